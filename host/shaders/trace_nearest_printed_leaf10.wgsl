struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: array<type_19>,
}

struct type_31 {
    member: array<array<type_18, 8>>,
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

struct type_45 {
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
    member: type_45,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_37;
@group(0) @binding(4) 
var<storage> global_3: type_27;
@group(0) @binding(2) 
var<storage> global_4: type_41;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_31;
@group(0) @binding(3) 
var<storage> global_6: type_49;

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
    var local_9: array<f32, 3>;
    var local_10: array<f32, 3>;
    var local_11: array<type_18, 8>;
    var local_12: array<f32, 128>;
    var local_13: array<f32, 3>;
    var local_14: array<f32, 3>;
    var local_15: array<f32, 3>;
    var local_16: array<f32, 3>;
    var local_17: array<u32, 3>;
    var local_18: array<u32, 3>;
    var local_19: array<u32, 3>;
    var local_20: array<array<f32, 3>, 3>;
    var local_21: array<u32, 3>;
    var local_22: array<f32, 3>;
    var local_23: array<f32, 3>;
    var phi_355_: i32;
    var phi_356_: i32;
    var phi_366_: bool;
    var phi_376_: u32;
    var phi_377_: u32;
    var phi_379_: bool;
    var phi_384_: u32;
    var phi_397_: i32;
    var phi_417_: i32;
    var phi_435_: f32;
    var phi_441_: f32;
    var phi_452_: f32;
    var phi_458_: f32;
    var phi_481_: f32;
    var phi_492_: f32;
    var phi_501_: f32;
    var phi_507_: f32;
    var phi_518_: f32;
    var phi_524_: f32;
    var phi_547_: f32;
    var phi_558_: f32;
    var phi_567_: f32;
    var phi_573_: f32;
    var phi_584_: f32;
    var phi_590_: f32;
    var phi_613_: f32;
    var phi_624_: f32;
    var phi_724_: f32;
    var phi_725_: f32;
    var phi_3075_: bool;
    var phi_3066_: f32;
    var phi_851_: type_53;
    var phi_854_: u32;
    var phi_856_: bool;
    var phi_858_: u32;
    var phi_869_: bool;
    var phi_956_: type_53;
    var phi_957_: bool;
    var phi_958_: u32;
    var phi_1942_: type_39;
    var phi_1951_: type_4;
    var phi_1952_: type_4;
    var phi_1975_: type_4;
    var phi_3068_: bool;
    var phi_2105_: type_4;
    var phi_2106_: type_4;
    var phi_2129_: type_4;
    var phi_3128_: bool;
    var phi_2693_: type_53;
    var phi_2770_: type_53;
    var phi_2771_: type_53;
    var phi_2772_: u32;
    var phi_2774_: type_53;
    var phi_2775_: u32;
    var phi_2776_: bool;
    var phi_2783_: type_53;
    var phi_2788_: type_53;
    var phi_2789_: bool;
    var phi_3177_: f32;
    var phi_3163_: bool;
    var phi_977_: type_4;
    var phi_978_: type_4;
    var phi_1001_: type_4;
    var phi_1043_: u32;
    var phi_1067_: type_47;
    var phi_3159_: bool;
    var phi_1078_: type_4;
    var phi_1079_: type_4;
    var phi_1102_: type_4;
    var phi_1112_: type_4;
    var phi_1113_: type_4;
    var phi_1136_: type_4;
    var phi_3154_: bool;
    var phi_3167_: bool;
    var phi_3166_: bool;
    var phi_1700_: vec3<f32>;
    var phi_1701_: vec3<f32>;
    var phi_1732_: bool;
    var phi_1741_: vec3<f32>;
    var phi_1781_: type_18;
    var phi_1783_: type_18;
    var phi_1784_: bool;
    var phi_1788_: type_18;
    var phi_1789_: type_18;
    var phi_1790_: type_18;
    var phi_1791_: bool;
    var phi_1795_: type_18;
    var phi_1796_: bool;
    var phi_1800_: type_18;
    var phi_1801_: bool;
    var phi_1805_: type_18;
    var phi_1817_: type_4;
    var phi_1820_: type_18;
    var phi_1818_: type_4;
    var phi_1843_: type_4;
    var phi_1875_: bool;
    var phi_1876_: bool;
    var phi_1897_: type_18;
    var phi_1821_: type_18;
    var phi_3182_: bool;
    var phi_3393_: f32;
    var phi_3392_: f32;
    var phi_3244_: bool;
    var phi_3391_: f32;
    var phi_3243_: bool;
    var phi_3390_: f32;
    var phi_3242_: bool;
    var phi_3330_: f32;
    var phi_3241_: bool;
    var phi_3295_: f32;
    var phi_3250_: bool;
    var phi_2791_: type_53;
    var phi_2792_: bool;
    var phi_2793_: u32;
    var phi_3294_: f32;
    var phi_3249_: bool;
    var phi_2794_: type_53;
    var phi_2795_: u32;
    var phi_2796_: bool;
    var phi_2797_: u32;
    var phi_3293_: f32;
    var phi_3248_: bool;
    var phi_2798_: type_53;
    var phi_2799_: u32;
    var phi_2800_: bool;
    var phi_2801_: u32;
    var phi_3292_: f32;
    var phi_3247_: bool;
    var phi_852_: type_53;
    var phi_855_: u32;
    var phi_857_: bool;
    var phi_859_: u32;
    var phi_2802_: bool;
    var phi_3246_: bool;
    var phi_2809_: type_4;
    var phi_2810_: type_4;
    var phi_2833_: type_4;
    var phi_2899_: type_18;
    var phi_3285_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e91 = global;
            let _e94 = arrayLength((&global_4.member));
            let _e105 = global_2.member[0u][0u];
            let _e109 = global_2.member[0u][1u];
            let _e113 = global_2.member[0u][2u];
            let _e117 = global_2.member[1u][0u];
            let _e121 = global_2.member[1u][1u];
            let _e125 = global_2.member[1u][2u];
            let _e129 = global_2.member[1u][3u];
            let _e132 = global_1.member[0u];
            let _e133 = bitcast<i32>(_e132);
            let _e143 = (_e91.x + (_e91.y * 2097152u));
            let _e144 = (_e143 < arrayLength((&global_3.member)));
            if _e144 {
                let _e145 = (_e143 < arrayLength((&global_5.member)));
                if _e145 {
                    if _e144 {
                    } else {
                        break;
                    }
                    let _e153 = global_3.member[_e143].member_2[0u];
                    let _e155 = (bitcast<u32>(_e153) & 2147483647u);
                    let _e160 = global_3.member[_e143].member_2[1u];
                    let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                    let _e167 = global_3.member[_e143].member_2[2u];
                    let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                    let _e174 = global_3.member[_e143].member[0u];
                    let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                    let _e181 = global_3.member[_e143].member[1u];
                    let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                    let _e188 = global_3.member[_e143].member[2u];
                    let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                    let _e192 = select(_e162, _e155, (_e162 < _e155));
                    let _e194 = select(_e169, _e192, (_e169 < _e192));
                    let _e196 = select(_e176, _e194, (_e176 < _e194));
                    let _e198 = select(_e183, _e196, (_e183 < _e196));
                    let _e200 = select(_e190, _e198, (_e190 < _e198));
                    let _e204 = global_3.member[_e143].member_1;
                    let _e206 = (bitcast<u32>(_e204) & 2147483647u);
                    let _e213 = global_3.member[_e143].member_3;
                    let _e219 = (((select(_e206, _e200, (_e206 < _e200)) < 2139095040u) && ((bitcast<u32>(_e213) & 2147483647u) <= 2139095040u)) && (_e194 > 0u));
                    if _e219 {
                        let _e222 = (bitcast<u32>(bitcast<f32>(_e194)) & 2147483647u);
                        if (_e222 >= 8388608u) {
                            phi_355_ = (bitcast<i32>((_e222 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_355_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e222)), 32u, (_e222 == 0u))));
                        }
                        let _e236 = phi_355_;
                        phi_356_ = _e236;
                    } else {
                        phi_356_ = 0i;
                    }
                    let _e238 = phi_356_;
                    let _e239 = (_e155 == _e194);
                    if _e239 {
                        phi_366_ = true;
                    } else {
                        phi_366_ = (_e162 == _e194);
                    }
                    let _e242 = phi_366_;
                    let _e243 = select(1u, 0u, _e239);
                    if _e242 {
                        let _e244 = (_e243 + 1u);
                        phi_376_ = _e244;
                        phi_377_ = _e244;
                        phi_379_ = select(true, false, (_e244 == 2u));
                    } else {
                        phi_376_ = u32();
                        phi_377_ = 0u;
                        phi_379_ = true;
                    }
                    let _e248 = phi_376_;
                    let _e250 = phi_377_;
                    let _e252 = phi_379_;
                    if _e252 {
                        phi_384_ = (_e250 + 1u);
                    } else {
                        phi_384_ = 0u;
                    }
                    let _e256 = phi_384_;
                    let _e257 = select(_e248, _e250, _e252);
                    let _e258 = select(_e243, select(2u, _e243, _e242), _e252);
                    if (_e133 < -126i) {
                        phi_397_ = -126i;
                    } else {
                        phi_397_ = select(_e133, 127i, (_e133 > 127i));
                    }
                    let _e263 = phi_397_;
                    let _e268 = bitcast<f32>((bitcast<u32>((_e263 + 127i)) << bitcast<u32>(23i)));
                    let _e274 = bitcast<f32>((bitcast<u32>(((_e133 - _e263) + 127i)) << bitcast<u32>(23i)));
                    let _e275 = -(_e238);
                    if (_e275 < -126i) {
                        phi_417_ = -126i;
                    } else {
                        phi_417_ = select(_e275, 127i, (_e275 > 127i));
                    }
                    let _e280 = phi_417_;
                    let _e285 = bitcast<f32>((bitcast<u32>((_e280 + 127i)) << bitcast<u32>(23i)));
                    let _e291 = bitcast<f32>((bitcast<u32>(((_e275 - _e280) + 127i)) << bitcast<u32>(23i)));
                    let _e295 = global_3.member[_e143].member;
                    let _e296 = (_e257 == 0u);
                    if _e296 {
                        phi_435_ = _e295[0];
                    } else {
                        phi_435_ = _e295[1];
                    }
                    let _e300 = phi_435_;
                    let _e301 = (_e257 == 2u);
                    if _e301 {
                        phi_441_ = _e295[2];
                    } else {
                        phi_441_ = _e300;
                    }
                    let _e304 = phi_441_;
                    let _e306 = ((_e304 * _e268) * _e274);
                    let _e307 = global_3.member[_e143].member_2;
                    if _e296 {
                        phi_452_ = _e307[0];
                    } else {
                        phi_452_ = _e307[1];
                    }
                    let _e311 = phi_452_;
                    if _e301 {
                        phi_458_ = _e307[2];
                    } else {
                        phi_458_ = _e311;
                    }
                    let _e314 = phi_458_;
                    let _e316 = ((_e314 * _e285) * _e291);
                    let _e320 = (bitcast<f32>((bitcast<u32>(_e316) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e320 {
                        let _e324 = (bitcast<f32>((bitcast<u32>(_e306) & 2147483647u)) * 0.00000011920929f);
                        phi_481_ = select(0.00000000000011368684f, _e324, (_e324 > 0.00000000000011368684f));
                    } else {
                        phi_481_ = 0f;
                    }
                    let _e328 = phi_481_;
                    let _e329 = (_e306 + _e328);
                    let _e330 = (_e306 - _e328);
                    let _e331 = select(_e316, 0f, _e320);
                    if _e320 {
                        phi_492_ = 38685626000000000000000000f;
                    } else {
                        phi_492_ = (1f / _e316);
                    }
                    let _e334 = phi_492_;
                    let _e335 = (_e256 == 0u);
                    if _e335 {
                        phi_501_ = _e295[0];
                    } else {
                        phi_501_ = _e295[1];
                    }
                    let _e339 = phi_501_;
                    let _e340 = (_e256 == 2u);
                    if _e340 {
                        phi_507_ = _e295[2];
                    } else {
                        phi_507_ = _e339;
                    }
                    let _e343 = phi_507_;
                    let _e345 = ((_e343 * _e268) * _e274);
                    if _e335 {
                        phi_518_ = _e307[0];
                    } else {
                        phi_518_ = _e307[1];
                    }
                    let _e349 = phi_518_;
                    if _e340 {
                        phi_524_ = _e307[2];
                    } else {
                        phi_524_ = _e349;
                    }
                    let _e352 = phi_524_;
                    let _e354 = ((_e352 * _e285) * _e291);
                    let _e358 = (bitcast<f32>((bitcast<u32>(_e354) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e358 {
                        let _e362 = (bitcast<f32>((bitcast<u32>(_e345) & 2147483647u)) * 0.00000011920929f);
                        phi_547_ = select(0.00000000000011368684f, _e362, (_e362 > 0.00000000000011368684f));
                    } else {
                        phi_547_ = 0f;
                    }
                    let _e366 = phi_547_;
                    let _e367 = (_e345 + _e366);
                    let _e368 = (_e345 - _e366);
                    let _e369 = select(_e354, 0f, _e358);
                    if _e358 {
                        phi_558_ = 38685626000000000000000000f;
                    } else {
                        phi_558_ = (1f / _e354);
                    }
                    let _e372 = phi_558_;
                    let _e373 = (_e258 == 0u);
                    if _e373 {
                        phi_567_ = _e295[0];
                    } else {
                        phi_567_ = _e295[1];
                    }
                    let _e377 = phi_567_;
                    let _e378 = (_e258 == 2u);
                    if _e378 {
                        phi_573_ = _e295[2];
                    } else {
                        phi_573_ = _e377;
                    }
                    let _e381 = phi_573_;
                    let _e383 = ((_e381 * _e268) * _e274);
                    if _e373 {
                        phi_584_ = _e307[0];
                    } else {
                        phi_584_ = _e307[1];
                    }
                    let _e387 = phi_584_;
                    if _e378 {
                        phi_590_ = _e307[2];
                    } else {
                        phi_590_ = _e387;
                    }
                    let _e390 = phi_590_;
                    let _e392 = ((_e390 * _e285) * _e291);
                    let _e396 = (bitcast<f32>((bitcast<u32>(_e392) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e396 {
                        let _e400 = (bitcast<f32>((bitcast<u32>(_e383) & 2147483647u)) * 0.00000011920929f);
                        phi_613_ = select(0.00000000000011368684f, _e400, (_e400 > 0.00000000000011368684f));
                    } else {
                        phi_613_ = 0f;
                    }
                    let _e404 = phi_613_;
                    let _e405 = (_e383 + _e404);
                    let _e406 = (_e383 - _e404);
                    let _e407 = select(_e392, 0f, _e396);
                    if _e396 {
                        phi_624_ = 38685626000000000000000000f;
                    } else {
                        phi_624_ = (1f / _e392);
                    }
                    let _e410 = phi_624_;
                    let _e413 = bitcast<f32>((bitcast<u32>(_e306) & 2147483647u));
                    let _e416 = bitcast<f32>((bitcast<u32>(_e345) & 2147483647u));
                    let _e418 = select(_e416, _e413, (_e413 > _e416));
                    let _e421 = bitcast<f32>((bitcast<u32>(_e383) & 2147483647u));
                    let _e424 = (_e133 + _e238);
                    if (_e219 && (select(_e421, _e418, (_e418 > _e421)) <= 1099511600000f)) {
                        let _e427 = (_e424 / 3i);
                        let _e434 = bitcast<f32>((bitcast<u32>((_e427 + 127i)) << bitcast<u32>(23i)));
                        let _e441 = bitcast<f32>((bitcast<u32>(((_e424 - (2i * _e427)) + 127i)) << bitcast<u32>(23i)));
                        let _e442 = (((_e204 * _e434) * _e434) * _e441);
                        let _e444 = select(340282350000000000000000000000000000000f, _e442, (_e442 < 340282350000000000000000000000000000000f));
                        let _e449 = (((_e213 * _e434) * _e434) * _e441);
                        let _e451 = select(340282350000000000000000000000000000000f, _e449, (_e449 < 340282350000000000000000000000000000000f));
                        phi_724_ = select(-340282350000000000000000000000000000000f, _e451, (_e451 > -340282350000000000000000000000000000000f));
                        phi_725_ = select(-340282350000000000000000000000000000000f, _e444, (_e444 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_724_ = 0f;
                        phi_725_ = 1f;
                    }
                    let _e455 = phi_724_;
                    let _e457 = phi_725_;
                    local_11 = array<type_18, 8>(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_12 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_23 = array<f32, 3>(bitcast<f32>(_e105), bitcast<f32>(_e109), bitcast<f32>(_e113));
                    let _e461 = (_e257 % 3u);
                    let _e462 = (_e461 < 3u);
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e464 = local_23[_e461];
                    let _e465 = (_e256 % 3u);
                    let _e466 = (_e465 < 3u);
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e468 = local_23[_e465];
                    let _e469 = (_e258 % 3u);
                    let _e470 = (_e469 < 3u);
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e472 = local_23[_e469];
                    local_22 = array<f32, 3>(bitcast<f32>(_e117), bitcast<f32>(_e121), bitcast<f32>(_e125));
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e476 = local_22[_e461];
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e478 = local_22[_e465];
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e480 = local_22[_e469];
                    phi_3075_ = false;
                    phi_3066_ = _e455;
                    phi_851_ = type_53(type_45(array<f32, 3>(_e464, _e468, _e472), array<f32, 3>(_e476, _e478, _e480)), select(0u, 2147483648u, (_e94 == 0u)));
                    phi_854_ = ((3u * _e94) + 1u);
                    phi_856_ = (_e457 <= _e455);
                    phi_858_ = 0u;
                    loop {
                        let _e488 = phi_3075_;
                        let _e490 = phi_3066_;
                        let _e492 = phi_851_;
                        let _e494 = phi_854_;
                        let _e496 = phi_856_;
                        let _e498 = phi_858_;
                        if _e496 {
                            phi_869_ = true;
                        } else {
                            phi_869_ = (_e498 > 0u);
                        }
                        let _e501 = phi_869_;
                        if _e501 {
                            let _e502 = (_e494 > 0u);
                            if _e502 {
                                if _e496 {
                                    phi_956_ = _e492;
                                    phi_957_ = _e496;
                                    phi_958_ = _e498;
                                } else {
                                    let _e503 = (_e498 - 1u);
                                    let _e504 = (_e503 % 128u);
                                    let _e505 = (_e504 < 128u);
                                    if _e505 {
                                    } else {
                                        phi_3246_ = true;
                                        break;
                                    }
                                    let _e507 = local_6[_e504];
                                    if _e505 {
                                    } else {
                                        phi_3246_ = true;
                                        break;
                                    }
                                    let _e509 = local_5[_e504];
                                    if _e505 {
                                    } else {
                                        phi_3246_ = true;
                                        break;
                                    }
                                    let _e511 = local_4[_e504];
                                    if _e505 {
                                    } else {
                                        phi_3246_ = true;
                                        break;
                                    }
                                    let _e513 = local_3[_e504];
                                    if _e505 {
                                    } else {
                                        phi_3246_ = true;
                                        break;
                                    }
                                    let _e516 = local_2[_e504];
                                    if _e505 {
                                    } else {
                                        phi_3246_ = true;
                                        break;
                                    }
                                    let _e518 = local_1[_e504];
                                    if _e505 {
                                    } else {
                                        phi_3246_ = true;
                                        break;
                                    }
                                    let _e520 = local[_e504];
                                    if _e505 {
                                    } else {
                                        phi_3246_ = true;
                                        break;
                                    }
                                    let _e525 = local_12[_e504];
                                    phi_956_ = type_53(type_45(array<f32, 3>(_e509, _e511, _e513), array<f32, 3>(_e516, _e518, _e520)), _e507);
                                    phi_957_ = (_e525 <= _e490);
                                    phi_958_ = _e503;
                                }
                                let _e528 = phi_956_;
                                let _e530 = phi_957_;
                                let _e532 = phi_958_;
                                if _e530 {
                                    if ((_e528.member_1 & 2147483648u) != 0u) {
                                        phi_3177_ = _e490;
                                        phi_3163_ = _e488;
                                        phi_977_ = type_4(0u, ((_e528.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e856 = phi_3177_;
                                            let _e858 = phi_3163_;
                                            let _e860 = phi_977_;
                                            if (_e860.member < _e860.member_1) {
                                                phi_978_ = type_4((_e860.member + 1u), _e860.member_1);
                                                phi_1001_ = type_4(1u, _e860.member);
                                            } else {
                                                phi_978_ = _e860;
                                                phi_1001_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e873 = phi_978_;
                                            let _e875 = phi_1001_;
                                            let _e879 = (bitcast<i32>(_e875.member) != 0i);
                                            if _e879 {
                                                local_8 = array<f32, 3>(_e528.member.member[0], _e528.member.member[1], _e528.member.member[2]);
                                                local_7 = array<f32, 3>(_e528.member.member_1[0], _e528.member.member_1[1], _e528.member.member_1[2]);
                                                let _e890 = ((_e528.member_1 & 268435455u) + _e875.member_1);
                                                let _e891 = (_e890 < arrayLength((&global_6.member)));
                                                if _e891 {
                                                    if _e891 {
                                                    } else {
                                                        phi_3330_ = _e856;
                                                        phi_3241_ = true;
                                                        break;
                                                    }
                                                    let _e894 = global_6.member[_e890].member_1;
                                                    phi_1043_ = _e894;
                                                } else {
                                                    phi_1043_ = 4294967295u;
                                                }
                                                let _e896 = phi_1043_;
                                                local_19 = array<u32, 3>(_e257, _e256, _e258);
                                                if _e891 {
                                                    if _e891 {
                                                    } else {
                                                        phi_3330_ = _e856;
                                                        phi_3241_ = true;
                                                        break;
                                                    }
                                                    let _e899 = global_6.member[_e890];
                                                    phi_1067_ = _e899;
                                                } else {
                                                    phi_1067_ = type_47(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e901 = phi_1067_;
                                                local_21 = array<u32, 3>(_e901.member[0], _e901.member[1], _e901.member[2]);
                                                local_20[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_20[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_20[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_3159_ = _e858;
                                                phi_1078_ = type_4(0u, 3u);
                                                loop {
                                                    let _e911 = phi_3159_;
                                                    let _e913 = phi_1078_;
                                                    if (_e913.member < _e913.member_1) {
                                                        phi_1079_ = type_4((_e913.member + 1u), _e913.member_1);
                                                        phi_1102_ = type_4(1u, _e913.member);
                                                    } else {
                                                        phi_1079_ = _e913;
                                                        phi_1102_ = type_4(0u, type_4().member_1);
                                                    }
                                                    let _e926 = phi_1079_;
                                                    let _e928 = phi_1102_;
                                                    let _e932 = (bitcast<i32>(_e928.member) != 0i);
                                                    if _e932 {
                                                        phi_1112_ = type_4(0u, 3u);
                                                        loop {
                                                            let _e934 = phi_1112_;
                                                            if (_e934.member < _e934.member_1) {
                                                                phi_1113_ = type_4((_e934.member + 1u), _e934.member_1);
                                                                phi_1136_ = type_4(1u, _e934.member);
                                                            } else {
                                                                phi_1113_ = _e934;
                                                                phi_1136_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e947 = phi_1113_;
                                                            let _e949 = phi_1136_;
                                                            let _e953 = (bitcast<i32>(_e949.member) != 0i);
                                                            if _e953 {
                                                                let _e954 = (_e928.member_1 < 3u);
                                                                if _e954 {
                                                                } else {
                                                                    phi_3154_ = true;
                                                                    break;
                                                                }
                                                                let _e956 = local_21[_e928.member_1];
                                                                let _e957 = (_e949.member_1 < 3u);
                                                                if _e957 {
                                                                } else {
                                                                    phi_3154_ = true;
                                                                    break;
                                                                }
                                                                let _e959 = local_19[_e949.member_1];
                                                                let _e964 = ((_e956 >> bitcast<u32>(((10u * _e959) & 31u))) & 1023u);
                                                                if _e957 {
                                                                } else {
                                                                    phi_3154_ = true;
                                                                    break;
                                                                }
                                                                let _e966 = local_8[_e949.member_1];
                                                                if _e957 {
                                                                } else {
                                                                    phi_3154_ = true;
                                                                    break;
                                                                }
                                                                let _e968 = local_7[_e949.member_1];
                                                                let _e979 = (_e966 + bitcast<f32>((bitcast<u32>((f32(_e964) * bitcast<f32>((bitcast<u32>(((_e968 - _e966) * 0.0009775171f)) ^ _e129)))) ^ _e129)));
                                                                if _e954 {
                                                                } else {
                                                                    phi_3154_ = true;
                                                                    break;
                                                                }
                                                                if _e957 {
                                                                } else {
                                                                    phi_3154_ = true;
                                                                    break;
                                                                }
                                                                local_20[_e928.member_1][_e949.member_1] = select(select(_e968, _e979, (_e979 < _e968)), _e968, (_e964 == 1023u));
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1112_ = _e947;
                                                                phi_3154_ = _e911;
                                                                break if !(_e953);
                                                            }
                                                        }
                                                        let _e988 = phi_3154_;
                                                        phi_3166_ = _e988;
                                                        if _e988 {
                                                            break;
                                                        }
                                                        phi_3167_ = _e988;
                                                    } else {
                                                        phi_3167_ = _e911;
                                                    }
                                                    let _e990 = phi_3167_;
                                                    continue;
                                                    continuing {
                                                        phi_3159_ = _e990;
                                                        phi_1078_ = _e926;
                                                        phi_3166_ = _e990;
                                                        break if !(_e932);
                                                    }
                                                }
                                                let _e993 = phi_3166_;
                                                phi_3330_ = _e856;
                                                phi_3241_ = _e993;
                                                if _e993 {
                                                    break;
                                                }
                                                let _e994 = local_20;
                                                let _e1009 = (_e994[0][2] - _e383);
                                                let _e1012 = (((_e994[0][0] - _e306) * _e407) - (_e1009 * _e331));
                                                let _e1015 = (((_e994[0][1] - _e345) * _e407) - (_e1009 * _e369));
                                                let _e1018 = (_e994[1][2] - _e383);
                                                let _e1021 = (((_e994[1][0] - _e306) * _e407) - (_e1018 * _e331));
                                                let _e1024 = (((_e994[1][1] - _e345) * _e407) - (_e1018 * _e369));
                                                let _e1027 = (_e994[2][2] - _e383);
                                                let _e1030 = (((_e994[2][0] - _e306) * _e407) - (_e1027 * _e331));
                                                let _e1033 = (((_e994[2][1] - _e345) * _e407) - (_e1027 * _e369));
                                                let _e1034 = (_e1030 * _e1024);
                                                let _e1035 = (_e1033 * _e1021);
                                                let _e1036 = (_e1012 * _e1033);
                                                let _e1037 = (_e1015 * _e1030);
                                                let _e1038 = (_e1021 * _e1015);
                                                let _e1039 = (_e1024 * _e1012);
                                                let _e1044 = (((_e1034 >= _e1035) && (_e1036 >= _e1037)) && (_e1038 >= _e1039));
                                                if (_e1044 || (((_e1034 <= _e1035) && (_e1036 <= _e1037)) && (_e1038 <= _e1039))) {
                                                    let _e1051 = select(-1f, 1f, _e1044);
                                                    let _e1053 = ((_e1034 - _e1035) * _e1051);
                                                    let _e1055 = select(0f, _e1053, (_e1053 > 0f));
                                                    let _e1057 = ((_e1036 - _e1037) * _e1051);
                                                    let _e1059 = select(0f, _e1057, (_e1057 > 0f));
                                                    let _e1061 = ((_e1038 - _e1039) * _e1051);
                                                    let _e1063 = select(0f, _e1061, (_e1061 > 0f));
                                                    let _e1065 = ((_e1055 + _e1059) + _e1063);
                                                    if (_e1065 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1795_ = type_18();
                                                        phi_1796_ = true;
                                                    } else {
                                                        let _e1068 = select(_e994[1][0], _e994[0][0], (_e994[0][0] < _e994[1][0]));
                                                        let _e1072 = select(_e994[1][0], _e994[0][0], (_e994[0][0] > _e994[1][0]));
                                                        let _e1076 = select(_e994[1][1], _e994[0][1], (_e994[0][1] < _e994[1][1]));
                                                        let _e1080 = select(_e994[1][1], _e994[0][1], (_e994[0][1] > _e994[1][1]));
                                                        let _e1084 = select(_e994[1][2], _e994[0][2], (_e994[0][2] < _e994[1][2]));
                                                        let _e1088 = select(_e994[1][2], _e994[0][2], (_e994[0][2] > _e994[1][2]));
                                                        let _e1093 = ((select(_e994[2][0], _e1068, (_e1068 < _e994[2][0])) - _e329) * _e334);
                                                        let _e1094 = ((select(_e994[2][0], _e1072, (_e1072 > _e994[2][0])) - _e330) * _e334);
                                                        let _e1097 = ((select(_e994[2][1], _e1076, (_e1076 < _e994[2][1])) - _e367) * _e372);
                                                        let _e1098 = ((select(_e994[2][1], _e1080, (_e1080 > _e994[2][1])) - _e368) * _e372);
                                                        let _e1101 = ((select(_e994[2][2], _e1084, (_e1084 < _e994[2][2])) - _e405) * _e410);
                                                        let _e1102 = ((select(_e994[2][2], _e1088, (_e1088 > _e994[2][2])) - _e406) * _e410);
                                                        let _e1104 = select(_e1102, _e1101, (_e1101 < _e1102));
                                                        let _e1106 = select(_e1102, _e1101, (_e1101 > _e1102));
                                                        let _e1108 = select(_e1094, _e1093, (_e1093 < _e1094));
                                                        let _e1110 = select(_e1098, _e1097, (_e1097 < _e1098));
                                                        let _e1112 = select(_e1110, _e1108, (_e1108 > _e1110));
                                                        let _e1114 = select(_e1104, _e1112, (_e1112 > _e1104));
                                                        let _e1116 = select(_e1094, _e1093, (_e1093 > _e1094));
                                                        let _e1118 = select(_e1098, _e1097, (_e1097 > _e1098));
                                                        let _e1120 = select(_e1118, _e1116, (_e1116 < _e1118));
                                                        let _e1122 = select(_e1106, _e1120, (_e1120 < _e1106));
                                                        let _e1123 = -(_e1104);
                                                        let _e1129 = select(_e457, _e1114, (_e1114 > _e457));
                                                        if (_e1129 > (_e1122 + (select(_e1123, _e1106, (_e1106 > _e1123)) * 0.0000019073523f))) {
                                                            phi_1790_ = type_18();
                                                            phi_1791_ = true;
                                                        } else {
                                                            let _e1131 = (_e1129 > _e856);
                                                            if _e1131 {
                                                                phi_1789_ = type_18();
                                                            } else {
                                                                let _e1135 = (_e994[1][0] - _e994[0][0]);
                                                                let _e1136 = (_e994[1][1] - _e994[0][1]);
                                                                let _e1137 = (_e994[1][2] - _e994[0][2]);
                                                                let _e1138 = vec3<f32>(_e1135, _e1136, _e1137);
                                                                let _e1139 = (_e994[2][0] - _e994[1][0]);
                                                                let _e1140 = (_e994[2][1] - _e994[1][1]);
                                                                let _e1141 = (_e994[2][2] - _e994[1][2]);
                                                                let _e1142 = vec3<f32>(_e1139, _e1140, _e1141);
                                                                let _e1143 = (_e994[0][0] - _e994[2][0]);
                                                                let _e1144 = (_e994[0][1] - _e994[2][1]);
                                                                let _e1145 = (_e994[0][2] - _e994[2][2]);
                                                                let _e1146 = vec3<f32>(_e1143, _e1144, _e1145);
                                                                let _e1149 = bitcast<f32>((bitcast<u32>(_e1135) & 2147483647u));
                                                                let _e1152 = bitcast<f32>((bitcast<u32>(_e1136) & 2147483647u));
                                                                let _e1154 = select(_e1152, _e1149, (_e1149 > _e1152));
                                                                let _e1157 = bitcast<f32>((bitcast<u32>(_e1137) & 2147483647u));
                                                                let _e1159 = select(_e1157, _e1154, (_e1154 > _e1157));
                                                                let _e1162 = bitcast<f32>((bitcast<u32>(_e1139) & 2147483647u));
                                                                let _e1165 = bitcast<f32>((bitcast<u32>(_e1140) & 2147483647u));
                                                                let _e1167 = select(_e1165, _e1162, (_e1162 > _e1165));
                                                                let _e1170 = bitcast<f32>((bitcast<u32>(_e1141) & 2147483647u));
                                                                let _e1172 = select(_e1170, _e1167, (_e1167 > _e1170));
                                                                let _e1175 = bitcast<f32>((bitcast<u32>(_e1143) & 2147483647u));
                                                                let _e1178 = bitcast<f32>((bitcast<u32>(_e1144) & 2147483647u));
                                                                let _e1180 = select(_e1178, _e1175, (_e1175 > _e1178));
                                                                let _e1183 = bitcast<f32>((bitcast<u32>(_e1145) & 2147483647u));
                                                                let _e1185 = select(_e1183, _e1180, (_e1180 > _e1183));
                                                                let _e1187 = select(_e1172, _e1159, (_e1159 > _e1172));
                                                                let _e1189 = select(_e1185, _e1187, (_e1187 > _e1185));
                                                                if (_e1159 == _e1189) {
                                                                    phi_1700_ = _e1142;
                                                                    phi_1701_ = _e1146;
                                                                } else {
                                                                    let _e1192 = vec3((_e1172 == _e1189));
                                                                    phi_1700_ = select(_e1138, _e1146, _e1192);
                                                                    phi_1701_ = select(_e1142, _e1138, _e1192);
                                                                }
                                                                let _e1196 = phi_1700_;
                                                                let _e1198 = phi_1701_;
                                                                let _e1205 = ((_e1196.y * _e1198.z) - (_e1198.y * _e1196.z));
                                                                let _e1210 = ((_e1196.z * _e1198.x) - (_e1198.z * _e1196.x));
                                                                let _e1213 = ((_e1196.x * _e1198.y) - (_e1198.x * _e1196.y));
                                                                if (_e1055 >= _e1059) {
                                                                    phi_1732_ = select(true, false, (_e1055 >= _e1063));
                                                                } else {
                                                                    phi_1732_ = true;
                                                                }
                                                                let _e1218 = phi_1732_;
                                                                if _e1218 {
                                                                    phi_1741_ = select(vec3<f32>(_e994[2][0], _e994[2][1], _e994[2][2]), vec3<f32>(_e994[1][0], _e994[1][1], _e994[1][2]), vec3((_e1059 >= _e1063)));
                                                                } else {
                                                                    phi_1741_ = vec3<f32>(_e994[0][0], _e994[0][1], _e994[0][2]);
                                                                }
                                                                let _e1223 = phi_1741_;
                                                                let _e1240 = ((((_e1205 * (_e1223.x - _e306)) + (_e1210 * (_e1223.y - _e345))) + (_e1213 * (_e1223.z - _e383))) / (((_e1205 * _e331) + (_e1210 * _e369)) + (_e1213 * _e407)));
                                                                let _e1242 = select(_e1122, _e1240, (_e1240 < _e1122));
                                                                let _e1244 = select(_e1114, _e1242, (_e1242 > _e1114));
                                                                if (_e1244 >= _e457) {
                                                                    let _e1246 = (_e1244 <= _e856);
                                                                    if _e1246 {
                                                                        let _e1247 = (1f / _e1065);
                                                                        phi_1781_ = type_18(_e1244, (_e1059 * _e1247), (_e1063 * _e1247), _e896);
                                                                    } else {
                                                                        phi_1781_ = type_18();
                                                                    }
                                                                    let _e1252 = phi_1781_;
                                                                    phi_1783_ = _e1252;
                                                                    phi_1784_ = select(true, false, _e1246);
                                                                } else {
                                                                    phi_1783_ = type_18();
                                                                    phi_1784_ = true;
                                                                }
                                                                let _e1255 = phi_1783_;
                                                                let _e1257 = phi_1784_;
                                                                if _e1257 {
                                                                    phi_1788_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1788_ = _e1255;
                                                                }
                                                                let _e1259 = phi_1788_;
                                                                phi_1789_ = _e1259;
                                                            }
                                                            let _e1261 = phi_1789_;
                                                            phi_1790_ = _e1261;
                                                            phi_1791_ = _e1131;
                                                        }
                                                        let _e1263 = phi_1790_;
                                                        let _e1265 = phi_1791_;
                                                        phi_1795_ = _e1263;
                                                        phi_1796_ = _e1265;
                                                    }
                                                    let _e1267 = phi_1795_;
                                                    let _e1269 = phi_1796_;
                                                    phi_1800_ = _e1267;
                                                    phi_1801_ = _e1269;
                                                } else {
                                                    phi_1800_ = type_18();
                                                    phi_1801_ = true;
                                                }
                                                let _e1271 = phi_1800_;
                                                let _e1273 = phi_1801_;
                                                if _e1273 {
                                                    phi_1805_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1805_ = _e1271;
                                                }
                                                let _e1275 = phi_1805_;
                                                if (_e1275.member_3 != 4294967295u) {
                                                    if (_e896 != 4294967295u) {
                                                        phi_1817_ = type_4(0u, 8u);
                                                        phi_1820_ = _e1275;
                                                        loop {
                                                            let _e1280 = phi_1817_;
                                                            let _e1282 = phi_1820_;
                                                            if (_e1280.member < _e1280.member_1) {
                                                                phi_1818_ = type_4((_e1280.member + 1u), _e1280.member_1);
                                                                phi_1843_ = type_4(1u, _e1280.member);
                                                            } else {
                                                                phi_1818_ = _e1280;
                                                                phi_1843_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1295 = phi_1818_;
                                                            let _e1297 = phi_1843_;
                                                            let _e1301 = (bitcast<i32>(_e1297.member) != 0i);
                                                            if _e1301 {
                                                                let _e1302 = (_e1297.member_1 < 8u);
                                                                if _e1302 {
                                                                } else {
                                                                    phi_3182_ = true;
                                                                    break;
                                                                }
                                                                let _e1307 = local_11[_e1297.member_1].member;
                                                                if (_e1282.member < _e1307) {
                                                                    phi_1876_ = true;
                                                                } else {
                                                                    let _e1309 = local_11[_e1297.member_1].member;
                                                                    if (_e1282.member == _e1309) {
                                                                        let _e1314 = local_11[_e1297.member_1].member_3;
                                                                        phi_1875_ = (_e1282.member_3 < _e1314);
                                                                    } else {
                                                                        phi_1875_ = false;
                                                                    }
                                                                    let _e1317 = phi_1875_;
                                                                    phi_1876_ = _e1317;
                                                                }
                                                                let _e1319 = phi_1876_;
                                                                if _e1319 {
                                                                    if _e1302 {
                                                                    } else {
                                                                        phi_3182_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1320 = local_11[_e1297.member_1];
                                                                    local_11[_e1297.member_1] = type_18(_e1282.member, _e1282.member_1, _e1282.member_2, _e1282.member_3);
                                                                    phi_1897_ = type_18(_e1320.member, _e1320.member_1, _e1320.member_2, _e1320.member_3);
                                                                } else {
                                                                    phi_1897_ = _e1282;
                                                                }
                                                                let _e1331 = phi_1897_;
                                                                phi_1821_ = _e1331;
                                                            } else {
                                                                phi_1821_ = type_18();
                                                            }
                                                            let _e1333 = phi_1821_;
                                                            continue;
                                                            continuing {
                                                                phi_1817_ = _e1295;
                                                                phi_1820_ = _e1333;
                                                                phi_3182_ = _e993;
                                                                break if !(_e1301);
                                                            }
                                                        }
                                                        let _e1336 = phi_3182_;
                                                        phi_3330_ = _e856;
                                                        phi_3241_ = _e1336;
                                                        if _e1336 {
                                                            break;
                                                        }
                                                        let _e1339 = local_11[7u].member_3;
                                                        if (_e1339 != 4294967295u) {
                                                            let _e1343 = local_11[7u].member;
                                                            phi_3393_ = _e1343;
                                                        } else {
                                                            phi_3393_ = _e856;
                                                        }
                                                        let _e1345 = phi_3393_;
                                                        phi_3392_ = _e1345;
                                                        phi_3244_ = _e1336;
                                                    } else {
                                                        phi_3392_ = _e856;
                                                        phi_3244_ = _e993;
                                                    }
                                                    let _e1347 = phi_3392_;
                                                    let _e1349 = phi_3244_;
                                                    phi_3391_ = _e1347;
                                                    phi_3243_ = _e1349;
                                                } else {
                                                    phi_3391_ = _e856;
                                                    phi_3243_ = _e993;
                                                }
                                                let _e1351 = phi_3391_;
                                                let _e1353 = phi_3243_;
                                                phi_3390_ = _e1351;
                                                phi_3242_ = _e1353;
                                            } else {
                                                phi_3390_ = _e856;
                                                phi_3242_ = _e858;
                                            }
                                            let _e1355 = phi_3390_;
                                            let _e1357 = phi_3242_;
                                            continue;
                                            continuing {
                                                phi_3177_ = _e1355;
                                                phi_3163_ = _e1357;
                                                phi_977_ = _e873;
                                                phi_3330_ = _e1355;
                                                phi_3241_ = _e1357;
                                                break if !(_e879);
                                            }
                                        }
                                        let _e1360 = phi_3330_;
                                        let _e1362 = phi_3241_;
                                        phi_3246_ = _e1362;
                                        if _e1362 {
                                            break;
                                        }
                                        phi_3295_ = _e1360;
                                        phi_3250_ = _e1362;
                                        phi_2791_ = _e528;
                                        phi_2792_ = false;
                                        phi_2793_ = _e532;
                                    } else {
                                        local_10 = array<f32, 3>(_e528.member.member[0], _e528.member.member[1], _e528.member.member[2]);
                                        local_9 = array<f32, 3>(_e528.member.member_1[0], _e528.member.member_1[1], _e528.member.member_1[2]);
                                        let _e552 = (_e528.member_1 < _e94);
                                        if _e552 {
                                            if _e552 {
                                            } else {
                                                phi_3246_ = true;
                                                break;
                                            }
                                            let _e554 = global_4.member[_e528.member_1];
                                            phi_1942_ = _e554;
                                        } else {
                                            phi_1942_ = type_39(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e556 = phi_1942_;
                                        let _e558 = array<u32, 3>(_e257, _e256, _e258);
                                        local_18 = _e558;
                                        local_14 = array<f32, 3>(0f, 0f, 0f);
                                        local_13 = array<f32, 3>(0f, 0f, 0f);
                                        phi_1951_ = type_4(0u, 3u);
                                        loop {
                                            let _e560 = phi_1951_;
                                            if (_e560.member < _e560.member_1) {
                                                phi_1952_ = type_4((_e560.member + 1u), _e560.member_1);
                                                phi_1975_ = type_4(1u, _e560.member);
                                            } else {
                                                phi_1952_ = _e560;
                                                phi_1975_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e573 = phi_1952_;
                                            let _e575 = phi_1975_;
                                            let _e579 = (bitcast<i32>(_e575.member) != 0i);
                                            if _e579 {
                                                let _e580 = (_e575.member_1 < 3u);
                                                if _e580 {
                                                } else {
                                                    phi_3068_ = true;
                                                    break;
                                                }
                                                let _e582 = local_18[_e575.member_1];
                                                if _e580 {
                                                } else {
                                                    phi_3068_ = true;
                                                    break;
                                                }
                                                let _e584 = local_10[_e575.member_1];
                                                if _e580 {
                                                } else {
                                                    phi_3068_ = true;
                                                    break;
                                                }
                                                let _e586 = local_9[_e575.member_1];
                                                let _e589 = ((10u * _e582) & 31u);
                                                let _e592 = ((_e556.member[0] >> bitcast<u32>(_e589)) & 1023u);
                                                let _e597 = bitcast<f32>((bitcast<u32>(((_e586 - _e584) * 0.0009775171f)) ^ _e129));
                                                let _e603 = (_e584 + bitcast<f32>((bitcast<u32>((f32(_e592) * _e597)) ^ _e129)));
                                                if _e580 {
                                                } else {
                                                    phi_3068_ = true;
                                                    break;
                                                }
                                                local_14[_e575.member_1] = select(select(_e586, _e603, (_e603 < _e586)), _e586, (_e592 == 1023u));
                                                let _e612 = ((_e556.member[1] >> bitcast<u32>(_e589)) & 1023u);
                                                let _e618 = (_e584 + bitcast<f32>((bitcast<u32>((f32(_e612) * _e597)) ^ _e129)));
                                                if _e580 {
                                                } else {
                                                    phi_3068_ = true;
                                                    break;
                                                }
                                                local_13[_e575.member_1] = select(select(_e586, _e618, (_e618 < _e586)), _e586, (_e612 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_1951_ = _e573;
                                                phi_3068_ = _e488;
                                                break if !(_e579);
                                            }
                                        }
                                        let _e626 = phi_3068_;
                                        phi_3246_ = _e626;
                                        if _e626 {
                                            break;
                                        }
                                        let _e627 = local_13;
                                        let _e628 = local_14;
                                        local_17 = _e558;
                                        local_16 = array<f32, 3>(0f, 0f, 0f);
                                        local_15 = array<f32, 3>(0f, 0f, 0f);
                                        phi_2105_ = type_4(0u, 3u);
                                        loop {
                                            let _e637 = phi_2105_;
                                            if (_e637.member < _e637.member_1) {
                                                phi_2106_ = type_4((_e637.member + 1u), _e637.member_1);
                                                phi_2129_ = type_4(1u, _e637.member);
                                            } else {
                                                phi_2106_ = _e637;
                                                phi_2129_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e650 = phi_2106_;
                                            let _e652 = phi_2129_;
                                            let _e656 = (bitcast<i32>(_e652.member) != 0i);
                                            if _e656 {
                                                let _e657 = (_e652.member_1 < 3u);
                                                if _e657 {
                                                } else {
                                                    phi_3128_ = true;
                                                    break;
                                                }
                                                let _e659 = local_17[_e652.member_1];
                                                if _e657 {
                                                } else {
                                                    phi_3128_ = true;
                                                    break;
                                                }
                                                let _e661 = local_10[_e652.member_1];
                                                if _e657 {
                                                } else {
                                                    phi_3128_ = true;
                                                    break;
                                                }
                                                let _e663 = local_9[_e652.member_1];
                                                let _e666 = ((10u * _e659) & 31u);
                                                let _e669 = ((_e556.member_1[0] >> bitcast<u32>(_e666)) & 1023u);
                                                let _e674 = bitcast<f32>((bitcast<u32>(((_e663 - _e661) * 0.0009775171f)) ^ _e129));
                                                let _e680 = (_e661 + bitcast<f32>((bitcast<u32>((f32(_e669) * _e674)) ^ _e129)));
                                                if _e657 {
                                                } else {
                                                    phi_3128_ = true;
                                                    break;
                                                }
                                                local_16[_e652.member_1] = select(select(_e663, _e680, (_e680 < _e663)), _e663, (_e669 == 1023u));
                                                let _e689 = ((_e556.member_1[1] >> bitcast<u32>(_e666)) & 1023u);
                                                let _e695 = (_e661 + bitcast<f32>((bitcast<u32>((f32(_e689) * _e674)) ^ _e129)));
                                                if _e657 {
                                                } else {
                                                    phi_3128_ = true;
                                                    break;
                                                }
                                                local_15[_e652.member_1] = select(select(_e663, _e695, (_e695 < _e663)), _e663, (_e689 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_2105_ = _e650;
                                                phi_3128_ = _e626;
                                                break if !(_e656);
                                            }
                                        }
                                        let _e703 = phi_3128_;
                                        phi_3246_ = _e703;
                                        if _e703 {
                                            break;
                                        }
                                        let _e704 = local_15;
                                        let _e705 = local_16;
                                        let _e716 = type_53(type_45(array<f32, 3>(_e628[0], _e628[1], _e628[2]), array<f32, 3>(_e627[0], _e627[1], _e627[2])), _e556.member_2);
                                        let _e721 = type_53(type_45(array<f32, 3>(_e705[0], _e705[1], _e705[2]), array<f32, 3>(_e704[0], _e704[1], _e704[2])), _e556.member_3);
                                        let _e726 = ((_e628[0] - _e329) * _e334);
                                        let _e727 = ((_e705[0] - _e329) * _e334);
                                        let _e728 = ((_e627[0] - _e330) * _e334);
                                        let _e729 = ((_e704[0] - _e330) * _e334);
                                        let _e734 = ((_e628[1] - _e367) * _e372);
                                        let _e735 = ((_e705[1] - _e367) * _e372);
                                        let _e736 = ((_e627[1] - _e368) * _e372);
                                        let _e737 = ((_e704[1] - _e368) * _e372);
                                        let _e742 = ((_e628[2] - _e405) * _e410);
                                        let _e743 = ((_e705[2] - _e405) * _e410);
                                        let _e744 = ((_e627[2] - _e406) * _e410);
                                        let _e745 = ((_e704[2] - _e406) * _e410);
                                        let _e747 = select(_e744, _e742, (_e742 < _e744));
                                        let _e749 = select(_e745, _e743, (_e743 < _e745));
                                        let _e751 = select(_e744, _e742, (_e742 > _e744));
                                        let _e753 = select(_e745, _e743, (_e743 > _e745));
                                        let _e755 = select(_e728, _e726, (_e726 < _e728));
                                        let _e757 = select(_e729, _e727, (_e727 < _e729));
                                        let _e759 = select(_e736, _e734, (_e734 < _e736));
                                        let _e761 = select(_e737, _e735, (_e735 < _e737));
                                        let _e763 = select(_e759, _e755, (_e755 > _e759));
                                        let _e765 = select(_e761, _e757, (_e757 > _e761));
                                        let _e767 = select(_e747, _e763, (_e763 > _e747));
                                        let _e769 = select(_e749, _e765, (_e765 > _e749));
                                        let _e771 = select(_e728, _e726, (_e726 > _e728));
                                        let _e773 = select(_e729, _e727, (_e727 > _e729));
                                        let _e775 = select(_e736, _e734, (_e734 > _e736));
                                        let _e777 = select(_e737, _e735, (_e735 > _e737));
                                        let _e779 = select(_e775, _e771, (_e771 < _e775));
                                        let _e781 = select(_e777, _e773, (_e773 < _e777));
                                        let _e786 = -(_e747);
                                        let _e787 = -(_e749);
                                        let _e794 = (select(_e751, _e779, (_e779 < _e751)) + (select(_e786, _e751, (_e751 > _e786)) * 0.0000019073523f));
                                        let _e795 = (select(_e753, _e781, (_e781 < _e753)) + (select(_e787, _e753, (_e753 > _e787)) * 0.0000019073523f));
                                        let _e797 = select(_e457, _e767, (_e767 > _e457));
                                        let _e799 = select(_e457, _e769, (_e769 > _e457));
                                        let _e804 = (_e797 <= select(_e490, _e794, (_e794 < _e490)));
                                        let _e805 = (_e799 <= select(_e490, _e795, (_e795 < _e490)));
                                        let _e806 = (_e797 <= _e799);
                                        if _e804 {
                                            if _e805 {
                                                if _e806 {
                                                    phi_2693_ = _e721;
                                                } else {
                                                    phi_2693_ = _e716;
                                                }
                                                let _e808 = phi_2693_;
                                                let _e816 = (_e532 % 128u);
                                                let _e817 = (_e816 < 128u);
                                                if _e817 {
                                                } else {
                                                    phi_3246_ = true;
                                                    break;
                                                }
                                                local_6[_e816] = _e808.member_1;
                                                if _e817 {
                                                } else {
                                                    phi_3246_ = true;
                                                    break;
                                                }
                                                local_5[_e816] = _e808.member.member[0];
                                                if _e817 {
                                                } else {
                                                    phi_3246_ = true;
                                                    break;
                                                }
                                                local_4[_e816] = _e808.member.member[1];
                                                if _e817 {
                                                } else {
                                                    phi_3246_ = true;
                                                    break;
                                                }
                                                local_3[_e816] = _e808.member.member[2];
                                                if _e817 {
                                                } else {
                                                    phi_3246_ = true;
                                                    break;
                                                }
                                                local_2[_e816] = _e808.member.member_1[0];
                                                if _e817 {
                                                } else {
                                                    phi_3246_ = true;
                                                    break;
                                                }
                                                local_1[_e816] = _e808.member.member_1[1];
                                                if _e817 {
                                                } else {
                                                    phi_3246_ = true;
                                                    break;
                                                }
                                                local[_e816] = _e808.member.member_1[2];
                                                if _e817 {
                                                } else {
                                                    phi_3246_ = true;
                                                    break;
                                                }
                                                local_12[_e816] = select(_e799, _e797, (_e797 > _e799));
                                                if _e806 {
                                                    phi_2770_ = _e716;
                                                } else {
                                                    phi_2770_ = _e721;
                                                }
                                                let _e834 = phi_2770_;
                                                phi_2771_ = _e834;
                                                phi_2772_ = (_e532 + 1u);
                                            } else {
                                                phi_2771_ = type_53();
                                                phi_2772_ = u32();
                                            }
                                            let _e836 = phi_2771_;
                                            let _e838 = phi_2772_;
                                            phi_2774_ = _e836;
                                            phi_2775_ = _e838;
                                            phi_2776_ = select(true, false, _e805);
                                        } else {
                                            phi_2774_ = type_53();
                                            phi_2775_ = u32();
                                            phi_2776_ = true;
                                        }
                                        let _e841 = phi_2774_;
                                        let _e843 = phi_2775_;
                                        let _e845 = phi_2776_;
                                        if _e845 {
                                            if _e804 {
                                                phi_2783_ = _e716;
                                            } else {
                                                phi_2783_ = _e721;
                                            }
                                            let _e847 = phi_2783_;
                                            phi_2788_ = _e847;
                                            phi_2789_ = select(_e805, true, _e804);
                                        } else {
                                            phi_2788_ = _e841;
                                            phi_2789_ = _e530;
                                        }
                                        let _e850 = phi_2788_;
                                        let _e852 = phi_2789_;
                                        phi_3295_ = _e490;
                                        phi_3250_ = _e703;
                                        phi_2791_ = _e850;
                                        phi_2792_ = _e852;
                                        phi_2793_ = select(_e843, _e532, _e845);
                                    }
                                    let _e1364 = phi_3295_;
                                    let _e1366 = phi_3250_;
                                    let _e1368 = phi_2791_;
                                    let _e1370 = phi_2792_;
                                    let _e1372 = phi_2793_;
                                    phi_3294_ = _e1364;
                                    phi_3249_ = _e1366;
                                    phi_2794_ = _e1368;
                                    phi_2795_ = (_e494 - 1u);
                                    phi_2796_ = _e1370;
                                    phi_2797_ = _e1372;
                                } else {
                                    phi_3294_ = _e490;
                                    phi_3249_ = _e488;
                                    phi_2794_ = _e528;
                                    phi_2795_ = _e494;
                                    phi_2796_ = _e530;
                                    phi_2797_ = _e532;
                                }
                                let _e1374 = phi_3294_;
                                let _e1376 = phi_3249_;
                                let _e1378 = phi_2794_;
                                let _e1380 = phi_2795_;
                                let _e1382 = phi_2796_;
                                let _e1384 = phi_2797_;
                                phi_3293_ = _e1374;
                                phi_3248_ = _e1376;
                                phi_2798_ = _e1378;
                                phi_2799_ = _e1380;
                                phi_2800_ = _e1382;
                                phi_2801_ = _e1384;
                            } else {
                                phi_3293_ = _e490;
                                phi_3248_ = _e488;
                                phi_2798_ = type_53();
                                phi_2799_ = u32();
                                phi_2800_ = bool();
                                phi_2801_ = u32();
                            }
                            let _e1386 = phi_3293_;
                            let _e1388 = phi_3248_;
                            let _e1390 = phi_2798_;
                            let _e1392 = phi_2799_;
                            let _e1394 = phi_2800_;
                            let _e1396 = phi_2801_;
                            phi_3292_ = _e1386;
                            phi_3247_ = _e1388;
                            phi_852_ = _e1390;
                            phi_855_ = _e1392;
                            phi_857_ = _e1394;
                            phi_859_ = _e1396;
                            phi_2802_ = _e502;
                        } else {
                            phi_3292_ = _e490;
                            phi_3247_ = _e488;
                            phi_852_ = type_53();
                            phi_855_ = u32();
                            phi_857_ = bool();
                            phi_859_ = u32();
                            phi_2802_ = false;
                        }
                        let _e1398 = phi_3292_;
                        let _e1400 = phi_3247_;
                        let _e1402 = phi_852_;
                        let _e1404 = phi_855_;
                        let _e1406 = phi_857_;
                        let _e1408 = phi_859_;
                        let _e1410 = phi_2802_;
                        continue;
                        continuing {
                            phi_3075_ = _e1400;
                            phi_3066_ = _e1398;
                            phi_851_ = _e1402;
                            phi_854_ = _e1404;
                            phi_856_ = _e1406;
                            phi_858_ = _e1408;
                            phi_3246_ = _e1400;
                            break if !(_e1410);
                        }
                    }
                    let _e1413 = phi_3246_;
                    if _e1413 {
                        break;
                    }
                    phi_2809_ = type_4(0u, 8u);
                    loop {
                        let _e1415 = phi_2809_;
                        if (_e1415.member < _e1415.member_1) {
                            phi_2810_ = type_4((_e1415.member + 1u), _e1415.member_1);
                            phi_2833_ = type_4(1u, _e1415.member);
                        } else {
                            phi_2810_ = _e1415;
                            phi_2833_ = type_4(0u, type_4().member_1);
                        }
                        let _e1428 = phi_2810_;
                        let _e1430 = phi_2833_;
                        let _e1434 = (bitcast<i32>(_e1430.member) != 0i);
                        if _e1434 {
                            let _e1435 = (_e1430.member_1 < 8u);
                            if _e1435 {
                            } else {
                                phi_3285_ = true;
                                break;
                            }
                            let _e1437 = local_11[_e1430.member_1];
                            if (_e1437.member_3 != 4294967295u) {
                                let _e1443 = -(_e424);
                                let _e1444 = (_e1443 / 3i);
                                let _e1451 = bitcast<f32>((bitcast<u32>((_e1444 + 127i)) << bitcast<u32>(23i)));
                                let _e1459 = (((_e1437.member * _e1451) * _e1451) * bitcast<f32>((bitcast<u32>(((_e1443 - (2i * _e1444)) + 127i)) << bitcast<u32>(23i))));
                                let _e1461 = select(340282350000000000000000000000000000000f, _e1459, (_e1459 < 340282350000000000000000000000000000000f));
                                phi_2899_ = type_18(select(-340282350000000000000000000000000000000f, _e1461, (_e1461 > -340282350000000000000000000000000000000f)), _e1437.member_1, _e1437.member_2, _e1437.member_3);
                            } else {
                                phi_2899_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1466 = phi_2899_;
                            if _e1435 {
                            } else {
                                phi_3285_ = true;
                                break;
                            }
                            local_11[_e1430.member_1] = type_18(_e1466.member, _e1466.member_1, _e1466.member_2, _e1466.member_3);
                        }
                        continue;
                        continuing {
                            phi_2809_ = _e1428;
                            phi_3285_ = _e1413;
                            break if !(_e1434);
                        }
                    }
                    let _e1474 = phi_3285_;
                    if _e1474 {
                        break;
                    }
                    let _e1475 = local_11;
                    if _e145 {
                    } else {
                        break;
                    }
                    global_5.member[_e143] = array<type_18, 8>(type_18(_e1475[0].member, _e1475[0].member_1, _e1475[0].member_2, _e1475[0].member_3), type_18(_e1475[1].member, _e1475[1].member_1, _e1475[1].member_2, _e1475[1].member_3), type_18(_e1475[2].member, _e1475[2].member_1, _e1475[2].member_2, _e1475[2].member_3), type_18(_e1475[3].member, _e1475[3].member_1, _e1475[3].member_2, _e1475[3].member_3), type_18(_e1475[4].member, _e1475[4].member_1, _e1475[4].member_2, _e1475[4].member_3), type_18(_e1475[5].member, _e1475[5].member_1, _e1475[5].member_2, _e1475[5].member_3), type_18(_e1475[6].member, _e1475[6].member_1, _e1475[6].member_2, _e1475[6].member_3), type_18(_e1475[7].member, _e1475[7].member_1, _e1475[7].member_2, _e1475[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
