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

struct type_23 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
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
    member: type_23,
    member_1: f32,
}

struct type_44 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_46 {
    member: array<type_27>,
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
var<storage, read_write> global_5: type_25;

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
    var phi_2282_: bool;
    var phi_652_: type_39;
    var phi_655_: u32;
    var phi_657_: u32;
    var phi_659_: bool;
    var phi_661_: u32;
    var phi_672_: bool;
    var phi_704_: u32;
    var phi_705_: bool;
    var phi_706_: u32;
    var phi_1794_: type_44;
    var phi_2138_: u32;
    var phi_2166_: u32;
    var phi_2167_: u32;
    var phi_2168_: u32;
    var phi_2170_: u32;
    var phi_2171_: u32;
    var phi_2172_: bool;
    var phi_2181_: u32;
    var phi_2186_: u32;
    var phi_2187_: bool;
    var phi_721_: type_39;
    var phi_724_: type_4;
    var phi_725_: type_4;
    var phi_747_: type_4;
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
    var phi_1618_: bool;
    var phi_1642_: f32;
    var phi_1643_: f32;
    var phi_1666_: type_23;
    var phi_1668_: type_23;
    var phi_1669_: bool;
    var phi_1673_: type_23;
    var phi_1674_: type_23;
    var phi_1675_: type_23;
    var phi_1676_: bool;
    var phi_1680_: type_23;
    var phi_1681_: bool;
    var phi_1682_: type_23;
    var phi_1683_: bool;
    var phi_1684_: bool;
    var phi_1685_: type_23;
    var phi_1686_: bool;
    var phi_1687_: bool;
    var phi_1695_: type_23;
    var phi_1696_: bool;
    var phi_1700_: type_23;
    var phi_1725_: bool;
    var phi_1726_: bool;
    var phi_1732_: type_39;
    var phi_1733_: type_39;
    var phi_1734_: type_39;
    var phi_722_: type_39;
    var phi_2276_: bool;
    var phi_2422_: bool;
    var phi_2189_: type_39;
    var phi_2190_: u32;
    var phi_2191_: bool;
    var phi_2192_: u32;
    var phi_2421_: bool;
    var phi_2193_: type_39;
    var phi_2194_: u32;
    var phi_2195_: u32;
    var phi_2196_: bool;
    var phi_2197_: u32;
    var phi_2420_: bool;
    var phi_2198_: type_39;
    var phi_2199_: u32;
    var phi_2200_: u32;
    var phi_2201_: bool;
    var phi_2202_: u32;
    var phi_2419_: bool;
    var phi_653_: type_39;
    var phi_656_: u32;
    var phi_658_: u32;
    var phi_660_: bool;
    var phi_662_: u32;
    var phi_2203_: bool;
    var phi_2418_: bool;
    var local_2: type_39;
    var phi_2255_: type_23;
    var local_3: type_39;

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
                            phi_272_ = (bitcast<i32>((_e159 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_272_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e159)), 32u, (_e159 == 0u))));
                        }
                        let _e173 = phi_272_;
                        phi_273_ = _e173;
                    } else {
                        phi_273_ = 0i;
                    }
                    let _e175 = phi_273_;
                    let _e176 = (_e92 == _e131);
                    if _e176 {
                        phi_283_ = true;
                    } else {
                        phi_283_ = (_e99 == _e131);
                    }
                    let _e179 = phi_283_;
                    let _e180 = select(1u, 0u, _e176);
                    if _e179 {
                        let _e181 = (_e180 + 1u);
                        phi_293_ = _e181;
                        phi_294_ = _e181;
                        phi_296_ = select(true, false, (_e181 == 2u));
                    } else {
                        phi_293_ = u32();
                        phi_294_ = 0u;
                        phi_296_ = true;
                    }
                    let _e185 = phi_293_;
                    let _e187 = phi_294_;
                    let _e189 = phi_296_;
                    if _e189 {
                        phi_301_ = (_e187 + 1u);
                    } else {
                        phi_301_ = 0u;
                    }
                    let _e193 = phi_301_;
                    let _e194 = select(_e185, _e187, _e189);
                    let _e195 = select(_e180, select(2u, _e180, _e179), _e189);
                    if (_e80 < -126i) {
                        phi_313_ = -126i;
                    } else {
                        phi_313_ = select(_e80, 127i, (_e80 > 127i));
                    }
                    let _e200 = phi_313_;
                    let _e205 = bitcast<f32>((bitcast<u32>((_e200 + 127i)) << bitcast<u32>(23i)));
                    let _e211 = bitcast<f32>((bitcast<u32>(((_e80 - _e200) + 127i)) << bitcast<u32>(23i)));
                    let _e212 = -(_e175);
                    if (_e212 < -126i) {
                        phi_333_ = -126i;
                    } else {
                        phi_333_ = select(_e212, 127i, (_e212 > 127i));
                    }
                    let _e217 = phi_333_;
                    let _e222 = bitcast<f32>((bitcast<u32>((_e217 + 127i)) << bitcast<u32>(23i)));
                    let _e228 = bitcast<f32>((bitcast<u32>(((_e212 - _e217) + 127i)) << bitcast<u32>(23i)));
                    let _e232 = global_4.member[_e76].member;
                    let _e233 = (_e194 == 0u);
                    if _e233 {
                        phi_351_ = _e232[0];
                    } else {
                        phi_351_ = _e232[1];
                    }
                    let _e237 = phi_351_;
                    let _e238 = (_e194 == 2u);
                    if _e238 {
                        phi_357_ = _e232[2];
                    } else {
                        phi_357_ = _e237;
                    }
                    let _e241 = phi_357_;
                    let _e243 = ((_e241 * _e205) * _e211);
                    let _e244 = global_4.member[_e76].member_2;
                    if _e233 {
                        phi_368_ = _e244[0];
                    } else {
                        phi_368_ = _e244[1];
                    }
                    let _e248 = phi_368_;
                    if _e238 {
                        phi_374_ = _e244[2];
                    } else {
                        phi_374_ = _e248;
                    }
                    let _e251 = phi_374_;
                    let _e253 = ((_e251 * _e222) * _e228);
                    let _e257 = (bitcast<f32>((bitcast<u32>(_e253) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e257 {
                        let _e261 = (bitcast<f32>((bitcast<u32>(_e243) & 2147483647u)) * 0.00000011920929f);
                        phi_397_ = select(0.00000000000011368684f, _e261, (_e261 > 0.00000000000011368684f));
                    } else {
                        phi_397_ = 0f;
                    }
                    let _e265 = phi_397_;
                    let _e266 = (_e243 + _e265);
                    let _e267 = (_e243 - _e265);
                    let _e268 = select(_e253, 0f, _e257);
                    if _e257 {
                        phi_408_ = 38685626000000000000000000f;
                    } else {
                        phi_408_ = (1f / _e253);
                    }
                    let _e271 = phi_408_;
                    let _e272 = (_e193 == 0u);
                    if _e272 {
                        phi_417_ = _e232[0];
                    } else {
                        phi_417_ = _e232[1];
                    }
                    let _e276 = phi_417_;
                    let _e277 = (_e193 == 2u);
                    if _e277 {
                        phi_423_ = _e232[2];
                    } else {
                        phi_423_ = _e276;
                    }
                    let _e280 = phi_423_;
                    let _e282 = ((_e280 * _e205) * _e211);
                    if _e272 {
                        phi_434_ = _e244[0];
                    } else {
                        phi_434_ = _e244[1];
                    }
                    let _e286 = phi_434_;
                    if _e277 {
                        phi_440_ = _e244[2];
                    } else {
                        phi_440_ = _e286;
                    }
                    let _e289 = phi_440_;
                    let _e291 = ((_e289 * _e222) * _e228);
                    let _e295 = (bitcast<f32>((bitcast<u32>(_e291) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e295 {
                        let _e299 = (bitcast<f32>((bitcast<u32>(_e282) & 2147483647u)) * 0.00000011920929f);
                        phi_463_ = select(0.00000000000011368684f, _e299, (_e299 > 0.00000000000011368684f));
                    } else {
                        phi_463_ = 0f;
                    }
                    let _e303 = phi_463_;
                    let _e304 = (_e282 + _e303);
                    let _e305 = (_e282 - _e303);
                    let _e306 = select(_e291, 0f, _e295);
                    if _e295 {
                        phi_474_ = 38685626000000000000000000f;
                    } else {
                        phi_474_ = (1f / _e291);
                    }
                    let _e309 = phi_474_;
                    let _e310 = (_e195 == 0u);
                    if _e310 {
                        phi_483_ = _e232[0];
                    } else {
                        phi_483_ = _e232[1];
                    }
                    let _e314 = phi_483_;
                    let _e315 = (_e195 == 2u);
                    if _e315 {
                        phi_489_ = _e232[2];
                    } else {
                        phi_489_ = _e314;
                    }
                    let _e318 = phi_489_;
                    let _e320 = ((_e318 * _e205) * _e211);
                    if _e310 {
                        phi_500_ = _e244[0];
                    } else {
                        phi_500_ = _e244[1];
                    }
                    let _e324 = phi_500_;
                    if _e315 {
                        phi_506_ = _e244[2];
                    } else {
                        phi_506_ = _e324;
                    }
                    let _e327 = phi_506_;
                    let _e329 = ((_e327 * _e222) * _e228);
                    let _e333 = (bitcast<f32>((bitcast<u32>(_e329) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e333 {
                        let _e337 = (bitcast<f32>((bitcast<u32>(_e320) & 2147483647u)) * 0.00000011920929f);
                        phi_529_ = select(0.00000000000011368684f, _e337, (_e337 > 0.00000000000011368684f));
                    } else {
                        phi_529_ = 0f;
                    }
                    let _e341 = phi_529_;
                    let _e342 = (_e320 + _e341);
                    let _e343 = (_e320 - _e341);
                    let _e344 = select(_e329, 0f, _e333);
                    if _e333 {
                        phi_540_ = 38685626000000000000000000f;
                    } else {
                        phi_540_ = (1f / _e329);
                    }
                    let _e347 = phi_540_;
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
                        phi_640_ = select(-340282350000000000000000000000000000000f, _e388, (_e388 > -340282350000000000000000000000000000000f));
                        phi_641_ = select(-340282350000000000000000000000000000000f, _e381, (_e381 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_640_ = 0f;
                        phi_641_ = 1f;
                    }
                    let _e392 = phi_640_;
                    let _e394 = phi_641_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2282_ = false;
                    phi_652_ = type_39(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e392);
                    phi_655_ = select(0u, 2147483648u, (_e66 == 0u));
                    phi_657_ = ((3u * _e66) + 1u);
                    phi_659_ = (_e394 <= _e392);
                    phi_661_ = 0u;
                    loop {
                        let _e402 = phi_2282_;
                        let _e404 = phi_652_;
                        let _e406 = phi_655_;
                        let _e408 = phi_657_;
                        let _e410 = phi_659_;
                        let _e412 = phi_661_;
                        local_2 = _e404;
                        if _e410 {
                            phi_672_ = true;
                        } else {
                            phi_672_ = (_e412 > 0u);
                        }
                        let _e415 = phi_672_;
                        if _e415 {
                            let _e416 = (_e408 > 0u);
                            if _e416 {
                                if _e410 {
                                    phi_704_ = _e406;
                                    phi_705_ = _e410;
                                    phi_706_ = _e412;
                                } else {
                                    let _e417 = (_e412 - 1u);
                                    let _e418 = (_e417 % 128u);
                                    let _e419 = (_e418 < 128u);
                                    if _e419 {
                                    } else {
                                        phi_2418_ = true;
                                        break;
                                    }
                                    let _e421 = local_1[_e418];
                                    if _e419 {
                                    } else {
                                        phi_2418_ = true;
                                        break;
                                    }
                                    let _e423 = local[_e418];
                                    phi_704_ = _e421;
                                    phi_705_ = (_e423 <= _e404.member_1);
                                    phi_706_ = _e417;
                                }
                                let _e427 = phi_704_;
                                let _e429 = phi_705_;
                                let _e431 = phi_706_;
                                if _e429 {
                                    if ((_e427 & 2147483648u) != 0u) {
                                        phi_721_ = _e404;
                                        phi_724_ = type_4(0u, ((_e427 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e629 = phi_721_;
                                            let _e631 = phi_724_;
                                            local_3 = _e629;
                                            if (_e631.member < _e631.member_1) {
                                                phi_725_ = type_4((_e631.member + 1u), _e631.member_1);
                                                phi_747_ = type_4(1u, _e631.member);
                                            } else {
                                                phi_725_ = _e631;
                                                phi_747_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e644 = phi_725_;
                                            let _e646 = phi_747_;
                                            let _e650 = (bitcast<i32>(_e646.member) != 0i);
                                            if _e650 {
                                                let _e651 = ((_e427 & 268435455u) + _e646.member_1);
                                                let _e652 = (_e651 < _e68);
                                                if _e652 {
                                                    if _e652 {
                                                    } else {
                                                        phi_2276_ = true;
                                                        break;
                                                    }
                                                    let _e656 = global_3.member[_e651].member_1;
                                                    phi_768_ = _e656;
                                                } else {
                                                    phi_768_ = 4294967295u;
                                                }
                                                let _e658 = phi_768_;
                                                if (_e651 >= _e68) {
                                                    phi_857_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e652 {
                                                    } else {
                                                        phi_2276_ = true;
                                                        break;
                                                    }
                                                    let _e660 = (_e194 % 3u);
                                                    let _e661 = (_e193 % 3u);
                                                    let _e662 = (_e195 % 3u);
                                                    if (_e660 < 9u) {
                                                    } else {
                                                        phi_2276_ = true;
                                                        break;
                                                    }
                                                    let _e668 = global_3.member[_e651].member[_e660];
                                                    if (_e661 < 9u) {
                                                    } else {
                                                        phi_2276_ = true;
                                                        break;
                                                    }
                                                    let _e674 = global_3.member[_e651].member[_e661];
                                                    if (_e662 < 9u) {
                                                    } else {
                                                        phi_2276_ = true;
                                                        break;
                                                    }
                                                    let _e680 = global_3.member[_e651].member[_e662];
                                                    let _e682 = (3u + _e660);
                                                    if (_e682 < 9u) {
                                                    } else {
                                                        phi_2276_ = true;
                                                        break;
                                                    }
                                                    let _e688 = global_3.member[_e651].member[_e682];
                                                    let _e689 = (3u + _e661);
                                                    if (_e689 < 9u) {
                                                    } else {
                                                        phi_2276_ = true;
                                                        break;
                                                    }
                                                    let _e695 = global_3.member[_e651].member[_e689];
                                                    let _e696 = (3u + _e662);
                                                    if (_e696 < 9u) {
                                                    } else {
                                                        phi_2276_ = true;
                                                        break;
                                                    }
                                                    let _e702 = global_3.member[_e651].member[_e696];
                                                    let _e704 = (6u + _e660);
                                                    if (_e704 < 9u) {
                                                    } else {
                                                        phi_2276_ = true;
                                                        break;
                                                    }
                                                    let _e710 = global_3.member[_e651].member[_e704];
                                                    let _e711 = (6u + _e661);
                                                    if (_e711 < 9u) {
                                                    } else {
                                                        phi_2276_ = true;
                                                        break;
                                                    }
                                                    let _e717 = global_3.member[_e651].member[_e711];
                                                    let _e718 = (6u + _e662);
                                                    if (_e718 < 9u) {
                                                    } else {
                                                        phi_2276_ = true;
                                                        break;
                                                    }
                                                    let _e724 = global_3.member[_e651].member[_e718];
                                                    phi_857_ = array<array<f32, 3>, 3>(array<f32, 3>(_e668, _e674, _e680), array<f32, 3>(_e688, _e695, _e702), array<f32, 3>(_e710, _e717, _e724));
                                                }
                                                let _e728 = phi_857_;
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
                                                        phi_1685_ = type_23();
                                                        phi_1686_ = true;
                                                        phi_1687_ = false;
                                                    } else {
                                                        let _e803 = select(_e752, _e739, (_e739 < _e752));
                                                        if (select(_e765, _e803, (_e803 < _e765)) > 0f) {
                                                            phi_974_ = true;
                                                        } else {
                                                            let _e808 = select(_e752, _e739, (_e739 > _e752));
                                                            phi_974_ = (select(_e765, _e808, (_e808 > _e765)) < 0f);
                                                        }
                                                        let _e813 = phi_974_;
                                                        if _e813 {
                                                            phi_1682_ = type_23();
                                                            phi_1683_ = true;
                                                            phi_1684_ = false;
                                                        } else {
                                                            let _e815 = select(_e755, _e742, (_e742 < _e755));
                                                            if (select(_e768, _e815, (_e815 < _e768)) > 0f) {
                                                                phi_1003_ = true;
                                                            } else {
                                                                let _e820 = select(_e755, _e742, (_e742 > _e755));
                                                                phi_1003_ = (select(_e768, _e820, (_e820 > _e768)) < 0f);
                                                            }
                                                            let _e825 = phi_1003_;
                                                            if _e825 {
                                                                phi_1680_ = type_23();
                                                                phi_1681_ = false;
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
                                                                    phi_1675_ = type_23();
                                                                    phi_1676_ = true;
                                                                } else {
                                                                    let _e890 = (_e888 > _e629.member_1);
                                                                    if _e890 {
                                                                        phi_1674_ = type_23();
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
                                                                            phi_1404_ = _e755;
                                                                            phi_1405_ = _e752;
                                                                            phi_1406_ = _e742;
                                                                            phi_1407_ = _e739;
                                                                            phi_1408_ = _e891;
                                                                            phi_1409_ = _e905;
                                                                            phi_1410_ = _e901;
                                                                            phi_1411_ = _e897;
                                                                        } else {
                                                                            let _e950 = (_e931 == _e948);
                                                                            let _e955 = vec3(_e950);
                                                                            phi_1404_ = select(_e742, _e768, _e950);
                                                                            phi_1405_ = select(_e739, _e765, _e950);
                                                                            phi_1406_ = select(_e768, _e755, _e950);
                                                                            phi_1407_ = select(_e765, _e752, _e950);
                                                                            phi_1408_ = select(_e893, _e892, _e955);
                                                                            phi_1409_ = select(_e901, _e897, _e955);
                                                                            phi_1410_ = select(_e897, _e905, _e955);
                                                                            phi_1411_ = select(_e905, _e901, _e955);
                                                                        }
                                                                        let _e961 = phi_1404_;
                                                                        let _e963 = phi_1405_;
                                                                        let _e965 = phi_1406_;
                                                                        let _e967 = phi_1407_;
                                                                        let _e969 = phi_1408_;
                                                                        let _e971 = phi_1409_;
                                                                        let _e973 = phi_1410_;
                                                                        let _e975 = phi_1411_;
                                                                        let _e982 = ((_e973.y * _e971.z) - (_e971.y * _e973.z));
                                                                        let _e987 = ((_e973.z * _e971.x) - (_e971.z * _e973.x));
                                                                        let _e990 = ((_e973.x * _e971.y) - (_e971.x * _e973.y));
                                                                        if (_e790 >= _e794) {
                                                                            phi_1442_ = select(true, false, (_e790 >= _e798));
                                                                        } else {
                                                                            phi_1442_ = true;
                                                                        }
                                                                        let _e995 = phi_1442_;
                                                                        if _e995 {
                                                                            phi_1451_ = select(_e893, _e892, vec3((_e794 >= _e798)));
                                                                        } else {
                                                                            phi_1451_ = _e891;
                                                                        }
                                                                        let _e1000 = phi_1451_;
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
                                                                            phi_1618_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1005) & 2147483647u)) > ((0.0000038146973f * select(_e1101, _e1098, (_e1098 > _e1101))) * select(_e1115, _e1112, (_e1112 > _e1115)))));
                                                                        } else {
                                                                            phi_1618_ = true;
                                                                        }
                                                                        let _e1122 = phi_1618_;
                                                                        if _e1122 {
                                                                            let _e1133 = ((((_e982 * (_e1044 - (_e268 * _e1047))) + (_e987 * (_e1045 - (_e306 * _e1047)))) + (_e990 * (_e1046 - _e1046))) / _e1005);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1133) & 2147483647u)) <= _e948) {
                                                                                phi_1642_ = (_e1047 + _e1133);
                                                                            } else {
                                                                                phi_1642_ = _e1047;
                                                                            }
                                                                            let _e1140 = phi_1642_;
                                                                            phi_1643_ = _e1140;
                                                                        } else {
                                                                            phi_1643_ = (_e1016 / _e1005);
                                                                        }
                                                                        let _e1142 = phi_1643_;
                                                                        let _e1144 = select(_e881, _e1142, (_e1142 < _e881));
                                                                        let _e1146 = select(_e873, _e1144, (_e1144 > _e873));
                                                                        if (_e1146 >= _e394) {
                                                                            let _e1148 = (_e1146 <= _e629.member_1);
                                                                            if _e1148 {
                                                                                let _e1149 = (1f / _e800);
                                                                                phi_1666_ = type_23(_e1146, (_e794 * _e1149), (_e798 * _e1149), _e658);
                                                                            } else {
                                                                                phi_1666_ = type_23();
                                                                            }
                                                                            let _e1154 = phi_1666_;
                                                                            phi_1668_ = _e1154;
                                                                            phi_1669_ = select(true, false, _e1148);
                                                                        } else {
                                                                            phi_1668_ = type_23();
                                                                            phi_1669_ = true;
                                                                        }
                                                                        let _e1157 = phi_1668_;
                                                                        let _e1159 = phi_1669_;
                                                                        if _e1159 {
                                                                            phi_1673_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1673_ = _e1157;
                                                                        }
                                                                        let _e1161 = phi_1673_;
                                                                        phi_1674_ = _e1161;
                                                                    }
                                                                    let _e1163 = phi_1674_;
                                                                    phi_1675_ = _e1163;
                                                                    phi_1676_ = _e890;
                                                                }
                                                                let _e1165 = phi_1675_;
                                                                let _e1167 = phi_1676_;
                                                                phi_1680_ = _e1165;
                                                                phi_1681_ = _e1167;
                                                            }
                                                            let _e1169 = phi_1680_;
                                                            let _e1171 = phi_1681_;
                                                            phi_1682_ = _e1169;
                                                            phi_1683_ = _e825;
                                                            phi_1684_ = _e1171;
                                                        }
                                                        let _e1173 = phi_1682_;
                                                        let _e1175 = phi_1683_;
                                                        let _e1177 = phi_1684_;
                                                        phi_1685_ = _e1173;
                                                        phi_1686_ = _e1175;
                                                        phi_1687_ = _e1177;
                                                    }
                                                    let _e1179 = phi_1685_;
                                                    let _e1181 = phi_1686_;
                                                    let _e1183 = phi_1687_;
                                                    phi_1695_ = _e1179;
                                                    phi_1696_ = select(_e1183, true, _e1181);
                                                } else {
                                                    phi_1695_ = type_23();
                                                    phi_1696_ = true;
                                                }
                                                let _e1186 = phi_1695_;
                                                let _e1188 = phi_1696_;
                                                if _e1188 {
                                                    phi_1700_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1700_ = _e1186;
                                                }
                                                let _e1190 = phi_1700_;
                                                if (_e1190.member_3 != 4294967295u) {
                                                    if (_e658 != 4294967295u) {
                                                        if (_e1190.member < _e629.member.member) {
                                                            phi_1726_ = true;
                                                        } else {
                                                            if (_e1190.member == _e629.member.member) {
                                                                phi_1725_ = (_e1190.member_3 < _e629.member.member_3);
                                                            } else {
                                                                phi_1725_ = false;
                                                            }
                                                            let _e1203 = phi_1725_;
                                                            phi_1726_ = _e1203;
                                                        }
                                                        let _e1205 = phi_1726_;
                                                        if _e1205 {
                                                            phi_1732_ = type_39(_e1190, _e1190.member);
                                                        } else {
                                                            phi_1732_ = _e629;
                                                        }
                                                        let _e1208 = phi_1732_;
                                                        phi_1733_ = _e1208;
                                                    } else {
                                                        phi_1733_ = _e629;
                                                    }
                                                    let _e1210 = phi_1733_;
                                                    phi_1734_ = _e1210;
                                                } else {
                                                    phi_1734_ = _e629;
                                                }
                                                let _e1212 = phi_1734_;
                                                phi_722_ = _e1212;
                                            } else {
                                                phi_722_ = type_39();
                                            }
                                            let _e1214 = phi_722_;
                                            continue;
                                            continuing {
                                                phi_721_ = _e1214;
                                                phi_724_ = _e644;
                                                phi_2276_ = _e402;
                                                break if !(_e650);
                                            }
                                        }
                                        let _e1217 = phi_2276_;
                                        phi_2418_ = _e1217;
                                        if _e1217 {
                                            break;
                                        }
                                        phi_2422_ = _e1217;
                                        let _e1402 = local_3;
                                        phi_2189_ = _e1402;
                                        phi_2190_ = _e427;
                                        phi_2191_ = false;
                                        phi_2192_ = _e431;
                                    } else {
                                        if (_e427 >= _e66) {
                                            phi_1794_ = type_44(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e427 < _e66) {
                                            } else {
                                                phi_2418_ = true;
                                                break;
                                            }
                                            let _e441 = (_e194 % 3u);
                                            if (_e441 < 3u) {
                                            } else {
                                                phi_2418_ = true;
                                                break;
                                            }
                                            let _e447 = global_2.member[_e427].member[_e441];
                                            let _e453 = (_e193 % 3u);
                                            if (_e453 < 3u) {
                                            } else {
                                                phi_2418_ = true;
                                                break;
                                            }
                                            let _e459 = global_2.member[_e427].member[_e453];
                                            let _e465 = (_e195 % 3u);
                                            if (_e465 < 3u) {
                                            } else {
                                                phi_2418_ = true;
                                                break;
                                            }
                                            let _e471 = global_2.member[_e427].member[_e465];
                                            let _e481 = global_2.member[_e427].member_1;
                                            let _e485 = global_2.member[_e427].member_2;
                                            phi_1794_ = type_44(array<vec4<f32>, 3>(vec4<f32>(_e447[0], _e447[1], _e447[2], _e447[3]), vec4<f32>(_e459[0], _e459[1], _e459[2], _e459[3]), vec4<f32>(_e471[0], _e471[1], _e471[2], _e471[3])), _e481, _e485);
                                        }
                                        let _e488 = phi_1794_;
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
                                        let _e588 = (_e581 <= select(_e404.member_1, _e578, (_e578 < _e404.member_1)));
                                        let _e589 = (_e583 <= select(_e404.member_1, _e579, (_e579 < _e404.member_1)));
                                        let _e590 = (_e581 <= _e583);
                                        if _e588 {
                                            if _e589 {
                                                if _e590 {
                                                    phi_2138_ = _e488.member_2;
                                                } else {
                                                    phi_2138_ = _e488.member_1;
                                                }
                                                let _e594 = phi_2138_;
                                                let _e597 = (_e431 % 128u);
                                                let _e598 = (_e597 < 128u);
                                                if _e598 {
                                                } else {
                                                    phi_2418_ = true;
                                                    break;
                                                }
                                                local_1[_e597] = _e594;
                                                if _e598 {
                                                } else {
                                                    phi_2418_ = true;
                                                    break;
                                                }
                                                local[_e597] = select(_e583, _e581, (_e581 > _e583));
                                                if _e590 {
                                                    phi_2166_ = _e488.member_1;
                                                } else {
                                                    phi_2166_ = _e488.member_2;
                                                }
                                                let _e605 = phi_2166_;
                                                phi_2167_ = _e605;
                                                phi_2168_ = (_e431 + 1u);
                                            } else {
                                                phi_2167_ = u32();
                                                phi_2168_ = u32();
                                            }
                                            let _e607 = phi_2167_;
                                            let _e609 = phi_2168_;
                                            phi_2170_ = _e607;
                                            phi_2171_ = _e609;
                                            phi_2172_ = select(true, false, _e589);
                                        } else {
                                            phi_2170_ = u32();
                                            phi_2171_ = u32();
                                            phi_2172_ = true;
                                        }
                                        let _e612 = phi_2170_;
                                        let _e614 = phi_2171_;
                                        let _e616 = phi_2172_;
                                        if _e616 {
                                            if _e588 {
                                                phi_2181_ = _e488.member_1;
                                            } else {
                                                phi_2181_ = _e488.member_2;
                                            }
                                            let _e620 = phi_2181_;
                                            phi_2186_ = _e620;
                                            phi_2187_ = select(_e589, true, _e588);
                                        } else {
                                            phi_2186_ = _e612;
                                            phi_2187_ = _e429;
                                        }
                                        let _e623 = phi_2186_;
                                        let _e625 = phi_2187_;
                                        phi_2422_ = _e402;
                                        phi_2189_ = _e404;
                                        phi_2190_ = _e623;
                                        phi_2191_ = _e625;
                                        phi_2192_ = select(_e614, _e431, _e616);
                                    }
                                    let _e1219 = phi_2422_;
                                    let _e1221 = phi_2189_;
                                    let _e1223 = phi_2190_;
                                    let _e1225 = phi_2191_;
                                    let _e1227 = phi_2192_;
                                    phi_2421_ = _e1219;
                                    phi_2193_ = _e1221;
                                    phi_2194_ = _e1223;
                                    phi_2195_ = (_e408 - 1u);
                                    phi_2196_ = _e1225;
                                    phi_2197_ = _e1227;
                                } else {
                                    phi_2421_ = _e402;
                                    phi_2193_ = _e404;
                                    phi_2194_ = _e427;
                                    phi_2195_ = _e408;
                                    phi_2196_ = _e429;
                                    phi_2197_ = _e431;
                                }
                                let _e1229 = phi_2421_;
                                let _e1231 = phi_2193_;
                                let _e1233 = phi_2194_;
                                let _e1235 = phi_2195_;
                                let _e1237 = phi_2196_;
                                let _e1239 = phi_2197_;
                                phi_2420_ = _e1229;
                                phi_2198_ = _e1231;
                                phi_2199_ = _e1233;
                                phi_2200_ = _e1235;
                                phi_2201_ = _e1237;
                                phi_2202_ = _e1239;
                            } else {
                                phi_2420_ = _e402;
                                phi_2198_ = type_39();
                                phi_2199_ = u32();
                                phi_2200_ = u32();
                                phi_2201_ = bool();
                                phi_2202_ = u32();
                            }
                            let _e1241 = phi_2420_;
                            let _e1243 = phi_2198_;
                            let _e1245 = phi_2199_;
                            let _e1247 = phi_2200_;
                            let _e1249 = phi_2201_;
                            let _e1251 = phi_2202_;
                            phi_2419_ = _e1241;
                            phi_653_ = _e1243;
                            phi_656_ = _e1245;
                            phi_658_ = _e1247;
                            phi_660_ = _e1249;
                            phi_662_ = _e1251;
                            phi_2203_ = _e416;
                        } else {
                            phi_2419_ = _e402;
                            phi_653_ = type_39();
                            phi_656_ = u32();
                            phi_658_ = u32();
                            phi_660_ = bool();
                            phi_662_ = u32();
                            phi_2203_ = false;
                        }
                        let _e1253 = phi_2419_;
                        let _e1255 = phi_653_;
                        let _e1257 = phi_656_;
                        let _e1259 = phi_658_;
                        let _e1261 = phi_660_;
                        let _e1263 = phi_662_;
                        let _e1265 = phi_2203_;
                        continue;
                        continuing {
                            phi_2282_ = _e1253;
                            phi_652_ = _e1255;
                            phi_655_ = _e1257;
                            phi_657_ = _e1259;
                            phi_659_ = _e1261;
                            phi_661_ = _e1263;
                            phi_2418_ = _e1253;
                            break if !(_e1265);
                        }
                    }
                    let _e1268 = phi_2418_;
                    if _e1268 {
                        break;
                    }
                    let _e1270 = local_2;
                    if (_e1270.member.member_3 != 4294967295u) {
                        let _e1275 = -(_e361);
                        let _e1276 = (_e1275 / 3i);
                        let _e1283 = bitcast<f32>((bitcast<u32>((_e1276 + 127i)) << bitcast<u32>(23i)));
                        let _e1291 = (((_e1270.member.member * _e1283) * _e1283) * bitcast<f32>((bitcast<u32>(((_e1275 - (2i * _e1276)) + 127i)) << bitcast<u32>(23i))));
                        let _e1293 = select(340282350000000000000000000000000000000f, _e1291, (_e1291 < 340282350000000000000000000000000000000f));
                        phi_2255_ = type_23(select(-340282350000000000000000000000000000000f, _e1293, (_e1293 > -340282350000000000000000000000000000000f)), _e1270.member.member_1, _e1270.member.member_2, _e1270.member.member_3);
                    } else {
                        phi_2255_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1300 = phi_2255_;
                    if _e82 {
                    } else {
                        break;
                    }
                    global_5.member[_e76] = _e1300;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
