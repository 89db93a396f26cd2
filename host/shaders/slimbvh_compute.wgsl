// Made by slimbvh's shader builder from its Rust: rays traced from your own compute shaders, with the stacks in workgroup
// memory. Put this text behind slimbvh.wgsl, and call
//
//   slimbvh_closest_hit_in_group(lane, origin, t_min, direction, t_max) -> SlimbvhHit
//   slimbvh_any_hit_in_group(lane, origin, t_min, direction, t_max) -> bool
//
// lane is the invocation's local_invocation_index. The stacks are 8 KiB for 64 invocations, 32 nodes each, whatever the
// size of the workgroup. A ray that needs more is traced again by the functions of slimbvh.wgsl; so is every ray of a lane
// from 64 on, so workgroups should have 64 invocations or fewer. Two invocations with the same lane get wrong answers.
// There is no barrier inside: calls may stand in branches and loops.
//
//   slimbvh_try_closest_hit(lane, origin, t_min, direction, t_max) -> SlimbvhTriedHit { hit, overflowed }
//   slimbvh_try_any_hit(lane, origin, t_min, direction, t_max) -> SlimbvhTriedAny { found, overflowed }
//
// trace nothing again: where overflowed is true, hit is a miss and found is false, and mean nothing. A shader that calls
// only these needs no private stack: it can list the rays that overflowed for a second dispatch.

var<workgroup> slimbvh_stacks: array<u32, 2048>;

var<private> slimbvh_lane: SlimbvhTypeJ;

var<private> slimbvh_overflowed: SlimbvhTypeJ;

