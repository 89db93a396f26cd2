struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: array<array<u32, 4>>,
}

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_30 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_37 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_40 {
    member: type_25,
    member_1: f32,
}

struct type_44 {
    member: type_40,
    member_1: u32,
    member_2: u32,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: type_37,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

struct type_59 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_20;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_27;
@group(0) @binding(0) 
var<uniform> global_3: type_46;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(3) 
var<storage> global_5: type_32;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_59;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_51, 128>;
    var phi_392_: i32;
    var phi_393_: i32;
    var phi_403_: bool;
    var phi_413_: u32;
    var phi_414_: u32;
    var phi_416_: bool;
    var phi_421_: u32;
    var phi_454_: i32;
    var phi_472_: f32;
    var phi_478_: f32;
    var phi_489_: f32;
    var phi_495_: f32;
    var phi_518_: f32;
    var phi_529_: f32;
    var phi_538_: f32;
    var phi_544_: f32;
    var phi_555_: f32;
    var phi_561_: f32;
    var phi_584_: f32;
    var phi_595_: f32;
    var phi_604_: f32;
    var phi_610_: f32;
    var phi_621_: f32;
    var phi_627_: f32;
    var phi_650_: f32;
    var phi_661_: f32;
    var phi_761_: f32;
    var phi_762_: f32;
    var phi_4393_: bool;
    var phi_1891_: type_44;
    var phi_1894_: type_51;
    var phi_1896_: u32;
    var phi_1898_: bool;
    var phi_1900_: u32;
    var phi_1911_: bool;
    var phi_1948_: type_51;
    var phi_1949_: bool;
    var phi_1950_: u32;
    var phi_3585_: u32;
    var phi_3586_: u32;
    var phi_3596_: u32;
    var phi_3598_: u32;
    var phi_3599_: bool;
    var phi_3619_: u32;
    var phi_3620_: u32;
    var phi_3624_: type_54;
    var phi_3968_: type_51;
    var phi_4001_: type_51;
    var phi_4002_: type_51;
    var phi_4003_: u32;
    var phi_4005_: type_51;
    var phi_4006_: u32;
    var phi_4007_: bool;
    var phi_4016_: type_51;
    var phi_4021_: type_51;
    var phi_4022_: bool;
    var phi_1968_: type_44;
    var phi_1971_: type_7;
    var phi_1972_: type_7;
    var phi_1994_: type_7;
    var phi_2018_: u32;
    var phi_2107_: array<array<f32, 3>, 3>;
    var phi_2578_: vec3<f32>;
    var phi_2579_: vec3<f32>;
    var phi_2610_: bool;
    var phi_2619_: vec3<f32>;
    var phi_2659_: type_25;
    var phi_2661_: type_25;
    var phi_2662_: bool;
    var phi_2666_: type_25;
    var phi_2667_: type_25;
    var phi_2668_: type_25;
    var phi_2669_: bool;
    var phi_2673_: type_25;
    var phi_2674_: bool;
    var phi_2678_: type_25;
    var phi_2679_: bool;
    var phi_2683_: type_25;
    var phi_2708_: bool;
    var phi_2709_: bool;
    var phi_2716_: type_44;
    var phi_2717_: type_44;
    var phi_2718_: type_44;
    var phi_1969_: type_44;
    var phi_4387_: bool;
    var phi_4505_: bool;
    var phi_4024_: type_44;
    var phi_4025_: type_51;
    var phi_4026_: bool;
    var phi_4027_: u32;
    var phi_4504_: bool;
    var phi_4028_: type_44;
    var phi_4029_: type_51;
    var phi_4030_: u32;
    var phi_4031_: bool;
    var phi_4032_: u32;
    var phi_4503_: bool;
    var phi_4033_: type_44;
    var phi_4034_: type_51;
    var phi_4035_: u32;
    var phi_4036_: bool;
    var phi_4037_: u32;
    var phi_4502_: bool;
    var phi_1892_: type_44;
    var phi_1895_: type_51;
    var phi_1897_: u32;
    var phi_1899_: bool;
    var phi_1901_: u32;
    var phi_4038_: bool;
    var phi_4501_: bool;
    var local_4: type_44;
    var phi_4090_: type_25;
    var local_5: type_44;
    var local_6: type_44;

