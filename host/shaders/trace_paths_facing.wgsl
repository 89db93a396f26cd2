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

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_32 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_33 {
    member: type_32,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_35 {
    member: array<type_33>,
}

struct type_40 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_46 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_49 {
    member: type_28,
    member_1: f32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_56 {
    member: array<vec4<u32>, 2>,
}

struct type_59 {
    member: array<i32>,
}

struct type_66 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_20;
@group(0) @binding(1) 
var<uniform> global_3: type_56;
@group(0) @binding(2) 
var<storage> global_4: type_42;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage> global_6: type_59;
@group(0) @binding(6) 
var<storage> global_7: type_35;
@group(0) @binding(7) 
var<storage, read_write> global_8: type_30;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_66;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_223_: u32;
    var phi_267_: i32;
    var phi_291_: type_46;
    var phi_397_: i32;
    var phi_398_: i32;
    var phi_408_: bool;
    var phi_418_: u32;
    var phi_419_: u32;
    var phi_421_: bool;
    var phi_426_: u32;
    var phi_458_: i32;
    var phi_476_: f32;
    var phi_482_: f32;
    var phi_493_: f32;
    var phi_499_: f32;
    var phi_522_: f32;
    var phi_533_: f32;
    var phi_542_: f32;
    var phi_548_: f32;
    var phi_559_: f32;
    var phi_565_: f32;
    var phi_588_: f32;
    var phi_599_: f32;
    var phi_608_: f32;
    var phi_614_: f32;
    var phi_625_: f32;
    var phi_631_: f32;
    var phi_654_: f32;
    var phi_665_: f32;
    var phi_765_: f32;
    var phi_766_: f32;
    var phi_2802_: bool;
    var phi_777_: type_49;
    var phi_780_: u32;
    var phi_782_: u32;
    var phi_784_: bool;
    var phi_786_: u32;
    var phi_797_: bool;
    var phi_829_: u32;
    var phi_830_: bool;
    var phi_831_: u32;
    var phi_2239_: type_54;
    var phi_2583_: u32;
    var phi_2611_: u32;
    var phi_2612_: u32;
    var phi_2613_: u32;
    var phi_2615_: u32;
    var phi_2616_: u32;
    var phi_2617_: bool;
    var phi_2626_: u32;
    var phi_2631_: u32;
    var phi_2632_: bool;
    var phi_846_: type_49;
    var phi_849_: type_8;
    var phi_850_: type_8;
    var phi_872_: type_8;
    var phi_893_: u32;
    var phi_982_: array<array<f32, 3>, 3>;
    var phi_1099_: bool;
    var phi_1128_: bool;
    var phi_1529_: f32;
    var phi_1530_: f32;
    var phi_1531_: f32;
    var phi_1532_: f32;
    var phi_1533_: vec3<f32>;
    var phi_1534_: vec3<f32>;
    var phi_1535_: vec3<f32>;
    var phi_1536_: vec3<f32>;
    var phi_1567_: bool;
    var phi_1576_: vec3<f32>;
    var phi_1741_: f32;
    var phi_1743_: f32;
    var phi_1744_: bool;
    var phi_1764_: f32;
    var phi_1765_: f32;
    var phi_1788_: type_28;
    var phi_1790_: type_28;
    var phi_1791_: bool;
    var phi_1795_: type_28;
    var phi_1796_: type_28;
    var phi_1797_: type_28;
    var phi_1798_: bool;
    var phi_1802_: type_28;
    var phi_1803_: bool;
    var phi_1804_: type_28;
    var phi_1805_: bool;
    var phi_1806_: bool;
    var phi_1807_: type_28;
    var phi_1808_: bool;
    var phi_1809_: bool;
    var phi_1817_: type_28;
    var phi_1818_: bool;
    var phi_1822_: type_28;
    var phi_1845_: u32;
    var phi_1859_: i32;
    var phi_1879_: vec3<f32>;
    var phi_1880_: vec3<f32>;
    var phi_1896_: vec3<f32>;
    var phi_1897_: vec3<f32>;
    var phi_1913_: vec3<f32>;
    var phi_1914_: vec3<f32>;
    var phi_1950_: vec3<f32>;
    var phi_2132_: f32;
    var phi_2150_: bool;
    var phi_2151_: bool;
    var phi_2170_: bool;
    var phi_2171_: bool;
    var phi_2177_: type_49;
    var phi_2178_: type_49;
    var phi_2179_: type_49;
    var phi_847_: type_49;
    var phi_2796_: bool;
    var phi_2966_: bool;
    var phi_2634_: type_49;
    var phi_2635_: u32;
    var phi_2636_: bool;
    var phi_2637_: u32;
    var phi_2965_: bool;
    var phi_2638_: type_49;
    var phi_2639_: u32;
    var phi_2640_: u32;
    var phi_2641_: bool;
    var phi_2642_: u32;
    var phi_2964_: bool;
    var phi_2643_: type_49;
    var phi_2644_: u32;
    var phi_2645_: u32;
    var phi_2646_: bool;
    var phi_2647_: u32;
    var phi_2963_: bool;
    var phi_778_: type_49;
    var phi_781_: u32;
    var phi_783_: u32;
    var phi_785_: bool;
    var phi_787_: u32;
    var phi_2648_: bool;
    var phi_2962_: bool;
    var local_2: type_49;
    var phi_2700_: type_28;
    var local_3: type_49;

    switch bitcast<i32>(0u) {
        default: {
            let _e76 = global;
            let _e78 = arrayLength((&global_4.member));
            let _e80 = arrayLength((&global_2.member));
            let _e92 = arrayLength((&global_9.member));
            let _e96 = (_e76.x + (_e76.y * 2097152u));
            let _e97 = (_e96 < arrayLength((&global_7.member)));
            if _e97 {
                if _e97 {
                } else {
                    break;
                }
                let _e101 = global_7.member[_e96].member_2;
                phi_223_ = _e101;
            } else {
                phi_223_ = 4294967295u;
            }
            let _e103 = phi_223_;
            let _e106 = global_1.member[0u];
            let _e110 = global_3.member[0u][0u];
            let _e114 = global_3.member[0u][1u];
            let _e118 = global_3.member[0u][2u];
            let _e122 = global_3.member[0u][3u];
            let _e126 = global_3.member[1u][0u];
            let _e130 = global_3.member[1u][1u];
            let _e134 = global_3.member[1u][2u];
            let _e138 = global_3.member[1u][3u];
            let _e139 = bitcast<f32>(_e110);
            let _e140 = bitcast<f32>(_e114);
            let _e141 = bitcast<f32>(_e118);
            let _e143 = bitcast<f32>(_e126);
            let _e144 = array<u32, 3>(_e130, _e134, _e138);
            let _e146 = bitcast<i32>(_e106);
            if (_e146 < -126i) {
                phi_267_ = -126i;
            } else {
                phi_267_ = select(_e146, 127i, (_e146 > 127i));
            }
            let _e151 = phi_267_;
            let _e156 = bitcast<f32>((bitcast<u32>((_e151 + 127i)) << bitcast<u32>(23i)));
            let _e162 = bitcast<f32>((bitcast<u32>(((_e146 - _e151) + 127i)) << bitcast<u32>(23i)));
            if (_e122 == 0u) {
                phi_291_ = type_46(array<f32, 3>(_e139, _e140, _e141), _e122, _e143, _e144);
            } else {
                phi_291_ = type_46(array<f32, 3>(((_e139 * _e156) * _e162), ((_e140 * _e156) * _e162), ((_e141 * _e156) * _e162)), _e122, ((_e143 * _e156) * _e162), _e144);
            }
            let _e175 = phi_291_;
            if _e97 {
                let _e176 = (_e96 < arrayLength((&global_8.member)));
                if _e176 {
                    if _e97 {
                    } else {
                        break;
                    }
                    let _e186 = global_7.member[_e96].member.member_2[0u];
                    let _e188 = (bitcast<u32>(_e186) & 2147483647u);
                    let _e194 = global_7.member[_e96].member.member_2[1u];
                    let _e196 = (bitcast<u32>(_e194) & 2147483647u);
                    let _e202 = global_7.member[_e96].member.member_2[2u];
                    let _e204 = (bitcast<u32>(_e202) & 2147483647u);
                    let _e210 = global_7.member[_e96].member.member[0u];
                    let _e212 = (bitcast<u32>(_e210) & 2147483647u);
                    let _e218 = global_7.member[_e96].member.member[1u];
                    let _e220 = (bitcast<u32>(_e218) & 2147483647u);
                    let _e226 = global_7.member[_e96].member.member[2u];
                    let _e228 = (bitcast<u32>(_e226) & 2147483647u);
                    let _e230 = select(_e196, _e188, (_e196 < _e188));
                    let _e232 = select(_e204, _e230, (_e204 < _e230));
                    let _e234 = select(_e212, _e232, (_e212 < _e232));
                    let _e236 = select(_e220, _e234, (_e220 < _e234));
                    let _e238 = select(_e228, _e236, (_e228 < _e236));
                    let _e243 = global_7.member[_e96].member.member_1;
                    let _e245 = (bitcast<u32>(_e243) & 2147483647u);
                    let _e253 = global_7.member[_e96].member.member_3;
                    let _e259 = (((select(_e245, _e238, (_e245 < _e238)) < 2139095040u) && ((bitcast<u32>(_e253) & 2147483647u) <= 2139095040u)) && (_e232 > 0u));
                    if _e259 {
                        let _e262 = (bitcast<u32>(bitcast<f32>(_e232)) & 2147483647u);
                        if (_e262 >= 8388608u) {
                            phi_397_ = (bitcast<i32>((_e262 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_397_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e262)), 32u, (_e262 == 0u))));
                        }
                        let _e276 = phi_397_;
                        phi_398_ = _e276;
                    } else {
                        phi_398_ = 0i;
                    }
                    let _e278 = phi_398_;
                    let _e279 = (_e188 == _e232);
                    if _e279 {
                        phi_408_ = true;
                    } else {
                        phi_408_ = (_e196 == _e232);
                    }
                    let _e282 = phi_408_;
                    let _e283 = select(1u, 0u, _e279);
                    if _e282 {
                        let _e284 = (_e283 + 1u);
                        phi_418_ = _e284;
                        phi_419_ = _e284;
                        phi_421_ = select(true, false, (_e284 == 2u));
                    } else {
                        phi_418_ = u32();
                        phi_419_ = 0u;
                        phi_421_ = true;
                    }
                    let _e288 = phi_418_;
                    let _e290 = phi_419_;
                    let _e292 = phi_421_;
                    if _e292 {
                        phi_426_ = (_e290 + 1u);
                    } else {
                        phi_426_ = 0u;
                    }
                    let _e296 = phi_426_;
                    let _e297 = select(_e288, _e290, _e292);
                    let _e298 = select(_e283, select(2u, _e283, _e282), _e292);
                    let _e299 = -(_e278);
                    if (_e299 < -126i) {
                        phi_458_ = -126i;
                    } else {
                        phi_458_ = select(_e299, 127i, (_e299 > 127i));
                    }
                    let _e304 = phi_458_;
                    let _e309 = bitcast<f32>((bitcast<u32>((_e304 + 127i)) << bitcast<u32>(23i)));
                    let _e315 = bitcast<f32>((bitcast<u32>(((_e299 - _e304) + 127i)) << bitcast<u32>(23i)));
                    let _e320 = global_7.member[_e96].member.member;
                    let _e321 = (_e297 == 0u);
                    if _e321 {
                        phi_476_ = _e320[0];
                    } else {
                        phi_476_ = _e320[1];
                    }
                    let _e325 = phi_476_;
                    let _e326 = (_e297 == 2u);
                    if _e326 {
                        phi_482_ = _e320[2];
                    } else {
                        phi_482_ = _e325;
                    }
                    let _e329 = phi_482_;
                    let _e330 = global_7.member[_e96].member.member_2;
                    if _e321 {
                        phi_493_ = _e330[0];
                    } else {
                        phi_493_ = _e330[1];
                    }
                    let _e334 = phi_493_;
                    if _e326 {
                        phi_499_ = _e330[2];
                    } else {
                        phi_499_ = _e334;
                    }
                    let _e337 = phi_499_;
                    let _e339 = ((_e337 * _e309) * _e315);
                    let _e343 = (bitcast<f32>((bitcast<u32>(_e339) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e343 {
                        let _e347 = (bitcast<f32>((bitcast<u32>(_e329) & 2147483647u)) * 0.00000011920929f);
                        phi_522_ = select(0.00000000000011368684f, _e347, (_e347 > 0.00000000000011368684f));
                    } else {
                        phi_522_ = 0f;
                    }
                    let _e351 = phi_522_;
                    let _e352 = (_e329 + _e351);
                    let _e353 = (_e329 - _e351);
                    let _e354 = select(_e339, 0f, _e343);
                    if _e343 {
                        phi_533_ = 38685626000000000000000000f;
                    } else {
                        phi_533_ = (1f / _e339);
                    }
                    let _e357 = phi_533_;
                    let _e358 = (_e296 == 0u);
                    if _e358 {
                        phi_542_ = _e320[0];
                    } else {
                        phi_542_ = _e320[1];
                    }
                    let _e362 = phi_542_;
                    let _e363 = (_e296 == 2u);
                    if _e363 {
                        phi_548_ = _e320[2];
                    } else {
                        phi_548_ = _e362;
                    }
                    let _e366 = phi_548_;
                    if _e358 {
                        phi_559_ = _e330[0];
                    } else {
                        phi_559_ = _e330[1];
                    }
                    let _e370 = phi_559_;
                    if _e363 {
                        phi_565_ = _e330[2];
                    } else {
                        phi_565_ = _e370;
                    }
                    let _e373 = phi_565_;
                    let _e375 = ((_e373 * _e309) * _e315);
                    let _e379 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e379 {
                        let _e383 = (bitcast<f32>((bitcast<u32>(_e366) & 2147483647u)) * 0.00000011920929f);
                        phi_588_ = select(0.00000000000011368684f, _e383, (_e383 > 0.00000000000011368684f));
                    } else {
                        phi_588_ = 0f;
                    }
                    let _e387 = phi_588_;
                    let _e388 = (_e366 + _e387);
                    let _e389 = (_e366 - _e387);
                    let _e390 = select(_e375, 0f, _e379);
                    if _e379 {
                        phi_599_ = 38685626000000000000000000f;
                    } else {
                        phi_599_ = (1f / _e375);
                    }
                    let _e393 = phi_599_;
                    let _e394 = (_e298 == 0u);
                    if _e394 {
                        phi_608_ = _e320[0];
                    } else {
                        phi_608_ = _e320[1];
                    }
                    let _e398 = phi_608_;
                    let _e399 = (_e298 == 2u);
                    if _e399 {
                        phi_614_ = _e320[2];
                    } else {
                        phi_614_ = _e398;
                    }
                    let _e402 = phi_614_;
                    if _e394 {
                        phi_625_ = _e330[0];
                    } else {
                        phi_625_ = _e330[1];
                    }
                    let _e406 = phi_625_;
                    if _e399 {
                        phi_631_ = _e330[2];
                    } else {
                        phi_631_ = _e406;
                    }
                    let _e409 = phi_631_;
                    let _e411 = ((_e409 * _e309) * _e315);
                    let _e415 = (bitcast<f32>((bitcast<u32>(_e411) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e415 {
                        let _e419 = (bitcast<f32>((bitcast<u32>(_e402) & 2147483647u)) * 0.00000011920929f);
                        phi_654_ = select(0.00000000000011368684f, _e419, (_e419 > 0.00000000000011368684f));
                    } else {
                        phi_654_ = 0f;
                    }
                    let _e423 = phi_654_;
                    let _e424 = (_e402 + _e423);
                    let _e425 = (_e402 - _e423);
                    let _e426 = select(_e411, 0f, _e415);
                    if _e415 {
                        phi_665_ = 38685626000000000000000000f;
                    } else {
                        phi_665_ = (1f / _e411);
                    }
                    let _e429 = phi_665_;
                    let _e432 = bitcast<f32>((bitcast<u32>(_e329) & 2147483647u));
                    let _e435 = bitcast<f32>((bitcast<u32>(_e366) & 2147483647u));
                    let _e437 = select(_e435, _e432, (_e432 > _e435));
                    let _e440 = bitcast<f32>((bitcast<u32>(_e402) & 2147483647u));
                    if (_e259 && (select(_e440, _e437, (_e437 > _e440)) <= 1099511600000f)) {
                        let _e445 = (_e278 / 3i);
                        let _e452 = bitcast<f32>((bitcast<u32>((_e445 + 127i)) << bitcast<u32>(23i)));
                        let _e459 = bitcast<f32>((bitcast<u32>(((_e278 - (2i * _e445)) + 127i)) << bitcast<u32>(23i)));
                        let _e460 = (((_e243 * _e452) * _e452) * _e459);
                        let _e462 = select(340282350000000000000000000000000000000f, _e460, (_e460 < 340282350000000000000000000000000000000f));
                        let _e467 = (((_e253 * _e452) * _e452) * _e459);
                        let _e469 = select(340282350000000000000000000000000000000f, _e467, (_e467 < 340282350000000000000000000000000000000f));
                        phi_765_ = select(-340282350000000000000000000000000000000f, _e469, (_e469 > -340282350000000000000000000000000000000f));
                        phi_766_ = select(-340282350000000000000000000000000000000f, _e462, (_e462 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_765_ = 0f;
                        phi_766_ = 1f;
                    }
                    let _e473 = phi_765_;
                    let _e475 = phi_766_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2802_ = false;
                    phi_777_ = type_49(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e473);
                    phi_780_ = select(0u, 2147483648u, (_e78 == 0u));
                    phi_782_ = ((3u * _e78) + 1u);
                    phi_784_ = (_e475 <= _e473);
                    phi_786_ = 0u;
                    loop {
                        let _e483 = phi_2802_;
                        let _e485 = phi_777_;
                        let _e487 = phi_780_;
                        let _e489 = phi_782_;
                        let _e491 = phi_784_;
                        let _e493 = phi_786_;
                        local_2 = _e485;
                        if _e491 {
                            phi_797_ = true;
                        } else {
                            phi_797_ = (_e493 > 0u);
                        }
                        let _e496 = phi_797_;
                        if _e496 {
                            let _e497 = (_e489 > 0u);
                            if _e497 {
                                if _e491 {
                                    phi_829_ = _e487;
                                    phi_830_ = _e491;
                                    phi_831_ = _e493;
                                } else {
                                    let _e498 = (_e493 - 1u);
                                    let _e499 = (_e498 % 128u);
                                    let _e500 = (_e499 < 128u);
                                    if _e500 {
                                    } else {
                                        phi_2962_ = true;
                                        break;
                                    }
                                    let _e502 = local_1[_e499];
                                    if _e500 {
                                    } else {
                                        phi_2962_ = true;
                                        break;
                                    }
                                    let _e504 = local[_e499];
                                    phi_829_ = _e502;
                                    phi_830_ = (_e504 <= _e485.member_1);
                                    phi_831_ = _e498;
                                }
                                let _e508 = phi_829_;
                                let _e510 = phi_830_;
                                let _e512 = phi_831_;
                                if _e510 {
                                    if ((_e508 & 2147483648u) != 0u) {
                                        phi_846_ = _e485;
                                        phi_849_ = type_8(0u, ((_e508 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e710 = phi_846_;
                                            let _e712 = phi_849_;
                                            local_3 = _e710;
                                            if (_e712.member < _e712.member_1) {
                                                phi_850_ = type_8((_e712.member + 1u), _e712.member_1);
                                                phi_872_ = type_8(1u, _e712.member);
                                            } else {
                                                phi_850_ = _e712;
                                                phi_872_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e725 = phi_850_;
                                            let _e727 = phi_872_;
                                            let _e731 = (bitcast<i32>(_e727.member) != 0i);
                                            if _e731 {
                                                let _e732 = ((_e508 & 268435455u) + _e727.member_1);
                                                let _e733 = (_e732 < _e80);
                                                if _e733 {
                                                    if _e733 {
                                                    } else {
                                                        phi_2796_ = true;
                                                        break;
                                                    }
                                                    let _e737 = global_2.member[_e732].member_1;
                                                    phi_893_ = _e737;
                                                } else {
                                                    phi_893_ = 4294967295u;
                                                }
                                                let _e739 = phi_893_;
                                                if (_e732 >= _e80) {
                                                    phi_982_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e733 {
                                                    } else {
                                                        phi_2796_ = true;
                                                        break;
                                                    }
                                                    let _e741 = (_e297 % 3u);
                                                    let _e742 = (_e296 % 3u);
                                                    let _e743 = (_e298 % 3u);
                                                    if (_e741 < 9u) {
                                                    } else {
                                                        phi_2796_ = true;
                                                        break;
                                                    }
                                                    let _e749 = global_2.member[_e732].member[_e741];
                                                    if (_e742 < 9u) {
                                                    } else {
                                                        phi_2796_ = true;
                                                        break;
                                                    }
                                                    let _e755 = global_2.member[_e732].member[_e742];
                                                    if (_e743 < 9u) {
                                                    } else {
                                                        phi_2796_ = true;
                                                        break;
                                                    }
                                                    let _e761 = global_2.member[_e732].member[_e743];
                                                    let _e763 = (3u + _e741);
                                                    if (_e763 < 9u) {
                                                    } else {
                                                        phi_2796_ = true;
                                                        break;
                                                    }
                                                    let _e769 = global_2.member[_e732].member[_e763];
                                                    let _e770 = (3u + _e742);
                                                    if (_e770 < 9u) {
                                                    } else {
                                                        phi_2796_ = true;
                                                        break;
                                                    }
                                                    let _e776 = global_2.member[_e732].member[_e770];
                                                    let _e777 = (3u + _e743);
                                                    if (_e777 < 9u) {
                                                    } else {
                                                        phi_2796_ = true;
                                                        break;
                                                    }
                                                    let _e783 = global_2.member[_e732].member[_e777];
                                                    let _e785 = (6u + _e741);
                                                    if (_e785 < 9u) {
                                                    } else {
                                                        phi_2796_ = true;
                                                        break;
                                                    }
                                                    let _e791 = global_2.member[_e732].member[_e785];
                                                    let _e792 = (6u + _e742);
                                                    if (_e792 < 9u) {
                                                    } else {
                                                        phi_2796_ = true;
                                                        break;
                                                    }
                                                    let _e798 = global_2.member[_e732].member[_e792];
                                                    let _e799 = (6u + _e743);
                                                    if (_e799 < 9u) {
                                                    } else {
                                                        phi_2796_ = true;
                                                        break;
                                                    }
                                                    let _e805 = global_2.member[_e732].member[_e799];
                                                    phi_982_ = array<array<f32, 3>, 3>(array<f32, 3>(_e749, _e755, _e761), array<f32, 3>(_e769, _e776, _e783), array<f32, 3>(_e791, _e798, _e805));
                                                }
                                                let _e809 = phi_982_;
                                                let _e817 = (_e809[0][2] - _e402);
                                                let _e820 = (((_e809[0][0] - _e329) * _e426) - (_e817 * _e354));
                                                let _e823 = (((_e809[0][1] - _e366) * _e426) - (_e817 * _e390));
                                                let _e830 = (_e809[1][2] - _e402);
                                                let _e833 = (((_e809[1][0] - _e329) * _e426) - (_e830 * _e354));
                                                let _e836 = (((_e809[1][1] - _e366) * _e426) - (_e830 * _e390));
                                                let _e843 = (_e809[2][2] - _e402);
                                                let _e846 = (((_e809[2][0] - _e329) * _e426) - (_e843 * _e354));
                                                let _e849 = (((_e809[2][1] - _e366) * _e426) - (_e843 * _e390));
                                                let _e850 = (_e846 * _e836);
                                                let _e851 = (_e849 * _e833);
                                                let _e852 = (_e820 * _e849);
                                                let _e853 = (_e823 * _e846);
                                                let _e854 = (_e833 * _e823);
                                                let _e855 = (_e836 * _e820);
                                                let _e860 = (((_e850 >= _e851) && (_e852 >= _e853)) && (_e854 >= _e855));
                                                if (_e860 || (((_e850 <= _e851) && (_e852 <= _e853)) && (_e854 <= _e855))) {
                                                    let _e867 = select(-1f, 1f, _e860);
                                                    let _e869 = ((_e850 - _e851) * _e867);
                                                    let _e871 = select(0f, _e869, (_e869 > 0f));
                                                    let _e873 = ((_e852 - _e853) * _e867);
                                                    let _e875 = select(0f, _e873, (_e873 > 0f));
                                                    let _e877 = ((_e854 - _e855) * _e867);
                                                    let _e879 = select(0f, _e877, (_e877 > 0f));
                                                    let _e881 = ((_e871 + _e875) + _e879);
                                                    if (_e881 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1807_ = type_28();
                                                        phi_1808_ = true;
                                                        phi_1809_ = false;
                                                    } else {
                                                        let _e884 = select(_e833, _e820, (_e820 < _e833));
                                                        if (select(_e846, _e884, (_e884 < _e846)) > 0f) {
                                                            phi_1099_ = true;
                                                        } else {
                                                            let _e889 = select(_e833, _e820, (_e820 > _e833));
                                                            phi_1099_ = (select(_e846, _e889, (_e889 > _e846)) < 0f);
                                                        }
                                                        let _e894 = phi_1099_;
                                                        if _e894 {
                                                            phi_1804_ = type_28();
                                                            phi_1805_ = true;
                                                            phi_1806_ = false;
                                                        } else {
                                                            let _e896 = select(_e836, _e823, (_e823 < _e836));
                                                            if (select(_e849, _e896, (_e896 < _e849)) > 0f) {
                                                                phi_1128_ = true;
                                                            } else {
                                                                let _e901 = select(_e836, _e823, (_e823 > _e836));
                                                                phi_1128_ = (select(_e849, _e901, (_e901 > _e849)) < 0f);
                                                            }
                                                            let _e906 = phi_1128_;
                                                            if _e906 {
                                                                phi_1802_ = type_28();
                                                                phi_1803_ = false;
                                                            } else {
                                                                let _e908 = select(_e809[1][0], _e809[0][0], (_e809[0][0] < _e809[1][0]));
                                                                let _e912 = select(_e809[1][0], _e809[0][0], (_e809[0][0] > _e809[1][0]));
                                                                let _e916 = select(_e809[1][1], _e809[0][1], (_e809[0][1] < _e809[1][1]));
                                                                let _e920 = select(_e809[1][1], _e809[0][1], (_e809[0][1] > _e809[1][1]));
                                                                let _e924 = select(_e809[1][2], _e809[0][2], (_e809[0][2] < _e809[1][2]));
                                                                let _e928 = select(_e809[1][2], _e809[0][2], (_e809[0][2] > _e809[1][2]));
                                                                let _e933 = ((select(_e809[2][0], _e908, (_e908 < _e809[2][0])) - _e352) * _e357);
                                                                let _e934 = ((select(_e809[2][0], _e912, (_e912 > _e809[2][0])) - _e353) * _e357);
                                                                let _e937 = ((select(_e809[2][1], _e916, (_e916 < _e809[2][1])) - _e388) * _e393);
                                                                let _e938 = ((select(_e809[2][1], _e920, (_e920 > _e809[2][1])) - _e389) * _e393);
                                                                let _e941 = ((select(_e809[2][2], _e924, (_e924 < _e809[2][2])) - _e424) * _e429);
                                                                let _e942 = ((select(_e809[2][2], _e928, (_e928 > _e809[2][2])) - _e425) * _e429);
                                                                let _e944 = select(_e942, _e941, (_e941 < _e942));
                                                                let _e946 = select(_e942, _e941, (_e941 > _e942));
                                                                let _e948 = select(_e934, _e933, (_e933 < _e934));
                                                                let _e950 = select(_e938, _e937, (_e937 < _e938));
                                                                let _e952 = select(_e950, _e948, (_e948 > _e950));
                                                                let _e954 = select(_e944, _e952, (_e952 > _e944));
                                                                let _e956 = select(_e934, _e933, (_e933 > _e934));
                                                                let _e958 = select(_e938, _e937, (_e937 > _e938));
                                                                let _e960 = select(_e958, _e956, (_e956 < _e958));
                                                                let _e962 = select(_e946, _e960, (_e960 < _e946));
                                                                let _e963 = -(_e944);
                                                                let _e969 = select(_e475, _e954, (_e954 > _e475));
                                                                if (_e969 > (_e962 + (select(_e963, _e946, (_e946 > _e963)) * 0.0000019073523f))) {
                                                                    phi_1797_ = type_28();
                                                                    phi_1798_ = true;
                                                                } else {
                                                                    let _e971 = (_e969 > _e710.member_1);
                                                                    if _e971 {
                                                                        phi_1796_ = type_28();
                                                                    } else {
                                                                        let _e972 = vec3<f32>(_e809[0][0], _e809[0][1], _e809[0][2]);
                                                                        let _e973 = vec3<f32>(_e809[1][0], _e809[1][1], _e809[1][2]);
                                                                        let _e974 = vec3<f32>(_e809[2][0], _e809[2][1], _e809[2][2]);
                                                                        let _e975 = (_e809[1][0] - _e809[0][0]);
                                                                        let _e976 = (_e809[1][1] - _e809[0][1]);
                                                                        let _e977 = (_e809[1][2] - _e809[0][2]);
                                                                        let _e978 = vec3<f32>(_e975, _e976, _e977);
                                                                        let _e979 = (_e809[2][0] - _e809[1][0]);
                                                                        let _e980 = (_e809[2][1] - _e809[1][1]);
                                                                        let _e981 = (_e809[2][2] - _e809[1][2]);
                                                                        let _e982 = vec3<f32>(_e979, _e980, _e981);
                                                                        let _e983 = (_e809[0][0] - _e809[2][0]);
                                                                        let _e984 = (_e809[0][1] - _e809[2][1]);
                                                                        let _e985 = (_e809[0][2] - _e809[2][2]);
                                                                        let _e986 = vec3<f32>(_e983, _e984, _e985);
                                                                        let _e989 = bitcast<f32>((bitcast<u32>(_e975) & 2147483647u));
                                                                        let _e992 = bitcast<f32>((bitcast<u32>(_e976) & 2147483647u));
                                                                        let _e994 = select(_e992, _e989, (_e989 > _e992));
                                                                        let _e997 = bitcast<f32>((bitcast<u32>(_e977) & 2147483647u));
                                                                        let _e999 = select(_e997, _e994, (_e994 > _e997));
                                                                        let _e1002 = bitcast<f32>((bitcast<u32>(_e979) & 2147483647u));
                                                                        let _e1005 = bitcast<f32>((bitcast<u32>(_e980) & 2147483647u));
                                                                        let _e1007 = select(_e1005, _e1002, (_e1002 > _e1005));
                                                                        let _e1010 = bitcast<f32>((bitcast<u32>(_e981) & 2147483647u));
                                                                        let _e1012 = select(_e1010, _e1007, (_e1007 > _e1010));
                                                                        let _e1015 = bitcast<f32>((bitcast<u32>(_e983) & 2147483647u));
                                                                        let _e1018 = bitcast<f32>((bitcast<u32>(_e984) & 2147483647u));
                                                                        let _e1020 = select(_e1018, _e1015, (_e1015 > _e1018));
                                                                        let _e1023 = bitcast<f32>((bitcast<u32>(_e985) & 2147483647u));
                                                                        let _e1025 = select(_e1023, _e1020, (_e1020 > _e1023));
                                                                        let _e1027 = select(_e1012, _e999, (_e999 > _e1012));
                                                                        let _e1029 = select(_e1025, _e1027, (_e1027 > _e1025));
                                                                        if (_e999 == _e1029) {
                                                                            phi_1529_ = _e836;
                                                                            phi_1530_ = _e833;
                                                                            phi_1531_ = _e823;
                                                                            phi_1532_ = _e820;
                                                                            phi_1533_ = _e972;
                                                                            phi_1534_ = _e986;
                                                                            phi_1535_ = _e982;
                                                                            phi_1536_ = _e978;
                                                                        } else {
                                                                            let _e1031 = (_e1012 == _e1029);
                                                                            let _e1036 = vec3(_e1031);
                                                                            phi_1529_ = select(_e823, _e849, _e1031);
                                                                            phi_1530_ = select(_e820, _e846, _e1031);
                                                                            phi_1531_ = select(_e849, _e836, _e1031);
                                                                            phi_1532_ = select(_e846, _e833, _e1031);
                                                                            phi_1533_ = select(_e974, _e973, _e1036);
                                                                            phi_1534_ = select(_e982, _e978, _e1036);
                                                                            phi_1535_ = select(_e978, _e986, _e1036);
                                                                            phi_1536_ = select(_e986, _e982, _e1036);
                                                                        }
                                                                        let _e1042 = phi_1529_;
                                                                        let _e1044 = phi_1530_;
                                                                        let _e1046 = phi_1531_;
                                                                        let _e1048 = phi_1532_;
                                                                        let _e1050 = phi_1533_;
                                                                        let _e1052 = phi_1534_;
                                                                        let _e1054 = phi_1535_;
                                                                        let _e1056 = phi_1536_;
                                                                        let _e1063 = ((_e1054.y * _e1052.z) - (_e1052.y * _e1054.z));
                                                                        let _e1068 = ((_e1054.z * _e1052.x) - (_e1052.z * _e1054.x));
                                                                        let _e1071 = ((_e1054.x * _e1052.y) - (_e1052.x * _e1054.y));
                                                                        if (_e871 >= _e875) {
                                                                            phi_1567_ = select(true, false, (_e871 >= _e879));
                                                                        } else {
                                                                            phi_1567_ = true;
                                                                        }
                                                                        let _e1076 = phi_1567_;
                                                                        if _e1076 {
                                                                            phi_1576_ = select(_e974, _e973, vec3((_e875 >= _e879)));
                                                                        } else {
                                                                            phi_1576_ = _e972;
                                                                        }
                                                                        let _e1081 = phi_1576_;
                                                                        let _e1092 = (((_e1063 * (_e1081.x - _e329)) + (_e1068 * (_e1081.y - _e366))) + (_e1071 * (_e1081.z - _e402)));
                                                                        let _e1097 = (((_e1063 * _e354) + (_e1068 * _e390)) + (_e1071 * _e426));
                                                                        let _e1098 = (_e1044 - _e1048);
                                                                        let _e1099 = (_e1042 - _e1046);
                                                                        let _e1107 = (-(((_e1048 * _e1098) + (_e1046 * _e1099))) / ((_e1098 * _e1098) + (_e1099 * _e1099)));
                                                                        let _e1109 = select(1f, _e1107, (_e1107 < 1f));
                                                                        let _e1111 = select(0f, _e1109, (_e1109 > 0f));
                                                                        let _e1124 = ((_e1050.x + (_e1056.x * _e1111)) - _e329);
                                                                        let _e1125 = ((_e1050.y + (_e1056.y * _e1111)) - _e366);
                                                                        let _e1126 = ((_e1050.z + (_e1056.z * _e1111)) - _e402);
                                                                        let _e1127 = (_e1126 / _e426);
                                                                        let _e1139 = bitcast<f32>((bitcast<u32>(_e1124) & 2147483647u));
                                                                        let _e1142 = bitcast<f32>((bitcast<u32>(_e1125) & 2147483647u));
                                                                        let _e1144 = select(_e1142, _e1139, (_e1139 > _e1142));
                                                                        let _e1147 = bitcast<f32>((bitcast<u32>(_e1126) & 2147483647u));
                                                                        let _e1149 = select(_e1147, _e1144, (_e1144 > _e1147));
                                                                        let _e1155 = bitcast<f32>((bitcast<u32>(_e1063) & 2147483647u));
                                                                        let _e1158 = bitcast<f32>((bitcast<u32>(_e1068) & 2147483647u));
                                                                        let _e1160 = select(_e1158, _e1155, (_e1155 > _e1158));
                                                                        let _e1163 = bitcast<f32>((bitcast<u32>(_e1071) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1063 * _e1124) + (_e1068 * _e1125)) + (_e1071 * _e1126)) - _e1092)) & 2147483647u)) <= ((0.0000009536743f * select(_e1029, _e1149, (_e1149 > _e1029))) * select(_e1163, _e1160, (_e1160 > _e1163)))) {
                                                                            let _e1173 = bitcast<f32>((bitcast<u32>(_e1054.x) & 2147483647u));
                                                                            let _e1176 = bitcast<f32>((bitcast<u32>(_e1054.y) & 2147483647u));
                                                                            let _e1178 = select(_e1176, _e1173, (_e1173 > _e1176));
                                                                            let _e1181 = bitcast<f32>((bitcast<u32>(_e1054.z) & 2147483647u));
                                                                            let _e1187 = bitcast<f32>((bitcast<u32>(_e1052.x) & 2147483647u));
                                                                            let _e1190 = bitcast<f32>((bitcast<u32>(_e1052.y) & 2147483647u));
                                                                            let _e1192 = select(_e1190, _e1187, (_e1187 > _e1190));
                                                                            let _e1195 = bitcast<f32>((bitcast<u32>(_e1052.z) & 2147483647u));
                                                                            let _e1199 = (bitcast<f32>((bitcast<u32>(_e1097) & 2147483647u)) > ((0.0000038146973f * select(_e1181, _e1178, (_e1178 > _e1181))) * select(_e1195, _e1192, (_e1192 > _e1195))));
                                                                            if _e1199 {
                                                                                phi_1741_ = (_e1092 / _e1097);
                                                                            } else {
                                                                                phi_1741_ = f32();
                                                                            }
                                                                            let _e1202 = phi_1741_;
                                                                            phi_1743_ = _e1202;
                                                                            phi_1744_ = select(true, false, _e1199);
                                                                        } else {
                                                                            phi_1743_ = f32();
                                                                            phi_1744_ = true;
                                                                        }
                                                                        let _e1205 = phi_1743_;
                                                                        let _e1207 = phi_1744_;
                                                                        if _e1207 {
                                                                            let _e1215 = (((_e1063 * (_e1124 - (_e354 * _e1127))) + (_e1068 * (_e1125 - (_e390 * _e1127)))) / _e1097);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1215) & 2147483647u)) <= _e1029) {
                                                                                phi_1764_ = (_e1127 + _e1215);
                                                                            } else {
                                                                                phi_1764_ = _e1127;
                                                                            }
                                                                            let _e1222 = phi_1764_;
                                                                            phi_1765_ = _e1222;
                                                                        } else {
                                                                            phi_1765_ = _e1205;
                                                                        }
                                                                        let _e1224 = phi_1765_;
                                                                        let _e1226 = select(_e962, _e1224, (_e1224 < _e962));
                                                                        let _e1228 = select(_e954, _e1226, (_e1226 > _e954));
                                                                        if (_e1228 >= _e475) {
                                                                            let _e1230 = (_e1228 <= _e710.member_1);
                                                                            if _e1230 {
                                                                                let _e1231 = (1f / _e881);
                                                                                phi_1788_ = type_28(_e1228, (_e875 * _e1231), (_e879 * _e1231), _e739);
                                                                            } else {
                                                                                phi_1788_ = type_28();
                                                                            }
                                                                            let _e1236 = phi_1788_;
                                                                            phi_1790_ = _e1236;
                                                                            phi_1791_ = select(true, false, _e1230);
                                                                        } else {
                                                                            phi_1790_ = type_28();
                                                                            phi_1791_ = true;
                                                                        }
                                                                        let _e1239 = phi_1790_;
                                                                        let _e1241 = phi_1791_;
                                                                        if _e1241 {
                                                                            phi_1795_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1795_ = _e1239;
                                                                        }
                                                                        let _e1243 = phi_1795_;
                                                                        phi_1796_ = _e1243;
                                                                    }
                                                                    let _e1245 = phi_1796_;
                                                                    phi_1797_ = _e1245;
                                                                    phi_1798_ = _e971;
                                                                }
                                                                let _e1247 = phi_1797_;
                                                                let _e1249 = phi_1798_;
                                                                phi_1802_ = _e1247;
                                                                phi_1803_ = _e1249;
                                                            }
                                                            let _e1251 = phi_1802_;
                                                            let _e1253 = phi_1803_;
                                                            phi_1804_ = _e1251;
                                                            phi_1805_ = _e906;
                                                            phi_1806_ = _e1253;
                                                        }
                                                        let _e1255 = phi_1804_;
                                                        let _e1257 = phi_1805_;
                                                        let _e1259 = phi_1806_;
                                                        phi_1807_ = _e1255;
                                                        phi_1808_ = _e1257;
                                                        phi_1809_ = _e1259;
                                                    }
                                                    let _e1261 = phi_1807_;
                                                    let _e1263 = phi_1808_;
                                                    let _e1265 = phi_1809_;
                                                    phi_1817_ = _e1261;
                                                    phi_1818_ = select(_e1265, true, _e1263);
                                                } else {
                                                    phi_1817_ = type_28();
                                                    phi_1818_ = true;
                                                }
                                                let _e1268 = phi_1817_;
                                                let _e1270 = phi_1818_;
                                                if _e1270 {
                                                    phi_1822_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1822_ = _e1268;
                                                }
                                                let _e1272 = phi_1822_;
                                                if (_e1272.member_3 != 4294967295u) {
                                                    if (_e739 == _e103) {
                                                        phi_2151_ = false;
                                                    } else {
                                                        let _e1276 = (_e739 < arrayLength((&global_5.member)));
                                                        if _e1276 {
                                                            if _e1276 {
                                                            } else {
                                                                phi_2796_ = true;
                                                                break;
                                                            }
                                                            let _e1278 = global_5.member[_e739];
                                                            phi_1845_ = _e1278;
                                                        } else {
                                                            phi_1845_ = 4294967295u;
                                                        }
                                                        let _e1280 = phi_1845_;
                                                        let _e1281 = (_e1280 < arrayLength((&global_6.member)));
                                                        if _e1281 {
                                                            if _e1281 {
                                                            } else {
                                                                phi_2796_ = true;
                                                                break;
                                                            }
                                                            let _e1283 = global_6.member[_e1280];
                                                            phi_1859_ = _e1283;
                                                        } else {
                                                            phi_1859_ = 0i;
                                                        }
                                                        let _e1285 = phi_1859_;
                                                        let _e1286 = (_e1285 == 0i);
                                                        if _e1286 {
                                                            phi_2150_ = true;
                                                        } else {
                                                            if _e321 {
                                                                phi_1880_ = vec3<f32>(_e809[0][0], _e809[0][1], _e809[0][2]);
                                                            } else {
                                                                if (_e297 == 1u) {
                                                                    phi_1879_ = vec3<f32>(_e809[0][2], _e809[0][0], _e809[0][1]);
                                                                } else {
                                                                    phi_1879_ = vec3<f32>(_e809[0][1], _e809[0][2], _e809[0][0]);
                                                                }
                                                                let _e1291 = phi_1879_;
                                                                phi_1880_ = _e1291;
                                                            }
                                                            let _e1294 = phi_1880_;
                                                            if _e321 {
                                                                phi_1897_ = vec3<f32>(_e809[1][0], _e809[1][1], _e809[1][2]);
                                                            } else {
                                                                if (_e297 == 1u) {
                                                                    phi_1896_ = vec3<f32>(_e809[1][2], _e809[1][0], _e809[1][1]);
                                                                } else {
                                                                    phi_1896_ = vec3<f32>(_e809[1][1], _e809[1][2], _e809[1][0]);
                                                                }
                                                                let _e1299 = phi_1896_;
                                                                phi_1897_ = _e1299;
                                                            }
                                                            let _e1302 = phi_1897_;
                                                            if _e321 {
                                                                phi_1914_ = vec3<f32>(_e809[2][0], _e809[2][1], _e809[2][2]);
                                                            } else {
                                                                if (_e297 == 1u) {
                                                                    phi_1913_ = vec3<f32>(_e809[2][2], _e809[2][0], _e809[2][1]);
                                                                } else {
                                                                    phi_1913_ = vec3<f32>(_e809[2][1], _e809[2][2], _e809[2][0]);
                                                                }
                                                                let _e1307 = phi_1913_;
                                                                phi_1914_ = _e1307;
                                                            }
                                                            let _e1310 = phi_1914_;
                                                            let _e1313 = (_e1302.x - _e1294.x);
                                                            let _e1316 = (_e1302.y - _e1294.y);
                                                            let _e1319 = (_e1302.z - _e1294.z);
                                                            let _e1321 = (_e1310.x - _e1294.x);
                                                            let _e1323 = (_e1310.y - _e1294.y);
                                                            let _e1325 = (_e1310.z - _e1294.z);
                                                            if (_e175.member_1 == 1u) {
                                                                phi_1950_ = (vec3<f32>(_e175.member[0], _e175.member[1], _e175.member[2]) - _e1294);
                                                            } else {
                                                                phi_1950_ = vec3<f32>(_e175.member[0], _e175.member[1], _e175.member[2]);
                                                            }
                                                            let _e1340 = phi_1950_;
                                                            let _e1346 = bitcast<f32>((bitcast<u32>((_e1313 * _e1323)) ^ _e175.member_3[0]));
                                                            let _e1350 = bitcast<f32>((bitcast<u32>((_e1316 * _e1321)) ^ _e175.member_3[0]));
                                                            let _e1354 = bitcast<f32>((bitcast<u32>((_e1316 * _e1325)) ^ _e175.member_3[0]));
                                                            let _e1358 = bitcast<f32>((bitcast<u32>((_e1319 * _e1323)) ^ _e175.member_3[0]));
                                                            let _e1362 = bitcast<f32>((bitcast<u32>((_e1319 * _e1321)) ^ _e175.member_3[0]));
                                                            let _e1366 = bitcast<f32>((bitcast<u32>((_e1313 * _e1325)) ^ _e175.member_3[0]));
                                                            let _e1367 = (_e1354 - _e1358);
                                                            let _e1368 = (_e1362 - _e1366);
                                                            let _e1369 = (_e1346 - _e1350);
                                                            let _e1393 = (bitcast<f32>((bitcast<u32>(_e1354) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1358) & 2147483647u)));
                                                            let _e1400 = (bitcast<f32>((bitcast<u32>(_e1362) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1366) & 2147483647u)));
                                                            let _e1407 = (bitcast<f32>((bitcast<u32>(_e1346) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1350) & 2147483647u)));
                                                            if (_e175.member_2 == 0f) {
                                                                phi_2132_ = 0f;
                                                            } else {
                                                                let _e1437 = bitcast<f32>((bitcast<u32>(_e1367) & 2147483647u));
                                                                let _e1440 = bitcast<f32>((bitcast<u32>(_e1368) & 2147483647u));
                                                                let _e1443 = bitcast<f32>((bitcast<u32>(_e1369) & 2147483647u));
                                                                let _e1445 = select(_e1443, _e1440, (_e1440 > _e1443));
                                                                let _e1449 = select(_e1443, _e1440, (_e1440 < _e1443));
                                                                let _e1453 = select(_e1440, _e1437, (_e1437 < _e1440));
                                                                let _e1455 = select(_e1440, _e1437, (_e1437 > _e1440));
                                                                let _e1457 = select(_e1443, _e1455, (_e1455 < _e1443));
                                                                phi_2132_ = bitcast<f32>((bitcast<u32>((_e175.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1445, _e1437, (_e1437 > _e1445)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1457, _e1453, (_e1453 > _e1457)))) ^ _e175.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1449, _e1437, (_e1437 < _e1449)))) ^ _e175.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1393 + _e1400) + _e1407))) ^ _e175.member_3[0]))) * 1.0000005f)) ^ _e175.member_3[0])))) ^ _e175.member_3[0]));
                                                            }
                                                            let _e1484 = phi_2132_;
                                                            phi_2150_ = (_e1286 || !(((((bitcast<f32>((bitcast<u32>((_e1340.x * _e1367)) ^ _e175.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1340.y * _e1368)) ^ _e175.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1340.z * _e1369)) ^ _e175.member_3[0]))) * f32(-(_e1285))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1340.x) & 2147483647u)) * _e1393)) ^ _e175.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1340.y) & 2147483647u)) * _e1400)) ^ _e175.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1340.z) & 2147483647u)) * _e1407)) ^ _e175.member_3[0]))))) ^ _e175.member_3[0])) + _e1484) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1498 = phi_2150_;
                                                        phi_2151_ = _e1498;
                                                    }
                                                    let _e1500 = phi_2151_;
                                                    if _e1500 {
                                                        if (_e1272.member < _e710.member.member) {
                                                            phi_2171_ = true;
                                                        } else {
                                                            if (_e1272.member == _e710.member.member) {
                                                                phi_2170_ = (_e1272.member_3 < _e710.member.member_3);
                                                            } else {
                                                                phi_2170_ = false;
                                                            }
                                                            let _e1510 = phi_2170_;
                                                            phi_2171_ = _e1510;
                                                        }
                                                        let _e1512 = phi_2171_;
                                                        if _e1512 {
                                                            phi_2177_ = type_49(_e1272, _e1272.member);
                                                        } else {
                                                            phi_2177_ = _e710;
                                                        }
                                                        let _e1515 = phi_2177_;
                                                        phi_2178_ = _e1515;
                                                    } else {
                                                        phi_2178_ = _e710;
                                                    }
                                                    let _e1517 = phi_2178_;
                                                    phi_2179_ = _e1517;
                                                } else {
                                                    phi_2179_ = _e710;
                                                }
                                                let _e1519 = phi_2179_;
                                                phi_847_ = _e1519;
                                            } else {
                                                phi_847_ = type_49();
                                            }
                                            let _e1521 = phi_847_;
                                            continue;
                                            continuing {
                                                phi_846_ = _e1521;
                                                phi_849_ = _e725;
                                                phi_2796_ = _e483;
                                                break if !(_e731);
                                            }
                                        }
                                        let _e1524 = phi_2796_;
                                        phi_2962_ = _e1524;
                                        if _e1524 {
                                            break;
                                        }
                                        phi_2966_ = _e1524;
                                        let _e1751 = local_3;
                                        phi_2634_ = _e1751;
                                        phi_2635_ = _e508;
                                        phi_2636_ = false;
                                        phi_2637_ = _e512;
                                    } else {
                                        if (_e508 >= _e78) {
                                            phi_2239_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e508 < _e78) {
                                            } else {
                                                phi_2962_ = true;
                                                break;
                                            }
                                            let _e522 = (_e297 % 3u);
                                            if (_e522 < 3u) {
                                            } else {
                                                phi_2962_ = true;
                                                break;
                                            }
                                            let _e528 = global_4.member[_e508].member[_e522];
                                            let _e534 = (_e296 % 3u);
                                            if (_e534 < 3u) {
                                            } else {
                                                phi_2962_ = true;
                                                break;
                                            }
                                            let _e540 = global_4.member[_e508].member[_e534];
                                            let _e546 = (_e298 % 3u);
                                            if (_e546 < 3u) {
                                            } else {
                                                phi_2962_ = true;
                                                break;
                                            }
                                            let _e552 = global_4.member[_e508].member[_e546];
                                            let _e562 = global_4.member[_e508].member_1;
                                            let _e566 = global_4.member[_e508].member_2;
                                            phi_2239_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e528[0], _e528[1], _e528[2], _e528[3]), vec4<f32>(_e540[0], _e540[1], _e540[2], _e540[3]), vec4<f32>(_e552[0], _e552[1], _e552[2], _e552[3])), _e562, _e566);
                                        }
                                        let _e569 = phi_2239_;
                                        let _e581 = ((_e569.member[0].x - _e352) * _e357);
                                        let _e582 = ((_e569.member[0].y - _e352) * _e357);
                                        let _e583 = ((_e569.member[0].z - _e353) * _e357);
                                        let _e584 = ((_e569.member[0].w - _e353) * _e357);
                                        let _e594 = ((_e569.member[1].x - _e388) * _e393);
                                        let _e595 = ((_e569.member[1].y - _e388) * _e393);
                                        let _e596 = ((_e569.member[1].z - _e389) * _e393);
                                        let _e597 = ((_e569.member[1].w - _e389) * _e393);
                                        let _e607 = ((_e569.member[2].x - _e424) * _e429);
                                        let _e608 = ((_e569.member[2].y - _e424) * _e429);
                                        let _e609 = ((_e569.member[2].z - _e425) * _e429);
                                        let _e610 = ((_e569.member[2].w - _e425) * _e429);
                                        let _e612 = select(_e609, _e607, (_e607 < _e609));
                                        let _e614 = select(_e610, _e608, (_e608 < _e610));
                                        let _e616 = select(_e609, _e607, (_e607 > _e609));
                                        let _e618 = select(_e610, _e608, (_e608 > _e610));
                                        let _e620 = select(_e583, _e581, (_e581 < _e583));
                                        let _e622 = select(_e584, _e582, (_e582 < _e584));
                                        let _e624 = select(_e596, _e594, (_e594 < _e596));
                                        let _e626 = select(_e597, _e595, (_e595 < _e597));
                                        let _e628 = select(_e624, _e620, (_e620 > _e624));
                                        let _e630 = select(_e626, _e622, (_e622 > _e626));
                                        let _e632 = select(_e612, _e628, (_e628 > _e612));
                                        let _e634 = select(_e614, _e630, (_e630 > _e614));
                                        let _e636 = select(_e583, _e581, (_e581 > _e583));
                                        let _e638 = select(_e584, _e582, (_e582 > _e584));
                                        let _e640 = select(_e596, _e594, (_e594 > _e596));
                                        let _e642 = select(_e597, _e595, (_e595 > _e597));
                                        let _e644 = select(_e640, _e636, (_e636 < _e640));
                                        let _e646 = select(_e642, _e638, (_e638 < _e642));
                                        let _e651 = -(_e612);
                                        let _e652 = -(_e614);
                                        let _e659 = (select(_e616, _e644, (_e644 < _e616)) + (select(_e651, _e616, (_e616 > _e651)) * 0.0000019073523f));
                                        let _e660 = (select(_e618, _e646, (_e646 < _e618)) + (select(_e652, _e618, (_e618 > _e652)) * 0.0000019073523f));
                                        let _e662 = select(_e475, _e632, (_e632 > _e475));
                                        let _e664 = select(_e475, _e634, (_e634 > _e475));
                                        let _e669 = (_e662 <= select(_e485.member_1, _e659, (_e659 < _e485.member_1)));
                                        let _e670 = (_e664 <= select(_e485.member_1, _e660, (_e660 < _e485.member_1)));
                                        let _e671 = (_e662 <= _e664);
                                        if _e669 {
                                            if _e670 {
                                                if _e671 {
                                                    phi_2583_ = _e569.member_2;
                                                } else {
                                                    phi_2583_ = _e569.member_1;
                                                }
                                                let _e675 = phi_2583_;
                                                let _e678 = (_e512 % 128u);
                                                let _e679 = (_e678 < 128u);
                                                if _e679 {
                                                } else {
                                                    phi_2962_ = true;
                                                    break;
                                                }
                                                local_1[_e678] = _e675;
                                                if _e679 {
                                                } else {
                                                    phi_2962_ = true;
                                                    break;
                                                }
                                                local[_e678] = select(_e664, _e662, (_e662 > _e664));
                                                if _e671 {
                                                    phi_2611_ = _e569.member_1;
                                                } else {
                                                    phi_2611_ = _e569.member_2;
                                                }
                                                let _e686 = phi_2611_;
                                                phi_2612_ = _e686;
                                                phi_2613_ = (_e512 + 1u);
                                            } else {
                                                phi_2612_ = u32();
                                                phi_2613_ = u32();
                                            }
                                            let _e688 = phi_2612_;
                                            let _e690 = phi_2613_;
                                            phi_2615_ = _e688;
                                            phi_2616_ = _e690;
                                            phi_2617_ = select(true, false, _e670);
                                        } else {
                                            phi_2615_ = u32();
                                            phi_2616_ = u32();
                                            phi_2617_ = true;
                                        }
                                        let _e693 = phi_2615_;
                                        let _e695 = phi_2616_;
                                        let _e697 = phi_2617_;
                                        if _e697 {
                                            if _e669 {
                                                phi_2626_ = _e569.member_1;
                                            } else {
                                                phi_2626_ = _e569.member_2;
                                            }
                                            let _e701 = phi_2626_;
                                            phi_2631_ = _e701;
                                            phi_2632_ = select(_e670, true, _e669);
                                        } else {
                                            phi_2631_ = _e693;
                                            phi_2632_ = _e510;
                                        }
                                        let _e704 = phi_2631_;
                                        let _e706 = phi_2632_;
                                        phi_2966_ = _e483;
                                        phi_2634_ = _e485;
                                        phi_2635_ = _e704;
                                        phi_2636_ = _e706;
                                        phi_2637_ = select(_e695, _e512, _e697);
                                    }
                                    let _e1526 = phi_2966_;
                                    let _e1528 = phi_2634_;
                                    let _e1530 = phi_2635_;
                                    let _e1532 = phi_2636_;
                                    let _e1534 = phi_2637_;
                                    phi_2965_ = _e1526;
                                    phi_2638_ = _e1528;
                                    phi_2639_ = _e1530;
                                    phi_2640_ = (_e489 - 1u);
                                    phi_2641_ = _e1532;
                                    phi_2642_ = _e1534;
                                } else {
                                    phi_2965_ = _e483;
                                    phi_2638_ = _e485;
                                    phi_2639_ = _e508;
                                    phi_2640_ = _e489;
                                    phi_2641_ = _e510;
                                    phi_2642_ = _e512;
                                }
                                let _e1536 = phi_2965_;
                                let _e1538 = phi_2638_;
                                let _e1540 = phi_2639_;
                                let _e1542 = phi_2640_;
                                let _e1544 = phi_2641_;
                                let _e1546 = phi_2642_;
                                phi_2964_ = _e1536;
                                phi_2643_ = _e1538;
                                phi_2644_ = _e1540;
                                phi_2645_ = _e1542;
                                phi_2646_ = _e1544;
                                phi_2647_ = _e1546;
                            } else {
                                phi_2964_ = _e483;
                                phi_2643_ = type_49();
                                phi_2644_ = u32();
                                phi_2645_ = u32();
                                phi_2646_ = bool();
                                phi_2647_ = u32();
                            }
                            let _e1548 = phi_2964_;
                            let _e1550 = phi_2643_;
                            let _e1552 = phi_2644_;
                            let _e1554 = phi_2645_;
                            let _e1556 = phi_2646_;
                            let _e1558 = phi_2647_;
                            phi_2963_ = _e1548;
                            phi_778_ = _e1550;
                            phi_781_ = _e1552;
                            phi_783_ = _e1554;
                            phi_785_ = _e1556;
                            phi_787_ = _e1558;
                            phi_2648_ = _e497;
                        } else {
                            phi_2963_ = _e483;
                            phi_778_ = type_49();
                            phi_781_ = u32();
                            phi_783_ = u32();
                            phi_785_ = bool();
                            phi_787_ = u32();
                            phi_2648_ = false;
                        }
                        let _e1560 = phi_2963_;
                        let _e1562 = phi_778_;
                        let _e1564 = phi_781_;
                        let _e1566 = phi_783_;
                        let _e1568 = phi_785_;
                        let _e1570 = phi_787_;
                        let _e1572 = phi_2648_;
                        continue;
                        continuing {
                            phi_2802_ = _e1560;
                            phi_777_ = _e1562;
                            phi_780_ = _e1564;
                            phi_782_ = _e1566;
                            phi_784_ = _e1568;
                            phi_786_ = _e1570;
                            phi_2962_ = _e1560;
                            break if !(_e1572);
                        }
                    }
                    let _e1575 = phi_2962_;
                    if _e1575 {
                        break;
                    }
                    let _e1577 = local_2;
                    if (_e1577.member.member_3 != 4294967295u) {
                        let _e1582 = (_e299 / 3i);
                        let _e1589 = bitcast<f32>((bitcast<u32>((_e1582 + 127i)) << bitcast<u32>(23i)));
                        let _e1597 = (((_e1577.member.member * _e1589) * _e1589) * bitcast<f32>((bitcast<u32>(((_e299 - (2i * _e1582)) + 127i)) << bitcast<u32>(23i))));
                        let _e1599 = select(340282350000000000000000000000000000000f, _e1597, (_e1597 < 340282350000000000000000000000000000000f));
                        phi_2700_ = type_28(select(-340282350000000000000000000000000000000f, _e1599, (_e1599 > -340282350000000000000000000000000000000f)), _e1577.member.member_1, _e1577.member.member_2, _e1577.member.member_3);
                    } else {
                        phi_2700_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1606 = phi_2700_;
                    if _e176 {
                    } else {
                        break;
                    }
                    global_8.member[_e96] = _e1606;
                    if _e97 {
                    } else {
                        break;
                    }
                    let _e1610 = select(0u, 1u, (_e243 <= _e253));
                    if (_e1610 > 0u) {
                        let _e1612 = (1u < _e92);
                        if _e1612 {
                            if (0u < _e92) {
                            } else {
                                break;
                            }
                            let _e1616 = atomicAdd((&global_9.member[0u]), _e1610);
                            if ((_e1616 + _e1610) < _e1616) {
                                if _e1612 {
                                } else {
                                    break;
                                }
                                let _e1621 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1624 = select(0u, 1u, (_e1606.member_3 != 4294967295u));
                    if (_e1624 > 0u) {
                        let _e1626 = (3u < _e92);
                        if _e1626 {
                            if (2u < _e92) {
                            } else {
                                break;
                            }
                            let _e1630 = atomicAdd((&global_9.member[2u]), _e1624);
                            if ((_e1630 + _e1624) < _e1630) {
                                if _e1626 {
                                } else {
                                    break;
                                }
                                let _e1635 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_facing(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
