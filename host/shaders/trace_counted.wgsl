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

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_39 {
    member: type_27,
    member_1: f32,
}

struct type_44 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_46 {
    member: array<type_28>,
}

struct type_48 {
    member: type_39,
    member_1: u32,
    member_2: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<storage> global_2: type_33;
@group(0) @binding(2) 
var<storage> global_3: type_15;
@group(0) @binding(3) 
var<storage> global_4: type_46;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_21;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_275_: i32;
    var phi_276_: i32;
    var phi_286_: bool;
    var phi_296_: u32;
    var phi_297_: u32;
    var phi_299_: bool;
    var phi_304_: u32;
    var phi_316_: i32;
    var phi_336_: i32;
    var phi_354_: f32;
    var phi_360_: f32;
    var phi_371_: f32;
    var phi_377_: f32;
    var phi_400_: f32;
    var phi_411_: f32;
    var phi_420_: f32;
    var phi_426_: f32;
    var phi_437_: f32;
    var phi_443_: f32;
    var phi_466_: f32;
    var phi_477_: f32;
    var phi_486_: f32;
    var phi_492_: f32;
    var phi_503_: f32;
    var phi_509_: f32;
    var phi_532_: f32;
    var phi_543_: f32;
    var phi_643_: f32;
    var phi_644_: f32;
    var phi_2246_: bool;
    var phi_656_: type_48;
    var phi_659_: u32;
    var phi_661_: u32;
    var phi_663_: bool;
    var phi_665_: u32;
    var phi_676_: bool;
    var phi_708_: u32;
    var phi_709_: bool;
    var phi_710_: u32;
    var phi_1802_: type_44;
    var phi_2146_: u32;
    var phi_2174_: u32;
    var phi_2175_: u32;
    var phi_2176_: u32;
    var phi_2178_: u32;
    var phi_2179_: u32;
    var phi_2180_: bool;
    var phi_2189_: u32;
    var phi_2194_: u32;
    var phi_2195_: bool;
    var phi_725_: type_48;
    var phi_728_: type_4;
    var phi_729_: type_4;
    var phi_751_: type_4;
    var phi_775_: u32;
    var phi_864_: array<array<f32, 3>, 3>;
    var phi_981_: bool;
    var phi_1010_: bool;
    var phi_1411_: f32;
    var phi_1412_: f32;
    var phi_1413_: f32;
    var phi_1414_: f32;
    var phi_1415_: vec3<f32>;
    var phi_1416_: vec3<f32>;
    var phi_1417_: vec3<f32>;
    var phi_1418_: vec3<f32>;
    var phi_1449_: bool;
    var phi_1458_: vec3<f32>;
    var phi_1623_: f32;
    var phi_1625_: f32;
    var phi_1626_: bool;
    var phi_1646_: f32;
    var phi_1647_: f32;
    var phi_1670_: type_27;
    var phi_1672_: type_27;
    var phi_1673_: bool;
    var phi_1677_: type_27;
    var phi_1678_: type_27;
    var phi_1679_: type_27;
    var phi_1680_: bool;
    var phi_1684_: type_27;
    var phi_1685_: bool;
    var phi_1686_: type_27;
    var phi_1687_: bool;
    var phi_1688_: bool;
    var phi_1689_: type_27;
    var phi_1690_: bool;
    var phi_1691_: bool;
    var phi_1699_: type_27;
    var phi_1700_: bool;
    var phi_1704_: type_27;
    var phi_1729_: bool;
    var phi_1730_: bool;
    var phi_1737_: type_48;
    var phi_1738_: type_48;
    var phi_1739_: type_48;
    var phi_726_: type_48;
    var phi_2240_: bool;
    var phi_2386_: bool;
    var phi_2197_: type_48;
    var phi_2198_: u32;
    var phi_2199_: bool;
    var phi_2200_: u32;
    var phi_2385_: bool;
    var phi_2201_: type_48;
    var phi_2202_: u32;
    var phi_2203_: u32;
    var phi_2204_: bool;
    var phi_2205_: u32;
    var phi_2384_: bool;
    var phi_2206_: type_48;
    var phi_2207_: u32;
    var phi_2208_: u32;
    var phi_2209_: bool;
    var phi_2210_: u32;
    var phi_2383_: bool;
    var phi_657_: type_48;
    var phi_660_: u32;
    var phi_662_: u32;
    var phi_664_: bool;
    var phi_666_: u32;
    var phi_2211_: bool;
    var phi_2382_: bool;
    var local_2: type_48;
    var local_3: type_48;
    var local_4: type_48;

