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

struct type_20 {
    member: array<type_18>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: type_18,
    member_1: f32,
}

struct type_31 {
    member: array<type_22>,
}

struct type_34 {
    member: array<vec4<u32>, 2>,
}

struct type_36 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_38 {
    member: array<type_36>,
}

struct type_41 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_44 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_46 {
    member: array<type_44>,
}

struct type_50 {
    member: type_41,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_34;
@group(0) @binding(4) 
var<storage> global_3: type_31;
@group(0) @binding(2) 
var<storage> global_4: type_38;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_20;
@group(0) @binding(3) 
var<storage> global_6: type_46;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;
    var local_3: array<f32, 3>;
    var local_4: array<f32, 128>;
    var local_5: array<type_50, 128>;
    var local_6: array<f32, 3>;
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var local_10: array<u32, 3>;
    var local_11: array<u32, 3>;
    var local_12: array<u32, 3>;
    var local_13: array<array<f32, 3>, 3>;
    var local_14: array<u32, 3>;
    var local_15: array<f32, 3>;
    var local_16: array<f32, 3>;
    var phi_342_: i32;
    var phi_343_: i32;
    var phi_353_: bool;
    var phi_363_: u32;
    var phi_364_: u32;
    var phi_366_: bool;
    var phi_371_: u32;
    var phi_416_: f32;
    var phi_422_: f32;
    var phi_433_: f32;
    var phi_439_: f32;
    var phi_462_: f32;
    var phi_473_: f32;
    var phi_482_: f32;
    var phi_488_: f32;
    var phi_499_: f32;
    var phi_505_: f32;
    var phi_528_: f32;
    var phi_539_: f32;
    var phi_548_: f32;
    var phi_554_: f32;
    var phi_565_: f32;
    var phi_571_: f32;
    var phi_594_: f32;
    var phi_605_: f32;
    var phi_705_: f32;
    var phi_706_: f32;
    var phi_4776_: bool;
    var phi_2834_: type_28;
    var phi_2837_: type_50;
    var phi_2839_: u32;
    var phi_2841_: bool;
    var phi_2843_: u32;
    var phi_2854_: bool;
    var phi_2899_: type_50;
    var phi_2900_: bool;
    var phi_2901_: u32;
    var phi_3817_: type_36;
    var phi_3826_: type_4;
    var phi_3827_: type_4;
    var phi_3850_: type_4;
    var phi_4769_: bool;
    var phi_3980_: type_4;
    var phi_3981_: type_4;
    var phi_4004_: type_4;
    var phi_4825_: bool;
    var phi_4567_: type_50;
    var phi_4606_: type_50;
    var phi_4607_: type_50;
    var phi_4608_: u32;
    var phi_4610_: type_50;
    var phi_4611_: u32;
    var phi_4612_: bool;
    var phi_4619_: type_50;
    var phi_4624_: type_50;
    var phi_4625_: bool;
    var phi_4842_: bool;
    var phi_2920_: type_28;
    var phi_2923_: type_4;
    var phi_2924_: type_4;
    var phi_2946_: type_4;
    var phi_2988_: u32;
    var phi_3012_: type_44;
    var phi_4838_: bool;
    var phi_3023_: type_4;
    var phi_3024_: type_4;
    var phi_3047_: type_4;
    var phi_3057_: type_4;
    var phi_3058_: type_4;
    var phi_3081_: type_4;
    var phi_4833_: bool;
    var phi_4846_: bool;
    var phi_4845_: bool;
    var phi_3644_: vec3<f32>;
    var phi_3645_: vec3<f32>;
    var phi_3676_: bool;
    var phi_3685_: vec3<f32>;
    var phi_3725_: type_18;
    var phi_3727_: type_18;
    var phi_3728_: bool;
    var phi_3732_: type_18;
    var phi_3733_: type_18;
    var phi_3734_: type_18;
    var phi_3735_: bool;
    var phi_3739_: type_18;
    var phi_3740_: bool;
    var phi_3744_: type_18;
    var phi_3745_: bool;
    var phi_3749_: type_18;
    var phi_3774_: bool;
    var phi_3775_: bool;
    var phi_3781_: type_28;
    var phi_3782_: type_28;
    var phi_3783_: type_28;
    var phi_4848_: bool;
    var phi_2921_: type_28;
    var phi_4847_: bool;
    var phi_4910_: bool;
    var phi_4627_: type_28;
    var phi_4628_: type_50;
    var phi_4629_: bool;
    var phi_4630_: u32;
    var phi_4909_: bool;
    var phi_4631_: type_28;
    var phi_4632_: type_50;
    var phi_4633_: u32;
    var phi_4634_: bool;
    var phi_4635_: u32;
    var phi_4908_: bool;
    var phi_4636_: type_28;
    var phi_4637_: type_50;
    var phi_4638_: u32;
    var phi_4639_: bool;
    var phi_4640_: u32;
    var phi_4907_: bool;
    var phi_2835_: type_28;
    var phi_2838_: type_50;
    var phi_2840_: u32;
    var phi_2842_: bool;
    var phi_2844_: u32;
    var phi_4641_: bool;
    var phi_4906_: bool;
    var local_17: type_28;
    var phi_4693_: type_18;
    var local_18: type_28;

