struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: array<array<u32, 4>>,
}

struct type_15 {
    member: vec4<u32>,
}

struct type_20 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_22 {
    member: array<type_20>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_40 {
    member: array<type_29>,
}

struct type_42 {
    member: f32,
    member_1: bool,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: type_32,
    member_1: u32,
}

struct type_50 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_15;
@group(0) @binding(3) 
var<storage> global_2: type_22;
@group(0) @binding(1) 
var<uniform> global_3: type_44;
@group(0) @binding(2) 
var<storage> global_4: type_12;
@group(0) @binding(4) 
var<storage> global_5: type_40;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;

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
    var phi_365_: i32;
    var phi_366_: i32;
    var phi_376_: bool;
    var phi_386_: u32;
    var phi_387_: u32;
    var phi_389_: bool;
    var phi_394_: u32;
    var phi_406_: i32;
    var phi_426_: i32;
    var phi_444_: f32;
    var phi_450_: f32;
    var phi_461_: f32;
    var phi_467_: f32;
    var phi_490_: f32;
    var phi_501_: f32;
    var phi_510_: f32;
    var phi_516_: f32;
    var phi_527_: f32;
    var phi_533_: f32;
    var phi_556_: f32;
    var phi_567_: f32;
    var phi_576_: f32;
    var phi_582_: f32;
    var phi_593_: f32;
    var phi_599_: f32;
    var phi_622_: f32;
    var phi_633_: f32;
    var phi_733_: f32;
    var phi_734_: f32;
    var phi_3382_: bool;
    var phi_823_: type_42;
    var phi_826_: type_49;
    var phi_828_: u32;
    var phi_830_: bool;
    var phi_832_: u32;
    var phi_843_: bool;
    var phi_929_: type_49;
    var phi_930_: bool;
    var phi_931_: u32;
    var phi_2660_: u32;
    var phi_2661_: u32;
    var phi_2671_: u32;
    var phi_2673_: u32;
    var phi_2674_: bool;
    var phi_2694_: u32;
    var phi_2695_: u32;
    var phi_2699_: type_50;
    var phi_3043_: type_49;
    var phi_3120_: type_49;
    var phi_3121_: type_49;
    var phi_3122_: u32;
    var phi_3124_: type_49;
    var phi_3125_: u32;
    var phi_3126_: bool;
    var phi_3135_: type_49;
    var phi_3140_: type_49;
    var phi_3141_: bool;
    var phi_949_: type_42;
    var phi_952_: type_7;
    var phi_953_: type_7;
    var phi_975_: type_7;
    var phi_996_: u32;
    var phi_1085_: array<array<f32, 3>, 3>;
    var phi_1202_: bool;
    var phi_1231_: bool;
    var phi_1632_: f32;
    var phi_1633_: f32;
    var phi_1634_: f32;
    var phi_1635_: f32;
    var phi_1636_: vec3<f32>;
    var phi_1637_: vec3<f32>;
    var phi_1638_: vec3<f32>;
    var phi_1639_: vec3<f32>;
    var phi_1670_: bool;
    var phi_1679_: vec3<f32>;
    var phi_1844_: f32;
    var phi_1846_: f32;
    var phi_1847_: bool;
    var phi_1867_: f32;
    var phi_1868_: f32;
    var phi_1891_: type_28;
    var phi_1893_: type_28;
    var phi_1894_: bool;
    var phi_1898_: type_28;
    var phi_1899_: type_28;
    var phi_1900_: type_28;
    var phi_1901_: bool;
    var phi_1905_: type_28;
    var phi_1906_: bool;
    var phi_1907_: type_28;
    var phi_1908_: bool;
    var phi_1909_: bool;
    var phi_1910_: type_28;
    var phi_1911_: bool;
    var phi_1912_: bool;
    var phi_1920_: type_28;
    var phi_1921_: bool;
    var phi_1925_: type_28;
    var phi_1936_: type_42;
    var phi_1937_: type_42;
    var phi_950_: type_42;
    var phi_3376_: bool;
    var local_10: type_42;
    var phi_3519_: bool;
    var phi_3143_: type_42;
    var phi_3144_: type_49;
    var phi_3145_: bool;
    var phi_3146_: u32;
    var phi_3518_: bool;
    var phi_3147_: type_42;
    var phi_3148_: type_49;
    var phi_3149_: u32;
    var phi_3150_: bool;
    var phi_3151_: u32;
    var phi_3517_: bool;
    var phi_3152_: type_42;
    var phi_3153_: type_49;
    var phi_3154_: u32;
    var phi_3155_: bool;
    var phi_3156_: u32;
    var phi_3516_: bool;
    var phi_824_: type_42;
    var phi_827_: type_49;
    var phi_829_: u32;
    var phi_831_: bool;
    var phi_833_: u32;
    var phi_3157_: bool;
    var phi_3515_: bool;
    var local_11: type_42;
    var local_12: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e85 = global;
            let _e87 = arrayLength((&global_4.member));
            let _e89 = arrayLength((&global_2.member));
            let _e97 = global_3.member[0u][0u];
            let _e101 = global_3.member[0u][1u];
            let _e105 = global_3.member[0u][2u];
            let _e109 = global_3.member[0u][3u];
            let _e113 = global_3.member[1u][0u];
            let _e117 = global_3.member[1u][1u];
            let _e121 = global_3.member[1u][2u];
            let _e124 = global_1.member[0u];
            let _e125 = bitcast<i32>(_e124);
            let _e137 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e109) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e97), bitcast<i32>(_e101), bitcast<i32>(_e105));
            local = array<i32, 3>(bitcast<i32>(_e113), bitcast<i32>(_e117), bitcast<i32>(_e121));
            let _e143 = (_e85.x + (_e85.y * 2097152u));
            let _e144 = (_e143 < arrayLength((&global_5.member)));
            if _e144 {
                let _e145 = (_e143 < arrayLength((&global_6.member)));
                if _e145 {
                    if _e144 {
                    } else {
                        break;
                    }
                    let _e153 = global_5.member[_e143].member_2[0u];
                    let _e155 = (bitcast<u32>(_e153) & 2147483647u);
                    let _e160 = global_5.member[_e143].member_2[1u];
                    let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                    let _e167 = global_5.member[_e143].member_2[2u];
                    let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                    let _e174 = global_5.member[_e143].member[0u];
                    let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                    let _e181 = global_5.member[_e143].member[1u];
                    let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                    let _e188 = global_5.member[_e143].member[2u];
                    let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                    let _e192 = select(_e162, _e155, (_e162 < _e155));
                    let _e194 = select(_e169, _e192, (_e169 < _e192));
                    let _e196 = select(_e176, _e194, (_e176 < _e194));
                    let _e198 = select(_e183, _e196, (_e183 < _e196));
                    let _e200 = select(_e190, _e198, (_e190 < _e198));
                    let _e204 = global_5.member[_e143].member_1;
                    let _e206 = (bitcast<u32>(_e204) & 2147483647u);
                    let _e213 = global_5.member[_e143].member_3;
                    let _e219 = (((select(_e206, _e200, (_e206 < _e200)) < 2139095040u) && ((bitcast<u32>(_e213) & 2147483647u) <= 2139095040u)) && (_e194 > 0u));
                    if _e219 {
                        let _e222 = (bitcast<u32>(bitcast<f32>(_e194)) & 2147483647u);
                        if (_e222 >= 8388608u) {
                            phi_365_ = (bitcast<i32>((_e222 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_365_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e222)), 32u, (_e222 == 0u))));
                        }
                        let _e236 = phi_365_;
                        phi_366_ = _e236;
                    } else {
                        phi_366_ = 0i;
                    }
                    let _e238 = phi_366_;
                    let _e239 = (_e155 == _e194);
                    if _e239 {
                        phi_376_ = true;
                    } else {
                        phi_376_ = (_e162 == _e194);
                    }
                    let _e242 = phi_376_;
                    let _e243 = select(1u, 0u, _e239);
                    if _e242 {
                        let _e244 = (_e243 + 1u);
                        phi_386_ = _e244;
                        phi_387_ = _e244;
                        phi_389_ = select(true, false, (_e244 == 2u));
                    } else {
                        phi_386_ = u32();
                        phi_387_ = 0u;
                        phi_389_ = true;
                    }
                    let _e248 = phi_386_;
                    let _e250 = phi_387_;
                    let _e252 = phi_389_;
                    if _e252 {
                        phi_394_ = (_e250 + 1u);
                    } else {
                        phi_394_ = 0u;
                    }
                    let _e256 = phi_394_;
                    let _e257 = select(_e248, _e250, _e252);
                    let _e258 = select(_e243, select(2u, _e243, _e242), _e252);
                    if (_e125 < -126i) {
                        phi_406_ = -126i;
                    } else {
                        phi_406_ = select(_e125, 127i, (_e125 > 127i));
                    }
                    let _e263 = phi_406_;
                    let _e268 = bitcast<f32>((bitcast<u32>((_e263 + 127i)) << bitcast<u32>(23i)));
                    let _e274 = bitcast<f32>((bitcast<u32>(((_e125 - _e263) + 127i)) << bitcast<u32>(23i)));
                    let _e275 = -(_e238);
                    if (_e275 < -126i) {
                        phi_426_ = -126i;
                    } else {
                        phi_426_ = select(_e275, 127i, (_e275 > 127i));
                    }
                    let _e280 = phi_426_;
                    let _e285 = bitcast<f32>((bitcast<u32>((_e280 + 127i)) << bitcast<u32>(23i)));
                    let _e291 = bitcast<f32>((bitcast<u32>(((_e275 - _e280) + 127i)) << bitcast<u32>(23i)));
                    let _e295 = global_5.member[_e143].member;
                    let _e296 = (_e257 == 0u);
                    if _e296 {
                        phi_444_ = _e295[0];
                    } else {
                        phi_444_ = _e295[1];
                    }
                    let _e300 = phi_444_;
                    let _e301 = (_e257 == 2u);
                    if _e301 {
                        phi_450_ = _e295[2];
                    } else {
                        phi_450_ = _e300;
                    }
                    let _e304 = phi_450_;
                    let _e306 = ((_e304 * _e268) * _e274);
                    let _e307 = global_5.member[_e143].member_2;
                    if _e296 {
                        phi_461_ = _e307[0];
                    } else {
                        phi_461_ = _e307[1];
                    }
                    let _e311 = phi_461_;
                    if _e301 {
                        phi_467_ = _e307[2];
                    } else {
                        phi_467_ = _e311;
                    }
                    let _e314 = phi_467_;
                    let _e316 = ((_e314 * _e285) * _e291);
                    let _e320 = (bitcast<f32>((bitcast<u32>(_e316) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e320 {
                        let _e324 = (bitcast<f32>((bitcast<u32>(_e306) & 2147483647u)) * 0.00000011920929f);
                        phi_490_ = select(0.00000000000011368684f, _e324, (_e324 > 0.00000000000011368684f));
                    } else {
                        phi_490_ = 0f;
                    }
                    let _e328 = phi_490_;
                    let _e329 = (_e306 + _e328);
                    let _e330 = (_e306 - _e328);
                    let _e331 = select(_e316, 0f, _e320);
                    if _e320 {
                        phi_501_ = 38685626000000000000000000f;
                    } else {
                        phi_501_ = (1f / _e316);
                    }
                    let _e334 = phi_501_;
                    let _e335 = (_e256 == 0u);
                    if _e335 {
                        phi_510_ = _e295[0];
                    } else {
                        phi_510_ = _e295[1];
                    }
                    let _e339 = phi_510_;
                    let _e340 = (_e256 == 2u);
                    if _e340 {
                        phi_516_ = _e295[2];
                    } else {
                        phi_516_ = _e339;
                    }
                    let _e343 = phi_516_;
                    let _e345 = ((_e343 * _e268) * _e274);
                    if _e335 {
                        phi_527_ = _e307[0];
                    } else {
                        phi_527_ = _e307[1];
                    }
                    let _e349 = phi_527_;
                    if _e340 {
                        phi_533_ = _e307[2];
                    } else {
                        phi_533_ = _e349;
                    }
                    let _e352 = phi_533_;
                    let _e354 = ((_e352 * _e285) * _e291);
                    let _e358 = (bitcast<f32>((bitcast<u32>(_e354) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e358 {
                        let _e362 = (bitcast<f32>((bitcast<u32>(_e345) & 2147483647u)) * 0.00000011920929f);
                        phi_556_ = select(0.00000000000011368684f, _e362, (_e362 > 0.00000000000011368684f));
                    } else {
                        phi_556_ = 0f;
                    }
                    let _e366 = phi_556_;
                    let _e367 = (_e345 + _e366);
                    let _e368 = (_e345 - _e366);
                    let _e369 = select(_e354, 0f, _e358);
                    if _e358 {
                        phi_567_ = 38685626000000000000000000f;
                    } else {
                        phi_567_ = (1f / _e354);
                    }
                    let _e372 = phi_567_;
                    let _e373 = (_e258 == 0u);
                    if _e373 {
                        phi_576_ = _e295[0];
                    } else {
                        phi_576_ = _e295[1];
                    }
                    let _e377 = phi_576_;
                    let _e378 = (_e258 == 2u);
                    if _e378 {
                        phi_582_ = _e295[2];
                    } else {
                        phi_582_ = _e377;
                    }
                    let _e381 = phi_582_;
                    let _e383 = ((_e381 * _e268) * _e274);
                    if _e373 {
                        phi_593_ = _e307[0];
                    } else {
                        phi_593_ = _e307[1];
                    }
                    let _e387 = phi_593_;
                    if _e378 {
                        phi_599_ = _e307[2];
                    } else {
                        phi_599_ = _e387;
                    }
                    let _e390 = phi_599_;
                    let _e392 = ((_e390 * _e285) * _e291);
                    let _e396 = (bitcast<f32>((bitcast<u32>(_e392) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e396 {
                        let _e400 = (bitcast<f32>((bitcast<u32>(_e383) & 2147483647u)) * 0.00000011920929f);
                        phi_622_ = select(0.00000000000011368684f, _e400, (_e400 > 0.00000000000011368684f));
                    } else {
                        phi_622_ = 0f;
                    }
                    let _e404 = phi_622_;
                    let _e405 = (_e383 + _e404);
                    let _e406 = (_e383 - _e404);
                    let _e407 = select(_e392, 0f, _e396);
                    if _e396 {
                        phi_633_ = 38685626000000000000000000f;
                    } else {
                        phi_633_ = (1f / _e392);
                    }
                    let _e410 = phi_633_;
                    let _e413 = bitcast<f32>((bitcast<u32>(_e306) & 2147483647u));
                    let _e416 = bitcast<f32>((bitcast<u32>(_e345) & 2147483647u));
                    let _e418 = select(_e416, _e413, (_e413 > _e416));
                    let _e421 = bitcast<f32>((bitcast<u32>(_e383) & 2147483647u));
                    let _e424 = (_e125 + _e238);
                    if (_e219 && (select(_e421, _e418, (_e418 > _e421)) <= 1099511600000f)) {
                        let _e427 = (_e424 / 3i);
                        let _e434 = bitcast<f32>((bitcast<u32>((_e427 + 127i)) << bitcast<u32>(23i)));
                        let _e441 = bitcast<f32>((bitcast<u32>(((_e424 - (2i * _e427)) + 127i)) << bitcast<u32>(23i)));
                        let _e442 = (((_e204 * _e434) * _e434) * _e441);
                        let _e444 = select(340282350000000000000000000000000000000f, _e442, (_e442 < 340282350000000000000000000000000000000f));
                        let _e449 = (((_e213 * _e434) * _e434) * _e441);
                        let _e451 = select(340282350000000000000000000000000000000f, _e449, (_e449 < 340282350000000000000000000000000000000f));
                        phi_733_ = select(-340282350000000000000000000000000000000f, _e451, (_e451 > -340282350000000000000000000000000000000f));
                        phi_734_ = select(-340282350000000000000000000000000000000f, _e444, (_e444 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_733_ = 0f;
                        phi_734_ = 1f;
                    }
                    let _e455 = phi_733_;
                    let _e457 = phi_734_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e461 = (_e257 % 3u);
                    let _e462 = (_e461 < 3u);
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e464 = local_1[_e461];
                    let _e467 = (_e256 % 3u);
                    let _e468 = (_e467 < 3u);
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e470 = local_1[_e467];
                    let _e473 = (_e258 % 3u);
                    let _e474 = (_e473 < 3u);
                    if _e474 {
                    } else {
                        break;
                    }
                    let _e476 = local_1[_e473];
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e481 = local[_e461];
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e485 = local[_e467];
                    if _e474 {
                    } else {
                        break;
                    }
                    let _e489 = local[_e473];
                    phi_3382_ = false;
                    phi_823_ = type_42(_e455, false);
                    phi_826_ = type_49(type_32(vec4<f32>((f32(_e464) * _e137), (f32(_e470) * _e137), (f32(_e476) * _e137), 0f), vec4<f32>((f32(_e481) * _e137), (f32(_e485) * _e137), (f32(_e489) * _e137), 0f)), select(0u, 2147483648u, (_e87 == 0u)));
                    phi_828_ = ((3u * _e87) + 1u);
                    phi_830_ = (_e457 <= _e455);
                    phi_832_ = 0u;
                    loop {
                        let _e499 = phi_3382_;
                        let _e501 = phi_823_;
                        let _e503 = phi_826_;
                        let _e505 = phi_828_;
                        let _e507 = phi_830_;
                        let _e509 = phi_832_;
                        local_11 = _e501;
                        if _e507 {
                            phi_843_ = true;
                        } else {
                            phi_843_ = (_e509 > 0u);
                        }
                        let _e512 = phi_843_;
                        if _e512 {
                            let _e513 = (_e505 > 0u);
                            if _e513 {
                                if _e507 {
                                    phi_929_ = _e503;
                                    phi_930_ = _e507;
                                    phi_931_ = _e509;
                                } else {
                                    let _e514 = (_e509 - 1u);
                                    let _e515 = (_e514 % 128u);
                                    let _e516 = (_e515 < 128u);
                                    if _e516 {
                                    } else {
                                        phi_3515_ = true;
                                        break;
                                    }
                                    let _e518 = local_7[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3515_ = true;
                                        break;
                                    }
                                    let _e520 = local_6[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3515_ = true;
                                        break;
                                    }
                                    let _e522 = local_5[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3515_ = true;
                                        break;
                                    }
                                    let _e524 = local_4[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3515_ = true;
                                        break;
                                    }
                                    let _e526 = local_3[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3515_ = true;
                                        break;
                                    }
                                    let _e528 = local_2[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3515_ = true;
                                        break;
                                    }
                                    let _e533 = local_8[_e515];
                                    if _e516 {
                                    } else {
                                        phi_3515_ = true;
                                        break;
                                    }
                                    let _e536 = local_9[_e515];
                                    phi_929_ = type_49(type_32(vec4<f32>(_e518, _e520, _e522, 0f), vec4<f32>(_e524, _e526, _e528, 0f)), _e533);
                                    phi_930_ = (_e536 <= _e501.member);
                                    phi_931_ = _e514;
                                }
                                let _e540 = phi_929_;
                                let _e542 = phi_930_;
                                let _e544 = phi_931_;
                                if _e542 {
                                    if ((_e540.member_1 & 2147483648u) != 0u) {
                                        phi_949_ = _e501;
                                        phi_952_ = type_7(0u, ((_e540.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e988 = phi_949_;
                                            let _e990 = phi_952_;
                                            local_10 = _e988;
                                            local_12 = _e988;
                                            if (_e990.member < _e990.member_1) {
                                                phi_953_ = type_7((_e990.member + 1u), _e990.member_1);
                                                phi_975_ = type_7(1u, _e990.member);
                                            } else {
                                                phi_953_ = _e990;
                                                phi_975_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e1003 = phi_953_;
                                            let _e1005 = phi_975_;
                                            let _e1009 = (bitcast<i32>(_e1005.member) != 0i);
                                            if _e1009 {
                                                let _e1010 = ((_e540.member_1 & 268435455u) + _e1005.member_1);
                                                let _e1011 = (_e1010 < _e89);
                                                if _e1011 {
                                                    if _e1011 {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1015 = global_2.member[_e1010].member_1;
                                                    phi_996_ = _e1015;
                                                } else {
                                                    phi_996_ = 4294967295u;
                                                }
                                                let _e1017 = phi_996_;
                                                if (_e1010 >= _e89) {
                                                    phi_1085_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1011 {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    if (_e461 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1024 = global_2.member[_e1010].member[_e461];
                                                    if (_e467 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1030 = global_2.member[_e1010].member[_e467];
                                                    if (_e473 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1036 = global_2.member[_e1010].member[_e473];
                                                    let _e1038 = (3u + _e461);
                                                    if (_e1038 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1044 = global_2.member[_e1010].member[_e1038];
                                                    let _e1045 = (3u + _e467);
                                                    if (_e1045 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1051 = global_2.member[_e1010].member[_e1045];
                                                    let _e1052 = (3u + _e473);
                                                    if (_e1052 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1058 = global_2.member[_e1010].member[_e1052];
                                                    let _e1060 = (6u + _e461);
                                                    if (_e1060 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1066 = global_2.member[_e1010].member[_e1060];
                                                    let _e1067 = (6u + _e467);
                                                    if (_e1067 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1073 = global_2.member[_e1010].member[_e1067];
                                                    let _e1074 = (6u + _e473);
                                                    if (_e1074 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1080 = global_2.member[_e1010].member[_e1074];
                                                    phi_1085_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1024, _e1030, _e1036), array<f32, 3>(_e1044, _e1051, _e1058), array<f32, 3>(_e1066, _e1073, _e1080));
                                                }
                                                let _e1084 = phi_1085_;
                                                let _e1092 = (_e1084[0][2] - _e383);
                                                let _e1095 = (((_e1084[0][0] - _e306) * _e407) - (_e1092 * _e331));
                                                let _e1098 = (((_e1084[0][1] - _e345) * _e407) - (_e1092 * _e369));
                                                let _e1105 = (_e1084[1][2] - _e383);
                                                let _e1108 = (((_e1084[1][0] - _e306) * _e407) - (_e1105 * _e331));
                                                let _e1111 = (((_e1084[1][1] - _e345) * _e407) - (_e1105 * _e369));
                                                let _e1118 = (_e1084[2][2] - _e383);
                                                let _e1121 = (((_e1084[2][0] - _e306) * _e407) - (_e1118 * _e331));
                                                let _e1124 = (((_e1084[2][1] - _e345) * _e407) - (_e1118 * _e369));
                                                let _e1125 = (_e1121 * _e1111);
                                                let _e1126 = (_e1124 * _e1108);
                                                let _e1127 = (_e1095 * _e1124);
                                                let _e1128 = (_e1098 * _e1121);
                                                let _e1129 = (_e1108 * _e1098);
                                                let _e1130 = (_e1111 * _e1095);
                                                let _e1135 = (((_e1125 >= _e1126) && (_e1127 >= _e1128)) && (_e1129 >= _e1130));
                                                if (_e1135 || (((_e1125 <= _e1126) && (_e1127 <= _e1128)) && (_e1129 <= _e1130))) {
                                                    let _e1142 = select(-1f, 1f, _e1135);
                                                    let _e1144 = ((_e1125 - _e1126) * _e1142);
                                                    let _e1146 = select(0f, _e1144, (_e1144 > 0f));
                                                    let _e1148 = ((_e1127 - _e1128) * _e1142);
                                                    let _e1150 = select(0f, _e1148, (_e1148 > 0f));
                                                    let _e1152 = ((_e1129 - _e1130) * _e1142);
                                                    let _e1154 = select(0f, _e1152, (_e1152 > 0f));
                                                    let _e1156 = ((_e1146 + _e1150) + _e1154);
                                                    if (_e1156 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1910_ = type_28();
                                                        phi_1911_ = true;
                                                        phi_1912_ = false;
                                                    } else {
                                                        let _e1159 = select(_e1108, _e1095, (_e1095 < _e1108));
                                                        if (select(_e1121, _e1159, (_e1159 < _e1121)) > 0f) {
                                                            phi_1202_ = true;
                                                        } else {
                                                            let _e1164 = select(_e1108, _e1095, (_e1095 > _e1108));
                                                            phi_1202_ = (select(_e1121, _e1164, (_e1164 > _e1121)) < 0f);
                                                        }
                                                        let _e1169 = phi_1202_;
                                                        if _e1169 {
                                                            phi_1907_ = type_28();
                                                            phi_1908_ = true;
                                                            phi_1909_ = false;
                                                        } else {
                                                            let _e1171 = select(_e1111, _e1098, (_e1098 < _e1111));
                                                            if (select(_e1124, _e1171, (_e1171 < _e1124)) > 0f) {
                                                                phi_1231_ = true;
                                                            } else {
                                                                let _e1176 = select(_e1111, _e1098, (_e1098 > _e1111));
                                                                phi_1231_ = (select(_e1124, _e1176, (_e1176 > _e1124)) < 0f);
                                                            }
                                                            let _e1181 = phi_1231_;
                                                            if _e1181 {
                                                                phi_1905_ = type_28();
                                                                phi_1906_ = false;
                                                            } else {
                                                                let _e1183 = select(_e1084[1][0], _e1084[0][0], (_e1084[0][0] < _e1084[1][0]));
                                                                let _e1187 = select(_e1084[1][0], _e1084[0][0], (_e1084[0][0] > _e1084[1][0]));
                                                                let _e1191 = select(_e1084[1][1], _e1084[0][1], (_e1084[0][1] < _e1084[1][1]));
                                                                let _e1195 = select(_e1084[1][1], _e1084[0][1], (_e1084[0][1] > _e1084[1][1]));
                                                                let _e1199 = select(_e1084[1][2], _e1084[0][2], (_e1084[0][2] < _e1084[1][2]));
                                                                let _e1203 = select(_e1084[1][2], _e1084[0][2], (_e1084[0][2] > _e1084[1][2]));
                                                                let _e1208 = ((select(_e1084[2][0], _e1183, (_e1183 < _e1084[2][0])) - _e329) * _e334);
                                                                let _e1209 = ((select(_e1084[2][0], _e1187, (_e1187 > _e1084[2][0])) - _e330) * _e334);
                                                                let _e1212 = ((select(_e1084[2][1], _e1191, (_e1191 < _e1084[2][1])) - _e367) * _e372);
                                                                let _e1213 = ((select(_e1084[2][1], _e1195, (_e1195 > _e1084[2][1])) - _e368) * _e372);
                                                                let _e1216 = ((select(_e1084[2][2], _e1199, (_e1199 < _e1084[2][2])) - _e405) * _e410);
                                                                let _e1217 = ((select(_e1084[2][2], _e1203, (_e1203 > _e1084[2][2])) - _e406) * _e410);
                                                                let _e1219 = select(_e1217, _e1216, (_e1216 < _e1217));
                                                                let _e1221 = select(_e1217, _e1216, (_e1216 > _e1217));
                                                                let _e1223 = select(_e1209, _e1208, (_e1208 < _e1209));
                                                                let _e1225 = select(_e1213, _e1212, (_e1212 < _e1213));
                                                                let _e1227 = select(_e1225, _e1223, (_e1223 > _e1225));
                                                                let _e1229 = select(_e1219, _e1227, (_e1227 > _e1219));
                                                                let _e1231 = select(_e1209, _e1208, (_e1208 > _e1209));
                                                                let _e1233 = select(_e1213, _e1212, (_e1212 > _e1213));
                                                                let _e1235 = select(_e1233, _e1231, (_e1231 < _e1233));
                                                                let _e1237 = select(_e1221, _e1235, (_e1235 < _e1221));
                                                                let _e1238 = -(_e1219);
                                                                let _e1244 = select(_e457, _e1229, (_e1229 > _e457));
                                                                if (_e1244 > (_e1237 + (select(_e1238, _e1221, (_e1221 > _e1238)) * 0.0000019073523f))) {
                                                                    phi_1900_ = type_28();
                                                                    phi_1901_ = true;
                                                                } else {
                                                                    let _e1246 = (_e1244 > _e988.member);
                                                                    if _e1246 {
                                                                        phi_1899_ = type_28();
                                                                    } else {
                                                                        let _e1247 = vec3<f32>(_e1084[0][0], _e1084[0][1], _e1084[0][2]);
                                                                        let _e1248 = vec3<f32>(_e1084[1][0], _e1084[1][1], _e1084[1][2]);
                                                                        let _e1249 = vec3<f32>(_e1084[2][0], _e1084[2][1], _e1084[2][2]);
                                                                        let _e1250 = (_e1084[1][0] - _e1084[0][0]);
                                                                        let _e1251 = (_e1084[1][1] - _e1084[0][1]);
                                                                        let _e1252 = (_e1084[1][2] - _e1084[0][2]);
                                                                        let _e1253 = vec3<f32>(_e1250, _e1251, _e1252);
                                                                        let _e1254 = (_e1084[2][0] - _e1084[1][0]);
                                                                        let _e1255 = (_e1084[2][1] - _e1084[1][1]);
                                                                        let _e1256 = (_e1084[2][2] - _e1084[1][2]);
                                                                        let _e1257 = vec3<f32>(_e1254, _e1255, _e1256);
                                                                        let _e1258 = (_e1084[0][0] - _e1084[2][0]);
                                                                        let _e1259 = (_e1084[0][1] - _e1084[2][1]);
                                                                        let _e1260 = (_e1084[0][2] - _e1084[2][2]);
                                                                        let _e1261 = vec3<f32>(_e1258, _e1259, _e1260);
                                                                        let _e1264 = bitcast<f32>((bitcast<u32>(_e1250) & 2147483647u));
                                                                        let _e1267 = bitcast<f32>((bitcast<u32>(_e1251) & 2147483647u));
                                                                        let _e1269 = select(_e1267, _e1264, (_e1264 > _e1267));
                                                                        let _e1272 = bitcast<f32>((bitcast<u32>(_e1252) & 2147483647u));
                                                                        let _e1274 = select(_e1272, _e1269, (_e1269 > _e1272));
                                                                        let _e1277 = bitcast<f32>((bitcast<u32>(_e1254) & 2147483647u));
                                                                        let _e1280 = bitcast<f32>((bitcast<u32>(_e1255) & 2147483647u));
                                                                        let _e1282 = select(_e1280, _e1277, (_e1277 > _e1280));
                                                                        let _e1285 = bitcast<f32>((bitcast<u32>(_e1256) & 2147483647u));
                                                                        let _e1287 = select(_e1285, _e1282, (_e1282 > _e1285));
                                                                        let _e1290 = bitcast<f32>((bitcast<u32>(_e1258) & 2147483647u));
                                                                        let _e1293 = bitcast<f32>((bitcast<u32>(_e1259) & 2147483647u));
                                                                        let _e1295 = select(_e1293, _e1290, (_e1290 > _e1293));
                                                                        let _e1298 = bitcast<f32>((bitcast<u32>(_e1260) & 2147483647u));
                                                                        let _e1300 = select(_e1298, _e1295, (_e1295 > _e1298));
                                                                        let _e1302 = select(_e1287, _e1274, (_e1274 > _e1287));
                                                                        let _e1304 = select(_e1300, _e1302, (_e1302 > _e1300));
                                                                        if (_e1274 == _e1304) {
                                                                            phi_1632_ = _e1111;
                                                                            phi_1633_ = _e1108;
                                                                            phi_1634_ = _e1098;
                                                                            phi_1635_ = _e1095;
                                                                            phi_1636_ = _e1247;
                                                                            phi_1637_ = _e1261;
                                                                            phi_1638_ = _e1257;
                                                                            phi_1639_ = _e1253;
                                                                        } else {
                                                                            let _e1306 = (_e1287 == _e1304);
                                                                            let _e1311 = vec3(_e1306);
                                                                            phi_1632_ = select(_e1098, _e1124, _e1306);
                                                                            phi_1633_ = select(_e1095, _e1121, _e1306);
                                                                            phi_1634_ = select(_e1124, _e1111, _e1306);
                                                                            phi_1635_ = select(_e1121, _e1108, _e1306);
                                                                            phi_1636_ = select(_e1249, _e1248, _e1311);
                                                                            phi_1637_ = select(_e1257, _e1253, _e1311);
                                                                            phi_1638_ = select(_e1253, _e1261, _e1311);
                                                                            phi_1639_ = select(_e1261, _e1257, _e1311);
                                                                        }
                                                                        let _e1317 = phi_1632_;
                                                                        let _e1319 = phi_1633_;
                                                                        let _e1321 = phi_1634_;
                                                                        let _e1323 = phi_1635_;
                                                                        let _e1325 = phi_1636_;
                                                                        let _e1327 = phi_1637_;
                                                                        let _e1329 = phi_1638_;
                                                                        let _e1331 = phi_1639_;
                                                                        let _e1338 = ((_e1329.y * _e1327.z) - (_e1327.y * _e1329.z));
                                                                        let _e1343 = ((_e1329.z * _e1327.x) - (_e1327.z * _e1329.x));
                                                                        let _e1346 = ((_e1329.x * _e1327.y) - (_e1327.x * _e1329.y));
                                                                        if (_e1146 >= _e1150) {
                                                                            phi_1670_ = select(true, false, (_e1146 >= _e1154));
                                                                        } else {
                                                                            phi_1670_ = true;
                                                                        }
                                                                        let _e1351 = phi_1670_;
                                                                        if _e1351 {
                                                                            phi_1679_ = select(_e1249, _e1248, vec3((_e1150 >= _e1154)));
                                                                        } else {
                                                                            phi_1679_ = _e1247;
                                                                        }
                                                                        let _e1356 = phi_1679_;
                                                                        let _e1367 = (((_e1338 * (_e1356.x - _e306)) + (_e1343 * (_e1356.y - _e345))) + (_e1346 * (_e1356.z - _e383)));
                                                                        let _e1372 = (((_e1338 * _e331) + (_e1343 * _e369)) + (_e1346 * _e407));
                                                                        let _e1373 = (_e1319 - _e1323);
                                                                        let _e1374 = (_e1317 - _e1321);
                                                                        let _e1382 = (-(((_e1323 * _e1373) + (_e1321 * _e1374))) / ((_e1373 * _e1373) + (_e1374 * _e1374)));
                                                                        let _e1384 = select(1f, _e1382, (_e1382 < 1f));
                                                                        let _e1386 = select(0f, _e1384, (_e1384 > 0f));
                                                                        let _e1399 = ((_e1325.x + (_e1331.x * _e1386)) - _e306);
                                                                        let _e1400 = ((_e1325.y + (_e1331.y * _e1386)) - _e345);
                                                                        let _e1401 = ((_e1325.z + (_e1331.z * _e1386)) - _e383);
                                                                        let _e1402 = (_e1401 / _e407);
                                                                        let _e1414 = bitcast<f32>((bitcast<u32>(_e1399) & 2147483647u));
                                                                        let _e1417 = bitcast<f32>((bitcast<u32>(_e1400) & 2147483647u));
                                                                        let _e1419 = select(_e1417, _e1414, (_e1414 > _e1417));
                                                                        let _e1422 = bitcast<f32>((bitcast<u32>(_e1401) & 2147483647u));
                                                                        let _e1424 = select(_e1422, _e1419, (_e1419 > _e1422));
                                                                        let _e1430 = bitcast<f32>((bitcast<u32>(_e1338) & 2147483647u));
                                                                        let _e1433 = bitcast<f32>((bitcast<u32>(_e1343) & 2147483647u));
                                                                        let _e1435 = select(_e1433, _e1430, (_e1430 > _e1433));
                                                                        let _e1438 = bitcast<f32>((bitcast<u32>(_e1346) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1338 * _e1399) + (_e1343 * _e1400)) + (_e1346 * _e1401)) - _e1367)) & 2147483647u)) <= ((0.0000009536743f * select(_e1304, _e1424, (_e1424 > _e1304))) * select(_e1438, _e1435, (_e1435 > _e1438)))) {
                                                                            let _e1448 = bitcast<f32>((bitcast<u32>(_e1329.x) & 2147483647u));
                                                                            let _e1451 = bitcast<f32>((bitcast<u32>(_e1329.y) & 2147483647u));
                                                                            let _e1453 = select(_e1451, _e1448, (_e1448 > _e1451));
                                                                            let _e1456 = bitcast<f32>((bitcast<u32>(_e1329.z) & 2147483647u));
                                                                            let _e1462 = bitcast<f32>((bitcast<u32>(_e1327.x) & 2147483647u));
                                                                            let _e1465 = bitcast<f32>((bitcast<u32>(_e1327.y) & 2147483647u));
                                                                            let _e1467 = select(_e1465, _e1462, (_e1462 > _e1465));
                                                                            let _e1470 = bitcast<f32>((bitcast<u32>(_e1327.z) & 2147483647u));
                                                                            let _e1474 = (bitcast<f32>((bitcast<u32>(_e1372) & 2147483647u)) > ((0.0000038146973f * select(_e1456, _e1453, (_e1453 > _e1456))) * select(_e1470, _e1467, (_e1467 > _e1470))));
                                                                            if _e1474 {
                                                                                phi_1844_ = (_e1367 / _e1372);
                                                                            } else {
                                                                                phi_1844_ = f32();
                                                                            }
                                                                            let _e1477 = phi_1844_;
                                                                            phi_1846_ = _e1477;
                                                                            phi_1847_ = select(true, false, _e1474);
                                                                        } else {
                                                                            phi_1846_ = f32();
                                                                            phi_1847_ = true;
                                                                        }
                                                                        let _e1480 = phi_1846_;
                                                                        let _e1482 = phi_1847_;
                                                                        if _e1482 {
                                                                            let _e1490 = (((_e1338 * (_e1399 - (_e331 * _e1402))) + (_e1343 * (_e1400 - (_e369 * _e1402)))) / _e1372);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1490) & 2147483647u)) <= _e1304) {
                                                                                phi_1867_ = (_e1402 + _e1490);
                                                                            } else {
                                                                                phi_1867_ = _e1402;
                                                                            }
                                                                            let _e1497 = phi_1867_;
                                                                            phi_1868_ = _e1497;
                                                                        } else {
                                                                            phi_1868_ = _e1480;
                                                                        }
                                                                        let _e1499 = phi_1868_;
                                                                        let _e1501 = select(_e1237, _e1499, (_e1499 < _e1237));
                                                                        let _e1503 = select(_e1229, _e1501, (_e1501 > _e1229));
                                                                        if (_e1503 >= _e457) {
                                                                            let _e1505 = (_e1503 <= _e988.member);
                                                                            if _e1505 {
                                                                                let _e1506 = (1f / _e1156);
                                                                                phi_1891_ = type_28(_e1503, (_e1150 * _e1506), (_e1154 * _e1506), _e1017);
                                                                            } else {
                                                                                phi_1891_ = type_28();
                                                                            }
                                                                            let _e1511 = phi_1891_;
                                                                            phi_1893_ = _e1511;
                                                                            phi_1894_ = select(true, false, _e1505);
                                                                        } else {
                                                                            phi_1893_ = type_28();
                                                                            phi_1894_ = true;
                                                                        }
                                                                        let _e1514 = phi_1893_;
                                                                        let _e1516 = phi_1894_;
                                                                        if _e1516 {
                                                                            phi_1898_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1898_ = _e1514;
                                                                        }
                                                                        let _e1518 = phi_1898_;
                                                                        phi_1899_ = _e1518;
                                                                    }
                                                                    let _e1520 = phi_1899_;
                                                                    phi_1900_ = _e1520;
                                                                    phi_1901_ = _e1246;
                                                                }
                                                                let _e1522 = phi_1900_;
                                                                let _e1524 = phi_1901_;
                                                                phi_1905_ = _e1522;
                                                                phi_1906_ = _e1524;
                                                            }
                                                            let _e1526 = phi_1905_;
                                                            let _e1528 = phi_1906_;
                                                            phi_1907_ = _e1526;
                                                            phi_1908_ = _e1181;
                                                            phi_1909_ = _e1528;
                                                        }
                                                        let _e1530 = phi_1907_;
                                                        let _e1532 = phi_1908_;
                                                        let _e1534 = phi_1909_;
                                                        phi_1910_ = _e1530;
                                                        phi_1911_ = _e1532;
                                                        phi_1912_ = _e1534;
                                                    }
                                                    let _e1536 = phi_1910_;
                                                    let _e1538 = phi_1911_;
                                                    let _e1540 = phi_1912_;
                                                    phi_1920_ = _e1536;
                                                    phi_1921_ = select(_e1540, true, _e1538);
                                                } else {
                                                    phi_1920_ = type_28();
                                                    phi_1921_ = true;
                                                }
                                                let _e1543 = phi_1920_;
                                                let _e1545 = phi_1921_;
                                                if _e1545 {
                                                    phi_1925_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1925_ = _e1543;
                                                }
                                                let _e1547 = phi_1925_;
                                                if (_e1547.member_3 != 4294967295u) {
                                                    if (_e1017 != 4294967295u) {
                                                        phi_1936_ = type_42(_e988.member, true);
                                                    } else {
                                                        phi_1936_ = _e988;
                                                    }
                                                    let _e1555 = phi_1936_;
                                                    phi_1937_ = _e1555;
                                                } else {
                                                    phi_1937_ = _e988;
                                                }
                                                let _e1557 = phi_1937_;
                                                phi_950_ = _e1557;
                                            } else {
                                                phi_950_ = type_42();
                                            }
                                            let _e1559 = phi_950_;
                                            continue;
                                            continuing {
                                                phi_949_ = _e1559;
                                                phi_952_ = _e1003;
                                                phi_3376_ = _e499;
                                                break if !(_e1009);
                                            }
                                        }
                                        let _e1562 = phi_3376_;
                                        phi_3515_ = _e1562;
                                        if _e1562 {
                                            break;
                                        }
                                        let _e1564 = local_10;
                                        phi_3519_ = _e1562;
                                        let _e1730 = local_12;
                                        phi_3143_ = _e1730;
                                        phi_3144_ = _e540;
                                        phi_3145_ = false;
                                        phi_3146_ = select(_e544, 0u, _e1564.member_1);
                                    } else {
                                        if (_e540.member_1 >= _e87) {
                                            phi_2699_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e540.member_1 < _e87) {
                                            } else {
                                                phi_3515_ = true;
                                                break;
                                            }
                                            let _e556 = ((1u + _e257) % 4u);
                                            if (_e556 < 4u) {
                                            } else {
                                                phi_3515_ = true;
                                                break;
                                            }
                                            let _e561 = global_4.member[_e540.member_1][_e556];
                                            let _e563 = (_e561 >> bitcast<u32>(11u));
                                            let _e565 = ((1u + _e256) % 4u);
                                            if (_e565 < 4u) {
                                            } else {
                                                phi_3515_ = true;
                                                break;
                                            }
                                            let _e570 = global_4.member[_e540.member_1][_e565];
                                            let _e572 = (_e570 >> bitcast<u32>(11u));
                                            let _e574 = ((1u + _e258) % 4u);
                                            if (_e574 < 4u) {
                                            } else {
                                                phi_3515_ = true;
                                                break;
                                            }
                                            let _e579 = global_4.member[_e540.member_1][_e574];
                                            let _e581 = (_e579 >> bitcast<u32>(11u));
                                            let _e604 = (bitcast<f32>((bitcast<u32>((_e540.member.member_1.x - _e540.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e605 = (bitcast<f32>((bitcast<u32>((_e540.member.member_1.y - _e540.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e606 = (bitcast<f32>((bitcast<u32>((_e540.member.member_1.z - _e540.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e608 = select(_e137, _e604, (_e604 > _e137));
                                            let _e610 = select(_e137, _e605, (_e605 > _e137));
                                            let _e612 = select(_e137, _e606, (_e606 > _e137));
                                            let _e637 = bitcast<u32>((f32(bitcast<i32>((_e561 & 1023u))) * _e608));
                                            let _e642 = (bitcast<i32>((_e561 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e645 = bitcast<f32>((_e637 & bitcast<u32>(_e642)));
                                            let _e646 = bitcast<u32>((f32(bitcast<i32>((_e570 & 1023u))) * _e610));
                                            let _e651 = (bitcast<i32>((_e570 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e654 = bitcast<f32>((_e646 & bitcast<u32>(_e651)));
                                            let _e655 = bitcast<u32>((f32(bitcast<i32>((_e579 & 1023u))) * _e612));
                                            let _e660 = (bitcast<i32>((_e579 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e663 = bitcast<f32>((_e655 & bitcast<u32>(_e660)));
                                            let _e667 = bitcast<f32>((_e637 & bitcast<u32>(~(_e642))));
                                            let _e671 = bitcast<f32>((_e646 & bitcast<u32>(~(_e651))));
                                            let _e675 = bitcast<f32>((_e655 & bitcast<u32>(~(_e660))));
                                            let _e676 = bitcast<u32>((f32(bitcast<i32>((_e563 & 1023u))) * _e608));
                                            let _e681 = (bitcast<i32>((_e563 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e684 = bitcast<f32>((_e676 & bitcast<u32>(_e681)));
                                            let _e685 = bitcast<u32>((f32(bitcast<i32>((_e572 & 1023u))) * _e610));
                                            let _e690 = (bitcast<i32>((_e572 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e693 = bitcast<f32>((_e685 & bitcast<u32>(_e690)));
                                            let _e694 = bitcast<u32>((f32(bitcast<i32>((_e581 & 1023u))) * _e612));
                                            let _e699 = (bitcast<i32>((_e581 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e702 = bitcast<f32>((_e694 & bitcast<u32>(_e699)));
                                            let _e706 = bitcast<f32>((_e676 & bitcast<u32>(~(_e681))));
                                            let _e710 = bitcast<f32>((_e685 & bitcast<u32>(~(_e690))));
                                            let _e714 = bitcast<f32>((_e694 & bitcast<u32>(~(_e699))));
                                            let _e744 = global_4.member[_e540.member_1][0u];
                                            let _e748 = global_4.member[_e540.member_1][1u];
                                            let _e752 = global_4.member[_e540.member_1][2u];
                                            let _e756 = global_4.member[_e540.member_1][3u];
                                            let _e768 = (((_e748 >> bitcast<u32>(22i)) | ((_e752 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e756 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e769 = (_e744 & 268435455u);
                                            let _e770 = (_e768 & 268435455u);
                                            let _e773 = ((_e744 >> bitcast<u32>(28u)) & 7u);
                                            let _e781 = ((_e744 >> bitcast<u32>(31i)) | (((_e768 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e782 = (_e773 != 0u);
                                            if (_e773 == 0u) {
                                                phi_2661_ = _e769;
                                            } else {
                                                if (_e773 == 7u) {
                                                    phi_2660_ = 2147483648u;
                                                } else {
                                                    phi_2660_ = ((2147483648u | (_e773 << bitcast<u32>(28u))) | (_e770 & 268435455u));
                                                }
                                                let _e791 = phi_2660_;
                                                phi_2661_ = _e791;
                                            }
                                            let _e793 = phi_2661_;
                                            if _e782 {
                                                let _e794 = (_e773 != 7u);
                                                if _e794 {
                                                    phi_2671_ = (_e770 + _e773);
                                                } else {
                                                    phi_2671_ = u32();
                                                }
                                                let _e797 = phi_2671_;
                                                phi_2673_ = _e797;
                                                phi_2674_ = select(true, false, _e794);
                                            } else {
                                                phi_2673_ = u32();
                                                phi_2674_ = true;
                                            }
                                            let _e800 = phi_2673_;
                                            let _e802 = phi_2674_;
                                            if (_e781 == 0u) {
                                                phi_2695_ = (_e769 + select(0u, 1u, !(_e782)));
                                            } else {
                                                if (_e781 == 7u) {
                                                    phi_2694_ = 2147483648u;
                                                } else {
                                                    phi_2694_ = ((2147483648u | (_e781 << bitcast<u32>(28u))) | (select(_e800, _e770, _e802) & 268435455u));
                                                }
                                                let _e815 = phi_2694_;
                                                phi_2695_ = _e815;
                                            }
                                            let _e817 = phi_2695_;
                                            phi_2699_ = type_50(array<vec4<f32>, 3>(vec4<f32>((_e540.member.member.x + _e645), (_e540.member.member.x + _e667), (_e540.member.member_1.x - _e684), (_e540.member.member_1.x - _e706)), vec4<f32>((_e540.member.member.y + _e654), (_e540.member.member.y + _e671), (_e540.member.member_1.y - _e693), (_e540.member.member_1.y - _e710)), vec4<f32>((_e540.member.member.z + _e663), (_e540.member.member.z + _e675), (_e540.member.member_1.z - _e702), (_e540.member.member_1.z - _e714))), type_49(type_32((_e540.member.member + vec4<f32>(_e645, _e654, _e663, 0f)), (_e540.member.member_1 - vec4<f32>(_e684, _e693, _e702, 0f))), _e793), type_49(type_32((_e540.member.member + vec4<f32>(_e667, _e671, _e675, 0f)), (_e540.member.member_1 - vec4<f32>(_e706, _e710, _e714, 0f))), _e817));
                                        }
                                        let _e822 = phi_2699_;
                                        let _e834 = ((_e822.member[0].x - _e329) * _e334);
                                        let _e835 = ((_e822.member[0].y - _e329) * _e334);
                                        let _e836 = ((_e822.member[0].z - _e330) * _e334);
                                        let _e837 = ((_e822.member[0].w - _e330) * _e334);
                                        let _e847 = ((_e822.member[1].x - _e367) * _e372);
                                        let _e848 = ((_e822.member[1].y - _e367) * _e372);
                                        let _e849 = ((_e822.member[1].z - _e368) * _e372);
                                        let _e850 = ((_e822.member[1].w - _e368) * _e372);
                                        let _e860 = ((_e822.member[2].x - _e405) * _e410);
                                        let _e861 = ((_e822.member[2].y - _e405) * _e410);
                                        let _e862 = ((_e822.member[2].z - _e406) * _e410);
                                        let _e863 = ((_e822.member[2].w - _e406) * _e410);
                                        let _e865 = select(_e862, _e860, (_e860 < _e862));
                                        let _e867 = select(_e863, _e861, (_e861 < _e863));
                                        let _e869 = select(_e862, _e860, (_e860 > _e862));
                                        let _e871 = select(_e863, _e861, (_e861 > _e863));
                                        let _e873 = select(_e836, _e834, (_e834 < _e836));
                                        let _e875 = select(_e837, _e835, (_e835 < _e837));
                                        let _e877 = select(_e849, _e847, (_e847 < _e849));
                                        let _e879 = select(_e850, _e848, (_e848 < _e850));
                                        let _e881 = select(_e877, _e873, (_e873 > _e877));
                                        let _e883 = select(_e879, _e875, (_e875 > _e879));
                                        let _e885 = select(_e865, _e881, (_e881 > _e865));
                                        let _e887 = select(_e867, _e883, (_e883 > _e867));
                                        let _e889 = select(_e836, _e834, (_e834 > _e836));
                                        let _e891 = select(_e837, _e835, (_e835 > _e837));
                                        let _e893 = select(_e849, _e847, (_e847 > _e849));
                                        let _e895 = select(_e850, _e848, (_e848 > _e850));
                                        let _e897 = select(_e893, _e889, (_e889 < _e893));
                                        let _e899 = select(_e895, _e891, (_e891 < _e895));
                                        let _e904 = -(_e865);
                                        let _e905 = -(_e867);
                                        let _e912 = (select(_e869, _e897, (_e897 < _e869)) + (select(_e904, _e869, (_e869 > _e904)) * 0.0000019073523f));
                                        let _e913 = (select(_e871, _e899, (_e899 < _e871)) + (select(_e905, _e871, (_e871 > _e905)) * 0.0000019073523f));
                                        let _e915 = select(_e457, _e885, (_e885 > _e457));
                                        let _e917 = select(_e457, _e887, (_e887 > _e457));
                                        let _e922 = (_e915 <= select(_e501.member, _e912, (_e912 < _e501.member)));
                                        let _e923 = (_e917 <= select(_e501.member, _e913, (_e913 < _e501.member)));
                                        let _e924 = (_e915 <= _e917);
                                        if _e922 {
                                            if _e923 {
                                                if _e924 {
                                                    phi_3043_ = _e822.member_2;
                                                } else {
                                                    phi_3043_ = _e822.member_1;
                                                }
                                                let _e928 = phi_3043_;
                                                let _e950 = (_e544 % 128u);
                                                let _e951 = (_e950 < 128u);
                                                if _e951 {
                                                } else {
                                                    phi_3515_ = true;
                                                    break;
                                                }
                                                local_8[_e950] = _e928.member_1;
                                                if _e951 {
                                                } else {
                                                    phi_3515_ = true;
                                                    break;
                                                }
                                                local_7[_e950] = _e928.member.member.x;
                                                if _e951 {
                                                } else {
                                                    phi_3515_ = true;
                                                    break;
                                                }
                                                local_6[_e950] = _e928.member.member.y;
                                                if _e951 {
                                                } else {
                                                    phi_3515_ = true;
                                                    break;
                                                }
                                                local_5[_e950] = _e928.member.member.z;
                                                if _e951 {
                                                } else {
                                                    phi_3515_ = true;
                                                    break;
                                                }
                                                local_4[_e950] = _e928.member.member_1.x;
                                                if _e951 {
                                                } else {
                                                    phi_3515_ = true;
                                                    break;
                                                }
                                                local_3[_e950] = _e928.member.member_1.y;
                                                if _e951 {
                                                } else {
                                                    phi_3515_ = true;
                                                    break;
                                                }
                                                local_2[_e950] = _e928.member.member_1.z;
                                                if _e951 {
                                                } else {
                                                    phi_3515_ = true;
                                                    break;
                                                }
                                                local_9[_e950] = select(_e917, _e915, (_e915 > _e917));
                                                if _e924 {
                                                    phi_3120_ = _e822.member_1;
                                                } else {
                                                    phi_3120_ = _e822.member_2;
                                                }
                                                let _e964 = phi_3120_;
                                                phi_3121_ = _e964;
                                                phi_3122_ = (_e544 + 1u);
                                            } else {
                                                phi_3121_ = type_49();
                                                phi_3122_ = u32();
                                            }
                                            let _e966 = phi_3121_;
                                            let _e968 = phi_3122_;
                                            phi_3124_ = _e966;
                                            phi_3125_ = _e968;
                                            phi_3126_ = select(true, false, _e923);
                                        } else {
                                            phi_3124_ = type_49();
                                            phi_3125_ = u32();
                                            phi_3126_ = true;
                                        }
                                        let _e971 = phi_3124_;
                                        let _e973 = phi_3125_;
                                        let _e975 = phi_3126_;
                                        if _e975 {
                                            if _e922 {
                                                phi_3135_ = _e822.member_1;
                                            } else {
                                                phi_3135_ = _e822.member_2;
                                            }
                                            let _e979 = phi_3135_;
                                            phi_3140_ = _e979;
                                            phi_3141_ = select(_e923, true, _e922);
                                        } else {
                                            phi_3140_ = _e971;
                                            phi_3141_ = _e542;
                                        }
                                        let _e982 = phi_3140_;
                                        let _e984 = phi_3141_;
                                        phi_3519_ = _e499;
                                        phi_3143_ = _e501;
                                        phi_3144_ = _e982;
                                        phi_3145_ = _e984;
                                        phi_3146_ = select(_e973, _e544, _e975);
                                    }
                                    let _e1568 = phi_3519_;
                                    let _e1570 = phi_3143_;
                                    let _e1572 = phi_3144_;
                                    let _e1574 = phi_3145_;
                                    let _e1576 = phi_3146_;
                                    phi_3518_ = _e1568;
                                    phi_3147_ = _e1570;
                                    phi_3148_ = _e1572;
                                    phi_3149_ = (_e505 - 1u);
                                    phi_3150_ = _e1574;
                                    phi_3151_ = _e1576;
                                } else {
                                    phi_3518_ = _e499;
                                    phi_3147_ = _e501;
                                    phi_3148_ = _e540;
                                    phi_3149_ = _e505;
                                    phi_3150_ = _e542;
                                    phi_3151_ = _e544;
                                }
                                let _e1578 = phi_3518_;
                                let _e1580 = phi_3147_;
                                let _e1582 = phi_3148_;
                                let _e1584 = phi_3149_;
                                let _e1586 = phi_3150_;
                                let _e1588 = phi_3151_;
                                phi_3517_ = _e1578;
                                phi_3152_ = _e1580;
                                phi_3153_ = _e1582;
                                phi_3154_ = _e1584;
                                phi_3155_ = _e1586;
                                phi_3156_ = _e1588;
                            } else {
                                phi_3517_ = _e499;
                                phi_3152_ = type_42();
                                phi_3153_ = type_49();
                                phi_3154_ = u32();
                                phi_3155_ = bool();
                                phi_3156_ = u32();
                            }
                            let _e1590 = phi_3517_;
                            let _e1592 = phi_3152_;
                            let _e1594 = phi_3153_;
                            let _e1596 = phi_3154_;
                            let _e1598 = phi_3155_;
                            let _e1600 = phi_3156_;
                            phi_3516_ = _e1590;
                            phi_824_ = _e1592;
                            phi_827_ = _e1594;
                            phi_829_ = _e1596;
                            phi_831_ = _e1598;
                            phi_833_ = _e1600;
                            phi_3157_ = _e513;
                        } else {
                            phi_3516_ = _e499;
                            phi_824_ = type_42();
                            phi_827_ = type_49();
                            phi_829_ = u32();
                            phi_831_ = bool();
                            phi_833_ = u32();
                            phi_3157_ = false;
                        }
                        let _e1602 = phi_3516_;
                        let _e1604 = phi_824_;
                        let _e1606 = phi_827_;
                        let _e1608 = phi_829_;
                        let _e1610 = phi_831_;
                        let _e1612 = phi_833_;
                        let _e1614 = phi_3157_;
                        continue;
                        continuing {
                            phi_3382_ = _e1602;
                            phi_823_ = _e1604;
                            phi_826_ = _e1606;
                            phi_828_ = _e1608;
                            phi_830_ = _e1610;
                            phi_832_ = _e1612;
                            phi_3515_ = _e1602;
                            break if !(_e1614);
                        }
                    }
                    let _e1617 = phi_3515_;
                    if _e1617 {
                        break;
                    }
                    let _e1619 = local_11;
                    if _e145 {
                    } else {
                        break;
                    }
                    global_6.member[_e143] = select(0u, 1u, _e1619.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
