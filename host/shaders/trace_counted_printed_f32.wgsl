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

struct type_21 {
    member: array<array<u32, 2>>,
}

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: type_25,
    member_1: f32,
}

struct type_36 {
    member: array<type_26>,
}

struct type_38 {
    member: type_32,
    member_1: u32,
    member_2: u32,
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
var<storage> global_4: type_36;
@group(0) @binding(2) 
var<storage> global_5: type_44;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_21;

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
    var phi_330_: i32;
    var phi_331_: i32;
    var phi_341_: bool;
    var phi_351_: u32;
    var phi_352_: u32;
    var phi_354_: bool;
    var phi_359_: u32;
    var phi_371_: i32;
    var phi_391_: i32;
    var phi_409_: f32;
    var phi_415_: f32;
    var phi_426_: f32;
    var phi_432_: f32;
    var phi_455_: f32;
    var phi_466_: f32;
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
    var phi_698_: f32;
    var phi_699_: f32;
    var phi_2939_: bool;
    var phi_773_: type_38;
    var phi_776_: type_49;
    var phi_778_: u32;
    var phi_780_: bool;
    var phi_782_: u32;
    var phi_793_: bool;
    var phi_879_: type_49;
    var phi_880_: bool;
    var phi_881_: u32;
    var phi_1935_: type_42;
    var phi_2767_: type_49;
    var phi_2844_: type_49;
    var phi_2845_: type_49;
    var phi_2846_: u32;
    var phi_2848_: type_49;
    var phi_2849_: u32;
    var phi_2850_: bool;
    var phi_2857_: type_49;
    var phi_2862_: type_49;
    var phi_2863_: bool;
    var phi_899_: type_38;
    var phi_902_: type_4;
    var phi_903_: type_4;
    var phi_925_: type_4;
    var phi_949_: u32;
    var phi_1038_: array<array<f32, 3>, 3>;
    var phi_1155_: bool;
    var phi_1184_: bool;
    var phi_1585_: f32;
    var phi_1586_: f32;
    var phi_1587_: f32;
    var phi_1588_: f32;
    var phi_1589_: vec3<f32>;
    var phi_1590_: vec3<f32>;
    var phi_1591_: vec3<f32>;
    var phi_1592_: vec3<f32>;
    var phi_1623_: bool;
    var phi_1632_: vec3<f32>;
    var phi_1797_: f32;
    var phi_1799_: f32;
    var phi_1800_: bool;
    var phi_1820_: f32;
    var phi_1821_: f32;
    var phi_1844_: type_25;
    var phi_1846_: type_25;
    var phi_1847_: bool;
    var phi_1851_: type_25;
    var phi_1852_: type_25;
    var phi_1853_: type_25;
    var phi_1854_: bool;
    var phi_1858_: type_25;
    var phi_1859_: bool;
    var phi_1860_: type_25;
    var phi_1861_: bool;
    var phi_1862_: bool;
    var phi_1863_: type_25;
    var phi_1864_: bool;
    var phi_1865_: bool;
    var phi_1873_: type_25;
    var phi_1874_: bool;
    var phi_1878_: type_25;
    var phi_1903_: bool;
    var phi_1904_: bool;
    var phi_1911_: type_38;
    var phi_1912_: type_38;
    var phi_1913_: type_38;
    var phi_900_: type_38;
    var phi_2933_: bool;
    var phi_3079_: bool;
    var phi_2865_: type_38;
    var phi_2866_: type_49;
    var phi_2867_: bool;
    var phi_2868_: u32;
    var phi_3078_: bool;
    var phi_2869_: type_38;
    var phi_2870_: type_49;
    var phi_2871_: u32;
    var phi_2872_: bool;
    var phi_2873_: u32;
    var phi_3077_: bool;
    var phi_2874_: type_38;
    var phi_2875_: type_49;
    var phi_2876_: u32;
    var phi_2877_: bool;
    var phi_2878_: u32;
    var phi_3076_: bool;
    var phi_774_: type_38;
    var phi_777_: type_49;
    var phi_779_: u32;
    var phi_781_: bool;
    var phi_783_: u32;
    var phi_2879_: bool;
    var phi_3075_: bool;
    var local_10: type_38;
    var local_11: type_38;
    var local_12: type_38;

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
                            phi_330_ = (bitcast<i32>((_e207 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_330_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e207)), 32u, (_e207 == 0u))));
                        }
                        let _e221 = phi_330_;
                        phi_331_ = _e221;
                    } else {
                        phi_331_ = 0i;
                    }
                    let _e223 = phi_331_;
                    let _e224 = (_e140 == _e179);
                    if _e224 {
                        phi_341_ = true;
                    } else {
                        phi_341_ = (_e147 == _e179);
                    }
                    let _e227 = phi_341_;
                    let _e228 = select(1u, 0u, _e224);
                    if _e227 {
                        let _e229 = (_e228 + 1u);
                        phi_351_ = _e229;
                        phi_352_ = _e229;
                        phi_354_ = select(true, false, (_e229 == 2u));
                    } else {
                        phi_351_ = u32();
                        phi_352_ = 0u;
                        phi_354_ = true;
                    }
                    let _e233 = phi_351_;
                    let _e235 = phi_352_;
                    let _e237 = phi_354_;
                    if _e237 {
                        phi_359_ = (_e235 + 1u);
                    } else {
                        phi_359_ = 0u;
                    }
                    let _e241 = phi_359_;
                    let _e242 = select(_e233, _e235, _e237);
                    let _e243 = select(_e228, select(2u, _e228, _e227), _e237);
                    if (_e118 < -126i) {
                        phi_371_ = -126i;
                    } else {
                        phi_371_ = select(_e118, 127i, (_e118 > 127i));
                    }
                    let _e248 = phi_371_;
                    let _e253 = bitcast<f32>((bitcast<u32>((_e248 + 127i)) << bitcast<u32>(23i)));
                    let _e259 = bitcast<f32>((bitcast<u32>(((_e118 - _e248) + 127i)) << bitcast<u32>(23i)));
                    let _e260 = -(_e223);
                    if (_e260 < -126i) {
                        phi_391_ = -126i;
                    } else {
                        phi_391_ = select(_e260, 127i, (_e260 > 127i));
                    }
                    let _e265 = phi_391_;
                    let _e270 = bitcast<f32>((bitcast<u32>((_e265 + 127i)) << bitcast<u32>(23i)));
                    let _e276 = bitcast<f32>((bitcast<u32>(((_e260 - _e265) + 127i)) << bitcast<u32>(23i)));
                    let _e280 = global_4.member[_e128].member;
                    let _e281 = (_e242 == 0u);
                    if _e281 {
                        phi_409_ = _e280[0];
                    } else {
                        phi_409_ = _e280[1];
                    }
                    let _e285 = phi_409_;
                    let _e286 = (_e242 == 2u);
                    if _e286 {
                        phi_415_ = _e280[2];
                    } else {
                        phi_415_ = _e285;
                    }
                    let _e289 = phi_415_;
                    let _e291 = ((_e289 * _e253) * _e259);
                    let _e292 = global_4.member[_e128].member_2;
                    if _e281 {
                        phi_426_ = _e292[0];
                    } else {
                        phi_426_ = _e292[1];
                    }
                    let _e296 = phi_426_;
                    if _e286 {
                        phi_432_ = _e292[2];
                    } else {
                        phi_432_ = _e296;
                    }
                    let _e299 = phi_432_;
                    let _e301 = ((_e299 * _e270) * _e276);
                    let _e305 = (bitcast<f32>((bitcast<u32>(_e301) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e305 {
                        let _e309 = (bitcast<f32>((bitcast<u32>(_e291) & 2147483647u)) * 0.00000011920929f);
                        phi_455_ = select(0.00000000000011368684f, _e309, (_e309 > 0.00000000000011368684f));
                    } else {
                        phi_455_ = 0f;
                    }
                    let _e313 = phi_455_;
                    let _e314 = (_e291 + _e313);
                    let _e315 = (_e291 - _e313);
                    let _e316 = select(_e301, 0f, _e305);
                    if _e305 {
                        phi_466_ = 38685626000000000000000000f;
                    } else {
                        phi_466_ = (1f / _e301);
                    }
                    let _e319 = phi_466_;
                    let _e320 = (_e241 == 0u);
                    if _e320 {
                        phi_475_ = _e280[0];
                    } else {
                        phi_475_ = _e280[1];
                    }
                    let _e324 = phi_475_;
                    let _e325 = (_e241 == 2u);
                    if _e325 {
                        phi_481_ = _e280[2];
                    } else {
                        phi_481_ = _e324;
                    }
                    let _e328 = phi_481_;
                    let _e330 = ((_e328 * _e253) * _e259);
                    if _e320 {
                        phi_492_ = _e292[0];
                    } else {
                        phi_492_ = _e292[1];
                    }
                    let _e334 = phi_492_;
                    if _e325 {
                        phi_498_ = _e292[2];
                    } else {
                        phi_498_ = _e334;
                    }
                    let _e337 = phi_498_;
                    let _e339 = ((_e337 * _e270) * _e276);
                    let _e343 = (bitcast<f32>((bitcast<u32>(_e339) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e343 {
                        let _e347 = (bitcast<f32>((bitcast<u32>(_e330) & 2147483647u)) * 0.00000011920929f);
                        phi_521_ = select(0.00000000000011368684f, _e347, (_e347 > 0.00000000000011368684f));
                    } else {
                        phi_521_ = 0f;
                    }
                    let _e351 = phi_521_;
                    let _e352 = (_e330 + _e351);
                    let _e353 = (_e330 - _e351);
                    let _e354 = select(_e339, 0f, _e343);
                    if _e343 {
                        phi_532_ = 38685626000000000000000000f;
                    } else {
                        phi_532_ = (1f / _e339);
                    }
                    let _e357 = phi_532_;
                    let _e358 = (_e243 == 0u);
                    if _e358 {
                        phi_541_ = _e280[0];
                    } else {
                        phi_541_ = _e280[1];
                    }
                    let _e362 = phi_541_;
                    let _e363 = (_e243 == 2u);
                    if _e363 {
                        phi_547_ = _e280[2];
                    } else {
                        phi_547_ = _e362;
                    }
                    let _e366 = phi_547_;
                    let _e368 = ((_e366 * _e253) * _e259);
                    if _e358 {
                        phi_558_ = _e292[0];
                    } else {
                        phi_558_ = _e292[1];
                    }
                    let _e372 = phi_558_;
                    if _e363 {
                        phi_564_ = _e292[2];
                    } else {
                        phi_564_ = _e372;
                    }
                    let _e375 = phi_564_;
                    let _e377 = ((_e375 * _e270) * _e276);
                    let _e381 = (bitcast<f32>((bitcast<u32>(_e377) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e381 {
                        let _e385 = (bitcast<f32>((bitcast<u32>(_e368) & 2147483647u)) * 0.00000011920929f);
                        phi_587_ = select(0.00000000000011368684f, _e385, (_e385 > 0.00000000000011368684f));
                    } else {
                        phi_587_ = 0f;
                    }
                    let _e389 = phi_587_;
                    let _e390 = (_e368 + _e389);
                    let _e391 = (_e368 - _e389);
                    let _e392 = select(_e377, 0f, _e381);
                    if _e381 {
                        phi_598_ = 38685626000000000000000000f;
                    } else {
                        phi_598_ = (1f / _e377);
                    }
                    let _e395 = phi_598_;
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
                        phi_698_ = select(-340282350000000000000000000000000000000f, _e436, (_e436 > -340282350000000000000000000000000000000f));
                        phi_699_ = select(-340282350000000000000000000000000000000f, _e429, (_e429 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_698_ = 0f;
                        phi_699_ = 1f;
                    }
                    let _e440 = phi_698_;
                    let _e442 = phi_699_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e90), bitcast<f32>(_e94), bitcast<f32>(_e98));
                    let _e448 = (_e242 % 3u);
                    let _e449 = (_e448 < 3u);
                    if _e449 {
                    } else {
                        break;
                    }
                    let _e451 = local_9[_e448];
                    let _e452 = (_e241 % 3u);
                    let _e453 = (_e452 < 3u);
                    if _e453 {
                    } else {
                        break;
                    }
                    let _e455 = local_9[_e452];
                    let _e456 = (_e243 % 3u);
                    let _e457 = (_e456 < 3u);
                    if _e457 {
                    } else {
                        break;
                    }
                    let _e459 = local_9[_e456];
                    local_8 = array<f32, 3>(bitcast<f32>(_e102), bitcast<f32>(_e106), bitcast<f32>(_e110));
                    if _e449 {
                    } else {
                        break;
                    }
                    let _e463 = local_8[_e448];
                    if _e453 {
                    } else {
                        break;
                    }
                    let _e465 = local_8[_e452];
                    if _e457 {
                    } else {
                        break;
                    }
                    let _e467 = local_8[_e456];
                    phi_2939_ = false;
                    phi_773_ = type_38(type_32(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e440), 0u, 0u);
                    phi_776_ = type_49(type_47(array<f32, 3>(_e451, _e455, _e459), array<f32, 3>(_e463, _e465, _e467)), select(0u, 2147483648u, (_e80 == 0u)));
                    phi_778_ = ((3u * _e80) + 1u);
                    phi_780_ = (_e442 <= _e440);
                    phi_782_ = 0u;
                    loop {
                        let _e475 = phi_2939_;
                        let _e477 = phi_773_;
                        let _e479 = phi_776_;
                        let _e481 = phi_778_;
                        let _e483 = phi_780_;
                        let _e485 = phi_782_;
                        local_10 = _e477;
                        local_11 = _e477;
                        if _e483 {
                            phi_793_ = true;
                        } else {
                            phi_793_ = (_e485 > 0u);
                        }
                        let _e488 = phi_793_;
                        if _e488 {
                            let _e489 = (_e481 > 0u);
                            if _e489 {
                                if _e483 {
                                    phi_879_ = _e479;
                                    phi_880_ = _e483;
                                    phi_881_ = _e485;
                                } else {
                                    let _e490 = (_e485 - 1u);
                                    let _e491 = (_e490 % 128u);
                                    let _e492 = (_e491 < 128u);
                                    if _e492 {
                                    } else {
                                        phi_3075_ = true;
                                        break;
                                    }
                                    let _e494 = local_6[_e491];
                                    if _e492 {
                                    } else {
                                        phi_3075_ = true;
                                        break;
                                    }
                                    let _e496 = local_5[_e491];
                                    if _e492 {
                                    } else {
                                        phi_3075_ = true;
                                        break;
                                    }
                                    let _e498 = local_4[_e491];
                                    if _e492 {
                                    } else {
                                        phi_3075_ = true;
                                        break;
                                    }
                                    let _e500 = local_3[_e491];
                                    if _e492 {
                                    } else {
                                        phi_3075_ = true;
                                        break;
                                    }
                                    let _e503 = local_2[_e491];
                                    if _e492 {
                                    } else {
                                        phi_3075_ = true;
                                        break;
                                    }
                                    let _e505 = local_1[_e491];
                                    if _e492 {
                                    } else {
                                        phi_3075_ = true;
                                        break;
                                    }
                                    let _e507 = local[_e491];
                                    if _e492 {
                                    } else {
                                        phi_3075_ = true;
                                        break;
                                    }
                                    let _e512 = local_7[_e491];
                                    phi_879_ = type_49(type_47(array<f32, 3>(_e496, _e498, _e500), array<f32, 3>(_e503, _e505, _e507)), _e494);
                                    phi_880_ = (_e512 <= _e477.member.member_1);
                                    phi_881_ = _e490;
                                }
                                let _e517 = phi_879_;
                                let _e519 = phi_880_;
                                let _e521 = phi_881_;
                                if _e519 {
                                    if ((_e517.member_1 & 2147483648u) != 0u) {
                                        phi_899_ = _e477;
                                        phi_902_ = type_4(0u, ((_e517.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e880 = phi_899_;
                                            let _e882 = phi_902_;
                                            local_12 = _e880;
                                            if (_e882.member < _e882.member_1) {
                                                phi_903_ = type_4((_e882.member + 1u), _e882.member_1);
                                                phi_925_ = type_4(1u, _e882.member);
                                            } else {
                                                phi_903_ = _e882;
                                                phi_925_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e895 = phi_903_;
                                            let _e897 = phi_925_;
                                            let _e901 = (bitcast<i32>(_e897.member) != 0i);
                                            if _e901 {
                                                let _e907 = type_38(_e880.member, _e880.member_1, (_e880.member_2 + 1u));
                                                let _e908 = ((_e517.member_1 & 268435455u) + _e897.member_1);
                                                let _e909 = (_e908 < _e82);
                                                if _e909 {
                                                    if _e909 {
                                                    } else {
                                                        phi_2933_ = true;
                                                        break;
                                                    }
                                                    let _e913 = global_2.member[_e908].member_1;
                                                    phi_949_ = _e913;
                                                } else {
                                                    phi_949_ = 4294967295u;
                                                }
                                                let _e915 = phi_949_;
                                                if (_e908 >= _e82) {
                                                    phi_1038_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e909 {
                                                    } else {
                                                        phi_2933_ = true;
                                                        break;
                                                    }
                                                    if (_e448 < 9u) {
                                                    } else {
                                                        phi_2933_ = true;
                                                        break;
                                                    }
                                                    let _e922 = global_2.member[_e908].member[_e448];
                                                    if (_e452 < 9u) {
                                                    } else {
                                                        phi_2933_ = true;
                                                        break;
                                                    }
                                                    let _e928 = global_2.member[_e908].member[_e452];
                                                    if (_e456 < 9u) {
                                                    } else {
                                                        phi_2933_ = true;
                                                        break;
                                                    }
                                                    let _e934 = global_2.member[_e908].member[_e456];
                                                    let _e936 = (3u + _e448);
                                                    if (_e936 < 9u) {
                                                    } else {
                                                        phi_2933_ = true;
                                                        break;
                                                    }
                                                    let _e942 = global_2.member[_e908].member[_e936];
                                                    let _e943 = (3u + _e452);
                                                    if (_e943 < 9u) {
                                                    } else {
                                                        phi_2933_ = true;
                                                        break;
                                                    }
                                                    let _e949 = global_2.member[_e908].member[_e943];
                                                    let _e950 = (3u + _e456);
                                                    if (_e950 < 9u) {
                                                    } else {
                                                        phi_2933_ = true;
                                                        break;
                                                    }
                                                    let _e956 = global_2.member[_e908].member[_e950];
                                                    let _e958 = (6u + _e448);
                                                    if (_e958 < 9u) {
                                                    } else {
                                                        phi_2933_ = true;
                                                        break;
                                                    }
                                                    let _e964 = global_2.member[_e908].member[_e958];
                                                    let _e965 = (6u + _e452);
                                                    if (_e965 < 9u) {
                                                    } else {
                                                        phi_2933_ = true;
                                                        break;
                                                    }
                                                    let _e971 = global_2.member[_e908].member[_e965];
                                                    let _e972 = (6u + _e456);
                                                    if (_e972 < 9u) {
                                                    } else {
                                                        phi_2933_ = true;
                                                        break;
                                                    }
                                                    let _e978 = global_2.member[_e908].member[_e972];
                                                    phi_1038_ = array<array<f32, 3>, 3>(array<f32, 3>(_e922, _e928, _e934), array<f32, 3>(_e942, _e949, _e956), array<f32, 3>(_e964, _e971, _e978));
                                                }
                                                let _e982 = phi_1038_;
                                                let _e991 = (_e982[0][2] - _e368);
                                                let _e994 = (((_e982[0][0] - _e291) * _e392) - (_e991 * _e316));
                                                let _e997 = (((_e982[0][1] - _e330) * _e392) - (_e991 * _e354));
                                                let _e1004 = (_e982[1][2] - _e368);
                                                let _e1007 = (((_e982[1][0] - _e291) * _e392) - (_e1004 * _e316));
                                                let _e1010 = (((_e982[1][1] - _e330) * _e392) - (_e1004 * _e354));
                                                let _e1017 = (_e982[2][2] - _e368);
                                                let _e1020 = (((_e982[2][0] - _e291) * _e392) - (_e1017 * _e316));
                                                let _e1023 = (((_e982[2][1] - _e330) * _e392) - (_e1017 * _e354));
                                                let _e1024 = (_e1020 * _e1010);
                                                let _e1025 = (_e1023 * _e1007);
                                                let _e1026 = (_e994 * _e1023);
                                                let _e1027 = (_e997 * _e1020);
                                                let _e1028 = (_e1007 * _e997);
                                                let _e1029 = (_e1010 * _e994);
                                                let _e1034 = (((_e1024 >= _e1025) && (_e1026 >= _e1027)) && (_e1028 >= _e1029));
                                                if (_e1034 || (((_e1024 <= _e1025) && (_e1026 <= _e1027)) && (_e1028 <= _e1029))) {
                                                    let _e1041 = select(-1f, 1f, _e1034);
                                                    let _e1043 = ((_e1024 - _e1025) * _e1041);
                                                    let _e1045 = select(0f, _e1043, (_e1043 > 0f));
                                                    let _e1047 = ((_e1026 - _e1027) * _e1041);
                                                    let _e1049 = select(0f, _e1047, (_e1047 > 0f));
                                                    let _e1051 = ((_e1028 - _e1029) * _e1041);
                                                    let _e1053 = select(0f, _e1051, (_e1051 > 0f));
                                                    let _e1055 = ((_e1045 + _e1049) + _e1053);
                                                    if (_e1055 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1863_ = type_25();
                                                        phi_1864_ = true;
                                                        phi_1865_ = false;
                                                    } else {
                                                        let _e1058 = select(_e1007, _e994, (_e994 < _e1007));
                                                        if (select(_e1020, _e1058, (_e1058 < _e1020)) > 0f) {
                                                            phi_1155_ = true;
                                                        } else {
                                                            let _e1063 = select(_e1007, _e994, (_e994 > _e1007));
                                                            phi_1155_ = (select(_e1020, _e1063, (_e1063 > _e1020)) < 0f);
                                                        }
                                                        let _e1068 = phi_1155_;
                                                        if _e1068 {
                                                            phi_1860_ = type_25();
                                                            phi_1861_ = true;
                                                            phi_1862_ = false;
                                                        } else {
                                                            let _e1070 = select(_e1010, _e997, (_e997 < _e1010));
                                                            if (select(_e1023, _e1070, (_e1070 < _e1023)) > 0f) {
                                                                phi_1184_ = true;
                                                            } else {
                                                                let _e1075 = select(_e1010, _e997, (_e997 > _e1010));
                                                                phi_1184_ = (select(_e1023, _e1075, (_e1075 > _e1023)) < 0f);
                                                            }
                                                            let _e1080 = phi_1184_;
                                                            if _e1080 {
                                                                phi_1858_ = type_25();
                                                                phi_1859_ = false;
                                                            } else {
                                                                let _e1082 = select(_e982[1][0], _e982[0][0], (_e982[0][0] < _e982[1][0]));
                                                                let _e1086 = select(_e982[1][0], _e982[0][0], (_e982[0][0] > _e982[1][0]));
                                                                let _e1090 = select(_e982[1][1], _e982[0][1], (_e982[0][1] < _e982[1][1]));
                                                                let _e1094 = select(_e982[1][1], _e982[0][1], (_e982[0][1] > _e982[1][1]));
                                                                let _e1098 = select(_e982[1][2], _e982[0][2], (_e982[0][2] < _e982[1][2]));
                                                                let _e1102 = select(_e982[1][2], _e982[0][2], (_e982[0][2] > _e982[1][2]));
                                                                let _e1107 = ((select(_e982[2][0], _e1082, (_e1082 < _e982[2][0])) - _e314) * _e319);
                                                                let _e1108 = ((select(_e982[2][0], _e1086, (_e1086 > _e982[2][0])) - _e315) * _e319);
                                                                let _e1111 = ((select(_e982[2][1], _e1090, (_e1090 < _e982[2][1])) - _e352) * _e357);
                                                                let _e1112 = ((select(_e982[2][1], _e1094, (_e1094 > _e982[2][1])) - _e353) * _e357);
                                                                let _e1115 = ((select(_e982[2][2], _e1098, (_e1098 < _e982[2][2])) - _e390) * _e395);
                                                                let _e1116 = ((select(_e982[2][2], _e1102, (_e1102 > _e982[2][2])) - _e391) * _e395);
                                                                let _e1118 = select(_e1116, _e1115, (_e1115 < _e1116));
                                                                let _e1120 = select(_e1116, _e1115, (_e1115 > _e1116));
                                                                let _e1122 = select(_e1108, _e1107, (_e1107 < _e1108));
                                                                let _e1124 = select(_e1112, _e1111, (_e1111 < _e1112));
                                                                let _e1126 = select(_e1124, _e1122, (_e1122 > _e1124));
                                                                let _e1128 = select(_e1118, _e1126, (_e1126 > _e1118));
                                                                let _e1130 = select(_e1108, _e1107, (_e1107 > _e1108));
                                                                let _e1132 = select(_e1112, _e1111, (_e1111 > _e1112));
                                                                let _e1134 = select(_e1132, _e1130, (_e1130 < _e1132));
                                                                let _e1136 = select(_e1120, _e1134, (_e1134 < _e1120));
                                                                let _e1137 = -(_e1118);
                                                                let _e1143 = select(_e442, _e1128, (_e1128 > _e442));
                                                                if (_e1143 > (_e1136 + (select(_e1137, _e1120, (_e1120 > _e1137)) * 0.0000019073523f))) {
                                                                    phi_1853_ = type_25();
                                                                    phi_1854_ = true;
                                                                } else {
                                                                    let _e1145 = (_e1143 > _e880.member.member_1);
                                                                    if _e1145 {
                                                                        phi_1852_ = type_25();
                                                                    } else {
                                                                        let _e1146 = vec3<f32>(_e982[0][0], _e982[0][1], _e982[0][2]);
                                                                        let _e1147 = vec3<f32>(_e982[1][0], _e982[1][1], _e982[1][2]);
                                                                        let _e1148 = vec3<f32>(_e982[2][0], _e982[2][1], _e982[2][2]);
                                                                        let _e1149 = (_e982[1][0] - _e982[0][0]);
                                                                        let _e1150 = (_e982[1][1] - _e982[0][1]);
                                                                        let _e1151 = (_e982[1][2] - _e982[0][2]);
                                                                        let _e1152 = vec3<f32>(_e1149, _e1150, _e1151);
                                                                        let _e1153 = (_e982[2][0] - _e982[1][0]);
                                                                        let _e1154 = (_e982[2][1] - _e982[1][1]);
                                                                        let _e1155 = (_e982[2][2] - _e982[1][2]);
                                                                        let _e1156 = vec3<f32>(_e1153, _e1154, _e1155);
                                                                        let _e1157 = (_e982[0][0] - _e982[2][0]);
                                                                        let _e1158 = (_e982[0][1] - _e982[2][1]);
                                                                        let _e1159 = (_e982[0][2] - _e982[2][2]);
                                                                        let _e1160 = vec3<f32>(_e1157, _e1158, _e1159);
                                                                        let _e1163 = bitcast<f32>((bitcast<u32>(_e1149) & 2147483647u));
                                                                        let _e1166 = bitcast<f32>((bitcast<u32>(_e1150) & 2147483647u));
                                                                        let _e1168 = select(_e1166, _e1163, (_e1163 > _e1166));
                                                                        let _e1171 = bitcast<f32>((bitcast<u32>(_e1151) & 2147483647u));
                                                                        let _e1173 = select(_e1171, _e1168, (_e1168 > _e1171));
                                                                        let _e1176 = bitcast<f32>((bitcast<u32>(_e1153) & 2147483647u));
                                                                        let _e1179 = bitcast<f32>((bitcast<u32>(_e1154) & 2147483647u));
                                                                        let _e1181 = select(_e1179, _e1176, (_e1176 > _e1179));
                                                                        let _e1184 = bitcast<f32>((bitcast<u32>(_e1155) & 2147483647u));
                                                                        let _e1186 = select(_e1184, _e1181, (_e1181 > _e1184));
                                                                        let _e1189 = bitcast<f32>((bitcast<u32>(_e1157) & 2147483647u));
                                                                        let _e1192 = bitcast<f32>((bitcast<u32>(_e1158) & 2147483647u));
                                                                        let _e1194 = select(_e1192, _e1189, (_e1189 > _e1192));
                                                                        let _e1197 = bitcast<f32>((bitcast<u32>(_e1159) & 2147483647u));
                                                                        let _e1199 = select(_e1197, _e1194, (_e1194 > _e1197));
                                                                        let _e1201 = select(_e1186, _e1173, (_e1173 > _e1186));
                                                                        let _e1203 = select(_e1199, _e1201, (_e1201 > _e1199));
                                                                        if (_e1173 == _e1203) {
                                                                            phi_1585_ = _e1010;
                                                                            phi_1586_ = _e1007;
                                                                            phi_1587_ = _e997;
                                                                            phi_1588_ = _e994;
                                                                            phi_1589_ = _e1146;
                                                                            phi_1590_ = _e1160;
                                                                            phi_1591_ = _e1156;
                                                                            phi_1592_ = _e1152;
                                                                        } else {
                                                                            let _e1205 = (_e1186 == _e1203);
                                                                            let _e1210 = vec3(_e1205);
                                                                            phi_1585_ = select(_e997, _e1023, _e1205);
                                                                            phi_1586_ = select(_e994, _e1020, _e1205);
                                                                            phi_1587_ = select(_e1023, _e1010, _e1205);
                                                                            phi_1588_ = select(_e1020, _e1007, _e1205);
                                                                            phi_1589_ = select(_e1148, _e1147, _e1210);
                                                                            phi_1590_ = select(_e1156, _e1152, _e1210);
                                                                            phi_1591_ = select(_e1152, _e1160, _e1210);
                                                                            phi_1592_ = select(_e1160, _e1156, _e1210);
                                                                        }
                                                                        let _e1216 = phi_1585_;
                                                                        let _e1218 = phi_1586_;
                                                                        let _e1220 = phi_1587_;
                                                                        let _e1222 = phi_1588_;
                                                                        let _e1224 = phi_1589_;
                                                                        let _e1226 = phi_1590_;
                                                                        let _e1228 = phi_1591_;
                                                                        let _e1230 = phi_1592_;
                                                                        let _e1237 = ((_e1228.y * _e1226.z) - (_e1226.y * _e1228.z));
                                                                        let _e1242 = ((_e1228.z * _e1226.x) - (_e1226.z * _e1228.x));
                                                                        let _e1245 = ((_e1228.x * _e1226.y) - (_e1226.x * _e1228.y));
                                                                        if (_e1045 >= _e1049) {
                                                                            phi_1623_ = select(true, false, (_e1045 >= _e1053));
                                                                        } else {
                                                                            phi_1623_ = true;
                                                                        }
                                                                        let _e1250 = phi_1623_;
                                                                        if _e1250 {
                                                                            phi_1632_ = select(_e1148, _e1147, vec3((_e1049 >= _e1053)));
                                                                        } else {
                                                                            phi_1632_ = _e1146;
                                                                        }
                                                                        let _e1255 = phi_1632_;
                                                                        let _e1266 = (((_e1237 * (_e1255.x - _e291)) + (_e1242 * (_e1255.y - _e330))) + (_e1245 * (_e1255.z - _e368)));
                                                                        let _e1271 = (((_e1237 * _e316) + (_e1242 * _e354)) + (_e1245 * _e392));
                                                                        let _e1272 = (_e1218 - _e1222);
                                                                        let _e1273 = (_e1216 - _e1220);
                                                                        let _e1281 = (-(((_e1222 * _e1272) + (_e1220 * _e1273))) / ((_e1272 * _e1272) + (_e1273 * _e1273)));
                                                                        let _e1283 = select(1f, _e1281, (_e1281 < 1f));
                                                                        let _e1285 = select(0f, _e1283, (_e1283 > 0f));
                                                                        let _e1298 = ((_e1224.x + (_e1230.x * _e1285)) - _e291);
                                                                        let _e1299 = ((_e1224.y + (_e1230.y * _e1285)) - _e330);
                                                                        let _e1300 = ((_e1224.z + (_e1230.z * _e1285)) - _e368);
                                                                        let _e1301 = (_e1300 / _e392);
                                                                        let _e1313 = bitcast<f32>((bitcast<u32>(_e1298) & 2147483647u));
                                                                        let _e1316 = bitcast<f32>((bitcast<u32>(_e1299) & 2147483647u));
                                                                        let _e1318 = select(_e1316, _e1313, (_e1313 > _e1316));
                                                                        let _e1321 = bitcast<f32>((bitcast<u32>(_e1300) & 2147483647u));
                                                                        let _e1323 = select(_e1321, _e1318, (_e1318 > _e1321));
                                                                        let _e1329 = bitcast<f32>((bitcast<u32>(_e1237) & 2147483647u));
                                                                        let _e1332 = bitcast<f32>((bitcast<u32>(_e1242) & 2147483647u));
                                                                        let _e1334 = select(_e1332, _e1329, (_e1329 > _e1332));
                                                                        let _e1337 = bitcast<f32>((bitcast<u32>(_e1245) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1237 * _e1298) + (_e1242 * _e1299)) + (_e1245 * _e1300)) - _e1266)) & 2147483647u)) <= ((0.0000009536743f * select(_e1203, _e1323, (_e1323 > _e1203))) * select(_e1337, _e1334, (_e1334 > _e1337)))) {
                                                                            let _e1347 = bitcast<f32>((bitcast<u32>(_e1228.x) & 2147483647u));
                                                                            let _e1350 = bitcast<f32>((bitcast<u32>(_e1228.y) & 2147483647u));
                                                                            let _e1352 = select(_e1350, _e1347, (_e1347 > _e1350));
                                                                            let _e1355 = bitcast<f32>((bitcast<u32>(_e1228.z) & 2147483647u));
                                                                            let _e1361 = bitcast<f32>((bitcast<u32>(_e1226.x) & 2147483647u));
                                                                            let _e1364 = bitcast<f32>((bitcast<u32>(_e1226.y) & 2147483647u));
                                                                            let _e1366 = select(_e1364, _e1361, (_e1361 > _e1364));
                                                                            let _e1369 = bitcast<f32>((bitcast<u32>(_e1226.z) & 2147483647u));
                                                                            let _e1373 = (bitcast<f32>((bitcast<u32>(_e1271) & 2147483647u)) > ((0.0000038146973f * select(_e1355, _e1352, (_e1352 > _e1355))) * select(_e1369, _e1366, (_e1366 > _e1369))));
                                                                            if _e1373 {
                                                                                phi_1797_ = (_e1266 / _e1271);
                                                                            } else {
                                                                                phi_1797_ = f32();
                                                                            }
                                                                            let _e1376 = phi_1797_;
                                                                            phi_1799_ = _e1376;
                                                                            phi_1800_ = select(true, false, _e1373);
                                                                        } else {
                                                                            phi_1799_ = f32();
                                                                            phi_1800_ = true;
                                                                        }
                                                                        let _e1379 = phi_1799_;
                                                                        let _e1381 = phi_1800_;
                                                                        if _e1381 {
                                                                            let _e1389 = (((_e1237 * (_e1298 - (_e316 * _e1301))) + (_e1242 * (_e1299 - (_e354 * _e1301)))) / _e1271);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1389) & 2147483647u)) <= _e1203) {
                                                                                phi_1820_ = (_e1301 + _e1389);
                                                                            } else {
                                                                                phi_1820_ = _e1301;
                                                                            }
                                                                            let _e1396 = phi_1820_;
                                                                            phi_1821_ = _e1396;
                                                                        } else {
                                                                            phi_1821_ = _e1379;
                                                                        }
                                                                        let _e1398 = phi_1821_;
                                                                        let _e1400 = select(_e1136, _e1398, (_e1398 < _e1136));
                                                                        let _e1402 = select(_e1128, _e1400, (_e1400 > _e1128));
                                                                        if (_e1402 >= _e442) {
                                                                            let _e1404 = (_e1402 <= _e880.member.member_1);
                                                                            if _e1404 {
                                                                                let _e1405 = (1f / _e1055);
                                                                                phi_1844_ = type_25(_e1402, (_e1049 * _e1405), (_e1053 * _e1405), _e915);
                                                                            } else {
                                                                                phi_1844_ = type_25();
                                                                            }
                                                                            let _e1410 = phi_1844_;
                                                                            phi_1846_ = _e1410;
                                                                            phi_1847_ = select(true, false, _e1404);
                                                                        } else {
                                                                            phi_1846_ = type_25();
                                                                            phi_1847_ = true;
                                                                        }
                                                                        let _e1413 = phi_1846_;
                                                                        let _e1415 = phi_1847_;
                                                                        if _e1415 {
                                                                            phi_1851_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1851_ = _e1413;
                                                                        }
                                                                        let _e1417 = phi_1851_;
                                                                        phi_1852_ = _e1417;
                                                                    }
                                                                    let _e1419 = phi_1852_;
                                                                    phi_1853_ = _e1419;
                                                                    phi_1854_ = _e1145;
                                                                }
                                                                let _e1421 = phi_1853_;
                                                                let _e1423 = phi_1854_;
                                                                phi_1858_ = _e1421;
                                                                phi_1859_ = _e1423;
                                                            }
                                                            let _e1425 = phi_1858_;
                                                            let _e1427 = phi_1859_;
                                                            phi_1860_ = _e1425;
                                                            phi_1861_ = _e1080;
                                                            phi_1862_ = _e1427;
                                                        }
                                                        let _e1429 = phi_1860_;
                                                        let _e1431 = phi_1861_;
                                                        let _e1433 = phi_1862_;
                                                        phi_1863_ = _e1429;
                                                        phi_1864_ = _e1431;
                                                        phi_1865_ = _e1433;
                                                    }
                                                    let _e1435 = phi_1863_;
                                                    let _e1437 = phi_1864_;
                                                    let _e1439 = phi_1865_;
                                                    phi_1873_ = _e1435;
                                                    phi_1874_ = select(_e1439, true, _e1437);
                                                } else {
                                                    phi_1873_ = type_25();
                                                    phi_1874_ = true;
                                                }
                                                let _e1442 = phi_1873_;
                                                let _e1444 = phi_1874_;
                                                if _e1444 {
                                                    phi_1878_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1878_ = _e1442;
                                                }
                                                let _e1446 = phi_1878_;
                                                if (_e1446.member_3 != 4294967295u) {
                                                    if (_e915 != 4294967295u) {
                                                        if (_e1446.member < _e880.member.member.member) {
                                                            phi_1904_ = true;
                                                        } else {
                                                            if (_e1446.member == _e880.member.member.member) {
                                                                phi_1903_ = (_e1446.member_3 < _e880.member.member.member_3);
                                                            } else {
                                                                phi_1903_ = false;
                                                            }
                                                            let _e1461 = phi_1903_;
                                                            phi_1904_ = _e1461;
                                                        }
                                                        let _e1463 = phi_1904_;
                                                        if _e1463 {
                                                            phi_1911_ = type_38(type_32(_e1446, _e1446.member), _e907.member_1, _e907.member_2);
                                                        } else {
                                                            phi_1911_ = _e907;
                                                        }
                                                        let _e1470 = phi_1911_;
                                                        phi_1912_ = _e1470;
                                                    } else {
                                                        phi_1912_ = _e907;
                                                    }
                                                    let _e1472 = phi_1912_;
                                                    phi_1913_ = _e1472;
                                                } else {
                                                    phi_1913_ = _e907;
                                                }
                                                let _e1474 = phi_1913_;
                                                phi_900_ = _e1474;
                                            } else {
                                                phi_900_ = type_38();
                                            }
                                            let _e1476 = phi_900_;
                                            continue;
                                            continuing {
                                                phi_899_ = _e1476;
                                                phi_902_ = _e895;
                                                phi_2933_ = _e475;
                                                break if !(_e901);
                                            }
                                        }
                                        let _e1479 = phi_2933_;
                                        phi_3075_ = _e1479;
                                        if _e1479 {
                                            break;
                                        }
                                        phi_3079_ = _e1479;
                                        let _e1644 = local_12;
                                        phi_2865_ = _e1644;
                                        phi_2866_ = _e517;
                                        phi_2867_ = false;
                                        phi_2868_ = _e521;
                                    } else {
                                        let _e536 = (_e517.member_1 < _e80);
                                        if _e536 {
                                            if _e536 {
                                            } else {
                                                phi_3075_ = true;
                                                break;
                                            }
                                            let _e538 = global_5.member[_e517.member_1];
                                            phi_1935_ = _e538;
                                        } else {
                                            phi_1935_ = type_42(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e540 = phi_1935_;
                                        let _e555 = ((10u * _e242) & 31u);
                                        let _e558 = ((_e540.member[0] >> bitcast<u32>(_e555)) & 1023u);
                                        let _e563 = bitcast<f32>((bitcast<u32>(((_e517.member.member_1[0] - _e517.member.member[0]) * 0.0009775171f)) ^ _e114));
                                        let _e569 = (_e517.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e558) * _e563)) ^ _e114)));
                                        let _e573 = select(select(_e517.member.member_1[0], _e569, (_e569 < _e517.member.member_1[0])), _e517.member.member_1[0], (_e558 == 1023u));
                                        let _e575 = ((10u * _e241) & 31u);
                                        let _e578 = ((_e540.member[0] >> bitcast<u32>(_e575)) & 1023u);
                                        let _e583 = bitcast<f32>((bitcast<u32>(((_e517.member.member_1[1] - _e517.member.member[1]) * 0.0009775171f)) ^ _e114));
                                        let _e589 = (_e517.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e578) * _e583)) ^ _e114)));
                                        let _e593 = select(select(_e517.member.member_1[1], _e589, (_e589 < _e517.member.member_1[1])), _e517.member.member_1[1], (_e578 == 1023u));
                                        let _e595 = ((10u * _e243) & 31u);
                                        let _e598 = ((_e540.member[0] >> bitcast<u32>(_e595)) & 1023u);
                                        let _e603 = bitcast<f32>((bitcast<u32>(((_e517.member.member_1[2] - _e517.member.member[2]) * 0.0009775171f)) ^ _e114));
                                        let _e609 = (_e517.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e598) * _e603)) ^ _e114)));
                                        let _e613 = select(select(_e517.member.member_1[2], _e609, (_e609 < _e517.member.member_1[2])), _e517.member.member_1[2], (_e598 == 1023u));
                                        let _e616 = ((_e540.member[1] >> bitcast<u32>(_e555)) & 1023u);
                                        let _e622 = (_e517.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e616) * _e563)) ^ _e114)));
                                        let _e626 = select(select(_e517.member.member_1[0], _e622, (_e622 < _e517.member.member_1[0])), _e517.member.member_1[0], (_e616 == 1023u));
                                        let _e629 = ((_e540.member[1] >> bitcast<u32>(_e575)) & 1023u);
                                        let _e635 = (_e517.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e629) * _e583)) ^ _e114)));
                                        let _e639 = select(select(_e517.member.member_1[1], _e635, (_e635 < _e517.member.member_1[1])), _e517.member.member_1[1], (_e629 == 1023u));
                                        let _e642 = ((_e540.member[1] >> bitcast<u32>(_e595)) & 1023u);
                                        let _e648 = (_e517.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e642) * _e603)) ^ _e114)));
                                        let _e652 = select(select(_e517.member.member_1[2], _e648, (_e648 < _e517.member.member_1[2])), _e517.member.member_1[2], (_e642 == 1023u));
                                        let _e658 = ((_e540.member_1[0] >> bitcast<u32>(_e555)) & 1023u);
                                        let _e664 = (_e517.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e658) * _e563)) ^ _e114)));
                                        let _e668 = select(select(_e517.member.member_1[0], _e664, (_e664 < _e517.member.member_1[0])), _e517.member.member_1[0], (_e658 == 1023u));
                                        let _e671 = ((_e540.member_1[0] >> bitcast<u32>(_e575)) & 1023u);
                                        let _e677 = (_e517.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e671) * _e583)) ^ _e114)));
                                        let _e681 = select(select(_e517.member.member_1[1], _e677, (_e677 < _e517.member.member_1[1])), _e517.member.member_1[1], (_e671 == 1023u));
                                        let _e684 = ((_e540.member_1[0] >> bitcast<u32>(_e595)) & 1023u);
                                        let _e690 = (_e517.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e684) * _e603)) ^ _e114)));
                                        let _e694 = select(select(_e517.member.member_1[2], _e690, (_e690 < _e517.member.member_1[2])), _e517.member.member_1[2], (_e684 == 1023u));
                                        let _e697 = ((_e540.member_1[1] >> bitcast<u32>(_e555)) & 1023u);
                                        let _e703 = (_e517.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e697) * _e563)) ^ _e114)));
                                        let _e707 = select(select(_e517.member.member_1[0], _e703, (_e703 < _e517.member.member_1[0])), _e517.member.member_1[0], (_e697 == 1023u));
                                        let _e710 = ((_e540.member_1[1] >> bitcast<u32>(_e575)) & 1023u);
                                        let _e716 = (_e517.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e710) * _e583)) ^ _e114)));
                                        let _e720 = select(select(_e517.member.member_1[1], _e716, (_e716 < _e517.member.member_1[1])), _e517.member.member_1[1], (_e710 == 1023u));
                                        let _e723 = ((_e540.member_1[1] >> bitcast<u32>(_e595)) & 1023u);
                                        let _e729 = (_e517.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e723) * _e603)) ^ _e114)));
                                        let _e733 = select(select(_e517.member.member_1[2], _e729, (_e729 < _e517.member.member_1[2])), _e517.member.member_1[2], (_e723 == 1023u));
                                        let _e738 = type_49(type_47(array<f32, 3>(_e573, _e593, _e613), array<f32, 3>(_e626, _e639, _e652)), _e540.member_2);
                                        let _e743 = type_49(type_47(array<f32, 3>(_e668, _e681, _e694), array<f32, 3>(_e707, _e720, _e733)), _e540.member_3);
                                        let _e750 = ((_e573 - _e314) * _e319);
                                        let _e751 = ((_e668 - _e314) * _e319);
                                        let _e752 = ((_e626 - _e315) * _e319);
                                        let _e753 = ((_e707 - _e315) * _e319);
                                        let _e758 = ((_e593 - _e352) * _e357);
                                        let _e759 = ((_e681 - _e352) * _e357);
                                        let _e760 = ((_e639 - _e353) * _e357);
                                        let _e761 = ((_e720 - _e353) * _e357);
                                        let _e766 = ((_e613 - _e390) * _e395);
                                        let _e767 = ((_e694 - _e390) * _e395);
                                        let _e768 = ((_e652 - _e391) * _e395);
                                        let _e769 = ((_e733 - _e391) * _e395);
                                        let _e771 = select(_e768, _e766, (_e766 < _e768));
                                        let _e773 = select(_e769, _e767, (_e767 < _e769));
                                        let _e775 = select(_e768, _e766, (_e766 > _e768));
                                        let _e777 = select(_e769, _e767, (_e767 > _e769));
                                        let _e779 = select(_e752, _e750, (_e750 < _e752));
                                        let _e781 = select(_e753, _e751, (_e751 < _e753));
                                        let _e783 = select(_e760, _e758, (_e758 < _e760));
                                        let _e785 = select(_e761, _e759, (_e759 < _e761));
                                        let _e787 = select(_e783, _e779, (_e779 > _e783));
                                        let _e789 = select(_e785, _e781, (_e781 > _e785));
                                        let _e791 = select(_e771, _e787, (_e787 > _e771));
                                        let _e793 = select(_e773, _e789, (_e789 > _e773));
                                        let _e795 = select(_e752, _e750, (_e750 > _e752));
                                        let _e797 = select(_e753, _e751, (_e751 > _e753));
                                        let _e799 = select(_e760, _e758, (_e758 > _e760));
                                        let _e801 = select(_e761, _e759, (_e759 > _e761));
                                        let _e803 = select(_e799, _e795, (_e795 < _e799));
                                        let _e805 = select(_e801, _e797, (_e797 < _e801));
                                        let _e810 = -(_e771);
                                        let _e811 = -(_e773);
                                        let _e818 = (select(_e775, _e803, (_e803 < _e775)) + (select(_e810, _e775, (_e775 > _e810)) * 0.0000019073523f));
                                        let _e819 = (select(_e777, _e805, (_e805 < _e777)) + (select(_e811, _e777, (_e777 > _e811)) * 0.0000019073523f));
                                        let _e821 = select(_e442, _e791, (_e791 > _e442));
                                        let _e823 = select(_e442, _e793, (_e793 > _e442));
                                        let _e828 = (_e821 <= select(_e477.member.member_1, _e818, (_e818 < _e477.member.member_1)));
                                        let _e829 = (_e823 <= select(_e477.member.member_1, _e819, (_e819 < _e477.member.member_1)));
                                        let _e830 = (_e821 <= _e823);
                                        if _e828 {
                                            if _e829 {
                                                if _e830 {
                                                    phi_2767_ = _e743;
                                                } else {
                                                    phi_2767_ = _e738;
                                                }
                                                let _e832 = phi_2767_;
                                                let _e840 = (_e521 % 128u);
                                                let _e841 = (_e840 < 128u);
                                                if _e841 {
                                                } else {
                                                    phi_3075_ = true;
                                                    break;
                                                }
                                                local_6[_e840] = _e832.member_1;
                                                if _e841 {
                                                } else {
                                                    phi_3075_ = true;
                                                    break;
                                                }
                                                local_5[_e840] = _e832.member.member[0];
                                                if _e841 {
                                                } else {
                                                    phi_3075_ = true;
                                                    break;
                                                }
                                                local_4[_e840] = _e832.member.member[1];
                                                if _e841 {
                                                } else {
                                                    phi_3075_ = true;
                                                    break;
                                                }
                                                local_3[_e840] = _e832.member.member[2];
                                                if _e841 {
                                                } else {
                                                    phi_3075_ = true;
                                                    break;
                                                }
                                                local_2[_e840] = _e832.member.member_1[0];
                                                if _e841 {
                                                } else {
                                                    phi_3075_ = true;
                                                    break;
                                                }
                                                local_1[_e840] = _e832.member.member_1[1];
                                                if _e841 {
                                                } else {
                                                    phi_3075_ = true;
                                                    break;
                                                }
                                                local[_e840] = _e832.member.member_1[2];
                                                if _e841 {
                                                } else {
                                                    phi_3075_ = true;
                                                    break;
                                                }
                                                local_7[_e840] = select(_e823, _e821, (_e821 > _e823));
                                                if _e830 {
                                                    phi_2844_ = _e738;
                                                } else {
                                                    phi_2844_ = _e743;
                                                }
                                                let _e858 = phi_2844_;
                                                phi_2845_ = _e858;
                                                phi_2846_ = (_e521 + 1u);
                                            } else {
                                                phi_2845_ = type_49();
                                                phi_2846_ = u32();
                                            }
                                            let _e860 = phi_2845_;
                                            let _e862 = phi_2846_;
                                            phi_2848_ = _e860;
                                            phi_2849_ = _e862;
                                            phi_2850_ = select(true, false, _e829);
                                        } else {
                                            phi_2848_ = type_49();
                                            phi_2849_ = u32();
                                            phi_2850_ = true;
                                        }
                                        let _e865 = phi_2848_;
                                        let _e867 = phi_2849_;
                                        let _e869 = phi_2850_;
                                        if _e869 {
                                            if _e828 {
                                                phi_2857_ = _e738;
                                            } else {
                                                phi_2857_ = _e743;
                                            }
                                            let _e871 = phi_2857_;
                                            phi_2862_ = _e871;
                                            phi_2863_ = select(_e829, true, _e828);
                                        } else {
                                            phi_2862_ = _e865;
                                            phi_2863_ = _e519;
                                        }
                                        let _e874 = phi_2862_;
                                        let _e876 = phi_2863_;
                                        phi_3079_ = _e475;
                                        phi_2865_ = type_38(_e477.member, (_e477.member_1 + 1u), _e477.member_2);
                                        phi_2866_ = _e874;
                                        phi_2867_ = _e876;
                                        phi_2868_ = select(_e867, _e521, _e869);
                                    }
                                    let _e1481 = phi_3079_;
                                    let _e1483 = phi_2865_;
                                    let _e1485 = phi_2866_;
                                    let _e1487 = phi_2867_;
                                    let _e1489 = phi_2868_;
                                    phi_3078_ = _e1481;
                                    phi_2869_ = _e1483;
                                    phi_2870_ = _e1485;
                                    phi_2871_ = (_e481 - 1u);
                                    phi_2872_ = _e1487;
                                    phi_2873_ = _e1489;
                                } else {
                                    phi_3078_ = _e475;
                                    phi_2869_ = _e477;
                                    phi_2870_ = _e517;
                                    phi_2871_ = _e481;
                                    phi_2872_ = _e519;
                                    phi_2873_ = _e521;
                                }
                                let _e1491 = phi_3078_;
                                let _e1493 = phi_2869_;
                                let _e1495 = phi_2870_;
                                let _e1497 = phi_2871_;
                                let _e1499 = phi_2872_;
                                let _e1501 = phi_2873_;
                                phi_3077_ = _e1491;
                                phi_2874_ = _e1493;
                                phi_2875_ = _e1495;
                                phi_2876_ = _e1497;
                                phi_2877_ = _e1499;
                                phi_2878_ = _e1501;
                            } else {
                                phi_3077_ = _e475;
                                phi_2874_ = type_38();
                                phi_2875_ = type_49();
                                phi_2876_ = u32();
                                phi_2877_ = bool();
                                phi_2878_ = u32();
                            }
                            let _e1503 = phi_3077_;
                            let _e1505 = phi_2874_;
                            let _e1507 = phi_2875_;
                            let _e1509 = phi_2876_;
                            let _e1511 = phi_2877_;
                            let _e1513 = phi_2878_;
                            phi_3076_ = _e1503;
                            phi_774_ = _e1505;
                            phi_777_ = _e1507;
                            phi_779_ = _e1509;
                            phi_781_ = _e1511;
                            phi_783_ = _e1513;
                            phi_2879_ = _e489;
                        } else {
                            phi_3076_ = _e475;
                            phi_774_ = type_38();
                            phi_777_ = type_49();
                            phi_779_ = u32();
                            phi_781_ = bool();
                            phi_783_ = u32();
                            phi_2879_ = false;
                        }
                        let _e1515 = phi_3076_;
                        let _e1517 = phi_774_;
                        let _e1519 = phi_777_;
                        let _e1521 = phi_779_;
                        let _e1523 = phi_781_;
                        let _e1525 = phi_783_;
                        let _e1527 = phi_2879_;
                        continue;
                        continuing {
                            phi_2939_ = _e1515;
                            phi_773_ = _e1517;
                            phi_776_ = _e1519;
                            phi_778_ = _e1521;
                            phi_780_ = _e1523;
                            phi_782_ = _e1525;
                            phi_3075_ = _e1515;
                            break if !(_e1527);
                        }
                    }
                    let _e1530 = phi_3075_;
                    if _e1530 {
                        break;
                    }
                    let _e1532 = local_10;
                    let _e1535 = local_11;
                    if _e130 {
                    } else {
                        break;
                    }
                    global_6.member[_e128][0u] = _e1532.member_1;
                    global_6.member[_e128][1u] = _e1535.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
