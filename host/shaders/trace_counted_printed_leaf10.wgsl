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
    var phi_333_: i32;
    var phi_334_: i32;
    var phi_344_: bool;
    var phi_354_: u32;
    var phi_355_: u32;
    var phi_357_: bool;
    var phi_362_: u32;
    var phi_374_: i32;
    var phi_394_: i32;
    var phi_412_: f32;
    var phi_418_: f32;
    var phi_429_: f32;
    var phi_435_: f32;
    var phi_458_: f32;
    var phi_469_: f32;
    var phi_478_: f32;
    var phi_484_: f32;
    var phi_495_: f32;
    var phi_501_: f32;
    var phi_524_: f32;
    var phi_535_: f32;
    var phi_544_: f32;
    var phi_550_: f32;
    var phi_561_: f32;
    var phi_567_: f32;
    var phi_590_: f32;
    var phi_601_: f32;
    var phi_701_: f32;
    var phi_702_: f32;
    var phi_3112_: bool;
    var phi_776_: type_33;
    var phi_779_: type_50;
    var phi_781_: u32;
    var phi_783_: bool;
    var phi_785_: u32;
    var phi_796_: bool;
    var phi_882_: type_50;
    var phi_883_: bool;
    var phi_884_: u32;
    var phi_2108_: type_37;
    var phi_2940_: type_50;
    var phi_3017_: type_50;
    var phi_3018_: type_50;
    var phi_3019_: u32;
    var phi_3021_: type_50;
    var phi_3022_: u32;
    var phi_3023_: bool;
    var phi_3030_: type_50;
    var phi_3035_: type_50;
    var phi_3036_: bool;
    var phi_903_: type_33;
    var phi_906_: type_4;
    var phi_907_: type_4;
    var phi_929_: type_4;
    var phi_957_: u32;
    var phi_973_: type_44;
    var phi_1349_: bool;
    var phi_1378_: bool;
    var phi_1755_: f32;
    var phi_1756_: f32;
    var phi_1757_: f32;
    var phi_1758_: f32;
    var phi_1759_: vec3<f32>;
    var phi_1760_: vec3<f32>;
    var phi_1761_: vec3<f32>;
    var phi_1762_: vec3<f32>;
    var phi_1793_: bool;
    var phi_1802_: vec3<f32>;
    var phi_1969_: bool;
    var phi_1993_: f32;
    var phi_1994_: f32;
    var phi_2017_: type_21;
    var phi_2019_: type_21;
    var phi_2020_: bool;
    var phi_2024_: type_21;
    var phi_2025_: type_21;
    var phi_2026_: type_21;
    var phi_2027_: bool;
    var phi_2031_: type_21;
    var phi_2032_: bool;
    var phi_2033_: type_21;
    var phi_2034_: bool;
    var phi_2035_: bool;
    var phi_2036_: type_21;
    var phi_2037_: bool;
    var phi_2038_: bool;
    var phi_2046_: type_21;
    var phi_2047_: bool;
    var phi_2051_: type_21;
    var phi_2076_: bool;
    var phi_2077_: bool;
    var phi_2084_: type_33;
    var phi_2085_: type_33;
    var phi_2086_: type_33;
    var phi_904_: type_33;
    var phi_3106_: bool;
    var phi_3270_: bool;
    var phi_3038_: type_33;
    var phi_3039_: type_50;
    var phi_3040_: bool;
    var phi_3041_: u32;
    var phi_3269_: bool;
    var phi_3042_: type_33;
    var phi_3043_: type_50;
    var phi_3044_: u32;
    var phi_3045_: bool;
    var phi_3046_: u32;
    var phi_3268_: bool;
    var phi_3047_: type_33;
    var phi_3048_: type_50;
    var phi_3049_: u32;
    var phi_3050_: bool;
    var phi_3051_: u32;
    var phi_3267_: bool;
    var phi_777_: type_33;
    var phi_780_: type_50;
    var phi_782_: u32;
    var phi_784_: bool;
    var phi_786_: u32;
    var phi_3052_: bool;
    var phi_3266_: bool;
    var local_10: type_33;
    var local_11: type_33;
    var local_12: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e74 = global;
            let _e77 = arrayLength((&global_4.member));
            let _e88 = global_2.member[0u][0u];
            let _e92 = global_2.member[0u][1u];
            let _e96 = global_2.member[0u][2u];
            let _e100 = global_2.member[1u][0u];
            let _e104 = global_2.member[1u][1u];
            let _e108 = global_2.member[1u][2u];
            let _e112 = global_2.member[1u][3u];
            let _e115 = global_1.member[0u];
            let _e116 = bitcast<i32>(_e115);
            let _e126 = (_e74.x + (_e74.y * 2097152u));
            let _e127 = (_e126 < arrayLength((&global_3.member)));
            if _e127 {
                let _e128 = (_e126 < arrayLength((&global_5.member)));
                if _e128 {
                    if _e127 {
                    } else {
                        break;
                    }
                    let _e136 = global_3.member[_e126].member_2[0u];
                    let _e138 = (bitcast<u32>(_e136) & 2147483647u);
                    let _e143 = global_3.member[_e126].member_2[1u];
                    let _e145 = (bitcast<u32>(_e143) & 2147483647u);
                    let _e150 = global_3.member[_e126].member_2[2u];
                    let _e152 = (bitcast<u32>(_e150) & 2147483647u);
                    let _e157 = global_3.member[_e126].member[0u];
                    let _e159 = (bitcast<u32>(_e157) & 2147483647u);
                    let _e164 = global_3.member[_e126].member[1u];
                    let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                    let _e171 = global_3.member[_e126].member[2u];
                    let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                    let _e175 = select(_e145, _e138, (_e145 < _e138));
                    let _e177 = select(_e152, _e175, (_e152 < _e175));
                    let _e179 = select(_e159, _e177, (_e159 < _e177));
                    let _e181 = select(_e166, _e179, (_e166 < _e179));
                    let _e183 = select(_e173, _e181, (_e173 < _e181));
                    let _e187 = global_3.member[_e126].member_1;
                    let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                    let _e196 = global_3.member[_e126].member_3;
                    let _e202 = (((select(_e189, _e183, (_e189 < _e183)) < 2139095040u) && ((bitcast<u32>(_e196) & 2147483647u) <= 2139095040u)) && (_e177 > 0u));
                    if _e202 {
                        let _e205 = (bitcast<u32>(bitcast<f32>(_e177)) & 2147483647u);
                        if (_e205 >= 8388608u) {
                            phi_333_ = (bitcast<i32>((_e205 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_333_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e205)), 32u, (_e205 == 0u))));
                        }
                        let _e219 = phi_333_;
                        phi_334_ = _e219;
                    } else {
                        phi_334_ = 0i;
                    }
                    let _e221 = phi_334_;
                    let _e222 = (_e138 == _e177);
                    if _e222 {
                        phi_344_ = true;
                    } else {
                        phi_344_ = (_e145 == _e177);
                    }
                    let _e225 = phi_344_;
                    let _e226 = select(1u, 0u, _e222);
                    if _e225 {
                        let _e227 = (_e226 + 1u);
                        phi_354_ = _e227;
                        phi_355_ = _e227;
                        phi_357_ = select(true, false, (_e227 == 2u));
                    } else {
                        phi_354_ = u32();
                        phi_355_ = 0u;
                        phi_357_ = true;
                    }
                    let _e231 = phi_354_;
                    let _e233 = phi_355_;
                    let _e235 = phi_357_;
                    if _e235 {
                        phi_362_ = (_e233 + 1u);
                    } else {
                        phi_362_ = 0u;
                    }
                    let _e239 = phi_362_;
                    let _e240 = select(_e231, _e233, _e235);
                    let _e241 = select(_e226, select(2u, _e226, _e225), _e235);
                    if (_e116 < -126i) {
                        phi_374_ = -126i;
                    } else {
                        phi_374_ = select(_e116, 127i, (_e116 > 127i));
                    }
                    let _e246 = phi_374_;
                    let _e251 = bitcast<f32>((bitcast<u32>((_e246 + 127i)) << bitcast<u32>(23i)));
                    let _e257 = bitcast<f32>((bitcast<u32>(((_e116 - _e246) + 127i)) << bitcast<u32>(23i)));
                    let _e258 = -(_e221);
                    if (_e258 < -126i) {
                        phi_394_ = -126i;
                    } else {
                        phi_394_ = select(_e258, 127i, (_e258 > 127i));
                    }
                    let _e263 = phi_394_;
                    let _e268 = bitcast<f32>((bitcast<u32>((_e263 + 127i)) << bitcast<u32>(23i)));
                    let _e274 = bitcast<f32>((bitcast<u32>(((_e258 - _e263) + 127i)) << bitcast<u32>(23i)));
                    let _e278 = global_3.member[_e126].member;
                    let _e279 = (_e240 == 0u);
                    if _e279 {
                        phi_412_ = _e278[0];
                    } else {
                        phi_412_ = _e278[1];
                    }
                    let _e283 = phi_412_;
                    let _e284 = (_e240 == 2u);
                    if _e284 {
                        phi_418_ = _e278[2];
                    } else {
                        phi_418_ = _e283;
                    }
                    let _e287 = phi_418_;
                    let _e289 = ((_e287 * _e251) * _e257);
                    let _e290 = global_3.member[_e126].member_2;
                    if _e279 {
                        phi_429_ = _e290[0];
                    } else {
                        phi_429_ = _e290[1];
                    }
                    let _e294 = phi_429_;
                    if _e284 {
                        phi_435_ = _e290[2];
                    } else {
                        phi_435_ = _e294;
                    }
                    let _e297 = phi_435_;
                    let _e299 = ((_e297 * _e268) * _e274);
                    let _e303 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e303 {
                        let _e307 = (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) * 0.00000011920929f);
                        phi_458_ = select(0.00000000000011368684f, _e307, (_e307 > 0.00000000000011368684f));
                    } else {
                        phi_458_ = 0f;
                    }
                    let _e311 = phi_458_;
                    let _e312 = (_e289 + _e311);
                    let _e313 = (_e289 - _e311);
                    let _e314 = select(_e299, 0f, _e303);
                    if _e303 {
                        phi_469_ = 38685626000000000000000000f;
                    } else {
                        phi_469_ = (1f / _e299);
                    }
                    let _e317 = phi_469_;
                    let _e318 = (_e239 == 0u);
                    if _e318 {
                        phi_478_ = _e278[0];
                    } else {
                        phi_478_ = _e278[1];
                    }
                    let _e322 = phi_478_;
                    let _e323 = (_e239 == 2u);
                    if _e323 {
                        phi_484_ = _e278[2];
                    } else {
                        phi_484_ = _e322;
                    }
                    let _e326 = phi_484_;
                    let _e328 = ((_e326 * _e251) * _e257);
                    if _e318 {
                        phi_495_ = _e290[0];
                    } else {
                        phi_495_ = _e290[1];
                    }
                    let _e332 = phi_495_;
                    if _e323 {
                        phi_501_ = _e290[2];
                    } else {
                        phi_501_ = _e332;
                    }
                    let _e335 = phi_501_;
                    let _e337 = ((_e335 * _e268) * _e274);
                    let _e341 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e341 {
                        let _e345 = (bitcast<f32>((bitcast<u32>(_e328) & 2147483647u)) * 0.00000011920929f);
                        phi_524_ = select(0.00000000000011368684f, _e345, (_e345 > 0.00000000000011368684f));
                    } else {
                        phi_524_ = 0f;
                    }
                    let _e349 = phi_524_;
                    let _e350 = (_e328 + _e349);
                    let _e351 = (_e328 - _e349);
                    let _e352 = select(_e337, 0f, _e341);
                    if _e341 {
                        phi_535_ = 38685626000000000000000000f;
                    } else {
                        phi_535_ = (1f / _e337);
                    }
                    let _e355 = phi_535_;
                    let _e356 = (_e241 == 0u);
                    if _e356 {
                        phi_544_ = _e278[0];
                    } else {
                        phi_544_ = _e278[1];
                    }
                    let _e360 = phi_544_;
                    let _e361 = (_e241 == 2u);
                    if _e361 {
                        phi_550_ = _e278[2];
                    } else {
                        phi_550_ = _e360;
                    }
                    let _e364 = phi_550_;
                    let _e366 = ((_e364 * _e251) * _e257);
                    if _e356 {
                        phi_561_ = _e290[0];
                    } else {
                        phi_561_ = _e290[1];
                    }
                    let _e370 = phi_561_;
                    if _e361 {
                        phi_567_ = _e290[2];
                    } else {
                        phi_567_ = _e370;
                    }
                    let _e373 = phi_567_;
                    let _e375 = ((_e373 * _e268) * _e274);
                    let _e379 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e379 {
                        let _e383 = (bitcast<f32>((bitcast<u32>(_e366) & 2147483647u)) * 0.00000011920929f);
                        phi_590_ = select(0.00000000000011368684f, _e383, (_e383 > 0.00000000000011368684f));
                    } else {
                        phi_590_ = 0f;
                    }
                    let _e387 = phi_590_;
                    let _e388 = (_e366 + _e387);
                    let _e389 = (_e366 - _e387);
                    let _e390 = select(_e375, 0f, _e379);
                    if _e379 {
                        phi_601_ = 38685626000000000000000000f;
                    } else {
                        phi_601_ = (1f / _e375);
                    }
                    let _e393 = phi_601_;
                    let _e396 = bitcast<f32>((bitcast<u32>(_e289) & 2147483647u));
                    let _e399 = bitcast<f32>((bitcast<u32>(_e328) & 2147483647u));
                    let _e401 = select(_e399, _e396, (_e396 > _e399));
                    let _e404 = bitcast<f32>((bitcast<u32>(_e366) & 2147483647u));
                    let _e407 = (_e116 + _e221);
                    if (_e202 && (select(_e404, _e401, (_e401 > _e404)) <= 1099511600000f)) {
                        let _e410 = (_e407 / 3i);
                        let _e417 = bitcast<f32>((bitcast<u32>((_e410 + 127i)) << bitcast<u32>(23i)));
                        let _e424 = bitcast<f32>((bitcast<u32>(((_e407 - (2i * _e410)) + 127i)) << bitcast<u32>(23i)));
                        let _e425 = (((_e187 * _e417) * _e417) * _e424);
                        let _e427 = select(340282350000000000000000000000000000000f, _e425, (_e425 < 340282350000000000000000000000000000000f));
                        let _e432 = (((_e196 * _e417) * _e417) * _e424);
                        let _e434 = select(340282350000000000000000000000000000000f, _e432, (_e432 < 340282350000000000000000000000000000000f));
                        phi_701_ = select(-340282350000000000000000000000000000000f, _e434, (_e434 > -340282350000000000000000000000000000000f));
                        phi_702_ = select(-340282350000000000000000000000000000000f, _e427, (_e427 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_701_ = 0f;
                        phi_702_ = 1f;
                    }
                    let _e438 = phi_701_;
                    let _e440 = phi_702_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e88), bitcast<f32>(_e92), bitcast<f32>(_e96));
                    let _e446 = (_e240 % 3u);
                    let _e447 = (_e446 < 3u);
                    if _e447 {
                    } else {
                        break;
                    }
                    let _e449 = local_9[_e446];
                    let _e450 = (_e239 % 3u);
                    let _e451 = (_e450 < 3u);
                    if _e451 {
                    } else {
                        break;
                    }
                    let _e453 = local_9[_e450];
                    let _e454 = (_e241 % 3u);
                    let _e455 = (_e454 < 3u);
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e457 = local_9[_e454];
                    local_8 = array<f32, 3>(bitcast<f32>(_e100), bitcast<f32>(_e104), bitcast<f32>(_e108));
                    if _e447 {
                    } else {
                        break;
                    }
                    let _e461 = local_8[_e446];
                    if _e451 {
                    } else {
                        break;
                    }
                    let _e463 = local_8[_e450];
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e465 = local_8[_e454];
                    phi_3112_ = false;
                    phi_776_ = type_33(type_28(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e438), 0u, 0u);
                    phi_779_ = type_50(type_42(array<f32, 3>(_e449, _e453, _e457), array<f32, 3>(_e461, _e463, _e465)), select(0u, 2147483648u, (_e77 == 0u)));
                    phi_781_ = ((3u * _e77) + 1u);
                    phi_783_ = (_e440 <= _e438);
                    phi_785_ = 0u;
                    loop {
                        let _e473 = phi_3112_;
                        let _e475 = phi_776_;
                        let _e477 = phi_779_;
                        let _e479 = phi_781_;
                        let _e481 = phi_783_;
                        let _e483 = phi_785_;
                        local_10 = _e475;
                        local_11 = _e475;
                        if _e481 {
                            phi_796_ = true;
                        } else {
                            phi_796_ = (_e483 > 0u);
                        }
                        let _e486 = phi_796_;
                        if _e486 {
                            let _e487 = (_e479 > 0u);
                            if _e487 {
                                if _e481 {
                                    phi_882_ = _e477;
                                    phi_883_ = _e481;
                                    phi_884_ = _e483;
                                } else {
                                    let _e488 = (_e483 - 1u);
                                    let _e489 = (_e488 % 128u);
                                    let _e490 = (_e489 < 128u);
                                    if _e490 {
                                    } else {
                                        phi_3266_ = true;
                                        break;
                                    }
                                    let _e492 = local_6[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3266_ = true;
                                        break;
                                    }
                                    let _e494 = local_5[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3266_ = true;
                                        break;
                                    }
                                    let _e496 = local_4[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3266_ = true;
                                        break;
                                    }
                                    let _e498 = local_3[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3266_ = true;
                                        break;
                                    }
                                    let _e501 = local_2[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3266_ = true;
                                        break;
                                    }
                                    let _e503 = local_1[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3266_ = true;
                                        break;
                                    }
                                    let _e505 = local[_e489];
                                    if _e490 {
                                    } else {
                                        phi_3266_ = true;
                                        break;
                                    }
                                    let _e510 = local_7[_e489];
                                    phi_882_ = type_50(type_42(array<f32, 3>(_e494, _e496, _e498), array<f32, 3>(_e501, _e503, _e505)), _e492);
                                    phi_883_ = (_e510 <= _e475.member.member_1);
                                    phi_884_ = _e488;
                                }
                                let _e515 = phi_882_;
                                let _e517 = phi_883_;
                                let _e519 = phi_884_;
                                if _e517 {
                                    if ((_e515.member_1 & 2147483648u) != 0u) {
                                        phi_903_ = _e475;
                                        phi_906_ = type_4(0u, ((_e515.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e879 = phi_903_;
                                            let _e881 = phi_906_;
                                            local_12 = _e879;
                                            if (_e881.member < _e881.member_1) {
                                                phi_907_ = type_4((_e881.member + 1u), _e881.member_1);
                                                phi_929_ = type_4(1u, _e881.member);
                                            } else {
                                                phi_907_ = _e881;
                                                phi_929_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e894 = phi_907_;
                                            let _e896 = phi_929_;
                                            let _e900 = (bitcast<i32>(_e896.member) != 0i);
                                            if _e900 {
                                                let _e906 = type_33(_e879.member, _e879.member_1, (_e879.member_2 + 1u));
                                                let _e907 = ((_e515.member_1 & 268435455u) + _e896.member_1);
                                                let _e908 = (_e907 < arrayLength((&global_6.member)));
                                                if _e908 {
                                                    if _e908 {
                                                    } else {
                                                        phi_3106_ = true;
                                                        break;
                                                    }
                                                    let _e911 = global_6.member[_e907].member_1;
                                                    phi_957_ = _e911;
                                                } else {
                                                    phi_957_ = 4294967295u;
                                                }
                                                let _e913 = phi_957_;
                                                if _e908 {
                                                    if _e908 {
                                                    } else {
                                                        phi_3106_ = true;
                                                        break;
                                                    }
                                                    let _e915 = global_6.member[_e907];
                                                    phi_973_ = _e915;
                                                } else {
                                                    phi_973_ = type_44(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e917 = phi_973_;
                                                let _e929 = ((10u * _e240) & 31u);
                                                let _e932 = ((_e917.member[0] >> bitcast<u32>(_e929)) & 1023u);
                                                let _e937 = bitcast<f32>((bitcast<u32>(((_e515.member.member_1[0] - _e515.member.member[0]) * 0.0009775171f)) ^ _e112));
                                                let _e943 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e932) * _e937)) ^ _e112)));
                                                let _e947 = select(select(_e515.member.member_1[0], _e943, (_e943 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e932 == 1023u));
                                                let _e949 = ((10u * _e239) & 31u);
                                                let _e952 = ((_e917.member[0] >> bitcast<u32>(_e949)) & 1023u);
                                                let _e957 = bitcast<f32>((bitcast<u32>(((_e515.member.member_1[1] - _e515.member.member[1]) * 0.0009775171f)) ^ _e112));
                                                let _e963 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e952) * _e957)) ^ _e112)));
                                                let _e967 = select(select(_e515.member.member_1[1], _e963, (_e963 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e952 == 1023u));
                                                let _e969 = ((10u * _e241) & 31u);
                                                let _e972 = ((_e917.member[0] >> bitcast<u32>(_e969)) & 1023u);
                                                let _e977 = bitcast<f32>((bitcast<u32>(((_e515.member.member_1[2] - _e515.member.member[2]) * 0.0009775171f)) ^ _e112));
                                                let _e983 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e972) * _e977)) ^ _e112)));
                                                let _e987 = select(select(_e515.member.member_1[2], _e983, (_e983 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e972 == 1023u));
                                                let _e991 = ((_e917.member[1] >> bitcast<u32>(_e929)) & 1023u);
                                                let _e997 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e991) * _e937)) ^ _e112)));
                                                let _e1001 = select(select(_e515.member.member_1[0], _e997, (_e997 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e991 == 1023u));
                                                let _e1004 = ((_e917.member[1] >> bitcast<u32>(_e949)) & 1023u);
                                                let _e1010 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1004) * _e957)) ^ _e112)));
                                                let _e1014 = select(select(_e515.member.member_1[1], _e1010, (_e1010 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e1004 == 1023u));
                                                let _e1017 = ((_e917.member[1] >> bitcast<u32>(_e969)) & 1023u);
                                                let _e1023 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1017) * _e977)) ^ _e112)));
                                                let _e1027 = select(select(_e515.member.member_1[2], _e1023, (_e1023 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e1017 == 1023u));
                                                let _e1031 = ((_e917.member[2] >> bitcast<u32>(_e929)) & 1023u);
                                                let _e1037 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1031) * _e937)) ^ _e112)));
                                                let _e1041 = select(select(_e515.member.member_1[0], _e1037, (_e1037 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e1031 == 1023u));
                                                let _e1044 = ((_e917.member[2] >> bitcast<u32>(_e949)) & 1023u);
                                                let _e1050 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1044) * _e957)) ^ _e112)));
                                                let _e1054 = select(select(_e515.member.member_1[1], _e1050, (_e1050 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e1044 == 1023u));
                                                let _e1057 = ((_e917.member[2] >> bitcast<u32>(_e969)) & 1023u);
                                                let _e1063 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1057) * _e977)) ^ _e112)));
                                                let _e1067 = select(select(_e515.member.member_1[2], _e1063, (_e1063 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e1057 == 1023u));
                                                let _e1072 = (_e987 - _e366);
                                                let _e1075 = (((_e947 - _e289) * _e390) - (_e1072 * _e314));
                                                let _e1078 = (((_e967 - _e328) * _e390) - (_e1072 * _e352));
                                                let _e1081 = (_e1027 - _e366);
                                                let _e1084 = (((_e1001 - _e289) * _e390) - (_e1081 * _e314));
                                                let _e1087 = (((_e1014 - _e328) * _e390) - (_e1081 * _e352));
                                                let _e1090 = (_e1067 - _e366);
                                                let _e1093 = (((_e1041 - _e289) * _e390) - (_e1090 * _e314));
                                                let _e1096 = (((_e1054 - _e328) * _e390) - (_e1090 * _e352));
                                                let _e1097 = (_e1093 * _e1087);
                                                let _e1098 = (_e1096 * _e1084);
                                                let _e1099 = (_e1075 * _e1096);
                                                let _e1100 = (_e1078 * _e1093);
                                                let _e1101 = (_e1084 * _e1078);
                                                let _e1102 = (_e1087 * _e1075);
                                                let _e1107 = (((_e1097 >= _e1098) && (_e1099 >= _e1100)) && (_e1101 >= _e1102));
                                                if (_e1107 || (((_e1097 <= _e1098) && (_e1099 <= _e1100)) && (_e1101 <= _e1102))) {
                                                    let _e1114 = select(-1f, 1f, _e1107);
                                                    let _e1116 = ((_e1097 - _e1098) * _e1114);
                                                    let _e1118 = select(0f, _e1116, (_e1116 > 0f));
                                                    let _e1120 = ((_e1099 - _e1100) * _e1114);
                                                    let _e1122 = select(0f, _e1120, (_e1120 > 0f));
                                                    let _e1124 = ((_e1101 - _e1102) * _e1114);
                                                    let _e1126 = select(0f, _e1124, (_e1124 > 0f));
                                                    let _e1128 = ((_e1118 + _e1122) + _e1126);
                                                    if (_e1128 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2036_ = type_21();
                                                        phi_2037_ = true;
                                                        phi_2038_ = false;
                                                    } else {
                                                        let _e1131 = select(_e1084, _e1075, (_e1075 < _e1084));
                                                        if (select(_e1093, _e1131, (_e1131 < _e1093)) > 0f) {
                                                            phi_1349_ = true;
                                                        } else {
                                                            let _e1136 = select(_e1084, _e1075, (_e1075 > _e1084));
                                                            phi_1349_ = (select(_e1093, _e1136, (_e1136 > _e1093)) < 0f);
                                                        }
                                                        let _e1141 = phi_1349_;
                                                        if _e1141 {
                                                            phi_2033_ = type_21();
                                                            phi_2034_ = true;
                                                            phi_2035_ = false;
                                                        } else {
                                                            let _e1143 = select(_e1087, _e1078, (_e1078 < _e1087));
                                                            if (select(_e1096, _e1143, (_e1143 < _e1096)) > 0f) {
                                                                phi_1378_ = true;
                                                            } else {
                                                                let _e1148 = select(_e1087, _e1078, (_e1078 > _e1087));
                                                                phi_1378_ = (select(_e1096, _e1148, (_e1148 > _e1096)) < 0f);
                                                            }
                                                            let _e1153 = phi_1378_;
                                                            if _e1153 {
                                                                phi_2031_ = type_21();
                                                                phi_2032_ = false;
                                                            } else {
                                                                let _e1155 = select(_e1001, _e947, (_e947 < _e1001));
                                                                let _e1159 = select(_e1001, _e947, (_e947 > _e1001));
                                                                let _e1163 = select(_e1014, _e967, (_e967 < _e1014));
                                                                let _e1167 = select(_e1014, _e967, (_e967 > _e1014));
                                                                let _e1171 = select(_e1027, _e987, (_e987 < _e1027));
                                                                let _e1175 = select(_e1027, _e987, (_e987 > _e1027));
                                                                let _e1180 = ((select(_e1041, _e1155, (_e1155 < _e1041)) - _e312) * _e317);
                                                                let _e1181 = ((select(_e1041, _e1159, (_e1159 > _e1041)) - _e313) * _e317);
                                                                let _e1184 = ((select(_e1054, _e1163, (_e1163 < _e1054)) - _e350) * _e355);
                                                                let _e1185 = ((select(_e1054, _e1167, (_e1167 > _e1054)) - _e351) * _e355);
                                                                let _e1188 = ((select(_e1067, _e1171, (_e1171 < _e1067)) - _e388) * _e393);
                                                                let _e1189 = ((select(_e1067, _e1175, (_e1175 > _e1067)) - _e389) * _e393);
                                                                let _e1191 = select(_e1189, _e1188, (_e1188 < _e1189));
                                                                let _e1193 = select(_e1189, _e1188, (_e1188 > _e1189));
                                                                let _e1195 = select(_e1181, _e1180, (_e1180 < _e1181));
                                                                let _e1197 = select(_e1185, _e1184, (_e1184 < _e1185));
                                                                let _e1199 = select(_e1197, _e1195, (_e1195 > _e1197));
                                                                let _e1201 = select(_e1191, _e1199, (_e1199 > _e1191));
                                                                let _e1203 = select(_e1181, _e1180, (_e1180 > _e1181));
                                                                let _e1205 = select(_e1185, _e1184, (_e1184 > _e1185));
                                                                let _e1207 = select(_e1205, _e1203, (_e1203 < _e1205));
                                                                let _e1209 = select(_e1193, _e1207, (_e1207 < _e1193));
                                                                let _e1210 = -(_e1191);
                                                                let _e1216 = select(_e440, _e1201, (_e1201 > _e440));
                                                                if (_e1216 > (_e1209 + (select(_e1210, _e1193, (_e1193 > _e1210)) * 0.0000019073523f))) {
                                                                    phi_2026_ = type_21();
                                                                    phi_2027_ = true;
                                                                } else {
                                                                    let _e1218 = (_e1216 > _e879.member.member_1);
                                                                    if _e1218 {
                                                                        phi_2025_ = type_21();
                                                                    } else {
                                                                        let _e1219 = vec3<f32>(_e947, _e967, _e987);
                                                                        let _e1220 = vec3<f32>(_e1001, _e1014, _e1027);
                                                                        let _e1221 = vec3<f32>(_e1041, _e1054, _e1067);
                                                                        let _e1222 = (_e1001 - _e947);
                                                                        let _e1223 = (_e1014 - _e967);
                                                                        let _e1224 = (_e1027 - _e987);
                                                                        let _e1225 = vec3<f32>(_e1222, _e1223, _e1224);
                                                                        let _e1226 = (_e1041 - _e1001);
                                                                        let _e1227 = (_e1054 - _e1014);
                                                                        let _e1228 = (_e1067 - _e1027);
                                                                        let _e1229 = vec3<f32>(_e1226, _e1227, _e1228);
                                                                        let _e1230 = (_e947 - _e1041);
                                                                        let _e1231 = (_e967 - _e1054);
                                                                        let _e1232 = (_e987 - _e1067);
                                                                        let _e1233 = vec3<f32>(_e1230, _e1231, _e1232);
                                                                        let _e1236 = bitcast<f32>((bitcast<u32>(_e1222) & 2147483647u));
                                                                        let _e1239 = bitcast<f32>((bitcast<u32>(_e1223) & 2147483647u));
                                                                        let _e1241 = select(_e1239, _e1236, (_e1236 > _e1239));
                                                                        let _e1244 = bitcast<f32>((bitcast<u32>(_e1224) & 2147483647u));
                                                                        let _e1246 = select(_e1244, _e1241, (_e1241 > _e1244));
                                                                        let _e1249 = bitcast<f32>((bitcast<u32>(_e1226) & 2147483647u));
                                                                        let _e1252 = bitcast<f32>((bitcast<u32>(_e1227) & 2147483647u));
                                                                        let _e1254 = select(_e1252, _e1249, (_e1249 > _e1252));
                                                                        let _e1257 = bitcast<f32>((bitcast<u32>(_e1228) & 2147483647u));
                                                                        let _e1259 = select(_e1257, _e1254, (_e1254 > _e1257));
                                                                        let _e1262 = bitcast<f32>((bitcast<u32>(_e1230) & 2147483647u));
                                                                        let _e1265 = bitcast<f32>((bitcast<u32>(_e1231) & 2147483647u));
                                                                        let _e1267 = select(_e1265, _e1262, (_e1262 > _e1265));
                                                                        let _e1270 = bitcast<f32>((bitcast<u32>(_e1232) & 2147483647u));
                                                                        let _e1272 = select(_e1270, _e1267, (_e1267 > _e1270));
                                                                        let _e1274 = select(_e1259, _e1246, (_e1246 > _e1259));
                                                                        let _e1276 = select(_e1272, _e1274, (_e1274 > _e1272));
                                                                        if (_e1246 == _e1276) {
                                                                            phi_1755_ = _e1087;
                                                                            phi_1756_ = _e1084;
                                                                            phi_1757_ = _e1078;
                                                                            phi_1758_ = _e1075;
                                                                            phi_1759_ = _e1219;
                                                                            phi_1760_ = _e1233;
                                                                            phi_1761_ = _e1229;
                                                                            phi_1762_ = _e1225;
                                                                        } else {
                                                                            let _e1278 = (_e1259 == _e1276);
                                                                            let _e1283 = vec3(_e1278);
                                                                            phi_1755_ = select(_e1078, _e1096, _e1278);
                                                                            phi_1756_ = select(_e1075, _e1093, _e1278);
                                                                            phi_1757_ = select(_e1096, _e1087, _e1278);
                                                                            phi_1758_ = select(_e1093, _e1084, _e1278);
                                                                            phi_1759_ = select(_e1221, _e1220, _e1283);
                                                                            phi_1760_ = select(_e1229, _e1225, _e1283);
                                                                            phi_1761_ = select(_e1225, _e1233, _e1283);
                                                                            phi_1762_ = select(_e1233, _e1229, _e1283);
                                                                        }
                                                                        let _e1289 = phi_1755_;
                                                                        let _e1291 = phi_1756_;
                                                                        let _e1293 = phi_1757_;
                                                                        let _e1295 = phi_1758_;
                                                                        let _e1297 = phi_1759_;
                                                                        let _e1299 = phi_1760_;
                                                                        let _e1301 = phi_1761_;
                                                                        let _e1303 = phi_1762_;
                                                                        let _e1310 = ((_e1301.y * _e1299.z) - (_e1299.y * _e1301.z));
                                                                        let _e1315 = ((_e1301.z * _e1299.x) - (_e1299.z * _e1301.x));
                                                                        let _e1318 = ((_e1301.x * _e1299.y) - (_e1299.x * _e1301.y));
                                                                        if (_e1118 >= _e1122) {
                                                                            phi_1793_ = select(true, false, (_e1118 >= _e1126));
                                                                        } else {
                                                                            phi_1793_ = true;
                                                                        }
                                                                        let _e1323 = phi_1793_;
                                                                        if _e1323 {
                                                                            phi_1802_ = select(_e1221, _e1220, vec3((_e1122 >= _e1126)));
                                                                        } else {
                                                                            phi_1802_ = _e1219;
                                                                        }
                                                                        let _e1328 = phi_1802_;
                                                                        let _e1333 = (((_e1310 * _e314) + (_e1315 * _e352)) + (_e1318 * _e390));
                                                                        let _e1344 = (((_e1310 * (_e1328.x - _e289)) + (_e1315 * (_e1328.y - _e328))) + (_e1318 * (_e1328.z - _e366)));
                                                                        let _e1346 = (_e1291 - _e1295);
                                                                        let _e1347 = (_e1289 - _e1293);
                                                                        let _e1355 = (-(((_e1295 * _e1346) + (_e1293 * _e1347))) / ((_e1346 * _e1346) + (_e1347 * _e1347)));
                                                                        let _e1357 = select(1f, _e1355, (_e1355 < 1f));
                                                                        let _e1359 = select(0f, _e1357, (_e1357 > 0f));
                                                                        let _e1372 = ((_e1297.x + (_e1303.x * _e1359)) - _e289);
                                                                        let _e1373 = ((_e1297.y + (_e1303.y * _e1359)) - _e328);
                                                                        let _e1374 = ((_e1297.z + (_e1303.z * _e1359)) - _e366);
                                                                        let _e1375 = (_e1374 / _e390);
                                                                        let _e1387 = bitcast<f32>((bitcast<u32>(_e1372) & 2147483647u));
                                                                        let _e1390 = bitcast<f32>((bitcast<u32>(_e1373) & 2147483647u));
                                                                        let _e1392 = select(_e1390, _e1387, (_e1387 > _e1390));
                                                                        let _e1395 = bitcast<f32>((bitcast<u32>(_e1374) & 2147483647u));
                                                                        let _e1397 = select(_e1395, _e1392, (_e1392 > _e1395));
                                                                        let _e1403 = bitcast<f32>((bitcast<u32>(_e1310) & 2147483647u));
                                                                        let _e1406 = bitcast<f32>((bitcast<u32>(_e1315) & 2147483647u));
                                                                        let _e1408 = select(_e1406, _e1403, (_e1403 > _e1406));
                                                                        let _e1411 = bitcast<f32>((bitcast<u32>(_e1318) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1310 * _e1372) + (_e1315 * _e1373)) + (_e1318 * _e1374)) - _e1344)) & 2147483647u)) <= ((0.0000009536743f * select(_e1276, _e1397, (_e1397 > _e1276))) * select(_e1411, _e1408, (_e1408 > _e1411)))) {
                                                                            let _e1421 = bitcast<f32>((bitcast<u32>(_e1301.x) & 2147483647u));
                                                                            let _e1424 = bitcast<f32>((bitcast<u32>(_e1301.y) & 2147483647u));
                                                                            let _e1426 = select(_e1424, _e1421, (_e1421 > _e1424));
                                                                            let _e1429 = bitcast<f32>((bitcast<u32>(_e1301.z) & 2147483647u));
                                                                            let _e1435 = bitcast<f32>((bitcast<u32>(_e1299.x) & 2147483647u));
                                                                            let _e1438 = bitcast<f32>((bitcast<u32>(_e1299.y) & 2147483647u));
                                                                            let _e1440 = select(_e1438, _e1435, (_e1435 > _e1438));
                                                                            let _e1443 = bitcast<f32>((bitcast<u32>(_e1299.z) & 2147483647u));
                                                                            phi_1969_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1333) & 2147483647u)) > ((0.0000038146973f * select(_e1429, _e1426, (_e1426 > _e1429))) * select(_e1443, _e1440, (_e1440 > _e1443)))));
                                                                        } else {
                                                                            phi_1969_ = true;
                                                                        }
                                                                        let _e1450 = phi_1969_;
                                                                        if _e1450 {
                                                                            let _e1461 = ((((_e1310 * (_e1372 - (_e314 * _e1375))) + (_e1315 * (_e1373 - (_e352 * _e1375)))) + (_e1318 * (_e1374 - _e1374))) / _e1333);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1461) & 2147483647u)) <= _e1276) {
                                                                                phi_1993_ = (_e1375 + _e1461);
                                                                            } else {
                                                                                phi_1993_ = _e1375;
                                                                            }
                                                                            let _e1468 = phi_1993_;
                                                                            phi_1994_ = _e1468;
                                                                        } else {
                                                                            phi_1994_ = (_e1344 / _e1333);
                                                                        }
                                                                        let _e1470 = phi_1994_;
                                                                        let _e1472 = select(_e1209, _e1470, (_e1470 < _e1209));
                                                                        let _e1474 = select(_e1201, _e1472, (_e1472 > _e1201));
                                                                        if (_e1474 >= _e440) {
                                                                            let _e1476 = (_e1474 <= _e879.member.member_1);
                                                                            if _e1476 {
                                                                                let _e1477 = (1f / _e1128);
                                                                                phi_2017_ = type_21(_e1474, (_e1122 * _e1477), (_e1126 * _e1477), _e913);
                                                                            } else {
                                                                                phi_2017_ = type_21();
                                                                            }
                                                                            let _e1482 = phi_2017_;
                                                                            phi_2019_ = _e1482;
                                                                            phi_2020_ = select(true, false, _e1476);
                                                                        } else {
                                                                            phi_2019_ = type_21();
                                                                            phi_2020_ = true;
                                                                        }
                                                                        let _e1485 = phi_2019_;
                                                                        let _e1487 = phi_2020_;
                                                                        if _e1487 {
                                                                            phi_2024_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2024_ = _e1485;
                                                                        }
                                                                        let _e1489 = phi_2024_;
                                                                        phi_2025_ = _e1489;
                                                                    }
                                                                    let _e1491 = phi_2025_;
                                                                    phi_2026_ = _e1491;
                                                                    phi_2027_ = _e1218;
                                                                }
                                                                let _e1493 = phi_2026_;
                                                                let _e1495 = phi_2027_;
                                                                phi_2031_ = _e1493;
                                                                phi_2032_ = _e1495;
                                                            }
                                                            let _e1497 = phi_2031_;
                                                            let _e1499 = phi_2032_;
                                                            phi_2033_ = _e1497;
                                                            phi_2034_ = _e1153;
                                                            phi_2035_ = _e1499;
                                                        }
                                                        let _e1501 = phi_2033_;
                                                        let _e1503 = phi_2034_;
                                                        let _e1505 = phi_2035_;
                                                        phi_2036_ = _e1501;
                                                        phi_2037_ = _e1503;
                                                        phi_2038_ = _e1505;
                                                    }
                                                    let _e1507 = phi_2036_;
                                                    let _e1509 = phi_2037_;
                                                    let _e1511 = phi_2038_;
                                                    phi_2046_ = _e1507;
                                                    phi_2047_ = select(_e1511, true, _e1509);
                                                } else {
                                                    phi_2046_ = type_21();
                                                    phi_2047_ = true;
                                                }
                                                let _e1514 = phi_2046_;
                                                let _e1516 = phi_2047_;
                                                if _e1516 {
                                                    phi_2051_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2051_ = _e1514;
                                                }
                                                let _e1518 = phi_2051_;
                                                if (_e1518.member_3 != 4294967295u) {
                                                    if (_e913 != 4294967295u) {
                                                        if (_e1518.member < _e879.member.member.member) {
                                                            phi_2077_ = true;
                                                        } else {
                                                            if (_e1518.member == _e879.member.member.member) {
                                                                phi_2076_ = (_e1518.member_3 < _e879.member.member.member_3);
                                                            } else {
                                                                phi_2076_ = false;
                                                            }
                                                            let _e1533 = phi_2076_;
                                                            phi_2077_ = _e1533;
                                                        }
                                                        let _e1535 = phi_2077_;
                                                        if _e1535 {
                                                            phi_2084_ = type_33(type_28(_e1518, _e1518.member), _e906.member_1, _e906.member_2);
                                                        } else {
                                                            phi_2084_ = _e906;
                                                        }
                                                        let _e1542 = phi_2084_;
                                                        phi_2085_ = _e1542;
                                                    } else {
                                                        phi_2085_ = _e906;
                                                    }
                                                    let _e1544 = phi_2085_;
                                                    phi_2086_ = _e1544;
                                                } else {
                                                    phi_2086_ = _e906;
                                                }
                                                let _e1546 = phi_2086_;
                                                phi_904_ = _e1546;
                                            } else {
                                                phi_904_ = type_33();
                                            }
                                            let _e1548 = phi_904_;
                                            continue;
                                            continuing {
                                                phi_903_ = _e1548;
                                                phi_906_ = _e894;
                                                phi_3106_ = _e473;
                                                break if !(_e900);
                                            }
                                        }
                                        let _e1551 = phi_3106_;
                                        phi_3266_ = _e1551;
                                        if _e1551 {
                                            break;
                                        }
                                        phi_3270_ = _e1551;
                                        let _e1714 = local_12;
                                        phi_3038_ = _e1714;
                                        phi_3039_ = _e515;
                                        phi_3040_ = false;
                                        phi_3041_ = _e519;
                                    } else {
                                        let _e535 = (_e515.member_1 < _e77);
                                        if _e535 {
                                            if _e535 {
                                            } else {
                                                phi_3266_ = true;
                                                break;
                                            }
                                            let _e537 = global_4.member[_e515.member_1];
                                            phi_2108_ = _e537;
                                        } else {
                                            phi_2108_ = type_37(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e539 = phi_2108_;
                                        let _e554 = ((10u * _e240) & 31u);
                                        let _e557 = ((_e539.member[0] >> bitcast<u32>(_e554)) & 1023u);
                                        let _e562 = bitcast<f32>((bitcast<u32>(((_e515.member.member_1[0] - _e515.member.member[0]) * 0.0009775171f)) ^ _e112));
                                        let _e568 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e557) * _e562)) ^ _e112)));
                                        let _e572 = select(select(_e515.member.member_1[0], _e568, (_e568 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e557 == 1023u));
                                        let _e574 = ((10u * _e239) & 31u);
                                        let _e577 = ((_e539.member[0] >> bitcast<u32>(_e574)) & 1023u);
                                        let _e582 = bitcast<f32>((bitcast<u32>(((_e515.member.member_1[1] - _e515.member.member[1]) * 0.0009775171f)) ^ _e112));
                                        let _e588 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e577) * _e582)) ^ _e112)));
                                        let _e592 = select(select(_e515.member.member_1[1], _e588, (_e588 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e577 == 1023u));
                                        let _e594 = ((10u * _e241) & 31u);
                                        let _e597 = ((_e539.member[0] >> bitcast<u32>(_e594)) & 1023u);
                                        let _e602 = bitcast<f32>((bitcast<u32>(((_e515.member.member_1[2] - _e515.member.member[2]) * 0.0009775171f)) ^ _e112));
                                        let _e608 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e597) * _e602)) ^ _e112)));
                                        let _e612 = select(select(_e515.member.member_1[2], _e608, (_e608 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e597 == 1023u));
                                        let _e615 = ((_e539.member[1] >> bitcast<u32>(_e554)) & 1023u);
                                        let _e621 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e615) * _e562)) ^ _e112)));
                                        let _e625 = select(select(_e515.member.member_1[0], _e621, (_e621 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e615 == 1023u));
                                        let _e628 = ((_e539.member[1] >> bitcast<u32>(_e574)) & 1023u);
                                        let _e634 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e628) * _e582)) ^ _e112)));
                                        let _e638 = select(select(_e515.member.member_1[1], _e634, (_e634 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e628 == 1023u));
                                        let _e641 = ((_e539.member[1] >> bitcast<u32>(_e594)) & 1023u);
                                        let _e647 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e641) * _e602)) ^ _e112)));
                                        let _e651 = select(select(_e515.member.member_1[2], _e647, (_e647 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e641 == 1023u));
                                        let _e657 = ((_e539.member_1[0] >> bitcast<u32>(_e554)) & 1023u);
                                        let _e663 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e657) * _e562)) ^ _e112)));
                                        let _e667 = select(select(_e515.member.member_1[0], _e663, (_e663 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e657 == 1023u));
                                        let _e670 = ((_e539.member_1[0] >> bitcast<u32>(_e574)) & 1023u);
                                        let _e676 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e670) * _e582)) ^ _e112)));
                                        let _e680 = select(select(_e515.member.member_1[1], _e676, (_e676 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e670 == 1023u));
                                        let _e683 = ((_e539.member_1[0] >> bitcast<u32>(_e594)) & 1023u);
                                        let _e689 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e683) * _e602)) ^ _e112)));
                                        let _e693 = select(select(_e515.member.member_1[2], _e689, (_e689 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e683 == 1023u));
                                        let _e696 = ((_e539.member_1[1] >> bitcast<u32>(_e554)) & 1023u);
                                        let _e702 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e696) * _e562)) ^ _e112)));
                                        let _e706 = select(select(_e515.member.member_1[0], _e702, (_e702 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e696 == 1023u));
                                        let _e709 = ((_e539.member_1[1] >> bitcast<u32>(_e574)) & 1023u);
                                        let _e715 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e709) * _e582)) ^ _e112)));
                                        let _e719 = select(select(_e515.member.member_1[1], _e715, (_e715 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e709 == 1023u));
                                        let _e722 = ((_e539.member_1[1] >> bitcast<u32>(_e594)) & 1023u);
                                        let _e728 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e722) * _e602)) ^ _e112)));
                                        let _e732 = select(select(_e515.member.member_1[2], _e728, (_e728 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e722 == 1023u));
                                        let _e737 = type_50(type_42(array<f32, 3>(_e572, _e592, _e612), array<f32, 3>(_e625, _e638, _e651)), _e539.member_2);
                                        let _e742 = type_50(type_42(array<f32, 3>(_e667, _e680, _e693), array<f32, 3>(_e706, _e719, _e732)), _e539.member_3);
                                        let _e749 = ((_e572 - _e312) * _e317);
                                        let _e750 = ((_e667 - _e312) * _e317);
                                        let _e751 = ((_e625 - _e313) * _e317);
                                        let _e752 = ((_e706 - _e313) * _e317);
                                        let _e757 = ((_e592 - _e350) * _e355);
                                        let _e758 = ((_e680 - _e350) * _e355);
                                        let _e759 = ((_e638 - _e351) * _e355);
                                        let _e760 = ((_e719 - _e351) * _e355);
                                        let _e765 = ((_e612 - _e388) * _e393);
                                        let _e766 = ((_e693 - _e388) * _e393);
                                        let _e767 = ((_e651 - _e389) * _e393);
                                        let _e768 = ((_e732 - _e389) * _e393);
                                        let _e770 = select(_e767, _e765, (_e765 < _e767));
                                        let _e772 = select(_e768, _e766, (_e766 < _e768));
                                        let _e774 = select(_e767, _e765, (_e765 > _e767));
                                        let _e776 = select(_e768, _e766, (_e766 > _e768));
                                        let _e778 = select(_e751, _e749, (_e749 < _e751));
                                        let _e780 = select(_e752, _e750, (_e750 < _e752));
                                        let _e782 = select(_e759, _e757, (_e757 < _e759));
                                        let _e784 = select(_e760, _e758, (_e758 < _e760));
                                        let _e786 = select(_e782, _e778, (_e778 > _e782));
                                        let _e788 = select(_e784, _e780, (_e780 > _e784));
                                        let _e790 = select(_e770, _e786, (_e786 > _e770));
                                        let _e792 = select(_e772, _e788, (_e788 > _e772));
                                        let _e794 = select(_e751, _e749, (_e749 > _e751));
                                        let _e796 = select(_e752, _e750, (_e750 > _e752));
                                        let _e798 = select(_e759, _e757, (_e757 > _e759));
                                        let _e800 = select(_e760, _e758, (_e758 > _e760));
                                        let _e802 = select(_e798, _e794, (_e794 < _e798));
                                        let _e804 = select(_e800, _e796, (_e796 < _e800));
                                        let _e809 = -(_e770);
                                        let _e810 = -(_e772);
                                        let _e817 = (select(_e774, _e802, (_e802 < _e774)) + (select(_e809, _e774, (_e774 > _e809)) * 0.0000019073523f));
                                        let _e818 = (select(_e776, _e804, (_e804 < _e776)) + (select(_e810, _e776, (_e776 > _e810)) * 0.0000019073523f));
                                        let _e820 = select(_e440, _e790, (_e790 > _e440));
                                        let _e822 = select(_e440, _e792, (_e792 > _e440));
                                        let _e827 = (_e820 <= select(_e475.member.member_1, _e817, (_e817 < _e475.member.member_1)));
                                        let _e828 = (_e822 <= select(_e475.member.member_1, _e818, (_e818 < _e475.member.member_1)));
                                        let _e829 = (_e820 <= _e822);
                                        if _e827 {
                                            if _e828 {
                                                if _e829 {
                                                    phi_2940_ = _e742;
                                                } else {
                                                    phi_2940_ = _e737;
                                                }
                                                let _e831 = phi_2940_;
                                                let _e839 = (_e519 % 128u);
                                                let _e840 = (_e839 < 128u);
                                                if _e840 {
                                                } else {
                                                    phi_3266_ = true;
                                                    break;
                                                }
                                                local_6[_e839] = _e831.member_1;
                                                if _e840 {
                                                } else {
                                                    phi_3266_ = true;
                                                    break;
                                                }
                                                local_5[_e839] = _e831.member.member[0];
                                                if _e840 {
                                                } else {
                                                    phi_3266_ = true;
                                                    break;
                                                }
                                                local_4[_e839] = _e831.member.member[1];
                                                if _e840 {
                                                } else {
                                                    phi_3266_ = true;
                                                    break;
                                                }
                                                local_3[_e839] = _e831.member.member[2];
                                                if _e840 {
                                                } else {
                                                    phi_3266_ = true;
                                                    break;
                                                }
                                                local_2[_e839] = _e831.member.member_1[0];
                                                if _e840 {
                                                } else {
                                                    phi_3266_ = true;
                                                    break;
                                                }
                                                local_1[_e839] = _e831.member.member_1[1];
                                                if _e840 {
                                                } else {
                                                    phi_3266_ = true;
                                                    break;
                                                }
                                                local[_e839] = _e831.member.member_1[2];
                                                if _e840 {
                                                } else {
                                                    phi_3266_ = true;
                                                    break;
                                                }
                                                local_7[_e839] = select(_e822, _e820, (_e820 > _e822));
                                                if _e829 {
                                                    phi_3017_ = _e737;
                                                } else {
                                                    phi_3017_ = _e742;
                                                }
                                                let _e857 = phi_3017_;
                                                phi_3018_ = _e857;
                                                phi_3019_ = (_e519 + 1u);
                                            } else {
                                                phi_3018_ = type_50();
                                                phi_3019_ = u32();
                                            }
                                            let _e859 = phi_3018_;
                                            let _e861 = phi_3019_;
                                            phi_3021_ = _e859;
                                            phi_3022_ = _e861;
                                            phi_3023_ = select(true, false, _e828);
                                        } else {
                                            phi_3021_ = type_50();
                                            phi_3022_ = u32();
                                            phi_3023_ = true;
                                        }
                                        let _e864 = phi_3021_;
                                        let _e866 = phi_3022_;
                                        let _e868 = phi_3023_;
                                        if _e868 {
                                            if _e827 {
                                                phi_3030_ = _e737;
                                            } else {
                                                phi_3030_ = _e742;
                                            }
                                            let _e870 = phi_3030_;
                                            phi_3035_ = _e870;
                                            phi_3036_ = select(_e828, true, _e827);
                                        } else {
                                            phi_3035_ = _e864;
                                            phi_3036_ = _e517;
                                        }
                                        let _e873 = phi_3035_;
                                        let _e875 = phi_3036_;
                                        phi_3270_ = _e473;
                                        phi_3038_ = type_33(_e475.member, (_e475.member_1 + 1u), _e475.member_2);
                                        phi_3039_ = _e873;
                                        phi_3040_ = _e875;
                                        phi_3041_ = select(_e866, _e519, _e868);
                                    }
                                    let _e1553 = phi_3270_;
                                    let _e1555 = phi_3038_;
                                    let _e1557 = phi_3039_;
                                    let _e1559 = phi_3040_;
                                    let _e1561 = phi_3041_;
                                    phi_3269_ = _e1553;
                                    phi_3042_ = _e1555;
                                    phi_3043_ = _e1557;
                                    phi_3044_ = (_e479 - 1u);
                                    phi_3045_ = _e1559;
                                    phi_3046_ = _e1561;
                                } else {
                                    phi_3269_ = _e473;
                                    phi_3042_ = _e475;
                                    phi_3043_ = _e515;
                                    phi_3044_ = _e479;
                                    phi_3045_ = _e517;
                                    phi_3046_ = _e519;
                                }
                                let _e1563 = phi_3269_;
                                let _e1565 = phi_3042_;
                                let _e1567 = phi_3043_;
                                let _e1569 = phi_3044_;
                                let _e1571 = phi_3045_;
                                let _e1573 = phi_3046_;
                                phi_3268_ = _e1563;
                                phi_3047_ = _e1565;
                                phi_3048_ = _e1567;
                                phi_3049_ = _e1569;
                                phi_3050_ = _e1571;
                                phi_3051_ = _e1573;
                            } else {
                                phi_3268_ = _e473;
                                phi_3047_ = type_33();
                                phi_3048_ = type_50();
                                phi_3049_ = u32();
                                phi_3050_ = bool();
                                phi_3051_ = u32();
                            }
                            let _e1575 = phi_3268_;
                            let _e1577 = phi_3047_;
                            let _e1579 = phi_3048_;
                            let _e1581 = phi_3049_;
                            let _e1583 = phi_3050_;
                            let _e1585 = phi_3051_;
                            phi_3267_ = _e1575;
                            phi_777_ = _e1577;
                            phi_780_ = _e1579;
                            phi_782_ = _e1581;
                            phi_784_ = _e1583;
                            phi_786_ = _e1585;
                            phi_3052_ = _e487;
                        } else {
                            phi_3267_ = _e473;
                            phi_777_ = type_33();
                            phi_780_ = type_50();
                            phi_782_ = u32();
                            phi_784_ = bool();
                            phi_786_ = u32();
                            phi_3052_ = false;
                        }
                        let _e1587 = phi_3267_;
                        let _e1589 = phi_777_;
                        let _e1591 = phi_780_;
                        let _e1593 = phi_782_;
                        let _e1595 = phi_784_;
                        let _e1597 = phi_786_;
                        let _e1599 = phi_3052_;
                        continue;
                        continuing {
                            phi_3112_ = _e1587;
                            phi_776_ = _e1589;
                            phi_779_ = _e1591;
                            phi_781_ = _e1593;
                            phi_783_ = _e1595;
                            phi_785_ = _e1597;
                            phi_3266_ = _e1587;
                            break if !(_e1599);
                        }
                    }
                    let _e1602 = phi_3266_;
                    if _e1602 {
                        break;
                    }
                    let _e1604 = local_10;
                    let _e1607 = local_11;
                    if _e128 {
                    } else {
                        break;
                    }
                    global_5.member[_e126][0u] = _e1604.member_1;
                    global_5.member[_e126][1u] = _e1607.member_2;
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
