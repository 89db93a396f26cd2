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
    var phi_276_: u32;
    var phi_320_: i32;
    var phi_344_: type_40;
    var phi_450_: i32;
    var phi_451_: i32;
    var phi_461_: bool;
    var phi_471_: u32;
    var phi_472_: u32;
    var phi_474_: bool;
    var phi_479_: u32;
    var phi_512_: i32;
    var phi_530_: f32;
    var phi_536_: f32;
    var phi_547_: f32;
    var phi_553_: f32;
    var phi_576_: f32;
    var phi_587_: f32;
    var phi_596_: f32;
    var phi_602_: f32;
    var phi_613_: f32;
    var phi_619_: f32;
    var phi_642_: f32;
    var phi_653_: f32;
    var phi_662_: f32;
    var phi_668_: f32;
    var phi_679_: f32;
    var phi_685_: f32;
    var phi_708_: f32;
    var phi_719_: f32;
    var phi_819_: f32;
    var phi_820_: f32;
    var phi_5156_: bool;
    var phi_2948_: type_42;
    var phi_2951_: type_61;
    var phi_2953_: u32;
    var phi_2955_: bool;
    var phi_2957_: u32;
    var phi_2968_: bool;
    var phi_3013_: type_61;
    var phi_3014_: bool;
    var phi_3015_: u32;
    var phi_4136_: type_53;
    var phi_4145_: type_8;
    var phi_4146_: type_8;
    var phi_4169_: type_8;
    var phi_5149_: bool;
    var phi_4299_: type_8;
    var phi_4300_: type_8;
    var phi_4323_: type_8;
    var phi_5213_: bool;
    var phi_4886_: type_61;
    var phi_4925_: type_61;
    var phi_4926_: type_61;
    var phi_4927_: u32;
    var phi_4929_: type_61;
    var phi_4930_: u32;
    var phi_4931_: bool;
    var phi_4938_: type_61;
    var phi_4943_: type_61;
    var phi_4944_: bool;
    var phi_3033_: type_42;
    var phi_3036_: type_8;
    var phi_3037_: type_8;
    var phi_3059_: type_8;
    var phi_3080_: u32;
    var phi_3169_: array<array<f32, 3>, 3>;
    var phi_3640_: vec3<f32>;
    var phi_3641_: vec3<f32>;
    var phi_3672_: bool;
    var phi_3681_: vec3<f32>;
    var phi_3721_: type_27;
    var phi_3723_: type_27;
    var phi_3724_: bool;
    var phi_3728_: type_27;
    var phi_3729_: type_27;
    var phi_3730_: type_27;
    var phi_3731_: bool;
    var phi_3735_: type_27;
    var phi_3736_: bool;
    var phi_3740_: type_27;
    var phi_3741_: bool;
    var phi_3745_: type_27;
    var phi_3768_: u32;
    var phi_3782_: i32;
    var phi_3802_: vec3<f32>;
    var phi_3803_: vec3<f32>;
    var phi_3819_: vec3<f32>;
    var phi_3820_: vec3<f32>;
    var phi_3836_: vec3<f32>;
    var phi_3837_: vec3<f32>;
    var phi_3873_: vec3<f32>;
    var phi_4055_: f32;
    var phi_4073_: bool;
    var phi_4074_: bool;
    var phi_4093_: bool;
    var phi_4094_: bool;
    var phi_4100_: type_42;
    var phi_4101_: type_42;
    var phi_4102_: type_42;
    var phi_3034_: type_42;
    var phi_5221_: bool;
    var phi_5308_: bool;
    var phi_4946_: type_42;
    var phi_4947_: type_61;
    var phi_4948_: bool;
    var phi_4949_: u32;
    var phi_5307_: bool;
    var phi_4950_: type_42;
    var phi_4951_: type_61;
    var phi_4952_: u32;
    var phi_4953_: bool;
    var phi_4954_: u32;
    var phi_5306_: bool;
    var phi_4955_: type_42;
    var phi_4956_: type_61;
    var phi_4957_: u32;
    var phi_4958_: bool;
    var phi_4959_: u32;
    var phi_5305_: bool;
    var phi_2949_: type_42;
    var phi_2952_: type_61;
    var phi_2954_: u32;
    var phi_2956_: bool;
    var phi_2958_: u32;
    var phi_4960_: bool;
    var phi_5304_: bool;
    var local_12: type_42;
    var phi_5012_: type_27;
    var local_13: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e91 = global;
            let _e94 = arrayLength((&global_10.member));
            let _e96 = arrayLength((&global_4.member));
            let _e108 = arrayLength((&global_9.member));
            let _e112 = global_3.member[0u][0u];
            let _e116 = global_3.member[0u][1u];
            let _e120 = global_3.member[0u][2u];
            let _e124 = global_3.member[1u][0u];
            let _e128 = global_3.member[1u][1u];
            let _e132 = global_3.member[1u][2u];
            let _e136 = global_3.member[1u][3u];
            let _e140 = (_e91.x + (_e91.y * 2097152u));
            let _e147 = (_e140 < arrayLength((&global_7.member)));
            if _e147 {
                if _e147 {
                } else {
                    break;
                }
                let _e151 = global_7.member[_e140].member_2;
                phi_276_ = _e151;
            } else {
                phi_276_ = 4294967295u;
            }
            let _e153 = phi_276_;
            let _e156 = global_1.member[0u];
            let _e160 = global_2.member[0u][0u];
            let _e164 = global_2.member[0u][1u];
            let _e168 = global_2.member[0u][2u];
            let _e172 = global_2.member[0u][3u];
            let _e176 = global_2.member[1u][0u];
            let _e180 = global_2.member[1u][1u];
            let _e184 = global_2.member[1u][2u];
            let _e188 = global_2.member[1u][3u];
            let _e189 = bitcast<f32>(_e160);
            let _e190 = bitcast<f32>(_e164);
            let _e191 = bitcast<f32>(_e168);
            let _e193 = bitcast<f32>(_e176);
            let _e194 = array<u32, 3>(_e180, _e184, _e188);
            let _e196 = bitcast<i32>(_e156);
            if (_e196 < -126i) {
                phi_320_ = -126i;
            } else {
                phi_320_ = select(_e196, 127i, (_e196 > 127i));
            }
            let _e201 = phi_320_;
            let _e206 = bitcast<f32>((bitcast<u32>((_e201 + 127i)) << bitcast<u32>(23i)));
            let _e212 = bitcast<f32>((bitcast<u32>(((_e196 - _e201) + 127i)) << bitcast<u32>(23i)));
            if (_e172 == 0u) {
                phi_344_ = type_40(array<f32, 3>(_e189, _e190, _e191), _e172, _e193, _e194);
            } else {
                phi_344_ = type_40(array<f32, 3>(((_e189 * _e206) * _e212), ((_e190 * _e206) * _e212), ((_e191 * _e206) * _e212)), _e172, ((_e193 * _e206) * _e212), _e194);
            }
            let _e225 = phi_344_;
            if _e147 {
                let _e226 = (_e140 < arrayLength((&global_8.member)));
                if _e226 {
                    if _e147 {
                    } else {
                        break;
                    }
                    let _e236 = global_7.member[_e140].member.member_2[0u];
                    let _e238 = (bitcast<u32>(_e236) & 2147483647u);
                    let _e244 = global_7.member[_e140].member.member_2[1u];
                    let _e246 = (bitcast<u32>(_e244) & 2147483647u);
                    let _e252 = global_7.member[_e140].member.member_2[2u];
                    let _e254 = (bitcast<u32>(_e252) & 2147483647u);
                    let _e260 = global_7.member[_e140].member.member[0u];
                    let _e262 = (bitcast<u32>(_e260) & 2147483647u);
                    let _e268 = global_7.member[_e140].member.member[1u];
                    let _e270 = (bitcast<u32>(_e268) & 2147483647u);
                    let _e276 = global_7.member[_e140].member.member[2u];
                    let _e278 = (bitcast<u32>(_e276) & 2147483647u);
                    let _e280 = select(_e246, _e238, (_e246 < _e238));
                    let _e282 = select(_e254, _e280, (_e254 < _e280));
                    let _e284 = select(_e262, _e282, (_e262 < _e282));
                    let _e286 = select(_e270, _e284, (_e270 < _e284));
                    let _e288 = select(_e278, _e286, (_e278 < _e286));
                    let _e293 = global_7.member[_e140].member.member_1;
                    let _e295 = (bitcast<u32>(_e293) & 2147483647u);
                    let _e303 = global_7.member[_e140].member.member_3;
                    let _e309 = (((select(_e295, _e288, (_e295 < _e288)) < 2139095040u) && ((bitcast<u32>(_e303) & 2147483647u) <= 2139095040u)) && (_e282 > 0u));
                    if _e309 {
                        let _e312 = (bitcast<u32>(bitcast<f32>(_e282)) & 2147483647u);
                        if (_e312 >= 8388608u) {
                            phi_450_ = (bitcast<i32>((_e312 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_450_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e312)), 32u, (_e312 == 0u))));
                        }
                        let _e326 = phi_450_;
                        phi_451_ = _e326;
                    } else {
                        phi_451_ = 0i;
                    }
                    let _e328 = phi_451_;
                    let _e329 = (_e238 == _e282);
                    if _e329 {
                        phi_461_ = true;
                    } else {
                        phi_461_ = (_e246 == _e282);
                    }
                    let _e332 = phi_461_;
                    let _e333 = select(1u, 0u, _e329);
                    if _e332 {
                        let _e334 = (_e333 + 1u);
                        phi_471_ = _e334;
                        phi_472_ = _e334;
                        phi_474_ = select(true, false, (_e334 == 2u));
                    } else {
                        phi_471_ = u32();
                        phi_472_ = 0u;
                        phi_474_ = true;
                    }
                    let _e338 = phi_471_;
                    let _e340 = phi_472_;
                    let _e342 = phi_474_;
                    if _e342 {
                        phi_479_ = (_e340 + 1u);
                    } else {
                        phi_479_ = 0u;
                    }
                    let _e346 = phi_479_;
                    let _e347 = select(_e338, _e340, _e342);
                    let _e348 = select(_e333, select(2u, _e333, _e332), _e342);
                    let _e349 = -(_e328);
                    if (_e349 < -126i) {
                        phi_512_ = -126i;
                    } else {
                        phi_512_ = select(_e349, 127i, (_e349 > 127i));
                    }
                    let _e354 = phi_512_;
                    let _e359 = bitcast<f32>((bitcast<u32>((_e354 + 127i)) << bitcast<u32>(23i)));
                    let _e365 = bitcast<f32>((bitcast<u32>(((_e349 - _e354) + 127i)) << bitcast<u32>(23i)));
                    let _e370 = global_7.member[_e140].member.member;
                    let _e371 = (_e347 == 0u);
                    if _e371 {
                        phi_530_ = _e370[0];
                    } else {
                        phi_530_ = _e370[1];
                    }
                    let _e375 = phi_530_;
                    let _e376 = (_e347 == 2u);
                    if _e376 {
                        phi_536_ = _e370[2];
                    } else {
                        phi_536_ = _e375;
                    }
                    let _e379 = phi_536_;
                    let _e380 = global_7.member[_e140].member.member_2;
                    if _e371 {
                        phi_547_ = _e380[0];
                    } else {
                        phi_547_ = _e380[1];
                    }
                    let _e384 = phi_547_;
                    if _e376 {
                        phi_553_ = _e380[2];
                    } else {
                        phi_553_ = _e384;
                    }
                    let _e387 = phi_553_;
                    let _e389 = ((_e387 * _e359) * _e365);
                    let _e393 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e393 {
                        let _e397 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) * 0.00000011920929f);
                        phi_576_ = select(0.00000000000011368684f, _e397, (_e397 > 0.00000000000011368684f));
                    } else {
                        phi_576_ = 0f;
                    }
                    let _e401 = phi_576_;
                    let _e402 = (_e379 + _e401);
                    let _e403 = (_e379 - _e401);
                    let _e404 = select(_e389, 0f, _e393);
                    if _e393 {
                        phi_587_ = 38685626000000000000000000f;
                    } else {
                        phi_587_ = (1f / _e389);
                    }
                    let _e407 = phi_587_;
                    let _e408 = (_e346 == 0u);
                    if _e408 {
                        phi_596_ = _e370[0];
                    } else {
                        phi_596_ = _e370[1];
                    }
                    let _e412 = phi_596_;
                    let _e413 = (_e346 == 2u);
                    if _e413 {
                        phi_602_ = _e370[2];
                    } else {
                        phi_602_ = _e412;
                    }
                    let _e416 = phi_602_;
                    if _e408 {
                        phi_613_ = _e380[0];
                    } else {
                        phi_613_ = _e380[1];
                    }
                    let _e420 = phi_613_;
                    if _e413 {
                        phi_619_ = _e380[2];
                    } else {
                        phi_619_ = _e420;
                    }
                    let _e423 = phi_619_;
                    let _e425 = ((_e423 * _e359) * _e365);
                    let _e429 = (bitcast<f32>((bitcast<u32>(_e425) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e429 {
                        let _e433 = (bitcast<f32>((bitcast<u32>(_e416) & 2147483647u)) * 0.00000011920929f);
                        phi_642_ = select(0.00000000000011368684f, _e433, (_e433 > 0.00000000000011368684f));
                    } else {
                        phi_642_ = 0f;
                    }
                    let _e437 = phi_642_;
                    let _e438 = (_e416 + _e437);
                    let _e439 = (_e416 - _e437);
                    let _e440 = select(_e425, 0f, _e429);
                    if _e429 {
                        phi_653_ = 38685626000000000000000000f;
                    } else {
                        phi_653_ = (1f / _e425);
                    }
                    let _e443 = phi_653_;
                    let _e444 = (_e348 == 0u);
                    if _e444 {
                        phi_662_ = _e370[0];
                    } else {
                        phi_662_ = _e370[1];
                    }
                    let _e448 = phi_662_;
                    let _e449 = (_e348 == 2u);
                    if _e449 {
                        phi_668_ = _e370[2];
                    } else {
                        phi_668_ = _e448;
                    }
                    let _e452 = phi_668_;
                    if _e444 {
                        phi_679_ = _e380[0];
                    } else {
                        phi_679_ = _e380[1];
                    }
                    let _e456 = phi_679_;
                    if _e449 {
                        phi_685_ = _e380[2];
                    } else {
                        phi_685_ = _e456;
                    }
                    let _e459 = phi_685_;
                    let _e461 = ((_e459 * _e359) * _e365);
                    let _e465 = (bitcast<f32>((bitcast<u32>(_e461) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e465 {
                        let _e469 = (bitcast<f32>((bitcast<u32>(_e452) & 2147483647u)) * 0.00000011920929f);
                        phi_708_ = select(0.00000000000011368684f, _e469, (_e469 > 0.00000000000011368684f));
                    } else {
                        phi_708_ = 0f;
                    }
                    let _e473 = phi_708_;
                    let _e474 = (_e452 + _e473);
                    let _e475 = (_e452 - _e473);
                    let _e476 = select(_e461, 0f, _e465);
                    if _e465 {
                        phi_719_ = 38685626000000000000000000f;
                    } else {
                        phi_719_ = (1f / _e461);
                    }
                    let _e479 = phi_719_;
                    let _e482 = bitcast<f32>((bitcast<u32>(_e379) & 2147483647u));
                    let _e485 = bitcast<f32>((bitcast<u32>(_e416) & 2147483647u));
                    let _e487 = select(_e485, _e482, (_e482 > _e485));
                    let _e490 = bitcast<f32>((bitcast<u32>(_e452) & 2147483647u));
                    if (_e309 && (select(_e490, _e487, (_e487 > _e490)) <= 1099511600000f)) {
                        let _e495 = (_e328 / 3i);
                        let _e502 = bitcast<f32>((bitcast<u32>((_e495 + 127i)) << bitcast<u32>(23i)));
                        let _e509 = bitcast<f32>((bitcast<u32>(((_e328 - (2i * _e495)) + 127i)) << bitcast<u32>(23i)));
                        let _e510 = (((_e293 * _e502) * _e502) * _e509);
                        let _e512 = select(340282350000000000000000000000000000000f, _e510, (_e510 < 340282350000000000000000000000000000000f));
                        let _e517 = (((_e303 * _e502) * _e502) * _e509);
                        let _e519 = select(340282350000000000000000000000000000000f, _e517, (_e517 < 340282350000000000000000000000000000000f));
                        phi_819_ = select(-340282350000000000000000000000000000000f, _e519, (_e519 > -340282350000000000000000000000000000000f));
                        phi_820_ = select(-340282350000000000000000000000000000000f, _e512, (_e512 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_819_ = 0f;
                        phi_820_ = 1f;
                    }
                    let _e523 = phi_819_;
                    let _e525 = phi_820_;
                    local_3 = array<type_61, 128>(type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_58(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_11 = array<f32, 3>(bitcast<f32>(_e112), bitcast<f32>(_e116), bitcast<f32>(_e120));
                    let _e530 = (_e347 % 3u);
                    let _e531 = (_e530 < 3u);
                    if _e531 {
                    } else {
                        break;
                    }
                    let _e533 = local_11[_e530];
                    let _e534 = (_e346 % 3u);
                    let _e535 = (_e534 < 3u);
                    if _e535 {
                    } else {
                        break;
                    }
                    let _e537 = local_11[_e534];
                    let _e538 = (_e348 % 3u);
                    let _e539 = (_e538 < 3u);
                    if _e539 {
                    } else {
                        break;
                    }
                    let _e541 = local_11[_e538];
                    local_10 = array<f32, 3>(bitcast<f32>(_e124), bitcast<f32>(_e128), bitcast<f32>(_e132));
                    if _e531 {
                    } else {
                        break;
                    }
                    let _e545 = local_10[_e530];
                    if _e535 {
                    } else {
                        break;
                    }
                    let _e547 = local_10[_e534];
                    if _e539 {
                    } else {
                        break;
                    }
                    let _e549 = local_10[_e538];
                    phi_5156_ = false;
                    phi_2948_ = type_42(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e523);
                    phi_2951_ = type_61(type_58(array<f32, 3>(_e533, _e537, _e541), array<f32, 3>(_e545, _e547, _e549)), select(0u, 2147483648u, (_e94 == 0u)));
                    phi_2953_ = ((3u * _e94) + 1u);
                    phi_2955_ = (_e525 <= _e523);
                    phi_2957_ = 0u;
                    loop {
                        let _e557 = phi_5156_;
                        let _e559 = phi_2948_;
                        let _e561 = phi_2951_;
                        let _e563 = phi_2953_;
                        let _e565 = phi_2955_;
                        let _e567 = phi_2957_;
                        local_12 = _e559;
                        if _e565 {
                            phi_2968_ = true;
                        } else {
                            phi_2968_ = (_e567 > 0u);
                        }
                        let _e570 = phi_2968_;
                        if _e570 {
                            let _e571 = (_e563 > 0u);
                            if _e571 {
                                if _e565 {
                                    phi_3013_ = _e561;
                                    phi_3014_ = _e565;
                                    phi_3015_ = _e567;
                                } else {
                                    let _e572 = (_e567 - 1u);
                                    let _e573 = (_e572 % 128u);
                                    let _e574 = (_e573 < 128u);
                                    if _e574 {
                                    } else {
                                        phi_5304_ = true;
                                        break;
                                    }
                                    let _e576 = local_3[_e573];
                                    if _e574 {
                                    } else {
                                        phi_5304_ = true;
                                        break;
                                    }
                                    let _e592 = local_2[_e573];
                                    phi_3013_ = type_61(type_58(array<f32, 3>(_e576.member.member[0], _e576.member.member[1], _e576.member.member[2]), array<f32, 3>(_e576.member.member_1[0], _e576.member.member_1[1], _e576.member.member_1[2])), _e576.member_1);
                                    phi_3014_ = (_e592 <= _e559.member_1);
                                    phi_3015_ = _e572;
                                }
                                let _e596 = phi_3013_;
                                let _e598 = phi_3014_;
                                let _e600 = phi_3015_;
                                if _e598 {
                                    if ((_e596.member_1 & 2147483648u) != 0u) {
                                        phi_3033_ = _e559;
                                        phi_3036_ = type_8(0u, ((_e596.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e922 = phi_3033_;
                                            let _e924 = phi_3036_;
                                            local_13 = _e922;
                                            if (_e924.member < _e924.member_1) {
                                                phi_3037_ = type_8((_e924.member + 1u), _e924.member_1);
                                                phi_3059_ = type_8(1u, _e924.member);
                                            } else {
                                                phi_3037_ = _e924;
                                                phi_3059_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e937 = phi_3037_;
                                            let _e939 = phi_3059_;
                                            let _e943 = (bitcast<i32>(_e939.member) != 0i);
                                            if _e943 {
                                                let _e944 = ((_e596.member_1 & 268435455u) + _e939.member_1);
                                                let _e945 = (_e944 < _e96);
                                                if _e945 {
                                                    if _e945 {
                                                    } else {
                                                        phi_5221_ = true;
                                                        break;
                                                    }
                                                    let _e949 = global_4.member[_e944].member_1;
                                                    phi_3080_ = _e949;
                                                } else {
                                                    phi_3080_ = 4294967295u;
                                                }
                                                let _e951 = phi_3080_;
                                                if (_e944 >= _e96) {
                                                    phi_3169_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e945 {
                                                    } else {
                                                        phi_5221_ = true;
                                                        break;
                                                    }
                                                    if (_e530 < 9u) {
                                                    } else {
                                                        phi_5221_ = true;
                                                        break;
                                                    }
                                                    let _e958 = global_4.member[_e944].member[_e530];
                                                    if (_e534 < 9u) {
                                                    } else {
                                                        phi_5221_ = true;
                                                        break;
                                                    }
                                                    let _e964 = global_4.member[_e944].member[_e534];
                                                    if (_e538 < 9u) {
                                                    } else {
                                                        phi_5221_ = true;
                                                        break;
                                                    }
                                                    let _e970 = global_4.member[_e944].member[_e538];
                                                    let _e972 = (3u + _e530);
                                                    if (_e972 < 9u) {
                                                    } else {
                                                        phi_5221_ = true;
                                                        break;
                                                    }
                                                    let _e978 = global_4.member[_e944].member[_e972];
                                                    let _e979 = (3u + _e534);
                                                    if (_e979 < 9u) {
                                                    } else {
                                                        phi_5221_ = true;
                                                        break;
                                                    }
                                                    let _e985 = global_4.member[_e944].member[_e979];
                                                    let _e986 = (3u + _e538);
                                                    if (_e986 < 9u) {
                                                    } else {
                                                        phi_5221_ = true;
                                                        break;
                                                    }
                                                    let _e992 = global_4.member[_e944].member[_e986];
                                                    let _e994 = (6u + _e530);
                                                    if (_e994 < 9u) {
                                                    } else {
                                                        phi_5221_ = true;
                                                        break;
                                                    }
                                                    let _e1000 = global_4.member[_e944].member[_e994];
                                                    let _e1001 = (6u + _e534);
                                                    if (_e1001 < 9u) {
                                                    } else {
                                                        phi_5221_ = true;
                                                        break;
                                                    }
                                                    let _e1007 = global_4.member[_e944].member[_e1001];
                                                    let _e1008 = (6u + _e538);
                                                    if (_e1008 < 9u) {
                                                    } else {
                                                        phi_5221_ = true;
                                                        break;
                                                    }
                                                    let _e1014 = global_4.member[_e944].member[_e1008];
                                                    phi_3169_ = array<array<f32, 3>, 3>(array<f32, 3>(_e958, _e964, _e970), array<f32, 3>(_e978, _e985, _e992), array<f32, 3>(_e1000, _e1007, _e1014));
                                                }
                                                let _e1018 = phi_3169_;
                                                let _e1026 = (_e1018[0][2] - _e452);
                                                let _e1029 = (((_e1018[0][0] - _e379) * _e476) - (_e1026 * _e404));
                                                let _e1032 = (((_e1018[0][1] - _e416) * _e476) - (_e1026 * _e440));
                                                let _e1039 = (_e1018[1][2] - _e452);
                                                let _e1042 = (((_e1018[1][0] - _e379) * _e476) - (_e1039 * _e404));
                                                let _e1045 = (((_e1018[1][1] - _e416) * _e476) - (_e1039 * _e440));
                                                let _e1052 = (_e1018[2][2] - _e452);
                                                let _e1055 = (((_e1018[2][0] - _e379) * _e476) - (_e1052 * _e404));
                                                let _e1058 = (((_e1018[2][1] - _e416) * _e476) - (_e1052 * _e440));
                                                let _e1059 = (_e1055 * _e1045);
                                                let _e1060 = (_e1058 * _e1042);
                                                let _e1061 = (_e1029 * _e1058);
                                                let _e1062 = (_e1032 * _e1055);
                                                let _e1063 = (_e1042 * _e1032);
                                                let _e1064 = (_e1045 * _e1029);
                                                let _e1069 = (((_e1059 >= _e1060) && (_e1061 >= _e1062)) && (_e1063 >= _e1064));
                                                if (_e1069 || (((_e1059 <= _e1060) && (_e1061 <= _e1062)) && (_e1063 <= _e1064))) {
                                                    let _e1076 = select(-1f, 1f, _e1069);
                                                    let _e1078 = ((_e1059 - _e1060) * _e1076);
                                                    let _e1080 = select(0f, _e1078, (_e1078 > 0f));
                                                    let _e1082 = ((_e1061 - _e1062) * _e1076);
                                                    let _e1084 = select(0f, _e1082, (_e1082 > 0f));
                                                    let _e1086 = ((_e1063 - _e1064) * _e1076);
                                                    let _e1088 = select(0f, _e1086, (_e1086 > 0f));
                                                    let _e1090 = ((_e1080 + _e1084) + _e1088);
                                                    if (_e1090 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3735_ = type_27();
                                                        phi_3736_ = true;
                                                    } else {
                                                        let _e1093 = select(_e1018[1][0], _e1018[0][0], (_e1018[0][0] < _e1018[1][0]));
                                                        let _e1097 = select(_e1018[1][0], _e1018[0][0], (_e1018[0][0] > _e1018[1][0]));
                                                        let _e1101 = select(_e1018[1][1], _e1018[0][1], (_e1018[0][1] < _e1018[1][1]));
                                                        let _e1105 = select(_e1018[1][1], _e1018[0][1], (_e1018[0][1] > _e1018[1][1]));
                                                        let _e1109 = select(_e1018[1][2], _e1018[0][2], (_e1018[0][2] < _e1018[1][2]));
                                                        let _e1113 = select(_e1018[1][2], _e1018[0][2], (_e1018[0][2] > _e1018[1][2]));
                                                        let _e1118 = ((select(_e1018[2][0], _e1093, (_e1093 < _e1018[2][0])) - _e402) * _e407);
                                                        let _e1119 = ((select(_e1018[2][0], _e1097, (_e1097 > _e1018[2][0])) - _e403) * _e407);
                                                        let _e1122 = ((select(_e1018[2][1], _e1101, (_e1101 < _e1018[2][1])) - _e438) * _e443);
                                                        let _e1123 = ((select(_e1018[2][1], _e1105, (_e1105 > _e1018[2][1])) - _e439) * _e443);
                                                        let _e1126 = ((select(_e1018[2][2], _e1109, (_e1109 < _e1018[2][2])) - _e474) * _e479);
                                                        let _e1127 = ((select(_e1018[2][2], _e1113, (_e1113 > _e1018[2][2])) - _e475) * _e479);
                                                        let _e1129 = select(_e1127, _e1126, (_e1126 < _e1127));
                                                        let _e1131 = select(_e1127, _e1126, (_e1126 > _e1127));
                                                        let _e1133 = select(_e1119, _e1118, (_e1118 < _e1119));
                                                        let _e1135 = select(_e1123, _e1122, (_e1122 < _e1123));
                                                        let _e1137 = select(_e1135, _e1133, (_e1133 > _e1135));
                                                        let _e1139 = select(_e1129, _e1137, (_e1137 > _e1129));
                                                        let _e1141 = select(_e1119, _e1118, (_e1118 > _e1119));
                                                        let _e1143 = select(_e1123, _e1122, (_e1122 > _e1123));
                                                        let _e1145 = select(_e1143, _e1141, (_e1141 < _e1143));
                                                        let _e1147 = select(_e1131, _e1145, (_e1145 < _e1131));
                                                        let _e1148 = -(_e1129);
                                                        let _e1154 = select(_e525, _e1139, (_e1139 > _e525));
                                                        if (_e1154 > (_e1147 + (select(_e1148, _e1131, (_e1131 > _e1148)) * 0.0000019073523f))) {
                                                            phi_3730_ = type_27();
                                                            phi_3731_ = true;
                                                        } else {
                                                            let _e1156 = (_e1154 > _e922.member_1);
                                                            if _e1156 {
                                                                phi_3729_ = type_27();
                                                            } else {
                                                                let _e1160 = (_e1018[1][0] - _e1018[0][0]);
                                                                let _e1161 = (_e1018[1][1] - _e1018[0][1]);
                                                                let _e1162 = (_e1018[1][2] - _e1018[0][2]);
                                                                let _e1163 = vec3<f32>(_e1160, _e1161, _e1162);
                                                                let _e1164 = (_e1018[2][0] - _e1018[1][0]);
                                                                let _e1165 = (_e1018[2][1] - _e1018[1][1]);
                                                                let _e1166 = (_e1018[2][2] - _e1018[1][2]);
                                                                let _e1167 = vec3<f32>(_e1164, _e1165, _e1166);
                                                                let _e1168 = (_e1018[0][0] - _e1018[2][0]);
                                                                let _e1169 = (_e1018[0][1] - _e1018[2][1]);
                                                                let _e1170 = (_e1018[0][2] - _e1018[2][2]);
                                                                let _e1171 = vec3<f32>(_e1168, _e1169, _e1170);
                                                                let _e1174 = bitcast<f32>((bitcast<u32>(_e1160) & 2147483647u));
                                                                let _e1177 = bitcast<f32>((bitcast<u32>(_e1161) & 2147483647u));
                                                                let _e1179 = select(_e1177, _e1174, (_e1174 > _e1177));
                                                                let _e1182 = bitcast<f32>((bitcast<u32>(_e1162) & 2147483647u));
                                                                let _e1184 = select(_e1182, _e1179, (_e1179 > _e1182));
                                                                let _e1187 = bitcast<f32>((bitcast<u32>(_e1164) & 2147483647u));
                                                                let _e1190 = bitcast<f32>((bitcast<u32>(_e1165) & 2147483647u));
                                                                let _e1192 = select(_e1190, _e1187, (_e1187 > _e1190));
                                                                let _e1195 = bitcast<f32>((bitcast<u32>(_e1166) & 2147483647u));
                                                                let _e1197 = select(_e1195, _e1192, (_e1192 > _e1195));
                                                                let _e1200 = bitcast<f32>((bitcast<u32>(_e1168) & 2147483647u));
                                                                let _e1203 = bitcast<f32>((bitcast<u32>(_e1169) & 2147483647u));
                                                                let _e1205 = select(_e1203, _e1200, (_e1200 > _e1203));
                                                                let _e1208 = bitcast<f32>((bitcast<u32>(_e1170) & 2147483647u));
                                                                let _e1210 = select(_e1208, _e1205, (_e1205 > _e1208));
                                                                let _e1212 = select(_e1197, _e1184, (_e1184 > _e1197));
                                                                let _e1214 = select(_e1210, _e1212, (_e1212 > _e1210));
                                                                if (_e1184 == _e1214) {
                                                                    phi_3640_ = _e1167;
                                                                    phi_3641_ = _e1171;
                                                                } else {
                                                                    let _e1217 = vec3((_e1197 == _e1214));
                                                                    phi_3640_ = select(_e1163, _e1171, _e1217);
                                                                    phi_3641_ = select(_e1167, _e1163, _e1217);
                                                                }
                                                                let _e1221 = phi_3640_;
                                                                let _e1223 = phi_3641_;
                                                                let _e1230 = ((_e1221.y * _e1223.z) - (_e1223.y * _e1221.z));
                                                                let _e1235 = ((_e1221.z * _e1223.x) - (_e1223.z * _e1221.x));
                                                                let _e1238 = ((_e1221.x * _e1223.y) - (_e1223.x * _e1221.y));
                                                                if (_e1080 >= _e1084) {
                                                                    phi_3672_ = select(true, false, (_e1080 >= _e1088));
                                                                } else {
                                                                    phi_3672_ = true;
                                                                }
                                                                let _e1243 = phi_3672_;
                                                                if _e1243 {
                                                                    phi_3681_ = select(vec3<f32>(_e1018[2][0], _e1018[2][1], _e1018[2][2]), vec3<f32>(_e1018[1][0], _e1018[1][1], _e1018[1][2]), vec3((_e1084 >= _e1088)));
                                                                } else {
                                                                    phi_3681_ = vec3<f32>(_e1018[0][0], _e1018[0][1], _e1018[0][2]);
                                                                }
                                                                let _e1248 = phi_3681_;
                                                                let _e1265 = ((((_e1230 * (_e1248.x - _e379)) + (_e1235 * (_e1248.y - _e416))) + (_e1238 * (_e1248.z - _e452))) / (((_e1230 * _e404) + (_e1235 * _e440)) + (_e1238 * _e476)));
                                                                let _e1267 = select(_e1147, _e1265, (_e1265 < _e1147));
                                                                let _e1269 = select(_e1139, _e1267, (_e1267 > _e1139));
                                                                if (_e1269 >= _e525) {
                                                                    let _e1271 = (_e1269 <= _e922.member_1);
                                                                    if _e1271 {
                                                                        let _e1272 = (1f / _e1090);
                                                                        phi_3721_ = type_27(_e1269, (_e1084 * _e1272), (_e1088 * _e1272), _e951);
                                                                    } else {
                                                                        phi_3721_ = type_27();
                                                                    }
                                                                    let _e1277 = phi_3721_;
                                                                    phi_3723_ = _e1277;
                                                                    phi_3724_ = select(true, false, _e1271);
                                                                } else {
                                                                    phi_3723_ = type_27();
                                                                    phi_3724_ = true;
                                                                }
                                                                let _e1280 = phi_3723_;
                                                                let _e1282 = phi_3724_;
                                                                if _e1282 {
                                                                    phi_3728_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3728_ = _e1280;
                                                                }
                                                                let _e1284 = phi_3728_;
                                                                phi_3729_ = _e1284;
                                                            }
                                                            let _e1286 = phi_3729_;
                                                            phi_3730_ = _e1286;
                                                            phi_3731_ = _e1156;
                                                        }
                                                        let _e1288 = phi_3730_;
                                                        let _e1290 = phi_3731_;
                                                        phi_3735_ = _e1288;
                                                        phi_3736_ = _e1290;
                                                    }
                                                    let _e1292 = phi_3735_;
                                                    let _e1294 = phi_3736_;
                                                    phi_3740_ = _e1292;
                                                    phi_3741_ = _e1294;
                                                } else {
                                                    phi_3740_ = type_27();
                                                    phi_3741_ = true;
                                                }
                                                let _e1296 = phi_3740_;
                                                let _e1298 = phi_3741_;
                                                if _e1298 {
                                                    phi_3745_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3745_ = _e1296;
                                                }
                                                let _e1300 = phi_3745_;
                                                if (_e1300.member_3 != 4294967295u) {
                                                    if (_e951 == _e153) {
                                                        phi_4074_ = false;
                                                    } else {
                                                        let _e1304 = (_e951 < arrayLength((&global_5.member)));
                                                        if _e1304 {
                                                            if _e1304 {
                                                            } else {
                                                                phi_5221_ = true;
                                                                break;
                                                            }
                                                            let _e1306 = global_5.member[_e951];
                                                            phi_3768_ = _e1306;
                                                        } else {
                                                            phi_3768_ = 4294967295u;
                                                        }
                                                        let _e1308 = phi_3768_;
                                                        let _e1309 = (_e1308 < arrayLength((&global_6.member)));
                                                        if _e1309 {
                                                            if _e1309 {
                                                            } else {
                                                                phi_5221_ = true;
                                                                break;
                                                            }
                                                            let _e1311 = global_6.member[_e1308];
                                                            phi_3782_ = _e1311;
                                                        } else {
                                                            phi_3782_ = 0i;
                                                        }
                                                        let _e1313 = phi_3782_;
                                                        let _e1314 = (_e1313 == 0i);
                                                        if _e1314 {
                                                            phi_4073_ = true;
                                                        } else {
                                                            if _e371 {
                                                                phi_3803_ = vec3<f32>(_e1018[0][0], _e1018[0][1], _e1018[0][2]);
                                                            } else {
                                                                if (_e347 == 1u) {
                                                                    phi_3802_ = vec3<f32>(_e1018[0][2], _e1018[0][0], _e1018[0][1]);
                                                                } else {
                                                                    phi_3802_ = vec3<f32>(_e1018[0][1], _e1018[0][2], _e1018[0][0]);
                                                                }
                                                                let _e1319 = phi_3802_;
                                                                phi_3803_ = _e1319;
                                                            }
                                                            let _e1322 = phi_3803_;
                                                            if _e371 {
                                                                phi_3820_ = vec3<f32>(_e1018[1][0], _e1018[1][1], _e1018[1][2]);
                                                            } else {
                                                                if (_e347 == 1u) {
                                                                    phi_3819_ = vec3<f32>(_e1018[1][2], _e1018[1][0], _e1018[1][1]);
                                                                } else {
                                                                    phi_3819_ = vec3<f32>(_e1018[1][1], _e1018[1][2], _e1018[1][0]);
                                                                }
                                                                let _e1327 = phi_3819_;
                                                                phi_3820_ = _e1327;
                                                            }
                                                            let _e1330 = phi_3820_;
                                                            if _e371 {
                                                                phi_3837_ = vec3<f32>(_e1018[2][0], _e1018[2][1], _e1018[2][2]);
                                                            } else {
                                                                if (_e347 == 1u) {
                                                                    phi_3836_ = vec3<f32>(_e1018[2][2], _e1018[2][0], _e1018[2][1]);
                                                                } else {
                                                                    phi_3836_ = vec3<f32>(_e1018[2][1], _e1018[2][2], _e1018[2][0]);
                                                                }
                                                                let _e1335 = phi_3836_;
                                                                phi_3837_ = _e1335;
                                                            }
                                                            let _e1338 = phi_3837_;
                                                            let _e1341 = (_e1330.x - _e1322.x);
                                                            let _e1344 = (_e1330.y - _e1322.y);
                                                            let _e1347 = (_e1330.z - _e1322.z);
                                                            let _e1349 = (_e1338.x - _e1322.x);
                                                            let _e1351 = (_e1338.y - _e1322.y);
                                                            let _e1353 = (_e1338.z - _e1322.z);
                                                            if (_e225.member_1 == 1u) {
                                                                phi_3873_ = (vec3<f32>(_e225.member[0], _e225.member[1], _e225.member[2]) - _e1322);
                                                            } else {
                                                                phi_3873_ = vec3<f32>(_e225.member[0], _e225.member[1], _e225.member[2]);
                                                            }
                                                            let _e1368 = phi_3873_;
                                                            let _e1374 = bitcast<f32>((bitcast<u32>((_e1341 * _e1351)) ^ _e225.member_3[0]));
                                                            let _e1378 = bitcast<f32>((bitcast<u32>((_e1344 * _e1349)) ^ _e225.member_3[0]));
                                                            let _e1382 = bitcast<f32>((bitcast<u32>((_e1344 * _e1353)) ^ _e225.member_3[0]));
                                                            let _e1386 = bitcast<f32>((bitcast<u32>((_e1347 * _e1351)) ^ _e225.member_3[0]));
                                                            let _e1390 = bitcast<f32>((bitcast<u32>((_e1347 * _e1349)) ^ _e225.member_3[0]));
                                                            let _e1394 = bitcast<f32>((bitcast<u32>((_e1341 * _e1353)) ^ _e225.member_3[0]));
                                                            let _e1395 = (_e1382 - _e1386);
                                                            let _e1396 = (_e1390 - _e1394);
                                                            let _e1397 = (_e1374 - _e1378);
                                                            let _e1421 = (bitcast<f32>((bitcast<u32>(_e1382) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1386) & 2147483647u)));
                                                            let _e1428 = (bitcast<f32>((bitcast<u32>(_e1390) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1394) & 2147483647u)));
                                                            let _e1435 = (bitcast<f32>((bitcast<u32>(_e1374) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1378) & 2147483647u)));
                                                            if (_e225.member_2 == 0f) {
                                                                phi_4055_ = 0f;
                                                            } else {
                                                                let _e1465 = bitcast<f32>((bitcast<u32>(_e1395) & 2147483647u));
                                                                let _e1468 = bitcast<f32>((bitcast<u32>(_e1396) & 2147483647u));
                                                                let _e1471 = bitcast<f32>((bitcast<u32>(_e1397) & 2147483647u));
                                                                let _e1473 = select(_e1471, _e1468, (_e1468 > _e1471));
                                                                let _e1477 = select(_e1471, _e1468, (_e1468 < _e1471));
                                                                let _e1481 = select(_e1468, _e1465, (_e1465 < _e1468));
                                                                let _e1483 = select(_e1468, _e1465, (_e1465 > _e1468));
                                                                let _e1485 = select(_e1471, _e1483, (_e1483 < _e1471));
                                                                phi_4055_ = bitcast<f32>((bitcast<u32>((_e225.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1473, _e1465, (_e1465 > _e1473)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1485, _e1481, (_e1481 > _e1485)))) ^ _e225.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1477, _e1465, (_e1465 < _e1477)))) ^ _e225.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1421 + _e1428) + _e1435))) ^ _e225.member_3[0]))) * 1.0000005f)) ^ _e225.member_3[0])))) ^ _e225.member_3[0]));
                                                            }
                                                            let _e1512 = phi_4055_;
                                                            phi_4073_ = (_e1314 || !(((((bitcast<f32>((bitcast<u32>((_e1368.x * _e1395)) ^ _e225.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1368.y * _e1396)) ^ _e225.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1368.z * _e1397)) ^ _e225.member_3[0]))) * f32(-(_e1313))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1368.x) & 2147483647u)) * _e1421)) ^ _e225.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1368.y) & 2147483647u)) * _e1428)) ^ _e225.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1368.z) & 2147483647u)) * _e1435)) ^ _e225.member_3[0]))))) ^ _e225.member_3[0])) + _e1512) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1526 = phi_4073_;
                                                        phi_4074_ = _e1526;
                                                    }
                                                    let _e1528 = phi_4074_;
                                                    if _e1528 {
                                                        if (_e1300.member < _e922.member.member) {
                                                            phi_4094_ = true;
                                                        } else {
                                                            if (_e1300.member == _e922.member.member) {
                                                                phi_4093_ = (_e1300.member_3 < _e922.member.member_3);
                                                            } else {
                                                                phi_4093_ = false;
                                                            }
                                                            let _e1538 = phi_4093_;
                                                            phi_4094_ = _e1538;
                                                        }
                                                        let _e1540 = phi_4094_;
                                                        if _e1540 {
                                                            phi_4100_ = type_42(_e1300, _e1300.member);
                                                        } else {
                                                            phi_4100_ = _e922;
                                                        }
                                                        let _e1543 = phi_4100_;
                                                        phi_4101_ = _e1543;
                                                    } else {
                                                        phi_4101_ = _e922;
                                                    }
                                                    let _e1545 = phi_4101_;
                                                    phi_4102_ = _e1545;
                                                } else {
                                                    phi_4102_ = _e922;
                                                }
                                                let _e1547 = phi_4102_;
                                                phi_3034_ = _e1547;
                                            } else {
                                                phi_3034_ = type_42();
                                            }
                                            let _e1549 = phi_3034_;
                                            continue;
                                            continuing {
                                                phi_3033_ = _e1549;
                                                phi_3036_ = _e937;
                                                phi_5221_ = _e557;
                                                break if !(_e943);
                                            }
                                        }
                                        let _e1552 = phi_5221_;
                                        phi_5304_ = _e1552;
                                        if _e1552 {
                                            break;
                                        }
                                        phi_5308_ = _e1552;
                                        let _e1768 = local_13;
                                        phi_4946_ = _e1768;
                                        phi_4947_ = _e596;
                                        phi_4948_ = false;
                                        phi_4949_ = _e600;
                                    } else {
                                        local_1 = array<f32, 3>(_e596.member.member[0], _e596.member.member[1], _e596.member.member[2]);
                                        local = array<f32, 3>(_e596.member.member_1[0], _e596.member.member_1[1], _e596.member.member_1[2]);
                                        let _e620 = (_e596.member_1 < _e94);
                                        if _e620 {
                                            if _e620 {
                                            } else {
                                                phi_5304_ = true;
                                                break;
                                            }
                                            let _e622 = global_10.member[_e596.member_1];
                                            phi_4136_ = _e622;
                                        } else {
                                            phi_4136_ = type_53(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e624 = phi_4136_;
                                        let _e626 = array<u32, 3>(_e347, _e346, _e348);
                                        local_9 = _e626;
                                        local_5 = array<f32, 3>(0f, 0f, 0f);
                                        local_4 = array<f32, 3>(0f, 0f, 0f);
                                        phi_4145_ = type_8(0u, 3u);
                                        loop {
                                            let _e628 = phi_4145_;
                                            if (_e628.member < _e628.member_1) {
                                                phi_4146_ = type_8((_e628.member + 1u), _e628.member_1);
                                                phi_4169_ = type_8(1u, _e628.member);
                                            } else {
                                                phi_4146_ = _e628;
                                                phi_4169_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e641 = phi_4146_;
                                            let _e643 = phi_4169_;
                                            let _e647 = (bitcast<i32>(_e643.member) != 0i);
                                            if _e647 {
                                                let _e648 = (_e643.member_1 < 3u);
                                                if _e648 {
                                                } else {
                                                    phi_5149_ = true;
                                                    break;
                                                }
                                                let _e650 = local_9[_e643.member_1];
                                                if _e648 {
                                                } else {
                                                    phi_5149_ = true;
                                                    break;
                                                }
                                                let _e652 = local_1[_e643.member_1];
                                                if _e648 {
                                                } else {
                                                    phi_5149_ = true;
                                                    break;
                                                }
                                                let _e654 = local[_e643.member_1];
                                                let _e657 = ((10u * _e650) & 31u);
                                                let _e660 = ((_e624.member[0] >> bitcast<u32>(_e657)) & 1023u);
                                                let _e665 = bitcast<f32>((bitcast<u32>(((_e654 - _e652) * 0.0009775171f)) ^ _e136));
                                                let _e671 = (_e652 + bitcast<f32>((bitcast<u32>((f32(_e660) * _e665)) ^ _e136)));
                                                if _e648 {
                                                } else {
                                                    phi_5149_ = true;
                                                    break;
                                                }
                                                local_5[_e643.member_1] = select(select(_e654, _e671, (_e671 < _e654)), _e654, (_e660 == 1023u));
                                                let _e680 = ((_e624.member[1] >> bitcast<u32>(_e657)) & 1023u);
                                                let _e686 = (_e652 + bitcast<f32>((bitcast<u32>((f32(_e680) * _e665)) ^ _e136)));
                                                if _e648 {
                                                } else {
                                                    phi_5149_ = true;
                                                    break;
                                                }
                                                local_4[_e643.member_1] = select(select(_e654, _e686, (_e686 < _e654)), _e654, (_e680 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_4145_ = _e641;
                                                phi_5149_ = _e557;
                                                break if !(_e647);
                                            }
                                        }
                                        let _e694 = phi_5149_;
                                        phi_5304_ = _e694;
                                        if _e694 {
                                            break;
                                        }
                                        let _e695 = local_4;
                                        let _e696 = local_5;
                                        local_8 = _e626;
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        local_6 = array<f32, 3>(0f, 0f, 0f);
                                        phi_4299_ = type_8(0u, 3u);
                                        loop {
                                            let _e705 = phi_4299_;
                                            if (_e705.member < _e705.member_1) {
                                                phi_4300_ = type_8((_e705.member + 1u), _e705.member_1);
                                                phi_4323_ = type_8(1u, _e705.member);
                                            } else {
                                                phi_4300_ = _e705;
                                                phi_4323_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e718 = phi_4300_;
                                            let _e720 = phi_4323_;
                                            let _e724 = (bitcast<i32>(_e720.member) != 0i);
                                            if _e724 {
                                                let _e725 = (_e720.member_1 < 3u);
                                                if _e725 {
                                                } else {
                                                    phi_5213_ = true;
                                                    break;
                                                }
                                                let _e727 = local_8[_e720.member_1];
                                                if _e725 {
                                                } else {
                                                    phi_5213_ = true;
                                                    break;
                                                }
                                                let _e729 = local_1[_e720.member_1];
                                                if _e725 {
                                                } else {
                                                    phi_5213_ = true;
                                                    break;
                                                }
                                                let _e731 = local[_e720.member_1];
                                                let _e734 = ((10u * _e727) & 31u);
                                                let _e737 = ((_e624.member_1[0] >> bitcast<u32>(_e734)) & 1023u);
                                                let _e742 = bitcast<f32>((bitcast<u32>(((_e731 - _e729) * 0.0009775171f)) ^ _e136));
                                                let _e748 = (_e729 + bitcast<f32>((bitcast<u32>((f32(_e737) * _e742)) ^ _e136)));
                                                if _e725 {
                                                } else {
                                                    phi_5213_ = true;
                                                    break;
                                                }
                                                local_7[_e720.member_1] = select(select(_e731, _e748, (_e748 < _e731)), _e731, (_e737 == 1023u));
                                                let _e757 = ((_e624.member_1[1] >> bitcast<u32>(_e734)) & 1023u);
                                                let _e763 = (_e729 + bitcast<f32>((bitcast<u32>((f32(_e757) * _e742)) ^ _e136)));
                                                if _e725 {
                                                } else {
                                                    phi_5213_ = true;
                                                    break;
                                                }
                                                local_6[_e720.member_1] = select(select(_e731, _e763, (_e763 < _e731)), _e731, (_e757 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_4299_ = _e718;
                                                phi_5213_ = _e694;
                                                break if !(_e724);
                                            }
                                        }
                                        let _e771 = phi_5213_;
                                        phi_5304_ = _e771;
                                        if _e771 {
                                            break;
                                        }
                                        let _e772 = local_6;
                                        let _e773 = local_7;
                                        let _e784 = type_61(type_58(array<f32, 3>(_e696[0], _e696[1], _e696[2]), array<f32, 3>(_e695[0], _e695[1], _e695[2])), _e624.member_2);
                                        let _e789 = type_61(type_58(array<f32, 3>(_e773[0], _e773[1], _e773[2]), array<f32, 3>(_e772[0], _e772[1], _e772[2])), _e624.member_3);
                                        let _e795 = ((_e696[0] - _e402) * _e407);
                                        let _e796 = ((_e773[0] - _e402) * _e407);
                                        let _e797 = ((_e695[0] - _e403) * _e407);
                                        let _e798 = ((_e772[0] - _e403) * _e407);
                                        let _e803 = ((_e696[1] - _e438) * _e443);
                                        let _e804 = ((_e773[1] - _e438) * _e443);
                                        let _e805 = ((_e695[1] - _e439) * _e443);
                                        let _e806 = ((_e772[1] - _e439) * _e443);
                                        let _e811 = ((_e696[2] - _e474) * _e479);
                                        let _e812 = ((_e773[2] - _e474) * _e479);
                                        let _e813 = ((_e695[2] - _e475) * _e479);
                                        let _e814 = ((_e772[2] - _e475) * _e479);
                                        let _e816 = select(_e813, _e811, (_e811 < _e813));
                                        let _e818 = select(_e814, _e812, (_e812 < _e814));
                                        let _e820 = select(_e813, _e811, (_e811 > _e813));
                                        let _e822 = select(_e814, _e812, (_e812 > _e814));
                                        let _e824 = select(_e797, _e795, (_e795 < _e797));
                                        let _e826 = select(_e798, _e796, (_e796 < _e798));
                                        let _e828 = select(_e805, _e803, (_e803 < _e805));
                                        let _e830 = select(_e806, _e804, (_e804 < _e806));
                                        let _e832 = select(_e828, _e824, (_e824 > _e828));
                                        let _e834 = select(_e830, _e826, (_e826 > _e830));
                                        let _e836 = select(_e816, _e832, (_e832 > _e816));
                                        let _e838 = select(_e818, _e834, (_e834 > _e818));
                                        let _e840 = select(_e797, _e795, (_e795 > _e797));
                                        let _e842 = select(_e798, _e796, (_e796 > _e798));
                                        let _e844 = select(_e805, _e803, (_e803 > _e805));
                                        let _e846 = select(_e806, _e804, (_e804 > _e806));
                                        let _e848 = select(_e844, _e840, (_e840 < _e844));
                                        let _e850 = select(_e846, _e842, (_e842 < _e846));
                                        let _e855 = -(_e816);
                                        let _e856 = -(_e818);
                                        let _e863 = (select(_e820, _e848, (_e848 < _e820)) + (select(_e855, _e820, (_e820 > _e855)) * 0.0000019073523f));
                                        let _e864 = (select(_e822, _e850, (_e850 < _e822)) + (select(_e856, _e822, (_e822 > _e856)) * 0.0000019073523f));
                                        let _e866 = select(_e525, _e836, (_e836 > _e525));
                                        let _e868 = select(_e525, _e838, (_e838 > _e525));
                                        let _e873 = (_e866 <= select(_e559.member_1, _e863, (_e863 < _e559.member_1)));
                                        let _e874 = (_e868 <= select(_e559.member_1, _e864, (_e864 < _e559.member_1)));
                                        let _e875 = (_e866 <= _e868);
                                        if _e873 {
                                            if _e874 {
                                                if _e875 {
                                                    phi_4886_ = _e789;
                                                } else {
                                                    phi_4886_ = _e784;
                                                }
                                                let _e877 = phi_4886_;
                                                let _e878 = (_e600 % 128u);
                                                let _e879 = (_e878 < 128u);
                                                if _e879 {
                                                } else {
                                                    phi_5304_ = true;
                                                    break;
                                                }
                                                local_3[_e878] = type_61(type_58(array<f32, 3>(_e877.member.member[0], _e877.member.member[1], _e877.member.member[2]), array<f32, 3>(_e877.member.member_1[0], _e877.member.member_1[1], _e877.member.member_1[2])), _e877.member_1);
                                                if _e879 {
                                                } else {
                                                    phi_5304_ = true;
                                                    break;
                                                }
                                                local_2[_e878] = select(_e868, _e866, (_e866 > _e868));
                                                if _e875 {
                                                    phi_4925_ = _e784;
                                                } else {
                                                    phi_4925_ = _e789;
                                                }
                                                let _e900 = phi_4925_;
                                                phi_4926_ = _e900;
                                                phi_4927_ = (_e600 + 1u);
                                            } else {
                                                phi_4926_ = type_61();
                                                phi_4927_ = u32();
                                            }
                                            let _e902 = phi_4926_;
                                            let _e904 = phi_4927_;
                                            phi_4929_ = _e902;
                                            phi_4930_ = _e904;
                                            phi_4931_ = select(true, false, _e874);
                                        } else {
                                            phi_4929_ = type_61();
                                            phi_4930_ = u32();
                                            phi_4931_ = true;
                                        }
                                        let _e907 = phi_4929_;
                                        let _e909 = phi_4930_;
                                        let _e911 = phi_4931_;
                                        if _e911 {
                                            if _e873 {
                                                phi_4938_ = _e784;
                                            } else {
                                                phi_4938_ = _e789;
                                            }
                                            let _e913 = phi_4938_;
                                            phi_4943_ = _e913;
                                            phi_4944_ = select(_e874, true, _e873);
                                        } else {
                                            phi_4943_ = _e907;
                                            phi_4944_ = _e598;
                                        }
                                        let _e916 = phi_4943_;
                                        let _e918 = phi_4944_;
                                        phi_5308_ = _e771;
                                        phi_4946_ = _e559;
                                        phi_4947_ = _e916;
                                        phi_4948_ = _e918;
                                        phi_4949_ = select(_e909, _e600, _e911);
                                    }
                                    let _e1554 = phi_5308_;
                                    let _e1556 = phi_4946_;
                                    let _e1558 = phi_4947_;
                                    let _e1560 = phi_4948_;
                                    let _e1562 = phi_4949_;
                                    phi_5307_ = _e1554;
                                    phi_4950_ = _e1556;
                                    phi_4951_ = _e1558;
                                    phi_4952_ = (_e563 - 1u);
                                    phi_4953_ = _e1560;
                                    phi_4954_ = _e1562;
                                } else {
                                    phi_5307_ = _e557;
                                    phi_4950_ = _e559;
                                    phi_4951_ = _e596;
                                    phi_4952_ = _e563;
                                    phi_4953_ = _e598;
                                    phi_4954_ = _e600;
                                }
                                let _e1564 = phi_5307_;
                                let _e1566 = phi_4950_;
                                let _e1568 = phi_4951_;
                                let _e1570 = phi_4952_;
                                let _e1572 = phi_4953_;
                                let _e1574 = phi_4954_;
                                phi_5306_ = _e1564;
                                phi_4955_ = _e1566;
                                phi_4956_ = _e1568;
                                phi_4957_ = _e1570;
                                phi_4958_ = _e1572;
                                phi_4959_ = _e1574;
                            } else {
                                phi_5306_ = _e557;
                                phi_4955_ = type_42();
                                phi_4956_ = type_61();
                                phi_4957_ = u32();
                                phi_4958_ = bool();
                                phi_4959_ = u32();
                            }
                            let _e1576 = phi_5306_;
                            let _e1578 = phi_4955_;
                            let _e1580 = phi_4956_;
                            let _e1582 = phi_4957_;
                            let _e1584 = phi_4958_;
                            let _e1586 = phi_4959_;
                            phi_5305_ = _e1576;
                            phi_2949_ = _e1578;
                            phi_2952_ = _e1580;
                            phi_2954_ = _e1582;
                            phi_2956_ = _e1584;
                            phi_2958_ = _e1586;
                            phi_4960_ = _e571;
                        } else {
                            phi_5305_ = _e557;
                            phi_2949_ = type_42();
                            phi_2952_ = type_61();
                            phi_2954_ = u32();
                            phi_2956_ = bool();
                            phi_2958_ = u32();
                            phi_4960_ = false;
                        }
                        let _e1588 = phi_5305_;
                        let _e1590 = phi_2949_;
                        let _e1592 = phi_2952_;
                        let _e1594 = phi_2954_;
                        let _e1596 = phi_2956_;
                        let _e1598 = phi_2958_;
                        let _e1600 = phi_4960_;
                        continue;
                        continuing {
                            phi_5156_ = _e1588;
                            phi_2948_ = _e1590;
                            phi_2951_ = _e1592;
                            phi_2953_ = _e1594;
                            phi_2955_ = _e1596;
                            phi_2957_ = _e1598;
                            phi_5304_ = _e1588;
                            break if !(_e1600);
                        }
                    }
                    let _e1603 = phi_5304_;
                    if _e1603 {
                        break;
                    }
                    let _e1605 = local_12;
                    if (_e1605.member.member_3 != 4294967295u) {
                        let _e1610 = (_e349 / 3i);
                        let _e1617 = bitcast<f32>((bitcast<u32>((_e1610 + 127i)) << bitcast<u32>(23i)));
                        let _e1625 = (((_e1605.member.member * _e1617) * _e1617) * bitcast<f32>((bitcast<u32>(((_e349 - (2i * _e1610)) + 127i)) << bitcast<u32>(23i))));
                        let _e1627 = select(340282350000000000000000000000000000000f, _e1625, (_e1625 < 340282350000000000000000000000000000000f));
                        phi_5012_ = type_27(select(-340282350000000000000000000000000000000f, _e1627, (_e1627 > -340282350000000000000000000000000000000f)), _e1605.member.member_1, _e1605.member.member_2, _e1605.member.member_3);
                    } else {
                        phi_5012_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1634 = phi_5012_;
                    if _e226 {
                    } else {
                        break;
                    }
                    global_8.member[_e140] = _e1634;
                    if _e147 {
                    } else {
                        break;
                    }
                    let _e1638 = select(0u, 1u, (_e293 <= _e303));
                    if (_e1638 > 0u) {
                        let _e1640 = (1u < _e108);
                        if _e1640 {
                            if (0u < _e108) {
                            } else {
                                break;
                            }
                            let _e1644 = atomicAdd((&global_9.member[0u]), _e1638);
                            if ((_e1644 + _e1638) < _e1644) {
                                if _e1640 {
                                } else {
                                    break;
                                }
                                let _e1649 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1652 = select(0u, 1u, (_e1634.member_3 != 4294967295u));
                    if (_e1652 > 0u) {
                        let _e1654 = (3u < _e108);
                        if _e1654 {
                            if (2u < _e108) {
                            } else {
                                break;
                            }
                            let _e1658 = atomicAdd((&global_9.member[2u]), _e1652);
                            if ((_e1658 + _e1652) < _e1658) {
                                if _e1654 {
                                } else {
                                    break;
                                }
                                let _e1663 = atomicAdd((&global_9.member[3u]), 1u);
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