    switch bitcast<i32>(0u) {
        default: {
            let _e80 = global;
            let _e82 = arrayLength((&global_4.member));
            let _e84 = arrayLength((&global_1.member));
            let _e92 = arrayLength((&global_7.member));
            let _e96 = global_3.member[0u][0u];
            let _e100 = global_3.member[0u][1u];
            let _e104 = global_3.member[0u][2u];
            let _e108 = global_3.member[0u][3u];
            let _e112 = global_3.member[1u][0u];
            let _e116 = global_3.member[1u][1u];
            let _e120 = global_3.member[1u][2u];
            let _e124 = (_e80.x + (_e80.y * 2097152u));
            let _e136 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e108) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e96), bitcast<i32>(_e100), bitcast<i32>(_e104));
            local = array<i32, 3>(bitcast<i32>(_e112), bitcast<i32>(_e116), bitcast<i32>(_e120));
            let _e139 = (_e124 < arrayLength((&global_5.member)));
            if _e139 {
                let _e140 = (_e124 < arrayLength((&global_2.member)));
                if _e140 {
                    let _e141 = (_e124 < arrayLength((&global_6.member)));
                    if _e141 {
                        if _e139 {
                        } else {
                            break;
                        }
                        let _e151 = global_5.member[_e124].member.member_2[0u];
                        let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                        let _e159 = global_5.member[_e124].member.member_2[1u];
                        let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                        let _e167 = global_5.member[_e124].member.member_2[2u];
                        let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                        let _e175 = global_5.member[_e124].member.member[0u];
                        let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                        let _e183 = global_5.member[_e124].member.member[1u];
                        let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                        let _e191 = global_5.member[_e124].member.member[2u];
                        let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                        let _e195 = select(_e161, _e153, (_e161 < _e153));
                        let _e197 = select(_e169, _e195, (_e169 < _e195));
                        let _e199 = select(_e177, _e197, (_e177 < _e197));
                        let _e201 = select(_e185, _e199, (_e185 < _e199));
                        let _e203 = select(_e193, _e201, (_e193 < _e201));
                        let _e208 = global_5.member[_e124].member.member_1;
                        let _e210 = (bitcast<u32>(_e208) & 2147483647u);
                        let _e218 = global_5.member[_e124].member.member_3;
                        let _e224 = (((select(_e210, _e203, (_e210 < _e203)) < 2139095040u) && ((bitcast<u32>(_e218) & 2147483647u) <= 2139095040u)) && (_e197 > 0u));
                        if _e224 {
                            let _e227 = (bitcast<u32>(bitcast<f32>(_e197)) & 2147483647u);
                            if (_e227 >= 8388608u) {
                                phi_392_ = (bitcast<i32>((_e227 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_392_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e227)), 32u, (_e227 == 0u))));
                            }
                            let _e241 = phi_392_;
                            phi_393_ = _e241;
                        } else {
                            phi_393_ = 0i;
                        }
                        let _e243 = phi_393_;
                        let _e244 = (_e153 == _e197);
                        if _e244 {
                            phi_403_ = true;
                        } else {
                            phi_403_ = (_e161 == _e197);
                        }
                        let _e247 = phi_403_;
                        let _e248 = select(1u, 0u, _e244);
                        if _e247 {
                            let _e249 = (_e248 + 1u);
                            phi_413_ = _e249;
                            phi_414_ = _e249;
                            phi_416_ = select(true, false, (_e249 == 2u));
                        } else {
                            phi_413_ = u32();
                            phi_414_ = 0u;
                            phi_416_ = true;
                        }
                        let _e253 = phi_413_;
                        let _e255 = phi_414_;
                        let _e257 = phi_416_;
                        if _e257 {
                            phi_421_ = (_e255 + 1u);
                        } else {
                            phi_421_ = 0u;
                        }
                        let _e261 = phi_421_;
                        let _e262 = select(_e253, _e255, _e257);
                        let _e263 = select(_e248, select(2u, _e248, _e247), _e257);
                        let _e264 = -(_e243);
                        if (_e264 < -126i) {
                            phi_454_ = -126i;
                        } else {
                            phi_454_ = select(_e264, 127i, (_e264 > 127i));
                        }
                        let _e269 = phi_454_;
                        let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                        let _e280 = bitcast<f32>((bitcast<u32>(((_e264 - _e269) + 127i)) << bitcast<u32>(23i)));
                        let _e285 = global_5.member[_e124].member.member;
                        let _e286 = (_e262 == 0u);
                        if _e286 {
                            phi_472_ = _e285[0];
                        } else {
                            phi_472_ = _e285[1];
                        }
                        let _e290 = phi_472_;
                        let _e291 = (_e262 == 2u);
                        if _e291 {
                            phi_478_ = _e285[2];
                        } else {
                            phi_478_ = _e290;
                        }
                        let _e294 = phi_478_;
                        let _e295 = global_5.member[_e124].member.member_2;
                        if _e286 {
                            phi_489_ = _e295[0];
                        } else {
                            phi_489_ = _e295[1];
                        }
                        let _e299 = phi_489_;
                        if _e291 {
                            phi_495_ = _e295[2];
                        } else {
                            phi_495_ = _e299;
                        }
                        let _e302 = phi_495_;
                        let _e304 = ((_e302 * _e274) * _e280);
                        let _e308 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e308 {
                            let _e312 = (bitcast<f32>((bitcast<u32>(_e294) & 2147483647u)) * 0.00000011920929f);
                            phi_518_ = select(0.00000000000011368684f, _e312, (_e312 > 0.00000000000011368684f));
                        } else {
                            phi_518_ = 0f;
                        }
                        let _e316 = phi_518_;
                        let _e317 = (_e294 + _e316);
                        let _e318 = (_e294 - _e316);
                        let _e319 = select(_e304, 0f, _e308);
                        if _e308 {
                            phi_529_ = 38685626000000000000000000f;
                        } else {
                            phi_529_ = (1f / _e304);
                        }
                        let _e322 = phi_529_;
                        let _e323 = (_e261 == 0u);
                        if _e323 {
                            phi_538_ = _e285[0];
                        } else {
                            phi_538_ = _e285[1];
                        }
                        let _e327 = phi_538_;
                        let _e328 = (_e261 == 2u);
                        if _e328 {
                            phi_544_ = _e285[2];
                        } else {
                            phi_544_ = _e327;
                        }
                        let _e331 = phi_544_;
                        if _e323 {
                            phi_555_ = _e295[0];
                        } else {
                            phi_555_ = _e295[1];
                        }
                        let _e335 = phi_555_;
                        if _e328 {
                            phi_561_ = _e295[2];
                        } else {
                            phi_561_ = _e335;
                        }
                        let _e338 = phi_561_;
                        let _e340 = ((_e338 * _e274) * _e280);
                        let _e344 = (bitcast<f32>((bitcast<u32>(_e340) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e344 {
                            let _e348 = (bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)) * 0.00000011920929f);
                            phi_584_ = select(0.00000000000011368684f, _e348, (_e348 > 0.00000000000011368684f));
                        } else {
                            phi_584_ = 0f;
                        }
                        let _e352 = phi_584_;
                        let _e353 = (_e331 + _e352);
                        let _e354 = (_e331 - _e352);
                        let _e355 = select(_e340, 0f, _e344);
                        if _e344 {
                            phi_595_ = 38685626000000000000000000f;
                        } else {
                            phi_595_ = (1f / _e340);
                        }
                        let _e358 = phi_595_;
                        let _e359 = (_e263 == 0u);
                        if _e359 {
                            phi_604_ = _e285[0];
                        } else {
                            phi_604_ = _e285[1];
                        }
                        let _e363 = phi_604_;
                        let _e364 = (_e263 == 2u);
                        if _e364 {
                            phi_610_ = _e285[2];
                        } else {
                            phi_610_ = _e363;
                        }
                        let _e367 = phi_610_;
                        if _e359 {
                            phi_621_ = _e295[0];
                        } else {
                            phi_621_ = _e295[1];
                        }
                        let _e371 = phi_621_;
                        if _e364 {
                            phi_627_ = _e295[2];
                        } else {
                            phi_627_ = _e371;
                        }
                        let _e374 = phi_627_;
                        let _e376 = ((_e374 * _e274) * _e280);
                        let _e380 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e380 {
                            let _e384 = (bitcast<f32>((bitcast<u32>(_e367) & 2147483647u)) * 0.00000011920929f);
                            phi_650_ = select(0.00000000000011368684f, _e384, (_e384 > 0.00000000000011368684f));
                        } else {
                            phi_650_ = 0f;
                        }
                        let _e388 = phi_650_;
                        let _e389 = (_e367 + _e388);
                        let _e390 = (_e367 - _e388);
                        let _e391 = select(_e376, 0f, _e380);
                        if _e380 {
                            phi_661_ = 38685626000000000000000000f;
                        } else {
                            phi_661_ = (1f / _e376);
                        }
                        let _e394 = phi_661_;
                        let _e397 = bitcast<f32>((bitcast<u32>(_e294) & 2147483647u));
                        let _e400 = bitcast<f32>((bitcast<u32>(_e331) & 2147483647u));
                        let _e402 = select(_e400, _e397, (_e397 > _e400));
                        let _e405 = bitcast<f32>((bitcast<u32>(_e367) & 2147483647u));
                        if (_e224 && (select(_e405, _e402, (_e402 > _e405)) <= 1099511600000f)) {
                            let _e410 = (_e243 / 3i);
                            let _e417 = bitcast<f32>((bitcast<u32>((_e410 + 127i)) << bitcast<u32>(23i)));
                            let _e424 = bitcast<f32>((bitcast<u32>(((_e243 - (2i * _e410)) + 127i)) << bitcast<u32>(23i)));
                            let _e425 = (((_e208 * _e417) * _e417) * _e424);
                            let _e427 = select(340282350000000000000000000000000000000f, _e425, (_e425 < 340282350000000000000000000000000000000f));
                            let _e432 = (((_e218 * _e417) * _e417) * _e424);
                            let _e434 = select(340282350000000000000000000000000000000f, _e432, (_e432 < 340282350000000000000000000000000000000f));
                            phi_761_ = select(-340282350000000000000000000000000000000f, _e434, (_e434 > -340282350000000000000000000000000000000f));
                            phi_762_ = select(-340282350000000000000000000000000000000f, _e427, (_e427 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_761_ = 0f;
                            phi_762_ = 1f;
                        }
                        let _e438 = phi_761_;
                        let _e440 = phi_762_;
                        if _e139 {
                        } else {
                            break;
                        }
                        let _e446 = global_5.member[_e124].member_2;
                        local_3 = array<type_51, 128>(type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e449 = (_e262 % 3u);
                        let _e450 = (_e449 < 3u);
                        if _e450 {
                        } else {
                            break;
                        }
                        let _e452 = local_1[_e449];
                        let _e455 = (_e261 % 3u);
                        let _e456 = (_e455 < 3u);
                        if _e456 {
                        } else {
                            break;
                        }
                        let _e458 = local_1[_e455];
                        let _e461 = (_e263 % 3u);
                        let _e462 = (_e461 < 3u);
                        if _e462 {
                        } else {
                            break;
                        }
                        let _e464 = local_1[_e461];
                        if _e450 {
                        } else {
                            break;
                        }
                        let _e469 = local[_e449];
                        if _e456 {
                        } else {
                            break;
                        }
                        let _e473 = local[_e455];
                        if _e462 {
                        } else {
                            break;
                        }
                        let _e477 = local[_e461];
                        phi_4393_ = false;
                        phi_1891_ = type_44(type_40(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e438), 0u, 0u);
                        phi_1894_ = type_51(type_37(vec4<f32>((f32(_e452) * _e136), (f32(_e458) * _e136), (f32(_e464) * _e136), 0f), vec4<f32>((f32(_e469) * _e136), (f32(_e473) * _e136), (f32(_e477) * _e136), 0f)), select(0u, 2147483648u, (_e82 == 0u)));
                        phi_1896_ = ((3u * _e82) + 1u);
                        phi_1898_ = (_e440 <= _e438);
                        phi_1900_ = 0u;
                        loop {
                            let _e487 = phi_4393_;
                            let _e489 = phi_1891_;
                            let _e491 = phi_1894_;
                            let _e493 = phi_1896_;
                            let _e495 = phi_1898_;
                            let _e497 = phi_1900_;
                            local_4 = _e489;
                            local_5 = _e489;
                            if _e495 {
                                phi_1911_ = true;
                            } else {
                                phi_1911_ = (_e497 > 0u);
                            }
                            let _e500 = phi_1911_;
                            if _e500 {
                                let _e501 = (_e493 > 0u);
                                if _e501 {
                                    if _e495 {
                                        phi_1948_ = _e491;
                                        phi_1949_ = _e495;
                                        phi_1950_ = _e497;
                                    } else {
                                        let _e502 = (_e497 - 1u);
                                        let _e503 = (_e502 % 128u);
                                        let _e504 = (_e503 < 128u);
                                        if _e504 {
                                        } else {
                                            phi_4501_ = true;
                                            break;
                                        }
                                        let _e506 = local_3[_e503];
                                        if _e504 {
                                        } else {
                                            phi_4501_ = true;
                                            break;
                                        }
                                        let _e514 = local_2[_e503];
                                        phi_1948_ = type_51(type_37(_e506.member.member, _e506.member.member_1), _e506.member_1);
                                        phi_1949_ = (_e514 <= _e489.member.member_1);
                                        phi_1950_ = _e502;
                                    }
                                    let _e519 = phi_1948_;
                                    let _e521 = phi_1949_;
                                    let _e523 = phi_1950_;
                                    if _e521 {
                                        if ((_e519.member_1 & 2147483648u) != 0u) {
                                            phi_1968_ = _e489;
                                            phi_1971_ = type_7(0u, ((_e519.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e976 = phi_1968_;
                                                let _e978 = phi_1971_;
                                                local_6 = _e976;
                                                if (_e978.member < _e978.member_1) {
                                                    phi_1972_ = type_7((_e978.member + 1u), _e978.member_1);
                                                    phi_1994_ = type_7(1u, _e978.member);
                                                } else {
                                                    phi_1972_ = _e978;
                                                    phi_1994_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e991 = phi_1972_;
                                                let _e993 = phi_1994_;
                                                let _e997 = (bitcast<i32>(_e993.member) != 0i);
                                                if _e997 {
                                                    let _e1003 = type_44(_e976.member, _e976.member_1, (_e976.member_2 + 1u));
                                                    let _e1004 = ((_e519.member_1 & 268435455u) + _e993.member_1);
                                                    let _e1005 = (_e1004 < _e84);
                                                    if _e1005 {
                                                        if _e1005 {
                                                        } else {
                                                            phi_4387_ = true;
                                                            break;
                                                        }
                                                        let _e1009 = global_1.member[_e1004].member_1;
                                                        phi_2018_ = _e1009;
                                                    } else {
                                                        phi_2018_ = 4294967295u;
                                                    }
                                                    let _e1011 = phi_2018_;
                                                    if (_e1004 >= _e84) {
                                                        phi_2107_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1005 {
                                                        } else {
                                                            phi_4387_ = true;
                                                            break;
                                                        }
                                                        if (_e449 < 9u) {
                                                        } else {
                                                            phi_4387_ = true;
                                                            break;
                                                        }
                                                        let _e1018 = global_1.member[_e1004].member[_e449];
                                                        if (_e455 < 9u) {
                                                        } else {
                                                            phi_4387_ = true;
                                                            break;
                                                        }
                                                        let _e1024 = global_1.member[_e1004].member[_e455];
                                                        if (_e461 < 9u) {
                                                        } else {
                                                            phi_4387_ = true;
                                                            break;
                                                        }
                                                        let _e1030 = global_1.member[_e1004].member[_e461];
                                                        let _e1032 = (3u + _e449);
                                                        if (_e1032 < 9u) {
                                                        } else {
                                                            phi_4387_ = true;
                                                            break;
                                                        }
                                                        let _e1038 = global_1.member[_e1004].member[_e1032];
                                                        let _e1039 = (3u + _e455);
                                                        if (_e1039 < 9u) {
                                                        } else {
                                                            phi_4387_ = true;
                                                            break;
                                                        }
                                                        let _e1045 = global_1.member[_e1004].member[_e1039];
                                                        let _e1046 = (3u + _e461);
                                                        if (_e1046 < 9u) {
                                                        } else {
                                                            phi_4387_ = true;
                                                            break;
                                                        }
                                                        let _e1052 = global_1.member[_e1004].member[_e1046];
                                                        let _e1054 = (6u + _e449);
                                                        if (_e1054 < 9u) {
                                                        } else {
                                                            phi_4387_ = true;
                                                            break;
                                                        }
                                                        let _e1060 = global_1.member[_e1004].member[_e1054];
                                                        let _e1061 = (6u + _e455);
                                                        if (_e1061 < 9u) {
                                                        } else {
                                                            phi_4387_ = true;
                                                            break;
                                                        }
                                                        let _e1067 = global_1.member[_e1004].member[_e1061];
                                                        let _e1068 = (6u + _e461);
                                                        if (_e1068 < 9u) {
                                                        } else {
                                                            phi_4387_ = true;
                                                            break;
                                                        }
                                                        let _e1074 = global_1.member[_e1004].member[_e1068];
                                                        phi_2107_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1018, _e1024, _e1030), array<f32, 3>(_e1038, _e1045, _e1052), array<f32, 3>(_e1060, _e1067, _e1074));
                                                    }
                                                    let _e1078 = phi_2107_;
                                                    let _e1087 = (_e1078[0][2] - _e367);
                                                    let _e1090 = (((_e1078[0][0] - _e294) * _e391) - (_e1087 * _e319));
                                                    let _e1093 = (((_e1078[0][1] - _e331) * _e391) - (_e1087 * _e355));
                                                    let _e1100 = (_e1078[1][2] - _e367);
                                                    let _e1103 = (((_e1078[1][0] - _e294) * _e391) - (_e1100 * _e319));
                                                    let _e1106 = (((_e1078[1][1] - _e331) * _e391) - (_e1100 * _e355));
                                                    let _e1113 = (_e1078[2][2] - _e367);
                                                    let _e1116 = (((_e1078[2][0] - _e294) * _e391) - (_e1113 * _e319));
                                                    let _e1119 = (((_e1078[2][1] - _e331) * _e391) - (_e1113 * _e355));
                                                    let _e1120 = (_e1116 * _e1106);
                                                    let _e1121 = (_e1119 * _e1103);
                                                    let _e1122 = (_e1090 * _e1119);
                                                    let _e1123 = (_e1093 * _e1116);
                                                    let _e1124 = (_e1103 * _e1093);
                                                    let _e1125 = (_e1106 * _e1090);
                                                    let _e1130 = (((_e1120 >= _e1121) && (_e1122 >= _e1123)) && (_e1124 >= _e1125));
                                                    if (_e1130 || (((_e1120 <= _e1121) && (_e1122 <= _e1123)) && (_e1124 <= _e1125))) {
                                                        let _e1137 = select(-1f, 1f, _e1130);
                                                        let _e1139 = ((_e1120 - _e1121) * _e1137);
                                                        let _e1141 = select(0f, _e1139, (_e1139 > 0f));
                                                        let _e1143 = ((_e1122 - _e1123) * _e1137);
                                                        let _e1145 = select(0f, _e1143, (_e1143 > 0f));
                                                        let _e1147 = ((_e1124 - _e1125) * _e1137);
                                                        let _e1149 = select(0f, _e1147, (_e1147 > 0f));
                                                        let _e1151 = ((_e1141 + _e1145) + _e1149);
                                                        if (_e1151 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2673_ = type_25();
                                                            phi_2674_ = true;
                                                        } else {
                                                            let _e1154 = select(_e1078[1][0], _e1078[0][0], (_e1078[0][0] < _e1078[1][0]));
                                                            let _e1158 = select(_e1078[1][0], _e1078[0][0], (_e1078[0][0] > _e1078[1][0]));
                                                            let _e1162 = select(_e1078[1][1], _e1078[0][1], (_e1078[0][1] < _e1078[1][1]));
                                                            let _e1166 = select(_e1078[1][1], _e1078[0][1], (_e1078[0][1] > _e1078[1][1]));
                                                            let _e1170 = select(_e1078[1][2], _e1078[0][2], (_e1078[0][2] < _e1078[1][2]));
                                                            let _e1174 = select(_e1078[1][2], _e1078[0][2], (_e1078[0][2] > _e1078[1][2]));
                                                            let _e1179 = ((select(_e1078[2][0], _e1154, (_e1154 < _e1078[2][0])) - _e317) * _e322);
                                                            let _e1180 = ((select(_e1078[2][0], _e1158, (_e1158 > _e1078[2][0])) - _e318) * _e322);
                                                            let _e1183 = ((select(_e1078[2][1], _e1162, (_e1162 < _e1078[2][1])) - _e353) * _e358);
                                                            let _e1184 = ((select(_e1078[2][1], _e1166, (_e1166 > _e1078[2][1])) - _e354) * _e358);
                                                            let _e1187 = ((select(_e1078[2][2], _e1170, (_e1170 < _e1078[2][2])) - _e389) * _e394);
                                                            let _e1188 = ((select(_e1078[2][2], _e1174, (_e1174 > _e1078[2][2])) - _e390) * _e394);
                                                            let _e1190 = select(_e1188, _e1187, (_e1187 < _e1188));
                                                            let _e1192 = select(_e1188, _e1187, (_e1187 > _e1188));
                                                            let _e1194 = select(_e1180, _e1179, (_e1179 < _e1180));
                                                            let _e1196 = select(_e1184, _e1183, (_e1183 < _e1184));
                                                            let _e1198 = select(_e1196, _e1194, (_e1194 > _e1196));
                                                            let _e1200 = select(_e1190, _e1198, (_e1198 > _e1190));
                                                            let _e1202 = select(_e1180, _e1179, (_e1179 > _e1180));
                                                            let _e1204 = select(_e1184, _e1183, (_e1183 > _e1184));
                                                            let _e1206 = select(_e1204, _e1202, (_e1202 < _e1204));
                                                            let _e1208 = select(_e1192, _e1206, (_e1206 < _e1192));
                                                            let _e1209 = -(_e1190);
                                                            let _e1215 = select(_e440, _e1200, (_e1200 > _e440));
                                                            if (_e1215 > (_e1208 + (select(_e1209, _e1192, (_e1192 > _e1209)) * 0.0000019073523f))) {
                                                                phi_2668_ = type_25();
                                                                phi_2669_ = true;
                                                            } else {
                                                                let _e1217 = (_e1215 > _e976.member.member_1);
                                                                if _e1217 {
                                                                    phi_2667_ = type_25();
                                                                } else {
                                                                    let _e1221 = (_e1078[1][0] - _e1078[0][0]);
                                                                    let _e1222 = (_e1078[1][1] - _e1078[0][1]);
                                                                    let _e1223 = (_e1078[1][2] - _e1078[0][2]);
                                                                    let _e1224 = vec3<f32>(_e1221, _e1222, _e1223);
                                                                    let _e1225 = (_e1078[2][0] - _e1078[1][0]);
                                                                    let _e1226 = (_e1078[2][1] - _e1078[1][1]);
                                                                    let _e1227 = (_e1078[2][2] - _e1078[1][2]);
                                                                    let _e1228 = vec3<f32>(_e1225, _e1226, _e1227);
                                                                    let _e1229 = (_e1078[0][0] - _e1078[2][0]);
                                                                    let _e1230 = (_e1078[0][1] - _e1078[2][1]);
                                                                    let _e1231 = (_e1078[0][2] - _e1078[2][2]);
                                                                    let _e1232 = vec3<f32>(_e1229, _e1230, _e1231);
                                                                    let _e1235 = bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u));
                                                                    let _e1238 = bitcast<f32>((bitcast<u32>(_e1222) & 2147483647u));
                                                                    let _e1240 = select(_e1238, _e1235, (_e1235 > _e1238));
                                                                    let _e1243 = bitcast<f32>((bitcast<u32>(_e1223) & 2147483647u));
                                                                    let _e1245 = select(_e1243, _e1240, (_e1240 > _e1243));
                                                                    let _e1248 = bitcast<f32>((bitcast<u32>(_e1225) & 2147483647u));
                                                                    let _e1251 = bitcast<f32>((bitcast<u32>(_e1226) & 2147483647u));
                                                                    let _e1253 = select(_e1251, _e1248, (_e1248 > _e1251));
                                                                    let _e1256 = bitcast<f32>((bitcast<u32>(_e1227) & 2147483647u));
                                                                    let _e1258 = select(_e1256, _e1253, (_e1253 > _e1256));
                                                                    let _e1261 = bitcast<f32>((bitcast<u32>(_e1229) & 2147483647u));
                                                                    let _e1264 = bitcast<f32>((bitcast<u32>(_e1230) & 2147483647u));
                                                                    let _e1266 = select(_e1264, _e1261, (_e1261 > _e1264));
                                                                    let _e1269 = bitcast<f32>((bitcast<u32>(_e1231) & 2147483647u));
                                                                    let _e1271 = select(_e1269, _e1266, (_e1266 > _e1269));
                                                                    let _e1273 = select(_e1258, _e1245, (_e1245 > _e1258));
                                                                    let _e1275 = select(_e1271, _e1273, (_e1273 > _e1271));
                                                                    if (_e1245 == _e1275) {
                                                                        phi_2578_ = _e1228;
                                                                        phi_2579_ = _e1232;
                                                                    } else {
                                                                        let _e1278 = vec3((_e1258 == _e1275));
                                                                        phi_2578_ = select(_e1224, _e1232, _e1278);
                                                                        phi_2579_ = select(_e1228, _e1224, _e1278);
                                                                    }
                                                                    let _e1282 = phi_2578_;
                                                                    let _e1284 = phi_2579_;
                                                                    let _e1291 = ((_e1282.y * _e1284.z) - (_e1284.y * _e1282.z));
                                                                    let _e1296 = ((_e1282.z * _e1284.x) - (_e1284.z * _e1282.x));
                                                                    let _e1299 = ((_e1282.x * _e1284.y) - (_e1284.x * _e1282.y));
                                                                    if (_e1141 >= _e1145) {
                                                                        phi_2610_ = select(true, false, (_e1141 >= _e1149));
                                                                    } else {
                                                                        phi_2610_ = true;
                                                                    }
                                                                    let _e1304 = phi_2610_;
                                                                    if _e1304 {
                                                                        phi_2619_ = select(vec3<f32>(_e1078[2][0], _e1078[2][1], _e1078[2][2]), vec3<f32>(_e1078[1][0], _e1078[1][1], _e1078[1][2]), vec3((_e1145 >= _e1149)));
                                                                    } else {
                                                                        phi_2619_ = vec3<f32>(_e1078[0][0], _e1078[0][1], _e1078[0][2]);
                                                                    }
                                                                    let _e1309 = phi_2619_;
                                                                    let _e1326 = ((((_e1291 * (_e1309.x - _e294)) + (_e1296 * (_e1309.y - _e331))) + (_e1299 * (_e1309.z - _e367))) / (((_e1291 * _e319) + (_e1296 * _e355)) + (_e1299 * _e391)));
                                                                    let _e1328 = select(_e1208, _e1326, (_e1326 < _e1208));
                                                                    let _e1330 = select(_e1200, _e1328, (_e1328 > _e1200));
                                                                    if (_e1330 >= _e440) {
                                                                        let _e1332 = (_e1330 <= _e976.member.member_1);
                                                                        if _e1332 {
                                                                            let _e1333 = (1f / _e1151);
                                                                            phi_2659_ = type_25(_e1330, (_e1145 * _e1333), (_e1149 * _e1333), _e1011);
                                                                        } else {
                                                                            phi_2659_ = type_25();
                                                                        }
                                                                        let _e1338 = phi_2659_;
                                                                        phi_2661_ = _e1338;
                                                                        phi_2662_ = select(true, false, _e1332);
                                                                    } else {
                                                                        phi_2661_ = type_25();
                                                                        phi_2662_ = true;
                                                                    }
                                                                    let _e1341 = phi_2661_;
                                                                    let _e1343 = phi_2662_;
                                                                    if _e1343 {
                                                                        phi_2666_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2666_ = _e1341;
                                                                    }
                                                                    let _e1345 = phi_2666_;
                                                                    phi_2667_ = _e1345;
                                                                }
                                                                let _e1347 = phi_2667_;
                                                                phi_2668_ = _e1347;
                                                                phi_2669_ = _e1217;
                                                            }
                                                            let _e1349 = phi_2668_;
                                                            let _e1351 = phi_2669_;
                                                            phi_2673_ = _e1349;
                                                            phi_2674_ = _e1351;
                                                        }
                                                        let _e1353 = phi_2673_;
                                                        let _e1355 = phi_2674_;
                                                        phi_2678_ = _e1353;
                                                        phi_2679_ = _e1355;
                                                    } else {
                                                        phi_2678_ = type_25();
                                                        phi_2679_ = true;
                                                    }
                                                    let _e1357 = phi_2678_;
                                                    let _e1359 = phi_2679_;
                                                    if _e1359 {
                                                        phi_2683_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2683_ = _e1357;
                                                    }
                                                    let _e1361 = phi_2683_;
                                                    if (_e1361.member_3 != 4294967295u) {
                                                        if (_e1011 != _e446) {
                                                            if (_e1361.member < _e976.member.member.member) {
                                                                phi_2709_ = true;
                                                            } else {
                                                                if (_e1361.member == _e976.member.member.member) {
                                                                    phi_2708_ = (_e1361.member_3 < _e976.member.member.member_3);
                                                                } else {
                                                                    phi_2708_ = false;
                                                                }
                                                                let _e1376 = phi_2708_;
                                                                phi_2709_ = _e1376;
                                                            }
                                                            let _e1378 = phi_2709_;
                                                            if _e1378 {
                                                                phi_2716_ = type_44(type_40(_e1361, _e1361.member), _e1003.member_1, _e1003.member_2);
                                                            } else {
                                                                phi_2716_ = _e1003;
                                                            }
                                                            let _e1385 = phi_2716_;
                                                            phi_2717_ = _e1385;
                                                        } else {
                                                            phi_2717_ = _e1003;
                                                        }
                                                        let _e1387 = phi_2717_;
                                                        phi_2718_ = _e1387;
                                                    } else {
                                                        phi_2718_ = _e1003;
                                                    }
                                                    let _e1389 = phi_2718_;
                                                    phi_1969_ = _e1389;
                                                } else {
                                                    phi_1969_ = type_44();
                                                }
                                                let _e1391 = phi_1969_;
                                                continue;
                                                continuing {
                                                    phi_1968_ = _e1391;
                                                    phi_1971_ = _e991;
                                                    phi_4387_ = _e487;
                                                    break if !(_e997);
                                                }
                                            }
                                            let _e1394 = phi_4387_;
                                            phi_4501_ = _e1394;
                                            if _e1394 {
                                                break;
                                            }
                                            phi_4505_ = _e1394;
                                            let _e1611 = local_6;
                                            phi_4024_ = _e1611;
                                            phi_4025_ = _e519;
                                            phi_4026_ = false;
                                            phi_4027_ = _e523;
                                        } else {
                                            if (_e519.member_1 >= _e82) {
                                                phi_3624_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e519.member_1 < _e82) {
                                                } else {
                                                    phi_4501_ = true;
                                                    break;
                                                }
                                                let _e541 = ((1u + _e262) % 4u);
                                                if (_e541 < 4u) {
                                                } else {
                                                    phi_4501_ = true;
                                                    break;
                                                }
                                                let _e546 = global_4.member[_e519.member_1][_e541];
                                                let _e548 = ((1u + _e261) % 4u);
                                                if (_e548 < 4u) {
                                                } else {
                                                    phi_4501_ = true;
                                                    break;
                                                }
                                                let _e553 = global_4.member[_e519.member_1][_e548];
                                                let _e555 = ((1u + _e263) % 4u);
                                                if (_e555 < 4u) {
                                                } else {
                                                    phi_4501_ = true;
                                                    break;
                                                }
                                                let _e560 = global_4.member[_e519.member_1][_e555];
                                                let _e562 = ((_e262 + 1u) % 4u);
                                                if (_e562 < 4u) {
                                                } else {
                                                    phi_4501_ = true;
                                                    break;
                                                }
                                                let _e567 = global_4.member[_e519.member_1][_e562];
                                                let _e569 = (_e567 >> bitcast<u32>(11u));
                                                let _e571 = ((_e261 + 1u) % 4u);
                                                if (_e571 < 4u) {
                                                } else {
                                                    phi_4501_ = true;
                                                    break;
                                                }
                                                let _e576 = global_4.member[_e519.member_1][_e571];
                                                let _e578 = (_e576 >> bitcast<u32>(11u));
                                                let _e580 = ((_e263 + 1u) % 4u);
                                                if (_e580 < 4u) {
                                                } else {
                                                    phi_4501_ = true;
                                                    break;
                                                }
                                                let _e585 = global_4.member[_e519.member_1][_e580];
                                                let _e587 = (_e585 >> bitcast<u32>(11u));
                                                let _e610 = (bitcast<f32>((bitcast<u32>((_e519.member.member_1.x - _e519.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e611 = (bitcast<f32>((bitcast<u32>((_e519.member.member_1.y - _e519.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e612 = (bitcast<f32>((bitcast<u32>((_e519.member.member_1.z - _e519.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e614 = select(_e136, _e610, (_e610 > _e136));
                                                let _e616 = select(_e136, _e611, (_e611 > _e136));
                                                let _e618 = select(_e136, _e612, (_e612 > _e136));
                                                let _e643 = bitcast<u32>((f32(bitcast<i32>((_e546 & 1023u))) * _e614));
                                                let _e648 = (bitcast<i32>((_e546 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e651 = bitcast<f32>((_e643 & bitcast<u32>(_e648)));
                                                let _e652 = bitcast<u32>((f32(bitcast<i32>((_e553 & 1023u))) * _e616));
                                                let _e657 = (bitcast<i32>((_e553 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e660 = bitcast<f32>((_e652 & bitcast<u32>(_e657)));
                                                let _e661 = bitcast<u32>((f32(bitcast<i32>((_e560 & 1023u))) * _e618));
                                                let _e666 = (bitcast<i32>((_e560 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e669 = bitcast<f32>((_e661 & bitcast<u32>(_e666)));
                                                let _e673 = bitcast<f32>((_e643 & bitcast<u32>(~(_e648))));
                                                let _e677 = bitcast<f32>((_e652 & bitcast<u32>(~(_e657))));
                                                let _e681 = bitcast<f32>((_e661 & bitcast<u32>(~(_e666))));
                                                let _e682 = bitcast<u32>((f32(bitcast<i32>((_e569 & 1023u))) * _e614));
                                                let _e687 = (bitcast<i32>((_e569 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e690 = bitcast<f32>((_e682 & bitcast<u32>(_e687)));
                                                let _e691 = bitcast<u32>((f32(bitcast<i32>((_e578 & 1023u))) * _e616));
                                                let _e696 = (bitcast<i32>((_e578 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e699 = bitcast<f32>((_e691 & bitcast<u32>(_e696)));
                                                let _e700 = bitcast<u32>((f32(bitcast<i32>((_e587 & 1023u))) * _e618));
                                                let _e705 = (bitcast<i32>((_e587 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e708 = bitcast<f32>((_e700 & bitcast<u32>(_e705)));
                                                let _e712 = bitcast<f32>((_e682 & bitcast<u32>(~(_e687))));
                                                let _e716 = bitcast<f32>((_e691 & bitcast<u32>(~(_e696))));
                                                let _e720 = bitcast<f32>((_e700 & bitcast<u32>(~(_e705))));
                                                let _e750 = global_4.member[_e519.member_1][0u];
                                                let _e754 = global_4.member[_e519.member_1][1u];
                                                let _e758 = global_4.member[_e519.member_1][2u];
                                                let _e762 = global_4.member[_e519.member_1][3u];
                                                let _e774 = (((_e754 >> bitcast<u32>(22i)) | ((_e758 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e762 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e775 = (_e750 & 268435455u);
                                                let _e776 = (_e774 & 268435455u);
                                                let _e779 = ((_e750 >> bitcast<u32>(28u)) & 7u);
                                                let _e787 = ((_e750 >> bitcast<u32>(31i)) | (((_e774 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e788 = (_e779 != 0u);
                                                if (_e779 == 0u) {
                                                    phi_3586_ = _e775;
                                                } else {
                                                    if (_e779 == 7u) {
                                                        phi_3585_ = 2147483648u;
                                                    } else {
                                                        phi_3585_ = ((2147483648u | (_e779 << bitcast<u32>(28u))) | (_e776 & 268435455u));
                                                    }
                                                    let _e797 = phi_3585_;
                                                    phi_3586_ = _e797;
                                                }
                                                let _e799 = phi_3586_;
                                                if _e788 {
                                                    let _e800 = (_e779 != 7u);
                                                    if _e800 {
                                                        phi_3596_ = (_e776 + _e779);
                                                    } else {
                                                        phi_3596_ = u32();
                                                    }
                                                    let _e803 = phi_3596_;
                                                    phi_3598_ = _e803;
                                                    phi_3599_ = select(true, false, _e800);
                                                } else {
                                                    phi_3598_ = u32();
                                                    phi_3599_ = true;
                                                }
                                                let _e806 = phi_3598_;
                                                let _e808 = phi_3599_;
                                                if (_e787 == 0u) {
                                                    phi_3620_ = (_e775 + select(0u, 1u, !(_e788)));
                                                } else {
                                                    if (_e787 == 7u) {
                                                        phi_3619_ = 2147483648u;
                                                    } else {
                                                        phi_3619_ = ((2147483648u | (_e787 << bitcast<u32>(28u))) | (select(_e806, _e776, _e808) & 268435455u));
                                                    }
                                                    let _e821 = phi_3619_;
                                                    phi_3620_ = _e821;
                                                }
                                                let _e823 = phi_3620_;
                                                phi_3624_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e519.member.member.x + _e651), (_e519.member.member.x + _e673), (_e519.member.member_1.x - _e690), (_e519.member.member_1.x - _e712)), vec4<f32>((_e519.member.member.y + _e660), (_e519.member.member.y + _e677), (_e519.member.member_1.y - _e699), (_e519.member.member_1.y - _e716)), vec4<f32>((_e519.member.member.z + _e669), (_e519.member.member.z + _e681), (_e519.member.member_1.z - _e708), (_e519.member.member_1.z - _e720))), type_51(type_37((_e519.member.member + vec4<f32>(_e651, _e660, _e669, 0f)), (_e519.member.member_1 - vec4<f32>(_e690, _e699, _e708, 0f))), _e799), type_51(type_37((_e519.member.member + vec4<f32>(_e673, _e677, _e681, 0f)), (_e519.member.member_1 - vec4<f32>(_e712, _e716, _e720, 0f))), _e823));
                                            }
                                            let _e828 = phi_3624_;
                                            let _e841 = ((_e828.member[0].x - _e317) * _e322);
                                            let _e842 = ((_e828.member[0].y - _e317) * _e322);
                                            let _e843 = ((_e828.member[0].z - _e318) * _e322);
                                            let _e844 = ((_e828.member[0].w - _e318) * _e322);
                                            let _e854 = ((_e828.member[1].x - _e353) * _e358);
                                            let _e855 = ((_e828.member[1].y - _e353) * _e358);
                                            let _e856 = ((_e828.member[1].z - _e354) * _e358);
                                            let _e857 = ((_e828.member[1].w - _e354) * _e358);
                                            let _e867 = ((_e828.member[2].x - _e389) * _e394);
                                            let _e868 = ((_e828.member[2].y - _e389) * _e394);
                                            let _e869 = ((_e828.member[2].z - _e390) * _e394);
                                            let _e870 = ((_e828.member[2].w - _e390) * _e394);
                                            let _e872 = select(_e869, _e867, (_e867 < _e869));
                                            let _e874 = select(_e870, _e868, (_e868 < _e870));
                                            let _e876 = select(_e869, _e867, (_e867 > _e869));
                                            let _e878 = select(_e870, _e868, (_e868 > _e870));
                                            let _e880 = select(_e843, _e841, (_e841 < _e843));
                                            let _e882 = select(_e844, _e842, (_e842 < _e844));
                                            let _e884 = select(_e856, _e854, (_e854 < _e856));
                                            let _e886 = select(_e857, _e855, (_e855 < _e857));
                                            let _e888 = select(_e884, _e880, (_e880 > _e884));
                                            let _e890 = select(_e886, _e882, (_e882 > _e886));
                                            let _e892 = select(_e872, _e888, (_e888 > _e872));
                                            let _e894 = select(_e874, _e890, (_e890 > _e874));
                                            let _e896 = select(_e843, _e841, (_e841 > _e843));
                                            let _e898 = select(_e844, _e842, (_e842 > _e844));
                                            let _e900 = select(_e856, _e854, (_e854 > _e856));
                                            let _e902 = select(_e857, _e855, (_e855 > _e857));
                                            let _e904 = select(_e900, _e896, (_e896 < _e900));
                                            let _e906 = select(_e902, _e898, (_e898 < _e902));
                                            let _e911 = -(_e872);
                                            let _e912 = -(_e874);
                                            let _e919 = (select(_e876, _e904, (_e904 < _e876)) + (select(_e911, _e876, (_e876 > _e911)) * 0.0000019073523f));
                                            let _e920 = (select(_e878, _e906, (_e906 < _e878)) + (select(_e912, _e878, (_e878 > _e912)) * 0.0000019073523f));
                                            let _e922 = select(_e440, _e892, (_e892 > _e440));
                                            let _e924 = select(_e440, _e894, (_e894 > _e440));
                                            let _e929 = (_e922 <= select(_e489.member.member_1, _e919, (_e919 < _e489.member.member_1)));
                                            let _e930 = (_e924 <= select(_e489.member.member_1, _e920, (_e920 < _e489.member.member_1)));
                                            let _e931 = (_e922 <= _e924);
                                            if _e929 {
                                                if _e930 {
                                                    if _e931 {
                                                        phi_3968_ = _e828.member_2;
                                                    } else {
                                                        phi_3968_ = _e828.member_1;
                                                    }
                                                    let _e935 = phi_3968_;
                                                    let _e936 = (_e523 % 128u);
                                                    let _e937 = (_e936 < 128u);
                                                    if _e937 {
                                                    } else {
                                                        phi_4501_ = true;
                                                        break;
                                                    }
                                                    local_3[_e936] = type_51(type_37(_e935.member.member, _e935.member.member_1), _e935.member_1);
                                                    if _e937 {
                                                    } else {
                                                        phi_4501_ = true;
                                                        break;
                                                    }
                                                    local_2[_e936] = select(_e924, _e922, (_e922 > _e924));
                                                    if _e931 {
                                                        phi_4001_ = _e828.member_1;
                                                    } else {
                                                        phi_4001_ = _e828.member_2;
                                                    }
                                                    let _e952 = phi_4001_;
                                                    phi_4002_ = _e952;
                                                    phi_4003_ = (_e523 + 1u);
                                                } else {
                                                    phi_4002_ = type_51();
                                                    phi_4003_ = u32();
                                                }
                                                let _e954 = phi_4002_;
                                                let _e956 = phi_4003_;
                                                phi_4005_ = _e954;
                                                phi_4006_ = _e956;
                                                phi_4007_ = select(true, false, _e930);
                                            } else {
                                                phi_4005_ = type_51();
                                                phi_4006_ = u32();
                                                phi_4007_ = true;
                                            }
                                            let _e959 = phi_4005_;
                                            let _e961 = phi_4006_;
                                            let _e963 = phi_4007_;
                                            if _e963 {
                                                if _e929 {
                                                    phi_4016_ = _e828.member_1;
                                                } else {
                                                    phi_4016_ = _e828.member_2;
                                                }
                                                let _e967 = phi_4016_;
                                                phi_4021_ = _e967;
                                                phi_4022_ = select(_e930, true, _e929);
                                            } else {
                                                phi_4021_ = _e959;
                                                phi_4022_ = _e521;
                                            }
                                            let _e970 = phi_4021_;
                                            let _e972 = phi_4022_;
                                            phi_4505_ = _e487;
                                            phi_4024_ = type_44(_e489.member, (_e489.member_1 + 1u), _e489.member_2);
                                            phi_4025_ = _e970;
                                            phi_4026_ = _e972;
                                            phi_4027_ = select(_e961, _e523, _e963);
                                        }
                                        let _e1396 = phi_4505_;
                                        let _e1398 = phi_4024_;
                                        let _e1400 = phi_4025_;
                                        let _e1402 = phi_4026_;
                                        let _e1404 = phi_4027_;
                                        phi_4504_ = _e1396;
                                        phi_4028_ = _e1398;
                                        phi_4029_ = _e1400;
                                        phi_4030_ = (_e493 - 1u);
                                        phi_4031_ = _e1402;
                                        phi_4032_ = _e1404;
                                    } else {
                                        phi_4504_ = _e487;
                                        phi_4028_ = _e489;
                                        phi_4029_ = _e519;
                                        phi_4030_ = _e493;
                                        phi_4031_ = _e521;
                                        phi_4032_ = _e523;
                                    }
                                    let _e1406 = phi_4504_;
                                    let _e1408 = phi_4028_;
                                    let _e1410 = phi_4029_;
                                    let _e1412 = phi_4030_;
                                    let _e1414 = phi_4031_;
                                    let _e1416 = phi_4032_;
                                    phi_4503_ = _e1406;
                                    phi_4033_ = _e1408;
                                    phi_4034_ = _e1410;
                                    phi_4035_ = _e1412;
                                    phi_4036_ = _e1414;
                                    phi_4037_ = _e1416;
                                } else {
                                    phi_4503_ = _e487;
                                    phi_4033_ = type_44();
                                    phi_4034_ = type_51();
                                    phi_4035_ = u32();
                                    phi_4036_ = bool();
                                    phi_4037_ = u32();
                                }
                                let _e1418 = phi_4503_;
                                let _e1420 = phi_4033_;
                                let _e1422 = phi_4034_;
                                let _e1424 = phi_4035_;
                                let _e1426 = phi_4036_;
                                let _e1428 = phi_4037_;
                                phi_4502_ = _e1418;
                                phi_1892_ = _e1420;
                                phi_1895_ = _e1422;
                                phi_1897_ = _e1424;
                                phi_1899_ = _e1426;
                                phi_1901_ = _e1428;
                                phi_4038_ = _e501;
                            } else {
                                phi_4502_ = _e487;
                                phi_1892_ = type_44();
                                phi_1895_ = type_51();
                                phi_1897_ = u32();
                                phi_1899_ = bool();
                                phi_1901_ = u32();
                                phi_4038_ = false;
                            }
                            let _e1430 = phi_4502_;
                            let _e1432 = phi_1892_;
                            let _e1434 = phi_1895_;
                            let _e1436 = phi_1897_;
                            let _e1438 = phi_1899_;
                            let _e1440 = phi_1901_;
                            let _e1442 = phi_4038_;
                            continue;
                            continuing {
                                phi_4393_ = _e1430;
                                phi_1891_ = _e1432;
                                phi_1894_ = _e1434;
                                phi_1896_ = _e1436;
                                phi_1898_ = _e1438;
                                phi_1900_ = _e1440;
                                phi_4501_ = _e1430;
                                break if !(_e1442);
                            }
                        }
                        let _e1445 = phi_4501_;
                        if _e1445 {
                            break;
                        }
                        let _e1447 = local_4;
                        if (_e1447.member.member.member_3 != 4294967295u) {
                            let _e1453 = (_e264 / 3i);
                            let _e1460 = bitcast<f32>((bitcast<u32>((_e1453 + 127i)) << bitcast<u32>(23i)));
                            let _e1468 = (((_e1447.member.member.member * _e1460) * _e1460) * bitcast<f32>((bitcast<u32>(((_e264 - (2i * _e1453)) + 127i)) << bitcast<u32>(23i))));
                            let _e1470 = select(340282350000000000000000000000000000000f, _e1468, (_e1468 < 340282350000000000000000000000000000000f));
                            phi_4090_ = type_25(select(-340282350000000000000000000000000000000f, _e1470, (_e1470 > -340282350000000000000000000000000000000f)), _e1447.member.member.member_1, _e1447.member.member.member_2, _e1447.member.member.member_3);
                        } else {
                            phi_4090_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1477 = phi_4090_;
                        if _e140 {
                        } else {
                            break;
                        }
                        global_2.member[_e124] = _e1477;
                        let _e1481 = local_5;
                        if _e141 {
                        } else {
                            break;
                        }
                        global_6.member[_e124] = _e1481.member_1;
                        if _e139 {
                        } else {
                            break;
                        }
                        let _e1486 = select(0u, 1u, (_e208 <= _e218));
                        if (_e1486 > 0u) {
                            let _e1488 = (1u < _e92);
                            if _e1488 {
                                if (0u < _e92) {
                                } else {
                                    break;
                                }
                                let _e1492 = atomicAdd((&global_7.member[0u]), _e1486);
                                if ((_e1492 + _e1486) < _e1492) {
                                    if _e1488 {
                                    } else {
                                        break;
                                    }
                                    let _e1497 = atomicAdd((&global_7.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1500 = select(0u, 1u, (_e1477.member_3 != 4294967295u));
                        if (_e1500 > 0u) {
                            let _e1502 = (3u < _e92);
                            if _e1502 {
                                if (2u < _e92) {
                                } else {
                                    break;
                                }
                                let _e1506 = atomicAdd((&global_7.member[2u]), _e1500);
                                if ((_e1506 + _e1500) < _e1506) {
                                    if _e1502 {
                                    } else {
                                        break;
                                    }
                                    let _e1511 = atomicAdd((&global_7.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1481.member_1 > 0u) {
                            let _e1513 = (5u < _e92);
                            if _e1513 {
                                if (4u < _e92) {
                                } else {
                                    break;
                                }
                                let _e1517 = atomicAdd((&global_7.member[4u]), _e1481.member_1);
                                if ((_e1517 + _e1481.member_1) < _e1517) {
                                    if _e1513 {
                                    } else {
                                        break;
                                    }
                                    let _e1522 = atomicAdd((&global_7.member[5u]), 1u);
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
fn trace_paths_counted_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
