struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: array<array<u32, 4>>,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_25 {
    member: array<array<u32, 2>>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_35 {
    member: type_28,
    member_1: f32,
}

struct type_40 {
    member: array<type_29>,
}

struct type_42 {
    member: type_35,
    member_1: u32,
    member_2: u32,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: type_32,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_19;
@group(0) @binding(1) 
var<uniform> global_3: type_44;
@group(0) @binding(2) 
var<storage> global_4: type_9;
@group(0) @binding(4) 
var<storage> global_5: type_40;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_25;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_49, 128>;
    var phi_379_: i32;
    var phi_380_: i32;
    var phi_390_: bool;
    var phi_400_: u32;
    var phi_401_: u32;
    var phi_403_: bool;
    var phi_408_: u32;
    var phi_421_: i32;
    var phi_441_: i32;
    var phi_459_: f32;
    var phi_465_: f32;
    var phi_476_: f32;
    var phi_482_: f32;
    var phi_505_: f32;
    var phi_516_: f32;
    var phi_525_: f32;
    var phi_531_: f32;
    var phi_542_: f32;
    var phi_548_: f32;
    var phi_571_: f32;
    var phi_582_: f32;
    var phi_591_: f32;
    var phi_597_: f32;
    var phi_608_: f32;
    var phi_614_: f32;
    var phi_637_: f32;
    var phi_648_: f32;
    var phi_748_: f32;
    var phi_749_: f32;
    var phi_4215_: bool;
    var phi_1870_: type_42;
    var phi_1873_: type_49;
    var phi_1875_: u32;
    var phi_1877_: bool;
    var phi_1879_: u32;
    var phi_1890_: bool;
    var phi_1927_: type_49;
    var phi_1928_: bool;
    var phi_1929_: u32;
    var phi_3564_: u32;
    var phi_3565_: u32;
    var phi_3575_: u32;
    var phi_3577_: u32;
    var phi_3578_: bool;
    var phi_3598_: u32;
    var phi_3599_: u32;
    var phi_3603_: type_52;
    var phi_3947_: type_49;
    var phi_3980_: type_49;
    var phi_3981_: type_49;
    var phi_3982_: u32;
    var phi_3984_: type_49;
    var phi_3985_: u32;
    var phi_3986_: bool;
    var phi_3995_: type_49;
    var phi_4000_: type_49;
    var phi_4001_: bool;
    var phi_1947_: type_42;
    var phi_1950_: type_4;
    var phi_1951_: type_4;
    var phi_1973_: type_4;
    var phi_1997_: u32;
    var phi_2086_: array<array<f32, 3>, 3>;
    var phi_2557_: vec3<f32>;
    var phi_2558_: vec3<f32>;
    var phi_2589_: bool;
    var phi_2598_: vec3<f32>;
    var phi_2638_: type_28;
    var phi_2640_: type_28;
    var phi_2641_: bool;
    var phi_2645_: type_28;
    var phi_2646_: type_28;
    var phi_2647_: type_28;
    var phi_2648_: bool;
    var phi_2652_: type_28;
    var phi_2653_: bool;
    var phi_2657_: type_28;
    var phi_2658_: bool;
    var phi_2662_: type_28;
    var phi_2687_: bool;
    var phi_2688_: bool;
    var phi_2695_: type_42;
    var phi_2696_: type_42;
    var phi_2697_: type_42;
    var phi_1948_: type_42;
    var phi_4209_: bool;
    var phi_4327_: bool;
    var phi_4003_: type_42;
    var phi_4004_: type_49;
    var phi_4005_: bool;
    var phi_4006_: u32;
    var phi_4326_: bool;
    var phi_4007_: type_42;
    var phi_4008_: type_49;
    var phi_4009_: u32;
    var phi_4010_: bool;
    var phi_4011_: u32;
    var phi_4325_: bool;
    var phi_4012_: type_42;
    var phi_4013_: type_49;
    var phi_4014_: u32;
    var phi_4015_: bool;
    var phi_4016_: u32;
    var phi_4324_: bool;
    var phi_1871_: type_42;
    var phi_1874_: type_49;
    var phi_1876_: u32;
    var phi_1878_: bool;
    var phi_1880_: u32;
    var phi_4017_: bool;
    var phi_4323_: bool;
    var local_4: type_42;
    var local_5: type_42;
    var local_6: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e78 = global;
            let _e80 = arrayLength((&global_4.member));
            let _e82 = arrayLength((&global_2.member));
            let _e90 = global_3.member[0u][0u];
            let _e94 = global_3.member[0u][1u];
            let _e98 = global_3.member[0u][2u];
            let _e102 = global_3.member[0u][3u];
            let _e106 = global_3.member[1u][0u];
            let _e110 = global_3.member[1u][1u];
            let _e114 = global_3.member[1u][2u];
            let _e117 = global_1.member[0u];
            let _e118 = bitcast<i32>(_e117);
            let _e130 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e102) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e90), bitcast<i32>(_e94), bitcast<i32>(_e98));
            local = array<i32, 3>(bitcast<i32>(_e106), bitcast<i32>(_e110), bitcast<i32>(_e114));
            let _e136 = (_e78.x + (_e78.y * 2097152u));
            let _e137 = (_e136 < arrayLength((&global_5.member)));
            if _e137 {
                let _e138 = (_e136 < arrayLength((&global_6.member)));
                if _e138 {
                    if _e137 {
                    } else {
                        break;
                    }
                    let _e146 = global_5.member[_e136].member_2[0u];
                    let _e148 = (bitcast<u32>(_e146) & 2147483647u);
                    let _e153 = global_5.member[_e136].member_2[1u];
                    let _e155 = (bitcast<u32>(_e153) & 2147483647u);
                    let _e160 = global_5.member[_e136].member_2[2u];
                    let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                    let _e167 = global_5.member[_e136].member[0u];
                    let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                    let _e174 = global_5.member[_e136].member[1u];
                    let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                    let _e181 = global_5.member[_e136].member[2u];
                    let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                    let _e185 = select(_e155, _e148, (_e155 < _e148));
                    let _e187 = select(_e162, _e185, (_e162 < _e185));
                    let _e189 = select(_e169, _e187, (_e169 < _e187));
                    let _e191 = select(_e176, _e189, (_e176 < _e189));
                    let _e193 = select(_e183, _e191, (_e183 < _e191));
                    let _e197 = global_5.member[_e136].member_1;
                    let _e199 = (bitcast<u32>(_e197) & 2147483647u);
                    let _e206 = global_5.member[_e136].member_3;
                    let _e212 = (((select(_e199, _e193, (_e199 < _e193)) < 2139095040u) && ((bitcast<u32>(_e206) & 2147483647u) <= 2139095040u)) && (_e187 > 0u));
                    if _e212 {
                        let _e215 = (bitcast<u32>(bitcast<f32>(_e187)) & 2147483647u);
                        if (_e215 >= 8388608u) {
                            phi_379_ = (bitcast<i32>((_e215 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_379_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e215)), 32u, (_e215 == 0u))));
                        }
                        let _e229 = phi_379_;
                        phi_380_ = _e229;
                    } else {
                        phi_380_ = 0i;
                    }
                    let _e231 = phi_380_;
                    let _e232 = (_e148 == _e187);
                    if _e232 {
                        phi_390_ = true;
                    } else {
                        phi_390_ = (_e155 == _e187);
                    }
                    let _e235 = phi_390_;
                    let _e236 = select(1u, 0u, _e232);
                    if _e235 {
                        let _e237 = (_e236 + 1u);
                        phi_400_ = _e237;
                        phi_401_ = _e237;
                        phi_403_ = select(true, false, (_e237 == 2u));
                    } else {
                        phi_400_ = u32();
                        phi_401_ = 0u;
                        phi_403_ = true;
                    }
                    let _e241 = phi_400_;
                    let _e243 = phi_401_;
                    let _e245 = phi_403_;
                    if _e245 {
                        phi_408_ = (_e243 + 1u);
                    } else {
                        phi_408_ = 0u;
                    }
                    let _e249 = phi_408_;
                    let _e250 = select(_e241, _e243, _e245);
                    let _e251 = select(_e236, select(2u, _e236, _e235), _e245);
                    if (_e118 < -126i) {
                        phi_421_ = -126i;
                    } else {
                        phi_421_ = select(_e118, 127i, (_e118 > 127i));
                    }
                    let _e256 = phi_421_;
                    let _e261 = bitcast<f32>((bitcast<u32>((_e256 + 127i)) << bitcast<u32>(23i)));
                    let _e267 = bitcast<f32>((bitcast<u32>(((_e118 - _e256) + 127i)) << bitcast<u32>(23i)));
                    let _e268 = -(_e231);
                    if (_e268 < -126i) {
                        phi_441_ = -126i;
                    } else {
                        phi_441_ = select(_e268, 127i, (_e268 > 127i));
                    }
                    let _e273 = phi_441_;
                    let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                    let _e284 = bitcast<f32>((bitcast<u32>(((_e268 - _e273) + 127i)) << bitcast<u32>(23i)));
                    let _e288 = global_5.member[_e136].member;
                    let _e289 = (_e250 == 0u);
                    if _e289 {
                        phi_459_ = _e288[0];
                    } else {
                        phi_459_ = _e288[1];
                    }
                    let _e293 = phi_459_;
                    let _e294 = (_e250 == 2u);
                    if _e294 {
                        phi_465_ = _e288[2];
                    } else {
                        phi_465_ = _e293;
                    }
                    let _e297 = phi_465_;
                    let _e299 = ((_e297 * _e261) * _e267);
                    let _e300 = global_5.member[_e136].member_2;
                    if _e289 {
                        phi_476_ = _e300[0];
                    } else {
                        phi_476_ = _e300[1];
                    }
                    let _e304 = phi_476_;
                    if _e294 {
                        phi_482_ = _e300[2];
                    } else {
                        phi_482_ = _e304;
                    }
                    let _e307 = phi_482_;
                    let _e309 = ((_e307 * _e278) * _e284);
                    let _e313 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e313 {
                        let _e317 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) * 0.00000011920929f);
                        phi_505_ = select(0.00000000000011368684f, _e317, (_e317 > 0.00000000000011368684f));
                    } else {
                        phi_505_ = 0f;
                    }
                    let _e321 = phi_505_;
                    let _e322 = (_e299 + _e321);
                    let _e323 = (_e299 - _e321);
                    let _e324 = select(_e309, 0f, _e313);
                    if _e313 {
                        phi_516_ = 38685626000000000000000000f;
                    } else {
                        phi_516_ = (1f / _e309);
                    }
                    let _e327 = phi_516_;
                    let _e328 = (_e249 == 0u);
                    if _e328 {
                        phi_525_ = _e288[0];
                    } else {
                        phi_525_ = _e288[1];
                    }
                    let _e332 = phi_525_;
                    let _e333 = (_e249 == 2u);
                    if _e333 {
                        phi_531_ = _e288[2];
                    } else {
                        phi_531_ = _e332;
                    }
                    let _e336 = phi_531_;
                    let _e338 = ((_e336 * _e261) * _e267);
                    if _e328 {
                        phi_542_ = _e300[0];
                    } else {
                        phi_542_ = _e300[1];
                    }
                    let _e342 = phi_542_;
                    if _e333 {
                        phi_548_ = _e300[2];
                    } else {
                        phi_548_ = _e342;
                    }
                    let _e345 = phi_548_;
                    let _e347 = ((_e345 * _e278) * _e284);
                    let _e351 = (bitcast<f32>((bitcast<u32>(_e347) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e351 {
                        let _e355 = (bitcast<f32>((bitcast<u32>(_e338) & 2147483647u)) * 0.00000011920929f);
                        phi_571_ = select(0.00000000000011368684f, _e355, (_e355 > 0.00000000000011368684f));
                    } else {
                        phi_571_ = 0f;
                    }
                    let _e359 = phi_571_;
                    let _e360 = (_e338 + _e359);
                    let _e361 = (_e338 - _e359);
                    let _e362 = select(_e347, 0f, _e351);
                    if _e351 {
                        phi_582_ = 38685626000000000000000000f;
                    } else {
                        phi_582_ = (1f / _e347);
                    }
                    let _e365 = phi_582_;
                    let _e366 = (_e251 == 0u);
                    if _e366 {
                        phi_591_ = _e288[0];
                    } else {
                        phi_591_ = _e288[1];
                    }
                    let _e370 = phi_591_;
                    let _e371 = (_e251 == 2u);
                    if _e371 {
                        phi_597_ = _e288[2];
                    } else {
                        phi_597_ = _e370;
                    }
                    let _e374 = phi_597_;
                    let _e376 = ((_e374 * _e261) * _e267);
                    if _e366 {
                        phi_608_ = _e300[0];
                    } else {
                        phi_608_ = _e300[1];
                    }
                    let _e380 = phi_608_;
                    if _e371 {
                        phi_614_ = _e300[2];
                    } else {
                        phi_614_ = _e380;
                    }
                    let _e383 = phi_614_;
                    let _e385 = ((_e383 * _e278) * _e284);
                    let _e389 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e389 {
                        let _e393 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) * 0.00000011920929f);
                        phi_637_ = select(0.00000000000011368684f, _e393, (_e393 > 0.00000000000011368684f));
                    } else {
                        phi_637_ = 0f;
                    }
                    let _e397 = phi_637_;
                    let _e398 = (_e376 + _e397);
                    let _e399 = (_e376 - _e397);
                    let _e400 = select(_e385, 0f, _e389);
                    if _e389 {
                        phi_648_ = 38685626000000000000000000f;
                    } else {
                        phi_648_ = (1f / _e385);
                    }
                    let _e403 = phi_648_;
                    let _e406 = bitcast<f32>((bitcast<u32>(_e299) & 2147483647u));
                    let _e409 = bitcast<f32>((bitcast<u32>(_e338) & 2147483647u));
                    let _e411 = select(_e409, _e406, (_e406 > _e409));
                    let _e414 = bitcast<f32>((bitcast<u32>(_e376) & 2147483647u));
                    let _e417 = (_e118 + _e231);
                    if (_e212 && (select(_e414, _e411, (_e411 > _e414)) <= 1099511600000f)) {
                        let _e420 = (_e417 / 3i);
                        let _e427 = bitcast<f32>((bitcast<u32>((_e420 + 127i)) << bitcast<u32>(23i)));
                        let _e434 = bitcast<f32>((bitcast<u32>(((_e417 - (2i * _e420)) + 127i)) << bitcast<u32>(23i)));
                        let _e435 = (((_e197 * _e427) * _e427) * _e434);
                        let _e437 = select(340282350000000000000000000000000000000f, _e435, (_e435 < 340282350000000000000000000000000000000f));
                        let _e442 = (((_e206 * _e427) * _e427) * _e434);
                        let _e444 = select(340282350000000000000000000000000000000f, _e442, (_e442 < 340282350000000000000000000000000000000f));
                        phi_748_ = select(-340282350000000000000000000000000000000f, _e444, (_e444 > -340282350000000000000000000000000000000f));
                        phi_749_ = select(-340282350000000000000000000000000000000f, _e437, (_e437 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_748_ = 0f;
                        phi_749_ = 1f;
                    }
                    let _e448 = phi_748_;
                    let _e450 = phi_749_;
                    local_3 = array<type_49, 128>(type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e455 = (_e250 % 3u);
                    let _e456 = (_e455 < 3u);
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e458 = local_1[_e455];
                    let _e461 = (_e249 % 3u);
                    let _e462 = (_e461 < 3u);
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e464 = local_1[_e461];
                    let _e467 = (_e251 % 3u);
                    let _e468 = (_e467 < 3u);
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e470 = local_1[_e467];
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e475 = local[_e455];
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e479 = local[_e461];
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e483 = local[_e467];
                    phi_4215_ = false;
                    phi_1870_ = type_42(type_35(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e448), 0u, 0u);
                    phi_1873_ = type_49(type_32(vec4<f32>((f32(_e458) * _e130), (f32(_e464) * _e130), (f32(_e470) * _e130), 0f), vec4<f32>((f32(_e475) * _e130), (f32(_e479) * _e130), (f32(_e483) * _e130), 0f)), select(0u, 2147483648u, (_e80 == 0u)));
                    phi_1875_ = ((3u * _e80) + 1u);
                    phi_1877_ = (_e450 <= _e448);
                    phi_1879_ = 0u;
                    loop {
                        let _e493 = phi_4215_;
                        let _e495 = phi_1870_;
                        let _e497 = phi_1873_;
                        let _e499 = phi_1875_;
                        let _e501 = phi_1877_;
                        let _e503 = phi_1879_;
                        local_4 = _e495;
                        local_5 = _e495;
                        if _e501 {
                            phi_1890_ = true;
                        } else {
                            phi_1890_ = (_e503 > 0u);
                        }
                        let _e506 = phi_1890_;
                        if _e506 {
                            let _e507 = (_e499 > 0u);
                            if _e507 {
                                if _e501 {
                                    phi_1927_ = _e497;
                                    phi_1928_ = _e501;
                                    phi_1929_ = _e503;
                                } else {
                                    let _e508 = (_e503 - 1u);
                                    let _e509 = (_e508 % 128u);
                                    let _e510 = (_e509 < 128u);
                                    if _e510 {
                                    } else {
                                        phi_4323_ = true;
                                        break;
                                    }
                                    let _e512 = local_3[_e509];
                                    if _e510 {
                                    } else {
                                        phi_4323_ = true;
                                        break;
                                    }
                                    let _e520 = local_2[_e509];
                                    phi_1927_ = type_49(type_32(_e512.member.member, _e512.member.member_1), _e512.member_1);
                                    phi_1928_ = (_e520 <= _e495.member.member_1);
                                    phi_1929_ = _e508;
                                }
                                let _e525 = phi_1927_;
                                let _e527 = phi_1928_;
                                let _e529 = phi_1929_;
                                if _e527 {
                                    if ((_e525.member_1 & 2147483648u) != 0u) {
                                        phi_1947_ = _e495;
                                        phi_1950_ = type_4(0u, ((_e525.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e982 = phi_1947_;
                                            let _e984 = phi_1950_;
                                            local_6 = _e982;
                                            if (_e984.member < _e984.member_1) {
                                                phi_1951_ = type_4((_e984.member + 1u), _e984.member_1);
                                                phi_1973_ = type_4(1u, _e984.member);
                                            } else {
                                                phi_1951_ = _e984;
                                                phi_1973_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e997 = phi_1951_;
                                            let _e999 = phi_1973_;
                                            let _e1003 = (bitcast<i32>(_e999.member) != 0i);
                                            if _e1003 {
                                                let _e1009 = type_42(_e982.member, _e982.member_1, (_e982.member_2 + 1u));
                                                let _e1010 = ((_e525.member_1 & 268435455u) + _e999.member_1);
                                                let _e1011 = (_e1010 < _e82);
                                                if _e1011 {
                                                    if _e1011 {
                                                    } else {
                                                        phi_4209_ = true;
                                                        break;
                                                    }
                                                    let _e1015 = global_2.member[_e1010].member_1;
                                                    phi_1997_ = _e1015;
                                                } else {
                                                    phi_1997_ = 4294967295u;
                                                }
                                                let _e1017 = phi_1997_;
                                                if (_e1010 >= _e82) {
                                                    phi_2086_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1011 {
                                                    } else {
                                                        phi_4209_ = true;
                                                        break;
                                                    }
                                                    if (_e455 < 9u) {
                                                    } else {
                                                        phi_4209_ = true;
                                                        break;
                                                    }
                                                    let _e1024 = global_2.member[_e1010].member[_e455];
                                                    if (_e461 < 9u) {
                                                    } else {
                                                        phi_4209_ = true;
                                                        break;
                                                    }
                                                    let _e1030 = global_2.member[_e1010].member[_e461];
                                                    if (_e467 < 9u) {
                                                    } else {
                                                        phi_4209_ = true;
                                                        break;
                                                    }
                                                    let _e1036 = global_2.member[_e1010].member[_e467];
                                                    let _e1038 = (3u + _e455);
                                                    if (_e1038 < 9u) {
                                                    } else {
                                                        phi_4209_ = true;
                                                        break;
                                                    }
                                                    let _e1044 = global_2.member[_e1010].member[_e1038];
                                                    let _e1045 = (3u + _e461);
                                                    if (_e1045 < 9u) {
                                                    } else {
                                                        phi_4209_ = true;
                                                        break;
                                                    }
                                                    let _e1051 = global_2.member[_e1010].member[_e1045];
                                                    let _e1052 = (3u + _e467);
                                                    if (_e1052 < 9u) {
                                                    } else {
                                                        phi_4209_ = true;
                                                        break;
                                                    }
                                                    let _e1058 = global_2.member[_e1010].member[_e1052];
                                                    let _e1060 = (6u + _e455);
                                                    if (_e1060 < 9u) {
                                                    } else {
                                                        phi_4209_ = true;
                                                        break;
                                                    }
                                                    let _e1066 = global_2.member[_e1010].member[_e1060];
                                                    let _e1067 = (6u + _e461);
                                                    if (_e1067 < 9u) {
                                                    } else {
                                                        phi_4209_ = true;
                                                        break;
                                                    }
                                                    let _e1073 = global_2.member[_e1010].member[_e1067];
                                                    let _e1074 = (6u + _e467);
                                                    if (_e1074 < 9u) {
                                                    } else {
                                                        phi_4209_ = true;
                                                        break;
                                                    }
                                                    let _e1080 = global_2.member[_e1010].member[_e1074];
                                                    phi_2086_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1024, _e1030, _e1036), array<f32, 3>(_e1044, _e1051, _e1058), array<f32, 3>(_e1066, _e1073, _e1080));
                                                }
                                                let _e1084 = phi_2086_;
                                                let _e1093 = (_e1084[0][2] - _e376);
                                                let _e1096 = (((_e1084[0][0] - _e299) * _e400) - (_e1093 * _e324));
                                                let _e1099 = (((_e1084[0][1] - _e338) * _e400) - (_e1093 * _e362));
                                                let _e1106 = (_e1084[1][2] - _e376);
                                                let _e1109 = (((_e1084[1][0] - _e299) * _e400) - (_e1106 * _e324));
                                                let _e1112 = (((_e1084[1][1] - _e338) * _e400) - (_e1106 * _e362));
                                                let _e1119 = (_e1084[2][2] - _e376);
                                                let _e1122 = (((_e1084[2][0] - _e299) * _e400) - (_e1119 * _e324));
                                                let _e1125 = (((_e1084[2][1] - _e338) * _e400) - (_e1119 * _e362));
                                                let _e1126 = (_e1122 * _e1112);
                                                let _e1127 = (_e1125 * _e1109);
                                                let _e1128 = (_e1096 * _e1125);
                                                let _e1129 = (_e1099 * _e1122);
                                                let _e1130 = (_e1109 * _e1099);
                                                let _e1131 = (_e1112 * _e1096);
                                                let _e1136 = (((_e1126 >= _e1127) && (_e1128 >= _e1129)) && (_e1130 >= _e1131));
                                                if (_e1136 || (((_e1126 <= _e1127) && (_e1128 <= _e1129)) && (_e1130 <= _e1131))) {
                                                    let _e1143 = select(-1f, 1f, _e1136);
                                                    let _e1145 = ((_e1126 - _e1127) * _e1143);
                                                    let _e1147 = select(0f, _e1145, (_e1145 > 0f));
                                                    let _e1149 = ((_e1128 - _e1129) * _e1143);
                                                    let _e1151 = select(0f, _e1149, (_e1149 > 0f));
                                                    let _e1153 = ((_e1130 - _e1131) * _e1143);
                                                    let _e1155 = select(0f, _e1153, (_e1153 > 0f));
                                                    let _e1157 = ((_e1147 + _e1151) + _e1155);
                                                    if (_e1157 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2652_ = type_28();
                                                        phi_2653_ = true;
                                                    } else {
                                                        let _e1160 = select(_e1084[1][0], _e1084[0][0], (_e1084[0][0] < _e1084[1][0]));
                                                        let _e1164 = select(_e1084[1][0], _e1084[0][0], (_e1084[0][0] > _e1084[1][0]));
                                                        let _e1168 = select(_e1084[1][1], _e1084[0][1], (_e1084[0][1] < _e1084[1][1]));
                                                        let _e1172 = select(_e1084[1][1], _e1084[0][1], (_e1084[0][1] > _e1084[1][1]));
                                                        let _e1176 = select(_e1084[1][2], _e1084[0][2], (_e1084[0][2] < _e1084[1][2]));
                                                        let _e1180 = select(_e1084[1][2], _e1084[0][2], (_e1084[0][2] > _e1084[1][2]));
                                                        let _e1185 = ((select(_e1084[2][0], _e1160, (_e1160 < _e1084[2][0])) - _e322) * _e327);
                                                        let _e1186 = ((select(_e1084[2][0], _e1164, (_e1164 > _e1084[2][0])) - _e323) * _e327);
                                                        let _e1189 = ((select(_e1084[2][1], _e1168, (_e1168 < _e1084[2][1])) - _e360) * _e365);
                                                        let _e1190 = ((select(_e1084[2][1], _e1172, (_e1172 > _e1084[2][1])) - _e361) * _e365);
                                                        let _e1193 = ((select(_e1084[2][2], _e1176, (_e1176 < _e1084[2][2])) - _e398) * _e403);
                                                        let _e1194 = ((select(_e1084[2][2], _e1180, (_e1180 > _e1084[2][2])) - _e399) * _e403);
                                                        let _e1196 = select(_e1194, _e1193, (_e1193 < _e1194));
                                                        let _e1198 = select(_e1194, _e1193, (_e1193 > _e1194));
                                                        let _e1200 = select(_e1186, _e1185, (_e1185 < _e1186));
                                                        let _e1202 = select(_e1190, _e1189, (_e1189 < _e1190));
                                                        let _e1204 = select(_e1202, _e1200, (_e1200 > _e1202));
                                                        let _e1206 = select(_e1196, _e1204, (_e1204 > _e1196));
                                                        let _e1208 = select(_e1186, _e1185, (_e1185 > _e1186));
                                                        let _e1210 = select(_e1190, _e1189, (_e1189 > _e1190));
                                                        let _e1212 = select(_e1210, _e1208, (_e1208 < _e1210));
                                                        let _e1214 = select(_e1198, _e1212, (_e1212 < _e1198));
                                                        let _e1215 = -(_e1196);
                                                        let _e1221 = select(_e450, _e1206, (_e1206 > _e450));
                                                        if (_e1221 > (_e1214 + (select(_e1215, _e1198, (_e1198 > _e1215)) * 0.0000019073523f))) {
                                                            phi_2647_ = type_28();
                                                            phi_2648_ = true;
                                                        } else {
                                                            let _e1223 = (_e1221 > _e982.member.member_1);
                                                            if _e1223 {
                                                                phi_2646_ = type_28();
                                                            } else {
                                                                let _e1227 = (_e1084[1][0] - _e1084[0][0]);
                                                                let _e1228 = (_e1084[1][1] - _e1084[0][1]);
                                                                let _e1229 = (_e1084[1][2] - _e1084[0][2]);
                                                                let _e1230 = vec3<f32>(_e1227, _e1228, _e1229);
                                                                let _e1231 = (_e1084[2][0] - _e1084[1][0]);
                                                                let _e1232 = (_e1084[2][1] - _e1084[1][1]);
                                                                let _e1233 = (_e1084[2][2] - _e1084[1][2]);
                                                                let _e1234 = vec3<f32>(_e1231, _e1232, _e1233);
                                                                let _e1235 = (_e1084[0][0] - _e1084[2][0]);
                                                                let _e1236 = (_e1084[0][1] - _e1084[2][1]);
                                                                let _e1237 = (_e1084[0][2] - _e1084[2][2]);
                                                                let _e1238 = vec3<f32>(_e1235, _e1236, _e1237);
                                                                let _e1241 = bitcast<f32>((bitcast<u32>(_e1227) & 2147483647u));
                                                                let _e1244 = bitcast<f32>((bitcast<u32>(_e1228) & 2147483647u));
                                                                let _e1246 = select(_e1244, _e1241, (_e1241 > _e1244));
                                                                let _e1249 = bitcast<f32>((bitcast<u32>(_e1229) & 2147483647u));
                                                                let _e1251 = select(_e1249, _e1246, (_e1246 > _e1249));
                                                                let _e1254 = bitcast<f32>((bitcast<u32>(_e1231) & 2147483647u));
                                                                let _e1257 = bitcast<f32>((bitcast<u32>(_e1232) & 2147483647u));
                                                                let _e1259 = select(_e1257, _e1254, (_e1254 > _e1257));
                                                                let _e1262 = bitcast<f32>((bitcast<u32>(_e1233) & 2147483647u));
                                                                let _e1264 = select(_e1262, _e1259, (_e1259 > _e1262));
                                                                let _e1267 = bitcast<f32>((bitcast<u32>(_e1235) & 2147483647u));
                                                                let _e1270 = bitcast<f32>((bitcast<u32>(_e1236) & 2147483647u));
                                                                let _e1272 = select(_e1270, _e1267, (_e1267 > _e1270));
                                                                let _e1275 = bitcast<f32>((bitcast<u32>(_e1237) & 2147483647u));
                                                                let _e1277 = select(_e1275, _e1272, (_e1272 > _e1275));
                                                                let _e1279 = select(_e1264, _e1251, (_e1251 > _e1264));
                                                                let _e1281 = select(_e1277, _e1279, (_e1279 > _e1277));
                                                                if (_e1251 == _e1281) {
                                                                    phi_2557_ = _e1234;
                                                                    phi_2558_ = _e1238;
                                                                } else {
                                                                    let _e1284 = vec3((_e1264 == _e1281));
                                                                    phi_2557_ = select(_e1230, _e1238, _e1284);
                                                                    phi_2558_ = select(_e1234, _e1230, _e1284);
                                                                }
                                                                let _e1288 = phi_2557_;
                                                                let _e1290 = phi_2558_;
                                                                let _e1297 = ((_e1288.y * _e1290.z) - (_e1290.y * _e1288.z));
                                                                let _e1302 = ((_e1288.z * _e1290.x) - (_e1290.z * _e1288.x));
                                                                let _e1305 = ((_e1288.x * _e1290.y) - (_e1290.x * _e1288.y));
                                                                if (_e1147 >= _e1151) {
                                                                    phi_2589_ = select(true, false, (_e1147 >= _e1155));
                                                                } else {
                                                                    phi_2589_ = true;
                                                                }
                                                                let _e1310 = phi_2589_;
                                                                if _e1310 {
                                                                    phi_2598_ = select(vec3<f32>(_e1084[2][0], _e1084[2][1], _e1084[2][2]), vec3<f32>(_e1084[1][0], _e1084[1][1], _e1084[1][2]), vec3((_e1151 >= _e1155)));
                                                                } else {
                                                                    phi_2598_ = vec3<f32>(_e1084[0][0], _e1084[0][1], _e1084[0][2]);
                                                                }
                                                                let _e1315 = phi_2598_;
                                                                let _e1332 = ((((_e1297 * (_e1315.x - _e299)) + (_e1302 * (_e1315.y - _e338))) + (_e1305 * (_e1315.z - _e376))) / (((_e1297 * _e324) + (_e1302 * _e362)) + (_e1305 * _e400)));
                                                                let _e1334 = select(_e1214, _e1332, (_e1332 < _e1214));
                                                                let _e1336 = select(_e1206, _e1334, (_e1334 > _e1206));
                                                                if (_e1336 >= _e450) {
                                                                    let _e1338 = (_e1336 <= _e982.member.member_1);
                                                                    if _e1338 {
                                                                        let _e1339 = (1f / _e1157);
                                                                        phi_2638_ = type_28(_e1336, (_e1151 * _e1339), (_e1155 * _e1339), _e1017);
                                                                    } else {
                                                                        phi_2638_ = type_28();
                                                                    }
                                                                    let _e1344 = phi_2638_;
                                                                    phi_2640_ = _e1344;
                                                                    phi_2641_ = select(true, false, _e1338);
                                                                } else {
                                                                    phi_2640_ = type_28();
                                                                    phi_2641_ = true;
                                                                }
                                                                let _e1347 = phi_2640_;
                                                                let _e1349 = phi_2641_;
                                                                if _e1349 {
                                                                    phi_2645_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2645_ = _e1347;
                                                                }
                                                                let _e1351 = phi_2645_;
                                                                phi_2646_ = _e1351;
                                                            }
                                                            let _e1353 = phi_2646_;
                                                            phi_2647_ = _e1353;
                                                            phi_2648_ = _e1223;
                                                        }
                                                        let _e1355 = phi_2647_;
                                                        let _e1357 = phi_2648_;
                                                        phi_2652_ = _e1355;
                                                        phi_2653_ = _e1357;
                                                    }
                                                    let _e1359 = phi_2652_;
                                                    let _e1361 = phi_2653_;
                                                    phi_2657_ = _e1359;
                                                    phi_2658_ = _e1361;
                                                } else {
                                                    phi_2657_ = type_28();
                                                    phi_2658_ = true;
                                                }
                                                let _e1363 = phi_2657_;
                                                let _e1365 = phi_2658_;
                                                if _e1365 {
                                                    phi_2662_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2662_ = _e1363;
                                                }
                                                let _e1367 = phi_2662_;
                                                if (_e1367.member_3 != 4294967295u) {
                                                    if (_e1017 != 4294967295u) {
                                                        if (_e1367.member < _e982.member.member.member) {
                                                            phi_2688_ = true;
                                                        } else {
                                                            if (_e1367.member == _e982.member.member.member) {
                                                                phi_2687_ = (_e1367.member_3 < _e982.member.member.member_3);
                                                            } else {
                                                                phi_2687_ = false;
                                                            }
                                                            let _e1382 = phi_2687_;
                                                            phi_2688_ = _e1382;
                                                        }
                                                        let _e1384 = phi_2688_;
                                                        if _e1384 {
                                                            phi_2695_ = type_42(type_35(_e1367, _e1367.member), _e1009.member_1, _e1009.member_2);
                                                        } else {
                                                            phi_2695_ = _e1009;
                                                        }
                                                        let _e1391 = phi_2695_;
                                                        phi_2696_ = _e1391;
                                                    } else {
                                                        phi_2696_ = _e1009;
                                                    }
                                                    let _e1393 = phi_2696_;
                                                    phi_2697_ = _e1393;
                                                } else {
                                                    phi_2697_ = _e1009;
                                                }
                                                let _e1395 = phi_2697_;
                                                phi_1948_ = _e1395;
                                            } else {
                                                phi_1948_ = type_42();
                                            }
                                            let _e1397 = phi_1948_;
                                            continue;
                                            continuing {
                                                phi_1947_ = _e1397;
                                                phi_1950_ = _e997;
                                                phi_4209_ = _e493;
                                                break if !(_e1003);
                                            }
                                        }
                                        let _e1400 = phi_4209_;
                                        phi_4323_ = _e1400;
                                        if _e1400 {
                                            break;
                                        }
                                        phi_4327_ = _e1400;
                                        let _e1553 = local_6;
                                        phi_4003_ = _e1553;
                                        phi_4004_ = _e525;
                                        phi_4005_ = false;
                                        phi_4006_ = _e529;
                                    } else {
                                        if (_e525.member_1 >= _e80) {
                                            phi_3603_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e525.member_1 < _e80) {
                                            } else {
                                                phi_4323_ = true;
                                                break;
                                            }
                                            let _e547 = ((1u + _e250) % 4u);
                                            if (_e547 < 4u) {
                                            } else {
                                                phi_4323_ = true;
                                                break;
                                            }
                                            let _e552 = global_4.member[_e525.member_1][_e547];
                                            let _e554 = ((1u + _e249) % 4u);
                                            if (_e554 < 4u) {
                                            } else {
                                                phi_4323_ = true;
                                                break;
                                            }
                                            let _e559 = global_4.member[_e525.member_1][_e554];
                                            let _e561 = ((1u + _e251) % 4u);
                                            if (_e561 < 4u) {
                                            } else {
                                                phi_4323_ = true;
                                                break;
                                            }
                                            let _e566 = global_4.member[_e525.member_1][_e561];
                                            let _e568 = ((_e250 + 1u) % 4u);
                                            if (_e568 < 4u) {
                                            } else {
                                                phi_4323_ = true;
                                                break;
                                            }
                                            let _e573 = global_4.member[_e525.member_1][_e568];
                                            let _e575 = (_e573 >> bitcast<u32>(11u));
                                            let _e577 = ((_e249 + 1u) % 4u);
                                            if (_e577 < 4u) {
                                            } else {
                                                phi_4323_ = true;
                                                break;
                                            }
                                            let _e582 = global_4.member[_e525.member_1][_e577];
                                            let _e584 = (_e582 >> bitcast<u32>(11u));
                                            let _e586 = ((_e251 + 1u) % 4u);
                                            if (_e586 < 4u) {
                                            } else {
                                                phi_4323_ = true;
                                                break;
                                            }
                                            let _e591 = global_4.member[_e525.member_1][_e586];
                                            let _e593 = (_e591 >> bitcast<u32>(11u));
                                            let _e616 = (bitcast<f32>((bitcast<u32>((_e525.member.member_1.x - _e525.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e617 = (bitcast<f32>((bitcast<u32>((_e525.member.member_1.y - _e525.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e618 = (bitcast<f32>((bitcast<u32>((_e525.member.member_1.z - _e525.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e620 = select(_e130, _e616, (_e616 > _e130));
                                            let _e622 = select(_e130, _e617, (_e617 > _e130));
                                            let _e624 = select(_e130, _e618, (_e618 > _e130));
                                            let _e649 = bitcast<u32>((f32(bitcast<i32>((_e552 & 1023u))) * _e620));
                                            let _e654 = (bitcast<i32>((_e552 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e657 = bitcast<f32>((_e649 & bitcast<u32>(_e654)));
                                            let _e658 = bitcast<u32>((f32(bitcast<i32>((_e559 & 1023u))) * _e622));
                                            let _e663 = (bitcast<i32>((_e559 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e666 = bitcast<f32>((_e658 & bitcast<u32>(_e663)));
                                            let _e667 = bitcast<u32>((f32(bitcast<i32>((_e566 & 1023u))) * _e624));
                                            let _e672 = (bitcast<i32>((_e566 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e675 = bitcast<f32>((_e667 & bitcast<u32>(_e672)));
                                            let _e679 = bitcast<f32>((_e649 & bitcast<u32>(~(_e654))));
                                            let _e683 = bitcast<f32>((_e658 & bitcast<u32>(~(_e663))));
                                            let _e687 = bitcast<f32>((_e667 & bitcast<u32>(~(_e672))));
                                            let _e688 = bitcast<u32>((f32(bitcast<i32>((_e575 & 1023u))) * _e620));
                                            let _e693 = (bitcast<i32>((_e575 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e696 = bitcast<f32>((_e688 & bitcast<u32>(_e693)));
                                            let _e697 = bitcast<u32>((f32(bitcast<i32>((_e584 & 1023u))) * _e622));
                                            let _e702 = (bitcast<i32>((_e584 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e705 = bitcast<f32>((_e697 & bitcast<u32>(_e702)));
                                            let _e706 = bitcast<u32>((f32(bitcast<i32>((_e593 & 1023u))) * _e624));
                                            let _e711 = (bitcast<i32>((_e593 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e714 = bitcast<f32>((_e706 & bitcast<u32>(_e711)));
                                            let _e718 = bitcast<f32>((_e688 & bitcast<u32>(~(_e693))));
                                            let _e722 = bitcast<f32>((_e697 & bitcast<u32>(~(_e702))));
                                            let _e726 = bitcast<f32>((_e706 & bitcast<u32>(~(_e711))));
                                            let _e756 = global_4.member[_e525.member_1][0u];
                                            let _e760 = global_4.member[_e525.member_1][1u];
                                            let _e764 = global_4.member[_e525.member_1][2u];
                                            let _e768 = global_4.member[_e525.member_1][3u];
                                            let _e780 = (((_e760 >> bitcast<u32>(22i)) | ((_e764 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e768 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e781 = (_e756 & 268435455u);
                                            let _e782 = (_e780 & 268435455u);
                                            let _e785 = ((_e756 >> bitcast<u32>(28u)) & 7u);
                                            let _e793 = ((_e756 >> bitcast<u32>(31i)) | (((_e780 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e794 = (_e785 != 0u);
                                            if (_e785 == 0u) {
                                                phi_3565_ = _e781;
                                            } else {
                                                if (_e785 == 7u) {
                                                    phi_3564_ = 2147483648u;
                                                } else {
                                                    phi_3564_ = ((2147483648u | (_e785 << bitcast<u32>(28u))) | (_e782 & 268435455u));
                                                }
                                                let _e803 = phi_3564_;
                                                phi_3565_ = _e803;
                                            }
                                            let _e805 = phi_3565_;
                                            if _e794 {
                                                let _e806 = (_e785 != 7u);
                                                if _e806 {
                                                    phi_3575_ = (_e782 + _e785);
                                                } else {
                                                    phi_3575_ = u32();
                                                }
                                                let _e809 = phi_3575_;
                                                phi_3577_ = _e809;
                                                phi_3578_ = select(true, false, _e806);
                                            } else {
                                                phi_3577_ = u32();
                                                phi_3578_ = true;
                                            }
                                            let _e812 = phi_3577_;
                                            let _e814 = phi_3578_;
                                            if (_e793 == 0u) {
                                                phi_3599_ = (_e781 + select(0u, 1u, !(_e794)));
                                            } else {
                                                if (_e793 == 7u) {
                                                    phi_3598_ = 2147483648u;
                                                } else {
                                                    phi_3598_ = ((2147483648u | (_e793 << bitcast<u32>(28u))) | (select(_e812, _e782, _e814) & 268435455u));
                                                }
                                                let _e827 = phi_3598_;
                                                phi_3599_ = _e827;
                                            }
                                            let _e829 = phi_3599_;
                                            phi_3603_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e525.member.member.x + _e657), (_e525.member.member.x + _e679), (_e525.member.member_1.x - _e696), (_e525.member.member_1.x - _e718)), vec4<f32>((_e525.member.member.y + _e666), (_e525.member.member.y + _e683), (_e525.member.member_1.y - _e705), (_e525.member.member_1.y - _e722)), vec4<f32>((_e525.member.member.z + _e675), (_e525.member.member.z + _e687), (_e525.member.member_1.z - _e714), (_e525.member.member_1.z - _e726))), type_49(type_32((_e525.member.member + vec4<f32>(_e657, _e666, _e675, 0f)), (_e525.member.member_1 - vec4<f32>(_e696, _e705, _e714, 0f))), _e805), type_49(type_32((_e525.member.member + vec4<f32>(_e679, _e683, _e687, 0f)), (_e525.member.member_1 - vec4<f32>(_e718, _e722, _e726, 0f))), _e829));
                                        }
                                        let _e834 = phi_3603_;
                                        let _e847 = ((_e834.member[0].x - _e322) * _e327);
                                        let _e848 = ((_e834.member[0].y - _e322) * _e327);
                                        let _e849 = ((_e834.member[0].z - _e323) * _e327);
                                        let _e850 = ((_e834.member[0].w - _e323) * _e327);
                                        let _e860 = ((_e834.member[1].x - _e360) * _e365);
                                        let _e861 = ((_e834.member[1].y - _e360) * _e365);
                                        let _e862 = ((_e834.member[1].z - _e361) * _e365);
                                        let _e863 = ((_e834.member[1].w - _e361) * _e365);
                                        let _e873 = ((_e834.member[2].x - _e398) * _e403);
                                        let _e874 = ((_e834.member[2].y - _e398) * _e403);
                                        let _e875 = ((_e834.member[2].z - _e399) * _e403);
                                        let _e876 = ((_e834.member[2].w - _e399) * _e403);
                                        let _e878 = select(_e875, _e873, (_e873 < _e875));
                                        let _e880 = select(_e876, _e874, (_e874 < _e876));
                                        let _e882 = select(_e875, _e873, (_e873 > _e875));
                                        let _e884 = select(_e876, _e874, (_e874 > _e876));
                                        let _e886 = select(_e849, _e847, (_e847 < _e849));
                                        let _e888 = select(_e850, _e848, (_e848 < _e850));
                                        let _e890 = select(_e862, _e860, (_e860 < _e862));
                                        let _e892 = select(_e863, _e861, (_e861 < _e863));
                                        let _e894 = select(_e890, _e886, (_e886 > _e890));
                                        let _e896 = select(_e892, _e888, (_e888 > _e892));
                                        let _e898 = select(_e878, _e894, (_e894 > _e878));
                                        let _e900 = select(_e880, _e896, (_e896 > _e880));
                                        let _e902 = select(_e849, _e847, (_e847 > _e849));
                                        let _e904 = select(_e850, _e848, (_e848 > _e850));
                                        let _e906 = select(_e862, _e860, (_e860 > _e862));
                                        let _e908 = select(_e863, _e861, (_e861 > _e863));
                                        let _e910 = select(_e906, _e902, (_e902 < _e906));
                                        let _e912 = select(_e908, _e904, (_e904 < _e908));
                                        let _e917 = -(_e878);
                                        let _e918 = -(_e880);
                                        let _e925 = (select(_e882, _e910, (_e910 < _e882)) + (select(_e917, _e882, (_e882 > _e917)) * 0.0000019073523f));
                                        let _e926 = (select(_e884, _e912, (_e912 < _e884)) + (select(_e918, _e884, (_e884 > _e918)) * 0.0000019073523f));
                                        let _e928 = select(_e450, _e898, (_e898 > _e450));
                                        let _e930 = select(_e450, _e900, (_e900 > _e450));
                                        let _e935 = (_e928 <= select(_e495.member.member_1, _e925, (_e925 < _e495.member.member_1)));
                                        let _e936 = (_e930 <= select(_e495.member.member_1, _e926, (_e926 < _e495.member.member_1)));
                                        let _e937 = (_e928 <= _e930);
                                        if _e935 {
                                            if _e936 {
                                                if _e937 {
                                                    phi_3947_ = _e834.member_2;
                                                } else {
                                                    phi_3947_ = _e834.member_1;
                                                }
                                                let _e941 = phi_3947_;
                                                let _e942 = (_e529 % 128u);
                                                let _e943 = (_e942 < 128u);
                                                if _e943 {
                                                } else {
                                                    phi_4323_ = true;
                                                    break;
                                                }
                                                local_3[_e942] = type_49(type_32(_e941.member.member, _e941.member.member_1), _e941.member_1);
                                                if _e943 {
                                                } else {
                                                    phi_4323_ = true;
                                                    break;
                                                }
                                                local_2[_e942] = select(_e930, _e928, (_e928 > _e930));
                                                if _e937 {
                                                    phi_3980_ = _e834.member_1;
                                                } else {
                                                    phi_3980_ = _e834.member_2;
                                                }
                                                let _e958 = phi_3980_;
                                                phi_3981_ = _e958;
                                                phi_3982_ = (_e529 + 1u);
                                            } else {
                                                phi_3981_ = type_49();
                                                phi_3982_ = u32();
                                            }
                                            let _e960 = phi_3981_;
                                            let _e962 = phi_3982_;
                                            phi_3984_ = _e960;
                                            phi_3985_ = _e962;
                                            phi_3986_ = select(true, false, _e936);
                                        } else {
                                            phi_3984_ = type_49();
                                            phi_3985_ = u32();
                                            phi_3986_ = true;
                                        }
                                        let _e965 = phi_3984_;
                                        let _e967 = phi_3985_;
                                        let _e969 = phi_3986_;
                                        if _e969 {
                                            if _e935 {
                                                phi_3995_ = _e834.member_1;
                                            } else {
                                                phi_3995_ = _e834.member_2;
                                            }
                                            let _e973 = phi_3995_;
                                            phi_4000_ = _e973;
                                            phi_4001_ = select(_e936, true, _e935);
                                        } else {
                                            phi_4000_ = _e965;
                                            phi_4001_ = _e527;
                                        }
                                        let _e976 = phi_4000_;
                                        let _e978 = phi_4001_;
                                        phi_4327_ = _e493;
                                        phi_4003_ = type_42(_e495.member, (_e495.member_1 + 1u), _e495.member_2);
                                        phi_4004_ = _e976;
                                        phi_4005_ = _e978;
                                        phi_4006_ = select(_e967, _e529, _e969);
                                    }
                                    let _e1402 = phi_4327_;
                                    let _e1404 = phi_4003_;
                                    let _e1406 = phi_4004_;
                                    let _e1408 = phi_4005_;
                                    let _e1410 = phi_4006_;
                                    phi_4326_ = _e1402;
                                    phi_4007_ = _e1404;
                                    phi_4008_ = _e1406;
                                    phi_4009_ = (_e499 - 1u);
                                    phi_4010_ = _e1408;
                                    phi_4011_ = _e1410;
                                } else {
                                    phi_4326_ = _e493;
                                    phi_4007_ = _e495;
                                    phi_4008_ = _e525;
                                    phi_4009_ = _e499;
                                    phi_4010_ = _e527;
                                    phi_4011_ = _e529;
                                }
                                let _e1412 = phi_4326_;
                                let _e1414 = phi_4007_;
                                let _e1416 = phi_4008_;
                                let _e1418 = phi_4009_;
                                let _e1420 = phi_4010_;
                                let _e1422 = phi_4011_;
                                phi_4325_ = _e1412;
                                phi_4012_ = _e1414;
                                phi_4013_ = _e1416;
                                phi_4014_ = _e1418;
                                phi_4015_ = _e1420;
                                phi_4016_ = _e1422;
                            } else {
                                phi_4325_ = _e493;
                                phi_4012_ = type_42();
                                phi_4013_ = type_49();
                                phi_4014_ = u32();
                                phi_4015_ = bool();
                                phi_4016_ = u32();
                            }
                            let _e1424 = phi_4325_;
                            let _e1426 = phi_4012_;
                            let _e1428 = phi_4013_;
                            let _e1430 = phi_4014_;
                            let _e1432 = phi_4015_;
                            let _e1434 = phi_4016_;
                            phi_4324_ = _e1424;
                            phi_1871_ = _e1426;
                            phi_1874_ = _e1428;
                            phi_1876_ = _e1430;
                            phi_1878_ = _e1432;
                            phi_1880_ = _e1434;
                            phi_4017_ = _e507;
                        } else {
                            phi_4324_ = _e493;
                            phi_1871_ = type_42();
                            phi_1874_ = type_49();
                            phi_1876_ = u32();
                            phi_1878_ = bool();
                            phi_1880_ = u32();
                            phi_4017_ = false;
                        }
                        let _e1436 = phi_4324_;
                        let _e1438 = phi_1871_;
                        let _e1440 = phi_1874_;
                        let _e1442 = phi_1876_;
                        let _e1444 = phi_1878_;
                        let _e1446 = phi_1880_;
                        let _e1448 = phi_4017_;
                        continue;
                        continuing {
                            phi_4215_ = _e1436;
                            phi_1870_ = _e1438;
                            phi_1873_ = _e1440;
                            phi_1875_ = _e1442;
                            phi_1877_ = _e1444;
                            phi_1879_ = _e1446;
                            phi_4323_ = _e1436;
                            break if !(_e1448);
                        }
                    }
                    let _e1451 = phi_4323_;
                    if _e1451 {
                        break;
                    }
                    let _e1453 = local_4;
                    let _e1456 = local_5;
                    if _e138 {
                    } else {
                        break;
                    }
                    global_6.member[_e136][0u] = _e1453.member_1;
                    global_6.member[_e136][1u] = _e1456.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
