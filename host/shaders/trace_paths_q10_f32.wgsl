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

struct type_22 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_30 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_34 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_35 {
    member: type_34,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_42 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_44 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_47 {
    member: type_30,
    member_1: f32,
}

struct type_52 {
    member: array<vec4<u32>, 2>,
}

struct type_55 {
    member: array<i32>,
}

struct type_62 {
    member: type_42,
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
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_52;
@group(0) @binding(2) 
var<uniform> global_3: type_52;
@group(0) @binding(3) 
var<storage> global_4: type_13;
@group(0) @binding(4) 
var<storage> global_5: type_24;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_55;
@group(0) @binding(7) 
var<storage> global_8: type_37;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_32;
@group(0) @binding(9) 
var<storage, read_write> global_10: type_68;

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
    var phi_388_: type_44;
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
    var phi_952_: type_47;
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
    var phi_1078_: type_47;
    var phi_1081_: type_8;
    var phi_1082_: type_8;
    var phi_1104_: type_8;
    var phi_1125_: u32;
    var phi_1214_: array<array<f32, 3>, 3>;
    var phi_1685_: vec3<f32>;
    var phi_1686_: vec3<f32>;
    var phi_1717_: bool;
    var phi_1726_: vec3<f32>;
    var phi_1766_: type_30;
    var phi_1768_: type_30;
    var phi_1769_: bool;
    var phi_1773_: type_30;
    var phi_1774_: type_30;
    var phi_1775_: type_30;
    var phi_1776_: bool;
    var phi_1780_: type_30;
    var phi_1781_: bool;
    var phi_1785_: type_30;
    var phi_1786_: bool;
    var phi_1790_: type_30;
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
    var phi_2145_: type_47;
    var phi_2146_: type_47;
    var phi_2147_: type_47;
    var phi_1079_: type_47;
    var phi_3691_: bool;
    var phi_3833_: bool;
    var phi_3352_: type_47;
    var phi_3353_: type_62;
    var phi_3354_: bool;
    var phi_3355_: u32;
    var phi_3832_: bool;
    var phi_3356_: type_47;
    var phi_3357_: type_62;
    var phi_3358_: u32;
    var phi_3359_: bool;
    var phi_3360_: u32;
    var phi_3831_: bool;
    var phi_3361_: type_47;
    var phi_3362_: type_62;
    var phi_3363_: u32;
    var phi_3364_: bool;
    var phi_3365_: u32;
    var phi_3830_: bool;
    var phi_953_: type_47;
    var phi_956_: type_62;
    var phi_958_: u32;
    var phi_960_: bool;
    var phi_962_: u32;
    var phi_3366_: bool;
    var phi_3829_: bool;
    var local_10: type_47;
    var phi_3418_: type_30;
    var local_11: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e93 = global;
            let _e95 = arrayLength((&global_4.member));
            let _e97 = arrayLength((&global_5.member));
            let _e109 = arrayLength((&global_10.member));
            let _e113 = global_3.member[0u][0u];
            let _e117 = global_3.member[0u][1u];
            let _e121 = global_3.member[0u][2u];
            let _e125 = global_3.member[0u][3u];
            let _e129 = global_3.member[1u][0u];
            let _e133 = global_3.member[1u][1u];
            let _e137 = global_3.member[1u][2u];
            let _e141 = (_e93.x + (_e93.y * 2097152u));
            let _e153 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e125) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e113), bitcast<i32>(_e117), bitcast<i32>(_e121));
            local = array<i32, 3>(bitcast<i32>(_e129), bitcast<i32>(_e133), bitcast<i32>(_e137));
            let _e156 = (_e141 < arrayLength((&global_8.member)));
            if _e156 {
                if _e156 {
                } else {
                    break;
                }
                let _e160 = global_8.member[_e141].member_2;
                phi_320_ = _e160;
            } else {
                phi_320_ = 4294967295u;
            }
            let _e162 = phi_320_;
            let _e165 = global_1.member[0u];
            let _e169 = global_2.member[0u][0u];
            let _e173 = global_2.member[0u][1u];
            let _e177 = global_2.member[0u][2u];
            let _e181 = global_2.member[0u][3u];
            let _e185 = global_2.member[1u][0u];
            let _e189 = global_2.member[1u][1u];
            let _e193 = global_2.member[1u][2u];
            let _e197 = global_2.member[1u][3u];
            let _e198 = bitcast<f32>(_e169);
            let _e199 = bitcast<f32>(_e173);
            let _e200 = bitcast<f32>(_e177);
            let _e202 = bitcast<f32>(_e185);
            let _e203 = array<u32, 3>(_e189, _e193, _e197);
            let _e205 = bitcast<i32>(_e165);
            if (_e205 < -126i) {
                phi_364_ = -126i;
            } else {
                phi_364_ = select(_e205, 127i, (_e205 > 127i));
            }
            let _e210 = phi_364_;
            let _e215 = bitcast<f32>((bitcast<u32>((_e210 + 127i)) << bitcast<u32>(23i)));
            let _e221 = bitcast<f32>((bitcast<u32>(((_e205 - _e210) + 127i)) << bitcast<u32>(23i)));
            if (_e181 == 0u) {
                phi_388_ = type_44(array<f32, 3>(_e198, _e199, _e200), _e181, _e202, _e203);
            } else {
                phi_388_ = type_44(array<f32, 3>(((_e198 * _e215) * _e221), ((_e199 * _e215) * _e221), ((_e200 * _e215) * _e221)), _e181, ((_e202 * _e215) * _e221), _e203);
            }
            let _e234 = phi_388_;
            if _e156 {
                let _e235 = (_e141 < arrayLength((&global_9.member)));
                if _e235 {
                    if _e156 {
                    } else {
                        break;
                    }
                    let _e245 = global_8.member[_e141].member.member_2[0u];
                    let _e247 = (bitcast<u32>(_e245) & 2147483647u);
                    let _e253 = global_8.member[_e141].member.member_2[1u];
                    let _e255 = (bitcast<u32>(_e253) & 2147483647u);
                    let _e261 = global_8.member[_e141].member.member_2[2u];
                    let _e263 = (bitcast<u32>(_e261) & 2147483647u);
                    let _e269 = global_8.member[_e141].member.member[0u];
                    let _e271 = (bitcast<u32>(_e269) & 2147483647u);
                    let _e277 = global_8.member[_e141].member.member[1u];
                    let _e279 = (bitcast<u32>(_e277) & 2147483647u);
                    let _e285 = global_8.member[_e141].member.member[2u];
                    let _e287 = (bitcast<u32>(_e285) & 2147483647u);
                    let _e289 = select(_e255, _e247, (_e255 < _e247));
                    let _e291 = select(_e263, _e289, (_e263 < _e289));
                    let _e293 = select(_e271, _e291, (_e271 < _e291));
                    let _e295 = select(_e279, _e293, (_e279 < _e293));
                    let _e297 = select(_e287, _e295, (_e287 < _e295));
                    let _e302 = global_8.member[_e141].member.member_1;
                    let _e304 = (bitcast<u32>(_e302) & 2147483647u);
                    let _e312 = global_8.member[_e141].member.member_3;
                    let _e318 = (((select(_e304, _e297, (_e304 < _e297)) < 2139095040u) && ((bitcast<u32>(_e312) & 2147483647u) <= 2139095040u)) && (_e291 > 0u));
                    if _e318 {
                        let _e321 = (bitcast<u32>(bitcast<f32>(_e291)) & 2147483647u);
                        if (_e321 >= 8388608u) {
                            phi_494_ = (bitcast<i32>((_e321 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_494_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e321)), 32u, (_e321 == 0u))));
                        }
                        let _e335 = phi_494_;
                        phi_495_ = _e335;
                    } else {
                        phi_495_ = 0i;
                    }
                    let _e337 = phi_495_;
                    let _e338 = (_e247 == _e291);
                    if _e338 {
                        phi_505_ = true;
                    } else {
                        phi_505_ = (_e255 == _e291);
                    }
                    let _e341 = phi_505_;
                    let _e342 = select(1u, 0u, _e338);
                    if _e341 {
                        let _e343 = (_e342 + 1u);
                        phi_515_ = _e343;
                        phi_516_ = _e343;
                        phi_518_ = select(true, false, (_e343 == 2u));
                    } else {
                        phi_515_ = u32();
                        phi_516_ = 0u;
                        phi_518_ = true;
                    }
                    let _e347 = phi_515_;
                    let _e349 = phi_516_;
                    let _e351 = phi_518_;
                    if _e351 {
                        phi_523_ = (_e349 + 1u);
                    } else {
                        phi_523_ = 0u;
                    }
                    let _e355 = phi_523_;
                    let _e356 = select(_e347, _e349, _e351);
                    let _e357 = select(_e342, select(2u, _e342, _e341), _e351);
                    let _e358 = -(_e337);
                    if (_e358 < -126i) {
                        phi_555_ = -126i;
                    } else {
                        phi_555_ = select(_e358, 127i, (_e358 > 127i));
                    }
                    let _e363 = phi_555_;
                    let _e368 = bitcast<f32>((bitcast<u32>((_e363 + 127i)) << bitcast<u32>(23i)));
                    let _e374 = bitcast<f32>((bitcast<u32>(((_e358 - _e363) + 127i)) << bitcast<u32>(23i)));
                    let _e379 = global_8.member[_e141].member.member;
                    let _e380 = (_e356 == 0u);
                    if _e380 {
                        phi_573_ = _e379[0];
                    } else {
                        phi_573_ = _e379[1];
                    }
                    let _e384 = phi_573_;
                    let _e385 = (_e356 == 2u);
                    if _e385 {
                        phi_579_ = _e379[2];
                    } else {
                        phi_579_ = _e384;
                    }
                    let _e388 = phi_579_;
                    let _e389 = global_8.member[_e141].member.member_2;
                    if _e380 {
                        phi_590_ = _e389[0];
                    } else {
                        phi_590_ = _e389[1];
                    }
                    let _e393 = phi_590_;
                    if _e385 {
                        phi_596_ = _e389[2];
                    } else {
                        phi_596_ = _e393;
                    }
                    let _e396 = phi_596_;
                    let _e398 = ((_e396 * _e368) * _e374);
                    let _e402 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e402 {
                        let _e406 = (bitcast<f32>((bitcast<u32>(_e388) & 2147483647u)) * 0.00000011920929f);
                        phi_619_ = select(0.00000000000011368684f, _e406, (_e406 > 0.00000000000011368684f));
                    } else {
                        phi_619_ = 0f;
                    }
                    let _e410 = phi_619_;
                    let _e411 = (_e388 + _e410);
                    let _e412 = (_e388 - _e410);
                    let _e413 = select(_e398, 0f, _e402);
                    if _e402 {
                        phi_630_ = 38685626000000000000000000f;
                    } else {
                        phi_630_ = (1f / _e398);
                    }
                    let _e416 = phi_630_;
                    let _e417 = (_e355 == 0u);
                    if _e417 {
                        phi_639_ = _e379[0];
                    } else {
                        phi_639_ = _e379[1];
                    }
                    let _e421 = phi_639_;
                    let _e422 = (_e355 == 2u);
                    if _e422 {
                        phi_645_ = _e379[2];
                    } else {
                        phi_645_ = _e421;
                    }
                    let _e425 = phi_645_;
                    if _e417 {
                        phi_656_ = _e389[0];
                    } else {
                        phi_656_ = _e389[1];
                    }
                    let _e429 = phi_656_;
                    if _e422 {
                        phi_662_ = _e389[2];
                    } else {
                        phi_662_ = _e429;
                    }
                    let _e432 = phi_662_;
                    let _e434 = ((_e432 * _e368) * _e374);
                    let _e438 = (bitcast<f32>((bitcast<u32>(_e434) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e438 {
                        let _e442 = (bitcast<f32>((bitcast<u32>(_e425) & 2147483647u)) * 0.00000011920929f);
                        phi_685_ = select(0.00000000000011368684f, _e442, (_e442 > 0.00000000000011368684f));
                    } else {
                        phi_685_ = 0f;
                    }
                    let _e446 = phi_685_;
                    let _e447 = (_e425 + _e446);
                    let _e448 = (_e425 - _e446);
                    let _e449 = select(_e434, 0f, _e438);
                    if _e438 {
                        phi_696_ = 38685626000000000000000000f;
                    } else {
                        phi_696_ = (1f / _e434);
                    }
                    let _e452 = phi_696_;
                    let _e453 = (_e357 == 0u);
                    if _e453 {
                        phi_705_ = _e379[0];
                    } else {
                        phi_705_ = _e379[1];
                    }
                    let _e457 = phi_705_;
                    let _e458 = (_e357 == 2u);
                    if _e458 {
                        phi_711_ = _e379[2];
                    } else {
                        phi_711_ = _e457;
                    }
                    let _e461 = phi_711_;
                    if _e453 {
                        phi_722_ = _e389[0];
                    } else {
                        phi_722_ = _e389[1];
                    }
                    let _e465 = phi_722_;
                    if _e458 {
                        phi_728_ = _e389[2];
                    } else {
                        phi_728_ = _e465;
                    }
                    let _e468 = phi_728_;
                    let _e470 = ((_e468 * _e368) * _e374);
                    let _e474 = (bitcast<f32>((bitcast<u32>(_e470) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e474 {
                        let _e478 = (bitcast<f32>((bitcast<u32>(_e461) & 2147483647u)) * 0.00000011920929f);
                        phi_751_ = select(0.00000000000011368684f, _e478, (_e478 > 0.00000000000011368684f));
                    } else {
                        phi_751_ = 0f;
                    }
                    let _e482 = phi_751_;
                    let _e483 = (_e461 + _e482);
                    let _e484 = (_e461 - _e482);
                    let _e485 = select(_e470, 0f, _e474);
                    if _e474 {
                        phi_762_ = 38685626000000000000000000f;
                    } else {
                        phi_762_ = (1f / _e470);
                    }
                    let _e488 = phi_762_;
                    let _e491 = bitcast<f32>((bitcast<u32>(_e388) & 2147483647u));
                    let _e494 = bitcast<f32>((bitcast<u32>(_e425) & 2147483647u));
                    let _e496 = select(_e494, _e491, (_e491 > _e494));
                    let _e499 = bitcast<f32>((bitcast<u32>(_e461) & 2147483647u));
                    if (_e318 && (select(_e499, _e496, (_e496 > _e499)) <= 1099511600000f)) {
                        let _e504 = (_e337 / 3i);
                        let _e511 = bitcast<f32>((bitcast<u32>((_e504 + 127i)) << bitcast<u32>(23i)));
                        let _e518 = bitcast<f32>((bitcast<u32>(((_e337 - (2i * _e504)) + 127i)) << bitcast<u32>(23i)));
                        let _e519 = (((_e302 * _e511) * _e511) * _e518);
                        let _e521 = select(340282350000000000000000000000000000000f, _e519, (_e519 < 340282350000000000000000000000000000000f));
                        let _e526 = (((_e312 * _e511) * _e511) * _e518);
                        let _e528 = select(340282350000000000000000000000000000000f, _e526, (_e526 < 340282350000000000000000000000000000000f));
                        phi_862_ = select(-340282350000000000000000000000000000000f, _e528, (_e528 > -340282350000000000000000000000000000000f));
                        phi_863_ = select(-340282350000000000000000000000000000000f, _e521, (_e521 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_862_ = 0f;
                        phi_863_ = 1f;
                    }
                    let _e532 = phi_862_;
                    let _e534 = phi_863_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e538 = (_e356 % 3u);
                    let _e539 = (_e538 < 3u);
                    if _e539 {
                    } else {
                        break;
                    }
                    let _e541 = local_1[_e538];
                    let _e544 = (_e355 % 3u);
                    let _e545 = (_e544 < 3u);
                    if _e545 {
                    } else {
                        break;
                    }
                    let _e547 = local_1[_e544];
                    let _e550 = (_e357 % 3u);
                    let _e551 = (_e550 < 3u);
                    if _e551 {
                    } else {
                        break;
                    }
                    let _e553 = local_1[_e550];
                    if _e539 {
                    } else {
                        break;
                    }
                    let _e558 = local[_e538];
                    if _e545 {
                    } else {
                        break;
                    }
                    let _e562 = local[_e544];
                    if _e551 {
                    } else {
                        break;
                    }
                    let _e566 = local[_e550];
                    phi_3697_ = false;
                    phi_952_ = type_47(type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e532);
                    phi_955_ = type_62(type_42(vec4<f32>((f32(_e541) * _e153), (f32(_e547) * _e153), (f32(_e553) * _e153), 0f), vec4<f32>((f32(_e558) * _e153), (f32(_e562) * _e153), (f32(_e566) * _e153), 0f)), select(0u, 2147483648u, (_e95 == 0u)));
                    phi_957_ = ((3u * _e95) + 1u);
                    phi_959_ = (_e534 <= _e532);
                    phi_961_ = 0u;
                    loop {
                        let _e576 = phi_3697_;
                        let _e578 = phi_952_;
                        let _e580 = phi_955_;
                        let _e582 = phi_957_;
                        let _e584 = phi_959_;
                        let _e586 = phi_961_;
                        local_10 = _e578;
                        if _e584 {
                            phi_972_ = true;
                        } else {
                            phi_972_ = (_e586 > 0u);
                        }
                        let _e589 = phi_972_;
                        if _e589 {
                            let _e590 = (_e582 > 0u);
                            if _e590 {
                                if _e584 {
                                    phi_1058_ = _e580;
                                    phi_1059_ = _e584;
                                    phi_1060_ = _e586;
                                } else {
                                    let _e591 = (_e586 - 1u);
                                    let _e592 = (_e591 % 128u);
                                    let _e593 = (_e592 < 128u);
                                    if _e593 {
                                    } else {
                                        phi_3829_ = true;
                                        break;
                                    }
                                    let _e595 = local_7[_e592];
                                    if _e593 {
                                    } else {
                                        phi_3829_ = true;
                                        break;
                                    }
                                    let _e597 = local_6[_e592];
                                    if _e593 {
                                    } else {
                                        phi_3829_ = true;
                                        break;
                                    }
                                    let _e599 = local_5[_e592];
                                    if _e593 {
                                    } else {
                                        phi_3829_ = true;
                                        break;
                                    }
                                    let _e601 = local_4[_e592];
                                    if _e593 {
                                    } else {
                                        phi_3829_ = true;
                                        break;
                                    }
                                    let _e603 = local_3[_e592];
                                    if _e593 {
                                    } else {
                                        phi_3829_ = true;
                                        break;
                                    }
                                    let _e605 = local_2[_e592];
                                    if _e593 {
                                    } else {
                                        phi_3829_ = true;
                                        break;
                                    }
                                    let _e610 = local_8[_e592];
                                    if _e593 {
                                    } else {
                                        phi_3829_ = true;
                                        break;
                                    }
                                    let _e613 = local_9[_e592];
                                    phi_1058_ = type_62(type_42(vec4<f32>(_e595, _e597, _e599, 0f), vec4<f32>(_e601, _e603, _e605, 0f)), _e610);
                                    phi_1059_ = (_e613 <= _e578.member_1);
                                    phi_1060_ = _e591;
                                }
                                let _e617 = phi_1058_;
                                let _e619 = phi_1059_;
                                let _e621 = phi_1060_;
                                if _e619 {
                                    if ((_e617.member_1 & 2147483648u) != 0u) {
                                        phi_1078_ = _e578;
                                        phi_1081_ = type_8(0u, ((_e617.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1065 = phi_1078_;
                                            let _e1067 = phi_1081_;
                                            local_11 = _e1065;
                                            if (_e1067.member < _e1067.member_1) {
                                                phi_1082_ = type_8((_e1067.member + 1u), _e1067.member_1);
                                                phi_1104_ = type_8(1u, _e1067.member);
                                            } else {
                                                phi_1082_ = _e1067;
                                                phi_1104_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1080 = phi_1082_;
                                            let _e1082 = phi_1104_;
                                            let _e1086 = (bitcast<i32>(_e1082.member) != 0i);
                                            if _e1086 {
                                                let _e1087 = ((_e617.member_1 & 268435455u) + _e1082.member_1);
                                                let _e1088 = (_e1087 < _e97);
                                                if _e1088 {
                                                    if _e1088 {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1092 = global_5.member[_e1087].member_1;
                                                    phi_1125_ = _e1092;
                                                } else {
                                                    phi_1125_ = 4294967295u;
                                                }
                                                let _e1094 = phi_1125_;
                                                if (_e1087 >= _e97) {
                                                    phi_1214_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1088 {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    if (_e538 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1101 = global_5.member[_e1087].member[_e538];
                                                    if (_e544 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1107 = global_5.member[_e1087].member[_e544];
                                                    if (_e550 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1113 = global_5.member[_e1087].member[_e550];
                                                    let _e1115 = (3u + _e538);
                                                    if (_e1115 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1121 = global_5.member[_e1087].member[_e1115];
                                                    let _e1122 = (3u + _e544);
                                                    if (_e1122 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1128 = global_5.member[_e1087].member[_e1122];
                                                    let _e1129 = (3u + _e550);
                                                    if (_e1129 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1135 = global_5.member[_e1087].member[_e1129];
                                                    let _e1137 = (6u + _e538);
                                                    if (_e1137 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1143 = global_5.member[_e1087].member[_e1137];
                                                    let _e1144 = (6u + _e544);
                                                    if (_e1144 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1150 = global_5.member[_e1087].member[_e1144];
                                                    let _e1151 = (6u + _e550);
                                                    if (_e1151 < 9u) {
                                                    } else {
                                                        phi_3691_ = true;
                                                        break;
                                                    }
                                                    let _e1157 = global_5.member[_e1087].member[_e1151];
                                                    phi_1214_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1101, _e1107, _e1113), array<f32, 3>(_e1121, _e1128, _e1135), array<f32, 3>(_e1143, _e1150, _e1157));
                                                }
                                                let _e1161 = phi_1214_;
                                                let _e1169 = (_e1161[0][2] - _e461);
                                                let _e1172 = (((_e1161[0][0] - _e388) * _e485) - (_e1169 * _e413));
                                                let _e1175 = (((_e1161[0][1] - _e425) * _e485) - (_e1169 * _e449));
                                                let _e1182 = (_e1161[1][2] - _e461);
                                                let _e1185 = (((_e1161[1][0] - _e388) * _e485) - (_e1182 * _e413));
                                                let _e1188 = (((_e1161[1][1] - _e425) * _e485) - (_e1182 * _e449));
                                                let _e1195 = (_e1161[2][2] - _e461);
                                                let _e1198 = (((_e1161[2][0] - _e388) * _e485) - (_e1195 * _e413));
                                                let _e1201 = (((_e1161[2][1] - _e425) * _e485) - (_e1195 * _e449));
                                                let _e1202 = (_e1198 * _e1188);
                                                let _e1203 = (_e1201 * _e1185);
                                                let _e1204 = (_e1172 * _e1201);
                                                let _e1205 = (_e1175 * _e1198);
                                                let _e1206 = (_e1185 * _e1175);
                                                let _e1207 = (_e1188 * _e1172);
                                                let _e1212 = (((_e1202 >= _e1203) && (_e1204 >= _e1205)) && (_e1206 >= _e1207));
                                                if (_e1212 || (((_e1202 <= _e1203) && (_e1204 <= _e1205)) && (_e1206 <= _e1207))) {
                                                    let _e1219 = select(-1f, 1f, _e1212);
                                                    let _e1221 = ((_e1202 - _e1203) * _e1219);
                                                    let _e1223 = select(0f, _e1221, (_e1221 > 0f));
                                                    let _e1225 = ((_e1204 - _e1205) * _e1219);
                                                    let _e1227 = select(0f, _e1225, (_e1225 > 0f));
                                                    let _e1229 = ((_e1206 - _e1207) * _e1219);
                                                    let _e1231 = select(0f, _e1229, (_e1229 > 0f));
                                                    let _e1233 = ((_e1223 + _e1227) + _e1231);
                                                    if (_e1233 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1780_ = type_30();
                                                        phi_1781_ = true;
                                                    } else {
                                                        let _e1236 = select(_e1161[1][0], _e1161[0][0], (_e1161[0][0] < _e1161[1][0]));
                                                        let _e1240 = select(_e1161[1][0], _e1161[0][0], (_e1161[0][0] > _e1161[1][0]));
                                                        let _e1244 = select(_e1161[1][1], _e1161[0][1], (_e1161[0][1] < _e1161[1][1]));
                                                        let _e1248 = select(_e1161[1][1], _e1161[0][1], (_e1161[0][1] > _e1161[1][1]));
                                                        let _e1252 = select(_e1161[1][2], _e1161[0][2], (_e1161[0][2] < _e1161[1][2]));
                                                        let _e1256 = select(_e1161[1][2], _e1161[0][2], (_e1161[0][2] > _e1161[1][2]));
                                                        let _e1261 = ((select(_e1161[2][0], _e1236, (_e1236 < _e1161[2][0])) - _e411) * _e416);
                                                        let _e1262 = ((select(_e1161[2][0], _e1240, (_e1240 > _e1161[2][0])) - _e412) * _e416);
                                                        let _e1265 = ((select(_e1161[2][1], _e1244, (_e1244 < _e1161[2][1])) - _e447) * _e452);
                                                        let _e1266 = ((select(_e1161[2][1], _e1248, (_e1248 > _e1161[2][1])) - _e448) * _e452);
                                                        let _e1269 = ((select(_e1161[2][2], _e1252, (_e1252 < _e1161[2][2])) - _e483) * _e488);
                                                        let _e1270 = ((select(_e1161[2][2], _e1256, (_e1256 > _e1161[2][2])) - _e484) * _e488);
                                                        let _e1272 = select(_e1270, _e1269, (_e1269 < _e1270));
                                                        let _e1274 = select(_e1270, _e1269, (_e1269 > _e1270));
                                                        let _e1276 = select(_e1262, _e1261, (_e1261 < _e1262));
                                                        let _e1278 = select(_e1266, _e1265, (_e1265 < _e1266));
                                                        let _e1280 = select(_e1278, _e1276, (_e1276 > _e1278));
                                                        let _e1282 = select(_e1272, _e1280, (_e1280 > _e1272));
                                                        let _e1284 = select(_e1262, _e1261, (_e1261 > _e1262));
                                                        let _e1286 = select(_e1266, _e1265, (_e1265 > _e1266));
                                                        let _e1288 = select(_e1286, _e1284, (_e1284 < _e1286));
                                                        let _e1290 = select(_e1274, _e1288, (_e1288 < _e1274));
                                                        let _e1291 = -(_e1272);
                                                        let _e1297 = select(_e534, _e1282, (_e1282 > _e534));
                                                        if (_e1297 > (_e1290 + (select(_e1291, _e1274, (_e1274 > _e1291)) * 0.0000019073523f))) {
                                                            phi_1775_ = type_30();
                                                            phi_1776_ = true;
                                                        } else {
                                                            let _e1299 = (_e1297 > _e1065.member_1);
                                                            if _e1299 {
                                                                phi_1774_ = type_30();
                                                            } else {
                                                                let _e1303 = (_e1161[1][0] - _e1161[0][0]);
                                                                let _e1304 = (_e1161[1][1] - _e1161[0][1]);
                                                                let _e1305 = (_e1161[1][2] - _e1161[0][2]);
                                                                let _e1306 = vec3<f32>(_e1303, _e1304, _e1305);
                                                                let _e1307 = (_e1161[2][0] - _e1161[1][0]);
                                                                let _e1308 = (_e1161[2][1] - _e1161[1][1]);
                                                                let _e1309 = (_e1161[2][2] - _e1161[1][2]);
                                                                let _e1310 = vec3<f32>(_e1307, _e1308, _e1309);
                                                                let _e1311 = (_e1161[0][0] - _e1161[2][0]);
                                                                let _e1312 = (_e1161[0][1] - _e1161[2][1]);
                                                                let _e1313 = (_e1161[0][2] - _e1161[2][2]);
                                                                let _e1314 = vec3<f32>(_e1311, _e1312, _e1313);
                                                                let _e1317 = bitcast<f32>((bitcast<u32>(_e1303) & 2147483647u));
                                                                let _e1320 = bitcast<f32>((bitcast<u32>(_e1304) & 2147483647u));
                                                                let _e1322 = select(_e1320, _e1317, (_e1317 > _e1320));
                                                                let _e1325 = bitcast<f32>((bitcast<u32>(_e1305) & 2147483647u));
                                                                let _e1327 = select(_e1325, _e1322, (_e1322 > _e1325));
                                                                let _e1330 = bitcast<f32>((bitcast<u32>(_e1307) & 2147483647u));
                                                                let _e1333 = bitcast<f32>((bitcast<u32>(_e1308) & 2147483647u));
                                                                let _e1335 = select(_e1333, _e1330, (_e1330 > _e1333));
                                                                let _e1338 = bitcast<f32>((bitcast<u32>(_e1309) & 2147483647u));
                                                                let _e1340 = select(_e1338, _e1335, (_e1335 > _e1338));
                                                                let _e1343 = bitcast<f32>((bitcast<u32>(_e1311) & 2147483647u));
                                                                let _e1346 = bitcast<f32>((bitcast<u32>(_e1312) & 2147483647u));
                                                                let _e1348 = select(_e1346, _e1343, (_e1343 > _e1346));
                                                                let _e1351 = bitcast<f32>((bitcast<u32>(_e1313) & 2147483647u));
                                                                let _e1353 = select(_e1351, _e1348, (_e1348 > _e1351));
                                                                let _e1355 = select(_e1340, _e1327, (_e1327 > _e1340));
                                                                let _e1357 = select(_e1353, _e1355, (_e1355 > _e1353));
                                                                if (_e1327 == _e1357) {
                                                                    phi_1685_ = _e1310;
                                                                    phi_1686_ = _e1314;
                                                                } else {
                                                                    let _e1360 = vec3((_e1340 == _e1357));
                                                                    phi_1685_ = select(_e1306, _e1314, _e1360);
                                                                    phi_1686_ = select(_e1310, _e1306, _e1360);
                                                                }
                                                                let _e1364 = phi_1685_;
                                                                let _e1366 = phi_1686_;
                                                                let _e1373 = ((_e1364.y * _e1366.z) - (_e1366.y * _e1364.z));
                                                                let _e1378 = ((_e1364.z * _e1366.x) - (_e1366.z * _e1364.x));
                                                                let _e1381 = ((_e1364.x * _e1366.y) - (_e1366.x * _e1364.y));
                                                                if (_e1223 >= _e1227) {
                                                                    phi_1717_ = select(true, false, (_e1223 >= _e1231));
                                                                } else {
                                                                    phi_1717_ = true;
                                                                }
                                                                let _e1386 = phi_1717_;
                                                                if _e1386 {
                                                                    phi_1726_ = select(vec3<f32>(_e1161[2][0], _e1161[2][1], _e1161[2][2]), vec3<f32>(_e1161[1][0], _e1161[1][1], _e1161[1][2]), vec3((_e1227 >= _e1231)));
                                                                } else {
                                                                    phi_1726_ = vec3<f32>(_e1161[0][0], _e1161[0][1], _e1161[0][2]);
                                                                }
                                                                let _e1391 = phi_1726_;
                                                                let _e1408 = ((((_e1373 * (_e1391.x - _e388)) + (_e1378 * (_e1391.y - _e425))) + (_e1381 * (_e1391.z - _e461))) / (((_e1373 * _e413) + (_e1378 * _e449)) + (_e1381 * _e485)));
                                                                let _e1410 = select(_e1290, _e1408, (_e1408 < _e1290));
                                                                let _e1412 = select(_e1282, _e1410, (_e1410 > _e1282));
                                                                if (_e1412 >= _e534) {
                                                                    let _e1414 = (_e1412 <= _e1065.member_1);
                                                                    if _e1414 {
                                                                        let _e1415 = (1f / _e1233);
                                                                        phi_1766_ = type_30(_e1412, (_e1227 * _e1415), (_e1231 * _e1415), _e1094);
                                                                    } else {
                                                                        phi_1766_ = type_30();
                                                                    }
                                                                    let _e1420 = phi_1766_;
                                                                    phi_1768_ = _e1420;
                                                                    phi_1769_ = select(true, false, _e1414);
                                                                } else {
                                                                    phi_1768_ = type_30();
                                                                    phi_1769_ = true;
                                                                }
                                                                let _e1423 = phi_1768_;
                                                                let _e1425 = phi_1769_;
                                                                if _e1425 {
                                                                    phi_1773_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1773_ = _e1423;
                                                                }
                                                                let _e1427 = phi_1773_;
                                                                phi_1774_ = _e1427;
                                                            }
                                                            let _e1429 = phi_1774_;
                                                            phi_1775_ = _e1429;
                                                            phi_1776_ = _e1299;
                                                        }
                                                        let _e1431 = phi_1775_;
                                                        let _e1433 = phi_1776_;
                                                        phi_1780_ = _e1431;
                                                        phi_1781_ = _e1433;
                                                    }
                                                    let _e1435 = phi_1780_;
                                                    let _e1437 = phi_1781_;
                                                    phi_1785_ = _e1435;
                                                    phi_1786_ = _e1437;
                                                } else {
                                                    phi_1785_ = type_30();
                                                    phi_1786_ = true;
                                                }
                                                let _e1439 = phi_1785_;
                                                let _e1441 = phi_1786_;
                                                if _e1441 {
                                                    phi_1790_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1790_ = _e1439;
                                                }
                                                let _e1443 = phi_1790_;
                                                if (_e1443.member_3 != 4294967295u) {
                                                    if (_e1094 == _e162) {
                                                        phi_2119_ = false;
                                                    } else {
                                                        let _e1447 = (_e1094 < arrayLength((&global_6.member)));
                                                        if _e1447 {
                                                            if _e1447 {
                                                            } else {
                                                                phi_3691_ = true;
                                                                break;
                                                            }
                                                            let _e1449 = global_6.member[_e1094];
                                                            phi_1813_ = _e1449;
                                                        } else {
                                                            phi_1813_ = 4294967295u;
                                                        }
                                                        let _e1451 = phi_1813_;
                                                        let _e1452 = (_e1451 < arrayLength((&global_7.member)));
                                                        if _e1452 {
                                                            if _e1452 {
                                                            } else {
                                                                phi_3691_ = true;
                                                                break;
                                                            }
                                                            let _e1454 = global_7.member[_e1451];
                                                            phi_1827_ = _e1454;
                                                        } else {
                                                            phi_1827_ = 0i;
                                                        }
                                                        let _e1456 = phi_1827_;
                                                        let _e1457 = (_e1456 == 0i);
                                                        if _e1457 {
                                                            phi_2118_ = true;
                                                        } else {
                                                            if _e380 {
                                                                phi_1848_ = vec3<f32>(_e1161[0][0], _e1161[0][1], _e1161[0][2]);
                                                            } else {
                                                                if (_e356 == 1u) {
                                                                    phi_1847_ = vec3<f32>(_e1161[0][2], _e1161[0][0], _e1161[0][1]);
                                                                } else {
                                                                    phi_1847_ = vec3<f32>(_e1161[0][1], _e1161[0][2], _e1161[0][0]);
                                                                }
                                                                let _e1462 = phi_1847_;
                                                                phi_1848_ = _e1462;
                                                            }
                                                            let _e1465 = phi_1848_;
                                                            if _e380 {
                                                                phi_1865_ = vec3<f32>(_e1161[1][0], _e1161[1][1], _e1161[1][2]);
                                                            } else {
                                                                if (_e356 == 1u) {
                                                                    phi_1864_ = vec3<f32>(_e1161[1][2], _e1161[1][0], _e1161[1][1]);
                                                                } else {
                                                                    phi_1864_ = vec3<f32>(_e1161[1][1], _e1161[1][2], _e1161[1][0]);
                                                                }
                                                                let _e1470 = phi_1864_;
                                                                phi_1865_ = _e1470;
                                                            }
                                                            let _e1473 = phi_1865_;
                                                            if _e380 {
                                                                phi_1882_ = vec3<f32>(_e1161[2][0], _e1161[2][1], _e1161[2][2]);
                                                            } else {
                                                                if (_e356 == 1u) {
                                                                    phi_1881_ = vec3<f32>(_e1161[2][2], _e1161[2][0], _e1161[2][1]);
                                                                } else {
                                                                    phi_1881_ = vec3<f32>(_e1161[2][1], _e1161[2][2], _e1161[2][0]);
                                                                }
                                                                let _e1478 = phi_1881_;
                                                                phi_1882_ = _e1478;
                                                            }
                                                            let _e1481 = phi_1882_;
                                                            let _e1484 = (_e1473.x - _e1465.x);
                                                            let _e1487 = (_e1473.y - _e1465.y);
                                                            let _e1490 = (_e1473.z - _e1465.z);
                                                            let _e1492 = (_e1481.x - _e1465.x);
                                                            let _e1494 = (_e1481.y - _e1465.y);
                                                            let _e1496 = (_e1481.z - _e1465.z);
                                                            if (_e234.member_1 == 1u) {
                                                                phi_1918_ = (vec3<f32>(_e234.member[0], _e234.member[1], _e234.member[2]) - _e1465);
                                                            } else {
                                                                phi_1918_ = vec3<f32>(_e234.member[0], _e234.member[1], _e234.member[2]);
                                                            }
                                                            let _e1511 = phi_1918_;
                                                            let _e1517 = bitcast<f32>((bitcast<u32>((_e1484 * _e1494)) ^ _e234.member_3[0]));
                                                            let _e1521 = bitcast<f32>((bitcast<u32>((_e1487 * _e1492)) ^ _e234.member_3[0]));
                                                            let _e1525 = bitcast<f32>((bitcast<u32>((_e1487 * _e1496)) ^ _e234.member_3[0]));
                                                            let _e1529 = bitcast<f32>((bitcast<u32>((_e1490 * _e1494)) ^ _e234.member_3[0]));
                                                            let _e1533 = bitcast<f32>((bitcast<u32>((_e1490 * _e1492)) ^ _e234.member_3[0]));
                                                            let _e1537 = bitcast<f32>((bitcast<u32>((_e1484 * _e1496)) ^ _e234.member_3[0]));
                                                            let _e1538 = (_e1525 - _e1529);
                                                            let _e1539 = (_e1533 - _e1537);
                                                            let _e1540 = (_e1517 - _e1521);
                                                            let _e1564 = (bitcast<f32>((bitcast<u32>(_e1525) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1529) & 2147483647u)));
                                                            let _e1571 = (bitcast<f32>((bitcast<u32>(_e1533) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1537) & 2147483647u)));
                                                            let _e1578 = (bitcast<f32>((bitcast<u32>(_e1517) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1521) & 2147483647u)));
                                                            if (_e234.member_2 == 0f) {
                                                                phi_2100_ = 0f;
                                                            } else {
                                                                let _e1608 = bitcast<f32>((bitcast<u32>(_e1538) & 2147483647u));
                                                                let _e1611 = bitcast<f32>((bitcast<u32>(_e1539) & 2147483647u));
                                                                let _e1614 = bitcast<f32>((bitcast<u32>(_e1540) & 2147483647u));
                                                                let _e1616 = select(_e1614, _e1611, (_e1611 > _e1614));
                                                                let _e1620 = select(_e1614, _e1611, (_e1611 < _e1614));
                                                                let _e1624 = select(_e1611, _e1608, (_e1608 < _e1611));
                                                                let _e1626 = select(_e1611, _e1608, (_e1608 > _e1611));
                                                                let _e1628 = select(_e1614, _e1626, (_e1626 < _e1614));
                                                                phi_2100_ = bitcast<f32>((bitcast<u32>((_e234.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1616, _e1608, (_e1608 > _e1616)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1628, _e1624, (_e1624 > _e1628)))) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1620, _e1608, (_e1608 < _e1620)))) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1564 + _e1571) + _e1578))) ^ _e234.member_3[0]))) * 1.0000005f)) ^ _e234.member_3[0])))) ^ _e234.member_3[0]));
                                                            }
                                                            let _e1655 = phi_2100_;
                                                            phi_2118_ = (_e1457 || !(((((bitcast<f32>((bitcast<u32>((_e1511.x * _e1538)) ^ _e234.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1511.y * _e1539)) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1511.z * _e1540)) ^ _e234.member_3[0]))) * f32(-(_e1456))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1511.x) & 2147483647u)) * _e1564)) ^ _e234.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1511.y) & 2147483647u)) * _e1571)) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1511.z) & 2147483647u)) * _e1578)) ^ _e234.member_3[0]))))) ^ _e234.member_3[0])) + _e1655) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1669 = phi_2118_;
                                                        phi_2119_ = _e1669;
                                                    }
                                                    let _e1671 = phi_2119_;
                                                    if _e1671 {
                                                        if (_e1443.member < _e1065.member.member) {
                                                            phi_2139_ = true;
                                                        } else {
                                                            if (_e1443.member == _e1065.member.member) {
                                                                phi_2138_ = (_e1443.member_3 < _e1065.member.member_3);
                                                            } else {
                                                                phi_2138_ = false;
                                                            }
                                                            let _e1681 = phi_2138_;
                                                            phi_2139_ = _e1681;
                                                        }
                                                        let _e1683 = phi_2139_;
                                                        if _e1683 {
                                                            phi_2145_ = type_47(_e1443, _e1443.member);
                                                        } else {
                                                            phi_2145_ = _e1065;
                                                        }
                                                        let _e1686 = phi_2145_;
                                                        phi_2146_ = _e1686;
                                                    } else {
                                                        phi_2146_ = _e1065;
                                                    }
                                                    let _e1688 = phi_2146_;
                                                    phi_2147_ = _e1688;
                                                } else {
                                                    phi_2147_ = _e1065;
                                                }
                                                let _e1690 = phi_2147_;
                                                phi_1079_ = _e1690;
                                            } else {
                                                phi_1079_ = type_47();
                                            }
                                            let _e1692 = phi_1079_;
                                            continue;
                                            continuing {
                                                phi_1078_ = _e1692;
                                                phi_1081_ = _e1080;
                                                phi_3691_ = _e576;
                                                break if !(_e1086);
                                            }
                                        }
                                        let _e1695 = phi_3691_;
                                        phi_3829_ = _e1695;
                                        if _e1695 {
                                            break;
                                        }
                                        phi_3833_ = _e1695;
                                        let _e1910 = local_11;
                                        phi_3352_ = _e1910;
                                        phi_3353_ = _e617;
                                        phi_3354_ = false;
                                        phi_3355_ = _e621;
                                    } else {
                                        if (_e617.member_1 >= _e95) {
                                            phi_2908_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_62(type_42(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_62(type_42(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e617.member_1 < _e95) {
                                            } else {
                                                phi_3829_ = true;
                                                break;
                                            }
                                            let _e633 = ((1u + _e356) % 4u);
                                            if (_e633 < 4u) {
                                            } else {
                                                phi_3829_ = true;
                                                break;
                                            }
                                            let _e638 = global_4.member[_e617.member_1][_e633];
                                            let _e640 = (_e638 >> bitcast<u32>(11u));
                                            let _e642 = ((1u + _e355) % 4u);
                                            if (_e642 < 4u) {
                                            } else {
                                                phi_3829_ = true;
                                                break;
                                            }
                                            let _e647 = global_4.member[_e617.member_1][_e642];
                                            let _e649 = (_e647 >> bitcast<u32>(11u));
                                            let _e651 = ((1u + _e357) % 4u);
                                            if (_e651 < 4u) {
                                            } else {
                                                phi_3829_ = true;
                                                break;
                                            }
                                            let _e656 = global_4.member[_e617.member_1][_e651];
                                            let _e658 = (_e656 >> bitcast<u32>(11u));
                                            let _e681 = (bitcast<f32>((bitcast<u32>((_e617.member.member_1.x - _e617.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e682 = (bitcast<f32>((bitcast<u32>((_e617.member.member_1.y - _e617.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e683 = (bitcast<f32>((bitcast<u32>((_e617.member.member_1.z - _e617.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e685 = select(_e153, _e681, (_e681 > _e153));
                                            let _e687 = select(_e153, _e682, (_e682 > _e153));
                                            let _e689 = select(_e153, _e683, (_e683 > _e153));
                                            let _e714 = bitcast<u32>((f32(bitcast<i32>((_e638 & 1023u))) * _e685));
                                            let _e719 = (bitcast<i32>((_e638 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e722 = bitcast<f32>((_e714 & bitcast<u32>(_e719)));
                                            let _e723 = bitcast<u32>((f32(bitcast<i32>((_e647 & 1023u))) * _e687));
                                            let _e728 = (bitcast<i32>((_e647 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e731 = bitcast<f32>((_e723 & bitcast<u32>(_e728)));
                                            let _e732 = bitcast<u32>((f32(bitcast<i32>((_e656 & 1023u))) * _e689));
                                            let _e737 = (bitcast<i32>((_e656 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e740 = bitcast<f32>((_e732 & bitcast<u32>(_e737)));
                                            let _e744 = bitcast<f32>((_e714 & bitcast<u32>(~(_e719))));
                                            let _e748 = bitcast<f32>((_e723 & bitcast<u32>(~(_e728))));
                                            let _e752 = bitcast<f32>((_e732 & bitcast<u32>(~(_e737))));
                                            let _e753 = bitcast<u32>((f32(bitcast<i32>((_e640 & 1023u))) * _e685));
                                            let _e758 = (bitcast<i32>((_e640 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e761 = bitcast<f32>((_e753 & bitcast<u32>(_e758)));
                                            let _e762 = bitcast<u32>((f32(bitcast<i32>((_e649 & 1023u))) * _e687));
                                            let _e767 = (bitcast<i32>((_e649 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e770 = bitcast<f32>((_e762 & bitcast<u32>(_e767)));
                                            let _e771 = bitcast<u32>((f32(bitcast<i32>((_e658 & 1023u))) * _e689));
                                            let _e776 = (bitcast<i32>((_e658 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e779 = bitcast<f32>((_e771 & bitcast<u32>(_e776)));
                                            let _e783 = bitcast<f32>((_e753 & bitcast<u32>(~(_e758))));
                                            let _e787 = bitcast<f32>((_e762 & bitcast<u32>(~(_e767))));
                                            let _e791 = bitcast<f32>((_e771 & bitcast<u32>(~(_e776))));
                                            let _e821 = global_4.member[_e617.member_1][0u];
                                            let _e825 = global_4.member[_e617.member_1][1u];
                                            let _e829 = global_4.member[_e617.member_1][2u];
                                            let _e833 = global_4.member[_e617.member_1][3u];
                                            let _e845 = (((_e825 >> bitcast<u32>(22i)) | ((_e829 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e833 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e846 = (_e821 & 268435455u);
                                            let _e847 = (_e845 & 268435455u);
                                            let _e850 = ((_e821 >> bitcast<u32>(28u)) & 7u);
                                            let _e858 = ((_e821 >> bitcast<u32>(31i)) | (((_e845 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e859 = (_e850 != 0u);
                                            if (_e850 == 0u) {
                                                phi_2870_ = _e846;
                                            } else {
                                                if (_e850 == 7u) {
                                                    phi_2869_ = 2147483648u;
                                                } else {
                                                    phi_2869_ = ((2147483648u | (_e850 << bitcast<u32>(28u))) | (_e847 & 268435455u));
                                                }
                                                let _e868 = phi_2869_;
                                                phi_2870_ = _e868;
                                            }
                                            let _e870 = phi_2870_;
                                            if _e859 {
                                                let _e871 = (_e850 != 7u);
                                                if _e871 {
                                                    phi_2880_ = (_e847 + _e850);
                                                } else {
                                                    phi_2880_ = u32();
                                                }
                                                let _e874 = phi_2880_;
                                                phi_2882_ = _e874;
                                                phi_2883_ = select(true, false, _e871);
                                            } else {
                                                phi_2882_ = u32();
                                                phi_2883_ = true;
                                            }
                                            let _e877 = phi_2882_;
                                            let _e879 = phi_2883_;
                                            if (_e858 == 0u) {
                                                phi_2904_ = (_e846 + select(0u, 1u, !(_e859)));
                                            } else {
                                                if (_e858 == 7u) {
                                                    phi_2903_ = 2147483648u;
                                                } else {
                                                    phi_2903_ = ((2147483648u | (_e858 << bitcast<u32>(28u))) | (select(_e877, _e847, _e879) & 268435455u));
                                                }
                                                let _e892 = phi_2903_;
                                                phi_2904_ = _e892;
                                            }
                                            let _e894 = phi_2904_;
                                            phi_2908_ = type_63(array<vec4<f32>, 3>(vec4<f32>((_e617.member.member.x + _e722), (_e617.member.member.x + _e744), (_e617.member.member_1.x - _e761), (_e617.member.member_1.x - _e783)), vec4<f32>((_e617.member.member.y + _e731), (_e617.member.member.y + _e748), (_e617.member.member_1.y - _e770), (_e617.member.member_1.y - _e787)), vec4<f32>((_e617.member.member.z + _e740), (_e617.member.member.z + _e752), (_e617.member.member_1.z - _e779), (_e617.member.member_1.z - _e791))), type_62(type_42((_e617.member.member + vec4<f32>(_e722, _e731, _e740, 0f)), (_e617.member.member_1 - vec4<f32>(_e761, _e770, _e779, 0f))), _e870), type_62(type_42((_e617.member.member + vec4<f32>(_e744, _e748, _e752, 0f)), (_e617.member.member_1 - vec4<f32>(_e783, _e787, _e791, 0f))), _e894));
                                        }
                                        let _e899 = phi_2908_;
                                        let _e911 = ((_e899.member[0].x - _e411) * _e416);
                                        let _e912 = ((_e899.member[0].y - _e411) * _e416);
                                        let _e913 = ((_e899.member[0].z - _e412) * _e416);
                                        let _e914 = ((_e899.member[0].w - _e412) * _e416);
                                        let _e924 = ((_e899.member[1].x - _e447) * _e452);
                                        let _e925 = ((_e899.member[1].y - _e447) * _e452);
                                        let _e926 = ((_e899.member[1].z - _e448) * _e452);
                                        let _e927 = ((_e899.member[1].w - _e448) * _e452);
                                        let _e937 = ((_e899.member[2].x - _e483) * _e488);
                                        let _e938 = ((_e899.member[2].y - _e483) * _e488);
                                        let _e939 = ((_e899.member[2].z - _e484) * _e488);
                                        let _e940 = ((_e899.member[2].w - _e484) * _e488);
                                        let _e942 = select(_e939, _e937, (_e937 < _e939));
                                        let _e944 = select(_e940, _e938, (_e938 < _e940));
                                        let _e946 = select(_e939, _e937, (_e937 > _e939));
                                        let _e948 = select(_e940, _e938, (_e938 > _e940));
                                        let _e950 = select(_e913, _e911, (_e911 < _e913));
                                        let _e952 = select(_e914, _e912, (_e912 < _e914));
                                        let _e954 = select(_e926, _e924, (_e924 < _e926));
                                        let _e956 = select(_e927, _e925, (_e925 < _e927));
                                        let _e958 = select(_e954, _e950, (_e950 > _e954));
                                        let _e960 = select(_e956, _e952, (_e952 > _e956));
                                        let _e962 = select(_e942, _e958, (_e958 > _e942));
                                        let _e964 = select(_e944, _e960, (_e960 > _e944));
                                        let _e966 = select(_e913, _e911, (_e911 > _e913));
                                        let _e968 = select(_e914, _e912, (_e912 > _e914));
                                        let _e970 = select(_e926, _e924, (_e924 > _e926));
                                        let _e972 = select(_e927, _e925, (_e925 > _e927));
                                        let _e974 = select(_e970, _e966, (_e966 < _e970));
                                        let _e976 = select(_e972, _e968, (_e968 < _e972));
                                        let _e981 = -(_e942);
                                        let _e982 = -(_e944);
                                        let _e989 = (select(_e946, _e974, (_e974 < _e946)) + (select(_e981, _e946, (_e946 > _e981)) * 0.0000019073523f));
                                        let _e990 = (select(_e948, _e976, (_e976 < _e948)) + (select(_e982, _e948, (_e948 > _e982)) * 0.0000019073523f));
                                        let _e992 = select(_e534, _e962, (_e962 > _e534));
                                        let _e994 = select(_e534, _e964, (_e964 > _e534));
                                        let _e999 = (_e992 <= select(_e578.member_1, _e989, (_e989 < _e578.member_1)));
                                        let _e1000 = (_e994 <= select(_e578.member_1, _e990, (_e990 < _e578.member_1)));
                                        let _e1001 = (_e992 <= _e994);
                                        if _e999 {
                                            if _e1000 {
                                                if _e1001 {
                                                    phi_3252_ = _e899.member_2;
                                                } else {
                                                    phi_3252_ = _e899.member_1;
                                                }
                                                let _e1005 = phi_3252_;
                                                let _e1027 = (_e621 % 128u);
                                                let _e1028 = (_e1027 < 128u);
                                                if _e1028 {
                                                } else {
                                                    phi_3829_ = true;
                                                    break;
                                                }
                                                local_8[_e1027] = _e1005.member_1;
                                                if _e1028 {
                                                } else {
                                                    phi_3829_ = true;
                                                    break;
                                                }
                                                local_7[_e1027] = _e1005.member.member.x;
                                                if _e1028 {
                                                } else {
                                                    phi_3829_ = true;
                                                    break;
                                                }
                                                local_6[_e1027] = _e1005.member.member.y;
                                                if _e1028 {
                                                } else {
                                                    phi_3829_ = true;
                                                    break;
                                                }
                                                local_5[_e1027] = _e1005.member.member.z;
                                                if _e1028 {
                                                } else {
                                                    phi_3829_ = true;
                                                    break;
                                                }
                                                local_4[_e1027] = _e1005.member.member_1.x;
                                                if _e1028 {
                                                } else {
                                                    phi_3829_ = true;
                                                    break;
                                                }
                                                local_3[_e1027] = _e1005.member.member_1.y;
                                                if _e1028 {
                                                } else {
                                                    phi_3829_ = true;
                                                    break;
                                                }
                                                local_2[_e1027] = _e1005.member.member_1.z;
                                                if _e1028 {
                                                } else {
                                                    phi_3829_ = true;
                                                    break;
                                                }
                                                local_9[_e1027] = select(_e994, _e992, (_e992 > _e994));
                                                if _e1001 {
                                                    phi_3329_ = _e899.member_1;
                                                } else {
                                                    phi_3329_ = _e899.member_2;
                                                }
                                                let _e1041 = phi_3329_;
                                                phi_3330_ = _e1041;
                                                phi_3331_ = (_e621 + 1u);
                                            } else {
                                                phi_3330_ = type_62();
                                                phi_3331_ = u32();
                                            }
                                            let _e1043 = phi_3330_;
                                            let _e1045 = phi_3331_;
                                            phi_3333_ = _e1043;
                                            phi_3334_ = _e1045;
                                            phi_3335_ = select(true, false, _e1000);
                                        } else {
                                            phi_3333_ = type_62();
                                            phi_3334_ = u32();
                                            phi_3335_ = true;
                                        }
                                        let _e1048 = phi_3333_;
                                        let _e1050 = phi_3334_;
                                        let _e1052 = phi_3335_;
                                        if _e1052 {
                                            if _e999 {
                                                phi_3344_ = _e899.member_1;
                                            } else {
                                                phi_3344_ = _e899.member_2;
                                            }
                                            let _e1056 = phi_3344_;
                                            phi_3349_ = _e1056;
                                            phi_3350_ = select(_e1000, true, _e999);
                                        } else {
                                            phi_3349_ = _e1048;
                                            phi_3350_ = _e619;
                                        }
                                        let _e1059 = phi_3349_;
                                        let _e1061 = phi_3350_;
                                        phi_3833_ = _e576;
                                        phi_3352_ = _e578;
                                        phi_3353_ = _e1059;
                                        phi_3354_ = _e1061;
                                        phi_3355_ = select(_e1050, _e621, _e1052);
                                    }
                                    let _e1697 = phi_3833_;
                                    let _e1699 = phi_3352_;
                                    let _e1701 = phi_3353_;
                                    let _e1703 = phi_3354_;
                                    let _e1705 = phi_3355_;
                                    phi_3832_ = _e1697;
                                    phi_3356_ = _e1699;
                                    phi_3357_ = _e1701;
                                    phi_3358_ = (_e582 - 1u);
                                    phi_3359_ = _e1703;
                                    phi_3360_ = _e1705;
                                } else {
                                    phi_3832_ = _e576;
                                    phi_3356_ = _e578;
                                    phi_3357_ = _e617;
                                    phi_3358_ = _e582;
                                    phi_3359_ = _e619;
                                    phi_3360_ = _e621;
                                }
                                let _e1707 = phi_3832_;
                                let _e1709 = phi_3356_;
                                let _e1711 = phi_3357_;
                                let _e1713 = phi_3358_;
                                let _e1715 = phi_3359_;
                                let _e1717 = phi_3360_;
                                phi_3831_ = _e1707;
                                phi_3361_ = _e1709;
                                phi_3362_ = _e1711;
                                phi_3363_ = _e1713;
                                phi_3364_ = _e1715;
                                phi_3365_ = _e1717;
                            } else {
                                phi_3831_ = _e576;
                                phi_3361_ = type_47();
                                phi_3362_ = type_62();
                                phi_3363_ = u32();
                                phi_3364_ = bool();
                                phi_3365_ = u32();
                            }
                            let _e1719 = phi_3831_;
                            let _e1721 = phi_3361_;
                            let _e1723 = phi_3362_;
                            let _e1725 = phi_3363_;
                            let _e1727 = phi_3364_;
                            let _e1729 = phi_3365_;
                            phi_3830_ = _e1719;
                            phi_953_ = _e1721;
                            phi_956_ = _e1723;
                            phi_958_ = _e1725;
                            phi_960_ = _e1727;
                            phi_962_ = _e1729;
                            phi_3366_ = _e590;
                        } else {
                            phi_3830_ = _e576;
                            phi_953_ = type_47();
                            phi_956_ = type_62();
                            phi_958_ = u32();
                            phi_960_ = bool();
                            phi_962_ = u32();
                            phi_3366_ = false;
                        }
                        let _e1731 = phi_3830_;
                        let _e1733 = phi_953_;
                        let _e1735 = phi_956_;
                        let _e1737 = phi_958_;
                        let _e1739 = phi_960_;
                        let _e1741 = phi_962_;
                        let _e1743 = phi_3366_;
                        continue;
                        continuing {
                            phi_3697_ = _e1731;
                            phi_952_ = _e1733;
                            phi_955_ = _e1735;
                            phi_957_ = _e1737;
                            phi_959_ = _e1739;
                            phi_961_ = _e1741;
                            phi_3829_ = _e1731;
                            break if !(_e1743);
                        }
                    }
                    let _e1746 = phi_3829_;
                    if _e1746 {
                        break;
                    }
                    let _e1748 = local_10;
                    if (_e1748.member.member_3 != 4294967295u) {
                        let _e1753 = (_e358 / 3i);
                        let _e1760 = bitcast<f32>((bitcast<u32>((_e1753 + 127i)) << bitcast<u32>(23i)));
                        let _e1768 = (((_e1748.member.member * _e1760) * _e1760) * bitcast<f32>((bitcast<u32>(((_e358 - (2i * _e1753)) + 127i)) << bitcast<u32>(23i))));
                        let _e1770 = select(340282350000000000000000000000000000000f, _e1768, (_e1768 < 340282350000000000000000000000000000000f));
                        phi_3418_ = type_30(select(-340282350000000000000000000000000000000f, _e1770, (_e1770 > -340282350000000000000000000000000000000f)), _e1748.member.member_1, _e1748.member.member_2, _e1748.member.member_3);
                    } else {
                        phi_3418_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1777 = phi_3418_;
                    if _e235 {
                    } else {
                        break;
                    }
                    global_9.member[_e141] = _e1777;
                    if _e156 {
                    } else {
                        break;
                    }
                    let _e1781 = select(0u, 1u, (_e302 <= _e312));
                    if (_e1781 > 0u) {
                        let _e1783 = (1u < _e109);
                        if _e1783 {
                            if (0u < _e109) {
                            } else {
                                break;
                            }
                            let _e1787 = atomicAdd((&global_10.member[0u]), _e1781);
                            if ((_e1787 + _e1781) < _e1787) {
                                if _e1783 {
                                } else {
                                    break;
                                }
                                let _e1792 = atomicAdd((&global_10.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1795 = select(0u, 1u, (_e1777.member_3 != 4294967295u));
                    if (_e1795 > 0u) {
                        let _e1797 = (3u < _e109);
                        if _e1797 {
                            if (2u < _e109) {
                            } else {
                                break;
                            }
                            let _e1801 = atomicAdd((&global_10.member[2u]), _e1795);
                            if ((_e1801 + _e1795) < _e1801) {
                                if _e1797 {
                                } else {
                                    break;
                                }
                                let _e1806 = atomicAdd((&global_10.member[3u]), 1u);
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
fn trace_paths_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
