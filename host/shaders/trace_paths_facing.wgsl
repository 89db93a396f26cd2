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

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_32 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_33 {
    member: type_32,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_35 {
    member: array<type_33>,
}

struct type_40 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_46 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_49 {
    member: type_28,
    member_1: f32,
}

struct type_53 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_55 {
    member: array<vec4<u32>, 2>,
}

struct type_58 {
    member: array<i32>,
}

struct type_66 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_55;
@group(0) @binding(2) 
var<storage> global_3: type_42;
@group(0) @binding(3) 
var<storage> global_4: type_20;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage> global_6: type_58;
@group(0) @binding(6) 
var<storage> global_7: type_35;
@group(0) @binding(7) 
var<storage, read_write> global_8: type_30;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_66;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_270_: type_46;
    var phi_380_: i32;
    var phi_381_: i32;
    var phi_391_: bool;
    var phi_401_: u32;
    var phi_402_: u32;
    var phi_404_: bool;
    var phi_409_: u32;
    var phi_453_: f32;
    var phi_459_: f32;
    var phi_470_: f32;
    var phi_476_: f32;
    var phi_499_: f32;
    var phi_510_: f32;
    var phi_519_: f32;
    var phi_525_: f32;
    var phi_536_: f32;
    var phi_542_: f32;
    var phi_565_: f32;
    var phi_576_: f32;
    var phi_585_: f32;
    var phi_591_: f32;
    var phi_602_: f32;
    var phi_608_: f32;
    var phi_631_: f32;
    var phi_642_: f32;
    var phi_742_: f32;
    var phi_743_: f32;
    var phi_2779_: bool;
    var phi_1017_: type_49;
    var phi_1020_: u32;
    var phi_1022_: u32;
    var phi_1024_: bool;
    var phi_1026_: u32;
    var phi_1037_: bool;
    var phi_1068_: u32;
    var phi_1069_: bool;
    var phi_1070_: u32;
    var phi_2214_: type_53;
    var phi_2558_: u32;
    var phi_2585_: u32;
    var phi_2586_: u32;
    var phi_2587_: u32;
    var phi_2589_: u32;
    var phi_2590_: u32;
    var phi_2591_: bool;
    var phi_2600_: u32;
    var phi_2605_: u32;
    var phi_2606_: bool;
    var phi_1085_: type_49;
    var phi_1088_: type_8;
    var phi_1089_: type_8;
    var phi_1111_: type_8;
    var phi_1132_: u32;
    var phi_1221_: array<array<f32, 3>, 3>;
    var phi_1692_: vec3<f32>;
    var phi_1693_: vec3<f32>;
    var phi_1724_: bool;
    var phi_1733_: vec3<f32>;
    var phi_1773_: type_28;
    var phi_1775_: type_28;
    var phi_1776_: bool;
    var phi_1780_: type_28;
    var phi_1781_: type_28;
    var phi_1782_: type_28;
    var phi_1783_: bool;
    var phi_1787_: type_28;
    var phi_1788_: bool;
    var phi_1792_: type_28;
    var phi_1793_: bool;
    var phi_1797_: type_28;
    var phi_1820_: u32;
    var phi_1834_: i32;
    var phi_1854_: vec3<f32>;
    var phi_1855_: vec3<f32>;
    var phi_1871_: vec3<f32>;
    var phi_1872_: vec3<f32>;
    var phi_1888_: vec3<f32>;
    var phi_1889_: vec3<f32>;
    var phi_1925_: vec3<f32>;
    var phi_2107_: f32;
    var phi_2125_: bool;
    var phi_2126_: bool;
    var phi_2145_: bool;
    var phi_2146_: bool;
    var phi_2152_: type_49;
    var phi_2153_: type_49;
    var phi_2154_: type_49;
    var phi_1086_: type_49;
    var phi_2773_: bool;
    var phi_2908_: bool;
    var phi_2608_: type_49;
    var phi_2609_: u32;
    var phi_2610_: bool;
    var phi_2611_: u32;
    var phi_2907_: bool;
    var phi_2612_: type_49;
    var phi_2613_: u32;
    var phi_2614_: u32;
    var phi_2615_: bool;
    var phi_2616_: u32;
    var phi_2906_: bool;
    var phi_2617_: type_49;
    var phi_2618_: u32;
    var phi_2619_: u32;
    var phi_2620_: bool;
    var phi_2621_: u32;
    var phi_2905_: bool;
    var phi_1018_: type_49;
    var phi_1021_: u32;
    var phi_1023_: u32;
    var phi_1025_: bool;
    var phi_1027_: u32;
    var phi_2622_: bool;
    var phi_2904_: bool;
    var local_2: type_49;
    var phi_2674_: type_28;
    var local_3: type_49;

    switch bitcast<i32>(0u) {
        default: {
            let _e72 = global;
            let _e74 = arrayLength((&global_3.member));
            let _e76 = arrayLength((&global_4.member));
            let _e88 = arrayLength((&global_9.member));
            let _e92 = (_e72.x + (_e72.y * 2097152u));
            let _e93 = (_e92 < arrayLength((&global_7.member)));
            if _e93 {
                let _e94 = (_e92 < arrayLength((&global_8.member)));
                if _e94 {
                    let _e97 = global_1.member[0u];
                    let _e101 = global_2.member[0u][0u];
                    let _e105 = global_2.member[0u][1u];
                    let _e109 = global_2.member[0u][2u];
                    let _e113 = global_2.member[0u][3u];
                    let _e117 = global_2.member[1u][0u];
                    let _e121 = global_2.member[1u][1u];
                    let _e125 = global_2.member[1u][2u];
                    let _e129 = global_2.member[1u][3u];
                    let _e130 = bitcast<f32>(_e101);
                    let _e131 = bitcast<f32>(_e105);
                    let _e132 = bitcast<f32>(_e109);
                    let _e134 = bitcast<f32>(_e117);
                    let _e135 = array<u32, 3>(_e121, _e125, _e129);
                    let _e137 = bitcast<i32>(_e97);
                    let _e138 = (_e137 / 2i);
                    let _e143 = bitcast<f32>((bitcast<u32>((_e138 + 127i)) << bitcast<u32>(23i)));
                    let _e149 = bitcast<f32>((bitcast<u32>(((_e137 - _e138) + 127i)) << bitcast<u32>(23i)));
                    if (_e113 == 0u) {
                        phi_270_ = type_46(array<f32, 3>(_e130, _e131, _e132), _e113, _e134, _e135);
                    } else {
                        phi_270_ = type_46(array<f32, 3>(((_e130 * _e143) * _e149), ((_e131 * _e143) * _e149), ((_e132 * _e143) * _e149)), _e113, ((_e134 * _e143) * _e149), _e135);
                    }
                    let _e162 = phi_270_;
                    if _e93 {
                    } else {
                        break;
                    }
                    if _e93 {
                    } else {
                        break;
                    }
                    let _e166 = global_7.member[_e92].member_2;
                    let _e176 = global_7.member[_e92].member.member_2[0u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e184 = global_7.member[_e92].member.member_2[1u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e192 = global_7.member[_e92].member.member_2[2u];
                    let _e194 = (bitcast<u32>(_e192) & 2147483647u);
                    let _e200 = global_7.member[_e92].member.member[0u];
                    let _e202 = (bitcast<u32>(_e200) & 2147483647u);
                    let _e208 = global_7.member[_e92].member.member[1u];
                    let _e210 = (bitcast<u32>(_e208) & 2147483647u);
                    let _e216 = global_7.member[_e92].member.member[2u];
                    let _e218 = (bitcast<u32>(_e216) & 2147483647u);
                    let _e220 = select(_e186, _e178, (_e186 < _e178));
                    let _e222 = select(_e194, _e220, (_e194 < _e220));
                    let _e224 = select(_e202, _e222, (_e202 < _e222));
                    let _e226 = select(_e210, _e224, (_e210 < _e224));
                    let _e228 = select(_e218, _e226, (_e218 < _e226));
                    let _e233 = global_7.member[_e92].member.member_1;
                    let _e235 = (bitcast<u32>(_e233) & 2147483647u);
                    let _e243 = global_7.member[_e92].member.member_3;
                    let _e249 = (((select(_e235, _e228, (_e235 < _e228)) < 2139095040u) && ((bitcast<u32>(_e243) & 2147483647u) <= 2139095040u)) && (_e222 > 0u));
                    if _e249 {
                        let _e252 = (bitcast<u32>(bitcast<f32>(_e222)) & 2147483647u);
                        if (_e252 >= 8388608u) {
                            phi_380_ = (bitcast<i32>((_e252 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_380_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e252)), 32u, (_e252 == 0u))));
                        }
                        let _e266 = phi_380_;
                        phi_381_ = _e266;
                    } else {
                        phi_381_ = 0i;
                    }
                    let _e268 = phi_381_;
                    let _e269 = (_e178 == _e222);
                    if _e269 {
                        phi_391_ = true;
                    } else {
                        phi_391_ = (_e186 == _e222);
                    }
                    let _e272 = phi_391_;
                    let _e273 = select(1u, 0u, _e269);
                    if _e272 {
                        let _e274 = (_e273 + 1u);
                        phi_401_ = _e274;
                        phi_402_ = _e274;
                        phi_404_ = select(true, false, (_e274 == 2u));
                    } else {
                        phi_401_ = u32();
                        phi_402_ = 0u;
                        phi_404_ = true;
                    }
                    let _e278 = phi_401_;
                    let _e280 = phi_402_;
                    let _e282 = phi_404_;
                    if _e282 {
                        phi_409_ = (_e280 + 1u);
                    } else {
                        phi_409_ = 0u;
                    }
                    let _e286 = phi_409_;
                    let _e287 = select(_e278, _e280, _e282);
                    let _e288 = select(_e273, select(2u, _e273, _e272), _e282);
                    let _e289 = -(_e268);
                    let _e290 = (_e289 / 2i);
                    let _e295 = bitcast<f32>((bitcast<u32>((_e290 + 127i)) << bitcast<u32>(23i)));
                    let _e301 = bitcast<f32>((bitcast<u32>(((_e289 - _e290) + 127i)) << bitcast<u32>(23i)));
                    let _e306 = global_7.member[_e92].member.member;
                    let _e307 = (_e287 == 0u);
                    if _e307 {
                        phi_453_ = _e306[0];
                    } else {
                        phi_453_ = _e306[1];
                    }
                    let _e311 = phi_453_;
                    let _e312 = (_e287 == 2u);
                    if _e312 {
                        phi_459_ = _e306[2];
                    } else {
                        phi_459_ = _e311;
                    }
                    let _e315 = phi_459_;
                    let _e316 = global_7.member[_e92].member.member_2;
                    if _e307 {
                        phi_470_ = _e316[0];
                    } else {
                        phi_470_ = _e316[1];
                    }
                    let _e320 = phi_470_;
                    if _e312 {
                        phi_476_ = _e316[2];
                    } else {
                        phi_476_ = _e320;
                    }
                    let _e323 = phi_476_;
                    let _e325 = ((_e323 * _e295) * _e301);
                    let _e329 = (bitcast<f32>((bitcast<u32>(_e325) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e329 {
                        let _e333 = (bitcast<f32>((bitcast<u32>(_e315) & 2147483647u)) * 0.00000011920929f);
                        phi_499_ = select(0.00000000000011368684f, _e333, (_e333 > 0.00000000000011368684f));
                    } else {
                        phi_499_ = 0f;
                    }
                    let _e337 = phi_499_;
                    let _e338 = (_e315 + _e337);
                    let _e339 = (_e315 - _e337);
                    let _e340 = select(_e325, 0f, _e329);
                    if _e329 {
                        phi_510_ = 38685626000000000000000000f;
                    } else {
                        phi_510_ = (1f / _e325);
                    }
                    let _e343 = phi_510_;
                    let _e344 = (_e286 == 0u);
                    if _e344 {
                        phi_519_ = _e306[0];
                    } else {
                        phi_519_ = _e306[1];
                    }
                    let _e348 = phi_519_;
                    let _e349 = (_e286 == 2u);
                    if _e349 {
                        phi_525_ = _e306[2];
                    } else {
                        phi_525_ = _e348;
                    }
                    let _e352 = phi_525_;
                    if _e344 {
                        phi_536_ = _e316[0];
                    } else {
                        phi_536_ = _e316[1];
                    }
                    let _e356 = phi_536_;
                    if _e349 {
                        phi_542_ = _e316[2];
                    } else {
                        phi_542_ = _e356;
                    }
                    let _e359 = phi_542_;
                    let _e361 = ((_e359 * _e295) * _e301);
                    let _e365 = (bitcast<f32>((bitcast<u32>(_e361) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e365 {
                        let _e369 = (bitcast<f32>((bitcast<u32>(_e352) & 2147483647u)) * 0.00000011920929f);
                        phi_565_ = select(0.00000000000011368684f, _e369, (_e369 > 0.00000000000011368684f));
                    } else {
                        phi_565_ = 0f;
                    }
                    let _e373 = phi_565_;
                    let _e374 = (_e352 + _e373);
                    let _e375 = (_e352 - _e373);
                    let _e376 = select(_e361, 0f, _e365);
                    if _e365 {
                        phi_576_ = 38685626000000000000000000f;
                    } else {
                        phi_576_ = (1f / _e361);
                    }
                    let _e379 = phi_576_;
                    let _e380 = (_e288 == 0u);
                    if _e380 {
                        phi_585_ = _e306[0];
                    } else {
                        phi_585_ = _e306[1];
                    }
                    let _e384 = phi_585_;
                    let _e385 = (_e288 == 2u);
                    if _e385 {
                        phi_591_ = _e306[2];
                    } else {
                        phi_591_ = _e384;
                    }
                    let _e388 = phi_591_;
                    if _e380 {
                        phi_602_ = _e316[0];
                    } else {
                        phi_602_ = _e316[1];
                    }
                    let _e392 = phi_602_;
                    if _e385 {
                        phi_608_ = _e316[2];
                    } else {
                        phi_608_ = _e392;
                    }
                    let _e395 = phi_608_;
                    let _e397 = ((_e395 * _e295) * _e301);
                    let _e401 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e401 {
                        let _e405 = (bitcast<f32>((bitcast<u32>(_e388) & 2147483647u)) * 0.00000011920929f);
                        phi_631_ = select(0.00000000000011368684f, _e405, (_e405 > 0.00000000000011368684f));
                    } else {
                        phi_631_ = 0f;
                    }
                    let _e409 = phi_631_;
                    let _e410 = (_e388 + _e409);
                    let _e411 = (_e388 - _e409);
                    let _e412 = select(_e397, 0f, _e401);
                    if _e401 {
                        phi_642_ = 38685626000000000000000000f;
                    } else {
                        phi_642_ = (1f / _e397);
                    }
                    let _e415 = phi_642_;
                    let _e418 = bitcast<f32>((bitcast<u32>(_e315) & 2147483647u));
                    let _e421 = bitcast<f32>((bitcast<u32>(_e352) & 2147483647u));
                    let _e423 = select(_e421, _e418, (_e418 > _e421));
                    let _e426 = bitcast<f32>((bitcast<u32>(_e388) & 2147483647u));
                    if (_e249 && (select(_e426, _e423, (_e423 > _e426)) <= 1099511600000f)) {
                        let _e431 = (_e268 / 3i);
                        let _e438 = bitcast<f32>((bitcast<u32>((_e431 + 127i)) << bitcast<u32>(23i)));
                        let _e445 = bitcast<f32>((bitcast<u32>(((_e268 - (2i * _e431)) + 127i)) << bitcast<u32>(23i)));
                        let _e446 = (((_e233 * _e438) * _e438) * _e445);
                        let _e448 = select(340282350000000000000000000000000000000f, _e446, (_e446 < 340282350000000000000000000000000000000f));
                        let _e453 = (((_e243 * _e438) * _e438) * _e445);
                        let _e455 = select(340282350000000000000000000000000000000f, _e453, (_e453 < 340282350000000000000000000000000000000f));
                        phi_742_ = select(-340282350000000000000000000000000000000f, _e455, (_e455 > -340282350000000000000000000000000000000f));
                        phi_743_ = select(-340282350000000000000000000000000000000f, _e448, (_e448 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_742_ = 0f;
                        phi_743_ = 1f;
                    }
                    let _e459 = phi_742_;
                    let _e461 = phi_743_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2779_ = false;
                    phi_1017_ = type_49(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e459);
                    phi_1020_ = select(0u, 2147483648u, (_e74 == 0u));
                    phi_1022_ = ((3u * _e74) + 1u);
                    phi_1024_ = (_e461 <= _e459);
                    phi_1026_ = 0u;
                    loop {
                        let _e469 = phi_2779_;
                        let _e471 = phi_1017_;
                        let _e473 = phi_1020_;
                        let _e475 = phi_1022_;
                        let _e477 = phi_1024_;
                        let _e479 = phi_1026_;
                        local_2 = _e471;
                        if _e477 {
                            phi_1037_ = true;
                        } else {
                            phi_1037_ = (_e479 > 0u);
                        }
                        let _e482 = phi_1037_;
                        if _e482 {
                            let _e483 = (_e475 > 0u);
                            if _e483 {
                                if _e477 {
                                    phi_1068_ = _e473;
                                    phi_1069_ = _e477;
                                    phi_1070_ = _e479;
                                } else {
                                    let _e484 = (_e479 - 1u);
                                    let _e485 = (_e484 % 128u);
                                    let _e486 = (_e485 < 128u);
                                    if _e486 {
                                    } else {
                                        phi_2904_ = true;
                                        break;
                                    }
                                    let _e488 = local_1[_e485];
                                    if _e486 {
                                    } else {
                                        phi_2904_ = true;
                                        break;
                                    }
                                    let _e490 = local[_e485];
                                    phi_1068_ = _e488;
                                    phi_1069_ = (_e490 <= _e471.member_1);
                                    phi_1070_ = _e484;
                                }
                                let _e494 = phi_1068_;
                                let _e496 = phi_1069_;
                                let _e498 = phi_1070_;
                                if _e496 {
                                    if ((_e494 & 2147483648u) != 0u) {
                                        phi_1085_ = _e471;
                                        phi_1088_ = type_8(0u, ((_e494 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e696 = phi_1085_;
                                            let _e698 = phi_1088_;
                                            local_3 = _e696;
                                            if (_e698.member < _e698.member_1) {
                                                phi_1089_ = type_8((_e698.member + 1u), _e698.member_1);
                                                phi_1111_ = type_8(1u, _e698.member);
                                            } else {
                                                phi_1089_ = _e698;
                                                phi_1111_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e711 = phi_1089_;
                                            let _e713 = phi_1111_;
                                            let _e717 = (bitcast<i32>(_e713.member) != 0i);
                                            if _e717 {
                                                let _e718 = ((_e494 & 268435455u) + _e713.member_1);
                                                let _e719 = (_e718 < _e76);
                                                if _e719 {
                                                    if _e719 {
                                                    } else {
                                                        phi_2773_ = true;
                                                        break;
                                                    }
                                                    let _e723 = global_4.member[_e718].member_1;
                                                    phi_1132_ = _e723;
                                                } else {
                                                    phi_1132_ = 4294967295u;
                                                }
                                                let _e725 = phi_1132_;
                                                if (_e718 >= _e76) {
                                                    phi_1221_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e719 {
                                                    } else {
                                                        phi_2773_ = true;
                                                        break;
                                                    }
                                                    let _e727 = (_e287 % 3u);
                                                    let _e728 = (_e286 % 3u);
                                                    let _e729 = (_e288 % 3u);
                                                    if (_e727 < 9u) {
                                                    } else {
                                                        phi_2773_ = true;
                                                        break;
                                                    }
                                                    let _e735 = global_4.member[_e718].member[_e727];
                                                    if (_e728 < 9u) {
                                                    } else {
                                                        phi_2773_ = true;
                                                        break;
                                                    }
                                                    let _e741 = global_4.member[_e718].member[_e728];
                                                    if (_e729 < 9u) {
                                                    } else {
                                                        phi_2773_ = true;
                                                        break;
                                                    }
                                                    let _e747 = global_4.member[_e718].member[_e729];
                                                    let _e749 = (3u + _e727);
                                                    if (_e749 < 9u) {
                                                    } else {
                                                        phi_2773_ = true;
                                                        break;
                                                    }
                                                    let _e755 = global_4.member[_e718].member[_e749];
                                                    let _e756 = (3u + _e728);
                                                    if (_e756 < 9u) {
                                                    } else {
                                                        phi_2773_ = true;
                                                        break;
                                                    }
                                                    let _e762 = global_4.member[_e718].member[_e756];
                                                    let _e763 = (3u + _e729);
                                                    if (_e763 < 9u) {
                                                    } else {
                                                        phi_2773_ = true;
                                                        break;
                                                    }
                                                    let _e769 = global_4.member[_e718].member[_e763];
                                                    let _e771 = (6u + _e727);
                                                    if (_e771 < 9u) {
                                                    } else {
                                                        phi_2773_ = true;
                                                        break;
                                                    }
                                                    let _e777 = global_4.member[_e718].member[_e771];
                                                    let _e778 = (6u + _e728);
                                                    if (_e778 < 9u) {
                                                    } else {
                                                        phi_2773_ = true;
                                                        break;
                                                    }
                                                    let _e784 = global_4.member[_e718].member[_e778];
                                                    let _e785 = (6u + _e729);
                                                    if (_e785 < 9u) {
                                                    } else {
                                                        phi_2773_ = true;
                                                        break;
                                                    }
                                                    let _e791 = global_4.member[_e718].member[_e785];
                                                    phi_1221_ = array<array<f32, 3>, 3>(array<f32, 3>(_e735, _e741, _e747), array<f32, 3>(_e755, _e762, _e769), array<f32, 3>(_e777, _e784, _e791));
                                                }
                                                let _e795 = phi_1221_;
                                                let _e803 = (_e795[0][2] - _e388);
                                                let _e806 = (((_e795[0][0] - _e315) * _e412) - (_e803 * _e340));
                                                let _e809 = (((_e795[0][1] - _e352) * _e412) - (_e803 * _e376));
                                                let _e816 = (_e795[1][2] - _e388);
                                                let _e819 = (((_e795[1][0] - _e315) * _e412) - (_e816 * _e340));
                                                let _e822 = (((_e795[1][1] - _e352) * _e412) - (_e816 * _e376));
                                                let _e829 = (_e795[2][2] - _e388);
                                                let _e832 = (((_e795[2][0] - _e315) * _e412) - (_e829 * _e340));
                                                let _e835 = (((_e795[2][1] - _e352) * _e412) - (_e829 * _e376));
                                                let _e836 = (_e832 * _e822);
                                                let _e837 = (_e835 * _e819);
                                                let _e838 = (_e806 * _e835);
                                                let _e839 = (_e809 * _e832);
                                                let _e840 = (_e819 * _e809);
                                                let _e841 = (_e822 * _e806);
                                                let _e846 = (((_e836 >= _e837) && (_e838 >= _e839)) && (_e840 >= _e841));
                                                if (_e846 || (((_e836 <= _e837) && (_e838 <= _e839)) && (_e840 <= _e841))) {
                                                    let _e853 = select(-1f, 1f, _e846);
                                                    let _e855 = ((_e836 - _e837) * _e853);
                                                    let _e857 = select(0f, _e855, (_e855 > 0f));
                                                    let _e859 = ((_e838 - _e839) * _e853);
                                                    let _e861 = select(0f, _e859, (_e859 > 0f));
                                                    let _e863 = ((_e840 - _e841) * _e853);
                                                    let _e865 = select(0f, _e863, (_e863 > 0f));
                                                    let _e867 = ((_e857 + _e861) + _e865);
                                                    if (_e867 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1787_ = type_28();
                                                        phi_1788_ = true;
                                                    } else {
                                                        let _e870 = select(_e795[1][0], _e795[0][0], (_e795[0][0] < _e795[1][0]));
                                                        let _e874 = select(_e795[1][0], _e795[0][0], (_e795[0][0] > _e795[1][0]));
                                                        let _e878 = select(_e795[1][1], _e795[0][1], (_e795[0][1] < _e795[1][1]));
                                                        let _e882 = select(_e795[1][1], _e795[0][1], (_e795[0][1] > _e795[1][1]));
                                                        let _e886 = select(_e795[1][2], _e795[0][2], (_e795[0][2] < _e795[1][2]));
                                                        let _e890 = select(_e795[1][2], _e795[0][2], (_e795[0][2] > _e795[1][2]));
                                                        let _e895 = ((select(_e795[2][0], _e870, (_e870 < _e795[2][0])) - _e338) * _e343);
                                                        let _e896 = ((select(_e795[2][0], _e874, (_e874 > _e795[2][0])) - _e339) * _e343);
                                                        let _e899 = ((select(_e795[2][1], _e878, (_e878 < _e795[2][1])) - _e374) * _e379);
                                                        let _e900 = ((select(_e795[2][1], _e882, (_e882 > _e795[2][1])) - _e375) * _e379);
                                                        let _e903 = ((select(_e795[2][2], _e886, (_e886 < _e795[2][2])) - _e410) * _e415);
                                                        let _e904 = ((select(_e795[2][2], _e890, (_e890 > _e795[2][2])) - _e411) * _e415);
                                                        let _e906 = select(_e904, _e903, (_e903 < _e904));
                                                        let _e908 = select(_e904, _e903, (_e903 > _e904));
                                                        let _e910 = select(_e896, _e895, (_e895 < _e896));
                                                        let _e912 = select(_e900, _e899, (_e899 < _e900));
                                                        let _e914 = select(_e912, _e910, (_e910 > _e912));
                                                        let _e916 = select(_e906, _e914, (_e914 > _e906));
                                                        let _e918 = select(_e896, _e895, (_e895 > _e896));
                                                        let _e920 = select(_e900, _e899, (_e899 > _e900));
                                                        let _e922 = select(_e920, _e918, (_e918 < _e920));
                                                        let _e924 = select(_e908, _e922, (_e922 < _e908));
                                                        let _e925 = -(_e906);
                                                        let _e931 = select(_e461, _e916, (_e916 > _e461));
                                                        if (_e931 > (_e924 + (select(_e925, _e908, (_e908 > _e925)) * 0.0000019073523f))) {
                                                            phi_1782_ = type_28();
                                                            phi_1783_ = true;
                                                        } else {
                                                            let _e933 = (_e931 > _e696.member_1);
                                                            if _e933 {
                                                                phi_1781_ = type_28();
                                                            } else {
                                                                let _e937 = (_e795[1][0] - _e795[0][0]);
                                                                let _e938 = (_e795[1][1] - _e795[0][1]);
                                                                let _e939 = (_e795[1][2] - _e795[0][2]);
                                                                let _e940 = vec3<f32>(_e937, _e938, _e939);
                                                                let _e941 = (_e795[2][0] - _e795[1][0]);
                                                                let _e942 = (_e795[2][1] - _e795[1][1]);
                                                                let _e943 = (_e795[2][2] - _e795[1][2]);
                                                                let _e944 = vec3<f32>(_e941, _e942, _e943);
                                                                let _e945 = (_e795[0][0] - _e795[2][0]);
                                                                let _e946 = (_e795[0][1] - _e795[2][1]);
                                                                let _e947 = (_e795[0][2] - _e795[2][2]);
                                                                let _e948 = vec3<f32>(_e945, _e946, _e947);
                                                                let _e951 = bitcast<f32>((bitcast<u32>(_e937) & 2147483647u));
                                                                let _e954 = bitcast<f32>((bitcast<u32>(_e938) & 2147483647u));
                                                                let _e956 = select(_e954, _e951, (_e951 > _e954));
                                                                let _e959 = bitcast<f32>((bitcast<u32>(_e939) & 2147483647u));
                                                                let _e961 = select(_e959, _e956, (_e956 > _e959));
                                                                let _e964 = bitcast<f32>((bitcast<u32>(_e941) & 2147483647u));
                                                                let _e967 = bitcast<f32>((bitcast<u32>(_e942) & 2147483647u));
                                                                let _e969 = select(_e967, _e964, (_e964 > _e967));
                                                                let _e972 = bitcast<f32>((bitcast<u32>(_e943) & 2147483647u));
                                                                let _e974 = select(_e972, _e969, (_e969 > _e972));
                                                                let _e977 = bitcast<f32>((bitcast<u32>(_e945) & 2147483647u));
                                                                let _e980 = bitcast<f32>((bitcast<u32>(_e946) & 2147483647u));
                                                                let _e982 = select(_e980, _e977, (_e977 > _e980));
                                                                let _e985 = bitcast<f32>((bitcast<u32>(_e947) & 2147483647u));
                                                                let _e987 = select(_e985, _e982, (_e982 > _e985));
                                                                let _e989 = select(_e974, _e961, (_e961 > _e974));
                                                                let _e991 = select(_e987, _e989, (_e989 > _e987));
                                                                if (_e961 == _e991) {
                                                                    phi_1692_ = _e944;
                                                                    phi_1693_ = _e948;
                                                                } else {
                                                                    let _e994 = vec3((_e974 == _e991));
                                                                    phi_1692_ = select(_e940, _e948, _e994);
                                                                    phi_1693_ = select(_e944, _e940, _e994);
                                                                }
                                                                let _e998 = phi_1692_;
                                                                let _e1000 = phi_1693_;
                                                                let _e1007 = ((_e998.y * _e1000.z) - (_e1000.y * _e998.z));
                                                                let _e1012 = ((_e998.z * _e1000.x) - (_e1000.z * _e998.x));
                                                                let _e1015 = ((_e998.x * _e1000.y) - (_e1000.x * _e998.y));
                                                                if (_e857 >= _e861) {
                                                                    phi_1724_ = select(true, false, (_e857 >= _e865));
                                                                } else {
                                                                    phi_1724_ = true;
                                                                }
                                                                let _e1020 = phi_1724_;
                                                                if _e1020 {
                                                                    phi_1733_ = select(vec3<f32>(_e795[2][0], _e795[2][1], _e795[2][2]), vec3<f32>(_e795[1][0], _e795[1][1], _e795[1][2]), vec3((_e861 >= _e865)));
                                                                } else {
                                                                    phi_1733_ = vec3<f32>(_e795[0][0], _e795[0][1], _e795[0][2]);
                                                                }
                                                                let _e1025 = phi_1733_;
                                                                let _e1042 = ((((_e1007 * (_e1025.x - _e315)) + (_e1012 * (_e1025.y - _e352))) + (_e1015 * (_e1025.z - _e388))) / (((_e1007 * _e340) + (_e1012 * _e376)) + (_e1015 * _e412)));
                                                                let _e1044 = select(_e924, _e1042, (_e1042 < _e924));
                                                                let _e1046 = select(_e916, _e1044, (_e1044 > _e916));
                                                                if (_e1046 >= _e461) {
                                                                    let _e1048 = (_e1046 <= _e696.member_1);
                                                                    if _e1048 {
                                                                        let _e1049 = (1f / _e867);
                                                                        phi_1773_ = type_28(_e1046, (_e861 * _e1049), (_e865 * _e1049), _e725);
                                                                    } else {
                                                                        phi_1773_ = type_28();
                                                                    }
                                                                    let _e1054 = phi_1773_;
                                                                    phi_1775_ = _e1054;
                                                                    phi_1776_ = select(true, false, _e1048);
                                                                } else {
                                                                    phi_1775_ = type_28();
                                                                    phi_1776_ = true;
                                                                }
                                                                let _e1057 = phi_1775_;
                                                                let _e1059 = phi_1776_;
                                                                if _e1059 {
                                                                    phi_1780_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1780_ = _e1057;
                                                                }
                                                                let _e1061 = phi_1780_;
                                                                phi_1781_ = _e1061;
                                                            }
                                                            let _e1063 = phi_1781_;
                                                            phi_1782_ = _e1063;
                                                            phi_1783_ = _e933;
                                                        }
                                                        let _e1065 = phi_1782_;
                                                        let _e1067 = phi_1783_;
                                                        phi_1787_ = _e1065;
                                                        phi_1788_ = _e1067;
                                                    }
                                                    let _e1069 = phi_1787_;
                                                    let _e1071 = phi_1788_;
                                                    phi_1792_ = _e1069;
                                                    phi_1793_ = _e1071;
                                                } else {
                                                    phi_1792_ = type_28();
                                                    phi_1793_ = true;
                                                }
                                                let _e1073 = phi_1792_;
                                                let _e1075 = phi_1793_;
                                                if _e1075 {
                                                    phi_1797_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1797_ = _e1073;
                                                }
                                                let _e1077 = phi_1797_;
                                                if (_e1077.member_3 != 4294967295u) {
                                                    if (_e725 == _e166) {
                                                        phi_2126_ = false;
                                                    } else {
                                                        let _e1081 = (_e725 < arrayLength((&global_5.member)));
                                                        if _e1081 {
                                                            if _e1081 {
                                                            } else {
                                                                phi_2773_ = true;
                                                                break;
                                                            }
                                                            let _e1083 = global_5.member[_e725];
                                                            phi_1820_ = _e1083;
                                                        } else {
                                                            phi_1820_ = 4294967295u;
                                                        }
                                                        let _e1085 = phi_1820_;
                                                        let _e1086 = (_e1085 < arrayLength((&global_6.member)));
                                                        if _e1086 {
                                                            if _e1086 {
                                                            } else {
                                                                phi_2773_ = true;
                                                                break;
                                                            }
                                                            let _e1088 = global_6.member[_e1085];
                                                            phi_1834_ = _e1088;
                                                        } else {
                                                            phi_1834_ = 0i;
                                                        }
                                                        let _e1090 = phi_1834_;
                                                        let _e1091 = (_e1090 == 0i);
                                                        if _e1091 {
                                                            phi_2125_ = true;
                                                        } else {
                                                            if _e307 {
                                                                phi_1855_ = vec3<f32>(_e795[0][0], _e795[0][1], _e795[0][2]);
                                                            } else {
                                                                if (_e287 == 1u) {
                                                                    phi_1854_ = vec3<f32>(_e795[0][2], _e795[0][0], _e795[0][1]);
                                                                } else {
                                                                    phi_1854_ = vec3<f32>(_e795[0][1], _e795[0][2], _e795[0][0]);
                                                                }
                                                                let _e1096 = phi_1854_;
                                                                phi_1855_ = _e1096;
                                                            }
                                                            let _e1099 = phi_1855_;
                                                            if _e307 {
                                                                phi_1872_ = vec3<f32>(_e795[1][0], _e795[1][1], _e795[1][2]);
                                                            } else {
                                                                if (_e287 == 1u) {
                                                                    phi_1871_ = vec3<f32>(_e795[1][2], _e795[1][0], _e795[1][1]);
                                                                } else {
                                                                    phi_1871_ = vec3<f32>(_e795[1][1], _e795[1][2], _e795[1][0]);
                                                                }
                                                                let _e1104 = phi_1871_;
                                                                phi_1872_ = _e1104;
                                                            }
                                                            let _e1107 = phi_1872_;
                                                            if _e307 {
                                                                phi_1889_ = vec3<f32>(_e795[2][0], _e795[2][1], _e795[2][2]);
                                                            } else {
                                                                if (_e287 == 1u) {
                                                                    phi_1888_ = vec3<f32>(_e795[2][2], _e795[2][0], _e795[2][1]);
                                                                } else {
                                                                    phi_1888_ = vec3<f32>(_e795[2][1], _e795[2][2], _e795[2][0]);
                                                                }
                                                                let _e1112 = phi_1888_;
                                                                phi_1889_ = _e1112;
                                                            }
                                                            let _e1115 = phi_1889_;
                                                            let _e1118 = (_e1107.x - _e1099.x);
                                                            let _e1121 = (_e1107.y - _e1099.y);
                                                            let _e1124 = (_e1107.z - _e1099.z);
                                                            let _e1126 = (_e1115.x - _e1099.x);
                                                            let _e1128 = (_e1115.y - _e1099.y);
                                                            let _e1130 = (_e1115.z - _e1099.z);
                                                            if (_e162.member_1 == 1u) {
                                                                phi_1925_ = (vec3<f32>(_e162.member[0], _e162.member[1], _e162.member[2]) - _e1099);
                                                            } else {
                                                                phi_1925_ = vec3<f32>(_e162.member[0], _e162.member[1], _e162.member[2]);
                                                            }
                                                            let _e1145 = phi_1925_;
                                                            let _e1151 = bitcast<f32>((bitcast<u32>((_e1118 * _e1128)) ^ _e162.member_3[0]));
                                                            let _e1155 = bitcast<f32>((bitcast<u32>((_e1121 * _e1126)) ^ _e162.member_3[0]));
                                                            let _e1159 = bitcast<f32>((bitcast<u32>((_e1121 * _e1130)) ^ _e162.member_3[0]));
                                                            let _e1163 = bitcast<f32>((bitcast<u32>((_e1124 * _e1128)) ^ _e162.member_3[0]));
                                                            let _e1167 = bitcast<f32>((bitcast<u32>((_e1124 * _e1126)) ^ _e162.member_3[0]));
                                                            let _e1171 = bitcast<f32>((bitcast<u32>((_e1118 * _e1130)) ^ _e162.member_3[0]));
                                                            let _e1172 = (_e1159 - _e1163);
                                                            let _e1173 = (_e1167 - _e1171);
                                                            let _e1174 = (_e1151 - _e1155);
                                                            let _e1198 = (bitcast<f32>((bitcast<u32>(_e1159) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1163) & 2147483647u)));
                                                            let _e1205 = (bitcast<f32>((bitcast<u32>(_e1167) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1171) & 2147483647u)));
                                                            let _e1212 = (bitcast<f32>((bitcast<u32>(_e1151) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1155) & 2147483647u)));
                                                            if (_e162.member_2 == 0f) {
                                                                phi_2107_ = 0f;
                                                            } else {
                                                                let _e1242 = bitcast<f32>((bitcast<u32>(_e1172) & 2147483647u));
                                                                let _e1245 = bitcast<f32>((bitcast<u32>(_e1173) & 2147483647u));
                                                                let _e1248 = bitcast<f32>((bitcast<u32>(_e1174) & 2147483647u));
                                                                let _e1250 = select(_e1248, _e1245, (_e1245 > _e1248));
                                                                let _e1254 = select(_e1248, _e1245, (_e1245 < _e1248));
                                                                let _e1258 = select(_e1245, _e1242, (_e1242 < _e1245));
                                                                let _e1260 = select(_e1245, _e1242, (_e1242 > _e1245));
                                                                let _e1262 = select(_e1248, _e1260, (_e1260 < _e1248));
                                                                phi_2107_ = bitcast<f32>((bitcast<u32>((_e162.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1250, _e1242, (_e1242 > _e1250)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1262, _e1258, (_e1258 > _e1262)))) ^ _e162.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1254, _e1242, (_e1242 < _e1254)))) ^ _e162.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1198 + _e1205) + _e1212))) ^ _e162.member_3[0]))) * 1.0000005f)) ^ _e162.member_3[0])))) ^ _e162.member_3[0]));
                                                            }
                                                            let _e1289 = phi_2107_;
                                                            phi_2125_ = (_e1091 || !(((((bitcast<f32>((bitcast<u32>((_e1145.x * _e1172)) ^ _e162.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1145.y * _e1173)) ^ _e162.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1145.z * _e1174)) ^ _e162.member_3[0]))) * f32(-(_e1090))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1145.x) & 2147483647u)) * _e1198)) ^ _e162.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1145.y) & 2147483647u)) * _e1205)) ^ _e162.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1145.z) & 2147483647u)) * _e1212)) ^ _e162.member_3[0]))))) ^ _e162.member_3[0])) + _e1289) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1303 = phi_2125_;
                                                        phi_2126_ = _e1303;
                                                    }
                                                    let _e1305 = phi_2126_;
                                                    if _e1305 {
                                                        if (_e1077.member < _e696.member.member) {
                                                            phi_2146_ = true;
                                                        } else {
                                                            if (_e1077.member == _e696.member.member) {
                                                                phi_2145_ = (_e1077.member_3 < _e696.member.member_3);
                                                            } else {
                                                                phi_2145_ = false;
                                                            }
                                                            let _e1315 = phi_2145_;
                                                            phi_2146_ = _e1315;
                                                        }
                                                        let _e1317 = phi_2146_;
                                                        if _e1317 {
                                                            phi_2152_ = type_49(_e1077, _e1077.member);
                                                        } else {
                                                            phi_2152_ = _e696;
                                                        }
                                                        let _e1320 = phi_2152_;
                                                        phi_2153_ = _e1320;
                                                    } else {
                                                        phi_2153_ = _e696;
                                                    }
                                                    let _e1322 = phi_2153_;
                                                    phi_2154_ = _e1322;
                                                } else {
                                                    phi_2154_ = _e696;
                                                }
                                                let _e1324 = phi_2154_;
                                                phi_1086_ = _e1324;
                                            } else {
                                                phi_1086_ = type_49();
                                            }
                                            let _e1326 = phi_1086_;
                                            continue;
                                            continuing {
                                                phi_1085_ = _e1326;
                                                phi_1088_ = _e711;
                                                phi_2773_ = _e469;
                                                break if !(_e717);
                                            }
                                        }
                                        let _e1329 = phi_2773_;
                                        phi_2904_ = _e1329;
                                        if _e1329 {
                                            break;
                                        }
                                        phi_2908_ = _e1329;
                                        let _e1534 = local_3;
                                        phi_2608_ = _e1534;
                                        phi_2609_ = _e494;
                                        phi_2610_ = false;
                                        phi_2611_ = _e498;
                                    } else {
                                        if (_e494 >= _e74) {
                                            phi_2214_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e494 < _e74) {
                                            } else {
                                                phi_2904_ = true;
                                                break;
                                            }
                                            let _e508 = (_e287 % 3u);
                                            if (_e508 < 3u) {
                                            } else {
                                                phi_2904_ = true;
                                                break;
                                            }
                                            let _e514 = global_3.member[_e494].member[_e508];
                                            let _e520 = (_e286 % 3u);
                                            if (_e520 < 3u) {
                                            } else {
                                                phi_2904_ = true;
                                                break;
                                            }
                                            let _e526 = global_3.member[_e494].member[_e520];
                                            let _e532 = (_e288 % 3u);
                                            if (_e532 < 3u) {
                                            } else {
                                                phi_2904_ = true;
                                                break;
                                            }
                                            let _e538 = global_3.member[_e494].member[_e532];
                                            let _e548 = global_3.member[_e494].member_1;
                                            let _e552 = global_3.member[_e494].member_2;
                                            phi_2214_ = type_53(array<vec4<f32>, 3>(vec4<f32>(_e514[0], _e514[1], _e514[2], _e514[3]), vec4<f32>(_e526[0], _e526[1], _e526[2], _e526[3]), vec4<f32>(_e538[0], _e538[1], _e538[2], _e538[3])), _e548, _e552);
                                        }
                                        let _e555 = phi_2214_;
                                        let _e567 = ((_e555.member[0].x - _e338) * _e343);
                                        let _e568 = ((_e555.member[0].y - _e338) * _e343);
                                        let _e569 = ((_e555.member[0].z - _e339) * _e343);
                                        let _e570 = ((_e555.member[0].w - _e339) * _e343);
                                        let _e580 = ((_e555.member[1].x - _e374) * _e379);
                                        let _e581 = ((_e555.member[1].y - _e374) * _e379);
                                        let _e582 = ((_e555.member[1].z - _e375) * _e379);
                                        let _e583 = ((_e555.member[1].w - _e375) * _e379);
                                        let _e593 = ((_e555.member[2].x - _e410) * _e415);
                                        let _e594 = ((_e555.member[2].y - _e410) * _e415);
                                        let _e595 = ((_e555.member[2].z - _e411) * _e415);
                                        let _e596 = ((_e555.member[2].w - _e411) * _e415);
                                        let _e598 = select(_e595, _e593, (_e593 < _e595));
                                        let _e600 = select(_e596, _e594, (_e594 < _e596));
                                        let _e602 = select(_e595, _e593, (_e593 > _e595));
                                        let _e604 = select(_e596, _e594, (_e594 > _e596));
                                        let _e606 = select(_e569, _e567, (_e567 < _e569));
                                        let _e608 = select(_e570, _e568, (_e568 < _e570));
                                        let _e610 = select(_e582, _e580, (_e580 < _e582));
                                        let _e612 = select(_e583, _e581, (_e581 < _e583));
                                        let _e614 = select(_e610, _e606, (_e606 > _e610));
                                        let _e616 = select(_e612, _e608, (_e608 > _e612));
                                        let _e618 = select(_e598, _e614, (_e614 > _e598));
                                        let _e620 = select(_e600, _e616, (_e616 > _e600));
                                        let _e622 = select(_e569, _e567, (_e567 > _e569));
                                        let _e624 = select(_e570, _e568, (_e568 > _e570));
                                        let _e626 = select(_e582, _e580, (_e580 > _e582));
                                        let _e628 = select(_e583, _e581, (_e581 > _e583));
                                        let _e630 = select(_e626, _e622, (_e622 < _e626));
                                        let _e632 = select(_e628, _e624, (_e624 < _e628));
                                        let _e637 = -(_e598);
                                        let _e638 = -(_e600);
                                        let _e645 = (select(_e602, _e630, (_e630 < _e602)) + (select(_e637, _e602, (_e602 > _e637)) * 0.0000019073523f));
                                        let _e646 = (select(_e604, _e632, (_e632 < _e604)) + (select(_e638, _e604, (_e604 > _e638)) * 0.0000019073523f));
                                        let _e648 = select(_e461, _e618, (_e618 > _e461));
                                        let _e650 = select(_e461, _e620, (_e620 > _e461));
                                        let _e655 = (_e648 <= select(_e471.member_1, _e645, (_e645 < _e471.member_1)));
                                        let _e656 = (_e650 <= select(_e471.member_1, _e646, (_e646 < _e471.member_1)));
                                        let _e657 = (_e648 <= _e650);
                                        if _e655 {
                                            if _e656 {
                                                if _e657 {
                                                    phi_2558_ = _e555.member_2;
                                                } else {
                                                    phi_2558_ = _e555.member_1;
                                                }
                                                let _e661 = phi_2558_;
                                                let _e662 = (_e498 % 128u);
                                                let _e663 = (_e662 < 128u);
                                                if _e663 {
                                                } else {
                                                    phi_2904_ = true;
                                                    break;
                                                }
                                                local_1[_e662] = _e661;
                                                if _e663 {
                                                } else {
                                                    phi_2904_ = true;
                                                    break;
                                                }
                                                local[_e662] = select(_e650, _e648, (_e648 > _e650));
                                                if _e657 {
                                                    phi_2585_ = _e555.member_1;
                                                } else {
                                                    phi_2585_ = _e555.member_2;
                                                }
                                                let _e672 = phi_2585_;
                                                phi_2586_ = _e672;
                                                phi_2587_ = (_e498 + 1u);
                                            } else {
                                                phi_2586_ = u32();
                                                phi_2587_ = u32();
                                            }
                                            let _e674 = phi_2586_;
                                            let _e676 = phi_2587_;
                                            phi_2589_ = _e674;
                                            phi_2590_ = _e676;
                                            phi_2591_ = select(true, false, _e656);
                                        } else {
                                            phi_2589_ = u32();
                                            phi_2590_ = u32();
                                            phi_2591_ = true;
                                        }
                                        let _e679 = phi_2589_;
                                        let _e681 = phi_2590_;
                                        let _e683 = phi_2591_;
                                        if _e683 {
                                            if _e655 {
                                                phi_2600_ = _e555.member_1;
                                            } else {
                                                phi_2600_ = _e555.member_2;
                                            }
                                            let _e687 = phi_2600_;
                                            phi_2605_ = _e687;
                                            phi_2606_ = select(_e656, true, _e655);
                                        } else {
                                            phi_2605_ = _e679;
                                            phi_2606_ = _e496;
                                        }
                                        let _e690 = phi_2605_;
                                        let _e692 = phi_2606_;
                                        phi_2908_ = _e469;
                                        phi_2608_ = _e471;
                                        phi_2609_ = _e690;
                                        phi_2610_ = _e692;
                                        phi_2611_ = select(_e681, _e498, _e683);
                                    }
                                    let _e1331 = phi_2908_;
                                    let _e1333 = phi_2608_;
                                    let _e1335 = phi_2609_;
                                    let _e1337 = phi_2610_;
                                    let _e1339 = phi_2611_;
                                    phi_2907_ = _e1331;
                                    phi_2612_ = _e1333;
                                    phi_2613_ = _e1335;
                                    phi_2614_ = (_e475 - 1u);
                                    phi_2615_ = _e1337;
                                    phi_2616_ = _e1339;
                                } else {
                                    phi_2907_ = _e469;
                                    phi_2612_ = _e471;
                                    phi_2613_ = _e494;
                                    phi_2614_ = _e475;
                                    phi_2615_ = _e496;
                                    phi_2616_ = _e498;
                                }
                                let _e1341 = phi_2907_;
                                let _e1343 = phi_2612_;
                                let _e1345 = phi_2613_;
                                let _e1347 = phi_2614_;
                                let _e1349 = phi_2615_;
                                let _e1351 = phi_2616_;
                                phi_2906_ = _e1341;
                                phi_2617_ = _e1343;
                                phi_2618_ = _e1345;
                                phi_2619_ = _e1347;
                                phi_2620_ = _e1349;
                                phi_2621_ = _e1351;
                            } else {
                                phi_2906_ = _e469;
                                phi_2617_ = type_49();
                                phi_2618_ = u32();
                                phi_2619_ = u32();
                                phi_2620_ = bool();
                                phi_2621_ = u32();
                            }
                            let _e1353 = phi_2906_;
                            let _e1355 = phi_2617_;
                            let _e1357 = phi_2618_;
                            let _e1359 = phi_2619_;
                            let _e1361 = phi_2620_;
                            let _e1363 = phi_2621_;
                            phi_2905_ = _e1353;
                            phi_1018_ = _e1355;
                            phi_1021_ = _e1357;
                            phi_1023_ = _e1359;
                            phi_1025_ = _e1361;
                            phi_1027_ = _e1363;
                            phi_2622_ = _e483;
                        } else {
                            phi_2905_ = _e469;
                            phi_1018_ = type_49();
                            phi_1021_ = u32();
                            phi_1023_ = u32();
                            phi_1025_ = bool();
                            phi_1027_ = u32();
                            phi_2622_ = false;
                        }
                        let _e1365 = phi_2905_;
                        let _e1367 = phi_1018_;
                        let _e1369 = phi_1021_;
                        let _e1371 = phi_1023_;
                        let _e1373 = phi_1025_;
                        let _e1375 = phi_1027_;
                        let _e1377 = phi_2622_;
                        continue;
                        continuing {
                            phi_2779_ = _e1365;
                            phi_1017_ = _e1367;
                            phi_1020_ = _e1369;
                            phi_1022_ = _e1371;
                            phi_1024_ = _e1373;
                            phi_1026_ = _e1375;
                            phi_2904_ = _e1365;
                            break if !(_e1377);
                        }
                    }
                    let _e1380 = phi_2904_;
                    if _e1380 {
                        break;
                    }
                    let _e1382 = local_2;
                    if (_e1382.member.member_3 != 4294967295u) {
                        let _e1387 = (_e289 / 3i);
                        let _e1394 = bitcast<f32>((bitcast<u32>((_e1387 + 127i)) << bitcast<u32>(23i)));
                        let _e1402 = (((_e1382.member.member * _e1394) * _e1394) * bitcast<f32>((bitcast<u32>(((_e289 - (2i * _e1387)) + 127i)) << bitcast<u32>(23i))));
                        let _e1404 = select(340282350000000000000000000000000000000f, _e1402, (_e1402 < 340282350000000000000000000000000000000f));
                        phi_2674_ = type_28(select(-340282350000000000000000000000000000000f, _e1404, (_e1404 > -340282350000000000000000000000000000000f)), _e1382.member.member_1, _e1382.member.member_2, _e1382.member.member_3);
                    } else {
                        phi_2674_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1411 = phi_2674_;
                    if _e94 {
                    } else {
                        break;
                    }
                    global_8.member[_e92] = _e1411;
                    if _e93 {
                    } else {
                        break;
                    }
                    let _e1415 = select(0u, 1u, (_e233 <= _e243));
                    if (_e1415 > 0u) {
                        let _e1417 = (1u < _e88);
                        if _e1417 {
                            if (0u < _e88) {
                            } else {
                                break;
                            }
                            let _e1421 = atomicAdd((&global_9.member[0u]), _e1415);
                            if ((_e1421 + _e1415) < _e1421) {
                                if _e1417 {
                                } else {
                                    break;
                                }
                                let _e1426 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1429 = select(0u, 1u, (_e1411.member_3 != 4294967295u));
                    if (_e1429 > 0u) {
                        let _e1431 = (3u < _e88);
                        if _e1431 {
                            if (2u < _e88) {
                            } else {
                                break;
                            }
                            let _e1435 = atomicAdd((&global_9.member[2u]), _e1429);
                            if ((_e1435 + _e1429) < _e1435) {
                                if _e1431 {
                                } else {
                                    break;
                                }
                                let _e1440 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_facing(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
