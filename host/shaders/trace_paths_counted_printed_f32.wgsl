struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_23 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: type_27,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_38 {
    member: type_23,
    member_1: f32,
}

struct type_41 {
    member: type_38,
    member_1: u32,
    member_2: u32,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_47 {
    member: array<type_45>,
}

struct type_52 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_54 {
    member: type_52,
    member_1: u32,
}

struct type_59 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_25;
@group(0) @binding(0) 
var<uniform> global_3: type_43;
@group(0) @binding(3) 
var<storage> global_4: type_30;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_59;
@group(0) @binding(1) 
var<storage> global_7: type_47;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 128>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 3>;
    var local_12: array<f32, 3>;
    var local_13: array<f32, 3>;
    var local_14: array<u32, 3>;
    var local_15: array<u32, 3>;
    var local_16: array<f32, 3>;
    var local_17: array<f32, 3>;
    var phi_348_: i32;
    var phi_349_: i32;
    var phi_359_: bool;
    var phi_369_: u32;
    var phi_370_: u32;
    var phi_372_: bool;
    var phi_377_: u32;
    var phi_410_: i32;
    var phi_428_: f32;
    var phi_434_: f32;
    var phi_445_: f32;
    var phi_451_: f32;
    var phi_474_: f32;
    var phi_485_: f32;
    var phi_494_: f32;
    var phi_500_: f32;
    var phi_511_: f32;
    var phi_517_: f32;
    var phi_540_: f32;
    var phi_551_: f32;
    var phi_560_: f32;
    var phi_566_: f32;
    var phi_577_: f32;
    var phi_583_: f32;
    var phi_606_: f32;
    var phi_617_: f32;
    var phi_717_: f32;
    var phi_718_: f32;
    var phi_2823_: bool;
    var phi_800_: type_41;
    var phi_803_: type_54;
    var phi_805_: u32;
    var phi_807_: bool;
    var phi_809_: u32;
    var phi_820_: bool;
    var phi_906_: type_54;
    var phi_907_: bool;
    var phi_908_: u32;
    var phi_1713_: type_45;
    var phi_1722_: type_7;
    var phi_1723_: type_7;
    var phi_1746_: type_7;
    var phi_2816_: bool;
    var phi_1876_: type_7;
    var phi_1877_: type_7;
    var phi_1900_: type_7;
    var phi_2876_: bool;
    var phi_2463_: type_54;
    var phi_2540_: type_54;
    var phi_2541_: type_54;
    var phi_2542_: u32;
    var phi_2544_: type_54;
    var phi_2545_: u32;
    var phi_2546_: bool;
    var phi_2553_: type_54;
    var phi_2558_: type_54;
    var phi_2559_: bool;
    var phi_926_: type_41;
    var phi_929_: type_7;
    var phi_930_: type_7;
    var phi_952_: type_7;
    var phi_976_: u32;
    var phi_1065_: array<array<f32, 3>, 3>;
    var phi_1536_: vec3<f32>;
    var phi_1537_: vec3<f32>;
    var phi_1568_: bool;
    var phi_1577_: vec3<f32>;
    var phi_1617_: type_23;
    var phi_1619_: type_23;
    var phi_1620_: bool;
    var phi_1624_: type_23;
    var phi_1625_: type_23;
    var phi_1626_: type_23;
    var phi_1627_: bool;
    var phi_1631_: type_23;
    var phi_1632_: bool;
    var phi_1636_: type_23;
    var phi_1637_: bool;
    var phi_1641_: type_23;
    var phi_1666_: bool;
    var phi_1667_: bool;
    var phi_1674_: type_41;
    var phi_1675_: type_41;
    var phi_1676_: type_41;
    var phi_927_: type_41;
    var phi_2884_: bool;
    var phi_2951_: bool;
    var phi_2561_: type_41;
    var phi_2562_: type_54;
    var phi_2563_: bool;
    var phi_2564_: u32;
    var phi_2950_: bool;
    var phi_2565_: type_41;
    var phi_2566_: type_54;
    var phi_2567_: u32;
    var phi_2568_: bool;
    var phi_2569_: u32;
    var phi_2949_: bool;
    var phi_2570_: type_41;
    var phi_2571_: type_54;
    var phi_2572_: u32;
    var phi_2573_: bool;
    var phi_2574_: u32;
    var phi_2948_: bool;
    var phi_801_: type_41;
    var phi_804_: type_54;
    var phi_806_: u32;
    var phi_808_: bool;
    var phi_810_: u32;
    var phi_2575_: bool;
    var phi_2947_: bool;
    var local_18: type_41;
    var phi_2627_: type_23;
    var local_19: type_41;
    var local_20: type_41;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e90 = arrayLength((&global_7.member));
            let _e92 = arrayLength((&global_1.member));
            let _e100 = arrayLength((&global_6.member));
            let _e104 = global_3.member[0u][0u];
            let _e108 = global_3.member[0u][1u];
            let _e112 = global_3.member[0u][2u];
            let _e116 = global_3.member[1u][0u];
            let _e120 = global_3.member[1u][1u];
            let _e124 = global_3.member[1u][2u];
            let _e128 = global_3.member[1u][3u];
            let _e132 = (_e87.x + (_e87.y * 2097152u));
            let _e139 = (_e132 < arrayLength((&global_4.member)));
            if _e139 {
                let _e140 = (_e132 < arrayLength((&global_2.member)));
                if _e140 {
                    let _e141 = (_e132 < arrayLength((&global_5.member)));
                    if _e141 {
                        if _e139 {
                        } else {
                            break;
                        }
                        let _e151 = global_4.member[_e132].member.member_2[0u];
                        let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                        let _e159 = global_4.member[_e132].member.member_2[1u];
                        let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                        let _e167 = global_4.member[_e132].member.member_2[2u];
                        let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                        let _e175 = global_4.member[_e132].member.member[0u];
                        let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                        let _e183 = global_4.member[_e132].member.member[1u];
                        let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                        let _e191 = global_4.member[_e132].member.member[2u];
                        let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                        let _e195 = select(_e161, _e153, (_e161 < _e153));
                        let _e197 = select(_e169, _e195, (_e169 < _e195));
                        let _e199 = select(_e177, _e197, (_e177 < _e197));
                        let _e201 = select(_e185, _e199, (_e185 < _e199));
                        let _e203 = select(_e193, _e201, (_e193 < _e201));
                        let _e208 = global_4.member[_e132].member.member_1;
                        let _e210 = (bitcast<u32>(_e208) & 2147483647u);
                        let _e218 = global_4.member[_e132].member.member_3;
                        let _e224 = (((select(_e210, _e203, (_e210 < _e203)) < 2139095040u) && ((bitcast<u32>(_e218) & 2147483647u) <= 2139095040u)) && (_e197 > 0u));
                        if _e224 {
                            let _e227 = (bitcast<u32>(bitcast<f32>(_e197)) & 2147483647u);
                            if (_e227 >= 8388608u) {
                                phi_348_ = (bitcast<i32>((_e227 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_348_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e227)), 32u, (_e227 == 0u))));
                            }
                            let _e241 = phi_348_;
                            phi_349_ = _e241;
                        } else {
                            phi_349_ = 0i;
                        }
                        let _e243 = phi_349_;
                        let _e244 = (_e153 == _e197);
                        if _e244 {
                            phi_359_ = true;
                        } else {
                            phi_359_ = (_e161 == _e197);
                        }
                        let _e247 = phi_359_;
                        let _e248 = select(1u, 0u, _e244);
                        if _e247 {
                            let _e249 = (_e248 + 1u);
                            phi_369_ = _e249;
                            phi_370_ = _e249;
                            phi_372_ = select(true, false, (_e249 == 2u));
                        } else {
                            phi_369_ = u32();
                            phi_370_ = 0u;
                            phi_372_ = true;
                        }
                        let _e253 = phi_369_;
                        let _e255 = phi_370_;
                        let _e257 = phi_372_;
                        if _e257 {
                            phi_377_ = (_e255 + 1u);
                        } else {
                            phi_377_ = 0u;
                        }
                        let _e261 = phi_377_;
                        let _e262 = select(_e253, _e255, _e257);
                        let _e263 = select(_e248, select(2u, _e248, _e247), _e257);
                        let _e264 = -(_e243);
                        if (_e264 < -126i) {
                            phi_410_ = -126i;
                        } else {
                            phi_410_ = select(_e264, 127i, (_e264 > 127i));
                        }
                        let _e269 = phi_410_;
                        let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                        let _e280 = bitcast<f32>((bitcast<u32>(((_e264 - _e269) + 127i)) << bitcast<u32>(23i)));
                        let _e285 = global_4.member[_e132].member.member;
                        let _e286 = (_e262 == 0u);
                        if _e286 {
                            phi_428_ = _e285[0];
                        } else {
                            phi_428_ = _e285[1];
                        }
                        let _e290 = phi_428_;
                        let _e291 = (_e262 == 2u);
                        if _e291 {
                            phi_434_ = _e285[2];
                        } else {
                            phi_434_ = _e290;
                        }
                        let _e294 = phi_434_;
                        let _e295 = global_4.member[_e132].member.member_2;
                        if _e286 {
                            phi_445_ = _e295[0];
                        } else {
                            phi_445_ = _e295[1];
                        }
                        let _e299 = phi_445_;
                        if _e291 {
                            phi_451_ = _e295[2];
                        } else {
                            phi_451_ = _e299;
                        }
                        let _e302 = phi_451_;
                        let _e304 = ((_e302 * _e274) * _e280);
                        let _e308 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e308 {
                            let _e312 = (bitcast<f32>((bitcast<u32>(_e294) & 2147483647u)) * 0.00000011920929f);
                            phi_474_ = select(0.00000000000011368684f, _e312, (_e312 > 0.00000000000011368684f));
                        } else {
                            phi_474_ = 0f;
                        }
                        let _e316 = phi_474_;
                        let _e317 = (_e294 + _e316);
                        let _e318 = (_e294 - _e316);
                        let _e319 = select(_e304, 0f, _e308);
                        if _e308 {
                            phi_485_ = 38685626000000000000000000f;
                        } else {
                            phi_485_ = (1f / _e304);
                        }
                        let _e322 = phi_485_;
                        let _e323 = (_e261 == 0u);
                        if _e323 {
                            phi_494_ = _e285[0];
                        } else {
                            phi_494_ = _e285[1];
                        }
                        let _e327 = phi_494_;
                        let _e328 = (_e261 == 2u);
                        if _e328 {
                            phi_500_ = _e285[2];
                        } else {
                            phi_500_ = _e327;
                        }
                        let _e331 = phi_500_;
                        if _e323 {
                            phi_511_ = _e295[0];
                        } else {
                            phi_511_ = _e295[1];
                        }
                        let _e335 = phi_511_;
                        if _e328 {
                            phi_517_ = _e295[2];
                        } else {
                            phi_517_ = _e335;
                        }
                        let _e338 = phi_517_;
                        let _e340 = ((_e338 * _e274) * _e280);
                        let _e344 = (bitcast<f32>((bitcast<u32>(_e340) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e344 {
                            let _e348 = (bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)) * 0.00000011920929f);
                            phi_540_ = select(0.00000000000011368684f, _e348, (_e348 > 0.00000000000011368684f));
                        } else {
                            phi_540_ = 0f;
                        }
                        let _e352 = phi_540_;
                        let _e353 = (_e331 + _e352);
                        let _e354 = (_e331 - _e352);
                        let _e355 = select(_e340, 0f, _e344);
                        if _e344 {
                            phi_551_ = 38685626000000000000000000f;
                        } else {
                            phi_551_ = (1f / _e340);
                        }
                        let _e358 = phi_551_;
                        let _e359 = (_e263 == 0u);
                        if _e359 {
                            phi_560_ = _e285[0];
                        } else {
                            phi_560_ = _e285[1];
                        }
                        let _e363 = phi_560_;
                        let _e364 = (_e263 == 2u);
                        if _e364 {
                            phi_566_ = _e285[2];
                        } else {
                            phi_566_ = _e363;
                        }
                        let _e367 = phi_566_;
                        if _e359 {
                            phi_577_ = _e295[0];
                        } else {
                            phi_577_ = _e295[1];
                        }
                        let _e371 = phi_577_;
                        if _e364 {
                            phi_583_ = _e295[2];
                        } else {
                            phi_583_ = _e371;
                        }
                        let _e374 = phi_583_;
                        let _e376 = ((_e374 * _e274) * _e280);
                        let _e380 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e380 {
                            let _e384 = (bitcast<f32>((bitcast<u32>(_e367) & 2147483647u)) * 0.00000011920929f);
                            phi_606_ = select(0.00000000000011368684f, _e384, (_e384 > 0.00000000000011368684f));
                        } else {
                            phi_606_ = 0f;
                        }
                        let _e388 = phi_606_;
                        let _e389 = (_e367 + _e388);
                        let _e390 = (_e367 - _e388);
                        let _e391 = select(_e376, 0f, _e380);
                        if _e380 {
                            phi_617_ = 38685626000000000000000000f;
                        } else {
                            phi_617_ = (1f / _e376);
                        }
                        let _e394 = phi_617_;
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
                            phi_717_ = select(-340282350000000000000000000000000000000f, _e434, (_e434 > -340282350000000000000000000000000000000f));
                            phi_718_ = select(-340282350000000000000000000000000000000f, _e427, (_e427 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_717_ = 0f;
                            phi_718_ = 1f;
                        }
                        let _e438 = phi_717_;
                        let _e440 = phi_718_;
                        if _e139 {
                        } else {
                            break;
                        }
                        let _e446 = global_4.member[_e132].member_2;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_17 = array<f32, 3>(bitcast<f32>(_e104), bitcast<f32>(_e108), bitcast<f32>(_e112));
                        let _e450 = (_e262 % 3u);
                        let _e451 = (_e450 < 3u);
                        if _e451 {
                        } else {
                            break;
                        }
                        let _e453 = local_17[_e450];
                        let _e454 = (_e261 % 3u);
                        let _e455 = (_e454 < 3u);
                        if _e455 {
                        } else {
                            break;
                        }
                        let _e457 = local_17[_e454];
                        let _e458 = (_e263 % 3u);
                        let _e459 = (_e458 < 3u);
                        if _e459 {
                        } else {
                            break;
                        }
                        let _e461 = local_17[_e458];
                        local_16 = array<f32, 3>(bitcast<f32>(_e116), bitcast<f32>(_e120), bitcast<f32>(_e124));
                        if _e451 {
                        } else {
                            break;
                        }
                        let _e465 = local_16[_e450];
                        if _e455 {
                        } else {
                            break;
                        }
                        let _e467 = local_16[_e454];
                        if _e459 {
                        } else {
                            break;
                        }
                        let _e469 = local_16[_e458];
                        phi_2823_ = false;
                        phi_800_ = type_41(type_38(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e438), 0u, 0u);
                        phi_803_ = type_54(type_52(array<f32, 3>(_e453, _e457, _e461), array<f32, 3>(_e465, _e467, _e469)), select(0u, 2147483648u, (_e90 == 0u)));
                        phi_805_ = ((3u * _e90) + 1u);
                        phi_807_ = (_e440 <= _e438);
                        phi_809_ = 0u;
                        loop {
                            let _e477 = phi_2823_;
                            let _e479 = phi_800_;
                            let _e481 = phi_803_;
                            let _e483 = phi_805_;
                            let _e485 = phi_807_;
                            let _e487 = phi_809_;
                            local_18 = _e479;
                            local_19 = _e479;
                            if _e485 {
                                phi_820_ = true;
                            } else {
                                phi_820_ = (_e487 > 0u);
                            }
                            let _e490 = phi_820_;
                            if _e490 {
                                let _e491 = (_e483 > 0u);
                                if _e491 {
                                    if _e485 {
                                        phi_906_ = _e481;
                                        phi_907_ = _e485;
                                        phi_908_ = _e487;
                                    } else {
                                        let _e492 = (_e487 - 1u);
                                        let _e493 = (_e492 % 128u);
                                        let _e494 = (_e493 < 128u);
                                        if _e494 {
                                        } else {
                                            phi_2947_ = true;
                                            break;
                                        }
                                        let _e496 = local_6[_e493];
                                        if _e494 {
                                        } else {
                                            phi_2947_ = true;
                                            break;
                                        }
                                        let _e498 = local_5[_e493];
                                        if _e494 {
                                        } else {
                                            phi_2947_ = true;
                                            break;
                                        }
                                        let _e500 = local_4[_e493];
                                        if _e494 {
                                        } else {
                                            phi_2947_ = true;
                                            break;
                                        }
                                        let _e502 = local_3[_e493];
                                        if _e494 {
                                        } else {
                                            phi_2947_ = true;
                                            break;
                                        }
                                        let _e505 = local_2[_e493];
                                        if _e494 {
                                        } else {
                                            phi_2947_ = true;
                                            break;
                                        }
                                        let _e507 = local_1[_e493];
                                        if _e494 {
                                        } else {
                                            phi_2947_ = true;
                                            break;
                                        }
                                        let _e509 = local[_e493];
                                        if _e494 {
                                        } else {
                                            phi_2947_ = true;
                                            break;
                                        }
                                        let _e514 = local_9[_e493];
                                        phi_906_ = type_54(type_52(array<f32, 3>(_e498, _e500, _e502), array<f32, 3>(_e505, _e507, _e509)), _e496);
                                        phi_907_ = (_e514 <= _e479.member.member_1);
                                        phi_908_ = _e492;
                                    }
                                    let _e519 = phi_906_;
                                    let _e521 = phi_907_;
                                    let _e523 = phi_908_;
                                    if _e521 {
                                        if ((_e519.member_1 & 2147483648u) != 0u) {
                                            phi_926_ = _e479;
                                            phi_929_ = type_7(0u, ((_e519.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e855 = phi_926_;
                                                let _e857 = phi_929_;
                                                local_20 = _e855;
                                                if (_e857.member < _e857.member_1) {
                                                    phi_930_ = type_7((_e857.member + 1u), _e857.member_1);
                                                    phi_952_ = type_7(1u, _e857.member);
                                                } else {
                                                    phi_930_ = _e857;
                                                    phi_952_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e870 = phi_930_;
                                                let _e872 = phi_952_;
                                                let _e876 = (bitcast<i32>(_e872.member) != 0i);
                                                if _e876 {
                                                    let _e882 = type_41(_e855.member, _e855.member_1, (_e855.member_2 + 1u));
                                                    let _e883 = ((_e519.member_1 & 268435455u) + _e872.member_1);
                                                    let _e884 = (_e883 < _e92);
                                                    if _e884 {
                                                        if _e884 {
                                                        } else {
                                                            phi_2884_ = true;
                                                            break;
                                                        }
                                                        let _e888 = global_1.member[_e883].member_1;
                                                        phi_976_ = _e888;
                                                    } else {
                                                        phi_976_ = 4294967295u;
                                                    }
                                                    let _e890 = phi_976_;
                                                    if (_e883 >= _e92) {
                                                        phi_1065_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e884 {
                                                        } else {
                                                            phi_2884_ = true;
                                                            break;
                                                        }
                                                        if (_e450 < 9u) {
                                                        } else {
                                                            phi_2884_ = true;
                                                            break;
                                                        }
                                                        let _e897 = global_1.member[_e883].member[_e450];
                                                        if (_e454 < 9u) {
                                                        } else {
                                                            phi_2884_ = true;
                                                            break;
                                                        }
                                                        let _e903 = global_1.member[_e883].member[_e454];
                                                        if (_e458 < 9u) {
                                                        } else {
                                                            phi_2884_ = true;
                                                            break;
                                                        }
                                                        let _e909 = global_1.member[_e883].member[_e458];
                                                        let _e911 = (3u + _e450);
                                                        if (_e911 < 9u) {
                                                        } else {
                                                            phi_2884_ = true;
                                                            break;
                                                        }
                                                        let _e917 = global_1.member[_e883].member[_e911];
                                                        let _e918 = (3u + _e454);
                                                        if (_e918 < 9u) {
                                                        } else {
                                                            phi_2884_ = true;
                                                            break;
                                                        }
                                                        let _e924 = global_1.member[_e883].member[_e918];
                                                        let _e925 = (3u + _e458);
                                                        if (_e925 < 9u) {
                                                        } else {
                                                            phi_2884_ = true;
                                                            break;
                                                        }
                                                        let _e931 = global_1.member[_e883].member[_e925];
                                                        let _e933 = (6u + _e450);
                                                        if (_e933 < 9u) {
                                                        } else {
                                                            phi_2884_ = true;
                                                            break;
                                                        }
                                                        let _e939 = global_1.member[_e883].member[_e933];
                                                        let _e940 = (6u + _e454);
                                                        if (_e940 < 9u) {
                                                        } else {
                                                            phi_2884_ = true;
                                                            break;
                                                        }
                                                        let _e946 = global_1.member[_e883].member[_e940];
                                                        let _e947 = (6u + _e458);
                                                        if (_e947 < 9u) {
                                                        } else {
                                                            phi_2884_ = true;
                                                            break;
                                                        }
                                                        let _e953 = global_1.member[_e883].member[_e947];
                                                        phi_1065_ = array<array<f32, 3>, 3>(array<f32, 3>(_e897, _e903, _e909), array<f32, 3>(_e917, _e924, _e931), array<f32, 3>(_e939, _e946, _e953));
                                                    }
                                                    let _e957 = phi_1065_;
                                                    let _e966 = (_e957[0][2] - _e367);
                                                    let _e969 = (((_e957[0][0] - _e294) * _e391) - (_e966 * _e319));
                                                    let _e972 = (((_e957[0][1] - _e331) * _e391) - (_e966 * _e355));
                                                    let _e979 = (_e957[1][2] - _e367);
                                                    let _e982 = (((_e957[1][0] - _e294) * _e391) - (_e979 * _e319));
                                                    let _e985 = (((_e957[1][1] - _e331) * _e391) - (_e979 * _e355));
                                                    let _e992 = (_e957[2][2] - _e367);
                                                    let _e995 = (((_e957[2][0] - _e294) * _e391) - (_e992 * _e319));
                                                    let _e998 = (((_e957[2][1] - _e331) * _e391) - (_e992 * _e355));
                                                    let _e999 = (_e995 * _e985);
                                                    let _e1000 = (_e998 * _e982);
                                                    let _e1001 = (_e969 * _e998);
                                                    let _e1002 = (_e972 * _e995);
                                                    let _e1003 = (_e982 * _e972);
                                                    let _e1004 = (_e985 * _e969);
                                                    let _e1009 = (((_e999 >= _e1000) && (_e1001 >= _e1002)) && (_e1003 >= _e1004));
                                                    if (_e1009 || (((_e999 <= _e1000) && (_e1001 <= _e1002)) && (_e1003 <= _e1004))) {
                                                        let _e1016 = select(-1f, 1f, _e1009);
                                                        let _e1018 = ((_e999 - _e1000) * _e1016);
                                                        let _e1020 = select(0f, _e1018, (_e1018 > 0f));
                                                        let _e1022 = ((_e1001 - _e1002) * _e1016);
                                                        let _e1024 = select(0f, _e1022, (_e1022 > 0f));
                                                        let _e1026 = ((_e1003 - _e1004) * _e1016);
                                                        let _e1028 = select(0f, _e1026, (_e1026 > 0f));
                                                        let _e1030 = ((_e1020 + _e1024) + _e1028);
                                                        if (_e1030 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1631_ = type_23();
                                                            phi_1632_ = true;
                                                        } else {
                                                            let _e1033 = select(_e957[1][0], _e957[0][0], (_e957[0][0] < _e957[1][0]));
                                                            let _e1037 = select(_e957[1][0], _e957[0][0], (_e957[0][0] > _e957[1][0]));
                                                            let _e1041 = select(_e957[1][1], _e957[0][1], (_e957[0][1] < _e957[1][1]));
                                                            let _e1045 = select(_e957[1][1], _e957[0][1], (_e957[0][1] > _e957[1][1]));
                                                            let _e1049 = select(_e957[1][2], _e957[0][2], (_e957[0][2] < _e957[1][2]));
                                                            let _e1053 = select(_e957[1][2], _e957[0][2], (_e957[0][2] > _e957[1][2]));
                                                            let _e1058 = ((select(_e957[2][0], _e1033, (_e1033 < _e957[2][0])) - _e317) * _e322);
                                                            let _e1059 = ((select(_e957[2][0], _e1037, (_e1037 > _e957[2][0])) - _e318) * _e322);
                                                            let _e1062 = ((select(_e957[2][1], _e1041, (_e1041 < _e957[2][1])) - _e353) * _e358);
                                                            let _e1063 = ((select(_e957[2][1], _e1045, (_e1045 > _e957[2][1])) - _e354) * _e358);
                                                            let _e1066 = ((select(_e957[2][2], _e1049, (_e1049 < _e957[2][2])) - _e389) * _e394);
                                                            let _e1067 = ((select(_e957[2][2], _e1053, (_e1053 > _e957[2][2])) - _e390) * _e394);
                                                            let _e1069 = select(_e1067, _e1066, (_e1066 < _e1067));
                                                            let _e1071 = select(_e1067, _e1066, (_e1066 > _e1067));
                                                            let _e1073 = select(_e1059, _e1058, (_e1058 < _e1059));
                                                            let _e1075 = select(_e1063, _e1062, (_e1062 < _e1063));
                                                            let _e1077 = select(_e1075, _e1073, (_e1073 > _e1075));
                                                            let _e1079 = select(_e1069, _e1077, (_e1077 > _e1069));
                                                            let _e1081 = select(_e1059, _e1058, (_e1058 > _e1059));
                                                            let _e1083 = select(_e1063, _e1062, (_e1062 > _e1063));
                                                            let _e1085 = select(_e1083, _e1081, (_e1081 < _e1083));
                                                            let _e1087 = select(_e1071, _e1085, (_e1085 < _e1071));
                                                            let _e1088 = -(_e1069);
                                                            let _e1094 = select(_e440, _e1079, (_e1079 > _e440));
                                                            if (_e1094 > (_e1087 + (select(_e1088, _e1071, (_e1071 > _e1088)) * 0.0000019073523f))) {
                                                                phi_1626_ = type_23();
                                                                phi_1627_ = true;
                                                            } else {
                                                                let _e1096 = (_e1094 > _e855.member.member_1);
                                                                if _e1096 {
                                                                    phi_1625_ = type_23();
                                                                } else {
                                                                    let _e1100 = (_e957[1][0] - _e957[0][0]);
                                                                    let _e1101 = (_e957[1][1] - _e957[0][1]);
                                                                    let _e1102 = (_e957[1][2] - _e957[0][2]);
                                                                    let _e1103 = vec3<f32>(_e1100, _e1101, _e1102);
                                                                    let _e1104 = (_e957[2][0] - _e957[1][0]);
                                                                    let _e1105 = (_e957[2][1] - _e957[1][1]);
                                                                    let _e1106 = (_e957[2][2] - _e957[1][2]);
                                                                    let _e1107 = vec3<f32>(_e1104, _e1105, _e1106);
                                                                    let _e1108 = (_e957[0][0] - _e957[2][0]);
                                                                    let _e1109 = (_e957[0][1] - _e957[2][1]);
                                                                    let _e1110 = (_e957[0][2] - _e957[2][2]);
                                                                    let _e1111 = vec3<f32>(_e1108, _e1109, _e1110);
                                                                    let _e1114 = bitcast<f32>((bitcast<u32>(_e1100) & 2147483647u));
                                                                    let _e1117 = bitcast<f32>((bitcast<u32>(_e1101) & 2147483647u));
                                                                    let _e1119 = select(_e1117, _e1114, (_e1114 > _e1117));
                                                                    let _e1122 = bitcast<f32>((bitcast<u32>(_e1102) & 2147483647u));
                                                                    let _e1124 = select(_e1122, _e1119, (_e1119 > _e1122));
                                                                    let _e1127 = bitcast<f32>((bitcast<u32>(_e1104) & 2147483647u));
                                                                    let _e1130 = bitcast<f32>((bitcast<u32>(_e1105) & 2147483647u));
                                                                    let _e1132 = select(_e1130, _e1127, (_e1127 > _e1130));
                                                                    let _e1135 = bitcast<f32>((bitcast<u32>(_e1106) & 2147483647u));
                                                                    let _e1137 = select(_e1135, _e1132, (_e1132 > _e1135));
                                                                    let _e1140 = bitcast<f32>((bitcast<u32>(_e1108) & 2147483647u));
                                                                    let _e1143 = bitcast<f32>((bitcast<u32>(_e1109) & 2147483647u));
                                                                    let _e1145 = select(_e1143, _e1140, (_e1140 > _e1143));
                                                                    let _e1148 = bitcast<f32>((bitcast<u32>(_e1110) & 2147483647u));
                                                                    let _e1150 = select(_e1148, _e1145, (_e1145 > _e1148));
                                                                    let _e1152 = select(_e1137, _e1124, (_e1124 > _e1137));
                                                                    let _e1154 = select(_e1150, _e1152, (_e1152 > _e1150));
                                                                    if (_e1124 == _e1154) {
                                                                        phi_1536_ = _e1107;
                                                                        phi_1537_ = _e1111;
                                                                    } else {
                                                                        let _e1157 = vec3((_e1137 == _e1154));
                                                                        phi_1536_ = select(_e1103, _e1111, _e1157);
                                                                        phi_1537_ = select(_e1107, _e1103, _e1157);
                                                                    }
                                                                    let _e1161 = phi_1536_;
                                                                    let _e1163 = phi_1537_;
                                                                    let _e1170 = ((_e1161.y * _e1163.z) - (_e1163.y * _e1161.z));
                                                                    let _e1175 = ((_e1161.z * _e1163.x) - (_e1163.z * _e1161.x));
                                                                    let _e1178 = ((_e1161.x * _e1163.y) - (_e1163.x * _e1161.y));
                                                                    if (_e1020 >= _e1024) {
                                                                        phi_1568_ = select(true, false, (_e1020 >= _e1028));
                                                                    } else {
                                                                        phi_1568_ = true;
                                                                    }
                                                                    let _e1183 = phi_1568_;
                                                                    if _e1183 {
                                                                        phi_1577_ = select(vec3<f32>(_e957[2][0], _e957[2][1], _e957[2][2]), vec3<f32>(_e957[1][0], _e957[1][1], _e957[1][2]), vec3((_e1024 >= _e1028)));
                                                                    } else {
                                                                        phi_1577_ = vec3<f32>(_e957[0][0], _e957[0][1], _e957[0][2]);
                                                                    }
                                                                    let _e1188 = phi_1577_;
                                                                    let _e1205 = ((((_e1170 * (_e1188.x - _e294)) + (_e1175 * (_e1188.y - _e331))) + (_e1178 * (_e1188.z - _e367))) / (((_e1170 * _e319) + (_e1175 * _e355)) + (_e1178 * _e391)));
                                                                    let _e1207 = select(_e1087, _e1205, (_e1205 < _e1087));
                                                                    let _e1209 = select(_e1079, _e1207, (_e1207 > _e1079));
                                                                    if (_e1209 >= _e440) {
                                                                        let _e1211 = (_e1209 <= _e855.member.member_1);
                                                                        if _e1211 {
                                                                            let _e1212 = (1f / _e1030);
                                                                            phi_1617_ = type_23(_e1209, (_e1024 * _e1212), (_e1028 * _e1212), _e890);
                                                                        } else {
                                                                            phi_1617_ = type_23();
                                                                        }
                                                                        let _e1217 = phi_1617_;
                                                                        phi_1619_ = _e1217;
                                                                        phi_1620_ = select(true, false, _e1211);
                                                                    } else {
                                                                        phi_1619_ = type_23();
                                                                        phi_1620_ = true;
                                                                    }
                                                                    let _e1220 = phi_1619_;
                                                                    let _e1222 = phi_1620_;
                                                                    if _e1222 {
                                                                        phi_1624_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1624_ = _e1220;
                                                                    }
                                                                    let _e1224 = phi_1624_;
                                                                    phi_1625_ = _e1224;
                                                                }
                                                                let _e1226 = phi_1625_;
                                                                phi_1626_ = _e1226;
                                                                phi_1627_ = _e1096;
                                                            }
                                                            let _e1228 = phi_1626_;
                                                            let _e1230 = phi_1627_;
                                                            phi_1631_ = _e1228;
                                                            phi_1632_ = _e1230;
                                                        }
                                                        let _e1232 = phi_1631_;
                                                        let _e1234 = phi_1632_;
                                                        phi_1636_ = _e1232;
                                                        phi_1637_ = _e1234;
                                                    } else {
                                                        phi_1636_ = type_23();
                                                        phi_1637_ = true;
                                                    }
                                                    let _e1236 = phi_1636_;
                                                    let _e1238 = phi_1637_;
                                                    if _e1238 {
                                                        phi_1641_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1641_ = _e1236;
                                                    }
                                                    let _e1240 = phi_1641_;
                                                    if (_e1240.member_3 != 4294967295u) {
                                                        if (_e890 != _e446) {
                                                            if (_e1240.member < _e855.member.member.member) {
                                                                phi_1667_ = true;
                                                            } else {
                                                                if (_e1240.member == _e855.member.member.member) {
                                                                    phi_1666_ = (_e1240.member_3 < _e855.member.member.member_3);
                                                                } else {
                                                                    phi_1666_ = false;
                                                                }
                                                                let _e1255 = phi_1666_;
                                                                phi_1667_ = _e1255;
                                                            }
                                                            let _e1257 = phi_1667_;
                                                            if _e1257 {
                                                                phi_1674_ = type_41(type_38(_e1240, _e1240.member), _e882.member_1, _e882.member_2);
                                                            } else {
                                                                phi_1674_ = _e882;
                                                            }
                                                            let _e1264 = phi_1674_;
                                                            phi_1675_ = _e1264;
                                                        } else {
                                                            phi_1675_ = _e882;
                                                        }
                                                        let _e1266 = phi_1675_;
                                                        phi_1676_ = _e1266;
                                                    } else {
                                                        phi_1676_ = _e882;
                                                    }
                                                    let _e1268 = phi_1676_;
                                                    phi_927_ = _e1268;
                                                } else {
                                                    phi_927_ = type_41();
                                                }
                                                let _e1270 = phi_927_;
                                                continue;
                                                continuing {
                                                    phi_926_ = _e1270;
                                                    phi_929_ = _e870;
                                                    phi_2884_ = _e477;
                                                    break if !(_e876);
                                                }
                                            }
                                            let _e1273 = phi_2884_;
                                            phi_2947_ = _e1273;
                                            if _e1273 {
                                                break;
                                            }
                                            phi_2951_ = _e1273;
                                            let _e1491 = local_20;
                                            phi_2561_ = _e1491;
                                            phi_2562_ = _e519;
                                            phi_2563_ = false;
                                            phi_2564_ = _e523;
                                        } else {
                                            local_8 = array<f32, 3>(_e519.member.member[0], _e519.member.member[1], _e519.member.member[2]);
                                            local_7 = array<f32, 3>(_e519.member.member_1[0], _e519.member.member_1[1], _e519.member.member_1[2]);
                                            let _e549 = (_e519.member_1 < _e90);
                                            if _e549 {
                                                if _e549 {
                                                } else {
                                                    phi_2947_ = true;
                                                    break;
                                                }
                                                let _e551 = global_7.member[_e519.member_1];
                                                phi_1713_ = _e551;
                                            } else {
                                                phi_1713_ = type_45(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e553 = phi_1713_;
                                            let _e555 = array<u32, 3>(_e262, _e261, _e263);
                                            local_15 = _e555;
                                            local_11 = array<f32, 3>(0f, 0f, 0f);
                                            local_10 = array<f32, 3>(0f, 0f, 0f);
                                            phi_1722_ = type_7(0u, 3u);
                                            loop {
                                                let _e557 = phi_1722_;
                                                if (_e557.member < _e557.member_1) {
                                                    phi_1723_ = type_7((_e557.member + 1u), _e557.member_1);
                                                    phi_1746_ = type_7(1u, _e557.member);
                                                } else {
                                                    phi_1723_ = _e557;
                                                    phi_1746_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e570 = phi_1723_;
                                                let _e572 = phi_1746_;
                                                let _e576 = (bitcast<i32>(_e572.member) != 0i);
                                                if _e576 {
                                                    let _e577 = (_e572.member_1 < 3u);
                                                    if _e577 {
                                                    } else {
                                                        phi_2816_ = true;
                                                        break;
                                                    }
                                                    let _e579 = local_15[_e572.member_1];
                                                    if _e577 {
                                                    } else {
                                                        phi_2816_ = true;
                                                        break;
                                                    }
                                                    let _e581 = local_8[_e572.member_1];
                                                    if _e577 {
                                                    } else {
                                                        phi_2816_ = true;
                                                        break;
                                                    }
                                                    let _e583 = local_7[_e572.member_1];
                                                    let _e586 = ((10u * _e579) & 31u);
                                                    let _e589 = ((_e553.member[0] >> bitcast<u32>(_e586)) & 1023u);
                                                    let _e594 = bitcast<f32>((bitcast<u32>(((_e583 - _e581) * 0.0009775171f)) ^ _e128));
                                                    let _e600 = (_e581 + bitcast<f32>((bitcast<u32>((f32(_e589) * _e594)) ^ _e128)));
                                                    if _e577 {
                                                    } else {
                                                        phi_2816_ = true;
                                                        break;
                                                    }
                                                    local_11[_e572.member_1] = select(select(_e583, _e600, (_e600 < _e583)), _e583, (_e589 == 1023u));
                                                    let _e609 = ((_e553.member[1] >> bitcast<u32>(_e586)) & 1023u);
                                                    let _e615 = (_e581 + bitcast<f32>((bitcast<u32>((f32(_e609) * _e594)) ^ _e128)));
                                                    if _e577 {
                                                    } else {
                                                        phi_2816_ = true;
                                                        break;
                                                    }
                                                    local_10[_e572.member_1] = select(select(_e583, _e615, (_e615 < _e583)), _e583, (_e609 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_1722_ = _e570;
                                                    phi_2816_ = _e477;
                                                    break if !(_e576);
                                                }
                                            }
                                            let _e623 = phi_2816_;
                                            phi_2947_ = _e623;
                                            if _e623 {
                                                break;
                                            }
                                            let _e624 = local_10;
                                            let _e625 = local_11;
                                            local_14 = _e555;
                                            local_13 = array<f32, 3>(0f, 0f, 0f);
                                            local_12 = array<f32, 3>(0f, 0f, 0f);
                                            phi_1876_ = type_7(0u, 3u);
                                            loop {
                                                let _e634 = phi_1876_;
                                                if (_e634.member < _e634.member_1) {
                                                    phi_1877_ = type_7((_e634.member + 1u), _e634.member_1);
                                                    phi_1900_ = type_7(1u, _e634.member);
                                                } else {
                                                    phi_1877_ = _e634;
                                                    phi_1900_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e647 = phi_1877_;
                                                let _e649 = phi_1900_;
                                                let _e653 = (bitcast<i32>(_e649.member) != 0i);
                                                if _e653 {
                                                    let _e654 = (_e649.member_1 < 3u);
                                                    if _e654 {
                                                    } else {
                                                        phi_2876_ = true;
                                                        break;
                                                    }
                                                    let _e656 = local_14[_e649.member_1];
                                                    if _e654 {
                                                    } else {
                                                        phi_2876_ = true;
                                                        break;
                                                    }
                                                    let _e658 = local_8[_e649.member_1];
                                                    if _e654 {
                                                    } else {
                                                        phi_2876_ = true;
                                                        break;
                                                    }
                                                    let _e660 = local_7[_e649.member_1];
                                                    let _e663 = ((10u * _e656) & 31u);
                                                    let _e666 = ((_e553.member_1[0] >> bitcast<u32>(_e663)) & 1023u);
                                                    let _e671 = bitcast<f32>((bitcast<u32>(((_e660 - _e658) * 0.0009775171f)) ^ _e128));
                                                    let _e677 = (_e658 + bitcast<f32>((bitcast<u32>((f32(_e666) * _e671)) ^ _e128)));
                                                    if _e654 {
                                                    } else {
                                                        phi_2876_ = true;
                                                        break;
                                                    }
                                                    local_13[_e649.member_1] = select(select(_e660, _e677, (_e677 < _e660)), _e660, (_e666 == 1023u));
                                                    let _e686 = ((_e553.member_1[1] >> bitcast<u32>(_e663)) & 1023u);
                                                    let _e692 = (_e658 + bitcast<f32>((bitcast<u32>((f32(_e686) * _e671)) ^ _e128)));
                                                    if _e654 {
                                                    } else {
                                                        phi_2876_ = true;
                                                        break;
                                                    }
                                                    local_12[_e649.member_1] = select(select(_e660, _e692, (_e692 < _e660)), _e660, (_e686 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_1876_ = _e647;
                                                    phi_2876_ = _e623;
                                                    break if !(_e653);
                                                }
                                            }
                                            let _e700 = phi_2876_;
                                            phi_2947_ = _e700;
                                            if _e700 {
                                                break;
                                            }
                                            let _e701 = local_12;
                                            let _e702 = local_13;
                                            let _e713 = type_54(type_52(array<f32, 3>(_e625[0], _e625[1], _e625[2]), array<f32, 3>(_e624[0], _e624[1], _e624[2])), _e553.member_2);
                                            let _e718 = type_54(type_52(array<f32, 3>(_e702[0], _e702[1], _e702[2]), array<f32, 3>(_e701[0], _e701[1], _e701[2])), _e553.member_3);
                                            let _e725 = ((_e625[0] - _e317) * _e322);
                                            let _e726 = ((_e702[0] - _e317) * _e322);
                                            let _e727 = ((_e624[0] - _e318) * _e322);
                                            let _e728 = ((_e701[0] - _e318) * _e322);
                                            let _e733 = ((_e625[1] - _e353) * _e358);
                                            let _e734 = ((_e702[1] - _e353) * _e358);
                                            let _e735 = ((_e624[1] - _e354) * _e358);
                                            let _e736 = ((_e701[1] - _e354) * _e358);
                                            let _e741 = ((_e625[2] - _e389) * _e394);
                                            let _e742 = ((_e702[2] - _e389) * _e394);
                                            let _e743 = ((_e624[2] - _e390) * _e394);
                                            let _e744 = ((_e701[2] - _e390) * _e394);
                                            let _e746 = select(_e743, _e741, (_e741 < _e743));
                                            let _e748 = select(_e744, _e742, (_e742 < _e744));
                                            let _e750 = select(_e743, _e741, (_e741 > _e743));
                                            let _e752 = select(_e744, _e742, (_e742 > _e744));
                                            let _e754 = select(_e727, _e725, (_e725 < _e727));
                                            let _e756 = select(_e728, _e726, (_e726 < _e728));
                                            let _e758 = select(_e735, _e733, (_e733 < _e735));
                                            let _e760 = select(_e736, _e734, (_e734 < _e736));
                                            let _e762 = select(_e758, _e754, (_e754 > _e758));
                                            let _e764 = select(_e760, _e756, (_e756 > _e760));
                                            let _e766 = select(_e746, _e762, (_e762 > _e746));
                                            let _e768 = select(_e748, _e764, (_e764 > _e748));
                                            let _e770 = select(_e727, _e725, (_e725 > _e727));
                                            let _e772 = select(_e728, _e726, (_e726 > _e728));
                                            let _e774 = select(_e735, _e733, (_e733 > _e735));
                                            let _e776 = select(_e736, _e734, (_e734 > _e736));
                                            let _e778 = select(_e774, _e770, (_e770 < _e774));
                                            let _e780 = select(_e776, _e772, (_e772 < _e776));
                                            let _e785 = -(_e746);
                                            let _e786 = -(_e748);
                                            let _e793 = (select(_e750, _e778, (_e778 < _e750)) + (select(_e785, _e750, (_e750 > _e785)) * 0.0000019073523f));
                                            let _e794 = (select(_e752, _e780, (_e780 < _e752)) + (select(_e786, _e752, (_e752 > _e786)) * 0.0000019073523f));
                                            let _e796 = select(_e440, _e766, (_e766 > _e440));
                                            let _e798 = select(_e440, _e768, (_e768 > _e440));
                                            let _e803 = (_e796 <= select(_e479.member.member_1, _e793, (_e793 < _e479.member.member_1)));
                                            let _e804 = (_e798 <= select(_e479.member.member_1, _e794, (_e794 < _e479.member.member_1)));
                                            let _e805 = (_e796 <= _e798);
                                            if _e803 {
                                                if _e804 {
                                                    if _e805 {
                                                        phi_2463_ = _e718;
                                                    } else {
                                                        phi_2463_ = _e713;
                                                    }
                                                    let _e807 = phi_2463_;
                                                    let _e815 = (_e523 % 128u);
                                                    let _e816 = (_e815 < 128u);
                                                    if _e816 {
                                                    } else {
                                                        phi_2947_ = true;
                                                        break;
                                                    }
                                                    local_6[_e815] = _e807.member_1;
                                                    if _e816 {
                                                    } else {
                                                        phi_2947_ = true;
                                                        break;
                                                    }
                                                    local_5[_e815] = _e807.member.member[0];
                                                    if _e816 {
                                                    } else {
                                                        phi_2947_ = true;
                                                        break;
                                                    }
                                                    local_4[_e815] = _e807.member.member[1];
                                                    if _e816 {
                                                    } else {
                                                        phi_2947_ = true;
                                                        break;
                                                    }
                                                    local_3[_e815] = _e807.member.member[2];
                                                    if _e816 {
                                                    } else {
                                                        phi_2947_ = true;
                                                        break;
                                                    }
                                                    local_2[_e815] = _e807.member.member_1[0];
                                                    if _e816 {
                                                    } else {
                                                        phi_2947_ = true;
                                                        break;
                                                    }
                                                    local_1[_e815] = _e807.member.member_1[1];
                                                    if _e816 {
                                                    } else {
                                                        phi_2947_ = true;
                                                        break;
                                                    }
                                                    local[_e815] = _e807.member.member_1[2];
                                                    if _e816 {
                                                    } else {
                                                        phi_2947_ = true;
                                                        break;
                                                    }
                                                    local_9[_e815] = select(_e798, _e796, (_e796 > _e798));
                                                    if _e805 {
                                                        phi_2540_ = _e713;
                                                    } else {
                                                        phi_2540_ = _e718;
                                                    }
                                                    let _e833 = phi_2540_;
                                                    phi_2541_ = _e833;
                                                    phi_2542_ = (_e523 + 1u);
                                                } else {
                                                    phi_2541_ = type_54();
                                                    phi_2542_ = u32();
                                                }
                                                let _e835 = phi_2541_;
                                                let _e837 = phi_2542_;
                                                phi_2544_ = _e835;
                                                phi_2545_ = _e837;
                                                phi_2546_ = select(true, false, _e804);
                                            } else {
                                                phi_2544_ = type_54();
                                                phi_2545_ = u32();
                                                phi_2546_ = true;
                                            }
                                            let _e840 = phi_2544_;
                                            let _e842 = phi_2545_;
                                            let _e844 = phi_2546_;
                                            if _e844 {
                                                if _e803 {
                                                    phi_2553_ = _e713;
                                                } else {
                                                    phi_2553_ = _e718;
                                                }
                                                let _e846 = phi_2553_;
                                                phi_2558_ = _e846;
                                                phi_2559_ = select(_e804, true, _e803);
                                            } else {
                                                phi_2558_ = _e840;
                                                phi_2559_ = _e521;
                                            }
                                            let _e849 = phi_2558_;
                                            let _e851 = phi_2559_;
                                            phi_2951_ = _e700;
                                            phi_2561_ = type_41(_e479.member, (_e479.member_1 + 1u), _e479.member_2);
                                            phi_2562_ = _e849;
                                            phi_2563_ = _e851;
                                            phi_2564_ = select(_e842, _e523, _e844);
                                        }
                                        let _e1275 = phi_2951_;
                                        let _e1277 = phi_2561_;
                                        let _e1279 = phi_2562_;
                                        let _e1281 = phi_2563_;
                                        let _e1283 = phi_2564_;
                                        phi_2950_ = _e1275;
                                        phi_2565_ = _e1277;
                                        phi_2566_ = _e1279;
                                        phi_2567_ = (_e483 - 1u);
                                        phi_2568_ = _e1281;
                                        phi_2569_ = _e1283;
                                    } else {
                                        phi_2950_ = _e477;
                                        phi_2565_ = _e479;
                                        phi_2566_ = _e519;
                                        phi_2567_ = _e483;
                                        phi_2568_ = _e521;
                                        phi_2569_ = _e523;
                                    }
                                    let _e1285 = phi_2950_;
                                    let _e1287 = phi_2565_;
                                    let _e1289 = phi_2566_;
                                    let _e1291 = phi_2567_;
                                    let _e1293 = phi_2568_;
                                    let _e1295 = phi_2569_;
                                    phi_2949_ = _e1285;
                                    phi_2570_ = _e1287;
                                    phi_2571_ = _e1289;
                                    phi_2572_ = _e1291;
                                    phi_2573_ = _e1293;
                                    phi_2574_ = _e1295;
                                } else {
                                    phi_2949_ = _e477;
                                    phi_2570_ = type_41();
                                    phi_2571_ = type_54();
                                    phi_2572_ = u32();
                                    phi_2573_ = bool();
                                    phi_2574_ = u32();
                                }
                                let _e1297 = phi_2949_;
                                let _e1299 = phi_2570_;
                                let _e1301 = phi_2571_;
                                let _e1303 = phi_2572_;
                                let _e1305 = phi_2573_;
                                let _e1307 = phi_2574_;
                                phi_2948_ = _e1297;
                                phi_801_ = _e1299;
                                phi_804_ = _e1301;
                                phi_806_ = _e1303;
                                phi_808_ = _e1305;
                                phi_810_ = _e1307;
                                phi_2575_ = _e491;
                            } else {
                                phi_2948_ = _e477;
                                phi_801_ = type_41();
                                phi_804_ = type_54();
                                phi_806_ = u32();
                                phi_808_ = bool();
                                phi_810_ = u32();
                                phi_2575_ = false;
                            }
                            let _e1309 = phi_2948_;
                            let _e1311 = phi_801_;
                            let _e1313 = phi_804_;
                            let _e1315 = phi_806_;
                            let _e1317 = phi_808_;
                            let _e1319 = phi_810_;
                            let _e1321 = phi_2575_;
                            continue;
                            continuing {
                                phi_2823_ = _e1309;
                                phi_800_ = _e1311;
                                phi_803_ = _e1313;
                                phi_805_ = _e1315;
                                phi_807_ = _e1317;
                                phi_809_ = _e1319;
                                phi_2947_ = _e1309;
                                break if !(_e1321);
                            }
                        }
                        let _e1324 = phi_2947_;
                        if _e1324 {
                            break;
                        }
                        let _e1326 = local_18;
                        if (_e1326.member.member.member_3 != 4294967295u) {
                            let _e1332 = (_e264 / 3i);
                            let _e1339 = bitcast<f32>((bitcast<u32>((_e1332 + 127i)) << bitcast<u32>(23i)));
                            let _e1347 = (((_e1326.member.member.member * _e1339) * _e1339) * bitcast<f32>((bitcast<u32>(((_e264 - (2i * _e1332)) + 127i)) << bitcast<u32>(23i))));
                            let _e1349 = select(340282350000000000000000000000000000000f, _e1347, (_e1347 < 340282350000000000000000000000000000000f));
                            phi_2627_ = type_23(select(-340282350000000000000000000000000000000f, _e1349, (_e1349 > -340282350000000000000000000000000000000f)), _e1326.member.member.member_1, _e1326.member.member.member_2, _e1326.member.member.member_3);
                        } else {
                            phi_2627_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1356 = phi_2627_;
                        if _e140 {
                        } else {
                            break;
                        }
                        global_2.member[_e132] = _e1356;
                        let _e1360 = local_19;
                        if _e141 {
                        } else {
                            break;
                        }
                        global_5.member[_e132] = _e1360.member_1;
                        if _e139 {
                        } else {
                            break;
                        }
                        let _e1365 = select(0u, 1u, (_e208 <= _e218));
                        if (_e1365 > 0u) {
                            let _e1367 = (1u < _e100);
                            if _e1367 {
                                if (0u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1371 = atomicAdd((&global_6.member[0u]), _e1365);
                                if ((_e1371 + _e1365) < _e1371) {
                                    if _e1367 {
                                    } else {
                                        break;
                                    }
                                    let _e1376 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1379 = select(0u, 1u, (_e1356.member_3 != 4294967295u));
                        if (_e1379 > 0u) {
                            let _e1381 = (3u < _e100);
                            if _e1381 {
                                if (2u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1385 = atomicAdd((&global_6.member[2u]), _e1379);
                                if ((_e1385 + _e1379) < _e1385) {
                                    if _e1381 {
                                    } else {
                                        break;
                                    }
                                    let _e1390 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1360.member_1 > 0u) {
                            let _e1392 = (5u < _e100);
                            if _e1392 {
                                if (4u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1396 = atomicAdd((&global_6.member[4u]), _e1360.member_1);
                                if ((_e1396 + _e1360.member_1) < _e1396) {
                                    if _e1392 {
                                    } else {
                                        break;
                                    }
                                    let _e1401 = atomicAdd((&global_6.member[5u]), 1u);
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
fn trace_paths_counted_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
