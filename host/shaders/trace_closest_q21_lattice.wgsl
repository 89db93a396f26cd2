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

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
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
    member: type_20,
    member_1: f32,
}

struct type_36 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_38 {
    member: array<type_24>,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<array<u32, 7>>,
}

struct type_50 {
    member: type_28,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_41;
@group(0) @binding(4) 
var<storage> global_3: type_38;
@group(0) @binding(2) 
var<storage> global_4: type_45;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_22;

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
    var phi_511_: i32;
    var phi_512_: i32;
    var phi_522_: bool;
    var phi_532_: u32;
    var phi_533_: u32;
    var phi_535_: bool;
    var phi_540_: u32;
    var phi_553_: i32;
    var phi_573_: i32;
    var phi_591_: f32;
    var phi_597_: f32;
    var phi_637_: f32;
    var phi_643_: f32;
    var phi_716_: f32;
    var phi_722_: f32;
    var phi_762_: f32;
    var phi_768_: f32;
    var phi_841_: f32;
    var phi_847_: f32;
    var phi_887_: f32;
    var phi_893_: f32;
    var phi_1012_: i32;
    var phi_1034_: u32;
    var phi_1035_: u32;
    var phi_1072_: i32;
    var phi_1094_: u32;
    var phi_1095_: u32;
    var phi_1103_: f32;
    var phi_1104_: f32;
    var phi_4674_: bool;
    var phi_1200_: type_33;
    var phi_1203_: bool;
    var phi_1205_: type_50;
    var phi_1207_: u32;
    var phi_1209_: u32;
    var phi_1220_: bool;
    var phi_1306_: bool;
    var phi_1307_: type_50;
    var phi_1308_: u32;
    var phi_3394_: u32;
    var phi_3400_: u32;
    var phi_3654_: u32;
    var phi_3655_: u32;
    var phi_3665_: u32;
    var phi_3667_: u32;
    var phi_3668_: bool;
    var phi_3688_: u32;
    var phi_3689_: u32;
    var phi_3693_: type_51;
    var phi_4055_: type_50;
    var phi_4131_: type_50;
    var phi_4132_: type_50;
    var phi_4133_: u32;
    var phi_4135_: type_50;
    var phi_4136_: u32;
    var phi_4137_: bool;
    var phi_4146_: type_50;
    var phi_4151_: bool;
    var phi_4152_: type_50;
    var phi_1327_: type_33;
    var phi_1330_: type_8;
    var phi_1331_: type_8;
    var phi_1353_: type_8;
    var phi_1394_: u32;
    var phi_1400_: u32;
    var phi_1410_: u32;
    var phi_1426_: u32;
    var phi_1459_: u32;
    var phi_1465_: u32;
    var phi_1931_: u32;
    var phi_1949_: u32;
    var phi_1967_: u32;
    var phi_1990_: u32;
    var phi_2008_: u32;
    var phi_2026_: u32;
    var phi_2049_: u32;
    var phi_2067_: u32;
    var phi_2085_: u32;
    var phi_1639_: u32;
    var phi_1654_: u32;
    var phi_1664_: u32;
    var phi_1685_: u32;
    var phi_1706_: u32;
    var phi_1736_: u32;
    var phi_1751_: u32;
    var phi_1761_: u32;
    var phi_1782_: u32;
    var phi_1803_: u32;
    var phi_1833_: u32;
    var phi_1848_: u32;
    var phi_1858_: u32;
    var phi_1879_: u32;
    var phi_1900_: u32;
    var phi_1492_: u32;
    var phi_1541_: u32;
    var phi_1590_: u32;
    var phi_2091_: array<array<f32, 3>, 3>;
    var phi_2621_: f32;
    var phi_2622_: f32;
    var phi_2623_: f32;
    var phi_2624_: f32;
    var phi_2625_: vec3<f32>;
    var phi_2626_: vec3<f32>;
    var phi_2627_: vec3<f32>;
    var phi_2628_: vec3<f32>;
    var phi_2819_: f32;
    var phi_2839_: type_36;
    var phi_2840_: type_36;
    var phi_2843_: type_36;
    var phi_2844_: type_36;
    var phi_2845_: bool;
    var phi_2849_: type_36;
    var phi_2858_: type_20;
    var phi_2883_: bool;
    var phi_2884_: bool;
    var phi_2890_: type_33;
    var phi_2891_: type_33;
    var phi_2892_: type_33;
    var phi_1328_: type_33;
    var phi_4668_: bool;
    var local_10: type_33;
    var phi_4872_: bool;
    var phi_4154_: type_33;
    var phi_4155_: bool;
    var phi_4156_: type_50;
    var phi_4157_: u32;
    var phi_4871_: bool;
    var phi_4158_: type_33;
    var phi_4159_: bool;
    var phi_4160_: type_50;
    var phi_4161_: u32;
    var phi_4162_: u32;
    var phi_4870_: bool;
    var phi_4163_: type_33;
    var phi_4164_: bool;
    var phi_4165_: type_50;
    var phi_4166_: u32;
    var phi_4167_: u32;
    var phi_4869_: bool;
    var phi_1201_: type_33;
    var phi_1204_: bool;
    var phi_1206_: type_50;
    var phi_1208_: u32;
    var phi_1210_: u32;
    var phi_4168_: bool;
    var phi_4868_: bool;
    var local_11: type_33;
    var phi_4206_: f32;
    var phi_4208_: f32;
    var phi_4209_: bool;
    var phi_4210_: f32;
    var phi_4211_: bool;
    var phi_4576_: u32;
    var phi_4594_: bool;
    var phi_4597_: bool;
    var phi_4610_: f32;
    var phi_4611_: f32;
    var phi_4616_: f32;
    var phi_4617_: f32;
    var phi_4618_: bool;
    var phi_4626_: f32;
    var phi_4226_: f32;
    var phi_4227_: f32;
    var phi_4239_: f32;
    var phi_4244_: type_20;
    var local_12: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e94 = global;
            let _e96 = arrayLength((&global_4.member));
            let _e99 = arrayLength((&global_5.member));
            let _e107 = global_2.member[0u][0u];
            let _e111 = global_2.member[0u][1u];
            let _e115 = global_2.member[0u][2u];
            let _e119 = global_2.member[0u][3u];
            let _e123 = global_2.member[1u][0u];
            let _e127 = global_2.member[1u][1u];
            let _e131 = global_2.member[1u][2u];
            let _e134 = global_1.member[0u];
            let _e135 = bitcast<i32>(_e134);
            let _e147 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e119) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e107), bitcast<i32>(_e111), bitcast<i32>(_e115));
            local = array<i32, 3>(bitcast<i32>(_e123), bitcast<i32>(_e127), bitcast<i32>(_e131));
            let _e153 = (_e94.x + (_e94.y * 2097152u));
            let _e154 = (_e153 < arrayLength((&global_3.member)));
            if _e154 {
                let _e155 = (_e153 < arrayLength((&global_6.member)));
                if _e155 {
                    if _e154 {
                    } else {
                        break;
                    }
                    let _e163 = global_3.member[_e153].member_2[0u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_3.member[_e153].member_2[1u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_3.member[_e153].member_2[2u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_3.member[_e153].member[0u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e191 = global_3.member[_e153].member[1u];
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e198 = global_3.member[_e153].member[2u];
                    let _e200 = (bitcast<u32>(_e198) & 2147483647u);
                    let _e202 = select(_e172, _e165, (_e172 < _e165));
                    let _e204 = select(_e179, _e202, (_e179 < _e202));
                    let _e206 = select(_e186, _e204, (_e186 < _e204));
                    let _e208 = select(_e193, _e206, (_e193 < _e206));
                    let _e210 = select(_e200, _e208, (_e200 < _e208));
                    let _e214 = global_3.member[_e153].member_1;
                    let _e215 = bitcast<u32>(_e214);
                    let _e216 = (_e215 & 2147483647u);
                    let _e223 = global_3.member[_e153].member_3;
                    let _e224 = bitcast<u32>(_e223);
                    let _e225 = (_e224 & 2147483647u);
                    let _e229 = (((select(_e216, _e210, (_e216 < _e210)) < 2139095040u) && (_e225 <= 2139095040u)) && (_e204 > 0u));
                    if _e229 {
                        let _e232 = (bitcast<u32>(bitcast<f32>(_e204)) & 2147483647u);
                        if (_e232 >= 8388608u) {
                            phi_511_ = (bitcast<i32>((_e232 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_511_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e232)), 32u, (_e232 == 0u))));
                        }
                        let _e246 = phi_511_;
                        phi_512_ = _e246;
                    } else {
                        phi_512_ = 0i;
                    }
                    let _e248 = phi_512_;
                    let _e249 = (_e165 == _e204);
                    if _e249 {
                        phi_522_ = true;
                    } else {
                        phi_522_ = (_e172 == _e204);
                    }
                    let _e252 = phi_522_;
                    let _e253 = select(1u, 0u, _e249);
                    if _e252 {
                        let _e254 = (_e253 + 1u);
                        phi_532_ = _e254;
                        phi_533_ = _e254;
                        phi_535_ = select(true, false, (_e254 == 2u));
                    } else {
                        phi_532_ = u32();
                        phi_533_ = 0u;
                        phi_535_ = true;
                    }
                    let _e258 = phi_532_;
                    let _e260 = phi_533_;
                    let _e262 = phi_535_;
                    if _e262 {
                        phi_540_ = (_e260 + 1u);
                    } else {
                        phi_540_ = 0u;
                    }
                    let _e266 = phi_540_;
                    let _e267 = select(_e258, _e260, _e262);
                    let _e268 = select(_e253, select(2u, _e253, _e252), _e262);
                    if (_e135 < -126i) {
                        phi_553_ = -126i;
                    } else {
                        phi_553_ = select(_e135, 127i, (_e135 > 127i));
                    }
                    let _e273 = phi_553_;
                    let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                    let _e284 = bitcast<f32>((bitcast<u32>(((_e135 - _e273) + 127i)) << bitcast<u32>(23i)));
                    let _e285 = -(_e248);
                    if (_e285 < -126i) {
                        phi_573_ = -126i;
                    } else {
                        phi_573_ = select(_e285, 127i, (_e285 > 127i));
                    }
                    let _e290 = phi_573_;
                    let _e295 = bitcast<f32>((bitcast<u32>((_e290 + 127i)) << bitcast<u32>(23i)));
                    let _e301 = bitcast<f32>((bitcast<u32>(((_e285 - _e290) + 127i)) << bitcast<u32>(23i)));
                    let _e305 = global_3.member[_e153].member;
                    let _e306 = (_e267 == 0u);
                    if _e306 {
                        phi_591_ = _e305[0];
                    } else {
                        phi_591_ = _e305[1];
                    }
                    let _e310 = phi_591_;
                    let _e311 = (_e267 == 2u);
                    if _e311 {
                        phi_597_ = _e305[2];
                    } else {
                        phi_597_ = _e310;
                    }
                    let _e314 = phi_597_;
                    let _e315 = bitcast<u32>(_e314);
                    let _e317 = ((_e315 & 2139095040u) != 0u);
                    let _e331 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e314, _e317) * _e278) * select(0.00000011920929f, 1f, _e317)) * _e284);
                    let _e332 = global_3.member[_e153].member_2;
                    if _e306 {
                        phi_637_ = _e332[0];
                    } else {
                        phi_637_ = _e332[1];
                    }
                    let _e336 = phi_637_;
                    if _e311 {
                        phi_643_ = _e332[2];
                    } else {
                        phi_643_ = _e336;
                    }
                    let _e339 = phi_643_;
                    let _e340 = bitcast<u32>(_e339);
                    let _e342 = ((_e340 & 2139095040u) != 0u);
                    let _e356 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e340 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e340 & 2147483648u))), _e339, _e342) * _e295) * select(0.00000011920929f, 1f, _e342)) * _e301);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e363 = bitcast<f32>((bitcast<u32>(_e331) & 2147483647u));
                    let _e364 = (_e363 * 0.00000011920929f);
                    let _e367 = select(select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f)), 0f, _e360);
                    let _e368 = select(0f, _e356, _e360);
                    let _e369 = (_e331 + _e367);
                    let _e370 = (_e331 - _e367);
                    let _e372 = select(38685626000000000000000000f, (1f / _e356), _e360);
                    let _e373 = (_e266 == 0u);
                    if _e373 {
                        phi_716_ = _e305[0];
                    } else {
                        phi_716_ = _e305[1];
                    }
                    let _e377 = phi_716_;
                    let _e378 = (_e266 == 2u);
                    if _e378 {
                        phi_722_ = _e305[2];
                    } else {
                        phi_722_ = _e377;
                    }
                    let _e381 = phi_722_;
                    let _e382 = bitcast<u32>(_e381);
                    let _e384 = ((_e382 & 2139095040u) != 0u);
                    let _e398 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e382 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e382 & 2147483648u))), _e381, _e384) * _e278) * select(0.00000011920929f, 1f, _e384)) * _e284);
                    if _e373 {
                        phi_762_ = _e332[0];
                    } else {
                        phi_762_ = _e332[1];
                    }
                    let _e402 = phi_762_;
                    if _e378 {
                        phi_768_ = _e332[2];
                    } else {
                        phi_768_ = _e402;
                    }
                    let _e405 = phi_768_;
                    let _e406 = bitcast<u32>(_e405);
                    let _e408 = ((_e406 & 2139095040u) != 0u);
                    let _e422 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e406 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e406 & 2147483648u))), _e405, _e408) * _e295) * select(0.00000011920929f, 1f, _e408)) * _e301);
                    let _e426 = (bitcast<f32>((bitcast<u32>(_e422) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e429 = bitcast<f32>((bitcast<u32>(_e398) & 2147483647u));
                    let _e430 = (_e429 * 0.00000011920929f);
                    let _e433 = select(select(0.00000000000011368684f, _e430, (_e430 > 0.00000000000011368684f)), 0f, _e426);
                    let _e434 = select(0f, _e422, _e426);
                    let _e435 = (_e398 + _e433);
                    let _e436 = (_e398 - _e433);
                    let _e438 = select(38685626000000000000000000f, (1f / _e422), _e426);
                    let _e439 = (_e268 == 0u);
                    if _e439 {
                        phi_841_ = _e305[0];
                    } else {
                        phi_841_ = _e305[1];
                    }
                    let _e443 = phi_841_;
                    let _e444 = (_e268 == 2u);
                    if _e444 {
                        phi_847_ = _e305[2];
                    } else {
                        phi_847_ = _e443;
                    }
                    let _e447 = phi_847_;
                    let _e448 = bitcast<u32>(_e447);
                    let _e450 = ((_e448 & 2139095040u) != 0u);
                    let _e464 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e448 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e448 & 2147483648u))), _e447, _e450) * _e278) * select(0.00000011920929f, 1f, _e450)) * _e284);
                    if _e439 {
                        phi_887_ = _e332[0];
                    } else {
                        phi_887_ = _e332[1];
                    }
                    let _e468 = phi_887_;
                    if _e444 {
                        phi_893_ = _e332[2];
                    } else {
                        phi_893_ = _e468;
                    }
                    let _e471 = phi_893_;
                    let _e472 = bitcast<u32>(_e471);
                    let _e474 = ((_e472 & 2139095040u) != 0u);
                    let _e488 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e472 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e472 & 2147483648u))), _e471, _e474) * _e295) * select(0.00000011920929f, 1f, _e474)) * _e301);
                    let _e492 = (bitcast<f32>((bitcast<u32>(_e488) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e495 = bitcast<f32>((bitcast<u32>(_e464) & 2147483647u));
                    let _e496 = (_e495 * 0.00000011920929f);
                    let _e499 = select(select(0.00000000000011368684f, _e496, (_e496 > 0.00000000000011368684f)), 0f, _e492);
                    let _e500 = select(0f, _e488, _e492);
                    let _e501 = (_e464 + _e499);
                    let _e502 = (_e464 - _e499);
                    let _e504 = select(38685626000000000000000000f, (1f / _e488), _e492);
                    let _e506 = select(_e429, _e363, (_e363 > _e429));
                    let _e509 = (_e135 + _e248);
                    if (_e229 && (select(_e495, _e506, (_e506 > _e495)) <= 1099511600000f)) {
                        let _e519 = ((_e216 & 8388607u) | (select(0u, 1u, ((_e216 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e522 = bitcast<i32>((_e216 >> bitcast<u32>(23i)));
                        let _e526 = (_e519 == 0u);
                        let _e529 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e519)), 32u, _e526)) - 8i);
                        if (_e522 == 255i) {
                            phi_1012_ = 255i;
                        } else {
                            phi_1012_ = (((_e522 + select(0i, 1i, (_e522 == 0i))) - _e529) + _e509);
                        }
                        let _e537 = phi_1012_;
                        let _e547 = (_e537 <= 0i);
                        if _e547 {
                            phi_1035_ = u32();
                        } else {
                            if _e526 {
                                phi_1034_ = u32();
                            } else {
                                phi_1034_ = select(((bitcast<u32>(_e537) << bitcast<u32>(23i)) | ((_e519 << bitcast<u32>(((_e529 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e537 >= 255i));
                            }
                            let _e551 = phi_1034_;
                            phi_1035_ = _e551;
                        }
                        let _e553 = phi_1035_;
                        let _e565 = ((_e225 & 8388607u) | (select(0u, 1u, ((_e225 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e568 = bitcast<i32>((_e225 >> bitcast<u32>(23i)));
                        let _e572 = (_e565 == 0u);
                        let _e575 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e565)), 32u, _e572)) - 8i);
                        if (_e568 == 255i) {
                            phi_1072_ = 255i;
                        } else {
                            phi_1072_ = (((_e568 + select(0i, 1i, (_e568 == 0i))) - _e575) + _e509);
                        }
                        let _e583 = phi_1072_;
                        let _e593 = (_e583 <= 0i);
                        if _e593 {
                            phi_1095_ = u32();
                        } else {
                            if _e572 {
                                phi_1094_ = u32();
                            } else {
                                phi_1094_ = select(((bitcast<u32>(_e583) << bitcast<u32>(23i)) | ((_e565 << bitcast<u32>(((_e575 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e583 >= 255i));
                            }
                            let _e597 = phi_1094_;
                            phi_1095_ = _e597;
                        }
                        let _e599 = phi_1095_;
                        phi_1103_ = bitcast<f32>(((_e224 & 2147483648u) | select(_e599, 0u, select(_e572, true, _e593))));
                        phi_1104_ = bitcast<f32>(((_e215 & 2147483648u) | select(_e553, 0u, select(_e526, true, _e547))));
                    } else {
                        phi_1103_ = 0f;
                        phi_1104_ = 1f;
                    }
                    let _e605 = phi_1103_;
                    let _e607 = phi_1104_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e613 = (_e267 % 3u);
                    let _e614 = (_e613 < 3u);
                    if _e614 {
                    } else {
                        break;
                    }
                    let _e616 = local_1[_e613];
                    let _e619 = (_e266 % 3u);
                    let _e620 = (_e619 < 3u);
                    if _e620 {
                    } else {
                        break;
                    }
                    let _e622 = local_1[_e619];
                    let _e625 = (_e268 % 3u);
                    let _e626 = (_e625 < 3u);
                    if _e626 {
                    } else {
                        break;
                    }
                    let _e628 = local_1[_e625];
                    if _e614 {
                    } else {
                        break;
                    }
                    let _e633 = local[_e613];
                    if _e620 {
                    } else {
                        break;
                    }
                    let _e637 = local[_e619];
                    if _e626 {
                    } else {
                        break;
                    }
                    let _e641 = local[_e625];
                    phi_4674_ = false;
                    phi_1200_ = type_33(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e605);
                    phi_1203_ = (_e607 <= _e605);
                    phi_1205_ = type_50(type_28(vec4<f32>((f32(_e616) * _e147), (f32(_e622) * _e147), (f32(_e628) * _e147), 0f), vec4<f32>((f32(_e633) * _e147), (f32(_e637) * _e147), (f32(_e641) * _e147), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                    phi_1207_ = 0u;
                    phi_1209_ = ((3u * _e96) + 1u);
                    loop {
                        let _e649 = phi_4674_;
                        let _e651 = phi_1200_;
                        let _e653 = phi_1203_;
                        let _e655 = phi_1205_;
                        let _e657 = phi_1207_;
                        let _e659 = phi_1209_;
                        local_11 = _e651;
                        if _e653 {
                            phi_1220_ = true;
                        } else {
                            phi_1220_ = (_e657 > 0u);
                        }
                        let _e662 = phi_1220_;
                        if _e662 {
                            let _e663 = (_e659 > 0u);
                            if _e663 {
                                if _e653 {
                                    phi_1306_ = _e653;
                                    phi_1307_ = _e655;
                                    phi_1308_ = _e657;
                                } else {
                                    let _e664 = (_e657 - 1u);
                                    let _e665 = (_e664 % 128u);
                                    let _e666 = (_e665 < 128u);
                                    if _e666 {
                                    } else {
                                        phi_4868_ = true;
                                        break;
                                    }
                                    let _e668 = local_7[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4868_ = true;
                                        break;
                                    }
                                    let _e670 = local_6[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4868_ = true;
                                        break;
                                    }
                                    let _e672 = local_5[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4868_ = true;
                                        break;
                                    }
                                    let _e674 = local_4[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4868_ = true;
                                        break;
                                    }
                                    let _e676 = local_3[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4868_ = true;
                                        break;
                                    }
                                    let _e678 = local_2[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4868_ = true;
                                        break;
                                    }
                                    let _e683 = local_8[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4868_ = true;
                                        break;
                                    }
                                    let _e686 = local_9[_e665];
                                    phi_1306_ = (_e686 <= _e651.member_1);
                                    phi_1307_ = type_50(type_28(vec4<f32>(_e668, _e670, _e672, 0f), vec4<f32>(_e674, _e676, _e678, 0f)), _e683);
                                    phi_1308_ = _e664;
                                }
                                let _e690 = phi_1306_;
                                let _e692 = phi_1307_;
                                let _e694 = phi_1308_;
                                if _e690 {
                                    let _e699 = (_e692.member_1 & 268435455u);
                                    if ((_e692.member_1 & 2147483648u) != 0u) {
                                        phi_1327_ = _e651;
                                        phi_1330_ = type_8(0u, ((_e692.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1182 = phi_1327_;
                                            let _e1184 = phi_1330_;
                                            local_10 = _e1182;
                                            local_12 = _e1182;
                                            if (_e1184.member < _e1184.member_1) {
                                                phi_1331_ = type_8((_e1184.member + 1u), _e1184.member_1);
                                                phi_1353_ = type_8(1u, _e1184.member);
                                            } else {
                                                phi_1331_ = _e1184;
                                                phi_1353_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1197 = phi_1331_;
                                            let _e1199 = phi_1353_;
                                            let _e1203 = (bitcast<i32>(_e1199.member) != 0i);
                                            if _e1203 {
                                                let _e1208 = (_e692.member.member_1.x - _e692.member.member.x);
                                                let _e1211 = (_e692.member.member_1.y - _e692.member.member.y);
                                                let _e1214 = (_e692.member.member_1.z - _e692.member.member.z);
                                                let _e1216 = select(_e1211, _e1208, (_e1208 > _e1211));
                                                let _e1218 = select(_e1214, _e1216, (_e1216 > _e1214));
                                                let _e1220 = (_e1218 < (1024f * _e147));
                                                if _e1220 {
                                                    phi_1394_ = 0u;
                                                } else {
                                                    phi_1394_ = select(2u, 1u, (_e1218 < (2097152f * _e147)));
                                                }
                                                let _e1225 = phi_1394_;
                                                switch bitcast<i32>(_e1225) {
                                                    case 0: {
                                                        phi_1400_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1400_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1400_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1400_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1228 = phi_1400_;
                                                switch bitcast<i32>(_e1225) {
                                                    case 0: {
                                                        phi_1410_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1410_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1410_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1410_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1235 = phi_1410_;
                                                let _e1237 = ((_e699 + (_e1199.member_1 * ((3u * _e1228) + 1u))) + (3u * _e1235));
                                                let _e1238 = (_e1237 < _e99);
                                                if _e1238 {
                                                    if _e1238 {
                                                    } else {
                                                        phi_4668_ = true;
                                                        break;
                                                    }
                                                    let _e1240 = global_5.member[_e1237];
                                                    phi_1426_ = _e1240;
                                                } else {
                                                    phi_1426_ = 4294967295u;
                                                }
                                                let _e1242 = phi_1426_;
                                                if _e1220 {
                                                    phi_1459_ = 0u;
                                                } else {
                                                    phi_1459_ = select(2u, 1u, (_e1218 < (2097152f * _e147)));
                                                }
                                                let _e1247 = phi_1459_;
                                                switch bitcast<i32>(_e1247) {
                                                    case 0: {
                                                        phi_1465_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1465_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1465_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1465_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1250 = phi_1465_;
                                                let _e1254 = (_e699 + (_e1199.member_1 * ((3u * _e1250) + 1u)));
                                                switch bitcast<i32>(_e1247) {
                                                    case 0: {
                                                        let _e1529 = (_e1254 < _e99);
                                                        if _e1529 {
                                                            if _e1529 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1531 = global_5.member[_e1254];
                                                            phi_1492_ = _e1531;
                                                        } else {
                                                            phi_1492_ = 0u;
                                                        }
                                                        let _e1533 = phi_1492_;
                                                        let _e1535 = ((10u * _e267) & 31u);
                                                        let _e1545 = ((10u * _e266) & 31u);
                                                        let _e1555 = ((10u * _e268) & 31u);
                                                        let _e1565 = (_e1254 + 1u);
                                                        let _e1566 = (_e1565 < _e99);
                                                        if _e1566 {
                                                            if _e1566 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1568 = global_5.member[_e1565];
                                                            phi_1541_ = _e1568;
                                                        } else {
                                                            phi_1541_ = 0u;
                                                        }
                                                        let _e1570 = phi_1541_;
                                                        let _e1596 = (_e1254 + 2u);
                                                        let _e1597 = (_e1596 < _e99);
                                                        if _e1597 {
                                                            if _e1597 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1599 = global_5.member[_e1596];
                                                            phi_1590_ = _e1599;
                                                        } else {
                                                            phi_1590_ = 0u;
                                                        }
                                                        let _e1601 = phi_1590_;
                                                        phi_2091_ = array<array<f32, 3>, 3>(array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | ((_e1533 >> bitcast<u32>(_e1535)) & 1023u))) - 8388608f) * _e147)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | ((_e1533 >> bitcast<u32>(_e1545)) & 1023u))) - 8388608f) * _e147)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | ((_e1533 >> bitcast<u32>(_e1555)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | ((_e1570 >> bitcast<u32>(_e1535)) & 1023u))) - 8388608f) * _e147)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | ((_e1570 >> bitcast<u32>(_e1545)) & 1023u))) - 8388608f) * _e147)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | ((_e1570 >> bitcast<u32>(_e1555)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | ((_e1601 >> bitcast<u32>(_e1535)) & 1023u))) - 8388608f) * _e147)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | ((_e1601 >> bitcast<u32>(_e1545)) & 1023u))) - 8388608f) * _e147)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | ((_e1601 >> bitcast<u32>(_e1555)) & 1023u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1343 = (_e1254 < _e99);
                                                        if _e1343 {
                                                            if _e1343 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1345 = global_5.member[_e1254];
                                                            phi_1639_ = _e1345;
                                                        } else {
                                                            phi_1639_ = 0u;
                                                        }
                                                        let _e1347 = phi_1639_;
                                                        let _e1348 = (_e1254 + 1u);
                                                        let _e1349 = (_e1348 < _e99);
                                                        if _e1349 {
                                                            if _e1349 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1351 = global_5.member[_e1348];
                                                            phi_1654_ = _e1351;
                                                        } else {
                                                            phi_1654_ = 0u;
                                                        }
                                                        let _e1353 = phi_1654_;
                                                        let _e1354 = (_e267 == 1u);
                                                        if _e1354 {
                                                            phi_1664_ = ((_e1347 >> bitcast<u32>(21i)) | (_e1353 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1664_ = (_e1353 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1363 = phi_1664_;
                                                        let _e1371 = (_e266 == 1u);
                                                        if _e1371 {
                                                            phi_1685_ = ((_e1347 >> bitcast<u32>(21i)) | (_e1353 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1685_ = (_e1353 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1380 = phi_1685_;
                                                        let _e1388 = (_e268 == 1u);
                                                        if _e1388 {
                                                            phi_1706_ = ((_e1347 >> bitcast<u32>(21i)) | (_e1353 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1706_ = (_e1353 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1397 = phi_1706_;
                                                        let _e1406 = (_e1254 + 2u);
                                                        let _e1407 = (_e1406 < _e99);
                                                        if _e1407 {
                                                            if _e1407 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1409 = global_5.member[_e1406];
                                                            phi_1736_ = _e1409;
                                                        } else {
                                                            phi_1736_ = 0u;
                                                        }
                                                        let _e1411 = phi_1736_;
                                                        let _e1412 = (_e1254 + 3u);
                                                        let _e1413 = (_e1412 < _e99);
                                                        if _e1413 {
                                                            if _e1413 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1415 = global_5.member[_e1412];
                                                            phi_1751_ = _e1415;
                                                        } else {
                                                            phi_1751_ = 0u;
                                                        }
                                                        let _e1417 = phi_1751_;
                                                        if _e1354 {
                                                            phi_1761_ = ((_e1411 >> bitcast<u32>(21i)) | (_e1417 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1761_ = (_e1417 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1426 = phi_1761_;
                                                        if _e1371 {
                                                            phi_1782_ = ((_e1411 >> bitcast<u32>(21i)) | (_e1417 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1782_ = (_e1417 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1442 = phi_1782_;
                                                        if _e1388 {
                                                            phi_1803_ = ((_e1411 >> bitcast<u32>(21i)) | (_e1417 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1803_ = (_e1417 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1458 = phi_1803_;
                                                        let _e1467 = (_e1254 + 4u);
                                                        let _e1468 = (_e1467 < _e99);
                                                        if _e1468 {
                                                            if _e1468 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1470 = global_5.member[_e1467];
                                                            phi_1833_ = _e1470;
                                                        } else {
                                                            phi_1833_ = 0u;
                                                        }
                                                        let _e1472 = phi_1833_;
                                                        let _e1473 = (_e1254 + 5u);
                                                        let _e1474 = (_e1473 < _e99);
                                                        if _e1474 {
                                                            if _e1474 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1476 = global_5.member[_e1473];
                                                            phi_1848_ = _e1476;
                                                        } else {
                                                            phi_1848_ = 0u;
                                                        }
                                                        let _e1478 = phi_1848_;
                                                        if _e1354 {
                                                            phi_1858_ = ((_e1472 >> bitcast<u32>(21i)) | (_e1478 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1858_ = (_e1478 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1487 = phi_1858_;
                                                        if _e1371 {
                                                            phi_1879_ = ((_e1472 >> bitcast<u32>(21i)) | (_e1478 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1879_ = (_e1478 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1503 = phi_1879_;
                                                        if _e1388 {
                                                            phi_1900_ = ((_e1472 >> bitcast<u32>(21i)) | (_e1478 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1900_ = (_e1478 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1519 = phi_1900_;
                                                        phi_2091_ = array<array<f32, 3>, 3>(array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1363, _e1347, _e306) & 2097151u))) - 8388608f) * _e147)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1380, _e1347, _e373) & 2097151u))) - 8388608f) * _e147)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1397, _e1347, _e439) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1426, _e1411, _e306) & 2097151u))) - 8388608f) * _e147)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1442, _e1411, _e373) & 2097151u))) - 8388608f) * _e147)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1458, _e1411, _e439) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1487, _e1472, _e306) & 2097151u))) - 8388608f) * _e147)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1503, _e1472, _e373) & 2097151u))) - 8388608f) * _e147)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1519, _e1472, _e439) & 2097151u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1256 = (_e1254 + _e267);
                                                        let _e1257 = (_e1256 < _e99);
                                                        if _e1257 {
                                                            if _e1257 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1259 = global_5.member[_e1256];
                                                            phi_1931_ = _e1259;
                                                        } else {
                                                            phi_1931_ = 0u;
                                                        }
                                                        let _e1261 = phi_1931_;
                                                        let _e1265 = (_e1254 + _e266);
                                                        let _e1266 = (_e1265 < _e99);
                                                        if _e1266 {
                                                            if _e1266 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1268 = global_5.member[_e1265];
                                                            phi_1949_ = _e1268;
                                                        } else {
                                                            phi_1949_ = 0u;
                                                        }
                                                        let _e1270 = phi_1949_;
                                                        let _e1274 = (_e1254 + _e268);
                                                        let _e1275 = (_e1274 < _e99);
                                                        if _e1275 {
                                                            if _e1275 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1277 = global_5.member[_e1274];
                                                            phi_1967_ = _e1277;
                                                        } else {
                                                            phi_1967_ = 0u;
                                                        }
                                                        let _e1279 = phi_1967_;
                                                        let _e1284 = (_e1254 + 3u);
                                                        let _e1285 = (_e1284 + _e267);
                                                        let _e1286 = (_e1285 < _e99);
                                                        if _e1286 {
                                                            if _e1286 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1288 = global_5.member[_e1285];
                                                            phi_1990_ = _e1288;
                                                        } else {
                                                            phi_1990_ = 0u;
                                                        }
                                                        let _e1290 = phi_1990_;
                                                        let _e1294 = (_e1284 + _e266);
                                                        let _e1295 = (_e1294 < _e99);
                                                        if _e1295 {
                                                            if _e1295 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1297 = global_5.member[_e1294];
                                                            phi_2008_ = _e1297;
                                                        } else {
                                                            phi_2008_ = 0u;
                                                        }
                                                        let _e1299 = phi_2008_;
                                                        let _e1303 = (_e1284 + _e268);
                                                        let _e1304 = (_e1303 < _e99);
                                                        if _e1304 {
                                                            if _e1304 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1306 = global_5.member[_e1303];
                                                            phi_2026_ = _e1306;
                                                        } else {
                                                            phi_2026_ = 0u;
                                                        }
                                                        let _e1308 = phi_2026_;
                                                        let _e1313 = (_e1254 + 6u);
                                                        let _e1314 = (_e1313 + _e267);
                                                        let _e1315 = (_e1314 < _e99);
                                                        if _e1315 {
                                                            if _e1315 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1317 = global_5.member[_e1314];
                                                            phi_2049_ = _e1317;
                                                        } else {
                                                            phi_2049_ = 0u;
                                                        }
                                                        let _e1319 = phi_2049_;
                                                        let _e1323 = (_e1313 + _e266);
                                                        let _e1324 = (_e1323 < _e99);
                                                        if _e1324 {
                                                            if _e1324 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1326 = global_5.member[_e1323];
                                                            phi_2067_ = _e1326;
                                                        } else {
                                                            phi_2067_ = 0u;
                                                        }
                                                        let _e1328 = phi_2067_;
                                                        let _e1332 = (_e1313 + _e268);
                                                        let _e1333 = (_e1332 < _e99);
                                                        if _e1333 {
                                                            if _e1333 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1335 = global_5.member[_e1332];
                                                            phi_2085_ = _e1335;
                                                        } else {
                                                            phi_2085_ = 0u;
                                                        }
                                                        let _e1337 = phi_2085_;
                                                        phi_2091_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1261)) * _e147), (f32(bitcast<i32>(_e1270)) * _e147), (f32(bitcast<i32>(_e1279)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1290)) * _e147), (f32(bitcast<i32>(_e1299)) * _e147), (f32(bitcast<i32>(_e1308)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1319)) * _e147), (f32(bitcast<i32>(_e1328)) * _e147), (f32(bitcast<i32>(_e1337)) * _e147)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2091_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1629 = phi_2091_;
                                                let _e1645 = (_e1629[0][2] - _e464);
                                                let _e1648 = (((_e1629[0][0] - _e331) * _e500) - (_e1645 * _e368));
                                                let _e1651 = (((_e1629[0][1] - _e398) * _e500) - (_e1645 * _e434));
                                                let _e1654 = (_e1629[1][2] - _e464);
                                                let _e1657 = (((_e1629[1][0] - _e331) * _e500) - (_e1654 * _e368));
                                                let _e1660 = (((_e1629[1][1] - _e398) * _e500) - (_e1654 * _e434));
                                                let _e1663 = (_e1629[2][2] - _e464);
                                                let _e1666 = (((_e1629[2][0] - _e331) * _e500) - (_e1663 * _e368));
                                                let _e1669 = (((_e1629[2][1] - _e398) * _e500) - (_e1663 * _e434));
                                                let _e1670 = (_e1666 * _e1660);
                                                let _e1671 = (_e1669 * _e1657);
                                                let _e1672 = (_e1648 * _e1669);
                                                let _e1673 = (_e1651 * _e1666);
                                                let _e1674 = (_e1657 * _e1651);
                                                let _e1675 = (_e1660 * _e1648);
                                                let _e1680 = (((_e1670 >= _e1671) && (_e1672 >= _e1673)) && (_e1674 >= _e1675));
                                                let _e1686 = (_e1680 || (((_e1670 <= _e1671) && (_e1672 <= _e1673)) && (_e1674 <= _e1675)));
                                                if _e1686 {
                                                    let _e1688 = select(-1f, 1f, _e1680);
                                                    let _e1690 = ((_e1670 - _e1671) * _e1688);
                                                    let _e1692 = select(0f, _e1690, (_e1690 > 0f));
                                                    let _e1694 = ((_e1672 - _e1673) * _e1688);
                                                    let _e1696 = select(0f, _e1694, (_e1694 > 0f));
                                                    let _e1698 = ((_e1674 - _e1675) * _e1688);
                                                    let _e1700 = select(0f, _e1698, (_e1698 > 0f));
                                                    let _e1702 = ((_e1692 + _e1696) + _e1700);
                                                    let _e1704 = select(_e1629[1][0], _e1629[0][0], (_e1629[0][0] < _e1629[1][0]));
                                                    let _e1708 = select(_e1629[1][0], _e1629[0][0], (_e1629[0][0] > _e1629[1][0]));
                                                    let _e1712 = select(_e1629[1][1], _e1629[0][1], (_e1629[0][1] < _e1629[1][1]));
                                                    let _e1716 = select(_e1629[1][1], _e1629[0][1], (_e1629[0][1] > _e1629[1][1]));
                                                    let _e1720 = select(_e1629[1][2], _e1629[0][2], (_e1629[0][2] < _e1629[1][2]));
                                                    let _e1724 = select(_e1629[1][2], _e1629[0][2], (_e1629[0][2] > _e1629[1][2]));
                                                    let _e1729 = ((select(_e1629[2][0], _e1704, (_e1704 < _e1629[2][0])) - _e369) * _e372);
                                                    let _e1730 = ((select(_e1629[2][0], _e1708, (_e1708 > _e1629[2][0])) - _e370) * _e372);
                                                    let _e1733 = ((select(_e1629[2][1], _e1712, (_e1712 < _e1629[2][1])) - _e435) * _e438);
                                                    let _e1734 = ((select(_e1629[2][1], _e1716, (_e1716 > _e1629[2][1])) - _e436) * _e438);
                                                    let _e1737 = ((select(_e1629[2][2], _e1720, (_e1720 < _e1629[2][2])) - _e501) * _e504);
                                                    let _e1738 = ((select(_e1629[2][2], _e1724, (_e1724 > _e1629[2][2])) - _e502) * _e504);
                                                    let _e1740 = select(_e1738, _e1737, (_e1737 < _e1738));
                                                    let _e1742 = select(_e1738, _e1737, (_e1737 > _e1738));
                                                    let _e1744 = select(_e1730, _e1729, (_e1729 < _e1730));
                                                    let _e1746 = select(_e1734, _e1733, (_e1733 < _e1734));
                                                    let _e1748 = select(_e1746, _e1744, (_e1744 > _e1746));
                                                    let _e1750 = select(_e1740, _e1748, (_e1748 > _e1740));
                                                    let _e1752 = select(_e1730, _e1729, (_e1729 > _e1730));
                                                    let _e1754 = select(_e1734, _e1733, (_e1733 > _e1734));
                                                    let _e1756 = select(_e1754, _e1752, (_e1752 < _e1754));
                                                    let _e1758 = select(_e1742, _e1756, (_e1756 < _e1742));
                                                    let _e1759 = -(_e1740);
                                                    let _e1765 = select(_e607, _e1750, (_e1750 > _e607));
                                                    let _e1769 = select(_e1657, _e1648, (_e1648 < _e1657));
                                                    let _e1774 = select(_e1657, _e1648, (_e1648 > _e1657));
                                                    let _e1781 = select(_e1660, _e1651, (_e1651 < _e1660));
                                                    let _e1786 = select(_e1660, _e1651, (_e1651 > _e1660));
                                                    let _e1795 = (((((_e1686 && (_e1702 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1666, _e1769, (_e1769 < _e1666)) <= 0f) && (select(_e1666, _e1774, (_e1774 > _e1666)) >= 0f))) && ((select(_e1669, _e1781, (_e1781 < _e1669)) <= 0f) && (select(_e1669, _e1786, (_e1786 > _e1669)) >= 0f))) && (_e1765 <= (_e1758 + (select(_e1759, _e1742, (_e1742 > _e1759)) * 0.0000019073523f)))) && (_e1765 <= _e1182.member_1));
                                                    if _e1795 {
                                                        let _e1800 = (_e1629[1][0] - _e1629[0][0]);
                                                        let _e1801 = (_e1629[1][1] - _e1629[0][1]);
                                                        let _e1802 = (_e1629[1][2] - _e1629[0][2]);
                                                        let _e1803 = vec3<f32>(_e1800, _e1801, _e1802);
                                                        let _e1804 = (_e1629[2][0] - _e1629[1][0]);
                                                        let _e1805 = (_e1629[2][1] - _e1629[1][1]);
                                                        let _e1806 = (_e1629[2][2] - _e1629[1][2]);
                                                        let _e1807 = vec3<f32>(_e1804, _e1805, _e1806);
                                                        let _e1808 = (_e1629[0][0] - _e1629[2][0]);
                                                        let _e1809 = (_e1629[0][1] - _e1629[2][1]);
                                                        let _e1810 = (_e1629[0][2] - _e1629[2][2]);
                                                        let _e1811 = vec3<f32>(_e1808, _e1809, _e1810);
                                                        let _e1814 = bitcast<f32>((bitcast<u32>(_e1800) & 2147483647u));
                                                        let _e1817 = bitcast<f32>((bitcast<u32>(_e1801) & 2147483647u));
                                                        let _e1819 = select(_e1817, _e1814, (_e1814 > _e1817));
                                                        let _e1822 = bitcast<f32>((bitcast<u32>(_e1802) & 2147483647u));
                                                        let _e1824 = select(_e1822, _e1819, (_e1819 > _e1822));
                                                        let _e1827 = bitcast<f32>((bitcast<u32>(_e1804) & 2147483647u));
                                                        let _e1830 = bitcast<f32>((bitcast<u32>(_e1805) & 2147483647u));
                                                        let _e1832 = select(_e1830, _e1827, (_e1827 > _e1830));
                                                        let _e1835 = bitcast<f32>((bitcast<u32>(_e1806) & 2147483647u));
                                                        let _e1837 = select(_e1835, _e1832, (_e1832 > _e1835));
                                                        let _e1840 = bitcast<f32>((bitcast<u32>(_e1808) & 2147483647u));
                                                        let _e1843 = bitcast<f32>((bitcast<u32>(_e1809) & 2147483647u));
                                                        let _e1845 = select(_e1843, _e1840, (_e1840 > _e1843));
                                                        let _e1848 = bitcast<f32>((bitcast<u32>(_e1810) & 2147483647u));
                                                        let _e1850 = select(_e1848, _e1845, (_e1845 > _e1848));
                                                        let _e1852 = select(_e1837, _e1824, (_e1824 > _e1837));
                                                        let _e1854 = select(_e1850, _e1852, (_e1852 > _e1850));
                                                        if (_e1824 == _e1854) {
                                                            phi_2621_ = _e1660;
                                                            phi_2622_ = _e1657;
                                                            phi_2623_ = _e1651;
                                                            phi_2624_ = _e1648;
                                                            phi_2625_ = vec3<f32>(_e1629[0][0], _e1629[0][1], _e1629[0][2]);
                                                            phi_2626_ = _e1811;
                                                            phi_2627_ = _e1807;
                                                            phi_2628_ = _e1803;
                                                        } else {
                                                            let _e1856 = (_e1837 == _e1854);
                                                            let _e1861 = vec3(_e1856);
                                                            phi_2621_ = select(_e1651, _e1669, _e1856);
                                                            phi_2622_ = select(_e1648, _e1666, _e1856);
                                                            phi_2623_ = select(_e1669, _e1660, _e1856);
                                                            phi_2624_ = select(_e1666, _e1657, _e1856);
                                                            phi_2625_ = select(vec3<f32>(_e1629[2][0], _e1629[2][1], _e1629[2][2]), vec3<f32>(_e1629[1][0], _e1629[1][1], _e1629[1][2]), _e1861);
                                                            phi_2626_ = select(_e1807, _e1803, _e1861);
                                                            phi_2627_ = select(_e1803, _e1811, _e1861);
                                                            phi_2628_ = select(_e1811, _e1807, _e1861);
                                                        }
                                                        let _e1867 = phi_2621_;
                                                        let _e1869 = phi_2622_;
                                                        let _e1871 = phi_2623_;
                                                        let _e1873 = phi_2624_;
                                                        let _e1875 = phi_2625_;
                                                        let _e1877 = phi_2626_;
                                                        let _e1879 = phi_2627_;
                                                        let _e1881 = phi_2628_;
                                                        let _e1888 = ((_e1879.y * _e1877.z) - (_e1877.y * _e1879.z));
                                                        let _e1893 = ((_e1879.z * _e1877.x) - (_e1877.z * _e1879.x));
                                                        let _e1896 = ((_e1879.x * _e1877.y) - (_e1877.x * _e1879.y));
                                                        let _e1899 = ((_e1692 >= _e1696) && (_e1692 >= _e1700));
                                                        let _e1900 = (_e1696 >= _e1700);
                                                        let _e1914 = (((_e1888 * (select(select(_e1629[2][0], _e1629[1][0], _e1900), _e1629[0][0], _e1899) - _e331)) + (_e1893 * (select(select(_e1629[2][1], _e1629[1][1], _e1900), _e1629[0][1], _e1899) - _e398))) + (_e1896 * (select(select(_e1629[2][2], _e1629[1][2], _e1900), _e1629[0][2], _e1899) - _e464)));
                                                        let _e1919 = (((_e1888 * _e368) + (_e1893 * _e434)) + (_e1896 * _e500));
                                                        let _e1920 = (_e1869 - _e1873);
                                                        let _e1921 = (_e1867 - _e1871);
                                                        let _e1924 = ((_e1920 * _e1920) + (_e1921 * _e1921));
                                                        let _e1931 = (-(((_e1873 * _e1920) + (_e1871 * _e1921))) / select(0.000000000000000000000000000000000000011754944f, _e1924, (_e1924 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1933 = select(1f, _e1931, (_e1931 < 1f));
                                                        let _e1935 = select(0f, _e1933, (_e1933 > 0f));
                                                        let _e1944 = ((_e1875.x + (_e1881.x * _e1935)) - _e331);
                                                        let _e1947 = ((_e1875.y + (_e1881.y * _e1935)) - _e398);
                                                        let _e1950 = ((_e1875.z + (_e1881.z * _e1935)) - _e464);
                                                        let _e1953 = bitcast<f32>((bitcast<u32>(_e1944) & 2147483647u));
                                                        let _e1956 = bitcast<f32>((bitcast<u32>(_e1947) & 2147483647u));
                                                        let _e1958 = select(_e1956, _e1953, (_e1953 > _e1956));
                                                        let _e1961 = bitcast<f32>((bitcast<u32>(_e1950) & 2147483647u));
                                                        let _e1963 = select(_e1961, _e1958, (_e1958 > _e1961));
                                                        let _e1969 = bitcast<f32>((bitcast<u32>(_e1888) & 2147483647u));
                                                        let _e1972 = bitcast<f32>((bitcast<u32>(_e1893) & 2147483647u));
                                                        let _e1974 = select(_e1972, _e1969, (_e1969 > _e1972));
                                                        let _e1977 = bitcast<f32>((bitcast<u32>(_e1896) & 2147483647u));
                                                        let _e1996 = bitcast<f32>((bitcast<u32>(_e1879.x) & 2147483647u));
                                                        let _e1999 = bitcast<f32>((bitcast<u32>(_e1879.y) & 2147483647u));
                                                        let _e2001 = select(_e1999, _e1996, (_e1996 > _e1999));
                                                        let _e2004 = bitcast<f32>((bitcast<u32>(_e1879.z) & 2147483647u));
                                                        let _e2010 = bitcast<f32>((bitcast<u32>(_e1877.x) & 2147483647u));
                                                        let _e2013 = bitcast<f32>((bitcast<u32>(_e1877.y) & 2147483647u));
                                                        let _e2015 = select(_e2013, _e2010, (_e2010 > _e2013));
                                                        let _e2018 = bitcast<f32>((bitcast<u32>(_e1877.z) & 2147483647u));
                                                        let _e2024 = ((bitcast<f32>((bitcast<u32>(((((_e1888 * _e1944) + (_e1893 * _e1947)) + (_e1896 * _e1950)) - _e1914)) & 2147483647u)) <= ((0.0000009536743f * select(_e1854, _e1963, (_e1963 > _e1854))) * select(_e1977, _e1974, (_e1974 > _e1977)))) && !((bitcast<f32>((bitcast<u32>(_e1919) & 2147483647u)) <= ((0.0000038146973f * select(_e2004, _e2001, (_e2001 > _e2004))) * select(_e2018, _e2015, (_e2015 > _e2018))))));
                                                        let _e2025 = (_e1914 / _e1919);
                                                        if (_e1795 && !(_e2024)) {
                                                            let _e2028 = (_e1950 / _e500);
                                                            let _e2036 = (((_e1888 * (_e1944 - (_e368 * _e2028))) + (_e1893 * (_e1947 - (_e434 * _e2028)))) / _e1919);
                                                            phi_2819_ = select(select(_e2028, (_e2028 + _e2036), (bitcast<f32>((bitcast<u32>(_e2036) & 2147483647u)) <= _e1854)), _e2025, _e2024);
                                                        } else {
                                                            phi_2819_ = _e2025;
                                                        }
                                                        let _e2045 = phi_2819_;
                                                        let _e2047 = select(_e1758, _e2045, (_e2045 < _e1758));
                                                        let _e2049 = select(_e1750, _e2047, (_e2047 > _e1750));
                                                        let _e2050 = (1f / _e1702);
                                                        phi_2839_ = type_36(_e2049, (_e1696 * _e2050), (_e1700 * _e2050), ((_e1795 && (_e2049 >= _e607)) && (_e2049 <= _e1182.member_1)));
                                                        phi_2840_ = type_36();
                                                    } else {
                                                        phi_2839_ = type_36();
                                                        phi_2840_ = type_36(0f, 0f, 0f, _e1795);
                                                    }
                                                    let _e2059 = phi_2839_;
                                                    let _e2061 = phi_2840_;
                                                    phi_2843_ = _e2059;
                                                    phi_2844_ = _e2061;
                                                    phi_2845_ = select(true, false, _e1795);
                                                } else {
                                                    phi_2843_ = type_36();
                                                    phi_2844_ = type_36(0f, 0f, 0f, _e1686);
                                                    phi_2845_ = true;
                                                }
                                                let _e2064 = phi_2843_;
                                                let _e2066 = phi_2844_;
                                                let _e2068 = phi_2845_;
                                                if _e2068 {
                                                    phi_2849_ = _e2066;
                                                } else {
                                                    phi_2849_ = _e2064;
                                                }
                                                let _e2070 = phi_2849_;
                                                if _e2070.member_3 {
                                                    phi_2858_ = type_20(_e2070.member, _e2070.member_1, _e2070.member_2, _e1242);
                                                } else {
                                                    phi_2858_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e2077 = phi_2858_;
                                                if (_e2077.member_3 != 4294967295u) {
                                                    if (_e1242 != 4294967295u) {
                                                        if (_e2077.member < _e1182.member.member) {
                                                            phi_2884_ = true;
                                                        } else {
                                                            if (_e2077.member == _e1182.member.member) {
                                                                phi_2883_ = (_e2077.member_3 < _e1182.member.member_3);
                                                            } else {
                                                                phi_2883_ = false;
                                                            }
                                                            let _e2090 = phi_2883_;
                                                            phi_2884_ = _e2090;
                                                        }
                                                        let _e2092 = phi_2884_;
                                                        if _e2092 {
                                                            phi_2890_ = type_33(_e2077, _e2077.member);
                                                        } else {
                                                            phi_2890_ = _e1182;
                                                        }
                                                        let _e2095 = phi_2890_;
                                                        phi_2891_ = _e2095;
                                                    } else {
                                                        phi_2891_ = _e1182;
                                                    }
                                                    let _e2097 = phi_2891_;
                                                    phi_2892_ = _e2097;
                                                } else {
                                                    phi_2892_ = _e1182;
                                                }
                                                let _e2099 = phi_2892_;
                                                phi_1328_ = _e2099;
                                            } else {
                                                phi_1328_ = type_33();
                                            }
                                            let _e2101 = phi_1328_;
                                            continue;
                                            continuing {
                                                phi_1327_ = _e2101;
                                                phi_1330_ = _e1197;
                                                phi_4668_ = _e649;
                                                break if !(_e1203);
                                            }
                                        }
                                        let _e2104 = phi_4668_;
                                        phi_4868_ = _e2104;
                                        if _e2104 {
                                            break;
                                        }
                                        let _e2106 = local_10;
                                        phi_4872_ = _e2104;
                                        let _e2412 = local_12;
                                        phi_4154_ = _e2412;
                                        phi_4155_ = false;
                                        phi_4156_ = _e692;
                                        phi_4157_ = select(_e694, 0u, (_e607 > _e2106.member_1));
                                    } else {
                                        if (_e692.member_1 >= _e96) {
                                            phi_3693_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e692.member_1 < _e96) {
                                            } else {
                                                phi_4868_ = true;
                                                break;
                                            }
                                            let _e706 = (_e267 * 2u);
                                            let _e708 = ((1u + _e706) % 7u);
                                            if (_e708 < 7u) {
                                            } else {
                                                phi_4868_ = true;
                                                break;
                                            }
                                            let _e713 = global_4.member[_e692.member_1][_e708];
                                            let _e715 = ((_e706 + 2u) % 7u);
                                            if (_e715 < 7u) {
                                            } else {
                                                phi_4868_ = true;
                                                break;
                                            }
                                            let _e720 = global_4.member[_e692.member_1][_e715];
                                            let _e721 = (_e266 * 2u);
                                            let _e723 = ((1u + _e721) % 7u);
                                            if (_e723 < 7u) {
                                            } else {
                                                phi_4868_ = true;
                                                break;
                                            }
                                            let _e728 = global_4.member[_e692.member_1][_e723];
                                            let _e730 = ((_e721 + 2u) % 7u);
                                            if (_e730 < 7u) {
                                            } else {
                                                phi_4868_ = true;
                                                break;
                                            }
                                            let _e735 = global_4.member[_e692.member_1][_e730];
                                            let _e736 = (_e268 * 2u);
                                            let _e738 = ((1u + _e736) % 7u);
                                            if (_e738 < 7u) {
                                            } else {
                                                phi_4868_ = true;
                                                break;
                                            }
                                            let _e743 = global_4.member[_e692.member_1][_e738];
                                            let _e745 = ((_e736 + 2u) % 7u);
                                            if (_e745 < 7u) {
                                            } else {
                                                phi_4868_ = true;
                                                break;
                                            }
                                            let _e750 = global_4.member[_e692.member_1][_e745];
                                            let _e773 = (bitcast<f32>((bitcast<u32>((_e692.member.member_1.x - _e692.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e774 = (bitcast<f32>((bitcast<u32>((_e692.member.member_1.y - _e692.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e775 = (bitcast<f32>((bitcast<u32>((_e692.member.member_1.z - _e692.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e777 = select(_e147, _e773, (_e773 > _e147));
                                            let _e779 = select(_e147, _e774, (_e774 > _e147));
                                            let _e781 = select(_e147, _e775, (_e775 > _e147));
                                            let _e812 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e713 & 2097151u))) - 8388608f) * _e777));
                                            let _e817 = (bitcast<i32>((_e713 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e820 = bitcast<f32>((_e812 & bitcast<u32>(_e817)));
                                            let _e821 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e728 & 2097151u))) - 8388608f) * _e779));
                                            let _e826 = (bitcast<i32>((_e728 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e829 = bitcast<f32>((_e821 & bitcast<u32>(_e826)));
                                            let _e830 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e743 & 2097151u))) - 8388608f) * _e781));
                                            let _e835 = (bitcast<i32>((_e743 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e838 = bitcast<f32>((_e830 & bitcast<u32>(_e835)));
                                            let _e842 = bitcast<f32>((_e812 & bitcast<u32>(~(_e817))));
                                            let _e846 = bitcast<f32>((_e821 & bitcast<u32>(~(_e826))));
                                            let _e850 = bitcast<f32>((_e830 & bitcast<u32>(~(_e835))));
                                            let _e851 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e720 & 2097151u))) - 8388608f) * _e777));
                                            let _e856 = (bitcast<i32>((_e720 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e859 = bitcast<f32>((_e851 & bitcast<u32>(_e856)));
                                            let _e860 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e735 & 2097151u))) - 8388608f) * _e779));
                                            let _e865 = (bitcast<i32>((_e735 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e868 = bitcast<f32>((_e860 & bitcast<u32>(_e865)));
                                            let _e869 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e750 & 2097151u))) - 8388608f) * _e781));
                                            let _e874 = (bitcast<i32>((_e750 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e877 = bitcast<f32>((_e869 & bitcast<u32>(_e874)));
                                            let _e881 = bitcast<f32>((_e851 & bitcast<u32>(~(_e856))));
                                            let _e885 = bitcast<f32>((_e860 & bitcast<u32>(~(_e865))));
                                            let _e889 = bitcast<f32>((_e869 & bitcast<u32>(~(_e874))));
                                            let _e890 = (_e692.member.member.x + _e820);
                                            let _e891 = (_e692.member.member.y + _e829);
                                            let _e892 = (_e692.member.member.z + _e838);
                                            let _e895 = (_e692.member.member_1.x - _e859);
                                            let _e896 = (_e692.member.member_1.y - _e868);
                                            let _e897 = (_e692.member.member_1.z - _e877);
                                            let _e916 = (_e895 - _e890);
                                            let _e917 = (_e896 - _e891);
                                            let _e918 = (_e897 - _e892);
                                            let _e920 = select(_e917, _e916, (_e916 > _e917));
                                            let _e922 = select(_e918, _e920, (_e920 > _e918));
                                            if (_e922 < (1024f * _e147)) {
                                                phi_3394_ = 0u;
                                            } else {
                                                phi_3394_ = select(2u, 1u, (_e922 < (2097152f * _e147)));
                                            }
                                            let _e929 = phi_3394_;
                                            switch bitcast<i32>(_e929) {
                                                case 0: {
                                                    phi_3400_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3400_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3400_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3400_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e932 = phi_3400_;
                                            let _e938 = global_4.member[_e692.member_1][0u];
                                            let _e942 = global_4.member[_e692.member_1][2u];
                                            let _e946 = global_4.member[_e692.member_1][4u];
                                            let _e950 = global_4.member[_e692.member_1][6u];
                                            let _e962 = (((_e942 >> bitcast<u32>(22i)) | ((_e946 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e950 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e963 = (_e938 & 268435455u);
                                            let _e964 = (_e962 & 268435455u);
                                            let _e967 = ((_e938 >> bitcast<u32>(28u)) & 7u);
                                            let _e975 = ((_e938 >> bitcast<u32>(31i)) | (((_e962 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e976 = (_e967 != 0u);
                                            if (_e967 == 0u) {
                                                phi_3655_ = _e963;
                                            } else {
                                                if (_e967 == 7u) {
                                                    phi_3654_ = 2147483648u;
                                                } else {
                                                    phi_3654_ = ((2147483648u | (_e967 << bitcast<u32>(28u))) | (_e964 & 268435455u));
                                                }
                                                let _e985 = phi_3654_;
                                                phi_3655_ = _e985;
                                            }
                                            let _e987 = phi_3655_;
                                            if _e976 {
                                                let _e988 = (_e967 != 7u);
                                                if _e988 {
                                                    phi_3665_ = (_e964 + (_e967 * ((3u * _e932) + 1u)));
                                                } else {
                                                    phi_3665_ = u32();
                                                }
                                                let _e992 = phi_3665_;
                                                phi_3667_ = _e992;
                                                phi_3668_ = select(true, false, _e988);
                                            } else {
                                                phi_3667_ = u32();
                                                phi_3668_ = true;
                                            }
                                            let _e995 = phi_3667_;
                                            let _e997 = phi_3668_;
                                            if (_e975 == 0u) {
                                                phi_3689_ = (_e963 + select(0u, 1u, !(_e976)));
                                            } else {
                                                if (_e975 == 7u) {
                                                    phi_3688_ = 2147483648u;
                                                } else {
                                                    phi_3688_ = ((2147483648u | (_e975 << bitcast<u32>(28u))) | (select(_e995, _e964, _e997) & 268435455u));
                                                }
                                                let _e1010 = phi_3688_;
                                                phi_3689_ = _e1010;
                                            }
                                            let _e1012 = phi_3689_;
                                            phi_3693_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e890, (_e692.member.member.x + _e842), _e895, (_e692.member.member_1.x - _e881)), vec4<f32>(_e891, (_e692.member.member.y + _e846), _e896, (_e692.member.member_1.y - _e885)), vec4<f32>(_e892, (_e692.member.member.z + _e850), _e897, (_e692.member.member_1.z - _e889))), type_50(type_28((_e692.member.member + vec4<f32>(_e820, _e829, _e838, 0f)), (_e692.member.member_1 - vec4<f32>(_e859, _e868, _e877, 0f))), _e987), type_50(type_28((_e692.member.member + vec4<f32>(_e842, _e846, _e850, 0f)), (_e692.member.member_1 - vec4<f32>(_e881, _e885, _e889, 0f))), _e1012));
                                        }
                                        let _e1017 = phi_3693_;
                                        let _e1029 = ((_e1017.member[0].x - _e369) * _e372);
                                        let _e1030 = ((_e1017.member[0].y - _e369) * _e372);
                                        let _e1031 = ((_e1017.member[0].z - _e370) * _e372);
                                        let _e1032 = ((_e1017.member[0].w - _e370) * _e372);
                                        let _e1042 = ((_e1017.member[1].x - _e435) * _e438);
                                        let _e1043 = ((_e1017.member[1].y - _e435) * _e438);
                                        let _e1044 = ((_e1017.member[1].z - _e436) * _e438);
                                        let _e1045 = ((_e1017.member[1].w - _e436) * _e438);
                                        let _e1055 = ((_e1017.member[2].x - _e501) * _e504);
                                        let _e1056 = ((_e1017.member[2].y - _e501) * _e504);
                                        let _e1057 = ((_e1017.member[2].z - _e502) * _e504);
                                        let _e1058 = ((_e1017.member[2].w - _e502) * _e504);
                                        let _e1060 = select(_e1057, _e1055, (_e1055 < _e1057));
                                        let _e1062 = select(_e1058, _e1056, (_e1056 < _e1058));
                                        let _e1064 = select(_e1057, _e1055, (_e1055 > _e1057));
                                        let _e1066 = select(_e1058, _e1056, (_e1056 > _e1058));
                                        let _e1068 = select(_e1031, _e1029, (_e1029 < _e1031));
                                        let _e1070 = select(_e1032, _e1030, (_e1030 < _e1032));
                                        let _e1072 = select(_e1044, _e1042, (_e1042 < _e1044));
                                        let _e1074 = select(_e1045, _e1043, (_e1043 < _e1045));
                                        let _e1076 = select(_e1072, _e1068, (_e1068 > _e1072));
                                        let _e1078 = select(_e1074, _e1070, (_e1070 > _e1074));
                                        let _e1080 = select(_e1060, _e1076, (_e1076 > _e1060));
                                        let _e1082 = select(_e1062, _e1078, (_e1078 > _e1062));
                                        let _e1084 = select(_e1031, _e1029, (_e1029 > _e1031));
                                        let _e1086 = select(_e1032, _e1030, (_e1030 > _e1032));
                                        let _e1088 = select(_e1044, _e1042, (_e1042 > _e1044));
                                        let _e1090 = select(_e1045, _e1043, (_e1043 > _e1045));
                                        let _e1092 = select(_e1088, _e1084, (_e1084 < _e1088));
                                        let _e1094 = select(_e1090, _e1086, (_e1086 < _e1090));
                                        let _e1099 = -(_e1060);
                                        let _e1100 = -(_e1062);
                                        let _e1107 = (select(_e1064, _e1092, (_e1092 < _e1064)) + (select(_e1099, _e1064, (_e1064 > _e1099)) * 0.0000019073523f));
                                        let _e1108 = (select(_e1066, _e1094, (_e1094 < _e1066)) + (select(_e1100, _e1066, (_e1066 > _e1100)) * 0.0000019073523f));
                                        let _e1110 = select(_e607, _e1080, (_e1080 > _e607));
                                        let _e1112 = select(_e607, _e1082, (_e1082 > _e607));
                                        let _e1117 = (_e1110 <= select(_e651.member_1, _e1107, (_e1107 < _e651.member_1)));
                                        let _e1118 = (_e1112 <= select(_e651.member_1, _e1108, (_e1108 < _e651.member_1)));
                                        let _e1119 = (_e1110 <= _e1112);
                                        if _e1117 {
                                            if _e1118 {
                                                if _e1119 {
                                                    phi_4055_ = _e1017.member_2;
                                                } else {
                                                    phi_4055_ = _e1017.member_1;
                                                }
                                                let _e1123 = phi_4055_;
                                                let _e1144 = (_e694 % 128u);
                                                let _e1145 = (_e1144 < 128u);
                                                if _e1145 {
                                                } else {
                                                    phi_4868_ = true;
                                                    break;
                                                }
                                                local_8[_e1144] = _e1123.member_1;
                                                if _e1145 {
                                                } else {
                                                    phi_4868_ = true;
                                                    break;
                                                }
                                                local_7[_e1144] = _e1123.member.member.x;
                                                if _e1145 {
                                                } else {
                                                    phi_4868_ = true;
                                                    break;
                                                }
                                                local_6[_e1144] = _e1123.member.member.y;
                                                if _e1145 {
                                                } else {
                                                    phi_4868_ = true;
                                                    break;
                                                }
                                                local_5[_e1144] = _e1123.member.member.z;
                                                if _e1145 {
                                                } else {
                                                    phi_4868_ = true;
                                                    break;
                                                }
                                                local_4[_e1144] = _e1123.member.member_1.x;
                                                if _e1145 {
                                                } else {
                                                    phi_4868_ = true;
                                                    break;
                                                }
                                                local_3[_e1144] = _e1123.member.member_1.y;
                                                if _e1145 {
                                                } else {
                                                    phi_4868_ = true;
                                                    break;
                                                }
                                                local_2[_e1144] = _e1123.member.member_1.z;
                                                if _e1145 {
                                                } else {
                                                    phi_4868_ = true;
                                                    break;
                                                }
                                                local_9[_e1144] = select(_e1110, _e1112, _e1119);
                                                if _e1119 {
                                                    phi_4131_ = _e1017.member_1;
                                                } else {
                                                    phi_4131_ = _e1017.member_2;
                                                }
                                                let _e1158 = phi_4131_;
                                                phi_4132_ = _e1158;
                                                phi_4133_ = (_e694 + 1u);
                                            } else {
                                                phi_4132_ = type_50();
                                                phi_4133_ = u32();
                                            }
                                            let _e1160 = phi_4132_;
                                            let _e1162 = phi_4133_;
                                            phi_4135_ = _e1160;
                                            phi_4136_ = _e1162;
                                            phi_4137_ = select(true, false, _e1118);
                                        } else {
                                            phi_4135_ = type_50();
                                            phi_4136_ = u32();
                                            phi_4137_ = true;
                                        }
                                        let _e1165 = phi_4135_;
                                        let _e1167 = phi_4136_;
                                        let _e1169 = phi_4137_;
                                        if _e1169 {
                                            if _e1117 {
                                                phi_4146_ = _e1017.member_1;
                                            } else {
                                                phi_4146_ = _e1017.member_2;
                                            }
                                            let _e1173 = phi_4146_;
                                            phi_4151_ = select(_e1118, true, _e1117);
                                            phi_4152_ = _e1173;
                                        } else {
                                            phi_4151_ = _e690;
                                            phi_4152_ = _e1165;
                                        }
                                        let _e1176 = phi_4151_;
                                        let _e1178 = phi_4152_;
                                        phi_4872_ = _e649;
                                        phi_4154_ = _e651;
                                        phi_4155_ = _e1176;
                                        phi_4156_ = _e1178;
                                        phi_4157_ = select(_e1167, _e694, _e1169);
                                    }
                                    let _e2111 = phi_4872_;
                                    let _e2113 = phi_4154_;
                                    let _e2115 = phi_4155_;
                                    let _e2117 = phi_4156_;
                                    let _e2119 = phi_4157_;
                                    phi_4871_ = _e2111;
                                    phi_4158_ = _e2113;
                                    phi_4159_ = _e2115;
                                    phi_4160_ = _e2117;
                                    phi_4161_ = _e2119;
                                    phi_4162_ = (_e659 - 1u);
                                } else {
                                    phi_4871_ = _e649;
                                    phi_4158_ = _e651;
                                    phi_4159_ = _e690;
                                    phi_4160_ = _e692;
                                    phi_4161_ = _e694;
                                    phi_4162_ = _e659;
                                }
                                let _e2121 = phi_4871_;
                                let _e2123 = phi_4158_;
                                let _e2125 = phi_4159_;
                                let _e2127 = phi_4160_;
                                let _e2129 = phi_4161_;
                                let _e2131 = phi_4162_;
                                phi_4870_ = _e2121;
                                phi_4163_ = _e2123;
                                phi_4164_ = _e2125;
                                phi_4165_ = _e2127;
                                phi_4166_ = _e2129;
                                phi_4167_ = _e2131;
                            } else {
                                phi_4870_ = _e649;
                                phi_4163_ = type_33();
                                phi_4164_ = bool();
                                phi_4165_ = type_50();
                                phi_4166_ = u32();
                                phi_4167_ = u32();
                            }
                            let _e2133 = phi_4870_;
                            let _e2135 = phi_4163_;
                            let _e2137 = phi_4164_;
                            let _e2139 = phi_4165_;
                            let _e2141 = phi_4166_;
                            let _e2143 = phi_4167_;
                            phi_4869_ = _e2133;
                            phi_1201_ = _e2135;
                            phi_1204_ = _e2137;
                            phi_1206_ = _e2139;
                            phi_1208_ = _e2141;
                            phi_1210_ = _e2143;
                            phi_4168_ = _e663;
                        } else {
                            phi_4869_ = _e649;
                            phi_1201_ = type_33();
                            phi_1204_ = bool();
                            phi_1206_ = type_50();
                            phi_1208_ = u32();
                            phi_1210_ = u32();
                            phi_4168_ = false;
                        }
                        let _e2145 = phi_4869_;
                        let _e2147 = phi_1201_;
                        let _e2149 = phi_1204_;
                        let _e2151 = phi_1206_;
                        let _e2153 = phi_1208_;
                        let _e2155 = phi_1210_;
                        let _e2157 = phi_4168_;
                        continue;
                        continuing {
                            phi_4674_ = _e2145;
                            phi_1200_ = _e2147;
                            phi_1203_ = _e2149;
                            phi_1205_ = _e2151;
                            phi_1207_ = _e2153;
                            phi_1209_ = _e2155;
                            phi_4868_ = _e2145;
                            break if !(_e2157);
                        }
                    }
                    let _e2160 = phi_4868_;
                    if _e2160 {
                        break;
                    }
                    let _e2162 = local_11;
                    if (_e2162.member.member_3 != 4294967295u) {
                        let _e2167 = -(_e509);
                        let _e2168 = bitcast<u32>(_e2162.member.member);
                        let _e2172 = (bitcast<i32>((_e2168 >> bitcast<u32>(23i))) & 255i);
                        let _e2173 = (_e2172 + _e2167);
                        if (_e2172 == 255i) {
                            phi_4227_ = _e2162.member.member;
                        } else {
                            if (_e2172 > 0i) {
                                if (_e2173 > 0i) {
                                    let _e2177 = (_e2173 < 255i);
                                    if _e2177 {
                                        phi_4206_ = bitcast<f32>((_e2168 + bitcast<u32>((_e2167 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4206_ = f32();
                                    }
                                    let _e2184 = phi_4206_;
                                    phi_4208_ = _e2184;
                                    phi_4209_ = select(true, false, _e2177);
                                } else {
                                    phi_4208_ = f32();
                                    phi_4209_ = true;
                                }
                                let _e2187 = phi_4208_;
                                let _e2189 = phi_4209_;
                                phi_4210_ = _e2187;
                                phi_4211_ = _e2189;
                            } else {
                                phi_4210_ = f32();
                                phi_4211_ = true;
                            }
                            let _e2191 = phi_4210_;
                            let _e2193 = phi_4211_;
                            if _e2193 {
                                let _e2194 = (_e2168 & 2147483648u);
                                let _e2201 = ((_e2168 & 8388607u) | (select(0u, 1u, ((_e2168 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2205 = (_e2201 == 0u);
                                if _e2205 {
                                    phi_4626_ = bitcast<f32>(_e2194);
                                } else {
                                    let _e2210 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2201)), 32u, _e2205) - 8u);
                                    let _e2213 = (_e2201 << bitcast<u32>((_e2210 & 31u)));
                                    let _e2215 = ((_e2173 + select(0i, 1i, (_e2172 == 0i))) - bitcast<i32>(_e2210));
                                    if (_e2215 >= 255i) {
                                        phi_4616_ = bitcast<f32>((_e2194 | 2139095040u));
                                        phi_4617_ = f32();
                                        phi_4618_ = true;
                                    } else {
                                        let _e2217 = (_e2215 > 0i);
                                        if _e2217 {
                                            phi_4610_ = bitcast<f32>(((_e2194 | (bitcast<u32>(_e2215) << bitcast<u32>(23i))) | (_e2213 & 8388607u)));
                                            phi_4611_ = f32();
                                        } else {
                                            if (_e2215 < -24i) {
                                                phi_4576_ = 26u;
                                            } else {
                                                phi_4576_ = bitcast<u32>((1i - _e2215));
                                            }
                                            let _e2222 = phi_4576_;
                                            let _e2223 = (_e2222 & 31u);
                                            let _e2225 = (_e2213 >> bitcast<u32>(_e2223));
                                            let _e2229 = (_e2213 & ((1u << bitcast<u32>(_e2223)) - 1u));
                                            let _e2233 = (1u << bitcast<u32>(((_e2222 - 1u) & 31u)));
                                            if (_e2229 > _e2233) {
                                                phi_4597_ = true;
                                            } else {
                                                if (_e2229 == _e2233) {
                                                    phi_4594_ = ((_e2225 & 1u) == 1u);
                                                } else {
                                                    phi_4594_ = false;
                                                }
                                                let _e2239 = phi_4594_;
                                                phi_4597_ = _e2239;
                                            }
                                            let _e2241 = phi_4597_;
                                            phi_4610_ = f32();
                                            phi_4611_ = bitcast<f32>((_e2194 | (_e2225 + select(0u, 1u, _e2241))));
                                        }
                                        let _e2254 = phi_4610_;
                                        let _e2256 = phi_4611_;
                                        phi_4616_ = _e2254;
                                        phi_4617_ = _e2256;
                                        phi_4618_ = _e2217;
                                    }
                                    let _e2260 = phi_4616_;
                                    let _e2262 = phi_4617_;
                                    let _e2264 = phi_4618_;
                                    phi_4626_ = select(_e2262, _e2260, _e2264);
                                }
                                let _e2268 = phi_4626_;
                                phi_4226_ = _e2268;
                            } else {
                                phi_4226_ = _e2191;
                            }
                            let _e2270 = phi_4226_;
                            phi_4227_ = _e2270;
                        }
                        let _e2272 = phi_4227_;
                        let _e2273 = bitcast<u32>(_e2272);
                        if ((_e2273 & 2147483647u) >= 2139095040u) {
                            phi_4239_ = bitcast<f32>(((_e2273 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4239_ = _e2272;
                        }
                        let _e2280 = phi_4239_;
                        phi_4244_ = type_20(_e2280, _e2162.member.member_1, _e2162.member.member_2, _e2162.member.member_3);
                    } else {
                        phi_4244_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2285 = phi_4244_;
                    if _e155 {
                    } else {
                        break;
                    }
                    global_6.member[_e153] = _e2285;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
