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

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: array<type_23>,
}

struct type_35 {
    member: array<array<type_22, 8>>,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_43 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_45 {
    member: array<type_43>,
}

struct type_49 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_52 {
    member: type_49,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_41;
@group(0) @binding(4) 
var<storage> global_4: type_31;
@group(0) @binding(2) 
var<storage> global_5: type_45;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_35;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<type_22, 8>;
    var local_3: array<f32, 128>;
    var local_4: array<type_52, 128>;
    var local_5: array<f32, 3>;
    var local_6: array<f32, 3>;
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<u32, 3>;
    var local_10: array<u32, 3>;
    var local_11: array<f32, 3>;
    var local_12: array<f32, 3>;
    var phi_340_: i32;
    var phi_341_: i32;
    var phi_351_: bool;
    var phi_361_: u32;
    var phi_362_: u32;
    var phi_364_: bool;
    var phi_369_: u32;
    var phi_414_: f32;
    var phi_420_: f32;
    var phi_431_: f32;
    var phi_437_: f32;
    var phi_460_: f32;
    var phi_471_: f32;
    var phi_480_: f32;
    var phi_486_: f32;
    var phi_497_: f32;
    var phi_503_: f32;
    var phi_526_: f32;
    var phi_537_: f32;
    var phi_546_: f32;
    var phi_552_: f32;
    var phi_563_: f32;
    var phi_569_: f32;
    var phi_592_: f32;
    var phi_603_: f32;
    var phi_703_: f32;
    var phi_704_: f32;
    var phi_4884_: bool;
    var phi_4875_: f32;
    var phi_2885_: type_52;
    var phi_2888_: u32;
    var phi_2890_: bool;
    var phi_2892_: u32;
    var phi_2903_: bool;
    var phi_2949_: type_52;
    var phi_2950_: bool;
    var phi_2951_: u32;
    var phi_3817_: type_43;
    var phi_3826_: type_4;
    var phi_3827_: type_4;
    var phi_3850_: type_4;
    var phi_4877_: bool;
    var phi_3980_: type_4;
    var phi_3981_: type_4;
    var phi_4004_: type_4;
    var phi_4933_: bool;
    var phi_4568_: type_52;
    var phi_4607_: type_52;
    var phi_4608_: type_52;
    var phi_4609_: u32;
    var phi_4611_: type_52;
    var phi_4612_: u32;
    var phi_4613_: bool;
    var phi_4620_: type_52;
    var phi_4625_: type_52;
    var phi_4626_: bool;
    var phi_4972_: bool;
    var phi_4962_: f32;
    var phi_2969_: type_4;
    var phi_2970_: type_4;
    var phi_2993_: type_4;
    var phi_3014_: u32;
    var phi_3103_: array<array<f32, 3>, 3>;
    var phi_3575_: vec3<f32>;
    var phi_3576_: vec3<f32>;
    var phi_3607_: bool;
    var phi_3616_: vec3<f32>;
    var phi_3656_: type_22;
    var phi_3658_: type_22;
    var phi_3659_: bool;
    var phi_3663_: type_22;
    var phi_3664_: type_22;
    var phi_3665_: type_22;
    var phi_3666_: bool;
    var phi_3670_: type_22;
    var phi_3671_: bool;
    var phi_3675_: type_22;
    var phi_3676_: bool;
    var phi_3680_: type_22;
    var phi_3692_: type_4;
    var phi_3695_: type_22;
    var phi_3693_: type_4;
    var phi_3718_: type_4;
    var phi_3750_: bool;
    var phi_3751_: bool;
    var phi_3772_: type_22;
    var phi_3696_: type_22;
    var phi_4963_: bool;
    var phi_5178_: f32;
    var phi_5177_: f32;
    var phi_5029_: bool;
    var phi_5176_: f32;
    var phi_5028_: bool;
    var phi_5175_: f32;
    var phi_5027_: bool;
    var phi_5115_: f32;
    var phi_5026_: bool;
    var phi_5080_: f32;
    var phi_5035_: bool;
    var phi_4628_: type_52;
    var phi_4629_: bool;
    var phi_4630_: u32;
    var phi_5079_: f32;
    var phi_5034_: bool;
    var phi_4631_: type_52;
    var phi_4632_: u32;
    var phi_4633_: bool;
    var phi_4634_: u32;
    var phi_5078_: f32;
    var phi_5033_: bool;
    var phi_4635_: type_52;
    var phi_4636_: u32;
    var phi_4637_: bool;
    var phi_4638_: u32;
    var phi_5077_: f32;
    var phi_5032_: bool;
    var phi_2886_: type_52;
    var phi_2889_: u32;
    var phi_2891_: bool;
    var phi_2893_: u32;
    var phi_4639_: bool;
    var phi_5031_: bool;
    var phi_4646_: type_4;
    var phi_4647_: type_4;
    var phi_4670_: type_4;
    var phi_4736_: type_22;
    var phi_5070_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e83 = global;
            let _e86 = arrayLength((&global_5.member));
            let _e88 = arrayLength((&global_2.member));
            let _e96 = global_3.member[0u][0u];
            let _e100 = global_3.member[0u][1u];
            let _e104 = global_3.member[0u][2u];
            let _e108 = global_3.member[1u][0u];
            let _e112 = global_3.member[1u][1u];
            let _e116 = global_3.member[1u][2u];
            let _e120 = global_3.member[1u][3u];
            let _e123 = global_1.member[0u];
            let _e124 = bitcast<i32>(_e123);
            let _e134 = (_e83.x + (_e83.y * 2097152u));
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
                            phi_340_ = (bitcast<i32>((_e213 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_340_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e213)), 32u, (_e213 == 0u))));
                        }
                        let _e227 = phi_340_;
                        phi_341_ = _e227;
                    } else {
                        phi_341_ = 0i;
                    }
                    let _e229 = phi_341_;
                    let _e230 = (_e146 == _e185);
                    if _e230 {
                        phi_351_ = true;
                    } else {
                        phi_351_ = (_e153 == _e185);
                    }
                    let _e233 = phi_351_;
                    let _e234 = select(1u, 0u, _e230);
                    if _e233 {
                        let _e235 = (_e234 + 1u);
                        phi_361_ = _e235;
                        phi_362_ = _e235;
                        phi_364_ = select(true, false, (_e235 == 2u));
                    } else {
                        phi_361_ = u32();
                        phi_362_ = 0u;
                        phi_364_ = true;
                    }
                    let _e239 = phi_361_;
                    let _e241 = phi_362_;
                    let _e243 = phi_364_;
                    if _e243 {
                        phi_369_ = (_e241 + 1u);
                    } else {
                        phi_369_ = 0u;
                    }
                    let _e247 = phi_369_;
                    let _e248 = select(_e239, _e241, _e243);
                    let _e249 = select(_e234, select(2u, _e234, _e233), _e243);
                    let _e250 = (_e124 / 2i);
                    let _e255 = bitcast<f32>((bitcast<u32>((_e250 + 127i)) << bitcast<u32>(23i)));
                    let _e261 = bitcast<f32>((bitcast<u32>(((_e124 - _e250) + 127i)) << bitcast<u32>(23i)));
                    let _e262 = -(_e229);
                    let _e263 = (_e262 / 2i);
                    let _e268 = bitcast<f32>((bitcast<u32>((_e263 + 127i)) << bitcast<u32>(23i)));
                    let _e274 = bitcast<f32>((bitcast<u32>(((_e262 - _e263) + 127i)) << bitcast<u32>(23i)));
                    let _e278 = global_4.member[_e134].member;
                    let _e279 = (_e248 == 0u);
                    if _e279 {
                        phi_414_ = _e278[0];
                    } else {
                        phi_414_ = _e278[1];
                    }
                    let _e283 = phi_414_;
                    let _e284 = (_e248 == 2u);
                    if _e284 {
                        phi_420_ = _e278[2];
                    } else {
                        phi_420_ = _e283;
                    }
                    let _e287 = phi_420_;
                    let _e289 = ((_e287 * _e255) * _e261);
                    let _e290 = global_4.member[_e134].member_2;
                    if _e279 {
                        phi_431_ = _e290[0];
                    } else {
                        phi_431_ = _e290[1];
                    }
                    let _e294 = phi_431_;
                    if _e284 {
                        phi_437_ = _e290[2];
                    } else {
                        phi_437_ = _e294;
                    }
                    let _e297 = phi_437_;
                    let _e299 = ((_e297 * _e268) * _e274);
                    let _e303 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e303 {
                        let _e307 = (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) * 0.00000011920929f);
                        phi_460_ = select(0.00000000000011368684f, _e307, (_e307 > 0.00000000000011368684f));
                    } else {
                        phi_460_ = 0f;
                    }
                    let _e311 = phi_460_;
                    let _e312 = (_e289 + _e311);
                    let _e313 = (_e289 - _e311);
                    let _e314 = select(_e299, 0f, _e303);
                    if _e303 {
                        phi_471_ = 38685626000000000000000000f;
                    } else {
                        phi_471_ = (1f / _e299);
                    }
                    let _e317 = phi_471_;
                    let _e318 = (_e247 == 0u);
                    if _e318 {
                        phi_480_ = _e278[0];
                    } else {
                        phi_480_ = _e278[1];
                    }
                    let _e322 = phi_480_;
                    let _e323 = (_e247 == 2u);
                    if _e323 {
                        phi_486_ = _e278[2];
                    } else {
                        phi_486_ = _e322;
                    }
                    let _e326 = phi_486_;
                    let _e328 = ((_e326 * _e255) * _e261);
                    if _e318 {
                        phi_497_ = _e290[0];
                    } else {
                        phi_497_ = _e290[1];
                    }
                    let _e332 = phi_497_;
                    if _e323 {
                        phi_503_ = _e290[2];
                    } else {
                        phi_503_ = _e332;
                    }
                    let _e335 = phi_503_;
                    let _e337 = ((_e335 * _e268) * _e274);
                    let _e341 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e341 {
                        let _e345 = (bitcast<f32>((bitcast<u32>(_e328) & 2147483647u)) * 0.00000011920929f);
                        phi_526_ = select(0.00000000000011368684f, _e345, (_e345 > 0.00000000000011368684f));
                    } else {
                        phi_526_ = 0f;
                    }
                    let _e349 = phi_526_;
                    let _e350 = (_e328 + _e349);
                    let _e351 = (_e328 - _e349);
                    let _e352 = select(_e337, 0f, _e341);
                    if _e341 {
                        phi_537_ = 38685626000000000000000000f;
                    } else {
                        phi_537_ = (1f / _e337);
                    }
                    let _e355 = phi_537_;
                    let _e356 = (_e249 == 0u);
                    if _e356 {
                        phi_546_ = _e278[0];
                    } else {
                        phi_546_ = _e278[1];
                    }
                    let _e360 = phi_546_;
                    let _e361 = (_e249 == 2u);
                    if _e361 {
                        phi_552_ = _e278[2];
                    } else {
                        phi_552_ = _e360;
                    }
                    let _e364 = phi_552_;
                    let _e366 = ((_e364 * _e255) * _e261);
                    if _e356 {
                        phi_563_ = _e290[0];
                    } else {
                        phi_563_ = _e290[1];
                    }
                    let _e370 = phi_563_;
                    if _e361 {
                        phi_569_ = _e290[2];
                    } else {
                        phi_569_ = _e370;
                    }
                    let _e373 = phi_569_;
                    let _e375 = ((_e373 * _e268) * _e274);
                    let _e379 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e379 {
                        let _e383 = (bitcast<f32>((bitcast<u32>(_e366) & 2147483647u)) * 0.00000011920929f);
                        phi_592_ = select(0.00000000000011368684f, _e383, (_e383 > 0.00000000000011368684f));
                    } else {
                        phi_592_ = 0f;
                    }
                    let _e387 = phi_592_;
                    let _e388 = (_e366 + _e387);
                    let _e389 = (_e366 - _e387);
                    let _e390 = select(_e375, 0f, _e379);
                    if _e379 {
                        phi_603_ = 38685626000000000000000000f;
                    } else {
                        phi_603_ = (1f / _e375);
                    }
                    let _e393 = phi_603_;
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
                        phi_703_ = select(-340282350000000000000000000000000000000f, _e434, (_e434 > -340282350000000000000000000000000000000f));
                        phi_704_ = select(-340282350000000000000000000000000000000f, _e427, (_e427 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_703_ = 0f;
                        phi_704_ = 1f;
                    }
                    let _e438 = phi_703_;
                    let _e440 = phi_704_;
                    local_2 = array<type_22, 8>(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_4 = array<type_52, 128>(type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_12 = array<f32, 3>(bitcast<f32>(_e96), bitcast<f32>(_e100), bitcast<f32>(_e104));
                    let _e444 = (_e248 % 3u);
                    let _e445 = (_e444 < 3u);
                    if _e445 {
                    } else {
                        break;
                    }
                    let _e447 = local_12[_e444];
                    let _e448 = (_e247 % 3u);
                    let _e449 = (_e448 < 3u);
                    if _e449 {
                    } else {
                        break;
                    }
                    let _e451 = local_12[_e448];
                    let _e452 = (_e249 % 3u);
                    let _e453 = (_e452 < 3u);
                    if _e453 {
                    } else {
                        break;
                    }
                    let _e455 = local_12[_e452];
                    local_11 = array<f32, 3>(bitcast<f32>(_e108), bitcast<f32>(_e112), bitcast<f32>(_e116));
                    if _e445 {
                    } else {
                        break;
                    }
                    let _e459 = local_11[_e444];
                    if _e449 {
                    } else {
                        break;
                    }
                    let _e461 = local_11[_e448];
                    if _e453 {
                    } else {
                        break;
                    }
                    let _e463 = local_11[_e452];
                    phi_4884_ = false;
                    phi_4875_ = _e438;
                    phi_2885_ = type_52(type_49(array<f32, 3>(_e447, _e451, _e455), array<f32, 3>(_e459, _e461, _e463)), select(0u, 2147483648u, (_e86 == 0u)));
                    phi_2888_ = ((3u * _e86) + 1u);
                    phi_2890_ = (_e440 <= _e438);
                    phi_2892_ = 0u;
                    loop {
                        let _e471 = phi_4884_;
                        let _e473 = phi_4875_;
                        let _e475 = phi_2885_;
                        let _e477 = phi_2888_;
                        let _e479 = phi_2890_;
                        let _e481 = phi_2892_;
                        if _e479 {
                            phi_2903_ = true;
                        } else {
                            phi_2903_ = (_e481 > 0u);
                        }
                        let _e484 = phi_2903_;
                        if _e484 {
                            let _e485 = (_e477 > 0u);
                            if _e485 {
                                if _e479 {
                                    phi_2949_ = _e475;
                                    phi_2950_ = _e479;
                                    phi_2951_ = _e481;
                                } else {
                                    let _e486 = (_e481 - 1u);
                                    let _e487 = (_e486 % 128u);
                                    let _e488 = (_e487 < 128u);
                                    if _e488 {
                                    } else {
                                        phi_5031_ = true;
                                        break;
                                    }
                                    let _e490 = local_4[_e487];
                                    if _e488 {
                                    } else {
                                        phi_5031_ = true;
                                        break;
                                    }
                                    let _e506 = local_3[_e487];
                                    phi_2949_ = type_52(type_49(array<f32, 3>(_e490.member.member[0], _e490.member.member[1], _e490.member.member[2]), array<f32, 3>(_e490.member.member_1[0], _e490.member.member_1[1], _e490.member.member_1[2])), _e490.member_1);
                                    phi_2950_ = (_e506 <= _e473);
                                    phi_2951_ = _e486;
                                }
                                let _e509 = phi_2949_;
                                let _e511 = phi_2950_;
                                let _e513 = phi_2951_;
                                if _e511 {
                                    if ((_e509.member_1 & 2147483648u) != 0u) {
                                        phi_4972_ = _e471;
                                        phi_4962_ = _e473;
                                        phi_2969_ = type_4(0u, ((_e509.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e834 = phi_4972_;
                                            let _e836 = phi_4962_;
                                            let _e838 = phi_2969_;
                                            if (_e838.member < _e838.member_1) {
                                                phi_2970_ = type_4((_e838.member + 1u), _e838.member_1);
                                                phi_2993_ = type_4(1u, _e838.member);
                                            } else {
                                                phi_2970_ = _e838;
                                                phi_2993_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e851 = phi_2970_;
                                            let _e853 = phi_2993_;
                                            let _e857 = (bitcast<i32>(_e853.member) != 0i);
                                            if _e857 {
                                                let _e858 = ((_e509.member_1 & 268435455u) + _e853.member_1);
                                                let _e859 = (_e858 < _e88);
                                                if _e859 {
                                                    if _e859 {
                                                    } else {
                                                        phi_5115_ = _e836;
                                                        phi_5026_ = true;
                                                        break;
                                                    }
                                                    let _e863 = global_2.member[_e858].member_1;
                                                    phi_3014_ = _e863;
                                                } else {
                                                    phi_3014_ = 4294967295u;
                                                }
                                                let _e865 = phi_3014_;
                                                if (_e858 >= _e88) {
                                                    phi_3103_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e859 {
                                                    } else {
                                                        phi_5115_ = _e836;
                                                        phi_5026_ = true;
                                                        break;
                                                    }
                                                    if (_e444 < 9u) {
                                                    } else {
                                                        phi_5115_ = _e836;
                                                        phi_5026_ = true;
                                                        break;
                                                    }
                                                    let _e872 = global_2.member[_e858].member[_e444];
                                                    if (_e448 < 9u) {
                                                    } else {
                                                        phi_5115_ = _e836;
                                                        phi_5026_ = true;
                                                        break;
                                                    }
                                                    let _e878 = global_2.member[_e858].member[_e448];
                                                    if (_e452 < 9u) {
                                                    } else {
                                                        phi_5115_ = _e836;
                                                        phi_5026_ = true;
                                                        break;
                                                    }
                                                    let _e884 = global_2.member[_e858].member[_e452];
                                                    let _e886 = (3u + _e444);
                                                    if (_e886 < 9u) {
                                                    } else {
                                                        phi_5115_ = _e836;
                                                        phi_5026_ = true;
                                                        break;
                                                    }
                                                    let _e892 = global_2.member[_e858].member[_e886];
                                                    let _e893 = (3u + _e448);
                                                    if (_e893 < 9u) {
                                                    } else {
                                                        phi_5115_ = _e836;
                                                        phi_5026_ = true;
                                                        break;
                                                    }
                                                    let _e899 = global_2.member[_e858].member[_e893];
                                                    let _e900 = (3u + _e452);
                                                    if (_e900 < 9u) {
                                                    } else {
                                                        phi_5115_ = _e836;
                                                        phi_5026_ = true;
                                                        break;
                                                    }
                                                    let _e906 = global_2.member[_e858].member[_e900];
                                                    let _e908 = (6u + _e444);
                                                    if (_e908 < 9u) {
                                                    } else {
                                                        phi_5115_ = _e836;
                                                        phi_5026_ = true;
                                                        break;
                                                    }
                                                    let _e914 = global_2.member[_e858].member[_e908];
                                                    let _e915 = (6u + _e448);
                                                    if (_e915 < 9u) {
                                                    } else {
                                                        phi_5115_ = _e836;
                                                        phi_5026_ = true;
                                                        break;
                                                    }
                                                    let _e921 = global_2.member[_e858].member[_e915];
                                                    let _e922 = (6u + _e452);
                                                    if (_e922 < 9u) {
                                                    } else {
                                                        phi_5115_ = _e836;
                                                        phi_5026_ = true;
                                                        break;
                                                    }
                                                    let _e928 = global_2.member[_e858].member[_e922];
                                                    phi_3103_ = array<array<f32, 3>, 3>(array<f32, 3>(_e872, _e878, _e884), array<f32, 3>(_e892, _e899, _e906), array<f32, 3>(_e914, _e921, _e928));
                                                }
                                                let _e932 = phi_3103_;
                                                let _e939 = (_e932[0][2] - _e366);
                                                let _e942 = (((_e932[0][0] - _e289) * _e390) - (_e939 * _e314));
                                                let _e945 = (((_e932[0][1] - _e328) * _e390) - (_e939 * _e352));
                                                let _e952 = (_e932[1][2] - _e366);
                                                let _e955 = (((_e932[1][0] - _e289) * _e390) - (_e952 * _e314));
                                                let _e958 = (((_e932[1][1] - _e328) * _e390) - (_e952 * _e352));
                                                let _e965 = (_e932[2][2] - _e366);
                                                let _e968 = (((_e932[2][0] - _e289) * _e390) - (_e965 * _e314));
                                                let _e971 = (((_e932[2][1] - _e328) * _e390) - (_e965 * _e352));
                                                let _e972 = (_e968 * _e958);
                                                let _e973 = (_e971 * _e955);
                                                let _e974 = (_e942 * _e971);
                                                let _e975 = (_e945 * _e968);
                                                let _e976 = (_e955 * _e945);
                                                let _e977 = (_e958 * _e942);
                                                let _e982 = (((_e972 >= _e973) && (_e974 >= _e975)) && (_e976 >= _e977));
                                                if (_e982 || (((_e972 <= _e973) && (_e974 <= _e975)) && (_e976 <= _e977))) {
                                                    let _e989 = select(-1f, 1f, _e982);
                                                    let _e991 = ((_e972 - _e973) * _e989);
                                                    let _e993 = select(0f, _e991, (_e991 > 0f));
                                                    let _e995 = ((_e974 - _e975) * _e989);
                                                    let _e997 = select(0f, _e995, (_e995 > 0f));
                                                    let _e999 = ((_e976 - _e977) * _e989);
                                                    let _e1001 = select(0f, _e999, (_e999 > 0f));
                                                    let _e1003 = ((_e993 + _e997) + _e1001);
                                                    if (_e1003 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3670_ = type_22();
                                                        phi_3671_ = true;
                                                    } else {
                                                        let _e1006 = select(_e932[1][0], _e932[0][0], (_e932[0][0] < _e932[1][0]));
                                                        let _e1010 = select(_e932[1][0], _e932[0][0], (_e932[0][0] > _e932[1][0]));
                                                        let _e1014 = select(_e932[1][1], _e932[0][1], (_e932[0][1] < _e932[1][1]));
                                                        let _e1018 = select(_e932[1][1], _e932[0][1], (_e932[0][1] > _e932[1][1]));
                                                        let _e1022 = select(_e932[1][2], _e932[0][2], (_e932[0][2] < _e932[1][2]));
                                                        let _e1026 = select(_e932[1][2], _e932[0][2], (_e932[0][2] > _e932[1][2]));
                                                        let _e1031 = ((select(_e932[2][0], _e1006, (_e1006 < _e932[2][0])) - _e312) * _e317);
                                                        let _e1032 = ((select(_e932[2][0], _e1010, (_e1010 > _e932[2][0])) - _e313) * _e317);
                                                        let _e1035 = ((select(_e932[2][1], _e1014, (_e1014 < _e932[2][1])) - _e350) * _e355);
                                                        let _e1036 = ((select(_e932[2][1], _e1018, (_e1018 > _e932[2][1])) - _e351) * _e355);
                                                        let _e1039 = ((select(_e932[2][2], _e1022, (_e1022 < _e932[2][2])) - _e388) * _e393);
                                                        let _e1040 = ((select(_e932[2][2], _e1026, (_e1026 > _e932[2][2])) - _e389) * _e393);
                                                        let _e1042 = select(_e1040, _e1039, (_e1039 < _e1040));
                                                        let _e1044 = select(_e1040, _e1039, (_e1039 > _e1040));
                                                        let _e1046 = select(_e1032, _e1031, (_e1031 < _e1032));
                                                        let _e1048 = select(_e1036, _e1035, (_e1035 < _e1036));
                                                        let _e1050 = select(_e1048, _e1046, (_e1046 > _e1048));
                                                        let _e1052 = select(_e1042, _e1050, (_e1050 > _e1042));
                                                        let _e1054 = select(_e1032, _e1031, (_e1031 > _e1032));
                                                        let _e1056 = select(_e1036, _e1035, (_e1035 > _e1036));
                                                        let _e1058 = select(_e1056, _e1054, (_e1054 < _e1056));
                                                        let _e1060 = select(_e1044, _e1058, (_e1058 < _e1044));
                                                        let _e1061 = -(_e1042);
                                                        let _e1067 = select(_e440, _e1052, (_e1052 > _e440));
                                                        if (_e1067 > (_e1060 + (select(_e1061, _e1044, (_e1044 > _e1061)) * 0.0000019073523f))) {
                                                            phi_3665_ = type_22();
                                                            phi_3666_ = true;
                                                        } else {
                                                            let _e1069 = (_e1067 > _e836);
                                                            if _e1069 {
                                                                phi_3664_ = type_22();
                                                            } else {
                                                                let _e1073 = (_e932[1][0] - _e932[0][0]);
                                                                let _e1074 = (_e932[1][1] - _e932[0][1]);
                                                                let _e1075 = (_e932[1][2] - _e932[0][2]);
                                                                let _e1076 = vec3<f32>(_e1073, _e1074, _e1075);
                                                                let _e1077 = (_e932[2][0] - _e932[1][0]);
                                                                let _e1078 = (_e932[2][1] - _e932[1][1]);
                                                                let _e1079 = (_e932[2][2] - _e932[1][2]);
                                                                let _e1080 = vec3<f32>(_e1077, _e1078, _e1079);
                                                                let _e1081 = (_e932[0][0] - _e932[2][0]);
                                                                let _e1082 = (_e932[0][1] - _e932[2][1]);
                                                                let _e1083 = (_e932[0][2] - _e932[2][2]);
                                                                let _e1084 = vec3<f32>(_e1081, _e1082, _e1083);
                                                                let _e1087 = bitcast<f32>((bitcast<u32>(_e1073) & 2147483647u));
                                                                let _e1090 = bitcast<f32>((bitcast<u32>(_e1074) & 2147483647u));
                                                                let _e1092 = select(_e1090, _e1087, (_e1087 > _e1090));
                                                                let _e1095 = bitcast<f32>((bitcast<u32>(_e1075) & 2147483647u));
                                                                let _e1097 = select(_e1095, _e1092, (_e1092 > _e1095));
                                                                let _e1100 = bitcast<f32>((bitcast<u32>(_e1077) & 2147483647u));
                                                                let _e1103 = bitcast<f32>((bitcast<u32>(_e1078) & 2147483647u));
                                                                let _e1105 = select(_e1103, _e1100, (_e1100 > _e1103));
                                                                let _e1108 = bitcast<f32>((bitcast<u32>(_e1079) & 2147483647u));
                                                                let _e1110 = select(_e1108, _e1105, (_e1105 > _e1108));
                                                                let _e1113 = bitcast<f32>((bitcast<u32>(_e1081) & 2147483647u));
                                                                let _e1116 = bitcast<f32>((bitcast<u32>(_e1082) & 2147483647u));
                                                                let _e1118 = select(_e1116, _e1113, (_e1113 > _e1116));
                                                                let _e1121 = bitcast<f32>((bitcast<u32>(_e1083) & 2147483647u));
                                                                let _e1123 = select(_e1121, _e1118, (_e1118 > _e1121));
                                                                let _e1125 = select(_e1110, _e1097, (_e1097 > _e1110));
                                                                let _e1127 = select(_e1123, _e1125, (_e1125 > _e1123));
                                                                if (_e1097 == _e1127) {
                                                                    phi_3575_ = _e1080;
                                                                    phi_3576_ = _e1084;
                                                                } else {
                                                                    let _e1130 = vec3((_e1110 == _e1127));
                                                                    phi_3575_ = select(_e1076, _e1084, _e1130);
                                                                    phi_3576_ = select(_e1080, _e1076, _e1130);
                                                                }
                                                                let _e1134 = phi_3575_;
                                                                let _e1136 = phi_3576_;
                                                                let _e1143 = ((_e1134.y * _e1136.z) - (_e1136.y * _e1134.z));
                                                                let _e1148 = ((_e1134.z * _e1136.x) - (_e1136.z * _e1134.x));
                                                                let _e1151 = ((_e1134.x * _e1136.y) - (_e1136.x * _e1134.y));
                                                                if (_e993 >= _e997) {
                                                                    phi_3607_ = select(true, false, (_e993 >= _e1001));
                                                                } else {
                                                                    phi_3607_ = true;
                                                                }
                                                                let _e1156 = phi_3607_;
                                                                if _e1156 {
                                                                    phi_3616_ = select(vec3<f32>(_e932[2][0], _e932[2][1], _e932[2][2]), vec3<f32>(_e932[1][0], _e932[1][1], _e932[1][2]), vec3((_e997 >= _e1001)));
                                                                } else {
                                                                    phi_3616_ = vec3<f32>(_e932[0][0], _e932[0][1], _e932[0][2]);
                                                                }
                                                                let _e1161 = phi_3616_;
                                                                let _e1178 = ((((_e1143 * (_e1161.x - _e289)) + (_e1148 * (_e1161.y - _e328))) + (_e1151 * (_e1161.z - _e366))) / (((_e1143 * _e314) + (_e1148 * _e352)) + (_e1151 * _e390)));
                                                                let _e1180 = select(_e1060, _e1178, (_e1178 < _e1060));
                                                                let _e1182 = select(_e1052, _e1180, (_e1180 > _e1052));
                                                                if (_e1182 >= _e440) {
                                                                    let _e1184 = (_e1182 <= _e836);
                                                                    if _e1184 {
                                                                        let _e1185 = (1f / _e1003);
                                                                        phi_3656_ = type_22(_e1182, (_e997 * _e1185), (_e1001 * _e1185), _e865);
                                                                    } else {
                                                                        phi_3656_ = type_22();
                                                                    }
                                                                    let _e1190 = phi_3656_;
                                                                    phi_3658_ = _e1190;
                                                                    phi_3659_ = select(true, false, _e1184);
                                                                } else {
                                                                    phi_3658_ = type_22();
                                                                    phi_3659_ = true;
                                                                }
                                                                let _e1193 = phi_3658_;
                                                                let _e1195 = phi_3659_;
                                                                if _e1195 {
                                                                    phi_3663_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3663_ = _e1193;
                                                                }
                                                                let _e1197 = phi_3663_;
                                                                phi_3664_ = _e1197;
                                                            }
                                                            let _e1199 = phi_3664_;
                                                            phi_3665_ = _e1199;
                                                            phi_3666_ = _e1069;
                                                        }
                                                        let _e1201 = phi_3665_;
                                                        let _e1203 = phi_3666_;
                                                        phi_3670_ = _e1201;
                                                        phi_3671_ = _e1203;
                                                    }
                                                    let _e1205 = phi_3670_;
                                                    let _e1207 = phi_3671_;
                                                    phi_3675_ = _e1205;
                                                    phi_3676_ = _e1207;
                                                } else {
                                                    phi_3675_ = type_22();
                                                    phi_3676_ = true;
                                                }
                                                let _e1209 = phi_3675_;
                                                let _e1211 = phi_3676_;
                                                if _e1211 {
                                                    phi_3680_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3680_ = _e1209;
                                                }
                                                let _e1213 = phi_3680_;
                                                if (_e1213.member_3 != 4294967295u) {
                                                    if (_e865 != 4294967295u) {
                                                        phi_3692_ = type_4(0u, 8u);
                                                        phi_3695_ = _e1213;
                                                        loop {
                                                            let _e1218 = phi_3692_;
                                                            let _e1220 = phi_3695_;
                                                            if (_e1218.member < _e1218.member_1) {
                                                                phi_3693_ = type_4((_e1218.member + 1u), _e1218.member_1);
                                                                phi_3718_ = type_4(1u, _e1218.member);
                                                            } else {
                                                                phi_3693_ = _e1218;
                                                                phi_3718_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1233 = phi_3693_;
                                                            let _e1235 = phi_3718_;
                                                            let _e1239 = (bitcast<i32>(_e1235.member) != 0i);
                                                            if _e1239 {
                                                                let _e1240 = (_e1235.member_1 < 8u);
                                                                if _e1240 {
                                                                } else {
                                                                    phi_4963_ = true;
                                                                    break;
                                                                }
                                                                let _e1245 = local_2[_e1235.member_1].member;
                                                                if (_e1220.member < _e1245) {
                                                                    phi_3751_ = true;
                                                                } else {
                                                                    let _e1247 = local_2[_e1235.member_1].member;
                                                                    if (_e1220.member == _e1247) {
                                                                        let _e1252 = local_2[_e1235.member_1].member_3;
                                                                        phi_3750_ = (_e1220.member_3 < _e1252);
                                                                    } else {
                                                                        phi_3750_ = false;
                                                                    }
                                                                    let _e1255 = phi_3750_;
                                                                    phi_3751_ = _e1255;
                                                                }
                                                                let _e1257 = phi_3751_;
                                                                if _e1257 {
                                                                    if _e1240 {
                                                                    } else {
                                                                        phi_4963_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1258 = local_2[_e1235.member_1];
                                                                    local_2[_e1235.member_1] = type_22(_e1220.member, _e1220.member_1, _e1220.member_2, _e1220.member_3);
                                                                    phi_3772_ = type_22(_e1258.member, _e1258.member_1, _e1258.member_2, _e1258.member_3);
                                                                } else {
                                                                    phi_3772_ = _e1220;
                                                                }
                                                                let _e1269 = phi_3772_;
                                                                phi_3696_ = _e1269;
                                                            } else {
                                                                phi_3696_ = type_22();
                                                            }
                                                            let _e1271 = phi_3696_;
                                                            continue;
                                                            continuing {
                                                                phi_3692_ = _e1233;
                                                                phi_3695_ = _e1271;
                                                                phi_4963_ = _e834;
                                                                break if !(_e1239);
                                                            }
                                                        }
                                                        let _e1274 = phi_4963_;
                                                        phi_5115_ = _e836;
                                                        phi_5026_ = _e1274;
                                                        if _e1274 {
                                                            break;
                                                        }
                                                        let _e1277 = local_2[7u].member_3;
                                                        if (_e1277 != 4294967295u) {
                                                            let _e1281 = local_2[7u].member;
                                                            phi_5178_ = _e1281;
                                                        } else {
                                                            phi_5178_ = _e836;
                                                        }
                                                        let _e1283 = phi_5178_;
                                                        phi_5177_ = _e1283;
                                                        phi_5029_ = _e1274;
                                                    } else {
                                                        phi_5177_ = _e836;
                                                        phi_5029_ = _e834;
                                                    }
                                                    let _e1285 = phi_5177_;
                                                    let _e1287 = phi_5029_;
                                                    phi_5176_ = _e1285;
                                                    phi_5028_ = _e1287;
                                                } else {
                                                    phi_5176_ = _e836;
                                                    phi_5028_ = _e834;
                                                }
                                                let _e1289 = phi_5176_;
                                                let _e1291 = phi_5028_;
                                                phi_5175_ = _e1289;
                                                phi_5027_ = _e1291;
                                            } else {
                                                phi_5175_ = _e836;
                                                phi_5027_ = _e834;
                                            }
                                            let _e1293 = phi_5175_;
                                            let _e1295 = phi_5027_;
                                            continue;
                                            continuing {
                                                phi_4972_ = _e1295;
                                                phi_4962_ = _e1293;
                                                phi_2969_ = _e851;
                                                phi_5115_ = _e1293;
                                                phi_5026_ = _e1295;
                                                break if !(_e857);
                                            }
                                        }
                                        let _e1298 = phi_5115_;
                                        let _e1300 = phi_5026_;
                                        phi_5031_ = _e1300;
                                        if _e1300 {
                                            break;
                                        }
                                        phi_5080_ = _e1298;
                                        phi_5035_ = _e1300;
                                        phi_4628_ = _e509;
                                        phi_4629_ = false;
                                        phi_4630_ = _e513;
                                    } else {
                                        local_1 = array<f32, 3>(_e509.member.member[0], _e509.member.member[1], _e509.member.member[2]);
                                        local = array<f32, 3>(_e509.member.member_1[0], _e509.member.member_1[1], _e509.member.member_1[2]);
                                        let _e533 = (_e509.member_1 < _e86);
                                        if _e533 {
                                            if _e533 {
                                            } else {
                                                phi_5031_ = true;
                                                break;
                                            }
                                            let _e535 = global_5.member[_e509.member_1];
                                            phi_3817_ = _e535;
                                        } else {
                                            phi_3817_ = type_43(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e537 = phi_3817_;
                                        let _e539 = array<u32, 3>(_e248, _e247, _e249);
                                        local_10 = _e539;
                                        local_6 = array<f32, 3>(0f, 0f, 0f);
                                        local_5 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3826_ = type_4(0u, 3u);
                                        loop {
                                            let _e541 = phi_3826_;
                                            if (_e541.member < _e541.member_1) {
                                                phi_3827_ = type_4((_e541.member + 1u), _e541.member_1);
                                                phi_3850_ = type_4(1u, _e541.member);
                                            } else {
                                                phi_3827_ = _e541;
                                                phi_3850_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e554 = phi_3827_;
                                            let _e556 = phi_3850_;
                                            let _e560 = (bitcast<i32>(_e556.member) != 0i);
                                            if _e560 {
                                                let _e561 = (_e556.member_1 < 3u);
                                                if _e561 {
                                                } else {
                                                    phi_4877_ = true;
                                                    break;
                                                }
                                                let _e563 = local_10[_e556.member_1];
                                                if _e561 {
                                                } else {
                                                    phi_4877_ = true;
                                                    break;
                                                }
                                                let _e565 = local_1[_e556.member_1];
                                                if _e561 {
                                                } else {
                                                    phi_4877_ = true;
                                                    break;
                                                }
                                                let _e567 = local[_e556.member_1];
                                                let _e570 = ((10u * _e563) & 31u);
                                                let _e573 = ((_e537.member[0] >> bitcast<u32>(_e570)) & 1023u);
                                                let _e578 = bitcast<f32>((bitcast<u32>(((_e567 - _e565) * 0.0009775171f)) ^ _e120));
                                                let _e584 = (_e565 + bitcast<f32>((bitcast<u32>((f32(_e573) * _e578)) ^ _e120)));
                                                if _e561 {
                                                } else {
                                                    phi_4877_ = true;
                                                    break;
                                                }
                                                local_6[_e556.member_1] = select(select(_e567, _e584, (_e584 < _e567)), _e567, (_e573 == 1023u));
                                                let _e593 = ((_e537.member[1] >> bitcast<u32>(_e570)) & 1023u);
                                                let _e599 = (_e565 + bitcast<f32>((bitcast<u32>((f32(_e593) * _e578)) ^ _e120)));
                                                if _e561 {
                                                } else {
                                                    phi_4877_ = true;
                                                    break;
                                                }
                                                local_5[_e556.member_1] = select(select(_e567, _e599, (_e599 < _e567)), _e567, (_e593 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3826_ = _e554;
                                                phi_4877_ = _e471;
                                                break if !(_e560);
                                            }
                                        }
                                        let _e607 = phi_4877_;
                                        phi_5031_ = _e607;
                                        if _e607 {
                                            break;
                                        }
                                        let _e608 = local_5;
                                        let _e609 = local_6;
                                        local_9 = _e539;
                                        local_8 = array<f32, 3>(0f, 0f, 0f);
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3980_ = type_4(0u, 3u);
                                        loop {
                                            let _e618 = phi_3980_;
                                            if (_e618.member < _e618.member_1) {
                                                phi_3981_ = type_4((_e618.member + 1u), _e618.member_1);
                                                phi_4004_ = type_4(1u, _e618.member);
                                            } else {
                                                phi_3981_ = _e618;
                                                phi_4004_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e631 = phi_3981_;
                                            let _e633 = phi_4004_;
                                            let _e637 = (bitcast<i32>(_e633.member) != 0i);
                                            if _e637 {
                                                let _e638 = (_e633.member_1 < 3u);
                                                if _e638 {
                                                } else {
                                                    phi_4933_ = true;
                                                    break;
                                                }
                                                let _e640 = local_9[_e633.member_1];
                                                if _e638 {
                                                } else {
                                                    phi_4933_ = true;
                                                    break;
                                                }
                                                let _e642 = local_1[_e633.member_1];
                                                if _e638 {
                                                } else {
                                                    phi_4933_ = true;
                                                    break;
                                                }
                                                let _e644 = local[_e633.member_1];
                                                let _e647 = ((10u * _e640) & 31u);
                                                let _e650 = ((_e537.member_1[0] >> bitcast<u32>(_e647)) & 1023u);
                                                let _e655 = bitcast<f32>((bitcast<u32>(((_e644 - _e642) * 0.0009775171f)) ^ _e120));
                                                let _e661 = (_e642 + bitcast<f32>((bitcast<u32>((f32(_e650) * _e655)) ^ _e120)));
                                                if _e638 {
                                                } else {
                                                    phi_4933_ = true;
                                                    break;
                                                }
                                                local_8[_e633.member_1] = select(select(_e644, _e661, (_e661 < _e644)), _e644, (_e650 == 1023u));
                                                let _e670 = ((_e537.member_1[1] >> bitcast<u32>(_e647)) & 1023u);
                                                let _e676 = (_e642 + bitcast<f32>((bitcast<u32>((f32(_e670) * _e655)) ^ _e120)));
                                                if _e638 {
                                                } else {
                                                    phi_4933_ = true;
                                                    break;
                                                }
                                                local_7[_e633.member_1] = select(select(_e644, _e676, (_e676 < _e644)), _e644, (_e670 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3980_ = _e631;
                                                phi_4933_ = _e607;
                                                break if !(_e637);
                                            }
                                        }
                                        let _e684 = phi_4933_;
                                        phi_5031_ = _e684;
                                        if _e684 {
                                            break;
                                        }
                                        let _e685 = local_7;
                                        let _e686 = local_8;
                                        let _e697 = type_52(type_49(array<f32, 3>(_e609[0], _e609[1], _e609[2]), array<f32, 3>(_e608[0], _e608[1], _e608[2])), _e537.member_2);
                                        let _e702 = type_52(type_49(array<f32, 3>(_e686[0], _e686[1], _e686[2]), array<f32, 3>(_e685[0], _e685[1], _e685[2])), _e537.member_3);
                                        let _e707 = ((_e609[0] - _e312) * _e317);
                                        let _e708 = ((_e686[0] - _e312) * _e317);
                                        let _e709 = ((_e608[0] - _e313) * _e317);
                                        let _e710 = ((_e685[0] - _e313) * _e317);
                                        let _e715 = ((_e609[1] - _e350) * _e355);
                                        let _e716 = ((_e686[1] - _e350) * _e355);
                                        let _e717 = ((_e608[1] - _e351) * _e355);
                                        let _e718 = ((_e685[1] - _e351) * _e355);
                                        let _e723 = ((_e609[2] - _e388) * _e393);
                                        let _e724 = ((_e686[2] - _e388) * _e393);
                                        let _e725 = ((_e608[2] - _e389) * _e393);
                                        let _e726 = ((_e685[2] - _e389) * _e393);
                                        let _e728 = select(_e725, _e723, (_e723 < _e725));
                                        let _e730 = select(_e726, _e724, (_e724 < _e726));
                                        let _e732 = select(_e725, _e723, (_e723 > _e725));
                                        let _e734 = select(_e726, _e724, (_e724 > _e726));
                                        let _e736 = select(_e709, _e707, (_e707 < _e709));
                                        let _e738 = select(_e710, _e708, (_e708 < _e710));
                                        let _e740 = select(_e717, _e715, (_e715 < _e717));
                                        let _e742 = select(_e718, _e716, (_e716 < _e718));
                                        let _e744 = select(_e740, _e736, (_e736 > _e740));
                                        let _e746 = select(_e742, _e738, (_e738 > _e742));
                                        let _e748 = select(_e728, _e744, (_e744 > _e728));
                                        let _e750 = select(_e730, _e746, (_e746 > _e730));
                                        let _e752 = select(_e709, _e707, (_e707 > _e709));
                                        let _e754 = select(_e710, _e708, (_e708 > _e710));
                                        let _e756 = select(_e717, _e715, (_e715 > _e717));
                                        let _e758 = select(_e718, _e716, (_e716 > _e718));
                                        let _e760 = select(_e756, _e752, (_e752 < _e756));
                                        let _e762 = select(_e758, _e754, (_e754 < _e758));
                                        let _e767 = -(_e728);
                                        let _e768 = -(_e730);
                                        let _e775 = (select(_e732, _e760, (_e760 < _e732)) + (select(_e767, _e732, (_e732 > _e767)) * 0.0000019073523f));
                                        let _e776 = (select(_e734, _e762, (_e762 < _e734)) + (select(_e768, _e734, (_e734 > _e768)) * 0.0000019073523f));
                                        let _e778 = select(_e440, _e748, (_e748 > _e440));
                                        let _e780 = select(_e440, _e750, (_e750 > _e440));
                                        let _e785 = (_e778 <= select(_e473, _e775, (_e775 < _e473)));
                                        let _e786 = (_e780 <= select(_e473, _e776, (_e776 < _e473)));
                                        let _e787 = (_e778 <= _e780);
                                        if _e785 {
                                            if _e786 {
                                                if _e787 {
                                                    phi_4568_ = _e702;
                                                } else {
                                                    phi_4568_ = _e697;
                                                }
                                                let _e789 = phi_4568_;
                                                let _e790 = (_e513 % 128u);
                                                let _e791 = (_e790 < 128u);
                                                if _e791 {
                                                } else {
                                                    phi_5031_ = true;
                                                    break;
                                                }
                                                local_4[_e790] = type_52(type_49(array<f32, 3>(_e789.member.member[0], _e789.member.member[1], _e789.member.member[2]), array<f32, 3>(_e789.member.member_1[0], _e789.member.member_1[1], _e789.member.member_1[2])), _e789.member_1);
                                                if _e791 {
                                                } else {
                                                    phi_5031_ = true;
                                                    break;
                                                }
                                                local_3[_e790] = select(_e780, _e778, (_e778 > _e780));
                                                if _e787 {
                                                    phi_4607_ = _e697;
                                                } else {
                                                    phi_4607_ = _e702;
                                                }
                                                let _e812 = phi_4607_;
                                                phi_4608_ = _e812;
                                                phi_4609_ = (_e513 + 1u);
                                            } else {
                                                phi_4608_ = type_52();
                                                phi_4609_ = u32();
                                            }
                                            let _e814 = phi_4608_;
                                            let _e816 = phi_4609_;
                                            phi_4611_ = _e814;
                                            phi_4612_ = _e816;
                                            phi_4613_ = select(true, false, _e786);
                                        } else {
                                            phi_4611_ = type_52();
                                            phi_4612_ = u32();
                                            phi_4613_ = true;
                                        }
                                        let _e819 = phi_4611_;
                                        let _e821 = phi_4612_;
                                        let _e823 = phi_4613_;
                                        if _e823 {
                                            if _e785 {
                                                phi_4620_ = _e697;
                                            } else {
                                                phi_4620_ = _e702;
                                            }
                                            let _e825 = phi_4620_;
                                            phi_4625_ = _e825;
                                            phi_4626_ = select(_e786, true, _e785);
                                        } else {
                                            phi_4625_ = _e819;
                                            phi_4626_ = _e511;
                                        }
                                        let _e828 = phi_4625_;
                                        let _e830 = phi_4626_;
                                        phi_5080_ = _e473;
                                        phi_5035_ = _e684;
                                        phi_4628_ = _e828;
                                        phi_4629_ = _e830;
                                        phi_4630_ = select(_e821, _e513, _e823);
                                    }
                                    let _e1302 = phi_5080_;
                                    let _e1304 = phi_5035_;
                                    let _e1306 = phi_4628_;
                                    let _e1308 = phi_4629_;
                                    let _e1310 = phi_4630_;
                                    phi_5079_ = _e1302;
                                    phi_5034_ = _e1304;
                                    phi_4631_ = _e1306;
                                    phi_4632_ = (_e477 - 1u);
                                    phi_4633_ = _e1308;
                                    phi_4634_ = _e1310;
                                } else {
                                    phi_5079_ = _e473;
                                    phi_5034_ = _e471;
                                    phi_4631_ = _e509;
                                    phi_4632_ = _e477;
                                    phi_4633_ = _e511;
                                    phi_4634_ = _e513;
                                }
                                let _e1312 = phi_5079_;
                                let _e1314 = phi_5034_;
                                let _e1316 = phi_4631_;
                                let _e1318 = phi_4632_;
                                let _e1320 = phi_4633_;
                                let _e1322 = phi_4634_;
                                phi_5078_ = _e1312;
                                phi_5033_ = _e1314;
                                phi_4635_ = _e1316;
                                phi_4636_ = _e1318;
                                phi_4637_ = _e1320;
                                phi_4638_ = _e1322;
                            } else {
                                phi_5078_ = _e473;
                                phi_5033_ = _e471;
                                phi_4635_ = type_52();
                                phi_4636_ = u32();
                                phi_4637_ = bool();
                                phi_4638_ = u32();
                            }
                            let _e1324 = phi_5078_;
                            let _e1326 = phi_5033_;
                            let _e1328 = phi_4635_;
                            let _e1330 = phi_4636_;
                            let _e1332 = phi_4637_;
                            let _e1334 = phi_4638_;
                            phi_5077_ = _e1324;
                            phi_5032_ = _e1326;
                            phi_2886_ = _e1328;
                            phi_2889_ = _e1330;
                            phi_2891_ = _e1332;
                            phi_2893_ = _e1334;
                            phi_4639_ = _e485;
                        } else {
                            phi_5077_ = _e473;
                            phi_5032_ = _e471;
                            phi_2886_ = type_52();
                            phi_2889_ = u32();
                            phi_2891_ = bool();
                            phi_2893_ = u32();
                            phi_4639_ = false;
                        }
                        let _e1336 = phi_5077_;
                        let _e1338 = phi_5032_;
                        let _e1340 = phi_2886_;
                        let _e1342 = phi_2889_;
                        let _e1344 = phi_2891_;
                        let _e1346 = phi_2893_;
                        let _e1348 = phi_4639_;
                        continue;
                        continuing {
                            phi_4884_ = _e1338;
                            phi_4875_ = _e1336;
                            phi_2885_ = _e1340;
                            phi_2888_ = _e1342;
                            phi_2890_ = _e1344;
                            phi_2892_ = _e1346;
                            phi_5031_ = _e1338;
                            break if !(_e1348);
                        }
                    }
                    let _e1351 = phi_5031_;
                    if _e1351 {
                        break;
                    }
                    phi_4646_ = type_4(0u, 8u);
                    loop {
                        let _e1353 = phi_4646_;
                        if (_e1353.member < _e1353.member_1) {
                            phi_4647_ = type_4((_e1353.member + 1u), _e1353.member_1);
                            phi_4670_ = type_4(1u, _e1353.member);
                        } else {
                            phi_4647_ = _e1353;
                            phi_4670_ = type_4(0u, type_4().member_1);
                        }
                        let _e1366 = phi_4647_;
                        let _e1368 = phi_4670_;
                        let _e1372 = (bitcast<i32>(_e1368.member) != 0i);
                        if _e1372 {
                            let _e1373 = (_e1368.member_1 < 8u);
                            if _e1373 {
                            } else {
                                phi_5070_ = true;
                                break;
                            }
                            let _e1375 = local_2[_e1368.member_1];
                            if (_e1375.member_3 != 4294967295u) {
                                let _e1381 = -(_e407);
                                let _e1382 = (_e1381 / 3i);
                                let _e1389 = bitcast<f32>((bitcast<u32>((_e1382 + 127i)) << bitcast<u32>(23i)));
                                let _e1397 = (((_e1375.member * _e1389) * _e1389) * bitcast<f32>((bitcast<u32>(((_e1381 - (2i * _e1382)) + 127i)) << bitcast<u32>(23i))));
                                let _e1399 = select(340282350000000000000000000000000000000f, _e1397, (_e1397 < 340282350000000000000000000000000000000f));
                                phi_4736_ = type_22(select(-340282350000000000000000000000000000000f, _e1399, (_e1399 > -340282350000000000000000000000000000000f)), _e1375.member_1, _e1375.member_2, _e1375.member_3);
                            } else {
                                phi_4736_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1404 = phi_4736_;
                            if _e1373 {
                            } else {
                                phi_5070_ = true;
                                break;
                            }
                            local_2[_e1368.member_1] = type_22(_e1404.member, _e1404.member_1, _e1404.member_2, _e1404.member_3);
                        }
                        continue;
                        continuing {
                            phi_4646_ = _e1366;
                            phi_5070_ = _e1351;
                            break if !(_e1372);
                        }
                    }
                    let _e1412 = phi_5070_;
                    if _e1412 {
                        break;
                    }
                    let _e1413 = local_2;
                    if _e136 {
                    } else {
                        break;
                    }
                    global_6.member[_e134] = array<type_22, 8>(type_22(_e1413[0].member, _e1413[0].member_1, _e1413[0].member_2, _e1413[0].member_3), type_22(_e1413[1].member, _e1413[1].member_1, _e1413[1].member_2, _e1413[1].member_3), type_22(_e1413[2].member, _e1413[2].member_1, _e1413[2].member_2, _e1413[2].member_3), type_22(_e1413[3].member, _e1413[3].member_1, _e1413[3].member_2, _e1413[3].member_3), type_22(_e1413[4].member, _e1413[4].member_1, _e1413[4].member_2, _e1413[4].member_3), type_22(_e1413[5].member, _e1413[5].member_1, _e1413[5].member_2, _e1413[5].member_3), type_22(_e1413[6].member, _e1413[6].member_1, _e1413[6].member_2, _e1413[6].member_3), type_22(_e1413[7].member, _e1413[7].member_1, _e1413[7].member_2, _e1413[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
