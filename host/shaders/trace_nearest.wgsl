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

struct type_24 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_38 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_40 {
    member: array<type_24>,
}

struct type_44 {
    member: array<array<type_23, 8>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<storage> global_2: type_29;
@group(0) @binding(2) 
var<storage> global_3: type_15;
@group(0) @binding(3) 
var<storage> global_4: type_40;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_44;

fn function_() {
    var local: array<type_23, 8>;
    var local_1: array<f32, 128>;
    var local_2: array<u32, 128>;
    var phi_274_: i32;
    var phi_275_: i32;
    var phi_285_: bool;
    var phi_295_: u32;
    var phi_296_: u32;
    var phi_298_: bool;
    var phi_303_: u32;
    var phi_347_: f32;
    var phi_353_: f32;
    var phi_364_: f32;
    var phi_370_: f32;
    var phi_393_: f32;
    var phi_404_: f32;
    var phi_413_: f32;
    var phi_419_: f32;
    var phi_430_: f32;
    var phi_436_: f32;
    var phi_459_: f32;
    var phi_470_: f32;
    var phi_479_: f32;
    var phi_485_: f32;
    var phi_496_: f32;
    var phi_502_: f32;
    var phi_525_: f32;
    var phi_536_: f32;
    var phi_636_: f32;
    var phi_637_: f32;
    var phi_2529_: bool;
    var phi_2509_: f32;
    var phi_964_: u32;
    var phi_967_: u32;
    var phi_969_: bool;
    var phi_971_: u32;
    var phi_982_: bool;
    var phi_1014_: u32;
    var phi_1015_: bool;
    var phi_1016_: u32;
    var phi_1905_: type_38;
    var phi_2250_: u32;
    var phi_2277_: u32;
    var phi_2278_: u32;
    var phi_2279_: u32;
    var phi_2281_: u32;
    var phi_2282_: u32;
    var phi_2283_: bool;
    var phi_2292_: u32;
    var phi_2297_: u32;
    var phi_2298_: bool;
    var phi_2526_: bool;
    var phi_2516_: f32;
    var phi_1031_: type_4;
    var phi_1032_: type_4;
    var phi_1055_: type_4;
    var phi_1076_: u32;
    var phi_1165_: array<array<f32, 3>, 3>;
    var phi_1637_: vec3<f32>;
    var phi_1638_: vec3<f32>;
    var phi_1669_: bool;
    var phi_1678_: vec3<f32>;
    var phi_1718_: type_23;
    var phi_1720_: type_23;
    var phi_1721_: bool;
    var phi_1725_: type_23;
    var phi_1726_: type_23;
    var phi_1727_: type_23;
    var phi_1728_: bool;
    var phi_1732_: type_23;
    var phi_1733_: bool;
    var phi_1737_: type_23;
    var phi_1738_: bool;
    var phi_1742_: type_23;
    var phi_1754_: type_4;
    var phi_1757_: type_23;
    var phi_1755_: type_4;
    var phi_1780_: type_4;
    var phi_1812_: bool;
    var phi_1813_: bool;
    var phi_1834_: type_23;
    var phi_1758_: type_23;
    var phi_2517_: bool;
    var phi_2780_: f32;
    var phi_2779_: f32;
    var phi_2630_: bool;
    var phi_2778_: f32;
    var phi_2629_: bool;
    var phi_2777_: f32;
    var phi_2628_: bool;
    var phi_2717_: f32;
    var phi_2627_: bool;
    var phi_2682_: f32;
    var phi_2636_: bool;
    var phi_2300_: u32;
    var phi_2301_: bool;
    var phi_2302_: u32;
    var phi_2681_: f32;
    var phi_2635_: bool;
    var phi_2303_: u32;
    var phi_2304_: u32;
    var phi_2305_: bool;
    var phi_2306_: u32;
    var phi_2680_: f32;
    var phi_2634_: bool;
    var phi_2307_: u32;
    var phi_2308_: u32;
    var phi_2309_: bool;
    var phi_2310_: u32;
    var phi_2679_: f32;
    var phi_2633_: bool;
    var phi_965_: u32;
    var phi_968_: u32;
    var phi_970_: bool;
    var phi_972_: u32;
    var phi_2311_: bool;
    var phi_2632_: bool;
    var phi_2318_: type_4;
    var phi_2319_: type_4;
    var phi_2342_: type_4;
    var phi_2408_: type_23;
    var phi_2672_: bool;

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
                            phi_274_ = (bitcast<i32>((_e160 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_274_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e160)), 32u, (_e160 == 0u))));
                        }
                        let _e174 = phi_274_;
                        phi_275_ = _e174;
                    } else {
                        phi_275_ = 0i;
                    }
                    let _e176 = phi_275_;
                    let _e177 = (_e93 == _e132);
                    if _e177 {
                        phi_285_ = true;
                    } else {
                        phi_285_ = (_e100 == _e132);
                    }
                    let _e180 = phi_285_;
                    let _e181 = select(1u, 0u, _e177);
                    if _e180 {
                        let _e182 = (_e181 + 1u);
                        phi_295_ = _e182;
                        phi_296_ = _e182;
                        phi_298_ = select(true, false, (_e182 == 2u));
                    } else {
                        phi_295_ = u32();
                        phi_296_ = 0u;
                        phi_298_ = true;
                    }
                    let _e186 = phi_295_;
                    let _e188 = phi_296_;
                    let _e190 = phi_298_;
                    if _e190 {
                        phi_303_ = (_e188 + 1u);
                    } else {
                        phi_303_ = 0u;
                    }
                    let _e194 = phi_303_;
                    let _e195 = select(_e186, _e188, _e190);
                    let _e196 = select(_e181, select(2u, _e181, _e180), _e190);
                    let _e197 = (_e81 / 2i);
                    let _e202 = bitcast<f32>((bitcast<u32>((_e197 + 127i)) << bitcast<u32>(23i)));
                    let _e208 = bitcast<f32>((bitcast<u32>(((_e81 - _e197) + 127i)) << bitcast<u32>(23i)));
                    let _e209 = -(_e176);
                    let _e210 = (_e209 / 2i);
                    let _e215 = bitcast<f32>((bitcast<u32>((_e210 + 127i)) << bitcast<u32>(23i)));
                    let _e221 = bitcast<f32>((bitcast<u32>(((_e209 - _e210) + 127i)) << bitcast<u32>(23i)));
                    let _e225 = global_4.member[_e77].member;
                    let _e226 = (_e195 == 0u);
                    if _e226 {
                        phi_347_ = _e225[0];
                    } else {
                        phi_347_ = _e225[1];
                    }
                    let _e230 = phi_347_;
                    let _e231 = (_e195 == 2u);
                    if _e231 {
                        phi_353_ = _e225[2];
                    } else {
                        phi_353_ = _e230;
                    }
                    let _e234 = phi_353_;
                    let _e236 = ((_e234 * _e202) * _e208);
                    let _e237 = global_4.member[_e77].member_2;
                    if _e226 {
                        phi_364_ = _e237[0];
                    } else {
                        phi_364_ = _e237[1];
                    }
                    let _e241 = phi_364_;
                    if _e231 {
                        phi_370_ = _e237[2];
                    } else {
                        phi_370_ = _e241;
                    }
                    let _e244 = phi_370_;
                    let _e246 = ((_e244 * _e215) * _e221);
                    let _e250 = (bitcast<f32>((bitcast<u32>(_e246) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e250 {
                        let _e254 = (bitcast<f32>((bitcast<u32>(_e236) & 2147483647u)) * 0.00000011920929f);
                        phi_393_ = select(0.00000000000011368684f, _e254, (_e254 > 0.00000000000011368684f));
                    } else {
                        phi_393_ = 0f;
                    }
                    let _e258 = phi_393_;
                    let _e259 = (_e236 + _e258);
                    let _e260 = (_e236 - _e258);
                    let _e261 = select(_e246, 0f, _e250);
                    if _e250 {
                        phi_404_ = 38685626000000000000000000f;
                    } else {
                        phi_404_ = (1f / _e246);
                    }
                    let _e264 = phi_404_;
                    let _e265 = (_e194 == 0u);
                    if _e265 {
                        phi_413_ = _e225[0];
                    } else {
                        phi_413_ = _e225[1];
                    }
                    let _e269 = phi_413_;
                    let _e270 = (_e194 == 2u);
                    if _e270 {
                        phi_419_ = _e225[2];
                    } else {
                        phi_419_ = _e269;
                    }
                    let _e273 = phi_419_;
                    let _e275 = ((_e273 * _e202) * _e208);
                    if _e265 {
                        phi_430_ = _e237[0];
                    } else {
                        phi_430_ = _e237[1];
                    }
                    let _e279 = phi_430_;
                    if _e270 {
                        phi_436_ = _e237[2];
                    } else {
                        phi_436_ = _e279;
                    }
                    let _e282 = phi_436_;
                    let _e284 = ((_e282 * _e215) * _e221);
                    let _e288 = (bitcast<f32>((bitcast<u32>(_e284) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e288 {
                        let _e292 = (bitcast<f32>((bitcast<u32>(_e275) & 2147483647u)) * 0.00000011920929f);
                        phi_459_ = select(0.00000000000011368684f, _e292, (_e292 > 0.00000000000011368684f));
                    } else {
                        phi_459_ = 0f;
                    }
                    let _e296 = phi_459_;
                    let _e297 = (_e275 + _e296);
                    let _e298 = (_e275 - _e296);
                    let _e299 = select(_e284, 0f, _e288);
                    if _e288 {
                        phi_470_ = 38685626000000000000000000f;
                    } else {
                        phi_470_ = (1f / _e284);
                    }
                    let _e302 = phi_470_;
                    let _e303 = (_e196 == 0u);
                    if _e303 {
                        phi_479_ = _e225[0];
                    } else {
                        phi_479_ = _e225[1];
                    }
                    let _e307 = phi_479_;
                    let _e308 = (_e196 == 2u);
                    if _e308 {
                        phi_485_ = _e225[2];
                    } else {
                        phi_485_ = _e307;
                    }
                    let _e311 = phi_485_;
                    let _e313 = ((_e311 * _e202) * _e208);
                    if _e303 {
                        phi_496_ = _e237[0];
                    } else {
                        phi_496_ = _e237[1];
                    }
                    let _e317 = phi_496_;
                    if _e308 {
                        phi_502_ = _e237[2];
                    } else {
                        phi_502_ = _e317;
                    }
                    let _e320 = phi_502_;
                    let _e322 = ((_e320 * _e215) * _e221);
                    let _e326 = (bitcast<f32>((bitcast<u32>(_e322) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e326 {
                        let _e330 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) * 0.00000011920929f);
                        phi_525_ = select(0.00000000000011368684f, _e330, (_e330 > 0.00000000000011368684f));
                    } else {
                        phi_525_ = 0f;
                    }
                    let _e334 = phi_525_;
                    let _e335 = (_e313 + _e334);
                    let _e336 = (_e313 - _e334);
                    let _e337 = select(_e322, 0f, _e326);
                    if _e326 {
                        phi_536_ = 38685626000000000000000000f;
                    } else {
                        phi_536_ = (1f / _e322);
                    }
                    let _e340 = phi_536_;
                    let _e343 = bitcast<f32>((bitcast<u32>(_e236) & 2147483647u));
                    let _e346 = bitcast<f32>((bitcast<u32>(_e275) & 2147483647u));
                    let _e348 = select(_e346, _e343, (_e343 > _e346));
                    let _e351 = bitcast<f32>((bitcast<u32>(_e313) & 2147483647u));
                    let _e354 = (_e81 + _e176);
                    if (_e157 && (select(_e351, _e348, (_e348 > _e351)) <= 1099511600000f)) {
                        let _e357 = (_e354 / 3i);
                        let _e364 = bitcast<f32>((bitcast<u32>((_e357 + 127i)) << bitcast<u32>(23i)));
                        let _e371 = bitcast<f32>((bitcast<u32>(((_e354 - (2i * _e357)) + 127i)) << bitcast<u32>(23i)));
                        let _e372 = (((_e142 * _e364) * _e364) * _e371);
                        let _e374 = select(340282350000000000000000000000000000000f, _e372, (_e372 < 340282350000000000000000000000000000000f));
                        let _e379 = (((_e151 * _e364) * _e364) * _e371);
                        let _e381 = select(340282350000000000000000000000000000000f, _e379, (_e379 < 340282350000000000000000000000000000000f));
                        phi_636_ = select(-340282350000000000000000000000000000000f, _e381, (_e381 > -340282350000000000000000000000000000000f));
                        phi_637_ = select(-340282350000000000000000000000000000000f, _e374, (_e374 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_636_ = 0f;
                        phi_637_ = 1f;
                    }
                    let _e385 = phi_636_;
                    let _e387 = phi_637_;
                    local = array<type_23, 8>(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_2 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2529_ = false;
                    phi_2509_ = _e385;
                    phi_964_ = select(0u, 2147483648u, (_e67 == 0u));
                    phi_967_ = ((3u * _e67) + 1u);
                    phi_969_ = (_e387 <= _e385);
                    phi_971_ = 0u;
                    loop {
                        let _e394 = phi_2529_;
                        let _e396 = phi_2509_;
                        let _e398 = phi_964_;
                        let _e400 = phi_967_;
                        let _e402 = phi_969_;
                        let _e404 = phi_971_;
                        if _e402 {
                            phi_982_ = true;
                        } else {
                            phi_982_ = (_e404 > 0u);
                        }
                        let _e407 = phi_982_;
                        if _e407 {
                            let _e408 = (_e400 > 0u);
                            if _e408 {
                                if _e402 {
                                    phi_1014_ = _e398;
                                    phi_1015_ = _e402;
                                    phi_1016_ = _e404;
                                } else {
                                    let _e409 = (_e404 - 1u);
                                    let _e410 = (_e409 % 128u);
                                    let _e411 = (_e410 < 128u);
                                    if _e411 {
                                    } else {
                                        phi_2632_ = true;
                                        break;
                                    }
                                    let _e413 = local_2[_e410];
                                    if _e411 {
                                    } else {
                                        phi_2632_ = true;
                                        break;
                                    }
                                    let _e415 = local_1[_e410];
                                    phi_1014_ = _e413;
                                    phi_1015_ = (_e415 <= _e396);
                                    phi_1016_ = _e409;
                                }
                                let _e418 = phi_1014_;
                                let _e420 = phi_1015_;
                                let _e422 = phi_1016_;
                                if _e420 {
                                    if ((_e418 & 2147483648u) != 0u) {
                                        phi_2526_ = _e394;
                                        phi_2516_ = _e396;
                                        phi_1031_ = type_4(0u, ((_e418 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e619 = phi_2526_;
                                            let _e621 = phi_2516_;
                                            let _e623 = phi_1031_;
                                            if (_e623.member < _e623.member_1) {
                                                phi_1032_ = type_4((_e623.member + 1u), _e623.member_1);
                                                phi_1055_ = type_4(1u, _e623.member);
                                            } else {
                                                phi_1032_ = _e623;
                                                phi_1055_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e636 = phi_1032_;
                                            let _e638 = phi_1055_;
                                            let _e642 = (bitcast<i32>(_e638.member) != 0i);
                                            if _e642 {
                                                let _e643 = ((_e418 & 268435455u) + _e638.member_1);
                                                let _e644 = (_e643 < _e69);
                                                if _e644 {
                                                    if _e644 {
                                                    } else {
                                                        phi_2717_ = _e621;
                                                        phi_2627_ = true;
                                                        break;
                                                    }
                                                    let _e648 = global_3.member[_e643].member_1;
                                                    phi_1076_ = _e648;
                                                } else {
                                                    phi_1076_ = 4294967295u;
                                                }
                                                let _e650 = phi_1076_;
                                                if (_e643 >= _e69) {
                                                    phi_1165_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e644 {
                                                    } else {
                                                        phi_2717_ = _e621;
                                                        phi_2627_ = true;
                                                        break;
                                                    }
                                                    let _e652 = (_e195 % 3u);
                                                    let _e653 = (_e194 % 3u);
                                                    let _e654 = (_e196 % 3u);
                                                    if (_e652 < 9u) {
                                                    } else {
                                                        phi_2717_ = _e621;
                                                        phi_2627_ = true;
                                                        break;
                                                    }
                                                    let _e660 = global_3.member[_e643].member[_e652];
                                                    if (_e653 < 9u) {
                                                    } else {
                                                        phi_2717_ = _e621;
                                                        phi_2627_ = true;
                                                        break;
                                                    }
                                                    let _e666 = global_3.member[_e643].member[_e653];
                                                    if (_e654 < 9u) {
                                                    } else {
                                                        phi_2717_ = _e621;
                                                        phi_2627_ = true;
                                                        break;
                                                    }
                                                    let _e672 = global_3.member[_e643].member[_e654];
                                                    let _e674 = (3u + _e652);
                                                    if (_e674 < 9u) {
                                                    } else {
                                                        phi_2717_ = _e621;
                                                        phi_2627_ = true;
                                                        break;
                                                    }
                                                    let _e680 = global_3.member[_e643].member[_e674];
                                                    let _e681 = (3u + _e653);
                                                    if (_e681 < 9u) {
                                                    } else {
                                                        phi_2717_ = _e621;
                                                        phi_2627_ = true;
                                                        break;
                                                    }
                                                    let _e687 = global_3.member[_e643].member[_e681];
                                                    let _e688 = (3u + _e654);
                                                    if (_e688 < 9u) {
                                                    } else {
                                                        phi_2717_ = _e621;
                                                        phi_2627_ = true;
                                                        break;
                                                    }
                                                    let _e694 = global_3.member[_e643].member[_e688];
                                                    let _e696 = (6u + _e652);
                                                    if (_e696 < 9u) {
                                                    } else {
                                                        phi_2717_ = _e621;
                                                        phi_2627_ = true;
                                                        break;
                                                    }
                                                    let _e702 = global_3.member[_e643].member[_e696];
                                                    let _e703 = (6u + _e653);
                                                    if (_e703 < 9u) {
                                                    } else {
                                                        phi_2717_ = _e621;
                                                        phi_2627_ = true;
                                                        break;
                                                    }
                                                    let _e709 = global_3.member[_e643].member[_e703];
                                                    let _e710 = (6u + _e654);
                                                    if (_e710 < 9u) {
                                                    } else {
                                                        phi_2717_ = _e621;
                                                        phi_2627_ = true;
                                                        break;
                                                    }
                                                    let _e716 = global_3.member[_e643].member[_e710];
                                                    phi_1165_ = array<array<f32, 3>, 3>(array<f32, 3>(_e660, _e666, _e672), array<f32, 3>(_e680, _e687, _e694), array<f32, 3>(_e702, _e709, _e716));
                                                }
                                                let _e720 = phi_1165_;
                                                let _e727 = (_e720[0][2] - _e313);
                                                let _e730 = (((_e720[0][0] - _e236) * _e337) - (_e727 * _e261));
                                                let _e733 = (((_e720[0][1] - _e275) * _e337) - (_e727 * _e299));
                                                let _e740 = (_e720[1][2] - _e313);
                                                let _e743 = (((_e720[1][0] - _e236) * _e337) - (_e740 * _e261));
                                                let _e746 = (((_e720[1][1] - _e275) * _e337) - (_e740 * _e299));
                                                let _e753 = (_e720[2][2] - _e313);
                                                let _e756 = (((_e720[2][0] - _e236) * _e337) - (_e753 * _e261));
                                                let _e759 = (((_e720[2][1] - _e275) * _e337) - (_e753 * _e299));
                                                let _e760 = (_e756 * _e746);
                                                let _e761 = (_e759 * _e743);
                                                let _e762 = (_e730 * _e759);
                                                let _e763 = (_e733 * _e756);
                                                let _e764 = (_e743 * _e733);
                                                let _e765 = (_e746 * _e730);
                                                let _e770 = (((_e760 >= _e761) && (_e762 >= _e763)) && (_e764 >= _e765));
                                                if (_e770 || (((_e760 <= _e761) && (_e762 <= _e763)) && (_e764 <= _e765))) {
                                                    let _e777 = select(-1f, 1f, _e770);
                                                    let _e779 = ((_e760 - _e761) * _e777);
                                                    let _e781 = select(0f, _e779, (_e779 > 0f));
                                                    let _e783 = ((_e762 - _e763) * _e777);
                                                    let _e785 = select(0f, _e783, (_e783 > 0f));
                                                    let _e787 = ((_e764 - _e765) * _e777);
                                                    let _e789 = select(0f, _e787, (_e787 > 0f));
                                                    let _e791 = ((_e781 + _e785) + _e789);
                                                    if (_e791 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1732_ = type_23();
                                                        phi_1733_ = true;
                                                    } else {
                                                        let _e794 = select(_e720[1][0], _e720[0][0], (_e720[0][0] < _e720[1][0]));
                                                        let _e798 = select(_e720[1][0], _e720[0][0], (_e720[0][0] > _e720[1][0]));
                                                        let _e802 = select(_e720[1][1], _e720[0][1], (_e720[0][1] < _e720[1][1]));
                                                        let _e806 = select(_e720[1][1], _e720[0][1], (_e720[0][1] > _e720[1][1]));
                                                        let _e810 = select(_e720[1][2], _e720[0][2], (_e720[0][2] < _e720[1][2]));
                                                        let _e814 = select(_e720[1][2], _e720[0][2], (_e720[0][2] > _e720[1][2]));
                                                        let _e819 = ((select(_e720[2][0], _e794, (_e794 < _e720[2][0])) - _e259) * _e264);
                                                        let _e820 = ((select(_e720[2][0], _e798, (_e798 > _e720[2][0])) - _e260) * _e264);
                                                        let _e823 = ((select(_e720[2][1], _e802, (_e802 < _e720[2][1])) - _e297) * _e302);
                                                        let _e824 = ((select(_e720[2][1], _e806, (_e806 > _e720[2][1])) - _e298) * _e302);
                                                        let _e827 = ((select(_e720[2][2], _e810, (_e810 < _e720[2][2])) - _e335) * _e340);
                                                        let _e828 = ((select(_e720[2][2], _e814, (_e814 > _e720[2][2])) - _e336) * _e340);
                                                        let _e830 = select(_e828, _e827, (_e827 < _e828));
                                                        let _e832 = select(_e828, _e827, (_e827 > _e828));
                                                        let _e834 = select(_e820, _e819, (_e819 < _e820));
                                                        let _e836 = select(_e824, _e823, (_e823 < _e824));
                                                        let _e838 = select(_e836, _e834, (_e834 > _e836));
                                                        let _e840 = select(_e830, _e838, (_e838 > _e830));
                                                        let _e842 = select(_e820, _e819, (_e819 > _e820));
                                                        let _e844 = select(_e824, _e823, (_e823 > _e824));
                                                        let _e846 = select(_e844, _e842, (_e842 < _e844));
                                                        let _e848 = select(_e832, _e846, (_e846 < _e832));
                                                        let _e849 = -(_e830);
                                                        let _e855 = select(_e387, _e840, (_e840 > _e387));
                                                        if (_e855 > (_e848 + (select(_e849, _e832, (_e832 > _e849)) * 0.0000019073523f))) {
                                                            phi_1727_ = type_23();
                                                            phi_1728_ = true;
                                                        } else {
                                                            let _e857 = (_e855 > _e621);
                                                            if _e857 {
                                                                phi_1726_ = type_23();
                                                            } else {
                                                                let _e861 = (_e720[1][0] - _e720[0][0]);
                                                                let _e862 = (_e720[1][1] - _e720[0][1]);
                                                                let _e863 = (_e720[1][2] - _e720[0][2]);
                                                                let _e864 = vec3<f32>(_e861, _e862, _e863);
                                                                let _e865 = (_e720[2][0] - _e720[1][0]);
                                                                let _e866 = (_e720[2][1] - _e720[1][1]);
                                                                let _e867 = (_e720[2][2] - _e720[1][2]);
                                                                let _e868 = vec3<f32>(_e865, _e866, _e867);
                                                                let _e869 = (_e720[0][0] - _e720[2][0]);
                                                                let _e870 = (_e720[0][1] - _e720[2][1]);
                                                                let _e871 = (_e720[0][2] - _e720[2][2]);
                                                                let _e872 = vec3<f32>(_e869, _e870, _e871);
                                                                let _e875 = bitcast<f32>((bitcast<u32>(_e861) & 2147483647u));
                                                                let _e878 = bitcast<f32>((bitcast<u32>(_e862) & 2147483647u));
                                                                let _e880 = select(_e878, _e875, (_e875 > _e878));
                                                                let _e883 = bitcast<f32>((bitcast<u32>(_e863) & 2147483647u));
                                                                let _e885 = select(_e883, _e880, (_e880 > _e883));
                                                                let _e888 = bitcast<f32>((bitcast<u32>(_e865) & 2147483647u));
                                                                let _e891 = bitcast<f32>((bitcast<u32>(_e866) & 2147483647u));
                                                                let _e893 = select(_e891, _e888, (_e888 > _e891));
                                                                let _e896 = bitcast<f32>((bitcast<u32>(_e867) & 2147483647u));
                                                                let _e898 = select(_e896, _e893, (_e893 > _e896));
                                                                let _e901 = bitcast<f32>((bitcast<u32>(_e869) & 2147483647u));
                                                                let _e904 = bitcast<f32>((bitcast<u32>(_e870) & 2147483647u));
                                                                let _e906 = select(_e904, _e901, (_e901 > _e904));
                                                                let _e909 = bitcast<f32>((bitcast<u32>(_e871) & 2147483647u));
                                                                let _e911 = select(_e909, _e906, (_e906 > _e909));
                                                                let _e913 = select(_e898, _e885, (_e885 > _e898));
                                                                let _e915 = select(_e911, _e913, (_e913 > _e911));
                                                                if (_e885 == _e915) {
                                                                    phi_1637_ = _e868;
                                                                    phi_1638_ = _e872;
                                                                } else {
                                                                    let _e918 = vec3((_e898 == _e915));
                                                                    phi_1637_ = select(_e864, _e872, _e918);
                                                                    phi_1638_ = select(_e868, _e864, _e918);
                                                                }
                                                                let _e922 = phi_1637_;
                                                                let _e924 = phi_1638_;
                                                                let _e931 = ((_e922.y * _e924.z) - (_e924.y * _e922.z));
                                                                let _e936 = ((_e922.z * _e924.x) - (_e924.z * _e922.x));
                                                                let _e939 = ((_e922.x * _e924.y) - (_e924.x * _e922.y));
                                                                if (_e781 >= _e785) {
                                                                    phi_1669_ = select(true, false, (_e781 >= _e789));
                                                                } else {
                                                                    phi_1669_ = true;
                                                                }
                                                                let _e944 = phi_1669_;
                                                                if _e944 {
                                                                    phi_1678_ = select(vec3<f32>(_e720[2][0], _e720[2][1], _e720[2][2]), vec3<f32>(_e720[1][0], _e720[1][1], _e720[1][2]), vec3((_e785 >= _e789)));
                                                                } else {
                                                                    phi_1678_ = vec3<f32>(_e720[0][0], _e720[0][1], _e720[0][2]);
                                                                }
                                                                let _e949 = phi_1678_;
                                                                let _e966 = ((((_e931 * (_e949.x - _e236)) + (_e936 * (_e949.y - _e275))) + (_e939 * (_e949.z - _e313))) / (((_e931 * _e261) + (_e936 * _e299)) + (_e939 * _e337)));
                                                                let _e968 = select(_e848, _e966, (_e966 < _e848));
                                                                let _e970 = select(_e840, _e968, (_e968 > _e840));
                                                                if (_e970 >= _e387) {
                                                                    let _e972 = (_e970 <= _e621);
                                                                    if _e972 {
                                                                        let _e973 = (1f / _e791);
                                                                        phi_1718_ = type_23(_e970, (_e785 * _e973), (_e789 * _e973), _e650);
                                                                    } else {
                                                                        phi_1718_ = type_23();
                                                                    }
                                                                    let _e978 = phi_1718_;
                                                                    phi_1720_ = _e978;
                                                                    phi_1721_ = select(true, false, _e972);
                                                                } else {
                                                                    phi_1720_ = type_23();
                                                                    phi_1721_ = true;
                                                                }
                                                                let _e981 = phi_1720_;
                                                                let _e983 = phi_1721_;
                                                                if _e983 {
                                                                    phi_1725_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1725_ = _e981;
                                                                }
                                                                let _e985 = phi_1725_;
                                                                phi_1726_ = _e985;
                                                            }
                                                            let _e987 = phi_1726_;
                                                            phi_1727_ = _e987;
                                                            phi_1728_ = _e857;
                                                        }
                                                        let _e989 = phi_1727_;
                                                        let _e991 = phi_1728_;
                                                        phi_1732_ = _e989;
                                                        phi_1733_ = _e991;
                                                    }
                                                    let _e993 = phi_1732_;
                                                    let _e995 = phi_1733_;
                                                    phi_1737_ = _e993;
                                                    phi_1738_ = _e995;
                                                } else {
                                                    phi_1737_ = type_23();
                                                    phi_1738_ = true;
                                                }
                                                let _e997 = phi_1737_;
                                                let _e999 = phi_1738_;
                                                if _e999 {
                                                    phi_1742_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1742_ = _e997;
                                                }
                                                let _e1001 = phi_1742_;
                                                if (_e1001.member_3 != 4294967295u) {
                                                    if (_e650 != 4294967295u) {
                                                        phi_1754_ = type_4(0u, 8u);
                                                        phi_1757_ = _e1001;
                                                        loop {
                                                            let _e1006 = phi_1754_;
                                                            let _e1008 = phi_1757_;
                                                            if (_e1006.member < _e1006.member_1) {
                                                                phi_1755_ = type_4((_e1006.member + 1u), _e1006.member_1);
                                                                phi_1780_ = type_4(1u, _e1006.member);
                                                            } else {
                                                                phi_1755_ = _e1006;
                                                                phi_1780_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1021 = phi_1755_;
                                                            let _e1023 = phi_1780_;
                                                            let _e1027 = (bitcast<i32>(_e1023.member) != 0i);
                                                            if _e1027 {
                                                                let _e1028 = (_e1023.member_1 < 8u);
                                                                if _e1028 {
                                                                } else {
                                                                    phi_2517_ = true;
                                                                    break;
                                                                }
                                                                let _e1033 = local[_e1023.member_1].member;
                                                                if (_e1008.member < _e1033) {
                                                                    phi_1813_ = true;
                                                                } else {
                                                                    let _e1035 = local[_e1023.member_1].member;
                                                                    if (_e1008.member == _e1035) {
                                                                        let _e1040 = local[_e1023.member_1].member_3;
                                                                        phi_1812_ = (_e1008.member_3 < _e1040);
                                                                    } else {
                                                                        phi_1812_ = false;
                                                                    }
                                                                    let _e1043 = phi_1812_;
                                                                    phi_1813_ = _e1043;
                                                                }
                                                                let _e1045 = phi_1813_;
                                                                if _e1045 {
                                                                    if _e1028 {
                                                                    } else {
                                                                        phi_2517_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1046 = local[_e1023.member_1];
                                                                    local[_e1023.member_1] = type_23(_e1008.member, _e1008.member_1, _e1008.member_2, _e1008.member_3);
                                                                    phi_1834_ = type_23(_e1046.member, _e1046.member_1, _e1046.member_2, _e1046.member_3);
                                                                } else {
                                                                    phi_1834_ = _e1008;
                                                                }
                                                                let _e1057 = phi_1834_;
                                                                phi_1758_ = _e1057;
                                                            } else {
                                                                phi_1758_ = type_23();
                                                            }
                                                            let _e1059 = phi_1758_;
                                                            continue;
                                                            continuing {
                                                                phi_1754_ = _e1021;
                                                                phi_1757_ = _e1059;
                                                                phi_2517_ = _e619;
                                                                break if !(_e1027);
                                                            }
                                                        }
                                                        let _e1062 = phi_2517_;
                                                        phi_2717_ = _e621;
                                                        phi_2627_ = _e1062;
                                                        if _e1062 {
                                                            break;
                                                        }
                                                        let _e1065 = local[7u].member_3;
                                                        if (_e1065 != 4294967295u) {
                                                            let _e1069 = local[7u].member;
                                                            phi_2780_ = _e1069;
                                                        } else {
                                                            phi_2780_ = _e621;
                                                        }
                                                        let _e1071 = phi_2780_;
                                                        phi_2779_ = _e1071;
                                                        phi_2630_ = _e1062;
                                                    } else {
                                                        phi_2779_ = _e621;
                                                        phi_2630_ = _e619;
                                                    }
                                                    let _e1073 = phi_2779_;
                                                    let _e1075 = phi_2630_;
                                                    phi_2778_ = _e1073;
                                                    phi_2629_ = _e1075;
                                                } else {
                                                    phi_2778_ = _e621;
                                                    phi_2629_ = _e619;
                                                }
                                                let _e1077 = phi_2778_;
                                                let _e1079 = phi_2629_;
                                                phi_2777_ = _e1077;
                                                phi_2628_ = _e1079;
                                            } else {
                                                phi_2777_ = _e621;
                                                phi_2628_ = _e619;
                                            }
                                            let _e1081 = phi_2777_;
                                            let _e1083 = phi_2628_;
                                            continue;
                                            continuing {
                                                phi_2526_ = _e1083;
                                                phi_2516_ = _e1081;
                                                phi_1031_ = _e636;
                                                phi_2717_ = _e1081;
                                                phi_2627_ = _e1083;
                                                break if !(_e642);
                                            }
                                        }
                                        let _e1086 = phi_2717_;
                                        let _e1088 = phi_2627_;
                                        phi_2632_ = _e1088;
                                        if _e1088 {
                                            break;
                                        }
                                        phi_2682_ = _e1086;
                                        phi_2636_ = _e1088;
                                        phi_2300_ = _e418;
                                        phi_2301_ = false;
                                        phi_2302_ = _e422;
                                    } else {
                                        if (_e418 >= _e67) {
                                            phi_1905_ = type_38(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e418 < _e67) {
                                            } else {
                                                phi_2632_ = true;
                                                break;
                                            }
                                            let _e432 = (_e195 % 3u);
                                            if (_e432 < 3u) {
                                            } else {
                                                phi_2632_ = true;
                                                break;
                                            }
                                            let _e438 = global_2.member[_e418].member[_e432];
                                            let _e444 = (_e194 % 3u);
                                            if (_e444 < 3u) {
                                            } else {
                                                phi_2632_ = true;
                                                break;
                                            }
                                            let _e450 = global_2.member[_e418].member[_e444];
                                            let _e456 = (_e196 % 3u);
                                            if (_e456 < 3u) {
                                            } else {
                                                phi_2632_ = true;
                                                break;
                                            }
                                            let _e462 = global_2.member[_e418].member[_e456];
                                            let _e472 = global_2.member[_e418].member_1;
                                            let _e476 = global_2.member[_e418].member_2;
                                            phi_1905_ = type_38(array<vec4<f32>, 3>(vec4<f32>(_e438[0], _e438[1], _e438[2], _e438[3]), vec4<f32>(_e450[0], _e450[1], _e450[2], _e450[3]), vec4<f32>(_e462[0], _e462[1], _e462[2], _e462[3])), _e472, _e476);
                                        }
                                        let _e479 = phi_1905_;
                                        let _e490 = ((_e479.member[0].x - _e259) * _e264);
                                        let _e491 = ((_e479.member[0].y - _e259) * _e264);
                                        let _e492 = ((_e479.member[0].z - _e260) * _e264);
                                        let _e493 = ((_e479.member[0].w - _e260) * _e264);
                                        let _e503 = ((_e479.member[1].x - _e297) * _e302);
                                        let _e504 = ((_e479.member[1].y - _e297) * _e302);
                                        let _e505 = ((_e479.member[1].z - _e298) * _e302);
                                        let _e506 = ((_e479.member[1].w - _e298) * _e302);
                                        let _e516 = ((_e479.member[2].x - _e335) * _e340);
                                        let _e517 = ((_e479.member[2].y - _e335) * _e340);
                                        let _e518 = ((_e479.member[2].z - _e336) * _e340);
                                        let _e519 = ((_e479.member[2].w - _e336) * _e340);
                                        let _e521 = select(_e518, _e516, (_e516 < _e518));
                                        let _e523 = select(_e519, _e517, (_e517 < _e519));
                                        let _e525 = select(_e518, _e516, (_e516 > _e518));
                                        let _e527 = select(_e519, _e517, (_e517 > _e519));
                                        let _e529 = select(_e492, _e490, (_e490 < _e492));
                                        let _e531 = select(_e493, _e491, (_e491 < _e493));
                                        let _e533 = select(_e505, _e503, (_e503 < _e505));
                                        let _e535 = select(_e506, _e504, (_e504 < _e506));
                                        let _e537 = select(_e533, _e529, (_e529 > _e533));
                                        let _e539 = select(_e535, _e531, (_e531 > _e535));
                                        let _e541 = select(_e521, _e537, (_e537 > _e521));
                                        let _e543 = select(_e523, _e539, (_e539 > _e523));
                                        let _e545 = select(_e492, _e490, (_e490 > _e492));
                                        let _e547 = select(_e493, _e491, (_e491 > _e493));
                                        let _e549 = select(_e505, _e503, (_e503 > _e505));
                                        let _e551 = select(_e506, _e504, (_e504 > _e506));
                                        let _e553 = select(_e549, _e545, (_e545 < _e549));
                                        let _e555 = select(_e551, _e547, (_e547 < _e551));
                                        let _e560 = -(_e521);
                                        let _e561 = -(_e523);
                                        let _e568 = (select(_e525, _e553, (_e553 < _e525)) + (select(_e560, _e525, (_e525 > _e560)) * 0.0000019073523f));
                                        let _e569 = (select(_e527, _e555, (_e555 < _e527)) + (select(_e561, _e527, (_e527 > _e561)) * 0.0000019073523f));
                                        let _e571 = select(_e387, _e541, (_e541 > _e387));
                                        let _e573 = select(_e387, _e543, (_e543 > _e387));
                                        let _e578 = (_e571 <= select(_e396, _e568, (_e568 < _e396)));
                                        let _e579 = (_e573 <= select(_e396, _e569, (_e569 < _e396)));
                                        let _e580 = (_e571 <= _e573);
                                        if _e578 {
                                            if _e579 {
                                                if _e580 {
                                                    phi_2250_ = _e479.member_2;
                                                } else {
                                                    phi_2250_ = _e479.member_1;
                                                }
                                                let _e584 = phi_2250_;
                                                let _e585 = (_e422 % 128u);
                                                let _e586 = (_e585 < 128u);
                                                if _e586 {
                                                } else {
                                                    phi_2632_ = true;
                                                    break;
                                                }
                                                local_2[_e585] = _e584;
                                                if _e586 {
                                                } else {
                                                    phi_2632_ = true;
                                                    break;
                                                }
                                                local_1[_e585] = select(_e573, _e571, (_e571 > _e573));
                                                if _e580 {
                                                    phi_2277_ = _e479.member_1;
                                                } else {
                                                    phi_2277_ = _e479.member_2;
                                                }
                                                let _e595 = phi_2277_;
                                                phi_2278_ = _e595;
                                                phi_2279_ = (_e422 + 1u);
                                            } else {
                                                phi_2278_ = u32();
                                                phi_2279_ = u32();
                                            }
                                            let _e597 = phi_2278_;
                                            let _e599 = phi_2279_;
                                            phi_2281_ = _e597;
                                            phi_2282_ = _e599;
                                            phi_2283_ = select(true, false, _e579);
                                        } else {
                                            phi_2281_ = u32();
                                            phi_2282_ = u32();
                                            phi_2283_ = true;
                                        }
                                        let _e602 = phi_2281_;
                                        let _e604 = phi_2282_;
                                        let _e606 = phi_2283_;
                                        if _e606 {
                                            if _e578 {
                                                phi_2292_ = _e479.member_1;
                                            } else {
                                                phi_2292_ = _e479.member_2;
                                            }
                                            let _e610 = phi_2292_;
                                            phi_2297_ = _e610;
                                            phi_2298_ = select(_e579, true, _e578);
                                        } else {
                                            phi_2297_ = _e602;
                                            phi_2298_ = _e420;
                                        }
                                        let _e613 = phi_2297_;
                                        let _e615 = phi_2298_;
                                        phi_2682_ = _e396;
                                        phi_2636_ = _e394;
                                        phi_2300_ = _e613;
                                        phi_2301_ = _e615;
                                        phi_2302_ = select(_e604, _e422, _e606);
                                    }
                                    let _e1090 = phi_2682_;
                                    let _e1092 = phi_2636_;
                                    let _e1094 = phi_2300_;
                                    let _e1096 = phi_2301_;
                                    let _e1098 = phi_2302_;
                                    phi_2681_ = _e1090;
                                    phi_2635_ = _e1092;
                                    phi_2303_ = _e1094;
                                    phi_2304_ = (_e400 - 1u);
                                    phi_2305_ = _e1096;
                                    phi_2306_ = _e1098;
                                } else {
                                    phi_2681_ = _e396;
                                    phi_2635_ = _e394;
                                    phi_2303_ = _e418;
                                    phi_2304_ = _e400;
                                    phi_2305_ = _e420;
                                    phi_2306_ = _e422;
                                }
                                let _e1100 = phi_2681_;
                                let _e1102 = phi_2635_;
                                let _e1104 = phi_2303_;
                                let _e1106 = phi_2304_;
                                let _e1108 = phi_2305_;
                                let _e1110 = phi_2306_;
                                phi_2680_ = _e1100;
                                phi_2634_ = _e1102;
                                phi_2307_ = _e1104;
                                phi_2308_ = _e1106;
                                phi_2309_ = _e1108;
                                phi_2310_ = _e1110;
                            } else {
                                phi_2680_ = _e396;
                                phi_2634_ = _e394;
                                phi_2307_ = u32();
                                phi_2308_ = u32();
                                phi_2309_ = bool();
                                phi_2310_ = u32();
                            }
                            let _e1112 = phi_2680_;
                            let _e1114 = phi_2634_;
                            let _e1116 = phi_2307_;
                            let _e1118 = phi_2308_;
                            let _e1120 = phi_2309_;
                            let _e1122 = phi_2310_;
                            phi_2679_ = _e1112;
                            phi_2633_ = _e1114;
                            phi_965_ = _e1116;
                            phi_968_ = _e1118;
                            phi_970_ = _e1120;
                            phi_972_ = _e1122;
                            phi_2311_ = _e408;
                        } else {
                            phi_2679_ = _e396;
                            phi_2633_ = _e394;
                            phi_965_ = u32();
                            phi_968_ = u32();
                            phi_970_ = bool();
                            phi_972_ = u32();
                            phi_2311_ = false;
                        }
                        let _e1124 = phi_2679_;
                        let _e1126 = phi_2633_;
                        let _e1128 = phi_965_;
                        let _e1130 = phi_968_;
                        let _e1132 = phi_970_;
                        let _e1134 = phi_972_;
                        let _e1136 = phi_2311_;
                        continue;
                        continuing {
                            phi_2529_ = _e1126;
                            phi_2509_ = _e1124;
                            phi_964_ = _e1128;
                            phi_967_ = _e1130;
                            phi_969_ = _e1132;
                            phi_971_ = _e1134;
                            phi_2632_ = _e1126;
                            break if !(_e1136);
                        }
                    }
                    let _e1139 = phi_2632_;
                    if _e1139 {
                        break;
                    }
                    phi_2318_ = type_4(0u, 8u);
                    loop {
                        let _e1141 = phi_2318_;
                        if (_e1141.member < _e1141.member_1) {
                            phi_2319_ = type_4((_e1141.member + 1u), _e1141.member_1);
                            phi_2342_ = type_4(1u, _e1141.member);
                        } else {
                            phi_2319_ = _e1141;
                            phi_2342_ = type_4(0u, type_4().member_1);
                        }
                        let _e1154 = phi_2319_;
                        let _e1156 = phi_2342_;
                        let _e1160 = (bitcast<i32>(_e1156.member) != 0i);
                        if _e1160 {
                            let _e1161 = (_e1156.member_1 < 8u);
                            if _e1161 {
                            } else {
                                phi_2672_ = true;
                                break;
                            }
                            let _e1163 = local[_e1156.member_1];
                            if (_e1163.member_3 != 4294967295u) {
                                let _e1169 = -(_e354);
                                let _e1170 = (_e1169 / 3i);
                                let _e1177 = bitcast<f32>((bitcast<u32>((_e1170 + 127i)) << bitcast<u32>(23i)));
                                let _e1185 = (((_e1163.member * _e1177) * _e1177) * bitcast<f32>((bitcast<u32>(((_e1169 - (2i * _e1170)) + 127i)) << bitcast<u32>(23i))));
                                let _e1187 = select(340282350000000000000000000000000000000f, _e1185, (_e1185 < 340282350000000000000000000000000000000f));
                                phi_2408_ = type_23(select(-340282350000000000000000000000000000000f, _e1187, (_e1187 > -340282350000000000000000000000000000000f)), _e1163.member_1, _e1163.member_2, _e1163.member_3);
                            } else {
                                phi_2408_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1192 = phi_2408_;
                            if _e1161 {
                            } else {
                                phi_2672_ = true;
                                break;
                            }
                            local[_e1156.member_1] = type_23(_e1192.member, _e1192.member_1, _e1192.member_2, _e1192.member_3);
                        }
                        continue;
                        continuing {
                            phi_2318_ = _e1154;
                            phi_2672_ = _e1139;
                            break if !(_e1160);
                        }
                    }
                    let _e1200 = phi_2672_;
                    if _e1200 {
                        break;
                    }
                    let _e1201 = local;
                    if _e83 {
                    } else {
                        break;
                    }
                    global_5.member[_e77] = array<type_23, 8>(type_23(_e1201[0].member, _e1201[0].member_1, _e1201[0].member_2, _e1201[0].member_3), type_23(_e1201[1].member, _e1201[1].member_1, _e1201[1].member_2, _e1201[1].member_3), type_23(_e1201[2].member, _e1201[2].member_1, _e1201[2].member_2, _e1201[2].member_3), type_23(_e1201[3].member, _e1201[3].member_1, _e1201[3].member_2, _e1201[3].member_3), type_23(_e1201[4].member, _e1201[4].member_1, _e1201[4].member_2, _e1201[4].member_3), type_23(_e1201[5].member, _e1201[5].member_1, _e1201[5].member_2, _e1201[5].member_3), type_23(_e1201[6].member, _e1201[6].member_1, _e1201[6].member_2, _e1201[6].member_3), type_23(_e1201[7].member, _e1201[7].member_1, _e1201[7].member_2, _e1201[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
