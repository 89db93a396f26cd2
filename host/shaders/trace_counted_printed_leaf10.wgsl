struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<array<u32, 2>>,
}

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: type_21,
    member_1: f32,
}

struct type_30 {
    member: array<type_22>,
}

struct type_32 {
    member: type_27,
    member_1: u32,
    member_2: u32,
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
var<storage> global_3: type_30;
@group(0) @binding(2) 
var<storage> global_4: type_38;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_17;
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
    var phi_343_: i32;
    var phi_344_: i32;
    var phi_354_: bool;
    var phi_364_: u32;
    var phi_365_: u32;
    var phi_367_: bool;
    var phi_372_: u32;
    var phi_417_: f32;
    var phi_423_: f32;
    var phi_434_: f32;
    var phi_440_: f32;
    var phi_463_: f32;
    var phi_474_: f32;
    var phi_483_: f32;
    var phi_489_: f32;
    var phi_500_: f32;
    var phi_506_: f32;
    var phi_529_: f32;
    var phi_540_: f32;
    var phi_549_: f32;
    var phi_555_: f32;
    var phi_566_: f32;
    var phi_572_: f32;
    var phi_595_: f32;
    var phi_606_: f32;
    var phi_706_: f32;
    var phi_707_: f32;
    var phi_4741_: bool;
    var phi_2836_: type_32;
    var phi_2839_: type_50;
    var phi_2841_: u32;
    var phi_2843_: bool;
    var phi_2845_: u32;
    var phi_2856_: bool;
    var phi_2901_: type_50;
    var phi_2902_: bool;
    var phi_2903_: u32;
    var phi_3826_: type_36;
    var phi_3835_: type_4;
    var phi_3836_: type_4;
    var phi_3859_: type_4;
    var phi_4734_: bool;
    var phi_3989_: type_4;
    var phi_3990_: type_4;
    var phi_4013_: type_4;
    var phi_4790_: bool;
    var phi_4576_: type_50;
    var phi_4615_: type_50;
    var phi_4616_: type_50;
    var phi_4617_: u32;
    var phi_4619_: type_50;
    var phi_4620_: u32;
    var phi_4621_: bool;
    var phi_4628_: type_50;
    var phi_4633_: type_50;
    var phi_4634_: bool;
    var phi_4807_: bool;
    var phi_2922_: type_32;
    var phi_2925_: type_4;
    var phi_2926_: type_4;
    var phi_2948_: type_4;
    var phi_2993_: u32;
    var phi_3017_: type_44;
    var phi_4803_: bool;
    var phi_3028_: type_4;
    var phi_3029_: type_4;
    var phi_3052_: type_4;
    var phi_3062_: type_4;
    var phi_3063_: type_4;
    var phi_3086_: type_4;
    var phi_4798_: bool;
    var phi_4811_: bool;
    var phi_4810_: bool;
    var phi_3649_: vec3<f32>;
    var phi_3650_: vec3<f32>;
    var phi_3681_: bool;
    var phi_3690_: vec3<f32>;
    var phi_3730_: type_21;
    var phi_3732_: type_21;
    var phi_3733_: bool;
    var phi_3737_: type_21;
    var phi_3738_: type_21;
    var phi_3739_: type_21;
    var phi_3740_: bool;
    var phi_3744_: type_21;
    var phi_3745_: bool;
    var phi_3749_: type_21;
    var phi_3750_: bool;
    var phi_3754_: type_21;
    var phi_3779_: bool;
    var phi_3780_: bool;
    var phi_3787_: type_32;
    var phi_3788_: type_32;
    var phi_3789_: type_32;
    var phi_4813_: bool;
    var phi_2923_: type_32;
    var phi_4812_: bool;
    var phi_4875_: bool;
    var phi_4636_: type_32;
    var phi_4637_: type_50;
    var phi_4638_: bool;
    var phi_4639_: u32;
    var phi_4874_: bool;
    var phi_4640_: type_32;
    var phi_4641_: type_50;
    var phi_4642_: u32;
    var phi_4643_: bool;
    var phi_4644_: u32;
    var phi_4873_: bool;
    var phi_4645_: type_32;
    var phi_4646_: type_50;
    var phi_4647_: u32;
    var phi_4648_: bool;
    var phi_4649_: u32;
    var phi_4872_: bool;
    var phi_2837_: type_32;
    var phi_2840_: type_50;
    var phi_2842_: u32;
    var phi_2844_: bool;
    var phi_2846_: u32;
    var phi_4650_: bool;
    var phi_4871_: bool;
    var local_17: type_32;
    var local_18: type_32;
    var local_19: type_32;

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
                            phi_343_ = (bitcast<i32>((_e213 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_343_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e213)), 32u, (_e213 == 0u))));
                        }
                        let _e227 = phi_343_;
                        phi_344_ = _e227;
                    } else {
                        phi_344_ = 0i;
                    }
                    let _e229 = phi_344_;
                    let _e230 = (_e146 == _e185);
                    if _e230 {
                        phi_354_ = true;
                    } else {
                        phi_354_ = (_e153 == _e185);
                    }
                    let _e233 = phi_354_;
                    let _e234 = select(1u, 0u, _e230);
                    if _e233 {
                        let _e235 = (_e234 + 1u);
                        phi_364_ = _e235;
                        phi_365_ = _e235;
                        phi_367_ = select(true, false, (_e235 == 2u));
                    } else {
                        phi_364_ = u32();
                        phi_365_ = 0u;
                        phi_367_ = true;
                    }
                    let _e239 = phi_364_;
                    let _e241 = phi_365_;
                    let _e243 = phi_367_;
                    if _e243 {
                        phi_372_ = (_e241 + 1u);
                    } else {
                        phi_372_ = 0u;
                    }
                    let _e247 = phi_372_;
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
                        phi_417_ = _e278[0];
                    } else {
                        phi_417_ = _e278[1];
                    }
                    let _e283 = phi_417_;
                    let _e284 = (_e248 == 2u);
                    if _e284 {
                        phi_423_ = _e278[2];
                    } else {
                        phi_423_ = _e283;
                    }
                    let _e287 = phi_423_;
                    let _e289 = ((_e287 * _e255) * _e261);
                    let _e290 = global_3.member[_e134].member_2;
                    if _e279 {
                        phi_434_ = _e290[0];
                    } else {
                        phi_434_ = _e290[1];
                    }
                    let _e294 = phi_434_;
                    if _e284 {
                        phi_440_ = _e290[2];
                    } else {
                        phi_440_ = _e294;
                    }
                    let _e297 = phi_440_;
                    let _e299 = ((_e297 * _e268) * _e274);
                    let _e303 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e303 {
                        let _e307 = (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) * 0.00000011920929f);
                        phi_463_ = select(0.00000000000011368684f, _e307, (_e307 > 0.00000000000011368684f));
                    } else {
                        phi_463_ = 0f;
                    }
                    let _e311 = phi_463_;
                    let _e312 = (_e289 + _e311);
                    let _e313 = (_e289 - _e311);
                    let _e314 = select(_e299, 0f, _e303);
                    if _e303 {
                        phi_474_ = 38685626000000000000000000f;
                    } else {
                        phi_474_ = (1f / _e299);
                    }
                    let _e317 = phi_474_;
                    let _e318 = (_e247 == 0u);
                    if _e318 {
                        phi_483_ = _e278[0];
                    } else {
                        phi_483_ = _e278[1];
                    }
                    let _e322 = phi_483_;
                    let _e323 = (_e247 == 2u);
                    if _e323 {
                        phi_489_ = _e278[2];
                    } else {
                        phi_489_ = _e322;
                    }
                    let _e326 = phi_489_;
                    let _e328 = ((_e326 * _e255) * _e261);
                    if _e318 {
                        phi_500_ = _e290[0];
                    } else {
                        phi_500_ = _e290[1];
                    }
                    let _e332 = phi_500_;
                    if _e323 {
                        phi_506_ = _e290[2];
                    } else {
                        phi_506_ = _e332;
                    }
                    let _e335 = phi_506_;
                    let _e337 = ((_e335 * _e268) * _e274);
                    let _e341 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e341 {
                        let _e345 = (bitcast<f32>((bitcast<u32>(_e328) & 2147483647u)) * 0.00000011920929f);
                        phi_529_ = select(0.00000000000011368684f, _e345, (_e345 > 0.00000000000011368684f));
                    } else {
                        phi_529_ = 0f;
                    }
                    let _e349 = phi_529_;
                    let _e350 = (_e328 + _e349);
                    let _e351 = (_e328 - _e349);
                    let _e352 = select(_e337, 0f, _e341);
                    if _e341 {
                        phi_540_ = 38685626000000000000000000f;
                    } else {
                        phi_540_ = (1f / _e337);
                    }
                    let _e355 = phi_540_;
                    let _e356 = (_e249 == 0u);
                    if _e356 {
                        phi_549_ = _e278[0];
                    } else {
                        phi_549_ = _e278[1];
                    }
                    let _e360 = phi_549_;
                    let _e361 = (_e249 == 2u);
                    if _e361 {
                        phi_555_ = _e278[2];
                    } else {
                        phi_555_ = _e360;
                    }
                    let _e364 = phi_555_;
                    let _e366 = ((_e364 * _e255) * _e261);
                    if _e356 {
                        phi_566_ = _e290[0];
                    } else {
                        phi_566_ = _e290[1];
                    }
                    let _e370 = phi_566_;
                    if _e361 {
                        phi_572_ = _e290[2];
                    } else {
                        phi_572_ = _e370;
                    }
                    let _e373 = phi_572_;
                    let _e375 = ((_e373 * _e268) * _e274);
                    let _e379 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e379 {
                        let _e383 = (bitcast<f32>((bitcast<u32>(_e366) & 2147483647u)) * 0.00000011920929f);
                        phi_595_ = select(0.00000000000011368684f, _e383, (_e383 > 0.00000000000011368684f));
                    } else {
                        phi_595_ = 0f;
                    }
                    let _e387 = phi_595_;
                    let _e388 = (_e366 + _e387);
                    let _e389 = (_e366 - _e387);
                    let _e390 = select(_e375, 0f, _e379);
                    if _e379 {
                        phi_606_ = 38685626000000000000000000f;
                    } else {
                        phi_606_ = (1f / _e375);
                    }
                    let _e393 = phi_606_;
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
                        phi_706_ = select(-340282350000000000000000000000000000000f, _e434, (_e434 > -340282350000000000000000000000000000000f));
                        phi_707_ = select(-340282350000000000000000000000000000000f, _e427, (_e427 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_706_ = 0f;
                        phi_707_ = 1f;
                    }
                    let _e438 = phi_706_;
                    let _e440 = phi_707_;
                    local_5 = array<type_50, 128>(type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_16 = array<f32, 3>(bitcast<f32>(_e96), bitcast<f32>(_e100), bitcast<f32>(_e104));
                    let _e446 = (_e248 % 3u);
                    let _e447 = (_e446 < 3u);
                    if _e447 {
                    } else {
                        break;
                    }
                    let _e449 = local_16[_e446];
                    let _e450 = (_e247 % 3u);
                    let _e451 = (_e450 < 3u);
                    if _e451 {
                    } else {
                        break;
                    }
                    let _e453 = local_16[_e450];
                    let _e454 = (_e249 % 3u);
                    let _e455 = (_e454 < 3u);
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e457 = local_16[_e454];
                    local_15 = array<f32, 3>(bitcast<f32>(_e108), bitcast<f32>(_e112), bitcast<f32>(_e116));
                    if _e447 {
                    } else {
                        break;
                    }
                    let _e461 = local_15[_e446];
                    if _e451 {
                    } else {
                        break;
                    }
                    let _e463 = local_15[_e450];
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e465 = local_15[_e454];
                    phi_4741_ = false;
                    phi_2836_ = type_32(type_27(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e438), 0u, 0u);
                    phi_2839_ = type_50(type_41(array<f32, 3>(_e449, _e453, _e457), array<f32, 3>(_e461, _e463, _e465)), select(0u, 2147483648u, (_e85 == 0u)));
                    phi_2841_ = ((3u * _e85) + 1u);
                    phi_2843_ = (_e440 <= _e438);
                    phi_2845_ = 0u;
                    loop {
                        let _e473 = phi_4741_;
                        let _e475 = phi_2836_;
                        let _e477 = phi_2839_;
                        let _e479 = phi_2841_;
                        let _e481 = phi_2843_;
                        let _e483 = phi_2845_;
                        local_17 = _e475;
                        local_18 = _e475;
                        if _e481 {
                            phi_2856_ = true;
                        } else {
                            phi_2856_ = (_e483 > 0u);
                        }
                        let _e486 = phi_2856_;
                        if _e486 {
                            let _e487 = (_e479 > 0u);
                            if _e487 {
                                if _e481 {
                                    phi_2901_ = _e477;
                                    phi_2902_ = _e481;
                                    phi_2903_ = _e483;
                                } else {
                                    let _e488 = (_e483 - 1u);
                                    let _e489 = (_e488 % 128u);
                                    let _e490 = (_e489 < 128u);
                                    if _e490 {
                                    } else {
                                        phi_4871_ = true;
                                        break;
                                    }
                                    let _e492 = local_5[_e489];
                                    if _e490 {
                                    } else {
                                        phi_4871_ = true;
                                        break;
                                    }
                                    let _e508 = local_4[_e489];
                                    phi_2901_ = type_50(type_41(array<f32, 3>(_e492.member.member[0], _e492.member.member[1], _e492.member.member[2]), array<f32, 3>(_e492.member.member_1[0], _e492.member.member_1[1], _e492.member.member_1[2])), _e492.member_1);
                                    phi_2902_ = (_e508 <= _e475.member.member_1);
                                    phi_2903_ = _e488;
                                }
                                let _e513 = phi_2901_;
                                let _e515 = phi_2902_;
                                let _e517 = phi_2903_;
                                if _e515 {
                                    if ((_e513.member_1 & 2147483648u) != 0u) {
                                        phi_4807_ = _e473;
                                        phi_2922_ = _e475;
                                        phi_2925_ = type_4(0u, ((_e513.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e846 = phi_4807_;
                                            let _e848 = phi_2922_;
                                            let _e850 = phi_2925_;
                                            local_19 = _e848;
                                            if (_e850.member < _e850.member_1) {
                                                phi_2926_ = type_4((_e850.member + 1u), _e850.member_1);
                                                phi_2948_ = type_4(1u, _e850.member);
                                            } else {
                                                phi_2926_ = _e850;
                                                phi_2948_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e863 = phi_2926_;
                                            let _e865 = phi_2948_;
                                            let _e869 = (bitcast<i32>(_e865.member) != 0i);
                                            if _e869 {
                                                let _e875 = type_32(_e848.member, _e848.member_1, (_e848.member_2 + 1u));
                                                local_1 = array<f32, 3>(_e513.member.member[0], _e513.member.member[1], _e513.member.member[2]);
                                                local = array<f32, 3>(_e513.member.member_1[0], _e513.member.member_1[1], _e513.member.member_1[2]);
                                                let _e886 = ((_e513.member_1 & 268435455u) + _e865.member_1);
                                                let _e887 = (_e886 < arrayLength((&global_6.member)));
                                                if _e887 {
                                                    if _e887 {
                                                    } else {
                                                        phi_4812_ = true;
                                                        break;
                                                    }
                                                    let _e890 = global_6.member[_e886].member_1;
                                                    phi_2993_ = _e890;
                                                } else {
                                                    phi_2993_ = 4294967295u;
                                                }
                                                let _e892 = phi_2993_;
                                                local_12 = array<u32, 3>(_e248, _e247, _e249);
                                                if _e887 {
                                                    if _e887 {
                                                    } else {
                                                        phi_4812_ = true;
                                                        break;
                                                    }
                                                    let _e895 = global_6.member[_e886];
                                                    phi_3017_ = _e895;
                                                } else {
                                                    phi_3017_ = type_44(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e897 = phi_3017_;
                                                local_14 = array<u32, 3>(_e897.member[0], _e897.member[1], _e897.member[2]);
                                                local_13[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_13[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_13[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4803_ = _e846;
                                                phi_3028_ = type_4(0u, 3u);
                                                loop {
                                                    let _e907 = phi_4803_;
                                                    let _e909 = phi_3028_;
                                                    if (_e909.member < _e909.member_1) {
                                                        phi_3029_ = type_4((_e909.member + 1u), _e909.member_1);
                                                        phi_3052_ = type_4(1u, _e909.member);
                                                    } else {
                                                        phi_3029_ = _e909;
                                                        phi_3052_ = type_4(0u, type_4().member_1);
                                                    }
                                                    let _e922 = phi_3029_;
                                                    let _e924 = phi_3052_;
                                                    let _e928 = (bitcast<i32>(_e924.member) != 0i);
                                                    if _e928 {
                                                        phi_3062_ = type_4(0u, 3u);
                                                        loop {
                                                            let _e930 = phi_3062_;
                                                            if (_e930.member < _e930.member_1) {
                                                                phi_3063_ = type_4((_e930.member + 1u), _e930.member_1);
                                                                phi_3086_ = type_4(1u, _e930.member);
                                                            } else {
                                                                phi_3063_ = _e930;
                                                                phi_3086_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e943 = phi_3063_;
                                                            let _e945 = phi_3086_;
                                                            let _e949 = (bitcast<i32>(_e945.member) != 0i);
                                                            if _e949 {
                                                                let _e950 = (_e924.member_1 < 3u);
                                                                if _e950 {
                                                                } else {
                                                                    phi_4798_ = true;
                                                                    break;
                                                                }
                                                                let _e952 = local_14[_e924.member_1];
                                                                let _e953 = (_e945.member_1 < 3u);
                                                                if _e953 {
                                                                } else {
                                                                    phi_4798_ = true;
                                                                    break;
                                                                }
                                                                let _e955 = local_12[_e945.member_1];
                                                                let _e960 = ((_e952 >> bitcast<u32>(((10u * _e955) & 31u))) & 1023u);
                                                                if _e953 {
                                                                } else {
                                                                    phi_4798_ = true;
                                                                    break;
                                                                }
                                                                let _e962 = local_1[_e945.member_1];
                                                                if _e953 {
                                                                } else {
                                                                    phi_4798_ = true;
                                                                    break;
                                                                }
                                                                let _e964 = local[_e945.member_1];
                                                                let _e975 = (_e962 + bitcast<f32>((bitcast<u32>((f32(_e960) * bitcast<f32>((bitcast<u32>(((_e964 - _e962) * 0.0009775171f)) ^ _e120)))) ^ _e120)));
                                                                if _e950 {
                                                                } else {
                                                                    phi_4798_ = true;
                                                                    break;
                                                                }
                                                                if _e953 {
                                                                } else {
                                                                    phi_4798_ = true;
                                                                    break;
                                                                }
                                                                local_13[_e924.member_1][_e945.member_1] = select(select(_e964, _e975, (_e975 < _e964)), _e964, (_e960 == 1023u));
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_3062_ = _e943;
                                                                phi_4798_ = _e907;
                                                                break if !(_e949);
                                                            }
                                                        }
                                                        let _e984 = phi_4798_;
                                                        phi_4810_ = _e984;
                                                        if _e984 {
                                                            break;
                                                        }
                                                        phi_4811_ = _e984;
                                                    } else {
                                                        phi_4811_ = _e907;
                                                    }
                                                    let _e986 = phi_4811_;
                                                    continue;
                                                    continuing {
                                                        phi_4803_ = _e986;
                                                        phi_3028_ = _e922;
                                                        phi_4810_ = _e986;
                                                        break if !(_e928);
                                                    }
                                                }
                                                let _e989 = phi_4810_;
                                                phi_4812_ = _e989;
                                                if _e989 {
                                                    break;
                                                }
                                                let _e990 = local_13;
                                                let _e1007 = (_e990[0][2] - _e366);
                                                let _e1010 = (((_e990[0][0] - _e289) * _e390) - (_e1007 * _e314));
                                                let _e1013 = (((_e990[0][1] - _e328) * _e390) - (_e1007 * _e352));
                                                let _e1016 = (_e990[1][2] - _e366);
                                                let _e1019 = (((_e990[1][0] - _e289) * _e390) - (_e1016 * _e314));
                                                let _e1022 = (((_e990[1][1] - _e328) * _e390) - (_e1016 * _e352));
                                                let _e1025 = (_e990[2][2] - _e366);
                                                let _e1028 = (((_e990[2][0] - _e289) * _e390) - (_e1025 * _e314));
                                                let _e1031 = (((_e990[2][1] - _e328) * _e390) - (_e1025 * _e352));
                                                let _e1032 = (_e1028 * _e1022);
                                                let _e1033 = (_e1031 * _e1019);
                                                let _e1034 = (_e1010 * _e1031);
                                                let _e1035 = (_e1013 * _e1028);
                                                let _e1036 = (_e1019 * _e1013);
                                                let _e1037 = (_e1022 * _e1010);
                                                let _e1042 = (((_e1032 >= _e1033) && (_e1034 >= _e1035)) && (_e1036 >= _e1037));
                                                if (_e1042 || (((_e1032 <= _e1033) && (_e1034 <= _e1035)) && (_e1036 <= _e1037))) {
                                                    let _e1049 = select(-1f, 1f, _e1042);
                                                    let _e1051 = ((_e1032 - _e1033) * _e1049);
                                                    let _e1053 = select(0f, _e1051, (_e1051 > 0f));
                                                    let _e1055 = ((_e1034 - _e1035) * _e1049);
                                                    let _e1057 = select(0f, _e1055, (_e1055 > 0f));
                                                    let _e1059 = ((_e1036 - _e1037) * _e1049);
                                                    let _e1061 = select(0f, _e1059, (_e1059 > 0f));
                                                    let _e1063 = ((_e1053 + _e1057) + _e1061);
                                                    if (_e1063 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3744_ = type_21();
                                                        phi_3745_ = true;
                                                    } else {
                                                        let _e1066 = select(_e990[1][0], _e990[0][0], (_e990[0][0] < _e990[1][0]));
                                                        let _e1070 = select(_e990[1][0], _e990[0][0], (_e990[0][0] > _e990[1][0]));
                                                        let _e1074 = select(_e990[1][1], _e990[0][1], (_e990[0][1] < _e990[1][1]));
                                                        let _e1078 = select(_e990[1][1], _e990[0][1], (_e990[0][1] > _e990[1][1]));
                                                        let _e1082 = select(_e990[1][2], _e990[0][2], (_e990[0][2] < _e990[1][2]));
                                                        let _e1086 = select(_e990[1][2], _e990[0][2], (_e990[0][2] > _e990[1][2]));
                                                        let _e1091 = ((select(_e990[2][0], _e1066, (_e1066 < _e990[2][0])) - _e312) * _e317);
                                                        let _e1092 = ((select(_e990[2][0], _e1070, (_e1070 > _e990[2][0])) - _e313) * _e317);
                                                        let _e1095 = ((select(_e990[2][1], _e1074, (_e1074 < _e990[2][1])) - _e350) * _e355);
                                                        let _e1096 = ((select(_e990[2][1], _e1078, (_e1078 > _e990[2][1])) - _e351) * _e355);
                                                        let _e1099 = ((select(_e990[2][2], _e1082, (_e1082 < _e990[2][2])) - _e388) * _e393);
                                                        let _e1100 = ((select(_e990[2][2], _e1086, (_e1086 > _e990[2][2])) - _e389) * _e393);
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
                                                        let _e1127 = select(_e440, _e1112, (_e1112 > _e440));
                                                        if (_e1127 > (_e1120 + (select(_e1121, _e1104, (_e1104 > _e1121)) * 0.0000019073523f))) {
                                                            phi_3739_ = type_21();
                                                            phi_3740_ = true;
                                                        } else {
                                                            let _e1129 = (_e1127 > _e848.member.member_1);
                                                            if _e1129 {
                                                                phi_3738_ = type_21();
                                                            } else {
                                                                let _e1133 = (_e990[1][0] - _e990[0][0]);
                                                                let _e1134 = (_e990[1][1] - _e990[0][1]);
                                                                let _e1135 = (_e990[1][2] - _e990[0][2]);
                                                                let _e1136 = vec3<f32>(_e1133, _e1134, _e1135);
                                                                let _e1137 = (_e990[2][0] - _e990[1][0]);
                                                                let _e1138 = (_e990[2][1] - _e990[1][1]);
                                                                let _e1139 = (_e990[2][2] - _e990[1][2]);
                                                                let _e1140 = vec3<f32>(_e1137, _e1138, _e1139);
                                                                let _e1141 = (_e990[0][0] - _e990[2][0]);
                                                                let _e1142 = (_e990[0][1] - _e990[2][1]);
                                                                let _e1143 = (_e990[0][2] - _e990[2][2]);
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
                                                                    phi_3649_ = _e1140;
                                                                    phi_3650_ = _e1144;
                                                                } else {
                                                                    let _e1190 = vec3((_e1170 == _e1187));
                                                                    phi_3649_ = select(_e1136, _e1144, _e1190);
                                                                    phi_3650_ = select(_e1140, _e1136, _e1190);
                                                                }
                                                                let _e1194 = phi_3649_;
                                                                let _e1196 = phi_3650_;
                                                                let _e1203 = ((_e1194.y * _e1196.z) - (_e1196.y * _e1194.z));
                                                                let _e1208 = ((_e1194.z * _e1196.x) - (_e1196.z * _e1194.x));
                                                                let _e1211 = ((_e1194.x * _e1196.y) - (_e1196.x * _e1194.y));
                                                                if (_e1053 >= _e1057) {
                                                                    phi_3681_ = select(true, false, (_e1053 >= _e1061));
                                                                } else {
                                                                    phi_3681_ = true;
                                                                }
                                                                let _e1216 = phi_3681_;
                                                                if _e1216 {
                                                                    phi_3690_ = select(vec3<f32>(_e990[2][0], _e990[2][1], _e990[2][2]), vec3<f32>(_e990[1][0], _e990[1][1], _e990[1][2]), vec3((_e1057 >= _e1061)));
                                                                } else {
                                                                    phi_3690_ = vec3<f32>(_e990[0][0], _e990[0][1], _e990[0][2]);
                                                                }
                                                                let _e1221 = phi_3690_;
                                                                let _e1238 = ((((_e1203 * (_e1221.x - _e289)) + (_e1208 * (_e1221.y - _e328))) + (_e1211 * (_e1221.z - _e366))) / (((_e1203 * _e314) + (_e1208 * _e352)) + (_e1211 * _e390)));
                                                                let _e1240 = select(_e1120, _e1238, (_e1238 < _e1120));
                                                                let _e1242 = select(_e1112, _e1240, (_e1240 > _e1112));
                                                                if (_e1242 >= _e440) {
                                                                    let _e1244 = (_e1242 <= _e848.member.member_1);
                                                                    if _e1244 {
                                                                        let _e1245 = (1f / _e1063);
                                                                        phi_3730_ = type_21(_e1242, (_e1057 * _e1245), (_e1061 * _e1245), _e892);
                                                                    } else {
                                                                        phi_3730_ = type_21();
                                                                    }
                                                                    let _e1250 = phi_3730_;
                                                                    phi_3732_ = _e1250;
                                                                    phi_3733_ = select(true, false, _e1244);
                                                                } else {
                                                                    phi_3732_ = type_21();
                                                                    phi_3733_ = true;
                                                                }
                                                                let _e1253 = phi_3732_;
                                                                let _e1255 = phi_3733_;
                                                                if _e1255 {
                                                                    phi_3737_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3737_ = _e1253;
                                                                }
                                                                let _e1257 = phi_3737_;
                                                                phi_3738_ = _e1257;
                                                            }
                                                            let _e1259 = phi_3738_;
                                                            phi_3739_ = _e1259;
                                                            phi_3740_ = _e1129;
                                                        }
                                                        let _e1261 = phi_3739_;
                                                        let _e1263 = phi_3740_;
                                                        phi_3744_ = _e1261;
                                                        phi_3745_ = _e1263;
                                                    }
                                                    let _e1265 = phi_3744_;
                                                    let _e1267 = phi_3745_;
                                                    phi_3749_ = _e1265;
                                                    phi_3750_ = _e1267;
                                                } else {
                                                    phi_3749_ = type_21();
                                                    phi_3750_ = true;
                                                }
                                                let _e1269 = phi_3749_;
                                                let _e1271 = phi_3750_;
                                                if _e1271 {
                                                    phi_3754_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3754_ = _e1269;
                                                }
                                                let _e1273 = phi_3754_;
                                                if (_e1273.member_3 != 4294967295u) {
                                                    if (_e892 != 4294967295u) {
                                                        if (_e1273.member < _e848.member.member.member) {
                                                            phi_3780_ = true;
                                                        } else {
                                                            if (_e1273.member == _e848.member.member.member) {
                                                                phi_3779_ = (_e1273.member_3 < _e848.member.member.member_3);
                                                            } else {
                                                                phi_3779_ = false;
                                                            }
                                                            let _e1288 = phi_3779_;
                                                            phi_3780_ = _e1288;
                                                        }
                                                        let _e1290 = phi_3780_;
                                                        if _e1290 {
                                                            phi_3787_ = type_32(type_27(_e1273, _e1273.member), _e875.member_1, _e875.member_2);
                                                        } else {
                                                            phi_3787_ = _e875;
                                                        }
                                                        let _e1297 = phi_3787_;
                                                        phi_3788_ = _e1297;
                                                    } else {
                                                        phi_3788_ = _e875;
                                                    }
                                                    let _e1299 = phi_3788_;
                                                    phi_3789_ = _e1299;
                                                } else {
                                                    phi_3789_ = _e875;
                                                }
                                                let _e1301 = phi_3789_;
                                                phi_4813_ = _e989;
                                                phi_2923_ = _e1301;
                                            } else {
                                                phi_4813_ = _e846;
                                                phi_2923_ = type_32();
                                            }
                                            let _e1303 = phi_4813_;
                                            let _e1305 = phi_2923_;
                                            continue;
                                            continuing {
                                                phi_4807_ = _e1303;
                                                phi_2922_ = _e1305;
                                                phi_2925_ = _e863;
                                                phi_4812_ = _e1303;
                                                break if !(_e869);
                                            }
                                        }
                                        let _e1308 = phi_4812_;
                                        phi_4871_ = _e1308;
                                        if _e1308 {
                                            break;
                                        }
                                        phi_4875_ = _e1308;
                                        let _e1472 = local_19;
                                        phi_4636_ = _e1472;
                                        phi_4637_ = _e513;
                                        phi_4638_ = false;
                                        phi_4639_ = _e517;
                                    } else {
                                        local_3 = array<f32, 3>(_e513.member.member[0], _e513.member.member[1], _e513.member.member[2]);
                                        local_2 = array<f32, 3>(_e513.member.member_1[0], _e513.member.member_1[1], _e513.member.member_1[2]);
                                        let _e543 = (_e513.member_1 < _e85);
                                        if _e543 {
                                            if _e543 {
                                            } else {
                                                phi_4871_ = true;
                                                break;
                                            }
                                            let _e545 = global_4.member[_e513.member_1];
                                            phi_3826_ = _e545;
                                        } else {
                                            phi_3826_ = type_36(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e547 = phi_3826_;
                                        let _e549 = array<u32, 3>(_e248, _e247, _e249);
                                        local_11 = _e549;
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        local_6 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3835_ = type_4(0u, 3u);
                                        loop {
                                            let _e551 = phi_3835_;
                                            if (_e551.member < _e551.member_1) {
                                                phi_3836_ = type_4((_e551.member + 1u), _e551.member_1);
                                                phi_3859_ = type_4(1u, _e551.member);
                                            } else {
                                                phi_3836_ = _e551;
                                                phi_3859_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e564 = phi_3836_;
                                            let _e566 = phi_3859_;
                                            let _e570 = (bitcast<i32>(_e566.member) != 0i);
                                            if _e570 {
                                                let _e571 = (_e566.member_1 < 3u);
                                                if _e571 {
                                                } else {
                                                    phi_4734_ = true;
                                                    break;
                                                }
                                                let _e573 = local_11[_e566.member_1];
                                                if _e571 {
                                                } else {
                                                    phi_4734_ = true;
                                                    break;
                                                }
                                                let _e575 = local_3[_e566.member_1];
                                                if _e571 {
                                                } else {
                                                    phi_4734_ = true;
                                                    break;
                                                }
                                                let _e577 = local_2[_e566.member_1];
                                                let _e580 = ((10u * _e573) & 31u);
                                                let _e583 = ((_e547.member[0] >> bitcast<u32>(_e580)) & 1023u);
                                                let _e588 = bitcast<f32>((bitcast<u32>(((_e577 - _e575) * 0.0009775171f)) ^ _e120));
                                                let _e594 = (_e575 + bitcast<f32>((bitcast<u32>((f32(_e583) * _e588)) ^ _e120)));
                                                if _e571 {
                                                } else {
                                                    phi_4734_ = true;
                                                    break;
                                                }
                                                local_7[_e566.member_1] = select(select(_e577, _e594, (_e594 < _e577)), _e577, (_e583 == 1023u));
                                                let _e603 = ((_e547.member[1] >> bitcast<u32>(_e580)) & 1023u);
                                                let _e609 = (_e575 + bitcast<f32>((bitcast<u32>((f32(_e603) * _e588)) ^ _e120)));
                                                if _e571 {
                                                } else {
                                                    phi_4734_ = true;
                                                    break;
                                                }
                                                local_6[_e566.member_1] = select(select(_e577, _e609, (_e609 < _e577)), _e577, (_e603 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3835_ = _e564;
                                                phi_4734_ = _e473;
                                                break if !(_e570);
                                            }
                                        }
                                        let _e617 = phi_4734_;
                                        phi_4871_ = _e617;
                                        if _e617 {
                                            break;
                                        }
                                        let _e618 = local_6;
                                        let _e619 = local_7;
                                        local_10 = _e549;
                                        local_9 = array<f32, 3>(0f, 0f, 0f);
                                        local_8 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3989_ = type_4(0u, 3u);
                                        loop {
                                            let _e628 = phi_3989_;
                                            if (_e628.member < _e628.member_1) {
                                                phi_3990_ = type_4((_e628.member + 1u), _e628.member_1);
                                                phi_4013_ = type_4(1u, _e628.member);
                                            } else {
                                                phi_3990_ = _e628;
                                                phi_4013_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e641 = phi_3990_;
                                            let _e643 = phi_4013_;
                                            let _e647 = (bitcast<i32>(_e643.member) != 0i);
                                            if _e647 {
                                                let _e648 = (_e643.member_1 < 3u);
                                                if _e648 {
                                                } else {
                                                    phi_4790_ = true;
                                                    break;
                                                }
                                                let _e650 = local_10[_e643.member_1];
                                                if _e648 {
                                                } else {
                                                    phi_4790_ = true;
                                                    break;
                                                }
                                                let _e652 = local_3[_e643.member_1];
                                                if _e648 {
                                                } else {
                                                    phi_4790_ = true;
                                                    break;
                                                }
                                                let _e654 = local_2[_e643.member_1];
                                                let _e657 = ((10u * _e650) & 31u);
                                                let _e660 = ((_e547.member_1[0] >> bitcast<u32>(_e657)) & 1023u);
                                                let _e665 = bitcast<f32>((bitcast<u32>(((_e654 - _e652) * 0.0009775171f)) ^ _e120));
                                                let _e671 = (_e652 + bitcast<f32>((bitcast<u32>((f32(_e660) * _e665)) ^ _e120)));
                                                if _e648 {
                                                } else {
                                                    phi_4790_ = true;
                                                    break;
                                                }
                                                local_9[_e643.member_1] = select(select(_e654, _e671, (_e671 < _e654)), _e654, (_e660 == 1023u));
                                                let _e680 = ((_e547.member_1[1] >> bitcast<u32>(_e657)) & 1023u);
                                                let _e686 = (_e652 + bitcast<f32>((bitcast<u32>((f32(_e680) * _e665)) ^ _e120)));
                                                if _e648 {
                                                } else {
                                                    phi_4790_ = true;
                                                    break;
                                                }
                                                local_8[_e643.member_1] = select(select(_e654, _e686, (_e686 < _e654)), _e654, (_e680 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3989_ = _e641;
                                                phi_4790_ = _e617;
                                                break if !(_e647);
                                            }
                                        }
                                        let _e694 = phi_4790_;
                                        phi_4871_ = _e694;
                                        if _e694 {
                                            break;
                                        }
                                        let _e695 = local_8;
                                        let _e696 = local_9;
                                        let _e707 = type_50(type_41(array<f32, 3>(_e619[0], _e619[1], _e619[2]), array<f32, 3>(_e618[0], _e618[1], _e618[2])), _e547.member_2);
                                        let _e712 = type_50(type_41(array<f32, 3>(_e696[0], _e696[1], _e696[2]), array<f32, 3>(_e695[0], _e695[1], _e695[2])), _e547.member_3);
                                        let _e719 = ((_e619[0] - _e312) * _e317);
                                        let _e720 = ((_e696[0] - _e312) * _e317);
                                        let _e721 = ((_e618[0] - _e313) * _e317);
                                        let _e722 = ((_e695[0] - _e313) * _e317);
                                        let _e727 = ((_e619[1] - _e350) * _e355);
                                        let _e728 = ((_e696[1] - _e350) * _e355);
                                        let _e729 = ((_e618[1] - _e351) * _e355);
                                        let _e730 = ((_e695[1] - _e351) * _e355);
                                        let _e735 = ((_e619[2] - _e388) * _e393);
                                        let _e736 = ((_e696[2] - _e388) * _e393);
                                        let _e737 = ((_e618[2] - _e389) * _e393);
                                        let _e738 = ((_e695[2] - _e389) * _e393);
                                        let _e740 = select(_e737, _e735, (_e735 < _e737));
                                        let _e742 = select(_e738, _e736, (_e736 < _e738));
                                        let _e744 = select(_e737, _e735, (_e735 > _e737));
                                        let _e746 = select(_e738, _e736, (_e736 > _e738));
                                        let _e748 = select(_e721, _e719, (_e719 < _e721));
                                        let _e750 = select(_e722, _e720, (_e720 < _e722));
                                        let _e752 = select(_e729, _e727, (_e727 < _e729));
                                        let _e754 = select(_e730, _e728, (_e728 < _e730));
                                        let _e756 = select(_e752, _e748, (_e748 > _e752));
                                        let _e758 = select(_e754, _e750, (_e750 > _e754));
                                        let _e760 = select(_e740, _e756, (_e756 > _e740));
                                        let _e762 = select(_e742, _e758, (_e758 > _e742));
                                        let _e764 = select(_e721, _e719, (_e719 > _e721));
                                        let _e766 = select(_e722, _e720, (_e720 > _e722));
                                        let _e768 = select(_e729, _e727, (_e727 > _e729));
                                        let _e770 = select(_e730, _e728, (_e728 > _e730));
                                        let _e772 = select(_e768, _e764, (_e764 < _e768));
                                        let _e774 = select(_e770, _e766, (_e766 < _e770));
                                        let _e779 = -(_e740);
                                        let _e780 = -(_e742);
                                        let _e787 = (select(_e744, _e772, (_e772 < _e744)) + (select(_e779, _e744, (_e744 > _e779)) * 0.0000019073523f));
                                        let _e788 = (select(_e746, _e774, (_e774 < _e746)) + (select(_e780, _e746, (_e746 > _e780)) * 0.0000019073523f));
                                        let _e790 = select(_e440, _e760, (_e760 > _e440));
                                        let _e792 = select(_e440, _e762, (_e762 > _e440));
                                        let _e797 = (_e790 <= select(_e475.member.member_1, _e787, (_e787 < _e475.member.member_1)));
                                        let _e798 = (_e792 <= select(_e475.member.member_1, _e788, (_e788 < _e475.member.member_1)));
                                        let _e799 = (_e790 <= _e792);
                                        if _e797 {
                                            if _e798 {
                                                if _e799 {
                                                    phi_4576_ = _e712;
                                                } else {
                                                    phi_4576_ = _e707;
                                                }
                                                let _e801 = phi_4576_;
                                                let _e802 = (_e517 % 128u);
                                                let _e803 = (_e802 < 128u);
                                                if _e803 {
                                                } else {
                                                    phi_4871_ = true;
                                                    break;
                                                }
                                                local_5[_e802] = type_50(type_41(array<f32, 3>(_e801.member.member[0], _e801.member.member[1], _e801.member.member[2]), array<f32, 3>(_e801.member.member_1[0], _e801.member.member_1[1], _e801.member.member_1[2])), _e801.member_1);
                                                if _e803 {
                                                } else {
                                                    phi_4871_ = true;
                                                    break;
                                                }
                                                local_4[_e802] = select(_e792, _e790, (_e790 > _e792));
                                                if _e799 {
                                                    phi_4615_ = _e707;
                                                } else {
                                                    phi_4615_ = _e712;
                                                }
                                                let _e824 = phi_4615_;
                                                phi_4616_ = _e824;
                                                phi_4617_ = (_e517 + 1u);
                                            } else {
                                                phi_4616_ = type_50();
                                                phi_4617_ = u32();
                                            }
                                            let _e826 = phi_4616_;
                                            let _e828 = phi_4617_;
                                            phi_4619_ = _e826;
                                            phi_4620_ = _e828;
                                            phi_4621_ = select(true, false, _e798);
                                        } else {
                                            phi_4619_ = type_50();
                                            phi_4620_ = u32();
                                            phi_4621_ = true;
                                        }
                                        let _e831 = phi_4619_;
                                        let _e833 = phi_4620_;
                                        let _e835 = phi_4621_;
                                        if _e835 {
                                            if _e797 {
                                                phi_4628_ = _e707;
                                            } else {
                                                phi_4628_ = _e712;
                                            }
                                            let _e837 = phi_4628_;
                                            phi_4633_ = _e837;
                                            phi_4634_ = select(_e798, true, _e797);
                                        } else {
                                            phi_4633_ = _e831;
                                            phi_4634_ = _e515;
                                        }
                                        let _e840 = phi_4633_;
                                        let _e842 = phi_4634_;
                                        phi_4875_ = _e694;
                                        phi_4636_ = type_32(_e475.member, (_e475.member_1 + 1u), _e475.member_2);
                                        phi_4637_ = _e840;
                                        phi_4638_ = _e842;
                                        phi_4639_ = select(_e833, _e517, _e835);
                                    }
                                    let _e1310 = phi_4875_;
                                    let _e1312 = phi_4636_;
                                    let _e1314 = phi_4637_;
                                    let _e1316 = phi_4638_;
                                    let _e1318 = phi_4639_;
                                    phi_4874_ = _e1310;
                                    phi_4640_ = _e1312;
                                    phi_4641_ = _e1314;
                                    phi_4642_ = (_e479 - 1u);
                                    phi_4643_ = _e1316;
                                    phi_4644_ = _e1318;
                                } else {
                                    phi_4874_ = _e473;
                                    phi_4640_ = _e475;
                                    phi_4641_ = _e513;
                                    phi_4642_ = _e479;
                                    phi_4643_ = _e515;
                                    phi_4644_ = _e517;
                                }
                                let _e1320 = phi_4874_;
                                let _e1322 = phi_4640_;
                                let _e1324 = phi_4641_;
                                let _e1326 = phi_4642_;
                                let _e1328 = phi_4643_;
                                let _e1330 = phi_4644_;
                                phi_4873_ = _e1320;
                                phi_4645_ = _e1322;
                                phi_4646_ = _e1324;
                                phi_4647_ = _e1326;
                                phi_4648_ = _e1328;
                                phi_4649_ = _e1330;
                            } else {
                                phi_4873_ = _e473;
                                phi_4645_ = type_32();
                                phi_4646_ = type_50();
                                phi_4647_ = u32();
                                phi_4648_ = bool();
                                phi_4649_ = u32();
                            }
                            let _e1332 = phi_4873_;
                            let _e1334 = phi_4645_;
                            let _e1336 = phi_4646_;
                            let _e1338 = phi_4647_;
                            let _e1340 = phi_4648_;
                            let _e1342 = phi_4649_;
                            phi_4872_ = _e1332;
                            phi_2837_ = _e1334;
                            phi_2840_ = _e1336;
                            phi_2842_ = _e1338;
                            phi_2844_ = _e1340;
                            phi_2846_ = _e1342;
                            phi_4650_ = _e487;
                        } else {
                            phi_4872_ = _e473;
                            phi_2837_ = type_32();
                            phi_2840_ = type_50();
                            phi_2842_ = u32();
                            phi_2844_ = bool();
                            phi_2846_ = u32();
                            phi_4650_ = false;
                        }
                        let _e1344 = phi_4872_;
                        let _e1346 = phi_2837_;
                        let _e1348 = phi_2840_;
                        let _e1350 = phi_2842_;
                        let _e1352 = phi_2844_;
                        let _e1354 = phi_2846_;
                        let _e1356 = phi_4650_;
                        continue;
                        continuing {
                            phi_4741_ = _e1344;
                            phi_2836_ = _e1346;
                            phi_2839_ = _e1348;
                            phi_2841_ = _e1350;
                            phi_2843_ = _e1352;
                            phi_2845_ = _e1354;
                            phi_4871_ = _e1344;
                            break if !(_e1356);
                        }
                    }
                    let _e1359 = phi_4871_;
                    if _e1359 {
                        break;
                    }
                    let _e1361 = local_17;
                    let _e1364 = local_18;
                    if _e136 {
                    } else {
                        break;
                    }
                    global_5.member[_e134][0u] = _e1361.member_1;
                    global_5.member[_e134][1u] = _e1364.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
