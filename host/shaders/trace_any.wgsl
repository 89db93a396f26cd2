struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: vec4<u32>,
}

struct type_16 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_26 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_27 {
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

struct type_42 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_44 {
    member: array<type_27>,
}

struct type_46 {
    member: f32,
    member_1: bool,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(1) 
var<storage> global_2: type_32;
@group(0) @binding(2) 
var<storage> global_3: type_18;
@group(0) @binding(3) 
var<storage> global_4: type_44;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_4;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_272_: i32;
    var phi_273_: i32;
    var phi_283_: bool;
    var phi_293_: u32;
    var phi_294_: u32;
    var phi_296_: bool;
    var phi_301_: u32;
    var phi_313_: i32;
    var phi_333_: i32;
    var phi_351_: f32;
    var phi_357_: f32;
    var phi_368_: f32;
    var phi_374_: f32;
    var phi_397_: f32;
    var phi_408_: f32;
    var phi_417_: f32;
    var phi_423_: f32;
    var phi_434_: f32;
    var phi_440_: f32;
    var phi_463_: f32;
    var phi_474_: f32;
    var phi_483_: f32;
    var phi_489_: f32;
    var phi_500_: f32;
    var phi_506_: f32;
    var phi_529_: f32;
    var phi_540_: f32;
    var phi_640_: f32;
    var phi_641_: f32;
    var phi_2212_: bool;
    var phi_652_: type_46;
    var phi_655_: u32;
    var phi_657_: u32;
    var phi_659_: bool;
    var phi_661_: u32;
    var phi_672_: bool;
    var phi_704_: u32;
    var phi_705_: bool;
    var phi_706_: u32;
    var phi_1770_: type_42;
    var phi_2114_: u32;
    var phi_2142_: u32;
    var phi_2143_: u32;
    var phi_2144_: u32;
    var phi_2146_: u32;
    var phi_2147_: u32;
    var phi_2148_: bool;
    var phi_2157_: u32;
    var phi_2162_: u32;
    var phi_2163_: bool;
    var phi_721_: type_46;
    var phi_724_: type_7;
    var phi_725_: type_7;
    var phi_747_: type_7;
    var phi_768_: u32;
    var phi_857_: array<array<f32, 3>, 3>;
    var phi_974_: bool;
    var phi_1003_: bool;
    var phi_1404_: f32;
    var phi_1405_: f32;
    var phi_1406_: f32;
    var phi_1407_: f32;
    var phi_1408_: vec3<f32>;
    var phi_1409_: vec3<f32>;
    var phi_1410_: vec3<f32>;
    var phi_1411_: vec3<f32>;
    var phi_1442_: bool;
    var phi_1451_: vec3<f32>;
    var phi_1616_: f32;
    var phi_1618_: f32;
    var phi_1619_: bool;
    var phi_1639_: f32;
    var phi_1640_: f32;
    var phi_1663_: type_26;
    var phi_1665_: type_26;
    var phi_1666_: bool;
    var phi_1670_: type_26;
    var phi_1671_: type_26;
    var phi_1672_: type_26;
    var phi_1673_: bool;
    var phi_1677_: type_26;
    var phi_1678_: bool;
    var phi_1679_: type_26;
    var phi_1680_: bool;
    var phi_1681_: bool;
    var phi_1682_: type_26;
    var phi_1683_: bool;
    var phi_1684_: bool;
    var phi_1692_: type_26;
    var phi_1693_: bool;
    var phi_1697_: type_26;
    var phi_1708_: type_46;
    var phi_1709_: type_46;
    var phi_722_: type_46;
    var phi_2206_: bool;
    var local_2: type_46;
    var phi_2349_: bool;
    var phi_2165_: type_46;
    var phi_2166_: u32;
    var phi_2167_: bool;
    var phi_2168_: u32;
    var phi_2348_: bool;
    var phi_2169_: type_46;
    var phi_2170_: u32;
    var phi_2171_: u32;
    var phi_2172_: bool;
    var phi_2173_: u32;
    var phi_2347_: bool;
    var phi_2174_: type_46;
    var phi_2175_: u32;
    var phi_2176_: u32;
    var phi_2177_: bool;
    var phi_2178_: u32;
    var phi_2346_: bool;
    var phi_653_: type_46;
    var phi_656_: u32;
    var phi_658_: u32;
    var phi_660_: bool;
    var phi_662_: u32;
    var phi_2179_: bool;
    var phi_2345_: bool;
    var local_3: type_46;
    var local_4: type_46;

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
                            phi_272_ = (bitcast<i32>((_e160 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_272_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e160)), 32u, (_e160 == 0u))));
                        }
                        let _e174 = phi_272_;
                        phi_273_ = _e174;
                    } else {
                        phi_273_ = 0i;
                    }
                    let _e176 = phi_273_;
                    let _e177 = (_e93 == _e132);
                    if _e177 {
                        phi_283_ = true;
                    } else {
                        phi_283_ = (_e100 == _e132);
                    }
                    let _e180 = phi_283_;
                    let _e181 = select(1u, 0u, _e177);
                    if _e180 {
                        let _e182 = (_e181 + 1u);
                        phi_293_ = _e182;
                        phi_294_ = _e182;
                        phi_296_ = select(true, false, (_e182 == 2u));
                    } else {
                        phi_293_ = u32();
                        phi_294_ = 0u;
                        phi_296_ = true;
                    }
                    let _e186 = phi_293_;
                    let _e188 = phi_294_;
                    let _e190 = phi_296_;
                    if _e190 {
                        phi_301_ = (_e188 + 1u);
                    } else {
                        phi_301_ = 0u;
                    }
                    let _e194 = phi_301_;
                    let _e195 = select(_e186, _e188, _e190);
                    let _e196 = select(_e181, select(2u, _e181, _e180), _e190);
                    if (_e81 < -126i) {
                        phi_313_ = -126i;
                    } else {
                        phi_313_ = select(_e81, 127i, (_e81 > 127i));
                    }
                    let _e201 = phi_313_;
                    let _e206 = bitcast<f32>((bitcast<u32>((_e201 + 127i)) << bitcast<u32>(23i)));
                    let _e212 = bitcast<f32>((bitcast<u32>(((_e81 - _e201) + 127i)) << bitcast<u32>(23i)));
                    let _e213 = -(_e176);
                    if (_e213 < -126i) {
                        phi_333_ = -126i;
                    } else {
                        phi_333_ = select(_e213, 127i, (_e213 > 127i));
                    }
                    let _e218 = phi_333_;
                    let _e223 = bitcast<f32>((bitcast<u32>((_e218 + 127i)) << bitcast<u32>(23i)));
                    let _e229 = bitcast<f32>((bitcast<u32>(((_e213 - _e218) + 127i)) << bitcast<u32>(23i)));
                    let _e233 = global_4.member[_e77].member;
                    let _e234 = (_e195 == 0u);
                    if _e234 {
                        phi_351_ = _e233[0];
                    } else {
                        phi_351_ = _e233[1];
                    }
                    let _e238 = phi_351_;
                    let _e239 = (_e195 == 2u);
                    if _e239 {
                        phi_357_ = _e233[2];
                    } else {
                        phi_357_ = _e238;
                    }
                    let _e242 = phi_357_;
                    let _e244 = ((_e242 * _e206) * _e212);
                    let _e245 = global_4.member[_e77].member_2;
                    if _e234 {
                        phi_368_ = _e245[0];
                    } else {
                        phi_368_ = _e245[1];
                    }
                    let _e249 = phi_368_;
                    if _e239 {
                        phi_374_ = _e245[2];
                    } else {
                        phi_374_ = _e249;
                    }
                    let _e252 = phi_374_;
                    let _e254 = ((_e252 * _e223) * _e229);
                    let _e258 = (bitcast<f32>((bitcast<u32>(_e254) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e258 {
                        let _e262 = (bitcast<f32>((bitcast<u32>(_e244) & 2147483647u)) * 0.00000011920929f);
                        phi_397_ = select(0.00000000000011368684f, _e262, (_e262 > 0.00000000000011368684f));
                    } else {
                        phi_397_ = 0f;
                    }
                    let _e266 = phi_397_;
                    let _e267 = (_e244 + _e266);
                    let _e268 = (_e244 - _e266);
                    let _e269 = select(_e254, 0f, _e258);
                    if _e258 {
                        phi_408_ = 38685626000000000000000000f;
                    } else {
                        phi_408_ = (1f / _e254);
                    }
                    let _e272 = phi_408_;
                    let _e273 = (_e194 == 0u);
                    if _e273 {
                        phi_417_ = _e233[0];
                    } else {
                        phi_417_ = _e233[1];
                    }
                    let _e277 = phi_417_;
                    let _e278 = (_e194 == 2u);
                    if _e278 {
                        phi_423_ = _e233[2];
                    } else {
                        phi_423_ = _e277;
                    }
                    let _e281 = phi_423_;
                    let _e283 = ((_e281 * _e206) * _e212);
                    if _e273 {
                        phi_434_ = _e245[0];
                    } else {
                        phi_434_ = _e245[1];
                    }
                    let _e287 = phi_434_;
                    if _e278 {
                        phi_440_ = _e245[2];
                    } else {
                        phi_440_ = _e287;
                    }
                    let _e290 = phi_440_;
                    let _e292 = ((_e290 * _e223) * _e229);
                    let _e296 = (bitcast<f32>((bitcast<u32>(_e292) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e296 {
                        let _e300 = (bitcast<f32>((bitcast<u32>(_e283) & 2147483647u)) * 0.00000011920929f);
                        phi_463_ = select(0.00000000000011368684f, _e300, (_e300 > 0.00000000000011368684f));
                    } else {
                        phi_463_ = 0f;
                    }
                    let _e304 = phi_463_;
                    let _e305 = (_e283 + _e304);
                    let _e306 = (_e283 - _e304);
                    let _e307 = select(_e292, 0f, _e296);
                    if _e296 {
                        phi_474_ = 38685626000000000000000000f;
                    } else {
                        phi_474_ = (1f / _e292);
                    }
                    let _e310 = phi_474_;
                    let _e311 = (_e196 == 0u);
                    if _e311 {
                        phi_483_ = _e233[0];
                    } else {
                        phi_483_ = _e233[1];
                    }
                    let _e315 = phi_483_;
                    let _e316 = (_e196 == 2u);
                    if _e316 {
                        phi_489_ = _e233[2];
                    } else {
                        phi_489_ = _e315;
                    }
                    let _e319 = phi_489_;
                    let _e321 = ((_e319 * _e206) * _e212);
                    if _e311 {
                        phi_500_ = _e245[0];
                    } else {
                        phi_500_ = _e245[1];
                    }
                    let _e325 = phi_500_;
                    if _e316 {
                        phi_506_ = _e245[2];
                    } else {
                        phi_506_ = _e325;
                    }
                    let _e328 = phi_506_;
                    let _e330 = ((_e328 * _e223) * _e229);
                    let _e334 = (bitcast<f32>((bitcast<u32>(_e330) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e334 {
                        let _e338 = (bitcast<f32>((bitcast<u32>(_e321) & 2147483647u)) * 0.00000011920929f);
                        phi_529_ = select(0.00000000000011368684f, _e338, (_e338 > 0.00000000000011368684f));
                    } else {
                        phi_529_ = 0f;
                    }
                    let _e342 = phi_529_;
                    let _e343 = (_e321 + _e342);
                    let _e344 = (_e321 - _e342);
                    let _e345 = select(_e330, 0f, _e334);
                    if _e334 {
                        phi_540_ = 38685626000000000000000000f;
                    } else {
                        phi_540_ = (1f / _e330);
                    }
                    let _e348 = phi_540_;
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
                        phi_640_ = select(-340282350000000000000000000000000000000f, _e389, (_e389 > -340282350000000000000000000000000000000f));
                        phi_641_ = select(-340282350000000000000000000000000000000f, _e382, (_e382 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_640_ = 0f;
                        phi_641_ = 1f;
                    }
                    let _e393 = phi_640_;
                    let _e395 = phi_641_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2212_ = false;
                    phi_652_ = type_46(_e393, false);
                    phi_655_ = select(0u, 2147483648u, (_e67 == 0u));
                    phi_657_ = ((3u * _e67) + 1u);
                    phi_659_ = (_e395 <= _e393);
                    phi_661_ = 0u;
                    loop {
                        let _e403 = phi_2212_;
                        let _e405 = phi_652_;
                        let _e407 = phi_655_;
                        let _e409 = phi_657_;
                        let _e411 = phi_659_;
                        let _e413 = phi_661_;
                        local_3 = _e405;
                        if _e411 {
                            phi_672_ = true;
                        } else {
                            phi_672_ = (_e413 > 0u);
                        }
                        let _e416 = phi_672_;
                        if _e416 {
                            let _e417 = (_e409 > 0u);
                            if _e417 {
                                if _e411 {
                                    phi_704_ = _e407;
                                    phi_705_ = _e411;
                                    phi_706_ = _e413;
                                } else {
                                    let _e418 = (_e413 - 1u);
                                    let _e419 = (_e418 % 128u);
                                    let _e420 = (_e419 < 128u);
                                    if _e420 {
                                    } else {
                                        phi_2345_ = true;
                                        break;
                                    }
                                    let _e422 = local_1[_e419];
                                    if _e420 {
                                    } else {
                                        phi_2345_ = true;
                                        break;
                                    }
                                    let _e424 = local[_e419];
                                    phi_704_ = _e422;
                                    phi_705_ = (_e424 <= _e405.member);
                                    phi_706_ = _e418;
                                }
                                let _e428 = phi_704_;
                                let _e430 = phi_705_;
                                let _e432 = phi_706_;
                                if _e430 {
                                    if ((_e428 & 2147483648u) != 0u) {
                                        phi_721_ = _e405;
                                        phi_724_ = type_7(0u, ((_e428 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e630 = phi_721_;
                                            let _e632 = phi_724_;
                                            local_2 = _e630;
                                            local_4 = _e630;
                                            if (_e632.member < _e632.member_1) {
                                                phi_725_ = type_7((_e632.member + 1u), _e632.member_1);
                                                phi_747_ = type_7(1u, _e632.member);
                                            } else {
                                                phi_725_ = _e632;
                                                phi_747_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e645 = phi_725_;
                                            let _e647 = phi_747_;
                                            let _e651 = (bitcast<i32>(_e647.member) != 0i);
                                            if _e651 {
                                                let _e652 = ((_e428 & 268435455u) + _e647.member_1);
                                                let _e653 = (_e652 < _e69);
                                                if _e653 {
                                                    if _e653 {
                                                    } else {
                                                        phi_2206_ = true;
                                                        break;
                                                    }
                                                    let _e657 = global_3.member[_e652].member_1;
                                                    phi_768_ = _e657;
                                                } else {
                                                    phi_768_ = 4294967295u;
                                                }
                                                let _e659 = phi_768_;
                                                if (_e652 >= _e69) {
                                                    phi_857_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e653 {
                                                    } else {
                                                        phi_2206_ = true;
                                                        break;
                                                    }
                                                    let _e661 = (_e195 % 3u);
                                                    let _e662 = (_e194 % 3u);
                                                    let _e663 = (_e196 % 3u);
                                                    if (_e661 < 9u) {
                                                    } else {
                                                        phi_2206_ = true;
                                                        break;
                                                    }
                                                    let _e669 = global_3.member[_e652].member[_e661];
                                                    if (_e662 < 9u) {
                                                    } else {
                                                        phi_2206_ = true;
                                                        break;
                                                    }
                                                    let _e675 = global_3.member[_e652].member[_e662];
                                                    if (_e663 < 9u) {
                                                    } else {
                                                        phi_2206_ = true;
                                                        break;
                                                    }
                                                    let _e681 = global_3.member[_e652].member[_e663];
                                                    let _e683 = (3u + _e661);
                                                    if (_e683 < 9u) {
                                                    } else {
                                                        phi_2206_ = true;
                                                        break;
                                                    }
                                                    let _e689 = global_3.member[_e652].member[_e683];
                                                    let _e690 = (3u + _e662);
                                                    if (_e690 < 9u) {
                                                    } else {
                                                        phi_2206_ = true;
                                                        break;
                                                    }
                                                    let _e696 = global_3.member[_e652].member[_e690];
                                                    let _e697 = (3u + _e663);
                                                    if (_e697 < 9u) {
                                                    } else {
                                                        phi_2206_ = true;
                                                        break;
                                                    }
                                                    let _e703 = global_3.member[_e652].member[_e697];
                                                    let _e705 = (6u + _e661);
                                                    if (_e705 < 9u) {
                                                    } else {
                                                        phi_2206_ = true;
                                                        break;
                                                    }
                                                    let _e711 = global_3.member[_e652].member[_e705];
                                                    let _e712 = (6u + _e662);
                                                    if (_e712 < 9u) {
                                                    } else {
                                                        phi_2206_ = true;
                                                        break;
                                                    }
                                                    let _e718 = global_3.member[_e652].member[_e712];
                                                    let _e719 = (6u + _e663);
                                                    if (_e719 < 9u) {
                                                    } else {
                                                        phi_2206_ = true;
                                                        break;
                                                    }
                                                    let _e725 = global_3.member[_e652].member[_e719];
                                                    phi_857_ = array<array<f32, 3>, 3>(array<f32, 3>(_e669, _e675, _e681), array<f32, 3>(_e689, _e696, _e703), array<f32, 3>(_e711, _e718, _e725));
                                                }
                                                let _e729 = phi_857_;
                                                let _e737 = (_e729[0][2] - _e321);
                                                let _e740 = (((_e729[0][0] - _e244) * _e345) - (_e737 * _e269));
                                                let _e743 = (((_e729[0][1] - _e283) * _e345) - (_e737 * _e307));
                                                let _e750 = (_e729[1][2] - _e321);
                                                let _e753 = (((_e729[1][0] - _e244) * _e345) - (_e750 * _e269));
                                                let _e756 = (((_e729[1][1] - _e283) * _e345) - (_e750 * _e307));
                                                let _e763 = (_e729[2][2] - _e321);
                                                let _e766 = (((_e729[2][0] - _e244) * _e345) - (_e763 * _e269));
                                                let _e769 = (((_e729[2][1] - _e283) * _e345) - (_e763 * _e307));
                                                let _e770 = (_e766 * _e756);
                                                let _e771 = (_e769 * _e753);
                                                let _e772 = (_e740 * _e769);
                                                let _e773 = (_e743 * _e766);
                                                let _e774 = (_e753 * _e743);
                                                let _e775 = (_e756 * _e740);
                                                let _e780 = (((_e770 >= _e771) && (_e772 >= _e773)) && (_e774 >= _e775));
                                                if (_e780 || (((_e770 <= _e771) && (_e772 <= _e773)) && (_e774 <= _e775))) {
                                                    let _e787 = select(-1f, 1f, _e780);
                                                    let _e789 = ((_e770 - _e771) * _e787);
                                                    let _e791 = select(0f, _e789, (_e789 > 0f));
                                                    let _e793 = ((_e772 - _e773) * _e787);
                                                    let _e795 = select(0f, _e793, (_e793 > 0f));
                                                    let _e797 = ((_e774 - _e775) * _e787);
                                                    let _e799 = select(0f, _e797, (_e797 > 0f));
                                                    let _e801 = ((_e791 + _e795) + _e799);
                                                    if (_e801 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1682_ = type_26();
                                                        phi_1683_ = true;
                                                        phi_1684_ = false;
                                                    } else {
                                                        let _e804 = select(_e753, _e740, (_e740 < _e753));
                                                        if (select(_e766, _e804, (_e804 < _e766)) > 0f) {
                                                            phi_974_ = true;
                                                        } else {
                                                            let _e809 = select(_e753, _e740, (_e740 > _e753));
                                                            phi_974_ = (select(_e766, _e809, (_e809 > _e766)) < 0f);
                                                        }
                                                        let _e814 = phi_974_;
                                                        if _e814 {
                                                            phi_1679_ = type_26();
                                                            phi_1680_ = true;
                                                            phi_1681_ = false;
                                                        } else {
                                                            let _e816 = select(_e756, _e743, (_e743 < _e756));
                                                            if (select(_e769, _e816, (_e816 < _e769)) > 0f) {
                                                                phi_1003_ = true;
                                                            } else {
                                                                let _e821 = select(_e756, _e743, (_e743 > _e756));
                                                                phi_1003_ = (select(_e769, _e821, (_e821 > _e769)) < 0f);
                                                            }
                                                            let _e826 = phi_1003_;
                                                            if _e826 {
                                                                phi_1677_ = type_26();
                                                                phi_1678_ = false;
                                                            } else {
                                                                let _e828 = select(_e729[1][0], _e729[0][0], (_e729[0][0] < _e729[1][0]));
                                                                let _e832 = select(_e729[1][0], _e729[0][0], (_e729[0][0] > _e729[1][0]));
                                                                let _e836 = select(_e729[1][1], _e729[0][1], (_e729[0][1] < _e729[1][1]));
                                                                let _e840 = select(_e729[1][1], _e729[0][1], (_e729[0][1] > _e729[1][1]));
                                                                let _e844 = select(_e729[1][2], _e729[0][2], (_e729[0][2] < _e729[1][2]));
                                                                let _e848 = select(_e729[1][2], _e729[0][2], (_e729[0][2] > _e729[1][2]));
                                                                let _e853 = ((select(_e729[2][0], _e828, (_e828 < _e729[2][0])) - _e267) * _e272);
                                                                let _e854 = ((select(_e729[2][0], _e832, (_e832 > _e729[2][0])) - _e268) * _e272);
                                                                let _e857 = ((select(_e729[2][1], _e836, (_e836 < _e729[2][1])) - _e305) * _e310);
                                                                let _e858 = ((select(_e729[2][1], _e840, (_e840 > _e729[2][1])) - _e306) * _e310);
                                                                let _e861 = ((select(_e729[2][2], _e844, (_e844 < _e729[2][2])) - _e343) * _e348);
                                                                let _e862 = ((select(_e729[2][2], _e848, (_e848 > _e729[2][2])) - _e344) * _e348);
                                                                let _e864 = select(_e862, _e861, (_e861 < _e862));
                                                                let _e866 = select(_e862, _e861, (_e861 > _e862));
                                                                let _e868 = select(_e854, _e853, (_e853 < _e854));
                                                                let _e870 = select(_e858, _e857, (_e857 < _e858));
                                                                let _e872 = select(_e870, _e868, (_e868 > _e870));
                                                                let _e874 = select(_e864, _e872, (_e872 > _e864));
                                                                let _e876 = select(_e854, _e853, (_e853 > _e854));
                                                                let _e878 = select(_e858, _e857, (_e857 > _e858));
                                                                let _e880 = select(_e878, _e876, (_e876 < _e878));
                                                                let _e882 = select(_e866, _e880, (_e880 < _e866));
                                                                let _e883 = -(_e864);
                                                                let _e889 = select(_e395, _e874, (_e874 > _e395));
                                                                if (_e889 > (_e882 + (select(_e883, _e866, (_e866 > _e883)) * 0.0000019073523f))) {
                                                                    phi_1672_ = type_26();
                                                                    phi_1673_ = true;
                                                                } else {
                                                                    let _e891 = (_e889 > _e630.member);
                                                                    if _e891 {
                                                                        phi_1671_ = type_26();
                                                                    } else {
                                                                        let _e892 = vec3<f32>(_e729[0][0], _e729[0][1], _e729[0][2]);
                                                                        let _e893 = vec3<f32>(_e729[1][0], _e729[1][1], _e729[1][2]);
                                                                        let _e894 = vec3<f32>(_e729[2][0], _e729[2][1], _e729[2][2]);
                                                                        let _e895 = (_e729[1][0] - _e729[0][0]);
                                                                        let _e896 = (_e729[1][1] - _e729[0][1]);
                                                                        let _e897 = (_e729[1][2] - _e729[0][2]);
                                                                        let _e898 = vec3<f32>(_e895, _e896, _e897);
                                                                        let _e899 = (_e729[2][0] - _e729[1][0]);
                                                                        let _e900 = (_e729[2][1] - _e729[1][1]);
                                                                        let _e901 = (_e729[2][2] - _e729[1][2]);
                                                                        let _e902 = vec3<f32>(_e899, _e900, _e901);
                                                                        let _e903 = (_e729[0][0] - _e729[2][0]);
                                                                        let _e904 = (_e729[0][1] - _e729[2][1]);
                                                                        let _e905 = (_e729[0][2] - _e729[2][2]);
                                                                        let _e906 = vec3<f32>(_e903, _e904, _e905);
                                                                        let _e909 = bitcast<f32>((bitcast<u32>(_e895) & 2147483647u));
                                                                        let _e912 = bitcast<f32>((bitcast<u32>(_e896) & 2147483647u));
                                                                        let _e914 = select(_e912, _e909, (_e909 > _e912));
                                                                        let _e917 = bitcast<f32>((bitcast<u32>(_e897) & 2147483647u));
                                                                        let _e919 = select(_e917, _e914, (_e914 > _e917));
                                                                        let _e922 = bitcast<f32>((bitcast<u32>(_e899) & 2147483647u));
                                                                        let _e925 = bitcast<f32>((bitcast<u32>(_e900) & 2147483647u));
                                                                        let _e927 = select(_e925, _e922, (_e922 > _e925));
                                                                        let _e930 = bitcast<f32>((bitcast<u32>(_e901) & 2147483647u));
                                                                        let _e932 = select(_e930, _e927, (_e927 > _e930));
                                                                        let _e935 = bitcast<f32>((bitcast<u32>(_e903) & 2147483647u));
                                                                        let _e938 = bitcast<f32>((bitcast<u32>(_e904) & 2147483647u));
                                                                        let _e940 = select(_e938, _e935, (_e935 > _e938));
                                                                        let _e943 = bitcast<f32>((bitcast<u32>(_e905) & 2147483647u));
                                                                        let _e945 = select(_e943, _e940, (_e940 > _e943));
                                                                        let _e947 = select(_e932, _e919, (_e919 > _e932));
                                                                        let _e949 = select(_e945, _e947, (_e947 > _e945));
                                                                        if (_e919 == _e949) {
                                                                            phi_1404_ = _e756;
                                                                            phi_1405_ = _e753;
                                                                            phi_1406_ = _e743;
                                                                            phi_1407_ = _e740;
                                                                            phi_1408_ = _e892;
                                                                            phi_1409_ = _e906;
                                                                            phi_1410_ = _e902;
                                                                            phi_1411_ = _e898;
                                                                        } else {
                                                                            let _e951 = (_e932 == _e949);
                                                                            let _e956 = vec3(_e951);
                                                                            phi_1404_ = select(_e743, _e769, _e951);
                                                                            phi_1405_ = select(_e740, _e766, _e951);
                                                                            phi_1406_ = select(_e769, _e756, _e951);
                                                                            phi_1407_ = select(_e766, _e753, _e951);
                                                                            phi_1408_ = select(_e894, _e893, _e956);
                                                                            phi_1409_ = select(_e902, _e898, _e956);
                                                                            phi_1410_ = select(_e898, _e906, _e956);
                                                                            phi_1411_ = select(_e906, _e902, _e956);
                                                                        }
                                                                        let _e962 = phi_1404_;
                                                                        let _e964 = phi_1405_;
                                                                        let _e966 = phi_1406_;
                                                                        let _e968 = phi_1407_;
                                                                        let _e970 = phi_1408_;
                                                                        let _e972 = phi_1409_;
                                                                        let _e974 = phi_1410_;
                                                                        let _e976 = phi_1411_;
                                                                        let _e983 = ((_e974.y * _e972.z) - (_e972.y * _e974.z));
                                                                        let _e988 = ((_e974.z * _e972.x) - (_e972.z * _e974.x));
                                                                        let _e991 = ((_e974.x * _e972.y) - (_e972.x * _e974.y));
                                                                        if (_e791 >= _e795) {
                                                                            phi_1442_ = select(true, false, (_e791 >= _e799));
                                                                        } else {
                                                                            phi_1442_ = true;
                                                                        }
                                                                        let _e996 = phi_1442_;
                                                                        if _e996 {
                                                                            phi_1451_ = select(_e894, _e893, vec3((_e795 >= _e799)));
                                                                        } else {
                                                                            phi_1451_ = _e892;
                                                                        }
                                                                        let _e1001 = phi_1451_;
                                                                        let _e1012 = (((_e983 * (_e1001.x - _e244)) + (_e988 * (_e1001.y - _e283))) + (_e991 * (_e1001.z - _e321)));
                                                                        let _e1017 = (((_e983 * _e269) + (_e988 * _e307)) + (_e991 * _e345));
                                                                        let _e1018 = (_e964 - _e968);
                                                                        let _e1019 = (_e962 - _e966);
                                                                        let _e1027 = (-(((_e968 * _e1018) + (_e966 * _e1019))) / ((_e1018 * _e1018) + (_e1019 * _e1019)));
                                                                        let _e1029 = select(1f, _e1027, (_e1027 < 1f));
                                                                        let _e1031 = select(0f, _e1029, (_e1029 > 0f));
                                                                        let _e1044 = ((_e970.x + (_e976.x * _e1031)) - _e244);
                                                                        let _e1045 = ((_e970.y + (_e976.y * _e1031)) - _e283);
                                                                        let _e1046 = ((_e970.z + (_e976.z * _e1031)) - _e321);
                                                                        let _e1047 = (_e1046 / _e345);
                                                                        let _e1059 = bitcast<f32>((bitcast<u32>(_e1044) & 2147483647u));
                                                                        let _e1062 = bitcast<f32>((bitcast<u32>(_e1045) & 2147483647u));
                                                                        let _e1064 = select(_e1062, _e1059, (_e1059 > _e1062));
                                                                        let _e1067 = bitcast<f32>((bitcast<u32>(_e1046) & 2147483647u));
                                                                        let _e1069 = select(_e1067, _e1064, (_e1064 > _e1067));
                                                                        let _e1075 = bitcast<f32>((bitcast<u32>(_e983) & 2147483647u));
                                                                        let _e1078 = bitcast<f32>((bitcast<u32>(_e988) & 2147483647u));
                                                                        let _e1080 = select(_e1078, _e1075, (_e1075 > _e1078));
                                                                        let _e1083 = bitcast<f32>((bitcast<u32>(_e991) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e983 * _e1044) + (_e988 * _e1045)) + (_e991 * _e1046)) - _e1012)) & 2147483647u)) <= ((0.0000009536743f * select(_e949, _e1069, (_e1069 > _e949))) * select(_e1083, _e1080, (_e1080 > _e1083)))) {
                                                                            let _e1093 = bitcast<f32>((bitcast<u32>(_e974.x) & 2147483647u));
                                                                            let _e1096 = bitcast<f32>((bitcast<u32>(_e974.y) & 2147483647u));
                                                                            let _e1098 = select(_e1096, _e1093, (_e1093 > _e1096));
                                                                            let _e1101 = bitcast<f32>((bitcast<u32>(_e974.z) & 2147483647u));
                                                                            let _e1107 = bitcast<f32>((bitcast<u32>(_e972.x) & 2147483647u));
                                                                            let _e1110 = bitcast<f32>((bitcast<u32>(_e972.y) & 2147483647u));
                                                                            let _e1112 = select(_e1110, _e1107, (_e1107 > _e1110));
                                                                            let _e1115 = bitcast<f32>((bitcast<u32>(_e972.z) & 2147483647u));
                                                                            let _e1119 = (bitcast<f32>((bitcast<u32>(_e1017) & 2147483647u)) > ((0.0000038146973f * select(_e1101, _e1098, (_e1098 > _e1101))) * select(_e1115, _e1112, (_e1112 > _e1115))));
                                                                            if _e1119 {
                                                                                phi_1616_ = (_e1012 / _e1017);
                                                                            } else {
                                                                                phi_1616_ = f32();
                                                                            }
                                                                            let _e1122 = phi_1616_;
                                                                            phi_1618_ = _e1122;
                                                                            phi_1619_ = select(true, false, _e1119);
                                                                        } else {
                                                                            phi_1618_ = f32();
                                                                            phi_1619_ = true;
                                                                        }
                                                                        let _e1125 = phi_1618_;
                                                                        let _e1127 = phi_1619_;
                                                                        if _e1127 {
                                                                            let _e1135 = (((_e983 * (_e1044 - (_e269 * _e1047))) + (_e988 * (_e1045 - (_e307 * _e1047)))) / _e1017);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1135) & 2147483647u)) <= _e949) {
                                                                                phi_1639_ = (_e1047 + _e1135);
                                                                            } else {
                                                                                phi_1639_ = _e1047;
                                                                            }
                                                                            let _e1142 = phi_1639_;
                                                                            phi_1640_ = _e1142;
                                                                        } else {
                                                                            phi_1640_ = _e1125;
                                                                        }
                                                                        let _e1144 = phi_1640_;
                                                                        let _e1146 = select(_e882, _e1144, (_e1144 < _e882));
                                                                        let _e1148 = select(_e874, _e1146, (_e1146 > _e874));
                                                                        if (_e1148 >= _e395) {
                                                                            let _e1150 = (_e1148 <= _e630.member);
                                                                            if _e1150 {
                                                                                let _e1151 = (1f / _e801);
                                                                                phi_1663_ = type_26(_e1148, (_e795 * _e1151), (_e799 * _e1151), _e659);
                                                                            } else {
                                                                                phi_1663_ = type_26();
                                                                            }
                                                                            let _e1156 = phi_1663_;
                                                                            phi_1665_ = _e1156;
                                                                            phi_1666_ = select(true, false, _e1150);
                                                                        } else {
                                                                            phi_1665_ = type_26();
                                                                            phi_1666_ = true;
                                                                        }
                                                                        let _e1159 = phi_1665_;
                                                                        let _e1161 = phi_1666_;
                                                                        if _e1161 {
                                                                            phi_1670_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1670_ = _e1159;
                                                                        }
                                                                        let _e1163 = phi_1670_;
                                                                        phi_1671_ = _e1163;
                                                                    }
                                                                    let _e1165 = phi_1671_;
                                                                    phi_1672_ = _e1165;
                                                                    phi_1673_ = _e891;
                                                                }
                                                                let _e1167 = phi_1672_;
                                                                let _e1169 = phi_1673_;
                                                                phi_1677_ = _e1167;
                                                                phi_1678_ = _e1169;
                                                            }
                                                            let _e1171 = phi_1677_;
                                                            let _e1173 = phi_1678_;
                                                            phi_1679_ = _e1171;
                                                            phi_1680_ = _e826;
                                                            phi_1681_ = _e1173;
                                                        }
                                                        let _e1175 = phi_1679_;
                                                        let _e1177 = phi_1680_;
                                                        let _e1179 = phi_1681_;
                                                        phi_1682_ = _e1175;
                                                        phi_1683_ = _e1177;
                                                        phi_1684_ = _e1179;
                                                    }
                                                    let _e1181 = phi_1682_;
                                                    let _e1183 = phi_1683_;
                                                    let _e1185 = phi_1684_;
                                                    phi_1692_ = _e1181;
                                                    phi_1693_ = select(_e1185, true, _e1183);
                                                } else {
                                                    phi_1692_ = type_26();
                                                    phi_1693_ = true;
                                                }
                                                let _e1188 = phi_1692_;
                                                let _e1190 = phi_1693_;
                                                if _e1190 {
                                                    phi_1697_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1697_ = _e1188;
                                                }
                                                let _e1192 = phi_1697_;
                                                if (_e1192.member_3 != 4294967295u) {
                                                    if (_e659 != 4294967295u) {
                                                        phi_1708_ = type_46(_e630.member, true);
                                                    } else {
                                                        phi_1708_ = _e630;
                                                    }
                                                    let _e1200 = phi_1708_;
                                                    phi_1709_ = _e1200;
                                                } else {
                                                    phi_1709_ = _e630;
                                                }
                                                let _e1202 = phi_1709_;
                                                phi_722_ = _e1202;
                                            } else {
                                                phi_722_ = type_46();
                                            }
                                            let _e1204 = phi_722_;
                                            continue;
                                            continuing {
                                                phi_721_ = _e1204;
                                                phi_724_ = _e645;
                                                phi_2206_ = _e403;
                                                break if !(_e651);
                                            }
                                        }
                                        let _e1207 = phi_2206_;
                                        phi_2345_ = _e1207;
                                        if _e1207 {
                                            break;
                                        }
                                        let _e1209 = local_2;
                                        phi_2349_ = _e1207;
                                        let _e1368 = local_4;
                                        phi_2165_ = _e1368;
                                        phi_2166_ = _e428;
                                        phi_2167_ = false;
                                        phi_2168_ = select(_e432, 0u, _e1209.member_1);
                                    } else {
                                        if (_e428 >= _e67) {
                                            phi_1770_ = type_42(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e428 < _e67) {
                                            } else {
                                                phi_2345_ = true;
                                                break;
                                            }
                                            let _e442 = (_e195 % 3u);
                                            if (_e442 < 3u) {
                                            } else {
                                                phi_2345_ = true;
                                                break;
                                            }
                                            let _e448 = global_2.member[_e428].member[_e442];
                                            let _e454 = (_e194 % 3u);
                                            if (_e454 < 3u) {
                                            } else {
                                                phi_2345_ = true;
                                                break;
                                            }
                                            let _e460 = global_2.member[_e428].member[_e454];
                                            let _e466 = (_e196 % 3u);
                                            if (_e466 < 3u) {
                                            } else {
                                                phi_2345_ = true;
                                                break;
                                            }
                                            let _e472 = global_2.member[_e428].member[_e466];
                                            let _e482 = global_2.member[_e428].member_1;
                                            let _e486 = global_2.member[_e428].member_2;
                                            phi_1770_ = type_42(array<vec4<f32>, 3>(vec4<f32>(_e448[0], _e448[1], _e448[2], _e448[3]), vec4<f32>(_e460[0], _e460[1], _e460[2], _e460[3]), vec4<f32>(_e472[0], _e472[1], _e472[2], _e472[3])), _e482, _e486);
                                        }
                                        let _e489 = phi_1770_;
                                        let _e501 = ((_e489.member[0].x - _e267) * _e272);
                                        let _e502 = ((_e489.member[0].y - _e267) * _e272);
                                        let _e503 = ((_e489.member[0].z - _e268) * _e272);
                                        let _e504 = ((_e489.member[0].w - _e268) * _e272);
                                        let _e514 = ((_e489.member[1].x - _e305) * _e310);
                                        let _e515 = ((_e489.member[1].y - _e305) * _e310);
                                        let _e516 = ((_e489.member[1].z - _e306) * _e310);
                                        let _e517 = ((_e489.member[1].w - _e306) * _e310);
                                        let _e527 = ((_e489.member[2].x - _e343) * _e348);
                                        let _e528 = ((_e489.member[2].y - _e343) * _e348);
                                        let _e529 = ((_e489.member[2].z - _e344) * _e348);
                                        let _e530 = ((_e489.member[2].w - _e344) * _e348);
                                        let _e532 = select(_e529, _e527, (_e527 < _e529));
                                        let _e534 = select(_e530, _e528, (_e528 < _e530));
                                        let _e536 = select(_e529, _e527, (_e527 > _e529));
                                        let _e538 = select(_e530, _e528, (_e528 > _e530));
                                        let _e540 = select(_e503, _e501, (_e501 < _e503));
                                        let _e542 = select(_e504, _e502, (_e502 < _e504));
                                        let _e544 = select(_e516, _e514, (_e514 < _e516));
                                        let _e546 = select(_e517, _e515, (_e515 < _e517));
                                        let _e548 = select(_e544, _e540, (_e540 > _e544));
                                        let _e550 = select(_e546, _e542, (_e542 > _e546));
                                        let _e552 = select(_e532, _e548, (_e548 > _e532));
                                        let _e554 = select(_e534, _e550, (_e550 > _e534));
                                        let _e556 = select(_e503, _e501, (_e501 > _e503));
                                        let _e558 = select(_e504, _e502, (_e502 > _e504));
                                        let _e560 = select(_e516, _e514, (_e514 > _e516));
                                        let _e562 = select(_e517, _e515, (_e515 > _e517));
                                        let _e564 = select(_e560, _e556, (_e556 < _e560));
                                        let _e566 = select(_e562, _e558, (_e558 < _e562));
                                        let _e571 = -(_e532);
                                        let _e572 = -(_e534);
                                        let _e579 = (select(_e536, _e564, (_e564 < _e536)) + (select(_e571, _e536, (_e536 > _e571)) * 0.0000019073523f));
                                        let _e580 = (select(_e538, _e566, (_e566 < _e538)) + (select(_e572, _e538, (_e538 > _e572)) * 0.0000019073523f));
                                        let _e582 = select(_e395, _e552, (_e552 > _e395));
                                        let _e584 = select(_e395, _e554, (_e554 > _e395));
                                        let _e589 = (_e582 <= select(_e405.member, _e579, (_e579 < _e405.member)));
                                        let _e590 = (_e584 <= select(_e405.member, _e580, (_e580 < _e405.member)));
                                        let _e591 = (_e582 <= _e584);
                                        if _e589 {
                                            if _e590 {
                                                if _e591 {
                                                    phi_2114_ = _e489.member_2;
                                                } else {
                                                    phi_2114_ = _e489.member_1;
                                                }
                                                let _e595 = phi_2114_;
                                                let _e598 = (_e432 % 128u);
                                                let _e599 = (_e598 < 128u);
                                                if _e599 {
                                                } else {
                                                    phi_2345_ = true;
                                                    break;
                                                }
                                                local_1[_e598] = _e595;
                                                if _e599 {
                                                } else {
                                                    phi_2345_ = true;
                                                    break;
                                                }
                                                local[_e598] = select(_e584, _e582, (_e582 > _e584));
                                                if _e591 {
                                                    phi_2142_ = _e489.member_1;
                                                } else {
                                                    phi_2142_ = _e489.member_2;
                                                }
                                                let _e606 = phi_2142_;
                                                phi_2143_ = _e606;
                                                phi_2144_ = (_e432 + 1u);
                                            } else {
                                                phi_2143_ = u32();
                                                phi_2144_ = u32();
                                            }
                                            let _e608 = phi_2143_;
                                            let _e610 = phi_2144_;
                                            phi_2146_ = _e608;
                                            phi_2147_ = _e610;
                                            phi_2148_ = select(true, false, _e590);
                                        } else {
                                            phi_2146_ = u32();
                                            phi_2147_ = u32();
                                            phi_2148_ = true;
                                        }
                                        let _e613 = phi_2146_;
                                        let _e615 = phi_2147_;
                                        let _e617 = phi_2148_;
                                        if _e617 {
                                            if _e589 {
                                                phi_2157_ = _e489.member_1;
                                            } else {
                                                phi_2157_ = _e489.member_2;
                                            }
                                            let _e621 = phi_2157_;
                                            phi_2162_ = _e621;
                                            phi_2163_ = select(_e590, true, _e589);
                                        } else {
                                            phi_2162_ = _e613;
                                            phi_2163_ = _e430;
                                        }
                                        let _e624 = phi_2162_;
                                        let _e626 = phi_2163_;
                                        phi_2349_ = _e403;
                                        phi_2165_ = _e405;
                                        phi_2166_ = _e624;
                                        phi_2167_ = _e626;
                                        phi_2168_ = select(_e615, _e432, _e617);
                                    }
                                    let _e1213 = phi_2349_;
                                    let _e1215 = phi_2165_;
                                    let _e1217 = phi_2166_;
                                    let _e1219 = phi_2167_;
                                    let _e1221 = phi_2168_;
                                    phi_2348_ = _e1213;
                                    phi_2169_ = _e1215;
                                    phi_2170_ = _e1217;
                                    phi_2171_ = (_e409 - 1u);
                                    phi_2172_ = _e1219;
                                    phi_2173_ = _e1221;
                                } else {
                                    phi_2348_ = _e403;
                                    phi_2169_ = _e405;
                                    phi_2170_ = _e428;
                                    phi_2171_ = _e409;
                                    phi_2172_ = _e430;
                                    phi_2173_ = _e432;
                                }
                                let _e1223 = phi_2348_;
                                let _e1225 = phi_2169_;
                                let _e1227 = phi_2170_;
                                let _e1229 = phi_2171_;
                                let _e1231 = phi_2172_;
                                let _e1233 = phi_2173_;
                                phi_2347_ = _e1223;
                                phi_2174_ = _e1225;
                                phi_2175_ = _e1227;
                                phi_2176_ = _e1229;
                                phi_2177_ = _e1231;
                                phi_2178_ = _e1233;
                            } else {
                                phi_2347_ = _e403;
                                phi_2174_ = type_46();
                                phi_2175_ = u32();
                                phi_2176_ = u32();
                                phi_2177_ = bool();
                                phi_2178_ = u32();
                            }
                            let _e1235 = phi_2347_;
                            let _e1237 = phi_2174_;
                            let _e1239 = phi_2175_;
                            let _e1241 = phi_2176_;
                            let _e1243 = phi_2177_;
                            let _e1245 = phi_2178_;
                            phi_2346_ = _e1235;
                            phi_653_ = _e1237;
                            phi_656_ = _e1239;
                            phi_658_ = _e1241;
                            phi_660_ = _e1243;
                            phi_662_ = _e1245;
                            phi_2179_ = _e417;
                        } else {
                            phi_2346_ = _e403;
                            phi_653_ = type_46();
                            phi_656_ = u32();
                            phi_658_ = u32();
                            phi_660_ = bool();
                            phi_662_ = u32();
                            phi_2179_ = false;
                        }
                        let _e1247 = phi_2346_;
                        let _e1249 = phi_653_;
                        let _e1251 = phi_656_;
                        let _e1253 = phi_658_;
                        let _e1255 = phi_660_;
                        let _e1257 = phi_662_;
                        let _e1259 = phi_2179_;
                        continue;
                        continuing {
                            phi_2212_ = _e1247;
                            phi_652_ = _e1249;
                            phi_655_ = _e1251;
                            phi_657_ = _e1253;
                            phi_659_ = _e1255;
                            phi_661_ = _e1257;
                            phi_2345_ = _e1247;
                            break if !(_e1259);
                        }
                    }
                    let _e1262 = phi_2345_;
                    if _e1262 {
                        break;
                    }
                    let _e1264 = local_3;
                    if _e83 {
                    } else {
                        break;
                    }
                    global_5.member[_e77] = select(0u, 1u, _e1264.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
