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

struct type_21 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_31 {
    member: array<type_21>,
}

struct type_33 {
    member: f32,
    member_1: bool,
}

struct type_35 {
    member: array<vec4<u32>, 2>,
}

struct type_42 {
    member: array<array<u32, 7>>,
}

struct type_48 {
    member: type_24,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_48,
    member_2: type_48,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_35;
@group(0) @binding(4) 
var<storage> global_3: type_31;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(2) 
var<storage> global_5: type_42;
@group(0) @binding(3) 
var<storage> global_6: type_4;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_48, 128>;
    var local_4: array<u32, 3>;
    var local_5: array<array<f32, 3>, 3>;
    var local_6: array<f32, 4>;
    var phi_395_: i32;
    var phi_396_: i32;
    var phi_406_: bool;
    var phi_416_: u32;
    var phi_417_: u32;
    var phi_419_: bool;
    var phi_424_: u32;
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
    var phi_601_: f32;
    var phi_607_: f32;
    var phi_618_: f32;
    var phi_624_: f32;
    var phi_647_: f32;
    var phi_658_: f32;
    var phi_758_: f32;
    var phi_759_: f32;
    var phi_4473_: bool;
    var phi_1879_: type_33;
    var phi_1882_: type_48;
    var phi_1884_: u32;
    var phi_1886_: bool;
    var phi_1888_: u32;
    var phi_1899_: bool;
    var phi_1936_: type_48;
    var phi_1937_: bool;
    var phi_1938_: u32;
    var phi_3541_: u32;
    var phi_3547_: u32;
    var phi_3801_: u32;
    var phi_3802_: u32;
    var phi_3812_: u32;
    var phi_3814_: u32;
    var phi_3815_: bool;
    var phi_3835_: u32;
    var phi_3836_: u32;
    var phi_3840_: type_51;
    var phi_4184_: type_48;
    var phi_4217_: type_48;
    var phi_4218_: type_48;
    var phi_4219_: u32;
    var phi_4221_: type_48;
    var phi_4222_: u32;
    var phi_4223_: bool;
    var phi_4232_: type_48;
    var phi_4237_: type_48;
    var phi_4238_: bool;
    var phi_4470_: bool;
    var phi_1957_: type_33;
    var phi_1960_: type_8;
    var phi_1961_: type_8;
    var phi_1983_: type_8;
    var phi_2024_: u32;
    var phi_2030_: u32;
    var phi_2040_: u32;
    var phi_2056_: u32;
    var phi_2093_: u32;
    var phi_2099_: u32;
    var phi_2109_: u32;
    var phi_4455_: bool;
    var phi_2125_: type_8;
    var phi_2126_: type_8;
    var phi_2149_: type_8;
    var phi_2172_: u32;
    var phi_2187_: u32;
    var phi_2190_: type_8;
    var phi_2191_: type_8;
    var phi_2214_: type_8;
    var phi_2280_: u32;
    var phi_2260_: u32;
    var phi_2261_: u32;
    var phi_2284_: f32;
    var phi_4448_: bool;
    var phi_4523_: bool;
    var phi_4522_: bool;
    var phi_2784_: vec3<f32>;
    var phi_2785_: vec3<f32>;
    var phi_2816_: bool;
    var phi_2825_: vec3<f32>;
    var phi_2865_: type_20;
    var phi_2867_: type_20;
    var phi_2868_: bool;
    var phi_2872_: type_20;
    var phi_2873_: type_20;
    var phi_2874_: type_20;
    var phi_2875_: bool;
    var phi_2879_: type_20;
    var phi_2880_: bool;
    var phi_2884_: type_20;
    var phi_2885_: bool;
    var phi_2889_: type_20;
    var phi_2900_: type_33;
    var phi_2901_: type_33;
    var phi_4525_: bool;
    var phi_1958_: type_33;
    var phi_4524_: bool;
    var local_7: type_33;
    var phi_4584_: bool;
    var phi_4240_: type_33;
    var phi_4241_: type_48;
    var phi_4242_: bool;
    var phi_4243_: u32;
    var phi_4583_: bool;
    var phi_4244_: type_33;
    var phi_4245_: type_48;
    var phi_4246_: u32;
    var phi_4247_: bool;
    var phi_4248_: u32;
    var phi_4582_: bool;
    var phi_4249_: type_33;
    var phi_4250_: type_48;
    var phi_4251_: u32;
    var phi_4252_: bool;
    var phi_4253_: u32;
    var phi_4581_: bool;
    var phi_1880_: type_33;
    var phi_1883_: type_48;
    var phi_1885_: u32;
    var phi_1887_: bool;
    var phi_1889_: u32;
    var phi_4254_: bool;
    var phi_4580_: bool;
    var local_8: type_33;
    var local_9: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e85 = global;
            let _e87 = arrayLength((&global_5.member));
            let _e90 = arrayLength((&global_6.member));
            let _e98 = global_2.member[0u][0u];
            let _e102 = global_2.member[0u][1u];
            let _e106 = global_2.member[0u][2u];
            let _e110 = global_2.member[0u][3u];
            let _e114 = global_2.member[1u][0u];
            let _e118 = global_2.member[1u][1u];
            let _e122 = global_2.member[1u][2u];
            let _e125 = global_1.member[0u];
            let _e126 = bitcast<i32>(_e125);
            let _e138 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e110) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e98), bitcast<i32>(_e102), bitcast<i32>(_e106));
            local = array<i32, 3>(bitcast<i32>(_e114), bitcast<i32>(_e118), bitcast<i32>(_e122));
            let _e144 = (_e85.x + (_e85.y * 2097152u));
            let _e145 = (_e144 < arrayLength((&global_3.member)));
            if _e145 {
                let _e146 = (_e144 < arrayLength((&global_4.member)));
                if _e146 {
                    if _e145 {
                    } else {
                        break;
                    }
                    let _e154 = global_3.member[_e144].member_2[0u];
                    let _e156 = (bitcast<u32>(_e154) & 2147483647u);
                    let _e161 = global_3.member[_e144].member_2[1u];
                    let _e163 = (bitcast<u32>(_e161) & 2147483647u);
                    let _e168 = global_3.member[_e144].member_2[2u];
                    let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                    let _e175 = global_3.member[_e144].member[0u];
                    let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                    let _e182 = global_3.member[_e144].member[1u];
                    let _e184 = (bitcast<u32>(_e182) & 2147483647u);
                    let _e189 = global_3.member[_e144].member[2u];
                    let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                    let _e193 = select(_e163, _e156, (_e163 < _e156));
                    let _e195 = select(_e170, _e193, (_e170 < _e193));
                    let _e197 = select(_e177, _e195, (_e177 < _e195));
                    let _e199 = select(_e184, _e197, (_e184 < _e197));
                    let _e201 = select(_e191, _e199, (_e191 < _e199));
                    let _e205 = global_3.member[_e144].member_1;
                    let _e207 = (bitcast<u32>(_e205) & 2147483647u);
                    let _e214 = global_3.member[_e144].member_3;
                    let _e220 = (((select(_e207, _e201, (_e207 < _e201)) < 2139095040u) && ((bitcast<u32>(_e214) & 2147483647u) <= 2139095040u)) && (_e195 > 0u));
                    if _e220 {
                        let _e223 = (bitcast<u32>(bitcast<f32>(_e195)) & 2147483647u);
                        if (_e223 >= 8388608u) {
                            phi_395_ = (bitcast<i32>((_e223 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_395_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e223)), 32u, (_e223 == 0u))));
                        }
                        let _e237 = phi_395_;
                        phi_396_ = _e237;
                    } else {
                        phi_396_ = 0i;
                    }
                    let _e239 = phi_396_;
                    let _e240 = (_e156 == _e195);
                    if _e240 {
                        phi_406_ = true;
                    } else {
                        phi_406_ = (_e163 == _e195);
                    }
                    let _e243 = phi_406_;
                    let _e244 = select(1u, 0u, _e240);
                    if _e243 {
                        let _e245 = (_e244 + 1u);
                        phi_416_ = _e245;
                        phi_417_ = _e245;
                        phi_419_ = select(true, false, (_e245 == 2u));
                    } else {
                        phi_416_ = u32();
                        phi_417_ = 0u;
                        phi_419_ = true;
                    }
                    let _e249 = phi_416_;
                    let _e251 = phi_417_;
                    let _e253 = phi_419_;
                    if _e253 {
                        phi_424_ = (_e251 + 1u);
                    } else {
                        phi_424_ = 0u;
                    }
                    let _e257 = phi_424_;
                    let _e258 = select(_e249, _e251, _e253);
                    let _e259 = select(_e244, select(2u, _e244, _e243), _e253);
                    let _e260 = (_e126 / 2i);
                    let _e265 = bitcast<f32>((bitcast<u32>((_e260 + 127i)) << bitcast<u32>(23i)));
                    let _e271 = bitcast<f32>((bitcast<u32>(((_e126 - _e260) + 127i)) << bitcast<u32>(23i)));
                    let _e272 = -(_e239);
                    let _e273 = (_e272 / 2i);
                    let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                    let _e284 = bitcast<f32>((bitcast<u32>(((_e272 - _e273) + 127i)) << bitcast<u32>(23i)));
                    let _e288 = global_3.member[_e144].member;
                    let _e289 = (_e258 == 0u);
                    if _e289 {
                        phi_469_ = _e288[0];
                    } else {
                        phi_469_ = _e288[1];
                    }
                    let _e293 = phi_469_;
                    let _e294 = (_e258 == 2u);
                    if _e294 {
                        phi_475_ = _e288[2];
                    } else {
                        phi_475_ = _e293;
                    }
                    let _e297 = phi_475_;
                    let _e299 = ((_e297 * _e265) * _e271);
                    let _e300 = global_3.member[_e144].member_2;
                    if _e289 {
                        phi_486_ = _e300[0];
                    } else {
                        phi_486_ = _e300[1];
                    }
                    let _e304 = phi_486_;
                    if _e294 {
                        phi_492_ = _e300[2];
                    } else {
                        phi_492_ = _e304;
                    }
                    let _e307 = phi_492_;
                    let _e309 = ((_e307 * _e278) * _e284);
                    let _e313 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e313 {
                        let _e317 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) * 0.00000011920929f);
                        phi_515_ = select(0.00000000000011368684f, _e317, (_e317 > 0.00000000000011368684f));
                    } else {
                        phi_515_ = 0f;
                    }
                    let _e321 = phi_515_;
                    let _e322 = (_e299 + _e321);
                    let _e323 = (_e299 - _e321);
                    let _e324 = select(_e309, 0f, _e313);
                    if _e313 {
                        phi_526_ = 38685626000000000000000000f;
                    } else {
                        phi_526_ = (1f / _e309);
                    }
                    let _e327 = phi_526_;
                    let _e328 = (_e257 == 0u);
                    if _e328 {
                        phi_535_ = _e288[0];
                    } else {
                        phi_535_ = _e288[1];
                    }
                    let _e332 = phi_535_;
                    let _e333 = (_e257 == 2u);
                    if _e333 {
                        phi_541_ = _e288[2];
                    } else {
                        phi_541_ = _e332;
                    }
                    let _e336 = phi_541_;
                    let _e338 = ((_e336 * _e265) * _e271);
                    if _e328 {
                        phi_552_ = _e300[0];
                    } else {
                        phi_552_ = _e300[1];
                    }
                    let _e342 = phi_552_;
                    if _e333 {
                        phi_558_ = _e300[2];
                    } else {
                        phi_558_ = _e342;
                    }
                    let _e345 = phi_558_;
                    let _e347 = ((_e345 * _e278) * _e284);
                    let _e351 = (bitcast<f32>((bitcast<u32>(_e347) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e351 {
                        let _e355 = (bitcast<f32>((bitcast<u32>(_e338) & 2147483647u)) * 0.00000011920929f);
                        phi_581_ = select(0.00000000000011368684f, _e355, (_e355 > 0.00000000000011368684f));
                    } else {
                        phi_581_ = 0f;
                    }
                    let _e359 = phi_581_;
                    let _e360 = (_e338 + _e359);
                    let _e361 = (_e338 - _e359);
                    let _e362 = select(_e347, 0f, _e351);
                    if _e351 {
                        phi_592_ = 38685626000000000000000000f;
                    } else {
                        phi_592_ = (1f / _e347);
                    }
                    let _e365 = phi_592_;
                    let _e366 = (_e259 == 0u);
                    if _e366 {
                        phi_601_ = _e288[0];
                    } else {
                        phi_601_ = _e288[1];
                    }
                    let _e370 = phi_601_;
                    let _e371 = (_e259 == 2u);
                    if _e371 {
                        phi_607_ = _e288[2];
                    } else {
                        phi_607_ = _e370;
                    }
                    let _e374 = phi_607_;
                    let _e376 = ((_e374 * _e265) * _e271);
                    if _e366 {
                        phi_618_ = _e300[0];
                    } else {
                        phi_618_ = _e300[1];
                    }
                    let _e380 = phi_618_;
                    if _e371 {
                        phi_624_ = _e300[2];
                    } else {
                        phi_624_ = _e380;
                    }
                    let _e383 = phi_624_;
                    let _e385 = ((_e383 * _e278) * _e284);
                    let _e389 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e389 {
                        let _e393 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) * 0.00000011920929f);
                        phi_647_ = select(0.00000000000011368684f, _e393, (_e393 > 0.00000000000011368684f));
                    } else {
                        phi_647_ = 0f;
                    }
                    let _e397 = phi_647_;
                    let _e398 = (_e376 + _e397);
                    let _e399 = (_e376 - _e397);
                    let _e400 = select(_e385, 0f, _e389);
                    if _e389 {
                        phi_658_ = 38685626000000000000000000f;
                    } else {
                        phi_658_ = (1f / _e385);
                    }
                    let _e403 = phi_658_;
                    let _e406 = bitcast<f32>((bitcast<u32>(_e299) & 2147483647u));
                    let _e409 = bitcast<f32>((bitcast<u32>(_e338) & 2147483647u));
                    let _e411 = select(_e409, _e406, (_e406 > _e409));
                    let _e414 = bitcast<f32>((bitcast<u32>(_e376) & 2147483647u));
                    let _e417 = (_e126 + _e239);
                    if (_e220 && (select(_e414, _e411, (_e411 > _e414)) <= 1099511600000f)) {
                        let _e420 = (_e417 / 3i);
                        let _e427 = bitcast<f32>((bitcast<u32>((_e420 + 127i)) << bitcast<u32>(23i)));
                        let _e434 = bitcast<f32>((bitcast<u32>(((_e417 - (2i * _e420)) + 127i)) << bitcast<u32>(23i)));
                        let _e435 = (((_e205 * _e427) * _e427) * _e434);
                        let _e437 = select(340282350000000000000000000000000000000f, _e435, (_e435 < 340282350000000000000000000000000000000f));
                        let _e442 = (((_e214 * _e427) * _e427) * _e434);
                        let _e444 = select(340282350000000000000000000000000000000f, _e442, (_e442 < 340282350000000000000000000000000000000f));
                        phi_758_ = select(-340282350000000000000000000000000000000f, _e444, (_e444 > -340282350000000000000000000000000000000f));
                        phi_759_ = select(-340282350000000000000000000000000000000f, _e437, (_e437 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_758_ = 0f;
                        phi_759_ = 1f;
                    }
                    let _e448 = phi_758_;
                    let _e450 = phi_759_;
                    local_3 = array<type_48, 128>(type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e454 = (_e258 % 3u);
                    let _e455 = (_e454 < 3u);
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e457 = local_1[_e454];
                    let _e460 = (_e257 % 3u);
                    let _e461 = (_e460 < 3u);
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e463 = local_1[_e460];
                    let _e466 = (_e259 % 3u);
                    let _e467 = (_e466 < 3u);
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e469 = local_1[_e466];
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e474 = local[_e454];
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e478 = local[_e460];
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e482 = local[_e466];
                    phi_4473_ = false;
                    phi_1879_ = type_33(_e448, false);
                    phi_1882_ = type_48(type_24(vec4<f32>((f32(_e457) * _e138), (f32(_e463) * _e138), (f32(_e469) * _e138), 0f), vec4<f32>((f32(_e474) * _e138), (f32(_e478) * _e138), (f32(_e482) * _e138), 0f)), select(0u, 2147483648u, (_e87 == 0u)));
                    phi_1884_ = ((3u * _e87) + 1u);
                    phi_1886_ = (_e450 <= _e448);
                    phi_1888_ = 0u;
                    loop {
                        let _e492 = phi_4473_;
                        let _e494 = phi_1879_;
                        let _e496 = phi_1882_;
                        let _e498 = phi_1884_;
                        let _e500 = phi_1886_;
                        let _e502 = phi_1888_;
                        local_8 = _e494;
                        if _e500 {
                            phi_1899_ = true;
                        } else {
                            phi_1899_ = (_e502 > 0u);
                        }
                        let _e505 = phi_1899_;
                        if _e505 {
                            let _e506 = (_e498 > 0u);
                            if _e506 {
                                if _e500 {
                                    phi_1936_ = _e496;
                                    phi_1937_ = _e500;
                                    phi_1938_ = _e502;
                                } else {
                                    let _e507 = (_e502 - 1u);
                                    let _e508 = (_e507 % 128u);
                                    let _e509 = (_e508 < 128u);
                                    if _e509 {
                                    } else {
                                        phi_4580_ = true;
                                        break;
                                    }
                                    let _e511 = local_3[_e508];
                                    if _e509 {
                                    } else {
                                        phi_4580_ = true;
                                        break;
                                    }
                                    let _e519 = local_2[_e508];
                                    phi_1936_ = type_48(type_24(_e511.member.member, _e511.member.member_1), _e511.member_1);
                                    phi_1937_ = (_e519 <= _e494.member);
                                    phi_1938_ = _e507;
                                }
                                let _e523 = phi_1936_;
                                let _e525 = phi_1937_;
                                let _e527 = phi_1938_;
                                if _e525 {
                                    let _e532 = (_e523.member_1 & 268435455u);
                                    if ((_e523.member_1 & 2147483648u) != 0u) {
                                        phi_4470_ = _e492;
                                        phi_1957_ = _e494;
                                        phi_1960_ = type_8(0u, ((_e523.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e994 = phi_4470_;
                                            let _e996 = phi_1957_;
                                            let _e998 = phi_1960_;
                                            local_7 = _e996;
                                            local_9 = _e996;
                                            if (_e998.member < _e998.member_1) {
                                                phi_1961_ = type_8((_e998.member + 1u), _e998.member_1);
                                                phi_1983_ = type_8(1u, _e998.member);
                                            } else {
                                                phi_1961_ = _e998;
                                                phi_1983_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1011 = phi_1961_;
                                            let _e1013 = phi_1983_;
                                            let _e1017 = (bitcast<i32>(_e1013.member) != 0i);
                                            if _e1017 {
                                                let _e1022 = (_e523.member.member_1.x - _e523.member.member.x);
                                                let _e1025 = (_e523.member.member_1.y - _e523.member.member.y);
                                                let _e1028 = (_e523.member.member_1.z - _e523.member.member.z);
                                                let _e1030 = select(_e1025, _e1022, (_e1022 > _e1025));
                                                let _e1032 = select(_e1028, _e1030, (_e1030 > _e1028));
                                                let _e1034 = (_e1032 < (1024f * _e138));
                                                if _e1034 {
                                                    phi_2024_ = 0u;
                                                } else {
                                                    phi_2024_ = select(2u, 1u, (_e1032 < (2097152f * _e138)));
                                                }
                                                let _e1039 = phi_2024_;
                                                switch bitcast<i32>(_e1039) {
                                                    case 0: {
                                                        phi_2030_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2030_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2030_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2030_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1042 = phi_2030_;
                                                switch bitcast<i32>(_e1039) {
                                                    case 0: {
                                                        phi_2040_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2040_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2040_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2040_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1049 = phi_2040_;
                                                let _e1051 = ((_e532 + (_e1013.member_1 * ((3u * _e1042) + 1u))) + (3u * _e1049));
                                                let _e1052 = (_e1051 < _e90);
                                                if _e1052 {
                                                    if _e1052 {
                                                    } else {
                                                        phi_4524_ = true;
                                                        break;
                                                    }
                                                    let _e1054 = global_6.member[_e1051];
                                                    phi_2056_ = _e1054;
                                                } else {
                                                    phi_2056_ = 4294967295u;
                                                }
                                                let _e1056 = phi_2056_;
                                                local_4 = array<u32, 3>(_e258, _e257, _e259);
                                                if _e1034 {
                                                    phi_2093_ = 0u;
                                                } else {
                                                    phi_2093_ = select(2u, 1u, (_e1032 < (2097152f * _e138)));
                                                }
                                                let _e1062 = phi_2093_;
                                                switch bitcast<i32>(_e1062) {
                                                    case 0: {
                                                        phi_2099_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2099_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2099_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2099_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1065 = phi_2099_;
                                                switch bitcast<i32>(_e1062) {
                                                    case 0: {
                                                        phi_2109_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2109_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2109_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2109_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1072 = phi_2109_;
                                                local_6 = array<f32, 4>(_e523.member.member.x, _e523.member.member.y, _e523.member.member.z, _e523.member.member.w);
                                                local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4455_ = _e994;
                                                phi_2125_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1086 = phi_4455_;
                                                    let _e1088 = phi_2125_;
                                                    if (_e1088.member < _e1088.member_1) {
                                                        phi_2126_ = type_8((_e1088.member + 1u), _e1088.member_1);
                                                        phi_2149_ = type_8(1u, _e1088.member);
                                                    } else {
                                                        phi_2126_ = _e1088;
                                                        phi_2149_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1101 = phi_2126_;
                                                    let _e1103 = phi_2149_;
                                                    let _e1107 = (bitcast<i32>(_e1103.member) != 0i);
                                                    if _e1107 {
                                                        let _e1109 = ((_e532 + (_e1013.member_1 * ((3u * _e1065) + 1u))) + (_e1103.member_1 * _e1072));
                                                        let _e1110 = (_e1109 < _e90);
                                                        if _e1110 {
                                                            if _e1110 {
                                                            } else {
                                                                phi_4522_ = true;
                                                                break;
                                                            }
                                                            let _e1112 = global_6.member[_e1109];
                                                            phi_2172_ = _e1112;
                                                        } else {
                                                            phi_2172_ = 0u;
                                                        }
                                                        let _e1114 = phi_2172_;
                                                        let _e1115 = (_e1109 + 1u);
                                                        let _e1116 = (_e1115 < _e90);
                                                        if _e1116 {
                                                            if _e1116 {
                                                            } else {
                                                                phi_4522_ = true;
                                                                break;
                                                            }
                                                            let _e1118 = global_6.member[_e1115];
                                                            phi_2187_ = _e1118;
                                                        } else {
                                                            phi_2187_ = 0u;
                                                        }
                                                        let _e1120 = phi_2187_;
                                                        phi_2190_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1122 = phi_2190_;
                                                            if (_e1122.member < _e1122.member_1) {
                                                                phi_2191_ = type_8((_e1122.member + 1u), _e1122.member_1);
                                                                phi_2214_ = type_8(1u, _e1122.member);
                                                            } else {
                                                                phi_2191_ = _e1122;
                                                                phi_2214_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1135 = phi_2191_;
                                                            let _e1137 = phi_2214_;
                                                            let _e1141 = (bitcast<i32>(_e1137.member) != 0i);
                                                            if _e1141 {
                                                                let _e1142 = (_e1137.member_1 < 3u);
                                                                if _e1142 {
                                                                } else {
                                                                    phi_4448_ = true;
                                                                    break;
                                                                }
                                                                let _e1144 = local_4[_e1137.member_1];
                                                                if (_e1137.member_1 < 4u) {
                                                                } else {
                                                                    phi_4448_ = true;
                                                                    break;
                                                                }
                                                                let _e1147 = local_6[_e1137.member_1];
                                                                switch bitcast<i32>(_e1062) {
                                                                    case 0: {
                                                                        phi_2284_ = (_e1147 + (f32(((_e1114 >> bitcast<u32>(((10u * _e1144) & 31u))) & 1023u)) * _e138));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1144 == 0u) {
                                                                            phi_2261_ = _e1114;
                                                                        } else {
                                                                            if (_e1144 == 1u) {
                                                                                phi_2260_ = ((_e1114 >> bitcast<u32>(21i)) | (_e1120 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2260_ = (_e1120 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1168 = phi_2260_;
                                                                            phi_2261_ = _e1168;
                                                                        }
                                                                        let _e1170 = phi_2261_;
                                                                        phi_2284_ = (_e1147 + (f32((_e1170 & 2097151u)) * _e138));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1149 = (_e1109 + _e1144);
                                                                        let _e1150 = (_e1149 < _e90);
                                                                        if _e1150 {
                                                                            if _e1150 {
                                                                            } else {
                                                                                phi_4448_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1152 = global_6.member[_e1149];
                                                                            phi_2280_ = _e1152;
                                                                        } else {
                                                                            phi_2280_ = 0u;
                                                                        }
                                                                        let _e1154 = phi_2280_;
                                                                        phi_2284_ = (f32(bitcast<i32>(_e1154)) * _e138);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2284_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1184 = phi_2284_;
                                                                if (_e1103.member_1 < 3u) {
                                                                } else {
                                                                    phi_4448_ = true;
                                                                    break;
                                                                }
                                                                if _e1142 {
                                                                } else {
                                                                    phi_4448_ = true;
                                                                    break;
                                                                }
                                                                local_5[_e1103.member_1][_e1137.member_1] = _e1184;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2190_ = _e1135;
                                                                phi_4448_ = _e1086;
                                                                break if !(_e1141);
                                                            }
                                                        }
                                                        let _e1190 = phi_4448_;
                                                        phi_4522_ = _e1190;
                                                        if _e1190 {
                                                            break;
                                                        }
                                                        phi_4523_ = _e1190;
                                                    } else {
                                                        phi_4523_ = _e1086;
                                                    }
                                                    let _e1192 = phi_4523_;
                                                    continue;
                                                    continuing {
                                                        phi_4455_ = _e1192;
                                                        phi_2125_ = _e1101;
                                                        phi_4522_ = _e1192;
                                                        break if !(_e1107);
                                                    }
                                                }
                                                let _e1195 = phi_4522_;
                                                phi_4524_ = _e1195;
                                                if _e1195 {
                                                    break;
                                                }
                                                let _e1196 = local_5;
                                                let _e1212 = (_e1196[0][2] - _e376);
                                                let _e1215 = (((_e1196[0][0] - _e299) * _e400) - (_e1212 * _e324));
                                                let _e1218 = (((_e1196[0][1] - _e338) * _e400) - (_e1212 * _e362));
                                                let _e1221 = (_e1196[1][2] - _e376);
                                                let _e1224 = (((_e1196[1][0] - _e299) * _e400) - (_e1221 * _e324));
                                                let _e1227 = (((_e1196[1][1] - _e338) * _e400) - (_e1221 * _e362));
                                                let _e1230 = (_e1196[2][2] - _e376);
                                                let _e1233 = (((_e1196[2][0] - _e299) * _e400) - (_e1230 * _e324));
                                                let _e1236 = (((_e1196[2][1] - _e338) * _e400) - (_e1230 * _e362));
                                                let _e1237 = (_e1233 * _e1227);
                                                let _e1238 = (_e1236 * _e1224);
                                                let _e1239 = (_e1215 * _e1236);
                                                let _e1240 = (_e1218 * _e1233);
                                                let _e1241 = (_e1224 * _e1218);
                                                let _e1242 = (_e1227 * _e1215);
                                                let _e1247 = (((_e1237 >= _e1238) && (_e1239 >= _e1240)) && (_e1241 >= _e1242));
                                                if (_e1247 || (((_e1237 <= _e1238) && (_e1239 <= _e1240)) && (_e1241 <= _e1242))) {
                                                    let _e1254 = select(-1f, 1f, _e1247);
                                                    let _e1256 = ((_e1237 - _e1238) * _e1254);
                                                    let _e1258 = select(0f, _e1256, (_e1256 > 0f));
                                                    let _e1260 = ((_e1239 - _e1240) * _e1254);
                                                    let _e1262 = select(0f, _e1260, (_e1260 > 0f));
                                                    let _e1264 = ((_e1241 - _e1242) * _e1254);
                                                    let _e1266 = select(0f, _e1264, (_e1264 > 0f));
                                                    let _e1268 = ((_e1258 + _e1262) + _e1266);
                                                    if (_e1268 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2879_ = type_20();
                                                        phi_2880_ = true;
                                                    } else {
                                                        let _e1271 = select(_e1196[1][0], _e1196[0][0], (_e1196[0][0] < _e1196[1][0]));
                                                        let _e1275 = select(_e1196[1][0], _e1196[0][0], (_e1196[0][0] > _e1196[1][0]));
                                                        let _e1279 = select(_e1196[1][1], _e1196[0][1], (_e1196[0][1] < _e1196[1][1]));
                                                        let _e1283 = select(_e1196[1][1], _e1196[0][1], (_e1196[0][1] > _e1196[1][1]));
                                                        let _e1287 = select(_e1196[1][2], _e1196[0][2], (_e1196[0][2] < _e1196[1][2]));
                                                        let _e1291 = select(_e1196[1][2], _e1196[0][2], (_e1196[0][2] > _e1196[1][2]));
                                                        let _e1296 = ((select(_e1196[2][0], _e1271, (_e1271 < _e1196[2][0])) - _e322) * _e327);
                                                        let _e1297 = ((select(_e1196[2][0], _e1275, (_e1275 > _e1196[2][0])) - _e323) * _e327);
                                                        let _e1300 = ((select(_e1196[2][1], _e1279, (_e1279 < _e1196[2][1])) - _e360) * _e365);
                                                        let _e1301 = ((select(_e1196[2][1], _e1283, (_e1283 > _e1196[2][1])) - _e361) * _e365);
                                                        let _e1304 = ((select(_e1196[2][2], _e1287, (_e1287 < _e1196[2][2])) - _e398) * _e403);
                                                        let _e1305 = ((select(_e1196[2][2], _e1291, (_e1291 > _e1196[2][2])) - _e399) * _e403);
                                                        let _e1307 = select(_e1305, _e1304, (_e1304 < _e1305));
                                                        let _e1309 = select(_e1305, _e1304, (_e1304 > _e1305));
                                                        let _e1311 = select(_e1297, _e1296, (_e1296 < _e1297));
                                                        let _e1313 = select(_e1301, _e1300, (_e1300 < _e1301));
                                                        let _e1315 = select(_e1313, _e1311, (_e1311 > _e1313));
                                                        let _e1317 = select(_e1307, _e1315, (_e1315 > _e1307));
                                                        let _e1319 = select(_e1297, _e1296, (_e1296 > _e1297));
                                                        let _e1321 = select(_e1301, _e1300, (_e1300 > _e1301));
                                                        let _e1323 = select(_e1321, _e1319, (_e1319 < _e1321));
                                                        let _e1325 = select(_e1309, _e1323, (_e1323 < _e1309));
                                                        let _e1326 = -(_e1307);
                                                        let _e1332 = select(_e450, _e1317, (_e1317 > _e450));
                                                        if (_e1332 > (_e1325 + (select(_e1326, _e1309, (_e1309 > _e1326)) * 0.0000019073523f))) {
                                                            phi_2874_ = type_20();
                                                            phi_2875_ = true;
                                                        } else {
                                                            let _e1334 = (_e1332 > _e996.member);
                                                            if _e1334 {
                                                                phi_2873_ = type_20();
                                                            } else {
                                                                let _e1338 = (_e1196[1][0] - _e1196[0][0]);
                                                                let _e1339 = (_e1196[1][1] - _e1196[0][1]);
                                                                let _e1340 = (_e1196[1][2] - _e1196[0][2]);
                                                                let _e1341 = vec3<f32>(_e1338, _e1339, _e1340);
                                                                let _e1342 = (_e1196[2][0] - _e1196[1][0]);
                                                                let _e1343 = (_e1196[2][1] - _e1196[1][1]);
                                                                let _e1344 = (_e1196[2][2] - _e1196[1][2]);
                                                                let _e1345 = vec3<f32>(_e1342, _e1343, _e1344);
                                                                let _e1346 = (_e1196[0][0] - _e1196[2][0]);
                                                                let _e1347 = (_e1196[0][1] - _e1196[2][1]);
                                                                let _e1348 = (_e1196[0][2] - _e1196[2][2]);
                                                                let _e1349 = vec3<f32>(_e1346, _e1347, _e1348);
                                                                let _e1352 = bitcast<f32>((bitcast<u32>(_e1338) & 2147483647u));
                                                                let _e1355 = bitcast<f32>((bitcast<u32>(_e1339) & 2147483647u));
                                                                let _e1357 = select(_e1355, _e1352, (_e1352 > _e1355));
                                                                let _e1360 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                let _e1362 = select(_e1360, _e1357, (_e1357 > _e1360));
                                                                let _e1365 = bitcast<f32>((bitcast<u32>(_e1342) & 2147483647u));
                                                                let _e1368 = bitcast<f32>((bitcast<u32>(_e1343) & 2147483647u));
                                                                let _e1370 = select(_e1368, _e1365, (_e1365 > _e1368));
                                                                let _e1373 = bitcast<f32>((bitcast<u32>(_e1344) & 2147483647u));
                                                                let _e1375 = select(_e1373, _e1370, (_e1370 > _e1373));
                                                                let _e1378 = bitcast<f32>((bitcast<u32>(_e1346) & 2147483647u));
                                                                let _e1381 = bitcast<f32>((bitcast<u32>(_e1347) & 2147483647u));
                                                                let _e1383 = select(_e1381, _e1378, (_e1378 > _e1381));
                                                                let _e1386 = bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u));
                                                                let _e1388 = select(_e1386, _e1383, (_e1383 > _e1386));
                                                                let _e1390 = select(_e1375, _e1362, (_e1362 > _e1375));
                                                                let _e1392 = select(_e1388, _e1390, (_e1390 > _e1388));
                                                                if (_e1362 == _e1392) {
                                                                    phi_2784_ = _e1345;
                                                                    phi_2785_ = _e1349;
                                                                } else {
                                                                    let _e1395 = vec3((_e1375 == _e1392));
                                                                    phi_2784_ = select(_e1341, _e1349, _e1395);
                                                                    phi_2785_ = select(_e1345, _e1341, _e1395);
                                                                }
                                                                let _e1399 = phi_2784_;
                                                                let _e1401 = phi_2785_;
                                                                let _e1408 = ((_e1399.y * _e1401.z) - (_e1401.y * _e1399.z));
                                                                let _e1413 = ((_e1399.z * _e1401.x) - (_e1401.z * _e1399.x));
                                                                let _e1416 = ((_e1399.x * _e1401.y) - (_e1401.x * _e1399.y));
                                                                if (_e1258 >= _e1262) {
                                                                    phi_2816_ = select(true, false, (_e1258 >= _e1266));
                                                                } else {
                                                                    phi_2816_ = true;
                                                                }
                                                                let _e1421 = phi_2816_;
                                                                if _e1421 {
                                                                    phi_2825_ = select(vec3<f32>(_e1196[2][0], _e1196[2][1], _e1196[2][2]), vec3<f32>(_e1196[1][0], _e1196[1][1], _e1196[1][2]), vec3((_e1262 >= _e1266)));
                                                                } else {
                                                                    phi_2825_ = vec3<f32>(_e1196[0][0], _e1196[0][1], _e1196[0][2]);
                                                                }
                                                                let _e1426 = phi_2825_;
                                                                let _e1443 = ((((_e1408 * (_e1426.x - _e299)) + (_e1413 * (_e1426.y - _e338))) + (_e1416 * (_e1426.z - _e376))) / (((_e1408 * _e324) + (_e1413 * _e362)) + (_e1416 * _e400)));
                                                                let _e1445 = select(_e1325, _e1443, (_e1443 < _e1325));
                                                                let _e1447 = select(_e1317, _e1445, (_e1445 > _e1317));
                                                                if (_e1447 >= _e450) {
                                                                    let _e1449 = (_e1447 <= _e996.member);
                                                                    if _e1449 {
                                                                        let _e1450 = (1f / _e1268);
                                                                        phi_2865_ = type_20(_e1447, (_e1262 * _e1450), (_e1266 * _e1450), _e1056);
                                                                    } else {
                                                                        phi_2865_ = type_20();
                                                                    }
                                                                    let _e1455 = phi_2865_;
                                                                    phi_2867_ = _e1455;
                                                                    phi_2868_ = select(true, false, _e1449);
                                                                } else {
                                                                    phi_2867_ = type_20();
                                                                    phi_2868_ = true;
                                                                }
                                                                let _e1458 = phi_2867_;
                                                                let _e1460 = phi_2868_;
                                                                if _e1460 {
                                                                    phi_2872_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2872_ = _e1458;
                                                                }
                                                                let _e1462 = phi_2872_;
                                                                phi_2873_ = _e1462;
                                                            }
                                                            let _e1464 = phi_2873_;
                                                            phi_2874_ = _e1464;
                                                            phi_2875_ = _e1334;
                                                        }
                                                        let _e1466 = phi_2874_;
                                                        let _e1468 = phi_2875_;
                                                        phi_2879_ = _e1466;
                                                        phi_2880_ = _e1468;
                                                    }
                                                    let _e1470 = phi_2879_;
                                                    let _e1472 = phi_2880_;
                                                    phi_2884_ = _e1470;
                                                    phi_2885_ = _e1472;
                                                } else {
                                                    phi_2884_ = type_20();
                                                    phi_2885_ = true;
                                                }
                                                let _e1474 = phi_2884_;
                                                let _e1476 = phi_2885_;
                                                if _e1476 {
                                                    phi_2889_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2889_ = _e1474;
                                                }
                                                let _e1478 = phi_2889_;
                                                if (_e1478.member_3 != 4294967295u) {
                                                    if (_e1056 != 4294967295u) {
                                                        phi_2900_ = type_33(_e996.member, true);
                                                    } else {
                                                        phi_2900_ = _e996;
                                                    }
                                                    let _e1486 = phi_2900_;
                                                    phi_2901_ = _e1486;
                                                } else {
                                                    phi_2901_ = _e996;
                                                }
                                                let _e1488 = phi_2901_;
                                                phi_4525_ = _e1195;
                                                phi_1958_ = _e1488;
                                            } else {
                                                phi_4525_ = _e994;
                                                phi_1958_ = type_33();
                                            }
                                            let _e1490 = phi_4525_;
                                            let _e1492 = phi_1958_;
                                            continue;
                                            continuing {
                                                phi_4470_ = _e1490;
                                                phi_1957_ = _e1492;
                                                phi_1960_ = _e1011;
                                                phi_4524_ = _e1490;
                                                break if !(_e1017);
                                            }
                                        }
                                        let _e1495 = phi_4524_;
                                        phi_4580_ = _e1495;
                                        if _e1495 {
                                            break;
                                        }
                                        let _e1497 = local_7;
                                        phi_4584_ = _e1495;
                                        let _e1667 = local_9;
                                        phi_4240_ = _e1667;
                                        phi_4241_ = _e523;
                                        phi_4242_ = false;
                                        phi_4243_ = select(_e527, 0u, _e1497.member_1);
                                    } else {
                                        if (_e523.member_1 >= _e87) {
                                            phi_3840_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_48(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e523.member_1 < _e87) {
                                            } else {
                                                phi_4580_ = true;
                                                break;
                                            }
                                            let _e541 = ((1u + (_e258 * 2u)) % 7u);
                                            if (_e541 < 7u) {
                                            } else {
                                                phi_4580_ = true;
                                                break;
                                            }
                                            let _e546 = global_5.member[_e523.member_1][_e541];
                                            let _e549 = ((1u + (_e257 * 2u)) % 7u);
                                            if (_e549 < 7u) {
                                            } else {
                                                phi_4580_ = true;
                                                break;
                                            }
                                            let _e554 = global_5.member[_e523.member_1][_e549];
                                            let _e557 = ((1u + (_e259 * 2u)) % 7u);
                                            if (_e557 < 7u) {
                                            } else {
                                                phi_4580_ = true;
                                                break;
                                            }
                                            let _e562 = global_5.member[_e523.member_1][_e557];
                                            let _e565 = (((_e258 + 1u) * 2u) % 7u);
                                            if (_e565 < 7u) {
                                            } else {
                                                phi_4580_ = true;
                                                break;
                                            }
                                            let _e570 = global_5.member[_e523.member_1][_e565];
                                            let _e573 = (((_e257 + 1u) * 2u) % 7u);
                                            if (_e573 < 7u) {
                                            } else {
                                                phi_4580_ = true;
                                                break;
                                            }
                                            let _e578 = global_5.member[_e523.member_1][_e573];
                                            let _e581 = (((_e259 + 1u) * 2u) % 7u);
                                            if (_e581 < 7u) {
                                            } else {
                                                phi_4580_ = true;
                                                break;
                                            }
                                            let _e586 = global_5.member[_e523.member_1][_e581];
                                            let _e609 = (bitcast<f32>((bitcast<u32>((_e523.member.member_1.x - _e523.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e610 = (bitcast<f32>((bitcast<u32>((_e523.member.member_1.y - _e523.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e611 = (bitcast<f32>((bitcast<u32>((_e523.member.member_1.z - _e523.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e613 = select(_e138, _e609, (_e609 > _e138));
                                            let _e615 = select(_e138, _e610, (_e610 > _e138));
                                            let _e617 = select(_e138, _e611, (_e611 > _e138));
                                            let _e642 = bitcast<u32>((f32(bitcast<i32>((_e546 & 2097151u))) * _e613));
                                            let _e647 = (bitcast<i32>((_e546 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e650 = bitcast<f32>((_e642 & bitcast<u32>(_e647)));
                                            let _e651 = bitcast<u32>((f32(bitcast<i32>((_e554 & 2097151u))) * _e615));
                                            let _e656 = (bitcast<i32>((_e554 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e659 = bitcast<f32>((_e651 & bitcast<u32>(_e656)));
                                            let _e660 = bitcast<u32>((f32(bitcast<i32>((_e562 & 2097151u))) * _e617));
                                            let _e665 = (bitcast<i32>((_e562 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e668 = bitcast<f32>((_e660 & bitcast<u32>(_e665)));
                                            let _e672 = bitcast<f32>((_e642 & bitcast<u32>(~(_e647))));
                                            let _e676 = bitcast<f32>((_e651 & bitcast<u32>(~(_e656))));
                                            let _e680 = bitcast<f32>((_e660 & bitcast<u32>(~(_e665))));
                                            let _e681 = bitcast<u32>((f32(bitcast<i32>((_e570 & 2097151u))) * _e613));
                                            let _e686 = (bitcast<i32>((_e570 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e689 = bitcast<f32>((_e681 & bitcast<u32>(_e686)));
                                            let _e690 = bitcast<u32>((f32(bitcast<i32>((_e578 & 2097151u))) * _e615));
                                            let _e695 = (bitcast<i32>((_e578 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e698 = bitcast<f32>((_e690 & bitcast<u32>(_e695)));
                                            let _e699 = bitcast<u32>((f32(bitcast<i32>((_e586 & 2097151u))) * _e617));
                                            let _e704 = (bitcast<i32>((_e586 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e707 = bitcast<f32>((_e699 & bitcast<u32>(_e704)));
                                            let _e711 = bitcast<f32>((_e681 & bitcast<u32>(~(_e686))));
                                            let _e715 = bitcast<f32>((_e690 & bitcast<u32>(~(_e695))));
                                            let _e719 = bitcast<f32>((_e699 & bitcast<u32>(~(_e704))));
                                            let _e720 = (_e523.member.member.x + _e650);
                                            let _e721 = (_e523.member.member.y + _e659);
                                            let _e722 = (_e523.member.member.z + _e668);
                                            let _e725 = (_e523.member.member_1.x - _e689);
                                            let _e726 = (_e523.member.member_1.y - _e698);
                                            let _e727 = (_e523.member.member_1.z - _e707);
                                            let _e746 = (_e725 - _e720);
                                            let _e747 = (_e726 - _e721);
                                            let _e748 = (_e727 - _e722);
                                            let _e750 = select(_e747, _e746, (_e746 > _e747));
                                            let _e752 = select(_e748, _e750, (_e750 > _e748));
                                            if (_e752 < (1024f * _e138)) {
                                                phi_3541_ = 0u;
                                            } else {
                                                phi_3541_ = select(2u, 1u, (_e752 < (2097152f * _e138)));
                                            }
                                            let _e759 = phi_3541_;
                                            switch bitcast<i32>(_e759) {
                                                case 0: {
                                                    phi_3547_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3547_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3547_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3547_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e762 = phi_3547_;
                                            let _e768 = global_5.member[_e523.member_1][0u];
                                            let _e772 = global_5.member[_e523.member_1][2u];
                                            let _e776 = global_5.member[_e523.member_1][4u];
                                            let _e780 = global_5.member[_e523.member_1][6u];
                                            let _e792 = (((_e772 >> bitcast<u32>(22i)) | ((_e776 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e780 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e793 = (_e768 & 268435455u);
                                            let _e794 = (_e792 & 268435455u);
                                            let _e797 = ((_e768 >> bitcast<u32>(28u)) & 7u);
                                            let _e805 = ((_e768 >> bitcast<u32>(31i)) | (((_e792 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e806 = (_e797 != 0u);
                                            if (_e797 == 0u) {
                                                phi_3802_ = _e793;
                                            } else {
                                                if (_e797 == 7u) {
                                                    phi_3801_ = 2147483648u;
                                                } else {
                                                    phi_3801_ = ((2147483648u | (_e797 << bitcast<u32>(28u))) | (_e794 & 268435455u));
                                                }
                                                let _e815 = phi_3801_;
                                                phi_3802_ = _e815;
                                            }
                                            let _e817 = phi_3802_;
                                            if _e806 {
                                                let _e818 = (_e797 != 7u);
                                                if _e818 {
                                                    phi_3812_ = (_e794 + (_e797 * ((3u * _e762) + 1u)));
                                                } else {
                                                    phi_3812_ = u32();
                                                }
                                                let _e822 = phi_3812_;
                                                phi_3814_ = _e822;
                                                phi_3815_ = select(true, false, _e818);
                                            } else {
                                                phi_3814_ = u32();
                                                phi_3815_ = true;
                                            }
                                            let _e825 = phi_3814_;
                                            let _e827 = phi_3815_;
                                            if (_e805 == 0u) {
                                                phi_3836_ = (_e793 + select(0u, 1u, !(_e806)));
                                            } else {
                                                if (_e805 == 7u) {
                                                    phi_3835_ = 2147483648u;
                                                } else {
                                                    phi_3835_ = ((2147483648u | (_e805 << bitcast<u32>(28u))) | (select(_e825, _e794, _e827) & 268435455u));
                                                }
                                                let _e840 = phi_3835_;
                                                phi_3836_ = _e840;
                                            }
                                            let _e842 = phi_3836_;
                                            phi_3840_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e720, (_e523.member.member.x + _e672), _e725, (_e523.member.member_1.x - _e711)), vec4<f32>(_e721, (_e523.member.member.y + _e676), _e726, (_e523.member.member_1.y - _e715)), vec4<f32>(_e722, (_e523.member.member.z + _e680), _e727, (_e523.member.member_1.z - _e719))), type_48(type_24((_e523.member.member + vec4<f32>(_e650, _e659, _e668, 0f)), (_e523.member.member_1 - vec4<f32>(_e689, _e698, _e707, 0f))), _e817), type_48(type_24((_e523.member.member + vec4<f32>(_e672, _e676, _e680, 0f)), (_e523.member.member_1 - vec4<f32>(_e711, _e715, _e719, 0f))), _e842));
                                        }
                                        let _e847 = phi_3840_;
                                        let _e859 = ((_e847.member[0].x - _e322) * _e327);
                                        let _e860 = ((_e847.member[0].y - _e322) * _e327);
                                        let _e861 = ((_e847.member[0].z - _e323) * _e327);
                                        let _e862 = ((_e847.member[0].w - _e323) * _e327);
                                        let _e872 = ((_e847.member[1].x - _e360) * _e365);
                                        let _e873 = ((_e847.member[1].y - _e360) * _e365);
                                        let _e874 = ((_e847.member[1].z - _e361) * _e365);
                                        let _e875 = ((_e847.member[1].w - _e361) * _e365);
                                        let _e885 = ((_e847.member[2].x - _e398) * _e403);
                                        let _e886 = ((_e847.member[2].y - _e398) * _e403);
                                        let _e887 = ((_e847.member[2].z - _e399) * _e403);
                                        let _e888 = ((_e847.member[2].w - _e399) * _e403);
                                        let _e890 = select(_e887, _e885, (_e885 < _e887));
                                        let _e892 = select(_e888, _e886, (_e886 < _e888));
                                        let _e894 = select(_e887, _e885, (_e885 > _e887));
                                        let _e896 = select(_e888, _e886, (_e886 > _e888));
                                        let _e898 = select(_e861, _e859, (_e859 < _e861));
                                        let _e900 = select(_e862, _e860, (_e860 < _e862));
                                        let _e902 = select(_e874, _e872, (_e872 < _e874));
                                        let _e904 = select(_e875, _e873, (_e873 < _e875));
                                        let _e906 = select(_e902, _e898, (_e898 > _e902));
                                        let _e908 = select(_e904, _e900, (_e900 > _e904));
                                        let _e910 = select(_e890, _e906, (_e906 > _e890));
                                        let _e912 = select(_e892, _e908, (_e908 > _e892));
                                        let _e914 = select(_e861, _e859, (_e859 > _e861));
                                        let _e916 = select(_e862, _e860, (_e860 > _e862));
                                        let _e918 = select(_e874, _e872, (_e872 > _e874));
                                        let _e920 = select(_e875, _e873, (_e873 > _e875));
                                        let _e922 = select(_e918, _e914, (_e914 < _e918));
                                        let _e924 = select(_e920, _e916, (_e916 < _e920));
                                        let _e929 = -(_e890);
                                        let _e930 = -(_e892);
                                        let _e937 = (select(_e894, _e922, (_e922 < _e894)) + (select(_e929, _e894, (_e894 > _e929)) * 0.0000019073523f));
                                        let _e938 = (select(_e896, _e924, (_e924 < _e896)) + (select(_e930, _e896, (_e896 > _e930)) * 0.0000019073523f));
                                        let _e940 = select(_e450, _e910, (_e910 > _e450));
                                        let _e942 = select(_e450, _e912, (_e912 > _e450));
                                        let _e947 = (_e940 <= select(_e494.member, _e937, (_e937 < _e494.member)));
                                        let _e948 = (_e942 <= select(_e494.member, _e938, (_e938 < _e494.member)));
                                        let _e949 = (_e940 <= _e942);
                                        if _e947 {
                                            if _e948 {
                                                if _e949 {
                                                    phi_4184_ = _e847.member_2;
                                                } else {
                                                    phi_4184_ = _e847.member_1;
                                                }
                                                let _e953 = phi_4184_;
                                                let _e954 = (_e527 % 128u);
                                                let _e955 = (_e954 < 128u);
                                                if _e955 {
                                                } else {
                                                    phi_4580_ = true;
                                                    break;
                                                }
                                                local_3[_e954] = type_48(type_24(_e953.member.member, _e953.member.member_1), _e953.member_1);
                                                if _e955 {
                                                } else {
                                                    phi_4580_ = true;
                                                    break;
                                                }
                                                local_2[_e954] = select(_e942, _e940, (_e940 > _e942));
                                                if _e949 {
                                                    phi_4217_ = _e847.member_1;
                                                } else {
                                                    phi_4217_ = _e847.member_2;
                                                }
                                                let _e970 = phi_4217_;
                                                phi_4218_ = _e970;
                                                phi_4219_ = (_e527 + 1u);
                                            } else {
                                                phi_4218_ = type_48();
                                                phi_4219_ = u32();
                                            }
                                            let _e972 = phi_4218_;
                                            let _e974 = phi_4219_;
                                            phi_4221_ = _e972;
                                            phi_4222_ = _e974;
                                            phi_4223_ = select(true, false, _e948);
                                        } else {
                                            phi_4221_ = type_48();
                                            phi_4222_ = u32();
                                            phi_4223_ = true;
                                        }
                                        let _e977 = phi_4221_;
                                        let _e979 = phi_4222_;
                                        let _e981 = phi_4223_;
                                        if _e981 {
                                            if _e947 {
                                                phi_4232_ = _e847.member_1;
                                            } else {
                                                phi_4232_ = _e847.member_2;
                                            }
                                            let _e985 = phi_4232_;
                                            phi_4237_ = _e985;
                                            phi_4238_ = select(_e948, true, _e947);
                                        } else {
                                            phi_4237_ = _e977;
                                            phi_4238_ = _e525;
                                        }
                                        let _e988 = phi_4237_;
                                        let _e990 = phi_4238_;
                                        phi_4584_ = _e492;
                                        phi_4240_ = _e494;
                                        phi_4241_ = _e988;
                                        phi_4242_ = _e990;
                                        phi_4243_ = select(_e979, _e527, _e981);
                                    }
                                    let _e1501 = phi_4584_;
                                    let _e1503 = phi_4240_;
                                    let _e1505 = phi_4241_;
                                    let _e1507 = phi_4242_;
                                    let _e1509 = phi_4243_;
                                    phi_4583_ = _e1501;
                                    phi_4244_ = _e1503;
                                    phi_4245_ = _e1505;
                                    phi_4246_ = (_e498 - 1u);
                                    phi_4247_ = _e1507;
                                    phi_4248_ = _e1509;
                                } else {
                                    phi_4583_ = _e492;
                                    phi_4244_ = _e494;
                                    phi_4245_ = _e523;
                                    phi_4246_ = _e498;
                                    phi_4247_ = _e525;
                                    phi_4248_ = _e527;
                                }
                                let _e1511 = phi_4583_;
                                let _e1513 = phi_4244_;
                                let _e1515 = phi_4245_;
                                let _e1517 = phi_4246_;
                                let _e1519 = phi_4247_;
                                let _e1521 = phi_4248_;
                                phi_4582_ = _e1511;
                                phi_4249_ = _e1513;
                                phi_4250_ = _e1515;
                                phi_4251_ = _e1517;
                                phi_4252_ = _e1519;
                                phi_4253_ = _e1521;
                            } else {
                                phi_4582_ = _e492;
                                phi_4249_ = type_33();
                                phi_4250_ = type_48();
                                phi_4251_ = u32();
                                phi_4252_ = bool();
                                phi_4253_ = u32();
                            }
                            let _e1523 = phi_4582_;
                            let _e1525 = phi_4249_;
                            let _e1527 = phi_4250_;
                            let _e1529 = phi_4251_;
                            let _e1531 = phi_4252_;
                            let _e1533 = phi_4253_;
                            phi_4581_ = _e1523;
                            phi_1880_ = _e1525;
                            phi_1883_ = _e1527;
                            phi_1885_ = _e1529;
                            phi_1887_ = _e1531;
                            phi_1889_ = _e1533;
                            phi_4254_ = _e506;
                        } else {
                            phi_4581_ = _e492;
                            phi_1880_ = type_33();
                            phi_1883_ = type_48();
                            phi_1885_ = u32();
                            phi_1887_ = bool();
                            phi_1889_ = u32();
                            phi_4254_ = false;
                        }
                        let _e1535 = phi_4581_;
                        let _e1537 = phi_1880_;
                        let _e1539 = phi_1883_;
                        let _e1541 = phi_1885_;
                        let _e1543 = phi_1887_;
                        let _e1545 = phi_1889_;
                        let _e1547 = phi_4254_;
                        continue;
                        continuing {
                            phi_4473_ = _e1535;
                            phi_1879_ = _e1537;
                            phi_1882_ = _e1539;
                            phi_1884_ = _e1541;
                            phi_1886_ = _e1543;
                            phi_1888_ = _e1545;
                            phi_4580_ = _e1535;
                            break if !(_e1547);
                        }
                    }
                    let _e1550 = phi_4580_;
                    if _e1550 {
                        break;
                    }
                    let _e1552 = local_8;
                    if _e146 {
                    } else {
                        break;
                    }
                    global_4.member[_e144] = select(0u, 1u, _e1552.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
