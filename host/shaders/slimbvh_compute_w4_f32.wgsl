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
//
// Each of the four has a variant for rays that leave a surface, with _from behind hit and a last argument skip, as in the
// first text: slimbvh_closest_hit_from_in_group, slimbvh_try_any_hit_from.

struct SlimbvhTypeS {
    member: u32,
}

var<workgroup> slimbvh_stacks: array<u32, 2048>;

var<private> slimbvh_lane: SlimbvhTypeS;

var<private> slimbvh_overflowed: SlimbvhTypeS;

fn slimbvh_trace_in_group() {
    var phi_484_: u32;
    var phi_490_: u32;
    var phi_496_: u32;
    var phi_761_: i32;
    var phi_772_: i32;
    var phi_886_: i32;
    var phi_1015_: i32;
    var phi_1037_: u32;
    var phi_1038_: u32;
    var phi_1039_: bool;
    var phi_1073_: i32;
    var phi_1095_: u32;
    var phi_1096_: u32;
    var phi_1097_: bool;
    var phi_658_: i32;
    var phi_664_: u32;
    var phi_683_: u32;
    var phi_684_: u32;
    var phi_685_: bool;
    var phi_703_: i32;
    var phi_709_: u32;
    var phi_728_: u32;
    var phi_729_: u32;
    var phi_730_: bool;
    var phi_1107_: SlimbvhTypeF;
    var phi_1353_: SlimbvhTypeO;
    var phi_1393_: SlimbvhTypeO;
    var phi_1396_: u32;
    var phi_1398_: u32;
    var phi_1400_: u32;
    var phi_1409_: u32;
    var phi_1412_: u32;
    var phi_1414_: u32;
    var phi_1851_: u32;
    var phi_1864_: u32;
    var phi_1877_: u32;
    var phi_1890_: u32;
    var phi_3641_: SlimbvhTypeG;
    var phi_3653_: SlimbvhTypeG;
    var phi_3665_: SlimbvhTypeG;
    var phi_3677_: SlimbvhTypeG;
    var phi_3689_: SlimbvhTypeG;
    var phi_1974_: u32;
    var phi_1979_: u32;
    var phi_1980_: u32;
    var phi_2001_: u32;
    var phi_1410_: u32;
    var phi_1413_: u32;
    var phi_1415_: u32;
    var local: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_2017_: SlimbvhTypeO;
    var phi_2020_: SlimbvhTypeG;
    var phi_2021_: SlimbvhTypeG;
    var phi_2043_: SlimbvhTypeG;
    var phi_2122_: array<vec4<f32>, 3>;
    var phi_2123_: array<vec4<f32>, 3>;
    var phi_2203_: array<vec4<f32>, 3>;
    var phi_2204_: array<vec4<f32>, 3>;
    var phi_2227_: array<f32, 3>;
    var phi_2228_: array<f32, 3>;
    var phi_2242_: array<f32, 3>;
    var phi_2243_: array<f32, 3>;
    var phi_2257_: array<f32, 3>;
    var phi_2258_: array<f32, 3>;
    var phi_2617_: f32;
    var phi_2618_: f32;
    var phi_2619_: f32;
    var phi_2620_: f32;
    var phi_2621_: vec3<f32>;
    var phi_2622_: vec3<f32>;
    var phi_2623_: vec3<f32>;
    var phi_2624_: vec3<f32>;
    var phi_2803_: f32;
    var phi_2829_: SlimbvhTypeH;
    var phi_2830_: SlimbvhTypeH;
    var phi_2833_: SlimbvhTypeH;
    var phi_2834_: SlimbvhTypeH;
    var phi_2835_: bool;
    var phi_2839_: SlimbvhTypeH;
    var phi_2848_: SlimbvhTypeI;
    var phi_2901_: i32;
    var phi_3041_: SlimbvhTypeK;
    var phi_3065_: u32;
    var phi_3093_: vec3<f32>;
    var phi_3094_: vec3<f32>;
    var phi_3111_: vec3<f32>;
    var phi_3112_: vec3<f32>;
    var phi_3129_: vec3<f32>;
    var phi_3130_: vec3<f32>;
    var phi_3166_: vec3<f32>;
    var phi_3348_: f32;
    var phi_3366_: bool;
    var phi_3367_: bool;
    var phi_3386_: bool;
    var phi_3387_: bool;
    var phi_3394_: SlimbvhTypeO;
    var phi_3400_: SlimbvhTypeO;
    var phi_3401_: SlimbvhTypeO;
    var phi_3402_: SlimbvhTypeO;
    var phi_2018_: SlimbvhTypeO;
    var local_3: u32;
    var local_4: u32;
    var phi_3460_: u32;
    var local_5: SlimbvhTypeO;
    var phi_3469_: SlimbvhTypeO;
    var phi_3470_: u32;
    var phi_3471_: u32;
    var phi_1394_: SlimbvhTypeO;
    var phi_1397_: u32;
    var phi_1399_: u32;
    var phi_1401_: u32;
    var local_6: u32;
    var local_7: SlimbvhTypeO;
    var phi_3508_: f32;
    var phi_3510_: f32;
    var phi_3511_: bool;
    var phi_3512_: f32;
    var phi_3513_: bool;
    var phi_3920_: u32;
    var phi_3938_: bool;
    var phi_3941_: bool;
    var phi_3954_: f32;
    var phi_3955_: f32;
    var phi_3960_: f32;
    var phi_3961_: f32;
    var phi_3962_: bool;
    var phi_3970_: f32;
    var phi_3528_: f32;
    var phi_3529_: f32;
    var phi_3541_: f32;
    var phi_3546_: SlimbvhTypeI;
    var phi_3559_: bool;
    var phi_3560_: bool;
    var phi_3561_: bool;
    var local_8: SlimbvhTypeO;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e93 = SlimbvhTypeI(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e96 = arrayLength((&slimbvh_nodes.member));
    let _e107 = slimbvh_origin.member;
    let _e113 = slimbvh_origin.member[3u];
    let _e114 = slimbvh_direction.member;
    let _e120 = slimbvh_direction.member[3u];
    let _e123 = slimbvh_exponent.member[0u];
    let _e124 = bitcast<i32>(_e123);
    let _e126 = (bitcast<u32>(_e107.x) & 2147483647u);
    let _e128 = (bitcast<u32>(_e107.y) & 2147483647u);
    let _e130 = (bitcast<u32>(_e107.z) & 2147483647u);
    let _e131 = bitcast<u32>(_e113);
    let _e132 = (_e131 & 2147483647u);
    let _e134 = (bitcast<u32>(_e114.x) & 2147483647u);
    let _e136 = (bitcast<u32>(_e114.y) & 2147483647u);
    let _e138 = (bitcast<u32>(_e114.z) & 2147483647u);
    let _e139 = bitcast<u32>(_e120);
    let _e140 = (_e139 & 2147483647u);
    let _e142 = select(_e136, _e134, (_e136 < _e134));
    let _e144 = select(_e138, _e142, (_e138 < _e142));
    let _e146 = select(_e126, _e144, (_e126 < _e144));
    let _e148 = select(_e128, _e146, (_e128 < _e146));
    let _e150 = select(_e130, _e148, (_e130 < _e148));
    let _e157 = (((select(_e132, _e150, (_e132 < _e150)) < 2139095040u) && (_e140 <= 2139095040u)) && (_e144 > 0u));
    if (_e134 == _e144) {
        phi_484_ = 0u;
    } else {
        phi_484_ = select(2u, 1u, (_e136 == _e144));
    }
    let _e162 = phi_484_;
    let _e163 = (_e162 == 2u);
    if _e163 {
        phi_490_ = 0u;
    } else {
        phi_490_ = (_e162 + 1u);
    }
    let _e166 = phi_490_;
    let _e167 = (_e166 == 2u);
    if _e167 {
        phi_496_ = 0u;
    } else {
        phi_496_ = (_e166 + 1u);
    }
    let _e170 = phi_496_;
    let _e171 = (_e166 == 0u);
    let _e173 = select(select(_e107.y, _e107.x, _e171), _e107.z, _e167);
    let _e174 = (_e170 == 0u);
    let _e176 = (_e170 == 2u);
    let _e177 = select(select(_e107.y, _e107.x, _e174), _e107.z, _e176);
    let _e178 = (_e162 == 0u);
    let _e180 = select(select(_e107.y, _e107.x, _e178), _e107.z, _e163);
    let _e182 = select(select(_e114.y, _e114.x, _e171), _e114.z, _e167);
    let _e184 = select(select(_e114.y, _e114.x, _e174), _e114.z, _e176);
    let _e186 = select(select(_e114.y, _e114.x, _e178), _e114.z, _e163);
    let _e187 = (_e132 - 1u);
    let _e188 = (_e140 - 1u);
    let _e190 = select(_e187, _e188, (_e188 < _e187));
    let _e191 = (_e126 - 1u);
    let _e192 = (_e128 - 1u);
    let _e194 = select(_e191, _e192, (_e192 < _e191));
    let _e195 = (_e130 - 1u);
    let _e197 = select(_e194, _e195, (_e195 < _e194));
    let _e198 = (_e134 - 1u);
    let _e199 = (_e136 - 1u);
    let _e201 = select(_e198, _e199, (_e199 < _e198));
    let _e202 = (_e138 - 1u);
    let _e204 = select(_e201, _e202, (_e202 < _e201));
    let _e206 = select(_e197, _e204, (_e204 < _e197));
    if (((select(_e206, _e190, (_e190 < _e206)) >= 8388607u) && (_e144 < 2130706432u)) && (bitcast<u32>((_e124 + 126i)) <= 253u)) {
        let _e471 = bitcast<i32>((_e144 >> bitcast<u32>(23i)));
        let _e472 = (_e471 - 127i);
        let _e473 = (_e124 + _e472);
        let _e478 = bitcast<f32>((bitcast<u32>((_e124 + 127i)) << bitcast<u32>(23i)));
        let _e483 = bitcast<f32>((bitcast<u32>((254i - _e471)) << bitcast<u32>(23i)));
        if (_e132 >= 2139095040u) {
            phi_658_ = 255i;
        } else {
            phi_658_ = (bitcast<i32>((_e132 >> bitcast<u32>(23i))) + _e473);
        }
        let _e498 = phi_658_;
        if (_e132 == 0u) {
            phi_664_ = 0u;
        } else {
            phi_664_ = (_e132 | 8388608u);
        }
        let _e502 = phi_664_;
        if (_e498 <= 0i) {
            phi_684_ = u32();
            phi_685_ = true;
        } else {
            let _e509 = (_e502 == 0u);
            if _e509 {
                phi_683_ = u32();
            } else {
                phi_683_ = select(((bitcast<u32>(_e498) << bitcast<u32>(23i)) | (_e502 & 8388607u)), 2139095039u, (_e498 >= 255i));
            }
            let _e513 = phi_683_;
            phi_684_ = _e513;
            phi_685_ = _e509;
        }
        let _e515 = phi_684_;
        let _e517 = phi_685_;
        if (_e140 >= 2139095040u) {
            phi_703_ = 255i;
        } else {
            phi_703_ = (bitcast<i32>((_e140 >> bitcast<u32>(23i))) + _e473);
        }
        let _e528 = phi_703_;
        if (_e140 == 0u) {
            phi_709_ = 0u;
        } else {
            phi_709_ = (_e140 | 8388608u);
        }
        let _e532 = phi_709_;
        if (_e528 <= 0i) {
            phi_729_ = u32();
            phi_730_ = true;
        } else {
            let _e539 = (_e532 == 0u);
            if _e539 {
                phi_728_ = u32();
            } else {
                phi_728_ = select(((bitcast<u32>(_e528) << bitcast<u32>(23i)) | (_e532 & 8388607u)), 2139095039u, (_e528 >= 255i));
            }
            let _e543 = phi_728_;
            phi_729_ = _e543;
            phi_730_ = _e539;
        }
        let _e545 = phi_729_;
        let _e547 = phi_730_;
        phi_1107_ = SlimbvhTypeF(array<f32, 3>((_e173 * _e478), (_e177 * _e478), (_e180 * _e478)), array<f32, 3>((_e182 * _e483), (_e184 * _e483), (_e186 * _e483)), bitcast<f32>(((_e131 & 2147483648u) | select(_e515, 0u, _e517))), bitcast<f32>(((_e139 & 2147483648u) | select(_e545, 0u, _e547))), _e472);
    } else {
        let _e219 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e144, _e157))) & 2147483647u);
        if (_e219 >= 8388608u) {
            phi_761_ = (bitcast<i32>((_e219 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_761_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e219)), 32u, (_e219 == 0u))));
        }
        let _e233 = phi_761_;
        let _e234 = (_e124 + _e233);
        if (_e124 < -126i) {
            phi_772_ = -126i;
        } else {
            phi_772_ = select(_e124, 127i, (_e124 > 127i));
        }
        let _e239 = phi_772_;
        let _e244 = bitcast<f32>((bitcast<u32>((_e239 + 127i)) << bitcast<u32>(23i)));
        let _e250 = bitcast<f32>((bitcast<u32>(((_e124 - _e239) + 127i)) << bitcast<u32>(23i)));
        let _e251 = bitcast<u32>(_e173);
        let _e253 = ((_e251 & 2139095040u) != 0u);
        let _e268 = bitcast<u32>(_e177);
        let _e270 = ((_e268 & 2139095040u) != 0u);
        let _e285 = bitcast<u32>(_e180);
        let _e287 = ((_e285 & 2139095040u) != 0u);
        let _e303 = -(_e233);
        if (_e303 < -126i) {
            phi_886_ = -126i;
        } else {
            phi_886_ = select(_e303, 127i, (_e303 > 127i));
        }
        let _e308 = phi_886_;
        let _e313 = bitcast<f32>((bitcast<u32>((_e308 + 127i)) << bitcast<u32>(23i)));
        let _e319 = bitcast<f32>((bitcast<u32>(((_e303 - _e308) + 127i)) << bitcast<u32>(23i)));
        let _e320 = bitcast<u32>(_e182);
        let _e322 = ((_e320 & 2139095040u) != 0u);
        let _e337 = bitcast<u32>(_e184);
        let _e339 = ((_e337 & 2139095040u) != 0u);
        let _e354 = bitcast<u32>(_e186);
        let _e356 = ((_e354 & 2139095040u) != 0u);
        let _e378 = ((_e132 & 8388607u) | (select(0u, 1u, ((_e132 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e381 = bitcast<i32>((_e132 >> bitcast<u32>(23i)));
        let _e388 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e378)), 32u, (_e378 == 0u))) - 8i);
        if (_e381 == 255i) {
            phi_1015_ = 255i;
        } else {
            phi_1015_ = (((_e381 + select(0i, 1i, (_e381 == 0i))) - _e388) + _e234);
        }
        let _e396 = phi_1015_;
        let _e400 = (_e378 << bitcast<u32>(((_e388 & 31i) & 31i)));
        if (_e396 <= 0i) {
            phi_1038_ = u32();
            phi_1039_ = true;
        } else {
            let _e407 = (_e400 == 0u);
            if _e407 {
                phi_1037_ = u32();
            } else {
                phi_1037_ = select(((bitcast<u32>(_e396) << bitcast<u32>(23i)) | (_e400 & 8388607u)), 2139095039u, (_e396 >= 255i));
            }
            let _e411 = phi_1037_;
            phi_1038_ = _e411;
            phi_1039_ = _e407;
        }
        let _e413 = phi_1038_;
        let _e415 = phi_1039_;
        let _e426 = ((_e140 & 8388607u) | (select(0u, 1u, ((_e140 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e429 = bitcast<i32>((_e140 >> bitcast<u32>(23i)));
        let _e436 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e426)), 32u, (_e426 == 0u))) - 8i);
        if (_e429 == 255i) {
            phi_1073_ = 255i;
        } else {
            phi_1073_ = (((_e429 + select(0i, 1i, (_e429 == 0i))) - _e436) + _e234);
        }
        let _e444 = phi_1073_;
        let _e448 = (_e426 << bitcast<u32>(((_e436 & 31i) & 31i)));
        if (_e444 <= 0i) {
            phi_1096_ = u32();
            phi_1097_ = true;
        } else {
            let _e455 = (_e448 == 0u);
            if _e455 {
                phi_1095_ = u32();
            } else {
                phi_1095_ = select(((bitcast<u32>(_e444) << bitcast<u32>(23i)) | (_e448 & 8388607u)), 2139095039u, (_e444 >= 255i));
            }
            let _e459 = phi_1095_;
            phi_1096_ = _e459;
            phi_1097_ = _e455;
        }
        let _e461 = phi_1096_;
        let _e463 = phi_1097_;
        phi_1107_ = SlimbvhTypeF(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e251 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e251 & 2147483648u))), _e173, _e253) * _e244) * select(0.00000011920929f, 1f, _e253)) * _e250), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e268 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e268 & 2147483648u))), _e177, _e270) * _e244) * select(0.00000011920929f, 1f, _e270)) * _e250), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e285 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e285 & 2147483648u))), _e180, _e287) * _e244) * select(0.00000011920929f, 1f, _e287)) * _e250)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e320 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e320 & 2147483648u))), _e182, _e322) * _e313) * select(0.00000011920929f, 1f, _e322)) * _e319), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e184, _e339) * _e313) * select(0.00000011920929f, 1f, _e339)) * _e319), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e354 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e354 & 2147483648u))), _e186, _e356) * _e313) * select(0.00000011920929f, 1f, _e356)) * _e319)), bitcast<f32>(((_e131 & 2147483648u) | select(_e413, 0u, _e415))), bitcast<f32>(((_e139 & 2147483648u) | select(_e461, 0u, _e463))), _e233);
    }
    let _e554 = phi_1107_;
    let _e569 = (bitcast<f32>((bitcast<u32>(_e554.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e572 = bitcast<f32>((bitcast<u32>(_e554.member[0]) & 2147483647u));
    let _e573 = (_e572 * 0.00000011920929f);
    let _e576 = select(select(0.00000000000011368684f, _e573, (_e573 > 0.00000000000011368684f)), 0f, _e569);
    let _e577 = select(0f, _e554.member_1[0], _e569);
    let _e578 = (_e554.member[0] + _e576);
    let _e579 = (_e554.member[0] - _e576);
    let _e581 = select(38685626000000000000000000f, (1f / _e554.member_1[0]), _e569);
    let _e585 = (bitcast<f32>((bitcast<u32>(_e554.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e588 = bitcast<f32>((bitcast<u32>(_e554.member[1]) & 2147483647u));
    let _e589 = (_e588 * 0.00000011920929f);
    let _e592 = select(select(0.00000000000011368684f, _e589, (_e589 > 0.00000000000011368684f)), 0f, _e585);
    let _e593 = select(0f, _e554.member_1[1], _e585);
    let _e594 = (_e554.member[1] + _e592);
    let _e595 = (_e554.member[1] - _e592);
    let _e597 = select(38685626000000000000000000f, (1f / _e554.member_1[1]), _e585);
    let _e601 = (bitcast<f32>((bitcast<u32>(_e554.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e604 = bitcast<f32>((bitcast<u32>(_e554.member[2]) & 2147483647u));
    let _e605 = (_e604 * 0.00000011920929f);
    let _e608 = select(select(0.00000000000011368684f, _e605, (_e605 > 0.00000000000011368684f)), 0f, _e601);
    let _e609 = select(0f, _e554.member_1[2], _e601);
    let _e610 = (_e554.member[2] + _e608);
    let _e611 = (_e554.member[2] - _e608);
    let _e613 = select(38685626000000000000000000f, (1f / _e554.member_1[2]), _e601);
    let _e615 = select(_e588, _e572, (_e572 > _e588));
    let _e619 = (_e157 && (select(_e604, _e615, (_e615 > _e604)) <= 1099511600000f));
    let _e620 = select(0f, _e554.member_3, _e619);
    let _e621 = select(1f, _e554.member_2, _e619);
    let _e625 = slimbvh_question.member[1u];
    let _e626 = slimbvh_lane.member;
    if (_e626 < 64u) {
        let _e628 = (_e626 % 64u);
        let _e631 = slimbvh_question.member[0u];
        if (_e631 == 1u) {
            phi_1353_ = SlimbvhTypeO(SlimbvhTypeL(_e93, _e620), true);
        } else {
            phi_1353_ = SlimbvhTypeO(SlimbvhTypeL(_e93, _e620), false);
        }
        let _e638 = phi_1353_;
        phi_1393_ = _e638;
        phi_1396_ = select(4294967295u, 0u, (_e621 <= _e620));
        phi_1398_ = 0u;
        phi_1400_ = (_e96 + 1u);
        loop {
            let _e656 = phi_1393_;
            let _e658 = phi_1396_;
            let _e660 = phi_1398_;
            let _e662 = phi_1400_;
            local_6 = _e658;
            local_7 = _e656;
            let _e663 = (_e658 <= 32u);
            if _e663 {
                phi_1409_ = _e658;
                phi_1412_ = _e660;
                phi_1414_ = _e662;
                loop {
                    let _e665 = phi_1409_;
                    let _e667 = phi_1412_;
                    let _e669 = phi_1414_;
                    local_1 = _e667;
                    local_2 = _e667;
                    local_3 = _e665;
                    local_4 = _e665;
                    local_9 = _e665;
                    local_10 = _e667;
                    local_11 = _e669;
                    let _e670 = (_e665 <= 32u);
                    let _e673 = (_e670 && !((_e667 >= _e96)));
                    local = _e670;
                    if _e673 {
                        let _e675 = ((2u * (_e166 & 3u)) + (bitcast<u32>(_e581) >> bitcast<u32>(31i)));
                        let _e677 = ((2u * (_e170 & 3u)) + (bitcast<u32>(_e597) >> bitcast<u32>(31i)));
                        let _e679 = ((2u * (_e162 & 3u)) + (bitcast<u32>(_e613) >> bitcast<u32>(31i)));
                        let _e686 = slimbvh_nodes.member[_e667].member[select(_e675, 5u, (5u < _e675))];
                        let _e693 = slimbvh_nodes.member[_e667].member[select(_e677, 5u, (5u < _e677))];
                        let _e700 = slimbvh_nodes.member[_e667].member[select(_e679, 5u, (5u < _e679))];
                        let _e701 = (_e675 ^ 1u);
                        let _e708 = slimbvh_nodes.member[_e667].member[select(_e701, 5u, (5u < _e701))];
                        let _e709 = (_e677 ^ 1u);
                        let _e716 = slimbvh_nodes.member[_e667].member[select(_e709, 5u, (5u < _e709))];
                        let _e717 = (_e679 ^ 1u);
                        let _e724 = slimbvh_nodes.member[_e667].member[select(_e717, 5u, (5u < _e717))];
                        let _e783 = ((_e700.x - _e610) * _e613);
                        let _e784 = ((_e700.y - _e610) * _e613);
                        let _e785 = ((_e700.z - _e610) * _e613);
                        let _e786 = ((_e700.w - _e610) * _e613);
                        let _e795 = ((_e724.x - _e611) * _e613);
                        let _e796 = ((_e724.y - _e611) * _e613);
                        let _e797 = ((_e724.z - _e611) * _e613);
                        let _e798 = ((_e724.w - _e611) * _e613);
                        let _e831 = max(max(max(((_e686.x - _e578) * _e581), ((_e693.x - _e594) * _e597)), _e783), _e621);
                        let _e832 = max(max(max(((_e686.y - _e578) * _e581), ((_e693.y - _e594) * _e597)), _e784), _e621);
                        let _e833 = max(max(max(((_e686.z - _e578) * _e581), ((_e693.z - _e594) * _e597)), _e785), _e621);
                        let _e834 = max(max(max(((_e686.w - _e578) * _e581), ((_e693.w - _e594) * _e597)), _e786), _e621);
                        if (_e831 <= min((min(min(((_e708.x - _e579) * _e581), ((_e716.x - _e595) * _e597)), _e795) + (max(_e795, -(_e783)) * 0.0000019073523f)), _e656.member.member_1)) {
                            phi_1851_ = (((bitcast<u32>(_e831) ^ select(0u, 4294967288u, _e638.member_1)) & 2147483640u) | 4u);
                        } else {
                            phi_1851_ = 4294967288u;
                        }
                        let _e849 = phi_1851_;
                        if (_e832 <= min((min(min(((_e708.y - _e579) * _e581), ((_e716.y - _e595) * _e597)), _e796) + (max(_e796, -(_e784)) * 0.0000019073523f)), _e656.member.member_1)) {
                            phi_1864_ = ((((bitcast<u32>(_e832) ^ select(0u, 4294967288u, _e638.member_1)) & 2147483640u) | 4u) | 1u);
                        } else {
                            phi_1864_ = 4294967288u;
                        }
                        let _e857 = phi_1864_;
                        if (_e833 <= min((min(min(((_e708.z - _e579) * _e581), ((_e716.z - _e595) * _e597)), _e797) + (max(_e797, -(_e785)) * 0.0000019073523f)), _e656.member.member_1)) {
                            phi_1877_ = ((((bitcast<u32>(_e833) ^ select(0u, 4294967288u, _e638.member_1)) & 2147483640u) | 4u) | 2u);
                        } else {
                            phi_1877_ = 4294967288u;
                        }
                        let _e865 = phi_1877_;
                        if (_e834 <= min((min(min(((_e708.w - _e579) * _e581), ((_e716.w - _e595) * _e597)), _e798) + (max(_e798, -(_e786)) * 0.0000019073523f)), _e656.member.member_1)) {
                            phi_1890_ = ((((bitcast<u32>(_e834) ^ select(0u, 4294967288u, _e638.member_1)) & 2147483640u) | 4u) | 3u);
                        } else {
                            phi_1890_ = 4294967288u;
                        }
                        let _e873 = phi_1890_;
                        if (_e849 < _e857) {
                            phi_3641_ = SlimbvhTypeG(_e849, _e857);
                        } else {
                            phi_3641_ = SlimbvhTypeG(_e857, _e849);
                        }
                        let _e878 = phi_3641_;
                        if (_e865 < _e873) {
                            phi_3653_ = SlimbvhTypeG(_e865, _e873);
                        } else {
                            phi_3653_ = SlimbvhTypeG(_e873, _e865);
                        }
                        let _e885 = phi_3653_;
                        if (_e878.member < _e885.member) {
                            phi_3665_ = SlimbvhTypeG(_e878.member, _e885.member);
                        } else {
                            phi_3665_ = SlimbvhTypeG(_e885.member, _e878.member);
                        }
                        let _e892 = phi_3665_;
                        if (_e878.member_1 < _e885.member_1) {
                            phi_3677_ = SlimbvhTypeG(_e878.member_1, _e885.member_1);
                        } else {
                            phi_3677_ = SlimbvhTypeG(_e885.member_1, _e878.member_1);
                        }
                        let _e899 = phi_3677_;
                        if (_e899.member < _e892.member_1) {
                            phi_3689_ = SlimbvhTypeG(_e899.member, _e892.member_1);
                        } else {
                            phi_3689_ = SlimbvhTypeG(_e892.member_1, _e899.member);
                        }
                        let _e906 = phi_3689_;
                        let _e921 = (((_e892.member & 7u) | ((_e906.member & 7u) << bitcast<u32>(3u))) | (((_e906.member_1 & 7u) | ((_e899.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                        if (_e921 == 0u) {
                            let _e941 = (_e665 - 1u);
                            let _e946 = slimbvh_stacks[(((_e941 % 32u) * 64u) + _e628)];
                            let _e947 = (_e946 & 511u);
                            let _e949 = (_e947 >> bitcast<u32>(3u));
                            let _e952 = ((_e949 == 0u) || (_e941 == 4294967295u));
                            if _e952 {
                            } else {
                                slimbvh_stacks[(((_e941 % 32u) * 64u) + _e628)] = (((_e946 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e949);
                            }
                            phi_1979_ = select(_e665, _e941, _e952);
                            phi_1980_ = (((_e946 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e947 & 3u) & 3u));
                        } else {
                            let _e924 = (_e921 >> bitcast<u32>(3u));
                            if (_e924 == 0u) {
                                phi_1974_ = _e665;
                            } else {
                                slimbvh_stacks[(((_e665 % 32u) * 64u) + _e628)] = ((_e667 << bitcast<u32>(9u)) | _e924);
                                phi_1974_ = (_e665 + 1u);
                            }
                            let _e935 = phi_1974_;
                            phi_1979_ = _e935;
                            phi_1980_ = ((_e667 << bitcast<u32>(2i)) | ((_e921 & 3u) & 3u));
                        }
                        let _e967 = phi_1979_;
                        let _e969 = phi_1980_;
                        let _e971 = (_e969 >> bitcast<u32>(2i));
                        if (_e971 < _e96) {
                            let _e978 = slimbvh_nodes.member[_e971].member_1[(_e969 & 3u)];
                            phi_2001_ = _e978;
                        } else {
                            phi_2001_ = 2147483648u;
                        }
                        let _e980 = phi_2001_;
                        let _e981 = (_e669 - 1u);
                        phi_1410_ = select(_e967, 4294967295u, (_e981 == 0u));
                        phi_1413_ = _e980;
                        phi_1415_ = _e981;
                    } else {
                        phi_1410_ = u32();
                        phi_1413_ = u32();
                        phi_1415_ = u32();
                    }
                    let _e985 = phi_1410_;
                    let _e987 = phi_1413_;
                    let _e989 = phi_1415_;
                    continue;
                    continuing {
                        phi_1409_ = _e985;
                        phi_1412_ = _e987;
                        phi_1414_ = _e989;
                        break if !(_e673);
                    }
                }
                let _e992 = local;
                if _e992 {
                    let _e994 = local_1;
                    let _e997 = local_2;
                    phi_2017_ = _e656;
                    phi_2020_ = SlimbvhTypeG(0u, ((_e997 >> bitcast<u32>(28u)) & 7u));
                    loop {
                        let _e1003 = phi_2017_;
                        let _e1005 = phi_2020_;
                        local_5 = _e1003;
                        local_8 = _e1003;
                        if (_e1005.member < _e1005.member_1) {
                            phi_2021_ = SlimbvhTypeG((_e1005.member + 1u), _e1005.member_1);
                            phi_2043_ = SlimbvhTypeG(1u, _e1005.member);
                        } else {
                            phi_2021_ = _e1005;
                            phi_2043_ = SlimbvhTypeG(0u, SlimbvhTypeG().member_1);
                        }
                        let _e1018 = phi_2021_;
                        let _e1020 = phi_2043_;
                        let _e1024 = (bitcast<i32>(_e1020.member) != 0i);
                        if _e1024 {
                            let _e1025 = ((_e994 & 268435455u) + _e1020.member_1);
                            let _e1026 = (_e1025 / 2u);
                            let _e1027 = (_e1025 % 2u);
                            let _e1028 = (_e1026 >= arrayLength((&slimbvh_triangles.member)));
                            if _e1028 {
                                phi_2123_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e1029 = (2u * _e1027);
                                let _e1033 = slimbvh_triangles.member[_e1026][_e1029];
                                let _e1038 = slimbvh_triangles.member[_e1026][(_e1029 + 1u)];
                                let _e1043 = slimbvh_triangles.member[_e1026][(_e1029 + 2u)];
                                if (_e1027 == 0u) {
                                    phi_2122_ = array<vec4<f32>, 3>(_e1033, _e1038, _e1043);
                                } else {
                                    phi_2122_ = array<vec4<f32>, 3>(vec4<f32>(_e1033.z, _e1033.w, _e1038.x, _e1038.y), vec4<f32>(_e1038.z, _e1038.w, _e1043.x, _e1043.y), vec4<f32>(_e1043.z, _e1043.w, 0f, 0f));
                                }
                                let _e1061 = phi_2122_;
                                phi_2123_ = _e1061;
                            }
                            let _e1063 = phi_2123_;
                            let _e1066 = bitcast<u32>(_e1063[2].y);
                            if _e1028 {
                                phi_2204_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e1067 = (2u * _e1027);
                                let _e1071 = slimbvh_triangles.member[_e1026][_e1067];
                                let _e1076 = slimbvh_triangles.member[_e1026][(_e1067 + 1u)];
                                let _e1081 = slimbvh_triangles.member[_e1026][(_e1067 + 2u)];
                                if (_e1027 == 0u) {
                                    phi_2203_ = array<vec4<f32>, 3>(_e1071, _e1076, _e1081);
                                } else {
                                    phi_2203_ = array<vec4<f32>, 3>(vec4<f32>(_e1071.z, _e1071.w, _e1076.x, _e1076.y), vec4<f32>(_e1076.z, _e1076.w, _e1081.x, _e1081.y), vec4<f32>(_e1081.z, _e1081.w, 0f, 0f));
                                }
                                let _e1099 = phi_2203_;
                                phi_2204_ = _e1099;
                            }
                            let _e1101 = phi_2204_;
                            if _e171 {
                                phi_2228_ = array<f32, 3>(_e1101[0].x, _e1101[0].y, _e1101[0].z);
                            } else {
                                if (_e166 == 1u) {
                                    phi_2227_ = array<f32, 3>(_e1101[0].y, _e1101[0].z, _e1101[0].x);
                                } else {
                                    phi_2227_ = array<f32, 3>(_e1101[0].z, _e1101[0].x, _e1101[0].y);
                                }
                                let _e1124 = phi_2227_;
                                phi_2228_ = _e1124;
                            }
                            let _e1127 = phi_2228_;
                            if _e171 {
                                phi_2243_ = array<f32, 3>(_e1101[0].w, _e1101[1].x, _e1101[1].y);
                            } else {
                                if (_e166 == 1u) {
                                    phi_2242_ = array<f32, 3>(_e1101[1].x, _e1101[1].y, _e1101[0].w);
                                } else {
                                    phi_2242_ = array<f32, 3>(_e1101[1].y, _e1101[0].w, _e1101[1].x);
                                }
                                let _e1132 = phi_2242_;
                                phi_2243_ = _e1132;
                            }
                            let _e1135 = phi_2243_;
                            if _e171 {
                                phi_2258_ = array<f32, 3>(_e1101[1].z, _e1101[1].w, _e1101[2].x);
                            } else {
                                if (_e166 == 1u) {
                                    phi_2257_ = array<f32, 3>(_e1101[1].w, _e1101[2].x, _e1101[1].z);
                                } else {
                                    phi_2257_ = array<f32, 3>(_e1101[2].x, _e1101[1].z, _e1101[1].w);
                                }
                                let _e1140 = phi_2257_;
                                phi_2258_ = _e1140;
                            }
                            let _e1143 = phi_2258_;
                            let _e1157 = (_e1127[2] - _e554.member[2]);
                            let _e1160 = (((_e1127[0] - _e554.member[0]) * _e609) - (_e1157 * _e577));
                            let _e1163 = (((_e1127[1] - _e554.member[1]) * _e609) - (_e1157 * _e593));
                            let _e1166 = (_e1135[2] - _e554.member[2]);
                            let _e1169 = (((_e1135[0] - _e554.member[0]) * _e609) - (_e1166 * _e577));
                            let _e1172 = (((_e1135[1] - _e554.member[1]) * _e609) - (_e1166 * _e593));
                            let _e1175 = (_e1143[2] - _e554.member[2]);
                            let _e1178 = (((_e1143[0] - _e554.member[0]) * _e609) - (_e1175 * _e577));
                            let _e1181 = (((_e1143[1] - _e554.member[1]) * _e609) - (_e1175 * _e593));
                            let _e1182 = (_e1178 * _e1172);
                            let _e1183 = (_e1181 * _e1169);
                            let _e1184 = (_e1160 * _e1181);
                            let _e1185 = (_e1163 * _e1178);
                            let _e1186 = (_e1169 * _e1163);
                            let _e1187 = (_e1172 * _e1160);
                            let _e1192 = (((_e1182 >= _e1183) && (_e1184 >= _e1185)) && (_e1186 >= _e1187));
                            let _e1198 = (_e1192 || (((_e1182 <= _e1183) && (_e1184 <= _e1185)) && (_e1186 <= _e1187)));
                            if _e1198 {
                                let _e1200 = select(-1f, 1f, _e1192);
                                let _e1202 = ((_e1182 - _e1183) * _e1200);
                                let _e1204 = select(0f, _e1202, (_e1202 > 0f));
                                let _e1206 = ((_e1184 - _e1185) * _e1200);
                                let _e1208 = select(0f, _e1206, (_e1206 > 0f));
                                let _e1210 = ((_e1186 - _e1187) * _e1200);
                                let _e1212 = select(0f, _e1210, (_e1210 > 0f));
                                let _e1214 = ((_e1204 + _e1208) + _e1212);
                                let _e1229 = ((min(min(_e1127[0], _e1135[0]), _e1143[0]) - _e578) * _e581);
                                let _e1230 = ((max(max(_e1127[0], _e1135[0]), _e1143[0]) - _e579) * _e581);
                                let _e1231 = vec4<f32>(_e1229, f32(), _e1230, f32());
                                let _e1234 = ((min(min(_e1127[1], _e1135[1]), _e1143[1]) - _e594) * _e597);
                                let _e1235 = ((max(max(_e1127[1], _e1135[1]), _e1143[1]) - _e595) * _e597);
                                let _e1236 = vec4<f32>(_e1234, f32(), _e1235, f32());
                                let _e1239 = ((min(min(_e1127[2], _e1135[2]), _e1143[2]) - _e610) * _e613);
                                let _e1240 = ((max(max(_e1127[2], _e1135[2]), _e1143[2]) - _e611) * _e613);
                                let _e1241 = vec4<f32>(_e1239, f32(), _e1240, f32());
                                let _e1242 = vec4<f32>(_e1230, f32(), _e1229, f32());
                                let _e1244 = vec4<f32>(_e1235, f32(), _e1234, f32());
                                let _e1246 = vec4<f32>(_e1240, f32(), _e1239, f32());
                                let _e1255 = max(max(min(_e1231, _e1242).x, min(_e1236, _e1244).x), min(_e1241, _e1246).x);
                                let _e1260 = min(min(max(_e1231, _e1242).x, max(_e1236, _e1244).x), max(_e1241, _e1246).x);
                                let _e1265 = max(_e1255, _e621);
                                let _e1287 = (((((_e1198 && (_e1214 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1160, _e1169), _e1178) <= 0f) && (max(max(_e1160, _e1169), _e1178) >= 0f))) && ((min(min(_e1163, _e1172), _e1181) <= 0f) && (max(max(_e1163, _e1172), _e1181) >= 0f))) && (_e1265 <= (_e1260 + (max(max(_e1241, _e1246).x, -(min(_e1241, _e1246).x)) * 0.0000019073523f)))) && (_e1265 <= _e1003.member.member_1));
                                if _e1287 {
                                    let _e1292 = (_e1135[0] - _e1127[0]);
                                    let _e1293 = (_e1135[1] - _e1127[1]);
                                    let _e1294 = (_e1135[2] - _e1127[2]);
                                    let _e1295 = vec3<f32>(_e1292, _e1293, _e1294);
                                    let _e1296 = (_e1143[0] - _e1135[0]);
                                    let _e1297 = (_e1143[1] - _e1135[1]);
                                    let _e1298 = (_e1143[2] - _e1135[2]);
                                    let _e1299 = vec3<f32>(_e1296, _e1297, _e1298);
                                    let _e1300 = (_e1127[0] - _e1143[0]);
                                    let _e1301 = (_e1127[1] - _e1143[1]);
                                    let _e1302 = (_e1127[2] - _e1143[2]);
                                    let _e1303 = vec3<f32>(_e1300, _e1301, _e1302);
                                    let _e1314 = max(max(bitcast<f32>((bitcast<u32>(_e1292) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1293) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1294) & 2147483647u)));
                                    let _e1325 = max(max(bitcast<f32>((bitcast<u32>(_e1296) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1297) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1298) & 2147483647u)));
                                    let _e1338 = max(max(_e1314, _e1325), max(max(bitcast<f32>((bitcast<u32>(_e1300) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1301) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1302) & 2147483647u))));
                                    if (_e1314 == _e1338) {
                                        phi_2617_ = _e1172;
                                        phi_2618_ = _e1169;
                                        phi_2619_ = _e1163;
                                        phi_2620_ = _e1160;
                                        phi_2621_ = vec3<f32>(_e1127[0], _e1127[1], _e1127[2]);
                                        phi_2622_ = _e1303;
                                        phi_2623_ = _e1299;
                                        phi_2624_ = _e1295;
                                    } else {
                                        let _e1340 = (_e1325 == _e1338);
                                        let _e1345 = vec3(_e1340);
                                        phi_2617_ = select(_e1163, _e1181, _e1340);
                                        phi_2618_ = select(_e1160, _e1178, _e1340);
                                        phi_2619_ = select(_e1181, _e1172, _e1340);
                                        phi_2620_ = select(_e1178, _e1169, _e1340);
                                        phi_2621_ = select(vec3<f32>(_e1143[0], _e1143[1], _e1143[2]), vec3<f32>(_e1135[0], _e1135[1], _e1135[2]), _e1345);
                                        phi_2622_ = select(_e1299, _e1295, _e1345);
                                        phi_2623_ = select(_e1295, _e1303, _e1345);
                                        phi_2624_ = select(_e1303, _e1299, _e1345);
                                    }
                                    let _e1351 = phi_2617_;
                                    let _e1353 = phi_2618_;
                                    let _e1355 = phi_2619_;
                                    let _e1357 = phi_2620_;
                                    let _e1359 = phi_2621_;
                                    let _e1361 = phi_2622_;
                                    let _e1363 = phi_2623_;
                                    let _e1365 = phi_2624_;
                                    let _e1372 = ((_e1363.y * _e1361.z) - (_e1361.y * _e1363.z));
                                    let _e1377 = ((_e1363.z * _e1361.x) - (_e1361.z * _e1363.x));
                                    let _e1380 = ((_e1363.x * _e1361.y) - (_e1361.x * _e1363.y));
                                    let _e1383 = ((_e1204 >= _e1208) && (_e1204 >= _e1212));
                                    let _e1384 = (_e1208 >= _e1212);
                                    let _e1398 = (((_e1372 * (select(select(_e1143[0], _e1135[0], _e1384), _e1127[0], _e1383) - _e554.member[0])) + (_e1377 * (select(select(_e1143[1], _e1135[1], _e1384), _e1127[1], _e1383) - _e554.member[1]))) + (_e1380 * (select(select(_e1143[2], _e1135[2], _e1384), _e1127[2], _e1383) - _e554.member[2])));
                                    let _e1403 = (((_e1372 * _e577) + (_e1377 * _e593)) + (_e1380 * _e609));
                                    let _e1404 = (_e1353 - _e1357);
                                    let _e1405 = (_e1351 - _e1355);
                                    let _e1408 = ((_e1404 * _e1404) + (_e1405 * _e1405));
                                    let _e1415 = (-(((_e1357 * _e1404) + (_e1355 * _e1405))) / select(0.000000000000000000000000000000000000011754944f, _e1408, (_e1408 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e1417 = select(1f, _e1415, (_e1415 < 1f));
                                    let _e1419 = select(0f, _e1417, (_e1417 > 0f));
                                    let _e1428 = ((_e1359.x + (_e1365.x * _e1419)) - _e554.member[0]);
                                    let _e1431 = ((_e1359.y + (_e1365.y * _e1419)) - _e554.member[1]);
                                    let _e1434 = ((_e1359.z + (_e1365.z * _e1419)) - _e554.member[2]);
                                    let _e1499 = ((bitcast<f32>((bitcast<u32>(((((_e1372 * _e1428) + (_e1377 * _e1431)) + (_e1380 * _e1434)) - _e1398)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1431) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u))), _e1338)) * max(max(bitcast<f32>((bitcast<u32>(_e1372) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1377) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1380) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1403) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1363.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1363.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1363.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1361.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1361.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1361.z) & 2147483647u)))))));
                                    let _e1500 = (_e1398 / _e1403);
                                    if (_e1287 && !(_e1499)) {
                                        let _e1503 = (_e1434 / _e609);
                                        let _e1511 = (((_e1372 * (_e1428 - (_e577 * _e1503))) + (_e1377 * (_e1431 - (_e593 * _e1503)))) / _e1403);
                                        phi_2803_ = select(select(_e1503, (_e1503 + _e1511), (bitcast<f32>((bitcast<u32>(_e1511) & 2147483647u)) <= _e1338)), _e1500, _e1499);
                                    } else {
                                        phi_2803_ = _e1500;
                                    }
                                    let _e1520 = phi_2803_;
                                    let _e1522 = select(_e1260, _e1520, (_e1520 < _e1260));
                                    let _e1524 = select(_e1255, _e1522, (_e1522 > _e1255));
                                    let _e1527 = select(_e1524, 0f, (bitcast<u32>(_e1524) == 2147483648u));
                                    let _e1528 = (1f / _e1214);
                                    phi_2829_ = SlimbvhTypeH(_e1527, (_e1208 * _e1528), (_e1212 * _e1528), ((_e1287 && (_e1527 >= _e621)) && (_e1527 <= _e1003.member.member_1)));
                                    phi_2830_ = SlimbvhTypeH();
                                } else {
                                    phi_2829_ = SlimbvhTypeH();
                                    phi_2830_ = SlimbvhTypeH(0f, 0f, 0f, _e1287);
                                }
                                let _e1537 = phi_2829_;
                                let _e1539 = phi_2830_;
                                phi_2833_ = _e1537;
                                phi_2834_ = _e1539;
                                phi_2835_ = select(true, false, _e1287);
                            } else {
                                phi_2833_ = SlimbvhTypeH();
                                phi_2834_ = SlimbvhTypeH(0f, 0f, 0f, _e1198);
                                phi_2835_ = true;
                            }
                            let _e1542 = phi_2833_;
                            let _e1544 = phi_2834_;
                            let _e1546 = phi_2835_;
                            if _e1546 {
                                phi_2839_ = _e1544;
                            } else {
                                phi_2839_ = _e1542;
                            }
                            let _e1548 = phi_2839_;
                            if _e1548.member_3 {
                                phi_2848_ = SlimbvhTypeI(_e1548.member, _e1548.member_1, _e1548.member_2, _e1066);
                            } else {
                                phi_2848_ = _e93;
                            }
                            let _e1555 = phi_2848_;
                            if (_e1555.member_3 != 4294967295u) {
                                let _e1561 = slimbvh_target.member[0u][0u];
                                let _e1565 = slimbvh_target.member[0u][1u];
                                let _e1569 = slimbvh_target.member[0u][2u];
                                let _e1573 = slimbvh_target.member[0u][3u];
                                let _e1577 = slimbvh_target.member[1u][0u];
                                let _e1581 = slimbvh_target.member[1u][1u];
                                let _e1585 = slimbvh_target.member[1u][2u];
                                let _e1589 = slimbvh_target.member[1u][3u];
                                let _e1590 = bitcast<f32>(_e1561);
                                let _e1591 = bitcast<f32>(_e1565);
                                let _e1592 = bitcast<f32>(_e1569);
                                let _e1594 = bitcast<f32>(_e1577);
                                let _e1595 = array<u32, 3>(_e1581, _e1585, _e1589);
                                if (_e124 < -126i) {
                                    phi_2901_ = -126i;
                                } else {
                                    phi_2901_ = select(_e124, 127i, (_e124 > 127i));
                                }
                                let _e1601 = phi_2901_;
                                let _e1606 = bitcast<f32>((bitcast<u32>((_e1601 + 127i)) << bitcast<u32>(23i)));
                                let _e1612 = bitcast<f32>((bitcast<u32>(((_e124 - _e1601) + 127i)) << bitcast<u32>(23i)));
                                if (_e1573 == 0u) {
                                    phi_3041_ = SlimbvhTypeK(array<f32, 3>(_e1590, _e1591, _e1592), _e1573, _e1594, _e1595);
                                } else {
                                    let _e1614 = bitcast<u32>(_e1590);
                                    let _e1616 = ((_e1614 & 2139095040u) != 0u);
                                    let _e1631 = bitcast<u32>(_e1591);
                                    let _e1633 = ((_e1631 & 2139095040u) != 0u);
                                    let _e1648 = bitcast<u32>(_e1592);
                                    let _e1650 = ((_e1648 & 2139095040u) != 0u);
                                    let _e1666 = bitcast<u32>(_e1594);
                                    let _e1668 = ((_e1666 & 2139095040u) != 0u);
                                    phi_3041_ = SlimbvhTypeK(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1614 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1614 & 2147483648u))), _e1590, _e1616) * _e1606) * select(0.00000011920929f, 1f, _e1616)) * _e1612), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1631 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1631 & 2147483648u))), _e1591, _e1633) * _e1606) * select(0.00000011920929f, 1f, _e1633)) * _e1612), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1648 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1648 & 2147483648u))), _e1592, _e1650) * _e1606) * select(0.00000011920929f, 1f, _e1650)) * _e1612)), _e1573, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1666 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1666 & 2147483648u))), _e1594, _e1668) * _e1606) * select(0.00000011920929f, 1f, _e1668)) * _e1612), _e1595);
                                }
                                let _e1685 = phi_3041_;
                                if (_e1066 == _e625) {
                                    phi_3367_ = false;
                                } else {
                                    let _e1687 = (_e1066 / 16u);
                                    if (_e1687 < arrayLength((&slimbvh_sides.member))) {
                                        let _e1690 = slimbvh_sides.member[_e1687];
                                        phi_3065_ = _e1690;
                                    } else {
                                        phi_3065_ = 0u;
                                    }
                                    let _e1692 = phi_3065_;
                                    let _e1701 = (bitcast<i32>((_e1692 << bitcast<u32>(((30u - ((_e1066 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                    let _e1702 = (_e1701 == 0i);
                                    if _e1702 {
                                        phi_3366_ = true;
                                    } else {
                                        if _e171 {
                                            phi_3094_ = vec3<f32>(_e1127[0], _e1127[1], _e1127[2]);
                                        } else {
                                            if (_e166 == 1u) {
                                                phi_3093_ = vec3<f32>(_e1127[2], _e1127[0], _e1127[1]);
                                            } else {
                                                phi_3093_ = vec3<f32>(_e1127[1], _e1127[2], _e1127[0]);
                                            }
                                            let _e1707 = phi_3093_;
                                            phi_3094_ = _e1707;
                                        }
                                        let _e1710 = phi_3094_;
                                        if _e171 {
                                            phi_3112_ = vec3<f32>(_e1135[0], _e1135[1], _e1135[2]);
                                        } else {
                                            if (_e166 == 1u) {
                                                phi_3111_ = vec3<f32>(_e1135[2], _e1135[0], _e1135[1]);
                                            } else {
                                                phi_3111_ = vec3<f32>(_e1135[1], _e1135[2], _e1135[0]);
                                            }
                                            let _e1715 = phi_3111_;
                                            phi_3112_ = _e1715;
                                        }
                                        let _e1718 = phi_3112_;
                                        if _e171 {
                                            phi_3130_ = vec3<f32>(_e1143[0], _e1143[1], _e1143[2]);
                                        } else {
                                            if (_e166 == 1u) {
                                                phi_3129_ = vec3<f32>(_e1143[2], _e1143[0], _e1143[1]);
                                            } else {
                                                phi_3129_ = vec3<f32>(_e1143[1], _e1143[2], _e1143[0]);
                                            }
                                            let _e1723 = phi_3129_;
                                            phi_3130_ = _e1723;
                                        }
                                        let _e1726 = phi_3130_;
                                        let _e1729 = (_e1718.x - _e1710.x);
                                        let _e1732 = (_e1718.y - _e1710.y);
                                        let _e1735 = (_e1718.z - _e1710.z);
                                        let _e1737 = (_e1726.x - _e1710.x);
                                        let _e1739 = (_e1726.y - _e1710.y);
                                        let _e1741 = (_e1726.z - _e1710.z);
                                        if (_e1685.member_1 == 1u) {
                                            phi_3166_ = (vec3<f32>(_e1685.member[0], _e1685.member[1], _e1685.member[2]) - _e1710);
                                        } else {
                                            phi_3166_ = vec3<f32>(_e1685.member[0], _e1685.member[1], _e1685.member[2]);
                                        }
                                        let _e1756 = phi_3166_;
                                        let _e1762 = bitcast<f32>((bitcast<u32>((_e1729 * _e1739)) ^ _e1685.member_3[0]));
                                        let _e1766 = bitcast<f32>((bitcast<u32>((_e1732 * _e1737)) ^ _e1685.member_3[0]));
                                        let _e1770 = bitcast<f32>((bitcast<u32>((_e1732 * _e1741)) ^ _e1685.member_3[0]));
                                        let _e1774 = bitcast<f32>((bitcast<u32>((_e1735 * _e1739)) ^ _e1685.member_3[0]));
                                        let _e1778 = bitcast<f32>((bitcast<u32>((_e1735 * _e1737)) ^ _e1685.member_3[0]));
                                        let _e1782 = bitcast<f32>((bitcast<u32>((_e1729 * _e1741)) ^ _e1685.member_3[0]));
                                        let _e1783 = (_e1770 - _e1774);
                                        let _e1784 = (_e1778 - _e1782);
                                        let _e1785 = (_e1762 - _e1766);
                                        let _e1809 = (bitcast<f32>((bitcast<u32>(_e1770) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1774) & 2147483647u)));
                                        let _e1816 = (bitcast<f32>((bitcast<u32>(_e1778) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1782) & 2147483647u)));
                                        let _e1823 = (bitcast<f32>((bitcast<u32>(_e1762) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1766) & 2147483647u)));
                                        if (_e1685.member_2 == 0f) {
                                            phi_3348_ = 0f;
                                        } else {
                                            let _e1853 = bitcast<f32>((bitcast<u32>(_e1783) & 2147483647u));
                                            let _e1856 = bitcast<f32>((bitcast<u32>(_e1784) & 2147483647u));
                                            let _e1859 = bitcast<f32>((bitcast<u32>(_e1785) & 2147483647u));
                                            let _e1861 = select(_e1859, _e1856, (_e1856 > _e1859));
                                            let _e1865 = select(_e1859, _e1856, (_e1856 < _e1859));
                                            let _e1869 = select(_e1856, _e1853, (_e1853 < _e1856));
                                            let _e1871 = select(_e1856, _e1853, (_e1853 > _e1856));
                                            let _e1873 = select(_e1859, _e1871, (_e1871 < _e1859));
                                            phi_3348_ = bitcast<f32>((bitcast<u32>((_e1685.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1861, _e1853, (_e1853 > _e1861)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1873, _e1869, (_e1869 > _e1873)))) ^ _e1685.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1865, _e1853, (_e1853 < _e1865)))) ^ _e1685.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1809 + _e1816) + _e1823))) ^ _e1685.member_3[0]))) * 1.0000005f)) ^ _e1685.member_3[0])))) ^ _e1685.member_3[0]));
                                        }
                                        let _e1900 = phi_3348_;
                                        phi_3366_ = (_e1702 || !(((((bitcast<f32>((bitcast<u32>((_e1756.x * _e1783)) ^ _e1685.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1756.y * _e1784)) ^ _e1685.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1756.z * _e1785)) ^ _e1685.member_3[0]))) * f32(-(_e1701))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1756.x) & 2147483647u)) * _e1809)) ^ _e1685.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1756.y) & 2147483647u)) * _e1816)) ^ _e1685.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1756.z) & 2147483647u)) * _e1823)) ^ _e1685.member_3[0]))))) ^ _e1685.member_3[0])) + _e1900) + 0.0000000000000000000000000000000000001880791f))));
                                    }
                                    let _e1914 = phi_3366_;
                                    phi_3367_ = _e1914;
                                }
                                let _e1916 = phi_3367_;
                                if _e1916 {
                                    if (_e1555.member < _e1003.member.member.member) {
                                        phi_3387_ = true;
                                    } else {
                                        if (_e1555.member == _e1003.member.member.member) {
                                            phi_3386_ = (_e1555.member_3 < _e1003.member.member.member_3);
                                        } else {
                                            phi_3386_ = false;
                                        }
                                        let _e1928 = phi_3386_;
                                        phi_3387_ = _e1928;
                                    }
                                    let _e1930 = phi_3387_;
                                    if _e1930 {
                                        phi_3394_ = SlimbvhTypeO(SlimbvhTypeL(_e1555, _e1555.member), _e1003.member_1);
                                    } else {
                                        phi_3394_ = _e1003;
                                    }
                                    let _e1936 = phi_3394_;
                                    if _e1936.member_1 {
                                        phi_3400_ = SlimbvhTypeO(SlimbvhTypeL(_e1936.member.member, bitcast<f32>(4286578687u)), _e1936.member_1);
                                    } else {
                                        phi_3400_ = _e1936;
                                    }
                                    let _e1945 = phi_3400_;
                                    phi_3401_ = _e1945;
                                } else {
                                    phi_3401_ = _e1003;
                                }
                                let _e1947 = phi_3401_;
                                phi_3402_ = _e1947;
                            } else {
                                phi_3402_ = _e1003;
                            }
                            let _e1949 = phi_3402_;
                            phi_2018_ = _e1949;
                        } else {
                            phi_2018_ = SlimbvhTypeO();
                        }
                        let _e1951 = phi_2018_;
                        continue;
                        continuing {
                            phi_2017_ = _e1951;
                            phi_2020_ = _e1018;
                            break if !(_e1024);
                        }
                    }
                    let _e1954 = local_3;
                    let _e1955 = (_e1954 - 1u);
                    let _e1960 = slimbvh_stacks[(((_e1955 % 32u) * 64u) + _e628)];
                    let _e1961 = (_e1960 & 511u);
                    let _e1963 = (_e1961 >> bitcast<u32>(3u));
                    let _e1966 = ((_e1963 == 0u) || (_e1955 == 4294967295u));
                    if _e1966 {
                    } else {
                        slimbvh_stacks[(((_e1955 % 32u) * 64u) + _e628)] = (((_e1960 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1963);
                    }
                    let _e1973 = local_4;
                    let _e1981 = (((_e1960 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1961 & 3u) & 3u));
                    let _e1983 = (_e1981 >> bitcast<u32>(2i));
                    if (_e1983 < _e96) {
                        let _e1990 = slimbvh_nodes.member[_e1983].member_1[(_e1981 & 3u)];
                        phi_3460_ = _e1990;
                    } else {
                        phi_3460_ = 2147483648u;
                    }
                    let _e1992 = phi_3460_;
                    let _e1994 = local_5;
                    let _e2269 = local_8;
                    phi_3469_ = _e2269;
                    phi_3470_ = select(select(_e1973, _e1955, _e1966), 4294967295u, (_e621 > _e1994.member.member_1));
                    phi_3471_ = _e1992;
                } else {
                    phi_3469_ = _e656;
                    let _e2272 = local_9;
                    phi_3470_ = _e2272;
                    let _e2275 = local_10;
                    phi_3471_ = _e2275;
                }
                let _e2000 = phi_3469_;
                let _e2002 = phi_3470_;
                let _e2004 = phi_3471_;
                phi_1394_ = _e2000;
                phi_1397_ = _e2002;
                phi_1399_ = _e2004;
                let _e2281 = local_11;
                phi_1401_ = _e2281;
            } else {
                phi_1394_ = SlimbvhTypeO();
                phi_1397_ = u32();
                phi_1399_ = u32();
                phi_1401_ = u32();
            }
            let _e2006 = phi_1394_;
            let _e2008 = phi_1397_;
            let _e2010 = phi_1399_;
            let _e2012 = phi_1401_;
            continue;
            continuing {
                phi_1393_ = _e2006;
                phi_1396_ = _e2008;
                phi_1398_ = _e2010;
                phi_1400_ = _e2012;
                break if !(_e663);
            }
        }
        let _e2015 = local_6;
        let _e2016 = (_e2015 == 4294967295u);
        let _e2018 = local_7;
        if (_e2018.member.member.member_3 != 4294967295u) {
            let _e2024 = -((_e124 + _e554.member_4));
            let _e2025 = bitcast<u32>(_e2018.member.member.member);
            let _e2029 = (bitcast<i32>((_e2025 >> bitcast<u32>(23i))) & 255i);
            let _e2030 = (_e2029 + _e2024);
            if (_e2029 == 255i) {
                phi_3529_ = _e2018.member.member.member;
            } else {
                if (_e2029 > 0i) {
                    if (_e2030 > 0i) {
                        let _e2034 = (_e2030 < 255i);
                        if _e2034 {
                            phi_3508_ = bitcast<f32>((_e2025 + bitcast<u32>((_e2024 << bitcast<u32>(23i)))));
                        } else {
                            phi_3508_ = f32();
                        }
                        let _e2041 = phi_3508_;
                        phi_3510_ = _e2041;
                        phi_3511_ = select(true, false, _e2034);
                    } else {
                        phi_3510_ = f32();
                        phi_3511_ = true;
                    }
                    let _e2044 = phi_3510_;
                    let _e2046 = phi_3511_;
                    phi_3512_ = _e2044;
                    phi_3513_ = _e2046;
                } else {
                    phi_3512_ = f32();
                    phi_3513_ = true;
                }
                let _e2048 = phi_3512_;
                let _e2050 = phi_3513_;
                if _e2050 {
                    let _e2051 = (_e2025 & 2147483648u);
                    let _e2058 = ((_e2025 & 8388607u) | (select(0u, 1u, ((_e2025 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e2062 = (_e2058 == 0u);
                    if _e2062 {
                        phi_3970_ = bitcast<f32>(_e2051);
                    } else {
                        let _e2067 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2058)), 32u, _e2062) - 8u);
                        let _e2070 = (_e2058 << bitcast<u32>((_e2067 & 31u)));
                        let _e2072 = ((_e2030 + select(0i, 1i, (_e2029 == 0i))) - bitcast<i32>(_e2067));
                        if (_e2072 >= 255i) {
                            phi_3960_ = bitcast<f32>((_e2051 | 2139095040u));
                            phi_3961_ = f32();
                            phi_3962_ = true;
                        } else {
                            let _e2074 = (_e2072 > 0i);
                            if _e2074 {
                                phi_3954_ = bitcast<f32>(((_e2051 | (bitcast<u32>(_e2072) << bitcast<u32>(23i))) | (_e2070 & 8388607u)));
                                phi_3955_ = f32();
                            } else {
                                if (_e2072 < -24i) {
                                    phi_3920_ = 26u;
                                } else {
                                    phi_3920_ = bitcast<u32>((1i - _e2072));
                                }
                                let _e2079 = phi_3920_;
                                let _e2080 = (_e2079 & 31u);
                                let _e2082 = (_e2070 >> bitcast<u32>(_e2080));
                                let _e2086 = (_e2070 & ((1u << bitcast<u32>(_e2080)) - 1u));
                                let _e2090 = (1u << bitcast<u32>(((_e2079 - 1u) & 31u)));
                                if (_e2086 > _e2090) {
                                    phi_3941_ = true;
                                } else {
                                    if (_e2086 == _e2090) {
                                        phi_3938_ = ((_e2082 & 1u) == 1u);
                                    } else {
                                        phi_3938_ = false;
                                    }
                                    let _e2096 = phi_3938_;
                                    phi_3941_ = _e2096;
                                }
                                let _e2098 = phi_3941_;
                                phi_3954_ = f32();
                                phi_3955_ = bitcast<f32>((_e2051 | (_e2082 + select(0u, 1u, _e2098))));
                            }
                            let _e2111 = phi_3954_;
                            let _e2113 = phi_3955_;
                            phi_3960_ = _e2111;
                            phi_3961_ = _e2113;
                            phi_3962_ = _e2074;
                        }
                        let _e2117 = phi_3960_;
                        let _e2119 = phi_3961_;
                        let _e2121 = phi_3962_;
                        phi_3970_ = select(_e2119, _e2117, _e2121);
                    }
                    let _e2125 = phi_3970_;
                    phi_3528_ = _e2125;
                } else {
                    phi_3528_ = _e2048;
                }
                let _e2127 = phi_3528_;
                phi_3529_ = _e2127;
            }
            let _e2129 = phi_3529_;
            let _e2130 = bitcast<u32>(_e2129);
            if ((_e2130 & 2147483647u) >= 2139095040u) {
                phi_3541_ = bitcast<f32>(((_e2130 & 2147483648u) | 2139095039u));
            } else {
                phi_3541_ = _e2129;
            }
            let _e2137 = phi_3541_;
            phi_3546_ = SlimbvhTypeI(_e2137, _e2018.member.member.member_1, _e2018.member.member.member_2, _e2018.member.member.member_3);
        } else {
            phi_3546_ = _e93;
        }
        let _e2142 = phi_3546_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2142.member), bitcast<u32>(_e2142.member_1), bitcast<u32>(_e2142.member_2), _e2142.member_3);
        phi_3559_ = _e2016;
        phi_3560_ = _e2016;
        phi_3561_ = select(true, false, _e2016);
    } else {
        phi_3559_ = bool();
        phi_3560_ = false;
        phi_3561_ = true;
    }
    let _e2153 = phi_3559_;
    let _e2155 = phi_3560_;
    let _e2157 = phi_3561_;
    if _e2157 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e2153, _e2155, _e2157)));
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

