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

struct type_31 {
    member: type_20,
    member_1: f32,
}

struct type_36 {
    member: array<type_24>,
}

struct type_39 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<array<u32, 7>>,
}

struct type_48 {
    member: type_28,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_48,
    member_2: type_48,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_39;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(2) 
var<storage> global_5: type_46;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_22;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_48, 128>;
    var phi_376_: i32;
    var phi_377_: i32;
    var phi_387_: bool;
    var phi_397_: u32;
    var phi_398_: u32;
    var phi_400_: bool;
    var phi_405_: u32;
    var phi_450_: f32;
    var phi_456_: f32;
    var phi_467_: f32;
    var phi_473_: f32;
    var phi_496_: f32;
    var phi_507_: f32;
    var phi_516_: f32;
    var phi_522_: f32;
    var phi_533_: f32;
    var phi_539_: f32;
    var phi_562_: f32;
    var phi_573_: f32;
    var phi_582_: f32;
    var phi_588_: f32;
    var phi_599_: f32;
    var phi_605_: f32;
    var phi_628_: f32;
    var phi_639_: f32;
    var phi_739_: f32;
    var phi_740_: f32;
    var phi_4242_: bool;
    var phi_1860_: type_31;
    var phi_1863_: type_48;
    var phi_1865_: u32;
    var phi_1867_: bool;
    var phi_1869_: u32;
    var phi_1880_: bool;
    var phi_1917_: type_48;
    var phi_1918_: bool;
    var phi_1919_: u32;
    var phi_3547_: u32;
    var phi_3548_: u32;
    var phi_3558_: u32;
    var phi_3560_: u32;
    var phi_3561_: bool;
    var phi_3581_: u32;
    var phi_3582_: u32;
    var phi_3586_: type_51;
    var phi_3930_: type_48;
    var phi_3963_: type_48;
    var phi_3964_: type_48;
    var phi_3965_: u32;
    var phi_3967_: type_48;
    var phi_3968_: u32;
    var phi_3969_: bool;
    var phi_3978_: type_48;
    var phi_3983_: type_48;
    var phi_3984_: bool;
    var phi_1937_: type_31;
    var phi_1940_: type_4;
    var phi_1941_: type_4;
    var phi_1963_: type_4;
    var phi_1984_: u32;
    var phi_2073_: array<array<f32, 3>, 3>;
    var phi_2544_: vec3<f32>;
    var phi_2545_: vec3<f32>;
    var phi_2576_: bool;
    var phi_2585_: vec3<f32>;
    var phi_2625_: type_20;
    var phi_2627_: type_20;
    var phi_2628_: bool;
    var phi_2632_: type_20;
    var phi_2633_: type_20;
    var phi_2634_: type_20;
    var phi_2635_: bool;
    var phi_2639_: type_20;
    var phi_2640_: bool;
    var phi_2644_: type_20;
    var phi_2645_: bool;
    var phi_2649_: type_20;
    var phi_2674_: bool;
    var phi_2675_: bool;
    var phi_2681_: type_31;
    var phi_2682_: type_31;
    var phi_2683_: type_31;
    var phi_1938_: type_31;
    var phi_4236_: bool;
    var phi_4350_: bool;
    var phi_3986_: type_31;
    var phi_3987_: type_48;
    var phi_3988_: bool;
    var phi_3989_: u32;
    var phi_4349_: bool;
    var phi_3990_: type_31;
    var phi_3991_: type_48;
    var phi_3992_: u32;
    var phi_3993_: bool;
    var phi_3994_: u32;
    var phi_4348_: bool;
    var phi_3995_: type_31;
    var phi_3996_: type_48;
    var phi_3997_: u32;
    var phi_3998_: bool;
    var phi_3999_: u32;
    var phi_4347_: bool;
    var phi_1861_: type_31;
    var phi_1864_: type_48;
    var phi_1866_: u32;
    var phi_1868_: bool;
    var phi_1870_: u32;
    var phi_4000_: bool;
    var phi_4346_: bool;
    var local_4: type_31;
    var phi_4052_: type_20;
    var local_5: type_31;

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
                            phi_376_ = (bitcast<i32>((_e213 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_376_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e213)), 32u, (_e213 == 0u))));
                        }
                        let _e227 = phi_376_;
                        phi_377_ = _e227;
                    } else {
                        phi_377_ = 0i;
                    }
                    let _e229 = phi_377_;
                    let _e230 = (_e146 == _e185);
                    if _e230 {
                        phi_387_ = true;
                    } else {
                        phi_387_ = (_e153 == _e185);
                    }
                    let _e233 = phi_387_;
                    let _e234 = select(1u, 0u, _e230);
                    if _e233 {
                        let _e235 = (_e234 + 1u);
                        phi_397_ = _e235;
                        phi_398_ = _e235;
                        phi_400_ = select(true, false, (_e235 == 2u));
                    } else {
                        phi_397_ = u32();
                        phi_398_ = 0u;
                        phi_400_ = true;
                    }
                    let _e239 = phi_397_;
                    let _e241 = phi_398_;
                    let _e243 = phi_400_;
                    if _e243 {
                        phi_405_ = (_e241 + 1u);
                    } else {
                        phi_405_ = 0u;
                    }
                    let _e247 = phi_405_;
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
                        phi_450_ = _e278[0];
                    } else {
                        phi_450_ = _e278[1];
                    }
                    let _e283 = phi_450_;
                    let _e284 = (_e248 == 2u);
                    if _e284 {
                        phi_456_ = _e278[2];
                    } else {
                        phi_456_ = _e283;
                    }
                    let _e287 = phi_456_;
                    let _e289 = ((_e287 * _e255) * _e261);
                    let _e290 = global_4.member[_e134].member_2;
                    if _e279 {
                        phi_467_ = _e290[0];
                    } else {
                        phi_467_ = _e290[1];
                    }
                    let _e294 = phi_467_;
                    if _e284 {
                        phi_473_ = _e290[2];
                    } else {
                        phi_473_ = _e294;
                    }
                    let _e297 = phi_473_;
                    let _e299 = ((_e297 * _e268) * _e274);
                    let _e303 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e303 {
                        let _e307 = (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) * 0.00000011920929f);
                        phi_496_ = select(0.00000000000011368684f, _e307, (_e307 > 0.00000000000011368684f));
                    } else {
                        phi_496_ = 0f;
                    }
                    let _e311 = phi_496_;
                    let _e312 = (_e289 + _e311);
                    let _e313 = (_e289 - _e311);
                    let _e314 = select(_e299, 0f, _e303);
                    if _e303 {
                        phi_507_ = 38685626000000000000000000f;
                    } else {
                        phi_507_ = (1f / _e299);
                    }
                    let _e317 = phi_507_;
                    let _e318 = (_e247 == 0u);
                    if _e318 {
                        phi_516_ = _e278[0];
                    } else {
                        phi_516_ = _e278[1];
                    }
                    let _e322 = phi_516_;
                    let _e323 = (_e247 == 2u);
                    if _e323 {
                        phi_522_ = _e278[2];
                    } else {
                        phi_522_ = _e322;
                    }
                    let _e326 = phi_522_;
                    let _e328 = ((_e326 * _e255) * _e261);
                    if _e318 {
                        phi_533_ = _e290[0];
                    } else {
                        phi_533_ = _e290[1];
                    }
                    let _e332 = phi_533_;
                    if _e323 {
                        phi_539_ = _e290[2];
                    } else {
                        phi_539_ = _e332;
                    }
                    let _e335 = phi_539_;
                    let _e337 = ((_e335 * _e268) * _e274);
                    let _e341 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e341 {
                        let _e345 = (bitcast<f32>((bitcast<u32>(_e328) & 2147483647u)) * 0.00000011920929f);
                        phi_562_ = select(0.00000000000011368684f, _e345, (_e345 > 0.00000000000011368684f));
                    } else {
                        phi_562_ = 0f;
                    }
                    let _e349 = phi_562_;
                    let _e350 = (_e328 + _e349);
                    let _e351 = (_e328 - _e349);
                    let _e352 = select(_e337, 0f, _e341);
                    if _e341 {
                        phi_573_ = 38685626000000000000000000f;
                    } else {
                        phi_573_ = (1f / _e337);
                    }
                    let _e355 = phi_573_;
                    let _e356 = (_e249 == 0u);
                    if _e356 {
                        phi_582_ = _e278[0];
                    } else {
                        phi_582_ = _e278[1];
                    }
                    let _e360 = phi_582_;
                    let _e361 = (_e249 == 2u);
                    if _e361 {
                        phi_588_ = _e278[2];
                    } else {
                        phi_588_ = _e360;
                    }
                    let _e364 = phi_588_;
                    let _e366 = ((_e364 * _e255) * _e261);
                    if _e356 {
                        phi_599_ = _e290[0];
                    } else {
                        phi_599_ = _e290[1];
                    }
                    let _e370 = phi_599_;
                    if _e361 {
                        phi_605_ = _e290[2];
                    } else {
                        phi_605_ = _e370;
                    }
                    let _e373 = phi_605_;
                    let _e375 = ((_e373 * _e268) * _e274);
                    let _e379 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e379 {
                        let _e383 = (bitcast<f32>((bitcast<u32>(_e366) & 2147483647u)) * 0.00000011920929f);
                        phi_628_ = select(0.00000000000011368684f, _e383, (_e383 > 0.00000000000011368684f));
                    } else {
                        phi_628_ = 0f;
                    }
                    let _e387 = phi_628_;
                    let _e388 = (_e366 + _e387);
                    let _e389 = (_e366 - _e387);
                    let _e390 = select(_e375, 0f, _e379);
                    if _e379 {
                        phi_639_ = 38685626000000000000000000f;
                    } else {
                        phi_639_ = (1f / _e375);
                    }
                    let _e393 = phi_639_;
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
                        phi_739_ = select(-340282350000000000000000000000000000000f, _e434, (_e434 > -340282350000000000000000000000000000000f));
                        phi_740_ = select(-340282350000000000000000000000000000000f, _e427, (_e427 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_739_ = 0f;
                        phi_740_ = 1f;
                    }
                    let _e438 = phi_739_;
                    let _e440 = phi_740_;
                    local_3 = array<type_48, 128>(type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e444 = (_e248 % 3u);
                    let _e445 = (_e444 < 3u);
                    if _e445 {
                    } else {
                        break;
                    }
                    let _e447 = local_1[_e444];
                    let _e450 = (_e247 % 3u);
                    let _e451 = (_e450 < 3u);
                    if _e451 {
                    } else {
                        break;
                    }
                    let _e453 = local_1[_e450];
                    let _e456 = (_e249 % 3u);
                    let _e457 = (_e456 < 3u);
                    if _e457 {
                    } else {
                        break;
                    }
                    let _e459 = local_1[_e456];
                    if _e445 {
                    } else {
                        break;
                    }
                    let _e464 = local[_e444];
                    if _e451 {
                    } else {
                        break;
                    }
                    let _e468 = local[_e450];
                    if _e457 {
                    } else {
                        break;
                    }
                    let _e472 = local[_e456];
                    phi_4242_ = false;
                    phi_1860_ = type_31(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e438);
                    phi_1863_ = type_48(type_28(vec4<f32>((f32(_e447) * _e128), (f32(_e453) * _e128), (f32(_e459) * _e128), 0f), vec4<f32>((f32(_e464) * _e128), (f32(_e468) * _e128), (f32(_e472) * _e128), 0f)), select(0u, 2147483648u, (_e78 == 0u)));
                    phi_1865_ = ((3u * _e78) + 1u);
                    phi_1867_ = (_e440 <= _e438);
                    phi_1869_ = 0u;
                    loop {
                        let _e482 = phi_4242_;
                        let _e484 = phi_1860_;
                        let _e486 = phi_1863_;
                        let _e488 = phi_1865_;
                        let _e490 = phi_1867_;
                        let _e492 = phi_1869_;
                        local_4 = _e484;
                        if _e490 {
                            phi_1880_ = true;
                        } else {
                            phi_1880_ = (_e492 > 0u);
                        }
                        let _e495 = phi_1880_;
                        if _e495 {
                            let _e496 = (_e488 > 0u);
                            if _e496 {
                                if _e490 {
                                    phi_1917_ = _e486;
                                    phi_1918_ = _e490;
                                    phi_1919_ = _e492;
                                } else {
                                    let _e497 = (_e492 - 1u);
                                    let _e498 = (_e497 % 128u);
                                    let _e499 = (_e498 < 128u);
                                    if _e499 {
                                    } else {
                                        phi_4346_ = true;
                                        break;
                                    }
                                    let _e501 = local_3[_e498];
                                    if _e499 {
                                    } else {
                                        phi_4346_ = true;
                                        break;
                                    }
                                    let _e509 = local_2[_e498];
                                    phi_1917_ = type_48(type_28(_e501.member.member, _e501.member.member_1), _e501.member_1);
                                    phi_1918_ = (_e509 <= _e484.member_1);
                                    phi_1919_ = _e497;
                                }
                                let _e513 = phi_1917_;
                                let _e515 = phi_1918_;
                                let _e517 = phi_1919_;
                                if _e515 {
                                    if ((_e513.member_1 & 2147483648u) != 0u) {
                                        phi_1937_ = _e484;
                                        phi_1940_ = type_4(0u, ((_e513.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e963 = phi_1937_;
                                            let _e965 = phi_1940_;
                                            local_5 = _e963;
                                            if (_e965.member < _e965.member_1) {
                                                phi_1941_ = type_4((_e965.member + 1u), _e965.member_1);
                                                phi_1963_ = type_4(1u, _e965.member);
                                            } else {
                                                phi_1941_ = _e965;
                                                phi_1963_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e978 = phi_1941_;
                                            let _e980 = phi_1963_;
                                            let _e984 = (bitcast<i32>(_e980.member) != 0i);
                                            if _e984 {
                                                let _e985 = ((_e513.member_1 & 268435455u) + _e980.member_1);
                                                let _e986 = (_e985 < _e80);
                                                if _e986 {
                                                    if _e986 {
                                                    } else {
                                                        phi_4236_ = true;
                                                        break;
                                                    }
                                                    let _e990 = global_2.member[_e985].member_1;
                                                    phi_1984_ = _e990;
                                                } else {
                                                    phi_1984_ = 4294967295u;
                                                }
                                                let _e992 = phi_1984_;
                                                if (_e985 >= _e80) {
                                                    phi_2073_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e986 {
                                                    } else {
                                                        phi_4236_ = true;
                                                        break;
                                                    }
                                                    if (_e444 < 9u) {
                                                    } else {
                                                        phi_4236_ = true;
                                                        break;
                                                    }
                                                    let _e999 = global_2.member[_e985].member[_e444];
                                                    if (_e450 < 9u) {
                                                    } else {
                                                        phi_4236_ = true;
                                                        break;
                                                    }
                                                    let _e1005 = global_2.member[_e985].member[_e450];
                                                    if (_e456 < 9u) {
                                                    } else {
                                                        phi_4236_ = true;
                                                        break;
                                                    }
                                                    let _e1011 = global_2.member[_e985].member[_e456];
                                                    let _e1013 = (3u + _e444);
                                                    if (_e1013 < 9u) {
                                                    } else {
                                                        phi_4236_ = true;
                                                        break;
                                                    }
                                                    let _e1019 = global_2.member[_e985].member[_e1013];
                                                    let _e1020 = (3u + _e450);
                                                    if (_e1020 < 9u) {
                                                    } else {
                                                        phi_4236_ = true;
                                                        break;
                                                    }
                                                    let _e1026 = global_2.member[_e985].member[_e1020];
                                                    let _e1027 = (3u + _e456);
                                                    if (_e1027 < 9u) {
                                                    } else {
                                                        phi_4236_ = true;
                                                        break;
                                                    }
                                                    let _e1033 = global_2.member[_e985].member[_e1027];
                                                    let _e1035 = (6u + _e444);
                                                    if (_e1035 < 9u) {
                                                    } else {
                                                        phi_4236_ = true;
                                                        break;
                                                    }
                                                    let _e1041 = global_2.member[_e985].member[_e1035];
                                                    let _e1042 = (6u + _e450);
                                                    if (_e1042 < 9u) {
                                                    } else {
                                                        phi_4236_ = true;
                                                        break;
                                                    }
                                                    let _e1048 = global_2.member[_e985].member[_e1042];
                                                    let _e1049 = (6u + _e456);
                                                    if (_e1049 < 9u) {
                                                    } else {
                                                        phi_4236_ = true;
                                                        break;
                                                    }
                                                    let _e1055 = global_2.member[_e985].member[_e1049];
                                                    phi_2073_ = array<array<f32, 3>, 3>(array<f32, 3>(_e999, _e1005, _e1011), array<f32, 3>(_e1019, _e1026, _e1033), array<f32, 3>(_e1041, _e1048, _e1055));
                                                }
                                                let _e1059 = phi_2073_;
                                                let _e1067 = (_e1059[0][2] - _e366);
                                                let _e1070 = (((_e1059[0][0] - _e289) * _e390) - (_e1067 * _e314));
                                                let _e1073 = (((_e1059[0][1] - _e328) * _e390) - (_e1067 * _e352));
                                                let _e1080 = (_e1059[1][2] - _e366);
                                                let _e1083 = (((_e1059[1][0] - _e289) * _e390) - (_e1080 * _e314));
                                                let _e1086 = (((_e1059[1][1] - _e328) * _e390) - (_e1080 * _e352));
                                                let _e1093 = (_e1059[2][2] - _e366);
                                                let _e1096 = (((_e1059[2][0] - _e289) * _e390) - (_e1093 * _e314));
                                                let _e1099 = (((_e1059[2][1] - _e328) * _e390) - (_e1093 * _e352));
                                                let _e1100 = (_e1096 * _e1086);
                                                let _e1101 = (_e1099 * _e1083);
                                                let _e1102 = (_e1070 * _e1099);
                                                let _e1103 = (_e1073 * _e1096);
                                                let _e1104 = (_e1083 * _e1073);
                                                let _e1105 = (_e1086 * _e1070);
                                                let _e1110 = (((_e1100 >= _e1101) && (_e1102 >= _e1103)) && (_e1104 >= _e1105));
                                                if (_e1110 || (((_e1100 <= _e1101) && (_e1102 <= _e1103)) && (_e1104 <= _e1105))) {
                                                    let _e1117 = select(-1f, 1f, _e1110);
                                                    let _e1119 = ((_e1100 - _e1101) * _e1117);
                                                    let _e1121 = select(0f, _e1119, (_e1119 > 0f));
                                                    let _e1123 = ((_e1102 - _e1103) * _e1117);
                                                    let _e1125 = select(0f, _e1123, (_e1123 > 0f));
                                                    let _e1127 = ((_e1104 - _e1105) * _e1117);
                                                    let _e1129 = select(0f, _e1127, (_e1127 > 0f));
                                                    let _e1131 = ((_e1121 + _e1125) + _e1129);
                                                    if (_e1131 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2639_ = type_20();
                                                        phi_2640_ = true;
                                                    } else {
                                                        let _e1134 = select(_e1059[1][0], _e1059[0][0], (_e1059[0][0] < _e1059[1][0]));
                                                        let _e1138 = select(_e1059[1][0], _e1059[0][0], (_e1059[0][0] > _e1059[1][0]));
                                                        let _e1142 = select(_e1059[1][1], _e1059[0][1], (_e1059[0][1] < _e1059[1][1]));
                                                        let _e1146 = select(_e1059[1][1], _e1059[0][1], (_e1059[0][1] > _e1059[1][1]));
                                                        let _e1150 = select(_e1059[1][2], _e1059[0][2], (_e1059[0][2] < _e1059[1][2]));
                                                        let _e1154 = select(_e1059[1][2], _e1059[0][2], (_e1059[0][2] > _e1059[1][2]));
                                                        let _e1159 = ((select(_e1059[2][0], _e1134, (_e1134 < _e1059[2][0])) - _e312) * _e317);
                                                        let _e1160 = ((select(_e1059[2][0], _e1138, (_e1138 > _e1059[2][0])) - _e313) * _e317);
                                                        let _e1163 = ((select(_e1059[2][1], _e1142, (_e1142 < _e1059[2][1])) - _e350) * _e355);
                                                        let _e1164 = ((select(_e1059[2][1], _e1146, (_e1146 > _e1059[2][1])) - _e351) * _e355);
                                                        let _e1167 = ((select(_e1059[2][2], _e1150, (_e1150 < _e1059[2][2])) - _e388) * _e393);
                                                        let _e1168 = ((select(_e1059[2][2], _e1154, (_e1154 > _e1059[2][2])) - _e389) * _e393);
                                                        let _e1170 = select(_e1168, _e1167, (_e1167 < _e1168));
                                                        let _e1172 = select(_e1168, _e1167, (_e1167 > _e1168));
                                                        let _e1174 = select(_e1160, _e1159, (_e1159 < _e1160));
                                                        let _e1176 = select(_e1164, _e1163, (_e1163 < _e1164));
                                                        let _e1178 = select(_e1176, _e1174, (_e1174 > _e1176));
                                                        let _e1180 = select(_e1170, _e1178, (_e1178 > _e1170));
                                                        let _e1182 = select(_e1160, _e1159, (_e1159 > _e1160));
                                                        let _e1184 = select(_e1164, _e1163, (_e1163 > _e1164));
                                                        let _e1186 = select(_e1184, _e1182, (_e1182 < _e1184));
                                                        let _e1188 = select(_e1172, _e1186, (_e1186 < _e1172));
                                                        let _e1189 = -(_e1170);
                                                        let _e1195 = select(_e440, _e1180, (_e1180 > _e440));
                                                        if (_e1195 > (_e1188 + (select(_e1189, _e1172, (_e1172 > _e1189)) * 0.0000019073523f))) {
                                                            phi_2634_ = type_20();
                                                            phi_2635_ = true;
                                                        } else {
                                                            let _e1197 = (_e1195 > _e963.member_1);
                                                            if _e1197 {
                                                                phi_2633_ = type_20();
                                                            } else {
                                                                let _e1201 = (_e1059[1][0] - _e1059[0][0]);
                                                                let _e1202 = (_e1059[1][1] - _e1059[0][1]);
                                                                let _e1203 = (_e1059[1][2] - _e1059[0][2]);
                                                                let _e1204 = vec3<f32>(_e1201, _e1202, _e1203);
                                                                let _e1205 = (_e1059[2][0] - _e1059[1][0]);
                                                                let _e1206 = (_e1059[2][1] - _e1059[1][1]);
                                                                let _e1207 = (_e1059[2][2] - _e1059[1][2]);
                                                                let _e1208 = vec3<f32>(_e1205, _e1206, _e1207);
                                                                let _e1209 = (_e1059[0][0] - _e1059[2][0]);
                                                                let _e1210 = (_e1059[0][1] - _e1059[2][1]);
                                                                let _e1211 = (_e1059[0][2] - _e1059[2][2]);
                                                                let _e1212 = vec3<f32>(_e1209, _e1210, _e1211);
                                                                let _e1215 = bitcast<f32>((bitcast<u32>(_e1201) & 2147483647u));
                                                                let _e1218 = bitcast<f32>((bitcast<u32>(_e1202) & 2147483647u));
                                                                let _e1220 = select(_e1218, _e1215, (_e1215 > _e1218));
                                                                let _e1223 = bitcast<f32>((bitcast<u32>(_e1203) & 2147483647u));
                                                                let _e1225 = select(_e1223, _e1220, (_e1220 > _e1223));
                                                                let _e1228 = bitcast<f32>((bitcast<u32>(_e1205) & 2147483647u));
                                                                let _e1231 = bitcast<f32>((bitcast<u32>(_e1206) & 2147483647u));
                                                                let _e1233 = select(_e1231, _e1228, (_e1228 > _e1231));
                                                                let _e1236 = bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u));
                                                                let _e1238 = select(_e1236, _e1233, (_e1233 > _e1236));
                                                                let _e1241 = bitcast<f32>((bitcast<u32>(_e1209) & 2147483647u));
                                                                let _e1244 = bitcast<f32>((bitcast<u32>(_e1210) & 2147483647u));
                                                                let _e1246 = select(_e1244, _e1241, (_e1241 > _e1244));
                                                                let _e1249 = bitcast<f32>((bitcast<u32>(_e1211) & 2147483647u));
                                                                let _e1251 = select(_e1249, _e1246, (_e1246 > _e1249));
                                                                let _e1253 = select(_e1238, _e1225, (_e1225 > _e1238));
                                                                let _e1255 = select(_e1251, _e1253, (_e1253 > _e1251));
                                                                if (_e1225 == _e1255) {
                                                                    phi_2544_ = _e1208;
                                                                    phi_2545_ = _e1212;
                                                                } else {
                                                                    let _e1258 = vec3((_e1238 == _e1255));
                                                                    phi_2544_ = select(_e1204, _e1212, _e1258);
                                                                    phi_2545_ = select(_e1208, _e1204, _e1258);
                                                                }
                                                                let _e1262 = phi_2544_;
                                                                let _e1264 = phi_2545_;
                                                                let _e1271 = ((_e1262.y * _e1264.z) - (_e1264.y * _e1262.z));
                                                                let _e1276 = ((_e1262.z * _e1264.x) - (_e1264.z * _e1262.x));
                                                                let _e1279 = ((_e1262.x * _e1264.y) - (_e1264.x * _e1262.y));
                                                                if (_e1121 >= _e1125) {
                                                                    phi_2576_ = select(true, false, (_e1121 >= _e1129));
                                                                } else {
                                                                    phi_2576_ = true;
                                                                }
                                                                let _e1284 = phi_2576_;
                                                                if _e1284 {
                                                                    phi_2585_ = select(vec3<f32>(_e1059[2][0], _e1059[2][1], _e1059[2][2]), vec3<f32>(_e1059[1][0], _e1059[1][1], _e1059[1][2]), vec3((_e1125 >= _e1129)));
                                                                } else {
                                                                    phi_2585_ = vec3<f32>(_e1059[0][0], _e1059[0][1], _e1059[0][2]);
                                                                }
                                                                let _e1289 = phi_2585_;
                                                                let _e1306 = ((((_e1271 * (_e1289.x - _e289)) + (_e1276 * (_e1289.y - _e328))) + (_e1279 * (_e1289.z - _e366))) / (((_e1271 * _e314) + (_e1276 * _e352)) + (_e1279 * _e390)));
                                                                let _e1308 = select(_e1188, _e1306, (_e1306 < _e1188));
                                                                let _e1310 = select(_e1180, _e1308, (_e1308 > _e1180));
                                                                if (_e1310 >= _e440) {
                                                                    let _e1312 = (_e1310 <= _e963.member_1);
                                                                    if _e1312 {
                                                                        let _e1313 = (1f / _e1131);
                                                                        phi_2625_ = type_20(_e1310, (_e1125 * _e1313), (_e1129 * _e1313), _e992);
                                                                    } else {
                                                                        phi_2625_ = type_20();
                                                                    }
                                                                    let _e1318 = phi_2625_;
                                                                    phi_2627_ = _e1318;
                                                                    phi_2628_ = select(true, false, _e1312);
                                                                } else {
                                                                    phi_2627_ = type_20();
                                                                    phi_2628_ = true;
                                                                }
                                                                let _e1321 = phi_2627_;
                                                                let _e1323 = phi_2628_;
                                                                if _e1323 {
                                                                    phi_2632_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2632_ = _e1321;
                                                                }
                                                                let _e1325 = phi_2632_;
                                                                phi_2633_ = _e1325;
                                                            }
                                                            let _e1327 = phi_2633_;
                                                            phi_2634_ = _e1327;
                                                            phi_2635_ = _e1197;
                                                        }
                                                        let _e1329 = phi_2634_;
                                                        let _e1331 = phi_2635_;
                                                        phi_2639_ = _e1329;
                                                        phi_2640_ = _e1331;
                                                    }
                                                    let _e1333 = phi_2639_;
                                                    let _e1335 = phi_2640_;
                                                    phi_2644_ = _e1333;
                                                    phi_2645_ = _e1335;
                                                } else {
                                                    phi_2644_ = type_20();
                                                    phi_2645_ = true;
                                                }
                                                let _e1337 = phi_2644_;
                                                let _e1339 = phi_2645_;
                                                if _e1339 {
                                                    phi_2649_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2649_ = _e1337;
                                                }
                                                let _e1341 = phi_2649_;
                                                if (_e1341.member_3 != 4294967295u) {
                                                    if (_e992 != 4294967295u) {
                                                        if (_e1341.member < _e963.member.member) {
                                                            phi_2675_ = true;
                                                        } else {
                                                            if (_e1341.member == _e963.member.member) {
                                                                phi_2674_ = (_e1341.member_3 < _e963.member.member_3);
                                                            } else {
                                                                phi_2674_ = false;
                                                            }
                                                            let _e1354 = phi_2674_;
                                                            phi_2675_ = _e1354;
                                                        }
                                                        let _e1356 = phi_2675_;
                                                        if _e1356 {
                                                            phi_2681_ = type_31(_e1341, _e1341.member);
                                                        } else {
                                                            phi_2681_ = _e963;
                                                        }
                                                        let _e1359 = phi_2681_;
                                                        phi_2682_ = _e1359;
                                                    } else {
                                                        phi_2682_ = _e963;
                                                    }
                                                    let _e1361 = phi_2682_;
                                                    phi_2683_ = _e1361;
                                                } else {
                                                    phi_2683_ = _e963;
                                                }
                                                let _e1363 = phi_2683_;
                                                phi_1938_ = _e1363;
                                            } else {
                                                phi_1938_ = type_31();
                                            }
                                            let _e1365 = phi_1938_;
                                            continue;
                                            continuing {
                                                phi_1937_ = _e1365;
                                                phi_1940_ = _e978;
                                                phi_4236_ = _e482;
                                                break if !(_e984);
                                            }
                                        }
                                        let _e1368 = phi_4236_;
                                        phi_4346_ = _e1368;
                                        if _e1368 {
                                            break;
                                        }
                                        phi_4350_ = _e1368;
                                        let _e1541 = local_5;
                                        phi_3986_ = _e1541;
                                        phi_3987_ = _e513;
                                        phi_3988_ = false;
                                        phi_3989_ = _e517;
                                    } else {
                                        if (_e513.member_1 >= _e78) {
                                            phi_3586_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_48(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e513.member_1 < _e78) {
                                            } else {
                                                phi_4346_ = true;
                                                break;
                                            }
                                            let _e530 = ((1u + (_e248 * 2u)) % 7u);
                                            if (_e530 < 7u) {
                                            } else {
                                                phi_4346_ = true;
                                                break;
                                            }
                                            let _e535 = global_5.member[_e513.member_1][_e530];
                                            let _e538 = ((1u + (_e247 * 2u)) % 7u);
                                            if (_e538 < 7u) {
                                            } else {
                                                phi_4346_ = true;
                                                break;
                                            }
                                            let _e543 = global_5.member[_e513.member_1][_e538];
                                            let _e546 = ((1u + (_e249 * 2u)) % 7u);
                                            if (_e546 < 7u) {
                                            } else {
                                                phi_4346_ = true;
                                                break;
                                            }
                                            let _e551 = global_5.member[_e513.member_1][_e546];
                                            let _e554 = (((_e248 + 1u) * 2u) % 7u);
                                            if (_e554 < 7u) {
                                            } else {
                                                phi_4346_ = true;
                                                break;
                                            }
                                            let _e559 = global_5.member[_e513.member_1][_e554];
                                            let _e562 = (((_e247 + 1u) * 2u) % 7u);
                                            if (_e562 < 7u) {
                                            } else {
                                                phi_4346_ = true;
                                                break;
                                            }
                                            let _e567 = global_5.member[_e513.member_1][_e562];
                                            let _e570 = (((_e249 + 1u) * 2u) % 7u);
                                            if (_e570 < 7u) {
                                            } else {
                                                phi_4346_ = true;
                                                break;
                                            }
                                            let _e575 = global_5.member[_e513.member_1][_e570];
                                            let _e598 = (bitcast<f32>((bitcast<u32>((_e513.member.member_1.x - _e513.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e599 = (bitcast<f32>((bitcast<u32>((_e513.member.member_1.y - _e513.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e600 = (bitcast<f32>((bitcast<u32>((_e513.member.member_1.z - _e513.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e602 = select(_e128, _e598, (_e598 > _e128));
                                            let _e604 = select(_e128, _e599, (_e599 > _e128));
                                            let _e606 = select(_e128, _e600, (_e600 > _e128));
                                            let _e631 = bitcast<u32>((f32(bitcast<i32>((_e535 & 2097151u))) * _e602));
                                            let _e636 = (bitcast<i32>((_e535 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e639 = bitcast<f32>((_e631 & bitcast<u32>(_e636)));
                                            let _e640 = bitcast<u32>((f32(bitcast<i32>((_e543 & 2097151u))) * _e604));
                                            let _e645 = (bitcast<i32>((_e543 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e648 = bitcast<f32>((_e640 & bitcast<u32>(_e645)));
                                            let _e649 = bitcast<u32>((f32(bitcast<i32>((_e551 & 2097151u))) * _e606));
                                            let _e654 = (bitcast<i32>((_e551 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e657 = bitcast<f32>((_e649 & bitcast<u32>(_e654)));
                                            let _e661 = bitcast<f32>((_e631 & bitcast<u32>(~(_e636))));
                                            let _e665 = bitcast<f32>((_e640 & bitcast<u32>(~(_e645))));
                                            let _e669 = bitcast<f32>((_e649 & bitcast<u32>(~(_e654))));
                                            let _e670 = bitcast<u32>((f32(bitcast<i32>((_e559 & 2097151u))) * _e602));
                                            let _e675 = (bitcast<i32>((_e559 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e678 = bitcast<f32>((_e670 & bitcast<u32>(_e675)));
                                            let _e679 = bitcast<u32>((f32(bitcast<i32>((_e567 & 2097151u))) * _e604));
                                            let _e684 = (bitcast<i32>((_e567 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e687 = bitcast<f32>((_e679 & bitcast<u32>(_e684)));
                                            let _e688 = bitcast<u32>((f32(bitcast<i32>((_e575 & 2097151u))) * _e606));
                                            let _e693 = (bitcast<i32>((_e575 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e696 = bitcast<f32>((_e688 & bitcast<u32>(_e693)));
                                            let _e700 = bitcast<f32>((_e670 & bitcast<u32>(~(_e675))));
                                            let _e704 = bitcast<f32>((_e679 & bitcast<u32>(~(_e684))));
                                            let _e708 = bitcast<f32>((_e688 & bitcast<u32>(~(_e693))));
                                            let _e738 = global_5.member[_e513.member_1][0u];
                                            let _e742 = global_5.member[_e513.member_1][2u];
                                            let _e746 = global_5.member[_e513.member_1][4u];
                                            let _e750 = global_5.member[_e513.member_1][6u];
                                            let _e762 = (((_e742 >> bitcast<u32>(22i)) | ((_e746 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e750 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e763 = (_e738 & 268435455u);
                                            let _e764 = (_e762 & 268435455u);
                                            let _e767 = ((_e738 >> bitcast<u32>(28u)) & 7u);
                                            let _e775 = ((_e738 >> bitcast<u32>(31i)) | (((_e762 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e776 = (_e767 != 0u);
                                            if (_e767 == 0u) {
                                                phi_3548_ = _e763;
                                            } else {
                                                if (_e767 == 7u) {
                                                    phi_3547_ = 2147483648u;
                                                } else {
                                                    phi_3547_ = ((2147483648u | (_e767 << bitcast<u32>(28u))) | (_e764 & 268435455u));
                                                }
                                                let _e785 = phi_3547_;
                                                phi_3548_ = _e785;
                                            }
                                            let _e787 = phi_3548_;
                                            if _e776 {
                                                let _e788 = (_e767 != 7u);
                                                if _e788 {
                                                    phi_3558_ = (_e764 + _e767);
                                                } else {
                                                    phi_3558_ = u32();
                                                }
                                                let _e791 = phi_3558_;
                                                phi_3560_ = _e791;
                                                phi_3561_ = select(true, false, _e788);
                                            } else {
                                                phi_3560_ = u32();
                                                phi_3561_ = true;
                                            }
                                            let _e794 = phi_3560_;
                                            let _e796 = phi_3561_;
                                            if (_e775 == 0u) {
                                                phi_3582_ = (_e763 + select(0u, 1u, !(_e776)));
                                            } else {
                                                if (_e775 == 7u) {
                                                    phi_3581_ = 2147483648u;
                                                } else {
                                                    phi_3581_ = ((2147483648u | (_e775 << bitcast<u32>(28u))) | (select(_e794, _e764, _e796) & 268435455u));
                                                }
                                                let _e809 = phi_3581_;
                                                phi_3582_ = _e809;
                                            }
                                            let _e811 = phi_3582_;
                                            phi_3586_ = type_51(array<vec4<f32>, 3>(vec4<f32>((_e513.member.member.x + _e639), (_e513.member.member.x + _e661), (_e513.member.member_1.x - _e678), (_e513.member.member_1.x - _e700)), vec4<f32>((_e513.member.member.y + _e648), (_e513.member.member.y + _e665), (_e513.member.member_1.y - _e687), (_e513.member.member_1.y - _e704)), vec4<f32>((_e513.member.member.z + _e657), (_e513.member.member.z + _e669), (_e513.member.member_1.z - _e696), (_e513.member.member_1.z - _e708))), type_48(type_28((_e513.member.member + vec4<f32>(_e639, _e648, _e657, 0f)), (_e513.member.member_1 - vec4<f32>(_e678, _e687, _e696, 0f))), _e787), type_48(type_28((_e513.member.member + vec4<f32>(_e661, _e665, _e669, 0f)), (_e513.member.member_1 - vec4<f32>(_e700, _e704, _e708, 0f))), _e811));
                                        }
                                        let _e816 = phi_3586_;
                                        let _e828 = ((_e816.member[0].x - _e312) * _e317);
                                        let _e829 = ((_e816.member[0].y - _e312) * _e317);
                                        let _e830 = ((_e816.member[0].z - _e313) * _e317);
                                        let _e831 = ((_e816.member[0].w - _e313) * _e317);
                                        let _e841 = ((_e816.member[1].x - _e350) * _e355);
                                        let _e842 = ((_e816.member[1].y - _e350) * _e355);
                                        let _e843 = ((_e816.member[1].z - _e351) * _e355);
                                        let _e844 = ((_e816.member[1].w - _e351) * _e355);
                                        let _e854 = ((_e816.member[2].x - _e388) * _e393);
                                        let _e855 = ((_e816.member[2].y - _e388) * _e393);
                                        let _e856 = ((_e816.member[2].z - _e389) * _e393);
                                        let _e857 = ((_e816.member[2].w - _e389) * _e393);
                                        let _e859 = select(_e856, _e854, (_e854 < _e856));
                                        let _e861 = select(_e857, _e855, (_e855 < _e857));
                                        let _e863 = select(_e856, _e854, (_e854 > _e856));
                                        let _e865 = select(_e857, _e855, (_e855 > _e857));
                                        let _e867 = select(_e830, _e828, (_e828 < _e830));
                                        let _e869 = select(_e831, _e829, (_e829 < _e831));
                                        let _e871 = select(_e843, _e841, (_e841 < _e843));
                                        let _e873 = select(_e844, _e842, (_e842 < _e844));
                                        let _e875 = select(_e871, _e867, (_e867 > _e871));
                                        let _e877 = select(_e873, _e869, (_e869 > _e873));
                                        let _e879 = select(_e859, _e875, (_e875 > _e859));
                                        let _e881 = select(_e861, _e877, (_e877 > _e861));
                                        let _e883 = select(_e830, _e828, (_e828 > _e830));
                                        let _e885 = select(_e831, _e829, (_e829 > _e831));
                                        let _e887 = select(_e843, _e841, (_e841 > _e843));
                                        let _e889 = select(_e844, _e842, (_e842 > _e844));
                                        let _e891 = select(_e887, _e883, (_e883 < _e887));
                                        let _e893 = select(_e889, _e885, (_e885 < _e889));
                                        let _e898 = -(_e859);
                                        let _e899 = -(_e861);
                                        let _e906 = (select(_e863, _e891, (_e891 < _e863)) + (select(_e898, _e863, (_e863 > _e898)) * 0.0000019073523f));
                                        let _e907 = (select(_e865, _e893, (_e893 < _e865)) + (select(_e899, _e865, (_e865 > _e899)) * 0.0000019073523f));
                                        let _e909 = select(_e440, _e879, (_e879 > _e440));
                                        let _e911 = select(_e440, _e881, (_e881 > _e440));
                                        let _e916 = (_e909 <= select(_e484.member_1, _e906, (_e906 < _e484.member_1)));
                                        let _e917 = (_e911 <= select(_e484.member_1, _e907, (_e907 < _e484.member_1)));
                                        let _e918 = (_e909 <= _e911);
                                        if _e916 {
                                            if _e917 {
                                                if _e918 {
                                                    phi_3930_ = _e816.member_2;
                                                } else {
                                                    phi_3930_ = _e816.member_1;
                                                }
                                                let _e922 = phi_3930_;
                                                let _e923 = (_e517 % 128u);
                                                let _e924 = (_e923 < 128u);
                                                if _e924 {
                                                } else {
                                                    phi_4346_ = true;
                                                    break;
                                                }
                                                local_3[_e923] = type_48(type_28(_e922.member.member, _e922.member.member_1), _e922.member_1);
                                                if _e924 {
                                                } else {
                                                    phi_4346_ = true;
                                                    break;
                                                }
                                                local_2[_e923] = select(_e911, _e909, (_e909 > _e911));
                                                if _e918 {
                                                    phi_3963_ = _e816.member_1;
                                                } else {
                                                    phi_3963_ = _e816.member_2;
                                                }
                                                let _e939 = phi_3963_;
                                                phi_3964_ = _e939;
                                                phi_3965_ = (_e517 + 1u);
                                            } else {
                                                phi_3964_ = type_48();
                                                phi_3965_ = u32();
                                            }
                                            let _e941 = phi_3964_;
                                            let _e943 = phi_3965_;
                                            phi_3967_ = _e941;
                                            phi_3968_ = _e943;
                                            phi_3969_ = select(true, false, _e917);
                                        } else {
                                            phi_3967_ = type_48();
                                            phi_3968_ = u32();
                                            phi_3969_ = true;
                                        }
                                        let _e946 = phi_3967_;
                                        let _e948 = phi_3968_;
                                        let _e950 = phi_3969_;
                                        if _e950 {
                                            if _e916 {
                                                phi_3978_ = _e816.member_1;
                                            } else {
                                                phi_3978_ = _e816.member_2;
                                            }
                                            let _e954 = phi_3978_;
                                            phi_3983_ = _e954;
                                            phi_3984_ = select(_e917, true, _e916);
                                        } else {
                                            phi_3983_ = _e946;
                                            phi_3984_ = _e515;
                                        }
                                        let _e957 = phi_3983_;
                                        let _e959 = phi_3984_;
                                        phi_4350_ = _e482;
                                        phi_3986_ = _e484;
                                        phi_3987_ = _e957;
                                        phi_3988_ = _e959;
                                        phi_3989_ = select(_e948, _e517, _e950);
                                    }
                                    let _e1370 = phi_4350_;
                                    let _e1372 = phi_3986_;
                                    let _e1374 = phi_3987_;
                                    let _e1376 = phi_3988_;
                                    let _e1378 = phi_3989_;
                                    phi_4349_ = _e1370;
                                    phi_3990_ = _e1372;
                                    phi_3991_ = _e1374;
                                    phi_3992_ = (_e488 - 1u);
                                    phi_3993_ = _e1376;
                                    phi_3994_ = _e1378;
                                } else {
                                    phi_4349_ = _e482;
                                    phi_3990_ = _e484;
                                    phi_3991_ = _e513;
                                    phi_3992_ = _e488;
                                    phi_3993_ = _e515;
                                    phi_3994_ = _e517;
                                }
                                let _e1380 = phi_4349_;
                                let _e1382 = phi_3990_;
                                let _e1384 = phi_3991_;
                                let _e1386 = phi_3992_;
                                let _e1388 = phi_3993_;
                                let _e1390 = phi_3994_;
                                phi_4348_ = _e1380;
                                phi_3995_ = _e1382;
                                phi_3996_ = _e1384;
                                phi_3997_ = _e1386;
                                phi_3998_ = _e1388;
                                phi_3999_ = _e1390;
                            } else {
                                phi_4348_ = _e482;
                                phi_3995_ = type_31();
                                phi_3996_ = type_48();
                                phi_3997_ = u32();
                                phi_3998_ = bool();
                                phi_3999_ = u32();
                            }
                            let _e1392 = phi_4348_;
                            let _e1394 = phi_3995_;
                            let _e1396 = phi_3996_;
                            let _e1398 = phi_3997_;
                            let _e1400 = phi_3998_;
                            let _e1402 = phi_3999_;
                            phi_4347_ = _e1392;
                            phi_1861_ = _e1394;
                            phi_1864_ = _e1396;
                            phi_1866_ = _e1398;
                            phi_1868_ = _e1400;
                            phi_1870_ = _e1402;
                            phi_4000_ = _e496;
                        } else {
                            phi_4347_ = _e482;
                            phi_1861_ = type_31();
                            phi_1864_ = type_48();
                            phi_1866_ = u32();
                            phi_1868_ = bool();
                            phi_1870_ = u32();
                            phi_4000_ = false;
                        }
                        let _e1404 = phi_4347_;
                        let _e1406 = phi_1861_;
                        let _e1408 = phi_1864_;
                        let _e1410 = phi_1866_;
                        let _e1412 = phi_1868_;
                        let _e1414 = phi_1870_;
                        let _e1416 = phi_4000_;
                        continue;
                        continuing {
                            phi_4242_ = _e1404;
                            phi_1860_ = _e1406;
                            phi_1863_ = _e1408;
                            phi_1865_ = _e1410;
                            phi_1867_ = _e1412;
                            phi_1869_ = _e1414;
                            phi_4346_ = _e1404;
                            break if !(_e1416);
                        }
                    }
                    let _e1419 = phi_4346_;
                    if _e1419 {
                        break;
                    }
                    let _e1421 = local_4;
                    if (_e1421.member.member_3 != 4294967295u) {
                        let _e1426 = -(_e407);
                        let _e1427 = (_e1426 / 3i);
                        let _e1434 = bitcast<f32>((bitcast<u32>((_e1427 + 127i)) << bitcast<u32>(23i)));
                        let _e1442 = (((_e1421.member.member * _e1434) * _e1434) * bitcast<f32>((bitcast<u32>(((_e1426 - (2i * _e1427)) + 127i)) << bitcast<u32>(23i))));
                        let _e1444 = select(340282350000000000000000000000000000000f, _e1442, (_e1442 < 340282350000000000000000000000000000000f));
                        phi_4052_ = type_20(select(-340282350000000000000000000000000000000f, _e1444, (_e1444 > -340282350000000000000000000000000000000f)), _e1421.member.member_1, _e1421.member.member_2, _e1421.member.member_3);
                    } else {
                        phi_4052_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1451 = phi_4052_;
                    if _e136 {
                    } else {
                        break;
                    }
                    global_6.member[_e134] = _e1451;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
