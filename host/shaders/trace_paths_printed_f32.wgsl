struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_34 {
    member: array<type_32>,
}

struct type_40 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_43 {
    member: type_27,
    member_1: f32,
}

struct type_47 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: array<i32>,
}

struct type_54 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_56 {
    member: array<type_54>,
}

struct type_59 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_61 {
    member: type_59,
    member_1: u32,
}

struct type_66 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_47;
@group(0) @binding(2) 
var<uniform> global_3: type_47;
@group(0) @binding(4) 
var<storage> global_4: type_20;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_50;
@group(0) @binding(7) 
var<storage> global_7: type_34;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_29;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_66;
@group(0) @binding(3) 
var<storage> global_10: type_56;

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
    var phi_272_: u32;
    var phi_316_: i32;
    var phi_340_: type_40;
    var phi_446_: i32;
    var phi_447_: i32;
    var phi_457_: bool;
    var phi_467_: u32;
    var phi_468_: u32;
    var phi_470_: bool;
    var phi_475_: u32;
    var phi_507_: i32;
    var phi_525_: f32;
    var phi_531_: f32;
    var phi_542_: f32;
    var phi_548_: f32;
    var phi_571_: f32;
    var phi_582_: f32;
    var phi_591_: f32;
    var phi_597_: f32;
    var phi_608_: f32;
    var phi_614_: f32;
    var phi_637_: f32;
    var phi_648_: f32;
    var phi_657_: f32;
    var phi_663_: f32;
    var phi_674_: f32;
    var phi_680_: f32;
    var phi_703_: f32;
    var phi_714_: f32;
    var phi_814_: f32;
    var phi_815_: f32;
    var phi_3492_: bool;
    var phi_888_: type_43;
    var phi_891_: type_61;
    var phi_893_: u32;
    var phi_895_: bool;
    var phi_897_: u32;
    var phi_908_: bool;
    var phi_994_: type_61;
    var phi_995_: bool;
    var phi_996_: u32;
    var phi_2369_: type_54;
    var phi_3201_: type_61;
    var phi_3278_: type_61;
    var phi_3279_: type_61;
    var phi_3280_: u32;
    var phi_3282_: type_61;
    var phi_3283_: u32;
    var phi_3284_: bool;
    var phi_3291_: type_61;
    var phi_3296_: type_61;
    var phi_3297_: bool;
    var phi_1014_: type_43;
    var phi_1017_: type_8;
    var phi_1018_: type_8;
    var phi_1040_: type_8;
    var phi_1061_: u32;
    var phi_1150_: array<array<f32, 3>, 3>;
    var phi_1267_: bool;
    var phi_1296_: bool;
    var phi_1697_: f32;
    var phi_1698_: f32;
    var phi_1699_: f32;
    var phi_1700_: f32;
    var phi_1701_: vec3<f32>;
    var phi_1702_: vec3<f32>;
    var phi_1703_: vec3<f32>;
    var phi_1704_: vec3<f32>;
    var phi_1735_: bool;
    var phi_1744_: vec3<f32>;
    var phi_1911_: bool;
    var phi_1935_: f32;
    var phi_1936_: f32;
    var phi_1959_: type_27;
    var phi_1961_: type_27;
    var phi_1962_: bool;
    var phi_1966_: type_27;
    var phi_1967_: type_27;
    var phi_1968_: type_27;
    var phi_1969_: bool;
    var phi_1973_: type_27;
    var phi_1974_: bool;
    var phi_1975_: type_27;
    var phi_1976_: bool;
    var phi_1977_: bool;
    var phi_1978_: type_27;
    var phi_1979_: bool;
    var phi_1980_: bool;
    var phi_1988_: type_27;
    var phi_1989_: bool;
    var phi_1993_: type_27;
    var phi_2016_: u32;
    var phi_2030_: i32;
    var phi_2050_: vec3<f32>;
    var phi_2051_: vec3<f32>;
    var phi_2067_: vec3<f32>;
    var phi_2068_: vec3<f32>;
    var phi_2084_: vec3<f32>;
    var phi_2085_: vec3<f32>;
    var phi_2121_: vec3<f32>;
    var phi_2303_: f32;
    var phi_2321_: bool;
    var phi_2322_: bool;
    var phi_2341_: bool;
    var phi_2342_: bool;
    var phi_2348_: type_43;
    var phi_2349_: type_43;
    var phi_2350_: type_43;
    var phi_1015_: type_43;
    var phi_3486_: bool;
    var phi_3656_: bool;
    var phi_3299_: type_43;
    var phi_3300_: type_61;
    var phi_3301_: bool;
    var phi_3302_: u32;
    var phi_3655_: bool;
    var phi_3303_: type_43;
    var phi_3304_: type_61;
    var phi_3305_: u32;
    var phi_3306_: bool;
    var phi_3307_: u32;
    var phi_3654_: bool;
    var phi_3308_: type_43;
    var phi_3309_: type_61;
    var phi_3310_: u32;
    var phi_3311_: bool;
    var phi_3312_: u32;
    var phi_3653_: bool;
    var phi_889_: type_43;
    var phi_892_: type_61;
    var phi_894_: u32;
    var phi_896_: bool;
    var phi_898_: u32;
    var phi_3313_: bool;
    var phi_3652_: bool;
    var local_10: type_43;
    var phi_3365_: type_27;
    var local_11: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e90 = arrayLength((&global_10.member));
            let _e92 = arrayLength((&global_4.member));
            let _e104 = arrayLength((&global_9.member));
            let _e108 = global_3.member[0u][0u];
            let _e112 = global_3.member[0u][1u];
            let _e116 = global_3.member[0u][2u];
            let _e120 = global_3.member[1u][0u];
            let _e124 = global_3.member[1u][1u];
            let _e128 = global_3.member[1u][2u];
            let _e132 = global_3.member[1u][3u];
            let _e136 = (_e87.x + (_e87.y * 2097152u));
            let _e143 = (_e136 < arrayLength((&global_7.member)));
            if _e143 {
                if _e143 {
                } else {
                    break;
                }
                let _e147 = global_7.member[_e136].member_2;
                phi_272_ = _e147;
            } else {
                phi_272_ = 4294967295u;
            }
            let _e149 = phi_272_;
            let _e152 = global_1.member[0u];
            let _e156 = global_2.member[0u][0u];
            let _e160 = global_2.member[0u][1u];
            let _e164 = global_2.member[0u][2u];
            let _e168 = global_2.member[0u][3u];
            let _e172 = global_2.member[1u][0u];
            let _e176 = global_2.member[1u][1u];
            let _e180 = global_2.member[1u][2u];
            let _e184 = global_2.member[1u][3u];
            let _e185 = bitcast<f32>(_e156);
            let _e186 = bitcast<f32>(_e160);
            let _e187 = bitcast<f32>(_e164);
            let _e189 = bitcast<f32>(_e172);
            let _e190 = array<u32, 3>(_e176, _e180, _e184);
            let _e192 = bitcast<i32>(_e152);
            if (_e192 < -126i) {
                phi_316_ = -126i;
            } else {
                phi_316_ = select(_e192, 127i, (_e192 > 127i));
            }
            let _e197 = phi_316_;
            let _e202 = bitcast<f32>((bitcast<u32>((_e197 + 127i)) << bitcast<u32>(23i)));
            let _e208 = bitcast<f32>((bitcast<u32>(((_e192 - _e197) + 127i)) << bitcast<u32>(23i)));
            if (_e168 == 0u) {
                phi_340_ = type_40(array<f32, 3>(_e185, _e186, _e187), _e168, _e189, _e190);
            } else {
                phi_340_ = type_40(array<f32, 3>(((_e185 * _e202) * _e208), ((_e186 * _e202) * _e208), ((_e187 * _e202) * _e208)), _e168, ((_e189 * _e202) * _e208), _e190);
            }
            let _e221 = phi_340_;
            if _e143 {
                let _e222 = (_e136 < arrayLength((&global_8.member)));
                if _e222 {
                    if _e143 {
                    } else {
                        break;
                    }
                    let _e232 = global_7.member[_e136].member.member_2[0u];
                    let _e234 = (bitcast<u32>(_e232) & 2147483647u);
                    let _e240 = global_7.member[_e136].member.member_2[1u];
                    let _e242 = (bitcast<u32>(_e240) & 2147483647u);
                    let _e248 = global_7.member[_e136].member.member_2[2u];
                    let _e250 = (bitcast<u32>(_e248) & 2147483647u);
                    let _e256 = global_7.member[_e136].member.member[0u];
                    let _e258 = (bitcast<u32>(_e256) & 2147483647u);
                    let _e264 = global_7.member[_e136].member.member[1u];
                    let _e266 = (bitcast<u32>(_e264) & 2147483647u);
                    let _e272 = global_7.member[_e136].member.member[2u];
                    let _e274 = (bitcast<u32>(_e272) & 2147483647u);
                    let _e276 = select(_e242, _e234, (_e242 < _e234));
                    let _e278 = select(_e250, _e276, (_e250 < _e276));
                    let _e280 = select(_e258, _e278, (_e258 < _e278));
                    let _e282 = select(_e266, _e280, (_e266 < _e280));
                    let _e284 = select(_e274, _e282, (_e274 < _e282));
                    let _e289 = global_7.member[_e136].member.member_1;
                    let _e291 = (bitcast<u32>(_e289) & 2147483647u);
                    let _e299 = global_7.member[_e136].member.member_3;
                    let _e305 = (((select(_e291, _e284, (_e291 < _e284)) < 2139095040u) && ((bitcast<u32>(_e299) & 2147483647u) <= 2139095040u)) && (_e278 > 0u));
                    if _e305 {
                        let _e308 = (bitcast<u32>(bitcast<f32>(_e278)) & 2147483647u);
                        if (_e308 >= 8388608u) {
                            phi_446_ = (bitcast<i32>((_e308 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_446_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e308)), 32u, (_e308 == 0u))));
                        }
                        let _e322 = phi_446_;
                        phi_447_ = _e322;
                    } else {
                        phi_447_ = 0i;
                    }
                    let _e324 = phi_447_;
                    let _e325 = (_e234 == _e278);
                    if _e325 {
                        phi_457_ = true;
                    } else {
                        phi_457_ = (_e242 == _e278);
                    }
                    let _e328 = phi_457_;
                    let _e329 = select(1u, 0u, _e325);
                    if _e328 {
                        let _e330 = (_e329 + 1u);
                        phi_467_ = _e330;
                        phi_468_ = _e330;
                        phi_470_ = select(true, false, (_e330 == 2u));
                    } else {
                        phi_467_ = u32();
                        phi_468_ = 0u;
                        phi_470_ = true;
                    }
                    let _e334 = phi_467_;
                    let _e336 = phi_468_;
                    let _e338 = phi_470_;
                    if _e338 {
                        phi_475_ = (_e336 + 1u);
                    } else {
                        phi_475_ = 0u;
                    }
                    let _e342 = phi_475_;
                    let _e343 = select(_e334, _e336, _e338);
                    let _e344 = select(_e329, select(2u, _e329, _e328), _e338);
                    let _e345 = -(_e324);
                    if (_e345 < -126i) {
                        phi_507_ = -126i;
                    } else {
                        phi_507_ = select(_e345, 127i, (_e345 > 127i));
                    }
                    let _e350 = phi_507_;
                    let _e355 = bitcast<f32>((bitcast<u32>((_e350 + 127i)) << bitcast<u32>(23i)));
                    let _e361 = bitcast<f32>((bitcast<u32>(((_e345 - _e350) + 127i)) << bitcast<u32>(23i)));
                    let _e366 = global_7.member[_e136].member.member;
                    let _e367 = (_e343 == 0u);
                    if _e367 {
                        phi_525_ = _e366[0];
                    } else {
                        phi_525_ = _e366[1];
                    }
                    let _e371 = phi_525_;
                    let _e372 = (_e343 == 2u);
                    if _e372 {
                        phi_531_ = _e366[2];
                    } else {
                        phi_531_ = _e371;
                    }
                    let _e375 = phi_531_;
                    let _e376 = global_7.member[_e136].member.member_2;
                    if _e367 {
                        phi_542_ = _e376[0];
                    } else {
                        phi_542_ = _e376[1];
                    }
                    let _e380 = phi_542_;
                    if _e372 {
                        phi_548_ = _e376[2];
                    } else {
                        phi_548_ = _e380;
                    }
                    let _e383 = phi_548_;
                    let _e385 = ((_e383 * _e355) * _e361);
                    let _e389 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e389 {
                        let _e393 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) * 0.00000011920929f);
                        phi_571_ = select(0.00000000000011368684f, _e393, (_e393 > 0.00000000000011368684f));
                    } else {
                        phi_571_ = 0f;
                    }
                    let _e397 = phi_571_;
                    let _e398 = (_e375 + _e397);
                    let _e399 = (_e375 - _e397);
                    let _e400 = select(_e385, 0f, _e389);
                    if _e389 {
                        phi_582_ = 38685626000000000000000000f;
                    } else {
                        phi_582_ = (1f / _e385);
                    }
                    let _e403 = phi_582_;
                    let _e404 = (_e342 == 0u);
                    if _e404 {
                        phi_591_ = _e366[0];
                    } else {
                        phi_591_ = _e366[1];
                    }
                    let _e408 = phi_591_;
                    let _e409 = (_e342 == 2u);
                    if _e409 {
                        phi_597_ = _e366[2];
                    } else {
                        phi_597_ = _e408;
                    }
                    let _e412 = phi_597_;
                    if _e404 {
                        phi_608_ = _e376[0];
                    } else {
                        phi_608_ = _e376[1];
                    }
                    let _e416 = phi_608_;
                    if _e409 {
                        phi_614_ = _e376[2];
                    } else {
                        phi_614_ = _e416;
                    }
                    let _e419 = phi_614_;
                    let _e421 = ((_e419 * _e355) * _e361);
                    let _e425 = (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e425 {
                        let _e429 = (bitcast<f32>((bitcast<u32>(_e412) & 2147483647u)) * 0.00000011920929f);
                        phi_637_ = select(0.00000000000011368684f, _e429, (_e429 > 0.00000000000011368684f));
                    } else {
                        phi_637_ = 0f;
                    }
                    let _e433 = phi_637_;
                    let _e434 = (_e412 + _e433);
                    let _e435 = (_e412 - _e433);
                    let _e436 = select(_e421, 0f, _e425);
                    if _e425 {
                        phi_648_ = 38685626000000000000000000f;
                    } else {
                        phi_648_ = (1f / _e421);
                    }
                    let _e439 = phi_648_;
                    let _e440 = (_e344 == 0u);
                    if _e440 {
                        phi_657_ = _e366[0];
                    } else {
                        phi_657_ = _e366[1];
                    }
                    let _e444 = phi_657_;
                    let _e445 = (_e344 == 2u);
                    if _e445 {
                        phi_663_ = _e366[2];
                    } else {
                        phi_663_ = _e444;
                    }
                    let _e448 = phi_663_;
                    if _e440 {
                        phi_674_ = _e376[0];
                    } else {
                        phi_674_ = _e376[1];
                    }
                    let _e452 = phi_674_;
                    if _e445 {
                        phi_680_ = _e376[2];
                    } else {
                        phi_680_ = _e452;
                    }
                    let _e455 = phi_680_;
                    let _e457 = ((_e455 * _e355) * _e361);
                    let _e461 = (bitcast<f32>((bitcast<u32>(_e457) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e461 {
                        let _e465 = (bitcast<f32>((bitcast<u32>(_e448) & 2147483647u)) * 0.00000011920929f);
                        phi_703_ = select(0.00000000000011368684f, _e465, (_e465 > 0.00000000000011368684f));
                    } else {
                        phi_703_ = 0f;
                    }
                    let _e469 = phi_703_;
                    let _e470 = (_e448 + _e469);
                    let _e471 = (_e448 - _e469);
                    let _e472 = select(_e457, 0f, _e461);
                    if _e461 {
                        phi_714_ = 38685626000000000000000000f;
                    } else {
                        phi_714_ = (1f / _e457);
                    }
                    let _e475 = phi_714_;
                    let _e478 = bitcast<f32>((bitcast<u32>(_e375) & 2147483647u));
                    let _e481 = bitcast<f32>((bitcast<u32>(_e412) & 2147483647u));
                    let _e483 = select(_e481, _e478, (_e478 > _e481));
                    let _e486 = bitcast<f32>((bitcast<u32>(_e448) & 2147483647u));
                    if (_e305 && (select(_e486, _e483, (_e483 > _e486)) <= 1099511600000f)) {
                        let _e491 = (_e324 / 3i);
                        let _e498 = bitcast<f32>((bitcast<u32>((_e491 + 127i)) << bitcast<u32>(23i)));
                        let _e505 = bitcast<f32>((bitcast<u32>(((_e324 - (2i * _e491)) + 127i)) << bitcast<u32>(23i)));
                        let _e506 = (((_e289 * _e498) * _e498) * _e505);
                        let _e508 = select(340282350000000000000000000000000000000f, _e506, (_e506 < 340282350000000000000000000000000000000f));
                        let _e513 = (((_e299 * _e498) * _e498) * _e505);
                        let _e515 = select(340282350000000000000000000000000000000f, _e513, (_e513 < 340282350000000000000000000000000000000f));
                        phi_814_ = select(-340282350000000000000000000000000000000f, _e515, (_e515 > -340282350000000000000000000000000000000f));
                        phi_815_ = select(-340282350000000000000000000000000000000f, _e508, (_e508 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_814_ = 0f;
                        phi_815_ = 1f;
                    }
                    let _e519 = phi_814_;
                    let _e521 = phi_815_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e108), bitcast<f32>(_e112), bitcast<f32>(_e116));
                    let _e526 = (_e343 % 3u);
                    let _e527 = (_e526 < 3u);
                    if _e527 {
                    } else {
                        break;
                    }
                    let _e529 = local_9[_e526];
                    let _e530 = (_e342 % 3u);
                    let _e531 = (_e530 < 3u);
                    if _e531 {
                    } else {
                        break;
                    }
                    let _e533 = local_9[_e530];
                    let _e534 = (_e344 % 3u);
                    let _e535 = (_e534 < 3u);
                    if _e535 {
                    } else {
                        break;
                    }
                    let _e537 = local_9[_e534];
                    local_8 = array<f32, 3>(bitcast<f32>(_e120), bitcast<f32>(_e124), bitcast<f32>(_e128));
                    if _e527 {
                    } else {
                        break;
                    }
                    let _e541 = local_8[_e526];
                    if _e531 {
                    } else {
                        break;
                    }
                    let _e543 = local_8[_e530];
                    if _e535 {
                    } else {
                        break;
                    }
                    let _e545 = local_8[_e534];
                    phi_3492_ = false;
                    phi_888_ = type_43(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e519);
                    phi_891_ = type_61(type_59(array<f32, 3>(_e529, _e533, _e537), array<f32, 3>(_e541, _e543, _e545)), select(0u, 2147483648u, (_e90 == 0u)));
                    phi_893_ = ((3u * _e90) + 1u);
                    phi_895_ = (_e521 <= _e519);
                    phi_897_ = 0u;
                    loop {
                        let _e553 = phi_3492_;
                        let _e555 = phi_888_;
                        let _e557 = phi_891_;
                        let _e559 = phi_893_;
                        let _e561 = phi_895_;
                        let _e563 = phi_897_;
                        local_10 = _e555;
                        if _e561 {
                            phi_908_ = true;
                        } else {
                            phi_908_ = (_e563 > 0u);
                        }
                        let _e566 = phi_908_;
                        if _e566 {
                            let _e567 = (_e559 > 0u);
                            if _e567 {
                                if _e561 {
                                    phi_994_ = _e557;
                                    phi_995_ = _e561;
                                    phi_996_ = _e563;
                                } else {
                                    let _e568 = (_e563 - 1u);
                                    let _e569 = (_e568 % 128u);
                                    let _e570 = (_e569 < 128u);
                                    if _e570 {
                                    } else {
                                        phi_3652_ = true;
                                        break;
                                    }
                                    let _e572 = local_6[_e569];
                                    if _e570 {
                                    } else {
                                        phi_3652_ = true;
                                        break;
                                    }
                                    let _e574 = local_5[_e569];
                                    if _e570 {
                                    } else {
                                        phi_3652_ = true;
                                        break;
                                    }
                                    let _e576 = local_4[_e569];
                                    if _e570 {
                                    } else {
                                        phi_3652_ = true;
                                        break;
                                    }
                                    let _e578 = local_3[_e569];
                                    if _e570 {
                                    } else {
                                        phi_3652_ = true;
                                        break;
                                    }
                                    let _e581 = local_2[_e569];
                                    if _e570 {
                                    } else {
                                        phi_3652_ = true;
                                        break;
                                    }
                                    let _e583 = local_1[_e569];
                                    if _e570 {
                                    } else {
                                        phi_3652_ = true;
                                        break;
                                    }
                                    let _e585 = local[_e569];
                                    if _e570 {
                                    } else {
                                        phi_3652_ = true;
                                        break;
                                    }
                                    let _e590 = local_7[_e569];
                                    phi_994_ = type_61(type_59(array<f32, 3>(_e574, _e576, _e578), array<f32, 3>(_e581, _e583, _e585)), _e572);
                                    phi_995_ = (_e590 <= _e555.member_1);
                                    phi_996_ = _e568;
                                }
                                let _e594 = phi_994_;
                                let _e596 = phi_995_;
                                let _e598 = phi_996_;
                                if _e596 {
                                    if ((_e594.member_1 & 2147483648u) != 0u) {
                                        phi_1014_ = _e555;
                                        phi_1017_ = type_8(0u, ((_e594.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e950 = phi_1014_;
                                            let _e952 = phi_1017_;
                                            local_11 = _e950;
                                            if (_e952.member < _e952.member_1) {
                                                phi_1018_ = type_8((_e952.member + 1u), _e952.member_1);
                                                phi_1040_ = type_8(1u, _e952.member);
                                            } else {
                                                phi_1018_ = _e952;
                                                phi_1040_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e965 = phi_1018_;
                                            let _e967 = phi_1040_;
                                            let _e971 = (bitcast<i32>(_e967.member) != 0i);
                                            if _e971 {
                                                let _e972 = ((_e594.member_1 & 268435455u) + _e967.member_1);
                                                let _e973 = (_e972 < _e92);
                                                if _e973 {
                                                    if _e973 {
                                                    } else {
                                                        phi_3486_ = true;
                                                        break;
                                                    }
                                                    let _e977 = global_4.member[_e972].member_1;
                                                    phi_1061_ = _e977;
                                                } else {
                                                    phi_1061_ = 4294967295u;
                                                }
                                                let _e979 = phi_1061_;
                                                if (_e972 >= _e92) {
                                                    phi_1150_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e973 {
                                                    } else {
                                                        phi_3486_ = true;
                                                        break;
                                                    }
                                                    if (_e526 < 9u) {
                                                    } else {
                                                        phi_3486_ = true;
                                                        break;
                                                    }
                                                    let _e986 = global_4.member[_e972].member[_e526];
                                                    if (_e530 < 9u) {
                                                    } else {
                                                        phi_3486_ = true;
                                                        break;
                                                    }
                                                    let _e992 = global_4.member[_e972].member[_e530];
                                                    if (_e534 < 9u) {
                                                    } else {
                                                        phi_3486_ = true;
                                                        break;
                                                    }
                                                    let _e998 = global_4.member[_e972].member[_e534];
                                                    let _e1000 = (3u + _e526);
                                                    if (_e1000 < 9u) {
                                                    } else {
                                                        phi_3486_ = true;
                                                        break;
                                                    }
                                                    let _e1006 = global_4.member[_e972].member[_e1000];
                                                    let _e1007 = (3u + _e530);
                                                    if (_e1007 < 9u) {
                                                    } else {
                                                        phi_3486_ = true;
                                                        break;
                                                    }
                                                    let _e1013 = global_4.member[_e972].member[_e1007];
                                                    let _e1014 = (3u + _e534);
                                                    if (_e1014 < 9u) {
                                                    } else {
                                                        phi_3486_ = true;
                                                        break;
                                                    }
                                                    let _e1020 = global_4.member[_e972].member[_e1014];
                                                    let _e1022 = (6u + _e526);
                                                    if (_e1022 < 9u) {
                                                    } else {
                                                        phi_3486_ = true;
                                                        break;
                                                    }
                                                    let _e1028 = global_4.member[_e972].member[_e1022];
                                                    let _e1029 = (6u + _e530);
                                                    if (_e1029 < 9u) {
                                                    } else {
                                                        phi_3486_ = true;
                                                        break;
                                                    }
                                                    let _e1035 = global_4.member[_e972].member[_e1029];
                                                    let _e1036 = (6u + _e534);
                                                    if (_e1036 < 9u) {
                                                    } else {
                                                        phi_3486_ = true;
                                                        break;
                                                    }
                                                    let _e1042 = global_4.member[_e972].member[_e1036];
                                                    phi_1150_ = array<array<f32, 3>, 3>(array<f32, 3>(_e986, _e992, _e998), array<f32, 3>(_e1006, _e1013, _e1020), array<f32, 3>(_e1028, _e1035, _e1042));
                                                }
                                                let _e1046 = phi_1150_;
                                                let _e1054 = (_e1046[0][2] - _e448);
                                                let _e1057 = (((_e1046[0][0] - _e375) * _e472) - (_e1054 * _e400));
                                                let _e1060 = (((_e1046[0][1] - _e412) * _e472) - (_e1054 * _e436));
                                                let _e1067 = (_e1046[1][2] - _e448);
                                                let _e1070 = (((_e1046[1][0] - _e375) * _e472) - (_e1067 * _e400));
                                                let _e1073 = (((_e1046[1][1] - _e412) * _e472) - (_e1067 * _e436));
                                                let _e1080 = (_e1046[2][2] - _e448);
                                                let _e1083 = (((_e1046[2][0] - _e375) * _e472) - (_e1080 * _e400));
                                                let _e1086 = (((_e1046[2][1] - _e412) * _e472) - (_e1080 * _e436));
                                                let _e1087 = (_e1083 * _e1073);
                                                let _e1088 = (_e1086 * _e1070);
                                                let _e1089 = (_e1057 * _e1086);
                                                let _e1090 = (_e1060 * _e1083);
                                                let _e1091 = (_e1070 * _e1060);
                                                let _e1092 = (_e1073 * _e1057);
                                                let _e1097 = (((_e1087 >= _e1088) && (_e1089 >= _e1090)) && (_e1091 >= _e1092));
                                                if (_e1097 || (((_e1087 <= _e1088) && (_e1089 <= _e1090)) && (_e1091 <= _e1092))) {
                                                    let _e1104 = select(-1f, 1f, _e1097);
                                                    let _e1106 = ((_e1087 - _e1088) * _e1104);
                                                    let _e1108 = select(0f, _e1106, (_e1106 > 0f));
                                                    let _e1110 = ((_e1089 - _e1090) * _e1104);
                                                    let _e1112 = select(0f, _e1110, (_e1110 > 0f));
                                                    let _e1114 = ((_e1091 - _e1092) * _e1104);
                                                    let _e1116 = select(0f, _e1114, (_e1114 > 0f));
                                                    let _e1118 = ((_e1108 + _e1112) + _e1116);
                                                    if (_e1118 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1978_ = type_27();
                                                        phi_1979_ = true;
                                                        phi_1980_ = false;
                                                    } else {
                                                        let _e1121 = select(_e1070, _e1057, (_e1057 < _e1070));
                                                        if (select(_e1083, _e1121, (_e1121 < _e1083)) > 0f) {
                                                            phi_1267_ = true;
                                                        } else {
                                                            let _e1126 = select(_e1070, _e1057, (_e1057 > _e1070));
                                                            phi_1267_ = (select(_e1083, _e1126, (_e1126 > _e1083)) < 0f);
                                                        }
                                                        let _e1131 = phi_1267_;
                                                        if _e1131 {
                                                            phi_1975_ = type_27();
                                                            phi_1976_ = true;
                                                            phi_1977_ = false;
                                                        } else {
                                                            let _e1133 = select(_e1073, _e1060, (_e1060 < _e1073));
                                                            if (select(_e1086, _e1133, (_e1133 < _e1086)) > 0f) {
                                                                phi_1296_ = true;
                                                            } else {
                                                                let _e1138 = select(_e1073, _e1060, (_e1060 > _e1073));
                                                                phi_1296_ = (select(_e1086, _e1138, (_e1138 > _e1086)) < 0f);
                                                            }
                                                            let _e1143 = phi_1296_;
                                                            if _e1143 {
                                                                phi_1973_ = type_27();
                                                                phi_1974_ = false;
                                                            } else {
                                                                let _e1145 = select(_e1046[1][0], _e1046[0][0], (_e1046[0][0] < _e1046[1][0]));
                                                                let _e1149 = select(_e1046[1][0], _e1046[0][0], (_e1046[0][0] > _e1046[1][0]));
                                                                let _e1153 = select(_e1046[1][1], _e1046[0][1], (_e1046[0][1] < _e1046[1][1]));
                                                                let _e1157 = select(_e1046[1][1], _e1046[0][1], (_e1046[0][1] > _e1046[1][1]));
                                                                let _e1161 = select(_e1046[1][2], _e1046[0][2], (_e1046[0][2] < _e1046[1][2]));
                                                                let _e1165 = select(_e1046[1][2], _e1046[0][2], (_e1046[0][2] > _e1046[1][2]));
                                                                let _e1170 = ((select(_e1046[2][0], _e1145, (_e1145 < _e1046[2][0])) - _e398) * _e403);
                                                                let _e1171 = ((select(_e1046[2][0], _e1149, (_e1149 > _e1046[2][0])) - _e399) * _e403);
                                                                let _e1174 = ((select(_e1046[2][1], _e1153, (_e1153 < _e1046[2][1])) - _e434) * _e439);
                                                                let _e1175 = ((select(_e1046[2][1], _e1157, (_e1157 > _e1046[2][1])) - _e435) * _e439);
                                                                let _e1178 = ((select(_e1046[2][2], _e1161, (_e1161 < _e1046[2][2])) - _e470) * _e475);
                                                                let _e1179 = ((select(_e1046[2][2], _e1165, (_e1165 > _e1046[2][2])) - _e471) * _e475);
                                                                let _e1181 = select(_e1179, _e1178, (_e1178 < _e1179));
                                                                let _e1183 = select(_e1179, _e1178, (_e1178 > _e1179));
                                                                let _e1185 = select(_e1171, _e1170, (_e1170 < _e1171));
                                                                let _e1187 = select(_e1175, _e1174, (_e1174 < _e1175));
                                                                let _e1189 = select(_e1187, _e1185, (_e1185 > _e1187));
                                                                let _e1191 = select(_e1181, _e1189, (_e1189 > _e1181));
                                                                let _e1193 = select(_e1171, _e1170, (_e1170 > _e1171));
                                                                let _e1195 = select(_e1175, _e1174, (_e1174 > _e1175));
                                                                let _e1197 = select(_e1195, _e1193, (_e1193 < _e1195));
                                                                let _e1199 = select(_e1183, _e1197, (_e1197 < _e1183));
                                                                let _e1200 = -(_e1181);
                                                                let _e1206 = select(_e521, _e1191, (_e1191 > _e521));
                                                                if (_e1206 > (_e1199 + (select(_e1200, _e1183, (_e1183 > _e1200)) * 0.0000019073523f))) {
                                                                    phi_1968_ = type_27();
                                                                    phi_1969_ = true;
                                                                } else {
                                                                    let _e1208 = (_e1206 > _e950.member_1);
                                                                    if _e1208 {
                                                                        phi_1967_ = type_27();
                                                                    } else {
                                                                        let _e1209 = vec3<f32>(_e1046[0][0], _e1046[0][1], _e1046[0][2]);
                                                                        let _e1210 = vec3<f32>(_e1046[1][0], _e1046[1][1], _e1046[1][2]);
                                                                        let _e1211 = vec3<f32>(_e1046[2][0], _e1046[2][1], _e1046[2][2]);
                                                                        let _e1212 = (_e1046[1][0] - _e1046[0][0]);
                                                                        let _e1213 = (_e1046[1][1] - _e1046[0][1]);
                                                                        let _e1214 = (_e1046[1][2] - _e1046[0][2]);
                                                                        let _e1215 = vec3<f32>(_e1212, _e1213, _e1214);
                                                                        let _e1216 = (_e1046[2][0] - _e1046[1][0]);
                                                                        let _e1217 = (_e1046[2][1] - _e1046[1][1]);
                                                                        let _e1218 = (_e1046[2][2] - _e1046[1][2]);
                                                                        let _e1219 = vec3<f32>(_e1216, _e1217, _e1218);
                                                                        let _e1220 = (_e1046[0][0] - _e1046[2][0]);
                                                                        let _e1221 = (_e1046[0][1] - _e1046[2][1]);
                                                                        let _e1222 = (_e1046[0][2] - _e1046[2][2]);
                                                                        let _e1223 = vec3<f32>(_e1220, _e1221, _e1222);
                                                                        let _e1226 = bitcast<f32>((bitcast<u32>(_e1212) & 2147483647u));
                                                                        let _e1229 = bitcast<f32>((bitcast<u32>(_e1213) & 2147483647u));
                                                                        let _e1231 = select(_e1229, _e1226, (_e1226 > _e1229));
                                                                        let _e1234 = bitcast<f32>((bitcast<u32>(_e1214) & 2147483647u));
                                                                        let _e1236 = select(_e1234, _e1231, (_e1231 > _e1234));
                                                                        let _e1239 = bitcast<f32>((bitcast<u32>(_e1216) & 2147483647u));
                                                                        let _e1242 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                        let _e1244 = select(_e1242, _e1239, (_e1239 > _e1242));
                                                                        let _e1247 = bitcast<f32>((bitcast<u32>(_e1218) & 2147483647u));
                                                                        let _e1249 = select(_e1247, _e1244, (_e1244 > _e1247));
                                                                        let _e1252 = bitcast<f32>((bitcast<u32>(_e1220) & 2147483647u));
                                                                        let _e1255 = bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u));
                                                                        let _e1257 = select(_e1255, _e1252, (_e1252 > _e1255));
                                                                        let _e1260 = bitcast<f32>((bitcast<u32>(_e1222) & 2147483647u));
                                                                        let _e1262 = select(_e1260, _e1257, (_e1257 > _e1260));
                                                                        let _e1264 = select(_e1249, _e1236, (_e1236 > _e1249));
                                                                        let _e1266 = select(_e1262, _e1264, (_e1264 > _e1262));
                                                                        if (_e1236 == _e1266) {
                                                                            phi_1697_ = _e1073;
                                                                            phi_1698_ = _e1070;
                                                                            phi_1699_ = _e1060;
                                                                            phi_1700_ = _e1057;
                                                                            phi_1701_ = _e1209;
                                                                            phi_1702_ = _e1223;
                                                                            phi_1703_ = _e1219;
                                                                            phi_1704_ = _e1215;
                                                                        } else {
                                                                            let _e1268 = (_e1249 == _e1266);
                                                                            let _e1273 = vec3(_e1268);
                                                                            phi_1697_ = select(_e1060, _e1086, _e1268);
                                                                            phi_1698_ = select(_e1057, _e1083, _e1268);
                                                                            phi_1699_ = select(_e1086, _e1073, _e1268);
                                                                            phi_1700_ = select(_e1083, _e1070, _e1268);
                                                                            phi_1701_ = select(_e1211, _e1210, _e1273);
                                                                            phi_1702_ = select(_e1219, _e1215, _e1273);
                                                                            phi_1703_ = select(_e1215, _e1223, _e1273);
                                                                            phi_1704_ = select(_e1223, _e1219, _e1273);
                                                                        }
                                                                        let _e1279 = phi_1697_;
                                                                        let _e1281 = phi_1698_;
                                                                        let _e1283 = phi_1699_;
                                                                        let _e1285 = phi_1700_;
                                                                        let _e1287 = phi_1701_;
                                                                        let _e1289 = phi_1702_;
                                                                        let _e1291 = phi_1703_;
                                                                        let _e1293 = phi_1704_;
                                                                        let _e1300 = ((_e1291.y * _e1289.z) - (_e1289.y * _e1291.z));
                                                                        let _e1305 = ((_e1291.z * _e1289.x) - (_e1289.z * _e1291.x));
                                                                        let _e1308 = ((_e1291.x * _e1289.y) - (_e1289.x * _e1291.y));
                                                                        if (_e1108 >= _e1112) {
                                                                            phi_1735_ = select(true, false, (_e1108 >= _e1116));
                                                                        } else {
                                                                            phi_1735_ = true;
                                                                        }
                                                                        let _e1313 = phi_1735_;
                                                                        if _e1313 {
                                                                            phi_1744_ = select(_e1211, _e1210, vec3((_e1112 >= _e1116)));
                                                                        } else {
                                                                            phi_1744_ = _e1209;
                                                                        }
                                                                        let _e1318 = phi_1744_;
                                                                        let _e1323 = (((_e1300 * _e400) + (_e1305 * _e436)) + (_e1308 * _e472));
                                                                        let _e1334 = (((_e1300 * (_e1318.x - _e375)) + (_e1305 * (_e1318.y - _e412))) + (_e1308 * (_e1318.z - _e448)));
                                                                        let _e1336 = (_e1281 - _e1285);
                                                                        let _e1337 = (_e1279 - _e1283);
                                                                        let _e1345 = (-(((_e1285 * _e1336) + (_e1283 * _e1337))) / ((_e1336 * _e1336) + (_e1337 * _e1337)));
                                                                        let _e1347 = select(1f, _e1345, (_e1345 < 1f));
                                                                        let _e1349 = select(0f, _e1347, (_e1347 > 0f));
                                                                        let _e1362 = ((_e1287.x + (_e1293.x * _e1349)) - _e375);
                                                                        let _e1363 = ((_e1287.y + (_e1293.y * _e1349)) - _e412);
                                                                        let _e1364 = ((_e1287.z + (_e1293.z * _e1349)) - _e448);
                                                                        let _e1365 = (_e1364 / _e472);
                                                                        let _e1377 = bitcast<f32>((bitcast<u32>(_e1362) & 2147483647u));
                                                                        let _e1380 = bitcast<f32>((bitcast<u32>(_e1363) & 2147483647u));
                                                                        let _e1382 = select(_e1380, _e1377, (_e1377 > _e1380));
                                                                        let _e1385 = bitcast<f32>((bitcast<u32>(_e1364) & 2147483647u));
                                                                        let _e1387 = select(_e1385, _e1382, (_e1382 > _e1385));
                                                                        let _e1393 = bitcast<f32>((bitcast<u32>(_e1300) & 2147483647u));
                                                                        let _e1396 = bitcast<f32>((bitcast<u32>(_e1305) & 2147483647u));
                                                                        let _e1398 = select(_e1396, _e1393, (_e1393 > _e1396));
                                                                        let _e1401 = bitcast<f32>((bitcast<u32>(_e1308) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1300 * _e1362) + (_e1305 * _e1363)) + (_e1308 * _e1364)) - _e1334)) & 2147483647u)) <= ((0.0000009536743f * select(_e1266, _e1387, (_e1387 > _e1266))) * select(_e1401, _e1398, (_e1398 > _e1401)))) {
                                                                            let _e1411 = bitcast<f32>((bitcast<u32>(_e1291.x) & 2147483647u));
                                                                            let _e1414 = bitcast<f32>((bitcast<u32>(_e1291.y) & 2147483647u));
                                                                            let _e1416 = select(_e1414, _e1411, (_e1411 > _e1414));
                                                                            let _e1419 = bitcast<f32>((bitcast<u32>(_e1291.z) & 2147483647u));
                                                                            let _e1425 = bitcast<f32>((bitcast<u32>(_e1289.x) & 2147483647u));
                                                                            let _e1428 = bitcast<f32>((bitcast<u32>(_e1289.y) & 2147483647u));
                                                                            let _e1430 = select(_e1428, _e1425, (_e1425 > _e1428));
                                                                            let _e1433 = bitcast<f32>((bitcast<u32>(_e1289.z) & 2147483647u));
                                                                            phi_1911_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1323) & 2147483647u)) > ((0.0000038146973f * select(_e1419, _e1416, (_e1416 > _e1419))) * select(_e1433, _e1430, (_e1430 > _e1433)))));
                                                                        } else {
                                                                            phi_1911_ = true;
                                                                        }
                                                                        let _e1440 = phi_1911_;
                                                                        if _e1440 {
                                                                            let _e1451 = ((((_e1300 * (_e1362 - (_e400 * _e1365))) + (_e1305 * (_e1363 - (_e436 * _e1365)))) + (_e1308 * (_e1364 - _e1364))) / _e1323);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1451) & 2147483647u)) <= _e1266) {
                                                                                phi_1935_ = (_e1365 + _e1451);
                                                                            } else {
                                                                                phi_1935_ = _e1365;
                                                                            }
                                                                            let _e1458 = phi_1935_;
                                                                            phi_1936_ = _e1458;
                                                                        } else {
                                                                            phi_1936_ = (_e1334 / _e1323);
                                                                        }
                                                                        let _e1460 = phi_1936_;
                                                                        let _e1462 = select(_e1199, _e1460, (_e1460 < _e1199));
                                                                        let _e1464 = select(_e1191, _e1462, (_e1462 > _e1191));
                                                                        if (_e1464 >= _e521) {
                                                                            let _e1466 = (_e1464 <= _e950.member_1);
                                                                            if _e1466 {
                                                                                let _e1467 = (1f / _e1118);
                                                                                phi_1959_ = type_27(_e1464, (_e1112 * _e1467), (_e1116 * _e1467), _e979);
                                                                            } else {
                                                                                phi_1959_ = type_27();
                                                                            }
                                                                            let _e1472 = phi_1959_;
                                                                            phi_1961_ = _e1472;
                                                                            phi_1962_ = select(true, false, _e1466);
                                                                        } else {
                                                                            phi_1961_ = type_27();
                                                                            phi_1962_ = true;
                                                                        }
                                                                        let _e1475 = phi_1961_;
                                                                        let _e1477 = phi_1962_;
                                                                        if _e1477 {
                                                                            phi_1966_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1966_ = _e1475;
                                                                        }
                                                                        let _e1479 = phi_1966_;
                                                                        phi_1967_ = _e1479;
                                                                    }
                                                                    let _e1481 = phi_1967_;
                                                                    phi_1968_ = _e1481;
                                                                    phi_1969_ = _e1208;
                                                                }
                                                                let _e1483 = phi_1968_;
                                                                let _e1485 = phi_1969_;
                                                                phi_1973_ = _e1483;
                                                                phi_1974_ = _e1485;
                                                            }
                                                            let _e1487 = phi_1973_;
                                                            let _e1489 = phi_1974_;
                                                            phi_1975_ = _e1487;
                                                            phi_1976_ = _e1143;
                                                            phi_1977_ = _e1489;
                                                        }
                                                        let _e1491 = phi_1975_;
                                                        let _e1493 = phi_1976_;
                                                        let _e1495 = phi_1977_;
                                                        phi_1978_ = _e1491;
                                                        phi_1979_ = _e1493;
                                                        phi_1980_ = _e1495;
                                                    }
                                                    let _e1497 = phi_1978_;
                                                    let _e1499 = phi_1979_;
                                                    let _e1501 = phi_1980_;
                                                    phi_1988_ = _e1497;
                                                    phi_1989_ = select(_e1501, true, _e1499);
                                                } else {
                                                    phi_1988_ = type_27();
                                                    phi_1989_ = true;
                                                }
                                                let _e1504 = phi_1988_;
                                                let _e1506 = phi_1989_;
                                                if _e1506 {
                                                    phi_1993_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1993_ = _e1504;
                                                }
                                                let _e1508 = phi_1993_;
                                                if (_e1508.member_3 != 4294967295u) {
                                                    if (_e979 == _e149) {
                                                        phi_2322_ = false;
                                                    } else {
                                                        let _e1512 = (_e979 < arrayLength((&global_5.member)));
                                                        if _e1512 {
                                                            if _e1512 {
                                                            } else {
                                                                phi_3486_ = true;
                                                                break;
                                                            }
                                                            let _e1514 = global_5.member[_e979];
                                                            phi_2016_ = _e1514;
                                                        } else {
                                                            phi_2016_ = 4294967295u;
                                                        }
                                                        let _e1516 = phi_2016_;
                                                        let _e1517 = (_e1516 < arrayLength((&global_6.member)));
                                                        if _e1517 {
                                                            if _e1517 {
                                                            } else {
                                                                phi_3486_ = true;
                                                                break;
                                                            }
                                                            let _e1519 = global_6.member[_e1516];
                                                            phi_2030_ = _e1519;
                                                        } else {
                                                            phi_2030_ = 0i;
                                                        }
                                                        let _e1521 = phi_2030_;
                                                        let _e1522 = (_e1521 == 0i);
                                                        if _e1522 {
                                                            phi_2321_ = true;
                                                        } else {
                                                            if _e367 {
                                                                phi_2051_ = vec3<f32>(_e1046[0][0], _e1046[0][1], _e1046[0][2]);
                                                            } else {
                                                                if (_e343 == 1u) {
                                                                    phi_2050_ = vec3<f32>(_e1046[0][2], _e1046[0][0], _e1046[0][1]);
                                                                } else {
                                                                    phi_2050_ = vec3<f32>(_e1046[0][1], _e1046[0][2], _e1046[0][0]);
                                                                }
                                                                let _e1527 = phi_2050_;
                                                                phi_2051_ = _e1527;
                                                            }
                                                            let _e1530 = phi_2051_;
                                                            if _e367 {
                                                                phi_2068_ = vec3<f32>(_e1046[1][0], _e1046[1][1], _e1046[1][2]);
                                                            } else {
                                                                if (_e343 == 1u) {
                                                                    phi_2067_ = vec3<f32>(_e1046[1][2], _e1046[1][0], _e1046[1][1]);
                                                                } else {
                                                                    phi_2067_ = vec3<f32>(_e1046[1][1], _e1046[1][2], _e1046[1][0]);
                                                                }
                                                                let _e1535 = phi_2067_;
                                                                phi_2068_ = _e1535;
                                                            }
                                                            let _e1538 = phi_2068_;
                                                            if _e367 {
                                                                phi_2085_ = vec3<f32>(_e1046[2][0], _e1046[2][1], _e1046[2][2]);
                                                            } else {
                                                                if (_e343 == 1u) {
                                                                    phi_2084_ = vec3<f32>(_e1046[2][2], _e1046[2][0], _e1046[2][1]);
                                                                } else {
                                                                    phi_2084_ = vec3<f32>(_e1046[2][1], _e1046[2][2], _e1046[2][0]);
                                                                }
                                                                let _e1543 = phi_2084_;
                                                                phi_2085_ = _e1543;
                                                            }
                                                            let _e1546 = phi_2085_;
                                                            let _e1549 = (_e1538.x - _e1530.x);
                                                            let _e1552 = (_e1538.y - _e1530.y);
                                                            let _e1555 = (_e1538.z - _e1530.z);
                                                            let _e1557 = (_e1546.x - _e1530.x);
                                                            let _e1559 = (_e1546.y - _e1530.y);
                                                            let _e1561 = (_e1546.z - _e1530.z);
                                                            if (_e221.member_1 == 1u) {
                                                                phi_2121_ = (vec3<f32>(_e221.member[0], _e221.member[1], _e221.member[2]) - _e1530);
                                                            } else {
                                                                phi_2121_ = vec3<f32>(_e221.member[0], _e221.member[1], _e221.member[2]);
                                                            }
                                                            let _e1576 = phi_2121_;
                                                            let _e1582 = bitcast<f32>((bitcast<u32>((_e1549 * _e1559)) ^ _e221.member_3[0]));
                                                            let _e1586 = bitcast<f32>((bitcast<u32>((_e1552 * _e1557)) ^ _e221.member_3[0]));
                                                            let _e1590 = bitcast<f32>((bitcast<u32>((_e1552 * _e1561)) ^ _e221.member_3[0]));
                                                            let _e1594 = bitcast<f32>((bitcast<u32>((_e1555 * _e1559)) ^ _e221.member_3[0]));
                                                            let _e1598 = bitcast<f32>((bitcast<u32>((_e1555 * _e1557)) ^ _e221.member_3[0]));
                                                            let _e1602 = bitcast<f32>((bitcast<u32>((_e1549 * _e1561)) ^ _e221.member_3[0]));
                                                            let _e1603 = (_e1590 - _e1594);
                                                            let _e1604 = (_e1598 - _e1602);
                                                            let _e1605 = (_e1582 - _e1586);
                                                            let _e1629 = (bitcast<f32>((bitcast<u32>(_e1590) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1594) & 2147483647u)));
                                                            let _e1636 = (bitcast<f32>((bitcast<u32>(_e1598) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1602) & 2147483647u)));
                                                            let _e1643 = (bitcast<f32>((bitcast<u32>(_e1582) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1586) & 2147483647u)));
                                                            if (_e221.member_2 == 0f) {
                                                                phi_2303_ = 0f;
                                                            } else {
                                                                let _e1673 = bitcast<f32>((bitcast<u32>(_e1603) & 2147483647u));
                                                                let _e1676 = bitcast<f32>((bitcast<u32>(_e1604) & 2147483647u));
                                                                let _e1679 = bitcast<f32>((bitcast<u32>(_e1605) & 2147483647u));
                                                                let _e1681 = select(_e1679, _e1676, (_e1676 > _e1679));
                                                                let _e1685 = select(_e1679, _e1676, (_e1676 < _e1679));
                                                                let _e1689 = select(_e1676, _e1673, (_e1673 < _e1676));
                                                                let _e1691 = select(_e1676, _e1673, (_e1673 > _e1676));
                                                                let _e1693 = select(_e1679, _e1691, (_e1691 < _e1679));
                                                                phi_2303_ = bitcast<f32>((bitcast<u32>((_e221.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1681, _e1673, (_e1673 > _e1681)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1693, _e1689, (_e1689 > _e1693)))) ^ _e221.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1685, _e1673, (_e1673 < _e1685)))) ^ _e221.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1629 + _e1636) + _e1643))) ^ _e221.member_3[0]))) * 1.0000005f)) ^ _e221.member_3[0])))) ^ _e221.member_3[0]));
                                                            }
                                                            let _e1720 = phi_2303_;
                                                            phi_2321_ = (_e1522 || !(((((bitcast<f32>((bitcast<u32>((_e1576.x * _e1603)) ^ _e221.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1576.y * _e1604)) ^ _e221.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1576.z * _e1605)) ^ _e221.member_3[0]))) * f32(-(_e1521))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1576.x) & 2147483647u)) * _e1629)) ^ _e221.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1576.y) & 2147483647u)) * _e1636)) ^ _e221.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1576.z) & 2147483647u)) * _e1643)) ^ _e221.member_3[0]))))) ^ _e221.member_3[0])) + _e1720) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1734 = phi_2321_;
                                                        phi_2322_ = _e1734;
                                                    }
                                                    let _e1736 = phi_2322_;
                                                    if _e1736 {
                                                        if (_e1508.member < _e950.member.member) {
                                                            phi_2342_ = true;
                                                        } else {
                                                            if (_e1508.member == _e950.member.member) {
                                                                phi_2341_ = (_e1508.member_3 < _e950.member.member_3);
                                                            } else {
                                                                phi_2341_ = false;
                                                            }
                                                            let _e1746 = phi_2341_;
                                                            phi_2342_ = _e1746;
                                                        }
                                                        let _e1748 = phi_2342_;
                                                        if _e1748 {
                                                            phi_2348_ = type_43(_e1508, _e1508.member);
                                                        } else {
                                                            phi_2348_ = _e950;
                                                        }
                                                        let _e1751 = phi_2348_;
                                                        phi_2349_ = _e1751;
                                                    } else {
                                                        phi_2349_ = _e950;
                                                    }
                                                    let _e1753 = phi_2349_;
                                                    phi_2350_ = _e1753;
                                                } else {
                                                    phi_2350_ = _e950;
                                                }
                                                let _e1755 = phi_2350_;
                                                phi_1015_ = _e1755;
                                            } else {
                                                phi_1015_ = type_43();
                                            }
                                            let _e1757 = phi_1015_;
                                            continue;
                                            continuing {
                                                phi_1014_ = _e1757;
                                                phi_1017_ = _e965;
                                                phi_3486_ = _e553;
                                                break if !(_e971);
                                            }
                                        }
                                        let _e1760 = phi_3486_;
                                        phi_3652_ = _e1760;
                                        if _e1760 {
                                            break;
                                        }
                                        phi_3656_ = _e1760;
                                        let _e1985 = local_11;
                                        phi_3299_ = _e1985;
                                        phi_3300_ = _e594;
                                        phi_3301_ = false;
                                        phi_3302_ = _e598;
                                    } else {
                                        let _e607 = (_e594.member_1 < _e90);
                                        if _e607 {
                                            if _e607 {
                                            } else {
                                                phi_3652_ = true;
                                                break;
                                            }
                                            let _e609 = global_10.member[_e594.member_1];
                                            phi_2369_ = _e609;
                                        } else {
                                            phi_2369_ = type_54(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e611 = phi_2369_;
                                        let _e626 = ((10u * _e343) & 31u);
                                        let _e629 = ((_e611.member[0] >> bitcast<u32>(_e626)) & 1023u);
                                        let _e634 = bitcast<f32>((bitcast<u32>(((_e594.member.member_1[0] - _e594.member.member[0]) * 0.0009775171f)) ^ _e132));
                                        let _e640 = (_e594.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e629) * _e634)) ^ _e132)));
                                        let _e644 = select(select(_e594.member.member_1[0], _e640, (_e640 < _e594.member.member_1[0])), _e594.member.member_1[0], (_e629 == 1023u));
                                        let _e646 = ((10u * _e342) & 31u);
                                        let _e649 = ((_e611.member[0] >> bitcast<u32>(_e646)) & 1023u);
                                        let _e654 = bitcast<f32>((bitcast<u32>(((_e594.member.member_1[1] - _e594.member.member[1]) * 0.0009775171f)) ^ _e132));
                                        let _e660 = (_e594.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e649) * _e654)) ^ _e132)));
                                        let _e664 = select(select(_e594.member.member_1[1], _e660, (_e660 < _e594.member.member_1[1])), _e594.member.member_1[1], (_e649 == 1023u));
                                        let _e666 = ((10u * _e344) & 31u);
                                        let _e669 = ((_e611.member[0] >> bitcast<u32>(_e666)) & 1023u);
                                        let _e674 = bitcast<f32>((bitcast<u32>(((_e594.member.member_1[2] - _e594.member.member[2]) * 0.0009775171f)) ^ _e132));
                                        let _e680 = (_e594.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e669) * _e674)) ^ _e132)));
                                        let _e684 = select(select(_e594.member.member_1[2], _e680, (_e680 < _e594.member.member_1[2])), _e594.member.member_1[2], (_e669 == 1023u));
                                        let _e687 = ((_e611.member[1] >> bitcast<u32>(_e626)) & 1023u);
                                        let _e693 = (_e594.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e687) * _e634)) ^ _e132)));
                                        let _e697 = select(select(_e594.member.member_1[0], _e693, (_e693 < _e594.member.member_1[0])), _e594.member.member_1[0], (_e687 == 1023u));
                                        let _e700 = ((_e611.member[1] >> bitcast<u32>(_e646)) & 1023u);
                                        let _e706 = (_e594.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e700) * _e654)) ^ _e132)));
                                        let _e710 = select(select(_e594.member.member_1[1], _e706, (_e706 < _e594.member.member_1[1])), _e594.member.member_1[1], (_e700 == 1023u));
                                        let _e713 = ((_e611.member[1] >> bitcast<u32>(_e666)) & 1023u);
                                        let _e719 = (_e594.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e713) * _e674)) ^ _e132)));
                                        let _e723 = select(select(_e594.member.member_1[2], _e719, (_e719 < _e594.member.member_1[2])), _e594.member.member_1[2], (_e713 == 1023u));
                                        let _e729 = ((_e611.member_1[0] >> bitcast<u32>(_e626)) & 1023u);
                                        let _e735 = (_e594.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e729) * _e634)) ^ _e132)));
                                        let _e739 = select(select(_e594.member.member_1[0], _e735, (_e735 < _e594.member.member_1[0])), _e594.member.member_1[0], (_e729 == 1023u));
                                        let _e742 = ((_e611.member_1[0] >> bitcast<u32>(_e646)) & 1023u);
                                        let _e748 = (_e594.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e742) * _e654)) ^ _e132)));
                                        let _e752 = select(select(_e594.member.member_1[1], _e748, (_e748 < _e594.member.member_1[1])), _e594.member.member_1[1], (_e742 == 1023u));
                                        let _e755 = ((_e611.member_1[0] >> bitcast<u32>(_e666)) & 1023u);
                                        let _e761 = (_e594.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e755) * _e674)) ^ _e132)));
                                        let _e765 = select(select(_e594.member.member_1[2], _e761, (_e761 < _e594.member.member_1[2])), _e594.member.member_1[2], (_e755 == 1023u));
                                        let _e768 = ((_e611.member_1[1] >> bitcast<u32>(_e626)) & 1023u);
                                        let _e774 = (_e594.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e768) * _e634)) ^ _e132)));
                                        let _e778 = select(select(_e594.member.member_1[0], _e774, (_e774 < _e594.member.member_1[0])), _e594.member.member_1[0], (_e768 == 1023u));
                                        let _e781 = ((_e611.member_1[1] >> bitcast<u32>(_e646)) & 1023u);
                                        let _e787 = (_e594.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e781) * _e654)) ^ _e132)));
                                        let _e791 = select(select(_e594.member.member_1[1], _e787, (_e787 < _e594.member.member_1[1])), _e594.member.member_1[1], (_e781 == 1023u));
                                        let _e794 = ((_e611.member_1[1] >> bitcast<u32>(_e666)) & 1023u);
                                        let _e800 = (_e594.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e794) * _e674)) ^ _e132)));
                                        let _e804 = select(select(_e594.member.member_1[2], _e800, (_e800 < _e594.member.member_1[2])), _e594.member.member_1[2], (_e794 == 1023u));
                                        let _e809 = type_61(type_59(array<f32, 3>(_e644, _e664, _e684), array<f32, 3>(_e697, _e710, _e723)), _e611.member_2);
                                        let _e814 = type_61(type_59(array<f32, 3>(_e739, _e752, _e765), array<f32, 3>(_e778, _e791, _e804)), _e611.member_3);
                                        let _e820 = ((_e644 - _e398) * _e403);
                                        let _e821 = ((_e739 - _e398) * _e403);
                                        let _e822 = ((_e697 - _e399) * _e403);
                                        let _e823 = ((_e778 - _e399) * _e403);
                                        let _e828 = ((_e664 - _e434) * _e439);
                                        let _e829 = ((_e752 - _e434) * _e439);
                                        let _e830 = ((_e710 - _e435) * _e439);
                                        let _e831 = ((_e791 - _e435) * _e439);
                                        let _e836 = ((_e684 - _e470) * _e475);
                                        let _e837 = ((_e765 - _e470) * _e475);
                                        let _e838 = ((_e723 - _e471) * _e475);
                                        let _e839 = ((_e804 - _e471) * _e475);
                                        let _e841 = select(_e838, _e836, (_e836 < _e838));
                                        let _e843 = select(_e839, _e837, (_e837 < _e839));
                                        let _e845 = select(_e838, _e836, (_e836 > _e838));
                                        let _e847 = select(_e839, _e837, (_e837 > _e839));
                                        let _e849 = select(_e822, _e820, (_e820 < _e822));
                                        let _e851 = select(_e823, _e821, (_e821 < _e823));
                                        let _e853 = select(_e830, _e828, (_e828 < _e830));
                                        let _e855 = select(_e831, _e829, (_e829 < _e831));
                                        let _e857 = select(_e853, _e849, (_e849 > _e853));
                                        let _e859 = select(_e855, _e851, (_e851 > _e855));
                                        let _e861 = select(_e841, _e857, (_e857 > _e841));
                                        let _e863 = select(_e843, _e859, (_e859 > _e843));
                                        let _e865 = select(_e822, _e820, (_e820 > _e822));
                                        let _e867 = select(_e823, _e821, (_e821 > _e823));
                                        let _e869 = select(_e830, _e828, (_e828 > _e830));
                                        let _e871 = select(_e831, _e829, (_e829 > _e831));
                                        let _e873 = select(_e869, _e865, (_e865 < _e869));
                                        let _e875 = select(_e871, _e867, (_e867 < _e871));
                                        let _e880 = -(_e841);
                                        let _e881 = -(_e843);
                                        let _e888 = (select(_e845, _e873, (_e873 < _e845)) + (select(_e880, _e845, (_e845 > _e880)) * 0.0000019073523f));
                                        let _e889 = (select(_e847, _e875, (_e875 < _e847)) + (select(_e881, _e847, (_e847 > _e881)) * 0.0000019073523f));
                                        let _e891 = select(_e521, _e861, (_e861 > _e521));
                                        let _e893 = select(_e521, _e863, (_e863 > _e521));
                                        let _e898 = (_e891 <= select(_e555.member_1, _e888, (_e888 < _e555.member_1)));
                                        let _e899 = (_e893 <= select(_e555.member_1, _e889, (_e889 < _e555.member_1)));
                                        let _e900 = (_e891 <= _e893);
                                        if _e898 {
                                            if _e899 {
                                                if _e900 {
                                                    phi_3201_ = _e814;
                                                } else {
                                                    phi_3201_ = _e809;
                                                }
                                                let _e902 = phi_3201_;
                                                let _e910 = (_e598 % 128u);
                                                let _e911 = (_e910 < 128u);
                                                if _e911 {
                                                } else {
                                                    phi_3652_ = true;
                                                    break;
                                                }
                                                local_6[_e910] = _e902.member_1;
                                                if _e911 {
                                                } else {
                                                    phi_3652_ = true;
                                                    break;
                                                }
                                                local_5[_e910] = _e902.member.member[0];
                                                if _e911 {
                                                } else {
                                                    phi_3652_ = true;
                                                    break;
                                                }
                                                local_4[_e910] = _e902.member.member[1];
                                                if _e911 {
                                                } else {
                                                    phi_3652_ = true;
                                                    break;
                                                }
                                                local_3[_e910] = _e902.member.member[2];
                                                if _e911 {
                                                } else {
                                                    phi_3652_ = true;
                                                    break;
                                                }
                                                local_2[_e910] = _e902.member.member_1[0];
                                                if _e911 {
                                                } else {
                                                    phi_3652_ = true;
                                                    break;
                                                }
                                                local_1[_e910] = _e902.member.member_1[1];
                                                if _e911 {
                                                } else {
                                                    phi_3652_ = true;
                                                    break;
                                                }
                                                local[_e910] = _e902.member.member_1[2];
                                                if _e911 {
                                                } else {
                                                    phi_3652_ = true;
                                                    break;
                                                }
                                                local_7[_e910] = select(_e893, _e891, (_e891 > _e893));
                                                if _e900 {
                                                    phi_3278_ = _e809;
                                                } else {
                                                    phi_3278_ = _e814;
                                                }
                                                let _e928 = phi_3278_;
                                                phi_3279_ = _e928;
                                                phi_3280_ = (_e598 + 1u);
                                            } else {
                                                phi_3279_ = type_61();
                                                phi_3280_ = u32();
                                            }
                                            let _e930 = phi_3279_;
                                            let _e932 = phi_3280_;
                                            phi_3282_ = _e930;
                                            phi_3283_ = _e932;
                                            phi_3284_ = select(true, false, _e899);
                                        } else {
                                            phi_3282_ = type_61();
                                            phi_3283_ = u32();
                                            phi_3284_ = true;
                                        }
                                        let _e935 = phi_3282_;
                                        let _e937 = phi_3283_;
                                        let _e939 = phi_3284_;
                                        if _e939 {
                                            if _e898 {
                                                phi_3291_ = _e809;
                                            } else {
                                                phi_3291_ = _e814;
                                            }
                                            let _e941 = phi_3291_;
                                            phi_3296_ = _e941;
                                            phi_3297_ = select(_e899, true, _e898);
                                        } else {
                                            phi_3296_ = _e935;
                                            phi_3297_ = _e596;
                                        }
                                        let _e944 = phi_3296_;
                                        let _e946 = phi_3297_;
                                        phi_3656_ = _e553;
                                        phi_3299_ = _e555;
                                        phi_3300_ = _e944;
                                        phi_3301_ = _e946;
                                        phi_3302_ = select(_e937, _e598, _e939);
                                    }
                                    let _e1762 = phi_3656_;
                                    let _e1764 = phi_3299_;
                                    let _e1766 = phi_3300_;
                                    let _e1768 = phi_3301_;
                                    let _e1770 = phi_3302_;
                                    phi_3655_ = _e1762;
                                    phi_3303_ = _e1764;
                                    phi_3304_ = _e1766;
                                    phi_3305_ = (_e559 - 1u);
                                    phi_3306_ = _e1768;
                                    phi_3307_ = _e1770;
                                } else {
                                    phi_3655_ = _e553;
                                    phi_3303_ = _e555;
                                    phi_3304_ = _e594;
                                    phi_3305_ = _e559;
                                    phi_3306_ = _e596;
                                    phi_3307_ = _e598;
                                }
                                let _e1772 = phi_3655_;
                                let _e1774 = phi_3303_;
                                let _e1776 = phi_3304_;
                                let _e1778 = phi_3305_;
                                let _e1780 = phi_3306_;
                                let _e1782 = phi_3307_;
                                phi_3654_ = _e1772;
                                phi_3308_ = _e1774;
                                phi_3309_ = _e1776;
                                phi_3310_ = _e1778;
                                phi_3311_ = _e1780;
                                phi_3312_ = _e1782;
                            } else {
                                phi_3654_ = _e553;
                                phi_3308_ = type_43();
                                phi_3309_ = type_61();
                                phi_3310_ = u32();
                                phi_3311_ = bool();
                                phi_3312_ = u32();
                            }
                            let _e1784 = phi_3654_;
                            let _e1786 = phi_3308_;
                            let _e1788 = phi_3309_;
                            let _e1790 = phi_3310_;
                            let _e1792 = phi_3311_;
                            let _e1794 = phi_3312_;
                            phi_3653_ = _e1784;
                            phi_889_ = _e1786;
                            phi_892_ = _e1788;
                            phi_894_ = _e1790;
                            phi_896_ = _e1792;
                            phi_898_ = _e1794;
                            phi_3313_ = _e567;
                        } else {
                            phi_3653_ = _e553;
                            phi_889_ = type_43();
                            phi_892_ = type_61();
                            phi_894_ = u32();
                            phi_896_ = bool();
                            phi_898_ = u32();
                            phi_3313_ = false;
                        }
                        let _e1796 = phi_3653_;
                        let _e1798 = phi_889_;
                        let _e1800 = phi_892_;
                        let _e1802 = phi_894_;
                        let _e1804 = phi_896_;
                        let _e1806 = phi_898_;
                        let _e1808 = phi_3313_;
                        continue;
                        continuing {
                            phi_3492_ = _e1796;
                            phi_888_ = _e1798;
                            phi_891_ = _e1800;
                            phi_893_ = _e1802;
                            phi_895_ = _e1804;
                            phi_897_ = _e1806;
                            phi_3652_ = _e1796;
                            break if !(_e1808);
                        }
                    }
                    let _e1811 = phi_3652_;
                    if _e1811 {
                        break;
                    }
                    let _e1813 = local_10;
                    if (_e1813.member.member_3 != 4294967295u) {
                        let _e1818 = (_e345 / 3i);
                        let _e1825 = bitcast<f32>((bitcast<u32>((_e1818 + 127i)) << bitcast<u32>(23i)));
                        let _e1833 = (((_e1813.member.member * _e1825) * _e1825) * bitcast<f32>((bitcast<u32>(((_e345 - (2i * _e1818)) + 127i)) << bitcast<u32>(23i))));
                        let _e1835 = select(340282350000000000000000000000000000000f, _e1833, (_e1833 < 340282350000000000000000000000000000000f));
                        phi_3365_ = type_27(select(-340282350000000000000000000000000000000f, _e1835, (_e1835 > -340282350000000000000000000000000000000f)), _e1813.member.member_1, _e1813.member.member_2, _e1813.member.member_3);
                    } else {
                        phi_3365_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1842 = phi_3365_;
                    if _e222 {
                    } else {
                        break;
                    }
                    global_8.member[_e136] = _e1842;
                    if _e143 {
                    } else {
                        break;
                    }
                    let _e1846 = select(0u, 1u, (_e289 <= _e299));
                    if (_e1846 > 0u) {
                        let _e1848 = (1u < _e104);
                        if _e1848 {
                            if (0u < _e104) {
                            } else {
                                break;
                            }
                            let _e1852 = atomicAdd((&global_9.member[0u]), _e1846);
                            if ((_e1852 + _e1846) < _e1852) {
                                if _e1848 {
                                } else {
                                    break;
                                }
                                let _e1857 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1860 = select(0u, 1u, (_e1842.member_3 != 4294967295u));
                    if (_e1860 > 0u) {
                        let _e1862 = (3u < _e104);
                        if _e1862 {
                            if (2u < _e104) {
                            } else {
                                break;
                            }
                            let _e1866 = atomicAdd((&global_9.member[2u]), _e1860);
                            if ((_e1866 + _e1860) < _e1866) {
                                if _e1862 {
                                } else {
                                    break;
                                }
                                let _e1871 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
