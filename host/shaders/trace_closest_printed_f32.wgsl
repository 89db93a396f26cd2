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

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_33 {
    member: type_22,
    member_1: f32,
}

struct type_37 {
    member: array<type_26>,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_42 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_44 {
    member: array<type_42>,
}

struct type_47 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_49 {
    member: type_47,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_40;
@group(0) @binding(4) 
var<storage> global_4: type_37;
@group(0) @binding(2) 
var<storage> global_5: type_44;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_24;

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
    var phi_329_: i32;
    var phi_330_: i32;
    var phi_340_: bool;
    var phi_350_: u32;
    var phi_351_: u32;
    var phi_353_: bool;
    var phi_358_: u32;
    var phi_370_: i32;
    var phi_390_: i32;
    var phi_408_: f32;
    var phi_414_: f32;
    var phi_425_: f32;
    var phi_431_: f32;
    var phi_454_: f32;
    var phi_465_: f32;
    var phi_474_: f32;
    var phi_480_: f32;
    var phi_491_: f32;
    var phi_497_: f32;
    var phi_520_: f32;
    var phi_531_: f32;
    var phi_540_: f32;
    var phi_546_: f32;
    var phi_557_: f32;
    var phi_563_: f32;
    var phi_586_: f32;
    var phi_597_: f32;
    var phi_697_: f32;
    var phi_698_: f32;
    var phi_2974_: bool;
    var phi_771_: type_33;
    var phi_774_: type_49;
    var phi_776_: u32;
    var phi_778_: bool;
    var phi_780_: u32;
    var phi_791_: bool;
    var phi_877_: type_49;
    var phi_878_: bool;
    var phi_879_: u32;
    var phi_1926_: type_42;
    var phi_2758_: type_49;
    var phi_2835_: type_49;
    var phi_2836_: type_49;
    var phi_2837_: u32;
    var phi_2839_: type_49;
    var phi_2840_: u32;
    var phi_2841_: bool;
    var phi_2848_: type_49;
    var phi_2853_: type_49;
    var phi_2854_: bool;
    var phi_897_: type_33;
    var phi_900_: type_4;
    var phi_901_: type_4;
    var phi_923_: type_4;
    var phi_944_: u32;
    var phi_1033_: array<array<f32, 3>, 3>;
    var phi_1150_: bool;
    var phi_1179_: bool;
    var phi_1580_: f32;
    var phi_1581_: f32;
    var phi_1582_: f32;
    var phi_1583_: f32;
    var phi_1584_: vec3<f32>;
    var phi_1585_: vec3<f32>;
    var phi_1586_: vec3<f32>;
    var phi_1587_: vec3<f32>;
    var phi_1618_: bool;
    var phi_1627_: vec3<f32>;
    var phi_1792_: f32;
    var phi_1794_: f32;
    var phi_1795_: bool;
    var phi_1815_: f32;
    var phi_1816_: f32;
    var phi_1839_: type_22;
    var phi_1841_: type_22;
    var phi_1842_: bool;
    var phi_1846_: type_22;
    var phi_1847_: type_22;
    var phi_1848_: type_22;
    var phi_1849_: bool;
    var phi_1853_: type_22;
    var phi_1854_: bool;
    var phi_1855_: type_22;
    var phi_1856_: bool;
    var phi_1857_: bool;
    var phi_1858_: type_22;
    var phi_1859_: bool;
    var phi_1860_: bool;
    var phi_1868_: type_22;
    var phi_1869_: bool;
    var phi_1873_: type_22;
    var phi_1898_: bool;
    var phi_1899_: bool;
    var phi_1905_: type_33;
    var phi_1906_: type_33;
    var phi_1907_: type_33;
    var phi_898_: type_33;
    var phi_2968_: bool;
    var phi_3114_: bool;
    var phi_2856_: type_33;
    var phi_2857_: type_49;
    var phi_2858_: bool;
    var phi_2859_: u32;
    var phi_3113_: bool;
    var phi_2860_: type_33;
    var phi_2861_: type_49;
    var phi_2862_: u32;
    var phi_2863_: bool;
    var phi_2864_: u32;
    var phi_3112_: bool;
    var phi_2865_: type_33;
    var phi_2866_: type_49;
    var phi_2867_: u32;
    var phi_2868_: bool;
    var phi_2869_: u32;
    var phi_3111_: bool;
    var phi_772_: type_33;
    var phi_775_: type_49;
    var phi_777_: u32;
    var phi_779_: bool;
    var phi_781_: u32;
    var phi_2870_: bool;
    var phi_3110_: bool;
    var local_10: type_33;
    var phi_2922_: type_22;
    var local_11: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e77 = global;
            let _e80 = arrayLength((&global_5.member));
            let _e82 = arrayLength((&global_2.member));
            let _e90 = global_3.member[0u][0u];
            let _e94 = global_3.member[0u][1u];
            let _e98 = global_3.member[0u][2u];
            let _e102 = global_3.member[1u][0u];
            let _e106 = global_3.member[1u][1u];
            let _e110 = global_3.member[1u][2u];
            let _e114 = global_3.member[1u][3u];
            let _e117 = global_1.member[0u];
            let _e118 = bitcast<i32>(_e117);
            let _e128 = (_e77.x + (_e77.y * 2097152u));
            let _e129 = (_e128 < arrayLength((&global_4.member)));
            if _e129 {
                let _e130 = (_e128 < arrayLength((&global_6.member)));
                if _e130 {
                    if _e129 {
                    } else {
                        break;
                    }
                    let _e138 = global_4.member[_e128].member_2[0u];
                    let _e140 = (bitcast<u32>(_e138) & 2147483647u);
                    let _e145 = global_4.member[_e128].member_2[1u];
                    let _e147 = (bitcast<u32>(_e145) & 2147483647u);
                    let _e152 = global_4.member[_e128].member_2[2u];
                    let _e154 = (bitcast<u32>(_e152) & 2147483647u);
                    let _e159 = global_4.member[_e128].member[0u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_4.member[_e128].member[1u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_4.member[_e128].member[2u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e177 = select(_e147, _e140, (_e147 < _e140));
                    let _e179 = select(_e154, _e177, (_e154 < _e177));
                    let _e181 = select(_e161, _e179, (_e161 < _e179));
                    let _e183 = select(_e168, _e181, (_e168 < _e181));
                    let _e185 = select(_e175, _e183, (_e175 < _e183));
                    let _e189 = global_4.member[_e128].member_1;
                    let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                    let _e198 = global_4.member[_e128].member_3;
                    let _e204 = (((select(_e191, _e185, (_e191 < _e185)) < 2139095040u) && ((bitcast<u32>(_e198) & 2147483647u) <= 2139095040u)) && (_e179 > 0u));
                    if _e204 {
                        let _e207 = (bitcast<u32>(bitcast<f32>(_e179)) & 2147483647u);
                        if (_e207 >= 8388608u) {
                            phi_329_ = (bitcast<i32>((_e207 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_329_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e207)), 32u, (_e207 == 0u))));
                        }
                        let _e221 = phi_329_;
                        phi_330_ = _e221;
                    } else {
                        phi_330_ = 0i;
                    }
                    let _e223 = phi_330_;
                    let _e224 = (_e140 == _e179);
                    if _e224 {
                        phi_340_ = true;
                    } else {
                        phi_340_ = (_e147 == _e179);
                    }
                    let _e227 = phi_340_;
                    let _e228 = select(1u, 0u, _e224);
                    if _e227 {
                        let _e229 = (_e228 + 1u);
                        phi_350_ = _e229;
                        phi_351_ = _e229;
                        phi_353_ = select(true, false, (_e229 == 2u));
                    } else {
                        phi_350_ = u32();
                        phi_351_ = 0u;
                        phi_353_ = true;
                    }
                    let _e233 = phi_350_;
                    let _e235 = phi_351_;
                    let _e237 = phi_353_;
                    if _e237 {
                        phi_358_ = (_e235 + 1u);
                    } else {
                        phi_358_ = 0u;
                    }
                    let _e241 = phi_358_;
                    let _e242 = select(_e233, _e235, _e237);
                    let _e243 = select(_e228, select(2u, _e228, _e227), _e237);
                    if (_e118 < -126i) {
                        phi_370_ = -126i;
                    } else {
                        phi_370_ = select(_e118, 127i, (_e118 > 127i));
                    }
                    let _e248 = phi_370_;
                    let _e253 = bitcast<f32>((bitcast<u32>((_e248 + 127i)) << bitcast<u32>(23i)));
                    let _e259 = bitcast<f32>((bitcast<u32>(((_e118 - _e248) + 127i)) << bitcast<u32>(23i)));
                    let _e260 = -(_e223);
                    if (_e260 < -126i) {
                        phi_390_ = -126i;
                    } else {
                        phi_390_ = select(_e260, 127i, (_e260 > 127i));
                    }
                    let _e265 = phi_390_;
                    let _e270 = bitcast<f32>((bitcast<u32>((_e265 + 127i)) << bitcast<u32>(23i)));
                    let _e276 = bitcast<f32>((bitcast<u32>(((_e260 - _e265) + 127i)) << bitcast<u32>(23i)));
                    let _e280 = global_4.member[_e128].member;
                    let _e281 = (_e242 == 0u);
                    if _e281 {
                        phi_408_ = _e280[0];
                    } else {
                        phi_408_ = _e280[1];
                    }
                    let _e285 = phi_408_;
                    let _e286 = (_e242 == 2u);
                    if _e286 {
                        phi_414_ = _e280[2];
                    } else {
                        phi_414_ = _e285;
                    }
                    let _e289 = phi_414_;
                    let _e291 = ((_e289 * _e253) * _e259);
                    let _e292 = global_4.member[_e128].member_2;
                    if _e281 {
                        phi_425_ = _e292[0];
                    } else {
                        phi_425_ = _e292[1];
                    }
                    let _e296 = phi_425_;
                    if _e286 {
                        phi_431_ = _e292[2];
                    } else {
                        phi_431_ = _e296;
                    }
                    let _e299 = phi_431_;
                    let _e301 = ((_e299 * _e270) * _e276);
                    let _e305 = (bitcast<f32>((bitcast<u32>(_e301) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e305 {
                        let _e309 = (bitcast<f32>((bitcast<u32>(_e291) & 2147483647u)) * 0.00000011920929f);
                        phi_454_ = select(0.00000000000011368684f, _e309, (_e309 > 0.00000000000011368684f));
                    } else {
                        phi_454_ = 0f;
                    }
                    let _e313 = phi_454_;
                    let _e314 = (_e291 + _e313);
                    let _e315 = (_e291 - _e313);
                    let _e316 = select(_e301, 0f, _e305);
                    if _e305 {
                        phi_465_ = 38685626000000000000000000f;
                    } else {
                        phi_465_ = (1f / _e301);
                    }
                    let _e319 = phi_465_;
                    let _e320 = (_e241 == 0u);
                    if _e320 {
                        phi_474_ = _e280[0];
                    } else {
                        phi_474_ = _e280[1];
                    }
                    let _e324 = phi_474_;
                    let _e325 = (_e241 == 2u);
                    if _e325 {
                        phi_480_ = _e280[2];
                    } else {
                        phi_480_ = _e324;
                    }
                    let _e328 = phi_480_;
                    let _e330 = ((_e328 * _e253) * _e259);
                    if _e320 {
                        phi_491_ = _e292[0];
                    } else {
                        phi_491_ = _e292[1];
                    }
                    let _e334 = phi_491_;
                    if _e325 {
                        phi_497_ = _e292[2];
                    } else {
                        phi_497_ = _e334;
                    }
                    let _e337 = phi_497_;
                    let _e339 = ((_e337 * _e270) * _e276);
                    let _e343 = (bitcast<f32>((bitcast<u32>(_e339) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e343 {
                        let _e347 = (bitcast<f32>((bitcast<u32>(_e330) & 2147483647u)) * 0.00000011920929f);
                        phi_520_ = select(0.00000000000011368684f, _e347, (_e347 > 0.00000000000011368684f));
                    } else {
                        phi_520_ = 0f;
                    }
                    let _e351 = phi_520_;
                    let _e352 = (_e330 + _e351);
                    let _e353 = (_e330 - _e351);
                    let _e354 = select(_e339, 0f, _e343);
                    if _e343 {
                        phi_531_ = 38685626000000000000000000f;
                    } else {
                        phi_531_ = (1f / _e339);
                    }
                    let _e357 = phi_531_;
                    let _e358 = (_e243 == 0u);
                    if _e358 {
                        phi_540_ = _e280[0];
                    } else {
                        phi_540_ = _e280[1];
                    }
                    let _e362 = phi_540_;
                    let _e363 = (_e243 == 2u);
                    if _e363 {
                        phi_546_ = _e280[2];
                    } else {
                        phi_546_ = _e362;
                    }
                    let _e366 = phi_546_;
                    let _e368 = ((_e366 * _e253) * _e259);
                    if _e358 {
                        phi_557_ = _e292[0];
                    } else {
                        phi_557_ = _e292[1];
                    }
                    let _e372 = phi_557_;
                    if _e363 {
                        phi_563_ = _e292[2];
                    } else {
                        phi_563_ = _e372;
                    }
                    let _e375 = phi_563_;
                    let _e377 = ((_e375 * _e270) * _e276);
                    let _e381 = (bitcast<f32>((bitcast<u32>(_e377) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e381 {
                        let _e385 = (bitcast<f32>((bitcast<u32>(_e368) & 2147483647u)) * 0.00000011920929f);
                        phi_586_ = select(0.00000000000011368684f, _e385, (_e385 > 0.00000000000011368684f));
                    } else {
                        phi_586_ = 0f;
                    }
                    let _e389 = phi_586_;
                    let _e390 = (_e368 + _e389);
                    let _e391 = (_e368 - _e389);
                    let _e392 = select(_e377, 0f, _e381);
                    if _e381 {
                        phi_597_ = 38685626000000000000000000f;
                    } else {
                        phi_597_ = (1f / _e377);
                    }
                    let _e395 = phi_597_;
                    let _e398 = bitcast<f32>((bitcast<u32>(_e291) & 2147483647u));
                    let _e401 = bitcast<f32>((bitcast<u32>(_e330) & 2147483647u));
                    let _e403 = select(_e401, _e398, (_e398 > _e401));
                    let _e406 = bitcast<f32>((bitcast<u32>(_e368) & 2147483647u));
                    let _e409 = (_e118 + _e223);
                    if (_e204 && (select(_e406, _e403, (_e403 > _e406)) <= 1099511600000f)) {
                        let _e412 = (_e409 / 3i);
                        let _e419 = bitcast<f32>((bitcast<u32>((_e412 + 127i)) << bitcast<u32>(23i)));
                        let _e426 = bitcast<f32>((bitcast<u32>(((_e409 - (2i * _e412)) + 127i)) << bitcast<u32>(23i)));
                        let _e427 = (((_e189 * _e419) * _e419) * _e426);
                        let _e429 = select(340282350000000000000000000000000000000f, _e427, (_e427 < 340282350000000000000000000000000000000f));
                        let _e434 = (((_e198 * _e419) * _e419) * _e426);
                        let _e436 = select(340282350000000000000000000000000000000f, _e434, (_e434 < 340282350000000000000000000000000000000f));
                        phi_697_ = select(-340282350000000000000000000000000000000f, _e436, (_e436 > -340282350000000000000000000000000000000f));
                        phi_698_ = select(-340282350000000000000000000000000000000f, _e429, (_e429 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_697_ = 0f;
                        phi_698_ = 1f;
                    }
                    let _e440 = phi_697_;
                    let _e442 = phi_698_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e90), bitcast<f32>(_e94), bitcast<f32>(_e98));
                    let _e447 = (_e242 % 3u);
                    let _e448 = (_e447 < 3u);
                    if _e448 {
                    } else {
                        break;
                    }
                    let _e450 = local_9[_e447];
                    let _e451 = (_e241 % 3u);
                    let _e452 = (_e451 < 3u);
                    if _e452 {
                    } else {
                        break;
                    }
                    let _e454 = local_9[_e451];
                    let _e455 = (_e243 % 3u);
                    let _e456 = (_e455 < 3u);
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e458 = local_9[_e455];
                    local_8 = array<f32, 3>(bitcast<f32>(_e102), bitcast<f32>(_e106), bitcast<f32>(_e110));
                    if _e448 {
                    } else {
                        break;
                    }
                    let _e462 = local_8[_e447];
                    if _e452 {
                    } else {
                        break;
                    }
                    let _e464 = local_8[_e451];
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e466 = local_8[_e455];
                    phi_2974_ = false;
                    phi_771_ = type_33(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e440);
                    phi_774_ = type_49(type_47(array<f32, 3>(_e450, _e454, _e458), array<f32, 3>(_e462, _e464, _e466)), select(0u, 2147483648u, (_e80 == 0u)));
                    phi_776_ = ((3u * _e80) + 1u);
                    phi_778_ = (_e442 <= _e440);
                    phi_780_ = 0u;
                    loop {
                        let _e474 = phi_2974_;
                        let _e476 = phi_771_;
                        let _e478 = phi_774_;
                        let _e480 = phi_776_;
                        let _e482 = phi_778_;
                        let _e484 = phi_780_;
                        local_10 = _e476;
                        if _e482 {
                            phi_791_ = true;
                        } else {
                            phi_791_ = (_e484 > 0u);
                        }
                        let _e487 = phi_791_;
                        if _e487 {
                            let _e488 = (_e480 > 0u);
                            if _e488 {
                                if _e482 {
                                    phi_877_ = _e478;
                                    phi_878_ = _e482;
                                    phi_879_ = _e484;
                                } else {
                                    let _e489 = (_e484 - 1u);
                                    let _e490 = (_e489 % 128u);
                                    let _e491 = (_e490 < 128u);
                                    if _e491 {
                                    } else {
                                        phi_3110_ = true;
                                        break;
                                    }
                                    let _e493 = local_6[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3110_ = true;
                                        break;
                                    }
                                    let _e495 = local_5[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3110_ = true;
                                        break;
                                    }
                                    let _e497 = local_4[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3110_ = true;
                                        break;
                                    }
                                    let _e499 = local_3[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3110_ = true;
                                        break;
                                    }
                                    let _e502 = local_2[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3110_ = true;
                                        break;
                                    }
                                    let _e504 = local_1[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3110_ = true;
                                        break;
                                    }
                                    let _e506 = local[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3110_ = true;
                                        break;
                                    }
                                    let _e511 = local_7[_e490];
                                    phi_877_ = type_49(type_47(array<f32, 3>(_e495, _e497, _e499), array<f32, 3>(_e502, _e504, _e506)), _e493);
                                    phi_878_ = (_e511 <= _e476.member_1);
                                    phi_879_ = _e489;
                                }
                                let _e515 = phi_877_;
                                let _e517 = phi_878_;
                                let _e519 = phi_879_;
                                if _e517 {
                                    if ((_e515.member_1 & 2147483648u) != 0u) {
                                        phi_897_ = _e476;
                                        phi_900_ = type_4(0u, ((_e515.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e871 = phi_897_;
                                            let _e873 = phi_900_;
                                            local_11 = _e871;
                                            if (_e873.member < _e873.member_1) {
                                                phi_901_ = type_4((_e873.member + 1u), _e873.member_1);
                                                phi_923_ = type_4(1u, _e873.member);
                                            } else {
                                                phi_901_ = _e873;
                                                phi_923_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e886 = phi_901_;
                                            let _e888 = phi_923_;
                                            let _e892 = (bitcast<i32>(_e888.member) != 0i);
                                            if _e892 {
                                                let _e893 = ((_e515.member_1 & 268435455u) + _e888.member_1);
                                                let _e894 = (_e893 < _e82);
                                                if _e894 {
                                                    if _e894 {
                                                    } else {
                                                        phi_2968_ = true;
                                                        break;
                                                    }
                                                    let _e898 = global_2.member[_e893].member_1;
                                                    phi_944_ = _e898;
                                                } else {
                                                    phi_944_ = 4294967295u;
                                                }
                                                let _e900 = phi_944_;
                                                if (_e893 >= _e82) {
                                                    phi_1033_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e894 {
                                                    } else {
                                                        phi_2968_ = true;
                                                        break;
                                                    }
                                                    if (_e447 < 9u) {
                                                    } else {
                                                        phi_2968_ = true;
                                                        break;
                                                    }
                                                    let _e907 = global_2.member[_e893].member[_e447];
                                                    if (_e451 < 9u) {
                                                    } else {
                                                        phi_2968_ = true;
                                                        break;
                                                    }
                                                    let _e913 = global_2.member[_e893].member[_e451];
                                                    if (_e455 < 9u) {
                                                    } else {
                                                        phi_2968_ = true;
                                                        break;
                                                    }
                                                    let _e919 = global_2.member[_e893].member[_e455];
                                                    let _e921 = (3u + _e447);
                                                    if (_e921 < 9u) {
                                                    } else {
                                                        phi_2968_ = true;
                                                        break;
                                                    }
                                                    let _e927 = global_2.member[_e893].member[_e921];
                                                    let _e928 = (3u + _e451);
                                                    if (_e928 < 9u) {
                                                    } else {
                                                        phi_2968_ = true;
                                                        break;
                                                    }
                                                    let _e934 = global_2.member[_e893].member[_e928];
                                                    let _e935 = (3u + _e455);
                                                    if (_e935 < 9u) {
                                                    } else {
                                                        phi_2968_ = true;
                                                        break;
                                                    }
                                                    let _e941 = global_2.member[_e893].member[_e935];
                                                    let _e943 = (6u + _e447);
                                                    if (_e943 < 9u) {
                                                    } else {
                                                        phi_2968_ = true;
                                                        break;
                                                    }
                                                    let _e949 = global_2.member[_e893].member[_e943];
                                                    let _e950 = (6u + _e451);
                                                    if (_e950 < 9u) {
                                                    } else {
                                                        phi_2968_ = true;
                                                        break;
                                                    }
                                                    let _e956 = global_2.member[_e893].member[_e950];
                                                    let _e957 = (6u + _e455);
                                                    if (_e957 < 9u) {
                                                    } else {
                                                        phi_2968_ = true;
                                                        break;
                                                    }
                                                    let _e963 = global_2.member[_e893].member[_e957];
                                                    phi_1033_ = array<array<f32, 3>, 3>(array<f32, 3>(_e907, _e913, _e919), array<f32, 3>(_e927, _e934, _e941), array<f32, 3>(_e949, _e956, _e963));
                                                }
                                                let _e967 = phi_1033_;
                                                let _e975 = (_e967[0][2] - _e368);
                                                let _e978 = (((_e967[0][0] - _e291) * _e392) - (_e975 * _e316));
                                                let _e981 = (((_e967[0][1] - _e330) * _e392) - (_e975 * _e354));
                                                let _e988 = (_e967[1][2] - _e368);
                                                let _e991 = (((_e967[1][0] - _e291) * _e392) - (_e988 * _e316));
                                                let _e994 = (((_e967[1][1] - _e330) * _e392) - (_e988 * _e354));
                                                let _e1001 = (_e967[2][2] - _e368);
                                                let _e1004 = (((_e967[2][0] - _e291) * _e392) - (_e1001 * _e316));
                                                let _e1007 = (((_e967[2][1] - _e330) * _e392) - (_e1001 * _e354));
                                                let _e1008 = (_e1004 * _e994);
                                                let _e1009 = (_e1007 * _e991);
                                                let _e1010 = (_e978 * _e1007);
                                                let _e1011 = (_e981 * _e1004);
                                                let _e1012 = (_e991 * _e981);
                                                let _e1013 = (_e994 * _e978);
                                                let _e1018 = (((_e1008 >= _e1009) && (_e1010 >= _e1011)) && (_e1012 >= _e1013));
                                                if (_e1018 || (((_e1008 <= _e1009) && (_e1010 <= _e1011)) && (_e1012 <= _e1013))) {
                                                    let _e1025 = select(-1f, 1f, _e1018);
                                                    let _e1027 = ((_e1008 - _e1009) * _e1025);
                                                    let _e1029 = select(0f, _e1027, (_e1027 > 0f));
                                                    let _e1031 = ((_e1010 - _e1011) * _e1025);
                                                    let _e1033 = select(0f, _e1031, (_e1031 > 0f));
                                                    let _e1035 = ((_e1012 - _e1013) * _e1025);
                                                    let _e1037 = select(0f, _e1035, (_e1035 > 0f));
                                                    let _e1039 = ((_e1029 + _e1033) + _e1037);
                                                    if (_e1039 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1858_ = type_22();
                                                        phi_1859_ = true;
                                                        phi_1860_ = false;
                                                    } else {
                                                        let _e1042 = select(_e991, _e978, (_e978 < _e991));
                                                        if (select(_e1004, _e1042, (_e1042 < _e1004)) > 0f) {
                                                            phi_1150_ = true;
                                                        } else {
                                                            let _e1047 = select(_e991, _e978, (_e978 > _e991));
                                                            phi_1150_ = (select(_e1004, _e1047, (_e1047 > _e1004)) < 0f);
                                                        }
                                                        let _e1052 = phi_1150_;
                                                        if _e1052 {
                                                            phi_1855_ = type_22();
                                                            phi_1856_ = true;
                                                            phi_1857_ = false;
                                                        } else {
                                                            let _e1054 = select(_e994, _e981, (_e981 < _e994));
                                                            if (select(_e1007, _e1054, (_e1054 < _e1007)) > 0f) {
                                                                phi_1179_ = true;
                                                            } else {
                                                                let _e1059 = select(_e994, _e981, (_e981 > _e994));
                                                                phi_1179_ = (select(_e1007, _e1059, (_e1059 > _e1007)) < 0f);
                                                            }
                                                            let _e1064 = phi_1179_;
                                                            if _e1064 {
                                                                phi_1853_ = type_22();
                                                                phi_1854_ = false;
                                                            } else {
                                                                let _e1066 = select(_e967[1][0], _e967[0][0], (_e967[0][0] < _e967[1][0]));
                                                                let _e1070 = select(_e967[1][0], _e967[0][0], (_e967[0][0] > _e967[1][0]));
                                                                let _e1074 = select(_e967[1][1], _e967[0][1], (_e967[0][1] < _e967[1][1]));
                                                                let _e1078 = select(_e967[1][1], _e967[0][1], (_e967[0][1] > _e967[1][1]));
                                                                let _e1082 = select(_e967[1][2], _e967[0][2], (_e967[0][2] < _e967[1][2]));
                                                                let _e1086 = select(_e967[1][2], _e967[0][2], (_e967[0][2] > _e967[1][2]));
                                                                let _e1091 = ((select(_e967[2][0], _e1066, (_e1066 < _e967[2][0])) - _e314) * _e319);
                                                                let _e1092 = ((select(_e967[2][0], _e1070, (_e1070 > _e967[2][0])) - _e315) * _e319);
                                                                let _e1095 = ((select(_e967[2][1], _e1074, (_e1074 < _e967[2][1])) - _e352) * _e357);
                                                                let _e1096 = ((select(_e967[2][1], _e1078, (_e1078 > _e967[2][1])) - _e353) * _e357);
                                                                let _e1099 = ((select(_e967[2][2], _e1082, (_e1082 < _e967[2][2])) - _e390) * _e395);
                                                                let _e1100 = ((select(_e967[2][2], _e1086, (_e1086 > _e967[2][2])) - _e391) * _e395);
                                                                let _e1102 = select(_e1100, _e1099, (_e1099 < _e1100));
                                                                let _e1104 = select(_e1100, _e1099, (_e1099 > _e1100));
                                                                let _e1106 = select(_e1092, _e1091, (_e1091 < _e1092));
                                                                let _e1108 = select(_e1096, _e1095, (_e1095 < _e1096));
                                                                let _e1110 = select(_e1108, _e1106, (_e1106 > _e1108));
                                                                let _e1112 = select(_e1102, _e1110, (_e1110 > _e1102));
                                                                let _e1114 = select(_e1092, _e1091, (_e1091 > _e1092));
                                                                let _e1116 = select(_e1096, _e1095, (_e1095 > _e1096));
                                                                let _e1118 = select(_e1116, _e1114, (_e1114 < _e1116));
                                                                let _e1120 = select(_e1104, _e1118, (_e1118 < _e1104));
                                                                let _e1121 = -(_e1102);
                                                                let _e1127 = select(_e442, _e1112, (_e1112 > _e442));
                                                                if (_e1127 > (_e1120 + (select(_e1121, _e1104, (_e1104 > _e1121)) * 0.0000019073523f))) {
                                                                    phi_1848_ = type_22();
                                                                    phi_1849_ = true;
                                                                } else {
                                                                    let _e1129 = (_e1127 > _e871.member_1);
                                                                    if _e1129 {
                                                                        phi_1847_ = type_22();
                                                                    } else {
                                                                        let _e1130 = vec3<f32>(_e967[0][0], _e967[0][1], _e967[0][2]);
                                                                        let _e1131 = vec3<f32>(_e967[1][0], _e967[1][1], _e967[1][2]);
                                                                        let _e1132 = vec3<f32>(_e967[2][0], _e967[2][1], _e967[2][2]);
                                                                        let _e1133 = (_e967[1][0] - _e967[0][0]);
                                                                        let _e1134 = (_e967[1][1] - _e967[0][1]);
                                                                        let _e1135 = (_e967[1][2] - _e967[0][2]);
                                                                        let _e1136 = vec3<f32>(_e1133, _e1134, _e1135);
                                                                        let _e1137 = (_e967[2][0] - _e967[1][0]);
                                                                        let _e1138 = (_e967[2][1] - _e967[1][1]);
                                                                        let _e1139 = (_e967[2][2] - _e967[1][2]);
                                                                        let _e1140 = vec3<f32>(_e1137, _e1138, _e1139);
                                                                        let _e1141 = (_e967[0][0] - _e967[2][0]);
                                                                        let _e1142 = (_e967[0][1] - _e967[2][1]);
                                                                        let _e1143 = (_e967[0][2] - _e967[2][2]);
                                                                        let _e1144 = vec3<f32>(_e1141, _e1142, _e1143);
                                                                        let _e1147 = bitcast<f32>((bitcast<u32>(_e1133) & 2147483647u));
                                                                        let _e1150 = bitcast<f32>((bitcast<u32>(_e1134) & 2147483647u));
                                                                        let _e1152 = select(_e1150, _e1147, (_e1147 > _e1150));
                                                                        let _e1155 = bitcast<f32>((bitcast<u32>(_e1135) & 2147483647u));
                                                                        let _e1157 = select(_e1155, _e1152, (_e1152 > _e1155));
                                                                        let _e1160 = bitcast<f32>((bitcast<u32>(_e1137) & 2147483647u));
                                                                        let _e1163 = bitcast<f32>((bitcast<u32>(_e1138) & 2147483647u));
                                                                        let _e1165 = select(_e1163, _e1160, (_e1160 > _e1163));
                                                                        let _e1168 = bitcast<f32>((bitcast<u32>(_e1139) & 2147483647u));
                                                                        let _e1170 = select(_e1168, _e1165, (_e1165 > _e1168));
                                                                        let _e1173 = bitcast<f32>((bitcast<u32>(_e1141) & 2147483647u));
                                                                        let _e1176 = bitcast<f32>((bitcast<u32>(_e1142) & 2147483647u));
                                                                        let _e1178 = select(_e1176, _e1173, (_e1173 > _e1176));
                                                                        let _e1181 = bitcast<f32>((bitcast<u32>(_e1143) & 2147483647u));
                                                                        let _e1183 = select(_e1181, _e1178, (_e1178 > _e1181));
                                                                        let _e1185 = select(_e1170, _e1157, (_e1157 > _e1170));
                                                                        let _e1187 = select(_e1183, _e1185, (_e1185 > _e1183));
                                                                        if (_e1157 == _e1187) {
                                                                            phi_1580_ = _e994;
                                                                            phi_1581_ = _e991;
                                                                            phi_1582_ = _e981;
                                                                            phi_1583_ = _e978;
                                                                            phi_1584_ = _e1130;
                                                                            phi_1585_ = _e1144;
                                                                            phi_1586_ = _e1140;
                                                                            phi_1587_ = _e1136;
                                                                        } else {
                                                                            let _e1189 = (_e1170 == _e1187);
                                                                            let _e1194 = vec3(_e1189);
                                                                            phi_1580_ = select(_e981, _e1007, _e1189);
                                                                            phi_1581_ = select(_e978, _e1004, _e1189);
                                                                            phi_1582_ = select(_e1007, _e994, _e1189);
                                                                            phi_1583_ = select(_e1004, _e991, _e1189);
                                                                            phi_1584_ = select(_e1132, _e1131, _e1194);
                                                                            phi_1585_ = select(_e1140, _e1136, _e1194);
                                                                            phi_1586_ = select(_e1136, _e1144, _e1194);
                                                                            phi_1587_ = select(_e1144, _e1140, _e1194);
                                                                        }
                                                                        let _e1200 = phi_1580_;
                                                                        let _e1202 = phi_1581_;
                                                                        let _e1204 = phi_1582_;
                                                                        let _e1206 = phi_1583_;
                                                                        let _e1208 = phi_1584_;
                                                                        let _e1210 = phi_1585_;
                                                                        let _e1212 = phi_1586_;
                                                                        let _e1214 = phi_1587_;
                                                                        let _e1221 = ((_e1212.y * _e1210.z) - (_e1210.y * _e1212.z));
                                                                        let _e1226 = ((_e1212.z * _e1210.x) - (_e1210.z * _e1212.x));
                                                                        let _e1229 = ((_e1212.x * _e1210.y) - (_e1210.x * _e1212.y));
                                                                        if (_e1029 >= _e1033) {
                                                                            phi_1618_ = select(true, false, (_e1029 >= _e1037));
                                                                        } else {
                                                                            phi_1618_ = true;
                                                                        }
                                                                        let _e1234 = phi_1618_;
                                                                        if _e1234 {
                                                                            phi_1627_ = select(_e1132, _e1131, vec3((_e1033 >= _e1037)));
                                                                        } else {
                                                                            phi_1627_ = _e1130;
                                                                        }
                                                                        let _e1239 = phi_1627_;
                                                                        let _e1250 = (((_e1221 * (_e1239.x - _e291)) + (_e1226 * (_e1239.y - _e330))) + (_e1229 * (_e1239.z - _e368)));
                                                                        let _e1255 = (((_e1221 * _e316) + (_e1226 * _e354)) + (_e1229 * _e392));
                                                                        let _e1256 = (_e1202 - _e1206);
                                                                        let _e1257 = (_e1200 - _e1204);
                                                                        let _e1265 = (-(((_e1206 * _e1256) + (_e1204 * _e1257))) / ((_e1256 * _e1256) + (_e1257 * _e1257)));
                                                                        let _e1267 = select(1f, _e1265, (_e1265 < 1f));
                                                                        let _e1269 = select(0f, _e1267, (_e1267 > 0f));
                                                                        let _e1282 = ((_e1208.x + (_e1214.x * _e1269)) - _e291);
                                                                        let _e1283 = ((_e1208.y + (_e1214.y * _e1269)) - _e330);
                                                                        let _e1284 = ((_e1208.z + (_e1214.z * _e1269)) - _e368);
                                                                        let _e1285 = (_e1284 / _e392);
                                                                        let _e1297 = bitcast<f32>((bitcast<u32>(_e1282) & 2147483647u));
                                                                        let _e1300 = bitcast<f32>((bitcast<u32>(_e1283) & 2147483647u));
                                                                        let _e1302 = select(_e1300, _e1297, (_e1297 > _e1300));
                                                                        let _e1305 = bitcast<f32>((bitcast<u32>(_e1284) & 2147483647u));
                                                                        let _e1307 = select(_e1305, _e1302, (_e1302 > _e1305));
                                                                        let _e1313 = bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u));
                                                                        let _e1316 = bitcast<f32>((bitcast<u32>(_e1226) & 2147483647u));
                                                                        let _e1318 = select(_e1316, _e1313, (_e1313 > _e1316));
                                                                        let _e1321 = bitcast<f32>((bitcast<u32>(_e1229) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1221 * _e1282) + (_e1226 * _e1283)) + (_e1229 * _e1284)) - _e1250)) & 2147483647u)) <= ((0.0000009536743f * select(_e1187, _e1307, (_e1307 > _e1187))) * select(_e1321, _e1318, (_e1318 > _e1321)))) {
                                                                            let _e1331 = bitcast<f32>((bitcast<u32>(_e1212.x) & 2147483647u));
                                                                            let _e1334 = bitcast<f32>((bitcast<u32>(_e1212.y) & 2147483647u));
                                                                            let _e1336 = select(_e1334, _e1331, (_e1331 > _e1334));
                                                                            let _e1339 = bitcast<f32>((bitcast<u32>(_e1212.z) & 2147483647u));
                                                                            let _e1345 = bitcast<f32>((bitcast<u32>(_e1210.x) & 2147483647u));
                                                                            let _e1348 = bitcast<f32>((bitcast<u32>(_e1210.y) & 2147483647u));
                                                                            let _e1350 = select(_e1348, _e1345, (_e1345 > _e1348));
                                                                            let _e1353 = bitcast<f32>((bitcast<u32>(_e1210.z) & 2147483647u));
                                                                            let _e1357 = (bitcast<f32>((bitcast<u32>(_e1255) & 2147483647u)) > ((0.0000038146973f * select(_e1339, _e1336, (_e1336 > _e1339))) * select(_e1353, _e1350, (_e1350 > _e1353))));
                                                                            if _e1357 {
                                                                                phi_1792_ = (_e1250 / _e1255);
                                                                            } else {
                                                                                phi_1792_ = f32();
                                                                            }
                                                                            let _e1360 = phi_1792_;
                                                                            phi_1794_ = _e1360;
                                                                            phi_1795_ = select(true, false, _e1357);
                                                                        } else {
                                                                            phi_1794_ = f32();
                                                                            phi_1795_ = true;
                                                                        }
                                                                        let _e1363 = phi_1794_;
                                                                        let _e1365 = phi_1795_;
                                                                        if _e1365 {
                                                                            let _e1373 = (((_e1221 * (_e1282 - (_e316 * _e1285))) + (_e1226 * (_e1283 - (_e354 * _e1285)))) / _e1255);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1373) & 2147483647u)) <= _e1187) {
                                                                                phi_1815_ = (_e1285 + _e1373);
                                                                            } else {
                                                                                phi_1815_ = _e1285;
                                                                            }
                                                                            let _e1380 = phi_1815_;
                                                                            phi_1816_ = _e1380;
                                                                        } else {
                                                                            phi_1816_ = _e1363;
                                                                        }
                                                                        let _e1382 = phi_1816_;
                                                                        let _e1384 = select(_e1120, _e1382, (_e1382 < _e1120));
                                                                        let _e1386 = select(_e1112, _e1384, (_e1384 > _e1112));
                                                                        if (_e1386 >= _e442) {
                                                                            let _e1388 = (_e1386 <= _e871.member_1);
                                                                            if _e1388 {
                                                                                let _e1389 = (1f / _e1039);
                                                                                phi_1839_ = type_22(_e1386, (_e1033 * _e1389), (_e1037 * _e1389), _e900);
                                                                            } else {
                                                                                phi_1839_ = type_22();
                                                                            }
                                                                            let _e1394 = phi_1839_;
                                                                            phi_1841_ = _e1394;
                                                                            phi_1842_ = select(true, false, _e1388);
                                                                        } else {
                                                                            phi_1841_ = type_22();
                                                                            phi_1842_ = true;
                                                                        }
                                                                        let _e1397 = phi_1841_;
                                                                        let _e1399 = phi_1842_;
                                                                        if _e1399 {
                                                                            phi_1846_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1846_ = _e1397;
                                                                        }
                                                                        let _e1401 = phi_1846_;
                                                                        phi_1847_ = _e1401;
                                                                    }
                                                                    let _e1403 = phi_1847_;
                                                                    phi_1848_ = _e1403;
                                                                    phi_1849_ = _e1129;
                                                                }
                                                                let _e1405 = phi_1848_;
                                                                let _e1407 = phi_1849_;
                                                                phi_1853_ = _e1405;
                                                                phi_1854_ = _e1407;
                                                            }
                                                            let _e1409 = phi_1853_;
                                                            let _e1411 = phi_1854_;
                                                            phi_1855_ = _e1409;
                                                            phi_1856_ = _e1064;
                                                            phi_1857_ = _e1411;
                                                        }
                                                        let _e1413 = phi_1855_;
                                                        let _e1415 = phi_1856_;
                                                        let _e1417 = phi_1857_;
                                                        phi_1858_ = _e1413;
                                                        phi_1859_ = _e1415;
                                                        phi_1860_ = _e1417;
                                                    }
                                                    let _e1419 = phi_1858_;
                                                    let _e1421 = phi_1859_;
                                                    let _e1423 = phi_1860_;
                                                    phi_1868_ = _e1419;
                                                    phi_1869_ = select(_e1423, true, _e1421);
                                                } else {
                                                    phi_1868_ = type_22();
                                                    phi_1869_ = true;
                                                }
                                                let _e1426 = phi_1868_;
                                                let _e1428 = phi_1869_;
                                                if _e1428 {
                                                    phi_1873_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1873_ = _e1426;
                                                }
                                                let _e1430 = phi_1873_;
                                                if (_e1430.member_3 != 4294967295u) {
                                                    if (_e900 != 4294967295u) {
                                                        if (_e1430.member < _e871.member.member) {
                                                            phi_1899_ = true;
                                                        } else {
                                                            if (_e1430.member == _e871.member.member) {
                                                                phi_1898_ = (_e1430.member_3 < _e871.member.member_3);
                                                            } else {
                                                                phi_1898_ = false;
                                                            }
                                                            let _e1443 = phi_1898_;
                                                            phi_1899_ = _e1443;
                                                        }
                                                        let _e1445 = phi_1899_;
                                                        if _e1445 {
                                                            phi_1905_ = type_33(_e1430, _e1430.member);
                                                        } else {
                                                            phi_1905_ = _e871;
                                                        }
                                                        let _e1448 = phi_1905_;
                                                        phi_1906_ = _e1448;
                                                    } else {
                                                        phi_1906_ = _e871;
                                                    }
                                                    let _e1450 = phi_1906_;
                                                    phi_1907_ = _e1450;
                                                } else {
                                                    phi_1907_ = _e871;
                                                }
                                                let _e1452 = phi_1907_;
                                                phi_898_ = _e1452;
                                            } else {
                                                phi_898_ = type_33();
                                            }
                                            let _e1454 = phi_898_;
                                            continue;
                                            continuing {
                                                phi_897_ = _e1454;
                                                phi_900_ = _e886;
                                                phi_2968_ = _e474;
                                                break if !(_e892);
                                            }
                                        }
                                        let _e1457 = phi_2968_;
                                        phi_3110_ = _e1457;
                                        if _e1457 {
                                            break;
                                        }
                                        phi_3114_ = _e1457;
                                        let _e1644 = local_11;
                                        phi_2856_ = _e1644;
                                        phi_2857_ = _e515;
                                        phi_2858_ = false;
                                        phi_2859_ = _e519;
                                    } else {
                                        let _e528 = (_e515.member_1 < _e80);
                                        if _e528 {
                                            if _e528 {
                                            } else {
                                                phi_3110_ = true;
                                                break;
                                            }
                                            let _e530 = global_5.member[_e515.member_1];
                                            phi_1926_ = _e530;
                                        } else {
                                            phi_1926_ = type_42(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e532 = phi_1926_;
                                        let _e547 = ((10u * _e242) & 31u);
                                        let _e550 = ((_e532.member[0] >> bitcast<u32>(_e547)) & 1023u);
                                        let _e555 = bitcast<f32>((bitcast<u32>(((_e515.member.member_1[0] - _e515.member.member[0]) * 0.0009775171f)) ^ _e114));
                                        let _e561 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e550) * _e555)) ^ _e114)));
                                        let _e565 = select(select(_e515.member.member_1[0], _e561, (_e561 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e550 == 1023u));
                                        let _e567 = ((10u * _e241) & 31u);
                                        let _e570 = ((_e532.member[0] >> bitcast<u32>(_e567)) & 1023u);
                                        let _e575 = bitcast<f32>((bitcast<u32>(((_e515.member.member_1[1] - _e515.member.member[1]) * 0.0009775171f)) ^ _e114));
                                        let _e581 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e570) * _e575)) ^ _e114)));
                                        let _e585 = select(select(_e515.member.member_1[1], _e581, (_e581 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e570 == 1023u));
                                        let _e587 = ((10u * _e243) & 31u);
                                        let _e590 = ((_e532.member[0] >> bitcast<u32>(_e587)) & 1023u);
                                        let _e595 = bitcast<f32>((bitcast<u32>(((_e515.member.member_1[2] - _e515.member.member[2]) * 0.0009775171f)) ^ _e114));
                                        let _e601 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e590) * _e595)) ^ _e114)));
                                        let _e605 = select(select(_e515.member.member_1[2], _e601, (_e601 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e590 == 1023u));
                                        let _e608 = ((_e532.member[1] >> bitcast<u32>(_e547)) & 1023u);
                                        let _e614 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e608) * _e555)) ^ _e114)));
                                        let _e618 = select(select(_e515.member.member_1[0], _e614, (_e614 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e608 == 1023u));
                                        let _e621 = ((_e532.member[1] >> bitcast<u32>(_e567)) & 1023u);
                                        let _e627 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e621) * _e575)) ^ _e114)));
                                        let _e631 = select(select(_e515.member.member_1[1], _e627, (_e627 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e621 == 1023u));
                                        let _e634 = ((_e532.member[1] >> bitcast<u32>(_e587)) & 1023u);
                                        let _e640 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e634) * _e595)) ^ _e114)));
                                        let _e644 = select(select(_e515.member.member_1[2], _e640, (_e640 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e634 == 1023u));
                                        let _e650 = ((_e532.member_1[0] >> bitcast<u32>(_e547)) & 1023u);
                                        let _e656 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e650) * _e555)) ^ _e114)));
                                        let _e660 = select(select(_e515.member.member_1[0], _e656, (_e656 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e650 == 1023u));
                                        let _e663 = ((_e532.member_1[0] >> bitcast<u32>(_e567)) & 1023u);
                                        let _e669 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e663) * _e575)) ^ _e114)));
                                        let _e673 = select(select(_e515.member.member_1[1], _e669, (_e669 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e663 == 1023u));
                                        let _e676 = ((_e532.member_1[0] >> bitcast<u32>(_e587)) & 1023u);
                                        let _e682 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e676) * _e595)) ^ _e114)));
                                        let _e686 = select(select(_e515.member.member_1[2], _e682, (_e682 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e676 == 1023u));
                                        let _e689 = ((_e532.member_1[1] >> bitcast<u32>(_e547)) & 1023u);
                                        let _e695 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e689) * _e555)) ^ _e114)));
                                        let _e699 = select(select(_e515.member.member_1[0], _e695, (_e695 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e689 == 1023u));
                                        let _e702 = ((_e532.member_1[1] >> bitcast<u32>(_e567)) & 1023u);
                                        let _e708 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e702) * _e575)) ^ _e114)));
                                        let _e712 = select(select(_e515.member.member_1[1], _e708, (_e708 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e702 == 1023u));
                                        let _e715 = ((_e532.member_1[1] >> bitcast<u32>(_e587)) & 1023u);
                                        let _e721 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e715) * _e595)) ^ _e114)));
                                        let _e725 = select(select(_e515.member.member_1[2], _e721, (_e721 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e715 == 1023u));
                                        let _e730 = type_49(type_47(array<f32, 3>(_e565, _e585, _e605), array<f32, 3>(_e618, _e631, _e644)), _e532.member_2);
                                        let _e735 = type_49(type_47(array<f32, 3>(_e660, _e673, _e686), array<f32, 3>(_e699, _e712, _e725)), _e532.member_3);
                                        let _e741 = ((_e565 - _e314) * _e319);
                                        let _e742 = ((_e660 - _e314) * _e319);
                                        let _e743 = ((_e618 - _e315) * _e319);
                                        let _e744 = ((_e699 - _e315) * _e319);
                                        let _e749 = ((_e585 - _e352) * _e357);
                                        let _e750 = ((_e673 - _e352) * _e357);
                                        let _e751 = ((_e631 - _e353) * _e357);
                                        let _e752 = ((_e712 - _e353) * _e357);
                                        let _e757 = ((_e605 - _e390) * _e395);
                                        let _e758 = ((_e686 - _e390) * _e395);
                                        let _e759 = ((_e644 - _e391) * _e395);
                                        let _e760 = ((_e725 - _e391) * _e395);
                                        let _e762 = select(_e759, _e757, (_e757 < _e759));
                                        let _e764 = select(_e760, _e758, (_e758 < _e760));
                                        let _e766 = select(_e759, _e757, (_e757 > _e759));
                                        let _e768 = select(_e760, _e758, (_e758 > _e760));
                                        let _e770 = select(_e743, _e741, (_e741 < _e743));
                                        let _e772 = select(_e744, _e742, (_e742 < _e744));
                                        let _e774 = select(_e751, _e749, (_e749 < _e751));
                                        let _e776 = select(_e752, _e750, (_e750 < _e752));
                                        let _e778 = select(_e774, _e770, (_e770 > _e774));
                                        let _e780 = select(_e776, _e772, (_e772 > _e776));
                                        let _e782 = select(_e762, _e778, (_e778 > _e762));
                                        let _e784 = select(_e764, _e780, (_e780 > _e764));
                                        let _e786 = select(_e743, _e741, (_e741 > _e743));
                                        let _e788 = select(_e744, _e742, (_e742 > _e744));
                                        let _e790 = select(_e751, _e749, (_e749 > _e751));
                                        let _e792 = select(_e752, _e750, (_e750 > _e752));
                                        let _e794 = select(_e790, _e786, (_e786 < _e790));
                                        let _e796 = select(_e792, _e788, (_e788 < _e792));
                                        let _e801 = -(_e762);
                                        let _e802 = -(_e764);
                                        let _e809 = (select(_e766, _e794, (_e794 < _e766)) + (select(_e801, _e766, (_e766 > _e801)) * 0.0000019073523f));
                                        let _e810 = (select(_e768, _e796, (_e796 < _e768)) + (select(_e802, _e768, (_e768 > _e802)) * 0.0000019073523f));
                                        let _e812 = select(_e442, _e782, (_e782 > _e442));
                                        let _e814 = select(_e442, _e784, (_e784 > _e442));
                                        let _e819 = (_e812 <= select(_e476.member_1, _e809, (_e809 < _e476.member_1)));
                                        let _e820 = (_e814 <= select(_e476.member_1, _e810, (_e810 < _e476.member_1)));
                                        let _e821 = (_e812 <= _e814);
                                        if _e819 {
                                            if _e820 {
                                                if _e821 {
                                                    phi_2758_ = _e735;
                                                } else {
                                                    phi_2758_ = _e730;
                                                }
                                                let _e823 = phi_2758_;
                                                let _e831 = (_e519 % 128u);
                                                let _e832 = (_e831 < 128u);
                                                if _e832 {
                                                } else {
                                                    phi_3110_ = true;
                                                    break;
                                                }
                                                local_6[_e831] = _e823.member_1;
                                                if _e832 {
                                                } else {
                                                    phi_3110_ = true;
                                                    break;
                                                }
                                                local_5[_e831] = _e823.member.member[0];
                                                if _e832 {
                                                } else {
                                                    phi_3110_ = true;
                                                    break;
                                                }
                                                local_4[_e831] = _e823.member.member[1];
                                                if _e832 {
                                                } else {
                                                    phi_3110_ = true;
                                                    break;
                                                }
                                                local_3[_e831] = _e823.member.member[2];
                                                if _e832 {
                                                } else {
                                                    phi_3110_ = true;
                                                    break;
                                                }
                                                local_2[_e831] = _e823.member.member_1[0];
                                                if _e832 {
                                                } else {
                                                    phi_3110_ = true;
                                                    break;
                                                }
                                                local_1[_e831] = _e823.member.member_1[1];
                                                if _e832 {
                                                } else {
                                                    phi_3110_ = true;
                                                    break;
                                                }
                                                local[_e831] = _e823.member.member_1[2];
                                                if _e832 {
                                                } else {
                                                    phi_3110_ = true;
                                                    break;
                                                }
                                                local_7[_e831] = select(_e814, _e812, (_e812 > _e814));
                                                if _e821 {
                                                    phi_2835_ = _e730;
                                                } else {
                                                    phi_2835_ = _e735;
                                                }
                                                let _e849 = phi_2835_;
                                                phi_2836_ = _e849;
                                                phi_2837_ = (_e519 + 1u);
                                            } else {
                                                phi_2836_ = type_49();
                                                phi_2837_ = u32();
                                            }
                                            let _e851 = phi_2836_;
                                            let _e853 = phi_2837_;
                                            phi_2839_ = _e851;
                                            phi_2840_ = _e853;
                                            phi_2841_ = select(true, false, _e820);
                                        } else {
                                            phi_2839_ = type_49();
                                            phi_2840_ = u32();
                                            phi_2841_ = true;
                                        }
                                        let _e856 = phi_2839_;
                                        let _e858 = phi_2840_;
                                        let _e860 = phi_2841_;
                                        if _e860 {
                                            if _e819 {
                                                phi_2848_ = _e730;
                                            } else {
                                                phi_2848_ = _e735;
                                            }
                                            let _e862 = phi_2848_;
                                            phi_2853_ = _e862;
                                            phi_2854_ = select(_e820, true, _e819);
                                        } else {
                                            phi_2853_ = _e856;
                                            phi_2854_ = _e517;
                                        }
                                        let _e865 = phi_2853_;
                                        let _e867 = phi_2854_;
                                        phi_3114_ = _e474;
                                        phi_2856_ = _e476;
                                        phi_2857_ = _e865;
                                        phi_2858_ = _e867;
                                        phi_2859_ = select(_e858, _e519, _e860);
                                    }
                                    let _e1459 = phi_3114_;
                                    let _e1461 = phi_2856_;
                                    let _e1463 = phi_2857_;
                                    let _e1465 = phi_2858_;
                                    let _e1467 = phi_2859_;
                                    phi_3113_ = _e1459;
                                    phi_2860_ = _e1461;
                                    phi_2861_ = _e1463;
                                    phi_2862_ = (_e480 - 1u);
                                    phi_2863_ = _e1465;
                                    phi_2864_ = _e1467;
                                } else {
                                    phi_3113_ = _e474;
                                    phi_2860_ = _e476;
                                    phi_2861_ = _e515;
                                    phi_2862_ = _e480;
                                    phi_2863_ = _e517;
                                    phi_2864_ = _e519;
                                }
                                let _e1469 = phi_3113_;
                                let _e1471 = phi_2860_;
                                let _e1473 = phi_2861_;
                                let _e1475 = phi_2862_;
                                let _e1477 = phi_2863_;
                                let _e1479 = phi_2864_;
                                phi_3112_ = _e1469;
                                phi_2865_ = _e1471;
                                phi_2866_ = _e1473;
                                phi_2867_ = _e1475;
                                phi_2868_ = _e1477;
                                phi_2869_ = _e1479;
                            } else {
                                phi_3112_ = _e474;
                                phi_2865_ = type_33();
                                phi_2866_ = type_49();
                                phi_2867_ = u32();
                                phi_2868_ = bool();
                                phi_2869_ = u32();
                            }
                            let _e1481 = phi_3112_;
                            let _e1483 = phi_2865_;
                            let _e1485 = phi_2866_;
                            let _e1487 = phi_2867_;
                            let _e1489 = phi_2868_;
                            let _e1491 = phi_2869_;
                            phi_3111_ = _e1481;
                            phi_772_ = _e1483;
                            phi_775_ = _e1485;
                            phi_777_ = _e1487;
                            phi_779_ = _e1489;
                            phi_781_ = _e1491;
                            phi_2870_ = _e488;
                        } else {
                            phi_3111_ = _e474;
                            phi_772_ = type_33();
                            phi_775_ = type_49();
                            phi_777_ = u32();
                            phi_779_ = bool();
                            phi_781_ = u32();
                            phi_2870_ = false;
                        }
                        let _e1493 = phi_3111_;
                        let _e1495 = phi_772_;
                        let _e1497 = phi_775_;
                        let _e1499 = phi_777_;
                        let _e1501 = phi_779_;
                        let _e1503 = phi_781_;
                        let _e1505 = phi_2870_;
                        continue;
                        continuing {
                            phi_2974_ = _e1493;
                            phi_771_ = _e1495;
                            phi_774_ = _e1497;
                            phi_776_ = _e1499;
                            phi_778_ = _e1501;
                            phi_780_ = _e1503;
                            phi_3110_ = _e1493;
                            break if !(_e1505);
                        }
                    }
                    let _e1508 = phi_3110_;
                    if _e1508 {
                        break;
                    }
                    let _e1510 = local_10;
                    if (_e1510.member.member_3 != 4294967295u) {
                        let _e1515 = -(_e409);
                        let _e1516 = (_e1515 / 3i);
                        let _e1523 = bitcast<f32>((bitcast<u32>((_e1516 + 127i)) << bitcast<u32>(23i)));
                        let _e1531 = (((_e1510.member.member * _e1523) * _e1523) * bitcast<f32>((bitcast<u32>(((_e1515 - (2i * _e1516)) + 127i)) << bitcast<u32>(23i))));
                        let _e1533 = select(340282350000000000000000000000000000000f, _e1531, (_e1531 < 340282350000000000000000000000000000000f));
                        phi_2922_ = type_22(select(-340282350000000000000000000000000000000f, _e1533, (_e1533 > -340282350000000000000000000000000000000f)), _e1510.member.member_1, _e1510.member.member_2, _e1510.member.member_3);
                    } else {
                        phi_2922_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1540 = phi_2922_;
                    if _e130 {
                    } else {
                        break;
                    }
                    global_6.member[_e128] = _e1540;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
