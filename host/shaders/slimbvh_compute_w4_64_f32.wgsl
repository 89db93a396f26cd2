// Made by slimbvh's shader builder from its Rust: rays traced from your own compute shaders, with the stacks in workgroup
// memory. Put this text behind the text slimbvh of the same kind of tree, and call
//
//   slimbvh_closest_hit_in_group(lane, origin, t_min, direction, t_max) -> SlimbvhHit
//   slimbvh_any_hit_in_group(lane, origin, t_min, direction, t_max) -> bool
//
// lane is the invocation's local_invocation_index. The stacks are 8 KiB for 64 invocations, 32 nodes each, whatever the
// size of the workgroup. A ray that needs more is traced again by the functions of the first text; so is every ray of a lane
// from 64 on, so workgroups should have 64 invocations or fewer. Two invocations with the same lane get wrong answers.
// There is no barrier inside: calls may stand in branches and loops.
//
//   slimbvh_try_closest_hit(lane, origin, t_min, direction, t_max) -> SlimbvhTriedHit { hit, overflowed }
//   slimbvh_try_any_hit(lane, origin, t_min, direction, t_max) -> SlimbvhTriedAny { found, overflowed }
//
// trace nothing again: where overflowed is true, hit is a miss and found is false, and mean nothing. A shader that calls
// only these needs no private stack: it can list the rays that overflowed for a second dispatch.

var<workgroup> slimbvh_stacks: array<u32, 2048>;

var<private> slimbvh_lane: SlimbvhTypeM;

var<private> slimbvh_overflowed: SlimbvhTypeM;

