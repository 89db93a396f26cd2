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
    var phi_945_: f32;
    var phi_996_: u32;
    var phi_998_: u32;
    var phi_999_: bool;
    var phi_1037_: u32;
    var phi_1038_: u32;
    var phi_1099_: u32;
    var phi_1101_: u32;
    var phi_1102_: bool;
    var phi_1118_: f32;
    var phi_1169_: u32;
    var phi_1171_: u32;
    var phi_1172_: bool;
    var phi_1210_: u32;
    var phi_1211_: u32;
    var phi_1272_: u32;
    var phi_1274_: u32;
    var phi_1275_: bool;
    var phi_1467_: type_41;
    var phi_1468_: u32;
    var phi_258_: type_41;
    var phi_260_: u32;
    var phi_1470_: bool;
    var phi_7529_: bool;
    var phi_1498_: type_31;
    var phi_1520_: type_31;
    var local: type_41;
    var local_1: type_41;
    var phi_1551_: f32;
    var phi_1602_: u32;
    var phi_1604_: u32;
    var phi_1605_: bool;
    var phi_1643_: u32;
    var phi_1644_: u32;
    var phi_1682_: f32;
    var phi_1733_: u32;
    var phi_1735_: u32;
    var phi_1736_: bool;
    var phi_1774_: u32;
    var phi_1775_: u32;
    var phi_1815_: f32;
    var phi_1866_: u32;
    var phi_1868_: u32;
    var phi_1869_: bool;
    var phi_1907_: u32;
    var phi_1908_: u32;
    var phi_1948_: f32;
    var phi_1999_: u32;
    var phi_2001_: u32;
    var phi_2002_: bool;
    var phi_2040_: u32;
    var phi_2041_: u32;
    var phi_2102_: u32;
    var phi_2104_: u32;
    var phi_2105_: bool;
    var phi_2119_: f32;
    var phi_2170_: u32;
    var phi_2172_: u32;
    var phi_2173_: bool;
    var phi_2211_: u32;
    var phi_2212_: u32;
    var phi_2273_: u32;
    var phi_2275_: u32;
    var phi_2276_: bool;
    var phi_2292_: f32;
    var phi_2343_: u32;
    var phi_2345_: u32;
    var phi_2346_: bool;
    var phi_2384_: u32;
    var phi_2385_: u32;
    var phi_2446_: u32;
    var phi_2448_: u32;
    var phi_2449_: bool;
    var phi_2474_: f32;
    var phi_2525_: u32;
    var phi_2527_: u32;
    var phi_2528_: bool;
    var phi_2566_: u32;
    var phi_2567_: u32;
    var phi_2605_: f32;
    var phi_2656_: u32;
    var phi_2658_: u32;
    var phi_2659_: bool;
    var phi_2697_: u32;
    var phi_2698_: u32;
    var phi_2738_: f32;
    var phi_2789_: u32;
    var phi_2791_: u32;
    var phi_2792_: bool;
    var phi_2830_: u32;
    var phi_2831_: u32;
    var phi_2871_: f32;
    var phi_2922_: u32;
    var phi_2924_: u32;
    var phi_2925_: bool;
    var phi_2963_: u32;
    var phi_2964_: u32;
    var phi_3025_: u32;
    var phi_3027_: u32;
    var phi_3028_: bool;
    var phi_3042_: f32;
    var phi_3093_: u32;
    var phi_3095_: u32;
    var phi_3096_: bool;
    var phi_3134_: u32;
    var phi_3135_: u32;
    var phi_3196_: u32;
    var phi_3198_: u32;
    var phi_3199_: bool;
    var phi_3215_: f32;
    var phi_3266_: u32;
    var phi_3268_: u32;
    var phi_3269_: bool;
    var phi_3307_: u32;
    var phi_3308_: u32;
    var phi_3369_: u32;
    var phi_3371_: u32;
    var phi_3372_: bool;
    var phi_3766_: type_4;
    var phi_3767_: type_4;
    var phi_3790_: type_4;
    var phi_3829_: f32;
    var phi_3880_: u32;
    var phi_3882_: u32;
    var phi_3883_: bool;
    var phi_3921_: u32;
    var phi_3922_: u32;
    var phi_3956_: u32;
    var phi_4025_: f32;
    var phi_4076_: u32;
    var phi_4078_: u32;
    var phi_4079_: bool;
    var phi_4117_: u32;
    var phi_4118_: u32;
    var phi_4152_: u32;
    var phi_4223_: f32;
    var phi_4274_: u32;
    var phi_4276_: u32;
    var phi_4277_: bool;
    var phi_4315_: u32;
    var phi_4316_: u32;
    var phi_4350_: u32;
    var phi_4427_: f32;
    var phi_4478_: u32;
    var phi_4480_: u32;
    var phi_4481_: bool;
    var phi_4519_: u32;
    var phi_4520_: u32;
    var phi_4554_: u32;
    var phi_4623_: f32;
    var phi_4674_: u32;
    var phi_4676_: u32;
    var phi_4677_: bool;
    var phi_4715_: u32;
    var phi_4716_: u32;
    var phi_4750_: u32;
    var phi_4821_: f32;
    var phi_4872_: u32;
    var phi_4874_: u32;
    var phi_4875_: bool;
    var phi_4913_: u32;
    var phi_4914_: u32;
    var phi_4948_: u32;
    var phi_5025_: f32;
    var phi_5076_: u32;
    var phi_5078_: u32;
    var phi_5079_: bool;
    var phi_5117_: u32;
    var phi_5118_: u32;
    var phi_5152_: u32;
    var phi_5221_: f32;
    var phi_5272_: u32;
    var phi_5274_: u32;
    var phi_5275_: bool;
    var phi_5313_: u32;
    var phi_5314_: u32;
    var phi_5348_: u32;
    var phi_5419_: f32;
    var phi_5470_: u32;
    var phi_5472_: u32;
    var phi_5473_: bool;
    var phi_5511_: u32;
    var phi_5512_: u32;
    var phi_5546_: u32;
    var phi_7666_: bool;
    var phi_8101_: bool;
    var phi_5637_: type_4;
    var phi_5638_: type_4;
    var phi_5661_: type_4;
    var phi_5700_: f32;
    var phi_5751_: u32;
    var phi_5753_: u32;
    var phi_5754_: bool;
    var phi_5792_: u32;
    var phi_5793_: u32;
    var phi_5827_: u32;
    var phi_5896_: f32;
    var phi_5947_: u32;
    var phi_5949_: u32;
    var phi_5950_: bool;
    var phi_5988_: u32;
    var phi_5989_: u32;
    var phi_6023_: u32;
    var phi_6094_: f32;
    var phi_6145_: u32;
    var phi_6147_: u32;
    var phi_6148_: bool;
    var phi_6186_: u32;
    var phi_6187_: u32;
    var phi_6221_: u32;
    var phi_6298_: f32;
    var phi_6349_: u32;
    var phi_6351_: u32;
    var phi_6352_: bool;
    var phi_6390_: u32;
    var phi_6391_: u32;
    var phi_6425_: u32;
    var phi_6494_: f32;
    var phi_6545_: u32;
    var phi_6547_: u32;
    var phi_6548_: bool;
    var phi_6586_: u32;
    var phi_6587_: u32;
    var phi_6621_: u32;
    var phi_6692_: f32;
    var phi_6743_: u32;
    var phi_6745_: u32;
    var phi_6746_: bool;
    var phi_6784_: u32;
    var phi_6785_: u32;
    var phi_6819_: u32;
    var phi_6896_: f32;
    var phi_6947_: u32;
    var phi_6949_: u32;
    var phi_6950_: bool;
    var phi_6988_: u32;
    var phi_6989_: u32;
    var phi_7023_: u32;
    var phi_7092_: f32;
    var phi_7143_: u32;
    var phi_7145_: u32;
    var phi_7146_: bool;
    var phi_7184_: u32;
    var phi_7185_: u32;
    var phi_7219_: u32;
    var phi_7290_: f32;
    var phi_7341_: u32;
    var phi_7343_: u32;
    var phi_7344_: bool;
    var phi_7382_: u32;
    var phi_7383_: u32;
    var phi_7417_: u32;
    var phi_8097_: bool;

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
                                    phi_1467_ = type_41();
                                    phi_1468_ = u32();
                                } else {
                                    let _e171 = (_e151 < _e49);
                                    if _e171 {
                                        if _e171 {
                                        } else {
                                            phi_7529_ = true;
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
                                    if _e321 {
                                        phi_945_ = (((_e221.member_1.y - _e149.member[1]) / _e320) * 1023f);
                                    } else {
                                        phi_945_ = 0f;
                                    }
                                    let _e571 = phi_945_;
                                    let _e573 = select(1023f, _e571, (_e571 < 1023f));
                                    let _e575 = select(0f, _e573, (_e573 > 0f));
                                    let _e580 = select(select(u32(_e575), 0u, (_e575 < 0f)), 4294967295u, (_e575 > 4294967000f));
                                    if (_e580 > 0u) {
                                        let _e587 = (_e149.member[1] + bitcast<f32>((bitcast<u32>((f32(_e580) * _e385)) ^ _e70)));
                                        let _e592 = (select(select(_e149.member_1[1], _e587, (_e587 < _e149.member_1[1])), _e149.member_1[1], (_e580 == 1023u)) > _e221.member_1.y);
                                        if _e592 {
                                            phi_996_ = (_e580 - 1u);
                                        } else {
                                            phi_996_ = u32();
                                        }
                                        let _e595 = phi_996_;
                                        phi_998_ = _e595;
                                        phi_999_ = select(true, false, _e592);
                                    } else {
                                        phi_998_ = u32();
                                        phi_999_ = true;
                                    }
                                    let _e598 = phi_998_;
                                    let _e600 = phi_999_;
                                    if _e600 {
                                        if (_e580 < 1023u) {
                                            let _e602 = (_e580 + 1u);
                                            let _e608 = (_e149.member[1] + bitcast<f32>((bitcast<u32>((f32(_e602) * _e385)) ^ _e70)));
                                            phi_1037_ = select(_e580, _e602, (select(select(_e149.member_1[1], _e608, (_e608 < _e149.member_1[1])), _e149.member_1[1], (_e602 == 1023u)) <= _e221.member_1.y));
                                        } else {
                                            phi_1037_ = _e580;
                                        }
                                        let _e616 = phi_1037_;
                                        phi_1038_ = _e616;
                                    } else {
                                        phi_1038_ = _e598;
                                    }
                                    let _e618 = phi_1038_;
                                    let _e624 = (_e149.member[1] + bitcast<f32>((bitcast<u32>((f32(_e618) * _e385)) ^ _e70)));
                                    let _e630 = select(_e618, 0u, (select(select(_e149.member_1[1], _e624, (_e624 < _e149.member_1[1])), _e149.member_1[1], (_e618 == 1023u)) > _e221.member_1.y));
                                    if (_e630 < 1023u) {
                                        let _e637 = (_e149.member[1] + bitcast<f32>((bitcast<u32>((f32(_e630) * _e385)) ^ _e70)));
                                        let _e642 = (select(select(_e149.member_1[1], _e637, (_e637 < _e149.member_1[1])), _e149.member_1[1], (_e630 == 1023u)) < _e221.member_1.y);
                                        if _e642 {
                                            phi_1099_ = (_e630 + 1u);
                                        } else {
                                            phi_1099_ = u32();
                                        }
                                        let _e645 = phi_1099_;
                                        phi_1101_ = _e645;
                                        phi_1102_ = select(true, false, _e642);
                                    } else {
                                        phi_1101_ = u32();
                                        phi_1102_ = true;
                                    }
                                    let _e648 = phi_1101_;
                                    let _e650 = phi_1102_;
                                    if _e402 {
                                        phi_1118_ = (((_e221.member_1.z - _e149.member[2]) / _e401) * 1023f);
                                    } else {
                                        phi_1118_ = 0f;
                                    }
                                    let _e659 = phi_1118_;
                                    let _e661 = select(1023f, _e659, (_e659 < 1023f));
                                    let _e663 = select(0f, _e661, (_e661 > 0f));
                                    let _e668 = select(select(u32(_e663), 0u, (_e663 < 0f)), 4294967295u, (_e663 > 4294967000f));
                                    if (_e668 > 0u) {
                                        let _e675 = (_e149.member[2] + bitcast<f32>((bitcast<u32>((f32(_e668) * _e466)) ^ _e70)));
                                        let _e680 = (select(select(_e149.member_1[2], _e675, (_e675 < _e149.member_1[2])), _e149.member_1[2], (_e668 == 1023u)) > _e221.member_1.z);
                                        if _e680 {
                                            phi_1169_ = (_e668 - 1u);
                                        } else {
                                            phi_1169_ = u32();
                                        }
                                        let _e683 = phi_1169_;
                                        phi_1171_ = _e683;
                                        phi_1172_ = select(true, false, _e680);
                                    } else {
                                        phi_1171_ = u32();
                                        phi_1172_ = true;
                                    }
                                    let _e686 = phi_1171_;
                                    let _e688 = phi_1172_;
                                    if _e688 {
                                        if (_e668 < 1023u) {
                                            let _e690 = (_e668 + 1u);
                                            let _e696 = (_e149.member[2] + bitcast<f32>((bitcast<u32>((f32(_e690) * _e466)) ^ _e70)));
                                            phi_1210_ = select(_e668, _e690, (select(select(_e149.member_1[2], _e696, (_e696 < _e149.member_1[2])), _e149.member_1[2], (_e690 == 1023u)) <= _e221.member_1.z));
                                        } else {
                                            phi_1210_ = _e668;
                                        }
                                        let _e704 = phi_1210_;
                                        phi_1211_ = _e704;
                                    } else {
                                        phi_1211_ = _e686;
                                    }
                                    let _e706 = phi_1211_;
                                    let _e712 = (_e149.member[2] + bitcast<f32>((bitcast<u32>((f32(_e706) * _e466)) ^ _e70)));
                                    let _e718 = select(_e706, 0u, (select(select(_e149.member_1[2], _e712, (_e712 < _e149.member_1[2])), _e149.member_1[2], (_e706 == 1023u)) > _e221.member_1.z));
                                    if (_e718 < 1023u) {
                                        let _e725 = (_e149.member[2] + bitcast<f32>((bitcast<u32>((f32(_e718) * _e466)) ^ _e70)));
                                        let _e730 = (select(select(_e149.member_1[2], _e725, (_e725 < _e149.member_1[2])), _e149.member_1[2], (_e718 == 1023u)) < _e221.member_1.z);
                                        if _e730 {
                                            phi_1272_ = (_e718 + 1u);
                                        } else {
                                            phi_1272_ = u32();
                                        }
                                        let _e733 = phi_1272_;
                                        phi_1274_ = _e733;
                                        phi_1275_ = select(true, false, _e730);
                                    } else {
                                        phi_1274_ = u32();
                                        phi_1275_ = true;
                                    }
                                    let _e736 = phi_1274_;
                                    let _e738 = phi_1275_;
                                    let _e742 = ((select(_e563, _e545, _e565) | (select(_e648, _e630, _e650) << bitcast<u32>(10i))) | (select(_e736, _e718, _e738) << bitcast<u32>(20i)));
                                    let _e743 = (_e481 & 1023u);
                                    let _e749 = (_e149.member[0] + bitcast<f32>((bitcast<u32>((f32(_e743) * _e307)) ^ _e70)));
                                    let _e756 = ((_e481 >> bitcast<u32>(10u)) & 1023u);
                                    let _e762 = (_e149.member[1] + bitcast<f32>((bitcast<u32>((f32(_e756) * _e385)) ^ _e70)));
                                    let _e769 = ((_e481 >> bitcast<u32>(20u)) & 1023u);
                                    let _e775 = (_e149.member[2] + bitcast<f32>((bitcast<u32>((f32(_e769) * _e466)) ^ _e70)));
                                    let _e781 = (_e742 & 1023u);
                                    let _e787 = (_e149.member[0] + bitcast<f32>((bitcast<u32>((f32(_e781) * _e307)) ^ _e70)));
                                    let _e794 = ((_e742 >> bitcast<u32>(10u)) & 1023u);
                                    let _e800 = (_e149.member[1] + bitcast<f32>((bitcast<u32>((f32(_e794) * _e385)) ^ _e70)));
                                    let _e807 = ((_e742 >> bitcast<u32>(20u)) & 1023u);
                                    let _e813 = (_e149.member[2] + bitcast<f32>((bitcast<u32>((f32(_e807) * _e466)) ^ _e70)));
                                    phi_1467_ = type_41(array<f32, 3>(select(select(_e149.member_1[0], _e749, (_e749 < _e149.member_1[0])), _e149.member_1[0], (_e743 == 1023u)), select(select(_e149.member_1[1], _e762, (_e762 < _e149.member_1[1])), _e149.member_1[1], (_e756 == 1023u)), select(select(_e149.member_1[2], _e775, (_e775 < _e149.member_1[2])), _e149.member_1[2], (_e769 == 1023u))), array<f32, 3>(select(select(_e149.member_1[0], _e787, (_e787 < _e149.member_1[0])), _e149.member_1[0], (_e781 == 1023u)), select(select(_e149.member_1[1], _e800, (_e800 < _e149.member_1[1])), _e149.member_1[1], (_e794 == 1023u)), select(select(_e149.member_1[2], _e813, (_e813 < _e149.member_1[2])), _e149.member_1[2], (_e807 == 1023u))));
                                    phi_1468_ = select(_e176.member_2, _e176.member_1, _e183);
                                }
                                let _e822 = phi_1467_;
                                let _e824 = phi_1468_;
                                phi_258_ = _e822;
                                phi_260_ = _e824;
                                phi_1470_ = select(true, false, _e170);
                            } else {
                                phi_258_ = type_41();
                                phi_260_ = u32();
                                phi_1470_ = false;
                            }
                            let _e827 = phi_258_;
                            let _e829 = phi_260_;
                            let _e831 = phi_1470_;
                            continue;
                            continuing {
                                phi_254_ = _e164;
                                phi_257_ = _e827;
                                phi_259_ = _e829;
                                phi_7529_ = false;
                                break if !(_e831);
                            }
                        }
                        let _e834 = phi_7529_;
                        if _e834 {
                            break;
                        }
                        if _e66 {
                        } else {
                            break;
                        }
                        let _e838 = global_4.member[_e61].member_1;
                        if (_e838 == 2147483648u) {
                            phi_1498_ = type_31(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            let _e844 = global_4.member[_e61].member[0u];
                            let _e849 = global_4.member[_e61].member[1u];
                            let _e854 = global_4.member[_e61].member[2u];
                            phi_1498_ = type_31(vec3<f32>(_e844[0], _e849[0], _e854[0]), vec3<f32>(_e844[2], _e849[2], _e854[2]));
                        }
                        let _e865 = phi_1498_;
                        let _e869 = global_4.member[_e61].member_2;
                        if (_e869 == 2147483648u) {
                            phi_1520_ = _e865;
                        } else {
                            let _e875 = global_4.member[_e61].member[0u];
                            let _e880 = global_4.member[_e61].member[1u];
                            let _e885 = global_4.member[_e61].member[2u];
                            phi_1520_ = type_31(vec3<f32>(_e875[1], _e880[1], _e885[1]), vec3<f32>(_e875[3], _e880[3], _e885[3]));
                        }
                        let _e896 = phi_1520_;
                        let _e922 = local;
                        let _e925 = local_1;
                        let _e933 = (_e925.member_1[0] - _e922.member[0]);
                        let _e934 = (_e933 > 0f);
                        if _e934 {
                            phi_1551_ = (((_e865.member.x - _e922.member[0]) / _e933) * 1023f);
                        } else {
                            phi_1551_ = 0f;
                        }
                        let _e939 = phi_1551_;
                        let _e941 = select(1023f, _e939, (_e939 < 1023f));
                        let _e943 = select(0f, _e941, (_e941 > 0f));
                        let _e948 = select(select(u32(_e943), 0u, (_e943 < 0f)), 4294967295u, (_e943 > 4294967000f));
                        if (_e948 > 0u) {
                            let _e959 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e948) * bitcast<f32>((bitcast<u32>((_e933 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                            let _e964 = (select(select(_e925.member_1[0], _e959, (_e959 < _e925.member_1[0])), _e925.member_1[0], (_e948 == 1023u)) > _e865.member.x);
                            if _e964 {
                                phi_1602_ = (_e948 - 1u);
                            } else {
                                phi_1602_ = u32();
                            }
                            let _e967 = phi_1602_;
                            phi_1604_ = _e967;
                            phi_1605_ = select(true, false, _e964);
                        } else {
                            phi_1604_ = u32();
                            phi_1605_ = true;
                        }
                        let _e970 = phi_1604_;
                        let _e972 = phi_1605_;
                        if _e972 {
                            if (_e948 < 1023u) {
                                let _e974 = (_e948 + 1u);
                                let _e984 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e974) * bitcast<f32>((bitcast<u32>((_e933 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                phi_1643_ = select(_e948, _e974, (select(select(_e925.member_1[0], _e984, (_e984 < _e925.member_1[0])), _e925.member_1[0], (_e974 == 1023u)) <= _e865.member.x));
                            } else {
                                phi_1643_ = _e948;
                            }
                            let _e992 = phi_1643_;
                            phi_1644_ = _e992;
                        } else {
                            phi_1644_ = _e970;
                        }
                        let _e994 = phi_1644_;
                        let _e998 = bitcast<f32>((bitcast<u32>((_e933 * 0.0009775171f)) ^ _e70));
                        let _e1004 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e994) * _e998)) ^ _e70)));
                        let _e1011 = (_e925.member_1[1] - _e922.member[1]);
                        let _e1012 = (_e1011 > 0f);
                        if _e1012 {
                            phi_1682_ = (((_e865.member.y - _e922.member[1]) / _e1011) * 1023f);
                        } else {
                            phi_1682_ = 0f;
                        }
                        let _e1017 = phi_1682_;
                        let _e1019 = select(1023f, _e1017, (_e1017 < 1023f));
                        let _e1021 = select(0f, _e1019, (_e1019 > 0f));
                        let _e1026 = select(select(u32(_e1021), 0u, (_e1021 < 0f)), 4294967295u, (_e1021 > 4294967000f));
                        if (_e1026 > 0u) {
                            let _e1037 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1026) * bitcast<f32>((bitcast<u32>((_e1011 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                            let _e1042 = (select(select(_e925.member_1[1], _e1037, (_e1037 < _e925.member_1[1])), _e925.member_1[1], (_e1026 == 1023u)) > _e865.member.y);
                            if _e1042 {
                                phi_1733_ = (_e1026 - 1u);
                            } else {
                                phi_1733_ = u32();
                            }
                            let _e1045 = phi_1733_;
                            phi_1735_ = _e1045;
                            phi_1736_ = select(true, false, _e1042);
                        } else {
                            phi_1735_ = u32();
                            phi_1736_ = true;
                        }
                        let _e1048 = phi_1735_;
                        let _e1050 = phi_1736_;
                        if _e1050 {
                            if (_e1026 < 1023u) {
                                let _e1052 = (_e1026 + 1u);
                                let _e1062 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1052) * bitcast<f32>((bitcast<u32>((_e1011 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                phi_1774_ = select(_e1026, _e1052, (select(select(_e925.member_1[1], _e1062, (_e1062 < _e925.member_1[1])), _e925.member_1[1], (_e1052 == 1023u)) <= _e865.member.y));
                            } else {
                                phi_1774_ = _e1026;
                            }
                            let _e1070 = phi_1774_;
                            phi_1775_ = _e1070;
                        } else {
                            phi_1775_ = _e1048;
                        }
                        let _e1072 = phi_1775_;
                        let _e1076 = bitcast<f32>((bitcast<u32>((_e1011 * 0.0009775171f)) ^ _e70));
                        let _e1082 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1072) * _e1076)) ^ _e70)));
                        let _e1092 = (_e925.member_1[2] - _e922.member[2]);
                        let _e1093 = (_e1092 > 0f);
                        if _e1093 {
                            phi_1815_ = (((_e865.member.z - _e922.member[2]) / _e1092) * 1023f);
                        } else {
                            phi_1815_ = 0f;
                        }
                        let _e1098 = phi_1815_;
                        let _e1100 = select(1023f, _e1098, (_e1098 < 1023f));
                        let _e1102 = select(0f, _e1100, (_e1100 > 0f));
                        let _e1107 = select(select(u32(_e1102), 0u, (_e1102 < 0f)), 4294967295u, (_e1102 > 4294967000f));
                        if (_e1107 > 0u) {
                            let _e1118 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1107) * bitcast<f32>((bitcast<u32>((_e1092 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                            let _e1123 = (select(select(_e925.member_1[2], _e1118, (_e1118 < _e925.member_1[2])), _e925.member_1[2], (_e1107 == 1023u)) > _e865.member.z);
                            if _e1123 {
                                phi_1866_ = (_e1107 - 1u);
                            } else {
                                phi_1866_ = u32();
                            }
                            let _e1126 = phi_1866_;
                            phi_1868_ = _e1126;
                            phi_1869_ = select(true, false, _e1123);
                        } else {
                            phi_1868_ = u32();
                            phi_1869_ = true;
                        }
                        let _e1129 = phi_1868_;
                        let _e1131 = phi_1869_;
                        if _e1131 {
                            if (_e1107 < 1023u) {
                                let _e1133 = (_e1107 + 1u);
                                let _e1143 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1133) * bitcast<f32>((bitcast<u32>((_e1092 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                phi_1907_ = select(_e1107, _e1133, (select(select(_e925.member_1[2], _e1143, (_e1143 < _e925.member_1[2])), _e925.member_1[2], (_e1133 == 1023u)) <= _e865.member.z));
                            } else {
                                phi_1907_ = _e1107;
                            }
                            let _e1151 = phi_1907_;
                            phi_1908_ = _e1151;
                        } else {
                            phi_1908_ = _e1129;
                        }
                        let _e1153 = phi_1908_;
                        let _e1157 = bitcast<f32>((bitcast<u32>((_e1092 * 0.0009775171f)) ^ _e70));
                        let _e1163 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1153) * _e1157)) ^ _e70)));
                        let _e1172 = ((select(_e994, 0u, (select(select(_e925.member_1[0], _e1004, (_e1004 < _e925.member_1[0])), _e925.member_1[0], (_e994 == 1023u)) > _e865.member.x)) | (select(_e1072, 0u, (select(select(_e925.member_1[1], _e1082, (_e1082 < _e925.member_1[1])), _e925.member_1[1], (_e1072 == 1023u)) > _e865.member.y)) << bitcast<u32>(10i))) | (select(_e1153, 0u, (select(select(_e925.member_1[2], _e1163, (_e1163 < _e925.member_1[2])), _e925.member_1[2], (_e1153 == 1023u)) > _e865.member.z)) << bitcast<u32>(20i)));
                        if _e934 {
                            phi_1948_ = (((_e865.member_1.x - _e922.member[0]) / _e933) * 1023f);
                        } else {
                            phi_1948_ = 0f;
                        }
                        let _e1177 = phi_1948_;
                        let _e1179 = select(1023f, _e1177, (_e1177 < 1023f));
                        let _e1181 = select(0f, _e1179, (_e1179 > 0f));
                        let _e1186 = select(select(u32(_e1181), 0u, (_e1181 < 0f)), 4294967295u, (_e1181 > 4294967000f));
                        if (_e1186 > 0u) {
                            let _e1193 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1186) * _e998)) ^ _e70)));
                            let _e1198 = (select(select(_e925.member_1[0], _e1193, (_e1193 < _e925.member_1[0])), _e925.member_1[0], (_e1186 == 1023u)) > _e865.member_1.x);
                            if _e1198 {
                                phi_1999_ = (_e1186 - 1u);
                            } else {
                                phi_1999_ = u32();
                            }
                            let _e1201 = phi_1999_;
                            phi_2001_ = _e1201;
                            phi_2002_ = select(true, false, _e1198);
                        } else {
                            phi_2001_ = u32();
                            phi_2002_ = true;
                        }
                        let _e1204 = phi_2001_;
                        let _e1206 = phi_2002_;
                        if _e1206 {
                            if (_e1186 < 1023u) {
                                let _e1208 = (_e1186 + 1u);
                                let _e1214 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1208) * _e998)) ^ _e70)));
                                phi_2040_ = select(_e1186, _e1208, (select(select(_e925.member_1[0], _e1214, (_e1214 < _e925.member_1[0])), _e925.member_1[0], (_e1208 == 1023u)) <= _e865.member_1.x));
                            } else {
                                phi_2040_ = _e1186;
                            }
                            let _e1222 = phi_2040_;
                            phi_2041_ = _e1222;
                        } else {
                            phi_2041_ = _e1204;
                        }
                        let _e1224 = phi_2041_;
                        let _e1230 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1224) * _e998)) ^ _e70)));
                        let _e1236 = select(_e1224, 0u, (select(select(_e925.member_1[0], _e1230, (_e1230 < _e925.member_1[0])), _e925.member_1[0], (_e1224 == 1023u)) > _e865.member_1.x));
                        if (_e1236 < 1023u) {
                            let _e1243 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1236) * _e998)) ^ _e70)));
                            let _e1248 = (select(select(_e925.member_1[0], _e1243, (_e1243 < _e925.member_1[0])), _e925.member_1[0], (_e1236 == 1023u)) < _e865.member_1.x);
                            if _e1248 {
                                phi_2102_ = (_e1236 + 1u);
                            } else {
                                phi_2102_ = u32();
                            }
                            let _e1251 = phi_2102_;
                            phi_2104_ = _e1251;
                            phi_2105_ = select(true, false, _e1248);
                        } else {
                            phi_2104_ = u32();
                            phi_2105_ = true;
                        }
                        let _e1254 = phi_2104_;
                        let _e1256 = phi_2105_;
                        if _e1012 {
                            phi_2119_ = (((_e865.member_1.y - _e922.member[1]) / _e1011) * 1023f);
                        } else {
                            phi_2119_ = 0f;
                        }
                        let _e1262 = phi_2119_;
                        let _e1264 = select(1023f, _e1262, (_e1262 < 1023f));
                        let _e1266 = select(0f, _e1264, (_e1264 > 0f));
                        let _e1271 = select(select(u32(_e1266), 0u, (_e1266 < 0f)), 4294967295u, (_e1266 > 4294967000f));
                        if (_e1271 > 0u) {
                            let _e1278 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1271) * _e1076)) ^ _e70)));
                            let _e1283 = (select(select(_e925.member_1[1], _e1278, (_e1278 < _e925.member_1[1])), _e925.member_1[1], (_e1271 == 1023u)) > _e865.member_1.y);
                            if _e1283 {
                                phi_2170_ = (_e1271 - 1u);
                            } else {
                                phi_2170_ = u32();
                            }
                            let _e1286 = phi_2170_;
                            phi_2172_ = _e1286;
                            phi_2173_ = select(true, false, _e1283);
                        } else {
                            phi_2172_ = u32();
                            phi_2173_ = true;
                        }
                        let _e1289 = phi_2172_;
                        let _e1291 = phi_2173_;
                        if _e1291 {
                            if (_e1271 < 1023u) {
                                let _e1293 = (_e1271 + 1u);
                                let _e1299 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1293) * _e1076)) ^ _e70)));
                                phi_2211_ = select(_e1271, _e1293, (select(select(_e925.member_1[1], _e1299, (_e1299 < _e925.member_1[1])), _e925.member_1[1], (_e1293 == 1023u)) <= _e865.member_1.y));
                            } else {
                                phi_2211_ = _e1271;
                            }
                            let _e1307 = phi_2211_;
                            phi_2212_ = _e1307;
                        } else {
                            phi_2212_ = _e1289;
                        }
                        let _e1309 = phi_2212_;
                        let _e1315 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1309) * _e1076)) ^ _e70)));
                        let _e1321 = select(_e1309, 0u, (select(select(_e925.member_1[1], _e1315, (_e1315 < _e925.member_1[1])), _e925.member_1[1], (_e1309 == 1023u)) > _e865.member_1.y));
                        if (_e1321 < 1023u) {
                            let _e1328 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1321) * _e1076)) ^ _e70)));
                            let _e1333 = (select(select(_e925.member_1[1], _e1328, (_e1328 < _e925.member_1[1])), _e925.member_1[1], (_e1321 == 1023u)) < _e865.member_1.y);
                            if _e1333 {
                                phi_2273_ = (_e1321 + 1u);
                            } else {
                                phi_2273_ = u32();
                            }
                            let _e1336 = phi_2273_;
                            phi_2275_ = _e1336;
                            phi_2276_ = select(true, false, _e1333);
                        } else {
                            phi_2275_ = u32();
                            phi_2276_ = true;
                        }
                        let _e1339 = phi_2275_;
                        let _e1341 = phi_2276_;
                        if _e1093 {
                            phi_2292_ = (((_e865.member_1.z - _e922.member[2]) / _e1092) * 1023f);
                        } else {
                            phi_2292_ = 0f;
                        }
                        let _e1350 = phi_2292_;
                        let _e1352 = select(1023f, _e1350, (_e1350 < 1023f));
                        let _e1354 = select(0f, _e1352, (_e1352 > 0f));
                        let _e1359 = select(select(u32(_e1354), 0u, (_e1354 < 0f)), 4294967295u, (_e1354 > 4294967000f));
                        if (_e1359 > 0u) {
                            let _e1366 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1359) * _e1157)) ^ _e70)));
                            let _e1371 = (select(select(_e925.member_1[2], _e1366, (_e1366 < _e925.member_1[2])), _e925.member_1[2], (_e1359 == 1023u)) > _e865.member_1.z);
                            if _e1371 {
                                phi_2343_ = (_e1359 - 1u);
                            } else {
                                phi_2343_ = u32();
                            }
                            let _e1374 = phi_2343_;
                            phi_2345_ = _e1374;
                            phi_2346_ = select(true, false, _e1371);
                        } else {
                            phi_2345_ = u32();
                            phi_2346_ = true;
                        }
                        let _e1377 = phi_2345_;
                        let _e1379 = phi_2346_;
                        if _e1379 {
                            if (_e1359 < 1023u) {
                                let _e1381 = (_e1359 + 1u);
                                let _e1387 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1381) * _e1157)) ^ _e70)));
                                phi_2384_ = select(_e1359, _e1381, (select(select(_e925.member_1[2], _e1387, (_e1387 < _e925.member_1[2])), _e925.member_1[2], (_e1381 == 1023u)) <= _e865.member_1.z));
                            } else {
                                phi_2384_ = _e1359;
                            }
                            let _e1395 = phi_2384_;
                            phi_2385_ = _e1395;
                        } else {
                            phi_2385_ = _e1377;
                        }
                        let _e1397 = phi_2385_;
                        let _e1403 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1397) * _e1157)) ^ _e70)));
                        let _e1409 = select(_e1397, 0u, (select(select(_e925.member_1[2], _e1403, (_e1403 < _e925.member_1[2])), _e925.member_1[2], (_e1397 == 1023u)) > _e865.member_1.z));
                        if (_e1409 < 1023u) {
                            let _e1416 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1409) * _e1157)) ^ _e70)));
                            let _e1421 = (select(select(_e925.member_1[2], _e1416, (_e1416 < _e925.member_1[2])), _e925.member_1[2], (_e1409 == 1023u)) < _e865.member_1.z);
                            if _e1421 {
                                phi_2446_ = (_e1409 + 1u);
                            } else {
                                phi_2446_ = u32();
                            }
                            let _e1424 = phi_2446_;
                            phi_2448_ = _e1424;
                            phi_2449_ = select(true, false, _e1421);
                        } else {
                            phi_2448_ = u32();
                            phi_2449_ = true;
                        }
                        let _e1427 = phi_2448_;
                        let _e1429 = phi_2449_;
                        let _e1433 = ((select(_e1254, _e1236, _e1256) | (select(_e1339, _e1321, _e1341) << bitcast<u32>(10i))) | (select(_e1427, _e1409, _e1429) << bitcast<u32>(20i)));
                        if _e934 {
                            phi_2474_ = (((_e896.member.x - _e922.member[0]) / _e933) * 1023f);
                        } else {
                            phi_2474_ = 0f;
                        }
                        let _e1439 = phi_2474_;
                        let _e1441 = select(1023f, _e1439, (_e1439 < 1023f));
                        let _e1443 = select(0f, _e1441, (_e1441 > 0f));
                        let _e1448 = select(select(u32(_e1443), 0u, (_e1443 < 0f)), 4294967295u, (_e1443 > 4294967000f));
                        if (_e1448 > 0u) {
                            let _e1455 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1448) * _e998)) ^ _e70)));
                            let _e1460 = (select(select(_e925.member_1[0], _e1455, (_e1455 < _e925.member_1[0])), _e925.member_1[0], (_e1448 == 1023u)) > _e896.member.x);
                            if _e1460 {
                                phi_2525_ = (_e1448 - 1u);
                            } else {
                                phi_2525_ = u32();
                            }
                            let _e1463 = phi_2525_;
                            phi_2527_ = _e1463;
                            phi_2528_ = select(true, false, _e1460);
                        } else {
                            phi_2527_ = u32();
                            phi_2528_ = true;
                        }
                        let _e1466 = phi_2527_;
                        let _e1468 = phi_2528_;
                        if _e1468 {
                            if (_e1448 < 1023u) {
                                let _e1470 = (_e1448 + 1u);
                                let _e1476 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1470) * _e998)) ^ _e70)));
                                phi_2566_ = select(_e1448, _e1470, (select(select(_e925.member_1[0], _e1476, (_e1476 < _e925.member_1[0])), _e925.member_1[0], (_e1470 == 1023u)) <= _e896.member.x));
                            } else {
                                phi_2566_ = _e1448;
                            }
                            let _e1484 = phi_2566_;
                            phi_2567_ = _e1484;
                        } else {
                            phi_2567_ = _e1466;
                        }
                        let _e1486 = phi_2567_;
                        let _e1492 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1486) * _e998)) ^ _e70)));
                        if _e1012 {
                            phi_2605_ = (((_e896.member.y - _e922.member[1]) / _e1011) * 1023f);
                        } else {
                            phi_2605_ = 0f;
                        }
                        let _e1503 = phi_2605_;
                        let _e1505 = select(1023f, _e1503, (_e1503 < 1023f));
                        let _e1507 = select(0f, _e1505, (_e1505 > 0f));
                        let _e1512 = select(select(u32(_e1507), 0u, (_e1507 < 0f)), 4294967295u, (_e1507 > 4294967000f));
                        if (_e1512 > 0u) {
                            let _e1519 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1512) * _e1076)) ^ _e70)));
                            let _e1524 = (select(select(_e925.member_1[1], _e1519, (_e1519 < _e925.member_1[1])), _e925.member_1[1], (_e1512 == 1023u)) > _e896.member.y);
                            if _e1524 {
                                phi_2656_ = (_e1512 - 1u);
                            } else {
                                phi_2656_ = u32();
                            }
                            let _e1527 = phi_2656_;
                            phi_2658_ = _e1527;
                            phi_2659_ = select(true, false, _e1524);
                        } else {
                            phi_2658_ = u32();
                            phi_2659_ = true;
                        }
                        let _e1530 = phi_2658_;
                        let _e1532 = phi_2659_;
                        if _e1532 {
                            if (_e1512 < 1023u) {
                                let _e1534 = (_e1512 + 1u);
                                let _e1540 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1534) * _e1076)) ^ _e70)));
                                phi_2697_ = select(_e1512, _e1534, (select(select(_e925.member_1[1], _e1540, (_e1540 < _e925.member_1[1])), _e925.member_1[1], (_e1534 == 1023u)) <= _e896.member.y));
                            } else {
                                phi_2697_ = _e1512;
                            }
                            let _e1548 = phi_2697_;
                            phi_2698_ = _e1548;
                        } else {
                            phi_2698_ = _e1530;
                        }
                        let _e1550 = phi_2698_;
                        let _e1556 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1550) * _e1076)) ^ _e70)));
                        if _e1093 {
                            phi_2738_ = (((_e896.member.z - _e922.member[2]) / _e1092) * 1023f);
                        } else {
                            phi_2738_ = 0f;
                        }
                        let _e1570 = phi_2738_;
                        let _e1572 = select(1023f, _e1570, (_e1570 < 1023f));
                        let _e1574 = select(0f, _e1572, (_e1572 > 0f));
                        let _e1579 = select(select(u32(_e1574), 0u, (_e1574 < 0f)), 4294967295u, (_e1574 > 4294967000f));
                        if (_e1579 > 0u) {
                            let _e1586 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1579) * _e1157)) ^ _e70)));
                            let _e1591 = (select(select(_e925.member_1[2], _e1586, (_e1586 < _e925.member_1[2])), _e925.member_1[2], (_e1579 == 1023u)) > _e896.member.z);
                            if _e1591 {
                                phi_2789_ = (_e1579 - 1u);
                            } else {
                                phi_2789_ = u32();
                            }
                            let _e1594 = phi_2789_;
                            phi_2791_ = _e1594;
                            phi_2792_ = select(true, false, _e1591);
                        } else {
                            phi_2791_ = u32();
                            phi_2792_ = true;
                        }
                        let _e1597 = phi_2791_;
                        let _e1599 = phi_2792_;
                        if _e1599 {
                            if (_e1579 < 1023u) {
                                let _e1601 = (_e1579 + 1u);
                                let _e1607 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1601) * _e1157)) ^ _e70)));
                                phi_2830_ = select(_e1579, _e1601, (select(select(_e925.member_1[2], _e1607, (_e1607 < _e925.member_1[2])), _e925.member_1[2], (_e1601 == 1023u)) <= _e896.member.z));
                            } else {
                                phi_2830_ = _e1579;
                            }
                            let _e1615 = phi_2830_;
                            phi_2831_ = _e1615;
                        } else {
                            phi_2831_ = _e1597;
                        }
                        let _e1617 = phi_2831_;
                        let _e1623 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1617) * _e1157)) ^ _e70)));
                        let _e1632 = ((select(_e1486, 0u, (select(select(_e925.member_1[0], _e1492, (_e1492 < _e925.member_1[0])), _e925.member_1[0], (_e1486 == 1023u)) > _e896.member.x)) | (select(_e1550, 0u, (select(select(_e925.member_1[1], _e1556, (_e1556 < _e925.member_1[1])), _e925.member_1[1], (_e1550 == 1023u)) > _e896.member.y)) << bitcast<u32>(10i))) | (select(_e1617, 0u, (select(select(_e925.member_1[2], _e1623, (_e1623 < _e925.member_1[2])), _e925.member_1[2], (_e1617 == 1023u)) > _e896.member.z)) << bitcast<u32>(20i)));
                        if _e934 {
                            phi_2871_ = (((_e896.member_1.x - _e922.member[0]) / _e933) * 1023f);
                        } else {
                            phi_2871_ = 0f;
                        }
                        let _e1637 = phi_2871_;
                        let _e1639 = select(1023f, _e1637, (_e1637 < 1023f));
                        let _e1641 = select(0f, _e1639, (_e1639 > 0f));
                        let _e1646 = select(select(u32(_e1641), 0u, (_e1641 < 0f)), 4294967295u, (_e1641 > 4294967000f));
                        if (_e1646 > 0u) {
                            let _e1653 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1646) * _e998)) ^ _e70)));
                            let _e1658 = (select(select(_e925.member_1[0], _e1653, (_e1653 < _e925.member_1[0])), _e925.member_1[0], (_e1646 == 1023u)) > _e896.member_1.x);
                            if _e1658 {
                                phi_2922_ = (_e1646 - 1u);
                            } else {
                                phi_2922_ = u32();
                            }
                            let _e1661 = phi_2922_;
                            phi_2924_ = _e1661;
                            phi_2925_ = select(true, false, _e1658);
                        } else {
                            phi_2924_ = u32();
                            phi_2925_ = true;
                        }
                        let _e1664 = phi_2924_;
                        let _e1666 = phi_2925_;
                        if _e1666 {
                            if (_e1646 < 1023u) {
                                let _e1668 = (_e1646 + 1u);
                                let _e1674 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1668) * _e998)) ^ _e70)));
                                phi_2963_ = select(_e1646, _e1668, (select(select(_e925.member_1[0], _e1674, (_e1674 < _e925.member_1[0])), _e925.member_1[0], (_e1668 == 1023u)) <= _e896.member_1.x));
                            } else {
                                phi_2963_ = _e1646;
                            }
                            let _e1682 = phi_2963_;
                            phi_2964_ = _e1682;
                        } else {
                            phi_2964_ = _e1664;
                        }
                        let _e1684 = phi_2964_;
                        let _e1690 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1684) * _e998)) ^ _e70)));
                        let _e1696 = select(_e1684, 0u, (select(select(_e925.member_1[0], _e1690, (_e1690 < _e925.member_1[0])), _e925.member_1[0], (_e1684 == 1023u)) > _e896.member_1.x));
                        if (_e1696 < 1023u) {
                            let _e1703 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1696) * _e998)) ^ _e70)));
                            let _e1708 = (select(select(_e925.member_1[0], _e1703, (_e1703 < _e925.member_1[0])), _e925.member_1[0], (_e1696 == 1023u)) < _e896.member_1.x);
                            if _e1708 {
                                phi_3025_ = (_e1696 + 1u);
                            } else {
                                phi_3025_ = u32();
                            }
                            let _e1711 = phi_3025_;
                            phi_3027_ = _e1711;
                            phi_3028_ = select(true, false, _e1708);
                        } else {
                            phi_3027_ = u32();
                            phi_3028_ = true;
                        }
                        let _e1714 = phi_3027_;
                        let _e1716 = phi_3028_;
                        if _e1012 {
                            phi_3042_ = (((_e896.member_1.y - _e922.member[1]) / _e1011) * 1023f);
                        } else {
                            phi_3042_ = 0f;
                        }
                        let _e1722 = phi_3042_;
                        let _e1724 = select(1023f, _e1722, (_e1722 < 1023f));
                        let _e1726 = select(0f, _e1724, (_e1724 > 0f));
                        let _e1731 = select(select(u32(_e1726), 0u, (_e1726 < 0f)), 4294967295u, (_e1726 > 4294967000f));
                        if (_e1731 > 0u) {
                            let _e1738 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1731) * _e1076)) ^ _e70)));
                            let _e1743 = (select(select(_e925.member_1[1], _e1738, (_e1738 < _e925.member_1[1])), _e925.member_1[1], (_e1731 == 1023u)) > _e896.member_1.y);
                            if _e1743 {
                                phi_3093_ = (_e1731 - 1u);
                            } else {
                                phi_3093_ = u32();
                            }
                            let _e1746 = phi_3093_;
                            phi_3095_ = _e1746;
                            phi_3096_ = select(true, false, _e1743);
                        } else {
                            phi_3095_ = u32();
                            phi_3096_ = true;
                        }
                        let _e1749 = phi_3095_;
                        let _e1751 = phi_3096_;
                        if _e1751 {
                            if (_e1731 < 1023u) {
                                let _e1753 = (_e1731 + 1u);
                                let _e1759 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1753) * _e1076)) ^ _e70)));
                                phi_3134_ = select(_e1731, _e1753, (select(select(_e925.member_1[1], _e1759, (_e1759 < _e925.member_1[1])), _e925.member_1[1], (_e1753 == 1023u)) <= _e896.member_1.y));
                            } else {
                                phi_3134_ = _e1731;
                            }
                            let _e1767 = phi_3134_;
                            phi_3135_ = _e1767;
                        } else {
                            phi_3135_ = _e1749;
                        }
                        let _e1769 = phi_3135_;
                        let _e1775 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1769) * _e1076)) ^ _e70)));
                        let _e1781 = select(_e1769, 0u, (select(select(_e925.member_1[1], _e1775, (_e1775 < _e925.member_1[1])), _e925.member_1[1], (_e1769 == 1023u)) > _e896.member_1.y));
                        if (_e1781 < 1023u) {
                            let _e1788 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1781) * _e1076)) ^ _e70)));
                            let _e1793 = (select(select(_e925.member_1[1], _e1788, (_e1788 < _e925.member_1[1])), _e925.member_1[1], (_e1781 == 1023u)) < _e896.member_1.y);
                            if _e1793 {
                                phi_3196_ = (_e1781 + 1u);
                            } else {
                                phi_3196_ = u32();
                            }
                            let _e1796 = phi_3196_;
                            phi_3198_ = _e1796;
                            phi_3199_ = select(true, false, _e1793);
                        } else {
                            phi_3198_ = u32();
                            phi_3199_ = true;
                        }
                        let _e1799 = phi_3198_;
                        let _e1801 = phi_3199_;
                        if _e1093 {
                            phi_3215_ = (((_e896.member_1.z - _e922.member[2]) / _e1092) * 1023f);
                        } else {
                            phi_3215_ = 0f;
                        }
                        let _e1810 = phi_3215_;
                        let _e1812 = select(1023f, _e1810, (_e1810 < 1023f));
                        let _e1814 = select(0f, _e1812, (_e1812 > 0f));
                        let _e1819 = select(select(u32(_e1814), 0u, (_e1814 < 0f)), 4294967295u, (_e1814 > 4294967000f));
                        if (_e1819 > 0u) {
                            let _e1826 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1819) * _e1157)) ^ _e70)));
                            let _e1831 = (select(select(_e925.member_1[2], _e1826, (_e1826 < _e925.member_1[2])), _e925.member_1[2], (_e1819 == 1023u)) > _e896.member_1.z);
                            if _e1831 {
                                phi_3266_ = (_e1819 - 1u);
                            } else {
                                phi_3266_ = u32();
                            }
                            let _e1834 = phi_3266_;
                            phi_3268_ = _e1834;
                            phi_3269_ = select(true, false, _e1831);
                        } else {
                            phi_3268_ = u32();
                            phi_3269_ = true;
                        }
                        let _e1837 = phi_3268_;
                        let _e1839 = phi_3269_;
                        if _e1839 {
                            if (_e1819 < 1023u) {
                                let _e1841 = (_e1819 + 1u);
                                let _e1847 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1841) * _e1157)) ^ _e70)));
                                phi_3307_ = select(_e1819, _e1841, (select(select(_e925.member_1[2], _e1847, (_e1847 < _e925.member_1[2])), _e925.member_1[2], (_e1841 == 1023u)) <= _e896.member_1.z));
                            } else {
                                phi_3307_ = _e1819;
                            }
                            let _e1855 = phi_3307_;
                            phi_3308_ = _e1855;
                        } else {
                            phi_3308_ = _e1837;
                        }
                        let _e1857 = phi_3308_;
                        let _e1863 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1857) * _e1157)) ^ _e70)));
                        let _e1869 = select(_e1857, 0u, (select(select(_e925.member_1[2], _e1863, (_e1863 < _e925.member_1[2])), _e925.member_1[2], (_e1857 == 1023u)) > _e896.member_1.z));
                        if (_e1869 < 1023u) {
                            let _e1876 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1869) * _e1157)) ^ _e70)));
                            let _e1881 = (select(select(_e925.member_1[2], _e1876, (_e1876 < _e925.member_1[2])), _e925.member_1[2], (_e1869 == 1023u)) < _e896.member_1.z);
                            if _e1881 {
                                phi_3369_ = (_e1869 + 1u);
                            } else {
                                phi_3369_ = u32();
                            }
                            let _e1884 = phi_3369_;
                            phi_3371_ = _e1884;
                            phi_3372_ = select(true, false, _e1881);
                        } else {
                            phi_3371_ = u32();
                            phi_3372_ = true;
                        }
                        let _e1887 = phi_3371_;
                        let _e1889 = phi_3372_;
                        let _e1893 = ((select(_e1714, _e1696, _e1716) | (select(_e1799, _e1781, _e1801) << bitcast<u32>(10i))) | (select(_e1887, _e1869, _e1889) << bitcast<u32>(20i)));
                        let _e1896 = (_e1172 & 1023u);
                        let _e1902 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1896) * _e998)) ^ _e70)));
                        let _e1906 = select(select(_e925.member_1[0], _e1902, (_e1902 < _e925.member_1[0])), _e925.member_1[0], (_e1896 == 1023u));
                        let _e1909 = ((_e1172 >> bitcast<u32>(10u)) & 1023u);
                        let _e1915 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1909) * _e1076)) ^ _e70)));
                        let _e1919 = select(select(_e925.member_1[1], _e1915, (_e1915 < _e925.member_1[1])), _e925.member_1[1], (_e1909 == 1023u));
                        let _e1922 = ((_e1172 >> bitcast<u32>(20u)) & 1023u);
                        let _e1928 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1922) * _e1157)) ^ _e70)));
                        let _e1932 = select(select(_e925.member_1[2], _e1928, (_e1928 < _e925.member_1[2])), _e925.member_1[2], (_e1922 == 1023u));
                        let _e1933 = (_e1433 & 1023u);
                        let _e1939 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1933) * _e998)) ^ _e70)));
                        let _e1943 = select(select(_e925.member_1[0], _e1939, (_e1939 < _e925.member_1[0])), _e925.member_1[0], (_e1933 == 1023u));
                        let _e1946 = ((_e1433 >> bitcast<u32>(10u)) & 1023u);
                        let _e1952 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1946) * _e1076)) ^ _e70)));
                        let _e1956 = select(select(_e925.member_1[1], _e1952, (_e1952 < _e925.member_1[1])), _e925.member_1[1], (_e1946 == 1023u));
                        let _e1959 = ((_e1433 >> bitcast<u32>(20u)) & 1023u);
                        let _e1965 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1959) * _e1157)) ^ _e70)));
                        let _e1969 = select(select(_e925.member_1[2], _e1965, (_e1965 < _e925.member_1[2])), _e925.member_1[2], (_e1959 == 1023u));
                        let _e1970 = (_e1632 & 1023u);
                        let _e1976 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1970) * _e998)) ^ _e70)));
                        let _e1980 = select(select(_e925.member_1[0], _e1976, (_e1976 < _e925.member_1[0])), _e925.member_1[0], (_e1970 == 1023u));
                        let _e1983 = ((_e1632 >> bitcast<u32>(10u)) & 1023u);
                        let _e1989 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1983) * _e1076)) ^ _e70)));
                        let _e1993 = select(select(_e925.member_1[1], _e1989, (_e1989 < _e925.member_1[1])), _e925.member_1[1], (_e1983 == 1023u));
                        let _e1996 = ((_e1632 >> bitcast<u32>(20u)) & 1023u);
                        let _e2002 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1996) * _e1157)) ^ _e70)));
                        let _e2006 = select(select(_e925.member_1[2], _e2002, (_e2002 < _e925.member_1[2])), _e925.member_1[2], (_e1996 == 1023u));
                        let _e2007 = (_e1893 & 1023u);
                        let _e2013 = (_e922.member[0] + bitcast<f32>((bitcast<u32>((f32(_e2007) * _e998)) ^ _e70)));
                        let _e2017 = select(select(_e925.member_1[0], _e2013, (_e2013 < _e925.member_1[0])), _e925.member_1[0], (_e2007 == 1023u));
                        let _e2020 = ((_e1893 >> bitcast<u32>(10u)) & 1023u);
                        let _e2026 = (_e922.member[1] + bitcast<f32>((bitcast<u32>((f32(_e2020) * _e1076)) ^ _e70)));
                        let _e2030 = select(select(_e925.member_1[1], _e2026, (_e2026 < _e925.member_1[1])), _e925.member_1[1], (_e2020 == 1023u));
                        let _e2033 = ((_e1893 >> bitcast<u32>(20u)) & 1023u);
                        let _e2039 = (_e922.member[2] + bitcast<f32>((bitcast<u32>((f32(_e2033) * _e1157)) ^ _e70)));
                        let _e2043 = select(select(_e925.member_1[2], _e2039, (_e2039 < _e925.member_1[2])), _e925.member_1[2], (_e2033 == 1023u));
                        if _e67 {
                        } else {
                            break;
                        }
                        global_5.member[_e61] = type_37(array<u32, 2>(_e1172, _e1433), array<u32, 2>(_e1632, _e1893), _e838, _e869);
                        if _e66 {
                        } else {
                            break;
                        }
                        if ((_e838 & 2147483648u) != 0u) {
                            phi_3766_ = type_4(0u, ((_e838 >> bitcast<u32>(28u)) & 7u));
                            loop {
                                let _e2053 = phi_3766_;
                                if (_e2053.member < _e2053.member_1) {
                                    phi_3767_ = type_4((_e2053.member + 1u), _e2053.member_1);
                                    phi_3790_ = type_4(1u, _e2053.member);
                                } else {
                                    phi_3767_ = _e2053;
                                    phi_3790_ = type_4(0u, type_4().member_1);
                                }
                                let _e2066 = phi_3767_;
                                let _e2068 = phi_3790_;
                                let _e2072 = (bitcast<i32>(_e2068.member) != 0i);
                                if _e2072 {
                                    let _e2074 = ((_e838 & 268435455u) + _e2068.member_1);
                                    let _e2075 = (_e2074 < _e51);
                                    if _e2075 {
                                        let _e2076 = (_e2074 < _e55);
                                        if _e2076 {
                                            if _e2075 {
                                            } else {
                                                phi_7666_ = true;
                                                break;
                                            }
                                            let _e2081 = global_2.member[_e2074].member[0u];
                                            let _e2086 = global_2.member[_e2074].member[1u];
                                            let _e2091 = global_2.member[_e2074].member[2u];
                                            let _e2092 = (_e1943 - _e1906);
                                            let _e2093 = (_e2092 > 0f);
                                            if _e2093 {
                                                phi_3829_ = (((_e2081 - _e1906) / _e2092) * 1023f);
                                            } else {
                                                phi_3829_ = 0f;
                                            }
                                            let _e2098 = phi_3829_;
                                            let _e2100 = select(1023f, _e2098, (_e2098 < 1023f));
                                            let _e2102 = select(0f, _e2100, (_e2100 > 0f));
                                            let _e2107 = select(select(u32(_e2102), 0u, (_e2102 < 0f)), 4294967295u, (_e2102 > 4294967000f));
                                            if (_e2107 > 0u) {
                                                let _e2118 = (_e1906 + bitcast<f32>((bitcast<u32>((f32(_e2107) * bitcast<f32>((bitcast<u32>((_e2092 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                let _e2123 = (select(select(_e1943, _e2118, (_e2118 < _e1943)), _e1943, (_e2107 == 1023u)) > _e2081);
                                                if _e2123 {
                                                    phi_3880_ = (_e2107 - 1u);
                                                } else {
                                                    phi_3880_ = u32();
                                                }
                                                let _e2126 = phi_3880_;
                                                phi_3882_ = _e2126;
                                                phi_3883_ = select(true, false, _e2123);
                                            } else {
                                                phi_3882_ = u32();
                                                phi_3883_ = true;
                                            }
                                            let _e2129 = phi_3882_;
                                            let _e2131 = phi_3883_;
                                            if _e2131 {
                                                if (_e2107 < 1023u) {
                                                    let _e2133 = (_e2107 + 1u);
                                                    let _e2143 = (_e1906 + bitcast<f32>((bitcast<u32>((f32(_e2133) * bitcast<f32>((bitcast<u32>((_e2092 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                    phi_3921_ = select(_e2107, _e2133, (select(select(_e1943, _e2143, (_e2143 < _e1943)), _e1943, (_e2133 == 1023u)) <= _e2081));
                                                } else {
                                                    phi_3921_ = _e2107;
                                                }
                                                let _e2151 = phi_3921_;
                                                phi_3922_ = _e2151;
                                            } else {
                                                phi_3922_ = _e2129;
                                            }
                                            let _e2153 = phi_3922_;
                                            let _e2157 = bitcast<f32>((bitcast<u32>((_e2092 * 0.0009775171f)) ^ _e70));
                                            let _e2163 = (_e1906 + bitcast<f32>((bitcast<u32>((f32(_e2153) * _e2157)) ^ _e70)));
                                            let _e2169 = select(_e2153, 0u, (select(select(_e1943, _e2163, (_e2163 < _e1943)), _e1943, (_e2153 == 1023u)) > _e2081));
                                            if (_e2169 < 1023u) {
                                                phi_3956_ = (_e2169 + 1u);
                                            } else {
                                                phi_3956_ = _e2169;
                                            }
                                            let _e2173 = phi_3956_;
                                            let _e2179 = (_e1906 + bitcast<f32>((bitcast<u32>((f32(_e2169) * _e2157)) ^ _e70)));
                                            let _e2193 = (_e1906 + bitcast<f32>((bitcast<u32>((f32(_e2173) * _e2157)) ^ _e70)));
                                            let _e2204 = (_e1956 - _e1919);
                                            let _e2205 = (_e2204 > 0f);
                                            if _e2205 {
                                                phi_4025_ = (((_e2086 - _e1919) / _e2204) * 1023f);
                                            } else {
                                                phi_4025_ = 0f;
                                            }
                                            let _e2210 = phi_4025_;
                                            let _e2212 = select(1023f, _e2210, (_e2210 < 1023f));
                                            let _e2214 = select(0f, _e2212, (_e2212 > 0f));
                                            let _e2219 = select(select(u32(_e2214), 0u, (_e2214 < 0f)), 4294967295u, (_e2214 > 4294967000f));
                                            if (_e2219 > 0u) {
                                                let _e2230 = (_e1919 + bitcast<f32>((bitcast<u32>((f32(_e2219) * bitcast<f32>((bitcast<u32>((_e2204 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                let _e2235 = (select(select(_e1956, _e2230, (_e2230 < _e1956)), _e1956, (_e2219 == 1023u)) > _e2086);
                                                if _e2235 {
                                                    phi_4076_ = (_e2219 - 1u);
                                                } else {
                                                    phi_4076_ = u32();
                                                }
                                                let _e2238 = phi_4076_;
                                                phi_4078_ = _e2238;
                                                phi_4079_ = select(true, false, _e2235);
                                            } else {
                                                phi_4078_ = u32();
                                                phi_4079_ = true;
                                            }
                                            let _e2241 = phi_4078_;
                                            let _e2243 = phi_4079_;
                                            if _e2243 {
                                                if (_e2219 < 1023u) {
                                                    let _e2245 = (_e2219 + 1u);
                                                    let _e2255 = (_e1919 + bitcast<f32>((bitcast<u32>((f32(_e2245) * bitcast<f32>((bitcast<u32>((_e2204 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                    phi_4117_ = select(_e2219, _e2245, (select(select(_e1956, _e2255, (_e2255 < _e1956)), _e1956, (_e2245 == 1023u)) <= _e2086));
                                                } else {
                                                    phi_4117_ = _e2219;
                                                }
                                                let _e2263 = phi_4117_;
                                                phi_4118_ = _e2263;
                                            } else {
                                                phi_4118_ = _e2241;
                                            }
                                            let _e2265 = phi_4118_;
                                            let _e2269 = bitcast<f32>((bitcast<u32>((_e2204 * 0.0009775171f)) ^ _e70));
                                            let _e2275 = (_e1919 + bitcast<f32>((bitcast<u32>((f32(_e2265) * _e2269)) ^ _e70)));
                                            let _e2281 = select(_e2265, 0u, (select(select(_e1956, _e2275, (_e2275 < _e1956)), _e1956, (_e2265 == 1023u)) > _e2086));
                                            if (_e2281 < 1023u) {
                                                phi_4152_ = (_e2281 + 1u);
                                            } else {
                                                phi_4152_ = _e2281;
                                            }
                                            let _e2285 = phi_4152_;
                                            let _e2291 = (_e1919 + bitcast<f32>((bitcast<u32>((f32(_e2281) * _e2269)) ^ _e70)));
                                            let _e2305 = (_e1919 + bitcast<f32>((bitcast<u32>((f32(_e2285) * _e2269)) ^ _e70)));
                                            let _e2319 = (_e1969 - _e1932);
                                            let _e2320 = (_e2319 > 0f);
                                            if _e2320 {
                                                phi_4223_ = (((_e2091 - _e1932) / _e2319) * 1023f);
                                            } else {
                                                phi_4223_ = 0f;
                                            }
                                            let _e2325 = phi_4223_;
                                            let _e2327 = select(1023f, _e2325, (_e2325 < 1023f));
                                            let _e2329 = select(0f, _e2327, (_e2327 > 0f));
                                            let _e2334 = select(select(u32(_e2329), 0u, (_e2329 < 0f)), 4294967295u, (_e2329 > 4294967000f));
                                            if (_e2334 > 0u) {
                                                let _e2345 = (_e1932 + bitcast<f32>((bitcast<u32>((f32(_e2334) * bitcast<f32>((bitcast<u32>((_e2319 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                let _e2350 = (select(select(_e1969, _e2345, (_e2345 < _e1969)), _e1969, (_e2334 == 1023u)) > _e2091);
                                                if _e2350 {
                                                    phi_4274_ = (_e2334 - 1u);
                                                } else {
                                                    phi_4274_ = u32();
                                                }
                                                let _e2353 = phi_4274_;
                                                phi_4276_ = _e2353;
                                                phi_4277_ = select(true, false, _e2350);
                                            } else {
                                                phi_4276_ = u32();
                                                phi_4277_ = true;
                                            }
                                            let _e2356 = phi_4276_;
                                            let _e2358 = phi_4277_;
                                            if _e2358 {
                                                if (_e2334 < 1023u) {
                                                    let _e2360 = (_e2334 + 1u);
                                                    let _e2370 = (_e1932 + bitcast<f32>((bitcast<u32>((f32(_e2360) * bitcast<f32>((bitcast<u32>((_e2319 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                    phi_4315_ = select(_e2334, _e2360, (select(select(_e1969, _e2370, (_e2370 < _e1969)), _e1969, (_e2360 == 1023u)) <= _e2091));
                                                } else {
                                                    phi_4315_ = _e2334;
                                                }
                                                let _e2378 = phi_4315_;
                                                phi_4316_ = _e2378;
                                            } else {
                                                phi_4316_ = _e2356;
                                            }
                                            let _e2380 = phi_4316_;
                                            let _e2384 = bitcast<f32>((bitcast<u32>((_e2319 * 0.0009775171f)) ^ _e70));
                                            let _e2390 = (_e1932 + bitcast<f32>((bitcast<u32>((f32(_e2380) * _e2384)) ^ _e70)));
                                            let _e2396 = select(_e2380, 0u, (select(select(_e1969, _e2390, (_e2390 < _e1969)), _e1969, (_e2380 == 1023u)) > _e2091));
                                            if (_e2396 < 1023u) {
                                                phi_4350_ = (_e2396 + 1u);
                                            } else {
                                                phi_4350_ = _e2396;
                                            }
                                            let _e2400 = phi_4350_;
                                            let _e2406 = (_e1932 + bitcast<f32>((bitcast<u32>((f32(_e2396) * _e2384)) ^ _e70)));
                                            let _e2420 = (_e1932 + bitcast<f32>((bitcast<u32>((f32(_e2400) * _e2384)) ^ _e70)));
                                            let _e2438 = global_2.member[_e2074].member[3u];
                                            let _e2443 = global_2.member[_e2074].member[4u];
                                            let _e2448 = global_2.member[_e2074].member[5u];
                                            if _e2093 {
                                                phi_4427_ = (((_e2438 - _e1906) / _e2092) * 1023f);
                                            } else {
                                                phi_4427_ = 0f;
                                            }
                                            let _e2453 = phi_4427_;
                                            let _e2455 = select(1023f, _e2453, (_e2453 < 1023f));
                                            let _e2457 = select(0f, _e2455, (_e2455 > 0f));
                                            let _e2462 = select(select(u32(_e2457), 0u, (_e2457 < 0f)), 4294967295u, (_e2457 > 4294967000f));
                                            if (_e2462 > 0u) {
                                                let _e2469 = (_e1906 + bitcast<f32>((bitcast<u32>((f32(_e2462) * _e2157)) ^ _e70)));
                                                let _e2474 = (select(select(_e1943, _e2469, (_e2469 < _e1943)), _e1943, (_e2462 == 1023u)) > _e2438);
                                                if _e2474 {
                                                    phi_4478_ = (_e2462 - 1u);
                                                } else {
                                                    phi_4478_ = u32();
                                                }
                                                let _e2477 = phi_4478_;
                                                phi_4480_ = _e2477;
                                                phi_4481_ = select(true, false, _e2474);
                                            } else {
                                                phi_4480_ = u32();
                                                phi_4481_ = true;
                                            }
                                            let _e2480 = phi_4480_;
                                            let _e2482 = phi_4481_;
                                            if _e2482 {
                                                if (_e2462 < 1023u) {
                                                    let _e2484 = (_e2462 + 1u);
                                                    let _e2490 = (_e1906 + bitcast<f32>((bitcast<u32>((f32(_e2484) * _e2157)) ^ _e70)));
                                                    phi_4519_ = select(_e2462, _e2484, (select(select(_e1943, _e2490, (_e2490 < _e1943)), _e1943, (_e2484 == 1023u)) <= _e2438));
                                                } else {
                                                    phi_4519_ = _e2462;
                                                }
                                                let _e2498 = phi_4519_;
                                                phi_4520_ = _e2498;
                                            } else {
                                                phi_4520_ = _e2480;
                                            }
                                            let _e2500 = phi_4520_;
                                            let _e2506 = (_e1906 + bitcast<f32>((bitcast<u32>((f32(_e2500) * _e2157)) ^ _e70)));
                                            let _e2512 = select(_e2500, 0u, (select(select(_e1943, _e2506, (_e2506 < _e1943)), _e1943, (_e2500 == 1023u)) > _e2438));
                                            if (_e2512 < 1023u) {
                                                phi_4554_ = (_e2512 + 1u);
                                            } else {
                                                phi_4554_ = _e2512;
                                            }
                                            let _e2516 = phi_4554_;
                                            let _e2522 = (_e1906 + bitcast<f32>((bitcast<u32>((f32(_e2512) * _e2157)) ^ _e70)));
                                            let _e2536 = (_e1906 + bitcast<f32>((bitcast<u32>((f32(_e2516) * _e2157)) ^ _e70)));
                                            if _e2205 {
                                                phi_4623_ = (((_e2443 - _e1919) / _e2204) * 1023f);
                                            } else {
                                                phi_4623_ = 0f;
                                            }
                                            let _e2551 = phi_4623_;
                                            let _e2553 = select(1023f, _e2551, (_e2551 < 1023f));
                                            let _e2555 = select(0f, _e2553, (_e2553 > 0f));
                                            let _e2560 = select(select(u32(_e2555), 0u, (_e2555 < 0f)), 4294967295u, (_e2555 > 4294967000f));
                                            if (_e2560 > 0u) {
                                                let _e2567 = (_e1919 + bitcast<f32>((bitcast<u32>((f32(_e2560) * _e2269)) ^ _e70)));
                                                let _e2572 = (select(select(_e1956, _e2567, (_e2567 < _e1956)), _e1956, (_e2560 == 1023u)) > _e2443);
                                                if _e2572 {
                                                    phi_4674_ = (_e2560 - 1u);
                                                } else {
                                                    phi_4674_ = u32();
                                                }
                                                let _e2575 = phi_4674_;
                                                phi_4676_ = _e2575;
                                                phi_4677_ = select(true, false, _e2572);
                                            } else {
                                                phi_4676_ = u32();
                                                phi_4677_ = true;
                                            }
                                            let _e2578 = phi_4676_;
                                            let _e2580 = phi_4677_;
                                            if _e2580 {
                                                if (_e2560 < 1023u) {
                                                    let _e2582 = (_e2560 + 1u);
                                                    let _e2588 = (_e1919 + bitcast<f32>((bitcast<u32>((f32(_e2582) * _e2269)) ^ _e70)));
                                                    phi_4715_ = select(_e2560, _e2582, (select(select(_e1956, _e2588, (_e2588 < _e1956)), _e1956, (_e2582 == 1023u)) <= _e2443));
                                                } else {
                                                    phi_4715_ = _e2560;
                                                }
                                                let _e2596 = phi_4715_;
                                                phi_4716_ = _e2596;
                                            } else {
                                                phi_4716_ = _e2578;
                                            }
                                            let _e2598 = phi_4716_;
                                            let _e2604 = (_e1919 + bitcast<f32>((bitcast<u32>((f32(_e2598) * _e2269)) ^ _e70)));
                                            let _e2610 = select(_e2598, 0u, (select(select(_e1956, _e2604, (_e2604 < _e1956)), _e1956, (_e2598 == 1023u)) > _e2443));
                                            if (_e2610 < 1023u) {
                                                phi_4750_ = (_e2610 + 1u);
                                            } else {
                                                phi_4750_ = _e2610;
                                            }
                                            let _e2614 = phi_4750_;
                                            let _e2620 = (_e1919 + bitcast<f32>((bitcast<u32>((f32(_e2610) * _e2269)) ^ _e70)));
                                            let _e2634 = (_e1919 + bitcast<f32>((bitcast<u32>((f32(_e2614) * _e2269)) ^ _e70)));
                                            if _e2320 {
                                                phi_4821_ = (((_e2448 - _e1932) / _e2319) * 1023f);
                                            } else {
                                                phi_4821_ = 0f;
                                            }
                                            let _e2652 = phi_4821_;
                                            let _e2654 = select(1023f, _e2652, (_e2652 < 1023f));
                                            let _e2656 = select(0f, _e2654, (_e2654 > 0f));
                                            let _e2661 = select(select(u32(_e2656), 0u, (_e2656 < 0f)), 4294967295u, (_e2656 > 4294967000f));
                                            if (_e2661 > 0u) {
                                                let _e2668 = (_e1932 + bitcast<f32>((bitcast<u32>((f32(_e2661) * _e2384)) ^ _e70)));
                                                let _e2673 = (select(select(_e1969, _e2668, (_e2668 < _e1969)), _e1969, (_e2661 == 1023u)) > _e2448);
                                                if _e2673 {
                                                    phi_4872_ = (_e2661 - 1u);
                                                } else {
                                                    phi_4872_ = u32();
                                                }
                                                let _e2676 = phi_4872_;
                                                phi_4874_ = _e2676;
                                                phi_4875_ = select(true, false, _e2673);
                                            } else {
                                                phi_4874_ = u32();
                                                phi_4875_ = true;
                                            }
                                            let _e2679 = phi_4874_;
                                            let _e2681 = phi_4875_;
                                            if _e2681 {
                                                if (_e2661 < 1023u) {
                                                    let _e2683 = (_e2661 + 1u);
                                                    let _e2689 = (_e1932 + bitcast<f32>((bitcast<u32>((f32(_e2683) * _e2384)) ^ _e70)));
                                                    phi_4913_ = select(_e2661, _e2683, (select(select(_e1969, _e2689, (_e2689 < _e1969)), _e1969, (_e2683 == 1023u)) <= _e2448));
                                                } else {
                                                    phi_4913_ = _e2661;
                                                }
                                                let _e2697 = phi_4913_;
                                                phi_4914_ = _e2697;
                                            } else {
                                                phi_4914_ = _e2679;
                                            }
                                            let _e2699 = phi_4914_;
                                            let _e2705 = (_e1932 + bitcast<f32>((bitcast<u32>((f32(_e2699) * _e2384)) ^ _e70)));
                                            let _e2711 = select(_e2699, 0u, (select(select(_e1969, _e2705, (_e2705 < _e1969)), _e1969, (_e2699 == 1023u)) > _e2448));
                                            if (_e2711 < 1023u) {
                                                phi_4948_ = (_e2711 + 1u);
                                            } else {
                                                phi_4948_ = _e2711;
                                            }
                                            let _e2715 = phi_4948_;
                                            let _e2721 = (_e1932 + bitcast<f32>((bitcast<u32>((f32(_e2711) * _e2384)) ^ _e70)));
                                            let _e2735 = (_e1932 + bitcast<f32>((bitcast<u32>((f32(_e2715) * _e2384)) ^ _e70)));
                                            let _e2753 = global_2.member[_e2074].member[6u];
                                            let _e2758 = global_2.member[_e2074].member[7u];
                                            let _e2763 = global_2.member[_e2074].member[8u];
                                            if _e2093 {
                                                phi_5025_ = (((_e2753 - _e1906) / _e2092) * 1023f);
                                            } else {
                                                phi_5025_ = 0f;
                                            }
                                            let _e2768 = phi_5025_;
                                            let _e2770 = select(1023f, _e2768, (_e2768 < 1023f));
                                            let _e2772 = select(0f, _e2770, (_e2770 > 0f));
                                            let _e2777 = select(select(u32(_e2772), 0u, (_e2772 < 0f)), 4294967295u, (_e2772 > 4294967000f));
                                            if (_e2777 > 0u) {
                                                let _e2784 = (_e1906 + bitcast<f32>((bitcast<u32>((f32(_e2777) * _e2157)) ^ _e70)));
                                                let _e2789 = (select(select(_e1943, _e2784, (_e2784 < _e1943)), _e1943, (_e2777 == 1023u)) > _e2753);
                                                if _e2789 {
                                                    phi_5076_ = (_e2777 - 1u);
                                                } else {
                                                    phi_5076_ = u32();
                                                }
                                                let _e2792 = phi_5076_;
                                                phi_5078_ = _e2792;
                                                phi_5079_ = select(true, false, _e2789);
                                            } else {
                                                phi_5078_ = u32();
                                                phi_5079_ = true;
                                            }
                                            let _e2795 = phi_5078_;
                                            let _e2797 = phi_5079_;
                                            if _e2797 {
                                                if (_e2777 < 1023u) {
                                                    let _e2799 = (_e2777 + 1u);
                                                    let _e2805 = (_e1906 + bitcast<f32>((bitcast<u32>((f32(_e2799) * _e2157)) ^ _e70)));
                                                    phi_5117_ = select(_e2777, _e2799, (select(select(_e1943, _e2805, (_e2805 < _e1943)), _e1943, (_e2799 == 1023u)) <= _e2753));
                                                } else {
                                                    phi_5117_ = _e2777;
                                                }
                                                let _e2813 = phi_5117_;
                                                phi_5118_ = _e2813;
                                            } else {
                                                phi_5118_ = _e2795;
                                            }
                                            let _e2815 = phi_5118_;
                                            let _e2821 = (_e1906 + bitcast<f32>((bitcast<u32>((f32(_e2815) * _e2157)) ^ _e70)));
                                            let _e2827 = select(_e2815, 0u, (select(select(_e1943, _e2821, (_e2821 < _e1943)), _e1943, (_e2815 == 1023u)) > _e2753));
                                            if (_e2827 < 1023u) {
                                                phi_5152_ = (_e2827 + 1u);
                                            } else {
                                                phi_5152_ = _e2827;
                                            }
                                            let _e2831 = phi_5152_;
                                            let _e2837 = (_e1906 + bitcast<f32>((bitcast<u32>((f32(_e2827) * _e2157)) ^ _e70)));
                                            let _e2851 = (_e1906 + bitcast<f32>((bitcast<u32>((f32(_e2831) * _e2157)) ^ _e70)));
                                            if _e2205 {
                                                phi_5221_ = (((_e2758 - _e1919) / _e2204) * 1023f);
                                            } else {
                                                phi_5221_ = 0f;
                                            }
                                            let _e2866 = phi_5221_;
                                            let _e2868 = select(1023f, _e2866, (_e2866 < 1023f));
                                            let _e2870 = select(0f, _e2868, (_e2868 > 0f));
                                            let _e2875 = select(select(u32(_e2870), 0u, (_e2870 < 0f)), 4294967295u, (_e2870 > 4294967000f));
                                            if (_e2875 > 0u) {
                                                let _e2882 = (_e1919 + bitcast<f32>((bitcast<u32>((f32(_e2875) * _e2269)) ^ _e70)));
                                                let _e2887 = (select(select(_e1956, _e2882, (_e2882 < _e1956)), _e1956, (_e2875 == 1023u)) > _e2758);
                                                if _e2887 {
                                                    phi_5272_ = (_e2875 - 1u);
                                                } else {
                                                    phi_5272_ = u32();
                                                }
                                                let _e2890 = phi_5272_;
                                                phi_5274_ = _e2890;
                                                phi_5275_ = select(true, false, _e2887);
                                            } else {
                                                phi_5274_ = u32();
                                                phi_5275_ = true;
                                            }
                                            let _e2893 = phi_5274_;
                                            let _e2895 = phi_5275_;
                                            if _e2895 {
                                                if (_e2875 < 1023u) {
                                                    let _e2897 = (_e2875 + 1u);
                                                    let _e2903 = (_e1919 + bitcast<f32>((bitcast<u32>((f32(_e2897) * _e2269)) ^ _e70)));
                                                    phi_5313_ = select(_e2875, _e2897, (select(select(_e1956, _e2903, (_e2903 < _e1956)), _e1956, (_e2897 == 1023u)) <= _e2758));
                                                } else {
                                                    phi_5313_ = _e2875;
                                                }
                                                let _e2911 = phi_5313_;
                                                phi_5314_ = _e2911;
                                            } else {
                                                phi_5314_ = _e2893;
                                            }
                                            let _e2913 = phi_5314_;
                                            let _e2919 = (_e1919 + bitcast<f32>((bitcast<u32>((f32(_e2913) * _e2269)) ^ _e70)));
                                            let _e2925 = select(_e2913, 0u, (select(select(_e1956, _e2919, (_e2919 < _e1956)), _e1956, (_e2913 == 1023u)) > _e2758));
                                            if (_e2925 < 1023u) {
                                                phi_5348_ = (_e2925 + 1u);
                                            } else {
                                                phi_5348_ = _e2925;
                                            }
                                            let _e2929 = phi_5348_;
                                            let _e2935 = (_e1919 + bitcast<f32>((bitcast<u32>((f32(_e2925) * _e2269)) ^ _e70)));
                                            let _e2949 = (_e1919 + bitcast<f32>((bitcast<u32>((f32(_e2929) * _e2269)) ^ _e70)));
                                            if _e2320 {
                                                phi_5419_ = (((_e2763 - _e1932) / _e2319) * 1023f);
                                            } else {
                                                phi_5419_ = 0f;
                                            }
                                            let _e2967 = phi_5419_;
                                            let _e2969 = select(1023f, _e2967, (_e2967 < 1023f));
                                            let _e2971 = select(0f, _e2969, (_e2969 > 0f));
                                            let _e2976 = select(select(u32(_e2971), 0u, (_e2971 < 0f)), 4294967295u, (_e2971 > 4294967000f));
                                            if (_e2976 > 0u) {
                                                let _e2983 = (_e1932 + bitcast<f32>((bitcast<u32>((f32(_e2976) * _e2384)) ^ _e70)));
                                                let _e2988 = (select(select(_e1969, _e2983, (_e2983 < _e1969)), _e1969, (_e2976 == 1023u)) > _e2763);
                                                if _e2988 {
                                                    phi_5470_ = (_e2976 - 1u);
                                                } else {
                                                    phi_5470_ = u32();
                                                }
                                                let _e2991 = phi_5470_;
                                                phi_5472_ = _e2991;
                                                phi_5473_ = select(true, false, _e2988);
                                            } else {
                                                phi_5472_ = u32();
                                                phi_5473_ = true;
                                            }
                                            let _e2994 = phi_5472_;
                                            let _e2996 = phi_5473_;
                                            if _e2996 {
                                                if (_e2976 < 1023u) {
                                                    let _e2998 = (_e2976 + 1u);
                                                    let _e3004 = (_e1932 + bitcast<f32>((bitcast<u32>((f32(_e2998) * _e2384)) ^ _e70)));
                                                    phi_5511_ = select(_e2976, _e2998, (select(select(_e1969, _e3004, (_e3004 < _e1969)), _e1969, (_e2998 == 1023u)) <= _e2763));
                                                } else {
                                                    phi_5511_ = _e2976;
                                                }
                                                let _e3012 = phi_5511_;
                                                phi_5512_ = _e3012;
                                            } else {
                                                phi_5512_ = _e2994;
                                            }
                                            let _e3014 = phi_5512_;
                                            let _e3020 = (_e1932 + bitcast<f32>((bitcast<u32>((f32(_e3014) * _e2384)) ^ _e70)));
                                            let _e3026 = select(_e3014, 0u, (select(select(_e1969, _e3020, (_e3020 < _e1969)), _e1969, (_e3014 == 1023u)) > _e2763));
                                            if (_e3026 < 1023u) {
                                                phi_5546_ = (_e3026 + 1u);
                                            } else {
                                                phi_5546_ = _e3026;
                                            }
                                            let _e3030 = phi_5546_;
                                            let _e3036 = (_e1932 + bitcast<f32>((bitcast<u32>((f32(_e3026) * _e2384)) ^ _e70)));
                                            let _e3050 = (_e1932 + bitcast<f32>((bitcast<u32>((f32(_e3030) * _e2384)) ^ _e70)));
                                            let _e3068 = global_2.member[_e2074].member_1;
                                            if _e2076 {
                                            } else {
                                                phi_7666_ = true;
                                                break;
                                            }
                                            global_6.member[_e2074] = type_43(array<u32, 3>(((select(_e2169, _e2173, (bitcast<f32>((bitcast<u32>((select(select(_e1943, _e2193, (_e2193 < _e1943)), _e1943, (_e2173 == 1023u)) - _e2081)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2081 - select(select(_e1943, _e2179, (_e2179 < _e1943)), _e1943, (_e2169 == 1023u)))) & 2147483647u)))) | (select(_e2281, _e2285, (bitcast<f32>((bitcast<u32>((select(select(_e1956, _e2305, (_e2305 < _e1956)), _e1956, (_e2285 == 1023u)) - _e2086)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2086 - select(select(_e1956, _e2291, (_e2291 < _e1956)), _e1956, (_e2281 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e2396, _e2400, (bitcast<f32>((bitcast<u32>((select(select(_e1969, _e2420, (_e2420 < _e1969)), _e1969, (_e2400 == 1023u)) - _e2091)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2091 - select(select(_e1969, _e2406, (_e2406 < _e1969)), _e1969, (_e2396 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i))), ((select(_e2512, _e2516, (bitcast<f32>((bitcast<u32>((select(select(_e1943, _e2536, (_e2536 < _e1943)), _e1943, (_e2516 == 1023u)) - _e2438)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2438 - select(select(_e1943, _e2522, (_e2522 < _e1943)), _e1943, (_e2512 == 1023u)))) & 2147483647u)))) | (select(_e2610, _e2614, (bitcast<f32>((bitcast<u32>((select(select(_e1956, _e2634, (_e2634 < _e1956)), _e1956, (_e2614 == 1023u)) - _e2443)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2443 - select(select(_e1956, _e2620, (_e2620 < _e1956)), _e1956, (_e2610 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e2711, _e2715, (bitcast<f32>((bitcast<u32>((select(select(_e1969, _e2735, (_e2735 < _e1969)), _e1969, (_e2715 == 1023u)) - _e2448)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2448 - select(select(_e1969, _e2721, (_e2721 < _e1969)), _e1969, (_e2711 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i))), ((select(_e2827, _e2831, (bitcast<f32>((bitcast<u32>((select(select(_e1943, _e2851, (_e2851 < _e1943)), _e1943, (_e2831 == 1023u)) - _e2753)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2753 - select(select(_e1943, _e2837, (_e2837 < _e1943)), _e1943, (_e2827 == 1023u)))) & 2147483647u)))) | (select(_e2925, _e2929, (bitcast<f32>((bitcast<u32>((select(select(_e1956, _e2949, (_e2949 < _e1956)), _e1956, (_e2929 == 1023u)) - _e2758)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2758 - select(select(_e1956, _e2935, (_e2935 < _e1956)), _e1956, (_e2925 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e3026, _e3030, (bitcast<f32>((bitcast<u32>((select(select(_e1969, _e3050, (_e3050 < _e1969)), _e1969, (_e3030 == 1023u)) - _e2763)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e2763 - select(select(_e1969, _e3036, (_e3036 < _e1969)), _e1969, (_e3026 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i)))), _e3068);
                                        }
                                    }
                                }
                                continue;
                                continuing {
                                    phi_3766_ = _e2066;
                                    phi_7666_ = _e834;
                                    break if !(_e2072);
                                }
                            }
                            let _e3074 = phi_7666_;
                            if _e3074 {
                                break;
                            }
                            phi_8101_ = _e3074;
                        } else {
                            phi_8101_ = _e834;
                        }
                        let _e3076 = phi_8101_;
                        if _e66 {
                        } else {
                            break;
                        }
                        if ((_e869 & 2147483648u) != 0u) {
                            phi_5637_ = type_4(0u, ((_e869 >> bitcast<u32>(28u)) & 7u));
                            loop {
                                let _e3084 = phi_5637_;
                                if (_e3084.member < _e3084.member_1) {
                                    phi_5638_ = type_4((_e3084.member + 1u), _e3084.member_1);
                                    phi_5661_ = type_4(1u, _e3084.member);
                                } else {
                                    phi_5638_ = _e3084;
                                    phi_5661_ = type_4(0u, type_4().member_1);
                                }
                                let _e3097 = phi_5638_;
                                let _e3099 = phi_5661_;
                                let _e3103 = (bitcast<i32>(_e3099.member) != 0i);
                                if _e3103 {
                                    let _e3105 = ((_e869 & 268435455u) + _e3099.member_1);
                                    let _e3106 = (_e3105 < _e51);
                                    if _e3106 {
                                        let _e3107 = (_e3105 < _e55);
                                        if _e3107 {
                                            if _e3106 {
                                            } else {
                                                phi_8097_ = true;
                                                break;
                                            }
                                            let _e3112 = global_2.member[_e3105].member[0u];
                                            let _e3117 = global_2.member[_e3105].member[1u];
                                            let _e3122 = global_2.member[_e3105].member[2u];
                                            let _e3123 = (_e2017 - _e1980);
                                            let _e3124 = (_e3123 > 0f);
                                            if _e3124 {
                                                phi_5700_ = (((_e3112 - _e1980) / _e3123) * 1023f);
                                            } else {
                                                phi_5700_ = 0f;
                                            }
                                            let _e3129 = phi_5700_;
                                            let _e3131 = select(1023f, _e3129, (_e3129 < 1023f));
                                            let _e3133 = select(0f, _e3131, (_e3131 > 0f));
                                            let _e3138 = select(select(u32(_e3133), 0u, (_e3133 < 0f)), 4294967295u, (_e3133 > 4294967000f));
                                            if (_e3138 > 0u) {
                                                let _e3149 = (_e1980 + bitcast<f32>((bitcast<u32>((f32(_e3138) * bitcast<f32>((bitcast<u32>((_e3123 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                let _e3154 = (select(select(_e2017, _e3149, (_e3149 < _e2017)), _e2017, (_e3138 == 1023u)) > _e3112);
                                                if _e3154 {
                                                    phi_5751_ = (_e3138 - 1u);
                                                } else {
                                                    phi_5751_ = u32();
                                                }
                                                let _e3157 = phi_5751_;
                                                phi_5753_ = _e3157;
                                                phi_5754_ = select(true, false, _e3154);
                                            } else {
                                                phi_5753_ = u32();
                                                phi_5754_ = true;
                                            }
                                            let _e3160 = phi_5753_;
                                            let _e3162 = phi_5754_;
                                            if _e3162 {
                                                if (_e3138 < 1023u) {
                                                    let _e3164 = (_e3138 + 1u);
                                                    let _e3174 = (_e1980 + bitcast<f32>((bitcast<u32>((f32(_e3164) * bitcast<f32>((bitcast<u32>((_e3123 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                    phi_5792_ = select(_e3138, _e3164, (select(select(_e2017, _e3174, (_e3174 < _e2017)), _e2017, (_e3164 == 1023u)) <= _e3112));
                                                } else {
                                                    phi_5792_ = _e3138;
                                                }
                                                let _e3182 = phi_5792_;
                                                phi_5793_ = _e3182;
                                            } else {
                                                phi_5793_ = _e3160;
                                            }
                                            let _e3184 = phi_5793_;
                                            let _e3188 = bitcast<f32>((bitcast<u32>((_e3123 * 0.0009775171f)) ^ _e70));
                                            let _e3194 = (_e1980 + bitcast<f32>((bitcast<u32>((f32(_e3184) * _e3188)) ^ _e70)));
                                            let _e3200 = select(_e3184, 0u, (select(select(_e2017, _e3194, (_e3194 < _e2017)), _e2017, (_e3184 == 1023u)) > _e3112));
                                            if (_e3200 < 1023u) {
                                                phi_5827_ = (_e3200 + 1u);
                                            } else {
                                                phi_5827_ = _e3200;
                                            }
                                            let _e3204 = phi_5827_;
                                            let _e3210 = (_e1980 + bitcast<f32>((bitcast<u32>((f32(_e3200) * _e3188)) ^ _e70)));
                                            let _e3224 = (_e1980 + bitcast<f32>((bitcast<u32>((f32(_e3204) * _e3188)) ^ _e70)));
                                            let _e3235 = (_e2030 - _e1993);
                                            let _e3236 = (_e3235 > 0f);
                                            if _e3236 {
                                                phi_5896_ = (((_e3117 - _e1993) / _e3235) * 1023f);
                                            } else {
                                                phi_5896_ = 0f;
                                            }
                                            let _e3241 = phi_5896_;
                                            let _e3243 = select(1023f, _e3241, (_e3241 < 1023f));
                                            let _e3245 = select(0f, _e3243, (_e3243 > 0f));
                                            let _e3250 = select(select(u32(_e3245), 0u, (_e3245 < 0f)), 4294967295u, (_e3245 > 4294967000f));
                                            if (_e3250 > 0u) {
                                                let _e3261 = (_e1993 + bitcast<f32>((bitcast<u32>((f32(_e3250) * bitcast<f32>((bitcast<u32>((_e3235 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                let _e3266 = (select(select(_e2030, _e3261, (_e3261 < _e2030)), _e2030, (_e3250 == 1023u)) > _e3117);
                                                if _e3266 {
                                                    phi_5947_ = (_e3250 - 1u);
                                                } else {
                                                    phi_5947_ = u32();
                                                }
                                                let _e3269 = phi_5947_;
                                                phi_5949_ = _e3269;
                                                phi_5950_ = select(true, false, _e3266);
                                            } else {
                                                phi_5949_ = u32();
                                                phi_5950_ = true;
                                            }
                                            let _e3272 = phi_5949_;
                                            let _e3274 = phi_5950_;
                                            if _e3274 {
                                                if (_e3250 < 1023u) {
                                                    let _e3276 = (_e3250 + 1u);
                                                    let _e3286 = (_e1993 + bitcast<f32>((bitcast<u32>((f32(_e3276) * bitcast<f32>((bitcast<u32>((_e3235 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                    phi_5988_ = select(_e3250, _e3276, (select(select(_e2030, _e3286, (_e3286 < _e2030)), _e2030, (_e3276 == 1023u)) <= _e3117));
                                                } else {
                                                    phi_5988_ = _e3250;
                                                }
                                                let _e3294 = phi_5988_;
                                                phi_5989_ = _e3294;
                                            } else {
                                                phi_5989_ = _e3272;
                                            }
                                            let _e3296 = phi_5989_;
                                            let _e3300 = bitcast<f32>((bitcast<u32>((_e3235 * 0.0009775171f)) ^ _e70));
                                            let _e3306 = (_e1993 + bitcast<f32>((bitcast<u32>((f32(_e3296) * _e3300)) ^ _e70)));
                                            let _e3312 = select(_e3296, 0u, (select(select(_e2030, _e3306, (_e3306 < _e2030)), _e2030, (_e3296 == 1023u)) > _e3117));
                                            if (_e3312 < 1023u) {
                                                phi_6023_ = (_e3312 + 1u);
                                            } else {
                                                phi_6023_ = _e3312;
                                            }
                                            let _e3316 = phi_6023_;
                                            let _e3322 = (_e1993 + bitcast<f32>((bitcast<u32>((f32(_e3312) * _e3300)) ^ _e70)));
                                            let _e3336 = (_e1993 + bitcast<f32>((bitcast<u32>((f32(_e3316) * _e3300)) ^ _e70)));
                                            let _e3350 = (_e2043 - _e2006);
                                            let _e3351 = (_e3350 > 0f);
                                            if _e3351 {
                                                phi_6094_ = (((_e3122 - _e2006) / _e3350) * 1023f);
                                            } else {
                                                phi_6094_ = 0f;
                                            }
                                            let _e3356 = phi_6094_;
                                            let _e3358 = select(1023f, _e3356, (_e3356 < 1023f));
                                            let _e3360 = select(0f, _e3358, (_e3358 > 0f));
                                            let _e3365 = select(select(u32(_e3360), 0u, (_e3360 < 0f)), 4294967295u, (_e3360 > 4294967000f));
                                            if (_e3365 > 0u) {
                                                let _e3376 = (_e2006 + bitcast<f32>((bitcast<u32>((f32(_e3365) * bitcast<f32>((bitcast<u32>((_e3350 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                let _e3381 = (select(select(_e2043, _e3376, (_e3376 < _e2043)), _e2043, (_e3365 == 1023u)) > _e3122);
                                                if _e3381 {
                                                    phi_6145_ = (_e3365 - 1u);
                                                } else {
                                                    phi_6145_ = u32();
                                                }
                                                let _e3384 = phi_6145_;
                                                phi_6147_ = _e3384;
                                                phi_6148_ = select(true, false, _e3381);
                                            } else {
                                                phi_6147_ = u32();
                                                phi_6148_ = true;
                                            }
                                            let _e3387 = phi_6147_;
                                            let _e3389 = phi_6148_;
                                            if _e3389 {
                                                if (_e3365 < 1023u) {
                                                    let _e3391 = (_e3365 + 1u);
                                                    let _e3401 = (_e2006 + bitcast<f32>((bitcast<u32>((f32(_e3391) * bitcast<f32>((bitcast<u32>((_e3350 * 0.0009775171f)) ^ _e70)))) ^ _e70)));
                                                    phi_6186_ = select(_e3365, _e3391, (select(select(_e2043, _e3401, (_e3401 < _e2043)), _e2043, (_e3391 == 1023u)) <= _e3122));
                                                } else {
                                                    phi_6186_ = _e3365;
                                                }
                                                let _e3409 = phi_6186_;
                                                phi_6187_ = _e3409;
                                            } else {
                                                phi_6187_ = _e3387;
                                            }
                                            let _e3411 = phi_6187_;
                                            let _e3415 = bitcast<f32>((bitcast<u32>((_e3350 * 0.0009775171f)) ^ _e70));
                                            let _e3421 = (_e2006 + bitcast<f32>((bitcast<u32>((f32(_e3411) * _e3415)) ^ _e70)));
                                            let _e3427 = select(_e3411, 0u, (select(select(_e2043, _e3421, (_e3421 < _e2043)), _e2043, (_e3411 == 1023u)) > _e3122));
                                            if (_e3427 < 1023u) {
                                                phi_6221_ = (_e3427 + 1u);
                                            } else {
                                                phi_6221_ = _e3427;
                                            }
                                            let _e3431 = phi_6221_;
                                            let _e3437 = (_e2006 + bitcast<f32>((bitcast<u32>((f32(_e3427) * _e3415)) ^ _e70)));
                                            let _e3451 = (_e2006 + bitcast<f32>((bitcast<u32>((f32(_e3431) * _e3415)) ^ _e70)));
                                            let _e3469 = global_2.member[_e3105].member[3u];
                                            let _e3474 = global_2.member[_e3105].member[4u];
                                            let _e3479 = global_2.member[_e3105].member[5u];
                                            if _e3124 {
                                                phi_6298_ = (((_e3469 - _e1980) / _e3123) * 1023f);
                                            } else {
                                                phi_6298_ = 0f;
                                            }
                                            let _e3484 = phi_6298_;
                                            let _e3486 = select(1023f, _e3484, (_e3484 < 1023f));
                                            let _e3488 = select(0f, _e3486, (_e3486 > 0f));
                                            let _e3493 = select(select(u32(_e3488), 0u, (_e3488 < 0f)), 4294967295u, (_e3488 > 4294967000f));
                                            if (_e3493 > 0u) {
                                                let _e3500 = (_e1980 + bitcast<f32>((bitcast<u32>((f32(_e3493) * _e3188)) ^ _e70)));
                                                let _e3505 = (select(select(_e2017, _e3500, (_e3500 < _e2017)), _e2017, (_e3493 == 1023u)) > _e3469);
                                                if _e3505 {
                                                    phi_6349_ = (_e3493 - 1u);
                                                } else {
                                                    phi_6349_ = u32();
                                                }
                                                let _e3508 = phi_6349_;
                                                phi_6351_ = _e3508;
                                                phi_6352_ = select(true, false, _e3505);
                                            } else {
                                                phi_6351_ = u32();
                                                phi_6352_ = true;
                                            }
                                            let _e3511 = phi_6351_;
                                            let _e3513 = phi_6352_;
                                            if _e3513 {
                                                if (_e3493 < 1023u) {
                                                    let _e3515 = (_e3493 + 1u);
                                                    let _e3521 = (_e1980 + bitcast<f32>((bitcast<u32>((f32(_e3515) * _e3188)) ^ _e70)));
                                                    phi_6390_ = select(_e3493, _e3515, (select(select(_e2017, _e3521, (_e3521 < _e2017)), _e2017, (_e3515 == 1023u)) <= _e3469));
                                                } else {
                                                    phi_6390_ = _e3493;
                                                }
                                                let _e3529 = phi_6390_;
                                                phi_6391_ = _e3529;
                                            } else {
                                                phi_6391_ = _e3511;
                                            }
                                            let _e3531 = phi_6391_;
                                            let _e3537 = (_e1980 + bitcast<f32>((bitcast<u32>((f32(_e3531) * _e3188)) ^ _e70)));
                                            let _e3543 = select(_e3531, 0u, (select(select(_e2017, _e3537, (_e3537 < _e2017)), _e2017, (_e3531 == 1023u)) > _e3469));
                                            if (_e3543 < 1023u) {
                                                phi_6425_ = (_e3543 + 1u);
                                            } else {
                                                phi_6425_ = _e3543;
                                            }
                                            let _e3547 = phi_6425_;
                                            let _e3553 = (_e1980 + bitcast<f32>((bitcast<u32>((f32(_e3543) * _e3188)) ^ _e70)));
                                            let _e3567 = (_e1980 + bitcast<f32>((bitcast<u32>((f32(_e3547) * _e3188)) ^ _e70)));
                                            if _e3236 {
                                                phi_6494_ = (((_e3474 - _e1993) / _e3235) * 1023f);
                                            } else {
                                                phi_6494_ = 0f;
                                            }
                                            let _e3582 = phi_6494_;
                                            let _e3584 = select(1023f, _e3582, (_e3582 < 1023f));
                                            let _e3586 = select(0f, _e3584, (_e3584 > 0f));
                                            let _e3591 = select(select(u32(_e3586), 0u, (_e3586 < 0f)), 4294967295u, (_e3586 > 4294967000f));
                                            if (_e3591 > 0u) {
                                                let _e3598 = (_e1993 + bitcast<f32>((bitcast<u32>((f32(_e3591) * _e3300)) ^ _e70)));
                                                let _e3603 = (select(select(_e2030, _e3598, (_e3598 < _e2030)), _e2030, (_e3591 == 1023u)) > _e3474);
                                                if _e3603 {
                                                    phi_6545_ = (_e3591 - 1u);
                                                } else {
                                                    phi_6545_ = u32();
                                                }
                                                let _e3606 = phi_6545_;
                                                phi_6547_ = _e3606;
                                                phi_6548_ = select(true, false, _e3603);
                                            } else {
                                                phi_6547_ = u32();
                                                phi_6548_ = true;
                                            }
                                            let _e3609 = phi_6547_;
                                            let _e3611 = phi_6548_;
                                            if _e3611 {
                                                if (_e3591 < 1023u) {
                                                    let _e3613 = (_e3591 + 1u);
                                                    let _e3619 = (_e1993 + bitcast<f32>((bitcast<u32>((f32(_e3613) * _e3300)) ^ _e70)));
                                                    phi_6586_ = select(_e3591, _e3613, (select(select(_e2030, _e3619, (_e3619 < _e2030)), _e2030, (_e3613 == 1023u)) <= _e3474));
                                                } else {
                                                    phi_6586_ = _e3591;
                                                }
                                                let _e3627 = phi_6586_;
                                                phi_6587_ = _e3627;
                                            } else {
                                                phi_6587_ = _e3609;
                                            }
                                            let _e3629 = phi_6587_;
                                            let _e3635 = (_e1993 + bitcast<f32>((bitcast<u32>((f32(_e3629) * _e3300)) ^ _e70)));
                                            let _e3641 = select(_e3629, 0u, (select(select(_e2030, _e3635, (_e3635 < _e2030)), _e2030, (_e3629 == 1023u)) > _e3474));
                                            if (_e3641 < 1023u) {
                                                phi_6621_ = (_e3641 + 1u);
                                            } else {
                                                phi_6621_ = _e3641;
                                            }
                                            let _e3645 = phi_6621_;
                                            let _e3651 = (_e1993 + bitcast<f32>((bitcast<u32>((f32(_e3641) * _e3300)) ^ _e70)));
                                            let _e3665 = (_e1993 + bitcast<f32>((bitcast<u32>((f32(_e3645) * _e3300)) ^ _e70)));
                                            if _e3351 {
                                                phi_6692_ = (((_e3479 - _e2006) / _e3350) * 1023f);
                                            } else {
                                                phi_6692_ = 0f;
                                            }
                                            let _e3683 = phi_6692_;
                                            let _e3685 = select(1023f, _e3683, (_e3683 < 1023f));
                                            let _e3687 = select(0f, _e3685, (_e3685 > 0f));
                                            let _e3692 = select(select(u32(_e3687), 0u, (_e3687 < 0f)), 4294967295u, (_e3687 > 4294967000f));
                                            if (_e3692 > 0u) {
                                                let _e3699 = (_e2006 + bitcast<f32>((bitcast<u32>((f32(_e3692) * _e3415)) ^ _e70)));
                                                let _e3704 = (select(select(_e2043, _e3699, (_e3699 < _e2043)), _e2043, (_e3692 == 1023u)) > _e3479);
                                                if _e3704 {
                                                    phi_6743_ = (_e3692 - 1u);
                                                } else {
                                                    phi_6743_ = u32();
                                                }
                                                let _e3707 = phi_6743_;
                                                phi_6745_ = _e3707;
                                                phi_6746_ = select(true, false, _e3704);
                                            } else {
                                                phi_6745_ = u32();
                                                phi_6746_ = true;
                                            }
                                            let _e3710 = phi_6745_;
                                            let _e3712 = phi_6746_;
                                            if _e3712 {
                                                if (_e3692 < 1023u) {
                                                    let _e3714 = (_e3692 + 1u);
                                                    let _e3720 = (_e2006 + bitcast<f32>((bitcast<u32>((f32(_e3714) * _e3415)) ^ _e70)));
                                                    phi_6784_ = select(_e3692, _e3714, (select(select(_e2043, _e3720, (_e3720 < _e2043)), _e2043, (_e3714 == 1023u)) <= _e3479));
                                                } else {
                                                    phi_6784_ = _e3692;
                                                }
                                                let _e3728 = phi_6784_;
                                                phi_6785_ = _e3728;
                                            } else {
                                                phi_6785_ = _e3710;
                                            }
                                            let _e3730 = phi_6785_;
                                            let _e3736 = (_e2006 + bitcast<f32>((bitcast<u32>((f32(_e3730) * _e3415)) ^ _e70)));
                                            let _e3742 = select(_e3730, 0u, (select(select(_e2043, _e3736, (_e3736 < _e2043)), _e2043, (_e3730 == 1023u)) > _e3479));
                                            if (_e3742 < 1023u) {
                                                phi_6819_ = (_e3742 + 1u);
                                            } else {
                                                phi_6819_ = _e3742;
                                            }
                                            let _e3746 = phi_6819_;
                                            let _e3752 = (_e2006 + bitcast<f32>((bitcast<u32>((f32(_e3742) * _e3415)) ^ _e70)));
                                            let _e3766 = (_e2006 + bitcast<f32>((bitcast<u32>((f32(_e3746) * _e3415)) ^ _e70)));
                                            let _e3784 = global_2.member[_e3105].member[6u];
                                            let _e3789 = global_2.member[_e3105].member[7u];
                                            let _e3794 = global_2.member[_e3105].member[8u];
                                            if _e3124 {
                                                phi_6896_ = (((_e3784 - _e1980) / _e3123) * 1023f);
                                            } else {
                                                phi_6896_ = 0f;
                                            }
                                            let _e3799 = phi_6896_;
                                            let _e3801 = select(1023f, _e3799, (_e3799 < 1023f));
                                            let _e3803 = select(0f, _e3801, (_e3801 > 0f));
                                            let _e3808 = select(select(u32(_e3803), 0u, (_e3803 < 0f)), 4294967295u, (_e3803 > 4294967000f));
                                            if (_e3808 > 0u) {
                                                let _e3815 = (_e1980 + bitcast<f32>((bitcast<u32>((f32(_e3808) * _e3188)) ^ _e70)));
                                                let _e3820 = (select(select(_e2017, _e3815, (_e3815 < _e2017)), _e2017, (_e3808 == 1023u)) > _e3784);
                                                if _e3820 {
                                                    phi_6947_ = (_e3808 - 1u);
                                                } else {
                                                    phi_6947_ = u32();
                                                }
                                                let _e3823 = phi_6947_;
                                                phi_6949_ = _e3823;
                                                phi_6950_ = select(true, false, _e3820);
                                            } else {
                                                phi_6949_ = u32();
                                                phi_6950_ = true;
                                            }
                                            let _e3826 = phi_6949_;
                                            let _e3828 = phi_6950_;
                                            if _e3828 {
                                                if (_e3808 < 1023u) {
                                                    let _e3830 = (_e3808 + 1u);
                                                    let _e3836 = (_e1980 + bitcast<f32>((bitcast<u32>((f32(_e3830) * _e3188)) ^ _e70)));
                                                    phi_6988_ = select(_e3808, _e3830, (select(select(_e2017, _e3836, (_e3836 < _e2017)), _e2017, (_e3830 == 1023u)) <= _e3784));
                                                } else {
                                                    phi_6988_ = _e3808;
                                                }
                                                let _e3844 = phi_6988_;
                                                phi_6989_ = _e3844;
                                            } else {
                                                phi_6989_ = _e3826;
                                            }
                                            let _e3846 = phi_6989_;
                                            let _e3852 = (_e1980 + bitcast<f32>((bitcast<u32>((f32(_e3846) * _e3188)) ^ _e70)));
                                            let _e3858 = select(_e3846, 0u, (select(select(_e2017, _e3852, (_e3852 < _e2017)), _e2017, (_e3846 == 1023u)) > _e3784));
                                            if (_e3858 < 1023u) {
                                                phi_7023_ = (_e3858 + 1u);
                                            } else {
                                                phi_7023_ = _e3858;
                                            }
                                            let _e3862 = phi_7023_;
                                            let _e3868 = (_e1980 + bitcast<f32>((bitcast<u32>((f32(_e3858) * _e3188)) ^ _e70)));
                                            let _e3882 = (_e1980 + bitcast<f32>((bitcast<u32>((f32(_e3862) * _e3188)) ^ _e70)));
                                            if _e3236 {
                                                phi_7092_ = (((_e3789 - _e1993) / _e3235) * 1023f);
                                            } else {
                                                phi_7092_ = 0f;
                                            }
                                            let _e3897 = phi_7092_;
                                            let _e3899 = select(1023f, _e3897, (_e3897 < 1023f));
                                            let _e3901 = select(0f, _e3899, (_e3899 > 0f));
                                            let _e3906 = select(select(u32(_e3901), 0u, (_e3901 < 0f)), 4294967295u, (_e3901 > 4294967000f));
                                            if (_e3906 > 0u) {
                                                let _e3913 = (_e1993 + bitcast<f32>((bitcast<u32>((f32(_e3906) * _e3300)) ^ _e70)));
                                                let _e3918 = (select(select(_e2030, _e3913, (_e3913 < _e2030)), _e2030, (_e3906 == 1023u)) > _e3789);
                                                if _e3918 {
                                                    phi_7143_ = (_e3906 - 1u);
                                                } else {
                                                    phi_7143_ = u32();
                                                }
                                                let _e3921 = phi_7143_;
                                                phi_7145_ = _e3921;
                                                phi_7146_ = select(true, false, _e3918);
                                            } else {
                                                phi_7145_ = u32();
                                                phi_7146_ = true;
                                            }
                                            let _e3924 = phi_7145_;
                                            let _e3926 = phi_7146_;
                                            if _e3926 {
                                                if (_e3906 < 1023u) {
                                                    let _e3928 = (_e3906 + 1u);
                                                    let _e3934 = (_e1993 + bitcast<f32>((bitcast<u32>((f32(_e3928) * _e3300)) ^ _e70)));
                                                    phi_7184_ = select(_e3906, _e3928, (select(select(_e2030, _e3934, (_e3934 < _e2030)), _e2030, (_e3928 == 1023u)) <= _e3789));
                                                } else {
                                                    phi_7184_ = _e3906;
                                                }
                                                let _e3942 = phi_7184_;
                                                phi_7185_ = _e3942;
                                            } else {
                                                phi_7185_ = _e3924;
                                            }
                                            let _e3944 = phi_7185_;
                                            let _e3950 = (_e1993 + bitcast<f32>((bitcast<u32>((f32(_e3944) * _e3300)) ^ _e70)));
                                            let _e3956 = select(_e3944, 0u, (select(select(_e2030, _e3950, (_e3950 < _e2030)), _e2030, (_e3944 == 1023u)) > _e3789));
                                            if (_e3956 < 1023u) {
                                                phi_7219_ = (_e3956 + 1u);
                                            } else {
                                                phi_7219_ = _e3956;
                                            }
                                            let _e3960 = phi_7219_;
                                            let _e3966 = (_e1993 + bitcast<f32>((bitcast<u32>((f32(_e3956) * _e3300)) ^ _e70)));
                                            let _e3980 = (_e1993 + bitcast<f32>((bitcast<u32>((f32(_e3960) * _e3300)) ^ _e70)));
                                            if _e3351 {
                                                phi_7290_ = (((_e3794 - _e2006) / _e3350) * 1023f);
                                            } else {
                                                phi_7290_ = 0f;
                                            }
                                            let _e3998 = phi_7290_;
                                            let _e4000 = select(1023f, _e3998, (_e3998 < 1023f));
                                            let _e4002 = select(0f, _e4000, (_e4000 > 0f));
                                            let _e4007 = select(select(u32(_e4002), 0u, (_e4002 < 0f)), 4294967295u, (_e4002 > 4294967000f));
                                            if (_e4007 > 0u) {
                                                let _e4014 = (_e2006 + bitcast<f32>((bitcast<u32>((f32(_e4007) * _e3415)) ^ _e70)));
                                                let _e4019 = (select(select(_e2043, _e4014, (_e4014 < _e2043)), _e2043, (_e4007 == 1023u)) > _e3794);
                                                if _e4019 {
                                                    phi_7341_ = (_e4007 - 1u);
                                                } else {
                                                    phi_7341_ = u32();
                                                }
                                                let _e4022 = phi_7341_;
                                                phi_7343_ = _e4022;
                                                phi_7344_ = select(true, false, _e4019);
                                            } else {
                                                phi_7343_ = u32();
                                                phi_7344_ = true;
                                            }
                                            let _e4025 = phi_7343_;
                                            let _e4027 = phi_7344_;
                                            if _e4027 {
                                                if (_e4007 < 1023u) {
                                                    let _e4029 = (_e4007 + 1u);
                                                    let _e4035 = (_e2006 + bitcast<f32>((bitcast<u32>((f32(_e4029) * _e3415)) ^ _e70)));
                                                    phi_7382_ = select(_e4007, _e4029, (select(select(_e2043, _e4035, (_e4035 < _e2043)), _e2043, (_e4029 == 1023u)) <= _e3794));
                                                } else {
                                                    phi_7382_ = _e4007;
                                                }
                                                let _e4043 = phi_7382_;
                                                phi_7383_ = _e4043;
                                            } else {
                                                phi_7383_ = _e4025;
                                            }
                                            let _e4045 = phi_7383_;
                                            let _e4051 = (_e2006 + bitcast<f32>((bitcast<u32>((f32(_e4045) * _e3415)) ^ _e70)));
                                            let _e4057 = select(_e4045, 0u, (select(select(_e2043, _e4051, (_e4051 < _e2043)), _e2043, (_e4045 == 1023u)) > _e3794));
                                            if (_e4057 < 1023u) {
                                                phi_7417_ = (_e4057 + 1u);
                                            } else {
                                                phi_7417_ = _e4057;
                                            }
                                            let _e4061 = phi_7417_;
                                            let _e4067 = (_e2006 + bitcast<f32>((bitcast<u32>((f32(_e4057) * _e3415)) ^ _e70)));
                                            let _e4081 = (_e2006 + bitcast<f32>((bitcast<u32>((f32(_e4061) * _e3415)) ^ _e70)));
                                            let _e4099 = global_2.member[_e3105].member_1;
                                            if _e3107 {
                                            } else {
                                                phi_8097_ = true;
                                                break;
                                            }
                                            global_6.member[_e3105] = type_43(array<u32, 3>(((select(_e3200, _e3204, (bitcast<f32>((bitcast<u32>((select(select(_e2017, _e3224, (_e3224 < _e2017)), _e2017, (_e3204 == 1023u)) - _e3112)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3112 - select(select(_e2017, _e3210, (_e3210 < _e2017)), _e2017, (_e3200 == 1023u)))) & 2147483647u)))) | (select(_e3312, _e3316, (bitcast<f32>((bitcast<u32>((select(select(_e2030, _e3336, (_e3336 < _e2030)), _e2030, (_e3316 == 1023u)) - _e3117)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3117 - select(select(_e2030, _e3322, (_e3322 < _e2030)), _e2030, (_e3312 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e3427, _e3431, (bitcast<f32>((bitcast<u32>((select(select(_e2043, _e3451, (_e3451 < _e2043)), _e2043, (_e3431 == 1023u)) - _e3122)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3122 - select(select(_e2043, _e3437, (_e3437 < _e2043)), _e2043, (_e3427 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i))), ((select(_e3543, _e3547, (bitcast<f32>((bitcast<u32>((select(select(_e2017, _e3567, (_e3567 < _e2017)), _e2017, (_e3547 == 1023u)) - _e3469)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3469 - select(select(_e2017, _e3553, (_e3553 < _e2017)), _e2017, (_e3543 == 1023u)))) & 2147483647u)))) | (select(_e3641, _e3645, (bitcast<f32>((bitcast<u32>((select(select(_e2030, _e3665, (_e3665 < _e2030)), _e2030, (_e3645 == 1023u)) - _e3474)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3474 - select(select(_e2030, _e3651, (_e3651 < _e2030)), _e2030, (_e3641 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e3742, _e3746, (bitcast<f32>((bitcast<u32>((select(select(_e2043, _e3766, (_e3766 < _e2043)), _e2043, (_e3746 == 1023u)) - _e3479)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3479 - select(select(_e2043, _e3752, (_e3752 < _e2043)), _e2043, (_e3742 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i))), ((select(_e3858, _e3862, (bitcast<f32>((bitcast<u32>((select(select(_e2017, _e3882, (_e3882 < _e2017)), _e2017, (_e3862 == 1023u)) - _e3784)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3784 - select(select(_e2017, _e3868, (_e3868 < _e2017)), _e2017, (_e3858 == 1023u)))) & 2147483647u)))) | (select(_e3956, _e3960, (bitcast<f32>((bitcast<u32>((select(select(_e2030, _e3980, (_e3980 < _e2030)), _e2030, (_e3960 == 1023u)) - _e3789)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3789 - select(select(_e2030, _e3966, (_e3966 < _e2030)), _e2030, (_e3956 == 1023u)))) & 2147483647u)))) << bitcast<u32>(10i))) | (select(_e4057, _e4061, (bitcast<f32>((bitcast<u32>((select(select(_e2043, _e4081, (_e4081 < _e2043)), _e2043, (_e4061 == 1023u)) - _e3794)) & 2147483647u)) < bitcast<f32>((bitcast<u32>((_e3794 - select(select(_e2043, _e4067, (_e4067 < _e2043)), _e2043, (_e4057 == 1023u)))) & 2147483647u)))) << bitcast<u32>(20i)))), _e4099);
                                        }
                                    }
                                }
                                continue;
                                continuing {
                                    phi_5637_ = _e3097;
                                    phi_8097_ = _e3076;
                                    break if !(_e3103);
                                }
                            }
                            let _e4105 = phi_8097_;
                            if _e4105 {
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
                                global_7.member[0u] = type_32(array<u32, 4>(bitcast<u32>(_e922.member[0]), bitcast<u32>(_e922.member[1]), bitcast<u32>(_e922.member[2]), 0u), array<u32, 4>(bitcast<u32>(_e925.member_1[0]), bitcast<u32>(_e925.member_1[1]), bitcast<u32>(_e925.member_1[2]), 0u));
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
