struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: array<type_19>,
}

struct type_31 {
    member: array<array<type_18, 8>>,
}

struct type_37 {
    member: array<vec4<u32>, 2>,
}

struct type_39 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_41 {
    member: array<type_39>,
}

struct type_44 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_46 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_48 {
    member: array<type_46>,
}

struct type_52 {
    member: type_44,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_37;
@group(0) @binding(4) 
var<storage> global_3: type_27;
@group(0) @binding(2) 
var<storage> global_4: type_41;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_31;
@group(0) @binding(3) 
var<storage> global_6: type_48;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<type_18, 8>;
    var local_8: array<f32, 128>;
    var local_9: array<f32, 3>;
    var local_10: array<f32, 3>;
    var phi_336_: i32;
    var phi_337_: i32;
    var phi_347_: bool;
    var phi_357_: u32;
    var phi_358_: u32;
    var phi_360_: bool;
    var phi_365_: u32;
    var phi_377_: i32;
    var phi_397_: i32;
    var phi_415_: f32;
    var phi_421_: f32;
    var phi_432_: f32;
    var phi_438_: f32;
    var phi_461_: f32;
    var phi_472_: f32;
    var phi_481_: f32;
    var phi_487_: f32;
    var phi_498_: f32;
    var phi_504_: f32;
    var phi_527_: f32;
    var phi_538_: f32;
    var phi_547_: f32;
    var phi_553_: f32;
    var phi_564_: f32;
    var phi_570_: f32;
    var phi_593_: f32;
    var phi_604_: f32;
    var phi_704_: f32;
    var phi_705_: f32;
    var phi_3198_: bool;
    var phi_3118_: f32;
    var phi_831_: type_52;
    var phi_834_: u32;
    var phi_836_: bool;
    var phi_838_: u32;
    var phi_849_: bool;
    var phi_936_: type_52;
    var phi_937_: bool;
    var phi_938_: u32;
    var phi_1956_: type_39;
    var phi_2789_: type_52;
    var phi_2866_: type_52;
    var phi_2867_: type_52;
    var phi_2868_: u32;
    var phi_2870_: type_52;
    var phi_2871_: u32;
    var phi_2872_: bool;
    var phi_2879_: type_52;
    var phi_2884_: type_52;
    var phi_2885_: bool;
    var phi_3195_: bool;
    var phi_3167_: f32;
    var phi_957_: type_4;
    var phi_958_: type_4;
    var phi_981_: type_4;
    var phi_1006_: u32;
    var phi_1022_: type_46;
    var phi_1729_: vec3<f32>;
    var phi_1730_: vec3<f32>;
    var phi_1761_: bool;
    var phi_1770_: vec3<f32>;
    var phi_1810_: type_18;
    var phi_1812_: type_18;
    var phi_1813_: bool;
    var phi_1817_: type_18;
    var phi_1818_: type_18;
    var phi_1819_: type_18;
    var phi_1820_: bool;
    var phi_1824_: type_18;
    var phi_1825_: bool;
    var phi_1829_: type_18;
    var phi_1830_: bool;
    var phi_1834_: type_18;
    var phi_1846_: type_4;
    var phi_1849_: type_18;
    var phi_1847_: type_4;
    var phi_1872_: type_4;
    var phi_1904_: bool;
    var phi_1905_: bool;
    var phi_1926_: type_18;
    var phi_1850_: type_18;
    var phi_3168_: bool;
    var phi_3477_: f32;
    var phi_3476_: f32;
    var phi_3303_: bool;
    var phi_3475_: f32;
    var phi_3302_: bool;
    var phi_3474_: f32;
    var phi_3301_: bool;
    var phi_3414_: f32;
    var phi_3300_: bool;
    var phi_3379_: f32;
    var phi_3309_: bool;
    var phi_2887_: type_52;
    var phi_2888_: bool;
    var phi_2889_: u32;
    var phi_3378_: f32;
    var phi_3308_: bool;
    var phi_2890_: type_52;
    var phi_2891_: u32;
    var phi_2892_: bool;
    var phi_2893_: u32;
    var phi_3377_: f32;
    var phi_3307_: bool;
    var phi_2894_: type_52;
    var phi_2895_: u32;
    var phi_2896_: bool;
    var phi_2897_: u32;
    var phi_3376_: f32;
    var phi_3306_: bool;
    var phi_832_: type_52;
    var phi_835_: u32;
    var phi_837_: bool;
    var phi_839_: u32;
    var phi_2898_: bool;
    var phi_3305_: bool;
    var phi_2905_: type_4;
    var phi_2906_: type_4;
    var phi_2929_: type_4;
    var phi_2995_: type_18;
    var phi_3369_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e76 = global;
            let _e79 = arrayLength((&global_4.member));
            let _e90 = global_2.member[0u][0u];
            let _e94 = global_2.member[0u][1u];
            let _e98 = global_2.member[0u][2u];
            let _e102 = global_2.member[1u][0u];
            let _e106 = global_2.member[1u][1u];
            let _e110 = global_2.member[1u][2u];
            let _e114 = global_2.member[1u][3u];
            let _e117 = global_1.member[0u];
            let _e118 = bitcast<i32>(_e117);
            let _e128 = (_e76.x + (_e76.y * 2097152u));
            let _e129 = (_e128 < arrayLength((&global_3.member)));
            if _e129 {
                let _e130 = (_e128 < arrayLength((&global_5.member)));
                if _e130 {
                    if _e129 {
                    } else {
                        break;
                    }
                    let _e138 = global_3.member[_e128].member_2[0u];
                    let _e140 = (bitcast<u32>(_e138) & 2147483647u);
                    let _e145 = global_3.member[_e128].member_2[1u];
                    let _e147 = (bitcast<u32>(_e145) & 2147483647u);
                    let _e152 = global_3.member[_e128].member_2[2u];
                    let _e154 = (bitcast<u32>(_e152) & 2147483647u);
                    let _e159 = global_3.member[_e128].member[0u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_3.member[_e128].member[1u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_3.member[_e128].member[2u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e177 = select(_e147, _e140, (_e147 < _e140));
                    let _e179 = select(_e154, _e177, (_e154 < _e177));
                    let _e181 = select(_e161, _e179, (_e161 < _e179));
                    let _e183 = select(_e168, _e181, (_e168 < _e181));
                    let _e185 = select(_e175, _e183, (_e175 < _e183));
                    let _e189 = global_3.member[_e128].member_1;
                    let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                    let _e198 = global_3.member[_e128].member_3;
                    let _e204 = (((select(_e191, _e185, (_e191 < _e185)) < 2139095040u) && ((bitcast<u32>(_e198) & 2147483647u) <= 2139095040u)) && (_e179 > 0u));
                    if _e204 {
                        let _e207 = (bitcast<u32>(bitcast<f32>(_e179)) & 2147483647u);
                        if (_e207 >= 8388608u) {
                            phi_336_ = (bitcast<i32>((_e207 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_336_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e207)), 32u, (_e207 == 0u))));
                        }
                        let _e221 = phi_336_;
                        phi_337_ = _e221;
                    } else {
                        phi_337_ = 0i;
                    }
                    let _e223 = phi_337_;
                    let _e224 = (_e140 == _e179);
                    if _e224 {
                        phi_347_ = true;
                    } else {
                        phi_347_ = (_e147 == _e179);
                    }
                    let _e227 = phi_347_;
                    let _e228 = select(1u, 0u, _e224);
                    if _e227 {
                        let _e229 = (_e228 + 1u);
                        phi_357_ = _e229;
                        phi_358_ = _e229;
                        phi_360_ = select(true, false, (_e229 == 2u));
                    } else {
                        phi_357_ = u32();
                        phi_358_ = 0u;
                        phi_360_ = true;
                    }
                    let _e233 = phi_357_;
                    let _e235 = phi_358_;
                    let _e237 = phi_360_;
                    if _e237 {
                        phi_365_ = (_e235 + 1u);
                    } else {
                        phi_365_ = 0u;
                    }
                    let _e241 = phi_365_;
                    let _e242 = select(_e233, _e235, _e237);
                    let _e243 = select(_e228, select(2u, _e228, _e227), _e237);
                    if (_e118 < -126i) {
                        phi_377_ = -126i;
                    } else {
                        phi_377_ = select(_e118, 127i, (_e118 > 127i));
                    }
                    let _e248 = phi_377_;
                    let _e253 = bitcast<f32>((bitcast<u32>((_e248 + 127i)) << bitcast<u32>(23i)));
                    let _e259 = bitcast<f32>((bitcast<u32>(((_e118 - _e248) + 127i)) << bitcast<u32>(23i)));
                    let _e260 = -(_e223);
                    if (_e260 < -126i) {
                        phi_397_ = -126i;
                    } else {
                        phi_397_ = select(_e260, 127i, (_e260 > 127i));
                    }
                    let _e265 = phi_397_;
                    let _e270 = bitcast<f32>((bitcast<u32>((_e265 + 127i)) << bitcast<u32>(23i)));
                    let _e276 = bitcast<f32>((bitcast<u32>(((_e260 - _e265) + 127i)) << bitcast<u32>(23i)));
                    let _e280 = global_3.member[_e128].member;
                    let _e281 = (_e242 == 0u);
                    if _e281 {
                        phi_415_ = _e280[0];
                    } else {
                        phi_415_ = _e280[1];
                    }
                    let _e285 = phi_415_;
                    let _e286 = (_e242 == 2u);
                    if _e286 {
                        phi_421_ = _e280[2];
                    } else {
                        phi_421_ = _e285;
                    }
                    let _e289 = phi_421_;
                    let _e291 = ((_e289 * _e253) * _e259);
                    let _e292 = global_3.member[_e128].member_2;
                    if _e281 {
                        phi_432_ = _e292[0];
                    } else {
                        phi_432_ = _e292[1];
                    }
                    let _e296 = phi_432_;
                    if _e286 {
                        phi_438_ = _e292[2];
                    } else {
                        phi_438_ = _e296;
                    }
                    let _e299 = phi_438_;
                    let _e301 = ((_e299 * _e270) * _e276);
                    let _e305 = (bitcast<f32>((bitcast<u32>(_e301) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e305 {
                        let _e309 = (bitcast<f32>((bitcast<u32>(_e291) & 2147483647u)) * 0.00000011920929f);
                        phi_461_ = select(0.00000000000011368684f, _e309, (_e309 > 0.00000000000011368684f));
                    } else {
                        phi_461_ = 0f;
                    }
                    let _e313 = phi_461_;
                    let _e314 = (_e291 + _e313);
                    let _e315 = (_e291 - _e313);
                    let _e316 = select(_e301, 0f, _e305);
                    if _e305 {
                        phi_472_ = 38685626000000000000000000f;
                    } else {
                        phi_472_ = (1f / _e301);
                    }
                    let _e319 = phi_472_;
                    let _e320 = (_e241 == 0u);
                    if _e320 {
                        phi_481_ = _e280[0];
                    } else {
                        phi_481_ = _e280[1];
                    }
                    let _e324 = phi_481_;
                    let _e325 = (_e241 == 2u);
                    if _e325 {
                        phi_487_ = _e280[2];
                    } else {
                        phi_487_ = _e324;
                    }
                    let _e328 = phi_487_;
                    let _e330 = ((_e328 * _e253) * _e259);
                    if _e320 {
                        phi_498_ = _e292[0];
                    } else {
                        phi_498_ = _e292[1];
                    }
                    let _e334 = phi_498_;
                    if _e325 {
                        phi_504_ = _e292[2];
                    } else {
                        phi_504_ = _e334;
                    }
                    let _e337 = phi_504_;
                    let _e339 = ((_e337 * _e270) * _e276);
                    let _e343 = (bitcast<f32>((bitcast<u32>(_e339) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e343 {
                        let _e347 = (bitcast<f32>((bitcast<u32>(_e330) & 2147483647u)) * 0.00000011920929f);
                        phi_527_ = select(0.00000000000011368684f, _e347, (_e347 > 0.00000000000011368684f));
                    } else {
                        phi_527_ = 0f;
                    }
                    let _e351 = phi_527_;
                    let _e352 = (_e330 + _e351);
                    let _e353 = (_e330 - _e351);
                    let _e354 = select(_e339, 0f, _e343);
                    if _e343 {
                        phi_538_ = 38685626000000000000000000f;
                    } else {
                        phi_538_ = (1f / _e339);
                    }
                    let _e357 = phi_538_;
                    let _e358 = (_e243 == 0u);
                    if _e358 {
                        phi_547_ = _e280[0];
                    } else {
                        phi_547_ = _e280[1];
                    }
                    let _e362 = phi_547_;
                    let _e363 = (_e243 == 2u);
                    if _e363 {
                        phi_553_ = _e280[2];
                    } else {
                        phi_553_ = _e362;
                    }
                    let _e366 = phi_553_;
                    let _e368 = ((_e366 * _e253) * _e259);
                    if _e358 {
                        phi_564_ = _e292[0];
                    } else {
                        phi_564_ = _e292[1];
                    }
                    let _e372 = phi_564_;
                    if _e363 {
                        phi_570_ = _e292[2];
                    } else {
                        phi_570_ = _e372;
                    }
                    let _e375 = phi_570_;
                    let _e377 = ((_e375 * _e270) * _e276);
                    let _e381 = (bitcast<f32>((bitcast<u32>(_e377) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e381 {
                        let _e385 = (bitcast<f32>((bitcast<u32>(_e368) & 2147483647u)) * 0.00000011920929f);
                        phi_593_ = select(0.00000000000011368684f, _e385, (_e385 > 0.00000000000011368684f));
                    } else {
                        phi_593_ = 0f;
                    }
                    let _e389 = phi_593_;
                    let _e390 = (_e368 + _e389);
                    let _e391 = (_e368 - _e389);
                    let _e392 = select(_e377, 0f, _e381);
                    if _e381 {
                        phi_604_ = 38685626000000000000000000f;
                    } else {
                        phi_604_ = (1f / _e377);
                    }
                    let _e395 = phi_604_;
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
                        phi_704_ = select(-340282350000000000000000000000000000000f, _e436, (_e436 > -340282350000000000000000000000000000000f));
                        phi_705_ = select(-340282350000000000000000000000000000000f, _e429, (_e429 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_704_ = 0f;
                        phi_705_ = 1f;
                    }
                    let _e440 = phi_704_;
                    let _e442 = phi_705_;
                    local_7 = array<type_18, 8>(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_8 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 3>(bitcast<f32>(_e90), bitcast<f32>(_e94), bitcast<f32>(_e98));
                    let _e446 = (_e242 % 3u);
                    let _e447 = (_e446 < 3u);
                    if _e447 {
                    } else {
                        break;
                    }
                    let _e449 = local_10[_e446];
                    let _e450 = (_e241 % 3u);
                    let _e451 = (_e450 < 3u);
                    if _e451 {
                    } else {
                        break;
                    }
                    let _e453 = local_10[_e450];
                    let _e454 = (_e243 % 3u);
                    let _e455 = (_e454 < 3u);
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e457 = local_10[_e454];
                    local_9 = array<f32, 3>(bitcast<f32>(_e102), bitcast<f32>(_e106), bitcast<f32>(_e110));
                    if _e447 {
                    } else {
                        break;
                    }
                    let _e461 = local_9[_e446];
                    if _e451 {
                    } else {
                        break;
                    }
                    let _e463 = local_9[_e450];
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e465 = local_9[_e454];
                    phi_3198_ = false;
                    phi_3118_ = _e440;
                    phi_831_ = type_52(type_44(array<f32, 3>(_e449, _e453, _e457), array<f32, 3>(_e461, _e463, _e465)), select(0u, 2147483648u, (_e79 == 0u)));
                    phi_834_ = ((3u * _e79) + 1u);
                    phi_836_ = (_e442 <= _e440);
                    phi_838_ = 0u;
                    loop {
                        let _e473 = phi_3198_;
                        let _e475 = phi_3118_;
                        let _e477 = phi_831_;
                        let _e479 = phi_834_;
                        let _e481 = phi_836_;
                        let _e483 = phi_838_;
                        if _e481 {
                            phi_849_ = true;
                        } else {
                            phi_849_ = (_e483 > 0u);
                        }
                        let _e486 = phi_849_;
                        if _e486 {
                            let _e487 = (_e479 > 0u);
                            if _e487 {
                                if _e481 {
                                    phi_936_ = _e477;
                                    phi_937_ = _e481;
                                    phi_938_ = _e483;
                                } else {
                                    let _e488 = (_e483 - 1u);
                                    let _e489 = (_e488 % 128u);
                                    let _e490 = (_e489 < 128u);
                                    if _e490 {
                                    } else {
                                        phi_3305_ = true;
                                        break;
                                    }
                                    let _e492 = local_6[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3305_ = true;
                                        break;
                                    }
                                    let _e494 = local_5[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3305_ = true;
                                        break;
                                    }
                                    let _e496 = local_4[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3305_ = true;
                                        break;
                                    }
                                    let _e498 = local_3[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3305_ = true;
                                        break;
                                    }
                                    let _e501 = local_2[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3305_ = true;
                                        break;
                                    }
                                    let _e503 = local_1[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3305_ = true;
                                        break;
                                    }
                                    let _e505 = local[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3305_ = true;
                                        break;
                                    }
                                    let _e510 = local_8[_e489];
                                    phi_936_ = type_52(type_44(array<f32, 3>(_e494, _e496, _e498), array<f32, 3>(_e501, _e503, _e505)), _e492);
                                    phi_937_ = (_e510 <= _e475);
                                    phi_938_ = _e488;
                                }
                                let _e513 = phi_936_;
                                let _e515 = phi_937_;
                                let _e517 = phi_938_;
                                if _e515 {
                                    if ((_e513.member_1 & 2147483648u) != 0u) {
                                        phi_3195_ = _e473;
                                        phi_3167_ = _e475;
                                        phi_957_ = type_4(0u, ((_e513.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e869 = phi_3195_;
                                            let _e871 = phi_3167_;
                                            let _e873 = phi_957_;
                                            if (_e873.member < _e873.member_1) {
                                                phi_958_ = type_4((_e873.member + 1u), _e873.member_1);
                                                phi_981_ = type_4(1u, _e873.member);
                                            } else {
                                                phi_958_ = _e873;
                                                phi_981_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e886 = phi_958_;
                                            let _e888 = phi_981_;
                                            let _e892 = (bitcast<i32>(_e888.member) != 0i);
                                            if _e892 {
                                                let _e893 = ((_e513.member_1 & 268435455u) + _e888.member_1);
                                                let _e894 = (_e893 < arrayLength((&global_6.member)));
                                                if _e894 {
                                                    if _e894 {
                                                    } else {
                                                        phi_3414_ = _e871;
                                                        phi_3300_ = true;
                                                        break;
                                                    }
                                                    let _e897 = global_6.member[_e893].member_1;
                                                    phi_1006_ = _e897;
                                                } else {
                                                    phi_1006_ = 4294967295u;
                                                }
                                                let _e899 = phi_1006_;
                                                if _e894 {
                                                    if _e894 {
                                                    } else {
                                                        phi_3414_ = _e871;
                                                        phi_3300_ = true;
                                                        break;
                                                    }
                                                    let _e901 = global_6.member[_e893];
                                                    phi_1022_ = _e901;
                                                } else {
                                                    phi_1022_ = type_46(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e903 = phi_1022_;
                                                let _e915 = ((10u * _e242) & 31u);
                                                let _e918 = ((_e903.member[0] >> bitcast<u32>(_e915)) & 1023u);
                                                let _e923 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[0] - _e513.member.member[0]) * 0.0009775171f)) ^ _e114));
                                                let _e929 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e918) * _e923)) ^ _e114)));
                                                let _e933 = select(select(_e513.member.member_1[0], _e929, (_e929 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e918 == 1023u));
                                                let _e935 = ((10u * _e241) & 31u);
                                                let _e938 = ((_e903.member[0] >> bitcast<u32>(_e935)) & 1023u);
                                                let _e943 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[1] - _e513.member.member[1]) * 0.0009775171f)) ^ _e114));
                                                let _e949 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e938) * _e943)) ^ _e114)));
                                                let _e953 = select(select(_e513.member.member_1[1], _e949, (_e949 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e938 == 1023u));
                                                let _e955 = ((10u * _e243) & 31u);
                                                let _e958 = ((_e903.member[0] >> bitcast<u32>(_e955)) & 1023u);
                                                let _e963 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[2] - _e513.member.member[2]) * 0.0009775171f)) ^ _e114));
                                                let _e969 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e958) * _e963)) ^ _e114)));
                                                let _e973 = select(select(_e513.member.member_1[2], _e969, (_e969 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e958 == 1023u));
                                                let _e977 = ((_e903.member[1] >> bitcast<u32>(_e915)) & 1023u);
                                                let _e983 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e977) * _e923)) ^ _e114)));
                                                let _e987 = select(select(_e513.member.member_1[0], _e983, (_e983 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e977 == 1023u));
                                                let _e990 = ((_e903.member[1] >> bitcast<u32>(_e935)) & 1023u);
                                                let _e996 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e990) * _e943)) ^ _e114)));
                                                let _e1000 = select(select(_e513.member.member_1[1], _e996, (_e996 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e990 == 1023u));
                                                let _e1003 = ((_e903.member[1] >> bitcast<u32>(_e955)) & 1023u);
                                                let _e1009 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1003) * _e963)) ^ _e114)));
                                                let _e1013 = select(select(_e513.member.member_1[2], _e1009, (_e1009 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e1003 == 1023u));
                                                let _e1017 = ((_e903.member[2] >> bitcast<u32>(_e915)) & 1023u);
                                                let _e1023 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1017) * _e923)) ^ _e114)));
                                                let _e1027 = select(select(_e513.member.member_1[0], _e1023, (_e1023 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e1017 == 1023u));
                                                let _e1030 = ((_e903.member[2] >> bitcast<u32>(_e935)) & 1023u);
                                                let _e1036 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1030) * _e943)) ^ _e114)));
                                                let _e1040 = select(select(_e513.member.member_1[1], _e1036, (_e1036 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e1030 == 1023u));
                                                let _e1043 = ((_e903.member[2] >> bitcast<u32>(_e955)) & 1023u);
                                                let _e1049 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1043) * _e963)) ^ _e114)));
                                                let _e1053 = select(select(_e513.member.member_1[2], _e1049, (_e1049 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e1043 == 1023u));
                                                let _e1056 = (_e973 - _e368);
                                                let _e1059 = (((_e933 - _e291) * _e392) - (_e1056 * _e316));
                                                let _e1062 = (((_e953 - _e330) * _e392) - (_e1056 * _e354));
                                                let _e1065 = (_e1013 - _e368);
                                                let _e1068 = (((_e987 - _e291) * _e392) - (_e1065 * _e316));
                                                let _e1071 = (((_e1000 - _e330) * _e392) - (_e1065 * _e354));
                                                let _e1074 = (_e1053 - _e368);
                                                let _e1077 = (((_e1027 - _e291) * _e392) - (_e1074 * _e316));
                                                let _e1080 = (((_e1040 - _e330) * _e392) - (_e1074 * _e354));
                                                let _e1081 = (_e1077 * _e1071);
                                                let _e1082 = (_e1080 * _e1068);
                                                let _e1083 = (_e1059 * _e1080);
                                                let _e1084 = (_e1062 * _e1077);
                                                let _e1085 = (_e1068 * _e1062);
                                                let _e1086 = (_e1071 * _e1059);
                                                let _e1091 = (((_e1081 >= _e1082) && (_e1083 >= _e1084)) && (_e1085 >= _e1086));
                                                if (_e1091 || (((_e1081 <= _e1082) && (_e1083 <= _e1084)) && (_e1085 <= _e1086))) {
                                                    let _e1098 = select(-1f, 1f, _e1091);
                                                    let _e1100 = ((_e1081 - _e1082) * _e1098);
                                                    let _e1102 = select(0f, _e1100, (_e1100 > 0f));
                                                    let _e1104 = ((_e1083 - _e1084) * _e1098);
                                                    let _e1106 = select(0f, _e1104, (_e1104 > 0f));
                                                    let _e1108 = ((_e1085 - _e1086) * _e1098);
                                                    let _e1110 = select(0f, _e1108, (_e1108 > 0f));
                                                    let _e1112 = ((_e1102 + _e1106) + _e1110);
                                                    if (_e1112 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1824_ = type_18();
                                                        phi_1825_ = true;
                                                    } else {
                                                        let _e1115 = select(_e987, _e933, (_e933 < _e987));
                                                        let _e1119 = select(_e987, _e933, (_e933 > _e987));
                                                        let _e1123 = select(_e1000, _e953, (_e953 < _e1000));
                                                        let _e1127 = select(_e1000, _e953, (_e953 > _e1000));
                                                        let _e1131 = select(_e1013, _e973, (_e973 < _e1013));
                                                        let _e1135 = select(_e1013, _e973, (_e973 > _e1013));
                                                        let _e1140 = ((select(_e1027, _e1115, (_e1115 < _e1027)) - _e314) * _e319);
                                                        let _e1141 = ((select(_e1027, _e1119, (_e1119 > _e1027)) - _e315) * _e319);
                                                        let _e1144 = ((select(_e1040, _e1123, (_e1123 < _e1040)) - _e352) * _e357);
                                                        let _e1145 = ((select(_e1040, _e1127, (_e1127 > _e1040)) - _e353) * _e357);
                                                        let _e1148 = ((select(_e1053, _e1131, (_e1131 < _e1053)) - _e390) * _e395);
                                                        let _e1149 = ((select(_e1053, _e1135, (_e1135 > _e1053)) - _e391) * _e395);
                                                        let _e1151 = select(_e1149, _e1148, (_e1148 < _e1149));
                                                        let _e1153 = select(_e1149, _e1148, (_e1148 > _e1149));
                                                        let _e1155 = select(_e1141, _e1140, (_e1140 < _e1141));
                                                        let _e1157 = select(_e1145, _e1144, (_e1144 < _e1145));
                                                        let _e1159 = select(_e1157, _e1155, (_e1155 > _e1157));
                                                        let _e1161 = select(_e1151, _e1159, (_e1159 > _e1151));
                                                        let _e1163 = select(_e1141, _e1140, (_e1140 > _e1141));
                                                        let _e1165 = select(_e1145, _e1144, (_e1144 > _e1145));
                                                        let _e1167 = select(_e1165, _e1163, (_e1163 < _e1165));
                                                        let _e1169 = select(_e1153, _e1167, (_e1167 < _e1153));
                                                        let _e1170 = -(_e1151);
                                                        let _e1176 = select(_e442, _e1161, (_e1161 > _e442));
                                                        if (_e1176 > (_e1169 + (select(_e1170, _e1153, (_e1153 > _e1170)) * 0.0000019073523f))) {
                                                            phi_1819_ = type_18();
                                                            phi_1820_ = true;
                                                        } else {
                                                            let _e1178 = (_e1176 > _e871);
                                                            if _e1178 {
                                                                phi_1818_ = type_18();
                                                            } else {
                                                                let _e1182 = (_e987 - _e933);
                                                                let _e1183 = (_e1000 - _e953);
                                                                let _e1184 = (_e1013 - _e973);
                                                                let _e1185 = vec3<f32>(_e1182, _e1183, _e1184);
                                                                let _e1186 = (_e1027 - _e987);
                                                                let _e1187 = (_e1040 - _e1000);
                                                                let _e1188 = (_e1053 - _e1013);
                                                                let _e1189 = vec3<f32>(_e1186, _e1187, _e1188);
                                                                let _e1190 = (_e933 - _e1027);
                                                                let _e1191 = (_e953 - _e1040);
                                                                let _e1192 = (_e973 - _e1053);
                                                                let _e1193 = vec3<f32>(_e1190, _e1191, _e1192);
                                                                let _e1196 = bitcast<f32>((bitcast<u32>(_e1182) & 2147483647u));
                                                                let _e1199 = bitcast<f32>((bitcast<u32>(_e1183) & 2147483647u));
                                                                let _e1201 = select(_e1199, _e1196, (_e1196 > _e1199));
                                                                let _e1204 = bitcast<f32>((bitcast<u32>(_e1184) & 2147483647u));
                                                                let _e1206 = select(_e1204, _e1201, (_e1201 > _e1204));
                                                                let _e1209 = bitcast<f32>((bitcast<u32>(_e1186) & 2147483647u));
                                                                let _e1212 = bitcast<f32>((bitcast<u32>(_e1187) & 2147483647u));
                                                                let _e1214 = select(_e1212, _e1209, (_e1209 > _e1212));
                                                                let _e1217 = bitcast<f32>((bitcast<u32>(_e1188) & 2147483647u));
                                                                let _e1219 = select(_e1217, _e1214, (_e1214 > _e1217));
                                                                let _e1222 = bitcast<f32>((bitcast<u32>(_e1190) & 2147483647u));
                                                                let _e1225 = bitcast<f32>((bitcast<u32>(_e1191) & 2147483647u));
                                                                let _e1227 = select(_e1225, _e1222, (_e1222 > _e1225));
                                                                let _e1230 = bitcast<f32>((bitcast<u32>(_e1192) & 2147483647u));
                                                                let _e1232 = select(_e1230, _e1227, (_e1227 > _e1230));
                                                                let _e1234 = select(_e1219, _e1206, (_e1206 > _e1219));
                                                                let _e1236 = select(_e1232, _e1234, (_e1234 > _e1232));
                                                                if (_e1206 == _e1236) {
                                                                    phi_1729_ = _e1189;
                                                                    phi_1730_ = _e1193;
                                                                } else {
                                                                    let _e1239 = vec3((_e1219 == _e1236));
                                                                    phi_1729_ = select(_e1185, _e1193, _e1239);
                                                                    phi_1730_ = select(_e1189, _e1185, _e1239);
                                                                }
                                                                let _e1243 = phi_1729_;
                                                                let _e1245 = phi_1730_;
                                                                let _e1252 = ((_e1243.y * _e1245.z) - (_e1245.y * _e1243.z));
                                                                let _e1257 = ((_e1243.z * _e1245.x) - (_e1245.z * _e1243.x));
                                                                let _e1260 = ((_e1243.x * _e1245.y) - (_e1245.x * _e1243.y));
                                                                if (_e1102 >= _e1106) {
                                                                    phi_1761_ = select(true, false, (_e1102 >= _e1110));
                                                                } else {
                                                                    phi_1761_ = true;
                                                                }
                                                                let _e1265 = phi_1761_;
                                                                if _e1265 {
                                                                    phi_1770_ = select(vec3<f32>(_e1027, _e1040, _e1053), vec3<f32>(_e987, _e1000, _e1013), vec3((_e1106 >= _e1110)));
                                                                } else {
                                                                    phi_1770_ = vec3<f32>(_e933, _e953, _e973);
                                                                }
                                                                let _e1270 = phi_1770_;
                                                                let _e1287 = ((((_e1252 * (_e1270.x - _e291)) + (_e1257 * (_e1270.y - _e330))) + (_e1260 * (_e1270.z - _e368))) / (((_e1252 * _e316) + (_e1257 * _e354)) + (_e1260 * _e392)));
                                                                let _e1289 = select(_e1169, _e1287, (_e1287 < _e1169));
                                                                let _e1291 = select(_e1161, _e1289, (_e1289 > _e1161));
                                                                if (_e1291 >= _e442) {
                                                                    let _e1293 = (_e1291 <= _e871);
                                                                    if _e1293 {
                                                                        let _e1294 = (1f / _e1112);
                                                                        phi_1810_ = type_18(_e1291, (_e1106 * _e1294), (_e1110 * _e1294), _e899);
                                                                    } else {
                                                                        phi_1810_ = type_18();
                                                                    }
                                                                    let _e1299 = phi_1810_;
                                                                    phi_1812_ = _e1299;
                                                                    phi_1813_ = select(true, false, _e1293);
                                                                } else {
                                                                    phi_1812_ = type_18();
                                                                    phi_1813_ = true;
                                                                }
                                                                let _e1302 = phi_1812_;
                                                                let _e1304 = phi_1813_;
                                                                if _e1304 {
                                                                    phi_1817_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1817_ = _e1302;
                                                                }
                                                                let _e1306 = phi_1817_;
                                                                phi_1818_ = _e1306;
                                                            }
                                                            let _e1308 = phi_1818_;
                                                            phi_1819_ = _e1308;
                                                            phi_1820_ = _e1178;
                                                        }
                                                        let _e1310 = phi_1819_;
                                                        let _e1312 = phi_1820_;
                                                        phi_1824_ = _e1310;
                                                        phi_1825_ = _e1312;
                                                    }
                                                    let _e1314 = phi_1824_;
                                                    let _e1316 = phi_1825_;
                                                    phi_1829_ = _e1314;
                                                    phi_1830_ = _e1316;
                                                } else {
                                                    phi_1829_ = type_18();
                                                    phi_1830_ = true;
                                                }
                                                let _e1318 = phi_1829_;
                                                let _e1320 = phi_1830_;
                                                if _e1320 {
                                                    phi_1834_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1834_ = _e1318;
                                                }
                                                let _e1322 = phi_1834_;
                                                if (_e1322.member_3 != 4294967295u) {
                                                    if (_e899 != 4294967295u) {
                                                        phi_1846_ = type_4(0u, 8u);
                                                        phi_1849_ = _e1322;
                                                        loop {
                                                            let _e1327 = phi_1846_;
                                                            let _e1329 = phi_1849_;
                                                            if (_e1327.member < _e1327.member_1) {
                                                                phi_1847_ = type_4((_e1327.member + 1u), _e1327.member_1);
                                                                phi_1872_ = type_4(1u, _e1327.member);
                                                            } else {
                                                                phi_1847_ = _e1327;
                                                                phi_1872_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1342 = phi_1847_;
                                                            let _e1344 = phi_1872_;
                                                            let _e1348 = (bitcast<i32>(_e1344.member) != 0i);
                                                            if _e1348 {
                                                                let _e1349 = (_e1344.member_1 < 8u);
                                                                if _e1349 {
                                                                } else {
                                                                    phi_3168_ = true;
                                                                    break;
                                                                }
                                                                let _e1354 = local_7[_e1344.member_1].member;
                                                                if (_e1329.member < _e1354) {
                                                                    phi_1905_ = true;
                                                                } else {
                                                                    let _e1356 = local_7[_e1344.member_1].member;
                                                                    if (_e1329.member == _e1356) {
                                                                        let _e1361 = local_7[_e1344.member_1].member_3;
                                                                        phi_1904_ = (_e1329.member_3 < _e1361);
                                                                    } else {
                                                                        phi_1904_ = false;
                                                                    }
                                                                    let _e1364 = phi_1904_;
                                                                    phi_1905_ = _e1364;
                                                                }
                                                                let _e1366 = phi_1905_;
                                                                if _e1366 {
                                                                    if _e1349 {
                                                                    } else {
                                                                        phi_3168_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1367 = local_7[_e1344.member_1];
                                                                    local_7[_e1344.member_1] = type_18(_e1329.member, _e1329.member_1, _e1329.member_2, _e1329.member_3);
                                                                    phi_1926_ = type_18(_e1367.member, _e1367.member_1, _e1367.member_2, _e1367.member_3);
                                                                } else {
                                                                    phi_1926_ = _e1329;
                                                                }
                                                                let _e1378 = phi_1926_;
                                                                phi_1850_ = _e1378;
                                                            } else {
                                                                phi_1850_ = type_18();
                                                            }
                                                            let _e1380 = phi_1850_;
                                                            continue;
                                                            continuing {
                                                                phi_1846_ = _e1342;
                                                                phi_1849_ = _e1380;
                                                                phi_3168_ = _e869;
                                                                break if !(_e1348);
                                                            }
                                                        }
                                                        let _e1383 = phi_3168_;
                                                        phi_3414_ = _e871;
                                                        phi_3300_ = _e1383;
                                                        if _e1383 {
                                                            break;
                                                        }
                                                        let _e1386 = local_7[7u].member_3;
                                                        if (_e1386 != 4294967295u) {
                                                            let _e1390 = local_7[7u].member;
                                                            phi_3477_ = _e1390;
                                                        } else {
                                                            phi_3477_ = _e871;
                                                        }
                                                        let _e1392 = phi_3477_;
                                                        phi_3476_ = _e1392;
                                                        phi_3303_ = _e1383;
                                                    } else {
                                                        phi_3476_ = _e871;
                                                        phi_3303_ = _e869;
                                                    }
                                                    let _e1394 = phi_3476_;
                                                    let _e1396 = phi_3303_;
                                                    phi_3475_ = _e1394;
                                                    phi_3302_ = _e1396;
                                                } else {
                                                    phi_3475_ = _e871;
                                                    phi_3302_ = _e869;
                                                }
                                                let _e1398 = phi_3475_;
                                                let _e1400 = phi_3302_;
                                                phi_3474_ = _e1398;
                                                phi_3301_ = _e1400;
                                            } else {
                                                phi_3474_ = _e871;
                                                phi_3301_ = _e869;
                                            }
                                            let _e1402 = phi_3474_;
                                            let _e1404 = phi_3301_;
                                            continue;
                                            continuing {
                                                phi_3195_ = _e1404;
                                                phi_3167_ = _e1402;
                                                phi_957_ = _e886;
                                                phi_3414_ = _e1402;
                                                phi_3300_ = _e1404;
                                                break if !(_e892);
                                            }
                                        }
                                        let _e1407 = phi_3414_;
                                        let _e1409 = phi_3300_;
                                        phi_3305_ = _e1409;
                                        if _e1409 {
                                            break;
                                        }
                                        phi_3379_ = _e1407;
                                        phi_3309_ = _e1409;
                                        phi_2887_ = _e513;
                                        phi_2888_ = false;
                                        phi_2889_ = _e517;
                                    } else {
                                        let _e527 = (_e513.member_1 < _e79);
                                        if _e527 {
                                            if _e527 {
                                            } else {
                                                phi_3305_ = true;
                                                break;
                                            }
                                            let _e529 = global_4.member[_e513.member_1];
                                            phi_1956_ = _e529;
                                        } else {
                                            phi_1956_ = type_39(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e531 = phi_1956_;
                                        let _e546 = ((10u * _e242) & 31u);
                                        let _e549 = ((_e531.member[0] >> bitcast<u32>(_e546)) & 1023u);
                                        let _e554 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[0] - _e513.member.member[0]) * 0.0009775171f)) ^ _e114));
                                        let _e560 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e549) * _e554)) ^ _e114)));
                                        let _e564 = select(select(_e513.member.member_1[0], _e560, (_e560 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e549 == 1023u));
                                        let _e566 = ((10u * _e241) & 31u);
                                        let _e569 = ((_e531.member[0] >> bitcast<u32>(_e566)) & 1023u);
                                        let _e574 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[1] - _e513.member.member[1]) * 0.0009775171f)) ^ _e114));
                                        let _e580 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e569) * _e574)) ^ _e114)));
                                        let _e584 = select(select(_e513.member.member_1[1], _e580, (_e580 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e569 == 1023u));
                                        let _e586 = ((10u * _e243) & 31u);
                                        let _e589 = ((_e531.member[0] >> bitcast<u32>(_e586)) & 1023u);
                                        let _e594 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[2] - _e513.member.member[2]) * 0.0009775171f)) ^ _e114));
                                        let _e600 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e589) * _e594)) ^ _e114)));
                                        let _e604 = select(select(_e513.member.member_1[2], _e600, (_e600 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e589 == 1023u));
                                        let _e607 = ((_e531.member[1] >> bitcast<u32>(_e546)) & 1023u);
                                        let _e613 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e607) * _e554)) ^ _e114)));
                                        let _e617 = select(select(_e513.member.member_1[0], _e613, (_e613 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e607 == 1023u));
                                        let _e620 = ((_e531.member[1] >> bitcast<u32>(_e566)) & 1023u);
                                        let _e626 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e620) * _e574)) ^ _e114)));
                                        let _e630 = select(select(_e513.member.member_1[1], _e626, (_e626 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e620 == 1023u));
                                        let _e633 = ((_e531.member[1] >> bitcast<u32>(_e586)) & 1023u);
                                        let _e639 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e633) * _e594)) ^ _e114)));
                                        let _e643 = select(select(_e513.member.member_1[2], _e639, (_e639 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e633 == 1023u));
                                        let _e649 = ((_e531.member_1[0] >> bitcast<u32>(_e546)) & 1023u);
                                        let _e655 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e649) * _e554)) ^ _e114)));
                                        let _e659 = select(select(_e513.member.member_1[0], _e655, (_e655 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e649 == 1023u));
                                        let _e662 = ((_e531.member_1[0] >> bitcast<u32>(_e566)) & 1023u);
                                        let _e668 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e662) * _e574)) ^ _e114)));
                                        let _e672 = select(select(_e513.member.member_1[1], _e668, (_e668 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e662 == 1023u));
                                        let _e675 = ((_e531.member_1[0] >> bitcast<u32>(_e586)) & 1023u);
                                        let _e681 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e675) * _e594)) ^ _e114)));
                                        let _e685 = select(select(_e513.member.member_1[2], _e681, (_e681 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e675 == 1023u));
                                        let _e688 = ((_e531.member_1[1] >> bitcast<u32>(_e546)) & 1023u);
                                        let _e694 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e688) * _e554)) ^ _e114)));
                                        let _e698 = select(select(_e513.member.member_1[0], _e694, (_e694 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e688 == 1023u));
                                        let _e701 = ((_e531.member_1[1] >> bitcast<u32>(_e566)) & 1023u);
                                        let _e707 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e701) * _e574)) ^ _e114)));
                                        let _e711 = select(select(_e513.member.member_1[1], _e707, (_e707 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e701 == 1023u));
                                        let _e714 = ((_e531.member_1[1] >> bitcast<u32>(_e586)) & 1023u);
                                        let _e720 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e714) * _e594)) ^ _e114)));
                                        let _e724 = select(select(_e513.member.member_1[2], _e720, (_e720 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e714 == 1023u));
                                        let _e729 = type_52(type_44(array<f32, 3>(_e564, _e584, _e604), array<f32, 3>(_e617, _e630, _e643)), _e531.member_2);
                                        let _e734 = type_52(type_44(array<f32, 3>(_e659, _e672, _e685), array<f32, 3>(_e698, _e711, _e724)), _e531.member_3);
                                        let _e739 = ((_e564 - _e314) * _e319);
                                        let _e740 = ((_e659 - _e314) * _e319);
                                        let _e741 = ((_e617 - _e315) * _e319);
                                        let _e742 = ((_e698 - _e315) * _e319);
                                        let _e747 = ((_e584 - _e352) * _e357);
                                        let _e748 = ((_e672 - _e352) * _e357);
                                        let _e749 = ((_e630 - _e353) * _e357);
                                        let _e750 = ((_e711 - _e353) * _e357);
                                        let _e755 = ((_e604 - _e390) * _e395);
                                        let _e756 = ((_e685 - _e390) * _e395);
                                        let _e757 = ((_e643 - _e391) * _e395);
                                        let _e758 = ((_e724 - _e391) * _e395);
                                        let _e760 = select(_e757, _e755, (_e755 < _e757));
                                        let _e762 = select(_e758, _e756, (_e756 < _e758));
                                        let _e764 = select(_e757, _e755, (_e755 > _e757));
                                        let _e766 = select(_e758, _e756, (_e756 > _e758));
                                        let _e768 = select(_e741, _e739, (_e739 < _e741));
                                        let _e770 = select(_e742, _e740, (_e740 < _e742));
                                        let _e772 = select(_e749, _e747, (_e747 < _e749));
                                        let _e774 = select(_e750, _e748, (_e748 < _e750));
                                        let _e776 = select(_e772, _e768, (_e768 > _e772));
                                        let _e778 = select(_e774, _e770, (_e770 > _e774));
                                        let _e780 = select(_e760, _e776, (_e776 > _e760));
                                        let _e782 = select(_e762, _e778, (_e778 > _e762));
                                        let _e784 = select(_e741, _e739, (_e739 > _e741));
                                        let _e786 = select(_e742, _e740, (_e740 > _e742));
                                        let _e788 = select(_e749, _e747, (_e747 > _e749));
                                        let _e790 = select(_e750, _e748, (_e748 > _e750));
                                        let _e792 = select(_e788, _e784, (_e784 < _e788));
                                        let _e794 = select(_e790, _e786, (_e786 < _e790));
                                        let _e799 = -(_e760);
                                        let _e800 = -(_e762);
                                        let _e807 = (select(_e764, _e792, (_e792 < _e764)) + (select(_e799, _e764, (_e764 > _e799)) * 0.0000019073523f));
                                        let _e808 = (select(_e766, _e794, (_e794 < _e766)) + (select(_e800, _e766, (_e766 > _e800)) * 0.0000019073523f));
                                        let _e810 = select(_e442, _e780, (_e780 > _e442));
                                        let _e812 = select(_e442, _e782, (_e782 > _e442));
                                        let _e817 = (_e810 <= select(_e475, _e807, (_e807 < _e475)));
                                        let _e818 = (_e812 <= select(_e475, _e808, (_e808 < _e475)));
                                        let _e819 = (_e810 <= _e812);
                                        if _e817 {
                                            if _e818 {
                                                if _e819 {
                                                    phi_2789_ = _e734;
                                                } else {
                                                    phi_2789_ = _e729;
                                                }
                                                let _e821 = phi_2789_;
                                                let _e829 = (_e517 % 128u);
                                                let _e830 = (_e829 < 128u);
                                                if _e830 {
                                                } else {
                                                    phi_3305_ = true;
                                                    break;
                                                }
                                                local_6[_e829] = _e821.member_1;
                                                if _e830 {
                                                } else {
                                                    phi_3305_ = true;
                                                    break;
                                                }
                                                local_5[_e829] = _e821.member.member[0];
                                                if _e830 {
                                                } else {
                                                    phi_3305_ = true;
                                                    break;
                                                }
                                                local_4[_e829] = _e821.member.member[1];
                                                if _e830 {
                                                } else {
                                                    phi_3305_ = true;
                                                    break;
                                                }
                                                local_3[_e829] = _e821.member.member[2];
                                                if _e830 {
                                                } else {
                                                    phi_3305_ = true;
                                                    break;
                                                }
                                                local_2[_e829] = _e821.member.member_1[0];
                                                if _e830 {
                                                } else {
                                                    phi_3305_ = true;
                                                    break;
                                                }
                                                local_1[_e829] = _e821.member.member_1[1];
                                                if _e830 {
                                                } else {
                                                    phi_3305_ = true;
                                                    break;
                                                }
                                                local[_e829] = _e821.member.member_1[2];
                                                if _e830 {
                                                } else {
                                                    phi_3305_ = true;
                                                    break;
                                                }
                                                local_8[_e829] = select(_e812, _e810, (_e810 > _e812));
                                                if _e819 {
                                                    phi_2866_ = _e729;
                                                } else {
                                                    phi_2866_ = _e734;
                                                }
                                                let _e847 = phi_2866_;
                                                phi_2867_ = _e847;
                                                phi_2868_ = (_e517 + 1u);
                                            } else {
                                                phi_2867_ = type_52();
                                                phi_2868_ = u32();
                                            }
                                            let _e849 = phi_2867_;
                                            let _e851 = phi_2868_;
                                            phi_2870_ = _e849;
                                            phi_2871_ = _e851;
                                            phi_2872_ = select(true, false, _e818);
                                        } else {
                                            phi_2870_ = type_52();
                                            phi_2871_ = u32();
                                            phi_2872_ = true;
                                        }
                                        let _e854 = phi_2870_;
                                        let _e856 = phi_2871_;
                                        let _e858 = phi_2872_;
                                        if _e858 {
                                            if _e817 {
                                                phi_2879_ = _e729;
                                            } else {
                                                phi_2879_ = _e734;
                                            }
                                            let _e860 = phi_2879_;
                                            phi_2884_ = _e860;
                                            phi_2885_ = select(_e818, true, _e817);
                                        } else {
                                            phi_2884_ = _e854;
                                            phi_2885_ = _e515;
                                        }
                                        let _e863 = phi_2884_;
                                        let _e865 = phi_2885_;
                                        phi_3379_ = _e475;
                                        phi_3309_ = _e473;
                                        phi_2887_ = _e863;
                                        phi_2888_ = _e865;
                                        phi_2889_ = select(_e856, _e517, _e858);
                                    }
                                    let _e1411 = phi_3379_;
                                    let _e1413 = phi_3309_;
                                    let _e1415 = phi_2887_;
                                    let _e1417 = phi_2888_;
                                    let _e1419 = phi_2889_;
                                    phi_3378_ = _e1411;
                                    phi_3308_ = _e1413;
                                    phi_2890_ = _e1415;
                                    phi_2891_ = (_e479 - 1u);
                                    phi_2892_ = _e1417;
                                    phi_2893_ = _e1419;
                                } else {
                                    phi_3378_ = _e475;
                                    phi_3308_ = _e473;
                                    phi_2890_ = _e513;
                                    phi_2891_ = _e479;
                                    phi_2892_ = _e515;
                                    phi_2893_ = _e517;
                                }
                                let _e1421 = phi_3378_;
                                let _e1423 = phi_3308_;
                                let _e1425 = phi_2890_;
                                let _e1427 = phi_2891_;
                                let _e1429 = phi_2892_;
                                let _e1431 = phi_2893_;
                                phi_3377_ = _e1421;
                                phi_3307_ = _e1423;
                                phi_2894_ = _e1425;
                                phi_2895_ = _e1427;
                                phi_2896_ = _e1429;
                                phi_2897_ = _e1431;
                            } else {
                                phi_3377_ = _e475;
                                phi_3307_ = _e473;
                                phi_2894_ = type_52();
                                phi_2895_ = u32();
                                phi_2896_ = bool();
                                phi_2897_ = u32();
                            }
                            let _e1433 = phi_3377_;
                            let _e1435 = phi_3307_;
                            let _e1437 = phi_2894_;
                            let _e1439 = phi_2895_;
                            let _e1441 = phi_2896_;
                            let _e1443 = phi_2897_;
                            phi_3376_ = _e1433;
                            phi_3306_ = _e1435;
                            phi_832_ = _e1437;
                            phi_835_ = _e1439;
                            phi_837_ = _e1441;
                            phi_839_ = _e1443;
                            phi_2898_ = _e487;
                        } else {
                            phi_3376_ = _e475;
                            phi_3306_ = _e473;
                            phi_832_ = type_52();
                            phi_835_ = u32();
                            phi_837_ = bool();
                            phi_839_ = u32();
                            phi_2898_ = false;
                        }
                        let _e1445 = phi_3376_;
                        let _e1447 = phi_3306_;
                        let _e1449 = phi_832_;
                        let _e1451 = phi_835_;
                        let _e1453 = phi_837_;
                        let _e1455 = phi_839_;
                        let _e1457 = phi_2898_;
                        continue;
                        continuing {
                            phi_3198_ = _e1447;
                            phi_3118_ = _e1445;
                            phi_831_ = _e1449;
                            phi_834_ = _e1451;
                            phi_836_ = _e1453;
                            phi_838_ = _e1455;
                            phi_3305_ = _e1447;
                            break if !(_e1457);
                        }
                    }
                    let _e1460 = phi_3305_;
                    if _e1460 {
                        break;
                    }
                    phi_2905_ = type_4(0u, 8u);
                    loop {
                        let _e1462 = phi_2905_;
                        if (_e1462.member < _e1462.member_1) {
                            phi_2906_ = type_4((_e1462.member + 1u), _e1462.member_1);
                            phi_2929_ = type_4(1u, _e1462.member);
                        } else {
                            phi_2906_ = _e1462;
                            phi_2929_ = type_4(0u, type_4().member_1);
                        }
                        let _e1475 = phi_2906_;
                        let _e1477 = phi_2929_;
                        let _e1481 = (bitcast<i32>(_e1477.member) != 0i);
                        if _e1481 {
                            let _e1482 = (_e1477.member_1 < 8u);
                            if _e1482 {
                            } else {
                                phi_3369_ = true;
                                break;
                            }
                            let _e1484 = local_7[_e1477.member_1];
                            if (_e1484.member_3 != 4294967295u) {
                                let _e1490 = -(_e409);
                                let _e1491 = (_e1490 / 3i);
                                let _e1498 = bitcast<f32>((bitcast<u32>((_e1491 + 127i)) << bitcast<u32>(23i)));
                                let _e1506 = (((_e1484.member * _e1498) * _e1498) * bitcast<f32>((bitcast<u32>(((_e1490 - (2i * _e1491)) + 127i)) << bitcast<u32>(23i))));
                                let _e1508 = select(340282350000000000000000000000000000000f, _e1506, (_e1506 < 340282350000000000000000000000000000000f));
                                phi_2995_ = type_18(select(-340282350000000000000000000000000000000f, _e1508, (_e1508 > -340282350000000000000000000000000000000f)), _e1484.member_1, _e1484.member_2, _e1484.member_3);
                            } else {
                                phi_2995_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1513 = phi_2995_;
                            if _e1482 {
                            } else {
                                phi_3369_ = true;
                                break;
                            }
                            local_7[_e1477.member_1] = type_18(_e1513.member, _e1513.member_1, _e1513.member_2, _e1513.member_3);
                        }
                        continue;
                        continuing {
                            phi_2905_ = _e1475;
                            phi_3369_ = _e1460;
                            break if !(_e1481);
                        }
                    }
                    let _e1521 = phi_3369_;
                    if _e1521 {
                        break;
                    }
                    let _e1522 = local_7;
                    if _e130 {
                    } else {
                        break;
                    }
                    global_5.member[_e128] = array<type_18, 8>(type_18(_e1522[0].member, _e1522[0].member_1, _e1522[0].member_2, _e1522[0].member_3), type_18(_e1522[1].member, _e1522[1].member_1, _e1522[1].member_2, _e1522[1].member_3), type_18(_e1522[2].member, _e1522[2].member_1, _e1522[2].member_2, _e1522[2].member_3), type_18(_e1522[3].member, _e1522[3].member_1, _e1522[3].member_2, _e1522[3].member_3), type_18(_e1522[4].member, _e1522[4].member_1, _e1522[4].member_2, _e1522[4].member_3), type_18(_e1522[5].member, _e1522[5].member_1, _e1522[5].member_2, _e1522[5].member_3), type_18(_e1522[6].member, _e1522[6].member_1, _e1522[6].member_2, _e1522[6].member_3), type_18(_e1522[7].member, _e1522[7].member_1, _e1522[7].member_2, _e1522[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
