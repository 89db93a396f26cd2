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
    var phi_271_: i32;
    var phi_272_: i32;
    var phi_282_: bool;
    var phi_292_: u32;
    var phi_293_: u32;
    var phi_295_: bool;
    var phi_300_: u32;
    var phi_312_: i32;
    var phi_332_: i32;
    var phi_350_: f32;
    var phi_356_: f32;
    var phi_367_: f32;
    var phi_373_: f32;
    var phi_396_: f32;
    var phi_407_: f32;
    var phi_416_: f32;
    var phi_422_: f32;
    var phi_433_: f32;
    var phi_439_: f32;
    var phi_462_: f32;
    var phi_473_: f32;
    var phi_482_: f32;
    var phi_488_: f32;
    var phi_499_: f32;
    var phi_505_: f32;
    var phi_528_: f32;
    var phi_539_: f32;
    var phi_639_: f32;
    var phi_640_: f32;
    var phi_2214_: bool;
    var phi_651_: type_46;
    var phi_654_: u32;
    var phi_656_: u32;
    var phi_658_: bool;
    var phi_660_: u32;
    var phi_671_: bool;
    var phi_703_: u32;
    var phi_704_: bool;
    var phi_705_: u32;
    var phi_1772_: type_42;
    var phi_2116_: u32;
    var phi_2144_: u32;
    var phi_2145_: u32;
    var phi_2146_: u32;
    var phi_2148_: u32;
    var phi_2149_: u32;
    var phi_2150_: bool;
    var phi_2159_: u32;
    var phi_2164_: u32;
    var phi_2165_: bool;
    var phi_720_: type_46;
    var phi_723_: type_7;
    var phi_724_: type_7;
    var phi_746_: type_7;
    var phi_767_: u32;
    var phi_856_: array<array<f32, 3>, 3>;
    var phi_973_: bool;
    var phi_1002_: bool;
    var phi_1403_: f32;
    var phi_1404_: f32;
    var phi_1405_: f32;
    var phi_1406_: f32;
    var phi_1407_: vec3<f32>;
    var phi_1408_: vec3<f32>;
    var phi_1409_: vec3<f32>;
    var phi_1410_: vec3<f32>;
    var phi_1441_: bool;
    var phi_1450_: vec3<f32>;
    var phi_1617_: bool;
    var phi_1641_: f32;
    var phi_1642_: f32;
    var phi_1665_: type_26;
    var phi_1667_: type_26;
    var phi_1668_: bool;
    var phi_1672_: type_26;
    var phi_1673_: type_26;
    var phi_1674_: type_26;
    var phi_1675_: bool;
    var phi_1679_: type_26;
    var phi_1680_: bool;
    var phi_1681_: type_26;
    var phi_1682_: bool;
    var phi_1683_: bool;
    var phi_1684_: type_26;
    var phi_1685_: bool;
    var phi_1686_: bool;
    var phi_1694_: type_26;
    var phi_1695_: bool;
    var phi_1699_: type_26;
    var phi_1710_: type_46;
    var phi_1711_: type_46;
    var phi_721_: type_46;
    var phi_2208_: bool;
    var local_2: type_46;
    var phi_2351_: bool;
    var phi_2167_: type_46;
    var phi_2168_: u32;
    var phi_2169_: bool;
    var phi_2170_: u32;
    var phi_2350_: bool;
    var phi_2171_: type_46;
    var phi_2172_: u32;
    var phi_2173_: u32;
    var phi_2174_: bool;
    var phi_2175_: u32;
    var phi_2349_: bool;
    var phi_2176_: type_46;
    var phi_2177_: u32;
    var phi_2178_: u32;
    var phi_2179_: bool;
    var phi_2180_: u32;
    var phi_2348_: bool;
    var phi_652_: type_46;
    var phi_655_: u32;
    var phi_657_: u32;
    var phi_659_: bool;
    var phi_661_: u32;
    var phi_2181_: bool;
    var phi_2347_: bool;
    var local_3: type_46;
    var local_4: type_46;

    switch bitcast<i32>(0u) {
        default: {
            let _e64 = global;
            let _e66 = arrayLength((&global_2.member));
            let _e68 = arrayLength((&global_3.member));
            let _e76 = (_e64.x + (_e64.y * 2097152u));
            let _e79 = global_1.member[0u];
            let _e80 = bitcast<i32>(_e79);
            let _e81 = (_e76 < arrayLength((&global_4.member)));
            if _e81 {
                let _e82 = (_e76 < arrayLength((&global_5.member)));
                if _e82 {
                    if _e81 {
                    } else {
                        break;
                    }
                    let _e90 = global_4.member[_e76].member_2[0u];
                    let _e92 = (bitcast<u32>(_e90) & 2147483647u);
                    let _e97 = global_4.member[_e76].member_2[1u];
                    let _e99 = (bitcast<u32>(_e97) & 2147483647u);
                    let _e104 = global_4.member[_e76].member_2[2u];
                    let _e106 = (bitcast<u32>(_e104) & 2147483647u);
                    let _e111 = global_4.member[_e76].member[0u];
                    let _e113 = (bitcast<u32>(_e111) & 2147483647u);
                    let _e118 = global_4.member[_e76].member[1u];
                    let _e120 = (bitcast<u32>(_e118) & 2147483647u);
                    let _e125 = global_4.member[_e76].member[2u];
                    let _e127 = (bitcast<u32>(_e125) & 2147483647u);
                    let _e129 = select(_e99, _e92, (_e99 < _e92));
                    let _e131 = select(_e106, _e129, (_e106 < _e129));
                    let _e133 = select(_e113, _e131, (_e113 < _e131));
                    let _e135 = select(_e120, _e133, (_e120 < _e133));
                    let _e137 = select(_e127, _e135, (_e127 < _e135));
                    let _e141 = global_4.member[_e76].member_1;
                    let _e143 = (bitcast<u32>(_e141) & 2147483647u);
                    let _e150 = global_4.member[_e76].member_3;
                    let _e156 = (((select(_e143, _e137, (_e143 < _e137)) < 2139095040u) && ((bitcast<u32>(_e150) & 2147483647u) <= 2139095040u)) && (_e131 > 0u));
                    if _e156 {
                        let _e159 = (bitcast<u32>(bitcast<f32>(_e131)) & 2147483647u);
                        if (_e159 >= 8388608u) {
                            phi_271_ = (bitcast<i32>((_e159 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_271_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e159)), 32u, (_e159 == 0u))));
                        }
                        let _e173 = phi_271_;
                        phi_272_ = _e173;
                    } else {
                        phi_272_ = 0i;
                    }
                    let _e175 = phi_272_;
                    let _e176 = (_e92 == _e131);
                    if _e176 {
                        phi_282_ = true;
                    } else {
                        phi_282_ = (_e99 == _e131);
                    }
                    let _e179 = phi_282_;
                    let _e180 = select(1u, 0u, _e176);
                    if _e179 {
                        let _e181 = (_e180 + 1u);
                        phi_292_ = _e181;
                        phi_293_ = _e181;
                        phi_295_ = select(true, false, (_e181 == 2u));
                    } else {
                        phi_292_ = u32();
                        phi_293_ = 0u;
                        phi_295_ = true;
                    }
                    let _e185 = phi_292_;
                    let _e187 = phi_293_;
                    let _e189 = phi_295_;
                    if _e189 {
                        phi_300_ = (_e187 + 1u);
                    } else {
                        phi_300_ = 0u;
                    }
                    let _e193 = phi_300_;
                    let _e194 = select(_e185, _e187, _e189);
                    let _e195 = select(_e180, select(2u, _e180, _e179), _e189);
                    if (_e80 < -126i) {
                        phi_312_ = -126i;
                    } else {
                        phi_312_ = select(_e80, 127i, (_e80 > 127i));
                    }
                    let _e200 = phi_312_;
                    let _e205 = bitcast<f32>((bitcast<u32>((_e200 + 127i)) << bitcast<u32>(23i)));
                    let _e211 = bitcast<f32>((bitcast<u32>(((_e80 - _e200) + 127i)) << bitcast<u32>(23i)));
                    let _e212 = -(_e175);
                    if (_e212 < -126i) {
                        phi_332_ = -126i;
                    } else {
                        phi_332_ = select(_e212, 127i, (_e212 > 127i));
                    }
                    let _e217 = phi_332_;
                    let _e222 = bitcast<f32>((bitcast<u32>((_e217 + 127i)) << bitcast<u32>(23i)));
                    let _e228 = bitcast<f32>((bitcast<u32>(((_e212 - _e217) + 127i)) << bitcast<u32>(23i)));
                    let _e232 = global_4.member[_e76].member;
                    let _e233 = (_e194 == 0u);
                    if _e233 {
                        phi_350_ = _e232[0];
                    } else {
                        phi_350_ = _e232[1];
                    }
                    let _e237 = phi_350_;
                    let _e238 = (_e194 == 2u);
                    if _e238 {
                        phi_356_ = _e232[2];
                    } else {
                        phi_356_ = _e237;
                    }
                    let _e241 = phi_356_;
                    let _e243 = ((_e241 * _e205) * _e211);
                    let _e244 = global_4.member[_e76].member_2;
                    if _e233 {
                        phi_367_ = _e244[0];
                    } else {
                        phi_367_ = _e244[1];
                    }
                    let _e248 = phi_367_;
                    if _e238 {
                        phi_373_ = _e244[2];
                    } else {
                        phi_373_ = _e248;
                    }
                    let _e251 = phi_373_;
                    let _e253 = ((_e251 * _e222) * _e228);
                    let _e257 = (bitcast<f32>((bitcast<u32>(_e253) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e257 {
                        let _e261 = (bitcast<f32>((bitcast<u32>(_e243) & 2147483647u)) * 0.00000011920929f);
                        phi_396_ = select(0.00000000000011368684f, _e261, (_e261 > 0.00000000000011368684f));
                    } else {
                        phi_396_ = 0f;
                    }
                    let _e265 = phi_396_;
                    let _e266 = (_e243 + _e265);
                    let _e267 = (_e243 - _e265);
                    let _e268 = select(_e253, 0f, _e257);
                    if _e257 {
                        phi_407_ = 38685626000000000000000000f;
                    } else {
                        phi_407_ = (1f / _e253);
                    }
                    let _e271 = phi_407_;
                    let _e272 = (_e193 == 0u);
                    if _e272 {
                        phi_416_ = _e232[0];
                    } else {
                        phi_416_ = _e232[1];
                    }
                    let _e276 = phi_416_;
                    let _e277 = (_e193 == 2u);
                    if _e277 {
                        phi_422_ = _e232[2];
                    } else {
                        phi_422_ = _e276;
                    }
                    let _e280 = phi_422_;
                    let _e282 = ((_e280 * _e205) * _e211);
                    if _e272 {
                        phi_433_ = _e244[0];
                    } else {
                        phi_433_ = _e244[1];
                    }
                    let _e286 = phi_433_;
                    if _e277 {
                        phi_439_ = _e244[2];
                    } else {
                        phi_439_ = _e286;
                    }
                    let _e289 = phi_439_;
                    let _e291 = ((_e289 * _e222) * _e228);
                    let _e295 = (bitcast<f32>((bitcast<u32>(_e291) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e295 {
                        let _e299 = (bitcast<f32>((bitcast<u32>(_e282) & 2147483647u)) * 0.00000011920929f);
                        phi_462_ = select(0.00000000000011368684f, _e299, (_e299 > 0.00000000000011368684f));
                    } else {
                        phi_462_ = 0f;
                    }
                    let _e303 = phi_462_;
                    let _e304 = (_e282 + _e303);
                    let _e305 = (_e282 - _e303);
                    let _e306 = select(_e291, 0f, _e295);
                    if _e295 {
                        phi_473_ = 38685626000000000000000000f;
                    } else {
                        phi_473_ = (1f / _e291);
                    }
                    let _e309 = phi_473_;
                    let _e310 = (_e195 == 0u);
                    if _e310 {
                        phi_482_ = _e232[0];
                    } else {
                        phi_482_ = _e232[1];
                    }
                    let _e314 = phi_482_;
                    let _e315 = (_e195 == 2u);
                    if _e315 {
                        phi_488_ = _e232[2];
                    } else {
                        phi_488_ = _e314;
                    }
                    let _e318 = phi_488_;
                    let _e320 = ((_e318 * _e205) * _e211);
                    if _e310 {
                        phi_499_ = _e244[0];
                    } else {
                        phi_499_ = _e244[1];
                    }
                    let _e324 = phi_499_;
                    if _e315 {
                        phi_505_ = _e244[2];
                    } else {
                        phi_505_ = _e324;
                    }
                    let _e327 = phi_505_;
                    let _e329 = ((_e327 * _e222) * _e228);
                    let _e333 = (bitcast<f32>((bitcast<u32>(_e329) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e333 {
                        let _e337 = (bitcast<f32>((bitcast<u32>(_e320) & 2147483647u)) * 0.00000011920929f);
                        phi_528_ = select(0.00000000000011368684f, _e337, (_e337 > 0.00000000000011368684f));
                    } else {
                        phi_528_ = 0f;
                    }
                    let _e341 = phi_528_;
                    let _e342 = (_e320 + _e341);
                    let _e343 = (_e320 - _e341);
                    let _e344 = select(_e329, 0f, _e333);
                    if _e333 {
                        phi_539_ = 38685626000000000000000000f;
                    } else {
                        phi_539_ = (1f / _e329);
                    }
                    let _e347 = phi_539_;
                    let _e350 = bitcast<f32>((bitcast<u32>(_e243) & 2147483647u));
                    let _e353 = bitcast<f32>((bitcast<u32>(_e282) & 2147483647u));
                    let _e355 = select(_e353, _e350, (_e350 > _e353));
                    let _e358 = bitcast<f32>((bitcast<u32>(_e320) & 2147483647u));
                    let _e361 = (_e80 + _e175);
                    if (_e156 && (select(_e358, _e355, (_e355 > _e358)) <= 1099511600000f)) {
                        let _e364 = (_e361 / 3i);
                        let _e371 = bitcast<f32>((bitcast<u32>((_e364 + 127i)) << bitcast<u32>(23i)));
                        let _e378 = bitcast<f32>((bitcast<u32>(((_e361 - (2i * _e364)) + 127i)) << bitcast<u32>(23i)));
                        let _e379 = (((_e141 * _e371) * _e371) * _e378);
                        let _e381 = select(340282350000000000000000000000000000000f, _e379, (_e379 < 340282350000000000000000000000000000000f));
                        let _e386 = (((_e150 * _e371) * _e371) * _e378);
                        let _e388 = select(340282350000000000000000000000000000000f, _e386, (_e386 < 340282350000000000000000000000000000000f));
                        phi_639_ = select(-340282350000000000000000000000000000000f, _e388, (_e388 > -340282350000000000000000000000000000000f));
                        phi_640_ = select(-340282350000000000000000000000000000000f, _e381, (_e381 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_639_ = 0f;
                        phi_640_ = 1f;
                    }
                    let _e392 = phi_639_;
                    let _e394 = phi_640_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2214_ = false;
                    phi_651_ = type_46(_e392, false);
                    phi_654_ = select(0u, 2147483648u, (_e66 == 0u));
                    phi_656_ = ((3u * _e66) + 1u);
                    phi_658_ = (_e394 <= _e392);
                    phi_660_ = 0u;
                    loop {
                        let _e402 = phi_2214_;
                        let _e404 = phi_651_;
                        let _e406 = phi_654_;
                        let _e408 = phi_656_;
                        let _e410 = phi_658_;
                        let _e412 = phi_660_;
                        local_3 = _e404;
                        if _e410 {
                            phi_671_ = true;
                        } else {
                            phi_671_ = (_e412 > 0u);
                        }
                        let _e415 = phi_671_;
                        if _e415 {
                            let _e416 = (_e408 > 0u);
                            if _e416 {
                                if _e410 {
                                    phi_703_ = _e406;
                                    phi_704_ = _e410;
                                    phi_705_ = _e412;
                                } else {
                                    let _e417 = (_e412 - 1u);
                                    let _e418 = (_e417 % 128u);
                                    let _e419 = (_e418 < 128u);
                                    if _e419 {
                                    } else {
                                        phi_2347_ = true;
                                        break;
                                    }
                                    let _e421 = local_1[_e418];
                                    if _e419 {
                                    } else {
                                        phi_2347_ = true;
                                        break;
                                    }
                                    let _e423 = local[_e418];
                                    phi_703_ = _e421;
                                    phi_704_ = (_e423 <= _e404.member);
                                    phi_705_ = _e417;
                                }
                                let _e427 = phi_703_;
                                let _e429 = phi_704_;
                                let _e431 = phi_705_;
                                if _e429 {
                                    if ((_e427 & 2147483648u) != 0u) {
                                        phi_720_ = _e404;
                                        phi_723_ = type_7(0u, ((_e427 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e629 = phi_720_;
                                            let _e631 = phi_723_;
                                            local_2 = _e629;
                                            local_4 = _e629;
                                            if (_e631.member < _e631.member_1) {
                                                phi_724_ = type_7((_e631.member + 1u), _e631.member_1);
                                                phi_746_ = type_7(1u, _e631.member);
                                            } else {
                                                phi_724_ = _e631;
                                                phi_746_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e644 = phi_724_;
                                            let _e646 = phi_746_;
                                            let _e650 = (bitcast<i32>(_e646.member) != 0i);
                                            if _e650 {
                                                let _e651 = ((_e427 & 268435455u) + _e646.member_1);
                                                let _e652 = (_e651 < _e68);
                                                if _e652 {
                                                    if _e652 {
                                                    } else {
                                                        phi_2208_ = true;
                                                        break;
                                                    }
                                                    let _e656 = global_3.member[_e651].member_1;
                                                    phi_767_ = _e656;
                                                } else {
                                                    phi_767_ = 4294967295u;
                                                }
                                                let _e658 = phi_767_;
                                                if (_e651 >= _e68) {
                                                    phi_856_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e652 {
                                                    } else {
                                                        phi_2208_ = true;
                                                        break;
                                                    }
                                                    let _e660 = (_e194 % 3u);
                                                    let _e661 = (_e193 % 3u);
                                                    let _e662 = (_e195 % 3u);
                                                    if (_e660 < 9u) {
                                                    } else {
                                                        phi_2208_ = true;
                                                        break;
                                                    }
                                                    let _e668 = global_3.member[_e651].member[_e660];
                                                    if (_e661 < 9u) {
                                                    } else {
                                                        phi_2208_ = true;
                                                        break;
                                                    }
                                                    let _e674 = global_3.member[_e651].member[_e661];
                                                    if (_e662 < 9u) {
                                                    } else {
                                                        phi_2208_ = true;
                                                        break;
                                                    }
                                                    let _e680 = global_3.member[_e651].member[_e662];
                                                    let _e682 = (3u + _e660);
                                                    if (_e682 < 9u) {
                                                    } else {
                                                        phi_2208_ = true;
                                                        break;
                                                    }
                                                    let _e688 = global_3.member[_e651].member[_e682];
                                                    let _e689 = (3u + _e661);
                                                    if (_e689 < 9u) {
                                                    } else {
                                                        phi_2208_ = true;
                                                        break;
                                                    }
                                                    let _e695 = global_3.member[_e651].member[_e689];
                                                    let _e696 = (3u + _e662);
                                                    if (_e696 < 9u) {
                                                    } else {
                                                        phi_2208_ = true;
                                                        break;
                                                    }
                                                    let _e702 = global_3.member[_e651].member[_e696];
                                                    let _e704 = (6u + _e660);
                                                    if (_e704 < 9u) {
                                                    } else {
                                                        phi_2208_ = true;
                                                        break;
                                                    }
                                                    let _e710 = global_3.member[_e651].member[_e704];
                                                    let _e711 = (6u + _e661);
                                                    if (_e711 < 9u) {
                                                    } else {
                                                        phi_2208_ = true;
                                                        break;
                                                    }
                                                    let _e717 = global_3.member[_e651].member[_e711];
                                                    let _e718 = (6u + _e662);
                                                    if (_e718 < 9u) {
                                                    } else {
                                                        phi_2208_ = true;
                                                        break;
                                                    }
                                                    let _e724 = global_3.member[_e651].member[_e718];
                                                    phi_856_ = array<array<f32, 3>, 3>(array<f32, 3>(_e668, _e674, _e680), array<f32, 3>(_e688, _e695, _e702), array<f32, 3>(_e710, _e717, _e724));
                                                }
                                                let _e728 = phi_856_;
                                                let _e736 = (_e728[0][2] - _e320);
                                                let _e739 = (((_e728[0][0] - _e243) * _e344) - (_e736 * _e268));
                                                let _e742 = (((_e728[0][1] - _e282) * _e344) - (_e736 * _e306));
                                                let _e749 = (_e728[1][2] - _e320);
                                                let _e752 = (((_e728[1][0] - _e243) * _e344) - (_e749 * _e268));
                                                let _e755 = (((_e728[1][1] - _e282) * _e344) - (_e749 * _e306));
                                                let _e762 = (_e728[2][2] - _e320);
                                                let _e765 = (((_e728[2][0] - _e243) * _e344) - (_e762 * _e268));
                                                let _e768 = (((_e728[2][1] - _e282) * _e344) - (_e762 * _e306));
                                                let _e769 = (_e765 * _e755);
                                                let _e770 = (_e768 * _e752);
                                                let _e771 = (_e739 * _e768);
                                                let _e772 = (_e742 * _e765);
                                                let _e773 = (_e752 * _e742);
                                                let _e774 = (_e755 * _e739);
                                                let _e779 = (((_e769 >= _e770) && (_e771 >= _e772)) && (_e773 >= _e774));
                                                if (_e779 || (((_e769 <= _e770) && (_e771 <= _e772)) && (_e773 <= _e774))) {
                                                    let _e786 = select(-1f, 1f, _e779);
                                                    let _e788 = ((_e769 - _e770) * _e786);
                                                    let _e790 = select(0f, _e788, (_e788 > 0f));
                                                    let _e792 = ((_e771 - _e772) * _e786);
                                                    let _e794 = select(0f, _e792, (_e792 > 0f));
                                                    let _e796 = ((_e773 - _e774) * _e786);
                                                    let _e798 = select(0f, _e796, (_e796 > 0f));
                                                    let _e800 = ((_e790 + _e794) + _e798);
                                                    if (_e800 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1684_ = type_26();
                                                        phi_1685_ = true;
                                                        phi_1686_ = false;
                                                    } else {
                                                        let _e803 = select(_e752, _e739, (_e739 < _e752));
                                                        if (select(_e765, _e803, (_e803 < _e765)) > 0f) {
                                                            phi_973_ = true;
                                                        } else {
                                                            let _e808 = select(_e752, _e739, (_e739 > _e752));
                                                            phi_973_ = (select(_e765, _e808, (_e808 > _e765)) < 0f);
                                                        }
                                                        let _e813 = phi_973_;
                                                        if _e813 {
                                                            phi_1681_ = type_26();
                                                            phi_1682_ = true;
                                                            phi_1683_ = false;
                                                        } else {
                                                            let _e815 = select(_e755, _e742, (_e742 < _e755));
                                                            if (select(_e768, _e815, (_e815 < _e768)) > 0f) {
                                                                phi_1002_ = true;
                                                            } else {
                                                                let _e820 = select(_e755, _e742, (_e742 > _e755));
                                                                phi_1002_ = (select(_e768, _e820, (_e820 > _e768)) < 0f);
                                                            }
                                                            let _e825 = phi_1002_;
                                                            if _e825 {
                                                                phi_1679_ = type_26();
                                                                phi_1680_ = false;
                                                            } else {
                                                                let _e827 = select(_e728[1][0], _e728[0][0], (_e728[0][0] < _e728[1][0]));
                                                                let _e831 = select(_e728[1][0], _e728[0][0], (_e728[0][0] > _e728[1][0]));
                                                                let _e835 = select(_e728[1][1], _e728[0][1], (_e728[0][1] < _e728[1][1]));
                                                                let _e839 = select(_e728[1][1], _e728[0][1], (_e728[0][1] > _e728[1][1]));
                                                                let _e843 = select(_e728[1][2], _e728[0][2], (_e728[0][2] < _e728[1][2]));
                                                                let _e847 = select(_e728[1][2], _e728[0][2], (_e728[0][2] > _e728[1][2]));
                                                                let _e852 = ((select(_e728[2][0], _e827, (_e827 < _e728[2][0])) - _e266) * _e271);
                                                                let _e853 = ((select(_e728[2][0], _e831, (_e831 > _e728[2][0])) - _e267) * _e271);
                                                                let _e856 = ((select(_e728[2][1], _e835, (_e835 < _e728[2][1])) - _e304) * _e309);
                                                                let _e857 = ((select(_e728[2][1], _e839, (_e839 > _e728[2][1])) - _e305) * _e309);
                                                                let _e860 = ((select(_e728[2][2], _e843, (_e843 < _e728[2][2])) - _e342) * _e347);
                                                                let _e861 = ((select(_e728[2][2], _e847, (_e847 > _e728[2][2])) - _e343) * _e347);
                                                                let _e863 = select(_e861, _e860, (_e860 < _e861));
                                                                let _e865 = select(_e861, _e860, (_e860 > _e861));
                                                                let _e867 = select(_e853, _e852, (_e852 < _e853));
                                                                let _e869 = select(_e857, _e856, (_e856 < _e857));
                                                                let _e871 = select(_e869, _e867, (_e867 > _e869));
                                                                let _e873 = select(_e863, _e871, (_e871 > _e863));
                                                                let _e875 = select(_e853, _e852, (_e852 > _e853));
                                                                let _e877 = select(_e857, _e856, (_e856 > _e857));
                                                                let _e879 = select(_e877, _e875, (_e875 < _e877));
                                                                let _e881 = select(_e865, _e879, (_e879 < _e865));
                                                                let _e882 = -(_e863);
                                                                let _e888 = select(_e394, _e873, (_e873 > _e394));
                                                                if (_e888 > (_e881 + (select(_e882, _e865, (_e865 > _e882)) * 0.0000019073523f))) {
                                                                    phi_1674_ = type_26();
                                                                    phi_1675_ = true;
                                                                } else {
                                                                    let _e890 = (_e888 > _e629.member);
                                                                    if _e890 {
                                                                        phi_1673_ = type_26();
                                                                    } else {
                                                                        let _e891 = vec3<f32>(_e728[0][0], _e728[0][1], _e728[0][2]);
                                                                        let _e892 = vec3<f32>(_e728[1][0], _e728[1][1], _e728[1][2]);
                                                                        let _e893 = vec3<f32>(_e728[2][0], _e728[2][1], _e728[2][2]);
                                                                        let _e894 = (_e728[1][0] - _e728[0][0]);
                                                                        let _e895 = (_e728[1][1] - _e728[0][1]);
                                                                        let _e896 = (_e728[1][2] - _e728[0][2]);
                                                                        let _e897 = vec3<f32>(_e894, _e895, _e896);
                                                                        let _e898 = (_e728[2][0] - _e728[1][0]);
                                                                        let _e899 = (_e728[2][1] - _e728[1][1]);
                                                                        let _e900 = (_e728[2][2] - _e728[1][2]);
                                                                        let _e901 = vec3<f32>(_e898, _e899, _e900);
                                                                        let _e902 = (_e728[0][0] - _e728[2][0]);
                                                                        let _e903 = (_e728[0][1] - _e728[2][1]);
                                                                        let _e904 = (_e728[0][2] - _e728[2][2]);
                                                                        let _e905 = vec3<f32>(_e902, _e903, _e904);
                                                                        let _e908 = bitcast<f32>((bitcast<u32>(_e894) & 2147483647u));
                                                                        let _e911 = bitcast<f32>((bitcast<u32>(_e895) & 2147483647u));
                                                                        let _e913 = select(_e911, _e908, (_e908 > _e911));
                                                                        let _e916 = bitcast<f32>((bitcast<u32>(_e896) & 2147483647u));
                                                                        let _e918 = select(_e916, _e913, (_e913 > _e916));
                                                                        let _e921 = bitcast<f32>((bitcast<u32>(_e898) & 2147483647u));
                                                                        let _e924 = bitcast<f32>((bitcast<u32>(_e899) & 2147483647u));
                                                                        let _e926 = select(_e924, _e921, (_e921 > _e924));
                                                                        let _e929 = bitcast<f32>((bitcast<u32>(_e900) & 2147483647u));
                                                                        let _e931 = select(_e929, _e926, (_e926 > _e929));
                                                                        let _e934 = bitcast<f32>((bitcast<u32>(_e902) & 2147483647u));
                                                                        let _e937 = bitcast<f32>((bitcast<u32>(_e903) & 2147483647u));
                                                                        let _e939 = select(_e937, _e934, (_e934 > _e937));
                                                                        let _e942 = bitcast<f32>((bitcast<u32>(_e904) & 2147483647u));
                                                                        let _e944 = select(_e942, _e939, (_e939 > _e942));
                                                                        let _e946 = select(_e931, _e918, (_e918 > _e931));
                                                                        let _e948 = select(_e944, _e946, (_e946 > _e944));
                                                                        if (_e918 == _e948) {
                                                                            phi_1403_ = _e755;
                                                                            phi_1404_ = _e752;
                                                                            phi_1405_ = _e742;
                                                                            phi_1406_ = _e739;
                                                                            phi_1407_ = _e891;
                                                                            phi_1408_ = _e905;
                                                                            phi_1409_ = _e901;
                                                                            phi_1410_ = _e897;
                                                                        } else {
                                                                            let _e950 = (_e931 == _e948);
                                                                            let _e955 = vec3(_e950);
                                                                            phi_1403_ = select(_e742, _e768, _e950);
                                                                            phi_1404_ = select(_e739, _e765, _e950);
                                                                            phi_1405_ = select(_e768, _e755, _e950);
                                                                            phi_1406_ = select(_e765, _e752, _e950);
                                                                            phi_1407_ = select(_e893, _e892, _e955);
                                                                            phi_1408_ = select(_e901, _e897, _e955);
                                                                            phi_1409_ = select(_e897, _e905, _e955);
                                                                            phi_1410_ = select(_e905, _e901, _e955);
                                                                        }
                                                                        let _e961 = phi_1403_;
                                                                        let _e963 = phi_1404_;
                                                                        let _e965 = phi_1405_;
                                                                        let _e967 = phi_1406_;
                                                                        let _e969 = phi_1407_;
                                                                        let _e971 = phi_1408_;
                                                                        let _e973 = phi_1409_;
                                                                        let _e975 = phi_1410_;
                                                                        let _e982 = ((_e973.y * _e971.z) - (_e971.y * _e973.z));
                                                                        let _e987 = ((_e973.z * _e971.x) - (_e971.z * _e973.x));
                                                                        let _e990 = ((_e973.x * _e971.y) - (_e971.x * _e973.y));
                                                                        if (_e790 >= _e794) {
                                                                            phi_1441_ = select(true, false, (_e790 >= _e798));
                                                                        } else {
                                                                            phi_1441_ = true;
                                                                        }
                                                                        let _e995 = phi_1441_;
                                                                        if _e995 {
                                                                            phi_1450_ = select(_e893, _e892, vec3((_e794 >= _e798)));
                                                                        } else {
                                                                            phi_1450_ = _e891;
                                                                        }
                                                                        let _e1000 = phi_1450_;
                                                                        let _e1005 = (((_e982 * _e268) + (_e987 * _e306)) + (_e990 * _e344));
                                                                        let _e1016 = (((_e982 * (_e1000.x - _e243)) + (_e987 * (_e1000.y - _e282))) + (_e990 * (_e1000.z - _e320)));
                                                                        let _e1018 = (_e963 - _e967);
                                                                        let _e1019 = (_e961 - _e965);
                                                                        let _e1027 = (-(((_e967 * _e1018) + (_e965 * _e1019))) / ((_e1018 * _e1018) + (_e1019 * _e1019)));
                                                                        let _e1029 = select(1f, _e1027, (_e1027 < 1f));
                                                                        let _e1031 = select(0f, _e1029, (_e1029 > 0f));
                                                                        let _e1044 = ((_e969.x + (_e975.x * _e1031)) - _e243);
                                                                        let _e1045 = ((_e969.y + (_e975.y * _e1031)) - _e282);
                                                                        let _e1046 = ((_e969.z + (_e975.z * _e1031)) - _e320);
                                                                        let _e1047 = (_e1046 / _e344);
                                                                        let _e1059 = bitcast<f32>((bitcast<u32>(_e1044) & 2147483647u));
                                                                        let _e1062 = bitcast<f32>((bitcast<u32>(_e1045) & 2147483647u));
                                                                        let _e1064 = select(_e1062, _e1059, (_e1059 > _e1062));
                                                                        let _e1067 = bitcast<f32>((bitcast<u32>(_e1046) & 2147483647u));
                                                                        let _e1069 = select(_e1067, _e1064, (_e1064 > _e1067));
                                                                        let _e1075 = bitcast<f32>((bitcast<u32>(_e982) & 2147483647u));
                                                                        let _e1078 = bitcast<f32>((bitcast<u32>(_e987) & 2147483647u));
                                                                        let _e1080 = select(_e1078, _e1075, (_e1075 > _e1078));
                                                                        let _e1083 = bitcast<f32>((bitcast<u32>(_e990) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e982 * _e1044) + (_e987 * _e1045)) + (_e990 * _e1046)) - _e1016)) & 2147483647u)) <= ((0.0000009536743f * select(_e948, _e1069, (_e1069 > _e948))) * select(_e1083, _e1080, (_e1080 > _e1083)))) {
                                                                            let _e1093 = bitcast<f32>((bitcast<u32>(_e973.x) & 2147483647u));
                                                                            let _e1096 = bitcast<f32>((bitcast<u32>(_e973.y) & 2147483647u));
                                                                            let _e1098 = select(_e1096, _e1093, (_e1093 > _e1096));
                                                                            let _e1101 = bitcast<f32>((bitcast<u32>(_e973.z) & 2147483647u));
                                                                            let _e1107 = bitcast<f32>((bitcast<u32>(_e971.x) & 2147483647u));
                                                                            let _e1110 = bitcast<f32>((bitcast<u32>(_e971.y) & 2147483647u));
                                                                            let _e1112 = select(_e1110, _e1107, (_e1107 > _e1110));
                                                                            let _e1115 = bitcast<f32>((bitcast<u32>(_e971.z) & 2147483647u));
                                                                            phi_1617_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1005) & 2147483647u)) > ((0.0000038146973f * select(_e1101, _e1098, (_e1098 > _e1101))) * select(_e1115, _e1112, (_e1112 > _e1115)))));
                                                                        } else {
                                                                            phi_1617_ = true;
                                                                        }
                                                                        let _e1122 = phi_1617_;
                                                                        if _e1122 {
                                                                            let _e1133 = ((((_e982 * (_e1044 - (_e268 * _e1047))) + (_e987 * (_e1045 - (_e306 * _e1047)))) + (_e990 * (_e1046 - _e1046))) / _e1005);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1133) & 2147483647u)) <= _e948) {
                                                                                phi_1641_ = (_e1047 + _e1133);
                                                                            } else {
                                                                                phi_1641_ = _e1047;
                                                                            }
                                                                            let _e1140 = phi_1641_;
                                                                            phi_1642_ = _e1140;
                                                                        } else {
                                                                            phi_1642_ = (_e1016 / _e1005);
                                                                        }
                                                                        let _e1142 = phi_1642_;
                                                                        let _e1144 = select(_e881, _e1142, (_e1142 < _e881));
                                                                        let _e1146 = select(_e873, _e1144, (_e1144 > _e873));
                                                                        if (_e1146 >= _e394) {
                                                                            let _e1148 = (_e1146 <= _e629.member);
                                                                            if _e1148 {
                                                                                let _e1149 = (1f / _e800);
                                                                                phi_1665_ = type_26(_e1146, (_e794 * _e1149), (_e798 * _e1149), _e658);
                                                                            } else {
                                                                                phi_1665_ = type_26();
                                                                            }
                                                                            let _e1154 = phi_1665_;
                                                                            phi_1667_ = _e1154;
                                                                            phi_1668_ = select(true, false, _e1148);
                                                                        } else {
                                                                            phi_1667_ = type_26();
                                                                            phi_1668_ = true;
                                                                        }
                                                                        let _e1157 = phi_1667_;
                                                                        let _e1159 = phi_1668_;
                                                                        if _e1159 {
                                                                            phi_1672_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1672_ = _e1157;
                                                                        }
                                                                        let _e1161 = phi_1672_;
                                                                        phi_1673_ = _e1161;
                                                                    }
                                                                    let _e1163 = phi_1673_;
                                                                    phi_1674_ = _e1163;
                                                                    phi_1675_ = _e890;
                                                                }
                                                                let _e1165 = phi_1674_;
                                                                let _e1167 = phi_1675_;
                                                                phi_1679_ = _e1165;
                                                                phi_1680_ = _e1167;
                                                            }
                                                            let _e1169 = phi_1679_;
                                                            let _e1171 = phi_1680_;
                                                            phi_1681_ = _e1169;
                                                            phi_1682_ = _e825;
                                                            phi_1683_ = _e1171;
                                                        }
                                                        let _e1173 = phi_1681_;
                                                        let _e1175 = phi_1682_;
                                                        let _e1177 = phi_1683_;
                                                        phi_1684_ = _e1173;
                                                        phi_1685_ = _e1175;
                                                        phi_1686_ = _e1177;
                                                    }
                                                    let _e1179 = phi_1684_;
                                                    let _e1181 = phi_1685_;
                                                    let _e1183 = phi_1686_;
                                                    phi_1694_ = _e1179;
                                                    phi_1695_ = select(_e1183, true, _e1181);
                                                } else {
                                                    phi_1694_ = type_26();
                                                    phi_1695_ = true;
                                                }
                                                let _e1186 = phi_1694_;
                                                let _e1188 = phi_1695_;
                                                if _e1188 {
                                                    phi_1699_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1699_ = _e1186;
                                                }
                                                let _e1190 = phi_1699_;
                                                if (_e1190.member_3 != 4294967295u) {
                                                    if (_e658 != 4294967295u) {
                                                        phi_1710_ = type_46(_e629.member, true);
                                                    } else {
                                                        phi_1710_ = _e629;
                                                    }
                                                    let _e1198 = phi_1710_;
                                                    phi_1711_ = _e1198;
                                                } else {
                                                    phi_1711_ = _e629;
                                                }
                                                let _e1200 = phi_1711_;
                                                phi_721_ = _e1200;
                                            } else {
                                                phi_721_ = type_46();
                                            }
                                            let _e1202 = phi_721_;
                                            continue;
                                            continuing {
                                                phi_720_ = _e1202;
                                                phi_723_ = _e644;
                                                phi_2208_ = _e402;
                                                break if !(_e650);
                                            }
                                        }
                                        let _e1205 = phi_2208_;
                                        phi_2347_ = _e1205;
                                        if _e1205 {
                                            break;
                                        }
                                        let _e1207 = local_2;
                                        phi_2351_ = _e1205;
                                        let _e1364 = local_4;
                                        phi_2167_ = _e1364;
                                        phi_2168_ = _e427;
                                        phi_2169_ = false;
                                        phi_2170_ = select(_e431, 0u, _e1207.member_1);
                                    } else {
                                        if (_e427 >= _e66) {
                                            phi_1772_ = type_42(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e427 < _e66) {
                                            } else {
                                                phi_2347_ = true;
                                                break;
                                            }
                                            let _e441 = (_e194 % 3u);
                                            if (_e441 < 3u) {
                                            } else {
                                                phi_2347_ = true;
                                                break;
                                            }
                                            let _e447 = global_2.member[_e427].member[_e441];
                                            let _e453 = (_e193 % 3u);
                                            if (_e453 < 3u) {
                                            } else {
                                                phi_2347_ = true;
                                                break;
                                            }
                                            let _e459 = global_2.member[_e427].member[_e453];
                                            let _e465 = (_e195 % 3u);
                                            if (_e465 < 3u) {
                                            } else {
                                                phi_2347_ = true;
                                                break;
                                            }
                                            let _e471 = global_2.member[_e427].member[_e465];
                                            let _e481 = global_2.member[_e427].member_1;
                                            let _e485 = global_2.member[_e427].member_2;
                                            phi_1772_ = type_42(array<vec4<f32>, 3>(vec4<f32>(_e447[0], _e447[1], _e447[2], _e447[3]), vec4<f32>(_e459[0], _e459[1], _e459[2], _e459[3]), vec4<f32>(_e471[0], _e471[1], _e471[2], _e471[3])), _e481, _e485);
                                        }
                                        let _e488 = phi_1772_;
                                        let _e500 = ((_e488.member[0].x - _e266) * _e271);
                                        let _e501 = ((_e488.member[0].y - _e266) * _e271);
                                        let _e502 = ((_e488.member[0].z - _e267) * _e271);
                                        let _e503 = ((_e488.member[0].w - _e267) * _e271);
                                        let _e513 = ((_e488.member[1].x - _e304) * _e309);
                                        let _e514 = ((_e488.member[1].y - _e304) * _e309);
                                        let _e515 = ((_e488.member[1].z - _e305) * _e309);
                                        let _e516 = ((_e488.member[1].w - _e305) * _e309);
                                        let _e526 = ((_e488.member[2].x - _e342) * _e347);
                                        let _e527 = ((_e488.member[2].y - _e342) * _e347);
                                        let _e528 = ((_e488.member[2].z - _e343) * _e347);
                                        let _e529 = ((_e488.member[2].w - _e343) * _e347);
                                        let _e531 = select(_e528, _e526, (_e526 < _e528));
                                        let _e533 = select(_e529, _e527, (_e527 < _e529));
                                        let _e535 = select(_e528, _e526, (_e526 > _e528));
                                        let _e537 = select(_e529, _e527, (_e527 > _e529));
                                        let _e539 = select(_e502, _e500, (_e500 < _e502));
                                        let _e541 = select(_e503, _e501, (_e501 < _e503));
                                        let _e543 = select(_e515, _e513, (_e513 < _e515));
                                        let _e545 = select(_e516, _e514, (_e514 < _e516));
                                        let _e547 = select(_e543, _e539, (_e539 > _e543));
                                        let _e549 = select(_e545, _e541, (_e541 > _e545));
                                        let _e551 = select(_e531, _e547, (_e547 > _e531));
                                        let _e553 = select(_e533, _e549, (_e549 > _e533));
                                        let _e555 = select(_e502, _e500, (_e500 > _e502));
                                        let _e557 = select(_e503, _e501, (_e501 > _e503));
                                        let _e559 = select(_e515, _e513, (_e513 > _e515));
                                        let _e561 = select(_e516, _e514, (_e514 > _e516));
                                        let _e563 = select(_e559, _e555, (_e555 < _e559));
                                        let _e565 = select(_e561, _e557, (_e557 < _e561));
                                        let _e570 = -(_e531);
                                        let _e571 = -(_e533);
                                        let _e578 = (select(_e535, _e563, (_e563 < _e535)) + (select(_e570, _e535, (_e535 > _e570)) * 0.0000019073523f));
                                        let _e579 = (select(_e537, _e565, (_e565 < _e537)) + (select(_e571, _e537, (_e537 > _e571)) * 0.0000019073523f));
                                        let _e581 = select(_e394, _e551, (_e551 > _e394));
                                        let _e583 = select(_e394, _e553, (_e553 > _e394));
                                        let _e588 = (_e581 <= select(_e404.member, _e578, (_e578 < _e404.member)));
                                        let _e589 = (_e583 <= select(_e404.member, _e579, (_e579 < _e404.member)));
                                        let _e590 = (_e581 <= _e583);
                                        if _e588 {
                                            if _e589 {
                                                if _e590 {
                                                    phi_2116_ = _e488.member_2;
                                                } else {
                                                    phi_2116_ = _e488.member_1;
                                                }
                                                let _e594 = phi_2116_;
                                                let _e597 = (_e431 % 128u);
                                                let _e598 = (_e597 < 128u);
                                                if _e598 {
                                                } else {
                                                    phi_2347_ = true;
                                                    break;
                                                }
                                                local_1[_e597] = _e594;
                                                if _e598 {
                                                } else {
                                                    phi_2347_ = true;
                                                    break;
                                                }
                                                local[_e597] = select(_e583, _e581, (_e581 > _e583));
                                                if _e590 {
                                                    phi_2144_ = _e488.member_1;
                                                } else {
                                                    phi_2144_ = _e488.member_2;
                                                }
                                                let _e605 = phi_2144_;
                                                phi_2145_ = _e605;
                                                phi_2146_ = (_e431 + 1u);
                                            } else {
                                                phi_2145_ = u32();
                                                phi_2146_ = u32();
                                            }
                                            let _e607 = phi_2145_;
                                            let _e609 = phi_2146_;
                                            phi_2148_ = _e607;
                                            phi_2149_ = _e609;
                                            phi_2150_ = select(true, false, _e589);
                                        } else {
                                            phi_2148_ = u32();
                                            phi_2149_ = u32();
                                            phi_2150_ = true;
                                        }
                                        let _e612 = phi_2148_;
                                        let _e614 = phi_2149_;
                                        let _e616 = phi_2150_;
                                        if _e616 {
                                            if _e588 {
                                                phi_2159_ = _e488.member_1;
                                            } else {
                                                phi_2159_ = _e488.member_2;
                                            }
                                            let _e620 = phi_2159_;
                                            phi_2164_ = _e620;
                                            phi_2165_ = select(_e589, true, _e588);
                                        } else {
                                            phi_2164_ = _e612;
                                            phi_2165_ = _e429;
                                        }
                                        let _e623 = phi_2164_;
                                        let _e625 = phi_2165_;
                                        phi_2351_ = _e402;
                                        phi_2167_ = _e404;
                                        phi_2168_ = _e623;
                                        phi_2169_ = _e625;
                                        phi_2170_ = select(_e614, _e431, _e616);
                                    }
                                    let _e1211 = phi_2351_;
                                    let _e1213 = phi_2167_;
                                    let _e1215 = phi_2168_;
                                    let _e1217 = phi_2169_;
                                    let _e1219 = phi_2170_;
                                    phi_2350_ = _e1211;
                                    phi_2171_ = _e1213;
                                    phi_2172_ = _e1215;
                                    phi_2173_ = (_e408 - 1u);
                                    phi_2174_ = _e1217;
                                    phi_2175_ = _e1219;
                                } else {
                                    phi_2350_ = _e402;
                                    phi_2171_ = _e404;
                                    phi_2172_ = _e427;
                                    phi_2173_ = _e408;
                                    phi_2174_ = _e429;
                                    phi_2175_ = _e431;
                                }
                                let _e1221 = phi_2350_;
                                let _e1223 = phi_2171_;
                                let _e1225 = phi_2172_;
                                let _e1227 = phi_2173_;
                                let _e1229 = phi_2174_;
                                let _e1231 = phi_2175_;
                                phi_2349_ = _e1221;
                                phi_2176_ = _e1223;
                                phi_2177_ = _e1225;
                                phi_2178_ = _e1227;
                                phi_2179_ = _e1229;
                                phi_2180_ = _e1231;
                            } else {
                                phi_2349_ = _e402;
                                phi_2176_ = type_46();
                                phi_2177_ = u32();
                                phi_2178_ = u32();
                                phi_2179_ = bool();
                                phi_2180_ = u32();
                            }
                            let _e1233 = phi_2349_;
                            let _e1235 = phi_2176_;
                            let _e1237 = phi_2177_;
                            let _e1239 = phi_2178_;
                            let _e1241 = phi_2179_;
                            let _e1243 = phi_2180_;
                            phi_2348_ = _e1233;
                            phi_652_ = _e1235;
                            phi_655_ = _e1237;
                            phi_657_ = _e1239;
                            phi_659_ = _e1241;
                            phi_661_ = _e1243;
                            phi_2181_ = _e416;
                        } else {
                            phi_2348_ = _e402;
                            phi_652_ = type_46();
                            phi_655_ = u32();
                            phi_657_ = u32();
                            phi_659_ = bool();
                            phi_661_ = u32();
                            phi_2181_ = false;
                        }
                        let _e1245 = phi_2348_;
                        let _e1247 = phi_652_;
                        let _e1249 = phi_655_;
                        let _e1251 = phi_657_;
                        let _e1253 = phi_659_;
                        let _e1255 = phi_661_;
                        let _e1257 = phi_2181_;
                        continue;
                        continuing {
                            phi_2214_ = _e1245;
                            phi_651_ = _e1247;
                            phi_654_ = _e1249;
                            phi_656_ = _e1251;
                            phi_658_ = _e1253;
                            phi_660_ = _e1255;
                            phi_2347_ = _e1245;
                            break if !(_e1257);
                        }
                    }
                    let _e1260 = phi_2347_;
                    if _e1260 {
                        break;
                    }
                    let _e1262 = local_3;
                    if _e82 {
                    } else {
                        break;
                    }
                    global_5.member[_e76] = select(0u, 1u, _e1262.member_1);
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
