struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_19 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<type_19>,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_33 {
    member: type_19,
    member_1: f32,
}

struct type_35 {
    member: type_33,
    member_1: u32,
    member_2: u32,
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

struct type_47 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_49 {
    member: array<type_47>,
}

struct type_53 {
    member: type_44,
    member_1: u32,
}

struct type_62 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_1: type_21;
@group(0) @binding(0) 
var<uniform> global_2: type_37;
@group(0) @binding(3) 
var<storage> global_3: type_26;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_5: type_62;
@group(0) @binding(1) 
var<storage> global_6: type_41;
@group(0) @binding(2) 
var<storage> global_7: type_49;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;
    var local_3: array<f32, 3>;
    var local_4: array<f32, 128>;
    var local_5: array<type_53, 128>;
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
    var phi_357_: i32;
    var phi_358_: i32;
    var phi_368_: bool;
    var phi_378_: u32;
    var phi_379_: u32;
    var phi_381_: bool;
    var phi_386_: u32;
    var phi_419_: i32;
    var phi_437_: f32;
    var phi_443_: f32;
    var phi_454_: f32;
    var phi_460_: f32;
    var phi_483_: f32;
    var phi_494_: f32;
    var phi_503_: f32;
    var phi_509_: f32;
    var phi_520_: f32;
    var phi_526_: f32;
    var phi_549_: f32;
    var phi_560_: f32;
    var phi_569_: f32;
    var phi_575_: f32;
    var phi_586_: f32;
    var phi_592_: f32;
    var phi_615_: f32;
    var phi_626_: f32;
    var phi_726_: f32;
    var phi_727_: f32;
    var phi_4926_: bool;
    var phi_2864_: type_35;
    var phi_2867_: type_53;
    var phi_2869_: u32;
    var phi_2871_: bool;
    var phi_2873_: u32;
    var phi_2884_: bool;
    var phi_2929_: type_53;
    var phi_2930_: bool;
    var phi_2931_: u32;
    var phi_3854_: type_39;
    var phi_3863_: type_7;
    var phi_3864_: type_7;
    var phi_3887_: type_7;
    var phi_4919_: bool;
    var phi_4017_: type_7;
    var phi_4018_: type_7;
    var phi_4041_: type_7;
    var phi_4979_: bool;
    var phi_4604_: type_53;
    var phi_4643_: type_53;
    var phi_4644_: type_53;
    var phi_4645_: u32;
    var phi_4647_: type_53;
    var phi_4648_: u32;
    var phi_4649_: bool;
    var phi_4656_: type_53;
    var phi_4661_: type_53;
    var phi_4662_: bool;
    var phi_4996_: bool;
    var phi_2950_: type_35;
    var phi_2953_: type_7;
    var phi_2954_: type_7;
    var phi_2976_: type_7;
    var phi_3021_: u32;
    var phi_3045_: type_47;
    var phi_4992_: bool;
    var phi_3056_: type_7;
    var phi_3057_: type_7;
    var phi_3080_: type_7;
    var phi_3090_: type_7;
    var phi_3091_: type_7;
    var phi_3114_: type_7;
    var phi_4987_: bool;
    var phi_5000_: bool;
    var phi_4999_: bool;
    var phi_3677_: vec3<f32>;
    var phi_3678_: vec3<f32>;
    var phi_3709_: bool;
    var phi_3718_: vec3<f32>;
    var phi_3758_: type_19;
    var phi_3760_: type_19;
    var phi_3761_: bool;
    var phi_3765_: type_19;
    var phi_3766_: type_19;
    var phi_3767_: type_19;
    var phi_3768_: bool;
    var phi_3772_: type_19;
    var phi_3773_: bool;
    var phi_3777_: type_19;
    var phi_3778_: bool;
    var phi_3782_: type_19;
    var phi_3807_: bool;
    var phi_3808_: bool;
    var phi_3815_: type_35;
    var phi_3816_: type_35;
    var phi_3817_: type_35;
    var phi_5002_: bool;
    var phi_2951_: type_35;
    var phi_5001_: bool;
    var phi_5064_: bool;
    var phi_4664_: type_35;
    var phi_4665_: type_53;
    var phi_4666_: bool;
    var phi_4667_: u32;
    var phi_5063_: bool;
    var phi_4668_: type_35;
    var phi_4669_: type_53;
    var phi_4670_: u32;
    var phi_4671_: bool;
    var phi_4672_: u32;
    var phi_5062_: bool;
    var phi_4673_: type_35;
    var phi_4674_: type_53;
    var phi_4675_: u32;
    var phi_4676_: bool;
    var phi_4677_: u32;
    var phi_5061_: bool;
    var phi_2865_: type_35;
    var phi_2868_: type_53;
    var phi_2870_: u32;
    var phi_2872_: bool;
    var phi_2874_: u32;
    var phi_4678_: bool;
    var phi_5060_: bool;
    var local_17: type_35;
    var phi_4730_: type_19;
    var local_18: type_35;
    var local_19: type_35;