    switch bitcast<i32>(0u) {
        default: {
            let _e65 = global;
            let _e67 = arrayLength((&global_2.member));
            let _e69 = arrayLength((&global_3.member));
            let _e77 = (_e65.x + (_e65.y * 2097152u));
            let _e80 = global_1.member[0u];
            let _e81 = bitcast<i32>(_e80);
            let _e82 = (_e77 < arrayLength((&global_4.member)));
            if _e82 {
                let _e83 = (_e77 < arrayLength((&global_5.member)));
                if _e83 {
                    if _e82 {
                    } else {
                        break;
                    }
                    let _e91 = global_4.member[_e77].member_2[0u];
                    let _e93 = (bitcast<u32>(_e91) & 2147483647u);
                    let _e98 = global_4.member[_e77].member_2[1u];
                    let _e100 = (bitcast<u32>(_e98) & 2147483647u);
                    let _e105 = global_4.member[_e77].member_2[2u];
                    let _e107 = (bitcast<u32>(_e105) & 2147483647u);
                    let _e112 = global_4.member[_e77].member[0u];
                    let _e114 = (bitcast<u32>(_e112) & 2147483647u);
                    let _e119 = global_4.member[_e77].member[1u];
                    let _e121 = (bitcast<u32>(_e119) & 2147483647u);
                    let _e126 = global_4.member[_e77].member[2u];
                    let _e128 = (bitcast<u32>(_e126) & 2147483647u);
                    let _e130 = select(_e100, _e93, (_e100 < _e93));
                    let _e132 = select(_e107, _e130, (_e107 < _e130));
                    let _e134 = select(_e114, _e132, (_e114 < _e132));
                    let _e136 = select(_e121, _e134, (_e121 < _e134));
                    let _e138 = select(_e128, _e136, (_e128 < _e136));
                    let _e142 = global_4.member[_e77].member_1;
                    let _e144 = (bitcast<u32>(_e142) & 2147483647u);
                    let _e151 = global_4.member[_e77].member_3;
                    let _e157 = (((select(_e144, _e138, (_e144 < _e138)) < 2139095040u) && ((bitcast<u32>(_e151) & 2147483647u) <= 2139095040u)) && (_e132 > 0u));
                    if _e157 {
                        let _e160 = (bitcast<u32>(bitcast<f32>(_e132)) & 2147483647u);
                        if (_e160 >= 8388608u) {
                            phi_275_ = (bitcast<i32>((_e160 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_275_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e160)), 32u, (_e160 == 0u))));
                        }
                        let _e174 = phi_275_;
                        phi_276_ = _e174;
                    } else {
                        phi_276_ = 0i;
                    }
                    let _e176 = phi_276_;
                    let _e177 = (_e93 == _e132);
                    if _e177 {
                        phi_286_ = true;
                    } else {
                        phi_286_ = (_e100 == _e132);
                    }
                    let _e180 = phi_286_;
                    let _e181 = select(1u, 0u, _e177);
                    if _e180 {
                        let _e182 = (_e181 + 1u);
                        phi_296_ = _e182;
                        phi_297_ = _e182;
                        phi_299_ = select(true, false, (_e182 == 2u));
                    } else {
                        phi_296_ = u32();
                        phi_297_ = 0u;
                        phi_299_ = true;
                    }
                    let _e186 = phi_296_;
                    let _e188 = phi_297_;
                    let _e190 = phi_299_;
                    if _e190 {
                        phi_304_ = (_e188 + 1u);
                    } else {
                        phi_304_ = 0u;
                    }
                    let _e194 = phi_304_;
                    let _e195 = select(_e186, _e188, _e190);
                    let _e196 = select(_e181, select(2u, _e181, _e180), _e190);
                    if (_e81 < -126i) {
                        phi_316_ = -126i;
                    } else {
                        phi_316_ = select(_e81, 127i, (_e81 > 127i));
                    }
                    let _e201 = phi_316_;
                    let _e206 = bitcast<f32>((bitcast<u32>((_e201 + 127i)) << bitcast<u32>(23i)));
                    let _e212 = bitcast<f32>((bitcast<u32>(((_e81 - _e201) + 127i)) << bitcast<u32>(23i)));
                    let _e213 = -(_e176);
                    if (_e213 < -126i) {
                        phi_336_ = -126i;
                    } else {
                        phi_336_ = select(_e213, 127i, (_e213 > 127i));
                    }
                    let _e218 = phi_336_;
                    let _e223 = bitcast<f32>((bitcast<u32>((_e218 + 127i)) << bitcast<u32>(23i)));
                    let _e229 = bitcast<f32>((bitcast<u32>(((_e213 - _e218) + 127i)) << bitcast<u32>(23i)));
                    let _e233 = global_4.member[_e77].member;
                    let _e234 = (_e195 == 0u);
                    if _e234 {
                        phi_354_ = _e233[0];
                    } else {
                        phi_354_ = _e233[1];
                    }
                    let _e238 = phi_354_;
                    let _e239 = (_e195 == 2u);
                    if _e239 {
                        phi_360_ = _e233[2];
                    } else {
                        phi_360_ = _e238;
                    }
                    let _e242 = phi_360_;
                    let _e244 = ((_e242 * _e206) * _e212);
                    let _e245 = global_4.member[_e77].member_2;
                    if _e234 {
                        phi_371_ = _e245[0];
                    } else {
                        phi_371_ = _e245[1];
                    }
                    let _e249 = phi_371_;
                    if _e239 {
                        phi_377_ = _e245[2];
                    } else {
                        phi_377_ = _e249;
                    }
                    let _e252 = phi_377_;
                    let _e254 = ((_e252 * _e223) * _e229);
                    let _e258 = (bitcast<f32>((bitcast<u32>(_e254) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e258 {
                        let _e262 = (bitcast<f32>((bitcast<u32>(_e244) & 2147483647u)) * 0.00000011920929f);
                        phi_400_ = select(0.00000000000011368684f, _e262, (_e262 > 0.00000000000011368684f));
                    } else {
                        phi_400_ = 0f;
                    }
                    let _e266 = phi_400_;
                    let _e267 = (_e244 + _e266);
                    let _e268 = (_e244 - _e266);
                    let _e269 = select(_e254, 0f, _e258);
                    if _e258 {
                        phi_411_ = 38685626000000000000000000f;
                    } else {
                        phi_411_ = (1f / _e254);
                    }
                    let _e272 = phi_411_;
                    let _e273 = (_e194 == 0u);
                    if _e273 {
                        phi_420_ = _e233[0];
                    } else {
                        phi_420_ = _e233[1];
                    }
                    let _e277 = phi_420_;
                    let _e278 = (_e194 == 2u);
                    if _e278 {
                        phi_426_ = _e233[2];
                    } else {
                        phi_426_ = _e277;
                    }
                    let _e281 = phi_426_;
                    let _e283 = ((_e281 * _e206) * _e212);
                    if _e273 {
                        phi_437_ = _e245[0];
                    } else {
                        phi_437_ = _e245[1];
                    }
                    let _e287 = phi_437_;
                    if _e278 {
                        phi_443_ = _e245[2];
                    } else {
                        phi_443_ = _e287;
                    }
                    let _e290 = phi_443_;
                    let _e292 = ((_e290 * _e223) * _e229);
                    let _e296 = (bitcast<f32>((bitcast<u32>(_e292) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e296 {
                        let _e300 = (bitcast<f32>((bitcast<u32>(_e283) & 2147483647u)) * 0.00000011920929f);
                        phi_466_ = select(0.00000000000011368684f, _e300, (_e300 > 0.00000000000011368684f));
                    } else {
                        phi_466_ = 0f;
                    }
                    let _e304 = phi_466_;
                    let _e305 = (_e283 + _e304);
                    let _e306 = (_e283 - _e304);
                    let _e307 = select(_e292, 0f, _e296);
                    if _e296 {
                        phi_477_ = 38685626000000000000000000f;
                    } else {
                        phi_477_ = (1f / _e292);
                    }
                    let _e310 = phi_477_;
                    let _e311 = (_e196 == 0u);
                    if _e311 {
                        phi_486_ = _e233[0];
                    } else {
                        phi_486_ = _e233[1];
                    }
                    let _e315 = phi_486_;
                    let _e316 = (_e196 == 2u);
                    if _e316 {
                        phi_492_ = _e233[2];
                    } else {
                        phi_492_ = _e315;
                    }
                    let _e319 = phi_492_;
                    let _e321 = ((_e319 * _e206) * _e212);
                    if _e311 {
                        phi_503_ = _e245[0];
                    } else {
                        phi_503_ = _e245[1];
                    }
                    let _e325 = phi_503_;
                    if _e316 {
                        phi_509_ = _e245[2];
                    } else {
                        phi_509_ = _e325;
                    }
                    let _e328 = phi_509_;
                    let _e330 = ((_e328 * _e223) * _e229);
                    let _e334 = (bitcast<f32>((bitcast<u32>(_e330) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e334 {
                        let _e338 = (bitcast<f32>((bitcast<u32>(_e321) & 2147483647u)) * 0.00000011920929f);
                        phi_532_ = select(0.00000000000011368684f, _e338, (_e338 > 0.00000000000011368684f));
                    } else {
                        phi_532_ = 0f;
                    }
                    let _e342 = phi_532_;
                    let _e343 = (_e321 + _e342);
                    let _e344 = (_e321 - _e342);
                    let _e345 = select(_e330, 0f, _e334);
                    if _e334 {
                        phi_543_ = 38685626000000000000000000f;
                    } else {
                        phi_543_ = (1f / _e330);
                    }
                    let _e348 = phi_543_;
                    let _e351 = bitcast<f32>((bitcast<u32>(_e244) & 2147483647u));
                    let _e354 = bitcast<f32>((bitcast<u32>(_e283) & 2147483647u));
                    let _e356 = select(_e354, _e351, (_e351 > _e354));
                    let _e359 = bitcast<f32>((bitcast<u32>(_e321) & 2147483647u));
                    let _e362 = (_e81 + _e176);
                    if (_e157 && (select(_e359, _e356, (_e356 > _e359)) <= 1099511600000f)) {
                        let _e365 = (_e362 / 3i);
                        let _e372 = bitcast<f32>((bitcast<u32>((_e365 + 127i)) << bitcast<u32>(23i)));
                        let _e379 = bitcast<f32>((bitcast<u32>(((_e362 - (2i * _e365)) + 127i)) << bitcast<u32>(23i)));
                        let _e380 = (((_e142 * _e372) * _e372) * _e379);
                        let _e382 = select(340282350000000000000000000000000000000f, _e380, (_e380 < 340282350000000000000000000000000000000f));
                        let _e387 = (((_e151 * _e372) * _e372) * _e379);
                        let _e389 = select(340282350000000000000000000000000000000f, _e387, (_e387 < 340282350000000000000000000000000000000f));
                        phi_643_ = select(-340282350000000000000000000000000000000f, _e389, (_e389 > -340282350000000000000000000000000000000f));
                        phi_644_ = select(-340282350000000000000000000000000000000f, _e382, (_e382 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_643_ = 0f;
                        phi_644_ = 1f;
                    }
                    let _e393 = phi_643_;
                    let _e395 = phi_644_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2246_ = false;
                    phi_656_ = type_48(type_39(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e393), 0u, 0u);
                    phi_659_ = select(0u, 2147483648u, (_e67 == 0u));
                    phi_661_ = ((3u * _e67) + 1u);
                    phi_663_ = (_e395 <= _e393);
                    phi_665_ = 0u;
                    loop {
                        let _e404 = phi_2246_;
                        let _e406 = phi_656_;
                        let _e408 = phi_659_;
                        let _e410 = phi_661_;
                        let _e412 = phi_663_;
                        let _e414 = phi_665_;
                        local_2 = _e406;
                        local_3 = _e406;
                        if _e412 {
                            phi_676_ = true;
                        } else {
                            phi_676_ = (_e414 > 0u);
                        }
                        let _e417 = phi_676_;
                        if _e417 {
                            let _e418 = (_e410 > 0u);
                            if _e418 {
                                if _e412 {
                                    phi_708_ = _e408;
                                    phi_709_ = _e412;
                                    phi_710_ = _e414;
                                } else {
                                    let _e419 = (_e414 - 1u);
                                    let _e420 = (_e419 % 128u);
                                    let _e421 = (_e420 < 128u);
                                    if _e421 {
                                    } else {
                                        phi_2382_ = true;
                                        break;
                                    }
                                    let _e423 = local_1[_e420];
                                    if _e421 {
                                    } else {
                                        phi_2382_ = true;
                                        break;
                                    }
                                    let _e425 = local[_e420];
                                    phi_708_ = _e423;
                                    phi_709_ = (_e425 <= _e406.member.member_1);
                                    phi_710_ = _e419;
                                }
                                let _e430 = phi_708_;
                                let _e432 = phi_709_;
                                let _e434 = phi_710_;
                                if _e432 {
                                    if ((_e430 & 2147483648u) != 0u) {
                                        phi_725_ = _e406;
                                        phi_728_ = type_4(0u, ((_e430 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e639 = phi_725_;
                                            let _e641 = phi_728_;
                                            local_4 = _e639;
                                            if (_e641.member < _e641.member_1) {
                                                phi_729_ = type_4((_e641.member + 1u), _e641.member_1);
                                                phi_751_ = type_4(1u, _e641.member);
                                            } else {
                                                phi_729_ = _e641;
                                                phi_751_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e654 = phi_729_;
                                            let _e656 = phi_751_;
                                            let _e660 = (bitcast<i32>(_e656.member) != 0i);
                                            if _e660 {
                                                let _e666 = type_48(_e639.member, _e639.member_1, (_e639.member_2 + 1u));
                                                let _e667 = ((_e430 & 268435455u) + _e656.member_1);
                                                let _e668 = (_e667 < _e69);
                                                if _e668 {
                                                    if _e668 {
                                                    } else {
                                                        phi_2240_ = true;
                                                        break;
                                                    }
                                                    let _e672 = global_3.member[_e667].member_1;
                                                    phi_775_ = _e672;
                                                } else {
                                                    phi_775_ = 4294967295u;
                                                }
                                                let _e674 = phi_775_;
                                                if (_e667 >= _e69) {
                                                    phi_864_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e668 {
                                                    } else {
                                                        phi_2240_ = true;
                                                        break;
                                                    }
                                                    let _e676 = (_e195 % 3u);
                                                    let _e677 = (_e194 % 3u);
                                                    let _e678 = (_e196 % 3u);
                                                    if (_e676 < 9u) {
                                                    } else {
                                                        phi_2240_ = true;
                                                        break;
                                                    }
                                                    let _e684 = global_3.member[_e667].member[_e676];
                                                    if (_e677 < 9u) {
                                                    } else {
                                                        phi_2240_ = true;
                                                        break;
                                                    }
                                                    let _e690 = global_3.member[_e667].member[_e677];
                                                    if (_e678 < 9u) {
                                                    } else {
                                                        phi_2240_ = true;
                                                        break;
                                                    }
                                                    let _e696 = global_3.member[_e667].member[_e678];
                                                    let _e698 = (3u + _e676);
                                                    if (_e698 < 9u) {
                                                    } else {
                                                        phi_2240_ = true;
                                                        break;
                                                    }
                                                    let _e704 = global_3.member[_e667].member[_e698];
                                                    let _e705 = (3u + _e677);
                                                    if (_e705 < 9u) {
                                                    } else {
                                                        phi_2240_ = true;
                                                        break;
                                                    }
                                                    let _e711 = global_3.member[_e667].member[_e705];
                                                    let _e712 = (3u + _e678);
                                                    if (_e712 < 9u) {
                                                    } else {
                                                        phi_2240_ = true;
                                                        break;
                                                    }
                                                    let _e718 = global_3.member[_e667].member[_e712];
                                                    let _e720 = (6u + _e676);
                                                    if (_e720 < 9u) {
                                                    } else {
                                                        phi_2240_ = true;
                                                        break;
                                                    }
                                                    let _e726 = global_3.member[_e667].member[_e720];
                                                    let _e727 = (6u + _e677);
                                                    if (_e727 < 9u) {
                                                    } else {
                                                        phi_2240_ = true;
                                                        break;
                                                    }
                                                    let _e733 = global_3.member[_e667].member[_e727];
                                                    let _e734 = (6u + _e678);
                                                    if (_e734 < 9u) {
                                                    } else {
                                                        phi_2240_ = true;
                                                        break;
                                                    }
                                                    let _e740 = global_3.member[_e667].member[_e734];
                                                    phi_864_ = array<array<f32, 3>, 3>(array<f32, 3>(_e684, _e690, _e696), array<f32, 3>(_e704, _e711, _e718), array<f32, 3>(_e726, _e733, _e740));
                                                }
                                                let _e744 = phi_864_;
                                                let _e753 = (_e744[0][2] - _e321);
                                                let _e756 = (((_e744[0][0] - _e244) * _e345) - (_e753 * _e269));
                                                let _e759 = (((_e744[0][1] - _e283) * _e345) - (_e753 * _e307));
                                                let _e766 = (_e744[1][2] - _e321);
                                                let _e769 = (((_e744[1][0] - _e244) * _e345) - (_e766 * _e269));
                                                let _e772 = (((_e744[1][1] - _e283) * _e345) - (_e766 * _e307));
                                                let _e779 = (_e744[2][2] - _e321);
                                                let _e782 = (((_e744[2][0] - _e244) * _e345) - (_e779 * _e269));
                                                let _e785 = (((_e744[2][1] - _e283) * _e345) - (_e779 * _e307));
                                                let _e786 = (_e782 * _e772);
                                                let _e787 = (_e785 * _e769);
                                                let _e788 = (_e756 * _e785);
                                                let _e789 = (_e759 * _e782);
                                                let _e790 = (_e769 * _e759);
                                                let _e791 = (_e772 * _e756);
                                                let _e796 = (((_e786 >= _e787) && (_e788 >= _e789)) && (_e790 >= _e791));
                                                if (_e796 || (((_e786 <= _e787) && (_e788 <= _e789)) && (_e790 <= _e791))) {
                                                    let _e803 = select(-1f, 1f, _e796);
                                                    let _e805 = ((_e786 - _e787) * _e803);
                                                    let _e807 = select(0f, _e805, (_e805 > 0f));
                                                    let _e809 = ((_e788 - _e789) * _e803);
                                                    let _e811 = select(0f, _e809, (_e809 > 0f));
                                                    let _e813 = ((_e790 - _e791) * _e803);
                                                    let _e815 = select(0f, _e813, (_e813 > 0f));
                                                    let _e817 = ((_e807 + _e811) + _e815);
                                                    if (_e817 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1689_ = type_27();
                                                        phi_1690_ = true;
                                                        phi_1691_ = false;
                                                    } else {
                                                        let _e820 = select(_e769, _e756, (_e756 < _e769));
                                                        if (select(_e782, _e820, (_e820 < _e782)) > 0f) {
                                                            phi_981_ = true;
                                                        } else {
                                                            let _e825 = select(_e769, _e756, (_e756 > _e769));
                                                            phi_981_ = (select(_e782, _e825, (_e825 > _e782)) < 0f);
                                                        }
                                                        let _e830 = phi_981_;
                                                        if _e830 {
                                                            phi_1686_ = type_27();
                                                            phi_1687_ = true;
                                                            phi_1688_ = false;
                                                        } else {
                                                            let _e832 = select(_e772, _e759, (_e759 < _e772));
                                                            if (select(_e785, _e832, (_e832 < _e785)) > 0f) {
                                                                phi_1010_ = true;
                                                            } else {
                                                                let _e837 = select(_e772, _e759, (_e759 > _e772));
                                                                phi_1010_ = (select(_e785, _e837, (_e837 > _e785)) < 0f);
                                                            }
                                                            let _e842 = phi_1010_;
                                                            if _e842 {
                                                                phi_1684_ = type_27();
                                                                phi_1685_ = false;
                                                            } else {
                                                                let _e844 = select(_e744[1][0], _e744[0][0], (_e744[0][0] < _e744[1][0]));
                                                                let _e848 = select(_e744[1][0], _e744[0][0], (_e744[0][0] > _e744[1][0]));
                                                                let _e852 = select(_e744[1][1], _e744[0][1], (_e744[0][1] < _e744[1][1]));
                                                                let _e856 = select(_e744[1][1], _e744[0][1], (_e744[0][1] > _e744[1][1]));
                                                                let _e860 = select(_e744[1][2], _e744[0][2], (_e744[0][2] < _e744[1][2]));
                                                                let _e864 = select(_e744[1][2], _e744[0][2], (_e744[0][2] > _e744[1][2]));
                                                                let _e869 = ((select(_e744[2][0], _e844, (_e844 < _e744[2][0])) - _e267) * _e272);
                                                                let _e870 = ((select(_e744[2][0], _e848, (_e848 > _e744[2][0])) - _e268) * _e272);
                                                                let _e873 = ((select(_e744[2][1], _e852, (_e852 < _e744[2][1])) - _e305) * _e310);
                                                                let _e874 = ((select(_e744[2][1], _e856, (_e856 > _e744[2][1])) - _e306) * _e310);
                                                                let _e877 = ((select(_e744[2][2], _e860, (_e860 < _e744[2][2])) - _e343) * _e348);
                                                                let _e878 = ((select(_e744[2][2], _e864, (_e864 > _e744[2][2])) - _e344) * _e348);
                                                                let _e880 = select(_e878, _e877, (_e877 < _e878));
                                                                let _e882 = select(_e878, _e877, (_e877 > _e878));
                                                                let _e884 = select(_e870, _e869, (_e869 < _e870));
                                                                let _e886 = select(_e874, _e873, (_e873 < _e874));
                                                                let _e888 = select(_e886, _e884, (_e884 > _e886));
                                                                let _e890 = select(_e880, _e888, (_e888 > _e880));
                                                                let _e892 = select(_e870, _e869, (_e869 > _e870));
                                                                let _e894 = select(_e874, _e873, (_e873 > _e874));
                                                                let _e896 = select(_e894, _e892, (_e892 < _e894));
                                                                let _e898 = select(_e882, _e896, (_e896 < _e882));
                                                                let _e899 = -(_e880);
                                                                let _e905 = select(_e395, _e890, (_e890 > _e395));
                                                                if (_e905 > (_e898 + (select(_e899, _e882, (_e882 > _e899)) * 0.0000019073523f))) {
                                                                    phi_1679_ = type_27();
                                                                    phi_1680_ = true;
                                                                } else {
                                                                    let _e907 = (_e905 > _e639.member.member_1);
                                                                    if _e907 {
                                                                        phi_1678_ = type_27();
                                                                    } else {
                                                                        let _e908 = vec3<f32>(_e744[0][0], _e744[0][1], _e744[0][2]);
                                                                        let _e909 = vec3<f32>(_e744[1][0], _e744[1][1], _e744[1][2]);
                                                                        let _e910 = vec3<f32>(_e744[2][0], _e744[2][1], _e744[2][2]);
                                                                        let _e911 = (_e744[1][0] - _e744[0][0]);
                                                                        let _e912 = (_e744[1][1] - _e744[0][1]);
                                                                        let _e913 = (_e744[1][2] - _e744[0][2]);
                                                                        let _e914 = vec3<f32>(_e911, _e912, _e913);
                                                                        let _e915 = (_e744[2][0] - _e744[1][0]);
                                                                        let _e916 = (_e744[2][1] - _e744[1][1]);
                                                                        let _e917 = (_e744[2][2] - _e744[1][2]);
                                                                        let _e918 = vec3<f32>(_e915, _e916, _e917);
                                                                        let _e919 = (_e744[0][0] - _e744[2][0]);
                                                                        let _e920 = (_e744[0][1] - _e744[2][1]);
                                                                        let _e921 = (_e744[0][2] - _e744[2][2]);
                                                                        let _e922 = vec3<f32>(_e919, _e920, _e921);
                                                                        let _e925 = bitcast<f32>((bitcast<u32>(_e911) & 2147483647u));
                                                                        let _e928 = bitcast<f32>((bitcast<u32>(_e912) & 2147483647u));
                                                                        let _e930 = select(_e928, _e925, (_e925 > _e928));
                                                                        let _e933 = bitcast<f32>((bitcast<u32>(_e913) & 2147483647u));
                                                                        let _e935 = select(_e933, _e930, (_e930 > _e933));
                                                                        let _e938 = bitcast<f32>((bitcast<u32>(_e915) & 2147483647u));
                                                                        let _e941 = bitcast<f32>((bitcast<u32>(_e916) & 2147483647u));
                                                                        let _e943 = select(_e941, _e938, (_e938 > _e941));
                                                                        let _e946 = bitcast<f32>((bitcast<u32>(_e917) & 2147483647u));
                                                                        let _e948 = select(_e946, _e943, (_e943 > _e946));
                                                                        let _e951 = bitcast<f32>((bitcast<u32>(_e919) & 2147483647u));
                                                                        let _e954 = bitcast<f32>((bitcast<u32>(_e920) & 2147483647u));
                                                                        let _e956 = select(_e954, _e951, (_e951 > _e954));
                                                                        let _e959 = bitcast<f32>((bitcast<u32>(_e921) & 2147483647u));
                                                                        let _e961 = select(_e959, _e956, (_e956 > _e959));
                                                                        let _e963 = select(_e948, _e935, (_e935 > _e948));
                                                                        let _e965 = select(_e961, _e963, (_e963 > _e961));
                                                                        if (_e935 == _e965) {
                                                                            phi_1411_ = _e772;
                                                                            phi_1412_ = _e769;
                                                                            phi_1413_ = _e759;
                                                                            phi_1414_ = _e756;
                                                                            phi_1415_ = _e908;
                                                                            phi_1416_ = _e922;
                                                                            phi_1417_ = _e918;
                                                                            phi_1418_ = _e914;
                                                                        } else {
                                                                            let _e967 = (_e948 == _e965);
                                                                            let _e972 = vec3(_e967);
                                                                            phi_1411_ = select(_e759, _e785, _e967);
                                                                            phi_1412_ = select(_e756, _e782, _e967);
                                                                            phi_1413_ = select(_e785, _e772, _e967);
                                                                            phi_1414_ = select(_e782, _e769, _e967);
                                                                            phi_1415_ = select(_e910, _e909, _e972);
                                                                            phi_1416_ = select(_e918, _e914, _e972);
                                                                            phi_1417_ = select(_e914, _e922, _e972);
                                                                            phi_1418_ = select(_e922, _e918, _e972);
                                                                        }
                                                                        let _e978 = phi_1411_;
                                                                        let _e980 = phi_1412_;
                                                                        let _e982 = phi_1413_;
                                                                        let _e984 = phi_1414_;
                                                                        let _e986 = phi_1415_;
                                                                        let _e988 = phi_1416_;
                                                                        let _e990 = phi_1417_;
                                                                        let _e992 = phi_1418_;
                                                                        let _e999 = ((_e990.y * _e988.z) - (_e988.y * _e990.z));
                                                                        let _e1004 = ((_e990.z * _e988.x) - (_e988.z * _e990.x));
                                                                        let _e1007 = ((_e990.x * _e988.y) - (_e988.x * _e990.y));
                                                                        if (_e807 >= _e811) {
                                                                            phi_1449_ = select(true, false, (_e807 >= _e815));
                                                                        } else {
                                                                            phi_1449_ = true;
                                                                        }
                                                                        let _e1012 = phi_1449_;
                                                                        if _e1012 {
                                                                            phi_1458_ = select(_e910, _e909, vec3((_e811 >= _e815)));
                                                                        } else {
                                                                            phi_1458_ = _e908;
                                                                        }
                                                                        let _e1017 = phi_1458_;
                                                                        let _e1028 = (((_e999 * (_e1017.x - _e244)) + (_e1004 * (_e1017.y - _e283))) + (_e1007 * (_e1017.z - _e321)));
                                                                        let _e1033 = (((_e999 * _e269) + (_e1004 * _e307)) + (_e1007 * _e345));
                                                                        let _e1034 = (_e980 - _e984);
                                                                        let _e1035 = (_e978 - _e982);
                                                                        let _e1043 = (-(((_e984 * _e1034) + (_e982 * _e1035))) / ((_e1034 * _e1034) + (_e1035 * _e1035)));
                                                                        let _e1045 = select(1f, _e1043, (_e1043 < 1f));
                                                                        let _e1047 = select(0f, _e1045, (_e1045 > 0f));
                                                                        let _e1060 = ((_e986.x + (_e992.x * _e1047)) - _e244);
                                                                        let _e1061 = ((_e986.y + (_e992.y * _e1047)) - _e283);
                                                                        let _e1062 = ((_e986.z + (_e992.z * _e1047)) - _e321);
                                                                        let _e1063 = (_e1062 / _e345);
                                                                        let _e1075 = bitcast<f32>((bitcast<u32>(_e1060) & 2147483647u));
                                                                        let _e1078 = bitcast<f32>((bitcast<u32>(_e1061) & 2147483647u));
                                                                        let _e1080 = select(_e1078, _e1075, (_e1075 > _e1078));
                                                                        let _e1083 = bitcast<f32>((bitcast<u32>(_e1062) & 2147483647u));
                                                                        let _e1085 = select(_e1083, _e1080, (_e1080 > _e1083));
                                                                        let _e1091 = bitcast<f32>((bitcast<u32>(_e999) & 2147483647u));
                                                                        let _e1094 = bitcast<f32>((bitcast<u32>(_e1004) & 2147483647u));
                                                                        let _e1096 = select(_e1094, _e1091, (_e1091 > _e1094));
                                                                        let _e1099 = bitcast<f32>((bitcast<u32>(_e1007) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e999 * _e1060) + (_e1004 * _e1061)) + (_e1007 * _e1062)) - _e1028)) & 2147483647u)) <= ((0.0000009536743f * select(_e965, _e1085, (_e1085 > _e965))) * select(_e1099, _e1096, (_e1096 > _e1099)))) {
                                                                            let _e1109 = bitcast<f32>((bitcast<u32>(_e990.x) & 2147483647u));
                                                                            let _e1112 = bitcast<f32>((bitcast<u32>(_e990.y) & 2147483647u));
                                                                            let _e1114 = select(_e1112, _e1109, (_e1109 > _e1112));
                                                                            let _e1117 = bitcast<f32>((bitcast<u32>(_e990.z) & 2147483647u));
                                                                            let _e1123 = bitcast<f32>((bitcast<u32>(_e988.x) & 2147483647u));
                                                                            let _e1126 = bitcast<f32>((bitcast<u32>(_e988.y) & 2147483647u));
                                                                            let _e1128 = select(_e1126, _e1123, (_e1123 > _e1126));
                                                                            let _e1131 = bitcast<f32>((bitcast<u32>(_e988.z) & 2147483647u));
                                                                            let _e1135 = (bitcast<f32>((bitcast<u32>(_e1033) & 2147483647u)) > ((0.0000038146973f * select(_e1117, _e1114, (_e1114 > _e1117))) * select(_e1131, _e1128, (_e1128 > _e1131))));
                                                                            if _e1135 {
                                                                                phi_1623_ = (_e1028 / _e1033);
                                                                            } else {
                                                                                phi_1623_ = f32();
                                                                            }
                                                                            let _e1138 = phi_1623_;
                                                                            phi_1625_ = _e1138;
                                                                            phi_1626_ = select(true, false, _e1135);
                                                                        } else {
                                                                            phi_1625_ = f32();
                                                                            phi_1626_ = true;
                                                                        }
                                                                        let _e1141 = phi_1625_;
                                                                        let _e1143 = phi_1626_;
                                                                        if _e1143 {
                                                                            let _e1151 = (((_e999 * (_e1060 - (_e269 * _e1063))) + (_e1004 * (_e1061 - (_e307 * _e1063)))) / _e1033);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1151) & 2147483647u)) <= _e965) {
                                                                                phi_1646_ = (_e1063 + _e1151);
                                                                            } else {
                                                                                phi_1646_ = _e1063;
                                                                            }
                                                                            let _e1158 = phi_1646_;
                                                                            phi_1647_ = _e1158;
                                                                        } else {
                                                                            phi_1647_ = _e1141;
                                                                        }
                                                                        let _e1160 = phi_1647_;
                                                                        let _e1162 = select(_e898, _e1160, (_e1160 < _e898));
                                                                        let _e1164 = select(_e890, _e1162, (_e1162 > _e890));
                                                                        if (_e1164 >= _e395) {
                                                                            let _e1166 = (_e1164 <= _e639.member.member_1);
                                                                            if _e1166 {
                                                                                let _e1167 = (1f / _e817);
                                                                                phi_1670_ = type_27(_e1164, (_e811 * _e1167), (_e815 * _e1167), _e674);
                                                                            } else {
                                                                                phi_1670_ = type_27();
                                                                            }
                                                                            let _e1172 = phi_1670_;
                                                                            phi_1672_ = _e1172;
                                                                            phi_1673_ = select(true, false, _e1166);
                                                                        } else {
                                                                            phi_1672_ = type_27();
                                                                            phi_1673_ = true;
                                                                        }
                                                                        let _e1175 = phi_1672_;
                                                                        let _e1177 = phi_1673_;
                                                                        if _e1177 {
                                                                            phi_1677_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1677_ = _e1175;
                                                                        }
                                                                        let _e1179 = phi_1677_;
                                                                        phi_1678_ = _e1179;
                                                                    }
                                                                    let _e1181 = phi_1678_;
                                                                    phi_1679_ = _e1181;
                                                                    phi_1680_ = _e907;
                                                                }
                                                                let _e1183 = phi_1679_;
                                                                let _e1185 = phi_1680_;
                                                                phi_1684_ = _e1183;
                                                                phi_1685_ = _e1185;
                                                            }
                                                            let _e1187 = phi_1684_;
                                                            let _e1189 = phi_1685_;
                                                            phi_1686_ = _e1187;
                                                            phi_1687_ = _e842;
                                                            phi_1688_ = _e1189;
                                                        }
                                                        let _e1191 = phi_1686_;
                                                        let _e1193 = phi_1687_;
                                                        let _e1195 = phi_1688_;
                                                        phi_1689_ = _e1191;
                                                        phi_1690_ = _e1193;
                                                        phi_1691_ = _e1195;
                                                    }
                                                    let _e1197 = phi_1689_;
                                                    let _e1199 = phi_1690_;
                                                    let _e1201 = phi_1691_;
                                                    phi_1699_ = _e1197;
                                                    phi_1700_ = select(_e1201, true, _e1199);
                                                } else {
                                                    phi_1699_ = type_27();
                                                    phi_1700_ = true;
                                                }
                                                let _e1204 = phi_1699_;
                                                let _e1206 = phi_1700_;
                                                if _e1206 {
                                                    phi_1704_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1704_ = _e1204;
                                                }
                                                let _e1208 = phi_1704_;
                                                if (_e1208.member_3 != 4294967295u) {
                                                    if (_e674 != 4294967295u) {
                                                        if (_e1208.member < _e639.member.member.member) {
                                                            phi_1730_ = true;
                                                        } else {
                                                            if (_e1208.member == _e639.member.member.member) {
                                                                phi_1729_ = (_e1208.member_3 < _e639.member.member.member_3);
                                                            } else {
                                                                phi_1729_ = false;
                                                            }
                                                            let _e1223 = phi_1729_;
                                                            phi_1730_ = _e1223;
                                                        }
                                                        let _e1225 = phi_1730_;
                                                        if _e1225 {
                                                            phi_1737_ = type_48(type_39(_e1208, _e1208.member), _e666.member_1, _e666.member_2);
                                                        } else {
                                                            phi_1737_ = _e666;
                                                        }
                                                        let _e1232 = phi_1737_;
                                                        phi_1738_ = _e1232;
                                                    } else {
                                                        phi_1738_ = _e666;
                                                    }
                                                    let _e1234 = phi_1738_;
                                                    phi_1739_ = _e1234;
                                                } else {
                                                    phi_1739_ = _e666;
                                                }
                                                let _e1236 = phi_1739_;
                                                phi_726_ = _e1236;
                                            } else {
                                                phi_726_ = type_48();
                                            }
                                            let _e1238 = phi_726_;
                                            continue;
                                            continuing {
                                                phi_725_ = _e1238;
                                                phi_728_ = _e654;
                                                phi_2240_ = _e404;
                                                break if !(_e660);
                                            }
                                        }
                                        let _e1241 = phi_2240_;
                                        phi_2382_ = _e1241;
                                        if _e1241 {
                                            break;
                                        }
                                        phi_2386_ = _e1241;
                                        let _e1406 = local_4;
                                        phi_2197_ = _e1406;
                                        phi_2198_ = _e430;
                                        phi_2199_ = false;
                                        phi_2200_ = _e434;
                                    } else {
                                        if (_e430 >= _e67) {
                                            phi_1802_ = type_44(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e430 < _e67) {
                                            } else {
                                                phi_2382_ = true;
                                                break;
                                            }
                                            let _e450 = (_e195 % 3u);
                                            if (_e450 < 3u) {
                                            } else {
                                                phi_2382_ = true;
                                                break;
                                            }
                                            let _e456 = global_2.member[_e430].member[_e450];
                                            let _e462 = (_e194 % 3u);
                                            if (_e462 < 3u) {
                                            } else {
                                                phi_2382_ = true;
                                                break;
                                            }
                                            let _e468 = global_2.member[_e430].member[_e462];
                                            let _e474 = (_e196 % 3u);
                                            if (_e474 < 3u) {
                                            } else {
                                                phi_2382_ = true;
                                                break;
                                            }
                                            let _e480 = global_2.member[_e430].member[_e474];
                                            let _e490 = global_2.member[_e430].member_1;
                                            let _e494 = global_2.member[_e430].member_2;
                                            phi_1802_ = type_44(array<vec4<f32>, 3>(vec4<f32>(_e456[0], _e456[1], _e456[2], _e456[3]), vec4<f32>(_e468[0], _e468[1], _e468[2], _e468[3]), vec4<f32>(_e480[0], _e480[1], _e480[2], _e480[3])), _e490, _e494);
                                        }
                                        let _e497 = phi_1802_;
                                        let _e510 = ((_e497.member[0].x - _e267) * _e272);
                                        let _e511 = ((_e497.member[0].y - _e267) * _e272);
                                        let _e512 = ((_e497.member[0].z - _e268) * _e272);
                                        let _e513 = ((_e497.member[0].w - _e268) * _e272);
                                        let _e523 = ((_e497.member[1].x - _e305) * _e310);
                                        let _e524 = ((_e497.member[1].y - _e305) * _e310);
                                        let _e525 = ((_e497.member[1].z - _e306) * _e310);
                                        let _e526 = ((_e497.member[1].w - _e306) * _e310);
                                        let _e536 = ((_e497.member[2].x - _e343) * _e348);
                                        let _e537 = ((_e497.member[2].y - _e343) * _e348);
                                        let _e538 = ((_e497.member[2].z - _e344) * _e348);
                                        let _e539 = ((_e497.member[2].w - _e344) * _e348);
                                        let _e541 = select(_e538, _e536, (_e536 < _e538));
                                        let _e543 = select(_e539, _e537, (_e537 < _e539));
                                        let _e545 = select(_e538, _e536, (_e536 > _e538));
                                        let _e547 = select(_e539, _e537, (_e537 > _e539));
                                        let _e549 = select(_e512, _e510, (_e510 < _e512));
                                        let _e551 = select(_e513, _e511, (_e511 < _e513));
                                        let _e553 = select(_e525, _e523, (_e523 < _e525));
                                        let _e555 = select(_e526, _e524, (_e524 < _e526));
                                        let _e557 = select(_e553, _e549, (_e549 > _e553));
                                        let _e559 = select(_e555, _e551, (_e551 > _e555));
                                        let _e561 = select(_e541, _e557, (_e557 > _e541));
                                        let _e563 = select(_e543, _e559, (_e559 > _e543));
                                        let _e565 = select(_e512, _e510, (_e510 > _e512));
                                        let _e567 = select(_e513, _e511, (_e511 > _e513));
                                        let _e569 = select(_e525, _e523, (_e523 > _e525));
                                        let _e571 = select(_e526, _e524, (_e524 > _e526));
                                        let _e573 = select(_e569, _e565, (_e565 < _e569));
                                        let _e575 = select(_e571, _e567, (_e567 < _e571));
                                        let _e580 = -(_e541);
                                        let _e581 = -(_e543);
                                        let _e588 = (select(_e545, _e573, (_e573 < _e545)) + (select(_e580, _e545, (_e545 > _e580)) * 0.0000019073523f));
                                        let _e589 = (select(_e547, _e575, (_e575 < _e547)) + (select(_e581, _e547, (_e547 > _e581)) * 0.0000019073523f));
                                        let _e591 = select(_e395, _e561, (_e561 > _e395));
                                        let _e593 = select(_e395, _e563, (_e563 > _e395));
                                        let _e598 = (_e591 <= select(_e406.member.member_1, _e588, (_e588 < _e406.member.member_1)));
                                        let _e599 = (_e593 <= select(_e406.member.member_1, _e589, (_e589 < _e406.member.member_1)));
                                        let _e600 = (_e591 <= _e593);
                                        if _e598 {
                                            if _e599 {
                                                if _e600 {
                                                    phi_2146_ = _e497.member_2;
                                                } else {
                                                    phi_2146_ = _e497.member_1;
                                                }
                                                let _e604 = phi_2146_;
                                                let _e607 = (_e434 % 128u);
                                                let _e608 = (_e607 < 128u);
                                                if _e608 {
                                                } else {
                                                    phi_2382_ = true;
                                                    break;
                                                }
                                                local_1[_e607] = _e604;
                                                if _e608 {
                                                } else {
                                                    phi_2382_ = true;
                                                    break;
                                                }
                                                local[_e607] = select(_e593, _e591, (_e591 > _e593));
                                                if _e600 {
                                                    phi_2174_ = _e497.member_1;
                                                } else {
                                                    phi_2174_ = _e497.member_2;
                                                }
                                                let _e615 = phi_2174_;
                                                phi_2175_ = _e615;
                                                phi_2176_ = (_e434 + 1u);
                                            } else {
                                                phi_2175_ = u32();
                                                phi_2176_ = u32();
                                            }
                                            let _e617 = phi_2175_;
                                            let _e619 = phi_2176_;
                                            phi_2178_ = _e617;
                                            phi_2179_ = _e619;
                                            phi_2180_ = select(true, false, _e599);
                                        } else {
                                            phi_2178_ = u32();
                                            phi_2179_ = u32();
                                            phi_2180_ = true;
                                        }
                                        let _e622 = phi_2178_;
                                        let _e624 = phi_2179_;
                                        let _e626 = phi_2180_;
                                        if _e626 {
                                            if _e598 {
                                                phi_2189_ = _e497.member_1;
                                            } else {
                                                phi_2189_ = _e497.member_2;
                                            }
                                            let _e630 = phi_2189_;
                                            phi_2194_ = _e630;
                                            phi_2195_ = select(_e599, true, _e598);
                                        } else {
                                            phi_2194_ = _e622;
                                            phi_2195_ = _e432;
                                        }
                                        let _e633 = phi_2194_;
                                        let _e635 = phi_2195_;
                                        phi_2386_ = _e404;
                                        phi_2197_ = type_48(_e406.member, (_e406.member_1 + 1u), _e406.member_2);
                                        phi_2198_ = _e633;
                                        phi_2199_ = _e635;
                                        phi_2200_ = select(_e624, _e434, _e626);
                                    }
                                    let _e1243 = phi_2386_;
                                    let _e1245 = phi_2197_;
                                    let _e1247 = phi_2198_;
                                    let _e1249 = phi_2199_;
                                    let _e1251 = phi_2200_;
                                    phi_2385_ = _e1243;
                                    phi_2201_ = _e1245;
                                    phi_2202_ = _e1247;
                                    phi_2203_ = (_e410 - 1u);
                                    phi_2204_ = _e1249;
                                    phi_2205_ = _e1251;
                                } else {
                                    phi_2385_ = _e404;
                                    phi_2201_ = _e406;
                                    phi_2202_ = _e430;
                                    phi_2203_ = _e410;
                                    phi_2204_ = _e432;
                                    phi_2205_ = _e434;
                                }
                                let _e1253 = phi_2385_;
                                let _e1255 = phi_2201_;
                                let _e1257 = phi_2202_;
                                let _e1259 = phi_2203_;
                                let _e1261 = phi_2204_;
                                let _e1263 = phi_2205_;
                                phi_2384_ = _e1253;
                                phi_2206_ = _e1255;
                                phi_2207_ = _e1257;
                                phi_2208_ = _e1259;
                                phi_2209_ = _e1261;
                                phi_2210_ = _e1263;
                            } else {
                                phi_2384_ = _e404;
                                phi_2206_ = type_48();
                                phi_2207_ = u32();
                                phi_2208_ = u32();
                                phi_2209_ = bool();
                                phi_2210_ = u32();
                            }
                            let _e1265 = phi_2384_;
                            let _e1267 = phi_2206_;
                            let _e1269 = phi_2207_;
                            let _e1271 = phi_2208_;
                            let _e1273 = phi_2209_;
                            let _e1275 = phi_2210_;
                            phi_2383_ = _e1265;
                            phi_657_ = _e1267;
                            phi_660_ = _e1269;
                            phi_662_ = _e1271;
                            phi_664_ = _e1273;
                            phi_666_ = _e1275;
                            phi_2211_ = _e418;
                        } else {
                            phi_2383_ = _e404;
                            phi_657_ = type_48();
                            phi_660_ = u32();
                            phi_662_ = u32();
                            phi_664_ = bool();
                            phi_666_ = u32();
                            phi_2211_ = false;
                        }
                        let _e1277 = phi_2383_;
                        let _e1279 = phi_657_;
                        let _e1281 = phi_660_;
                        let _e1283 = phi_662_;
                        let _e1285 = phi_664_;
                        let _e1287 = phi_666_;
                        let _e1289 = phi_2211_;
                        continue;
                        continuing {
                            phi_2246_ = _e1277;
                            phi_656_ = _e1279;
                            phi_659_ = _e1281;
                            phi_661_ = _e1283;
                            phi_663_ = _e1285;
                            phi_665_ = _e1287;
                            phi_2382_ = _e1277;
                            break if !(_e1289);
                        }
                    }
                    let _e1292 = phi_2382_;
                    if _e1292 {
                        break;
                    }
                    let _e1294 = local_2;
                    let _e1297 = local_3;
                    if _e83 {
                    } else {
                        break;
                    }
                    global_5.member[_e77][0u] = _e1294.member_1;
                    global_5.member[_e77][1u] = _e1297.member_2;
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
