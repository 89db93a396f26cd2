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

struct type_20 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_32 {
    member: type_20,
    member_1: f32,
}

struct type_37 {
    member: array<type_24>,
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
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_40;
@group(0) @binding(4) 
var<storage> global_3: type_37;
@group(0) @binding(2) 
var<storage> global_4: type_44;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_22;

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
    var phi_434_: i32;
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
    var phi_4084_: bool;
    var phi_851_: type_32;
    var phi_854_: type_49;
    var phi_856_: u32;
    var phi_858_: bool;
    var phi_860_: u32;
    var phi_871_: bool;
    var phi_957_: type_49;
    var phi_958_: bool;
    var phi_959_: u32;
    var phi_3071_: u32;
    var phi_3077_: u32;
    var phi_3331_: u32;
    var phi_3332_: u32;
    var phi_3342_: u32;
    var phi_3344_: u32;
    var phi_3345_: bool;
    var phi_3365_: u32;
    var phi_3366_: u32;
    var phi_3370_: type_50;
    var phi_3714_: type_49;
    var phi_3791_: type_49;
    var phi_3792_: type_49;
    var phi_3793_: u32;
    var phi_3795_: type_49;
    var phi_3796_: u32;
    var phi_3797_: bool;
    var phi_3806_: type_49;
    var phi_3811_: type_49;
    var phi_3812_: bool;
    var phi_978_: type_32;
    var phi_981_: type_8;
    var phi_982_: type_8;
    var phi_1004_: type_8;
    var phi_1045_: u32;
    var phi_1051_: u32;
    var phi_1061_: u32;
    var phi_1077_: u32;
    var phi_1110_: u32;
    var phi_1116_: u32;
    var phi_1543_: u32;
    var phi_1561_: u32;
    var phi_1579_: u32;
    var phi_1599_: u32;
    var phi_1617_: u32;
    var phi_1635_: u32;
    var phi_1655_: u32;
    var phi_1673_: u32;
    var phi_1691_: u32;
    var phi_1269_: u32;
    var phi_1284_: u32;
    var phi_1294_: u32;
    var phi_1314_: u32;
    var phi_1334_: u32;
    var phi_1360_: u32;
    var phi_1375_: u32;
    var phi_1385_: u32;
    var phi_1405_: u32;
    var phi_1425_: u32;
    var phi_1451_: u32;
    var phi_1466_: u32;
    var phi_1476_: u32;
    var phi_1496_: u32;
    var phi_1516_: u32;
    var phi_1140_: u32;
    var phi_1183_: u32;
    var phi_1226_: u32;
    var phi_1697_: array<array<f32, 3>, 3>;
    var phi_1814_: bool;
    var phi_1843_: bool;
    var phi_2244_: f32;
    var phi_2245_: f32;
    var phi_2246_: f32;
    var phi_2247_: f32;
    var phi_2248_: vec3<f32>;
    var phi_2249_: vec3<f32>;
    var phi_2250_: vec3<f32>;
    var phi_2251_: vec3<f32>;
    var phi_2282_: bool;
    var phi_2291_: vec3<f32>;
    var phi_2458_: bool;
    var phi_2482_: f32;
    var phi_2483_: f32;
    var phi_2506_: type_20;
    var phi_2508_: type_20;
    var phi_2509_: bool;
    var phi_2513_: type_20;
    var phi_2514_: type_20;
    var phi_2515_: type_20;
    var phi_2516_: bool;
    var phi_2520_: type_20;
    var phi_2521_: bool;
    var phi_2522_: type_20;
    var phi_2523_: bool;
    var phi_2524_: bool;
    var phi_2525_: type_20;
    var phi_2526_: bool;
    var phi_2527_: bool;
    var phi_2535_: type_20;
    var phi_2536_: bool;
    var phi_2540_: type_20;
    var phi_2565_: bool;
    var phi_2566_: bool;
    var phi_2572_: type_32;
    var phi_2573_: type_32;
    var phi_2574_: type_32;
    var phi_979_: type_32;
    var phi_4078_: bool;
    var phi_4271_: bool;
    var phi_3814_: type_32;
    var phi_3815_: type_49;
    var phi_3816_: bool;
    var phi_3817_: u32;
    var phi_4270_: bool;
    var phi_3818_: type_32;
    var phi_3819_: type_49;
    var phi_3820_: u32;
    var phi_3821_: bool;
    var phi_3822_: u32;
    var phi_4269_: bool;
    var phi_3823_: type_32;
    var phi_3824_: type_49;
    var phi_3825_: u32;
    var phi_3826_: bool;
    var phi_3827_: u32;
    var phi_4268_: bool;
    var phi_852_: type_32;
    var phi_855_: type_49;
    var phi_857_: u32;
    var phi_859_: bool;
    var phi_861_: u32;
    var phi_3828_: bool;
    var phi_4267_: bool;
    var local_10: type_32;
    var phi_3880_: type_20;
    var local_11: type_32;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e89 = arrayLength((&global_4.member));
            let _e92 = arrayLength((&global_5.member));
            let _e100 = global_2.member[0u][0u];
            let _e104 = global_2.member[0u][1u];
            let _e108 = global_2.member[0u][2u];
            let _e112 = global_2.member[0u][3u];
            let _e116 = global_2.member[1u][0u];
            let _e120 = global_2.member[1u][1u];
            let _e124 = global_2.member[1u][2u];
            let _e127 = global_1.member[0u];
            let _e128 = bitcast<i32>(_e127);
            let _e140 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e112) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e100), bitcast<i32>(_e104), bitcast<i32>(_e108));
            local = array<i32, 3>(bitcast<i32>(_e116), bitcast<i32>(_e120), bitcast<i32>(_e124));
            let _e146 = (_e87.x + (_e87.y * 2097152u));
            let _e147 = (_e146 < arrayLength((&global_3.member)));
            if _e147 {
                let _e148 = (_e146 < arrayLength((&global_6.member)));
                if _e148 {
                    if _e147 {
                    } else {
                        break;
                    }
                    let _e156 = global_3.member[_e146].member_2[0u];
                    let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                    let _e163 = global_3.member[_e146].member_2[1u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_3.member[_e146].member_2[2u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_3.member[_e146].member[0u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_3.member[_e146].member[1u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e191 = global_3.member[_e146].member[2u];
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e195 = select(_e165, _e158, (_e165 < _e158));
                    let _e197 = select(_e172, _e195, (_e172 < _e195));
                    let _e199 = select(_e179, _e197, (_e179 < _e197));
                    let _e201 = select(_e186, _e199, (_e186 < _e199));
                    let _e203 = select(_e193, _e201, (_e193 < _e201));
                    let _e207 = global_3.member[_e146].member_1;
                    let _e209 = (bitcast<u32>(_e207) & 2147483647u);
                    let _e216 = global_3.member[_e146].member_3;
                    let _e222 = (((select(_e209, _e203, (_e209 < _e203)) < 2139095040u) && ((bitcast<u32>(_e216) & 2147483647u) <= 2139095040u)) && (_e197 > 0u));
                    if _e222 {
                        let _e225 = (bitcast<u32>(bitcast<f32>(_e197)) & 2147483647u);
                        if (_e225 >= 8388608u) {
                            phi_393_ = (bitcast<i32>((_e225 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_393_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e225)), 32u, (_e225 == 0u))));
                        }
                        let _e239 = phi_393_;
                        phi_394_ = _e239;
                    } else {
                        phi_394_ = 0i;
                    }
                    let _e241 = phi_394_;
                    let _e242 = (_e158 == _e197);
                    if _e242 {
                        phi_404_ = true;
                    } else {
                        phi_404_ = (_e165 == _e197);
                    }
                    let _e245 = phi_404_;
                    let _e246 = select(1u, 0u, _e242);
                    if _e245 {
                        let _e247 = (_e246 + 1u);
                        phi_414_ = _e247;
                        phi_415_ = _e247;
                        phi_417_ = select(true, false, (_e247 == 2u));
                    } else {
                        phi_414_ = u32();
                        phi_415_ = 0u;
                        phi_417_ = true;
                    }
                    let _e251 = phi_414_;
                    let _e253 = phi_415_;
                    let _e255 = phi_417_;
                    if _e255 {
                        phi_422_ = (_e253 + 1u);
                    } else {
                        phi_422_ = 0u;
                    }
                    let _e259 = phi_422_;
                    let _e260 = select(_e251, _e253, _e255);
                    let _e261 = select(_e246, select(2u, _e246, _e245), _e255);
                    if (_e128 < -126i) {
                        phi_434_ = -126i;
                    } else {
                        phi_434_ = select(_e128, 127i, (_e128 > 127i));
                    }
                    let _e266 = phi_434_;
                    let _e271 = bitcast<f32>((bitcast<u32>((_e266 + 127i)) << bitcast<u32>(23i)));
                    let _e277 = bitcast<f32>((bitcast<u32>(((_e128 - _e266) + 127i)) << bitcast<u32>(23i)));
                    let _e278 = -(_e241);
                    if (_e278 < -126i) {
                        phi_454_ = -126i;
                    } else {
                        phi_454_ = select(_e278, 127i, (_e278 > 127i));
                    }
                    let _e283 = phi_454_;
                    let _e288 = bitcast<f32>((bitcast<u32>((_e283 + 127i)) << bitcast<u32>(23i)));
                    let _e294 = bitcast<f32>((bitcast<u32>(((_e278 - _e283) + 127i)) << bitcast<u32>(23i)));
                    let _e298 = global_3.member[_e146].member;
                    let _e299 = (_e260 == 0u);
                    if _e299 {
                        phi_472_ = _e298[0];
                    } else {
                        phi_472_ = _e298[1];
                    }
                    let _e303 = phi_472_;
                    let _e304 = (_e260 == 2u);
                    if _e304 {
                        phi_478_ = _e298[2];
                    } else {
                        phi_478_ = _e303;
                    }
                    let _e307 = phi_478_;
                    let _e309 = ((_e307 * _e271) * _e277);
                    let _e310 = global_3.member[_e146].member_2;
                    if _e299 {
                        phi_489_ = _e310[0];
                    } else {
                        phi_489_ = _e310[1];
                    }
                    let _e314 = phi_489_;
                    if _e304 {
                        phi_495_ = _e310[2];
                    } else {
                        phi_495_ = _e314;
                    }
                    let _e317 = phi_495_;
                    let _e319 = ((_e317 * _e288) * _e294);
                    let _e323 = (bitcast<f32>((bitcast<u32>(_e319) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e323 {
                        let _e327 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) * 0.00000011920929f);
                        phi_518_ = select(0.00000000000011368684f, _e327, (_e327 > 0.00000000000011368684f));
                    } else {
                        phi_518_ = 0f;
                    }
                    let _e331 = phi_518_;
                    let _e332 = (_e309 + _e331);
                    let _e333 = (_e309 - _e331);
                    let _e334 = select(_e319, 0f, _e323);
                    if _e323 {
                        phi_529_ = 38685626000000000000000000f;
                    } else {
                        phi_529_ = (1f / _e319);
                    }
                    let _e337 = phi_529_;
                    let _e338 = (_e259 == 0u);
                    if _e338 {
                        phi_538_ = _e298[0];
                    } else {
                        phi_538_ = _e298[1];
                    }
                    let _e342 = phi_538_;
                    let _e343 = (_e259 == 2u);
                    if _e343 {
                        phi_544_ = _e298[2];
                    } else {
                        phi_544_ = _e342;
                    }
                    let _e346 = phi_544_;
                    let _e348 = ((_e346 * _e271) * _e277);
                    if _e338 {
                        phi_555_ = _e310[0];
                    } else {
                        phi_555_ = _e310[1];
                    }
                    let _e352 = phi_555_;
                    if _e343 {
                        phi_561_ = _e310[2];
                    } else {
                        phi_561_ = _e352;
                    }
                    let _e355 = phi_561_;
                    let _e357 = ((_e355 * _e288) * _e294);
                    let _e361 = (bitcast<f32>((bitcast<u32>(_e357) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e361 {
                        let _e365 = (bitcast<f32>((bitcast<u32>(_e348) & 2147483647u)) * 0.00000011920929f);
                        phi_584_ = select(0.00000000000011368684f, _e365, (_e365 > 0.00000000000011368684f));
                    } else {
                        phi_584_ = 0f;
                    }
                    let _e369 = phi_584_;
                    let _e370 = (_e348 + _e369);
                    let _e371 = (_e348 - _e369);
                    let _e372 = select(_e357, 0f, _e361);
                    if _e361 {
                        phi_595_ = 38685626000000000000000000f;
                    } else {
                        phi_595_ = (1f / _e357);
                    }
                    let _e375 = phi_595_;
                    let _e376 = (_e261 == 0u);
                    if _e376 {
                        phi_604_ = _e298[0];
                    } else {
                        phi_604_ = _e298[1];
                    }
                    let _e380 = phi_604_;
                    let _e381 = (_e261 == 2u);
                    if _e381 {
                        phi_610_ = _e298[2];
                    } else {
                        phi_610_ = _e380;
                    }
                    let _e384 = phi_610_;
                    let _e386 = ((_e384 * _e271) * _e277);
                    if _e376 {
                        phi_621_ = _e310[0];
                    } else {
                        phi_621_ = _e310[1];
                    }
                    let _e390 = phi_621_;
                    if _e381 {
                        phi_627_ = _e310[2];
                    } else {
                        phi_627_ = _e390;
                    }
                    let _e393 = phi_627_;
                    let _e395 = ((_e393 * _e288) * _e294);
                    let _e399 = (bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e399 {
                        let _e403 = (bitcast<f32>((bitcast<u32>(_e386) & 2147483647u)) * 0.00000011920929f);
                        phi_650_ = select(0.00000000000011368684f, _e403, (_e403 > 0.00000000000011368684f));
                    } else {
                        phi_650_ = 0f;
                    }
                    let _e407 = phi_650_;
                    let _e408 = (_e386 + _e407);
                    let _e409 = (_e386 - _e407);
                    let _e410 = select(_e395, 0f, _e399);
                    if _e399 {
                        phi_661_ = 38685626000000000000000000f;
                    } else {
                        phi_661_ = (1f / _e395);
                    }
                    let _e413 = phi_661_;
                    let _e416 = bitcast<f32>((bitcast<u32>(_e309) & 2147483647u));
                    let _e419 = bitcast<f32>((bitcast<u32>(_e348) & 2147483647u));
                    let _e421 = select(_e419, _e416, (_e416 > _e419));
                    let _e424 = bitcast<f32>((bitcast<u32>(_e386) & 2147483647u));
                    let _e427 = (_e128 + _e241);
                    if (_e222 && (select(_e424, _e421, (_e421 > _e424)) <= 1099511600000f)) {
                        let _e430 = (_e427 / 3i);
                        let _e437 = bitcast<f32>((bitcast<u32>((_e430 + 127i)) << bitcast<u32>(23i)));
                        let _e444 = bitcast<f32>((bitcast<u32>(((_e427 - (2i * _e430)) + 127i)) << bitcast<u32>(23i)));
                        let _e445 = (((_e207 * _e437) * _e437) * _e444);
                        let _e447 = select(340282350000000000000000000000000000000f, _e445, (_e445 < 340282350000000000000000000000000000000f));
                        let _e452 = (((_e216 * _e437) * _e437) * _e444);
                        let _e454 = select(340282350000000000000000000000000000000f, _e452, (_e452 < 340282350000000000000000000000000000000f));
                        phi_761_ = select(-340282350000000000000000000000000000000f, _e454, (_e454 > -340282350000000000000000000000000000000f));
                        phi_762_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_761_ = 0f;
                        phi_762_ = 1f;
                    }
                    let _e458 = phi_761_;
                    let _e460 = phi_762_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e464 = (_e260 % 3u);
                    let _e465 = (_e464 < 3u);
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e467 = local_1[_e464];
                    let _e470 = (_e259 % 3u);
                    let _e471 = (_e470 < 3u);
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e473 = local_1[_e470];
                    let _e476 = (_e261 % 3u);
                    let _e477 = (_e476 < 3u);
                    if _e477 {
                    } else {
                        break;
                    }
                    let _e479 = local_1[_e476];
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e484 = local[_e464];
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e488 = local[_e470];
                    if _e477 {
                    } else {
                        break;
                    }
                    let _e492 = local[_e476];
                    phi_4084_ = false;
                    phi_851_ = type_32(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e458);
                    phi_854_ = type_49(type_28(vec4<f32>((f32(_e467) * _e140), (f32(_e473) * _e140), (f32(_e479) * _e140), 0f), vec4<f32>((f32(_e484) * _e140), (f32(_e488) * _e140), (f32(_e492) * _e140), 0f)), select(0u, 2147483648u, (_e89 == 0u)));
                    phi_856_ = ((3u * _e89) + 1u);
                    phi_858_ = (_e460 <= _e458);
                    phi_860_ = 0u;
                    loop {
                        let _e502 = phi_4084_;
                        let _e504 = phi_851_;
                        let _e506 = phi_854_;
                        let _e508 = phi_856_;
                        let _e510 = phi_858_;
                        let _e512 = phi_860_;
                        local_10 = _e504;
                        if _e510 {
                            phi_871_ = true;
                        } else {
                            phi_871_ = (_e512 > 0u);
                        }
                        let _e515 = phi_871_;
                        if _e515 {
                            let _e516 = (_e508 > 0u);
                            if _e516 {
                                if _e510 {
                                    phi_957_ = _e506;
                                    phi_958_ = _e510;
                                    phi_959_ = _e512;
                                } else {
                                    let _e517 = (_e512 - 1u);
                                    let _e518 = (_e517 % 128u);
                                    let _e519 = (_e518 < 128u);
                                    if _e519 {
                                    } else {
                                        phi_4267_ = true;
                                        break;
                                    }
                                    let _e521 = local_7[_e518];
                                    if _e519 {
                                    } else {
                                        phi_4267_ = true;
                                        break;
                                    }
                                    let _e523 = local_6[_e518];
                                    if _e519 {
                                    } else {
                                        phi_4267_ = true;
                                        break;
                                    }
                                    let _e525 = local_5[_e518];
                                    if _e519 {
                                    } else {
                                        phi_4267_ = true;
                                        break;
                                    }
                                    let _e527 = local_4[_e518];
                                    if _e519 {
                                    } else {
                                        phi_4267_ = true;
                                        break;
                                    }
                                    let _e529 = local_3[_e518];
                                    if _e519 {
                                    } else {
                                        phi_4267_ = true;
                                        break;
                                    }
                                    let _e531 = local_2[_e518];
                                    if _e519 {
                                    } else {
                                        phi_4267_ = true;
                                        break;
                                    }
                                    let _e536 = local_8[_e518];
                                    if _e519 {
                                    } else {
                                        phi_4267_ = true;
                                        break;
                                    }
                                    let _e539 = local_9[_e518];
                                    phi_957_ = type_49(type_28(vec4<f32>(_e521, _e523, _e525, 0f), vec4<f32>(_e527, _e529, _e531, 0f)), _e536);
                                    phi_958_ = (_e539 <= _e504.member_1);
                                    phi_959_ = _e517;
                                }
                                let _e543 = phi_957_;
                                let _e545 = phi_958_;
                                let _e547 = phi_959_;
                                if _e545 {
                                    let _e552 = (_e543.member_1 & 268435455u);
                                    if ((_e543.member_1 & 2147483648u) != 0u) {
                                        phi_978_ = _e504;
                                        phi_981_ = type_8(0u, ((_e543.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1030 = phi_978_;
                                            let _e1032 = phi_981_;
                                            local_11 = _e1030;
                                            if (_e1032.member < _e1032.member_1) {
                                                phi_982_ = type_8((_e1032.member + 1u), _e1032.member_1);
                                                phi_1004_ = type_8(1u, _e1032.member);
                                            } else {
                                                phi_982_ = _e1032;
                                                phi_1004_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1045 = phi_982_;
                                            let _e1047 = phi_1004_;
                                            let _e1051 = (bitcast<i32>(_e1047.member) != 0i);
                                            if _e1051 {
                                                let _e1056 = (_e543.member.member_1.x - _e543.member.member.x);
                                                let _e1059 = (_e543.member.member_1.y - _e543.member.member.y);
                                                let _e1062 = (_e543.member.member_1.z - _e543.member.member.z);
                                                let _e1064 = select(_e1059, _e1056, (_e1056 > _e1059));
                                                let _e1066 = select(_e1062, _e1064, (_e1064 > _e1062));
                                                let _e1068 = (_e1066 < (1024f * _e140));
                                                if _e1068 {
                                                    phi_1045_ = 0u;
                                                } else {
                                                    phi_1045_ = select(2u, 1u, (_e1066 < (2097152f * _e140)));
                                                }
                                                let _e1073 = phi_1045_;
                                                switch bitcast<i32>(_e1073) {
                                                    case 0: {
                                                        phi_1051_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1051_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1051_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1051_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1076 = phi_1051_;
                                                switch bitcast<i32>(_e1073) {
                                                    case 0: {
                                                        phi_1061_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1061_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1061_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1061_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1083 = phi_1061_;
                                                let _e1085 = ((_e552 + (_e1047.member_1 * ((3u * _e1076) + 1u))) + (3u * _e1083));
                                                let _e1086 = (_e1085 < _e92);
                                                if _e1086 {
                                                    if _e1086 {
                                                    } else {
                                                        phi_4078_ = true;
                                                        break;
                                                    }
                                                    let _e1088 = global_5.member[_e1085];
                                                    phi_1077_ = _e1088;
                                                } else {
                                                    phi_1077_ = 4294967295u;
                                                }
                                                let _e1090 = phi_1077_;
                                                if _e1068 {
                                                    phi_1110_ = 0u;
                                                } else {
                                                    phi_1110_ = select(2u, 1u, (_e1066 < (2097152f * _e140)));
                                                }
                                                let _e1095 = phi_1110_;
                                                switch bitcast<i32>(_e1095) {
                                                    case 0: {
                                                        phi_1116_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1116_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1116_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1116_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1098 = phi_1116_;
                                                let _e1102 = (_e552 + (_e1047.member_1 * ((3u * _e1098) + 1u)));
                                                switch bitcast<i32>(_e1095) {
                                                    case 0: {
                                                        let _e1368 = (_e1102 < _e92);
                                                        if _e1368 {
                                                            if _e1368 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1370 = global_5.member[_e1102];
                                                            phi_1140_ = _e1370;
                                                        } else {
                                                            phi_1140_ = 0u;
                                                        }
                                                        let _e1372 = phi_1140_;
                                                        let _e1374 = ((10u * _e260) & 31u);
                                                        let _e1383 = ((10u * _e259) & 31u);
                                                        let _e1392 = ((10u * _e261) & 31u);
                                                        let _e1401 = (_e1102 + 1u);
                                                        let _e1402 = (_e1401 < _e92);
                                                        if _e1402 {
                                                            if _e1402 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1404 = global_5.member[_e1401];
                                                            phi_1183_ = _e1404;
                                                        } else {
                                                            phi_1183_ = 0u;
                                                        }
                                                        let _e1406 = phi_1183_;
                                                        let _e1429 = (_e1102 + 2u);
                                                        let _e1430 = (_e1429 < _e92);
                                                        if _e1430 {
                                                            if _e1430 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1432 = global_5.member[_e1429];
                                                            phi_1226_ = _e1432;
                                                        } else {
                                                            phi_1226_ = 0u;
                                                        }
                                                        let _e1434 = phi_1226_;
                                                        phi_1697_ = array<array<f32, 3>, 3>(array<f32, 3>((_e543.member.member.x + (f32(bitcast<i32>(((_e1372 >> bitcast<u32>(_e1374)) & 1023u))) * _e140)), (_e543.member.member.y + (f32(bitcast<i32>(((_e1372 >> bitcast<u32>(_e1383)) & 1023u))) * _e140)), (_e543.member.member.z + (f32(bitcast<i32>(((_e1372 >> bitcast<u32>(_e1392)) & 1023u))) * _e140))), array<f32, 3>((_e543.member.member.x + (f32(bitcast<i32>(((_e1406 >> bitcast<u32>(_e1374)) & 1023u))) * _e140)), (_e543.member.member.y + (f32(bitcast<i32>(((_e1406 >> bitcast<u32>(_e1383)) & 1023u))) * _e140)), (_e543.member.member.z + (f32(bitcast<i32>(((_e1406 >> bitcast<u32>(_e1392)) & 1023u))) * _e140))), array<f32, 3>((_e543.member.member.x + (f32(bitcast<i32>(((_e1434 >> bitcast<u32>(_e1374)) & 1023u))) * _e140)), (_e543.member.member.y + (f32(bitcast<i32>(((_e1434 >> bitcast<u32>(_e1383)) & 1023u))) * _e140)), (_e543.member.member.z + (f32(bitcast<i32>(((_e1434 >> bitcast<u32>(_e1392)) & 1023u))) * _e140))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1191 = (_e1102 < _e92);
                                                        if _e1191 {
                                                            if _e1191 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1193 = global_5.member[_e1102];
                                                            phi_1269_ = _e1193;
                                                        } else {
                                                            phi_1269_ = 0u;
                                                        }
                                                        let _e1195 = phi_1269_;
                                                        let _e1196 = (_e1102 + 1u);
                                                        let _e1197 = (_e1196 < _e92);
                                                        if _e1197 {
                                                            if _e1197 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1199 = global_5.member[_e1196];
                                                            phi_1284_ = _e1199;
                                                        } else {
                                                            phi_1284_ = 0u;
                                                        }
                                                        let _e1201 = phi_1284_;
                                                        let _e1202 = (_e260 == 1u);
                                                        if _e1202 {
                                                            phi_1294_ = ((_e1195 >> bitcast<u32>(21i)) | (_e1201 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1294_ = (_e1201 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1211 = phi_1294_;
                                                        let _e1218 = (_e259 == 1u);
                                                        if _e1218 {
                                                            phi_1314_ = ((_e1195 >> bitcast<u32>(21i)) | (_e1201 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1314_ = (_e1201 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1227 = phi_1314_;
                                                        let _e1234 = (_e261 == 1u);
                                                        if _e1234 {
                                                            phi_1334_ = ((_e1195 >> bitcast<u32>(21i)) | (_e1201 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1334_ = (_e1201 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1243 = phi_1334_;
                                                        let _e1251 = (_e1102 + 2u);
                                                        let _e1252 = (_e1251 < _e92);
                                                        if _e1252 {
                                                            if _e1252 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1254 = global_5.member[_e1251];
                                                            phi_1360_ = _e1254;
                                                        } else {
                                                            phi_1360_ = 0u;
                                                        }
                                                        let _e1256 = phi_1360_;
                                                        let _e1257 = (_e1102 + 3u);
                                                        let _e1258 = (_e1257 < _e92);
                                                        if _e1258 {
                                                            if _e1258 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1260 = global_5.member[_e1257];
                                                            phi_1375_ = _e1260;
                                                        } else {
                                                            phi_1375_ = 0u;
                                                        }
                                                        let _e1262 = phi_1375_;
                                                        if _e1202 {
                                                            phi_1385_ = ((_e1256 >> bitcast<u32>(21i)) | (_e1262 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1385_ = (_e1262 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1271 = phi_1385_;
                                                        if _e1218 {
                                                            phi_1405_ = ((_e1256 >> bitcast<u32>(21i)) | (_e1262 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1405_ = (_e1262 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1286 = phi_1405_;
                                                        if _e1234 {
                                                            phi_1425_ = ((_e1256 >> bitcast<u32>(21i)) | (_e1262 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1425_ = (_e1262 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1301 = phi_1425_;
                                                        let _e1309 = (_e1102 + 4u);
                                                        let _e1310 = (_e1309 < _e92);
                                                        if _e1310 {
                                                            if _e1310 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1312 = global_5.member[_e1309];
                                                            phi_1451_ = _e1312;
                                                        } else {
                                                            phi_1451_ = 0u;
                                                        }
                                                        let _e1314 = phi_1451_;
                                                        let _e1315 = (_e1102 + 5u);
                                                        let _e1316 = (_e1315 < _e92);
                                                        if _e1316 {
                                                            if _e1316 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1318 = global_5.member[_e1315];
                                                            phi_1466_ = _e1318;
                                                        } else {
                                                            phi_1466_ = 0u;
                                                        }
                                                        let _e1320 = phi_1466_;
                                                        if _e1202 {
                                                            phi_1476_ = ((_e1314 >> bitcast<u32>(21i)) | (_e1320 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1476_ = (_e1320 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1329 = phi_1476_;
                                                        if _e1218 {
                                                            phi_1496_ = ((_e1314 >> bitcast<u32>(21i)) | (_e1320 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1496_ = (_e1320 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1344 = phi_1496_;
                                                        if _e1234 {
                                                            phi_1516_ = ((_e1314 >> bitcast<u32>(21i)) | (_e1320 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1516_ = (_e1320 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1359 = phi_1516_;
                                                        phi_1697_ = array<array<f32, 3>, 3>(array<f32, 3>((_e543.member.member.x + (f32(bitcast<i32>((select(_e1211, _e1195, _e299) & 2097151u))) * _e140)), (_e543.member.member.y + (f32(bitcast<i32>((select(_e1227, _e1195, _e338) & 2097151u))) * _e140)), (_e543.member.member.z + (f32(bitcast<i32>((select(_e1243, _e1195, _e376) & 2097151u))) * _e140))), array<f32, 3>((_e543.member.member.x + (f32(bitcast<i32>((select(_e1271, _e1256, _e299) & 2097151u))) * _e140)), (_e543.member.member.y + (f32(bitcast<i32>((select(_e1286, _e1256, _e338) & 2097151u))) * _e140)), (_e543.member.member.z + (f32(bitcast<i32>((select(_e1301, _e1256, _e376) & 2097151u))) * _e140))), array<f32, 3>((_e543.member.member.x + (f32(bitcast<i32>((select(_e1329, _e1314, _e299) & 2097151u))) * _e140)), (_e543.member.member.y + (f32(bitcast<i32>((select(_e1344, _e1314, _e338) & 2097151u))) * _e140)), (_e543.member.member.z + (f32(bitcast<i32>((select(_e1359, _e1314, _e376) & 2097151u))) * _e140))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1104 = (_e1102 + _e260);
                                                        let _e1105 = (_e1104 < _e92);
                                                        if _e1105 {
                                                            if _e1105 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1107 = global_5.member[_e1104];
                                                            phi_1543_ = _e1107;
                                                        } else {
                                                            phi_1543_ = 0u;
                                                        }
                                                        let _e1109 = phi_1543_;
                                                        let _e1113 = (_e1102 + _e259);
                                                        let _e1114 = (_e1113 < _e92);
                                                        if _e1114 {
                                                            if _e1114 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1116 = global_5.member[_e1113];
                                                            phi_1561_ = _e1116;
                                                        } else {
                                                            phi_1561_ = 0u;
                                                        }
                                                        let _e1118 = phi_1561_;
                                                        let _e1122 = (_e1102 + _e261);
                                                        let _e1123 = (_e1122 < _e92);
                                                        if _e1123 {
                                                            if _e1123 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1125 = global_5.member[_e1122];
                                                            phi_1579_ = _e1125;
                                                        } else {
                                                            phi_1579_ = 0u;
                                                        }
                                                        let _e1127 = phi_1579_;
                                                        let _e1132 = (_e1102 + 3u);
                                                        let _e1133 = (_e1132 + _e260);
                                                        let _e1134 = (_e1133 < _e92);
                                                        if _e1134 {
                                                            if _e1134 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1136 = global_5.member[_e1133];
                                                            phi_1599_ = _e1136;
                                                        } else {
                                                            phi_1599_ = 0u;
                                                        }
                                                        let _e1138 = phi_1599_;
                                                        let _e1142 = (_e1132 + _e259);
                                                        let _e1143 = (_e1142 < _e92);
                                                        if _e1143 {
                                                            if _e1143 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1145 = global_5.member[_e1142];
                                                            phi_1617_ = _e1145;
                                                        } else {
                                                            phi_1617_ = 0u;
                                                        }
                                                        let _e1147 = phi_1617_;
                                                        let _e1151 = (_e1132 + _e261);
                                                        let _e1152 = (_e1151 < _e92);
                                                        if _e1152 {
                                                            if _e1152 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1154 = global_5.member[_e1151];
                                                            phi_1635_ = _e1154;
                                                        } else {
                                                            phi_1635_ = 0u;
                                                        }
                                                        let _e1156 = phi_1635_;
                                                        let _e1161 = (_e1102 + 6u);
                                                        let _e1162 = (_e1161 + _e260);
                                                        let _e1163 = (_e1162 < _e92);
                                                        if _e1163 {
                                                            if _e1163 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1165 = global_5.member[_e1162];
                                                            phi_1655_ = _e1165;
                                                        } else {
                                                            phi_1655_ = 0u;
                                                        }
                                                        let _e1167 = phi_1655_;
                                                        let _e1171 = (_e1161 + _e259);
                                                        let _e1172 = (_e1171 < _e92);
                                                        if _e1172 {
                                                            if _e1172 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1174 = global_5.member[_e1171];
                                                            phi_1673_ = _e1174;
                                                        } else {
                                                            phi_1673_ = 0u;
                                                        }
                                                        let _e1176 = phi_1673_;
                                                        let _e1180 = (_e1161 + _e261);
                                                        let _e1181 = (_e1180 < _e92);
                                                        if _e1181 {
                                                            if _e1181 {
                                                            } else {
                                                                phi_4078_ = true;
                                                                break;
                                                            }
                                                            let _e1183 = global_5.member[_e1180];
                                                            phi_1691_ = _e1183;
                                                        } else {
                                                            phi_1691_ = 0u;
                                                        }
                                                        let _e1185 = phi_1691_;
                                                        phi_1697_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1109)) * _e140), (f32(bitcast<i32>(_e1118)) * _e140), (f32(bitcast<i32>(_e1127)) * _e140)), array<f32, 3>((f32(bitcast<i32>(_e1138)) * _e140), (f32(bitcast<i32>(_e1147)) * _e140), (f32(bitcast<i32>(_e1156)) * _e140)), array<f32, 3>((f32(bitcast<i32>(_e1167)) * _e140), (f32(bitcast<i32>(_e1176)) * _e140), (f32(bitcast<i32>(_e1185)) * _e140)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1697_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1459 = phi_1697_;
                                                let _e1467 = (_e1459[0][2] - _e386);
                                                let _e1470 = (((_e1459[0][0] - _e309) * _e410) - (_e1467 * _e334));
                                                let _e1473 = (((_e1459[0][1] - _e348) * _e410) - (_e1467 * _e372));
                                                let _e1480 = (_e1459[1][2] - _e386);
                                                let _e1483 = (((_e1459[1][0] - _e309) * _e410) - (_e1480 * _e334));
                                                let _e1486 = (((_e1459[1][1] - _e348) * _e410) - (_e1480 * _e372));
                                                let _e1493 = (_e1459[2][2] - _e386);
                                                let _e1496 = (((_e1459[2][0] - _e309) * _e410) - (_e1493 * _e334));
                                                let _e1499 = (((_e1459[2][1] - _e348) * _e410) - (_e1493 * _e372));
                                                let _e1500 = (_e1496 * _e1486);
                                                let _e1501 = (_e1499 * _e1483);
                                                let _e1502 = (_e1470 * _e1499);
                                                let _e1503 = (_e1473 * _e1496);
                                                let _e1504 = (_e1483 * _e1473);
                                                let _e1505 = (_e1486 * _e1470);
                                                let _e1510 = (((_e1500 >= _e1501) && (_e1502 >= _e1503)) && (_e1504 >= _e1505));
                                                if (_e1510 || (((_e1500 <= _e1501) && (_e1502 <= _e1503)) && (_e1504 <= _e1505))) {
                                                    let _e1517 = select(-1f, 1f, _e1510);
                                                    let _e1519 = ((_e1500 - _e1501) * _e1517);
                                                    let _e1521 = select(0f, _e1519, (_e1519 > 0f));
                                                    let _e1523 = ((_e1502 - _e1503) * _e1517);
                                                    let _e1525 = select(0f, _e1523, (_e1523 > 0f));
                                                    let _e1527 = ((_e1504 - _e1505) * _e1517);
                                                    let _e1529 = select(0f, _e1527, (_e1527 > 0f));
                                                    let _e1531 = ((_e1521 + _e1525) + _e1529);
                                                    if (_e1531 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2525_ = type_20();
                                                        phi_2526_ = true;
                                                        phi_2527_ = false;
                                                    } else {
                                                        let _e1534 = select(_e1483, _e1470, (_e1470 < _e1483));
                                                        if (select(_e1496, _e1534, (_e1534 < _e1496)) > 0f) {
                                                            phi_1814_ = true;
                                                        } else {
                                                            let _e1539 = select(_e1483, _e1470, (_e1470 > _e1483));
                                                            phi_1814_ = (select(_e1496, _e1539, (_e1539 > _e1496)) < 0f);
                                                        }
                                                        let _e1544 = phi_1814_;
                                                        if _e1544 {
                                                            phi_2522_ = type_20();
                                                            phi_2523_ = true;
                                                            phi_2524_ = false;
                                                        } else {
                                                            let _e1546 = select(_e1486, _e1473, (_e1473 < _e1486));
                                                            if (select(_e1499, _e1546, (_e1546 < _e1499)) > 0f) {
                                                                phi_1843_ = true;
                                                            } else {
                                                                let _e1551 = select(_e1486, _e1473, (_e1473 > _e1486));
                                                                phi_1843_ = (select(_e1499, _e1551, (_e1551 > _e1499)) < 0f);
                                                            }
                                                            let _e1556 = phi_1843_;
                                                            if _e1556 {
                                                                phi_2520_ = type_20();
                                                                phi_2521_ = false;
                                                            } else {
                                                                let _e1558 = select(_e1459[1][0], _e1459[0][0], (_e1459[0][0] < _e1459[1][0]));
                                                                let _e1562 = select(_e1459[1][0], _e1459[0][0], (_e1459[0][0] > _e1459[1][0]));
                                                                let _e1566 = select(_e1459[1][1], _e1459[0][1], (_e1459[0][1] < _e1459[1][1]));
                                                                let _e1570 = select(_e1459[1][1], _e1459[0][1], (_e1459[0][1] > _e1459[1][1]));
                                                                let _e1574 = select(_e1459[1][2], _e1459[0][2], (_e1459[0][2] < _e1459[1][2]));
                                                                let _e1578 = select(_e1459[1][2], _e1459[0][2], (_e1459[0][2] > _e1459[1][2]));
                                                                let _e1583 = ((select(_e1459[2][0], _e1558, (_e1558 < _e1459[2][0])) - _e332) * _e337);
                                                                let _e1584 = ((select(_e1459[2][0], _e1562, (_e1562 > _e1459[2][0])) - _e333) * _e337);
                                                                let _e1587 = ((select(_e1459[2][1], _e1566, (_e1566 < _e1459[2][1])) - _e370) * _e375);
                                                                let _e1588 = ((select(_e1459[2][1], _e1570, (_e1570 > _e1459[2][1])) - _e371) * _e375);
                                                                let _e1591 = ((select(_e1459[2][2], _e1574, (_e1574 < _e1459[2][2])) - _e408) * _e413);
                                                                let _e1592 = ((select(_e1459[2][2], _e1578, (_e1578 > _e1459[2][2])) - _e409) * _e413);
                                                                let _e1594 = select(_e1592, _e1591, (_e1591 < _e1592));
                                                                let _e1596 = select(_e1592, _e1591, (_e1591 > _e1592));
                                                                let _e1598 = select(_e1584, _e1583, (_e1583 < _e1584));
                                                                let _e1600 = select(_e1588, _e1587, (_e1587 < _e1588));
                                                                let _e1602 = select(_e1600, _e1598, (_e1598 > _e1600));
                                                                let _e1604 = select(_e1594, _e1602, (_e1602 > _e1594));
                                                                let _e1606 = select(_e1584, _e1583, (_e1583 > _e1584));
                                                                let _e1608 = select(_e1588, _e1587, (_e1587 > _e1588));
                                                                let _e1610 = select(_e1608, _e1606, (_e1606 < _e1608));
                                                                let _e1612 = select(_e1596, _e1610, (_e1610 < _e1596));
                                                                let _e1613 = -(_e1594);
                                                                let _e1619 = select(_e460, _e1604, (_e1604 > _e460));
                                                                if (_e1619 > (_e1612 + (select(_e1613, _e1596, (_e1596 > _e1613)) * 0.0000019073523f))) {
                                                                    phi_2515_ = type_20();
                                                                    phi_2516_ = true;
                                                                } else {
                                                                    let _e1621 = (_e1619 > _e1030.member_1);
                                                                    if _e1621 {
                                                                        phi_2514_ = type_20();
                                                                    } else {
                                                                        let _e1622 = vec3<f32>(_e1459[0][0], _e1459[0][1], _e1459[0][2]);
                                                                        let _e1623 = vec3<f32>(_e1459[1][0], _e1459[1][1], _e1459[1][2]);
                                                                        let _e1624 = vec3<f32>(_e1459[2][0], _e1459[2][1], _e1459[2][2]);
                                                                        let _e1625 = (_e1459[1][0] - _e1459[0][0]);
                                                                        let _e1626 = (_e1459[1][1] - _e1459[0][1]);
                                                                        let _e1627 = (_e1459[1][2] - _e1459[0][2]);
                                                                        let _e1628 = vec3<f32>(_e1625, _e1626, _e1627);
                                                                        let _e1629 = (_e1459[2][0] - _e1459[1][0]);
                                                                        let _e1630 = (_e1459[2][1] - _e1459[1][1]);
                                                                        let _e1631 = (_e1459[2][2] - _e1459[1][2]);
                                                                        let _e1632 = vec3<f32>(_e1629, _e1630, _e1631);
                                                                        let _e1633 = (_e1459[0][0] - _e1459[2][0]);
                                                                        let _e1634 = (_e1459[0][1] - _e1459[2][1]);
                                                                        let _e1635 = (_e1459[0][2] - _e1459[2][2]);
                                                                        let _e1636 = vec3<f32>(_e1633, _e1634, _e1635);
                                                                        let _e1639 = bitcast<f32>((bitcast<u32>(_e1625) & 2147483647u));
                                                                        let _e1642 = bitcast<f32>((bitcast<u32>(_e1626) & 2147483647u));
                                                                        let _e1644 = select(_e1642, _e1639, (_e1639 > _e1642));
                                                                        let _e1647 = bitcast<f32>((bitcast<u32>(_e1627) & 2147483647u));
                                                                        let _e1649 = select(_e1647, _e1644, (_e1644 > _e1647));
                                                                        let _e1652 = bitcast<f32>((bitcast<u32>(_e1629) & 2147483647u));
                                                                        let _e1655 = bitcast<f32>((bitcast<u32>(_e1630) & 2147483647u));
                                                                        let _e1657 = select(_e1655, _e1652, (_e1652 > _e1655));
                                                                        let _e1660 = bitcast<f32>((bitcast<u32>(_e1631) & 2147483647u));
                                                                        let _e1662 = select(_e1660, _e1657, (_e1657 > _e1660));
                                                                        let _e1665 = bitcast<f32>((bitcast<u32>(_e1633) & 2147483647u));
                                                                        let _e1668 = bitcast<f32>((bitcast<u32>(_e1634) & 2147483647u));
                                                                        let _e1670 = select(_e1668, _e1665, (_e1665 > _e1668));
                                                                        let _e1673 = bitcast<f32>((bitcast<u32>(_e1635) & 2147483647u));
                                                                        let _e1675 = select(_e1673, _e1670, (_e1670 > _e1673));
                                                                        let _e1677 = select(_e1662, _e1649, (_e1649 > _e1662));
                                                                        let _e1679 = select(_e1675, _e1677, (_e1677 > _e1675));
                                                                        if (_e1649 == _e1679) {
                                                                            phi_2244_ = _e1486;
                                                                            phi_2245_ = _e1483;
                                                                            phi_2246_ = _e1473;
                                                                            phi_2247_ = _e1470;
                                                                            phi_2248_ = _e1622;
                                                                            phi_2249_ = _e1636;
                                                                            phi_2250_ = _e1632;
                                                                            phi_2251_ = _e1628;
                                                                        } else {
                                                                            let _e1681 = (_e1662 == _e1679);
                                                                            let _e1686 = vec3(_e1681);
                                                                            phi_2244_ = select(_e1473, _e1499, _e1681);
                                                                            phi_2245_ = select(_e1470, _e1496, _e1681);
                                                                            phi_2246_ = select(_e1499, _e1486, _e1681);
                                                                            phi_2247_ = select(_e1496, _e1483, _e1681);
                                                                            phi_2248_ = select(_e1624, _e1623, _e1686);
                                                                            phi_2249_ = select(_e1632, _e1628, _e1686);
                                                                            phi_2250_ = select(_e1628, _e1636, _e1686);
                                                                            phi_2251_ = select(_e1636, _e1632, _e1686);
                                                                        }
                                                                        let _e1692 = phi_2244_;
                                                                        let _e1694 = phi_2245_;
                                                                        let _e1696 = phi_2246_;
                                                                        let _e1698 = phi_2247_;
                                                                        let _e1700 = phi_2248_;
                                                                        let _e1702 = phi_2249_;
                                                                        let _e1704 = phi_2250_;
                                                                        let _e1706 = phi_2251_;
                                                                        let _e1713 = ((_e1704.y * _e1702.z) - (_e1702.y * _e1704.z));
                                                                        let _e1718 = ((_e1704.z * _e1702.x) - (_e1702.z * _e1704.x));
                                                                        let _e1721 = ((_e1704.x * _e1702.y) - (_e1702.x * _e1704.y));
                                                                        if (_e1521 >= _e1525) {
                                                                            phi_2282_ = select(true, false, (_e1521 >= _e1529));
                                                                        } else {
                                                                            phi_2282_ = true;
                                                                        }
                                                                        let _e1726 = phi_2282_;
                                                                        if _e1726 {
                                                                            phi_2291_ = select(_e1624, _e1623, vec3((_e1525 >= _e1529)));
                                                                        } else {
                                                                            phi_2291_ = _e1622;
                                                                        }
                                                                        let _e1731 = phi_2291_;
                                                                        let _e1736 = (((_e1713 * _e334) + (_e1718 * _e372)) + (_e1721 * _e410));
                                                                        let _e1747 = (((_e1713 * (_e1731.x - _e309)) + (_e1718 * (_e1731.y - _e348))) + (_e1721 * (_e1731.z - _e386)));
                                                                        let _e1749 = (_e1694 - _e1698);
                                                                        let _e1750 = (_e1692 - _e1696);
                                                                        let _e1758 = (-(((_e1698 * _e1749) + (_e1696 * _e1750))) / ((_e1749 * _e1749) + (_e1750 * _e1750)));
                                                                        let _e1760 = select(1f, _e1758, (_e1758 < 1f));
                                                                        let _e1762 = select(0f, _e1760, (_e1760 > 0f));
                                                                        let _e1775 = ((_e1700.x + (_e1706.x * _e1762)) - _e309);
                                                                        let _e1776 = ((_e1700.y + (_e1706.y * _e1762)) - _e348);
                                                                        let _e1777 = ((_e1700.z + (_e1706.z * _e1762)) - _e386);
                                                                        let _e1778 = (_e1777 / _e410);
                                                                        let _e1790 = bitcast<f32>((bitcast<u32>(_e1775) & 2147483647u));
                                                                        let _e1793 = bitcast<f32>((bitcast<u32>(_e1776) & 2147483647u));
                                                                        let _e1795 = select(_e1793, _e1790, (_e1790 > _e1793));
                                                                        let _e1798 = bitcast<f32>((bitcast<u32>(_e1777) & 2147483647u));
                                                                        let _e1800 = select(_e1798, _e1795, (_e1795 > _e1798));
                                                                        let _e1806 = bitcast<f32>((bitcast<u32>(_e1713) & 2147483647u));
                                                                        let _e1809 = bitcast<f32>((bitcast<u32>(_e1718) & 2147483647u));
                                                                        let _e1811 = select(_e1809, _e1806, (_e1806 > _e1809));
                                                                        let _e1814 = bitcast<f32>((bitcast<u32>(_e1721) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1713 * _e1775) + (_e1718 * _e1776)) + (_e1721 * _e1777)) - _e1747)) & 2147483647u)) <= ((0.0000009536743f * select(_e1679, _e1800, (_e1800 > _e1679))) * select(_e1814, _e1811, (_e1811 > _e1814)))) {
                                                                            let _e1824 = bitcast<f32>((bitcast<u32>(_e1704.x) & 2147483647u));
                                                                            let _e1827 = bitcast<f32>((bitcast<u32>(_e1704.y) & 2147483647u));
                                                                            let _e1829 = select(_e1827, _e1824, (_e1824 > _e1827));
                                                                            let _e1832 = bitcast<f32>((bitcast<u32>(_e1704.z) & 2147483647u));
                                                                            let _e1838 = bitcast<f32>((bitcast<u32>(_e1702.x) & 2147483647u));
                                                                            let _e1841 = bitcast<f32>((bitcast<u32>(_e1702.y) & 2147483647u));
                                                                            let _e1843 = select(_e1841, _e1838, (_e1838 > _e1841));
                                                                            let _e1846 = bitcast<f32>((bitcast<u32>(_e1702.z) & 2147483647u));
                                                                            phi_2458_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1736) & 2147483647u)) > ((0.0000038146973f * select(_e1832, _e1829, (_e1829 > _e1832))) * select(_e1846, _e1843, (_e1843 > _e1846)))));
                                                                        } else {
                                                                            phi_2458_ = true;
                                                                        }
                                                                        let _e1853 = phi_2458_;
                                                                        if _e1853 {
                                                                            let _e1864 = ((((_e1713 * (_e1775 - (_e334 * _e1778))) + (_e1718 * (_e1776 - (_e372 * _e1778)))) + (_e1721 * (_e1777 - _e1777))) / _e1736);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1864) & 2147483647u)) <= _e1679) {
                                                                                phi_2482_ = (_e1778 + _e1864);
                                                                            } else {
                                                                                phi_2482_ = _e1778;
                                                                            }
                                                                            let _e1871 = phi_2482_;
                                                                            phi_2483_ = _e1871;
                                                                        } else {
                                                                            phi_2483_ = (_e1747 / _e1736);
                                                                        }
                                                                        let _e1873 = phi_2483_;
                                                                        let _e1875 = select(_e1612, _e1873, (_e1873 < _e1612));
                                                                        let _e1877 = select(_e1604, _e1875, (_e1875 > _e1604));
                                                                        if (_e1877 >= _e460) {
                                                                            let _e1879 = (_e1877 <= _e1030.member_1);
                                                                            if _e1879 {
                                                                                let _e1880 = (1f / _e1531);
                                                                                phi_2506_ = type_20(_e1877, (_e1525 * _e1880), (_e1529 * _e1880), _e1090);
                                                                            } else {
                                                                                phi_2506_ = type_20();
                                                                            }
                                                                            let _e1885 = phi_2506_;
                                                                            phi_2508_ = _e1885;
                                                                            phi_2509_ = select(true, false, _e1879);
                                                                        } else {
                                                                            phi_2508_ = type_20();
                                                                            phi_2509_ = true;
                                                                        }
                                                                        let _e1888 = phi_2508_;
                                                                        let _e1890 = phi_2509_;
                                                                        if _e1890 {
                                                                            phi_2513_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2513_ = _e1888;
                                                                        }
                                                                        let _e1892 = phi_2513_;
                                                                        phi_2514_ = _e1892;
                                                                    }
                                                                    let _e1894 = phi_2514_;
                                                                    phi_2515_ = _e1894;
                                                                    phi_2516_ = _e1621;
                                                                }
                                                                let _e1896 = phi_2515_;
                                                                let _e1898 = phi_2516_;
                                                                phi_2520_ = _e1896;
                                                                phi_2521_ = _e1898;
                                                            }
                                                            let _e1900 = phi_2520_;
                                                            let _e1902 = phi_2521_;
                                                            phi_2522_ = _e1900;
                                                            phi_2523_ = _e1556;
                                                            phi_2524_ = _e1902;
                                                        }
                                                        let _e1904 = phi_2522_;
                                                        let _e1906 = phi_2523_;
                                                        let _e1908 = phi_2524_;
                                                        phi_2525_ = _e1904;
                                                        phi_2526_ = _e1906;
                                                        phi_2527_ = _e1908;
                                                    }
                                                    let _e1910 = phi_2525_;
                                                    let _e1912 = phi_2526_;
                                                    let _e1914 = phi_2527_;
                                                    phi_2535_ = _e1910;
                                                    phi_2536_ = select(_e1914, true, _e1912);
                                                } else {
                                                    phi_2535_ = type_20();
                                                    phi_2536_ = true;
                                                }
                                                let _e1917 = phi_2535_;
                                                let _e1919 = phi_2536_;
                                                if _e1919 {
                                                    phi_2540_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2540_ = _e1917;
                                                }
                                                let _e1921 = phi_2540_;
                                                if (_e1921.member_3 != 4294967295u) {
                                                    if (_e1090 != 4294967295u) {
                                                        if (_e1921.member < _e1030.member.member) {
                                                            phi_2566_ = true;
                                                        } else {
                                                            if (_e1921.member == _e1030.member.member) {
                                                                phi_2565_ = (_e1921.member_3 < _e1030.member.member_3);
                                                            } else {
                                                                phi_2565_ = false;
                                                            }
                                                            let _e1934 = phi_2565_;
                                                            phi_2566_ = _e1934;
                                                        }
                                                        let _e1936 = phi_2566_;
                                                        if _e1936 {
                                                            phi_2572_ = type_32(_e1921, _e1921.member);
                                                        } else {
                                                            phi_2572_ = _e1030;
                                                        }
                                                        let _e1939 = phi_2572_;
                                                        phi_2573_ = _e1939;
                                                    } else {
                                                        phi_2573_ = _e1030;
                                                    }
                                                    let _e1941 = phi_2573_;
                                                    phi_2574_ = _e1941;
                                                } else {
                                                    phi_2574_ = _e1030;
                                                }
                                                let _e1943 = phi_2574_;
                                                phi_979_ = _e1943;
                                            } else {
                                                phi_979_ = type_32();
                                            }
                                            let _e1945 = phi_979_;
                                            continue;
                                            continuing {
                                                phi_978_ = _e1945;
                                                phi_981_ = _e1045;
                                                phi_4078_ = _e502;
                                                break if !(_e1051);
                                            }
                                        }
                                        let _e1948 = phi_4078_;
                                        phi_4267_ = _e1948;
                                        if _e1948 {
                                            break;
                                        }
                                        phi_4271_ = _e1948;
                                        let _e2174 = local_11;
                                        phi_3814_ = _e2174;
                                        phi_3815_ = _e543;
                                        phi_3816_ = false;
                                        phi_3817_ = _e547;
                                    } else {
                                        if (_e543.member_1 >= _e89) {
                                            phi_3370_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e543.member_1 < _e89) {
                                            } else {
                                                phi_4267_ = true;
                                                break;
                                            }
                                            let _e559 = (_e260 * 2u);
                                            let _e561 = ((1u + _e559) % 7u);
                                            if (_e561 < 7u) {
                                            } else {
                                                phi_4267_ = true;
                                                break;
                                            }
                                            let _e566 = global_4.member[_e543.member_1][_e561];
                                            let _e568 = ((_e559 + 2u) % 7u);
                                            if (_e568 < 7u) {
                                            } else {
                                                phi_4267_ = true;
                                                break;
                                            }
                                            let _e573 = global_4.member[_e543.member_1][_e568];
                                            let _e574 = (_e259 * 2u);
                                            let _e576 = ((1u + _e574) % 7u);
                                            if (_e576 < 7u) {
                                            } else {
                                                phi_4267_ = true;
                                                break;
                                            }
                                            let _e581 = global_4.member[_e543.member_1][_e576];
                                            let _e583 = ((_e574 + 2u) % 7u);
                                            if (_e583 < 7u) {
                                            } else {
                                                phi_4267_ = true;
                                                break;
                                            }
                                            let _e588 = global_4.member[_e543.member_1][_e583];
                                            let _e589 = (_e261 * 2u);
                                            let _e591 = ((1u + _e589) % 7u);
                                            if (_e591 < 7u) {
                                            } else {
                                                phi_4267_ = true;
                                                break;
                                            }
                                            let _e596 = global_4.member[_e543.member_1][_e591];
                                            let _e598 = ((_e589 + 2u) % 7u);
                                            if (_e598 < 7u) {
                                            } else {
                                                phi_4267_ = true;
                                                break;
                                            }
                                            let _e603 = global_4.member[_e543.member_1][_e598];
                                            let _e626 = (bitcast<f32>((bitcast<u32>((_e543.member.member_1.x - _e543.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e627 = (bitcast<f32>((bitcast<u32>((_e543.member.member_1.y - _e543.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e628 = (bitcast<f32>((bitcast<u32>((_e543.member.member_1.z - _e543.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e630 = select(_e140, _e626, (_e626 > _e140));
                                            let _e632 = select(_e140, _e627, (_e627 > _e140));
                                            let _e634 = select(_e140, _e628, (_e628 > _e140));
                                            let _e659 = bitcast<u32>((f32(bitcast<i32>((_e566 & 2097151u))) * _e630));
                                            let _e664 = (bitcast<i32>((_e566 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e667 = bitcast<f32>((_e659 & bitcast<u32>(_e664)));
                                            let _e668 = bitcast<u32>((f32(bitcast<i32>((_e581 & 2097151u))) * _e632));
                                            let _e673 = (bitcast<i32>((_e581 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e676 = bitcast<f32>((_e668 & bitcast<u32>(_e673)));
                                            let _e677 = bitcast<u32>((f32(bitcast<i32>((_e596 & 2097151u))) * _e634));
                                            let _e682 = (bitcast<i32>((_e596 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e685 = bitcast<f32>((_e677 & bitcast<u32>(_e682)));
                                            let _e689 = bitcast<f32>((_e659 & bitcast<u32>(~(_e664))));
                                            let _e693 = bitcast<f32>((_e668 & bitcast<u32>(~(_e673))));
                                            let _e697 = bitcast<f32>((_e677 & bitcast<u32>(~(_e682))));
                                            let _e698 = bitcast<u32>((f32(bitcast<i32>((_e573 & 2097151u))) * _e630));
                                            let _e703 = (bitcast<i32>((_e573 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e706 = bitcast<f32>((_e698 & bitcast<u32>(_e703)));
                                            let _e707 = bitcast<u32>((f32(bitcast<i32>((_e588 & 2097151u))) * _e632));
                                            let _e712 = (bitcast<i32>((_e588 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e715 = bitcast<f32>((_e707 & bitcast<u32>(_e712)));
                                            let _e716 = bitcast<u32>((f32(bitcast<i32>((_e603 & 2097151u))) * _e634));
                                            let _e721 = (bitcast<i32>((_e603 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e724 = bitcast<f32>((_e716 & bitcast<u32>(_e721)));
                                            let _e728 = bitcast<f32>((_e698 & bitcast<u32>(~(_e703))));
                                            let _e732 = bitcast<f32>((_e707 & bitcast<u32>(~(_e712))));
                                            let _e736 = bitcast<f32>((_e716 & bitcast<u32>(~(_e721))));
                                            let _e737 = (_e543.member.member.x + _e667);
                                            let _e738 = (_e543.member.member.y + _e676);
                                            let _e739 = (_e543.member.member.z + _e685);
                                            let _e742 = (_e543.member.member_1.x - _e706);
                                            let _e743 = (_e543.member.member_1.y - _e715);
                                            let _e744 = (_e543.member.member_1.z - _e724);
                                            let _e763 = (_e742 - _e737);
                                            let _e764 = (_e743 - _e738);
                                            let _e765 = (_e744 - _e739);
                                            let _e767 = select(_e764, _e763, (_e763 > _e764));
                                            let _e769 = select(_e765, _e767, (_e767 > _e765));
                                            if (_e769 < (1024f * _e140)) {
                                                phi_3071_ = 0u;
                                            } else {
                                                phi_3071_ = select(2u, 1u, (_e769 < (2097152f * _e140)));
                                            }
                                            let _e776 = phi_3071_;
                                            switch bitcast<i32>(_e776) {
                                                case 0: {
                                                    phi_3077_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3077_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3077_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3077_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e779 = phi_3077_;
                                            let _e785 = global_4.member[_e543.member_1][0u];
                                            let _e789 = global_4.member[_e543.member_1][2u];
                                            let _e793 = global_4.member[_e543.member_1][4u];
                                            let _e797 = global_4.member[_e543.member_1][6u];
                                            let _e809 = (((_e789 >> bitcast<u32>(22i)) | ((_e793 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e797 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e810 = (_e785 & 268435455u);
                                            let _e811 = (_e809 & 268435455u);
                                            let _e814 = ((_e785 >> bitcast<u32>(28u)) & 7u);
                                            let _e822 = ((_e785 >> bitcast<u32>(31i)) | (((_e809 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e823 = (_e814 != 0u);
                                            if (_e814 == 0u) {
                                                phi_3332_ = _e810;
                                            } else {
                                                if (_e814 == 7u) {
                                                    phi_3331_ = 2147483648u;
                                                } else {
                                                    phi_3331_ = ((2147483648u | (_e814 << bitcast<u32>(28u))) | (_e811 & 268435455u));
                                                }
                                                let _e832 = phi_3331_;
                                                phi_3332_ = _e832;
                                            }
                                            let _e834 = phi_3332_;
                                            if _e823 {
                                                let _e835 = (_e814 != 7u);
                                                if _e835 {
                                                    phi_3342_ = (_e811 + (_e814 * ((3u * _e779) + 1u)));
                                                } else {
                                                    phi_3342_ = u32();
                                                }
                                                let _e839 = phi_3342_;
                                                phi_3344_ = _e839;
                                                phi_3345_ = select(true, false, _e835);
                                            } else {
                                                phi_3344_ = u32();
                                                phi_3345_ = true;
                                            }
                                            let _e842 = phi_3344_;
                                            let _e844 = phi_3345_;
                                            if (_e822 == 0u) {
                                                phi_3366_ = (_e810 + select(0u, 1u, !(_e823)));
                                            } else {
                                                if (_e822 == 7u) {
                                                    phi_3365_ = 2147483648u;
                                                } else {
                                                    phi_3365_ = ((2147483648u | (_e822 << bitcast<u32>(28u))) | (select(_e842, _e811, _e844) & 268435455u));
                                                }
                                                let _e857 = phi_3365_;
                                                phi_3366_ = _e857;
                                            }
                                            let _e859 = phi_3366_;
                                            phi_3370_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e737, (_e543.member.member.x + _e689), _e742, (_e543.member.member_1.x - _e728)), vec4<f32>(_e738, (_e543.member.member.y + _e693), _e743, (_e543.member.member_1.y - _e732)), vec4<f32>(_e739, (_e543.member.member.z + _e697), _e744, (_e543.member.member_1.z - _e736))), type_49(type_28((_e543.member.member + vec4<f32>(_e667, _e676, _e685, 0f)), (_e543.member.member_1 - vec4<f32>(_e706, _e715, _e724, 0f))), _e834), type_49(type_28((_e543.member.member + vec4<f32>(_e689, _e693, _e697, 0f)), (_e543.member.member_1 - vec4<f32>(_e728, _e732, _e736, 0f))), _e859));
                                        }
                                        let _e864 = phi_3370_;
                                        let _e876 = ((_e864.member[0].x - _e332) * _e337);
                                        let _e877 = ((_e864.member[0].y - _e332) * _e337);
                                        let _e878 = ((_e864.member[0].z - _e333) * _e337);
                                        let _e879 = ((_e864.member[0].w - _e333) * _e337);
                                        let _e889 = ((_e864.member[1].x - _e370) * _e375);
                                        let _e890 = ((_e864.member[1].y - _e370) * _e375);
                                        let _e891 = ((_e864.member[1].z - _e371) * _e375);
                                        let _e892 = ((_e864.member[1].w - _e371) * _e375);
                                        let _e902 = ((_e864.member[2].x - _e408) * _e413);
                                        let _e903 = ((_e864.member[2].y - _e408) * _e413);
                                        let _e904 = ((_e864.member[2].z - _e409) * _e413);
                                        let _e905 = ((_e864.member[2].w - _e409) * _e413);
                                        let _e907 = select(_e904, _e902, (_e902 < _e904));
                                        let _e909 = select(_e905, _e903, (_e903 < _e905));
                                        let _e911 = select(_e904, _e902, (_e902 > _e904));
                                        let _e913 = select(_e905, _e903, (_e903 > _e905));
                                        let _e915 = select(_e878, _e876, (_e876 < _e878));
                                        let _e917 = select(_e879, _e877, (_e877 < _e879));
                                        let _e919 = select(_e891, _e889, (_e889 < _e891));
                                        let _e921 = select(_e892, _e890, (_e890 < _e892));
                                        let _e923 = select(_e919, _e915, (_e915 > _e919));
                                        let _e925 = select(_e921, _e917, (_e917 > _e921));
                                        let _e927 = select(_e907, _e923, (_e923 > _e907));
                                        let _e929 = select(_e909, _e925, (_e925 > _e909));
                                        let _e931 = select(_e878, _e876, (_e876 > _e878));
                                        let _e933 = select(_e879, _e877, (_e877 > _e879));
                                        let _e935 = select(_e891, _e889, (_e889 > _e891));
                                        let _e937 = select(_e892, _e890, (_e890 > _e892));
                                        let _e939 = select(_e935, _e931, (_e931 < _e935));
                                        let _e941 = select(_e937, _e933, (_e933 < _e937));
                                        let _e946 = -(_e907);
                                        let _e947 = -(_e909);
                                        let _e954 = (select(_e911, _e939, (_e939 < _e911)) + (select(_e946, _e911, (_e911 > _e946)) * 0.0000019073523f));
                                        let _e955 = (select(_e913, _e941, (_e941 < _e913)) + (select(_e947, _e913, (_e913 > _e947)) * 0.0000019073523f));
                                        let _e957 = select(_e460, _e927, (_e927 > _e460));
                                        let _e959 = select(_e460, _e929, (_e929 > _e460));
                                        let _e964 = (_e957 <= select(_e504.member_1, _e954, (_e954 < _e504.member_1)));
                                        let _e965 = (_e959 <= select(_e504.member_1, _e955, (_e955 < _e504.member_1)));
                                        let _e966 = (_e957 <= _e959);
                                        if _e964 {
                                            if _e965 {
                                                if _e966 {
                                                    phi_3714_ = _e864.member_2;
                                                } else {
                                                    phi_3714_ = _e864.member_1;
                                                }
                                                let _e970 = phi_3714_;
                                                let _e992 = (_e547 % 128u);
                                                let _e993 = (_e992 < 128u);
                                                if _e993 {
                                                } else {
                                                    phi_4267_ = true;
                                                    break;
                                                }
                                                local_8[_e992] = _e970.member_1;
                                                if _e993 {
                                                } else {
                                                    phi_4267_ = true;
                                                    break;
                                                }
                                                local_7[_e992] = _e970.member.member.x;
                                                if _e993 {
                                                } else {
                                                    phi_4267_ = true;
                                                    break;
                                                }
                                                local_6[_e992] = _e970.member.member.y;
                                                if _e993 {
                                                } else {
                                                    phi_4267_ = true;
                                                    break;
                                                }
                                                local_5[_e992] = _e970.member.member.z;
                                                if _e993 {
                                                } else {
                                                    phi_4267_ = true;
                                                    break;
                                                }
                                                local_4[_e992] = _e970.member.member_1.x;
                                                if _e993 {
                                                } else {
                                                    phi_4267_ = true;
                                                    break;
                                                }
                                                local_3[_e992] = _e970.member.member_1.y;
                                                if _e993 {
                                                } else {
                                                    phi_4267_ = true;
                                                    break;
                                                }
                                                local_2[_e992] = _e970.member.member_1.z;
                                                if _e993 {
                                                } else {
                                                    phi_4267_ = true;
                                                    break;
                                                }
                                                local_9[_e992] = select(_e959, _e957, (_e957 > _e959));
                                                if _e966 {
                                                    phi_3791_ = _e864.member_1;
                                                } else {
                                                    phi_3791_ = _e864.member_2;
                                                }
                                                let _e1006 = phi_3791_;
                                                phi_3792_ = _e1006;
                                                phi_3793_ = (_e547 + 1u);
                                            } else {
                                                phi_3792_ = type_49();
                                                phi_3793_ = u32();
                                            }
                                            let _e1008 = phi_3792_;
                                            let _e1010 = phi_3793_;
                                            phi_3795_ = _e1008;
                                            phi_3796_ = _e1010;
                                            phi_3797_ = select(true, false, _e965);
                                        } else {
                                            phi_3795_ = type_49();
                                            phi_3796_ = u32();
                                            phi_3797_ = true;
                                        }
                                        let _e1013 = phi_3795_;
                                        let _e1015 = phi_3796_;
                                        let _e1017 = phi_3797_;
                                        if _e1017 {
                                            if _e964 {
                                                phi_3806_ = _e864.member_1;
                                            } else {
                                                phi_3806_ = _e864.member_2;
                                            }
                                            let _e1021 = phi_3806_;
                                            phi_3811_ = _e1021;
                                            phi_3812_ = select(_e965, true, _e964);
                                        } else {
                                            phi_3811_ = _e1013;
                                            phi_3812_ = _e545;
                                        }
                                        let _e1024 = phi_3811_;
                                        let _e1026 = phi_3812_;
                                        phi_4271_ = _e502;
                                        phi_3814_ = _e504;
                                        phi_3815_ = _e1024;
                                        phi_3816_ = _e1026;
                                        phi_3817_ = select(_e1015, _e547, _e1017);
                                    }
                                    let _e1950 = phi_4271_;
                                    let _e1952 = phi_3814_;
                                    let _e1954 = phi_3815_;
                                    let _e1956 = phi_3816_;
                                    let _e1958 = phi_3817_;
                                    phi_4270_ = _e1950;
                                    phi_3818_ = _e1952;
                                    phi_3819_ = _e1954;
                                    phi_3820_ = (_e508 - 1u);
                                    phi_3821_ = _e1956;
                                    phi_3822_ = _e1958;
                                } else {
                                    phi_4270_ = _e502;
                                    phi_3818_ = _e504;
                                    phi_3819_ = _e543;
                                    phi_3820_ = _e508;
                                    phi_3821_ = _e545;
                                    phi_3822_ = _e547;
                                }
                                let _e1960 = phi_4270_;
                                let _e1962 = phi_3818_;
                                let _e1964 = phi_3819_;
                                let _e1966 = phi_3820_;
                                let _e1968 = phi_3821_;
                                let _e1970 = phi_3822_;
                                phi_4269_ = _e1960;
                                phi_3823_ = _e1962;
                                phi_3824_ = _e1964;
                                phi_3825_ = _e1966;
                                phi_3826_ = _e1968;
                                phi_3827_ = _e1970;
                            } else {
                                phi_4269_ = _e502;
                                phi_3823_ = type_32();
                                phi_3824_ = type_49();
                                phi_3825_ = u32();
                                phi_3826_ = bool();
                                phi_3827_ = u32();
                            }
                            let _e1972 = phi_4269_;
                            let _e1974 = phi_3823_;
                            let _e1976 = phi_3824_;
                            let _e1978 = phi_3825_;
                            let _e1980 = phi_3826_;
                            let _e1982 = phi_3827_;
                            phi_4268_ = _e1972;
                            phi_852_ = _e1974;
                            phi_855_ = _e1976;
                            phi_857_ = _e1978;
                            phi_859_ = _e1980;
                            phi_861_ = _e1982;
                            phi_3828_ = _e516;
                        } else {
                            phi_4268_ = _e502;
                            phi_852_ = type_32();
                            phi_855_ = type_49();
                            phi_857_ = u32();
                            phi_859_ = bool();
                            phi_861_ = u32();
                            phi_3828_ = false;
                        }
                        let _e1984 = phi_4268_;
                        let _e1986 = phi_852_;
                        let _e1988 = phi_855_;
                        let _e1990 = phi_857_;
                        let _e1992 = phi_859_;
                        let _e1994 = phi_861_;
                        let _e1996 = phi_3828_;
                        continue;
                        continuing {
                            phi_4084_ = _e1984;
                            phi_851_ = _e1986;
                            phi_854_ = _e1988;
                            phi_856_ = _e1990;
                            phi_858_ = _e1992;
                            phi_860_ = _e1994;
                            phi_4267_ = _e1984;
                            break if !(_e1996);
                        }
                    }
                    let _e1999 = phi_4267_;
                    if _e1999 {
                        break;
                    }
                    let _e2001 = local_10;
                    if (_e2001.member.member_3 != 4294967295u) {
                        let _e2006 = -(_e427);
                        let _e2007 = (_e2006 / 3i);
                        let _e2014 = bitcast<f32>((bitcast<u32>((_e2007 + 127i)) << bitcast<u32>(23i)));
                        let _e2022 = (((_e2001.member.member * _e2014) * _e2014) * bitcast<f32>((bitcast<u32>(((_e2006 - (2i * _e2007)) + 127i)) << bitcast<u32>(23i))));
                        let _e2024 = select(340282350000000000000000000000000000000f, _e2022, (_e2022 < 340282350000000000000000000000000000000f));
                        phi_3880_ = type_20(select(-340282350000000000000000000000000000000f, _e2024, (_e2024 > -340282350000000000000000000000000000000f)), _e2001.member.member_1, _e2001.member.member_2, _e2001.member.member_3);
                    } else {
                        phi_3880_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2031 = phi_3880_;
                    if _e148 {
                    } else {
                        break;
                    }
                    global_6.member[_e146] = _e2031;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
