struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_10 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_12 {
    member: array<type_10>,
}

struct type_16 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_20 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_21 {
    member: type_20,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_23 {
    member: array<type_21>,
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
    member: type_16,
    member_1: f32,
}

struct type_43 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_12;
@group(0) @binding(0) 
var<storage> global_2: type_32;
@group(0) @binding(2) 
var<storage> global_3: type_23;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_18;

fn function_() {
    var local: array<u32, 128>;
    var local_1: array<f32, 128>;
    var phi_260_: i32;
    var phi_261_: i32;
    var phi_271_: bool;
    var phi_281_: u32;
    var phi_282_: u32;
    var phi_284_: bool;
    var phi_289_: u32;
    var phi_333_: f32;
    var phi_339_: f32;
    var phi_350_: f32;
    var phi_356_: f32;
    var phi_379_: f32;
    var phi_394_: f32;
    var phi_403_: f32;
    var phi_409_: f32;
    var phi_420_: f32;
    var phi_426_: f32;
    var phi_449_: f32;
    var phi_464_: f32;
    var phi_473_: f32;
    var phi_479_: f32;
    var phi_490_: f32;
    var phi_496_: f32;
    var phi_519_: f32;
    var phi_534_: f32;
    var phi_634_: f32;
    var phi_635_: f32;
    var phi_2000_: bool;
    var phi_646_: type_40;
    var phi_649_: u32;
    var phi_651_: u32;
    var phi_653_: bool;
    var phi_655_: u32;
    var phi_666_: bool;
    var phi_696_: u32;
    var phi_697_: bool;
    var phi_698_: u32;
    var phi_1518_: type_43;
    var phi_1862_: u32;
    var phi_1888_: u32;
    var phi_1889_: u32;
    var phi_1890_: u32;
    var phi_1892_: u32;
    var phi_1893_: u32;
    var phi_1894_: bool;
    var phi_1903_: u32;
    var phi_1908_: u32;
    var phi_1909_: bool;
    var phi_714_: type_40;
    var phi_717_: type_4;
    var phi_718_: type_4;
    var phi_740_: type_4;
    var phi_760_: u32;
    var phi_848_: array<array<f32, 3>, 3>;
    var phi_1319_: vec3<f32>;
    var phi_1320_: vec3<f32>;
    var phi_1351_: bool;
    var phi_1360_: vec3<f32>;
    var phi_1400_: type_16;
    var phi_1402_: type_16;
    var phi_1403_: bool;
    var phi_1407_: type_16;
    var phi_1408_: type_16;
    var phi_1409_: type_16;
    var phi_1410_: bool;
    var phi_1414_: type_16;
    var phi_1415_: bool;
    var phi_1419_: type_16;
    var phi_1420_: bool;
    var phi_1424_: type_16;
    var phi_1449_: bool;
    var phi_1450_: bool;
    var phi_1456_: type_40;
    var phi_1457_: type_40;
    var phi_1458_: type_40;
    var phi_715_: type_40;
    var phi_1994_: bool;
    var phi_2108_: bool;
    var phi_1911_: type_40;
    var phi_1912_: u32;
    var phi_1913_: bool;
    var phi_1914_: u32;
    var phi_2107_: bool;
    var phi_1915_: type_40;
    var phi_1916_: u32;
    var phi_1917_: u32;
    var phi_1918_: bool;
    var phi_1919_: u32;
    var phi_2106_: bool;
    var phi_1920_: type_40;
    var phi_1921_: u32;
    var phi_1922_: u32;
    var phi_1923_: bool;
    var phi_1924_: u32;
    var phi_2105_: bool;
    var phi_647_: type_40;
    var phi_650_: u32;
    var phi_652_: u32;
    var phi_654_: bool;
    var phi_656_: u32;
    var phi_1925_: bool;
    var phi_2104_: bool;
    var local_2: type_40;
    var phi_1977_: type_16;
    var local_3: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e59 = global;
            let _e61 = arrayLength((&global_2.member));
            let _e63 = arrayLength((&global_1.member));
            let _e71 = (_e59.x + (_e59.y * 2097152u));
            let _e72 = (_e71 < arrayLength((&global_3.member)));
            if _e72 {
                let _e73 = (_e71 < arrayLength((&global_4.member)));
                if _e73 {
                    if _e72 {
                    } else {
                        break;
                    }
                    if _e72 {
                    } else {
                        break;
                    }
                    let _e77 = global_3.member[_e71].member_2;
                    let _e87 = global_3.member[_e71].member.member_2[0u];
                    let _e89 = (bitcast<u32>(_e87) & 2147483647u);
                    let _e95 = global_3.member[_e71].member.member_2[1u];
                    let _e97 = (bitcast<u32>(_e95) & 2147483647u);
                    let _e103 = global_3.member[_e71].member.member_2[2u];
                    let _e105 = (bitcast<u32>(_e103) & 2147483647u);
                    let _e111 = global_3.member[_e71].member.member[0u];
                    let _e113 = (bitcast<u32>(_e111) & 2147483647u);
                    let _e119 = global_3.member[_e71].member.member[1u];
                    let _e121 = (bitcast<u32>(_e119) & 2147483647u);
                    let _e127 = global_3.member[_e71].member.member[2u];
                    let _e129 = (bitcast<u32>(_e127) & 2147483647u);
                    let _e131 = select(_e97, _e89, (_e97 < _e89));
                    let _e133 = select(_e105, _e131, (_e105 < _e131));
                    let _e135 = select(_e113, _e133, (_e113 < _e133));
                    let _e137 = select(_e121, _e135, (_e121 < _e135));
                    let _e139 = select(_e129, _e137, (_e129 < _e137));
                    let _e144 = global_3.member[_e71].member.member_1;
                    let _e146 = (bitcast<u32>(_e144) & 2147483647u);
                    let _e154 = global_3.member[_e71].member.member_3;
                    let _e160 = (((select(_e146, _e139, (_e146 < _e139)) < 2139095040u) && ((bitcast<u32>(_e154) & 2147483647u) <= 2139095040u)) && (_e133 > 0u));
                    if _e160 {
                        let _e163 = (bitcast<u32>(bitcast<f32>(_e133)) & 2147483647u);
                        if (_e163 >= 8388608u) {
                            phi_260_ = (bitcast<i32>((_e163 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_260_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e163)), 32u, (_e163 == 0u))));
                        }
                        let _e177 = phi_260_;
                        phi_261_ = _e177;
                    } else {
                        phi_261_ = 0i;
                    }
                    let _e179 = phi_261_;
                    let _e180 = (_e89 == _e133);
                    if _e180 {
                        phi_271_ = true;
                    } else {
                        phi_271_ = (_e97 == _e133);
                    }
                    let _e183 = phi_271_;
                    let _e184 = select(1u, 0u, _e180);
                    if _e183 {
                        let _e185 = (_e184 + 1u);
                        phi_281_ = _e185;
                        phi_282_ = _e185;
                        phi_284_ = select(true, false, (_e185 == 2u));
                    } else {
                        phi_281_ = u32();
                        phi_282_ = 0u;
                        phi_284_ = true;
                    }
                    let _e189 = phi_281_;
                    let _e191 = phi_282_;
                    let _e193 = phi_284_;
                    if _e193 {
                        phi_289_ = (_e191 + 1u);
                    } else {
                        phi_289_ = 0u;
                    }
                    let _e197 = phi_289_;
                    let _e198 = select(_e189, _e191, _e193);
                    let _e199 = select(_e184, select(2u, _e184, _e183), _e193);
                    let _e200 = -(_e179);
                    let _e201 = (_e200 / 2i);
                    let _e206 = bitcast<f32>((bitcast<u32>((_e201 + 127i)) << bitcast<u32>(23i)));
                    let _e212 = bitcast<f32>((bitcast<u32>(((_e200 - _e201) + 127i)) << bitcast<u32>(23i)));
                    let _e217 = global_3.member[_e71].member.member;
                    let _e218 = (_e198 == 0u);
                    if _e218 {
                        phi_333_ = _e217[0];
                    } else {
                        phi_333_ = _e217[1];
                    }
                    let _e222 = phi_333_;
                    let _e223 = (_e198 == 2u);
                    if _e223 {
                        phi_339_ = _e217[2];
                    } else {
                        phi_339_ = _e222;
                    }
                    let _e226 = phi_339_;
                    let _e227 = global_3.member[_e71].member.member_2;
                    if _e218 {
                        phi_350_ = _e227[0];
                    } else {
                        phi_350_ = _e227[1];
                    }
                    let _e231 = phi_350_;
                    if _e223 {
                        phi_356_ = _e227[2];
                    } else {
                        phi_356_ = _e231;
                    }
                    let _e234 = phi_356_;
                    let _e236 = ((_e234 * _e206) * _e212);
                    let _e240 = (bitcast<f32>((bitcast<u32>(_e236) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e240 {
                        let _e244 = (bitcast<f32>((bitcast<u32>(_e226) & 2147483647u)) * 0.00000011920929f);
                        phi_379_ = select(0.00000000000000000086736174f, _e244, (_e244 > 0.00000000000000000086736174f));
                    } else {
                        phi_379_ = 0f;
                    }
                    let _e248 = phi_379_;
                    let _e249 = (_e226 + _e248);
                    let _e250 = (_e226 - _e248);
                    let _e251 = select(_e236, 0f, _e240);
                    if _e240 {
                        phi_394_ = 1267650600000000000000000000000f;
                    } else {
                        phi_394_ = (1f / _e236);
                    }
                    let _e254 = phi_394_;
                    let _e255 = (_e197 == 0u);
                    if _e255 {
                        phi_403_ = _e217[0];
                    } else {
                        phi_403_ = _e217[1];
                    }
                    let _e259 = phi_403_;
                    let _e260 = (_e197 == 2u);
                    if _e260 {
                        phi_409_ = _e217[2];
                    } else {
                        phi_409_ = _e259;
                    }
                    let _e263 = phi_409_;
                    if _e255 {
                        phi_420_ = _e227[0];
                    } else {
                        phi_420_ = _e227[1];
                    }
                    let _e267 = phi_420_;
                    if _e260 {
                        phi_426_ = _e227[2];
                    } else {
                        phi_426_ = _e267;
                    }
                    let _e270 = phi_426_;
                    let _e272 = ((_e270 * _e206) * _e212);
                    let _e276 = (bitcast<f32>((bitcast<u32>(_e272) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e276 {
                        let _e280 = (bitcast<f32>((bitcast<u32>(_e263) & 2147483647u)) * 0.00000011920929f);
                        phi_449_ = select(0.00000000000000000086736174f, _e280, (_e280 > 0.00000000000000000086736174f));
                    } else {
                        phi_449_ = 0f;
                    }
                    let _e284 = phi_449_;
                    let _e285 = (_e263 + _e284);
                    let _e286 = (_e263 - _e284);
                    let _e287 = select(_e272, 0f, _e276);
                    if _e276 {
                        phi_464_ = 1267650600000000000000000000000f;
                    } else {
                        phi_464_ = (1f / _e272);
                    }
                    let _e290 = phi_464_;
                    let _e291 = (_e199 == 0u);
                    if _e291 {
                        phi_473_ = _e217[0];
                    } else {
                        phi_473_ = _e217[1];
                    }
                    let _e295 = phi_473_;
                    let _e296 = (_e199 == 2u);
                    if _e296 {
                        phi_479_ = _e217[2];
                    } else {
                        phi_479_ = _e295;
                    }
                    let _e299 = phi_479_;
                    if _e291 {
                        phi_490_ = _e227[0];
                    } else {
                        phi_490_ = _e227[1];
                    }
                    let _e303 = phi_490_;
                    if _e296 {
                        phi_496_ = _e227[2];
                    } else {
                        phi_496_ = _e303;
                    }
                    let _e306 = phi_496_;
                    let _e308 = ((_e306 * _e206) * _e212);
                    let _e312 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e312 {
                        let _e316 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) * 0.00000011920929f);
                        phi_519_ = select(0.00000000000000000086736174f, _e316, (_e316 > 0.00000000000000000086736174f));
                    } else {
                        phi_519_ = 0f;
                    }
                    let _e320 = phi_519_;
                    let _e321 = (_e299 + _e320);
                    let _e322 = (_e299 - _e320);
                    let _e323 = select(_e308, 0f, _e312);
                    if _e312 {
                        phi_534_ = 1267650600000000000000000000000f;
                    } else {
                        phi_534_ = (1f / _e308);
                    }
                    let _e326 = phi_534_;
                    let _e329 = bitcast<f32>((bitcast<u32>(_e226) & 2147483647u));
                    let _e332 = bitcast<f32>((bitcast<u32>(_e263) & 2147483647u));
                    let _e334 = select(_e332, _e329, (_e329 > _e332));
                    let _e337 = bitcast<f32>((bitcast<u32>(_e299) & 2147483647u));
                    if (_e160 && (select(_e337, _e334, (_e334 > _e337)) <= 1099511600000f)) {
                        let _e342 = (_e179 / 3i);
                        let _e349 = bitcast<f32>((bitcast<u32>((_e342 + 127i)) << bitcast<u32>(23i)));
                        let _e356 = bitcast<f32>((bitcast<u32>(((_e179 - (2i * _e342)) + 127i)) << bitcast<u32>(23i)));
                        let _e357 = (((_e144 * _e349) * _e349) * _e356);
                        let _e359 = select(340282350000000000000000000000000000000f, _e357, (_e357 < 340282350000000000000000000000000000000f));
                        let _e364 = (((_e154 * _e349) * _e349) * _e356);
                        let _e366 = select(340282350000000000000000000000000000000f, _e364, (_e364 < 340282350000000000000000000000000000000f));
                        phi_634_ = select(-340282350000000000000000000000000000000f, _e366, (_e366 > -340282350000000000000000000000000000000f));
                        phi_635_ = select(-340282350000000000000000000000000000000f, _e359, (_e359 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_634_ = 0f;
                        phi_635_ = 1f;
                    }
                    let _e370 = phi_634_;
                    let _e372 = phi_635_;
                    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2000_ = false;
                    phi_646_ = type_40(type_16(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e370);
                    phi_649_ = select(0u, 2147483648u, (_e61 == 0u));
                    phi_651_ = ((3u * _e61) + 1u);
                    phi_653_ = (_e372 <= _e370);
                    phi_655_ = 0u;
                    loop {
                        let _e380 = phi_2000_;
                        let _e382 = phi_646_;
                        let _e384 = phi_649_;
                        let _e386 = phi_651_;
                        let _e388 = phi_653_;
                        let _e390 = phi_655_;
                        local_2 = _e382;
                        if _e388 {
                            phi_666_ = true;
                        } else {
                            phi_666_ = (_e390 > 0u);
                        }
                        let _e393 = phi_666_;
                        if _e393 {
                            let _e394 = (_e386 > 0u);
                            if _e394 {
                                if _e388 {
                                    phi_696_ = _e384;
                                    phi_697_ = _e388;
                                    phi_698_ = _e390;
                                } else {
                                    let _e395 = (_e390 - 1u);
                                    let _e396 = (_e395 % 128u);
                                    let _e397 = (_e396 < 128u);
                                    if _e397 {
                                    } else {
                                        phi_2104_ = true;
                                        break;
                                    }
                                    let _e399 = local[_e396];
                                    if _e397 {
                                    } else {
                                        phi_2104_ = true;
                                        break;
                                    }
                                    let _e401 = local_1[_e396];
                                    phi_696_ = _e399;
                                    phi_697_ = (_e401 <= _e382.member_1);
                                    phi_698_ = _e395;
                                }
                                let _e405 = phi_696_;
                                let _e407 = phi_697_;
                                let _e409 = phi_698_;
                                if _e407 {
                                    let _e413 = (_e405 & 268435455u);
                                    if ((_e405 & 2147483648u) != 0u) {
                                        phi_714_ = _e382;
                                        phi_717_ = type_4(_e413, (_e413 + ((_e405 >> bitcast<u32>(28u)) & 7u)));
                                        loop {
                                            let _e608 = phi_714_;
                                            let _e610 = phi_717_;
                                            local_3 = _e608;
                                            if (_e610.member < _e610.member_1) {
                                                phi_718_ = type_4((_e610.member + 1u), _e610.member_1);
                                                phi_740_ = type_4(1u, _e610.member);
                                            } else {
                                                phi_718_ = _e610;
                                                phi_740_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e623 = phi_718_;
                                            let _e625 = phi_740_;
                                            let _e629 = (bitcast<i32>(_e625.member) != 0i);
                                            if _e629 {
                                                let _e630 = (_e625.member_1 < _e63);
                                                if _e630 {
                                                    if _e630 {
                                                    } else {
                                                        phi_1994_ = true;
                                                        break;
                                                    }
                                                    let _e634 = global_1.member[_e625.member_1].member_1;
                                                    phi_760_ = _e634;
                                                } else {
                                                    phi_760_ = 4294967295u;
                                                }
                                                let _e636 = phi_760_;
                                                if (_e625.member_1 >= _e63) {
                                                    phi_848_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e630 {
                                                    } else {
                                                        phi_1994_ = true;
                                                        break;
                                                    }
                                                    let _e638 = (_e198 % 3u);
                                                    let _e639 = (_e197 % 3u);
                                                    let _e640 = (_e199 % 3u);
                                                    if (_e638 < 9u) {
                                                    } else {
                                                        phi_1994_ = true;
                                                        break;
                                                    }
                                                    let _e646 = global_1.member[_e625.member_1].member[_e638];
                                                    if (_e639 < 9u) {
                                                    } else {
                                                        phi_1994_ = true;
                                                        break;
                                                    }
                                                    let _e652 = global_1.member[_e625.member_1].member[_e639];
                                                    if (_e640 < 9u) {
                                                    } else {
                                                        phi_1994_ = true;
                                                        break;
                                                    }
                                                    let _e658 = global_1.member[_e625.member_1].member[_e640];
                                                    let _e660 = (3u + _e638);
                                                    if (_e660 < 9u) {
                                                    } else {
                                                        phi_1994_ = true;
                                                        break;
                                                    }
                                                    let _e666 = global_1.member[_e625.member_1].member[_e660];
                                                    let _e667 = (3u + _e639);
                                                    if (_e667 < 9u) {
                                                    } else {
                                                        phi_1994_ = true;
                                                        break;
                                                    }
                                                    let _e673 = global_1.member[_e625.member_1].member[_e667];
                                                    let _e674 = (3u + _e640);
                                                    if (_e674 < 9u) {
                                                    } else {
                                                        phi_1994_ = true;
                                                        break;
                                                    }
                                                    let _e680 = global_1.member[_e625.member_1].member[_e674];
                                                    let _e682 = (6u + _e638);
                                                    if (_e682 < 9u) {
                                                    } else {
                                                        phi_1994_ = true;
                                                        break;
                                                    }
                                                    let _e688 = global_1.member[_e625.member_1].member[_e682];
                                                    let _e689 = (6u + _e639);
                                                    if (_e689 < 9u) {
                                                    } else {
                                                        phi_1994_ = true;
                                                        break;
                                                    }
                                                    let _e695 = global_1.member[_e625.member_1].member[_e689];
                                                    let _e696 = (6u + _e640);
                                                    if (_e696 < 9u) {
                                                    } else {
                                                        phi_1994_ = true;
                                                        break;
                                                    }
                                                    let _e702 = global_1.member[_e625.member_1].member[_e696];
                                                    phi_848_ = array<array<f32, 3>, 3>(array<f32, 3>(_e646, _e652, _e658), array<f32, 3>(_e666, _e673, _e680), array<f32, 3>(_e688, _e695, _e702));
                                                }
                                                let _e706 = phi_848_;
                                                let _e714 = (_e706[0][2] - _e299);
                                                let _e717 = (((_e706[0][0] - _e226) * _e323) - (_e714 * _e251));
                                                let _e720 = (((_e706[0][1] - _e263) * _e323) - (_e714 * _e287));
                                                let _e727 = (_e706[1][2] - _e299);
                                                let _e730 = (((_e706[1][0] - _e226) * _e323) - (_e727 * _e251));
                                                let _e733 = (((_e706[1][1] - _e263) * _e323) - (_e727 * _e287));
                                                let _e740 = (_e706[2][2] - _e299);
                                                let _e743 = (((_e706[2][0] - _e226) * _e323) - (_e740 * _e251));
                                                let _e746 = (((_e706[2][1] - _e263) * _e323) - (_e740 * _e287));
                                                let _e747 = (_e743 * _e733);
                                                let _e748 = (_e746 * _e730);
                                                let _e749 = (_e717 * _e746);
                                                let _e750 = (_e720 * _e743);
                                                let _e751 = (_e730 * _e720);
                                                let _e752 = (_e733 * _e717);
                                                let _e757 = (((_e747 >= _e748) && (_e749 >= _e750)) && (_e751 >= _e752));
                                                if (_e757 || (((_e747 <= _e748) && (_e749 <= _e750)) && (_e751 <= _e752))) {
                                                    let _e764 = select(-1f, 1f, _e757);
                                                    let _e766 = ((_e747 - _e748) * _e764);
                                                    let _e768 = select(0f, _e766, (_e766 > 0f));
                                                    let _e770 = ((_e749 - _e750) * _e764);
                                                    let _e772 = select(0f, _e770, (_e770 > 0f));
                                                    let _e774 = ((_e751 - _e752) * _e764);
                                                    let _e776 = select(0f, _e774, (_e774 > 0f));
                                                    let _e778 = ((_e768 + _e772) + _e776);
                                                    if (_e778 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1414_ = type_16();
                                                        phi_1415_ = true;
                                                    } else {
                                                        let _e781 = select(_e706[1][0], _e706[0][0], (_e706[0][0] < _e706[1][0]));
                                                        let _e785 = select(_e706[1][0], _e706[0][0], (_e706[0][0] > _e706[1][0]));
                                                        let _e789 = select(_e706[1][1], _e706[0][1], (_e706[0][1] < _e706[1][1]));
                                                        let _e793 = select(_e706[1][1], _e706[0][1], (_e706[0][1] > _e706[1][1]));
                                                        let _e797 = select(_e706[1][2], _e706[0][2], (_e706[0][2] < _e706[1][2]));
                                                        let _e801 = select(_e706[1][2], _e706[0][2], (_e706[0][2] > _e706[1][2]));
                                                        let _e806 = ((select(_e706[2][0], _e781, (_e781 < _e706[2][0])) - _e249) * _e254);
                                                        let _e807 = ((select(_e706[2][0], _e785, (_e785 > _e706[2][0])) - _e250) * _e254);
                                                        let _e810 = ((select(_e706[2][1], _e789, (_e789 < _e706[2][1])) - _e285) * _e290);
                                                        let _e811 = ((select(_e706[2][1], _e793, (_e793 > _e706[2][1])) - _e286) * _e290);
                                                        let _e814 = ((select(_e706[2][2], _e797, (_e797 < _e706[2][2])) - _e321) * _e326);
                                                        let _e815 = ((select(_e706[2][2], _e801, (_e801 > _e706[2][2])) - _e322) * _e326);
                                                        let _e817 = select(_e815, _e814, (_e814 < _e815));
                                                        let _e819 = select(_e815, _e814, (_e814 > _e815));
                                                        let _e821 = select(_e807, _e806, (_e806 < _e807));
                                                        let _e823 = select(_e811, _e810, (_e810 < _e811));
                                                        let _e825 = select(_e823, _e821, (_e821 > _e823));
                                                        let _e827 = select(_e817, _e825, (_e825 > _e817));
                                                        let _e829 = select(_e807, _e806, (_e806 > _e807));
                                                        let _e831 = select(_e811, _e810, (_e810 > _e811));
                                                        let _e833 = select(_e831, _e829, (_e829 < _e831));
                                                        let _e835 = select(_e819, _e833, (_e833 < _e819));
                                                        let _e836 = -(_e817);
                                                        let _e842 = select(_e372, _e827, (_e827 > _e372));
                                                        if (_e842 > (_e835 + (select(_e836, _e819, (_e819 > _e836)) * 0.0000019073523f))) {
                                                            phi_1409_ = type_16();
                                                            phi_1410_ = true;
                                                        } else {
                                                            let _e844 = (_e842 > _e608.member_1);
                                                            if _e844 {
                                                                phi_1408_ = type_16();
                                                            } else {
                                                                let _e848 = (_e706[1][0] - _e706[0][0]);
                                                                let _e849 = (_e706[1][1] - _e706[0][1]);
                                                                let _e850 = (_e706[1][2] - _e706[0][2]);
                                                                let _e851 = vec3<f32>(_e848, _e849, _e850);
                                                                let _e852 = (_e706[2][0] - _e706[1][0]);
                                                                let _e853 = (_e706[2][1] - _e706[1][1]);
                                                                let _e854 = (_e706[2][2] - _e706[1][2]);
                                                                let _e855 = vec3<f32>(_e852, _e853, _e854);
                                                                let _e856 = (_e706[0][0] - _e706[2][0]);
                                                                let _e857 = (_e706[0][1] - _e706[2][1]);
                                                                let _e858 = (_e706[0][2] - _e706[2][2]);
                                                                let _e859 = vec3<f32>(_e856, _e857, _e858);
                                                                let _e862 = bitcast<f32>((bitcast<u32>(_e848) & 2147483647u));
                                                                let _e865 = bitcast<f32>((bitcast<u32>(_e849) & 2147483647u));
                                                                let _e867 = select(_e865, _e862, (_e862 > _e865));
                                                                let _e870 = bitcast<f32>((bitcast<u32>(_e850) & 2147483647u));
                                                                let _e872 = select(_e870, _e867, (_e867 > _e870));
                                                                let _e875 = bitcast<f32>((bitcast<u32>(_e852) & 2147483647u));
                                                                let _e878 = bitcast<f32>((bitcast<u32>(_e853) & 2147483647u));
                                                                let _e880 = select(_e878, _e875, (_e875 > _e878));
                                                                let _e883 = bitcast<f32>((bitcast<u32>(_e854) & 2147483647u));
                                                                let _e885 = select(_e883, _e880, (_e880 > _e883));
                                                                let _e888 = bitcast<f32>((bitcast<u32>(_e856) & 2147483647u));
                                                                let _e891 = bitcast<f32>((bitcast<u32>(_e857) & 2147483647u));
                                                                let _e893 = select(_e891, _e888, (_e888 > _e891));
                                                                let _e896 = bitcast<f32>((bitcast<u32>(_e858) & 2147483647u));
                                                                let _e898 = select(_e896, _e893, (_e893 > _e896));
                                                                let _e900 = select(_e885, _e872, (_e872 > _e885));
                                                                let _e902 = select(_e898, _e900, (_e900 > _e898));
                                                                if (_e872 == _e902) {
                                                                    phi_1319_ = _e855;
                                                                    phi_1320_ = _e859;
                                                                } else {
                                                                    let _e905 = vec3((_e885 == _e902));
                                                                    phi_1319_ = select(_e851, _e859, _e905);
                                                                    phi_1320_ = select(_e855, _e851, _e905);
                                                                }
                                                                let _e909 = phi_1319_;
                                                                let _e911 = phi_1320_;
                                                                let _e918 = ((_e909.y * _e911.z) - (_e911.y * _e909.z));
                                                                let _e923 = ((_e909.z * _e911.x) - (_e911.z * _e909.x));
                                                                let _e926 = ((_e909.x * _e911.y) - (_e911.x * _e909.y));
                                                                if (_e768 >= _e772) {
                                                                    phi_1351_ = select(true, false, (_e768 >= _e776));
                                                                } else {
                                                                    phi_1351_ = true;
                                                                }
                                                                let _e931 = phi_1351_;
                                                                if _e931 {
                                                                    phi_1360_ = select(vec3<f32>(_e706[2][0], _e706[2][1], _e706[2][2]), vec3<f32>(_e706[1][0], _e706[1][1], _e706[1][2]), vec3((_e772 >= _e776)));
                                                                } else {
                                                                    phi_1360_ = vec3<f32>(_e706[0][0], _e706[0][1], _e706[0][2]);
                                                                }
                                                                let _e936 = phi_1360_;
                                                                let _e953 = ((((_e918 * (_e936.x - _e226)) + (_e923 * (_e936.y - _e263))) + (_e926 * (_e936.z - _e299))) / (((_e918 * _e251) + (_e923 * _e287)) + (_e926 * _e323)));
                                                                let _e955 = select(_e835, _e953, (_e953 < _e835));
                                                                let _e957 = select(_e827, _e955, (_e955 > _e827));
                                                                if (_e957 >= _e372) {
                                                                    let _e959 = (_e957 <= _e608.member_1);
                                                                    if _e959 {
                                                                        let _e960 = (1f / _e778);
                                                                        phi_1400_ = type_16(_e957, (_e772 * _e960), (_e776 * _e960), _e636);
                                                                    } else {
                                                                        phi_1400_ = type_16();
                                                                    }
                                                                    let _e965 = phi_1400_;
                                                                    phi_1402_ = _e965;
                                                                    phi_1403_ = select(true, false, _e959);
                                                                } else {
                                                                    phi_1402_ = type_16();
                                                                    phi_1403_ = true;
                                                                }
                                                                let _e968 = phi_1402_;
                                                                let _e970 = phi_1403_;
                                                                if _e970 {
                                                                    phi_1407_ = type_16(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1407_ = _e968;
                                                                }
                                                                let _e972 = phi_1407_;
                                                                phi_1408_ = _e972;
                                                            }
                                                            let _e974 = phi_1408_;
                                                            phi_1409_ = _e974;
                                                            phi_1410_ = _e844;
                                                        }
                                                        let _e976 = phi_1409_;
                                                        let _e978 = phi_1410_;
                                                        phi_1414_ = _e976;
                                                        phi_1415_ = _e978;
                                                    }
                                                    let _e980 = phi_1414_;
                                                    let _e982 = phi_1415_;
                                                    phi_1419_ = _e980;
                                                    phi_1420_ = _e982;
                                                } else {
                                                    phi_1419_ = type_16();
                                                    phi_1420_ = true;
                                                }
                                                let _e984 = phi_1419_;
                                                let _e986 = phi_1420_;
                                                if _e986 {
                                                    phi_1424_ = type_16(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1424_ = _e984;
                                                }
                                                let _e988 = phi_1424_;
                                                if (_e988.member_3 != 4294967295u) {
                                                    if (_e636 != _e77) {
                                                        if (_e988.member < _e608.member.member) {
                                                            phi_1450_ = true;
                                                        } else {
                                                            if (_e988.member == _e608.member.member) {
                                                                phi_1449_ = (_e988.member_3 < _e608.member.member_3);
                                                            } else {
                                                                phi_1449_ = false;
                                                            }
                                                            let _e1001 = phi_1449_;
                                                            phi_1450_ = _e1001;
                                                        }
                                                        let _e1003 = phi_1450_;
                                                        if _e1003 {
                                                            phi_1456_ = type_40(_e988, _e988.member);
                                                        } else {
                                                            phi_1456_ = _e608;
                                                        }
                                                        let _e1006 = phi_1456_;
                                                        phi_1457_ = _e1006;
                                                    } else {
                                                        phi_1457_ = _e608;
                                                    }
                                                    let _e1008 = phi_1457_;
                                                    phi_1458_ = _e1008;
                                                } else {
                                                    phi_1458_ = _e608;
                                                }
                                                let _e1010 = phi_1458_;
                                                phi_715_ = _e1010;
                                            } else {
                                                phi_715_ = type_40();
                                            }
                                            let _e1012 = phi_715_;
                                            continue;
                                            continuing {
                                                phi_714_ = _e1012;
                                                phi_717_ = _e623;
                                                phi_1994_ = _e380;
                                                break if !(_e629);
                                            }
                                        }
                                        let _e1015 = phi_1994_;
                                        phi_2104_ = _e1015;
                                        if _e1015 {
                                            break;
                                        }
                                        phi_2108_ = _e1015;
                                        let _e1180 = local_3;
                                        phi_1911_ = _e1180;
                                        phi_1912_ = _e405;
                                        phi_1913_ = false;
                                        phi_1914_ = _e409;
                                    } else {
                                        if (_e405 >= _e61) {
                                            phi_1518_ = type_43(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e405 < _e61) {
                                            } else {
                                                phi_2104_ = true;
                                                break;
                                            }
                                            let _e419 = (_e198 % 3u);
                                            if (_e419 < 3u) {
                                            } else {
                                                phi_2104_ = true;
                                                break;
                                            }
                                            let _e425 = global_2.member[_e405].member[_e419];
                                            let _e431 = (_e197 % 3u);
                                            if (_e431 < 3u) {
                                            } else {
                                                phi_2104_ = true;
                                                break;
                                            }
                                            let _e437 = global_2.member[_e405].member[_e431];
                                            let _e443 = (_e199 % 3u);
                                            if (_e443 < 3u) {
                                            } else {
                                                phi_2104_ = true;
                                                break;
                                            }
                                            let _e449 = global_2.member[_e405].member[_e443];
                                            let _e459 = global_2.member[_e405].member_1;
                                            let _e463 = global_2.member[_e405].member_2;
                                            phi_1518_ = type_43(array<vec4<f32>, 3>(vec4<f32>(_e425[0], _e425[1], _e425[2], _e425[3]), vec4<f32>(_e437[0], _e437[1], _e437[2], _e437[3]), vec4<f32>(_e449[0], _e449[1], _e449[2], _e449[3])), _e459, _e463);
                                        }
                                        let _e466 = phi_1518_;
                                        let _e478 = ((_e466.member[0].x - _e249) * _e254);
                                        let _e479 = ((_e466.member[0].y - _e249) * _e254);
                                        let _e480 = ((_e466.member[0].z - _e250) * _e254);
                                        let _e481 = ((_e466.member[0].w - _e250) * _e254);
                                        let _e491 = ((_e466.member[1].x - _e285) * _e290);
                                        let _e492 = ((_e466.member[1].y - _e285) * _e290);
                                        let _e493 = ((_e466.member[1].z - _e286) * _e290);
                                        let _e494 = ((_e466.member[1].w - _e286) * _e290);
                                        let _e504 = ((_e466.member[2].x - _e321) * _e326);
                                        let _e505 = ((_e466.member[2].y - _e321) * _e326);
                                        let _e506 = ((_e466.member[2].z - _e322) * _e326);
                                        let _e507 = ((_e466.member[2].w - _e322) * _e326);
                                        let _e509 = select(_e506, _e504, (_e504 < _e506));
                                        let _e511 = select(_e507, _e505, (_e505 < _e507));
                                        let _e513 = select(_e506, _e504, (_e504 > _e506));
                                        let _e515 = select(_e507, _e505, (_e505 > _e507));
                                        let _e517 = select(_e480, _e478, (_e478 < _e480));
                                        let _e519 = select(_e481, _e479, (_e479 < _e481));
                                        let _e521 = select(_e493, _e491, (_e491 < _e493));
                                        let _e523 = select(_e494, _e492, (_e492 < _e494));
                                        let _e525 = select(_e521, _e517, (_e517 > _e521));
                                        let _e527 = select(_e523, _e519, (_e519 > _e523));
                                        let _e529 = select(_e509, _e525, (_e525 > _e509));
                                        let _e531 = select(_e511, _e527, (_e527 > _e511));
                                        let _e533 = select(_e480, _e478, (_e478 > _e480));
                                        let _e535 = select(_e481, _e479, (_e479 > _e481));
                                        let _e537 = select(_e493, _e491, (_e491 > _e493));
                                        let _e539 = select(_e494, _e492, (_e492 > _e494));
                                        let _e541 = select(_e537, _e533, (_e533 < _e537));
                                        let _e543 = select(_e539, _e535, (_e535 < _e539));
                                        let _e548 = -(_e509);
                                        let _e549 = -(_e511);
                                        let _e556 = (select(_e513, _e541, (_e541 < _e513)) + (select(_e548, _e513, (_e513 > _e548)) * 0.0000019073523f));
                                        let _e557 = (select(_e515, _e543, (_e543 < _e515)) + (select(_e549, _e515, (_e515 > _e549)) * 0.0000019073523f));
                                        let _e559 = select(_e372, _e529, (_e529 > _e372));
                                        let _e561 = select(_e372, _e531, (_e531 > _e372));
                                        let _e566 = (_e559 <= select(_e382.member_1, _e556, (_e556 < _e382.member_1)));
                                        let _e567 = (_e561 <= select(_e382.member_1, _e557, (_e557 < _e382.member_1)));
                                        let _e568 = (_e559 <= _e561);
                                        if _e566 {
                                            if _e567 {
                                                if _e568 {
                                                    phi_1862_ = _e466.member_2;
                                                } else {
                                                    phi_1862_ = _e466.member_1;
                                                }
                                                let _e572 = phi_1862_;
                                                let _e573 = (_e409 % 128u);
                                                let _e574 = (_e573 < 128u);
                                                if _e574 {
                                                } else {
                                                    phi_2104_ = true;
                                                    break;
                                                }
                                                local[_e573] = _e572;
                                                if _e574 {
                                                } else {
                                                    phi_2104_ = true;
                                                    break;
                                                }
                                                local_1[_e573] = select(_e561, _e559, (_e559 > _e561));
                                                if _e568 {
                                                    phi_1888_ = _e466.member_1;
                                                } else {
                                                    phi_1888_ = _e466.member_2;
                                                }
                                                let _e583 = phi_1888_;
                                                phi_1889_ = _e583;
                                                phi_1890_ = (_e409 + 1u);
                                            } else {
                                                phi_1889_ = u32();
                                                phi_1890_ = u32();
                                            }
                                            let _e585 = phi_1889_;
                                            let _e587 = phi_1890_;
                                            phi_1892_ = _e585;
                                            phi_1893_ = _e587;
                                            phi_1894_ = select(true, false, _e567);
                                        } else {
                                            phi_1892_ = u32();
                                            phi_1893_ = u32();
                                            phi_1894_ = true;
                                        }
                                        let _e590 = phi_1892_;
                                        let _e592 = phi_1893_;
                                        let _e594 = phi_1894_;
                                        if _e594 {
                                            if _e566 {
                                                phi_1903_ = _e466.member_1;
                                            } else {
                                                phi_1903_ = _e466.member_2;
                                            }
                                            let _e598 = phi_1903_;
                                            phi_1908_ = _e598;
                                            phi_1909_ = select(_e567, true, _e566);
                                        } else {
                                            phi_1908_ = _e590;
                                            phi_1909_ = _e407;
                                        }
                                        let _e601 = phi_1908_;
                                        let _e603 = phi_1909_;
                                        phi_2108_ = _e380;
                                        phi_1911_ = _e382;
                                        phi_1912_ = _e601;
                                        phi_1913_ = _e603;
                                        phi_1914_ = select(_e592, _e409, _e594);
                                    }
                                    let _e1017 = phi_2108_;
                                    let _e1019 = phi_1911_;
                                    let _e1021 = phi_1912_;
                                    let _e1023 = phi_1913_;
                                    let _e1025 = phi_1914_;
                                    phi_2107_ = _e1017;
                                    phi_1915_ = _e1019;
                                    phi_1916_ = _e1021;
                                    phi_1917_ = (_e386 - 1u);
                                    phi_1918_ = _e1023;
                                    phi_1919_ = _e1025;
                                } else {
                                    phi_2107_ = _e380;
                                    phi_1915_ = _e382;
                                    phi_1916_ = _e405;
                                    phi_1917_ = _e386;
                                    phi_1918_ = _e407;
                                    phi_1919_ = _e409;
                                }
                                let _e1027 = phi_2107_;
                                let _e1029 = phi_1915_;
                                let _e1031 = phi_1916_;
                                let _e1033 = phi_1917_;
                                let _e1035 = phi_1918_;
                                let _e1037 = phi_1919_;
                                phi_2106_ = _e1027;
                                phi_1920_ = _e1029;
                                phi_1921_ = _e1031;
                                phi_1922_ = _e1033;
                                phi_1923_ = _e1035;
                                phi_1924_ = _e1037;
                            } else {
                                phi_2106_ = _e380;
                                phi_1920_ = type_40();
                                phi_1921_ = u32();
                                phi_1922_ = u32();
                                phi_1923_ = bool();
                                phi_1924_ = u32();
                            }
                            let _e1039 = phi_2106_;
                            let _e1041 = phi_1920_;
                            let _e1043 = phi_1921_;
                            let _e1045 = phi_1922_;
                            let _e1047 = phi_1923_;
                            let _e1049 = phi_1924_;
                            phi_2105_ = _e1039;
                            phi_647_ = _e1041;
                            phi_650_ = _e1043;
                            phi_652_ = _e1045;
                            phi_654_ = _e1047;
                            phi_656_ = _e1049;
                            phi_1925_ = _e394;
                        } else {
                            phi_2105_ = _e380;
                            phi_647_ = type_40();
                            phi_650_ = u32();
                            phi_652_ = u32();
                            phi_654_ = bool();
                            phi_656_ = u32();
                            phi_1925_ = false;
                        }
                        let _e1051 = phi_2105_;
                        let _e1053 = phi_647_;
                        let _e1055 = phi_650_;
                        let _e1057 = phi_652_;
                        let _e1059 = phi_654_;
                        let _e1061 = phi_656_;
                        let _e1063 = phi_1925_;
                        continue;
                        continuing {
                            phi_2000_ = _e1051;
                            phi_646_ = _e1053;
                            phi_649_ = _e1055;
                            phi_651_ = _e1057;
                            phi_653_ = _e1059;
                            phi_655_ = _e1061;
                            phi_2104_ = _e1051;
                            break if !(_e1063);
                        }
                    }
                    let _e1066 = phi_2104_;
                    if _e1066 {
                        break;
                    }
                    let _e1068 = local_2;
                    if (_e1068.member.member_3 != 4294967295u) {
                        let _e1073 = (_e200 / 3i);
                        let _e1080 = bitcast<f32>((bitcast<u32>((_e1073 + 127i)) << bitcast<u32>(23i)));
                        let _e1088 = (((_e1068.member.member * _e1080) * _e1080) * bitcast<f32>((bitcast<u32>(((_e200 - (2i * _e1073)) + 127i)) << bitcast<u32>(23i))));
                        let _e1090 = select(340282350000000000000000000000000000000f, _e1088, (_e1088 < 340282350000000000000000000000000000000f));
                        phi_1977_ = type_16(select(-340282350000000000000000000000000000000f, _e1090, (_e1090 > -340282350000000000000000000000000000000f)), _e1068.member.member_1, _e1068.member.member_2, _e1068.member.member_3);
                    } else {
                        phi_1977_ = type_16(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1097 = phi_1977_;
                    if _e73 {
                    } else {
                        break;
                    }
                    global_4.member[_e71] = _e1097;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_paths(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
