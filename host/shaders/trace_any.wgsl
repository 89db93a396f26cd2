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

struct type_29 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_31 {
    member: array<type_29>,
}

struct type_41 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_44 {
    member: array<type_24>,
}

struct type_46 {
    member: f32,
    member_1: bool,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(1) 
var<storage> global_2: type_31;
@group(0) @binding(2) 
var<storage> global_3: type_18;
@group(0) @binding(3) 
var<storage> global_4: type_44;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_4;

fn function_() {
    var local: array<u32, 128>;
    var local_1: array<f32, 128>;
    var phi_258_: i32;
    var phi_259_: i32;
    var phi_269_: bool;
    var phi_279_: u32;
    var phi_280_: u32;
    var phi_282_: bool;
    var phi_287_: u32;
    var phi_331_: f32;
    var phi_337_: f32;
    var phi_348_: f32;
    var phi_354_: f32;
    var phi_377_: f32;
    var phi_392_: f32;
    var phi_401_: f32;
    var phi_407_: f32;
    var phi_418_: f32;
    var phi_424_: f32;
    var phi_447_: f32;
    var phi_462_: f32;
    var phi_471_: f32;
    var phi_477_: f32;
    var phi_488_: f32;
    var phi_494_: f32;
    var phi_517_: f32;
    var phi_532_: f32;
    var phi_632_: f32;
    var phi_633_: f32;
    var phi_1931_: bool;
    var phi_644_: type_46;
    var phi_647_: u32;
    var phi_649_: u32;
    var phi_651_: bool;
    var phi_653_: u32;
    var phi_664_: bool;
    var phi_694_: u32;
    var phi_695_: bool;
    var phi_696_: u32;
    var phi_1495_: type_41;
    var phi_1839_: u32;
    var phi_1865_: u32;
    var phi_1866_: u32;
    var phi_1867_: u32;
    var phi_1869_: u32;
    var phi_1870_: u32;
    var phi_1871_: bool;
    var phi_1880_: u32;
    var phi_1885_: u32;
    var phi_1886_: bool;
    var phi_712_: type_46;
    var phi_715_: type_7;
    var phi_716_: type_7;
    var phi_738_: type_7;
    var phi_758_: u32;
    var phi_846_: array<array<f32, 3>, 3>;
    var phi_1317_: vec3<f32>;
    var phi_1318_: vec3<f32>;
    var phi_1349_: bool;
    var phi_1358_: vec3<f32>;
    var phi_1398_: type_23;
    var phi_1400_: type_23;
    var phi_1401_: bool;
    var phi_1405_: type_23;
    var phi_1406_: type_23;
    var phi_1407_: type_23;
    var phi_1408_: bool;
    var phi_1412_: type_23;
    var phi_1413_: bool;
    var phi_1417_: type_23;
    var phi_1418_: bool;
    var phi_1422_: type_23;
    var phi_1433_: type_46;
    var phi_1434_: type_46;
    var phi_713_: type_46;
    var phi_1925_: bool;
    var local_2: type_46;
    var phi_2036_: bool;
    var phi_1888_: type_46;
    var phi_1889_: u32;
    var phi_1890_: bool;
    var phi_1891_: u32;
    var phi_2035_: bool;
    var phi_1892_: type_46;
    var phi_1893_: u32;
    var phi_1894_: u32;
    var phi_1895_: bool;
    var phi_1896_: u32;
    var phi_2034_: bool;
    var phi_1897_: type_46;
    var phi_1898_: u32;
    var phi_1899_: u32;
    var phi_1900_: bool;
    var phi_1901_: u32;
    var phi_2033_: bool;
    var phi_645_: type_46;
    var phi_648_: u32;
    var phi_650_: u32;
    var phi_652_: bool;
    var phi_654_: u32;
    var phi_1902_: bool;
    var phi_2032_: bool;
    var local_3: type_46;
    var local_4: type_46;

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
                            phi_258_ = (bitcast<i32>((_e155 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_258_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e155)), 32u, (_e155 == 0u))));
                        }
                        let _e169 = phi_258_;
                        phi_259_ = _e169;
                    } else {
                        phi_259_ = 0i;
                    }
                    let _e171 = phi_259_;
                    let _e172 = (_e88 == _e127);
                    if _e172 {
                        phi_269_ = true;
                    } else {
                        phi_269_ = (_e95 == _e127);
                    }
                    let _e175 = phi_269_;
                    let _e176 = select(1u, 0u, _e172);
                    if _e175 {
                        let _e177 = (_e176 + 1u);
                        phi_279_ = _e177;
                        phi_280_ = _e177;
                        phi_282_ = select(true, false, (_e177 == 2u));
                    } else {
                        phi_279_ = u32();
                        phi_280_ = 0u;
                        phi_282_ = true;
                    }
                    let _e181 = phi_279_;
                    let _e183 = phi_280_;
                    let _e185 = phi_282_;
                    if _e185 {
                        phi_287_ = (_e183 + 1u);
                    } else {
                        phi_287_ = 0u;
                    }
                    let _e189 = phi_287_;
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
                        phi_331_ = _e220[0];
                    } else {
                        phi_331_ = _e220[1];
                    }
                    let _e225 = phi_331_;
                    let _e226 = (_e190 == 2u);
                    if _e226 {
                        phi_337_ = _e220[2];
                    } else {
                        phi_337_ = _e225;
                    }
                    let _e229 = phi_337_;
                    let _e231 = ((_e229 * _e197) * _e203);
                    let _e232 = global_4.member[_e72].member_2;
                    if _e221 {
                        phi_348_ = _e232[0];
                    } else {
                        phi_348_ = _e232[1];
                    }
                    let _e236 = phi_348_;
                    if _e226 {
                        phi_354_ = _e232[2];
                    } else {
                        phi_354_ = _e236;
                    }
                    let _e239 = phi_354_;
                    let _e241 = ((_e239 * _e210) * _e216);
                    let _e245 = (bitcast<f32>((bitcast<u32>(_e241) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e245 {
                        let _e249 = (bitcast<f32>((bitcast<u32>(_e231) & 2147483647u)) * 0.00000011920929f);
                        phi_377_ = select(0.00000000000000000086736174f, _e249, (_e249 > 0.00000000000000000086736174f));
                    } else {
                        phi_377_ = 0f;
                    }
                    let _e253 = phi_377_;
                    let _e254 = (_e231 + _e253);
                    let _e255 = (_e231 - _e253);
                    let _e256 = select(_e241, 0f, _e245);
                    if _e245 {
                        phi_392_ = 1267650600000000000000000000000f;
                    } else {
                        phi_392_ = (1f / _e241);
                    }
                    let _e259 = phi_392_;
                    let _e260 = (_e189 == 0u);
                    if _e260 {
                        phi_401_ = _e220[0];
                    } else {
                        phi_401_ = _e220[1];
                    }
                    let _e264 = phi_401_;
                    let _e265 = (_e189 == 2u);
                    if _e265 {
                        phi_407_ = _e220[2];
                    } else {
                        phi_407_ = _e264;
                    }
                    let _e268 = phi_407_;
                    let _e270 = ((_e268 * _e197) * _e203);
                    if _e260 {
                        phi_418_ = _e232[0];
                    } else {
                        phi_418_ = _e232[1];
                    }
                    let _e274 = phi_418_;
                    if _e265 {
                        phi_424_ = _e232[2];
                    } else {
                        phi_424_ = _e274;
                    }
                    let _e277 = phi_424_;
                    let _e279 = ((_e277 * _e210) * _e216);
                    let _e283 = (bitcast<f32>((bitcast<u32>(_e279) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e283 {
                        let _e287 = (bitcast<f32>((bitcast<u32>(_e270) & 2147483647u)) * 0.00000011920929f);
                        phi_447_ = select(0.00000000000000000086736174f, _e287, (_e287 > 0.00000000000000000086736174f));
                    } else {
                        phi_447_ = 0f;
                    }
                    let _e291 = phi_447_;
                    let _e292 = (_e270 + _e291);
                    let _e293 = (_e270 - _e291);
                    let _e294 = select(_e279, 0f, _e283);
                    if _e283 {
                        phi_462_ = 1267650600000000000000000000000f;
                    } else {
                        phi_462_ = (1f / _e279);
                    }
                    let _e297 = phi_462_;
                    let _e298 = (_e191 == 0u);
                    if _e298 {
                        phi_471_ = _e220[0];
                    } else {
                        phi_471_ = _e220[1];
                    }
                    let _e302 = phi_471_;
                    let _e303 = (_e191 == 2u);
                    if _e303 {
                        phi_477_ = _e220[2];
                    } else {
                        phi_477_ = _e302;
                    }
                    let _e306 = phi_477_;
                    let _e308 = ((_e306 * _e197) * _e203);
                    if _e298 {
                        phi_488_ = _e232[0];
                    } else {
                        phi_488_ = _e232[1];
                    }
                    let _e312 = phi_488_;
                    if _e303 {
                        phi_494_ = _e232[2];
                    } else {
                        phi_494_ = _e312;
                    }
                    let _e315 = phi_494_;
                    let _e317 = ((_e315 * _e210) * _e216);
                    let _e321 = (bitcast<f32>((bitcast<u32>(_e317) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e321 {
                        let _e325 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) * 0.00000011920929f);
                        phi_517_ = select(0.00000000000000000086736174f, _e325, (_e325 > 0.00000000000000000086736174f));
                    } else {
                        phi_517_ = 0f;
                    }
                    let _e329 = phi_517_;
                    let _e330 = (_e308 + _e329);
                    let _e331 = (_e308 - _e329);
                    let _e332 = select(_e317, 0f, _e321);
                    if _e321 {
                        phi_532_ = 1267650600000000000000000000000f;
                    } else {
                        phi_532_ = (1f / _e317);
                    }
                    let _e335 = phi_532_;
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
                        phi_632_ = select(-340282350000000000000000000000000000000f, _e376, (_e376 > -340282350000000000000000000000000000000f));
                        phi_633_ = select(-340282350000000000000000000000000000000f, _e369, (_e369 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_632_ = 0f;
                        phi_633_ = 1f;
                    }
                    let _e380 = phi_632_;
                    let _e382 = phi_633_;
                    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_1931_ = false;
                    phi_644_ = type_46(_e380, false);
                    phi_647_ = select(0u, 2147483648u, (_e62 == 0u));
                    phi_649_ = ((3u * _e62) + 1u);
                    phi_651_ = (_e382 <= _e380);
                    phi_653_ = 0u;
                    loop {
                        let _e390 = phi_1931_;
                        let _e392 = phi_644_;
                        let _e394 = phi_647_;
                        let _e396 = phi_649_;
                        let _e398 = phi_651_;
                        let _e400 = phi_653_;
                        local_3 = _e392;
                        if _e398 {
                            phi_664_ = true;
                        } else {
                            phi_664_ = (_e400 > 0u);
                        }
                        let _e403 = phi_664_;
                        if _e403 {
                            let _e404 = (_e396 > 0u);
                            if _e404 {
                                if _e398 {
                                    phi_694_ = _e394;
                                    phi_695_ = _e398;
                                    phi_696_ = _e400;
                                } else {
                                    let _e405 = (_e400 - 1u);
                                    let _e406 = (_e405 % 128u);
                                    let _e407 = (_e406 < 128u);
                                    if _e407 {
                                    } else {
                                        phi_2032_ = true;
                                        break;
                                    }
                                    let _e409 = local[_e406];
                                    if _e407 {
                                    } else {
                                        phi_2032_ = true;
                                        break;
                                    }
                                    let _e411 = local_1[_e406];
                                    phi_694_ = _e409;
                                    phi_695_ = (_e411 <= _e392.member);
                                    phi_696_ = _e405;
                                }
                                let _e415 = phi_694_;
                                let _e417 = phi_695_;
                                let _e419 = phi_696_;
                                if _e417 {
                                    let _e423 = (_e415 & 268435455u);
                                    if ((_e415 & 2147483648u) != 0u) {
                                        phi_712_ = _e392;
                                        phi_715_ = type_7(_e423, (_e423 + ((_e415 >> bitcast<u32>(28u)) & 7u)));
                                        loop {
                                            let _e618 = phi_712_;
                                            let _e620 = phi_715_;
                                            local_2 = _e618;
                                            local_4 = _e618;
                                            if (_e620.member < _e620.member_1) {
                                                phi_716_ = type_7((_e620.member + 1u), _e620.member_1);
                                                phi_738_ = type_7(1u, _e620.member);
                                            } else {
                                                phi_716_ = _e620;
                                                phi_738_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e633 = phi_716_;
                                            let _e635 = phi_738_;
                                            let _e639 = (bitcast<i32>(_e635.member) != 0i);
                                            if _e639 {
                                                let _e640 = (_e635.member_1 < _e64);
                                                if _e640 {
                                                    if _e640 {
                                                    } else {
                                                        phi_1925_ = true;
                                                        break;
                                                    }
                                                    let _e644 = global_3.member[_e635.member_1].member_1;
                                                    phi_758_ = _e644;
                                                } else {
                                                    phi_758_ = 4294967295u;
                                                }
                                                let _e646 = phi_758_;
                                                if (_e635.member_1 >= _e64) {
                                                    phi_846_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e640 {
                                                    } else {
                                                        phi_1925_ = true;
                                                        break;
                                                    }
                                                    let _e648 = (_e190 % 3u);
                                                    let _e649 = (_e189 % 3u);
                                                    let _e650 = (_e191 % 3u);
                                                    if (_e648 < 9u) {
                                                    } else {
                                                        phi_1925_ = true;
                                                        break;
                                                    }
                                                    let _e656 = global_3.member[_e635.member_1].member[_e648];
                                                    if (_e649 < 9u) {
                                                    } else {
                                                        phi_1925_ = true;
                                                        break;
                                                    }
                                                    let _e662 = global_3.member[_e635.member_1].member[_e649];
                                                    if (_e650 < 9u) {
                                                    } else {
                                                        phi_1925_ = true;
                                                        break;
                                                    }
                                                    let _e668 = global_3.member[_e635.member_1].member[_e650];
                                                    let _e670 = (3u + _e648);
                                                    if (_e670 < 9u) {
                                                    } else {
                                                        phi_1925_ = true;
                                                        break;
                                                    }
                                                    let _e676 = global_3.member[_e635.member_1].member[_e670];
                                                    let _e677 = (3u + _e649);
                                                    if (_e677 < 9u) {
                                                    } else {
                                                        phi_1925_ = true;
                                                        break;
                                                    }
                                                    let _e683 = global_3.member[_e635.member_1].member[_e677];
                                                    let _e684 = (3u + _e650);
                                                    if (_e684 < 9u) {
                                                    } else {
                                                        phi_1925_ = true;
                                                        break;
                                                    }
                                                    let _e690 = global_3.member[_e635.member_1].member[_e684];
                                                    let _e692 = (6u + _e648);
                                                    if (_e692 < 9u) {
                                                    } else {
                                                        phi_1925_ = true;
                                                        break;
                                                    }
                                                    let _e698 = global_3.member[_e635.member_1].member[_e692];
                                                    let _e699 = (6u + _e649);
                                                    if (_e699 < 9u) {
                                                    } else {
                                                        phi_1925_ = true;
                                                        break;
                                                    }
                                                    let _e705 = global_3.member[_e635.member_1].member[_e699];
                                                    let _e706 = (6u + _e650);
                                                    if (_e706 < 9u) {
                                                    } else {
                                                        phi_1925_ = true;
                                                        break;
                                                    }
                                                    let _e712 = global_3.member[_e635.member_1].member[_e706];
                                                    phi_846_ = array<array<f32, 3>, 3>(array<f32, 3>(_e656, _e662, _e668), array<f32, 3>(_e676, _e683, _e690), array<f32, 3>(_e698, _e705, _e712));
                                                }
                                                let _e716 = phi_846_;
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
                                                        phi_1412_ = type_23();
                                                        phi_1413_ = true;
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
                                                            phi_1407_ = type_23();
                                                            phi_1408_ = true;
                                                        } else {
                                                            let _e854 = (_e852 > _e618.member);
                                                            if _e854 {
                                                                phi_1406_ = type_23();
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
                                                                    phi_1317_ = _e865;
                                                                    phi_1318_ = _e869;
                                                                } else {
                                                                    let _e915 = vec3((_e895 == _e912));
                                                                    phi_1317_ = select(_e861, _e869, _e915);
                                                                    phi_1318_ = select(_e865, _e861, _e915);
                                                                }
                                                                let _e919 = phi_1317_;
                                                                let _e921 = phi_1318_;
                                                                let _e928 = ((_e919.y * _e921.z) - (_e921.y * _e919.z));
                                                                let _e933 = ((_e919.z * _e921.x) - (_e921.z * _e919.x));
                                                                let _e936 = ((_e919.x * _e921.y) - (_e921.x * _e919.y));
                                                                if (_e778 >= _e782) {
                                                                    phi_1349_ = select(true, false, (_e778 >= _e786));
                                                                } else {
                                                                    phi_1349_ = true;
                                                                }
                                                                let _e941 = phi_1349_;
                                                                if _e941 {
                                                                    phi_1358_ = select(vec3<f32>(_e716[2][0], _e716[2][1], _e716[2][2]), vec3<f32>(_e716[1][0], _e716[1][1], _e716[1][2]), vec3((_e782 >= _e786)));
                                                                } else {
                                                                    phi_1358_ = vec3<f32>(_e716[0][0], _e716[0][1], _e716[0][2]);
                                                                }
                                                                let _e946 = phi_1358_;
                                                                let _e963 = ((((_e928 * (_e946.x - _e231)) + (_e933 * (_e946.y - _e270))) + (_e936 * (_e946.z - _e308))) / (((_e928 * _e256) + (_e933 * _e294)) + (_e936 * _e332)));
                                                                let _e965 = select(_e845, _e963, (_e963 < _e845));
                                                                let _e967 = select(_e837, _e965, (_e965 > _e837));
                                                                if (_e967 >= _e382) {
                                                                    let _e969 = (_e967 <= _e618.member);
                                                                    if _e969 {
                                                                        let _e970 = (1f / _e788);
                                                                        phi_1398_ = type_23(_e967, (_e782 * _e970), (_e786 * _e970), _e646);
                                                                    } else {
                                                                        phi_1398_ = type_23();
                                                                    }
                                                                    let _e975 = phi_1398_;
                                                                    phi_1400_ = _e975;
                                                                    phi_1401_ = select(true, false, _e969);
                                                                } else {
                                                                    phi_1400_ = type_23();
                                                                    phi_1401_ = true;
                                                                }
                                                                let _e978 = phi_1400_;
                                                                let _e980 = phi_1401_;
                                                                if _e980 {
                                                                    phi_1405_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1405_ = _e978;
                                                                }
                                                                let _e982 = phi_1405_;
                                                                phi_1406_ = _e982;
                                                            }
                                                            let _e984 = phi_1406_;
                                                            phi_1407_ = _e984;
                                                            phi_1408_ = _e854;
                                                        }
                                                        let _e986 = phi_1407_;
                                                        let _e988 = phi_1408_;
                                                        phi_1412_ = _e986;
                                                        phi_1413_ = _e988;
                                                    }
                                                    let _e990 = phi_1412_;
                                                    let _e992 = phi_1413_;
                                                    phi_1417_ = _e990;
                                                    phi_1418_ = _e992;
                                                } else {
                                                    phi_1417_ = type_23();
                                                    phi_1418_ = true;
                                                }
                                                let _e994 = phi_1417_;
                                                let _e996 = phi_1418_;
                                                if _e996 {
                                                    phi_1422_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1422_ = _e994;
                                                }
                                                let _e998 = phi_1422_;
                                                if (_e998.member_3 != 4294967295u) {
                                                    if (_e646 != 4294967295u) {
                                                        phi_1433_ = type_46(_e618.member, true);
                                                    } else {
                                                        phi_1433_ = _e618;
                                                    }
                                                    let _e1006 = phi_1433_;
                                                    phi_1434_ = _e1006;
                                                } else {
                                                    phi_1434_ = _e618;
                                                }
                                                let _e1008 = phi_1434_;
                                                phi_713_ = _e1008;
                                            } else {
                                                phi_713_ = type_46();
                                            }
                                            let _e1010 = phi_713_;
                                            continue;
                                            continuing {
                                                phi_712_ = _e1010;
                                                phi_715_ = _e633;
                                                phi_1925_ = _e390;
                                                break if !(_e639);
                                            }
                                        }
                                        let _e1013 = phi_1925_;
                                        phi_2032_ = _e1013;
                                        if _e1013 {
                                            break;
                                        }
                                        let _e1015 = local_2;
                                        phi_2036_ = _e1013;
                                        let _e1153 = local_4;
                                        phi_1888_ = _e1153;
                                        phi_1889_ = _e415;
                                        phi_1890_ = false;
                                        phi_1891_ = select(_e419, 0u, _e1015.member_1);
                                    } else {
                                        if (_e415 >= _e62) {
                                            phi_1495_ = type_41(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e415 < _e62) {
                                            } else {
                                                phi_2032_ = true;
                                                break;
                                            }
                                            let _e429 = (_e190 % 3u);
                                            if (_e429 < 3u) {
                                            } else {
                                                phi_2032_ = true;
                                                break;
                                            }
                                            let _e435 = global_2.member[_e415].member[_e429];
                                            let _e441 = (_e189 % 3u);
                                            if (_e441 < 3u) {
                                            } else {
                                                phi_2032_ = true;
                                                break;
                                            }
                                            let _e447 = global_2.member[_e415].member[_e441];
                                            let _e453 = (_e191 % 3u);
                                            if (_e453 < 3u) {
                                            } else {
                                                phi_2032_ = true;
                                                break;
                                            }
                                            let _e459 = global_2.member[_e415].member[_e453];
                                            let _e469 = global_2.member[_e415].member_1;
                                            let _e473 = global_2.member[_e415].member_2;
                                            phi_1495_ = type_41(array<vec4<f32>, 3>(vec4<f32>(_e435[0], _e435[1], _e435[2], _e435[3]), vec4<f32>(_e447[0], _e447[1], _e447[2], _e447[3]), vec4<f32>(_e459[0], _e459[1], _e459[2], _e459[3])), _e469, _e473);
                                        }
                                        let _e476 = phi_1495_;
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
                                        let _e576 = (_e569 <= select(_e392.member, _e566, (_e566 < _e392.member)));
                                        let _e577 = (_e571 <= select(_e392.member, _e567, (_e567 < _e392.member)));
                                        let _e578 = (_e569 <= _e571);
                                        if _e576 {
                                            if _e577 {
                                                if _e578 {
                                                    phi_1839_ = _e476.member_2;
                                                } else {
                                                    phi_1839_ = _e476.member_1;
                                                }
                                                let _e582 = phi_1839_;
                                                let _e583 = (_e419 % 128u);
                                                let _e584 = (_e583 < 128u);
                                                if _e584 {
                                                } else {
                                                    phi_2032_ = true;
                                                    break;
                                                }
                                                local[_e583] = _e582;
                                                if _e584 {
                                                } else {
                                                    phi_2032_ = true;
                                                    break;
                                                }
                                                local_1[_e583] = select(_e571, _e569, (_e569 > _e571));
                                                if _e578 {
                                                    phi_1865_ = _e476.member_1;
                                                } else {
                                                    phi_1865_ = _e476.member_2;
                                                }
                                                let _e593 = phi_1865_;
                                                phi_1866_ = _e593;
                                                phi_1867_ = (_e419 + 1u);
                                            } else {
                                                phi_1866_ = u32();
                                                phi_1867_ = u32();
                                            }
                                            let _e595 = phi_1866_;
                                            let _e597 = phi_1867_;
                                            phi_1869_ = _e595;
                                            phi_1870_ = _e597;
                                            phi_1871_ = select(true, false, _e577);
                                        } else {
                                            phi_1869_ = u32();
                                            phi_1870_ = u32();
                                            phi_1871_ = true;
                                        }
                                        let _e600 = phi_1869_;
                                        let _e602 = phi_1870_;
                                        let _e604 = phi_1871_;
                                        if _e604 {
                                            if _e576 {
                                                phi_1880_ = _e476.member_1;
                                            } else {
                                                phi_1880_ = _e476.member_2;
                                            }
                                            let _e608 = phi_1880_;
                                            phi_1885_ = _e608;
                                            phi_1886_ = select(_e577, true, _e576);
                                        } else {
                                            phi_1885_ = _e600;
                                            phi_1886_ = _e417;
                                        }
                                        let _e611 = phi_1885_;
                                        let _e613 = phi_1886_;
                                        phi_2036_ = _e390;
                                        phi_1888_ = _e392;
                                        phi_1889_ = _e611;
                                        phi_1890_ = _e613;
                                        phi_1891_ = select(_e602, _e419, _e604);
                                    }
                                    let _e1019 = phi_2036_;
                                    let _e1021 = phi_1888_;
                                    let _e1023 = phi_1889_;
                                    let _e1025 = phi_1890_;
                                    let _e1027 = phi_1891_;
                                    phi_2035_ = _e1019;
                                    phi_1892_ = _e1021;
                                    phi_1893_ = _e1023;
                                    phi_1894_ = (_e396 - 1u);
                                    phi_1895_ = _e1025;
                                    phi_1896_ = _e1027;
                                } else {
                                    phi_2035_ = _e390;
                                    phi_1892_ = _e392;
                                    phi_1893_ = _e415;
                                    phi_1894_ = _e396;
                                    phi_1895_ = _e417;
                                    phi_1896_ = _e419;
                                }
                                let _e1029 = phi_2035_;
                                let _e1031 = phi_1892_;
                                let _e1033 = phi_1893_;
                                let _e1035 = phi_1894_;
                                let _e1037 = phi_1895_;
                                let _e1039 = phi_1896_;
                                phi_2034_ = _e1029;
                                phi_1897_ = _e1031;
                                phi_1898_ = _e1033;
                                phi_1899_ = _e1035;
                                phi_1900_ = _e1037;
                                phi_1901_ = _e1039;
                            } else {
                                phi_2034_ = _e390;
                                phi_1897_ = type_46();
                                phi_1898_ = u32();
                                phi_1899_ = u32();
                                phi_1900_ = bool();
                                phi_1901_ = u32();
                            }
                            let _e1041 = phi_2034_;
                            let _e1043 = phi_1897_;
                            let _e1045 = phi_1898_;
                            let _e1047 = phi_1899_;
                            let _e1049 = phi_1900_;
                            let _e1051 = phi_1901_;
                            phi_2033_ = _e1041;
                            phi_645_ = _e1043;
                            phi_648_ = _e1045;
                            phi_650_ = _e1047;
                            phi_652_ = _e1049;
                            phi_654_ = _e1051;
                            phi_1902_ = _e404;
                        } else {
                            phi_2033_ = _e390;
                            phi_645_ = type_46();
                            phi_648_ = u32();
                            phi_650_ = u32();
                            phi_652_ = bool();
                            phi_654_ = u32();
                            phi_1902_ = false;
                        }
                        let _e1053 = phi_2033_;
                        let _e1055 = phi_645_;
                        let _e1057 = phi_648_;
                        let _e1059 = phi_650_;
                        let _e1061 = phi_652_;
                        let _e1063 = phi_654_;
                        let _e1065 = phi_1902_;
                        continue;
                        continuing {
                            phi_1931_ = _e1053;
                            phi_644_ = _e1055;
                            phi_647_ = _e1057;
                            phi_649_ = _e1059;
                            phi_651_ = _e1061;
                            phi_653_ = _e1063;
                            phi_2032_ = _e1053;
                            break if !(_e1065);
                        }
                    }
                    let _e1068 = phi_2032_;
                    if _e1068 {
                        break;
                    }
                    let _e1070 = local_3;
                    if _e74 {
                    } else {
                        break;
                    }
                    global_5.member[_e72] = select(0u, 1u, _e1070.member_1);
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