fn slimbvh_trace_in_group() {
    var phi_540_: u32;
    var phi_546_: u32;
    var phi_552_: u32;
    var phi_817_: i32;
    var phi_828_: i32;
    var phi_942_: i32;
    var phi_1071_: i32;
    var phi_1093_: u32;
    var phi_1094_: u32;
    var phi_1095_: bool;
    var phi_1129_: i32;
    var phi_1151_: u32;
    var phi_1152_: u32;
    var phi_1153_: bool;
    var phi_714_: i32;
    var phi_720_: u32;
    var phi_739_: u32;
    var phi_740_: u32;
    var phi_741_: bool;
    var phi_759_: i32;
    var phi_765_: u32;
    var phi_784_: u32;
    var phi_785_: u32;
    var phi_786_: bool;
    var phi_1163_: SlimbvhTypeC;
    var phi_1399_: SlimbvhTypeN;
    var phi_1456_: array<f32, 3>;
    var phi_1457_: array<f32, 3>;
    var phi_1475_: array<f32, 3>;
    var phi_1476_: array<f32, 3>;
    var phi_1649_: SlimbvhTypeN;
    var phi_1652_: u32;
    var phi_1654_: u32;
    var phi_1656_: u32;
    var phi_1665_: u32;
    var phi_1668_: u32;
    var phi_1670_: u32;
    var phi_1766_: SlimbvhTypeK;
    var phi_1767_: SlimbvhTypeK;
    var phi_1812_: SlimbvhTypeK;
    var phi_1813_: SlimbvhTypeK;
    var phi_1858_: SlimbvhTypeK;
    var phi_1859_: SlimbvhTypeK;
    var phi_2335_: u32;
    var phi_2348_: u32;
    var phi_2361_: u32;
    var phi_2374_: u32;
    var phi_3859_: SlimbvhTypeD;
    var phi_3871_: SlimbvhTypeD;
    var phi_3883_: SlimbvhTypeD;
    var phi_3895_: SlimbvhTypeD;
    var phi_3907_: SlimbvhTypeD;
    var phi_2458_: u32;
    var phi_2463_: u32;
    var phi_2464_: u32;
    var phi_2487_: u32;
    var phi_1666_: u32;
    var phi_1669_: u32;
    var phi_1671_: u32;
    var local: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_2503_: SlimbvhTypeN;
    var phi_2506_: SlimbvhTypeD;
    var phi_2507_: SlimbvhTypeD;
    var phi_2529_: SlimbvhTypeD;
    var phi_2608_: array<vec4<f32>, 3>;
    var phi_2609_: array<vec4<f32>, 3>;
    var phi_2689_: array<vec4<f32>, 3>;
    var phi_2690_: array<vec4<f32>, 3>;
    var phi_2713_: array<f32, 3>;
    var phi_2714_: array<f32, 3>;
    var phi_2728_: array<f32, 3>;
    var phi_2729_: array<f32, 3>;
    var phi_2743_: array<f32, 3>;
    var phi_2744_: array<f32, 3>;
    var phi_3103_: f32;
    var phi_3104_: f32;
    var phi_3105_: f32;
    var phi_3106_: f32;
    var phi_3107_: vec3<f32>;
    var phi_3108_: vec3<f32>;
    var phi_3109_: vec3<f32>;
    var phi_3110_: vec3<f32>;
    var phi_3289_: f32;
    var phi_3315_: SlimbvhTypeE;
    var phi_3316_: SlimbvhTypeE;
    var phi_3319_: SlimbvhTypeE;
    var phi_3320_: SlimbvhTypeE;
    var phi_3321_: bool;
    var phi_3325_: SlimbvhTypeE;
    var phi_3334_: SlimbvhTypeF;
    var phi_3361_: bool;
    var phi_3362_: bool;
    var phi_3369_: SlimbvhTypeN;
    var phi_3375_: SlimbvhTypeN;
    var phi_3376_: SlimbvhTypeN;
    var phi_3377_: SlimbvhTypeN;
    var phi_2504_: SlimbvhTypeN;
    var local_3: u32;
    var local_4: u32;
    var phi_3437_: u32;
    var local_5: SlimbvhTypeN;
    var phi_3446_: SlimbvhTypeN;
    var phi_3447_: u32;
    var phi_3448_: u32;
    var phi_1650_: SlimbvhTypeN;
    var phi_1653_: u32;
    var phi_1655_: u32;
    var phi_1657_: u32;
    var local_6: u32;
    var local_7: SlimbvhTypeN;
    var phi_3485_: f32;
    var phi_3487_: f32;
    var phi_3488_: bool;
    var phi_3489_: f32;
    var phi_3490_: bool;
    var phi_4138_: u32;
    var phi_4156_: bool;
    var phi_4159_: bool;
    var phi_4172_: f32;
    var phi_4173_: f32;
    var phi_4178_: f32;
    var phi_4179_: f32;
    var phi_4180_: bool;
    var phi_4188_: f32;
    var phi_3505_: f32;
    var phi_3506_: f32;
    var phi_3518_: f32;
    var phi_3523_: SlimbvhTypeF;
    var phi_3536_: bool;
    var phi_3537_: bool;
    var phi_3538_: bool;
    var local_8: SlimbvhTypeN;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e90 = SlimbvhTypeF(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e94 = arrayLength((&slimbvh_nodes.member));
    let _e106 = slimbvh_root.member[0u][0u];
    let _e110 = slimbvh_root.member[0u][1u];
    let _e114 = slimbvh_root.member[0u][2u];
    let _e118 = slimbvh_root.member[0u][3u];
    let _e122 = slimbvh_root.member[1u][0u];
    let _e126 = slimbvh_root.member[1u][1u];
    let _e130 = slimbvh_root.member[1u][2u];
    let _e142 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e118) + 127i)) << bitcast<u32>(23i)));
    let _e143 = slimbvh_origin.member;
    let _e149 = slimbvh_origin.member[3u];
    let _e150 = slimbvh_direction.member;
    let _e156 = slimbvh_direction.member[3u];
    let _e159 = slimbvh_exponent.member[0u];
    let _e160 = bitcast<i32>(_e159);
    let _e162 = (bitcast<u32>(_e143.x) & 2147483647u);
    let _e164 = (bitcast<u32>(_e143.y) & 2147483647u);
    let _e166 = (bitcast<u32>(_e143.z) & 2147483647u);
    let _e167 = bitcast<u32>(_e149);
    let _e168 = (_e167 & 2147483647u);
    let _e170 = (bitcast<u32>(_e150.x) & 2147483647u);
    let _e172 = (bitcast<u32>(_e150.y) & 2147483647u);
    let _e174 = (bitcast<u32>(_e150.z) & 2147483647u);
    let _e175 = bitcast<u32>(_e156);
    let _e176 = (_e175 & 2147483647u);
    let _e178 = select(_e172, _e170, (_e172 < _e170));
    let _e180 = select(_e174, _e178, (_e174 < _e178));
    let _e182 = select(_e162, _e180, (_e162 < _e180));
    let _e184 = select(_e164, _e182, (_e164 < _e182));
    let _e186 = select(_e166, _e184, (_e166 < _e184));
    let _e193 = (((select(_e168, _e186, (_e168 < _e186)) < 2139095040u) && (_e176 <= 2139095040u)) && (_e180 > 0u));
    if (_e170 == _e180) {
        phi_540_ = 0u;
    } else {
        phi_540_ = select(2u, 1u, (_e172 == _e180));
    }
    let _e198 = phi_540_;
    let _e199 = (_e198 == 2u);
    if _e199 {
        phi_546_ = 0u;
    } else {
        phi_546_ = (_e198 + 1u);
    }
    let _e202 = phi_546_;
    let _e203 = (_e202 == 2u);
    if _e203 {
        phi_552_ = 0u;
    } else {
        phi_552_ = (_e202 + 1u);
    }
    let _e206 = phi_552_;
    let _e207 = (_e202 == 0u);
    let _e209 = select(select(_e143.y, _e143.x, _e207), _e143.z, _e203);
    let _e210 = (_e206 == 0u);
    let _e212 = (_e206 == 2u);
    let _e213 = select(select(_e143.y, _e143.x, _e210), _e143.z, _e212);
    let _e214 = (_e198 == 0u);
    let _e216 = select(select(_e143.y, _e143.x, _e214), _e143.z, _e199);
    let _e218 = select(select(_e150.y, _e150.x, _e207), _e150.z, _e203);
    let _e220 = select(select(_e150.y, _e150.x, _e210), _e150.z, _e212);
    let _e222 = select(select(_e150.y, _e150.x, _e214), _e150.z, _e199);
    let _e223 = (_e168 - 1u);
    let _e224 = (_e176 - 1u);
    let _e226 = select(_e223, _e224, (_e224 < _e223));
    let _e227 = (_e162 - 1u);
    let _e228 = (_e164 - 1u);
    let _e230 = select(_e227, _e228, (_e228 < _e227));
    let _e231 = (_e166 - 1u);
    let _e233 = select(_e230, _e231, (_e231 < _e230));
    let _e234 = (_e170 - 1u);
    let _e235 = (_e172 - 1u);
    let _e237 = select(_e234, _e235, (_e235 < _e234));
    let _e238 = (_e174 - 1u);
    let _e240 = select(_e237, _e238, (_e238 < _e237));
    let _e242 = select(_e233, _e240, (_e240 < _e233));
    if (((select(_e242, _e226, (_e226 < _e242)) >= 8388607u) && (_e180 < 2130706432u)) && (bitcast<u32>((_e160 + 126i)) <= 253u)) {
        let _e507 = bitcast<i32>((_e180 >> bitcast<u32>(23i)));
        let _e508 = (_e507 - 127i);
        let _e509 = (_e160 + _e508);
        let _e514 = bitcast<f32>((bitcast<u32>((_e160 + 127i)) << bitcast<u32>(23i)));
        let _e519 = bitcast<f32>((bitcast<u32>((254i - _e507)) << bitcast<u32>(23i)));
        if (_e168 >= 2139095040u) {
            phi_714_ = 255i;
        } else {
            phi_714_ = (bitcast<i32>((_e168 >> bitcast<u32>(23i))) + _e509);
        }
        let _e534 = phi_714_;
        if (_e168 == 0u) {
            phi_720_ = 0u;
        } else {
            phi_720_ = (_e168 | 8388608u);
        }
        let _e538 = phi_720_;
        if (_e534 <= 0i) {
            phi_740_ = u32();
            phi_741_ = true;
        } else {
            let _e545 = (_e538 == 0u);
            if _e545 {
                phi_739_ = u32();
            } else {
                phi_739_ = select(((bitcast<u32>(_e534) << bitcast<u32>(23i)) | (_e538 & 8388607u)), 2139095039u, (_e534 >= 255i));
            }
            let _e549 = phi_739_;
            phi_740_ = _e549;
            phi_741_ = _e545;
        }
        let _e551 = phi_740_;
        let _e553 = phi_741_;
        if (_e176 >= 2139095040u) {
            phi_759_ = 255i;
        } else {
            phi_759_ = (bitcast<i32>((_e176 >> bitcast<u32>(23i))) + _e509);
        }
        let _e564 = phi_759_;
        if (_e176 == 0u) {
            phi_765_ = 0u;
        } else {
            phi_765_ = (_e176 | 8388608u);
        }
        let _e568 = phi_765_;
        if (_e564 <= 0i) {
            phi_785_ = u32();
            phi_786_ = true;
        } else {
            let _e575 = (_e568 == 0u);
            if _e575 {
                phi_784_ = u32();
            } else {
                phi_784_ = select(((bitcast<u32>(_e564) << bitcast<u32>(23i)) | (_e568 & 8388607u)), 2139095039u, (_e564 >= 255i));
            }
            let _e579 = phi_784_;
            phi_785_ = _e579;
            phi_786_ = _e575;
        }
        let _e581 = phi_785_;
        let _e583 = phi_786_;
        phi_1163_ = SlimbvhTypeC(array<f32, 3>((_e209 * _e514), (_e213 * _e514), (_e216 * _e514)), array<f32, 3>((_e218 * _e519), (_e220 * _e519), (_e222 * _e519)), bitcast<f32>(((_e167 & 2147483648u) | select(_e551, 0u, _e553))), bitcast<f32>(((_e175 & 2147483648u) | select(_e581, 0u, _e583))), _e508);
    } else {
        let _e255 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e180, _e193))) & 2147483647u);
        if (_e255 >= 8388608u) {
            phi_817_ = (bitcast<i32>((_e255 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_817_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e255)), 32u, (_e255 == 0u))));
        }
        let _e269 = phi_817_;
        let _e270 = (_e160 + _e269);
        if (_e160 < -126i) {
            phi_828_ = -126i;
        } else {
            phi_828_ = select(_e160, 127i, (_e160 > 127i));
        }
        let _e275 = phi_828_;
        let _e280 = bitcast<f32>((bitcast<u32>((_e275 + 127i)) << bitcast<u32>(23i)));
        let _e286 = bitcast<f32>((bitcast<u32>(((_e160 - _e275) + 127i)) << bitcast<u32>(23i)));
        let _e287 = bitcast<u32>(_e209);
        let _e289 = ((_e287 & 2139095040u) != 0u);
        let _e304 = bitcast<u32>(_e213);
        let _e306 = ((_e304 & 2139095040u) != 0u);
        let _e321 = bitcast<u32>(_e216);
        let _e323 = ((_e321 & 2139095040u) != 0u);
        let _e339 = -(_e269);
        if (_e339 < -126i) {
            phi_942_ = -126i;
        } else {
            phi_942_ = select(_e339, 127i, (_e339 > 127i));
        }
        let _e344 = phi_942_;
        let _e349 = bitcast<f32>((bitcast<u32>((_e344 + 127i)) << bitcast<u32>(23i)));
        let _e355 = bitcast<f32>((bitcast<u32>(((_e339 - _e344) + 127i)) << bitcast<u32>(23i)));
        let _e356 = bitcast<u32>(_e218);
        let _e358 = ((_e356 & 2139095040u) != 0u);
        let _e373 = bitcast<u32>(_e220);
        let _e375 = ((_e373 & 2139095040u) != 0u);
        let _e390 = bitcast<u32>(_e222);
        let _e392 = ((_e390 & 2139095040u) != 0u);
        let _e414 = ((_e168 & 8388607u) | (select(0u, 1u, ((_e168 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e417 = bitcast<i32>((_e168 >> bitcast<u32>(23i)));
        let _e424 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e414)), 32u, (_e414 == 0u))) - 8i);
        if (_e417 == 255i) {
            phi_1071_ = 255i;
        } else {
            phi_1071_ = (((_e417 + select(0i, 1i, (_e417 == 0i))) - _e424) + _e270);
        }
        let _e432 = phi_1071_;
        let _e436 = (_e414 << bitcast<u32>(((_e424 & 31i) & 31i)));
        if (_e432 <= 0i) {
            phi_1094_ = u32();
            phi_1095_ = true;
        } else {
            let _e443 = (_e436 == 0u);
            if _e443 {
                phi_1093_ = u32();
            } else {
                phi_1093_ = select(((bitcast<u32>(_e432) << bitcast<u32>(23i)) | (_e436 & 8388607u)), 2139095039u, (_e432 >= 255i));
            }
            let _e447 = phi_1093_;
            phi_1094_ = _e447;
            phi_1095_ = _e443;
        }
        let _e449 = phi_1094_;
        let _e451 = phi_1095_;
        let _e462 = ((_e176 & 8388607u) | (select(0u, 1u, ((_e176 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e465 = bitcast<i32>((_e176 >> bitcast<u32>(23i)));
        let _e472 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e462)), 32u, (_e462 == 0u))) - 8i);
        if (_e465 == 255i) {
            phi_1129_ = 255i;
        } else {
            phi_1129_ = (((_e465 + select(0i, 1i, (_e465 == 0i))) - _e472) + _e270);
        }
        let _e480 = phi_1129_;
        let _e484 = (_e462 << bitcast<u32>(((_e472 & 31i) & 31i)));
        if (_e480 <= 0i) {
            phi_1152_ = u32();
            phi_1153_ = true;
        } else {
            let _e491 = (_e484 == 0u);
            if _e491 {
                phi_1151_ = u32();
            } else {
                phi_1151_ = select(((bitcast<u32>(_e480) << bitcast<u32>(23i)) | (_e484 & 8388607u)), 2139095039u, (_e480 >= 255i));
            }
            let _e495 = phi_1151_;
            phi_1152_ = _e495;
            phi_1153_ = _e491;
        }
        let _e497 = phi_1152_;
        let _e499 = phi_1153_;
        phi_1163_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e287 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e287 & 2147483648u))), _e209, _e289) * _e280) * select(0.00000011920929f, 1f, _e289)) * _e286), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e304 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e304 & 2147483648u))), _e213, _e306) * _e280) * select(0.00000011920929f, 1f, _e306)) * _e286), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e321 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e321 & 2147483648u))), _e216, _e323) * _e280) * select(0.00000011920929f, 1f, _e323)) * _e286)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e356 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e356 & 2147483648u))), _e218, _e358) * _e349) * select(0.00000011920929f, 1f, _e358)) * _e355), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e373 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e373 & 2147483648u))), _e220, _e375) * _e349) * select(0.00000011920929f, 1f, _e375)) * _e355), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e390 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e390 & 2147483648u))), _e222, _e392) * _e349) * select(0.00000011920929f, 1f, _e392)) * _e355)), bitcast<f32>(((_e167 & 2147483648u) | select(_e449, 0u, _e451))), bitcast<f32>(((_e175 & 2147483648u) | select(_e497, 0u, _e499))), _e269);
    }
    let _e590 = phi_1163_;
    let _e605 = (bitcast<f32>((bitcast<u32>(_e590.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e608 = bitcast<f32>((bitcast<u32>(_e590.member[0]) & 2147483647u));
    let _e609 = (_e608 * 0.00000011920929f);
    let _e612 = select(select(0.00000000000011368684f, _e609, (_e609 > 0.00000000000011368684f)), 0f, _e605);
    let _e613 = select(0f, _e590.member_1[0], _e605);
    let _e614 = (_e590.member[0] + _e612);
    let _e615 = (_e590.member[0] - _e612);
    let _e617 = select(38685626000000000000000000f, (1f / _e590.member_1[0]), _e605);
    let _e621 = (bitcast<f32>((bitcast<u32>(_e590.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e624 = bitcast<f32>((bitcast<u32>(_e590.member[1]) & 2147483647u));
    let _e625 = (_e624 * 0.00000011920929f);
    let _e628 = select(select(0.00000000000011368684f, _e625, (_e625 > 0.00000000000011368684f)), 0f, _e621);
    let _e629 = select(0f, _e590.member_1[1], _e621);
    let _e630 = (_e590.member[1] + _e628);
    let _e631 = (_e590.member[1] - _e628);
    let _e633 = select(38685626000000000000000000f, (1f / _e590.member_1[1]), _e621);
    let _e637 = (bitcast<f32>((bitcast<u32>(_e590.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e640 = bitcast<f32>((bitcast<u32>(_e590.member[2]) & 2147483647u));
    let _e641 = (_e640 * 0.00000011920929f);
    let _e644 = select(select(0.00000000000011368684f, _e641, (_e641 > 0.00000000000011368684f)), 0f, _e637);
    let _e645 = select(0f, _e590.member_1[2], _e637);
    let _e646 = (_e590.member[2] + _e644);
    let _e647 = (_e590.member[2] - _e644);
    let _e649 = select(38685626000000000000000000f, (1f / _e590.member_1[2]), _e637);
    let _e651 = select(_e624, _e608, (_e608 > _e624));
    let _e655 = (_e193 && (select(_e640, _e651, (_e651 > _e640)) <= 1099511600000f));
    let _e656 = select(0f, _e590.member_3, _e655);
    let _e657 = select(1f, _e590.member_2, _e655);
    let _e659 = slimbvh_lane.member;
    if (_e659 < 64u) {
        let _e661 = (_e659 % 64u);
        let _e662 = slimbvh_any_will_do.member;
        if (_e662 == 1u) {
            phi_1399_ = SlimbvhTypeN(SlimbvhTypeH(_e90, _e656), true);
        } else {
            phi_1399_ = SlimbvhTypeN(SlimbvhTypeH(_e90, _e656), false);
        }
        let _e669 = phi_1399_;
        let _e674 = (_e202 & 3u);
        let _e675 = (_e206 & 3u);
        let _e676 = (_e198 & 3u);
        let _e679 = (bitcast<u32>(_e617) >> bitcast<u32>(31i));
        let _e682 = (bitcast<u32>(_e633) >> bitcast<u32>(31i));
        let _e685 = (bitcast<u32>(_e649) >> bitcast<u32>(31i));
        let _e687 = (f32(bitcast<i32>(_e106)) * _e142);
        let _e689 = (f32(bitcast<i32>(_e110)) * _e142);
        let _e691 = (f32(bitcast<i32>(_e114)) * _e142);
        let _e692 = (_e674 == 0u);
        if _e692 {
            phi_1457_ = array<f32, 3>(_e687, _e689, _e691);
        } else {
            if (_e674 == 1u) {
                phi_1456_ = array<f32, 3>(_e689, _e691, _e687);
            } else {
                phi_1456_ = array<f32, 3>(_e691, _e687, _e689);
            }
            let _e697 = phi_1456_;
            phi_1457_ = _e697;
        }
        let _e700 = phi_1457_;
        let _e702 = (f32(bitcast<i32>(_e122)) * _e142);
        let _e704 = (f32(bitcast<i32>(_e126)) * _e142);
        let _e706 = (f32(bitcast<i32>(_e130)) * _e142);
        if _e692 {
            phi_1476_ = array<f32, 3>(_e702, _e704, _e706);
        } else {
            if (_e674 == 1u) {
                phi_1475_ = array<f32, 3>(_e704, _e706, _e702);
            } else {
                phi_1475_ = array<f32, 3>(_e706, _e702, _e704);
            }
            let _e711 = phi_1475_;
            phi_1476_ = _e711;
        }
        let _e714 = phi_1476_;
        let _e725 = ((_e700[0] - _e614) * _e617);
        let _e726 = ((_e714[0] - _e615) * _e617);
        let _e727 = vec4<f32>(_e725, f32(), _e726, f32());
        let _e730 = ((_e700[1] - _e630) * _e633);
        let _e731 = ((_e714[1] - _e631) * _e633);
        let _e732 = vec4<f32>(_e730, f32(), _e731, f32());
        let _e735 = ((_e700[2] - _e646) * _e649);
        let _e736 = ((_e714[2] - _e647) * _e649);
        let _e737 = vec4<f32>(_e735, f32(), _e736, f32());
        let _e738 = vec4<f32>(_e726, f32(), _e725, f32());
        let _e740 = vec4<f32>(_e731, f32(), _e730, f32());
        let _e742 = vec4<f32>(_e736, f32(), _e735, f32());
        phi_1649_ = _e669;
        phi_1652_ = select(4294967295u, select(4294967295u, 0u, (_e657 <= _e656)), (max(max(max(min(_e727, _e738).x, min(_e732, _e740).x), min(_e737, _e742).x), _e657) <= min((min(min(max(_e727, _e738).x, max(_e732, _e740).x), max(_e737, _e742).x) + (max(max(_e737, _e742).x, -(min(_e737, _e742).x)) * 0.0000019073523f)), _e669.member.member_1)));
        phi_1654_ = 0u;
        phi_1656_ = (_e94 + 1u);
        loop {
            let _e766 = phi_1649_;
            let _e768 = phi_1652_;
            let _e770 = phi_1654_;
            let _e772 = phi_1656_;
            local_6 = _e768;
            local_7 = _e766;
            let _e773 = (_e768 <= 32u);
            if _e773 {
                phi_1665_ = _e768;
                phi_1668_ = _e770;
                phi_1670_ = _e772;
                loop {
                    let _e775 = phi_1665_;
                    let _e777 = phi_1668_;
                    let _e779 = phi_1670_;
                    local_1 = _e777;
                    local_2 = _e777;
                    local_3 = _e775;
                    local_4 = _e775;
                    local_9 = _e775;
                    local_10 = _e777;
                    local_11 = _e779;
                    let _e780 = (_e775 <= 32u);
                    let _e783 = (_e780 && !((_e777 >= _e94)));
                    local = _e780;
                    if _e783 {
                        let _e789 = slimbvh_nodes.member[_e777].member[select(_e674, 2u, (2u < _e674))];
                        let _e795 = slimbvh_nodes.member[_e777].member[select(_e675, 2u, (2u < _e675))];
                        let _e801 = slimbvh_nodes.member[_e777].member[select(_e676, 2u, (2u < _e676))];
                        let _e804 = bitcast<u32>(_e142);
                        let _e809 = bitcast<f32>(_e789.x);
                        let _e814 = (_e809 + (f32((_e789.w >> bitcast<u32>(5u))) * _e142));
                        if (_e679 == 0u) {
                            phi_1766_ = SlimbvhTypeK(_e789.z, _e814);
                            phi_1767_ = SlimbvhTypeK(_e789.y, _e809);
                        } else {
                            phi_1766_ = SlimbvhTypeK(_e789.y, _e809);
                            phi_1767_ = SlimbvhTypeK(_e789.z, _e814);
                        }
                        let _e825 = phi_1766_;
                        let _e827 = phi_1767_;
                        let _e831 = bitcast<f32>(((_e804 + ((_e789.w & 31u) << bitcast<u32>(23i))) ^ (_e679 << bitcast<u32>(31i))));
                        let _e871 = bitcast<f32>(_e795.x);
                        let _e876 = (_e871 + (f32((_e795.w >> bitcast<u32>(5u))) * _e142));
                        if (_e682 == 0u) {
                            phi_1812_ = SlimbvhTypeK(_e795.z, _e876);
                            phi_1813_ = SlimbvhTypeK(_e795.y, _e871);
                        } else {
                            phi_1812_ = SlimbvhTypeK(_e795.y, _e871);
                            phi_1813_ = SlimbvhTypeK(_e795.z, _e876);
                        }
                        let _e887 = phi_1812_;
                        let _e889 = phi_1813_;
                        let _e893 = bitcast<f32>(((_e804 + ((_e795.w & 31u) << bitcast<u32>(23i))) ^ (_e682 << bitcast<u32>(31i))));
                        let _e933 = bitcast<f32>(_e801.x);
                        let _e938 = (_e933 + (f32((_e801.w >> bitcast<u32>(5u))) * _e142));
                        if (_e685 == 0u) {
                            phi_1858_ = SlimbvhTypeK(_e801.z, _e938);
                            phi_1859_ = SlimbvhTypeK(_e801.y, _e933);
                        } else {
                            phi_1858_ = SlimbvhTypeK(_e801.y, _e933);
                            phi_1859_ = SlimbvhTypeK(_e801.z, _e938);
                        }
                        let _e949 = phi_1858_;
                        let _e951 = phi_1859_;
                        let _e955 = bitcast<f32>(((_e804 + ((_e801.w & 31u) << bitcast<u32>(23i))) ^ (_e685 << bitcast<u32>(31i))));
                        let _e991 = (_e831 * _e617);
                        let _e998 = (((_e827.member_1 - _e614) * _e617) + (bitcast<f32>((bitcast<u32>(_e991) & 2147483647u)) * -0.00012207031f));
                        let _e1007 = (-(_e831) * _e617);
                        let _e1014 = (((_e825.member_1 - _e615) * _e617) + (bitcast<f32>((bitcast<u32>(_e1007) & 2147483647u)) * 0.00012207031f));
                        let _e1023 = (_e893 * _e633);
                        let _e1030 = (((_e889.member_1 - _e630) * _e633) + (bitcast<f32>((bitcast<u32>(_e1023) & 2147483647u)) * -0.00012207031f));
                        let _e1039 = (-(_e893) * _e633);
                        let _e1046 = (((_e887.member_1 - _e631) * _e633) + (bitcast<f32>((bitcast<u32>(_e1039) & 2147483647u)) * 0.00012207031f));
                        let _e1055 = (_e955 * _e649);
                        let _e1062 = (((_e951.member_1 - _e646) * _e649) + (bitcast<f32>((bitcast<u32>(_e1055) & 2147483647u)) * -0.00012207031f));
                        let _e1067 = ((f32((_e951.member & 255u)) * _e1055) + _e1062);
                        let _e1068 = ((f32(((_e951.member >> bitcast<u32>(8u)) & 255u)) * _e1055) + _e1062);
                        let _e1069 = ((f32(((_e951.member >> bitcast<u32>(16u)) & 255u)) * _e1055) + _e1062);
                        let _e1070 = ((f32(((_e951.member >> bitcast<u32>(24u)) & 255u)) * _e1055) + _e1062);
                        let _e1071 = (-(_e955) * _e649);
                        let _e1078 = (((_e949.member_1 - _e647) * _e649) + (bitcast<f32>((bitcast<u32>(_e1071) & 2147483647u)) * 0.00012207031f));
                        let _e1083 = ((f32((_e949.member & 255u)) * _e1071) + _e1078);
                        let _e1084 = ((f32(((_e949.member >> bitcast<u32>(8u)) & 255u)) * _e1071) + _e1078);
                        let _e1085 = ((f32(((_e949.member >> bitcast<u32>(16u)) & 255u)) * _e1071) + _e1078);
                        let _e1086 = ((f32(((_e949.member >> bitcast<u32>(24u)) & 255u)) * _e1071) + _e1078);
                        let _e1119 = max(max(max(((f32((_e827.member & 255u)) * _e991) + _e998), ((f32((_e889.member & 255u)) * _e1023) + _e1030)), _e1067), _e657);
                        let _e1120 = max(max(max(((f32(((_e827.member >> bitcast<u32>(8u)) & 255u)) * _e991) + _e998), ((f32(((_e889.member >> bitcast<u32>(8u)) & 255u)) * _e1023) + _e1030)), _e1068), _e657);
                        let _e1121 = max(max(max(((f32(((_e827.member >> bitcast<u32>(16u)) & 255u)) * _e991) + _e998), ((f32(((_e889.member >> bitcast<u32>(16u)) & 255u)) * _e1023) + _e1030)), _e1069), _e657);
                        let _e1122 = max(max(max(((f32(((_e827.member >> bitcast<u32>(24u)) & 255u)) * _e991) + _e998), ((f32(((_e889.member >> bitcast<u32>(24u)) & 255u)) * _e1023) + _e1030)), _e1070), _e657);
                        let _e1127 = (_e766.member.member_1 + (bitcast<f32>((bitcast<u32>(_e766.member.member_1) & 2147483647u)) * 0.0000004768374f));
                        if (_e1119 <= min((min(min(((f32((_e825.member & 255u)) * _e1007) + _e1014), ((f32((_e887.member & 255u)) * _e1039) + _e1046)), _e1083) + (max(_e1083, -(_e1067)) * 0.0000023841915f)), _e1127)) {
                            phi_2335_ = (((bitcast<u32>(_e1119) ^ select(0u, 4294967288u, _e669.member_1)) & 2147483640u) | 4u);
                        } else {
                            phi_2335_ = 4294967288u;
                        }
                        let _e1142 = phi_2335_;
                        if (_e1120 <= min((min(min(((f32(((_e825.member >> bitcast<u32>(8u)) & 255u)) * _e1007) + _e1014), ((f32(((_e887.member >> bitcast<u32>(8u)) & 255u)) * _e1039) + _e1046)), _e1084) + (max(_e1084, -(_e1068)) * 0.0000023841915f)), _e1127)) {
                            phi_2348_ = ((((bitcast<u32>(_e1120) ^ select(0u, 4294967288u, _e669.member_1)) & 2147483640u) | 4u) | 1u);
                        } else {
                            phi_2348_ = 4294967288u;
                        }
                        let _e1150 = phi_2348_;
                        if (_e1121 <= min((min(min(((f32(((_e825.member >> bitcast<u32>(16u)) & 255u)) * _e1007) + _e1014), ((f32(((_e887.member >> bitcast<u32>(16u)) & 255u)) * _e1039) + _e1046)), _e1085) + (max(_e1085, -(_e1069)) * 0.0000023841915f)), _e1127)) {
                            phi_2361_ = ((((bitcast<u32>(_e1121) ^ select(0u, 4294967288u, _e669.member_1)) & 2147483640u) | 4u) | 2u);
                        } else {
                            phi_2361_ = 4294967288u;
                        }
                        let _e1158 = phi_2361_;
                        if (_e1122 <= min((min(min(((f32(((_e825.member >> bitcast<u32>(24u)) & 255u)) * _e1007) + _e1014), ((f32(((_e887.member >> bitcast<u32>(24u)) & 255u)) * _e1039) + _e1046)), _e1086) + (max(_e1086, -(_e1070)) * 0.0000023841915f)), _e1127)) {
                            phi_2374_ = ((((bitcast<u32>(_e1122) ^ select(0u, 4294967288u, _e669.member_1)) & 2147483640u) | 4u) | 3u);
                        } else {
                            phi_2374_ = 4294967288u;
                        }
                        let _e1166 = phi_2374_;
                        if (_e1142 < _e1150) {
                            phi_3859_ = SlimbvhTypeD(_e1142, _e1150);
                        } else {
                            phi_3859_ = SlimbvhTypeD(_e1150, _e1142);
                        }
                        let _e1171 = phi_3859_;
                        if (_e1158 < _e1166) {
                            phi_3871_ = SlimbvhTypeD(_e1158, _e1166);
                        } else {
                            phi_3871_ = SlimbvhTypeD(_e1166, _e1158);
                        }
                        let _e1178 = phi_3871_;
                        if (_e1171.member < _e1178.member) {
                            phi_3883_ = SlimbvhTypeD(_e1171.member, _e1178.member);
                        } else {
                            phi_3883_ = SlimbvhTypeD(_e1178.member, _e1171.member);
                        }
                        let _e1185 = phi_3883_;
                        if (_e1171.member_1 < _e1178.member_1) {
                            phi_3895_ = SlimbvhTypeD(_e1171.member_1, _e1178.member_1);
                        } else {
                            phi_3895_ = SlimbvhTypeD(_e1178.member_1, _e1171.member_1);
                        }
                        let _e1192 = phi_3895_;
                        if (_e1192.member < _e1185.member_1) {
                            phi_3907_ = SlimbvhTypeD(_e1192.member, _e1185.member_1);
                        } else {
                            phi_3907_ = SlimbvhTypeD(_e1185.member_1, _e1192.member);
                        }
                        let _e1199 = phi_3907_;
                        let _e1214 = (((_e1185.member & 7u) | ((_e1199.member & 7u) << bitcast<u32>(3u))) | (((_e1199.member_1 & 7u) | ((_e1192.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                        if (_e1214 == 0u) {
                            let _e1234 = (_e775 - 1u);
                            let _e1239 = slimbvh_stacks[(((_e1234 % 32u) * 64u) + _e661)];
                            let _e1240 = (_e1239 & 511u);
                            let _e1242 = (_e1240 >> bitcast<u32>(3u));
                            let _e1245 = ((_e1242 == 0u) || (_e1234 == 4294967295u));
                            if _e1245 {
                            } else {
                                slimbvh_stacks[(((_e1234 % 32u) * 64u) + _e661)] = (((_e1239 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1242);
                            }
                            phi_2463_ = select(_e775, _e1234, _e1245);
                            phi_2464_ = (((_e1239 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1240 & 3u) & 3u));
                        } else {
                            let _e1217 = (_e1214 >> bitcast<u32>(3u));
                            if (_e1217 == 0u) {
                                phi_2458_ = _e775;
                            } else {
                                slimbvh_stacks[(((_e775 % 32u) * 64u) + _e661)] = ((_e777 << bitcast<u32>(9u)) | _e1217);
                                phi_2458_ = (_e775 + 1u);
                            }
                            let _e1228 = phi_2458_;
                            phi_2463_ = _e1228;
                            phi_2464_ = ((_e777 << bitcast<u32>(2i)) | ((_e1214 & 3u) & 3u));
                        }
                        let _e1260 = phi_2463_;
                        let _e1262 = phi_2464_;
                        let _e1264 = (_e1262 >> bitcast<u32>(2i));
                        if (_e1264 < _e94) {
                            let _e1270 = slimbvh_nodes.member[_e1264].member_1[(_e1262 & 3u)];
                            phi_2487_ = _e1270;
                        } else {
                            phi_2487_ = 2147483648u;
                        }
                        let _e1272 = phi_2487_;
                        let _e1273 = (_e779 - 1u);
                        phi_1666_ = select(_e1260, 4294967295u, (_e1273 == 0u));
                        phi_1669_ = _e1272;
                        phi_1671_ = _e1273;
                    } else {
                        phi_1666_ = u32();
                        phi_1669_ = u32();
                        phi_1671_ = u32();
                    }
                    let _e1277 = phi_1666_;
                    let _e1279 = phi_1669_;
                    let _e1281 = phi_1671_;
                    continue;
                    continuing {
                        phi_1665_ = _e1277;
                        phi_1668_ = _e1279;
                        phi_1670_ = _e1281;
                        break if !(_e783);
                    }
                }
                let _e1284 = local;
                if _e1284 {
                    let _e1286 = local_1;
                    let _e1289 = local_2;
                    phi_2503_ = _e766;
                    phi_2506_ = SlimbvhTypeD(0u, ((_e1289 >> bitcast<u32>(28u)) & 7u));
                    loop {
                        let _e1295 = phi_2503_;
                        let _e1297 = phi_2506_;
                        local_5 = _e1295;
                        local_8 = _e1295;
                        if (_e1297.member < _e1297.member_1) {
                            phi_2507_ = SlimbvhTypeD((_e1297.member + 1u), _e1297.member_1);
                            phi_2529_ = SlimbvhTypeD(1u, _e1297.member);
                        } else {
                            phi_2507_ = _e1297;
                            phi_2529_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                        }
                        let _e1310 = phi_2507_;
                        let _e1312 = phi_2529_;
                        let _e1316 = (bitcast<i32>(_e1312.member) != 0i);
                        if _e1316 {
                            let _e1317 = ((_e1286 & 268435455u) + _e1312.member_1);
                            let _e1318 = (_e1317 / 2u);
                            let _e1319 = (_e1317 % 2u);
                            let _e1320 = (_e1318 >= arrayLength((&slimbvh_triangles.member)));
                            if _e1320 {
                                phi_2609_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e1321 = (2u * _e1319);
                                let _e1325 = slimbvh_triangles.member[_e1318][_e1321];
                                let _e1330 = slimbvh_triangles.member[_e1318][(_e1321 + 1u)];
                                let _e1335 = slimbvh_triangles.member[_e1318][(_e1321 + 2u)];
                                if (_e1319 == 0u) {
                                    phi_2608_ = array<vec4<f32>, 3>(_e1325, _e1330, _e1335);
                                } else {
                                    phi_2608_ = array<vec4<f32>, 3>(vec4<f32>(_e1325.z, _e1325.w, _e1330.x, _e1330.y), vec4<f32>(_e1330.z, _e1330.w, _e1335.x, _e1335.y), vec4<f32>(_e1335.z, _e1335.w, 0f, 0f));
                                }
                                let _e1353 = phi_2608_;
                                phi_2609_ = _e1353;
                            }
                            let _e1355 = phi_2609_;
                            let _e1358 = bitcast<u32>(_e1355[2].y);
                            if _e1320 {
                                phi_2690_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e1359 = (2u * _e1319);
                                let _e1363 = slimbvh_triangles.member[_e1318][_e1359];
                                let _e1368 = slimbvh_triangles.member[_e1318][(_e1359 + 1u)];
                                let _e1373 = slimbvh_triangles.member[_e1318][(_e1359 + 2u)];
                                if (_e1319 == 0u) {
                                    phi_2689_ = array<vec4<f32>, 3>(_e1363, _e1368, _e1373);
                                } else {
                                    phi_2689_ = array<vec4<f32>, 3>(vec4<f32>(_e1363.z, _e1363.w, _e1368.x, _e1368.y), vec4<f32>(_e1368.z, _e1368.w, _e1373.x, _e1373.y), vec4<f32>(_e1373.z, _e1373.w, 0f, 0f));
                                }
                                let _e1391 = phi_2689_;
                                phi_2690_ = _e1391;
                            }
                            let _e1393 = phi_2690_;
                            if _e207 {
                                phi_2714_ = array<f32, 3>(_e1393[0].x, _e1393[0].y, _e1393[0].z);
                            } else {
                                if (_e202 == 1u) {
                                    phi_2713_ = array<f32, 3>(_e1393[0].y, _e1393[0].z, _e1393[0].x);
                                } else {
                                    phi_2713_ = array<f32, 3>(_e1393[0].z, _e1393[0].x, _e1393[0].y);
                                }
                                let _e1416 = phi_2713_;
                                phi_2714_ = _e1416;
                            }
                            let _e1419 = phi_2714_;
                            if _e207 {
                                phi_2729_ = array<f32, 3>(_e1393[0].w, _e1393[1].x, _e1393[1].y);
                            } else {
                                if (_e202 == 1u) {
                                    phi_2728_ = array<f32, 3>(_e1393[1].x, _e1393[1].y, _e1393[0].w);
                                } else {
                                    phi_2728_ = array<f32, 3>(_e1393[1].y, _e1393[0].w, _e1393[1].x);
                                }
                                let _e1424 = phi_2728_;
                                phi_2729_ = _e1424;
                            }
                            let _e1427 = phi_2729_;
                            if _e207 {
                                phi_2744_ = array<f32, 3>(_e1393[1].z, _e1393[1].w, _e1393[2].x);
                            } else {
                                if (_e202 == 1u) {
                                    phi_2743_ = array<f32, 3>(_e1393[1].w, _e1393[2].x, _e1393[1].z);
                                } else {
                                    phi_2743_ = array<f32, 3>(_e1393[2].x, _e1393[1].z, _e1393[1].w);
                                }
                                let _e1432 = phi_2743_;
                                phi_2744_ = _e1432;
                            }
                            let _e1435 = phi_2744_;
                            let _e1449 = (_e1419[2] - _e590.member[2]);
                            let _e1452 = (((_e1419[0] - _e590.member[0]) * _e645) - (_e1449 * _e613));
                            let _e1455 = (((_e1419[1] - _e590.member[1]) * _e645) - (_e1449 * _e629));
                            let _e1458 = (_e1427[2] - _e590.member[2]);
                            let _e1461 = (((_e1427[0] - _e590.member[0]) * _e645) - (_e1458 * _e613));
                            let _e1464 = (((_e1427[1] - _e590.member[1]) * _e645) - (_e1458 * _e629));
                            let _e1467 = (_e1435[2] - _e590.member[2]);
                            let _e1470 = (((_e1435[0] - _e590.member[0]) * _e645) - (_e1467 * _e613));
                            let _e1473 = (((_e1435[1] - _e590.member[1]) * _e645) - (_e1467 * _e629));
                            let _e1474 = (_e1470 * _e1464);
                            let _e1475 = (_e1473 * _e1461);
                            let _e1476 = (_e1452 * _e1473);
                            let _e1477 = (_e1455 * _e1470);
                            let _e1478 = (_e1461 * _e1455);
                            let _e1479 = (_e1464 * _e1452);
                            let _e1484 = (((_e1474 >= _e1475) && (_e1476 >= _e1477)) && (_e1478 >= _e1479));
                            let _e1490 = (_e1484 || (((_e1474 <= _e1475) && (_e1476 <= _e1477)) && (_e1478 <= _e1479)));
                            if _e1490 {
                                let _e1492 = select(-1f, 1f, _e1484);
                                let _e1494 = ((_e1474 - _e1475) * _e1492);
                                let _e1496 = select(0f, _e1494, (_e1494 > 0f));
                                let _e1498 = ((_e1476 - _e1477) * _e1492);
                                let _e1500 = select(0f, _e1498, (_e1498 > 0f));
                                let _e1502 = ((_e1478 - _e1479) * _e1492);
                                let _e1504 = select(0f, _e1502, (_e1502 > 0f));
                                let _e1506 = ((_e1496 + _e1500) + _e1504);
                                let _e1521 = ((min(min(_e1419[0], _e1427[0]), _e1435[0]) - _e614) * _e617);
                                let _e1522 = ((max(max(_e1419[0], _e1427[0]), _e1435[0]) - _e615) * _e617);
                                let _e1523 = vec4<f32>(_e1521, f32(), _e1522, f32());
                                let _e1526 = ((min(min(_e1419[1], _e1427[1]), _e1435[1]) - _e630) * _e633);
                                let _e1527 = ((max(max(_e1419[1], _e1427[1]), _e1435[1]) - _e631) * _e633);
                                let _e1528 = vec4<f32>(_e1526, f32(), _e1527, f32());
                                let _e1531 = ((min(min(_e1419[2], _e1427[2]), _e1435[2]) - _e646) * _e649);
                                let _e1532 = ((max(max(_e1419[2], _e1427[2]), _e1435[2]) - _e647) * _e649);
                                let _e1533 = vec4<f32>(_e1531, f32(), _e1532, f32());
                                let _e1534 = vec4<f32>(_e1522, f32(), _e1521, f32());
                                let _e1536 = vec4<f32>(_e1527, f32(), _e1526, f32());
                                let _e1538 = vec4<f32>(_e1532, f32(), _e1531, f32());
                                let _e1547 = max(max(min(_e1523, _e1534).x, min(_e1528, _e1536).x), min(_e1533, _e1538).x);
                                let _e1552 = min(min(max(_e1523, _e1534).x, max(_e1528, _e1536).x), max(_e1533, _e1538).x);
                                let _e1557 = max(_e1547, _e657);
                                let _e1579 = (((((_e1490 && (_e1506 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1452, _e1461), _e1470) <= 0f) && (max(max(_e1452, _e1461), _e1470) >= 0f))) && ((min(min(_e1455, _e1464), _e1473) <= 0f) && (max(max(_e1455, _e1464), _e1473) >= 0f))) && (_e1557 <= (_e1552 + (max(max(_e1533, _e1538).x, -(min(_e1533, _e1538).x)) * 0.0000019073523f)))) && (_e1557 <= _e1295.member.member_1));
                                if _e1579 {
                                    let _e1584 = (_e1427[0] - _e1419[0]);
                                    let _e1585 = (_e1427[1] - _e1419[1]);
                                    let _e1586 = (_e1427[2] - _e1419[2]);
                                    let _e1587 = vec3<f32>(_e1584, _e1585, _e1586);
                                    let _e1588 = (_e1435[0] - _e1427[0]);
                                    let _e1589 = (_e1435[1] - _e1427[1]);
                                    let _e1590 = (_e1435[2] - _e1427[2]);
                                    let _e1591 = vec3<f32>(_e1588, _e1589, _e1590);
                                    let _e1592 = (_e1419[0] - _e1435[0]);
                                    let _e1593 = (_e1419[1] - _e1435[1]);
                                    let _e1594 = (_e1419[2] - _e1435[2]);
                                    let _e1595 = vec3<f32>(_e1592, _e1593, _e1594);
                                    let _e1606 = max(max(bitcast<f32>((bitcast<u32>(_e1584) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1585) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1586) & 2147483647u)));
                                    let _e1617 = max(max(bitcast<f32>((bitcast<u32>(_e1588) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1589) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1590) & 2147483647u)));
                                    let _e1630 = max(max(_e1606, _e1617), max(max(bitcast<f32>((bitcast<u32>(_e1592) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1593) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1594) & 2147483647u))));
                                    if (_e1606 == _e1630) {
                                        phi_3103_ = _e1464;
                                        phi_3104_ = _e1461;
                                        phi_3105_ = _e1455;
                                        phi_3106_ = _e1452;
                                        phi_3107_ = vec3<f32>(_e1419[0], _e1419[1], _e1419[2]);
                                        phi_3108_ = _e1595;
                                        phi_3109_ = _e1591;
                                        phi_3110_ = _e1587;
                                    } else {
                                        let _e1632 = (_e1617 == _e1630);
                                        let _e1637 = vec3(_e1632);
                                        phi_3103_ = select(_e1455, _e1473, _e1632);
                                        phi_3104_ = select(_e1452, _e1470, _e1632);
                                        phi_3105_ = select(_e1473, _e1464, _e1632);
                                        phi_3106_ = select(_e1470, _e1461, _e1632);
                                        phi_3107_ = select(vec3<f32>(_e1435[0], _e1435[1], _e1435[2]), vec3<f32>(_e1427[0], _e1427[1], _e1427[2]), _e1637);
                                        phi_3108_ = select(_e1591, _e1587, _e1637);
                                        phi_3109_ = select(_e1587, _e1595, _e1637);
                                        phi_3110_ = select(_e1595, _e1591, _e1637);
                                    }
                                    let _e1643 = phi_3103_;
                                    let _e1645 = phi_3104_;
                                    let _e1647 = phi_3105_;
                                    let _e1649 = phi_3106_;
                                    let _e1651 = phi_3107_;
                                    let _e1653 = phi_3108_;
                                    let _e1655 = phi_3109_;
                                    let _e1657 = phi_3110_;
                                    let _e1664 = ((_e1655.y * _e1653.z) - (_e1653.y * _e1655.z));
                                    let _e1669 = ((_e1655.z * _e1653.x) - (_e1653.z * _e1655.x));
                                    let _e1672 = ((_e1655.x * _e1653.y) - (_e1653.x * _e1655.y));
                                    let _e1675 = ((_e1496 >= _e1500) && (_e1496 >= _e1504));
                                    let _e1676 = (_e1500 >= _e1504);
                                    let _e1690 = (((_e1664 * (select(select(_e1435[0], _e1427[0], _e1676), _e1419[0], _e1675) - _e590.member[0])) + (_e1669 * (select(select(_e1435[1], _e1427[1], _e1676), _e1419[1], _e1675) - _e590.member[1]))) + (_e1672 * (select(select(_e1435[2], _e1427[2], _e1676), _e1419[2], _e1675) - _e590.member[2])));
                                    let _e1695 = (((_e1664 * _e613) + (_e1669 * _e629)) + (_e1672 * _e645));
                                    let _e1696 = (_e1645 - _e1649);
                                    let _e1697 = (_e1643 - _e1647);
                                    let _e1700 = ((_e1696 * _e1696) + (_e1697 * _e1697));
                                    let _e1707 = (-(((_e1649 * _e1696) + (_e1647 * _e1697))) / select(0.000000000000000000000000000000000000011754944f, _e1700, (_e1700 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e1709 = select(1f, _e1707, (_e1707 < 1f));
                                    let _e1711 = select(0f, _e1709, (_e1709 > 0f));
                                    let _e1720 = ((_e1651.x + (_e1657.x * _e1711)) - _e590.member[0]);
                                    let _e1723 = ((_e1651.y + (_e1657.y * _e1711)) - _e590.member[1]);
                                    let _e1726 = ((_e1651.z + (_e1657.z * _e1711)) - _e590.member[2]);
                                    let _e1791 = ((bitcast<f32>((bitcast<u32>(((((_e1664 * _e1720) + (_e1669 * _e1723)) + (_e1672 * _e1726)) - _e1690)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1720) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1723) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1726) & 2147483647u))), _e1630)) * max(max(bitcast<f32>((bitcast<u32>(_e1664) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1669) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1672) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1695) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1655.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1655.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1655.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1653.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1653.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1653.z) & 2147483647u)))))));
                                    let _e1792 = (_e1690 / _e1695);
                                    if (_e1579 && !(_e1791)) {
                                        let _e1795 = (_e1726 / _e645);
                                        let _e1803 = (((_e1664 * (_e1720 - (_e613 * _e1795))) + (_e1669 * (_e1723 - (_e629 * _e1795)))) / _e1695);
                                        phi_3289_ = select(select(_e1795, (_e1795 + _e1803), (bitcast<f32>((bitcast<u32>(_e1803) & 2147483647u)) <= _e1630)), _e1792, _e1791);
                                    } else {
                                        phi_3289_ = _e1792;
                                    }
                                    let _e1812 = phi_3289_;
                                    let _e1814 = select(_e1552, _e1812, (_e1812 < _e1552));
                                    let _e1816 = select(_e1547, _e1814, (_e1814 > _e1547));
                                    let _e1819 = select(_e1816, 0f, (bitcast<u32>(_e1816) == 2147483648u));
                                    let _e1820 = (1f / _e1506);
                                    phi_3315_ = SlimbvhTypeE(_e1819, (_e1500 * _e1820), (_e1504 * _e1820), ((_e1579 && (_e1819 >= _e657)) && (_e1819 <= _e1295.member.member_1)));
                                    phi_3316_ = SlimbvhTypeE();
                                } else {
                                    phi_3315_ = SlimbvhTypeE();
                                    phi_3316_ = SlimbvhTypeE(0f, 0f, 0f, _e1579);
                                }
                                let _e1829 = phi_3315_;
                                let _e1831 = phi_3316_;
                                phi_3319_ = _e1829;
                                phi_3320_ = _e1831;
                                phi_3321_ = select(true, false, _e1579);
                            } else {
                                phi_3319_ = SlimbvhTypeE();
                                phi_3320_ = SlimbvhTypeE(0f, 0f, 0f, _e1490);
                                phi_3321_ = true;
                            }
                            let _e1834 = phi_3319_;
                            let _e1836 = phi_3320_;
                            let _e1838 = phi_3321_;
                            if _e1838 {
                                phi_3325_ = _e1836;
                            } else {
                                phi_3325_ = _e1834;
                            }
                            let _e1840 = phi_3325_;
                            if _e1840.member_3 {
                                phi_3334_ = SlimbvhTypeF(_e1840.member, _e1840.member_1, _e1840.member_2, _e1358);
                            } else {
                                phi_3334_ = _e90;
                            }
                            let _e1847 = phi_3334_;
                            if (_e1847.member_3 != 4294967295u) {
                                if (_e1358 != 4294967295u) {
                                    if (_e1847.member < _e1295.member.member.member) {
                                        phi_3362_ = true;
                                    } else {
                                        if (_e1847.member == _e1295.member.member.member) {
                                            phi_3361_ = (_e1847.member_3 < _e1295.member.member.member_3);
                                        } else {
                                            phi_3361_ = false;
                                        }
                                        let _e1862 = phi_3361_;
                                        phi_3362_ = _e1862;
                                    }
                                    let _e1864 = phi_3362_;
                                    if _e1864 {
                                        phi_3369_ = SlimbvhTypeN(SlimbvhTypeH(_e1847, _e1847.member), _e1295.member_1);
                                    } else {
                                        phi_3369_ = _e1295;
                                    }
                                    let _e1870 = phi_3369_;
                                    if _e1870.member_1 {
                                        phi_3375_ = SlimbvhTypeN(SlimbvhTypeH(_e1870.member.member, bitcast<f32>(4286578687u)), _e1870.member_1);
                                    } else {
                                        phi_3375_ = _e1870;
                                    }
                                    let _e1879 = phi_3375_;
                                    phi_3376_ = _e1879;
                                } else {
                                    phi_3376_ = _e1295;
                                }
                                let _e1881 = phi_3376_;
                                phi_3377_ = _e1881;
                            } else {
                                phi_3377_ = _e1295;
                            }
                            let _e1883 = phi_3377_;
                            phi_2504_ = _e1883;
                        } else {
                            phi_2504_ = SlimbvhTypeN();
                        }
                        let _e1885 = phi_2504_;
                        continue;
                        continuing {
                            phi_2503_ = _e1885;
                            phi_2506_ = _e1310;
                            break if !(_e1316);
                        }
                    }
                    let _e1888 = local_3;
                    let _e1889 = (_e1888 - 1u);
                    let _e1894 = slimbvh_stacks[(((_e1889 % 32u) * 64u) + _e661)];
                    let _e1895 = (_e1894 & 511u);
                    let _e1897 = (_e1895 >> bitcast<u32>(3u));
                    let _e1900 = ((_e1897 == 0u) || (_e1889 == 4294967295u));
                    if _e1900 {
                    } else {
                        slimbvh_stacks[(((_e1889 % 32u) * 64u) + _e661)] = (((_e1894 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1897);
                    }
                    let _e1907 = local_4;
                    let _e1915 = (((_e1894 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1895 & 3u) & 3u));
                    let _e1917 = (_e1915 >> bitcast<u32>(2i));
                    if (_e1917 < _e94) {
                        let _e1923 = slimbvh_nodes.member[_e1917].member_1[(_e1915 & 3u)];
                        phi_3437_ = _e1923;
                    } else {
                        phi_3437_ = 2147483648u;
                    }
                    let _e1925 = phi_3437_;
                    let _e1927 = local_5;
                    let _e2199 = local_8;
                    phi_3446_ = _e2199;
                    phi_3447_ = select(select(_e1907, _e1889, _e1900), 4294967295u, (_e657 > _e1927.member.member_1));
                    phi_3448_ = _e1925;
                } else {
                    phi_3446_ = _e766;
                    let _e2202 = local_9;
                    phi_3447_ = _e2202;
                    let _e2205 = local_10;
                    phi_3448_ = _e2205;
                }
                let _e1933 = phi_3446_;
                let _e1935 = phi_3447_;
                let _e1937 = phi_3448_;
                phi_1650_ = _e1933;
                phi_1653_ = _e1935;
                phi_1655_ = _e1937;
                let _e2211 = local_11;
                phi_1657_ = _e2211;
            } else {
                phi_1650_ = SlimbvhTypeN();
                phi_1653_ = u32();
                phi_1655_ = u32();
                phi_1657_ = u32();
            }
            let _e1939 = phi_1650_;
            let _e1941 = phi_1653_;
            let _e1943 = phi_1655_;
            let _e1945 = phi_1657_;
            continue;
            continuing {
                phi_1649_ = _e1939;
                phi_1652_ = _e1941;
                phi_1654_ = _e1943;
                phi_1656_ = _e1945;
                break if !(_e773);
            }
        }
        let _e1948 = local_6;
        let _e1949 = (_e1948 == 4294967295u);
        let _e1951 = local_7;
        if (_e1951.member.member.member_3 != 4294967295u) {
            let _e1957 = -((_e160 + _e590.member_4));
            let _e1958 = bitcast<u32>(_e1951.member.member.member);
            let _e1962 = (bitcast<i32>((_e1958 >> bitcast<u32>(23i))) & 255i);
            let _e1963 = (_e1962 + _e1957);
            if (_e1962 == 255i) {
                phi_3506_ = _e1951.member.member.member;
            } else {
                if (_e1962 > 0i) {
                    if (_e1963 > 0i) {
                        let _e1967 = (_e1963 < 255i);
                        if _e1967 {
                            phi_3485_ = bitcast<f32>((_e1958 + bitcast<u32>((_e1957 << bitcast<u32>(23i)))));
                        } else {
                            phi_3485_ = f32();
                        }
                        let _e1974 = phi_3485_;
                        phi_3487_ = _e1974;
                        phi_3488_ = select(true, false, _e1967);
                    } else {
                        phi_3487_ = f32();
                        phi_3488_ = true;
                    }
                    let _e1977 = phi_3487_;
                    let _e1979 = phi_3488_;
                    phi_3489_ = _e1977;
                    phi_3490_ = _e1979;
                } else {
                    phi_3489_ = f32();
                    phi_3490_ = true;
                }
                let _e1981 = phi_3489_;
                let _e1983 = phi_3490_;
                if _e1983 {
                    let _e1984 = (_e1958 & 2147483648u);
                    let _e1991 = ((_e1958 & 8388607u) | (select(0u, 1u, ((_e1958 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e1995 = (_e1991 == 0u);
                    if _e1995 {
                        phi_4188_ = bitcast<f32>(_e1984);
                    } else {
                        let _e2000 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1991)), 32u, _e1995) - 8u);
                        let _e2003 = (_e1991 << bitcast<u32>((_e2000 & 31u)));
                        let _e2005 = ((_e1963 + select(0i, 1i, (_e1962 == 0i))) - bitcast<i32>(_e2000));
                        if (_e2005 >= 255i) {
                            phi_4178_ = bitcast<f32>((_e1984 | 2139095040u));
                            phi_4179_ = f32();
                            phi_4180_ = true;
                        } else {
                            let _e2007 = (_e2005 > 0i);
                            if _e2007 {
                                phi_4172_ = bitcast<f32>(((_e1984 | (bitcast<u32>(_e2005) << bitcast<u32>(23i))) | (_e2003 & 8388607u)));
                                phi_4173_ = f32();
                            } else {
                                if (_e2005 < -24i) {
                                    phi_4138_ = 26u;
                                } else {
                                    phi_4138_ = bitcast<u32>((1i - _e2005));
                                }
                                let _e2012 = phi_4138_;
                                let _e2013 = (_e2012 & 31u);
                                let _e2015 = (_e2003 >> bitcast<u32>(_e2013));
                                let _e2019 = (_e2003 & ((1u << bitcast<u32>(_e2013)) - 1u));
                                let _e2023 = (1u << bitcast<u32>(((_e2012 - 1u) & 31u)));
                                if (_e2019 > _e2023) {
                                    phi_4159_ = true;
                                } else {
                                    if (_e2019 == _e2023) {
                                        phi_4156_ = ((_e2015 & 1u) == 1u);
                                    } else {
                                        phi_4156_ = false;
                                    }
                                    let _e2029 = phi_4156_;
                                    phi_4159_ = _e2029;
                                }
                                let _e2031 = phi_4159_;
                                phi_4172_ = f32();
                                phi_4173_ = bitcast<f32>((_e1984 | (_e2015 + select(0u, 1u, _e2031))));
                            }
                            let _e2044 = phi_4172_;
                            let _e2046 = phi_4173_;
                            phi_4178_ = _e2044;
                            phi_4179_ = _e2046;
                            phi_4180_ = _e2007;
                        }
                        let _e2050 = phi_4178_;
                        let _e2052 = phi_4179_;
                        let _e2054 = phi_4180_;
                        phi_4188_ = select(_e2052, _e2050, _e2054);
                    }
                    let _e2058 = phi_4188_;
                    phi_3505_ = _e2058;
                } else {
                    phi_3505_ = _e1981;
                }
                let _e2060 = phi_3505_;
                phi_3506_ = _e2060;
            }
            let _e2062 = phi_3506_;
            let _e2063 = bitcast<u32>(_e2062);
            if ((_e2063 & 2147483647u) >= 2139095040u) {
                phi_3518_ = bitcast<f32>(((_e2063 & 2147483648u) | 2139095039u));
            } else {
                phi_3518_ = _e2062;
            }
            let _e2070 = phi_3518_;
            phi_3523_ = SlimbvhTypeF(_e2070, _e1951.member.member.member_1, _e1951.member.member.member_2, _e1951.member.member.member_3);
        } else {
            phi_3523_ = _e90;
        }
        let _e2075 = phi_3523_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2075.member), bitcast<u32>(_e2075.member_1), bitcast<u32>(_e2075.member_2), _e2075.member_3);
        phi_3536_ = _e1949;
        phi_3537_ = _e1949;
        phi_3538_ = select(true, false, _e1949);
    } else {
        phi_3536_ = bool();
        phi_3537_ = false;
        phi_3538_ = true;
    }
    let _e2086 = phi_3536_;
    let _e2088 = phi_3537_;
    let _e2090 = phi_3538_;
    if _e2090 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e2086, _e2088, _e2090)));
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