    switch bitcast<i32>(0u) {
        default: {
            let _e82 = global;
            let _e85 = arrayLength((&global_4.member));
            let _e96 = global_2.member[0u][0u];
            let _e100 = global_2.member[0u][1u];
            let _e104 = global_2.member[0u][2u];
            let _e108 = global_2.member[1u][0u];
            let _e112 = global_2.member[1u][1u];
            let _e116 = global_2.member[1u][2u];
            let _e120 = global_2.member[1u][3u];
            let _e123 = global_1.member[0u];
            let _e124 = bitcast<i32>(_e123);
            let _e134 = (_e82.x + (_e82.y * 2097152u));
            let _e135 = (_e134 < arrayLength((&global_3.member)));
            if _e135 {
                let _e136 = (_e134 < arrayLength((&global_5.member)));
                if _e136 {
                    if _e135 {
                    } else {
                        break;
                    }
                    let _e144 = global_3.member[_e134].member_2[0u];
                    let _e146 = (bitcast<u32>(_e144) & 2147483647u);
                    let _e151 = global_3.member[_e134].member_2[1u];
                    let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                    let _e158 = global_3.member[_e134].member_2[2u];
                    let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                    let _e165 = global_3.member[_e134].member[0u];
                    let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                    let _e172 = global_3.member[_e134].member[1u];
                    let _e174 = (bitcast<u32>(_e172) & 2147483647u);
                    let _e179 = global_3.member[_e134].member[2u];
                    let _e181 = (bitcast<u32>(_e179) & 2147483647u);
                    let _e183 = select(_e153, _e146, (_e153 < _e146));
                    let _e185 = select(_e160, _e183, (_e160 < _e183));
                    let _e187 = select(_e167, _e185, (_e167 < _e185));
                    let _e189 = select(_e174, _e187, (_e174 < _e187));
                    let _e191 = select(_e181, _e189, (_e181 < _e189));
                    let _e195 = global_3.member[_e134].member_1;
                    let _e197 = (bitcast<u32>(_e195) & 2147483647u);
                    let _e204 = global_3.member[_e134].member_3;
                    let _e210 = (((select(_e197, _e191, (_e197 < _e191)) < 2139095040u) && ((bitcast<u32>(_e204) & 2147483647u) <= 2139095040u)) && (_e185 > 0u));
                    if _e210 {
                        let _e213 = (bitcast<u32>(bitcast<f32>(_e185)) & 2147483647u);
                        if (_e213 >= 8388608u) {
                            phi_342_ = (bitcast<i32>((_e213 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_342_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e213)), 32u, (_e213 == 0u))));
                        }
                        let _e227 = phi_342_;
                        phi_343_ = _e227;
                    } else {
                        phi_343_ = 0i;
                    }
                    let _e229 = phi_343_;
                    let _e230 = (_e146 == _e185);
                    if _e230 {
                        phi_353_ = true;
                    } else {
                        phi_353_ = (_e153 == _e185);
                    }
                    let _e233 = phi_353_;
                    let _e234 = select(1u, 0u, _e230);
                    if _e233 {
                        let _e235 = (_e234 + 1u);
                        phi_363_ = _e235;
                        phi_364_ = _e235;
                        phi_366_ = select(true, false, (_e235 == 2u));
                    } else {
                        phi_363_ = u32();
                        phi_364_ = 0u;
                        phi_366_ = true;
                    }
                    let _e239 = phi_363_;
                    let _e241 = phi_364_;
                    let _e243 = phi_366_;
                    if _e243 {
                        phi_371_ = (_e241 + 1u);
                    } else {
                        phi_371_ = 0u;
                    }
                    let _e247 = phi_371_;
                    let _e248 = select(_e239, _e241, _e243);
                    let _e249 = select(_e234, select(2u, _e234, _e233), _e243);
                    let _e250 = (_e124 / 2i);
                    let _e255 = bitcast<f32>((bitcast<u32>((_e250 + 127i)) << bitcast<u32>(23i)));
                    let _e261 = bitcast<f32>((bitcast<u32>(((_e124 - _e250) + 127i)) << bitcast<u32>(23i)));
                    let _e262 = -(_e229);
                    let _e263 = (_e262 / 2i);
                    let _e268 = bitcast<f32>((bitcast<u32>((_e263 + 127i)) << bitcast<u32>(23i)));
                    let _e274 = bitcast<f32>((bitcast<u32>(((_e262 - _e263) + 127i)) << bitcast<u32>(23i)));
                    let _e278 = global_3.member[_e134].member;
                    let _e279 = (_e248 == 0u);
                    if _e279 {
                        phi_416_ = _e278[0];
                    } else {
                        phi_416_ = _e278[1];
                    }
                    let _e283 = phi_416_;
                    let _e284 = (_e248 == 2u);
                    if _e284 {
                        phi_422_ = _e278[2];
                    } else {
                        phi_422_ = _e283;
                    }
                    let _e287 = phi_422_;
                    let _e289 = ((_e287 * _e255) * _e261);
                    let _e290 = global_3.member[_e134].member_2;
                    if _e279 {
                        phi_433_ = _e290[0];
                    } else {
                        phi_433_ = _e290[1];
                    }
                    let _e294 = phi_433_;
                    if _e284 {
                        phi_439_ = _e290[2];
                    } else {
                        phi_439_ = _e294;
                    }
                    let _e297 = phi_439_;
                    let _e299 = ((_e297 * _e268) * _e274);
                    let _e303 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e303 {
                        let _e307 = (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) * 0.00000011920929f);
                        phi_462_ = select(0.00000000000011368684f, _e307, (_e307 > 0.00000000000011368684f));
                    } else {
                        phi_462_ = 0f;
                    }
                    let _e311 = phi_462_;
                    let _e312 = (_e289 + _e311);
                    let _e313 = (_e289 - _e311);
                    let _e314 = select(_e299, 0f, _e303);
                    if _e303 {
                        phi_473_ = 38685626000000000000000000f;
                    } else {
                        phi_473_ = (1f / _e299);
                    }
                    let _e317 = phi_473_;
                    let _e318 = (_e247 == 0u);
                    if _e318 {
                        phi_482_ = _e278[0];
                    } else {
                        phi_482_ = _e278[1];
                    }
                    let _e322 = phi_482_;
                    let _e323 = (_e247 == 2u);
                    if _e323 {
                        phi_488_ = _e278[2];
                    } else {
                        phi_488_ = _e322;
                    }
                    let _e326 = phi_488_;
                    let _e328 = ((_e326 * _e255) * _e261);
                    if _e318 {
                        phi_499_ = _e290[0];
                    } else {
                        phi_499_ = _e290[1];
                    }
                    let _e332 = phi_499_;
                    if _e323 {
                        phi_505_ = _e290[2];
                    } else {
                        phi_505_ = _e332;
                    }
                    let _e335 = phi_505_;
                    let _e337 = ((_e335 * _e268) * _e274);
                    let _e341 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e341 {
                        let _e345 = (bitcast<f32>((bitcast<u32>(_e328) & 2147483647u)) * 0.00000011920929f);
                        phi_528_ = select(0.00000000000011368684f, _e345, (_e345 > 0.00000000000011368684f));
                    } else {
                        phi_528_ = 0f;
                    }
                    let _e349 = phi_528_;
                    let _e350 = (_e328 + _e349);
                    let _e351 = (_e328 - _e349);
                    let _e352 = select(_e337, 0f, _e341);
                    if _e341 {
                        phi_539_ = 38685626000000000000000000f;
                    } else {
                        phi_539_ = (1f / _e337);
                    }
                    let _e355 = phi_539_;
                    let _e356 = (_e249 == 0u);
                    if _e356 {
                        phi_548_ = _e278[0];
                    } else {
                        phi_548_ = _e278[1];
                    }
                    let _e360 = phi_548_;
                    let _e361 = (_e249 == 2u);
                    if _e361 {
                        phi_554_ = _e278[2];
                    } else {
                        phi_554_ = _e360;
                    }
                    let _e364 = phi_554_;
                    let _e366 = ((_e364 * _e255) * _e261);
                    if _e356 {
                        phi_565_ = _e290[0];
                    } else {
                        phi_565_ = _e290[1];
                    }
                    let _e370 = phi_565_;
                    if _e361 {
                        phi_571_ = _e290[2];
                    } else {
                        phi_571_ = _e370;
                    }
                    let _e373 = phi_571_;
                    let _e375 = ((_e373 * _e268) * _e274);
                    let _e379 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e379 {
                        let _e383 = (bitcast<f32>((bitcast<u32>(_e366) & 2147483647u)) * 0.00000011920929f);
                        phi_594_ = select(0.00000000000011368684f, _e383, (_e383 > 0.00000000000011368684f));
                    } else {
                        phi_594_ = 0f;
                    }
                    let _e387 = phi_594_;
                    let _e388 = (_e366 + _e387);
                    let _e389 = (_e366 - _e387);
                    let _e390 = select(_e375, 0f, _e379);
                    if _e379 {
                        phi_605_ = 38685626000000000000000000f;
                    } else {
                        phi_605_ = (1f / _e375);
                    }
                    let _e393 = phi_605_;
                    let _e396 = bitcast<f32>((bitcast<u32>(_e289) & 2147483647u));
                    let _e399 = bitcast<f32>((bitcast<u32>(_e328) & 2147483647u));
                    let _e401 = select(_e399, _e396, (_e396 > _e399));
                    let _e404 = bitcast<f32>((bitcast<u32>(_e366) & 2147483647u));
                    let _e407 = (_e124 + _e229);
                    if (_e210 && (select(_e404, _e401, (_e401 > _e404)) <= 1099511600000f)) {
                        let _e410 = (_e407 / 3i);
                        let _e417 = bitcast<f32>((bitcast<u32>((_e410 + 127i)) << bitcast<u32>(23i)));
                        let _e424 = bitcast<f32>((bitcast<u32>(((_e407 - (2i * _e410)) + 127i)) << bitcast<u32>(23i)));
                        let _e425 = (((_e195 * _e417) * _e417) * _e424);
                        let _e427 = select(340282350000000000000000000000000000000f, _e425, (_e425 < 340282350000000000000000000000000000000f));
                        let _e432 = (((_e204 * _e417) * _e417) * _e424);
                        let _e434 = select(340282350000000000000000000000000000000f, _e432, (_e432 < 340282350000000000000000000000000000000f));
                        phi_705_ = select(-340282350000000000000000000000000000000f, _e434, (_e434 > -340282350000000000000000000000000000000f));
                        phi_706_ = select(-340282350000000000000000000000000000000f, _e427, (_e427 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_705_ = 0f;
                        phi_706_ = 1f;
                    }
                    let _e438 = phi_705_;
                    let _e440 = phi_706_;
                    local_5 = array<type_50, 128>(type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_16 = array<f32, 3>(bitcast<f32>(_e96), bitcast<f32>(_e100), bitcast<f32>(_e104));
                    let _e445 = (_e248 % 3u);
                    let _e446 = (_e445 < 3u);
                    if _e446 {
                    } else {
                        break;
                    }
                    let _e448 = local_16[_e445];
                    let _e449 = (_e247 % 3u);
                    let _e450 = (_e449 < 3u);
                    if _e450 {
                    } else {
                        break;
                    }
                    let _e452 = local_16[_e449];
                    let _e453 = (_e249 % 3u);
                    let _e454 = (_e453 < 3u);
                    if _e454 {
                    } else {
                        break;
                    }
                    let _e456 = local_16[_e453];
                    local_15 = array<f32, 3>(bitcast<f32>(_e108), bitcast<f32>(_e112), bitcast<f32>(_e116));
                    if _e446 {
                    } else {
                        break;
                    }
                    let _e460 = local_15[_e445];
                    if _e450 {
                    } else {
                        break;
                    }
                    let _e462 = local_15[_e449];
                    if _e454 {
                    } else {
                        break;
                    }
                    let _e464 = local_15[_e453];
                    phi_4776_ = false;
                    phi_2834_ = type_28(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e438);
                    phi_2837_ = type_50(type_41(array<f32, 3>(_e448, _e452, _e456), array<f32, 3>(_e460, _e462, _e464)), select(0u, 2147483648u, (_e85 == 0u)));
                    phi_2839_ = ((3u * _e85) + 1u);
                    phi_2841_ = (_e440 <= _e438);
                    phi_2843_ = 0u;
                    loop {
                        let _e472 = phi_4776_;
                        let _e474 = phi_2834_;
                        let _e476 = phi_2837_;
                        let _e478 = phi_2839_;
                        let _e480 = phi_2841_;
                        let _e482 = phi_2843_;
                        local_17 = _e474;
                        if _e480 {
                            phi_2854_ = true;
                        } else {
                            phi_2854_ = (_e482 > 0u);
                        }
                        let _e485 = phi_2854_;
                        if _e485 {
                            let _e486 = (_e478 > 0u);
                            if _e486 {
                                if _e480 {
                                    phi_2899_ = _e476;
                                    phi_2900_ = _e480;
                                    phi_2901_ = _e482;
                                } else {
                                    let _e487 = (_e482 - 1u);
                                    let _e488 = (_e487 % 128u);
                                    let _e489 = (_e488 < 128u);
                                    if _e489 {
                                    } else {
                                        phi_4906_ = true;
                                        break;
                                    }
                                    let _e491 = local_5[_e488];
                                    if _e489 {
                                    } else {
                                        phi_4906_ = true;
                                        break;
                                    }
                                    let _e507 = local_4[_e488];
                                    phi_2899_ = type_50(type_41(array<f32, 3>(_e491.member.member[0], _e491.member.member[1], _e491.member.member[2]), array<f32, 3>(_e491.member.member_1[0], _e491.member.member_1[1], _e491.member.member_1[2])), _e491.member_1);
                                    phi_2900_ = (_e507 <= _e474.member_1);
                                    phi_2901_ = _e487;
                                }
                                let _e511 = phi_2899_;
                                let _e513 = phi_2900_;
                                let _e515 = phi_2901_;
                                if _e513 {
                                    if ((_e511.member_1 & 2147483648u) != 0u) {
                                        phi_4842_ = _e472;
                                        phi_2920_ = _e474;
                                        phi_2923_ = type_4(0u, ((_e511.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e837 = phi_4842_;
                                            let _e839 = phi_2920_;
                                            let _e841 = phi_2923_;
                                            local_18 = _e839;
                                            if (_e841.member < _e841.member_1) {
                                                phi_2924_ = type_4((_e841.member + 1u), _e841.member_1);
                                                phi_2946_ = type_4(1u, _e841.member);
                                            } else {
                                                phi_2924_ = _e841;
                                                phi_2946_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e854 = phi_2924_;
                                            let _e856 = phi_2946_;
                                            let _e860 = (bitcast<i32>(_e856.member) != 0i);
                                            if _e860 {
                                                local_1 = array<f32, 3>(_e511.member.member[0], _e511.member.member[1], _e511.member.member[2]);
                                                local = array<f32, 3>(_e511.member.member_1[0], _e511.member.member_1[1], _e511.member.member_1[2]);
                                                let _e871 = ((_e511.member_1 & 268435455u) + _e856.member_1);
                                                let _e872 = (_e871 < arrayLength((&global_6.member)));
                                                if _e872 {
                                                    if _e872 {
                                                    } else {
                                                        phi_4847_ = true;
                                                        break;
                                                    }
                                                    let _e875 = global_6.member[_e871].member_1;
                                                    phi_2988_ = _e875;
                                                } else {
                                                    phi_2988_ = 4294967295u;
                                                }
                                                let _e877 = phi_2988_;
                                                local_12 = array<u32, 3>(_e248, _e247, _e249);
                                                if _e872 {
                                                    if _e872 {
                                                    } else {
                                                        phi_4847_ = true;
                                                        break;
                                                    }
                                                    let _e880 = global_6.member[_e871];
                                                    phi_3012_ = _e880;
                                                } else {
                                                    phi_3012_ = type_44(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e882 = phi_3012_;
                                                local_14 = array<u32, 3>(_e882.member[0], _e882.member[1], _e882.member[2]);
                                                local_13[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_13[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_13[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4838_ = _e837;
                                                phi_3023_ = type_4(0u, 3u);
                                                loop {
                                                    let _e892 = phi_4838_;
                                                    let _e894 = phi_3023_;
                                                    if (_e894.member < _e894.member_1) {
                                                        phi_3024_ = type_4((_e894.member + 1u), _e894.member_1);
                                                        phi_3047_ = type_4(1u, _e894.member);
                                                    } else {
                                                        phi_3024_ = _e894;
                                                        phi_3047_ = type_4(0u, type_4().member_1);
                                                    }
                                                    let _e907 = phi_3024_;
                                                    let _e909 = phi_3047_;
                                                    let _e913 = (bitcast<i32>(_e909.member) != 0i);
                                                    if _e913 {
                                                        phi_3057_ = type_4(0u, 3u);
                                                        loop {
                                                            let _e915 = phi_3057_;
                                                            if (_e915.member < _e915.member_1) {
                                                                phi_3058_ = type_4((_e915.member + 1u), _e915.member_1);
                                                                phi_3081_ = type_4(1u, _e915.member);
                                                            } else {
                                                                phi_3058_ = _e915;
                                                                phi_3081_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e928 = phi_3058_;
                                                            let _e930 = phi_3081_;
                                                            let _e934 = (bitcast<i32>(_e930.member) != 0i);
                                                            if _e934 {
                                                                let _e935 = (_e909.member_1 < 3u);
                                                                if _e935 {
                                                                } else {
                                                                    phi_4833_ = true;
                                                                    break;
                                                                }
                                                                let _e937 = local_14[_e909.member_1];
                                                                let _e938 = (_e930.member_1 < 3u);
                                                                if _e938 {
                                                                } else {
                                                                    phi_4833_ = true;
                                                                    break;
                                                                }
                                                                let _e940 = local_12[_e930.member_1];
                                                                let _e945 = ((_e937 >> bitcast<u32>(((10u * _e940) & 31u))) & 1023u);
                                                                if _e938 {
                                                                } else {
                                                                    phi_4833_ = true;
                                                                    break;
                                                                }
                                                                let _e947 = local_1[_e930.member_1];
                                                                if _e938 {
                                                                } else {
                                                                    phi_4833_ = true;
                                                                    break;
                                                                }
                                                                let _e949 = local[_e930.member_1];
                                                                let _e960 = (_e947 + bitcast<f32>((bitcast<u32>((f32(_e945) * bitcast<f32>((bitcast<u32>(((_e949 - _e947) * 0.0009775171f)) ^ _e120)))) ^ _e120)));
                                                                if _e935 {
                                                                } else {
                                                                    phi_4833_ = true;
                                                                    break;
                                                                }
                                                                if _e938 {
                                                                } else {
                                                                    phi_4833_ = true;
                                                                    break;
                                                                }
                                                                local_13[_e909.member_1][_e930.member_1] = select(select(_e949, _e960, (_e960 < _e949)), _e949, (_e945 == 1023u));
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_3057_ = _e928;
                                                                phi_4833_ = _e892;
                                                                break if !(_e934);
                                                            }
                                                        }
                                                        let _e969 = phi_4833_;
                                                        phi_4845_ = _e969;
                                                        if _e969 {
                                                            break;
                                                        }
                                                        phi_4846_ = _e969;
                                                    } else {
                                                        phi_4846_ = _e892;
                                                    }
                                                    let _e971 = phi_4846_;
                                                    continue;
                                                    continuing {
                                                        phi_4838_ = _e971;
                                                        phi_3023_ = _e907;
                                                        phi_4845_ = _e971;
                                                        break if !(_e913);
                                                    }
                                                }
                                                let _e974 = phi_4845_;
                                                phi_4847_ = _e974;
                                                if _e974 {
                                                    break;
                                                }
                                                let _e975 = local_13;
                                                let _e991 = (_e975[0][2] - _e366);
                                                let _e994 = (((_e975[0][0] - _e289) * _e390) - (_e991 * _e314));
                                                let _e997 = (((_e975[0][1] - _e328) * _e390) - (_e991 * _e352));
                                                let _e1000 = (_e975[1][2] - _e366);
                                                let _e1003 = (((_e975[1][0] - _e289) * _e390) - (_e1000 * _e314));
                                                let _e1006 = (((_e975[1][1] - _e328) * _e390) - (_e1000 * _e352));
                                                let _e1009 = (_e975[2][2] - _e366);
                                                let _e1012 = (((_e975[2][0] - _e289) * _e390) - (_e1009 * _e314));
                                                let _e1015 = (((_e975[2][1] - _e328) * _e390) - (_e1009 * _e352));
                                                let _e1016 = (_e1012 * _e1006);
                                                let _e1017 = (_e1015 * _e1003);
                                                let _e1018 = (_e994 * _e1015);
                                                let _e1019 = (_e997 * _e1012);
                                                let _e1020 = (_e1003 * _e997);
                                                let _e1021 = (_e1006 * _e994);
                                                let _e1026 = (((_e1016 >= _e1017) && (_e1018 >= _e1019)) && (_e1020 >= _e1021));
                                                if (_e1026 || (((_e1016 <= _e1017) && (_e1018 <= _e1019)) && (_e1020 <= _e1021))) {
                                                    let _e1033 = select(-1f, 1f, _e1026);
                                                    let _e1035 = ((_e1016 - _e1017) * _e1033);
                                                    let _e1037 = select(0f, _e1035, (_e1035 > 0f));
                                                    let _e1039 = ((_e1018 - _e1019) * _e1033);
                                                    let _e1041 = select(0f, _e1039, (_e1039 > 0f));
                                                    let _e1043 = ((_e1020 - _e1021) * _e1033);
                                                    let _e1045 = select(0f, _e1043, (_e1043 > 0f));
                                                    let _e1047 = ((_e1037 + _e1041) + _e1045);
                                                    if (_e1047 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3739_ = type_18();
                                                        phi_3740_ = true;
                                                    } else {
                                                        let _e1050 = select(_e975[1][0], _e975[0][0], (_e975[0][0] < _e975[1][0]));
                                                        let _e1054 = select(_e975[1][0], _e975[0][0], (_e975[0][0] > _e975[1][0]));
                                                        let _e1058 = select(_e975[1][1], _e975[0][1], (_e975[0][1] < _e975[1][1]));
                                                        let _e1062 = select(_e975[1][1], _e975[0][1], (_e975[0][1] > _e975[1][1]));
                                                        let _e1066 = select(_e975[1][2], _e975[0][2], (_e975[0][2] < _e975[1][2]));
                                                        let _e1070 = select(_e975[1][2], _e975[0][2], (_e975[0][2] > _e975[1][2]));
                                                        let _e1075 = ((select(_e975[2][0], _e1050, (_e1050 < _e975[2][0])) - _e312) * _e317);
                                                        let _e1076 = ((select(_e975[2][0], _e1054, (_e1054 > _e975[2][0])) - _e313) * _e317);
                                                        let _e1079 = ((select(_e975[2][1], _e1058, (_e1058 < _e975[2][1])) - _e350) * _e355);
                                                        let _e1080 = ((select(_e975[2][1], _e1062, (_e1062 > _e975[2][1])) - _e351) * _e355);
                                                        let _e1083 = ((select(_e975[2][2], _e1066, (_e1066 < _e975[2][2])) - _e388) * _e393);
                                                        let _e1084 = ((select(_e975[2][2], _e1070, (_e1070 > _e975[2][2])) - _e389) * _e393);
                                                        let _e1086 = select(_e1084, _e1083, (_e1083 < _e1084));
                                                        let _e1088 = select(_e1084, _e1083, (_e1083 > _e1084));
                                                        let _e1090 = select(_e1076, _e1075, (_e1075 < _e1076));
                                                        let _e1092 = select(_e1080, _e1079, (_e1079 < _e1080));
                                                        let _e1094 = select(_e1092, _e1090, (_e1090 > _e1092));
                                                        let _e1096 = select(_e1086, _e1094, (_e1094 > _e1086));
                                                        let _e1098 = select(_e1076, _e1075, (_e1075 > _e1076));
                                                        let _e1100 = select(_e1080, _e1079, (_e1079 > _e1080));
                                                        let _e1102 = select(_e1100, _e1098, (_e1098 < _e1100));
                                                        let _e1104 = select(_e1088, _e1102, (_e1102 < _e1088));
                                                        let _e1105 = -(_e1086);
                                                        let _e1111 = select(_e440, _e1096, (_e1096 > _e440));
                                                        if (_e1111 > (_e1104 + (select(_e1105, _e1088, (_e1088 > _e1105)) * 0.0000019073523f))) {
                                                            phi_3734_ = type_18();
                                                            phi_3735_ = true;
                                                        } else {
                                                            let _e1113 = (_e1111 > _e839.member_1);
                                                            if _e1113 {
                                                                phi_3733_ = type_18();
                                                            } else {
                                                                let _e1117 = (_e975[1][0] - _e975[0][0]);
                                                                let _e1118 = (_e975[1][1] - _e975[0][1]);
                                                                let _e1119 = (_e975[1][2] - _e975[0][2]);
                                                                let _e1120 = vec3<f32>(_e1117, _e1118, _e1119);
                                                                let _e1121 = (_e975[2][0] - _e975[1][0]);
                                                                let _e1122 = (_e975[2][1] - _e975[1][1]);
                                                                let _e1123 = (_e975[2][2] - _e975[1][2]);
                                                                let _e1124 = vec3<f32>(_e1121, _e1122, _e1123);
                                                                let _e1125 = (_e975[0][0] - _e975[2][0]);
                                                                let _e1126 = (_e975[0][1] - _e975[2][1]);
                                                                let _e1127 = (_e975[0][2] - _e975[2][2]);
                                                                let _e1128 = vec3<f32>(_e1125, _e1126, _e1127);
                                                                let _e1131 = bitcast<f32>((bitcast<u32>(_e1117) & 2147483647u));
                                                                let _e1134 = bitcast<f32>((bitcast<u32>(_e1118) & 2147483647u));
                                                                let _e1136 = select(_e1134, _e1131, (_e1131 > _e1134));
                                                                let _e1139 = bitcast<f32>((bitcast<u32>(_e1119) & 2147483647u));
                                                                let _e1141 = select(_e1139, _e1136, (_e1136 > _e1139));
                                                                let _e1144 = bitcast<f32>((bitcast<u32>(_e1121) & 2147483647u));
                                                                let _e1147 = bitcast<f32>((bitcast<u32>(_e1122) & 2147483647u));
                                                                let _e1149 = select(_e1147, _e1144, (_e1144 > _e1147));
                                                                let _e1152 = bitcast<f32>((bitcast<u32>(_e1123) & 2147483647u));
                                                                let _e1154 = select(_e1152, _e1149, (_e1149 > _e1152));
                                                                let _e1157 = bitcast<f32>((bitcast<u32>(_e1125) & 2147483647u));
                                                                let _e1160 = bitcast<f32>((bitcast<u32>(_e1126) & 2147483647u));
                                                                let _e1162 = select(_e1160, _e1157, (_e1157 > _e1160));
                                                                let _e1165 = bitcast<f32>((bitcast<u32>(_e1127) & 2147483647u));
                                                                let _e1167 = select(_e1165, _e1162, (_e1162 > _e1165));
                                                                let _e1169 = select(_e1154, _e1141, (_e1141 > _e1154));
                                                                let _e1171 = select(_e1167, _e1169, (_e1169 > _e1167));
                                                                if (_e1141 == _e1171) {
                                                                    phi_3644_ = _e1124;
                                                                    phi_3645_ = _e1128;
                                                                } else {
                                                                    let _e1174 = vec3((_e1154 == _e1171));
                                                                    phi_3644_ = select(_e1120, _e1128, _e1174);
                                                                    phi_3645_ = select(_e1124, _e1120, _e1174);
                                                                }
                                                                let _e1178 = phi_3644_;
                                                                let _e1180 = phi_3645_;
                                                                let _e1187 = ((_e1178.y * _e1180.z) - (_e1180.y * _e1178.z));
                                                                let _e1192 = ((_e1178.z * _e1180.x) - (_e1180.z * _e1178.x));
                                                                let _e1195 = ((_e1178.x * _e1180.y) - (_e1180.x * _e1178.y));
                                                                if (_e1037 >= _e1041) {
                                                                    phi_3676_ = select(true, false, (_e1037 >= _e1045));
                                                                } else {
                                                                    phi_3676_ = true;
                                                                }
                                                                let _e1200 = phi_3676_;
                                                                if _e1200 {
                                                                    phi_3685_ = select(vec3<f32>(_e975[2][0], _e975[2][1], _e975[2][2]), vec3<f32>(_e975[1][0], _e975[1][1], _e975[1][2]), vec3((_e1041 >= _e1045)));
                                                                } else {
                                                                    phi_3685_ = vec3<f32>(_e975[0][0], _e975[0][1], _e975[0][2]);
                                                                }
                                                                let _e1205 = phi_3685_;
                                                                let _e1222 = ((((_e1187 * (_e1205.x - _e289)) + (_e1192 * (_e1205.y - _e328))) + (_e1195 * (_e1205.z - _e366))) / (((_e1187 * _e314) + (_e1192 * _e352)) + (_e1195 * _e390)));
                                                                let _e1224 = select(_e1104, _e1222, (_e1222 < _e1104));
                                                                let _e1226 = select(_e1096, _e1224, (_e1224 > _e1096));
                                                                if (_e1226 >= _e440) {
                                                                    let _e1228 = (_e1226 <= _e839.member_1);
                                                                    if _e1228 {
                                                                        let _e1229 = (1f / _e1047);
                                                                        phi_3725_ = type_18(_e1226, (_e1041 * _e1229), (_e1045 * _e1229), _e877);
                                                                    } else {
                                                                        phi_3725_ = type_18();
                                                                    }
                                                                    let _e1234 = phi_3725_;
                                                                    phi_3727_ = _e1234;
                                                                    phi_3728_ = select(true, false, _e1228);
                                                                } else {
                                                                    phi_3727_ = type_18();
                                                                    phi_3728_ = true;
                                                                }
                                                                let _e1237 = phi_3727_;
                                                                let _e1239 = phi_3728_;
                                                                if _e1239 {
                                                                    phi_3732_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3732_ = _e1237;
                                                                }
                                                                let _e1241 = phi_3732_;
                                                                phi_3733_ = _e1241;
                                                            }
                                                            let _e1243 = phi_3733_;
                                                            phi_3734_ = _e1243;
                                                            phi_3735_ = _e1113;
                                                        }
                                                        let _e1245 = phi_3734_;
                                                        let _e1247 = phi_3735_;
                                                        phi_3739_ = _e1245;
                                                        phi_3740_ = _e1247;
                                                    }
                                                    let _e1249 = phi_3739_;
                                                    let _e1251 = phi_3740_;
                                                    phi_3744_ = _e1249;
                                                    phi_3745_ = _e1251;
                                                } else {
                                                    phi_3744_ = type_18();
                                                    phi_3745_ = true;
                                                }
                                                let _e1253 = phi_3744_;
                                                let _e1255 = phi_3745_;
                                                if _e1255 {
                                                    phi_3749_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3749_ = _e1253;
                                                }
                                                let _e1257 = phi_3749_;
                                                if (_e1257.member_3 != 4294967295u) {
                                                    if (_e877 != 4294967295u) {
                                                        if (_e1257.member < _e839.member.member) {
                                                            phi_3775_ = true;
                                                        } else {
                                                            if (_e1257.member == _e839.member.member) {
                                                                phi_3774_ = (_e1257.member_3 < _e839.member.member_3);
                                                            } else {
                                                                phi_3774_ = false;
                                                            }
                                                            let _e1270 = phi_3774_;
                                                            phi_3775_ = _e1270;
                                                        }
                                                        let _e1272 = phi_3775_;
                                                        if _e1272 {
                                                            phi_3781_ = type_28(_e1257, _e1257.member);
                                                        } else {
                                                            phi_3781_ = _e839;
                                                        }
                                                        let _e1275 = phi_3781_;
                                                        phi_3782_ = _e1275;
                                                    } else {
                                                        phi_3782_ = _e839;
                                                    }
                                                    let _e1277 = phi_3782_;
                                                    phi_3783_ = _e1277;
                                                } else {
                                                    phi_3783_ = _e839;
                                                }
                                                let _e1279 = phi_3783_;
                                                phi_4848_ = _e974;
                                                phi_2921_ = _e1279;
                                            } else {
                                                phi_4848_ = _e837;
                                                phi_2921_ = type_28();
                                            }
                                            let _e1281 = phi_4848_;
                                            let _e1283 = phi_2921_;
                                            continue;
                                            continuing {
                                                phi_4842_ = _e1281;
                                                phi_2920_ = _e1283;
                                                phi_2923_ = _e854;
                                                phi_4847_ = _e1281;
                                                break if !(_e860);
                                            }
                                        }
                                        let _e1286 = phi_4847_;
                                        phi_4906_ = _e1286;
                                        if _e1286 {
                                            break;
                                        }
                                        phi_4910_ = _e1286;
                                        let _e1472 = local_18;
                                        phi_4627_ = _e1472;
                                        phi_4628_ = _e511;
                                        phi_4629_ = false;
                                        phi_4630_ = _e515;
                                    } else {
                                        local_3 = array<f32, 3>(_e511.member.member[0], _e511.member.member[1], _e511.member.member[2]);
                                        local_2 = array<f32, 3>(_e511.member.member_1[0], _e511.member.member_1[1], _e511.member.member_1[2]);
                                        let _e535 = (_e511.member_1 < _e85);
                                        if _e535 {
                                            if _e535 {
                                            } else {
                                                phi_4906_ = true;
                                                break;
                                            }
                                            let _e537 = global_4.member[_e511.member_1];
                                            phi_3817_ = _e537;
                                        } else {
                                            phi_3817_ = type_36(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e539 = phi_3817_;
                                        let _e541 = array<u32, 3>(_e248, _e247, _e249);
                                        local_11 = _e541;
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        local_6 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3826_ = type_4(0u, 3u);
                                        loop {
                                            let _e543 = phi_3826_;
                                            if (_e543.member < _e543.member_1) {
                                                phi_3827_ = type_4((_e543.member + 1u), _e543.member_1);
                                                phi_3850_ = type_4(1u, _e543.member);
                                            } else {
                                                phi_3827_ = _e543;
                                                phi_3850_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e556 = phi_3827_;
                                            let _e558 = phi_3850_;
                                            let _e562 = (bitcast<i32>(_e558.member) != 0i);
                                            if _e562 {
                                                let _e563 = (_e558.member_1 < 3u);
                                                if _e563 {
                                                } else {
                                                    phi_4769_ = true;
                                                    break;
                                                }
                                                let _e565 = local_11[_e558.member_1];
                                                if _e563 {
                                                } else {
                                                    phi_4769_ = true;
                                                    break;
                                                }
                                                let _e567 = local_3[_e558.member_1];
                                                if _e563 {
                                                } else {
                                                    phi_4769_ = true;
                                                    break;
                                                }
                                                let _e569 = local_2[_e558.member_1];
                                                let _e572 = ((10u * _e565) & 31u);
                                                let _e575 = ((_e539.member[0] >> bitcast<u32>(_e572)) & 1023u);
                                                let _e580 = bitcast<f32>((bitcast<u32>(((_e569 - _e567) * 0.0009775171f)) ^ _e120));
                                                let _e586 = (_e567 + bitcast<f32>((bitcast<u32>((f32(_e575) * _e580)) ^ _e120)));
                                                if _e563 {
                                                } else {
                                                    phi_4769_ = true;
                                                    break;
                                                }
                                                local_7[_e558.member_1] = select(select(_e569, _e586, (_e586 < _e569)), _e569, (_e575 == 1023u));
                                                let _e595 = ((_e539.member[1] >> bitcast<u32>(_e572)) & 1023u);
                                                let _e601 = (_e567 + bitcast<f32>((bitcast<u32>((f32(_e595) * _e580)) ^ _e120)));
                                                if _e563 {
                                                } else {
                                                    phi_4769_ = true;
                                                    break;
                                                }
                                                local_6[_e558.member_1] = select(select(_e569, _e601, (_e601 < _e569)), _e569, (_e595 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3826_ = _e556;
                                                phi_4769_ = _e472;
                                                break if !(_e562);
                                            }
                                        }
                                        let _e609 = phi_4769_;
                                        phi_4906_ = _e609;
                                        if _e609 {
                                            break;
                                        }
                                        let _e610 = local_6;
                                        let _e611 = local_7;
                                        local_10 = _e541;
                                        local_9 = array<f32, 3>(0f, 0f, 0f);
                                        local_8 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3980_ = type_4(0u, 3u);
                                        loop {
                                            let _e620 = phi_3980_;
                                            if (_e620.member < _e620.member_1) {
                                                phi_3981_ = type_4((_e620.member + 1u), _e620.member_1);
                                                phi_4004_ = type_4(1u, _e620.member);
                                            } else {
                                                phi_3981_ = _e620;
                                                phi_4004_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e633 = phi_3981_;
                                            let _e635 = phi_4004_;
                                            let _e639 = (bitcast<i32>(_e635.member) != 0i);
                                            if _e639 {
                                                let _e640 = (_e635.member_1 < 3u);
                                                if _e640 {
                                                } else {
                                                    phi_4825_ = true;
                                                    break;
                                                }
                                                let _e642 = local_10[_e635.member_1];
                                                if _e640 {
                                                } else {
                                                    phi_4825_ = true;
                                                    break;
                                                }
                                                let _e644 = local_3[_e635.member_1];
                                                if _e640 {
                                                } else {
                                                    phi_4825_ = true;
                                                    break;
                                                }
                                                let _e646 = local_2[_e635.member_1];
                                                let _e649 = ((10u * _e642) & 31u);
                                                let _e652 = ((_e539.member_1[0] >> bitcast<u32>(_e649)) & 1023u);
                                                let _e657 = bitcast<f32>((bitcast<u32>(((_e646 - _e644) * 0.0009775171f)) ^ _e120));
                                                let _e663 = (_e644 + bitcast<f32>((bitcast<u32>((f32(_e652) * _e657)) ^ _e120)));
                                                if _e640 {
                                                } else {
                                                    phi_4825_ = true;
                                                    break;
                                                }
                                                local_9[_e635.member_1] = select(select(_e646, _e663, (_e663 < _e646)), _e646, (_e652 == 1023u));
                                                let _e672 = ((_e539.member_1[1] >> bitcast<u32>(_e649)) & 1023u);
                                                let _e678 = (_e644 + bitcast<f32>((bitcast<u32>((f32(_e672) * _e657)) ^ _e120)));
                                                if _e640 {
                                                } else {
                                                    phi_4825_ = true;
                                                    break;
                                                }
                                                local_8[_e635.member_1] = select(select(_e646, _e678, (_e678 < _e646)), _e646, (_e672 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3980_ = _e633;
                                                phi_4825_ = _e609;
                                                break if !(_e639);
                                            }
                                        }
                                        let _e686 = phi_4825_;
                                        phi_4906_ = _e686;
                                        if _e686 {
                                            break;
                                        }
                                        let _e687 = local_8;
                                        let _e688 = local_9;
                                        let _e699 = type_50(type_41(array<f32, 3>(_e611[0], _e611[1], _e611[2]), array<f32, 3>(_e610[0], _e610[1], _e610[2])), _e539.member_2);
                                        let _e704 = type_50(type_41(array<f32, 3>(_e688[0], _e688[1], _e688[2]), array<f32, 3>(_e687[0], _e687[1], _e687[2])), _e539.member_3);
                                        let _e710 = ((_e611[0] - _e312) * _e317);
                                        let _e711 = ((_e688[0] - _e312) * _e317);
                                        let _e712 = ((_e610[0] - _e313) * _e317);
                                        let _e713 = ((_e687[0] - _e313) * _e317);
                                        let _e718 = ((_e611[1] - _e350) * _e355);
                                        let _e719 = ((_e688[1] - _e350) * _e355);
                                        let _e720 = ((_e610[1] - _e351) * _e355);
                                        let _e721 = ((_e687[1] - _e351) * _e355);
                                        let _e726 = ((_e611[2] - _e388) * _e393);
                                        let _e727 = ((_e688[2] - _e388) * _e393);
                                        let _e728 = ((_e610[2] - _e389) * _e393);
                                        let _e729 = ((_e687[2] - _e389) * _e393);
                                        let _e731 = select(_e728, _e726, (_e726 < _e728));
                                        let _e733 = select(_e729, _e727, (_e727 < _e729));
                                        let _e735 = select(_e728, _e726, (_e726 > _e728));
                                        let _e737 = select(_e729, _e727, (_e727 > _e729));
                                        let _e739 = select(_e712, _e710, (_e710 < _e712));
                                        let _e741 = select(_e713, _e711, (_e711 < _e713));
                                        let _e743 = select(_e720, _e718, (_e718 < _e720));
                                        let _e745 = select(_e721, _e719, (_e719 < _e721));
                                        let _e747 = select(_e743, _e739, (_e739 > _e743));
                                        let _e749 = select(_e745, _e741, (_e741 > _e745));
                                        let _e751 = select(_e731, _e747, (_e747 > _e731));
                                        let _e753 = select(_e733, _e749, (_e749 > _e733));
                                        let _e755 = select(_e712, _e710, (_e710 > _e712));
                                        let _e757 = select(_e713, _e711, (_e711 > _e713));
                                        let _e759 = select(_e720, _e718, (_e718 > _e720));
                                        let _e761 = select(_e721, _e719, (_e719 > _e721));
                                        let _e763 = select(_e759, _e755, (_e755 < _e759));
                                        let _e765 = select(_e761, _e757, (_e757 < _e761));
                                        let _e770 = -(_e731);
                                        let _e771 = -(_e733);
                                        let _e778 = (select(_e735, _e763, (_e763 < _e735)) + (select(_e770, _e735, (_e735 > _e770)) * 0.0000019073523f));
                                        let _e779 = (select(_e737, _e765, (_e765 < _e737)) + (select(_e771, _e737, (_e737 > _e771)) * 0.0000019073523f));
                                        let _e781 = select(_e440, _e751, (_e751 > _e440));
                                        let _e783 = select(_e440, _e753, (_e753 > _e440));
                                        let _e788 = (_e781 <= select(_e474.member_1, _e778, (_e778 < _e474.member_1)));
                                        let _e789 = (_e783 <= select(_e474.member_1, _e779, (_e779 < _e474.member_1)));
                                        let _e790 = (_e781 <= _e783);
                                        if _e788 {
                                            if _e789 {
                                                if _e790 {
                                                    phi_4567_ = _e704;
                                                } else {
                                                    phi_4567_ = _e699;
                                                }
                                                let _e792 = phi_4567_;
                                                let _e793 = (_e515 % 128u);
                                                let _e794 = (_e793 < 128u);
                                                if _e794 {
                                                } else {
                                                    phi_4906_ = true;
                                                    break;
                                                }
                                                local_5[_e793] = type_50(type_41(array<f32, 3>(_e792.member.member[0], _e792.member.member[1], _e792.member.member[2]), array<f32, 3>(_e792.member.member_1[0], _e792.member.member_1[1], _e792.member.member_1[2])), _e792.member_1);
                                                if _e794 {
                                                } else {
                                                    phi_4906_ = true;
                                                    break;
                                                }
                                                local_4[_e793] = select(_e783, _e781, (_e781 > _e783));
                                                if _e790 {
                                                    phi_4606_ = _e699;
                                                } else {
                                                    phi_4606_ = _e704;
                                                }
                                                let _e815 = phi_4606_;
                                                phi_4607_ = _e815;
                                                phi_4608_ = (_e515 + 1u);
                                            } else {
                                                phi_4607_ = type_50();
                                                phi_4608_ = u32();
                                            }
                                            let _e817 = phi_4607_;
                                            let _e819 = phi_4608_;
                                            phi_4610_ = _e817;
                                            phi_4611_ = _e819;
                                            phi_4612_ = select(true, false, _e789);
                                        } else {
                                            phi_4610_ = type_50();
                                            phi_4611_ = u32();
                                            phi_4612_ = true;
                                        }
                                        let _e822 = phi_4610_;
                                        let _e824 = phi_4611_;
                                        let _e826 = phi_4612_;
                                        if _e826 {
                                            if _e788 {
                                                phi_4619_ = _e699;
                                            } else {
                                                phi_4619_ = _e704;
                                            }
                                            let _e828 = phi_4619_;
                                            phi_4624_ = _e828;
                                            phi_4625_ = select(_e789, true, _e788);
                                        } else {
                                            phi_4624_ = _e822;
                                            phi_4625_ = _e513;
                                        }
                                        let _e831 = phi_4624_;
                                        let _e833 = phi_4625_;
                                        phi_4910_ = _e686;
                                        phi_4627_ = _e474;
                                        phi_4628_ = _e831;
                                        phi_4629_ = _e833;
                                        phi_4630_ = select(_e824, _e515, _e826);
                                    }
                                    let _e1288 = phi_4910_;
                                    let _e1290 = phi_4627_;
                                    let _e1292 = phi_4628_;
                                    let _e1294 = phi_4629_;
                                    let _e1296 = phi_4630_;
                                    phi_4909_ = _e1288;
                                    phi_4631_ = _e1290;
                                    phi_4632_ = _e1292;
                                    phi_4633_ = (_e478 - 1u);
                                    phi_4634_ = _e1294;
                                    phi_4635_ = _e1296;
                                } else {
                                    phi_4909_ = _e472;
                                    phi_4631_ = _e474;
                                    phi_4632_ = _e511;
                                    phi_4633_ = _e478;
                                    phi_4634_ = _e513;
                                    phi_4635_ = _e515;
                                }
                                let _e1298 = phi_4909_;
                                let _e1300 = phi_4631_;
                                let _e1302 = phi_4632_;
                                let _e1304 = phi_4633_;
                                let _e1306 = phi_4634_;
                                let _e1308 = phi_4635_;
                                phi_4908_ = _e1298;
                                phi_4636_ = _e1300;
                                phi_4637_ = _e1302;
                                phi_4638_ = _e1304;
                                phi_4639_ = _e1306;
                                phi_4640_ = _e1308;
                            } else {
                                phi_4908_ = _e472;
                                phi_4636_ = type_28();
                                phi_4637_ = type_50();
                                phi_4638_ = u32();
                                phi_4639_ = bool();
                                phi_4640_ = u32();
                            }
                            let _e1310 = phi_4908_;
                            let _e1312 = phi_4636_;
                            let _e1314 = phi_4637_;
                            let _e1316 = phi_4638_;
                            let _e1318 = phi_4639_;
                            let _e1320 = phi_4640_;
                            phi_4907_ = _e1310;
                            phi_2835_ = _e1312;
                            phi_2838_ = _e1314;
                            phi_2840_ = _e1316;
                            phi_2842_ = _e1318;
                            phi_2844_ = _e1320;
                            phi_4641_ = _e486;
                        } else {
                            phi_4907_ = _e472;
                            phi_2835_ = type_28();
                            phi_2838_ = type_50();
                            phi_2840_ = u32();
                            phi_2842_ = bool();
                            phi_2844_ = u32();
                            phi_4641_ = false;
                        }
                        let _e1322 = phi_4907_;
                        let _e1324 = phi_2835_;
                        let _e1326 = phi_2838_;
                        let _e1328 = phi_2840_;
                        let _e1330 = phi_2842_;
                        let _e1332 = phi_2844_;
                        let _e1334 = phi_4641_;
                        continue;
                        continuing {
                            phi_4776_ = _e1322;
                            phi_2834_ = _e1324;
                            phi_2837_ = _e1326;
                            phi_2839_ = _e1328;
                            phi_2841_ = _e1330;
                            phi_2843_ = _e1332;
                            phi_4906_ = _e1322;
                            break if !(_e1334);
                        }
                    }
                    let _e1337 = phi_4906_;
                    if _e1337 {
                        break;
                    }
                    let _e1339 = local_17;
                    if (_e1339.member.member_3 != 4294967295u) {
                        let _e1344 = -(_e407);
                        let _e1345 = (_e1344 / 3i);
                        let _e1352 = bitcast<f32>((bitcast<u32>((_e1345 + 127i)) << bitcast<u32>(23i)));
                        let _e1360 = (((_e1339.member.member * _e1352) * _e1352) * bitcast<f32>((bitcast<u32>(((_e1344 - (2i * _e1345)) + 127i)) << bitcast<u32>(23i))));
                        let _e1362 = select(340282350000000000000000000000000000000f, _e1360, (_e1360 < 340282350000000000000000000000000000000f));
                        phi_4693_ = type_18(select(-340282350000000000000000000000000000000f, _e1362, (_e1362 > -340282350000000000000000000000000000000f)), _e1339.member.member_1, _e1339.member.member_2, _e1339.member.member_3);
                    } else {
                        phi_4693_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1369 = phi_4693_;
                    if _e136 {
                    } else {
                        break;
                    }
                    global_5.member[_e134] = _e1369;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
