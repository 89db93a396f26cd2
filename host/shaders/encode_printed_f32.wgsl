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
    var phi_916_: f32;
    var phi_967_: u32;
    var phi_969_: u32;
    var phi_970_: bool;
    var phi_1008_: u32;
    var phi_1009_: u32;
    var phi_1070_: u32;
    var phi_1072_: u32;
    var phi_1073_: bool;
    var phi_1089_: f32;
    var phi_1140_: u32;
    var phi_1142_: u32;
    var phi_1143_: bool;
    var phi_1181_: u32;
    var phi_1182_: u32;
    var phi_1243_: u32;
    var phi_1245_: u32;
    var phi_1246_: bool;
    var phi_1438_: type_34;
    var phi_1439_: u32;
    var phi_229_: type_34;
    var phi_231_: u32;
    var phi_1441_: bool;
    var phi_3398_: bool;
    var phi_1469_: type_24;
    var phi_1491_: type_24;
    var local: type_34;
    var local_1: type_34;
    var phi_1522_: f32;
    var phi_1573_: u32;
    var phi_1575_: u32;
    var phi_1576_: bool;
    var phi_1614_: u32;
    var phi_1615_: u32;
    var phi_1653_: f32;
    var phi_1704_: u32;
    var phi_1706_: u32;
    var phi_1707_: bool;
    var phi_1745_: u32;
    var phi_1746_: u32;
    var phi_1786_: f32;
    var phi_1837_: u32;
    var phi_1839_: u32;
    var phi_1840_: bool;
    var phi_1878_: u32;
    var phi_1879_: u32;
    var phi_1919_: f32;
    var phi_1970_: u32;
    var phi_1972_: u32;
    var phi_1973_: bool;
    var phi_2011_: u32;
    var phi_2012_: u32;
    var phi_2073_: u32;
    var phi_2075_: u32;
    var phi_2076_: bool;
    var phi_2090_: f32;
    var phi_2141_: u32;
    var phi_2143_: u32;
    var phi_2144_: bool;
    var phi_2182_: u32;
    var phi_2183_: u32;
    var phi_2244_: u32;
    var phi_2246_: u32;
    var phi_2247_: bool;
    var phi_2263_: f32;
    var phi_2314_: u32;
    var phi_2316_: u32;
    var phi_2317_: bool;
    var phi_2355_: u32;
    var phi_2356_: u32;
    var phi_2417_: u32;
    var phi_2419_: u32;
    var phi_2420_: bool;
    var phi_2445_: f32;
    var phi_2496_: u32;
    var phi_2498_: u32;
    var phi_2499_: bool;
    var phi_2537_: u32;
    var phi_2538_: u32;
    var phi_2576_: f32;
    var phi_2627_: u32;
    var phi_2629_: u32;
    var phi_2630_: bool;
    var phi_2668_: u32;
    var phi_2669_: u32;
    var phi_2709_: f32;
    var phi_2760_: u32;
    var phi_2762_: u32;
    var phi_2763_: bool;
    var phi_2801_: u32;
    var phi_2802_: u32;
    var phi_2842_: f32;
    var phi_2893_: u32;
    var phi_2895_: u32;
    var phi_2896_: bool;
    var phi_2934_: u32;
    var phi_2935_: u32;
    var phi_2996_: u32;
    var phi_2998_: u32;
    var phi_2999_: bool;
    var phi_3013_: f32;
    var phi_3064_: u32;
    var phi_3066_: u32;
    var phi_3067_: bool;
    var phi_3105_: u32;
    var phi_3106_: u32;
    var phi_3167_: u32;
    var phi_3169_: u32;
    var phi_3170_: bool;
    var phi_3186_: f32;
    var phi_3237_: u32;
    var phi_3239_: u32;
    var phi_3240_: bool;
    var phi_3278_: u32;
    var phi_3279_: u32;
    var phi_3340_: u32;
    var phi_3342_: u32;
    var phi_3343_: bool;

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
                                    phi_1438_ = type_34();
                                    phi_1439_ = u32();
                                } else {
                                    let _e157 = (_e137 < _e39);
                                    if _e157 {
                                        if _e157 {
                                        } else {
                                            phi_3398_ = true;
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
                                    if _e307 {
                                        phi_916_ = (((_e207.member_1.y - _e135.member[1]) / _e306) * 1023f);
                                    } else {
                                        phi_916_ = 0f;
                                    }
                                    let _e557 = phi_916_;
                                    let _e559 = select(1023f, _e557, (_e557 < 1023f));
                                    let _e561 = select(0f, _e559, (_e559 > 0f));
                                    let _e566 = select(select(u32(_e561), 0u, (_e561 < 0f)), 4294967295u, (_e561 > 4294967000f));
                                    if (_e566 > 0u) {
                                        let _e573 = (_e135.member[1] + bitcast<f32>((bitcast<u32>((f32(_e566) * _e371)) ^ _e56)));
                                        let _e578 = (select(select(_e135.member_1[1], _e573, (_e573 < _e135.member_1[1])), _e135.member_1[1], (_e566 == 1023u)) > _e207.member_1.y);
                                        if _e578 {
                                            phi_967_ = (_e566 - 1u);
                                        } else {
                                            phi_967_ = u32();
                                        }
                                        let _e581 = phi_967_;
                                        phi_969_ = _e581;
                                        phi_970_ = select(true, false, _e578);
                                    } else {
                                        phi_969_ = u32();
                                        phi_970_ = true;
                                    }
                                    let _e584 = phi_969_;
                                    let _e586 = phi_970_;
                                    if _e586 {
                                        if (_e566 < 1023u) {
                                            let _e588 = (_e566 + 1u);
                                            let _e594 = (_e135.member[1] + bitcast<f32>((bitcast<u32>((f32(_e588) * _e371)) ^ _e56)));
                                            phi_1008_ = select(_e566, _e588, (select(select(_e135.member_1[1], _e594, (_e594 < _e135.member_1[1])), _e135.member_1[1], (_e588 == 1023u)) <= _e207.member_1.y));
                                        } else {
                                            phi_1008_ = _e566;
                                        }
                                        let _e602 = phi_1008_;
                                        phi_1009_ = _e602;
                                    } else {
                                        phi_1009_ = _e584;
                                    }
                                    let _e604 = phi_1009_;
                                    let _e610 = (_e135.member[1] + bitcast<f32>((bitcast<u32>((f32(_e604) * _e371)) ^ _e56)));
                                    let _e616 = select(_e604, 0u, (select(select(_e135.member_1[1], _e610, (_e610 < _e135.member_1[1])), _e135.member_1[1], (_e604 == 1023u)) > _e207.member_1.y));
                                    if (_e616 < 1023u) {
                                        let _e623 = (_e135.member[1] + bitcast<f32>((bitcast<u32>((f32(_e616) * _e371)) ^ _e56)));
                                        let _e628 = (select(select(_e135.member_1[1], _e623, (_e623 < _e135.member_1[1])), _e135.member_1[1], (_e616 == 1023u)) < _e207.member_1.y);
                                        if _e628 {
                                            phi_1070_ = (_e616 + 1u);
                                        } else {
                                            phi_1070_ = u32();
                                        }
                                        let _e631 = phi_1070_;
                                        phi_1072_ = _e631;
                                        phi_1073_ = select(true, false, _e628);
                                    } else {
                                        phi_1072_ = u32();
                                        phi_1073_ = true;
                                    }
                                    let _e634 = phi_1072_;
                                    let _e636 = phi_1073_;
                                    if _e388 {
                                        phi_1089_ = (((_e207.member_1.z - _e135.member[2]) / _e387) * 1023f);
                                    } else {
                                        phi_1089_ = 0f;
                                    }
                                    let _e645 = phi_1089_;
                                    let _e647 = select(1023f, _e645, (_e645 < 1023f));
                                    let _e649 = select(0f, _e647, (_e647 > 0f));
                                    let _e654 = select(select(u32(_e649), 0u, (_e649 < 0f)), 4294967295u, (_e649 > 4294967000f));
                                    if (_e654 > 0u) {
                                        let _e661 = (_e135.member[2] + bitcast<f32>((bitcast<u32>((f32(_e654) * _e452)) ^ _e56)));
                                        let _e666 = (select(select(_e135.member_1[2], _e661, (_e661 < _e135.member_1[2])), _e135.member_1[2], (_e654 == 1023u)) > _e207.member_1.z);
                                        if _e666 {
                                            phi_1140_ = (_e654 - 1u);
                                        } else {
                                            phi_1140_ = u32();
                                        }
                                        let _e669 = phi_1140_;
                                        phi_1142_ = _e669;
                                        phi_1143_ = select(true, false, _e666);
                                    } else {
                                        phi_1142_ = u32();
                                        phi_1143_ = true;
                                    }
                                    let _e672 = phi_1142_;
                                    let _e674 = phi_1143_;
                                    if _e674 {
                                        if (_e654 < 1023u) {
                                            let _e676 = (_e654 + 1u);
                                            let _e682 = (_e135.member[2] + bitcast<f32>((bitcast<u32>((f32(_e676) * _e452)) ^ _e56)));
                                            phi_1181_ = select(_e654, _e676, (select(select(_e135.member_1[2], _e682, (_e682 < _e135.member_1[2])), _e135.member_1[2], (_e676 == 1023u)) <= _e207.member_1.z));
                                        } else {
                                            phi_1181_ = _e654;
                                        }
                                        let _e690 = phi_1181_;
                                        phi_1182_ = _e690;
                                    } else {
                                        phi_1182_ = _e672;
                                    }
                                    let _e692 = phi_1182_;
                                    let _e698 = (_e135.member[2] + bitcast<f32>((bitcast<u32>((f32(_e692) * _e452)) ^ _e56)));
                                    let _e704 = select(_e692, 0u, (select(select(_e135.member_1[2], _e698, (_e698 < _e135.member_1[2])), _e135.member_1[2], (_e692 == 1023u)) > _e207.member_1.z));
                                    if (_e704 < 1023u) {
                                        let _e711 = (_e135.member[2] + bitcast<f32>((bitcast<u32>((f32(_e704) * _e452)) ^ _e56)));
                                        let _e716 = (select(select(_e135.member_1[2], _e711, (_e711 < _e135.member_1[2])), _e135.member_1[2], (_e704 == 1023u)) < _e207.member_1.z);
                                        if _e716 {
                                            phi_1243_ = (_e704 + 1u);
                                        } else {
                                            phi_1243_ = u32();
                                        }
                                        let _e719 = phi_1243_;
                                        phi_1245_ = _e719;
                                        phi_1246_ = select(true, false, _e716);
                                    } else {
                                        phi_1245_ = u32();
                                        phi_1246_ = true;
                                    }
                                    let _e722 = phi_1245_;
                                    let _e724 = phi_1246_;
                                    let _e728 = ((select(_e549, _e531, _e551) | (select(_e634, _e616, _e636) << bitcast<u32>(10i))) | (select(_e722, _e704, _e724) << bitcast<u32>(20i)));
                                    let _e729 = (_e467 & 1023u);
                                    let _e735 = (_e135.member[0] + bitcast<f32>((bitcast<u32>((f32(_e729) * _e293)) ^ _e56)));
                                    let _e742 = ((_e467 >> bitcast<u32>(10u)) & 1023u);
                                    let _e748 = (_e135.member[1] + bitcast<f32>((bitcast<u32>((f32(_e742) * _e371)) ^ _e56)));
                                    let _e755 = ((_e467 >> bitcast<u32>(20u)) & 1023u);
                                    let _e761 = (_e135.member[2] + bitcast<f32>((bitcast<u32>((f32(_e755) * _e452)) ^ _e56)));
                                    let _e767 = (_e728 & 1023u);
                                    let _e773 = (_e135.member[0] + bitcast<f32>((bitcast<u32>((f32(_e767) * _e293)) ^ _e56)));
                                    let _e780 = ((_e728 >> bitcast<u32>(10u)) & 1023u);
                                    let _e786 = (_e135.member[1] + bitcast<f32>((bitcast<u32>((f32(_e780) * _e371)) ^ _e56)));
                                    let _e793 = ((_e728 >> bitcast<u32>(20u)) & 1023u);
                                    let _e799 = (_e135.member[2] + bitcast<f32>((bitcast<u32>((f32(_e793) * _e452)) ^ _e56)));
                                    phi_1438_ = type_34(array<f32, 3>(select(select(_e135.member_1[0], _e735, (_e735 < _e135.member_1[0])), _e135.member_1[0], (_e729 == 1023u)), select(select(_e135.member_1[1], _e748, (_e748 < _e135.member_1[1])), _e135.member_1[1], (_e742 == 1023u)), select(select(_e135.member_1[2], _e761, (_e761 < _e135.member_1[2])), _e135.member_1[2], (_e755 == 1023u))), array<f32, 3>(select(select(_e135.member_1[0], _e773, (_e773 < _e135.member_1[0])), _e135.member_1[0], (_e767 == 1023u)), select(select(_e135.member_1[1], _e786, (_e786 < _e135.member_1[1])), _e135.member_1[1], (_e780 == 1023u)), select(select(_e135.member_1[2], _e799, (_e799 < _e135.member_1[2])), _e135.member_1[2], (_e793 == 1023u))));
                                    phi_1439_ = select(_e162.member_2, _e162.member_1, _e169);
                                }
                                let _e808 = phi_1438_;
                                let _e810 = phi_1439_;
                                phi_229_ = _e808;
                                phi_231_ = _e810;
                                phi_1441_ = select(true, false, _e156);
                            } else {
                                phi_229_ = type_34();
                                phi_231_ = u32();
                                phi_1441_ = false;
                            }
                            let _e813 = phi_229_;
                            let _e815 = phi_231_;
                            let _e817 = phi_1441_;
                            continue;
                            continuing {
                                phi_225_ = _e150;
                                phi_228_ = _e813;
                                phi_230_ = _e815;
                                phi_3398_ = false;
                                break if !(_e817);
                            }
                        }
                        let _e820 = phi_3398_;
                        if _e820 {
                            break;
                        }
                        if _e52 {
                        } else {
                            break;
                        }
                        let _e824 = global_3.member[_e47].member_1;
                        if (_e824 == 2147483648u) {
                            phi_1469_ = type_24(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            let _e830 = global_3.member[_e47].member[0u];
                            let _e835 = global_3.member[_e47].member[1u];
                            let _e840 = global_3.member[_e47].member[2u];
                            phi_1469_ = type_24(vec3<f32>(_e830[0], _e835[0], _e840[0]), vec3<f32>(_e830[2], _e835[2], _e840[2]));
                        }
                        let _e851 = phi_1469_;
                        let _e855 = global_3.member[_e47].member_2;
                        if (_e855 == 2147483648u) {
                            phi_1491_ = _e851;
                        } else {
                            let _e861 = global_3.member[_e47].member[0u];
                            let _e866 = global_3.member[_e47].member[1u];
                            let _e871 = global_3.member[_e47].member[2u];
                            phi_1491_ = type_24(vec3<f32>(_e861[1], _e866[1], _e871[1]), vec3<f32>(_e861[3], _e866[3], _e871[3]));
                        }
                        let _e882 = phi_1491_;
                        let _e908 = local;
                        let _e911 = local_1;
                        let _e919 = (_e911.member_1[0] - _e908.member[0]);
                        let _e920 = (_e919 > 0f);
                        if _e920 {
                            phi_1522_ = (((_e851.member.x - _e908.member[0]) / _e919) * 1023f);
                        } else {
                            phi_1522_ = 0f;
                        }
                        let _e925 = phi_1522_;
                        let _e927 = select(1023f, _e925, (_e925 < 1023f));
                        let _e929 = select(0f, _e927, (_e927 > 0f));
                        let _e934 = select(select(u32(_e929), 0u, (_e929 < 0f)), 4294967295u, (_e929 > 4294967000f));
                        if (_e934 > 0u) {
                            let _e945 = (_e908.member[0] + bitcast<f32>((bitcast<u32>((f32(_e934) * bitcast<f32>((bitcast<u32>((_e919 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                            let _e950 = (select(select(_e911.member_1[0], _e945, (_e945 < _e911.member_1[0])), _e911.member_1[0], (_e934 == 1023u)) > _e851.member.x);
                            if _e950 {
                                phi_1573_ = (_e934 - 1u);
                            } else {
                                phi_1573_ = u32();
                            }
                            let _e953 = phi_1573_;
                            phi_1575_ = _e953;
                            phi_1576_ = select(true, false, _e950);
                        } else {
                            phi_1575_ = u32();
                            phi_1576_ = true;
                        }
                        let _e956 = phi_1575_;
                        let _e958 = phi_1576_;
                        if _e958 {
                            if (_e934 < 1023u) {
                                let _e960 = (_e934 + 1u);
                                let _e970 = (_e908.member[0] + bitcast<f32>((bitcast<u32>((f32(_e960) * bitcast<f32>((bitcast<u32>((_e919 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                                phi_1614_ = select(_e934, _e960, (select(select(_e911.member_1[0], _e970, (_e970 < _e911.member_1[0])), _e911.member_1[0], (_e960 == 1023u)) <= _e851.member.x));
                            } else {
                                phi_1614_ = _e934;
                            }
                            let _e978 = phi_1614_;
                            phi_1615_ = _e978;
                        } else {
                            phi_1615_ = _e956;
                        }
                        let _e980 = phi_1615_;
                        let _e984 = bitcast<f32>((bitcast<u32>((_e919 * 0.0009775171f)) ^ _e56));
                        let _e990 = (_e908.member[0] + bitcast<f32>((bitcast<u32>((f32(_e980) * _e984)) ^ _e56)));
                        let _e997 = (_e911.member_1[1] - _e908.member[1]);
                        let _e998 = (_e997 > 0f);
                        if _e998 {
                            phi_1653_ = (((_e851.member.y - _e908.member[1]) / _e997) * 1023f);
                        } else {
                            phi_1653_ = 0f;
                        }
                        let _e1003 = phi_1653_;
                        let _e1005 = select(1023f, _e1003, (_e1003 < 1023f));
                        let _e1007 = select(0f, _e1005, (_e1005 > 0f));
                        let _e1012 = select(select(u32(_e1007), 0u, (_e1007 < 0f)), 4294967295u, (_e1007 > 4294967000f));
                        if (_e1012 > 0u) {
                            let _e1023 = (_e908.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1012) * bitcast<f32>((bitcast<u32>((_e997 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                            let _e1028 = (select(select(_e911.member_1[1], _e1023, (_e1023 < _e911.member_1[1])), _e911.member_1[1], (_e1012 == 1023u)) > _e851.member.y);
                            if _e1028 {
                                phi_1704_ = (_e1012 - 1u);
                            } else {
                                phi_1704_ = u32();
                            }
                            let _e1031 = phi_1704_;
                            phi_1706_ = _e1031;
                            phi_1707_ = select(true, false, _e1028);
                        } else {
                            phi_1706_ = u32();
                            phi_1707_ = true;
                        }
                        let _e1034 = phi_1706_;
                        let _e1036 = phi_1707_;
                        if _e1036 {
                            if (_e1012 < 1023u) {
                                let _e1038 = (_e1012 + 1u);
                                let _e1048 = (_e908.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1038) * bitcast<f32>((bitcast<u32>((_e997 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                                phi_1745_ = select(_e1012, _e1038, (select(select(_e911.member_1[1], _e1048, (_e1048 < _e911.member_1[1])), _e911.member_1[1], (_e1038 == 1023u)) <= _e851.member.y));
                            } else {
                                phi_1745_ = _e1012;
                            }
                            let _e1056 = phi_1745_;
                            phi_1746_ = _e1056;
                        } else {
                            phi_1746_ = _e1034;
                        }
                        let _e1058 = phi_1746_;
                        let _e1062 = bitcast<f32>((bitcast<u32>((_e997 * 0.0009775171f)) ^ _e56));
                        let _e1068 = (_e908.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1058) * _e1062)) ^ _e56)));
                        let _e1078 = (_e911.member_1[2] - _e908.member[2]);
                        let _e1079 = (_e1078 > 0f);
                        if _e1079 {
                            phi_1786_ = (((_e851.member.z - _e908.member[2]) / _e1078) * 1023f);
                        } else {
                            phi_1786_ = 0f;
                        }
                        let _e1084 = phi_1786_;
                        let _e1086 = select(1023f, _e1084, (_e1084 < 1023f));
                        let _e1088 = select(0f, _e1086, (_e1086 > 0f));
                        let _e1093 = select(select(u32(_e1088), 0u, (_e1088 < 0f)), 4294967295u, (_e1088 > 4294967000f));
                        if (_e1093 > 0u) {
                            let _e1104 = (_e908.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1093) * bitcast<f32>((bitcast<u32>((_e1078 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                            let _e1109 = (select(select(_e911.member_1[2], _e1104, (_e1104 < _e911.member_1[2])), _e911.member_1[2], (_e1093 == 1023u)) > _e851.member.z);
                            if _e1109 {
                                phi_1837_ = (_e1093 - 1u);
                            } else {
                                phi_1837_ = u32();
                            }
                            let _e1112 = phi_1837_;
                            phi_1839_ = _e1112;
                            phi_1840_ = select(true, false, _e1109);
                        } else {
                            phi_1839_ = u32();
                            phi_1840_ = true;
                        }
                        let _e1115 = phi_1839_;
                        let _e1117 = phi_1840_;
                        if _e1117 {
                            if (_e1093 < 1023u) {
                                let _e1119 = (_e1093 + 1u);
                                let _e1129 = (_e908.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1119) * bitcast<f32>((bitcast<u32>((_e1078 * 0.0009775171f)) ^ _e56)))) ^ _e56)));
                                phi_1878_ = select(_e1093, _e1119, (select(select(_e911.member_1[2], _e1129, (_e1129 < _e911.member_1[2])), _e911.member_1[2], (_e1119 == 1023u)) <= _e851.member.z));
                            } else {
                                phi_1878_ = _e1093;
                            }
                            let _e1137 = phi_1878_;
                            phi_1879_ = _e1137;
                        } else {
                            phi_1879_ = _e1115;
                        }
                        let _e1139 = phi_1879_;
                        let _e1143 = bitcast<f32>((bitcast<u32>((_e1078 * 0.0009775171f)) ^ _e56));
                        let _e1149 = (_e908.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1139) * _e1143)) ^ _e56)));
                        if _e920 {
                            phi_1919_ = (((_e851.member_1.x - _e908.member[0]) / _e919) * 1023f);
                        } else {
                            phi_1919_ = 0f;
                        }
                        let _e1163 = phi_1919_;
                        let _e1165 = select(1023f, _e1163, (_e1163 < 1023f));
                        let _e1167 = select(0f, _e1165, (_e1165 > 0f));
                        let _e1172 = select(select(u32(_e1167), 0u, (_e1167 < 0f)), 4294967295u, (_e1167 > 4294967000f));
                        if (_e1172 > 0u) {
                            let _e1179 = (_e908.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1172) * _e984)) ^ _e56)));
                            let _e1184 = (select(select(_e911.member_1[0], _e1179, (_e1179 < _e911.member_1[0])), _e911.member_1[0], (_e1172 == 1023u)) > _e851.member_1.x);
                            if _e1184 {
                                phi_1970_ = (_e1172 - 1u);
                            } else {
                                phi_1970_ = u32();
                            }
                            let _e1187 = phi_1970_;
                            phi_1972_ = _e1187;
                            phi_1973_ = select(true, false, _e1184);
                        } else {
                            phi_1972_ = u32();
                            phi_1973_ = true;
                        }
                        let _e1190 = phi_1972_;
                        let _e1192 = phi_1973_;
                        if _e1192 {
                            if (_e1172 < 1023u) {
                                let _e1194 = (_e1172 + 1u);
                                let _e1200 = (_e908.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1194) * _e984)) ^ _e56)));
                                phi_2011_ = select(_e1172, _e1194, (select(select(_e911.member_1[0], _e1200, (_e1200 < _e911.member_1[0])), _e911.member_1[0], (_e1194 == 1023u)) <= _e851.member_1.x));
                            } else {
                                phi_2011_ = _e1172;
                            }
                            let _e1208 = phi_2011_;
                            phi_2012_ = _e1208;
                        } else {
                            phi_2012_ = _e1190;
                        }
                        let _e1210 = phi_2012_;
                        let _e1216 = (_e908.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1210) * _e984)) ^ _e56)));
                        let _e1222 = select(_e1210, 0u, (select(select(_e911.member_1[0], _e1216, (_e1216 < _e911.member_1[0])), _e911.member_1[0], (_e1210 == 1023u)) > _e851.member_1.x));
                        if (_e1222 < 1023u) {
                            let _e1229 = (_e908.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1222) * _e984)) ^ _e56)));
                            let _e1234 = (select(select(_e911.member_1[0], _e1229, (_e1229 < _e911.member_1[0])), _e911.member_1[0], (_e1222 == 1023u)) < _e851.member_1.x);
                            if _e1234 {
                                phi_2073_ = (_e1222 + 1u);
                            } else {
                                phi_2073_ = u32();
                            }
                            let _e1237 = phi_2073_;
                            phi_2075_ = _e1237;
                            phi_2076_ = select(true, false, _e1234);
                        } else {
                            phi_2075_ = u32();
                            phi_2076_ = true;
                        }
                        let _e1240 = phi_2075_;
                        let _e1242 = phi_2076_;
                        if _e998 {
                            phi_2090_ = (((_e851.member_1.y - _e908.member[1]) / _e997) * 1023f);
                        } else {
                            phi_2090_ = 0f;
                        }
                        let _e1248 = phi_2090_;
                        let _e1250 = select(1023f, _e1248, (_e1248 < 1023f));
                        let _e1252 = select(0f, _e1250, (_e1250 > 0f));
                        let _e1257 = select(select(u32(_e1252), 0u, (_e1252 < 0f)), 4294967295u, (_e1252 > 4294967000f));
                        if (_e1257 > 0u) {
                            let _e1264 = (_e908.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1257) * _e1062)) ^ _e56)));
                            let _e1269 = (select(select(_e911.member_1[1], _e1264, (_e1264 < _e911.member_1[1])), _e911.member_1[1], (_e1257 == 1023u)) > _e851.member_1.y);
                            if _e1269 {
                                phi_2141_ = (_e1257 - 1u);
                            } else {
                                phi_2141_ = u32();
                            }
                            let _e1272 = phi_2141_;
                            phi_2143_ = _e1272;
                            phi_2144_ = select(true, false, _e1269);
                        } else {
                            phi_2143_ = u32();
                            phi_2144_ = true;
                        }
                        let _e1275 = phi_2143_;
                        let _e1277 = phi_2144_;
                        if _e1277 {
                            if (_e1257 < 1023u) {
                                let _e1279 = (_e1257 + 1u);
                                let _e1285 = (_e908.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1279) * _e1062)) ^ _e56)));
                                phi_2182_ = select(_e1257, _e1279, (select(select(_e911.member_1[1], _e1285, (_e1285 < _e911.member_1[1])), _e911.member_1[1], (_e1279 == 1023u)) <= _e851.member_1.y));
                            } else {
                                phi_2182_ = _e1257;
                            }
                            let _e1293 = phi_2182_;
                            phi_2183_ = _e1293;
                        } else {
                            phi_2183_ = _e1275;
                        }
                        let _e1295 = phi_2183_;
                        let _e1301 = (_e908.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1295) * _e1062)) ^ _e56)));
                        let _e1307 = select(_e1295, 0u, (select(select(_e911.member_1[1], _e1301, (_e1301 < _e911.member_1[1])), _e911.member_1[1], (_e1295 == 1023u)) > _e851.member_1.y));
                        if (_e1307 < 1023u) {
                            let _e1314 = (_e908.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1307) * _e1062)) ^ _e56)));
                            let _e1319 = (select(select(_e911.member_1[1], _e1314, (_e1314 < _e911.member_1[1])), _e911.member_1[1], (_e1307 == 1023u)) < _e851.member_1.y);
                            if _e1319 {
                                phi_2244_ = (_e1307 + 1u);
                            } else {
                                phi_2244_ = u32();
                            }
                            let _e1322 = phi_2244_;
                            phi_2246_ = _e1322;
                            phi_2247_ = select(true, false, _e1319);
                        } else {
                            phi_2246_ = u32();
                            phi_2247_ = true;
                        }
                        let _e1325 = phi_2246_;
                        let _e1327 = phi_2247_;
                        if _e1079 {
                            phi_2263_ = (((_e851.member_1.z - _e908.member[2]) / _e1078) * 1023f);
                        } else {
                            phi_2263_ = 0f;
                        }
                        let _e1336 = phi_2263_;
                        let _e1338 = select(1023f, _e1336, (_e1336 < 1023f));
                        let _e1340 = select(0f, _e1338, (_e1338 > 0f));
                        let _e1345 = select(select(u32(_e1340), 0u, (_e1340 < 0f)), 4294967295u, (_e1340 > 4294967000f));
                        if (_e1345 > 0u) {
                            let _e1352 = (_e908.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1345) * _e1143)) ^ _e56)));
                            let _e1357 = (select(select(_e911.member_1[2], _e1352, (_e1352 < _e911.member_1[2])), _e911.member_1[2], (_e1345 == 1023u)) > _e851.member_1.z);
                            if _e1357 {
                                phi_2314_ = (_e1345 - 1u);
                            } else {
                                phi_2314_ = u32();
                            }
                            let _e1360 = phi_2314_;
                            phi_2316_ = _e1360;
                            phi_2317_ = select(true, false, _e1357);
                        } else {
                            phi_2316_ = u32();
                            phi_2317_ = true;
                        }
                        let _e1363 = phi_2316_;
                        let _e1365 = phi_2317_;
                        if _e1365 {
                            if (_e1345 < 1023u) {
                                let _e1367 = (_e1345 + 1u);
                                let _e1373 = (_e908.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1367) * _e1143)) ^ _e56)));
                                phi_2355_ = select(_e1345, _e1367, (select(select(_e911.member_1[2], _e1373, (_e1373 < _e911.member_1[2])), _e911.member_1[2], (_e1367 == 1023u)) <= _e851.member_1.z));
                            } else {
                                phi_2355_ = _e1345;
                            }
                            let _e1381 = phi_2355_;
                            phi_2356_ = _e1381;
                        } else {
                            phi_2356_ = _e1363;
                        }
                        let _e1383 = phi_2356_;
                        let _e1389 = (_e908.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1383) * _e1143)) ^ _e56)));
                        let _e1395 = select(_e1383, 0u, (select(select(_e911.member_1[2], _e1389, (_e1389 < _e911.member_1[2])), _e911.member_1[2], (_e1383 == 1023u)) > _e851.member_1.z));
                        if (_e1395 < 1023u) {
                            let _e1402 = (_e908.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1395) * _e1143)) ^ _e56)));
                            let _e1407 = (select(select(_e911.member_1[2], _e1402, (_e1402 < _e911.member_1[2])), _e911.member_1[2], (_e1395 == 1023u)) < _e851.member_1.z);
                            if _e1407 {
                                phi_2417_ = (_e1395 + 1u);
                            } else {
                                phi_2417_ = u32();
                            }
                            let _e1410 = phi_2417_;
                            phi_2419_ = _e1410;
                            phi_2420_ = select(true, false, _e1407);
                        } else {
                            phi_2419_ = u32();
                            phi_2420_ = true;
                        }
                        let _e1413 = phi_2419_;
                        let _e1415 = phi_2420_;
                        if _e920 {
                            phi_2445_ = (((_e882.member.x - _e908.member[0]) / _e919) * 1023f);
                        } else {
                            phi_2445_ = 0f;
                        }
                        let _e1425 = phi_2445_;
                        let _e1427 = select(1023f, _e1425, (_e1425 < 1023f));
                        let _e1429 = select(0f, _e1427, (_e1427 > 0f));
                        let _e1434 = select(select(u32(_e1429), 0u, (_e1429 < 0f)), 4294967295u, (_e1429 > 4294967000f));
                        if (_e1434 > 0u) {
                            let _e1441 = (_e908.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1434) * _e984)) ^ _e56)));
                            let _e1446 = (select(select(_e911.member_1[0], _e1441, (_e1441 < _e911.member_1[0])), _e911.member_1[0], (_e1434 == 1023u)) > _e882.member.x);
                            if _e1446 {
                                phi_2496_ = (_e1434 - 1u);
                            } else {
                                phi_2496_ = u32();
                            }
                            let _e1449 = phi_2496_;
                            phi_2498_ = _e1449;
                            phi_2499_ = select(true, false, _e1446);
                        } else {
                            phi_2498_ = u32();
                            phi_2499_ = true;
                        }
                        let _e1452 = phi_2498_;
                        let _e1454 = phi_2499_;
                        if _e1454 {
                            if (_e1434 < 1023u) {
                                let _e1456 = (_e1434 + 1u);
                                let _e1462 = (_e908.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1456) * _e984)) ^ _e56)));
                                phi_2537_ = select(_e1434, _e1456, (select(select(_e911.member_1[0], _e1462, (_e1462 < _e911.member_1[0])), _e911.member_1[0], (_e1456 == 1023u)) <= _e882.member.x));
                            } else {
                                phi_2537_ = _e1434;
                            }
                            let _e1470 = phi_2537_;
                            phi_2538_ = _e1470;
                        } else {
                            phi_2538_ = _e1452;
                        }
                        let _e1472 = phi_2538_;
                        let _e1478 = (_e908.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1472) * _e984)) ^ _e56)));
                        if _e998 {
                            phi_2576_ = (((_e882.member.y - _e908.member[1]) / _e997) * 1023f);
                        } else {
                            phi_2576_ = 0f;
                        }
                        let _e1489 = phi_2576_;
                        let _e1491 = select(1023f, _e1489, (_e1489 < 1023f));
                        let _e1493 = select(0f, _e1491, (_e1491 > 0f));
                        let _e1498 = select(select(u32(_e1493), 0u, (_e1493 < 0f)), 4294967295u, (_e1493 > 4294967000f));
                        if (_e1498 > 0u) {
                            let _e1505 = (_e908.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1498) * _e1062)) ^ _e56)));
                            let _e1510 = (select(select(_e911.member_1[1], _e1505, (_e1505 < _e911.member_1[1])), _e911.member_1[1], (_e1498 == 1023u)) > _e882.member.y);
                            if _e1510 {
                                phi_2627_ = (_e1498 - 1u);
                            } else {
                                phi_2627_ = u32();
                            }
                            let _e1513 = phi_2627_;
                            phi_2629_ = _e1513;
                            phi_2630_ = select(true, false, _e1510);
                        } else {
                            phi_2629_ = u32();
                            phi_2630_ = true;
                        }
                        let _e1516 = phi_2629_;
                        let _e1518 = phi_2630_;
                        if _e1518 {
                            if (_e1498 < 1023u) {
                                let _e1520 = (_e1498 + 1u);
                                let _e1526 = (_e908.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1520) * _e1062)) ^ _e56)));
                                phi_2668_ = select(_e1498, _e1520, (select(select(_e911.member_1[1], _e1526, (_e1526 < _e911.member_1[1])), _e911.member_1[1], (_e1520 == 1023u)) <= _e882.member.y));
                            } else {
                                phi_2668_ = _e1498;
                            }
                            let _e1534 = phi_2668_;
                            phi_2669_ = _e1534;
                        } else {
                            phi_2669_ = _e1516;
                        }
                        let _e1536 = phi_2669_;
                        let _e1542 = (_e908.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1536) * _e1062)) ^ _e56)));
                        if _e1079 {
                            phi_2709_ = (((_e882.member.z - _e908.member[2]) / _e1078) * 1023f);
                        } else {
                            phi_2709_ = 0f;
                        }
                        let _e1556 = phi_2709_;
                        let _e1558 = select(1023f, _e1556, (_e1556 < 1023f));
                        let _e1560 = select(0f, _e1558, (_e1558 > 0f));
                        let _e1565 = select(select(u32(_e1560), 0u, (_e1560 < 0f)), 4294967295u, (_e1560 > 4294967000f));
                        if (_e1565 > 0u) {
                            let _e1572 = (_e908.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1565) * _e1143)) ^ _e56)));
                            let _e1577 = (select(select(_e911.member_1[2], _e1572, (_e1572 < _e911.member_1[2])), _e911.member_1[2], (_e1565 == 1023u)) > _e882.member.z);
                            if _e1577 {
                                phi_2760_ = (_e1565 - 1u);
                            } else {
                                phi_2760_ = u32();
                            }
                            let _e1580 = phi_2760_;
                            phi_2762_ = _e1580;
                            phi_2763_ = select(true, false, _e1577);
                        } else {
                            phi_2762_ = u32();
                            phi_2763_ = true;
                        }
                        let _e1583 = phi_2762_;
                        let _e1585 = phi_2763_;
                        if _e1585 {
                            if (_e1565 < 1023u) {
                                let _e1587 = (_e1565 + 1u);
                                let _e1593 = (_e908.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1587) * _e1143)) ^ _e56)));
                                phi_2801_ = select(_e1565, _e1587, (select(select(_e911.member_1[2], _e1593, (_e1593 < _e911.member_1[2])), _e911.member_1[2], (_e1587 == 1023u)) <= _e882.member.z));
                            } else {
                                phi_2801_ = _e1565;
                            }
                            let _e1601 = phi_2801_;
                            phi_2802_ = _e1601;
                        } else {
                            phi_2802_ = _e1583;
                        }
                        let _e1603 = phi_2802_;
                        let _e1609 = (_e908.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1603) * _e1143)) ^ _e56)));
                        if _e920 {
                            phi_2842_ = (((_e882.member_1.x - _e908.member[0]) / _e919) * 1023f);
                        } else {
                            phi_2842_ = 0f;
                        }
                        let _e1623 = phi_2842_;
                        let _e1625 = select(1023f, _e1623, (_e1623 < 1023f));
                        let _e1627 = select(0f, _e1625, (_e1625 > 0f));
                        let _e1632 = select(select(u32(_e1627), 0u, (_e1627 < 0f)), 4294967295u, (_e1627 > 4294967000f));
                        if (_e1632 > 0u) {
                            let _e1639 = (_e908.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1632) * _e984)) ^ _e56)));
                            let _e1644 = (select(select(_e911.member_1[0], _e1639, (_e1639 < _e911.member_1[0])), _e911.member_1[0], (_e1632 == 1023u)) > _e882.member_1.x);
                            if _e1644 {
                                phi_2893_ = (_e1632 - 1u);
                            } else {
                                phi_2893_ = u32();
                            }
                            let _e1647 = phi_2893_;
                            phi_2895_ = _e1647;
                            phi_2896_ = select(true, false, _e1644);
                        } else {
                            phi_2895_ = u32();
                            phi_2896_ = true;
                        }
                        let _e1650 = phi_2895_;
                        let _e1652 = phi_2896_;
                        if _e1652 {
                            if (_e1632 < 1023u) {
                                let _e1654 = (_e1632 + 1u);
                                let _e1660 = (_e908.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1654) * _e984)) ^ _e56)));
                                phi_2934_ = select(_e1632, _e1654, (select(select(_e911.member_1[0], _e1660, (_e1660 < _e911.member_1[0])), _e911.member_1[0], (_e1654 == 1023u)) <= _e882.member_1.x));
                            } else {
                                phi_2934_ = _e1632;
                            }
                            let _e1668 = phi_2934_;
                            phi_2935_ = _e1668;
                        } else {
                            phi_2935_ = _e1650;
                        }
                        let _e1670 = phi_2935_;
                        let _e1676 = (_e908.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1670) * _e984)) ^ _e56)));
                        let _e1682 = select(_e1670, 0u, (select(select(_e911.member_1[0], _e1676, (_e1676 < _e911.member_1[0])), _e911.member_1[0], (_e1670 == 1023u)) > _e882.member_1.x));
                        if (_e1682 < 1023u) {
                            let _e1689 = (_e908.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1682) * _e984)) ^ _e56)));
                            let _e1694 = (select(select(_e911.member_1[0], _e1689, (_e1689 < _e911.member_1[0])), _e911.member_1[0], (_e1682 == 1023u)) < _e882.member_1.x);
                            if _e1694 {
                                phi_2996_ = (_e1682 + 1u);
                            } else {
                                phi_2996_ = u32();
                            }
                            let _e1697 = phi_2996_;
                            phi_2998_ = _e1697;
                            phi_2999_ = select(true, false, _e1694);
                        } else {
                            phi_2998_ = u32();
                            phi_2999_ = true;
                        }
                        let _e1700 = phi_2998_;
                        let _e1702 = phi_2999_;
                        if _e998 {
                            phi_3013_ = (((_e882.member_1.y - _e908.member[1]) / _e997) * 1023f);
                        } else {
                            phi_3013_ = 0f;
                        }
                        let _e1708 = phi_3013_;
                        let _e1710 = select(1023f, _e1708, (_e1708 < 1023f));
                        let _e1712 = select(0f, _e1710, (_e1710 > 0f));
                        let _e1717 = select(select(u32(_e1712), 0u, (_e1712 < 0f)), 4294967295u, (_e1712 > 4294967000f));
                        if (_e1717 > 0u) {
                            let _e1724 = (_e908.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1717) * _e1062)) ^ _e56)));
                            let _e1729 = (select(select(_e911.member_1[1], _e1724, (_e1724 < _e911.member_1[1])), _e911.member_1[1], (_e1717 == 1023u)) > _e882.member_1.y);
                            if _e1729 {
                                phi_3064_ = (_e1717 - 1u);
                            } else {
                                phi_3064_ = u32();
                            }
                            let _e1732 = phi_3064_;
                            phi_3066_ = _e1732;
                            phi_3067_ = select(true, false, _e1729);
                        } else {
                            phi_3066_ = u32();
                            phi_3067_ = true;
                        }
                        let _e1735 = phi_3066_;
                        let _e1737 = phi_3067_;
                        if _e1737 {
                            if (_e1717 < 1023u) {
                                let _e1739 = (_e1717 + 1u);
                                let _e1745 = (_e908.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1739) * _e1062)) ^ _e56)));
                                phi_3105_ = select(_e1717, _e1739, (select(select(_e911.member_1[1], _e1745, (_e1745 < _e911.member_1[1])), _e911.member_1[1], (_e1739 == 1023u)) <= _e882.member_1.y));
                            } else {
                                phi_3105_ = _e1717;
                            }
                            let _e1753 = phi_3105_;
                            phi_3106_ = _e1753;
                        } else {
                            phi_3106_ = _e1735;
                        }
                        let _e1755 = phi_3106_;
                        let _e1761 = (_e908.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1755) * _e1062)) ^ _e56)));
                        let _e1767 = select(_e1755, 0u, (select(select(_e911.member_1[1], _e1761, (_e1761 < _e911.member_1[1])), _e911.member_1[1], (_e1755 == 1023u)) > _e882.member_1.y));
                        if (_e1767 < 1023u) {
                            let _e1774 = (_e908.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1767) * _e1062)) ^ _e56)));
                            let _e1779 = (select(select(_e911.member_1[1], _e1774, (_e1774 < _e911.member_1[1])), _e911.member_1[1], (_e1767 == 1023u)) < _e882.member_1.y);
                            if _e1779 {
                                phi_3167_ = (_e1767 + 1u);
                            } else {
                                phi_3167_ = u32();
                            }
                            let _e1782 = phi_3167_;
                            phi_3169_ = _e1782;
                            phi_3170_ = select(true, false, _e1779);
                        } else {
                            phi_3169_ = u32();
                            phi_3170_ = true;
                        }
                        let _e1785 = phi_3169_;
                        let _e1787 = phi_3170_;
                        if _e1079 {
                            phi_3186_ = (((_e882.member_1.z - _e908.member[2]) / _e1078) * 1023f);
                        } else {
                            phi_3186_ = 0f;
                        }
                        let _e1796 = phi_3186_;
                        let _e1798 = select(1023f, _e1796, (_e1796 < 1023f));
                        let _e1800 = select(0f, _e1798, (_e1798 > 0f));
                        let _e1805 = select(select(u32(_e1800), 0u, (_e1800 < 0f)), 4294967295u, (_e1800 > 4294967000f));
                        if (_e1805 > 0u) {
                            let _e1812 = (_e908.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1805) * _e1143)) ^ _e56)));
                            let _e1817 = (select(select(_e911.member_1[2], _e1812, (_e1812 < _e911.member_1[2])), _e911.member_1[2], (_e1805 == 1023u)) > _e882.member_1.z);
                            if _e1817 {
                                phi_3237_ = (_e1805 - 1u);
                            } else {
                                phi_3237_ = u32();
                            }
                            let _e1820 = phi_3237_;
                            phi_3239_ = _e1820;
                            phi_3240_ = select(true, false, _e1817);
                        } else {
                            phi_3239_ = u32();
                            phi_3240_ = true;
                        }
                        let _e1823 = phi_3239_;
                        let _e1825 = phi_3240_;
                        if _e1825 {
                            if (_e1805 < 1023u) {
                                let _e1827 = (_e1805 + 1u);
                                let _e1833 = (_e908.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1827) * _e1143)) ^ _e56)));
                                phi_3278_ = select(_e1805, _e1827, (select(select(_e911.member_1[2], _e1833, (_e1833 < _e911.member_1[2])), _e911.member_1[2], (_e1827 == 1023u)) <= _e882.member_1.z));
                            } else {
                                phi_3278_ = _e1805;
                            }
                            let _e1841 = phi_3278_;
                            phi_3279_ = _e1841;
                        } else {
                            phi_3279_ = _e1823;
                        }
                        let _e1843 = phi_3279_;
                        let _e1849 = (_e908.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1843) * _e1143)) ^ _e56)));
                        let _e1855 = select(_e1843, 0u, (select(select(_e911.member_1[2], _e1849, (_e1849 < _e911.member_1[2])), _e911.member_1[2], (_e1843 == 1023u)) > _e882.member_1.z));
                        if (_e1855 < 1023u) {
                            let _e1862 = (_e908.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1855) * _e1143)) ^ _e56)));
                            let _e1867 = (select(select(_e911.member_1[2], _e1862, (_e1862 < _e911.member_1[2])), _e911.member_1[2], (_e1855 == 1023u)) < _e882.member_1.z);
                            if _e1867 {
                                phi_3340_ = (_e1855 + 1u);
                            } else {
                                phi_3340_ = u32();
                            }
                            let _e1870 = phi_3340_;
                            phi_3342_ = _e1870;
                            phi_3343_ = select(true, false, _e1867);
                        } else {
                            phi_3342_ = u32();
                            phi_3343_ = true;
                        }
                        let _e1873 = phi_3342_;
                        let _e1875 = phi_3343_;
                        if _e53 {
                        } else {
                            break;
                        }
                        global_4.member[_e47] = type_30(array<u32, 2>(((select(_e980, 0u, (select(select(_e911.member_1[0], _e990, (_e990 < _e911.member_1[0])), _e911.member_1[0], (_e980 == 1023u)) > _e851.member.x)) | (select(_e1058, 0u, (select(select(_e911.member_1[1], _e1068, (_e1068 < _e911.member_1[1])), _e911.member_1[1], (_e1058 == 1023u)) > _e851.member.y)) << bitcast<u32>(10i))) | (select(_e1139, 0u, (select(select(_e911.member_1[2], _e1149, (_e1149 < _e911.member_1[2])), _e911.member_1[2], (_e1139 == 1023u)) > _e851.member.z)) << bitcast<u32>(20i))), ((select(_e1240, _e1222, _e1242) | (select(_e1325, _e1307, _e1327) << bitcast<u32>(10i))) | (select(_e1413, _e1395, _e1415) << bitcast<u32>(20i)))), array<u32, 2>(((select(_e1472, 0u, (select(select(_e911.member_1[0], _e1478, (_e1478 < _e911.member_1[0])), _e911.member_1[0], (_e1472 == 1023u)) > _e882.member.x)) | (select(_e1536, 0u, (select(select(_e911.member_1[1], _e1542, (_e1542 < _e911.member_1[1])), _e911.member_1[1], (_e1536 == 1023u)) > _e882.member.y)) << bitcast<u32>(10i))) | (select(_e1603, 0u, (select(select(_e911.member_1[2], _e1609, (_e1609 < _e911.member_1[2])), _e911.member_1[2], (_e1603 == 1023u)) > _e882.member.z)) << bitcast<u32>(20i))), ((select(_e1700, _e1682, _e1702) | (select(_e1785, _e1767, _e1787) << bitcast<u32>(10i))) | (select(_e1873, _e1855, _e1875) << bitcast<u32>(20i)))), _e824, _e855);
                        if (_e47 == 0u) {
                            if (_e43 == 0u) {
                            } else {
                                if (0u < _e43) {
                                } else {
                                    break;
                                }
                                global_5.member[0u] = type_25(array<u32, 4>(bitcast<u32>(_e908.member[0]), bitcast<u32>(_e908.member[1]), bitcast<u32>(_e908.member[2]), 0u), array<u32, 4>(bitcast<u32>(_e911.member_1[0]), bitcast<u32>(_e911.member_1[1]), bitcast<u32>(_e911.member_1[2]), 0u));
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
