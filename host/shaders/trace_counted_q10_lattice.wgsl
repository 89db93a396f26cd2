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

struct type_24 {
    member: array<array<u32, 2>>,
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

struct type_36 {
    member: type_28,
    member_1: f32,
}

struct type_41 {
    member: array<type_29>,
}

struct type_43 {
    member: type_36,
    member_1: u32,
    member_2: u32,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: type_32,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_45;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_41;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_24;

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
    var phi_395_: i32;
    var phi_396_: i32;
    var phi_406_: bool;
    var phi_416_: u32;
    var phi_417_: u32;
    var phi_419_: bool;
    var phi_424_: u32;
    var phi_436_: i32;
    var phi_456_: i32;
    var phi_474_: f32;
    var phi_480_: f32;
    var phi_491_: f32;
    var phi_497_: f32;
    var phi_520_: f32;
    var phi_531_: f32;
    var phi_540_: f32;
    var phi_546_: f32;
    var phi_557_: f32;
    var phi_563_: f32;
    var phi_586_: f32;
    var phi_597_: f32;
    var phi_606_: f32;
    var phi_612_: f32;
    var phi_623_: f32;
    var phi_629_: f32;
    var phi_652_: f32;
    var phi_663_: f32;
    var phi_763_: f32;
    var phi_764_: f32;
    var phi_4047_: bool;
    var phi_854_: type_43;
    var phi_857_: type_50;
    var phi_859_: u32;
    var phi_861_: bool;
    var phi_863_: u32;
    var phi_874_: bool;
    var phi_960_: type_50;
    var phi_961_: bool;
    var phi_962_: u32;
    var phi_3078_: u32;
    var phi_3084_: u32;
    var phi_3338_: u32;
    var phi_3339_: u32;
    var phi_3349_: u32;
    var phi_3351_: u32;
    var phi_3352_: bool;
    var phi_3372_: u32;
    var phi_3373_: u32;
    var phi_3377_: type_51;
    var phi_3721_: type_50;
    var phi_3798_: type_50;
    var phi_3799_: type_50;
    var phi_3800_: u32;
    var phi_3802_: type_50;
    var phi_3803_: u32;
    var phi_3804_: bool;
    var phi_3813_: type_50;
    var phi_3818_: type_50;
    var phi_3819_: bool;
    var phi_981_: type_43;
    var phi_984_: type_8;
    var phi_985_: type_8;
    var phi_1007_: type_8;
    var phi_1051_: u32;
    var phi_1057_: u32;
    var phi_1067_: u32;
    var phi_1083_: u32;
    var phi_1116_: u32;
    var phi_1122_: u32;
    var phi_1549_: u32;
    var phi_1567_: u32;
    var phi_1585_: u32;
    var phi_1605_: u32;
    var phi_1623_: u32;
    var phi_1641_: u32;
    var phi_1661_: u32;
    var phi_1679_: u32;
    var phi_1697_: u32;
    var phi_1275_: u32;
    var phi_1290_: u32;
    var phi_1300_: u32;
    var phi_1320_: u32;
    var phi_1340_: u32;
    var phi_1366_: u32;
    var phi_1381_: u32;
    var phi_1391_: u32;
    var phi_1411_: u32;
    var phi_1431_: u32;
    var phi_1457_: u32;
    var phi_1472_: u32;
    var phi_1482_: u32;
    var phi_1502_: u32;
    var phi_1522_: u32;
    var phi_1146_: u32;
    var phi_1189_: u32;
    var phi_1232_: u32;
    var phi_1703_: array<array<f32, 3>, 3>;
    var phi_1820_: bool;
    var phi_1849_: bool;
    var phi_2250_: f32;
    var phi_2251_: f32;
    var phi_2252_: f32;
    var phi_2253_: f32;
    var phi_2254_: vec3<f32>;
    var phi_2255_: vec3<f32>;
    var phi_2256_: vec3<f32>;
    var phi_2257_: vec3<f32>;
    var phi_2288_: bool;
    var phi_2297_: vec3<f32>;
    var phi_2462_: f32;
    var phi_2464_: f32;
    var phi_2465_: bool;
    var phi_2485_: f32;
    var phi_2486_: f32;
    var phi_2509_: type_28;
    var phi_2511_: type_28;
    var phi_2512_: bool;
    var phi_2516_: type_28;
    var phi_2517_: type_28;
    var phi_2518_: type_28;
    var phi_2519_: bool;
    var phi_2523_: type_28;
    var phi_2524_: bool;
    var phi_2525_: type_28;
    var phi_2526_: bool;
    var phi_2527_: bool;
    var phi_2528_: type_28;
    var phi_2529_: bool;
    var phi_2530_: bool;
    var phi_2538_: type_28;
    var phi_2539_: bool;
    var phi_2543_: type_28;
    var phi_2568_: bool;
    var phi_2569_: bool;
    var phi_2576_: type_43;
    var phi_2577_: type_43;
    var phi_2578_: type_43;
    var phi_982_: type_43;
    var phi_4041_: bool;
    var phi_4234_: bool;
    var phi_3821_: type_43;
    var phi_3822_: type_50;
    var phi_3823_: bool;
    var phi_3824_: u32;
    var phi_4233_: bool;
    var phi_3825_: type_43;
    var phi_3826_: type_50;
    var phi_3827_: u32;
    var phi_3828_: bool;
    var phi_3829_: u32;
    var phi_4232_: bool;
    var phi_3830_: type_43;
    var phi_3831_: type_50;
    var phi_3832_: u32;
    var phi_3833_: bool;
    var phi_3834_: u32;
    var phi_4231_: bool;
    var phi_855_: type_43;
    var phi_858_: type_50;
    var phi_860_: u32;
    var phi_862_: bool;
    var phi_864_: u32;
    var phi_3835_: bool;
    var phi_4230_: bool;
    var local_10: type_43;
    var local_11: type_43;
    var local_12: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e91 = global;
            let _e93 = arrayLength((&global_3.member));
            let _e96 = arrayLength((&global_5.member));
            let _e104 = global_2.member[0u][0u];
            let _e108 = global_2.member[0u][1u];
            let _e112 = global_2.member[0u][2u];
            let _e116 = global_2.member[0u][3u];
            let _e120 = global_2.member[1u][0u];
            let _e124 = global_2.member[1u][1u];
            let _e128 = global_2.member[1u][2u];
            let _e131 = global_1.member[0u];
            let _e132 = bitcast<i32>(_e131);
            let _e144 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e116) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e104), bitcast<i32>(_e108), bitcast<i32>(_e112));
            local = array<i32, 3>(bitcast<i32>(_e120), bitcast<i32>(_e124), bitcast<i32>(_e128));
            let _e150 = (_e91.x + (_e91.y * 2097152u));
            let _e151 = (_e150 < arrayLength((&global_4.member)));
            if _e151 {
                let _e152 = (_e150 < arrayLength((&global_6.member)));
                if _e152 {
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e160 = global_4.member[_e150].member_2[0u];
                    let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                    let _e167 = global_4.member[_e150].member_2[1u];
                    let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                    let _e174 = global_4.member[_e150].member_2[2u];
                    let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                    let _e181 = global_4.member[_e150].member[0u];
                    let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                    let _e188 = global_4.member[_e150].member[1u];
                    let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                    let _e195 = global_4.member[_e150].member[2u];
                    let _e197 = (bitcast<u32>(_e195) & 2147483647u);
                    let _e199 = select(_e169, _e162, (_e169 < _e162));
                    let _e201 = select(_e176, _e199, (_e176 < _e199));
                    let _e203 = select(_e183, _e201, (_e183 < _e201));
                    let _e205 = select(_e190, _e203, (_e190 < _e203));
                    let _e207 = select(_e197, _e205, (_e197 < _e205));
                    let _e211 = global_4.member[_e150].member_1;
                    let _e213 = (bitcast<u32>(_e211) & 2147483647u);
                    let _e220 = global_4.member[_e150].member_3;
                    let _e226 = (((select(_e213, _e207, (_e213 < _e207)) < 2139095040u) && ((bitcast<u32>(_e220) & 2147483647u) <= 2139095040u)) && (_e201 > 0u));
                    if _e226 {
                        let _e229 = (bitcast<u32>(bitcast<f32>(_e201)) & 2147483647u);
                        if (_e229 >= 8388608u) {
                            phi_395_ = (bitcast<i32>((_e229 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_395_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e229)), 32u, (_e229 == 0u))));
                        }
                        let _e243 = phi_395_;
                        phi_396_ = _e243;
                    } else {
                        phi_396_ = 0i;
                    }
                    let _e245 = phi_396_;
                    let _e246 = (_e162 == _e201);
                    if _e246 {
                        phi_406_ = true;
                    } else {
                        phi_406_ = (_e169 == _e201);
                    }
                    let _e249 = phi_406_;
                    let _e250 = select(1u, 0u, _e246);
                    if _e249 {
                        let _e251 = (_e250 + 1u);
                        phi_416_ = _e251;
                        phi_417_ = _e251;
                        phi_419_ = select(true, false, (_e251 == 2u));
                    } else {
                        phi_416_ = u32();
                        phi_417_ = 0u;
                        phi_419_ = true;
                    }
                    let _e255 = phi_416_;
                    let _e257 = phi_417_;
                    let _e259 = phi_419_;
                    if _e259 {
                        phi_424_ = (_e257 + 1u);
                    } else {
                        phi_424_ = 0u;
                    }
                    let _e263 = phi_424_;
                    let _e264 = select(_e255, _e257, _e259);
                    let _e265 = select(_e250, select(2u, _e250, _e249), _e259);
                    if (_e132 < -126i) {
                        phi_436_ = -126i;
                    } else {
                        phi_436_ = select(_e132, 127i, (_e132 > 127i));
                    }
                    let _e270 = phi_436_;
                    let _e275 = bitcast<f32>((bitcast<u32>((_e270 + 127i)) << bitcast<u32>(23i)));
                    let _e281 = bitcast<f32>((bitcast<u32>(((_e132 - _e270) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = -(_e245);
                    if (_e282 < -126i) {
                        phi_456_ = -126i;
                    } else {
                        phi_456_ = select(_e282, 127i, (_e282 > 127i));
                    }
                    let _e287 = phi_456_;
                    let _e292 = bitcast<f32>((bitcast<u32>((_e287 + 127i)) << bitcast<u32>(23i)));
                    let _e298 = bitcast<f32>((bitcast<u32>(((_e282 - _e287) + 127i)) << bitcast<u32>(23i)));
                    let _e302 = global_4.member[_e150].member;
                    let _e303 = (_e264 == 0u);
                    if _e303 {
                        phi_474_ = _e302[0];
                    } else {
                        phi_474_ = _e302[1];
                    }
                    let _e307 = phi_474_;
                    let _e308 = (_e264 == 2u);
                    if _e308 {
                        phi_480_ = _e302[2];
                    } else {
                        phi_480_ = _e307;
                    }
                    let _e311 = phi_480_;
                    let _e313 = ((_e311 * _e275) * _e281);
                    let _e314 = global_4.member[_e150].member_2;
                    if _e303 {
                        phi_491_ = _e314[0];
                    } else {
                        phi_491_ = _e314[1];
                    }
                    let _e318 = phi_491_;
                    if _e308 {
                        phi_497_ = _e314[2];
                    } else {
                        phi_497_ = _e318;
                    }
                    let _e321 = phi_497_;
                    let _e323 = ((_e321 * _e292) * _e298);
                    let _e327 = (bitcast<f32>((bitcast<u32>(_e323) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e327 {
                        let _e331 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) * 0.00000011920929f);
                        phi_520_ = select(0.00000000000011368684f, _e331, (_e331 > 0.00000000000011368684f));
                    } else {
                        phi_520_ = 0f;
                    }
                    let _e335 = phi_520_;
                    let _e336 = (_e313 + _e335);
                    let _e337 = (_e313 - _e335);
                    let _e338 = select(_e323, 0f, _e327);
                    if _e327 {
                        phi_531_ = 38685626000000000000000000f;
                    } else {
                        phi_531_ = (1f / _e323);
                    }
                    let _e341 = phi_531_;
                    let _e342 = (_e263 == 0u);
                    if _e342 {
                        phi_540_ = _e302[0];
                    } else {
                        phi_540_ = _e302[1];
                    }
                    let _e346 = phi_540_;
                    let _e347 = (_e263 == 2u);
                    if _e347 {
                        phi_546_ = _e302[2];
                    } else {
                        phi_546_ = _e346;
                    }
                    let _e350 = phi_546_;
                    let _e352 = ((_e350 * _e275) * _e281);
                    if _e342 {
                        phi_557_ = _e314[0];
                    } else {
                        phi_557_ = _e314[1];
                    }
                    let _e356 = phi_557_;
                    if _e347 {
                        phi_563_ = _e314[2];
                    } else {
                        phi_563_ = _e356;
                    }
                    let _e359 = phi_563_;
                    let _e361 = ((_e359 * _e292) * _e298);
                    let _e365 = (bitcast<f32>((bitcast<u32>(_e361) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e365 {
                        let _e369 = (bitcast<f32>((bitcast<u32>(_e352) & 2147483647u)) * 0.00000011920929f);
                        phi_586_ = select(0.00000000000011368684f, _e369, (_e369 > 0.00000000000011368684f));
                    } else {
                        phi_586_ = 0f;
                    }
                    let _e373 = phi_586_;
                    let _e374 = (_e352 + _e373);
                    let _e375 = (_e352 - _e373);
                    let _e376 = select(_e361, 0f, _e365);
                    if _e365 {
                        phi_597_ = 38685626000000000000000000f;
                    } else {
                        phi_597_ = (1f / _e361);
                    }
                    let _e379 = phi_597_;
                    let _e380 = (_e265 == 0u);
                    if _e380 {
                        phi_606_ = _e302[0];
                    } else {
                        phi_606_ = _e302[1];
                    }
                    let _e384 = phi_606_;
                    let _e385 = (_e265 == 2u);
                    if _e385 {
                        phi_612_ = _e302[2];
                    } else {
                        phi_612_ = _e384;
                    }
                    let _e388 = phi_612_;
                    let _e390 = ((_e388 * _e275) * _e281);
                    if _e380 {
                        phi_623_ = _e314[0];
                    } else {
                        phi_623_ = _e314[1];
                    }
                    let _e394 = phi_623_;
                    if _e385 {
                        phi_629_ = _e314[2];
                    } else {
                        phi_629_ = _e394;
                    }
                    let _e397 = phi_629_;
                    let _e399 = ((_e397 * _e292) * _e298);
                    let _e403 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e403 {
                        let _e407 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) * 0.00000011920929f);
                        phi_652_ = select(0.00000000000011368684f, _e407, (_e407 > 0.00000000000011368684f));
                    } else {
                        phi_652_ = 0f;
                    }
                    let _e411 = phi_652_;
                    let _e412 = (_e390 + _e411);
                    let _e413 = (_e390 - _e411);
                    let _e414 = select(_e399, 0f, _e403);
                    if _e403 {
                        phi_663_ = 38685626000000000000000000f;
                    } else {
                        phi_663_ = (1f / _e399);
                    }
                    let _e417 = phi_663_;
                    let _e420 = bitcast<f32>((bitcast<u32>(_e313) & 2147483647u));
                    let _e423 = bitcast<f32>((bitcast<u32>(_e352) & 2147483647u));
                    let _e425 = select(_e423, _e420, (_e420 > _e423));
                    let _e428 = bitcast<f32>((bitcast<u32>(_e390) & 2147483647u));
                    let _e431 = (_e132 + _e245);
                    if (_e226 && (select(_e428, _e425, (_e425 > _e428)) <= 1099511600000f)) {
                        let _e434 = (_e431 / 3i);
                        let _e441 = bitcast<f32>((bitcast<u32>((_e434 + 127i)) << bitcast<u32>(23i)));
                        let _e448 = bitcast<f32>((bitcast<u32>(((_e431 - (2i * _e434)) + 127i)) << bitcast<u32>(23i)));
                        let _e449 = (((_e211 * _e441) * _e441) * _e448);
                        let _e451 = select(340282350000000000000000000000000000000f, _e449, (_e449 < 340282350000000000000000000000000000000f));
                        let _e456 = (((_e220 * _e441) * _e441) * _e448);
                        let _e458 = select(340282350000000000000000000000000000000f, _e456, (_e456 < 340282350000000000000000000000000000000f));
                        phi_763_ = select(-340282350000000000000000000000000000000f, _e458, (_e458 > -340282350000000000000000000000000000000f));
                        phi_764_ = select(-340282350000000000000000000000000000000f, _e451, (_e451 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_763_ = 0f;
                        phi_764_ = 1f;
                    }
                    let _e462 = phi_763_;
                    let _e464 = phi_764_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e469 = (_e264 % 3u);
                    let _e470 = (_e469 < 3u);
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e472 = local_1[_e469];
                    let _e475 = (_e263 % 3u);
                    let _e476 = (_e475 < 3u);
                    if _e476 {
                    } else {
                        break;
                    }
                    let _e478 = local_1[_e475];
                    let _e481 = (_e265 % 3u);
                    let _e482 = (_e481 < 3u);
                    if _e482 {
                    } else {
                        break;
                    }
                    let _e484 = local_1[_e481];
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e489 = local[_e469];
                    if _e476 {
                    } else {
                        break;
                    }
                    let _e493 = local[_e475];
                    if _e482 {
                    } else {
                        break;
                    }
                    let _e497 = local[_e481];
                    phi_4047_ = false;
                    phi_854_ = type_43(type_36(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e462), 0u, 0u);
                    phi_857_ = type_50(type_32(vec4<f32>((f32(_e472) * _e144), (f32(_e478) * _e144), (f32(_e484) * _e144), 0f), vec4<f32>((f32(_e489) * _e144), (f32(_e493) * _e144), (f32(_e497) * _e144), 0f)), select(0u, 2147483648u, (_e93 == 0u)));
                    phi_859_ = ((3u * _e93) + 1u);
                    phi_861_ = (_e464 <= _e462);
                    phi_863_ = 0u;
                    loop {
                        let _e507 = phi_4047_;
                        let _e509 = phi_854_;
                        let _e511 = phi_857_;
                        let _e513 = phi_859_;
                        let _e515 = phi_861_;
                        let _e517 = phi_863_;
                        local_10 = _e509;
                        local_11 = _e509;
                        if _e515 {
                            phi_874_ = true;
                        } else {
                            phi_874_ = (_e517 > 0u);
                        }
                        let _e520 = phi_874_;
                        if _e520 {
                            let _e521 = (_e513 > 0u);
                            if _e521 {
                                if _e515 {
                                    phi_960_ = _e511;
                                    phi_961_ = _e515;
                                    phi_962_ = _e517;
                                } else {
                                    let _e522 = (_e517 - 1u);
                                    let _e523 = (_e522 % 128u);
                                    let _e524 = (_e523 < 128u);
                                    if _e524 {
                                    } else {
                                        phi_4230_ = true;
                                        break;
                                    }
                                    let _e526 = local_7[_e523];
                                    if _e524 {
                                    } else {
                                        phi_4230_ = true;
                                        break;
                                    }
                                    let _e528 = local_6[_e523];
                                    if _e524 {
                                    } else {
                                        phi_4230_ = true;
                                        break;
                                    }
                                    let _e530 = local_5[_e523];
                                    if _e524 {
                                    } else {
                                        phi_4230_ = true;
                                        break;
                                    }
                                    let _e532 = local_4[_e523];
                                    if _e524 {
                                    } else {
                                        phi_4230_ = true;
                                        break;
                                    }
                                    let _e534 = local_3[_e523];
                                    if _e524 {
                                    } else {
                                        phi_4230_ = true;
                                        break;
                                    }
                                    let _e536 = local_2[_e523];
                                    if _e524 {
                                    } else {
                                        phi_4230_ = true;
                                        break;
                                    }
                                    let _e541 = local_8[_e523];
                                    if _e524 {
                                    } else {
                                        phi_4230_ = true;
                                        break;
                                    }
                                    let _e544 = local_9[_e523];
                                    phi_960_ = type_50(type_32(vec4<f32>(_e526, _e528, _e530, 0f), vec4<f32>(_e532, _e534, _e536, 0f)), _e541);
                                    phi_961_ = (_e544 <= _e509.member.member_1);
                                    phi_962_ = _e522;
                                }
                                let _e549 = phi_960_;
                                let _e551 = phi_961_;
                                let _e553 = phi_962_;
                                if _e551 {
                                    let _e558 = (_e549.member_1 & 268435455u);
                                    if ((_e549.member_1 & 2147483648u) != 0u) {
                                        phi_981_ = _e509;
                                        phi_984_ = type_8(0u, ((_e549.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1025 = phi_981_;
                                            let _e1027 = phi_984_;
                                            local_12 = _e1025;
                                            if (_e1027.member < _e1027.member_1) {
                                                phi_985_ = type_8((_e1027.member + 1u), _e1027.member_1);
                                                phi_1007_ = type_8(1u, _e1027.member);
                                            } else {
                                                phi_985_ = _e1027;
                                                phi_1007_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1040 = phi_985_;
                                            let _e1042 = phi_1007_;
                                            let _e1046 = (bitcast<i32>(_e1042.member) != 0i);
                                            if _e1046 {
                                                let _e1052 = type_43(_e1025.member, _e1025.member_1, (_e1025.member_2 + 1u));
                                                let _e1057 = (_e549.member.member_1.x - _e549.member.member.x);
                                                let _e1060 = (_e549.member.member_1.y - _e549.member.member.y);
                                                let _e1063 = (_e549.member.member_1.z - _e549.member.member.z);
                                                let _e1065 = select(_e1060, _e1057, (_e1057 > _e1060));
                                                let _e1067 = select(_e1063, _e1065, (_e1065 > _e1063));
                                                let _e1069 = (_e1067 < (1024f * _e144));
                                                if _e1069 {
                                                    phi_1051_ = 0u;
                                                } else {
                                                    phi_1051_ = select(2u, 1u, (_e1067 < (2097152f * _e144)));
                                                }
                                                let _e1074 = phi_1051_;
                                                switch bitcast<i32>(_e1074) {
                                                    case 0: {
                                                        phi_1057_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1057_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1057_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1057_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1077 = phi_1057_;
                                                switch bitcast<i32>(_e1074) {
                                                    case 0: {
                                                        phi_1067_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1067_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1067_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1067_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1084 = phi_1067_;
                                                let _e1086 = ((_e558 + (_e1042.member_1 * ((3u * _e1077) + 1u))) + (3u * _e1084));
                                                let _e1087 = (_e1086 < _e96);
                                                if _e1087 {
                                                    if _e1087 {
                                                    } else {
                                                        phi_4041_ = true;
                                                        break;
                                                    }
                                                    let _e1089 = global_5.member[_e1086];
                                                    phi_1083_ = _e1089;
                                                } else {
                                                    phi_1083_ = 4294967295u;
                                                }
                                                let _e1091 = phi_1083_;
                                                if _e1069 {
                                                    phi_1116_ = 0u;
                                                } else {
                                                    phi_1116_ = select(2u, 1u, (_e1067 < (2097152f * _e144)));
                                                }
                                                let _e1096 = phi_1116_;
                                                switch bitcast<i32>(_e1096) {
                                                    case 0: {
                                                        phi_1122_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1122_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1122_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1122_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1099 = phi_1122_;
                                                let _e1103 = (_e558 + (_e1042.member_1 * ((3u * _e1099) + 1u)));
                                                switch bitcast<i32>(_e1096) {
                                                    case 0: {
                                                        let _e1369 = (_e1103 < _e96);
                                                        if _e1369 {
                                                            if _e1369 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1371 = global_5.member[_e1103];
                                                            phi_1146_ = _e1371;
                                                        } else {
                                                            phi_1146_ = 0u;
                                                        }
                                                        let _e1373 = phi_1146_;
                                                        let _e1375 = ((10u * _e264) & 31u);
                                                        let _e1384 = ((10u * _e263) & 31u);
                                                        let _e1393 = ((10u * _e265) & 31u);
                                                        let _e1402 = (_e1103 + 1u);
                                                        let _e1403 = (_e1402 < _e96);
                                                        if _e1403 {
                                                            if _e1403 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1405 = global_5.member[_e1402];
                                                            phi_1189_ = _e1405;
                                                        } else {
                                                            phi_1189_ = 0u;
                                                        }
                                                        let _e1407 = phi_1189_;
                                                        let _e1430 = (_e1103 + 2u);
                                                        let _e1431 = (_e1430 < _e96);
                                                        if _e1431 {
                                                            if _e1431 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1433 = global_5.member[_e1430];
                                                            phi_1232_ = _e1433;
                                                        } else {
                                                            phi_1232_ = 0u;
                                                        }
                                                        let _e1435 = phi_1232_;
                                                        phi_1703_ = array<array<f32, 3>, 3>(array<f32, 3>((_e549.member.member.x + (f32(bitcast<i32>(((_e1373 >> bitcast<u32>(_e1375)) & 1023u))) * _e144)), (_e549.member.member.y + (f32(bitcast<i32>(((_e1373 >> bitcast<u32>(_e1384)) & 1023u))) * _e144)), (_e549.member.member.z + (f32(bitcast<i32>(((_e1373 >> bitcast<u32>(_e1393)) & 1023u))) * _e144))), array<f32, 3>((_e549.member.member.x + (f32(bitcast<i32>(((_e1407 >> bitcast<u32>(_e1375)) & 1023u))) * _e144)), (_e549.member.member.y + (f32(bitcast<i32>(((_e1407 >> bitcast<u32>(_e1384)) & 1023u))) * _e144)), (_e549.member.member.z + (f32(bitcast<i32>(((_e1407 >> bitcast<u32>(_e1393)) & 1023u))) * _e144))), array<f32, 3>((_e549.member.member.x + (f32(bitcast<i32>(((_e1435 >> bitcast<u32>(_e1375)) & 1023u))) * _e144)), (_e549.member.member.y + (f32(bitcast<i32>(((_e1435 >> bitcast<u32>(_e1384)) & 1023u))) * _e144)), (_e549.member.member.z + (f32(bitcast<i32>(((_e1435 >> bitcast<u32>(_e1393)) & 1023u))) * _e144))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1192 = (_e1103 < _e96);
                                                        if _e1192 {
                                                            if _e1192 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1194 = global_5.member[_e1103];
                                                            phi_1275_ = _e1194;
                                                        } else {
                                                            phi_1275_ = 0u;
                                                        }
                                                        let _e1196 = phi_1275_;
                                                        let _e1197 = (_e1103 + 1u);
                                                        let _e1198 = (_e1197 < _e96);
                                                        if _e1198 {
                                                            if _e1198 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1200 = global_5.member[_e1197];
                                                            phi_1290_ = _e1200;
                                                        } else {
                                                            phi_1290_ = 0u;
                                                        }
                                                        let _e1202 = phi_1290_;
                                                        let _e1203 = (_e264 == 1u);
                                                        if _e1203 {
                                                            phi_1300_ = ((_e1196 >> bitcast<u32>(21i)) | (_e1202 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1300_ = (_e1202 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1212 = phi_1300_;
                                                        let _e1219 = (_e263 == 1u);
                                                        if _e1219 {
                                                            phi_1320_ = ((_e1196 >> bitcast<u32>(21i)) | (_e1202 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1320_ = (_e1202 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1228 = phi_1320_;
                                                        let _e1235 = (_e265 == 1u);
                                                        if _e1235 {
                                                            phi_1340_ = ((_e1196 >> bitcast<u32>(21i)) | (_e1202 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1340_ = (_e1202 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1244 = phi_1340_;
                                                        let _e1252 = (_e1103 + 2u);
                                                        let _e1253 = (_e1252 < _e96);
                                                        if _e1253 {
                                                            if _e1253 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1255 = global_5.member[_e1252];
                                                            phi_1366_ = _e1255;
                                                        } else {
                                                            phi_1366_ = 0u;
                                                        }
                                                        let _e1257 = phi_1366_;
                                                        let _e1258 = (_e1103 + 3u);
                                                        let _e1259 = (_e1258 < _e96);
                                                        if _e1259 {
                                                            if _e1259 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1261 = global_5.member[_e1258];
                                                            phi_1381_ = _e1261;
                                                        } else {
                                                            phi_1381_ = 0u;
                                                        }
                                                        let _e1263 = phi_1381_;
                                                        if _e1203 {
                                                            phi_1391_ = ((_e1257 >> bitcast<u32>(21i)) | (_e1263 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1391_ = (_e1263 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1272 = phi_1391_;
                                                        if _e1219 {
                                                            phi_1411_ = ((_e1257 >> bitcast<u32>(21i)) | (_e1263 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1411_ = (_e1263 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1287 = phi_1411_;
                                                        if _e1235 {
                                                            phi_1431_ = ((_e1257 >> bitcast<u32>(21i)) | (_e1263 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1431_ = (_e1263 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1302 = phi_1431_;
                                                        let _e1310 = (_e1103 + 4u);
                                                        let _e1311 = (_e1310 < _e96);
                                                        if _e1311 {
                                                            if _e1311 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1313 = global_5.member[_e1310];
                                                            phi_1457_ = _e1313;
                                                        } else {
                                                            phi_1457_ = 0u;
                                                        }
                                                        let _e1315 = phi_1457_;
                                                        let _e1316 = (_e1103 + 5u);
                                                        let _e1317 = (_e1316 < _e96);
                                                        if _e1317 {
                                                            if _e1317 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1319 = global_5.member[_e1316];
                                                            phi_1472_ = _e1319;
                                                        } else {
                                                            phi_1472_ = 0u;
                                                        }
                                                        let _e1321 = phi_1472_;
                                                        if _e1203 {
                                                            phi_1482_ = ((_e1315 >> bitcast<u32>(21i)) | (_e1321 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1482_ = (_e1321 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1330 = phi_1482_;
                                                        if _e1219 {
                                                            phi_1502_ = ((_e1315 >> bitcast<u32>(21i)) | (_e1321 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1502_ = (_e1321 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1345 = phi_1502_;
                                                        if _e1235 {
                                                            phi_1522_ = ((_e1315 >> bitcast<u32>(21i)) | (_e1321 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1522_ = (_e1321 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1360 = phi_1522_;
                                                        phi_1703_ = array<array<f32, 3>, 3>(array<f32, 3>((_e549.member.member.x + (f32(bitcast<i32>((select(_e1212, _e1196, _e303) & 2097151u))) * _e144)), (_e549.member.member.y + (f32(bitcast<i32>((select(_e1228, _e1196, _e342) & 2097151u))) * _e144)), (_e549.member.member.z + (f32(bitcast<i32>((select(_e1244, _e1196, _e380) & 2097151u))) * _e144))), array<f32, 3>((_e549.member.member.x + (f32(bitcast<i32>((select(_e1272, _e1257, _e303) & 2097151u))) * _e144)), (_e549.member.member.y + (f32(bitcast<i32>((select(_e1287, _e1257, _e342) & 2097151u))) * _e144)), (_e549.member.member.z + (f32(bitcast<i32>((select(_e1302, _e1257, _e380) & 2097151u))) * _e144))), array<f32, 3>((_e549.member.member.x + (f32(bitcast<i32>((select(_e1330, _e1315, _e303) & 2097151u))) * _e144)), (_e549.member.member.y + (f32(bitcast<i32>((select(_e1345, _e1315, _e342) & 2097151u))) * _e144)), (_e549.member.member.z + (f32(bitcast<i32>((select(_e1360, _e1315, _e380) & 2097151u))) * _e144))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1105 = (_e1103 + _e264);
                                                        let _e1106 = (_e1105 < _e96);
                                                        if _e1106 {
                                                            if _e1106 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1108 = global_5.member[_e1105];
                                                            phi_1549_ = _e1108;
                                                        } else {
                                                            phi_1549_ = 0u;
                                                        }
                                                        let _e1110 = phi_1549_;
                                                        let _e1114 = (_e1103 + _e263);
                                                        let _e1115 = (_e1114 < _e96);
                                                        if _e1115 {
                                                            if _e1115 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1117 = global_5.member[_e1114];
                                                            phi_1567_ = _e1117;
                                                        } else {
                                                            phi_1567_ = 0u;
                                                        }
                                                        let _e1119 = phi_1567_;
                                                        let _e1123 = (_e1103 + _e265);
                                                        let _e1124 = (_e1123 < _e96);
                                                        if _e1124 {
                                                            if _e1124 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1126 = global_5.member[_e1123];
                                                            phi_1585_ = _e1126;
                                                        } else {
                                                            phi_1585_ = 0u;
                                                        }
                                                        let _e1128 = phi_1585_;
                                                        let _e1133 = (_e1103 + 3u);
                                                        let _e1134 = (_e1133 + _e264);
                                                        let _e1135 = (_e1134 < _e96);
                                                        if _e1135 {
                                                            if _e1135 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1137 = global_5.member[_e1134];
                                                            phi_1605_ = _e1137;
                                                        } else {
                                                            phi_1605_ = 0u;
                                                        }
                                                        let _e1139 = phi_1605_;
                                                        let _e1143 = (_e1133 + _e263);
                                                        let _e1144 = (_e1143 < _e96);
                                                        if _e1144 {
                                                            if _e1144 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1146 = global_5.member[_e1143];
                                                            phi_1623_ = _e1146;
                                                        } else {
                                                            phi_1623_ = 0u;
                                                        }
                                                        let _e1148 = phi_1623_;
                                                        let _e1152 = (_e1133 + _e265);
                                                        let _e1153 = (_e1152 < _e96);
                                                        if _e1153 {
                                                            if _e1153 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1155 = global_5.member[_e1152];
                                                            phi_1641_ = _e1155;
                                                        } else {
                                                            phi_1641_ = 0u;
                                                        }
                                                        let _e1157 = phi_1641_;
                                                        let _e1162 = (_e1103 + 6u);
                                                        let _e1163 = (_e1162 + _e264);
                                                        let _e1164 = (_e1163 < _e96);
                                                        if _e1164 {
                                                            if _e1164 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1166 = global_5.member[_e1163];
                                                            phi_1661_ = _e1166;
                                                        } else {
                                                            phi_1661_ = 0u;
                                                        }
                                                        let _e1168 = phi_1661_;
                                                        let _e1172 = (_e1162 + _e263);
                                                        let _e1173 = (_e1172 < _e96);
                                                        if _e1173 {
                                                            if _e1173 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1175 = global_5.member[_e1172];
                                                            phi_1679_ = _e1175;
                                                        } else {
                                                            phi_1679_ = 0u;
                                                        }
                                                        let _e1177 = phi_1679_;
                                                        let _e1181 = (_e1162 + _e265);
                                                        let _e1182 = (_e1181 < _e96);
                                                        if _e1182 {
                                                            if _e1182 {
                                                            } else {
                                                                phi_4041_ = true;
                                                                break;
                                                            }
                                                            let _e1184 = global_5.member[_e1181];
                                                            phi_1697_ = _e1184;
                                                        } else {
                                                            phi_1697_ = 0u;
                                                        }
                                                        let _e1186 = phi_1697_;
                                                        phi_1703_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1110)) * _e144), (f32(bitcast<i32>(_e1119)) * _e144), (f32(bitcast<i32>(_e1128)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e1139)) * _e144), (f32(bitcast<i32>(_e1148)) * _e144), (f32(bitcast<i32>(_e1157)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e1168)) * _e144), (f32(bitcast<i32>(_e1177)) * _e144), (f32(bitcast<i32>(_e1186)) * _e144)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1703_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1460 = phi_1703_;
                                                let _e1469 = (_e1460[0][2] - _e390);
                                                let _e1472 = (((_e1460[0][0] - _e313) * _e414) - (_e1469 * _e338));
                                                let _e1475 = (((_e1460[0][1] - _e352) * _e414) - (_e1469 * _e376));
                                                let _e1482 = (_e1460[1][2] - _e390);
                                                let _e1485 = (((_e1460[1][0] - _e313) * _e414) - (_e1482 * _e338));
                                                let _e1488 = (((_e1460[1][1] - _e352) * _e414) - (_e1482 * _e376));
                                                let _e1495 = (_e1460[2][2] - _e390);
                                                let _e1498 = (((_e1460[2][0] - _e313) * _e414) - (_e1495 * _e338));
                                                let _e1501 = (((_e1460[2][1] - _e352) * _e414) - (_e1495 * _e376));
                                                let _e1502 = (_e1498 * _e1488);
                                                let _e1503 = (_e1501 * _e1485);
                                                let _e1504 = (_e1472 * _e1501);
                                                let _e1505 = (_e1475 * _e1498);
                                                let _e1506 = (_e1485 * _e1475);
                                                let _e1507 = (_e1488 * _e1472);
                                                let _e1512 = (((_e1502 >= _e1503) && (_e1504 >= _e1505)) && (_e1506 >= _e1507));
                                                if (_e1512 || (((_e1502 <= _e1503) && (_e1504 <= _e1505)) && (_e1506 <= _e1507))) {
                                                    let _e1519 = select(-1f, 1f, _e1512);
                                                    let _e1521 = ((_e1502 - _e1503) * _e1519);
                                                    let _e1523 = select(0f, _e1521, (_e1521 > 0f));
                                                    let _e1525 = ((_e1504 - _e1505) * _e1519);
                                                    let _e1527 = select(0f, _e1525, (_e1525 > 0f));
                                                    let _e1529 = ((_e1506 - _e1507) * _e1519);
                                                    let _e1531 = select(0f, _e1529, (_e1529 > 0f));
                                                    let _e1533 = ((_e1523 + _e1527) + _e1531);
                                                    if (_e1533 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2528_ = type_28();
                                                        phi_2529_ = true;
                                                        phi_2530_ = false;
                                                    } else {
                                                        let _e1536 = select(_e1485, _e1472, (_e1472 < _e1485));
                                                        if (select(_e1498, _e1536, (_e1536 < _e1498)) > 0f) {
                                                            phi_1820_ = true;
                                                        } else {
                                                            let _e1541 = select(_e1485, _e1472, (_e1472 > _e1485));
                                                            phi_1820_ = (select(_e1498, _e1541, (_e1541 > _e1498)) < 0f);
                                                        }
                                                        let _e1546 = phi_1820_;
                                                        if _e1546 {
                                                            phi_2525_ = type_28();
                                                            phi_2526_ = true;
                                                            phi_2527_ = false;
                                                        } else {
                                                            let _e1548 = select(_e1488, _e1475, (_e1475 < _e1488));
                                                            if (select(_e1501, _e1548, (_e1548 < _e1501)) > 0f) {
                                                                phi_1849_ = true;
                                                            } else {
                                                                let _e1553 = select(_e1488, _e1475, (_e1475 > _e1488));
                                                                phi_1849_ = (select(_e1501, _e1553, (_e1553 > _e1501)) < 0f);
                                                            }
                                                            let _e1558 = phi_1849_;
                                                            if _e1558 {
                                                                phi_2523_ = type_28();
                                                                phi_2524_ = false;
                                                            } else {
                                                                let _e1560 = select(_e1460[1][0], _e1460[0][0], (_e1460[0][0] < _e1460[1][0]));
                                                                let _e1564 = select(_e1460[1][0], _e1460[0][0], (_e1460[0][0] > _e1460[1][0]));
                                                                let _e1568 = select(_e1460[1][1], _e1460[0][1], (_e1460[0][1] < _e1460[1][1]));
                                                                let _e1572 = select(_e1460[1][1], _e1460[0][1], (_e1460[0][1] > _e1460[1][1]));
                                                                let _e1576 = select(_e1460[1][2], _e1460[0][2], (_e1460[0][2] < _e1460[1][2]));
                                                                let _e1580 = select(_e1460[1][2], _e1460[0][2], (_e1460[0][2] > _e1460[1][2]));
                                                                let _e1585 = ((select(_e1460[2][0], _e1560, (_e1560 < _e1460[2][0])) - _e336) * _e341);
                                                                let _e1586 = ((select(_e1460[2][0], _e1564, (_e1564 > _e1460[2][0])) - _e337) * _e341);
                                                                let _e1589 = ((select(_e1460[2][1], _e1568, (_e1568 < _e1460[2][1])) - _e374) * _e379);
                                                                let _e1590 = ((select(_e1460[2][1], _e1572, (_e1572 > _e1460[2][1])) - _e375) * _e379);
                                                                let _e1593 = ((select(_e1460[2][2], _e1576, (_e1576 < _e1460[2][2])) - _e412) * _e417);
                                                                let _e1594 = ((select(_e1460[2][2], _e1580, (_e1580 > _e1460[2][2])) - _e413) * _e417);
                                                                let _e1596 = select(_e1594, _e1593, (_e1593 < _e1594));
                                                                let _e1598 = select(_e1594, _e1593, (_e1593 > _e1594));
                                                                let _e1600 = select(_e1586, _e1585, (_e1585 < _e1586));
                                                                let _e1602 = select(_e1590, _e1589, (_e1589 < _e1590));
                                                                let _e1604 = select(_e1602, _e1600, (_e1600 > _e1602));
                                                                let _e1606 = select(_e1596, _e1604, (_e1604 > _e1596));
                                                                let _e1608 = select(_e1586, _e1585, (_e1585 > _e1586));
                                                                let _e1610 = select(_e1590, _e1589, (_e1589 > _e1590));
                                                                let _e1612 = select(_e1610, _e1608, (_e1608 < _e1610));
                                                                let _e1614 = select(_e1598, _e1612, (_e1612 < _e1598));
                                                                let _e1615 = -(_e1596);
                                                                let _e1621 = select(_e464, _e1606, (_e1606 > _e464));
                                                                if (_e1621 > (_e1614 + (select(_e1615, _e1598, (_e1598 > _e1615)) * 0.0000019073523f))) {
                                                                    phi_2518_ = type_28();
                                                                    phi_2519_ = true;
                                                                } else {
                                                                    let _e1623 = (_e1621 > _e1025.member.member_1);
                                                                    if _e1623 {
                                                                        phi_2517_ = type_28();
                                                                    } else {
                                                                        let _e1624 = vec3<f32>(_e1460[0][0], _e1460[0][1], _e1460[0][2]);
                                                                        let _e1625 = vec3<f32>(_e1460[1][0], _e1460[1][1], _e1460[1][2]);
                                                                        let _e1626 = vec3<f32>(_e1460[2][0], _e1460[2][1], _e1460[2][2]);
                                                                        let _e1627 = (_e1460[1][0] - _e1460[0][0]);
                                                                        let _e1628 = (_e1460[1][1] - _e1460[0][1]);
                                                                        let _e1629 = (_e1460[1][2] - _e1460[0][2]);
                                                                        let _e1630 = vec3<f32>(_e1627, _e1628, _e1629);
                                                                        let _e1631 = (_e1460[2][0] - _e1460[1][0]);
                                                                        let _e1632 = (_e1460[2][1] - _e1460[1][1]);
                                                                        let _e1633 = (_e1460[2][2] - _e1460[1][2]);
                                                                        let _e1634 = vec3<f32>(_e1631, _e1632, _e1633);
                                                                        let _e1635 = (_e1460[0][0] - _e1460[2][0]);
                                                                        let _e1636 = (_e1460[0][1] - _e1460[2][1]);
                                                                        let _e1637 = (_e1460[0][2] - _e1460[2][2]);
                                                                        let _e1638 = vec3<f32>(_e1635, _e1636, _e1637);
                                                                        let _e1641 = bitcast<f32>((bitcast<u32>(_e1627) & 2147483647u));
                                                                        let _e1644 = bitcast<f32>((bitcast<u32>(_e1628) & 2147483647u));
                                                                        let _e1646 = select(_e1644, _e1641, (_e1641 > _e1644));
                                                                        let _e1649 = bitcast<f32>((bitcast<u32>(_e1629) & 2147483647u));
                                                                        let _e1651 = select(_e1649, _e1646, (_e1646 > _e1649));
                                                                        let _e1654 = bitcast<f32>((bitcast<u32>(_e1631) & 2147483647u));
                                                                        let _e1657 = bitcast<f32>((bitcast<u32>(_e1632) & 2147483647u));
                                                                        let _e1659 = select(_e1657, _e1654, (_e1654 > _e1657));
                                                                        let _e1662 = bitcast<f32>((bitcast<u32>(_e1633) & 2147483647u));
                                                                        let _e1664 = select(_e1662, _e1659, (_e1659 > _e1662));
                                                                        let _e1667 = bitcast<f32>((bitcast<u32>(_e1635) & 2147483647u));
                                                                        let _e1670 = bitcast<f32>((bitcast<u32>(_e1636) & 2147483647u));
                                                                        let _e1672 = select(_e1670, _e1667, (_e1667 > _e1670));
                                                                        let _e1675 = bitcast<f32>((bitcast<u32>(_e1637) & 2147483647u));
                                                                        let _e1677 = select(_e1675, _e1672, (_e1672 > _e1675));
                                                                        let _e1679 = select(_e1664, _e1651, (_e1651 > _e1664));
                                                                        let _e1681 = select(_e1677, _e1679, (_e1679 > _e1677));
                                                                        if (_e1651 == _e1681) {
                                                                            phi_2250_ = _e1488;
                                                                            phi_2251_ = _e1485;
                                                                            phi_2252_ = _e1475;
                                                                            phi_2253_ = _e1472;
                                                                            phi_2254_ = _e1624;
                                                                            phi_2255_ = _e1638;
                                                                            phi_2256_ = _e1634;
                                                                            phi_2257_ = _e1630;
                                                                        } else {
                                                                            let _e1683 = (_e1664 == _e1681);
                                                                            let _e1688 = vec3(_e1683);
                                                                            phi_2250_ = select(_e1475, _e1501, _e1683);
                                                                            phi_2251_ = select(_e1472, _e1498, _e1683);
                                                                            phi_2252_ = select(_e1501, _e1488, _e1683);
                                                                            phi_2253_ = select(_e1498, _e1485, _e1683);
                                                                            phi_2254_ = select(_e1626, _e1625, _e1688);
                                                                            phi_2255_ = select(_e1634, _e1630, _e1688);
                                                                            phi_2256_ = select(_e1630, _e1638, _e1688);
                                                                            phi_2257_ = select(_e1638, _e1634, _e1688);
                                                                        }
                                                                        let _e1694 = phi_2250_;
                                                                        let _e1696 = phi_2251_;
                                                                        let _e1698 = phi_2252_;
                                                                        let _e1700 = phi_2253_;
                                                                        let _e1702 = phi_2254_;
                                                                        let _e1704 = phi_2255_;
                                                                        let _e1706 = phi_2256_;
                                                                        let _e1708 = phi_2257_;
                                                                        let _e1715 = ((_e1706.y * _e1704.z) - (_e1704.y * _e1706.z));
                                                                        let _e1720 = ((_e1706.z * _e1704.x) - (_e1704.z * _e1706.x));
                                                                        let _e1723 = ((_e1706.x * _e1704.y) - (_e1704.x * _e1706.y));
                                                                        if (_e1523 >= _e1527) {
                                                                            phi_2288_ = select(true, false, (_e1523 >= _e1531));
                                                                        } else {
                                                                            phi_2288_ = true;
                                                                        }
                                                                        let _e1728 = phi_2288_;
                                                                        if _e1728 {
                                                                            phi_2297_ = select(_e1626, _e1625, vec3((_e1527 >= _e1531)));
                                                                        } else {
                                                                            phi_2297_ = _e1624;
                                                                        }
                                                                        let _e1733 = phi_2297_;
                                                                        let _e1744 = (((_e1715 * (_e1733.x - _e313)) + (_e1720 * (_e1733.y - _e352))) + (_e1723 * (_e1733.z - _e390)));
                                                                        let _e1749 = (((_e1715 * _e338) + (_e1720 * _e376)) + (_e1723 * _e414));
                                                                        let _e1750 = (_e1696 - _e1700);
                                                                        let _e1751 = (_e1694 - _e1698);
                                                                        let _e1759 = (-(((_e1700 * _e1750) + (_e1698 * _e1751))) / ((_e1750 * _e1750) + (_e1751 * _e1751)));
                                                                        let _e1761 = select(1f, _e1759, (_e1759 < 1f));
                                                                        let _e1763 = select(0f, _e1761, (_e1761 > 0f));
                                                                        let _e1776 = ((_e1702.x + (_e1708.x * _e1763)) - _e313);
                                                                        let _e1777 = ((_e1702.y + (_e1708.y * _e1763)) - _e352);
                                                                        let _e1778 = ((_e1702.z + (_e1708.z * _e1763)) - _e390);
                                                                        let _e1779 = (_e1778 / _e414);
                                                                        let _e1791 = bitcast<f32>((bitcast<u32>(_e1776) & 2147483647u));
                                                                        let _e1794 = bitcast<f32>((bitcast<u32>(_e1777) & 2147483647u));
                                                                        let _e1796 = select(_e1794, _e1791, (_e1791 > _e1794));
                                                                        let _e1799 = bitcast<f32>((bitcast<u32>(_e1778) & 2147483647u));
                                                                        let _e1801 = select(_e1799, _e1796, (_e1796 > _e1799));
                                                                        let _e1807 = bitcast<f32>((bitcast<u32>(_e1715) & 2147483647u));
                                                                        let _e1810 = bitcast<f32>((bitcast<u32>(_e1720) & 2147483647u));
                                                                        let _e1812 = select(_e1810, _e1807, (_e1807 > _e1810));
                                                                        let _e1815 = bitcast<f32>((bitcast<u32>(_e1723) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1715 * _e1776) + (_e1720 * _e1777)) + (_e1723 * _e1778)) - _e1744)) & 2147483647u)) <= ((0.0000009536743f * select(_e1681, _e1801, (_e1801 > _e1681))) * select(_e1815, _e1812, (_e1812 > _e1815)))) {
                                                                            let _e1825 = bitcast<f32>((bitcast<u32>(_e1706.x) & 2147483647u));
                                                                            let _e1828 = bitcast<f32>((bitcast<u32>(_e1706.y) & 2147483647u));
                                                                            let _e1830 = select(_e1828, _e1825, (_e1825 > _e1828));
                                                                            let _e1833 = bitcast<f32>((bitcast<u32>(_e1706.z) & 2147483647u));
                                                                            let _e1839 = bitcast<f32>((bitcast<u32>(_e1704.x) & 2147483647u));
                                                                            let _e1842 = bitcast<f32>((bitcast<u32>(_e1704.y) & 2147483647u));
                                                                            let _e1844 = select(_e1842, _e1839, (_e1839 > _e1842));
                                                                            let _e1847 = bitcast<f32>((bitcast<u32>(_e1704.z) & 2147483647u));
                                                                            let _e1851 = (bitcast<f32>((bitcast<u32>(_e1749) & 2147483647u)) > ((0.0000038146973f * select(_e1833, _e1830, (_e1830 > _e1833))) * select(_e1847, _e1844, (_e1844 > _e1847))));
                                                                            if _e1851 {
                                                                                phi_2462_ = (_e1744 / _e1749);
                                                                            } else {
                                                                                phi_2462_ = f32();
                                                                            }
                                                                            let _e1854 = phi_2462_;
                                                                            phi_2464_ = _e1854;
                                                                            phi_2465_ = select(true, false, _e1851);
                                                                        } else {
                                                                            phi_2464_ = f32();
                                                                            phi_2465_ = true;
                                                                        }
                                                                        let _e1857 = phi_2464_;
                                                                        let _e1859 = phi_2465_;
                                                                        if _e1859 {
                                                                            let _e1867 = (((_e1715 * (_e1776 - (_e338 * _e1779))) + (_e1720 * (_e1777 - (_e376 * _e1779)))) / _e1749);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1867) & 2147483647u)) <= _e1681) {
                                                                                phi_2485_ = (_e1779 + _e1867);
                                                                            } else {
                                                                                phi_2485_ = _e1779;
                                                                            }
                                                                            let _e1874 = phi_2485_;
                                                                            phi_2486_ = _e1874;
                                                                        } else {
                                                                            phi_2486_ = _e1857;
                                                                        }
                                                                        let _e1876 = phi_2486_;
                                                                        let _e1878 = select(_e1614, _e1876, (_e1876 < _e1614));
                                                                        let _e1880 = select(_e1606, _e1878, (_e1878 > _e1606));
                                                                        if (_e1880 >= _e464) {
                                                                            let _e1882 = (_e1880 <= _e1025.member.member_1);
                                                                            if _e1882 {
                                                                                let _e1883 = (1f / _e1533);
                                                                                phi_2509_ = type_28(_e1880, (_e1527 * _e1883), (_e1531 * _e1883), _e1091);
                                                                            } else {
                                                                                phi_2509_ = type_28();
                                                                            }
                                                                            let _e1888 = phi_2509_;
                                                                            phi_2511_ = _e1888;
                                                                            phi_2512_ = select(true, false, _e1882);
                                                                        } else {
                                                                            phi_2511_ = type_28();
                                                                            phi_2512_ = true;
                                                                        }
                                                                        let _e1891 = phi_2511_;
                                                                        let _e1893 = phi_2512_;
                                                                        if _e1893 {
                                                                            phi_2516_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2516_ = _e1891;
                                                                        }
                                                                        let _e1895 = phi_2516_;
                                                                        phi_2517_ = _e1895;
                                                                    }
                                                                    let _e1897 = phi_2517_;
                                                                    phi_2518_ = _e1897;
                                                                    phi_2519_ = _e1623;
                                                                }
                                                                let _e1899 = phi_2518_;
                                                                let _e1901 = phi_2519_;
                                                                phi_2523_ = _e1899;
                                                                phi_2524_ = _e1901;
                                                            }
                                                            let _e1903 = phi_2523_;
                                                            let _e1905 = phi_2524_;
                                                            phi_2525_ = _e1903;
                                                            phi_2526_ = _e1558;
                                                            phi_2527_ = _e1905;
                                                        }
                                                        let _e1907 = phi_2525_;
                                                        let _e1909 = phi_2526_;
                                                        let _e1911 = phi_2527_;
                                                        phi_2528_ = _e1907;
                                                        phi_2529_ = _e1909;
                                                        phi_2530_ = _e1911;
                                                    }
                                                    let _e1913 = phi_2528_;
                                                    let _e1915 = phi_2529_;
                                                    let _e1917 = phi_2530_;
                                                    phi_2538_ = _e1913;
                                                    phi_2539_ = select(_e1917, true, _e1915);
                                                } else {
                                                    phi_2538_ = type_28();
                                                    phi_2539_ = true;
                                                }
                                                let _e1920 = phi_2538_;
                                                let _e1922 = phi_2539_;
                                                if _e1922 {
                                                    phi_2543_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2543_ = _e1920;
                                                }
                                                let _e1924 = phi_2543_;
                                                if (_e1924.member_3 != 4294967295u) {
                                                    if (_e1091 != 4294967295u) {
                                                        if (_e1924.member < _e1025.member.member.member) {
                                                            phi_2569_ = true;
                                                        } else {
                                                            if (_e1924.member == _e1025.member.member.member) {
                                                                phi_2568_ = (_e1924.member_3 < _e1025.member.member.member_3);
                                                            } else {
                                                                phi_2568_ = false;
                                                            }
                                                            let _e1939 = phi_2568_;
                                                            phi_2569_ = _e1939;
                                                        }
                                                        let _e1941 = phi_2569_;
                                                        if _e1941 {
                                                            phi_2576_ = type_43(type_36(_e1924, _e1924.member), _e1052.member_1, _e1052.member_2);
                                                        } else {
                                                            phi_2576_ = _e1052;
                                                        }
                                                        let _e1948 = phi_2576_;
                                                        phi_2577_ = _e1948;
                                                    } else {
                                                        phi_2577_ = _e1052;
                                                    }
                                                    let _e1950 = phi_2577_;
                                                    phi_2578_ = _e1950;
                                                } else {
                                                    phi_2578_ = _e1052;
                                                }
                                                let _e1952 = phi_2578_;
                                                phi_982_ = _e1952;
                                            } else {
                                                phi_982_ = type_43();
                                            }
                                            let _e1954 = phi_982_;
                                            continue;
                                            continuing {
                                                phi_981_ = _e1954;
                                                phi_984_ = _e1040;
                                                phi_4041_ = _e507;
                                                break if !(_e1046);
                                            }
                                        }
                                        let _e1957 = phi_4041_;
                                        phi_4230_ = _e1957;
                                        if _e1957 {
                                            break;
                                        }
                                        phi_4234_ = _e1957;
                                        let _e2163 = local_12;
                                        phi_3821_ = _e2163;
                                        phi_3822_ = _e549;
                                        phi_3823_ = false;
                                        phi_3824_ = _e553;
                                    } else {
                                        if (_e549.member_1 >= _e93) {
                                            phi_3377_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e549.member_1 < _e93) {
                                            } else {
                                                phi_4230_ = true;
                                                break;
                                            }
                                            let _e572 = ((1u + _e264) % 4u);
                                            if (_e572 < 4u) {
                                            } else {
                                                phi_4230_ = true;
                                                break;
                                            }
                                            let _e577 = global_3.member[_e549.member_1][_e572];
                                            let _e579 = (_e577 >> bitcast<u32>(11u));
                                            let _e581 = ((1u + _e263) % 4u);
                                            if (_e581 < 4u) {
                                            } else {
                                                phi_4230_ = true;
                                                break;
                                            }
                                            let _e586 = global_3.member[_e549.member_1][_e581];
                                            let _e588 = (_e586 >> bitcast<u32>(11u));
                                            let _e590 = ((1u + _e265) % 4u);
                                            if (_e590 < 4u) {
                                            } else {
                                                phi_4230_ = true;
                                                break;
                                            }
                                            let _e595 = global_3.member[_e549.member_1][_e590];
                                            let _e597 = (_e595 >> bitcast<u32>(11u));
                                            let _e620 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.x - _e549.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e621 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.y - _e549.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e622 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.z - _e549.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e624 = select(_e144, _e620, (_e620 > _e144));
                                            let _e626 = select(_e144, _e621, (_e621 > _e144));
                                            let _e628 = select(_e144, _e622, (_e622 > _e144));
                                            let _e653 = bitcast<u32>((f32(bitcast<i32>((_e577 & 1023u))) * _e624));
                                            let _e658 = (bitcast<i32>((_e577 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e661 = bitcast<f32>((_e653 & bitcast<u32>(_e658)));
                                            let _e662 = bitcast<u32>((f32(bitcast<i32>((_e586 & 1023u))) * _e626));
                                            let _e667 = (bitcast<i32>((_e586 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e670 = bitcast<f32>((_e662 & bitcast<u32>(_e667)));
                                            let _e671 = bitcast<u32>((f32(bitcast<i32>((_e595 & 1023u))) * _e628));
                                            let _e676 = (bitcast<i32>((_e595 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e679 = bitcast<f32>((_e671 & bitcast<u32>(_e676)));
                                            let _e683 = bitcast<f32>((_e653 & bitcast<u32>(~(_e658))));
                                            let _e687 = bitcast<f32>((_e662 & bitcast<u32>(~(_e667))));
                                            let _e691 = bitcast<f32>((_e671 & bitcast<u32>(~(_e676))));
                                            let _e692 = bitcast<u32>((f32(bitcast<i32>((_e579 & 1023u))) * _e624));
                                            let _e697 = (bitcast<i32>((_e579 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e700 = bitcast<f32>((_e692 & bitcast<u32>(_e697)));
                                            let _e701 = bitcast<u32>((f32(bitcast<i32>((_e588 & 1023u))) * _e626));
                                            let _e706 = (bitcast<i32>((_e588 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e709 = bitcast<f32>((_e701 & bitcast<u32>(_e706)));
                                            let _e710 = bitcast<u32>((f32(bitcast<i32>((_e597 & 1023u))) * _e628));
                                            let _e715 = (bitcast<i32>((_e597 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e718 = bitcast<f32>((_e710 & bitcast<u32>(_e715)));
                                            let _e722 = bitcast<f32>((_e692 & bitcast<u32>(~(_e697))));
                                            let _e726 = bitcast<f32>((_e701 & bitcast<u32>(~(_e706))));
                                            let _e730 = bitcast<f32>((_e710 & bitcast<u32>(~(_e715))));
                                            let _e731 = (_e549.member.member.x + _e661);
                                            let _e732 = (_e549.member.member.y + _e670);
                                            let _e733 = (_e549.member.member.z + _e679);
                                            let _e736 = (_e549.member.member_1.x - _e700);
                                            let _e737 = (_e549.member.member_1.y - _e709);
                                            let _e738 = (_e549.member.member_1.z - _e718);
                                            let _e757 = (_e736 - _e731);
                                            let _e758 = (_e737 - _e732);
                                            let _e759 = (_e738 - _e733);
                                            let _e761 = select(_e758, _e757, (_e757 > _e758));
                                            let _e763 = select(_e759, _e761, (_e761 > _e759));
                                            if (_e763 < (1024f * _e144)) {
                                                phi_3078_ = 0u;
                                            } else {
                                                phi_3078_ = select(2u, 1u, (_e763 < (2097152f * _e144)));
                                            }
                                            let _e770 = phi_3078_;
                                            switch bitcast<i32>(_e770) {
                                                case 0: {
                                                    phi_3084_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3084_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3084_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3084_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e773 = phi_3084_;
                                            let _e779 = global_3.member[_e549.member_1][0u];
                                            let _e783 = global_3.member[_e549.member_1][1u];
                                            let _e787 = global_3.member[_e549.member_1][2u];
                                            let _e791 = global_3.member[_e549.member_1][3u];
                                            let _e803 = (((_e783 >> bitcast<u32>(22i)) | ((_e787 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e791 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e804 = (_e779 & 268435455u);
                                            let _e805 = (_e803 & 268435455u);
                                            let _e808 = ((_e779 >> bitcast<u32>(28u)) & 7u);
                                            let _e816 = ((_e779 >> bitcast<u32>(31i)) | (((_e803 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e817 = (_e808 != 0u);
                                            if (_e808 == 0u) {
                                                phi_3339_ = _e804;
                                            } else {
                                                if (_e808 == 7u) {
                                                    phi_3338_ = 2147483648u;
                                                } else {
                                                    phi_3338_ = ((2147483648u | (_e808 << bitcast<u32>(28u))) | (_e805 & 268435455u));
                                                }
                                                let _e826 = phi_3338_;
                                                phi_3339_ = _e826;
                                            }
                                            let _e828 = phi_3339_;
                                            if _e817 {
                                                let _e829 = (_e808 != 7u);
                                                if _e829 {
                                                    phi_3349_ = (_e805 + (_e808 * ((3u * _e773) + 1u)));
                                                } else {
                                                    phi_3349_ = u32();
                                                }
                                                let _e833 = phi_3349_;
                                                phi_3351_ = _e833;
                                                phi_3352_ = select(true, false, _e829);
                                            } else {
                                                phi_3351_ = u32();
                                                phi_3352_ = true;
                                            }
                                            let _e836 = phi_3351_;
                                            let _e838 = phi_3352_;
                                            if (_e816 == 0u) {
                                                phi_3373_ = (_e804 + select(0u, 1u, !(_e817)));
                                            } else {
                                                if (_e816 == 7u) {
                                                    phi_3372_ = 2147483648u;
                                                } else {
                                                    phi_3372_ = ((2147483648u | (_e816 << bitcast<u32>(28u))) | (select(_e836, _e805, _e838) & 268435455u));
                                                }
                                                let _e851 = phi_3372_;
                                                phi_3373_ = _e851;
                                            }
                                            let _e853 = phi_3373_;
                                            phi_3377_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e731, (_e549.member.member.x + _e683), _e736, (_e549.member.member_1.x - _e722)), vec4<f32>(_e732, (_e549.member.member.y + _e687), _e737, (_e549.member.member_1.y - _e726)), vec4<f32>(_e733, (_e549.member.member.z + _e691), _e738, (_e549.member.member_1.z - _e730))), type_50(type_32((_e549.member.member + vec4<f32>(_e661, _e670, _e679, 0f)), (_e549.member.member_1 - vec4<f32>(_e700, _e709, _e718, 0f))), _e828), type_50(type_32((_e549.member.member + vec4<f32>(_e683, _e687, _e691, 0f)), (_e549.member.member_1 - vec4<f32>(_e722, _e726, _e730, 0f))), _e853));
                                        }
                                        let _e858 = phi_3377_;
                                        let _e871 = ((_e858.member[0].x - _e336) * _e341);
                                        let _e872 = ((_e858.member[0].y - _e336) * _e341);
                                        let _e873 = ((_e858.member[0].z - _e337) * _e341);
                                        let _e874 = ((_e858.member[0].w - _e337) * _e341);
                                        let _e884 = ((_e858.member[1].x - _e374) * _e379);
                                        let _e885 = ((_e858.member[1].y - _e374) * _e379);
                                        let _e886 = ((_e858.member[1].z - _e375) * _e379);
                                        let _e887 = ((_e858.member[1].w - _e375) * _e379);
                                        let _e897 = ((_e858.member[2].x - _e412) * _e417);
                                        let _e898 = ((_e858.member[2].y - _e412) * _e417);
                                        let _e899 = ((_e858.member[2].z - _e413) * _e417);
                                        let _e900 = ((_e858.member[2].w - _e413) * _e417);
                                        let _e902 = select(_e899, _e897, (_e897 < _e899));
                                        let _e904 = select(_e900, _e898, (_e898 < _e900));
                                        let _e906 = select(_e899, _e897, (_e897 > _e899));
                                        let _e908 = select(_e900, _e898, (_e898 > _e900));
                                        let _e910 = select(_e873, _e871, (_e871 < _e873));
                                        let _e912 = select(_e874, _e872, (_e872 < _e874));
                                        let _e914 = select(_e886, _e884, (_e884 < _e886));
                                        let _e916 = select(_e887, _e885, (_e885 < _e887));
                                        let _e918 = select(_e914, _e910, (_e910 > _e914));
                                        let _e920 = select(_e916, _e912, (_e912 > _e916));
                                        let _e922 = select(_e902, _e918, (_e918 > _e902));
                                        let _e924 = select(_e904, _e920, (_e920 > _e904));
                                        let _e926 = select(_e873, _e871, (_e871 > _e873));
                                        let _e928 = select(_e874, _e872, (_e872 > _e874));
                                        let _e930 = select(_e886, _e884, (_e884 > _e886));
                                        let _e932 = select(_e887, _e885, (_e885 > _e887));
                                        let _e934 = select(_e930, _e926, (_e926 < _e930));
                                        let _e936 = select(_e932, _e928, (_e928 < _e932));
                                        let _e941 = -(_e902);
                                        let _e942 = -(_e904);
                                        let _e949 = (select(_e906, _e934, (_e934 < _e906)) + (select(_e941, _e906, (_e906 > _e941)) * 0.0000019073523f));
                                        let _e950 = (select(_e908, _e936, (_e936 < _e908)) + (select(_e942, _e908, (_e908 > _e942)) * 0.0000019073523f));
                                        let _e952 = select(_e464, _e922, (_e922 > _e464));
                                        let _e954 = select(_e464, _e924, (_e924 > _e464));
                                        let _e959 = (_e952 <= select(_e509.member.member_1, _e949, (_e949 < _e509.member.member_1)));
                                        let _e960 = (_e954 <= select(_e509.member.member_1, _e950, (_e950 < _e509.member.member_1)));
                                        let _e961 = (_e952 <= _e954);
                                        if _e959 {
                                            if _e960 {
                                                if _e961 {
                                                    phi_3721_ = _e858.member_2;
                                                } else {
                                                    phi_3721_ = _e858.member_1;
                                                }
                                                let _e965 = phi_3721_;
                                                let _e987 = (_e553 % 128u);
                                                let _e988 = (_e987 < 128u);
                                                if _e988 {
                                                } else {
                                                    phi_4230_ = true;
                                                    break;
                                                }
                                                local_8[_e987] = _e965.member_1;
                                                if _e988 {
                                                } else {
                                                    phi_4230_ = true;
                                                    break;
                                                }
                                                local_7[_e987] = _e965.member.member.x;
                                                if _e988 {
                                                } else {
                                                    phi_4230_ = true;
                                                    break;
                                                }
                                                local_6[_e987] = _e965.member.member.y;
                                                if _e988 {
                                                } else {
                                                    phi_4230_ = true;
                                                    break;
                                                }
                                                local_5[_e987] = _e965.member.member.z;
                                                if _e988 {
                                                } else {
                                                    phi_4230_ = true;
                                                    break;
                                                }
                                                local_4[_e987] = _e965.member.member_1.x;
                                                if _e988 {
                                                } else {
                                                    phi_4230_ = true;
                                                    break;
                                                }
                                                local_3[_e987] = _e965.member.member_1.y;
                                                if _e988 {
                                                } else {
                                                    phi_4230_ = true;
                                                    break;
                                                }
                                                local_2[_e987] = _e965.member.member_1.z;
                                                if _e988 {
                                                } else {
                                                    phi_4230_ = true;
                                                    break;
                                                }
                                                local_9[_e987] = select(_e954, _e952, (_e952 > _e954));
                                                if _e961 {
                                                    phi_3798_ = _e858.member_1;
                                                } else {
                                                    phi_3798_ = _e858.member_2;
                                                }
                                                let _e1001 = phi_3798_;
                                                phi_3799_ = _e1001;
                                                phi_3800_ = (_e553 + 1u);
                                            } else {
                                                phi_3799_ = type_50();
                                                phi_3800_ = u32();
                                            }
                                            let _e1003 = phi_3799_;
                                            let _e1005 = phi_3800_;
                                            phi_3802_ = _e1003;
                                            phi_3803_ = _e1005;
                                            phi_3804_ = select(true, false, _e960);
                                        } else {
                                            phi_3802_ = type_50();
                                            phi_3803_ = u32();
                                            phi_3804_ = true;
                                        }
                                        let _e1008 = phi_3802_;
                                        let _e1010 = phi_3803_;
                                        let _e1012 = phi_3804_;
                                        if _e1012 {
                                            if _e959 {
                                                phi_3813_ = _e858.member_1;
                                            } else {
                                                phi_3813_ = _e858.member_2;
                                            }
                                            let _e1016 = phi_3813_;
                                            phi_3818_ = _e1016;
                                            phi_3819_ = select(_e960, true, _e959);
                                        } else {
                                            phi_3818_ = _e1008;
                                            phi_3819_ = _e551;
                                        }
                                        let _e1019 = phi_3818_;
                                        let _e1021 = phi_3819_;
                                        phi_4234_ = _e507;
                                        phi_3821_ = type_43(_e509.member, (_e509.member_1 + 1u), _e509.member_2);
                                        phi_3822_ = _e1019;
                                        phi_3823_ = _e1021;
                                        phi_3824_ = select(_e1010, _e553, _e1012);
                                    }
                                    let _e1959 = phi_4234_;
                                    let _e1961 = phi_3821_;
                                    let _e1963 = phi_3822_;
                                    let _e1965 = phi_3823_;
                                    let _e1967 = phi_3824_;
                                    phi_4233_ = _e1959;
                                    phi_3825_ = _e1961;
                                    phi_3826_ = _e1963;
                                    phi_3827_ = (_e513 - 1u);
                                    phi_3828_ = _e1965;
                                    phi_3829_ = _e1967;
                                } else {
                                    phi_4233_ = _e507;
                                    phi_3825_ = _e509;
                                    phi_3826_ = _e549;
                                    phi_3827_ = _e513;
                                    phi_3828_ = _e551;
                                    phi_3829_ = _e553;
                                }
                                let _e1969 = phi_4233_;
                                let _e1971 = phi_3825_;
                                let _e1973 = phi_3826_;
                                let _e1975 = phi_3827_;
                                let _e1977 = phi_3828_;
                                let _e1979 = phi_3829_;
                                phi_4232_ = _e1969;
                                phi_3830_ = _e1971;
                                phi_3831_ = _e1973;
                                phi_3832_ = _e1975;
                                phi_3833_ = _e1977;
                                phi_3834_ = _e1979;
                            } else {
                                phi_4232_ = _e507;
                                phi_3830_ = type_43();
                                phi_3831_ = type_50();
                                phi_3832_ = u32();
                                phi_3833_ = bool();
                                phi_3834_ = u32();
                            }
                            let _e1981 = phi_4232_;
                            let _e1983 = phi_3830_;
                            let _e1985 = phi_3831_;
                            let _e1987 = phi_3832_;
                            let _e1989 = phi_3833_;
                            let _e1991 = phi_3834_;
                            phi_4231_ = _e1981;
                            phi_855_ = _e1983;
                            phi_858_ = _e1985;
                            phi_860_ = _e1987;
                            phi_862_ = _e1989;
                            phi_864_ = _e1991;
                            phi_3835_ = _e521;
                        } else {
                            phi_4231_ = _e507;
                            phi_855_ = type_43();
                            phi_858_ = type_50();
                            phi_860_ = u32();
                            phi_862_ = bool();
                            phi_864_ = u32();
                            phi_3835_ = false;
                        }
                        let _e1993 = phi_4231_;
                        let _e1995 = phi_855_;
                        let _e1997 = phi_858_;
                        let _e1999 = phi_860_;
                        let _e2001 = phi_862_;
                        let _e2003 = phi_864_;
                        let _e2005 = phi_3835_;
                        continue;
                        continuing {
                            phi_4047_ = _e1993;
                            phi_854_ = _e1995;
                            phi_857_ = _e1997;
                            phi_859_ = _e1999;
                            phi_861_ = _e2001;
                            phi_863_ = _e2003;
                            phi_4230_ = _e1993;
                            break if !(_e2005);
                        }
                    }
                    let _e2008 = phi_4230_;
                    if _e2008 {
                        break;
                    }
                    let _e2010 = local_10;
                    let _e2013 = local_11;
                    if _e152 {
                    } else {
                        break;
                    }
                    global_6.member[_e150][0u] = _e2010.member_1;
                    global_6.member[_e150][1u] = _e2013.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
