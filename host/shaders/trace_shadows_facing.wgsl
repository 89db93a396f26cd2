struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_30 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_37 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_39 {
    member: array<type_37>,
}

struct type_42 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_44 {
    member: array<type_42>,
}

struct type_47 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_55 {
    member: f32,
    member_1: bool,
}

struct type_57 {
    member: array<vec4<u32>, 2>,
}

struct type_60 {
    member: array<i32>,
}

struct type_67 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_20;
@group(0) @binding(1) 
var<uniform> global_3: type_57;
@group(0) @binding(2) 
var<storage> global_4: type_39;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage> global_6: type_60;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_67;
@group(0) @binding(6) 
var<storage> global_8: type_44;
@group(0) @binding(7) 
var<storage, read_write> global_9: type_32;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_218_: u32;
    var phi_262_: i32;
    var phi_286_: type_47;
    var phi_436_: i32;
    var phi_437_: i32;
    var phi_447_: bool;
    var phi_457_: u32;
    var phi_458_: u32;
    var phi_460_: bool;
    var phi_465_: u32;
    var phi_497_: i32;
    var phi_515_: f32;
    var phi_521_: f32;
    var phi_532_: f32;
    var phi_538_: f32;
    var phi_561_: f32;
    var phi_572_: f32;
    var phi_581_: f32;
    var phi_587_: f32;
    var phi_598_: f32;
    var phi_604_: f32;
    var phi_627_: f32;
    var phi_638_: f32;
    var phi_647_: f32;
    var phi_653_: f32;
    var phi_664_: f32;
    var phi_670_: f32;
    var phi_693_: f32;
    var phi_704_: f32;
    var phi_804_: f32;
    var phi_805_: f32;
    var phi_2475_: bool;
    var phi_816_: type_55;
    var phi_819_: u32;
    var phi_821_: u32;
    var phi_823_: bool;
    var phi_825_: u32;
    var phi_836_: bool;
    var phi_868_: u32;
    var phi_869_: bool;
    var phi_870_: u32;
    var phi_1993_: type_54;
    var phi_2337_: u32;
    var phi_2365_: u32;
    var phi_2366_: u32;
    var phi_2367_: u32;
    var phi_2369_: u32;
    var phi_2370_: u32;
    var phi_2371_: bool;
    var phi_2380_: u32;
    var phi_2385_: u32;
    var phi_2386_: bool;
    var phi_885_: type_55;
    var phi_888_: type_8;
    var phi_889_: type_8;
    var phi_911_: type_8;
    var phi_932_: u32;
    var phi_1021_: array<array<f32, 3>, 3>;
    var phi_1492_: vec3<f32>;
    var phi_1493_: vec3<f32>;
    var phi_1524_: bool;
    var phi_1533_: vec3<f32>;
    var phi_1573_: type_28;
    var phi_1575_: type_28;
    var phi_1576_: bool;
    var phi_1580_: type_28;
    var phi_1581_: type_28;
    var phi_1582_: type_28;
    var phi_1583_: bool;
    var phi_1587_: type_28;
    var phi_1588_: bool;
    var phi_1592_: type_28;
    var phi_1593_: bool;
    var phi_1597_: type_28;
    var phi_1620_: u32;
    var phi_1634_: i32;
    var phi_1654_: vec3<f32>;
    var phi_1655_: vec3<f32>;
    var phi_1671_: vec3<f32>;
    var phi_1672_: vec3<f32>;
    var phi_1688_: vec3<f32>;
    var phi_1689_: vec3<f32>;
    var phi_1725_: vec3<f32>;
    var phi_1907_: f32;
    var phi_1925_: bool;
    var phi_1926_: bool;
    var phi_1931_: type_55;
    var phi_1932_: type_55;
    var phi_886_: type_55;
    var phi_2469_: bool;
    var local_2: type_55;
    var phi_2611_: bool;
    var phi_2388_: type_55;
    var phi_2389_: u32;
    var phi_2390_: bool;
    var phi_2391_: u32;
    var phi_2610_: bool;
    var phi_2392_: type_55;
    var phi_2393_: u32;
    var phi_2394_: u32;
    var phi_2395_: bool;
    var phi_2396_: u32;
    var phi_2609_: bool;
    var phi_2397_: type_55;
    var phi_2398_: u32;
    var phi_2399_: u32;
    var phi_2400_: bool;
    var phi_2401_: u32;
    var phi_2608_: bool;
    var phi_817_: type_55;
    var phi_820_: u32;
    var phi_822_: u32;
    var phi_824_: bool;
    var phi_826_: u32;
    var phi_2402_: bool;
    var phi_2607_: bool;
    var local_3: type_55;
    var local_4: type_55;

    switch bitcast<i32>(0u) {
        default: {
            let _e73 = global;
            let _e75 = arrayLength((&global_4.member));
            let _e77 = arrayLength((&global_2.member));
            let _e89 = arrayLength((&global_7.member));
            let _e93 = (_e73.x + (_e73.y * 2097152u));
            let _e94 = (_e93 < arrayLength((&global_8.member)));
            if _e94 {
                if _e94 {
                } else {
                    break;
                }
                let _e98 = global_8.member[_e93].member_2;
                phi_218_ = _e98;
            } else {
                phi_218_ = 4294967295u;
            }
            let _e100 = phi_218_;
            let _e103 = global_1.member[0u];
            let _e107 = global_3.member[0u][0u];
            let _e111 = global_3.member[0u][1u];
            let _e115 = global_3.member[0u][2u];
            let _e119 = global_3.member[0u][3u];
            let _e123 = global_3.member[1u][0u];
            let _e127 = global_3.member[1u][1u];
            let _e131 = global_3.member[1u][2u];
            let _e135 = global_3.member[1u][3u];
            let _e136 = bitcast<f32>(_e107);
            let _e137 = bitcast<f32>(_e111);
            let _e138 = bitcast<f32>(_e115);
            let _e140 = bitcast<f32>(_e123);
            let _e141 = array<u32, 3>(_e127, _e131, _e135);
            let _e143 = bitcast<i32>(_e103);
            if (_e143 < -126i) {
                phi_262_ = -126i;
            } else {
                phi_262_ = select(_e143, 127i, (_e143 > 127i));
            }
            let _e148 = phi_262_;
            let _e153 = bitcast<f32>((bitcast<u32>((_e148 + 127i)) << bitcast<u32>(23i)));
            let _e159 = bitcast<f32>((bitcast<u32>(((_e143 - _e148) + 127i)) << bitcast<u32>(23i)));
            if (_e119 == 0u) {
                phi_286_ = type_47(array<f32, 3>(_e136, _e137, _e138), _e119, _e140, _e141);
            } else {
                phi_286_ = type_47(array<f32, 3>(((_e136 * _e153) * _e159), ((_e137 * _e153) * _e159), ((_e138 * _e153) * _e159)), _e119, ((_e140 * _e153) * _e159), _e141);
            }
            let _e172 = phi_286_;
            if _e94 {
                let _e173 = (_e93 < arrayLength((&global_9.member)));
                if _e173 {
                    if _e94 {
                    } else {
                        break;
                    }
                    let _e178 = global_8.member[_e93].member.member_1;
                    let _e183 = global_8.member[_e93].member.member_3;
                    if (_e178 <= _e183) {
                        let _e185 = (1u < _e89);
                        if _e185 {
                            if (0u < _e89) {
                            } else {
                                break;
                            }
                            let _e189 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e189 + 1u) < _e189) {
                                if _e185 {
                                } else {
                                    break;
                                }
                                let _e194 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e94 {
                        } else {
                            break;
                        }
                        let _e204 = global_8.member[_e93].member.member_2[0u];
                        let _e206 = (bitcast<u32>(_e204) & 2147483647u);
                        let _e212 = global_8.member[_e93].member.member_2[1u];
                        let _e214 = (bitcast<u32>(_e212) & 2147483647u);
                        let _e220 = global_8.member[_e93].member.member_2[2u];
                        let _e222 = (bitcast<u32>(_e220) & 2147483647u);
                        let _e228 = global_8.member[_e93].member.member[0u];
                        let _e230 = (bitcast<u32>(_e228) & 2147483647u);
                        let _e236 = global_8.member[_e93].member.member[1u];
                        let _e238 = (bitcast<u32>(_e236) & 2147483647u);
                        let _e244 = global_8.member[_e93].member.member[2u];
                        let _e246 = (bitcast<u32>(_e244) & 2147483647u);
                        let _e248 = select(_e214, _e206, (_e214 < _e206));
                        let _e250 = select(_e222, _e248, (_e222 < _e248));
                        let _e252 = select(_e230, _e250, (_e230 < _e250));
                        let _e254 = select(_e238, _e252, (_e238 < _e252));
                        let _e256 = select(_e246, _e254, (_e246 < _e254));
                        let _e258 = (bitcast<u32>(_e178) & 2147483647u);
                        let _e267 = (((select(_e258, _e256, (_e258 < _e256)) < 2139095040u) && ((bitcast<u32>(_e183) & 2147483647u) <= 2139095040u)) && (_e250 > 0u));
                        if _e267 {
                            let _e270 = (bitcast<u32>(bitcast<f32>(_e250)) & 2147483647u);
                            if (_e270 >= 8388608u) {
                                phi_436_ = (bitcast<i32>((_e270 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_436_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e270)), 32u, (_e270 == 0u))));
                            }
                            let _e284 = phi_436_;
                            phi_437_ = _e284;
                        } else {
                            phi_437_ = 0i;
                        }
                        let _e286 = phi_437_;
                        let _e287 = (_e206 == _e250);
                        if _e287 {
                            phi_447_ = true;
                        } else {
                            phi_447_ = (_e214 == _e250);
                        }
                        let _e290 = phi_447_;
                        let _e291 = select(1u, 0u, _e287);
                        if _e290 {
                            let _e292 = (_e291 + 1u);
                            phi_457_ = _e292;
                            phi_458_ = _e292;
                            phi_460_ = select(true, false, (_e292 == 2u));
                        } else {
                            phi_457_ = u32();
                            phi_458_ = 0u;
                            phi_460_ = true;
                        }
                        let _e296 = phi_457_;
                        let _e298 = phi_458_;
                        let _e300 = phi_460_;
                        if _e300 {
                            phi_465_ = (_e298 + 1u);
                        } else {
                            phi_465_ = 0u;
                        }
                        let _e304 = phi_465_;
                        let _e305 = select(_e296, _e298, _e300);
                        let _e306 = select(_e291, select(2u, _e291, _e290), _e300);
                        let _e307 = -(_e286);
                        if (_e307 < -126i) {
                            phi_497_ = -126i;
                        } else {
                            phi_497_ = select(_e307, 127i, (_e307 > 127i));
                        }
                        let _e312 = phi_497_;
                        let _e317 = bitcast<f32>((bitcast<u32>((_e312 + 127i)) << bitcast<u32>(23i)));
                        let _e323 = bitcast<f32>((bitcast<u32>(((_e307 - _e312) + 127i)) << bitcast<u32>(23i)));
                        let _e328 = global_8.member[_e93].member.member;
                        let _e329 = (_e305 == 0u);
                        if _e329 {
                            phi_515_ = _e328[0];
                        } else {
                            phi_515_ = _e328[1];
                        }
                        let _e333 = phi_515_;
                        let _e334 = (_e305 == 2u);
                        if _e334 {
                            phi_521_ = _e328[2];
                        } else {
                            phi_521_ = _e333;
                        }
                        let _e337 = phi_521_;
                        let _e338 = global_8.member[_e93].member.member_2;
                        if _e329 {
                            phi_532_ = _e338[0];
                        } else {
                            phi_532_ = _e338[1];
                        }
                        let _e342 = phi_532_;
                        if _e334 {
                            phi_538_ = _e338[2];
                        } else {
                            phi_538_ = _e342;
                        }
                        let _e345 = phi_538_;
                        let _e347 = ((_e345 * _e317) * _e323);
                        let _e351 = (bitcast<f32>((bitcast<u32>(_e347) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e351 {
                            let _e355 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) * 0.00000011920929f);
                            phi_561_ = select(0.00000000000011368684f, _e355, (_e355 > 0.00000000000011368684f));
                        } else {
                            phi_561_ = 0f;
                        }
                        let _e359 = phi_561_;
                        let _e360 = (_e337 + _e359);
                        let _e361 = (_e337 - _e359);
                        let _e362 = select(_e347, 0f, _e351);
                        if _e351 {
                            phi_572_ = 38685626000000000000000000f;
                        } else {
                            phi_572_ = (1f / _e347);
                        }
                        let _e365 = phi_572_;
                        let _e366 = (_e304 == 0u);
                        if _e366 {
                            phi_581_ = _e328[0];
                        } else {
                            phi_581_ = _e328[1];
                        }
                        let _e370 = phi_581_;
                        let _e371 = (_e304 == 2u);
                        if _e371 {
                            phi_587_ = _e328[2];
                        } else {
                            phi_587_ = _e370;
                        }
                        let _e374 = phi_587_;
                        if _e366 {
                            phi_598_ = _e338[0];
                        } else {
                            phi_598_ = _e338[1];
                        }
                        let _e378 = phi_598_;
                        if _e371 {
                            phi_604_ = _e338[2];
                        } else {
                            phi_604_ = _e378;
                        }
                        let _e381 = phi_604_;
                        let _e383 = ((_e381 * _e317) * _e323);
                        let _e387 = (bitcast<f32>((bitcast<u32>(_e383) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e387 {
                            let _e391 = (bitcast<f32>((bitcast<u32>(_e374) & 2147483647u)) * 0.00000011920929f);
                            phi_627_ = select(0.00000000000011368684f, _e391, (_e391 > 0.00000000000011368684f));
                        } else {
                            phi_627_ = 0f;
                        }
                        let _e395 = phi_627_;
                        let _e396 = (_e374 + _e395);
                        let _e397 = (_e374 - _e395);
                        let _e398 = select(_e383, 0f, _e387);
                        if _e387 {
                            phi_638_ = 38685626000000000000000000f;
                        } else {
                            phi_638_ = (1f / _e383);
                        }
                        let _e401 = phi_638_;
                        let _e402 = (_e306 == 0u);
                        if _e402 {
                            phi_647_ = _e328[0];
                        } else {
                            phi_647_ = _e328[1];
                        }
                        let _e406 = phi_647_;
                        let _e407 = (_e306 == 2u);
                        if _e407 {
                            phi_653_ = _e328[2];
                        } else {
                            phi_653_ = _e406;
                        }
                        let _e410 = phi_653_;
                        if _e402 {
                            phi_664_ = _e338[0];
                        } else {
                            phi_664_ = _e338[1];
                        }
                        let _e414 = phi_664_;
                        if _e407 {
                            phi_670_ = _e338[2];
                        } else {
                            phi_670_ = _e414;
                        }
                        let _e417 = phi_670_;
                        let _e419 = ((_e417 * _e317) * _e323);
                        let _e423 = (bitcast<f32>((bitcast<u32>(_e419) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e423 {
                            let _e427 = (bitcast<f32>((bitcast<u32>(_e410) & 2147483647u)) * 0.00000011920929f);
                            phi_693_ = select(0.00000000000011368684f, _e427, (_e427 > 0.00000000000011368684f));
                        } else {
                            phi_693_ = 0f;
                        }
                        let _e431 = phi_693_;
                        let _e432 = (_e410 + _e431);
                        let _e433 = (_e410 - _e431);
                        let _e434 = select(_e419, 0f, _e423);
                        if _e423 {
                            phi_704_ = 38685626000000000000000000f;
                        } else {
                            phi_704_ = (1f / _e419);
                        }
                        let _e437 = phi_704_;
                        let _e440 = bitcast<f32>((bitcast<u32>(_e337) & 2147483647u));
                        let _e443 = bitcast<f32>((bitcast<u32>(_e374) & 2147483647u));
                        let _e445 = select(_e443, _e440, (_e440 > _e443));
                        let _e448 = bitcast<f32>((bitcast<u32>(_e410) & 2147483647u));
                        if (_e267 && (select(_e448, _e445, (_e445 > _e448)) <= 1099511600000f)) {
                            let _e453 = (_e286 / 3i);
                            let _e460 = bitcast<f32>((bitcast<u32>((_e453 + 127i)) << bitcast<u32>(23i)));
                            let _e467 = bitcast<f32>((bitcast<u32>(((_e286 - (2i * _e453)) + 127i)) << bitcast<u32>(23i)));
                            let _e468 = (((_e178 * _e460) * _e460) * _e467);
                            let _e470 = select(340282350000000000000000000000000000000f, _e468, (_e468 < 340282350000000000000000000000000000000f));
                            let _e475 = (((_e183 * _e460) * _e460) * _e467);
                            let _e477 = select(340282350000000000000000000000000000000f, _e475, (_e475 < 340282350000000000000000000000000000000f));
                            phi_804_ = select(-340282350000000000000000000000000000000f, _e477, (_e477 > -340282350000000000000000000000000000000f));
                            phi_805_ = select(-340282350000000000000000000000000000000f, _e470, (_e470 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_804_ = 0f;
                            phi_805_ = 1f;
                        }
                        let _e481 = phi_804_;
                        let _e483 = phi_805_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2475_ = false;
                        phi_816_ = type_55(_e481, false);
                        phi_819_ = select(0u, 2147483648u, (_e75 == 0u));
                        phi_821_ = ((3u * _e75) + 1u);
                        phi_823_ = (_e483 <= _e481);
                        phi_825_ = 0u;
                        loop {
                            let _e491 = phi_2475_;
                            let _e493 = phi_816_;
                            let _e495 = phi_819_;
                            let _e497 = phi_821_;
                            let _e499 = phi_823_;
                            let _e501 = phi_825_;
                            local_3 = _e493;
                            if _e499 {
                                phi_836_ = true;
                            } else {
                                phi_836_ = (_e501 > 0u);
                            }
                            let _e504 = phi_836_;
                            if _e504 {
                                let _e505 = (_e497 > 0u);
                                if _e505 {
                                    if _e499 {
                                        phi_868_ = _e495;
                                        phi_869_ = _e499;
                                        phi_870_ = _e501;
                                    } else {
                                        let _e506 = (_e501 - 1u);
                                        let _e507 = (_e506 % 128u);
                                        let _e508 = (_e507 < 128u);
                                        if _e508 {
                                        } else {
                                            phi_2607_ = true;
                                            break;
                                        }
                                        let _e510 = local_1[_e507];
                                        if _e508 {
                                        } else {
                                            phi_2607_ = true;
                                            break;
                                        }
                                        let _e512 = local[_e507];
                                        phi_868_ = _e510;
                                        phi_869_ = (_e512 <= _e493.member);
                                        phi_870_ = _e506;
                                    }
                                    let _e516 = phi_868_;
                                    let _e518 = phi_869_;
                                    let _e520 = phi_870_;
                                    if _e518 {
                                        if ((_e516 & 2147483648u) != 0u) {
                                            phi_885_ = _e493;
                                            phi_888_ = type_8(0u, ((_e516 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e718 = phi_885_;
                                                let _e720 = phi_888_;
                                                local_2 = _e718;
                                                local_4 = _e718;
                                                if (_e720.member < _e720.member_1) {
                                                    phi_889_ = type_8((_e720.member + 1u), _e720.member_1);
                                                    phi_911_ = type_8(1u, _e720.member);
                                                } else {
                                                    phi_889_ = _e720;
                                                    phi_911_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e733 = phi_889_;
                                                let _e735 = phi_911_;
                                                let _e739 = (bitcast<i32>(_e735.member) != 0i);
                                                if _e739 {
                                                    let _e740 = ((_e516 & 268435455u) + _e735.member_1);
                                                    let _e741 = (_e740 < _e77);
                                                    if _e741 {
                                                        if _e741 {
                                                        } else {
                                                            phi_2469_ = true;
                                                            break;
                                                        }
                                                        let _e745 = global_2.member[_e740].member_1;
                                                        phi_932_ = _e745;
                                                    } else {
                                                        phi_932_ = 4294967295u;
                                                    }
                                                    let _e747 = phi_932_;
                                                    if (_e740 >= _e77) {
                                                        phi_1021_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e741 {
                                                        } else {
                                                            phi_2469_ = true;
                                                            break;
                                                        }
                                                        let _e749 = (_e305 % 3u);
                                                        let _e750 = (_e304 % 3u);
                                                        let _e751 = (_e306 % 3u);
                                                        if (_e749 < 9u) {
                                                        } else {
                                                            phi_2469_ = true;
                                                            break;
                                                        }
                                                        let _e757 = global_2.member[_e740].member[_e749];
                                                        if (_e750 < 9u) {
                                                        } else {
                                                            phi_2469_ = true;
                                                            break;
                                                        }
                                                        let _e763 = global_2.member[_e740].member[_e750];
                                                        if (_e751 < 9u) {
                                                        } else {
                                                            phi_2469_ = true;
                                                            break;
                                                        }
                                                        let _e769 = global_2.member[_e740].member[_e751];
                                                        let _e771 = (3u + _e749);
                                                        if (_e771 < 9u) {
                                                        } else {
                                                            phi_2469_ = true;
                                                            break;
                                                        }
                                                        let _e777 = global_2.member[_e740].member[_e771];
                                                        let _e778 = (3u + _e750);
                                                        if (_e778 < 9u) {
                                                        } else {
                                                            phi_2469_ = true;
                                                            break;
                                                        }
                                                        let _e784 = global_2.member[_e740].member[_e778];
                                                        let _e785 = (3u + _e751);
                                                        if (_e785 < 9u) {
                                                        } else {
                                                            phi_2469_ = true;
                                                            break;
                                                        }
                                                        let _e791 = global_2.member[_e740].member[_e785];
                                                        let _e793 = (6u + _e749);
                                                        if (_e793 < 9u) {
                                                        } else {
                                                            phi_2469_ = true;
                                                            break;
                                                        }
                                                        let _e799 = global_2.member[_e740].member[_e793];
                                                        let _e800 = (6u + _e750);
                                                        if (_e800 < 9u) {
                                                        } else {
                                                            phi_2469_ = true;
                                                            break;
                                                        }
                                                        let _e806 = global_2.member[_e740].member[_e800];
                                                        let _e807 = (6u + _e751);
                                                        if (_e807 < 9u) {
                                                        } else {
                                                            phi_2469_ = true;
                                                            break;
                                                        }
                                                        let _e813 = global_2.member[_e740].member[_e807];
                                                        phi_1021_ = array<array<f32, 3>, 3>(array<f32, 3>(_e757, _e763, _e769), array<f32, 3>(_e777, _e784, _e791), array<f32, 3>(_e799, _e806, _e813));
                                                    }
                                                    let _e817 = phi_1021_;
                                                    let _e825 = (_e817[0][2] - _e410);
                                                    let _e828 = (((_e817[0][0] - _e337) * _e434) - (_e825 * _e362));
                                                    let _e831 = (((_e817[0][1] - _e374) * _e434) - (_e825 * _e398));
                                                    let _e838 = (_e817[1][2] - _e410);
                                                    let _e841 = (((_e817[1][0] - _e337) * _e434) - (_e838 * _e362));
                                                    let _e844 = (((_e817[1][1] - _e374) * _e434) - (_e838 * _e398));
                                                    let _e851 = (_e817[2][2] - _e410);
                                                    let _e854 = (((_e817[2][0] - _e337) * _e434) - (_e851 * _e362));
                                                    let _e857 = (((_e817[2][1] - _e374) * _e434) - (_e851 * _e398));
                                                    let _e858 = (_e854 * _e844);
                                                    let _e859 = (_e857 * _e841);
                                                    let _e860 = (_e828 * _e857);
                                                    let _e861 = (_e831 * _e854);
                                                    let _e862 = (_e841 * _e831);
                                                    let _e863 = (_e844 * _e828);
                                                    let _e868 = (((_e858 >= _e859) && (_e860 >= _e861)) && (_e862 >= _e863));
                                                    if (_e868 || (((_e858 <= _e859) && (_e860 <= _e861)) && (_e862 <= _e863))) {
                                                        let _e875 = select(-1f, 1f, _e868);
                                                        let _e877 = ((_e858 - _e859) * _e875);
                                                        let _e879 = select(0f, _e877, (_e877 > 0f));
                                                        let _e881 = ((_e860 - _e861) * _e875);
                                                        let _e883 = select(0f, _e881, (_e881 > 0f));
                                                        let _e885 = ((_e862 - _e863) * _e875);
                                                        let _e887 = select(0f, _e885, (_e885 > 0f));
                                                        let _e889 = ((_e879 + _e883) + _e887);
                                                        if (_e889 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1587_ = type_28();
                                                            phi_1588_ = true;
                                                        } else {
                                                            let _e892 = select(_e817[1][0], _e817[0][0], (_e817[0][0] < _e817[1][0]));
                                                            let _e896 = select(_e817[1][0], _e817[0][0], (_e817[0][0] > _e817[1][0]));
                                                            let _e900 = select(_e817[1][1], _e817[0][1], (_e817[0][1] < _e817[1][1]));
                                                            let _e904 = select(_e817[1][1], _e817[0][1], (_e817[0][1] > _e817[1][1]));
                                                            let _e908 = select(_e817[1][2], _e817[0][2], (_e817[0][2] < _e817[1][2]));
                                                            let _e912 = select(_e817[1][2], _e817[0][2], (_e817[0][2] > _e817[1][2]));
                                                            let _e917 = ((select(_e817[2][0], _e892, (_e892 < _e817[2][0])) - _e360) * _e365);
                                                            let _e918 = ((select(_e817[2][0], _e896, (_e896 > _e817[2][0])) - _e361) * _e365);
                                                            let _e921 = ((select(_e817[2][1], _e900, (_e900 < _e817[2][1])) - _e396) * _e401);
                                                            let _e922 = ((select(_e817[2][1], _e904, (_e904 > _e817[2][1])) - _e397) * _e401);
                                                            let _e925 = ((select(_e817[2][2], _e908, (_e908 < _e817[2][2])) - _e432) * _e437);
                                                            let _e926 = ((select(_e817[2][2], _e912, (_e912 > _e817[2][2])) - _e433) * _e437);
                                                            let _e928 = select(_e926, _e925, (_e925 < _e926));
                                                            let _e930 = select(_e926, _e925, (_e925 > _e926));
                                                            let _e932 = select(_e918, _e917, (_e917 < _e918));
                                                            let _e934 = select(_e922, _e921, (_e921 < _e922));
                                                            let _e936 = select(_e934, _e932, (_e932 > _e934));
                                                            let _e938 = select(_e928, _e936, (_e936 > _e928));
                                                            let _e940 = select(_e918, _e917, (_e917 > _e918));
                                                            let _e942 = select(_e922, _e921, (_e921 > _e922));
                                                            let _e944 = select(_e942, _e940, (_e940 < _e942));
                                                            let _e946 = select(_e930, _e944, (_e944 < _e930));
                                                            let _e947 = -(_e928);
                                                            let _e953 = select(_e483, _e938, (_e938 > _e483));
                                                            if (_e953 > (_e946 + (select(_e947, _e930, (_e930 > _e947)) * 0.0000019073523f))) {
                                                                phi_1582_ = type_28();
                                                                phi_1583_ = true;
                                                            } else {
                                                                let _e955 = (_e953 > _e718.member);
                                                                if _e955 {
                                                                    phi_1581_ = type_28();
                                                                } else {
                                                                    let _e959 = (_e817[1][0] - _e817[0][0]);
                                                                    let _e960 = (_e817[1][1] - _e817[0][1]);
                                                                    let _e961 = (_e817[1][2] - _e817[0][2]);
                                                                    let _e962 = vec3<f32>(_e959, _e960, _e961);
                                                                    let _e963 = (_e817[2][0] - _e817[1][0]);
                                                                    let _e964 = (_e817[2][1] - _e817[1][1]);
                                                                    let _e965 = (_e817[2][2] - _e817[1][2]);
                                                                    let _e966 = vec3<f32>(_e963, _e964, _e965);
                                                                    let _e967 = (_e817[0][0] - _e817[2][0]);
                                                                    let _e968 = (_e817[0][1] - _e817[2][1]);
                                                                    let _e969 = (_e817[0][2] - _e817[2][2]);
                                                                    let _e970 = vec3<f32>(_e967, _e968, _e969);
                                                                    let _e973 = bitcast<f32>((bitcast<u32>(_e959) & 2147483647u));
                                                                    let _e976 = bitcast<f32>((bitcast<u32>(_e960) & 2147483647u));
                                                                    let _e978 = select(_e976, _e973, (_e973 > _e976));
                                                                    let _e981 = bitcast<f32>((bitcast<u32>(_e961) & 2147483647u));
                                                                    let _e983 = select(_e981, _e978, (_e978 > _e981));
                                                                    let _e986 = bitcast<f32>((bitcast<u32>(_e963) & 2147483647u));
                                                                    let _e989 = bitcast<f32>((bitcast<u32>(_e964) & 2147483647u));
                                                                    let _e991 = select(_e989, _e986, (_e986 > _e989));
                                                                    let _e994 = bitcast<f32>((bitcast<u32>(_e965) & 2147483647u));
                                                                    let _e996 = select(_e994, _e991, (_e991 > _e994));
                                                                    let _e999 = bitcast<f32>((bitcast<u32>(_e967) & 2147483647u));
                                                                    let _e1002 = bitcast<f32>((bitcast<u32>(_e968) & 2147483647u));
                                                                    let _e1004 = select(_e1002, _e999, (_e999 > _e1002));
                                                                    let _e1007 = bitcast<f32>((bitcast<u32>(_e969) & 2147483647u));
                                                                    let _e1009 = select(_e1007, _e1004, (_e1004 > _e1007));
                                                                    let _e1011 = select(_e996, _e983, (_e983 > _e996));
                                                                    let _e1013 = select(_e1009, _e1011, (_e1011 > _e1009));
                                                                    if (_e983 == _e1013) {
                                                                        phi_1492_ = _e966;
                                                                        phi_1493_ = _e970;
                                                                    } else {
                                                                        let _e1016 = vec3((_e996 == _e1013));
                                                                        phi_1492_ = select(_e962, _e970, _e1016);
                                                                        phi_1493_ = select(_e966, _e962, _e1016);
                                                                    }
                                                                    let _e1020 = phi_1492_;
                                                                    let _e1022 = phi_1493_;
                                                                    let _e1029 = ((_e1020.y * _e1022.z) - (_e1022.y * _e1020.z));
                                                                    let _e1034 = ((_e1020.z * _e1022.x) - (_e1022.z * _e1020.x));
                                                                    let _e1037 = ((_e1020.x * _e1022.y) - (_e1022.x * _e1020.y));
                                                                    if (_e879 >= _e883) {
                                                                        phi_1524_ = select(true, false, (_e879 >= _e887));
                                                                    } else {
                                                                        phi_1524_ = true;
                                                                    }
                                                                    let _e1042 = phi_1524_;
                                                                    if _e1042 {
                                                                        phi_1533_ = select(vec3<f32>(_e817[2][0], _e817[2][1], _e817[2][2]), vec3<f32>(_e817[1][0], _e817[1][1], _e817[1][2]), vec3((_e883 >= _e887)));
                                                                    } else {
                                                                        phi_1533_ = vec3<f32>(_e817[0][0], _e817[0][1], _e817[0][2]);
                                                                    }
                                                                    let _e1047 = phi_1533_;
                                                                    let _e1064 = ((((_e1029 * (_e1047.x - _e337)) + (_e1034 * (_e1047.y - _e374))) + (_e1037 * (_e1047.z - _e410))) / (((_e1029 * _e362) + (_e1034 * _e398)) + (_e1037 * _e434)));
                                                                    let _e1066 = select(_e946, _e1064, (_e1064 < _e946));
                                                                    let _e1068 = select(_e938, _e1066, (_e1066 > _e938));
                                                                    if (_e1068 >= _e483) {
                                                                        let _e1070 = (_e1068 <= _e718.member);
                                                                        if _e1070 {
                                                                            let _e1071 = (1f / _e889);
                                                                            phi_1573_ = type_28(_e1068, (_e883 * _e1071), (_e887 * _e1071), _e747);
                                                                        } else {
                                                                            phi_1573_ = type_28();
                                                                        }
                                                                        let _e1076 = phi_1573_;
                                                                        phi_1575_ = _e1076;
                                                                        phi_1576_ = select(true, false, _e1070);
                                                                    } else {
                                                                        phi_1575_ = type_28();
                                                                        phi_1576_ = true;
                                                                    }
                                                                    let _e1079 = phi_1575_;
                                                                    let _e1081 = phi_1576_;
                                                                    if _e1081 {
                                                                        phi_1580_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1580_ = _e1079;
                                                                    }
                                                                    let _e1083 = phi_1580_;
                                                                    phi_1581_ = _e1083;
                                                                }
                                                                let _e1085 = phi_1581_;
                                                                phi_1582_ = _e1085;
                                                                phi_1583_ = _e955;
                                                            }
                                                            let _e1087 = phi_1582_;
                                                            let _e1089 = phi_1583_;
                                                            phi_1587_ = _e1087;
                                                            phi_1588_ = _e1089;
                                                        }
                                                        let _e1091 = phi_1587_;
                                                        let _e1093 = phi_1588_;
                                                        phi_1592_ = _e1091;
                                                        phi_1593_ = _e1093;
                                                    } else {
                                                        phi_1592_ = type_28();
                                                        phi_1593_ = true;
                                                    }
                                                    let _e1095 = phi_1592_;
                                                    let _e1097 = phi_1593_;
                                                    if _e1097 {
                                                        phi_1597_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1597_ = _e1095;
                                                    }
                                                    let _e1099 = phi_1597_;
                                                    if (_e1099.member_3 != 4294967295u) {
                                                        if (_e747 == _e100) {
                                                            phi_1926_ = false;
                                                        } else {
                                                            let _e1103 = (_e747 < arrayLength((&global_5.member)));
                                                            if _e1103 {
                                                                if _e1103 {
                                                                } else {
                                                                    phi_2469_ = true;
                                                                    break;
                                                                }
                                                                let _e1105 = global_5.member[_e747];
                                                                phi_1620_ = _e1105;
                                                            } else {
                                                                phi_1620_ = 4294967295u;
                                                            }
                                                            let _e1107 = phi_1620_;
                                                            let _e1108 = (_e1107 < arrayLength((&global_6.member)));
                                                            if _e1108 {
                                                                if _e1108 {
                                                                } else {
                                                                    phi_2469_ = true;
                                                                    break;
                                                                }
                                                                let _e1110 = global_6.member[_e1107];
                                                                phi_1634_ = _e1110;
                                                            } else {
                                                                phi_1634_ = 0i;
                                                            }
                                                            let _e1112 = phi_1634_;
                                                            let _e1113 = (_e1112 == 0i);
                                                            if _e1113 {
                                                                phi_1925_ = true;
                                                            } else {
                                                                if _e329 {
                                                                    phi_1655_ = vec3<f32>(_e817[0][0], _e817[0][1], _e817[0][2]);
                                                                } else {
                                                                    if (_e305 == 1u) {
                                                                        phi_1654_ = vec3<f32>(_e817[0][2], _e817[0][0], _e817[0][1]);
                                                                    } else {
                                                                        phi_1654_ = vec3<f32>(_e817[0][1], _e817[0][2], _e817[0][0]);
                                                                    }
                                                                    let _e1118 = phi_1654_;
                                                                    phi_1655_ = _e1118;
                                                                }
                                                                let _e1121 = phi_1655_;
                                                                if _e329 {
                                                                    phi_1672_ = vec3<f32>(_e817[1][0], _e817[1][1], _e817[1][2]);
                                                                } else {
                                                                    if (_e305 == 1u) {
                                                                        phi_1671_ = vec3<f32>(_e817[1][2], _e817[1][0], _e817[1][1]);
                                                                    } else {
                                                                        phi_1671_ = vec3<f32>(_e817[1][1], _e817[1][2], _e817[1][0]);
                                                                    }
                                                                    let _e1126 = phi_1671_;
                                                                    phi_1672_ = _e1126;
                                                                }
                                                                let _e1129 = phi_1672_;
                                                                if _e329 {
                                                                    phi_1689_ = vec3<f32>(_e817[2][0], _e817[2][1], _e817[2][2]);
                                                                } else {
                                                                    if (_e305 == 1u) {
                                                                        phi_1688_ = vec3<f32>(_e817[2][2], _e817[2][0], _e817[2][1]);
                                                                    } else {
                                                                        phi_1688_ = vec3<f32>(_e817[2][1], _e817[2][2], _e817[2][0]);
                                                                    }
                                                                    let _e1134 = phi_1688_;
                                                                    phi_1689_ = _e1134;
                                                                }
                                                                let _e1137 = phi_1689_;
                                                                let _e1140 = (_e1129.x - _e1121.x);
                                                                let _e1143 = (_e1129.y - _e1121.y);
                                                                let _e1146 = (_e1129.z - _e1121.z);
                                                                let _e1148 = (_e1137.x - _e1121.x);
                                                                let _e1150 = (_e1137.y - _e1121.y);
                                                                let _e1152 = (_e1137.z - _e1121.z);
                                                                if (_e172.member_1 == 1u) {
                                                                    phi_1725_ = (vec3<f32>(_e172.member[0], _e172.member[1], _e172.member[2]) - _e1121);
                                                                } else {
                                                                    phi_1725_ = vec3<f32>(_e172.member[0], _e172.member[1], _e172.member[2]);
                                                                }
                                                                let _e1167 = phi_1725_;
                                                                let _e1173 = bitcast<f32>((bitcast<u32>((_e1140 * _e1150)) ^ _e172.member_3[0]));
                                                                let _e1177 = bitcast<f32>((bitcast<u32>((_e1143 * _e1148)) ^ _e172.member_3[0]));
                                                                let _e1181 = bitcast<f32>((bitcast<u32>((_e1143 * _e1152)) ^ _e172.member_3[0]));
                                                                let _e1185 = bitcast<f32>((bitcast<u32>((_e1146 * _e1150)) ^ _e172.member_3[0]));
                                                                let _e1189 = bitcast<f32>((bitcast<u32>((_e1146 * _e1148)) ^ _e172.member_3[0]));
                                                                let _e1193 = bitcast<f32>((bitcast<u32>((_e1140 * _e1152)) ^ _e172.member_3[0]));
                                                                let _e1194 = (_e1181 - _e1185);
                                                                let _e1195 = (_e1189 - _e1193);
                                                                let _e1196 = (_e1173 - _e1177);
                                                                let _e1220 = (bitcast<f32>((bitcast<u32>(_e1181) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1185) & 2147483647u)));
                                                                let _e1227 = (bitcast<f32>((bitcast<u32>(_e1189) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1193) & 2147483647u)));
                                                                let _e1234 = (bitcast<f32>((bitcast<u32>(_e1173) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1177) & 2147483647u)));
                                                                if (_e172.member_2 == 0f) {
                                                                    phi_1907_ = 0f;
                                                                } else {
                                                                    let _e1264 = bitcast<f32>((bitcast<u32>(_e1194) & 2147483647u));
                                                                    let _e1267 = bitcast<f32>((bitcast<u32>(_e1195) & 2147483647u));
                                                                    let _e1270 = bitcast<f32>((bitcast<u32>(_e1196) & 2147483647u));
                                                                    let _e1272 = select(_e1270, _e1267, (_e1267 > _e1270));
                                                                    let _e1276 = select(_e1270, _e1267, (_e1267 < _e1270));
                                                                    let _e1280 = select(_e1267, _e1264, (_e1264 < _e1267));
                                                                    let _e1282 = select(_e1267, _e1264, (_e1264 > _e1267));
                                                                    let _e1284 = select(_e1270, _e1282, (_e1282 < _e1270));
                                                                    phi_1907_ = bitcast<f32>((bitcast<u32>((_e172.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1272, _e1264, (_e1264 > _e1272)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1284, _e1280, (_e1280 > _e1284)))) ^ _e172.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1276, _e1264, (_e1264 < _e1276)))) ^ _e172.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1220 + _e1227) + _e1234))) ^ _e172.member_3[0]))) * 1.0000005f)) ^ _e172.member_3[0])))) ^ _e172.member_3[0]));
                                                                }
                                                                let _e1311 = phi_1907_;
                                                                phi_1925_ = (_e1113 || !(((((bitcast<f32>((bitcast<u32>((_e1167.x * _e1194)) ^ _e172.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1167.y * _e1195)) ^ _e172.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1167.z * _e1196)) ^ _e172.member_3[0]))) * f32(-(_e1112))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1167.x) & 2147483647u)) * _e1220)) ^ _e172.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1167.y) & 2147483647u)) * _e1227)) ^ _e172.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1167.z) & 2147483647u)) * _e1234)) ^ _e172.member_3[0]))))) ^ _e172.member_3[0])) + _e1311) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1325 = phi_1925_;
                                                            phi_1926_ = _e1325;
                                                        }
                                                        let _e1327 = phi_1926_;
                                                        if _e1327 {
                                                            phi_1931_ = type_55(_e718.member, true);
                                                        } else {
                                                            phi_1931_ = _e718;
                                                        }
                                                        let _e1332 = phi_1931_;
                                                        phi_1932_ = _e1332;
                                                    } else {
                                                        phi_1932_ = _e718;
                                                    }
                                                    let _e1334 = phi_1932_;
                                                    phi_886_ = _e1334;
                                                } else {
                                                    phi_886_ = type_55();
                                                }
                                                let _e1336 = phi_886_;
                                                continue;
                                                continuing {
                                                    phi_885_ = _e1336;
                                                    phi_888_ = _e733;
                                                    phi_2469_ = _e491;
                                                    break if !(_e739);
                                                }
                                            }
                                            let _e1339 = phi_2469_;
                                            phi_2607_ = _e1339;
                                            if _e1339 {
                                                break;
                                            }
                                            let _e1341 = local_2;
                                            phi_2611_ = _e1339;
                                            let _e1521 = local_4;
                                            phi_2388_ = _e1521;
                                            phi_2389_ = _e516;
                                            phi_2390_ = false;
                                            phi_2391_ = select(_e520, 0u, _e1341.member_1);
                                        } else {
                                            if (_e516 >= _e75) {
                                                phi_1993_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e516 < _e75) {
                                                } else {
                                                    phi_2607_ = true;
                                                    break;
                                                }
                                                let _e530 = (_e305 % 3u);
                                                if (_e530 < 3u) {
                                                } else {
                                                    phi_2607_ = true;
                                                    break;
                                                }
                                                let _e536 = global_4.member[_e516].member[_e530];
                                                let _e542 = (_e304 % 3u);
                                                if (_e542 < 3u) {
                                                } else {
                                                    phi_2607_ = true;
                                                    break;
                                                }
                                                let _e548 = global_4.member[_e516].member[_e542];
                                                let _e554 = (_e306 % 3u);
                                                if (_e554 < 3u) {
                                                } else {
                                                    phi_2607_ = true;
                                                    break;
                                                }
                                                let _e560 = global_4.member[_e516].member[_e554];
                                                let _e570 = global_4.member[_e516].member_1;
                                                let _e574 = global_4.member[_e516].member_2;
                                                phi_1993_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e536[0], _e536[1], _e536[2], _e536[3]), vec4<f32>(_e548[0], _e548[1], _e548[2], _e548[3]), vec4<f32>(_e560[0], _e560[1], _e560[2], _e560[3])), _e570, _e574);
                                            }
                                            let _e577 = phi_1993_;
                                            let _e589 = ((_e577.member[0].x - _e360) * _e365);
                                            let _e590 = ((_e577.member[0].y - _e360) * _e365);
                                            let _e591 = ((_e577.member[0].z - _e361) * _e365);
                                            let _e592 = ((_e577.member[0].w - _e361) * _e365);
                                            let _e602 = ((_e577.member[1].x - _e396) * _e401);
                                            let _e603 = ((_e577.member[1].y - _e396) * _e401);
                                            let _e604 = ((_e577.member[1].z - _e397) * _e401);
                                            let _e605 = ((_e577.member[1].w - _e397) * _e401);
                                            let _e615 = ((_e577.member[2].x - _e432) * _e437);
                                            let _e616 = ((_e577.member[2].y - _e432) * _e437);
                                            let _e617 = ((_e577.member[2].z - _e433) * _e437);
                                            let _e618 = ((_e577.member[2].w - _e433) * _e437);
                                            let _e620 = select(_e617, _e615, (_e615 < _e617));
                                            let _e622 = select(_e618, _e616, (_e616 < _e618));
                                            let _e624 = select(_e617, _e615, (_e615 > _e617));
                                            let _e626 = select(_e618, _e616, (_e616 > _e618));
                                            let _e628 = select(_e591, _e589, (_e589 < _e591));
                                            let _e630 = select(_e592, _e590, (_e590 < _e592));
                                            let _e632 = select(_e604, _e602, (_e602 < _e604));
                                            let _e634 = select(_e605, _e603, (_e603 < _e605));
                                            let _e636 = select(_e632, _e628, (_e628 > _e632));
                                            let _e638 = select(_e634, _e630, (_e630 > _e634));
                                            let _e640 = select(_e620, _e636, (_e636 > _e620));
                                            let _e642 = select(_e622, _e638, (_e638 > _e622));
                                            let _e644 = select(_e591, _e589, (_e589 > _e591));
                                            let _e646 = select(_e592, _e590, (_e590 > _e592));
                                            let _e648 = select(_e604, _e602, (_e602 > _e604));
                                            let _e650 = select(_e605, _e603, (_e603 > _e605));
                                            let _e652 = select(_e648, _e644, (_e644 < _e648));
                                            let _e654 = select(_e650, _e646, (_e646 < _e650));
                                            let _e659 = -(_e620);
                                            let _e660 = -(_e622);
                                            let _e667 = (select(_e624, _e652, (_e652 < _e624)) + (select(_e659, _e624, (_e624 > _e659)) * 0.0000019073523f));
                                            let _e668 = (select(_e626, _e654, (_e654 < _e626)) + (select(_e660, _e626, (_e626 > _e660)) * 0.0000019073523f));
                                            let _e670 = select(_e483, _e640, (_e640 > _e483));
                                            let _e672 = select(_e483, _e642, (_e642 > _e483));
                                            let _e677 = (_e670 <= select(_e493.member, _e667, (_e667 < _e493.member)));
                                            let _e678 = (_e672 <= select(_e493.member, _e668, (_e668 < _e493.member)));
                                            let _e679 = (_e670 <= _e672);
                                            if _e677 {
                                                if _e678 {
                                                    if _e679 {
                                                        phi_2337_ = _e577.member_2;
                                                    } else {
                                                        phi_2337_ = _e577.member_1;
                                                    }
                                                    let _e683 = phi_2337_;
                                                    let _e686 = (_e520 % 128u);
                                                    let _e687 = (_e686 < 128u);
                                                    if _e687 {
                                                    } else {
                                                        phi_2607_ = true;
                                                        break;
                                                    }
                                                    local_1[_e686] = _e683;
                                                    if _e687 {
                                                    } else {
                                                        phi_2607_ = true;
                                                        break;
                                                    }
                                                    local[_e686] = select(_e672, _e670, (_e670 > _e672));
                                                    if _e679 {
                                                        phi_2365_ = _e577.member_1;
                                                    } else {
                                                        phi_2365_ = _e577.member_2;
                                                    }
                                                    let _e694 = phi_2365_;
                                                    phi_2366_ = _e694;
                                                    phi_2367_ = (_e520 + 1u);
                                                } else {
                                                    phi_2366_ = u32();
                                                    phi_2367_ = u32();
                                                }
                                                let _e696 = phi_2366_;
                                                let _e698 = phi_2367_;
                                                phi_2369_ = _e696;
                                                phi_2370_ = _e698;
                                                phi_2371_ = select(true, false, _e678);
                                            } else {
                                                phi_2369_ = u32();
                                                phi_2370_ = u32();
                                                phi_2371_ = true;
                                            }
                                            let _e701 = phi_2369_;
                                            let _e703 = phi_2370_;
                                            let _e705 = phi_2371_;
                                            if _e705 {
                                                if _e677 {
                                                    phi_2380_ = _e577.member_1;
                                                } else {
                                                    phi_2380_ = _e577.member_2;
                                                }
                                                let _e709 = phi_2380_;
                                                phi_2385_ = _e709;
                                                phi_2386_ = select(_e678, true, _e677);
                                            } else {
                                                phi_2385_ = _e701;
                                                phi_2386_ = _e518;
                                            }
                                            let _e712 = phi_2385_;
                                            let _e714 = phi_2386_;
                                            phi_2611_ = _e491;
                                            phi_2388_ = _e493;
                                            phi_2389_ = _e712;
                                            phi_2390_ = _e714;
                                            phi_2391_ = select(_e703, _e520, _e705);
                                        }
                                        let _e1345 = phi_2611_;
                                        let _e1347 = phi_2388_;
                                        let _e1349 = phi_2389_;
                                        let _e1351 = phi_2390_;
                                        let _e1353 = phi_2391_;
                                        phi_2610_ = _e1345;
                                        phi_2392_ = _e1347;
                                        phi_2393_ = _e1349;
                                        phi_2394_ = (_e497 - 1u);
                                        phi_2395_ = _e1351;
                                        phi_2396_ = _e1353;
                                    } else {
                                        phi_2610_ = _e491;
                                        phi_2392_ = _e493;
                                        phi_2393_ = _e516;
                                        phi_2394_ = _e497;
                                        phi_2395_ = _e518;
                                        phi_2396_ = _e520;
                                    }
                                    let _e1355 = phi_2610_;
                                    let _e1357 = phi_2392_;
                                    let _e1359 = phi_2393_;
                                    let _e1361 = phi_2394_;
                                    let _e1363 = phi_2395_;
                                    let _e1365 = phi_2396_;
                                    phi_2609_ = _e1355;
                                    phi_2397_ = _e1357;
                                    phi_2398_ = _e1359;
                                    phi_2399_ = _e1361;
                                    phi_2400_ = _e1363;
                                    phi_2401_ = _e1365;
                                } else {
                                    phi_2609_ = _e491;
                                    phi_2397_ = type_55();
                                    phi_2398_ = u32();
                                    phi_2399_ = u32();
                                    phi_2400_ = bool();
                                    phi_2401_ = u32();
                                }
                                let _e1367 = phi_2609_;
                                let _e1369 = phi_2397_;
                                let _e1371 = phi_2398_;
                                let _e1373 = phi_2399_;
                                let _e1375 = phi_2400_;
                                let _e1377 = phi_2401_;
                                phi_2608_ = _e1367;
                                phi_817_ = _e1369;
                                phi_820_ = _e1371;
                                phi_822_ = _e1373;
                                phi_824_ = _e1375;
                                phi_826_ = _e1377;
                                phi_2402_ = _e505;
                            } else {
                                phi_2608_ = _e491;
                                phi_817_ = type_55();
                                phi_820_ = u32();
                                phi_822_ = u32();
                                phi_824_ = bool();
                                phi_826_ = u32();
                                phi_2402_ = false;
                            }
                            let _e1379 = phi_2608_;
                            let _e1381 = phi_817_;
                            let _e1383 = phi_820_;
                            let _e1385 = phi_822_;
                            let _e1387 = phi_824_;
                            let _e1389 = phi_826_;
                            let _e1391 = phi_2402_;
                            continue;
                            continuing {
                                phi_2475_ = _e1379;
                                phi_816_ = _e1381;
                                phi_819_ = _e1383;
                                phi_821_ = _e1385;
                                phi_823_ = _e1387;
                                phi_825_ = _e1389;
                                phi_2607_ = _e1379;
                                break if !(_e1391);
                            }
                        }
                        let _e1394 = phi_2607_;
                        if _e1394 {
                            break;
                        }
                        let _e1396 = local_3;
                        if _e1396.member_1 {
                        } else {
                            if _e173 {
                            } else {
                                break;
                            }
                            let _e1400 = global_9.member[_e93];
                            if _e94 {
                            } else {
                                break;
                            }
                            let _e1404 = global_8.member[_e93].member_1;
                            if _e173 {
                            } else {
                                break;
                            }
                            global_9.member[_e93] = type_30(_e1400.member, _e1400.member_1, _e1400.member_2, array<f32, 3>((_e1400.member_3[0] + (_e1404[0] * _e1400.member_1[0])), (_e1400.member_3[1] + (_e1404[1] * _e1400.member_1[1])), (_e1400.member_3[2] + (_e1404[2] * _e1400.member_1[2]))), _e1400.member_4);
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
fn trace_shadows_facing(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
