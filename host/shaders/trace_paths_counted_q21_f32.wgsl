struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_34 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_38 {
    member: type_22,
    member_1: f32,
}

struct type_42 {
    member: type_38,
    member_1: u32,
    member_2: u32,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_48 {
    member: array<array<u32, 7>>,
}

struct type_53 {
    member: type_34,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_53,
    member_2: type_53,
}

struct type_59 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_24;
@group(0) @binding(0) 
var<uniform> global_3: type_44;
@group(0) @binding(3) 
var<storage> global_4: type_29;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_59;
@group(0) @binding(1) 
var<storage> global_7: type_48;

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
    var phi_393_: i32;
    var phi_394_: i32;
    var phi_404_: bool;
    var phi_414_: u32;
    var phi_415_: u32;
    var phi_417_: bool;
    var phi_422_: u32;
    var phi_454_: i32;
    var phi_472_: f32;
    var phi_478_: f32;
    var phi_489_: f32;
    var phi_495_: f32;
    var phi_518_: f32;
    var phi_529_: f32;
    var phi_538_: f32;
    var phi_544_: f32;
    var phi_555_: f32;
    var phi_561_: f32;
    var phi_584_: f32;
    var phi_595_: f32;
    var phi_604_: f32;
    var phi_610_: f32;
    var phi_621_: f32;
    var phi_627_: f32;
    var phi_650_: f32;
    var phi_661_: f32;
    var phi_761_: f32;
    var phi_762_: f32;
    var phi_3594_: bool;
    var phi_860_: type_42;
    var phi_863_: type_53;
    var phi_865_: u32;
    var phi_867_: bool;
    var phi_869_: u32;
    var phi_880_: bool;
    var phi_966_: type_53;
    var phi_967_: bool;
    var phi_968_: u32;
    var phi_2728_: u32;
    var phi_2729_: u32;
    var phi_2739_: u32;
    var phi_2741_: u32;
    var phi_2742_: bool;
    var phi_2762_: u32;
    var phi_2763_: u32;
    var phi_2767_: type_54;
    var phi_3111_: type_53;
    var phi_3188_: type_53;
    var phi_3189_: type_53;
    var phi_3190_: u32;
    var phi_3192_: type_53;
    var phi_3193_: u32;
    var phi_3194_: bool;
    var phi_3203_: type_53;
    var phi_3208_: type_53;
    var phi_3209_: bool;
    var phi_986_: type_42;
    var phi_989_: type_7;
    var phi_990_: type_7;
    var phi_1012_: type_7;
    var phi_1036_: u32;
    var phi_1125_: array<array<f32, 3>, 3>;
    var phi_1242_: bool;
    var phi_1271_: bool;
    var phi_1672_: f32;
    var phi_1673_: f32;
    var phi_1674_: f32;
    var phi_1675_: f32;
    var phi_1676_: vec3<f32>;
    var phi_1677_: vec3<f32>;
    var phi_1678_: vec3<f32>;
    var phi_1679_: vec3<f32>;
    var phi_1710_: bool;
    var phi_1719_: vec3<f32>;
    var phi_1886_: bool;
    var phi_1910_: f32;
    var phi_1911_: f32;
    var phi_1934_: type_22;
    var phi_1936_: type_22;
    var phi_1937_: bool;
    var phi_1941_: type_22;
    var phi_1942_: type_22;
    var phi_1943_: type_22;
    var phi_1944_: bool;
    var phi_1948_: type_22;
    var phi_1949_: bool;
    var phi_1950_: type_22;
    var phi_1951_: bool;
    var phi_1952_: bool;
    var phi_1953_: type_22;
    var phi_1954_: bool;
    var phi_1955_: bool;
    var phi_1963_: type_22;
    var phi_1964_: bool;
    var phi_1968_: type_22;
    var phi_1993_: bool;
    var phi_1994_: bool;
    var phi_2001_: type_42;
    var phi_2002_: type_42;
    var phi_2003_: type_42;
    var phi_987_: type_42;
    var phi_3588_: bool;
    var phi_3734_: bool;
    var phi_3211_: type_42;
    var phi_3212_: type_53;
    var phi_3213_: bool;
    var phi_3214_: u32;
    var phi_3733_: bool;
    var phi_3215_: type_42;
    var phi_3216_: type_53;
    var phi_3217_: u32;
    var phi_3218_: bool;
    var phi_3219_: u32;
    var phi_3732_: bool;
    var phi_3220_: type_42;
    var phi_3221_: type_53;
    var phi_3222_: u32;
    var phi_3223_: bool;
    var phi_3224_: u32;
    var phi_3731_: bool;
    var phi_861_: type_42;
    var phi_864_: type_53;
    var phi_866_: u32;
    var phi_868_: bool;
    var phi_870_: u32;
    var phi_3225_: bool;
    var phi_3730_: bool;
    var local_10: type_42;
    var phi_3277_: type_22;
    var local_11: type_42;
    var local_12: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e84 = global;
            let _e86 = arrayLength((&global_7.member));
            let _e88 = arrayLength((&global_1.member));
            let _e96 = arrayLength((&global_6.member));
            let _e100 = global_3.member[0u][0u];
            let _e104 = global_3.member[0u][1u];
            let _e108 = global_3.member[0u][2u];
            let _e112 = global_3.member[0u][3u];
            let _e116 = global_3.member[1u][0u];
            let _e120 = global_3.member[1u][1u];
            let _e124 = global_3.member[1u][2u];
            let _e128 = (_e84.x + (_e84.y * 2097152u));
            let _e140 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e112) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e100), bitcast<i32>(_e104), bitcast<i32>(_e108));
            local = array<i32, 3>(bitcast<i32>(_e116), bitcast<i32>(_e120), bitcast<i32>(_e124));
            let _e143 = (_e128 < arrayLength((&global_4.member)));
            if _e143 {
                let _e144 = (_e128 < arrayLength((&global_2.member)));
                if _e144 {
                    let _e145 = (_e128 < arrayLength((&global_5.member)));
                    if _e145 {
                        if _e143 {
                        } else {
                            break;
                        }
                        let _e155 = global_4.member[_e128].member.member_2[0u];
                        let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                        let _e163 = global_4.member[_e128].member.member_2[1u];
                        let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                        let _e171 = global_4.member[_e128].member.member_2[2u];
                        let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                        let _e179 = global_4.member[_e128].member.member[0u];
                        let _e181 = (bitcast<u32>(_e179) & 2147483647u);
                        let _e187 = global_4.member[_e128].member.member[1u];
                        let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                        let _e195 = global_4.member[_e128].member.member[2u];
                        let _e197 = (bitcast<u32>(_e195) & 2147483647u);
                        let _e199 = select(_e165, _e157, (_e165 < _e157));
                        let _e201 = select(_e173, _e199, (_e173 < _e199));
                        let _e203 = select(_e181, _e201, (_e181 < _e201));
                        let _e205 = select(_e189, _e203, (_e189 < _e203));
                        let _e207 = select(_e197, _e205, (_e197 < _e205));
                        let _e212 = global_4.member[_e128].member.member_1;
                        let _e214 = (bitcast<u32>(_e212) & 2147483647u);
                        let _e222 = global_4.member[_e128].member.member_3;
                        let _e228 = (((select(_e214, _e207, (_e214 < _e207)) < 2139095040u) && ((bitcast<u32>(_e222) & 2147483647u) <= 2139095040u)) && (_e201 > 0u));
                        if _e228 {
                            let _e231 = (bitcast<u32>(bitcast<f32>(_e201)) & 2147483647u);
                            if (_e231 >= 8388608u) {
                                phi_393_ = (bitcast<i32>((_e231 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_393_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e231)), 32u, (_e231 == 0u))));
                            }
                            let _e245 = phi_393_;
                            phi_394_ = _e245;
                        } else {
                            phi_394_ = 0i;
                        }
                        let _e247 = phi_394_;
                        let _e248 = (_e157 == _e201);
                        if _e248 {
                            phi_404_ = true;
                        } else {
                            phi_404_ = (_e165 == _e201);
                        }
                        let _e251 = phi_404_;
                        let _e252 = select(1u, 0u, _e248);
                        if _e251 {
                            let _e253 = (_e252 + 1u);
                            phi_414_ = _e253;
                            phi_415_ = _e253;
                            phi_417_ = select(true, false, (_e253 == 2u));
                        } else {
                            phi_414_ = u32();
                            phi_415_ = 0u;
                            phi_417_ = true;
                        }
                        let _e257 = phi_414_;
                        let _e259 = phi_415_;
                        let _e261 = phi_417_;
                        if _e261 {
                            phi_422_ = (_e259 + 1u);
                        } else {
                            phi_422_ = 0u;
                        }
                        let _e265 = phi_422_;
                        let _e266 = select(_e257, _e259, _e261);
                        let _e267 = select(_e252, select(2u, _e252, _e251), _e261);
                        let _e268 = -(_e247);
                        if (_e268 < -126i) {
                            phi_454_ = -126i;
                        } else {
                            phi_454_ = select(_e268, 127i, (_e268 > 127i));
                        }
                        let _e273 = phi_454_;
                        let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                        let _e284 = bitcast<f32>((bitcast<u32>(((_e268 - _e273) + 127i)) << bitcast<u32>(23i)));
                        let _e289 = global_4.member[_e128].member.member;
                        let _e290 = (_e266 == 0u);
                        if _e290 {
                            phi_472_ = _e289[0];
                        } else {
                            phi_472_ = _e289[1];
                        }
                        let _e294 = phi_472_;
                        let _e295 = (_e266 == 2u);
                        if _e295 {
                            phi_478_ = _e289[2];
                        } else {
                            phi_478_ = _e294;
                        }
                        let _e298 = phi_478_;
                        let _e299 = global_4.member[_e128].member.member_2;
                        if _e290 {
                            phi_489_ = _e299[0];
                        } else {
                            phi_489_ = _e299[1];
                        }
                        let _e303 = phi_489_;
                        if _e295 {
                            phi_495_ = _e299[2];
                        } else {
                            phi_495_ = _e303;
                        }
                        let _e306 = phi_495_;
                        let _e308 = ((_e306 * _e278) * _e284);
                        let _e312 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e312 {
                            let _e316 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) * 0.00000011920929f);
                            phi_518_ = select(0.00000000000011368684f, _e316, (_e316 > 0.00000000000011368684f));
                        } else {
                            phi_518_ = 0f;
                        }
                        let _e320 = phi_518_;
                        let _e321 = (_e298 + _e320);
                        let _e322 = (_e298 - _e320);
                        let _e323 = select(_e308, 0f, _e312);
                        if _e312 {
                            phi_529_ = 38685626000000000000000000f;
                        } else {
                            phi_529_ = (1f / _e308);
                        }
                        let _e326 = phi_529_;
                        let _e327 = (_e265 == 0u);
                        if _e327 {
                            phi_538_ = _e289[0];
                        } else {
                            phi_538_ = _e289[1];
                        }
                        let _e331 = phi_538_;
                        let _e332 = (_e265 == 2u);
                        if _e332 {
                            phi_544_ = _e289[2];
                        } else {
                            phi_544_ = _e331;
                        }
                        let _e335 = phi_544_;
                        if _e327 {
                            phi_555_ = _e299[0];
                        } else {
                            phi_555_ = _e299[1];
                        }
                        let _e339 = phi_555_;
                        if _e332 {
                            phi_561_ = _e299[2];
                        } else {
                            phi_561_ = _e339;
                        }
                        let _e342 = phi_561_;
                        let _e344 = ((_e342 * _e278) * _e284);
                        let _e348 = (bitcast<f32>((bitcast<u32>(_e344) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e348 {
                            let _e352 = (bitcast<f32>((bitcast<u32>(_e335) & 2147483647u)) * 0.00000011920929f);
                            phi_584_ = select(0.00000000000011368684f, _e352, (_e352 > 0.00000000000011368684f));
                        } else {
                            phi_584_ = 0f;
                        }
                        let _e356 = phi_584_;
                        let _e357 = (_e335 + _e356);
                        let _e358 = (_e335 - _e356);
                        let _e359 = select(_e344, 0f, _e348);
                        if _e348 {
                            phi_595_ = 38685626000000000000000000f;
                        } else {
                            phi_595_ = (1f / _e344);
                        }
                        let _e362 = phi_595_;
                        let _e363 = (_e267 == 0u);
                        if _e363 {
                            phi_604_ = _e289[0];
                        } else {
                            phi_604_ = _e289[1];
                        }
                        let _e367 = phi_604_;
                        let _e368 = (_e267 == 2u);
                        if _e368 {
                            phi_610_ = _e289[2];
                        } else {
                            phi_610_ = _e367;
                        }
                        let _e371 = phi_610_;
                        if _e363 {
                            phi_621_ = _e299[0];
                        } else {
                            phi_621_ = _e299[1];
                        }
                        let _e375 = phi_621_;
                        if _e368 {
                            phi_627_ = _e299[2];
                        } else {
                            phi_627_ = _e375;
                        }
                        let _e378 = phi_627_;
                        let _e380 = ((_e378 * _e278) * _e284);
                        let _e384 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e384 {
                            let _e388 = (bitcast<f32>((bitcast<u32>(_e371) & 2147483647u)) * 0.00000011920929f);
                            phi_650_ = select(0.00000000000011368684f, _e388, (_e388 > 0.00000000000011368684f));
                        } else {
                            phi_650_ = 0f;
                        }
                        let _e392 = phi_650_;
                        let _e393 = (_e371 + _e392);
                        let _e394 = (_e371 - _e392);
                        let _e395 = select(_e380, 0f, _e384);
                        if _e384 {
                            phi_661_ = 38685626000000000000000000f;
                        } else {
                            phi_661_ = (1f / _e380);
                        }
                        let _e398 = phi_661_;
                        let _e401 = bitcast<f32>((bitcast<u32>(_e298) & 2147483647u));
                        let _e404 = bitcast<f32>((bitcast<u32>(_e335) & 2147483647u));
                        let _e406 = select(_e404, _e401, (_e401 > _e404));
                        let _e409 = bitcast<f32>((bitcast<u32>(_e371) & 2147483647u));
                        if (_e228 && (select(_e409, _e406, (_e406 > _e409)) <= 1099511600000f)) {
                            let _e414 = (_e247 / 3i);
                            let _e421 = bitcast<f32>((bitcast<u32>((_e414 + 127i)) << bitcast<u32>(23i)));
                            let _e428 = bitcast<f32>((bitcast<u32>(((_e247 - (2i * _e414)) + 127i)) << bitcast<u32>(23i)));
                            let _e429 = (((_e212 * _e421) * _e421) * _e428);
                            let _e431 = select(340282350000000000000000000000000000000f, _e429, (_e429 < 340282350000000000000000000000000000000f));
                            let _e436 = (((_e222 * _e421) * _e421) * _e428);
                            let _e438 = select(340282350000000000000000000000000000000f, _e436, (_e436 < 340282350000000000000000000000000000000f));
                            phi_761_ = select(-340282350000000000000000000000000000000f, _e438, (_e438 > -340282350000000000000000000000000000000f));
                            phi_762_ = select(-340282350000000000000000000000000000000f, _e431, (_e431 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_761_ = 0f;
                            phi_762_ = 1f;
                        }
                        let _e442 = phi_761_;
                        let _e444 = phi_762_;
                        if _e143 {
                        } else {
                            break;
                        }
                        let _e450 = global_4.member[_e128].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e453 = (_e266 % 3u);
                        let _e454 = (_e453 < 3u);
                        if _e454 {
                        } else {
                            break;
                        }
                        let _e456 = local_1[_e453];
                        let _e459 = (_e265 % 3u);
                        let _e460 = (_e459 < 3u);
                        if _e460 {
                        } else {
                            break;
                        }
                        let _e462 = local_1[_e459];
                        let _e465 = (_e267 % 3u);
                        let _e466 = (_e465 < 3u);
                        if _e466 {
                        } else {
                            break;
                        }
                        let _e468 = local_1[_e465];
                        if _e454 {
                        } else {
                            break;
                        }
                        let _e473 = local[_e453];
                        if _e460 {
                        } else {
                            break;
                        }
                        let _e477 = local[_e459];
                        if _e466 {
                        } else {
                            break;
                        }
                        let _e481 = local[_e465];
                        phi_3594_ = false;
                        phi_860_ = type_42(type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e442), 0u, 0u);
                        phi_863_ = type_53(type_34(vec4<f32>((f32(_e456) * _e140), (f32(_e462) * _e140), (f32(_e468) * _e140), 0f), vec4<f32>((f32(_e473) * _e140), (f32(_e477) * _e140), (f32(_e481) * _e140), 0f)), select(0u, 2147483648u, (_e86 == 0u)));
                        phi_865_ = ((3u * _e86) + 1u);
                        phi_867_ = (_e444 <= _e442);
                        phi_869_ = 0u;
                        loop {
                            let _e491 = phi_3594_;
                            let _e493 = phi_860_;
                            let _e495 = phi_863_;
                            let _e497 = phi_865_;
                            let _e499 = phi_867_;
                            let _e501 = phi_869_;
                            local_10 = _e493;
                            local_11 = _e493;
                            if _e499 {
                                phi_880_ = true;
                            } else {
                                phi_880_ = (_e501 > 0u);
                            }
                            let _e504 = phi_880_;
                            if _e504 {
                                let _e505 = (_e497 > 0u);
                                if _e505 {
                                    if _e499 {
                                        phi_966_ = _e495;
                                        phi_967_ = _e499;
                                        phi_968_ = _e501;
                                    } else {
                                        let _e506 = (_e501 - 1u);
                                        let _e507 = (_e506 % 128u);
                                        let _e508 = (_e507 < 128u);
                                        if _e508 {
                                        } else {
                                            phi_3730_ = true;
                                            break;
                                        }
                                        let _e510 = local_7[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3730_ = true;
                                            break;
                                        }
                                        let _e512 = local_6[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3730_ = true;
                                            break;
                                        }
                                        let _e514 = local_5[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3730_ = true;
                                            break;
                                        }
                                        let _e516 = local_4[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3730_ = true;
                                            break;
                                        }
                                        let _e518 = local_3[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3730_ = true;
                                            break;
                                        }
                                        let _e520 = local_2[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3730_ = true;
                                            break;
                                        }
                                        let _e525 = local_8[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3730_ = true;
                                            break;
                                        }
                                        let _e528 = local_9[_e507];
                                        phi_966_ = type_53(type_34(vec4<f32>(_e510, _e512, _e514, 0f), vec4<f32>(_e516, _e518, _e520, 0f)), _e525);
                                        phi_967_ = (_e528 <= _e493.member.member_1);
                                        phi_968_ = _e506;
                                    }
                                    let _e533 = phi_966_;
                                    let _e535 = phi_967_;
                                    let _e537 = phi_968_;
                                    if _e535 {
                                        if ((_e533.member_1 & 2147483648u) != 0u) {
                                            phi_986_ = _e493;
                                            phi_989_ = type_7(0u, ((_e533.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1006 = phi_986_;
                                                let _e1008 = phi_989_;
                                                local_12 = _e1006;
                                                if (_e1008.member < _e1008.member_1) {
                                                    phi_990_ = type_7((_e1008.member + 1u), _e1008.member_1);
                                                    phi_1012_ = type_7(1u, _e1008.member);
                                                } else {
                                                    phi_990_ = _e1008;
                                                    phi_1012_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1021 = phi_990_;
                                                let _e1023 = phi_1012_;
                                                let _e1027 = (bitcast<i32>(_e1023.member) != 0i);
                                                if _e1027 {
                                                    let _e1033 = type_42(_e1006.member, _e1006.member_1, (_e1006.member_2 + 1u));
                                                    let _e1034 = ((_e533.member_1 & 268435455u) + _e1023.member_1);
                                                    let _e1035 = (_e1034 < _e88);
                                                    if _e1035 {
                                                        if _e1035 {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1039 = global_1.member[_e1034].member_1;
                                                        phi_1036_ = _e1039;
                                                    } else {
                                                        phi_1036_ = 4294967295u;
                                                    }
                                                    let _e1041 = phi_1036_;
                                                    if (_e1034 >= _e88) {
                                                        phi_1125_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1035 {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        if (_e453 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1048 = global_1.member[_e1034].member[_e453];
                                                        if (_e459 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1054 = global_1.member[_e1034].member[_e459];
                                                        if (_e465 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1060 = global_1.member[_e1034].member[_e465];
                                                        let _e1062 = (3u + _e453);
                                                        if (_e1062 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1068 = global_1.member[_e1034].member[_e1062];
                                                        let _e1069 = (3u + _e459);
                                                        if (_e1069 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1075 = global_1.member[_e1034].member[_e1069];
                                                        let _e1076 = (3u + _e465);
                                                        if (_e1076 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1082 = global_1.member[_e1034].member[_e1076];
                                                        let _e1084 = (6u + _e453);
                                                        if (_e1084 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1090 = global_1.member[_e1034].member[_e1084];
                                                        let _e1091 = (6u + _e459);
                                                        if (_e1091 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1097 = global_1.member[_e1034].member[_e1091];
                                                        let _e1098 = (6u + _e465);
                                                        if (_e1098 < 9u) {
                                                        } else {
                                                            phi_3588_ = true;
                                                            break;
                                                        }
                                                        let _e1104 = global_1.member[_e1034].member[_e1098];
                                                        phi_1125_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1048, _e1054, _e1060), array<f32, 3>(_e1068, _e1075, _e1082), array<f32, 3>(_e1090, _e1097, _e1104));
                                                    }
                                                    let _e1108 = phi_1125_;
                                                    let _e1117 = (_e1108[0][2] - _e371);
                                                    let _e1120 = (((_e1108[0][0] - _e298) * _e395) - (_e1117 * _e323));
                                                    let _e1123 = (((_e1108[0][1] - _e335) * _e395) - (_e1117 * _e359));
                                                    let _e1130 = (_e1108[1][2] - _e371);
                                                    let _e1133 = (((_e1108[1][0] - _e298) * _e395) - (_e1130 * _e323));
                                                    let _e1136 = (((_e1108[1][1] - _e335) * _e395) - (_e1130 * _e359));
                                                    let _e1143 = (_e1108[2][2] - _e371);
                                                    let _e1146 = (((_e1108[2][0] - _e298) * _e395) - (_e1143 * _e323));
                                                    let _e1149 = (((_e1108[2][1] - _e335) * _e395) - (_e1143 * _e359));
                                                    let _e1150 = (_e1146 * _e1136);
                                                    let _e1151 = (_e1149 * _e1133);
                                                    let _e1152 = (_e1120 * _e1149);
                                                    let _e1153 = (_e1123 * _e1146);
                                                    let _e1154 = (_e1133 * _e1123);
                                                    let _e1155 = (_e1136 * _e1120);
                                                    let _e1160 = (((_e1150 >= _e1151) && (_e1152 >= _e1153)) && (_e1154 >= _e1155));
                                                    if (_e1160 || (((_e1150 <= _e1151) && (_e1152 <= _e1153)) && (_e1154 <= _e1155))) {
                                                        let _e1167 = select(-1f, 1f, _e1160);
                                                        let _e1169 = ((_e1150 - _e1151) * _e1167);
                                                        let _e1171 = select(0f, _e1169, (_e1169 > 0f));
                                                        let _e1173 = ((_e1152 - _e1153) * _e1167);
                                                        let _e1175 = select(0f, _e1173, (_e1173 > 0f));
                                                        let _e1177 = ((_e1154 - _e1155) * _e1167);
                                                        let _e1179 = select(0f, _e1177, (_e1177 > 0f));
                                                        let _e1181 = ((_e1171 + _e1175) + _e1179);
                                                        if (_e1181 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1953_ = type_22();
                                                            phi_1954_ = true;
                                                            phi_1955_ = false;
                                                        } else {
                                                            let _e1184 = select(_e1133, _e1120, (_e1120 < _e1133));
                                                            if (select(_e1146, _e1184, (_e1184 < _e1146)) > 0f) {
                                                                phi_1242_ = true;
                                                            } else {
                                                                let _e1189 = select(_e1133, _e1120, (_e1120 > _e1133));
                                                                phi_1242_ = (select(_e1146, _e1189, (_e1189 > _e1146)) < 0f);
                                                            }
                                                            let _e1194 = phi_1242_;
                                                            if _e1194 {
                                                                phi_1950_ = type_22();
                                                                phi_1951_ = true;
                                                                phi_1952_ = false;
                                                            } else {
                                                                let _e1196 = select(_e1136, _e1123, (_e1123 < _e1136));
                                                                if (select(_e1149, _e1196, (_e1196 < _e1149)) > 0f) {
                                                                    phi_1271_ = true;
                                                                } else {
                                                                    let _e1201 = select(_e1136, _e1123, (_e1123 > _e1136));
                                                                    phi_1271_ = (select(_e1149, _e1201, (_e1201 > _e1149)) < 0f);
                                                                }
                                                                let _e1206 = phi_1271_;
                                                                if _e1206 {
                                                                    phi_1948_ = type_22();
                                                                    phi_1949_ = false;
                                                                } else {
                                                                    let _e1208 = select(_e1108[1][0], _e1108[0][0], (_e1108[0][0] < _e1108[1][0]));
                                                                    let _e1212 = select(_e1108[1][0], _e1108[0][0], (_e1108[0][0] > _e1108[1][0]));
                                                                    let _e1216 = select(_e1108[1][1], _e1108[0][1], (_e1108[0][1] < _e1108[1][1]));
                                                                    let _e1220 = select(_e1108[1][1], _e1108[0][1], (_e1108[0][1] > _e1108[1][1]));
                                                                    let _e1224 = select(_e1108[1][2], _e1108[0][2], (_e1108[0][2] < _e1108[1][2]));
                                                                    let _e1228 = select(_e1108[1][2], _e1108[0][2], (_e1108[0][2] > _e1108[1][2]));
                                                                    let _e1233 = ((select(_e1108[2][0], _e1208, (_e1208 < _e1108[2][0])) - _e321) * _e326);
                                                                    let _e1234 = ((select(_e1108[2][0], _e1212, (_e1212 > _e1108[2][0])) - _e322) * _e326);
                                                                    let _e1237 = ((select(_e1108[2][1], _e1216, (_e1216 < _e1108[2][1])) - _e357) * _e362);
                                                                    let _e1238 = ((select(_e1108[2][1], _e1220, (_e1220 > _e1108[2][1])) - _e358) * _e362);
                                                                    let _e1241 = ((select(_e1108[2][2], _e1224, (_e1224 < _e1108[2][2])) - _e393) * _e398);
                                                                    let _e1242 = ((select(_e1108[2][2], _e1228, (_e1228 > _e1108[2][2])) - _e394) * _e398);
                                                                    let _e1244 = select(_e1242, _e1241, (_e1241 < _e1242));
                                                                    let _e1246 = select(_e1242, _e1241, (_e1241 > _e1242));
                                                                    let _e1248 = select(_e1234, _e1233, (_e1233 < _e1234));
                                                                    let _e1250 = select(_e1238, _e1237, (_e1237 < _e1238));
                                                                    let _e1252 = select(_e1250, _e1248, (_e1248 > _e1250));
                                                                    let _e1254 = select(_e1244, _e1252, (_e1252 > _e1244));
                                                                    let _e1256 = select(_e1234, _e1233, (_e1233 > _e1234));
                                                                    let _e1258 = select(_e1238, _e1237, (_e1237 > _e1238));
                                                                    let _e1260 = select(_e1258, _e1256, (_e1256 < _e1258));
                                                                    let _e1262 = select(_e1246, _e1260, (_e1260 < _e1246));
                                                                    let _e1263 = -(_e1244);
                                                                    let _e1269 = select(_e444, _e1254, (_e1254 > _e444));
                                                                    if (_e1269 > (_e1262 + (select(_e1263, _e1246, (_e1246 > _e1263)) * 0.0000019073523f))) {
                                                                        phi_1943_ = type_22();
                                                                        phi_1944_ = true;
                                                                    } else {
                                                                        let _e1271 = (_e1269 > _e1006.member.member_1);
                                                                        if _e1271 {
                                                                            phi_1942_ = type_22();
                                                                        } else {
                                                                            let _e1272 = vec3<f32>(_e1108[0][0], _e1108[0][1], _e1108[0][2]);
                                                                            let _e1273 = vec3<f32>(_e1108[1][0], _e1108[1][1], _e1108[1][2]);
                                                                            let _e1274 = vec3<f32>(_e1108[2][0], _e1108[2][1], _e1108[2][2]);
                                                                            let _e1275 = (_e1108[1][0] - _e1108[0][0]);
                                                                            let _e1276 = (_e1108[1][1] - _e1108[0][1]);
                                                                            let _e1277 = (_e1108[1][2] - _e1108[0][2]);
                                                                            let _e1278 = vec3<f32>(_e1275, _e1276, _e1277);
                                                                            let _e1279 = (_e1108[2][0] - _e1108[1][0]);
                                                                            let _e1280 = (_e1108[2][1] - _e1108[1][1]);
                                                                            let _e1281 = (_e1108[2][2] - _e1108[1][2]);
                                                                            let _e1282 = vec3<f32>(_e1279, _e1280, _e1281);
                                                                            let _e1283 = (_e1108[0][0] - _e1108[2][0]);
                                                                            let _e1284 = (_e1108[0][1] - _e1108[2][1]);
                                                                            let _e1285 = (_e1108[0][2] - _e1108[2][2]);
                                                                            let _e1286 = vec3<f32>(_e1283, _e1284, _e1285);
                                                                            let _e1289 = bitcast<f32>((bitcast<u32>(_e1275) & 2147483647u));
                                                                            let _e1292 = bitcast<f32>((bitcast<u32>(_e1276) & 2147483647u));
                                                                            let _e1294 = select(_e1292, _e1289, (_e1289 > _e1292));
                                                                            let _e1297 = bitcast<f32>((bitcast<u32>(_e1277) & 2147483647u));
                                                                            let _e1299 = select(_e1297, _e1294, (_e1294 > _e1297));
                                                                            let _e1302 = bitcast<f32>((bitcast<u32>(_e1279) & 2147483647u));
                                                                            let _e1305 = bitcast<f32>((bitcast<u32>(_e1280) & 2147483647u));
                                                                            let _e1307 = select(_e1305, _e1302, (_e1302 > _e1305));
                                                                            let _e1310 = bitcast<f32>((bitcast<u32>(_e1281) & 2147483647u));
                                                                            let _e1312 = select(_e1310, _e1307, (_e1307 > _e1310));
                                                                            let _e1315 = bitcast<f32>((bitcast<u32>(_e1283) & 2147483647u));
                                                                            let _e1318 = bitcast<f32>((bitcast<u32>(_e1284) & 2147483647u));
                                                                            let _e1320 = select(_e1318, _e1315, (_e1315 > _e1318));
                                                                            let _e1323 = bitcast<f32>((bitcast<u32>(_e1285) & 2147483647u));
                                                                            let _e1325 = select(_e1323, _e1320, (_e1320 > _e1323));
                                                                            let _e1327 = select(_e1312, _e1299, (_e1299 > _e1312));
                                                                            let _e1329 = select(_e1325, _e1327, (_e1327 > _e1325));
                                                                            if (_e1299 == _e1329) {
                                                                                phi_1672_ = _e1136;
                                                                                phi_1673_ = _e1133;
                                                                                phi_1674_ = _e1123;
                                                                                phi_1675_ = _e1120;
                                                                                phi_1676_ = _e1272;
                                                                                phi_1677_ = _e1286;
                                                                                phi_1678_ = _e1282;
                                                                                phi_1679_ = _e1278;
                                                                            } else {
                                                                                let _e1331 = (_e1312 == _e1329);
                                                                                let _e1336 = vec3(_e1331);
                                                                                phi_1672_ = select(_e1123, _e1149, _e1331);
                                                                                phi_1673_ = select(_e1120, _e1146, _e1331);
                                                                                phi_1674_ = select(_e1149, _e1136, _e1331);
                                                                                phi_1675_ = select(_e1146, _e1133, _e1331);
                                                                                phi_1676_ = select(_e1274, _e1273, _e1336);
                                                                                phi_1677_ = select(_e1282, _e1278, _e1336);
                                                                                phi_1678_ = select(_e1278, _e1286, _e1336);
                                                                                phi_1679_ = select(_e1286, _e1282, _e1336);
                                                                            }
                                                                            let _e1342 = phi_1672_;
                                                                            let _e1344 = phi_1673_;
                                                                            let _e1346 = phi_1674_;
                                                                            let _e1348 = phi_1675_;
                                                                            let _e1350 = phi_1676_;
                                                                            let _e1352 = phi_1677_;
                                                                            let _e1354 = phi_1678_;
                                                                            let _e1356 = phi_1679_;
                                                                            let _e1363 = ((_e1354.y * _e1352.z) - (_e1352.y * _e1354.z));
                                                                            let _e1368 = ((_e1354.z * _e1352.x) - (_e1352.z * _e1354.x));
                                                                            let _e1371 = ((_e1354.x * _e1352.y) - (_e1352.x * _e1354.y));
                                                                            if (_e1171 >= _e1175) {
                                                                                phi_1710_ = select(true, false, (_e1171 >= _e1179));
                                                                            } else {
                                                                                phi_1710_ = true;
                                                                            }
                                                                            let _e1376 = phi_1710_;
                                                                            if _e1376 {
                                                                                phi_1719_ = select(_e1274, _e1273, vec3((_e1175 >= _e1179)));
                                                                            } else {
                                                                                phi_1719_ = _e1272;
                                                                            }
                                                                            let _e1381 = phi_1719_;
                                                                            let _e1386 = (((_e1363 * _e323) + (_e1368 * _e359)) + (_e1371 * _e395));
                                                                            let _e1397 = (((_e1363 * (_e1381.x - _e298)) + (_e1368 * (_e1381.y - _e335))) + (_e1371 * (_e1381.z - _e371)));
                                                                            let _e1399 = (_e1344 - _e1348);
                                                                            let _e1400 = (_e1342 - _e1346);
                                                                            let _e1408 = (-(((_e1348 * _e1399) + (_e1346 * _e1400))) / ((_e1399 * _e1399) + (_e1400 * _e1400)));
                                                                            let _e1410 = select(1f, _e1408, (_e1408 < 1f));
                                                                            let _e1412 = select(0f, _e1410, (_e1410 > 0f));
                                                                            let _e1425 = ((_e1350.x + (_e1356.x * _e1412)) - _e298);
                                                                            let _e1426 = ((_e1350.y + (_e1356.y * _e1412)) - _e335);
                                                                            let _e1427 = ((_e1350.z + (_e1356.z * _e1412)) - _e371);
                                                                            let _e1428 = (_e1427 / _e395);
                                                                            let _e1440 = bitcast<f32>((bitcast<u32>(_e1425) & 2147483647u));
                                                                            let _e1443 = bitcast<f32>((bitcast<u32>(_e1426) & 2147483647u));
                                                                            let _e1445 = select(_e1443, _e1440, (_e1440 > _e1443));
                                                                            let _e1448 = bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u));
                                                                            let _e1450 = select(_e1448, _e1445, (_e1445 > _e1448));
                                                                            let _e1456 = bitcast<f32>((bitcast<u32>(_e1363) & 2147483647u));
                                                                            let _e1459 = bitcast<f32>((bitcast<u32>(_e1368) & 2147483647u));
                                                                            let _e1461 = select(_e1459, _e1456, (_e1456 > _e1459));
                                                                            let _e1464 = bitcast<f32>((bitcast<u32>(_e1371) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1363 * _e1425) + (_e1368 * _e1426)) + (_e1371 * _e1427)) - _e1397)) & 2147483647u)) <= ((0.0000009536743f * select(_e1329, _e1450, (_e1450 > _e1329))) * select(_e1464, _e1461, (_e1461 > _e1464)))) {
                                                                                let _e1474 = bitcast<f32>((bitcast<u32>(_e1354.x) & 2147483647u));
                                                                                let _e1477 = bitcast<f32>((bitcast<u32>(_e1354.y) & 2147483647u));
                                                                                let _e1479 = select(_e1477, _e1474, (_e1474 > _e1477));
                                                                                let _e1482 = bitcast<f32>((bitcast<u32>(_e1354.z) & 2147483647u));
                                                                                let _e1488 = bitcast<f32>((bitcast<u32>(_e1352.x) & 2147483647u));
                                                                                let _e1491 = bitcast<f32>((bitcast<u32>(_e1352.y) & 2147483647u));
                                                                                let _e1493 = select(_e1491, _e1488, (_e1488 > _e1491));
                                                                                let _e1496 = bitcast<f32>((bitcast<u32>(_e1352.z) & 2147483647u));
                                                                                phi_1886_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1386) & 2147483647u)) > ((0.0000038146973f * select(_e1482, _e1479, (_e1479 > _e1482))) * select(_e1496, _e1493, (_e1493 > _e1496)))));
                                                                            } else {
                                                                                phi_1886_ = true;
                                                                            }
                                                                            let _e1503 = phi_1886_;
                                                                            if _e1503 {
                                                                                let _e1514 = ((((_e1363 * (_e1425 - (_e323 * _e1428))) + (_e1368 * (_e1426 - (_e359 * _e1428)))) + (_e1371 * (_e1427 - _e1427))) / _e1386);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1514) & 2147483647u)) <= _e1329) {
                                                                                    phi_1910_ = (_e1428 + _e1514);
                                                                                } else {
                                                                                    phi_1910_ = _e1428;
                                                                                }
                                                                                let _e1521 = phi_1910_;
                                                                                phi_1911_ = _e1521;
                                                                            } else {
                                                                                phi_1911_ = (_e1397 / _e1386);
                                                                            }
                                                                            let _e1523 = phi_1911_;
                                                                            let _e1525 = select(_e1262, _e1523, (_e1523 < _e1262));
                                                                            let _e1527 = select(_e1254, _e1525, (_e1525 > _e1254));
                                                                            if (_e1527 >= _e444) {
                                                                                let _e1529 = (_e1527 <= _e1006.member.member_1);
                                                                                if _e1529 {
                                                                                    let _e1530 = (1f / _e1181);
                                                                                    phi_1934_ = type_22(_e1527, (_e1175 * _e1530), (_e1179 * _e1530), _e1041);
                                                                                } else {
                                                                                    phi_1934_ = type_22();
                                                                                }
                                                                                let _e1535 = phi_1934_;
                                                                                phi_1936_ = _e1535;
                                                                                phi_1937_ = select(true, false, _e1529);
                                                                            } else {
                                                                                phi_1936_ = type_22();
                                                                                phi_1937_ = true;
                                                                            }
                                                                            let _e1538 = phi_1936_;
                                                                            let _e1540 = phi_1937_;
                                                                            if _e1540 {
                                                                                phi_1941_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_1941_ = _e1538;
                                                                            }
                                                                            let _e1542 = phi_1941_;
                                                                            phi_1942_ = _e1542;
                                                                        }
                                                                        let _e1544 = phi_1942_;
                                                                        phi_1943_ = _e1544;
                                                                        phi_1944_ = _e1271;
                                                                    }
                                                                    let _e1546 = phi_1943_;
                                                                    let _e1548 = phi_1944_;
                                                                    phi_1948_ = _e1546;
                                                                    phi_1949_ = _e1548;
                                                                }
                                                                let _e1550 = phi_1948_;
                                                                let _e1552 = phi_1949_;
                                                                phi_1950_ = _e1550;
                                                                phi_1951_ = _e1206;
                                                                phi_1952_ = _e1552;
                                                            }
                                                            let _e1554 = phi_1950_;
                                                            let _e1556 = phi_1951_;
                                                            let _e1558 = phi_1952_;
                                                            phi_1953_ = _e1554;
                                                            phi_1954_ = _e1556;
                                                            phi_1955_ = _e1558;
                                                        }
                                                        let _e1560 = phi_1953_;
                                                        let _e1562 = phi_1954_;
                                                        let _e1564 = phi_1955_;
                                                        phi_1963_ = _e1560;
                                                        phi_1964_ = select(_e1564, true, _e1562);
                                                    } else {
                                                        phi_1963_ = type_22();
                                                        phi_1964_ = true;
                                                    }
                                                    let _e1567 = phi_1963_;
                                                    let _e1569 = phi_1964_;
                                                    if _e1569 {
                                                        phi_1968_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1968_ = _e1567;
                                                    }
                                                    let _e1571 = phi_1968_;
                                                    if (_e1571.member_3 != 4294967295u) {
                                                        if (_e1041 != _e450) {
                                                            if (_e1571.member < _e1006.member.member.member) {
                                                                phi_1994_ = true;
                                                            } else {
                                                                if (_e1571.member == _e1006.member.member.member) {
                                                                    phi_1993_ = (_e1571.member_3 < _e1006.member.member.member_3);
                                                                } else {
                                                                    phi_1993_ = false;
                                                                }
                                                                let _e1586 = phi_1993_;
                                                                phi_1994_ = _e1586;
                                                            }
                                                            let _e1588 = phi_1994_;
                                                            if _e1588 {
                                                                phi_2001_ = type_42(type_38(_e1571, _e1571.member), _e1033.member_1, _e1033.member_2);
                                                            } else {
                                                                phi_2001_ = _e1033;
                                                            }
                                                            let _e1595 = phi_2001_;
                                                            phi_2002_ = _e1595;
                                                        } else {
                                                            phi_2002_ = _e1033;
                                                        }
                                                        let _e1597 = phi_2002_;
                                                        phi_2003_ = _e1597;
                                                    } else {
                                                        phi_2003_ = _e1033;
                                                    }
                                                    let _e1599 = phi_2003_;
                                                    phi_987_ = _e1599;
                                                } else {
                                                    phi_987_ = type_42();
                                                }
                                                let _e1601 = phi_987_;
                                                continue;
                                                continuing {
                                                    phi_986_ = _e1601;
                                                    phi_989_ = _e1021;
                                                    phi_3588_ = _e491;
                                                    break if !(_e1027);
                                                }
                                            }
                                            let _e1604 = phi_3588_;
                                            phi_3730_ = _e1604;
                                            if _e1604 {
                                                break;
                                            }
                                            phi_3734_ = _e1604;
                                            let _e1838 = local_12;
                                            phi_3211_ = _e1838;
                                            phi_3212_ = _e533;
                                            phi_3213_ = false;
                                            phi_3214_ = _e537;
                                        } else {
                                            if (_e533.member_1 >= _e86) {
                                                phi_2767_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e533.member_1 < _e86) {
                                                } else {
                                                    phi_3730_ = true;
                                                    break;
                                                }
                                                let _e554 = (_e266 * 2u);
                                                let _e556 = ((1u + _e554) % 7u);
                                                if (_e556 < 7u) {
                                                } else {
                                                    phi_3730_ = true;
                                                    break;
                                                }
                                                let _e561 = global_7.member[_e533.member_1][_e556];
                                                let _e563 = ((_e554 + 2u) % 7u);
                                                if (_e563 < 7u) {
                                                } else {
                                                    phi_3730_ = true;
                                                    break;
                                                }
                                                let _e568 = global_7.member[_e533.member_1][_e563];
                                                let _e569 = (_e265 * 2u);
                                                let _e571 = ((1u + _e569) % 7u);
                                                if (_e571 < 7u) {
                                                } else {
                                                    phi_3730_ = true;
                                                    break;
                                                }
                                                let _e576 = global_7.member[_e533.member_1][_e571];
                                                let _e578 = ((_e569 + 2u) % 7u);
                                                if (_e578 < 7u) {
                                                } else {
                                                    phi_3730_ = true;
                                                    break;
                                                }
                                                let _e583 = global_7.member[_e533.member_1][_e578];
                                                let _e584 = (_e267 * 2u);
                                                let _e586 = ((1u + _e584) % 7u);
                                                if (_e586 < 7u) {
                                                } else {
                                                    phi_3730_ = true;
                                                    break;
                                                }
                                                let _e591 = global_7.member[_e533.member_1][_e586];
                                                let _e593 = ((_e584 + 2u) % 7u);
                                                if (_e593 < 7u) {
                                                } else {
                                                    phi_3730_ = true;
                                                    break;
                                                }
                                                let _e598 = global_7.member[_e533.member_1][_e593];
                                                let _e621 = (bitcast<f32>((bitcast<u32>((_e533.member.member_1.x - _e533.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e622 = (bitcast<f32>((bitcast<u32>((_e533.member.member_1.y - _e533.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e623 = (bitcast<f32>((bitcast<u32>((_e533.member.member_1.z - _e533.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e625 = select(_e140, _e621, (_e621 > _e140));
                                                let _e627 = select(_e140, _e622, (_e622 > _e140));
                                                let _e629 = select(_e140, _e623, (_e623 > _e140));
                                                let _e654 = bitcast<u32>((f32(bitcast<i32>((_e561 & 2097151u))) * _e625));
                                                let _e659 = (bitcast<i32>((_e561 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e662 = bitcast<f32>((_e654 & bitcast<u32>(_e659)));
                                                let _e663 = bitcast<u32>((f32(bitcast<i32>((_e576 & 2097151u))) * _e627));
                                                let _e668 = (bitcast<i32>((_e576 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e671 = bitcast<f32>((_e663 & bitcast<u32>(_e668)));
                                                let _e672 = bitcast<u32>((f32(bitcast<i32>((_e591 & 2097151u))) * _e629));
                                                let _e677 = (bitcast<i32>((_e591 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e680 = bitcast<f32>((_e672 & bitcast<u32>(_e677)));
                                                let _e684 = bitcast<f32>((_e654 & bitcast<u32>(~(_e659))));
                                                let _e688 = bitcast<f32>((_e663 & bitcast<u32>(~(_e668))));
                                                let _e692 = bitcast<f32>((_e672 & bitcast<u32>(~(_e677))));
                                                let _e693 = bitcast<u32>((f32(bitcast<i32>((_e568 & 2097151u))) * _e625));
                                                let _e698 = (bitcast<i32>((_e568 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e701 = bitcast<f32>((_e693 & bitcast<u32>(_e698)));
                                                let _e702 = bitcast<u32>((f32(bitcast<i32>((_e583 & 2097151u))) * _e627));
                                                let _e707 = (bitcast<i32>((_e583 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e710 = bitcast<f32>((_e702 & bitcast<u32>(_e707)));
                                                let _e711 = bitcast<u32>((f32(bitcast<i32>((_e598 & 2097151u))) * _e629));
                                                let _e716 = (bitcast<i32>((_e598 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e719 = bitcast<f32>((_e711 & bitcast<u32>(_e716)));
                                                let _e723 = bitcast<f32>((_e693 & bitcast<u32>(~(_e698))));
                                                let _e727 = bitcast<f32>((_e702 & bitcast<u32>(~(_e707))));
                                                let _e731 = bitcast<f32>((_e711 & bitcast<u32>(~(_e716))));
                                                let _e761 = global_7.member[_e533.member_1][0u];
                                                let _e765 = global_7.member[_e533.member_1][2u];
                                                let _e769 = global_7.member[_e533.member_1][4u];
                                                let _e773 = global_7.member[_e533.member_1][6u];
                                                let _e785 = (((_e765 >> bitcast<u32>(22i)) | ((_e769 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e773 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e786 = (_e761 & 268435455u);
                                                let _e787 = (_e785 & 268435455u);
                                                let _e790 = ((_e761 >> bitcast<u32>(28u)) & 7u);
                                                let _e798 = ((_e761 >> bitcast<u32>(31i)) | (((_e785 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e799 = (_e790 != 0u);
                                                if (_e790 == 0u) {
                                                    phi_2729_ = _e786;
                                                } else {
                                                    if (_e790 == 7u) {
                                                        phi_2728_ = 2147483648u;
                                                    } else {
                                                        phi_2728_ = ((2147483648u | (_e790 << bitcast<u32>(28u))) | (_e787 & 268435455u));
                                                    }
                                                    let _e808 = phi_2728_;
                                                    phi_2729_ = _e808;
                                                }
                                                let _e810 = phi_2729_;
                                                if _e799 {
                                                    let _e811 = (_e790 != 7u);
                                                    if _e811 {
                                                        phi_2739_ = (_e787 + _e790);
                                                    } else {
                                                        phi_2739_ = u32();
                                                    }
                                                    let _e814 = phi_2739_;
                                                    phi_2741_ = _e814;
                                                    phi_2742_ = select(true, false, _e811);
                                                } else {
                                                    phi_2741_ = u32();
                                                    phi_2742_ = true;
                                                }
                                                let _e817 = phi_2741_;
                                                let _e819 = phi_2742_;
                                                if (_e798 == 0u) {
                                                    phi_2763_ = (_e786 + select(0u, 1u, !(_e799)));
                                                } else {
                                                    if (_e798 == 7u) {
                                                        phi_2762_ = 2147483648u;
                                                    } else {
                                                        phi_2762_ = ((2147483648u | (_e798 << bitcast<u32>(28u))) | (select(_e817, _e787, _e819) & 268435455u));
                                                    }
                                                    let _e832 = phi_2762_;
                                                    phi_2763_ = _e832;
                                                }
                                                let _e834 = phi_2763_;
                                                phi_2767_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e533.member.member.x + _e662), (_e533.member.member.x + _e684), (_e533.member.member_1.x - _e701), (_e533.member.member_1.x - _e723)), vec4<f32>((_e533.member.member.y + _e671), (_e533.member.member.y + _e688), (_e533.member.member_1.y - _e710), (_e533.member.member_1.y - _e727)), vec4<f32>((_e533.member.member.z + _e680), (_e533.member.member.z + _e692), (_e533.member.member_1.z - _e719), (_e533.member.member_1.z - _e731))), type_53(type_34((_e533.member.member + vec4<f32>(_e662, _e671, _e680, 0f)), (_e533.member.member_1 - vec4<f32>(_e701, _e710, _e719, 0f))), _e810), type_53(type_34((_e533.member.member + vec4<f32>(_e684, _e688, _e692, 0f)), (_e533.member.member_1 - vec4<f32>(_e723, _e727, _e731, 0f))), _e834));
                                            }
                                            let _e839 = phi_2767_;
                                            let _e852 = ((_e839.member[0].x - _e321) * _e326);
                                            let _e853 = ((_e839.member[0].y - _e321) * _e326);
                                            let _e854 = ((_e839.member[0].z - _e322) * _e326);
                                            let _e855 = ((_e839.member[0].w - _e322) * _e326);
                                            let _e865 = ((_e839.member[1].x - _e357) * _e362);
                                            let _e866 = ((_e839.member[1].y - _e357) * _e362);
                                            let _e867 = ((_e839.member[1].z - _e358) * _e362);
                                            let _e868 = ((_e839.member[1].w - _e358) * _e362);
                                            let _e878 = ((_e839.member[2].x - _e393) * _e398);
                                            let _e879 = ((_e839.member[2].y - _e393) * _e398);
                                            let _e880 = ((_e839.member[2].z - _e394) * _e398);
                                            let _e881 = ((_e839.member[2].w - _e394) * _e398);
                                            let _e883 = select(_e880, _e878, (_e878 < _e880));
                                            let _e885 = select(_e881, _e879, (_e879 < _e881));
                                            let _e887 = select(_e880, _e878, (_e878 > _e880));
                                            let _e889 = select(_e881, _e879, (_e879 > _e881));
                                            let _e891 = select(_e854, _e852, (_e852 < _e854));
                                            let _e893 = select(_e855, _e853, (_e853 < _e855));
                                            let _e895 = select(_e867, _e865, (_e865 < _e867));
                                            let _e897 = select(_e868, _e866, (_e866 < _e868));
                                            let _e899 = select(_e895, _e891, (_e891 > _e895));
                                            let _e901 = select(_e897, _e893, (_e893 > _e897));
                                            let _e903 = select(_e883, _e899, (_e899 > _e883));
                                            let _e905 = select(_e885, _e901, (_e901 > _e885));
                                            let _e907 = select(_e854, _e852, (_e852 > _e854));
                                            let _e909 = select(_e855, _e853, (_e853 > _e855));
                                            let _e911 = select(_e867, _e865, (_e865 > _e867));
                                            let _e913 = select(_e868, _e866, (_e866 > _e868));
                                            let _e915 = select(_e911, _e907, (_e907 < _e911));
                                            let _e917 = select(_e913, _e909, (_e909 < _e913));
                                            let _e922 = -(_e883);
                                            let _e923 = -(_e885);
                                            let _e930 = (select(_e887, _e915, (_e915 < _e887)) + (select(_e922, _e887, (_e887 > _e922)) * 0.0000019073523f));
                                            let _e931 = (select(_e889, _e917, (_e917 < _e889)) + (select(_e923, _e889, (_e889 > _e923)) * 0.0000019073523f));
                                            let _e933 = select(_e444, _e903, (_e903 > _e444));
                                            let _e935 = select(_e444, _e905, (_e905 > _e444));
                                            let _e940 = (_e933 <= select(_e493.member.member_1, _e930, (_e930 < _e493.member.member_1)));
                                            let _e941 = (_e935 <= select(_e493.member.member_1, _e931, (_e931 < _e493.member.member_1)));
                                            let _e942 = (_e933 <= _e935);
                                            if _e940 {
                                                if _e941 {
                                                    if _e942 {
                                                        phi_3111_ = _e839.member_2;
                                                    } else {
                                                        phi_3111_ = _e839.member_1;
                                                    }
                                                    let _e946 = phi_3111_;
                                                    let _e968 = (_e537 % 128u);
                                                    let _e969 = (_e968 < 128u);
                                                    if _e969 {
                                                    } else {
                                                        phi_3730_ = true;
                                                        break;
                                                    }
                                                    local_8[_e968] = _e946.member_1;
                                                    if _e969 {
                                                    } else {
                                                        phi_3730_ = true;
                                                        break;
                                                    }
                                                    local_7[_e968] = _e946.member.member.x;
                                                    if _e969 {
                                                    } else {
                                                        phi_3730_ = true;
                                                        break;
                                                    }
                                                    local_6[_e968] = _e946.member.member.y;
                                                    if _e969 {
                                                    } else {
                                                        phi_3730_ = true;
                                                        break;
                                                    }
                                                    local_5[_e968] = _e946.member.member.z;
                                                    if _e969 {
                                                    } else {
                                                        phi_3730_ = true;
                                                        break;
                                                    }
                                                    local_4[_e968] = _e946.member.member_1.x;
                                                    if _e969 {
                                                    } else {
                                                        phi_3730_ = true;
                                                        break;
                                                    }
                                                    local_3[_e968] = _e946.member.member_1.y;
                                                    if _e969 {
                                                    } else {
                                                        phi_3730_ = true;
                                                        break;
                                                    }
                                                    local_2[_e968] = _e946.member.member_1.z;
                                                    if _e969 {
                                                    } else {
                                                        phi_3730_ = true;
                                                        break;
                                                    }
                                                    local_9[_e968] = select(_e935, _e933, (_e933 > _e935));
                                                    if _e942 {
                                                        phi_3188_ = _e839.member_1;
                                                    } else {
                                                        phi_3188_ = _e839.member_2;
                                                    }
                                                    let _e982 = phi_3188_;
                                                    phi_3189_ = _e982;
                                                    phi_3190_ = (_e537 + 1u);
                                                } else {
                                                    phi_3189_ = type_53();
                                                    phi_3190_ = u32();
                                                }
                                                let _e984 = phi_3189_;
                                                let _e986 = phi_3190_;
                                                phi_3192_ = _e984;
                                                phi_3193_ = _e986;
                                                phi_3194_ = select(true, false, _e941);
                                            } else {
                                                phi_3192_ = type_53();
                                                phi_3193_ = u32();
                                                phi_3194_ = true;
                                            }
                                            let _e989 = phi_3192_;
                                            let _e991 = phi_3193_;
                                            let _e993 = phi_3194_;
                                            if _e993 {
                                                if _e940 {
                                                    phi_3203_ = _e839.member_1;
                                                } else {
                                                    phi_3203_ = _e839.member_2;
                                                }
                                                let _e997 = phi_3203_;
                                                phi_3208_ = _e997;
                                                phi_3209_ = select(_e941, true, _e940);
                                            } else {
                                                phi_3208_ = _e989;
                                                phi_3209_ = _e535;
                                            }
                                            let _e1000 = phi_3208_;
                                            let _e1002 = phi_3209_;
                                            phi_3734_ = _e491;
                                            phi_3211_ = type_42(_e493.member, (_e493.member_1 + 1u), _e493.member_2);
                                            phi_3212_ = _e1000;
                                            phi_3213_ = _e1002;
                                            phi_3214_ = select(_e991, _e537, _e993);
                                        }
                                        let _e1606 = phi_3734_;
                                        let _e1608 = phi_3211_;
                                        let _e1610 = phi_3212_;
                                        let _e1612 = phi_3213_;
                                        let _e1614 = phi_3214_;
                                        phi_3733_ = _e1606;
                                        phi_3215_ = _e1608;
                                        phi_3216_ = _e1610;
                                        phi_3217_ = (_e497 - 1u);
                                        phi_3218_ = _e1612;
                                        phi_3219_ = _e1614;
                                    } else {
                                        phi_3733_ = _e491;
                                        phi_3215_ = _e493;
                                        phi_3216_ = _e533;
                                        phi_3217_ = _e497;
                                        phi_3218_ = _e535;
                                        phi_3219_ = _e537;
                                    }
                                    let _e1616 = phi_3733_;
                                    let _e1618 = phi_3215_;
                                    let _e1620 = phi_3216_;
                                    let _e1622 = phi_3217_;
                                    let _e1624 = phi_3218_;
                                    let _e1626 = phi_3219_;
                                    phi_3732_ = _e1616;
                                    phi_3220_ = _e1618;
                                    phi_3221_ = _e1620;
                                    phi_3222_ = _e1622;
                                    phi_3223_ = _e1624;
                                    phi_3224_ = _e1626;
                                } else {
                                    phi_3732_ = _e491;
                                    phi_3220_ = type_42();
                                    phi_3221_ = type_53();
                                    phi_3222_ = u32();
                                    phi_3223_ = bool();
                                    phi_3224_ = u32();
                                }
                                let _e1628 = phi_3732_;
                                let _e1630 = phi_3220_;
                                let _e1632 = phi_3221_;
                                let _e1634 = phi_3222_;
                                let _e1636 = phi_3223_;
                                let _e1638 = phi_3224_;
                                phi_3731_ = _e1628;
                                phi_861_ = _e1630;
                                phi_864_ = _e1632;
                                phi_866_ = _e1634;
                                phi_868_ = _e1636;
                                phi_870_ = _e1638;
                                phi_3225_ = _e505;
                            } else {
                                phi_3731_ = _e491;
                                phi_861_ = type_42();
                                phi_864_ = type_53();
                                phi_866_ = u32();
                                phi_868_ = bool();
                                phi_870_ = u32();
                                phi_3225_ = false;
                            }
                            let _e1640 = phi_3731_;
                            let _e1642 = phi_861_;
                            let _e1644 = phi_864_;
                            let _e1646 = phi_866_;
                            let _e1648 = phi_868_;
                            let _e1650 = phi_870_;
                            let _e1652 = phi_3225_;
                            continue;
                            continuing {
                                phi_3594_ = _e1640;
                                phi_860_ = _e1642;
                                phi_863_ = _e1644;
                                phi_865_ = _e1646;
                                phi_867_ = _e1648;
                                phi_869_ = _e1650;
                                phi_3730_ = _e1640;
                                break if !(_e1652);
                            }
                        }
                        let _e1655 = phi_3730_;
                        if _e1655 {
                            break;
                        }
                        let _e1657 = local_10;
                        if (_e1657.member.member.member_3 != 4294967295u) {
                            let _e1663 = (_e268 / 3i);
                            let _e1670 = bitcast<f32>((bitcast<u32>((_e1663 + 127i)) << bitcast<u32>(23i)));
                            let _e1678 = (((_e1657.member.member.member * _e1670) * _e1670) * bitcast<f32>((bitcast<u32>(((_e268 - (2i * _e1663)) + 127i)) << bitcast<u32>(23i))));
                            let _e1680 = select(340282350000000000000000000000000000000f, _e1678, (_e1678 < 340282350000000000000000000000000000000f));
                            phi_3277_ = type_22(select(-340282350000000000000000000000000000000f, _e1680, (_e1680 > -340282350000000000000000000000000000000f)), _e1657.member.member.member_1, _e1657.member.member.member_2, _e1657.member.member.member_3);
                        } else {
                            phi_3277_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1687 = phi_3277_;
                        if _e144 {
                        } else {
                            break;
                        }
                        global_2.member[_e128] = _e1687;
                        let _e1691 = local_11;
                        if _e145 {
                        } else {
                            break;
                        }
                        global_5.member[_e128] = _e1691.member_1;
                        if _e143 {
                        } else {
                            break;
                        }
                        let _e1696 = select(0u, 1u, (_e212 <= _e222));
                        if (_e1696 > 0u) {
                            let _e1698 = (1u < _e96);
                            if _e1698 {
                                if (0u < _e96) {
                                } else {
                                    break;
                                }
                                let _e1702 = atomicAdd((&global_6.member[0u]), _e1696);
                                if ((_e1702 + _e1696) < _e1702) {
                                    if _e1698 {
                                    } else {
                                        break;
                                    }
                                    let _e1707 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1710 = select(0u, 1u, (_e1687.member_3 != 4294967295u));
                        if (_e1710 > 0u) {
                            let _e1712 = (3u < _e96);
                            if _e1712 {
                                if (2u < _e96) {
                                } else {
                                    break;
                                }
                                let _e1716 = atomicAdd((&global_6.member[2u]), _e1710);
                                if ((_e1716 + _e1710) < _e1716) {
                                    if _e1712 {
                                    } else {
                                        break;
                                    }
                                    let _e1721 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1691.member_1 > 0u) {
                            let _e1723 = (5u < _e96);
                            if _e1723 {
                                if (4u < _e96) {
                                } else {
                                    break;
                                }
                                let _e1727 = atomicAdd((&global_6.member[4u]), _e1691.member_1);
                                if ((_e1727 + _e1691.member_1) < _e1727) {
                                    if _e1723 {
                                    } else {
                                        break;
                                    }
                                    let _e1732 = atomicAdd((&global_6.member[5u]), 1u);
                                }
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
fn trace_paths_counted_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