fn slimbvh_trace_in_group() {
    var phi_363_: u32;
    var phi_369_: u32;
    var phi_375_: u32;
    var phi_640_: i32;
    var phi_651_: i32;
    var phi_765_: i32;
    var phi_894_: i32;
    var phi_916_: u32;
    var phi_917_: u32;
    var phi_918_: bool;
    var phi_952_: i32;
    var phi_974_: u32;
    var phi_975_: u32;
    var phi_976_: bool;
    var phi_537_: i32;
    var phi_543_: u32;
    var phi_562_: u32;
    var phi_563_: u32;
    var phi_564_: bool;
    var phi_582_: i32;
    var phi_588_: u32;
    var phi_607_: u32;
    var phi_608_: u32;
    var phi_609_: bool;
    var phi_986_: SlimbvhTypeF;
    var phi_1188_: SlimbvhTypeK;
    var phi_1203_: SlimbvhTypeK;
    var phi_1206_: u32;
    var phi_1208_: u32;
    var phi_1210_: u32;
    var phi_1219_: u32;
    var phi_1222_: u32;
    var phi_1224_: u32;
    var phi_1471_: u32;
    var phi_1487_: u32;
    var phi_1488_: u32;
    var phi_1220_: u32;
    var phi_1223_: u32;
    var phi_1225_: u32;
    var local: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_1504_: SlimbvhTypeK;
    var phi_1507_: SlimbvhTypeA;
    var phi_1508_: SlimbvhTypeA;
    var phi_1530_: SlimbvhTypeA;
    var phi_1609_: array<vec4<f32>, 3>;
    var phi_1610_: array<vec4<f32>, 3>;
    var phi_1684_: array<vec4<f32>, 3>;
    var phi_1685_: array<vec4<f32>, 3>;
    var phi_1708_: array<f32, 3>;
    var phi_1709_: array<f32, 3>;
    var phi_1723_: array<f32, 3>;
    var phi_1724_: array<f32, 3>;
    var phi_1738_: array<f32, 3>;
    var phi_1739_: array<f32, 3>;
    var phi_2055_: f32;
    var phi_2056_: f32;
    var phi_2057_: f32;
    var phi_2058_: f32;
    var phi_2059_: vec3<f32>;
    var phi_2060_: vec3<f32>;
    var phi_2061_: vec3<f32>;
    var phi_2062_: vec3<f32>;
    var phi_2241_: f32;
    var phi_2267_: SlimbvhTypeH;
    var phi_2268_: SlimbvhTypeH;
    var phi_2271_: SlimbvhTypeH;
    var phi_2272_: SlimbvhTypeH;
    var phi_2273_: bool;
    var phi_2277_: SlimbvhTypeH;
    var phi_2286_: SlimbvhTypeC;
    var phi_2311_: bool;
    var phi_2312_: bool;
    var phi_2319_: SlimbvhTypeK;
    var phi_2325_: SlimbvhTypeK;
    var phi_2326_: SlimbvhTypeK;
    var phi_2327_: SlimbvhTypeK;
    var phi_1505_: SlimbvhTypeK;
    var local_3: u32;
    var local_4: SlimbvhTypeK;
    var phi_2349_: SlimbvhTypeK;
    var phi_2350_: u32;
    var phi_2351_: u32;
    var phi_1204_: SlimbvhTypeK;
    var phi_1207_: u32;
    var phi_1209_: u32;
    var phi_1211_: u32;
    var local_5: u32;
    var local_6: SlimbvhTypeK;
    var phi_2386_: f32;
    var phi_2388_: f32;
    var phi_2389_: bool;
    var phi_2390_: f32;
    var phi_2391_: bool;
    var phi_2601_: u32;
    var phi_2619_: bool;
    var phi_2622_: bool;
    var phi_2635_: f32;
    var phi_2636_: f32;
    var phi_2641_: f32;
    var phi_2642_: f32;
    var phi_2643_: bool;
    var phi_2651_: f32;
    var phi_2406_: f32;
    var phi_2407_: f32;
    var phi_2419_: f32;
    var phi_2424_: SlimbvhTypeC;
    var phi_2437_: bool;
    var phi_2438_: bool;
    var phi_2439_: bool;
    var local_7: SlimbvhTypeK;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e76 = SlimbvhTypeC(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e78 = arrayLength((&slimbvh_nodes.member));
    let _e87 = slimbvh_origin.member;
    let _e93 = slimbvh_origin.member[3u];
    let _e94 = slimbvh_direction.member;
    let _e100 = slimbvh_direction.member[3u];
    let _e103 = slimbvh_exponent.member[0u];
    let _e104 = bitcast<i32>(_e103);
    let _e106 = (bitcast<u32>(_e87.x) & 2147483647u);
    let _e108 = (bitcast<u32>(_e87.y) & 2147483647u);
    let _e110 = (bitcast<u32>(_e87.z) & 2147483647u);
    let _e111 = bitcast<u32>(_e93);
    let _e112 = (_e111 & 2147483647u);
    let _e114 = (bitcast<u32>(_e94.x) & 2147483647u);
    let _e116 = (bitcast<u32>(_e94.y) & 2147483647u);
    let _e118 = (bitcast<u32>(_e94.z) & 2147483647u);
    let _e119 = bitcast<u32>(_e100);
    let _e120 = (_e119 & 2147483647u);
    let _e122 = select(_e116, _e114, (_e116 < _e114));
    let _e124 = select(_e118, _e122, (_e118 < _e122));
    let _e126 = select(_e106, _e124, (_e106 < _e124));
    let _e128 = select(_e108, _e126, (_e108 < _e126));
    let _e130 = select(_e110, _e128, (_e110 < _e128));
    let _e137 = (((select(_e112, _e130, (_e112 < _e130)) < 2139095040u) && (_e120 <= 2139095040u)) && (_e124 > 0u));
    if (_e114 == _e124) {
        phi_363_ = 0u;
    } else {
        phi_363_ = select(2u, 1u, (_e116 == _e124));
    }
    let _e142 = phi_363_;
    let _e143 = (_e142 == 2u);
    if _e143 {
        phi_369_ = 0u;
    } else {
        phi_369_ = (_e142 + 1u);
    }
    let _e146 = phi_369_;
    let _e147 = (_e146 == 2u);
    if _e147 {
        phi_375_ = 0u;
    } else {
        phi_375_ = (_e146 + 1u);
    }
    let _e150 = phi_375_;
    let _e151 = (_e146 == 0u);
    let _e153 = select(select(_e87.y, _e87.x, _e151), _e87.z, _e147);
    let _e154 = (_e150 == 0u);
    let _e156 = (_e150 == 2u);
    let _e157 = select(select(_e87.y, _e87.x, _e154), _e87.z, _e156);
    let _e158 = (_e142 == 0u);
    let _e160 = select(select(_e87.y, _e87.x, _e158), _e87.z, _e143);
    let _e162 = select(select(_e94.y, _e94.x, _e151), _e94.z, _e147);
    let _e164 = select(select(_e94.y, _e94.x, _e154), _e94.z, _e156);
    let _e166 = select(select(_e94.y, _e94.x, _e158), _e94.z, _e143);
    let _e167 = (_e112 - 1u);
    let _e168 = (_e120 - 1u);
    let _e170 = select(_e167, _e168, (_e168 < _e167));
    let _e171 = (_e106 - 1u);
    let _e172 = (_e108 - 1u);
    let _e174 = select(_e171, _e172, (_e172 < _e171));
    let _e175 = (_e110 - 1u);
    let _e177 = select(_e174, _e175, (_e175 < _e174));
    let _e178 = (_e114 - 1u);
    let _e179 = (_e116 - 1u);
    let _e181 = select(_e178, _e179, (_e179 < _e178));
    let _e182 = (_e118 - 1u);
    let _e184 = select(_e181, _e182, (_e182 < _e181));
    let _e186 = select(_e177, _e184, (_e184 < _e177));
    if (((select(_e186, _e170, (_e170 < _e186)) >= 8388607u) && (_e124 < 2130706432u)) && (bitcast<u32>((_e104 + 126i)) <= 253u)) {
        let _e451 = bitcast<i32>((_e124 >> bitcast<u32>(23i)));
        let _e452 = (_e451 - 127i);
        let _e453 = (_e104 + _e452);
        let _e458 = bitcast<f32>((bitcast<u32>((_e104 + 127i)) << bitcast<u32>(23i)));
        let _e463 = bitcast<f32>((bitcast<u32>((254i - _e451)) << bitcast<u32>(23i)));
        if (_e112 >= 2139095040u) {
            phi_537_ = 255i;
        } else {
            phi_537_ = (bitcast<i32>((_e112 >> bitcast<u32>(23i))) + _e453);
        }
        let _e478 = phi_537_;
        if (_e112 == 0u) {
            phi_543_ = 0u;
        } else {
            phi_543_ = (_e112 | 8388608u);
        }
        let _e482 = phi_543_;
        if (_e478 <= 0i) {
            phi_563_ = u32();
            phi_564_ = true;
        } else {
            let _e489 = (_e482 == 0u);
            if _e489 {
                phi_562_ = u32();
            } else {
                phi_562_ = select(((bitcast<u32>(_e478) << bitcast<u32>(23i)) | (_e482 & 8388607u)), 2139095039u, (_e478 >= 255i));
            }
            let _e493 = phi_562_;
            phi_563_ = _e493;
            phi_564_ = _e489;
        }
        let _e495 = phi_563_;
        let _e497 = phi_564_;
        if (_e120 >= 2139095040u) {
            phi_582_ = 255i;
        } else {
            phi_582_ = (bitcast<i32>((_e120 >> bitcast<u32>(23i))) + _e453);
        }
        let _e508 = phi_582_;
        if (_e120 == 0u) {
            phi_588_ = 0u;
        } else {
            phi_588_ = (_e120 | 8388608u);
        }
        let _e512 = phi_588_;
        if (_e508 <= 0i) {
            phi_608_ = u32();
            phi_609_ = true;
        } else {
            let _e519 = (_e512 == 0u);
            if _e519 {
                phi_607_ = u32();
            } else {
                phi_607_ = select(((bitcast<u32>(_e508) << bitcast<u32>(23i)) | (_e512 & 8388607u)), 2139095039u, (_e508 >= 255i));
            }
            let _e523 = phi_607_;
            phi_608_ = _e523;
            phi_609_ = _e519;
        }
        let _e525 = phi_608_;
        let _e527 = phi_609_;
        phi_986_ = SlimbvhTypeF(array<f32, 3>((_e153 * _e458), (_e157 * _e458), (_e160 * _e458)), array<f32, 3>((_e162 * _e463), (_e164 * _e463), (_e166 * _e463)), bitcast<f32>(((_e111 & 2147483648u) | select(_e495, 0u, _e497))), bitcast<f32>(((_e119 & 2147483648u) | select(_e525, 0u, _e527))), _e452);
    } else {
        let _e199 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e124, _e137))) & 2147483647u);
        if (_e199 >= 8388608u) {
            phi_640_ = (bitcast<i32>((_e199 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_640_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e199)), 32u, (_e199 == 0u))));
        }
        let _e213 = phi_640_;
        let _e214 = (_e104 + _e213);
        if (_e104 < -126i) {
            phi_651_ = -126i;
        } else {
            phi_651_ = select(_e104, 127i, (_e104 > 127i));
        }
        let _e219 = phi_651_;
        let _e224 = bitcast<f32>((bitcast<u32>((_e219 + 127i)) << bitcast<u32>(23i)));
        let _e230 = bitcast<f32>((bitcast<u32>(((_e104 - _e219) + 127i)) << bitcast<u32>(23i)));
        let _e231 = bitcast<u32>(_e153);
        let _e233 = ((_e231 & 2139095040u) != 0u);
        let _e248 = bitcast<u32>(_e157);
        let _e250 = ((_e248 & 2139095040u) != 0u);
        let _e265 = bitcast<u32>(_e160);
        let _e267 = ((_e265 & 2139095040u) != 0u);
        let _e283 = -(_e213);
        if (_e283 < -126i) {
            phi_765_ = -126i;
        } else {
            phi_765_ = select(_e283, 127i, (_e283 > 127i));
        }
        let _e288 = phi_765_;
        let _e293 = bitcast<f32>((bitcast<u32>((_e288 + 127i)) << bitcast<u32>(23i)));
        let _e299 = bitcast<f32>((bitcast<u32>(((_e283 - _e288) + 127i)) << bitcast<u32>(23i)));
        let _e300 = bitcast<u32>(_e162);
        let _e302 = ((_e300 & 2139095040u) != 0u);
        let _e317 = bitcast<u32>(_e164);
        let _e319 = ((_e317 & 2139095040u) != 0u);
        let _e334 = bitcast<u32>(_e166);
        let _e336 = ((_e334 & 2139095040u) != 0u);
        let _e358 = ((_e112 & 8388607u) | (select(0u, 1u, ((_e112 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e361 = bitcast<i32>((_e112 >> bitcast<u32>(23i)));
        let _e368 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e358)), 32u, (_e358 == 0u))) - 8i);
        if (_e361 == 255i) {
            phi_894_ = 255i;
        } else {
            phi_894_ = (((_e361 + select(0i, 1i, (_e361 == 0i))) - _e368) + _e214);
        }
        let _e376 = phi_894_;
        let _e380 = (_e358 << bitcast<u32>(((_e368 & 31i) & 31i)));
        if (_e376 <= 0i) {
            phi_917_ = u32();
            phi_918_ = true;
        } else {
            let _e387 = (_e380 == 0u);
            if _e387 {
                phi_916_ = u32();
            } else {
                phi_916_ = select(((bitcast<u32>(_e376) << bitcast<u32>(23i)) | (_e380 & 8388607u)), 2139095039u, (_e376 >= 255i));
            }
            let _e391 = phi_916_;
            phi_917_ = _e391;
            phi_918_ = _e387;
        }
        let _e393 = phi_917_;
        let _e395 = phi_918_;
        let _e406 = ((_e120 & 8388607u) | (select(0u, 1u, ((_e120 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e409 = bitcast<i32>((_e120 >> bitcast<u32>(23i)));
        let _e416 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e406)), 32u, (_e406 == 0u))) - 8i);
        if (_e409 == 255i) {
            phi_952_ = 255i;
        } else {
            phi_952_ = (((_e409 + select(0i, 1i, (_e409 == 0i))) - _e416) + _e214);
        }
        let _e424 = phi_952_;
        let _e428 = (_e406 << bitcast<u32>(((_e416 & 31i) & 31i)));
        if (_e424 <= 0i) {
            phi_975_ = u32();
            phi_976_ = true;
        } else {
            let _e435 = (_e428 == 0u);
            if _e435 {
                phi_974_ = u32();
            } else {
                phi_974_ = select(((bitcast<u32>(_e424) << bitcast<u32>(23i)) | (_e428 & 8388607u)), 2139095039u, (_e424 >= 255i));
            }
            let _e439 = phi_974_;
            phi_975_ = _e439;
            phi_976_ = _e435;
        }
        let _e441 = phi_975_;
        let _e443 = phi_976_;
        phi_986_ = SlimbvhTypeF(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e231 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e231 & 2147483648u))), _e153, _e233) * _e224) * select(0.00000011920929f, 1f, _e233)) * _e230), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e248 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e248 & 2147483648u))), _e157, _e250) * _e224) * select(0.00000011920929f, 1f, _e250)) * _e230), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e265 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e265 & 2147483648u))), _e160, _e267) * _e224) * select(0.00000011920929f, 1f, _e267)) * _e230)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e300 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e300 & 2147483648u))), _e162, _e302) * _e293) * select(0.00000011920929f, 1f, _e302)) * _e299), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e317 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e317 & 2147483648u))), _e164, _e319) * _e293) * select(0.00000011920929f, 1f, _e319)) * _e299), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e334 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e334 & 2147483648u))), _e166, _e336) * _e293) * select(0.00000011920929f, 1f, _e336)) * _e299)), bitcast<f32>(((_e111 & 2147483648u) | select(_e393, 0u, _e395))), bitcast<f32>(((_e119 & 2147483648u) | select(_e441, 0u, _e443))), _e213);
    }
    let _e534 = phi_986_;
    let _e549 = (bitcast<f32>((bitcast<u32>(_e534.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e552 = bitcast<f32>((bitcast<u32>(_e534.member[0]) & 2147483647u));
    let _e553 = (_e552 * 0.00000011920929f);
    let _e556 = select(select(0.00000000000011368684f, _e553, (_e553 > 0.00000000000011368684f)), 0f, _e549);
    let _e557 = select(0f, _e534.member_1[0], _e549);
    let _e558 = (_e534.member[0] + _e556);
    let _e559 = (_e534.member[0] - _e556);
    let _e561 = select(38685626000000000000000000f, (1f / _e534.member_1[0]), _e549);
    let _e565 = (bitcast<f32>((bitcast<u32>(_e534.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e568 = bitcast<f32>((bitcast<u32>(_e534.member[1]) & 2147483647u));
    let _e569 = (_e568 * 0.00000011920929f);
    let _e572 = select(select(0.00000000000011368684f, _e569, (_e569 > 0.00000000000011368684f)), 0f, _e565);
    let _e573 = select(0f, _e534.member_1[1], _e565);
    let _e574 = (_e534.member[1] + _e572);
    let _e575 = (_e534.member[1] - _e572);
    let _e577 = select(38685626000000000000000000f, (1f / _e534.member_1[1]), _e565);
    let _e581 = (bitcast<f32>((bitcast<u32>(_e534.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e584 = bitcast<f32>((bitcast<u32>(_e534.member[2]) & 2147483647u));
    let _e585 = (_e584 * 0.00000011920929f);
    let _e588 = select(select(0.00000000000011368684f, _e585, (_e585 > 0.00000000000011368684f)), 0f, _e581);
    let _e589 = select(0f, _e534.member_1[2], _e581);
    let _e590 = (_e534.member[2] + _e588);
    let _e591 = (_e534.member[2] - _e588);
    let _e593 = select(38685626000000000000000000f, (1f / _e534.member_1[2]), _e581);
    let _e595 = select(_e568, _e552, (_e552 > _e568));
    let _e599 = (_e137 && (select(_e584, _e595, (_e595 > _e584)) <= 1099511600000f));
    let _e600 = select(0f, _e534.member_3, _e599);
    let _e601 = select(1f, _e534.member_2, _e599);
    let _e603 = slimbvh_lane.member;
    if (_e603 < 64u) {
        let _e605 = (_e603 % 64u);
        let _e606 = slimbvh_any_will_do.member;
        if (_e606 == 1u) {
            phi_1188_ = SlimbvhTypeK(SlimbvhTypeG(_e76, _e600), true);
        } else {
            phi_1188_ = SlimbvhTypeK(SlimbvhTypeG(_e76, _e600), false);
        }
        let _e613 = phi_1188_;
        phi_1203_ = _e613;
        phi_1206_ = 0u;
        phi_1208_ = select(4294967295u, 0u, (_e601 <= _e600));
        phi_1210_ = (_e78 + 1u);
        loop {
            let _e622 = phi_1203_;
            let _e624 = phi_1206_;
            let _e626 = phi_1208_;
            let _e628 = phi_1210_;
            local_5 = _e626;
            local_6 = _e622;
            let _e629 = (_e626 <= 32u);
            if _e629 {
                phi_1219_ = _e624;
                phi_1222_ = _e626;
                phi_1224_ = _e628;
                loop {
                    let _e631 = phi_1219_;
                    let _e633 = phi_1222_;
                    let _e635 = phi_1224_;
                    local_1 = _e631;
                    local_2 = _e631;
                    local_3 = _e633;
                    local_8 = _e631;
                    local_9 = _e633;
                    local_10 = _e635;
                    let _e636 = (_e633 <= 32u);
                    let _e639 = (_e636 && !((_e631 >= _e78)));
                    local = _e636;
                    if _e639 {
                        let _e644 = slimbvh_nodes.member[_e631][3u][0u];
                        let _e649 = slimbvh_nodes.member[_e631][3u][1u];
                        let _e654 = slimbvh_nodes.member[_e631][((_e146 & 3u) % 4u)];
                        let _e659 = slimbvh_nodes.member[_e631][((_e150 & 3u) % 4u)];
                        let _e664 = slimbvh_nodes.member[_e631][((_e142 & 3u) % 4u)];
                        let _e665 = bitcast<u32>(_e644);
                        let _e666 = bitcast<u32>(_e649);
                        let _e677 = ((_e654.x - _e558) * _e561);
                        let _e678 = ((_e654.y - _e558) * _e561);
                        let _e679 = ((_e654.z - _e559) * _e561);
                        let _e680 = ((_e654.w - _e559) * _e561);
                        let _e689 = ((_e659.x - _e574) * _e577);
                        let _e690 = ((_e659.y - _e574) * _e577);
                        let _e691 = ((_e659.z - _e575) * _e577);
                        let _e692 = ((_e659.w - _e575) * _e577);
                        let _e701 = ((_e664.x - _e590) * _e593);
                        let _e702 = ((_e664.y - _e590) * _e593);
                        let _e703 = ((_e664.z - _e591) * _e593);
                        let _e704 = ((_e664.w - _e591) * _e593);
                        let _e705 = min(_e701, _e703);
                        let _e706 = min(_e702, _e704);
                        let _e707 = max(_e701, _e703);
                        let _e708 = max(_e702, _e704);
                        let _e733 = max(max(max(min(_e677, _e679), min(_e689, _e691)), _e705), _e601);
                        let _e734 = max(max(max(min(_e678, _e680), min(_e690, _e692)), _e706), _e601);
                        let _e737 = (_e733 <= min((min(min(max(_e677, _e679), max(_e689, _e691)), _e707) + (max(_e707, -(_e705)) * 0.0000019073523f)), _e622.member.member_1));
                        let _e738 = (_e734 <= min((min(min(max(_e678, _e680), max(_e690, _e692)), _e708) + (max(_e708, -(_e706)) * 0.0000019073523f)), _e622.member.member_1));
                        if (_e737 || _e738) {
                            let _e750 = (_e737 && (((_e733 <= _e734) != _e613.member_1) || !(_e738)));
                            if (_e737 && _e738) {
                                slimbvh_stacks[(((_e633 % 32u) * 64u) + _e605)] = select(_e665, _e666, _e750);
                                phi_1471_ = (_e633 + 1u);
                            } else {
                                phi_1471_ = _e633;
                            }
                            let _e760 = phi_1471_;
                            phi_1487_ = select(_e666, _e665, _e750);
                            phi_1488_ = _e760;
                        } else {
                            let _e742 = (_e633 - 1u);
                            let _e747 = slimbvh_stacks[(((_e742 % 32u) * 64u) + _e605)];
                            phi_1487_ = _e747;
                            phi_1488_ = _e742;
                        }
                        let _e762 = phi_1487_;
                        let _e764 = phi_1488_;
                        let _e765 = (_e635 - 1u);
                        phi_1220_ = _e762;
                        phi_1223_ = select(_e764, 4294967295u, (_e765 == 0u));
                        phi_1225_ = _e765;
                    } else {
                        phi_1220_ = u32();
                        phi_1223_ = u32();
                        phi_1225_ = u32();
                    }
                    let _e769 = phi_1220_;
                    let _e771 = phi_1223_;
                    let _e773 = phi_1225_;
                    continue;
                    continuing {
                        phi_1219_ = _e769;
                        phi_1222_ = _e771;
                        phi_1224_ = _e773;
                        break if !(_e639);
                    }
                }
                let _e776 = local;
                if _e776 {
                    let _e778 = local_1;
                    let _e781 = local_2;
                    phi_1504_ = _e622;
                    phi_1507_ = SlimbvhTypeA(0u, ((_e781 >> bitcast<u32>(28u)) & 7u));
                    loop {
                        let _e787 = phi_1504_;
                        let _e789 = phi_1507_;
                        local_4 = _e787;
                        local_7 = _e787;
                        if (_e789.member < _e789.member_1) {
                            phi_1508_ = SlimbvhTypeA((_e789.member + 1u), _e789.member_1);
                            phi_1530_ = SlimbvhTypeA(1u, _e789.member);
                        } else {
                            phi_1508_ = _e789;
                            phi_1530_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                        }
                        let _e802 = phi_1508_;
                        let _e804 = phi_1530_;
                        let _e808 = (bitcast<i32>(_e804.member) != 0i);
                        if _e808 {
                            let _e809 = ((_e778 & 268435455u) + _e804.member_1);
                            let _e810 = (_e809 / 2u);
                            let _e811 = (_e809 % 2u);
                            let _e812 = (_e810 >= arrayLength((&slimbvh_triangles.member)));
                            if _e812 {
                                phi_1610_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e813 = (2u * _e811);
                                let _e817 = slimbvh_triangles.member[_e810][_e813];
                                let _e822 = slimbvh_triangles.member[_e810][(_e813 + 1u)];
                                let _e827 = slimbvh_triangles.member[_e810][(_e813 + 2u)];
                                if (_e811 == 0u) {
                                    phi_1609_ = array<vec4<f32>, 3>(_e817, _e822, _e827);
                                } else {
                                    phi_1609_ = array<vec4<f32>, 3>(vec4<f32>(_e817.z, _e817.w, _e822.x, _e822.y), vec4<f32>(_e822.z, _e822.w, _e827.x, _e827.y), vec4<f32>(_e827.z, _e827.w, 0f, 0f));
                                }
                                let _e845 = phi_1609_;
                                phi_1610_ = _e845;
                            }
                            let _e847 = phi_1610_;
                            let _e850 = bitcast<u32>(_e847[2].y);
                            if _e812 {
                                phi_1685_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e851 = (2u * _e811);
                                let _e855 = slimbvh_triangles.member[_e810][_e851];
                                let _e860 = slimbvh_triangles.member[_e810][(_e851 + 1u)];
                                let _e865 = slimbvh_triangles.member[_e810][(_e851 + 2u)];
                                if (_e811 == 0u) {
                                    phi_1684_ = array<vec4<f32>, 3>(_e855, _e860, _e865);
                                } else {
                                    phi_1684_ = array<vec4<f32>, 3>(vec4<f32>(_e855.z, _e855.w, _e860.x, _e860.y), vec4<f32>(_e860.z, _e860.w, _e865.x, _e865.y), vec4<f32>(_e865.z, _e865.w, 0f, 0f));
                                }
                                let _e883 = phi_1684_;
                                phi_1685_ = _e883;
                            }
                            let _e885 = phi_1685_;
                            if _e151 {
                                phi_1709_ = array<f32, 3>(_e885[0].x, _e885[0].y, _e885[0].z);
                            } else {
                                if (_e146 == 1u) {
                                    phi_1708_ = array<f32, 3>(_e885[0].y, _e885[0].z, _e885[0].x);
                                } else {
                                    phi_1708_ = array<f32, 3>(_e885[0].z, _e885[0].x, _e885[0].y);
                                }
                                let _e908 = phi_1708_;
                                phi_1709_ = _e908;
                            }
                            let _e911 = phi_1709_;
                            if _e151 {
                                phi_1724_ = array<f32, 3>(_e885[0].w, _e885[1].x, _e885[1].y);
                            } else {
                                if (_e146 == 1u) {
                                    phi_1723_ = array<f32, 3>(_e885[1].x, _e885[1].y, _e885[0].w);
                                } else {
                                    phi_1723_ = array<f32, 3>(_e885[1].y, _e885[0].w, _e885[1].x);
                                }
                                let _e916 = phi_1723_;
                                phi_1724_ = _e916;
                            }
                            let _e919 = phi_1724_;
                            if _e151 {
                                phi_1739_ = array<f32, 3>(_e885[1].z, _e885[1].w, _e885[2].x);
                            } else {
                                if (_e146 == 1u) {
                                    phi_1738_ = array<f32, 3>(_e885[1].w, _e885[2].x, _e885[1].z);
                                } else {
                                    phi_1738_ = array<f32, 3>(_e885[2].x, _e885[1].z, _e885[1].w);
                                }
                                let _e924 = phi_1738_;
                                phi_1739_ = _e924;
                            }
                            let _e927 = phi_1739_;
                            let _e941 = (_e911[2] - _e534.member[2]);
                            let _e944 = (((_e911[0] - _e534.member[0]) * _e589) - (_e941 * _e557));
                            let _e947 = (((_e911[1] - _e534.member[1]) * _e589) - (_e941 * _e573));
                            let _e950 = (_e919[2] - _e534.member[2]);
                            let _e953 = (((_e919[0] - _e534.member[0]) * _e589) - (_e950 * _e557));
                            let _e956 = (((_e919[1] - _e534.member[1]) * _e589) - (_e950 * _e573));
                            let _e959 = (_e927[2] - _e534.member[2]);
                            let _e962 = (((_e927[0] - _e534.member[0]) * _e589) - (_e959 * _e557));
                            let _e965 = (((_e927[1] - _e534.member[1]) * _e589) - (_e959 * _e573));
                            let _e966 = (_e962 * _e956);
                            let _e967 = (_e965 * _e953);
                            let _e968 = (_e944 * _e965);
                            let _e969 = (_e947 * _e962);
                            let _e970 = (_e953 * _e947);
                            let _e971 = (_e956 * _e944);
                            let _e976 = (((_e966 >= _e967) && (_e968 >= _e969)) && (_e970 >= _e971));
                            let _e982 = (_e976 || (((_e966 <= _e967) && (_e968 <= _e969)) && (_e970 <= _e971)));
                            if _e982 {
                                let _e984 = select(-1f, 1f, _e976);
                                let _e986 = ((_e966 - _e967) * _e984);
                                let _e988 = select(0f, _e986, (_e986 > 0f));
                                let _e990 = ((_e968 - _e969) * _e984);
                                let _e992 = select(0f, _e990, (_e990 > 0f));
                                let _e994 = ((_e970 - _e971) * _e984);
                                let _e996 = select(0f, _e994, (_e994 > 0f));
                                let _e998 = ((_e988 + _e992) + _e996);
                                let _e1013 = ((min(min(_e911[0], _e919[0]), _e927[0]) - _e558) * _e561);
                                let _e1014 = ((max(max(_e911[0], _e919[0]), _e927[0]) - _e559) * _e561);
                                let _e1017 = ((min(min(_e911[1], _e919[1]), _e927[1]) - _e574) * _e577);
                                let _e1018 = ((max(max(_e911[1], _e919[1]), _e927[1]) - _e575) * _e577);
                                let _e1021 = ((min(min(_e911[2], _e919[2]), _e927[2]) - _e590) * _e593);
                                let _e1022 = ((max(max(_e911[2], _e919[2]), _e927[2]) - _e591) * _e593);
                                let _e1023 = min(_e1021, _e1022);
                                let _e1024 = max(_e1021, _e1022);
                                let _e1028 = max(max(min(_e1013, _e1014), min(_e1017, _e1018)), _e1023);
                                let _e1032 = min(min(max(_e1013, _e1014), max(_e1017, _e1018)), _e1024);
                                let _e1037 = max(_e1028, _e601);
                                let _e1059 = (((((_e982 && (_e998 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e944, _e953), _e962) <= 0f) && (max(max(_e944, _e953), _e962) >= 0f))) && ((min(min(_e947, _e956), _e965) <= 0f) && (max(max(_e947, _e956), _e965) >= 0f))) && (_e1037 <= (_e1032 + (max(_e1024, -(_e1023)) * 0.0000019073523f)))) && (_e1037 <= _e787.member.member_1));
                                if _e1059 {
                                    let _e1064 = (_e919[0] - _e911[0]);
                                    let _e1065 = (_e919[1] - _e911[1]);
                                    let _e1066 = (_e919[2] - _e911[2]);
                                    let _e1067 = vec3<f32>(_e1064, _e1065, _e1066);
                                    let _e1068 = (_e927[0] - _e919[0]);
                                    let _e1069 = (_e927[1] - _e919[1]);
                                    let _e1070 = (_e927[2] - _e919[2]);
                                    let _e1071 = vec3<f32>(_e1068, _e1069, _e1070);
                                    let _e1072 = (_e911[0] - _e927[0]);
                                    let _e1073 = (_e911[1] - _e927[1]);
                                    let _e1074 = (_e911[2] - _e927[2]);
                                    let _e1075 = vec3<f32>(_e1072, _e1073, _e1074);
                                    let _e1086 = max(max(bitcast<f32>((bitcast<u32>(_e1064) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1065) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1066) & 2147483647u)));
                                    let _e1097 = max(max(bitcast<f32>((bitcast<u32>(_e1068) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1069) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1070) & 2147483647u)));
                                    let _e1110 = max(max(_e1086, _e1097), max(max(bitcast<f32>((bitcast<u32>(_e1072) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1073) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1074) & 2147483647u))));
                                    if (_e1086 == _e1110) {
                                        phi_2055_ = _e956;
                                        phi_2056_ = _e953;
                                        phi_2057_ = _e947;
                                        phi_2058_ = _e944;
                                        phi_2059_ = vec3<f32>(_e911[0], _e911[1], _e911[2]);
                                        phi_2060_ = _e1075;
                                        phi_2061_ = _e1071;
                                        phi_2062_ = _e1067;
                                    } else {
                                        let _e1112 = (_e1097 == _e1110);
                                        let _e1117 = vec3(_e1112);
                                        phi_2055_ = select(_e947, _e965, _e1112);
                                        phi_2056_ = select(_e944, _e962, _e1112);
                                        phi_2057_ = select(_e965, _e956, _e1112);
                                        phi_2058_ = select(_e962, _e953, _e1112);
                                        phi_2059_ = select(vec3<f32>(_e927[0], _e927[1], _e927[2]), vec3<f32>(_e919[0], _e919[1], _e919[2]), _e1117);
                                        phi_2060_ = select(_e1071, _e1067, _e1117);
                                        phi_2061_ = select(_e1067, _e1075, _e1117);
                                        phi_2062_ = select(_e1075, _e1071, _e1117);
                                    }
                                    let _e1123 = phi_2055_;
                                    let _e1125 = phi_2056_;
                                    let _e1127 = phi_2057_;
                                    let _e1129 = phi_2058_;
                                    let _e1131 = phi_2059_;
                                    let _e1133 = phi_2060_;
                                    let _e1135 = phi_2061_;
                                    let _e1137 = phi_2062_;
                                    let _e1144 = ((_e1135.y * _e1133.z) - (_e1133.y * _e1135.z));
                                    let _e1149 = ((_e1135.z * _e1133.x) - (_e1133.z * _e1135.x));
                                    let _e1152 = ((_e1135.x * _e1133.y) - (_e1133.x * _e1135.y));
                                    let _e1155 = ((_e988 >= _e992) && (_e988 >= _e996));
                                    let _e1156 = (_e992 >= _e996);
                                    let _e1170 = (((_e1144 * (select(select(_e927[0], _e919[0], _e1156), _e911[0], _e1155) - _e534.member[0])) + (_e1149 * (select(select(_e927[1], _e919[1], _e1156), _e911[1], _e1155) - _e534.member[1]))) + (_e1152 * (select(select(_e927[2], _e919[2], _e1156), _e911[2], _e1155) - _e534.member[2])));
                                    let _e1175 = (((_e1144 * _e557) + (_e1149 * _e573)) + (_e1152 * _e589));
                                    let _e1176 = (_e1125 - _e1129);
                                    let _e1177 = (_e1123 - _e1127);
                                    let _e1180 = ((_e1176 * _e1176) + (_e1177 * _e1177));
                                    let _e1187 = (-(((_e1129 * _e1176) + (_e1127 * _e1177))) / select(0.000000000000000000000000000000000000011754944f, _e1180, (_e1180 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e1189 = select(1f, _e1187, (_e1187 < 1f));
                                    let _e1191 = select(0f, _e1189, (_e1189 > 0f));
                                    let _e1200 = ((_e1131.x + (_e1137.x * _e1191)) - _e534.member[0]);
                                    let _e1203 = ((_e1131.y + (_e1137.y * _e1191)) - _e534.member[1]);
                                    let _e1206 = ((_e1131.z + (_e1137.z * _e1191)) - _e534.member[2]);
                                    let _e1271 = ((bitcast<f32>((bitcast<u32>(((((_e1144 * _e1200) + (_e1149 * _e1203)) + (_e1152 * _e1206)) - _e1170)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1200) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1203) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1206) & 2147483647u))), _e1110)) * max(max(bitcast<f32>((bitcast<u32>(_e1144) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1149) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1152) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1175) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1135.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1135.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1135.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1133.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1133.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1133.z) & 2147483647u)))))));
                                    let _e1272 = (_e1170 / _e1175);
                                    if (_e1059 && !(_e1271)) {
                                        let _e1275 = (_e1206 / _e589);
                                        let _e1283 = (((_e1144 * (_e1200 - (_e557 * _e1275))) + (_e1149 * (_e1203 - (_e573 * _e1275)))) / _e1175);
                                        phi_2241_ = select(select(_e1275, (_e1275 + _e1283), (bitcast<f32>((bitcast<u32>(_e1283) & 2147483647u)) <= _e1110)), _e1272, _e1271);
                                    } else {
                                        phi_2241_ = _e1272;
                                    }
                                    let _e1292 = phi_2241_;
                                    let _e1294 = select(_e1032, _e1292, (_e1292 < _e1032));
                                    let _e1296 = select(_e1028, _e1294, (_e1294 > _e1028));
                                    let _e1299 = select(_e1296, 0f, (bitcast<u32>(_e1296) == 2147483648u));
                                    let _e1300 = (1f / _e998);
                                    phi_2267_ = SlimbvhTypeH(_e1299, (_e992 * _e1300), (_e996 * _e1300), ((_e1059 && (_e1299 >= _e601)) && (_e1299 <= _e787.member.member_1)));
                                    phi_2268_ = SlimbvhTypeH();
                                } else {
                                    phi_2267_ = SlimbvhTypeH();
                                    phi_2268_ = SlimbvhTypeH(0f, 0f, 0f, _e1059);
                                }
                                let _e1309 = phi_2267_;
                                let _e1311 = phi_2268_;
                                phi_2271_ = _e1309;
                                phi_2272_ = _e1311;
                                phi_2273_ = select(true, false, _e1059);
                            } else {
                                phi_2271_ = SlimbvhTypeH();
                                phi_2272_ = SlimbvhTypeH(0f, 0f, 0f, _e982);
                                phi_2273_ = true;
                            }
                            let _e1314 = phi_2271_;
                            let _e1316 = phi_2272_;
                            let _e1318 = phi_2273_;
                            if _e1318 {
                                phi_2277_ = _e1316;
                            } else {
                                phi_2277_ = _e1314;
                            }
                            let _e1320 = phi_2277_;
                            if _e1320.member_3 {
                                phi_2286_ = SlimbvhTypeC(_e1320.member, _e1320.member_1, _e1320.member_2, _e850);
                            } else {
                                phi_2286_ = _e76;
                            }
                            let _e1327 = phi_2286_;
                            if (_e1327.member_3 != 4294967295u) {
                                if (_e850 != 4294967295u) {
                                    if (_e1327.member < _e787.member.member.member) {
                                        phi_2312_ = true;
                                    } else {
                                        if (_e1327.member == _e787.member.member.member) {
                                            phi_2311_ = (_e1327.member_3 < _e787.member.member.member_3);
                                        } else {
                                            phi_2311_ = false;
                                        }
                                        let _e1342 = phi_2311_;
                                        phi_2312_ = _e1342;
                                    }
                                    let _e1344 = phi_2312_;
                                    if _e1344 {
                                        phi_2319_ = SlimbvhTypeK(SlimbvhTypeG(_e1327, _e1327.member), _e787.member_1);
                                    } else {
                                        phi_2319_ = _e787;
                                    }
                                    let _e1350 = phi_2319_;
                                    if _e1350.member_1 {
                                        phi_2325_ = SlimbvhTypeK(SlimbvhTypeG(_e1350.member.member, bitcast<f32>(4286578687u)), _e1350.member_1);
                                    } else {
                                        phi_2325_ = _e1350;
                                    }
                                    let _e1359 = phi_2325_;
                                    phi_2326_ = _e1359;
                                } else {
                                    phi_2326_ = _e787;
                                }
                                let _e1361 = phi_2326_;
                                phi_2327_ = _e1361;
                            } else {
                                phi_2327_ = _e787;
                            }
                            let _e1363 = phi_2327_;
                            phi_1505_ = _e1363;
                        } else {
                            phi_1505_ = SlimbvhTypeK();
                        }
                        let _e1365 = phi_1505_;
                        continue;
                        continuing {
                            phi_1504_ = _e1365;
                            phi_1507_ = _e802;
                            break if !(_e808);
                        }
                    }
                    let _e1368 = local_3;
                    let _e1369 = (_e1368 - 1u);
                    let _e1374 = slimbvh_stacks[(((_e1369 % 32u) * 64u) + _e605)];
                    let _e1376 = local_4;
                    let _e1626 = local_7;
                    phi_2349_ = _e1626;
                    phi_2350_ = _e1374;
                    phi_2351_ = select(_e1369, 4294967295u, (_e601 > _e1376.member.member_1));
                } else {
                    phi_2349_ = _e622;
                    let _e1629 = local_8;
                    phi_2350_ = _e1629;
                    let _e1632 = local_9;
                    phi_2351_ = _e1632;
                }
                let _e1382 = phi_2349_;
                let _e1384 = phi_2350_;
                let _e1386 = phi_2351_;
                phi_1204_ = _e1382;
                phi_1207_ = _e1384;
                phi_1209_ = _e1386;
                let _e1638 = local_10;
                phi_1211_ = _e1638;
            } else {
                phi_1204_ = SlimbvhTypeK();
                phi_1207_ = u32();
                phi_1209_ = u32();
                phi_1211_ = u32();
            }
            let _e1388 = phi_1204_;
            let _e1390 = phi_1207_;
            let _e1392 = phi_1209_;
            let _e1394 = phi_1211_;
            continue;
            continuing {
                phi_1203_ = _e1388;
                phi_1206_ = _e1390;
                phi_1208_ = _e1392;
                phi_1210_ = _e1394;
                break if !(_e629);
            }
        }
        let _e1397 = local_5;
        let _e1398 = (_e1397 == 4294967295u);
        let _e1400 = local_6;
        if (_e1400.member.member.member_3 != 4294967295u) {
            let _e1406 = -((_e104 + _e534.member_4));
            let _e1407 = bitcast<u32>(_e1400.member.member.member);
            let _e1411 = (bitcast<i32>((_e1407 >> bitcast<u32>(23i))) & 255i);
            let _e1412 = (_e1411 + _e1406);
            if (_e1411 == 255i) {
                phi_2407_ = _e1400.member.member.member;
            } else {
                if (_e1411 > 0i) {
                    if (_e1412 > 0i) {
                        let _e1416 = (_e1412 < 255i);
                        if _e1416 {
                            phi_2386_ = bitcast<f32>((_e1407 + bitcast<u32>((_e1406 << bitcast<u32>(23i)))));
                        } else {
                            phi_2386_ = f32();
                        }
                        let _e1423 = phi_2386_;
                        phi_2388_ = _e1423;
                        phi_2389_ = select(true, false, _e1416);
                    } else {
                        phi_2388_ = f32();
                        phi_2389_ = true;
                    }
                    let _e1426 = phi_2388_;
                    let _e1428 = phi_2389_;
                    phi_2390_ = _e1426;
                    phi_2391_ = _e1428;
                } else {
                    phi_2390_ = f32();
                    phi_2391_ = true;
                }
                let _e1430 = phi_2390_;
                let _e1432 = phi_2391_;
                if _e1432 {
                    let _e1433 = (_e1407 & 2147483648u);
                    let _e1440 = ((_e1407 & 8388607u) | (select(0u, 1u, ((_e1407 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e1444 = (_e1440 == 0u);
                    if _e1444 {
                        phi_2651_ = bitcast<f32>(_e1433);
                    } else {
                        let _e1449 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1440)), 32u, _e1444) - 8u);
                        let _e1452 = (_e1440 << bitcast<u32>((_e1449 & 31u)));
                        let _e1454 = ((_e1412 + select(0i, 1i, (_e1411 == 0i))) - bitcast<i32>(_e1449));
                        if (_e1454 >= 255i) {
                            phi_2641_ = bitcast<f32>((_e1433 | 2139095040u));
                            phi_2642_ = f32();
                            phi_2643_ = true;
                        } else {
                            let _e1456 = (_e1454 > 0i);
                            if _e1456 {
                                phi_2635_ = bitcast<f32>(((_e1433 | (bitcast<u32>(_e1454) << bitcast<u32>(23i))) | (_e1452 & 8388607u)));
                                phi_2636_ = f32();
                            } else {
                                if (_e1454 < -24i) {
                                    phi_2601_ = 26u;
                                } else {
                                    phi_2601_ = bitcast<u32>((1i - _e1454));
                                }
                                let _e1461 = phi_2601_;
                                let _e1462 = (_e1461 & 31u);
                                let _e1464 = (_e1452 >> bitcast<u32>(_e1462));
                                let _e1468 = (_e1452 & ((1u << bitcast<u32>(_e1462)) - 1u));
                                let _e1472 = (1u << bitcast<u32>(((_e1461 - 1u) & 31u)));
                                if (_e1468 > _e1472) {
                                    phi_2622_ = true;
                                } else {
                                    if (_e1468 == _e1472) {
                                        phi_2619_ = ((_e1464 & 1u) == 1u);
                                    } else {
                                        phi_2619_ = false;
                                    }
                                    let _e1478 = phi_2619_;
                                    phi_2622_ = _e1478;
                                }
                                let _e1480 = phi_2622_;
                                phi_2635_ = f32();
                                phi_2636_ = bitcast<f32>((_e1433 | (_e1464 + select(0u, 1u, _e1480))));
                            }
                            let _e1493 = phi_2635_;
                            let _e1495 = phi_2636_;
                            phi_2641_ = _e1493;
                            phi_2642_ = _e1495;
                            phi_2643_ = _e1456;
                        }
                        let _e1499 = phi_2641_;
                        let _e1501 = phi_2642_;
                        let _e1503 = phi_2643_;
                        phi_2651_ = select(_e1501, _e1499, _e1503);
                    }
                    let _e1507 = phi_2651_;
                    phi_2406_ = _e1507;
                } else {
                    phi_2406_ = _e1430;
                }
                let _e1509 = phi_2406_;
                phi_2407_ = _e1509;
            }
            let _e1511 = phi_2407_;
            let _e1512 = bitcast<u32>(_e1511);
            if ((_e1512 & 2147483647u) >= 2139095040u) {
                phi_2419_ = bitcast<f32>(((_e1512 & 2147483648u) | 2139095039u));
            } else {
                phi_2419_ = _e1511;
            }
            let _e1519 = phi_2419_;
            phi_2424_ = SlimbvhTypeC(_e1519, _e1400.member.member.member_1, _e1400.member.member.member_2, _e1400.member.member.member_3);
        } else {
            phi_2424_ = _e76;
        }
        let _e1524 = phi_2424_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1524.member), bitcast<u32>(_e1524.member_1), bitcast<u32>(_e1524.member_2), _e1524.member_3);
        phi_2437_ = _e1398;
        phi_2438_ = _e1398;
        phi_2439_ = select(true, false, _e1398);
    } else {
        phi_2437_ = bool();
        phi_2438_ = false;
        phi_2439_ = true;
    }
    let _e1535 = phi_2437_;
    let _e1537 = phi_2438_;
    let _e1539 = phi_2439_;
    if _e1539 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e1535, _e1537, _e1539)));
    return;
}

