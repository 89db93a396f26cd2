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

struct type_26 {
    member: array<type_24>,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_37 {
    member: type_24,
    member_1: f32,
}

struct type_40 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_42 {
    member: array<type_28>,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: type_32,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_45;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_42;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_26;

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
    var phi_1200_: type_37;
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
    var phi_1327_: type_37;
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
    var phi_2839_: type_40;
    var phi_2840_: type_40;
    var phi_2843_: type_40;
    var phi_2844_: type_40;
    var phi_2845_: bool;
    var phi_2849_: type_40;
    var phi_2858_: type_24;
    var phi_2883_: bool;
    var phi_2884_: bool;
    var phi_2890_: type_37;
    var phi_2891_: type_37;
    var phi_2892_: type_37;
    var phi_1328_: type_37;
    var phi_4668_: bool;
    var local_10: type_37;
    var phi_4872_: bool;
    var phi_4154_: type_37;
    var phi_4155_: bool;
    var phi_4156_: type_50;
    var phi_4157_: u32;
    var phi_4871_: bool;
    var phi_4158_: type_37;
    var phi_4159_: bool;
    var phi_4160_: type_50;
    var phi_4161_: u32;
    var phi_4162_: u32;
    var phi_4870_: bool;
    var phi_4163_: type_37;
    var phi_4164_: bool;
    var phi_4165_: type_50;
    var phi_4166_: u32;
    var phi_4167_: u32;
    var phi_4869_: bool;
    var phi_1201_: type_37;
    var phi_1204_: bool;
    var phi_1206_: type_50;
    var phi_1208_: u32;
    var phi_1210_: u32;
    var phi_4168_: bool;
    var phi_4868_: bool;
    var local_11: type_37;
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
    var phi_4244_: type_24;
    var local_12: type_37;

