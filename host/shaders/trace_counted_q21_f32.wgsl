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

struct type_31 {
    member: type_24,
    member_1: f32,
}

struct type_36 {
    member: array<type_25>,
}

struct type_38 {
    member: type_31,
    member_1: u32,
    member_2: u32,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: array<array<u32, 7>>,
}

struct type_49 {
    member: type_28,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
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
var<storage> global_5: type_47;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_21;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_49, 128>;
    var phi_377_: i32;
    var phi_378_: i32;
    var phi_388_: bool;
    var phi_398_: u32;
    var phi_399_: u32;
    var phi_401_: bool;
    var phi_406_: u32;
    var phi_451_: f32;
    var phi_457_: f32;
    var phi_468_: f32;
    var phi_474_: f32;
    var phi_497_: f32;
    var phi_508_: f32;
    var phi_517_: f32;
    var phi_523_: f32;
    var phi_534_: f32;
    var phi_540_: f32;
    var phi_563_: f32;
    var phi_574_: f32;
    var phi_583_: f32;
    var phi_589_: f32;
    var phi_600_: f32;
    var phi_606_: f32;
    var phi_629_: f32;
    var phi_640_: f32;
    var phi_740_: f32;
    var phi_741_: f32;
    var phi_4207_: bool;
    var phi_1862_: type_38;
    var phi_1865_: type_49;
    var phi_1867_: u32;
    var phi_1869_: bool;
    var phi_1871_: u32;
    var phi_1882_: bool;
    var phi_1919_: type_49;
    var phi_1920_: bool;
    var phi_1921_: u32;
    var phi_3556_: u32;
    var phi_3557_: u32;
    var phi_3567_: u32;
    var phi_3569_: u32;
    var phi_3570_: bool;
    var phi_3590_: u32;
    var phi_3591_: u32;
    var phi_3595_: type_52;
    var phi_3939_: type_49;
    var phi_3972_: type_49;
    var phi_3973_: type_49;
    var phi_3974_: u32;
    var phi_3976_: type_49;
    var phi_3977_: u32;
    var phi_3978_: bool;
    var phi_3987_: type_49;
    var phi_3992_: type_49;
    var phi_3993_: bool;
    var phi_1939_: type_38;
    var phi_1942_: type_4;
    var phi_1943_: type_4;
    var phi_1965_: type_4;
    var phi_1989_: u32;
    var phi_2078_: array<array<f32, 3>, 3>;
    var phi_2549_: vec3<f32>;
    var phi_2550_: vec3<f32>;
    var phi_2581_: bool;
    var phi_2590_: vec3<f32>;
    var phi_2630_: type_24;
    var phi_2632_: type_24;
    var phi_2633_: bool;
    var phi_2637_: type_24;
    var phi_2638_: type_24;
    var phi_2639_: type_24;
    var phi_2640_: bool;
    var phi_2644_: type_24;
    var phi_2645_: bool;
    var phi_2649_: type_24;
    var phi_2650_: bool;
    var phi_2654_: type_24;
    var phi_2679_: bool;
    var phi_2680_: bool;
    var phi_2687_: type_38;
    var phi_2688_: type_38;
    var phi_2689_: type_38;
    var phi_1940_: type_38;
    var phi_4201_: bool;
    var phi_4315_: bool;
    var phi_3995_: type_38;
    var phi_3996_: type_49;
    var phi_3997_: bool;
    var phi_3998_: u32;
    var phi_4314_: bool;
    var phi_3999_: type_38;
    var phi_4000_: type_49;
    var phi_4001_: u32;
    var phi_4002_: bool;
    var phi_4003_: u32;
    var phi_4313_: bool;
    var phi_4004_: type_38;
    var phi_4005_: type_49;
    var phi_4006_: u32;
    var phi_4007_: bool;
    var phi_4008_: u32;
    var phi_4312_: bool;
    var phi_1863_: type_38;
    var phi_1866_: type_49;
    var phi_1868_: u32;
    var phi_1870_: bool;
    var phi_1872_: u32;
    var phi_4009_: bool;
    var phi_4311_: bool;
    var local_4: type_38;
    var local_5: type_38;
    var local_6: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e76 = global;
            let _e78 = arrayLength((&global_5.member));
            let _e80 = arrayLength((&global_2.member));
            let _e88 = global_3.member[0u][0u];
            let _e92 = global_3.member[0u][1u];
            let _e96 = global_3.member[0u][2u];
            let _e100 = global_3.member[0u][3u];
            let _e104 = global_3.member[1u][0u];
            let _e108 = global_3.member[1u][1u];
            let _e112 = global_3.member[1u][2u];
            let _e115 = global_1.member[0u];
            let _e116 = bitcast<i32>(_e115);
            let _e128 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e100) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e88), bitcast<i32>(_e92), bitcast<i32>(_e96));
            local = array<i32, 3>(bitcast<i32>(_e104), bitcast<i32>(_e108), bitcast<i32>(_e112));
            let _e134 = (_e76.x + (_e76.y * 2097152u));
            let _e135 = (_e134 < arrayLength((&global_4.member)));
            if _e135 {
                let _e136 = (_e134 < arrayLength((&global_6.member)));
                if _e136 {
                    if _e135 {
                    } else {
                        break;
                    }
                    let _e144 = global_4.member[_e134].member_2[0u];
                    let _e146 = (bitcast<u32>(_e144) & 2147483647u);
                    let _e151 = global_4.member[_e134].member_2[1u];
                    let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                    let _e158 = global_4.member[_e134].member_2[2u];
                    let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                    let _e165 = global_4.member[_e134].member[0u];
                    let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                    let _e172 = global_4.member[_e134].member[1u];
                    let _e174 = (bitcast<u32>(_e172) & 2147483647u);
                    let _e179 = global_4.member[_e134].member[2u];
                    let _e181 = (bitcast<u32>(_e179) & 2147483647u);
                    let _e183 = select(_e153, _e146, (_e153 < _e146));
                    let _e185 = select(_e160, _e183, (_e160 < _e183));
                    let _e187 = select(_e167, _e185, (_e167 < _e185));
                    let _e189 = select(_e174, _e187, (_e174 < _e187));
                    let _e191 = select(_e181, _e189, (_e181 < _e189));
                    let _e195 = global_4.member[_e134].member_1;
                    let _e197 = (bitcast<u32>(_e195) & 2147483647u);
                    let _e204 = global_4.member[_e134].member_3;
                    let _e210 = (((select(_e197, _e191, (_e197 < _e191)) < 2139095040u) && ((bitcast<u32>(_e204) & 2147483647u) <= 2139095040u)) && (_e185 > 0u));
                    if _e210 {
                        let _e213 = (bitcast<u32>(bitcast<f32>(_e185)) & 2147483647u);
                        if (_e213 >= 8388608u) {
                            phi_377_ = (bitcast<i32>((_e213 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_377_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e213)), 32u, (_e213 == 0u))));
                        }
                        let _e227 = phi_377_;
                        phi_378_ = _e227;
                    } else {
                        phi_378_ = 0i;
                    }
                    let _e229 = phi_378_;
                    let _e230 = (_e146 == _e185);
                    if _e230 {
                        phi_388_ = true;
                    } else {
                        phi_388_ = (_e153 == _e185);
                    }
                    let _e233 = phi_388_;
                    let _e234 = select(1u, 0u, _e230);
                    if _e233 {
                        let _e235 = (_e234 + 1u);
                        phi_398_ = _e235;
                        phi_399_ = _e235;
                        phi_401_ = select(true, false, (_e235 == 2u));
                    } else {
                        phi_398_ = u32();
                        phi_399_ = 0u;
                        phi_401_ = true;
                    }
                    let _e239 = phi_398_;
                    let _e241 = phi_399_;
                    let _e243 = phi_401_;
                    if _e243 {
                        phi_406_ = (_e241 + 1u);
                    } else {
                        phi_406_ = 0u;
                    }
                    let _e247 = phi_406_;
                    let _e248 = select(_e239, _e241, _e243);
                    let _e249 = select(_e234, select(2u, _e234, _e233), _e243);
                    let _e250 = (_e116 / 2i);
                    let _e255 = bitcast<f32>((bitcast<u32>((_e250 + 127i)) << bitcast<u32>(23i)));
                    let _e261 = bitcast<f32>((bitcast<u32>(((_e116 - _e250) + 127i)) << bitcast<u32>(23i)));
                    let _e262 = -(_e229);
                    let _e263 = (_e262 / 2i);
                    let _e268 = bitcast<f32>((bitcast<u32>((_e263 + 127i)) << bitcast<u32>(23i)));
                    let _e274 = bitcast<f32>((bitcast<u32>(((_e262 - _e263) + 127i)) << bitcast<u32>(23i)));
                    let _e278 = global_4.member[_e134].member;
                    let _e279 = (_e248 == 0u);
                    if _e279 {
                        phi_451_ = _e278[0];
                    } else {
                        phi_451_ = _e278[1];
                    }
                    let _e283 = phi_451_;
                    let _e284 = (_e248 == 2u);
                    if _e284 {
                        phi_457_ = _e278[2];
                    } else {
                        phi_457_ = _e283;
                    }
                    let _e287 = phi_457_;
                    let _e289 = ((_e287 * _e255) * _e261);
                    let _e290 = global_4.member[_e134].member_2;
                    if _e279 {
                        phi_468_ = _e290[0];
                    } else {
                        phi_468_ = _e290[1];
                    }
                    let _e294 = phi_468_;
                    if _e284 {
                        phi_474_ = _e290[2];
                    } else {
                        phi_474_ = _e294;
                    }
                    let _e297 = phi_474_;
                    let _e299 = ((_e297 * _e268) * _e274);
                    let _e303 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e303 {
                        let _e307 = (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) * 0.00000011920929f);
                        phi_497_ = select(0.00000000000011368684f, _e307, (_e307 > 0.00000000000011368684f));
                    } else {
                        phi_497_ = 0f;
                    }
                    let _e311 = phi_497_;
                    let _e312 = (_e289 + _e311);
                    let _e313 = (_e289 - _e311);
                    let _e314 = select(_e299, 0f, _e303);
                    if _e303 {
                        phi_508_ = 38685626000000000000000000f;
                    } else {
                        phi_508_ = (1f / _e299);
                    }
                    let _e317 = phi_508_;
                    let _e318 = (_e247 == 0u);
                    if _e318 {
                        phi_517_ = _e278[0];
                    } else {
                        phi_517_ = _e278[1];
                    }
                    let _e322 = phi_517_;
                    let _e323 = (_e247 == 2u);
                    if _e323 {
                        phi_523_ = _e278[2];
                    } else {
                        phi_523_ = _e322;
                    }
                    let _e326 = phi_523_;
                    let _e328 = ((_e326 * _e255) * _e261);
                    if _e318 {
                        phi_534_ = _e290[0];
                    } else {
                        phi_534_ = _e290[1];
                    }
                    let _e332 = phi_534_;
                    if _e323 {
                        phi_540_ = _e290[2];
                    } else {
                        phi_540_ = _e332;
                    }
                    let _e335 = phi_540_;
                    let _e337 = ((_e335 * _e268) * _e274);
                    let _e341 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e341 {
                        let _e345 = (bitcast<f32>((bitcast<u32>(_e328) & 2147483647u)) * 0.00000011920929f);
                        phi_563_ = select(0.00000000000011368684f, _e345, (_e345 > 0.00000000000011368684f));
                    } else {
                        phi_563_ = 0f;
                    }
                    let _e349 = phi_563_;
                    let _e350 = (_e328 + _e349);
                    let _e351 = (_e328 - _e349);
                    let _e352 = select(_e337, 0f, _e341);
                    if _e341 {
                        phi_574_ = 38685626000000000000000000f;
                    } else {
                        phi_574_ = (1f / _e337);
                    }
                    let _e355 = phi_574_;
                    let _e356 = (_e249 == 0u);
                    if _e356 {
                        phi_583_ = _e278[0];
                    } else {
                        phi_583_ = _e278[1];
                    }
                    let _e360 = phi_583_;
                    let _e361 = (_e249 == 2u);
                    if _e361 {
                        phi_589_ = _e278[2];
                    } else {
                        phi_589_ = _e360;
                    }
                    let _e364 = phi_589_;
                    let _e366 = ((_e364 * _e255) * _e261);
                    if _e356 {
                        phi_600_ = _e290[0];
                    } else {
                        phi_600_ = _e290[1];
                    }
                    let _e370 = phi_600_;
                    if _e361 {
                        phi_606_ = _e290[2];
                    } else {
                        phi_606_ = _e370;
                    }
                    let _e373 = phi_606_;
                    let _e375 = ((_e373 * _e268) * _e274);
                    let _e379 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e379 {
                        let _e383 = (bitcast<f32>((bitcast<u32>(_e366) & 2147483647u)) * 0.00000011920929f);
                        phi_629_ = select(0.00000000000011368684f, _e383, (_e383 > 0.00000000000011368684f));
                    } else {
                        phi_629_ = 0f;
                    }
                    let _e387 = phi_629_;
                    let _e388 = (_e366 + _e387);
                    let _e389 = (_e366 - _e387);
                    let _e390 = select(_e375, 0f, _e379);
                    if _e379 {
                        phi_640_ = 38685626000000000000000000f;
                    } else {
                        phi_640_ = (1f / _e375);
                    }
                    let _e393 = phi_640_;
                    let _e396 = bitcast<f32>((bitcast<u32>(_e289) & 2147483647u));
                    let _e399 = bitcast<f32>((bitcast<u32>(_e328) & 2147483647u));
                    let _e401 = select(_e399, _e396, (_e396 > _e399));
                    let _e404 = bitcast<f32>((bitcast<u32>(_e366) & 2147483647u));
                    let _e407 = (_e116 + _e229);
                    if (_e210 && (select(_e404, _e401, (_e401 > _e404)) <= 1099511600000f)) {
                        let _e410 = (_e407 / 3i);
                        let _e417 = bitcast<f32>((bitcast<u32>((_e410 + 127i)) << bitcast<u32>(23i)));
                        let _e424 = bitcast<f32>((bitcast<u32>(((_e407 - (2i * _e410)) + 127i)) << bitcast<u32>(23i)));
                        let _e425 = (((_e195 * _e417) * _e417) * _e424);
                        let _e427 = select(340282350000000000000000000000000000000f, _e425, (_e425 < 340282350000000000000000000000000000000f));
                        let _e432 = (((_e204 * _e417) * _e417) * _e424);
                        let _e434 = select(340282350000000000000000000000000000000f, _e432, (_e432 < 340282350000000000000000000000000000000f));
                        phi_740_ = select(-340282350000000000000000000000000000000f, _e434, (_e434 > -340282350000000000000000000000000000000f));
                        phi_741_ = select(-340282350000000000000000000000000000000f, _e427, (_e427 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_740_ = 0f;
                        phi_741_ = 1f;
                    }
                    let _e438 = phi_740_;
                    let _e440 = phi_741_;
                    local_3 = array<type_49, 128>(type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e445 = (_e248 % 3u);
                    let _e446 = (_e445 < 3u);
                    if _e446 {
                    } else {
                        break;
                    }
                    let _e448 = local_1[_e445];
                    let _e451 = (_e247 % 3u);
                    let _e452 = (_e451 < 3u);
                    if _e452 {
                    } else {
                        break;
                    }
                    let _e454 = local_1[_e451];
                    let _e457 = (_e249 % 3u);
                    let _e458 = (_e457 < 3u);
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e460 = local_1[_e457];
                    if _e446 {
                    } else {
                        break;
                    }
                    let _e465 = local[_e445];
                    if _e452 {
                    } else {
                        break;
                    }
                    let _e469 = local[_e451];
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e473 = local[_e457];
                    phi_4207_ = false;
                    phi_1862_ = type_38(type_31(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e438), 0u, 0u);
                    phi_1865_ = type_49(type_28(vec4<f32>((f32(_e448) * _e128), (f32(_e454) * _e128), (f32(_e460) * _e128), 0f), vec4<f32>((f32(_e465) * _e128), (f32(_e469) * _e128), (f32(_e473) * _e128), 0f)), select(0u, 2147483648u, (_e78 == 0u)));
                    phi_1867_ = ((3u * _e78) + 1u);
                    phi_1869_ = (_e440 <= _e438);
                    phi_1871_ = 0u;
                    loop {
                        let _e483 = phi_4207_;
                        let _e485 = phi_1862_;
                        let _e487 = phi_1865_;
                        let _e489 = phi_1867_;
                        let _e491 = phi_1869_;
                        let _e493 = phi_1871_;
                        local_4 = _e485;
                        local_5 = _e485;
                        if _e491 {
                            phi_1882_ = true;
                        } else {
                            phi_1882_ = (_e493 > 0u);
                        }
                        let _e496 = phi_1882_;
                        if _e496 {
                            let _e497 = (_e489 > 0u);
                            if _e497 {
                                if _e491 {
                                    phi_1919_ = _e487;
                                    phi_1920_ = _e491;
                                    phi_1921_ = _e493;
                                } else {
                                    let _e498 = (_e493 - 1u);
                                    let _e499 = (_e498 % 128u);
                                    let _e500 = (_e499 < 128u);
                                    if _e500 {
                                    } else {
                                        phi_4311_ = true;
                                        break;
                                    }
                                    let _e502 = local_3[_e499];
                                    if _e500 {
                                    } else {
                                        phi_4311_ = true;
                                        break;
                                    }
                                    let _e510 = local_2[_e499];
                                    phi_1919_ = type_49(type_28(_e502.member.member, _e502.member.member_1), _e502.member_1);
                                    phi_1920_ = (_e510 <= _e485.member.member_1);
                                    phi_1921_ = _e498;
                                }
                                let _e515 = phi_1919_;
                                let _e517 = phi_1920_;
                                let _e519 = phi_1921_;
                                if _e517 {
                                    if ((_e515.member_1 & 2147483648u) != 0u) {
                                        phi_1939_ = _e485;
                                        phi_1942_ = type_4(0u, ((_e515.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e972 = phi_1939_;
                                            let _e974 = phi_1942_;
                                            local_6 = _e972;
                                            if (_e974.member < _e974.member_1) {
                                                phi_1943_ = type_4((_e974.member + 1u), _e974.member_1);
                                                phi_1965_ = type_4(1u, _e974.member);
                                            } else {
                                                phi_1943_ = _e974;
                                                phi_1965_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e987 = phi_1943_;
                                            let _e989 = phi_1965_;
                                            let _e993 = (bitcast<i32>(_e989.member) != 0i);
                                            if _e993 {
                                                let _e999 = type_38(_e972.member, _e972.member_1, (_e972.member_2 + 1u));
                                                let _e1000 = ((_e515.member_1 & 268435455u) + _e989.member_1);
                                                let _e1001 = (_e1000 < _e80);
                                                if _e1001 {
                                                    if _e1001 {
                                                    } else {
                                                        phi_4201_ = true;
                                                        break;
                                                    }
                                                    let _e1005 = global_2.member[_e1000].member_1;
                                                    phi_1989_ = _e1005;
                                                } else {
                                                    phi_1989_ = 4294967295u;
                                                }
                                                let _e1007 = phi_1989_;
                                                if (_e1000 >= _e80) {
                                                    phi_2078_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1001 {
                                                    } else {
                                                        phi_4201_ = true;
                                                        break;
                                                    }
                                                    if (_e445 < 9u) {
                                                    } else {
                                                        phi_4201_ = true;
                                                        break;
                                                    }
                                                    let _e1014 = global_2.member[_e1000].member[_e445];
                                                    if (_e451 < 9u) {
                                                    } else {
                                                        phi_4201_ = true;
                                                        break;
                                                    }
                                                    let _e1020 = global_2.member[_e1000].member[_e451];
                                                    if (_e457 < 9u) {
                                                    } else {
                                                        phi_4201_ = true;
                                                        break;
                                                    }
                                                    let _e1026 = global_2.member[_e1000].member[_e457];
                                                    let _e1028 = (3u + _e445);
                                                    if (_e1028 < 9u) {
                                                    } else {
                                                        phi_4201_ = true;
                                                        break;
                                                    }
                                                    let _e1034 = global_2.member[_e1000].member[_e1028];
                                                    let _e1035 = (3u + _e451);
                                                    if (_e1035 < 9u) {
                                                    } else {
                                                        phi_4201_ = true;
                                                        break;
                                                    }
                                                    let _e1041 = global_2.member[_e1000].member[_e1035];
                                                    let _e1042 = (3u + _e457);
                                                    if (_e1042 < 9u) {
                                                    } else {
                                                        phi_4201_ = true;
                                                        break;
                                                    }
                                                    let _e1048 = global_2.member[_e1000].member[_e1042];
                                                    let _e1050 = (6u + _e445);
                                                    if (_e1050 < 9u) {
                                                    } else {
                                                        phi_4201_ = true;
                                                        break;
                                                    }
                                                    let _e1056 = global_2.member[_e1000].member[_e1050];
                                                    let _e1057 = (6u + _e451);
                                                    if (_e1057 < 9u) {
                                                    } else {
                                                        phi_4201_ = true;
                                                        break;
                                                    }
                                                    let _e1063 = global_2.member[_e1000].member[_e1057];
                                                    let _e1064 = (6u + _e457);
                                                    if (_e1064 < 9u) {
                                                    } else {
                                                        phi_4201_ = true;
                                                        break;
                                                    }
                                                    let _e1070 = global_2.member[_e1000].member[_e1064];
                                                    phi_2078_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1014, _e1020, _e1026), array<f32, 3>(_e1034, _e1041, _e1048), array<f32, 3>(_e1056, _e1063, _e1070));
                                                }
                                                let _e1074 = phi_2078_;
                                                let _e1083 = (_e1074[0][2] - _e366);
                                                let _e1086 = (((_e1074[0][0] - _e289) * _e390) - (_e1083 * _e314));
                                                let _e1089 = (((_e1074[0][1] - _e328) * _e390) - (_e1083 * _e352));
                                                let _e1096 = (_e1074[1][2] - _e366);
                                                let _e1099 = (((_e1074[1][0] - _e289) * _e390) - (_e1096 * _e314));
                                                let _e1102 = (((_e1074[1][1] - _e328) * _e390) - (_e1096 * _e352));
                                                let _e1109 = (_e1074[2][2] - _e366);
                                                let _e1112 = (((_e1074[2][0] - _e289) * _e390) - (_e1109 * _e314));
                                                let _e1115 = (((_e1074[2][1] - _e328) * _e390) - (_e1109 * _e352));
                                                let _e1116 = (_e1112 * _e1102);
                                                let _e1117 = (_e1115 * _e1099);
                                                let _e1118 = (_e1086 * _e1115);
                                                let _e1119 = (_e1089 * _e1112);
                                                let _e1120 = (_e1099 * _e1089);
                                                let _e1121 = (_e1102 * _e1086);
                                                let _e1126 = (((_e1116 >= _e1117) && (_e1118 >= _e1119)) && (_e1120 >= _e1121));
                                                if (_e1126 || (((_e1116 <= _e1117) && (_e1118 <= _e1119)) && (_e1120 <= _e1121))) {
                                                    let _e1133 = select(-1f, 1f, _e1126);
                                                    let _e1135 = ((_e1116 - _e1117) * _e1133);
                                                    let _e1137 = select(0f, _e1135, (_e1135 > 0f));
                                                    let _e1139 = ((_e1118 - _e1119) * _e1133);
                                                    let _e1141 = select(0f, _e1139, (_e1139 > 0f));
                                                    let _e1143 = ((_e1120 - _e1121) * _e1133);
                                                    let _e1145 = select(0f, _e1143, (_e1143 > 0f));
                                                    let _e1147 = ((_e1137 + _e1141) + _e1145);
                                                    if (_e1147 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2644_ = type_24();
                                                        phi_2645_ = true;
                                                    } else {
                                                        let _e1150 = select(_e1074[1][0], _e1074[0][0], (_e1074[0][0] < _e1074[1][0]));
                                                        let _e1154 = select(_e1074[1][0], _e1074[0][0], (_e1074[0][0] > _e1074[1][0]));
                                                        let _e1158 = select(_e1074[1][1], _e1074[0][1], (_e1074[0][1] < _e1074[1][1]));
                                                        let _e1162 = select(_e1074[1][1], _e1074[0][1], (_e1074[0][1] > _e1074[1][1]));
                                                        let _e1166 = select(_e1074[1][2], _e1074[0][2], (_e1074[0][2] < _e1074[1][2]));
                                                        let _e1170 = select(_e1074[1][2], _e1074[0][2], (_e1074[0][2] > _e1074[1][2]));
                                                        let _e1175 = ((select(_e1074[2][0], _e1150, (_e1150 < _e1074[2][0])) - _e312) * _e317);
                                                        let _e1176 = ((select(_e1074[2][0], _e1154, (_e1154 > _e1074[2][0])) - _e313) * _e317);
                                                        let _e1179 = ((select(_e1074[2][1], _e1158, (_e1158 < _e1074[2][1])) - _e350) * _e355);
                                                        let _e1180 = ((select(_e1074[2][1], _e1162, (_e1162 > _e1074[2][1])) - _e351) * _e355);
                                                        let _e1183 = ((select(_e1074[2][2], _e1166, (_e1166 < _e1074[2][2])) - _e388) * _e393);
                                                        let _e1184 = ((select(_e1074[2][2], _e1170, (_e1170 > _e1074[2][2])) - _e389) * _e393);
                                                        let _e1186 = select(_e1184, _e1183, (_e1183 < _e1184));
                                                        let _e1188 = select(_e1184, _e1183, (_e1183 > _e1184));
                                                        let _e1190 = select(_e1176, _e1175, (_e1175 < _e1176));
                                                        let _e1192 = select(_e1180, _e1179, (_e1179 < _e1180));
                                                        let _e1194 = select(_e1192, _e1190, (_e1190 > _e1192));
                                                        let _e1196 = select(_e1186, _e1194, (_e1194 > _e1186));
                                                        let _e1198 = select(_e1176, _e1175, (_e1175 > _e1176));
                                                        let _e1200 = select(_e1180, _e1179, (_e1179 > _e1180));
                                                        let _e1202 = select(_e1200, _e1198, (_e1198 < _e1200));
                                                        let _e1204 = select(_e1188, _e1202, (_e1202 < _e1188));
                                                        let _e1205 = -(_e1186);
                                                        let _e1211 = select(_e440, _e1196, (_e1196 > _e440));
                                                        if (_e1211 > (_e1204 + (select(_e1205, _e1188, (_e1188 > _e1205)) * 0.0000019073523f))) {
                                                            phi_2639_ = type_24();
                                                            phi_2640_ = true;
                                                        } else {
                                                            let _e1213 = (_e1211 > _e972.member.member_1);
                                                            if _e1213 {
                                                                phi_2638_ = type_24();
                                                            } else {
                                                                let _e1217 = (_e1074[1][0] - _e1074[0][0]);
                                                                let _e1218 = (_e1074[1][1] - _e1074[0][1]);
                                                                let _e1219 = (_e1074[1][2] - _e1074[0][2]);
                                                                let _e1220 = vec3<f32>(_e1217, _e1218, _e1219);
                                                                let _e1221 = (_e1074[2][0] - _e1074[1][0]);
                                                                let _e1222 = (_e1074[2][1] - _e1074[1][1]);
                                                                let _e1223 = (_e1074[2][2] - _e1074[1][2]);
                                                                let _e1224 = vec3<f32>(_e1221, _e1222, _e1223);
                                                                let _e1225 = (_e1074[0][0] - _e1074[2][0]);
                                                                let _e1226 = (_e1074[0][1] - _e1074[2][1]);
                                                                let _e1227 = (_e1074[0][2] - _e1074[2][2]);
                                                                let _e1228 = vec3<f32>(_e1225, _e1226, _e1227);
                                                                let _e1231 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                let _e1234 = bitcast<f32>((bitcast<u32>(_e1218) & 2147483647u));
                                                                let _e1236 = select(_e1234, _e1231, (_e1231 > _e1234));
                                                                let _e1239 = bitcast<f32>((bitcast<u32>(_e1219) & 2147483647u));
                                                                let _e1241 = select(_e1239, _e1236, (_e1236 > _e1239));
                                                                let _e1244 = bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u));
                                                                let _e1247 = bitcast<f32>((bitcast<u32>(_e1222) & 2147483647u));
                                                                let _e1249 = select(_e1247, _e1244, (_e1244 > _e1247));
                                                                let _e1252 = bitcast<f32>((bitcast<u32>(_e1223) & 2147483647u));
                                                                let _e1254 = select(_e1252, _e1249, (_e1249 > _e1252));
                                                                let _e1257 = bitcast<f32>((bitcast<u32>(_e1225) & 2147483647u));
                                                                let _e1260 = bitcast<f32>((bitcast<u32>(_e1226) & 2147483647u));
                                                                let _e1262 = select(_e1260, _e1257, (_e1257 > _e1260));
                                                                let _e1265 = bitcast<f32>((bitcast<u32>(_e1227) & 2147483647u));
                                                                let _e1267 = select(_e1265, _e1262, (_e1262 > _e1265));
                                                                let _e1269 = select(_e1254, _e1241, (_e1241 > _e1254));
                                                                let _e1271 = select(_e1267, _e1269, (_e1269 > _e1267));
                                                                if (_e1241 == _e1271) {
                                                                    phi_2549_ = _e1224;
                                                                    phi_2550_ = _e1228;
                                                                } else {
                                                                    let _e1274 = vec3((_e1254 == _e1271));
                                                                    phi_2549_ = select(_e1220, _e1228, _e1274);
                                                                    phi_2550_ = select(_e1224, _e1220, _e1274);
                                                                }
                                                                let _e1278 = phi_2549_;
                                                                let _e1280 = phi_2550_;
                                                                let _e1287 = ((_e1278.y * _e1280.z) - (_e1280.y * _e1278.z));
                                                                let _e1292 = ((_e1278.z * _e1280.x) - (_e1280.z * _e1278.x));
                                                                let _e1295 = ((_e1278.x * _e1280.y) - (_e1280.x * _e1278.y));
                                                                if (_e1137 >= _e1141) {
                                                                    phi_2581_ = select(true, false, (_e1137 >= _e1145));
                                                                } else {
                                                                    phi_2581_ = true;
                                                                }
                                                                let _e1300 = phi_2581_;
                                                                if _e1300 {
                                                                    phi_2590_ = select(vec3<f32>(_e1074[2][0], _e1074[2][1], _e1074[2][2]), vec3<f32>(_e1074[1][0], _e1074[1][1], _e1074[1][2]), vec3((_e1141 >= _e1145)));
                                                                } else {
                                                                    phi_2590_ = vec3<f32>(_e1074[0][0], _e1074[0][1], _e1074[0][2]);
                                                                }
                                                                let _e1305 = phi_2590_;
                                                                let _e1322 = ((((_e1287 * (_e1305.x - _e289)) + (_e1292 * (_e1305.y - _e328))) + (_e1295 * (_e1305.z - _e366))) / (((_e1287 * _e314) + (_e1292 * _e352)) + (_e1295 * _e390)));
                                                                let _e1324 = select(_e1204, _e1322, (_e1322 < _e1204));
                                                                let _e1326 = select(_e1196, _e1324, (_e1324 > _e1196));
                                                                if (_e1326 >= _e440) {
                                                                    let _e1328 = (_e1326 <= _e972.member.member_1);
                                                                    if _e1328 {
                                                                        let _e1329 = (1f / _e1147);
                                                                        phi_2630_ = type_24(_e1326, (_e1141 * _e1329), (_e1145 * _e1329), _e1007);
                                                                    } else {
                                                                        phi_2630_ = type_24();
                                                                    }
                                                                    let _e1334 = phi_2630_;
                                                                    phi_2632_ = _e1334;
                                                                    phi_2633_ = select(true, false, _e1328);
                                                                } else {
                                                                    phi_2632_ = type_24();
                                                                    phi_2633_ = true;
                                                                }
                                                                let _e1337 = phi_2632_;
                                                                let _e1339 = phi_2633_;
                                                                if _e1339 {
                                                                    phi_2637_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2637_ = _e1337;
                                                                }
                                                                let _e1341 = phi_2637_;
                                                                phi_2638_ = _e1341;
                                                            }
                                                            let _e1343 = phi_2638_;
                                                            phi_2639_ = _e1343;
                                                            phi_2640_ = _e1213;
                                                        }
                                                        let _e1345 = phi_2639_;
                                                        let _e1347 = phi_2640_;
                                                        phi_2644_ = _e1345;
                                                        phi_2645_ = _e1347;
                                                    }
                                                    let _e1349 = phi_2644_;
                                                    let _e1351 = phi_2645_;
                                                    phi_2649_ = _e1349;
                                                    phi_2650_ = _e1351;
                                                } else {
                                                    phi_2649_ = type_24();
                                                    phi_2650_ = true;
                                                }
                                                let _e1353 = phi_2649_;
                                                let _e1355 = phi_2650_;
                                                if _e1355 {
                                                    phi_2654_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2654_ = _e1353;
                                                }
                                                let _e1357 = phi_2654_;
                                                if (_e1357.member_3 != 4294967295u) {
                                                    if (_e1007 != 4294967295u) {
                                                        if (_e1357.member < _e972.member.member.member) {
                                                            phi_2680_ = true;
                                                        } else {
                                                            if (_e1357.member == _e972.member.member.member) {
                                                                phi_2679_ = (_e1357.member_3 < _e972.member.member.member_3);
                                                            } else {
                                                                phi_2679_ = false;
                                                            }
                                                            let _e1372 = phi_2679_;
                                                            phi_2680_ = _e1372;
                                                        }
                                                        let _e1374 = phi_2680_;
                                                        if _e1374 {
                                                            phi_2687_ = type_38(type_31(_e1357, _e1357.member), _e999.member_1, _e999.member_2);
                                                        } else {
                                                            phi_2687_ = _e999;
                                                        }
                                                        let _e1381 = phi_2687_;
                                                        phi_2688_ = _e1381;
                                                    } else {
                                                        phi_2688_ = _e999;
                                                    }
                                                    let _e1383 = phi_2688_;
                                                    phi_2689_ = _e1383;
                                                } else {
                                                    phi_2689_ = _e999;
                                                }
                                                let _e1385 = phi_2689_;
                                                phi_1940_ = _e1385;
                                            } else {
                                                phi_1940_ = type_38();
                                            }
                                            let _e1387 = phi_1940_;
                                            continue;
                                            continuing {
                                                phi_1939_ = _e1387;
                                                phi_1942_ = _e987;
                                                phi_4201_ = _e483;
                                                break if !(_e993);
                                            }
                                        }
                                        let _e1390 = phi_4201_;
                                        phi_4311_ = _e1390;
                                        if _e1390 {
                                            break;
                                        }
                                        phi_4315_ = _e1390;
                                        let _e1541 = local_6;
                                        phi_3995_ = _e1541;
                                        phi_3996_ = _e515;
                                        phi_3997_ = false;
                                        phi_3998_ = _e519;
                                    } else {
                                        if (_e515.member_1 >= _e78) {
                                            phi_3595_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e515.member_1 < _e78) {
                                            } else {
                                                phi_4311_ = true;
                                                break;
                                            }
                                            let _e538 = ((1u + (_e248 * 2u)) % 7u);
                                            if (_e538 < 7u) {
                                            } else {
                                                phi_4311_ = true;
                                                break;
                                            }
                                            let _e543 = global_5.member[_e515.member_1][_e538];
                                            let _e546 = ((1u + (_e247 * 2u)) % 7u);
                                            if (_e546 < 7u) {
                                            } else {
                                                phi_4311_ = true;
                                                break;
                                            }
                                            let _e551 = global_5.member[_e515.member_1][_e546];
                                            let _e554 = ((1u + (_e249 * 2u)) % 7u);
                                            if (_e554 < 7u) {
                                            } else {
                                                phi_4311_ = true;
                                                break;
                                            }
                                            let _e559 = global_5.member[_e515.member_1][_e554];
                                            let _e562 = (((_e248 + 1u) * 2u) % 7u);
                                            if (_e562 < 7u) {
                                            } else {
                                                phi_4311_ = true;
                                                break;
                                            }
                                            let _e567 = global_5.member[_e515.member_1][_e562];
                                            let _e570 = (((_e247 + 1u) * 2u) % 7u);
                                            if (_e570 < 7u) {
                                            } else {
                                                phi_4311_ = true;
                                                break;
                                            }
                                            let _e575 = global_5.member[_e515.member_1][_e570];
                                            let _e578 = (((_e249 + 1u) * 2u) % 7u);
                                            if (_e578 < 7u) {
                                            } else {
                                                phi_4311_ = true;
                                                break;
                                            }
                                            let _e583 = global_5.member[_e515.member_1][_e578];
                                            let _e606 = (bitcast<f32>((bitcast<u32>((_e515.member.member_1.x - _e515.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e607 = (bitcast<f32>((bitcast<u32>((_e515.member.member_1.y - _e515.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e608 = (bitcast<f32>((bitcast<u32>((_e515.member.member_1.z - _e515.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e610 = select(_e128, _e606, (_e606 > _e128));
                                            let _e612 = select(_e128, _e607, (_e607 > _e128));
                                            let _e614 = select(_e128, _e608, (_e608 > _e128));
                                            let _e639 = bitcast<u32>((f32(bitcast<i32>((_e543 & 2097151u))) * _e610));
                                            let _e644 = (bitcast<i32>((_e543 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e647 = bitcast<f32>((_e639 & bitcast<u32>(_e644)));
                                            let _e648 = bitcast<u32>((f32(bitcast<i32>((_e551 & 2097151u))) * _e612));
                                            let _e653 = (bitcast<i32>((_e551 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e656 = bitcast<f32>((_e648 & bitcast<u32>(_e653)));
                                            let _e657 = bitcast<u32>((f32(bitcast<i32>((_e559 & 2097151u))) * _e614));
                                            let _e662 = (bitcast<i32>((_e559 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e665 = bitcast<f32>((_e657 & bitcast<u32>(_e662)));
                                            let _e669 = bitcast<f32>((_e639 & bitcast<u32>(~(_e644))));
                                            let _e673 = bitcast<f32>((_e648 & bitcast<u32>(~(_e653))));
                                            let _e677 = bitcast<f32>((_e657 & bitcast<u32>(~(_e662))));
                                            let _e678 = bitcast<u32>((f32(bitcast<i32>((_e567 & 2097151u))) * _e610));
                                            let _e683 = (bitcast<i32>((_e567 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e686 = bitcast<f32>((_e678 & bitcast<u32>(_e683)));
                                            let _e687 = bitcast<u32>((f32(bitcast<i32>((_e575 & 2097151u))) * _e612));
                                            let _e692 = (bitcast<i32>((_e575 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e695 = bitcast<f32>((_e687 & bitcast<u32>(_e692)));
                                            let _e696 = bitcast<u32>((f32(bitcast<i32>((_e583 & 2097151u))) * _e614));
                                            let _e701 = (bitcast<i32>((_e583 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e704 = bitcast<f32>((_e696 & bitcast<u32>(_e701)));
                                            let _e708 = bitcast<f32>((_e678 & bitcast<u32>(~(_e683))));
                                            let _e712 = bitcast<f32>((_e687 & bitcast<u32>(~(_e692))));
                                            let _e716 = bitcast<f32>((_e696 & bitcast<u32>(~(_e701))));
                                            let _e746 = global_5.member[_e515.member_1][0u];
                                            let _e750 = global_5.member[_e515.member_1][2u];
                                            let _e754 = global_5.member[_e515.member_1][4u];
                                            let _e758 = global_5.member[_e515.member_1][6u];
                                            let _e770 = (((_e750 >> bitcast<u32>(22i)) | ((_e754 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e758 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e771 = (_e746 & 268435455u);
                                            let _e772 = (_e770 & 268435455u);
                                            let _e775 = ((_e746 >> bitcast<u32>(28u)) & 7u);
                                            let _e783 = ((_e746 >> bitcast<u32>(31i)) | (((_e770 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e784 = (_e775 != 0u);
                                            if (_e775 == 0u) {
                                                phi_3557_ = _e771;
                                            } else {
                                                if (_e775 == 7u) {
                                                    phi_3556_ = 2147483648u;
                                                } else {
                                                    phi_3556_ = ((2147483648u | (_e775 << bitcast<u32>(28u))) | (_e772 & 268435455u));
                                                }
                                                let _e793 = phi_3556_;
                                                phi_3557_ = _e793;
                                            }
                                            let _e795 = phi_3557_;
                                            if _e784 {
                                                let _e796 = (_e775 != 7u);
                                                if _e796 {
                                                    phi_3567_ = (_e772 + _e775);
                                                } else {
                                                    phi_3567_ = u32();
                                                }
                                                let _e799 = phi_3567_;
                                                phi_3569_ = _e799;
                                                phi_3570_ = select(true, false, _e796);
                                            } else {
                                                phi_3569_ = u32();
                                                phi_3570_ = true;
                                            }
                                            let _e802 = phi_3569_;
                                            let _e804 = phi_3570_;
                                            if (_e783 == 0u) {
                                                phi_3591_ = (_e771 + select(0u, 1u, !(_e784)));
                                            } else {
                                                if (_e783 == 7u) {
                                                    phi_3590_ = 2147483648u;
                                                } else {
                                                    phi_3590_ = ((2147483648u | (_e783 << bitcast<u32>(28u))) | (select(_e802, _e772, _e804) & 268435455u));
                                                }
                                                let _e817 = phi_3590_;
                                                phi_3591_ = _e817;
                                            }
                                            let _e819 = phi_3591_;
                                            phi_3595_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e515.member.member.x + _e647), (_e515.member.member.x + _e669), (_e515.member.member_1.x - _e686), (_e515.member.member_1.x - _e708)), vec4<f32>((_e515.member.member.y + _e656), (_e515.member.member.y + _e673), (_e515.member.member_1.y - _e695), (_e515.member.member_1.y - _e712)), vec4<f32>((_e515.member.member.z + _e665), (_e515.member.member.z + _e677), (_e515.member.member_1.z - _e704), (_e515.member.member_1.z - _e716))), type_49(type_28((_e515.member.member + vec4<f32>(_e647, _e656, _e665, 0f)), (_e515.member.member_1 - vec4<f32>(_e686, _e695, _e704, 0f))), _e795), type_49(type_28((_e515.member.member + vec4<f32>(_e669, _e673, _e677, 0f)), (_e515.member.member_1 - vec4<f32>(_e708, _e712, _e716, 0f))), _e819));
                                        }
                                        let _e824 = phi_3595_;
                                        let _e837 = ((_e824.member[0].x - _e312) * _e317);
                                        let _e838 = ((_e824.member[0].y - _e312) * _e317);
                                        let _e839 = ((_e824.member[0].z - _e313) * _e317);
                                        let _e840 = ((_e824.member[0].w - _e313) * _e317);
                                        let _e850 = ((_e824.member[1].x - _e350) * _e355);
                                        let _e851 = ((_e824.member[1].y - _e350) * _e355);
                                        let _e852 = ((_e824.member[1].z - _e351) * _e355);
                                        let _e853 = ((_e824.member[1].w - _e351) * _e355);
                                        let _e863 = ((_e824.member[2].x - _e388) * _e393);
                                        let _e864 = ((_e824.member[2].y - _e388) * _e393);
                                        let _e865 = ((_e824.member[2].z - _e389) * _e393);
                                        let _e866 = ((_e824.member[2].w - _e389) * _e393);
                                        let _e868 = select(_e865, _e863, (_e863 < _e865));
                                        let _e870 = select(_e866, _e864, (_e864 < _e866));
                                        let _e872 = select(_e865, _e863, (_e863 > _e865));
                                        let _e874 = select(_e866, _e864, (_e864 > _e866));
                                        let _e876 = select(_e839, _e837, (_e837 < _e839));
                                        let _e878 = select(_e840, _e838, (_e838 < _e840));
                                        let _e880 = select(_e852, _e850, (_e850 < _e852));
                                        let _e882 = select(_e853, _e851, (_e851 < _e853));
                                        let _e884 = select(_e880, _e876, (_e876 > _e880));
                                        let _e886 = select(_e882, _e878, (_e878 > _e882));
                                        let _e888 = select(_e868, _e884, (_e884 > _e868));
                                        let _e890 = select(_e870, _e886, (_e886 > _e870));
                                        let _e892 = select(_e839, _e837, (_e837 > _e839));
                                        let _e894 = select(_e840, _e838, (_e838 > _e840));
                                        let _e896 = select(_e852, _e850, (_e850 > _e852));
                                        let _e898 = select(_e853, _e851, (_e851 > _e853));
                                        let _e900 = select(_e896, _e892, (_e892 < _e896));
                                        let _e902 = select(_e898, _e894, (_e894 < _e898));
                                        let _e907 = -(_e868);
                                        let _e908 = -(_e870);
                                        let _e915 = (select(_e872, _e900, (_e900 < _e872)) + (select(_e907, _e872, (_e872 > _e907)) * 0.0000019073523f));
                                        let _e916 = (select(_e874, _e902, (_e902 < _e874)) + (select(_e908, _e874, (_e874 > _e908)) * 0.0000019073523f));
                                        let _e918 = select(_e440, _e888, (_e888 > _e440));
                                        let _e920 = select(_e440, _e890, (_e890 > _e440));
                                        let _e925 = (_e918 <= select(_e485.member.member_1, _e915, (_e915 < _e485.member.member_1)));
                                        let _e926 = (_e920 <= select(_e485.member.member_1, _e916, (_e916 < _e485.member.member_1)));
                                        let _e927 = (_e918 <= _e920);
                                        if _e925 {
                                            if _e926 {
                                                if _e927 {
                                                    phi_3939_ = _e824.member_2;
                                                } else {
                                                    phi_3939_ = _e824.member_1;
                                                }
                                                let _e931 = phi_3939_;
                                                let _e932 = (_e519 % 128u);
                                                let _e933 = (_e932 < 128u);
                                                if _e933 {
                                                } else {
                                                    phi_4311_ = true;
                                                    break;
                                                }
                                                local_3[_e932] = type_49(type_28(_e931.member.member, _e931.member.member_1), _e931.member_1);
                                                if _e933 {
                                                } else {
                                                    phi_4311_ = true;
                                                    break;
                                                }
                                                local_2[_e932] = select(_e920, _e918, (_e918 > _e920));
                                                if _e927 {
                                                    phi_3972_ = _e824.member_1;
                                                } else {
                                                    phi_3972_ = _e824.member_2;
                                                }
                                                let _e948 = phi_3972_;
                                                phi_3973_ = _e948;
                                                phi_3974_ = (_e519 + 1u);
                                            } else {
                                                phi_3973_ = type_49();
                                                phi_3974_ = u32();
                                            }
                                            let _e950 = phi_3973_;
                                            let _e952 = phi_3974_;
                                            phi_3976_ = _e950;
                                            phi_3977_ = _e952;
                                            phi_3978_ = select(true, false, _e926);
                                        } else {
                                            phi_3976_ = type_49();
                                            phi_3977_ = u32();
                                            phi_3978_ = true;
                                        }
                                        let _e955 = phi_3976_;
                                        let _e957 = phi_3977_;
                                        let _e959 = phi_3978_;
                                        if _e959 {
                                            if _e925 {
                                                phi_3987_ = _e824.member_1;
                                            } else {
                                                phi_3987_ = _e824.member_2;
                                            }
                                            let _e963 = phi_3987_;
                                            phi_3992_ = _e963;
                                            phi_3993_ = select(_e926, true, _e925);
                                        } else {
                                            phi_3992_ = _e955;
                                            phi_3993_ = _e517;
                                        }
                                        let _e966 = phi_3992_;
                                        let _e968 = phi_3993_;
                                        phi_4315_ = _e483;
                                        phi_3995_ = type_38(_e485.member, (_e485.member_1 + 1u), _e485.member_2);
                                        phi_3996_ = _e966;
                                        phi_3997_ = _e968;
                                        phi_3998_ = select(_e957, _e519, _e959);
                                    }
                                    let _e1392 = phi_4315_;
                                    let _e1394 = phi_3995_;
                                    let _e1396 = phi_3996_;
                                    let _e1398 = phi_3997_;
                                    let _e1400 = phi_3998_;
                                    phi_4314_ = _e1392;
                                    phi_3999_ = _e1394;
                                    phi_4000_ = _e1396;
                                    phi_4001_ = (_e489 - 1u);
                                    phi_4002_ = _e1398;
                                    phi_4003_ = _e1400;
                                } else {
                                    phi_4314_ = _e483;
                                    phi_3999_ = _e485;
                                    phi_4000_ = _e515;
                                    phi_4001_ = _e489;
                                    phi_4002_ = _e517;
                                    phi_4003_ = _e519;
                                }
                                let _e1402 = phi_4314_;
                                let _e1404 = phi_3999_;
                                let _e1406 = phi_4000_;
                                let _e1408 = phi_4001_;
                                let _e1410 = phi_4002_;
                                let _e1412 = phi_4003_;
                                phi_4313_ = _e1402;
                                phi_4004_ = _e1404;
                                phi_4005_ = _e1406;
                                phi_4006_ = _e1408;
                                phi_4007_ = _e1410;
                                phi_4008_ = _e1412;
                            } else {
                                phi_4313_ = _e483;
                                phi_4004_ = type_38();
                                phi_4005_ = type_49();
                                phi_4006_ = u32();
                                phi_4007_ = bool();
                                phi_4008_ = u32();
                            }
                            let _e1414 = phi_4313_;
                            let _e1416 = phi_4004_;
                            let _e1418 = phi_4005_;
                            let _e1420 = phi_4006_;
                            let _e1422 = phi_4007_;
                            let _e1424 = phi_4008_;
                            phi_4312_ = _e1414;
                            phi_1863_ = _e1416;
                            phi_1866_ = _e1418;
                            phi_1868_ = _e1420;
                            phi_1870_ = _e1422;
                            phi_1872_ = _e1424;
                            phi_4009_ = _e497;
                        } else {
                            phi_4312_ = _e483;
                            phi_1863_ = type_38();
                            phi_1866_ = type_49();
                            phi_1868_ = u32();
                            phi_1870_ = bool();
                            phi_1872_ = u32();
                            phi_4009_ = false;
                        }
                        let _e1426 = phi_4312_;
                        let _e1428 = phi_1863_;
                        let _e1430 = phi_1866_;
                        let _e1432 = phi_1868_;
                        let _e1434 = phi_1870_;
                        let _e1436 = phi_1872_;
                        let _e1438 = phi_4009_;
                        continue;
                        continuing {
                            phi_4207_ = _e1426;
                            phi_1862_ = _e1428;
                            phi_1865_ = _e1430;
                            phi_1867_ = _e1432;
                            phi_1869_ = _e1434;
                            phi_1871_ = _e1436;
                            phi_4311_ = _e1426;
                            break if !(_e1438);
                        }
                    }
                    let _e1441 = phi_4311_;
                    if _e1441 {
                        break;
                    }
                    let _e1443 = local_4;
                    let _e1446 = local_5;
                    if _e136 {
                    } else {
                        break;
                    }
                    global_6.member[_e134][0u] = _e1443.member_1;
                    global_6.member[_e134][1u] = _e1446.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
