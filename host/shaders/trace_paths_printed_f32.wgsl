struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_34 {
    member: array<type_32>,
}

struct type_40 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_42 {
    member: type_27,
    member_1: f32,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: array<i32>,
}

struct type_53 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_55 {
    member: array<type_53>,
}

struct type_58 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_61 {
    member: type_58,
    member_1: u32,
}

struct type_68 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_46;
@group(0) @binding(2) 
var<uniform> global_3: type_46;
@group(0) @binding(4) 
var<storage> global_4: type_20;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_49;
@group(0) @binding(7) 
var<storage> global_7: type_34;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_29;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_68;
@group(0) @binding(3) 
var<storage> global_10: type_55;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_61, 128>;
    var local_4: array<f32, 3>;
    var local_5: array<f32, 3>;
    var local_6: array<f32, 3>;
    var local_7: array<f32, 3>;
    var local_8: array<u32, 3>;
    var local_9: array<u32, 3>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 3>;
    var phi_275_: u32;
    var phi_340_: type_40;
    var phi_446_: i32;
    var phi_447_: i32;
    var phi_457_: bool;
    var phi_467_: u32;
    var phi_468_: u32;
    var phi_470_: bool;
    var phi_475_: u32;
    var phi_520_: f32;
    var phi_526_: f32;
    var phi_537_: f32;
    var phi_543_: f32;
    var phi_566_: f32;
    var phi_577_: f32;
    var phi_586_: f32;
    var phi_592_: f32;
    var phi_603_: f32;
    var phi_609_: f32;
    var phi_632_: f32;
    var phi_643_: f32;
    var phi_652_: f32;
    var phi_658_: f32;
    var phi_669_: f32;
    var phi_675_: f32;
    var phi_698_: f32;
    var phi_709_: f32;
    var phi_809_: f32;
    var phi_810_: f32;
    var phi_5146_: bool;
    var phi_2938_: type_42;
    var phi_2941_: type_61;
    var phi_2943_: u32;
    var phi_2945_: bool;
    var phi_2947_: u32;
    var phi_2958_: bool;
    var phi_3003_: type_61;
    var phi_3004_: bool;
    var phi_3005_: u32;
    var phi_4126_: type_53;
    var phi_4135_: type_8;
    var phi_4136_: type_8;
    var phi_4159_: type_8;
    var phi_5139_: bool;
    var phi_4289_: type_8;
    var phi_4290_: type_8;
    var phi_4313_: type_8;
    var phi_5197_: bool;
    var phi_4876_: type_61;
    var phi_4915_: type_61;
    var phi_4916_: type_61;
    var phi_4917_: u32;
    var phi_4919_: type_61;
    var phi_4920_: u32;
    var phi_4921_: bool;
    var phi_4928_: type_61;
    var phi_4933_: type_61;
    var phi_4934_: bool;
    var phi_3023_: type_42;
    var phi_3026_: type_8;
    var phi_3027_: type_8;
    var phi_3049_: type_8;
    var phi_3070_: u32;
    var phi_3159_: array<array<f32, 3>, 3>;
    var phi_3630_: vec3<f32>;
    var phi_3631_: vec3<f32>;
    var phi_3662_: bool;
    var phi_3671_: vec3<f32>;
    var phi_3711_: type_27;
    var phi_3713_: type_27;
    var phi_3714_: bool;
    var phi_3718_: type_27;
    var phi_3719_: type_27;
    var phi_3720_: type_27;
    var phi_3721_: bool;
    var phi_3725_: type_27;
    var phi_3726_: bool;
    var phi_3730_: type_27;
    var phi_3731_: bool;
    var phi_3735_: type_27;
    var phi_3758_: u32;
    var phi_3772_: i32;
    var phi_3792_: vec3<f32>;
    var phi_3793_: vec3<f32>;
    var phi_3809_: vec3<f32>;
    var phi_3810_: vec3<f32>;
    var phi_3826_: vec3<f32>;
    var phi_3827_: vec3<f32>;
    var phi_3863_: vec3<f32>;
    var phi_4045_: f32;
    var phi_4063_: bool;
    var phi_4064_: bool;
    var phi_4083_: bool;
    var phi_4084_: bool;
    var phi_4090_: type_42;
    var phi_4091_: type_42;
    var phi_4092_: type_42;
    var phi_3024_: type_42;
    var phi_5205_: bool;
    var phi_5292_: bool;
    var phi_4936_: type_42;
    var phi_4937_: type_61;
    var phi_4938_: bool;
    var phi_4939_: u32;
    var phi_5291_: bool;
    var phi_4940_: type_42;
    var phi_4941_: type_61;
    var phi_4942_: u32;
    var phi_4943_: bool;
    var phi_4944_: u32;
    var phi_5290_: bool;
    var phi_4945_: type_42;
    var phi_4946_: type_61;
    var phi_4947_: u32;
    var phi_4948_: bool;
    var phi_4949_: u32;
    var phi_5289_: bool;
    var phi_2939_: type_42;
    var phi_2942_: type_61;
    var phi_2944_: u32;
    var phi_2946_: bool;
    var phi_2948_: u32;
    var phi_4950_: bool;
    var phi_5288_: bool;
    var local_12: type_42;
    var phi_5002_: type_27;
    var local_13: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e90 = global;
            let _e93 = arrayLength((&global_10.member));
            let _e95 = arrayLength((&global_4.member));
            let _e107 = arrayLength((&global_9.member));
            let _e111 = global_3.member[0u][0u];
            let _e115 = global_3.member[0u][1u];
            let _e119 = global_3.member[0u][2u];
            let _e123 = global_3.member[1u][0u];
            let _e127 = global_3.member[1u][1u];
            let _e131 = global_3.member[1u][2u];
            let _e135 = global_3.member[1u][3u];
            let _e139 = (_e90.x + (_e90.y * 2097152u));
            let _e146 = (_e139 < arrayLength((&global_7.member)));
            if _e146 {
                if _e146 {
                } else {
                    break;
                }
                let _e150 = global_7.member[_e139].member_2;
                phi_275_ = _e150;
            } else {
                phi_275_ = 4294967295u;
            }
            let _e152 = phi_275_;
            let _e155 = global_1.member[0u];
            let _e159 = global_2.member[0u][0u];
            let _e163 = global_2.member[0u][1u];
            let _e167 = global_2.member[0u][2u];
            let _e171 = global_2.member[0u][3u];
            let _e175 = global_2.member[1u][0u];
            let _e179 = global_2.member[1u][1u];
            let _e183 = global_2.member[1u][2u];
            let _e187 = global_2.member[1u][3u];
            let _e188 = bitcast<f32>(_e159);
            let _e189 = bitcast<f32>(_e163);
            let _e190 = bitcast<f32>(_e167);
            let _e192 = bitcast<f32>(_e175);
            let _e193 = array<u32, 3>(_e179, _e183, _e187);
            let _e195 = bitcast<i32>(_e155);
            let _e196 = (_e195 / 2i);
            let _e201 = bitcast<f32>((bitcast<u32>((_e196 + 127i)) << bitcast<u32>(23i)));
            let _e207 = bitcast<f32>((bitcast<u32>(((_e195 - _e196) + 127i)) << bitcast<u32>(23i)));
            if (_e171 == 0u) {
                phi_340_ = type_40(array<f32, 3>(_e188, _e189, _e190), _e171, _e192, _e193);
            } else {
                phi_340_ = type_40(array<f32, 3>(((_e188 * _e201) * _e207), ((_e189 * _e201) * _e207), ((_e190 * _e201) * _e207)), _e171, ((_e192 * _e201) * _e207), _e193);
            }
            let _e220 = phi_340_;
            if _e146 {
                let _e221 = (_e139 < arrayLength((&global_8.member)));
                if _e221 {
                    if _e146 {
                    } else {
                        break;
                    }
                    let _e231 = global_7.member[_e139].member.member_2[0u];
                    let _e233 = (bitcast<u32>(_e231) & 2147483647u);
                    let _e239 = global_7.member[_e139].member.member_2[1u];
                    let _e241 = (bitcast<u32>(_e239) & 2147483647u);
                    let _e247 = global_7.member[_e139].member.member_2[2u];
                    let _e249 = (bitcast<u32>(_e247) & 2147483647u);
                    let _e255 = global_7.member[_e139].member.member[0u];
                    let _e257 = (bitcast<u32>(_e255) & 2147483647u);
                    let _e263 = global_7.member[_e139].member.member[1u];
                    let _e265 = (bitcast<u32>(_e263) & 2147483647u);
                    let _e271 = global_7.member[_e139].member.member[2u];
                    let _e273 = (bitcast<u32>(_e271) & 2147483647u);
                    let _e275 = select(_e241, _e233, (_e241 < _e233));
                    let _e277 = select(_e249, _e275, (_e249 < _e275));
                    let _e279 = select(_e257, _e277, (_e257 < _e277));
                    let _e281 = select(_e265, _e279, (_e265 < _e279));
                    let _e283 = select(_e273, _e281, (_e273 < _e281));
                    let _e288 = global_7.member[_e139].member.member_1;
                    let _e290 = (bitcast<u32>(_e288) & 2147483647u);
                    let _e298 = global_7.member[_e139].member.member_3;
                    let _e304 = (((select(_e290, _e283, (_e290 < _e283)) < 2139095040u) && ((bitcast<u32>(_e298) & 2147483647u) <= 2139095040u)) && (_e277 > 0u));
                    if _e304 {
                        let _e307 = (bitcast<u32>(bitcast<f32>(_e277)) & 2147483647u);
                        if (_e307 >= 8388608u) {
                            phi_446_ = (bitcast<i32>((_e307 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_446_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e307)), 32u, (_e307 == 0u))));
                        }
                        let _e321 = phi_446_;
                        phi_447_ = _e321;
                    } else {
                        phi_447_ = 0i;
                    }
                    let _e323 = phi_447_;
                    let _e324 = (_e233 == _e277);
                    if _e324 {
                        phi_457_ = true;
                    } else {
                        phi_457_ = (_e241 == _e277);
                    }
                    let _e327 = phi_457_;
                    let _e328 = select(1u, 0u, _e324);
                    if _e327 {
                        let _e329 = (_e328 + 1u);
                        phi_467_ = _e329;
                        phi_468_ = _e329;
                        phi_470_ = select(true, false, (_e329 == 2u));
                    } else {
                        phi_467_ = u32();
                        phi_468_ = 0u;
                        phi_470_ = true;
                    }
                    let _e333 = phi_467_;
                    let _e335 = phi_468_;
                    let _e337 = phi_470_;
                    if _e337 {
                        phi_475_ = (_e335 + 1u);
                    } else {
                        phi_475_ = 0u;
                    }
                    let _e341 = phi_475_;
                    let _e342 = select(_e333, _e335, _e337);
                    let _e343 = select(_e328, select(2u, _e328, _e327), _e337);
                    let _e344 = -(_e323);
                    let _e345 = (_e344 / 2i);
                    let _e350 = bitcast<f32>((bitcast<u32>((_e345 + 127i)) << bitcast<u32>(23i)));
                    let _e356 = bitcast<f32>((bitcast<u32>(((_e344 - _e345) + 127i)) << bitcast<u32>(23i)));
                    let _e361 = global_7.member[_e139].member.member;
                    let _e362 = (_e342 == 0u);
                    if _e362 {
                        phi_520_ = _e361[0];
                    } else {
                        phi_520_ = _e361[1];
                    }
                    let _e366 = phi_520_;
                    let _e367 = (_e342 == 2u);
                    if _e367 {
                        phi_526_ = _e361[2];
                    } else {
                        phi_526_ = _e366;
                    }
                    let _e370 = phi_526_;
                    let _e371 = global_7.member[_e139].member.member_2;
                    if _e362 {
                        phi_537_ = _e371[0];
                    } else {
                        phi_537_ = _e371[1];
                    }
                    let _e375 = phi_537_;
                    if _e367 {
                        phi_543_ = _e371[2];
                    } else {
                        phi_543_ = _e375;
                    }
                    let _e378 = phi_543_;
                    let _e380 = ((_e378 * _e350) * _e356);
                    let _e384 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e384 {
                        let _e388 = (bitcast<f32>((bitcast<u32>(_e370) & 2147483647u)) * 0.00000011920929f);
                        phi_566_ = select(0.00000000000011368684f, _e388, (_e388 > 0.00000000000011368684f));
                    } else {
                        phi_566_ = 0f;
                    }
                    let _e392 = phi_566_;
                    let _e393 = (_e370 + _e392);
                    let _e394 = (_e370 - _e392);
                    let _e395 = select(_e380, 0f, _e384);
                    if _e384 {
                        phi_577_ = 38685626000000000000000000f;
                    } else {
                        phi_577_ = (1f / _e380);
                    }
                    let _e398 = phi_577_;
                    let _e399 = (_e341 == 0u);
                    if _e399 {
                        phi_586_ = _e361[0];
                    } else {
                        phi_586_ = _e361[1];
                    }
                    let _e403 = phi_586_;
                    let _e404 = (_e341 == 2u);
                    if _e404 {
                        phi_592_ = _e361[2];
                    } else {
                        phi_592_ = _e403;
                    }
                    let _e407 = phi_592_;
                    if _e399 {
                        phi_603_ = _e371[0];
                    } else {
                        phi_603_ = _e371[1];
                    }
                    let _e411 = phi_603_;
                    if _e404 {
                        phi_609_ = _e371[2];
                    } else {
                        phi_609_ = _e411;
                    }
                    let _e414 = phi_609_;
                    let _e416 = ((_e414 * _e350) * _e356);
                    let _e420 = (bitcast<f32>((bitcast<u32>(_e416) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e420 {
                        let _e424 = (bitcast<f32>((bitcast<u32>(_e407) & 2147483647u)) * 0.00000011920929f);
                        phi_632_ = select(0.00000000000011368684f, _e424, (_e424 > 0.00000000000011368684f));
                    } else {
                        phi_632_ = 0f;
                    }
                    let _e428 = phi_632_;
                    let _e429 = (_e407 + _e428);
                    let _e430 = (_e407 - _e428);
                    let _e431 = select(_e416, 0f, _e420);
                    if _e420 {
                        phi_643_ = 38685626000000000000000000f;
                    } else {
                        phi_643_ = (1f / _e416);
                    }
                    let _e434 = phi_643_;
                    let _e435 = (_e343 == 0u);
                    if _e435 {
                        phi_652_ = _e361[0];
                    } else {
                        phi_652_ = _e361[1];
                    }
                    let _e439 = phi_652_;
                    let _e440 = (_e343 == 2u);
                    if _e440 {
                        phi_658_ = _e361[2];
                    } else {
                        phi_658_ = _e439;
                    }
                    let _e443 = phi_658_;
                    if _e435 {
                        phi_669_ = _e371[0];
                    } else {
                        phi_669_ = _e371[1];
                    }
                    let _e447 = phi_669_;
                    if _e440 {
                        phi_675_ = _e371[2];
                    } else {
                        phi_675_ = _e447;
                    }
                    let _e450 = phi_675_;
                    let _e452 = ((_e450 * _e350) * _e356);
                    let _e456 = (bitcast<f32>((bitcast<u32>(_e452) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e456 {
                        let _e460 = (bitcast<f32>((bitcast<u32>(_e443) & 2147483647u)) * 0.00000011920929f);
                        phi_698_ = select(0.00000000000011368684f, _e460, (_e460 > 0.00000000000011368684f));
                    } else {
                        phi_698_ = 0f;
                    }
                    let _e464 = phi_698_;
                    let _e465 = (_e443 + _e464);
                    let _e466 = (_e443 - _e464);
                    let _e467 = select(_e452, 0f, _e456);
                    if _e456 {
                        phi_709_ = 38685626000000000000000000f;
                    } else {
                        phi_709_ = (1f / _e452);
                    }
                    let _e470 = phi_709_;
                    let _e473 = bitcast<f32>((bitcast<u32>(_e370) & 2147483647u));
                    let _e476 = bitcast<f32>((bitcast<u32>(_e407) & 2147483647u));
                    let _e478 = select(_e476, _e473, (_e473 > _e476));
                    let _e481 = bitcast<f32>((bitcast<u32>(_e443) & 2147483647u));
                    if (_e304 && (select(_e481, _e478, (_e478 > _e481)) <= 1099511600000f)) {
                        let _e486 = (_e323 / 3i);
                        let _e493 = bitcast<f32>((bitcast<u32>((_e486 + 127i)) << bitcast<u32>(23i)));
                        let _e500 = bitcast<f32>((bitcast<u32>(((_e323 - (2i * _e486)) + 127i)) << bitcast<u32>(23i)));
                        let _e501 = (((_e288 * _e493) * _e493) * _e500);
                        let _e503 = select(340282350000000000000000000000000000000f, _e501, (_e501 < 340282350000000000000000000000000000000f));
                        let _e508 = (((_e298 * _e493) * _e493) * _e500);
                        let _e510 = select(340282350000000000000000000000000000000f, _e508, (_e508 < 340282350000000000000000000000000000000f));
                        phi_809_ = select(-340282350000000000000000000000000000000f, _e510, (_e510 > -340282350000000000000000000000000000000f));
                        phi_810_ = select(-340282350000000000000000000000000000000f, _e503, (_e503 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_809_ = 0f;
                        phi_810_ = 1f;
                    }
                    let _e514 = phi_809_;
                    let _e516 = phi_810_;
                    local_3 = array<type_61, 128>(type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_11 = array<f32, 3>(bitcast<f32>(_e111), bitcast<f32>(_e115), bitcast<f32>(_e119));
                    let _e521 = (_e342 % 3u);
                    let _e522 = (_e521 < 3u);
                    if _e522 {
                    } else {
                        break;
                    }
                    let _e524 = local_11[_e521];
                    let _e525 = (_e341 % 3u);
                    let _e526 = (_e525 < 3u);
                    if _e526 {
                    } else {
                        break;
                    }
                    let _e528 = local_11[_e525];
                    let _e529 = (_e343 % 3u);
                    let _e530 = (_e529 < 3u);
                    if _e530 {
                    } else {
                        break;
                    }
                    let _e532 = local_11[_e529];
                    local_10 = array<f32, 3>(bitcast<f32>(_e123), bitcast<f32>(_e127), bitcast<f32>(_e131));
                    if _e522 {
                    } else {
                        break;
                    }
                    let _e536 = local_10[_e521];
                    if _e526 {
                    } else {
                        break;
                    }
                    let _e538 = local_10[_e525];
                    if _e530 {
                    } else {
                        break;
                    }
                    let _e540 = local_10[_e529];
                    phi_5146_ = false;
                    phi_2938_ = type_42(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e514);
                    phi_2941_ = type_61(type_58(array<f32, 3>(_e524, _e528, _e532), array<f32, 3>(_e536, _e538, _e540)), select(0u, 2147483648u, (_e93 == 0u)));
                    phi_2943_ = ((3u * _e93) + 1u);
                    phi_2945_ = (_e516 <= _e514);
                    phi_2947_ = 0u;
                    loop {
                        let _e548 = phi_5146_;
                        let _e550 = phi_2938_;
                        let _e552 = phi_2941_;
                        let _e554 = phi_2943_;
                        let _e556 = phi_2945_;
                        let _e558 = phi_2947_;
                        local_12 = _e550;
                        if _e556 {
                            phi_2958_ = true;
                        } else {
                            phi_2958_ = (_e558 > 0u);
                        }
                        let _e561 = phi_2958_;
                        if _e561 {
                            let _e562 = (_e554 > 0u);
                            if _e562 {
                                if _e556 {
                                    phi_3003_ = _e552;
                                    phi_3004_ = _e556;
                                    phi_3005_ = _e558;
                                } else {
                                    let _e563 = (_e558 - 1u);
                                    let _e564 = (_e563 % 128u);
                                    let _e565 = (_e564 < 128u);
                                    if _e565 {
                                    } else {
                                        phi_5288_ = true;
                                        break;
                                    }
                                    let _e567 = local_3[_e564];
                                    if _e565 {
                                    } else {
                                        phi_5288_ = true;
                                        break;
                                    }
                                    let _e583 = local_2[_e564];
                                    phi_3003_ = type_61(type_58(array<f32, 3>(_e567.member.member[0], _e567.member.member[1], _e567.member.member[2]), array<f32, 3>(_e567.member.member_1[0], _e567.member.member_1[1], _e567.member.member_1[2])), _e567.member_1);
                                    phi_3004_ = (_e583 <= _e550.member_1);
                                    phi_3005_ = _e563;
                                }
                                let _e587 = phi_3003_;
                                let _e589 = phi_3004_;
                                let _e591 = phi_3005_;
                                if _e589 {
                                    if ((_e587.member_1 & 2147483648u) != 0u) {
                                        phi_3023_ = _e550;
                                        phi_3026_ = type_8(0u, ((_e587.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e913 = phi_3023_;
                                            let _e915 = phi_3026_;
                                            local_13 = _e913;
                                            if (_e915.member < _e915.member_1) {
                                                phi_3027_ = type_8((_e915.member + 1u), _e915.member_1);
                                                phi_3049_ = type_8(1u, _e915.member);
                                            } else {
                                                phi_3027_ = _e915;
                                                phi_3049_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e928 = phi_3027_;
                                            let _e930 = phi_3049_;
                                            let _e934 = (bitcast<i32>(_e930.member) != 0i);
                                            if _e934 {
                                                let _e935 = ((_e587.member_1 & 268435455u) + _e930.member_1);
                                                let _e936 = (_e935 < _e95);
                                                if _e936 {
                                                    if _e936 {
                                                    } else {
                                                        phi_5205_ = true;
                                                        break;
                                                    }
                                                    let _e940 = global_4.member[_e935].member_1;
                                                    phi_3070_ = _e940;
                                                } else {
                                                    phi_3070_ = 4294967295u;
                                                }
                                                let _e942 = phi_3070_;
                                                if (_e935 >= _e95) {
                                                    phi_3159_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e936 {
                                                    } else {
                                                        phi_5205_ = true;
                                                        break;
                                                    }
                                                    if (_e521 < 9u) {
                                                    } else {
                                                        phi_5205_ = true;
                                                        break;
                                                    }
                                                    let _e949 = global_4.member[_e935].member[_e521];
                                                    if (_e525 < 9u) {
                                                    } else {
                                                        phi_5205_ = true;
                                                        break;
                                                    }
                                                    let _e955 = global_4.member[_e935].member[_e525];
                                                    if (_e529 < 9u) {
                                                    } else {
                                                        phi_5205_ = true;
                                                        break;
                                                    }
                                                    let _e961 = global_4.member[_e935].member[_e529];
                                                    let _e963 = (3u + _e521);
                                                    if (_e963 < 9u) {
                                                    } else {
                                                        phi_5205_ = true;
                                                        break;
                                                    }
                                                    let _e969 = global_4.member[_e935].member[_e963];
                                                    let _e970 = (3u + _e525);
                                                    if (_e970 < 9u) {
                                                    } else {
                                                        phi_5205_ = true;
                                                        break;
                                                    }
                                                    let _e976 = global_4.member[_e935].member[_e970];
                                                    let _e977 = (3u + _e529);
                                                    if (_e977 < 9u) {
                                                    } else {
                                                        phi_5205_ = true;
                                                        break;
                                                    }
                                                    let _e983 = global_4.member[_e935].member[_e977];
                                                    let _e985 = (6u + _e521);
                                                    if (_e985 < 9u) {
                                                    } else {
                                                        phi_5205_ = true;
                                                        break;
                                                    }
                                                    let _e991 = global_4.member[_e935].member[_e985];
                                                    let _e992 = (6u + _e525);
                                                    if (_e992 < 9u) {
                                                    } else {
                                                        phi_5205_ = true;
                                                        break;
                                                    }
                                                    let _e998 = global_4.member[_e935].member[_e992];
                                                    let _e999 = (6u + _e529);
                                                    if (_e999 < 9u) {
                                                    } else {
                                                        phi_5205_ = true;
                                                        break;
                                                    }
                                                    let _e1005 = global_4.member[_e935].member[_e999];
                                                    phi_3159_ = array<array<f32, 3>, 3>(array<f32, 3>(_e949, _e955, _e961), array<f32, 3>(_e969, _e976, _e983), array<f32, 3>(_e991, _e998, _e1005));
                                                }
                                                let _e1009 = phi_3159_;
                                                let _e1017 = (_e1009[0][2] - _e443);
                                                let _e1020 = (((_e1009[0][0] - _e370) * _e467) - (_e1017 * _e395));
                                                let _e1023 = (((_e1009[0][1] - _e407) * _e467) - (_e1017 * _e431));
                                                let _e1030 = (_e1009[1][2] - _e443);
                                                let _e1033 = (((_e1009[1][0] - _e370) * _e467) - (_e1030 * _e395));
                                                let _e1036 = (((_e1009[1][1] - _e407) * _e467) - (_e1030 * _e431));
                                                let _e1043 = (_e1009[2][2] - _e443);
                                                let _e1046 = (((_e1009[2][0] - _e370) * _e467) - (_e1043 * _e395));
                                                let _e1049 = (((_e1009[2][1] - _e407) * _e467) - (_e1043 * _e431));
                                                let _e1050 = (_e1046 * _e1036);
                                                let _e1051 = (_e1049 * _e1033);
                                                let _e1052 = (_e1020 * _e1049);
                                                let _e1053 = (_e1023 * _e1046);
                                                let _e1054 = (_e1033 * _e1023);
                                                let _e1055 = (_e1036 * _e1020);
                                                let _e1060 = (((_e1050 >= _e1051) && (_e1052 >= _e1053)) && (_e1054 >= _e1055));
                                                if (_e1060 || (((_e1050 <= _e1051) && (_e1052 <= _e1053)) && (_e1054 <= _e1055))) {
                                                    let _e1067 = select(-1f, 1f, _e1060);
                                                    let _e1069 = ((_e1050 - _e1051) * _e1067);
                                                    let _e1071 = select(0f, _e1069, (_e1069 > 0f));
                                                    let _e1073 = ((_e1052 - _e1053) * _e1067);
                                                    let _e1075 = select(0f, _e1073, (_e1073 > 0f));
                                                    let _e1077 = ((_e1054 - _e1055) * _e1067);
                                                    let _e1079 = select(0f, _e1077, (_e1077 > 0f));
                                                    let _e1081 = ((_e1071 + _e1075) + _e1079);
                                                    if (_e1081 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3725_ = type_27();
                                                        phi_3726_ = true;
                                                    } else {
                                                        let _e1084 = select(_e1009[1][0], _e1009[0][0], (_e1009[0][0] < _e1009[1][0]));
                                                        let _e1088 = select(_e1009[1][0], _e1009[0][0], (_e1009[0][0] > _e1009[1][0]));
                                                        let _e1092 = select(_e1009[1][1], _e1009[0][1], (_e1009[0][1] < _e1009[1][1]));
                                                        let _e1096 = select(_e1009[1][1], _e1009[0][1], (_e1009[0][1] > _e1009[1][1]));
                                                        let _e1100 = select(_e1009[1][2], _e1009[0][2], (_e1009[0][2] < _e1009[1][2]));
                                                        let _e1104 = select(_e1009[1][2], _e1009[0][2], (_e1009[0][2] > _e1009[1][2]));
                                                        let _e1109 = ((select(_e1009[2][0], _e1084, (_e1084 < _e1009[2][0])) - _e393) * _e398);
                                                        let _e1110 = ((select(_e1009[2][0], _e1088, (_e1088 > _e1009[2][0])) - _e394) * _e398);
                                                        let _e1113 = ((select(_e1009[2][1], _e1092, (_e1092 < _e1009[2][1])) - _e429) * _e434);
                                                        let _e1114 = ((select(_e1009[2][1], _e1096, (_e1096 > _e1009[2][1])) - _e430) * _e434);
                                                        let _e1117 = ((select(_e1009[2][2], _e1100, (_e1100 < _e1009[2][2])) - _e465) * _e470);
                                                        let _e1118 = ((select(_e1009[2][2], _e1104, (_e1104 > _e1009[2][2])) - _e466) * _e470);
                                                        let _e1120 = select(_e1118, _e1117, (_e1117 < _e1118));
                                                        let _e1122 = select(_e1118, _e1117, (_e1117 > _e1118));
                                                        let _e1124 = select(_e1110, _e1109, (_e1109 < _e1110));
                                                        let _e1126 = select(_e1114, _e1113, (_e1113 < _e1114));
                                                        let _e1128 = select(_e1126, _e1124, (_e1124 > _e1126));
                                                        let _e1130 = select(_e1120, _e1128, (_e1128 > _e1120));
                                                        let _e1132 = select(_e1110, _e1109, (_e1109 > _e1110));
                                                        let _e1134 = select(_e1114, _e1113, (_e1113 > _e1114));
                                                        let _e1136 = select(_e1134, _e1132, (_e1132 < _e1134));
                                                        let _e1138 = select(_e1122, _e1136, (_e1136 < _e1122));
                                                        let _e1139 = -(_e1120);
                                                        let _e1145 = select(_e516, _e1130, (_e1130 > _e516));
                                                        if (_e1145 > (_e1138 + (select(_e1139, _e1122, (_e1122 > _e1139)) * 0.0000019073523f))) {
                                                            phi_3720_ = type_27();
                                                            phi_3721_ = true;
                                                        } else {
                                                            let _e1147 = (_e1145 > _e913.member_1);
                                                            if _e1147 {
                                                                phi_3719_ = type_27();
                                                            } else {
                                                                let _e1151 = (_e1009[1][0] - _e1009[0][0]);
                                                                let _e1152 = (_e1009[1][1] - _e1009[0][1]);
                                                                let _e1153 = (_e1009[1][2] - _e1009[0][2]);
                                                                let _e1154 = vec3<f32>(_e1151, _e1152, _e1153);
                                                                let _e1155 = (_e1009[2][0] - _e1009[1][0]);
                                                                let _e1156 = (_e1009[2][1] - _e1009[1][1]);
                                                                let _e1157 = (_e1009[2][2] - _e1009[1][2]);
                                                                let _e1158 = vec3<f32>(_e1155, _e1156, _e1157);
                                                                let _e1159 = (_e1009[0][0] - _e1009[2][0]);
                                                                let _e1160 = (_e1009[0][1] - _e1009[2][1]);
                                                                let _e1161 = (_e1009[0][2] - _e1009[2][2]);
                                                                let _e1162 = vec3<f32>(_e1159, _e1160, _e1161);
                                                                let _e1165 = bitcast<f32>((bitcast<u32>(_e1151) & 2147483647u));
                                                                let _e1168 = bitcast<f32>((bitcast<u32>(_e1152) & 2147483647u));
                                                                let _e1170 = select(_e1168, _e1165, (_e1165 > _e1168));
                                                                let _e1173 = bitcast<f32>((bitcast<u32>(_e1153) & 2147483647u));
                                                                let _e1175 = select(_e1173, _e1170, (_e1170 > _e1173));
                                                                let _e1178 = bitcast<f32>((bitcast<u32>(_e1155) & 2147483647u));
                                                                let _e1181 = bitcast<f32>((bitcast<u32>(_e1156) & 2147483647u));
                                                                let _e1183 = select(_e1181, _e1178, (_e1178 > _e1181));
                                                                let _e1186 = bitcast<f32>((bitcast<u32>(_e1157) & 2147483647u));
                                                                let _e1188 = select(_e1186, _e1183, (_e1183 > _e1186));
                                                                let _e1191 = bitcast<f32>((bitcast<u32>(_e1159) & 2147483647u));
                                                                let _e1194 = bitcast<f32>((bitcast<u32>(_e1160) & 2147483647u));
                                                                let _e1196 = select(_e1194, _e1191, (_e1191 > _e1194));
                                                                let _e1199 = bitcast<f32>((bitcast<u32>(_e1161) & 2147483647u));
                                                                let _e1201 = select(_e1199, _e1196, (_e1196 > _e1199));
                                                                let _e1203 = select(_e1188, _e1175, (_e1175 > _e1188));
                                                                let _e1205 = select(_e1201, _e1203, (_e1203 > _e1201));
                                                                if (_e1175 == _e1205) {
                                                                    phi_3630_ = _e1158;
                                                                    phi_3631_ = _e1162;
                                                                } else {
                                                                    let _e1208 = vec3((_e1188 == _e1205));
                                                                    phi_3630_ = select(_e1154, _e1162, _e1208);
                                                                    phi_3631_ = select(_e1158, _e1154, _e1208);
                                                                }
                                                                let _e1212 = phi_3630_;
                                                                let _e1214 = phi_3631_;
                                                                let _e1221 = ((_e1212.y * _e1214.z) - (_e1214.y * _e1212.z));
                                                                let _e1226 = ((_e1212.z * _e1214.x) - (_e1214.z * _e1212.x));
                                                                let _e1229 = ((_e1212.x * _e1214.y) - (_e1214.x * _e1212.y));
                                                                if (_e1071 >= _e1075) {
                                                                    phi_3662_ = select(true, false, (_e1071 >= _e1079));
                                                                } else {
                                                                    phi_3662_ = true;
                                                                }
                                                                let _e1234 = phi_3662_;
                                                                if _e1234 {
                                                                    phi_3671_ = select(vec3<f32>(_e1009[2][0], _e1009[2][1], _e1009[2][2]), vec3<f32>(_e1009[1][0], _e1009[1][1], _e1009[1][2]), vec3((_e1075 >= _e1079)));
                                                                } else {
                                                                    phi_3671_ = vec3<f32>(_e1009[0][0], _e1009[0][1], _e1009[0][2]);
                                                                }
                                                                let _e1239 = phi_3671_;
                                                                let _e1256 = ((((_e1221 * (_e1239.x - _e370)) + (_e1226 * (_e1239.y - _e407))) + (_e1229 * (_e1239.z - _e443))) / (((_e1221 * _e395) + (_e1226 * _e431)) + (_e1229 * _e467)));
                                                                let _e1258 = select(_e1138, _e1256, (_e1256 < _e1138));
                                                                let _e1260 = select(_e1130, _e1258, (_e1258 > _e1130));
                                                                if (_e1260 >= _e516) {
                                                                    let _e1262 = (_e1260 <= _e913.member_1);
                                                                    if _e1262 {
                                                                        let _e1263 = (1f / _e1081);
                                                                        phi_3711_ = type_27(_e1260, (_e1075 * _e1263), (_e1079 * _e1263), _e942);
                                                                    } else {
                                                                        phi_3711_ = type_27();
                                                                    }
                                                                    let _e1268 = phi_3711_;
                                                                    phi_3713_ = _e1268;
                                                                    phi_3714_ = select(true, false, _e1262);
                                                                } else {
                                                                    phi_3713_ = type_27();
                                                                    phi_3714_ = true;
                                                                }
                                                                let _e1271 = phi_3713_;
                                                                let _e1273 = phi_3714_;
                                                                if _e1273 {
                                                                    phi_3718_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3718_ = _e1271;
                                                                }
                                                                let _e1275 = phi_3718_;
                                                                phi_3719_ = _e1275;
                                                            }
                                                            let _e1277 = phi_3719_;
                                                            phi_3720_ = _e1277;
                                                            phi_3721_ = _e1147;
                                                        }
                                                        let _e1279 = phi_3720_;
                                                        let _e1281 = phi_3721_;
                                                        phi_3725_ = _e1279;
                                                        phi_3726_ = _e1281;
                                                    }
                                                    let _e1283 = phi_3725_;
                                                    let _e1285 = phi_3726_;
                                                    phi_3730_ = _e1283;
                                                    phi_3731_ = _e1285;
                                                } else {
                                                    phi_3730_ = type_27();
                                                    phi_3731_ = true;
                                                }
                                                let _e1287 = phi_3730_;
                                                let _e1289 = phi_3731_;
                                                if _e1289 {
                                                    phi_3735_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3735_ = _e1287;
                                                }
                                                let _e1291 = phi_3735_;
                                                if (_e1291.member_3 != 4294967295u) {
                                                    if (_e942 == _e152) {
                                                        phi_4064_ = false;
                                                    } else {
                                                        let _e1295 = (_e942 < arrayLength((&global_5.member)));
                                                        if _e1295 {
                                                            if _e1295 {
                                                            } else {
                                                                phi_5205_ = true;
                                                                break;
                                                            }
                                                            let _e1297 = global_5.member[_e942];
                                                            phi_3758_ = _e1297;
                                                        } else {
                                                            phi_3758_ = 4294967295u;
                                                        }
                                                        let _e1299 = phi_3758_;
                                                        let _e1300 = (_e1299 < arrayLength((&global_6.member)));
                                                        if _e1300 {
                                                            if _e1300 {
                                                            } else {
                                                                phi_5205_ = true;
                                                                break;
                                                            }
                                                            let _e1302 = global_6.member[_e1299];
                                                            phi_3772_ = _e1302;
                                                        } else {
                                                            phi_3772_ = 0i;
                                                        }
                                                        let _e1304 = phi_3772_;
                                                        let _e1305 = (_e1304 == 0i);
                                                        if _e1305 {
                                                            phi_4063_ = true;
                                                        } else {
                                                            if _e362 {
                                                                phi_3793_ = vec3<f32>(_e1009[0][0], _e1009[0][1], _e1009[0][2]);
                                                            } else {
                                                                if (_e342 == 1u) {
                                                                    phi_3792_ = vec3<f32>(_e1009[0][2], _e1009[0][0], _e1009[0][1]);
                                                                } else {
                                                                    phi_3792_ = vec3<f32>(_e1009[0][1], _e1009[0][2], _e1009[0][0]);
                                                                }
                                                                let _e1310 = phi_3792_;
                                                                phi_3793_ = _e1310;
                                                            }
                                                            let _e1313 = phi_3793_;
                                                            if _e362 {
                                                                phi_3810_ = vec3<f32>(_e1009[1][0], _e1009[1][1], _e1009[1][2]);
                                                            } else {
                                                                if (_e342 == 1u) {
                                                                    phi_3809_ = vec3<f32>(_e1009[1][2], _e1009[1][0], _e1009[1][1]);
                                                                } else {
                                                                    phi_3809_ = vec3<f32>(_e1009[1][1], _e1009[1][2], _e1009[1][0]);
                                                                }
                                                                let _e1318 = phi_3809_;
                                                                phi_3810_ = _e1318;
                                                            }
                                                            let _e1321 = phi_3810_;
                                                            if _e362 {
                                                                phi_3827_ = vec3<f32>(_e1009[2][0], _e1009[2][1], _e1009[2][2]);
                                                            } else {
                                                                if (_e342 == 1u) {
                                                                    phi_3826_ = vec3<f32>(_e1009[2][2], _e1009[2][0], _e1009[2][1]);
                                                                } else {
                                                                    phi_3826_ = vec3<f32>(_e1009[2][1], _e1009[2][2], _e1009[2][0]);
                                                                }
                                                                let _e1326 = phi_3826_;
                                                                phi_3827_ = _e1326;
                                                            }
                                                            let _e1329 = phi_3827_;
                                                            let _e1332 = (_e1321.x - _e1313.x);
                                                            let _e1335 = (_e1321.y - _e1313.y);
                                                            let _e1338 = (_e1321.z - _e1313.z);
                                                            let _e1340 = (_e1329.x - _e1313.x);
                                                            let _e1342 = (_e1329.y - _e1313.y);
                                                            let _e1344 = (_e1329.z - _e1313.z);
                                                            if (_e220.member_1 == 1u) {
                                                                phi_3863_ = (vec3<f32>(_e220.member[0], _e220.member[1], _e220.member[2]) - _e1313);
                                                            } else {
                                                                phi_3863_ = vec3<f32>(_e220.member[0], _e220.member[1], _e220.member[2]);
                                                            }
                                                            let _e1359 = phi_3863_;
                                                            let _e1365 = bitcast<f32>((bitcast<u32>((_e1332 * _e1342)) ^ _e220.member_3[0]));
                                                            let _e1369 = bitcast<f32>((bitcast<u32>((_e1335 * _e1340)) ^ _e220.member_3[0]));
                                                            let _e1373 = bitcast<f32>((bitcast<u32>((_e1335 * _e1344)) ^ _e220.member_3[0]));
                                                            let _e1377 = bitcast<f32>((bitcast<u32>((_e1338 * _e1342)) ^ _e220.member_3[0]));
                                                            let _e1381 = bitcast<f32>((bitcast<u32>((_e1338 * _e1340)) ^ _e220.member_3[0]));
                                                            let _e1385 = bitcast<f32>((bitcast<u32>((_e1332 * _e1344)) ^ _e220.member_3[0]));
                                                            let _e1386 = (_e1373 - _e1377);
                                                            let _e1387 = (_e1381 - _e1385);
                                                            let _e1388 = (_e1365 - _e1369);
                                                            let _e1412 = (bitcast<f32>((bitcast<u32>(_e1373) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1377) & 2147483647u)));
                                                            let _e1419 = (bitcast<f32>((bitcast<u32>(_e1381) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1385) & 2147483647u)));
                                                            let _e1426 = (bitcast<f32>((bitcast<u32>(_e1365) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1369) & 2147483647u)));
                                                            if (_e220.member_2 == 0f) {
                                                                phi_4045_ = 0f;
                                                            } else {
                                                                let _e1456 = bitcast<f32>((bitcast<u32>(_e1386) & 2147483647u));
                                                                let _e1459 = bitcast<f32>((bitcast<u32>(_e1387) & 2147483647u));
                                                                let _e1462 = bitcast<f32>((bitcast<u32>(_e1388) & 2147483647u));
                                                                let _e1464 = select(_e1462, _e1459, (_e1459 > _e1462));
                                                                let _e1468 = select(_e1462, _e1459, (_e1459 < _e1462));
                                                                let _e1472 = select(_e1459, _e1456, (_e1456 < _e1459));
                                                                let _e1474 = select(_e1459, _e1456, (_e1456 > _e1459));
                                                                let _e1476 = select(_e1462, _e1474, (_e1474 < _e1462));
                                                                phi_4045_ = bitcast<f32>((bitcast<u32>((_e220.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1464, _e1456, (_e1456 > _e1464)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1476, _e1472, (_e1472 > _e1476)))) ^ _e220.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1468, _e1456, (_e1456 < _e1468)))) ^ _e220.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1412 + _e1419) + _e1426))) ^ _e220.member_3[0]))) * 1.0000005f)) ^ _e220.member_3[0])))) ^ _e220.member_3[0]));
                                                            }
                                                            let _e1503 = phi_4045_;
                                                            phi_4063_ = (_e1305 || !(((((bitcast<f32>((bitcast<u32>((_e1359.x * _e1386)) ^ _e220.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1359.y * _e1387)) ^ _e220.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1359.z * _e1388)) ^ _e220.member_3[0]))) * f32(-(_e1304))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1359.x) & 2147483647u)) * _e1412)) ^ _e220.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1359.y) & 2147483647u)) * _e1419)) ^ _e220.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1359.z) & 2147483647u)) * _e1426)) ^ _e220.member_3[0]))))) ^ _e220.member_3[0])) + _e1503) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1517 = phi_4063_;
                                                        phi_4064_ = _e1517;
                                                    }
                                                    let _e1519 = phi_4064_;
                                                    if _e1519 {
                                                        if (_e1291.member < _e913.member.member) {
                                                            phi_4084_ = true;
                                                        } else {
                                                            if (_e1291.member == _e913.member.member) {
                                                                phi_4083_ = (_e1291.member_3 < _e913.member.member_3);
                                                            } else {
                                                                phi_4083_ = false;
                                                            }
                                                            let _e1529 = phi_4083_;
                                                            phi_4084_ = _e1529;
                                                        }
                                                        let _e1531 = phi_4084_;
                                                        if _e1531 {
                                                            phi_4090_ = type_42(_e1291, _e1291.member);
                                                        } else {
                                                            phi_4090_ = _e913;
                                                        }
                                                        let _e1534 = phi_4090_;
                                                        phi_4091_ = _e1534;
                                                    } else {
                                                        phi_4091_ = _e913;
                                                    }
                                                    let _e1536 = phi_4091_;
                                                    phi_4092_ = _e1536;
                                                } else {
                                                    phi_4092_ = _e913;
                                                }
                                                let _e1538 = phi_4092_;
                                                phi_3024_ = _e1538;
                                            } else {
                                                phi_3024_ = type_42();
                                            }
                                            let _e1540 = phi_3024_;
                                            continue;
                                            continuing {
                                                phi_3023_ = _e1540;
                                                phi_3026_ = _e928;
                                                phi_5205_ = _e548;
                                                break if !(_e934);
                                            }
                                        }
                                        let _e1543 = phi_5205_;
                                        phi_5288_ = _e1543;
                                        if _e1543 {
                                            break;
                                        }
                                        phi_5292_ = _e1543;
                                        let _e1757 = local_13;
                                        phi_4936_ = _e1757;
                                        phi_4937_ = _e587;
                                        phi_4938_ = false;
                                        phi_4939_ = _e591;
                                    } else {
                                        local_1 = array<f32, 3>(_e587.member.member[0], _e587.member.member[1], _e587.member.member[2]);
                                        local = array<f32, 3>(_e587.member.member_1[0], _e587.member.member_1[1], _e587.member.member_1[2]);
                                        let _e611 = (_e587.member_1 < _e93);
                                        if _e611 {
                                            if _e611 {
                                            } else {
                                                phi_5288_ = true;
                                                break;
                                            }
                                            let _e613 = global_10.member[_e587.member_1];
                                            phi_4126_ = _e613;
                                        } else {
                                            phi_4126_ = type_53(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e615 = phi_4126_;
                                        let _e617 = array<u32, 3>(_e342, _e341, _e343);
                                        local_9 = _e617;
                                        local_5 = array<f32, 3>(0f, 0f, 0f);
                                        local_4 = array<f32, 3>(0f, 0f, 0f);
                                        phi_4135_ = type_8(0u, 3u);
                                        loop {
                                            let _e619 = phi_4135_;
                                            if (_e619.member < _e619.member_1) {
                                                phi_4136_ = type_8((_e619.member + 1u), _e619.member_1);
                                                phi_4159_ = type_8(1u, _e619.member);
                                            } else {
                                                phi_4136_ = _e619;
                                                phi_4159_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e632 = phi_4136_;
                                            let _e634 = phi_4159_;
                                            let _e638 = (bitcast<i32>(_e634.member) != 0i);
                                            if _e638 {
                                                let _e639 = (_e634.member_1 < 3u);
                                                if _e639 {
                                                } else {
                                                    phi_5139_ = true;
                                                    break;
                                                }
                                                let _e641 = local_9[_e634.member_1];
                                                if _e639 {
                                                } else {
                                                    phi_5139_ = true;
                                                    break;
                                                }
                                                let _e643 = local_1[_e634.member_1];
                                                if _e639 {
                                                } else {
                                                    phi_5139_ = true;
                                                    break;
                                                }
                                                let _e645 = local[_e634.member_1];
                                                let _e648 = ((10u * _e641) & 31u);
                                                let _e651 = ((_e615.member[0] >> bitcast<u32>(_e648)) & 1023u);
                                                let _e656 = bitcast<f32>((bitcast<u32>(((_e645 - _e643) * 0.0009775171f)) ^ _e135));
                                                let _e662 = (_e643 + bitcast<f32>((bitcast<u32>((f32(_e651) * _e656)) ^ _e135)));
                                                if _e639 {
                                                } else {
                                                    phi_5139_ = true;
                                                    break;
                                                }
                                                local_5[_e634.member_1] = select(select(_e645, _e662, (_e662 < _e645)), _e645, (_e651 == 1023u));
                                                let _e671 = ((_e615.member[1] >> bitcast<u32>(_e648)) & 1023u);
                                                let _e677 = (_e643 + bitcast<f32>((bitcast<u32>((f32(_e671) * _e656)) ^ _e135)));
                                                if _e639 {
                                                } else {
                                                    phi_5139_ = true;
                                                    break;
                                                }
                                                local_4[_e634.member_1] = select(select(_e645, _e677, (_e677 < _e645)), _e645, (_e671 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_4135_ = _e632;
                                                phi_5139_ = _e548;
                                                break if !(_e638);
                                            }
                                        }
                                        let _e685 = phi_5139_;
                                        phi_5288_ = _e685;
                                        if _e685 {
                                            break;
                                        }
                                        let _e686 = local_4;
                                        let _e687 = local_5;
                                        local_8 = _e617;
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        local_6 = array<f32, 3>(0f, 0f, 0f);
                                        phi_4289_ = type_8(0u, 3u);
                                        loop {
                                            let _e696 = phi_4289_;
                                            if (_e696.member < _e696.member_1) {
                                                phi_4290_ = type_8((_e696.member + 1u), _e696.member_1);
                                                phi_4313_ = type_8(1u, _e696.member);
                                            } else {
                                                phi_4290_ = _e696;
                                                phi_4313_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e709 = phi_4290_;
                                            let _e711 = phi_4313_;
                                            let _e715 = (bitcast<i32>(_e711.member) != 0i);
                                            if _e715 {
                                                let _e716 = (_e711.member_1 < 3u);
                                                if _e716 {
                                                } else {
                                                    phi_5197_ = true;
                                                    break;
                                                }
                                                let _e718 = local_8[_e711.member_1];
                                                if _e716 {
                                                } else {
                                                    phi_5197_ = true;
                                                    break;
                                                }
                                                let _e720 = local_1[_e711.member_1];
                                                if _e716 {
                                                } else {
                                                    phi_5197_ = true;
                                                    break;
                                                }
                                                let _e722 = local[_e711.member_1];
                                                let _e725 = ((10u * _e718) & 31u);
                                                let _e728 = ((_e615.member_1[0] >> bitcast<u32>(_e725)) & 1023u);
                                                let _e733 = bitcast<f32>((bitcast<u32>(((_e722 - _e720) * 0.0009775171f)) ^ _e135));
                                                let _e739 = (_e720 + bitcast<f32>((bitcast<u32>((f32(_e728) * _e733)) ^ _e135)));
                                                if _e716 {
                                                } else {
                                                    phi_5197_ = true;
                                                    break;
                                                }
                                                local_7[_e711.member_1] = select(select(_e722, _e739, (_e739 < _e722)), _e722, (_e728 == 1023u));
                                                let _e748 = ((_e615.member_1[1] >> bitcast<u32>(_e725)) & 1023u);
                                                let _e754 = (_e720 + bitcast<f32>((bitcast<u32>((f32(_e748) * _e733)) ^ _e135)));
                                                if _e716 {
                                                } else {
                                                    phi_5197_ = true;
                                                    break;
                                                }
                                                local_6[_e711.member_1] = select(select(_e722, _e754, (_e754 < _e722)), _e722, (_e748 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_4289_ = _e709;
                                                phi_5197_ = _e685;
                                                break if !(_e715);
                                            }
                                        }
                                        let _e762 = phi_5197_;
                                        phi_5288_ = _e762;
                                        if _e762 {
                                            break;
                                        }
                                        let _e763 = local_6;
                                        let _e764 = local_7;
                                        let _e775 = type_61(type_58(array<f32, 3>(_e687[0], _e687[1], _e687[2]), array<f32, 3>(_e686[0], _e686[1], _e686[2])), _e615.member_2);
                                        let _e780 = type_61(type_58(array<f32, 3>(_e764[0], _e764[1], _e764[2]), array<f32, 3>(_e763[0], _e763[1], _e763[2])), _e615.member_3);
                                        let _e786 = ((_e687[0] - _e393) * _e398);
                                        let _e787 = ((_e764[0] - _e393) * _e398);
                                        let _e788 = ((_e686[0] - _e394) * _e398);
                                        let _e789 = ((_e763[0] - _e394) * _e398);
                                        let _e794 = ((_e687[1] - _e429) * _e434);
                                        let _e795 = ((_e764[1] - _e429) * _e434);
                                        let _e796 = ((_e686[1] - _e430) * _e434);
                                        let _e797 = ((_e763[1] - _e430) * _e434);
                                        let _e802 = ((_e687[2] - _e465) * _e470);
                                        let _e803 = ((_e764[2] - _e465) * _e470);
                                        let _e804 = ((_e686[2] - _e466) * _e470);
                                        let _e805 = ((_e763[2] - _e466) * _e470);
                                        let _e807 = select(_e804, _e802, (_e802 < _e804));
                                        let _e809 = select(_e805, _e803, (_e803 < _e805));
                                        let _e811 = select(_e804, _e802, (_e802 > _e804));
                                        let _e813 = select(_e805, _e803, (_e803 > _e805));
                                        let _e815 = select(_e788, _e786, (_e786 < _e788));
                                        let _e817 = select(_e789, _e787, (_e787 < _e789));
                                        let _e819 = select(_e796, _e794, (_e794 < _e796));
                                        let _e821 = select(_e797, _e795, (_e795 < _e797));
                                        let _e823 = select(_e819, _e815, (_e815 > _e819));
                                        let _e825 = select(_e821, _e817, (_e817 > _e821));
                                        let _e827 = select(_e807, _e823, (_e823 > _e807));
                                        let _e829 = select(_e809, _e825, (_e825 > _e809));
                                        let _e831 = select(_e788, _e786, (_e786 > _e788));
                                        let _e833 = select(_e789, _e787, (_e787 > _e789));
                                        let _e835 = select(_e796, _e794, (_e794 > _e796));
                                        let _e837 = select(_e797, _e795, (_e795 > _e797));
                                        let _e839 = select(_e835, _e831, (_e831 < _e835));
                                        let _e841 = select(_e837, _e833, (_e833 < _e837));
                                        let _e846 = -(_e807);
                                        let _e847 = -(_e809);
                                        let _e854 = (select(_e811, _e839, (_e839 < _e811)) + (select(_e846, _e811, (_e811 > _e846)) * 0.0000019073523f));
                                        let _e855 = (select(_e813, _e841, (_e841 < _e813)) + (select(_e847, _e813, (_e813 > _e847)) * 0.0000019073523f));
                                        let _e857 = select(_e516, _e827, (_e827 > _e516));
                                        let _e859 = select(_e516, _e829, (_e829 > _e516));
                                        let _e864 = (_e857 <= select(_e550.member_1, _e854, (_e854 < _e550.member_1)));
                                        let _e865 = (_e859 <= select(_e550.member_1, _e855, (_e855 < _e550.member_1)));
                                        let _e866 = (_e857 <= _e859);
                                        if _e864 {
                                            if _e865 {
                                                if _e866 {
                                                    phi_4876_ = _e780;
                                                } else {
                                                    phi_4876_ = _e775;
                                                }
                                                let _e868 = phi_4876_;
                                                let _e869 = (_e591 % 128u);
                                                let _e870 = (_e869 < 128u);
                                                if _e870 {
                                                } else {
                                                    phi_5288_ = true;
                                                    break;
                                                }
                                                local_3[_e869] = type_61(type_58(array<f32, 3>(_e868.member.member[0], _e868.member.member[1], _e868.member.member[2]), array<f32, 3>(_e868.member.member_1[0], _e868.member.member_1[1], _e868.member.member_1[2])), _e868.member_1);
                                                if _e870 {
                                                } else {
                                                    phi_5288_ = true;
                                                    break;
                                                }
                                                local_2[_e869] = select(_e859, _e857, (_e857 > _e859));
                                                if _e866 {
                                                    phi_4915_ = _e775;
                                                } else {
                                                    phi_4915_ = _e780;
                                                }
                                                let _e891 = phi_4915_;
                                                phi_4916_ = _e891;
                                                phi_4917_ = (_e591 + 1u);
                                            } else {
                                                phi_4916_ = type_61();
                                                phi_4917_ = u32();
                                            }
                                            let _e893 = phi_4916_;
                                            let _e895 = phi_4917_;
                                            phi_4919_ = _e893;
                                            phi_4920_ = _e895;
                                            phi_4921_ = select(true, false, _e865);
                                        } else {
                                            phi_4919_ = type_61();
                                            phi_4920_ = u32();
                                            phi_4921_ = true;
                                        }
                                        let _e898 = phi_4919_;
                                        let _e900 = phi_4920_;
                                        let _e902 = phi_4921_;
                                        if _e902 {
                                            if _e864 {
                                                phi_4928_ = _e775;
                                            } else {
                                                phi_4928_ = _e780;
                                            }
                                            let _e904 = phi_4928_;
                                            phi_4933_ = _e904;
                                            phi_4934_ = select(_e865, true, _e864);
                                        } else {
                                            phi_4933_ = _e898;
                                            phi_4934_ = _e589;
                                        }
                                        let _e907 = phi_4933_;
                                        let _e909 = phi_4934_;
                                        phi_5292_ = _e762;
                                        phi_4936_ = _e550;
                                        phi_4937_ = _e907;
                                        phi_4938_ = _e909;
                                        phi_4939_ = select(_e900, _e591, _e902);
                                    }
                                    let _e1545 = phi_5292_;
                                    let _e1547 = phi_4936_;
                                    let _e1549 = phi_4937_;
                                    let _e1551 = phi_4938_;
                                    let _e1553 = phi_4939_;
                                    phi_5291_ = _e1545;
                                    phi_4940_ = _e1547;
                                    phi_4941_ = _e1549;
                                    phi_4942_ = (_e554 - 1u);
                                    phi_4943_ = _e1551;
                                    phi_4944_ = _e1553;
                                } else {
                                    phi_5291_ = _e548;
                                    phi_4940_ = _e550;
                                    phi_4941_ = _e587;
                                    phi_4942_ = _e554;
                                    phi_4943_ = _e589;
                                    phi_4944_ = _e591;
                                }
                                let _e1555 = phi_5291_;
                                let _e1557 = phi_4940_;
                                let _e1559 = phi_4941_;
                                let _e1561 = phi_4942_;
                                let _e1563 = phi_4943_;
                                let _e1565 = phi_4944_;
                                phi_5290_ = _e1555;
                                phi_4945_ = _e1557;
                                phi_4946_ = _e1559;
                                phi_4947_ = _e1561;
                                phi_4948_ = _e1563;
                                phi_4949_ = _e1565;
                            } else {
                                phi_5290_ = _e548;
                                phi_4945_ = type_42();
                                phi_4946_ = type_61();
                                phi_4947_ = u32();
                                phi_4948_ = bool();
                                phi_4949_ = u32();
                            }
                            let _e1567 = phi_5290_;
                            let _e1569 = phi_4945_;
                            let _e1571 = phi_4946_;
                            let _e1573 = phi_4947_;
                            let _e1575 = phi_4948_;
                            let _e1577 = phi_4949_;
                            phi_5289_ = _e1567;
                            phi_2939_ = _e1569;
                            phi_2942_ = _e1571;
                            phi_2944_ = _e1573;
                            phi_2946_ = _e1575;
                            phi_2948_ = _e1577;
                            phi_4950_ = _e562;
                        } else {
                            phi_5289_ = _e548;
                            phi_2939_ = type_42();
                            phi_2942_ = type_61();
                            phi_2944_ = u32();
                            phi_2946_ = bool();
                            phi_2948_ = u32();
                            phi_4950_ = false;
                        }
                        let _e1579 = phi_5289_;
                        let _e1581 = phi_2939_;
                        let _e1583 = phi_2942_;
                        let _e1585 = phi_2944_;
                        let _e1587 = phi_2946_;
                        let _e1589 = phi_2948_;
                        let _e1591 = phi_4950_;
                        continue;
                        continuing {
                            phi_5146_ = _e1579;
                            phi_2938_ = _e1581;
                            phi_2941_ = _e1583;
                            phi_2943_ = _e1585;
                            phi_2945_ = _e1587;
                            phi_2947_ = _e1589;
                            phi_5288_ = _e1579;
                            break if !(_e1591);
                        }
                    }
                    let _e1594 = phi_5288_;
                    if _e1594 {
                        break;
                    }
                    let _e1596 = local_12;
                    if (_e1596.member.member_3 != 4294967295u) {
                        let _e1601 = (_e344 / 3i);
                        let _e1608 = bitcast<f32>((bitcast<u32>((_e1601 + 127i)) << bitcast<u32>(23i)));
                        let _e1616 = (((_e1596.member.member * _e1608) * _e1608) * bitcast<f32>((bitcast<u32>(((_e344 - (2i * _e1601)) + 127i)) << bitcast<u32>(23i))));
                        let _e1618 = select(340282350000000000000000000000000000000f, _e1616, (_e1616 < 340282350000000000000000000000000000000f));
                        phi_5002_ = type_27(select(-340282350000000000000000000000000000000f, _e1618, (_e1618 > -340282350000000000000000000000000000000f)), _e1596.member.member_1, _e1596.member.member_2, _e1596.member.member_3);
                    } else {
                        phi_5002_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1625 = phi_5002_;
                    if _e221 {
                    } else {
                        break;
                    }
                    global_8.member[_e139] = _e1625;
                    if _e146 {
                    } else {
                        break;
                    }
                    let _e1629 = select(0u, 1u, (_e288 <= _e298));
                    if (_e1629 > 0u) {
                        let _e1631 = (1u < _e107);
                        if _e1631 {
                            if (0u < _e107) {
                            } else {
                                break;
                            }
                            let _e1635 = atomicAdd((&global_9.member[0u]), _e1629);
                            if ((_e1635 + _e1629) < _e1635) {
                                if _e1631 {
                                } else {
                                    break;
                                }
                                let _e1640 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1643 = select(0u, 1u, (_e1625.member_3 != 4294967295u));
                    if (_e1643 > 0u) {
                        let _e1645 = (3u < _e107);
                        if _e1645 {
                            if (2u < _e107) {
                            } else {
                                break;
                            }
                            let _e1649 = atomicAdd((&global_9.member[2u]), _e1643);
                            if ((_e1649 + _e1643) < _e1649) {
                                if _e1645 {
                                } else {
                                    break;
                                }
                                let _e1654 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
