struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: vec4<u32>,
}

struct type_19 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_21 {
    member: array<type_19>,
}

struct type_24 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_25 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_27 {
    member: array<type_25>,
}

struct type_30 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_34 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_9;
@group(0) @binding(1) 
var<uniform> global_2: type_9;
@group(0) @binding(2) 
var<storage> global_3: type_21;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_32;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_27;

fn function_() {
    var phi_137_: type_19;
    var phi_155_: type_24;
    var phi_173_: type_24;
    var phi_225_: type_4;
    var phi_228_: type_34;
    var phi_230_: u32;
    var phi_226_: type_4;
    var phi_253_: type_4;
    var phi_275_: type_19;
    var phi_284_: bool;
    var phi_302_: type_24;
    var phi_320_: type_24;
    var phi_324_: type_24;
    var phi_348_: f32;
    var phi_399_: u32;
    var phi_401_: u32;
    var phi_402_: bool;
    var phi_440_: u32;
    var phi_441_: u32;
    var phi_479_: f32;
    var phi_530_: u32;
    var phi_532_: u32;
    var phi_533_: bool;
    var phi_571_: u32;
    var phi_572_: u32;
    var phi_612_: f32;
    var phi_663_: u32;
    var phi_665_: u32;
    var phi_666_: bool;
    var phi_704_: u32;
    var phi_705_: u32;
    var phi_745_: f32;
    var phi_796_: u32;
    var phi_798_: u32;
    var phi_799_: bool;
    var phi_837_: u32;
    var phi_838_: u32;
    var phi_899_: u32;
    var phi_901_: u32;
    var phi_902_: bool;
    var phi_944_: f32;
    var phi_995_: u32;
    var phi_997_: u32;
    var phi_998_: bool;
    var phi_1036_: u32;
    var phi_1037_: u32;
    var phi_1098_: u32;
    var phi_1100_: u32;
    var phi_1101_: bool;
    var phi_1145_: f32;
    var phi_1196_: u32;
    var phi_1198_: u32;
    var phi_1199_: bool;
    var phi_1237_: u32;
    var phi_1238_: u32;
    var phi_1299_: u32;
    var phi_1301_: u32;
    var phi_1302_: bool;
    var phi_1522_: type_34;
    var phi_1523_: u32;
    var phi_229_: type_34;
    var phi_231_: u32;
    var phi_1525_: bool;
    var phi_3650_: bool;
    var phi_1553_: type_24;
    var phi_1575_: type_24;
    var local: type_34;
    var local_1: type_34;
    var phi_1606_: f32;
    var phi_1657_: u32;
    var phi_1659_: u32;
    var phi_1660_: bool;
    var phi_1698_: u32;
    var phi_1699_: u32;
    var phi_1737_: f32;
    var phi_1788_: u32;
    var phi_1790_: u32;
    var phi_1791_: bool;
    var phi_1829_: u32;
    var phi_1830_: u32;
    var phi_1870_: f32;
    var phi_1921_: u32;
    var phi_1923_: u32;
    var phi_1924_: bool;
    var phi_1962_: u32;
    var phi_1963_: u32;
    var phi_2003_: f32;
    var phi_2054_: u32;
    var phi_2056_: u32;
    var phi_2057_: bool;
    var phi_2095_: u32;
    var phi_2096_: u32;
    var phi_2157_: u32;
    var phi_2159_: u32;
    var phi_2160_: bool;
    var phi_2202_: f32;
    var phi_2253_: u32;
    var phi_2255_: u32;
    var phi_2256_: bool;
    var phi_2294_: u32;
    var phi_2295_: u32;
    var phi_2356_: u32;
    var phi_2358_: u32;
    var phi_2359_: bool;
    var phi_2403_: f32;
    var phi_2454_: u32;
    var phi_2456_: u32;
    var phi_2457_: bool;
    var phi_2495_: u32;
    var phi_2496_: u32;
    var phi_2557_: u32;
    var phi_2559_: u32;
    var phi_2560_: bool;
    var phi_2613_: f32;
    var phi_2664_: u32;
    var phi_2666_: u32;
    var phi_2667_: bool;
    var phi_2705_: u32;
    var phi_2706_: u32;
    var phi_2744_: f32;
    var phi_2795_: u32;
    var phi_2797_: u32;
    var phi_2798_: bool;
    var phi_2836_: u32;
    var phi_2837_: u32;
    var phi_2877_: f32;
    var phi_2928_: u32;
    var phi_2930_: u32;
    var phi_2931_: bool;
    var phi_2969_: u32;
    var phi_2970_: u32;
    var phi_3010_: f32;
    var phi_3061_: u32;
    var phi_3063_: u32;
    var phi_3064_: bool;
    var phi_3102_: u32;
    var phi_3103_: u32;
    var phi_3164_: u32;
    var phi_3166_: u32;
    var phi_3167_: bool;
    var phi_3209_: f32;
    var phi_3260_: u32;
    var phi_3262_: u32;
    var phi_3263_: bool;
    var phi_3301_: u32;
    var phi_3302_: u32;
    var phi_3363_: u32;
    var phi_3365_: u32;
    var phi_3366_: bool;
    var phi_3410_: f32;
    var phi_3461_: u32;
    var phi_3463_: u32;
    var phi_3464_: bool;
    var phi_3502_: u32;
    var phi_3503_: u32;
    var phi_3564_: u32;
    var phi_3566_: u32;
    var phi_3567_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e37 = global;
            let _e39 = arrayLength((&global_3.member));
            let _e43 = arrayLength((&global_5.member));
            let _e47 = (_e37.x + (_e37.y * 2097152u));
            let _e50 = global_1.member[0u];
            if (_e47 < _e50) {
                let _e52 = (_e47 < _e39);
                if _e52 {
                    let _e53 = (_e47 < arrayLength((&global_4.member)));
                    if _e53 {
                        let _e56 = global_2.member[0u];
                        let _e57 = (0u < _e39);
                        if _e57 {
                            if _e57 {
                            } else {
                                break;
                            }
                            let _e60 = global_3.member[0u];
                            phi_137_ = _e60;
                        } else {
                            phi_137_ = type_19(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e62 = phi_137_;
                        if (_e62.member_1 == 2147483648u) {
                            phi_155_ = type_24(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            phi_155_ = type_24(vec3<f32>(_e62.member[0][0], _e62.member[1][0], _e62.member[2][0]), vec3<f32>(_e62.member[0][2], _e62.member[1][2], _e62.member[2][2]));
                        }
                        let _e81 = phi_155_;
                        if (_e62.member_2 == 2147483648u) {
                            phi_173_ = _e81;
                        } else {
                            phi_173_ = type_24(vec3<f32>(_e62.member[0][1], _e62.member[1][1], _e62.member[2][1]), vec3<f32>(_e62.member[0][3], _e62.member[1][3], _e62.member[2][3]));
                        }
                        let _e100 = phi_173_;
                        phi_225_ = type_4(0u, 128u);
                        phi_228_ = type_34(array<f32, 3>(select(_e100.member.x, _e81.member.x, (_e81.member.x < _e100.member.x)), select(_e100.member.y, _e81.member.y, (_e81.member.y < _e100.member.y)), select(_e100.member.z, _e81.member.z, (_e81.member.z < _e100.member.z))), array<f32, 3>(select(_e100.member_1.x, _e81.member_1.x, (_e81.member_1.x > _e100.member_1.x)), select(_e100.member_1.y, _e81.member_1.y, (_e81.member_1.y > _e100.member_1.y)), select(_e100.member_1.z, _e81.member_1.z, (_e81.member_1.z > _e100.member_1.z))));
                        phi_230_ = 0u;
                        loop {
                            let _e133 = phi_225_;
                            let _e135 = phi_228_;
                            let _e137 = phi_230_;
                            local = _e135;
                            local_1 = _e135;
                            if (_e133.member < _e133.member_1) {
                                phi_226_ = type_4((_e133.member + 1u), _e133.member_1);
                                phi_253_ = type_4(1u, _e133.member);
                            } else {
                                phi_226_ = _e133;
                                phi_253_ = type_4(0u, type_4().member_1);
                            }
                            let _e150 = phi_226_;
                            let _e152 = phi_253_;
                            if (bitcast<i32>(_e152.member) != 0i) {
                                let _e156 = (_e137 == _e47);
                                if _e156 {
                                    phi_1522_ = type_34();
                                    phi_1523_ = u32();
                                } else {
                                    let _e157 = (_e137 < _e39);
                                    if _e157 {
                                        if _e157 {
                                        } else {
                                            phi_3650_ = true;
                                            break;
                                        }
                                        let _e160 = global_3.member[_e137];
                                        phi_275_ = _e160;
                                    } else {
                                        phi_275_ = type_19(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e162 = phi_275_;
                                    if ((_e162.member_1 & 2147483648u) != 0u) {
                                        phi_284_ = false;
                                    } else {
                                        phi_284_ = (_e47 <= _e162.member_1);
                                    }
                                    let _e169 = phi_284_;
                                    if (_e162.member_1 == 2147483648u) {
                                        phi_302_ = type_24(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                    } else {
                                        phi_302_ = type_24(vec3<f32>(_e162.member[0][0], _e162.member[1][0], _e162.member[2][0]), vec3<f32>(_e162.member[0][2], _e162.member[1][2], _e162.member[2][2]));
                                    }
                                    let _e187 = phi_302_;
                                    if (_e162.member_2 == 2147483648u) {
                                        phi_320_ = _e187;
                                    } else {
                                        phi_320_ = type_24(vec3<f32>(_e162.member[0][1], _e162.member[1][1], _e162.member[2][1]), vec3<f32>(_e162.member[0][3], _e162.member[1][3], _e162.member[2][3]));
                                    }
                                    let _e205 = phi_320_;
                                    if _e169 {
                                        phi_324_ = _e187;
                                    } else {
                                        phi_324_ = _e205;
                                    }
                                    let _e207 = phi_324_;
                                    let _e228 = (_e135.member_1[0] - _e135.member[0]);
                                    let _e229 = (_e228 > 0f);
                                    if _e229 {
                                        phi_348_ = (((_e207.member.x - _e135.member[0]) / _e228) * 1023f);
                                    } else {
                                        phi_348_ = 0f;
                                    }
                                    let _e234 = phi_348_;
                                    let _e236 = select(1023f, _e234, (_e234 < 1023f));
                                    let _e238 = select(0f, _e236, (_e236 > 0f));
                                    let _e243 = select(select(u32(_e238), 0u, (_e238 < 0f)), 4294967295u, (_e238 > 4294967000f));
                                    if (_e243 > 0u) {
                                        let _e254 = (_e135.member[0] + bitcast<f32>((bitcast<u32>((f32(_e243) * bitcast<f32>((bitcast<u32>((_e228 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                                        let _e259 = (select(select(_e135.member_1[0], _e254, (_e254 < _e135.member_1[0])), _e135.member_1[0], (_e243 == 1023u)) > _e207.member.x);
                                        if _e259 {
                                            phi_399_ = (_e243 - 1u);
                                        } else {
                                            phi_399_ = u32();
                                        }
                                        let _e262 = phi_399_;
                                        phi_401_ = _e262;
                                        phi_402_ = select(true, false, _e259);
                                    } else {
                                        phi_401_ = u32();
                                        phi_402_ = true;
                                    }
                                    let _e265 = phi_401_;
                                    let _e267 = phi_402_;
                                    if _e267 {
                                        if (_e243 < 1023u) {
                                            let _e269 = (_e243 + 1u);
                                            let _e279 = (_e135.member[0] + bitcast<f32>((bitcast<u32>((f32(_e269) * bitcast<f32>((bitcast<u32>((_e228 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                                            phi_440_ = select(_e243, _e269, (select(select(_e135.member_1[0], _e279, (_e279 < _e135.member_1[0])), _e135.member_1[0], (_e269 == 1023u)) <= _e207.member.x));
                                        } else {
                                            phi_440_ = _e243;
                                        }
                                        let _e287 = phi_440_;
                                        phi_441_ = _e287;
                                    } else {
                                        phi_441_ = _e265;
                                    }
                                    let _e289 = phi_441_;
                                    let _e293 = bitcast<f32>((bitcast<u32>((_e228 * 0.0009775171f)) ^ _e56));
                                    let _e299 = (_e135.member[0] + bitcast<f32>((bitcast<u32>((f32(_e289) * _e293)) ^ _e56)));
                                    let _e306 = (_e135.member_1[1] - _e135.member[1]);
                                    let _e307 = (_e306 > 0f);
                                    if _e307 {
                                        phi_479_ = (((_e207.member.y - _e135.member[1]) / _e306) * 1023f);
                                    } else {
                                        phi_479_ = 0f;
                                    }
                                    let _e312 = phi_479_;
                                    let _e314 = select(1023f, _e312, (_e312 < 1023f));
                                    let _e316 = select(0f, _e314, (_e314 > 0f));
                                    let _e321 = select(select(u32(_e316), 0u, (_e316 < 0f)), 4294967295u, (_e316 > 4294967000f));
                                    if (_e321 > 0u) {
                                        let _e332 = (_e135.member[1] + bitcast<f32>((bitcast<u32>((f32(_e321) * bitcast<f32>((bitcast<u32>((_e306 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                                        let _e337 = (select(select(_e135.member_1[1], _e332, (_e332 < _e135.member_1[1])), _e135.member_1[1], (_e321 == 1023u)) > _e207.member.y);
                                        if _e337 {
                                            phi_530_ = (_e321 - 1u);
                                        } else {
                                            phi_530_ = u32();
                                        }
                                        let _e340 = phi_530_;
                                        phi_532_ = _e340;
                                        phi_533_ = select(true, false, _e337);
                                    } else {
                                        phi_532_ = u32();
                                        phi_533_ = true;
                                    }
                                    let _e343 = phi_532_;
                                    let _e345 = phi_533_;
                                    if _e345 {
                                        if (_e321 < 1023u) {
                                            let _e347 = (_e321 + 1u);
                                            let _e357 = (_e135.member[1] + bitcast<f32>((bitcast<u32>((f32(_e347) * bitcast<f32>((bitcast<u32>((_e306 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                                            phi_571_ = select(_e321, _e347, (select(select(_e135.member_1[1], _e357, (_e357 < _e135.member_1[1])), _e135.member_1[1], (_e347 == 1023u)) <= _e207.member.y));
                                        } else {
                                            phi_571_ = _e321;
                                        }
                                        let _e365 = phi_571_;
                                        phi_572_ = _e365;
                                    } else {
                                        phi_572_ = _e343;
                                    }
                                    let _e367 = phi_572_;
                                    let _e371 = bitcast<f32>((bitcast<u32>((_e306 * 0.0009775171f)) ^ _e56));
                                    let _e377 = (_e135.member[1] + bitcast<f32>((bitcast<u32>((f32(_e367) * _e371)) ^ _e56)));
                                    let _e387 = (_e135.member_1[2] - _e135.member[2]);
                                    let _e388 = (_e387 > 0f);
                                    if _e388 {
                                        phi_612_ = (((_e207.member.z - _e135.member[2]) / _e387) * 1023f);
                                    } else {
                                        phi_612_ = 0f;
                                    }
                                    let _e393 = phi_612_;
                                    let _e395 = select(1023f, _e393, (_e393 < 1023f));
                                    let _e397 = select(0f, _e395, (_e395 > 0f));
                                    let _e402 = select(select(u32(_e397), 0u, (_e397 < 0f)), 4294967295u, (_e397 > 4294967000f));
                                    if (_e402 > 0u) {
                                        let _e413 = (_e135.member[2] + bitcast<f32>((bitcast<u32>((f32(_e402) * bitcast<f32>((bitcast<u32>((_e387 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                                        let _e418 = (select(select(_e135.member_1[2], _e413, (_e413 < _e135.member_1[2])), _e135.member_1[2], (_e402 == 1023u)) > _e207.member.z);
                                        if _e418 {
                                            phi_663_ = (_e402 - 1u);
                                        } else {
                                            phi_663_ = u32();
                                        }
                                        let _e421 = phi_663_;
                                        phi_665_ = _e421;
                                        phi_666_ = select(true, false, _e418);
                                    } else {
                                        phi_665_ = u32();
                                        phi_666_ = true;
                                    }
                                    let _e424 = phi_665_;
                                    let _e426 = phi_666_;
                                    if _e426 {
                                        if (_e402 < 1023u) {
                                            let _e428 = (_e402 + 1u);
                                            let _e438 = (_e135.member[2] + bitcast<f32>((bitcast<u32>((f32(_e428) * bitcast<f32>((bitcast<u32>((_e387 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                                            phi_704_ = select(_e402, _e428, (select(select(_e135.member_1[2], _e438, (_e438 < _e135.member_1[2])), _e135.member_1[2], (_e428 == 1023u)) <= _e207.member.z));
                                        } else {
                                            phi_704_ = _e402;
                                        }
                                        let _e446 = phi_704_;
                                        phi_705_ = _e446;
                                    } else {
                                        phi_705_ = _e424;
                                    }
                                    let _e448 = phi_705_;
                                    let _e452 = bitcast<f32>((bitcast<u32>((_e387 * 0.0009775171f)) ^ _e56));
                                    let _e458 = (_e135.member[2] + bitcast<f32>((bitcast<u32>((f32(_e448) * _e452)) ^ _e56)));
                                    let _e467 = ((select(_e289, 0u, (select(select(_e135.member_1[0], _e299, (_e299 < _e135.member_1[0])), _e135.member_1[0], (_e289 == 1023u)) > _e207.member.x)) | (select(_e367, 0u, (select(select(_e135.member_1[1], _e377, (_e377 < _e135.member_1[1])), _e135.member_1[1], (_e367 == 1023u)) > _e207.member.y)) << bitcast<u32>(10i))) | (select(_e448, 0u, (select(select(_e135.member_1[2], _e458, (_e458 < _e135.member_1[2])), _e135.member_1[2], (_e448 == 1023u)) > _e207.member.z)) << bitcast<u32>(20i)));
                                    if _e229 {
                                        phi_745_ = (((_e207.member_1.x - _e135.member[0]) / _e228) * 1023f);
                                    } else {
                                        phi_745_ = 0f;
                                    }
                                    let _e472 = phi_745_;
                                    let _e474 = select(1023f, _e472, (_e472 < 1023f));
                                    let _e476 = select(0f, _e474, (_e474 > 0f));
                                    let _e481 = select(select(u32(_e476), 0u, (_e476 < 0f)), 4294967295u, (_e476 > 4294967000f));
                                    if (_e481 > 0u) {
                                        let _e488 = (_e135.member[0] + bitcast<f32>((bitcast<u32>((f32(_e481) * _e293)) ^ _e56)));
                                        let _e493 = (select(select(_e135.member_1[0], _e488, (_e488 < _e135.member_1[0])), _e135.member_1[0], (_e481 == 1023u)) > _e207.member_1.x);
                                        if _e493 {
                                            phi_796_ = (_e481 - 1u);
                                        } else {
                                            phi_796_ = u32();
                                        }
                                        let _e496 = phi_796_;
                                        phi_798_ = _e496;
                                        phi_799_ = select(true, false, _e493);
                                    } else {
                                        phi_798_ = u32();
                                        phi_799_ = true;
                                    }
                                    let _e499 = phi_798_;
                                    let _e501 = phi_799_;
                                    if _e501 {
                                        if (_e481 < 1023u) {
                                            let _e503 = (_e481 + 1u);
                                            let _e509 = (_e135.member[0] + bitcast<f32>((bitcast<u32>((f32(_e503) * _e293)) ^ _e56)));
                                            phi_837_ = select(_e481, _e503, (select(select(_e135.member_1[0], _e509, (_e509 < _e135.member_1[0])), _e135.member_1[0], (_e503 == 1023u)) <= _e207.member_1.x));
                                        } else {
                                            phi_837_ = _e481;
                                        }
                                        let _e517 = phi_837_;
                                        phi_838_ = _e517;
                                    } else {
                                        phi_838_ = _e499;
                                    }
                                    let _e519 = phi_838_;
                                    let _e525 = (_e135.member[0] + bitcast<f32>((bitcast<u32>((f32(_e519) * _e293)) ^ _e56)));
                                    let _e531 = select(_e519, 0u, (select(select(_e135.member_1[0], _e525, (_e525 < _e135.member_1[0])), _e135.member_1[0], (_e519 == 1023u)) > _e207.member_1.x));
                                    if (_e531 < 1023u) {
                                        let _e538 = (_e135.member[0] + bitcast<f32>((bitcast<u32>((f32(_e531) * _e293)) ^ _e56)));
                                        let _e543 = (select(select(_e135.member_1[0], _e538, (_e538 < _e135.member_1[0])), _e135.member_1[0], (_e531 == 1023u)) < _e207.member_1.x);
                                        if _e543 {
                                            phi_899_ = (_e531 + 1u);
                                        } else {
                                            phi_899_ = u32();
                                        }
                                        let _e546 = phi_899_;
                                        phi_901_ = _e546;
                                        phi_902_ = select(true, false, _e543);
                                    } else {
                                        phi_901_ = u32();
                                        phi_902_ = true;
                                    }
                                    let _e549 = phi_901_;
                                    let _e551 = phi_902_;
                                    let _e552 = select(_e549, _e531, _e551);
                                    let _e558 = (_e135.member[0] + bitcast<f32>((bitcast<u32>((f32(_e552) * _e293)) ^ _e56)));
                                    if _e307 {
                                        phi_944_ = (((_e207.member_1.y - _e135.member[1]) / _e306) * 1023f);
                                    } else {
                                        phi_944_ = 0f;
                                    }
                                    let _e569 = phi_944_;
                                    let _e571 = select(1023f, _e569, (_e569 < 1023f));
                                    let _e573 = select(0f, _e571, (_e571 > 0f));
                                    let _e578 = select(select(u32(_e573), 0u, (_e573 < 0f)), 4294967295u, (_e573 > 4294967000f));
                                    if (_e578 > 0u) {
                                        let _e585 = (_e135.member[1] + bitcast<f32>((bitcast<u32>((f32(_e578) * _e371)) ^ _e56)));
                                        let _e590 = (select(select(_e135.member_1[1], _e585, (_e585 < _e135.member_1[1])), _e135.member_1[1], (_e578 == 1023u)) > _e207.member_1.y);
                                        if _e590 {
                                            phi_995_ = (_e578 - 1u);
                                        } else {
                                            phi_995_ = u32();
                                        }
                                        let _e593 = phi_995_;
                                        phi_997_ = _e593;
                                        phi_998_ = select(true, false, _e590);
                                    } else {
                                        phi_997_ = u32();
                                        phi_998_ = true;
                                    }
                                    let _e596 = phi_997_;
                                    let _e598 = phi_998_;
                                    if _e598 {
                                        if (_e578 < 1023u) {
                                            let _e600 = (_e578 + 1u);
                                            let _e606 = (_e135.member[1] + bitcast<f32>((bitcast<u32>((f32(_e600) * _e371)) ^ _e56)));
                                            phi_1036_ = select(_e578, _e600, (select(select(_e135.member_1[1], _e606, (_e606 < _e135.member_1[1])), _e135.member_1[1], (_e600 == 1023u)) <= _e207.member_1.y));
                                        } else {
                                            phi_1036_ = _e578;
                                        }
                                        let _e614 = phi_1036_;
                                        phi_1037_ = _e614;
                                    } else {
                                        phi_1037_ = _e596;
                                    }
                                    let _e616 = phi_1037_;
                                    let _e622 = (_e135.member[1] + bitcast<f32>((bitcast<u32>((f32(_e616) * _e371)) ^ _e56)));
                                    let _e628 = select(_e616, 0u, (select(select(_e135.member_1[1], _e622, (_e622 < _e135.member_1[1])), _e135.member_1[1], (_e616 == 1023u)) > _e207.member_1.y));
                                    if (_e628 < 1023u) {
                                        let _e635 = (_e135.member[1] + bitcast<f32>((bitcast<u32>((f32(_e628) * _e371)) ^ _e56)));
                                        let _e640 = (select(select(_e135.member_1[1], _e635, (_e635 < _e135.member_1[1])), _e135.member_1[1], (_e628 == 1023u)) < _e207.member_1.y);
                                        if _e640 {
                                            phi_1098_ = (_e628 + 1u);
                                        } else {
                                            phi_1098_ = u32();
                                        }
                                        let _e643 = phi_1098_;
                                        phi_1100_ = _e643;
                                        phi_1101_ = select(true, false, _e640);
                                    } else {
                                        phi_1100_ = u32();
                                        phi_1101_ = true;
                                    }
                                    let _e646 = phi_1100_;
                                    let _e648 = phi_1101_;
                                    let _e649 = select(_e646, _e628, _e648);
                                    let _e655 = (_e135.member[1] + bitcast<f32>((bitcast<u32>((f32(_e649) * _e371)) ^ _e56)));
                                    if _e388 {
                                        phi_1145_ = (((_e207.member_1.z - _e135.member[2]) / _e387) * 1023f);
                                    } else {
                                        phi_1145_ = 0f;
                                    }
                                    let _e669 = phi_1145_;
                                    let _e671 = select(1023f, _e669, (_e669 < 1023f));
                                    let _e673 = select(0f, _e671, (_e671 > 0f));
                                    let _e678 = select(select(u32(_e673), 0u, (_e673 < 0f)), 4294967295u, (_e673 > 4294967000f));
                                    if (_e678 > 0u) {
                                        let _e685 = (_e135.member[2] + bitcast<f32>((bitcast<u32>((f32(_e678) * _e452)) ^ _e56)));
                                        let _e690 = (select(select(_e135.member_1[2], _e685, (_e685 < _e135.member_1[2])), _e135.member_1[2], (_e678 == 1023u)) > _e207.member_1.z);
                                        if _e690 {
                                            phi_1196_ = (_e678 - 1u);
                                        } else {
                                            phi_1196_ = u32();
                                        }
                                        let _e693 = phi_1196_;
                                        phi_1198_ = _e693;
                                        phi_1199_ = select(true, false, _e690);
                                    } else {
                                        phi_1198_ = u32();
                                        phi_1199_ = true;
                                    }
                                    let _e696 = phi_1198_;
                                    let _e698 = phi_1199_;
                                    if _e698 {
                                        if (_e678 < 1023u) {
                                            let _e700 = (_e678 + 1u);
                                            let _e706 = (_e135.member[2] + bitcast<f32>((bitcast<u32>((f32(_e700) * _e452)) ^ _e56)));
                                            phi_1237_ = select(_e678, _e700, (select(select(_e135.member_1[2], _e706, (_e706 < _e135.member_1[2])), _e135.member_1[2], (_e700 == 1023u)) <= _e207.member_1.z));
                                        } else {
                                            phi_1237_ = _e678;
                                        }
                                        let _e714 = phi_1237_;
                                        phi_1238_ = _e714;
                                    } else {
                                        phi_1238_ = _e696;
                                    }
                                    let _e716 = phi_1238_;
                                    let _e722 = (_e135.member[2] + bitcast<f32>((bitcast<u32>((f32(_e716) * _e452)) ^ _e56)));
                                    let _e728 = select(_e716, 0u, (select(select(_e135.member_1[2], _e722, (_e722 < _e135.member_1[2])), _e135.member_1[2], (_e716 == 1023u)) > _e207.member_1.z));
                                    if (_e728 < 1023u) {
                                        let _e735 = (_e135.member[2] + bitcast<f32>((bitcast<u32>((f32(_e728) * _e452)) ^ _e56)));
                                        let _e740 = (select(select(_e135.member_1[2], _e735, (_e735 < _e135.member_1[2])), _e135.member_1[2], (_e728 == 1023u)) < _e207.member_1.z);
                                        if _e740 {
                                            phi_1299_ = (_e728 + 1u);
                                        } else {
                                            phi_1299_ = u32();
                                        }
                                        let _e743 = phi_1299_;
                                        phi_1301_ = _e743;
                                        phi_1302_ = select(true, false, _e740);
                                    } else {
                                        phi_1301_ = u32();
                                        phi_1302_ = true;
                                    }
                                    let _e746 = phi_1301_;
                                    let _e748 = phi_1302_;
                                    let _e749 = select(_e746, _e728, _e748);
                                    let _e755 = (_e135.member[2] + bitcast<f32>((bitcast<u32>((f32(_e749) * _e452)) ^ _e56)));
                                    let _e764 = ((select(_e552, 1023u, (select(select(_e135.member_1[0], _e558, (_e558 < _e135.member_1[0])), _e135.member_1[0], (_e552 == 1023u)) < _e207.member_1.x)) | (select(_e649, 1023u, (select(select(_e135.member_1[1], _e655, (_e655 < _e135.member_1[1])), _e135.member_1[1], (_e649 == 1023u)) < _e207.member_1.y)) << bitcast<u32>(10i))) | (select(_e749, 1023u, (select(select(_e135.member_1[2], _e755, (_e755 < _e135.member_1[2])), _e135.member_1[2], (_e749 == 1023u)) < _e207.member_1.z)) << bitcast<u32>(20i)));
                                    let _e765 = (_e467 & 1023u);
                                    let _e771 = (_e135.member[0] + bitcast<f32>((bitcast<u32>((f32(_e765) * _e293)) ^ _e56)));
                                    let _e778 = ((_e467 >> bitcast<u32>(10u)) & 1023u);
                                    let _e784 = (_e135.member[1] + bitcast<f32>((bitcast<u32>((f32(_e778) * _e371)) ^ _e56)));
                                    let _e791 = ((_e467 >> bitcast<u32>(20u)) & 1023u);
                                    let _e797 = (_e135.member[2] + bitcast<f32>((bitcast<u32>((f32(_e791) * _e452)) ^ _e56)));
                                    let _e803 = (_e764 & 1023u);
                                    let _e809 = (_e135.member[0] + bitcast<f32>((bitcast<u32>((f32(_e803) * _e293)) ^ _e56)));
                                    let _e816 = ((_e764 >> bitcast<u32>(10u)) & 1023u);
                                    let _e822 = (_e135.member[1] + bitcast<f32>((bitcast<u32>((f32(_e816) * _e371)) ^ _e56)));
                                    let _e829 = ((_e764 >> bitcast<u32>(20u)) & 1023u);
                                    let _e835 = (_e135.member[2] + bitcast<f32>((bitcast<u32>((f32(_e829) * _e452)) ^ _e56)));
                                    phi_1522_ = type_34(array<f32, 3>(select(select(_e135.member_1[0], _e771, (_e771 < _e135.member_1[0])), _e135.member_1[0], (_e765 == 1023u)), select(select(_e135.member_1[1], _e784, (_e784 < _e135.member_1[1])), _e135.member_1[1], (_e778 == 1023u)), select(select(_e135.member_1[2], _e797, (_e797 < _e135.member_1[2])), _e135.member_1[2], (_e791 == 1023u))), array<f32, 3>(select(select(_e135.member_1[0], _e809, (_e809 < _e135.member_1[0])), _e135.member_1[0], (_e803 == 1023u)), select(select(_e135.member_1[1], _e822, (_e822 < _e135.member_1[1])), _e135.member_1[1], (_e816 == 1023u)), select(select(_e135.member_1[2], _e835, (_e835 < _e135.member_1[2])), _e135.member_1[2], (_e829 == 1023u))));
                                    phi_1523_ = select(_e162.member_2, _e162.member_1, _e169);
                                }
                                let _e844 = phi_1522_;
                                let _e846 = phi_1523_;
                                phi_229_ = _e844;
                                phi_231_ = _e846;
                                phi_1525_ = select(true, false, _e156);
                            } else {
                                phi_229_ = type_34();
                                phi_231_ = u32();
                                phi_1525_ = false;
                            }
                            let _e849 = phi_229_;
                            let _e851 = phi_231_;
                            let _e853 = phi_1525_;
                            continue;
                            continuing {
                                phi_225_ = _e150;
                                phi_228_ = _e849;
                                phi_230_ = _e851;
                                phi_3650_ = false;
                                break if !(_e853);
                            }
                        }
                        let _e856 = phi_3650_;
                        if _e856 {
                            break;
                        }
                        if _e52 {
                        } else {
                            break;
                        }
                        let _e860 = global_3.member[_e47].member_1;
                        if (_e860 == 2147483648u) {
                            phi_1553_ = type_24(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            let _e866 = global_3.member[_e47].member[0u];
                            let _e871 = global_3.member[_e47].member[1u];
                            let _e876 = global_3.member[_e47].member[2u];
                            phi_1553_ = type_24(vec3<f32>(_e866[0], _e871[0], _e876[0]), vec3<f32>(_e866[2], _e871[2], _e876[2]));
                        }
                        let _e887 = phi_1553_;
                        let _e891 = global_3.member[_e47].member_2;
                        if (_e891 == 2147483648u) {
                            phi_1575_ = _e887;
                        } else {
                            let _e897 = global_3.member[_e47].member[0u];
                            let _e902 = global_3.member[_e47].member[1u];
                            let _e907 = global_3.member[_e47].member[2u];
                            phi_1575_ = type_24(vec3<f32>(_e897[1], _e902[1], _e907[1]), vec3<f32>(_e897[3], _e902[3], _e907[3]));
                        }
                        let _e918 = phi_1575_;
                        let _e944 = local;
                        let _e947 = local_1;
                        let _e955 = (_e947.member_1[0] - _e944.member[0]);
                        let _e956 = (_e955 > 0f);
                        if _e956 {
                            phi_1606_ = (((_e887.member.x - _e944.member[0]) / _e955) * 1023f);
                        } else {
                            phi_1606_ = 0f;
                        }
                        let _e961 = phi_1606_;
                        let _e963 = select(1023f, _e961, (_e961 < 1023f));
                        let _e965 = select(0f, _e963, (_e963 > 0f));
                        let _e970 = select(select(u32(_e965), 0u, (_e965 < 0f)), 4294967295u, (_e965 > 4294967000f));
                        if (_e970 > 0u) {
                            let _e981 = (_e944.member[0] + bitcast<f32>((bitcast<u32>((f32(_e970) * bitcast<f32>((bitcast<u32>((_e955 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                            let _e986 = (select(select(_e947.member_1[0], _e981, (_e981 < _e947.member_1[0])), _e947.member_1[0], (_e970 == 1023u)) > _e887.member.x);
                            if _e986 {
                                phi_1657_ = (_e970 - 1u);
                            } else {
                                phi_1657_ = u32();
                            }
                            let _e989 = phi_1657_;
                            phi_1659_ = _e989;
                            phi_1660_ = select(true, false, _e986);
                        } else {
                            phi_1659_ = u32();
                            phi_1660_ = true;
                        }
                        let _e992 = phi_1659_;
                        let _e994 = phi_1660_;
                        if _e994 {
                            if (_e970 < 1023u) {
                                let _e996 = (_e970 + 1u);
                                let _e1006 = (_e944.member[0] + bitcast<f32>((bitcast<u32>((f32(_e996) * bitcast<f32>((bitcast<u32>((_e955 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                                phi_1698_ = select(_e970, _e996, (select(select(_e947.member_1[0], _e1006, (_e1006 < _e947.member_1[0])), _e947.member_1[0], (_e996 == 1023u)) <= _e887.member.x));
                            } else {
                                phi_1698_ = _e970;
                            }
                            let _e1014 = phi_1698_;
                            phi_1699_ = _e1014;
                        } else {
                            phi_1699_ = _e992;
                        }
                        let _e1016 = phi_1699_;
                        let _e1020 = bitcast<f32>((bitcast<u32>((_e955 * 0.0009775171f)) ^ _e56));
                        let _e1026 = (_e944.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1016) * _e1020)) ^ _e56)));
                        let _e1033 = (_e947.member_1[1] - _e944.member[1]);
                        let _e1034 = (_e1033 > 0f);
                        if _e1034 {
                            phi_1737_ = (((_e887.member.y - _e944.member[1]) / _e1033) * 1023f);
                        } else {
                            phi_1737_ = 0f;
                        }
                        let _e1039 = phi_1737_;
                        let _e1041 = select(1023f, _e1039, (_e1039 < 1023f));
                        let _e1043 = select(0f, _e1041, (_e1041 > 0f));
                        let _e1048 = select(select(u32(_e1043), 0u, (_e1043 < 0f)), 4294967295u, (_e1043 > 4294967000f));
                        if (_e1048 > 0u) {
                            let _e1059 = (_e944.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1048) * bitcast<f32>((bitcast<u32>((_e1033 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                            let _e1064 = (select(select(_e947.member_1[1], _e1059, (_e1059 < _e947.member_1[1])), _e947.member_1[1], (_e1048 == 1023u)) > _e887.member.y);
                            if _e1064 {
                                phi_1788_ = (_e1048 - 1u);
                            } else {
                                phi_1788_ = u32();
                            }
                            let _e1067 = phi_1788_;
                            phi_1790_ = _e1067;
                            phi_1791_ = select(true, false, _e1064);
                        } else {
                            phi_1790_ = u32();
                            phi_1791_ = true;
                        }
                        let _e1070 = phi_1790_;
                        let _e1072 = phi_1791_;
                        if _e1072 {
                            if (_e1048 < 1023u) {
                                let _e1074 = (_e1048 + 1u);
                                let _e1084 = (_e944.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1074) * bitcast<f32>((bitcast<u32>((_e1033 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                                phi_1829_ = select(_e1048, _e1074, (select(select(_e947.member_1[1], _e1084, (_e1084 < _e947.member_1[1])), _e947.member_1[1], (_e1074 == 1023u)) <= _e887.member.y));
                            } else {
                                phi_1829_ = _e1048;
                            }
                            let _e1092 = phi_1829_;
                            phi_1830_ = _e1092;
                        } else {
                            phi_1830_ = _e1070;
                        }
                        let _e1094 = phi_1830_;
                        let _e1098 = bitcast<f32>((bitcast<u32>((_e1033 * 0.0009775171f)) ^ _e56));
                        let _e1104 = (_e944.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1094) * _e1098)) ^ _e56)));
                        let _e1114 = (_e947.member_1[2] - _e944.member[2]);
                        let _e1115 = (_e1114 > 0f);
                        if _e1115 {
                            phi_1870_ = (((_e887.member.z - _e944.member[2]) / _e1114) * 1023f);
                        } else {
                            phi_1870_ = 0f;
                        }
                        let _e1120 = phi_1870_;
                        let _e1122 = select(1023f, _e1120, (_e1120 < 1023f));
                        let _e1124 = select(0f, _e1122, (_e1122 > 0f));
                        let _e1129 = select(select(u32(_e1124), 0u, (_e1124 < 0f)), 4294967295u, (_e1124 > 4294967000f));
                        if (_e1129 > 0u) {
                            let _e1140 = (_e944.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1129) * bitcast<f32>((bitcast<u32>((_e1114 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                            let _e1145 = (select(select(_e947.member_1[2], _e1140, (_e1140 < _e947.member_1[2])), _e947.member_1[2], (_e1129 == 1023u)) > _e887.member.z);
                            if _e1145 {
                                phi_1921_ = (_e1129 - 1u);
                            } else {
                                phi_1921_ = u32();
                            }
                            let _e1148 = phi_1921_;
                            phi_1923_ = _e1148;
                            phi_1924_ = select(true, false, _e1145);
                        } else {
                            phi_1923_ = u32();
                            phi_1924_ = true;
                        }
                        let _e1151 = phi_1923_;
                        let _e1153 = phi_1924_;
                        if _e1153 {
                            if (_e1129 < 1023u) {
                                let _e1155 = (_e1129 + 1u);
                                let _e1165 = (_e944.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1155) * bitcast<f32>((bitcast<u32>((_e1114 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                                phi_1962_ = select(_e1129, _e1155, (select(select(_e947.member_1[2], _e1165, (_e1165 < _e947.member_1[2])), _e947.member_1[2], (_e1155 == 1023u)) <= _e887.member.z));
                            } else {
                                phi_1962_ = _e1129;
                            }
                            let _e1173 = phi_1962_;
                            phi_1963_ = _e1173;
                        } else {
                            phi_1963_ = _e1151;
                        }
                        let _e1175 = phi_1963_;
                        let _e1179 = bitcast<f32>((bitcast<u32>((_e1114 * 0.0009775171f)) ^ _e56));
                        let _e1185 = (_e944.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1175) * _e1179)) ^ _e56)));
                        if _e956 {
                            phi_2003_ = (((_e887.member_1.x - _e944.member[0]) / _e955) * 1023f);
                        } else {
                            phi_2003_ = 0f;
                        }
                        let _e1199 = phi_2003_;
                        let _e1201 = select(1023f, _e1199, (_e1199 < 1023f));
                        let _e1203 = select(0f, _e1201, (_e1201 > 0f));
                        let _e1208 = select(select(u32(_e1203), 0u, (_e1203 < 0f)), 4294967295u, (_e1203 > 4294967000f));
                        if (_e1208 > 0u) {
                            let _e1215 = (_e944.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1208) * _e1020)) ^ _e56)));
                            let _e1220 = (select(select(_e947.member_1[0], _e1215, (_e1215 < _e947.member_1[0])), _e947.member_1[0], (_e1208 == 1023u)) > _e887.member_1.x);
                            if _e1220 {
                                phi_2054_ = (_e1208 - 1u);
                            } else {
                                phi_2054_ = u32();
                            }
                            let _e1223 = phi_2054_;
                            phi_2056_ = _e1223;
                            phi_2057_ = select(true, false, _e1220);
                        } else {
                            phi_2056_ = u32();
                            phi_2057_ = true;
                        }
                        let _e1226 = phi_2056_;
                        let _e1228 = phi_2057_;
                        if _e1228 {
                            if (_e1208 < 1023u) {
                                let _e1230 = (_e1208 + 1u);
                                let _e1236 = (_e944.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1230) * _e1020)) ^ _e56)));
                                phi_2095_ = select(_e1208, _e1230, (select(select(_e947.member_1[0], _e1236, (_e1236 < _e947.member_1[0])), _e947.member_1[0], (_e1230 == 1023u)) <= _e887.member_1.x));
                            } else {
                                phi_2095_ = _e1208;
                            }
                            let _e1244 = phi_2095_;
                            phi_2096_ = _e1244;
                        } else {
                            phi_2096_ = _e1226;
                        }
                        let _e1246 = phi_2096_;
                        let _e1252 = (_e944.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1246) * _e1020)) ^ _e56)));
                        let _e1258 = select(_e1246, 0u, (select(select(_e947.member_1[0], _e1252, (_e1252 < _e947.member_1[0])), _e947.member_1[0], (_e1246 == 1023u)) > _e887.member_1.x));
                        if (_e1258 < 1023u) {
                            let _e1265 = (_e944.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1258) * _e1020)) ^ _e56)));
                            let _e1270 = (select(select(_e947.member_1[0], _e1265, (_e1265 < _e947.member_1[0])), _e947.member_1[0], (_e1258 == 1023u)) < _e887.member_1.x);
                            if _e1270 {
                                phi_2157_ = (_e1258 + 1u);
                            } else {
                                phi_2157_ = u32();
                            }
                            let _e1273 = phi_2157_;
                            phi_2159_ = _e1273;
                            phi_2160_ = select(true, false, _e1270);
                        } else {
                            phi_2159_ = u32();
                            phi_2160_ = true;
                        }
                        let _e1276 = phi_2159_;
                        let _e1278 = phi_2160_;
                        let _e1279 = select(_e1276, _e1258, _e1278);
                        let _e1285 = (_e944.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1279) * _e1020)) ^ _e56)));
                        if _e1034 {
                            phi_2202_ = (((_e887.member_1.y - _e944.member[1]) / _e1033) * 1023f);
                        } else {
                            phi_2202_ = 0f;
                        }
                        let _e1296 = phi_2202_;
                        let _e1298 = select(1023f, _e1296, (_e1296 < 1023f));
                        let _e1300 = select(0f, _e1298, (_e1298 > 0f));
                        let _e1305 = select(select(u32(_e1300), 0u, (_e1300 < 0f)), 4294967295u, (_e1300 > 4294967000f));
                        if (_e1305 > 0u) {
                            let _e1312 = (_e944.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1305) * _e1098)) ^ _e56)));
                            let _e1317 = (select(select(_e947.member_1[1], _e1312, (_e1312 < _e947.member_1[1])), _e947.member_1[1], (_e1305 == 1023u)) > _e887.member_1.y);
                            if _e1317 {
                                phi_2253_ = (_e1305 - 1u);
                            } else {
                                phi_2253_ = u32();
                            }
                            let _e1320 = phi_2253_;
                            phi_2255_ = _e1320;
                            phi_2256_ = select(true, false, _e1317);
                        } else {
                            phi_2255_ = u32();
                            phi_2256_ = true;
                        }
                        let _e1323 = phi_2255_;
                        let _e1325 = phi_2256_;
                        if _e1325 {
                            if (_e1305 < 1023u) {
                                let _e1327 = (_e1305 + 1u);
                                let _e1333 = (_e944.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1327) * _e1098)) ^ _e56)));
                                phi_2294_ = select(_e1305, _e1327, (select(select(_e947.member_1[1], _e1333, (_e1333 < _e947.member_1[1])), _e947.member_1[1], (_e1327 == 1023u)) <= _e887.member_1.y));
                            } else {
                                phi_2294_ = _e1305;
                            }
                            let _e1341 = phi_2294_;
                            phi_2295_ = _e1341;
                        } else {
                            phi_2295_ = _e1323;
                        }
                        let _e1343 = phi_2295_;
                        let _e1349 = (_e944.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1343) * _e1098)) ^ _e56)));
                        let _e1355 = select(_e1343, 0u, (select(select(_e947.member_1[1], _e1349, (_e1349 < _e947.member_1[1])), _e947.member_1[1], (_e1343 == 1023u)) > _e887.member_1.y));
                        if (_e1355 < 1023u) {
                            let _e1362 = (_e944.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1355) * _e1098)) ^ _e56)));
                            let _e1367 = (select(select(_e947.member_1[1], _e1362, (_e1362 < _e947.member_1[1])), _e947.member_1[1], (_e1355 == 1023u)) < _e887.member_1.y);
                            if _e1367 {
                                phi_2356_ = (_e1355 + 1u);
                            } else {
                                phi_2356_ = u32();
                            }
                            let _e1370 = phi_2356_;
                            phi_2358_ = _e1370;
                            phi_2359_ = select(true, false, _e1367);
                        } else {
                            phi_2358_ = u32();
                            phi_2359_ = true;
                        }
                        let _e1373 = phi_2358_;
                        let _e1375 = phi_2359_;
                        let _e1376 = select(_e1373, _e1355, _e1375);
                        let _e1382 = (_e944.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1376) * _e1098)) ^ _e56)));
                        if _e1115 {
                            phi_2403_ = (((_e887.member_1.z - _e944.member[2]) / _e1114) * 1023f);
                        } else {
                            phi_2403_ = 0f;
                        }
                        let _e1396 = phi_2403_;
                        let _e1398 = select(1023f, _e1396, (_e1396 < 1023f));
                        let _e1400 = select(0f, _e1398, (_e1398 > 0f));
                        let _e1405 = select(select(u32(_e1400), 0u, (_e1400 < 0f)), 4294967295u, (_e1400 > 4294967000f));
                        if (_e1405 > 0u) {
                            let _e1412 = (_e944.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1405) * _e1179)) ^ _e56)));
                            let _e1417 = (select(select(_e947.member_1[2], _e1412, (_e1412 < _e947.member_1[2])), _e947.member_1[2], (_e1405 == 1023u)) > _e887.member_1.z);
                            if _e1417 {
                                phi_2454_ = (_e1405 - 1u);
                            } else {
                                phi_2454_ = u32();
                            }
                            let _e1420 = phi_2454_;
                            phi_2456_ = _e1420;
                            phi_2457_ = select(true, false, _e1417);
                        } else {
                            phi_2456_ = u32();
                            phi_2457_ = true;
                        }
                        let _e1423 = phi_2456_;
                        let _e1425 = phi_2457_;
                        if _e1425 {
                            if (_e1405 < 1023u) {
                                let _e1427 = (_e1405 + 1u);
                                let _e1433 = (_e944.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1427) * _e1179)) ^ _e56)));
                                phi_2495_ = select(_e1405, _e1427, (select(select(_e947.member_1[2], _e1433, (_e1433 < _e947.member_1[2])), _e947.member_1[2], (_e1427 == 1023u)) <= _e887.member_1.z));
                            } else {
                                phi_2495_ = _e1405;
                            }
                            let _e1441 = phi_2495_;
                            phi_2496_ = _e1441;
                        } else {
                            phi_2496_ = _e1423;
                        }
                        let _e1443 = phi_2496_;
                        let _e1449 = (_e944.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1443) * _e1179)) ^ _e56)));
                        let _e1455 = select(_e1443, 0u, (select(select(_e947.member_1[2], _e1449, (_e1449 < _e947.member_1[2])), _e947.member_1[2], (_e1443 == 1023u)) > _e887.member_1.z));
                        if (_e1455 < 1023u) {
                            let _e1462 = (_e944.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1455) * _e1179)) ^ _e56)));
                            let _e1467 = (select(select(_e947.member_1[2], _e1462, (_e1462 < _e947.member_1[2])), _e947.member_1[2], (_e1455 == 1023u)) < _e887.member_1.z);
                            if _e1467 {
                                phi_2557_ = (_e1455 + 1u);
                            } else {
                                phi_2557_ = u32();
                            }
                            let _e1470 = phi_2557_;
                            phi_2559_ = _e1470;
                            phi_2560_ = select(true, false, _e1467);
                        } else {
                            phi_2559_ = u32();
                            phi_2560_ = true;
                        }
                        let _e1473 = phi_2559_;
                        let _e1475 = phi_2560_;
                        let _e1476 = select(_e1473, _e1455, _e1475);
                        let _e1482 = (_e944.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1476) * _e1179)) ^ _e56)));
                        if _e956 {
                            phi_2613_ = (((_e918.member.x - _e944.member[0]) / _e955) * 1023f);
                        } else {
                            phi_2613_ = 0f;
                        }
                        let _e1497 = phi_2613_;
                        let _e1499 = select(1023f, _e1497, (_e1497 < 1023f));
                        let _e1501 = select(0f, _e1499, (_e1499 > 0f));
                        let _e1506 = select(select(u32(_e1501), 0u, (_e1501 < 0f)), 4294967295u, (_e1501 > 4294967000f));
                        if (_e1506 > 0u) {
                            let _e1513 = (_e944.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1506) * _e1020)) ^ _e56)));
                            let _e1518 = (select(select(_e947.member_1[0], _e1513, (_e1513 < _e947.member_1[0])), _e947.member_1[0], (_e1506 == 1023u)) > _e918.member.x);
                            if _e1518 {
                                phi_2664_ = (_e1506 - 1u);
                            } else {
                                phi_2664_ = u32();
                            }
                            let _e1521 = phi_2664_;
                            phi_2666_ = _e1521;
                            phi_2667_ = select(true, false, _e1518);
                        } else {
                            phi_2666_ = u32();
                            phi_2667_ = true;
                        }
                        let _e1524 = phi_2666_;
                        let _e1526 = phi_2667_;
                        if _e1526 {
                            if (_e1506 < 1023u) {
                                let _e1528 = (_e1506 + 1u);
                                let _e1534 = (_e944.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1528) * _e1020)) ^ _e56)));
                                phi_2705_ = select(_e1506, _e1528, (select(select(_e947.member_1[0], _e1534, (_e1534 < _e947.member_1[0])), _e947.member_1[0], (_e1528 == 1023u)) <= _e918.member.x));
                            } else {
                                phi_2705_ = _e1506;
                            }
                            let _e1542 = phi_2705_;
                            phi_2706_ = _e1542;
                        } else {
                            phi_2706_ = _e1524;
                        }
                        let _e1544 = phi_2706_;
                        let _e1550 = (_e944.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1544) * _e1020)) ^ _e56)));
                        if _e1034 {
                            phi_2744_ = (((_e918.member.y - _e944.member[1]) / _e1033) * 1023f);
                        } else {
                            phi_2744_ = 0f;
                        }
                        let _e1561 = phi_2744_;
                        let _e1563 = select(1023f, _e1561, (_e1561 < 1023f));
                        let _e1565 = select(0f, _e1563, (_e1563 > 0f));
                        let _e1570 = select(select(u32(_e1565), 0u, (_e1565 < 0f)), 4294967295u, (_e1565 > 4294967000f));
                        if (_e1570 > 0u) {
                            let _e1577 = (_e944.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1570) * _e1098)) ^ _e56)));
                            let _e1582 = (select(select(_e947.member_1[1], _e1577, (_e1577 < _e947.member_1[1])), _e947.member_1[1], (_e1570 == 1023u)) > _e918.member.y);
                            if _e1582 {
                                phi_2795_ = (_e1570 - 1u);
                            } else {
                                phi_2795_ = u32();
                            }
                            let _e1585 = phi_2795_;
                            phi_2797_ = _e1585;
                            phi_2798_ = select(true, false, _e1582);
                        } else {
                            phi_2797_ = u32();
                            phi_2798_ = true;
                        }
                        let _e1588 = phi_2797_;
                        let _e1590 = phi_2798_;
                        if _e1590 {
                            if (_e1570 < 1023u) {
                                let _e1592 = (_e1570 + 1u);
                                let _e1598 = (_e944.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1592) * _e1098)) ^ _e56)));
                                phi_2836_ = select(_e1570, _e1592, (select(select(_e947.member_1[1], _e1598, (_e1598 < _e947.member_1[1])), _e947.member_1[1], (_e1592 == 1023u)) <= _e918.member.y));
                            } else {
                                phi_2836_ = _e1570;
                            }
                            let _e1606 = phi_2836_;
                            phi_2837_ = _e1606;
                        } else {
                            phi_2837_ = _e1588;
                        }
                        let _e1608 = phi_2837_;
                        let _e1614 = (_e944.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1608) * _e1098)) ^ _e56)));
                        if _e1115 {
                            phi_2877_ = (((_e918.member.z - _e944.member[2]) / _e1114) * 1023f);
                        } else {
                            phi_2877_ = 0f;
                        }
                        let _e1628 = phi_2877_;
                        let _e1630 = select(1023f, _e1628, (_e1628 < 1023f));
                        let _e1632 = select(0f, _e1630, (_e1630 > 0f));
                        let _e1637 = select(select(u32(_e1632), 0u, (_e1632 < 0f)), 4294967295u, (_e1632 > 4294967000f));
                        if (_e1637 > 0u) {
                            let _e1644 = (_e944.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1637) * _e1179)) ^ _e56)));
                            let _e1649 = (select(select(_e947.member_1[2], _e1644, (_e1644 < _e947.member_1[2])), _e947.member_1[2], (_e1637 == 1023u)) > _e918.member.z);
                            if _e1649 {
                                phi_2928_ = (_e1637 - 1u);
                            } else {
                                phi_2928_ = u32();
                            }
                            let _e1652 = phi_2928_;
                            phi_2930_ = _e1652;
                            phi_2931_ = select(true, false, _e1649);
                        } else {
                            phi_2930_ = u32();
                            phi_2931_ = true;
                        }
                        let _e1655 = phi_2930_;
                        let _e1657 = phi_2931_;
                        if _e1657 {
                            if (_e1637 < 1023u) {
                                let _e1659 = (_e1637 + 1u);
                                let _e1665 = (_e944.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1659) * _e1179)) ^ _e56)));
                                phi_2969_ = select(_e1637, _e1659, (select(select(_e947.member_1[2], _e1665, (_e1665 < _e947.member_1[2])), _e947.member_1[2], (_e1659 == 1023u)) <= _e918.member.z));
                            } else {
                                phi_2969_ = _e1637;
                            }
                            let _e1673 = phi_2969_;
                            phi_2970_ = _e1673;
                        } else {
                            phi_2970_ = _e1655;
                        }
                        let _e1675 = phi_2970_;
                        let _e1681 = (_e944.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1675) * _e1179)) ^ _e56)));
                        if _e956 {
                            phi_3010_ = (((_e918.member_1.x - _e944.member[0]) / _e955) * 1023f);
                        } else {
                            phi_3010_ = 0f;
                        }
                        let _e1695 = phi_3010_;
                        let _e1697 = select(1023f, _e1695, (_e1695 < 1023f));
                        let _e1699 = select(0f, _e1697, (_e1697 > 0f));
                        let _e1704 = select(select(u32(_e1699), 0u, (_e1699 < 0f)), 4294967295u, (_e1699 > 4294967000f));
                        if (_e1704 > 0u) {
                            let _e1711 = (_e944.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1704) * _e1020)) ^ _e56)));
                            let _e1716 = (select(select(_e947.member_1[0], _e1711, (_e1711 < _e947.member_1[0])), _e947.member_1[0], (_e1704 == 1023u)) > _e918.member_1.x);
                            if _e1716 {
                                phi_3061_ = (_e1704 - 1u);
                            } else {
                                phi_3061_ = u32();
                            }
                            let _e1719 = phi_3061_;
                            phi_3063_ = _e1719;
                            phi_3064_ = select(true, false, _e1716);
                        } else {
                            phi_3063_ = u32();
                            phi_3064_ = true;
                        }
                        let _e1722 = phi_3063_;
                        let _e1724 = phi_3064_;
                        if _e1724 {
                            if (_e1704 < 1023u) {
                                let _e1726 = (_e1704 + 1u);
                                let _e1732 = (_e944.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1726) * _e1020)) ^ _e56)));
                                phi_3102_ = select(_e1704, _e1726, (select(select(_e947.member_1[0], _e1732, (_e1732 < _e947.member_1[0])), _e947.member_1[0], (_e1726 == 1023u)) <= _e918.member_1.x));
                            } else {
                                phi_3102_ = _e1704;
                            }
                            let _e1740 = phi_3102_;
                            phi_3103_ = _e1740;
                        } else {
                            phi_3103_ = _e1722;
                        }
                        let _e1742 = phi_3103_;
                        let _e1748 = (_e944.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1742) * _e1020)) ^ _e56)));
                        let _e1754 = select(_e1742, 0u, (select(select(_e947.member_1[0], _e1748, (_e1748 < _e947.member_1[0])), _e947.member_1[0], (_e1742 == 1023u)) > _e918.member_1.x));
                        if (_e1754 < 1023u) {
                            let _e1761 = (_e944.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1754) * _e1020)) ^ _e56)));
                            let _e1766 = (select(select(_e947.member_1[0], _e1761, (_e1761 < _e947.member_1[0])), _e947.member_1[0], (_e1754 == 1023u)) < _e918.member_1.x);
                            if _e1766 {
                                phi_3164_ = (_e1754 + 1u);
                            } else {
                                phi_3164_ = u32();
                            }
                            let _e1769 = phi_3164_;
                            phi_3166_ = _e1769;
                            phi_3167_ = select(true, false, _e1766);
                        } else {
                            phi_3166_ = u32();
                            phi_3167_ = true;
                        }
                        let _e1772 = phi_3166_;
                        let _e1774 = phi_3167_;
                        let _e1775 = select(_e1772, _e1754, _e1774);
                        let _e1781 = (_e944.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1775) * _e1020)) ^ _e56)));
                        if _e1034 {
                            phi_3209_ = (((_e918.member_1.y - _e944.member[1]) / _e1033) * 1023f);
                        } else {
                            phi_3209_ = 0f;
                        }
                        let _e1792 = phi_3209_;
                        let _e1794 = select(1023f, _e1792, (_e1792 < 1023f));
                        let _e1796 = select(0f, _e1794, (_e1794 > 0f));
                        let _e1801 = select(select(u32(_e1796), 0u, (_e1796 < 0f)), 4294967295u, (_e1796 > 4294967000f));
                        if (_e1801 > 0u) {
                            let _e1808 = (_e944.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1801) * _e1098)) ^ _e56)));
                            let _e1813 = (select(select(_e947.member_1[1], _e1808, (_e1808 < _e947.member_1[1])), _e947.member_1[1], (_e1801 == 1023u)) > _e918.member_1.y);
                            if _e1813 {
                                phi_3260_ = (_e1801 - 1u);
                            } else {
                                phi_3260_ = u32();
                            }
                            let _e1816 = phi_3260_;
                            phi_3262_ = _e1816;
                            phi_3263_ = select(true, false, _e1813);
                        } else {
                            phi_3262_ = u32();
                            phi_3263_ = true;
                        }
                        let _e1819 = phi_3262_;
                        let _e1821 = phi_3263_;
                        if _e1821 {
                            if (_e1801 < 1023u) {
                                let _e1823 = (_e1801 + 1u);
                                let _e1829 = (_e944.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1823) * _e1098)) ^ _e56)));
                                phi_3301_ = select(_e1801, _e1823, (select(select(_e947.member_1[1], _e1829, (_e1829 < _e947.member_1[1])), _e947.member_1[1], (_e1823 == 1023u)) <= _e918.member_1.y));
                            } else {
                                phi_3301_ = _e1801;
                            }
                            let _e1837 = phi_3301_;
                            phi_3302_ = _e1837;
                        } else {
                            phi_3302_ = _e1819;
                        }
                        let _e1839 = phi_3302_;
                        let _e1845 = (_e944.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1839) * _e1098)) ^ _e56)));
                        let _e1851 = select(_e1839, 0u, (select(select(_e947.member_1[1], _e1845, (_e1845 < _e947.member_1[1])), _e947.member_1[1], (_e1839 == 1023u)) > _e918.member_1.y));
                        if (_e1851 < 1023u) {
                            let _e1858 = (_e944.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1851) * _e1098)) ^ _e56)));
                            let _e1863 = (select(select(_e947.member_1[1], _e1858, (_e1858 < _e947.member_1[1])), _e947.member_1[1], (_e1851 == 1023u)) < _e918.member_1.y);
                            if _e1863 {
                                phi_3363_ = (_e1851 + 1u);
                            } else {
                                phi_3363_ = u32();
                            }
                            let _e1866 = phi_3363_;
                            phi_3365_ = _e1866;
                            phi_3366_ = select(true, false, _e1863);
                        } else {
                            phi_3365_ = u32();
                            phi_3366_ = true;
                        }
                        let _e1869 = phi_3365_;
                        let _e1871 = phi_3366_;
                        let _e1872 = select(_e1869, _e1851, _e1871);
                        let _e1878 = (_e944.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1872) * _e1098)) ^ _e56)));
                        if _e1115 {
                            phi_3410_ = (((_e918.member_1.z - _e944.member[2]) / _e1114) * 1023f);
                        } else {
                            phi_3410_ = 0f;
                        }
                        let _e1892 = phi_3410_;
                        let _e1894 = select(1023f, _e1892, (_e1892 < 1023f));
                        let _e1896 = select(0f, _e1894, (_e1894 > 0f));
                        let _e1901 = select(select(u32(_e1896), 0u, (_e1896 < 0f)), 4294967295u, (_e1896 > 4294967000f));
                        if (_e1901 > 0u) {
                            let _e1908 = (_e944.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1901) * _e1179)) ^ _e56)));
                            let _e1913 = (select(select(_e947.member_1[2], _e1908, (_e1908 < _e947.member_1[2])), _e947.member_1[2], (_e1901 == 1023u)) > _e918.member_1.z);
                            if _e1913 {
                                phi_3461_ = (_e1901 - 1u);
                            } else {
                                phi_3461_ = u32();
                            }
                            let _e1916 = phi_3461_;
                            phi_3463_ = _e1916;
                            phi_3464_ = select(true, false, _e1913);
                        } else {
                            phi_3463_ = u32();
                            phi_3464_ = true;
                        }
                        let _e1919 = phi_3463_;
                        let _e1921 = phi_3464_;
                        if _e1921 {
                            if (_e1901 < 1023u) {
                                let _e1923 = (_e1901 + 1u);
                                let _e1929 = (_e944.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1923) * _e1179)) ^ _e56)));
                                phi_3502_ = select(_e1901, _e1923, (select(select(_e947.member_1[2], _e1929, (_e1929 < _e947.member_1[2])), _e947.member_1[2], (_e1923 == 1023u)) <= _e918.member_1.z));
                            } else {
                                phi_3502_ = _e1901;
                            }
                            let _e1937 = phi_3502_;
                            phi_3503_ = _e1937;
                        } else {
                            phi_3503_ = _e1919;
                        }
                        let _e1939 = phi_3503_;
                        let _e1945 = (_e944.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1939) * _e1179)) ^ _e56)));
                        let _e1951 = select(_e1939, 0u, (select(select(_e947.member_1[2], _e1945, (_e1945 < _e947.member_1[2])), _e947.member_1[2], (_e1939 == 1023u)) > _e918.member_1.z));
                        if (_e1951 < 1023u) {
                            let _e1958 = (_e944.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1951) * _e1179)) ^ _e56)));
                            let _e1963 = (select(select(_e947.member_1[2], _e1958, (_e1958 < _e947.member_1[2])), _e947.member_1[2], (_e1951 == 1023u)) < _e918.member_1.z);
                            if _e1963 {
                                phi_3564_ = (_e1951 + 1u);
                            } else {
                                phi_3564_ = u32();
                            }
                            let _e1966 = phi_3564_;
                            phi_3566_ = _e1966;
                            phi_3567_ = select(true, false, _e1963);
                        } else {
                            phi_3566_ = u32();
                            phi_3567_ = true;
                        }
                        let _e1969 = phi_3566_;
                        let _e1971 = phi_3567_;
                        let _e1972 = select(_e1969, _e1951, _e1971);
                        let _e1978 = (_e944.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1972) * _e1179)) ^ _e56)));
                        if _e53 {
                        } else {
                            break;
                        }
                        global_4.member[_e47] = type_30(array<u32, 2>(((select(_e1016, 0u, (select(select(_e947.member_1[0], _e1026, (_e1026 < _e947.member_1[0])), _e947.member_1[0], (_e1016 == 1023u)) > _e887.member.x)) | (select(_e1094, 0u, (select(select(_e947.member_1[1], _e1104, (_e1104 < _e947.member_1[1])), _e947.member_1[1], (_e1094 == 1023u)) > _e887.member.y)) << bitcast<u32>(10i))) | (select(_e1175, 0u, (select(select(_e947.member_1[2], _e1185, (_e1185 < _e947.member_1[2])), _e947.member_1[2], (_e1175 == 1023u)) > _e887.member.z)) << bitcast<u32>(20i))), ((select(_e1279, 1023u, (select(select(_e947.member_1[0], _e1285, (_e1285 < _e947.member_1[0])), _e947.member_1[0], (_e1279 == 1023u)) < _e887.member_1.x)) | (select(_e1376, 1023u, (select(select(_e947.member_1[1], _e1382, (_e1382 < _e947.member_1[1])), _e947.member_1[1], (_e1376 == 1023u)) < _e887.member_1.y)) << bitcast<u32>(10i))) | (select(_e1476, 1023u, (select(select(_e947.member_1[2], _e1482, (_e1482 < _e947.member_1[2])), _e947.member_1[2], (_e1476 == 1023u)) < _e887.member_1.z)) << bitcast<u32>(20i)))), array<u32, 2>(((select(_e1544, 0u, (select(select(_e947.member_1[0], _e1550, (_e1550 < _e947.member_1[0])), _e947.member_1[0], (_e1544 == 1023u)) > _e918.member.x)) | (select(_e1608, 0u, (select(select(_e947.member_1[1], _e1614, (_e1614 < _e947.member_1[1])), _e947.member_1[1], (_e1608 == 1023u)) > _e918.member.y)) << bitcast<u32>(10i))) | (select(_e1675, 0u, (select(select(_e947.member_1[2], _e1681, (_e1681 < _e947.member_1[2])), _e947.member_1[2], (_e1675 == 1023u)) > _e918.member.z)) << bitcast<u32>(20i))), ((select(_e1775, 1023u, (select(select(_e947.member_1[0], _e1781, (_e1781 < _e947.member_1[0])), _e947.member_1[0], (_e1775 == 1023u)) < _e918.member_1.x)) | (select(_e1872, 1023u, (select(select(_e947.member_1[1], _e1878, (_e1878 < _e947.member_1[1])), _e947.member_1[1], (_e1872 == 1023u)) < _e918.member_1.y)) << bitcast<u32>(10i))) | (select(_e1972, 1023u, (select(select(_e947.member_1[2], _e1978, (_e1978 < _e947.member_1[2])), _e947.member_1[2], (_e1972 == 1023u)) < _e918.member_1.z)) << bitcast<u32>(20i)))), _e860, _e891);
                        if (_e47 == 0u) {
                            if (_e43 == 0u) {
                            } else {
                                if (0u < _e43) {
                                } else {
                                    break;
                                }
                                global_5.member[0u] = type_25(array<u32, 4>(bitcast<u32>(_e944.member[0]), bitcast<u32>(_e944.member[1]), bitcast<u32>(_e944.member[2]), 0u), array<u32, 4>(bitcast<u32>(_e947.member_1[0]), bitcast<u32>(_e947.member_1[1]), bitcast<u32>(_e947.member_1[2]), 0u));
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
fn encode_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
