struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_21 {
    member: array<array<u32, 2>>,
}

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: type_25,
    member_1: f32,
}

struct type_36 {
    member: array<type_26>,
}

struct type_38 {
    member: type_32,
    member_1: u32,
    member_2: u32,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_42 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_44 {
    member: array<type_42>,
}

struct type_47 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_49 {
    member: type_47,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_40;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(2) 
var<storage> global_5: type_44;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_21;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_324_: i32;
    var phi_325_: i32;
    var phi_335_: bool;
    var phi_345_: u32;
    var phi_346_: u32;
    var phi_348_: bool;
    var phi_353_: u32;
    var phi_365_: i32;
    var phi_385_: i32;
    var phi_403_: f32;
    var phi_409_: f32;
    var phi_420_: f32;
    var phi_426_: f32;
    var phi_449_: f32;
    var phi_460_: f32;
    var phi_469_: f32;
    var phi_475_: f32;
    var phi_486_: f32;
    var phi_492_: f32;
    var phi_515_: f32;
    var phi_526_: f32;
    var phi_535_: f32;
    var phi_541_: f32;
    var phi_552_: f32;
    var phi_558_: f32;
    var phi_581_: f32;
    var phi_592_: f32;
    var phi_692_: f32;
    var phi_693_: f32;
    var phi_2669_: bool;
    var phi_767_: type_38;
    var phi_770_: type_49;
    var phi_772_: u32;
    var phi_774_: bool;
    var phi_776_: u32;
    var phi_787_: bool;
    var phi_873_: type_49;
    var phi_874_: bool;
    var phi_875_: u32;
    var phi_1665_: type_42;
    var phi_2497_: type_49;
    var phi_2574_: type_49;
    var phi_2575_: type_49;
    var phi_2576_: u32;
    var phi_2578_: type_49;
    var phi_2579_: u32;
    var phi_2580_: bool;
    var phi_2587_: type_49;
    var phi_2592_: type_49;
    var phi_2593_: bool;
    var phi_893_: type_38;
    var phi_896_: type_4;
    var phi_897_: type_4;
    var phi_919_: type_4;
    var phi_943_: u32;
    var phi_1032_: array<array<f32, 3>, 3>;
    var phi_1503_: vec3<f32>;
    var phi_1504_: vec3<f32>;
    var phi_1535_: bool;
    var phi_1544_: vec3<f32>;
    var phi_1584_: type_25;
    var phi_1586_: type_25;
    var phi_1587_: bool;
    var phi_1591_: type_25;
    var phi_1592_: type_25;
    var phi_1593_: type_25;
    var phi_1594_: bool;
    var phi_1598_: type_25;
    var phi_1599_: bool;
    var phi_1603_: type_25;
    var phi_1604_: bool;
    var phi_1608_: type_25;
    var phi_1633_: bool;
    var phi_1634_: bool;
    var phi_1641_: type_38;
    var phi_1642_: type_38;
    var phi_1643_: type_38;
    var phi_894_: type_38;
    var phi_2663_: bool;
    var phi_2781_: bool;
    var phi_2595_: type_38;
    var phi_2596_: type_49;
    var phi_2597_: bool;
    var phi_2598_: u32;
    var phi_2780_: bool;
    var phi_2599_: type_38;
    var phi_2600_: type_49;
    var phi_2601_: u32;
    var phi_2602_: bool;
    var phi_2603_: u32;
    var phi_2779_: bool;
    var phi_2604_: type_38;
    var phi_2605_: type_49;
    var phi_2606_: u32;
    var phi_2607_: bool;
    var phi_2608_: u32;
    var phi_2778_: bool;
    var phi_768_: type_38;
    var phi_771_: type_49;
    var phi_773_: u32;
    var phi_775_: bool;
    var phi_777_: u32;
    var phi_2609_: bool;
    var phi_2777_: bool;
    var local_10: type_38;
    var local_11: type_38;
    var local_12: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e74 = global;
            let _e77 = arrayLength((&global_5.member));
            let _e79 = arrayLength((&global_2.member));
            let _e87 = global_3.member[0u][0u];
            let _e91 = global_3.member[0u][1u];
            let _e95 = global_3.member[0u][2u];
            let _e99 = global_3.member[1u][0u];
            let _e103 = global_3.member[1u][1u];
            let _e107 = global_3.member[1u][2u];
            let _e111 = global_3.member[1u][3u];
            let _e114 = global_1.member[0u];
            let _e115 = bitcast<i32>(_e114);
            let _e125 = (_e74.x + (_e74.y * 2097152u));
            let _e126 = (_e125 < arrayLength((&global_4.member)));
            if _e126 {
                let _e127 = (_e125 < arrayLength((&global_6.member)));
                if _e127 {
                    if _e126 {
                    } else {
                        break;
                    }
                    let _e135 = global_4.member[_e125].member_2[0u];
                    let _e137 = (bitcast<u32>(_e135) & 2147483647u);
                    let _e142 = global_4.member[_e125].member_2[1u];
                    let _e144 = (bitcast<u32>(_e142) & 2147483647u);
                    let _e149 = global_4.member[_e125].member_2[2u];
                    let _e151 = (bitcast<u32>(_e149) & 2147483647u);
                    let _e156 = global_4.member[_e125].member[0u];
                    let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                    let _e163 = global_4.member[_e125].member[1u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_4.member[_e125].member[2u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e174 = select(_e144, _e137, (_e144 < _e137));
                    let _e176 = select(_e151, _e174, (_e151 < _e174));
                    let _e178 = select(_e158, _e176, (_e158 < _e176));
                    let _e180 = select(_e165, _e178, (_e165 < _e178));
                    let _e182 = select(_e172, _e180, (_e172 < _e180));
                    let _e186 = global_4.member[_e125].member_1;
                    let _e188 = (bitcast<u32>(_e186) & 2147483647u);
                    let _e195 = global_4.member[_e125].member_3;
                    let _e201 = (((select(_e188, _e182, (_e188 < _e182)) < 2139095040u) && ((bitcast<u32>(_e195) & 2147483647u) <= 2139095040u)) && (_e176 > 0u));
                    if _e201 {
                        let _e204 = (bitcast<u32>(bitcast<f32>(_e176)) & 2147483647u);
                        if (_e204 >= 8388608u) {
                            phi_324_ = (bitcast<i32>((_e204 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_324_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e204)), 32u, (_e204 == 0u))));
                        }
                        let _e218 = phi_324_;
                        phi_325_ = _e218;
                    } else {
                        phi_325_ = 0i;
                    }
                    let _e220 = phi_325_;
                    let _e221 = (_e137 == _e176);
                    if _e221 {
                        phi_335_ = true;
                    } else {
                        phi_335_ = (_e144 == _e176);
                    }
                    let _e224 = phi_335_;
                    let _e225 = select(1u, 0u, _e221);
                    if _e224 {
                        let _e226 = (_e225 + 1u);
                        phi_345_ = _e226;
                        phi_346_ = _e226;
                        phi_348_ = select(true, false, (_e226 == 2u));
                    } else {
                        phi_345_ = u32();
                        phi_346_ = 0u;
                        phi_348_ = true;
                    }
                    let _e230 = phi_345_;
                    let _e232 = phi_346_;
                    let _e234 = phi_348_;
                    if _e234 {
                        phi_353_ = (_e232 + 1u);
                    } else {
                        phi_353_ = 0u;
                    }
                    let _e238 = phi_353_;
                    let _e239 = select(_e230, _e232, _e234);
                    let _e240 = select(_e225, select(2u, _e225, _e224), _e234);
                    if (_e115 < -126i) {
                        phi_365_ = -126i;
                    } else {
                        phi_365_ = select(_e115, 127i, (_e115 > 127i));
                    }
                    let _e245 = phi_365_;
                    let _e250 = bitcast<f32>((bitcast<u32>((_e245 + 127i)) << bitcast<u32>(23i)));
                    let _e256 = bitcast<f32>((bitcast<u32>(((_e115 - _e245) + 127i)) << bitcast<u32>(23i)));
                    let _e257 = -(_e220);
                    if (_e257 < -126i) {
                        phi_385_ = -126i;
                    } else {
                        phi_385_ = select(_e257, 127i, (_e257 > 127i));
                    }
                    let _e262 = phi_385_;
                    let _e267 = bitcast<f32>((bitcast<u32>((_e262 + 127i)) << bitcast<u32>(23i)));
                    let _e273 = bitcast<f32>((bitcast<u32>(((_e257 - _e262) + 127i)) << bitcast<u32>(23i)));
                    let _e277 = global_4.member[_e125].member;
                    let _e278 = (_e239 == 0u);
                    if _e278 {
                        phi_403_ = _e277[0];
                    } else {
                        phi_403_ = _e277[1];
                    }
                    let _e282 = phi_403_;
                    let _e283 = (_e239 == 2u);
                    if _e283 {
                        phi_409_ = _e277[2];
                    } else {
                        phi_409_ = _e282;
                    }
                    let _e286 = phi_409_;
                    let _e288 = ((_e286 * _e250) * _e256);
                    let _e289 = global_4.member[_e125].member_2;
                    if _e278 {
                        phi_420_ = _e289[0];
                    } else {
                        phi_420_ = _e289[1];
                    }
                    let _e293 = phi_420_;
                    if _e283 {
                        phi_426_ = _e289[2];
                    } else {
                        phi_426_ = _e293;
                    }
                    let _e296 = phi_426_;
                    let _e298 = ((_e296 * _e267) * _e273);
                    let _e302 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e302 {
                        let _e306 = (bitcast<f32>((bitcast<u32>(_e288) & 2147483647u)) * 0.00000011920929f);
                        phi_449_ = select(0.00000000000011368684f, _e306, (_e306 > 0.00000000000011368684f));
                    } else {
                        phi_449_ = 0f;
                    }
                    let _e310 = phi_449_;
                    let _e311 = (_e288 + _e310);
                    let _e312 = (_e288 - _e310);
                    let _e313 = select(_e298, 0f, _e302);
                    if _e302 {
                        phi_460_ = 38685626000000000000000000f;
                    } else {
                        phi_460_ = (1f / _e298);
                    }
                    let _e316 = phi_460_;
                    let _e317 = (_e238 == 0u);
                    if _e317 {
                        phi_469_ = _e277[0];
                    } else {
                        phi_469_ = _e277[1];
                    }
                    let _e321 = phi_469_;
                    let _e322 = (_e238 == 2u);
                    if _e322 {
                        phi_475_ = _e277[2];
                    } else {
                        phi_475_ = _e321;
                    }
                    let _e325 = phi_475_;
                    let _e327 = ((_e325 * _e250) * _e256);
                    if _e317 {
                        phi_486_ = _e289[0];
                    } else {
                        phi_486_ = _e289[1];
                    }
                    let _e331 = phi_486_;
                    if _e322 {
                        phi_492_ = _e289[2];
                    } else {
                        phi_492_ = _e331;
                    }
                    let _e334 = phi_492_;
                    let _e336 = ((_e334 * _e267) * _e273);
                    let _e340 = (bitcast<f32>((bitcast<u32>(_e336) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e340 {
                        let _e344 = (bitcast<f32>((bitcast<u32>(_e327) & 2147483647u)) * 0.00000011920929f);
                        phi_515_ = select(0.00000000000011368684f, _e344, (_e344 > 0.00000000000011368684f));
                    } else {
                        phi_515_ = 0f;
                    }
                    let _e348 = phi_515_;
                    let _e349 = (_e327 + _e348);
                    let _e350 = (_e327 - _e348);
                    let _e351 = select(_e336, 0f, _e340);
                    if _e340 {
                        phi_526_ = 38685626000000000000000000f;
                    } else {
                        phi_526_ = (1f / _e336);
                    }
                    let _e354 = phi_526_;
                    let _e355 = (_e240 == 0u);
                    if _e355 {
                        phi_535_ = _e277[0];
                    } else {
                        phi_535_ = _e277[1];
                    }
                    let _e359 = phi_535_;
                    let _e360 = (_e240 == 2u);
                    if _e360 {
                        phi_541_ = _e277[2];
                    } else {
                        phi_541_ = _e359;
                    }
                    let _e363 = phi_541_;
                    let _e365 = ((_e363 * _e250) * _e256);
                    if _e355 {
                        phi_552_ = _e289[0];
                    } else {
                        phi_552_ = _e289[1];
                    }
                    let _e369 = phi_552_;
                    if _e360 {
                        phi_558_ = _e289[2];
                    } else {
                        phi_558_ = _e369;
                    }
                    let _e372 = phi_558_;
                    let _e374 = ((_e372 * _e267) * _e273);
                    let _e378 = (bitcast<f32>((bitcast<u32>(_e374) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e378 {
                        let _e382 = (bitcast<f32>((bitcast<u32>(_e365) & 2147483647u)) * 0.00000011920929f);
                        phi_581_ = select(0.00000000000011368684f, _e382, (_e382 > 0.00000000000011368684f));
                    } else {
                        phi_581_ = 0f;
                    }
                    let _e386 = phi_581_;
                    let _e387 = (_e365 + _e386);
                    let _e388 = (_e365 - _e386);
                    let _e389 = select(_e374, 0f, _e378);
                    if _e378 {
                        phi_592_ = 38685626000000000000000000f;
                    } else {
                        phi_592_ = (1f / _e374);
                    }
                    let _e392 = phi_592_;
                    let _e395 = bitcast<f32>((bitcast<u32>(_e288) & 2147483647u));
                    let _e398 = bitcast<f32>((bitcast<u32>(_e327) & 2147483647u));
                    let _e400 = select(_e398, _e395, (_e395 > _e398));
                    let _e403 = bitcast<f32>((bitcast<u32>(_e365) & 2147483647u));
                    let _e406 = (_e115 + _e220);
                    if (_e201 && (select(_e403, _e400, (_e400 > _e403)) <= 1099511600000f)) {
                        let _e409 = (_e406 / 3i);
                        let _e416 = bitcast<f32>((bitcast<u32>((_e409 + 127i)) << bitcast<u32>(23i)));
                        let _e423 = bitcast<f32>((bitcast<u32>(((_e406 - (2i * _e409)) + 127i)) << bitcast<u32>(23i)));
                        let _e424 = (((_e186 * _e416) * _e416) * _e423);
                        let _e426 = select(340282350000000000000000000000000000000f, _e424, (_e424 < 340282350000000000000000000000000000000f));
                        let _e431 = (((_e195 * _e416) * _e416) * _e423);
                        let _e433 = select(340282350000000000000000000000000000000f, _e431, (_e431 < 340282350000000000000000000000000000000f));
                        phi_692_ = select(-340282350000000000000000000000000000000f, _e433, (_e433 > -340282350000000000000000000000000000000f));
                        phi_693_ = select(-340282350000000000000000000000000000000f, _e426, (_e426 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_692_ = 0f;
                        phi_693_ = 1f;
                    }
                    let _e437 = phi_692_;
                    let _e439 = phi_693_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e87), bitcast<f32>(_e91), bitcast<f32>(_e95));
                    let _e445 = (_e239 % 3u);
                    let _e446 = (_e445 < 3u);
                    if _e446 {
                    } else {
                        break;
                    }
                    let _e448 = local_9[_e445];
                    let _e449 = (_e238 % 3u);
                    let _e450 = (_e449 < 3u);
                    if _e450 {
                    } else {
                        break;
                    }
                    let _e452 = local_9[_e449];
                    let _e453 = (_e240 % 3u);
                    let _e454 = (_e453 < 3u);
                    if _e454 {
                    } else {
                        break;
                    }
                    let _e456 = local_9[_e453];
                    local_8 = array<f32, 3>(bitcast<f32>(_e99), bitcast<f32>(_e103), bitcast<f32>(_e107));
                    if _e446 {
                    } else {
                        break;
                    }
                    let _e460 = local_8[_e445];
                    if _e450 {
                    } else {
                        break;
                    }
                    let _e462 = local_8[_e449];
                    if _e454 {
                    } else {
                        break;
                    }
                    let _e464 = local_8[_e453];
                    phi_2669_ = false;
                    phi_767_ = type_38(type_32(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e437), 0u, 0u);
                    phi_770_ = type_49(type_47(array<f32, 3>(_e448, _e452, _e456), array<f32, 3>(_e460, _e462, _e464)), select(0u, 2147483648u, (_e77 == 0u)));
                    phi_772_ = ((3u * _e77) + 1u);
                    phi_774_ = (_e439 <= _e437);
                    phi_776_ = 0u;
                    loop {
                        let _e472 = phi_2669_;
                        let _e474 = phi_767_;
                        let _e476 = phi_770_;
                        let _e478 = phi_772_;
                        let _e480 = phi_774_;
                        let _e482 = phi_776_;
                        local_10 = _e474;
                        local_11 = _e474;
                        if _e480 {
                            phi_787_ = true;
                        } else {
                            phi_787_ = (_e482 > 0u);
                        }
                        let _e485 = phi_787_;
                        if _e485 {
                            let _e486 = (_e478 > 0u);
                            if _e486 {
                                if _e480 {
                                    phi_873_ = _e476;
                                    phi_874_ = _e480;
                                    phi_875_ = _e482;
                                } else {
                                    let _e487 = (_e482 - 1u);
                                    let _e488 = (_e487 % 128u);
                                    let _e489 = (_e488 < 128u);
                                    if _e489 {
                                    } else {
                                        phi_2777_ = true;
                                        break;
                                    }
                                    let _e491 = local_6[_e488];
                                    if _e489 {
                                    } else {
                                        phi_2777_ = true;
                                        break;
                                    }
                                    let _e493 = local_5[_e488];
                                    if _e489 {
                                    } else {
                                        phi_2777_ = true;
                                        break;
                                    }
                                    let _e495 = local_4[_e488];
                                    if _e489 {
                                    } else {
                                        phi_2777_ = true;
                                        break;
                                    }
                                    let _e497 = local_3[_e488];
                                    if _e489 {
                                    } else {
                                        phi_2777_ = true;
                                        break;
                                    }
                                    let _e500 = local_2[_e488];
                                    if _e489 {
                                    } else {
                                        phi_2777_ = true;
                                        break;
                                    }
                                    let _e502 = local_1[_e488];
                                    if _e489 {
                                    } else {
                                        phi_2777_ = true;
                                        break;
                                    }
                                    let _e504 = local[_e488];
                                    if _e489 {
                                    } else {
                                        phi_2777_ = true;
                                        break;
                                    }
                                    let _e509 = local_7[_e488];
                                    phi_873_ = type_49(type_47(array<f32, 3>(_e493, _e495, _e497), array<f32, 3>(_e500, _e502, _e504)), _e491);
                                    phi_874_ = (_e509 <= _e474.member.member_1);
                                    phi_875_ = _e487;
                                }
                                let _e514 = phi_873_;
                                let _e516 = phi_874_;
                                let _e518 = phi_875_;
                                if _e516 {
                                    if ((_e514.member_1 & 2147483648u) != 0u) {
                                        phi_893_ = _e474;
                                        phi_896_ = type_4(0u, ((_e514.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e877 = phi_893_;
                                            let _e879 = phi_896_;
                                            local_12 = _e877;
                                            if (_e879.member < _e879.member_1) {
                                                phi_897_ = type_4((_e879.member + 1u), _e879.member_1);
                                                phi_919_ = type_4(1u, _e879.member);
                                            } else {
                                                phi_897_ = _e879;
                                                phi_919_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e892 = phi_897_;
                                            let _e894 = phi_919_;
                                            let _e898 = (bitcast<i32>(_e894.member) != 0i);
                                            if _e898 {
                                                let _e904 = type_38(_e877.member, _e877.member_1, (_e877.member_2 + 1u));
                                                let _e905 = ((_e514.member_1 & 268435455u) + _e894.member_1);
                                                let _e906 = (_e905 < _e79);
                                                if _e906 {
                                                    if _e906 {
                                                    } else {
                                                        phi_2663_ = true;
                                                        break;
                                                    }
                                                    let _e910 = global_2.member[_e905].member_1;
                                                    phi_943_ = _e910;
                                                } else {
                                                    phi_943_ = 4294967295u;
                                                }
                                                let _e912 = phi_943_;
                                                if (_e905 >= _e79) {
                                                    phi_1032_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e906 {
                                                    } else {
                                                        phi_2663_ = true;
                                                        break;
                                                    }
                                                    if (_e445 < 9u) {
                                                    } else {
                                                        phi_2663_ = true;
                                                        break;
                                                    }
                                                    let _e919 = global_2.member[_e905].member[_e445];
                                                    if (_e449 < 9u) {
                                                    } else {
                                                        phi_2663_ = true;
                                                        break;
                                                    }
                                                    let _e925 = global_2.member[_e905].member[_e449];
                                                    if (_e453 < 9u) {
                                                    } else {
                                                        phi_2663_ = true;
                                                        break;
                                                    }
                                                    let _e931 = global_2.member[_e905].member[_e453];
                                                    let _e933 = (3u + _e445);
                                                    if (_e933 < 9u) {
                                                    } else {
                                                        phi_2663_ = true;
                                                        break;
                                                    }
                                                    let _e939 = global_2.member[_e905].member[_e933];
                                                    let _e940 = (3u + _e449);
                                                    if (_e940 < 9u) {
                                                    } else {
                                                        phi_2663_ = true;
                                                        break;
                                                    }
                                                    let _e946 = global_2.member[_e905].member[_e940];
                                                    let _e947 = (3u + _e453);
                                                    if (_e947 < 9u) {
                                                    } else {
                                                        phi_2663_ = true;
                                                        break;
                                                    }
                                                    let _e953 = global_2.member[_e905].member[_e947];
                                                    let _e955 = (6u + _e445);
                                                    if (_e955 < 9u) {
                                                    } else {
                                                        phi_2663_ = true;
                                                        break;
                                                    }
                                                    let _e961 = global_2.member[_e905].member[_e955];
                                                    let _e962 = (6u + _e449);
                                                    if (_e962 < 9u) {
                                                    } else {
                                                        phi_2663_ = true;
                                                        break;
                                                    }
                                                    let _e968 = global_2.member[_e905].member[_e962];
                                                    let _e969 = (6u + _e453);
                                                    if (_e969 < 9u) {
                                                    } else {
                                                        phi_2663_ = true;
                                                        break;
                                                    }
                                                    let _e975 = global_2.member[_e905].member[_e969];
                                                    phi_1032_ = array<array<f32, 3>, 3>(array<f32, 3>(_e919, _e925, _e931), array<f32, 3>(_e939, _e946, _e953), array<f32, 3>(_e961, _e968, _e975));
                                                }
                                                let _e979 = phi_1032_;
                                                let _e988 = (_e979[0][2] - _e365);
                                                let _e991 = (((_e979[0][0] - _e288) * _e389) - (_e988 * _e313));
                                                let _e994 = (((_e979[0][1] - _e327) * _e389) - (_e988 * _e351));
                                                let _e1001 = (_e979[1][2] - _e365);
                                                let _e1004 = (((_e979[1][0] - _e288) * _e389) - (_e1001 * _e313));
                                                let _e1007 = (((_e979[1][1] - _e327) * _e389) - (_e1001 * _e351));
                                                let _e1014 = (_e979[2][2] - _e365);
                                                let _e1017 = (((_e979[2][0] - _e288) * _e389) - (_e1014 * _e313));
                                                let _e1020 = (((_e979[2][1] - _e327) * _e389) - (_e1014 * _e351));
                                                let _e1021 = (_e1017 * _e1007);
                                                let _e1022 = (_e1020 * _e1004);
                                                let _e1023 = (_e991 * _e1020);
                                                let _e1024 = (_e994 * _e1017);
                                                let _e1025 = (_e1004 * _e994);
                                                let _e1026 = (_e1007 * _e991);
                                                let _e1031 = (((_e1021 >= _e1022) && (_e1023 >= _e1024)) && (_e1025 >= _e1026));
                                                if (_e1031 || (((_e1021 <= _e1022) && (_e1023 <= _e1024)) && (_e1025 <= _e1026))) {
                                                    let _e1038 = select(-1f, 1f, _e1031);
                                                    let _e1040 = ((_e1021 - _e1022) * _e1038);
                                                    let _e1042 = select(0f, _e1040, (_e1040 > 0f));
                                                    let _e1044 = ((_e1023 - _e1024) * _e1038);
                                                    let _e1046 = select(0f, _e1044, (_e1044 > 0f));
                                                    let _e1048 = ((_e1025 - _e1026) * _e1038);
                                                    let _e1050 = select(0f, _e1048, (_e1048 > 0f));
                                                    let _e1052 = ((_e1042 + _e1046) + _e1050);
                                                    if (_e1052 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1598_ = type_25();
                                                        phi_1599_ = true;
                                                    } else {
                                                        let _e1055 = select(_e979[1][0], _e979[0][0], (_e979[0][0] < _e979[1][0]));
                                                        let _e1059 = select(_e979[1][0], _e979[0][0], (_e979[0][0] > _e979[1][0]));
                                                        let _e1063 = select(_e979[1][1], _e979[0][1], (_e979[0][1] < _e979[1][1]));
                                                        let _e1067 = select(_e979[1][1], _e979[0][1], (_e979[0][1] > _e979[1][1]));
                                                        let _e1071 = select(_e979[1][2], _e979[0][2], (_e979[0][2] < _e979[1][2]));
                                                        let _e1075 = select(_e979[1][2], _e979[0][2], (_e979[0][2] > _e979[1][2]));
                                                        let _e1080 = ((select(_e979[2][0], _e1055, (_e1055 < _e979[2][0])) - _e311) * _e316);
                                                        let _e1081 = ((select(_e979[2][0], _e1059, (_e1059 > _e979[2][0])) - _e312) * _e316);
                                                        let _e1084 = ((select(_e979[2][1], _e1063, (_e1063 < _e979[2][1])) - _e349) * _e354);
                                                        let _e1085 = ((select(_e979[2][1], _e1067, (_e1067 > _e979[2][1])) - _e350) * _e354);
                                                        let _e1088 = ((select(_e979[2][2], _e1071, (_e1071 < _e979[2][2])) - _e387) * _e392);
                                                        let _e1089 = ((select(_e979[2][2], _e1075, (_e1075 > _e979[2][2])) - _e388) * _e392);
                                                        let _e1091 = select(_e1089, _e1088, (_e1088 < _e1089));
                                                        let _e1093 = select(_e1089, _e1088, (_e1088 > _e1089));
                                                        let _e1095 = select(_e1081, _e1080, (_e1080 < _e1081));
                                                        let _e1097 = select(_e1085, _e1084, (_e1084 < _e1085));
                                                        let _e1099 = select(_e1097, _e1095, (_e1095 > _e1097));
                                                        let _e1101 = select(_e1091, _e1099, (_e1099 > _e1091));
                                                        let _e1103 = select(_e1081, _e1080, (_e1080 > _e1081));
                                                        let _e1105 = select(_e1085, _e1084, (_e1084 > _e1085));
                                                        let _e1107 = select(_e1105, _e1103, (_e1103 < _e1105));
                                                        let _e1109 = select(_e1093, _e1107, (_e1107 < _e1093));
                                                        let _e1110 = -(_e1091);
                                                        let _e1116 = select(_e439, _e1101, (_e1101 > _e439));
                                                        if (_e1116 > (_e1109 + (select(_e1110, _e1093, (_e1093 > _e1110)) * 0.0000019073523f))) {
                                                            phi_1593_ = type_25();
                                                            phi_1594_ = true;
                                                        } else {
                                                            let _e1118 = (_e1116 > _e877.member.member_1);
                                                            if _e1118 {
                                                                phi_1592_ = type_25();
                                                            } else {
                                                                let _e1122 = (_e979[1][0] - _e979[0][0]);
                                                                let _e1123 = (_e979[1][1] - _e979[0][1]);
                                                                let _e1124 = (_e979[1][2] - _e979[0][2]);
                                                                let _e1125 = vec3<f32>(_e1122, _e1123, _e1124);
                                                                let _e1126 = (_e979[2][0] - _e979[1][0]);
                                                                let _e1127 = (_e979[2][1] - _e979[1][1]);
                                                                let _e1128 = (_e979[2][2] - _e979[1][2]);
                                                                let _e1129 = vec3<f32>(_e1126, _e1127, _e1128);
                                                                let _e1130 = (_e979[0][0] - _e979[2][0]);
                                                                let _e1131 = (_e979[0][1] - _e979[2][1]);
                                                                let _e1132 = (_e979[0][2] - _e979[2][2]);
                                                                let _e1133 = vec3<f32>(_e1130, _e1131, _e1132);
                                                                let _e1136 = bitcast<f32>((bitcast<u32>(_e1122) & 2147483647u));
                                                                let _e1139 = bitcast<f32>((bitcast<u32>(_e1123) & 2147483647u));
                                                                let _e1141 = select(_e1139, _e1136, (_e1136 > _e1139));
                                                                let _e1144 = bitcast<f32>((bitcast<u32>(_e1124) & 2147483647u));
                                                                let _e1146 = select(_e1144, _e1141, (_e1141 > _e1144));
                                                                let _e1149 = bitcast<f32>((bitcast<u32>(_e1126) & 2147483647u));
                                                                let _e1152 = bitcast<f32>((bitcast<u32>(_e1127) & 2147483647u));
                                                                let _e1154 = select(_e1152, _e1149, (_e1149 > _e1152));
                                                                let _e1157 = bitcast<f32>((bitcast<u32>(_e1128) & 2147483647u));
                                                                let _e1159 = select(_e1157, _e1154, (_e1154 > _e1157));
                                                                let _e1162 = bitcast<f32>((bitcast<u32>(_e1130) & 2147483647u));
                                                                let _e1165 = bitcast<f32>((bitcast<u32>(_e1131) & 2147483647u));
                                                                let _e1167 = select(_e1165, _e1162, (_e1162 > _e1165));
                                                                let _e1170 = bitcast<f32>((bitcast<u32>(_e1132) & 2147483647u));
                                                                let _e1172 = select(_e1170, _e1167, (_e1167 > _e1170));
                                                                let _e1174 = select(_e1159, _e1146, (_e1146 > _e1159));
                                                                let _e1176 = select(_e1172, _e1174, (_e1174 > _e1172));
                                                                if (_e1146 == _e1176) {
                                                                    phi_1503_ = _e1129;
                                                                    phi_1504_ = _e1133;
                                                                } else {
                                                                    let _e1179 = vec3((_e1159 == _e1176));
                                                                    phi_1503_ = select(_e1125, _e1133, _e1179);
                                                                    phi_1504_ = select(_e1129, _e1125, _e1179);
                                                                }
                                                                let _e1183 = phi_1503_;
                                                                let _e1185 = phi_1504_;
                                                                let _e1192 = ((_e1183.y * _e1185.z) - (_e1185.y * _e1183.z));
                                                                let _e1197 = ((_e1183.z * _e1185.x) - (_e1185.z * _e1183.x));
                                                                let _e1200 = ((_e1183.x * _e1185.y) - (_e1185.x * _e1183.y));
                                                                if (_e1042 >= _e1046) {
                                                                    phi_1535_ = select(true, false, (_e1042 >= _e1050));
                                                                } else {
                                                                    phi_1535_ = true;
                                                                }
                                                                let _e1205 = phi_1535_;
                                                                if _e1205 {
                                                                    phi_1544_ = select(vec3<f32>(_e979[2][0], _e979[2][1], _e979[2][2]), vec3<f32>(_e979[1][0], _e979[1][1], _e979[1][2]), vec3((_e1046 >= _e1050)));
                                                                } else {
                                                                    phi_1544_ = vec3<f32>(_e979[0][0], _e979[0][1], _e979[0][2]);
                                                                }
                                                                let _e1210 = phi_1544_;
                                                                let _e1227 = ((((_e1192 * (_e1210.x - _e288)) + (_e1197 * (_e1210.y - _e327))) + (_e1200 * (_e1210.z - _e365))) / (((_e1192 * _e313) + (_e1197 * _e351)) + (_e1200 * _e389)));
                                                                let _e1229 = select(_e1109, _e1227, (_e1227 < _e1109));
                                                                let _e1231 = select(_e1101, _e1229, (_e1229 > _e1101));
                                                                if (_e1231 >= _e439) {
                                                                    let _e1233 = (_e1231 <= _e877.member.member_1);
                                                                    if _e1233 {
                                                                        let _e1234 = (1f / _e1052);
                                                                        phi_1584_ = type_25(_e1231, (_e1046 * _e1234), (_e1050 * _e1234), _e912);
                                                                    } else {
                                                                        phi_1584_ = type_25();
                                                                    }
                                                                    let _e1239 = phi_1584_;
                                                                    phi_1586_ = _e1239;
                                                                    phi_1587_ = select(true, false, _e1233);
                                                                } else {
                                                                    phi_1586_ = type_25();
                                                                    phi_1587_ = true;
                                                                }
                                                                let _e1242 = phi_1586_;
                                                                let _e1244 = phi_1587_;
                                                                if _e1244 {
                                                                    phi_1591_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1591_ = _e1242;
                                                                }
                                                                let _e1246 = phi_1591_;
                                                                phi_1592_ = _e1246;
                                                            }
                                                            let _e1248 = phi_1592_;
                                                            phi_1593_ = _e1248;
                                                            phi_1594_ = _e1118;
                                                        }
                                                        let _e1250 = phi_1593_;
                                                        let _e1252 = phi_1594_;
                                                        phi_1598_ = _e1250;
                                                        phi_1599_ = _e1252;
                                                    }
                                                    let _e1254 = phi_1598_;
                                                    let _e1256 = phi_1599_;
                                                    phi_1603_ = _e1254;
                                                    phi_1604_ = _e1256;
                                                } else {
                                                    phi_1603_ = type_25();
                                                    phi_1604_ = true;
                                                }
                                                let _e1258 = phi_1603_;
                                                let _e1260 = phi_1604_;
                                                if _e1260 {
                                                    phi_1608_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1608_ = _e1258;
                                                }
                                                let _e1262 = phi_1608_;
                                                if (_e1262.member_3 != 4294967295u) {
                                                    if (_e912 != 4294967295u) {
                                                        if (_e1262.member < _e877.member.member.member) {
                                                            phi_1634_ = true;
                                                        } else {
                                                            if (_e1262.member == _e877.member.member.member) {
                                                                phi_1633_ = (_e1262.member_3 < _e877.member.member.member_3);
                                                            } else {
                                                                phi_1633_ = false;
                                                            }
                                                            let _e1277 = phi_1633_;
                                                            phi_1634_ = _e1277;
                                                        }
                                                        let _e1279 = phi_1634_;
                                                        if _e1279 {
                                                            phi_1641_ = type_38(type_32(_e1262, _e1262.member), _e904.member_1, _e904.member_2);
                                                        } else {
                                                            phi_1641_ = _e904;
                                                        }
                                                        let _e1286 = phi_1641_;
                                                        phi_1642_ = _e1286;
                                                    } else {
                                                        phi_1642_ = _e904;
                                                    }
                                                    let _e1288 = phi_1642_;
                                                    phi_1643_ = _e1288;
                                                } else {
                                                    phi_1643_ = _e904;
                                                }
                                                let _e1290 = phi_1643_;
                                                phi_894_ = _e1290;
                                            } else {
                                                phi_894_ = type_38();
                                            }
                                            let _e1292 = phi_894_;
                                            continue;
                                            continuing {
                                                phi_893_ = _e1292;
                                                phi_896_ = _e892;
                                                phi_2663_ = _e472;
                                                break if !(_e898);
                                            }
                                        }
                                        let _e1295 = phi_2663_;
                                        phi_2777_ = _e1295;
                                        if _e1295 {
                                            break;
                                        }
                                        phi_2781_ = _e1295;
                                        let _e1441 = local_12;
                                        phi_2595_ = _e1441;
                                        phi_2596_ = _e514;
                                        phi_2597_ = false;
                                        phi_2598_ = _e518;
                                    } else {
                                        let _e533 = (_e514.member_1 < _e77);
                                        if _e533 {
                                            if _e533 {
                                            } else {
                                                phi_2777_ = true;
                                                break;
                                            }
                                            let _e535 = global_5.member[_e514.member_1];
                                            phi_1665_ = _e535;
                                        } else {
                                            phi_1665_ = type_42(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e537 = phi_1665_;
                                        let _e552 = ((10u * _e239) & 31u);
                                        let _e555 = ((_e537.member[0] >> bitcast<u32>(_e552)) & 1023u);
                                        let _e560 = bitcast<f32>((bitcast<u32>(((_e514.member.member_1[0] - _e514.member.member[0]) * 0.0009775171f)) ^ _e111));
                                        let _e566 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e555) * _e560)) ^ _e111)));
                                        let _e570 = select(select(_e514.member.member_1[0], _e566, (_e566 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e555 == 1023u));
                                        let _e572 = ((10u * _e238) & 31u);
                                        let _e575 = ((_e537.member[0] >> bitcast<u32>(_e572)) & 1023u);
                                        let _e580 = bitcast<f32>((bitcast<u32>(((_e514.member.member_1[1] - _e514.member.member[1]) * 0.0009775171f)) ^ _e111));
                                        let _e586 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e575) * _e580)) ^ _e111)));
                                        let _e590 = select(select(_e514.member.member_1[1], _e586, (_e586 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e575 == 1023u));
                                        let _e592 = ((10u * _e240) & 31u);
                                        let _e595 = ((_e537.member[0] >> bitcast<u32>(_e592)) & 1023u);
                                        let _e600 = bitcast<f32>((bitcast<u32>(((_e514.member.member_1[2] - _e514.member.member[2]) * 0.0009775171f)) ^ _e111));
                                        let _e606 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e595) * _e600)) ^ _e111)));
                                        let _e610 = select(select(_e514.member.member_1[2], _e606, (_e606 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e595 == 1023u));
                                        let _e613 = ((_e537.member[1] >> bitcast<u32>(_e552)) & 1023u);
                                        let _e619 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e613) * _e560)) ^ _e111)));
                                        let _e623 = select(select(_e514.member.member_1[0], _e619, (_e619 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e613 == 1023u));
                                        let _e626 = ((_e537.member[1] >> bitcast<u32>(_e572)) & 1023u);
                                        let _e632 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e626) * _e580)) ^ _e111)));
                                        let _e636 = select(select(_e514.member.member_1[1], _e632, (_e632 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e626 == 1023u));
                                        let _e639 = ((_e537.member[1] >> bitcast<u32>(_e592)) & 1023u);
                                        let _e645 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e639) * _e600)) ^ _e111)));
                                        let _e649 = select(select(_e514.member.member_1[2], _e645, (_e645 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e639 == 1023u));
                                        let _e655 = ((_e537.member_1[0] >> bitcast<u32>(_e552)) & 1023u);
                                        let _e661 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e655) * _e560)) ^ _e111)));
                                        let _e665 = select(select(_e514.member.member_1[0], _e661, (_e661 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e655 == 1023u));
                                        let _e668 = ((_e537.member_1[0] >> bitcast<u32>(_e572)) & 1023u);
                                        let _e674 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e668) * _e580)) ^ _e111)));
                                        let _e678 = select(select(_e514.member.member_1[1], _e674, (_e674 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e668 == 1023u));
                                        let _e681 = ((_e537.member_1[0] >> bitcast<u32>(_e592)) & 1023u);
                                        let _e687 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e681) * _e600)) ^ _e111)));
                                        let _e691 = select(select(_e514.member.member_1[2], _e687, (_e687 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e681 == 1023u));
                                        let _e694 = ((_e537.member_1[1] >> bitcast<u32>(_e552)) & 1023u);
                                        let _e700 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e694) * _e560)) ^ _e111)));
                                        let _e704 = select(select(_e514.member.member_1[0], _e700, (_e700 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e694 == 1023u));
                                        let _e707 = ((_e537.member_1[1] >> bitcast<u32>(_e572)) & 1023u);
                                        let _e713 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e707) * _e580)) ^ _e111)));
                                        let _e717 = select(select(_e514.member.member_1[1], _e713, (_e713 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e707 == 1023u));
                                        let _e720 = ((_e537.member_1[1] >> bitcast<u32>(_e592)) & 1023u);
                                        let _e726 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e720) * _e600)) ^ _e111)));
                                        let _e730 = select(select(_e514.member.member_1[2], _e726, (_e726 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e720 == 1023u));
                                        let _e735 = type_49(type_47(array<f32, 3>(_e570, _e590, _e610), array<f32, 3>(_e623, _e636, _e649)), _e537.member_2);
                                        let _e740 = type_49(type_47(array<f32, 3>(_e665, _e678, _e691), array<f32, 3>(_e704, _e717, _e730)), _e537.member_3);
                                        let _e747 = ((_e570 - _e311) * _e316);
                                        let _e748 = ((_e665 - _e311) * _e316);
                                        let _e749 = ((_e623 - _e312) * _e316);
                                        let _e750 = ((_e704 - _e312) * _e316);
                                        let _e755 = ((_e590 - _e349) * _e354);
                                        let _e756 = ((_e678 - _e349) * _e354);
                                        let _e757 = ((_e636 - _e350) * _e354);
                                        let _e758 = ((_e717 - _e350) * _e354);
                                        let _e763 = ((_e610 - _e387) * _e392);
                                        let _e764 = ((_e691 - _e387) * _e392);
                                        let _e765 = ((_e649 - _e388) * _e392);
                                        let _e766 = ((_e730 - _e388) * _e392);
                                        let _e768 = select(_e765, _e763, (_e763 < _e765));
                                        let _e770 = select(_e766, _e764, (_e764 < _e766));
                                        let _e772 = select(_e765, _e763, (_e763 > _e765));
                                        let _e774 = select(_e766, _e764, (_e764 > _e766));
                                        let _e776 = select(_e749, _e747, (_e747 < _e749));
                                        let _e778 = select(_e750, _e748, (_e748 < _e750));
                                        let _e780 = select(_e757, _e755, (_e755 < _e757));
                                        let _e782 = select(_e758, _e756, (_e756 < _e758));
                                        let _e784 = select(_e780, _e776, (_e776 > _e780));
                                        let _e786 = select(_e782, _e778, (_e778 > _e782));
                                        let _e788 = select(_e768, _e784, (_e784 > _e768));
                                        let _e790 = select(_e770, _e786, (_e786 > _e770));
                                        let _e792 = select(_e749, _e747, (_e747 > _e749));
                                        let _e794 = select(_e750, _e748, (_e748 > _e750));
                                        let _e796 = select(_e757, _e755, (_e755 > _e757));
                                        let _e798 = select(_e758, _e756, (_e756 > _e758));
                                        let _e800 = select(_e796, _e792, (_e792 < _e796));
                                        let _e802 = select(_e798, _e794, (_e794 < _e798));
                                        let _e807 = -(_e768);
                                        let _e808 = -(_e770);
                                        let _e815 = (select(_e772, _e800, (_e800 < _e772)) + (select(_e807, _e772, (_e772 > _e807)) * 0.0000019073523f));
                                        let _e816 = (select(_e774, _e802, (_e802 < _e774)) + (select(_e808, _e774, (_e774 > _e808)) * 0.0000019073523f));
                                        let _e818 = select(_e439, _e788, (_e788 > _e439));
                                        let _e820 = select(_e439, _e790, (_e790 > _e439));
                                        let _e825 = (_e818 <= select(_e474.member.member_1, _e815, (_e815 < _e474.member.member_1)));
                                        let _e826 = (_e820 <= select(_e474.member.member_1, _e816, (_e816 < _e474.member.member_1)));
                                        let _e827 = (_e818 <= _e820);
                                        if _e825 {
                                            if _e826 {
                                                if _e827 {
                                                    phi_2497_ = _e740;
                                                } else {
                                                    phi_2497_ = _e735;
                                                }
                                                let _e829 = phi_2497_;
                                                let _e837 = (_e518 % 128u);
                                                let _e838 = (_e837 < 128u);
                                                if _e838 {
                                                } else {
                                                    phi_2777_ = true;
                                                    break;
                                                }
                                                local_6[_e837] = _e829.member_1;
                                                if _e838 {
                                                } else {
                                                    phi_2777_ = true;
                                                    break;
                                                }
                                                local_5[_e837] = _e829.member.member[0];
                                                if _e838 {
                                                } else {
                                                    phi_2777_ = true;
                                                    break;
                                                }
                                                local_4[_e837] = _e829.member.member[1];
                                                if _e838 {
                                                } else {
                                                    phi_2777_ = true;
                                                    break;
                                                }
                                                local_3[_e837] = _e829.member.member[2];
                                                if _e838 {
                                                } else {
                                                    phi_2777_ = true;
                                                    break;
                                                }
                                                local_2[_e837] = _e829.member.member_1[0];
                                                if _e838 {
                                                } else {
                                                    phi_2777_ = true;
                                                    break;
                                                }
                                                local_1[_e837] = _e829.member.member_1[1];
                                                if _e838 {
                                                } else {
                                                    phi_2777_ = true;
                                                    break;
                                                }
                                                local[_e837] = _e829.member.member_1[2];
                                                if _e838 {
                                                } else {
                                                    phi_2777_ = true;
                                                    break;
                                                }
                                                local_7[_e837] = select(_e820, _e818, (_e818 > _e820));
                                                if _e827 {
                                                    phi_2574_ = _e735;
                                                } else {
                                                    phi_2574_ = _e740;
                                                }
                                                let _e855 = phi_2574_;
                                                phi_2575_ = _e855;
                                                phi_2576_ = (_e518 + 1u);
                                            } else {
                                                phi_2575_ = type_49();
                                                phi_2576_ = u32();
                                            }
                                            let _e857 = phi_2575_;
                                            let _e859 = phi_2576_;
                                            phi_2578_ = _e857;
                                            phi_2579_ = _e859;
                                            phi_2580_ = select(true, false, _e826);
                                        } else {
                                            phi_2578_ = type_49();
                                            phi_2579_ = u32();
                                            phi_2580_ = true;
                                        }
                                        let _e862 = phi_2578_;
                                        let _e864 = phi_2579_;
                                        let _e866 = phi_2580_;
                                        if _e866 {
                                            if _e825 {
                                                phi_2587_ = _e735;
                                            } else {
                                                phi_2587_ = _e740;
                                            }
                                            let _e868 = phi_2587_;
                                            phi_2592_ = _e868;
                                            phi_2593_ = select(_e826, true, _e825);
                                        } else {
                                            phi_2592_ = _e862;
                                            phi_2593_ = _e516;
                                        }
                                        let _e871 = phi_2592_;
                                        let _e873 = phi_2593_;
                                        phi_2781_ = _e472;
                                        phi_2595_ = type_38(_e474.member, (_e474.member_1 + 1u), _e474.member_2);
                                        phi_2596_ = _e871;
                                        phi_2597_ = _e873;
                                        phi_2598_ = select(_e864, _e518, _e866);
                                    }
                                    let _e1297 = phi_2781_;
                                    let _e1299 = phi_2595_;
                                    let _e1301 = phi_2596_;
                                    let _e1303 = phi_2597_;
                                    let _e1305 = phi_2598_;
                                    phi_2780_ = _e1297;
                                    phi_2599_ = _e1299;
                                    phi_2600_ = _e1301;
                                    phi_2601_ = (_e478 - 1u);
                                    phi_2602_ = _e1303;
                                    phi_2603_ = _e1305;
                                } else {
                                    phi_2780_ = _e472;
                                    phi_2599_ = _e474;
                                    phi_2600_ = _e514;
                                    phi_2601_ = _e478;
                                    phi_2602_ = _e516;
                                    phi_2603_ = _e518;
                                }
                                let _e1307 = phi_2780_;
                                let _e1309 = phi_2599_;
                                let _e1311 = phi_2600_;
                                let _e1313 = phi_2601_;
                                let _e1315 = phi_2602_;
                                let _e1317 = phi_2603_;
                                phi_2779_ = _e1307;
                                phi_2604_ = _e1309;
                                phi_2605_ = _e1311;
                                phi_2606_ = _e1313;
                                phi_2607_ = _e1315;
                                phi_2608_ = _e1317;
                            } else {
                                phi_2779_ = _e472;
                                phi_2604_ = type_38();
                                phi_2605_ = type_49();
                                phi_2606_ = u32();
                                phi_2607_ = bool();
                                phi_2608_ = u32();
                            }
                            let _e1319 = phi_2779_;
                            let _e1321 = phi_2604_;
                            let _e1323 = phi_2605_;
                            let _e1325 = phi_2606_;
                            let _e1327 = phi_2607_;
                            let _e1329 = phi_2608_;
                            phi_2778_ = _e1319;
                            phi_768_ = _e1321;
                            phi_771_ = _e1323;
                            phi_773_ = _e1325;
                            phi_775_ = _e1327;
                            phi_777_ = _e1329;
                            phi_2609_ = _e486;
                        } else {
                            phi_2778_ = _e472;
                            phi_768_ = type_38();
                            phi_771_ = type_49();
                            phi_773_ = u32();
                            phi_775_ = bool();
                            phi_777_ = u32();
                            phi_2609_ = false;
                        }
                        let _e1331 = phi_2778_;
                        let _e1333 = phi_768_;
                        let _e1335 = phi_771_;
                        let _e1337 = phi_773_;
                        let _e1339 = phi_775_;
                        let _e1341 = phi_777_;
                        let _e1343 = phi_2609_;
                        continue;
                        continuing {
                            phi_2669_ = _e1331;
                            phi_767_ = _e1333;
                            phi_770_ = _e1335;
                            phi_772_ = _e1337;
                            phi_774_ = _e1339;
                            phi_776_ = _e1341;
                            phi_2777_ = _e1331;
                            break if !(_e1343);
                        }
                    }
                    let _e1346 = phi_2777_;
                    if _e1346 {
                        break;
                    }
                    let _e1348 = local_10;
                    let _e1351 = local_11;
                    if _e127 {
                    } else {
                        break;
                    }
                    global_6.member[_e125][0u] = _e1348.member_1;
                    global_6.member[_e125][1u] = _e1351.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
