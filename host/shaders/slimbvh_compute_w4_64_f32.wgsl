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
    var phi_541_: u32;
    var phi_547_: u32;
    var phi_553_: u32;
    var phi_818_: i32;
    var phi_829_: i32;
    var phi_943_: i32;
    var phi_1072_: i32;
    var phi_1094_: u32;
    var phi_1095_: u32;
    var phi_1096_: bool;
    var phi_1130_: i32;
    var phi_1152_: u32;
    var phi_1153_: u32;
    var phi_1154_: bool;
    var phi_715_: i32;
    var phi_721_: u32;
    var phi_740_: u32;
    var phi_741_: u32;
    var phi_742_: bool;
    var phi_760_: i32;
    var phi_766_: u32;
    var phi_785_: u32;
    var phi_786_: u32;
    var phi_787_: bool;
    var phi_1164_: SlimbvhTypeC;
    var phi_1400_: SlimbvhTypeN;
    var phi_1463_: array<f32, 3>;
    var phi_1464_: array<f32, 3>;
    var phi_1482_: array<f32, 3>;
    var phi_1483_: array<f32, 3>;
    var phi_1656_: SlimbvhTypeN;
    var phi_1659_: u32;
    var phi_1661_: u32;
    var phi_1663_: u32;
    var phi_1672_: u32;
    var phi_1675_: u32;
    var phi_1677_: u32;
    var phi_1779_: SlimbvhTypeK;
    var phi_1780_: SlimbvhTypeK;
    var phi_1839_: SlimbvhTypeK;
    var phi_1840_: SlimbvhTypeK;
    var phi_1899_: SlimbvhTypeK;
    var phi_1900_: SlimbvhTypeK;
    var phi_2384_: u32;
    var phi_2397_: u32;
    var phi_2410_: u32;
    var phi_2423_: u32;
    var phi_3910_: SlimbvhTypeD;
    var phi_3922_: SlimbvhTypeD;
    var phi_3934_: SlimbvhTypeD;
    var phi_3946_: SlimbvhTypeD;
    var phi_3958_: SlimbvhTypeD;
    var phi_2507_: u32;
    var phi_2512_: u32;
    var phi_2513_: u32;
    var phi_2537_: u32;
    var phi_1673_: u32;
    var phi_1676_: u32;
    var phi_1678_: u32;
    var local: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_2553_: SlimbvhTypeN;
    var phi_2556_: SlimbvhTypeD;
    var phi_2557_: SlimbvhTypeD;
    var phi_2579_: SlimbvhTypeD;
    var phi_2658_: array<vec4<f32>, 3>;
    var phi_2659_: array<vec4<f32>, 3>;
    var phi_2739_: array<vec4<f32>, 3>;
    var phi_2740_: array<vec4<f32>, 3>;
    var phi_2763_: array<f32, 3>;
    var phi_2764_: array<f32, 3>;
    var phi_2778_: array<f32, 3>;
    var phi_2779_: array<f32, 3>;
    var phi_2793_: array<f32, 3>;
    var phi_2794_: array<f32, 3>;
    var phi_3153_: f32;
    var phi_3154_: f32;
    var phi_3155_: f32;
    var phi_3156_: f32;
    var phi_3157_: vec3<f32>;
    var phi_3158_: vec3<f32>;
    var phi_3159_: vec3<f32>;
    var phi_3160_: vec3<f32>;
    var phi_3339_: f32;
    var phi_3365_: SlimbvhTypeE;
    var phi_3366_: SlimbvhTypeE;
    var phi_3369_: SlimbvhTypeE;
    var phi_3370_: SlimbvhTypeE;
    var phi_3371_: bool;
    var phi_3375_: SlimbvhTypeE;
    var phi_3384_: SlimbvhTypeF;
    var phi_3411_: bool;
    var phi_3412_: bool;
    var phi_3419_: SlimbvhTypeN;
    var phi_3425_: SlimbvhTypeN;
    var phi_3426_: SlimbvhTypeN;
    var phi_3427_: SlimbvhTypeN;
    var phi_2554_: SlimbvhTypeN;
    var local_3: u32;
    var local_4: u32;
    var phi_3488_: u32;
    var local_5: SlimbvhTypeN;
    var phi_3497_: SlimbvhTypeN;
    var phi_3498_: u32;
    var phi_3499_: u32;
    var phi_1657_: SlimbvhTypeN;
    var phi_1660_: u32;
    var phi_1662_: u32;
    var phi_1664_: u32;
    var local_6: u32;
    var local_7: SlimbvhTypeN;
    var phi_3536_: f32;
    var phi_3538_: f32;
    var phi_3539_: bool;
    var phi_3540_: f32;
    var phi_3541_: bool;
    var phi_4189_: u32;
    var phi_4207_: bool;
    var phi_4210_: bool;
    var phi_4223_: f32;
    var phi_4224_: f32;
    var phi_4229_: f32;
    var phi_4230_: f32;
    var phi_4231_: bool;
    var phi_4239_: f32;
    var phi_3556_: f32;
    var phi_3557_: f32;
    var phi_3569_: f32;
    var phi_3574_: SlimbvhTypeF;
    var phi_3587_: bool;
    var phi_3588_: bool;
    var phi_3589_: bool;
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
        phi_541_ = 0u;
    } else {
        phi_541_ = select(2u, 1u, (_e172 == _e180));
    }
    let _e198 = phi_541_;
    let _e199 = (_e198 == 2u);
    if _e199 {
        phi_547_ = 0u;
    } else {
        phi_547_ = (_e198 + 1u);
    }
    let _e202 = phi_547_;
    let _e203 = (_e202 == 2u);
    if _e203 {
        phi_553_ = 0u;
    } else {
        phi_553_ = (_e202 + 1u);
    }
    let _e206 = phi_553_;
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
            phi_715_ = 255i;
        } else {
            phi_715_ = (bitcast<i32>((_e168 >> bitcast<u32>(23i))) + _e509);
        }
        let _e534 = phi_715_;
        if (_e168 == 0u) {
            phi_721_ = 0u;
        } else {
            phi_721_ = (_e168 | 8388608u);
        }
        let _e538 = phi_721_;
        if (_e534 <= 0i) {
            phi_741_ = u32();
            phi_742_ = true;
        } else {
            let _e545 = (_e538 == 0u);
            if _e545 {
                phi_740_ = u32();
            } else {
                phi_740_ = select(((bitcast<u32>(_e534) << bitcast<u32>(23i)) | (_e538 & 8388607u)), 2139095039u, (_e534 >= 255i));
            }
            let _e549 = phi_740_;
            phi_741_ = _e549;
            phi_742_ = _e545;
        }
        let _e551 = phi_741_;
        let _e553 = phi_742_;
        if (_e176 >= 2139095040u) {
            phi_760_ = 255i;
        } else {
            phi_760_ = (bitcast<i32>((_e176 >> bitcast<u32>(23i))) + _e509);
        }
        let _e564 = phi_760_;
        if (_e176 == 0u) {
            phi_766_ = 0u;
        } else {
            phi_766_ = (_e176 | 8388608u);
        }
        let _e568 = phi_766_;
        if (_e564 <= 0i) {
            phi_786_ = u32();
            phi_787_ = true;
        } else {
            let _e575 = (_e568 == 0u);
            if _e575 {
                phi_785_ = u32();
            } else {
                phi_785_ = select(((bitcast<u32>(_e564) << bitcast<u32>(23i)) | (_e568 & 8388607u)), 2139095039u, (_e564 >= 255i));
            }
            let _e579 = phi_785_;
            phi_786_ = _e579;
            phi_787_ = _e575;
        }
        let _e581 = phi_786_;
        let _e583 = phi_787_;
        phi_1164_ = SlimbvhTypeC(array<f32, 3>((_e209 * _e514), (_e213 * _e514), (_e216 * _e514)), array<f32, 3>((_e218 * _e519), (_e220 * _e519), (_e222 * _e519)), bitcast<f32>(((_e167 & 2147483648u) | select(_e551, 0u, _e553))), bitcast<f32>(((_e175 & 2147483648u) | select(_e581, 0u, _e583))), _e508);
    } else {
        let _e255 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e180, _e193))) & 2147483647u);
        if (_e255 >= 8388608u) {
            phi_818_ = (bitcast<i32>((_e255 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_818_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e255)), 32u, (_e255 == 0u))));
        }
        let _e269 = phi_818_;
        let _e270 = (_e160 + _e269);
        if (_e160 < -126i) {
            phi_829_ = -126i;
        } else {
            phi_829_ = select(_e160, 127i, (_e160 > 127i));
        }
        let _e275 = phi_829_;
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
            phi_943_ = -126i;
        } else {
            phi_943_ = select(_e339, 127i, (_e339 > 127i));
        }
        let _e344 = phi_943_;
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
            phi_1072_ = 255i;
        } else {
            phi_1072_ = (((_e417 + select(0i, 1i, (_e417 == 0i))) - _e424) + _e270);
        }
        let _e432 = phi_1072_;
        let _e436 = (_e414 << bitcast<u32>(((_e424 & 31i) & 31i)));
        if (_e432 <= 0i) {
            phi_1095_ = u32();
            phi_1096_ = true;
        } else {
            let _e443 = (_e436 == 0u);
            if _e443 {
                phi_1094_ = u32();
            } else {
                phi_1094_ = select(((bitcast<u32>(_e432) << bitcast<u32>(23i)) | (_e436 & 8388607u)), 2139095039u, (_e432 >= 255i));
            }
            let _e447 = phi_1094_;
            phi_1095_ = _e447;
            phi_1096_ = _e443;
        }
        let _e449 = phi_1095_;
        let _e451 = phi_1096_;
        let _e462 = ((_e176 & 8388607u) | (select(0u, 1u, ((_e176 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e465 = bitcast<i32>((_e176 >> bitcast<u32>(23i)));
        let _e472 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e462)), 32u, (_e462 == 0u))) - 8i);
        if (_e465 == 255i) {
            phi_1130_ = 255i;
        } else {
            phi_1130_ = (((_e465 + select(0i, 1i, (_e465 == 0i))) - _e472) + _e270);
        }
        let _e480 = phi_1130_;
        let _e484 = (_e462 << bitcast<u32>(((_e472 & 31i) & 31i)));
        if (_e480 <= 0i) {
            phi_1153_ = u32();
            phi_1154_ = true;
        } else {
            let _e491 = (_e484 == 0u);
            if _e491 {
                phi_1152_ = u32();
            } else {
                phi_1152_ = select(((bitcast<u32>(_e480) << bitcast<u32>(23i)) | (_e484 & 8388607u)), 2139095039u, (_e480 >= 255i));
            }
            let _e495 = phi_1152_;
            phi_1153_ = _e495;
            phi_1154_ = _e491;
        }
        let _e497 = phi_1153_;
        let _e499 = phi_1154_;
        phi_1164_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e287 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e287 & 2147483648u))), _e209, _e289) * _e280) * select(0.00000011920929f, 1f, _e289)) * _e286), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e304 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e304 & 2147483648u))), _e213, _e306) * _e280) * select(0.00000011920929f, 1f, _e306)) * _e286), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e321 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e321 & 2147483648u))), _e216, _e323) * _e280) * select(0.00000011920929f, 1f, _e323)) * _e286)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e356 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e356 & 2147483648u))), _e218, _e358) * _e349) * select(0.00000011920929f, 1f, _e358)) * _e355), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e373 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e373 & 2147483648u))), _e220, _e375) * _e349) * select(0.00000011920929f, 1f, _e375)) * _e355), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e390 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e390 & 2147483648u))), _e222, _e392) * _e349) * select(0.00000011920929f, 1f, _e392)) * _e355)), bitcast<f32>(((_e167 & 2147483648u) | select(_e449, 0u, _e451))), bitcast<f32>(((_e175 & 2147483648u) | select(_e497, 0u, _e499))), _e269);
    }
    let _e590 = phi_1164_;
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
            phi_1400_ = SlimbvhTypeN(SlimbvhTypeH(_e90, _e656), true);
        } else {
            phi_1400_ = SlimbvhTypeN(SlimbvhTypeH(_e90, _e656), false);
        }
        let _e669 = phi_1400_;
        let _e674 = (_e202 & 3u);
        let _e675 = (_e206 & 3u);
        let _e676 = (_e198 & 3u);
        let _e679 = (bitcast<u32>(_e617) >> bitcast<u32>(31i));
        let _e682 = (bitcast<u32>(_e633) >> bitcast<u32>(31i));
        let _e685 = (bitcast<u32>(_e649) >> bitcast<u32>(31i));
        let _e689 = (f32(bitcast<i32>(_e106)) * _e142);
        let _e691 = (f32(bitcast<i32>(_e110)) * _e142);
        let _e693 = (f32(bitcast<i32>(_e114)) * _e142);
        let _e694 = (_e674 == 0u);
        if _e694 {
            phi_1464_ = array<f32, 3>(_e689, _e691, _e693);
        } else {
            if (_e674 == 1u) {
                phi_1463_ = array<f32, 3>(_e691, _e693, _e689);
            } else {
                phi_1463_ = array<f32, 3>(_e693, _e689, _e691);
            }
            let _e699 = phi_1463_;
            phi_1464_ = _e699;
        }
        let _e702 = phi_1464_;
        let _e704 = (f32(bitcast<i32>(_e122)) * _e142);
        let _e706 = (f32(bitcast<i32>(_e126)) * _e142);
        let _e708 = (f32(bitcast<i32>(_e130)) * _e142);
        if _e694 {
            phi_1483_ = array<f32, 3>(_e704, _e706, _e708);
        } else {
            if (_e674 == 1u) {
                phi_1482_ = array<f32, 3>(_e706, _e708, _e704);
            } else {
                phi_1482_ = array<f32, 3>(_e708, _e704, _e706);
            }
            let _e713 = phi_1482_;
            phi_1483_ = _e713;
        }
        let _e716 = phi_1483_;
        let _e727 = ((_e702[0] - _e614) * _e617);
        let _e728 = ((_e716[0] - _e615) * _e617);
        let _e729 = vec4<f32>(_e727, f32(), _e728, f32());
        let _e732 = ((_e702[1] - _e630) * _e633);
        let _e733 = ((_e716[1] - _e631) * _e633);
        let _e734 = vec4<f32>(_e732, f32(), _e733, f32());
        let _e737 = ((_e702[2] - _e646) * _e649);
        let _e738 = ((_e716[2] - _e647) * _e649);
        let _e739 = vec4<f32>(_e737, f32(), _e738, f32());
        let _e740 = vec4<f32>(_e728, f32(), _e727, f32());
        let _e742 = vec4<f32>(_e733, f32(), _e732, f32());
        let _e744 = vec4<f32>(_e738, f32(), _e737, f32());
        phi_1656_ = _e669;
        phi_1659_ = select(4294967295u, select(4294967295u, 0u, (_e657 <= _e656)), (max(max(max(min(_e729, _e740).x, min(_e734, _e742).x), min(_e739, _e744).x), _e657) <= min((min(min(max(_e729, _e740).x, max(_e734, _e742).x), max(_e739, _e744).x) + (max(max(_e739, _e744).x, -(min(_e739, _e744).x)) * 0.0000019073523f)), _e669.member.member_1)));
        phi_1661_ = select(0u, 2147483648u, (_e94 == 0u));
        phi_1663_ = (_e94 + 1u);
        loop {
            let _e768 = phi_1656_;
            let _e770 = phi_1659_;
            let _e772 = phi_1661_;
            let _e774 = phi_1663_;
            local_6 = _e770;
            local_7 = _e768;
            let _e775 = (_e770 <= 32u);
            if _e775 {
                phi_1672_ = _e770;
                phi_1675_ = _e772;
                phi_1677_ = _e774;
                loop {
                    let _e777 = phi_1672_;
                    let _e779 = phi_1675_;
                    let _e781 = phi_1677_;
                    local_1 = _e779;
                    local_2 = _e779;
                    local_3 = _e777;
                    local_4 = _e777;
                    local_9 = _e777;
                    local_10 = _e779;
                    local_11 = _e781;
                    let _e782 = (_e777 <= 32u);
                    let _e785 = (_e782 && !((_e779 >= _e94)));
                    local = _e782;
                    if _e785 {
                        let _e791 = slimbvh_nodes.member[_e779].member[select(_e674, 2u, (2u < _e674))];
                        let _e797 = slimbvh_nodes.member[_e779].member[select(_e675, 2u, (2u < _e675))];
                        let _e803 = slimbvh_nodes.member[_e779].member[select(_e676, 2u, (2u < _e676))];
                        let _e806 = bitcast<u32>(_e142);
                        let _e811 = bitcast<f32>(_e791.x);
                        let _e816 = (_e811 + (f32((_e791.w >> bitcast<u32>(5u))) * _e142));
                        if (_e679 == 0u) {
                            phi_1779_ = SlimbvhTypeK(_e791.z, _e816);
                            phi_1780_ = SlimbvhTypeK(_e791.y, _e811);
                        } else {
                            phi_1779_ = SlimbvhTypeK(_e791.y, _e811);
                            phi_1780_ = SlimbvhTypeK(_e791.z, _e816);
                        }
                        let _e827 = phi_1779_;
                        let _e829 = phi_1780_;
                        let _e833 = bitcast<f32>(((_e806 + ((_e791.w & 31u) << bitcast<u32>(23i))) ^ (_e679 << bitcast<u32>(31i))));
                        let _e873 = bitcast<f32>(_e797.x);
                        let _e878 = (_e873 + (f32((_e797.w >> bitcast<u32>(5u))) * _e142));
                        if (_e682 == 0u) {
                            phi_1839_ = SlimbvhTypeK(_e797.z, _e878);
                            phi_1840_ = SlimbvhTypeK(_e797.y, _e873);
                        } else {
                            phi_1839_ = SlimbvhTypeK(_e797.y, _e873);
                            phi_1840_ = SlimbvhTypeK(_e797.z, _e878);
                        }
                        let _e889 = phi_1839_;
                        let _e891 = phi_1840_;
                        let _e895 = bitcast<f32>(((_e806 + ((_e797.w & 31u) << bitcast<u32>(23i))) ^ (_e682 << bitcast<u32>(31i))));
                        let _e935 = bitcast<f32>(_e803.x);
                        let _e940 = (_e935 + (f32((_e803.w >> bitcast<u32>(5u))) * _e142));
                        if (_e685 == 0u) {
                            phi_1899_ = SlimbvhTypeK(_e803.z, _e940);
                            phi_1900_ = SlimbvhTypeK(_e803.y, _e935);
                        } else {
                            phi_1899_ = SlimbvhTypeK(_e803.y, _e935);
                            phi_1900_ = SlimbvhTypeK(_e803.z, _e940);
                        }
                        let _e951 = phi_1899_;
                        let _e953 = phi_1900_;
                        let _e957 = bitcast<f32>(((_e806 + ((_e803.w & 31u) << bitcast<u32>(23i))) ^ (_e685 << bitcast<u32>(31i))));
                        let _e993 = (_e833 * _e617);
                        let _e1000 = (((_e829.member_1 - _e614) * _e617) + (bitcast<f32>((bitcast<u32>(_e993) & 2147483647u)) * -0.00012207031f));
                        let _e1009 = (-(_e833) * _e617);
                        let _e1016 = (((_e827.member_1 - _e615) * _e617) + (bitcast<f32>((bitcast<u32>(_e1009) & 2147483647u)) * 0.00012207031f));
                        let _e1025 = (_e895 * _e633);
                        let _e1032 = (((_e891.member_1 - _e630) * _e633) + (bitcast<f32>((bitcast<u32>(_e1025) & 2147483647u)) * -0.00012207031f));
                        let _e1041 = (-(_e895) * _e633);
                        let _e1048 = (((_e889.member_1 - _e631) * _e633) + (bitcast<f32>((bitcast<u32>(_e1041) & 2147483647u)) * 0.00012207031f));
                        let _e1057 = (_e957 * _e649);
                        let _e1064 = (((_e953.member_1 - _e646) * _e649) + (bitcast<f32>((bitcast<u32>(_e1057) & 2147483647u)) * -0.00012207031f));
                        let _e1069 = ((f32((_e953.member & 255u)) * _e1057) + _e1064);
                        let _e1070 = ((f32(((_e953.member >> bitcast<u32>(8u)) & 255u)) * _e1057) + _e1064);
                        let _e1071 = ((f32(((_e953.member >> bitcast<u32>(16u)) & 255u)) * _e1057) + _e1064);
                        let _e1072 = ((f32(((_e953.member >> bitcast<u32>(24u)) & 255u)) * _e1057) + _e1064);
                        let _e1073 = (-(_e957) * _e649);
                        let _e1080 = (((_e951.member_1 - _e647) * _e649) + (bitcast<f32>((bitcast<u32>(_e1073) & 2147483647u)) * 0.00012207031f));
                        let _e1085 = ((f32((_e951.member & 255u)) * _e1073) + _e1080);
                        let _e1086 = ((f32(((_e951.member >> bitcast<u32>(8u)) & 255u)) * _e1073) + _e1080);
                        let _e1087 = ((f32(((_e951.member >> bitcast<u32>(16u)) & 255u)) * _e1073) + _e1080);
                        let _e1088 = ((f32(((_e951.member >> bitcast<u32>(24u)) & 255u)) * _e1073) + _e1080);
                        let _e1121 = max(max(max(((f32((_e829.member & 255u)) * _e993) + _e1000), ((f32((_e891.member & 255u)) * _e1025) + _e1032)), _e1069), _e657);
                        let _e1122 = max(max(max(((f32(((_e829.member >> bitcast<u32>(8u)) & 255u)) * _e993) + _e1000), ((f32(((_e891.member >> bitcast<u32>(8u)) & 255u)) * _e1025) + _e1032)), _e1070), _e657);
                        let _e1123 = max(max(max(((f32(((_e829.member >> bitcast<u32>(16u)) & 255u)) * _e993) + _e1000), ((f32(((_e891.member >> bitcast<u32>(16u)) & 255u)) * _e1025) + _e1032)), _e1071), _e657);
                        let _e1124 = max(max(max(((f32(((_e829.member >> bitcast<u32>(24u)) & 255u)) * _e993) + _e1000), ((f32(((_e891.member >> bitcast<u32>(24u)) & 255u)) * _e1025) + _e1032)), _e1072), _e657);
                        let _e1129 = (_e768.member.member_1 + (bitcast<f32>((bitcast<u32>(_e768.member.member_1) & 2147483647u)) * 0.0000004768374f));
                        if (_e1121 <= min((min(min(((f32((_e827.member & 255u)) * _e1009) + _e1016), ((f32((_e889.member & 255u)) * _e1041) + _e1048)), _e1085) + (max(_e1085, -(_e1069)) * 0.0000023841915f)), _e1129)) {
                            phi_2384_ = (((bitcast<u32>(_e1121) ^ select(0u, 4294967288u, _e669.member_1)) & 2147483640u) | 4u);
                        } else {
                            phi_2384_ = 4294967288u;
                        }
                        let _e1144 = phi_2384_;
                        if (_e1122 <= min((min(min(((f32(((_e827.member >> bitcast<u32>(8u)) & 255u)) * _e1009) + _e1016), ((f32(((_e889.member >> bitcast<u32>(8u)) & 255u)) * _e1041) + _e1048)), _e1086) + (max(_e1086, -(_e1070)) * 0.0000023841915f)), _e1129)) {
                            phi_2397_ = ((((bitcast<u32>(_e1122) ^ select(0u, 4294967288u, _e669.member_1)) & 2147483640u) | 4u) | 1u);
                        } else {
                            phi_2397_ = 4294967288u;
                        }
                        let _e1152 = phi_2397_;
                        if (_e1123 <= min((min(min(((f32(((_e827.member >> bitcast<u32>(16u)) & 255u)) * _e1009) + _e1016), ((f32(((_e889.member >> bitcast<u32>(16u)) & 255u)) * _e1041) + _e1048)), _e1087) + (max(_e1087, -(_e1071)) * 0.0000023841915f)), _e1129)) {
                            phi_2410_ = ((((bitcast<u32>(_e1123) ^ select(0u, 4294967288u, _e669.member_1)) & 2147483640u) | 4u) | 2u);
                        } else {
                            phi_2410_ = 4294967288u;
                        }
                        let _e1160 = phi_2410_;
                        if (_e1124 <= min((min(min(((f32(((_e827.member >> bitcast<u32>(24u)) & 255u)) * _e1009) + _e1016), ((f32(((_e889.member >> bitcast<u32>(24u)) & 255u)) * _e1041) + _e1048)), _e1088) + (max(_e1088, -(_e1072)) * 0.0000023841915f)), _e1129)) {
                            phi_2423_ = ((((bitcast<u32>(_e1124) ^ select(0u, 4294967288u, _e669.member_1)) & 2147483640u) | 4u) | 3u);
                        } else {
                            phi_2423_ = 4294967288u;
                        }
                        let _e1168 = phi_2423_;
                        if (_e1144 < _e1152) {
                            phi_3910_ = SlimbvhTypeD(_e1144, _e1152);
                        } else {
                            phi_3910_ = SlimbvhTypeD(_e1152, _e1144);
                        }
                        let _e1173 = phi_3910_;
                        if (_e1160 < _e1168) {
                            phi_3922_ = SlimbvhTypeD(_e1160, _e1168);
                        } else {
                            phi_3922_ = SlimbvhTypeD(_e1168, _e1160);
                        }
                        let _e1180 = phi_3922_;
                        if (_e1173.member < _e1180.member) {
                            phi_3934_ = SlimbvhTypeD(_e1173.member, _e1180.member);
                        } else {
                            phi_3934_ = SlimbvhTypeD(_e1180.member, _e1173.member);
                        }
                        let _e1187 = phi_3934_;
                        if (_e1173.member_1 < _e1180.member_1) {
                            phi_3946_ = SlimbvhTypeD(_e1173.member_1, _e1180.member_1);
                        } else {
                            phi_3946_ = SlimbvhTypeD(_e1180.member_1, _e1173.member_1);
                        }
                        let _e1194 = phi_3946_;
                        if (_e1194.member < _e1187.member_1) {
                            phi_3958_ = SlimbvhTypeD(_e1194.member, _e1187.member_1);
                        } else {
                            phi_3958_ = SlimbvhTypeD(_e1187.member_1, _e1194.member);
                        }
                        let _e1201 = phi_3958_;
                        let _e1216 = (((_e1187.member & 7u) | ((_e1201.member & 7u) << bitcast<u32>(3u))) | (((_e1201.member_1 & 7u) | ((_e1194.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                        if (_e1216 == 0u) {
                            let _e1236 = (_e777 - 1u);
                            let _e1241 = slimbvh_stacks[(((_e1236 % 32u) * 64u) + _e661)];
                            let _e1242 = (_e1241 & 511u);
                            let _e1244 = (_e1242 >> bitcast<u32>(3u));
                            let _e1247 = ((_e1244 == 0u) || (_e1236 == 4294967295u));
                            if _e1247 {
                            } else {
                                slimbvh_stacks[(((_e1236 % 32u) * 64u) + _e661)] = (((_e1241 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1244);
                            }
                            phi_2512_ = select(_e777, _e1236, _e1247);
                            phi_2513_ = (((_e1241 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1242 & 3u) & 3u));
                        } else {
                            let _e1219 = (_e1216 >> bitcast<u32>(3u));
                            if (_e1219 == 0u) {
                                phi_2507_ = _e777;
                            } else {
                                slimbvh_stacks[(((_e777 % 32u) * 64u) + _e661)] = ((_e779 << bitcast<u32>(9u)) | _e1219);
                                phi_2507_ = (_e777 + 1u);
                            }
                            let _e1230 = phi_2507_;
                            phi_2512_ = _e1230;
                            phi_2513_ = ((_e779 << bitcast<u32>(2i)) | ((_e1216 & 3u) & 3u));
                        }
                        let _e1262 = phi_2512_;
                        let _e1264 = phi_2513_;
                        let _e1266 = (_e1264 >> bitcast<u32>(2i));
                        if (_e1266 < _e94) {
                            let _e1272 = slimbvh_nodes.member[_e1266].member_1[(_e1264 & 3u)];
                            phi_2537_ = _e1272;
                        } else {
                            phi_2537_ = 2147483648u;
                        }
                        let _e1274 = phi_2537_;
                        let _e1275 = (_e781 - 1u);
                        phi_1673_ = select(_e1262, 4294967295u, (_e1275 == 0u));
                        phi_1676_ = _e1274;
                        phi_1678_ = _e1275;
                    } else {
                        phi_1673_ = u32();
                        phi_1676_ = u32();
                        phi_1678_ = u32();
                    }
                    let _e1279 = phi_1673_;
                    let _e1281 = phi_1676_;
                    let _e1283 = phi_1678_;
                    continue;
                    continuing {
                        phi_1672_ = _e1279;
                        phi_1675_ = _e1281;
                        phi_1677_ = _e1283;
                        break if !(_e785);
                    }
                }
                let _e1286 = local;
                if _e1286 {
                    let _e1288 = local_1;
                    let _e1291 = local_2;
                    phi_2553_ = _e768;
                    phi_2556_ = SlimbvhTypeD(0u, ((_e1291 >> bitcast<u32>(28u)) & 7u));
                    loop {
                        let _e1297 = phi_2553_;
                        let _e1299 = phi_2556_;
                        local_5 = _e1297;
                        local_8 = _e1297;
                        if (_e1299.member < _e1299.member_1) {
                            phi_2557_ = SlimbvhTypeD((_e1299.member + 1u), _e1299.member_1);
                            phi_2579_ = SlimbvhTypeD(1u, _e1299.member);
                        } else {
                            phi_2557_ = _e1299;
                            phi_2579_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                        }
                        let _e1312 = phi_2557_;
                        let _e1314 = phi_2579_;
                        let _e1318 = (bitcast<i32>(_e1314.member) != 0i);
                        if _e1318 {
                            let _e1319 = ((_e1288 & 268435455u) + _e1314.member_1);
                            let _e1320 = (_e1319 / 2u);
                            let _e1321 = (_e1319 % 2u);
                            let _e1322 = (_e1320 >= arrayLength((&slimbvh_triangles.member)));
                            if _e1322 {
                                phi_2659_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e1323 = (2u * _e1321);
                                let _e1327 = slimbvh_triangles.member[_e1320][_e1323];
                                let _e1332 = slimbvh_triangles.member[_e1320][(_e1323 + 1u)];
                                let _e1337 = slimbvh_triangles.member[_e1320][(_e1323 + 2u)];
                                if (_e1321 == 0u) {
                                    phi_2658_ = array<vec4<f32>, 3>(_e1327, _e1332, _e1337);
                                } else {
                                    phi_2658_ = array<vec4<f32>, 3>(vec4<f32>(_e1327.z, _e1327.w, _e1332.x, _e1332.y), vec4<f32>(_e1332.z, _e1332.w, _e1337.x, _e1337.y), vec4<f32>(_e1337.z, _e1337.w, 0f, 0f));
                                }
                                let _e1355 = phi_2658_;
                                phi_2659_ = _e1355;
                            }
                            let _e1357 = phi_2659_;
                            let _e1360 = bitcast<u32>(_e1357[2].y);
                            if _e1322 {
                                phi_2740_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e1361 = (2u * _e1321);
                                let _e1365 = slimbvh_triangles.member[_e1320][_e1361];
                                let _e1370 = slimbvh_triangles.member[_e1320][(_e1361 + 1u)];
                                let _e1375 = slimbvh_triangles.member[_e1320][(_e1361 + 2u)];
                                if (_e1321 == 0u) {
                                    phi_2739_ = array<vec4<f32>, 3>(_e1365, _e1370, _e1375);
                                } else {
                                    phi_2739_ = array<vec4<f32>, 3>(vec4<f32>(_e1365.z, _e1365.w, _e1370.x, _e1370.y), vec4<f32>(_e1370.z, _e1370.w, _e1375.x, _e1375.y), vec4<f32>(_e1375.z, _e1375.w, 0f, 0f));
                                }
                                let _e1393 = phi_2739_;
                                phi_2740_ = _e1393;
                            }
                            let _e1395 = phi_2740_;
                            if _e207 {
                                phi_2764_ = array<f32, 3>(_e1395[0].x, _e1395[0].y, _e1395[0].z);
                            } else {
                                if (_e202 == 1u) {
                                    phi_2763_ = array<f32, 3>(_e1395[0].y, _e1395[0].z, _e1395[0].x);
                                } else {
                                    phi_2763_ = array<f32, 3>(_e1395[0].z, _e1395[0].x, _e1395[0].y);
                                }
                                let _e1418 = phi_2763_;
                                phi_2764_ = _e1418;
                            }
                            let _e1421 = phi_2764_;
                            if _e207 {
                                phi_2779_ = array<f32, 3>(_e1395[0].w, _e1395[1].x, _e1395[1].y);
                            } else {
                                if (_e202 == 1u) {
                                    phi_2778_ = array<f32, 3>(_e1395[1].x, _e1395[1].y, _e1395[0].w);
                                } else {
                                    phi_2778_ = array<f32, 3>(_e1395[1].y, _e1395[0].w, _e1395[1].x);
                                }
                                let _e1426 = phi_2778_;
                                phi_2779_ = _e1426;
                            }
                            let _e1429 = phi_2779_;
                            if _e207 {
                                phi_2794_ = array<f32, 3>(_e1395[1].z, _e1395[1].w, _e1395[2].x);
                            } else {
                                if (_e202 == 1u) {
                                    phi_2793_ = array<f32, 3>(_e1395[1].w, _e1395[2].x, _e1395[1].z);
                                } else {
                                    phi_2793_ = array<f32, 3>(_e1395[2].x, _e1395[1].z, _e1395[1].w);
                                }
                                let _e1434 = phi_2793_;
                                phi_2794_ = _e1434;
                            }
                            let _e1437 = phi_2794_;
                            let _e1451 = (_e1421[2] - _e590.member[2]);
                            let _e1454 = (((_e1421[0] - _e590.member[0]) * _e645) - (_e1451 * _e613));
                            let _e1457 = (((_e1421[1] - _e590.member[1]) * _e645) - (_e1451 * _e629));
                            let _e1460 = (_e1429[2] - _e590.member[2]);
                            let _e1463 = (((_e1429[0] - _e590.member[0]) * _e645) - (_e1460 * _e613));
                            let _e1466 = (((_e1429[1] - _e590.member[1]) * _e645) - (_e1460 * _e629));
                            let _e1469 = (_e1437[2] - _e590.member[2]);
                            let _e1472 = (((_e1437[0] - _e590.member[0]) * _e645) - (_e1469 * _e613));
                            let _e1475 = (((_e1437[1] - _e590.member[1]) * _e645) - (_e1469 * _e629));
                            let _e1476 = (_e1472 * _e1466);
                            let _e1477 = (_e1475 * _e1463);
                            let _e1478 = (_e1454 * _e1475);
                            let _e1479 = (_e1457 * _e1472);
                            let _e1480 = (_e1463 * _e1457);
                            let _e1481 = (_e1466 * _e1454);
                            let _e1486 = (((_e1476 >= _e1477) && (_e1478 >= _e1479)) && (_e1480 >= _e1481));
                            let _e1492 = (_e1486 || (((_e1476 <= _e1477) && (_e1478 <= _e1479)) && (_e1480 <= _e1481)));
                            if _e1492 {
                                let _e1494 = select(-1f, 1f, _e1486);
                                let _e1496 = ((_e1476 - _e1477) * _e1494);
                                let _e1498 = select(0f, _e1496, (_e1496 > 0f));
                                let _e1500 = ((_e1478 - _e1479) * _e1494);
                                let _e1502 = select(0f, _e1500, (_e1500 > 0f));
                                let _e1504 = ((_e1480 - _e1481) * _e1494);
                                let _e1506 = select(0f, _e1504, (_e1504 > 0f));
                                let _e1508 = ((_e1498 + _e1502) + _e1506);
                                let _e1523 = ((min(min(_e1421[0], _e1429[0]), _e1437[0]) - _e614) * _e617);
                                let _e1524 = ((max(max(_e1421[0], _e1429[0]), _e1437[0]) - _e615) * _e617);
                                let _e1525 = vec4<f32>(_e1523, f32(), _e1524, f32());
                                let _e1528 = ((min(min(_e1421[1], _e1429[1]), _e1437[1]) - _e630) * _e633);
                                let _e1529 = ((max(max(_e1421[1], _e1429[1]), _e1437[1]) - _e631) * _e633);
                                let _e1530 = vec4<f32>(_e1528, f32(), _e1529, f32());
                                let _e1533 = ((min(min(_e1421[2], _e1429[2]), _e1437[2]) - _e646) * _e649);
                                let _e1534 = ((max(max(_e1421[2], _e1429[2]), _e1437[2]) - _e647) * _e649);
                                let _e1535 = vec4<f32>(_e1533, f32(), _e1534, f32());
                                let _e1536 = vec4<f32>(_e1524, f32(), _e1523, f32());
                                let _e1538 = vec4<f32>(_e1529, f32(), _e1528, f32());
                                let _e1540 = vec4<f32>(_e1534, f32(), _e1533, f32());
                                let _e1549 = max(max(min(_e1525, _e1536).x, min(_e1530, _e1538).x), min(_e1535, _e1540).x);
                                let _e1554 = min(min(max(_e1525, _e1536).x, max(_e1530, _e1538).x), max(_e1535, _e1540).x);
                                let _e1559 = max(_e1549, _e657);
                                let _e1581 = (((((_e1492 && (_e1508 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1454, _e1463), _e1472) <= 0f) && (max(max(_e1454, _e1463), _e1472) >= 0f))) && ((min(min(_e1457, _e1466), _e1475) <= 0f) && (max(max(_e1457, _e1466), _e1475) >= 0f))) && (_e1559 <= (_e1554 + (max(max(_e1535, _e1540).x, -(min(_e1535, _e1540).x)) * 0.0000019073523f)))) && (_e1559 <= _e1297.member.member_1));
                                if _e1581 {
                                    let _e1586 = (_e1429[0] - _e1421[0]);
                                    let _e1587 = (_e1429[1] - _e1421[1]);
                                    let _e1588 = (_e1429[2] - _e1421[2]);
                                    let _e1589 = vec3<f32>(_e1586, _e1587, _e1588);
                                    let _e1590 = (_e1437[0] - _e1429[0]);
                                    let _e1591 = (_e1437[1] - _e1429[1]);
                                    let _e1592 = (_e1437[2] - _e1429[2]);
                                    let _e1593 = vec3<f32>(_e1590, _e1591, _e1592);
                                    let _e1594 = (_e1421[0] - _e1437[0]);
                                    let _e1595 = (_e1421[1] - _e1437[1]);
                                    let _e1596 = (_e1421[2] - _e1437[2]);
                                    let _e1597 = vec3<f32>(_e1594, _e1595, _e1596);
                                    let _e1608 = max(max(bitcast<f32>((bitcast<u32>(_e1586) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1587) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1588) & 2147483647u)));
                                    let _e1619 = max(max(bitcast<f32>((bitcast<u32>(_e1590) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1591) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1592) & 2147483647u)));
                                    let _e1632 = max(max(_e1608, _e1619), max(max(bitcast<f32>((bitcast<u32>(_e1594) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1595) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1596) & 2147483647u))));
                                    if (_e1608 == _e1632) {
                                        phi_3153_ = _e1466;
                                        phi_3154_ = _e1463;
                                        phi_3155_ = _e1457;
                                        phi_3156_ = _e1454;
                                        phi_3157_ = vec3<f32>(_e1421[0], _e1421[1], _e1421[2]);
                                        phi_3158_ = _e1597;
                                        phi_3159_ = _e1593;
                                        phi_3160_ = _e1589;
                                    } else {
                                        let _e1634 = (_e1619 == _e1632);
                                        let _e1639 = vec3(_e1634);
                                        phi_3153_ = select(_e1457, _e1475, _e1634);
                                        phi_3154_ = select(_e1454, _e1472, _e1634);
                                        phi_3155_ = select(_e1475, _e1466, _e1634);
                                        phi_3156_ = select(_e1472, _e1463, _e1634);
                                        phi_3157_ = select(vec3<f32>(_e1437[0], _e1437[1], _e1437[2]), vec3<f32>(_e1429[0], _e1429[1], _e1429[2]), _e1639);
                                        phi_3158_ = select(_e1593, _e1589, _e1639);
                                        phi_3159_ = select(_e1589, _e1597, _e1639);
                                        phi_3160_ = select(_e1597, _e1593, _e1639);
                                    }
                                    let _e1645 = phi_3153_;
                                    let _e1647 = phi_3154_;
                                    let _e1649 = phi_3155_;
                                    let _e1651 = phi_3156_;
                                    let _e1653 = phi_3157_;
                                    let _e1655 = phi_3158_;
                                    let _e1657 = phi_3159_;
                                    let _e1659 = phi_3160_;
                                    let _e1666 = ((_e1657.y * _e1655.z) - (_e1655.y * _e1657.z));
                                    let _e1671 = ((_e1657.z * _e1655.x) - (_e1655.z * _e1657.x));
                                    let _e1674 = ((_e1657.x * _e1655.y) - (_e1655.x * _e1657.y));
                                    let _e1677 = ((_e1498 >= _e1502) && (_e1498 >= _e1506));
                                    let _e1678 = (_e1502 >= _e1506);
                                    let _e1692 = (((_e1666 * (select(select(_e1437[0], _e1429[0], _e1678), _e1421[0], _e1677) - _e590.member[0])) + (_e1671 * (select(select(_e1437[1], _e1429[1], _e1678), _e1421[1], _e1677) - _e590.member[1]))) + (_e1674 * (select(select(_e1437[2], _e1429[2], _e1678), _e1421[2], _e1677) - _e590.member[2])));
                                    let _e1697 = (((_e1666 * _e613) + (_e1671 * _e629)) + (_e1674 * _e645));
                                    let _e1698 = (_e1647 - _e1651);
                                    let _e1699 = (_e1645 - _e1649);
                                    let _e1702 = ((_e1698 * _e1698) + (_e1699 * _e1699));
                                    let _e1709 = (-(((_e1651 * _e1698) + (_e1649 * _e1699))) / select(0.000000000000000000000000000000000000011754944f, _e1702, (_e1702 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e1711 = select(1f, _e1709, (_e1709 < 1f));
                                    let _e1713 = select(0f, _e1711, (_e1711 > 0f));
                                    let _e1722 = ((_e1653.x + (_e1659.x * _e1713)) - _e590.member[0]);
                                    let _e1725 = ((_e1653.y + (_e1659.y * _e1713)) - _e590.member[1]);
                                    let _e1728 = ((_e1653.z + (_e1659.z * _e1713)) - _e590.member[2]);
                                    let _e1793 = ((bitcast<f32>((bitcast<u32>(((((_e1666 * _e1722) + (_e1671 * _e1725)) + (_e1674 * _e1728)) - _e1692)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1722) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1725) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1728) & 2147483647u))), _e1632)) * max(max(bitcast<f32>((bitcast<u32>(_e1666) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1671) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1674) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1697) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1657.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1657.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1657.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1655.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1655.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1655.z) & 2147483647u)))))));
                                    let _e1794 = (_e1692 / _e1697);
                                    if (_e1581 && !(_e1793)) {
                                        let _e1797 = (_e1728 / _e645);
                                        let _e1805 = (((_e1666 * (_e1722 - (_e613 * _e1797))) + (_e1671 * (_e1725 - (_e629 * _e1797)))) / _e1697);
                                        phi_3339_ = select(select(_e1797, (_e1797 + _e1805), (bitcast<f32>((bitcast<u32>(_e1805) & 2147483647u)) <= _e1632)), _e1794, _e1793);
                                    } else {
                                        phi_3339_ = _e1794;
                                    }
                                    let _e1814 = phi_3339_;
                                    let _e1816 = select(_e1554, _e1814, (_e1814 < _e1554));
                                    let _e1818 = select(_e1549, _e1816, (_e1816 > _e1549));
                                    let _e1821 = select(_e1818, 0f, (bitcast<u32>(_e1818) == 2147483648u));
                                    let _e1822 = (1f / _e1508);
                                    phi_3365_ = SlimbvhTypeE(_e1821, (_e1502 * _e1822), (_e1506 * _e1822), ((_e1581 && (_e1821 >= _e657)) && (_e1821 <= _e1297.member.member_1)));
                                    phi_3366_ = SlimbvhTypeE();
                                } else {
                                    phi_3365_ = SlimbvhTypeE();
                                    phi_3366_ = SlimbvhTypeE(0f, 0f, 0f, _e1581);
                                }
                                let _e1831 = phi_3365_;
                                let _e1833 = phi_3366_;
                                phi_3369_ = _e1831;
                                phi_3370_ = _e1833;
                                phi_3371_ = select(true, false, _e1581);
                            } else {
                                phi_3369_ = SlimbvhTypeE();
                                phi_3370_ = SlimbvhTypeE(0f, 0f, 0f, _e1492);
                                phi_3371_ = true;
                            }
                            let _e1836 = phi_3369_;
                            let _e1838 = phi_3370_;
                            let _e1840 = phi_3371_;
                            if _e1840 {
                                phi_3375_ = _e1838;
                            } else {
                                phi_3375_ = _e1836;
                            }
                            let _e1842 = phi_3375_;
                            if _e1842.member_3 {
                                phi_3384_ = SlimbvhTypeF(_e1842.member, _e1842.member_1, _e1842.member_2, _e1360);
                            } else {
                                phi_3384_ = _e90;
                            }
                            let _e1849 = phi_3384_;
                            if (_e1849.member_3 != 4294967295u) {
                                if (_e1360 != 4294967295u) {
                                    if (_e1849.member < _e1297.member.member.member) {
                                        phi_3412_ = true;
                                    } else {
                                        if (_e1849.member == _e1297.member.member.member) {
                                            phi_3411_ = (_e1849.member_3 < _e1297.member.member.member_3);
                                        } else {
                                            phi_3411_ = false;
                                        }
                                        let _e1864 = phi_3411_;
                                        phi_3412_ = _e1864;
                                    }
                                    let _e1866 = phi_3412_;
                                    if _e1866 {
                                        phi_3419_ = SlimbvhTypeN(SlimbvhTypeH(_e1849, _e1849.member), _e1297.member_1);
                                    } else {
                                        phi_3419_ = _e1297;
                                    }
                                    let _e1872 = phi_3419_;
                                    if _e1872.member_1 {
                                        phi_3425_ = SlimbvhTypeN(SlimbvhTypeH(_e1872.member.member, bitcast<f32>(4286578687u)), _e1872.member_1);
                                    } else {
                                        phi_3425_ = _e1872;
                                    }
                                    let _e1881 = phi_3425_;
                                    phi_3426_ = _e1881;
                                } else {
                                    phi_3426_ = _e1297;
                                }
                                let _e1883 = phi_3426_;
                                phi_3427_ = _e1883;
                            } else {
                                phi_3427_ = _e1297;
                            }
                            let _e1885 = phi_3427_;
                            phi_2554_ = _e1885;
                        } else {
                            phi_2554_ = SlimbvhTypeN();
                        }
                        let _e1887 = phi_2554_;
                        continue;
                        continuing {
                            phi_2553_ = _e1887;
                            phi_2556_ = _e1312;
                            break if !(_e1318);
                        }
                    }
                    let _e1890 = local_3;
                    let _e1891 = (_e1890 - 1u);
                    let _e1896 = slimbvh_stacks[(((_e1891 % 32u) * 64u) + _e661)];
                    let _e1897 = (_e1896 & 511u);
                    let _e1899 = (_e1897 >> bitcast<u32>(3u));
                    let _e1902 = ((_e1899 == 0u) || (_e1891 == 4294967295u));
                    if _e1902 {
                    } else {
                        slimbvh_stacks[(((_e1891 % 32u) * 64u) + _e661)] = (((_e1896 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1899);
                    }
                    let _e1909 = local_4;
                    let _e1917 = (((_e1896 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1897 & 3u) & 3u));
                    let _e1919 = (_e1917 >> bitcast<u32>(2i));
                    if (_e1919 < _e94) {
                        let _e1925 = slimbvh_nodes.member[_e1919].member_1[(_e1917 & 3u)];
                        phi_3488_ = _e1925;
                    } else {
                        phi_3488_ = 2147483648u;
                    }
                    let _e1927 = phi_3488_;
                    let _e1929 = local_5;
                    let _e2201 = local_8;
                    phi_3497_ = _e2201;
                    phi_3498_ = select(select(_e1909, _e1891, _e1902), 4294967295u, (_e657 > _e1929.member.member_1));
                    phi_3499_ = _e1927;
                } else {
                    phi_3497_ = _e768;
                    let _e2204 = local_9;
                    phi_3498_ = _e2204;
                    let _e2207 = local_10;
                    phi_3499_ = _e2207;
                }
                let _e1935 = phi_3497_;
                let _e1937 = phi_3498_;
                let _e1939 = phi_3499_;
                phi_1657_ = _e1935;
                phi_1660_ = _e1937;
                phi_1662_ = _e1939;
                let _e2213 = local_11;
                phi_1664_ = _e2213;
            } else {
                phi_1657_ = SlimbvhTypeN();
                phi_1660_ = u32();
                phi_1662_ = u32();
                phi_1664_ = u32();
            }
            let _e1941 = phi_1657_;
            let _e1943 = phi_1660_;
            let _e1945 = phi_1662_;
            let _e1947 = phi_1664_;
            continue;
            continuing {
                phi_1656_ = _e1941;
                phi_1659_ = _e1943;
                phi_1661_ = _e1945;
                phi_1663_ = _e1947;
                break if !(_e775);
            }
        }
        let _e1950 = local_6;
        let _e1951 = (_e1950 == 4294967295u);
        let _e1953 = local_7;
        if (_e1953.member.member.member_3 != 4294967295u) {
            let _e1959 = -((_e160 + _e590.member_4));
            let _e1960 = bitcast<u32>(_e1953.member.member.member);
            let _e1964 = (bitcast<i32>((_e1960 >> bitcast<u32>(23i))) & 255i);
            let _e1965 = (_e1964 + _e1959);
            if (_e1964 == 255i) {
                phi_3557_ = _e1953.member.member.member;
            } else {
                if (_e1964 > 0i) {
                    if (_e1965 > 0i) {
                        let _e1969 = (_e1965 < 255i);
                        if _e1969 {
                            phi_3536_ = bitcast<f32>((_e1960 + bitcast<u32>((_e1959 << bitcast<u32>(23i)))));
                        } else {
                            phi_3536_ = f32();
                        }
                        let _e1976 = phi_3536_;
                        phi_3538_ = _e1976;
                        phi_3539_ = select(true, false, _e1969);
                    } else {
                        phi_3538_ = f32();
                        phi_3539_ = true;
                    }
                    let _e1979 = phi_3538_;
                    let _e1981 = phi_3539_;
                    phi_3540_ = _e1979;
                    phi_3541_ = _e1981;
                } else {
                    phi_3540_ = f32();
                    phi_3541_ = true;
                }
                let _e1983 = phi_3540_;
                let _e1985 = phi_3541_;
                if _e1985 {
                    let _e1986 = (_e1960 & 2147483648u);
                    let _e1993 = ((_e1960 & 8388607u) | (select(0u, 1u, ((_e1960 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e1997 = (_e1993 == 0u);
                    if _e1997 {
                        phi_4239_ = bitcast<f32>(_e1986);
                    } else {
                        let _e2002 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1993)), 32u, _e1997) - 8u);
                        let _e2005 = (_e1993 << bitcast<u32>((_e2002 & 31u)));
                        let _e2007 = ((_e1965 + select(0i, 1i, (_e1964 == 0i))) - bitcast<i32>(_e2002));
                        if (_e2007 >= 255i) {
                            phi_4229_ = bitcast<f32>((_e1986 | 2139095040u));
                            phi_4230_ = f32();
                            phi_4231_ = true;
                        } else {
                            let _e2009 = (_e2007 > 0i);
                            if _e2009 {
                                phi_4223_ = bitcast<f32>(((_e1986 | (bitcast<u32>(_e2007) << bitcast<u32>(23i))) | (_e2005 & 8388607u)));
                                phi_4224_ = f32();
                            } else {
                                if (_e2007 < -24i) {
                                    phi_4189_ = 26u;
                                } else {
                                    phi_4189_ = bitcast<u32>((1i - _e2007));
                                }
                                let _e2014 = phi_4189_;
                                let _e2015 = (_e2014 & 31u);
                                let _e2017 = (_e2005 >> bitcast<u32>(_e2015));
                                let _e2021 = (_e2005 & ((1u << bitcast<u32>(_e2015)) - 1u));
                                let _e2025 = (1u << bitcast<u32>(((_e2014 - 1u) & 31u)));
                                if (_e2021 > _e2025) {
                                    phi_4210_ = true;
                                } else {
                                    if (_e2021 == _e2025) {
                                        phi_4207_ = ((_e2017 & 1u) == 1u);
                                    } else {
                                        phi_4207_ = false;
                                    }
                                    let _e2031 = phi_4207_;
                                    phi_4210_ = _e2031;
                                }
                                let _e2033 = phi_4210_;
                                phi_4223_ = f32();
                                phi_4224_ = bitcast<f32>((_e1986 | (_e2017 + select(0u, 1u, _e2033))));
                            }
                            let _e2046 = phi_4223_;
                            let _e2048 = phi_4224_;
                            phi_4229_ = _e2046;
                            phi_4230_ = _e2048;
                            phi_4231_ = _e2009;
                        }
                        let _e2052 = phi_4229_;
                        let _e2054 = phi_4230_;
                        let _e2056 = phi_4231_;
                        phi_4239_ = select(_e2054, _e2052, _e2056);
                    }
                    let _e2060 = phi_4239_;
                    phi_3556_ = _e2060;
                } else {
                    phi_3556_ = _e1983;
                }
                let _e2062 = phi_3556_;
                phi_3557_ = _e2062;
            }
            let _e2064 = phi_3557_;
            let _e2065 = bitcast<u32>(_e2064);
            if ((_e2065 & 2147483647u) >= 2139095040u) {
                phi_3569_ = bitcast<f32>(((_e2065 & 2147483648u) | 2139095039u));
            } else {
                phi_3569_ = _e2064;
            }
            let _e2072 = phi_3569_;
            phi_3574_ = SlimbvhTypeF(_e2072, _e1953.member.member.member_1, _e1953.member.member.member_2, _e1953.member.member.member_3);
        } else {
            phi_3574_ = _e90;
        }
        let _e2077 = phi_3574_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2077.member), bitcast<u32>(_e2077.member_1), bitcast<u32>(_e2077.member_2), _e2077.member_3);
        phi_3587_ = _e1951;
        phi_3588_ = _e1951;
        phi_3589_ = select(true, false, _e1951);
    } else {
        phi_3587_ = bool();
        phi_3588_ = false;
        phi_3589_ = true;
    }
    let _e2088 = phi_3587_;
    let _e2090 = phi_3588_;
    let _e2092 = phi_3589_;
    if _e2092 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e2088, _e2090, _e2092)));
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
