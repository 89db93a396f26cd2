struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_34 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_36 {
    member: array<type_34>,
}

struct type_42 {
    member: type_22,
    member_1: f32,
}

struct type_47 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_48 {
    member: type_42,
    member_1: u32,
    member_2: u32,
}

struct type_52 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_15;
@group(0) @binding(0) 
var<storage> global_2: type_36;
@group(0) @binding(2) 
var<storage> global_3: type_29;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_24;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_52;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_283_: i32;
    var phi_284_: i32;
    var phi_294_: bool;
    var phi_304_: u32;
    var phi_305_: u32;
    var phi_307_: bool;
    var phi_312_: u32;
    var phi_344_: i32;
    var phi_362_: f32;
    var phi_368_: f32;
    var phi_379_: f32;
    var phi_385_: f32;
    var phi_408_: f32;
    var phi_419_: f32;
    var phi_428_: f32;
    var phi_434_: f32;
    var phi_445_: f32;
    var phi_451_: f32;
    var phi_474_: f32;
    var phi_485_: f32;
    var phi_494_: f32;
    var phi_500_: f32;
    var phi_511_: f32;
    var phi_517_: f32;
    var phi_540_: f32;
    var phi_551_: f32;
    var phi_651_: f32;
    var phi_652_: f32;
    var phi_2422_: bool;
    var phi_672_: type_48;
    var phi_675_: u32;
    var phi_677_: u32;
    var phi_679_: bool;
    var phi_681_: u32;
    var phi_692_: bool;
    var phi_724_: u32;
    var phi_725_: bool;
    var phi_726_: u32;
    var phi_1821_: type_47;
    var phi_2165_: u32;
    var phi_2193_: u32;
    var phi_2194_: u32;
    var phi_2195_: u32;
    var phi_2197_: u32;
    var phi_2198_: u32;
    var phi_2199_: bool;
    var phi_2208_: u32;
    var phi_2213_: u32;
    var phi_2214_: bool;
    var phi_741_: type_48;
    var phi_744_: type_7;
    var phi_745_: type_7;
    var phi_767_: type_7;
    var phi_791_: u32;
    var phi_880_: array<array<f32, 3>, 3>;
    var phi_997_: bool;
    var phi_1026_: bool;
    var phi_1427_: f32;
    var phi_1428_: f32;
    var phi_1429_: f32;
    var phi_1430_: f32;
    var phi_1431_: vec3<f32>;
    var phi_1432_: vec3<f32>;
    var phi_1433_: vec3<f32>;
    var phi_1434_: vec3<f32>;
    var phi_1465_: bool;
    var phi_1474_: vec3<f32>;
    var phi_1641_: bool;
    var phi_1665_: f32;
    var phi_1666_: f32;
    var phi_1689_: type_22;
    var phi_1691_: type_22;
    var phi_1692_: bool;
    var phi_1696_: type_22;
    var phi_1697_: type_22;
    var phi_1698_: type_22;
    var phi_1699_: bool;
    var phi_1703_: type_22;
    var phi_1704_: bool;
    var phi_1705_: type_22;
    var phi_1706_: bool;
    var phi_1707_: bool;
    var phi_1708_: type_22;
    var phi_1709_: bool;
    var phi_1710_: bool;
    var phi_1718_: type_22;
    var phi_1719_: bool;
    var phi_1723_: type_22;
    var phi_1748_: bool;
    var phi_1749_: bool;
    var phi_1756_: type_48;
    var phi_1757_: type_48;
    var phi_1758_: type_48;
    var phi_742_: type_48;
    var phi_2416_: bool;
    var phi_2562_: bool;
    var phi_2216_: type_48;
    var phi_2217_: u32;
    var phi_2218_: bool;
    var phi_2219_: u32;
    var phi_2561_: bool;
    var phi_2220_: type_48;
    var phi_2221_: u32;
    var phi_2222_: u32;
    var phi_2223_: bool;
    var phi_2224_: u32;
    var phi_2560_: bool;
    var phi_2225_: type_48;
    var phi_2226_: u32;
    var phi_2227_: u32;
    var phi_2228_: bool;
    var phi_2229_: u32;
    var phi_2559_: bool;
    var phi_673_: type_48;
    var phi_676_: u32;
    var phi_678_: u32;
    var phi_680_: bool;
    var phi_682_: u32;
    var phi_2230_: bool;
    var phi_2558_: bool;
    var local_2: type_48;
    var phi_2282_: type_22;
    var local_3: type_48;
    var local_4: type_48;

    switch bitcast<i32>(0u) {
        default: {
            let _e66 = global;
            let _e68 = arrayLength((&global_2.member));
            let _e70 = arrayLength((&global_1.member));
            let _e78 = arrayLength((&global_6.member));
            let _e82 = (_e66.x + (_e66.y * 2097152u));
            let _e83 = (_e82 < arrayLength((&global_3.member)));
            if _e83 {
                let _e84 = (_e82 < arrayLength((&global_4.member)));
                if _e84 {
                    let _e85 = (_e82 < arrayLength((&global_5.member)));
                    if _e85 {
                        if _e83 {
                        } else {
                            break;
                        }
                        let _e95 = global_3.member[_e82].member.member_2[0u];
                        let _e97 = (bitcast<u32>(_e95) & 2147483647u);
                        let _e103 = global_3.member[_e82].member.member_2[1u];
                        let _e105 = (bitcast<u32>(_e103) & 2147483647u);
                        let _e111 = global_3.member[_e82].member.member_2[2u];
                        let _e113 = (bitcast<u32>(_e111) & 2147483647u);
                        let _e119 = global_3.member[_e82].member.member[0u];
                        let _e121 = (bitcast<u32>(_e119) & 2147483647u);
                        let _e127 = global_3.member[_e82].member.member[1u];
                        let _e129 = (bitcast<u32>(_e127) & 2147483647u);
                        let _e135 = global_3.member[_e82].member.member[2u];
                        let _e137 = (bitcast<u32>(_e135) & 2147483647u);
                        let _e139 = select(_e105, _e97, (_e105 < _e97));
                        let _e141 = select(_e113, _e139, (_e113 < _e139));
                        let _e143 = select(_e121, _e141, (_e121 < _e141));
                        let _e145 = select(_e129, _e143, (_e129 < _e143));
                        let _e147 = select(_e137, _e145, (_e137 < _e145));
                        let _e152 = global_3.member[_e82].member.member_1;
                        let _e154 = (bitcast<u32>(_e152) & 2147483647u);
                        let _e162 = global_3.member[_e82].member.member_3;
                        let _e168 = (((select(_e154, _e147, (_e154 < _e147)) < 2139095040u) && ((bitcast<u32>(_e162) & 2147483647u) <= 2139095040u)) && (_e141 > 0u));
                        if _e168 {
                            let _e171 = (bitcast<u32>(bitcast<f32>(_e141)) & 2147483647u);
                            if (_e171 >= 8388608u) {
                                phi_283_ = (bitcast<i32>((_e171 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_283_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e171)), 32u, (_e171 == 0u))));
                            }
                            let _e185 = phi_283_;
                            phi_284_ = _e185;
                        } else {
                            phi_284_ = 0i;
                        }
                        let _e187 = phi_284_;
                        let _e188 = (_e97 == _e141);
                        if _e188 {
                            phi_294_ = true;
                        } else {
                            phi_294_ = (_e105 == _e141);
                        }
                        let _e191 = phi_294_;
                        let _e192 = select(1u, 0u, _e188);
                        if _e191 {
                            let _e193 = (_e192 + 1u);
                            phi_304_ = _e193;
                            phi_305_ = _e193;
                            phi_307_ = select(true, false, (_e193 == 2u));
                        } else {
                            phi_304_ = u32();
                            phi_305_ = 0u;
                            phi_307_ = true;
                        }
                        let _e197 = phi_304_;
                        let _e199 = phi_305_;
                        let _e201 = phi_307_;
                        if _e201 {
                            phi_312_ = (_e199 + 1u);
                        } else {
                            phi_312_ = 0u;
                        }
                        let _e205 = phi_312_;
                        let _e206 = select(_e197, _e199, _e201);
                        let _e207 = select(_e192, select(2u, _e192, _e191), _e201);
                        let _e208 = -(_e187);
                        if (_e208 < -126i) {
                            phi_344_ = -126i;
                        } else {
                            phi_344_ = select(_e208, 127i, (_e208 > 127i));
                        }
                        let _e213 = phi_344_;
                        let _e218 = bitcast<f32>((bitcast<u32>((_e213 + 127i)) << bitcast<u32>(23i)));
                        let _e224 = bitcast<f32>((bitcast<u32>(((_e208 - _e213) + 127i)) << bitcast<u32>(23i)));
                        let _e229 = global_3.member[_e82].member.member;
                        let _e230 = (_e206 == 0u);
                        if _e230 {
                            phi_362_ = _e229[0];
                        } else {
                            phi_362_ = _e229[1];
                        }
                        let _e234 = phi_362_;
                        let _e235 = (_e206 == 2u);
                        if _e235 {
                            phi_368_ = _e229[2];
                        } else {
                            phi_368_ = _e234;
                        }
                        let _e238 = phi_368_;
                        let _e239 = global_3.member[_e82].member.member_2;
                        if _e230 {
                            phi_379_ = _e239[0];
                        } else {
                            phi_379_ = _e239[1];
                        }
                        let _e243 = phi_379_;
                        if _e235 {
                            phi_385_ = _e239[2];
                        } else {
                            phi_385_ = _e243;
                        }
                        let _e246 = phi_385_;
                        let _e248 = ((_e246 * _e218) * _e224);
                        let _e252 = (bitcast<f32>((bitcast<u32>(_e248) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e252 {
                            let _e256 = (bitcast<f32>((bitcast<u32>(_e238) & 2147483647u)) * 0.00000011920929f);
                            phi_408_ = select(0.00000000000011368684f, _e256, (_e256 > 0.00000000000011368684f));
                        } else {
                            phi_408_ = 0f;
                        }
                        let _e260 = phi_408_;
                        let _e261 = (_e238 + _e260);
                        let _e262 = (_e238 - _e260);
                        let _e263 = select(_e248, 0f, _e252);
                        if _e252 {
                            phi_419_ = 38685626000000000000000000f;
                        } else {
                            phi_419_ = (1f / _e248);
                        }
                        let _e266 = phi_419_;
                        let _e267 = (_e205 == 0u);
                        if _e267 {
                            phi_428_ = _e229[0];
                        } else {
                            phi_428_ = _e229[1];
                        }
                        let _e271 = phi_428_;
                        let _e272 = (_e205 == 2u);
                        if _e272 {
                            phi_434_ = _e229[2];
                        } else {
                            phi_434_ = _e271;
                        }
                        let _e275 = phi_434_;
                        if _e267 {
                            phi_445_ = _e239[0];
                        } else {
                            phi_445_ = _e239[1];
                        }
                        let _e279 = phi_445_;
                        if _e272 {
                            phi_451_ = _e239[2];
                        } else {
                            phi_451_ = _e279;
                        }
                        let _e282 = phi_451_;
                        let _e284 = ((_e282 * _e218) * _e224);
                        let _e288 = (bitcast<f32>((bitcast<u32>(_e284) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e288 {
                            let _e292 = (bitcast<f32>((bitcast<u32>(_e275) & 2147483647u)) * 0.00000011920929f);
                            phi_474_ = select(0.00000000000011368684f, _e292, (_e292 > 0.00000000000011368684f));
                        } else {
                            phi_474_ = 0f;
                        }
                        let _e296 = phi_474_;
                        let _e297 = (_e275 + _e296);
                        let _e298 = (_e275 - _e296);
                        let _e299 = select(_e284, 0f, _e288);
                        if _e288 {
                            phi_485_ = 38685626000000000000000000f;
                        } else {
                            phi_485_ = (1f / _e284);
                        }
                        let _e302 = phi_485_;
                        let _e303 = (_e207 == 0u);
                        if _e303 {
                            phi_494_ = _e229[0];
                        } else {
                            phi_494_ = _e229[1];
                        }
                        let _e307 = phi_494_;
                        let _e308 = (_e207 == 2u);
                        if _e308 {
                            phi_500_ = _e229[2];
                        } else {
                            phi_500_ = _e307;
                        }
                        let _e311 = phi_500_;
                        if _e303 {
                            phi_511_ = _e239[0];
                        } else {
                            phi_511_ = _e239[1];
                        }
                        let _e315 = phi_511_;
                        if _e308 {
                            phi_517_ = _e239[2];
                        } else {
                            phi_517_ = _e315;
                        }
                        let _e318 = phi_517_;
                        let _e320 = ((_e318 * _e218) * _e224);
                        let _e324 = (bitcast<f32>((bitcast<u32>(_e320) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e324 {
                            let _e328 = (bitcast<f32>((bitcast<u32>(_e311) & 2147483647u)) * 0.00000011920929f);
                            phi_540_ = select(0.00000000000011368684f, _e328, (_e328 > 0.00000000000011368684f));
                        } else {
                            phi_540_ = 0f;
                        }
                        let _e332 = phi_540_;
                        let _e333 = (_e311 + _e332);
                        let _e334 = (_e311 - _e332);
                        let _e335 = select(_e320, 0f, _e324);
                        if _e324 {
                            phi_551_ = 38685626000000000000000000f;
                        } else {
                            phi_551_ = (1f / _e320);
                        }
                        let _e338 = phi_551_;
                        let _e341 = bitcast<f32>((bitcast<u32>(_e238) & 2147483647u));
                        let _e344 = bitcast<f32>((bitcast<u32>(_e275) & 2147483647u));
                        let _e346 = select(_e344, _e341, (_e341 > _e344));
                        let _e349 = bitcast<f32>((bitcast<u32>(_e311) & 2147483647u));
                        if (_e168 && (select(_e349, _e346, (_e346 > _e349)) <= 1099511600000f)) {
                            let _e354 = (_e187 / 3i);
                            let _e361 = bitcast<f32>((bitcast<u32>((_e354 + 127i)) << bitcast<u32>(23i)));
                            let _e368 = bitcast<f32>((bitcast<u32>(((_e187 - (2i * _e354)) + 127i)) << bitcast<u32>(23i)));
                            let _e369 = (((_e152 * _e361) * _e361) * _e368);
                            let _e371 = select(340282350000000000000000000000000000000f, _e369, (_e369 < 340282350000000000000000000000000000000f));
                            let _e376 = (((_e162 * _e361) * _e361) * _e368);
                            let _e378 = select(340282350000000000000000000000000000000f, _e376, (_e376 < 340282350000000000000000000000000000000f));
                            phi_651_ = select(-340282350000000000000000000000000000000f, _e378, (_e378 > -340282350000000000000000000000000000000f));
                            phi_652_ = select(-340282350000000000000000000000000000000f, _e371, (_e371 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_651_ = 0f;
                            phi_652_ = 1f;
                        }
                        let _e382 = phi_651_;
                        let _e384 = phi_652_;
                        if _e83 {
                        } else {
                            break;
                        }
                        let _e390 = global_3.member[_e82].member_2;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2422_ = false;
                        phi_672_ = type_48(type_42(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e382), 0u, 0u);
                        phi_675_ = select(0u, 2147483648u, (_e68 == 0u));
                        phi_677_ = ((3u * _e68) + 1u);
                        phi_679_ = (_e384 <= _e382);
                        phi_681_ = 0u;
                        loop {
                            let _e397 = phi_2422_;
                            let _e399 = phi_672_;
                            let _e401 = phi_675_;
                            let _e403 = phi_677_;
                            let _e405 = phi_679_;
                            let _e407 = phi_681_;
                            local_2 = _e399;
                            local_3 = _e399;
                            if _e405 {
                                phi_692_ = true;
                            } else {
                                phi_692_ = (_e407 > 0u);
                            }
                            let _e410 = phi_692_;
                            if _e410 {
                                let _e411 = (_e403 > 0u);
                                if _e411 {
                                    if _e405 {
                                        phi_724_ = _e401;
                                        phi_725_ = _e405;
                                        phi_726_ = _e407;
                                    } else {
                                        let _e412 = (_e407 - 1u);
                                        let _e413 = (_e412 % 128u);
                                        let _e414 = (_e413 < 128u);
                                        if _e414 {
                                        } else {
                                            phi_2558_ = true;
                                            break;
                                        }
                                        let _e416 = local_1[_e413];
                                        if _e414 {
                                        } else {
                                            phi_2558_ = true;
                                            break;
                                        }
                                        let _e418 = local[_e413];
                                        phi_724_ = _e416;
                                        phi_725_ = (_e418 <= _e399.member.member_1);
                                        phi_726_ = _e412;
                                    }
                                    let _e423 = phi_724_;
                                    let _e425 = phi_725_;
                                    let _e427 = phi_726_;
                                    if _e425 {
                                        if ((_e423 & 2147483648u) != 0u) {
                                            phi_741_ = _e399;
                                            phi_744_ = type_7(0u, ((_e423 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e632 = phi_741_;
                                                let _e634 = phi_744_;
                                                local_4 = _e632;
                                                if (_e634.member < _e634.member_1) {
                                                    phi_745_ = type_7((_e634.member + 1u), _e634.member_1);
                                                    phi_767_ = type_7(1u, _e634.member);
                                                } else {
                                                    phi_745_ = _e634;
                                                    phi_767_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e647 = phi_745_;
                                                let _e649 = phi_767_;
                                                let _e653 = (bitcast<i32>(_e649.member) != 0i);
                                                if _e653 {
                                                    let _e659 = type_48(_e632.member, _e632.member_1, (_e632.member_2 + 1u));
                                                    let _e660 = ((_e423 & 268435455u) + _e649.member_1);
                                                    let _e661 = (_e660 < _e70);
                                                    if _e661 {
                                                        if _e661 {
                                                        } else {
                                                            phi_2416_ = true;
                                                            break;
                                                        }
                                                        let _e665 = global_1.member[_e660].member_1;
                                                        phi_791_ = _e665;
                                                    } else {
                                                        phi_791_ = 4294967295u;
                                                    }
                                                    let _e667 = phi_791_;
                                                    if (_e660 >= _e70) {
                                                        phi_880_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e661 {
                                                        } else {
                                                            phi_2416_ = true;
                                                            break;
                                                        }
                                                        let _e669 = (_e206 % 3u);
                                                        let _e670 = (_e205 % 3u);
                                                        let _e671 = (_e207 % 3u);
                                                        if (_e669 < 9u) {
                                                        } else {
                                                            phi_2416_ = true;
                                                            break;
                                                        }
                                                        let _e677 = global_1.member[_e660].member[_e669];
                                                        if (_e670 < 9u) {
                                                        } else {
                                                            phi_2416_ = true;
                                                            break;
                                                        }
                                                        let _e683 = global_1.member[_e660].member[_e670];
                                                        if (_e671 < 9u) {
                                                        } else {
                                                            phi_2416_ = true;
                                                            break;
                                                        }
                                                        let _e689 = global_1.member[_e660].member[_e671];
                                                        let _e691 = (3u + _e669);
                                                        if (_e691 < 9u) {
                                                        } else {
                                                            phi_2416_ = true;
                                                            break;
                                                        }
                                                        let _e697 = global_1.member[_e660].member[_e691];
                                                        let _e698 = (3u + _e670);
                                                        if (_e698 < 9u) {
                                                        } else {
                                                            phi_2416_ = true;
                                                            break;
                                                        }
                                                        let _e704 = global_1.member[_e660].member[_e698];
                                                        let _e705 = (3u + _e671);
                                                        if (_e705 < 9u) {
                                                        } else {
                                                            phi_2416_ = true;
                                                            break;
                                                        }
                                                        let _e711 = global_1.member[_e660].member[_e705];
                                                        let _e713 = (6u + _e669);
                                                        if (_e713 < 9u) {
                                                        } else {
                                                            phi_2416_ = true;
                                                            break;
                                                        }
                                                        let _e719 = global_1.member[_e660].member[_e713];
                                                        let _e720 = (6u + _e670);
                                                        if (_e720 < 9u) {
                                                        } else {
                                                            phi_2416_ = true;
                                                            break;
                                                        }
                                                        let _e726 = global_1.member[_e660].member[_e720];
                                                        let _e727 = (6u + _e671);
                                                        if (_e727 < 9u) {
                                                        } else {
                                                            phi_2416_ = true;
                                                            break;
                                                        }
                                                        let _e733 = global_1.member[_e660].member[_e727];
                                                        phi_880_ = array<array<f32, 3>, 3>(array<f32, 3>(_e677, _e683, _e689), array<f32, 3>(_e697, _e704, _e711), array<f32, 3>(_e719, _e726, _e733));
                                                    }
                                                    let _e737 = phi_880_;
                                                    let _e746 = (_e737[0][2] - _e311);
                                                    let _e749 = (((_e737[0][0] - _e238) * _e335) - (_e746 * _e263));
                                                    let _e752 = (((_e737[0][1] - _e275) * _e335) - (_e746 * _e299));
                                                    let _e759 = (_e737[1][2] - _e311);
                                                    let _e762 = (((_e737[1][0] - _e238) * _e335) - (_e759 * _e263));
                                                    let _e765 = (((_e737[1][1] - _e275) * _e335) - (_e759 * _e299));
                                                    let _e772 = (_e737[2][2] - _e311);
                                                    let _e775 = (((_e737[2][0] - _e238) * _e335) - (_e772 * _e263));
                                                    let _e778 = (((_e737[2][1] - _e275) * _e335) - (_e772 * _e299));
                                                    let _e779 = (_e775 * _e765);
                                                    let _e780 = (_e778 * _e762);
                                                    let _e781 = (_e749 * _e778);
                                                    let _e782 = (_e752 * _e775);
                                                    let _e783 = (_e762 * _e752);
                                                    let _e784 = (_e765 * _e749);
                                                    let _e789 = (((_e779 >= _e780) && (_e781 >= _e782)) && (_e783 >= _e784));
                                                    if (_e789 || (((_e779 <= _e780) && (_e781 <= _e782)) && (_e783 <= _e784))) {
                                                        let _e796 = select(-1f, 1f, _e789);
                                                        let _e798 = ((_e779 - _e780) * _e796);
                                                        let _e800 = select(0f, _e798, (_e798 > 0f));
                                                        let _e802 = ((_e781 - _e782) * _e796);
                                                        let _e804 = select(0f, _e802, (_e802 > 0f));
                                                        let _e806 = ((_e783 - _e784) * _e796);
                                                        let _e808 = select(0f, _e806, (_e806 > 0f));
                                                        let _e810 = ((_e800 + _e804) + _e808);
                                                        if (_e810 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1708_ = type_22();
                                                            phi_1709_ = true;
                                                            phi_1710_ = false;
                                                        } else {
                                                            let _e813 = select(_e762, _e749, (_e749 < _e762));
                                                            if (select(_e775, _e813, (_e813 < _e775)) > 0f) {
                                                                phi_997_ = true;
                                                            } else {
                                                                let _e818 = select(_e762, _e749, (_e749 > _e762));
                                                                phi_997_ = (select(_e775, _e818, (_e818 > _e775)) < 0f);
                                                            }
                                                            let _e823 = phi_997_;
                                                            if _e823 {
                                                                phi_1705_ = type_22();
                                                                phi_1706_ = true;
                                                                phi_1707_ = false;
                                                            } else {
                                                                let _e825 = select(_e765, _e752, (_e752 < _e765));
                                                                if (select(_e778, _e825, (_e825 < _e778)) > 0f) {
                                                                    phi_1026_ = true;
                                                                } else {
                                                                    let _e830 = select(_e765, _e752, (_e752 > _e765));
                                                                    phi_1026_ = (select(_e778, _e830, (_e830 > _e778)) < 0f);
                                                                }
                                                                let _e835 = phi_1026_;
                                                                if _e835 {
                                                                    phi_1703_ = type_22();
                                                                    phi_1704_ = false;
                                                                } else {
                                                                    let _e837 = select(_e737[1][0], _e737[0][0], (_e737[0][0] < _e737[1][0]));
                                                                    let _e841 = select(_e737[1][0], _e737[0][0], (_e737[0][0] > _e737[1][0]));
                                                                    let _e845 = select(_e737[1][1], _e737[0][1], (_e737[0][1] < _e737[1][1]));
                                                                    let _e849 = select(_e737[1][1], _e737[0][1], (_e737[0][1] > _e737[1][1]));
                                                                    let _e853 = select(_e737[1][2], _e737[0][2], (_e737[0][2] < _e737[1][2]));
                                                                    let _e857 = select(_e737[1][2], _e737[0][2], (_e737[0][2] > _e737[1][2]));
                                                                    let _e862 = ((select(_e737[2][0], _e837, (_e837 < _e737[2][0])) - _e261) * _e266);
                                                                    let _e863 = ((select(_e737[2][0], _e841, (_e841 > _e737[2][0])) - _e262) * _e266);
                                                                    let _e866 = ((select(_e737[2][1], _e845, (_e845 < _e737[2][1])) - _e297) * _e302);
                                                                    let _e867 = ((select(_e737[2][1], _e849, (_e849 > _e737[2][1])) - _e298) * _e302);
                                                                    let _e870 = ((select(_e737[2][2], _e853, (_e853 < _e737[2][2])) - _e333) * _e338);
                                                                    let _e871 = ((select(_e737[2][2], _e857, (_e857 > _e737[2][2])) - _e334) * _e338);
                                                                    let _e873 = select(_e871, _e870, (_e870 < _e871));
                                                                    let _e875 = select(_e871, _e870, (_e870 > _e871));
                                                                    let _e877 = select(_e863, _e862, (_e862 < _e863));
                                                                    let _e879 = select(_e867, _e866, (_e866 < _e867));
                                                                    let _e881 = select(_e879, _e877, (_e877 > _e879));
                                                                    let _e883 = select(_e873, _e881, (_e881 > _e873));
                                                                    let _e885 = select(_e863, _e862, (_e862 > _e863));
                                                                    let _e887 = select(_e867, _e866, (_e866 > _e867));
                                                                    let _e889 = select(_e887, _e885, (_e885 < _e887));
                                                                    let _e891 = select(_e875, _e889, (_e889 < _e875));
                                                                    let _e892 = -(_e873);
                                                                    let _e898 = select(_e384, _e883, (_e883 > _e384));
                                                                    if (_e898 > (_e891 + (select(_e892, _e875, (_e875 > _e892)) * 0.0000019073523f))) {
                                                                        phi_1698_ = type_22();
                                                                        phi_1699_ = true;
                                                                    } else {
                                                                        let _e900 = (_e898 > _e632.member.member_1);
                                                                        if _e900 {
                                                                            phi_1697_ = type_22();
                                                                        } else {
                                                                            let _e901 = vec3<f32>(_e737[0][0], _e737[0][1], _e737[0][2]);
                                                                            let _e902 = vec3<f32>(_e737[1][0], _e737[1][1], _e737[1][2]);
                                                                            let _e903 = vec3<f32>(_e737[2][0], _e737[2][1], _e737[2][2]);
                                                                            let _e904 = (_e737[1][0] - _e737[0][0]);
                                                                            let _e905 = (_e737[1][1] - _e737[0][1]);
                                                                            let _e906 = (_e737[1][2] - _e737[0][2]);
                                                                            let _e907 = vec3<f32>(_e904, _e905, _e906);
                                                                            let _e908 = (_e737[2][0] - _e737[1][0]);
                                                                            let _e909 = (_e737[2][1] - _e737[1][1]);
                                                                            let _e910 = (_e737[2][2] - _e737[1][2]);
                                                                            let _e911 = vec3<f32>(_e908, _e909, _e910);
                                                                            let _e912 = (_e737[0][0] - _e737[2][0]);
                                                                            let _e913 = (_e737[0][1] - _e737[2][1]);
                                                                            let _e914 = (_e737[0][2] - _e737[2][2]);
                                                                            let _e915 = vec3<f32>(_e912, _e913, _e914);
                                                                            let _e918 = bitcast<f32>((bitcast<u32>(_e904) & 2147483647u));
                                                                            let _e921 = bitcast<f32>((bitcast<u32>(_e905) & 2147483647u));
                                                                            let _e923 = select(_e921, _e918, (_e918 > _e921));
                                                                            let _e926 = bitcast<f32>((bitcast<u32>(_e906) & 2147483647u));
                                                                            let _e928 = select(_e926, _e923, (_e923 > _e926));
                                                                            let _e931 = bitcast<f32>((bitcast<u32>(_e908) & 2147483647u));
                                                                            let _e934 = bitcast<f32>((bitcast<u32>(_e909) & 2147483647u));
                                                                            let _e936 = select(_e934, _e931, (_e931 > _e934));
                                                                            let _e939 = bitcast<f32>((bitcast<u32>(_e910) & 2147483647u));
                                                                            let _e941 = select(_e939, _e936, (_e936 > _e939));
                                                                            let _e944 = bitcast<f32>((bitcast<u32>(_e912) & 2147483647u));
                                                                            let _e947 = bitcast<f32>((bitcast<u32>(_e913) & 2147483647u));
                                                                            let _e949 = select(_e947, _e944, (_e944 > _e947));
                                                                            let _e952 = bitcast<f32>((bitcast<u32>(_e914) & 2147483647u));
                                                                            let _e954 = select(_e952, _e949, (_e949 > _e952));
                                                                            let _e956 = select(_e941, _e928, (_e928 > _e941));
                                                                            let _e958 = select(_e954, _e956, (_e956 > _e954));
                                                                            if (_e928 == _e958) {
                                                                                phi_1427_ = _e765;
                                                                                phi_1428_ = _e762;
                                                                                phi_1429_ = _e752;
                                                                                phi_1430_ = _e749;
                                                                                phi_1431_ = _e901;
                                                                                phi_1432_ = _e915;
                                                                                phi_1433_ = _e911;
                                                                                phi_1434_ = _e907;
                                                                            } else {
                                                                                let _e960 = (_e941 == _e958);
                                                                                let _e965 = vec3(_e960);
                                                                                phi_1427_ = select(_e752, _e778, _e960);
                                                                                phi_1428_ = select(_e749, _e775, _e960);
                                                                                phi_1429_ = select(_e778, _e765, _e960);
                                                                                phi_1430_ = select(_e775, _e762, _e960);
                                                                                phi_1431_ = select(_e903, _e902, _e965);
                                                                                phi_1432_ = select(_e911, _e907, _e965);
                                                                                phi_1433_ = select(_e907, _e915, _e965);
                                                                                phi_1434_ = select(_e915, _e911, _e965);
                                                                            }
                                                                            let _e971 = phi_1427_;
                                                                            let _e973 = phi_1428_;
                                                                            let _e975 = phi_1429_;
                                                                            let _e977 = phi_1430_;
                                                                            let _e979 = phi_1431_;
                                                                            let _e981 = phi_1432_;
                                                                            let _e983 = phi_1433_;
                                                                            let _e985 = phi_1434_;
                                                                            let _e992 = ((_e983.y * _e981.z) - (_e981.y * _e983.z));
                                                                            let _e997 = ((_e983.z * _e981.x) - (_e981.z * _e983.x));
                                                                            let _e1000 = ((_e983.x * _e981.y) - (_e981.x * _e983.y));
                                                                            if (_e800 >= _e804) {
                                                                                phi_1465_ = select(true, false, (_e800 >= _e808));
                                                                            } else {
                                                                                phi_1465_ = true;
                                                                            }
                                                                            let _e1005 = phi_1465_;
                                                                            if _e1005 {
                                                                                phi_1474_ = select(_e903, _e902, vec3((_e804 >= _e808)));
                                                                            } else {
                                                                                phi_1474_ = _e901;
                                                                            }
                                                                            let _e1010 = phi_1474_;
                                                                            let _e1015 = (((_e992 * _e263) + (_e997 * _e299)) + (_e1000 * _e335));
                                                                            let _e1026 = (((_e992 * (_e1010.x - _e238)) + (_e997 * (_e1010.y - _e275))) + (_e1000 * (_e1010.z - _e311)));
                                                                            let _e1028 = (_e973 - _e977);
                                                                            let _e1029 = (_e971 - _e975);
                                                                            let _e1037 = (-(((_e977 * _e1028) + (_e975 * _e1029))) / ((_e1028 * _e1028) + (_e1029 * _e1029)));
                                                                            let _e1039 = select(1f, _e1037, (_e1037 < 1f));
                                                                            let _e1041 = select(0f, _e1039, (_e1039 > 0f));
                                                                            let _e1054 = ((_e979.x + (_e985.x * _e1041)) - _e238);
                                                                            let _e1055 = ((_e979.y + (_e985.y * _e1041)) - _e275);
                                                                            let _e1056 = ((_e979.z + (_e985.z * _e1041)) - _e311);
                                                                            let _e1057 = (_e1056 / _e335);
                                                                            let _e1069 = bitcast<f32>((bitcast<u32>(_e1054) & 2147483647u));
                                                                            let _e1072 = bitcast<f32>((bitcast<u32>(_e1055) & 2147483647u));
                                                                            let _e1074 = select(_e1072, _e1069, (_e1069 > _e1072));
                                                                            let _e1077 = bitcast<f32>((bitcast<u32>(_e1056) & 2147483647u));
                                                                            let _e1079 = select(_e1077, _e1074, (_e1074 > _e1077));
                                                                            let _e1085 = bitcast<f32>((bitcast<u32>(_e992) & 2147483647u));
                                                                            let _e1088 = bitcast<f32>((bitcast<u32>(_e997) & 2147483647u));
                                                                            let _e1090 = select(_e1088, _e1085, (_e1085 > _e1088));
                                                                            let _e1093 = bitcast<f32>((bitcast<u32>(_e1000) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e992 * _e1054) + (_e997 * _e1055)) + (_e1000 * _e1056)) - _e1026)) & 2147483647u)) <= ((0.0000009536743f * select(_e958, _e1079, (_e1079 > _e958))) * select(_e1093, _e1090, (_e1090 > _e1093)))) {
                                                                                let _e1103 = bitcast<f32>((bitcast<u32>(_e983.x) & 2147483647u));
                                                                                let _e1106 = bitcast<f32>((bitcast<u32>(_e983.y) & 2147483647u));
                                                                                let _e1108 = select(_e1106, _e1103, (_e1103 > _e1106));
                                                                                let _e1111 = bitcast<f32>((bitcast<u32>(_e983.z) & 2147483647u));
                                                                                let _e1117 = bitcast<f32>((bitcast<u32>(_e981.x) & 2147483647u));
                                                                                let _e1120 = bitcast<f32>((bitcast<u32>(_e981.y) & 2147483647u));
                                                                                let _e1122 = select(_e1120, _e1117, (_e1117 > _e1120));
                                                                                let _e1125 = bitcast<f32>((bitcast<u32>(_e981.z) & 2147483647u));
                                                                                phi_1641_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1015) & 2147483647u)) > ((0.0000038146973f * select(_e1111, _e1108, (_e1108 > _e1111))) * select(_e1125, _e1122, (_e1122 > _e1125)))));
                                                                            } else {
                                                                                phi_1641_ = true;
                                                                            }
                                                                            let _e1132 = phi_1641_;
                                                                            if _e1132 {
                                                                                let _e1143 = ((((_e992 * (_e1054 - (_e263 * _e1057))) + (_e997 * (_e1055 - (_e299 * _e1057)))) + (_e1000 * (_e1056 - _e1056))) / _e1015);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1143) & 2147483647u)) <= _e958) {
                                                                                    phi_1665_ = (_e1057 + _e1143);
                                                                                } else {
                                                                                    phi_1665_ = _e1057;
                                                                                }
                                                                                let _e1150 = phi_1665_;
                                                                                phi_1666_ = _e1150;
                                                                            } else {
                                                                                phi_1666_ = (_e1026 / _e1015);
                                                                            }
                                                                            let _e1152 = phi_1666_;
                                                                            let _e1154 = select(_e891, _e1152, (_e1152 < _e891));
                                                                            let _e1156 = select(_e883, _e1154, (_e1154 > _e883));
                                                                            if (_e1156 >= _e384) {
                                                                                let _e1158 = (_e1156 <= _e632.member.member_1);
                                                                                if _e1158 {
                                                                                    let _e1159 = (1f / _e810);
                                                                                    phi_1689_ = type_22(_e1156, (_e804 * _e1159), (_e808 * _e1159), _e667);
                                                                                } else {
                                                                                    phi_1689_ = type_22();
                                                                                }
                                                                                let _e1164 = phi_1689_;
                                                                                phi_1691_ = _e1164;
                                                                                phi_1692_ = select(true, false, _e1158);
                                                                            } else {
                                                                                phi_1691_ = type_22();
                                                                                phi_1692_ = true;
                                                                            }
                                                                            let _e1167 = phi_1691_;
                                                                            let _e1169 = phi_1692_;
                                                                            if _e1169 {
                                                                                phi_1696_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_1696_ = _e1167;
                                                                            }
                                                                            let _e1171 = phi_1696_;
                                                                            phi_1697_ = _e1171;
                                                                        }
                                                                        let _e1173 = phi_1697_;
                                                                        phi_1698_ = _e1173;
                                                                        phi_1699_ = _e900;
                                                                    }
                                                                    let _e1175 = phi_1698_;
                                                                    let _e1177 = phi_1699_;
                                                                    phi_1703_ = _e1175;
                                                                    phi_1704_ = _e1177;
                                                                }
                                                                let _e1179 = phi_1703_;
                                                                let _e1181 = phi_1704_;
                                                                phi_1705_ = _e1179;
                                                                phi_1706_ = _e835;
                                                                phi_1707_ = _e1181;
                                                            }
                                                            let _e1183 = phi_1705_;
                                                            let _e1185 = phi_1706_;
                                                            let _e1187 = phi_1707_;
                                                            phi_1708_ = _e1183;
                                                            phi_1709_ = _e1185;
                                                            phi_1710_ = _e1187;
                                                        }
                                                        let _e1189 = phi_1708_;
                                                        let _e1191 = phi_1709_;
                                                        let _e1193 = phi_1710_;
                                                        phi_1718_ = _e1189;
                                                        phi_1719_ = select(_e1193, true, _e1191);
                                                    } else {
                                                        phi_1718_ = type_22();
                                                        phi_1719_ = true;
                                                    }
                                                    let _e1196 = phi_1718_;
                                                    let _e1198 = phi_1719_;
                                                    if _e1198 {
                                                        phi_1723_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1723_ = _e1196;
                                                    }
                                                    let _e1200 = phi_1723_;
                                                    if (_e1200.member_3 != 4294967295u) {
                                                        if (_e667 != _e390) {
                                                            if (_e1200.member < _e632.member.member.member) {
                                                                phi_1749_ = true;
                                                            } else {
                                                                if (_e1200.member == _e632.member.member.member) {
                                                                    phi_1748_ = (_e1200.member_3 < _e632.member.member.member_3);
                                                                } else {
                                                                    phi_1748_ = false;
                                                                }
                                                                let _e1215 = phi_1748_;
                                                                phi_1749_ = _e1215;
                                                            }
                                                            let _e1217 = phi_1749_;
                                                            if _e1217 {
                                                                phi_1756_ = type_48(type_42(_e1200, _e1200.member), _e659.member_1, _e659.member_2);
                                                            } else {
                                                                phi_1756_ = _e659;
                                                            }
                                                            let _e1224 = phi_1756_;
                                                            phi_1757_ = _e1224;
                                                        } else {
                                                            phi_1757_ = _e659;
                                                        }
                                                        let _e1226 = phi_1757_;
                                                        phi_1758_ = _e1226;
                                                    } else {
                                                        phi_1758_ = _e659;
                                                    }
                                                    let _e1228 = phi_1758_;
                                                    phi_742_ = _e1228;
                                                } else {
                                                    phi_742_ = type_48();
                                                }
                                                let _e1230 = phi_742_;
                                                continue;
                                                continuing {
                                                    phi_741_ = _e1230;
                                                    phi_744_ = _e647;
                                                    phi_2416_ = _e397;
                                                    break if !(_e653);
                                                }
                                            }
                                            let _e1233 = phi_2416_;
                                            phi_2558_ = _e1233;
                                            if _e1233 {
                                                break;
                                            }
                                            phi_2562_ = _e1233;
                                            let _e1460 = local_4;
                                            phi_2216_ = _e1460;
                                            phi_2217_ = _e423;
                                            phi_2218_ = false;
                                            phi_2219_ = _e427;
                                        } else {
                                            if (_e423 >= _e68) {
                                                phi_1821_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e423 < _e68) {
                                                } else {
                                                    phi_2558_ = true;
                                                    break;
                                                }
                                                let _e443 = (_e206 % 3u);
                                                if (_e443 < 3u) {
                                                } else {
                                                    phi_2558_ = true;
                                                    break;
                                                }
                                                let _e449 = global_2.member[_e423].member[_e443];
                                                let _e455 = (_e205 % 3u);
                                                if (_e455 < 3u) {
                                                } else {
                                                    phi_2558_ = true;
                                                    break;
                                                }
                                                let _e461 = global_2.member[_e423].member[_e455];
                                                let _e467 = (_e207 % 3u);
                                                if (_e467 < 3u) {
                                                } else {
                                                    phi_2558_ = true;
                                                    break;
                                                }
                                                let _e473 = global_2.member[_e423].member[_e467];
                                                let _e483 = global_2.member[_e423].member_1;
                                                let _e487 = global_2.member[_e423].member_2;
                                                phi_1821_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e449[0], _e449[1], _e449[2], _e449[3]), vec4<f32>(_e461[0], _e461[1], _e461[2], _e461[3]), vec4<f32>(_e473[0], _e473[1], _e473[2], _e473[3])), _e483, _e487);
                                            }
                                            let _e490 = phi_1821_;
                                            let _e503 = ((_e490.member[0].x - _e261) * _e266);
                                            let _e504 = ((_e490.member[0].y - _e261) * _e266);
                                            let _e505 = ((_e490.member[0].z - _e262) * _e266);
                                            let _e506 = ((_e490.member[0].w - _e262) * _e266);
                                            let _e516 = ((_e490.member[1].x - _e297) * _e302);
                                            let _e517 = ((_e490.member[1].y - _e297) * _e302);
                                            let _e518 = ((_e490.member[1].z - _e298) * _e302);
                                            let _e519 = ((_e490.member[1].w - _e298) * _e302);
                                            let _e529 = ((_e490.member[2].x - _e333) * _e338);
                                            let _e530 = ((_e490.member[2].y - _e333) * _e338);
                                            let _e531 = ((_e490.member[2].z - _e334) * _e338);
                                            let _e532 = ((_e490.member[2].w - _e334) * _e338);
                                            let _e534 = select(_e531, _e529, (_e529 < _e531));
                                            let _e536 = select(_e532, _e530, (_e530 < _e532));
                                            let _e538 = select(_e531, _e529, (_e529 > _e531));
                                            let _e540 = select(_e532, _e530, (_e530 > _e532));
                                            let _e542 = select(_e505, _e503, (_e503 < _e505));
                                            let _e544 = select(_e506, _e504, (_e504 < _e506));
                                            let _e546 = select(_e518, _e516, (_e516 < _e518));
                                            let _e548 = select(_e519, _e517, (_e517 < _e519));
                                            let _e550 = select(_e546, _e542, (_e542 > _e546));
                                            let _e552 = select(_e548, _e544, (_e544 > _e548));
                                            let _e554 = select(_e534, _e550, (_e550 > _e534));
                                            let _e556 = select(_e536, _e552, (_e552 > _e536));
                                            let _e558 = select(_e505, _e503, (_e503 > _e505));
                                            let _e560 = select(_e506, _e504, (_e504 > _e506));
                                            let _e562 = select(_e518, _e516, (_e516 > _e518));
                                            let _e564 = select(_e519, _e517, (_e517 > _e519));
                                            let _e566 = select(_e562, _e558, (_e558 < _e562));
                                            let _e568 = select(_e564, _e560, (_e560 < _e564));
                                            let _e573 = -(_e534);
                                            let _e574 = -(_e536);
                                            let _e581 = (select(_e538, _e566, (_e566 < _e538)) + (select(_e573, _e538, (_e538 > _e573)) * 0.0000019073523f));
                                            let _e582 = (select(_e540, _e568, (_e568 < _e540)) + (select(_e574, _e540, (_e540 > _e574)) * 0.0000019073523f));
                                            let _e584 = select(_e384, _e554, (_e554 > _e384));
                                            let _e586 = select(_e384, _e556, (_e556 > _e384));
                                            let _e591 = (_e584 <= select(_e399.member.member_1, _e581, (_e581 < _e399.member.member_1)));
                                            let _e592 = (_e586 <= select(_e399.member.member_1, _e582, (_e582 < _e399.member.member_1)));
                                            let _e593 = (_e584 <= _e586);
                                            if _e591 {
                                                if _e592 {
                                                    if _e593 {
                                                        phi_2165_ = _e490.member_2;
                                                    } else {
                                                        phi_2165_ = _e490.member_1;
                                                    }
                                                    let _e597 = phi_2165_;
                                                    let _e600 = (_e427 % 128u);
                                                    let _e601 = (_e600 < 128u);
                                                    if _e601 {
                                                    } else {
                                                        phi_2558_ = true;
                                                        break;
                                                    }
                                                    local_1[_e600] = _e597;
                                                    if _e601 {
                                                    } else {
                                                        phi_2558_ = true;
                                                        break;
                                                    }
                                                    local[_e600] = select(_e586, _e584, (_e584 > _e586));
                                                    if _e593 {
                                                        phi_2193_ = _e490.member_1;
                                                    } else {
                                                        phi_2193_ = _e490.member_2;
                                                    }
                                                    let _e608 = phi_2193_;
                                                    phi_2194_ = _e608;
                                                    phi_2195_ = (_e427 + 1u);
                                                } else {
                                                    phi_2194_ = u32();
                                                    phi_2195_ = u32();
                                                }
                                                let _e610 = phi_2194_;
                                                let _e612 = phi_2195_;
                                                phi_2197_ = _e610;
                                                phi_2198_ = _e612;
                                                phi_2199_ = select(true, false, _e592);
                                            } else {
                                                phi_2197_ = u32();
                                                phi_2198_ = u32();
                                                phi_2199_ = true;
                                            }
                                            let _e615 = phi_2197_;
                                            let _e617 = phi_2198_;
                                            let _e619 = phi_2199_;
                                            if _e619 {
                                                if _e591 {
                                                    phi_2208_ = _e490.member_1;
                                                } else {
                                                    phi_2208_ = _e490.member_2;
                                                }
                                                let _e623 = phi_2208_;
                                                phi_2213_ = _e623;
                                                phi_2214_ = select(_e592, true, _e591);
                                            } else {
                                                phi_2213_ = _e615;
                                                phi_2214_ = _e425;
                                            }
                                            let _e626 = phi_2213_;
                                            let _e628 = phi_2214_;
                                            phi_2562_ = _e397;
                                            phi_2216_ = type_48(_e399.member, (_e399.member_1 + 1u), _e399.member_2);
                                            phi_2217_ = _e626;
                                            phi_2218_ = _e628;
                                            phi_2219_ = select(_e617, _e427, _e619);
                                        }
                                        let _e1235 = phi_2562_;
                                        let _e1237 = phi_2216_;
                                        let _e1239 = phi_2217_;
                                        let _e1241 = phi_2218_;
                                        let _e1243 = phi_2219_;
                                        phi_2561_ = _e1235;
                                        phi_2220_ = _e1237;
                                        phi_2221_ = _e1239;
                                        phi_2222_ = (_e403 - 1u);
                                        phi_2223_ = _e1241;
                                        phi_2224_ = _e1243;
                                    } else {
                                        phi_2561_ = _e397;
                                        phi_2220_ = _e399;
                                        phi_2221_ = _e423;
                                        phi_2222_ = _e403;
                                        phi_2223_ = _e425;
                                        phi_2224_ = _e427;
                                    }
                                    let _e1245 = phi_2561_;
                                    let _e1247 = phi_2220_;
                                    let _e1249 = phi_2221_;
                                    let _e1251 = phi_2222_;
                                    let _e1253 = phi_2223_;
                                    let _e1255 = phi_2224_;
                                    phi_2560_ = _e1245;
                                    phi_2225_ = _e1247;
                                    phi_2226_ = _e1249;
                                    phi_2227_ = _e1251;
                                    phi_2228_ = _e1253;
                                    phi_2229_ = _e1255;
                                } else {
                                    phi_2560_ = _e397;
                                    phi_2225_ = type_48();
                                    phi_2226_ = u32();
                                    phi_2227_ = u32();
                                    phi_2228_ = bool();
                                    phi_2229_ = u32();
                                }
                                let _e1257 = phi_2560_;
                                let _e1259 = phi_2225_;
                                let _e1261 = phi_2226_;
                                let _e1263 = phi_2227_;
                                let _e1265 = phi_2228_;
                                let _e1267 = phi_2229_;
                                phi_2559_ = _e1257;
                                phi_673_ = _e1259;
                                phi_676_ = _e1261;
                                phi_678_ = _e1263;
                                phi_680_ = _e1265;
                                phi_682_ = _e1267;
                                phi_2230_ = _e411;
                            } else {
                                phi_2559_ = _e397;
                                phi_673_ = type_48();
                                phi_676_ = u32();
                                phi_678_ = u32();
                                phi_680_ = bool();
                                phi_682_ = u32();
                                phi_2230_ = false;
                            }
                            let _e1269 = phi_2559_;
                            let _e1271 = phi_673_;
                            let _e1273 = phi_676_;
                            let _e1275 = phi_678_;
                            let _e1277 = phi_680_;
                            let _e1279 = phi_682_;
                            let _e1281 = phi_2230_;
                            continue;
                            continuing {
                                phi_2422_ = _e1269;
                                phi_672_ = _e1271;
                                phi_675_ = _e1273;
                                phi_677_ = _e1275;
                                phi_679_ = _e1277;
                                phi_681_ = _e1279;
                                phi_2558_ = _e1269;
                                break if !(_e1281);
                            }
                        }
                        let _e1284 = phi_2558_;
                        if _e1284 {
                            break;
                        }
                        let _e1286 = local_2;
                        if (_e1286.member.member.member_3 != 4294967295u) {
                            let _e1292 = (_e208 / 3i);
                            let _e1299 = bitcast<f32>((bitcast<u32>((_e1292 + 127i)) << bitcast<u32>(23i)));
                            let _e1307 = (((_e1286.member.member.member * _e1299) * _e1299) * bitcast<f32>((bitcast<u32>(((_e208 - (2i * _e1292)) + 127i)) << bitcast<u32>(23i))));
                            let _e1309 = select(340282350000000000000000000000000000000f, _e1307, (_e1307 < 340282350000000000000000000000000000000f));
                            phi_2282_ = type_22(select(-340282350000000000000000000000000000000f, _e1309, (_e1309 > -340282350000000000000000000000000000000f)), _e1286.member.member.member_1, _e1286.member.member.member_2, _e1286.member.member.member_3);
                        } else {
                            phi_2282_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1316 = phi_2282_;
                        if _e84 {
                        } else {
                            break;
                        }
                        global_4.member[_e82] = _e1316;
                        let _e1320 = local_3;
                        if _e85 {
                        } else {
                            break;
                        }
                        global_5.member[_e82] = _e1320.member_1;
                        if _e83 {
                        } else {
                            break;
                        }
                        let _e1325 = select(0u, 1u, (_e152 <= _e162));
                        if (_e1325 > 0u) {
                            let _e1327 = (1u < _e78);
                            if _e1327 {
                                if (0u < _e78) {
                                } else {
                                    break;
                                }
                                let _e1331 = atomicAdd((&global_6.member[0u]), _e1325);
                                if ((_e1331 + _e1325) < _e1331) {
                                    if _e1327 {
                                    } else {
                                        break;
                                    }
                                    let _e1336 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1339 = select(0u, 1u, (_e1316.member_3 != 4294967295u));
                        if (_e1339 > 0u) {
                            let _e1341 = (3u < _e78);
                            if _e1341 {
                                if (2u < _e78) {
                                } else {
                                    break;
                                }
                                let _e1345 = atomicAdd((&global_6.member[2u]), _e1339);
                                if ((_e1345 + _e1339) < _e1345) {
                                    if _e1341 {
                                    } else {
                                        break;
                                    }
                                    let _e1350 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1320.member_1 > 0u) {
                            let _e1352 = (5u < _e78);
                            if _e1352 {
                                if (4u < _e78) {
                                } else {
                                    break;
                                }
                                let _e1356 = atomicAdd((&global_6.member[4u]), _e1320.member_1);
                                if ((_e1356 + _e1320.member_1) < _e1356) {
                                    if _e1352 {
                                    } else {
                                        break;
                                    }
                                    let _e1361 = atomicAdd((&global_6.member[5u]), 1u);
                                }
                            }
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_paths_counted(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
