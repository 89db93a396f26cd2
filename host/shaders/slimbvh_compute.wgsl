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
    var phi_361_: u32;
    var phi_367_: u32;
    var phi_373_: u32;
    var phi_638_: i32;
    var phi_649_: i32;
    var phi_763_: i32;
    var phi_892_: i32;
    var phi_914_: u32;
    var phi_915_: u32;
    var phi_916_: bool;
    var phi_950_: i32;
    var phi_972_: u32;
    var phi_973_: u32;
    var phi_974_: bool;
    var phi_535_: i32;
    var phi_541_: u32;
    var phi_560_: u32;
    var phi_561_: u32;
    var phi_562_: bool;
    var phi_580_: i32;
    var phi_586_: u32;
    var phi_605_: u32;
    var phi_606_: u32;
    var phi_607_: bool;
    var phi_984_: SlimbvhTypeF;
    var phi_1186_: SlimbvhTypeK;
    var phi_1201_: SlimbvhTypeK;
    var phi_1204_: u32;
    var phi_1206_: u32;
    var phi_1208_: u32;
    var phi_1217_: u32;
    var phi_1220_: u32;
    var phi_1222_: u32;
    var phi_1469_: u32;
    var phi_1485_: u32;
    var phi_1486_: u32;
    var phi_1218_: u32;
    var phi_1221_: u32;
    var phi_1223_: u32;
    var local: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_1502_: SlimbvhTypeK;
    var phi_1505_: SlimbvhTypeA;
    var phi_1506_: SlimbvhTypeA;
    var phi_1528_: SlimbvhTypeA;
    var phi_1607_: array<vec4<f32>, 3>;
    var phi_1608_: array<vec4<f32>, 3>;
    var phi_1682_: array<vec4<f32>, 3>;
    var phi_1683_: array<vec4<f32>, 3>;
    var phi_1706_: array<f32, 3>;
    var phi_1707_: array<f32, 3>;
    var phi_1721_: array<f32, 3>;
    var phi_1722_: array<f32, 3>;
    var phi_1736_: array<f32, 3>;
    var phi_1737_: array<f32, 3>;
    var phi_2053_: f32;
    var phi_2054_: f32;
    var phi_2055_: f32;
    var phi_2056_: f32;
    var phi_2057_: vec3<f32>;
    var phi_2058_: vec3<f32>;
    var phi_2059_: vec3<f32>;
    var phi_2060_: vec3<f32>;
    var phi_2239_: f32;
    var phi_2265_: SlimbvhTypeH;
    var phi_2266_: SlimbvhTypeH;
    var phi_2269_: SlimbvhTypeH;
    var phi_2270_: SlimbvhTypeH;
    var phi_2271_: bool;
    var phi_2275_: SlimbvhTypeH;
    var phi_2284_: SlimbvhTypeC;
    var phi_2309_: bool;
    var phi_2310_: bool;
    var phi_2317_: SlimbvhTypeK;
    var phi_2323_: SlimbvhTypeK;
    var phi_2324_: SlimbvhTypeK;
    var phi_2325_: SlimbvhTypeK;
    var phi_1503_: SlimbvhTypeK;
    var local_3: u32;
    var local_4: SlimbvhTypeK;
    var phi_2347_: SlimbvhTypeK;
    var phi_2348_: u32;
    var phi_2349_: u32;
    var phi_1202_: SlimbvhTypeK;
    var phi_1205_: u32;
    var phi_1207_: u32;
    var phi_1209_: u32;
    var local_5: u32;
    var local_6: SlimbvhTypeK;
    var phi_2384_: f32;
    var phi_2386_: f32;
    var phi_2387_: bool;
    var phi_2388_: f32;
    var phi_2389_: bool;
    var phi_2599_: u32;
    var phi_2617_: bool;
    var phi_2620_: bool;
    var phi_2633_: f32;
    var phi_2634_: f32;
    var phi_2639_: f32;
    var phi_2640_: f32;
    var phi_2641_: bool;
    var phi_2649_: f32;
    var phi_2404_: f32;
    var phi_2405_: f32;
    var phi_2417_: f32;
    var phi_2422_: SlimbvhTypeC;
    var phi_2435_: bool;
    var phi_2436_: bool;
    var phi_2437_: bool;
    var local_7: SlimbvhTypeK;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e74 = SlimbvhTypeC(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e76 = arrayLength((&slimbvh_nodes.member));
    let _e85 = slimbvh_origin.member;
    let _e91 = slimbvh_origin.member[3u];
    let _e92 = slimbvh_direction.member;
    let _e98 = slimbvh_direction.member[3u];
    let _e101 = slimbvh_exponent.member[0u];
    let _e102 = bitcast<i32>(_e101);
    let _e104 = (bitcast<u32>(_e85.x) & 2147483647u);
    let _e106 = (bitcast<u32>(_e85.y) & 2147483647u);
    let _e108 = (bitcast<u32>(_e85.z) & 2147483647u);
    let _e109 = bitcast<u32>(_e91);
    let _e110 = (_e109 & 2147483647u);
    let _e112 = (bitcast<u32>(_e92.x) & 2147483647u);
    let _e114 = (bitcast<u32>(_e92.y) & 2147483647u);
    let _e116 = (bitcast<u32>(_e92.z) & 2147483647u);
    let _e117 = bitcast<u32>(_e98);
    let _e118 = (_e117 & 2147483647u);
    let _e120 = select(_e114, _e112, (_e114 < _e112));
    let _e122 = select(_e116, _e120, (_e116 < _e120));
    let _e124 = select(_e104, _e122, (_e104 < _e122));
    let _e126 = select(_e106, _e124, (_e106 < _e124));
    let _e128 = select(_e108, _e126, (_e108 < _e126));
    let _e135 = (((select(_e110, _e128, (_e110 < _e128)) < 2139095040u) && (_e118 <= 2139095040u)) && (_e122 > 0u));
    if (_e112 == _e122) {
        phi_361_ = 0u;
    } else {
        phi_361_ = select(2u, 1u, (_e114 == _e122));
    }
    let _e140 = phi_361_;
    let _e141 = (_e140 == 2u);
    if _e141 {
        phi_367_ = 0u;
    } else {
        phi_367_ = (_e140 + 1u);
    }
    let _e144 = phi_367_;
    let _e145 = (_e144 == 2u);
    if _e145 {
        phi_373_ = 0u;
    } else {
        phi_373_ = (_e144 + 1u);
    }
    let _e148 = phi_373_;
    let _e149 = (_e144 == 0u);
    let _e151 = select(select(_e85.y, _e85.x, _e149), _e85.z, _e145);
    let _e152 = (_e148 == 0u);
    let _e154 = (_e148 == 2u);
    let _e155 = select(select(_e85.y, _e85.x, _e152), _e85.z, _e154);
    let _e156 = (_e140 == 0u);
    let _e158 = select(select(_e85.y, _e85.x, _e156), _e85.z, _e141);
    let _e160 = select(select(_e92.y, _e92.x, _e149), _e92.z, _e145);
    let _e162 = select(select(_e92.y, _e92.x, _e152), _e92.z, _e154);
    let _e164 = select(select(_e92.y, _e92.x, _e156), _e92.z, _e141);
    let _e165 = (_e110 - 1u);
    let _e166 = (_e118 - 1u);
    let _e168 = select(_e165, _e166, (_e166 < _e165));
    let _e169 = (_e104 - 1u);
    let _e170 = (_e106 - 1u);
    let _e172 = select(_e169, _e170, (_e170 < _e169));
    let _e173 = (_e108 - 1u);
    let _e175 = select(_e172, _e173, (_e173 < _e172));
    let _e176 = (_e112 - 1u);
    let _e177 = (_e114 - 1u);
    let _e179 = select(_e176, _e177, (_e177 < _e176));
    let _e180 = (_e116 - 1u);
    let _e182 = select(_e179, _e180, (_e180 < _e179));
    let _e184 = select(_e175, _e182, (_e182 < _e175));
    if ((((select(_e184, _e168, (_e168 < _e184)) >= 8388607u) && (_e122 < 2130706432u)) && (_e102 >= -126i)) && (_e102 <= 127i)) {
        let _e449 = bitcast<i32>((_e122 >> bitcast<u32>(23i)));
        let _e450 = (_e449 - 127i);
        let _e451 = (_e102 + _e450);
        let _e456 = bitcast<f32>((bitcast<u32>((_e102 + 127i)) << bitcast<u32>(23i)));
        let _e461 = bitcast<f32>((bitcast<u32>((254i - _e449)) << bitcast<u32>(23i)));
        if (_e110 >= 2139095040u) {
            phi_535_ = 255i;
        } else {
            phi_535_ = (bitcast<i32>((_e110 >> bitcast<u32>(23i))) + _e451);
        }
        let _e476 = phi_535_;
        if (_e110 == 0u) {
            phi_541_ = 0u;
        } else {
            phi_541_ = (_e110 | 8388608u);
        }
        let _e480 = phi_541_;
        if (_e476 <= 0i) {
            phi_561_ = u32();
            phi_562_ = true;
        } else {
            let _e487 = (_e480 == 0u);
            if _e487 {
                phi_560_ = u32();
            } else {
                phi_560_ = select(((bitcast<u32>(_e476) << bitcast<u32>(23i)) | (_e480 & 8388607u)), 2139095039u, (_e476 >= 255i));
            }
            let _e491 = phi_560_;
            phi_561_ = _e491;
            phi_562_ = _e487;
        }
        let _e493 = phi_561_;
        let _e495 = phi_562_;
        if (_e118 >= 2139095040u) {
            phi_580_ = 255i;
        } else {
            phi_580_ = (bitcast<i32>((_e118 >> bitcast<u32>(23i))) + _e451);
        }
        let _e506 = phi_580_;
        if (_e118 == 0u) {
            phi_586_ = 0u;
        } else {
            phi_586_ = (_e118 | 8388608u);
        }
        let _e510 = phi_586_;
        if (_e506 <= 0i) {
            phi_606_ = u32();
            phi_607_ = true;
        } else {
            let _e517 = (_e510 == 0u);
            if _e517 {
                phi_605_ = u32();
            } else {
                phi_605_ = select(((bitcast<u32>(_e506) << bitcast<u32>(23i)) | (_e510 & 8388607u)), 2139095039u, (_e506 >= 255i));
            }
            let _e521 = phi_605_;
            phi_606_ = _e521;
            phi_607_ = _e517;
        }
        let _e523 = phi_606_;
        let _e525 = phi_607_;
        phi_984_ = SlimbvhTypeF(array<f32, 3>((_e151 * _e456), (_e155 * _e456), (_e158 * _e456)), array<f32, 3>((_e160 * _e461), (_e162 * _e461), (_e164 * _e461)), bitcast<f32>(((_e109 & 2147483648u) | select(_e493, 0u, _e495))), bitcast<f32>(((_e117 & 2147483648u) | select(_e523, 0u, _e525))), _e450);
    } else {
        let _e197 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e122, _e135))) & 2147483647u);
        if (_e197 >= 8388608u) {
            phi_638_ = (bitcast<i32>((_e197 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_638_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e197)), 32u, (_e197 == 0u))));
        }
        let _e211 = phi_638_;
        let _e212 = (_e102 + _e211);
        if (_e102 < -126i) {
            phi_649_ = -126i;
        } else {
            phi_649_ = select(_e102, 127i, (_e102 > 127i));
        }
        let _e217 = phi_649_;
        let _e222 = bitcast<f32>((bitcast<u32>((_e217 + 127i)) << bitcast<u32>(23i)));
        let _e228 = bitcast<f32>((bitcast<u32>(((_e102 - _e217) + 127i)) << bitcast<u32>(23i)));
        let _e229 = bitcast<u32>(_e151);
        let _e231 = ((_e229 & 2139095040u) != 0u);
        let _e246 = bitcast<u32>(_e155);
        let _e248 = ((_e246 & 2139095040u) != 0u);
        let _e263 = bitcast<u32>(_e158);
        let _e265 = ((_e263 & 2139095040u) != 0u);
        let _e281 = -(_e211);
        if (_e281 < -126i) {
            phi_763_ = -126i;
        } else {
            phi_763_ = select(_e281, 127i, (_e281 > 127i));
        }
        let _e286 = phi_763_;
        let _e291 = bitcast<f32>((bitcast<u32>((_e286 + 127i)) << bitcast<u32>(23i)));
        let _e297 = bitcast<f32>((bitcast<u32>(((_e281 - _e286) + 127i)) << bitcast<u32>(23i)));
        let _e298 = bitcast<u32>(_e160);
        let _e300 = ((_e298 & 2139095040u) != 0u);
        let _e315 = bitcast<u32>(_e162);
        let _e317 = ((_e315 & 2139095040u) != 0u);
        let _e332 = bitcast<u32>(_e164);
        let _e334 = ((_e332 & 2139095040u) != 0u);
        let _e356 = ((_e110 & 8388607u) | (select(0u, 1u, ((_e110 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e359 = bitcast<i32>((_e110 >> bitcast<u32>(23i)));
        let _e366 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e356)), 32u, (_e356 == 0u))) - 8i);
        if (_e359 == 255i) {
            phi_892_ = 255i;
        } else {
            phi_892_ = (((_e359 + select(0i, 1i, (_e359 == 0i))) - _e366) + _e212);
        }
        let _e374 = phi_892_;
        let _e378 = (_e356 << bitcast<u32>(((_e366 & 31i) & 31i)));
        if (_e374 <= 0i) {
            phi_915_ = u32();
            phi_916_ = true;
        } else {
            let _e385 = (_e378 == 0u);
            if _e385 {
                phi_914_ = u32();
            } else {
                phi_914_ = select(((bitcast<u32>(_e374) << bitcast<u32>(23i)) | (_e378 & 8388607u)), 2139095039u, (_e374 >= 255i));
            }
            let _e389 = phi_914_;
            phi_915_ = _e389;
            phi_916_ = _e385;
        }
        let _e391 = phi_915_;
        let _e393 = phi_916_;
        let _e404 = ((_e118 & 8388607u) | (select(0u, 1u, ((_e118 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e407 = bitcast<i32>((_e118 >> bitcast<u32>(23i)));
        let _e414 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e404)), 32u, (_e404 == 0u))) - 8i);
        if (_e407 == 255i) {
            phi_950_ = 255i;
        } else {
            phi_950_ = (((_e407 + select(0i, 1i, (_e407 == 0i))) - _e414) + _e212);
        }
        let _e422 = phi_950_;
        let _e426 = (_e404 << bitcast<u32>(((_e414 & 31i) & 31i)));
        if (_e422 <= 0i) {
            phi_973_ = u32();
            phi_974_ = true;
        } else {
            let _e433 = (_e426 == 0u);
            if _e433 {
                phi_972_ = u32();
            } else {
                phi_972_ = select(((bitcast<u32>(_e422) << bitcast<u32>(23i)) | (_e426 & 8388607u)), 2139095039u, (_e422 >= 255i));
            }
            let _e437 = phi_972_;
            phi_973_ = _e437;
            phi_974_ = _e433;
        }
        let _e439 = phi_973_;
        let _e441 = phi_974_;
        phi_984_ = SlimbvhTypeF(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e229 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e229 & 2147483648u))), _e151, _e231) * _e222) * select(0.00000011920929f, 1f, _e231)) * _e228), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e246 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e246 & 2147483648u))), _e155, _e248) * _e222) * select(0.00000011920929f, 1f, _e248)) * _e228), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e263 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e263 & 2147483648u))), _e158, _e265) * _e222) * select(0.00000011920929f, 1f, _e265)) * _e228)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e298 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e298 & 2147483648u))), _e160, _e300) * _e291) * select(0.00000011920929f, 1f, _e300)) * _e297), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e162, _e317) * _e291) * select(0.00000011920929f, 1f, _e317)) * _e297), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e332 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e332 & 2147483648u))), _e164, _e334) * _e291) * select(0.00000011920929f, 1f, _e334)) * _e297)), bitcast<f32>(((_e109 & 2147483648u) | select(_e391, 0u, _e393))), bitcast<f32>(((_e117 & 2147483648u) | select(_e439, 0u, _e441))), _e211);
    }
    let _e532 = phi_984_;
    let _e547 = (bitcast<f32>((bitcast<u32>(_e532.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e550 = bitcast<f32>((bitcast<u32>(_e532.member[0]) & 2147483647u));
    let _e551 = (_e550 * 0.00000011920929f);
    let _e554 = select(select(0.00000000000011368684f, _e551, (_e551 > 0.00000000000011368684f)), 0f, _e547);
    let _e555 = select(0f, _e532.member_1[0], _e547);
    let _e556 = (_e532.member[0] + _e554);
    let _e557 = (_e532.member[0] - _e554);
    let _e559 = select(38685626000000000000000000f, (1f / _e532.member_1[0]), _e547);
    let _e563 = (bitcast<f32>((bitcast<u32>(_e532.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e566 = bitcast<f32>((bitcast<u32>(_e532.member[1]) & 2147483647u));
    let _e567 = (_e566 * 0.00000011920929f);
    let _e570 = select(select(0.00000000000011368684f, _e567, (_e567 > 0.00000000000011368684f)), 0f, _e563);
    let _e571 = select(0f, _e532.member_1[1], _e563);
    let _e572 = (_e532.member[1] + _e570);
    let _e573 = (_e532.member[1] - _e570);
    let _e575 = select(38685626000000000000000000f, (1f / _e532.member_1[1]), _e563);
    let _e579 = (bitcast<f32>((bitcast<u32>(_e532.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e582 = bitcast<f32>((bitcast<u32>(_e532.member[2]) & 2147483647u));
    let _e583 = (_e582 * 0.00000011920929f);
    let _e586 = select(select(0.00000000000011368684f, _e583, (_e583 > 0.00000000000011368684f)), 0f, _e579);
    let _e587 = select(0f, _e532.member_1[2], _e579);
    let _e588 = (_e532.member[2] + _e586);
    let _e589 = (_e532.member[2] - _e586);
    let _e591 = select(38685626000000000000000000f, (1f / _e532.member_1[2]), _e579);
    let _e593 = select(_e566, _e550, (_e550 > _e566));
    let _e597 = (_e135 && (select(_e582, _e593, (_e593 > _e582)) <= 1099511600000f));
    let _e598 = select(0f, _e532.member_3, _e597);
    let _e599 = select(1f, _e532.member_2, _e597);
    let _e601 = slimbvh_lane.member;
    if (_e601 < 64u) {
        let _e603 = (_e601 % 64u);
        let _e604 = slimbvh_any_will_do.member;
        if (_e604 == 1u) {
            phi_1186_ = SlimbvhTypeK(SlimbvhTypeG(_e74, _e598), true);
        } else {
            phi_1186_ = SlimbvhTypeK(SlimbvhTypeG(_e74, _e598), false);
        }
        let _e611 = phi_1186_;
        phi_1201_ = _e611;
        phi_1204_ = 0u;
        phi_1206_ = select(4294967295u, 0u, (_e599 <= _e598));
        phi_1208_ = (_e76 + 1u);
        loop {
            let _e620 = phi_1201_;
            let _e622 = phi_1204_;
            let _e624 = phi_1206_;
            let _e626 = phi_1208_;
            local_5 = _e624;
            local_6 = _e620;
            let _e627 = (_e624 <= 32u);
            if _e627 {
                phi_1217_ = _e622;
                phi_1220_ = _e624;
                phi_1222_ = _e626;
                loop {
                    let _e629 = phi_1217_;
                    let _e631 = phi_1220_;
                    let _e633 = phi_1222_;
                    local_1 = _e629;
                    local_2 = _e629;
                    local_3 = _e631;
                    local_8 = _e629;
                    local_9 = _e631;
                    local_10 = _e633;
                    let _e634 = (_e631 <= 32u);
                    let _e637 = (_e634 && !((_e629 >= _e76)));
                    local = _e634;
                    if _e637 {
                        let _e642 = slimbvh_nodes.member[_e629][3u][0u];
                        let _e647 = slimbvh_nodes.member[_e629][3u][1u];
                        let _e652 = slimbvh_nodes.member[_e629][((_e144 & 3u) % 4u)];
                        let _e657 = slimbvh_nodes.member[_e629][((_e148 & 3u) % 4u)];
                        let _e662 = slimbvh_nodes.member[_e629][((_e140 & 3u) % 4u)];
                        let _e663 = bitcast<u32>(_e642);
                        let _e664 = bitcast<u32>(_e647);
                        let _e675 = ((_e652.x - _e556) * _e559);
                        let _e676 = ((_e652.y - _e556) * _e559);
                        let _e677 = ((_e652.z - _e557) * _e559);
                        let _e678 = ((_e652.w - _e557) * _e559);
                        let _e687 = ((_e657.x - _e572) * _e575);
                        let _e688 = ((_e657.y - _e572) * _e575);
                        let _e689 = ((_e657.z - _e573) * _e575);
                        let _e690 = ((_e657.w - _e573) * _e575);
                        let _e699 = ((_e662.x - _e588) * _e591);
                        let _e700 = ((_e662.y - _e588) * _e591);
                        let _e701 = ((_e662.z - _e589) * _e591);
                        let _e702 = ((_e662.w - _e589) * _e591);
                        let _e703 = min(_e699, _e701);
                        let _e704 = min(_e700, _e702);
                        let _e705 = max(_e699, _e701);
                        let _e706 = max(_e700, _e702);
                        let _e731 = max(max(max(min(_e675, _e677), min(_e687, _e689)), _e703), _e599);
                        let _e732 = max(max(max(min(_e676, _e678), min(_e688, _e690)), _e704), _e599);
                        let _e735 = (_e731 <= min((min(min(max(_e675, _e677), max(_e687, _e689)), _e705) + (max(_e705, -(_e703)) * 0.0000019073523f)), _e620.member.member_1));
                        let _e736 = (_e732 <= min((min(min(max(_e676, _e678), max(_e688, _e690)), _e706) + (max(_e706, -(_e704)) * 0.0000019073523f)), _e620.member.member_1));
                        if (_e735 || _e736) {
                            let _e748 = (_e735 && (((_e731 <= _e732) != _e611.member_1) || !(_e736)));
                            if (_e735 && _e736) {
                                slimbvh_stacks[(((_e631 % 32u) * 64u) + _e603)] = select(_e663, _e664, _e748);
                                phi_1469_ = (_e631 + 1u);
                            } else {
                                phi_1469_ = _e631;
                            }
                            let _e758 = phi_1469_;
                            phi_1485_ = select(_e664, _e663, _e748);
                            phi_1486_ = _e758;
                        } else {
                            let _e740 = (_e631 - 1u);
                            let _e745 = slimbvh_stacks[(((_e740 % 32u) * 64u) + _e603)];
                            phi_1485_ = _e745;
                            phi_1486_ = _e740;
                        }
                        let _e760 = phi_1485_;
                        let _e762 = phi_1486_;
                        let _e763 = (_e633 - 1u);
                        phi_1218_ = _e760;
                        phi_1221_ = select(_e762, 4294967295u, (_e763 == 0u));
                        phi_1223_ = _e763;
                    } else {
                        phi_1218_ = u32();
                        phi_1221_ = u32();
                        phi_1223_ = u32();
                    }
                    let _e767 = phi_1218_;
                    let _e769 = phi_1221_;
                    let _e771 = phi_1223_;
                    continue;
                    continuing {
                        phi_1217_ = _e767;
                        phi_1220_ = _e769;
                        phi_1222_ = _e771;
                        break if !(_e637);
                    }
                }
                let _e774 = local;
                if _e774 {
                    let _e776 = local_1;
                    let _e779 = local_2;
                    phi_1502_ = _e620;
                    phi_1505_ = SlimbvhTypeA(0u, ((_e779 >> bitcast<u32>(28u)) & 7u));
                    loop {
                        let _e785 = phi_1502_;
                        let _e787 = phi_1505_;
                        local_4 = _e785;
                        local_7 = _e785;
                        if (_e787.member < _e787.member_1) {
                            phi_1506_ = SlimbvhTypeA((_e787.member + 1u), _e787.member_1);
                            phi_1528_ = SlimbvhTypeA(1u, _e787.member);
                        } else {
                            phi_1506_ = _e787;
                            phi_1528_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                        }
                        let _e800 = phi_1506_;
                        let _e802 = phi_1528_;
                        let _e806 = (bitcast<i32>(_e802.member) != 0i);
                        if _e806 {
                            let _e807 = ((_e776 & 268435455u) + _e802.member_1);
                            let _e808 = (_e807 / 2u);
                            let _e809 = (_e807 % 2u);
                            let _e810 = (_e808 >= arrayLength((&slimbvh_triangles.member)));
                            if _e810 {
                                phi_1608_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e811 = (2u * _e809);
                                let _e815 = slimbvh_triangles.member[_e808][_e811];
                                let _e820 = slimbvh_triangles.member[_e808][(_e811 + 1u)];
                                let _e825 = slimbvh_triangles.member[_e808][(_e811 + 2u)];
                                if (_e809 == 0u) {
                                    phi_1607_ = array<vec4<f32>, 3>(_e815, _e820, _e825);
                                } else {
                                    phi_1607_ = array<vec4<f32>, 3>(vec4<f32>(_e815.z, _e815.w, _e820.x, _e820.y), vec4<f32>(_e820.z, _e820.w, _e825.x, _e825.y), vec4<f32>(_e825.z, _e825.w, 0f, 0f));
                                }
                                let _e843 = phi_1607_;
                                phi_1608_ = _e843;
                            }
                            let _e845 = phi_1608_;
                            let _e848 = bitcast<u32>(_e845[2].y);
                            if _e810 {
                                phi_1683_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e849 = (2u * _e809);
                                let _e853 = slimbvh_triangles.member[_e808][_e849];
                                let _e858 = slimbvh_triangles.member[_e808][(_e849 + 1u)];
                                let _e863 = slimbvh_triangles.member[_e808][(_e849 + 2u)];
                                if (_e809 == 0u) {
                                    phi_1682_ = array<vec4<f32>, 3>(_e853, _e858, _e863);
                                } else {
                                    phi_1682_ = array<vec4<f32>, 3>(vec4<f32>(_e853.z, _e853.w, _e858.x, _e858.y), vec4<f32>(_e858.z, _e858.w, _e863.x, _e863.y), vec4<f32>(_e863.z, _e863.w, 0f, 0f));
                                }
                                let _e881 = phi_1682_;
                                phi_1683_ = _e881;
                            }
                            let _e883 = phi_1683_;
                            if _e149 {
                                phi_1707_ = array<f32, 3>(_e883[0].x, _e883[0].y, _e883[0].z);
                            } else {
                                if (_e144 == 1u) {
                                    phi_1706_ = array<f32, 3>(_e883[0].y, _e883[0].z, _e883[0].x);
                                } else {
                                    phi_1706_ = array<f32, 3>(_e883[0].z, _e883[0].x, _e883[0].y);
                                }
                                let _e906 = phi_1706_;
                                phi_1707_ = _e906;
                            }
                            let _e909 = phi_1707_;
                            if _e149 {
                                phi_1722_ = array<f32, 3>(_e883[0].w, _e883[1].x, _e883[1].y);
                            } else {
                                if (_e144 == 1u) {
                                    phi_1721_ = array<f32, 3>(_e883[1].x, _e883[1].y, _e883[0].w);
                                } else {
                                    phi_1721_ = array<f32, 3>(_e883[1].y, _e883[0].w, _e883[1].x);
                                }
                                let _e914 = phi_1721_;
                                phi_1722_ = _e914;
                            }
                            let _e917 = phi_1722_;
                            if _e149 {
                                phi_1737_ = array<f32, 3>(_e883[1].z, _e883[1].w, _e883[2].x);
                            } else {
                                if (_e144 == 1u) {
                                    phi_1736_ = array<f32, 3>(_e883[1].w, _e883[2].x, _e883[1].z);
                                } else {
                                    phi_1736_ = array<f32, 3>(_e883[2].x, _e883[1].z, _e883[1].w);
                                }
                                let _e922 = phi_1736_;
                                phi_1737_ = _e922;
                            }
                            let _e925 = phi_1737_;
                            let _e939 = (_e909[2] - _e532.member[2]);
                            let _e942 = (((_e909[0] - _e532.member[0]) * _e587) - (_e939 * _e555));
                            let _e945 = (((_e909[1] - _e532.member[1]) * _e587) - (_e939 * _e571));
                            let _e948 = (_e917[2] - _e532.member[2]);
                            let _e951 = (((_e917[0] - _e532.member[0]) * _e587) - (_e948 * _e555));
                            let _e954 = (((_e917[1] - _e532.member[1]) * _e587) - (_e948 * _e571));
                            let _e957 = (_e925[2] - _e532.member[2]);
                            let _e960 = (((_e925[0] - _e532.member[0]) * _e587) - (_e957 * _e555));
                            let _e963 = (((_e925[1] - _e532.member[1]) * _e587) - (_e957 * _e571));
                            let _e964 = (_e960 * _e954);
                            let _e965 = (_e963 * _e951);
                            let _e966 = (_e942 * _e963);
                            let _e967 = (_e945 * _e960);
                            let _e968 = (_e951 * _e945);
                            let _e969 = (_e954 * _e942);
                            let _e974 = (((_e964 >= _e965) && (_e966 >= _e967)) && (_e968 >= _e969));
                            let _e980 = (_e974 || (((_e964 <= _e965) && (_e966 <= _e967)) && (_e968 <= _e969)));
                            if _e980 {
                                let _e982 = select(-1f, 1f, _e974);
                                let _e984 = ((_e964 - _e965) * _e982);
                                let _e986 = select(0f, _e984, (_e984 > 0f));
                                let _e988 = ((_e966 - _e967) * _e982);
                                let _e990 = select(0f, _e988, (_e988 > 0f));
                                let _e992 = ((_e968 - _e969) * _e982);
                                let _e994 = select(0f, _e992, (_e992 > 0f));
                                let _e996 = ((_e986 + _e990) + _e994);
                                let _e1011 = ((min(min(_e909[0], _e917[0]), _e925[0]) - _e556) * _e559);
                                let _e1012 = ((max(max(_e909[0], _e917[0]), _e925[0]) - _e557) * _e559);
                                let _e1015 = ((min(min(_e909[1], _e917[1]), _e925[1]) - _e572) * _e575);
                                let _e1016 = ((max(max(_e909[1], _e917[1]), _e925[1]) - _e573) * _e575);
                                let _e1019 = ((min(min(_e909[2], _e917[2]), _e925[2]) - _e588) * _e591);
                                let _e1020 = ((max(max(_e909[2], _e917[2]), _e925[2]) - _e589) * _e591);
                                let _e1021 = min(_e1019, _e1020);
                                let _e1022 = max(_e1019, _e1020);
                                let _e1026 = max(max(min(_e1011, _e1012), min(_e1015, _e1016)), _e1021);
                                let _e1030 = min(min(max(_e1011, _e1012), max(_e1015, _e1016)), _e1022);
                                let _e1035 = max(_e1026, _e599);
                                let _e1057 = (((((_e980 && (_e996 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e942, _e951), _e960) <= 0f) && (max(max(_e942, _e951), _e960) >= 0f))) && ((min(min(_e945, _e954), _e963) <= 0f) && (max(max(_e945, _e954), _e963) >= 0f))) && (_e1035 <= (_e1030 + (max(_e1022, -(_e1021)) * 0.0000019073523f)))) && (_e1035 <= _e785.member.member_1));
                                if _e1057 {
                                    let _e1062 = (_e917[0] - _e909[0]);
                                    let _e1063 = (_e917[1] - _e909[1]);
                                    let _e1064 = (_e917[2] - _e909[2]);
                                    let _e1065 = vec3<f32>(_e1062, _e1063, _e1064);
                                    let _e1066 = (_e925[0] - _e917[0]);
                                    let _e1067 = (_e925[1] - _e917[1]);
                                    let _e1068 = (_e925[2] - _e917[2]);
                                    let _e1069 = vec3<f32>(_e1066, _e1067, _e1068);
                                    let _e1070 = (_e909[0] - _e925[0]);
                                    let _e1071 = (_e909[1] - _e925[1]);
                                    let _e1072 = (_e909[2] - _e925[2]);
                                    let _e1073 = vec3<f32>(_e1070, _e1071, _e1072);
                                    let _e1084 = max(max(bitcast<f32>((bitcast<u32>(_e1062) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1063) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1064) & 2147483647u)));
                                    let _e1095 = max(max(bitcast<f32>((bitcast<u32>(_e1066) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1067) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1068) & 2147483647u)));
                                    let _e1108 = max(max(_e1084, _e1095), max(max(bitcast<f32>((bitcast<u32>(_e1070) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1071) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1072) & 2147483647u))));
                                    if (_e1084 == _e1108) {
                                        phi_2053_ = _e954;
                                        phi_2054_ = _e951;
                                        phi_2055_ = _e945;
                                        phi_2056_ = _e942;
                                        phi_2057_ = vec3<f32>(_e909[0], _e909[1], _e909[2]);
                                        phi_2058_ = _e1073;
                                        phi_2059_ = _e1069;
                                        phi_2060_ = _e1065;
                                    } else {
                                        let _e1110 = (_e1095 == _e1108);
                                        let _e1115 = vec3(_e1110);
                                        phi_2053_ = select(_e945, _e963, _e1110);
                                        phi_2054_ = select(_e942, _e960, _e1110);
                                        phi_2055_ = select(_e963, _e954, _e1110);
                                        phi_2056_ = select(_e960, _e951, _e1110);
                                        phi_2057_ = select(vec3<f32>(_e925[0], _e925[1], _e925[2]), vec3<f32>(_e917[0], _e917[1], _e917[2]), _e1115);
                                        phi_2058_ = select(_e1069, _e1065, _e1115);
                                        phi_2059_ = select(_e1065, _e1073, _e1115);
                                        phi_2060_ = select(_e1073, _e1069, _e1115);
                                    }
                                    let _e1121 = phi_2053_;
                                    let _e1123 = phi_2054_;
                                    let _e1125 = phi_2055_;
                                    let _e1127 = phi_2056_;
                                    let _e1129 = phi_2057_;
                                    let _e1131 = phi_2058_;
                                    let _e1133 = phi_2059_;
                                    let _e1135 = phi_2060_;
                                    let _e1142 = ((_e1133.y * _e1131.z) - (_e1131.y * _e1133.z));
                                    let _e1147 = ((_e1133.z * _e1131.x) - (_e1131.z * _e1133.x));
                                    let _e1150 = ((_e1133.x * _e1131.y) - (_e1131.x * _e1133.y));
                                    let _e1153 = ((_e986 >= _e990) && (_e986 >= _e994));
                                    let _e1154 = (_e990 >= _e994);
                                    let _e1168 = (((_e1142 * (select(select(_e925[0], _e917[0], _e1154), _e909[0], _e1153) - _e532.member[0])) + (_e1147 * (select(select(_e925[1], _e917[1], _e1154), _e909[1], _e1153) - _e532.member[1]))) + (_e1150 * (select(select(_e925[2], _e917[2], _e1154), _e909[2], _e1153) - _e532.member[2])));
                                    let _e1173 = (((_e1142 * _e555) + (_e1147 * _e571)) + (_e1150 * _e587));
                                    let _e1174 = (_e1123 - _e1127);
                                    let _e1175 = (_e1121 - _e1125);
                                    let _e1178 = ((_e1174 * _e1174) + (_e1175 * _e1175));
                                    let _e1185 = (-(((_e1127 * _e1174) + (_e1125 * _e1175))) / select(0.000000000000000000000000000000000000011754944f, _e1178, (_e1178 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e1187 = select(1f, _e1185, (_e1185 < 1f));
                                    let _e1189 = select(0f, _e1187, (_e1187 > 0f));
                                    let _e1198 = ((_e1129.x + (_e1135.x * _e1189)) - _e532.member[0]);
                                    let _e1201 = ((_e1129.y + (_e1135.y * _e1189)) - _e532.member[1]);
                                    let _e1204 = ((_e1129.z + (_e1135.z * _e1189)) - _e532.member[2]);
                                    let _e1269 = ((bitcast<f32>((bitcast<u32>(((((_e1142 * _e1198) + (_e1147 * _e1201)) + (_e1150 * _e1204)) - _e1168)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1198) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1201) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1204) & 2147483647u))), _e1108)) * max(max(bitcast<f32>((bitcast<u32>(_e1142) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1147) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1150) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1173) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1133.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1133.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1133.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1131.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1131.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1131.z) & 2147483647u)))))));
                                    let _e1270 = (_e1168 / _e1173);
                                    if (_e1057 && !(_e1269)) {
                                        let _e1273 = (_e1204 / _e587);
                                        let _e1281 = (((_e1142 * (_e1198 - (_e555 * _e1273))) + (_e1147 * (_e1201 - (_e571 * _e1273)))) / _e1173);
                                        phi_2239_ = select(select(_e1273, (_e1273 + _e1281), (bitcast<f32>((bitcast<u32>(_e1281) & 2147483647u)) <= _e1108)), _e1270, _e1269);
                                    } else {
                                        phi_2239_ = _e1270;
                                    }
                                    let _e1290 = phi_2239_;
                                    let _e1292 = select(_e1030, _e1290, (_e1290 < _e1030));
                                    let _e1294 = select(_e1026, _e1292, (_e1292 > _e1026));
                                    let _e1297 = select(_e1294, 0f, (bitcast<u32>(_e1294) == 2147483648u));
                                    let _e1298 = (1f / _e996);
                                    phi_2265_ = SlimbvhTypeH(_e1297, (_e990 * _e1298), (_e994 * _e1298), ((_e1057 && (_e1297 >= _e599)) && (_e1297 <= _e785.member.member_1)));
                                    phi_2266_ = SlimbvhTypeH();
                                } else {
                                    phi_2265_ = SlimbvhTypeH();
                                    phi_2266_ = SlimbvhTypeH(0f, 0f, 0f, _e1057);
                                }
                                let _e1307 = phi_2265_;
                                let _e1309 = phi_2266_;
                                phi_2269_ = _e1307;
                                phi_2270_ = _e1309;
                                phi_2271_ = select(true, false, _e1057);
                            } else {
                                phi_2269_ = SlimbvhTypeH();
                                phi_2270_ = SlimbvhTypeH(0f, 0f, 0f, _e980);
                                phi_2271_ = true;
                            }
                            let _e1312 = phi_2269_;
                            let _e1314 = phi_2270_;
                            let _e1316 = phi_2271_;
                            if _e1316 {
                                phi_2275_ = _e1314;
                            } else {
                                phi_2275_ = _e1312;
                            }
                            let _e1318 = phi_2275_;
                            if _e1318.member_3 {
                                phi_2284_ = SlimbvhTypeC(_e1318.member, _e1318.member_1, _e1318.member_2, _e848);
                            } else {
                                phi_2284_ = _e74;
                            }
                            let _e1325 = phi_2284_;
                            if (_e1325.member_3 != 4294967295u) {
                                if (_e848 != 4294967295u) {
                                    if (_e1325.member < _e785.member.member.member) {
                                        phi_2310_ = true;
                                    } else {
                                        if (_e1325.member == _e785.member.member.member) {
                                            phi_2309_ = (_e1325.member_3 < _e785.member.member.member_3);
                                        } else {
                                            phi_2309_ = false;
                                        }
                                        let _e1340 = phi_2309_;
                                        phi_2310_ = _e1340;
                                    }
                                    let _e1342 = phi_2310_;
                                    if _e1342 {
                                        phi_2317_ = SlimbvhTypeK(SlimbvhTypeG(_e1325, _e1325.member), _e785.member_1);
                                    } else {
                                        phi_2317_ = _e785;
                                    }
                                    let _e1348 = phi_2317_;
                                    if _e1348.member_1 {
                                        phi_2323_ = SlimbvhTypeK(SlimbvhTypeG(_e1348.member.member, bitcast<f32>(4286578687u)), _e1348.member_1);
                                    } else {
                                        phi_2323_ = _e1348;
                                    }
                                    let _e1357 = phi_2323_;
                                    phi_2324_ = _e1357;
                                } else {
                                    phi_2324_ = _e785;
                                }
                                let _e1359 = phi_2324_;
                                phi_2325_ = _e1359;
                            } else {
                                phi_2325_ = _e785;
                            }
                            let _e1361 = phi_2325_;
                            phi_1503_ = _e1361;
                        } else {
                            phi_1503_ = SlimbvhTypeK();
                        }
                        let _e1363 = phi_1503_;
                        continue;
                        continuing {
                            phi_1502_ = _e1363;
                            phi_1505_ = _e800;
                            break if !(_e806);
                        }
                    }
                    let _e1366 = local_3;
                    let _e1367 = (_e1366 - 1u);
                    let _e1372 = slimbvh_stacks[(((_e1367 % 32u) * 64u) + _e603)];
                    let _e1374 = local_4;
                    let _e1624 = local_7;
                    phi_2347_ = _e1624;
                    phi_2348_ = _e1372;
                    phi_2349_ = select(_e1367, 4294967295u, (_e599 > _e1374.member.member_1));
                } else {
                    phi_2347_ = _e620;
                    let _e1627 = local_8;
                    phi_2348_ = _e1627;
                    let _e1630 = local_9;
                    phi_2349_ = _e1630;
                }
                let _e1380 = phi_2347_;
                let _e1382 = phi_2348_;
                let _e1384 = phi_2349_;
                phi_1202_ = _e1380;
                phi_1205_ = _e1382;
                phi_1207_ = _e1384;
                let _e1636 = local_10;
                phi_1209_ = _e1636;
            } else {
                phi_1202_ = SlimbvhTypeK();
                phi_1205_ = u32();
                phi_1207_ = u32();
                phi_1209_ = u32();
            }
            let _e1386 = phi_1202_;
            let _e1388 = phi_1205_;
            let _e1390 = phi_1207_;
            let _e1392 = phi_1209_;
            continue;
            continuing {
                phi_1201_ = _e1386;
                phi_1204_ = _e1388;
                phi_1206_ = _e1390;
                phi_1208_ = _e1392;
                break if !(_e627);
            }
        }
        let _e1395 = local_5;
        let _e1396 = (_e1395 == 4294967295u);
        let _e1398 = local_6;
        if (_e1398.member.member.member_3 != 4294967295u) {
            let _e1404 = -((_e102 + _e532.member_4));
            let _e1405 = bitcast<u32>(_e1398.member.member.member);
            let _e1409 = (bitcast<i32>((_e1405 >> bitcast<u32>(23i))) & 255i);
            let _e1410 = (_e1409 + _e1404);
            if (_e1409 == 255i) {
                phi_2405_ = _e1398.member.member.member;
            } else {
                if (_e1409 > 0i) {
                    if (_e1410 > 0i) {
                        let _e1414 = (_e1410 < 255i);
                        if _e1414 {
                            phi_2384_ = bitcast<f32>((_e1405 + bitcast<u32>((_e1404 << bitcast<u32>(23i)))));
                        } else {
                            phi_2384_ = f32();
                        }
                        let _e1421 = phi_2384_;
                        phi_2386_ = _e1421;
                        phi_2387_ = select(true, false, _e1414);
                    } else {
                        phi_2386_ = f32();
                        phi_2387_ = true;
                    }
                    let _e1424 = phi_2386_;
                    let _e1426 = phi_2387_;
                    phi_2388_ = _e1424;
                    phi_2389_ = _e1426;
                } else {
                    phi_2388_ = f32();
                    phi_2389_ = true;
                }
                let _e1428 = phi_2388_;
                let _e1430 = phi_2389_;
                if _e1430 {
                    let _e1431 = (_e1405 & 2147483648u);
                    let _e1438 = ((_e1405 & 8388607u) | (select(0u, 1u, ((_e1405 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e1442 = (_e1438 == 0u);
                    if _e1442 {
                        phi_2649_ = bitcast<f32>(_e1431);
                    } else {
                        let _e1447 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1438)), 32u, _e1442) - 8u);
                        let _e1450 = (_e1438 << bitcast<u32>((_e1447 & 31u)));
                        let _e1452 = ((_e1410 + select(0i, 1i, (_e1409 == 0i))) - bitcast<i32>(_e1447));
                        if (_e1452 >= 255i) {
                            phi_2639_ = bitcast<f32>((_e1431 | 2139095040u));
                            phi_2640_ = f32();
                            phi_2641_ = true;
                        } else {
                            let _e1454 = (_e1452 > 0i);
                            if _e1454 {
                                phi_2633_ = bitcast<f32>(((_e1431 | (bitcast<u32>(_e1452) << bitcast<u32>(23i))) | (_e1450 & 8388607u)));
                                phi_2634_ = f32();
                            } else {
                                if (_e1452 < -24i) {
                                    phi_2599_ = 26u;
                                } else {
                                    phi_2599_ = bitcast<u32>((1i - _e1452));
                                }
                                let _e1459 = phi_2599_;
                                let _e1460 = (_e1459 & 31u);
                                let _e1462 = (_e1450 >> bitcast<u32>(_e1460));
                                let _e1466 = (_e1450 & ((1u << bitcast<u32>(_e1460)) - 1u));
                                let _e1470 = (1u << bitcast<u32>(((_e1459 - 1u) & 31u)));
                                if (_e1466 > _e1470) {
                                    phi_2620_ = true;
                                } else {
                                    if (_e1466 == _e1470) {
                                        phi_2617_ = ((_e1462 & 1u) == 1u);
                                    } else {
                                        phi_2617_ = false;
                                    }
                                    let _e1476 = phi_2617_;
                                    phi_2620_ = _e1476;
                                }
                                let _e1478 = phi_2620_;
                                phi_2633_ = f32();
                                phi_2634_ = bitcast<f32>((_e1431 | (_e1462 + select(0u, 1u, _e1478))));
                            }
                            let _e1491 = phi_2633_;
                            let _e1493 = phi_2634_;
                            phi_2639_ = _e1491;
                            phi_2640_ = _e1493;
                            phi_2641_ = _e1454;
                        }
                        let _e1497 = phi_2639_;
                        let _e1499 = phi_2640_;
                        let _e1501 = phi_2641_;
                        phi_2649_ = select(_e1499, _e1497, _e1501);
                    }
                    let _e1505 = phi_2649_;
                    phi_2404_ = _e1505;
                } else {
                    phi_2404_ = _e1428;
                }
                let _e1507 = phi_2404_;
                phi_2405_ = _e1507;
            }
            let _e1509 = phi_2405_;
            let _e1510 = bitcast<u32>(_e1509);
            if ((_e1510 & 2147483647u) >= 2139095040u) {
                phi_2417_ = bitcast<f32>(((_e1510 & 2147483648u) | 2139095039u));
            } else {
                phi_2417_ = _e1509;
            }
            let _e1517 = phi_2417_;
            phi_2422_ = SlimbvhTypeC(_e1517, _e1398.member.member.member_1, _e1398.member.member.member_2, _e1398.member.member.member_3);
        } else {
            phi_2422_ = _e74;
        }
        let _e1522 = phi_2422_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1522.member), bitcast<u32>(_e1522.member_1), bitcast<u32>(_e1522.member_2), _e1522.member_3);
        phi_2435_ = _e1396;
        phi_2436_ = _e1396;
        phi_2437_ = select(true, false, _e1396);
    } else {
        phi_2435_ = bool();
        phi_2436_ = false;
        phi_2437_ = true;
    }
    let _e1533 = phi_2435_;
    let _e1535 = phi_2436_;
    let _e1537 = phi_2437_;
    if _e1537 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e1533, _e1535, _e1537)));
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
