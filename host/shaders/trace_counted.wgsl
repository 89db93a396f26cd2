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

struct type_30 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_40 {
    member: type_24,
    member_1: f32,
}

struct type_43 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_46 {
    member: array<type_25>,
}

struct type_48 {
    member: type_40,
    member_1: u32,
    member_2: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<storage> global_2: type_32;
@group(0) @binding(2) 
var<storage> global_3: type_15;
@group(0) @binding(3) 
var<storage> global_4: type_46;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_21;

fn function_() {
    var local: array<u32, 128>;
    var local_1: array<f32, 128>;
    var phi_261_: i32;
    var phi_262_: i32;
    var phi_272_: bool;
    var phi_282_: u32;
    var phi_283_: u32;
    var phi_285_: bool;
    var phi_290_: u32;
    var phi_334_: f32;
    var phi_340_: f32;
    var phi_351_: f32;
    var phi_357_: f32;
    var phi_380_: f32;
    var phi_395_: f32;
    var phi_404_: f32;
    var phi_410_: f32;
    var phi_421_: f32;
    var phi_427_: f32;
    var phi_450_: f32;
    var phi_465_: f32;
    var phi_474_: f32;
    var phi_480_: f32;
    var phi_491_: f32;
    var phi_497_: f32;
    var phi_520_: f32;
    var phi_535_: f32;
    var phi_635_: f32;
    var phi_636_: f32;
    var phi_1965_: bool;
    var phi_648_: type_48;
    var phi_651_: u32;
    var phi_653_: u32;
    var phi_655_: bool;
    var phi_657_: u32;
    var phi_668_: bool;
    var phi_698_: u32;
    var phi_699_: bool;
    var phi_700_: u32;
    var phi_1527_: type_43;
    var phi_1871_: u32;
    var phi_1897_: u32;
    var phi_1898_: u32;
    var phi_1899_: u32;
    var phi_1901_: u32;
    var phi_1902_: u32;
    var phi_1903_: bool;
    var phi_1912_: u32;
    var phi_1917_: u32;
    var phi_1918_: bool;
    var phi_716_: type_48;
    var phi_719_: type_4;
    var phi_720_: type_4;
    var phi_742_: type_4;
    var phi_765_: u32;
    var phi_853_: array<array<f32, 3>, 3>;
    var phi_1324_: vec3<f32>;
    var phi_1325_: vec3<f32>;
    var phi_1356_: bool;
    var phi_1365_: vec3<f32>;
    var phi_1405_: type_24;
    var phi_1407_: type_24;
    var phi_1408_: bool;
    var phi_1412_: type_24;
    var phi_1413_: type_24;
    var phi_1414_: type_24;
    var phi_1415_: bool;
    var phi_1419_: type_24;
    var phi_1420_: bool;
    var phi_1424_: type_24;
    var phi_1425_: bool;
    var phi_1429_: type_24;
    var phi_1454_: bool;
    var phi_1455_: bool;
    var phi_1462_: type_48;
    var phi_1463_: type_48;
    var phi_1464_: type_48;
    var phi_717_: type_48;
    var phi_1959_: bool;
    var phi_2073_: bool;
    var phi_1920_: type_48;
    var phi_1921_: u32;
    var phi_1922_: bool;
    var phi_1923_: u32;
    var phi_2072_: bool;
    var phi_1924_: type_48;
    var phi_1925_: u32;
    var phi_1926_: u32;
    var phi_1927_: bool;
    var phi_1928_: u32;
    var phi_2071_: bool;
    var phi_1929_: type_48;
    var phi_1930_: u32;
    var phi_1931_: u32;
    var phi_1932_: bool;
    var phi_1933_: u32;
    var phi_2070_: bool;
    var phi_649_: type_48;
    var phi_652_: u32;
    var phi_654_: u32;
    var phi_656_: bool;
    var phi_658_: u32;
    var phi_1934_: bool;
    var phi_2069_: bool;
    var local_2: type_48;
    var local_3: type_48;
    var local_4: type_48;

    switch bitcast<i32>(0u) {
        default: {
            let _e60 = global;
            let _e62 = arrayLength((&global_2.member));
            let _e64 = arrayLength((&global_3.member));
            let _e72 = (_e60.x + (_e60.y * 2097152u));
            let _e73 = (_e72 < arrayLength((&global_4.member)));
            if _e73 {
                let _e74 = (_e72 < arrayLength((&global_5.member)));
                if _e74 {
                    if _e73 {
                    } else {
                        break;
                    }
                    let _e77 = global_1.member[0u];
                    let _e78 = bitcast<i32>(_e77);
                    let _e86 = global_4.member[_e72].member_2[0u];
                    let _e88 = (bitcast<u32>(_e86) & 2147483647u);
                    let _e93 = global_4.member[_e72].member_2[1u];
                    let _e95 = (bitcast<u32>(_e93) & 2147483647u);
                    let _e100 = global_4.member[_e72].member_2[2u];
                    let _e102 = (bitcast<u32>(_e100) & 2147483647u);
                    let _e107 = global_4.member[_e72].member[0u];
                    let _e109 = (bitcast<u32>(_e107) & 2147483647u);
                    let _e114 = global_4.member[_e72].member[1u];
                    let _e116 = (bitcast<u32>(_e114) & 2147483647u);
                    let _e121 = global_4.member[_e72].member[2u];
                    let _e123 = (bitcast<u32>(_e121) & 2147483647u);
                    let _e125 = select(_e95, _e88, (_e95 < _e88));
                    let _e127 = select(_e102, _e125, (_e102 < _e125));
                    let _e129 = select(_e109, _e127, (_e109 < _e127));
                    let _e131 = select(_e116, _e129, (_e116 < _e129));
                    let _e133 = select(_e123, _e131, (_e123 < _e131));
                    let _e137 = global_4.member[_e72].member_1;
                    let _e139 = (bitcast<u32>(_e137) & 2147483647u);
                    let _e146 = global_4.member[_e72].member_3;
                    let _e152 = (((select(_e139, _e133, (_e139 < _e133)) < 2139095040u) && ((bitcast<u32>(_e146) & 2147483647u) <= 2139095040u)) && (_e127 > 0u));
                    if _e152 {
                        let _e155 = (bitcast<u32>(bitcast<f32>(_e127)) & 2147483647u);
                        if (_e155 >= 8388608u) {
                            phi_261_ = (bitcast<i32>((_e155 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_261_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e155)), 32u, (_e155 == 0u))));
                        }
                        let _e169 = phi_261_;
                        phi_262_ = _e169;
                    } else {
                        phi_262_ = 0i;
                    }
                    let _e171 = phi_262_;
                    let _e172 = (_e88 == _e127);
                    if _e172 {
                        phi_272_ = true;
                    } else {
                        phi_272_ = (_e95 == _e127);
                    }
                    let _e175 = phi_272_;
                    let _e176 = select(1u, 0u, _e172);
                    if _e175 {
                        let _e177 = (_e176 + 1u);
                        phi_282_ = _e177;
                        phi_283_ = _e177;
                        phi_285_ = select(true, false, (_e177 == 2u));
                    } else {
                        phi_282_ = u32();
                        phi_283_ = 0u;
                        phi_285_ = true;
                    }
                    let _e181 = phi_282_;
                    let _e183 = phi_283_;
                    let _e185 = phi_285_;
                    if _e185 {
                        phi_290_ = (_e183 + 1u);
                    } else {
                        phi_290_ = 0u;
                    }
                    let _e189 = phi_290_;
                    let _e190 = select(_e181, _e183, _e185);
                    let _e191 = select(_e176, select(2u, _e176, _e175), _e185);
                    let _e192 = (_e78 / 2i);
                    let _e197 = bitcast<f32>((bitcast<u32>((_e192 + 127i)) << bitcast<u32>(23i)));
                    let _e203 = bitcast<f32>((bitcast<u32>(((_e78 - _e192) + 127i)) << bitcast<u32>(23i)));
                    let _e204 = -(_e171);
                    let _e205 = (_e204 / 2i);
                    let _e210 = bitcast<f32>((bitcast<u32>((_e205 + 127i)) << bitcast<u32>(23i)));
                    let _e216 = bitcast<f32>((bitcast<u32>(((_e204 - _e205) + 127i)) << bitcast<u32>(23i)));
                    let _e220 = global_4.member[_e72].member;
                    let _e221 = (_e190 == 0u);
                    if _e221 {
                        phi_334_ = _e220[0];
                    } else {
                        phi_334_ = _e220[1];
                    }
                    let _e225 = phi_334_;
                    let _e226 = (_e190 == 2u);
                    if _e226 {
                        phi_340_ = _e220[2];
                    } else {
                        phi_340_ = _e225;
                    }
                    let _e229 = phi_340_;
                    let _e231 = ((_e229 * _e197) * _e203);
                    let _e232 = global_4.member[_e72].member_2;
                    if _e221 {
                        phi_351_ = _e232[0];
                    } else {
                        phi_351_ = _e232[1];
                    }
                    let _e236 = phi_351_;
                    if _e226 {
                        phi_357_ = _e232[2];
                    } else {
                        phi_357_ = _e236;
                    }
                    let _e239 = phi_357_;
                    let _e241 = ((_e239 * _e210) * _e216);
                    let _e245 = (bitcast<f32>((bitcast<u32>(_e241) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e245 {
                        let _e249 = (bitcast<f32>((bitcast<u32>(_e231) & 2147483647u)) * 0.00000011920929f);
                        phi_380_ = select(0.00000000000000000086736174f, _e249, (_e249 > 0.00000000000000000086736174f));
                    } else {
                        phi_380_ = 0f;
                    }
                    let _e253 = phi_380_;
                    let _e254 = (_e231 + _e253);
                    let _e255 = (_e231 - _e253);
                    let _e256 = select(_e241, 0f, _e245);
                    if _e245 {
                        phi_395_ = 1267650600000000000000000000000f;
                    } else {
                        phi_395_ = (1f / _e241);
                    }
                    let _e259 = phi_395_;
                    let _e260 = (_e189 == 0u);
                    if _e260 {
                        phi_404_ = _e220[0];
                    } else {
                        phi_404_ = _e220[1];
                    }
                    let _e264 = phi_404_;
                    let _e265 = (_e189 == 2u);
                    if _e265 {
                        phi_410_ = _e220[2];
                    } else {
                        phi_410_ = _e264;
                    }
                    let _e268 = phi_410_;
                    let _e270 = ((_e268 * _e197) * _e203);
                    if _e260 {
                        phi_421_ = _e232[0];
                    } else {
                        phi_421_ = _e232[1];
                    }
                    let _e274 = phi_421_;
                    if _e265 {
                        phi_427_ = _e232[2];
                    } else {
                        phi_427_ = _e274;
                    }
                    let _e277 = phi_427_;
                    let _e279 = ((_e277 * _e210) * _e216);
                    let _e283 = (bitcast<f32>((bitcast<u32>(_e279) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e283 {
                        let _e287 = (bitcast<f32>((bitcast<u32>(_e270) & 2147483647u)) * 0.00000011920929f);
                        phi_450_ = select(0.00000000000000000086736174f, _e287, (_e287 > 0.00000000000000000086736174f));
                    } else {
                        phi_450_ = 0f;
                    }
                    let _e291 = phi_450_;
                    let _e292 = (_e270 + _e291);
                    let _e293 = (_e270 - _e291);
                    let _e294 = select(_e279, 0f, _e283);
                    if _e283 {
                        phi_465_ = 1267650600000000000000000000000f;
                    } else {
                        phi_465_ = (1f / _e279);
                    }
                    let _e297 = phi_465_;
                    let _e298 = (_e191 == 0u);
                    if _e298 {
                        phi_474_ = _e220[0];
                    } else {
                        phi_474_ = _e220[1];
                    }
                    let _e302 = phi_474_;
                    let _e303 = (_e191 == 2u);
                    if _e303 {
                        phi_480_ = _e220[2];
                    } else {
                        phi_480_ = _e302;
                    }
                    let _e306 = phi_480_;
                    let _e308 = ((_e306 * _e197) * _e203);
                    if _e298 {
                        phi_491_ = _e232[0];
                    } else {
                        phi_491_ = _e232[1];
                    }
                    let _e312 = phi_491_;
                    if _e303 {
                        phi_497_ = _e232[2];
                    } else {
                        phi_497_ = _e312;
                    }
                    let _e315 = phi_497_;
                    let _e317 = ((_e315 * _e210) * _e216);
                    let _e321 = (bitcast<f32>((bitcast<u32>(_e317) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e321 {
                        let _e325 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) * 0.00000011920929f);
                        phi_520_ = select(0.00000000000000000086736174f, _e325, (_e325 > 0.00000000000000000086736174f));
                    } else {
                        phi_520_ = 0f;
                    }
                    let _e329 = phi_520_;
                    let _e330 = (_e308 + _e329);
                    let _e331 = (_e308 - _e329);
                    let _e332 = select(_e317, 0f, _e321);
                    if _e321 {
                        phi_535_ = 1267650600000000000000000000000f;
                    } else {
                        phi_535_ = (1f / _e317);
                    }
                    let _e335 = phi_535_;
                    let _e338 = bitcast<f32>((bitcast<u32>(_e231) & 2147483647u));
                    let _e341 = bitcast<f32>((bitcast<u32>(_e270) & 2147483647u));
                    let _e343 = select(_e341, _e338, (_e338 > _e341));
                    let _e346 = bitcast<f32>((bitcast<u32>(_e308) & 2147483647u));
                    let _e349 = (_e78 + _e171);
                    if (_e152 && (select(_e346, _e343, (_e343 > _e346)) <= 1099511600000f)) {
                        let _e352 = (_e349 / 3i);
                        let _e359 = bitcast<f32>((bitcast<u32>((_e352 + 127i)) << bitcast<u32>(23i)));
                        let _e366 = bitcast<f32>((bitcast<u32>(((_e349 - (2i * _e352)) + 127i)) << bitcast<u32>(23i)));
                        let _e367 = (((_e137 * _e359) * _e359) * _e366);
                        let _e369 = select(340282350000000000000000000000000000000f, _e367, (_e367 < 340282350000000000000000000000000000000f));
                        let _e374 = (((_e146 * _e359) * _e359) * _e366);
                        let _e376 = select(340282350000000000000000000000000000000f, _e374, (_e374 < 340282350000000000000000000000000000000f));
                        phi_635_ = select(-340282350000000000000000000000000000000f, _e376, (_e376 > -340282350000000000000000000000000000000f));
                        phi_636_ = select(-340282350000000000000000000000000000000f, _e369, (_e369 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_635_ = 0f;
                        phi_636_ = 1f;
                    }
                    let _e380 = phi_635_;
                    let _e382 = phi_636_;
                    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_1965_ = false;
                    phi_648_ = type_48(type_40(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e380), 0u, 0u);
                    phi_651_ = select(0u, 2147483648u, (_e62 == 0u));
                    phi_653_ = ((3u * _e62) + 1u);
                    phi_655_ = (_e382 <= _e380);
                    phi_657_ = 0u;
                    loop {
                        let _e391 = phi_1965_;
                        let _e393 = phi_648_;
                        let _e395 = phi_651_;
                        let _e397 = phi_653_;
                        let _e399 = phi_655_;
                        let _e401 = phi_657_;
                        local_2 = _e393;
                        local_3 = _e393;
                        if _e399 {
                            phi_668_ = true;
                        } else {
                            phi_668_ = (_e401 > 0u);
                        }
                        let _e404 = phi_668_;
                        if _e404 {
                            let _e405 = (_e397 > 0u);
                            if _e405 {
                                if _e399 {
                                    phi_698_ = _e395;
                                    phi_699_ = _e399;
                                    phi_700_ = _e401;
                                } else {
                                    let _e406 = (_e401 - 1u);
                                    let _e407 = (_e406 % 128u);
                                    let _e408 = (_e407 < 128u);
                                    if _e408 {
                                    } else {
                                        phi_2069_ = true;
                                        break;
                                    }
                                    let _e410 = local[_e407];
                                    if _e408 {
                                    } else {
                                        phi_2069_ = true;
                                        break;
                                    }
                                    let _e412 = local_1[_e407];
                                    phi_698_ = _e410;
                                    phi_699_ = (_e412 <= _e393.member.member_1);
                                    phi_700_ = _e406;
                                }
                                let _e417 = phi_698_;
                                let _e419 = phi_699_;
                                let _e421 = phi_700_;
                                if _e419 {
                                    let _e425 = (_e417 & 268435455u);
                                    if ((_e417 & 2147483648u) != 0u) {
                                        phi_716_ = _e393;
                                        phi_719_ = type_4(_e425, (_e425 + ((_e417 >> bitcast<u32>(28u)) & 7u)));
                                        loop {
                                            let _e627 = phi_716_;
                                            let _e629 = phi_719_;
                                            local_4 = _e627;
                                            if (_e629.member < _e629.member_1) {
                                                phi_720_ = type_4((_e629.member + 1u), _e629.member_1);
                                                phi_742_ = type_4(1u, _e629.member);
                                            } else {
                                                phi_720_ = _e629;
                                                phi_742_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e642 = phi_720_;
                                            let _e644 = phi_742_;
                                            let _e648 = (bitcast<i32>(_e644.member) != 0i);
                                            if _e648 {
                                                let _e654 = type_48(_e627.member, _e627.member_1, (_e627.member_2 + 1u));
                                                let _e655 = (_e644.member_1 < _e64);
                                                if _e655 {
                                                    if _e655 {
                                                    } else {
                                                        phi_1959_ = true;
                                                        break;
                                                    }
                                                    let _e659 = global_3.member[_e644.member_1].member_1;
                                                    phi_765_ = _e659;
                                                } else {
                                                    phi_765_ = 4294967295u;
                                                }
                                                let _e661 = phi_765_;
                                                if (_e644.member_1 >= _e64) {
                                                    phi_853_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e655 {
                                                    } else {
                                                        phi_1959_ = true;
                                                        break;
                                                    }
                                                    let _e663 = (_e190 % 3u);
                                                    let _e664 = (_e189 % 3u);
                                                    let _e665 = (_e191 % 3u);
                                                    if (_e663 < 9u) {
                                                    } else {
                                                        phi_1959_ = true;
                                                        break;
                                                    }
                                                    let _e671 = global_3.member[_e644.member_1].member[_e663];
                                                    if (_e664 < 9u) {
                                                    } else {
                                                        phi_1959_ = true;
                                                        break;
                                                    }
                                                    let _e677 = global_3.member[_e644.member_1].member[_e664];
                                                    if (_e665 < 9u) {
                                                    } else {
                                                        phi_1959_ = true;
                                                        break;
                                                    }
                                                    let _e683 = global_3.member[_e644.member_1].member[_e665];
                                                    let _e685 = (3u + _e663);
                                                    if (_e685 < 9u) {
                                                    } else {
                                                        phi_1959_ = true;
                                                        break;
                                                    }
                                                    let _e691 = global_3.member[_e644.member_1].member[_e685];
                                                    let _e692 = (3u + _e664);
                                                    if (_e692 < 9u) {
                                                    } else {
                                                        phi_1959_ = true;
                                                        break;
                                                    }
                                                    let _e698 = global_3.member[_e644.member_1].member[_e692];
                                                    let _e699 = (3u + _e665);
                                                    if (_e699 < 9u) {
                                                    } else {
                                                        phi_1959_ = true;
                                                        break;
                                                    }
                                                    let _e705 = global_3.member[_e644.member_1].member[_e699];
                                                    let _e707 = (6u + _e663);
                                                    if (_e707 < 9u) {
                                                    } else {
                                                        phi_1959_ = true;
                                                        break;
                                                    }
                                                    let _e713 = global_3.member[_e644.member_1].member[_e707];
                                                    let _e714 = (6u + _e664);
                                                    if (_e714 < 9u) {
                                                    } else {
                                                        phi_1959_ = true;
                                                        break;
                                                    }
                                                    let _e720 = global_3.member[_e644.member_1].member[_e714];
                                                    let _e721 = (6u + _e665);
                                                    if (_e721 < 9u) {
                                                    } else {
                                                        phi_1959_ = true;
                                                        break;
                                                    }
                                                    let _e727 = global_3.member[_e644.member_1].member[_e721];
                                                    phi_853_ = array<array<f32, 3>, 3>(array<f32, 3>(_e671, _e677, _e683), array<f32, 3>(_e691, _e698, _e705), array<f32, 3>(_e713, _e720, _e727));
                                                }
                                                let _e731 = phi_853_;
                                                let _e740 = (_e731[0][2] - _e308);
                                                let _e743 = (((_e731[0][0] - _e231) * _e332) - (_e740 * _e256));
                                                let _e746 = (((_e731[0][1] - _e270) * _e332) - (_e740 * _e294));
                                                let _e753 = (_e731[1][2] - _e308);
                                                let _e756 = (((_e731[1][0] - _e231) * _e332) - (_e753 * _e256));
                                                let _e759 = (((_e731[1][1] - _e270) * _e332) - (_e753 * _e294));
                                                let _e766 = (_e731[2][2] - _e308);
                                                let _e769 = (((_e731[2][0] - _e231) * _e332) - (_e766 * _e256));
                                                let _e772 = (((_e731[2][1] - _e270) * _e332) - (_e766 * _e294));
                                                let _e773 = (_e769 * _e759);
                                                let _e774 = (_e772 * _e756);
                                                let _e775 = (_e743 * _e772);
                                                let _e776 = (_e746 * _e769);
                                                let _e777 = (_e756 * _e746);
                                                let _e778 = (_e759 * _e743);
                                                let _e783 = (((_e773 >= _e774) && (_e775 >= _e776)) && (_e777 >= _e778));
                                                if (_e783 || (((_e773 <= _e774) && (_e775 <= _e776)) && (_e777 <= _e778))) {
                                                    let _e790 = select(-1f, 1f, _e783);
                                                    let _e792 = ((_e773 - _e774) * _e790);
                                                    let _e794 = select(0f, _e792, (_e792 > 0f));
                                                    let _e796 = ((_e775 - _e776) * _e790);
                                                    let _e798 = select(0f, _e796, (_e796 > 0f));
                                                    let _e800 = ((_e777 - _e778) * _e790);
                                                    let _e802 = select(0f, _e800, (_e800 > 0f));
                                                    let _e804 = ((_e794 + _e798) + _e802);
                                                    if (_e804 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1419_ = type_24();
                                                        phi_1420_ = true;
                                                    } else {
                                                        let _e807 = select(_e731[1][0], _e731[0][0], (_e731[0][0] < _e731[1][0]));
                                                        let _e811 = select(_e731[1][0], _e731[0][0], (_e731[0][0] > _e731[1][0]));
                                                        let _e815 = select(_e731[1][1], _e731[0][1], (_e731[0][1] < _e731[1][1]));
                                                        let _e819 = select(_e731[1][1], _e731[0][1], (_e731[0][1] > _e731[1][1]));
                                                        let _e823 = select(_e731[1][2], _e731[0][2], (_e731[0][2] < _e731[1][2]));
                                                        let _e827 = select(_e731[1][2], _e731[0][2], (_e731[0][2] > _e731[1][2]));
                                                        let _e832 = ((select(_e731[2][0], _e807, (_e807 < _e731[2][0])) - _e254) * _e259);
                                                        let _e833 = ((select(_e731[2][0], _e811, (_e811 > _e731[2][0])) - _e255) * _e259);
                                                        let _e836 = ((select(_e731[2][1], _e815, (_e815 < _e731[2][1])) - _e292) * _e297);
                                                        let _e837 = ((select(_e731[2][1], _e819, (_e819 > _e731[2][1])) - _e293) * _e297);
                                                        let _e840 = ((select(_e731[2][2], _e823, (_e823 < _e731[2][2])) - _e330) * _e335);
                                                        let _e841 = ((select(_e731[2][2], _e827, (_e827 > _e731[2][2])) - _e331) * _e335);
                                                        let _e843 = select(_e841, _e840, (_e840 < _e841));
                                                        let _e845 = select(_e841, _e840, (_e840 > _e841));
                                                        let _e847 = select(_e833, _e832, (_e832 < _e833));
                                                        let _e849 = select(_e837, _e836, (_e836 < _e837));
                                                        let _e851 = select(_e849, _e847, (_e847 > _e849));
                                                        let _e853 = select(_e843, _e851, (_e851 > _e843));
                                                        let _e855 = select(_e833, _e832, (_e832 > _e833));
                                                        let _e857 = select(_e837, _e836, (_e836 > _e837));
                                                        let _e859 = select(_e857, _e855, (_e855 < _e857));
                                                        let _e861 = select(_e845, _e859, (_e859 < _e845));
                                                        let _e862 = -(_e843);
                                                        let _e868 = select(_e382, _e853, (_e853 > _e382));
                                                        if (_e868 > (_e861 + (select(_e862, _e845, (_e845 > _e862)) * 0.0000019073523f))) {
                                                            phi_1414_ = type_24();
                                                            phi_1415_ = true;
                                                        } else {
                                                            let _e870 = (_e868 > _e627.member.member_1);
                                                            if _e870 {
                                                                phi_1413_ = type_24();
                                                            } else {
                                                                let _e874 = (_e731[1][0] - _e731[0][0]);
                                                                let _e875 = (_e731[1][1] - _e731[0][1]);
                                                                let _e876 = (_e731[1][2] - _e731[0][2]);
                                                                let _e877 = vec3<f32>(_e874, _e875, _e876);
                                                                let _e878 = (_e731[2][0] - _e731[1][0]);
                                                                let _e879 = (_e731[2][1] - _e731[1][1]);
                                                                let _e880 = (_e731[2][2] - _e731[1][2]);
                                                                let _e881 = vec3<f32>(_e878, _e879, _e880);
                                                                let _e882 = (_e731[0][0] - _e731[2][0]);
                                                                let _e883 = (_e731[0][1] - _e731[2][1]);
                                                                let _e884 = (_e731[0][2] - _e731[2][2]);
                                                                let _e885 = vec3<f32>(_e882, _e883, _e884);
                                                                let _e888 = bitcast<f32>((bitcast<u32>(_e874) & 2147483647u));
                                                                let _e891 = bitcast<f32>((bitcast<u32>(_e875) & 2147483647u));
                                                                let _e893 = select(_e891, _e888, (_e888 > _e891));
                                                                let _e896 = bitcast<f32>((bitcast<u32>(_e876) & 2147483647u));
                                                                let _e898 = select(_e896, _e893, (_e893 > _e896));
                                                                let _e901 = bitcast<f32>((bitcast<u32>(_e878) & 2147483647u));
                                                                let _e904 = bitcast<f32>((bitcast<u32>(_e879) & 2147483647u));
                                                                let _e906 = select(_e904, _e901, (_e901 > _e904));
                                                                let _e909 = bitcast<f32>((bitcast<u32>(_e880) & 2147483647u));
                                                                let _e911 = select(_e909, _e906, (_e906 > _e909));
                                                                let _e914 = bitcast<f32>((bitcast<u32>(_e882) & 2147483647u));
                                                                let _e917 = bitcast<f32>((bitcast<u32>(_e883) & 2147483647u));
                                                                let _e919 = select(_e917, _e914, (_e914 > _e917));
                                                                let _e922 = bitcast<f32>((bitcast<u32>(_e884) & 2147483647u));
                                                                let _e924 = select(_e922, _e919, (_e919 > _e922));
                                                                let _e926 = select(_e911, _e898, (_e898 > _e911));
                                                                let _e928 = select(_e924, _e926, (_e926 > _e924));
                                                                if (_e898 == _e928) {
                                                                    phi_1324_ = _e881;
                                                                    phi_1325_ = _e885;
                                                                } else {
                                                                    let _e931 = vec3((_e911 == _e928));
                                                                    phi_1324_ = select(_e877, _e885, _e931);
                                                                    phi_1325_ = select(_e881, _e877, _e931);
                                                                }
                                                                let _e935 = phi_1324_;
                                                                let _e937 = phi_1325_;
                                                                let _e944 = ((_e935.y * _e937.z) - (_e937.y * _e935.z));
                                                                let _e949 = ((_e935.z * _e937.x) - (_e937.z * _e935.x));
                                                                let _e952 = ((_e935.x * _e937.y) - (_e937.x * _e935.y));
                                                                if (_e794 >= _e798) {
                                                                    phi_1356_ = select(true, false, (_e794 >= _e802));
                                                                } else {
                                                                    phi_1356_ = true;
                                                                }
                                                                let _e957 = phi_1356_;
                                                                if _e957 {
                                                                    phi_1365_ = select(vec3<f32>(_e731[2][0], _e731[2][1], _e731[2][2]), vec3<f32>(_e731[1][0], _e731[1][1], _e731[1][2]), vec3((_e798 >= _e802)));
                                                                } else {
                                                                    phi_1365_ = vec3<f32>(_e731[0][0], _e731[0][1], _e731[0][2]);
                                                                }
                                                                let _e962 = phi_1365_;
                                                                let _e979 = ((((_e944 * (_e962.x - _e231)) + (_e949 * (_e962.y - _e270))) + (_e952 * (_e962.z - _e308))) / (((_e944 * _e256) + (_e949 * _e294)) + (_e952 * _e332)));
                                                                let _e981 = select(_e861, _e979, (_e979 < _e861));
                                                                let _e983 = select(_e853, _e981, (_e981 > _e853));
                                                                if (_e983 >= _e382) {
                                                                    let _e985 = (_e983 <= _e627.member.member_1);
                                                                    if _e985 {
                                                                        let _e986 = (1f / _e804);
                                                                        phi_1405_ = type_24(_e983, (_e798 * _e986), (_e802 * _e986), _e661);
                                                                    } else {
                                                                        phi_1405_ = type_24();
                                                                    }
                                                                    let _e991 = phi_1405_;
                                                                    phi_1407_ = _e991;
                                                                    phi_1408_ = select(true, false, _e985);
                                                                } else {
                                                                    phi_1407_ = type_24();
                                                                    phi_1408_ = true;
                                                                }
                                                                let _e994 = phi_1407_;
                                                                let _e996 = phi_1408_;
                                                                if _e996 {
                                                                    phi_1412_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1412_ = _e994;
                                                                }
                                                                let _e998 = phi_1412_;
                                                                phi_1413_ = _e998;
                                                            }
                                                            let _e1000 = phi_1413_;
                                                            phi_1414_ = _e1000;
                                                            phi_1415_ = _e870;
                                                        }
                                                        let _e1002 = phi_1414_;
                                                        let _e1004 = phi_1415_;
                                                        phi_1419_ = _e1002;
                                                        phi_1420_ = _e1004;
                                                    }
                                                    let _e1006 = phi_1419_;
                                                    let _e1008 = phi_1420_;
                                                    phi_1424_ = _e1006;
                                                    phi_1425_ = _e1008;
                                                } else {
                                                    phi_1424_ = type_24();
                                                    phi_1425_ = true;
                                                }
                                                let _e1010 = phi_1424_;
                                                let _e1012 = phi_1425_;
                                                if _e1012 {
                                                    phi_1429_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1429_ = _e1010;
                                                }
                                                let _e1014 = phi_1429_;
                                                if (_e1014.member_3 != 4294967295u) {
                                                    if (_e661 != 4294967295u) {
                                                        if (_e1014.member < _e627.member.member.member) {
                                                            phi_1455_ = true;
                                                        } else {
                                                            if (_e1014.member == _e627.member.member.member) {
                                                                phi_1454_ = (_e1014.member_3 < _e627.member.member.member_3);
                                                            } else {
                                                                phi_1454_ = false;
                                                            }
                                                            let _e1029 = phi_1454_;
                                                            phi_1455_ = _e1029;
                                                        }
                                                        let _e1031 = phi_1455_;
                                                        if _e1031 {
                                                            phi_1462_ = type_48(type_40(_e1014, _e1014.member), _e654.member_1, _e654.member_2);
                                                        } else {
                                                            phi_1462_ = _e654;
                                                        }
                                                        let _e1038 = phi_1462_;
                                                        phi_1463_ = _e1038;
                                                    } else {
                                                        phi_1463_ = _e654;
                                                    }
                                                    let _e1040 = phi_1463_;
                                                    phi_1464_ = _e1040;
                                                } else {
                                                    phi_1464_ = _e654;
                                                }
                                                let _e1042 = phi_1464_;
                                                phi_717_ = _e1042;
                                            } else {
                                                phi_717_ = type_48();
                                            }
                                            let _e1044 = phi_717_;
                                            continue;
                                            continuing {
                                                phi_716_ = _e1044;
                                                phi_719_ = _e642;
                                                phi_1959_ = _e391;
                                                break if !(_e648);
                                            }
                                        }
                                        let _e1047 = phi_1959_;
                                        phi_2069_ = _e1047;
                                        if _e1047 {
                                            break;
                                        }
                                        phi_2073_ = _e1047;
                                        let _e1191 = local_4;
                                        phi_1920_ = _e1191;
                                        phi_1921_ = _e417;
                                        phi_1922_ = false;
                                        phi_1923_ = _e421;
                                    } else {
                                        if (_e417 >= _e62) {
                                            phi_1527_ = type_43(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e417 < _e62) {
                                            } else {
                                                phi_2069_ = true;
                                                break;
                                            }
                                            let _e437 = (_e190 % 3u);
                                            if (_e437 < 3u) {
                                            } else {
                                                phi_2069_ = true;
                                                break;
                                            }
                                            let _e443 = global_2.member[_e417].member[_e437];
                                            let _e449 = (_e189 % 3u);
                                            if (_e449 < 3u) {
                                            } else {
                                                phi_2069_ = true;
                                                break;
                                            }
                                            let _e455 = global_2.member[_e417].member[_e449];
                                            let _e461 = (_e191 % 3u);
                                            if (_e461 < 3u) {
                                            } else {
                                                phi_2069_ = true;
                                                break;
                                            }
                                            let _e467 = global_2.member[_e417].member[_e461];
                                            let _e477 = global_2.member[_e417].member_1;
                                            let _e481 = global_2.member[_e417].member_2;
                                            phi_1527_ = type_43(array<vec4<f32>, 3>(vec4<f32>(_e443[0], _e443[1], _e443[2], _e443[3]), vec4<f32>(_e455[0], _e455[1], _e455[2], _e455[3]), vec4<f32>(_e467[0], _e467[1], _e467[2], _e467[3])), _e477, _e481);
                                        }
                                        let _e484 = phi_1527_;
                                        let _e497 = ((_e484.member[0].x - _e254) * _e259);
                                        let _e498 = ((_e484.member[0].y - _e254) * _e259);
                                        let _e499 = ((_e484.member[0].z - _e255) * _e259);
                                        let _e500 = ((_e484.member[0].w - _e255) * _e259);
                                        let _e510 = ((_e484.member[1].x - _e292) * _e297);
                                        let _e511 = ((_e484.member[1].y - _e292) * _e297);
                                        let _e512 = ((_e484.member[1].z - _e293) * _e297);
                                        let _e513 = ((_e484.member[1].w - _e293) * _e297);
                                        let _e523 = ((_e484.member[2].x - _e330) * _e335);
                                        let _e524 = ((_e484.member[2].y - _e330) * _e335);
                                        let _e525 = ((_e484.member[2].z - _e331) * _e335);
                                        let _e526 = ((_e484.member[2].w - _e331) * _e335);
                                        let _e528 = select(_e525, _e523, (_e523 < _e525));
                                        let _e530 = select(_e526, _e524, (_e524 < _e526));
                                        let _e532 = select(_e525, _e523, (_e523 > _e525));
                                        let _e534 = select(_e526, _e524, (_e524 > _e526));
                                        let _e536 = select(_e499, _e497, (_e497 < _e499));
                                        let _e538 = select(_e500, _e498, (_e498 < _e500));
                                        let _e540 = select(_e512, _e510, (_e510 < _e512));
                                        let _e542 = select(_e513, _e511, (_e511 < _e513));
                                        let _e544 = select(_e540, _e536, (_e536 > _e540));
                                        let _e546 = select(_e542, _e538, (_e538 > _e542));
                                        let _e548 = select(_e528, _e544, (_e544 > _e528));
                                        let _e550 = select(_e530, _e546, (_e546 > _e530));
                                        let _e552 = select(_e499, _e497, (_e497 > _e499));
                                        let _e554 = select(_e500, _e498, (_e498 > _e500));
                                        let _e556 = select(_e512, _e510, (_e510 > _e512));
                                        let _e558 = select(_e513, _e511, (_e511 > _e513));
                                        let _e560 = select(_e556, _e552, (_e552 < _e556));
                                        let _e562 = select(_e558, _e554, (_e554 < _e558));
                                        let _e567 = -(_e528);
                                        let _e568 = -(_e530);
                                        let _e575 = (select(_e532, _e560, (_e560 < _e532)) + (select(_e567, _e532, (_e532 > _e567)) * 0.0000019073523f));
                                        let _e576 = (select(_e534, _e562, (_e562 < _e534)) + (select(_e568, _e534, (_e534 > _e568)) * 0.0000019073523f));
                                        let _e578 = select(_e382, _e548, (_e548 > _e382));
                                        let _e580 = select(_e382, _e550, (_e550 > _e382));
                                        let _e585 = (_e578 <= select(_e393.member.member_1, _e575, (_e575 < _e393.member.member_1)));
                                        let _e586 = (_e580 <= select(_e393.member.member_1, _e576, (_e576 < _e393.member.member_1)));
                                        let _e587 = (_e578 <= _e580);
                                        if _e585 {
                                            if _e586 {
                                                if _e587 {
                                                    phi_1871_ = _e484.member_2;
                                                } else {
                                                    phi_1871_ = _e484.member_1;
                                                }
                                                let _e591 = phi_1871_;
                                                let _e592 = (_e421 % 128u);
                                                let _e593 = (_e592 < 128u);
                                                if _e593 {
                                                } else {
                                                    phi_2069_ = true;
                                                    break;
                                                }
                                                local[_e592] = _e591;
                                                if _e593 {
                                                } else {
                                                    phi_2069_ = true;
                                                    break;
                                                }
                                                local_1[_e592] = select(_e580, _e578, (_e578 > _e580));
                                                if _e587 {
                                                    phi_1897_ = _e484.member_1;
                                                } else {
                                                    phi_1897_ = _e484.member_2;
                                                }
                                                let _e602 = phi_1897_;
                                                phi_1898_ = _e602;
                                                phi_1899_ = (_e421 + 1u);
                                            } else {
                                                phi_1898_ = u32();
                                                phi_1899_ = u32();
                                            }
                                            let _e604 = phi_1898_;
                                            let _e606 = phi_1899_;
                                            phi_1901_ = _e604;
                                            phi_1902_ = _e606;
                                            phi_1903_ = select(true, false, _e586);
                                        } else {
                                            phi_1901_ = u32();
                                            phi_1902_ = u32();
                                            phi_1903_ = true;
                                        }
                                        let _e609 = phi_1901_;
                                        let _e611 = phi_1902_;
                                        let _e613 = phi_1903_;
                                        if _e613 {
                                            if _e585 {
                                                phi_1912_ = _e484.member_1;
                                            } else {
                                                phi_1912_ = _e484.member_2;
                                            }
                                            let _e617 = phi_1912_;
                                            phi_1917_ = _e617;
                                            phi_1918_ = select(_e586, true, _e585);
                                        } else {
                                            phi_1917_ = _e609;
                                            phi_1918_ = _e419;
                                        }
                                        let _e620 = phi_1917_;
                                        let _e622 = phi_1918_;
                                        phi_2073_ = _e391;
                                        phi_1920_ = type_48(_e393.member, (_e393.member_1 + 1u), _e393.member_2);
                                        phi_1921_ = _e620;
                                        phi_1922_ = _e622;
                                        phi_1923_ = select(_e611, _e421, _e613);
                                    }
                                    let _e1049 = phi_2073_;
                                    let _e1051 = phi_1920_;
                                    let _e1053 = phi_1921_;
                                    let _e1055 = phi_1922_;
                                    let _e1057 = phi_1923_;
                                    phi_2072_ = _e1049;
                                    phi_1924_ = _e1051;
                                    phi_1925_ = _e1053;
                                    phi_1926_ = (_e397 - 1u);
                                    phi_1927_ = _e1055;
                                    phi_1928_ = _e1057;
                                } else {
                                    phi_2072_ = _e391;
                                    phi_1924_ = _e393;
                                    phi_1925_ = _e417;
                                    phi_1926_ = _e397;
                                    phi_1927_ = _e419;
                                    phi_1928_ = _e421;
                                }
                                let _e1059 = phi_2072_;
                                let _e1061 = phi_1924_;
                                let _e1063 = phi_1925_;
                                let _e1065 = phi_1926_;
                                let _e1067 = phi_1927_;
                                let _e1069 = phi_1928_;
                                phi_2071_ = _e1059;
                                phi_1929_ = _e1061;
                                phi_1930_ = _e1063;
                                phi_1931_ = _e1065;
                                phi_1932_ = _e1067;
                                phi_1933_ = _e1069;
                            } else {
                                phi_2071_ = _e391;
                                phi_1929_ = type_48();
                                phi_1930_ = u32();
                                phi_1931_ = u32();
                                phi_1932_ = bool();
                                phi_1933_ = u32();
                            }
                            let _e1071 = phi_2071_;
                            let _e1073 = phi_1929_;
                            let _e1075 = phi_1930_;
                            let _e1077 = phi_1931_;
                            let _e1079 = phi_1932_;
                            let _e1081 = phi_1933_;
                            phi_2070_ = _e1071;
                            phi_649_ = _e1073;
                            phi_652_ = _e1075;
                            phi_654_ = _e1077;
                            phi_656_ = _e1079;
                            phi_658_ = _e1081;
                            phi_1934_ = _e405;
                        } else {
                            phi_2070_ = _e391;
                            phi_649_ = type_48();
                            phi_652_ = u32();
                            phi_654_ = u32();
                            phi_656_ = bool();
                            phi_658_ = u32();
                            phi_1934_ = false;
                        }
                        let _e1083 = phi_2070_;
                        let _e1085 = phi_649_;
                        let _e1087 = phi_652_;
                        let _e1089 = phi_654_;
                        let _e1091 = phi_656_;
                        let _e1093 = phi_658_;
                        let _e1095 = phi_1934_;
                        continue;
                        continuing {
                            phi_1965_ = _e1083;
                            phi_648_ = _e1085;
                            phi_651_ = _e1087;
                            phi_653_ = _e1089;
                            phi_655_ = _e1091;
                            phi_657_ = _e1093;
                            phi_2069_ = _e1083;
                            break if !(_e1095);
                        }
                    }
                    let _e1098 = phi_2069_;
                    if _e1098 {
                        break;
                    }
                    let _e1100 = local_2;
                    let _e1103 = local_3;
                    if _e74 {
                    } else {
                        break;
                    }
                    global_5.member[_e72][0u] = _e1100.member_1;
                    global_5.member[_e72][1u] = _e1103.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
