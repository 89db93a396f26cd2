struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<array<u32, 2>>,
}

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: type_21,
    member_1: f32,
}

struct type_31 {
    member: array<type_22>,
}

struct type_33 {
    member: type_28,
    member_1: u32,
    member_2: u32,
}

struct type_35 {
    member: array<vec4<u32>, 2>,
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

struct type_42 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_44 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_46 {
    member: array<type_44>,
}

struct type_50 {
    member: type_42,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_35;
@group(0) @binding(4) 
var<storage> global_3: type_31;
@group(0) @binding(2) 
var<storage> global_4: type_39;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_17;
@group(0) @binding(3) 
var<storage> global_6: type_46;

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
    var phi_334_: i32;
    var phi_335_: i32;
    var phi_345_: bool;
    var phi_355_: u32;
    var phi_356_: u32;
    var phi_358_: bool;
    var phi_363_: u32;
    var phi_375_: i32;
    var phi_395_: i32;
    var phi_413_: f32;
    var phi_419_: f32;
    var phi_430_: f32;
    var phi_436_: f32;
    var phi_459_: f32;
    var phi_470_: f32;
    var phi_479_: f32;
    var phi_485_: f32;
    var phi_496_: f32;
    var phi_502_: f32;
    var phi_525_: f32;
    var phi_536_: f32;
    var phi_545_: f32;
    var phi_551_: f32;
    var phi_562_: f32;
    var phi_568_: f32;
    var phi_591_: f32;
    var phi_602_: f32;
    var phi_702_: f32;
    var phi_703_: f32;
    var phi_3110_: bool;
    var phi_777_: type_33;
    var phi_780_: type_50;
    var phi_782_: u32;
    var phi_784_: bool;
    var phi_786_: u32;
    var phi_797_: bool;
    var phi_883_: type_50;
    var phi_884_: bool;
    var phi_885_: u32;
    var phi_2106_: type_37;
    var phi_2938_: type_50;
    var phi_3015_: type_50;
    var phi_3016_: type_50;
    var phi_3017_: u32;
    var phi_3019_: type_50;
    var phi_3020_: u32;
    var phi_3021_: bool;
    var phi_3028_: type_50;
    var phi_3033_: type_50;
    var phi_3034_: bool;
    var phi_904_: type_33;
    var phi_907_: type_4;
    var phi_908_: type_4;
    var phi_930_: type_4;
    var phi_958_: u32;
    var phi_974_: type_44;
    var phi_1350_: bool;
    var phi_1379_: bool;
    var phi_1756_: f32;
    var phi_1757_: f32;
    var phi_1758_: f32;
    var phi_1759_: f32;
    var phi_1760_: vec3<f32>;
    var phi_1761_: vec3<f32>;
    var phi_1762_: vec3<f32>;
    var phi_1763_: vec3<f32>;
    var phi_1794_: bool;
    var phi_1803_: vec3<f32>;
    var phi_1968_: f32;
    var phi_1970_: f32;
    var phi_1971_: bool;
    var phi_1991_: f32;
    var phi_1992_: f32;
    var phi_2015_: type_21;
    var phi_2017_: type_21;
    var phi_2018_: bool;
    var phi_2022_: type_21;
    var phi_2023_: type_21;
    var phi_2024_: type_21;
    var phi_2025_: bool;
    var phi_2029_: type_21;
    var phi_2030_: bool;
    var phi_2031_: type_21;
    var phi_2032_: bool;
    var phi_2033_: bool;
    var phi_2034_: type_21;
    var phi_2035_: bool;
    var phi_2036_: bool;
    var phi_2044_: type_21;
    var phi_2045_: bool;
    var phi_2049_: type_21;
    var phi_2074_: bool;
    var phi_2075_: bool;
    var phi_2082_: type_33;
    var phi_2083_: type_33;
    var phi_2084_: type_33;
    var phi_905_: type_33;
    var phi_3104_: bool;
    var phi_3268_: bool;
    var phi_3036_: type_33;
    var phi_3037_: type_50;
    var phi_3038_: bool;
    var phi_3039_: u32;
    var phi_3267_: bool;
    var phi_3040_: type_33;
    var phi_3041_: type_50;
    var phi_3042_: u32;
    var phi_3043_: bool;
    var phi_3044_: u32;
    var phi_3266_: bool;
    var phi_3045_: type_33;
    var phi_3046_: type_50;
    var phi_3047_: u32;
    var phi_3048_: bool;
    var phi_3049_: u32;
    var phi_3265_: bool;
    var phi_778_: type_33;
    var phi_781_: type_50;
    var phi_783_: u32;
    var phi_785_: bool;
    var phi_787_: u32;
    var phi_3050_: bool;
    var phi_3264_: bool;
    var local_10: type_33;
    var local_11: type_33;
    var local_12: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e75 = global;
            let _e78 = arrayLength((&global_4.member));
            let _e89 = global_2.member[0u][0u];
            let _e93 = global_2.member[0u][1u];
            let _e97 = global_2.member[0u][2u];
            let _e101 = global_2.member[1u][0u];
            let _e105 = global_2.member[1u][1u];
            let _e109 = global_2.member[1u][2u];
            let _e113 = global_2.member[1u][3u];
            let _e116 = global_1.member[0u];
            let _e117 = bitcast<i32>(_e116);
            let _e127 = (_e75.x + (_e75.y * 2097152u));
            let _e128 = (_e127 < arrayLength((&global_3.member)));
            if _e128 {
                let _e129 = (_e127 < arrayLength((&global_5.member)));
                if _e129 {
                    if _e128 {
                    } else {
                        break;
                    }
                    let _e137 = global_3.member[_e127].member_2[0u];
                    let _e139 = (bitcast<u32>(_e137) & 2147483647u);
                    let _e144 = global_3.member[_e127].member_2[1u];
                    let _e146 = (bitcast<u32>(_e144) & 2147483647u);
                    let _e151 = global_3.member[_e127].member_2[2u];
                    let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                    let _e158 = global_3.member[_e127].member[0u];
                    let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                    let _e165 = global_3.member[_e127].member[1u];
                    let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                    let _e172 = global_3.member[_e127].member[2u];
                    let _e174 = (bitcast<u32>(_e172) & 2147483647u);
                    let _e176 = select(_e146, _e139, (_e146 < _e139));
                    let _e178 = select(_e153, _e176, (_e153 < _e176));
                    let _e180 = select(_e160, _e178, (_e160 < _e178));
                    let _e182 = select(_e167, _e180, (_e167 < _e180));
                    let _e184 = select(_e174, _e182, (_e174 < _e182));
                    let _e188 = global_3.member[_e127].member_1;
                    let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                    let _e197 = global_3.member[_e127].member_3;
                    let _e203 = (((select(_e190, _e184, (_e190 < _e184)) < 2139095040u) && ((bitcast<u32>(_e197) & 2147483647u) <= 2139095040u)) && (_e178 > 0u));
                    if _e203 {
                        let _e206 = (bitcast<u32>(bitcast<f32>(_e178)) & 2147483647u);
                        if (_e206 >= 8388608u) {
                            phi_334_ = (bitcast<i32>((_e206 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_334_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e206)), 32u, (_e206 == 0u))));
                        }
                        let _e220 = phi_334_;
                        phi_335_ = _e220;
                    } else {
                        phi_335_ = 0i;
                    }
                    let _e222 = phi_335_;
                    let _e223 = (_e139 == _e178);
                    if _e223 {
                        phi_345_ = true;
                    } else {
                        phi_345_ = (_e146 == _e178);
                    }
                    let _e226 = phi_345_;
                    let _e227 = select(1u, 0u, _e223);
                    if _e226 {
                        let _e228 = (_e227 + 1u);
                        phi_355_ = _e228;
                        phi_356_ = _e228;
                        phi_358_ = select(true, false, (_e228 == 2u));
                    } else {
                        phi_355_ = u32();
                        phi_356_ = 0u;
                        phi_358_ = true;
                    }
                    let _e232 = phi_355_;
                    let _e234 = phi_356_;
                    let _e236 = phi_358_;
                    if _e236 {
                        phi_363_ = (_e234 + 1u);
                    } else {
                        phi_363_ = 0u;
                    }
                    let _e240 = phi_363_;
                    let _e241 = select(_e232, _e234, _e236);
                    let _e242 = select(_e227, select(2u, _e227, _e226), _e236);
                    if (_e117 < -126i) {
                        phi_375_ = -126i;
                    } else {
                        phi_375_ = select(_e117, 127i, (_e117 > 127i));
                    }
                    let _e247 = phi_375_;
                    let _e252 = bitcast<f32>((bitcast<u32>((_e247 + 127i)) << bitcast<u32>(23i)));
                    let _e258 = bitcast<f32>((bitcast<u32>(((_e117 - _e247) + 127i)) << bitcast<u32>(23i)));
                    let _e259 = -(_e222);
                    if (_e259 < -126i) {
                        phi_395_ = -126i;
                    } else {
                        phi_395_ = select(_e259, 127i, (_e259 > 127i));
                    }
                    let _e264 = phi_395_;
                    let _e269 = bitcast<f32>((bitcast<u32>((_e264 + 127i)) << bitcast<u32>(23i)));
                    let _e275 = bitcast<f32>((bitcast<u32>(((_e259 - _e264) + 127i)) << bitcast<u32>(23i)));
                    let _e279 = global_3.member[_e127].member;
                    let _e280 = (_e241 == 0u);
                    if _e280 {
                        phi_413_ = _e279[0];
                    } else {
                        phi_413_ = _e279[1];
                    }
                    let _e284 = phi_413_;
                    let _e285 = (_e241 == 2u);
                    if _e285 {
                        phi_419_ = _e279[2];
                    } else {
                        phi_419_ = _e284;
                    }
                    let _e288 = phi_419_;
                    let _e290 = ((_e288 * _e252) * _e258);
                    let _e291 = global_3.member[_e127].member_2;
                    if _e280 {
                        phi_430_ = _e291[0];
                    } else {
                        phi_430_ = _e291[1];
                    }
                    let _e295 = phi_430_;
                    if _e285 {
                        phi_436_ = _e291[2];
                    } else {
                        phi_436_ = _e295;
                    }
                    let _e298 = phi_436_;
                    let _e300 = ((_e298 * _e269) * _e275);
                    let _e304 = (bitcast<f32>((bitcast<u32>(_e300) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e304 {
                        let _e308 = (bitcast<f32>((bitcast<u32>(_e290) & 2147483647u)) * 0.00000011920929f);
                        phi_459_ = select(0.00000000000011368684f, _e308, (_e308 > 0.00000000000011368684f));
                    } else {
                        phi_459_ = 0f;
                    }
                    let _e312 = phi_459_;
                    let _e313 = (_e290 + _e312);
                    let _e314 = (_e290 - _e312);
                    let _e315 = select(_e300, 0f, _e304);
                    if _e304 {
                        phi_470_ = 38685626000000000000000000f;
                    } else {
                        phi_470_ = (1f / _e300);
                    }
                    let _e318 = phi_470_;
                    let _e319 = (_e240 == 0u);
                    if _e319 {
                        phi_479_ = _e279[0];
                    } else {
                        phi_479_ = _e279[1];
                    }
                    let _e323 = phi_479_;
                    let _e324 = (_e240 == 2u);
                    if _e324 {
                        phi_485_ = _e279[2];
                    } else {
                        phi_485_ = _e323;
                    }
                    let _e327 = phi_485_;
                    let _e329 = ((_e327 * _e252) * _e258);
                    if _e319 {
                        phi_496_ = _e291[0];
                    } else {
                        phi_496_ = _e291[1];
                    }
                    let _e333 = phi_496_;
                    if _e324 {
                        phi_502_ = _e291[2];
                    } else {
                        phi_502_ = _e333;
                    }
                    let _e336 = phi_502_;
                    let _e338 = ((_e336 * _e269) * _e275);
                    let _e342 = (bitcast<f32>((bitcast<u32>(_e338) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e342 {
                        let _e346 = (bitcast<f32>((bitcast<u32>(_e329) & 2147483647u)) * 0.00000011920929f);
                        phi_525_ = select(0.00000000000011368684f, _e346, (_e346 > 0.00000000000011368684f));
                    } else {
                        phi_525_ = 0f;
                    }
                    let _e350 = phi_525_;
                    let _e351 = (_e329 + _e350);
                    let _e352 = (_e329 - _e350);
                    let _e353 = select(_e338, 0f, _e342);
                    if _e342 {
                        phi_536_ = 38685626000000000000000000f;
                    } else {
                        phi_536_ = (1f / _e338);
                    }
                    let _e356 = phi_536_;
                    let _e357 = (_e242 == 0u);
                    if _e357 {
                        phi_545_ = _e279[0];
                    } else {
                        phi_545_ = _e279[1];
                    }
                    let _e361 = phi_545_;
                    let _e362 = (_e242 == 2u);
                    if _e362 {
                        phi_551_ = _e279[2];
                    } else {
                        phi_551_ = _e361;
                    }
                    let _e365 = phi_551_;
                    let _e367 = ((_e365 * _e252) * _e258);
                    if _e357 {
                        phi_562_ = _e291[0];
                    } else {
                        phi_562_ = _e291[1];
                    }
                    let _e371 = phi_562_;
                    if _e362 {
                        phi_568_ = _e291[2];
                    } else {
                        phi_568_ = _e371;
                    }
                    let _e374 = phi_568_;
                    let _e376 = ((_e374 * _e269) * _e275);
                    let _e380 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e380 {
                        let _e384 = (bitcast<f32>((bitcast<u32>(_e367) & 2147483647u)) * 0.00000011920929f);
                        phi_591_ = select(0.00000000000011368684f, _e384, (_e384 > 0.00000000000011368684f));
                    } else {
                        phi_591_ = 0f;
                    }
                    let _e388 = phi_591_;
                    let _e389 = (_e367 + _e388);
                    let _e390 = (_e367 - _e388);
                    let _e391 = select(_e376, 0f, _e380);
                    if _e380 {
                        phi_602_ = 38685626000000000000000000f;
                    } else {
                        phi_602_ = (1f / _e376);
                    }
                    let _e394 = phi_602_;
                    let _e397 = bitcast<f32>((bitcast<u32>(_e290) & 2147483647u));
                    let _e400 = bitcast<f32>((bitcast<u32>(_e329) & 2147483647u));
                    let _e402 = select(_e400, _e397, (_e397 > _e400));
                    let _e405 = bitcast<f32>((bitcast<u32>(_e367) & 2147483647u));
                    let _e408 = (_e117 + _e222);
                    if (_e203 && (select(_e405, _e402, (_e402 > _e405)) <= 1099511600000f)) {
                        let _e411 = (_e408 / 3i);
                        let _e418 = bitcast<f32>((bitcast<u32>((_e411 + 127i)) << bitcast<u32>(23i)));
                        let _e425 = bitcast<f32>((bitcast<u32>(((_e408 - (2i * _e411)) + 127i)) << bitcast<u32>(23i)));
                        let _e426 = (((_e188 * _e418) * _e418) * _e425);
                        let _e428 = select(340282350000000000000000000000000000000f, _e426, (_e426 < 340282350000000000000000000000000000000f));
                        let _e433 = (((_e197 * _e418) * _e418) * _e425);
                        let _e435 = select(340282350000000000000000000000000000000f, _e433, (_e433 < 340282350000000000000000000000000000000f));
                        phi_702_ = select(-340282350000000000000000000000000000000f, _e435, (_e435 > -340282350000000000000000000000000000000f));
                        phi_703_ = select(-340282350000000000000000000000000000000f, _e428, (_e428 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_702_ = 0f;
                        phi_703_ = 1f;
                    }
                    let _e439 = phi_702_;
                    let _e441 = phi_703_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e89), bitcast<f32>(_e93), bitcast<f32>(_e97));
                    let _e447 = (_e241 % 3u);
                    let _e448 = (_e447 < 3u);
                    if _e448 {
                    } else {
                        break;
                    }
                    let _e450 = local_9[_e447];
                    let _e451 = (_e240 % 3u);
                    let _e452 = (_e451 < 3u);
                    if _e452 {
                    } else {
                        break;
                    }
                    let _e454 = local_9[_e451];
                    let _e455 = (_e242 % 3u);
                    let _e456 = (_e455 < 3u);
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e458 = local_9[_e455];
                    local_8 = array<f32, 3>(bitcast<f32>(_e101), bitcast<f32>(_e105), bitcast<f32>(_e109));
                    if _e448 {
                    } else {
                        break;
                    }
                    let _e462 = local_8[_e447];
                    if _e452 {
                    } else {
                        break;
                    }
                    let _e464 = local_8[_e451];
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e466 = local_8[_e455];
                    phi_3110_ = false;
                    phi_777_ = type_33(type_28(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e439), 0u, 0u);
                    phi_780_ = type_50(type_42(array<f32, 3>(_e450, _e454, _e458), array<f32, 3>(_e462, _e464, _e466)), select(0u, 2147483648u, (_e78 == 0u)));
                    phi_782_ = ((3u * _e78) + 1u);
                    phi_784_ = (_e441 <= _e439);
                    phi_786_ = 0u;
                    loop {
                        let _e474 = phi_3110_;
                        let _e476 = phi_777_;
                        let _e478 = phi_780_;
                        let _e480 = phi_782_;
                        let _e482 = phi_784_;
                        let _e484 = phi_786_;
                        local_10 = _e476;
                        local_11 = _e476;
                        if _e482 {
                            phi_797_ = true;
                        } else {
                            phi_797_ = (_e484 > 0u);
                        }
                        let _e487 = phi_797_;
                        if _e487 {
                            let _e488 = (_e480 > 0u);
                            if _e488 {
                                if _e482 {
                                    phi_883_ = _e478;
                                    phi_884_ = _e482;
                                    phi_885_ = _e484;
                                } else {
                                    let _e489 = (_e484 - 1u);
                                    let _e490 = (_e489 % 128u);
                                    let _e491 = (_e490 < 128u);
                                    if _e491 {
                                    } else {
                                        phi_3264_ = true;
                                        break;
                                    }
                                    let _e493 = local_6[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3264_ = true;
                                        break;
                                    }
                                    let _e495 = local_5[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3264_ = true;
                                        break;
                                    }
                                    let _e497 = local_4[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3264_ = true;
                                        break;
                                    }
                                    let _e499 = local_3[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3264_ = true;
                                        break;
                                    }
                                    let _e502 = local_2[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3264_ = true;
                                        break;
                                    }
                                    let _e504 = local_1[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3264_ = true;
                                        break;
                                    }
                                    let _e506 = local[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3264_ = true;
                                        break;
                                    }
                                    let _e511 = local_7[_e490];
                                    phi_883_ = type_50(type_42(array<f32, 3>(_e495, _e497, _e499), array<f32, 3>(_e502, _e504, _e506)), _e493);
                                    phi_884_ = (_e511 <= _e476.member.member_1);
                                    phi_885_ = _e489;
                                }
                                let _e516 = phi_883_;
                                let _e518 = phi_884_;
                                let _e520 = phi_885_;
                                if _e518 {
                                    if ((_e516.member_1 & 2147483648u) != 0u) {
                                        phi_904_ = _e476;
                                        phi_907_ = type_4(0u, ((_e516.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e880 = phi_904_;
                                            let _e882 = phi_907_;
                                            local_12 = _e880;
                                            if (_e882.member < _e882.member_1) {
                                                phi_908_ = type_4((_e882.member + 1u), _e882.member_1);
                                                phi_930_ = type_4(1u, _e882.member);
                                            } else {
                                                phi_908_ = _e882;
                                                phi_930_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e895 = phi_908_;
                                            let _e897 = phi_930_;
                                            let _e901 = (bitcast<i32>(_e897.member) != 0i);
                                            if _e901 {
                                                let _e907 = type_33(_e880.member, _e880.member_1, (_e880.member_2 + 1u));
                                                let _e908 = ((_e516.member_1 & 268435455u) + _e897.member_1);
                                                let _e909 = (_e908 < arrayLength((&global_6.member)));
                                                if _e909 {
                                                    if _e909 {
                                                    } else {
                                                        phi_3104_ = true;
                                                        break;
                                                    }
                                                    let _e912 = global_6.member[_e908].member_1;
                                                    phi_958_ = _e912;
                                                } else {
                                                    phi_958_ = 4294967295u;
                                                }
                                                let _e914 = phi_958_;
                                                if _e909 {
                                                    if _e909 {
                                                    } else {
                                                        phi_3104_ = true;
                                                        break;
                                                    }
                                                    let _e916 = global_6.member[_e908];
                                                    phi_974_ = _e916;
                                                } else {
                                                    phi_974_ = type_44(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e918 = phi_974_;
                                                let _e930 = ((10u * _e241) & 31u);
                                                let _e933 = ((_e918.member[0] >> bitcast<u32>(_e930)) & 1023u);
                                                let _e938 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[0] - _e516.member.member[0]) * 0.0009775171f)) ^ _e113));
                                                let _e944 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e933) * _e938)) ^ _e113)));
                                                let _e948 = select(select(_e516.member.member_1[0], _e944, (_e944 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e933 == 1023u));
                                                let _e950 = ((10u * _e240) & 31u);
                                                let _e953 = ((_e918.member[0] >> bitcast<u32>(_e950)) & 1023u);
                                                let _e958 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[1] - _e516.member.member[1]) * 0.0009775171f)) ^ _e113));
                                                let _e964 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e953) * _e958)) ^ _e113)));
                                                let _e968 = select(select(_e516.member.member_1[1], _e964, (_e964 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e953 == 1023u));
                                                let _e970 = ((10u * _e242) & 31u);
                                                let _e973 = ((_e918.member[0] >> bitcast<u32>(_e970)) & 1023u);
                                                let _e978 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[2] - _e516.member.member[2]) * 0.0009775171f)) ^ _e113));
                                                let _e984 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e973) * _e978)) ^ _e113)));
                                                let _e988 = select(select(_e516.member.member_1[2], _e984, (_e984 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e973 == 1023u));
                                                let _e992 = ((_e918.member[1] >> bitcast<u32>(_e930)) & 1023u);
                                                let _e998 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e992) * _e938)) ^ _e113)));
                                                let _e1002 = select(select(_e516.member.member_1[0], _e998, (_e998 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e992 == 1023u));
                                                let _e1005 = ((_e918.member[1] >> bitcast<u32>(_e950)) & 1023u);
                                                let _e1011 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1005) * _e958)) ^ _e113)));
                                                let _e1015 = select(select(_e516.member.member_1[1], _e1011, (_e1011 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e1005 == 1023u));
                                                let _e1018 = ((_e918.member[1] >> bitcast<u32>(_e970)) & 1023u);
                                                let _e1024 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1018) * _e978)) ^ _e113)));
                                                let _e1028 = select(select(_e516.member.member_1[2], _e1024, (_e1024 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e1018 == 1023u));
                                                let _e1032 = ((_e918.member[2] >> bitcast<u32>(_e930)) & 1023u);
                                                let _e1038 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1032) * _e938)) ^ _e113)));
                                                let _e1042 = select(select(_e516.member.member_1[0], _e1038, (_e1038 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e1032 == 1023u));
                                                let _e1045 = ((_e918.member[2] >> bitcast<u32>(_e950)) & 1023u);
                                                let _e1051 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1045) * _e958)) ^ _e113)));
                                                let _e1055 = select(select(_e516.member.member_1[1], _e1051, (_e1051 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e1045 == 1023u));
                                                let _e1058 = ((_e918.member[2] >> bitcast<u32>(_e970)) & 1023u);
                                                let _e1064 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1058) * _e978)) ^ _e113)));
                                                let _e1068 = select(select(_e516.member.member_1[2], _e1064, (_e1064 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e1058 == 1023u));
                                                let _e1073 = (_e988 - _e367);
                                                let _e1076 = (((_e948 - _e290) * _e391) - (_e1073 * _e315));
                                                let _e1079 = (((_e968 - _e329) * _e391) - (_e1073 * _e353));
                                                let _e1082 = (_e1028 - _e367);
                                                let _e1085 = (((_e1002 - _e290) * _e391) - (_e1082 * _e315));
                                                let _e1088 = (((_e1015 - _e329) * _e391) - (_e1082 * _e353));
                                                let _e1091 = (_e1068 - _e367);
                                                let _e1094 = (((_e1042 - _e290) * _e391) - (_e1091 * _e315));
                                                let _e1097 = (((_e1055 - _e329) * _e391) - (_e1091 * _e353));
                                                let _e1098 = (_e1094 * _e1088);
                                                let _e1099 = (_e1097 * _e1085);
                                                let _e1100 = (_e1076 * _e1097);
                                                let _e1101 = (_e1079 * _e1094);
                                                let _e1102 = (_e1085 * _e1079);
                                                let _e1103 = (_e1088 * _e1076);
                                                let _e1108 = (((_e1098 >= _e1099) && (_e1100 >= _e1101)) && (_e1102 >= _e1103));
                                                if (_e1108 || (((_e1098 <= _e1099) && (_e1100 <= _e1101)) && (_e1102 <= _e1103))) {
                                                    let _e1115 = select(-1f, 1f, _e1108);
                                                    let _e1117 = ((_e1098 - _e1099) * _e1115);
                                                    let _e1119 = select(0f, _e1117, (_e1117 > 0f));
                                                    let _e1121 = ((_e1100 - _e1101) * _e1115);
                                                    let _e1123 = select(0f, _e1121, (_e1121 > 0f));
                                                    let _e1125 = ((_e1102 - _e1103) * _e1115);
                                                    let _e1127 = select(0f, _e1125, (_e1125 > 0f));
                                                    let _e1129 = ((_e1119 + _e1123) + _e1127);
                                                    if (_e1129 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2034_ = type_21();
                                                        phi_2035_ = true;
                                                        phi_2036_ = false;
                                                    } else {
                                                        let _e1132 = select(_e1085, _e1076, (_e1076 < _e1085));
                                                        if (select(_e1094, _e1132, (_e1132 < _e1094)) > 0f) {
                                                            phi_1350_ = true;
                                                        } else {
                                                            let _e1137 = select(_e1085, _e1076, (_e1076 > _e1085));
                                                            phi_1350_ = (select(_e1094, _e1137, (_e1137 > _e1094)) < 0f);
                                                        }
                                                        let _e1142 = phi_1350_;
                                                        if _e1142 {
                                                            phi_2031_ = type_21();
                                                            phi_2032_ = true;
                                                            phi_2033_ = false;
                                                        } else {
                                                            let _e1144 = select(_e1088, _e1079, (_e1079 < _e1088));
                                                            if (select(_e1097, _e1144, (_e1144 < _e1097)) > 0f) {
                                                                phi_1379_ = true;
                                                            } else {
                                                                let _e1149 = select(_e1088, _e1079, (_e1079 > _e1088));
                                                                phi_1379_ = (select(_e1097, _e1149, (_e1149 > _e1097)) < 0f);
                                                            }
                                                            let _e1154 = phi_1379_;
                                                            if _e1154 {
                                                                phi_2029_ = type_21();
                                                                phi_2030_ = false;
                                                            } else {
                                                                let _e1156 = select(_e1002, _e948, (_e948 < _e1002));
                                                                let _e1160 = select(_e1002, _e948, (_e948 > _e1002));
                                                                let _e1164 = select(_e1015, _e968, (_e968 < _e1015));
                                                                let _e1168 = select(_e1015, _e968, (_e968 > _e1015));
                                                                let _e1172 = select(_e1028, _e988, (_e988 < _e1028));
                                                                let _e1176 = select(_e1028, _e988, (_e988 > _e1028));
                                                                let _e1181 = ((select(_e1042, _e1156, (_e1156 < _e1042)) - _e313) * _e318);
                                                                let _e1182 = ((select(_e1042, _e1160, (_e1160 > _e1042)) - _e314) * _e318);
                                                                let _e1185 = ((select(_e1055, _e1164, (_e1164 < _e1055)) - _e351) * _e356);
                                                                let _e1186 = ((select(_e1055, _e1168, (_e1168 > _e1055)) - _e352) * _e356);
                                                                let _e1189 = ((select(_e1068, _e1172, (_e1172 < _e1068)) - _e389) * _e394);
                                                                let _e1190 = ((select(_e1068, _e1176, (_e1176 > _e1068)) - _e390) * _e394);
                                                                let _e1192 = select(_e1190, _e1189, (_e1189 < _e1190));
                                                                let _e1194 = select(_e1190, _e1189, (_e1189 > _e1190));
                                                                let _e1196 = select(_e1182, _e1181, (_e1181 < _e1182));
                                                                let _e1198 = select(_e1186, _e1185, (_e1185 < _e1186));
                                                                let _e1200 = select(_e1198, _e1196, (_e1196 > _e1198));
                                                                let _e1202 = select(_e1192, _e1200, (_e1200 > _e1192));
                                                                let _e1204 = select(_e1182, _e1181, (_e1181 > _e1182));
                                                                let _e1206 = select(_e1186, _e1185, (_e1185 > _e1186));
                                                                let _e1208 = select(_e1206, _e1204, (_e1204 < _e1206));
                                                                let _e1210 = select(_e1194, _e1208, (_e1208 < _e1194));
                                                                let _e1211 = -(_e1192);
                                                                let _e1217 = select(_e441, _e1202, (_e1202 > _e441));
                                                                if (_e1217 > (_e1210 + (select(_e1211, _e1194, (_e1194 > _e1211)) * 0.0000019073523f))) {
                                                                    phi_2024_ = type_21();
                                                                    phi_2025_ = true;
                                                                } else {
                                                                    let _e1219 = (_e1217 > _e880.member.member_1);
                                                                    if _e1219 {
                                                                        phi_2023_ = type_21();
                                                                    } else {
                                                                        let _e1220 = vec3<f32>(_e948, _e968, _e988);
                                                                        let _e1221 = vec3<f32>(_e1002, _e1015, _e1028);
                                                                        let _e1222 = vec3<f32>(_e1042, _e1055, _e1068);
                                                                        let _e1223 = (_e1002 - _e948);
                                                                        let _e1224 = (_e1015 - _e968);
                                                                        let _e1225 = (_e1028 - _e988);
                                                                        let _e1226 = vec3<f32>(_e1223, _e1224, _e1225);
                                                                        let _e1227 = (_e1042 - _e1002);
                                                                        let _e1228 = (_e1055 - _e1015);
                                                                        let _e1229 = (_e1068 - _e1028);
                                                                        let _e1230 = vec3<f32>(_e1227, _e1228, _e1229);
                                                                        let _e1231 = (_e948 - _e1042);
                                                                        let _e1232 = (_e968 - _e1055);
                                                                        let _e1233 = (_e988 - _e1068);
                                                                        let _e1234 = vec3<f32>(_e1231, _e1232, _e1233);
                                                                        let _e1237 = bitcast<f32>((bitcast<u32>(_e1223) & 2147483647u));
                                                                        let _e1240 = bitcast<f32>((bitcast<u32>(_e1224) & 2147483647u));
                                                                        let _e1242 = select(_e1240, _e1237, (_e1237 > _e1240));
                                                                        let _e1245 = bitcast<f32>((bitcast<u32>(_e1225) & 2147483647u));
                                                                        let _e1247 = select(_e1245, _e1242, (_e1242 > _e1245));
                                                                        let _e1250 = bitcast<f32>((bitcast<u32>(_e1227) & 2147483647u));
                                                                        let _e1253 = bitcast<f32>((bitcast<u32>(_e1228) & 2147483647u));
                                                                        let _e1255 = select(_e1253, _e1250, (_e1250 > _e1253));
                                                                        let _e1258 = bitcast<f32>((bitcast<u32>(_e1229) & 2147483647u));
                                                                        let _e1260 = select(_e1258, _e1255, (_e1255 > _e1258));
                                                                        let _e1263 = bitcast<f32>((bitcast<u32>(_e1231) & 2147483647u));
                                                                        let _e1266 = bitcast<f32>((bitcast<u32>(_e1232) & 2147483647u));
                                                                        let _e1268 = select(_e1266, _e1263, (_e1263 > _e1266));
                                                                        let _e1271 = bitcast<f32>((bitcast<u32>(_e1233) & 2147483647u));
                                                                        let _e1273 = select(_e1271, _e1268, (_e1268 > _e1271));
                                                                        let _e1275 = select(_e1260, _e1247, (_e1247 > _e1260));
                                                                        let _e1277 = select(_e1273, _e1275, (_e1275 > _e1273));
                                                                        if (_e1247 == _e1277) {
                                                                            phi_1756_ = _e1088;
                                                                            phi_1757_ = _e1085;
                                                                            phi_1758_ = _e1079;
                                                                            phi_1759_ = _e1076;
                                                                            phi_1760_ = _e1220;
                                                                            phi_1761_ = _e1234;
                                                                            phi_1762_ = _e1230;
                                                                            phi_1763_ = _e1226;
                                                                        } else {
                                                                            let _e1279 = (_e1260 == _e1277);
                                                                            let _e1284 = vec3(_e1279);
                                                                            phi_1756_ = select(_e1079, _e1097, _e1279);
                                                                            phi_1757_ = select(_e1076, _e1094, _e1279);
                                                                            phi_1758_ = select(_e1097, _e1088, _e1279);
                                                                            phi_1759_ = select(_e1094, _e1085, _e1279);
                                                                            phi_1760_ = select(_e1222, _e1221, _e1284);
                                                                            phi_1761_ = select(_e1230, _e1226, _e1284);
                                                                            phi_1762_ = select(_e1226, _e1234, _e1284);
                                                                            phi_1763_ = select(_e1234, _e1230, _e1284);
                                                                        }
                                                                        let _e1290 = phi_1756_;
                                                                        let _e1292 = phi_1757_;
                                                                        let _e1294 = phi_1758_;
                                                                        let _e1296 = phi_1759_;
                                                                        let _e1298 = phi_1760_;
                                                                        let _e1300 = phi_1761_;
                                                                        let _e1302 = phi_1762_;
                                                                        let _e1304 = phi_1763_;
                                                                        let _e1311 = ((_e1302.y * _e1300.z) - (_e1300.y * _e1302.z));
                                                                        let _e1316 = ((_e1302.z * _e1300.x) - (_e1300.z * _e1302.x));
                                                                        let _e1319 = ((_e1302.x * _e1300.y) - (_e1300.x * _e1302.y));
                                                                        if (_e1119 >= _e1123) {
                                                                            phi_1794_ = select(true, false, (_e1119 >= _e1127));
                                                                        } else {
                                                                            phi_1794_ = true;
                                                                        }
                                                                        let _e1324 = phi_1794_;
                                                                        if _e1324 {
                                                                            phi_1803_ = select(_e1222, _e1221, vec3((_e1123 >= _e1127)));
                                                                        } else {
                                                                            phi_1803_ = _e1220;
                                                                        }
                                                                        let _e1329 = phi_1803_;
                                                                        let _e1340 = (((_e1311 * (_e1329.x - _e290)) + (_e1316 * (_e1329.y - _e329))) + (_e1319 * (_e1329.z - _e367)));
                                                                        let _e1345 = (((_e1311 * _e315) + (_e1316 * _e353)) + (_e1319 * _e391));
                                                                        let _e1346 = (_e1292 - _e1296);
                                                                        let _e1347 = (_e1290 - _e1294);
                                                                        let _e1355 = (-(((_e1296 * _e1346) + (_e1294 * _e1347))) / ((_e1346 * _e1346) + (_e1347 * _e1347)));
                                                                        let _e1357 = select(1f, _e1355, (_e1355 < 1f));
                                                                        let _e1359 = select(0f, _e1357, (_e1357 > 0f));
                                                                        let _e1372 = ((_e1298.x + (_e1304.x * _e1359)) - _e290);
                                                                        let _e1373 = ((_e1298.y + (_e1304.y * _e1359)) - _e329);
                                                                        let _e1374 = ((_e1298.z + (_e1304.z * _e1359)) - _e367);
                                                                        let _e1375 = (_e1374 / _e391);
                                                                        let _e1387 = bitcast<f32>((bitcast<u32>(_e1372) & 2147483647u));
                                                                        let _e1390 = bitcast<f32>((bitcast<u32>(_e1373) & 2147483647u));
                                                                        let _e1392 = select(_e1390, _e1387, (_e1387 > _e1390));
                                                                        let _e1395 = bitcast<f32>((bitcast<u32>(_e1374) & 2147483647u));
                                                                        let _e1397 = select(_e1395, _e1392, (_e1392 > _e1395));
                                                                        let _e1403 = bitcast<f32>((bitcast<u32>(_e1311) & 2147483647u));
                                                                        let _e1406 = bitcast<f32>((bitcast<u32>(_e1316) & 2147483647u));
                                                                        let _e1408 = select(_e1406, _e1403, (_e1403 > _e1406));
                                                                        let _e1411 = bitcast<f32>((bitcast<u32>(_e1319) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1311 * _e1372) + (_e1316 * _e1373)) + (_e1319 * _e1374)) - _e1340)) & 2147483647u)) <= ((0.0000009536743f * select(_e1277, _e1397, (_e1397 > _e1277))) * select(_e1411, _e1408, (_e1408 > _e1411)))) {
                                                                            let _e1421 = bitcast<f32>((bitcast<u32>(_e1302.x) & 2147483647u));
                                                                            let _e1424 = bitcast<f32>((bitcast<u32>(_e1302.y) & 2147483647u));
                                                                            let _e1426 = select(_e1424, _e1421, (_e1421 > _e1424));
                                                                            let _e1429 = bitcast<f32>((bitcast<u32>(_e1302.z) & 2147483647u));
                                                                            let _e1435 = bitcast<f32>((bitcast<u32>(_e1300.x) & 2147483647u));
                                                                            let _e1438 = bitcast<f32>((bitcast<u32>(_e1300.y) & 2147483647u));
                                                                            let _e1440 = select(_e1438, _e1435, (_e1435 > _e1438));
                                                                            let _e1443 = bitcast<f32>((bitcast<u32>(_e1300.z) & 2147483647u));
                                                                            let _e1447 = (bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u)) > ((0.0000038146973f * select(_e1429, _e1426, (_e1426 > _e1429))) * select(_e1443, _e1440, (_e1440 > _e1443))));
                                                                            if _e1447 {
                                                                                phi_1968_ = (_e1340 / _e1345);
                                                                            } else {
                                                                                phi_1968_ = f32();
                                                                            }
                                                                            let _e1450 = phi_1968_;
                                                                            phi_1970_ = _e1450;
                                                                            phi_1971_ = select(true, false, _e1447);
                                                                        } else {
                                                                            phi_1970_ = f32();
                                                                            phi_1971_ = true;
                                                                        }
                                                                        let _e1453 = phi_1970_;
                                                                        let _e1455 = phi_1971_;
                                                                        if _e1455 {
                                                                            let _e1463 = (((_e1311 * (_e1372 - (_e315 * _e1375))) + (_e1316 * (_e1373 - (_e353 * _e1375)))) / _e1345);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1463) & 2147483647u)) <= _e1277) {
                                                                                phi_1991_ = (_e1375 + _e1463);
                                                                            } else {
                                                                                phi_1991_ = _e1375;
                                                                            }
                                                                            let _e1470 = phi_1991_;
                                                                            phi_1992_ = _e1470;
                                                                        } else {
                                                                            phi_1992_ = _e1453;
                                                                        }
                                                                        let _e1472 = phi_1992_;
                                                                        let _e1474 = select(_e1210, _e1472, (_e1472 < _e1210));
                                                                        let _e1476 = select(_e1202, _e1474, (_e1474 > _e1202));
                                                                        if (_e1476 >= _e441) {
                                                                            let _e1478 = (_e1476 <= _e880.member.member_1);
                                                                            if _e1478 {
                                                                                let _e1479 = (1f / _e1129);
                                                                                phi_2015_ = type_21(_e1476, (_e1123 * _e1479), (_e1127 * _e1479), _e914);
                                                                            } else {
                                                                                phi_2015_ = type_21();
                                                                            }
                                                                            let _e1484 = phi_2015_;
                                                                            phi_2017_ = _e1484;
                                                                            phi_2018_ = select(true, false, _e1478);
                                                                        } else {
                                                                            phi_2017_ = type_21();
                                                                            phi_2018_ = true;
                                                                        }
                                                                        let _e1487 = phi_2017_;
                                                                        let _e1489 = phi_2018_;
                                                                        if _e1489 {
                                                                            phi_2022_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2022_ = _e1487;
                                                                        }
                                                                        let _e1491 = phi_2022_;
                                                                        phi_2023_ = _e1491;
                                                                    }
                                                                    let _e1493 = phi_2023_;
                                                                    phi_2024_ = _e1493;
                                                                    phi_2025_ = _e1219;
                                                                }
                                                                let _e1495 = phi_2024_;
                                                                let _e1497 = phi_2025_;
                                                                phi_2029_ = _e1495;
                                                                phi_2030_ = _e1497;
                                                            }
                                                            let _e1499 = phi_2029_;
                                                            let _e1501 = phi_2030_;
                                                            phi_2031_ = _e1499;
                                                            phi_2032_ = _e1154;
                                                            phi_2033_ = _e1501;
                                                        }
                                                        let _e1503 = phi_2031_;
                                                        let _e1505 = phi_2032_;
                                                        let _e1507 = phi_2033_;
                                                        phi_2034_ = _e1503;
                                                        phi_2035_ = _e1505;
                                                        phi_2036_ = _e1507;
                                                    }
                                                    let _e1509 = phi_2034_;
                                                    let _e1511 = phi_2035_;
                                                    let _e1513 = phi_2036_;
                                                    phi_2044_ = _e1509;
                                                    phi_2045_ = select(_e1513, true, _e1511);
                                                } else {
                                                    phi_2044_ = type_21();
                                                    phi_2045_ = true;
                                                }
                                                let _e1516 = phi_2044_;
                                                let _e1518 = phi_2045_;
                                                if _e1518 {
                                                    phi_2049_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2049_ = _e1516;
                                                }
                                                let _e1520 = phi_2049_;
                                                if (_e1520.member_3 != 4294967295u) {
                                                    if (_e914 != 4294967295u) {
                                                        if (_e1520.member < _e880.member.member.member) {
                                                            phi_2075_ = true;
                                                        } else {
                                                            if (_e1520.member == _e880.member.member.member) {
                                                                phi_2074_ = (_e1520.member_3 < _e880.member.member.member_3);
                                                            } else {
                                                                phi_2074_ = false;
                                                            }
                                                            let _e1535 = phi_2074_;
                                                            phi_2075_ = _e1535;
                                                        }
                                                        let _e1537 = phi_2075_;
                                                        if _e1537 {
                                                            phi_2082_ = type_33(type_28(_e1520, _e1520.member), _e907.member_1, _e907.member_2);
                                                        } else {
                                                            phi_2082_ = _e907;
                                                        }
                                                        let _e1544 = phi_2082_;
                                                        phi_2083_ = _e1544;
                                                    } else {
                                                        phi_2083_ = _e907;
                                                    }
                                                    let _e1546 = phi_2083_;
                                                    phi_2084_ = _e1546;
                                                } else {
                                                    phi_2084_ = _e907;
                                                }
                                                let _e1548 = phi_2084_;
                                                phi_905_ = _e1548;
                                            } else {
                                                phi_905_ = type_33();
                                            }
                                            let _e1550 = phi_905_;
                                            continue;
                                            continuing {
                                                phi_904_ = _e1550;
                                                phi_907_ = _e895;
                                                phi_3104_ = _e474;
                                                break if !(_e901);
                                            }
                                        }
                                        let _e1553 = phi_3104_;
                                        phi_3264_ = _e1553;
                                        if _e1553 {
                                            break;
                                        }
                                        phi_3268_ = _e1553;
                                        let _e1718 = local_12;
                                        phi_3036_ = _e1718;
                                        phi_3037_ = _e516;
                                        phi_3038_ = false;
                                        phi_3039_ = _e520;
                                    } else {
                                        let _e536 = (_e516.member_1 < _e78);
                                        if _e536 {
                                            if _e536 {
                                            } else {
                                                phi_3264_ = true;
                                                break;
                                            }
                                            let _e538 = global_4.member[_e516.member_1];
                                            phi_2106_ = _e538;
                                        } else {
                                            phi_2106_ = type_37(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e540 = phi_2106_;
                                        let _e555 = ((10u * _e241) & 31u);
                                        let _e558 = ((_e540.member[0] >> bitcast<u32>(_e555)) & 1023u);
                                        let _e563 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[0] - _e516.member.member[0]) * 0.0009775171f)) ^ _e113));
                                        let _e569 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e558) * _e563)) ^ _e113)));
                                        let _e573 = select(select(_e516.member.member_1[0], _e569, (_e569 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e558 == 1023u));
                                        let _e575 = ((10u * _e240) & 31u);
                                        let _e578 = ((_e540.member[0] >> bitcast<u32>(_e575)) & 1023u);
                                        let _e583 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[1] - _e516.member.member[1]) * 0.0009775171f)) ^ _e113));
                                        let _e589 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e578) * _e583)) ^ _e113)));
                                        let _e593 = select(select(_e516.member.member_1[1], _e589, (_e589 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e578 == 1023u));
                                        let _e595 = ((10u * _e242) & 31u);
                                        let _e598 = ((_e540.member[0] >> bitcast<u32>(_e595)) & 1023u);
                                        let _e603 = bitcast<f32>((bitcast<u32>(((_e516.member.member_1[2] - _e516.member.member[2]) * 0.0009775171f)) ^ _e113));
                                        let _e609 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e598) * _e603)) ^ _e113)));
                                        let _e613 = select(select(_e516.member.member_1[2], _e609, (_e609 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e598 == 1023u));
                                        let _e616 = ((_e540.member[1] >> bitcast<u32>(_e555)) & 1023u);
                                        let _e622 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e616) * _e563)) ^ _e113)));
                                        let _e626 = select(select(_e516.member.member_1[0], _e622, (_e622 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e616 == 1023u));
                                        let _e629 = ((_e540.member[1] >> bitcast<u32>(_e575)) & 1023u);
                                        let _e635 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e629) * _e583)) ^ _e113)));
                                        let _e639 = select(select(_e516.member.member_1[1], _e635, (_e635 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e629 == 1023u));
                                        let _e642 = ((_e540.member[1] >> bitcast<u32>(_e595)) & 1023u);
                                        let _e648 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e642) * _e603)) ^ _e113)));
                                        let _e652 = select(select(_e516.member.member_1[2], _e648, (_e648 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e642 == 1023u));
                                        let _e658 = ((_e540.member_1[0] >> bitcast<u32>(_e555)) & 1023u);
                                        let _e664 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e658) * _e563)) ^ _e113)));
                                        let _e668 = select(select(_e516.member.member_1[0], _e664, (_e664 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e658 == 1023u));
                                        let _e671 = ((_e540.member_1[0] >> bitcast<u32>(_e575)) & 1023u);
                                        let _e677 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e671) * _e583)) ^ _e113)));
                                        let _e681 = select(select(_e516.member.member_1[1], _e677, (_e677 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e671 == 1023u));
                                        let _e684 = ((_e540.member_1[0] >> bitcast<u32>(_e595)) & 1023u);
                                        let _e690 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e684) * _e603)) ^ _e113)));
                                        let _e694 = select(select(_e516.member.member_1[2], _e690, (_e690 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e684 == 1023u));
                                        let _e697 = ((_e540.member_1[1] >> bitcast<u32>(_e555)) & 1023u);
                                        let _e703 = (_e516.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e697) * _e563)) ^ _e113)));
                                        let _e707 = select(select(_e516.member.member_1[0], _e703, (_e703 < _e516.member.member_1[0])), _e516.member.member_1[0], (_e697 == 1023u));
                                        let _e710 = ((_e540.member_1[1] >> bitcast<u32>(_e575)) & 1023u);
                                        let _e716 = (_e516.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e710) * _e583)) ^ _e113)));
                                        let _e720 = select(select(_e516.member.member_1[1], _e716, (_e716 < _e516.member.member_1[1])), _e516.member.member_1[1], (_e710 == 1023u));
                                        let _e723 = ((_e540.member_1[1] >> bitcast<u32>(_e595)) & 1023u);
                                        let _e729 = (_e516.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e723) * _e603)) ^ _e113)));
                                        let _e733 = select(select(_e516.member.member_1[2], _e729, (_e729 < _e516.member.member_1[2])), _e516.member.member_1[2], (_e723 == 1023u));
                                        let _e738 = type_50(type_42(array<f32, 3>(_e573, _e593, _e613), array<f32, 3>(_e626, _e639, _e652)), _e540.member_2);
                                        let _e743 = type_50(type_42(array<f32, 3>(_e668, _e681, _e694), array<f32, 3>(_e707, _e720, _e733)), _e540.member_3);
                                        let _e750 = ((_e573 - _e313) * _e318);
                                        let _e751 = ((_e668 - _e313) * _e318);
                                        let _e752 = ((_e626 - _e314) * _e318);
                                        let _e753 = ((_e707 - _e314) * _e318);
                                        let _e758 = ((_e593 - _e351) * _e356);
                                        let _e759 = ((_e681 - _e351) * _e356);
                                        let _e760 = ((_e639 - _e352) * _e356);
                                        let _e761 = ((_e720 - _e352) * _e356);
                                        let _e766 = ((_e613 - _e389) * _e394);
                                        let _e767 = ((_e694 - _e389) * _e394);
                                        let _e768 = ((_e652 - _e390) * _e394);
                                        let _e769 = ((_e733 - _e390) * _e394);
                                        let _e771 = select(_e768, _e766, (_e766 < _e768));
                                        let _e773 = select(_e769, _e767, (_e767 < _e769));
                                        let _e775 = select(_e768, _e766, (_e766 > _e768));
                                        let _e777 = select(_e769, _e767, (_e767 > _e769));
                                        let _e779 = select(_e752, _e750, (_e750 < _e752));
                                        let _e781 = select(_e753, _e751, (_e751 < _e753));
                                        let _e783 = select(_e760, _e758, (_e758 < _e760));
                                        let _e785 = select(_e761, _e759, (_e759 < _e761));
                                        let _e787 = select(_e783, _e779, (_e779 > _e783));
                                        let _e789 = select(_e785, _e781, (_e781 > _e785));
                                        let _e791 = select(_e771, _e787, (_e787 > _e771));
                                        let _e793 = select(_e773, _e789, (_e789 > _e773));
                                        let _e795 = select(_e752, _e750, (_e750 > _e752));
                                        let _e797 = select(_e753, _e751, (_e751 > _e753));
                                        let _e799 = select(_e760, _e758, (_e758 > _e760));
                                        let _e801 = select(_e761, _e759, (_e759 > _e761));
                                        let _e803 = select(_e799, _e795, (_e795 < _e799));
                                        let _e805 = select(_e801, _e797, (_e797 < _e801));
                                        let _e810 = -(_e771);
                                        let _e811 = -(_e773);
                                        let _e818 = (select(_e775, _e803, (_e803 < _e775)) + (select(_e810, _e775, (_e775 > _e810)) * 0.0000019073523f));
                                        let _e819 = (select(_e777, _e805, (_e805 < _e777)) + (select(_e811, _e777, (_e777 > _e811)) * 0.0000019073523f));
                                        let _e821 = select(_e441, _e791, (_e791 > _e441));
                                        let _e823 = select(_e441, _e793, (_e793 > _e441));
                                        let _e828 = (_e821 <= select(_e476.member.member_1, _e818, (_e818 < _e476.member.member_1)));
                                        let _e829 = (_e823 <= select(_e476.member.member_1, _e819, (_e819 < _e476.member.member_1)));
                                        let _e830 = (_e821 <= _e823);
                                        if _e828 {
                                            if _e829 {
                                                if _e830 {
                                                    phi_2938_ = _e743;
                                                } else {
                                                    phi_2938_ = _e738;
                                                }
                                                let _e832 = phi_2938_;
                                                let _e840 = (_e520 % 128u);
                                                let _e841 = (_e840 < 128u);
                                                if _e841 {
                                                } else {
                                                    phi_3264_ = true;
                                                    break;
                                                }
                                                local_6[_e840] = _e832.member_1;
                                                if _e841 {
                                                } else {
                                                    phi_3264_ = true;
                                                    break;
                                                }
                                                local_5[_e840] = _e832.member.member[0];
                                                if _e841 {
                                                } else {
                                                    phi_3264_ = true;
                                                    break;
                                                }
                                                local_4[_e840] = _e832.member.member[1];
                                                if _e841 {
                                                } else {
                                                    phi_3264_ = true;
                                                    break;
                                                }
                                                local_3[_e840] = _e832.member.member[2];
                                                if _e841 {
                                                } else {
                                                    phi_3264_ = true;
                                                    break;
                                                }
                                                local_2[_e840] = _e832.member.member_1[0];
                                                if _e841 {
                                                } else {
                                                    phi_3264_ = true;
                                                    break;
                                                }
                                                local_1[_e840] = _e832.member.member_1[1];
                                                if _e841 {
                                                } else {
                                                    phi_3264_ = true;
                                                    break;
                                                }
                                                local[_e840] = _e832.member.member_1[2];
                                                if _e841 {
                                                } else {
                                                    phi_3264_ = true;
                                                    break;
                                                }
                                                local_7[_e840] = select(_e823, _e821, (_e821 > _e823));
                                                if _e830 {
                                                    phi_3015_ = _e738;
                                                } else {
                                                    phi_3015_ = _e743;
                                                }
                                                let _e858 = phi_3015_;
                                                phi_3016_ = _e858;
                                                phi_3017_ = (_e520 + 1u);
                                            } else {
                                                phi_3016_ = type_50();
                                                phi_3017_ = u32();
                                            }
                                            let _e860 = phi_3016_;
                                            let _e862 = phi_3017_;
                                            phi_3019_ = _e860;
                                            phi_3020_ = _e862;
                                            phi_3021_ = select(true, false, _e829);
                                        } else {
                                            phi_3019_ = type_50();
                                            phi_3020_ = u32();
                                            phi_3021_ = true;
                                        }
                                        let _e865 = phi_3019_;
                                        let _e867 = phi_3020_;
                                        let _e869 = phi_3021_;
                                        if _e869 {
                                            if _e828 {
                                                phi_3028_ = _e738;
                                            } else {
                                                phi_3028_ = _e743;
                                            }
                                            let _e871 = phi_3028_;
                                            phi_3033_ = _e871;
                                            phi_3034_ = select(_e829, true, _e828);
                                        } else {
                                            phi_3033_ = _e865;
                                            phi_3034_ = _e518;
                                        }
                                        let _e874 = phi_3033_;
                                        let _e876 = phi_3034_;
                                        phi_3268_ = _e474;
                                        phi_3036_ = type_33(_e476.member, (_e476.member_1 + 1u), _e476.member_2);
                                        phi_3037_ = _e874;
                                        phi_3038_ = _e876;
                                        phi_3039_ = select(_e867, _e520, _e869);
                                    }
                                    let _e1555 = phi_3268_;
                                    let _e1557 = phi_3036_;
                                    let _e1559 = phi_3037_;
                                    let _e1561 = phi_3038_;
                                    let _e1563 = phi_3039_;
                                    phi_3267_ = _e1555;
                                    phi_3040_ = _e1557;
                                    phi_3041_ = _e1559;
                                    phi_3042_ = (_e480 - 1u);
                                    phi_3043_ = _e1561;
                                    phi_3044_ = _e1563;
                                } else {
                                    phi_3267_ = _e474;
                                    phi_3040_ = _e476;
                                    phi_3041_ = _e516;
                                    phi_3042_ = _e480;
                                    phi_3043_ = _e518;
                                    phi_3044_ = _e520;
                                }
                                let _e1565 = phi_3267_;
                                let _e1567 = phi_3040_;
                                let _e1569 = phi_3041_;
                                let _e1571 = phi_3042_;
                                let _e1573 = phi_3043_;
                                let _e1575 = phi_3044_;
                                phi_3266_ = _e1565;
                                phi_3045_ = _e1567;
                                phi_3046_ = _e1569;
                                phi_3047_ = _e1571;
                                phi_3048_ = _e1573;
                                phi_3049_ = _e1575;
                            } else {
                                phi_3266_ = _e474;
                                phi_3045_ = type_33();
                                phi_3046_ = type_50();
                                phi_3047_ = u32();
                                phi_3048_ = bool();
                                phi_3049_ = u32();
                            }
                            let _e1577 = phi_3266_;
                            let _e1579 = phi_3045_;
                            let _e1581 = phi_3046_;
                            let _e1583 = phi_3047_;
                            let _e1585 = phi_3048_;
                            let _e1587 = phi_3049_;
                            phi_3265_ = _e1577;
                            phi_778_ = _e1579;
                            phi_781_ = _e1581;
                            phi_783_ = _e1583;
                            phi_785_ = _e1585;
                            phi_787_ = _e1587;
                            phi_3050_ = _e488;
                        } else {
                            phi_3265_ = _e474;
                            phi_778_ = type_33();
                            phi_781_ = type_50();
                            phi_783_ = u32();
                            phi_785_ = bool();
                            phi_787_ = u32();
                            phi_3050_ = false;
                        }
                        let _e1589 = phi_3265_;
                        let _e1591 = phi_778_;
                        let _e1593 = phi_781_;
                        let _e1595 = phi_783_;
                        let _e1597 = phi_785_;
                        let _e1599 = phi_787_;
                        let _e1601 = phi_3050_;
                        continue;
                        continuing {
                            phi_3110_ = _e1589;
                            phi_777_ = _e1591;
                            phi_780_ = _e1593;
                            phi_782_ = _e1595;
                            phi_784_ = _e1597;
                            phi_786_ = _e1599;
                            phi_3264_ = _e1589;
                            break if !(_e1601);
                        }
                    }
                    let _e1604 = phi_3264_;
                    if _e1604 {
                        break;
                    }
                    let _e1606 = local_10;
                    let _e1609 = local_11;
                    if _e129 {
                    } else {
                        break;
                    }
                    global_5.member[_e127][0u] = _e1606.member_1;
                    global_5.member[_e127][1u] = _e1609.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
