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

struct type_26 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: type_30,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_38 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_40 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_43 {
    member: type_26,
    member_1: f32,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: array<i32>,
}

struct type_57 {
    member: array<array<u32, 7>>,
}

struct type_62 {
    member: type_38,
    member_1: u32,
}

struct type_63 {
    member: array<vec4<f32>, 3>,
    member_1: type_62,
    member_2: type_62,
}

struct type_68 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_48;
@group(0) @binding(2) 
var<uniform> global_3: type_48;
@group(0) @binding(4) 
var<storage> global_4: type_20;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_51;
@group(0) @binding(7) 
var<storage> global_7: type_33;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_28;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_68;
@group(0) @binding(3) 
var<storage> global_10: type_57;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<f32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<u32, 128>;
    var local_9: array<f32, 128>;
    var phi_320_: u32;
    var phi_364_: i32;
    var phi_388_: type_40;
    var phi_494_: i32;
    var phi_495_: i32;
    var phi_505_: bool;
    var phi_515_: u32;
    var phi_516_: u32;
    var phi_518_: bool;
    var phi_523_: u32;
    var phi_555_: i32;
    var phi_573_: f32;
    var phi_579_: f32;
    var phi_590_: f32;
    var phi_596_: f32;
    var phi_619_: f32;
    var phi_630_: f32;
    var phi_639_: f32;
    var phi_645_: f32;
    var phi_656_: f32;
    var phi_662_: f32;
    var phi_685_: f32;
    var phi_696_: f32;
    var phi_705_: f32;
    var phi_711_: f32;
    var phi_722_: f32;
    var phi_728_: f32;
    var phi_751_: f32;
    var phi_762_: f32;
    var phi_862_: f32;
    var phi_863_: f32;
    var phi_3697_: bool;
    var phi_952_: type_43;
    var phi_955_: type_62;
    var phi_957_: u32;
    var phi_959_: bool;
    var phi_961_: u32;
    var phi_972_: bool;
    var phi_1058_: type_62;
    var phi_1059_: bool;
    var phi_1060_: u32;
    var phi_2869_: u32;
    var phi_2870_: u32;
    var phi_2880_: u32;
    var phi_2882_: u32;
    var phi_2883_: bool;
    var phi_2903_: u32;
    var phi_2904_: u32;
    var phi_2908_: type_63;
    var phi_3252_: type_62;
    var phi_3329_: type_62;
    var phi_3330_: type_62;
    var phi_3331_: u32;
    var phi_3333_: type_62;
    var phi_3334_: u32;
    var phi_3335_: bool;
    var phi_3344_: type_62;
    var phi_3349_: type_62;
    var phi_3350_: bool;
    var phi_1078_: type_43;
    var phi_1081_: type_8;
    var phi_1082_: type_8;
    var phi_1104_: type_8;
    var phi_1125_: u32;
    var phi_1214_: array<array<f32, 3>, 3>;
    var phi_1685_: vec3<f32>;
    var phi_1686_: vec3<f32>;
    var phi_1717_: bool;
    var phi_1726_: vec3<f32>;
    var phi_1766_: type_26;
    var phi_1768_: type_26;
    var phi_1769_: bool;
    var phi_1773_: type_26;
    var phi_1774_: type_26;
    var phi_1775_: type_26;
    var phi_1776_: bool;
    var phi_1780_: type_26;
    var phi_1781_: bool;
    var phi_1785_: type_26;
    var phi_1786_: bool;
    var phi_1790_: type_26;
    var phi_1813_: u32;
    var phi_1827_: i32;
    var phi_1847_: vec3<f32>;
    var phi_1848_: vec3<f32>;
    var phi_1864_: vec3<f32>;
    var phi_1865_: vec3<f32>;
    var phi_1881_: vec3<f32>;
    var phi_1882_: vec3<f32>;
    var phi_1918_: vec3<f32>;
    var phi_2100_: f32;
    var phi_2118_: bool;
    var phi_2119_: bool;
    var phi_2138_: bool;
    var phi_2139_: bool;
    var phi_2145_: type_43;
    var phi_2146_: type_43;
    var phi_2147_: type_43;
    var phi_1079_: type_43;
    var phi_3691_: bool;
    var phi_3833_: bool;
    var phi_3352_: type_43;
    var phi_3353_: type_62;
    var phi_3354_: bool;
    var phi_3355_: u32;
    var phi_3832_: bool;
    var phi_3356_: type_43;
    var phi_3357_: type_62;
    var phi_3358_: u32;
    var phi_3359_: bool;
    var phi_3360_: u32;
    var phi_3831_: bool;
    var phi_3361_: type_43;
    var phi_3362_: type_62;
    var phi_3363_: u32;
    var phi_3364_: bool;
    var phi_3365_: u32;
    var phi_3830_: bool;
    var phi_953_: type_43;
    var phi_956_: type_62;
    var phi_958_: u32;
    var phi_960_: bool;
    var phi_962_: u32;
    var phi_3366_: bool;
    var phi_3829_: bool;
    var local_10: type_43;
    var phi_3418_: type_26;
    var local_11: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e92 = global;
            let _e94 = arrayLength((&global_10.member));
            let _e96 = arrayLength((&global_4.member));
            let _e108 = arrayLength((&global_9.member));
            let _e112 = global_3.member[0u][0u];
            let _e116 = global_3.member[0u][1u];
            let _e120 = global_3.member[0u][2u];
            let _e124 = global_3.member[0u][3u];
            let _e128 = global_3.member[1u][0u];
            let _e132 = global_3.member[1u][1u];
            let _e136 = global_3.member[1u][2u];
            let _e140 = (_e92.x + (_e92.y * 2097152u));
            let _e152 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e124) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e112), bitcast<i32>(_e116), bitcast<i32>(_e120));
            local = array<i32, 3>(bitcast<i32>(_e128), bitcast<i32>(_e132), bitcast<i32>(_e136));
            let _e155 = (_e140 < arrayLength((&global_7.member)));
            if _e155 {
                if _e155 {
                } else {
                    break;
                }
                let _e159 = global_7.member[_e140].member_2;
                phi_320_ = _e159;
            } else {
                phi_320_ = 4294967295u;
            }
            let _e161 = phi_320_;
            let _e164 = global_1.member[0u];
            let _e168 = global_2.member[0u][0u];
            let _e172 = global_2.member[0u][1u];
            let _e176 = global_2.member[0u][2u];
            let _e180 = global_2.member[0u][3u];
            let _e184 = global_2.member[1u][0u];
            let _e188 = global_2.member[1u][1u];
            let _e192 = global_2.member[1u][2u];
            let _e196 = global_2.member[1u][3u];
            let _e197 = bitcast<f32>(_e168);
            let _e198 = bitcast<f32>(_e172);
            let _e199 = bitcast<f32>(_e176);
            let _e201 = bitcast<f32>(_e184);
            let _e202 = array<u32, 3>(_e188, _e192, _e196);
            let _e204 = bitcast<i32>(_e164);
            if (_e204 < -126i) {
                phi_364_ = -126i;
            } else {
                phi_364_ = select(_e204, 127i, (_e204 > 127i));
            }
            let _e209 = phi_364_;
            let _e214 = bitcast<f32>((bitcast<u32>((_e209 + 127i)) << bitcast<u32>(23i)));
            let _e220 = bitcast<f32>((bitcast<u32>(((_e204 - _e209) + 127i)) << bitcast<u32>(23i)));
            if (_e180 == 0u) {
                phi_388_ = type_40(array<f32, 3>(_e197, _e198, _e199), _e180, _e201, _e202);
            } else {
                phi_388_ = type_40(array<f32, 3>(((_e197 * _e214) * _e220), ((_e198 * _e214) * _e220), ((_e199 * _e214) * _e220)), _e180, ((_e201 * _e214) * _e220), _e202);
            }
            let _e233 = phi_388_;
            if _e155 {
                let _e234 = (_e140 < arrayLength((&global_8.member)));
                if _e234 {
                    if _e155 {
                    } else {
                        break;
                    }
                    let _e244 = global_7.member[_e140].member.member_2[0u];
                    let _e246 = (bitcast<u32>(_e244) & 2147483647u);
                    let _e252 = global_7.member[_e140].member.member_2[1u];
                    let _e254 = (bitcast<u32>(_e252) & 2147483647u);
                    let _e260 = global_7.member[_e140].member.member_2[2u];
                    let _e262 = (bitcast<u32>(_e260) & 2147483647u);
                    let _e268 = global_7.member[_e140].member.member[0u];
                    let _e270 = (bitcast<u32>(_e268) & 2147483647u);
                    let _e276 = global_7.member[_e140].member.member[1u];
                    let _e278 = (bitcast<u32>(_e276) & 2147483647u);
                    let _e284 = global_7.member[_e140].member.member[2u];
                    let _e286 = (bitcast<u32>(_e284) & 2147483647u);
                    let _e288 = select(_e254, _e246, (_e254 < _e246));
                    let _e290 = select(_e262, _e288, (_e262 < _e288));
                    let _e292 = select(_e270, _e290, (_e270 < _e290));
                    let _e294 = select(_e278, _e292, (_e278 < _e292));
                    let _e296 = select(_e286, _e294, (_e286 < _e294));
                    let _e301 = global_7.member[_e140].member.member_1;
                    let _e303 = (bitcast<u32>(_e301) & 2147483647u);
                    let _e311 = global_7.member[_e140].member.member_3;
                    let _e317 = (((select(_e303, _e296, (_e303 < _e296)) < 2139095040u) && ((bitcast<u32>(_e311) & 2147483647u) <= 2139095040u)) && (_e290 > 0u));
                    if _e317 {
                        let _e320 = (bitcast<u32>(bitcast<f32>(_e290)) & 2147483647u);
                        if (_e320 >= 8388608u) {
                            phi_494_ = (bitcast<i32>((_e320 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_494_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e320)), 32u, (_e320 == 0u))));
                        }
                        let _e334 = phi_494_;
                        phi_495_ = _e334;
                    } else {
                        phi_495_ = 0i;
                    }
                    let _e336 = phi_495_;
                    let _e337 = (_e246 == _e290);
                    if _e337 {
                        phi_505_ = true;
                    } else {
                        phi_505_ = (_e254 == _e290);
                    }
                    let _e340 = phi_505_;
                    let _e341 = select(1u, 0u, _e337);
                    if _e340 {
                        let _e342 = (_e341 + 1u);
                        phi_515_ = _e342;
                        phi_516_ = _e342;
                        phi_518_ = select(true, false, (_e342 == 2u));
                    } else {
                        phi_515_ = u32();
                        phi_516_ = 0u;
                        phi_518_ = true;
                    }
                    let _e346 = phi_515_;
                    let _e348 = phi_516_;
                    let _e350 = phi_518_;
                    if _e350 {
                        phi_523_ = (_e348 + 1u);
                    } else {
                        phi_523_ = 0u;
                    }
                    let _e354 = phi_523_;
                    let _e355 = select(_e346, _e348, _e350);
                    let _e356 = select(_e341, select(2u, _e341, _e340), _e350);
                    let _e357 = -(_e336);
                    if (_e357 < -126i) {
                        phi_555_ = -126i;
                    } else {
                        phi_555_ = select(_e357, 127i, (_e357 > 127i));
                    }
                    let _e362 = phi_555_;
                    let _e367 = bitcast<f32>((bitcast<u32>((_e362 + 127i)) << bitcast<u32>(23i)));
                    let _e373 = bitcast<f32>((bitcast<u32>(((_e357 - _e362) + 127i)) << bitcast<u32>(23i)));
                    let _e378 = global_7.member[_e140].member.member;
                    let _e379 = (_e355 == 0u);
                    if _e379 {
                        phi_573_ = _e378[0];
                    } else {
                        phi_573_ = _e378[1];
                    }
                    let _e383 = phi_573_;
                    let _e384 = (_e355 == 2u);
                    if _e384 {
                        phi_579_ = _e378[2];
                    } else {
                        phi_579_ = _e383;
                    }
                    let _e387 = phi_579_;
                    let _e388 = global_7.member[_e140].member.member_2;
                    if _e379 {
                        phi_590_ = _e388[0];
                    } else {
                        phi_590_ = _e388[1];
                    }
                    let _e392 = phi_590_;
                    if _e384 {
                        phi_596_ = _e388[2];
                    } else {
                        phi_596_ = _e392;
                    }
                    let _e395 = phi_596_;
                    let _e397 = ((_e395 * _e367) * _e373);
                    let _e401 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e401 {
                        let _e405 = (bitcast<f32>((bitcast<u32>(_e387) & 2147483647u)) * 0.00000011920929f);
                        phi_619_ = select(0.00000000000011368684f, _e405, (_e405 > 0.00000000000011368684f));
                    } else {
                        phi_619_ = 0f;
                    }
                    let _e409 = phi_619_;
                    let _e410 = (_e387 + _e409);
                    let _e411 = (_e387 - _e409);
                    let _e412 = select(_e397, 0f, _e401);
                    if _e401 {
                        phi_630_ = 38685626000000000000000000f;
                    } else {
                        phi_630_ = (1f / _e397);
                    }
                    let _e415 = phi_630_;
                    let _e416 = (_e354 == 0u);
                    if _e416 {
                        phi_639_ = _e378[0];
                    } else {
                        phi_639_ = _e378[1];
                    }
                    let _e420 = phi_639_;
                    let _e421 = (_e354 == 2u);
                    if _e421 {
                        phi_645_ = _e378[2];
                    } else {
                        phi_645_ = _e420;
                    }
                    let _e424 = phi_645_;
                    if _e416 {
                        phi_656_ = _e388[0];
                    } else {
                        phi_656_ = _e388[1];
                    }
                    let _e428 = phi_656_;
                    if _e421 {
                        phi_662_ = _e388[2];
                    } else {
                        phi_662_ = _e428;
                    }
                    let _e431 = phi_662_;
                    let _e433 = ((_e431 * _e367) * _e373);
                    let _e437 = (bitcast<f32>((bitcast<u32>(_e433) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e437 {
                        let _e441 = (bitcast<f32>((bitcast<u32>(_e424) & 2147483647u)) * 0.00000011920929f);
                        phi_685_ = select(0.00000000000011368684f, _e441, (_e441 > 0.00000000000011368684f));
                    } else {
                        phi_685_ = 0f;
                    }
                    let _e445 = phi_685_;
                    let _e446 = (_e424 + _e445);
                    let _e447 = (_e424 - _e445);
                    let _e448 = select(_e433, 0f, _e437);
                    if _e437 {
                        phi_696_ = 38685626000000000000000000f;
                    } else {
                        phi_696_ = (1f / _e433);
                    }
                    let _e451 = phi_696_;
                    let _e452 = (_e356 == 0u);
                    if _e452 {
                        phi_705_ = _e378[0];
                    } else {
                        phi_705_ = _e378[1];
                    }
                    let _e456 = phi_705_;
                    let _e457 = (_e356 == 2u);
                    if _e457 {
                        phi_711_ = _e378[2];
                    } else {
                        phi_711_ = _e456;
                    }
                    let _e460 = phi_711_;
                    if _e452 {
                        phi_722_ = _e388[0];
                    } else {
                        phi_722_ = _e388[1];
                    }
                    let _e464 = phi_722_;
                    if _e457 {
                        phi_728_ = _e388[2];
                    } else {
                        phi_728_ = _e464;
                    }
                    let _e467 = phi_728_;
                    let _e469 = ((_e467 * _e367) * _e373);
                    let _e473 = (bitcast<f32>((bitcast<u32>(_e469) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e473 {
                        let _e477 = (bitcast<f32>((bitcast<u32>(_e460) & 2147483647u)) * 0.00000011920929f);
                        phi_751_ = select(0.00000000000011368684f, _e477, (_e477 > 0.00000000000011368684f));
                    } else {
                        phi_751_ = 0f;
                    }
                    let _e481 = phi_751_;
                    let _e482 = (_e460 + _e481);
                    let _e483 = (_e460 - _e481);
                    let _e484 = select(_e469, 0f, _e473);
                    if _e473 {
                        phi_762_ = 38685626000000000000000000f;
                    } else {
                        phi_762_ = (1f / _e469);
                    }
                    let _e487 = phi_762_;
                    let _e490 = bitcast<f32>((bitcast<u32>(_e387) & 2147483647u));
                    let _e493 = bitcast<f32>((bitcast<u32>(_e424) & 2147483647u));
                    let _e495 = select(_e493, _e490, (_e490 > _e493));
                    let _e498 = bitcast<f32>((bitcast<u32>(_e460) & 2147483647u));
                    if (_e317 && (select(_e498, _e495, (_e495 > _e498)) <= 1099511600000f)) {
                        let _e503 = (_e336 / 3i);
                        let _e510 = bitcast<f32>((bitcast<u32>((_e503 + 127i)) << bitcast<u32>(23i)));
                        let _e517 = bitcast<f32>((bitcast<u32>(((_e336 - (2i * _e503)) + 127i)) << bitcast<u32>(23i)));
                        let _e518 = (((_e301 * _e510) * _e510) * _e517);
                        let _e520 = select(340282350000000000000000000000000000000f, _e518, (_e518 < 340282350000000000000000000000000000000f));
                        let _e525 = (((_e311 * _e510) * _e510) * _e517);
                        let _e527 = select(340282350000000000000000000000000000000f, _e525, (_e525 < 340282350000000000000000000000000000000f));
                        phi_862_ = select(-340282350000000000000000000000000000000f, _e527, (_e527 > -340282350000000000000000000000000000000f));
                        phi_863_ = select(-340282350000000000000000000000000000000f, _e520, (_e520 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_862_ = 0f;
                        phi_863_ = 1f;
                    }
                    let _e531 = phi_862_;
                    let _e533 = phi_863_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e537 = (_e355 % 3u);
                    let _e538 = (_e537 < 3u);
                    if _e538 {
                    } else {
                        break;
                    }
                    let _e540 = local_1[_e537];
                    let _e543 = (_e354 % 3u);
                    let _e544 = (_e543 < 3u);
                    if _e544 {
                    } else {
                        break;
                    }
                    let _e546 = local_1[_e543];
                    let _e549 = (_e356 % 3u);
                    let _e550 = (_e549 < 3u);
                    if _e550 {
                    } else {
                        break;
                    }
                    let _e552 = local_1[_e549];
                    if _e538 {
                    } else {
                        break;
                    }
                    let _e557 = local[_e537];
                    if _e544 {
                    } else {
                        break;
                    }
                    let _e561 = local[_e543];
                    if _e550 {
                    } else {
                        break;
                    }
                    let _e565 = local[_e549];
                    phi_3697_ = false;
                    phi_952_ = type_43(type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e531);
                    phi_955_ = type_62(type_38(vec4<f32>((f32(_e540) * _e152), (f32(_e546) * _e152), (f32(_e552) * _e152), 0f), vec4<f32>((f32(_e557) * _e152), (f32(_e561) * _e152), (f32(_e565) * _e152), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                    phi_957_ = ((3u * _e94) + 1u);
                    phi_959_ = (_e533 <= _e531);
                    phi_961_ = 0u;
                    loop {
                        let _e575 = phi_3697_;
                        let _e577 = phi_952_;
                        let _e579 = phi_955_;
                        let _e581 = phi_957_;
                        let _e583 = phi_959_;
                        let _e585 = phi_961_;
                        local_10 = _e577;
                        if _e583 {
                            phi_972_ = true;
                        } else {
                            phi_972_ = (_e585 > 0u);
                        }
                        let _e588 = phi_972_;
                        if _e588 {
                            let _e589 = (_e581 > 0u);
                            if _e589 {
                                if _e583 {
                                    phi_1058_ = _e579;
                                    phi_1059_ = _e583;
                                    phi_1060_ = _e585;
                                } else {
                                    let _e590 = (_e585 - 1u);
                                    let _e591 = (_e590 % 128u);
                                    let _e592 = (_e591 < 128u);
                                    if _e592 {
                                    } else {
                                        phi_3829_ = true;
                                        break;
                                    }
                                    let _e594 = local_7[_e591];
                                    if _e592 {
                                    } else {
                                        phi_3829_ = true;
                                        break;
                                    }
                                    let _e596 = local_6[_e591];
                                    if _e592 {
                                    } else {
                                        phi_3829_ = true;
                                        break;
                                    }
                                    let _e598 = local_5[_e591];
                                    if _e592 {
                                    } else {
                                        phi_3829_ = true;
                                        break;
                                    }
                                    let _e600 = local_4[_e591];
                                    if _e592 {
                                    } else {
                                        phi_3829_ = true;
                                        break;
                                    }
                                    let _e602 = local_3[_e591];
                                    if _e592 {
                                    } else {
                                        phi_3829_ = true;
                                        break;
                                    }
                                    let _e604 = local_2[_e591];
                                    if _e592 {
                                    } else {
                                        phi_3829_ = true;
                                        break;
                                    }
                                    let _e609 = local_8[_e591];
                                    if _e592 {
                                    } else {
                                        phi_3829_ = true;
                                        break;
                                    }
                                    let _e612 = local_9[_e591];
                                    phi_1058_ = type_62(type_38(vec4<f32>(_e594, _e596, _e598, 0f), vec4<f32>(_e600, _e602, _e604, 0f)), _e609);
                                    phi_1059_ = (_e612 <= _e577.member_1);
                                    phi_1060_ = _e590;
                                }
                                let _e616 = phi_1058_;
                                let _e618 = phi_1059_;
                                let _e620 = phi_1060_;
                                if _e618 {
                                    if ((_e616.member_1 & 2147483648u) != 0u) {
                                        phi_1078_ = _e577;
                                        phi_1081_ = type_8(0u, ((_e616.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1082 = phi_1078_;
                                            let _e1084 = phi_1081_;
                                            local_11 = _e1082;
                                            if (_e1084.member < _e1084.member_1) {
                                                phi_1082_ = type_8((_e1084.member + 1u), _e1084.member_1);
                                                phi_1104_ = type_8(1u, _e1084.member);
                                            } else {
                                                phi_1082_ = _e1084;
                                                phi_1104_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1097 = phi_1082_;
                                            let _e1099 = phi_1104_;
                                            let _e1103 = (bitcast<i32>(_e1099.member) != 0i);
                                            if _e1103 {
                                                let _e1104 = ((_e616.member_1 & 268435455u) + _e1099.member_1);
                                                let _e1105 = (_e1104 < _e96);
                                                if _e1105 {
                                                    if _e1105 {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1109 = global_4.member[_e1104].member_1;
                                                    phi_1125_ = _e1109;
                                                } else {
                                                    phi_1125_ = 4294967295u;
                                                }
                                                let _e1111 = phi_1125_;
                                                if (_e1104 >= _e96) {
                                                    phi_1214_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1105 {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    if (_e537 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1118 = global_4.member[_e1104].member[_e537];
                                                    if (_e543 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1124 = global_4.member[_e1104].member[_e543];
                                                    if (_e549 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1130 = global_4.member[_e1104].member[_e549];
                                                    let _e1132 = (3u + _e537);
                                                    if (_e1132 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1138 = global_4.member[_e1104].member[_e1132];
                                                    let _e1139 = (3u + _e543);
                                                    if (_e1139 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1145 = global_4.member[_e1104].member[_e1139];
                                                    let _e1146 = (3u + _e549);
                                                    if (_e1146 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1152 = global_4.member[_e1104].member[_e1146];
                                                    let _e1154 = (6u + _e537);
                                                    if (_e1154 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1160 = global_4.member[_e1104].member[_e1154];
                                                    let _e1161 = (6u + _e543);
                                                    if (_e1161 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1167 = global_4.member[_e1104].member[_e1161];
                                                    let _e1168 = (6u + _e549);
                                                    if (_e1168 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1174 = global_4.member[_e1104].member[_e1168];
                                                    phi_1214_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1118, _e1124, _e1130), array<f32, 3>(_e1138, _e1145, _e1152), array<f32, 3>(_e1160, _e1167, _e1174));
                                                }
                                                let _e1178 = phi_1214_;
                                                let _e1186 = (_e1178[0][2] - _e460);
                                                let _e1189 = (((_e1178[0][0] - _e387) * _e484) - (_e1186 * _e412));
                                                let _e1192 = (((_e1178[0][1] - _e424) * _e484) - (_e1186 * _e448));
                                                let _e1199 = (_e1178[1][2] - _e460);
                                                let _e1202 = (((_e1178[1][0] - _e387) * _e484) - (_e1199 * _e412));
                                                let _e1205 = (((_e1178[1][1] - _e424) * _e484) - (_e1199 * _e448));
                                                let _e1212 = (_e1178[2][2] - _e460);
                                                let _e1215 = (((_e1178[2][0] - _e387) * _e484) - (_e1212 * _e412));
                                                let _e1218 = (((_e1178[2][1] - _e424) * _e484) - (_e1212 * _e448));
                                                let _e1219 = (_e1215 * _e1205);
                                                let _e1220 = (_e1218 * _e1202);
                                                let _e1221 = (_e1189 * _e1218);
                                                let _e1222 = (_e1192 * _e1215);
                                                let _e1223 = (_e1202 * _e1192);
                                                let _e1224 = (_e1205 * _e1189);
                                                let _e1229 = (((_e1219 >= _e1220) && (_e1221 >= _e1222)) && (_e1223 >= _e1224));
                                                if (_e1229 || (((_e1219 <= _e1220) && (_e1221 <= _e1222)) && (_e1223 <= _e1224))) {
                                                    let _e1236 = select(-1f, 1f, _e1229);
                                                    let _e1238 = ((_e1219 - _e1220) * _e1236);
                                                    let _e1240 = select(0f, _e1238, (_e1238 > 0f));
                                                    let _e1242 = ((_e1221 - _e1222) * _e1236);
                                                    let _e1244 = select(0f, _e1242, (_e1242 > 0f));
                                                    let _e1246 = ((_e1223 - _e1224) * _e1236);
                                                    let _e1248 = select(0f, _e1246, (_e1246 > 0f));
                                                    let _e1250 = ((_e1240 + _e1244) + _e1248);
                                                    if (_e1250 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1780_ = type_26();
                                                        phi_1781_ = true;
                                                    } else {
                                                        let _e1253 = select(_e1178[1][0], _e1178[0][0], (_e1178[0][0] < _e1178[1][0]));
                                                        let _e1257 = select(_e1178[1][0], _e1178[0][0], (_e1178[0][0] > _e1178[1][0]));
                                                        let _e1261 = select(_e1178[1][1], _e1178[0][1], (_e1178[0][1] < _e1178[1][1]));
                                                        let _e1265 = select(_e1178[1][1], _e1178[0][1], (_e1178[0][1] > _e1178[1][1]));
                                                        let _e1269 = select(_e1178[1][2], _e1178[0][2], (_e1178[0][2] < _e1178[1][2]));
                                                        let _e1273 = select(_e1178[1][2], _e1178[0][2], (_e1178[0][2] > _e1178[1][2]));
                                                        let _e1278 = ((select(_e1178[2][0], _e1253, (_e1253 < _e1178[2][0])) - _e410) * _e415);
                                                        let _e1279 = ((select(_e1178[2][0], _e1257, (_e1257 > _e1178[2][0])) - _e411) * _e415);
                                                        let _e1282 = ((select(_e1178[2][1], _e1261, (_e1261 < _e1178[2][1])) - _e446) * _e451);
                                                        let _e1283 = ((select(_e1178[2][1], _e1265, (_e1265 > _e1178[2][1])) - _e447) * _e451);
                                                        let _e1286 = ((select(_e1178[2][2], _e1269, (_e1269 < _e1178[2][2])) - _e482) * _e487);
                                                        let _e1287 = ((select(_e1178[2][2], _e1273, (_e1273 > _e1178[2][2])) - _e483) * _e487);
                                                        let _e1289 = select(_e1287, _e1286, (_e1286 < _e1287));
                                                        let _e1291 = select(_e1287, _e1286, (_e1286 > _e1287));
                                                        let _e1293 = select(_e1279, _e1278, (_e1278 < _e1279));
                                                        let _e1295 = select(_e1283, _e1282, (_e1282 < _e1283));
                                                        let _e1297 = select(_e1295, _e1293, (_e1293 > _e1295));
                                                        let _e1299 = select(_e1289, _e1297, (_e1297 > _e1289));
                                                        let _e1301 = select(_e1279, _e1278, (_e1278 > _e1279));
                                                        let _e1303 = select(_e1283, _e1282, (_e1282 > _e1283));
                                                        let _e1305 = select(_e1303, _e1301, (_e1301 < _e1303));
                                                        let _e1307 = select(_e1291, _e1305, (_e1305 < _e1291));
                                                        let _e1308 = -(_e1289);
                                                        let _e1314 = select(_e533, _e1299, (_e1299 > _e533));
                                                        if (_e1314 > (_e1307 + (select(_e1308, _e1291, (_e1291 > _e1308)) * 0.0000019073523f))) {
                                                            phi_1775_ = type_26();
                                                            phi_1776_ = true;
                                                        } else {
                                                            let _e1316 = (_e1314 > _e1082.member_1);
                                                            if _e1316 {
                                                                phi_1774_ = type_26();
                                                            } else {
                                                                let _e1320 = (_e1178[1][0] - _e1178[0][0]);
                                                                let _e1321 = (_e1178[1][1] - _e1178[0][1]);
                                                                let _e1322 = (_e1178[1][2] - _e1178[0][2]);
                                                                let _e1323 = vec3<f32>(_e1320, _e1321, _e1322);
                                                                let _e1324 = (_e1178[2][0] - _e1178[1][0]);
                                                                let _e1325 = (_e1178[2][1] - _e1178[1][1]);
                                                                let _e1326 = (_e1178[2][2] - _e1178[1][2]);
                                                                let _e1327 = vec3<f32>(_e1324, _e1325, _e1326);
                                                                let _e1328 = (_e1178[0][0] - _e1178[2][0]);
                                                                let _e1329 = (_e1178[0][1] - _e1178[2][1]);
                                                                let _e1330 = (_e1178[0][2] - _e1178[2][2]);
                                                                let _e1331 = vec3<f32>(_e1328, _e1329, _e1330);
                                                                let _e1334 = bitcast<f32>((bitcast<u32>(_e1320) & 2147483647u));
                                                                let _e1337 = bitcast<f32>((bitcast<u32>(_e1321) & 2147483647u));
                                                                let _e1339 = select(_e1337, _e1334, (_e1334 > _e1337));
                                                                let _e1342 = bitcast<f32>((bitcast<u32>(_e1322) & 2147483647u));
                                                                let _e1344 = select(_e1342, _e1339, (_e1339 > _e1342));
                                                                let _e1347 = bitcast<f32>((bitcast<u32>(_e1324) & 2147483647u));
                                                                let _e1350 = bitcast<f32>((bitcast<u32>(_e1325) & 2147483647u));
                                                                let _e1352 = select(_e1350, _e1347, (_e1347 > _e1350));
                                                                let _e1355 = bitcast<f32>((bitcast<u32>(_e1326) & 2147483647u));
                                                                let _e1357 = select(_e1355, _e1352, (_e1352 > _e1355));
                                                                let _e1360 = bitcast<f32>((bitcast<u32>(_e1328) & 2147483647u));
                                                                let _e1363 = bitcast<f32>((bitcast<u32>(_e1329) & 2147483647u));
                                                                let _e1365 = select(_e1363, _e1360, (_e1360 > _e1363));
                                                                let _e1368 = bitcast<f32>((bitcast<u32>(_e1330) & 2147483647u));
                                                                let _e1370 = select(_e1368, _e1365, (_e1365 > _e1368));
                                                                let _e1372 = select(_e1357, _e1344, (_e1344 > _e1357));
                                                                let _e1374 = select(_e1370, _e1372, (_e1372 > _e1370));
                                                                if (_e1344 == _e1374) {
                                                                    phi_1685_ = _e1327;
                                                                    phi_1686_ = _e1331;
                                                                } else {
                                                                    let _e1377 = vec3((_e1357 == _e1374));
                                                                    phi_1685_ = select(_e1323, _e1331, _e1377);
                                                                    phi_1686_ = select(_e1327, _e1323, _e1377);
                                                                }
                                                                let _e1381 = phi_1685_;
                                                                let _e1383 = phi_1686_;
                                                                let _e1390 = ((_e1381.y * _e1383.z) - (_e1383.y * _e1381.z));
                                                                let _e1395 = ((_e1381.z * _e1383.x) - (_e1383.z * _e1381.x));
                                                                let _e1398 = ((_e1381.x * _e1383.y) - (_e1383.x * _e1381.y));
                                                                if (_e1240 >= _e1244) {
                                                                    phi_1717_ = select(true, false, (_e1240 >= _e1248));
                                                                } else {
                                                                    phi_1717_ = true;
                                                                }
                                                                let _e1403 = phi_1717_;
                                                                if _e1403 {
                                                                    phi_1726_ = select(vec3<f32>(_e1178[2][0], _e1178[2][1], _e1178[2][2]), vec3<f32>(_e1178[1][0], _e1178[1][1], _e1178[1][2]), vec3((_e1244 >= _e1248)));
                                                                } else {
                                                                    phi_1726_ = vec3<f32>(_e1178[0][0], _e1178[0][1], _e1178[0][2]);
                                                                }
                                                                let _e1408 = phi_1726_;
                                                                let _e1425 = ((((_e1390 * (_e1408.x - _e387)) + (_e1395 * (_e1408.y - _e424))) + (_e1398 * (_e1408.z - _e460))) / (((_e1390 * _e412) + (_e1395 * _e448)) + (_e1398 * _e484)));
                                                                let _e1427 = select(_e1307, _e1425, (_e1425 < _e1307));
                                                                let _e1429 = select(_e1299, _e1427, (_e1427 > _e1299));
                                                                if (_e1429 >= _e533) {
                                                                    let _e1431 = (_e1429 <= _e1082.member_1);
                                                                    if _e1431 {
                                                                        let _e1432 = (1f / _e1250);
                                                                        phi_1766_ = type_26(_e1429, (_e1244 * _e1432), (_e1248 * _e1432), _e1111);
                                                                    } else {
                                                                        phi_1766_ = type_26();
                                                                    }
                                                                    let _e1437 = phi_1766_;
                                                                    phi_1768_ = _e1437;
                                                                    phi_1769_ = select(true, false, _e1431);
                                                                } else {
                                                                    phi_1768_ = type_26();
                                                                    phi_1769_ = true;
                                                                }
                                                                let _e1440 = phi_1768_;
                                                                let _e1442 = phi_1769_;
                                                                if _e1442 {
                                                                    phi_1773_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1773_ = _e1440;
                                                                }
                                                                let _e1444 = phi_1773_;
                                                                phi_1774_ = _e1444;
                                                            }
                                                            let _e1446 = phi_1774_;
                                                            phi_1775_ = _e1446;
                                                            phi_1776_ = _e1316;
                                                        }
                                                        let _e1448 = phi_1775_;
                                                        let _e1450 = phi_1776_;
                                                        phi_1780_ = _e1448;
                                                        phi_1781_ = _e1450;
                                                    }
                                                    let _e1452 = phi_1780_;
                                                    let _e1454 = phi_1781_;
                                                    phi_1785_ = _e1452;
                                                    phi_1786_ = _e1454;
                                                } else {
                                                    phi_1785_ = type_26();
                                                    phi_1786_ = true;
                                                }
                                                let _e1456 = phi_1785_;
                                                let _e1458 = phi_1786_;
                                                if _e1458 {
                                                    phi_1790_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1790_ = _e1456;
                                                }
                                                let _e1460 = phi_1790_;
                                                if (_e1460.member_3 != 4294967295u) {
                                                    if (_e1111 == _e161) {
                                                        phi_2119_ = false;
                                                    } else {
                                                        let _e1464 = (_e1111 < arrayLength((&global_5.member)));
                                                        if _e1464 {
                                                            if _e1464 {
                                                            } else {
                                                                phi_3691_ = true;
                                                                break;
                                                            }
                                                            let _e1466 = global_5.member[_e1111];
                                                            phi_1813_ = _e1466;
                                                        } else {
                                                            phi_1813_ = 4294967295u;
                                                        }
                                                        let _e1468 = phi_1813_;
                                                        let _e1469 = (_e1468 < arrayLength((&global_6.member)));
                                                        if _e1469 {
                                                            if _e1469 {
                                                            } else {
                                                                phi_3691_ = true;
                                                                break;
                                                            }
                                                            let _e1471 = global_6.member[_e1468];
                                                            phi_1827_ = _e1471;
                                                        } else {
                                                            phi_1827_ = 0i;
                                                        }
                                                        let _e1473 = phi_1827_;
                                                        let _e1474 = (_e1473 == 0i);
                                                        if _e1474 {
                                                            phi_2118_ = true;
                                                        } else {
                                                            if _e379 {
                                                                phi_1848_ = vec3<f32>(_e1178[0][0], _e1178[0][1], _e1178[0][2]);
                                                            } else {
                                                                if (_e355 == 1u) {
                                                                    phi_1847_ = vec3<f32>(_e1178[0][2], _e1178[0][0], _e1178[0][1]);
                                                                } else {
                                                                    phi_1847_ = vec3<f32>(_e1178[0][1], _e1178[0][2], _e1178[0][0]);
                                                                }
                                                                let _e1479 = phi_1847_;
                                                                phi_1848_ = _e1479;
                                                            }
                                                            let _e1482 = phi_1848_;
                                                            if _e379 {
                                                                phi_1865_ = vec3<f32>(_e1178[1][0], _e1178[1][1], _e1178[1][2]);
                                                            } else {
                                                                if (_e355 == 1u) {
                                                                    phi_1864_ = vec3<f32>(_e1178[1][2], _e1178[1][0], _e1178[1][1]);
                                                                } else {
                                                                    phi_1864_ = vec3<f32>(_e1178[1][1], _e1178[1][2], _e1178[1][0]);
                                                                }
                                                                let _e1487 = phi_1864_;
                                                                phi_1865_ = _e1487;
                                                            }
                                                            let _e1490 = phi_1865_;
                                                            if _e379 {
                                                                phi_1882_ = vec3<f32>(_e1178[2][0], _e1178[2][1], _e1178[2][2]);
                                                            } else {
                                                                if (_e355 == 1u) {
                                                                    phi_1881_ = vec3<f32>(_e1178[2][2], _e1178[2][0], _e1178[2][1]);
                                                                } else {
                                                                    phi_1881_ = vec3<f32>(_e1178[2][1], _e1178[2][2], _e1178[2][0]);
                                                                }
                                                                let _e1495 = phi_1881_;
                                                                phi_1882_ = _e1495;
                                                            }
                                                            let _e1498 = phi_1882_;
                                                            let _e1501 = (_e1490.x - _e1482.x);
                                                            let _e1504 = (_e1490.y - _e1482.y);
                                                            let _e1507 = (_e1490.z - _e1482.z);
                                                            let _e1509 = (_e1498.x - _e1482.x);
                                                            let _e1511 = (_e1498.y - _e1482.y);
                                                            let _e1513 = (_e1498.z - _e1482.z);
                                                            if (_e233.member_1 == 1u) {
                                                                phi_1918_ = (vec3<f32>(_e233.member[0], _e233.member[1], _e233.member[2]) - _e1482);
                                                            } else {
                                                                phi_1918_ = vec3<f32>(_e233.member[0], _e233.member[1], _e233.member[2]);
                                                            }
                                                            let _e1528 = phi_1918_;
                                                            let _e1534 = bitcast<f32>((bitcast<u32>((_e1501 * _e1511)) ^ _e233.member_3[0]));
                                                            let _e1538 = bitcast<f32>((bitcast<u32>((_e1504 * _e1509)) ^ _e233.member_3[0]));
                                                            let _e1542 = bitcast<f32>((bitcast<u32>((_e1504 * _e1513)) ^ _e233.member_3[0]));
                                                            let _e1546 = bitcast<f32>((bitcast<u32>((_e1507 * _e1511)) ^ _e233.member_3[0]));
                                                            let _e1550 = bitcast<f32>((bitcast<u32>((_e1507 * _e1509)) ^ _e233.member_3[0]));
                                                            let _e1554 = bitcast<f32>((bitcast<u32>((_e1501 * _e1513)) ^ _e233.member_3[0]));
                                                            let _e1555 = (_e1542 - _e1546);
                                                            let _e1556 = (_e1550 - _e1554);
                                                            let _e1557 = (_e1534 - _e1538);
                                                            let _e1581 = (bitcast<f32>((bitcast<u32>(_e1542) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1546) & 2147483647u)));
                                                            let _e1588 = (bitcast<f32>((bitcast<u32>(_e1550) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1554) & 2147483647u)));
                                                            let _e1595 = (bitcast<f32>((bitcast<u32>(_e1534) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1538) & 2147483647u)));
                                                            if (_e233.member_2 == 0f) {
                                                                phi_2100_ = 0f;
                                                            } else {
                                                                let _e1625 = bitcast<f32>((bitcast<u32>(_e1555) & 2147483647u));
                                                                let _e1628 = bitcast<f32>((bitcast<u32>(_e1556) & 2147483647u));
                                                                let _e1631 = bitcast<f32>((bitcast<u32>(_e1557) & 2147483647u));
                                                                let _e1633 = select(_e1631, _e1628, (_e1628 > _e1631));
                                                                let _e1637 = select(_e1631, _e1628, (_e1628 < _e1631));
                                                                let _e1641 = select(_e1628, _e1625, (_e1625 < _e1628));
                                                                let _e1643 = select(_e1628, _e1625, (_e1625 > _e1628));
                                                                let _e1645 = select(_e1631, _e1643, (_e1643 < _e1631));
                                                                phi_2100_ = bitcast<f32>((bitcast<u32>((_e233.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1633, _e1625, (_e1625 > _e1633)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1645, _e1641, (_e1641 > _e1645)))) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1637, _e1625, (_e1625 < _e1637)))) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1581 + _e1588) + _e1595))) ^ _e233.member_3[0]))) * 1.0000005f)) ^ _e233.member_3[0])))) ^ _e233.member_3[0]));
                                                            }
                                                            let _e1672 = phi_2100_;
                                                            phi_2118_ = (_e1474 || !(((((bitcast<f32>((bitcast<u32>((_e1528.x * _e1555)) ^ _e233.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1528.y * _e1556)) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1528.z * _e1557)) ^ _e233.member_3[0]))) * f32(-(_e1473))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1528.x) & 2147483647u)) * _e1581)) ^ _e233.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1528.y) & 2147483647u)) * _e1588)) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1528.z) & 2147483647u)) * _e1595)) ^ _e233.member_3[0]))))) ^ _e233.member_3[0])) + _e1672) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1686 = phi_2118_;
                                                        phi_2119_ = _e1686;
                                                    }
                                                    let _e1688 = phi_2119_;
                                                    if _e1688 {
                                                        if (_e1460.member < _e1082.member.member) {
                                                            phi_2139_ = true;
                                                        } else {
                                                            if (_e1460.member == _e1082.member.member) {
                                                                phi_2138_ = (_e1460.member_3 < _e1082.member.member_3);
                                                            } else {
                                                                phi_2138_ = false;
                                                            }
                                                            let _e1698 = phi_2138_;
                                                            phi_2139_ = _e1698;
                                                        }
                                                        let _e1700 = phi_2139_;
                                                        if _e1700 {
                                                            phi_2145_ = type_43(_e1460, _e1460.member);
                                                        } else {
                                                            phi_2145_ = _e1082;
                                                        }
                                                        let _e1703 = phi_2145_;
                                                        phi_2146_ = _e1703;
                                                    } else {
                                                        phi_2146_ = _e1082;
                                                    }
                                                    let _e1705 = phi_2146_;
                                                    phi_2147_ = _e1705;
                                                } else {
                                                    phi_2147_ = _e1082;
                                                }
                                                let _e1707 = phi_2147_;
                                                phi_1079_ = _e1707;
                                            } else {
                                                phi_1079_ = type_43();
                                            }
                                            let _e1709 = phi_1079_;
                                            continue;
                                            continuing {
                                                phi_1078_ = _e1709;
                                                phi_1081_ = _e1097;
                                                phi_3691_ = _e575;
                                                break if !(_e1103);
                                            }
                                        }
                                        let _e1712 = phi_3691_;
                                        phi_3829_ = _e1712;
                                        if _e1712 {
                                            break;
                                        }
                                        phi_3833_ = _e1712;
                                        let _e1927 = local_11;
                                        phi_3352_ = _e1927;
                                        phi_3353_ = _e616;
                                        phi_3354_ = false;
                                        phi_3355_ = _e620;
                                    } else {
                                        if (_e616.member_1 >= _e94) {
                                            phi_2908_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_62(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_62(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e616.member_1 < _e94) {
                                            } else {
                                                phi_3829_ = true;
                                                break;
                                            }
                                            let _e631 = (_e355 * 2u);
                                            let _e633 = ((1u + _e631) % 7u);
                                            if (_e633 < 7u) {
                                            } else {
                                                phi_3829_ = true;
                                                break;
                                            }
                                            let _e638 = global_10.member[_e616.member_1][_e633];
                                            let _e640 = ((_e631 + 2u) % 7u);
                                            if (_e640 < 7u) {
                                            } else {
                                                phi_3829_ = true;
                                                break;
                                            }
                                            let _e645 = global_10.member[_e616.member_1][_e640];
                                            let _e646 = (_e354 * 2u);
                                            let _e648 = ((1u + _e646) % 7u);
                                            if (_e648 < 7u) {
                                            } else {
                                                phi_3829_ = true;
                                                break;
                                            }
                                            let _e653 = global_10.member[_e616.member_1][_e648];
                                            let _e655 = ((_e646 + 2u) % 7u);
                                            if (_e655 < 7u) {
                                            } else {
                                                phi_3829_ = true;
                                                break;
                                            }
                                            let _e660 = global_10.member[_e616.member_1][_e655];
                                            let _e661 = (_e356 * 2u);
                                            let _e663 = ((1u + _e661) % 7u);
                                            if (_e663 < 7u) {
                                            } else {
                                                phi_3829_ = true;
                                                break;
                                            }
                                            let _e668 = global_10.member[_e616.member_1][_e663];
                                            let _e670 = ((_e661 + 2u) % 7u);
                                            if (_e670 < 7u) {
                                            } else {
                                                phi_3829_ = true;
                                                break;
                                            }
                                            let _e675 = global_10.member[_e616.member_1][_e670];
                                            let _e698 = (bitcast<f32>((bitcast<u32>((_e616.member.member_1.x - _e616.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e699 = (bitcast<f32>((bitcast<u32>((_e616.member.member_1.y - _e616.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e700 = (bitcast<f32>((bitcast<u32>((_e616.member.member_1.z - _e616.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e702 = select(_e152, _e698, (_e698 > _e152));
                                            let _e704 = select(_e152, _e699, (_e699 > _e152));
                                            let _e706 = select(_e152, _e700, (_e700 > _e152));
                                            let _e731 = bitcast<u32>((f32(bitcast<i32>((_e638 & 2097151u))) * _e702));
                                            let _e736 = (bitcast<i32>((_e638 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e739 = bitcast<f32>((_e731 & bitcast<u32>(_e736)));
                                            let _e740 = bitcast<u32>((f32(bitcast<i32>((_e653 & 2097151u))) * _e704));
                                            let _e745 = (bitcast<i32>((_e653 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e748 = bitcast<f32>((_e740 & bitcast<u32>(_e745)));
                                            let _e749 = bitcast<u32>((f32(bitcast<i32>((_e668 & 2097151u))) * _e706));
                                            let _e754 = (bitcast<i32>((_e668 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e757 = bitcast<f32>((_e749 & bitcast<u32>(_e754)));
                                            let _e761 = bitcast<f32>((_e731 & bitcast<u32>(~(_e736))));
                                            let _e765 = bitcast<f32>((_e740 & bitcast<u32>(~(_e745))));
                                            let _e769 = bitcast<f32>((_e749 & bitcast<u32>(~(_e754))));
                                            let _e770 = bitcast<u32>((f32(bitcast<i32>((_e645 & 2097151u))) * _e702));
                                            let _e775 = (bitcast<i32>((_e645 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e778 = bitcast<f32>((_e770 & bitcast<u32>(_e775)));
                                            let _e779 = bitcast<u32>((f32(bitcast<i32>((_e660 & 2097151u))) * _e704));
                                            let _e784 = (bitcast<i32>((_e660 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e787 = bitcast<f32>((_e779 & bitcast<u32>(_e784)));
                                            let _e788 = bitcast<u32>((f32(bitcast<i32>((_e675 & 2097151u))) * _e706));
                                            let _e793 = (bitcast<i32>((_e675 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e796 = bitcast<f32>((_e788 & bitcast<u32>(_e793)));
                                            let _e800 = bitcast<f32>((_e770 & bitcast<u32>(~(_e775))));
                                            let _e804 = bitcast<f32>((_e779 & bitcast<u32>(~(_e784))));
                                            let _e808 = bitcast<f32>((_e788 & bitcast<u32>(~(_e793))));
                                            let _e838 = global_10.member[_e616.member_1][0u];
                                            let _e842 = global_10.member[_e616.member_1][2u];
                                            let _e846 = global_10.member[_e616.member_1][4u];
                                            let _e850 = global_10.member[_e616.member_1][6u];
                                            let _e862 = (((_e842 >> bitcast<u32>(22i)) | ((_e846 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e850 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e863 = (_e838 & 268435455u);
                                            let _e864 = (_e862 & 268435455u);
                                            let _e867 = ((_e838 >> bitcast<u32>(28u)) & 7u);
                                            let _e875 = ((_e838 >> bitcast<u32>(31i)) | (((_e862 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e876 = (_e867 != 0u);
                                            if (_e867 == 0u) {
                                                phi_2870_ = _e863;
                                            } else {
                                                if (_e867 == 7u) {
                                                    phi_2869_ = 2147483648u;
                                                } else {
                                                    phi_2869_ = ((2147483648u | (_e867 << bitcast<u32>(28u))) | (_e864 & 268435455u));
                                                }
                                                let _e885 = phi_2869_;
                                                phi_2870_ = _e885;
                                            }
                                            let _e887 = phi_2870_;
                                            if _e876 {
                                                let _e888 = (_e867 != 7u);
                                                if _e888 {
                                                    phi_2880_ = (_e864 + _e867);
                                                } else {
                                                    phi_2880_ = u32();
                                                }
                                                let _e891 = phi_2880_;
                                                phi_2882_ = _e891;
                                                phi_2883_ = select(true, false, _e888);
                                            } else {
                                                phi_2882_ = u32();
                                                phi_2883_ = true;
                                            }
                                            let _e894 = phi_2882_;
                                            let _e896 = phi_2883_;
                                            if (_e875 == 0u) {
                                                phi_2904_ = (_e863 + select(0u, 1u, !(_e876)));
                                            } else {
                                                if (_e875 == 7u) {
                                                    phi_2903_ = 2147483648u;
                                                } else {
                                                    phi_2903_ = ((2147483648u | (_e875 << bitcast<u32>(28u))) | (select(_e894, _e864, _e896) & 268435455u));
                                                }
                                                let _e909 = phi_2903_;
                                                phi_2904_ = _e909;
                                            }
                                            let _e911 = phi_2904_;
                                            phi_2908_ = type_63(array<vec4<f32>, 3>(vec4<f32>((_e616.member.member.x + _e739), (_e616.member.member.x + _e761), (_e616.member.member_1.x - _e778), (_e616.member.member_1.x - _e800)), vec4<f32>((_e616.member.member.y + _e748), (_e616.member.member.y + _e765), (_e616.member.member_1.y - _e787), (_e616.member.member_1.y - _e804)), vec4<f32>((_e616.member.member.z + _e757), (_e616.member.member.z + _e769), (_e616.member.member_1.z - _e796), (_e616.member.member_1.z - _e808))), type_62(type_38((_e616.member.member + vec4<f32>(_e739, _e748, _e757, 0f)), (_e616.member.member_1 - vec4<f32>(_e778, _e787, _e796, 0f))), _e887), type_62(type_38((_e616.member.member + vec4<f32>(_e761, _e765, _e769, 0f)), (_e616.member.member_1 - vec4<f32>(_e800, _e804, _e808, 0f))), _e911));
                                        }
                                        let _e916 = phi_2908_;
                                        let _e928 = ((_e916.member[0].x - _e410) * _e415);
                                        let _e929 = ((_e916.member[0].y - _e410) * _e415);
                                        let _e930 = ((_e916.member[0].z - _e411) * _e415);
                                        let _e931 = ((_e916.member[0].w - _e411) * _e415);
                                        let _e941 = ((_e916.member[1].x - _e446) * _e451);
                                        let _e942 = ((_e916.member[1].y - _e446) * _e451);
                                        let _e943 = ((_e916.member[1].z - _e447) * _e451);
                                        let _e944 = ((_e916.member[1].w - _e447) * _e451);
                                        let _e954 = ((_e916.member[2].x - _e482) * _e487);
                                        let _e955 = ((_e916.member[2].y - _e482) * _e487);
                                        let _e956 = ((_e916.member[2].z - _e483) * _e487);
                                        let _e957 = ((_e916.member[2].w - _e483) * _e487);
                                        let _e959 = select(_e956, _e954, (_e954 < _e956));
                                        let _e961 = select(_e957, _e955, (_e955 < _e957));
                                        let _e963 = select(_e956, _e954, (_e954 > _e956));
                                        let _e965 = select(_e957, _e955, (_e955 > _e957));
                                        let _e967 = select(_e930, _e928, (_e928 < _e930));
                                        let _e969 = select(_e931, _e929, (_e929 < _e931));
                                        let _e971 = select(_e943, _e941, (_e941 < _e943));
                                        let _e973 = select(_e944, _e942, (_e942 < _e944));
                                        let _e975 = select(_e971, _e967, (_e967 > _e971));
                                        let _e977 = select(_e973, _e969, (_e969 > _e973));
                                        let _e979 = select(_e959, _e975, (_e975 > _e959));
                                        let _e981 = select(_e961, _e977, (_e977 > _e961));
                                        let _e983 = select(_e930, _e928, (_e928 > _e930));
                                        let _e985 = select(_e931, _e929, (_e929 > _e931));
                                        let _e987 = select(_e943, _e941, (_e941 > _e943));
                                        let _e989 = select(_e944, _e942, (_e942 > _e944));
                                        let _e991 = select(_e987, _e983, (_e983 < _e987));
                                        let _e993 = select(_e989, _e985, (_e985 < _e989));
                                        let _e998 = -(_e959);
                                        let _e999 = -(_e961);
                                        let _e1006 = (select(_e963, _e991, (_e991 < _e963)) + (select(_e998, _e963, (_e963 > _e998)) * 0.0000019073523f));
                                        let _e1007 = (select(_e965, _e993, (_e993 < _e965)) + (select(_e999, _e965, (_e965 > _e999)) * 0.0000019073523f));
                                        let _e1009 = select(_e533, _e979, (_e979 > _e533));
                                        let _e1011 = select(_e533, _e981, (_e981 > _e533));
                                        let _e1016 = (_e1009 <= select(_e577.member_1, _e1006, (_e1006 < _e577.member_1)));
                                        let _e1017 = (_e1011 <= select(_e577.member_1, _e1007, (_e1007 < _e577.member_1)));
                                        let _e1018 = (_e1009 <= _e1011);
                                        if _e1016 {
                                            if _e1017 {
                                                if _e1018 {
                                                    phi_3252_ = _e916.member_2;
                                                } else {
                                                    phi_3252_ = _e916.member_1;
                                                }
                                                let _e1022 = phi_3252_;
                                                let _e1044 = (_e620 % 128u);
                                                let _e1045 = (_e1044 < 128u);
                                                if _e1045 {
                                                } else {
                                                    phi_3829_ = true;
                                                    break;
                                                }
                                                local_8[_e1044] = _e1022.member_1;
                                                if _e1045 {
                                                } else {
                                                    phi_3829_ = true;
                                                    break;
                                                }
                                                local_7[_e1044] = _e1022.member.member.x;
                                                if _e1045 {
                                                } else {
                                                    phi_3829_ = true;
                                                    break;
                                                }
                                                local_6[_e1044] = _e1022.member.member.y;
                                                if _e1045 {
                                                } else {
                                                    phi_3829_ = true;
                                                    break;
                                                }
                                                local_5[_e1044] = _e1022.member.member.z;
                                                if _e1045 {
                                                } else {
                                                    phi_3829_ = true;
                                                    break;
                                                }
                                                local_4[_e1044] = _e1022.member.member_1.x;
                                                if _e1045 {
                                                } else {
                                                    phi_3829_ = true;
                                                    break;
                                                }
                                                local_3[_e1044] = _e1022.member.member_1.y;
                                                if _e1045 {
                                                } else {
                                                    phi_3829_ = true;
                                                    break;
                                                }
                                                local_2[_e1044] = _e1022.member.member_1.z;
                                                if _e1045 {
                                                } else {
                                                    phi_3829_ = true;
                                                    break;
                                                }
                                                local_9[_e1044] = select(_e1011, _e1009, (_e1009 > _e1011));
                                                if _e1018 {
                                                    phi_3329_ = _e916.member_1;
                                                } else {
                                                    phi_3329_ = _e916.member_2;
                                                }
                                                let _e1058 = phi_3329_;
                                                phi_3330_ = _e1058;
                                                phi_3331_ = (_e620 + 1u);
                                            } else {
                                                phi_3330_ = type_62();
                                                phi_3331_ = u32();
                                            }
                                            let _e1060 = phi_3330_;
                                            let _e1062 = phi_3331_;
                                            phi_3333_ = _e1060;
                                            phi_3334_ = _e1062;
                                            phi_3335_ = select(true, false, _e1017);
                                        } else {
                                            phi_3333_ = type_62();
                                            phi_3334_ = u32();
                                            phi_3335_ = true;
                                        }
                                        let _e1065 = phi_3333_;
                                        let _e1067 = phi_3334_;
                                        let _e1069 = phi_3335_;
                                        if _e1069 {
                                            if _e1016 {
                                                phi_3344_ = _e916.member_1;
                                            } else {
                                                phi_3344_ = _e916.member_2;
                                            }
                                            let _e1073 = phi_3344_;
                                            phi_3349_ = _e1073;
                                            phi_3350_ = select(_e1017, true, _e1016);
                                        } else {
                                            phi_3349_ = _e1065;
                                            phi_3350_ = _e618;
                                        }
                                        let _e1076 = phi_3349_;
                                        let _e1078 = phi_3350_;
                                        phi_3833_ = _e575;
                                        phi_3352_ = _e577;
                                        phi_3353_ = _e1076;
                                        phi_3354_ = _e1078;
                                        phi_3355_ = select(_e1067, _e620, _e1069);
                                    }
                                    let _e1714 = phi_3833_;
                                    let _e1716 = phi_3352_;
                                    let _e1718 = phi_3353_;
                                    let _e1720 = phi_3354_;
                                    let _e1722 = phi_3355_;
                                    phi_3832_ = _e1714;
                                    phi_3356_ = _e1716;
                                    phi_3357_ = _e1718;
                                    phi_3358_ = (_e581 - 1u);
                                    phi_3359_ = _e1720;
                                    phi_3360_ = _e1722;
                                } else {
                                    phi_3832_ = _e575;
                                    phi_3356_ = _e577;
                                    phi_3357_ = _e616;
                                    phi_3358_ = _e581;
                                    phi_3359_ = _e618;
                                    phi_3360_ = _e620;
                                }
                                let _e1724 = phi_3832_;
                                let _e1726 = phi_3356_;
                                let _e1728 = phi_3357_;
                                let _e1730 = phi_3358_;
                                let _e1732 = phi_3359_;
                                let _e1734 = phi_3360_;
                                phi_3831_ = _e1724;
                                phi_3361_ = _e1726;
                                phi_3362_ = _e1728;
                                phi_3363_ = _e1730;
                                phi_3364_ = _e1732;
                                phi_3365_ = _e1734;
                            } else {
                                phi_3831_ = _e575;
                                phi_3361_ = type_43();
                                phi_3362_ = type_62();
                                phi_3363_ = u32();
                                phi_3364_ = bool();
                                phi_3365_ = u32();
                            }
                            let _e1736 = phi_3831_;
                            let _e1738 = phi_3361_;
                            let _e1740 = phi_3362_;
                            let _e1742 = phi_3363_;
                            let _e1744 = phi_3364_;
                            let _e1746 = phi_3365_;
                            phi_3830_ = _e1736;
                            phi_953_ = _e1738;
                            phi_956_ = _e1740;
                            phi_958_ = _e1742;
                            phi_960_ = _e1744;
                            phi_962_ = _e1746;
                            phi_3366_ = _e589;
                        } else {
                            phi_3830_ = _e575;
                            phi_953_ = type_43();
                            phi_956_ = type_62();
                            phi_958_ = u32();
                            phi_960_ = bool();
                            phi_962_ = u32();
                            phi_3366_ = false;
                        }
                        let _e1748 = phi_3830_;
                        let _e1750 = phi_953_;
                        let _e1752 = phi_956_;
                        let _e1754 = phi_958_;
                        let _e1756 = phi_960_;
                        let _e1758 = phi_962_;
                        let _e1760 = phi_3366_;
                        continue;
                        continuing {
                            phi_3697_ = _e1748;
                            phi_952_ = _e1750;
                            phi_955_ = _e1752;
                            phi_957_ = _e1754;
                            phi_959_ = _e1756;
                            phi_961_ = _e1758;
                            phi_3829_ = _e1748;
                            break if !(_e1760);
                        }
                    }
                    let _e1763 = phi_3829_;
                    if _e1763 {
                        break;
                    }
                    let _e1765 = local_10;
                    if (_e1765.member.member_3 != 4294967295u) {
                        let _e1770 = (_e357 / 3i);
                        let _e1777 = bitcast<f32>((bitcast<u32>((_e1770 + 127i)) << bitcast<u32>(23i)));
                        let _e1785 = (((_e1765.member.member * _e1777) * _e1777) * bitcast<f32>((bitcast<u32>(((_e357 - (2i * _e1770)) + 127i)) << bitcast<u32>(23i))));
                        let _e1787 = select(340282350000000000000000000000000000000f, _e1785, (_e1785 < 340282350000000000000000000000000000000f));
                        phi_3418_ = type_26(select(-340282350000000000000000000000000000000f, _e1787, (_e1787 > -340282350000000000000000000000000000000f)), _e1765.member.member_1, _e1765.member.member_2, _e1765.member.member_3);
                    } else {
                        phi_3418_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1794 = phi_3418_;
                    if _e234 {
                    } else {
                        break;
                    }
                    global_8.member[_e140] = _e1794;
                    if _e155 {
                    } else {
                        break;
                    }
                    let _e1798 = select(0u, 1u, (_e301 <= _e311));
                    if (_e1798 > 0u) {
                        let _e1800 = (1u < _e108);
                        if _e1800 {
                            if (0u < _e108) {
                            } else {
                                break;
                            }
                            let _e1804 = atomicAdd((&global_9.member[0u]), _e1798);
                            if ((_e1804 + _e1798) < _e1804) {
                                if _e1800 {
                                } else {
                                    break;
                                }
                                let _e1809 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1812 = select(0u, 1u, (_e1794.member_3 != 4294967295u));
                    if (_e1812 > 0u) {
                        let _e1814 = (3u < _e108);
                        if _e1814 {
                            if (2u < _e108) {
                            } else {
                                break;
                            }
                            let _e1818 = atomicAdd((&global_9.member[2u]), _e1812);
                            if ((_e1818 + _e1812) < _e1818) {
                                if _e1814 {
                                } else {
                                    break;
                                }
                                let _e1823 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