    switch bitcast<i32>(0u) {
        default: {
            let _e97 = global;
            let _e99 = arrayLength((&global_3.member));
            let _e102 = arrayLength((&global_5.member));
            let _e110 = global_2.member[0u][0u];
            let _e114 = global_2.member[0u][1u];
            let _e118 = global_2.member[0u][2u];
            let _e122 = global_2.member[0u][3u];
            let _e126 = global_2.member[1u][0u];
            let _e130 = global_2.member[1u][1u];
            let _e134 = global_2.member[1u][2u];
            let _e137 = global_1.member[0u];
            let _e138 = bitcast<i32>(_e137);
            let _e150 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e122) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e110), bitcast<i32>(_e114), bitcast<i32>(_e118));
            local = array<i32, 3>(bitcast<i32>(_e126), bitcast<i32>(_e130), bitcast<i32>(_e134));
            let _e156 = (_e97.x + (_e97.y * 2097152u));
            let _e157 = (_e156 < arrayLength((&global_4.member)));
            if _e157 {
                let _e158 = (_e156 < arrayLength((&global_6.member)));
                if _e158 {
                    if _e157 {
                    } else {
                        break;
                    }
                    let _e166 = global_4.member[_e156].member_2[0u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_4.member[_e156].member_2[1u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_4.member[_e156].member_2[2u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e187 = global_4.member[_e156].member[0u];
                    let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                    let _e194 = global_4.member[_e156].member[1u];
                    let _e196 = (bitcast<u32>(_e194) & 2147483647u);
                    let _e201 = global_4.member[_e156].member[2u];
                    let _e203 = (bitcast<u32>(_e201) & 2147483647u);
                    let _e205 = select(_e175, _e168, (_e175 < _e168));
                    let _e207 = select(_e182, _e205, (_e182 < _e205));
                    let _e209 = select(_e189, _e207, (_e189 < _e207));
                    let _e211 = select(_e196, _e209, (_e196 < _e209));
                    let _e213 = select(_e203, _e211, (_e203 < _e211));
                    let _e217 = global_4.member[_e156].member_1;
                    let _e218 = bitcast<u32>(_e217);
                    let _e219 = (_e218 & 2147483647u);
                    let _e226 = global_4.member[_e156].member_3;
                    let _e227 = bitcast<u32>(_e226);
                    let _e228 = (_e227 & 2147483647u);
                    let _e232 = (((select(_e219, _e213, (_e219 < _e213)) < 2139095040u) && (_e228 <= 2139095040u)) && (_e207 > 0u));
                    if _e232 {
                        let _e235 = (bitcast<u32>(bitcast<f32>(_e207)) & 2147483647u);
                        if (_e235 >= 8388608u) {
                            phi_511_ = (bitcast<i32>((_e235 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_511_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e235)), 32u, (_e235 == 0u))));
                        }
                        let _e249 = phi_511_;
                        phi_512_ = _e249;
                    } else {
                        phi_512_ = 0i;
                    }
                    let _e251 = phi_512_;
                    let _e252 = (_e168 == _e207);
                    if _e252 {
                        phi_522_ = true;
                    } else {
                        phi_522_ = (_e175 == _e207);
                    }
                    let _e255 = phi_522_;
                    let _e256 = select(1u, 0u, _e252);
                    if _e255 {
                        let _e257 = (_e256 + 1u);
                        phi_532_ = _e257;
                        phi_533_ = _e257;
                        phi_535_ = select(true, false, (_e257 == 2u));
                    } else {
                        phi_532_ = u32();
                        phi_533_ = 0u;
                        phi_535_ = true;
                    }
                    let _e261 = phi_532_;
                    let _e263 = phi_533_;
                    let _e265 = phi_535_;
                    if _e265 {
                        phi_540_ = (_e263 + 1u);
                    } else {
                        phi_540_ = 0u;
                    }
                    let _e269 = phi_540_;
                    let _e270 = select(_e261, _e263, _e265);
                    let _e271 = select(_e256, select(2u, _e256, _e255), _e265);
                    if (_e138 < -126i) {
                        phi_553_ = -126i;
                    } else {
                        phi_553_ = select(_e138, 127i, (_e138 > 127i));
                    }
                    let _e276 = phi_553_;
                    let _e281 = bitcast<f32>((bitcast<u32>((_e276 + 127i)) << bitcast<u32>(23i)));
                    let _e287 = bitcast<f32>((bitcast<u32>(((_e138 - _e276) + 127i)) << bitcast<u32>(23i)));
                    let _e288 = -(_e251);
                    if (_e288 < -126i) {
                        phi_573_ = -126i;
                    } else {
                        phi_573_ = select(_e288, 127i, (_e288 > 127i));
                    }
                    let _e293 = phi_573_;
                    let _e298 = bitcast<f32>((bitcast<u32>((_e293 + 127i)) << bitcast<u32>(23i)));
                    let _e304 = bitcast<f32>((bitcast<u32>(((_e288 - _e293) + 127i)) << bitcast<u32>(23i)));
                    let _e308 = global_4.member[_e156].member;
                    let _e309 = (_e270 == 0u);
                    if _e309 {
                        phi_591_ = _e308[0];
                    } else {
                        phi_591_ = _e308[1];
                    }
                    let _e313 = phi_591_;
                    let _e314 = (_e270 == 2u);
                    if _e314 {
                        phi_597_ = _e308[2];
                    } else {
                        phi_597_ = _e313;
                    }
                    let _e317 = phi_597_;
                    let _e318 = bitcast<u32>(_e317);
                    let _e320 = ((_e318 & 2139095040u) != 0u);
                    let _e334 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e317, _e320) * _e281) * select(0.00000011920929f, 1f, _e320)) * _e287);
                    let _e335 = global_4.member[_e156].member_2;
                    if _e309 {
                        phi_637_ = _e335[0];
                    } else {
                        phi_637_ = _e335[1];
                    }
                    let _e339 = phi_637_;
                    if _e314 {
                        phi_643_ = _e335[2];
                    } else {
                        phi_643_ = _e339;
                    }
                    let _e342 = phi_643_;
                    let _e343 = bitcast<u32>(_e342);
                    let _e345 = ((_e343 & 2139095040u) != 0u);
                    let _e359 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e343 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e343 & 2147483648u))), _e342, _e345) * _e298) * select(0.00000011920929f, 1f, _e345)) * _e304);
                    let _e363 = (bitcast<f32>((bitcast<u32>(_e359) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e366 = bitcast<f32>((bitcast<u32>(_e334) & 2147483647u));
                    let _e367 = (_e366 * 0.00000011920929f);
                    let _e370 = select(select(0.00000000000011368684f, _e367, (_e367 > 0.00000000000011368684f)), 0f, _e363);
                    let _e371 = select(0f, _e359, _e363);
                    let _e372 = (_e334 + _e370);
                    let _e373 = (_e334 - _e370);
                    let _e375 = select(38685626000000000000000000f, (1f / _e359), _e363);
                    let _e376 = (_e269 == 0u);
                    if _e376 {
                        phi_716_ = _e308[0];
                    } else {
                        phi_716_ = _e308[1];
                    }
                    let _e380 = phi_716_;
                    let _e381 = (_e269 == 2u);
                    if _e381 {
                        phi_722_ = _e308[2];
                    } else {
                        phi_722_ = _e380;
                    }
                    let _e384 = phi_722_;
                    let _e385 = bitcast<u32>(_e384);
                    let _e387 = ((_e385 & 2139095040u) != 0u);
                    let _e401 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e385 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e385 & 2147483648u))), _e384, _e387) * _e281) * select(0.00000011920929f, 1f, _e387)) * _e287);
                    if _e376 {
                        phi_762_ = _e335[0];
                    } else {
                        phi_762_ = _e335[1];
                    }
                    let _e405 = phi_762_;
                    if _e381 {
                        phi_768_ = _e335[2];
                    } else {
                        phi_768_ = _e405;
                    }
                    let _e408 = phi_768_;
                    let _e409 = bitcast<u32>(_e408);
                    let _e411 = ((_e409 & 2139095040u) != 0u);
                    let _e425 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e409 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e409 & 2147483648u))), _e408, _e411) * _e298) * select(0.00000011920929f, 1f, _e411)) * _e304);
                    let _e429 = (bitcast<f32>((bitcast<u32>(_e425) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e432 = bitcast<f32>((bitcast<u32>(_e401) & 2147483647u));
                    let _e433 = (_e432 * 0.00000011920929f);
                    let _e436 = select(select(0.00000000000011368684f, _e433, (_e433 > 0.00000000000011368684f)), 0f, _e429);
                    let _e437 = select(0f, _e425, _e429);
                    let _e438 = (_e401 + _e436);
                    let _e439 = (_e401 - _e436);
                    let _e441 = select(38685626000000000000000000f, (1f / _e425), _e429);
                    let _e442 = (_e271 == 0u);
                    if _e442 {
                        phi_841_ = _e308[0];
                    } else {
                        phi_841_ = _e308[1];
                    }
                    let _e446 = phi_841_;
                    let _e447 = (_e271 == 2u);
                    if _e447 {
                        phi_847_ = _e308[2];
                    } else {
                        phi_847_ = _e446;
                    }
                    let _e450 = phi_847_;
                    let _e451 = bitcast<u32>(_e450);
                    let _e453 = ((_e451 & 2139095040u) != 0u);
                    let _e467 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e451 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e451 & 2147483648u))), _e450, _e453) * _e281) * select(0.00000011920929f, 1f, _e453)) * _e287);
                    if _e442 {
                        phi_887_ = _e335[0];
                    } else {
                        phi_887_ = _e335[1];
                    }
                    let _e471 = phi_887_;
                    if _e447 {
                        phi_893_ = _e335[2];
                    } else {
                        phi_893_ = _e471;
                    }
                    let _e474 = phi_893_;
                    let _e475 = bitcast<u32>(_e474);
                    let _e477 = ((_e475 & 2139095040u) != 0u);
                    let _e491 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e475 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e475 & 2147483648u))), _e474, _e477) * _e298) * select(0.00000011920929f, 1f, _e477)) * _e304);
                    let _e495 = (bitcast<f32>((bitcast<u32>(_e491) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e498 = bitcast<f32>((bitcast<u32>(_e467) & 2147483647u));
                    let _e499 = (_e498 * 0.00000011920929f);
                    let _e502 = select(select(0.00000000000011368684f, _e499, (_e499 > 0.00000000000011368684f)), 0f, _e495);
                    let _e503 = select(0f, _e491, _e495);
                    let _e504 = (_e467 + _e502);
                    let _e505 = (_e467 - _e502);
                    let _e507 = select(38685626000000000000000000f, (1f / _e491), _e495);
                    let _e509 = select(_e432, _e366, (_e366 > _e432));
                    let _e512 = (_e138 + _e251);
                    if (_e232 && (select(_e498, _e509, (_e509 > _e498)) <= 1099511600000f)) {
                        let _e522 = ((_e219 & 8388607u) | (select(0u, 1u, ((_e219 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e525 = bitcast<i32>((_e219 >> bitcast<u32>(23i)));
                        let _e529 = (_e522 == 0u);
                        let _e532 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e522)), 32u, _e529)) - 8i);
                        if (_e525 == 255i) {
                            phi_1012_ = 255i;
                        } else {
                            phi_1012_ = (((_e525 + select(0i, 1i, (_e525 == 0i))) - _e532) + _e512);
                        }
                        let _e540 = phi_1012_;
                        let _e550 = (_e540 <= 0i);
                        if _e550 {
                            phi_1035_ = u32();
                        } else {
                            if _e529 {
                                phi_1034_ = u32();
                            } else {
                                phi_1034_ = select(((bitcast<u32>(_e540) << bitcast<u32>(23i)) | ((_e522 << bitcast<u32>(((_e532 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e540 >= 255i));
                            }
                            let _e554 = phi_1034_;
                            phi_1035_ = _e554;
                        }
                        let _e556 = phi_1035_;
                        let _e568 = ((_e228 & 8388607u) | (select(0u, 1u, ((_e228 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e571 = bitcast<i32>((_e228 >> bitcast<u32>(23i)));
                        let _e575 = (_e568 == 0u);
                        let _e578 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e568)), 32u, _e575)) - 8i);
                        if (_e571 == 255i) {
                            phi_1072_ = 255i;
                        } else {
                            phi_1072_ = (((_e571 + select(0i, 1i, (_e571 == 0i))) - _e578) + _e512);
                        }
                        let _e586 = phi_1072_;
                        let _e596 = (_e586 <= 0i);
                        if _e596 {
                            phi_1095_ = u32();
                        } else {
                            if _e575 {
                                phi_1094_ = u32();
                            } else {
                                phi_1094_ = select(((bitcast<u32>(_e586) << bitcast<u32>(23i)) | ((_e568 << bitcast<u32>(((_e578 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e586 >= 255i));
                            }
                            let _e600 = phi_1094_;
                            phi_1095_ = _e600;
                        }
                        let _e602 = phi_1095_;
                        phi_1103_ = bitcast<f32>(((_e227 & 2147483648u) | select(_e602, 0u, select(_e575, true, _e596))));
                        phi_1104_ = bitcast<f32>(((_e218 & 2147483648u) | select(_e556, 0u, select(_e529, true, _e550))));
                    } else {
                        phi_1103_ = 0f;
                        phi_1104_ = 1f;
                    }
                    let _e608 = phi_1103_;
                    let _e610 = phi_1104_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e616 = (_e270 % 3u);
                    let _e617 = (_e616 < 3u);
                    if _e617 {
                    } else {
                        break;
                    }
                    let _e619 = local_1[_e616];
                    let _e622 = (_e269 % 3u);
                    let _e623 = (_e622 < 3u);
                    if _e623 {
                    } else {
                        break;
                    }
                    let _e625 = local_1[_e622];
                    let _e628 = (_e271 % 3u);
                    let _e629 = (_e628 < 3u);
                    if _e629 {
                    } else {
                        break;
                    }
                    let _e631 = local_1[_e628];
                    if _e617 {
                    } else {
                        break;
                    }
                    let _e636 = local[_e616];
                    if _e623 {
                    } else {
                        break;
                    }
                    let _e640 = local[_e622];
                    if _e629 {
                    } else {
                        break;
                    }
                    let _e644 = local[_e628];
                    phi_4674_ = false;
                    phi_1200_ = type_37(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e608);
                    phi_1203_ = (_e610 <= _e608);
                    phi_1205_ = type_50(type_32(vec4<f32>((f32(_e619) * _e150), (f32(_e625) * _e150), (f32(_e631) * _e150), 0f), vec4<f32>((f32(_e636) * _e150), (f32(_e640) * _e150), (f32(_e644) * _e150), 0f)), select(0u, 2147483648u, (_e99 == 0u)));
                    phi_1207_ = 0u;
                    phi_1209_ = ((3u * _e99) + 1u);
                    loop {
                        let _e652 = phi_4674_;
                        let _e654 = phi_1200_;
                        let _e656 = phi_1203_;
                        let _e658 = phi_1205_;
                        let _e660 = phi_1207_;
                        let _e662 = phi_1209_;
                        local_11 = _e654;
                        if _e656 {
                            phi_1220_ = true;
                        } else {
                            phi_1220_ = (_e660 > 0u);
                        }
                        let _e665 = phi_1220_;
                        if _e665 {
                            let _e666 = (_e662 > 0u);
                            if _e666 {
                                if _e656 {
                                    phi_1306_ = _e656;
                                    phi_1307_ = _e658;
                                    phi_1308_ = _e660;
                                } else {
                                    let _e667 = (_e660 - 1u);
                                    let _e668 = (_e667 % 128u);
                                    let _e669 = (_e668 < 128u);
                                    if _e669 {
                                    } else {
                                        phi_4868_ = true;
                                        break;
                                    }
                                    let _e671 = local_7[_e668];
                                    if _e669 {
                                    } else {
                                        phi_4868_ = true;
                                        break;
                                    }
                                    let _e673 = local_6[_e668];
                                    if _e669 {
                                    } else {
                                        phi_4868_ = true;
                                        break;
                                    }
                                    let _e675 = local_5[_e668];
                                    if _e669 {
                                    } else {
                                        phi_4868_ = true;
                                        break;
                                    }
                                    let _e677 = local_4[_e668];
                                    if _e669 {
                                    } else {
                                        phi_4868_ = true;
                                        break;
                                    }
                                    let _e679 = local_3[_e668];
                                    if _e669 {
                                    } else {
                                        phi_4868_ = true;
                                        break;
                                    }
                                    let _e681 = local_2[_e668];
                                    if _e669 {
                                    } else {
                                        phi_4868_ = true;
                                        break;
                                    }
                                    let _e686 = local_8[_e668];
                                    if _e669 {
                                    } else {
                                        phi_4868_ = true;
                                        break;
                                    }
                                    let _e689 = local_9[_e668];
                                    phi_1306_ = (_e689 <= _e654.member_1);
                                    phi_1307_ = type_50(type_32(vec4<f32>(_e671, _e673, _e675, 0f), vec4<f32>(_e677, _e679, _e681, 0f)), _e686);
                                    phi_1308_ = _e667;
                                }
                                let _e693 = phi_1306_;
                                let _e695 = phi_1307_;
                                let _e697 = phi_1308_;
                                if _e693 {
                                    let _e702 = (_e695.member_1 & 268435455u);
                                    if ((_e695.member_1 & 2147483648u) != 0u) {
                                        phi_1327_ = _e654;
                                        phi_1330_ = type_8(0u, ((_e695.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1167 = phi_1327_;
                                            let _e1169 = phi_1330_;
                                            local_10 = _e1167;
                                            local_12 = _e1167;
                                            if (_e1169.member < _e1169.member_1) {
                                                phi_1331_ = type_8((_e1169.member + 1u), _e1169.member_1);
                                                phi_1353_ = type_8(1u, _e1169.member);
                                            } else {
                                                phi_1331_ = _e1169;
                                                phi_1353_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1182 = phi_1331_;
                                            let _e1184 = phi_1353_;
                                            let _e1188 = (bitcast<i32>(_e1184.member) != 0i);
                                            if _e1188 {
                                                let _e1193 = (_e695.member.member_1.x - _e695.member.member.x);
                                                let _e1196 = (_e695.member.member_1.y - _e695.member.member.y);
                                                let _e1199 = (_e695.member.member_1.z - _e695.member.member.z);
                                                let _e1201 = select(_e1196, _e1193, (_e1193 > _e1196));
                                                let _e1203 = select(_e1199, _e1201, (_e1201 > _e1199));
                                                let _e1205 = (_e1203 < (1024f * _e150));
                                                if _e1205 {
                                                    phi_1394_ = 0u;
                                                } else {
                                                    phi_1394_ = select(2u, 1u, (_e1203 < (2097152f * _e150)));
                                                }
                                                let _e1210 = phi_1394_;
                                                switch bitcast<i32>(_e1210) {
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
                                                let _e1213 = phi_1400_;
                                                switch bitcast<i32>(_e1210) {
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
                                                let _e1220 = phi_1410_;
                                                let _e1222 = ((_e702 + (_e1184.member_1 * ((3u * _e1213) + 1u))) + (3u * _e1220));
                                                let _e1223 = (_e1222 < _e102);
                                                if _e1223 {
                                                    if _e1223 {
                                                    } else {
                                                        phi_4668_ = true;
                                                        break;
                                                    }
                                                    let _e1225 = global_5.member[_e1222];
                                                    phi_1426_ = _e1225;
                                                } else {
                                                    phi_1426_ = 4294967295u;
                                                }
                                                let _e1227 = phi_1426_;
                                                if _e1205 {
                                                    phi_1459_ = 0u;
                                                } else {
                                                    phi_1459_ = select(2u, 1u, (_e1203 < (2097152f * _e150)));
                                                }
                                                let _e1232 = phi_1459_;
                                                switch bitcast<i32>(_e1232) {
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
                                                let _e1235 = phi_1465_;
                                                let _e1239 = (_e702 + (_e1184.member_1 * ((3u * _e1235) + 1u)));
                                                switch bitcast<i32>(_e1232) {
                                                    case 0: {
                                                        let _e1514 = (_e1239 < _e102);
                                                        if _e1514 {
                                                            if _e1514 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1516 = global_5.member[_e1239];
                                                            phi_1492_ = _e1516;
                                                        } else {
                                                            phi_1492_ = 0u;
                                                        }
                                                        let _e1518 = phi_1492_;
                                                        let _e1520 = ((10u * _e270) & 31u);
                                                        let _e1530 = ((10u * _e269) & 31u);
                                                        let _e1540 = ((10u * _e271) & 31u);
                                                        let _e1550 = (_e1239 + 1u);
                                                        let _e1551 = (_e1550 < _e102);
                                                        if _e1551 {
                                                            if _e1551 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1553 = global_5.member[_e1550];
                                                            phi_1541_ = _e1553;
                                                        } else {
                                                            phi_1541_ = 0u;
                                                        }
                                                        let _e1555 = phi_1541_;
                                                        let _e1581 = (_e1239 + 2u);
                                                        let _e1582 = (_e1581 < _e102);
                                                        if _e1582 {
                                                            if _e1582 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1584 = global_5.member[_e1581];
                                                            phi_1590_ = _e1584;
                                                        } else {
                                                            phi_1590_ = 0u;
                                                        }
                                                        let _e1586 = phi_1590_;
                                                        phi_2091_ = array<array<f32, 3>, 3>(array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | ((_e1518 >> bitcast<u32>(_e1520)) & 1023u))) - 8388608f) * _e150)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | ((_e1518 >> bitcast<u32>(_e1530)) & 1023u))) - 8388608f) * _e150)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | ((_e1518 >> bitcast<u32>(_e1540)) & 1023u))) - 8388608f) * _e150))), array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | ((_e1555 >> bitcast<u32>(_e1520)) & 1023u))) - 8388608f) * _e150)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | ((_e1555 >> bitcast<u32>(_e1530)) & 1023u))) - 8388608f) * _e150)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | ((_e1555 >> bitcast<u32>(_e1540)) & 1023u))) - 8388608f) * _e150))), array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | ((_e1586 >> bitcast<u32>(_e1520)) & 1023u))) - 8388608f) * _e150)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | ((_e1586 >> bitcast<u32>(_e1530)) & 1023u))) - 8388608f) * _e150)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | ((_e1586 >> bitcast<u32>(_e1540)) & 1023u))) - 8388608f) * _e150))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1328 = (_e1239 < _e102);
                                                        if _e1328 {
                                                            if _e1328 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1330 = global_5.member[_e1239];
                                                            phi_1639_ = _e1330;
                                                        } else {
                                                            phi_1639_ = 0u;
                                                        }
                                                        let _e1332 = phi_1639_;
                                                        let _e1333 = (_e1239 + 1u);
                                                        let _e1334 = (_e1333 < _e102);
                                                        if _e1334 {
                                                            if _e1334 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1336 = global_5.member[_e1333];
                                                            phi_1654_ = _e1336;
                                                        } else {
                                                            phi_1654_ = 0u;
                                                        }
                                                        let _e1338 = phi_1654_;
                                                        let _e1339 = (_e270 == 1u);
                                                        if _e1339 {
                                                            phi_1664_ = ((_e1332 >> bitcast<u32>(21i)) | (_e1338 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1664_ = (_e1338 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1348 = phi_1664_;
                                                        let _e1356 = (_e269 == 1u);
                                                        if _e1356 {
                                                            phi_1685_ = ((_e1332 >> bitcast<u32>(21i)) | (_e1338 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1685_ = (_e1338 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1365 = phi_1685_;
                                                        let _e1373 = (_e271 == 1u);
                                                        if _e1373 {
                                                            phi_1706_ = ((_e1332 >> bitcast<u32>(21i)) | (_e1338 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1706_ = (_e1338 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1382 = phi_1706_;
                                                        let _e1391 = (_e1239 + 2u);
                                                        let _e1392 = (_e1391 < _e102);
                                                        if _e1392 {
                                                            if _e1392 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1394 = global_5.member[_e1391];
                                                            phi_1736_ = _e1394;
                                                        } else {
                                                            phi_1736_ = 0u;
                                                        }
                                                        let _e1396 = phi_1736_;
                                                        let _e1397 = (_e1239 + 3u);
                                                        let _e1398 = (_e1397 < _e102);
                                                        if _e1398 {
                                                            if _e1398 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1400 = global_5.member[_e1397];
                                                            phi_1751_ = _e1400;
                                                        } else {
                                                            phi_1751_ = 0u;
                                                        }
                                                        let _e1402 = phi_1751_;
                                                        if _e1339 {
                                                            phi_1761_ = ((_e1396 >> bitcast<u32>(21i)) | (_e1402 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1761_ = (_e1402 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1411 = phi_1761_;
                                                        if _e1356 {
                                                            phi_1782_ = ((_e1396 >> bitcast<u32>(21i)) | (_e1402 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1782_ = (_e1402 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1427 = phi_1782_;
                                                        if _e1373 {
                                                            phi_1803_ = ((_e1396 >> bitcast<u32>(21i)) | (_e1402 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1803_ = (_e1402 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1443 = phi_1803_;
                                                        let _e1452 = (_e1239 + 4u);
                                                        let _e1453 = (_e1452 < _e102);
                                                        if _e1453 {
                                                            if _e1453 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1455 = global_5.member[_e1452];
                                                            phi_1833_ = _e1455;
                                                        } else {
                                                            phi_1833_ = 0u;
                                                        }
                                                        let _e1457 = phi_1833_;
                                                        let _e1458 = (_e1239 + 5u);
                                                        let _e1459 = (_e1458 < _e102);
                                                        if _e1459 {
                                                            if _e1459 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1461 = global_5.member[_e1458];
                                                            phi_1848_ = _e1461;
                                                        } else {
                                                            phi_1848_ = 0u;
                                                        }
                                                        let _e1463 = phi_1848_;
                                                        if _e1339 {
                                                            phi_1858_ = ((_e1457 >> bitcast<u32>(21i)) | (_e1463 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1858_ = (_e1463 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1472 = phi_1858_;
                                                        if _e1356 {
                                                            phi_1879_ = ((_e1457 >> bitcast<u32>(21i)) | (_e1463 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1879_ = (_e1463 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1488 = phi_1879_;
                                                        if _e1373 {
                                                            phi_1900_ = ((_e1457 >> bitcast<u32>(21i)) | (_e1463 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1900_ = (_e1463 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1504 = phi_1900_;
                                                        phi_2091_ = array<array<f32, 3>, 3>(array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1348, _e1332, _e309) & 2097151u))) - 8388608f) * _e150)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1365, _e1332, _e376) & 2097151u))) - 8388608f) * _e150)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1382, _e1332, _e442) & 2097151u))) - 8388608f) * _e150))), array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1411, _e1396, _e309) & 2097151u))) - 8388608f) * _e150)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1427, _e1396, _e376) & 2097151u))) - 8388608f) * _e150)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1443, _e1396, _e442) & 2097151u))) - 8388608f) * _e150))), array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1472, _e1457, _e309) & 2097151u))) - 8388608f) * _e150)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1488, _e1457, _e376) & 2097151u))) - 8388608f) * _e150)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1504, _e1457, _e442) & 2097151u))) - 8388608f) * _e150))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1241 = (_e1239 + _e270);
                                                        let _e1242 = (_e1241 < _e102);
                                                        if _e1242 {
                                                            if _e1242 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1244 = global_5.member[_e1241];
                                                            phi_1931_ = _e1244;
                                                        } else {
                                                            phi_1931_ = 0u;
                                                        }
                                                        let _e1246 = phi_1931_;
                                                        let _e1250 = (_e1239 + _e269);
                                                        let _e1251 = (_e1250 < _e102);
                                                        if _e1251 {
                                                            if _e1251 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1253 = global_5.member[_e1250];
                                                            phi_1949_ = _e1253;
                                                        } else {
                                                            phi_1949_ = 0u;
                                                        }
                                                        let _e1255 = phi_1949_;
                                                        let _e1259 = (_e1239 + _e271);
                                                        let _e1260 = (_e1259 < _e102);
                                                        if _e1260 {
                                                            if _e1260 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1262 = global_5.member[_e1259];
                                                            phi_1967_ = _e1262;
                                                        } else {
                                                            phi_1967_ = 0u;
                                                        }
                                                        let _e1264 = phi_1967_;
                                                        let _e1269 = (_e1239 + 3u);
                                                        let _e1270 = (_e1269 + _e270);
                                                        let _e1271 = (_e1270 < _e102);
                                                        if _e1271 {
                                                            if _e1271 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1273 = global_5.member[_e1270];
                                                            phi_1990_ = _e1273;
                                                        } else {
                                                            phi_1990_ = 0u;
                                                        }
                                                        let _e1275 = phi_1990_;
                                                        let _e1279 = (_e1269 + _e269);
                                                        let _e1280 = (_e1279 < _e102);
                                                        if _e1280 {
                                                            if _e1280 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1282 = global_5.member[_e1279];
                                                            phi_2008_ = _e1282;
                                                        } else {
                                                            phi_2008_ = 0u;
                                                        }
                                                        let _e1284 = phi_2008_;
                                                        let _e1288 = (_e1269 + _e271);
                                                        let _e1289 = (_e1288 < _e102);
                                                        if _e1289 {
                                                            if _e1289 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1291 = global_5.member[_e1288];
                                                            phi_2026_ = _e1291;
                                                        } else {
                                                            phi_2026_ = 0u;
                                                        }
                                                        let _e1293 = phi_2026_;
                                                        let _e1298 = (_e1239 + 6u);
                                                        let _e1299 = (_e1298 + _e270);
                                                        let _e1300 = (_e1299 < _e102);
                                                        if _e1300 {
                                                            if _e1300 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1302 = global_5.member[_e1299];
                                                            phi_2049_ = _e1302;
                                                        } else {
                                                            phi_2049_ = 0u;
                                                        }
                                                        let _e1304 = phi_2049_;
                                                        let _e1308 = (_e1298 + _e269);
                                                        let _e1309 = (_e1308 < _e102);
                                                        if _e1309 {
                                                            if _e1309 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1311 = global_5.member[_e1308];
                                                            phi_2067_ = _e1311;
                                                        } else {
                                                            phi_2067_ = 0u;
                                                        }
                                                        let _e1313 = phi_2067_;
                                                        let _e1317 = (_e1298 + _e271);
                                                        let _e1318 = (_e1317 < _e102);
                                                        if _e1318 {
                                                            if _e1318 {
                                                            } else {
                                                                phi_4668_ = true;
                                                                break;
                                                            }
                                                            let _e1320 = global_5.member[_e1317];
                                                            phi_2085_ = _e1320;
                                                        } else {
                                                            phi_2085_ = 0u;
                                                        }
                                                        let _e1322 = phi_2085_;
                                                        phi_2091_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1246)) * _e150), (f32(bitcast<i32>(_e1255)) * _e150), (f32(bitcast<i32>(_e1264)) * _e150)), array<f32, 3>((f32(bitcast<i32>(_e1275)) * _e150), (f32(bitcast<i32>(_e1284)) * _e150), (f32(bitcast<i32>(_e1293)) * _e150)), array<f32, 3>((f32(bitcast<i32>(_e1304)) * _e150), (f32(bitcast<i32>(_e1313)) * _e150), (f32(bitcast<i32>(_e1322)) * _e150)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2091_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1614 = phi_2091_;
                                                let _e1630 = (_e1614[0][2] - _e467);
                                                let _e1633 = (((_e1614[0][0] - _e334) * _e503) - (_e1630 * _e371));
                                                let _e1636 = (((_e1614[0][1] - _e401) * _e503) - (_e1630 * _e437));
                                                let _e1639 = (_e1614[1][2] - _e467);
                                                let _e1642 = (((_e1614[1][0] - _e334) * _e503) - (_e1639 * _e371));
                                                let _e1645 = (((_e1614[1][1] - _e401) * _e503) - (_e1639 * _e437));
                                                let _e1648 = (_e1614[2][2] - _e467);
                                                let _e1651 = (((_e1614[2][0] - _e334) * _e503) - (_e1648 * _e371));
                                                let _e1654 = (((_e1614[2][1] - _e401) * _e503) - (_e1648 * _e437));
                                                let _e1655 = (_e1651 * _e1645);
                                                let _e1656 = (_e1654 * _e1642);
                                                let _e1657 = (_e1633 * _e1654);
                                                let _e1658 = (_e1636 * _e1651);
                                                let _e1659 = (_e1642 * _e1636);
                                                let _e1660 = (_e1645 * _e1633);
                                                let _e1665 = (((_e1655 >= _e1656) && (_e1657 >= _e1658)) && (_e1659 >= _e1660));
                                                let _e1671 = (_e1665 || (((_e1655 <= _e1656) && (_e1657 <= _e1658)) && (_e1659 <= _e1660)));
                                                if _e1671 {
                                                    let _e1673 = select(-1f, 1f, _e1665);
                                                    let _e1675 = ((_e1655 - _e1656) * _e1673);
                                                    let _e1677 = select(0f, _e1675, (_e1675 > 0f));
                                                    let _e1679 = ((_e1657 - _e1658) * _e1673);
                                                    let _e1681 = select(0f, _e1679, (_e1679 > 0f));
                                                    let _e1683 = ((_e1659 - _e1660) * _e1673);
                                                    let _e1685 = select(0f, _e1683, (_e1683 > 0f));
                                                    let _e1687 = ((_e1677 + _e1681) + _e1685);
                                                    let _e1689 = select(_e1614[1][0], _e1614[0][0], (_e1614[0][0] < _e1614[1][0]));
                                                    let _e1693 = select(_e1614[1][0], _e1614[0][0], (_e1614[0][0] > _e1614[1][0]));
                                                    let _e1697 = select(_e1614[1][1], _e1614[0][1], (_e1614[0][1] < _e1614[1][1]));
                                                    let _e1701 = select(_e1614[1][1], _e1614[0][1], (_e1614[0][1] > _e1614[1][1]));
                                                    let _e1705 = select(_e1614[1][2], _e1614[0][2], (_e1614[0][2] < _e1614[1][2]));
                                                    let _e1709 = select(_e1614[1][2], _e1614[0][2], (_e1614[0][2] > _e1614[1][2]));
                                                    let _e1714 = ((select(_e1614[2][0], _e1689, (_e1689 < _e1614[2][0])) - _e372) * _e375);
                                                    let _e1715 = ((select(_e1614[2][0], _e1693, (_e1693 > _e1614[2][0])) - _e373) * _e375);
                                                    let _e1718 = ((select(_e1614[2][1], _e1697, (_e1697 < _e1614[2][1])) - _e438) * _e441);
                                                    let _e1719 = ((select(_e1614[2][1], _e1701, (_e1701 > _e1614[2][1])) - _e439) * _e441);
                                                    let _e1722 = ((select(_e1614[2][2], _e1705, (_e1705 < _e1614[2][2])) - _e504) * _e507);
                                                    let _e1723 = ((select(_e1614[2][2], _e1709, (_e1709 > _e1614[2][2])) - _e505) * _e507);
                                                    let _e1725 = select(_e1723, _e1722, (_e1722 < _e1723));
                                                    let _e1727 = select(_e1723, _e1722, (_e1722 > _e1723));
                                                    let _e1729 = select(_e1715, _e1714, (_e1714 < _e1715));
                                                    let _e1731 = select(_e1719, _e1718, (_e1718 < _e1719));
                                                    let _e1733 = select(_e1731, _e1729, (_e1729 > _e1731));
                                                    let _e1735 = select(_e1725, _e1733, (_e1733 > _e1725));
                                                    let _e1737 = select(_e1715, _e1714, (_e1714 > _e1715));
                                                    let _e1739 = select(_e1719, _e1718, (_e1718 > _e1719));
                                                    let _e1741 = select(_e1739, _e1737, (_e1737 < _e1739));
                                                    let _e1743 = select(_e1727, _e1741, (_e1741 < _e1727));
                                                    let _e1744 = -(_e1725);
                                                    let _e1750 = select(_e610, _e1735, (_e1735 > _e610));
                                                    let _e1754 = select(_e1642, _e1633, (_e1633 < _e1642));
                                                    let _e1759 = select(_e1642, _e1633, (_e1633 > _e1642));
                                                    let _e1766 = select(_e1645, _e1636, (_e1636 < _e1645));
                                                    let _e1771 = select(_e1645, _e1636, (_e1636 > _e1645));
                                                    let _e1780 = (((((_e1671 && (_e1687 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1651, _e1754, (_e1754 < _e1651)) <= 0f) && (select(_e1651, _e1759, (_e1759 > _e1651)) >= 0f))) && ((select(_e1654, _e1766, (_e1766 < _e1654)) <= 0f) && (select(_e1654, _e1771, (_e1771 > _e1654)) >= 0f))) && (_e1750 <= (_e1743 + (select(_e1744, _e1727, (_e1727 > _e1744)) * 0.0000019073523f)))) && (_e1750 <= _e1167.member_1));
                                                    if _e1780 {
                                                        let _e1785 = (_e1614[1][0] - _e1614[0][0]);
                                                        let _e1786 = (_e1614[1][1] - _e1614[0][1]);
                                                        let _e1787 = (_e1614[1][2] - _e1614[0][2]);
                                                        let _e1788 = vec3<f32>(_e1785, _e1786, _e1787);
                                                        let _e1789 = (_e1614[2][0] - _e1614[1][0]);
                                                        let _e1790 = (_e1614[2][1] - _e1614[1][1]);
                                                        let _e1791 = (_e1614[2][2] - _e1614[1][2]);
                                                        let _e1792 = vec3<f32>(_e1789, _e1790, _e1791);
                                                        let _e1793 = (_e1614[0][0] - _e1614[2][0]);
                                                        let _e1794 = (_e1614[0][1] - _e1614[2][1]);
                                                        let _e1795 = (_e1614[0][2] - _e1614[2][2]);
                                                        let _e1796 = vec3<f32>(_e1793, _e1794, _e1795);
                                                        let _e1799 = bitcast<f32>((bitcast<u32>(_e1785) & 2147483647u));
                                                        let _e1802 = bitcast<f32>((bitcast<u32>(_e1786) & 2147483647u));
                                                        let _e1804 = select(_e1802, _e1799, (_e1799 > _e1802));
                                                        let _e1807 = bitcast<f32>((bitcast<u32>(_e1787) & 2147483647u));
                                                        let _e1809 = select(_e1807, _e1804, (_e1804 > _e1807));
                                                        let _e1812 = bitcast<f32>((bitcast<u32>(_e1789) & 2147483647u));
                                                        let _e1815 = bitcast<f32>((bitcast<u32>(_e1790) & 2147483647u));
                                                        let _e1817 = select(_e1815, _e1812, (_e1812 > _e1815));
                                                        let _e1820 = bitcast<f32>((bitcast<u32>(_e1791) & 2147483647u));
                                                        let _e1822 = select(_e1820, _e1817, (_e1817 > _e1820));
                                                        let _e1825 = bitcast<f32>((bitcast<u32>(_e1793) & 2147483647u));
                                                        let _e1828 = bitcast<f32>((bitcast<u32>(_e1794) & 2147483647u));
                                                        let _e1830 = select(_e1828, _e1825, (_e1825 > _e1828));
                                                        let _e1833 = bitcast<f32>((bitcast<u32>(_e1795) & 2147483647u));
                                                        let _e1835 = select(_e1833, _e1830, (_e1830 > _e1833));
                                                        let _e1837 = select(_e1822, _e1809, (_e1809 > _e1822));
                                                        let _e1839 = select(_e1835, _e1837, (_e1837 > _e1835));
                                                        if (_e1809 == _e1839) {
                                                            phi_2621_ = _e1645;
                                                            phi_2622_ = _e1642;
                                                            phi_2623_ = _e1636;
                                                            phi_2624_ = _e1633;
                                                            phi_2625_ = vec3<f32>(_e1614[0][0], _e1614[0][1], _e1614[0][2]);
                                                            phi_2626_ = _e1796;
                                                            phi_2627_ = _e1792;
                                                            phi_2628_ = _e1788;
                                                        } else {
                                                            let _e1841 = (_e1822 == _e1839);
                                                            let _e1846 = vec3(_e1841);
                                                            phi_2621_ = select(_e1636, _e1654, _e1841);
                                                            phi_2622_ = select(_e1633, _e1651, _e1841);
                                                            phi_2623_ = select(_e1654, _e1645, _e1841);
                                                            phi_2624_ = select(_e1651, _e1642, _e1841);
                                                            phi_2625_ = select(vec3<f32>(_e1614[2][0], _e1614[2][1], _e1614[2][2]), vec3<f32>(_e1614[1][0], _e1614[1][1], _e1614[1][2]), _e1846);
                                                            phi_2626_ = select(_e1792, _e1788, _e1846);
                                                            phi_2627_ = select(_e1788, _e1796, _e1846);
                                                            phi_2628_ = select(_e1796, _e1792, _e1846);
                                                        }
                                                        let _e1852 = phi_2621_;
                                                        let _e1854 = phi_2622_;
                                                        let _e1856 = phi_2623_;
                                                        let _e1858 = phi_2624_;
                                                        let _e1860 = phi_2625_;
                                                        let _e1862 = phi_2626_;
                                                        let _e1864 = phi_2627_;
                                                        let _e1866 = phi_2628_;
                                                        let _e1873 = ((_e1864.y * _e1862.z) - (_e1862.y * _e1864.z));
                                                        let _e1878 = ((_e1864.z * _e1862.x) - (_e1862.z * _e1864.x));
                                                        let _e1881 = ((_e1864.x * _e1862.y) - (_e1862.x * _e1864.y));
                                                        let _e1884 = ((_e1677 >= _e1681) && (_e1677 >= _e1685));
                                                        let _e1885 = (_e1681 >= _e1685);
                                                        let _e1899 = (((_e1873 * (select(select(_e1614[2][0], _e1614[1][0], _e1885), _e1614[0][0], _e1884) - _e334)) + (_e1878 * (select(select(_e1614[2][1], _e1614[1][1], _e1885), _e1614[0][1], _e1884) - _e401))) + (_e1881 * (select(select(_e1614[2][2], _e1614[1][2], _e1885), _e1614[0][2], _e1884) - _e467)));
                                                        let _e1904 = (((_e1873 * _e371) + (_e1878 * _e437)) + (_e1881 * _e503));
                                                        let _e1905 = (_e1854 - _e1858);
                                                        let _e1906 = (_e1852 - _e1856);
                                                        let _e1909 = ((_e1905 * _e1905) + (_e1906 * _e1906));
                                                        let _e1916 = (-(((_e1858 * _e1905) + (_e1856 * _e1906))) / select(0.000000000000000000000000000000000000011754944f, _e1909, (_e1909 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1918 = select(1f, _e1916, (_e1916 < 1f));
                                                        let _e1920 = select(0f, _e1918, (_e1918 > 0f));
                                                        let _e1929 = ((_e1860.x + (_e1866.x * _e1920)) - _e334);
                                                        let _e1932 = ((_e1860.y + (_e1866.y * _e1920)) - _e401);
                                                        let _e1935 = ((_e1860.z + (_e1866.z * _e1920)) - _e467);
                                                        let _e1938 = bitcast<f32>((bitcast<u32>(_e1929) & 2147483647u));
                                                        let _e1941 = bitcast<f32>((bitcast<u32>(_e1932) & 2147483647u));
                                                        let _e1943 = select(_e1941, _e1938, (_e1938 > _e1941));
                                                        let _e1946 = bitcast<f32>((bitcast<u32>(_e1935) & 2147483647u));
                                                        let _e1948 = select(_e1946, _e1943, (_e1943 > _e1946));
                                                        let _e1954 = bitcast<f32>((bitcast<u32>(_e1873) & 2147483647u));
                                                        let _e1957 = bitcast<f32>((bitcast<u32>(_e1878) & 2147483647u));
                                                        let _e1959 = select(_e1957, _e1954, (_e1954 > _e1957));
                                                        let _e1962 = bitcast<f32>((bitcast<u32>(_e1881) & 2147483647u));
                                                        let _e1981 = bitcast<f32>((bitcast<u32>(_e1864.x) & 2147483647u));
                                                        let _e1984 = bitcast<f32>((bitcast<u32>(_e1864.y) & 2147483647u));
                                                        let _e1986 = select(_e1984, _e1981, (_e1981 > _e1984));
                                                        let _e1989 = bitcast<f32>((bitcast<u32>(_e1864.z) & 2147483647u));
                                                        let _e1995 = bitcast<f32>((bitcast<u32>(_e1862.x) & 2147483647u));
                                                        let _e1998 = bitcast<f32>((bitcast<u32>(_e1862.y) & 2147483647u));
                                                        let _e2000 = select(_e1998, _e1995, (_e1995 > _e1998));
                                                        let _e2003 = bitcast<f32>((bitcast<u32>(_e1862.z) & 2147483647u));
                                                        let _e2009 = ((bitcast<f32>((bitcast<u32>(((((_e1873 * _e1929) + (_e1878 * _e1932)) + (_e1881 * _e1935)) - _e1899)) & 2147483647u)) <= ((0.0000009536743f * select(_e1839, _e1948, (_e1948 > _e1839))) * select(_e1962, _e1959, (_e1959 > _e1962)))) && !((bitcast<f32>((bitcast<u32>(_e1904) & 2147483647u)) <= ((0.0000038146973f * select(_e1989, _e1986, (_e1986 > _e1989))) * select(_e2003, _e2000, (_e2000 > _e2003))))));
                                                        let _e2010 = (_e1899 / _e1904);
                                                        if (_e1780 && !(_e2009)) {
                                                            let _e2013 = (_e1935 / _e503);
                                                            let _e2021 = (((_e1873 * (_e1929 - (_e371 * _e2013))) + (_e1878 * (_e1932 - (_e437 * _e2013)))) / _e1904);
                                                            phi_2819_ = select(select(_e2013, (_e2013 + _e2021), (bitcast<f32>((bitcast<u32>(_e2021) & 2147483647u)) <= _e1839)), _e2010, _e2009);
                                                        } else {
                                                            phi_2819_ = _e2010;
                                                        }
                                                        let _e2030 = phi_2819_;
                                                        let _e2032 = select(_e1743, _e2030, (_e2030 < _e1743));
                                                        let _e2034 = select(_e1735, _e2032, (_e2032 > _e1735));
                                                        let _e2035 = (1f / _e1687);
                                                        phi_2839_ = type_40(_e2034, (_e1681 * _e2035), (_e1685 * _e2035), ((_e1780 && (_e2034 >= _e610)) && (_e2034 <= _e1167.member_1)));
                                                        phi_2840_ = type_40();
                                                    } else {
                                                        phi_2839_ = type_40();
                                                        phi_2840_ = type_40(0f, 0f, 0f, _e1780);
                                                    }
                                                    let _e2044 = phi_2839_;
                                                    let _e2046 = phi_2840_;
                                                    phi_2843_ = _e2044;
                                                    phi_2844_ = _e2046;
                                                    phi_2845_ = select(true, false, _e1780);
                                                } else {
                                                    phi_2843_ = type_40();
                                                    phi_2844_ = type_40(0f, 0f, 0f, _e1671);
                                                    phi_2845_ = true;
                                                }
                                                let _e2049 = phi_2843_;
                                                let _e2051 = phi_2844_;
                                                let _e2053 = phi_2845_;
                                                if _e2053 {
                                                    phi_2849_ = _e2051;
                                                } else {
                                                    phi_2849_ = _e2049;
                                                }
                                                let _e2055 = phi_2849_;
                                                if _e2055.member_3 {
                                                    phi_2858_ = type_24(_e2055.member, _e2055.member_1, _e2055.member_2, _e1227);
                                                } else {
                                                    phi_2858_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e2062 = phi_2858_;
                                                if (_e2062.member_3 != 4294967295u) {
                                                    if (_e1227 != 4294967295u) {
                                                        if (_e2062.member < _e1167.member.member) {
                                                            phi_2884_ = true;
                                                        } else {
                                                            if (_e2062.member == _e1167.member.member) {
                                                                phi_2883_ = (_e2062.member_3 < _e1167.member.member_3);
                                                            } else {
                                                                phi_2883_ = false;
                                                            }
                                                            let _e2075 = phi_2883_;
                                                            phi_2884_ = _e2075;
                                                        }
                                                        let _e2077 = phi_2884_;
                                                        if _e2077 {
                                                            phi_2890_ = type_37(_e2062, _e2062.member);
                                                        } else {
                                                            phi_2890_ = _e1167;
                                                        }
                                                        let _e2080 = phi_2890_;
                                                        phi_2891_ = _e2080;
                                                    } else {
                                                        phi_2891_ = _e1167;
                                                    }
                                                    let _e2082 = phi_2891_;
                                                    phi_2892_ = _e2082;
                                                } else {
                                                    phi_2892_ = _e1167;
                                                }
                                                let _e2084 = phi_2892_;
                                                phi_1328_ = _e2084;
                                            } else {
                                                phi_1328_ = type_37();
                                            }
                                            let _e2086 = phi_1328_;
                                            continue;
                                            continuing {
                                                phi_1327_ = _e2086;
                                                phi_1330_ = _e1182;
                                                phi_4668_ = _e652;
                                                break if !(_e1188);
                                            }
                                        }
                                        let _e2089 = phi_4668_;
                                        phi_4868_ = _e2089;
                                        if _e2089 {
                                            break;
                                        }
                                        let _e2091 = local_10;
                                        phi_4872_ = _e2089;
                                        let _e2397 = local_12;
                                        phi_4154_ = _e2397;
                                        phi_4155_ = false;
                                        phi_4156_ = _e695;
                                        phi_4157_ = select(_e697, 0u, (_e610 > _e2091.member_1));
                                    } else {
                                        if (_e695.member_1 >= _e99) {
                                            phi_3693_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e695.member_1 < _e99) {
                                            } else {
                                                phi_4868_ = true;
                                                break;
                                            }
                                            let _e710 = ((1u + _e270) % 4u);
                                            if (_e710 < 4u) {
                                            } else {
                                                phi_4868_ = true;
                                                break;
                                            }
                                            let _e715 = global_3.member[_e695.member_1][_e710];
                                            let _e717 = (_e715 >> bitcast<u32>(11u));
                                            let _e719 = ((1u + _e269) % 4u);
                                            if (_e719 < 4u) {
                                            } else {
                                                phi_4868_ = true;
                                                break;
                                            }
                                            let _e724 = global_3.member[_e695.member_1][_e719];
                                            let _e726 = (_e724 >> bitcast<u32>(11u));
                                            let _e728 = ((1u + _e271) % 4u);
                                            if (_e728 < 4u) {
                                            } else {
                                                phi_4868_ = true;
                                                break;
                                            }
                                            let _e733 = global_3.member[_e695.member_1][_e728];
                                            let _e735 = (_e733 >> bitcast<u32>(11u));
                                            let _e758 = (bitcast<f32>((bitcast<u32>((_e695.member.member_1.x - _e695.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e759 = (bitcast<f32>((bitcast<u32>((_e695.member.member_1.y - _e695.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e760 = (bitcast<f32>((bitcast<u32>((_e695.member.member_1.z - _e695.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e762 = select(_e150, _e758, (_e758 > _e150));
                                            let _e764 = select(_e150, _e759, (_e759 > _e150));
                                            let _e766 = select(_e150, _e760, (_e760 > _e150));
                                            let _e797 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e715 & 1023u))) - 8388608f) * _e762));
                                            let _e802 = (bitcast<i32>((_e715 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e805 = bitcast<f32>((_e797 & bitcast<u32>(_e802)));
                                            let _e806 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e724 & 1023u))) - 8388608f) * _e764));
                                            let _e811 = (bitcast<i32>((_e724 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e814 = bitcast<f32>((_e806 & bitcast<u32>(_e811)));
                                            let _e815 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e733 & 1023u))) - 8388608f) * _e766));
                                            let _e820 = (bitcast<i32>((_e733 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e823 = bitcast<f32>((_e815 & bitcast<u32>(_e820)));
                                            let _e827 = bitcast<f32>((_e797 & bitcast<u32>(~(_e802))));
                                            let _e831 = bitcast<f32>((_e806 & bitcast<u32>(~(_e811))));
                                            let _e835 = bitcast<f32>((_e815 & bitcast<u32>(~(_e820))));
                                            let _e836 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e717 & 1023u))) - 8388608f) * _e762));
                                            let _e841 = (bitcast<i32>((_e717 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e844 = bitcast<f32>((_e836 & bitcast<u32>(_e841)));
                                            let _e845 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e726 & 1023u))) - 8388608f) * _e764));
                                            let _e850 = (bitcast<i32>((_e726 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e853 = bitcast<f32>((_e845 & bitcast<u32>(_e850)));
                                            let _e854 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e735 & 1023u))) - 8388608f) * _e766));
                                            let _e859 = (bitcast<i32>((_e735 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e862 = bitcast<f32>((_e854 & bitcast<u32>(_e859)));
                                            let _e866 = bitcast<f32>((_e836 & bitcast<u32>(~(_e841))));
                                            let _e870 = bitcast<f32>((_e845 & bitcast<u32>(~(_e850))));
                                            let _e874 = bitcast<f32>((_e854 & bitcast<u32>(~(_e859))));
                                            let _e875 = (_e695.member.member.x + _e805);
                                            let _e876 = (_e695.member.member.y + _e814);
                                            let _e877 = (_e695.member.member.z + _e823);
                                            let _e880 = (_e695.member.member_1.x - _e844);
                                            let _e881 = (_e695.member.member_1.y - _e853);
                                            let _e882 = (_e695.member.member_1.z - _e862);
                                            let _e901 = (_e880 - _e875);
                                            let _e902 = (_e881 - _e876);
                                            let _e903 = (_e882 - _e877);
                                            let _e905 = select(_e902, _e901, (_e901 > _e902));
                                            let _e907 = select(_e903, _e905, (_e905 > _e903));
                                            if (_e907 < (1024f * _e150)) {
                                                phi_3394_ = 0u;
                                            } else {
                                                phi_3394_ = select(2u, 1u, (_e907 < (2097152f * _e150)));
                                            }
                                            let _e914 = phi_3394_;
                                            switch bitcast<i32>(_e914) {
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
                                            let _e917 = phi_3400_;
                                            let _e923 = global_3.member[_e695.member_1][0u];
                                            let _e927 = global_3.member[_e695.member_1][1u];
                                            let _e931 = global_3.member[_e695.member_1][2u];
                                            let _e935 = global_3.member[_e695.member_1][3u];
                                            let _e947 = (((_e927 >> bitcast<u32>(22i)) | ((_e931 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e935 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e948 = (_e923 & 268435455u);
                                            let _e949 = (_e947 & 268435455u);
                                            let _e952 = ((_e923 >> bitcast<u32>(28u)) & 7u);
                                            let _e960 = ((_e923 >> bitcast<u32>(31i)) | (((_e947 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e961 = (_e952 != 0u);
                                            if (_e952 == 0u) {
                                                phi_3655_ = _e948;
                                            } else {
                                                if (_e952 == 7u) {
                                                    phi_3654_ = 2147483648u;
                                                } else {
                                                    phi_3654_ = ((2147483648u | (_e952 << bitcast<u32>(28u))) | (_e949 & 268435455u));
                                                }
                                                let _e970 = phi_3654_;
                                                phi_3655_ = _e970;
                                            }
                                            let _e972 = phi_3655_;
                                            if _e961 {
                                                let _e973 = (_e952 != 7u);
                                                if _e973 {
                                                    phi_3665_ = (_e949 + (_e952 * ((3u * _e917) + 1u)));
                                                } else {
                                                    phi_3665_ = u32();
                                                }
                                                let _e977 = phi_3665_;
                                                phi_3667_ = _e977;
                                                phi_3668_ = select(true, false, _e973);
                                            } else {
                                                phi_3667_ = u32();
                                                phi_3668_ = true;
                                            }
                                            let _e980 = phi_3667_;
                                            let _e982 = phi_3668_;
                                            if (_e960 == 0u) {
                                                phi_3689_ = (_e948 + select(0u, 1u, !(_e961)));
                                            } else {
                                                if (_e960 == 7u) {
                                                    phi_3688_ = 2147483648u;
                                                } else {
                                                    phi_3688_ = ((2147483648u | (_e960 << bitcast<u32>(28u))) | (select(_e980, _e949, _e982) & 268435455u));
                                                }
                                                let _e995 = phi_3688_;
                                                phi_3689_ = _e995;
                                            }
                                            let _e997 = phi_3689_;
                                            phi_3693_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e875, (_e695.member.member.x + _e827), _e880, (_e695.member.member_1.x - _e866)), vec4<f32>(_e876, (_e695.member.member.y + _e831), _e881, (_e695.member.member_1.y - _e870)), vec4<f32>(_e877, (_e695.member.member.z + _e835), _e882, (_e695.member.member_1.z - _e874))), type_50(type_32((_e695.member.member + vec4<f32>(_e805, _e814, _e823, 0f)), (_e695.member.member_1 - vec4<f32>(_e844, _e853, _e862, 0f))), _e972), type_50(type_32((_e695.member.member + vec4<f32>(_e827, _e831, _e835, 0f)), (_e695.member.member_1 - vec4<f32>(_e866, _e870, _e874, 0f))), _e997));
                                        }
                                        let _e1002 = phi_3693_;
                                        let _e1014 = ((_e1002.member[0].x - _e372) * _e375);
                                        let _e1015 = ((_e1002.member[0].y - _e372) * _e375);
                                        let _e1016 = ((_e1002.member[0].z - _e373) * _e375);
                                        let _e1017 = ((_e1002.member[0].w - _e373) * _e375);
                                        let _e1027 = ((_e1002.member[1].x - _e438) * _e441);
                                        let _e1028 = ((_e1002.member[1].y - _e438) * _e441);
                                        let _e1029 = ((_e1002.member[1].z - _e439) * _e441);
                                        let _e1030 = ((_e1002.member[1].w - _e439) * _e441);
                                        let _e1040 = ((_e1002.member[2].x - _e504) * _e507);
                                        let _e1041 = ((_e1002.member[2].y - _e504) * _e507);
                                        let _e1042 = ((_e1002.member[2].z - _e505) * _e507);
                                        let _e1043 = ((_e1002.member[2].w - _e505) * _e507);
                                        let _e1045 = select(_e1042, _e1040, (_e1040 < _e1042));
                                        let _e1047 = select(_e1043, _e1041, (_e1041 < _e1043));
                                        let _e1049 = select(_e1042, _e1040, (_e1040 > _e1042));
                                        let _e1051 = select(_e1043, _e1041, (_e1041 > _e1043));
                                        let _e1053 = select(_e1016, _e1014, (_e1014 < _e1016));
                                        let _e1055 = select(_e1017, _e1015, (_e1015 < _e1017));
                                        let _e1057 = select(_e1029, _e1027, (_e1027 < _e1029));
                                        let _e1059 = select(_e1030, _e1028, (_e1028 < _e1030));
                                        let _e1061 = select(_e1057, _e1053, (_e1053 > _e1057));
                                        let _e1063 = select(_e1059, _e1055, (_e1055 > _e1059));
                                        let _e1065 = select(_e1045, _e1061, (_e1061 > _e1045));
                                        let _e1067 = select(_e1047, _e1063, (_e1063 > _e1047));
                                        let _e1069 = select(_e1016, _e1014, (_e1014 > _e1016));
                                        let _e1071 = select(_e1017, _e1015, (_e1015 > _e1017));
                                        let _e1073 = select(_e1029, _e1027, (_e1027 > _e1029));
                                        let _e1075 = select(_e1030, _e1028, (_e1028 > _e1030));
                                        let _e1077 = select(_e1073, _e1069, (_e1069 < _e1073));
                                        let _e1079 = select(_e1075, _e1071, (_e1071 < _e1075));
                                        let _e1084 = -(_e1045);
                                        let _e1085 = -(_e1047);
                                        let _e1092 = (select(_e1049, _e1077, (_e1077 < _e1049)) + (select(_e1084, _e1049, (_e1049 > _e1084)) * 0.0000019073523f));
                                        let _e1093 = (select(_e1051, _e1079, (_e1079 < _e1051)) + (select(_e1085, _e1051, (_e1051 > _e1085)) * 0.0000019073523f));
                                        let _e1095 = select(_e610, _e1065, (_e1065 > _e610));
                                        let _e1097 = select(_e610, _e1067, (_e1067 > _e610));
                                        let _e1102 = (_e1095 <= select(_e654.member_1, _e1092, (_e1092 < _e654.member_1)));
                                        let _e1103 = (_e1097 <= select(_e654.member_1, _e1093, (_e1093 < _e654.member_1)));
                                        let _e1104 = (_e1095 <= _e1097);
                                        if _e1102 {
                                            if _e1103 {
                                                if _e1104 {
                                                    phi_4055_ = _e1002.member_2;
                                                } else {
                                                    phi_4055_ = _e1002.member_1;
                                                }
                                                let _e1108 = phi_4055_;
                                                let _e1129 = (_e697 % 128u);
                                                let _e1130 = (_e1129 < 128u);
                                                if _e1130 {
                                                } else {
                                                    phi_4868_ = true;
                                                    break;
                                                }
                                                local_8[_e1129] = _e1108.member_1;
                                                if _e1130 {
                                                } else {
                                                    phi_4868_ = true;
                                                    break;
                                                }
                                                local_7[_e1129] = _e1108.member.member.x;
                                                if _e1130 {
                                                } else {
                                                    phi_4868_ = true;
                                                    break;
                                                }
                                                local_6[_e1129] = _e1108.member.member.y;
                                                if _e1130 {
                                                } else {
                                                    phi_4868_ = true;
                                                    break;
                                                }
                                                local_5[_e1129] = _e1108.member.member.z;
                                                if _e1130 {
                                                } else {
                                                    phi_4868_ = true;
                                                    break;
                                                }
                                                local_4[_e1129] = _e1108.member.member_1.x;
                                                if _e1130 {
                                                } else {
                                                    phi_4868_ = true;
                                                    break;
                                                }
                                                local_3[_e1129] = _e1108.member.member_1.y;
                                                if _e1130 {
                                                } else {
                                                    phi_4868_ = true;
                                                    break;
                                                }
                                                local_2[_e1129] = _e1108.member.member_1.z;
                                                if _e1130 {
                                                } else {
                                                    phi_4868_ = true;
                                                    break;
                                                }
                                                local_9[_e1129] = select(_e1095, _e1097, _e1104);
                                                if _e1104 {
                                                    phi_4131_ = _e1002.member_1;
                                                } else {
                                                    phi_4131_ = _e1002.member_2;
                                                }
                                                let _e1143 = phi_4131_;
                                                phi_4132_ = _e1143;
                                                phi_4133_ = (_e697 + 1u);
                                            } else {
                                                phi_4132_ = type_50();
                                                phi_4133_ = u32();
                                            }
                                            let _e1145 = phi_4132_;
                                            let _e1147 = phi_4133_;
                                            phi_4135_ = _e1145;
                                            phi_4136_ = _e1147;
                                            phi_4137_ = select(true, false, _e1103);
                                        } else {
                                            phi_4135_ = type_50();
                                            phi_4136_ = u32();
                                            phi_4137_ = true;
                                        }
                                        let _e1150 = phi_4135_;
                                        let _e1152 = phi_4136_;
                                        let _e1154 = phi_4137_;
                                        if _e1154 {
                                            if _e1102 {
                                                phi_4146_ = _e1002.member_1;
                                            } else {
                                                phi_4146_ = _e1002.member_2;
                                            }
                                            let _e1158 = phi_4146_;
                                            phi_4151_ = select(_e1103, true, _e1102);
                                            phi_4152_ = _e1158;
                                        } else {
                                            phi_4151_ = _e693;
                                            phi_4152_ = _e1150;
                                        }
                                        let _e1161 = phi_4151_;
                                        let _e1163 = phi_4152_;
                                        phi_4872_ = _e652;
                                        phi_4154_ = _e654;
                                        phi_4155_ = _e1161;
                                        phi_4156_ = _e1163;
                                        phi_4157_ = select(_e1152, _e697, _e1154);
                                    }
                                    let _e2096 = phi_4872_;
                                    let _e2098 = phi_4154_;
                                    let _e2100 = phi_4155_;
                                    let _e2102 = phi_4156_;
                                    let _e2104 = phi_4157_;
                                    phi_4871_ = _e2096;
                                    phi_4158_ = _e2098;
                                    phi_4159_ = _e2100;
                                    phi_4160_ = _e2102;
                                    phi_4161_ = _e2104;
                                    phi_4162_ = (_e662 - 1u);
                                } else {
                                    phi_4871_ = _e652;
                                    phi_4158_ = _e654;
                                    phi_4159_ = _e693;
                                    phi_4160_ = _e695;
                                    phi_4161_ = _e697;
                                    phi_4162_ = _e662;
                                }
                                let _e2106 = phi_4871_;
                                let _e2108 = phi_4158_;
                                let _e2110 = phi_4159_;
                                let _e2112 = phi_4160_;
                                let _e2114 = phi_4161_;
                                let _e2116 = phi_4162_;
                                phi_4870_ = _e2106;
                                phi_4163_ = _e2108;
                                phi_4164_ = _e2110;
                                phi_4165_ = _e2112;
                                phi_4166_ = _e2114;
                                phi_4167_ = _e2116;
                            } else {
                                phi_4870_ = _e652;
                                phi_4163_ = type_37();
                                phi_4164_ = bool();
                                phi_4165_ = type_50();
                                phi_4166_ = u32();
                                phi_4167_ = u32();
                            }
                            let _e2118 = phi_4870_;
                            let _e2120 = phi_4163_;
                            let _e2122 = phi_4164_;
                            let _e2124 = phi_4165_;
                            let _e2126 = phi_4166_;
                            let _e2128 = phi_4167_;
                            phi_4869_ = _e2118;
                            phi_1201_ = _e2120;
                            phi_1204_ = _e2122;
                            phi_1206_ = _e2124;
                            phi_1208_ = _e2126;
                            phi_1210_ = _e2128;
                            phi_4168_ = _e666;
                        } else {
                            phi_4869_ = _e652;
                            phi_1201_ = type_37();
                            phi_1204_ = bool();
                            phi_1206_ = type_50();
                            phi_1208_ = u32();
                            phi_1210_ = u32();
                            phi_4168_ = false;
                        }
                        let _e2130 = phi_4869_;
                        let _e2132 = phi_1201_;
                        let _e2134 = phi_1204_;
                        let _e2136 = phi_1206_;
                        let _e2138 = phi_1208_;
                        let _e2140 = phi_1210_;
                        let _e2142 = phi_4168_;
                        continue;
                        continuing {
                            phi_4674_ = _e2130;
                            phi_1200_ = _e2132;
                            phi_1203_ = _e2134;
                            phi_1205_ = _e2136;
                            phi_1207_ = _e2138;
                            phi_1209_ = _e2140;
                            phi_4868_ = _e2130;
                            break if !(_e2142);
                        }
                    }
                    let _e2145 = phi_4868_;
                    if _e2145 {
                        break;
                    }
                    let _e2147 = local_11;
                    if (_e2147.member.member_3 != 4294967295u) {
                        let _e2152 = -(_e512);
                        let _e2153 = bitcast<u32>(_e2147.member.member);
                        let _e2157 = (bitcast<i32>((_e2153 >> bitcast<u32>(23i))) & 255i);
                        let _e2158 = (_e2157 + _e2152);
                        if (_e2157 == 255i) {
                            phi_4227_ = _e2147.member.member;
                        } else {
                            if (_e2157 > 0i) {
                                if (_e2158 > 0i) {
                                    let _e2162 = (_e2158 < 255i);
                                    if _e2162 {
                                        phi_4206_ = bitcast<f32>((_e2153 + bitcast<u32>((_e2152 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4206_ = f32();
                                    }
                                    let _e2169 = phi_4206_;
                                    phi_4208_ = _e2169;
                                    phi_4209_ = select(true, false, _e2162);
                                } else {
                                    phi_4208_ = f32();
                                    phi_4209_ = true;
                                }
                                let _e2172 = phi_4208_;
                                let _e2174 = phi_4209_;
                                phi_4210_ = _e2172;
                                phi_4211_ = _e2174;
                            } else {
                                phi_4210_ = f32();
                                phi_4211_ = true;
                            }
                            let _e2176 = phi_4210_;
                            let _e2178 = phi_4211_;
                            if _e2178 {
                                let _e2179 = (_e2153 & 2147483648u);
                                let _e2186 = ((_e2153 & 8388607u) | (select(0u, 1u, ((_e2153 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2190 = (_e2186 == 0u);
                                if _e2190 {
                                    phi_4626_ = bitcast<f32>(_e2179);
                                } else {
                                    let _e2195 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2186)), 32u, _e2190) - 8u);
                                    let _e2198 = (_e2186 << bitcast<u32>((_e2195 & 31u)));
                                    let _e2200 = ((_e2158 + select(0i, 1i, (_e2157 == 0i))) - bitcast<i32>(_e2195));
                                    if (_e2200 >= 255i) {
                                        phi_4616_ = bitcast<f32>((_e2179 | 2139095040u));
                                        phi_4617_ = f32();
                                        phi_4618_ = true;
                                    } else {
                                        let _e2202 = (_e2200 > 0i);
                                        if _e2202 {
                                            phi_4610_ = bitcast<f32>(((_e2179 | (bitcast<u32>(_e2200) << bitcast<u32>(23i))) | (_e2198 & 8388607u)));
                                            phi_4611_ = f32();
                                        } else {
                                            if (_e2200 < -24i) {
                                                phi_4576_ = 26u;
                                            } else {
                                                phi_4576_ = bitcast<u32>((1i - _e2200));
                                            }
                                            let _e2207 = phi_4576_;
                                            let _e2208 = (_e2207 & 31u);
                                            let _e2210 = (_e2198 >> bitcast<u32>(_e2208));
                                            let _e2214 = (_e2198 & ((1u << bitcast<u32>(_e2208)) - 1u));
                                            let _e2218 = (1u << bitcast<u32>(((_e2207 - 1u) & 31u)));
                                            if (_e2214 > _e2218) {
                                                phi_4597_ = true;
                                            } else {
                                                if (_e2214 == _e2218) {
                                                    phi_4594_ = ((_e2210 & 1u) == 1u);
                                                } else {
                                                    phi_4594_ = false;
                                                }
                                                let _e2224 = phi_4594_;
                                                phi_4597_ = _e2224;
                                            }
                                            let _e2226 = phi_4597_;
                                            phi_4610_ = f32();
                                            phi_4611_ = bitcast<f32>((_e2179 | (_e2210 + select(0u, 1u, _e2226))));
                                        }
                                        let _e2239 = phi_4610_;
                                        let _e2241 = phi_4611_;
                                        phi_4616_ = _e2239;
                                        phi_4617_ = _e2241;
                                        phi_4618_ = _e2202;
                                    }
                                    let _e2245 = phi_4616_;
                                    let _e2247 = phi_4617_;
                                    let _e2249 = phi_4618_;
                                    phi_4626_ = select(_e2247, _e2245, _e2249);
                                }
                                let _e2253 = phi_4626_;
                                phi_4226_ = _e2253;
                            } else {
                                phi_4226_ = _e2176;
                            }
                            let _e2255 = phi_4226_;
                            phi_4227_ = _e2255;
                        }
                        let _e2257 = phi_4227_;
                        let _e2258 = bitcast<u32>(_e2257);
                        if ((_e2258 & 2147483647u) >= 2139095040u) {
                            phi_4239_ = bitcast<f32>(((_e2258 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4239_ = _e2257;
                        }
                        let _e2265 = phi_4239_;
                        phi_4244_ = type_24(_e2265, _e2147.member.member_1, _e2147.member.member_2, _e2147.member.member_3);
                    } else {
                        phi_4244_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2270 = phi_4244_;
                    if _e158 {
                    } else {
                        break;
                    }
                    global_6.member[_e156] = _e2270;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
