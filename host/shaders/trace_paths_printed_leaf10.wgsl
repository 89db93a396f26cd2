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

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_35 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_37 {
    member: type_22,
    member_1: f32,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_43 {
    member: array<i32>,
}

struct type_47 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_49 {
    member: array<type_47>,
}

struct type_52 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_55 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_57 {
    member: array<type_55>,
}

struct type_61 {
    member: type_52,
    member_1: u32,
}

struct type_70 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_40;
@group(0) @binding(2) 
var<uniform> global_3: type_40;
@group(0) @binding(5) 
var<storage> global_4: type_4;
@group(0) @binding(6) 
var<storage> global_5: type_43;
@group(0) @binding(7) 
var<storage> global_6: type_29;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_24;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_70;
@group(0) @binding(3) 
var<storage> global_9: type_49;
@group(0) @binding(4) 
var<storage> global_10: type_57;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;
    var local_3: array<f32, 3>;
    var local_4: array<f32, 128>;
    var local_5: array<type_61, 128>;
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
    var phi_287_: u32;
    var phi_331_: i32;
    var phi_355_: type_35;
    var phi_461_: i32;
    var phi_462_: i32;
    var phi_472_: bool;
    var phi_482_: u32;
    var phi_483_: u32;
    var phi_485_: bool;
    var phi_490_: u32;
    var phi_523_: i32;
    var phi_541_: f32;
    var phi_547_: f32;
    var phi_558_: f32;
    var phi_564_: f32;
    var phi_587_: f32;
    var phi_598_: f32;
    var phi_607_: f32;
    var phi_613_: f32;
    var phi_624_: f32;
    var phi_630_: f32;
    var phi_653_: f32;
    var phi_664_: f32;
    var phi_673_: f32;
    var phi_679_: f32;
    var phi_690_: f32;
    var phi_696_: f32;
    var phi_719_: f32;
    var phi_730_: f32;
    var phi_830_: f32;
    var phi_831_: f32;
    var phi_5299_: bool;
    var phi_2959_: type_37;
    var phi_2962_: type_61;
    var phi_2964_: u32;
    var phi_2966_: bool;
    var phi_2968_: u32;
    var phi_2979_: bool;
    var phi_3024_: type_61;
    var phi_3025_: bool;
    var phi_3026_: u32;
    var phi_4265_: type_47;
    var phi_4274_: type_8;
    var phi_4275_: type_8;
    var phi_4298_: type_8;
    var phi_5292_: bool;
    var phi_4428_: type_8;
    var phi_4429_: type_8;
    var phi_4452_: type_8;
    var phi_5356_: bool;
    var phi_5015_: type_61;
    var phi_5054_: type_61;
    var phi_5055_: type_61;
    var phi_5056_: u32;
    var phi_5058_: type_61;
    var phi_5059_: u32;
    var phi_5060_: bool;
    var phi_5067_: type_61;
    var phi_5072_: type_61;
    var phi_5073_: bool;
    var phi_5373_: bool;
    var phi_3045_: type_37;
    var phi_3048_: type_8;
    var phi_3049_: type_8;
    var phi_3071_: type_8;
    var phi_3113_: u32;
    var phi_3137_: type_55;
    var phi_5369_: bool;
    var phi_3148_: type_8;
    var phi_3149_: type_8;
    var phi_3172_: type_8;
    var phi_3182_: type_8;
    var phi_3183_: type_8;
    var phi_3206_: type_8;
    var phi_5364_: bool;
    var phi_5377_: bool;
    var phi_5376_: bool;
    var phi_3769_: vec3<f32>;
    var phi_3770_: vec3<f32>;
    var phi_3801_: bool;
    var phi_3810_: vec3<f32>;
    var phi_3850_: type_22;
    var phi_3852_: type_22;
    var phi_3853_: bool;
    var phi_3857_: type_22;
    var phi_3858_: type_22;
    var phi_3859_: type_22;
    var phi_3860_: bool;
    var phi_3864_: type_22;
    var phi_3865_: bool;
    var phi_3869_: type_22;
    var phi_3870_: bool;
    var phi_3874_: type_22;
    var phi_3897_: u32;
    var phi_3911_: i32;
    var phi_3931_: vec3<f32>;
    var phi_3932_: vec3<f32>;
    var phi_3948_: vec3<f32>;
    var phi_3949_: vec3<f32>;
    var phi_3965_: vec3<f32>;
    var phi_3966_: vec3<f32>;
    var phi_4002_: vec3<f32>;
    var phi_4184_: f32;
    var phi_4202_: bool;
    var phi_4203_: bool;
    var phi_4222_: bool;
    var phi_4223_: bool;
    var phi_4229_: type_37;
    var phi_4230_: type_37;
    var phi_4231_: type_37;
    var phi_5379_: bool;
    var phi_3046_: type_37;
    var phi_5378_: bool;
    var phi_5461_: bool;
    var phi_5075_: type_37;
    var phi_5076_: type_61;
    var phi_5077_: bool;
    var phi_5078_: u32;
    var phi_5460_: bool;
    var phi_5079_: type_37;
    var phi_5080_: type_61;
    var phi_5081_: u32;
    var phi_5082_: bool;
    var phi_5083_: u32;
    var phi_5459_: bool;
    var phi_5084_: type_37;
    var phi_5085_: type_61;
    var phi_5086_: u32;
    var phi_5087_: bool;
    var phi_5088_: u32;
    var phi_5458_: bool;
    var phi_2960_: type_37;
    var phi_2963_: type_61;
    var phi_2965_: u32;
    var phi_2967_: bool;
    var phi_2969_: u32;
    var phi_5089_: bool;
    var phi_5457_: bool;
    var local_17: type_37;
    var phi_5141_: type_22;
    var local_18: type_37;

    switch bitcast<i32>(0u) {
        default: {
            let _e94 = global;
            let _e97 = arrayLength((&global_9.member));
            let _e112 = arrayLength((&global_8.member));
            let _e116 = global_3.member[0u][0u];
            let _e120 = global_3.member[0u][1u];
            let _e124 = global_3.member[0u][2u];
            let _e128 = global_3.member[1u][0u];
            let _e132 = global_3.member[1u][1u];
            let _e136 = global_3.member[1u][2u];
            let _e140 = global_3.member[1u][3u];
            let _e144 = (_e94.x + (_e94.y * 2097152u));
            let _e151 = (_e144 < arrayLength((&global_6.member)));
            if _e151 {
                if _e151 {
                } else {
                    break;
                }
                let _e155 = global_6.member[_e144].member_2;
                phi_287_ = _e155;
            } else {
                phi_287_ = 4294967295u;
            }
            let _e157 = phi_287_;
            let _e160 = global_1.member[0u];
            let _e164 = global_2.member[0u][0u];
            let _e168 = global_2.member[0u][1u];
            let _e172 = global_2.member[0u][2u];
            let _e176 = global_2.member[0u][3u];
            let _e180 = global_2.member[1u][0u];
            let _e184 = global_2.member[1u][1u];
            let _e188 = global_2.member[1u][2u];
            let _e192 = global_2.member[1u][3u];
            let _e193 = bitcast<f32>(_e164);
            let _e194 = bitcast<f32>(_e168);
            let _e195 = bitcast<f32>(_e172);
            let _e197 = bitcast<f32>(_e180);
            let _e198 = array<u32, 3>(_e184, _e188, _e192);
            let _e200 = bitcast<i32>(_e160);
            if (_e200 < -126i) {
                phi_331_ = -126i;
            } else {
                phi_331_ = select(_e200, 127i, (_e200 > 127i));
            }
            let _e205 = phi_331_;
            let _e210 = bitcast<f32>((bitcast<u32>((_e205 + 127i)) << bitcast<u32>(23i)));
            let _e216 = bitcast<f32>((bitcast<u32>(((_e200 - _e205) + 127i)) << bitcast<u32>(23i)));
            if (_e176 == 0u) {
                phi_355_ = type_35(array<f32, 3>(_e193, _e194, _e195), _e176, _e197, _e198);
            } else {
                phi_355_ = type_35(array<f32, 3>(((_e193 * _e210) * _e216), ((_e194 * _e210) * _e216), ((_e195 * _e210) * _e216)), _e176, ((_e197 * _e210) * _e216), _e198);
            }
            let _e229 = phi_355_;
            if _e151 {
                let _e230 = (_e144 < arrayLength((&global_7.member)));
                if _e230 {
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e240 = global_6.member[_e144].member.member_2[0u];
                    let _e242 = (bitcast<u32>(_e240) & 2147483647u);
                    let _e248 = global_6.member[_e144].member.member_2[1u];
                    let _e250 = (bitcast<u32>(_e248) & 2147483647u);
                    let _e256 = global_6.member[_e144].member.member_2[2u];
                    let _e258 = (bitcast<u32>(_e256) & 2147483647u);
                    let _e264 = global_6.member[_e144].member.member[0u];
                    let _e266 = (bitcast<u32>(_e264) & 2147483647u);
                    let _e272 = global_6.member[_e144].member.member[1u];
                    let _e274 = (bitcast<u32>(_e272) & 2147483647u);
                    let _e280 = global_6.member[_e144].member.member[2u];
                    let _e282 = (bitcast<u32>(_e280) & 2147483647u);
                    let _e284 = select(_e250, _e242, (_e250 < _e242));
                    let _e286 = select(_e258, _e284, (_e258 < _e284));
                    let _e288 = select(_e266, _e286, (_e266 < _e286));
                    let _e290 = select(_e274, _e288, (_e274 < _e288));
                    let _e292 = select(_e282, _e290, (_e282 < _e290));
                    let _e297 = global_6.member[_e144].member.member_1;
                    let _e299 = (bitcast<u32>(_e297) & 2147483647u);
                    let _e307 = global_6.member[_e144].member.member_3;
                    let _e313 = (((select(_e299, _e292, (_e299 < _e292)) < 2139095040u) && ((bitcast<u32>(_e307) & 2147483647u) <= 2139095040u)) && (_e286 > 0u));
                    if _e313 {
                        let _e316 = (bitcast<u32>(bitcast<f32>(_e286)) & 2147483647u);
                        if (_e316 >= 8388608u) {
                            phi_461_ = (bitcast<i32>((_e316 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_461_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e316)), 32u, (_e316 == 0u))));
                        }
                        let _e330 = phi_461_;
                        phi_462_ = _e330;
                    } else {
                        phi_462_ = 0i;
                    }
                    let _e332 = phi_462_;
                    let _e333 = (_e242 == _e286);
                    if _e333 {
                        phi_472_ = true;
                    } else {
                        phi_472_ = (_e250 == _e286);
                    }
                    let _e336 = phi_472_;
                    let _e337 = select(1u, 0u, _e333);
                    if _e336 {
                        let _e338 = (_e337 + 1u);
                        phi_482_ = _e338;
                        phi_483_ = _e338;
                        phi_485_ = select(true, false, (_e338 == 2u));
                    } else {
                        phi_482_ = u32();
                        phi_483_ = 0u;
                        phi_485_ = true;
                    }
                    let _e342 = phi_482_;
                    let _e344 = phi_483_;
                    let _e346 = phi_485_;
                    if _e346 {
                        phi_490_ = (_e344 + 1u);
                    } else {
                        phi_490_ = 0u;
                    }
                    let _e350 = phi_490_;
                    let _e351 = select(_e342, _e344, _e346);
                    let _e352 = select(_e337, select(2u, _e337, _e336), _e346);
                    let _e353 = -(_e332);
                    if (_e353 < -126i) {
                        phi_523_ = -126i;
                    } else {
                        phi_523_ = select(_e353, 127i, (_e353 > 127i));
                    }
                    let _e358 = phi_523_;
                    let _e363 = bitcast<f32>((bitcast<u32>((_e358 + 127i)) << bitcast<u32>(23i)));
                    let _e369 = bitcast<f32>((bitcast<u32>(((_e353 - _e358) + 127i)) << bitcast<u32>(23i)));
                    let _e374 = global_6.member[_e144].member.member;
                    let _e375 = (_e351 == 0u);
                    if _e375 {
                        phi_541_ = _e374[0];
                    } else {
                        phi_541_ = _e374[1];
                    }
                    let _e379 = phi_541_;
                    let _e380 = (_e351 == 2u);
                    if _e380 {
                        phi_547_ = _e374[2];
                    } else {
                        phi_547_ = _e379;
                    }
                    let _e383 = phi_547_;
                    let _e384 = global_6.member[_e144].member.member_2;
                    if _e375 {
                        phi_558_ = _e384[0];
                    } else {
                        phi_558_ = _e384[1];
                    }
                    let _e388 = phi_558_;
                    if _e380 {
                        phi_564_ = _e384[2];
                    } else {
                        phi_564_ = _e388;
                    }
                    let _e391 = phi_564_;
                    let _e393 = ((_e391 * _e363) * _e369);
                    let _e397 = (bitcast<f32>((bitcast<u32>(_e393) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e397 {
                        let _e401 = (bitcast<f32>((bitcast<u32>(_e383) & 2147483647u)) * 0.00000011920929f);
                        phi_587_ = select(0.00000000000011368684f, _e401, (_e401 > 0.00000000000011368684f));
                    } else {
                        phi_587_ = 0f;
                    }
                    let _e405 = phi_587_;
                    let _e406 = (_e383 + _e405);
                    let _e407 = (_e383 - _e405);
                    let _e408 = select(_e393, 0f, _e397);
                    if _e397 {
                        phi_598_ = 38685626000000000000000000f;
                    } else {
                        phi_598_ = (1f / _e393);
                    }
                    let _e411 = phi_598_;
                    let _e412 = (_e350 == 0u);
                    if _e412 {
                        phi_607_ = _e374[0];
                    } else {
                        phi_607_ = _e374[1];
                    }
                    let _e416 = phi_607_;
                    let _e417 = (_e350 == 2u);
                    if _e417 {
                        phi_613_ = _e374[2];
                    } else {
                        phi_613_ = _e416;
                    }
                    let _e420 = phi_613_;
                    if _e412 {
                        phi_624_ = _e384[0];
                    } else {
                        phi_624_ = _e384[1];
                    }
                    let _e424 = phi_624_;
                    if _e417 {
                        phi_630_ = _e384[2];
                    } else {
                        phi_630_ = _e424;
                    }
                    let _e427 = phi_630_;
                    let _e429 = ((_e427 * _e363) * _e369);
                    let _e433 = (bitcast<f32>((bitcast<u32>(_e429) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e433 {
                        let _e437 = (bitcast<f32>((bitcast<u32>(_e420) & 2147483647u)) * 0.00000011920929f);
                        phi_653_ = select(0.00000000000011368684f, _e437, (_e437 > 0.00000000000011368684f));
                    } else {
                        phi_653_ = 0f;
                    }
                    let _e441 = phi_653_;
                    let _e442 = (_e420 + _e441);
                    let _e443 = (_e420 - _e441);
                    let _e444 = select(_e429, 0f, _e433);
                    if _e433 {
                        phi_664_ = 38685626000000000000000000f;
                    } else {
                        phi_664_ = (1f / _e429);
                    }
                    let _e447 = phi_664_;
                    let _e448 = (_e352 == 0u);
                    if _e448 {
                        phi_673_ = _e374[0];
                    } else {
                        phi_673_ = _e374[1];
                    }
                    let _e452 = phi_673_;
                    let _e453 = (_e352 == 2u);
                    if _e453 {
                        phi_679_ = _e374[2];
                    } else {
                        phi_679_ = _e452;
                    }
                    let _e456 = phi_679_;
                    if _e448 {
                        phi_690_ = _e384[0];
                    } else {
                        phi_690_ = _e384[1];
                    }
                    let _e460 = phi_690_;
                    if _e453 {
                        phi_696_ = _e384[2];
                    } else {
                        phi_696_ = _e460;
                    }
                    let _e463 = phi_696_;
                    let _e465 = ((_e463 * _e363) * _e369);
                    let _e469 = (bitcast<f32>((bitcast<u32>(_e465) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e469 {
                        let _e473 = (bitcast<f32>((bitcast<u32>(_e456) & 2147483647u)) * 0.00000011920929f);
                        phi_719_ = select(0.00000000000011368684f, _e473, (_e473 > 0.00000000000011368684f));
                    } else {
                        phi_719_ = 0f;
                    }
                    let _e477 = phi_719_;
                    let _e478 = (_e456 + _e477);
                    let _e479 = (_e456 - _e477);
                    let _e480 = select(_e465, 0f, _e469);
                    if _e469 {
                        phi_730_ = 38685626000000000000000000f;
                    } else {
                        phi_730_ = (1f / _e465);
                    }
                    let _e483 = phi_730_;
                    let _e486 = bitcast<f32>((bitcast<u32>(_e383) & 2147483647u));
                    let _e489 = bitcast<f32>((bitcast<u32>(_e420) & 2147483647u));
                    let _e491 = select(_e489, _e486, (_e486 > _e489));
                    let _e494 = bitcast<f32>((bitcast<u32>(_e456) & 2147483647u));
                    if (_e313 && (select(_e494, _e491, (_e491 > _e494)) <= 1099511600000f)) {
                        let _e499 = (_e332 / 3i);
                        let _e506 = bitcast<f32>((bitcast<u32>((_e499 + 127i)) << bitcast<u32>(23i)));
                        let _e513 = bitcast<f32>((bitcast<u32>(((_e332 - (2i * _e499)) + 127i)) << bitcast<u32>(23i)));
                        let _e514 = (((_e297 * _e506) * _e506) * _e513);
                        let _e516 = select(340282350000000000000000000000000000000f, _e514, (_e514 < 340282350000000000000000000000000000000f));
                        let _e521 = (((_e307 * _e506) * _e506) * _e513);
                        let _e523 = select(340282350000000000000000000000000000000f, _e521, (_e521 < 340282350000000000000000000000000000000f));
                        phi_830_ = select(-340282350000000000000000000000000000000f, _e523, (_e523 > -340282350000000000000000000000000000000f));
                        phi_831_ = select(-340282350000000000000000000000000000000f, _e516, (_e516 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_830_ = 0f;
                        phi_831_ = 1f;
                    }
                    let _e527 = phi_830_;
                    let _e529 = phi_831_;
                    local_5 = array<type_61, 128>(type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_16 = array<f32, 3>(bitcast<f32>(_e116), bitcast<f32>(_e120), bitcast<f32>(_e124));
                    let _e534 = (_e351 % 3u);
                    let _e535 = (_e534 < 3u);
                    if _e535 {
                    } else {
                        break;
                    }
                    let _e537 = local_16[_e534];
                    let _e538 = (_e350 % 3u);
                    let _e539 = (_e538 < 3u);
                    if _e539 {
                    } else {
                        break;
                    }
                    let _e541 = local_16[_e538];
                    let _e542 = (_e352 % 3u);
                    let _e543 = (_e542 < 3u);
                    if _e543 {
                    } else {
                        break;
                    }
                    let _e545 = local_16[_e542];
                    local_15 = array<f32, 3>(bitcast<f32>(_e128), bitcast<f32>(_e132), bitcast<f32>(_e136));
                    if _e535 {
                    } else {
                        break;
                    }
                    let _e549 = local_15[_e534];
                    if _e539 {
                    } else {
                        break;
                    }
                    let _e551 = local_15[_e538];
                    if _e543 {
                    } else {
                        break;
                    }
                    let _e553 = local_15[_e542];
                    phi_5299_ = false;
                    phi_2959_ = type_37(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e527);
                    phi_2962_ = type_61(type_52(array<f32, 3>(_e537, _e541, _e545), array<f32, 3>(_e549, _e551, _e553)), select(0u, 2147483648u, (_e97 == 0u)));
                    phi_2964_ = ((3u * _e97) + 1u);
                    phi_2966_ = (_e529 <= _e527);
                    phi_2968_ = 0u;
                    loop {
                        let _e561 = phi_5299_;
                        let _e563 = phi_2959_;
                        let _e565 = phi_2962_;
                        let _e567 = phi_2964_;
                        let _e569 = phi_2966_;
                        let _e571 = phi_2968_;
                        local_17 = _e563;
                        if _e569 {
                            phi_2979_ = true;
                        } else {
                            phi_2979_ = (_e571 > 0u);
                        }
                        let _e574 = phi_2979_;
                        if _e574 {
                            let _e575 = (_e567 > 0u);
                            if _e575 {
                                if _e569 {
                                    phi_3024_ = _e565;
                                    phi_3025_ = _e569;
                                    phi_3026_ = _e571;
                                } else {
                                    let _e576 = (_e571 - 1u);
                                    let _e577 = (_e576 % 128u);
                                    let _e578 = (_e577 < 128u);
                                    if _e578 {
                                    } else {
                                        phi_5457_ = true;
                                        break;
                                    }
                                    let _e580 = local_5[_e577];
                                    if _e578 {
                                    } else {
                                        phi_5457_ = true;
                                        break;
                                    }
                                    let _e596 = local_4[_e577];
                                    phi_3024_ = type_61(type_52(array<f32, 3>(_e580.member.member[0], _e580.member.member[1], _e580.member.member[2]), array<f32, 3>(_e580.member.member_1[0], _e580.member.member_1[1], _e580.member.member_1[2])), _e580.member_1);
                                    phi_3025_ = (_e596 <= _e563.member_1);
                                    phi_3026_ = _e576;
                                }
                                let _e600 = phi_3024_;
                                let _e602 = phi_3025_;
                                let _e604 = phi_3026_;
                                if _e602 {
                                    if ((_e600.member_1 & 2147483648u) != 0u) {
                                        phi_5373_ = _e561;
                                        phi_3045_ = _e563;
                                        phi_3048_ = type_8(0u, ((_e600.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e926 = phi_5373_;
                                            let _e928 = phi_3045_;
                                            let _e930 = phi_3048_;
                                            local_18 = _e928;
                                            if (_e930.member < _e930.member_1) {
                                                phi_3049_ = type_8((_e930.member + 1u), _e930.member_1);
                                                phi_3071_ = type_8(1u, _e930.member);
                                            } else {
                                                phi_3049_ = _e930;
                                                phi_3071_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e943 = phi_3049_;
                                            let _e945 = phi_3071_;
                                            let _e949 = (bitcast<i32>(_e945.member) != 0i);
                                            if _e949 {
                                                local_1 = array<f32, 3>(_e600.member.member[0], _e600.member.member[1], _e600.member.member[2]);
                                                local = array<f32, 3>(_e600.member.member_1[0], _e600.member.member_1[1], _e600.member.member_1[2]);
                                                let _e960 = ((_e600.member_1 & 268435455u) + _e945.member_1);
                                                let _e961 = (_e960 < arrayLength((&global_10.member)));
                                                if _e961 {
                                                    if _e961 {
                                                    } else {
                                                        phi_5378_ = true;
                                                        break;
                                                    }
                                                    let _e964 = global_10.member[_e960].member_1;
                                                    phi_3113_ = _e964;
                                                } else {
                                                    phi_3113_ = 4294967295u;
                                                }
                                                let _e966 = phi_3113_;
                                                local_12 = array<u32, 3>(_e351, _e350, _e352);
                                                if _e961 {
                                                    if _e961 {
                                                    } else {
                                                        phi_5378_ = true;
                                                        break;
                                                    }
                                                    let _e969 = global_10.member[_e960];
                                                    phi_3137_ = _e969;
                                                } else {
                                                    phi_3137_ = type_55(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e971 = phi_3137_;
                                                local_14 = array<u32, 3>(_e971.member[0], _e971.member[1], _e971.member[2]);
                                                local_13[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_13[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_13[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_5369_ = _e926;
                                                phi_3148_ = type_8(0u, 3u);
                                                loop {
                                                    let _e981 = phi_5369_;
                                                    let _e983 = phi_3148_;
                                                    if (_e983.member < _e983.member_1) {
                                                        phi_3149_ = type_8((_e983.member + 1u), _e983.member_1);
                                                        phi_3172_ = type_8(1u, _e983.member);
                                                    } else {
                                                        phi_3149_ = _e983;
                                                        phi_3172_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e996 = phi_3149_;
                                                    let _e998 = phi_3172_;
                                                    let _e1002 = (bitcast<i32>(_e998.member) != 0i);
                                                    if _e1002 {
                                                        phi_3182_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1004 = phi_3182_;
                                                            if (_e1004.member < _e1004.member_1) {
                                                                phi_3183_ = type_8((_e1004.member + 1u), _e1004.member_1);
                                                                phi_3206_ = type_8(1u, _e1004.member);
                                                            } else {
                                                                phi_3183_ = _e1004;
                                                                phi_3206_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1017 = phi_3183_;
                                                            let _e1019 = phi_3206_;
                                                            let _e1023 = (bitcast<i32>(_e1019.member) != 0i);
                                                            if _e1023 {
                                                                let _e1024 = (_e998.member_1 < 3u);
                                                                if _e1024 {
                                                                } else {
                                                                    phi_5364_ = true;
                                                                    break;
                                                                }
                                                                let _e1026 = local_14[_e998.member_1];
                                                                let _e1027 = (_e1019.member_1 < 3u);
                                                                if _e1027 {
                                                                } else {
                                                                    phi_5364_ = true;
                                                                    break;
                                                                }
                                                                let _e1029 = local_12[_e1019.member_1];
                                                                let _e1034 = ((_e1026 >> bitcast<u32>(((10u * _e1029) & 31u))) & 1023u);
                                                                if _e1027 {
                                                                } else {
                                                                    phi_5364_ = true;
                                                                    break;
                                                                }
                                                                let _e1036 = local_1[_e1019.member_1];
                                                                if _e1027 {
                                                                } else {
                                                                    phi_5364_ = true;
                                                                    break;
                                                                }
                                                                let _e1038 = local[_e1019.member_1];
                                                                let _e1049 = (_e1036 + bitcast<f32>((bitcast<u32>((f32(_e1034) * bitcast<f32>((bitcast<u32>(((_e1038 - _e1036) * 0.0009775171f)) ^ _e140)))) ^ _e140)));
                                                                if _e1024 {
                                                                } else {
                                                                    phi_5364_ = true;
                                                                    break;
                                                                }
                                                                if _e1027 {
                                                                } else {
                                                                    phi_5364_ = true;
                                                                    break;
                                                                }
                                                                local_13[_e998.member_1][_e1019.member_1] = select(select(_e1038, _e1049, (_e1049 < _e1038)), _e1038, (_e1034 == 1023u));
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_3182_ = _e1017;
                                                                phi_5364_ = _e981;
                                                                break if !(_e1023);
                                                            }
                                                        }
                                                        let _e1058 = phi_5364_;
                                                        phi_5376_ = _e1058;
                                                        if _e1058 {
                                                            break;
                                                        }
                                                        phi_5377_ = _e1058;
                                                    } else {
                                                        phi_5377_ = _e981;
                                                    }
                                                    let _e1060 = phi_5377_;
                                                    continue;
                                                    continuing {
                                                        phi_5369_ = _e1060;
                                                        phi_3148_ = _e996;
                                                        phi_5376_ = _e1060;
                                                        break if !(_e1002);
                                                    }
                                                }
                                                let _e1063 = phi_5376_;
                                                phi_5378_ = _e1063;
                                                if _e1063 {
                                                    break;
                                                }
                                                let _e1064 = local_13;
                                                let _e1080 = (_e1064[0][2] - _e456);
                                                let _e1083 = (((_e1064[0][0] - _e383) * _e480) - (_e1080 * _e408));
                                                let _e1086 = (((_e1064[0][1] - _e420) * _e480) - (_e1080 * _e444));
                                                let _e1089 = (_e1064[1][2] - _e456);
                                                let _e1092 = (((_e1064[1][0] - _e383) * _e480) - (_e1089 * _e408));
                                                let _e1095 = (((_e1064[1][1] - _e420) * _e480) - (_e1089 * _e444));
                                                let _e1098 = (_e1064[2][2] - _e456);
                                                let _e1101 = (((_e1064[2][0] - _e383) * _e480) - (_e1098 * _e408));
                                                let _e1104 = (((_e1064[2][1] - _e420) * _e480) - (_e1098 * _e444));
                                                let _e1105 = (_e1101 * _e1095);
                                                let _e1106 = (_e1104 * _e1092);
                                                let _e1107 = (_e1083 * _e1104);
                                                let _e1108 = (_e1086 * _e1101);
                                                let _e1109 = (_e1092 * _e1086);
                                                let _e1110 = (_e1095 * _e1083);
                                                let _e1115 = (((_e1105 >= _e1106) && (_e1107 >= _e1108)) && (_e1109 >= _e1110));
                                                if (_e1115 || (((_e1105 <= _e1106) && (_e1107 <= _e1108)) && (_e1109 <= _e1110))) {
                                                    let _e1122 = select(-1f, 1f, _e1115);
                                                    let _e1124 = ((_e1105 - _e1106) * _e1122);
                                                    let _e1126 = select(0f, _e1124, (_e1124 > 0f));
                                                    let _e1128 = ((_e1107 - _e1108) * _e1122);
                                                    let _e1130 = select(0f, _e1128, (_e1128 > 0f));
                                                    let _e1132 = ((_e1109 - _e1110) * _e1122);
                                                    let _e1134 = select(0f, _e1132, (_e1132 > 0f));
                                                    let _e1136 = ((_e1126 + _e1130) + _e1134);
                                                    if (_e1136 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3864_ = type_22();
                                                        phi_3865_ = true;
                                                    } else {
                                                        let _e1139 = select(_e1064[1][0], _e1064[0][0], (_e1064[0][0] < _e1064[1][0]));
                                                        let _e1143 = select(_e1064[1][0], _e1064[0][0], (_e1064[0][0] > _e1064[1][0]));
                                                        let _e1147 = select(_e1064[1][1], _e1064[0][1], (_e1064[0][1] < _e1064[1][1]));
                                                        let _e1151 = select(_e1064[1][1], _e1064[0][1], (_e1064[0][1] > _e1064[1][1]));
                                                        let _e1155 = select(_e1064[1][2], _e1064[0][2], (_e1064[0][2] < _e1064[1][2]));
                                                        let _e1159 = select(_e1064[1][2], _e1064[0][2], (_e1064[0][2] > _e1064[1][2]));
                                                        let _e1164 = ((select(_e1064[2][0], _e1139, (_e1139 < _e1064[2][0])) - _e406) * _e411);
                                                        let _e1165 = ((select(_e1064[2][0], _e1143, (_e1143 > _e1064[2][0])) - _e407) * _e411);
                                                        let _e1168 = ((select(_e1064[2][1], _e1147, (_e1147 < _e1064[2][1])) - _e442) * _e447);
                                                        let _e1169 = ((select(_e1064[2][1], _e1151, (_e1151 > _e1064[2][1])) - _e443) * _e447);
                                                        let _e1172 = ((select(_e1064[2][2], _e1155, (_e1155 < _e1064[2][2])) - _e478) * _e483);
                                                        let _e1173 = ((select(_e1064[2][2], _e1159, (_e1159 > _e1064[2][2])) - _e479) * _e483);
                                                        let _e1175 = select(_e1173, _e1172, (_e1172 < _e1173));
                                                        let _e1177 = select(_e1173, _e1172, (_e1172 > _e1173));
                                                        let _e1179 = select(_e1165, _e1164, (_e1164 < _e1165));
                                                        let _e1181 = select(_e1169, _e1168, (_e1168 < _e1169));
                                                        let _e1183 = select(_e1181, _e1179, (_e1179 > _e1181));
                                                        let _e1185 = select(_e1175, _e1183, (_e1183 > _e1175));
                                                        let _e1187 = select(_e1165, _e1164, (_e1164 > _e1165));
                                                        let _e1189 = select(_e1169, _e1168, (_e1168 > _e1169));
                                                        let _e1191 = select(_e1189, _e1187, (_e1187 < _e1189));
                                                        let _e1193 = select(_e1177, _e1191, (_e1191 < _e1177));
                                                        let _e1194 = -(_e1175);
                                                        let _e1200 = select(_e529, _e1185, (_e1185 > _e529));
                                                        if (_e1200 > (_e1193 + (select(_e1194, _e1177, (_e1177 > _e1194)) * 0.0000019073523f))) {
                                                            phi_3859_ = type_22();
                                                            phi_3860_ = true;
                                                        } else {
                                                            let _e1202 = (_e1200 > _e928.member_1);
                                                            if _e1202 {
                                                                phi_3858_ = type_22();
                                                            } else {
                                                                let _e1206 = (_e1064[1][0] - _e1064[0][0]);
                                                                let _e1207 = (_e1064[1][1] - _e1064[0][1]);
                                                                let _e1208 = (_e1064[1][2] - _e1064[0][2]);
                                                                let _e1209 = vec3<f32>(_e1206, _e1207, _e1208);
                                                                let _e1210 = (_e1064[2][0] - _e1064[1][0]);
                                                                let _e1211 = (_e1064[2][1] - _e1064[1][1]);
                                                                let _e1212 = (_e1064[2][2] - _e1064[1][2]);
                                                                let _e1213 = vec3<f32>(_e1210, _e1211, _e1212);
                                                                let _e1214 = (_e1064[0][0] - _e1064[2][0]);
                                                                let _e1215 = (_e1064[0][1] - _e1064[2][1]);
                                                                let _e1216 = (_e1064[0][2] - _e1064[2][2]);
                                                                let _e1217 = vec3<f32>(_e1214, _e1215, _e1216);
                                                                let _e1220 = bitcast<f32>((bitcast<u32>(_e1206) & 2147483647u));
                                                                let _e1223 = bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u));
                                                                let _e1225 = select(_e1223, _e1220, (_e1220 > _e1223));
                                                                let _e1228 = bitcast<f32>((bitcast<u32>(_e1208) & 2147483647u));
                                                                let _e1230 = select(_e1228, _e1225, (_e1225 > _e1228));
                                                                let _e1233 = bitcast<f32>((bitcast<u32>(_e1210) & 2147483647u));
                                                                let _e1236 = bitcast<f32>((bitcast<u32>(_e1211) & 2147483647u));
                                                                let _e1238 = select(_e1236, _e1233, (_e1233 > _e1236));
                                                                let _e1241 = bitcast<f32>((bitcast<u32>(_e1212) & 2147483647u));
                                                                let _e1243 = select(_e1241, _e1238, (_e1238 > _e1241));
                                                                let _e1246 = bitcast<f32>((bitcast<u32>(_e1214) & 2147483647u));
                                                                let _e1249 = bitcast<f32>((bitcast<u32>(_e1215) & 2147483647u));
                                                                let _e1251 = select(_e1249, _e1246, (_e1246 > _e1249));
                                                                let _e1254 = bitcast<f32>((bitcast<u32>(_e1216) & 2147483647u));
                                                                let _e1256 = select(_e1254, _e1251, (_e1251 > _e1254));
                                                                let _e1258 = select(_e1243, _e1230, (_e1230 > _e1243));
                                                                let _e1260 = select(_e1256, _e1258, (_e1258 > _e1256));
                                                                if (_e1230 == _e1260) {
                                                                    phi_3769_ = _e1213;
                                                                    phi_3770_ = _e1217;
                                                                } else {
                                                                    let _e1263 = vec3((_e1243 == _e1260));
                                                                    phi_3769_ = select(_e1209, _e1217, _e1263);
                                                                    phi_3770_ = select(_e1213, _e1209, _e1263);
                                                                }
                                                                let _e1267 = phi_3769_;
                                                                let _e1269 = phi_3770_;
                                                                let _e1276 = ((_e1267.y * _e1269.z) - (_e1269.y * _e1267.z));
                                                                let _e1281 = ((_e1267.z * _e1269.x) - (_e1269.z * _e1267.x));
                                                                let _e1284 = ((_e1267.x * _e1269.y) - (_e1269.x * _e1267.y));
                                                                if (_e1126 >= _e1130) {
                                                                    phi_3801_ = select(true, false, (_e1126 >= _e1134));
                                                                } else {
                                                                    phi_3801_ = true;
                                                                }
                                                                let _e1289 = phi_3801_;
                                                                if _e1289 {
                                                                    phi_3810_ = select(vec3<f32>(_e1064[2][0], _e1064[2][1], _e1064[2][2]), vec3<f32>(_e1064[1][0], _e1064[1][1], _e1064[1][2]), vec3((_e1130 >= _e1134)));
                                                                } else {
                                                                    phi_3810_ = vec3<f32>(_e1064[0][0], _e1064[0][1], _e1064[0][2]);
                                                                }
                                                                let _e1294 = phi_3810_;
                                                                let _e1311 = ((((_e1276 * (_e1294.x - _e383)) + (_e1281 * (_e1294.y - _e420))) + (_e1284 * (_e1294.z - _e456))) / (((_e1276 * _e408) + (_e1281 * _e444)) + (_e1284 * _e480)));
                                                                let _e1313 = select(_e1193, _e1311, (_e1311 < _e1193));
                                                                let _e1315 = select(_e1185, _e1313, (_e1313 > _e1185));
                                                                if (_e1315 >= _e529) {
                                                                    let _e1317 = (_e1315 <= _e928.member_1);
                                                                    if _e1317 {
                                                                        let _e1318 = (1f / _e1136);
                                                                        phi_3850_ = type_22(_e1315, (_e1130 * _e1318), (_e1134 * _e1318), _e966);
                                                                    } else {
                                                                        phi_3850_ = type_22();
                                                                    }
                                                                    let _e1323 = phi_3850_;
                                                                    phi_3852_ = _e1323;
                                                                    phi_3853_ = select(true, false, _e1317);
                                                                } else {
                                                                    phi_3852_ = type_22();
                                                                    phi_3853_ = true;
                                                                }
                                                                let _e1326 = phi_3852_;
                                                                let _e1328 = phi_3853_;
                                                                if _e1328 {
                                                                    phi_3857_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3857_ = _e1326;
                                                                }
                                                                let _e1330 = phi_3857_;
                                                                phi_3858_ = _e1330;
                                                            }
                                                            let _e1332 = phi_3858_;
                                                            phi_3859_ = _e1332;
                                                            phi_3860_ = _e1202;
                                                        }
                                                        let _e1334 = phi_3859_;
                                                        let _e1336 = phi_3860_;
                                                        phi_3864_ = _e1334;
                                                        phi_3865_ = _e1336;
                                                    }
                                                    let _e1338 = phi_3864_;
                                                    let _e1340 = phi_3865_;
                                                    phi_3869_ = _e1338;
                                                    phi_3870_ = _e1340;
                                                } else {
                                                    phi_3869_ = type_22();
                                                    phi_3870_ = true;
                                                }
                                                let _e1342 = phi_3869_;
                                                let _e1344 = phi_3870_;
                                                if _e1344 {
                                                    phi_3874_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3874_ = _e1342;
                                                }
                                                let _e1346 = phi_3874_;
                                                if (_e1346.member_3 != 4294967295u) {
                                                    if (_e966 == _e157) {
                                                        phi_4203_ = false;
                                                    } else {
                                                        let _e1350 = (_e966 < arrayLength((&global_4.member)));
                                                        if _e1350 {
                                                            if _e1350 {
                                                            } else {
                                                                phi_5378_ = true;
                                                                break;
                                                            }
                                                            let _e1352 = global_4.member[_e966];
                                                            phi_3897_ = _e1352;
                                                        } else {
                                                            phi_3897_ = 4294967295u;
                                                        }
                                                        let _e1354 = phi_3897_;
                                                        let _e1355 = (_e1354 < arrayLength((&global_5.member)));
                                                        if _e1355 {
                                                            if _e1355 {
                                                            } else {
                                                                phi_5378_ = true;
                                                                break;
                                                            }
                                                            let _e1357 = global_5.member[_e1354];
                                                            phi_3911_ = _e1357;
                                                        } else {
                                                            phi_3911_ = 0i;
                                                        }
                                                        let _e1359 = phi_3911_;
                                                        let _e1360 = (_e1359 == 0i);
                                                        if _e1360 {
                                                            phi_4202_ = true;
                                                        } else {
                                                            if _e375 {
                                                                phi_3932_ = vec3<f32>(_e1064[0][0], _e1064[0][1], _e1064[0][2]);
                                                            } else {
                                                                if (_e351 == 1u) {
                                                                    phi_3931_ = vec3<f32>(_e1064[0][2], _e1064[0][0], _e1064[0][1]);
                                                                } else {
                                                                    phi_3931_ = vec3<f32>(_e1064[0][1], _e1064[0][2], _e1064[0][0]);
                                                                }
                                                                let _e1365 = phi_3931_;
                                                                phi_3932_ = _e1365;
                                                            }
                                                            let _e1368 = phi_3932_;
                                                            if _e375 {
                                                                phi_3949_ = vec3<f32>(_e1064[1][0], _e1064[1][1], _e1064[1][2]);
                                                            } else {
                                                                if (_e351 == 1u) {
                                                                    phi_3948_ = vec3<f32>(_e1064[1][2], _e1064[1][0], _e1064[1][1]);
                                                                } else {
                                                                    phi_3948_ = vec3<f32>(_e1064[1][1], _e1064[1][2], _e1064[1][0]);
                                                                }
                                                                let _e1373 = phi_3948_;
                                                                phi_3949_ = _e1373;
                                                            }
                                                            let _e1376 = phi_3949_;
                                                            if _e375 {
                                                                phi_3966_ = vec3<f32>(_e1064[2][0], _e1064[2][1], _e1064[2][2]);
                                                            } else {
                                                                if (_e351 == 1u) {
                                                                    phi_3965_ = vec3<f32>(_e1064[2][2], _e1064[2][0], _e1064[2][1]);
                                                                } else {
                                                                    phi_3965_ = vec3<f32>(_e1064[2][1], _e1064[2][2], _e1064[2][0]);
                                                                }
                                                                let _e1381 = phi_3965_;
                                                                phi_3966_ = _e1381;
                                                            }
                                                            let _e1384 = phi_3966_;
                                                            let _e1387 = (_e1376.x - _e1368.x);
                                                            let _e1390 = (_e1376.y - _e1368.y);
                                                            let _e1393 = (_e1376.z - _e1368.z);
                                                            let _e1395 = (_e1384.x - _e1368.x);
                                                            let _e1397 = (_e1384.y - _e1368.y);
                                                            let _e1399 = (_e1384.z - _e1368.z);
                                                            if (_e229.member_1 == 1u) {
                                                                phi_4002_ = (vec3<f32>(_e229.member[0], _e229.member[1], _e229.member[2]) - _e1368);
                                                            } else {
                                                                phi_4002_ = vec3<f32>(_e229.member[0], _e229.member[1], _e229.member[2]);
                                                            }
                                                            let _e1414 = phi_4002_;
                                                            let _e1420 = bitcast<f32>((bitcast<u32>((_e1387 * _e1397)) ^ _e229.member_3[0]));
                                                            let _e1424 = bitcast<f32>((bitcast<u32>((_e1390 * _e1395)) ^ _e229.member_3[0]));
                                                            let _e1428 = bitcast<f32>((bitcast<u32>((_e1390 * _e1399)) ^ _e229.member_3[0]));
                                                            let _e1432 = bitcast<f32>((bitcast<u32>((_e1393 * _e1397)) ^ _e229.member_3[0]));
                                                            let _e1436 = bitcast<f32>((bitcast<u32>((_e1393 * _e1395)) ^ _e229.member_3[0]));
                                                            let _e1440 = bitcast<f32>((bitcast<u32>((_e1387 * _e1399)) ^ _e229.member_3[0]));
                                                            let _e1441 = (_e1428 - _e1432);
                                                            let _e1442 = (_e1436 - _e1440);
                                                            let _e1443 = (_e1420 - _e1424);
                                                            let _e1467 = (bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u)));
                                                            let _e1474 = (bitcast<f32>((bitcast<u32>(_e1436) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1440) & 2147483647u)));
                                                            let _e1481 = (bitcast<f32>((bitcast<u32>(_e1420) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1424) & 2147483647u)));
                                                            if (_e229.member_2 == 0f) {
                                                                phi_4184_ = 0f;
                                                            } else {
                                                                let _e1511 = bitcast<f32>((bitcast<u32>(_e1441) & 2147483647u));
                                                                let _e1514 = bitcast<f32>((bitcast<u32>(_e1442) & 2147483647u));
                                                                let _e1517 = bitcast<f32>((bitcast<u32>(_e1443) & 2147483647u));
                                                                let _e1519 = select(_e1517, _e1514, (_e1514 > _e1517));
                                                                let _e1523 = select(_e1517, _e1514, (_e1514 < _e1517));
                                                                let _e1527 = select(_e1514, _e1511, (_e1511 < _e1514));
                                                                let _e1529 = select(_e1514, _e1511, (_e1511 > _e1514));
                                                                let _e1531 = select(_e1517, _e1529, (_e1529 < _e1517));
                                                                phi_4184_ = bitcast<f32>((bitcast<u32>((_e229.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1519, _e1511, (_e1511 > _e1519)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1531, _e1527, (_e1527 > _e1531)))) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1523, _e1511, (_e1511 < _e1523)))) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1467 + _e1474) + _e1481))) ^ _e229.member_3[0]))) * 1.0000005f)) ^ _e229.member_3[0])))) ^ _e229.member_3[0]));
                                                            }
                                                            let _e1558 = phi_4184_;
                                                            phi_4202_ = (_e1360 || !(((((bitcast<f32>((bitcast<u32>((_e1414.x * _e1441)) ^ _e229.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1414.y * _e1442)) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1414.z * _e1443)) ^ _e229.member_3[0]))) * f32(-(_e1359))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1414.x) & 2147483647u)) * _e1467)) ^ _e229.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1414.y) & 2147483647u)) * _e1474)) ^ _e229.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1414.z) & 2147483647u)) * _e1481)) ^ _e229.member_3[0]))))) ^ _e229.member_3[0])) + _e1558) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1572 = phi_4202_;
                                                        phi_4203_ = _e1572;
                                                    }
                                                    let _e1574 = phi_4203_;
                                                    if _e1574 {
                                                        if (_e1346.member < _e928.member.member) {
                                                            phi_4223_ = true;
                                                        } else {
                                                            if (_e1346.member == _e928.member.member) {
                                                                phi_4222_ = (_e1346.member_3 < _e928.member.member_3);
                                                            } else {
                                                                phi_4222_ = false;
                                                            }
                                                            let _e1584 = phi_4222_;
                                                            phi_4223_ = _e1584;
                                                        }
                                                        let _e1586 = phi_4223_;
                                                        if _e1586 {
                                                            phi_4229_ = type_37(_e1346, _e1346.member);
                                                        } else {
                                                            phi_4229_ = _e928;
                                                        }
                                                        let _e1589 = phi_4229_;
                                                        phi_4230_ = _e1589;
                                                    } else {
                                                        phi_4230_ = _e928;
                                                    }
                                                    let _e1591 = phi_4230_;
                                                    phi_4231_ = _e1591;
                                                } else {
                                                    phi_4231_ = _e928;
                                                }
                                                let _e1593 = phi_4231_;
                                                phi_5379_ = _e1063;
                                                phi_3046_ = _e1593;
                                            } else {
                                                phi_5379_ = _e926;
                                                phi_3046_ = type_37();
                                            }
                                            let _e1595 = phi_5379_;
                                            let _e1597 = phi_3046_;
                                            continue;
                                            continuing {
                                                phi_5373_ = _e1595;
                                                phi_3045_ = _e1597;
                                                phi_3048_ = _e943;
                                                phi_5378_ = _e1595;
                                                break if !(_e949);
                                            }
                                        }
                                        let _e1600 = phi_5378_;
                                        phi_5457_ = _e1600;
                                        if _e1600 {
                                            break;
                                        }
                                        phi_5461_ = _e1600;
                                        let _e1828 = local_18;
                                        phi_5075_ = _e1828;
                                        phi_5076_ = _e600;
                                        phi_5077_ = false;
                                        phi_5078_ = _e604;
                                    } else {
                                        local_3 = array<f32, 3>(_e600.member.member[0], _e600.member.member[1], _e600.member.member[2]);
                                        local_2 = array<f32, 3>(_e600.member.member_1[0], _e600.member.member_1[1], _e600.member.member_1[2]);
                                        let _e624 = (_e600.member_1 < _e97);
                                        if _e624 {
                                            if _e624 {
                                            } else {
                                                phi_5457_ = true;
                                                break;
                                            }
                                            let _e626 = global_9.member[_e600.member_1];
                                            phi_4265_ = _e626;
                                        } else {
                                            phi_4265_ = type_47(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e628 = phi_4265_;
                                        let _e630 = array<u32, 3>(_e351, _e350, _e352);
                                        local_11 = _e630;
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        local_6 = array<f32, 3>(0f, 0f, 0f);
                                        phi_4274_ = type_8(0u, 3u);
                                        loop {
                                            let _e632 = phi_4274_;
                                            if (_e632.member < _e632.member_1) {
                                                phi_4275_ = type_8((_e632.member + 1u), _e632.member_1);
                                                phi_4298_ = type_8(1u, _e632.member);
                                            } else {
                                                phi_4275_ = _e632;
                                                phi_4298_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e645 = phi_4275_;
                                            let _e647 = phi_4298_;
                                            let _e651 = (bitcast<i32>(_e647.member) != 0i);
                                            if _e651 {
                                                let _e652 = (_e647.member_1 < 3u);
                                                if _e652 {
                                                } else {
                                                    phi_5292_ = true;
                                                    break;
                                                }
                                                let _e654 = local_11[_e647.member_1];
                                                if _e652 {
                                                } else {
                                                    phi_5292_ = true;
                                                    break;
                                                }
                                                let _e656 = local_3[_e647.member_1];
                                                if _e652 {
                                                } else {
                                                    phi_5292_ = true;
                                                    break;
                                                }
                                                let _e658 = local_2[_e647.member_1];
                                                let _e661 = ((10u * _e654) & 31u);
                                                let _e664 = ((_e628.member[0] >> bitcast<u32>(_e661)) & 1023u);
                                                let _e669 = bitcast<f32>((bitcast<u32>(((_e658 - _e656) * 0.0009775171f)) ^ _e140));
                                                let _e675 = (_e656 + bitcast<f32>((bitcast<u32>((f32(_e664) * _e669)) ^ _e140)));
                                                if _e652 {
                                                } else {
                                                    phi_5292_ = true;
                                                    break;
                                                }
                                                local_7[_e647.member_1] = select(select(_e658, _e675, (_e675 < _e658)), _e658, (_e664 == 1023u));
                                                let _e684 = ((_e628.member[1] >> bitcast<u32>(_e661)) & 1023u);
                                                let _e690 = (_e656 + bitcast<f32>((bitcast<u32>((f32(_e684) * _e669)) ^ _e140)));
                                                if _e652 {
                                                } else {
                                                    phi_5292_ = true;
                                                    break;
                                                }
                                                local_6[_e647.member_1] = select(select(_e658, _e690, (_e690 < _e658)), _e658, (_e684 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_4274_ = _e645;
                                                phi_5292_ = _e561;
                                                break if !(_e651);
                                            }
                                        }
                                        let _e698 = phi_5292_;
                                        phi_5457_ = _e698;
                                        if _e698 {
                                            break;
                                        }
                                        let _e699 = local_6;
                                        let _e700 = local_7;
                                        local_10 = _e630;
                                        local_9 = array<f32, 3>(0f, 0f, 0f);
                                        local_8 = array<f32, 3>(0f, 0f, 0f);
                                        phi_4428_ = type_8(0u, 3u);
                                        loop {
                                            let _e709 = phi_4428_;
                                            if (_e709.member < _e709.member_1) {
                                                phi_4429_ = type_8((_e709.member + 1u), _e709.member_1);
                                                phi_4452_ = type_8(1u, _e709.member);
                                            } else {
                                                phi_4429_ = _e709;
                                                phi_4452_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e722 = phi_4429_;
                                            let _e724 = phi_4452_;
                                            let _e728 = (bitcast<i32>(_e724.member) != 0i);
                                            if _e728 {
                                                let _e729 = (_e724.member_1 < 3u);
                                                if _e729 {
                                                } else {
                                                    phi_5356_ = true;
                                                    break;
                                                }
                                                let _e731 = local_10[_e724.member_1];
                                                if _e729 {
                                                } else {
                                                    phi_5356_ = true;
                                                    break;
                                                }
                                                let _e733 = local_3[_e724.member_1];
                                                if _e729 {
                                                } else {
                                                    phi_5356_ = true;
                                                    break;
                                                }
                                                let _e735 = local_2[_e724.member_1];
                                                let _e738 = ((10u * _e731) & 31u);
                                                let _e741 = ((_e628.member_1[0] >> bitcast<u32>(_e738)) & 1023u);
                                                let _e746 = bitcast<f32>((bitcast<u32>(((_e735 - _e733) * 0.0009775171f)) ^ _e140));
                                                let _e752 = (_e733 + bitcast<f32>((bitcast<u32>((f32(_e741) * _e746)) ^ _e140)));
                                                if _e729 {
                                                } else {
                                                    phi_5356_ = true;
                                                    break;
                                                }
                                                local_9[_e724.member_1] = select(select(_e735, _e752, (_e752 < _e735)), _e735, (_e741 == 1023u));
                                                let _e761 = ((_e628.member_1[1] >> bitcast<u32>(_e738)) & 1023u);
                                                let _e767 = (_e733 + bitcast<f32>((bitcast<u32>((f32(_e761) * _e746)) ^ _e140)));
                                                if _e729 {
                                                } else {
                                                    phi_5356_ = true;
                                                    break;
                                                }
                                                local_8[_e724.member_1] = select(select(_e735, _e767, (_e767 < _e735)), _e735, (_e761 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_4428_ = _e722;
                                                phi_5356_ = _e698;
                                                break if !(_e728);
                                            }
                                        }
                                        let _e775 = phi_5356_;
                                        phi_5457_ = _e775;
                                        if _e775 {
                                            break;
                                        }
                                        let _e776 = local_8;
                                        let _e777 = local_9;
                                        let _e788 = type_61(type_52(array<f32, 3>(_e700[0], _e700[1], _e700[2]), array<f32, 3>(_e699[0], _e699[1], _e699[2])), _e628.member_2);
                                        let _e793 = type_61(type_52(array<f32, 3>(_e777[0], _e777[1], _e777[2]), array<f32, 3>(_e776[0], _e776[1], _e776[2])), _e628.member_3);
                                        let _e799 = ((_e700[0] - _e406) * _e411);
                                        let _e800 = ((_e777[0] - _e406) * _e411);
                                        let _e801 = ((_e699[0] - _e407) * _e411);
                                        let _e802 = ((_e776[0] - _e407) * _e411);
                                        let _e807 = ((_e700[1] - _e442) * _e447);
                                        let _e808 = ((_e777[1] - _e442) * _e447);
                                        let _e809 = ((_e699[1] - _e443) * _e447);
                                        let _e810 = ((_e776[1] - _e443) * _e447);
                                        let _e815 = ((_e700[2] - _e478) * _e483);
                                        let _e816 = ((_e777[2] - _e478) * _e483);
                                        let _e817 = ((_e699[2] - _e479) * _e483);
                                        let _e818 = ((_e776[2] - _e479) * _e483);
                                        let _e820 = select(_e817, _e815, (_e815 < _e817));
                                        let _e822 = select(_e818, _e816, (_e816 < _e818));
                                        let _e824 = select(_e817, _e815, (_e815 > _e817));
                                        let _e826 = select(_e818, _e816, (_e816 > _e818));
                                        let _e828 = select(_e801, _e799, (_e799 < _e801));
                                        let _e830 = select(_e802, _e800, (_e800 < _e802));
                                        let _e832 = select(_e809, _e807, (_e807 < _e809));
                                        let _e834 = select(_e810, _e808, (_e808 < _e810));
                                        let _e836 = select(_e832, _e828, (_e828 > _e832));
                                        let _e838 = select(_e834, _e830, (_e830 > _e834));
                                        let _e840 = select(_e820, _e836, (_e836 > _e820));
                                        let _e842 = select(_e822, _e838, (_e838 > _e822));
                                        let _e844 = select(_e801, _e799, (_e799 > _e801));
                                        let _e846 = select(_e802, _e800, (_e800 > _e802));
                                        let _e848 = select(_e809, _e807, (_e807 > _e809));
                                        let _e850 = select(_e810, _e808, (_e808 > _e810));
                                        let _e852 = select(_e848, _e844, (_e844 < _e848));
                                        let _e854 = select(_e850, _e846, (_e846 < _e850));
                                        let _e859 = -(_e820);
                                        let _e860 = -(_e822);
                                        let _e867 = (select(_e824, _e852, (_e852 < _e824)) + (select(_e859, _e824, (_e824 > _e859)) * 0.0000019073523f));
                                        let _e868 = (select(_e826, _e854, (_e854 < _e826)) + (select(_e860, _e826, (_e826 > _e860)) * 0.0000019073523f));
                                        let _e870 = select(_e529, _e840, (_e840 > _e529));
                                        let _e872 = select(_e529, _e842, (_e842 > _e529));
                                        let _e877 = (_e870 <= select(_e563.member_1, _e867, (_e867 < _e563.member_1)));
                                        let _e878 = (_e872 <= select(_e563.member_1, _e868, (_e868 < _e563.member_1)));
                                        let _e879 = (_e870 <= _e872);
                                        if _e877 {
                                            if _e878 {
                                                if _e879 {
                                                    phi_5015_ = _e793;
                                                } else {
                                                    phi_5015_ = _e788;
                                                }
                                                let _e881 = phi_5015_;
                                                let _e882 = (_e604 % 128u);
                                                let _e883 = (_e882 < 128u);
                                                if _e883 {
                                                } else {
                                                    phi_5457_ = true;
                                                    break;
                                                }
                                                local_5[_e882] = type_61(type_52(array<f32, 3>(_e881.member.member[0], _e881.member.member[1], _e881.member.member[2]), array<f32, 3>(_e881.member.member_1[0], _e881.member.member_1[1], _e881.member.member_1[2])), _e881.member_1);
                                                if _e883 {
                                                } else {
                                                    phi_5457_ = true;
                                                    break;
                                                }
                                                local_4[_e882] = select(_e872, _e870, (_e870 > _e872));
                                                if _e879 {
                                                    phi_5054_ = _e788;
                                                } else {
                                                    phi_5054_ = _e793;
                                                }
                                                let _e904 = phi_5054_;
                                                phi_5055_ = _e904;
                                                phi_5056_ = (_e604 + 1u);
                                            } else {
                                                phi_5055_ = type_61();
                                                phi_5056_ = u32();
                                            }
                                            let _e906 = phi_5055_;
                                            let _e908 = phi_5056_;
                                            phi_5058_ = _e906;
                                            phi_5059_ = _e908;
                                            phi_5060_ = select(true, false, _e878);
                                        } else {
                                            phi_5058_ = type_61();
                                            phi_5059_ = u32();
                                            phi_5060_ = true;
                                        }
                                        let _e911 = phi_5058_;
                                        let _e913 = phi_5059_;
                                        let _e915 = phi_5060_;
                                        if _e915 {
                                            if _e877 {
                                                phi_5067_ = _e788;
                                            } else {
                                                phi_5067_ = _e793;
                                            }
                                            let _e917 = phi_5067_;
                                            phi_5072_ = _e917;
                                            phi_5073_ = select(_e878, true, _e877);
                                        } else {
                                            phi_5072_ = _e911;
                                            phi_5073_ = _e602;
                                        }
                                        let _e920 = phi_5072_;
                                        let _e922 = phi_5073_;
                                        phi_5461_ = _e775;
                                        phi_5075_ = _e563;
                                        phi_5076_ = _e920;
                                        phi_5077_ = _e922;
                                        phi_5078_ = select(_e913, _e604, _e915);
                                    }
                                    let _e1602 = phi_5461_;
                                    let _e1604 = phi_5075_;
                                    let _e1606 = phi_5076_;
                                    let _e1608 = phi_5077_;
                                    let _e1610 = phi_5078_;
                                    phi_5460_ = _e1602;
                                    phi_5079_ = _e1604;
                                    phi_5080_ = _e1606;
                                    phi_5081_ = (_e567 - 1u);
                                    phi_5082_ = _e1608;
                                    phi_5083_ = _e1610;
                                } else {
                                    phi_5460_ = _e561;
                                    phi_5079_ = _e563;
                                    phi_5080_ = _e600;
                                    phi_5081_ = _e567;
                                    phi_5082_ = _e602;
                                    phi_5083_ = _e604;
                                }
                                let _e1612 = phi_5460_;
                                let _e1614 = phi_5079_;
                                let _e1616 = phi_5080_;
                                let _e1618 = phi_5081_;
                                let _e1620 = phi_5082_;
                                let _e1622 = phi_5083_;
                                phi_5459_ = _e1612;
                                phi_5084_ = _e1614;
                                phi_5085_ = _e1616;
                                phi_5086_ = _e1618;
                                phi_5087_ = _e1620;
                                phi_5088_ = _e1622;
                            } else {
                                phi_5459_ = _e561;
                                phi_5084_ = type_37();
                                phi_5085_ = type_61();
                                phi_5086_ = u32();
                                phi_5087_ = bool();
                                phi_5088_ = u32();
                            }
                            let _e1624 = phi_5459_;
                            let _e1626 = phi_5084_;
                            let _e1628 = phi_5085_;
                            let _e1630 = phi_5086_;
                            let _e1632 = phi_5087_;
                            let _e1634 = phi_5088_;
                            phi_5458_ = _e1624;
                            phi_2960_ = _e1626;
                            phi_2963_ = _e1628;
                            phi_2965_ = _e1630;
                            phi_2967_ = _e1632;
                            phi_2969_ = _e1634;
                            phi_5089_ = _e575;
                        } else {
                            phi_5458_ = _e561;
                            phi_2960_ = type_37();
                            phi_2963_ = type_61();
                            phi_2965_ = u32();
                            phi_2967_ = bool();
                            phi_2969_ = u32();
                            phi_5089_ = false;
                        }
                        let _e1636 = phi_5458_;
                        let _e1638 = phi_2960_;
                        let _e1640 = phi_2963_;
                        let _e1642 = phi_2965_;
                        let _e1644 = phi_2967_;
                        let _e1646 = phi_2969_;
                        let _e1648 = phi_5089_;
                        continue;
                        continuing {
                            phi_5299_ = _e1636;
                            phi_2959_ = _e1638;
                            phi_2962_ = _e1640;
                            phi_2964_ = _e1642;
                            phi_2966_ = _e1644;
                            phi_2968_ = _e1646;
                            phi_5457_ = _e1636;
                            break if !(_e1648);
                        }
                    }
                    let _e1651 = phi_5457_;
                    if _e1651 {
                        break;
                    }
                    let _e1653 = local_17;
                    if (_e1653.member.member_3 != 4294967295u) {
                        let _e1658 = (_e353 / 3i);
                        let _e1665 = bitcast<f32>((bitcast<u32>((_e1658 + 127i)) << bitcast<u32>(23i)));
                        let _e1673 = (((_e1653.member.member * _e1665) * _e1665) * bitcast<f32>((bitcast<u32>(((_e353 - (2i * _e1658)) + 127i)) << bitcast<u32>(23i))));
                        let _e1675 = select(340282350000000000000000000000000000000f, _e1673, (_e1673 < 340282350000000000000000000000000000000f));
                        phi_5141_ = type_22(select(-340282350000000000000000000000000000000f, _e1675, (_e1675 > -340282350000000000000000000000000000000f)), _e1653.member.member_1, _e1653.member.member_2, _e1653.member.member_3);
                    } else {
                        phi_5141_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1682 = phi_5141_;
                    if _e230 {
                    } else {
                        break;
                    }
                    global_7.member[_e144] = _e1682;
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e1686 = select(0u, 1u, (_e297 <= _e307));
                    if (_e1686 > 0u) {
                        let _e1688 = (1u < _e112);
                        if _e1688 {
                            if (0u < _e112) {
                            } else {
                                break;
                            }
                            let _e1692 = atomicAdd((&global_8.member[0u]), _e1686);
                            if ((_e1692 + _e1686) < _e1692) {
                                if _e1688 {
                                } else {
                                    break;
                                }
                                let _e1697 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1700 = select(0u, 1u, (_e1682.member_3 != 4294967295u));
                    if (_e1700 > 0u) {
                        let _e1702 = (3u < _e112);
                        if _e1702 {
                            if (2u < _e112) {
                            } else {
                                break;
                            }
                            let _e1706 = atomicAdd((&global_8.member[2u]), _e1700);
                            if ((_e1706 + _e1700) < _e1706) {
                                if _e1702 {
                                } else {
                                    break;
                                }
                                let _e1711 = atomicAdd((&global_8.member[3u]), 1u);
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
fn trace_paths_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
