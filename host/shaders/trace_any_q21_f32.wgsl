struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: vec4<u32>,
}

struct type_16 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_24 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: array<type_25>,
}

struct type_38 {
    member: f32,
    member_1: bool,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<array<u32, 7>>,
}

struct type_49 {
    member: type_28,
    member_1: u32,
}

struct type_50 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(3) 
var<storage> global_2: type_18;
@group(0) @binding(1) 
var<uniform> global_3: type_40;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(2) 
var<storage> global_6: type_44;

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
    var phi_823_: type_38;
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
    var phi_949_: type_38;
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
    var phi_1891_: type_24;
    var phi_1893_: type_24;
    var phi_1894_: bool;
    var phi_1898_: type_24;
    var phi_1899_: type_24;
    var phi_1900_: type_24;
    var phi_1901_: bool;
    var phi_1905_: type_24;
    var phi_1906_: bool;
    var phi_1907_: type_24;
    var phi_1908_: bool;
    var phi_1909_: bool;
    var phi_1910_: type_24;
    var phi_1911_: bool;
    var phi_1912_: bool;
    var phi_1920_: type_24;
    var phi_1921_: bool;
    var phi_1925_: type_24;
    var phi_1936_: type_38;
    var phi_1937_: type_38;
    var phi_950_: type_38;
    var phi_3376_: bool;
    var local_10: type_38;
    var phi_3519_: bool;
    var phi_3143_: type_38;
    var phi_3144_: type_49;
    var phi_3145_: bool;
    var phi_3146_: u32;
    var phi_3518_: bool;
    var phi_3147_: type_38;
    var phi_3148_: type_49;
    var phi_3149_: u32;
    var phi_3150_: bool;
    var phi_3151_: u32;
    var phi_3517_: bool;
    var phi_3152_: type_38;
    var phi_3153_: type_49;
    var phi_3154_: u32;
    var phi_3155_: bool;
    var phi_3156_: u32;
    var phi_3516_: bool;
    var phi_824_: type_38;
    var phi_827_: type_49;
    var phi_829_: u32;
    var phi_831_: bool;
    var phi_833_: u32;
    var phi_3157_: bool;
    var phi_3515_: bool;
    var local_11: type_38;
    var local_12: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e83 = global;
            let _e85 = arrayLength((&global_6.member));
            let _e87 = arrayLength((&global_2.member));
            let _e95 = global_3.member[0u][0u];
            let _e99 = global_3.member[0u][1u];
            let _e103 = global_3.member[0u][2u];
            let _e107 = global_3.member[0u][3u];
            let _e111 = global_3.member[1u][0u];
            let _e115 = global_3.member[1u][1u];
            let _e119 = global_3.member[1u][2u];
            let _e122 = global_1.member[0u];
            let _e123 = bitcast<i32>(_e122);
            let _e135 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e107) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e95), bitcast<i32>(_e99), bitcast<i32>(_e103));
            local = array<i32, 3>(bitcast<i32>(_e111), bitcast<i32>(_e115), bitcast<i32>(_e119));
            let _e141 = (_e83.x + (_e83.y * 2097152u));
            let _e142 = (_e141 < arrayLength((&global_4.member)));
            if _e142 {
                let _e143 = (_e141 < arrayLength((&global_5.member)));
                if _e143 {
                    if _e142 {
                    } else {
                        break;
                    }
                    let _e151 = global_4.member[_e141].member_2[0u];
                    let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                    let _e158 = global_4.member[_e141].member_2[1u];
                    let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                    let _e165 = global_4.member[_e141].member_2[2u];
                    let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                    let _e172 = global_4.member[_e141].member[0u];
                    let _e174 = (bitcast<u32>(_e172) & 2147483647u);
                    let _e179 = global_4.member[_e141].member[1u];
                    let _e181 = (bitcast<u32>(_e179) & 2147483647u);
                    let _e186 = global_4.member[_e141].member[2u];
                    let _e188 = (bitcast<u32>(_e186) & 2147483647u);
                    let _e190 = select(_e160, _e153, (_e160 < _e153));
                    let _e192 = select(_e167, _e190, (_e167 < _e190));
                    let _e194 = select(_e174, _e192, (_e174 < _e192));
                    let _e196 = select(_e181, _e194, (_e181 < _e194));
                    let _e198 = select(_e188, _e196, (_e188 < _e196));
                    let _e202 = global_4.member[_e141].member_1;
                    let _e204 = (bitcast<u32>(_e202) & 2147483647u);
                    let _e211 = global_4.member[_e141].member_3;
                    let _e217 = (((select(_e204, _e198, (_e204 < _e198)) < 2139095040u) && ((bitcast<u32>(_e211) & 2147483647u) <= 2139095040u)) && (_e192 > 0u));
                    if _e217 {
                        let _e220 = (bitcast<u32>(bitcast<f32>(_e192)) & 2147483647u);
                        if (_e220 >= 8388608u) {
                            phi_365_ = (bitcast<i32>((_e220 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_365_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e220)), 32u, (_e220 == 0u))));
                        }
                        let _e234 = phi_365_;
                        phi_366_ = _e234;
                    } else {
                        phi_366_ = 0i;
                    }
                    let _e236 = phi_366_;
                    let _e237 = (_e153 == _e192);
                    if _e237 {
                        phi_376_ = true;
                    } else {
                        phi_376_ = (_e160 == _e192);
                    }
                    let _e240 = phi_376_;
                    let _e241 = select(1u, 0u, _e237);
                    if _e240 {
                        let _e242 = (_e241 + 1u);
                        phi_386_ = _e242;
                        phi_387_ = _e242;
                        phi_389_ = select(true, false, (_e242 == 2u));
                    } else {
                        phi_386_ = u32();
                        phi_387_ = 0u;
                        phi_389_ = true;
                    }
                    let _e246 = phi_386_;
                    let _e248 = phi_387_;
                    let _e250 = phi_389_;
                    if _e250 {
                        phi_394_ = (_e248 + 1u);
                    } else {
                        phi_394_ = 0u;
                    }
                    let _e254 = phi_394_;
                    let _e255 = select(_e246, _e248, _e250);
                    let _e256 = select(_e241, select(2u, _e241, _e240), _e250);
                    if (_e123 < -126i) {
                        phi_406_ = -126i;
                    } else {
                        phi_406_ = select(_e123, 127i, (_e123 > 127i));
                    }
                    let _e261 = phi_406_;
                    let _e266 = bitcast<f32>((bitcast<u32>((_e261 + 127i)) << bitcast<u32>(23i)));
                    let _e272 = bitcast<f32>((bitcast<u32>(((_e123 - _e261) + 127i)) << bitcast<u32>(23i)));
                    let _e273 = -(_e236);
                    if (_e273 < -126i) {
                        phi_426_ = -126i;
                    } else {
                        phi_426_ = select(_e273, 127i, (_e273 > 127i));
                    }
                    let _e278 = phi_426_;
                    let _e283 = bitcast<f32>((bitcast<u32>((_e278 + 127i)) << bitcast<u32>(23i)));
                    let _e289 = bitcast<f32>((bitcast<u32>(((_e273 - _e278) + 127i)) << bitcast<u32>(23i)));
                    let _e293 = global_4.member[_e141].member;
                    let _e294 = (_e255 == 0u);
                    if _e294 {
                        phi_444_ = _e293[0];
                    } else {
                        phi_444_ = _e293[1];
                    }
                    let _e298 = phi_444_;
                    let _e299 = (_e255 == 2u);
                    if _e299 {
                        phi_450_ = _e293[2];
                    } else {
                        phi_450_ = _e298;
                    }
                    let _e302 = phi_450_;
                    let _e304 = ((_e302 * _e266) * _e272);
                    let _e305 = global_4.member[_e141].member_2;
                    if _e294 {
                        phi_461_ = _e305[0];
                    } else {
                        phi_461_ = _e305[1];
                    }
                    let _e309 = phi_461_;
                    if _e299 {
                        phi_467_ = _e305[2];
                    } else {
                        phi_467_ = _e309;
                    }
                    let _e312 = phi_467_;
                    let _e314 = ((_e312 * _e283) * _e289);
                    let _e318 = (bitcast<f32>((bitcast<u32>(_e314) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e318 {
                        let _e322 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) * 0.00000011920929f);
                        phi_490_ = select(0.00000000000011368684f, _e322, (_e322 > 0.00000000000011368684f));
                    } else {
                        phi_490_ = 0f;
                    }
                    let _e326 = phi_490_;
                    let _e327 = (_e304 + _e326);
                    let _e328 = (_e304 - _e326);
                    let _e329 = select(_e314, 0f, _e318);
                    if _e318 {
                        phi_501_ = 38685626000000000000000000f;
                    } else {
                        phi_501_ = (1f / _e314);
                    }
                    let _e332 = phi_501_;
                    let _e333 = (_e254 == 0u);
                    if _e333 {
                        phi_510_ = _e293[0];
                    } else {
                        phi_510_ = _e293[1];
                    }
                    let _e337 = phi_510_;
                    let _e338 = (_e254 == 2u);
                    if _e338 {
                        phi_516_ = _e293[2];
                    } else {
                        phi_516_ = _e337;
                    }
                    let _e341 = phi_516_;
                    let _e343 = ((_e341 * _e266) * _e272);
                    if _e333 {
                        phi_527_ = _e305[0];
                    } else {
                        phi_527_ = _e305[1];
                    }
                    let _e347 = phi_527_;
                    if _e338 {
                        phi_533_ = _e305[2];
                    } else {
                        phi_533_ = _e347;
                    }
                    let _e350 = phi_533_;
                    let _e352 = ((_e350 * _e283) * _e289);
                    let _e356 = (bitcast<f32>((bitcast<u32>(_e352) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e356 {
                        let _e360 = (bitcast<f32>((bitcast<u32>(_e343) & 2147483647u)) * 0.00000011920929f);
                        phi_556_ = select(0.00000000000011368684f, _e360, (_e360 > 0.00000000000011368684f));
                    } else {
                        phi_556_ = 0f;
                    }
                    let _e364 = phi_556_;
                    let _e365 = (_e343 + _e364);
                    let _e366 = (_e343 - _e364);
                    let _e367 = select(_e352, 0f, _e356);
                    if _e356 {
                        phi_567_ = 38685626000000000000000000f;
                    } else {
                        phi_567_ = (1f / _e352);
                    }
                    let _e370 = phi_567_;
                    let _e371 = (_e256 == 0u);
                    if _e371 {
                        phi_576_ = _e293[0];
                    } else {
                        phi_576_ = _e293[1];
                    }
                    let _e375 = phi_576_;
                    let _e376 = (_e256 == 2u);
                    if _e376 {
                        phi_582_ = _e293[2];
                    } else {
                        phi_582_ = _e375;
                    }
                    let _e379 = phi_582_;
                    let _e381 = ((_e379 * _e266) * _e272);
                    if _e371 {
                        phi_593_ = _e305[0];
                    } else {
                        phi_593_ = _e305[1];
                    }
                    let _e385 = phi_593_;
                    if _e376 {
                        phi_599_ = _e305[2];
                    } else {
                        phi_599_ = _e385;
                    }
                    let _e388 = phi_599_;
                    let _e390 = ((_e388 * _e283) * _e289);
                    let _e394 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e394 {
                        let _e398 = (bitcast<f32>((bitcast<u32>(_e381) & 2147483647u)) * 0.00000011920929f);
                        phi_622_ = select(0.00000000000011368684f, _e398, (_e398 > 0.00000000000011368684f));
                    } else {
                        phi_622_ = 0f;
                    }
                    let _e402 = phi_622_;
                    let _e403 = (_e381 + _e402);
                    let _e404 = (_e381 - _e402);
                    let _e405 = select(_e390, 0f, _e394);
                    if _e394 {
                        phi_633_ = 38685626000000000000000000f;
                    } else {
                        phi_633_ = (1f / _e390);
                    }
                    let _e408 = phi_633_;
                    let _e411 = bitcast<f32>((bitcast<u32>(_e304) & 2147483647u));
                    let _e414 = bitcast<f32>((bitcast<u32>(_e343) & 2147483647u));
                    let _e416 = select(_e414, _e411, (_e411 > _e414));
                    let _e419 = bitcast<f32>((bitcast<u32>(_e381) & 2147483647u));
                    let _e422 = (_e123 + _e236);
                    if (_e217 && (select(_e419, _e416, (_e416 > _e419)) <= 1099511600000f)) {
                        let _e425 = (_e422 / 3i);
                        let _e432 = bitcast<f32>((bitcast<u32>((_e425 + 127i)) << bitcast<u32>(23i)));
                        let _e439 = bitcast<f32>((bitcast<u32>(((_e422 - (2i * _e425)) + 127i)) << bitcast<u32>(23i)));
                        let _e440 = (((_e202 * _e432) * _e432) * _e439);
                        let _e442 = select(340282350000000000000000000000000000000f, _e440, (_e440 < 340282350000000000000000000000000000000f));
                        let _e447 = (((_e211 * _e432) * _e432) * _e439);
                        let _e449 = select(340282350000000000000000000000000000000f, _e447, (_e447 < 340282350000000000000000000000000000000f));
                        phi_733_ = select(-340282350000000000000000000000000000000f, _e449, (_e449 > -340282350000000000000000000000000000000f));
                        phi_734_ = select(-340282350000000000000000000000000000000f, _e442, (_e442 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_733_ = 0f;
                        phi_734_ = 1f;
                    }
                    let _e453 = phi_733_;
                    let _e455 = phi_734_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e459 = (_e255 % 3u);
                    let _e460 = (_e459 < 3u);
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e462 = local_1[_e459];
                    let _e465 = (_e254 % 3u);
                    let _e466 = (_e465 < 3u);
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e468 = local_1[_e465];
                    let _e471 = (_e256 % 3u);
                    let _e472 = (_e471 < 3u);
                    if _e472 {
                    } else {
                        break;
                    }
                    let _e474 = local_1[_e471];
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e479 = local[_e459];
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e483 = local[_e465];
                    if _e472 {
                    } else {
                        break;
                    }
                    let _e487 = local[_e471];
                    phi_3382_ = false;
                    phi_823_ = type_38(_e453, false);
                    phi_826_ = type_49(type_28(vec4<f32>((f32(_e462) * _e135), (f32(_e468) * _e135), (f32(_e474) * _e135), 0f), vec4<f32>((f32(_e479) * _e135), (f32(_e483) * _e135), (f32(_e487) * _e135), 0f)), select(0u, 2147483648u, (_e85 == 0u)));
                    phi_828_ = ((3u * _e85) + 1u);
                    phi_830_ = (_e455 <= _e453);
                    phi_832_ = 0u;
                    loop {
                        let _e497 = phi_3382_;
                        let _e499 = phi_823_;
                        let _e501 = phi_826_;
                        let _e503 = phi_828_;
                        let _e505 = phi_830_;
                        let _e507 = phi_832_;
                        local_11 = _e499;
                        if _e505 {
                            phi_843_ = true;
                        } else {
                            phi_843_ = (_e507 > 0u);
                        }
                        let _e510 = phi_843_;
                        if _e510 {
                            let _e511 = (_e503 > 0u);
                            if _e511 {
                                if _e505 {
                                    phi_929_ = _e501;
                                    phi_930_ = _e505;
                                    phi_931_ = _e507;
                                } else {
                                    let _e512 = (_e507 - 1u);
                                    let _e513 = (_e512 % 128u);
                                    let _e514 = (_e513 < 128u);
                                    if _e514 {
                                    } else {
                                        phi_3515_ = true;
                                        break;
                                    }
                                    let _e516 = local_7[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3515_ = true;
                                        break;
                                    }
                                    let _e518 = local_6[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3515_ = true;
                                        break;
                                    }
                                    let _e520 = local_5[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3515_ = true;
                                        break;
                                    }
                                    let _e522 = local_4[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3515_ = true;
                                        break;
                                    }
                                    let _e524 = local_3[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3515_ = true;
                                        break;
                                    }
                                    let _e526 = local_2[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3515_ = true;
                                        break;
                                    }
                                    let _e531 = local_8[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3515_ = true;
                                        break;
                                    }
                                    let _e534 = local_9[_e513];
                                    phi_929_ = type_49(type_28(vec4<f32>(_e516, _e518, _e520, 0f), vec4<f32>(_e522, _e524, _e526, 0f)), _e531);
                                    phi_930_ = (_e534 <= _e499.member);
                                    phi_931_ = _e512;
                                }
                                let _e538 = phi_929_;
                                let _e540 = phi_930_;
                                let _e542 = phi_931_;
                                if _e540 {
                                    if ((_e538.member_1 & 2147483648u) != 0u) {
                                        phi_949_ = _e499;
                                        phi_952_ = type_7(0u, ((_e538.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1004 = phi_949_;
                                            let _e1006 = phi_952_;
                                            local_10 = _e1004;
                                            local_12 = _e1004;
                                            if (_e1006.member < _e1006.member_1) {
                                                phi_953_ = type_7((_e1006.member + 1u), _e1006.member_1);
                                                phi_975_ = type_7(1u, _e1006.member);
                                            } else {
                                                phi_953_ = _e1006;
                                                phi_975_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e1019 = phi_953_;
                                            let _e1021 = phi_975_;
                                            let _e1025 = (bitcast<i32>(_e1021.member) != 0i);
                                            if _e1025 {
                                                let _e1026 = ((_e538.member_1 & 268435455u) + _e1021.member_1);
                                                let _e1027 = (_e1026 < _e87);
                                                if _e1027 {
                                                    if _e1027 {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1031 = global_2.member[_e1026].member_1;
                                                    phi_996_ = _e1031;
                                                } else {
                                                    phi_996_ = 4294967295u;
                                                }
                                                let _e1033 = phi_996_;
                                                if (_e1026 >= _e87) {
                                                    phi_1085_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1027 {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    if (_e459 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1040 = global_2.member[_e1026].member[_e459];
                                                    if (_e465 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1046 = global_2.member[_e1026].member[_e465];
                                                    if (_e471 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1052 = global_2.member[_e1026].member[_e471];
                                                    let _e1054 = (3u + _e459);
                                                    if (_e1054 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1060 = global_2.member[_e1026].member[_e1054];
                                                    let _e1061 = (3u + _e465);
                                                    if (_e1061 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1067 = global_2.member[_e1026].member[_e1061];
                                                    let _e1068 = (3u + _e471);
                                                    if (_e1068 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1074 = global_2.member[_e1026].member[_e1068];
                                                    let _e1076 = (6u + _e459);
                                                    if (_e1076 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1082 = global_2.member[_e1026].member[_e1076];
                                                    let _e1083 = (6u + _e465);
                                                    if (_e1083 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1089 = global_2.member[_e1026].member[_e1083];
                                                    let _e1090 = (6u + _e471);
                                                    if (_e1090 < 9u) {
                                                    } else {
                                                        phi_3376_ = true;
                                                        break;
                                                    }
                                                    let _e1096 = global_2.member[_e1026].member[_e1090];
                                                    phi_1085_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1040, _e1046, _e1052), array<f32, 3>(_e1060, _e1067, _e1074), array<f32, 3>(_e1082, _e1089, _e1096));
                                                }
                                                let _e1100 = phi_1085_;
                                                let _e1108 = (_e1100[0][2] - _e381);
                                                let _e1111 = (((_e1100[0][0] - _e304) * _e405) - (_e1108 * _e329));
                                                let _e1114 = (((_e1100[0][1] - _e343) * _e405) - (_e1108 * _e367));
                                                let _e1121 = (_e1100[1][2] - _e381);
                                                let _e1124 = (((_e1100[1][0] - _e304) * _e405) - (_e1121 * _e329));
                                                let _e1127 = (((_e1100[1][1] - _e343) * _e405) - (_e1121 * _e367));
                                                let _e1134 = (_e1100[2][2] - _e381);
                                                let _e1137 = (((_e1100[2][0] - _e304) * _e405) - (_e1134 * _e329));
                                                let _e1140 = (((_e1100[2][1] - _e343) * _e405) - (_e1134 * _e367));
                                                let _e1141 = (_e1137 * _e1127);
                                                let _e1142 = (_e1140 * _e1124);
                                                let _e1143 = (_e1111 * _e1140);
                                                let _e1144 = (_e1114 * _e1137);
                                                let _e1145 = (_e1124 * _e1114);
                                                let _e1146 = (_e1127 * _e1111);
                                                let _e1151 = (((_e1141 >= _e1142) && (_e1143 >= _e1144)) && (_e1145 >= _e1146));
                                                if (_e1151 || (((_e1141 <= _e1142) && (_e1143 <= _e1144)) && (_e1145 <= _e1146))) {
                                                    let _e1158 = select(-1f, 1f, _e1151);
                                                    let _e1160 = ((_e1141 - _e1142) * _e1158);
                                                    let _e1162 = select(0f, _e1160, (_e1160 > 0f));
                                                    let _e1164 = ((_e1143 - _e1144) * _e1158);
                                                    let _e1166 = select(0f, _e1164, (_e1164 > 0f));
                                                    let _e1168 = ((_e1145 - _e1146) * _e1158);
                                                    let _e1170 = select(0f, _e1168, (_e1168 > 0f));
                                                    let _e1172 = ((_e1162 + _e1166) + _e1170);
                                                    if (_e1172 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1910_ = type_24();
                                                        phi_1911_ = true;
                                                        phi_1912_ = false;
                                                    } else {
                                                        let _e1175 = select(_e1124, _e1111, (_e1111 < _e1124));
                                                        if (select(_e1137, _e1175, (_e1175 < _e1137)) > 0f) {
                                                            phi_1202_ = true;
                                                        } else {
                                                            let _e1180 = select(_e1124, _e1111, (_e1111 > _e1124));
                                                            phi_1202_ = (select(_e1137, _e1180, (_e1180 > _e1137)) < 0f);
                                                        }
                                                        let _e1185 = phi_1202_;
                                                        if _e1185 {
                                                            phi_1907_ = type_24();
                                                            phi_1908_ = true;
                                                            phi_1909_ = false;
                                                        } else {
                                                            let _e1187 = select(_e1127, _e1114, (_e1114 < _e1127));
                                                            if (select(_e1140, _e1187, (_e1187 < _e1140)) > 0f) {
                                                                phi_1231_ = true;
                                                            } else {
                                                                let _e1192 = select(_e1127, _e1114, (_e1114 > _e1127));
                                                                phi_1231_ = (select(_e1140, _e1192, (_e1192 > _e1140)) < 0f);
                                                            }
                                                            let _e1197 = phi_1231_;
                                                            if _e1197 {
                                                                phi_1905_ = type_24();
                                                                phi_1906_ = false;
                                                            } else {
                                                                let _e1199 = select(_e1100[1][0], _e1100[0][0], (_e1100[0][0] < _e1100[1][0]));
                                                                let _e1203 = select(_e1100[1][0], _e1100[0][0], (_e1100[0][0] > _e1100[1][0]));
                                                                let _e1207 = select(_e1100[1][1], _e1100[0][1], (_e1100[0][1] < _e1100[1][1]));
                                                                let _e1211 = select(_e1100[1][1], _e1100[0][1], (_e1100[0][1] > _e1100[1][1]));
                                                                let _e1215 = select(_e1100[1][2], _e1100[0][2], (_e1100[0][2] < _e1100[1][2]));
                                                                let _e1219 = select(_e1100[1][2], _e1100[0][2], (_e1100[0][2] > _e1100[1][2]));
                                                                let _e1224 = ((select(_e1100[2][0], _e1199, (_e1199 < _e1100[2][0])) - _e327) * _e332);
                                                                let _e1225 = ((select(_e1100[2][0], _e1203, (_e1203 > _e1100[2][0])) - _e328) * _e332);
                                                                let _e1228 = ((select(_e1100[2][1], _e1207, (_e1207 < _e1100[2][1])) - _e365) * _e370);
                                                                let _e1229 = ((select(_e1100[2][1], _e1211, (_e1211 > _e1100[2][1])) - _e366) * _e370);
                                                                let _e1232 = ((select(_e1100[2][2], _e1215, (_e1215 < _e1100[2][2])) - _e403) * _e408);
                                                                let _e1233 = ((select(_e1100[2][2], _e1219, (_e1219 > _e1100[2][2])) - _e404) * _e408);
                                                                let _e1235 = select(_e1233, _e1232, (_e1232 < _e1233));
                                                                let _e1237 = select(_e1233, _e1232, (_e1232 > _e1233));
                                                                let _e1239 = select(_e1225, _e1224, (_e1224 < _e1225));
                                                                let _e1241 = select(_e1229, _e1228, (_e1228 < _e1229));
                                                                let _e1243 = select(_e1241, _e1239, (_e1239 > _e1241));
                                                                let _e1245 = select(_e1235, _e1243, (_e1243 > _e1235));
                                                                let _e1247 = select(_e1225, _e1224, (_e1224 > _e1225));
                                                                let _e1249 = select(_e1229, _e1228, (_e1228 > _e1229));
                                                                let _e1251 = select(_e1249, _e1247, (_e1247 < _e1249));
                                                                let _e1253 = select(_e1237, _e1251, (_e1251 < _e1237));
                                                                let _e1254 = -(_e1235);
                                                                let _e1260 = select(_e455, _e1245, (_e1245 > _e455));
                                                                if (_e1260 > (_e1253 + (select(_e1254, _e1237, (_e1237 > _e1254)) * 0.0000019073523f))) {
                                                                    phi_1900_ = type_24();
                                                                    phi_1901_ = true;
                                                                } else {
                                                                    let _e1262 = (_e1260 > _e1004.member);
                                                                    if _e1262 {
                                                                        phi_1899_ = type_24();
                                                                    } else {
                                                                        let _e1263 = vec3<f32>(_e1100[0][0], _e1100[0][1], _e1100[0][2]);
                                                                        let _e1264 = vec3<f32>(_e1100[1][0], _e1100[1][1], _e1100[1][2]);
                                                                        let _e1265 = vec3<f32>(_e1100[2][0], _e1100[2][1], _e1100[2][2]);
                                                                        let _e1266 = (_e1100[1][0] - _e1100[0][0]);
                                                                        let _e1267 = (_e1100[1][1] - _e1100[0][1]);
                                                                        let _e1268 = (_e1100[1][2] - _e1100[0][2]);
                                                                        let _e1269 = vec3<f32>(_e1266, _e1267, _e1268);
                                                                        let _e1270 = (_e1100[2][0] - _e1100[1][0]);
                                                                        let _e1271 = (_e1100[2][1] - _e1100[1][1]);
                                                                        let _e1272 = (_e1100[2][2] - _e1100[1][2]);
                                                                        let _e1273 = vec3<f32>(_e1270, _e1271, _e1272);
                                                                        let _e1274 = (_e1100[0][0] - _e1100[2][0]);
                                                                        let _e1275 = (_e1100[0][1] - _e1100[2][1]);
                                                                        let _e1276 = (_e1100[0][2] - _e1100[2][2]);
                                                                        let _e1277 = vec3<f32>(_e1274, _e1275, _e1276);
                                                                        let _e1280 = bitcast<f32>((bitcast<u32>(_e1266) & 2147483647u));
                                                                        let _e1283 = bitcast<f32>((bitcast<u32>(_e1267) & 2147483647u));
                                                                        let _e1285 = select(_e1283, _e1280, (_e1280 > _e1283));
                                                                        let _e1288 = bitcast<f32>((bitcast<u32>(_e1268) & 2147483647u));
                                                                        let _e1290 = select(_e1288, _e1285, (_e1285 > _e1288));
                                                                        let _e1293 = bitcast<f32>((bitcast<u32>(_e1270) & 2147483647u));
                                                                        let _e1296 = bitcast<f32>((bitcast<u32>(_e1271) & 2147483647u));
                                                                        let _e1298 = select(_e1296, _e1293, (_e1293 > _e1296));
                                                                        let _e1301 = bitcast<f32>((bitcast<u32>(_e1272) & 2147483647u));
                                                                        let _e1303 = select(_e1301, _e1298, (_e1298 > _e1301));
                                                                        let _e1306 = bitcast<f32>((bitcast<u32>(_e1274) & 2147483647u));
                                                                        let _e1309 = bitcast<f32>((bitcast<u32>(_e1275) & 2147483647u));
                                                                        let _e1311 = select(_e1309, _e1306, (_e1306 > _e1309));
                                                                        let _e1314 = bitcast<f32>((bitcast<u32>(_e1276) & 2147483647u));
                                                                        let _e1316 = select(_e1314, _e1311, (_e1311 > _e1314));
                                                                        let _e1318 = select(_e1303, _e1290, (_e1290 > _e1303));
                                                                        let _e1320 = select(_e1316, _e1318, (_e1318 > _e1316));
                                                                        if (_e1290 == _e1320) {
                                                                            phi_1632_ = _e1127;
                                                                            phi_1633_ = _e1124;
                                                                            phi_1634_ = _e1114;
                                                                            phi_1635_ = _e1111;
                                                                            phi_1636_ = _e1263;
                                                                            phi_1637_ = _e1277;
                                                                            phi_1638_ = _e1273;
                                                                            phi_1639_ = _e1269;
                                                                        } else {
                                                                            let _e1322 = (_e1303 == _e1320);
                                                                            let _e1327 = vec3(_e1322);
                                                                            phi_1632_ = select(_e1114, _e1140, _e1322);
                                                                            phi_1633_ = select(_e1111, _e1137, _e1322);
                                                                            phi_1634_ = select(_e1140, _e1127, _e1322);
                                                                            phi_1635_ = select(_e1137, _e1124, _e1322);
                                                                            phi_1636_ = select(_e1265, _e1264, _e1327);
                                                                            phi_1637_ = select(_e1273, _e1269, _e1327);
                                                                            phi_1638_ = select(_e1269, _e1277, _e1327);
                                                                            phi_1639_ = select(_e1277, _e1273, _e1327);
                                                                        }
                                                                        let _e1333 = phi_1632_;
                                                                        let _e1335 = phi_1633_;
                                                                        let _e1337 = phi_1634_;
                                                                        let _e1339 = phi_1635_;
                                                                        let _e1341 = phi_1636_;
                                                                        let _e1343 = phi_1637_;
                                                                        let _e1345 = phi_1638_;
                                                                        let _e1347 = phi_1639_;
                                                                        let _e1354 = ((_e1345.y * _e1343.z) - (_e1343.y * _e1345.z));
                                                                        let _e1359 = ((_e1345.z * _e1343.x) - (_e1343.z * _e1345.x));
                                                                        let _e1362 = ((_e1345.x * _e1343.y) - (_e1343.x * _e1345.y));
                                                                        if (_e1162 >= _e1166) {
                                                                            phi_1670_ = select(true, false, (_e1162 >= _e1170));
                                                                        } else {
                                                                            phi_1670_ = true;
                                                                        }
                                                                        let _e1367 = phi_1670_;
                                                                        if _e1367 {
                                                                            phi_1679_ = select(_e1265, _e1264, vec3((_e1166 >= _e1170)));
                                                                        } else {
                                                                            phi_1679_ = _e1263;
                                                                        }
                                                                        let _e1372 = phi_1679_;
                                                                        let _e1383 = (((_e1354 * (_e1372.x - _e304)) + (_e1359 * (_e1372.y - _e343))) + (_e1362 * (_e1372.z - _e381)));
                                                                        let _e1388 = (((_e1354 * _e329) + (_e1359 * _e367)) + (_e1362 * _e405));
                                                                        let _e1389 = (_e1335 - _e1339);
                                                                        let _e1390 = (_e1333 - _e1337);
                                                                        let _e1398 = (-(((_e1339 * _e1389) + (_e1337 * _e1390))) / ((_e1389 * _e1389) + (_e1390 * _e1390)));
                                                                        let _e1400 = select(1f, _e1398, (_e1398 < 1f));
                                                                        let _e1402 = select(0f, _e1400, (_e1400 > 0f));
                                                                        let _e1415 = ((_e1341.x + (_e1347.x * _e1402)) - _e304);
                                                                        let _e1416 = ((_e1341.y + (_e1347.y * _e1402)) - _e343);
                                                                        let _e1417 = ((_e1341.z + (_e1347.z * _e1402)) - _e381);
                                                                        let _e1418 = (_e1417 / _e405);
                                                                        let _e1430 = bitcast<f32>((bitcast<u32>(_e1415) & 2147483647u));
                                                                        let _e1433 = bitcast<f32>((bitcast<u32>(_e1416) & 2147483647u));
                                                                        let _e1435 = select(_e1433, _e1430, (_e1430 > _e1433));
                                                                        let _e1438 = bitcast<f32>((bitcast<u32>(_e1417) & 2147483647u));
                                                                        let _e1440 = select(_e1438, _e1435, (_e1435 > _e1438));
                                                                        let _e1446 = bitcast<f32>((bitcast<u32>(_e1354) & 2147483647u));
                                                                        let _e1449 = bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u));
                                                                        let _e1451 = select(_e1449, _e1446, (_e1446 > _e1449));
                                                                        let _e1454 = bitcast<f32>((bitcast<u32>(_e1362) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1354 * _e1415) + (_e1359 * _e1416)) + (_e1362 * _e1417)) - _e1383)) & 2147483647u)) <= ((0.0000009536743f * select(_e1320, _e1440, (_e1440 > _e1320))) * select(_e1454, _e1451, (_e1451 > _e1454)))) {
                                                                            let _e1464 = bitcast<f32>((bitcast<u32>(_e1345.x) & 2147483647u));
                                                                            let _e1467 = bitcast<f32>((bitcast<u32>(_e1345.y) & 2147483647u));
                                                                            let _e1469 = select(_e1467, _e1464, (_e1464 > _e1467));
                                                                            let _e1472 = bitcast<f32>((bitcast<u32>(_e1345.z) & 2147483647u));
                                                                            let _e1478 = bitcast<f32>((bitcast<u32>(_e1343.x) & 2147483647u));
                                                                            let _e1481 = bitcast<f32>((bitcast<u32>(_e1343.y) & 2147483647u));
                                                                            let _e1483 = select(_e1481, _e1478, (_e1478 > _e1481));
                                                                            let _e1486 = bitcast<f32>((bitcast<u32>(_e1343.z) & 2147483647u));
                                                                            let _e1490 = (bitcast<f32>((bitcast<u32>(_e1388) & 2147483647u)) > ((0.0000038146973f * select(_e1472, _e1469, (_e1469 > _e1472))) * select(_e1486, _e1483, (_e1483 > _e1486))));
                                                                            if _e1490 {
                                                                                phi_1844_ = (_e1383 / _e1388);
                                                                            } else {
                                                                                phi_1844_ = f32();
                                                                            }
                                                                            let _e1493 = phi_1844_;
                                                                            phi_1846_ = _e1493;
                                                                            phi_1847_ = select(true, false, _e1490);
                                                                        } else {
                                                                            phi_1846_ = f32();
                                                                            phi_1847_ = true;
                                                                        }
                                                                        let _e1496 = phi_1846_;
                                                                        let _e1498 = phi_1847_;
                                                                        if _e1498 {
                                                                            let _e1506 = (((_e1354 * (_e1415 - (_e329 * _e1418))) + (_e1359 * (_e1416 - (_e367 * _e1418)))) / _e1388);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1506) & 2147483647u)) <= _e1320) {
                                                                                phi_1867_ = (_e1418 + _e1506);
                                                                            } else {
                                                                                phi_1867_ = _e1418;
                                                                            }
                                                                            let _e1513 = phi_1867_;
                                                                            phi_1868_ = _e1513;
                                                                        } else {
                                                                            phi_1868_ = _e1496;
                                                                        }
                                                                        let _e1515 = phi_1868_;
                                                                        let _e1517 = select(_e1253, _e1515, (_e1515 < _e1253));
                                                                        let _e1519 = select(_e1245, _e1517, (_e1517 > _e1245));
                                                                        if (_e1519 >= _e455) {
                                                                            let _e1521 = (_e1519 <= _e1004.member);
                                                                            if _e1521 {
                                                                                let _e1522 = (1f / _e1172);
                                                                                phi_1891_ = type_24(_e1519, (_e1166 * _e1522), (_e1170 * _e1522), _e1033);
                                                                            } else {
                                                                                phi_1891_ = type_24();
                                                                            }
                                                                            let _e1527 = phi_1891_;
                                                                            phi_1893_ = _e1527;
                                                                            phi_1894_ = select(true, false, _e1521);
                                                                        } else {
                                                                            phi_1893_ = type_24();
                                                                            phi_1894_ = true;
                                                                        }
                                                                        let _e1530 = phi_1893_;
                                                                        let _e1532 = phi_1894_;
                                                                        if _e1532 {
                                                                            phi_1898_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1898_ = _e1530;
                                                                        }
                                                                        let _e1534 = phi_1898_;
                                                                        phi_1899_ = _e1534;
                                                                    }
                                                                    let _e1536 = phi_1899_;
                                                                    phi_1900_ = _e1536;
                                                                    phi_1901_ = _e1262;
                                                                }
                                                                let _e1538 = phi_1900_;
                                                                let _e1540 = phi_1901_;
                                                                phi_1905_ = _e1538;
                                                                phi_1906_ = _e1540;
                                                            }
                                                            let _e1542 = phi_1905_;
                                                            let _e1544 = phi_1906_;
                                                            phi_1907_ = _e1542;
                                                            phi_1908_ = _e1197;
                                                            phi_1909_ = _e1544;
                                                        }
                                                        let _e1546 = phi_1907_;
                                                        let _e1548 = phi_1908_;
                                                        let _e1550 = phi_1909_;
                                                        phi_1910_ = _e1546;
                                                        phi_1911_ = _e1548;
                                                        phi_1912_ = _e1550;
                                                    }
                                                    let _e1552 = phi_1910_;
                                                    let _e1554 = phi_1911_;
                                                    let _e1556 = phi_1912_;
                                                    phi_1920_ = _e1552;
                                                    phi_1921_ = select(_e1556, true, _e1554);
                                                } else {
                                                    phi_1920_ = type_24();
                                                    phi_1921_ = true;
                                                }
                                                let _e1559 = phi_1920_;
                                                let _e1561 = phi_1921_;
                                                if _e1561 {
                                                    phi_1925_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1925_ = _e1559;
                                                }
                                                let _e1563 = phi_1925_;
                                                if (_e1563.member_3 != 4294967295u) {
                                                    if (_e1033 != 4294967295u) {
                                                        phi_1936_ = type_38(_e1004.member, true);
                                                    } else {
                                                        phi_1936_ = _e1004;
                                                    }
                                                    let _e1571 = phi_1936_;
                                                    phi_1937_ = _e1571;
                                                } else {
                                                    phi_1937_ = _e1004;
                                                }
                                                let _e1573 = phi_1937_;
                                                phi_950_ = _e1573;
                                            } else {
                                                phi_950_ = type_38();
                                            }
                                            let _e1575 = phi_950_;
                                            continue;
                                            continuing {
                                                phi_949_ = _e1575;
                                                phi_952_ = _e1019;
                                                phi_3376_ = _e497;
                                                break if !(_e1025);
                                            }
                                        }
                                        let _e1578 = phi_3376_;
                                        phi_3515_ = _e1578;
                                        if _e1578 {
                                            break;
                                        }
                                        let _e1580 = local_10;
                                        phi_3519_ = _e1578;
                                        let _e1746 = local_12;
                                        phi_3143_ = _e1746;
                                        phi_3144_ = _e538;
                                        phi_3145_ = false;
                                        phi_3146_ = select(_e542, 0u, _e1580.member_1);
                                    } else {
                                        if (_e538.member_1 >= _e85) {
                                            phi_2699_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e538.member_1 < _e85) {
                                            } else {
                                                phi_3515_ = true;
                                                break;
                                            }
                                            let _e553 = (_e255 * 2u);
                                            let _e555 = ((1u + _e553) % 7u);
                                            if (_e555 < 7u) {
                                            } else {
                                                phi_3515_ = true;
                                                break;
                                            }
                                            let _e560 = global_6.member[_e538.member_1][_e555];
                                            let _e562 = ((_e553 + 2u) % 7u);
                                            if (_e562 < 7u) {
                                            } else {
                                                phi_3515_ = true;
                                                break;
                                            }
                                            let _e567 = global_6.member[_e538.member_1][_e562];
                                            let _e568 = (_e254 * 2u);
                                            let _e570 = ((1u + _e568) % 7u);
                                            if (_e570 < 7u) {
                                            } else {
                                                phi_3515_ = true;
                                                break;
                                            }
                                            let _e575 = global_6.member[_e538.member_1][_e570];
                                            let _e577 = ((_e568 + 2u) % 7u);
                                            if (_e577 < 7u) {
                                            } else {
                                                phi_3515_ = true;
                                                break;
                                            }
                                            let _e582 = global_6.member[_e538.member_1][_e577];
                                            let _e583 = (_e256 * 2u);
                                            let _e585 = ((1u + _e583) % 7u);
                                            if (_e585 < 7u) {
                                            } else {
                                                phi_3515_ = true;
                                                break;
                                            }
                                            let _e590 = global_6.member[_e538.member_1][_e585];
                                            let _e592 = ((_e583 + 2u) % 7u);
                                            if (_e592 < 7u) {
                                            } else {
                                                phi_3515_ = true;
                                                break;
                                            }
                                            let _e597 = global_6.member[_e538.member_1][_e592];
                                            let _e620 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.x - _e538.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e621 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.y - _e538.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e622 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.z - _e538.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e624 = select(_e135, _e620, (_e620 > _e135));
                                            let _e626 = select(_e135, _e621, (_e621 > _e135));
                                            let _e628 = select(_e135, _e622, (_e622 > _e135));
                                            let _e653 = bitcast<u32>((f32(bitcast<i32>((_e560 & 2097151u))) * _e624));
                                            let _e658 = (bitcast<i32>((_e560 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e661 = bitcast<f32>((_e653 & bitcast<u32>(_e658)));
                                            let _e662 = bitcast<u32>((f32(bitcast<i32>((_e575 & 2097151u))) * _e626));
                                            let _e667 = (bitcast<i32>((_e575 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e670 = bitcast<f32>((_e662 & bitcast<u32>(_e667)));
                                            let _e671 = bitcast<u32>((f32(bitcast<i32>((_e590 & 2097151u))) * _e628));
                                            let _e676 = (bitcast<i32>((_e590 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e679 = bitcast<f32>((_e671 & bitcast<u32>(_e676)));
                                            let _e683 = bitcast<f32>((_e653 & bitcast<u32>(~(_e658))));
                                            let _e687 = bitcast<f32>((_e662 & bitcast<u32>(~(_e667))));
                                            let _e691 = bitcast<f32>((_e671 & bitcast<u32>(~(_e676))));
                                            let _e692 = bitcast<u32>((f32(bitcast<i32>((_e567 & 2097151u))) * _e624));
                                            let _e697 = (bitcast<i32>((_e567 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e700 = bitcast<f32>((_e692 & bitcast<u32>(_e697)));
                                            let _e701 = bitcast<u32>((f32(bitcast<i32>((_e582 & 2097151u))) * _e626));
                                            let _e706 = (bitcast<i32>((_e582 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e709 = bitcast<f32>((_e701 & bitcast<u32>(_e706)));
                                            let _e710 = bitcast<u32>((f32(bitcast<i32>((_e597 & 2097151u))) * _e628));
                                            let _e715 = (bitcast<i32>((_e597 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e718 = bitcast<f32>((_e710 & bitcast<u32>(_e715)));
                                            let _e722 = bitcast<f32>((_e692 & bitcast<u32>(~(_e697))));
                                            let _e726 = bitcast<f32>((_e701 & bitcast<u32>(~(_e706))));
                                            let _e730 = bitcast<f32>((_e710 & bitcast<u32>(~(_e715))));
                                            let _e760 = global_6.member[_e538.member_1][0u];
                                            let _e764 = global_6.member[_e538.member_1][2u];
                                            let _e768 = global_6.member[_e538.member_1][4u];
                                            let _e772 = global_6.member[_e538.member_1][6u];
                                            let _e784 = (((_e764 >> bitcast<u32>(22i)) | ((_e768 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e772 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e785 = (_e760 & 268435455u);
                                            let _e786 = (_e784 & 268435455u);
                                            let _e789 = ((_e760 >> bitcast<u32>(28u)) & 7u);
                                            let _e797 = ((_e760 >> bitcast<u32>(31i)) | (((_e784 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e798 = (_e789 != 0u);
                                            if (_e789 == 0u) {
                                                phi_2661_ = _e785;
                                            } else {
                                                if (_e789 == 7u) {
                                                    phi_2660_ = 2147483648u;
                                                } else {
                                                    phi_2660_ = ((2147483648u | (_e789 << bitcast<u32>(28u))) | (_e786 & 268435455u));
                                                }
                                                let _e807 = phi_2660_;
                                                phi_2661_ = _e807;
                                            }
                                            let _e809 = phi_2661_;
                                            if _e798 {
                                                let _e810 = (_e789 != 7u);
                                                if _e810 {
                                                    phi_2671_ = (_e786 + _e789);
                                                } else {
                                                    phi_2671_ = u32();
                                                }
                                                let _e813 = phi_2671_;
                                                phi_2673_ = _e813;
                                                phi_2674_ = select(true, false, _e810);
                                            } else {
                                                phi_2673_ = u32();
                                                phi_2674_ = true;
                                            }
                                            let _e816 = phi_2673_;
                                            let _e818 = phi_2674_;
                                            if (_e797 == 0u) {
                                                phi_2695_ = (_e785 + select(0u, 1u, !(_e798)));
                                            } else {
                                                if (_e797 == 7u) {
                                                    phi_2694_ = 2147483648u;
                                                } else {
                                                    phi_2694_ = ((2147483648u | (_e797 << bitcast<u32>(28u))) | (select(_e816, _e786, _e818) & 268435455u));
                                                }
                                                let _e831 = phi_2694_;
                                                phi_2695_ = _e831;
                                            }
                                            let _e833 = phi_2695_;
                                            phi_2699_ = type_50(array<vec4<f32>, 3>(vec4<f32>((_e538.member.member.x + _e661), (_e538.member.member.x + _e683), (_e538.member.member_1.x - _e700), (_e538.member.member_1.x - _e722)), vec4<f32>((_e538.member.member.y + _e670), (_e538.member.member.y + _e687), (_e538.member.member_1.y - _e709), (_e538.member.member_1.y - _e726)), vec4<f32>((_e538.member.member.z + _e679), (_e538.member.member.z + _e691), (_e538.member.member_1.z - _e718), (_e538.member.member_1.z - _e730))), type_49(type_28((_e538.member.member + vec4<f32>(_e661, _e670, _e679, 0f)), (_e538.member.member_1 - vec4<f32>(_e700, _e709, _e718, 0f))), _e809), type_49(type_28((_e538.member.member + vec4<f32>(_e683, _e687, _e691, 0f)), (_e538.member.member_1 - vec4<f32>(_e722, _e726, _e730, 0f))), _e833));
                                        }
                                        let _e838 = phi_2699_;
                                        let _e850 = ((_e838.member[0].x - _e327) * _e332);
                                        let _e851 = ((_e838.member[0].y - _e327) * _e332);
                                        let _e852 = ((_e838.member[0].z - _e328) * _e332);
                                        let _e853 = ((_e838.member[0].w - _e328) * _e332);
                                        let _e863 = ((_e838.member[1].x - _e365) * _e370);
                                        let _e864 = ((_e838.member[1].y - _e365) * _e370);
                                        let _e865 = ((_e838.member[1].z - _e366) * _e370);
                                        let _e866 = ((_e838.member[1].w - _e366) * _e370);
                                        let _e876 = ((_e838.member[2].x - _e403) * _e408);
                                        let _e877 = ((_e838.member[2].y - _e403) * _e408);
                                        let _e878 = ((_e838.member[2].z - _e404) * _e408);
                                        let _e879 = ((_e838.member[2].w - _e404) * _e408);
                                        let _e881 = select(_e878, _e876, (_e876 < _e878));
                                        let _e883 = select(_e879, _e877, (_e877 < _e879));
                                        let _e885 = select(_e878, _e876, (_e876 > _e878));
                                        let _e887 = select(_e879, _e877, (_e877 > _e879));
                                        let _e889 = select(_e852, _e850, (_e850 < _e852));
                                        let _e891 = select(_e853, _e851, (_e851 < _e853));
                                        let _e893 = select(_e865, _e863, (_e863 < _e865));
                                        let _e895 = select(_e866, _e864, (_e864 < _e866));
                                        let _e897 = select(_e893, _e889, (_e889 > _e893));
                                        let _e899 = select(_e895, _e891, (_e891 > _e895));
                                        let _e901 = select(_e881, _e897, (_e897 > _e881));
                                        let _e903 = select(_e883, _e899, (_e899 > _e883));
                                        let _e905 = select(_e852, _e850, (_e850 > _e852));
                                        let _e907 = select(_e853, _e851, (_e851 > _e853));
                                        let _e909 = select(_e865, _e863, (_e863 > _e865));
                                        let _e911 = select(_e866, _e864, (_e864 > _e866));
                                        let _e913 = select(_e909, _e905, (_e905 < _e909));
                                        let _e915 = select(_e911, _e907, (_e907 < _e911));
                                        let _e920 = -(_e881);
                                        let _e921 = -(_e883);
                                        let _e928 = (select(_e885, _e913, (_e913 < _e885)) + (select(_e920, _e885, (_e885 > _e920)) * 0.0000019073523f));
                                        let _e929 = (select(_e887, _e915, (_e915 < _e887)) + (select(_e921, _e887, (_e887 > _e921)) * 0.0000019073523f));
                                        let _e931 = select(_e455, _e901, (_e901 > _e455));
                                        let _e933 = select(_e455, _e903, (_e903 > _e455));
                                        let _e938 = (_e931 <= select(_e499.member, _e928, (_e928 < _e499.member)));
                                        let _e939 = (_e933 <= select(_e499.member, _e929, (_e929 < _e499.member)));
                                        let _e940 = (_e931 <= _e933);
                                        if _e938 {
                                            if _e939 {
                                                if _e940 {
                                                    phi_3043_ = _e838.member_2;
                                                } else {
                                                    phi_3043_ = _e838.member_1;
                                                }
                                                let _e944 = phi_3043_;
                                                let _e966 = (_e542 % 128u);
                                                let _e967 = (_e966 < 128u);
                                                if _e967 {
                                                } else {
                                                    phi_3515_ = true;
                                                    break;
                                                }
                                                local_8[_e966] = _e944.member_1;
                                                if _e967 {
                                                } else {
                                                    phi_3515_ = true;
                                                    break;
                                                }
                                                local_7[_e966] = _e944.member.member.x;
                                                if _e967 {
                                                } else {
                                                    phi_3515_ = true;
                                                    break;
                                                }
                                                local_6[_e966] = _e944.member.member.y;
                                                if _e967 {
                                                } else {
                                                    phi_3515_ = true;
                                                    break;
                                                }
                                                local_5[_e966] = _e944.member.member.z;
                                                if _e967 {
                                                } else {
                                                    phi_3515_ = true;
                                                    break;
                                                }
                                                local_4[_e966] = _e944.member.member_1.x;
                                                if _e967 {
                                                } else {
                                                    phi_3515_ = true;
                                                    break;
                                                }
                                                local_3[_e966] = _e944.member.member_1.y;
                                                if _e967 {
                                                } else {
                                                    phi_3515_ = true;
                                                    break;
                                                }
                                                local_2[_e966] = _e944.member.member_1.z;
                                                if _e967 {
                                                } else {
                                                    phi_3515_ = true;
                                                    break;
                                                }
                                                local_9[_e966] = select(_e933, _e931, (_e931 > _e933));
                                                if _e940 {
                                                    phi_3120_ = _e838.member_1;
                                                } else {
                                                    phi_3120_ = _e838.member_2;
                                                }
                                                let _e980 = phi_3120_;
                                                phi_3121_ = _e980;
                                                phi_3122_ = (_e542 + 1u);
                                            } else {
                                                phi_3121_ = type_49();
                                                phi_3122_ = u32();
                                            }
                                            let _e982 = phi_3121_;
                                            let _e984 = phi_3122_;
                                            phi_3124_ = _e982;
                                            phi_3125_ = _e984;
                                            phi_3126_ = select(true, false, _e939);
                                        } else {
                                            phi_3124_ = type_49();
                                            phi_3125_ = u32();
                                            phi_3126_ = true;
                                        }
                                        let _e987 = phi_3124_;
                                        let _e989 = phi_3125_;
                                        let _e991 = phi_3126_;
                                        if _e991 {
                                            if _e938 {
                                                phi_3135_ = _e838.member_1;
                                            } else {
                                                phi_3135_ = _e838.member_2;
                                            }
                                            let _e995 = phi_3135_;
                                            phi_3140_ = _e995;
                                            phi_3141_ = select(_e939, true, _e938);
                                        } else {
                                            phi_3140_ = _e987;
                                            phi_3141_ = _e540;
                                        }
                                        let _e998 = phi_3140_;
                                        let _e1000 = phi_3141_;
                                        phi_3519_ = _e497;
                                        phi_3143_ = _e499;
                                        phi_3144_ = _e998;
                                        phi_3145_ = _e1000;
                                        phi_3146_ = select(_e989, _e542, _e991);
                                    }
                                    let _e1584 = phi_3519_;
                                    let _e1586 = phi_3143_;
                                    let _e1588 = phi_3144_;
                                    let _e1590 = phi_3145_;
                                    let _e1592 = phi_3146_;
                                    phi_3518_ = _e1584;
                                    phi_3147_ = _e1586;
                                    phi_3148_ = _e1588;
                                    phi_3149_ = (_e503 - 1u);
                                    phi_3150_ = _e1590;
                                    phi_3151_ = _e1592;
                                } else {
                                    phi_3518_ = _e497;
                                    phi_3147_ = _e499;
                                    phi_3148_ = _e538;
                                    phi_3149_ = _e503;
                                    phi_3150_ = _e540;
                                    phi_3151_ = _e542;
                                }
                                let _e1594 = phi_3518_;
                                let _e1596 = phi_3147_;
                                let _e1598 = phi_3148_;
                                let _e1600 = phi_3149_;
                                let _e1602 = phi_3150_;
                                let _e1604 = phi_3151_;
                                phi_3517_ = _e1594;
                                phi_3152_ = _e1596;
                                phi_3153_ = _e1598;
                                phi_3154_ = _e1600;
                                phi_3155_ = _e1602;
                                phi_3156_ = _e1604;
                            } else {
                                phi_3517_ = _e497;
                                phi_3152_ = type_38();
                                phi_3153_ = type_49();
                                phi_3154_ = u32();
                                phi_3155_ = bool();
                                phi_3156_ = u32();
                            }
                            let _e1606 = phi_3517_;
                            let _e1608 = phi_3152_;
                            let _e1610 = phi_3153_;
                            let _e1612 = phi_3154_;
                            let _e1614 = phi_3155_;
                            let _e1616 = phi_3156_;
                            phi_3516_ = _e1606;
                            phi_824_ = _e1608;
                            phi_827_ = _e1610;
                            phi_829_ = _e1612;
                            phi_831_ = _e1614;
                            phi_833_ = _e1616;
                            phi_3157_ = _e511;
                        } else {
                            phi_3516_ = _e497;
                            phi_824_ = type_38();
                            phi_827_ = type_49();
                            phi_829_ = u32();
                            phi_831_ = bool();
                            phi_833_ = u32();
                            phi_3157_ = false;
                        }
                        let _e1618 = phi_3516_;
                        let _e1620 = phi_824_;
                        let _e1622 = phi_827_;
                        let _e1624 = phi_829_;
                        let _e1626 = phi_831_;
                        let _e1628 = phi_833_;
                        let _e1630 = phi_3157_;
                        continue;
                        continuing {
                            phi_3382_ = _e1618;
                            phi_823_ = _e1620;
                            phi_826_ = _e1622;
                            phi_828_ = _e1624;
                            phi_830_ = _e1626;
                            phi_832_ = _e1628;
                            phi_3515_ = _e1618;
                            break if !(_e1630);
                        }
                    }
                    let _e1633 = phi_3515_;
                    if _e1633 {
                        break;
                    }
                    let _e1635 = local_11;
                    if _e143 {
                    } else {
                        break;
                    }
                    global_5.member[_e141] = select(0u, 1u, _e1635.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
