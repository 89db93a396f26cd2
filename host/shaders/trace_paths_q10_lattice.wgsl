struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
}

struct type_16 {
    member: vec4<u32>,
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
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_42 {
    member: type_25,
    member_1: f32,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: array<i32>,
}

struct type_59 {
    member: type_37,
    member_1: u32,
}

struct type_62 {
    member: array<vec4<f32>, 3>,
    member_1: type_59,
    member_2: type_59,
}

struct type_69 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_46;
@group(0) @binding(2) 
var<uniform> global_3: type_46;
@group(0) @binding(3) 
var<storage> global_4: type_13;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_49;
@group(0) @binding(7) 
var<storage> global_7: type_32;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_27;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_69;
@group(0) @binding(4) 
var<storage> global_10: type_4;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_59, 128>;
    var local_4: array<u32, 3>;
    var local_5: array<array<f32, 3>, 3>;
    var local_6: array<f32, 4>;
    var phi_341_: u32;
    var phi_385_: i32;
    var phi_409_: type_40;
    var phi_515_: i32;
    var phi_516_: i32;
    var phi_526_: bool;
    var phi_536_: u32;
    var phi_537_: u32;
    var phi_539_: bool;
    var phi_544_: u32;
    var phi_577_: i32;
    var phi_595_: f32;
    var phi_601_: f32;
    var phi_612_: f32;
    var phi_618_: f32;
    var phi_641_: f32;
    var phi_652_: f32;
    var phi_661_: f32;
    var phi_667_: f32;
    var phi_678_: f32;
    var phi_684_: f32;
    var phi_707_: f32;
    var phi_718_: f32;
    var phi_727_: f32;
    var phi_733_: f32;
    var phi_744_: f32;
    var phi_750_: f32;
    var phi_773_: f32;
    var phi_784_: f32;
    var phi_884_: f32;
    var phi_885_: f32;
    var phi_5064_: bool;
    var phi_2005_: type_42;
    var phi_2008_: type_59;
    var phi_2010_: u32;
    var phi_2012_: bool;
    var phi_2014_: u32;
    var phi_2025_: bool;
    var phi_2062_: type_59;
    var phi_2063_: bool;
    var phi_2064_: u32;
    var phi_4011_: u32;
    var phi_4017_: u32;
    var phi_4271_: u32;
    var phi_4272_: u32;
    var phi_4282_: u32;
    var phi_4284_: u32;
    var phi_4285_: bool;
    var phi_4305_: u32;
    var phi_4306_: u32;
    var phi_4310_: type_62;
    var phi_4654_: type_59;
    var phi_4687_: type_59;
    var phi_4688_: type_59;
    var phi_4689_: u32;
    var phi_4691_: type_59;
    var phi_4692_: u32;
    var phi_4693_: bool;
    var phi_4702_: type_59;
    var phi_4707_: type_59;
    var phi_4708_: bool;
    var phi_5061_: bool;
    var phi_2083_: type_42;
    var phi_2086_: type_8;
    var phi_2087_: type_8;
    var phi_2109_: type_8;
    var phi_2150_: u32;
    var phi_2156_: u32;
    var phi_2166_: u32;
    var phi_2182_: u32;
    var phi_2219_: u32;
    var phi_2225_: u32;
    var phi_2235_: u32;
    var phi_5046_: bool;
    var phi_2251_: type_8;
    var phi_2252_: type_8;
    var phi_2275_: type_8;
    var phi_2298_: u32;
    var phi_2313_: u32;
    var phi_2316_: type_8;
    var phi_2317_: type_8;
    var phi_2340_: type_8;
    var phi_2406_: u32;
    var phi_2386_: u32;
    var phi_2387_: u32;
    var phi_2410_: f32;
    var phi_5039_: bool;
    var phi_5122_: bool;
    var phi_5121_: bool;
    var phi_2910_: vec3<f32>;
    var phi_2911_: vec3<f32>;
    var phi_2942_: bool;
    var phi_2951_: vec3<f32>;
    var phi_2991_: type_25;
    var phi_2993_: type_25;
    var phi_2994_: bool;
    var phi_2998_: type_25;
    var phi_2999_: type_25;
    var phi_3000_: type_25;
    var phi_3001_: bool;
    var phi_3005_: type_25;
    var phi_3006_: bool;
    var phi_3010_: type_25;
    var phi_3011_: bool;
    var phi_3015_: type_25;
    var phi_3038_: u32;
    var phi_3052_: i32;
    var phi_3072_: vec3<f32>;
    var phi_3073_: vec3<f32>;
    var phi_3089_: vec3<f32>;
    var phi_3090_: vec3<f32>;
    var phi_3106_: vec3<f32>;
    var phi_3107_: vec3<f32>;
    var phi_3143_: vec3<f32>;
    var phi_3325_: f32;
    var phi_3343_: bool;
    var phi_3344_: bool;
    var phi_3363_: bool;
    var phi_3364_: bool;
    var phi_3370_: type_42;
    var phi_3371_: type_42;
    var phi_3372_: type_42;
    var phi_5124_: bool;
    var phi_2084_: type_42;
    var phi_5123_: bool;
    var phi_5206_: bool;
    var phi_4710_: type_42;
    var phi_4711_: type_59;
    var phi_4712_: bool;
    var phi_4713_: u32;
    var phi_5205_: bool;
    var phi_4714_: type_42;
    var phi_4715_: type_59;
    var phi_4716_: u32;
    var phi_4717_: bool;
    var phi_4718_: u32;
    var phi_5204_: bool;
    var phi_4719_: type_42;
    var phi_4720_: type_59;
    var phi_4721_: u32;
    var phi_4722_: bool;
    var phi_4723_: u32;
    var phi_5203_: bool;
    var phi_2006_: type_42;
    var phi_2009_: type_59;
    var phi_2011_: u32;
    var phi_2013_: bool;
    var phi_2015_: u32;
    var phi_4724_: bool;
    var phi_5202_: bool;
    var local_7: type_42;
    var phi_4776_: type_25;
    var local_8: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e98 = global;
            let _e100 = arrayLength((&global_4.member));
            let _e103 = arrayLength((&global_10.member));
            let _e115 = arrayLength((&global_9.member));
            let _e119 = global_3.member[0u][0u];
            let _e123 = global_3.member[0u][1u];
            let _e127 = global_3.member[0u][2u];
            let _e131 = global_3.member[0u][3u];
            let _e135 = global_3.member[1u][0u];
            let _e139 = global_3.member[1u][1u];
            let _e143 = global_3.member[1u][2u];
            let _e147 = (_e98.x + (_e98.y * 2097152u));
            let _e159 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e131) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e119), bitcast<i32>(_e123), bitcast<i32>(_e127));
            local = array<i32, 3>(bitcast<i32>(_e135), bitcast<i32>(_e139), bitcast<i32>(_e143));
            let _e162 = (_e147 < arrayLength((&global_7.member)));
            if _e162 {
                if _e162 {
                } else {
                    break;
                }
                let _e166 = global_7.member[_e147].member_2;
                phi_341_ = _e166;
            } else {
                phi_341_ = 4294967295u;
            }
            let _e168 = phi_341_;
            let _e171 = global_1.member[0u];
            let _e175 = global_2.member[0u][0u];
            let _e179 = global_2.member[0u][1u];
            let _e183 = global_2.member[0u][2u];
            let _e187 = global_2.member[0u][3u];
            let _e191 = global_2.member[1u][0u];
            let _e195 = global_2.member[1u][1u];
            let _e199 = global_2.member[1u][2u];
            let _e203 = global_2.member[1u][3u];
            let _e204 = bitcast<f32>(_e175);
            let _e205 = bitcast<f32>(_e179);
            let _e206 = bitcast<f32>(_e183);
            let _e208 = bitcast<f32>(_e191);
            let _e209 = array<u32, 3>(_e195, _e199, _e203);
            let _e211 = bitcast<i32>(_e171);
            if (_e211 < -126i) {
                phi_385_ = -126i;
            } else {
                phi_385_ = select(_e211, 127i, (_e211 > 127i));
            }
            let _e216 = phi_385_;
            let _e221 = bitcast<f32>((bitcast<u32>((_e216 + 127i)) << bitcast<u32>(23i)));
            let _e227 = bitcast<f32>((bitcast<u32>(((_e211 - _e216) + 127i)) << bitcast<u32>(23i)));
            if (_e187 == 0u) {
                phi_409_ = type_40(array<f32, 3>(_e204, _e205, _e206), _e187, _e208, _e209);
            } else {
                phi_409_ = type_40(array<f32, 3>(((_e204 * _e221) * _e227), ((_e205 * _e221) * _e227), ((_e206 * _e221) * _e227)), _e187, ((_e208 * _e221) * _e227), _e209);
            }
            let _e240 = phi_409_;
            if _e162 {
                let _e241 = (_e147 < arrayLength((&global_8.member)));
                if _e241 {
                    if _e162 {
                    } else {
                        break;
                    }
                    let _e251 = global_7.member[_e147].member.member_2[0u];
                    let _e253 = (bitcast<u32>(_e251) & 2147483647u);
                    let _e259 = global_7.member[_e147].member.member_2[1u];
                    let _e261 = (bitcast<u32>(_e259) & 2147483647u);
                    let _e267 = global_7.member[_e147].member.member_2[2u];
                    let _e269 = (bitcast<u32>(_e267) & 2147483647u);
                    let _e275 = global_7.member[_e147].member.member[0u];
                    let _e277 = (bitcast<u32>(_e275) & 2147483647u);
                    let _e283 = global_7.member[_e147].member.member[1u];
                    let _e285 = (bitcast<u32>(_e283) & 2147483647u);
                    let _e291 = global_7.member[_e147].member.member[2u];
                    let _e293 = (bitcast<u32>(_e291) & 2147483647u);
                    let _e295 = select(_e261, _e253, (_e261 < _e253));
                    let _e297 = select(_e269, _e295, (_e269 < _e295));
                    let _e299 = select(_e277, _e297, (_e277 < _e297));
                    let _e301 = select(_e285, _e299, (_e285 < _e299));
                    let _e303 = select(_e293, _e301, (_e293 < _e301));
                    let _e308 = global_7.member[_e147].member.member_1;
                    let _e310 = (bitcast<u32>(_e308) & 2147483647u);
                    let _e318 = global_7.member[_e147].member.member_3;
                    let _e324 = (((select(_e310, _e303, (_e310 < _e303)) < 2139095040u) && ((bitcast<u32>(_e318) & 2147483647u) <= 2139095040u)) && (_e297 > 0u));
                    if _e324 {
                        let _e327 = (bitcast<u32>(bitcast<f32>(_e297)) & 2147483647u);
                        if (_e327 >= 8388608u) {
                            phi_515_ = (bitcast<i32>((_e327 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_515_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e327)), 32u, (_e327 == 0u))));
                        }
                        let _e341 = phi_515_;
                        phi_516_ = _e341;
                    } else {
                        phi_516_ = 0i;
                    }
                    let _e343 = phi_516_;
                    let _e344 = (_e253 == _e297);
                    if _e344 {
                        phi_526_ = true;
                    } else {
                        phi_526_ = (_e261 == _e297);
                    }
                    let _e347 = phi_526_;
                    let _e348 = select(1u, 0u, _e344);
                    if _e347 {
                        let _e349 = (_e348 + 1u);
                        phi_536_ = _e349;
                        phi_537_ = _e349;
                        phi_539_ = select(true, false, (_e349 == 2u));
                    } else {
                        phi_536_ = u32();
                        phi_537_ = 0u;
                        phi_539_ = true;
                    }
                    let _e353 = phi_536_;
                    let _e355 = phi_537_;
                    let _e357 = phi_539_;
                    if _e357 {
                        phi_544_ = (_e355 + 1u);
                    } else {
                        phi_544_ = 0u;
                    }
                    let _e361 = phi_544_;
                    let _e362 = select(_e353, _e355, _e357);
                    let _e363 = select(_e348, select(2u, _e348, _e347), _e357);
                    let _e364 = -(_e343);
                    if (_e364 < -126i) {
                        phi_577_ = -126i;
                    } else {
                        phi_577_ = select(_e364, 127i, (_e364 > 127i));
                    }
                    let _e369 = phi_577_;
                    let _e374 = bitcast<f32>((bitcast<u32>((_e369 + 127i)) << bitcast<u32>(23i)));
                    let _e380 = bitcast<f32>((bitcast<u32>(((_e364 - _e369) + 127i)) << bitcast<u32>(23i)));
                    let _e385 = global_7.member[_e147].member.member;
                    let _e386 = (_e362 == 0u);
                    if _e386 {
                        phi_595_ = _e385[0];
                    } else {
                        phi_595_ = _e385[1];
                    }
                    let _e390 = phi_595_;
                    let _e391 = (_e362 == 2u);
                    if _e391 {
                        phi_601_ = _e385[2];
                    } else {
                        phi_601_ = _e390;
                    }
                    let _e394 = phi_601_;
                    let _e395 = global_7.member[_e147].member.member_2;
                    if _e386 {
                        phi_612_ = _e395[0];
                    } else {
                        phi_612_ = _e395[1];
                    }
                    let _e399 = phi_612_;
                    if _e391 {
                        phi_618_ = _e395[2];
                    } else {
                        phi_618_ = _e399;
                    }
                    let _e402 = phi_618_;
                    let _e404 = ((_e402 * _e374) * _e380);
                    let _e408 = (bitcast<f32>((bitcast<u32>(_e404) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e408 {
                        let _e412 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) * 0.00000011920929f);
                        phi_641_ = select(0.00000000000011368684f, _e412, (_e412 > 0.00000000000011368684f));
                    } else {
                        phi_641_ = 0f;
                    }
                    let _e416 = phi_641_;
                    let _e417 = (_e394 + _e416);
                    let _e418 = (_e394 - _e416);
                    let _e419 = select(_e404, 0f, _e408);
                    if _e408 {
                        phi_652_ = 38685626000000000000000000f;
                    } else {
                        phi_652_ = (1f / _e404);
                    }
                    let _e422 = phi_652_;
                    let _e423 = (_e361 == 0u);
                    if _e423 {
                        phi_661_ = _e385[0];
                    } else {
                        phi_661_ = _e385[1];
                    }
                    let _e427 = phi_661_;
                    let _e428 = (_e361 == 2u);
                    if _e428 {
                        phi_667_ = _e385[2];
                    } else {
                        phi_667_ = _e427;
                    }
                    let _e431 = phi_667_;
                    if _e423 {
                        phi_678_ = _e395[0];
                    } else {
                        phi_678_ = _e395[1];
                    }
                    let _e435 = phi_678_;
                    if _e428 {
                        phi_684_ = _e395[2];
                    } else {
                        phi_684_ = _e435;
                    }
                    let _e438 = phi_684_;
                    let _e440 = ((_e438 * _e374) * _e380);
                    let _e444 = (bitcast<f32>((bitcast<u32>(_e440) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e444 {
                        let _e448 = (bitcast<f32>((bitcast<u32>(_e431) & 2147483647u)) * 0.00000011920929f);
                        phi_707_ = select(0.00000000000011368684f, _e448, (_e448 > 0.00000000000011368684f));
                    } else {
                        phi_707_ = 0f;
                    }
                    let _e452 = phi_707_;
                    let _e453 = (_e431 + _e452);
                    let _e454 = (_e431 - _e452);
                    let _e455 = select(_e440, 0f, _e444);
                    if _e444 {
                        phi_718_ = 38685626000000000000000000f;
                    } else {
                        phi_718_ = (1f / _e440);
                    }
                    let _e458 = phi_718_;
                    let _e459 = (_e363 == 0u);
                    if _e459 {
                        phi_727_ = _e385[0];
                    } else {
                        phi_727_ = _e385[1];
                    }
                    let _e463 = phi_727_;
                    let _e464 = (_e363 == 2u);
                    if _e464 {
                        phi_733_ = _e385[2];
                    } else {
                        phi_733_ = _e463;
                    }
                    let _e467 = phi_733_;
                    if _e459 {
                        phi_744_ = _e395[0];
                    } else {
                        phi_744_ = _e395[1];
                    }
                    let _e471 = phi_744_;
                    if _e464 {
                        phi_750_ = _e395[2];
                    } else {
                        phi_750_ = _e471;
                    }
                    let _e474 = phi_750_;
                    let _e476 = ((_e474 * _e374) * _e380);
                    let _e480 = (bitcast<f32>((bitcast<u32>(_e476) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e480 {
                        let _e484 = (bitcast<f32>((bitcast<u32>(_e467) & 2147483647u)) * 0.00000011920929f);
                        phi_773_ = select(0.00000000000011368684f, _e484, (_e484 > 0.00000000000011368684f));
                    } else {
                        phi_773_ = 0f;
                    }
                    let _e488 = phi_773_;
                    let _e489 = (_e467 + _e488);
                    let _e490 = (_e467 - _e488);
                    let _e491 = select(_e476, 0f, _e480);
                    if _e480 {
                        phi_784_ = 38685626000000000000000000f;
                    } else {
                        phi_784_ = (1f / _e476);
                    }
                    let _e494 = phi_784_;
                    let _e497 = bitcast<f32>((bitcast<u32>(_e394) & 2147483647u));
                    let _e500 = bitcast<f32>((bitcast<u32>(_e431) & 2147483647u));
                    let _e502 = select(_e500, _e497, (_e497 > _e500));
                    let _e505 = bitcast<f32>((bitcast<u32>(_e467) & 2147483647u));
                    if (_e324 && (select(_e505, _e502, (_e502 > _e505)) <= 1099511600000f)) {
                        let _e510 = (_e343 / 3i);
                        let _e517 = bitcast<f32>((bitcast<u32>((_e510 + 127i)) << bitcast<u32>(23i)));
                        let _e524 = bitcast<f32>((bitcast<u32>(((_e343 - (2i * _e510)) + 127i)) << bitcast<u32>(23i)));
                        let _e525 = (((_e308 * _e517) * _e517) * _e524);
                        let _e527 = select(340282350000000000000000000000000000000f, _e525, (_e525 < 340282350000000000000000000000000000000f));
                        let _e532 = (((_e318 * _e517) * _e517) * _e524);
                        let _e534 = select(340282350000000000000000000000000000000f, _e532, (_e532 < 340282350000000000000000000000000000000f));
                        phi_884_ = select(-340282350000000000000000000000000000000f, _e534, (_e534 > -340282350000000000000000000000000000000f));
                        phi_885_ = select(-340282350000000000000000000000000000000f, _e527, (_e527 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_884_ = 0f;
                        phi_885_ = 1f;
                    }
                    let _e538 = phi_884_;
                    let _e540 = phi_885_;
                    local_3 = array<type_59, 128>(type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e544 = (_e362 % 3u);
                    let _e545 = (_e544 < 3u);
                    if _e545 {
                    } else {
                        break;
                    }
                    let _e547 = local_1[_e544];
                    let _e550 = (_e361 % 3u);
                    let _e551 = (_e550 < 3u);
                    if _e551 {
                    } else {
                        break;
                    }
                    let _e553 = local_1[_e550];
                    let _e556 = (_e363 % 3u);
                    let _e557 = (_e556 < 3u);
                    if _e557 {
                    } else {
                        break;
                    }
                    let _e559 = local_1[_e556];
                    if _e545 {
                    } else {
                        break;
                    }
                    let _e564 = local[_e544];
                    if _e551 {
                    } else {
                        break;
                    }
                    let _e568 = local[_e550];
                    if _e557 {
                    } else {
                        break;
                    }
                    let _e572 = local[_e556];
                    phi_5064_ = false;
                    phi_2005_ = type_42(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e538);
                    phi_2008_ = type_59(type_37(vec4<f32>((f32(_e547) * _e159), (f32(_e553) * _e159), (f32(_e559) * _e159), 0f), vec4<f32>((f32(_e564) * _e159), (f32(_e568) * _e159), (f32(_e572) * _e159), 0f)), select(0u, 2147483648u, (_e100 == 0u)));
                    phi_2010_ = ((3u * _e100) + 1u);
                    phi_2012_ = (_e540 <= _e538);
                    phi_2014_ = 0u;
                    loop {
                        let _e582 = phi_5064_;
                        let _e584 = phi_2005_;
                        let _e586 = phi_2008_;
                        let _e588 = phi_2010_;
                        let _e590 = phi_2012_;
                        let _e592 = phi_2014_;
                        local_7 = _e584;
                        if _e590 {
                            phi_2025_ = true;
                        } else {
                            phi_2025_ = (_e592 > 0u);
                        }
                        let _e595 = phi_2025_;
                        if _e595 {
                            let _e596 = (_e588 > 0u);
                            if _e596 {
                                if _e590 {
                                    phi_2062_ = _e586;
                                    phi_2063_ = _e590;
                                    phi_2064_ = _e592;
                                } else {
                                    let _e597 = (_e592 - 1u);
                                    let _e598 = (_e597 % 128u);
                                    let _e599 = (_e598 < 128u);
                                    if _e599 {
                                    } else {
                                        phi_5202_ = true;
                                        break;
                                    }
                                    let _e601 = local_3[_e598];
                                    if _e599 {
                                    } else {
                                        phi_5202_ = true;
                                        break;
                                    }
                                    let _e609 = local_2[_e598];
                                    phi_2062_ = type_59(type_37(_e601.member.member, _e601.member.member_1), _e601.member_1);
                                    phi_2063_ = (_e609 <= _e584.member_1);
                                    phi_2064_ = _e597;
                                }
                                let _e613 = phi_2062_;
                                let _e615 = phi_2063_;
                                let _e617 = phi_2064_;
                                if _e615 {
                                    let _e622 = (_e613.member_1 & 268435455u);
                                    if ((_e613.member_1 & 2147483648u) != 0u) {
                                        phi_5061_ = _e582;
                                        phi_2083_ = _e584;
                                        phi_2086_ = type_8(0u, ((_e613.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1084 = phi_5061_;
                                            let _e1086 = phi_2083_;
                                            let _e1088 = phi_2086_;
                                            local_8 = _e1086;
                                            if (_e1088.member < _e1088.member_1) {
                                                phi_2087_ = type_8((_e1088.member + 1u), _e1088.member_1);
                                                phi_2109_ = type_8(1u, _e1088.member);
                                            } else {
                                                phi_2087_ = _e1088;
                                                phi_2109_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1101 = phi_2087_;
                                            let _e1103 = phi_2109_;
                                            let _e1107 = (bitcast<i32>(_e1103.member) != 0i);
                                            if _e1107 {
                                                let _e1112 = (_e613.member.member_1.x - _e613.member.member.x);
                                                let _e1115 = (_e613.member.member_1.y - _e613.member.member.y);
                                                let _e1118 = (_e613.member.member_1.z - _e613.member.member.z);
                                                let _e1120 = select(_e1115, _e1112, (_e1112 > _e1115));
                                                let _e1122 = select(_e1118, _e1120, (_e1120 > _e1118));
                                                let _e1124 = (_e1122 < (1024f * _e159));
                                                if _e1124 {
                                                    phi_2150_ = 0u;
                                                } else {
                                                    phi_2150_ = select(2u, 1u, (_e1122 < (2097152f * _e159)));
                                                }
                                                let _e1129 = phi_2150_;
                                                switch bitcast<i32>(_e1129) {
                                                    case 0: {
                                                        phi_2156_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2156_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2156_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2156_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1132 = phi_2156_;
                                                switch bitcast<i32>(_e1129) {
                                                    case 0: {
                                                        phi_2166_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2166_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2166_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2166_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1139 = phi_2166_;
                                                let _e1141 = ((_e622 + (_e1103.member_1 * ((3u * _e1132) + 1u))) + (3u * _e1139));
                                                let _e1142 = (_e1141 < _e103);
                                                if _e1142 {
                                                    if _e1142 {
                                                    } else {
                                                        phi_5123_ = true;
                                                        break;
                                                    }
                                                    let _e1144 = global_10.member[_e1141];
                                                    phi_2182_ = _e1144;
                                                } else {
                                                    phi_2182_ = 4294967295u;
                                                }
                                                let _e1146 = phi_2182_;
                                                local_4 = array<u32, 3>(_e362, _e361, _e363);
                                                if _e1124 {
                                                    phi_2219_ = 0u;
                                                } else {
                                                    phi_2219_ = select(2u, 1u, (_e1122 < (2097152f * _e159)));
                                                }
                                                let _e1152 = phi_2219_;
                                                switch bitcast<i32>(_e1152) {
                                                    case 0: {
                                                        phi_2225_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2225_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2225_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2225_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1155 = phi_2225_;
                                                switch bitcast<i32>(_e1152) {
                                                    case 0: {
                                                        phi_2235_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2235_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2235_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2235_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1162 = phi_2235_;
                                                local_6 = array<f32, 4>(_e613.member.member.x, _e613.member.member.y, _e613.member.member.z, _e613.member.member.w);
                                                local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_5046_ = _e1084;
                                                phi_2251_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1176 = phi_5046_;
                                                    let _e1178 = phi_2251_;
                                                    if (_e1178.member < _e1178.member_1) {
                                                        phi_2252_ = type_8((_e1178.member + 1u), _e1178.member_1);
                                                        phi_2275_ = type_8(1u, _e1178.member);
                                                    } else {
                                                        phi_2252_ = _e1178;
                                                        phi_2275_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1191 = phi_2252_;
                                                    let _e1193 = phi_2275_;
                                                    let _e1197 = (bitcast<i32>(_e1193.member) != 0i);
                                                    if _e1197 {
                                                        let _e1199 = ((_e622 + (_e1103.member_1 * ((3u * _e1155) + 1u))) + (_e1193.member_1 * _e1162));
                                                        let _e1200 = (_e1199 < _e103);
                                                        if _e1200 {
                                                            if _e1200 {
                                                            } else {
                                                                phi_5121_ = true;
                                                                break;
                                                            }
                                                            let _e1202 = global_10.member[_e1199];
                                                            phi_2298_ = _e1202;
                                                        } else {
                                                            phi_2298_ = 0u;
                                                        }
                                                        let _e1204 = phi_2298_;
                                                        let _e1205 = (_e1199 + 1u);
                                                        let _e1206 = (_e1205 < _e103);
                                                        if _e1206 {
                                                            if _e1206 {
                                                            } else {
                                                                phi_5121_ = true;
                                                                break;
                                                            }
                                                            let _e1208 = global_10.member[_e1205];
                                                            phi_2313_ = _e1208;
                                                        } else {
                                                            phi_2313_ = 0u;
                                                        }
                                                        let _e1210 = phi_2313_;
                                                        phi_2316_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1212 = phi_2316_;
                                                            if (_e1212.member < _e1212.member_1) {
                                                                phi_2317_ = type_8((_e1212.member + 1u), _e1212.member_1);
                                                                phi_2340_ = type_8(1u, _e1212.member);
                                                            } else {
                                                                phi_2317_ = _e1212;
                                                                phi_2340_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1225 = phi_2317_;
                                                            let _e1227 = phi_2340_;
                                                            let _e1231 = (bitcast<i32>(_e1227.member) != 0i);
                                                            if _e1231 {
                                                                let _e1232 = (_e1227.member_1 < 3u);
                                                                if _e1232 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1234 = local_4[_e1227.member_1];
                                                                if (_e1227.member_1 < 4u) {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                let _e1237 = local_6[_e1227.member_1];
                                                                switch bitcast<i32>(_e1152) {
                                                                    case 0: {
                                                                        phi_2410_ = (_e1237 + (f32(((_e1204 >> bitcast<u32>(((10u * _e1234) & 31u))) & 1023u)) * _e159));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1234 == 0u) {
                                                                            phi_2387_ = _e1204;
                                                                        } else {
                                                                            if (_e1234 == 1u) {
                                                                                phi_2386_ = ((_e1204 >> bitcast<u32>(21i)) | (_e1210 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2386_ = (_e1210 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1258 = phi_2386_;
                                                                            phi_2387_ = _e1258;
                                                                        }
                                                                        let _e1260 = phi_2387_;
                                                                        phi_2410_ = (_e1237 + (f32((_e1260 & 2097151u)) * _e159));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1239 = (_e1199 + _e1234);
                                                                        let _e1240 = (_e1239 < _e103);
                                                                        if _e1240 {
                                                                            if _e1240 {
                                                                            } else {
                                                                                phi_5039_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1242 = global_10.member[_e1239];
                                                                            phi_2406_ = _e1242;
                                                                        } else {
                                                                            phi_2406_ = 0u;
                                                                        }
                                                                        let _e1244 = phi_2406_;
                                                                        phi_2410_ = (f32(bitcast<i32>(_e1244)) * _e159);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2410_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1274 = phi_2410_;
                                                                if (_e1193.member_1 < 3u) {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                if _e1232 {
                                                                } else {
                                                                    phi_5039_ = true;
                                                                    break;
                                                                }
                                                                local_5[_e1193.member_1][_e1227.member_1] = _e1274;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2316_ = _e1225;
                                                                phi_5039_ = _e1176;
                                                                break if !(_e1231);
                                                            }
                                                        }
                                                        let _e1280 = phi_5039_;
                                                        phi_5121_ = _e1280;
                                                        if _e1280 {
                                                            break;
                                                        }
                                                        phi_5122_ = _e1280;
                                                    } else {
                                                        phi_5122_ = _e1176;
                                                    }
                                                    let _e1282 = phi_5122_;
                                                    continue;
                                                    continuing {
                                                        phi_5046_ = _e1282;
                                                        phi_2251_ = _e1191;
                                                        phi_5121_ = _e1282;
                                                        break if !(_e1197);
                                                    }
                                                }
                                                let _e1285 = phi_5121_;
                                                phi_5123_ = _e1285;
                                                if _e1285 {
                                                    break;
                                                }
                                                let _e1286 = local_5;
                                                let _e1302 = (_e1286[0][2] - _e467);
                                                let _e1305 = (((_e1286[0][0] - _e394) * _e491) - (_e1302 * _e419));
                                                let _e1308 = (((_e1286[0][1] - _e431) * _e491) - (_e1302 * _e455));
                                                let _e1311 = (_e1286[1][2] - _e467);
                                                let _e1314 = (((_e1286[1][0] - _e394) * _e491) - (_e1311 * _e419));
                                                let _e1317 = (((_e1286[1][1] - _e431) * _e491) - (_e1311 * _e455));
                                                let _e1320 = (_e1286[2][2] - _e467);
                                                let _e1323 = (((_e1286[2][0] - _e394) * _e491) - (_e1320 * _e419));
                                                let _e1326 = (((_e1286[2][1] - _e431) * _e491) - (_e1320 * _e455));
                                                let _e1327 = (_e1323 * _e1317);
                                                let _e1328 = (_e1326 * _e1314);
                                                let _e1329 = (_e1305 * _e1326);
                                                let _e1330 = (_e1308 * _e1323);
                                                let _e1331 = (_e1314 * _e1308);
                                                let _e1332 = (_e1317 * _e1305);
                                                let _e1337 = (((_e1327 >= _e1328) && (_e1329 >= _e1330)) && (_e1331 >= _e1332));
                                                if (_e1337 || (((_e1327 <= _e1328) && (_e1329 <= _e1330)) && (_e1331 <= _e1332))) {
                                                    let _e1344 = select(-1f, 1f, _e1337);
                                                    let _e1346 = ((_e1327 - _e1328) * _e1344);
                                                    let _e1348 = select(0f, _e1346, (_e1346 > 0f));
                                                    let _e1350 = ((_e1329 - _e1330) * _e1344);
                                                    let _e1352 = select(0f, _e1350, (_e1350 > 0f));
                                                    let _e1354 = ((_e1331 - _e1332) * _e1344);
                                                    let _e1356 = select(0f, _e1354, (_e1354 > 0f));
                                                    let _e1358 = ((_e1348 + _e1352) + _e1356);
                                                    if (_e1358 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3005_ = type_25();
                                                        phi_3006_ = true;
                                                    } else {
                                                        let _e1361 = select(_e1286[1][0], _e1286[0][0], (_e1286[0][0] < _e1286[1][0]));
                                                        let _e1365 = select(_e1286[1][0], _e1286[0][0], (_e1286[0][0] > _e1286[1][0]));
                                                        let _e1369 = select(_e1286[1][1], _e1286[0][1], (_e1286[0][1] < _e1286[1][1]));
                                                        let _e1373 = select(_e1286[1][1], _e1286[0][1], (_e1286[0][1] > _e1286[1][1]));
                                                        let _e1377 = select(_e1286[1][2], _e1286[0][2], (_e1286[0][2] < _e1286[1][2]));
                                                        let _e1381 = select(_e1286[1][2], _e1286[0][2], (_e1286[0][2] > _e1286[1][2]));
                                                        let _e1386 = ((select(_e1286[2][0], _e1361, (_e1361 < _e1286[2][0])) - _e417) * _e422);
                                                        let _e1387 = ((select(_e1286[2][0], _e1365, (_e1365 > _e1286[2][0])) - _e418) * _e422);
                                                        let _e1390 = ((select(_e1286[2][1], _e1369, (_e1369 < _e1286[2][1])) - _e453) * _e458);
                                                        let _e1391 = ((select(_e1286[2][1], _e1373, (_e1373 > _e1286[2][1])) - _e454) * _e458);
                                                        let _e1394 = ((select(_e1286[2][2], _e1377, (_e1377 < _e1286[2][2])) - _e489) * _e494);
                                                        let _e1395 = ((select(_e1286[2][2], _e1381, (_e1381 > _e1286[2][2])) - _e490) * _e494);
                                                        let _e1397 = select(_e1395, _e1394, (_e1394 < _e1395));
                                                        let _e1399 = select(_e1395, _e1394, (_e1394 > _e1395));
                                                        let _e1401 = select(_e1387, _e1386, (_e1386 < _e1387));
                                                        let _e1403 = select(_e1391, _e1390, (_e1390 < _e1391));
                                                        let _e1405 = select(_e1403, _e1401, (_e1401 > _e1403));
                                                        let _e1407 = select(_e1397, _e1405, (_e1405 > _e1397));
                                                        let _e1409 = select(_e1387, _e1386, (_e1386 > _e1387));
                                                        let _e1411 = select(_e1391, _e1390, (_e1390 > _e1391));
                                                        let _e1413 = select(_e1411, _e1409, (_e1409 < _e1411));
                                                        let _e1415 = select(_e1399, _e1413, (_e1413 < _e1399));
                                                        let _e1416 = -(_e1397);
                                                        let _e1422 = select(_e540, _e1407, (_e1407 > _e540));
                                                        if (_e1422 > (_e1415 + (select(_e1416, _e1399, (_e1399 > _e1416)) * 0.0000019073523f))) {
                                                            phi_3000_ = type_25();
                                                            phi_3001_ = true;
                                                        } else {
                                                            let _e1424 = (_e1422 > _e1086.member_1);
                                                            if _e1424 {
                                                                phi_2999_ = type_25();
                                                            } else {
                                                                let _e1428 = (_e1286[1][0] - _e1286[0][0]);
                                                                let _e1429 = (_e1286[1][1] - _e1286[0][1]);
                                                                let _e1430 = (_e1286[1][2] - _e1286[0][2]);
                                                                let _e1431 = vec3<f32>(_e1428, _e1429, _e1430);
                                                                let _e1432 = (_e1286[2][0] - _e1286[1][0]);
                                                                let _e1433 = (_e1286[2][1] - _e1286[1][1]);
                                                                let _e1434 = (_e1286[2][2] - _e1286[1][2]);
                                                                let _e1435 = vec3<f32>(_e1432, _e1433, _e1434);
                                                                let _e1436 = (_e1286[0][0] - _e1286[2][0]);
                                                                let _e1437 = (_e1286[0][1] - _e1286[2][1]);
                                                                let _e1438 = (_e1286[0][2] - _e1286[2][2]);
                                                                let _e1439 = vec3<f32>(_e1436, _e1437, _e1438);
                                                                let _e1442 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
                                                                let _e1445 = bitcast<f32>((bitcast<u32>(_e1429) & 2147483647u));
                                                                let _e1447 = select(_e1445, _e1442, (_e1442 > _e1445));
                                                                let _e1450 = bitcast<f32>((bitcast<u32>(_e1430) & 2147483647u));
                                                                let _e1452 = select(_e1450, _e1447, (_e1447 > _e1450));
                                                                let _e1455 = bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u));
                                                                let _e1458 = bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u));
                                                                let _e1460 = select(_e1458, _e1455, (_e1455 > _e1458));
                                                                let _e1463 = bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u));
                                                                let _e1465 = select(_e1463, _e1460, (_e1460 > _e1463));
                                                                let _e1468 = bitcast<f32>((bitcast<u32>(_e1436) & 2147483647u));
                                                                let _e1471 = bitcast<f32>((bitcast<u32>(_e1437) & 2147483647u));
                                                                let _e1473 = select(_e1471, _e1468, (_e1468 > _e1471));
                                                                let _e1476 = bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u));
                                                                let _e1478 = select(_e1476, _e1473, (_e1473 > _e1476));
                                                                let _e1480 = select(_e1465, _e1452, (_e1452 > _e1465));
                                                                let _e1482 = select(_e1478, _e1480, (_e1480 > _e1478));
                                                                if (_e1452 == _e1482) {
                                                                    phi_2910_ = _e1435;
                                                                    phi_2911_ = _e1439;
                                                                } else {
                                                                    let _e1485 = vec3((_e1465 == _e1482));
                                                                    phi_2910_ = select(_e1431, _e1439, _e1485);
                                                                    phi_2911_ = select(_e1435, _e1431, _e1485);
                                                                }
                                                                let _e1489 = phi_2910_;
                                                                let _e1491 = phi_2911_;
                                                                let _e1498 = ((_e1489.y * _e1491.z) - (_e1491.y * _e1489.z));
                                                                let _e1503 = ((_e1489.z * _e1491.x) - (_e1491.z * _e1489.x));
                                                                let _e1506 = ((_e1489.x * _e1491.y) - (_e1491.x * _e1489.y));
                                                                if (_e1348 >= _e1352) {
                                                                    phi_2942_ = select(true, false, (_e1348 >= _e1356));
                                                                } else {
                                                                    phi_2942_ = true;
                                                                }
                                                                let _e1511 = phi_2942_;
                                                                if _e1511 {
                                                                    phi_2951_ = select(vec3<f32>(_e1286[2][0], _e1286[2][1], _e1286[2][2]), vec3<f32>(_e1286[1][0], _e1286[1][1], _e1286[1][2]), vec3((_e1352 >= _e1356)));
                                                                } else {
                                                                    phi_2951_ = vec3<f32>(_e1286[0][0], _e1286[0][1], _e1286[0][2]);
                                                                }
                                                                let _e1516 = phi_2951_;
                                                                let _e1533 = ((((_e1498 * (_e1516.x - _e394)) + (_e1503 * (_e1516.y - _e431))) + (_e1506 * (_e1516.z - _e467))) / (((_e1498 * _e419) + (_e1503 * _e455)) + (_e1506 * _e491)));
                                                                let _e1535 = select(_e1415, _e1533, (_e1533 < _e1415));
                                                                let _e1537 = select(_e1407, _e1535, (_e1535 > _e1407));
                                                                if (_e1537 >= _e540) {
                                                                    let _e1539 = (_e1537 <= _e1086.member_1);
                                                                    if _e1539 {
                                                                        let _e1540 = (1f / _e1358);
                                                                        phi_2991_ = type_25(_e1537, (_e1352 * _e1540), (_e1356 * _e1540), _e1146);
                                                                    } else {
                                                                        phi_2991_ = type_25();
                                                                    }
                                                                    let _e1545 = phi_2991_;
                                                                    phi_2993_ = _e1545;
                                                                    phi_2994_ = select(true, false, _e1539);
                                                                } else {
                                                                    phi_2993_ = type_25();
                                                                    phi_2994_ = true;
                                                                }
                                                                let _e1548 = phi_2993_;
                                                                let _e1550 = phi_2994_;
                                                                if _e1550 {
                                                                    phi_2998_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2998_ = _e1548;
                                                                }
                                                                let _e1552 = phi_2998_;
                                                                phi_2999_ = _e1552;
                                                            }
                                                            let _e1554 = phi_2999_;
                                                            phi_3000_ = _e1554;
                                                            phi_3001_ = _e1424;
                                                        }
                                                        let _e1556 = phi_3000_;
                                                        let _e1558 = phi_3001_;
                                                        phi_3005_ = _e1556;
                                                        phi_3006_ = _e1558;
                                                    }
                                                    let _e1560 = phi_3005_;
                                                    let _e1562 = phi_3006_;
                                                    phi_3010_ = _e1560;
                                                    phi_3011_ = _e1562;
                                                } else {
                                                    phi_3010_ = type_25();
                                                    phi_3011_ = true;
                                                }
                                                let _e1564 = phi_3010_;
                                                let _e1566 = phi_3011_;
                                                if _e1566 {
                                                    phi_3015_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3015_ = _e1564;
                                                }
                                                let _e1568 = phi_3015_;
                                                if (_e1568.member_3 != 4294967295u) {
                                                    if (_e1146 == _e168) {
                                                        phi_3344_ = false;
                                                    } else {
                                                        let _e1572 = (_e1146 < arrayLength((&global_5.member)));
                                                        if _e1572 {
                                                            if _e1572 {
                                                            } else {
                                                                phi_5123_ = true;
                                                                break;
                                                            }
                                                            let _e1574 = global_5.member[_e1146];
                                                            phi_3038_ = _e1574;
                                                        } else {
                                                            phi_3038_ = 4294967295u;
                                                        }
                                                        let _e1576 = phi_3038_;
                                                        let _e1577 = (_e1576 < arrayLength((&global_6.member)));
                                                        if _e1577 {
                                                            if _e1577 {
                                                            } else {
                                                                phi_5123_ = true;
                                                                break;
                                                            }
                                                            let _e1579 = global_6.member[_e1576];
                                                            phi_3052_ = _e1579;
                                                        } else {
                                                            phi_3052_ = 0i;
                                                        }
                                                        let _e1581 = phi_3052_;
                                                        let _e1582 = (_e1581 == 0i);
                                                        if _e1582 {
                                                            phi_3343_ = true;
                                                        } else {
                                                            if _e386 {
                                                                phi_3073_ = vec3<f32>(_e1286[0][0], _e1286[0][1], _e1286[0][2]);
                                                            } else {
                                                                if (_e362 == 1u) {
                                                                    phi_3072_ = vec3<f32>(_e1286[0][2], _e1286[0][0], _e1286[0][1]);
                                                                } else {
                                                                    phi_3072_ = vec3<f32>(_e1286[0][1], _e1286[0][2], _e1286[0][0]);
                                                                }
                                                                let _e1587 = phi_3072_;
                                                                phi_3073_ = _e1587;
                                                            }
                                                            let _e1590 = phi_3073_;
                                                            if _e386 {
                                                                phi_3090_ = vec3<f32>(_e1286[1][0], _e1286[1][1], _e1286[1][2]);
                                                            } else {
                                                                if (_e362 == 1u) {
                                                                    phi_3089_ = vec3<f32>(_e1286[1][2], _e1286[1][0], _e1286[1][1]);
                                                                } else {
                                                                    phi_3089_ = vec3<f32>(_e1286[1][1], _e1286[1][2], _e1286[1][0]);
                                                                }
                                                                let _e1595 = phi_3089_;
                                                                phi_3090_ = _e1595;
                                                            }
                                                            let _e1598 = phi_3090_;
                                                            if _e386 {
                                                                phi_3107_ = vec3<f32>(_e1286[2][0], _e1286[2][1], _e1286[2][2]);
                                                            } else {
                                                                if (_e362 == 1u) {
                                                                    phi_3106_ = vec3<f32>(_e1286[2][2], _e1286[2][0], _e1286[2][1]);
                                                                } else {
                                                                    phi_3106_ = vec3<f32>(_e1286[2][1], _e1286[2][2], _e1286[2][0]);
                                                                }
                                                                let _e1603 = phi_3106_;
                                                                phi_3107_ = _e1603;
                                                            }
                                                            let _e1606 = phi_3107_;
                                                            let _e1609 = (_e1598.x - _e1590.x);
                                                            let _e1612 = (_e1598.y - _e1590.y);
                                                            let _e1615 = (_e1598.z - _e1590.z);
                                                            let _e1617 = (_e1606.x - _e1590.x);
                                                            let _e1619 = (_e1606.y - _e1590.y);
                                                            let _e1621 = (_e1606.z - _e1590.z);
                                                            if (_e240.member_1 == 1u) {
                                                                phi_3143_ = (vec3<f32>(_e240.member[0], _e240.member[1], _e240.member[2]) - _e1590);
                                                            } else {
                                                                phi_3143_ = vec3<f32>(_e240.member[0], _e240.member[1], _e240.member[2]);
                                                            }
                                                            let _e1636 = phi_3143_;
                                                            let _e1642 = bitcast<f32>((bitcast<u32>((_e1609 * _e1619)) ^ _e240.member_3[0]));
                                                            let _e1646 = bitcast<f32>((bitcast<u32>((_e1612 * _e1617)) ^ _e240.member_3[0]));
                                                            let _e1650 = bitcast<f32>((bitcast<u32>((_e1612 * _e1621)) ^ _e240.member_3[0]));
                                                            let _e1654 = bitcast<f32>((bitcast<u32>((_e1615 * _e1619)) ^ _e240.member_3[0]));
                                                            let _e1658 = bitcast<f32>((bitcast<u32>((_e1615 * _e1617)) ^ _e240.member_3[0]));
                                                            let _e1662 = bitcast<f32>((bitcast<u32>((_e1609 * _e1621)) ^ _e240.member_3[0]));
                                                            let _e1663 = (_e1650 - _e1654);
                                                            let _e1664 = (_e1658 - _e1662);
                                                            let _e1665 = (_e1642 - _e1646);
                                                            let _e1689 = (bitcast<f32>((bitcast<u32>(_e1650) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1654) & 2147483647u)));
                                                            let _e1696 = (bitcast<f32>((bitcast<u32>(_e1658) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1662) & 2147483647u)));
                                                            let _e1703 = (bitcast<f32>((bitcast<u32>(_e1642) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1646) & 2147483647u)));
                                                            if (_e240.member_2 == 0f) {
                                                                phi_3325_ = 0f;
                                                            } else {
                                                                let _e1733 = bitcast<f32>((bitcast<u32>(_e1663) & 2147483647u));
                                                                let _e1736 = bitcast<f32>((bitcast<u32>(_e1664) & 2147483647u));
                                                                let _e1739 = bitcast<f32>((bitcast<u32>(_e1665) & 2147483647u));
                                                                let _e1741 = select(_e1739, _e1736, (_e1736 > _e1739));
                                                                let _e1745 = select(_e1739, _e1736, (_e1736 < _e1739));
                                                                let _e1749 = select(_e1736, _e1733, (_e1733 < _e1736));
                                                                let _e1751 = select(_e1736, _e1733, (_e1733 > _e1736));
                                                                let _e1753 = select(_e1739, _e1751, (_e1751 < _e1739));
                                                                phi_3325_ = bitcast<f32>((bitcast<u32>((_e240.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1741, _e1733, (_e1733 > _e1741)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1753, _e1749, (_e1749 > _e1753)))) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1745, _e1733, (_e1733 < _e1745)))) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1689 + _e1696) + _e1703))) ^ _e240.member_3[0]))) * 1.0000005f)) ^ _e240.member_3[0])))) ^ _e240.member_3[0]));
                                                            }
                                                            let _e1780 = phi_3325_;
                                                            phi_3343_ = (_e1582 || !(((((bitcast<f32>((bitcast<u32>((_e1636.x * _e1663)) ^ _e240.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1636.y * _e1664)) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1636.z * _e1665)) ^ _e240.member_3[0]))) * f32(-(_e1581))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1636.x) & 2147483647u)) * _e1689)) ^ _e240.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1636.y) & 2147483647u)) * _e1696)) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1636.z) & 2147483647u)) * _e1703)) ^ _e240.member_3[0]))))) ^ _e240.member_3[0])) + _e1780) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1794 = phi_3343_;
                                                        phi_3344_ = _e1794;
                                                    }
                                                    let _e1796 = phi_3344_;
                                                    if _e1796 {
                                                        if (_e1568.member < _e1086.member.member) {
                                                            phi_3364_ = true;
                                                        } else {
                                                            if (_e1568.member == _e1086.member.member) {
                                                                phi_3363_ = (_e1568.member_3 < _e1086.member.member_3);
                                                            } else {
                                                                phi_3363_ = false;
                                                            }
                                                            let _e1806 = phi_3363_;
                                                            phi_3364_ = _e1806;
                                                        }
                                                        let _e1808 = phi_3364_;
                                                        if _e1808 {
                                                            phi_3370_ = type_42(_e1568, _e1568.member);
                                                        } else {
                                                            phi_3370_ = _e1086;
                                                        }
                                                        let _e1811 = phi_3370_;
                                                        phi_3371_ = _e1811;
                                                    } else {
                                                        phi_3371_ = _e1086;
                                                    }
                                                    let _e1813 = phi_3371_;
                                                    phi_3372_ = _e1813;
                                                } else {
                                                    phi_3372_ = _e1086;
                                                }
                                                let _e1815 = phi_3372_;
                                                phi_5124_ = _e1285;
                                                phi_2084_ = _e1815;
                                            } else {
                                                phi_5124_ = _e1084;
                                                phi_2084_ = type_42();
                                            }
                                            let _e1817 = phi_5124_;
                                            let _e1819 = phi_2084_;
                                            continue;
                                            continuing {
                                                phi_5061_ = _e1817;
                                                phi_2083_ = _e1819;
                                                phi_2086_ = _e1101;
                                                phi_5123_ = _e1817;
                                                break if !(_e1107);
                                            }
                                        }
                                        let _e1822 = phi_5123_;
                                        phi_5202_ = _e1822;
                                        if _e1822 {
                                            break;
                                        }
                                        phi_5206_ = _e1822;
                                        let _e2062 = local_8;
                                        phi_4710_ = _e2062;
                                        phi_4711_ = _e613;
                                        phi_4712_ = false;
                                        phi_4713_ = _e617;
                                    } else {
                                        if (_e613.member_1 >= _e100) {
                                            phi_4310_ = type_62(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_59(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e613.member_1 < _e100) {
                                            } else {
                                                phi_5202_ = true;
                                                break;
                                            }
                                            let _e630 = ((1u + _e362) % 4u);
                                            if (_e630 < 4u) {
                                            } else {
                                                phi_5202_ = true;
                                                break;
                                            }
                                            let _e635 = global_4.member[_e613.member_1][_e630];
                                            let _e637 = ((1u + _e361) % 4u);
                                            if (_e637 < 4u) {
                                            } else {
                                                phi_5202_ = true;
                                                break;
                                            }
                                            let _e642 = global_4.member[_e613.member_1][_e637];
                                            let _e644 = ((1u + _e363) % 4u);
                                            if (_e644 < 4u) {
                                            } else {
                                                phi_5202_ = true;
                                                break;
                                            }
                                            let _e649 = global_4.member[_e613.member_1][_e644];
                                            let _e651 = ((_e362 + 1u) % 4u);
                                            if (_e651 < 4u) {
                                            } else {
                                                phi_5202_ = true;
                                                break;
                                            }
                                            let _e656 = global_4.member[_e613.member_1][_e651];
                                            let _e658 = (_e656 >> bitcast<u32>(11u));
                                            let _e660 = ((_e361 + 1u) % 4u);
                                            if (_e660 < 4u) {
                                            } else {
                                                phi_5202_ = true;
                                                break;
                                            }
                                            let _e665 = global_4.member[_e613.member_1][_e660];
                                            let _e667 = (_e665 >> bitcast<u32>(11u));
                                            let _e669 = ((_e363 + 1u) % 4u);
                                            if (_e669 < 4u) {
                                            } else {
                                                phi_5202_ = true;
                                                break;
                                            }
                                            let _e674 = global_4.member[_e613.member_1][_e669];
                                            let _e676 = (_e674 >> bitcast<u32>(11u));
                                            let _e699 = (bitcast<f32>((bitcast<u32>((_e613.member.member_1.x - _e613.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e700 = (bitcast<f32>((bitcast<u32>((_e613.member.member_1.y - _e613.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e701 = (bitcast<f32>((bitcast<u32>((_e613.member.member_1.z - _e613.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e703 = select(_e159, _e699, (_e699 > _e159));
                                            let _e705 = select(_e159, _e700, (_e700 > _e159));
                                            let _e707 = select(_e159, _e701, (_e701 > _e159));
                                            let _e732 = bitcast<u32>((f32(bitcast<i32>((_e635 & 1023u))) * _e703));
                                            let _e737 = (bitcast<i32>((_e635 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e740 = bitcast<f32>((_e732 & bitcast<u32>(_e737)));
                                            let _e741 = bitcast<u32>((f32(bitcast<i32>((_e642 & 1023u))) * _e705));
                                            let _e746 = (bitcast<i32>((_e642 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e749 = bitcast<f32>((_e741 & bitcast<u32>(_e746)));
                                            let _e750 = bitcast<u32>((f32(bitcast<i32>((_e649 & 1023u))) * _e707));
                                            let _e755 = (bitcast<i32>((_e649 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e758 = bitcast<f32>((_e750 & bitcast<u32>(_e755)));
                                            let _e762 = bitcast<f32>((_e732 & bitcast<u32>(~(_e737))));
                                            let _e766 = bitcast<f32>((_e741 & bitcast<u32>(~(_e746))));
                                            let _e770 = bitcast<f32>((_e750 & bitcast<u32>(~(_e755))));
                                            let _e771 = bitcast<u32>((f32(bitcast<i32>((_e658 & 1023u))) * _e703));
                                            let _e776 = (bitcast<i32>((_e658 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e779 = bitcast<f32>((_e771 & bitcast<u32>(_e776)));
                                            let _e780 = bitcast<u32>((f32(bitcast<i32>((_e667 & 1023u))) * _e705));
                                            let _e785 = (bitcast<i32>((_e667 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e788 = bitcast<f32>((_e780 & bitcast<u32>(_e785)));
                                            let _e789 = bitcast<u32>((f32(bitcast<i32>((_e676 & 1023u))) * _e707));
                                            let _e794 = (bitcast<i32>((_e676 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e797 = bitcast<f32>((_e789 & bitcast<u32>(_e794)));
                                            let _e801 = bitcast<f32>((_e771 & bitcast<u32>(~(_e776))));
                                            let _e805 = bitcast<f32>((_e780 & bitcast<u32>(~(_e785))));
                                            let _e809 = bitcast<f32>((_e789 & bitcast<u32>(~(_e794))));
                                            let _e810 = (_e613.member.member.x + _e740);
                                            let _e811 = (_e613.member.member.y + _e749);
                                            let _e812 = (_e613.member.member.z + _e758);
                                            let _e815 = (_e613.member.member_1.x - _e779);
                                            let _e816 = (_e613.member.member_1.y - _e788);
                                            let _e817 = (_e613.member.member_1.z - _e797);
                                            let _e836 = (_e815 - _e810);
                                            let _e837 = (_e816 - _e811);
                                            let _e838 = (_e817 - _e812);
                                            let _e840 = select(_e837, _e836, (_e836 > _e837));
                                            let _e842 = select(_e838, _e840, (_e840 > _e838));
                                            if (_e842 < (1024f * _e159)) {
                                                phi_4011_ = 0u;
                                            } else {
                                                phi_4011_ = select(2u, 1u, (_e842 < (2097152f * _e159)));
                                            }
                                            let _e849 = phi_4011_;
                                            switch bitcast<i32>(_e849) {
                                                case 0: {
                                                    phi_4017_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_4017_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_4017_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_4017_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e852 = phi_4017_;
                                            let _e858 = global_4.member[_e613.member_1][0u];
                                            let _e862 = global_4.member[_e613.member_1][1u];
                                            let _e866 = global_4.member[_e613.member_1][2u];
                                            let _e870 = global_4.member[_e613.member_1][3u];
                                            let _e882 = (((_e862 >> bitcast<u32>(22i)) | ((_e866 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e870 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e883 = (_e858 & 268435455u);
                                            let _e884 = (_e882 & 268435455u);
                                            let _e887 = ((_e858 >> bitcast<u32>(28u)) & 7u);
                                            let _e895 = ((_e858 >> bitcast<u32>(31i)) | (((_e882 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e896 = (_e887 != 0u);
                                            if (_e887 == 0u) {
                                                phi_4272_ = _e883;
                                            } else {
                                                if (_e887 == 7u) {
                                                    phi_4271_ = 2147483648u;
                                                } else {
                                                    phi_4271_ = ((2147483648u | (_e887 << bitcast<u32>(28u))) | (_e884 & 268435455u));
                                                }
                                                let _e905 = phi_4271_;
                                                phi_4272_ = _e905;
                                            }
                                            let _e907 = phi_4272_;
                                            if _e896 {
                                                let _e908 = (_e887 != 7u);
                                                if _e908 {
                                                    phi_4282_ = (_e884 + (_e887 * ((3u * _e852) + 1u)));
                                                } else {
                                                    phi_4282_ = u32();
                                                }
                                                let _e912 = phi_4282_;
                                                phi_4284_ = _e912;
                                                phi_4285_ = select(true, false, _e908);
                                            } else {
                                                phi_4284_ = u32();
                                                phi_4285_ = true;
                                            }
                                            let _e915 = phi_4284_;
                                            let _e917 = phi_4285_;
                                            if (_e895 == 0u) {
                                                phi_4306_ = (_e883 + select(0u, 1u, !(_e896)));
                                            } else {
                                                if (_e895 == 7u) {
                                                    phi_4305_ = 2147483648u;
                                                } else {
                                                    phi_4305_ = ((2147483648u | (_e895 << bitcast<u32>(28u))) | (select(_e915, _e884, _e917) & 268435455u));
                                                }
                                                let _e930 = phi_4305_;
                                                phi_4306_ = _e930;
                                            }
                                            let _e932 = phi_4306_;
                                            phi_4310_ = type_62(array<vec4<f32>, 3>(vec4<f32>(_e810, (_e613.member.member.x + _e762), _e815, (_e613.member.member_1.x - _e801)), vec4<f32>(_e811, (_e613.member.member.y + _e766), _e816, (_e613.member.member_1.y - _e805)), vec4<f32>(_e812, (_e613.member.member.z + _e770), _e817, (_e613.member.member_1.z - _e809))), type_59(type_37((_e613.member.member + vec4<f32>(_e740, _e749, _e758, 0f)), (_e613.member.member_1 - vec4<f32>(_e779, _e788, _e797, 0f))), _e907), type_59(type_37((_e613.member.member + vec4<f32>(_e762, _e766, _e770, 0f)), (_e613.member.member_1 - vec4<f32>(_e801, _e805, _e809, 0f))), _e932));
                                        }
                                        let _e937 = phi_4310_;
                                        let _e949 = ((_e937.member[0].x - _e417) * _e422);
                                        let _e950 = ((_e937.member[0].y - _e417) * _e422);
                                        let _e951 = ((_e937.member[0].z - _e418) * _e422);
                                        let _e952 = ((_e937.member[0].w - _e418) * _e422);
                                        let _e962 = ((_e937.member[1].x - _e453) * _e458);
                                        let _e963 = ((_e937.member[1].y - _e453) * _e458);
                                        let _e964 = ((_e937.member[1].z - _e454) * _e458);
                                        let _e965 = ((_e937.member[1].w - _e454) * _e458);
                                        let _e975 = ((_e937.member[2].x - _e489) * _e494);
                                        let _e976 = ((_e937.member[2].y - _e489) * _e494);
                                        let _e977 = ((_e937.member[2].z - _e490) * _e494);
                                        let _e978 = ((_e937.member[2].w - _e490) * _e494);
                                        let _e980 = select(_e977, _e975, (_e975 < _e977));
                                        let _e982 = select(_e978, _e976, (_e976 < _e978));
                                        let _e984 = select(_e977, _e975, (_e975 > _e977));
                                        let _e986 = select(_e978, _e976, (_e976 > _e978));
                                        let _e988 = select(_e951, _e949, (_e949 < _e951));
                                        let _e990 = select(_e952, _e950, (_e950 < _e952));
                                        let _e992 = select(_e964, _e962, (_e962 < _e964));
                                        let _e994 = select(_e965, _e963, (_e963 < _e965));
                                        let _e996 = select(_e992, _e988, (_e988 > _e992));
                                        let _e998 = select(_e994, _e990, (_e990 > _e994));
                                        let _e1000 = select(_e980, _e996, (_e996 > _e980));
                                        let _e1002 = select(_e982, _e998, (_e998 > _e982));
                                        let _e1004 = select(_e951, _e949, (_e949 > _e951));
                                        let _e1006 = select(_e952, _e950, (_e950 > _e952));
                                        let _e1008 = select(_e964, _e962, (_e962 > _e964));
                                        let _e1010 = select(_e965, _e963, (_e963 > _e965));
                                        let _e1012 = select(_e1008, _e1004, (_e1004 < _e1008));
                                        let _e1014 = select(_e1010, _e1006, (_e1006 < _e1010));
                                        let _e1019 = -(_e980);
                                        let _e1020 = -(_e982);
                                        let _e1027 = (select(_e984, _e1012, (_e1012 < _e984)) + (select(_e1019, _e984, (_e984 > _e1019)) * 0.0000019073523f));
                                        let _e1028 = (select(_e986, _e1014, (_e1014 < _e986)) + (select(_e1020, _e986, (_e986 > _e1020)) * 0.0000019073523f));
                                        let _e1030 = select(_e540, _e1000, (_e1000 > _e540));
                                        let _e1032 = select(_e540, _e1002, (_e1002 > _e540));
                                        let _e1037 = (_e1030 <= select(_e584.member_1, _e1027, (_e1027 < _e584.member_1)));
                                        let _e1038 = (_e1032 <= select(_e584.member_1, _e1028, (_e1028 < _e584.member_1)));
                                        let _e1039 = (_e1030 <= _e1032);
                                        if _e1037 {
                                            if _e1038 {
                                                if _e1039 {
                                                    phi_4654_ = _e937.member_2;
                                                } else {
                                                    phi_4654_ = _e937.member_1;
                                                }
                                                let _e1043 = phi_4654_;
                                                let _e1044 = (_e617 % 128u);
                                                let _e1045 = (_e1044 < 128u);
                                                if _e1045 {
                                                } else {
                                                    phi_5202_ = true;
                                                    break;
                                                }
                                                local_3[_e1044] = type_59(type_37(_e1043.member.member, _e1043.member.member_1), _e1043.member_1);
                                                if _e1045 {
                                                } else {
                                                    phi_5202_ = true;
                                                    break;
                                                }
                                                local_2[_e1044] = select(_e1032, _e1030, (_e1030 > _e1032));
                                                if _e1039 {
                                                    phi_4687_ = _e937.member_1;
                                                } else {
                                                    phi_4687_ = _e937.member_2;
                                                }
                                                let _e1060 = phi_4687_;
                                                phi_4688_ = _e1060;
                                                phi_4689_ = (_e617 + 1u);
                                            } else {
                                                phi_4688_ = type_59();
                                                phi_4689_ = u32();
                                            }
                                            let _e1062 = phi_4688_;
                                            let _e1064 = phi_4689_;
                                            phi_4691_ = _e1062;
                                            phi_4692_ = _e1064;
                                            phi_4693_ = select(true, false, _e1038);
                                        } else {
                                            phi_4691_ = type_59();
                                            phi_4692_ = u32();
                                            phi_4693_ = true;
                                        }
                                        let _e1067 = phi_4691_;
                                        let _e1069 = phi_4692_;
                                        let _e1071 = phi_4693_;
                                        if _e1071 {
                                            if _e1037 {
                                                phi_4702_ = _e937.member_1;
                                            } else {
                                                phi_4702_ = _e937.member_2;
                                            }
                                            let _e1075 = phi_4702_;
                                            phi_4707_ = _e1075;
                                            phi_4708_ = select(_e1038, true, _e1037);
                                        } else {
                                            phi_4707_ = _e1067;
                                            phi_4708_ = _e615;
                                        }
                                        let _e1078 = phi_4707_;
                                        let _e1080 = phi_4708_;
                                        phi_5206_ = _e582;
                                        phi_4710_ = _e584;
                                        phi_4711_ = _e1078;
                                        phi_4712_ = _e1080;
                                        phi_4713_ = select(_e1069, _e617, _e1071);
                                    }
                                    let _e1824 = phi_5206_;
                                    let _e1826 = phi_4710_;
                                    let _e1828 = phi_4711_;
                                    let _e1830 = phi_4712_;
                                    let _e1832 = phi_4713_;
                                    phi_5205_ = _e1824;
                                    phi_4714_ = _e1826;
                                    phi_4715_ = _e1828;
                                    phi_4716_ = (_e588 - 1u);
                                    phi_4717_ = _e1830;
                                    phi_4718_ = _e1832;
                                } else {
                                    phi_5205_ = _e582;
                                    phi_4714_ = _e584;
                                    phi_4715_ = _e613;
                                    phi_4716_ = _e588;
                                    phi_4717_ = _e615;
                                    phi_4718_ = _e617;
                                }
                                let _e1834 = phi_5205_;
                                let _e1836 = phi_4714_;
                                let _e1838 = phi_4715_;
                                let _e1840 = phi_4716_;
                                let _e1842 = phi_4717_;
                                let _e1844 = phi_4718_;
                                phi_5204_ = _e1834;
                                phi_4719_ = _e1836;
                                phi_4720_ = _e1838;
                                phi_4721_ = _e1840;
                                phi_4722_ = _e1842;
                                phi_4723_ = _e1844;
                            } else {
                                phi_5204_ = _e582;
                                phi_4719_ = type_42();
                                phi_4720_ = type_59();
                                phi_4721_ = u32();
                                phi_4722_ = bool();
                                phi_4723_ = u32();
                            }
                            let _e1846 = phi_5204_;
                            let _e1848 = phi_4719_;
                            let _e1850 = phi_4720_;
                            let _e1852 = phi_4721_;
                            let _e1854 = phi_4722_;
                            let _e1856 = phi_4723_;
                            phi_5203_ = _e1846;
                            phi_2006_ = _e1848;
                            phi_2009_ = _e1850;
                            phi_2011_ = _e1852;
                            phi_2013_ = _e1854;
                            phi_2015_ = _e1856;
                            phi_4724_ = _e596;
                        } else {
                            phi_5203_ = _e582;
                            phi_2006_ = type_42();
                            phi_2009_ = type_59();
                            phi_2011_ = u32();
                            phi_2013_ = bool();
                            phi_2015_ = u32();
                            phi_4724_ = false;
                        }
                        let _e1858 = phi_5203_;
                        let _e1860 = phi_2006_;
                        let _e1862 = phi_2009_;
                        let _e1864 = phi_2011_;
                        let _e1866 = phi_2013_;
                        let _e1868 = phi_2015_;
                        let _e1870 = phi_4724_;
                        continue;
                        continuing {
                            phi_5064_ = _e1858;
                            phi_2005_ = _e1860;
                            phi_2008_ = _e1862;
                            phi_2010_ = _e1864;
                            phi_2012_ = _e1866;
                            phi_2014_ = _e1868;
                            phi_5202_ = _e1858;
                            break if !(_e1870);
                        }
                    }
                    let _e1873 = phi_5202_;
                    if _e1873 {
                        break;
                    }
                    let _e1875 = local_7;
                    if (_e1875.member.member_3 != 4294967295u) {
                        let _e1880 = (_e364 / 3i);
                        let _e1887 = bitcast<f32>((bitcast<u32>((_e1880 + 127i)) << bitcast<u32>(23i)));
                        let _e1895 = (((_e1875.member.member * _e1887) * _e1887) * bitcast<f32>((bitcast<u32>(((_e364 - (2i * _e1880)) + 127i)) << bitcast<u32>(23i))));
                        let _e1897 = select(340282350000000000000000000000000000000f, _e1895, (_e1895 < 340282350000000000000000000000000000000f));
                        phi_4776_ = type_25(select(-340282350000000000000000000000000000000f, _e1897, (_e1897 > -340282350000000000000000000000000000000f)), _e1875.member.member_1, _e1875.member.member_2, _e1875.member.member_3);
                    } else {
                        phi_4776_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1904 = phi_4776_;
                    if _e241 {
                    } else {
                        break;
                    }
                    global_8.member[_e147] = _e1904;
                    if _e162 {
                    } else {
                        break;
                    }
                    let _e1908 = select(0u, 1u, (_e308 <= _e318));
                    if (_e1908 > 0u) {
                        let _e1910 = (1u < _e115);
                        if _e1910 {
                            if (0u < _e115) {
                            } else {
                                break;
                            }
                            let _e1914 = atomicAdd((&global_9.member[0u]), _e1908);
                            if ((_e1914 + _e1908) < _e1914) {
                                if _e1910 {
                                } else {
                                    break;
                                }
                                let _e1919 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1922 = select(0u, 1u, (_e1904.member_3 != 4294967295u));
                    if (_e1922 > 0u) {
                        let _e1924 = (3u < _e115);
                        if _e1924 {
                            if (2u < _e115) {
                            } else {
                                break;
                            }
                            let _e1928 = atomicAdd((&global_9.member[2u]), _e1922);
                            if ((_e1928 + _e1922) < _e1928) {
                                if _e1924 {
                                } else {
                                    break;
                                }
                                let _e1933 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
