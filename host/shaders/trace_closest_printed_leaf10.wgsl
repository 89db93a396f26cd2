struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: type_18,
    member_1: f32,
}

struct type_32 {
    member: array<type_22>,
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
var<storage> global_3: type_32;
@group(0) @binding(2) 
var<storage> global_4: type_39;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_20;
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
    var phi_332_: i32;
    var phi_333_: i32;
    var phi_343_: bool;
    var phi_353_: u32;
    var phi_354_: u32;
    var phi_356_: bool;
    var phi_361_: u32;
    var phi_373_: i32;
    var phi_393_: i32;
    var phi_411_: f32;
    var phi_417_: f32;
    var phi_428_: f32;
    var phi_434_: f32;
    var phi_457_: f32;
    var phi_468_: f32;
    var phi_477_: f32;
    var phi_483_: f32;
    var phi_494_: f32;
    var phi_500_: f32;
    var phi_523_: f32;
    var phi_534_: f32;
    var phi_543_: f32;
    var phi_549_: f32;
    var phi_560_: f32;
    var phi_566_: f32;
    var phi_589_: f32;
    var phi_600_: f32;
    var phi_700_: f32;
    var phi_701_: f32;
    var phi_3147_: bool;
    var phi_774_: type_29;
    var phi_777_: type_50;
    var phi_779_: u32;
    var phi_781_: bool;
    var phi_783_: u32;
    var phi_794_: bool;
    var phi_880_: type_50;
    var phi_881_: bool;
    var phi_882_: u32;
    var phi_2099_: type_37;
    var phi_2931_: type_50;
    var phi_3008_: type_50;
    var phi_3009_: type_50;
    var phi_3010_: u32;
    var phi_3012_: type_50;
    var phi_3013_: u32;
    var phi_3014_: bool;
    var phi_3021_: type_50;
    var phi_3026_: type_50;
    var phi_3027_: bool;
    var phi_901_: type_29;
    var phi_904_: type_4;
    var phi_905_: type_4;
    var phi_927_: type_4;
    var phi_952_: u32;
    var phi_968_: type_44;
    var phi_1344_: bool;
    var phi_1373_: bool;
    var phi_1750_: f32;
    var phi_1751_: f32;
    var phi_1752_: f32;
    var phi_1753_: f32;
    var phi_1754_: vec3<f32>;
    var phi_1755_: vec3<f32>;
    var phi_1756_: vec3<f32>;
    var phi_1757_: vec3<f32>;
    var phi_1788_: bool;
    var phi_1797_: vec3<f32>;
    var phi_1964_: bool;
    var phi_1988_: f32;
    var phi_1989_: f32;
    var phi_2012_: type_18;
    var phi_2014_: type_18;
    var phi_2015_: bool;
    var phi_2019_: type_18;
    var phi_2020_: type_18;
    var phi_2021_: type_18;
    var phi_2022_: bool;
    var phi_2026_: type_18;
    var phi_2027_: bool;
    var phi_2028_: type_18;
    var phi_2029_: bool;
    var phi_2030_: bool;
    var phi_2031_: type_18;
    var phi_2032_: bool;
    var phi_2033_: bool;
    var phi_2041_: type_18;
    var phi_2042_: bool;
    var phi_2046_: type_18;
    var phi_2071_: bool;
    var phi_2072_: bool;
    var phi_2078_: type_29;
    var phi_2079_: type_29;
    var phi_2080_: type_29;
    var phi_902_: type_29;
    var phi_3141_: bool;
    var phi_3305_: bool;
    var phi_3029_: type_29;
    var phi_3030_: type_50;
    var phi_3031_: bool;
    var phi_3032_: u32;
    var phi_3304_: bool;
    var phi_3033_: type_29;
    var phi_3034_: type_50;
    var phi_3035_: u32;
    var phi_3036_: bool;
    var phi_3037_: u32;
    var phi_3303_: bool;
    var phi_3038_: type_29;
    var phi_3039_: type_50;
    var phi_3040_: u32;
    var phi_3041_: bool;
    var phi_3042_: u32;
    var phi_3302_: bool;
    var phi_775_: type_29;
    var phi_778_: type_50;
    var phi_780_: u32;
    var phi_782_: bool;
    var phi_784_: u32;
    var phi_3043_: bool;
    var phi_3301_: bool;
    var local_10: type_29;
    var phi_3095_: type_18;
    var local_11: type_29;

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
                            phi_332_ = (bitcast<i32>((_e205 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_332_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e205)), 32u, (_e205 == 0u))));
                        }
                        let _e219 = phi_332_;
                        phi_333_ = _e219;
                    } else {
                        phi_333_ = 0i;
                    }
                    let _e221 = phi_333_;
                    let _e222 = (_e138 == _e177);
                    if _e222 {
                        phi_343_ = true;
                    } else {
                        phi_343_ = (_e145 == _e177);
                    }
                    let _e225 = phi_343_;
                    let _e226 = select(1u, 0u, _e222);
                    if _e225 {
                        let _e227 = (_e226 + 1u);
                        phi_353_ = _e227;
                        phi_354_ = _e227;
                        phi_356_ = select(true, false, (_e227 == 2u));
                    } else {
                        phi_353_ = u32();
                        phi_354_ = 0u;
                        phi_356_ = true;
                    }
                    let _e231 = phi_353_;
                    let _e233 = phi_354_;
                    let _e235 = phi_356_;
                    if _e235 {
                        phi_361_ = (_e233 + 1u);
                    } else {
                        phi_361_ = 0u;
                    }
                    let _e239 = phi_361_;
                    let _e240 = select(_e231, _e233, _e235);
                    let _e241 = select(_e226, select(2u, _e226, _e225), _e235);
                    if (_e116 < -126i) {
                        phi_373_ = -126i;
                    } else {
                        phi_373_ = select(_e116, 127i, (_e116 > 127i));
                    }
                    let _e246 = phi_373_;
                    let _e251 = bitcast<f32>((bitcast<u32>((_e246 + 127i)) << bitcast<u32>(23i)));
                    let _e257 = bitcast<f32>((bitcast<u32>(((_e116 - _e246) + 127i)) << bitcast<u32>(23i)));
                    let _e258 = -(_e221);
                    if (_e258 < -126i) {
                        phi_393_ = -126i;
                    } else {
                        phi_393_ = select(_e258, 127i, (_e258 > 127i));
                    }
                    let _e263 = phi_393_;
                    let _e268 = bitcast<f32>((bitcast<u32>((_e263 + 127i)) << bitcast<u32>(23i)));
                    let _e274 = bitcast<f32>((bitcast<u32>(((_e258 - _e263) + 127i)) << bitcast<u32>(23i)));
                    let _e278 = global_3.member[_e126].member;
                    let _e279 = (_e240 == 0u);
                    if _e279 {
                        phi_411_ = _e278[0];
                    } else {
                        phi_411_ = _e278[1];
                    }
                    let _e283 = phi_411_;
                    let _e284 = (_e240 == 2u);
                    if _e284 {
                        phi_417_ = _e278[2];
                    } else {
                        phi_417_ = _e283;
                    }
                    let _e287 = phi_417_;
                    let _e289 = ((_e287 * _e251) * _e257);
                    let _e290 = global_3.member[_e126].member_2;
                    if _e279 {
                        phi_428_ = _e290[0];
                    } else {
                        phi_428_ = _e290[1];
                    }
                    let _e294 = phi_428_;
                    if _e284 {
                        phi_434_ = _e290[2];
                    } else {
                        phi_434_ = _e294;
                    }
                    let _e297 = phi_434_;
                    let _e299 = ((_e297 * _e268) * _e274);
                    let _e303 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e303 {
                        let _e307 = (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) * 0.00000011920929f);
                        phi_457_ = select(0.00000000000011368684f, _e307, (_e307 > 0.00000000000011368684f));
                    } else {
                        phi_457_ = 0f;
                    }
                    let _e311 = phi_457_;
                    let _e312 = (_e289 + _e311);
                    let _e313 = (_e289 - _e311);
                    let _e314 = select(_e299, 0f, _e303);
                    if _e303 {
                        phi_468_ = 38685626000000000000000000f;
                    } else {
                        phi_468_ = (1f / _e299);
                    }
                    let _e317 = phi_468_;
                    let _e318 = (_e239 == 0u);
                    if _e318 {
                        phi_477_ = _e278[0];
                    } else {
                        phi_477_ = _e278[1];
                    }
                    let _e322 = phi_477_;
                    let _e323 = (_e239 == 2u);
                    if _e323 {
                        phi_483_ = _e278[2];
                    } else {
                        phi_483_ = _e322;
                    }
                    let _e326 = phi_483_;
                    let _e328 = ((_e326 * _e251) * _e257);
                    if _e318 {
                        phi_494_ = _e290[0];
                    } else {
                        phi_494_ = _e290[1];
                    }
                    let _e332 = phi_494_;
                    if _e323 {
                        phi_500_ = _e290[2];
                    } else {
                        phi_500_ = _e332;
                    }
                    let _e335 = phi_500_;
                    let _e337 = ((_e335 * _e268) * _e274);
                    let _e341 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e341 {
                        let _e345 = (bitcast<f32>((bitcast<u32>(_e328) & 2147483647u)) * 0.00000011920929f);
                        phi_523_ = select(0.00000000000011368684f, _e345, (_e345 > 0.00000000000011368684f));
                    } else {
                        phi_523_ = 0f;
                    }
                    let _e349 = phi_523_;
                    let _e350 = (_e328 + _e349);
                    let _e351 = (_e328 - _e349);
                    let _e352 = select(_e337, 0f, _e341);
                    if _e341 {
                        phi_534_ = 38685626000000000000000000f;
                    } else {
                        phi_534_ = (1f / _e337);
                    }
                    let _e355 = phi_534_;
                    let _e356 = (_e241 == 0u);
                    if _e356 {
                        phi_543_ = _e278[0];
                    } else {
                        phi_543_ = _e278[1];
                    }
                    let _e360 = phi_543_;
                    let _e361 = (_e241 == 2u);
                    if _e361 {
                        phi_549_ = _e278[2];
                    } else {
                        phi_549_ = _e360;
                    }
                    let _e364 = phi_549_;
                    let _e366 = ((_e364 * _e251) * _e257);
                    if _e356 {
                        phi_560_ = _e290[0];
                    } else {
                        phi_560_ = _e290[1];
                    }
                    let _e370 = phi_560_;
                    if _e361 {
                        phi_566_ = _e290[2];
                    } else {
                        phi_566_ = _e370;
                    }
                    let _e373 = phi_566_;
                    let _e375 = ((_e373 * _e268) * _e274);
                    let _e379 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e379 {
                        let _e383 = (bitcast<f32>((bitcast<u32>(_e366) & 2147483647u)) * 0.00000011920929f);
                        phi_589_ = select(0.00000000000011368684f, _e383, (_e383 > 0.00000000000011368684f));
                    } else {
                        phi_589_ = 0f;
                    }
                    let _e387 = phi_589_;
                    let _e388 = (_e366 + _e387);
                    let _e389 = (_e366 - _e387);
                    let _e390 = select(_e375, 0f, _e379);
                    if _e379 {
                        phi_600_ = 38685626000000000000000000f;
                    } else {
                        phi_600_ = (1f / _e375);
                    }
                    let _e393 = phi_600_;
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
                        phi_700_ = select(-340282350000000000000000000000000000000f, _e434, (_e434 > -340282350000000000000000000000000000000f));
                        phi_701_ = select(-340282350000000000000000000000000000000f, _e427, (_e427 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_700_ = 0f;
                        phi_701_ = 1f;
                    }
                    let _e438 = phi_700_;
                    let _e440 = phi_701_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e88), bitcast<f32>(_e92), bitcast<f32>(_e96));
                    let _e445 = (_e240 % 3u);
                    let _e446 = (_e445 < 3u);
                    if _e446 {
                    } else {
                        break;
                    }
                    let _e448 = local_9[_e445];
                    let _e449 = (_e239 % 3u);
                    let _e450 = (_e449 < 3u);
                    if _e450 {
                    } else {
                        break;
                    }
                    let _e452 = local_9[_e449];
                    let _e453 = (_e241 % 3u);
                    let _e454 = (_e453 < 3u);
                    if _e454 {
                    } else {
                        break;
                    }
                    let _e456 = local_9[_e453];
                    local_8 = array<f32, 3>(bitcast<f32>(_e100), bitcast<f32>(_e104), bitcast<f32>(_e108));
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
                    phi_3147_ = false;
                    phi_774_ = type_29(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e438);
                    phi_777_ = type_50(type_42(array<f32, 3>(_e448, _e452, _e456), array<f32, 3>(_e460, _e462, _e464)), select(0u, 2147483648u, (_e77 == 0u)));
                    phi_779_ = ((3u * _e77) + 1u);
                    phi_781_ = (_e440 <= _e438);
                    phi_783_ = 0u;
                    loop {
                        let _e472 = phi_3147_;
                        let _e474 = phi_774_;
                        let _e476 = phi_777_;
                        let _e478 = phi_779_;
                        let _e480 = phi_781_;
                        let _e482 = phi_783_;
                        local_10 = _e474;
                        if _e480 {
                            phi_794_ = true;
                        } else {
                            phi_794_ = (_e482 > 0u);
                        }
                        let _e485 = phi_794_;
                        if _e485 {
                            let _e486 = (_e478 > 0u);
                            if _e486 {
                                if _e480 {
                                    phi_880_ = _e476;
                                    phi_881_ = _e480;
                                    phi_882_ = _e482;
                                } else {
                                    let _e487 = (_e482 - 1u);
                                    let _e488 = (_e487 % 128u);
                                    let _e489 = (_e488 < 128u);
                                    if _e489 {
                                    } else {
                                        phi_3301_ = true;
                                        break;
                                    }
                                    let _e491 = local_6[_e488];
                                    if _e489 {
                                    } else {
                                        phi_3301_ = true;
                                        break;
                                    }
                                    let _e493 = local_5[_e488];
                                    if _e489 {
                                    } else {
                                        phi_3301_ = true;
                                        break;
                                    }
                                    let _e495 = local_4[_e488];
                                    if _e489 {
                                    } else {
                                        phi_3301_ = true;
                                        break;
                                    }
                                    let _e497 = local_3[_e488];
                                    if _e489 {
                                    } else {
                                        phi_3301_ = true;
                                        break;
                                    }
                                    let _e500 = local_2[_e488];
                                    if _e489 {
                                    } else {
                                        phi_3301_ = true;
                                        break;
                                    }
                                    let _e502 = local_1[_e488];
                                    if _e489 {
                                    } else {
                                        phi_3301_ = true;
                                        break;
                                    }
                                    let _e504 = local[_e488];
                                    if _e489 {
                                    } else {
                                        phi_3301_ = true;
                                        break;
                                    }
                                    let _e509 = local_7[_e488];
                                    phi_880_ = type_50(type_42(array<f32, 3>(_e493, _e495, _e497), array<f32, 3>(_e500, _e502, _e504)), _e491);
                                    phi_881_ = (_e509 <= _e474.member_1);
                                    phi_882_ = _e487;
                                }
                                let _e513 = phi_880_;
                                let _e515 = phi_881_;
                                let _e517 = phi_882_;
                                if _e515 {
                                    if ((_e513.member_1 & 2147483648u) != 0u) {
                                        phi_901_ = _e474;
                                        phi_904_ = type_4(0u, ((_e513.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e870 = phi_901_;
                                            let _e872 = phi_904_;
                                            local_11 = _e870;
                                            if (_e872.member < _e872.member_1) {
                                                phi_905_ = type_4((_e872.member + 1u), _e872.member_1);
                                                phi_927_ = type_4(1u, _e872.member);
                                            } else {
                                                phi_905_ = _e872;
                                                phi_927_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e885 = phi_905_;
                                            let _e887 = phi_927_;
                                            let _e891 = (bitcast<i32>(_e887.member) != 0i);
                                            if _e891 {
                                                let _e892 = ((_e513.member_1 & 268435455u) + _e887.member_1);
                                                let _e893 = (_e892 < arrayLength((&global_6.member)));
                                                if _e893 {
                                                    if _e893 {
                                                    } else {
                                                        phi_3141_ = true;
                                                        break;
                                                    }
                                                    let _e896 = global_6.member[_e892].member_1;
                                                    phi_952_ = _e896;
                                                } else {
                                                    phi_952_ = 4294967295u;
                                                }
                                                let _e898 = phi_952_;
                                                if _e893 {
                                                    if _e893 {
                                                    } else {
                                                        phi_3141_ = true;
                                                        break;
                                                    }
                                                    let _e900 = global_6.member[_e892];
                                                    phi_968_ = _e900;
                                                } else {
                                                    phi_968_ = type_44(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e902 = phi_968_;
                                                let _e914 = ((10u * _e240) & 31u);
                                                let _e917 = ((_e902.member[0] >> bitcast<u32>(_e914)) & 1023u);
                                                let _e922 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[0] - _e513.member.member[0]) * 0.0009775171f)) ^ _e112));
                                                let _e928 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e917) * _e922)) ^ _e112)));
                                                let _e932 = select(select(_e513.member.member_1[0], _e928, (_e928 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e917 == 1023u));
                                                let _e934 = ((10u * _e239) & 31u);
                                                let _e937 = ((_e902.member[0] >> bitcast<u32>(_e934)) & 1023u);
                                                let _e942 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[1] - _e513.member.member[1]) * 0.0009775171f)) ^ _e112));
                                                let _e948 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e937) * _e942)) ^ _e112)));
                                                let _e952 = select(select(_e513.member.member_1[1], _e948, (_e948 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e937 == 1023u));
                                                let _e954 = ((10u * _e241) & 31u);
                                                let _e957 = ((_e902.member[0] >> bitcast<u32>(_e954)) & 1023u);
                                                let _e962 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[2] - _e513.member.member[2]) * 0.0009775171f)) ^ _e112));
                                                let _e968 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e957) * _e962)) ^ _e112)));
                                                let _e972 = select(select(_e513.member.member_1[2], _e968, (_e968 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e957 == 1023u));
                                                let _e976 = ((_e902.member[1] >> bitcast<u32>(_e914)) & 1023u);
                                                let _e982 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e976) * _e922)) ^ _e112)));
                                                let _e986 = select(select(_e513.member.member_1[0], _e982, (_e982 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e976 == 1023u));
                                                let _e989 = ((_e902.member[1] >> bitcast<u32>(_e934)) & 1023u);
                                                let _e995 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e989) * _e942)) ^ _e112)));
                                                let _e999 = select(select(_e513.member.member_1[1], _e995, (_e995 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e989 == 1023u));
                                                let _e1002 = ((_e902.member[1] >> bitcast<u32>(_e954)) & 1023u);
                                                let _e1008 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1002) * _e962)) ^ _e112)));
                                                let _e1012 = select(select(_e513.member.member_1[2], _e1008, (_e1008 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e1002 == 1023u));
                                                let _e1016 = ((_e902.member[2] >> bitcast<u32>(_e914)) & 1023u);
                                                let _e1022 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1016) * _e922)) ^ _e112)));
                                                let _e1026 = select(select(_e513.member.member_1[0], _e1022, (_e1022 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e1016 == 1023u));
                                                let _e1029 = ((_e902.member[2] >> bitcast<u32>(_e934)) & 1023u);
                                                let _e1035 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1029) * _e942)) ^ _e112)));
                                                let _e1039 = select(select(_e513.member.member_1[1], _e1035, (_e1035 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e1029 == 1023u));
                                                let _e1042 = ((_e902.member[2] >> bitcast<u32>(_e954)) & 1023u);
                                                let _e1048 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1042) * _e962)) ^ _e112)));
                                                let _e1052 = select(select(_e513.member.member_1[2], _e1048, (_e1048 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e1042 == 1023u));
                                                let _e1056 = (_e972 - _e366);
                                                let _e1059 = (((_e932 - _e289) * _e390) - (_e1056 * _e314));
                                                let _e1062 = (((_e952 - _e328) * _e390) - (_e1056 * _e352));
                                                let _e1065 = (_e1012 - _e366);
                                                let _e1068 = (((_e986 - _e289) * _e390) - (_e1065 * _e314));
                                                let _e1071 = (((_e999 - _e328) * _e390) - (_e1065 * _e352));
                                                let _e1074 = (_e1052 - _e366);
                                                let _e1077 = (((_e1026 - _e289) * _e390) - (_e1074 * _e314));
                                                let _e1080 = (((_e1039 - _e328) * _e390) - (_e1074 * _e352));
                                                let _e1081 = (_e1077 * _e1071);
                                                let _e1082 = (_e1080 * _e1068);
                                                let _e1083 = (_e1059 * _e1080);
                                                let _e1084 = (_e1062 * _e1077);
                                                let _e1085 = (_e1068 * _e1062);
                                                let _e1086 = (_e1071 * _e1059);
                                                let _e1091 = (((_e1081 >= _e1082) && (_e1083 >= _e1084)) && (_e1085 >= _e1086));
                                                if (_e1091 || (((_e1081 <= _e1082) && (_e1083 <= _e1084)) && (_e1085 <= _e1086))) {
                                                    let _e1098 = select(-1f, 1f, _e1091);
                                                    let _e1100 = ((_e1081 - _e1082) * _e1098);
                                                    let _e1102 = select(0f, _e1100, (_e1100 > 0f));
                                                    let _e1104 = ((_e1083 - _e1084) * _e1098);
                                                    let _e1106 = select(0f, _e1104, (_e1104 > 0f));
                                                    let _e1108 = ((_e1085 - _e1086) * _e1098);
                                                    let _e1110 = select(0f, _e1108, (_e1108 > 0f));
                                                    let _e1112 = ((_e1102 + _e1106) + _e1110);
                                                    if (_e1112 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2031_ = type_18();
                                                        phi_2032_ = true;
                                                        phi_2033_ = false;
                                                    } else {
                                                        let _e1115 = select(_e1068, _e1059, (_e1059 < _e1068));
                                                        if (select(_e1077, _e1115, (_e1115 < _e1077)) > 0f) {
                                                            phi_1344_ = true;
                                                        } else {
                                                            let _e1120 = select(_e1068, _e1059, (_e1059 > _e1068));
                                                            phi_1344_ = (select(_e1077, _e1120, (_e1120 > _e1077)) < 0f);
                                                        }
                                                        let _e1125 = phi_1344_;
                                                        if _e1125 {
                                                            phi_2028_ = type_18();
                                                            phi_2029_ = true;
                                                            phi_2030_ = false;
                                                        } else {
                                                            let _e1127 = select(_e1071, _e1062, (_e1062 < _e1071));
                                                            if (select(_e1080, _e1127, (_e1127 < _e1080)) > 0f) {
                                                                phi_1373_ = true;
                                                            } else {
                                                                let _e1132 = select(_e1071, _e1062, (_e1062 > _e1071));
                                                                phi_1373_ = (select(_e1080, _e1132, (_e1132 > _e1080)) < 0f);
                                                            }
                                                            let _e1137 = phi_1373_;
                                                            if _e1137 {
                                                                phi_2026_ = type_18();
                                                                phi_2027_ = false;
                                                            } else {
                                                                let _e1139 = select(_e986, _e932, (_e932 < _e986));
                                                                let _e1143 = select(_e986, _e932, (_e932 > _e986));
                                                                let _e1147 = select(_e999, _e952, (_e952 < _e999));
                                                                let _e1151 = select(_e999, _e952, (_e952 > _e999));
                                                                let _e1155 = select(_e1012, _e972, (_e972 < _e1012));
                                                                let _e1159 = select(_e1012, _e972, (_e972 > _e1012));
                                                                let _e1164 = ((select(_e1026, _e1139, (_e1139 < _e1026)) - _e312) * _e317);
                                                                let _e1165 = ((select(_e1026, _e1143, (_e1143 > _e1026)) - _e313) * _e317);
                                                                let _e1168 = ((select(_e1039, _e1147, (_e1147 < _e1039)) - _e350) * _e355);
                                                                let _e1169 = ((select(_e1039, _e1151, (_e1151 > _e1039)) - _e351) * _e355);
                                                                let _e1172 = ((select(_e1052, _e1155, (_e1155 < _e1052)) - _e388) * _e393);
                                                                let _e1173 = ((select(_e1052, _e1159, (_e1159 > _e1052)) - _e389) * _e393);
                                                                let _e1175 = select(_e1173, _e1172, (_e1172 < _e1173));
                                                                let _e1177 = select(_e1173, _e1172, (_e1172 > _e1173));
                                                                let _e1179 = select(_e1165, _e1164, (_e1164 < _e1165));
                                                                let _e1181 = select(_e1169, _e1168, (_e1168 < _e1169));
                                                                let _e1183 = select(_e1181, _e1179, (_e1179 > _e1181));
                                                                let _e1185 = select(_e1175, _e1183, (_e1183 > _e1175));
                                                                let _e1187 = select(_e1165, _e1164, (_e1164 > _e1165));
                                                                let _e1189 = select(_e1169, _e1168, (_e1168 > _e1169));
                                                                let _e1191 = select(_e1189, _e1187, (_e1187 < _e1189));
                                                                let _e1193 = select(_e1177, _e1191, (_e1191 < _e1177));
                                                                let _e1194 = -(_e1175);
                                                                let _e1200 = select(_e440, _e1185, (_e1185 > _e440));
                                                                if (_e1200 > (_e1193 + (select(_e1194, _e1177, (_e1177 > _e1194)) * 0.0000019073523f))) {
                                                                    phi_2021_ = type_18();
                                                                    phi_2022_ = true;
                                                                } else {
                                                                    let _e1202 = (_e1200 > _e870.member_1);
                                                                    if _e1202 {
                                                                        phi_2020_ = type_18();
                                                                    } else {
                                                                        let _e1203 = vec3<f32>(_e932, _e952, _e972);
                                                                        let _e1204 = vec3<f32>(_e986, _e999, _e1012);
                                                                        let _e1205 = vec3<f32>(_e1026, _e1039, _e1052);
                                                                        let _e1206 = (_e986 - _e932);
                                                                        let _e1207 = (_e999 - _e952);
                                                                        let _e1208 = (_e1012 - _e972);
                                                                        let _e1209 = vec3<f32>(_e1206, _e1207, _e1208);
                                                                        let _e1210 = (_e1026 - _e986);
                                                                        let _e1211 = (_e1039 - _e999);
                                                                        let _e1212 = (_e1052 - _e1012);
                                                                        let _e1213 = vec3<f32>(_e1210, _e1211, _e1212);
                                                                        let _e1214 = (_e932 - _e1026);
                                                                        let _e1215 = (_e952 - _e1039);
                                                                        let _e1216 = (_e972 - _e1052);
                                                                        let _e1217 = vec3<f32>(_e1214, _e1215, _e1216);
                                                                        let _e1220 = bitcast<f32>((bitcast<u32>(_e1206) & 2147483647u));
                                                                        let _e1223 = bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u));
                                                                        let _e1225 = select(_e1223, _e1220, (_e1220 > _e1223));
                                                                        let _e1228 = bitcast<f32>((bitcast<u32>(_e1208) & 2147483647u));
                                                                        let _e1230 = select(_e1228, _e1225, (_e1225 > _e1228));
                                                                        let _e1233 = bitcast<f32>((bitcast<u32>(_e1210) & 2147483647u));
                                                                        let _e1236 = bitcast<f32>((bitcast<u32>(_e1211) & 2147483647u));
                                                                        let _e1238 = select(_e1236, _e1233, (_e1233 > _e1236));
                                                                        let _e1241 = bitcast<f32>((bitcast<u32>(_e1212) & 2147483647u));
                                                                        let _e1243 = select(_e1241, _e1238, (_e1238 > _e1241));
                                                                        let _e1246 = bitcast<f32>((bitcast<u32>(_e1214) & 2147483647u));
                                                                        let _e1249 = bitcast<f32>((bitcast<u32>(_e1215) & 2147483647u));
                                                                        let _e1251 = select(_e1249, _e1246, (_e1246 > _e1249));
                                                                        let _e1254 = bitcast<f32>((bitcast<u32>(_e1216) & 2147483647u));
                                                                        let _e1256 = select(_e1254, _e1251, (_e1251 > _e1254));
                                                                        let _e1258 = select(_e1243, _e1230, (_e1230 > _e1243));
                                                                        let _e1260 = select(_e1256, _e1258, (_e1258 > _e1256));
                                                                        if (_e1230 == _e1260) {
                                                                            phi_1750_ = _e1071;
                                                                            phi_1751_ = _e1068;
                                                                            phi_1752_ = _e1062;
                                                                            phi_1753_ = _e1059;
                                                                            phi_1754_ = _e1203;
                                                                            phi_1755_ = _e1217;
                                                                            phi_1756_ = _e1213;
                                                                            phi_1757_ = _e1209;
                                                                        } else {
                                                                            let _e1262 = (_e1243 == _e1260);
                                                                            let _e1267 = vec3(_e1262);
                                                                            phi_1750_ = select(_e1062, _e1080, _e1262);
                                                                            phi_1751_ = select(_e1059, _e1077, _e1262);
                                                                            phi_1752_ = select(_e1080, _e1071, _e1262);
                                                                            phi_1753_ = select(_e1077, _e1068, _e1262);
                                                                            phi_1754_ = select(_e1205, _e1204, _e1267);
                                                                            phi_1755_ = select(_e1213, _e1209, _e1267);
                                                                            phi_1756_ = select(_e1209, _e1217, _e1267);
                                                                            phi_1757_ = select(_e1217, _e1213, _e1267);
                                                                        }
                                                                        let _e1273 = phi_1750_;
                                                                        let _e1275 = phi_1751_;
                                                                        let _e1277 = phi_1752_;
                                                                        let _e1279 = phi_1753_;
                                                                        let _e1281 = phi_1754_;
                                                                        let _e1283 = phi_1755_;
                                                                        let _e1285 = phi_1756_;
                                                                        let _e1287 = phi_1757_;
                                                                        let _e1294 = ((_e1285.y * _e1283.z) - (_e1283.y * _e1285.z));
                                                                        let _e1299 = ((_e1285.z * _e1283.x) - (_e1283.z * _e1285.x));
                                                                        let _e1302 = ((_e1285.x * _e1283.y) - (_e1283.x * _e1285.y));
                                                                        if (_e1102 >= _e1106) {
                                                                            phi_1788_ = select(true, false, (_e1102 >= _e1110));
                                                                        } else {
                                                                            phi_1788_ = true;
                                                                        }
                                                                        let _e1307 = phi_1788_;
                                                                        if _e1307 {
                                                                            phi_1797_ = select(_e1205, _e1204, vec3((_e1106 >= _e1110)));
                                                                        } else {
                                                                            phi_1797_ = _e1203;
                                                                        }
                                                                        let _e1312 = phi_1797_;
                                                                        let _e1317 = (((_e1294 * _e314) + (_e1299 * _e352)) + (_e1302 * _e390));
                                                                        let _e1328 = (((_e1294 * (_e1312.x - _e289)) + (_e1299 * (_e1312.y - _e328))) + (_e1302 * (_e1312.z - _e366)));
                                                                        let _e1330 = (_e1275 - _e1279);
                                                                        let _e1331 = (_e1273 - _e1277);
                                                                        let _e1339 = (-(((_e1279 * _e1330) + (_e1277 * _e1331))) / ((_e1330 * _e1330) + (_e1331 * _e1331)));
                                                                        let _e1341 = select(1f, _e1339, (_e1339 < 1f));
                                                                        let _e1343 = select(0f, _e1341, (_e1341 > 0f));
                                                                        let _e1356 = ((_e1281.x + (_e1287.x * _e1343)) - _e289);
                                                                        let _e1357 = ((_e1281.y + (_e1287.y * _e1343)) - _e328);
                                                                        let _e1358 = ((_e1281.z + (_e1287.z * _e1343)) - _e366);
                                                                        let _e1359 = (_e1358 / _e390);
                                                                        let _e1371 = bitcast<f32>((bitcast<u32>(_e1356) & 2147483647u));
                                                                        let _e1374 = bitcast<f32>((bitcast<u32>(_e1357) & 2147483647u));
                                                                        let _e1376 = select(_e1374, _e1371, (_e1371 > _e1374));
                                                                        let _e1379 = bitcast<f32>((bitcast<u32>(_e1358) & 2147483647u));
                                                                        let _e1381 = select(_e1379, _e1376, (_e1376 > _e1379));
                                                                        let _e1387 = bitcast<f32>((bitcast<u32>(_e1294) & 2147483647u));
                                                                        let _e1390 = bitcast<f32>((bitcast<u32>(_e1299) & 2147483647u));
                                                                        let _e1392 = select(_e1390, _e1387, (_e1387 > _e1390));
                                                                        let _e1395 = bitcast<f32>((bitcast<u32>(_e1302) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1294 * _e1356) + (_e1299 * _e1357)) + (_e1302 * _e1358)) - _e1328)) & 2147483647u)) <= ((0.0000009536743f * select(_e1260, _e1381, (_e1381 > _e1260))) * select(_e1395, _e1392, (_e1392 > _e1395)))) {
                                                                            let _e1405 = bitcast<f32>((bitcast<u32>(_e1285.x) & 2147483647u));
                                                                            let _e1408 = bitcast<f32>((bitcast<u32>(_e1285.y) & 2147483647u));
                                                                            let _e1410 = select(_e1408, _e1405, (_e1405 > _e1408));
                                                                            let _e1413 = bitcast<f32>((bitcast<u32>(_e1285.z) & 2147483647u));
                                                                            let _e1419 = bitcast<f32>((bitcast<u32>(_e1283.x) & 2147483647u));
                                                                            let _e1422 = bitcast<f32>((bitcast<u32>(_e1283.y) & 2147483647u));
                                                                            let _e1424 = select(_e1422, _e1419, (_e1419 > _e1422));
                                                                            let _e1427 = bitcast<f32>((bitcast<u32>(_e1283.z) & 2147483647u));
                                                                            phi_1964_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1317) & 2147483647u)) > ((0.0000038146973f * select(_e1413, _e1410, (_e1410 > _e1413))) * select(_e1427, _e1424, (_e1424 > _e1427)))));
                                                                        } else {
                                                                            phi_1964_ = true;
                                                                        }
                                                                        let _e1434 = phi_1964_;
                                                                        if _e1434 {
                                                                            let _e1445 = ((((_e1294 * (_e1356 - (_e314 * _e1359))) + (_e1299 * (_e1357 - (_e352 * _e1359)))) + (_e1302 * (_e1358 - _e1358))) / _e1317);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1445) & 2147483647u)) <= _e1260) {
                                                                                phi_1988_ = (_e1359 + _e1445);
                                                                            } else {
                                                                                phi_1988_ = _e1359;
                                                                            }
                                                                            let _e1452 = phi_1988_;
                                                                            phi_1989_ = _e1452;
                                                                        } else {
                                                                            phi_1989_ = (_e1328 / _e1317);
                                                                        }
                                                                        let _e1454 = phi_1989_;
                                                                        let _e1456 = select(_e1193, _e1454, (_e1454 < _e1193));
                                                                        let _e1458 = select(_e1185, _e1456, (_e1456 > _e1185));
                                                                        if (_e1458 >= _e440) {
                                                                            let _e1460 = (_e1458 <= _e870.member_1);
                                                                            if _e1460 {
                                                                                let _e1461 = (1f / _e1112);
                                                                                phi_2012_ = type_18(_e1458, (_e1106 * _e1461), (_e1110 * _e1461), _e898);
                                                                            } else {
                                                                                phi_2012_ = type_18();
                                                                            }
                                                                            let _e1466 = phi_2012_;
                                                                            phi_2014_ = _e1466;
                                                                            phi_2015_ = select(true, false, _e1460);
                                                                        } else {
                                                                            phi_2014_ = type_18();
                                                                            phi_2015_ = true;
                                                                        }
                                                                        let _e1469 = phi_2014_;
                                                                        let _e1471 = phi_2015_;
                                                                        if _e1471 {
                                                                            phi_2019_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2019_ = _e1469;
                                                                        }
                                                                        let _e1473 = phi_2019_;
                                                                        phi_2020_ = _e1473;
                                                                    }
                                                                    let _e1475 = phi_2020_;
                                                                    phi_2021_ = _e1475;
                                                                    phi_2022_ = _e1202;
                                                                }
                                                                let _e1477 = phi_2021_;
                                                                let _e1479 = phi_2022_;
                                                                phi_2026_ = _e1477;
                                                                phi_2027_ = _e1479;
                                                            }
                                                            let _e1481 = phi_2026_;
                                                            let _e1483 = phi_2027_;
                                                            phi_2028_ = _e1481;
                                                            phi_2029_ = _e1137;
                                                            phi_2030_ = _e1483;
                                                        }
                                                        let _e1485 = phi_2028_;
                                                        let _e1487 = phi_2029_;
                                                        let _e1489 = phi_2030_;
                                                        phi_2031_ = _e1485;
                                                        phi_2032_ = _e1487;
                                                        phi_2033_ = _e1489;
                                                    }
                                                    let _e1491 = phi_2031_;
                                                    let _e1493 = phi_2032_;
                                                    let _e1495 = phi_2033_;
                                                    phi_2041_ = _e1491;
                                                    phi_2042_ = select(_e1495, true, _e1493);
                                                } else {
                                                    phi_2041_ = type_18();
                                                    phi_2042_ = true;
                                                }
                                                let _e1498 = phi_2041_;
                                                let _e1500 = phi_2042_;
                                                if _e1500 {
                                                    phi_2046_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2046_ = _e1498;
                                                }
                                                let _e1502 = phi_2046_;
                                                if (_e1502.member_3 != 4294967295u) {
                                                    if (_e898 != 4294967295u) {
                                                        if (_e1502.member < _e870.member.member) {
                                                            phi_2072_ = true;
                                                        } else {
                                                            if (_e1502.member == _e870.member.member) {
                                                                phi_2071_ = (_e1502.member_3 < _e870.member.member_3);
                                                            } else {
                                                                phi_2071_ = false;
                                                            }
                                                            let _e1515 = phi_2071_;
                                                            phi_2072_ = _e1515;
                                                        }
                                                        let _e1517 = phi_2072_;
                                                        if _e1517 {
                                                            phi_2078_ = type_29(_e1502, _e1502.member);
                                                        } else {
                                                            phi_2078_ = _e870;
                                                        }
                                                        let _e1520 = phi_2078_;
                                                        phi_2079_ = _e1520;
                                                    } else {
                                                        phi_2079_ = _e870;
                                                    }
                                                    let _e1522 = phi_2079_;
                                                    phi_2080_ = _e1522;
                                                } else {
                                                    phi_2080_ = _e870;
                                                }
                                                let _e1524 = phi_2080_;
                                                phi_902_ = _e1524;
                                            } else {
                                                phi_902_ = type_29();
                                            }
                                            let _e1526 = phi_902_;
                                            continue;
                                            continuing {
                                                phi_901_ = _e1526;
                                                phi_904_ = _e885;
                                                phi_3141_ = _e472;
                                                break if !(_e891);
                                            }
                                        }
                                        let _e1529 = phi_3141_;
                                        phi_3301_ = _e1529;
                                        if _e1529 {
                                            break;
                                        }
                                        phi_3305_ = _e1529;
                                        let _e1714 = local_11;
                                        phi_3029_ = _e1714;
                                        phi_3030_ = _e513;
                                        phi_3031_ = false;
                                        phi_3032_ = _e517;
                                    } else {
                                        let _e527 = (_e513.member_1 < _e77);
                                        if _e527 {
                                            if _e527 {
                                            } else {
                                                phi_3301_ = true;
                                                break;
                                            }
                                            let _e529 = global_4.member[_e513.member_1];
                                            phi_2099_ = _e529;
                                        } else {
                                            phi_2099_ = type_37(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e531 = phi_2099_;
                                        let _e546 = ((10u * _e240) & 31u);
                                        let _e549 = ((_e531.member[0] >> bitcast<u32>(_e546)) & 1023u);
                                        let _e554 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[0] - _e513.member.member[0]) * 0.0009775171f)) ^ _e112));
                                        let _e560 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e549) * _e554)) ^ _e112)));
                                        let _e564 = select(select(_e513.member.member_1[0], _e560, (_e560 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e549 == 1023u));
                                        let _e566 = ((10u * _e239) & 31u);
                                        let _e569 = ((_e531.member[0] >> bitcast<u32>(_e566)) & 1023u);
                                        let _e574 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[1] - _e513.member.member[1]) * 0.0009775171f)) ^ _e112));
                                        let _e580 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e569) * _e574)) ^ _e112)));
                                        let _e584 = select(select(_e513.member.member_1[1], _e580, (_e580 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e569 == 1023u));
                                        let _e586 = ((10u * _e241) & 31u);
                                        let _e589 = ((_e531.member[0] >> bitcast<u32>(_e586)) & 1023u);
                                        let _e594 = bitcast<f32>((bitcast<u32>(((_e513.member.member_1[2] - _e513.member.member[2]) * 0.0009775171f)) ^ _e112));
                                        let _e600 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e589) * _e594)) ^ _e112)));
                                        let _e604 = select(select(_e513.member.member_1[2], _e600, (_e600 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e589 == 1023u));
                                        let _e607 = ((_e531.member[1] >> bitcast<u32>(_e546)) & 1023u);
                                        let _e613 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e607) * _e554)) ^ _e112)));
                                        let _e617 = select(select(_e513.member.member_1[0], _e613, (_e613 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e607 == 1023u));
                                        let _e620 = ((_e531.member[1] >> bitcast<u32>(_e566)) & 1023u);
                                        let _e626 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e620) * _e574)) ^ _e112)));
                                        let _e630 = select(select(_e513.member.member_1[1], _e626, (_e626 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e620 == 1023u));
                                        let _e633 = ((_e531.member[1] >> bitcast<u32>(_e586)) & 1023u);
                                        let _e639 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e633) * _e594)) ^ _e112)));
                                        let _e643 = select(select(_e513.member.member_1[2], _e639, (_e639 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e633 == 1023u));
                                        let _e649 = ((_e531.member_1[0] >> bitcast<u32>(_e546)) & 1023u);
                                        let _e655 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e649) * _e554)) ^ _e112)));
                                        let _e659 = select(select(_e513.member.member_1[0], _e655, (_e655 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e649 == 1023u));
                                        let _e662 = ((_e531.member_1[0] >> bitcast<u32>(_e566)) & 1023u);
                                        let _e668 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e662) * _e574)) ^ _e112)));
                                        let _e672 = select(select(_e513.member.member_1[1], _e668, (_e668 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e662 == 1023u));
                                        let _e675 = ((_e531.member_1[0] >> bitcast<u32>(_e586)) & 1023u);
                                        let _e681 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e675) * _e594)) ^ _e112)));
                                        let _e685 = select(select(_e513.member.member_1[2], _e681, (_e681 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e675 == 1023u));
                                        let _e688 = ((_e531.member_1[1] >> bitcast<u32>(_e546)) & 1023u);
                                        let _e694 = (_e513.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e688) * _e554)) ^ _e112)));
                                        let _e698 = select(select(_e513.member.member_1[0], _e694, (_e694 < _e513.member.member_1[0])), _e513.member.member_1[0], (_e688 == 1023u));
                                        let _e701 = ((_e531.member_1[1] >> bitcast<u32>(_e566)) & 1023u);
                                        let _e707 = (_e513.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e701) * _e574)) ^ _e112)));
                                        let _e711 = select(select(_e513.member.member_1[1], _e707, (_e707 < _e513.member.member_1[1])), _e513.member.member_1[1], (_e701 == 1023u));
                                        let _e714 = ((_e531.member_1[1] >> bitcast<u32>(_e586)) & 1023u);
                                        let _e720 = (_e513.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e714) * _e594)) ^ _e112)));
                                        let _e724 = select(select(_e513.member.member_1[2], _e720, (_e720 < _e513.member.member_1[2])), _e513.member.member_1[2], (_e714 == 1023u));
                                        let _e729 = type_50(type_42(array<f32, 3>(_e564, _e584, _e604), array<f32, 3>(_e617, _e630, _e643)), _e531.member_2);
                                        let _e734 = type_50(type_42(array<f32, 3>(_e659, _e672, _e685), array<f32, 3>(_e698, _e711, _e724)), _e531.member_3);
                                        let _e740 = ((_e564 - _e312) * _e317);
                                        let _e741 = ((_e659 - _e312) * _e317);
                                        let _e742 = ((_e617 - _e313) * _e317);
                                        let _e743 = ((_e698 - _e313) * _e317);
                                        let _e748 = ((_e584 - _e350) * _e355);
                                        let _e749 = ((_e672 - _e350) * _e355);
                                        let _e750 = ((_e630 - _e351) * _e355);
                                        let _e751 = ((_e711 - _e351) * _e355);
                                        let _e756 = ((_e604 - _e388) * _e393);
                                        let _e757 = ((_e685 - _e388) * _e393);
                                        let _e758 = ((_e643 - _e389) * _e393);
                                        let _e759 = ((_e724 - _e389) * _e393);
                                        let _e761 = select(_e758, _e756, (_e756 < _e758));
                                        let _e763 = select(_e759, _e757, (_e757 < _e759));
                                        let _e765 = select(_e758, _e756, (_e756 > _e758));
                                        let _e767 = select(_e759, _e757, (_e757 > _e759));
                                        let _e769 = select(_e742, _e740, (_e740 < _e742));
                                        let _e771 = select(_e743, _e741, (_e741 < _e743));
                                        let _e773 = select(_e750, _e748, (_e748 < _e750));
                                        let _e775 = select(_e751, _e749, (_e749 < _e751));
                                        let _e777 = select(_e773, _e769, (_e769 > _e773));
                                        let _e779 = select(_e775, _e771, (_e771 > _e775));
                                        let _e781 = select(_e761, _e777, (_e777 > _e761));
                                        let _e783 = select(_e763, _e779, (_e779 > _e763));
                                        let _e785 = select(_e742, _e740, (_e740 > _e742));
                                        let _e787 = select(_e743, _e741, (_e741 > _e743));
                                        let _e789 = select(_e750, _e748, (_e748 > _e750));
                                        let _e791 = select(_e751, _e749, (_e749 > _e751));
                                        let _e793 = select(_e789, _e785, (_e785 < _e789));
                                        let _e795 = select(_e791, _e787, (_e787 < _e791));
                                        let _e800 = -(_e761);
                                        let _e801 = -(_e763);
                                        let _e808 = (select(_e765, _e793, (_e793 < _e765)) + (select(_e800, _e765, (_e765 > _e800)) * 0.0000019073523f));
                                        let _e809 = (select(_e767, _e795, (_e795 < _e767)) + (select(_e801, _e767, (_e767 > _e801)) * 0.0000019073523f));
                                        let _e811 = select(_e440, _e781, (_e781 > _e440));
                                        let _e813 = select(_e440, _e783, (_e783 > _e440));
                                        let _e818 = (_e811 <= select(_e474.member_1, _e808, (_e808 < _e474.member_1)));
                                        let _e819 = (_e813 <= select(_e474.member_1, _e809, (_e809 < _e474.member_1)));
                                        let _e820 = (_e811 <= _e813);
                                        if _e818 {
                                            if _e819 {
                                                if _e820 {
                                                    phi_2931_ = _e734;
                                                } else {
                                                    phi_2931_ = _e729;
                                                }
                                                let _e822 = phi_2931_;
                                                let _e830 = (_e517 % 128u);
                                                let _e831 = (_e830 < 128u);
                                                if _e831 {
                                                } else {
                                                    phi_3301_ = true;
                                                    break;
                                                }
                                                local_6[_e830] = _e822.member_1;
                                                if _e831 {
                                                } else {
                                                    phi_3301_ = true;
                                                    break;
                                                }
                                                local_5[_e830] = _e822.member.member[0];
                                                if _e831 {
                                                } else {
                                                    phi_3301_ = true;
                                                    break;
                                                }
                                                local_4[_e830] = _e822.member.member[1];
                                                if _e831 {
                                                } else {
                                                    phi_3301_ = true;
                                                    break;
                                                }
                                                local_3[_e830] = _e822.member.member[2];
                                                if _e831 {
                                                } else {
                                                    phi_3301_ = true;
                                                    break;
                                                }
                                                local_2[_e830] = _e822.member.member_1[0];
                                                if _e831 {
                                                } else {
                                                    phi_3301_ = true;
                                                    break;
                                                }
                                                local_1[_e830] = _e822.member.member_1[1];
                                                if _e831 {
                                                } else {
                                                    phi_3301_ = true;
                                                    break;
                                                }
                                                local[_e830] = _e822.member.member_1[2];
                                                if _e831 {
                                                } else {
                                                    phi_3301_ = true;
                                                    break;
                                                }
                                                local_7[_e830] = select(_e813, _e811, (_e811 > _e813));
                                                if _e820 {
                                                    phi_3008_ = _e729;
                                                } else {
                                                    phi_3008_ = _e734;
                                                }
                                                let _e848 = phi_3008_;
                                                phi_3009_ = _e848;
                                                phi_3010_ = (_e517 + 1u);
                                            } else {
                                                phi_3009_ = type_50();
                                                phi_3010_ = u32();
                                            }
                                            let _e850 = phi_3009_;
                                            let _e852 = phi_3010_;
                                            phi_3012_ = _e850;
                                            phi_3013_ = _e852;
                                            phi_3014_ = select(true, false, _e819);
                                        } else {
                                            phi_3012_ = type_50();
                                            phi_3013_ = u32();
                                            phi_3014_ = true;
                                        }
                                        let _e855 = phi_3012_;
                                        let _e857 = phi_3013_;
                                        let _e859 = phi_3014_;
                                        if _e859 {
                                            if _e818 {
                                                phi_3021_ = _e729;
                                            } else {
                                                phi_3021_ = _e734;
                                            }
                                            let _e861 = phi_3021_;
                                            phi_3026_ = _e861;
                                            phi_3027_ = select(_e819, true, _e818);
                                        } else {
                                            phi_3026_ = _e855;
                                            phi_3027_ = _e515;
                                        }
                                        let _e864 = phi_3026_;
                                        let _e866 = phi_3027_;
                                        phi_3305_ = _e472;
                                        phi_3029_ = _e474;
                                        phi_3030_ = _e864;
                                        phi_3031_ = _e866;
                                        phi_3032_ = select(_e857, _e517, _e859);
                                    }
                                    let _e1531 = phi_3305_;
                                    let _e1533 = phi_3029_;
                                    let _e1535 = phi_3030_;
                                    let _e1537 = phi_3031_;
                                    let _e1539 = phi_3032_;
                                    phi_3304_ = _e1531;
                                    phi_3033_ = _e1533;
                                    phi_3034_ = _e1535;
                                    phi_3035_ = (_e478 - 1u);
                                    phi_3036_ = _e1537;
                                    phi_3037_ = _e1539;
                                } else {
                                    phi_3304_ = _e472;
                                    phi_3033_ = _e474;
                                    phi_3034_ = _e513;
                                    phi_3035_ = _e478;
                                    phi_3036_ = _e515;
                                    phi_3037_ = _e517;
                                }
                                let _e1541 = phi_3304_;
                                let _e1543 = phi_3033_;
                                let _e1545 = phi_3034_;
                                let _e1547 = phi_3035_;
                                let _e1549 = phi_3036_;
                                let _e1551 = phi_3037_;
                                phi_3303_ = _e1541;
                                phi_3038_ = _e1543;
                                phi_3039_ = _e1545;
                                phi_3040_ = _e1547;
                                phi_3041_ = _e1549;
                                phi_3042_ = _e1551;
                            } else {
                                phi_3303_ = _e472;
                                phi_3038_ = type_29();
                                phi_3039_ = type_50();
                                phi_3040_ = u32();
                                phi_3041_ = bool();
                                phi_3042_ = u32();
                            }
                            let _e1553 = phi_3303_;
                            let _e1555 = phi_3038_;
                            let _e1557 = phi_3039_;
                            let _e1559 = phi_3040_;
                            let _e1561 = phi_3041_;
                            let _e1563 = phi_3042_;
                            phi_3302_ = _e1553;
                            phi_775_ = _e1555;
                            phi_778_ = _e1557;
                            phi_780_ = _e1559;
                            phi_782_ = _e1561;
                            phi_784_ = _e1563;
                            phi_3043_ = _e486;
                        } else {
                            phi_3302_ = _e472;
                            phi_775_ = type_29();
                            phi_778_ = type_50();
                            phi_780_ = u32();
                            phi_782_ = bool();
                            phi_784_ = u32();
                            phi_3043_ = false;
                        }
                        let _e1565 = phi_3302_;
                        let _e1567 = phi_775_;
                        let _e1569 = phi_778_;
                        let _e1571 = phi_780_;
                        let _e1573 = phi_782_;
                        let _e1575 = phi_784_;
                        let _e1577 = phi_3043_;
                        continue;
                        continuing {
                            phi_3147_ = _e1565;
                            phi_774_ = _e1567;
                            phi_777_ = _e1569;
                            phi_779_ = _e1571;
                            phi_781_ = _e1573;
                            phi_783_ = _e1575;
                            phi_3301_ = _e1565;
                            break if !(_e1577);
                        }
                    }
                    let _e1580 = phi_3301_;
                    if _e1580 {
                        break;
                    }
                    let _e1582 = local_10;
                    if (_e1582.member.member_3 != 4294967295u) {
                        let _e1587 = -(_e407);
                        let _e1588 = (_e1587 / 3i);
                        let _e1595 = bitcast<f32>((bitcast<u32>((_e1588 + 127i)) << bitcast<u32>(23i)));
                        let _e1603 = (((_e1582.member.member * _e1595) * _e1595) * bitcast<f32>((bitcast<u32>(((_e1587 - (2i * _e1588)) + 127i)) << bitcast<u32>(23i))));
                        let _e1605 = select(340282350000000000000000000000000000000f, _e1603, (_e1603 < 340282350000000000000000000000000000000f));
                        phi_3095_ = type_18(select(-340282350000000000000000000000000000000f, _e1605, (_e1605 > -340282350000000000000000000000000000000f)), _e1582.member.member_1, _e1582.member.member_2, _e1582.member.member_3);
                    } else {
                        phi_3095_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1612 = phi_3095_;
                    if _e128 {
                    } else {
                        break;
                    }
                    global_5.member[_e126] = _e1612;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
