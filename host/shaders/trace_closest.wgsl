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
    member: type_20,
    member_1: f32,
}

struct type_43 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_46 {
    member: array<type_24>,
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
var<storage, read_write> global_5: type_22;

fn function_() {
    var local: array<u32, 128>;
    var local_1: array<f32, 128>;
    var phi_259_: i32;
    var phi_260_: i32;
    var phi_270_: bool;
    var phi_280_: u32;
    var phi_281_: u32;
    var phi_283_: bool;
    var phi_288_: u32;
    var phi_332_: f32;
    var phi_338_: f32;
    var phi_349_: f32;
    var phi_355_: f32;
    var phi_378_: f32;
    var phi_393_: f32;
    var phi_402_: f32;
    var phi_408_: f32;
    var phi_419_: f32;
    var phi_425_: f32;
    var phi_448_: f32;
    var phi_463_: f32;
    var phi_472_: f32;
    var phi_478_: f32;
    var phi_489_: f32;
    var phi_495_: f32;
    var phi_518_: f32;
    var phi_533_: f32;
    var phi_633_: f32;
    var phi_634_: f32;
    var phi_1999_: bool;
    var phi_645_: type_40;
    var phi_648_: u32;
    var phi_650_: u32;
    var phi_652_: bool;
    var phi_654_: u32;
    var phi_665_: bool;
    var phi_695_: u32;
    var phi_696_: bool;
    var phi_697_: u32;
    var phi_1517_: type_43;
    var phi_1861_: u32;
    var phi_1887_: u32;
    var phi_1888_: u32;
    var phi_1889_: u32;
    var phi_1891_: u32;
    var phi_1892_: u32;
    var phi_1893_: bool;
    var phi_1902_: u32;
    var phi_1907_: u32;
    var phi_1908_: bool;
    var phi_713_: type_40;
    var phi_716_: type_4;
    var phi_717_: type_4;
    var phi_739_: type_4;
    var phi_759_: u32;
    var phi_847_: array<array<f32, 3>, 3>;
    var phi_1318_: vec3<f32>;
    var phi_1319_: vec3<f32>;
    var phi_1350_: bool;
    var phi_1359_: vec3<f32>;
    var phi_1399_: type_20;
    var phi_1401_: type_20;
    var phi_1402_: bool;
    var phi_1406_: type_20;
    var phi_1407_: type_20;
    var phi_1408_: type_20;
    var phi_1409_: bool;
    var phi_1413_: type_20;
    var phi_1414_: bool;
    var phi_1418_: type_20;
    var phi_1419_: bool;
    var phi_1423_: type_20;
    var phi_1448_: bool;
    var phi_1449_: bool;
    var phi_1455_: type_40;
    var phi_1456_: type_40;
    var phi_1457_: type_40;
    var phi_714_: type_40;
    var phi_1993_: bool;
    var phi_2107_: bool;
    var phi_1910_: type_40;
    var phi_1911_: u32;
    var phi_1912_: bool;
    var phi_1913_: u32;
    var phi_2106_: bool;
    var phi_1914_: type_40;
    var phi_1915_: u32;
    var phi_1916_: u32;
    var phi_1917_: bool;
    var phi_1918_: u32;
    var phi_2105_: bool;
    var phi_1919_: type_40;
    var phi_1920_: u32;
    var phi_1921_: u32;
    var phi_1922_: bool;
    var phi_1923_: u32;
    var phi_2104_: bool;
    var phi_646_: type_40;
    var phi_649_: u32;
    var phi_651_: u32;
    var phi_653_: bool;
    var phi_655_: u32;
    var phi_1924_: bool;
    var phi_2103_: bool;
    var local_2: type_40;
    var phi_1976_: type_20;
    var local_3: type_40;

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
                            phi_259_ = (bitcast<i32>((_e155 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_259_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e155)), 32u, (_e155 == 0u))));
                        }
                        let _e169 = phi_259_;
                        phi_260_ = _e169;
                    } else {
                        phi_260_ = 0i;
                    }
                    let _e171 = phi_260_;
                    let _e172 = (_e88 == _e127);
                    if _e172 {
                        phi_270_ = true;
                    } else {
                        phi_270_ = (_e95 == _e127);
                    }
                    let _e175 = phi_270_;
                    let _e176 = select(1u, 0u, _e172);
                    if _e175 {
                        let _e177 = (_e176 + 1u);
                        phi_280_ = _e177;
                        phi_281_ = _e177;
                        phi_283_ = select(true, false, (_e177 == 2u));
                    } else {
                        phi_280_ = u32();
                        phi_281_ = 0u;
                        phi_283_ = true;
                    }
                    let _e181 = phi_280_;
                    let _e183 = phi_281_;
                    let _e185 = phi_283_;
                    if _e185 {
                        phi_288_ = (_e183 + 1u);
                    } else {
                        phi_288_ = 0u;
                    }
                    let _e189 = phi_288_;
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
                        phi_332_ = _e220[0];
                    } else {
                        phi_332_ = _e220[1];
                    }
                    let _e225 = phi_332_;
                    let _e226 = (_e190 == 2u);
                    if _e226 {
                        phi_338_ = _e220[2];
                    } else {
                        phi_338_ = _e225;
                    }
                    let _e229 = phi_338_;
                    let _e231 = ((_e229 * _e197) * _e203);
                    let _e232 = global_4.member[_e72].member_2;
                    if _e221 {
                        phi_349_ = _e232[0];
                    } else {
                        phi_349_ = _e232[1];
                    }
                    let _e236 = phi_349_;
                    if _e226 {
                        phi_355_ = _e232[2];
                    } else {
                        phi_355_ = _e236;
                    }
                    let _e239 = phi_355_;
                    let _e241 = ((_e239 * _e210) * _e216);
                    let _e245 = (bitcast<f32>((bitcast<u32>(_e241) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e245 {
                        let _e249 = (bitcast<f32>((bitcast<u32>(_e231) & 2147483647u)) * 0.00000011920929f);
                        phi_378_ = select(0.00000000000000000086736174f, _e249, (_e249 > 0.00000000000000000086736174f));
                    } else {
                        phi_378_ = 0f;
                    }
                    let _e253 = phi_378_;
                    let _e254 = (_e231 + _e253);
                    let _e255 = (_e231 - _e253);
                    let _e256 = select(_e241, 0f, _e245);
                    if _e245 {
                        phi_393_ = 1267650600000000000000000000000f;
                    } else {
                        phi_393_ = (1f / _e241);
                    }
                    let _e259 = phi_393_;
                    let _e260 = (_e189 == 0u);
                    if _e260 {
                        phi_402_ = _e220[0];
                    } else {
                        phi_402_ = _e220[1];
                    }
                    let _e264 = phi_402_;
                    let _e265 = (_e189 == 2u);
                    if _e265 {
                        phi_408_ = _e220[2];
                    } else {
                        phi_408_ = _e264;
                    }
                    let _e268 = phi_408_;
                    let _e270 = ((_e268 * _e197) * _e203);
                    if _e260 {
                        phi_419_ = _e232[0];
                    } else {
                        phi_419_ = _e232[1];
                    }
                    let _e274 = phi_419_;
                    if _e265 {
                        phi_425_ = _e232[2];
                    } else {
                        phi_425_ = _e274;
                    }
                    let _e277 = phi_425_;
                    let _e279 = ((_e277 * _e210) * _e216);
                    let _e283 = (bitcast<f32>((bitcast<u32>(_e279) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e283 {
                        let _e287 = (bitcast<f32>((bitcast<u32>(_e270) & 2147483647u)) * 0.00000011920929f);
                        phi_448_ = select(0.00000000000000000086736174f, _e287, (_e287 > 0.00000000000000000086736174f));
                    } else {
                        phi_448_ = 0f;
                    }
                    let _e291 = phi_448_;
                    let _e292 = (_e270 + _e291);
                    let _e293 = (_e270 - _e291);
                    let _e294 = select(_e279, 0f, _e283);
                    if _e283 {
                        phi_463_ = 1267650600000000000000000000000f;
                    } else {
                        phi_463_ = (1f / _e279);
                    }
                    let _e297 = phi_463_;
                    let _e298 = (_e191 == 0u);
                    if _e298 {
                        phi_472_ = _e220[0];
                    } else {
                        phi_472_ = _e220[1];
                    }
                    let _e302 = phi_472_;
                    let _e303 = (_e191 == 2u);
                    if _e303 {
                        phi_478_ = _e220[2];
                    } else {
                        phi_478_ = _e302;
                    }
                    let _e306 = phi_478_;
                    let _e308 = ((_e306 * _e197) * _e203);
                    if _e298 {
                        phi_489_ = _e232[0];
                    } else {
                        phi_489_ = _e232[1];
                    }
                    let _e312 = phi_489_;
                    if _e303 {
                        phi_495_ = _e232[2];
                    } else {
                        phi_495_ = _e312;
                    }
                    let _e315 = phi_495_;
                    let _e317 = ((_e315 * _e210) * _e216);
                    let _e321 = (bitcast<f32>((bitcast<u32>(_e317) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e321 {
                        let _e325 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) * 0.00000011920929f);
                        phi_518_ = select(0.00000000000000000086736174f, _e325, (_e325 > 0.00000000000000000086736174f));
                    } else {
                        phi_518_ = 0f;
                    }
                    let _e329 = phi_518_;
                    let _e330 = (_e308 + _e329);
                    let _e331 = (_e308 - _e329);
                    let _e332 = select(_e317, 0f, _e321);
                    if _e321 {
                        phi_533_ = 1267650600000000000000000000000f;
                    } else {
                        phi_533_ = (1f / _e317);
                    }
                    let _e335 = phi_533_;
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
                        phi_633_ = select(-340282350000000000000000000000000000000f, _e376, (_e376 > -340282350000000000000000000000000000000f));
                        phi_634_ = select(-340282350000000000000000000000000000000f, _e369, (_e369 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_633_ = 0f;
                        phi_634_ = 1f;
                    }
                    let _e380 = phi_633_;
                    let _e382 = phi_634_;
                    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_1999_ = false;
                    phi_645_ = type_40(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e380);
                    phi_648_ = select(0u, 2147483648u, (_e62 == 0u));
                    phi_650_ = ((3u * _e62) + 1u);
                    phi_652_ = (_e382 <= _e380);
                    phi_654_ = 0u;
                    loop {
                        let _e390 = phi_1999_;
                        let _e392 = phi_645_;
                        let _e394 = phi_648_;
                        let _e396 = phi_650_;
                        let _e398 = phi_652_;
                        let _e400 = phi_654_;
                        local_2 = _e392;
                        if _e398 {
                            phi_665_ = true;
                        } else {
                            phi_665_ = (_e400 > 0u);
                        }
                        let _e403 = phi_665_;
                        if _e403 {
                            let _e404 = (_e396 > 0u);
                            if _e404 {
                                if _e398 {
                                    phi_695_ = _e394;
                                    phi_696_ = _e398;
                                    phi_697_ = _e400;
                                } else {
                                    let _e405 = (_e400 - 1u);
                                    let _e406 = (_e405 % 128u);
                                    let _e407 = (_e406 < 128u);
                                    if _e407 {
                                    } else {
                                        phi_2103_ = true;
                                        break;
                                    }
                                    let _e409 = local[_e406];
                                    if _e407 {
                                    } else {
                                        phi_2103_ = true;
                                        break;
                                    }
                                    let _e411 = local_1[_e406];
                                    phi_695_ = _e409;
                                    phi_696_ = (_e411 <= _e392.member_1);
                                    phi_697_ = _e405;
                                }
                                let _e415 = phi_695_;
                                let _e417 = phi_696_;
                                let _e419 = phi_697_;
                                if _e417 {
                                    let _e423 = (_e415 & 268435455u);
                                    if ((_e415 & 2147483648u) != 0u) {
                                        phi_713_ = _e392;
                                        phi_716_ = type_4(_e423, (_e423 + ((_e415 >> bitcast<u32>(28u)) & 7u)));
                                        loop {
                                            let _e618 = phi_713_;
                                            let _e620 = phi_716_;
                                            local_3 = _e618;
                                            if (_e620.member < _e620.member_1) {
                                                phi_717_ = type_4((_e620.member + 1u), _e620.member_1);
                                                phi_739_ = type_4(1u, _e620.member);
                                            } else {
                                                phi_717_ = _e620;
                                                phi_739_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e633 = phi_717_;
                                            let _e635 = phi_739_;
                                            let _e639 = (bitcast<i32>(_e635.member) != 0i);
                                            if _e639 {
                                                let _e640 = (_e635.member_1 < _e64);
                                                if _e640 {
                                                    if _e640 {
                                                    } else {
                                                        phi_1993_ = true;
                                                        break;
                                                    }
                                                    let _e644 = global_3.member[_e635.member_1].member_1;
                                                    phi_759_ = _e644;
                                                } else {
                                                    phi_759_ = 4294967295u;
                                                }
                                                let _e646 = phi_759_;
                                                if (_e635.member_1 >= _e64) {
                                                    phi_847_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e640 {
                                                    } else {
                                                        phi_1993_ = true;
                                                        break;
                                                    }
                                                    let _e648 = (_e190 % 3u);
                                                    let _e649 = (_e189 % 3u);
                                                    let _e650 = (_e191 % 3u);
                                                    if (_e648 < 9u) {
                                                    } else {
                                                        phi_1993_ = true;
                                                        break;
                                                    }
                                                    let _e656 = global_3.member[_e635.member_1].member[_e648];
                                                    if (_e649 < 9u) {
                                                    } else {
                                                        phi_1993_ = true;
                                                        break;
                                                    }
                                                    let _e662 = global_3.member[_e635.member_1].member[_e649];
                                                    if (_e650 < 9u) {
                                                    } else {
                                                        phi_1993_ = true;
                                                        break;
                                                    }
                                                    let _e668 = global_3.member[_e635.member_1].member[_e650];
                                                    let _e670 = (3u + _e648);
                                                    if (_e670 < 9u) {
                                                    } else {
                                                        phi_1993_ = true;
                                                        break;
                                                    }
                                                    let _e676 = global_3.member[_e635.member_1].member[_e670];
                                                    let _e677 = (3u + _e649);
                                                    if (_e677 < 9u) {
                                                    } else {
                                                        phi_1993_ = true;
                                                        break;
                                                    }
                                                    let _e683 = global_3.member[_e635.member_1].member[_e677];
                                                    let _e684 = (3u + _e650);
                                                    if (_e684 < 9u) {
                                                    } else {
                                                        phi_1993_ = true;
                                                        break;
                                                    }
                                                    let _e690 = global_3.member[_e635.member_1].member[_e684];
                                                    let _e692 = (6u + _e648);
                                                    if (_e692 < 9u) {
                                                    } else {
                                                        phi_1993_ = true;
                                                        break;
                                                    }
                                                    let _e698 = global_3.member[_e635.member_1].member[_e692];
                                                    let _e699 = (6u + _e649);
                                                    if (_e699 < 9u) {
                                                    } else {
                                                        phi_1993_ = true;
                                                        break;
                                                    }
                                                    let _e705 = global_3.member[_e635.member_1].member[_e699];
                                                    let _e706 = (6u + _e650);
                                                    if (_e706 < 9u) {
                                                    } else {
                                                        phi_1993_ = true;
                                                        break;
                                                    }
                                                    let _e712 = global_3.member[_e635.member_1].member[_e706];
                                                    phi_847_ = array<array<f32, 3>, 3>(array<f32, 3>(_e656, _e662, _e668), array<f32, 3>(_e676, _e683, _e690), array<f32, 3>(_e698, _e705, _e712));
                                                }
                                                let _e716 = phi_847_;
                                                let _e724 = (_e716[0][2] - _e308);
                                                let _e727 = (((_e716[0][0] - _e231) * _e332) - (_e724 * _e256));
                                                let _e730 = (((_e716[0][1] - _e270) * _e332) - (_e724 * _e294));
                                                let _e737 = (_e716[1][2] - _e308);
                                                let _e740 = (((_e716[1][0] - _e231) * _e332) - (_e737 * _e256));
                                                let _e743 = (((_e716[1][1] - _e270) * _e332) - (_e737 * _e294));
                                                let _e750 = (_e716[2][2] - _e308);
                                                let _e753 = (((_e716[2][0] - _e231) * _e332) - (_e750 * _e256));
                                                let _e756 = (((_e716[2][1] - _e270) * _e332) - (_e750 * _e294));
                                                let _e757 = (_e753 * _e743);
                                                let _e758 = (_e756 * _e740);
                                                let _e759 = (_e727 * _e756);
                                                let _e760 = (_e730 * _e753);
                                                let _e761 = (_e740 * _e730);
                                                let _e762 = (_e743 * _e727);
                                                let _e767 = (((_e757 >= _e758) && (_e759 >= _e760)) && (_e761 >= _e762));
                                                if (_e767 || (((_e757 <= _e758) && (_e759 <= _e760)) && (_e761 <= _e762))) {
                                                    let _e774 = select(-1f, 1f, _e767);
                                                    let _e776 = ((_e757 - _e758) * _e774);
                                                    let _e778 = select(0f, _e776, (_e776 > 0f));
                                                    let _e780 = ((_e759 - _e760) * _e774);
                                                    let _e782 = select(0f, _e780, (_e780 > 0f));
                                                    let _e784 = ((_e761 - _e762) * _e774);
                                                    let _e786 = select(0f, _e784, (_e784 > 0f));
                                                    let _e788 = ((_e778 + _e782) + _e786);
                                                    if (_e788 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1413_ = type_20();
                                                        phi_1414_ = true;
                                                    } else {
                                                        let _e791 = select(_e716[1][0], _e716[0][0], (_e716[0][0] < _e716[1][0]));
                                                        let _e795 = select(_e716[1][0], _e716[0][0], (_e716[0][0] > _e716[1][0]));
                                                        let _e799 = select(_e716[1][1], _e716[0][1], (_e716[0][1] < _e716[1][1]));
                                                        let _e803 = select(_e716[1][1], _e716[0][1], (_e716[0][1] > _e716[1][1]));
                                                        let _e807 = select(_e716[1][2], _e716[0][2], (_e716[0][2] < _e716[1][2]));
                                                        let _e811 = select(_e716[1][2], _e716[0][2], (_e716[0][2] > _e716[1][2]));
                                                        let _e816 = ((select(_e716[2][0], _e791, (_e791 < _e716[2][0])) - _e254) * _e259);
                                                        let _e817 = ((select(_e716[2][0], _e795, (_e795 > _e716[2][0])) - _e255) * _e259);
                                                        let _e820 = ((select(_e716[2][1], _e799, (_e799 < _e716[2][1])) - _e292) * _e297);
                                                        let _e821 = ((select(_e716[2][1], _e803, (_e803 > _e716[2][1])) - _e293) * _e297);
                                                        let _e824 = ((select(_e716[2][2], _e807, (_e807 < _e716[2][2])) - _e330) * _e335);
                                                        let _e825 = ((select(_e716[2][2], _e811, (_e811 > _e716[2][2])) - _e331) * _e335);
                                                        let _e827 = select(_e825, _e824, (_e824 < _e825));
                                                        let _e829 = select(_e825, _e824, (_e824 > _e825));
                                                        let _e831 = select(_e817, _e816, (_e816 < _e817));
                                                        let _e833 = select(_e821, _e820, (_e820 < _e821));
                                                        let _e835 = select(_e833, _e831, (_e831 > _e833));
                                                        let _e837 = select(_e827, _e835, (_e835 > _e827));
                                                        let _e839 = select(_e817, _e816, (_e816 > _e817));
                                                        let _e841 = select(_e821, _e820, (_e820 > _e821));
                                                        let _e843 = select(_e841, _e839, (_e839 < _e841));
                                                        let _e845 = select(_e829, _e843, (_e843 < _e829));
                                                        let _e846 = -(_e827);
                                                        let _e852 = select(_e382, _e837, (_e837 > _e382));
                                                        if (_e852 > (_e845 + (select(_e846, _e829, (_e829 > _e846)) * 0.0000019073523f))) {
                                                            phi_1408_ = type_20();
                                                            phi_1409_ = true;
                                                        } else {
                                                            let _e854 = (_e852 > _e618.member_1);
                                                            if _e854 {
                                                                phi_1407_ = type_20();
                                                            } else {
                                                                let _e858 = (_e716[1][0] - _e716[0][0]);
                                                                let _e859 = (_e716[1][1] - _e716[0][1]);
                                                                let _e860 = (_e716[1][2] - _e716[0][2]);
                                                                let _e861 = vec3<f32>(_e858, _e859, _e860);
                                                                let _e862 = (_e716[2][0] - _e716[1][0]);
                                                                let _e863 = (_e716[2][1] - _e716[1][1]);
                                                                let _e864 = (_e716[2][2] - _e716[1][2]);
                                                                let _e865 = vec3<f32>(_e862, _e863, _e864);
                                                                let _e866 = (_e716[0][0] - _e716[2][0]);
                                                                let _e867 = (_e716[0][1] - _e716[2][1]);
                                                                let _e868 = (_e716[0][2] - _e716[2][2]);
                                                                let _e869 = vec3<f32>(_e866, _e867, _e868);
                                                                let _e872 = bitcast<f32>((bitcast<u32>(_e858) & 2147483647u));
                                                                let _e875 = bitcast<f32>((bitcast<u32>(_e859) & 2147483647u));
                                                                let _e877 = select(_e875, _e872, (_e872 > _e875));
                                                                let _e880 = bitcast<f32>((bitcast<u32>(_e860) & 2147483647u));
                                                                let _e882 = select(_e880, _e877, (_e877 > _e880));
                                                                let _e885 = bitcast<f32>((bitcast<u32>(_e862) & 2147483647u));
                                                                let _e888 = bitcast<f32>((bitcast<u32>(_e863) & 2147483647u));
                                                                let _e890 = select(_e888, _e885, (_e885 > _e888));
                                                                let _e893 = bitcast<f32>((bitcast<u32>(_e864) & 2147483647u));
                                                                let _e895 = select(_e893, _e890, (_e890 > _e893));
                                                                let _e898 = bitcast<f32>((bitcast<u32>(_e866) & 2147483647u));
                                                                let _e901 = bitcast<f32>((bitcast<u32>(_e867) & 2147483647u));
                                                                let _e903 = select(_e901, _e898, (_e898 > _e901));
                                                                let _e906 = bitcast<f32>((bitcast<u32>(_e868) & 2147483647u));
                                                                let _e908 = select(_e906, _e903, (_e903 > _e906));
                                                                let _e910 = select(_e895, _e882, (_e882 > _e895));
                                                                let _e912 = select(_e908, _e910, (_e910 > _e908));
                                                                if (_e882 == _e912) {
                                                                    phi_1318_ = _e865;
                                                                    phi_1319_ = _e869;
                                                                } else {
                                                                    let _e915 = vec3((_e895 == _e912));
                                                                    phi_1318_ = select(_e861, _e869, _e915);
                                                                    phi_1319_ = select(_e865, _e861, _e915);
                                                                }
                                                                let _e919 = phi_1318_;
                                                                let _e921 = phi_1319_;
                                                                let _e928 = ((_e919.y * _e921.z) - (_e921.y * _e919.z));
                                                                let _e933 = ((_e919.z * _e921.x) - (_e921.z * _e919.x));
                                                                let _e936 = ((_e919.x * _e921.y) - (_e921.x * _e919.y));
                                                                if (_e778 >= _e782) {
                                                                    phi_1350_ = select(true, false, (_e778 >= _e786));
                                                                } else {
                                                                    phi_1350_ = true;
                                                                }
                                                                let _e941 = phi_1350_;
                                                                if _e941 {
                                                                    phi_1359_ = select(vec3<f32>(_e716[2][0], _e716[2][1], _e716[2][2]), vec3<f32>(_e716[1][0], _e716[1][1], _e716[1][2]), vec3((_e782 >= _e786)));
                                                                } else {
                                                                    phi_1359_ = vec3<f32>(_e716[0][0], _e716[0][1], _e716[0][2]);
                                                                }
                                                                let _e946 = phi_1359_;
                                                                let _e963 = ((((_e928 * (_e946.x - _e231)) + (_e933 * (_e946.y - _e270))) + (_e936 * (_e946.z - _e308))) / (((_e928 * _e256) + (_e933 * _e294)) + (_e936 * _e332)));
                                                                let _e965 = select(_e845, _e963, (_e963 < _e845));
                                                                let _e967 = select(_e837, _e965, (_e965 > _e837));
                                                                if (_e967 >= _e382) {
                                                                    let _e969 = (_e967 <= _e618.member_1);
                                                                    if _e969 {
                                                                        let _e970 = (1f / _e788);
                                                                        phi_1399_ = type_20(_e967, (_e782 * _e970), (_e786 * _e970), _e646);
                                                                    } else {
                                                                        phi_1399_ = type_20();
                                                                    }
                                                                    let _e975 = phi_1399_;
                                                                    phi_1401_ = _e975;
                                                                    phi_1402_ = select(true, false, _e969);
                                                                } else {
                                                                    phi_1401_ = type_20();
                                                                    phi_1402_ = true;
                                                                }
                                                                let _e978 = phi_1401_;
                                                                let _e980 = phi_1402_;
                                                                if _e980 {
                                                                    phi_1406_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1406_ = _e978;
                                                                }
                                                                let _e982 = phi_1406_;
                                                                phi_1407_ = _e982;
                                                            }
                                                            let _e984 = phi_1407_;
                                                            phi_1408_ = _e984;
                                                            phi_1409_ = _e854;
                                                        }
                                                        let _e986 = phi_1408_;
                                                        let _e988 = phi_1409_;
                                                        phi_1413_ = _e986;
                                                        phi_1414_ = _e988;
                                                    }
                                                    let _e990 = phi_1413_;
                                                    let _e992 = phi_1414_;
                                                    phi_1418_ = _e990;
                                                    phi_1419_ = _e992;
                                                } else {
                                                    phi_1418_ = type_20();
                                                    phi_1419_ = true;
                                                }
                                                let _e994 = phi_1418_;
                                                let _e996 = phi_1419_;
                                                if _e996 {
                                                    phi_1423_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1423_ = _e994;
                                                }
                                                let _e998 = phi_1423_;
                                                if (_e998.member_3 != 4294967295u) {
                                                    if (_e646 != 4294967295u) {
                                                        if (_e998.member < _e618.member.member) {
                                                            phi_1449_ = true;
                                                        } else {
                                                            if (_e998.member == _e618.member.member) {
                                                                phi_1448_ = (_e998.member_3 < _e618.member.member_3);
                                                            } else {
                                                                phi_1448_ = false;
                                                            }
                                                            let _e1011 = phi_1448_;
                                                            phi_1449_ = _e1011;
                                                        }
                                                        let _e1013 = phi_1449_;
                                                        if _e1013 {
                                                            phi_1455_ = type_40(_e998, _e998.member);
                                                        } else {
                                                            phi_1455_ = _e618;
                                                        }
                                                        let _e1016 = phi_1455_;
                                                        phi_1456_ = _e1016;
                                                    } else {
                                                        phi_1456_ = _e618;
                                                    }
                                                    let _e1018 = phi_1456_;
                                                    phi_1457_ = _e1018;
                                                } else {
                                                    phi_1457_ = _e618;
                                                }
                                                let _e1020 = phi_1457_;
                                                phi_714_ = _e1020;
                                            } else {
                                                phi_714_ = type_40();
                                            }
                                            let _e1022 = phi_714_;
                                            continue;
                                            continuing {
                                                phi_713_ = _e1022;
                                                phi_716_ = _e633;
                                                phi_1993_ = _e390;
                                                break if !(_e639);
                                            }
                                        }
                                        let _e1025 = phi_1993_;
                                        phi_2103_ = _e1025;
                                        if _e1025 {
                                            break;
                                        }
                                        phi_2107_ = _e1025;
                                        let _e1191 = local_3;
                                        phi_1910_ = _e1191;
                                        phi_1911_ = _e415;
                                        phi_1912_ = false;
                                        phi_1913_ = _e419;
                                    } else {
                                        if (_e415 >= _e62) {
                                            phi_1517_ = type_43(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e415 < _e62) {
                                            } else {
                                                phi_2103_ = true;
                                                break;
                                            }
                                            let _e429 = (_e190 % 3u);
                                            if (_e429 < 3u) {
                                            } else {
                                                phi_2103_ = true;
                                                break;
                                            }
                                            let _e435 = global_2.member[_e415].member[_e429];
                                            let _e441 = (_e189 % 3u);
                                            if (_e441 < 3u) {
                                            } else {
                                                phi_2103_ = true;
                                                break;
                                            }
                                            let _e447 = global_2.member[_e415].member[_e441];
                                            let _e453 = (_e191 % 3u);
                                            if (_e453 < 3u) {
                                            } else {
                                                phi_2103_ = true;
                                                break;
                                            }
                                            let _e459 = global_2.member[_e415].member[_e453];
                                            let _e469 = global_2.member[_e415].member_1;
                                            let _e473 = global_2.member[_e415].member_2;
                                            phi_1517_ = type_43(array<vec4<f32>, 3>(vec4<f32>(_e435[0], _e435[1], _e435[2], _e435[3]), vec4<f32>(_e447[0], _e447[1], _e447[2], _e447[3]), vec4<f32>(_e459[0], _e459[1], _e459[2], _e459[3])), _e469, _e473);
                                        }
                                        let _e476 = phi_1517_;
                                        let _e488 = ((_e476.member[0].x - _e254) * _e259);
                                        let _e489 = ((_e476.member[0].y - _e254) * _e259);
                                        let _e490 = ((_e476.member[0].z - _e255) * _e259);
                                        let _e491 = ((_e476.member[0].w - _e255) * _e259);
                                        let _e501 = ((_e476.member[1].x - _e292) * _e297);
                                        let _e502 = ((_e476.member[1].y - _e292) * _e297);
                                        let _e503 = ((_e476.member[1].z - _e293) * _e297);
                                        let _e504 = ((_e476.member[1].w - _e293) * _e297);
                                        let _e514 = ((_e476.member[2].x - _e330) * _e335);
                                        let _e515 = ((_e476.member[2].y - _e330) * _e335);
                                        let _e516 = ((_e476.member[2].z - _e331) * _e335);
                                        let _e517 = ((_e476.member[2].w - _e331) * _e335);
                                        let _e519 = select(_e516, _e514, (_e514 < _e516));
                                        let _e521 = select(_e517, _e515, (_e515 < _e517));
                                        let _e523 = select(_e516, _e514, (_e514 > _e516));
                                        let _e525 = select(_e517, _e515, (_e515 > _e517));
                                        let _e527 = select(_e490, _e488, (_e488 < _e490));
                                        let _e529 = select(_e491, _e489, (_e489 < _e491));
                                        let _e531 = select(_e503, _e501, (_e501 < _e503));
                                        let _e533 = select(_e504, _e502, (_e502 < _e504));
                                        let _e535 = select(_e531, _e527, (_e527 > _e531));
                                        let _e537 = select(_e533, _e529, (_e529 > _e533));
                                        let _e539 = select(_e519, _e535, (_e535 > _e519));
                                        let _e541 = select(_e521, _e537, (_e537 > _e521));
                                        let _e543 = select(_e490, _e488, (_e488 > _e490));
                                        let _e545 = select(_e491, _e489, (_e489 > _e491));
                                        let _e547 = select(_e503, _e501, (_e501 > _e503));
                                        let _e549 = select(_e504, _e502, (_e502 > _e504));
                                        let _e551 = select(_e547, _e543, (_e543 < _e547));
                                        let _e553 = select(_e549, _e545, (_e545 < _e549));
                                        let _e558 = -(_e519);
                                        let _e559 = -(_e521);
                                        let _e566 = (select(_e523, _e551, (_e551 < _e523)) + (select(_e558, _e523, (_e523 > _e558)) * 0.0000019073523f));
                                        let _e567 = (select(_e525, _e553, (_e553 < _e525)) + (select(_e559, _e525, (_e525 > _e559)) * 0.0000019073523f));
                                        let _e569 = select(_e382, _e539, (_e539 > _e382));
                                        let _e571 = select(_e382, _e541, (_e541 > _e382));
                                        let _e576 = (_e569 <= select(_e392.member_1, _e566, (_e566 < _e392.member_1)));
                                        let _e577 = (_e571 <= select(_e392.member_1, _e567, (_e567 < _e392.member_1)));
                                        let _e578 = (_e569 <= _e571);
                                        if _e576 {
                                            if _e577 {
                                                if _e578 {
                                                    phi_1861_ = _e476.member_2;
                                                } else {
                                                    phi_1861_ = _e476.member_1;
                                                }
                                                let _e582 = phi_1861_;
                                                let _e583 = (_e419 % 128u);
                                                let _e584 = (_e583 < 128u);
                                                if _e584 {
                                                } else {
                                                    phi_2103_ = true;
                                                    break;
                                                }
                                                local[_e583] = _e582;
                                                if _e584 {
                                                } else {
                                                    phi_2103_ = true;
                                                    break;
                                                }
                                                local_1[_e583] = select(_e571, _e569, (_e569 > _e571));
                                                if _e578 {
                                                    phi_1887_ = _e476.member_1;
                                                } else {
                                                    phi_1887_ = _e476.member_2;
                                                }
                                                let _e593 = phi_1887_;
                                                phi_1888_ = _e593;
                                                phi_1889_ = (_e419 + 1u);
                                            } else {
                                                phi_1888_ = u32();
                                                phi_1889_ = u32();
                                            }
                                            let _e595 = phi_1888_;
                                            let _e597 = phi_1889_;
                                            phi_1891_ = _e595;
                                            phi_1892_ = _e597;
                                            phi_1893_ = select(true, false, _e577);
                                        } else {
                                            phi_1891_ = u32();
                                            phi_1892_ = u32();
                                            phi_1893_ = true;
                                        }
                                        let _e600 = phi_1891_;
                                        let _e602 = phi_1892_;
                                        let _e604 = phi_1893_;
                                        if _e604 {
                                            if _e576 {
                                                phi_1902_ = _e476.member_1;
                                            } else {
                                                phi_1902_ = _e476.member_2;
                                            }
                                            let _e608 = phi_1902_;
                                            phi_1907_ = _e608;
                                            phi_1908_ = select(_e577, true, _e576);
                                        } else {
                                            phi_1907_ = _e600;
                                            phi_1908_ = _e417;
                                        }
                                        let _e611 = phi_1907_;
                                        let _e613 = phi_1908_;
                                        phi_2107_ = _e390;
                                        phi_1910_ = _e392;
                                        phi_1911_ = _e611;
                                        phi_1912_ = _e613;
                                        phi_1913_ = select(_e602, _e419, _e604);
                                    }
                                    let _e1027 = phi_2107_;
                                    let _e1029 = phi_1910_;
                                    let _e1031 = phi_1911_;
                                    let _e1033 = phi_1912_;
                                    let _e1035 = phi_1913_;
                                    phi_2106_ = _e1027;
                                    phi_1914_ = _e1029;
                                    phi_1915_ = _e1031;
                                    phi_1916_ = (_e396 - 1u);
                                    phi_1917_ = _e1033;
                                    phi_1918_ = _e1035;
                                } else {
                                    phi_2106_ = _e390;
                                    phi_1914_ = _e392;
                                    phi_1915_ = _e415;
                                    phi_1916_ = _e396;
                                    phi_1917_ = _e417;
                                    phi_1918_ = _e419;
                                }
                                let _e1037 = phi_2106_;
                                let _e1039 = phi_1914_;
                                let _e1041 = phi_1915_;
                                let _e1043 = phi_1916_;
                                let _e1045 = phi_1917_;
                                let _e1047 = phi_1918_;
                                phi_2105_ = _e1037;
                                phi_1919_ = _e1039;
                                phi_1920_ = _e1041;
                                phi_1921_ = _e1043;
                                phi_1922_ = _e1045;
                                phi_1923_ = _e1047;
                            } else {
                                phi_2105_ = _e390;
                                phi_1919_ = type_40();
                                phi_1920_ = u32();
                                phi_1921_ = u32();
                                phi_1922_ = bool();
                                phi_1923_ = u32();
                            }
                            let _e1049 = phi_2105_;
                            let _e1051 = phi_1919_;
                            let _e1053 = phi_1920_;
                            let _e1055 = phi_1921_;
                            let _e1057 = phi_1922_;
                            let _e1059 = phi_1923_;
                            phi_2104_ = _e1049;
                            phi_646_ = _e1051;
                            phi_649_ = _e1053;
                            phi_651_ = _e1055;
                            phi_653_ = _e1057;
                            phi_655_ = _e1059;
                            phi_1924_ = _e404;
                        } else {
                            phi_2104_ = _e390;
                            phi_646_ = type_40();
                            phi_649_ = u32();
                            phi_651_ = u32();
                            phi_653_ = bool();
                            phi_655_ = u32();
                            phi_1924_ = false;
                        }
                        let _e1061 = phi_2104_;
                        let _e1063 = phi_646_;
                        let _e1065 = phi_649_;
                        let _e1067 = phi_651_;
                        let _e1069 = phi_653_;
                        let _e1071 = phi_655_;
                        let _e1073 = phi_1924_;
                        continue;
                        continuing {
                            phi_1999_ = _e1061;
                            phi_645_ = _e1063;
                            phi_648_ = _e1065;
                            phi_650_ = _e1067;
                            phi_652_ = _e1069;
                            phi_654_ = _e1071;
                            phi_2103_ = _e1061;
                            break if !(_e1073);
                        }
                    }
                    let _e1076 = phi_2103_;
                    if _e1076 {
                        break;
                    }
                    let _e1078 = local_2;
                    if (_e1078.member.member_3 != 4294967295u) {
                        let _e1083 = -(_e349);
                        let _e1084 = (_e1083 / 3i);
                        let _e1091 = bitcast<f32>((bitcast<u32>((_e1084 + 127i)) << bitcast<u32>(23i)));
                        let _e1099 = (((_e1078.member.member * _e1091) * _e1091) * bitcast<f32>((bitcast<u32>(((_e1083 - (2i * _e1084)) + 127i)) << bitcast<u32>(23i))));
                        let _e1101 = select(340282350000000000000000000000000000000f, _e1099, (_e1099 < 340282350000000000000000000000000000000f));
                        phi_1976_ = type_20(select(-340282350000000000000000000000000000000f, _e1101, (_e1101 > -340282350000000000000000000000000000000f)), _e1078.member.member_1, _e1078.member.member_2, _e1078.member.member_3);
                    } else {
                        phi_1976_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1108 = phi_1976_;
                    if _e74 {
                    } else {
                        break;
                    }
                    global_5.member[_e72] = _e1108;
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
