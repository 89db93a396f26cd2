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
    var phi_141_: type_19;
    var phi_159_: type_24;
    var phi_177_: type_24;
    var phi_229_: type_4;
    var phi_232_: type_34;
    var phi_234_: u32;
    var phi_230_: type_4;
    var phi_257_: type_4;
    var phi_279_: type_19;
    var phi_288_: bool;
    var phi_306_: type_24;
    var phi_324_: type_24;
    var phi_328_: type_24;
    var phi_356_: f32;
    var phi_389_: u32;
    var phi_391_: u32;
    var phi_392_: bool;
    var phi_414_: u32;
    var phi_415_: u32;
    var phi_450_: u32;
    var phi_452_: u32;
    var phi_453_: bool;
    var phi_493_: u32;
    var phi_494_: u32;
    var phi_538_: f32;
    var phi_571_: u32;
    var phi_573_: u32;
    var phi_574_: bool;
    var phi_596_: u32;
    var phi_597_: u32;
    var phi_632_: u32;
    var phi_634_: u32;
    var phi_635_: bool;
    var phi_675_: u32;
    var phi_676_: u32;
    var phi_722_: f32;
    var phi_755_: u32;
    var phi_757_: u32;
    var phi_758_: bool;
    var phi_780_: u32;
    var phi_781_: u32;
    var phi_816_: u32;
    var phi_818_: u32;
    var phi_819_: bool;
    var phi_859_: u32;
    var phi_860_: u32;
    var phi_906_: f32;
    var phi_939_: u32;
    var phi_941_: u32;
    var phi_942_: bool;
    var phi_964_: u32;
    var phi_965_: u32;
    var phi_1000_: u32;
    var phi_1002_: u32;
    var phi_1003_: bool;
    var phi_1043_: u32;
    var phi_1044_: u32;
    var phi_1109_: u32;
    var phi_1111_: u32;
    var phi_1112_: bool;
    var phi_1160_: f32;
    var phi_1193_: u32;
    var phi_1195_: u32;
    var phi_1196_: bool;
    var phi_1218_: u32;
    var phi_1219_: u32;
    var phi_1254_: u32;
    var phi_1256_: u32;
    var phi_1257_: bool;
    var phi_1297_: u32;
    var phi_1298_: u32;
    var phi_1363_: u32;
    var phi_1365_: u32;
    var phi_1366_: bool;
    var phi_1416_: f32;
    var phi_1449_: u32;
    var phi_1451_: u32;
    var phi_1452_: bool;
    var phi_1474_: u32;
    var phi_1475_: u32;
    var phi_1510_: u32;
    var phi_1512_: u32;
    var phi_1513_: bool;
    var phi_1553_: u32;
    var phi_1554_: u32;
    var phi_1619_: u32;
    var phi_1621_: u32;
    var phi_1622_: bool;
    var phi_1856_: type_34;
    var phi_1857_: u32;
    var phi_233_: type_34;
    var phi_235_: u32;
    var phi_1859_: bool;
    var phi_4620_: bool;
    var phi_1887_: type_24;
    var phi_1909_: type_24;
    var local: type_34;
    var local_1: type_34;
    var phi_1944_: f32;
    var phi_1977_: u32;
    var phi_1979_: u32;
    var phi_1980_: bool;
    var phi_2002_: u32;
    var phi_2003_: u32;
    var phi_2038_: u32;
    var phi_2040_: u32;
    var phi_2041_: bool;
    var phi_2081_: u32;
    var phi_2082_: u32;
    var phi_2126_: f32;
    var phi_2159_: u32;
    var phi_2161_: u32;
    var phi_2162_: bool;
    var phi_2184_: u32;
    var phi_2185_: u32;
    var phi_2220_: u32;
    var phi_2222_: u32;
    var phi_2223_: bool;
    var phi_2263_: u32;
    var phi_2264_: u32;
    var phi_2310_: f32;
    var phi_2343_: u32;
    var phi_2345_: u32;
    var phi_2346_: bool;
    var phi_2368_: u32;
    var phi_2369_: u32;
    var phi_2404_: u32;
    var phi_2406_: u32;
    var phi_2407_: bool;
    var phi_2447_: u32;
    var phi_2448_: u32;
    var phi_2494_: f32;
    var phi_2527_: u32;
    var phi_2529_: u32;
    var phi_2530_: bool;
    var phi_2552_: u32;
    var phi_2553_: u32;
    var phi_2588_: u32;
    var phi_2590_: u32;
    var phi_2591_: bool;
    var phi_2631_: u32;
    var phi_2632_: u32;
    var phi_2697_: u32;
    var phi_2699_: u32;
    var phi_2700_: bool;
    var phi_2748_: f32;
    var phi_2781_: u32;
    var phi_2783_: u32;
    var phi_2784_: bool;
    var phi_2806_: u32;
    var phi_2807_: u32;
    var phi_2842_: u32;
    var phi_2844_: u32;
    var phi_2845_: bool;
    var phi_2885_: u32;
    var phi_2886_: u32;
    var phi_2951_: u32;
    var phi_2953_: u32;
    var phi_2954_: bool;
    var phi_3004_: f32;
    var phi_3037_: u32;
    var phi_3039_: u32;
    var phi_3040_: bool;
    var phi_3062_: u32;
    var phi_3063_: u32;
    var phi_3098_: u32;
    var phi_3100_: u32;
    var phi_3101_: bool;
    var phi_3141_: u32;
    var phi_3142_: u32;
    var phi_3207_: u32;
    var phi_3209_: u32;
    var phi_3210_: bool;
    var phi_3269_: f32;
    var phi_3302_: u32;
    var phi_3304_: u32;
    var phi_3305_: bool;
    var phi_3327_: u32;
    var phi_3328_: u32;
    var phi_3363_: u32;
    var phi_3365_: u32;
    var phi_3366_: bool;
    var phi_3406_: u32;
    var phi_3407_: u32;
    var phi_3451_: f32;
    var phi_3484_: u32;
    var phi_3486_: u32;
    var phi_3487_: bool;
    var phi_3509_: u32;
    var phi_3510_: u32;
    var phi_3545_: u32;
    var phi_3547_: u32;
    var phi_3548_: bool;
    var phi_3588_: u32;
    var phi_3589_: u32;
    var phi_3635_: f32;
    var phi_3668_: u32;
    var phi_3670_: u32;
    var phi_3671_: bool;
    var phi_3693_: u32;
    var phi_3694_: u32;
    var phi_3729_: u32;
    var phi_3731_: u32;
    var phi_3732_: bool;
    var phi_3772_: u32;
    var phi_3773_: u32;
    var phi_3819_: f32;
    var phi_3852_: u32;
    var phi_3854_: u32;
    var phi_3855_: bool;
    var phi_3877_: u32;
    var phi_3878_: u32;
    var phi_3913_: u32;
    var phi_3915_: u32;
    var phi_3916_: bool;
    var phi_3956_: u32;
    var phi_3957_: u32;
    var phi_4022_: u32;
    var phi_4024_: u32;
    var phi_4025_: bool;
    var phi_4073_: f32;
    var phi_4106_: u32;
    var phi_4108_: u32;
    var phi_4109_: bool;
    var phi_4131_: u32;
    var phi_4132_: u32;
    var phi_4167_: u32;
    var phi_4169_: u32;
    var phi_4170_: bool;
    var phi_4210_: u32;
    var phi_4211_: u32;
    var phi_4276_: u32;
    var phi_4278_: u32;
    var phi_4279_: bool;
    var phi_4329_: f32;
    var phi_4362_: u32;
    var phi_4364_: u32;
    var phi_4365_: bool;
    var phi_4387_: u32;
    var phi_4388_: u32;
    var phi_4423_: u32;
    var phi_4425_: u32;
    var phi_4426_: bool;
    var phi_4466_: u32;
    var phi_4467_: u32;
    var phi_4532_: u32;
    var phi_4534_: u32;
    var phi_4535_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e41 = global;
            let _e43 = arrayLength((&global_3.member));
            let _e47 = arrayLength((&global_5.member));
            let _e51 = (_e41.x + (_e41.y * 2097152u));
            let _e54 = global_1.member[0u];
            if (_e51 < _e54) {
                let _e56 = (_e51 < _e43);
                if _e56 {
                    let _e57 = (_e51 < arrayLength((&global_4.member)));
                    if _e57 {
                        let _e60 = global_2.member[0u];
                        let _e61 = (0u < _e43);
                        if _e61 {
                            if _e61 {
                            } else {
                                break;
                            }
                            let _e64 = global_3.member[0u];
                            phi_141_ = _e64;
                        } else {
                            phi_141_ = type_19(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e66 = phi_141_;
                        if (_e66.member_1 == 2147483648u) {
                            phi_159_ = type_24(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            phi_159_ = type_24(vec3<f32>(_e66.member[0][0], _e66.member[1][0], _e66.member[2][0]), vec3<f32>(_e66.member[0][2], _e66.member[1][2], _e66.member[2][2]));
                        }
                        let _e85 = phi_159_;
                        if (_e66.member_2 == 2147483648u) {
                            phi_177_ = _e85;
                        } else {
                            phi_177_ = type_24(vec3<f32>(_e66.member[0][1], _e66.member[1][1], _e66.member[2][1]), vec3<f32>(_e66.member[0][3], _e66.member[1][3], _e66.member[2][3]));
                        }
                        let _e104 = phi_177_;
                        phi_229_ = type_4(0u, 128u);
                        phi_232_ = type_34(array<f32, 3>(select(_e104.member.x, _e85.member.x, (_e85.member.x < _e104.member.x)), select(_e104.member.y, _e85.member.y, (_e85.member.y < _e104.member.y)), select(_e104.member.z, _e85.member.z, (_e85.member.z < _e104.member.z))), array<f32, 3>(select(_e104.member_1.x, _e85.member_1.x, (_e85.member_1.x > _e104.member_1.x)), select(_e104.member_1.y, _e85.member_1.y, (_e85.member_1.y > _e104.member_1.y)), select(_e104.member_1.z, _e85.member_1.z, (_e85.member_1.z > _e104.member_1.z))));
                        phi_234_ = 0u;
                        loop {
                            let _e137 = phi_229_;
                            let _e139 = phi_232_;
                            let _e141 = phi_234_;
                            local = _e139;
                            local_1 = _e139;
                            if (_e137.member < _e137.member_1) {
                                phi_230_ = type_4((_e137.member + 1u), _e137.member_1);
                                phi_257_ = type_4(1u, _e137.member);
                            } else {
                                phi_230_ = _e137;
                                phi_257_ = type_4(0u, type_4().member_1);
                            }
                            let _e154 = phi_230_;
                            let _e156 = phi_257_;
                            if (bitcast<i32>(_e156.member) != 0i) {
                                let _e160 = (_e141 == _e51);
                                if _e160 {
                                    phi_1856_ = type_34();
                                    phi_1857_ = u32();
                                } else {
                                    let _e161 = (_e141 < _e43);
                                    if _e161 {
                                        if _e161 {
                                        } else {
                                            phi_4620_ = true;
                                            break;
                                        }
                                        let _e164 = global_3.member[_e141];
                                        phi_279_ = _e164;
                                    } else {
                                        phi_279_ = type_19(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e166 = phi_279_;
                                    if ((_e166.member_1 & 2147483648u) != 0u) {
                                        phi_288_ = false;
                                    } else {
                                        phi_288_ = (_e51 <= _e166.member_1);
                                    }
                                    let _e173 = phi_288_;
                                    if (_e166.member_1 == 2147483648u) {
                                        phi_306_ = type_24(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                    } else {
                                        phi_306_ = type_24(vec3<f32>(_e166.member[0][0], _e166.member[1][0], _e166.member[2][0]), vec3<f32>(_e166.member[0][2], _e166.member[1][2], _e166.member[2][2]));
                                    }
                                    let _e191 = phi_306_;
                                    if (_e166.member_2 == 2147483648u) {
                                        phi_324_ = _e191;
                                    } else {
                                        phi_324_ = type_24(vec3<f32>(_e166.member[0][1], _e166.member[1][1], _e166.member[2][1]), vec3<f32>(_e166.member[0][3], _e166.member[1][3], _e166.member[2][3]));
                                    }
                                    let _e209 = phi_324_;
                                    if _e173 {
                                        phi_328_ = _e191;
                                    } else {
                                        phi_328_ = _e209;
                                    }
                                    let _e211 = phi_328_;
                                    let _e232 = (_e211.member.x - _e139.member[0]);
                                    let _e237 = bitcast<f32>((bitcast<u32>(((_e139.member_1[0] - _e139.member[0]) * 0.0009775171f)) ^ _e60));
                                    let _e238 = (_e237 > 0f);
                                    if _e238 {
                                        phi_356_ = (_e232 / _e237);
                                    } else {
                                        phi_356_ = 0f;
                                    }
                                    let _e241 = phi_356_;
                                    let _e243 = select(1023f, _e241, (_e241 < 1023f));
                                    let _e251 = bitcast<u32>(select(0i, select(select(i32(_e243), i32(-2147483648), (_e243 < -2147483600f)), 2147483647i, (_e243 > 2147483500f)), (_e243 == _e243)));
                                    if (_e251 > 0u) {
                                        let _e260 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e251)) - 8388608f) * _e237)) ^ _e60)) > _e232);
                                        if _e260 {
                                            phi_389_ = (_e251 - 1u);
                                        } else {
                                            phi_389_ = u32();
                                        }
                                        let _e263 = phi_389_;
                                        phi_391_ = _e263;
                                        phi_392_ = select(true, false, _e260);
                                    } else {
                                        phi_391_ = u32();
                                        phi_392_ = true;
                                    }
                                    let _e266 = phi_391_;
                                    let _e268 = phi_392_;
                                    if _e268 {
                                        if (_e251 < 1023u) {
                                            let _e270 = (_e251 + 1u);
                                            phi_414_ = select(_e251, _e270, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e270)) - 8388608f) * _e237)) ^ _e60)) <= _e232));
                                        } else {
                                            phi_414_ = _e251;
                                        }
                                        let _e281 = phi_414_;
                                        phi_415_ = _e281;
                                    } else {
                                        phi_415_ = _e266;
                                    }
                                    let _e283 = phi_415_;
                                    if (_e283 > 0u) {
                                        let _e292 = (_e139.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e283)) - 8388608f) * _e237)) ^ _e60)));
                                        let _e297 = (select(select(_e139.member_1[0], _e292, (_e292 < _e139.member_1[0])), _e139.member_1[0], (_e283 == 1023u)) > _e211.member.x);
                                        if _e297 {
                                            phi_450_ = (_e283 - 1u);
                                        } else {
                                            phi_450_ = u32();
                                        }
                                        let _e300 = phi_450_;
                                        phi_452_ = _e300;
                                        phi_453_ = select(true, false, _e297);
                                    } else {
                                        phi_452_ = u32();
                                        phi_453_ = true;
                                    }
                                    let _e303 = phi_452_;
                                    let _e305 = phi_453_;
                                    if _e305 {
                                        if (_e283 < 1023u) {
                                            let _e307 = (_e283 + 1u);
                                            let _e315 = (_e139.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e307)) - 8388608f) * _e237)) ^ _e60)));
                                            phi_493_ = select(_e283, _e307, (select(select(_e139.member_1[0], _e315, (_e315 < _e139.member_1[0])), _e139.member_1[0], (_e307 == 1023u)) <= _e211.member.x));
                                        } else {
                                            phi_493_ = _e283;
                                        }
                                        let _e323 = phi_493_;
                                        phi_494_ = _e323;
                                    } else {
                                        phi_494_ = _e303;
                                    }
                                    let _e325 = phi_494_;
                                    let _e333 = (_e139.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e325)) - 8388608f) * _e237)) ^ _e60)));
                                    let _e340 = (_e211.member.y - _e139.member[1]);
                                    let _e345 = bitcast<f32>((bitcast<u32>(((_e139.member_1[1] - _e139.member[1]) * 0.0009775171f)) ^ _e60));
                                    let _e346 = (_e345 > 0f);
                                    if _e346 {
                                        phi_538_ = (_e340 / _e345);
                                    } else {
                                        phi_538_ = 0f;
                                    }
                                    let _e349 = phi_538_;
                                    let _e351 = select(1023f, _e349, (_e349 < 1023f));
                                    let _e359 = bitcast<u32>(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < -2147483600f)), 2147483647i, (_e351 > 2147483500f)), (_e351 == _e351)));
                                    if (_e359 > 0u) {
                                        let _e368 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e359)) - 8388608f) * _e345)) ^ _e60)) > _e340);
                                        if _e368 {
                                            phi_571_ = (_e359 - 1u);
                                        } else {
                                            phi_571_ = u32();
                                        }
                                        let _e371 = phi_571_;
                                        phi_573_ = _e371;
                                        phi_574_ = select(true, false, _e368);
                                    } else {
                                        phi_573_ = u32();
                                        phi_574_ = true;
                                    }
                                    let _e374 = phi_573_;
                                    let _e376 = phi_574_;
                                    if _e376 {
                                        if (_e359 < 1023u) {
                                            let _e378 = (_e359 + 1u);
                                            phi_596_ = select(_e359, _e378, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e378)) - 8388608f) * _e345)) ^ _e60)) <= _e340));
                                        } else {
                                            phi_596_ = _e359;
                                        }
                                        let _e389 = phi_596_;
                                        phi_597_ = _e389;
                                    } else {
                                        phi_597_ = _e374;
                                    }
                                    let _e391 = phi_597_;
                                    if (_e391 > 0u) {
                                        let _e400 = (_e139.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e391)) - 8388608f) * _e345)) ^ _e60)));
                                        let _e405 = (select(select(_e139.member_1[1], _e400, (_e400 < _e139.member_1[1])), _e139.member_1[1], (_e391 == 1023u)) > _e211.member.y);
                                        if _e405 {
                                            phi_632_ = (_e391 - 1u);
                                        } else {
                                            phi_632_ = u32();
                                        }
                                        let _e408 = phi_632_;
                                        phi_634_ = _e408;
                                        phi_635_ = select(true, false, _e405);
                                    } else {
                                        phi_634_ = u32();
                                        phi_635_ = true;
                                    }
                                    let _e411 = phi_634_;
                                    let _e413 = phi_635_;
                                    if _e413 {
                                        if (_e391 < 1023u) {
                                            let _e415 = (_e391 + 1u);
                                            let _e423 = (_e139.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e415)) - 8388608f) * _e345)) ^ _e60)));
                                            phi_675_ = select(_e391, _e415, (select(select(_e139.member_1[1], _e423, (_e423 < _e139.member_1[1])), _e139.member_1[1], (_e415 == 1023u)) <= _e211.member.y));
                                        } else {
                                            phi_675_ = _e391;
                                        }
                                        let _e431 = phi_675_;
                                        phi_676_ = _e431;
                                    } else {
                                        phi_676_ = _e411;
                                    }
                                    let _e433 = phi_676_;
                                    let _e441 = (_e139.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e433)) - 8388608f) * _e345)) ^ _e60)));
                                    let _e451 = (_e211.member.z - _e139.member[2]);
                                    let _e456 = bitcast<f32>((bitcast<u32>(((_e139.member_1[2] - _e139.member[2]) * 0.0009775171f)) ^ _e60));
                                    let _e457 = (_e456 > 0f);
                                    if _e457 {
                                        phi_722_ = (_e451 / _e456);
                                    } else {
                                        phi_722_ = 0f;
                                    }
                                    let _e460 = phi_722_;
                                    let _e462 = select(1023f, _e460, (_e460 < 1023f));
                                    let _e470 = bitcast<u32>(select(0i, select(select(i32(_e462), i32(-2147483648), (_e462 < -2147483600f)), 2147483647i, (_e462 > 2147483500f)), (_e462 == _e462)));
                                    if (_e470 > 0u) {
                                        let _e479 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e470)) - 8388608f) * _e456)) ^ _e60)) > _e451);
                                        if _e479 {
                                            phi_755_ = (_e470 - 1u);
                                        } else {
                                            phi_755_ = u32();
                                        }
                                        let _e482 = phi_755_;
                                        phi_757_ = _e482;
                                        phi_758_ = select(true, false, _e479);
                                    } else {
                                        phi_757_ = u32();
                                        phi_758_ = true;
                                    }
                                    let _e485 = phi_757_;
                                    let _e487 = phi_758_;
                                    if _e487 {
                                        if (_e470 < 1023u) {
                                            let _e489 = (_e470 + 1u);
                                            phi_780_ = select(_e470, _e489, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e489)) - 8388608f) * _e456)) ^ _e60)) <= _e451));
                                        } else {
                                            phi_780_ = _e470;
                                        }
                                        let _e500 = phi_780_;
                                        phi_781_ = _e500;
                                    } else {
                                        phi_781_ = _e485;
                                    }
                                    let _e502 = phi_781_;
                                    if (_e502 > 0u) {
                                        let _e511 = (_e139.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e502)) - 8388608f) * _e456)) ^ _e60)));
                                        let _e516 = (select(select(_e139.member_1[2], _e511, (_e511 < _e139.member_1[2])), _e139.member_1[2], (_e502 == 1023u)) > _e211.member.z);
                                        if _e516 {
                                            phi_816_ = (_e502 - 1u);
                                        } else {
                                            phi_816_ = u32();
                                        }
                                        let _e519 = phi_816_;
                                        phi_818_ = _e519;
                                        phi_819_ = select(true, false, _e516);
                                    } else {
                                        phi_818_ = u32();
                                        phi_819_ = true;
                                    }
                                    let _e522 = phi_818_;
                                    let _e524 = phi_819_;
                                    if _e524 {
                                        if (_e502 < 1023u) {
                                            let _e526 = (_e502 + 1u);
                                            let _e534 = (_e139.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e526)) - 8388608f) * _e456)) ^ _e60)));
                                            phi_859_ = select(_e502, _e526, (select(select(_e139.member_1[2], _e534, (_e534 < _e139.member_1[2])), _e139.member_1[2], (_e526 == 1023u)) <= _e211.member.z));
                                        } else {
                                            phi_859_ = _e502;
                                        }
                                        let _e542 = phi_859_;
                                        phi_860_ = _e542;
                                    } else {
                                        phi_860_ = _e522;
                                    }
                                    let _e544 = phi_860_;
                                    let _e552 = (_e139.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e544)) - 8388608f) * _e456)) ^ _e60)));
                                    let _e561 = ((select(_e325, 0u, (select(select(_e139.member_1[0], _e333, (_e333 < _e139.member_1[0])), _e139.member_1[0], (_e325 == 1023u)) > _e211.member.x)) | (select(_e433, 0u, (select(select(_e139.member_1[1], _e441, (_e441 < _e139.member_1[1])), _e139.member_1[1], (_e433 == 1023u)) > _e211.member.y)) << bitcast<u32>(10i))) | (select(_e544, 0u, (select(select(_e139.member_1[2], _e552, (_e552 < _e139.member_1[2])), _e139.member_1[2], (_e544 == 1023u)) > _e211.member.z)) << bitcast<u32>(20i)));
                                    let _e562 = (_e211.member_1.x - _e139.member[0]);
                                    if _e238 {
                                        phi_906_ = (_e562 / _e237);
                                    } else {
                                        phi_906_ = 0f;
                                    }
                                    let _e565 = phi_906_;
                                    let _e567 = select(1023f, _e565, (_e565 < 1023f));
                                    let _e575 = bitcast<u32>(select(0i, select(select(i32(_e567), i32(-2147483648), (_e567 < -2147483600f)), 2147483647i, (_e567 > 2147483500f)), (_e567 == _e567)));
                                    if (_e575 > 0u) {
                                        let _e584 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e575)) - 8388608f) * _e237)) ^ _e60)) > _e562);
                                        if _e584 {
                                            phi_939_ = (_e575 - 1u);
                                        } else {
                                            phi_939_ = u32();
                                        }
                                        let _e587 = phi_939_;
                                        phi_941_ = _e587;
                                        phi_942_ = select(true, false, _e584);
                                    } else {
                                        phi_941_ = u32();
                                        phi_942_ = true;
                                    }
                                    let _e590 = phi_941_;
                                    let _e592 = phi_942_;
                                    if _e592 {
                                        if (_e575 < 1023u) {
                                            let _e594 = (_e575 + 1u);
                                            phi_964_ = select(_e575, _e594, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e594)) - 8388608f) * _e237)) ^ _e60)) <= _e562));
                                        } else {
                                            phi_964_ = _e575;
                                        }
                                        let _e605 = phi_964_;
                                        phi_965_ = _e605;
                                    } else {
                                        phi_965_ = _e590;
                                    }
                                    let _e607 = phi_965_;
                                    if (_e607 > 0u) {
                                        let _e616 = (_e139.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e607)) - 8388608f) * _e237)) ^ _e60)));
                                        let _e621 = (select(select(_e139.member_1[0], _e616, (_e616 < _e139.member_1[0])), _e139.member_1[0], (_e607 == 1023u)) > _e211.member_1.x);
                                        if _e621 {
                                            phi_1000_ = (_e607 - 1u);
                                        } else {
                                            phi_1000_ = u32();
                                        }
                                        let _e624 = phi_1000_;
                                        phi_1002_ = _e624;
                                        phi_1003_ = select(true, false, _e621);
                                    } else {
                                        phi_1002_ = u32();
                                        phi_1003_ = true;
                                    }
                                    let _e627 = phi_1002_;
                                    let _e629 = phi_1003_;
                                    if _e629 {
                                        if (_e607 < 1023u) {
                                            let _e631 = (_e607 + 1u);
                                            let _e639 = (_e139.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e631)) - 8388608f) * _e237)) ^ _e60)));
                                            phi_1043_ = select(_e607, _e631, (select(select(_e139.member_1[0], _e639, (_e639 < _e139.member_1[0])), _e139.member_1[0], (_e631 == 1023u)) <= _e211.member_1.x));
                                        } else {
                                            phi_1043_ = _e607;
                                        }
                                        let _e647 = phi_1043_;
                                        phi_1044_ = _e647;
                                    } else {
                                        phi_1044_ = _e627;
                                    }
                                    let _e649 = phi_1044_;
                                    let _e657 = (_e139.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e649)) - 8388608f) * _e237)) ^ _e60)));
                                    let _e663 = select(_e649, 0u, (select(select(_e139.member_1[0], _e657, (_e657 < _e139.member_1[0])), _e139.member_1[0], (_e649 == 1023u)) > _e211.member_1.x));
                                    if (_e663 < 1023u) {
                                        let _e672 = (_e139.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e663)) - 8388608f) * _e237)) ^ _e60)));
                                        let _e677 = (select(select(_e139.member_1[0], _e672, (_e672 < _e139.member_1[0])), _e139.member_1[0], (_e663 == 1023u)) < _e211.member_1.x);
                                        if _e677 {
                                            phi_1109_ = (_e663 + 1u);
                                        } else {
                                            phi_1109_ = u32();
                                        }
                                        let _e680 = phi_1109_;
                                        phi_1111_ = _e680;
                                        phi_1112_ = select(true, false, _e677);
                                    } else {
                                        phi_1111_ = u32();
                                        phi_1112_ = true;
                                    }
                                    let _e683 = phi_1111_;
                                    let _e685 = phi_1112_;
                                    let _e686 = select(_e683, _e663, _e685);
                                    let _e694 = (_e139.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e686)) - 8388608f) * _e237)) ^ _e60)));
                                    let _e701 = (_e211.member_1.y - _e139.member[1]);
                                    if _e346 {
                                        phi_1160_ = (_e701 / _e345);
                                    } else {
                                        phi_1160_ = 0f;
                                    }
                                    let _e704 = phi_1160_;
                                    let _e706 = select(1023f, _e704, (_e704 < 1023f));
                                    let _e714 = bitcast<u32>(select(0i, select(select(i32(_e706), i32(-2147483648), (_e706 < -2147483600f)), 2147483647i, (_e706 > 2147483500f)), (_e706 == _e706)));
                                    if (_e714 > 0u) {
                                        let _e723 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e714)) - 8388608f) * _e345)) ^ _e60)) > _e701);
                                        if _e723 {
                                            phi_1193_ = (_e714 - 1u);
                                        } else {
                                            phi_1193_ = u32();
                                        }
                                        let _e726 = phi_1193_;
                                        phi_1195_ = _e726;
                                        phi_1196_ = select(true, false, _e723);
                                    } else {
                                        phi_1195_ = u32();
                                        phi_1196_ = true;
                                    }
                                    let _e729 = phi_1195_;
                                    let _e731 = phi_1196_;
                                    if _e731 {
                                        if (_e714 < 1023u) {
                                            let _e733 = (_e714 + 1u);
                                            phi_1218_ = select(_e714, _e733, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e733)) - 8388608f) * _e345)) ^ _e60)) <= _e701));
                                        } else {
                                            phi_1218_ = _e714;
                                        }
                                        let _e744 = phi_1218_;
                                        phi_1219_ = _e744;
                                    } else {
                                        phi_1219_ = _e729;
                                    }
                                    let _e746 = phi_1219_;
                                    if (_e746 > 0u) {
                                        let _e755 = (_e139.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e746)) - 8388608f) * _e345)) ^ _e60)));
                                        let _e760 = (select(select(_e139.member_1[1], _e755, (_e755 < _e139.member_1[1])), _e139.member_1[1], (_e746 == 1023u)) > _e211.member_1.y);
                                        if _e760 {
                                            phi_1254_ = (_e746 - 1u);
                                        } else {
                                            phi_1254_ = u32();
                                        }
                                        let _e763 = phi_1254_;
                                        phi_1256_ = _e763;
                                        phi_1257_ = select(true, false, _e760);
                                    } else {
                                        phi_1256_ = u32();
                                        phi_1257_ = true;
                                    }
                                    let _e766 = phi_1256_;
                                    let _e768 = phi_1257_;
                                    if _e768 {
                                        if (_e746 < 1023u) {
                                            let _e770 = (_e746 + 1u);
                                            let _e778 = (_e139.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e770)) - 8388608f) * _e345)) ^ _e60)));
                                            phi_1297_ = select(_e746, _e770, (select(select(_e139.member_1[1], _e778, (_e778 < _e139.member_1[1])), _e139.member_1[1], (_e770 == 1023u)) <= _e211.member_1.y));
                                        } else {
                                            phi_1297_ = _e746;
                                        }
                                        let _e786 = phi_1297_;
                                        phi_1298_ = _e786;
                                    } else {
                                        phi_1298_ = _e766;
                                    }
                                    let _e788 = phi_1298_;
                                    let _e796 = (_e139.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e788)) - 8388608f) * _e345)) ^ _e60)));
                                    let _e802 = select(_e788, 0u, (select(select(_e139.member_1[1], _e796, (_e796 < _e139.member_1[1])), _e139.member_1[1], (_e788 == 1023u)) > _e211.member_1.y));
                                    if (_e802 < 1023u) {
                                        let _e811 = (_e139.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e802)) - 8388608f) * _e345)) ^ _e60)));
                                        let _e816 = (select(select(_e139.member_1[1], _e811, (_e811 < _e139.member_1[1])), _e139.member_1[1], (_e802 == 1023u)) < _e211.member_1.y);
                                        if _e816 {
                                            phi_1363_ = (_e802 + 1u);
                                        } else {
                                            phi_1363_ = u32();
                                        }
                                        let _e819 = phi_1363_;
                                        phi_1365_ = _e819;
                                        phi_1366_ = select(true, false, _e816);
                                    } else {
                                        phi_1365_ = u32();
                                        phi_1366_ = true;
                                    }
                                    let _e822 = phi_1365_;
                                    let _e824 = phi_1366_;
                                    let _e825 = select(_e822, _e802, _e824);
                                    let _e833 = (_e139.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e825)) - 8388608f) * _e345)) ^ _e60)));
                                    let _e843 = (_e211.member_1.z - _e139.member[2]);
                                    if _e457 {
                                        phi_1416_ = (_e843 / _e456);
                                    } else {
                                        phi_1416_ = 0f;
                                    }
                                    let _e846 = phi_1416_;
                                    let _e848 = select(1023f, _e846, (_e846 < 1023f));
                                    let _e856 = bitcast<u32>(select(0i, select(select(i32(_e848), i32(-2147483648), (_e848 < -2147483600f)), 2147483647i, (_e848 > 2147483500f)), (_e848 == _e848)));
                                    if (_e856 > 0u) {
                                        let _e865 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e856)) - 8388608f) * _e456)) ^ _e60)) > _e843);
                                        if _e865 {
                                            phi_1449_ = (_e856 - 1u);
                                        } else {
                                            phi_1449_ = u32();
                                        }
                                        let _e868 = phi_1449_;
                                        phi_1451_ = _e868;
                                        phi_1452_ = select(true, false, _e865);
                                    } else {
                                        phi_1451_ = u32();
                                        phi_1452_ = true;
                                    }
                                    let _e871 = phi_1451_;
                                    let _e873 = phi_1452_;
                                    if _e873 {
                                        if (_e856 < 1023u) {
                                            let _e875 = (_e856 + 1u);
                                            phi_1474_ = select(_e856, _e875, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e875)) - 8388608f) * _e456)) ^ _e60)) <= _e843));
                                        } else {
                                            phi_1474_ = _e856;
                                        }
                                        let _e886 = phi_1474_;
                                        phi_1475_ = _e886;
                                    } else {
                                        phi_1475_ = _e871;
                                    }
                                    let _e888 = phi_1475_;
                                    if (_e888 > 0u) {
                                        let _e897 = (_e139.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e888)) - 8388608f) * _e456)) ^ _e60)));
                                        let _e902 = (select(select(_e139.member_1[2], _e897, (_e897 < _e139.member_1[2])), _e139.member_1[2], (_e888 == 1023u)) > _e211.member_1.z);
                                        if _e902 {
                                            phi_1510_ = (_e888 - 1u);
                                        } else {
                                            phi_1510_ = u32();
                                        }
                                        let _e905 = phi_1510_;
                                        phi_1512_ = _e905;
                                        phi_1513_ = select(true, false, _e902);
                                    } else {
                                        phi_1512_ = u32();
                                        phi_1513_ = true;
                                    }
                                    let _e908 = phi_1512_;
                                    let _e910 = phi_1513_;
                                    if _e910 {
                                        if (_e888 < 1023u) {
                                            let _e912 = (_e888 + 1u);
                                            let _e920 = (_e139.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e912)) - 8388608f) * _e456)) ^ _e60)));
                                            phi_1553_ = select(_e888, _e912, (select(select(_e139.member_1[2], _e920, (_e920 < _e139.member_1[2])), _e139.member_1[2], (_e912 == 1023u)) <= _e211.member_1.z));
                                        } else {
                                            phi_1553_ = _e888;
                                        }
                                        let _e928 = phi_1553_;
                                        phi_1554_ = _e928;
                                    } else {
                                        phi_1554_ = _e908;
                                    }
                                    let _e930 = phi_1554_;
                                    let _e938 = (_e139.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e930)) - 8388608f) * _e456)) ^ _e60)));
                                    let _e944 = select(_e930, 0u, (select(select(_e139.member_1[2], _e938, (_e938 < _e139.member_1[2])), _e139.member_1[2], (_e930 == 1023u)) > _e211.member_1.z));
                                    if (_e944 < 1023u) {
                                        let _e953 = (_e139.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e944)) - 8388608f) * _e456)) ^ _e60)));
                                        let _e958 = (select(select(_e139.member_1[2], _e953, (_e953 < _e139.member_1[2])), _e139.member_1[2], (_e944 == 1023u)) < _e211.member_1.z);
                                        if _e958 {
                                            phi_1619_ = (_e944 + 1u);
                                        } else {
                                            phi_1619_ = u32();
                                        }
                                        let _e961 = phi_1619_;
                                        phi_1621_ = _e961;
                                        phi_1622_ = select(true, false, _e958);
                                    } else {
                                        phi_1621_ = u32();
                                        phi_1622_ = true;
                                    }
                                    let _e964 = phi_1621_;
                                    let _e966 = phi_1622_;
                                    let _e967 = select(_e964, _e944, _e966);
                                    let _e975 = (_e139.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e967)) - 8388608f) * _e456)) ^ _e60)));
                                    let _e984 = ((select(_e686, 1023u, (select(select(_e139.member_1[0], _e694, (_e694 < _e139.member_1[0])), _e139.member_1[0], (_e686 == 1023u)) < _e211.member_1.x)) | (select(_e825, 1023u, (select(select(_e139.member_1[1], _e833, (_e833 < _e139.member_1[1])), _e139.member_1[1], (_e825 == 1023u)) < _e211.member_1.y)) << bitcast<u32>(10i))) | (select(_e967, 1023u, (select(select(_e139.member_1[2], _e975, (_e975 < _e139.member_1[2])), _e139.member_1[2], (_e967 == 1023u)) < _e211.member_1.z)) << bitcast<u32>(20i)));
                                    let _e985 = (_e561 & 1023u);
                                    let _e993 = (_e139.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e985)) - 8388608f) * _e237)) ^ _e60)));
                                    let _e1000 = ((_e561 >> bitcast<u32>(10u)) & 1023u);
                                    let _e1008 = (_e139.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1000)) - 8388608f) * _e345)) ^ _e60)));
                                    let _e1015 = ((_e561 >> bitcast<u32>(20u)) & 1023u);
                                    let _e1023 = (_e139.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1015)) - 8388608f) * _e456)) ^ _e60)));
                                    let _e1029 = (_e984 & 1023u);
                                    let _e1037 = (_e139.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1029)) - 8388608f) * _e237)) ^ _e60)));
                                    let _e1044 = ((_e984 >> bitcast<u32>(10u)) & 1023u);
                                    let _e1052 = (_e139.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1044)) - 8388608f) * _e345)) ^ _e60)));
                                    let _e1059 = ((_e984 >> bitcast<u32>(20u)) & 1023u);
                                    let _e1067 = (_e139.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1059)) - 8388608f) * _e456)) ^ _e60)));
                                    phi_1856_ = type_34(array<f32, 3>(select(select(_e139.member_1[0], _e993, (_e993 < _e139.member_1[0])), _e139.member_1[0], (_e985 == 1023u)), select(select(_e139.member_1[1], _e1008, (_e1008 < _e139.member_1[1])), _e139.member_1[1], (_e1000 == 1023u)), select(select(_e139.member_1[2], _e1023, (_e1023 < _e139.member_1[2])), _e139.member_1[2], (_e1015 == 1023u))), array<f32, 3>(select(select(_e139.member_1[0], _e1037, (_e1037 < _e139.member_1[0])), _e139.member_1[0], (_e1029 == 1023u)), select(select(_e139.member_1[1], _e1052, (_e1052 < _e139.member_1[1])), _e139.member_1[1], (_e1044 == 1023u)), select(select(_e139.member_1[2], _e1067, (_e1067 < _e139.member_1[2])), _e139.member_1[2], (_e1059 == 1023u))));
                                    phi_1857_ = select(_e166.member_2, _e166.member_1, _e173);
                                }
                                let _e1076 = phi_1856_;
                                let _e1078 = phi_1857_;
                                phi_233_ = _e1076;
                                phi_235_ = _e1078;
                                phi_1859_ = select(true, false, _e160);
                            } else {
                                phi_233_ = type_34();
                                phi_235_ = u32();
                                phi_1859_ = false;
                            }
                            let _e1081 = phi_233_;
                            let _e1083 = phi_235_;
                            let _e1085 = phi_1859_;
                            continue;
                            continuing {
                                phi_229_ = _e154;
                                phi_232_ = _e1081;
                                phi_234_ = _e1083;
                                phi_4620_ = false;
                                break if !(_e1085);
                            }
                        }
                        let _e1088 = phi_4620_;
                        if _e1088 {
                            break;
                        }
                        if _e56 {
                        } else {
                            break;
                        }
                        let _e1092 = global_3.member[_e51].member_1;
                        if (_e1092 == 2147483648u) {
                            phi_1887_ = type_24(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            let _e1098 = global_3.member[_e51].member[0u];
                            let _e1103 = global_3.member[_e51].member[1u];
                            let _e1108 = global_3.member[_e51].member[2u];
                            phi_1887_ = type_24(vec3<f32>(_e1098[0], _e1103[0], _e1108[0]), vec3<f32>(_e1098[2], _e1103[2], _e1108[2]));
                        }
                        let _e1119 = phi_1887_;
                        let _e1123 = global_3.member[_e51].member_2;
                        if (_e1123 == 2147483648u) {
                            phi_1909_ = _e1119;
                        } else {
                            let _e1129 = global_3.member[_e51].member[0u];
                            let _e1134 = global_3.member[_e51].member[1u];
                            let _e1139 = global_3.member[_e51].member[2u];
                            phi_1909_ = type_24(vec3<f32>(_e1129[1], _e1134[1], _e1139[1]), vec3<f32>(_e1129[3], _e1134[3], _e1139[3]));
                        }
                        let _e1150 = phi_1909_;
                        let _e1176 = local;
                        let _e1179 = local_1;
                        let _e1187 = (_e1119.member.x - _e1176.member[0]);
                        let _e1192 = bitcast<f32>((bitcast<u32>(((_e1179.member_1[0] - _e1176.member[0]) * 0.0009775171f)) ^ _e60));
                        let _e1193 = (_e1192 > 0f);
                        if _e1193 {
                            phi_1944_ = (_e1187 / _e1192);
                        } else {
                            phi_1944_ = 0f;
                        }
                        let _e1196 = phi_1944_;
                        let _e1198 = select(1023f, _e1196, (_e1196 < 1023f));
                        let _e1206 = bitcast<u32>(select(0i, select(select(i32(_e1198), i32(-2147483648), (_e1198 < -2147483600f)), 2147483647i, (_e1198 > 2147483500f)), (_e1198 == _e1198)));
                        if (_e1206 > 0u) {
                            let _e1215 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1206)) - 8388608f) * _e1192)) ^ _e60)) > _e1187);
                            if _e1215 {
                                phi_1977_ = (_e1206 - 1u);
                            } else {
                                phi_1977_ = u32();
                            }
                            let _e1218 = phi_1977_;
                            phi_1979_ = _e1218;
                            phi_1980_ = select(true, false, _e1215);
                        } else {
                            phi_1979_ = u32();
                            phi_1980_ = true;
                        }
                        let _e1221 = phi_1979_;
                        let _e1223 = phi_1980_;
                        if _e1223 {
                            if (_e1206 < 1023u) {
                                let _e1225 = (_e1206 + 1u);
                                phi_2002_ = select(_e1206, _e1225, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1225)) - 8388608f) * _e1192)) ^ _e60)) <= _e1187));
                            } else {
                                phi_2002_ = _e1206;
                            }
                            let _e1236 = phi_2002_;
                            phi_2003_ = _e1236;
                        } else {
                            phi_2003_ = _e1221;
                        }
                        let _e1238 = phi_2003_;
                        if (_e1238 > 0u) {
                            let _e1247 = (_e1176.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1238)) - 8388608f) * _e1192)) ^ _e60)));
                            let _e1252 = (select(select(_e1179.member_1[0], _e1247, (_e1247 < _e1179.member_1[0])), _e1179.member_1[0], (_e1238 == 1023u)) > _e1119.member.x);
                            if _e1252 {
                                phi_2038_ = (_e1238 - 1u);
                            } else {
                                phi_2038_ = u32();
                            }
                            let _e1255 = phi_2038_;
                            phi_2040_ = _e1255;
                            phi_2041_ = select(true, false, _e1252);
                        } else {
                            phi_2040_ = u32();
                            phi_2041_ = true;
                        }
                        let _e1258 = phi_2040_;
                        let _e1260 = phi_2041_;
                        if _e1260 {
                            if (_e1238 < 1023u) {
                                let _e1262 = (_e1238 + 1u);
                                let _e1270 = (_e1176.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1262)) - 8388608f) * _e1192)) ^ _e60)));
                                phi_2081_ = select(_e1238, _e1262, (select(select(_e1179.member_1[0], _e1270, (_e1270 < _e1179.member_1[0])), _e1179.member_1[0], (_e1262 == 1023u)) <= _e1119.member.x));
                            } else {
                                phi_2081_ = _e1238;
                            }
                            let _e1278 = phi_2081_;
                            phi_2082_ = _e1278;
                        } else {
                            phi_2082_ = _e1258;
                        }
                        let _e1280 = phi_2082_;
                        let _e1288 = (_e1176.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1280)) - 8388608f) * _e1192)) ^ _e60)));
                        let _e1295 = (_e1119.member.y - _e1176.member[1]);
                        let _e1300 = bitcast<f32>((bitcast<u32>(((_e1179.member_1[1] - _e1176.member[1]) * 0.0009775171f)) ^ _e60));
                        let _e1301 = (_e1300 > 0f);
                        if _e1301 {
                            phi_2126_ = (_e1295 / _e1300);
                        } else {
                            phi_2126_ = 0f;
                        }
                        let _e1304 = phi_2126_;
                        let _e1306 = select(1023f, _e1304, (_e1304 < 1023f));
                        let _e1314 = bitcast<u32>(select(0i, select(select(i32(_e1306), i32(-2147483648), (_e1306 < -2147483600f)), 2147483647i, (_e1306 > 2147483500f)), (_e1306 == _e1306)));
                        if (_e1314 > 0u) {
                            let _e1323 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1314)) - 8388608f) * _e1300)) ^ _e60)) > _e1295);
                            if _e1323 {
                                phi_2159_ = (_e1314 - 1u);
                            } else {
                                phi_2159_ = u32();
                            }
                            let _e1326 = phi_2159_;
                            phi_2161_ = _e1326;
                            phi_2162_ = select(true, false, _e1323);
                        } else {
                            phi_2161_ = u32();
                            phi_2162_ = true;
                        }
                        let _e1329 = phi_2161_;
                        let _e1331 = phi_2162_;
                        if _e1331 {
                            if (_e1314 < 1023u) {
                                let _e1333 = (_e1314 + 1u);
                                phi_2184_ = select(_e1314, _e1333, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1333)) - 8388608f) * _e1300)) ^ _e60)) <= _e1295));
                            } else {
                                phi_2184_ = _e1314;
                            }
                            let _e1344 = phi_2184_;
                            phi_2185_ = _e1344;
                        } else {
                            phi_2185_ = _e1329;
                        }
                        let _e1346 = phi_2185_;
                        if (_e1346 > 0u) {
                            let _e1355 = (_e1176.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1346)) - 8388608f) * _e1300)) ^ _e60)));
                            let _e1360 = (select(select(_e1179.member_1[1], _e1355, (_e1355 < _e1179.member_1[1])), _e1179.member_1[1], (_e1346 == 1023u)) > _e1119.member.y);
                            if _e1360 {
                                phi_2220_ = (_e1346 - 1u);
                            } else {
                                phi_2220_ = u32();
                            }
                            let _e1363 = phi_2220_;
                            phi_2222_ = _e1363;
                            phi_2223_ = select(true, false, _e1360);
                        } else {
                            phi_2222_ = u32();
                            phi_2223_ = true;
                        }
                        let _e1366 = phi_2222_;
                        let _e1368 = phi_2223_;
                        if _e1368 {
                            if (_e1346 < 1023u) {
                                let _e1370 = (_e1346 + 1u);
                                let _e1378 = (_e1176.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1370)) - 8388608f) * _e1300)) ^ _e60)));
                                phi_2263_ = select(_e1346, _e1370, (select(select(_e1179.member_1[1], _e1378, (_e1378 < _e1179.member_1[1])), _e1179.member_1[1], (_e1370 == 1023u)) <= _e1119.member.y));
                            } else {
                                phi_2263_ = _e1346;
                            }
                            let _e1386 = phi_2263_;
                            phi_2264_ = _e1386;
                        } else {
                            phi_2264_ = _e1366;
                        }
                        let _e1388 = phi_2264_;
                        let _e1396 = (_e1176.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1388)) - 8388608f) * _e1300)) ^ _e60)));
                        let _e1406 = (_e1119.member.z - _e1176.member[2]);
                        let _e1411 = bitcast<f32>((bitcast<u32>(((_e1179.member_1[2] - _e1176.member[2]) * 0.0009775171f)) ^ _e60));
                        let _e1412 = (_e1411 > 0f);
                        if _e1412 {
                            phi_2310_ = (_e1406 / _e1411);
                        } else {
                            phi_2310_ = 0f;
                        }
                        let _e1415 = phi_2310_;
                        let _e1417 = select(1023f, _e1415, (_e1415 < 1023f));
                        let _e1425 = bitcast<u32>(select(0i, select(select(i32(_e1417), i32(-2147483648), (_e1417 < -2147483600f)), 2147483647i, (_e1417 > 2147483500f)), (_e1417 == _e1417)));
                        if (_e1425 > 0u) {
                            let _e1434 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1425)) - 8388608f) * _e1411)) ^ _e60)) > _e1406);
                            if _e1434 {
                                phi_2343_ = (_e1425 - 1u);
                            } else {
                                phi_2343_ = u32();
                            }
                            let _e1437 = phi_2343_;
                            phi_2345_ = _e1437;
                            phi_2346_ = select(true, false, _e1434);
                        } else {
                            phi_2345_ = u32();
                            phi_2346_ = true;
                        }
                        let _e1440 = phi_2345_;
                        let _e1442 = phi_2346_;
                        if _e1442 {
                            if (_e1425 < 1023u) {
                                let _e1444 = (_e1425 + 1u);
                                phi_2368_ = select(_e1425, _e1444, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1444)) - 8388608f) * _e1411)) ^ _e60)) <= _e1406));
                            } else {
                                phi_2368_ = _e1425;
                            }
                            let _e1455 = phi_2368_;
                            phi_2369_ = _e1455;
                        } else {
                            phi_2369_ = _e1440;
                        }
                        let _e1457 = phi_2369_;
                        if (_e1457 > 0u) {
                            let _e1466 = (_e1176.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1457)) - 8388608f) * _e1411)) ^ _e60)));
                            let _e1471 = (select(select(_e1179.member_1[2], _e1466, (_e1466 < _e1179.member_1[2])), _e1179.member_1[2], (_e1457 == 1023u)) > _e1119.member.z);
                            if _e1471 {
                                phi_2404_ = (_e1457 - 1u);
                            } else {
                                phi_2404_ = u32();
                            }
                            let _e1474 = phi_2404_;
                            phi_2406_ = _e1474;
                            phi_2407_ = select(true, false, _e1471);
                        } else {
                            phi_2406_ = u32();
                            phi_2407_ = true;
                        }
                        let _e1477 = phi_2406_;
                        let _e1479 = phi_2407_;
                        if _e1479 {
                            if (_e1457 < 1023u) {
                                let _e1481 = (_e1457 + 1u);
                                let _e1489 = (_e1176.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1481)) - 8388608f) * _e1411)) ^ _e60)));
                                phi_2447_ = select(_e1457, _e1481, (select(select(_e1179.member_1[2], _e1489, (_e1489 < _e1179.member_1[2])), _e1179.member_1[2], (_e1481 == 1023u)) <= _e1119.member.z));
                            } else {
                                phi_2447_ = _e1457;
                            }
                            let _e1497 = phi_2447_;
                            phi_2448_ = _e1497;
                        } else {
                            phi_2448_ = _e1477;
                        }
                        let _e1499 = phi_2448_;
                        let _e1507 = (_e1176.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1499)) - 8388608f) * _e1411)) ^ _e60)));
                        let _e1517 = (_e1119.member_1.x - _e1176.member[0]);
                        if _e1193 {
                            phi_2494_ = (_e1517 / _e1192);
                        } else {
                            phi_2494_ = 0f;
                        }
                        let _e1520 = phi_2494_;
                        let _e1522 = select(1023f, _e1520, (_e1520 < 1023f));
                        let _e1530 = bitcast<u32>(select(0i, select(select(i32(_e1522), i32(-2147483648), (_e1522 < -2147483600f)), 2147483647i, (_e1522 > 2147483500f)), (_e1522 == _e1522)));
                        if (_e1530 > 0u) {
                            let _e1539 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1530)) - 8388608f) * _e1192)) ^ _e60)) > _e1517);
                            if _e1539 {
                                phi_2527_ = (_e1530 - 1u);
                            } else {
                                phi_2527_ = u32();
                            }
                            let _e1542 = phi_2527_;
                            phi_2529_ = _e1542;
                            phi_2530_ = select(true, false, _e1539);
                        } else {
                            phi_2529_ = u32();
                            phi_2530_ = true;
                        }
                        let _e1545 = phi_2529_;
                        let _e1547 = phi_2530_;
                        if _e1547 {
                            if (_e1530 < 1023u) {
                                let _e1549 = (_e1530 + 1u);
                                phi_2552_ = select(_e1530, _e1549, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1549)) - 8388608f) * _e1192)) ^ _e60)) <= _e1517));
                            } else {
                                phi_2552_ = _e1530;
                            }
                            let _e1560 = phi_2552_;
                            phi_2553_ = _e1560;
                        } else {
                            phi_2553_ = _e1545;
                        }
                        let _e1562 = phi_2553_;
                        if (_e1562 > 0u) {
                            let _e1571 = (_e1176.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1562)) - 8388608f) * _e1192)) ^ _e60)));
                            let _e1576 = (select(select(_e1179.member_1[0], _e1571, (_e1571 < _e1179.member_1[0])), _e1179.member_1[0], (_e1562 == 1023u)) > _e1119.member_1.x);
                            if _e1576 {
                                phi_2588_ = (_e1562 - 1u);
                            } else {
                                phi_2588_ = u32();
                            }
                            let _e1579 = phi_2588_;
                            phi_2590_ = _e1579;
                            phi_2591_ = select(true, false, _e1576);
                        } else {
                            phi_2590_ = u32();
                            phi_2591_ = true;
                        }
                        let _e1582 = phi_2590_;
                        let _e1584 = phi_2591_;
                        if _e1584 {
                            if (_e1562 < 1023u) {
                                let _e1586 = (_e1562 + 1u);
                                let _e1594 = (_e1176.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1586)) - 8388608f) * _e1192)) ^ _e60)));
                                phi_2631_ = select(_e1562, _e1586, (select(select(_e1179.member_1[0], _e1594, (_e1594 < _e1179.member_1[0])), _e1179.member_1[0], (_e1586 == 1023u)) <= _e1119.member_1.x));
                            } else {
                                phi_2631_ = _e1562;
                            }
                            let _e1602 = phi_2631_;
                            phi_2632_ = _e1602;
                        } else {
                            phi_2632_ = _e1582;
                        }
                        let _e1604 = phi_2632_;
                        let _e1612 = (_e1176.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1604)) - 8388608f) * _e1192)) ^ _e60)));
                        let _e1618 = select(_e1604, 0u, (select(select(_e1179.member_1[0], _e1612, (_e1612 < _e1179.member_1[0])), _e1179.member_1[0], (_e1604 == 1023u)) > _e1119.member_1.x));
                        if (_e1618 < 1023u) {
                            let _e1627 = (_e1176.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1618)) - 8388608f) * _e1192)) ^ _e60)));
                            let _e1632 = (select(select(_e1179.member_1[0], _e1627, (_e1627 < _e1179.member_1[0])), _e1179.member_1[0], (_e1618 == 1023u)) < _e1119.member_1.x);
                            if _e1632 {
                                phi_2697_ = (_e1618 + 1u);
                            } else {
                                phi_2697_ = u32();
                            }
                            let _e1635 = phi_2697_;
                            phi_2699_ = _e1635;
                            phi_2700_ = select(true, false, _e1632);
                        } else {
                            phi_2699_ = u32();
                            phi_2700_ = true;
                        }
                        let _e1638 = phi_2699_;
                        let _e1640 = phi_2700_;
                        let _e1641 = select(_e1638, _e1618, _e1640);
                        let _e1649 = (_e1176.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1641)) - 8388608f) * _e1192)) ^ _e60)));
                        let _e1656 = (_e1119.member_1.y - _e1176.member[1]);
                        if _e1301 {
                            phi_2748_ = (_e1656 / _e1300);
                        } else {
                            phi_2748_ = 0f;
                        }
                        let _e1659 = phi_2748_;
                        let _e1661 = select(1023f, _e1659, (_e1659 < 1023f));
                        let _e1669 = bitcast<u32>(select(0i, select(select(i32(_e1661), i32(-2147483648), (_e1661 < -2147483600f)), 2147483647i, (_e1661 > 2147483500f)), (_e1661 == _e1661)));
                        if (_e1669 > 0u) {
                            let _e1678 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1669)) - 8388608f) * _e1300)) ^ _e60)) > _e1656);
                            if _e1678 {
                                phi_2781_ = (_e1669 - 1u);
                            } else {
                                phi_2781_ = u32();
                            }
                            let _e1681 = phi_2781_;
                            phi_2783_ = _e1681;
                            phi_2784_ = select(true, false, _e1678);
                        } else {
                            phi_2783_ = u32();
                            phi_2784_ = true;
                        }
                        let _e1684 = phi_2783_;
                        let _e1686 = phi_2784_;
                        if _e1686 {
                            if (_e1669 < 1023u) {
                                let _e1688 = (_e1669 + 1u);
                                phi_2806_ = select(_e1669, _e1688, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1688)) - 8388608f) * _e1300)) ^ _e60)) <= _e1656));
                            } else {
                                phi_2806_ = _e1669;
                            }
                            let _e1699 = phi_2806_;
                            phi_2807_ = _e1699;
                        } else {
                            phi_2807_ = _e1684;
                        }
                        let _e1701 = phi_2807_;
                        if (_e1701 > 0u) {
                            let _e1710 = (_e1176.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1701)) - 8388608f) * _e1300)) ^ _e60)));
                            let _e1715 = (select(select(_e1179.member_1[1], _e1710, (_e1710 < _e1179.member_1[1])), _e1179.member_1[1], (_e1701 == 1023u)) > _e1119.member_1.y);
                            if _e1715 {
                                phi_2842_ = (_e1701 - 1u);
                            } else {
                                phi_2842_ = u32();
                            }
                            let _e1718 = phi_2842_;
                            phi_2844_ = _e1718;
                            phi_2845_ = select(true, false, _e1715);
                        } else {
                            phi_2844_ = u32();
                            phi_2845_ = true;
                        }
                        let _e1721 = phi_2844_;
                        let _e1723 = phi_2845_;
                        if _e1723 {
                            if (_e1701 < 1023u) {
                                let _e1725 = (_e1701 + 1u);
                                let _e1733 = (_e1176.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1725)) - 8388608f) * _e1300)) ^ _e60)));
                                phi_2885_ = select(_e1701, _e1725, (select(select(_e1179.member_1[1], _e1733, (_e1733 < _e1179.member_1[1])), _e1179.member_1[1], (_e1725 == 1023u)) <= _e1119.member_1.y));
                            } else {
                                phi_2885_ = _e1701;
                            }
                            let _e1741 = phi_2885_;
                            phi_2886_ = _e1741;
                        } else {
                            phi_2886_ = _e1721;
                        }
                        let _e1743 = phi_2886_;
                        let _e1751 = (_e1176.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1743)) - 8388608f) * _e1300)) ^ _e60)));
                        let _e1757 = select(_e1743, 0u, (select(select(_e1179.member_1[1], _e1751, (_e1751 < _e1179.member_1[1])), _e1179.member_1[1], (_e1743 == 1023u)) > _e1119.member_1.y));
                        if (_e1757 < 1023u) {
                            let _e1766 = (_e1176.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1757)) - 8388608f) * _e1300)) ^ _e60)));
                            let _e1771 = (select(select(_e1179.member_1[1], _e1766, (_e1766 < _e1179.member_1[1])), _e1179.member_1[1], (_e1757 == 1023u)) < _e1119.member_1.y);
                            if _e1771 {
                                phi_2951_ = (_e1757 + 1u);
                            } else {
                                phi_2951_ = u32();
                            }
                            let _e1774 = phi_2951_;
                            phi_2953_ = _e1774;
                            phi_2954_ = select(true, false, _e1771);
                        } else {
                            phi_2953_ = u32();
                            phi_2954_ = true;
                        }
                        let _e1777 = phi_2953_;
                        let _e1779 = phi_2954_;
                        let _e1780 = select(_e1777, _e1757, _e1779);
                        let _e1788 = (_e1176.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1780)) - 8388608f) * _e1300)) ^ _e60)));
                        let _e1798 = (_e1119.member_1.z - _e1176.member[2]);
                        if _e1412 {
                            phi_3004_ = (_e1798 / _e1411);
                        } else {
                            phi_3004_ = 0f;
                        }
                        let _e1801 = phi_3004_;
                        let _e1803 = select(1023f, _e1801, (_e1801 < 1023f));
                        let _e1811 = bitcast<u32>(select(0i, select(select(i32(_e1803), i32(-2147483648), (_e1803 < -2147483600f)), 2147483647i, (_e1803 > 2147483500f)), (_e1803 == _e1803)));
                        if (_e1811 > 0u) {
                            let _e1820 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1811)) - 8388608f) * _e1411)) ^ _e60)) > _e1798);
                            if _e1820 {
                                phi_3037_ = (_e1811 - 1u);
                            } else {
                                phi_3037_ = u32();
                            }
                            let _e1823 = phi_3037_;
                            phi_3039_ = _e1823;
                            phi_3040_ = select(true, false, _e1820);
                        } else {
                            phi_3039_ = u32();
                            phi_3040_ = true;
                        }
                        let _e1826 = phi_3039_;
                        let _e1828 = phi_3040_;
                        if _e1828 {
                            if (_e1811 < 1023u) {
                                let _e1830 = (_e1811 + 1u);
                                phi_3062_ = select(_e1811, _e1830, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1830)) - 8388608f) * _e1411)) ^ _e60)) <= _e1798));
                            } else {
                                phi_3062_ = _e1811;
                            }
                            let _e1841 = phi_3062_;
                            phi_3063_ = _e1841;
                        } else {
                            phi_3063_ = _e1826;
                        }
                        let _e1843 = phi_3063_;
                        if (_e1843 > 0u) {
                            let _e1852 = (_e1176.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1843)) - 8388608f) * _e1411)) ^ _e60)));
                            let _e1857 = (select(select(_e1179.member_1[2], _e1852, (_e1852 < _e1179.member_1[2])), _e1179.member_1[2], (_e1843 == 1023u)) > _e1119.member_1.z);
                            if _e1857 {
                                phi_3098_ = (_e1843 - 1u);
                            } else {
                                phi_3098_ = u32();
                            }
                            let _e1860 = phi_3098_;
                            phi_3100_ = _e1860;
                            phi_3101_ = select(true, false, _e1857);
                        } else {
                            phi_3100_ = u32();
                            phi_3101_ = true;
                        }
                        let _e1863 = phi_3100_;
                        let _e1865 = phi_3101_;
                        if _e1865 {
                            if (_e1843 < 1023u) {
                                let _e1867 = (_e1843 + 1u);
                                let _e1875 = (_e1176.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1867)) - 8388608f) * _e1411)) ^ _e60)));
                                phi_3141_ = select(_e1843, _e1867, (select(select(_e1179.member_1[2], _e1875, (_e1875 < _e1179.member_1[2])), _e1179.member_1[2], (_e1867 == 1023u)) <= _e1119.member_1.z));
                            } else {
                                phi_3141_ = _e1843;
                            }
                            let _e1883 = phi_3141_;
                            phi_3142_ = _e1883;
                        } else {
                            phi_3142_ = _e1863;
                        }
                        let _e1885 = phi_3142_;
                        let _e1893 = (_e1176.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1885)) - 8388608f) * _e1411)) ^ _e60)));
                        let _e1899 = select(_e1885, 0u, (select(select(_e1179.member_1[2], _e1893, (_e1893 < _e1179.member_1[2])), _e1179.member_1[2], (_e1885 == 1023u)) > _e1119.member_1.z));
                        if (_e1899 < 1023u) {
                            let _e1908 = (_e1176.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1899)) - 8388608f) * _e1411)) ^ _e60)));
                            let _e1913 = (select(select(_e1179.member_1[2], _e1908, (_e1908 < _e1179.member_1[2])), _e1179.member_1[2], (_e1899 == 1023u)) < _e1119.member_1.z);
                            if _e1913 {
                                phi_3207_ = (_e1899 + 1u);
                            } else {
                                phi_3207_ = u32();
                            }
                            let _e1916 = phi_3207_;
                            phi_3209_ = _e1916;
                            phi_3210_ = select(true, false, _e1913);
                        } else {
                            phi_3209_ = u32();
                            phi_3210_ = true;
                        }
                        let _e1919 = phi_3209_;
                        let _e1921 = phi_3210_;
                        let _e1922 = select(_e1919, _e1899, _e1921);
                        let _e1930 = (_e1176.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1922)) - 8388608f) * _e1411)) ^ _e60)));
                        let _e1941 = (_e1150.member.x - _e1176.member[0]);
                        if _e1193 {
                            phi_3269_ = (_e1941 / _e1192);
                        } else {
                            phi_3269_ = 0f;
                        }
                        let _e1944 = phi_3269_;
                        let _e1946 = select(1023f, _e1944, (_e1944 < 1023f));
                        let _e1954 = bitcast<u32>(select(0i, select(select(i32(_e1946), i32(-2147483648), (_e1946 < -2147483600f)), 2147483647i, (_e1946 > 2147483500f)), (_e1946 == _e1946)));
                        if (_e1954 > 0u) {
                            let _e1963 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1954)) - 8388608f) * _e1192)) ^ _e60)) > _e1941);
                            if _e1963 {
                                phi_3302_ = (_e1954 - 1u);
                            } else {
                                phi_3302_ = u32();
                            }
                            let _e1966 = phi_3302_;
                            phi_3304_ = _e1966;
                            phi_3305_ = select(true, false, _e1963);
                        } else {
                            phi_3304_ = u32();
                            phi_3305_ = true;
                        }
                        let _e1969 = phi_3304_;
                        let _e1971 = phi_3305_;
                        if _e1971 {
                            if (_e1954 < 1023u) {
                                let _e1973 = (_e1954 + 1u);
                                phi_3327_ = select(_e1954, _e1973, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1973)) - 8388608f) * _e1192)) ^ _e60)) <= _e1941));
                            } else {
                                phi_3327_ = _e1954;
                            }
                            let _e1984 = phi_3327_;
                            phi_3328_ = _e1984;
                        } else {
                            phi_3328_ = _e1969;
                        }
                        let _e1986 = phi_3328_;
                        if (_e1986 > 0u) {
                            let _e1995 = (_e1176.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1986)) - 8388608f) * _e1192)) ^ _e60)));
                            let _e2000 = (select(select(_e1179.member_1[0], _e1995, (_e1995 < _e1179.member_1[0])), _e1179.member_1[0], (_e1986 == 1023u)) > _e1150.member.x);
                            if _e2000 {
                                phi_3363_ = (_e1986 - 1u);
                            } else {
                                phi_3363_ = u32();
                            }
                            let _e2003 = phi_3363_;
                            phi_3365_ = _e2003;
                            phi_3366_ = select(true, false, _e2000);
                        } else {
                            phi_3365_ = u32();
                            phi_3366_ = true;
                        }
                        let _e2006 = phi_3365_;
                        let _e2008 = phi_3366_;
                        if _e2008 {
                            if (_e1986 < 1023u) {
                                let _e2010 = (_e1986 + 1u);
                                let _e2018 = (_e1176.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2010)) - 8388608f) * _e1192)) ^ _e60)));
                                phi_3406_ = select(_e1986, _e2010, (select(select(_e1179.member_1[0], _e2018, (_e2018 < _e1179.member_1[0])), _e1179.member_1[0], (_e2010 == 1023u)) <= _e1150.member.x));
                            } else {
                                phi_3406_ = _e1986;
                            }
                            let _e2026 = phi_3406_;
                            phi_3407_ = _e2026;
                        } else {
                            phi_3407_ = _e2006;
                        }
                        let _e2028 = phi_3407_;
                        let _e2036 = (_e1176.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2028)) - 8388608f) * _e1192)) ^ _e60)));
                        let _e2043 = (_e1150.member.y - _e1176.member[1]);
                        if _e1301 {
                            phi_3451_ = (_e2043 / _e1300);
                        } else {
                            phi_3451_ = 0f;
                        }
                        let _e2046 = phi_3451_;
                        let _e2048 = select(1023f, _e2046, (_e2046 < 1023f));
                        let _e2056 = bitcast<u32>(select(0i, select(select(i32(_e2048), i32(-2147483648), (_e2048 < -2147483600f)), 2147483647i, (_e2048 > 2147483500f)), (_e2048 == _e2048)));
                        if (_e2056 > 0u) {
                            let _e2065 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2056)) - 8388608f) * _e1300)) ^ _e60)) > _e2043);
                            if _e2065 {
                                phi_3484_ = (_e2056 - 1u);
                            } else {
                                phi_3484_ = u32();
                            }
                            let _e2068 = phi_3484_;
                            phi_3486_ = _e2068;
                            phi_3487_ = select(true, false, _e2065);
                        } else {
                            phi_3486_ = u32();
                            phi_3487_ = true;
                        }
                        let _e2071 = phi_3486_;
                        let _e2073 = phi_3487_;
                        if _e2073 {
                            if (_e2056 < 1023u) {
                                let _e2075 = (_e2056 + 1u);
                                phi_3509_ = select(_e2056, _e2075, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2075)) - 8388608f) * _e1300)) ^ _e60)) <= _e2043));
                            } else {
                                phi_3509_ = _e2056;
                            }
                            let _e2086 = phi_3509_;
                            phi_3510_ = _e2086;
                        } else {
                            phi_3510_ = _e2071;
                        }
                        let _e2088 = phi_3510_;
                        if (_e2088 > 0u) {
                            let _e2097 = (_e1176.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2088)) - 8388608f) * _e1300)) ^ _e60)));
                            let _e2102 = (select(select(_e1179.member_1[1], _e2097, (_e2097 < _e1179.member_1[1])), _e1179.member_1[1], (_e2088 == 1023u)) > _e1150.member.y);
                            if _e2102 {
                                phi_3545_ = (_e2088 - 1u);
                            } else {
                                phi_3545_ = u32();
                            }
                            let _e2105 = phi_3545_;
                            phi_3547_ = _e2105;
                            phi_3548_ = select(true, false, _e2102);
                        } else {
                            phi_3547_ = u32();
                            phi_3548_ = true;
                        }
                        let _e2108 = phi_3547_;
                        let _e2110 = phi_3548_;
                        if _e2110 {
                            if (_e2088 < 1023u) {
                                let _e2112 = (_e2088 + 1u);
                                let _e2120 = (_e1176.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2112)) - 8388608f) * _e1300)) ^ _e60)));
                                phi_3588_ = select(_e2088, _e2112, (select(select(_e1179.member_1[1], _e2120, (_e2120 < _e1179.member_1[1])), _e1179.member_1[1], (_e2112 == 1023u)) <= _e1150.member.y));
                            } else {
                                phi_3588_ = _e2088;
                            }
                            let _e2128 = phi_3588_;
                            phi_3589_ = _e2128;
                        } else {
                            phi_3589_ = _e2108;
                        }
                        let _e2130 = phi_3589_;
                        let _e2138 = (_e1176.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2130)) - 8388608f) * _e1300)) ^ _e60)));
                        let _e2148 = (_e1150.member.z - _e1176.member[2]);
                        if _e1412 {
                            phi_3635_ = (_e2148 / _e1411);
                        } else {
                            phi_3635_ = 0f;
                        }
                        let _e2151 = phi_3635_;
                        let _e2153 = select(1023f, _e2151, (_e2151 < 1023f));
                        let _e2161 = bitcast<u32>(select(0i, select(select(i32(_e2153), i32(-2147483648), (_e2153 < -2147483600f)), 2147483647i, (_e2153 > 2147483500f)), (_e2153 == _e2153)));
                        if (_e2161 > 0u) {
                            let _e2170 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2161)) - 8388608f) * _e1411)) ^ _e60)) > _e2148);
                            if _e2170 {
                                phi_3668_ = (_e2161 - 1u);
                            } else {
                                phi_3668_ = u32();
                            }
                            let _e2173 = phi_3668_;
                            phi_3670_ = _e2173;
                            phi_3671_ = select(true, false, _e2170);
                        } else {
                            phi_3670_ = u32();
                            phi_3671_ = true;
                        }
                        let _e2176 = phi_3670_;
                        let _e2178 = phi_3671_;
                        if _e2178 {
                            if (_e2161 < 1023u) {
                                let _e2180 = (_e2161 + 1u);
                                phi_3693_ = select(_e2161, _e2180, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2180)) - 8388608f) * _e1411)) ^ _e60)) <= _e2148));
                            } else {
                                phi_3693_ = _e2161;
                            }
                            let _e2191 = phi_3693_;
                            phi_3694_ = _e2191;
                        } else {
                            phi_3694_ = _e2176;
                        }
                        let _e2193 = phi_3694_;
                        if (_e2193 > 0u) {
                            let _e2202 = (_e1176.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2193)) - 8388608f) * _e1411)) ^ _e60)));
                            let _e2207 = (select(select(_e1179.member_1[2], _e2202, (_e2202 < _e1179.member_1[2])), _e1179.member_1[2], (_e2193 == 1023u)) > _e1150.member.z);
                            if _e2207 {
                                phi_3729_ = (_e2193 - 1u);
                            } else {
                                phi_3729_ = u32();
                            }
                            let _e2210 = phi_3729_;
                            phi_3731_ = _e2210;
                            phi_3732_ = select(true, false, _e2207);
                        } else {
                            phi_3731_ = u32();
                            phi_3732_ = true;
                        }
                        let _e2213 = phi_3731_;
                        let _e2215 = phi_3732_;
                        if _e2215 {
                            if (_e2193 < 1023u) {
                                let _e2217 = (_e2193 + 1u);
                                let _e2225 = (_e1176.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2217)) - 8388608f) * _e1411)) ^ _e60)));
                                phi_3772_ = select(_e2193, _e2217, (select(select(_e1179.member_1[2], _e2225, (_e2225 < _e1179.member_1[2])), _e1179.member_1[2], (_e2217 == 1023u)) <= _e1150.member.z));
                            } else {
                                phi_3772_ = _e2193;
                            }
                            let _e2233 = phi_3772_;
                            phi_3773_ = _e2233;
                        } else {
                            phi_3773_ = _e2213;
                        }
                        let _e2235 = phi_3773_;
                        let _e2243 = (_e1176.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2235)) - 8388608f) * _e1411)) ^ _e60)));
                        let _e2253 = (_e1150.member_1.x - _e1176.member[0]);
                        if _e1193 {
                            phi_3819_ = (_e2253 / _e1192);
                        } else {
                            phi_3819_ = 0f;
                        }
                        let _e2256 = phi_3819_;
                        let _e2258 = select(1023f, _e2256, (_e2256 < 1023f));
                        let _e2266 = bitcast<u32>(select(0i, select(select(i32(_e2258), i32(-2147483648), (_e2258 < -2147483600f)), 2147483647i, (_e2258 > 2147483500f)), (_e2258 == _e2258)));
                        if (_e2266 > 0u) {
                            let _e2275 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2266)) - 8388608f) * _e1192)) ^ _e60)) > _e2253);
                            if _e2275 {
                                phi_3852_ = (_e2266 - 1u);
                            } else {
                                phi_3852_ = u32();
                            }
                            let _e2278 = phi_3852_;
                            phi_3854_ = _e2278;
                            phi_3855_ = select(true, false, _e2275);
                        } else {
                            phi_3854_ = u32();
                            phi_3855_ = true;
                        }
                        let _e2281 = phi_3854_;
                        let _e2283 = phi_3855_;
                        if _e2283 {
                            if (_e2266 < 1023u) {
                                let _e2285 = (_e2266 + 1u);
                                phi_3877_ = select(_e2266, _e2285, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2285)) - 8388608f) * _e1192)) ^ _e60)) <= _e2253));
                            } else {
                                phi_3877_ = _e2266;
                            }
                            let _e2296 = phi_3877_;
                            phi_3878_ = _e2296;
                        } else {
                            phi_3878_ = _e2281;
                        }
                        let _e2298 = phi_3878_;
                        if (_e2298 > 0u) {
                            let _e2307 = (_e1176.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2298)) - 8388608f) * _e1192)) ^ _e60)));
                            let _e2312 = (select(select(_e1179.member_1[0], _e2307, (_e2307 < _e1179.member_1[0])), _e1179.member_1[0], (_e2298 == 1023u)) > _e1150.member_1.x);
                            if _e2312 {
                                phi_3913_ = (_e2298 - 1u);
                            } else {
                                phi_3913_ = u32();
                            }
                            let _e2315 = phi_3913_;
                            phi_3915_ = _e2315;
                            phi_3916_ = select(true, false, _e2312);
                        } else {
                            phi_3915_ = u32();
                            phi_3916_ = true;
                        }
                        let _e2318 = phi_3915_;
                        let _e2320 = phi_3916_;
                        if _e2320 {
                            if (_e2298 < 1023u) {
                                let _e2322 = (_e2298 + 1u);
                                let _e2330 = (_e1176.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2322)) - 8388608f) * _e1192)) ^ _e60)));
                                phi_3956_ = select(_e2298, _e2322, (select(select(_e1179.member_1[0], _e2330, (_e2330 < _e1179.member_1[0])), _e1179.member_1[0], (_e2322 == 1023u)) <= _e1150.member_1.x));
                            } else {
                                phi_3956_ = _e2298;
                            }
                            let _e2338 = phi_3956_;
                            phi_3957_ = _e2338;
                        } else {
                            phi_3957_ = _e2318;
                        }
                        let _e2340 = phi_3957_;
                        let _e2348 = (_e1176.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2340)) - 8388608f) * _e1192)) ^ _e60)));
                        let _e2354 = select(_e2340, 0u, (select(select(_e1179.member_1[0], _e2348, (_e2348 < _e1179.member_1[0])), _e1179.member_1[0], (_e2340 == 1023u)) > _e1150.member_1.x));
                        if (_e2354 < 1023u) {
                            let _e2363 = (_e1176.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2354)) - 8388608f) * _e1192)) ^ _e60)));
                            let _e2368 = (select(select(_e1179.member_1[0], _e2363, (_e2363 < _e1179.member_1[0])), _e1179.member_1[0], (_e2354 == 1023u)) < _e1150.member_1.x);
                            if _e2368 {
                                phi_4022_ = (_e2354 + 1u);
                            } else {
                                phi_4022_ = u32();
                            }
                            let _e2371 = phi_4022_;
                            phi_4024_ = _e2371;
                            phi_4025_ = select(true, false, _e2368);
                        } else {
                            phi_4024_ = u32();
                            phi_4025_ = true;
                        }
                        let _e2374 = phi_4024_;
                        let _e2376 = phi_4025_;
                        let _e2377 = select(_e2374, _e2354, _e2376);
                        let _e2385 = (_e1176.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2377)) - 8388608f) * _e1192)) ^ _e60)));
                        let _e2392 = (_e1150.member_1.y - _e1176.member[1]);
                        if _e1301 {
                            phi_4073_ = (_e2392 / _e1300);
                        } else {
                            phi_4073_ = 0f;
                        }
                        let _e2395 = phi_4073_;
                        let _e2397 = select(1023f, _e2395, (_e2395 < 1023f));
                        let _e2405 = bitcast<u32>(select(0i, select(select(i32(_e2397), i32(-2147483648), (_e2397 < -2147483600f)), 2147483647i, (_e2397 > 2147483500f)), (_e2397 == _e2397)));
                        if (_e2405 > 0u) {
                            let _e2414 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2405)) - 8388608f) * _e1300)) ^ _e60)) > _e2392);
                            if _e2414 {
                                phi_4106_ = (_e2405 - 1u);
                            } else {
                                phi_4106_ = u32();
                            }
                            let _e2417 = phi_4106_;
                            phi_4108_ = _e2417;
                            phi_4109_ = select(true, false, _e2414);
                        } else {
                            phi_4108_ = u32();
                            phi_4109_ = true;
                        }
                        let _e2420 = phi_4108_;
                        let _e2422 = phi_4109_;
                        if _e2422 {
                            if (_e2405 < 1023u) {
                                let _e2424 = (_e2405 + 1u);
                                phi_4131_ = select(_e2405, _e2424, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2424)) - 8388608f) * _e1300)) ^ _e60)) <= _e2392));
                            } else {
                                phi_4131_ = _e2405;
                            }
                            let _e2435 = phi_4131_;
                            phi_4132_ = _e2435;
                        } else {
                            phi_4132_ = _e2420;
                        }
                        let _e2437 = phi_4132_;
                        if (_e2437 > 0u) {
                            let _e2446 = (_e1176.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2437)) - 8388608f) * _e1300)) ^ _e60)));
                            let _e2451 = (select(select(_e1179.member_1[1], _e2446, (_e2446 < _e1179.member_1[1])), _e1179.member_1[1], (_e2437 == 1023u)) > _e1150.member_1.y);
                            if _e2451 {
                                phi_4167_ = (_e2437 - 1u);
                            } else {
                                phi_4167_ = u32();
                            }
                            let _e2454 = phi_4167_;
                            phi_4169_ = _e2454;
                            phi_4170_ = select(true, false, _e2451);
                        } else {
                            phi_4169_ = u32();
                            phi_4170_ = true;
                        }
                        let _e2457 = phi_4169_;
                        let _e2459 = phi_4170_;
                        if _e2459 {
                            if (_e2437 < 1023u) {
                                let _e2461 = (_e2437 + 1u);
                                let _e2469 = (_e1176.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2461)) - 8388608f) * _e1300)) ^ _e60)));
                                phi_4210_ = select(_e2437, _e2461, (select(select(_e1179.member_1[1], _e2469, (_e2469 < _e1179.member_1[1])), _e1179.member_1[1], (_e2461 == 1023u)) <= _e1150.member_1.y));
                            } else {
                                phi_4210_ = _e2437;
                            }
                            let _e2477 = phi_4210_;
                            phi_4211_ = _e2477;
                        } else {
                            phi_4211_ = _e2457;
                        }
                        let _e2479 = phi_4211_;
                        let _e2487 = (_e1176.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2479)) - 8388608f) * _e1300)) ^ _e60)));
                        let _e2493 = select(_e2479, 0u, (select(select(_e1179.member_1[1], _e2487, (_e2487 < _e1179.member_1[1])), _e1179.member_1[1], (_e2479 == 1023u)) > _e1150.member_1.y));
                        if (_e2493 < 1023u) {
                            let _e2502 = (_e1176.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2493)) - 8388608f) * _e1300)) ^ _e60)));
                            let _e2507 = (select(select(_e1179.member_1[1], _e2502, (_e2502 < _e1179.member_1[1])), _e1179.member_1[1], (_e2493 == 1023u)) < _e1150.member_1.y);
                            if _e2507 {
                                phi_4276_ = (_e2493 + 1u);
                            } else {
                                phi_4276_ = u32();
                            }
                            let _e2510 = phi_4276_;
                            phi_4278_ = _e2510;
                            phi_4279_ = select(true, false, _e2507);
                        } else {
                            phi_4278_ = u32();
                            phi_4279_ = true;
                        }
                        let _e2513 = phi_4278_;
                        let _e2515 = phi_4279_;
                        let _e2516 = select(_e2513, _e2493, _e2515);
                        let _e2524 = (_e1176.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2516)) - 8388608f) * _e1300)) ^ _e60)));
                        let _e2534 = (_e1150.member_1.z - _e1176.member[2]);
                        if _e1412 {
                            phi_4329_ = (_e2534 / _e1411);
                        } else {
                            phi_4329_ = 0f;
                        }
                        let _e2537 = phi_4329_;
                        let _e2539 = select(1023f, _e2537, (_e2537 < 1023f));
                        let _e2547 = bitcast<u32>(select(0i, select(select(i32(_e2539), i32(-2147483648), (_e2539 < -2147483600f)), 2147483647i, (_e2539 > 2147483500f)), (_e2539 == _e2539)));
                        if (_e2547 > 0u) {
                            let _e2556 = (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2547)) - 8388608f) * _e1411)) ^ _e60)) > _e2534);
                            if _e2556 {
                                phi_4362_ = (_e2547 - 1u);
                            } else {
                                phi_4362_ = u32();
                            }
                            let _e2559 = phi_4362_;
                            phi_4364_ = _e2559;
                            phi_4365_ = select(true, false, _e2556);
                        } else {
                            phi_4364_ = u32();
                            phi_4365_ = true;
                        }
                        let _e2562 = phi_4364_;
                        let _e2564 = phi_4365_;
                        if _e2564 {
                            if (_e2547 < 1023u) {
                                let _e2566 = (_e2547 + 1u);
                                phi_4387_ = select(_e2547, _e2566, (bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2566)) - 8388608f) * _e1411)) ^ _e60)) <= _e2534));
                            } else {
                                phi_4387_ = _e2547;
                            }
                            let _e2577 = phi_4387_;
                            phi_4388_ = _e2577;
                        } else {
                            phi_4388_ = _e2562;
                        }
                        let _e2579 = phi_4388_;
                        if (_e2579 > 0u) {
                            let _e2588 = (_e1176.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2579)) - 8388608f) * _e1411)) ^ _e60)));
                            let _e2593 = (select(select(_e1179.member_1[2], _e2588, (_e2588 < _e1179.member_1[2])), _e1179.member_1[2], (_e2579 == 1023u)) > _e1150.member_1.z);
                            if _e2593 {
                                phi_4423_ = (_e2579 - 1u);
                            } else {
                                phi_4423_ = u32();
                            }
                            let _e2596 = phi_4423_;
                            phi_4425_ = _e2596;
                            phi_4426_ = select(true, false, _e2593);
                        } else {
                            phi_4425_ = u32();
                            phi_4426_ = true;
                        }
                        let _e2599 = phi_4425_;
                        let _e2601 = phi_4426_;
                        if _e2601 {
                            if (_e2579 < 1023u) {
                                let _e2603 = (_e2579 + 1u);
                                let _e2611 = (_e1176.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2603)) - 8388608f) * _e1411)) ^ _e60)));
                                phi_4466_ = select(_e2579, _e2603, (select(select(_e1179.member_1[2], _e2611, (_e2611 < _e1179.member_1[2])), _e1179.member_1[2], (_e2603 == 1023u)) <= _e1150.member_1.z));
                            } else {
                                phi_4466_ = _e2579;
                            }
                            let _e2619 = phi_4466_;
                            phi_4467_ = _e2619;
                        } else {
                            phi_4467_ = _e2599;
                        }
                        let _e2621 = phi_4467_;
                        let _e2629 = (_e1176.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2621)) - 8388608f) * _e1411)) ^ _e60)));
                        let _e2635 = select(_e2621, 0u, (select(select(_e1179.member_1[2], _e2629, (_e2629 < _e1179.member_1[2])), _e1179.member_1[2], (_e2621 == 1023u)) > _e1150.member_1.z));
                        if (_e2635 < 1023u) {
                            let _e2644 = (_e1176.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2635)) - 8388608f) * _e1411)) ^ _e60)));
                            let _e2649 = (select(select(_e1179.member_1[2], _e2644, (_e2644 < _e1179.member_1[2])), _e1179.member_1[2], (_e2635 == 1023u)) < _e1150.member_1.z);
                            if _e2649 {
                                phi_4532_ = (_e2635 + 1u);
                            } else {
                                phi_4532_ = u32();
                            }
                            let _e2652 = phi_4532_;
                            phi_4534_ = _e2652;
                            phi_4535_ = select(true, false, _e2649);
                        } else {
                            phi_4534_ = u32();
                            phi_4535_ = true;
                        }
                        let _e2655 = phi_4534_;
                        let _e2657 = phi_4535_;
                        let _e2658 = select(_e2655, _e2635, _e2657);
                        let _e2666 = (_e1176.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e2658)) - 8388608f) * _e1411)) ^ _e60)));
                        if _e57 {
                        } else {
                            break;
                        }
                        global_4.member[_e51] = type_30(array<u32, 2>(((select(_e1280, 0u, (select(select(_e1179.member_1[0], _e1288, (_e1288 < _e1179.member_1[0])), _e1179.member_1[0], (_e1280 == 1023u)) > _e1119.member.x)) | (select(_e1388, 0u, (select(select(_e1179.member_1[1], _e1396, (_e1396 < _e1179.member_1[1])), _e1179.member_1[1], (_e1388 == 1023u)) > _e1119.member.y)) << bitcast<u32>(10i))) | (select(_e1499, 0u, (select(select(_e1179.member_1[2], _e1507, (_e1507 < _e1179.member_1[2])), _e1179.member_1[2], (_e1499 == 1023u)) > _e1119.member.z)) << bitcast<u32>(20i))), ((select(_e1641, 1023u, (select(select(_e1179.member_1[0], _e1649, (_e1649 < _e1179.member_1[0])), _e1179.member_1[0], (_e1641 == 1023u)) < _e1119.member_1.x)) | (select(_e1780, 1023u, (select(select(_e1179.member_1[1], _e1788, (_e1788 < _e1179.member_1[1])), _e1179.member_1[1], (_e1780 == 1023u)) < _e1119.member_1.y)) << bitcast<u32>(10i))) | (select(_e1922, 1023u, (select(select(_e1179.member_1[2], _e1930, (_e1930 < _e1179.member_1[2])), _e1179.member_1[2], (_e1922 == 1023u)) < _e1119.member_1.z)) << bitcast<u32>(20i)))), array<u32, 2>(((select(_e2028, 0u, (select(select(_e1179.member_1[0], _e2036, (_e2036 < _e1179.member_1[0])), _e1179.member_1[0], (_e2028 == 1023u)) > _e1150.member.x)) | (select(_e2130, 0u, (select(select(_e1179.member_1[1], _e2138, (_e2138 < _e1179.member_1[1])), _e1179.member_1[1], (_e2130 == 1023u)) > _e1150.member.y)) << bitcast<u32>(10i))) | (select(_e2235, 0u, (select(select(_e1179.member_1[2], _e2243, (_e2243 < _e1179.member_1[2])), _e1179.member_1[2], (_e2235 == 1023u)) > _e1150.member.z)) << bitcast<u32>(20i))), ((select(_e2377, 1023u, (select(select(_e1179.member_1[0], _e2385, (_e2385 < _e1179.member_1[0])), _e1179.member_1[0], (_e2377 == 1023u)) < _e1150.member_1.x)) | (select(_e2516, 1023u, (select(select(_e1179.member_1[1], _e2524, (_e2524 < _e1179.member_1[1])), _e1179.member_1[1], (_e2516 == 1023u)) < _e1150.member_1.y)) << bitcast<u32>(10i))) | (select(_e2658, 1023u, (select(select(_e1179.member_1[2], _e2666, (_e2666 < _e1179.member_1[2])), _e1179.member_1[2], (_e2658 == 1023u)) < _e1150.member_1.z)) << bitcast<u32>(20i)))), _e1092, _e1123);
                        if (_e51 == 0u) {
                            if (_e47 == 0u) {
                            } else {
                                if (0u < _e47) {
                                } else {
                                    break;
                                }
                                global_5.member[0u] = type_25(array<u32, 4>(bitcast<u32>(_e1176.member[0]), bitcast<u32>(_e1176.member[1]), bitcast<u32>(_e1176.member[2]), 0u), array<u32, 4>(bitcast<u32>(_e1179.member_1[0]), bitcast<u32>(_e1179.member_1[1]), bitcast<u32>(_e1179.member_1[2]), 0u));
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