fn slimbvh_try_closest_hit_from(lane: u32, origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32, skip: u32) -> SlimbvhTriedHit {
    slimbvh_lane.member = lane;
    slimbvh_origin.member = vec4<f32>(origin, t_min);
    slimbvh_direction.member = vec4<f32>(direction, t_max);
    slimbvh_question.member = vec2<u32>(0u, skip);
    slimbvh_trace_in_group();
    let hit = slimbvh_hit.member;
    return SlimbvhTriedHit(
        SlimbvhHit(bitcast<f32>(hit.x), bitcast<f32>(hit.y), bitcast<f32>(hit.z), hit.w),
        slimbvh_overflowed.member != 0u,
    );
}

fn slimbvh_try_closest_hit(lane: u32, origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> SlimbvhTriedHit {
    return slimbvh_try_closest_hit_from(lane, origin, t_min, direction, t_max, 0xffffffffu);
}

fn slimbvh_try_any_hit_from(lane: u32, origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32, skip: u32) -> SlimbvhTriedAny {
    slimbvh_lane.member = lane;
    slimbvh_origin.member = vec4<f32>(origin, t_min);
    slimbvh_direction.member = vec4<f32>(direction, t_max);
    slimbvh_question.member = vec2<u32>(1u, skip);
    slimbvh_trace_in_group();
    return SlimbvhTriedAny(slimbvh_hit.member.w != 0xffffffffu, slimbvh_overflowed.member != 0u);
}

fn slimbvh_try_any_hit(lane: u32, origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> SlimbvhTriedAny {
    return slimbvh_try_any_hit_from(lane, origin, t_min, direction, t_max, 0xffffffffu);
}

fn slimbvh_closest_hit_from_in_group(lane: u32, origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32, skip: u32) -> SlimbvhHit {
    let tried = slimbvh_try_closest_hit_from(lane, origin, t_min, direction, t_max, skip);
    if tried.overflowed {
        return slimbvh_closest_hit_from(origin, t_min, direction, t_max, skip);
    }
    return tried.hit;
}

fn slimbvh_closest_hit_in_group(lane: u32, origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> SlimbvhHit {
    return slimbvh_closest_hit_from_in_group(lane, origin, t_min, direction, t_max, 0xffffffffu);
}

fn slimbvh_any_hit_from_in_group(lane: u32, origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32, skip: u32) -> bool {
    let tried = slimbvh_try_any_hit_from(lane, origin, t_min, direction, t_max, skip);
    if tried.overflowed {
        return slimbvh_any_hit_from(origin, t_min, direction, t_max, skip);
    }
    return tried.found;
}

fn slimbvh_any_hit_in_group(lane: u32, origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> bool {
    return slimbvh_any_hit_from_in_group(lane, origin, t_min, direction, t_max, 0xffffffffu);
}