struct SlimbvhTriedHit {
    hit: SlimbvhHit,
    overflowed: bool,
}

struct SlimbvhTriedAny {
    found: bool,
    overflowed: bool,
}

fn slimbvh_try_closest_hit(lane: u32, origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> SlimbvhTriedHit {
    slimbvh_lane.member = lane;
    slimbvh_origin.member = vec4<f32>(origin, t_min);
    slimbvh_direction.member = vec4<f32>(direction, t_max);
    slimbvh_any_will_do.member = 0u;
    slimbvh_trace_in_group();
    let hit = slimbvh_hit.member;
    return SlimbvhTriedHit(
        SlimbvhHit(bitcast<f32>(hit.x), bitcast<f32>(hit.y), bitcast<f32>(hit.z), hit.w),
        slimbvh_overflowed.member != 0u,
    );
}

fn slimbvh_try_any_hit(lane: u32, origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> SlimbvhTriedAny {
    slimbvh_lane.member = lane;
    slimbvh_origin.member = vec4<f32>(origin, t_min);
    slimbvh_direction.member = vec4<f32>(direction, t_max);
    slimbvh_any_will_do.member = 1u;
    slimbvh_trace_in_group();
    return SlimbvhTriedAny(slimbvh_hit.member.w != 0xffffffffu, slimbvh_overflowed.member != 0u);
}

fn slimbvh_closest_hit_in_group(lane: u32, origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> SlimbvhHit {
    let tried = slimbvh_try_closest_hit(lane, origin, t_min, direction, t_max);
    if tried.overflowed {
        return slimbvh_closest_hit(origin, t_min, direction, t_max);
    }
    return tried.hit;
}

fn slimbvh_any_hit_in_group(lane: u32, origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> bool {
    let tried = slimbvh_try_any_hit(lane, origin, t_min, direction, t_max);
    if tried.overflowed {
        return slimbvh_any_hit(origin, t_min, direction, t_max);
    }
    return tried.found;
}
