struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: vec4<u32>,
}

struct type_15 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_26 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_31 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_32 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_34 {
    member: array<type_32>,
}

struct type_37 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_39 {
    member: array<type_37>,
}

struct type_41 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_43 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_45 {
    member: array<type_43>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_9;
@group(0) @binding(3) 
var<storage> global_2: type_17;
@group(0) @binding(1) 
var<uniform> global_3: type_9;
@group(0) @binding(2) 
var<storage> global_4: type_28;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_39;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_45;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_34;

fn function_() {
    var phi_166_: type_26;
    var phi_184_: type_31;
    var phi_202_: type_31;
    var phi_254_: type_4;
    var phi_257_: type_41;
    var phi_259_: u32;
    var phi_255_: type_4;
    var phi_282_: type_4;
    var phi_304_: type_26;
    var phi_313_: bool;
    var phi_331_: type_31;
    var phi_349_: type_31;
    var phi_353_: type_31;
    var phi_377_: f32;
    var phi_428_: u32;
    var phi_430_: u32;
    var phi_431_: bool;
    var phi_469_: u32;
    var phi_470_: u32;
    var phi_508_: f32;
    var phi_559_: u32;
    var phi_561_: u32;
    var phi_562_: bool;
    var phi_600_: u32;
    var phi_601_: u32;
    var phi_641_: f32;
    var phi_692_: u32;
    var phi_694_: u32;
    var phi_695_: bool;
    var phi_733_: u32;
    var phi_734_: u32;
    var phi_774_: f32;
    var phi_825_: u32;
    var phi_827_: u32;
    var phi_828_: bool;
    var phi_866_: u32;
    var phi_867_: u32;
    var phi_928_: u32;
    var phi_930_: u32;
    var phi_931_: bool;
    var phi_973_: f32;
    var phi_1024_: u32;
    var phi_1026_: u32;
    var phi_1027_: bool;
    var phi_1065_: u32;
    var phi_1066_: u32;
    var phi_1127_: u32;
    var phi_1129_: u32;
    var phi_1130_: bool;
    var phi_1174_: f32;
    var phi_1225_: u32;
    var phi_1227_: u32;
    var phi_1228_: bool;
    var phi_1266_: u32;
    var phi_1267_: u32;
    var phi_1328_: u32;
    var phi_1330_: u32;
    var phi_1331_: bool;
    var phi_1551_: type_41;
    var phi_1552_: u32;
    var phi_258_: type_41;
    var phi_260_: u32;
    var phi_1554_: bool;
    var phi_7781_: bool;
    var phi_1582_: type_31;
    var phi_1604_: type_31;
    var local: type_41;
    var local_1: type_41;
    var phi_1635_: f32;
    var phi_1686_: u32;
    var phi_1688_: u32;
    var phi_1689_: bool;
    var phi_1727_: u32;
    var phi_1728_: u32;
    var phi_1766_: f32;
    var phi_1817_: u32;
    var phi_1819_: u32;
    var phi_1820_: bool;
    var phi_1858_: u32;
    var phi_1859_: u32;
    var phi_1899_: f32;
    var phi_1950_: u32;
    var phi_1952_: u32;
    var phi_1953_: bool;
    var phi_1991_: u32;
    var phi_1992_: u32;
    var phi_2032_: f32;
    var phi_2083_: u32;
    var phi_2085_: u32;
    var phi_2086_: bool;
    var phi_2124_: u32;
    var phi_2125_: u32;
    var phi_2186_: u32;
    var phi_2188_: u32;
    var phi_2189_: bool;
    var phi_2231_: f32;
    var phi_2282_: u32;
    var phi_2284_: u32;
    var phi_2285_: bool;
    var phi_2323_: u32;
    var phi_2324_: u32;
    var phi_2385_: u32;
    var phi_2387_: u32;
    var phi_2388_: bool;
    var phi_2432_: f32;
    var phi_2483_: u32;
    var phi_2485_: u32;
    var phi_2486_: bool;
    var phi_2524_: u32;
    var phi_2525_: u32;
    var phi_2586_: u32;
    var phi_2588_: u32;
    var phi_2589_: bool;
    var phi_2642_: f32;
    var phi_2693_: u32;
    var phi_2695_: u32;
    var phi_2696_: bool;
    var phi_2734_: u32;
    var phi_2735_: u32;
    var phi_2773_: f32;
    var phi_2824_: u32;
    var phi_2826_: u32;
    var phi_2827_: bool;
    var phi_2865_: u32;
    var phi_2866_: u32;
    var phi_2906_: f32;
    var phi_2957_: u32;
    var phi_2959_: u32;
    var phi_2960_: bool;
    var phi_2998_: u32;
    var phi_2999_: u32;
    var phi_3039_: f32;
    var phi_3090_: u32;
    var phi_3092_: u32;
    var phi_3093_: bool;
    var phi_3131_: u32;
    var phi_3132_: u32;
    var phi_3193_: u32;
    var phi_3195_: u32;
    var phi_3196_: bool;
    var phi_3238_: f32;
    var phi_3289_: u32;
    var phi_3291_: u32;
    var phi_3292_: bool;
    var phi_3330_: u32;
    var phi_3331_: u32;
    var phi_3392_: u32;
    var phi_3394_: u32;
    var phi_3395_: bool;
    var phi_3439_: f32;
    var phi_3490_: u32;
    var phi_3492_: u32;
    var phi_3493_: bool;
    var phi_3531_: u32;
    var phi_3532_: u32;
    var phi_3593_: u32;
    var phi_3595_: u32;
    var phi_3596_: bool;
    var phi_4018_: type_4;
    var phi_4019_: type_4;
    var phi_4042_: type_4;
    var phi_4081_: f32;
    var phi_4132_: u32;
    var phi_4134_: u32;
    var phi_4135_: bool;
    var phi_4173_: u32;
    var phi_4174_: u32;
    var phi_4208_: u32;
    var phi_4277_: f32;
    var phi_4328_: u32;
    var phi_4330_: u32;
    var phi_4331_: bool;
    var phi_4369_: u32;
    var phi_4370_: u32;
    var phi_4404_: u32;
    var phi_4475_: f32;
    var phi_4526_: u32;
    var phi_4528_: u32;
    var phi_4529_: bool;
    var phi_4567_: u32;
    var phi_4568_: u32;
    var phi_4602_: u32;
    var phi_4679_: f32;
    var phi_4730_: u32;
    var phi_4732_: u32;
    var phi_4733_: bool;
    var phi_4771_: u32;
    var phi_4772_: u32;
    var phi_4806_: u32;
    var phi_4875_: f32;
    var phi_4926_: u32;
    var phi_4928_: u32;
    var phi_4929_: bool;
    var phi_4967_: u32;
    var phi_4968_: u32;
    var phi_5002_: u32;
    var phi_5073_: f32;
    var phi_5124_: u32;
    var phi_5126_: u32;
    var phi_5127_: bool;
    var phi_5165_: u32;
    var phi_5166_: u32;
    var phi_5200_: u32;
    var phi_5277_: f32;
    var phi_5328_: u32;
    var phi_5330_: u32;
    var phi_5331_: bool;
    var phi_5369_: u32;
    var phi_5370_: u32;
    var phi_5404_: u32;
    var phi_5473_: f32;
    var phi_5524_: u32;
    var phi_5526_: u32;
    var phi_5527_: bool;
    var phi_5565_: u32;
    var phi_5566_: u32;
    var phi_5600_: u32;
    var phi_5671_: f32;
    var phi_5722_: u32;
    var phi_5724_: u32;
    var phi_5725_: bool;
    var phi_5763_: u32;
    var phi_5764_: u32;
    var phi_5798_: u32;
    var phi_7927_: bool;
    var phi_8380_: bool;
    var phi_5889_: type_4;
    var phi_5890_: type_4;
    var phi_5913_: type_4;
    var phi_5952_: f32;
    var phi_6003_: u32;
    var phi_6005_: u32;
    var phi_6006_: bool;
    var phi_6044_: u32;
    var phi_6045_: u32;
    var phi_6079_: u32;
    var phi_6148_: f32;
    var phi_6199_: u32;
    var phi_6201_: u32;
    var phi_6202_: bool;
    var phi_6240_: u32;
    var phi_6241_: u32;
    var phi_6275_: u32;
    var phi_6346_: f32;
    var phi_6397_: u32;
    var phi_6399_: u32;
    var phi_6400_: bool;
    var phi_6438_: u32;
    var phi_6439_: u32;
    var phi_6473_: u32;
    var phi_6550_: f32;
    var phi_6601_: u32;
    var phi_6603_: u32;
    var phi_6604_: bool;
    var phi_6642_: u32;
    var phi_6643_: u32;
    var phi_6677_: u32;
    var phi_6746_: f32;
    var phi_6797_: u32;
    var phi_6799_: u32;
    var phi_6800_: bool;
    var phi_6838_: u32;
    var phi_6839_: u32;
    var phi_6873_: u32;
    var phi_6944_: f32;
    var phi_6995_: u32;
    var phi_6997_: u32;
    var phi_6998_: bool;
    var phi_7036_: u32;
    var phi_7037_: u32;
    var phi_7071_: u32;
    var phi_7148_: f32;
    var phi_7199_: u32;
    var phi_7201_: u32;
    var phi_7202_: bool;
    var phi_7240_: u32;
    var phi_7241_: u32;
    var phi_7275_: u32;
    var phi_7344_: f32;
    var phi_7395_: u32;
    var phi_7397_: u32;
    var phi_7398_: bool;
    var phi_7436_: u32;
    var phi_7437_: u32;
    var phi_7471_: u32;
    var phi_7542_: f32;
    var phi_7593_: u32;
    var phi_7595_: u32;
    var phi_7596_: bool;
    var phi_7634_: u32;
    var phi_7635_: u32;
    var phi_7669_: u32;
    var phi_8376_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e47 = global;
            let _e49 = arrayLength((&global_4.member));
            let _e51 = arrayLength((&global_2.member));
            let _e55 = arrayLength((&global_6.member));
            let _e57 = arrayLength((&global_7.member));
            let _e61 = (_e47.x + (_e47.y * 2097152u));
            let _e64 = global_1.member[0u];
            if (_e61 < _e64) {
                let _e66 = (_e61 < _e49);
                if _e66 {
                    let _e67 = (_e61 < arrayLength((&global_5.member)));
                    if _e67 {
                        let _e70 = global_3.member[0u];
                        let _e71 = (0u < _e49);
                        if _e71 {
                            if _e71 {
                            } else {
                                break;
                            }
                            let _e74 = global_4.member[0u];
                            phi_166_ = _e74;
                        } else {
                            phi_166_ = type_26(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e76 = phi_166_;
                        if (_e76.member_1 == 2147483648u) {
                            phi_184_ = type_31(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            phi_184_ = type_31(vec3<f32>(_e76.member[0][0], _e76.member[1][0], _e76.member[2][0]), vec3<f32>(_e76.member[0][2], _e76.member[1][2], _e76.member[2][2]));
                        }
                        let _e95 = phi_184_;
                        if (_e76.member_2 == 2147483648u) {
                            phi_202_ = _e95;
                        } else {
                            phi_202_ = type_31(vec3<f32>(_e76.member[0][1], _e76.member[1][1], _e76.member[2][1]), vec3<f32>(_e76.member[0][3], _e76.member[1][3], _e76.member[2][3]));
                        }
                        let _e114 = phi_202_;
                        phi_254_ = type_4(0u, 128u);
                        phi_257_ = type_41(array<f32, 3>(select(_e114.member.x, _e95.member.x, (_e95.member.x < _e114.member.x)), select(_e114.member.y, _e95.member.y, (_e95.member.y < _e114.member.y)), select(_e114.member.z, _e95.member.z, (_e95.member.z < _e114.member.z))), array<f32, 3>(select(_e114.member_1.x, _e95.member_1.x, (_e95.member_1.x > _e114.member_1.x)), select(_e114.member_1.y, _e95.member_1.y, (_e95.member_1.y > _e114.member_1.y)), select(_e114.member_1.z, _e95.member_1.z, (_e95.member_1.z > _e114.member_1.z))));
                        phi_259_ = 0u;
                        loop {
                            let _e147 = phi_254_;
                            let _e149 = phi_257_;
                            let _e151 = phi_259_;
                            local = _e149;
                            local_1 = _e149;
                            if (_e147.member < _e147.member_1) {
                                phi_255_ = type_4((_e147.member + 1u), _e147.member_1);
                                phi_282_ = type_4(1u, _e147.member);
                            } else {
                                phi_255_ = _e147;
                                phi_282_ = type_4(0u, type_4().member_1);
                            }
                            let _e164 = phi_255_;
                            let _e166 = phi_282_;
                            if (bitcast<i32>(_e166.member) != 0i) {
                                let _e170 = (_e151 == _e61);
                                if _e170 {
                                    phi_1551_ = type_41();
                                    phi_1552_ = u32();
                                } else {
                                    let _e171 = (_e151 < _e49);
                                    if _e171 {
                                        if _e171 {
                                        } else {
                                            phi_7781_ = true;
                                            break;
                                        }
                                        let _e174 = global_4.member[_e151];
                                        phi_304_ = _e174;
                                    } else {
                                        phi_304_ = type_26(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e176 = phi_304_;
                                    if ((_e176.member_1 & 2147483648u) != 0u) {
                                        phi_313_ = false;
                                    } else {
                                        phi_313_ = (_e61 <= _e176.member_1);
                                    }
                                    let _e183 = phi_313_;
                                    if (_e176.member_1 == 2147483648u) {
                                        phi_331_ = type_31(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                    } else {
                                        phi_331_ = type_31(vec3<f32>(_e176.member[0][0], _e176.member[1][0], _e176.member[2][0]), vec3<f32>(_e176.member[0][2], _e176.member[1][2], _e176.member[2][2]));
                                    }
                                    let _e201 = phi_331_;
                                    if (_e176.member_2 == 2147483648u) {
                                        phi_349_ = _e201;
                                    } else {
                                        phi_349_ = type_31(vec3<f32>(_e176.member[0][1], _e176.member[1][1], _e176.member[2][1]), vec3<f32>(_e176.member[0][3], _e176.member[1][3], _e176.member[2][3]));
                                    }
                                    let _e219 = phi_349_;
                                    if _e183 {
                                        phi_353_ = _e201;
                                    } else {
                                        phi_353_ = _e219;
                                    }
                                    let _e221 = phi_353_;
                                    let _e242 = (_e149.member_1[0] - _e149.member[0]);
                                    let _e243 = (_e242 > 0f);
                                    if _e243 {
                                        phi_377_ = (((_e221.member.x - _e149.member[0]) / _e242) * 1023f);
                                    } else {
                                        phi_377_ = 0f;
                                    }
                                    let _e248 = phi_377_;
                                    let _e250 = select(1023f, _e248, (_e248 < 1023f));
                                    let _e252 = select(0f, _e250, (_e250 > 0f));
                                    let _e257 = select(select(u32(_e252), 0u, (_e252 < 0f)), 4294967295u, (_e252 > 4294967000f));
                                    if (_e257 > 0u) {
                                        let _e268 = (_e149.member[0] + bitcast<f32>((bitcast<u32>((f32(_e257) * bitcast<f32>((bitcast<u32>((_e242 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                        let _e273 = (select(select(_e149.member_1[0], _e268, (_e268 < _e149.member_1[0])), _e149.member_1[0], (_e257 == 1023u)) > _e221.member.x);
                                        if _e273 {
                                            phi_428_ = (_e257 - 1u);
                                        } else {
                                            phi_428_ = u32();
                                        }
                                        let _e276 = phi_428_;
                                        phi_430_ = _e276;
                                        phi_431_ = select(true, false, _e273);
                                    } else {
                                        phi_430_ = u32();
                                        phi_431_ = true;
                                    }
                                    let _e279 = phi_430_;
                                    let _e281 = phi_431_;
                                    if _e281 {
                                        if (_e257 < 1023u) {
                                            let _e283 = (_e257 + 1u);
                                            let _e293 = (_e149.member[0] + bitcast<f32>((bitcast<u32>((f32(_e283) * bitcast<f32>((bitcast<u32>((_e242 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                            phi_469_ = select(_e257, _e283, (select(select(_e149.member_1[0], _e293, (_e293 < _e149.member_1[0])), _e149.member_1[0], (_e283 == 1023u)) <= _e221.member.x));
                                        } else {
                                            phi_469_ = _e257;
                                        }
                                        let _e301 = phi_469_;
                                        phi_470_ = _e301;
                                    } else {
                                        phi_470_ = _e279;
                                    }
                                    let _e303 = phi_470_;
                                    let _e307 = bitcast<f32>((bitcast<u32>((_e242 * 0.0009775171f)) ^ _e70));
                                    let _e313 = (_e149.member[0] + bitcast<f32>((bitcast<u32>((f32(_e303) * _e307)) ^ _e70)));
                                    let _e320 = (_e149.member_1[1] - _e149.member[1]);
                                    let _e321 = (_e320 > 0f);
                                    if _e321 {
                                        phi_508_ = (((_e221.member.y - _e149.member[1]) / _e320) * 1023f);
                                    } else {
                                        phi_508_ = 0f;
                                    }
                                    let _e326 = phi_508_;
                                    let _e328 = select(1023f, _e326, (_e326 < 1023f));
                                    let _e330 = select(0f, _e328, (_e328 > 0f));
                                    let _e335 = select(select(u32(_e330), 0u, (_e330 < 0f)), 4294967295u, (_e330 > 4294967000f));
                                    if (_e335 > 0u) {
                                        let _e346 = (_e149.member[1] + bitcast<f32>((bitcast<u32>((f32(_e335) * bitcast<f32>((bitcast<u32>((_e320 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                        let _e351 = (select(select(_e149.member_1[1], _e346, (_e346 < _e149.member_1[1])), _e149.member_1[1], (_e335 == 1023u)) > _e221.member.y);
                                        if _e351 {
                                            phi_559_ = (_e335 - 1u);
                                        } else {
                                            phi_559_ = u32();
                                        }
                                        let _e354 = phi_559_;
                                        phi_561_ = _e354;
                                        phi_562_ = select(true, false, _e351);
                                    } else {
                                        phi_561_ = u32();
                                        phi_562_ = true;
                                    }
                                    let _e357 = phi_561_;
                                    let _e359 = phi_562_;
                                    if _e359 {
                                        if (_e335 < 1023u) {
                                            let _e361 = (_e335 + 1u);
                                            let _e371 = (_e149.member[1] + bitcast<f32>((bitcast<u32>((f32(_e361) * bitcast<f32>((bitcast<u32>((_e320 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                            phi_600_ = select(_e335, _e361, (select(select(_e149.member_1[1], _e371, (_e371 < _e149.member_1[1])), _e149.member_1[1], (_e361 == 1023u)) <= _e221.member.y));
                                        } else {
                                            phi_600_ = _e335;
                                        }
                                        let _e379 = phi_600_;
                                        phi_601_ = _e379;
                                    } else {
                                        phi_601_ = _e357;
                                    }
                                    let _e381 = phi_601_;
                                    let _e385 = bitcast<f32>((bitcast<u32>((_e320 * 0.0009775171f)) ^ _e70));
                                    let _e391 = (_e149.member[1] + bitcast<f32>((bitcast<u32>((f32(_e381) * _e385)) ^ _e70)));
                                    let _e401 = (_e149.member_1[2] - _e149.member[2]);
                                    let _e402 = (_e401 > 0f);
                                    if _e402 {
                                        phi_641_ = (((_e221.member.z - _e149.member[2]) / _e401) * 1023f);
                                    } else {
                                        phi_641_ = 0f;
                                    }
                                    let _e407 = phi_641_;
                                    let _e409 = select(1023f, _e407, (_e407 < 1023f));
                                    let _e411 = select(0f, _e409, (_e409 > 0f));
                                    let _e416 = select(select(u32(_e411), 0u, (_e411 < 0f)), 4294967295u, (_e411 > 4294967000f));
                                    if (_e416 > 0u) {
                                        let _e427 = (_e149.member[2] + bitcast<f32>((bitcast<u32>((f32(_e416) * bitcast<f32>((bitcast<u32>((_e401 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                        let _e432 = (select(select(_e149.member_1[2], _e427, (_e427 < _e149.member_1[2])), _e149.member_1[2], (_e416 == 1023u)) > _e221.member.z);
                                        if _e432 {
                                            phi_692_ = (_e416 - 1u);
                                        } else {
                                            phi_692_ = u32();
                                        }
                                        let _e435 = phi_692_;
                                        phi_694_ = _e435;
                                        phi_695_ = select(true, false, _e432);
                                    } else {
                                        phi_694_ = u32();
                                        phi_695_ = true;
                                    }
                                    let _e438 = phi_694_;
                                    let _e440 = phi_695_;
                                    if _e440 {
                                        if (_e416 < 1023u) {
                                            let _e442 = (_e416 + 1u);
                                            let _e452 = (_e149.member[2] + bitcast<f32>((bitcast<u32>((f32(_e442) * bitcast<f32>((bitcast<u32>((_e401 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                            phi_733_ = select(_e416, _e442, (select(select(_e149.member_1[2], _e452, (_e452 < _e149.member_1[2])), _e149.member_1[2], (_e442 == 1023u)) <= _e221.member.z));
                                        } else {
                                            phi_733_ = _e416;
                                        }
                                        let _e460 = phi_733_;
                                        phi_734_ = _e460;
                                    } else {
                                        phi_734_ = _e438;
                                    }
                                    let _e462 = phi_734_;
                                    let _e466 = bitcast<f32>((bitcast<u32>((_e401 * 0.0009775171f)) ^ _e70));
                                    let _e472 = (_e149.member[2] + bitcast<f32>((bitcast<u32>((f32(_e462) * _e466)) ^ _e70)));
                                    let _e481 = ((select(_e303, 0u, (select(select(_e149.member_1[0], _e313, (_e313 < _e149.member_1[0])), _e149.member_1[0], (_e303 == 1023u)) > _e221.member.x)) | (select(_e381, 0u, (select(select(_e149.member_1[1], _e391, (_e391 < _e149.member_1[1])), _e149.member_1[1], (_e381 == 1023u)) > _e221.member.y)) << bitcast<u32>(10i))) | (select(_e462, 0u, (select(select(_e149.member_1[2], _e472, (_e472 < _e149.member_1[2])), _e149.member_1[2], (_e462 == 1023u)) > _e221.member.z)) << bitcast<u32>(20i)));
                                    if _e243 {
                                        phi_774_ = (((_e221.member_1.x - _e149.member[0]) / _e242) * 1023f);
                                    } else {
                                        phi_774_ = 0f;
                                    }
                                    let _e486 = phi_774_;
                                    let _e488 = select(1023f, _e486, (_e486 < 1023f));
                                    let _e490 = select(0f, _e488, (_e488 > 0f));
                                    let _e495 = select(select(u32(_e490), 0u, (_e490 < 0f)), 4294967295u, (_e490 > 4294967000f));
                                    if (_e495 > 0u) {
                                        let _e502 = (_e149.member[0] + bitcast<f32>((bitcast<u32>((f32(_e495) * _e307)) ^ _e70)));
                                        let _e507 = (select(select(_e149.member_1[0], _e502, (_e502 < _e149.member_1[0])), _e149.member_1[0], (_e495 == 1023u)) > _e221.member_1.x);
                                        if _e507 {
                                            phi_825_ = (_e495 - 1u);
                                        } else {
                                            phi_825_ = u32();
                                        }
                                        let _e510 = phi_825_;
                                        phi_827_ = _e510;
                                        phi_828_ = select(true, false, _e507);
                                    } else {
                                        phi_827_ = u32();
                                        phi_828_ = true;
                                    }
                                    let _e513 = phi_827_;
                                    let _e515 = phi_828_;
                                    if _e515 {
                                        if (_e495 < 1023u) {
                                            let _e517 = (_e495 + 1u);
                                            let _e523 = (_e149.member[0] + bitcast<f32>((bitcast<u32>((f32(_e517) * _e307)) ^ _e70)));
                                            phi_866_ = select(_e495, _e517, (select(select(_e149.member_1[0], _e523, (_e523 < _e149.member_1[0])), _e149.member_1[0], (_e517 == 1023u)) <= _e221.member_1.x));
                                        } else {
                                            phi_866_ = _e495;
                                        }
                                        let _e531 = phi_866_;
                                        phi_867_ = _e531;
                                    } else {
                                        phi_867_ = _e513;
                                    }
                                    let _e533 = phi_867_;
                                    let _e539 = (_e149.member[0] + bitcast<f32>((bitcast<u32>((f32(_e533) * _e307)) ^ _e70)));
                                    let _e545 = select(_e533, 0u, (select(select(_e149.member_1[0], _e539, (_e539 < _e149.member_1[0])), _e149.member_1[0], (_e533 == 1023u)) > _e221.member_1.x));
                                    if (_e545 < 1023u) {
                                        let _e552 = (_e149.member[0] + bitcast<f32>((bitcast<u32>((f32(_e545) * _e307)) ^ _e70)));
                                        let _e557 = (select(select(_e149.member_1[0], _e552, (_e552 < _e149.member_1[0])), _e149.member_1[0], (_e545 == 1023u)) < _e221.member_1.x);
                                        if _e557 {
                                            phi_928_ = (_e545 + 1u);
                                        } else {
                                            phi_928_ = u32();
                                        }
                                        let _e560 = phi_928_;
                                        phi_930_ = _e560;
                                        phi_931_ = select(true, false, _e557);
                                    } else {
                                        phi_930_ = u32();
                                        phi_931_ = true;
                                    }
                                    let _e563 = phi_930_;
                                    let _e565 = phi_931_;
                                    let _e566 = select(_e563, _e545, _e565);
                                    let _e572 = (_e149.member[0] + bitcast<f32>((bitcast<u32>((f32(_e566) * _e307)) ^ _e70)));
                                    if _e321 {
                                        phi_973_ = (((_e221.member_1.y - _e149.member[1]) / _e320) * 1023f);
                                    } else {
                                        phi_973_ = 0f;
                                    }
                                    let _e583 = phi_973_;
                                    let _e585 = select(1023f, _e583, (_e583 < 1023f));
                                    let _e587 = select(0f, _e585, (_e585 > 0f));
                                    let _e592 = select(select(u32(_e587), 0u, (_e587 < 0f)), 4294967295u, (_e587 > 4294967000f));
                                    if (_e592 > 0u) {
                                        let _e599 = (_e149.member[1] + bitcast<f32>((bitcast<u32>((f32(_e592) * _e385)) ^ _e70)));
                                        let _e604 = (select(select(_e149.member_1[1], _e599, (_e599 < _e149.member_1[1])), _e149.member_1[1], (_e592 == 1023u)) > _e221.member_1.y);
                                        if _e604 {
                                            phi_1024_ = (_e592 - 1u);
                                        } else {
                                            phi_1024_ = u32();
                                        }
                                        let _e607 = phi_1024_;
                                        phi_1026_ = _e607;
                                        phi_1027_ = select(true, false, _e604);
                                    } else {
                                        phi_1026_ = u32();
                                        phi_1027_ = true;
                                    }
                                    let _e610 = phi_1026_;
                                    let _e612 = phi_1027_;
                                    if _e612 {
                                        if (_e592 < 1023u) {
                                            let _e614 = (_e592 + 1u);
                                            let _e620 = (_e149.member[1] + bitcast<f32>((bitcast<u32>((f32(_e614) * _e385)) ^ _e70)));
                                            phi_1065_ = select(_e592, _e614, (select(select(_e149.member_1[1], _e620, (_e620 < _e149.member_1[1])), _e149.member_1[1], (_e614 == 1023u)) <= _e221.member_1.y));
                                        } else {
                                            phi_1065_ = _e592;
                                        }
                                        let _e628 = phi_1065_;
                                        phi_1066_ = _e628;
                                    } else {
                                        phi_1066_ = _e610;
                                    }
                                    let _e630 = phi_1066_;
                                    let _e636 = (_e149.member[1] + bitcast<f32>((bitcast<u32>((f32(_e630) * _e385)) ^ _e70)));
                                    let _e642 = select(_e630, 0u, (select(select(_e149.member_1[1], _e636, (_e636 < _e149.member_1[1])), _e149.member_1[1], (_e630 == 1023u)) > _e221.member_1.y));
                                    if (_e642 < 1023u) {
                                        let _e649 = (_e149.member[1] + bitcast<f32>((bitcast<u32>((f32(_e642) * _e385)) ^ _e70)));
                                        let _e654 = (select(select(_e149.member_1[1], _e649, (_e649 < _e149.member_1[1])), _e149.member_1[1], (_e642 == 1023u)) < _e221.member_1.y);
                                        if _e654 {
                                            phi_1127_ = (_e642 + 1u);
                                        } else {
                                            phi_1127_ = u32();
                                        }
                                        let _e657 = phi_1127_;
                                        phi_1129_ = _e657;
                                        phi_1130_ = select(true, false, _e654);
                                    } else {
                                        phi_1129_ = u32();
                                        phi_1130_ = true;
                                    }
                                    let _e660 = phi_1129_;
                                    let _e662 = phi_1130_;
                                    let _e663 = select(_e660, _e642, _e662);
                                    let _e669 = (_e149.member[1] + bitcast<f32>((bitcast<u32>((f32(_e663) * _e385)) ^ _e70)));
                                    if _e402 {
                                        phi_1174_ = (((_e221.member_1.z - _e149.member[2]) / _e401) * 1023f);
                                    } else {
                                        phi_1174_ = 0f;
                                    }
                                    let _e683 = phi_1174_;
                                    let _e685 = select(1023f, _e683, (_e683 < 1023f));
                                    let _e687 = select(0f, _e685, (_e685 > 0f));
                                    let _e692 = select(select(u32(_e687), 0u, (_e687 < 0f)), 4294967295u, (_e687 > 4294967000f));
                                    if (_e692 > 0u) {
                                        let _e699 = (_e149.member[2] + bitcast<f32>((bitcast<u32>((f32(_e692) * _e466)) ^ _e70)));
                                        let _e704 = (select(select(_e149.member_1[2], _e699, (_e699 < _e149.member_1[2])), _e149.member_1[2], (_e692 == 1023u)) > _e221.member_1.z);
                                        if _e704 {
                                            phi_1225_ = (_e692 - 1u);
                                        } else {
                                            phi_1225_ = u32();
                                        }
                                        let _e707 = phi_1225_;
                                        phi_1227_ = _e707;
                                        phi_1228_ = select(true, false, _e704);
                                    } else {
                                        phi_1227_ = u32();
                                        phi_1228_ = true;
                                    }
                                    let _e710 = phi_1227_;
                                    let _e712 = phi_1228_;
                                    if _e712 {
                                        if (_e692 < 1023u) {
                                            let _e714 = (_e692 + 1u);
                                            let _e720 = (_e149.member[2] + bitcast<f32>((bitcast<u32>((f32(_e714) * _e466)) ^ _e70)));
                                            phi_1266_ = select(_e692, _e714, (select(select(_e149.member_1[2], _e720, (_e720 < _e149.member_1[2])), _e149.member_1[2], (_e714 == 1023u)) <= _e221.member_1.z));
                                        } else {
                                            phi_1266_ = _e692;
                                        }
                                        let _e728 = phi_1266_;
                                        phi_1267_ = _e728;
                                    } else {
                                        phi_1267_ = _e710;
                                    }
                                    let _e730 = phi_1267_;
                                    let _e736 = (_e149.member[2] + bitcast<f32>((bitcast<u32>((f32(_e730) * _e466)) ^ _e70)));
                                    let _e742 = select(_e730, 0u, (select(select(_e149.member_1[2], _e736, (_e736 < _e149.member_1[2])), _e149.member_1[2], (_e730 == 1023u)) > _e221.member_1.z));
                                    if (_e742 < 1023u) {
                                        let _e749 = (_e149.member[2] + bitcast<f32>((bitcast<u32>((f32(_e742) * _e466)) ^ _e70)));
                                        let _e754 = (select(select(_e149.member_1[2], _e749, (_e749 < _e149.member_1[2])), _e149.member_1[2], (_e742 == 1023u)) < _e221.member_1.z);
                                        if _e754 {
                                            phi_1328_ = (_e742 + 1u);
                                        } else {
                                            phi_1328_ = u32();
                                        }
                                        let _e757 = phi_1328_;
                                        phi_1330_ = _e757;
                                        phi_1331_ = select(true, false, _e754);
                                    } else {
                                        phi_1330_ = u32();
                                        phi_1331_ = true;
                                    }
                                    let _e760 = phi_1330_;
                                    let _e762 = phi_1331_;
                                    let _e763 = select(_e760, _e742, _e762);
                                    let _e769 = (_e149.member[2] + bitcast<f32>((bitcast<u32>((f32(_e763) * _e466)) ^ _e70)));
                                    let _e778 = ((select(_e566, 1023u, (select(select(_e149.member_1[0], _e572, (_e572 < _e149.member_1[0])), _e149.member_1[0], (_e566 == 1023u)) < _e221.member_1.x)) | (select(_e663, 1023u, (select(select(_e149.member_1[1], _e669, (_e669 < _e149.member_1[1])), _e149.member_1[1], (_e663 == 1023u)) < _e221.member_1.y)) << bitcast<u32>(10i))) | (select(_e763, 1023u, (select(select(_e149.member_1[2], _e769, (_e769 < _e149.member_1[2])), _e149.member_1[2], (_e763 == 1023u)) < _e221.member_1.z)) << bitcast<u32>(20i)));
                                    let _e779 = (_e481 & 1023u);
                                    let _e785 = (_e149.member[0] + bitcast<f32>((bitcast<u32>((f32(_e779) * _e307)) ^ _e70)));
                                    let _e792 = ((_e481 >> bitcast<u32>(10u)) & 1023u);
                                    let _e798 = (_e149.member[1] + bitcast<f32>((bitcast<u32>((f32(_e792) * _e385)) ^ _e70)));
                                    let _e805 = ((_e481 >> bitcast<u32>(20u)) & 1023u);
                                    let _e811 = (_e149.member[2] + bitcast<f32>((bitcast<u32>((f32(_e805) * _e466)) ^ _e70)));
                                    let _e817 = (_e778 & 1023u);
                                    let _e823 = (_e149.member[0] + bitcast<f32>((bitcast<u32>((f32(_e817) * _e307)) ^ _e70)));
                                    let _e830 = ((_e778 >> bitcast<u32>(10u)) & 1023u);
                                    let _e836 = (_e149.member[1] + bitcast<f32>((bitcast<u32>((f32(_e830) * _e385)) ^ _e70)));
                                    let _e843 = ((_e778 >> bitcast<u32>(20u)) & 1023u);
                                    let _e849 = (_e149.member[2] + bitcast<f32>((bitcast<u32>((f32(_e843) * _e466)) ^ _e70)));
                                    phi_1551_ = type_41(array<f32, 3>(select(select(_e149.member_1[0], _e785, (_e785 < _e149.member_1[0])), _e149.member_1[0], (_e779 == 1023u)), select(select(_e149.member_1[1], _e798, (_e798 < _e149.member_1[1])), _e149.member_1[1], (_e792 == 1023u)), select(select(_e149.member_1[2], _e811, (_e811 < _e149.member_1[2])), _e149.member_1[2], (_e805 == 1023u))), array<f32, 3>(select(select(_e149.member_1[0], _e823, (_e823 < _e149.member_1[0])), _e149.member_1[0], (_e817 == 1023u)), select(select(_e149.member_1[1], _e836, (_e836 < _e149.member_1[1])), _e149.member_1[1], (_e830 == 1023u)), select(select(_e149.member_1[2], _e849, (_e849 < _e149.member_1[2])), _e149.member_1[2], (_e843 == 1023u))));
                                    phi_1552_ = select(_e176.member_2, _e176.member_1, _e183);
                                }
                                let _e858 = phi_1551_;
                                let _e860 = phi_1552_;
                                phi_258_ = _e858;
                                phi_260_ = _e860;
                                phi_1554_ = select(true, false, _e170);
                            } else {
                                phi_258_ = type_41();
                                phi_260_ = u32();
                                phi_1554_ = false;
                            }
                            let _e863 = phi_258_;
                            let _e865 = phi_260_;
                            let _e867 = phi_1554_;
                            continue;
                            continuing {
                                phi_254_ = _e164;
                                phi_257_ = _e863;
                                phi_259_ = _e865;
                                phi_7781_ = false;
                                break if !(_e867);
                            }
                        }
                        let _e870 = phi_7781_;
                        if _e870 {
                            break;
                        }
                        if _e66 {
                        } else {
                            break;
                        }
                        let _e874 = global_4.member[_e61].member_1;
                        if (_e874 == 2147483648u) {
                            phi_1582_ = type_31(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            let _e880 = global_4.member[_e61].member[0u];
                            let _e885 = global_4.member[_e61].member[1u];
                            let _e890 = global_4.member[_e61].member[2u];
                            phi_1582_ = type_31(vec3<f32>(_e880[0], _e885[0], _e890[0]), vec3<f32>(_e880[2], _e885[2], _e890[2]));
                        }
                        let _e901 = phi_1582_;
                        let _e905 = global_4.member[_e61].member_2;
                        if (_e905 == 2147483648u) {
                            phi_1604_ = _e901;
                        } else {
                            let _e911 = global_4.member[_e61].member[0u];
                            let _e916 = global_4.member[_e61].member[1u];
                            let _e921 = global_4.member[_e61].member[2u];
                            phi_1604_ = type_31(vec3<f32>(_e911[1], _e916[1], _e921[1]), vec3<f32>(_e911[3], _e916[3], _e921[3]));
                        }
                        let _e932 = phi_1604_;
                        let _e958 = local;
                        let _e961 = local_1;
                        let _e969 = (_e961.member_1[0] - _e958.member[0]);
                        let _e970 = (_e969 > 0f);
                        if _e970 {
                            phi_1635_ = (((_e901.member.x - _e958.member[0]) / _e969) * 1023f);
                        } else {
                            phi_1635_ = 0f;
                        }
                        let _e975 = phi_1635_;
                        let _e977 = select(1023f, _e975, (_e975 < 1023f));
                        let _e979 = select(0f, _e977, (_e977 > 0f));
                        let _e984 = select(select(u32(_e979), 0u, (_e979 < 0f)), 4294967295u, (_e979 > 4294967000f));
                        if (_e984 > 0u) {
                            let _e995 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e984) * bitcast<f32>((bitcast<u32>((_e969 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                            let _e1000 = (select(select(_e961.member_1[0], _e995, (_e995 < _e961.member_1[0])), _e961.member_1[0], (_e984 == 1023u)) > _e901.member.x);
                            if _e1000 {
                                phi_1686_ = (_e984 - 1u);
                            } else {
                                phi_1686_ = u32();
                            }
                            let _e1003 = phi_1686_;
                            phi_1688_ = _e1003;
                            phi_1689_ = select(true, false, _e1000);
                        } else {
                            phi_1688_ = u32();
                            phi_1689_ = true;
                        }
                        let _e1006 = phi_1688_;
                        let _e1008 = phi_1689_;
                        if _e1008 {
                            if (_e984 < 1023u) {
                                let _e1010 = (_e984 + 1u);
                                let _e1020 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1010) * bitcast<f32>((bitcast<u32>((_e969 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                phi_1727_ = select(_e984, _e1010, (select(select(_e961.member_1[0], _e1020, (_e1020 < _e961.member_1[0])), _e961.member_1[0], (_e1010 == 1023u)) <= _e901.member.x));
                            } else {
                                phi_1727_ = _e984;
                            }
                            let _e1028 = phi_1727_;
                            phi_1728_ = _e1028;
                        } else {
                            phi_1728_ = _e1006;
                        }
                        let _e1030 = phi_1728_;
                        let _e1034 = bitcast<f32>((bitcast<u32>((_e969 * 0.0009775171f)) ^ _e70));
                        let _e1040 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1030) * _e1034)) ^ _e70)));
                        let _e1047 = (_e961.member_1[1] - _e958.member[1]);
                        let _e1048 = (_e1047 > 0f);
                        if _e1048 {
                            phi_1766_ = (((_e901.member.y - _e958.member[1]) / _e1047) * 1023f);
                        } else {
                            phi_1766_ = 0f;
                        }
                        let _e1053 = phi_1766_;
                        let _e1055 = select(1023f, _e1053, (_e1053 < 1023f));
                        let _e1057 = select(0f, _e1055, (_e1055 > 0f));
                        let _e1062 = select(select(u32(_e1057), 0u, (_e1057 < 0f)), 4294967295u, (_e1057 > 4294967000f));
                        if (_e1062 > 0u) {
                            let _e1073 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1062) * bitcast<f32>((bitcast<u32>((_e1047 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                            let _e1078 = (select(select(_e961.member_1[1], _e1073, (_e1073 < _e961.member_1[1])), _e961.member_1[1], (_e1062 == 1023u)) > _e901.member.y);
                            if _e1078 {
                                phi_1817_ = (_e1062 - 1u);
                            } else {
                                phi_1817_ = u32();
                            }
                            let _e1081 = phi_1817_;
                            phi_1819_ = _e1081;
                            phi_1820_ = select(true, false, _e1078);
                        } else {
                            phi_1819_ = u32();
                            phi_1820_ = true;
                        }
                        let _e1084 = phi_1819_;
                        let _e1086 = phi_1820_;
                        if _e1086 {
                            if (_e1062 < 1023u) {
                                let _e1088 = (_e1062 + 1u);
                                let _e1098 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1088) * bitcast<f32>((bitcast<u32>((_e1047 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                phi_1858_ = select(_e1062, _e1088, (select(select(_e961.member_1[1], _e1098, (_e1098 < _e961.member_1[1])), _e961.member_1[1], (_e1088 == 1023u)) <= _e901.member.y));
                            } else {
                                phi_1858_ = _e1062;
                            }
                            let _e1106 = phi_1858_;
                            phi_1859_ = _e1106;
                        } else {
                            phi_1859_ = _e1084;
                        }
                        let _e1108 = phi_1859_;
                        let _e1112 = bitcast<f32>((bitcast<u32>((_e1047 * 0.0009775171f)) ^ _e70));
                        let _e1118 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1108) * _e1112)) ^ _e70)));
                        let _e1128 = (_e961.member_1[2] - _e958.member[2]);
                        let _e1129 = (_e1128 > 0f);
                        if _e1129 {
                            phi_1899_ = (((_e901.member.z - _e958.member[2]) / _e1128) * 1023f);
                        } else {
                            phi_1899_ = 0f;
                        }
                        let _e1134 = phi_1899_;
                        let _e1136 = select(1023f, _e1134, (_e1134 < 1023f));
                        let _e1138 = select(0f, _e1136, (_e1136 > 0f));
                        let _e1143 = select(select(u32(_e1138), 0u, (_e1138 < 0f)), 4294967295u, (_e1138 > 4294967000f));
                        if (_e1143 > 0u) {
                            let _e1154 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1143) * bitcast<f32>((bitcast<u32>((_e1128 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                            let _e1159 = (select(select(_e961.member_1[2], _e1154, (_e1154 < _e961.member_1[2])), _e961.member_1[2], (_e1143 == 1023u)) > _e901.member.z);
                            if _e1159 {
                                phi_1950_ = (_e1143 - 1u);
                            } else {
                                phi_1950_ = u32();
                            }
                            let _e1162 = phi_1950_;
                            phi_1952_ = _e1162;
                            phi_1953_ = select(true, false, _e1159);
                        } else {
                            phi_1952_ = u32();
                            phi_1953_ = true;
                        }
                        let _e1165 = phi_1952_;
                        let _e1167 = phi_1953_;
                        if _e1167 {
                            if (_e1143 < 1023u) {
                                let _e1169 = (_e1143 + 1u);
                                let _e1179 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1169) * bitcast<f32>((bitcast<u32>((_e1128 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                phi_1991_ = select(_e1143, _e1169, (select(select(_e961.member_1[2], _e1179, (_e1179 < _e961.member_1[2])), _e961.member_1[2], (_e1169 == 1023u)) <= _e901.member.z));
                            } else {
                                phi_1991_ = _e1143;
                            }
                            let _e1187 = phi_1991_;
                            phi_1992_ = _e1187;
                        } else {
                            phi_1992_ = _e1165;
                        }
                        let _e1189 = phi_1992_;
                        let _e1193 = bitcast<f32>((bitcast<u32>((_e1128 * 0.0009775171f)) ^ _e70));
                        let _e1199 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1189) * _e1193)) ^ _e70)));
                        let _e1208 = ((select(_e1030, 0u, (select(select(_e961.member_1[0], _e1040, (_e1040 < _e961.member_1[0])), _e961.member_1[0], (_e1030 == 1023u)) > _e901.member.x)) | (select(_e1108, 0u, (select(select(_e961.member_1[1], _e1118, (_e1118 < _e961.member_1[1])), _e961.member_1[1], (_e1108 == 1023u)) > _e901.member.y)) << bitcast<u32>(10i))) | (select(_e1189, 0u, (select(select(_e961.member_1[2], _e1199, (_e1199 < _e961.member_1[2])), _e961.member_1[2], (_e1189 == 1023u)) > _e901.member.z)) << bitcast<u32>(20i)));
                        if _e970 {
                            phi_2032_ = (((_e901.member_1.x - _e958.member[0]) / _e969) * 1023f);
                        } else {
                            phi_2032_ = 0f;
                        }
                        let _e1213 = phi_2032_;
                        let _e1215 = select(1023f, _e1213, (_e1213 < 1023f));
                        let _e1217 = select(0f, _e1215, (_e1215 > 0f));
                        let _e1222 = select(select(u32(_e1217), 0u, (_e1217 < 0f)), 4294967295u, (_e1217 > 4294967000f));
                        if (_e1222 > 0u) {
                            let _e1229 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1222) * _e1034)) ^ _e70)));
                            let _e1234 = (select(select(_e961.member_1[0], _e1229, (_e1229 < _e961.member_1[0])), _e961.member_1[0], (_e1222 == 1023u)) > _e901.member_1.x);
                            if _e1234 {
                                phi_2083_ = (_e1222 - 1u);
                            } else {
                                phi_2083_ = u32();
                            }
                            let _e1237 = phi_2083_;
                            phi_2085_ = _e1237;
                            phi_2086_ = select(true, false, _e1234);
                        } else {
                            phi_2085_ = u32();
                            phi_2086_ = true;
                        }
                        let _e1240 = phi_2085_;
                        let _e1242 = phi_2086_;
                        if _e1242 {
                            if (_e1222 < 1023u) {
                                let _e1244 = (_e1222 + 1u);
                                let _e1250 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1244) * _e1034)) ^ _e70)));
                                phi_2124_ = select(_e1222, _e1244, (select(select(_e961.member_1[0], _e1250, (_e1250 < _e961.member_1[0])), _e961.member_1[0], (_e1244 == 1023u)) <= _e901.member_1.x));
                            } else {
                                phi_2124_ = _e1222;
                            }
                            let _e1258 = phi_2124_;
                            phi_2125_ = _e1258;
                        } else {
                            phi_2125_ = _e1240;
                        }
                        let _e1260 = phi_2125_;
                        let _e1266 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1260) * _e1034)) ^ _e70)));
                        let _e1272 = select(_e1260, 0u, (select(select(_e961.member_1[0], _e1266, (_e1266 < _e961.member_1[0])), _e961.member_1[0], (_e1260 == 1023u)) > _e901.member_1.x));
                        if (_e1272 < 1023u) {
                            let _e1279 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1272) * _e1034)) ^ _e70)));
                            let _e1284 = (select(select(_e961.member_1[0], _e1279, (_e1279 < _e961.member_1[0])), _e961.member_1[0], (_e1272 == 1023u)) < _e901.member_1.x);
                            if _e1284 {
                                phi_2186_ = (_e1272 + 1u);
                            } else {
                                phi_2186_ = u32();
                            }
                            let _e1287 = phi_2186_;
                            phi_2188_ = _e1287;
                            phi_2189_ = select(true, false, _e1284);
                        } else {
                            phi_2188_ = u32();
                            phi_2189_ = true;
                        }
                        let _e1290 = phi_2188_;
                        let _e1292 = phi_2189_;
                        let _e1293 = select(_e1290, _e1272, _e1292);
                        let _e1299 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1293) * _e1034)) ^ _e70)));
                        if _e1048 {
                            phi_2231_ = (((_e901.member_1.y - _e958.member[1]) / _e1047) * 1023f);
                        } else {
                            phi_2231_ = 0f;
                        }
                        let _e1310 = phi_2231_;
                        let _e1312 = select(1023f, _e1310, (_e1310 < 1023f));
                        let _e1314 = select(0f, _e1312, (_e1312 > 0f));
                        let _e1319 = select(select(u32(_e1314), 0u, (_e1314 < 0f)), 4294967295u, (_e1314 > 4294967000f));
                        if (_e1319 > 0u) {
                            let _e1326 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1319) * _e1112)) ^ _e70)));
                            let _e1331 = (select(select(_e961.member_1[1], _e1326, (_e1326 < _e961.member_1[1])), _e961.member_1[1], (_e1319 == 1023u)) > _e901.member_1.y);
                            if _e1331 {
                                phi_2282_ = (_e1319 - 1u);
                            } else {
                                phi_2282_ = u32();
                            }
                            let _e1334 = phi_2282_;
                            phi_2284_ = _e1334;
                            phi_2285_ = select(true, false, _e1331);
                        } else {
                            phi_2284_ = u32();
                            phi_2285_ = true;
                        }
                        let _e1337 = phi_2284_;
                        let _e1339 = phi_2285_;
                        if _e1339 {
                            if (_e1319 < 1023u) {
                                let _e1341 = (_e1319 + 1u);
                                let _e1347 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1341) * _e1112)) ^ _e70)));
                                phi_2323_ = select(_e1319, _e1341, (select(select(_e961.member_1[1], _e1347, (_e1347 < _e961.member_1[1])), _e961.member_1[1], (_e1341 == 1023u)) <= _e901.member_1.y));
                            } else {
                                phi_2323_ = _e1319;
                            }
                            let _e1355 = phi_2323_;
                            phi_2324_ = _e1355;
                        } else {
                            phi_2324_ = _e1337;
                        }
                        let _e1357 = phi_2324_;
                        let _e1363 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1357) * _e1112)) ^ _e70)));
                        let _e1369 = select(_e1357, 0u, (select(select(_e961.member_1[1], _e1363, (_e1363 < _e961.member_1[1])), _e961.member_1[1], (_e1357 == 1023u)) > _e901.member_1.y));
                        if (_e1369 < 1023u) {
                            let _e1376 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1369) * _e1112)) ^ _e70)));
                            let _e1381 = (select(select(_e961.member_1[1], _e1376, (_e1376 < _e961.member_1[1])), _e961.member_1[1], (_e1369 == 1023u)) < _e901.member_1.y);
                            if _e1381 {
                                phi_2385_ = (_e1369 + 1u);
                            } else {
                                phi_2385_ = u32();
                            }
                            let _e1384 = phi_2385_;
                            phi_2387_ = _e1384;
                            phi_2388_ = select(true, false, _e1381);
                        } else {
                            phi_2387_ = u32();
                            phi_2388_ = true;
                        }
                        let _e1387 = phi_2387_;
                        let _e1389 = phi_2388_;
                        let _e1390 = select(_e1387, _e1369, _e1389);
                        let _e1396 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1390) * _e1112)) ^ _e70)));
                        if _e1129 {
                            phi_2432_ = (((_e901.member_1.z - _e958.member[2]) / _e1128) * 1023f);
                        } else {
                            phi_2432_ = 0f;
                        }
                        let _e1410 = phi_2432_;
                        let _e1412 = select(1023f, _e1410, (_e1410 < 1023f));
                        let _e1414 = select(0f, _e1412, (_e1412 > 0f));
                        let _e1419 = select(select(u32(_e1414), 0u, (_e1414 < 0f)), 4294967295u, (_e1414 > 4294967000f));
                        if (_e1419 > 0u) {
                            let _e1426 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1419) * _e1193)) ^ _e70)));
                            let _e1431 = (select(select(_e961.member_1[2], _e1426, (_e1426 < _e961.member_1[2])), _e961.member_1[2], (_e1419 == 1023u)) > _e901.member_1.z);
                            if _e1431 {
                                phi_2483_ = (_e1419 - 1u);
                            } else {
                                phi_2483_ = u32();
                            }
                            let _e1434 = phi_2483_;
                            phi_2485_ = _e1434;
                            phi_2486_ = select(true, false, _e1431);
                        } else {
                            phi_2485_ = u32();
                            phi_2486_ = true;
                        }
                        let _e1437 = phi_2485_;
                        let _e1439 = phi_2486_;
                        if _e1439 {
                            if (_e1419 < 1023u) {
                                let _e1441 = (_e1419 + 1u);
                                let _e1447 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1441) * _e1193)) ^ _e70)));
                                phi_2524_ = select(_e1419, _e1441, (select(select(_e961.member_1[2], _e1447, (_e1447 < _e961.member_1[2])), _e961.member_1[2], (_e1441 == 1023u)) <= _e901.member_1.z));
                            } else {
                                phi_2524_ = _e1419;
                            }
                            let _e1455 = phi_2524_;
                            phi_2525_ = _e1455;
                        } else {
                            phi_2525_ = _e1437;
                        }
                        let _e1457 = phi_2525_;
                        let _e1463 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1457) * _e1193)) ^ _e70)));
                        let _e1469 = select(_e1457, 0u, (select(select(_e961.member_1[2], _e1463, (_e1463 < _e961.member_1[2])), _e961.member_1[2], (_e1457 == 1023u)) > _e901.member_1.z));
                        if (_e1469 < 1023u) {
                            let _e1476 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1469) * _e1193)) ^ _e70)));
                            let _e1481 = (select(select(_e961.member_1[2], _e1476, (_e1476 < _e961.member_1[2])), _e961.member_1[2], (_e1469 == 1023u)) < _e901.member_1.z);
                            if _e1481 {
                                phi_2586_ = (_e1469 + 1u);
                            } else {
                                phi_2586_ = u32();
                            }
                            let _e1484 = phi_2586_;
                            phi_2588_ = _e1484;
                            phi_2589_ = select(true, false, _e1481);
                        } else {
                            phi_2588_ = u32();
                            phi_2589_ = true;
                        }
                        let _e1487 = phi_2588_;
                        let _e1489 = phi_2589_;
                        let _e1490 = select(_e1487, _e1469, _e1489);
                        let _e1496 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1490) * _e1193)) ^ _e70)));
                        let _e1505 = ((select(_e1293, 1023u, (select(select(_e961.member_1[0], _e1299, (_e1299 < _e961.member_1[0])), _e961.member_1[0], (_e1293 == 1023u)) < _e901.member_1.x)) | (select(_e1390, 1023u, (select(select(_e961.member_1[1], _e1396, (_e1396 < _e961.member_1[1])), _e961.member_1[1], (_e1390 == 1023u)) < _e901.member_1.y)) << bitcast<u32>(10i))) | (select(_e1490, 1023u, (select(select(_e961.member_1[2], _e1496, (_e1496 < _e961.member_1[2])), _e961.member_1[2], (_e1490 == 1023u)) < _e901.member_1.z)) << bitcast<u32>(20i)));
                        if _e970 {
                            phi_2642_ = (((_e932.member.x - _e958.member[0]) / _e969) * 1023f);
                        } else {
                            phi_2642_ = 0f;
                        }
                        let _e1511 = phi_2642_;
                        let _e1513 = select(1023f, _e1511, (_e1511 < 1023f));
                        let _e1515 = select(0f, _e1513, (_e1513 > 0f));
                        let _e1520 = select(select(u32(_e1515), 0u, (_e1515 < 0f)), 4294967295u, (_e1515 > 4294967000f));
                        if (_e1520 > 0u) {
                            let _e1527 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1520) * _e1034)) ^ _e70)));
                            let _e1532 = (select(select(_e961.member_1[0], _e1527, (_e1527 < _e961.member_1[0])), _e961.member_1[0], (_e1520 == 1023u)) > _e932.member.x);
                            if _e1532 {
                                phi_2693_ = (_e1520 - 1u);
                            } else {
                                phi_2693_ = u32();
                            }
                            let _e1535 = phi_2693_;
                            phi_2695_ = _e1535;
                            phi_2696_ = select(true, false, _e1532);
                        } else {
                            phi_2695_ = u32();
                            phi_2696_ = true;
                        }
                        let _e1538 = phi_2695_;
                        let _e1540 = phi_2696_;
                        if _e1540 {
                            if (_e1520 < 1023u) {
                                let _e1542 = (_e1520 + 1u);
                                let _e1548 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1542) * _e1034)) ^ _e70)));
                                phi_2734_ = select(_e1520, _e1542, (select(select(_e961.member_1[0], _e1548, (_e1548 < _e961.member_1[0])), _e961.member_1[0], (_e1542 == 1023u)) <= _e932.member.x));
                            } else {
                                phi_2734_ = _e1520;
                            }
                            let _e1556 = phi_2734_;
                            phi_2735_ = _e1556;
                        } else {
                            phi_2735_ = _e1538;
                        }
                        let _e1558 = phi_2735_;
                        let _e1564 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1558) * _e1034)) ^ _e70)));
                        if _e1048 {
                            phi_2773_ = (((_e932.member.y - _e958.member[1]) / _e1047) * 1023f);
                        } else {
                            phi_2773_ = 0f;
                        }
                        let _e1575 = phi_2773_;
                        let _e1577 = select(1023f, _e1575, (_e1575 < 1023f));
                        let _e1579 = select(0f, _e1577, (_e1577 > 0f));
                        let _e1584 = select(select(u32(_e1579), 0u, (_e1579 < 0f)), 4294967295u, (_e1579 > 4294967000f));
                        if (_e1584 > 0u) {
                            let _e1591 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1584) * _e1112)) ^ _e70)));
                            let _e1596 = (select(select(_e961.member_1[1], _e1591, (_e1591 < _e961.member_1[1])), _e961.member_1[1], (_e1584 == 1023u)) > _e932.member.y);
                            if _e1596 {
                                phi_2824_ = (_e1584 - 1u);
                            } else {
                                phi_2824_ = u32();
                            }
                            let _e1599 = phi_2824_;
                            phi_2826_ = _e1599;
                            phi_2827_ = select(true, false, _e1596);
                        } else {
                            phi_2826_ = u32();
                            phi_2827_ = true;
                        }
                        let _e1602 = phi_2826_;
                        let _e1604 = phi_2827_;
                        if _e1604 {
                            if (_e1584 < 1023u) {
                                let _e1606 = (_e1584 + 1u);
                                let _e1612 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1606) * _e1112)) ^ _e70)));
                                phi_2865_ = select(_e1584, _e1606, (select(select(_e961.member_1[1], _e1612, (_e1612 < _e961.member_1[1])), _e961.member_1[1], (_e1606 == 1023u)) <= _e932.member.y));
                            } else {
                                phi_2865_ = _e1584;
                            }
                            let _e1620 = phi_2865_;
                            phi_2866_ = _e1620;
                        } else {
                            phi_2866_ = _e1602;
                        }
                        let _e1622 = phi_2866_;
                        let _e1628 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1622) * _e1112)) ^ _e70)));
                        if _e1129 {
                            phi_2906_ = (((_e932.member.z - _e958.member[2]) / _e1128) * 1023f);
                        } else {
                            phi_2906_ = 0f;
                        }
                        let _e1642 = phi_2906_;
                        let _e1644 = select(1023f, _e1642, (_e1642 < 1023f));
                        let _e1646 = select(0f, _e1644, (_e1644 > 0f));
                        let _e1651 = select(select(u32(_e1646), 0u, (_e1646 < 0f)), 4294967295u, (_e1646 > 4294967000f));
                        if (_e1651 > 0u) {
                            let _e1658 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1651) * _e1193)) ^ _e70)));
                            let _e1663 = (select(select(_e961.member_1[2], _e1658, (_e1658 < _e961.member_1[2])), _e961.member_1[2], (_e1651 == 1023u)) > _e932.member.z);
                            if _e1663 {
                                phi_2957_ = (_e1651 - 1u);
                            } else {
                                phi_2957_ = u32();
                            }
                            let _e1666 = phi_2957_;
                            phi_2959_ = _e1666;
                            phi_2960_ = select(true, false, _e1663);
                        } else {
                            phi_2959_ = u32();
                            phi_2960_ = true;
                        }
                        let _e1669 = phi_2959_;
                        let _e1671 = phi_2960_;
                        if _e1671 {
                            if (_e1651 < 1023u) {
                                let _e1673 = (_e1651 + 1u);
                                let _e1679 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1673) * _e1193)) ^ _e70)));
                                phi_2998_ = select(_e1651, _e1673, (select(select(_e961.member_1[2], _e1679, (_e1679 < _e961.member_1[2])), _e961.member_1[2], (_e1673 == 1023u)) <= _e932.member.z));
                            } else {
                                phi_2998_ = _e1651;
                            }
                            let _e1687 = phi_2998_;
                            phi_2999_ = _e1687;
                        } else {
                            phi_2999_ = _e1669;
                        }
                        let _e1689 = phi_2999_;
                        let _e1695 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1689) * _e1193)) ^ _e70)));
                        let _e1704 = ((select(_e1558, 0u, (select(select(_e961.member_1[0], _e1564, (_e1564 < _e961.member_1[0])), _e961.member_1[0], (_e1558 == 1023u)) > _e932.member.x)) | (select(_e1622, 0u, (select(select(_e961.member_1[1], _e1628, (_e1628 < _e961.member_1[1])), _e961.member_1[1], (_e1622 == 1023u)) > _e932.member.y)) << bitcast<u32>(10i))) | (select(_e1689, 0u, (select(select(_e961.member_1[2], _e1695, (_e1695 < _e961.member_1[2])), _e961.member_1[2], (_e1689 == 1023u)) > _e932.member.z)) << bitcast<u32>(20i)));
                        if _e970 {
                            phi_3039_ = (((_e932.member_1.x - _e958.member[0]) / _e969) * 1023f);
                        } else {
                            phi_3039_ = 0f;
                        }
                        let _e1709 = phi_3039_;
                        let _e1711 = select(1023f, _e1709, (_e1709 < 1023f));
                        let _e1713 = select(0f, _e1711, (_e1711 > 0f));
                        let _e1718 = select(select(u32(_e1713), 0u, (_e1713 < 0f)), 4294967295u, (_e1713 > 4294967000f));
                        if (_e1718 > 0u) {
                            let _e1725 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1718) * _e1034)) ^ _e70)));
                            let _e1730 = (select(select(_e961.member_1[0], _e1725, (_e1725 < _e961.member_1[0])), _e961.member_1[0], (_e1718 == 1023u)) > _e932.member_1.x);
                            if _e1730 {
                                phi_3090_ = (_e1718 - 1u);
                            } else {
                                phi_3090_ = u32();
                            }
                            let _e1733 = phi_3090_;
                            phi_3092_ = _e1733;
                            phi_3093_ = select(true, false, _e1730);
                        } else {
                            phi_3092_ = u32();
                            phi_3093_ = true;
                        }
                        let _e1736 = phi_3092_;
                        let _e1738 = phi_3093_;
                        if _e1738 {
                            if (_e1718 < 1023u) {
                                let _e1740 = (_e1718 + 1u);
                                let _e1746 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1740) * _e1034)) ^ _e70)));
                                phi_3131_ = select(_e1718, _e1740, (select(select(_e961.member_1[0], _e1746, (_e1746 < _e961.member_1[0])), _e961.member_1[0], (_e1740 == 1023u)) <= _e932.member_1.x));
                            } else {
                                phi_3131_ = _e1718;
                            }
                            let _e1754 = phi_3131_;
                            phi_3132_ = _e1754;
                        } else {
                            phi_3132_ = _e1736;
                        }
                        let _e1756 = phi_3132_;
                        let _e1762 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1756) * _e1034)) ^ _e70)));
                        let _e1768 = select(_e1756, 0u, (select(select(_e961.member_1[0], _e1762, (_e1762 < _e961.member_1[0])), _e961.member_1[0], (_e1756 == 1023u)) > _e932.member_1.x));
                        if (_e1768 < 1023u) {
                            let _e1775 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1768) * _e1034)) ^ _e70)));
                            let _e1780 = (select(select(_e961.member_1[0], _e1775, (_e1775 < _e961.member_1[0])), _e961.member_1[0], (_e1768 == 1023u)) < _e932.member_1.x);
                            if _e1780 {
                                phi_3193_ = (_e1768 + 1u);
                            } else {
                                phi_3193_ = u32();
                            }
                            let _e1783 = phi_3193_;
                            phi_3195_ = _e1783;
                            phi_3196_ = select(true, false, _e1780);
                        } else {
                            phi_3195_ = u32();
                            phi_3196_ = true;
                        }
                        let _e1786 = phi_3195_;
                        let _e1788 = phi_3196_;
                        let _e1789 = select(_e1786, _e1768, _e1788);
                        let _e1795 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1789) * _e1034)) ^ _e70)));
                        if _e1048 {
                            phi_3238_ = (((_e932.member_1.y - _e958.member[1]) / _e1047) * 1023f);
                        } else {
                            phi_3238_ = 0f;
                        }
                        let _e1806 = phi_3238_;
                        let _e1808 = select(1023f, _e1806, (_e1806 < 1023f));
                        let _e1810 = select(0f, _e1808, (_e1808 > 0f));
                        let _e1815 = select(select(u32(_e1810), 0u, (_e1810 < 0f)), 4294967295u, (_e1810 > 4294967000f));
                        if (_e1815 > 0u) {
                            let _e1822 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1815) * _e1112)) ^ _e70)));
                            let _e1827 = (select(select(_e961.member_1[1], _e1822, (_e1822 < _e961.member_1[1])), _e961.member_1[1], (_e1815 == 1023u)) > _e932.member_1.y);
                            if _e1827 {
                                phi_3289_ = (_e1815 - 1u);
                            } else {
                                phi_3289_ = u32();
                            }
                            let _e1830 = phi_3289_;
                            phi_3291_ = _e1830;
                            phi_3292_ = select(true, false, _e1827);
                        } else {
                            phi_3291_ = u32();
                            phi_3292_ = true;
                        }
                        let _e1833 = phi_3291_;
                        let _e1835 = phi_3292_;
                        if _e1835 {
                            if (_e1815 < 1023u) {
                                let _e1837 = (_e1815 + 1u);
                                let _e1843 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1837) * _e1112)) ^ _e70)));
                                phi_3330_ = select(_e1815, _e1837, (select(select(_e961.member_1[1], _e1843, (_e1843 < _e961.member_1[1])), _e961.member_1[1], (_e1837 == 1023u)) <= _e932.member_1.y));
                            } else {
                                phi_3330_ = _e1815;
                            }
                            let _e1851 = phi_3330_;
                            phi_3331_ = _e1851;
                        } else {
                            phi_3331_ = _e1833;
                        }
                        let _e1853 = phi_3331_;
                        let _e1859 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1853) * _e1112)) ^ _e70)));
                        let _e1865 = select(_e1853, 0u, (select(select(_e961.member_1[1], _e1859, (_e1859 < _e961.member_1[1])), _e961.member_1[1], (_e1853 == 1023u)) > _e932.member_1.y));
                        if (_e1865 < 1023u) {
                            let _e1872 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1865) * _e1112)) ^ _e70)));
                            let _e1877 = (select(select(_e961.member_1[1], _e1872, (_e1872 < _e961.member_1[1])), _e961.member_1[1], (_e1865 == 1023u)) < _e932.member_1.y);
                            if _e1877 {
                                phi_3392_ = (_e1865 + 1u);
                            } else {
                                phi_3392_ = u32();
                            }
                            let _e1880 = phi_3392_;
                            phi_3394_ = _e1880;
                            phi_3395_ = select(true, false, _e1877);
                        } else {
                            phi_3394_ = u32();
                            phi_3395_ = true;
                        }
                        let _e1883 = phi_3394_;
                        let _e1885 = phi_3395_;
                        let _e1886 = select(_e1883, _e1865, _e1885);
                        let _e1892 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1886) * _e1112)) ^ _e70)));
                        if _e1129 {
                            phi_3439_ = (((_e932.member_1.z - _e958.member[2]) / _e1128) * 1023f);
                        } else {
                            phi_3439_ = 0f;
                        }
                        let _e1906 = phi_3439_;
                        let _e1908 = select(1023f, _e1906, (_e1906 < 1023f));
                        let _e1910 = select(0f, _e1908, (_e1908 > 0f));
                        let _e1915 = select(select(u32(_e1910), 0u, (_e1910 < 0f)), 4294967295u, (_e1910 > 4294967000f));
                        if (_e1915 > 0u) {
                            let _e1922 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1915) * _e1193)) ^ _e70)));
                            let _e1927 = (select(select(_e961.member_1[2], _e1922, (_e1922 < _e961.member_1[2])), _e961.member_1[2], (_e1915 == 1023u)) > _e932.member_1.z);
                            if _e1927 {
                                phi_3490_ = (_e1915 - 1u);
                            } else {
                                phi_3490_ = u32();
                            }
                            let _e1930 = phi_3490_;
                            phi_3492_ = _e1930;
                            phi_3493_ = select(true, false, _e1927);
                        } else {
                            phi_3492_ = u32();
                            phi_3493_ = true;
                        }
                        let _e1933 = phi_3492_;
                        let _e1935 = phi_3493_;
                        if _e1935 {
                            if (_e1915 < 1023u) {
                                let _e1937 = (_e1915 + 1u);
                                let _e1943 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1937) * _e1193)) ^ _e70)));
                                phi_3531_ = select(_e1915, _e1937, (select(select(_e961.member_1[2], _e1943, (_e1943 < _e961.member_1[2])), _e961.member_1[2], (_e1937 == 1023u)) <= _e932.member_1.z));
                            } else {
                                phi_3531_ = _e1915;
                            }
                            let _e1951 = phi_3531_;
                            phi_3532_ = _e1951;
                        } else {
                            phi_3532_ = _e1933;
                        }
                        let _e1953 = phi_3532_;
                        let _e1959 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1953) * _e1193)) ^ _e70)));
                        let _e1965 = select(_e1953, 0u, (select(select(_e961.member_1[2], _e1959, (_e1959 < _e961.member_1[2])), _e961.member_1[2], (_e1953 == 1023u)) > _e932.member_1.z));
                        if (_e1965 < 1023u) {
                            let _e1972 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1965) * _e1193)) ^ _e70)));
                            let _e1977 = (select(select(_e961.member_1[2], _e1972, (_e1972 < _e961.member_1[2])), _e961.member_1[2], (_e1965 == 1023u)) < _e932.member_1.z);
                            if _e1977 {
                                phi_3593_ = (_e1965 + 1u);
                            } else {
                                phi_3593_ = u32();
                            }
                            let _e1980 = phi_3593_;
                            phi_3595_ = _e1980;
                            phi_3596_ = select(true, false, _e1977);
                        } else {
                            phi_3595_ = u32();
                            phi_3596_ = true;
                        }
                        let _e1983 = phi_3595_;
                        let _e1985 = phi_3596_;
                        let _e1986 = select(_e1983, _e1965, _e1985);
                        let _e1992 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1986) * _e1193)) ^ _e70)));
                        let _e2001 = ((select(_e1789, 1023u, (select(select(_e961.member_1[0], _e1795, (_e1795 < _e961.member_1[0])), _e961.member_1[0], (_e1789 == 1023u)) < _e932.member_1.x)) | (select(_e1886, 1023u, (select(select(_e961.member_1[1], _e1892, (_e1892 < _e961.member_1[1])), _e961.member_1[1], (_e1886 == 1023u)) < _e932.member_1.y)) << bitcast<u32>(10i))) | (select(_e1986, 1023u, (select(select(_e961.member_1[2], _e1992, (_e1992 < _e961.member_1[2])), _e961.member_1[2], (_e1986 == 1023u)) < _e932.member_1.z)) << bitcast<u32>(20i)));
                        let _e2004 = (_e1208 & 1023u);
                        let _e2010 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e2004) * _e1034)) ^ _e70)));
                        let _e2014 = select(select(_e961.member_1[0], _e2010, (_e2010 < _e961.member_1[0])), _e961.member_1[0], (_e2004 == 1023u));
                        let _e2017 = ((_e1208 >> bitcast<u32>(10u)) & 1023u);
                        let _e2023 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e2017) * _e1112)) ^ _e70)));
                        let _e2027 = select(select(_e961.member_1[1], _e2023, (_e2023 < _e961.member_1[1])), _e961.member_1[1], (_e2017 == 1023u));
                        let _e2030 = ((_e1208 >> bitcast<u32>(20u)) & 1023u);
                        let _e2036 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e2030) * _e1193)) ^ _e70)));
                        let _e2040 = select(select(_e961.member_1[2], _e2036, (_e2036 < _e961.member_1[2])), _e961.member_1[2], (_e2030 == 1023u));
                        let _e2041 = (_e1505 & 1023u);
                        let _e2047 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e2041) * _e1034)) ^ _e70)));
                        let _e2051 = select(select(_e961.member_1[0], _e2047, (_e2047 < _e961.member_1[0])), _e961.member_1[0], (_e2041 == 1023u));
                        let _e2054 = ((_e1505 >> bitcast<u32>(10u)) & 1023u);
                        let _e2060 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e2054) * _e1112)) ^ _e70)));
                        let _e2064 = select(select(_e961.member_1[1], _e2060, (_e2060 < _e961.member_1[1])), _e961.member_1[1], (_e2054 == 1023u));
                        let _e2067 = ((_e1505 >> bitcast<u32>(20u)) & 1023u);
                        let _e2073 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e2067) * _e1193)) ^ _e70)));
                        let _e2077 = select(select(_e961.member_1[2], _e2073, (_e2073 < _e961.member_1[2])), _e961.member_1[2], (_e2067 == 1023u));
                        let _e2078 = (_e1704 & 1023u);
                        let _e2084 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e2078) * _e1034)) ^ _e70)));
                        let _e2088 = select(select(_e961.member_1[0], _e2084, (_e2084 < _e961.member_1[0])), _e961.member_1[0], (_e2078 == 1023u));
                        let _e2091 = ((_e1704 >> bitcast<u32>(10u)) & 1023u);
                        let _e2097 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e2091) * _e1112)) ^ _e70)));
                        let _e2101 = select(select(_e961.member_1[1], _e2097, (_e2097 < _e961.member_1[1])), _e961.member_1[1], (_e2091 == 1023u));
                        let _e2104 = ((_e1704 >> bitcast<u32>(20u)) & 1023u);
                        let _e2110 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e2104) * _e1193)) ^ _e70)));
                        let _e2114 = select(select(_e961.member_1[2], _e2110, (_e2110 < _e961.member_1[2])), _e961.member_1[2], (_e2104 == 1023u));
                        let _e2115 = (_e2001 & 1023u);
                        let _e2121 = (_e958.member[0] + bitcast<f32>((bitcast<u32>((f32(_e2115) * _e1034)) ^ _e70)));
                        let _e2125 = select(select(_e961.member_1[0], _e2121, (_e2121 < _e961.member_1[0])), _e961.member_1[0], (_e2115 == 1023u));
                        let _e2128 = ((_e2001 >> bitcast<u32>(10u)) & 1023u);
                        let _e2134 = (_e958.member[1] + bitcast<f32>((bitcast<u32>((f32(_e2128) * _e1112)) ^ _e70)));
                        let _e2138 = select(select(_e961.member_1[1], _e2134, (_e2134 < _e961.member_1[1])), _e961.member_1[1], (_e2128 == 1023u));
                        let _e2141 = ((_e2001 >> bitcast<u32>(20u)) & 1023u);
                        let _e2147 = (_e958.member[2] + bitcast<f32>((bitcast<u32>((f32(_e2141) * _e1193)) ^ _e70)));
                        let _e2151 = select(select(_e961.member_1[2], _e2147, (_e2147 < _e961.member_1[2])), _e961.member_1[2], (_e2141 == 1023u));
                        if _e67 {
                        } else {
                            break;
                        }
                        global_5.member[_e61] = type_37(array<u32, 2>(_e1208, _e1505), array<u32, 2>(_e1704, _e2001), _e874, _e905);
                        if _e66 {
                        } else {
                            break;
                        }
                        if ((_e874 & 2147483648u) != 0u) {
                            phi_4018_ = type_4(0u, ((_e874 >> bitcast<u32>(28u)) & 7u));
                            loop {
                                let _e2161 = phi_4018_;
                                if (_e2161.member < _e2161.member_1) {
                                    phi_4019_ = type_4((_e2161.member + 1u), _e2161.member_1);
                                    phi_4042_ = type_4(1u, _e2161.member);
                                } else {
                                    phi_4019_ = _e2161;
                                    phi_4042_ = type_4(0u, type_4().member_1);
                                }
                                let _e2174 = phi_4019_;
                                let _e2176 = phi_4042_;
                                let _e2180 = (bitcast<i32>(_e2176.member) != 0i);
                                if _e2180 {
                                    let _e2182 = ((_e874 & 268435455u) + _e2176.member_1);
                                    let _e2183 = (_e2182 < _e51);
                                    if _e2183 {
                                        let _e2184 = (_e2182 < _e55);
                                        if _e2184 {
                                            if _e2183 {
                                            } else {
                                                phi_7927_ = true;
                                                break;
                                            }
                                            let _e2189 = global_2.member[_e2182].member[0u];
                                            let _e2194 = global_2.member[_e2182].member[1u];
                                            let _e2199 = global_2.member[_e2182].member[2u];
                                            let _e2200 = (_e2051 - _e2014);
                                            let _e2201 = (_e2200 > 0f);
                                            if _e2201 {
                                                phi_4081_ = (((_e2189 - _e2014) / _e2200) * 1023f);
                                            } else {
                                                phi_4081_ = 0f;
                                            }
                                            let _e2206 = phi_4081_;
                                            let _e2208 = select(1023f, _e2206, (_e2206 < 1023f));
                                            let _e2210 = select(0f, _e2208, (_e2208 > 0f));
                                            let _e2215 = select(select(u32(_e2210), 0u, (_e2210 < 0f)), 4294967295u, (_e2210 > 4294967000f));
                                            if (_e2215 > 0u) {
                                                let _e2226 = (_e2014 + bitcast<f32>((bitcast<u32>((f32(_e2215) * bitcast<f32>((bitcast<u32>((_e2200 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                let _e2231 = (select(select(_e2051, _e2226, (_e2226 < _e2051)), _e2051, (_e2215 == 1023u)) > _e2189);
                                                if _e2231 {
                                                    phi_4132_ = (_e2215 - 1u);
                                                } else {
                                                    phi_4132_ = u32();
                                                }
                                                let _e2234 = phi_4132_;
                                                phi_4134_ = _e2234;
                                                phi_4135_ = select(true, false, _e2231);
                                            } else {
                                                phi_4134_ = u32();
                                                phi_4135_ = true;
                                            }
                                            let _e2237 = phi_4134_;
                                            let _e2239 = phi_4135_;
                                            if _e2239 {
                                                if (_e2215 < 1023u) {
                                                    let _e2241 = (_e2215 + 1u);
                                                    let _e2251 = (_e2014 + bitcast<f32>((bitcast<u32>((f32(_e2241) * bitcast<f32>((bitcast<u32>((_e2200 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                    phi_4173_ = select(_e2215, _e2241, (select(select(_e2051, _e2251, (_e2251 < _e2051)), _e2051, (_e2241 == 1023u)) <= _e2189));
                                                } else {
                                                    phi_4173_ = _e2215;
                                                }
                                                let _e2259 = phi_4173_;
                                                phi_4174_ = _e2259;
                                            } else {
                                                phi_4174_ = _e2237;
                                            }
                                            let _e2261 = phi_4174_;
                                            let _e2265 = bitcast<f32>((bitcast<u32>((_e2200 * 0.0009775171f)) ^ _e70));
                                            let _e2271 = (_e2014 + bitcast<f32>((bitcast<u32>((f32(_e2261) * _e2265)) ^ _e70)));
                                            let _e2277 = select(_e2261, 0u, (select(select(_e2051, _e2271, (_e2271 < _e2051)), _e2051, (_e2261 == 1023u)) > _e2189));
                                            if (_e2277 < 1023u) {
                                                phi_4208_ = (_e2277 + 1u);
                                            } else {
                                                phi_4208_ = _e2277;
                                            }
                                            let _e2281 = phi_4208_;
                                            let _e2287 = (_e2014 + bitcast<f32>((bitcast<u32>((f32(_e2277) * _e2265)) ^ _e70)));
                                            let _e2301 = (_e2014 + bitcast<f32>((bitcast<u32>((f32(_e2281) * _e2265)) ^ _e70)));
                                            let _e2312 = (_e2064 - _e2027);
                                            let _e2313 = (_e2312 > 0f);
                                            if _e2313 {
                                                phi_4277_ = (((_e2194 - _e2027) / _e2312) * 1023f);
                                            } else {
                                                phi_4277_ = 0f;
                                            }
                                            let _e2318 = phi_4277_;
                                            let _e2320 = select(1023f, _e2318, (_e2318 < 1023f));
                                            let _e2322 = select(0f, _e2320, (_e2320 > 0f));
                                            let _e2327 = select(select(u32(_e2322), 0u, (_e2322 < 0f)), 4294967295u, (_e2322 > 4294967000f));
                                            if (_e2327 > 0u) {
                                                let _e2338 = (_e2027 + bitcast<f32>((bitcast<u32>((f32(_e2327) * bitcast<f32>((bitcast<u32>((_e2312 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                let _e2343 = (select(select(_e2064, _e2338, (_e2338 < _e2064)), _e2064, (_e2327 == 1023u)) > _e2194);
                                                if _e2343 {
                                                    phi_4328_ = (_e2327 - 1u);
                                                } else {
                                                    phi_4328_ = u32();
                                                }
                                                let _e2346 = phi_4328_;
                                                phi_4330_ = _e2346;
                                                phi_4331_ = select(true, false, _e2343);
                                            } else {
                                                phi_4330_ = u32();
                                                phi_4331_ = true;
                                            }
                                            let _e2349 = phi_4330_;
                                            let _e2351 = phi_4331_;
                                            if _e2351 {
                                                if (_e2327 < 1023u) {
                                                    let _e2353 = (_e2327 + 1u);
                                                    let _e2363 = (_e2027 + bitcast<f32>((bitcast<u32>((f32(_e2353) * bitcast<f32>((bitcast<u32>((_e2312 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                    phi_4369_ = select(_e2327, _e2353, (select(select(_e2064, _e2363, (_e2363 < _e2064)), _e2064, (_e2353 == 1023u)) <= _e2194));
                                                } else {
                                                    phi_4369_ = _e2327;
                                                }
                                                let _e2371 = phi_4369_;
                                                phi_4370_ = _e2371;
                                            } else {
                                                phi_4370_ = _e2349;
                                            }
                                            let _e2373 = phi_4370_;
                                            let _e2377 = bitcast<f32>((bitcast<u32>((_e2312 * 0.0009775171f)) ^ _e70));
                                            let _e2383 = (_e2027 + bitcast<f32>((bitcast<u32>((f32(_e2373) * _e2377)) ^ _e70)));
                                            let _e2389 = select(_e2373, 0u, (select(select(_e2064, _e2383, (_e2383 < _e2064)), _e2064, (_e2373 == 1023u)) > _e2194));
                                            if (_e2389 < 1023u) {
                                                phi_4404_ = (_e2389 + 1u);
                                            } else {
                                                phi_4404_ = _e2389;
                                            }
                                            let _e2393 = phi_4404_;
                                            let _e2399 = (_e2027 + bitcast<f32>((bitcast<u32>((f32(_e2389) * _e2377)) ^ _e70)));
                                            let _e2413 = (_e2027 + bitcast<f32>((bitcast<u32>((f32(_e2393) * _e2377)) ^ _e70)));
                                            let _e2427 = (_e2077 - _e2040);
                                            let _e2428 = (_e2427 > 0f);
                                            if _e2428 {
                                                phi_4475_ = (((_e2199 - _e2040) / _e2427) * 1023f);
                                            } else {
                                                phi_4475_ = 0f;
                                            }
                                            let _e2433 = phi_4475_;
                                            let _e2435 = select(1023f, _e2433, (_e2433 < 1023f));
                                            let _e2437 = select(0f, _e2435, (_e2435 > 0f));
                                            let _e2442 = select(select(u32(_e2437), 0u, (_e2437 < 0f)), 4294967295u, (_e2437 > 4294967000f));
                                            if (_e2442 > 0u) {
                                                let _e2453 = (_e2040 + bitcast<f32>((bitcast<u32>((f32(_e2442) * bitcast<f32>((bitcast<u32>((_e2427 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                let _e2458 = (select(select(_e2077, _e2453, (_e2453 < _e2077)), _e2077, (_e2442 == 1023u)) > _e2199);
                                                if _e2458 {
                                                    phi_4526_ = (_e2442 - 1u);
                                                } else {
                                                    phi_4526_ = u32();
                                                }
                                                let _e2461 = phi_4526_;
                                                phi_4528_ = _e2461;
                                                phi_4529_ = select(true, false, _e2458);
                                            } else {
                                                phi_4528_ = u32();
                                                phi_4529_ = true;
                                            }
                                            let _e2464 = phi_4528_;
                                            let _e2466 = phi_4529_;
                                            if _e2466 {
                                                if (_e2442 < 1023u) {
                                                    let _e2468 = (_e2442 + 1u);
                                                    let _e2478 = (_e2040 + bitcast<f32>((bitcast<u32>((f32(_e2468) * bitcast<f32>((bitcast<u32>((_e2427 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                    phi_4567_ = select(_e2442, _e2468, (select(select(_e2077, _e2478, (_e2478 < _e2077)), _e2077, (_e2468 == 1023u)) <= _e2199));
                                                } else {
                                                    phi_4567_ = _e2442;
                                                }
                                                let _e2486 = phi_4567_;
                                                phi_4568_ = _e2486;
                                            } else {
                                                phi_4568_ = _e2464;
                                            }
                                            let _e2488 = phi_4568_;
                                            let _e2492 = bitcast<f32>((bitcast<u32>((_e2427 * 0.0009775171f)) ^ _e70));
                                            let _e2498 = (_e2040 + bitcast<f32>((bitcast<u32>((f32(_e2488) * _e2492)) ^ _e70)));
                                            let _e2504 = select(_e2488, 0u, (select(select(_e2077, _e2498, (_e2498 < _e2077)), _e2077, (_e2488 == 1023u)) > _e2199));
                                            if (_e2504 < 1023u) {
                                                phi_4602_ = (_e2504 + 1u);
                                            } else {
                                                phi_4602_ = _e2504;
                                            }
                                            let _e2508 = phi_4602_;
                                            let _e2514 = (_e2040 + bitcast<f32>((bitcast<u32>((f32(_e2504) * _e2492)) ^ _e70)));
                                            let _e2528 = (_e2040 + bitcast<f32>((bitcast<u32>((f32(_e2508) * _e2492)) ^ _e70)));
                                            let _e2546 = global_2.member[_e2182].member[3u];
                                            let _e2551 = global_2.member[_e2182].member[4u];
                                            let _e2556 = global_2.member[_e2182].member[5u];
                                            if _e2201 {
                                                phi_4679_ = (((_e2546 - _e2014) / _e2200) * 1023f);
                                            } else {
                                                phi_4679_ = 0f;
                                            }
                                            let _e2561 = phi_4679_;
                                            let _e2563 = select(1023f, _e2561, (_e2561 < 1023f));
                                            let _e2565 = select(0f, _e2563, (_e2563 > 0f));
                                            let _e2570 = select(select(u32(_e2565), 0u, (_e2565 < 0f)), 4294967295u, (_e2565 > 4294967000f));
                                            if (_e2570 > 0u) {
                                                let _e2577 = (_e2014 + bitcast<f32>((bitcast<u32>((f32(_e2570) * _e2265)) ^ _e70)));
                                                let _e2582 = (select(select(_e2051, _e2577, (_e2577 < _e2051)), _e2051, (_e2570 == 1023u)) > _e2546);
                                                if _e2582 {
                                                    phi_4730_ = (_e2570 - 1u);
                                                } else {
                                                    phi_4730_ = u32();
                                                }
                                                let _e2585 = phi_4730_;
                                                phi_4732_ = _e2585;
                                                phi_4733_ = select(true, false, _e2582);
                                            } else {
                                                phi_4732_ = u32();
                                                phi_4733_ = true;
                                            }
                                            let _e2588 = phi_4732_;
                                            let _e2590 = phi_4733_;
                                            if _e2590 {
                                                if (_e2570 < 1023u) {
                                                    let _e2592 = (_e2570 + 1u);
                                                    let _e2598 = (_e2014 + bitcast<f32>((bitcast<u32>((f32(_e2592) * _e2265)) ^ _e70)));
                                                    phi_4771_ = select(_e2570, _e2592, (select(select(_e2051, _e2598, (_e2598 < _e2051)), _e2051, (_e2592 == 1023u)) <= _e2546));
                                                } else {
                                                    phi_4771_ = _e2570;
                                                }
                                                let _e2606 = phi_4771_;
                                                phi_4772_ = _e2606;
                                            } else {
                                                phi_4772_ = _e2588;
                                            }
                                            let _e2608 = phi_4772_;
                                            let _e2614 = (_e2014 + bitcast<f32>((bitcast<u32>((f32(_e2608) * _e2265)) ^ _e70)));
                                            let _e2620 = select(_e2608, 0u, (select(select(_e2051, _e2614, (_e2614 < _e2051)), _e2051, (_e2608 == 1023u)) > _e2546));
                                            if (_e2620 < 1023u) {
                                                phi_4806_ = (_e2620 + 1u);
                                            } else {
                                                phi_4806_ = _e2620;
                                            }
                                            let _e2624 = phi_4806_;
                                            let _e2630 = (_e2014 + bitcast<f32>((bitcast<u32>((f32(_e2620) * _e2265)) ^ _e70)));
                                            let _e2644 = (_e2014 + bitcast<f32>((bitcast<u32>((f32(_e2624) * _e2265)) ^ _e70)));
                                            if _e2313 {
                                                phi_4875_ = (((_e2551 - _e2027) / _e2312) * 1023f);
                                            } else {
                                                phi_4875_ = 0f;
                                            }
                                            let _e2659 = phi_4875_;
                                            let _e2661 = select(1023f, _e2659, (_e2659 < 1023f));
                                            let _e2663 = select(0f, _e2661, (_e2661 > 0f));
                                            let _e2668 = select(select(u32(_e2663), 0u, (_e2663 < 0f)), 4294967295u, (_e2663 > 4294967000f));
                                            if (_e2668 > 0u) {
                                                let _e2675 = (_e2027 + bitcast<f32>((bitcast<u32>((f32(_e2668) * _e2377)) ^ _e70)));
                                                let _e2680 = (select(select(_e2064, _e2675, (_e2675 < _e2064)), _e2064, (_e2668 == 1023u)) > _e2551);
                                                if _e2680 {
                                                    phi_4926_ = (_e2668 - 1u);
                                                } else {
                                                    phi_4926_ = u32();
                                                }
                                                let _e2683 = phi_4926_;
                                                phi_4928_ = _e2683;
                                                phi_4929_ = select(true, false, _e2680);
                                            } else {
                                                phi_4928_ = u32();
                                                phi_4929_ = true;
                                            }
                                            let _e2686 = phi_4928_;
                                            let _e2688 = phi_4929_;
                                            if _e2688 {
                                                if (_e2668 < 1023u) {
                                                    let _e2690 = (_e2668 + 1u);
                                                    let _e2696 = (_e2027 + bitcast<f32>((bitcast<u32>((f32(_e2690) * _e2377)) ^ _e70)));
                                                    phi_4967_ = select(_e2668, _e2690, (select(select(_e2064, _e2696, (_e2696 < _e2064)), _e2064, (_e2690 == 1023u)) <= _e2551));
                                                } else {
                                                    phi_4967_ = _e2668;
                                                }
                                                let _e2704 = phi_4967_;
                                                phi_4968_ = _e2704;
                                            } else {
                                                phi_4968_ = _e2686;
                                            }
                                            let _e2706 = phi_4968_;
                                            let _e2712 = (_e2027 + bitcast<f32>((bitcast<u32>((f32(_e2706) * _e2377)) ^ _e70)));
                                            let _e2718 = select(_e2706, 0u, (select(select(_e2064, _e2712, (_e2712 < _e2064)), _e2064, (_e2706 == 1023u)) > _e2551));
                                            if (_e2718 < 1023u) {
                                                phi_5002_ = (_e2718 + 1u);
                                            } else {
                                                phi_5002_ = _e2718;
                                            }
                                            let _e2722 = phi_5002_;
                                            let _e2728 = (_e2027 + bitcast<f32>((bitcast<u32>((f32(_e2718) * _e2377)) ^ _e70)));
                                            let _e2742 = (_e2027 + bitcast<f32>((bitcast<u32>((f32(_e2722) * _e2377)) ^ _e70)));
                                            if _e2428 {
                                                phi_5073_ = (((_e2556 - _e2040) / _e2427) * 1023f);
                                            } else {
                                                phi_5073_ = 0f;
                                            }
                                            let _e2760 = phi_5073_;
                                            let _e2762 = select(1023f, _e2760, (_e2760 < 1023f));
                                            let _e2764 = select(0f, _e2762, (_e2762 > 0f));
                                            let _e2769 = select(select(u32(_e2764), 0u, (_e2764 < 0f)), 4294967295u, (_e2764 > 4294967000f));
                                            if (_e2769 > 0u) {
                                                let _e2776 = (_e2040 + bitcast<f32>((bitcast<u32>((f32(_e2769) * _e2492)) ^ _e70)));
                                                let _e2781 = (select(select(_e2077, _e2776, (_e2776 < _e2077)), _e2077, (_e2769 == 1023u)) > _e2556);
                                                if _e2781 {
                                                    phi_5124_ = (_e2769 - 1u);
                                                } else {
                                                    phi_5124_ = u32();
                                                }
                                                let _e2784 = phi_5124_;
                                                phi_5126_ = _e2784;
                                                phi_5127_ = select(true, false, _e2781);
                                            } else {
                                                phi_5126_ = u32();
                                                phi_5127_ = true;
                                            }
                                            let _e2787 = phi_5126_;
                                            let _e2789 = phi_5127_;
                                            if _e2789 {
                                                if (_e2769 < 1023u) {
                                                    let _e2791 = (_e2769 + 1u);
                                                    let _e2797 = (_e2040 + bitcast<f32>((bitcast<u32>((f32(_e2791) * _e2492)) ^ _e70)));
                                                    phi_5165_ = select(_e2769, _e2791, (select(select(_e2077, _e2797, (_e2797 < _e2077)), _e2077, (_e2791 == 1023u)) <= _e2556));
                                                } else {
                                                    phi_5165_ = _e2769;
                                                }
                                                let _e2805 = phi_5165_;
                                                phi_5166_ = _e2805;
                                            } else {
                                                phi_5166_ = _e2787;
                                            }
                                            let _e2807 = phi_5166_;
                                            let _e2813 = (_e2040 + bitcast<f32>((bitcast<u32>((f32(_e2807) * _e2492)) ^ _e70)));
                                            let _e2819 = select(_e2807, 0u, (select(select(_e2077, _e2813, (_e2813 < _e2077)), _e2077, (_e2807 == 1023u)) > _e2556));
                                            if (_e2819 < 1023u) {
                                                phi_5200_ = (_e2819 + 1u);
                                            } else {
                                                phi_5200_ = _e2819;
                                            }
                                            let _e2823 = phi_5200_;
                                            let _e2829 = (_e2040 + bitcast<f32>((bitcast<u32>((f32(_e2819) * _e2492)) ^ _e70)));
                                            let _e2843 = (_e2040 + bitcast<f32>((bitcast<u32>((f32(_e2823) * _e2492)) ^ _e70)));
                                            let _e2861 = global_2.member[_e2182].member[6u];
                                            let _e2866 = global_2.member[_e2182].member[7u];
                                            let _e2871 = global_2.member[_e2182].member[8u];
                                            if _e2201 {
                                                phi_5277_ = (((_e2861 - _e2014) / _e2200) * 1023f);
                                            } else {
                                                phi_5277_ = 0f;
                                            }
                                            let _e2876 = phi_5277_;
                                            let _e2878 = select(1023f, _e2876, (_e2876 < 1023f));
                                            let _e2880 = select(0f, _e2878, (_e2878 > 0f));
                                            let _e2885 = select(select(u32(_e2880), 0u, (_e2880 < 0f)), 4294967295u, (_e2880 > 4294967000f));
                                            if (_e2885 > 0u) {
                                                let _e2892 = (_e2014 + bitcast<f32>((bitcast<u32>((f32(_e2885) * _e2265)) ^ _e70)));
                                                let _e2897 = (select(select(_e2051, _e2892, (_e2892 < _e2051)), _e2051, (_e2885 == 1023u)) > _e2861);
                                                if _e2897 {
                                                    phi_5328_ = (_e2885 - 1u);
                                                } else {
                                                    phi_5328_ = u32();
                                                }
                                                let _e2900 = phi_5328_;
                                                phi_5330_ = _e2900;
                                                phi_5331_ = select(true, false, _e2897);
                                            } else {
                                                phi_5330_ = u32();
                                                phi_5331_ = true;
                                            }
                                            let _e2903 = phi_5330_;
                                            let _e2905 = phi_5331_;
                                            if _e2905 {
                                                if (_e2885 < 1023u) {
                                                    let _e2907 = (_e2885 + 1u);
                                                    let _e2913 = (_e2014 + bitcast<f32>((bitcast<u32>((f32(_e2907) * _e2265)) ^ _e70)));
                                                    phi_5369_ = select(_e2885, _e2907, (select(select(_e2051, _e2913, (_e2913 < _e2051)), _e2051, (_e2907 == 1023u)) <= _e2861));
                                                } else {
                                                    phi_5369_ = _e2885;
                                                }
                                                let _e2921 = phi_5369_;
                                                phi_5370_ = _e2921;
                                            } else {
                                                phi_5370_ = _e2903;
                                            }
                                            let _e2923 = phi_5370_;
                                            let _e2929 = (_e2014 + bitcast<f32>((bitcast<u32>((f32(_e2923) * _e2265)) ^ _e70)));
                                            let _e2935 = select(_e2923, 0u, (select(select(_e2051, _e2929, (_e2929 < _e2051)), _e2051, (_e2923 == 1023u)) > _e2861));
                                            if (_e2935 < 1023u) {
                                                phi_5404_ = (_e2935 + 1u);
                                            } else {
                                                phi_5404_ = _e2935;
                                            }
                                            let _e2939 = phi_5404_;
                                            let _e2945 = (_e2014 + bitcast<f32>((bitcast<u32>((f32(_e2935) * _e2265)) ^ _e70)));
                                            let _e2959 = (_e2014 + bitcast<f32>((bitcast<u32>((f32(_e2939) * _e2265)) ^ _e70)));
                                            if _e2313 {
                                                phi_5473_ = (((_e2866 - _e2027) / _e2312) * 1023f);
                                            } else {
                                                phi_5473_ = 0f;
                                            }
                                            let _e2974 = phi_5473_;
                                            let _e2976 = select(1023f, _e2974, (_e2974 < 1023f));
                                            let _e2978 = select(0f, _e2976, (_e2976 > 0f));
                                            let _e2983 = select(select(u32(_e2978), 0u, (_e2978 < 0f)), 4294967295u, (_e2978 > 4294967000f));
                                            if (_e2983 > 0u) {
                                                let _e2990 = (_e2027 + bitcast<f32>((bitcast<u32>((f32(_e2983) * _e2377)) ^ _e70)));
                                                let _e2995 = (select(select(_e2064, _e2990, (_e2990 < _e2064)), _e2064, (_e2983 == 1023u)) > _e2866);
                                                if _e2995 {
                                                    phi_5524_ = (_e2983 - 1u);
                                                } else {
                                                    phi_5524_ = u32();
                                                }
                                                let _e2998 = phi_5524_;
                                                phi_5526_ = _e2998;
                                                phi_5527_ = select(true, false, _e2995);
                                            } else {
                                                phi_5526_ = u32();
                                                phi_5527_ = true;
                                            }
                                            let _e3001 = phi_5526_;
                                            let _e3003 = phi_5527_;
                                            if _e3003 {
                                                if (_e2983 < 1023u) {
                                                    let _e3005 = (_e2983 + 1u);
                                                    let _e3011 = (_e2027 + bitcast<f32>((bitcast<u32>((f32(_e3005) * _e2377)) ^ _e70)));
                                                    phi_5565_ = select(_e2983, _e3005, (select(select(_e2064, _e3011, (_e3011 < _e2064)), _e2064, (_e3005 == 1023u)) <= _e2866));
                                                } else {
                                                    phi_5565_ = _e2983;
                                                }
                                                let _e3019 = phi_5565_;
                                                phi_5566_ = _e3019;
                                            } else {
                                                phi_5566_ = _e3001;
                                            }
                                            let _e3021 = phi_5566_;
                                            let _e3027 = (_e2027 + bitcast<f32>((bitcast<u32>((f32(_e3021) * _e2377)) ^ _e70)));
                                            let _e3033 = select(_e3021, 0u, (select(select(_e2064, _e3027, (_e3027 < _e2064)), _e2064, (_e3021 == 1023u)) > _e2866));
                                            if (_e3033 < 1023u) {
                                                phi_5600_ = (_e3033 + 1u);
                                            } else {
                                                phi_5600_ = _e3033;
                                            }
                                            let _e3037 = phi_5600_;
                                            let _e3043 = (_e2027 + bitcast<f32>((bitcast<u32>((f32(_e3033) * _e2377)) ^ _e70)));
                                            let _e3057 = (_e2027 + bitcast<f32>((bitcast<u32>((f32(_e3037) * _e2377)) ^ _e70)));
                                            if _e2428 {
                                                phi_5671_ = (((_e2871 - _e2040) / _e2427) * 1023f);
                                            } else {
                                                phi_5671_ = 0f;
                                            }
                                            let _e3075 = phi_5671_;
                                            let _e3077 = select(1023f, _e3075, (_e3075 < 1023f));
                                            let _e3079 = select(0f, _e3077, (_e3077 > 0f));
                                            let _e3084 = select(select(u32(_e3079), 0u, (_e3079 < 0f)), 4294967295u, (_e3079 > 4294967000f));
                                            if (_e3084 > 0u) {
                                                let _e3091 = (_e2040 + bitcast<f32>((bitcast<u32>((f32(_e3084) * _e2492)) ^ _e70)));
                                                let _e3096 = (select(select(_e2077, _e3091, (_e3091 < _e2077)), _e2077, (_e3084 == 1023u)) > _e2871);
                                                if _e3096 {
                                                    phi_5722_ = (_e3084 - 1u);
                                                } else {
                                                    phi_5722_ = u32();
                                                }
                                                let _e3099 = phi_5722_;
                                                phi_5724_ = _e3099;
                                                phi_5725_ = select(true, false, _e3096);
                                            } else {
                                                phi_5724_ = u32();
                                                phi_5725_ = true;
                                            }
                                            let _e3102 = phi_5724_;
                                            let _e3104 = phi_5725_;
                                            if _e3104 {
                                                if (_e3084 < 1023u) {
                                                    let _e3106 = (_e3084 + 1u);
                                                    let _e3112 = (_e2040 + bitcast<f32>((bitcast<u32>((f32(_e3106) * _e2492)) ^ _e70)));
                                                    phi_5763_ = select(_e3084, _e3106, (select(select(_e2077, _e3112, (_e3112 < _e2077)), _e2077, (_e3106 == 1023u)) <= _e2871));
                                                } else {
                                                    phi_5763_ = _e3084;
                                                }
                                                let _e3120 = phi_5763_;
                                                phi_5764_ = _e3120;
                                            } else {
                                                phi_5764_ = _e3102;
                                            }
                                            let _e3122 = phi_5764_;
                                            let _e3128 = (_e2040 + bitcast<f32>((bitcast<u32>((f32(_e3122) * _e2492)) ^ _e70)));
                                            let _e3134 = select(_e3122, 0u, (select(select(_e2077, _e3128, (_e3128 < _e2077)), _e2077, (_e3122 == 1023u)) > _e2871));
                                            if (_e3134 < 1023u) {
                                                phi_5798_ = (_e3134 + 1u);
                                            } else {
                                                phi_5798_ = _e3134;
                                            }
                                            let _e3138 = phi_5798_;
                                            let _e3144 = (_e2040 + bitcast<f32>((bitcast<u32>((f32(_e3134) * _e2492)) ^ _e70)));
                                            let _e3158 = (_e2040 + bitcast<f32>((bitcast<u32>((f32(_e3138) * _e2492)) ^ _e70)));
                                            let _e3176 = global_2.member[_e2182].member_1;
                                            if _e2184 {
                                            } else {
                                                phi_7927_ = true;
                                                break;
                                            }
                                            global_6.member[_e2182] = type_43(array<u32, 3>(((select(_e2277, _e2281, (bitcast<f32>((bitcast<u32>((select(select(_e2051, _e2301, (_e2301 < _e2051)), _e2051, (_e2281 == 1023u)) - _e2189)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2189 - select(select(_e2051, _e2287, (_e2287 < _e2051)), _e2051, (_e2277 == 1023u)))) & 2147483647u)))) | (select(_e2389, _e2393, (bitcast<f32>((bitcast<u32>((select(select(_e2064, _e2413, (_e2413 < _e2064)), _e2064, (_e2393 == 1023u)) - _e2194)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2194 - select(select(_e2064, _e2399, (_e2399 < _e2064)), _e2064, (_e2389 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e2504, _e2508, (bitcast<f32>((bitcast<u32>((select(select(_e2077, _e2528, (_e2528 < _e2077)), _e2077, (_e2508 == 1023u)) - _e2199)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2199 - select(select(_e2077, _e2514, (_e2514 < _e2077)), _e2077, (_e2504 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i))), ((select(_e2620, _e2624, (bitcast<f32>((bitcast<u32>((select(select(_e2051, _e2644, (_e2644 < _e2051)), _e2051, (_e2624 == 1023u)) - _e2546)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2546 - select(select(_e2051, _e2630, (_e2630 < _e2051)), _e2051, (_e2620 == 1023u)))) & 2147483647u)))) | (select(_e2718, _e2722, (bitcast<f32>((bitcast<u32>((select(select(_e2064, _e2742, (_e2742 < _e2064)), _e2064, (_e2722 == 1023u)) - _e2551)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2551 - select(select(_e2064, _e2728, (_e2728 < _e2064)), _e2064, (_e2718 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e2819, _e2823, (bitcast<f32>((bitcast<u32>((select(select(_e2077, _e2843, (_e2843 < _e2077)), _e2077, (_e2823 == 1023u)) - _e2556)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2556 - select(select(_e2077, _e2829, (_e2829 < _e2077)), _e2077, (_e2819 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i))), ((select(_e2935, _e2939, (bitcast<f32>((bitcast<u32>((select(select(_e2051, _e2959, (_e2959 < _e2051)), _e2051, (_e2939 == 1023u)) - _e2861)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2861 - select(select(_e2051, _e2945, (_e2945 < _e2051)), _e2051, (_e2935 == 1023u)))) & 2147483647u)))) | (select(_e3033, _e3037, (bitcast<f32>((bitcast<u32>((select(select(_e2064, _e3057, (_e3057 < _e2064)), _e2064, (_e3037 == 1023u)) - _e2866)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2866 - select(select(_e2064, _e3043, (_e3043 < _e2064)), _e2064, (_e3033 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e3134, _e3138, (bitcast<f32>((bitcast<u32>((select(select(_e2077, _e3158, (_e3158 < _e2077)), _e2077, (_e3138 == 1023u)) - _e2871)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2871 - select(select(_e2077, _e3144, (_e3144 < _e2077)), _e2077, (_e3134 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i)))), _e3176);
                                        }
                                    }
                                }
                                continue;
                                continuing {
                                    phi_4018_ = _e2174;
                                    phi_7927_ = _e870;
                                    break if !(_e2180);
                                }
                            }
                            let _e3182 = phi_7927_;
                            if _e3182 {
                                break;
                            }
                            phi_8380_ = _e3182;
                        } else {
                            phi_8380_ = _e870;
                        }
                        let _e3184 = phi_8380_;
                        if _e66 {
                        } else {
                            break;
                        }
                        if ((_e905 & 2147483648u) != 0u) {
                            phi_5889_ = type_4(0u, ((_e905 >> bitcast<u32>(28u)) & 7u));
                            loop {
                                let _e3192 = phi_5889_;
                                if (_e3192.member < _e3192.member_1) {
                                    phi_5890_ = type_4((_e3192.member + 1u), _e3192.member_1);
                                    phi_5913_ = type_4(1u, _e3192.member);
                                } else {
                                    phi_5890_ = _e3192;
                                    phi_5913_ = type_4(0u, type_4().member_1);
                                }
                                let _e3205 = phi_5890_;
                                let _e3207 = phi_5913_;
                                let _e3211 = (bitcast<i32>(_e3207.member) != 0i);
                                if _e3211 {
                                    let _e3213 = ((_e905 & 268435455u) + _e3207.member_1);
                                    let _e3214 = (_e3213 < _e51);
                                    if _e3214 {
                                        let _e3215 = (_e3213 < _e55);
                                        if _e3215 {
                                            if _e3214 {
                                            } else {
                                                phi_8376_ = true;
                                                break;
                                            }
                                            let _e3220 = global_2.member[_e3213].member[0u];
                                            let _e3225 = global_2.member[_e3213].member[1u];
                                            let _e3230 = global_2.member[_e3213].member[2u];
                                            let _e3231 = (_e2125 - _e2088);
                                            let _e3232 = (_e3231 > 0f);
                                            if _e3232 {
                                                phi_5952_ = (((_e3220 - _e2088) / _e3231) * 1023f);
                                            } else {
                                                phi_5952_ = 0f;
                                            }
                                            let _e3237 = phi_5952_;
                                            let _e3239 = select(1023f, _e3237, (_e3237 < 1023f));
                                            let _e3241 = select(0f, _e3239, (_e3239 > 0f));
                                            let _e3246 = select(select(u32(_e3241), 0u, (_e3241 < 0f)), 4294967295u, (_e3241 > 4294967000f));
                                            if (_e3246 > 0u) {
                                                let _e3257 = (_e2088 + bitcast<f32>((bitcast<u32>((f32(_e3246) * bitcast<f32>((bitcast<u32>((_e3231 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                let _e3262 = (select(select(_e2125, _e3257, (_e3257 < _e2125)), _e2125, (_e3246 == 1023u)) > _e3220);
                                                if _e3262 {
                                                    phi_6003_ = (_e3246 - 1u);
                                                } else {
                                                    phi_6003_ = u32();
                                                }
                                                let _e3265 = phi_6003_;
                                                phi_6005_ = _e3265;
                                                phi_6006_ = select(true, false, _e3262);
                                            } else {
                                                phi_6005_ = u32();
                                                phi_6006_ = true;
                                            }
                                            let _e3268 = phi_6005_;
                                            let _e3270 = phi_6006_;
                                            if _e3270 {
                                                if (_e3246 < 1023u) {
                                                    let _e3272 = (_e3246 + 1u);
                                                    let _e3282 = (_e2088 + bitcast<f32>((bitcast<u32>((f32(_e3272) * bitcast<f32>((bitcast<u32>((_e3231 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                    phi_6044_ = select(_e3246, _e3272, (select(select(_e2125, _e3282, (_e3282 < _e2125)), _e2125, (_e3272 == 1023u)) <= _e3220));
                                                } else {
                                                    phi_6044_ = _e3246;
                                                }
                                                let _e3290 = phi_6044_;
                                                phi_6045_ = _e3290;
                                            } else {
                                                phi_6045_ = _e3268;
                                            }
                                            let _e3292 = phi_6045_;
                                            let _e3296 = bitcast<f32>((bitcast<u32>((_e3231 * 0.0009775171f)) ^ _e70));
                                            let _e3302 = (_e2088 + bitcast<f32>((bitcast<u32>((f32(_e3292) * _e3296)) ^ _e70)));
                                            let _e3308 = select(_e3292, 0u, (select(select(_e2125, _e3302, (_e3302 < _e2125)), _e2125, (_e3292 == 1023u)) > _e3220));
                                            if (_e3308 < 1023u) {
                                                phi_6079_ = (_e3308 + 1u);
                                            } else {
                                                phi_6079_ = _e3308;
                                            }
                                            let _e3312 = phi_6079_;
                                            let _e3318 = (_e2088 + bitcast<f32>((bitcast<u32>((f32(_e3308) * _e3296)) ^ _e70)));
                                            let _e3332 = (_e2088 + bitcast<f32>((bitcast<u32>((f32(_e3312) * _e3296)) ^ _e70)));
                                            let _e3343 = (_e2138 - _e2101);
                                            let _e3344 = (_e3343 > 0f);
                                            if _e3344 {
                                                phi_6148_ = (((_e3225 - _e2101) / _e3343) * 1023f);
                                            } else {
                                                phi_6148_ = 0f;
                                            }
                                            let _e3349 = phi_6148_;
                                            let _e3351 = select(1023f, _e3349, (_e3349 < 1023f));
                                            let _e3353 = select(0f, _e3351, (_e3351 > 0f));
                                            let _e3358 = select(select(u32(_e3353), 0u, (_e3353 < 0f)), 4294967295u, (_e3353 > 4294967000f));
                                            if (_e3358 > 0u) {
                                                let _e3369 = (_e2101 + bitcast<f32>((bitcast<u32>((f32(_e3358) * bitcast<f32>((bitcast<u32>((_e3343 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                let _e3374 = (select(select(_e2138, _e3369, (_e3369 < _e2138)), _e2138, (_e3358 == 1023u)) > _e3225);
                                                if _e3374 {
                                                    phi_6199_ = (_e3358 - 1u);
                                                } else {
                                                    phi_6199_ = u32();
                                                }
                                                let _e3377 = phi_6199_;
                                                phi_6201_ = _e3377;
                                                phi_6202_ = select(true, false, _e3374);
                                            } else {
                                                phi_6201_ = u32();
                                                phi_6202_ = true;
                                            }
                                            let _e3380 = phi_6201_;
                                            let _e3382 = phi_6202_;
                                            if _e3382 {
                                                if (_e3358 < 1023u) {
                                                    let _e3384 = (_e3358 + 1u);
                                                    let _e3394 = (_e2101 + bitcast<f32>((bitcast<u32>((f32(_e3384) * bitcast<f32>((bitcast<u32>((_e3343 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                    phi_6240_ = select(_e3358, _e3384, (select(select(_e2138, _e3394, (_e3394 < _e2138)), _e2138, (_e3384 == 1023u)) <= _e3225));
                                                } else {
                                                    phi_6240_ = _e3358;
                                                }
                                                let _e3402 = phi_6240_;
                                                phi_6241_ = _e3402;
                                            } else {
                                                phi_6241_ = _e3380;
                                            }
                                            let _e3404 = phi_6241_;
                                            let _e3408 = bitcast<f32>((bitcast<u32>((_e3343 * 0.0009775171f)) ^ _e70));
                                            let _e3414 = (_e2101 + bitcast<f32>((bitcast<u32>((f32(_e3404) * _e3408)) ^ _e70)));
                                            let _e3420 = select(_e3404, 0u, (select(select(_e2138, _e3414, (_e3414 < _e2138)), _e2138, (_e3404 == 1023u)) > _e3225));
                                            if (_e3420 < 1023u) {
                                                phi_6275_ = (_e3420 + 1u);
                                            } else {
                                                phi_6275_ = _e3420;
                                            }
                                            let _e3424 = phi_6275_;
                                            let _e3430 = (_e2101 + bitcast<f32>((bitcast<u32>((f32(_e3420) * _e3408)) ^ _e70)));
                                            let _e3444 = (_e2101 + bitcast<f32>((bitcast<u32>((f32(_e3424) * _e3408)) ^ _e70)));
                                            let _e3458 = (_e2151 - _e2114);
                                            let _e3459 = (_e3458 > 0f);
                                            if _e3459 {
                                                phi_6346_ = (((_e3230 - _e2114) / _e3458) * 1023f);
                                            } else {
                                                phi_6346_ = 0f;
                                            }
                                            let _e3464 = phi_6346_;
                                            let _e3466 = select(1023f, _e3464, (_e3464 < 1023f));
                                            let _e3468 = select(0f, _e3466, (_e3466 > 0f));
                                            let _e3473 = select(select(u32(_e3468), 0u, (_e3468 < 0f)), 4294967295u, (_e3468 > 4294967000f));
                                            if (_e3473 > 0u) {
                                                let _e3484 = (_e2114 + bitcast<f32>((bitcast<u32>((f32(_e3473) * bitcast<f32>((bitcast<u32>((_e3458 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                let _e3489 = (select(select(_e2151, _e3484, (_e3484 < _e2151)), _e2151, (_e3473 == 1023u)) > _e3230);
                                                if _e3489 {
                                                    phi_6397_ = (_e3473 - 1u);
                                                } else {
                                                    phi_6397_ = u32();
                                                }
                                                let _e3492 = phi_6397_;
                                                phi_6399_ = _e3492;
                                                phi_6400_ = select(true, false, _e3489);
                                            } else {
                                                phi_6399_ = u32();
                                                phi_6400_ = true;
                                            }
                                            let _e3495 = phi_6399_;
                                            let _e3497 = phi_6400_;
                                            if _e3497 {
                                                if (_e3473 < 1023u) {
                                                    let _e3499 = (_e3473 + 1u);
                                                    let _e3509 = (_e2114 + bitcast<f32>((bitcast<u32>((f32(_e3499) * bitcast<f32>((bitcast<u32>((_e3458 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                    phi_6438_ = select(_e3473, _e3499, (select(select(_e2151, _e3509, (_e3509 < _e2151)), _e2151, (_e3499 == 1023u)) <= _e3230));
                                                } else {
                                                    phi_6438_ = _e3473;
                                                }
                                                let _e3517 = phi_6438_;
                                                phi_6439_ = _e3517;
                                            } else {
                                                phi_6439_ = _e3495;
                                            }
                                            let _e3519 = phi_6439_;
                                            let _e3523 = bitcast<f32>((bitcast<u32>((_e3458 * 0.0009775171f)) ^ _e70));
                                            let _e3529 = (_e2114 + bitcast<f32>((bitcast<u32>((f32(_e3519) * _e3523)) ^ _e70)));
                                            let _e3535 = select(_e3519, 0u, (select(select(_e2151, _e3529, (_e3529 < _e2151)), _e2151, (_e3519 == 1023u)) > _e3230));
                                            if (_e3535 < 1023u) {
                                                phi_6473_ = (_e3535 + 1u);
                                            } else {
                                                phi_6473_ = _e3535;
                                            }
                                            let _e3539 = phi_6473_;
                                            let _e3545 = (_e2114 + bitcast<f32>((bitcast<u32>((f32(_e3535) * _e3523)) ^ _e70)));
                                            let _e3559 = (_e2114 + bitcast<f32>((bitcast<u32>((f32(_e3539) * _e3523)) ^ _e70)));
                                            let _e3577 = global_2.member[_e3213].member[3u];
                                            let _e3582 = global_2.member[_e3213].member[4u];
                                            let _e3587 = global_2.member[_e3213].member[5u];
                                            if _e3232 {
                                                phi_6550_ = (((_e3577 - _e2088) / _e3231) * 1023f);
                                            } else {
                                                phi_6550_ = 0f;
                                            }
                                            let _e3592 = phi_6550_;
                                            let _e3594 = select(1023f, _e3592, (_e3592 < 1023f));
                                            let _e3596 = select(0f, _e3594, (_e3594 > 0f));
                                            let _e3601 = select(select(u32(_e3596), 0u, (_e3596 < 0f)), 4294967295u, (_e3596 > 4294967000f));
                                            if (_e3601 > 0u) {
                                                let _e3608 = (_e2088 + bitcast<f32>((bitcast<u32>((f32(_e3601) * _e3296)) ^ _e70)));
                                                let _e3613 = (select(select(_e2125, _e3608, (_e3608 < _e2125)), _e2125, (_e3601 == 1023u)) > _e3577);
                                                if _e3613 {
                                                    phi_6601_ = (_e3601 - 1u);
                                                } else {
                                                    phi_6601_ = u32();
                                                }
                                                let _e3616 = phi_6601_;
                                                phi_6603_ = _e3616;
                                                phi_6604_ = select(true, false, _e3613);
                                            } else {
                                                phi_6603_ = u32();
                                                phi_6604_ = true;
                                            }
                                            let _e3619 = phi_6603_;
                                            let _e3621 = phi_6604_;
                                            if _e3621 {
                                                if (_e3601 < 1023u) {
                                                    let _e3623 = (_e3601 + 1u);
                                                    let _e3629 = (_e2088 + bitcast<f32>((bitcast<u32>((f32(_e3623) * _e3296)) ^ _e70)));
                                                    phi_6642_ = select(_e3601, _e3623, (select(select(_e2125, _e3629, (_e3629 < _e2125)), _e2125, (_e3623 == 1023u)) <= _e3577));
                                                } else {
                                                    phi_6642_ = _e3601;
                                                }
                                                let _e3637 = phi_6642_;
                                                phi_6643_ = _e3637;
                                            } else {
                                                phi_6643_ = _e3619;
                                            }
                                            let _e3639 = phi_6643_;
                                            let _e3645 = (_e2088 + bitcast<f32>((bitcast<u32>((f32(_e3639) * _e3296)) ^ _e70)));
                                            let _e3651 = select(_e3639, 0u, (select(select(_e2125, _e3645, (_e3645 < _e2125)), _e2125, (_e3639 == 1023u)) > _e3577));
                                            if (_e3651 < 1023u) {
                                                phi_6677_ = (_e3651 + 1u);
                                            } else {
                                                phi_6677_ = _e3651;
                                            }
                                            let _e3655 = phi_6677_;
                                            let _e3661 = (_e2088 + bitcast<f32>((bitcast<u32>((f32(_e3651) * _e3296)) ^ _e70)));
                                            let _e3675 = (_e2088 + bitcast<f32>((bitcast<u32>((f32(_e3655) * _e3296)) ^ _e70)));
                                            if _e3344 {
                                                phi_6746_ = (((_e3582 - _e2101) / _e3343) * 1023f);
                                            } else {
                                                phi_6746_ = 0f;
                                            }
                                            let _e3690 = phi_6746_;
                                            let _e3692 = select(1023f, _e3690, (_e3690 < 1023f));
                                            let _e3694 = select(0f, _e3692, (_e3692 > 0f));
                                            let _e3699 = select(select(u32(_e3694), 0u, (_e3694 < 0f)), 4294967295u, (_e3694 > 4294967000f));
                                            if (_e3699 > 0u) {
                                                let _e3706 = (_e2101 + bitcast<f32>((bitcast<u32>((f32(_e3699) * _e3408)) ^ _e70)));
                                                let _e3711 = (select(select(_e2138, _e3706, (_e3706 < _e2138)), _e2138, (_e3699 == 1023u)) > _e3582);
                                                if _e3711 {
                                                    phi_6797_ = (_e3699 - 1u);
                                                } else {
                                                    phi_6797_ = u32();
                                                }
                                                let _e3714 = phi_6797_;
                                                phi_6799_ = _e3714;
                                                phi_6800_ = select(true, false, _e3711);
                                            } else {
                                                phi_6799_ = u32();
                                                phi_6800_ = true;
                                            }
                                            let _e3717 = phi_6799_;
                                            let _e3719 = phi_6800_;
                                            if _e3719 {
                                                if (_e3699 < 1023u) {
                                                    let _e3721 = (_e3699 + 1u);
                                                    let _e3727 = (_e2101 + bitcast<f32>((bitcast<u32>((f32(_e3721) * _e3408)) ^ _e70)));
                                                    phi_6838_ = select(_e3699, _e3721, (select(select(_e2138, _e3727, (_e3727 < _e2138)), _e2138, (_e3721 == 1023u)) <= _e3582));
                                                } else {
                                                    phi_6838_ = _e3699;
                                                }
                                                let _e3735 = phi_6838_;
                                                phi_6839_ = _e3735;
                                            } else {
                                                phi_6839_ = _e3717;
                                            }
                                            let _e3737 = phi_6839_;
                                            let _e3743 = (_e2101 + bitcast<f32>((bitcast<u32>((f32(_e3737) * _e3408)) ^ _e70)));
                                            let _e3749 = select(_e3737, 0u, (select(select(_e2138, _e3743, (_e3743 < _e2138)), _e2138, (_e3737 == 1023u)) > _e3582));
                                            if (_e3749 < 1023u) {
                                                phi_6873_ = (_e3749 + 1u);
                                            } else {
                                                phi_6873_ = _e3749;
                                            }
                                            let _e3753 = phi_6873_;
                                            let _e3759 = (_e2101 + bitcast<f32>((bitcast<u32>((f32(_e3749) * _e3408)) ^ _e70)));
                                            let _e3773 = (_e2101 + bitcast<f32>((bitcast<u32>((f32(_e3753) * _e3408)) ^ _e70)));
                                            if _e3459 {
                                                phi_6944_ = (((_e3587 - _e2114) / _e3458) * 1023f);
                                            } else {
                                                phi_6944_ = 0f;
                                            }
                                            let _e3791 = phi_6944_;
                                            let _e3793 = select(1023f, _e3791, (_e3791 < 1023f));
                                            let _e3795 = select(0f, _e3793, (_e3793 > 0f));
                                            let _e3800 = select(select(u32(_e3795), 0u, (_e3795 < 0f)), 4294967295u, (_e3795 > 4294967000f));
                                            if (_e3800 > 0u) {
                                                let _e3807 = (_e2114 + bitcast<f32>((bitcast<u32>((f32(_e3800) * _e3523)) ^ _e70)));
                                                let _e3812 = (select(select(_e2151, _e3807, (_e3807 < _e2151)), _e2151, (_e3800 == 1023u)) > _e3587);
                                                if _e3812 {
                                                    phi_6995_ = (_e3800 - 1u);
                                                } else {
                                                    phi_6995_ = u32();
                                                }
                                                let _e3815 = phi_6995_;
                                                phi_6997_ = _e3815;
                                                phi_6998_ = select(true, false, _e3812);
                                            } else {
                                                phi_6997_ = u32();
                                                phi_6998_ = true;
                                            }
                                            let _e3818 = phi_6997_;
                                            let _e3820 = phi_6998_;
                                            if _e3820 {
                                                if (_e3800 < 1023u) {
                                                    let _e3822 = (_e3800 + 1u);
                                                    let _e3828 = (_e2114 + bitcast<f32>((bitcast<u32>((f32(_e3822) * _e3523)) ^ _e70)));
                                                    phi_7036_ = select(_e3800, _e3822, (select(select(_e2151, _e3828, (_e3828 < _e2151)), _e2151, (_e3822 == 1023u)) <= _e3587));
                                                } else {
                                                    phi_7036_ = _e3800;
                                                }
                                                let _e3836 = phi_7036_;
                                                phi_7037_ = _e3836;
                                            } else {
                                                phi_7037_ = _e3818;
                                            }
                                            let _e3838 = phi_7037_;
                                            let _e3844 = (_e2114 + bitcast<f32>((bitcast<u32>((f32(_e3838) * _e3523)) ^ _e70)));
                                            let _e3850 = select(_e3838, 0u, (select(select(_e2151, _e3844, (_e3844 < _e2151)), _e2151, (_e3838 == 1023u)) > _e3587));
                                            if (_e3850 < 1023u) {
                                                phi_7071_ = (_e3850 + 1u);
                                            } else {
                                                phi_7071_ = _e3850;
                                            }
                                            let _e3854 = phi_7071_;
                                            let _e3860 = (_e2114 + bitcast<f32>((bitcast<u32>((f32(_e3850) * _e3523)) ^ _e70)));
                                            let _e3874 = (_e2114 + bitcast<f32>((bitcast<u32>((f32(_e3854) * _e3523)) ^ _e70)));
                                            let _e3892 = global_2.member[_e3213].member[6u];
                                            let _e3897 = global_2.member[_e3213].member[7u];
                                            let _e3902 = global_2.member[_e3213].member[8u];
                                            if _e3232 {
                                                phi_7148_ = (((_e3892 - _e2088) / _e3231) * 1023f);
                                            } else {
                                                phi_7148_ = 0f;
                                            }
                                            let _e3907 = phi_7148_;
                                            let _e3909 = select(1023f, _e3907, (_e3907 < 1023f));
                                            let _e3911 = select(0f, _e3909, (_e3909 > 0f));
                                            let _e3916 = select(select(u32(_e3911), 0u, (_e3911 < 0f)), 4294967295u, (_e3911 > 4294967000f));
                                            if (_e3916 > 0u) {
                                                let _e3923 = (_e2088 + bitcast<f32>((bitcast<u32>((f32(_e3916) * _e3296)) ^ _e70)));
                                                let _e3928 = (select(select(_e2125, _e3923, (_e3923 < _e2125)), _e2125, (_e3916 == 1023u)) > _e3892);
                                                if _e3928 {
                                                    phi_7199_ = (_e3916 - 1u);
                                                } else {
                                                    phi_7199_ = u32();
                                                }
                                                let _e3931 = phi_7199_;
                                                phi_7201_ = _e3931;
                                                phi_7202_ = select(true, false, _e3928);
                                            } else {
                                                phi_7201_ = u32();
                                                phi_7202_ = true;
                                            }
                                            let _e3934 = phi_7201_;
                                            let _e3936 = phi_7202_;
                                            if _e3936 {
                                                if (_e3916 < 1023u) {
                                                    let _e3938 = (_e3916 + 1u);
                                                    let _e3944 = (_e2088 + bitcast<f32>((bitcast<u32>((f32(_e3938) * _e3296)) ^ _e70)));
                                                    phi_7240_ = select(_e3916, _e3938, (select(select(_e2125, _e3944, (_e3944 < _e2125)), _e2125, (_e3938 == 1023u)) <= _e3892));
                                                } else {
                                                    phi_7240_ = _e3916;
                                                }
                                                let _e3952 = phi_7240_;
                                                phi_7241_ = _e3952;
                                            } else {
                                                phi_7241_ = _e3934;
                                            }
                                            let _e3954 = phi_7241_;
                                            let _e3960 = (_e2088 + bitcast<f32>((bitcast<u32>((f32(_e3954) * _e3296)) ^ _e70)));
                                            let _e3966 = select(_e3954, 0u, (select(select(_e2125, _e3960, (_e3960 < _e2125)), _e2125, (_e3954 == 1023u)) > _e3892));
                                            if (_e3966 < 1023u) {
                                                phi_7275_ = (_e3966 + 1u);
                                            } else {
                                                phi_7275_ = _e3966;
                                            }
                                            let _e3970 = phi_7275_;
                                            let _e3976 = (_e2088 + bitcast<f32>((bitcast<u32>((f32(_e3966) * _e3296)) ^ _e70)));
                                            let _e3990 = (_e2088 + bitcast<f32>((bitcast<u32>((f32(_e3970) * _e3296)) ^ _e70)));
                                            if _e3344 {
                                                phi_7344_ = (((_e3897 - _e2101) / _e3343) * 1023f);
                                            } else {
                                                phi_7344_ = 0f;
                                            }
                                            let _e4005 = phi_7344_;
                                            let _e4007 = select(1023f, _e4005, (_e4005 < 1023f));
                                            let _e4009 = select(0f, _e4007, (_e4007 > 0f));
                                            let _e4014 = select(select(u32(_e4009), 0u, (_e4009 < 0f)), 4294967295u, (_e4009 > 4294967000f));
                                            if (_e4014 > 0u) {
                                                let _e4021 = (_e2101 + bitcast<f32>((bitcast<u32>((f32(_e4014) * _e3408)) ^ _e70)));
                                                let _e4026 = (select(select(_e2138, _e4021, (_e4021 < _e2138)), _e2138, (_e4014 == 1023u)) > _e3897);
                                                if _e4026 {
                                                    phi_7395_ = (_e4014 - 1u);
                                                } else {
                                                    phi_7395_ = u32();
                                                }
                                                let _e4029 = phi_7395_;
                                                phi_7397_ = _e4029;
                                                phi_7398_ = select(true, false, _e4026);
                                            } else {
                                                phi_7397_ = u32();
                                                phi_7398_ = true;
                                            }
                                            let _e4032 = phi_7397_;
                                            let _e4034 = phi_7398_;
                                            if _e4034 {
                                                if (_e4014 < 1023u) {
                                                    let _e4036 = (_e4014 + 1u);
                                                    let _e4042 = (_e2101 + bitcast<f32>((bitcast<u32>((f32(_e4036) * _e3408)) ^ _e70)));
                                                    phi_7436_ = select(_e4014, _e4036, (select(select(_e2138, _e4042, (_e4042 < _e2138)), _e2138, (_e4036 == 1023u)) <= _e3897));
                                                } else {
                                                    phi_7436_ = _e4014;
                                                }
                                                let _e4050 = phi_7436_;
                                                phi_7437_ = _e4050;
                                            } else {
                                                phi_7437_ = _e4032;
                                            }
                                            let _e4052 = phi_7437_;
                                            let _e4058 = (_e2101 + bitcast<f32>((bitcast<u32>((f32(_e4052) * _e3408)) ^ _e70)));
                                            let _e4064 = select(_e4052, 0u, (select(select(_e2138, _e4058, (_e4058 < _e2138)), _e2138, (_e4052 == 1023u)) > _e3897));
                                            if (_e4064 < 1023u) {
                                                phi_7471_ = (_e4064 + 1u);
                                            } else {
                                                phi_7471_ = _e4064;
                                            }
                                            let _e4068 = phi_7471_;
                                            let _e4074 = (_e2101 + bitcast<f32>((bitcast<u32>((f32(_e4064) * _e3408)) ^ _e70)));
                                            let _e4088 = (_e2101 + bitcast<f32>((bitcast<u32>((f32(_e4068) * _e3408)) ^ _e70)));
                                            if _e3459 {
                                                phi_7542_ = (((_e3902 - _e2114) / _e3458) * 1023f);
                                            } else {
                                                phi_7542_ = 0f;
                                            }
                                            let _e4106 = phi_7542_;
                                            let _e4108 = select(1023f, _e4106, (_e4106 < 1023f));
                                            let _e4110 = select(0f, _e4108, (_e4108 > 0f));
                                            let _e4115 = select(select(u32(_e4110), 0u, (_e4110 < 0f)), 4294967295u, (_e4110 > 4294967000f));
                                            if (_e4115 > 0u) {
                                                let _e4122 = (_e2114 + bitcast<f32>((bitcast<u32>((f32(_e4115) * _e3523)) ^ _e70)));
                                                let _e4127 = (select(select(_e2151, _e4122, (_e4122 < _e2151)), _e2151, (_e4115 == 1023u)) > _e3902);
                                                if _e4127 {
                                                    phi_7593_ = (_e4115 - 1u);
                                                } else {
                                                    phi_7593_ = u32();
                                                }
                                                let _e4130 = phi_7593_;
                                                phi_7595_ = _e4130;
                                                phi_7596_ = select(true, false, _e4127);
                                            } else {
                                                phi_7595_ = u32();
                                                phi_7596_ = true;
                                            }
                                            let _e4133 = phi_7595_;
                                            let _e4135 = phi_7596_;
                                            if _e4135 {
                                                if (_e4115 < 1023u) {
                                                    let _e4137 = (_e4115 + 1u);
                                                    let _e4143 = (_e2114 + bitcast<f32>((bitcast<u32>((f32(_e4137) * _e3523)) ^ _e70)));
                                                    phi_7634_ = select(_e4115, _e4137, (select(select(_e2151, _e4143, (_e4143 < _e2151)), _e2151, (_e4137 == 1023u)) <= _e3902));
                                                } else {
                                                    phi_7634_ = _e4115;
                                                }
                                                let _e4151 = phi_7634_;
                                                phi_7635_ = _e4151;
                                            } else {
                                                phi_7635_ = _e4133;
                                            }
                                            let _e4153 = phi_7635_;
                                            let _e4159 = (_e2114 + bitcast<f32>((bitcast<u32>((f32(_e4153) * _e3523)) ^ _e70)));
                                            let _e4165 = select(_e4153, 0u, (select(select(_e2151, _e4159, (_e4159 < _e2151)), _e2151, (_e4153 == 1023u)) > _e3902));
                                            if (_e4165 < 1023u) {
                                                phi_7669_ = (_e4165 + 1u);
                                            } else {
                                                phi_7669_ = _e4165;
                                            }
                                            let _e4169 = phi_7669_;
                                            let _e4175 = (_e2114 + bitcast<f32>((bitcast<u32>((f32(_e4165) * _e3523)) ^ _e70)));
                                            let _e4189 = (_e2114 + bitcast<f32>((bitcast<u32>((f32(_e4169) * _e3523)) ^ _e70)));
                                            let _e4207 = global_2.member[_e3213].member_1;
                                            if _e3215 {
                                            } else {
                                                phi_8376_ = true;
                                                break;
                                            }
                                            global_6.member[_e3213] = type_43(array<u32, 3>(((select(_e3308, _e3312, (bitcast<f32>((bitcast<u32>((select(select(_e2125, _e3332, (_e3332 < _e2125)), _e2125, (_e3312 == 1023u)) - _e3220)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3220 - select(select(_e2125, _e3318, (_e3318 < _e2125)), _e2125, (_e3308 == 1023u)))) & 2147483647u)))) | (select(_e3420, _e3424, (bitcast<f32>((bitcast<u32>((select(select(_e2138, _e3444, (_e3444 < _e2138)), _e2138, (_e3424 == 1023u)) - _e3225)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3225 - select(select(_e2138, _e3430, (_e3430 < _e2138)), _e2138, (_e3420 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e3535, _e3539, (bitcast<f32>((bitcast<u32>((select(select(_e2151, _e3559, (_e3559 < _e2151)), _e2151, (_e3539 == 1023u)) - _e3230)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3230 - select(select(_e2151, _e3545, (_e3545 < _e2151)), _e2151, (_e3535 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i))), ((select(_e3651, _e3655, (bitcast<f32>((bitcast<u32>((select(select(_e2125, _e3675, (_e3675 < _e2125)), _e2125, (_e3655 == 1023u)) - _e3577)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3577 - select(select(_e2125, _e3661, (_e3661 < _e2125)), _e2125, (_e3651 == 1023u)))) & 2147483647u)))) | (select(_e3749, _e3753, (bitcast<f32>((bitcast<u32>((select(select(_e2138, _e3773, (_e3773 < _e2138)), _e2138, (_e3753 == 1023u)) - _e3582)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3582 - select(select(_e2138, _e3759, (_e3759 < _e2138)), _e2138, (_e3749 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e3850, _e3854, (bitcast<f32>((bitcast<u32>((select(select(_e2151, _e3874, (_e3874 < _e2151)), _e2151, (_e3854 == 1023u)) - _e3587)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3587 - select(select(_e2151, _e3860, (_e3860 < _e2151)), _e2151, (_e3850 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i))), ((select(_e3966, _e3970, (bitcast<f32>((bitcast<u32>((select(select(_e2125, _e3990, (_e3990 < _e2125)), _e2125, (_e3970 == 1023u)) - _e3892)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3892 - select(select(_e2125, _e3976, (_e3976 < _e2125)), _e2125, (_e3966 == 1023u)))) & 2147483647u)))) | (select(_e4064, _e4068, (bitcast<f32>((bitcast<u32>((select(select(_e2138, _e4088, (_e4088 < _e2138)), _e2138, (_e4068 == 1023u)) - _e3897)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3897 - select(select(_e2138, _e4074, (_e4074 < _e2138)), _e2138, (_e4064 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e4165, _e4169, (bitcast<f32>((bitcast<u32>((select(select(_e2151, _e4189, (_e4189 < _e2151)), _e2151, (_e4169 == 1023u)) - _e3902)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3902 - select(select(_e2151, _e4175, (_e4175 < _e2151)), _e2151, (_e4165 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i)))), _e4207);
                                        }
                                    }
                                }
                                continue;
                                continuing {
                                    phi_5889_ = _e3205;
                                    phi_8376_ = _e3184;
                                    break if !(_e3211);
                                }
                            }
                            let _e4213 = phi_8376_;
                            if _e4213 {
                                break;
                            }
                        }
                        if (_e61 == 0u) {
                            if (_e57 == 0u) {
                            } else {
                                if (0u < _e57) {
                                } else {
                                    break;
                                }
                                global_7.member[0u] = type_32(array<u32, 4>(bitcast<u32>(_e958.member[0]), bitcast<u32>(_e958.member[1]), bitcast<u32>(_e958.member[2]), 0u), array<u32, 4>(bitcast<u32>(_e961.member_1[0]), bitcast<u32>(_e961.member_1[1]), bitcast<u32>(_e961.member_1[2]), 0u));
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
fn encode_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