    switch bitcast<i32>(0u) {
        default: {
            let _e86 = global;
            let _e89 = arrayLength((&global_6.member));
            let _e100 = arrayLength((&global_5.member));
            let _e104 = global_2.member[0u][0u];
            let _e108 = global_2.member[0u][1u];
            let _e112 = global_2.member[0u][2u];
            let _e116 = global_2.member[1u][0u];
            let _e120 = global_2.member[1u][1u];
            let _e124 = global_2.member[1u][2u];
            let _e128 = global_2.member[1u][3u];
            let _e132 = (_e86.x + (_e86.y * 2097152u));
            let _e139 = (_e132 < arrayLength((&global_3.member)));
            if _e139 {
                let _e140 = (_e132 < arrayLength((&global_1.member)));
                if _e140 {
                    let _e141 = (_e132 < arrayLength((&global_4.member)));
                    if _e141 {
                        if _e139 {
                        } else {
                            break;
                        }
                        let _e151 = global_3.member[_e132].member.member_2[0u];
                        let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                        let _e159 = global_3.member[_e132].member.member_2[1u];
                        let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                        let _e167 = global_3.member[_e132].member.member_2[2u];
                        let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                        let _e175 = global_3.member[_e132].member.member[0u];
                        let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                        let _e183 = global_3.member[_e132].member.member[1u];
                        let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                        let _e191 = global_3.member[_e132].member.member[2u];
                        let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                        let _e195 = select(_e161, _e153, (_e161 < _e153));
                        let _e197 = select(_e169, _e195, (_e169 < _e195));
                        let _e199 = select(_e177, _e197, (_e177 < _e197));
                        let _e201 = select(_e185, _e199, (_e185 < _e199));
                        let _e203 = select(_e193, _e201, (_e193 < _e201));
                        let _e208 = global_3.member[_e132].member.member_1;
                        let _e210 = (bitcast<u32>(_e208) & 2147483647u);
                        let _e218 = global_3.member[_e132].member.member_3;
                        let _e224 = (((select(_e210, _e203, (_e210 < _e203)) < 2139095040u) && ((bitcast<u32>(_e218) & 2147483647u) <= 2139095040u)) && (_e197 > 0u));
                        if _e224 {
                            let _e227 = (bitcast<u32>(bitcast<f32>(_e197)) & 2147483647u);
                            if (_e227 >= 8388608u) {
                                phi_357_ = (bitcast<i32>((_e227 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_357_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e227)), 32u, (_e227 == 0u))));
                            }
                            let _e241 = phi_357_;
                            phi_358_ = _e241;
                        } else {
                            phi_358_ = 0i;
                        }
                        let _e243 = phi_358_;
                        let _e244 = (_e153 == _e197);
                        if _e244 {
                            phi_368_ = true;
                        } else {
                            phi_368_ = (_e161 == _e197);
                        }
                        let _e247 = phi_368_;
                        let _e248 = select(1u, 0u, _e244);
                        if _e247 {
                            let _e249 = (_e248 + 1u);
                            phi_378_ = _e249;
                            phi_379_ = _e249;
                            phi_381_ = select(true, false, (_e249 == 2u));
                        } else {
                            phi_378_ = u32();
                            phi_379_ = 0u;
                            phi_381_ = true;
                        }
                        let _e253 = phi_378_;
                        let _e255 = phi_379_;
                        let _e257 = phi_381_;
                        if _e257 {
                            phi_386_ = (_e255 + 1u);
                        } else {
                            phi_386_ = 0u;
                        }
                        let _e261 = phi_386_;
                        let _e262 = select(_e253, _e255, _e257);
                        let _e263 = select(_e248, select(2u, _e248, _e247), _e257);
                        let _e264 = -(_e243);
                        if (_e264 < -126i) {
                            phi_419_ = -126i;
                        } else {
                            phi_419_ = select(_e264, 127i, (_e264 > 127i));
                        }
                        let _e269 = phi_419_;
                        let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                        let _e280 = bitcast<f32>((bitcast<u32>(((_e264 - _e269) + 127i)) << bitcast<u32>(23i)));
                        let _e285 = global_3.member[_e132].member.member;
                        let _e286 = (_e262 == 0u);
                        if _e286 {
                            phi_437_ = _e285[0];
                        } else {
                            phi_437_ = _e285[1];
                        }
                        let _e290 = phi_437_;
                        let _e291 = (_e262 == 2u);
                        if _e291 {
                            phi_443_ = _e285[2];
                        } else {
                            phi_443_ = _e290;
                        }
                        let _e294 = phi_443_;
                        let _e295 = global_3.member[_e132].member.member_2;
                        if _e286 {
                            phi_454_ = _e295[0];
                        } else {
                            phi_454_ = _e295[1];
                        }
                        let _e299 = phi_454_;
                        if _e291 {
                            phi_460_ = _e295[2];
                        } else {
                            phi_460_ = _e299;
                        }
                        let _e302 = phi_460_;
                        let _e304 = ((_e302 * _e274) * _e280);
                        let _e308 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e308 {
                            let _e312 = (bitcast<f32>((bitcast<u32>(_e294) & 2147483647u)) * 0.00000011920929f);
                            phi_483_ = select(0.00000000000011368684f, _e312, (_e312 > 0.00000000000011368684f));
                        } else {
                            phi_483_ = 0f;
                        }
                        let _e316 = phi_483_;
                        let _e317 = (_e294 + _e316);
                        let _e318 = (_e294 - _e316);
                        let _e319 = select(_e304, 0f, _e308);
                        if _e308 {
                            phi_494_ = 38685626000000000000000000f;
                        } else {
                            phi_494_ = (1f / _e304);
                        }
                        let _e322 = phi_494_;
                        let _e323 = (_e261 == 0u);
                        if _e323 {
                            phi_503_ = _e285[0];
                        } else {
                            phi_503_ = _e285[1];
                        }
                        let _e327 = phi_503_;
                        let _e328 = (_e261 == 2u);
                        if _e328 {
                            phi_509_ = _e285[2];
                        } else {
                            phi_509_ = _e327;
                        }
                        let _e331 = phi_509_;
                        if _e323 {
                            phi_520_ = _e295[0];
                        } else {
                            phi_520_ = _e295[1];
                        }
                        let _e335 = phi_520_;
                        if _e328 {
                            phi_526_ = _e295[2];
                        } else {
                            phi_526_ = _e335;
                        }
                        let _e338 = phi_526_;
                        let _e340 = ((_e338 * _e274) * _e280);
                        let _e344 = (bitcast<f32>((bitcast<u32>(_e340) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e344 {
                            let _e348 = (bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)) * 0.00000011920929f);
                            phi_549_ = select(0.00000000000011368684f, _e348, (_e348 > 0.00000000000011368684f));
                        } else {
                            phi_549_ = 0f;
                        }
                        let _e352 = phi_549_;
                        let _e353 = (_e331 + _e352);
                        let _e354 = (_e331 - _e352);
                        let _e355 = select(_e340, 0f, _e344);
                        if _e344 {
                            phi_560_ = 38685626000000000000000000f;
                        } else {
                            phi_560_ = (1f / _e340);
                        }
                        let _e358 = phi_560_;
                        let _e359 = (_e263 == 0u);
                        if _e359 {
                            phi_569_ = _e285[0];
                        } else {
                            phi_569_ = _e285[1];
                        }
                        let _e363 = phi_569_;
                        let _e364 = (_e263 == 2u);
                        if _e364 {
                            phi_575_ = _e285[2];
                        } else {
                            phi_575_ = _e363;
                        }
                        let _e367 = phi_575_;
                        if _e359 {
                            phi_586_ = _e295[0];
                        } else {
                            phi_586_ = _e295[1];
                        }
                        let _e371 = phi_586_;
                        if _e364 {
                            phi_592_ = _e295[2];
                        } else {
                            phi_592_ = _e371;
                        }
                        let _e374 = phi_592_;
                        let _e376 = ((_e374 * _e274) * _e280);
                        let _e380 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e380 {
                            let _e384 = (bitcast<f32>((bitcast<u32>(_e367) & 2147483647u)) * 0.00000011920929f);
                            phi_615_ = select(0.00000000000011368684f, _e384, (_e384 > 0.00000000000011368684f));
                        } else {
                            phi_615_ = 0f;
                        }
                        let _e388 = phi_615_;
                        let _e389 = (_e367 + _e388);
                        let _e390 = (_e367 - _e388);
                        let _e391 = select(_e376, 0f, _e380);
                        if _e380 {
                            phi_626_ = 38685626000000000000000000f;
                        } else {
                            phi_626_ = (1f / _e376);
                        }
                        let _e394 = phi_626_;
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
                            phi_726_ = select(-340282350000000000000000000000000000000f, _e434, (_e434 > -340282350000000000000000000000000000000f));
                            phi_727_ = select(-340282350000000000000000000000000000000f, _e427, (_e427 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_726_ = 0f;
                            phi_727_ = 1f;
                        }
                        let _e438 = phi_726_;
                        let _e440 = phi_727_;
                        if _e139 {
                        } else {
                            break;
                        }
                        let _e446 = global_3.member[_e132].member_2;
                        local_5 = array<type_53, 128>(type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_16 = array<f32, 3>(bitcast<f32>(_e104), bitcast<f32>(_e108), bitcast<f32>(_e112));
                        let _e450 = (_e262 % 3u);
                        let _e451 = (_e450 < 3u);
                        if _e451 {
                        } else {
                            break;
                        }
                        let _e453 = local_16[_e450];
                        let _e454 = (_e261 % 3u);
                        let _e455 = (_e454 < 3u);
                        if _e455 {
                        } else {
                            break;
                        }
                        let _e457 = local_16[_e454];
                        let _e458 = (_e263 % 3u);
                        let _e459 = (_e458 < 3u);
                        if _e459 {
                        } else {
                            break;
                        }
                        let _e461 = local_16[_e458];
                        local_15 = array<f32, 3>(bitcast<f32>(_e116), bitcast<f32>(_e120), bitcast<f32>(_e124));
                        if _e451 {
                        } else {
                            break;
                        }
                        let _e465 = local_15[_e450];
                        if _e455 {
                        } else {
                            break;
                        }
                        let _e467 = local_15[_e454];
                        if _e459 {
                        } else {
                            break;
                        }
                        let _e469 = local_15[_e458];
                        phi_4926_ = false;
                        phi_2864_ = type_35(type_33(type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e438), 0u, 0u);
                        phi_2867_ = type_53(type_44(array<f32, 3>(_e453, _e457, _e461), array<f32, 3>(_e465, _e467, _e469)), select(0u, 2147483648u, (_e89 == 0u)));
                        phi_2869_ = ((3u * _e89) + 1u);
                        phi_2871_ = (_e440 <= _e438);
                        phi_2873_ = 0u;
                        loop {
                            let _e477 = phi_4926_;
                            let _e479 = phi_2864_;
                            let _e481 = phi_2867_;
                            let _e483 = phi_2869_;
                            let _e485 = phi_2871_;
                            let _e487 = phi_2873_;
                            local_17 = _e479;
                            local_18 = _e479;
                            if _e485 {
                                phi_2884_ = true;
                            } else {
                                phi_2884_ = (_e487 > 0u);
                            }
                            let _e490 = phi_2884_;
                            if _e490 {
                                let _e491 = (_e483 > 0u);
                                if _e491 {
                                    if _e485 {
                                        phi_2929_ = _e481;
                                        phi_2930_ = _e485;
                                        phi_2931_ = _e487;
                                    } else {
                                        let _e492 = (_e487 - 1u);
                                        let _e493 = (_e492 % 128u);
                                        let _e494 = (_e493 < 128u);
                                        if _e494 {
                                        } else {
                                            phi_5060_ = true;
                                            break;
                                        }
                                        let _e496 = local_5[_e493];
                                        if _e494 {
                                        } else {
                                            phi_5060_ = true;
                                            break;
                                        }
                                        let _e512 = local_4[_e493];
                                        phi_2929_ = type_53(type_44(array<f32, 3>(_e496.member.member[0], _e496.member.member[1], _e496.member.member[2]), array<f32, 3>(_e496.member.member_1[0], _e496.member.member_1[1], _e496.member.member_1[2])), _e496.member_1);
                                        phi_2930_ = (_e512 <= _e479.member.member_1);
                                        phi_2931_ = _e492;
                                    }
                                    let _e517 = phi_2929_;
                                    let _e519 = phi_2930_;
                                    let _e521 = phi_2931_;
                                    if _e519 {
                                        if ((_e517.member_1 & 2147483648u) != 0u) {
                                            phi_4996_ = _e477;
                                            phi_2950_ = _e479;
                                            phi_2953_ = type_7(0u, ((_e517.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e850 = phi_4996_;
                                                let _e852 = phi_2950_;
                                                let _e854 = phi_2953_;
                                                local_19 = _e852;
                                                if (_e854.member < _e854.member_1) {
                                                    phi_2954_ = type_7((_e854.member + 1u), _e854.member_1);
                                                    phi_2976_ = type_7(1u, _e854.member);
                                                } else {
                                                    phi_2954_ = _e854;
                                                    phi_2976_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e867 = phi_2954_;
                                                let _e869 = phi_2976_;
                                                let _e873 = (bitcast<i32>(_e869.member) != 0i);
                                                if _e873 {
                                                    let _e879 = type_35(_e852.member, _e852.member_1, (_e852.member_2 + 1u));
                                                    local_1 = array<f32, 3>(_e517.member.member[0], _e517.member.member[1], _e517.member.member[2]);
                                                    local = array<f32, 3>(_e517.member.member_1[0], _e517.member.member_1[1], _e517.member.member_1[2]);
                                                    let _e890 = ((_e517.member_1 & 268435455u) + _e869.member_1);
                                                    let _e891 = (_e890 < arrayLength((&global_7.member)));
                                                    if _e891 {
                                                        if _e891 {
                                                        } else {
                                                            phi_5001_ = true;
                                                            break;
                                                        }
                                                        let _e894 = global_7.member[_e890].member_1;
                                                        phi_3021_ = _e894;
                                                    } else {
                                                        phi_3021_ = 4294967295u;
                                                    }
                                                    let _e896 = phi_3021_;
                                                    local_12 = array<u32, 3>(_e262, _e261, _e263);
                                                    if _e891 {
                                                        if _e891 {
                                                        } else {
                                                            phi_5001_ = true;
                                                            break;
                                                        }
                                                        let _e899 = global_7.member[_e890];
                                                        phi_3045_ = _e899;
                                                    } else {
                                                        phi_3045_ = type_47(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e901 = phi_3045_;
                                                    local_14 = array<u32, 3>(_e901.member[0], _e901.member[1], _e901.member[2]);
                                                    local_13[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_13[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_13[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_4992_ = _e850;
                                                    phi_3056_ = type_7(0u, 3u);
                                                    loop {
                                                        let _e911 = phi_4992_;
                                                        let _e913 = phi_3056_;
                                                        if (_e913.member < _e913.member_1) {
                                                            phi_3057_ = type_7((_e913.member + 1u), _e913.member_1);
                                                            phi_3080_ = type_7(1u, _e913.member);
                                                        } else {
                                                            phi_3057_ = _e913;
                                                            phi_3080_ = type_7(0u, type_7().member_1);
                                                        }
                                                        let _e926 = phi_3057_;
                                                        let _e928 = phi_3080_;
                                                        let _e932 = (bitcast<i32>(_e928.member) != 0i);
                                                        if _e932 {
                                                            phi_3090_ = type_7(0u, 3u);
                                                            loop {
                                                                let _e934 = phi_3090_;
                                                                if (_e934.member < _e934.member_1) {
                                                                    phi_3091_ = type_7((_e934.member + 1u), _e934.member_1);
                                                                    phi_3114_ = type_7(1u, _e934.member);
                                                                } else {
                                                                    phi_3091_ = _e934;
                                                                    phi_3114_ = type_7(0u, type_7().member_1);
                                                                }
                                                                let _e947 = phi_3091_;
                                                                let _e949 = phi_3114_;
                                                                let _e953 = (bitcast<i32>(_e949.member) != 0i);
                                                                if _e953 {
                                                                    let _e954 = (_e928.member_1 < 3u);
                                                                    if _e954 {
                                                                    } else {
                                                                        phi_4987_ = true;
                                                                        break;
                                                                    }
                                                                    let _e956 = local_14[_e928.member_1];
                                                                    let _e957 = (_e949.member_1 < 3u);
                                                                    if _e957 {
                                                                    } else {
                                                                        phi_4987_ = true;
                                                                        break;
                                                                    }
                                                                    let _e959 = local_12[_e949.member_1];
                                                                    let _e964 = ((_e956 >> bitcast<u32>(((10u * _e959) & 31u))) & 1023u);
                                                                    if _e957 {
                                                                    } else {
                                                                        phi_4987_ = true;
                                                                        break;
                                                                    }
                                                                    let _e966 = local_1[_e949.member_1];
                                                                    if _e957 {
                                                                    } else {
                                                                        phi_4987_ = true;
                                                                        break;
                                                                    }
                                                                    let _e968 = local[_e949.member_1];
                                                                    let _e979 = (_e966 + bitcast<f32>((bitcast<u32>((f32(_e964) * bitcast<f32>((bitcast<u32>(((_e968 - _e966) * 0.0009775171f)) ^ _e128)))) ^ _e128)));
                                                                    if _e954 {
                                                                    } else {
                                                                        phi_4987_ = true;
                                                                        break;
                                                                    }
                                                                    if _e957 {
                                                                    } else {
                                                                        phi_4987_ = true;
                                                                        break;
                                                                    }
                                                                    local_13[_e928.member_1][_e949.member_1] = select(select(_e968, _e979, (_e979 < _e968)), _e968, (_e964 == 1023u));
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_3090_ = _e947;
                                                                    phi_4987_ = _e911;
                                                                    break if !(_e953);
                                                                }
                                                            }
                                                            let _e988 = phi_4987_;
                                                            phi_4999_ = _e988;
                                                            if _e988 {
                                                                break;
                                                            }
                                                            phi_5000_ = _e988;
                                                        } else {
                                                            phi_5000_ = _e911;
                                                        }
                                                        let _e990 = phi_5000_;
                                                        continue;
                                                        continuing {
                                                            phi_4992_ = _e990;
                                                            phi_3056_ = _e926;
                                                            phi_4999_ = _e990;
                                                            break if !(_e932);
                                                        }
                                                    }
                                                    let _e993 = phi_4999_;
                                                    phi_5001_ = _e993;
                                                    if _e993 {
                                                        break;
                                                    }
                                                    let _e994 = local_13;
                                                    let _e1011 = (_e994[0][2] - _e367);
                                                    let _e1014 = (((_e994[0][0] - _e294) * _e391) - (_e1011 * _e319));
                                                    let _e1017 = (((_e994[0][1] - _e331) * _e391) - (_e1011 * _e355));
                                                    let _e1020 = (_e994[1][2] - _e367);
                                                    let _e1023 = (((_e994[1][0] - _e294) * _e391) - (_e1020 * _e319));
                                                    let _e1026 = (((_e994[1][1] - _e331) * _e391) - (_e1020 * _e355));
                                                    let _e1029 = (_e994[2][2] - _e367);
                                                    let _e1032 = (((_e994[2][0] - _e294) * _e391) - (_e1029 * _e319));
                                                    let _e1035 = (((_e994[2][1] - _e331) * _e391) - (_e1029 * _e355));
                                                    let _e1036 = (_e1032 * _e1026);
                                                    let _e1037 = (_e1035 * _e1023);
                                                    let _e1038 = (_e1014 * _e1035);
                                                    let _e1039 = (_e1017 * _e1032);
                                                    let _e1040 = (_e1023 * _e1017);
                                                    let _e1041 = (_e1026 * _e1014);
                                                    let _e1046 = (((_e1036 >= _e1037) && (_e1038 >= _e1039)) && (_e1040 >= _e1041));
                                                    if (_e1046 || (((_e1036 <= _e1037) && (_e1038 <= _e1039)) && (_e1040 <= _e1041))) {
                                                        let _e1053 = select(-1f, 1f, _e1046);
                                                        let _e1055 = ((_e1036 - _e1037) * _e1053);
                                                        let _e1057 = select(0f, _e1055, (_e1055 > 0f));
                                                        let _e1059 = ((_e1038 - _e1039) * _e1053);
                                                        let _e1061 = select(0f, _e1059, (_e1059 > 0f));
                                                        let _e1063 = ((_e1040 - _e1041) * _e1053);
                                                        let _e1065 = select(0f, _e1063, (_e1063 > 0f));
                                                        let _e1067 = ((_e1057 + _e1061) + _e1065);
                                                        if (_e1067 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_3772_ = type_19();
                                                            phi_3773_ = true;
                                                        } else {
                                                            let _e1070 = select(_e994[1][0], _e994[0][0], (_e994[0][0] < _e994[1][0]));
                                                            let _e1074 = select(_e994[1][0], _e994[0][0], (_e994[0][0] > _e994[1][0]));
                                                            let _e1078 = select(_e994[1][1], _e994[0][1], (_e994[0][1] < _e994[1][1]));
                                                            let _e1082 = select(_e994[1][1], _e994[0][1], (_e994[0][1] > _e994[1][1]));
                                                            let _e1086 = select(_e994[1][2], _e994[0][2], (_e994[0][2] < _e994[1][2]));
                                                            let _e1090 = select(_e994[1][2], _e994[0][2], (_e994[0][2] > _e994[1][2]));
                                                            let _e1095 = ((select(_e994[2][0], _e1070, (_e1070 < _e994[2][0])) - _e317) * _e322);
                                                            let _e1096 = ((select(_e994[2][0], _e1074, (_e1074 > _e994[2][0])) - _e318) * _e322);
                                                            let _e1099 = ((select(_e994[2][1], _e1078, (_e1078 < _e994[2][1])) - _e353) * _e358);
                                                            let _e1100 = ((select(_e994[2][1], _e1082, (_e1082 > _e994[2][1])) - _e354) * _e358);
                                                            let _e1103 = ((select(_e994[2][2], _e1086, (_e1086 < _e994[2][2])) - _e389) * _e394);
                                                            let _e1104 = ((select(_e994[2][2], _e1090, (_e1090 > _e994[2][2])) - _e390) * _e394);
                                                            let _e1106 = select(_e1104, _e1103, (_e1103 < _e1104));
                                                            let _e1108 = select(_e1104, _e1103, (_e1103 > _e1104));
                                                            let _e1110 = select(_e1096, _e1095, (_e1095 < _e1096));
                                                            let _e1112 = select(_e1100, _e1099, (_e1099 < _e1100));
                                                            let _e1114 = select(_e1112, _e1110, (_e1110 > _e1112));
                                                            let _e1116 = select(_e1106, _e1114, (_e1114 > _e1106));
                                                            let _e1118 = select(_e1096, _e1095, (_e1095 > _e1096));
                                                            let _e1120 = select(_e1100, _e1099, (_e1099 > _e1100));
                                                            let _e1122 = select(_e1120, _e1118, (_e1118 < _e1120));
                                                            let _e1124 = select(_e1108, _e1122, (_e1122 < _e1108));
                                                            let _e1125 = -(_e1106);
                                                            let _e1131 = select(_e440, _e1116, (_e1116 > _e440));
                                                            if (_e1131 > (_e1124 + (select(_e1125, _e1108, (_e1108 > _e1125)) * 0.0000019073523f))) {
                                                                phi_3767_ = type_19();
                                                                phi_3768_ = true;
                                                            } else {
                                                                let _e1133 = (_e1131 > _e852.member.member_1);
                                                                if _e1133 {
                                                                    phi_3766_ = type_19();
                                                                } else {
                                                                    let _e1137 = (_e994[1][0] - _e994[0][0]);
                                                                    let _e1138 = (_e994[1][1] - _e994[0][1]);
                                                                    let _e1139 = (_e994[1][2] - _e994[0][2]);
                                                                    let _e1140 = vec3<f32>(_e1137, _e1138, _e1139);
                                                                    let _e1141 = (_e994[2][0] - _e994[1][0]);
                                                                    let _e1142 = (_e994[2][1] - _e994[1][1]);
                                                                    let _e1143 = (_e994[2][2] - _e994[1][2]);
                                                                    let _e1144 = vec3<f32>(_e1141, _e1142, _e1143);
                                                                    let _e1145 = (_e994[0][0] - _e994[2][0]);
                                                                    let _e1146 = (_e994[0][1] - _e994[2][1]);
                                                                    let _e1147 = (_e994[0][2] - _e994[2][2]);
                                                                    let _e1148 = vec3<f32>(_e1145, _e1146, _e1147);
                                                                    let _e1151 = bitcast<f32>((bitcast<u32>(_e1137) & 2147483647u));
                                                                    let _e1154 = bitcast<f32>((bitcast<u32>(_e1138) & 2147483647u));
                                                                    let _e1156 = select(_e1154, _e1151, (_e1151 > _e1154));
                                                                    let _e1159 = bitcast<f32>((bitcast<u32>(_e1139) & 2147483647u));
                                                                    let _e1161 = select(_e1159, _e1156, (_e1156 > _e1159));
                                                                    let _e1164 = bitcast<f32>((bitcast<u32>(_e1141) & 2147483647u));
                                                                    let _e1167 = bitcast<f32>((bitcast<u32>(_e1142) & 2147483647u));
                                                                    let _e1169 = select(_e1167, _e1164, (_e1164 > _e1167));
                                                                    let _e1172 = bitcast<f32>((bitcast<u32>(_e1143) & 2147483647u));
                                                                    let _e1174 = select(_e1172, _e1169, (_e1169 > _e1172));
                                                                    let _e1177 = bitcast<f32>((bitcast<u32>(_e1145) & 2147483647u));
                                                                    let _e1180 = bitcast<f32>((bitcast<u32>(_e1146) & 2147483647u));
                                                                    let _e1182 = select(_e1180, _e1177, (_e1177 > _e1180));
                                                                    let _e1185 = bitcast<f32>((bitcast<u32>(_e1147) & 2147483647u));
                                                                    let _e1187 = select(_e1185, _e1182, (_e1182 > _e1185));
                                                                    let _e1189 = select(_e1174, _e1161, (_e1161 > _e1174));
                                                                    let _e1191 = select(_e1187, _e1189, (_e1189 > _e1187));
                                                                    if (_e1161 == _e1191) {
                                                                        phi_3677_ = _e1144;
                                                                        phi_3678_ = _e1148;
                                                                    } else {
                                                                        let _e1194 = vec3((_e1174 == _e1191));
                                                                        phi_3677_ = select(_e1140, _e1148, _e1194);
                                                                        phi_3678_ = select(_e1144, _e1140, _e1194);
                                                                    }
                                                                    let _e1198 = phi_3677_;
                                                                    let _e1200 = phi_3678_;
                                                                    let _e1207 = ((_e1198.y * _e1200.z) - (_e1200.y * _e1198.z));
                                                                    let _e1212 = ((_e1198.z * _e1200.x) - (_e1200.z * _e1198.x));
                                                                    let _e1215 = ((_e1198.x * _e1200.y) - (_e1200.x * _e1198.y));
                                                                    if (_e1057 >= _e1061) {
                                                                        phi_3709_ = select(true, false, (_e1057 >= _e1065));
                                                                    } else {
                                                                        phi_3709_ = true;
                                                                    }
                                                                    let _e1220 = phi_3709_;
                                                                    if _e1220 {
                                                                        phi_3718_ = select(vec3<f32>(_e994[2][0], _e994[2][1], _e994[2][2]), vec3<f32>(_e994[1][0], _e994[1][1], _e994[1][2]), vec3((_e1061 >= _e1065)));
                                                                    } else {
                                                                        phi_3718_ = vec3<f32>(_e994[0][0], _e994[0][1], _e994[0][2]);
                                                                    }
                                                                    let _e1225 = phi_3718_;
                                                                    let _e1242 = ((((_e1207 * (_e1225.x - _e294)) + (_e1212 * (_e1225.y - _e331))) + (_e1215 * (_e1225.z - _e367))) / (((_e1207 * _e319) + (_e1212 * _e355)) + (_e1215 * _e391)));
                                                                    let _e1244 = select(_e1124, _e1242, (_e1242 < _e1124));
                                                                    let _e1246 = select(_e1116, _e1244, (_e1244 > _e1116));
                                                                    if (_e1246 >= _e440) {
                                                                        let _e1248 = (_e1246 <= _e852.member.member_1);
                                                                        if _e1248 {
                                                                            let _e1249 = (1f / _e1067);
                                                                            phi_3758_ = type_19(_e1246, (_e1061 * _e1249), (_e1065 * _e1249), _e896);
                                                                        } else {
                                                                            phi_3758_ = type_19();
                                                                        }
                                                                        let _e1254 = phi_3758_;
                                                                        phi_3760_ = _e1254;
                                                                        phi_3761_ = select(true, false, _e1248);
                                                                    } else {
                                                                        phi_3760_ = type_19();
                                                                        phi_3761_ = true;
                                                                    }
                                                                    let _e1257 = phi_3760_;
                                                                    let _e1259 = phi_3761_;
                                                                    if _e1259 {
                                                                        phi_3765_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_3765_ = _e1257;
                                                                    }
                                                                    let _e1261 = phi_3765_;
                                                                    phi_3766_ = _e1261;
                                                                }
                                                                let _e1263 = phi_3766_;
                                                                phi_3767_ = _e1263;
                                                                phi_3768_ = _e1133;
                                                            }
                                                            let _e1265 = phi_3767_;
                                                            let _e1267 = phi_3768_;
                                                            phi_3772_ = _e1265;
                                                            phi_3773_ = _e1267;
                                                        }
                                                        let _e1269 = phi_3772_;
                                                        let _e1271 = phi_3773_;
                                                        phi_3777_ = _e1269;
                                                        phi_3778_ = _e1271;
                                                    } else {
                                                        phi_3777_ = type_19();
                                                        phi_3778_ = true;
                                                    }
                                                    let _e1273 = phi_3777_;
                                                    let _e1275 = phi_3778_;
                                                    if _e1275 {
                                                        phi_3782_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_3782_ = _e1273;
                                                    }
                                                    let _e1277 = phi_3782_;
                                                    if (_e1277.member_3 != 4294967295u) {
                                                        if (_e896 != _e446) {
                                                            if (_e1277.member < _e852.member.member.member) {
                                                                phi_3808_ = true;
                                                            } else {
                                                                if (_e1277.member == _e852.member.member.member) {
                                                                    phi_3807_ = (_e1277.member_3 < _e852.member.member.member_3);
                                                                } else {
                                                                    phi_3807_ = false;
                                                                }
                                                                let _e1292 = phi_3807_;
                                                                phi_3808_ = _e1292;
                                                            }
                                                            let _e1294 = phi_3808_;
                                                            if _e1294 {
                                                                phi_3815_ = type_35(type_33(_e1277, _e1277.member), _e879.member_1, _e879.member_2);
                                                            } else {
                                                                phi_3815_ = _e879;
                                                            }
                                                            let _e1301 = phi_3815_;
                                                            phi_3816_ = _e1301;
                                                        } else {
                                                            phi_3816_ = _e879;
                                                        }
                                                        let _e1303 = phi_3816_;
                                                        phi_3817_ = _e1303;
                                                    } else {
                                                        phi_3817_ = _e879;
                                                    }
                                                    let _e1305 = phi_3817_;
                                                    phi_5002_ = _e993;
                                                    phi_2951_ = _e1305;
                                                } else {
                                                    phi_5002_ = _e850;
                                                    phi_2951_ = type_35();
                                                }
                                                let _e1307 = phi_5002_;
                                                let _e1309 = phi_2951_;
                                                continue;
                                                continuing {
                                                    phi_4996_ = _e1307;
                                                    phi_2950_ = _e1309;
                                                    phi_2953_ = _e867;
                                                    phi_5001_ = _e1307;
                                                    break if !(_e873);
                                                }
                                            }
                                            let _e1312 = phi_5001_;
                                            phi_5060_ = _e1312;
                                            if _e1312 {
                                                break;
                                            }
                                            phi_5064_ = _e1312;
                                            let _e1542 = local_19;
                                            phi_4664_ = _e1542;
                                            phi_4665_ = _e517;
                                            phi_4666_ = false;
                                            phi_4667_ = _e521;
                                        } else {
                                            local_3 = array<f32, 3>(_e517.member.member[0], _e517.member.member[1], _e517.member.member[2]);
                                            local_2 = array<f32, 3>(_e517.member.member_1[0], _e517.member.member_1[1], _e517.member.member_1[2]);
                                            let _e547 = (_e517.member_1 < _e89);
                                            if _e547 {
                                                if _e547 {
                                                } else {
                                                    phi_5060_ = true;
                                                    break;
                                                }
                                                let _e549 = global_6.member[_e517.member_1];
                                                phi_3854_ = _e549;
                                            } else {
                                                phi_3854_ = type_39(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e551 = phi_3854_;
                                            let _e553 = array<u32, 3>(_e262, _e261, _e263);
                                            local_11 = _e553;
                                            local_7 = array<f32, 3>(0f, 0f, 0f);
                                            local_6 = array<f32, 3>(0f, 0f, 0f);
                                            phi_3863_ = type_7(0u, 3u);
                                            loop {
                                                let _e555 = phi_3863_;
                                                if (_e555.member < _e555.member_1) {
                                                    phi_3864_ = type_7((_e555.member + 1u), _e555.member_1);
                                                    phi_3887_ = type_7(1u, _e555.member);
                                                } else {
                                                    phi_3864_ = _e555;
                                                    phi_3887_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e568 = phi_3864_;
                                                let _e570 = phi_3887_;
                                                let _e574 = (bitcast<i32>(_e570.member) != 0i);
                                                if _e574 {
                                                    let _e575 = (_e570.member_1 < 3u);
                                                    if _e575 {
                                                    } else {
                                                        phi_4919_ = true;
                                                        break;
                                                    }
                                                    let _e577 = local_11[_e570.member_1];
                                                    if _e575 {
                                                    } else {
                                                        phi_4919_ = true;
                                                        break;
                                                    }
                                                    let _e579 = local_3[_e570.member_1];
                                                    if _e575 {
                                                    } else {
                                                        phi_4919_ = true;
                                                        break;
                                                    }
                                                    let _e581 = local_2[_e570.member_1];
                                                    let _e584 = ((10u * _e577) & 31u);
                                                    let _e587 = ((_e551.member[0] >> bitcast<u32>(_e584)) & 1023u);
                                                    let _e592 = bitcast<f32>((bitcast<u32>(((_e581 - _e579) * 0.0009775171f)) ^ _e128));
                                                    let _e598 = (_e579 + bitcast<f32>((bitcast<u32>((f32(_e587) * _e592)) ^ _e128)));
                                                    if _e575 {
                                                    } else {
                                                        phi_4919_ = true;
                                                        break;
                                                    }
                                                    local_7[_e570.member_1] = select(select(_e581, _e598, (_e598 < _e581)), _e581, (_e587 == 1023u));
                                                    let _e607 = ((_e551.member[1] >> bitcast<u32>(_e584)) & 1023u);
                                                    let _e613 = (_e579 + bitcast<f32>((bitcast<u32>((f32(_e607) * _e592)) ^ _e128)));
                                                    if _e575 {
                                                    } else {
                                                        phi_4919_ = true;
                                                        break;
                                                    }
                                                    local_6[_e570.member_1] = select(select(_e581, _e613, (_e613 < _e581)), _e581, (_e607 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_3863_ = _e568;
                                                    phi_4919_ = _e477;
                                                    break if !(_e574);
                                                }
                                            }
                                            let _e621 = phi_4919_;
                                            phi_5060_ = _e621;
                                            if _e621 {
                                                break;
                                            }
                                            let _e622 = local_6;
                                            let _e623 = local_7;
                                            local_10 = _e553;
                                            local_9 = array<f32, 3>(0f, 0f, 0f);
                                            local_8 = array<f32, 3>(0f, 0f, 0f);
                                            phi_4017_ = type_7(0u, 3u);
                                            loop {
                                                let _e632 = phi_4017_;
                                                if (_e632.member < _e632.member_1) {
                                                    phi_4018_ = type_7((_e632.member + 1u), _e632.member_1);
                                                    phi_4041_ = type_7(1u, _e632.member);
                                                } else {
                                                    phi_4018_ = _e632;
                                                    phi_4041_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e645 = phi_4018_;
                                                let _e647 = phi_4041_;
                                                let _e651 = (bitcast<i32>(_e647.member) != 0i);
                                                if _e651 {
                                                    let _e652 = (_e647.member_1 < 3u);
                                                    if _e652 {
                                                    } else {
                                                        phi_4979_ = true;
                                                        break;
                                                    }
                                                    let _e654 = local_10[_e647.member_1];
                                                    if _e652 {
                                                    } else {
                                                        phi_4979_ = true;
                                                        break;
                                                    }
                                                    let _e656 = local_3[_e647.member_1];
                                                    if _e652 {
                                                    } else {
                                                        phi_4979_ = true;
                                                        break;
                                                    }
                                                    let _e658 = local_2[_e647.member_1];
                                                    let _e661 = ((10u * _e654) & 31u);
                                                    let _e664 = ((_e551.member_1[0] >> bitcast<u32>(_e661)) & 1023u);
                                                    let _e669 = bitcast<f32>((bitcast<u32>(((_e658 - _e656) * 0.0009775171f)) ^ _e128));
                                                    let _e675 = (_e656 + bitcast<f32>((bitcast<u32>((f32(_e664) * _e669)) ^ _e128)));
                                                    if _e652 {
                                                    } else {
                                                        phi_4979_ = true;
                                                        break;
                                                    }
                                                    local_9[_e647.member_1] = select(select(_e658, _e675, (_e675 < _e658)), _e658, (_e664 == 1023u));
                                                    let _e684 = ((_e551.member_1[1] >> bitcast<u32>(_e661)) & 1023u);
                                                    let _e690 = (_e656 + bitcast<f32>((bitcast<u32>((f32(_e684) * _e669)) ^ _e128)));
                                                    if _e652 {
                                                    } else {
                                                        phi_4979_ = true;
                                                        break;
                                                    }
                                                    local_8[_e647.member_1] = select(select(_e658, _e690, (_e690 < _e658)), _e658, (_e684 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_4017_ = _e645;
                                                    phi_4979_ = _e621;
                                                    break if !(_e651);
                                                }
                                            }
                                            let _e698 = phi_4979_;
                                            phi_5060_ = _e698;
                                            if _e698 {
                                                break;
                                            }
                                            let _e699 = local_8;
                                            let _e700 = local_9;
                                            let _e711 = type_53(type_44(array<f32, 3>(_e623[0], _e623[1], _e623[2]), array<f32, 3>(_e622[0], _e622[1], _e622[2])), _e551.member_2);
                                            let _e716 = type_53(type_44(array<f32, 3>(_e700[0], _e700[1], _e700[2]), array<f32, 3>(_e699[0], _e699[1], _e699[2])), _e551.member_3);
                                            let _e723 = ((_e623[0] - _e317) * _e322);
                                            let _e724 = ((_e700[0] - _e317) * _e322);
                                            let _e725 = ((_e622[0] - _e318) * _e322);
                                            let _e726 = ((_e699[0] - _e318) * _e322);
                                            let _e731 = ((_e623[1] - _e353) * _e358);
                                            let _e732 = ((_e700[1] - _e353) * _e358);
                                            let _e733 = ((_e622[1] - _e354) * _e358);
                                            let _e734 = ((_e699[1] - _e354) * _e358);
                                            let _e739 = ((_e623[2] - _e389) * _e394);
                                            let _e740 = ((_e700[2] - _e389) * _e394);
                                            let _e741 = ((_e622[2] - _e390) * _e394);
                                            let _e742 = ((_e699[2] - _e390) * _e394);
                                            let _e744 = select(_e741, _e739, (_e739 < _e741));
                                            let _e746 = select(_e742, _e740, (_e740 < _e742));
                                            let _e748 = select(_e741, _e739, (_e739 > _e741));
                                            let _e750 = select(_e742, _e740, (_e740 > _e742));
                                            let _e752 = select(_e725, _e723, (_e723 < _e725));
                                            let _e754 = select(_e726, _e724, (_e724 < _e726));
                                            let _e756 = select(_e733, _e731, (_e731 < _e733));
                                            let _e758 = select(_e734, _e732, (_e732 < _e734));
                                            let _e760 = select(_e756, _e752, (_e752 > _e756));
                                            let _e762 = select(_e758, _e754, (_e754 > _e758));
                                            let _e764 = select(_e744, _e760, (_e760 > _e744));
                                            let _e766 = select(_e746, _e762, (_e762 > _e746));
                                            let _e768 = select(_e725, _e723, (_e723 > _e725));
                                            let _e770 = select(_e726, _e724, (_e724 > _e726));
                                            let _e772 = select(_e733, _e731, (_e731 > _e733));
                                            let _e774 = select(_e734, _e732, (_e732 > _e734));
                                            let _e776 = select(_e772, _e768, (_e768 < _e772));
                                            let _e778 = select(_e774, _e770, (_e770 < _e774));
                                            let _e783 = -(_e744);
                                            let _e784 = -(_e746);
                                            let _e791 = (select(_e748, _e776, (_e776 < _e748)) + (select(_e783, _e748, (_e748 > _e783)) * 0.0000019073523f));
                                            let _e792 = (select(_e750, _e778, (_e778 < _e750)) + (select(_e784, _e750, (_e750 > _e784)) * 0.0000019073523f));
                                            let _e794 = select(_e440, _e764, (_e764 > _e440));
                                            let _e796 = select(_e440, _e766, (_e766 > _e440));
                                            let _e801 = (_e794 <= select(_e479.member.member_1, _e791, (_e791 < _e479.member.member_1)));
                                            let _e802 = (_e796 <= select(_e479.member.member_1, _e792, (_e792 < _e479.member.member_1)));
                                            let _e803 = (_e794 <= _e796);
                                            if _e801 {
                                                if _e802 {
                                                    if _e803 {
                                                        phi_4604_ = _e716;
                                                    } else {
                                                        phi_4604_ = _e711;
                                                    }
                                                    let _e805 = phi_4604_;
                                                    let _e806 = (_e521 % 128u);
                                                    let _e807 = (_e806 < 128u);
                                                    if _e807 {
                                                    } else {
                                                        phi_5060_ = true;
                                                        break;
                                                    }
                                                    local_5[_e806] = type_53(type_44(array<f32, 3>(_e805.member.member[0], _e805.member.member[1], _e805.member.member[2]), array<f32, 3>(_e805.member.member_1[0], _e805.member.member_1[1], _e805.member.member_1[2])), _e805.member_1);
                                                    if _e807 {
                                                    } else {
                                                        phi_5060_ = true;
                                                        break;
                                                    }
                                                    local_4[_e806] = select(_e796, _e794, (_e794 > _e796));
                                                    if _e803 {
                                                        phi_4643_ = _e711;
                                                    } else {
                                                        phi_4643_ = _e716;
                                                    }
                                                    let _e828 = phi_4643_;
                                                    phi_4644_ = _e828;
                                                    phi_4645_ = (_e521 + 1u);
                                                } else {
                                                    phi_4644_ = type_53();
                                                    phi_4645_ = u32();
                                                }
                                                let _e830 = phi_4644_;
                                                let _e832 = phi_4645_;
                                                phi_4647_ = _e830;
                                                phi_4648_ = _e832;
                                                phi_4649_ = select(true, false, _e802);
                                            } else {
                                                phi_4647_ = type_53();
                                                phi_4648_ = u32();
                                                phi_4649_ = true;
                                            }
                                            let _e835 = phi_4647_;
                                            let _e837 = phi_4648_;
                                            let _e839 = phi_4649_;
                                            if _e839 {
                                                if _e801 {
                                                    phi_4656_ = _e711;
                                                } else {
                                                    phi_4656_ = _e716;
                                                }
                                                let _e841 = phi_4656_;
                                                phi_4661_ = _e841;
                                                phi_4662_ = select(_e802, true, _e801);
                                            } else {
                                                phi_4661_ = _e835;
                                                phi_4662_ = _e519;
                                            }
                                            let _e844 = phi_4661_;
                                            let _e846 = phi_4662_;
                                            phi_5064_ = _e698;
                                            phi_4664_ = type_35(_e479.member, (_e479.member_1 + 1u), _e479.member_2);
                                            phi_4665_ = _e844;
                                            phi_4666_ = _e846;
                                            phi_4667_ = select(_e837, _e521, _e839);
                                        }
                                        let _e1314 = phi_5064_;
                                        let _e1316 = phi_4664_;
                                        let _e1318 = phi_4665_;
                                        let _e1320 = phi_4666_;
                                        let _e1322 = phi_4667_;
                                        phi_5063_ = _e1314;
                                        phi_4668_ = _e1316;
                                        phi_4669_ = _e1318;
                                        phi_4670_ = (_e483 - 1u);
                                        phi_4671_ = _e1320;
                                        phi_4672_ = _e1322;
                                    } else {
                                        phi_5063_ = _e477;
                                        phi_4668_ = _e479;
                                        phi_4669_ = _e517;
                                        phi_4670_ = _e483;
                                        phi_4671_ = _e519;
                                        phi_4672_ = _e521;
                                    }
                                    let _e1324 = phi_5063_;
                                    let _e1326 = phi_4668_;
                                    let _e1328 = phi_4669_;
                                    let _e1330 = phi_4670_;
                                    let _e1332 = phi_4671_;
                                    let _e1334 = phi_4672_;
                                    phi_5062_ = _e1324;
                                    phi_4673_ = _e1326;
                                    phi_4674_ = _e1328;
                                    phi_4675_ = _e1330;
                                    phi_4676_ = _e1332;
                                    phi_4677_ = _e1334;
                                } else {
                                    phi_5062_ = _e477;
                                    phi_4673_ = type_35();
                                    phi_4674_ = type_53();
                                    phi_4675_ = u32();
                                    phi_4676_ = bool();
                                    phi_4677_ = u32();
                                }
                                let _e1336 = phi_5062_;
                                let _e1338 = phi_4673_;
                                let _e1340 = phi_4674_;
                                let _e1342 = phi_4675_;
                                let _e1344 = phi_4676_;
                                let _e1346 = phi_4677_;
                                phi_5061_ = _e1336;
                                phi_2865_ = _e1338;
                                phi_2868_ = _e1340;
                                phi_2870_ = _e1342;
                                phi_2872_ = _e1344;
                                phi_2874_ = _e1346;
                                phi_4678_ = _e491;
                            } else {
                                phi_5061_ = _e477;
                                phi_2865_ = type_35();
                                phi_2868_ = type_53();
                                phi_2870_ = u32();
                                phi_2872_ = bool();
                                phi_2874_ = u32();
                                phi_4678_ = false;
                            }
                            let _e1348 = phi_5061_;
                            let _e1350 = phi_2865_;
                            let _e1352 = phi_2868_;
                            let _e1354 = phi_2870_;
                            let _e1356 = phi_2872_;
                            let _e1358 = phi_2874_;
                            let _e1360 = phi_4678_;
                            continue;
                            continuing {
                                phi_4926_ = _e1348;
                                phi_2864_ = _e1350;
                                phi_2867_ = _e1352;
                                phi_2869_ = _e1354;
                                phi_2871_ = _e1356;
                                phi_2873_ = _e1358;
                                phi_5060_ = _e1348;
                                break if !(_e1360);
                            }
                        }
                        let _e1363 = phi_5060_;
                        if _e1363 {
                            break;
                        }
                        let _e1365 = local_17;
                        if (_e1365.member.member.member_3 != 4294967295u) {
                            let _e1371 = (_e264 / 3i);
                            let _e1378 = bitcast<f32>((bitcast<u32>((_e1371 + 127i)) << bitcast<u32>(23i)));
                            let _e1386 = (((_e1365.member.member.member * _e1378) * _e1378) * bitcast<f32>((bitcast<u32>(((_e264 - (2i * _e1371)) + 127i)) << bitcast<u32>(23i))));
                            let _e1388 = select(340282350000000000000000000000000000000f, _e1386, (_e1386 < 340282350000000000000000000000000000000f));
                            phi_4730_ = type_19(select(-340282350000000000000000000000000000000f, _e1388, (_e1388 > -340282350000000000000000000000000000000f)), _e1365.member.member.member_1, _e1365.member.member.member_2, _e1365.member.member.member_3);
                        } else {
                            phi_4730_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1395 = phi_4730_;
                        if _e140 {
                        } else {
                            break;
                        }
                        global_1.member[_e132] = _e1395;
                        let _e1399 = local_18;
                        if _e141 {
                        } else {
                            break;
                        }
                        global_4.member[_e132] = _e1399.member_1;
                        if _e139 {
                        } else {
                            break;
                        }
                        let _e1404 = select(0u, 1u, (_e208 <= _e218));
                        if (_e1404 > 0u) {
                            let _e1406 = (1u < _e100);
                            if _e1406 {
                                if (0u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1410 = atomicAdd((&global_5.member[0u]), _e1404);
                                if ((_e1410 + _e1404) < _e1410) {
                                    if _e1406 {
                                    } else {
                                        break;
                                    }
                                    let _e1415 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1418 = select(0u, 1u, (_e1395.member_3 != 4294967295u));
                        if (_e1418 > 0u) {
                            let _e1420 = (3u < _e100);
                            if _e1420 {
                                if (2u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1424 = atomicAdd((&global_5.member[2u]), _e1418);
                                if ((_e1424 + _e1418) < _e1424) {
                                    if _e1420 {
                                    } else {
                                        break;
                                    }
                                    let _e1429 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1399.member_1 > 0u) {
                            let _e1431 = (5u < _e100);
                            if _e1431 {
                                if (4u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1435 = atomicAdd((&global_5.member[4u]), _e1399.member_1);
                                if ((_e1435 + _e1399.member_1) < _e1435) {
                                    if _e1431 {
                                    } else {
                                        break;
                                    }
                                    let _e1440 = atomicAdd((&global_5.member[5u]), 1u);
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
fn trace_paths_counted_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
