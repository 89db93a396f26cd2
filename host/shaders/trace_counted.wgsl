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
    var phi_274_: i32;
    var phi_275_: i32;
    var phi_285_: bool;
    var phi_295_: u32;
    var phi_296_: u32;
    var phi_298_: bool;
    var phi_303_: u32;
    var phi_315_: i32;
    var phi_335_: i32;
    var phi_353_: f32;
    var phi_359_: f32;
    var phi_370_: f32;
    var phi_376_: f32;
    var phi_399_: f32;
    var phi_410_: f32;
    var phi_419_: f32;
    var phi_425_: f32;
    var phi_436_: f32;
    var phi_442_: f32;
    var phi_465_: f32;
    var phi_476_: f32;
    var phi_485_: f32;
    var phi_491_: f32;
    var phi_502_: f32;
    var phi_508_: f32;
    var phi_531_: f32;
    var phi_542_: f32;
    var phi_642_: f32;
    var phi_643_: f32;
    var phi_2248_: bool;
    var phi_655_: type_48;
    var phi_658_: u32;
    var phi_660_: u32;
    var phi_662_: bool;
    var phi_664_: u32;
    var phi_675_: bool;
    var phi_707_: u32;
    var phi_708_: bool;
    var phi_709_: u32;
    var phi_1804_: type_44;
    var phi_2148_: u32;
    var phi_2176_: u32;
    var phi_2177_: u32;
    var phi_2178_: u32;
    var phi_2180_: u32;
    var phi_2181_: u32;
    var phi_2182_: bool;
    var phi_2191_: u32;
    var phi_2196_: u32;
    var phi_2197_: bool;
    var phi_724_: type_48;
    var phi_727_: type_4;
    var phi_728_: type_4;
    var phi_750_: type_4;
    var phi_774_: u32;
    var phi_863_: array<array<f32, 3>, 3>;
    var phi_980_: bool;
    var phi_1009_: bool;
    var phi_1410_: f32;
    var phi_1411_: f32;
    var phi_1412_: f32;
    var phi_1413_: f32;
    var phi_1414_: vec3<f32>;
    var phi_1415_: vec3<f32>;
    var phi_1416_: vec3<f32>;
    var phi_1417_: vec3<f32>;
    var phi_1448_: bool;
    var phi_1457_: vec3<f32>;
    var phi_1624_: bool;
    var phi_1648_: f32;
    var phi_1649_: f32;
    var phi_1672_: type_27;
    var phi_1674_: type_27;
    var phi_1675_: bool;
    var phi_1679_: type_27;
    var phi_1680_: type_27;
    var phi_1681_: type_27;
    var phi_1682_: bool;
    var phi_1686_: type_27;
    var phi_1687_: bool;
    var phi_1688_: type_27;
    var phi_1689_: bool;
    var phi_1690_: bool;
    var phi_1691_: type_27;
    var phi_1692_: bool;
    var phi_1693_: bool;
    var phi_1701_: type_27;
    var phi_1702_: bool;
    var phi_1706_: type_27;
    var phi_1731_: bool;
    var phi_1732_: bool;
    var phi_1739_: type_48;
    var phi_1740_: type_48;
    var phi_1741_: type_48;
    var phi_725_: type_48;
    var phi_2242_: bool;
    var phi_2388_: bool;
    var phi_2199_: type_48;
    var phi_2200_: u32;
    var phi_2201_: bool;
    var phi_2202_: u32;
    var phi_2387_: bool;
    var phi_2203_: type_48;
    var phi_2204_: u32;
    var phi_2205_: u32;
    var phi_2206_: bool;
    var phi_2207_: u32;
    var phi_2386_: bool;
    var phi_2208_: type_48;
    var phi_2209_: u32;
    var phi_2210_: u32;
    var phi_2211_: bool;
    var phi_2212_: u32;
    var phi_2385_: bool;
    var phi_656_: type_48;
    var phi_659_: u32;
    var phi_661_: u32;
    var phi_663_: bool;
    var phi_665_: u32;
    var phi_2213_: bool;
    var phi_2384_: bool;
    var local_2: type_48;
    var local_3: type_48;
    var local_4: type_48;

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
                            phi_274_ = (bitcast<i32>((_e159 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_274_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e159)), 32u, (_e159 == 0u))));
                        }
                        let _e173 = phi_274_;
                        phi_275_ = _e173;
                    } else {
                        phi_275_ = 0i;
                    }
                    let _e175 = phi_275_;
                    let _e176 = (_e92 == _e131);
                    if _e176 {
                        phi_285_ = true;
                    } else {
                        phi_285_ = (_e99 == _e131);
                    }
                    let _e179 = phi_285_;
                    let _e180 = select(1u, 0u, _e176);
                    if _e179 {
                        let _e181 = (_e180 + 1u);
                        phi_295_ = _e181;
                        phi_296_ = _e181;
                        phi_298_ = select(true, false, (_e181 == 2u));
                    } else {
                        phi_295_ = u32();
                        phi_296_ = 0u;
                        phi_298_ = true;
                    }
                    let _e185 = phi_295_;
                    let _e187 = phi_296_;
                    let _e189 = phi_298_;
                    if _e189 {
                        phi_303_ = (_e187 + 1u);
                    } else {
                        phi_303_ = 0u;
                    }
                    let _e193 = phi_303_;
                    let _e194 = select(_e185, _e187, _e189);
                    let _e195 = select(_e180, select(2u, _e180, _e179), _e189);
                    if (_e80 < -126i) {
                        phi_315_ = -126i;
                    } else {
                        phi_315_ = select(_e80, 127i, (_e80 > 127i));
                    }
                    let _e200 = phi_315_;
                    let _e205 = bitcast<f32>((bitcast<u32>((_e200 + 127i)) << bitcast<u32>(23i)));
                    let _e211 = bitcast<f32>((bitcast<u32>(((_e80 - _e200) + 127i)) << bitcast<u32>(23i)));
                    let _e212 = -(_e175);
                    if (_e212 < -126i) {
                        phi_335_ = -126i;
                    } else {
                        phi_335_ = select(_e212, 127i, (_e212 > 127i));
                    }
                    let _e217 = phi_335_;
                    let _e222 = bitcast<f32>((bitcast<u32>((_e217 + 127i)) << bitcast<u32>(23i)));
                    let _e228 = bitcast<f32>((bitcast<u32>(((_e212 - _e217) + 127i)) << bitcast<u32>(23i)));
                    let _e232 = global_4.member[_e76].member;
                    let _e233 = (_e194 == 0u);
                    if _e233 {
                        phi_353_ = _e232[0];
                    } else {
                        phi_353_ = _e232[1];
                    }
                    let _e237 = phi_353_;
                    let _e238 = (_e194 == 2u);
                    if _e238 {
                        phi_359_ = _e232[2];
                    } else {
                        phi_359_ = _e237;
                    }
                    let _e241 = phi_359_;
                    let _e243 = ((_e241 * _e205) * _e211);
                    let _e244 = global_4.member[_e76].member_2;
                    if _e233 {
                        phi_370_ = _e244[0];
                    } else {
                        phi_370_ = _e244[1];
                    }
                    let _e248 = phi_370_;
                    if _e238 {
                        phi_376_ = _e244[2];
                    } else {
                        phi_376_ = _e248;
                    }
                    let _e251 = phi_376_;
                    let _e253 = ((_e251 * _e222) * _e228);
                    let _e257 = (bitcast<f32>((bitcast<u32>(_e253) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e257 {
                        let _e261 = (bitcast<f32>((bitcast<u32>(_e243) & 2147483647u)) * 0.00000011920929f);
                        phi_399_ = select(0.00000000000011368684f, _e261, (_e261 > 0.00000000000011368684f));
                    } else {
                        phi_399_ = 0f;
                    }
                    let _e265 = phi_399_;
                    let _e266 = (_e243 + _e265);
                    let _e267 = (_e243 - _e265);
                    let _e268 = select(_e253, 0f, _e257);
                    if _e257 {
                        phi_410_ = 38685626000000000000000000f;
                    } else {
                        phi_410_ = (1f / _e253);
                    }
                    let _e271 = phi_410_;
                    let _e272 = (_e193 == 0u);
                    if _e272 {
                        phi_419_ = _e232[0];
                    } else {
                        phi_419_ = _e232[1];
                    }
                    let _e276 = phi_419_;
                    let _e277 = (_e193 == 2u);
                    if _e277 {
                        phi_425_ = _e232[2];
                    } else {
                        phi_425_ = _e276;
                    }
                    let _e280 = phi_425_;
                    let _e282 = ((_e280 * _e205) * _e211);
                    if _e272 {
                        phi_436_ = _e244[0];
                    } else {
                        phi_436_ = _e244[1];
                    }
                    let _e286 = phi_436_;
                    if _e277 {
                        phi_442_ = _e244[2];
                    } else {
                        phi_442_ = _e286;
                    }
                    let _e289 = phi_442_;
                    let _e291 = ((_e289 * _e222) * _e228);
                    let _e295 = (bitcast<f32>((bitcast<u32>(_e291) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e295 {
                        let _e299 = (bitcast<f32>((bitcast<u32>(_e282) & 2147483647u)) * 0.00000011920929f);
                        phi_465_ = select(0.00000000000011368684f, _e299, (_e299 > 0.00000000000011368684f));
                    } else {
                        phi_465_ = 0f;
                    }
                    let _e303 = phi_465_;
                    let _e304 = (_e282 + _e303);
                    let _e305 = (_e282 - _e303);
                    let _e306 = select(_e291, 0f, _e295);
                    if _e295 {
                        phi_476_ = 38685626000000000000000000f;
                    } else {
                        phi_476_ = (1f / _e291);
                    }
                    let _e309 = phi_476_;
                    let _e310 = (_e195 == 0u);
                    if _e310 {
                        phi_485_ = _e232[0];
                    } else {
                        phi_485_ = _e232[1];
                    }
                    let _e314 = phi_485_;
                    let _e315 = (_e195 == 2u);
                    if _e315 {
                        phi_491_ = _e232[2];
                    } else {
                        phi_491_ = _e314;
                    }
                    let _e318 = phi_491_;
                    let _e320 = ((_e318 * _e205) * _e211);
                    if _e310 {
                        phi_502_ = _e244[0];
                    } else {
                        phi_502_ = _e244[1];
                    }
                    let _e324 = phi_502_;
                    if _e315 {
                        phi_508_ = _e244[2];
                    } else {
                        phi_508_ = _e324;
                    }
                    let _e327 = phi_508_;
                    let _e329 = ((_e327 * _e222) * _e228);
                    let _e333 = (bitcast<f32>((bitcast<u32>(_e329) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e333 {
                        let _e337 = (bitcast<f32>((bitcast<u32>(_e320) & 2147483647u)) * 0.00000011920929f);
                        phi_531_ = select(0.00000000000011368684f, _e337, (_e337 > 0.00000000000011368684f));
                    } else {
                        phi_531_ = 0f;
                    }
                    let _e341 = phi_531_;
                    let _e342 = (_e320 + _e341);
                    let _e343 = (_e320 - _e341);
                    let _e344 = select(_e329, 0f, _e333);
                    if _e333 {
                        phi_542_ = 38685626000000000000000000f;
                    } else {
                        phi_542_ = (1f / _e329);
                    }
                    let _e347 = phi_542_;
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
                        phi_642_ = select(-340282350000000000000000000000000000000f, _e388, (_e388 > -340282350000000000000000000000000000000f));
                        phi_643_ = select(-340282350000000000000000000000000000000f, _e381, (_e381 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_642_ = 0f;
                        phi_643_ = 1f;
                    }
                    let _e392 = phi_642_;
                    let _e394 = phi_643_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2248_ = false;
                    phi_655_ = type_48(type_39(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e392), 0u, 0u);
                    phi_658_ = select(0u, 2147483648u, (_e66 == 0u));
                    phi_660_ = ((3u * _e66) + 1u);
                    phi_662_ = (_e394 <= _e392);
                    phi_664_ = 0u;
                    loop {
                        let _e403 = phi_2248_;
                        let _e405 = phi_655_;
                        let _e407 = phi_658_;
                        let _e409 = phi_660_;
                        let _e411 = phi_662_;
                        let _e413 = phi_664_;
                        local_2 = _e405;
                        local_3 = _e405;
                        if _e411 {
                            phi_675_ = true;
                        } else {
                            phi_675_ = (_e413 > 0u);
                        }
                        let _e416 = phi_675_;
                        if _e416 {
                            let _e417 = (_e409 > 0u);
                            if _e417 {
                                if _e411 {
                                    phi_707_ = _e407;
                                    phi_708_ = _e411;
                                    phi_709_ = _e413;
                                } else {
                                    let _e418 = (_e413 - 1u);
                                    let _e419 = (_e418 % 128u);
                                    let _e420 = (_e419 < 128u);
                                    if _e420 {
                                    } else {
                                        phi_2384_ = true;
                                        break;
                                    }
                                    let _e422 = local_1[_e419];
                                    if _e420 {
                                    } else {
                                        phi_2384_ = true;
                                        break;
                                    }
                                    let _e424 = local[_e419];
                                    phi_707_ = _e422;
                                    phi_708_ = (_e424 <= _e405.member.member_1);
                                    phi_709_ = _e418;
                                }
                                let _e429 = phi_707_;
                                let _e431 = phi_708_;
                                let _e433 = phi_709_;
                                if _e431 {
                                    if ((_e429 & 2147483648u) != 0u) {
                                        phi_724_ = _e405;
                                        phi_727_ = type_4(0u, ((_e429 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e638 = phi_724_;
                                            let _e640 = phi_727_;
                                            local_4 = _e638;
                                            if (_e640.member < _e640.member_1) {
                                                phi_728_ = type_4((_e640.member + 1u), _e640.member_1);
                                                phi_750_ = type_4(1u, _e640.member);
                                            } else {
                                                phi_728_ = _e640;
                                                phi_750_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e653 = phi_728_;
                                            let _e655 = phi_750_;
                                            let _e659 = (bitcast<i32>(_e655.member) != 0i);
                                            if _e659 {
                                                let _e665 = type_48(_e638.member, _e638.member_1, (_e638.member_2 + 1u));
                                                let _e666 = ((_e429 & 268435455u) + _e655.member_1);
                                                let _e667 = (_e666 < _e68);
                                                if _e667 {
                                                    if _e667 {
                                                    } else {
                                                        phi_2242_ = true;
                                                        break;
                                                    }
                                                    let _e671 = global_3.member[_e666].member_1;
                                                    phi_774_ = _e671;
                                                } else {
                                                    phi_774_ = 4294967295u;
                                                }
                                                let _e673 = phi_774_;
                                                if (_e666 >= _e68) {
                                                    phi_863_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e667 {
                                                    } else {
                                                        phi_2242_ = true;
                                                        break;
                                                    }
                                                    let _e675 = (_e194 % 3u);
                                                    let _e676 = (_e193 % 3u);
                                                    let _e677 = (_e195 % 3u);
                                                    if (_e675 < 9u) {
                                                    } else {
                                                        phi_2242_ = true;
                                                        break;
                                                    }
                                                    let _e683 = global_3.member[_e666].member[_e675];
                                                    if (_e676 < 9u) {
                                                    } else {
                                                        phi_2242_ = true;
                                                        break;
                                                    }
                                                    let _e689 = global_3.member[_e666].member[_e676];
                                                    if (_e677 < 9u) {
                                                    } else {
                                                        phi_2242_ = true;
                                                        break;
                                                    }
                                                    let _e695 = global_3.member[_e666].member[_e677];
                                                    let _e697 = (3u + _e675);
                                                    if (_e697 < 9u) {
                                                    } else {
                                                        phi_2242_ = true;
                                                        break;
                                                    }
                                                    let _e703 = global_3.member[_e666].member[_e697];
                                                    let _e704 = (3u + _e676);
                                                    if (_e704 < 9u) {
                                                    } else {
                                                        phi_2242_ = true;
                                                        break;
                                                    }
                                                    let _e710 = global_3.member[_e666].member[_e704];
                                                    let _e711 = (3u + _e677);
                                                    if (_e711 < 9u) {
                                                    } else {
                                                        phi_2242_ = true;
                                                        break;
                                                    }
                                                    let _e717 = global_3.member[_e666].member[_e711];
                                                    let _e719 = (6u + _e675);
                                                    if (_e719 < 9u) {
                                                    } else {
                                                        phi_2242_ = true;
                                                        break;
                                                    }
                                                    let _e725 = global_3.member[_e666].member[_e719];
                                                    let _e726 = (6u + _e676);
                                                    if (_e726 < 9u) {
                                                    } else {
                                                        phi_2242_ = true;
                                                        break;
                                                    }
                                                    let _e732 = global_3.member[_e666].member[_e726];
                                                    let _e733 = (6u + _e677);
                                                    if (_e733 < 9u) {
                                                    } else {
                                                        phi_2242_ = true;
                                                        break;
                                                    }
                                                    let _e739 = global_3.member[_e666].member[_e733];
                                                    phi_863_ = array<array<f32, 3>, 3>(array<f32, 3>(_e683, _e689, _e695), array<f32, 3>(_e703, _e710, _e717), array<f32, 3>(_e725, _e732, _e739));
                                                }
                                                let _e743 = phi_863_;
                                                let _e752 = (_e743[0][2] - _e320);
                                                let _e755 = (((_e743[0][0] - _e243) * _e344) - (_e752 * _e268));
                                                let _e758 = (((_e743[0][1] - _e282) * _e344) - (_e752 * _e306));
                                                let _e765 = (_e743[1][2] - _e320);
                                                let _e768 = (((_e743[1][0] - _e243) * _e344) - (_e765 * _e268));
                                                let _e771 = (((_e743[1][1] - _e282) * _e344) - (_e765 * _e306));
                                                let _e778 = (_e743[2][2] - _e320);
                                                let _e781 = (((_e743[2][0] - _e243) * _e344) - (_e778 * _e268));
                                                let _e784 = (((_e743[2][1] - _e282) * _e344) - (_e778 * _e306));
                                                let _e785 = (_e781 * _e771);
                                                let _e786 = (_e784 * _e768);
                                                let _e787 = (_e755 * _e784);
                                                let _e788 = (_e758 * _e781);
                                                let _e789 = (_e768 * _e758);
                                                let _e790 = (_e771 * _e755);
                                                let _e795 = (((_e785 >= _e786) && (_e787 >= _e788)) && (_e789 >= _e790));
                                                if (_e795 || (((_e785 <= _e786) && (_e787 <= _e788)) && (_e789 <= _e790))) {
                                                    let _e802 = select(-1f, 1f, _e795);
                                                    let _e804 = ((_e785 - _e786) * _e802);
                                                    let _e806 = select(0f, _e804, (_e804 > 0f));
                                                    let _e808 = ((_e787 - _e788) * _e802);
                                                    let _e810 = select(0f, _e808, (_e808 > 0f));
                                                    let _e812 = ((_e789 - _e790) * _e802);
                                                    let _e814 = select(0f, _e812, (_e812 > 0f));
                                                    let _e816 = ((_e806 + _e810) + _e814);
                                                    if (_e816 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1691_ = type_27();
                                                        phi_1692_ = true;
                                                        phi_1693_ = false;
                                                    } else {
                                                        let _e819 = select(_e768, _e755, (_e755 < _e768));
                                                        if (select(_e781, _e819, (_e819 < _e781)) > 0f) {
                                                            phi_980_ = true;
                                                        } else {
                                                            let _e824 = select(_e768, _e755, (_e755 > _e768));
                                                            phi_980_ = (select(_e781, _e824, (_e824 > _e781)) < 0f);
                                                        }
                                                        let _e829 = phi_980_;
                                                        if _e829 {
                                                            phi_1688_ = type_27();
                                                            phi_1689_ = true;
                                                            phi_1690_ = false;
                                                        } else {
                                                            let _e831 = select(_e771, _e758, (_e758 < _e771));
                                                            if (select(_e784, _e831, (_e831 < _e784)) > 0f) {
                                                                phi_1009_ = true;
                                                            } else {
                                                                let _e836 = select(_e771, _e758, (_e758 > _e771));
                                                                phi_1009_ = (select(_e784, _e836, (_e836 > _e784)) < 0f);
                                                            }
                                                            let _e841 = phi_1009_;
                                                            if _e841 {
                                                                phi_1686_ = type_27();
                                                                phi_1687_ = false;
                                                            } else {
                                                                let _e843 = select(_e743[1][0], _e743[0][0], (_e743[0][0] < _e743[1][0]));
                                                                let _e847 = select(_e743[1][0], _e743[0][0], (_e743[0][0] > _e743[1][0]));
                                                                let _e851 = select(_e743[1][1], _e743[0][1], (_e743[0][1] < _e743[1][1]));
                                                                let _e855 = select(_e743[1][1], _e743[0][1], (_e743[0][1] > _e743[1][1]));
                                                                let _e859 = select(_e743[1][2], _e743[0][2], (_e743[0][2] < _e743[1][2]));
                                                                let _e863 = select(_e743[1][2], _e743[0][2], (_e743[0][2] > _e743[1][2]));
                                                                let _e868 = ((select(_e743[2][0], _e843, (_e843 < _e743[2][0])) - _e266) * _e271);
                                                                let _e869 = ((select(_e743[2][0], _e847, (_e847 > _e743[2][0])) - _e267) * _e271);
                                                                let _e872 = ((select(_e743[2][1], _e851, (_e851 < _e743[2][1])) - _e304) * _e309);
                                                                let _e873 = ((select(_e743[2][1], _e855, (_e855 > _e743[2][1])) - _e305) * _e309);
                                                                let _e876 = ((select(_e743[2][2], _e859, (_e859 < _e743[2][2])) - _e342) * _e347);
                                                                let _e877 = ((select(_e743[2][2], _e863, (_e863 > _e743[2][2])) - _e343) * _e347);
                                                                let _e879 = select(_e877, _e876, (_e876 < _e877));
                                                                let _e881 = select(_e877, _e876, (_e876 > _e877));
                                                                let _e883 = select(_e869, _e868, (_e868 < _e869));
                                                                let _e885 = select(_e873, _e872, (_e872 < _e873));
                                                                let _e887 = select(_e885, _e883, (_e883 > _e885));
                                                                let _e889 = select(_e879, _e887, (_e887 > _e879));
                                                                let _e891 = select(_e869, _e868, (_e868 > _e869));
                                                                let _e893 = select(_e873, _e872, (_e872 > _e873));
                                                                let _e895 = select(_e893, _e891, (_e891 < _e893));
                                                                let _e897 = select(_e881, _e895, (_e895 < _e881));
                                                                let _e898 = -(_e879);
                                                                let _e904 = select(_e394, _e889, (_e889 > _e394));
                                                                if (_e904 > (_e897 + (select(_e898, _e881, (_e881 > _e898)) * 0.0000019073523f))) {
                                                                    phi_1681_ = type_27();
                                                                    phi_1682_ = true;
                                                                } else {
                                                                    let _e906 = (_e904 > _e638.member.member_1);
                                                                    if _e906 {
                                                                        phi_1680_ = type_27();
                                                                    } else {
                                                                        let _e907 = vec3<f32>(_e743[0][0], _e743[0][1], _e743[0][2]);
                                                                        let _e908 = vec3<f32>(_e743[1][0], _e743[1][1], _e743[1][2]);
                                                                        let _e909 = vec3<f32>(_e743[2][0], _e743[2][1], _e743[2][2]);
                                                                        let _e910 = (_e743[1][0] - _e743[0][0]);
                                                                        let _e911 = (_e743[1][1] - _e743[0][1]);
                                                                        let _e912 = (_e743[1][2] - _e743[0][2]);
                                                                        let _e913 = vec3<f32>(_e910, _e911, _e912);
                                                                        let _e914 = (_e743[2][0] - _e743[1][0]);
                                                                        let _e915 = (_e743[2][1] - _e743[1][1]);
                                                                        let _e916 = (_e743[2][2] - _e743[1][2]);
                                                                        let _e917 = vec3<f32>(_e914, _e915, _e916);
                                                                        let _e918 = (_e743[0][0] - _e743[2][0]);
                                                                        let _e919 = (_e743[0][1] - _e743[2][1]);
                                                                        let _e920 = (_e743[0][2] - _e743[2][2]);
                                                                        let _e921 = vec3<f32>(_e918, _e919, _e920);
                                                                        let _e924 = bitcast<f32>((bitcast<u32>(_e910) & 2147483647u));
                                                                        let _e927 = bitcast<f32>((bitcast<u32>(_e911) & 2147483647u));
                                                                        let _e929 = select(_e927, _e924, (_e924 > _e927));
                                                                        let _e932 = bitcast<f32>((bitcast<u32>(_e912) & 2147483647u));
                                                                        let _e934 = select(_e932, _e929, (_e929 > _e932));
                                                                        let _e937 = bitcast<f32>((bitcast<u32>(_e914) & 2147483647u));
                                                                        let _e940 = bitcast<f32>((bitcast<u32>(_e915) & 2147483647u));
                                                                        let _e942 = select(_e940, _e937, (_e937 > _e940));
                                                                        let _e945 = bitcast<f32>((bitcast<u32>(_e916) & 2147483647u));
                                                                        let _e947 = select(_e945, _e942, (_e942 > _e945));
                                                                        let _e950 = bitcast<f32>((bitcast<u32>(_e918) & 2147483647u));
                                                                        let _e953 = bitcast<f32>((bitcast<u32>(_e919) & 2147483647u));
                                                                        let _e955 = select(_e953, _e950, (_e950 > _e953));
                                                                        let _e958 = bitcast<f32>((bitcast<u32>(_e920) & 2147483647u));
                                                                        let _e960 = select(_e958, _e955, (_e955 > _e958));
                                                                        let _e962 = select(_e947, _e934, (_e934 > _e947));
                                                                        let _e964 = select(_e960, _e962, (_e962 > _e960));
                                                                        if (_e934 == _e964) {
                                                                            phi_1410_ = _e771;
                                                                            phi_1411_ = _e768;
                                                                            phi_1412_ = _e758;
                                                                            phi_1413_ = _e755;
                                                                            phi_1414_ = _e907;
                                                                            phi_1415_ = _e921;
                                                                            phi_1416_ = _e917;
                                                                            phi_1417_ = _e913;
                                                                        } else {
                                                                            let _e966 = (_e947 == _e964);
                                                                            let _e971 = vec3(_e966);
                                                                            phi_1410_ = select(_e758, _e784, _e966);
                                                                            phi_1411_ = select(_e755, _e781, _e966);
                                                                            phi_1412_ = select(_e784, _e771, _e966);
                                                                            phi_1413_ = select(_e781, _e768, _e966);
                                                                            phi_1414_ = select(_e909, _e908, _e971);
                                                                            phi_1415_ = select(_e917, _e913, _e971);
                                                                            phi_1416_ = select(_e913, _e921, _e971);
                                                                            phi_1417_ = select(_e921, _e917, _e971);
                                                                        }
                                                                        let _e977 = phi_1410_;
                                                                        let _e979 = phi_1411_;
                                                                        let _e981 = phi_1412_;
                                                                        let _e983 = phi_1413_;
                                                                        let _e985 = phi_1414_;
                                                                        let _e987 = phi_1415_;
                                                                        let _e989 = phi_1416_;
                                                                        let _e991 = phi_1417_;
                                                                        let _e998 = ((_e989.y * _e987.z) - (_e987.y * _e989.z));
                                                                        let _e1003 = ((_e989.z * _e987.x) - (_e987.z * _e989.x));
                                                                        let _e1006 = ((_e989.x * _e987.y) - (_e987.x * _e989.y));
                                                                        if (_e806 >= _e810) {
                                                                            phi_1448_ = select(true, false, (_e806 >= _e814));
                                                                        } else {
                                                                            phi_1448_ = true;
                                                                        }
                                                                        let _e1011 = phi_1448_;
                                                                        if _e1011 {
                                                                            phi_1457_ = select(_e909, _e908, vec3((_e810 >= _e814)));
                                                                        } else {
                                                                            phi_1457_ = _e907;
                                                                        }
                                                                        let _e1016 = phi_1457_;
                                                                        let _e1021 = (((_e998 * _e268) + (_e1003 * _e306)) + (_e1006 * _e344));
                                                                        let _e1032 = (((_e998 * (_e1016.x - _e243)) + (_e1003 * (_e1016.y - _e282))) + (_e1006 * (_e1016.z - _e320)));
                                                                        let _e1034 = (_e979 - _e983);
                                                                        let _e1035 = (_e977 - _e981);
                                                                        let _e1043 = (-(((_e983 * _e1034) + (_e981 * _e1035))) / ((_e1034 * _e1034) + (_e1035 * _e1035)));
                                                                        let _e1045 = select(1f, _e1043, (_e1043 < 1f));
                                                                        let _e1047 = select(0f, _e1045, (_e1045 > 0f));
                                                                        let _e1060 = ((_e985.x + (_e991.x * _e1047)) - _e243);
                                                                        let _e1061 = ((_e985.y + (_e991.y * _e1047)) - _e282);
                                                                        let _e1062 = ((_e985.z + (_e991.z * _e1047)) - _e320);
                                                                        let _e1063 = (_e1062 / _e344);
                                                                        let _e1075 = bitcast<f32>((bitcast<u32>(_e1060) & 2147483647u));
                                                                        let _e1078 = bitcast<f32>((bitcast<u32>(_e1061) & 2147483647u));
                                                                        let _e1080 = select(_e1078, _e1075, (_e1075 > _e1078));
                                                                        let _e1083 = bitcast<f32>((bitcast<u32>(_e1062) & 2147483647u));
                                                                        let _e1085 = select(_e1083, _e1080, (_e1080 > _e1083));
                                                                        let _e1091 = bitcast<f32>((bitcast<u32>(_e998) & 2147483647u));
                                                                        let _e1094 = bitcast<f32>((bitcast<u32>(_e1003) & 2147483647u));
                                                                        let _e1096 = select(_e1094, _e1091, (_e1091 > _e1094));
                                                                        let _e1099 = bitcast<f32>((bitcast<u32>(_e1006) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e998 * _e1060) + (_e1003 * _e1061)) + (_e1006 * _e1062)) - _e1032)) & 2147483647u)) <= ((0.0000009536743f * select(_e964, _e1085, (_e1085 > _e964))) * select(_e1099, _e1096, (_e1096 > _e1099)))) {
                                                                            let _e1109 = bitcast<f32>((bitcast<u32>(_e989.x) & 2147483647u));
                                                                            let _e1112 = bitcast<f32>((bitcast<u32>(_e989.y) & 2147483647u));
                                                                            let _e1114 = select(_e1112, _e1109, (_e1109 > _e1112));
                                                                            let _e1117 = bitcast<f32>((bitcast<u32>(_e989.z) & 2147483647u));
                                                                            let _e1123 = bitcast<f32>((bitcast<u32>(_e987.x) & 2147483647u));
                                                                            let _e1126 = bitcast<f32>((bitcast<u32>(_e987.y) & 2147483647u));
                                                                            let _e1128 = select(_e1126, _e1123, (_e1123 > _e1126));
                                                                            let _e1131 = bitcast<f32>((bitcast<u32>(_e987.z) & 2147483647u));
                                                                            phi_1624_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1021) & 2147483647u)) > ((0.0000038146973f * select(_e1117, _e1114, (_e1114 > _e1117))) * select(_e1131, _e1128, (_e1128 > _e1131)))));
                                                                        } else {
                                                                            phi_1624_ = true;
                                                                        }
                                                                        let _e1138 = phi_1624_;
                                                                        if _e1138 {
                                                                            let _e1149 = ((((_e998 * (_e1060 - (_e268 * _e1063))) + (_e1003 * (_e1061 - (_e306 * _e1063)))) + (_e1006 * (_e1062 - _e1062))) / _e1021);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1149) & 2147483647u)) <= _e964) {
                                                                                phi_1648_ = (_e1063 + _e1149);
                                                                            } else {
                                                                                phi_1648_ = _e1063;
                                                                            }
                                                                            let _e1156 = phi_1648_;
                                                                            phi_1649_ = _e1156;
                                                                        } else {
                                                                            phi_1649_ = (_e1032 / _e1021);
                                                                        }
                                                                        let _e1158 = phi_1649_;
                                                                        let _e1160 = select(_e897, _e1158, (_e1158 < _e897));
                                                                        let _e1162 = select(_e889, _e1160, (_e1160 > _e889));
                                                                        if (_e1162 >= _e394) {
                                                                            let _e1164 = (_e1162 <= _e638.member.member_1);
                                                                            if _e1164 {
                                                                                let _e1165 = (1f / _e816);
                                                                                phi_1672_ = type_27(_e1162, (_e810 * _e1165), (_e814 * _e1165), _e673);
                                                                            } else {
                                                                                phi_1672_ = type_27();
                                                                            }
                                                                            let _e1170 = phi_1672_;
                                                                            phi_1674_ = _e1170;
                                                                            phi_1675_ = select(true, false, _e1164);
                                                                        } else {
                                                                            phi_1674_ = type_27();
                                                                            phi_1675_ = true;
                                                                        }
                                                                        let _e1173 = phi_1674_;
                                                                        let _e1175 = phi_1675_;
                                                                        if _e1175 {
                                                                            phi_1679_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1679_ = _e1173;
                                                                        }
                                                                        let _e1177 = phi_1679_;
                                                                        phi_1680_ = _e1177;
                                                                    }
                                                                    let _e1179 = phi_1680_;
                                                                    phi_1681_ = _e1179;
                                                                    phi_1682_ = _e906;
                                                                }
                                                                let _e1181 = phi_1681_;
                                                                let _e1183 = phi_1682_;
                                                                phi_1686_ = _e1181;
                                                                phi_1687_ = _e1183;
                                                            }
                                                            let _e1185 = phi_1686_;
                                                            let _e1187 = phi_1687_;
                                                            phi_1688_ = _e1185;
                                                            phi_1689_ = _e841;
                                                            phi_1690_ = _e1187;
                                                        }
                                                        let _e1189 = phi_1688_;
                                                        let _e1191 = phi_1689_;
                                                        let _e1193 = phi_1690_;
                                                        phi_1691_ = _e1189;
                                                        phi_1692_ = _e1191;
                                                        phi_1693_ = _e1193;
                                                    }
                                                    let _e1195 = phi_1691_;
                                                    let _e1197 = phi_1692_;
                                                    let _e1199 = phi_1693_;
                                                    phi_1701_ = _e1195;
                                                    phi_1702_ = select(_e1199, true, _e1197);
                                                } else {
                                                    phi_1701_ = type_27();
                                                    phi_1702_ = true;
                                                }
                                                let _e1202 = phi_1701_;
                                                let _e1204 = phi_1702_;
                                                if _e1204 {
                                                    phi_1706_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1706_ = _e1202;
                                                }
                                                let _e1206 = phi_1706_;
                                                if (_e1206.member_3 != 4294967295u) {
                                                    if (_e673 != 4294967295u) {
                                                        if (_e1206.member < _e638.member.member.member) {
                                                            phi_1732_ = true;
                                                        } else {
                                                            if (_e1206.member == _e638.member.member.member) {
                                                                phi_1731_ = (_e1206.member_3 < _e638.member.member.member_3);
                                                            } else {
                                                                phi_1731_ = false;
                                                            }
                                                            let _e1221 = phi_1731_;
                                                            phi_1732_ = _e1221;
                                                        }
                                                        let _e1223 = phi_1732_;
                                                        if _e1223 {
                                                            phi_1739_ = type_48(type_39(_e1206, _e1206.member), _e665.member_1, _e665.member_2);
                                                        } else {
                                                            phi_1739_ = _e665;
                                                        }
                                                        let _e1230 = phi_1739_;
                                                        phi_1740_ = _e1230;
                                                    } else {
                                                        phi_1740_ = _e665;
                                                    }
                                                    let _e1232 = phi_1740_;
                                                    phi_1741_ = _e1232;
                                                } else {
                                                    phi_1741_ = _e665;
                                                }
                                                let _e1234 = phi_1741_;
                                                phi_725_ = _e1234;
                                            } else {
                                                phi_725_ = type_48();
                                            }
                                            let _e1236 = phi_725_;
                                            continue;
                                            continuing {
                                                phi_724_ = _e1236;
                                                phi_727_ = _e653;
                                                phi_2242_ = _e403;
                                                break if !(_e659);
                                            }
                                        }
                                        let _e1239 = phi_2242_;
                                        phi_2384_ = _e1239;
                                        if _e1239 {
                                            break;
                                        }
                                        phi_2388_ = _e1239;
                                        let _e1402 = local_4;
                                        phi_2199_ = _e1402;
                                        phi_2200_ = _e429;
                                        phi_2201_ = false;
                                        phi_2202_ = _e433;
                                    } else {
                                        if (_e429 >= _e66) {
                                            phi_1804_ = type_44(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e429 < _e66) {
                                            } else {
                                                phi_2384_ = true;
                                                break;
                                            }
                                            let _e449 = (_e194 % 3u);
                                            if (_e449 < 3u) {
                                            } else {
                                                phi_2384_ = true;
                                                break;
                                            }
                                            let _e455 = global_2.member[_e429].member[_e449];
                                            let _e461 = (_e193 % 3u);
                                            if (_e461 < 3u) {
                                            } else {
                                                phi_2384_ = true;
                                                break;
                                            }
                                            let _e467 = global_2.member[_e429].member[_e461];
                                            let _e473 = (_e195 % 3u);
                                            if (_e473 < 3u) {
                                            } else {
                                                phi_2384_ = true;
                                                break;
                                            }
                                            let _e479 = global_2.member[_e429].member[_e473];
                                            let _e489 = global_2.member[_e429].member_1;
                                            let _e493 = global_2.member[_e429].member_2;
                                            phi_1804_ = type_44(array<vec4<f32>, 3>(vec4<f32>(_e455[0], _e455[1], _e455[2], _e455[3]), vec4<f32>(_e467[0], _e467[1], _e467[2], _e467[3]), vec4<f32>(_e479[0], _e479[1], _e479[2], _e479[3])), _e489, _e493);
                                        }
                                        let _e496 = phi_1804_;
                                        let _e509 = ((_e496.member[0].x - _e266) * _e271);
                                        let _e510 = ((_e496.member[0].y - _e266) * _e271);
                                        let _e511 = ((_e496.member[0].z - _e267) * _e271);
                                        let _e512 = ((_e496.member[0].w - _e267) * _e271);
                                        let _e522 = ((_e496.member[1].x - _e304) * _e309);
                                        let _e523 = ((_e496.member[1].y - _e304) * _e309);
                                        let _e524 = ((_e496.member[1].z - _e305) * _e309);
                                        let _e525 = ((_e496.member[1].w - _e305) * _e309);
                                        let _e535 = ((_e496.member[2].x - _e342) * _e347);
                                        let _e536 = ((_e496.member[2].y - _e342) * _e347);
                                        let _e537 = ((_e496.member[2].z - _e343) * _e347);
                                        let _e538 = ((_e496.member[2].w - _e343) * _e347);
                                        let _e540 = select(_e537, _e535, (_e535 < _e537));
                                        let _e542 = select(_e538, _e536, (_e536 < _e538));
                                        let _e544 = select(_e537, _e535, (_e535 > _e537));
                                        let _e546 = select(_e538, _e536, (_e536 > _e538));
                                        let _e548 = select(_e511, _e509, (_e509 < _e511));
                                        let _e550 = select(_e512, _e510, (_e510 < _e512));
                                        let _e552 = select(_e524, _e522, (_e522 < _e524));
                                        let _e554 = select(_e525, _e523, (_e523 < _e525));
                                        let _e556 = select(_e552, _e548, (_e548 > _e552));
                                        let _e558 = select(_e554, _e550, (_e550 > _e554));
                                        let _e560 = select(_e540, _e556, (_e556 > _e540));
                                        let _e562 = select(_e542, _e558, (_e558 > _e542));
                                        let _e564 = select(_e511, _e509, (_e509 > _e511));
                                        let _e566 = select(_e512, _e510, (_e510 > _e512));
                                        let _e568 = select(_e524, _e522, (_e522 > _e524));
                                        let _e570 = select(_e525, _e523, (_e523 > _e525));
                                        let _e572 = select(_e568, _e564, (_e564 < _e568));
                                        let _e574 = select(_e570, _e566, (_e566 < _e570));
                                        let _e579 = -(_e540);
                                        let _e580 = -(_e542);
                                        let _e587 = (select(_e544, _e572, (_e572 < _e544)) + (select(_e579, _e544, (_e544 > _e579)) * 0.0000019073523f));
                                        let _e588 = (select(_e546, _e574, (_e574 < _e546)) + (select(_e580, _e546, (_e546 > _e580)) * 0.0000019073523f));
                                        let _e590 = select(_e394, _e560, (_e560 > _e394));
                                        let _e592 = select(_e394, _e562, (_e562 > _e394));
                                        let _e597 = (_e590 <= select(_e405.member.member_1, _e587, (_e587 < _e405.member.member_1)));
                                        let _e598 = (_e592 <= select(_e405.member.member_1, _e588, (_e588 < _e405.member.member_1)));
                                        let _e599 = (_e590 <= _e592);
                                        if _e597 {
                                            if _e598 {
                                                if _e599 {
                                                    phi_2148_ = _e496.member_2;
                                                } else {
                                                    phi_2148_ = _e496.member_1;
                                                }
                                                let _e603 = phi_2148_;
                                                let _e606 = (_e433 % 128u);
                                                let _e607 = (_e606 < 128u);
                                                if _e607 {
                                                } else {
                                                    phi_2384_ = true;
                                                    break;
                                                }
                                                local_1[_e606] = _e603;
                                                if _e607 {
                                                } else {
                                                    phi_2384_ = true;
                                                    break;
                                                }
                                                local[_e606] = select(_e592, _e590, (_e590 > _e592));
                                                if _e599 {
                                                    phi_2176_ = _e496.member_1;
                                                } else {
                                                    phi_2176_ = _e496.member_2;
                                                }
                                                let _e614 = phi_2176_;
                                                phi_2177_ = _e614;
                                                phi_2178_ = (_e433 + 1u);
                                            } else {
                                                phi_2177_ = u32();
                                                phi_2178_ = u32();
                                            }
                                            let _e616 = phi_2177_;
                                            let _e618 = phi_2178_;
                                            phi_2180_ = _e616;
                                            phi_2181_ = _e618;
                                            phi_2182_ = select(true, false, _e598);
                                        } else {
                                            phi_2180_ = u32();
                                            phi_2181_ = u32();
                                            phi_2182_ = true;
                                        }
                                        let _e621 = phi_2180_;
                                        let _e623 = phi_2181_;
                                        let _e625 = phi_2182_;
                                        if _e625 {
                                            if _e597 {
                                                phi_2191_ = _e496.member_1;
                                            } else {
                                                phi_2191_ = _e496.member_2;
                                            }
                                            let _e629 = phi_2191_;
                                            phi_2196_ = _e629;
                                            phi_2197_ = select(_e598, true, _e597);
                                        } else {
                                            phi_2196_ = _e621;
                                            phi_2197_ = _e431;
                                        }
                                        let _e632 = phi_2196_;
                                        let _e634 = phi_2197_;
                                        phi_2388_ = _e403;
                                        phi_2199_ = type_48(_e405.member, (_e405.member_1 + 1u), _e405.member_2);
                                        phi_2200_ = _e632;
                                        phi_2201_ = _e634;
                                        phi_2202_ = select(_e623, _e433, _e625);
                                    }
                                    let _e1241 = phi_2388_;
                                    let _e1243 = phi_2199_;
                                    let _e1245 = phi_2200_;
                                    let _e1247 = phi_2201_;
                                    let _e1249 = phi_2202_;
                                    phi_2387_ = _e1241;
                                    phi_2203_ = _e1243;
                                    phi_2204_ = _e1245;
                                    phi_2205_ = (_e409 - 1u);
                                    phi_2206_ = _e1247;
                                    phi_2207_ = _e1249;
                                } else {
                                    phi_2387_ = _e403;
                                    phi_2203_ = _e405;
                                    phi_2204_ = _e429;
                                    phi_2205_ = _e409;
                                    phi_2206_ = _e431;
                                    phi_2207_ = _e433;
                                }
                                let _e1251 = phi_2387_;
                                let _e1253 = phi_2203_;
                                let _e1255 = phi_2204_;
                                let _e1257 = phi_2205_;
                                let _e1259 = phi_2206_;
                                let _e1261 = phi_2207_;
                                phi_2386_ = _e1251;
                                phi_2208_ = _e1253;
                                phi_2209_ = _e1255;
                                phi_2210_ = _e1257;
                                phi_2211_ = _e1259;
                                phi_2212_ = _e1261;
                            } else {
                                phi_2386_ = _e403;
                                phi_2208_ = type_48();
                                phi_2209_ = u32();
                                phi_2210_ = u32();
                                phi_2211_ = bool();
                                phi_2212_ = u32();
                            }
                            let _e1263 = phi_2386_;
                            let _e1265 = phi_2208_;
                            let _e1267 = phi_2209_;
                            let _e1269 = phi_2210_;
                            let _e1271 = phi_2211_;
                            let _e1273 = phi_2212_;
                            phi_2385_ = _e1263;
                            phi_656_ = _e1265;
                            phi_659_ = _e1267;
                            phi_661_ = _e1269;
                            phi_663_ = _e1271;
                            phi_665_ = _e1273;
                            phi_2213_ = _e417;
                        } else {
                            phi_2385_ = _e403;
                            phi_656_ = type_48();
                            phi_659_ = u32();
                            phi_661_ = u32();
                            phi_663_ = bool();
                            phi_665_ = u32();
                            phi_2213_ = false;
                        }
                        let _e1275 = phi_2385_;
                        let _e1277 = phi_656_;
                        let _e1279 = phi_659_;
                        let _e1281 = phi_661_;
                        let _e1283 = phi_663_;
                        let _e1285 = phi_665_;
                        let _e1287 = phi_2213_;
                        continue;
                        continuing {
                            phi_2248_ = _e1275;
                            phi_655_ = _e1277;
                            phi_658_ = _e1279;
                            phi_660_ = _e1281;
                            phi_662_ = _e1283;
                            phi_664_ = _e1285;
                            phi_2384_ = _e1275;
                            break if !(_e1287);
                        }
                    }
                    let _e1290 = phi_2384_;
                    if _e1290 {
                        break;
                    }
                    let _e1292 = local_2;
                    let _e1295 = local_3;
                    if _e82 {
                    } else {
                        break;
                    }
                    global_5.member[_e76][0u] = _e1292.member_1;
                    global_5.member[_e76][1u] = _e1295.member_2;
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
