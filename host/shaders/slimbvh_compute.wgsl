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

var<private> slimbvh_lane: SlimbvhTypeJ;

var<private> slimbvh_overflowed: SlimbvhTypeJ;

fn slimbvh_trace_in_group() {
    var phi_400_: u32;
    var phi_406_: u32;
    var phi_412_: u32;
    var phi_677_: i32;
    var phi_688_: i32;
    var phi_802_: i32;
    var phi_931_: i32;
    var phi_953_: u32;
    var phi_954_: u32;
    var phi_955_: bool;
    var phi_989_: i32;
    var phi_1011_: u32;
    var phi_1012_: u32;
    var phi_1013_: bool;
    var phi_574_: i32;
    var phi_580_: u32;
    var phi_599_: u32;
    var phi_600_: u32;
    var phi_601_: bool;
    var phi_619_: i32;
    var phi_625_: u32;
    var phi_644_: u32;
    var phi_645_: u32;
    var phi_646_: bool;
    var phi_1023_: SlimbvhTypeC;
    var phi_1225_: SlimbvhTypeK;
    var phi_1240_: SlimbvhTypeK;
    var phi_1243_: u32;
    var phi_1245_: u32;
    var phi_1247_: u32;
    var phi_1256_: u32;
    var phi_1259_: u32;
    var phi_1261_: u32;
    var phi_1525_: u32;
    var phi_1541_: u32;
    var phi_1542_: u32;
    var phi_1257_: u32;
    var phi_1260_: u32;
    var phi_1262_: u32;
    var local: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_1558_: SlimbvhTypeK;
    var phi_1561_: SlimbvhTypeD;
    var phi_1562_: SlimbvhTypeD;
    var phi_1584_: SlimbvhTypeD;
    var phi_1663_: array<vec4<f32>, 3>;
    var phi_1664_: array<vec4<f32>, 3>;
    var phi_1738_: array<vec4<f32>, 3>;
    var phi_1739_: array<vec4<f32>, 3>;
    var phi_1762_: array<f32, 3>;
    var phi_1763_: array<f32, 3>;
    var phi_1777_: array<f32, 3>;
    var phi_1778_: array<f32, 3>;
    var phi_1792_: array<f32, 3>;
    var phi_1793_: array<f32, 3>;
    var phi_2126_: f32;
    var phi_2127_: f32;
    var phi_2128_: f32;
    var phi_2129_: f32;
    var phi_2130_: vec3<f32>;
    var phi_2131_: vec3<f32>;
    var phi_2132_: vec3<f32>;
    var phi_2133_: vec3<f32>;
    var phi_2312_: f32;
    var phi_2338_: SlimbvhTypeE;
    var phi_2339_: SlimbvhTypeE;
    var phi_2342_: SlimbvhTypeE;
    var phi_2343_: SlimbvhTypeE;
    var phi_2344_: bool;
    var phi_2348_: SlimbvhTypeE;
    var phi_2357_: SlimbvhTypeF;
    var phi_2382_: bool;
    var phi_2383_: bool;
    var phi_2390_: SlimbvhTypeK;
    var phi_2396_: SlimbvhTypeK;
    var phi_2397_: SlimbvhTypeK;
    var phi_2398_: SlimbvhTypeK;
    var phi_1559_: SlimbvhTypeK;
    var local_3: u32;
    var local_4: SlimbvhTypeK;
    var phi_2420_: SlimbvhTypeK;
    var phi_2421_: u32;
    var phi_2422_: u32;
    var phi_1241_: SlimbvhTypeK;
    var phi_1244_: u32;
    var phi_1246_: u32;
    var phi_1248_: u32;
    var local_5: u32;
    var local_6: SlimbvhTypeK;
    var phi_2457_: f32;
    var phi_2459_: f32;
    var phi_2460_: bool;
    var phi_2461_: f32;
    var phi_2462_: bool;
    var phi_2865_: u32;
    var phi_2883_: bool;
    var phi_2886_: bool;
    var phi_2899_: f32;
    var phi_2900_: f32;
    var phi_2905_: f32;
    var phi_2906_: f32;
    var phi_2907_: bool;
    var phi_2915_: f32;
    var phi_2477_: f32;
    var phi_2478_: f32;
    var phi_2490_: f32;
    var phi_2495_: SlimbvhTypeF;
    var phi_2508_: bool;
    var phi_2509_: bool;
    var phi_2510_: bool;
    var local_7: SlimbvhTypeK;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e76 = SlimbvhTypeF(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e79 = arrayLength((&slimbvh_nodes.member));
    let _e88 = slimbvh_origin.member;
    let _e94 = slimbvh_origin.member[3u];
    let _e95 = slimbvh_direction.member;
    let _e101 = slimbvh_direction.member[3u];
    let _e104 = slimbvh_exponent.member[0u];
    let _e105 = bitcast<i32>(_e104);
    let _e107 = (bitcast<u32>(_e88.x) & 2147483647u);
    let _e109 = (bitcast<u32>(_e88.y) & 2147483647u);
    let _e111 = (bitcast<u32>(_e88.z) & 2147483647u);
    let _e112 = bitcast<u32>(_e94);
    let _e113 = (_e112 & 2147483647u);
    let _e115 = (bitcast<u32>(_e95.x) & 2147483647u);
    let _e117 = (bitcast<u32>(_e95.y) & 2147483647u);
    let _e119 = (bitcast<u32>(_e95.z) & 2147483647u);
    let _e120 = bitcast<u32>(_e101);
    let _e121 = (_e120 & 2147483647u);
    let _e123 = select(_e117, _e115, (_e117 < _e115));
    let _e125 = select(_e119, _e123, (_e119 < _e123));
    let _e127 = select(_e107, _e125, (_e107 < _e125));
    let _e129 = select(_e109, _e127, (_e109 < _e127));
    let _e131 = select(_e111, _e129, (_e111 < _e129));
    let _e138 = (((select(_e113, _e131, (_e113 < _e131)) < 2139095040u) && (_e121 <= 2139095040u)) && (_e125 > 0u));
    if (_e115 == _e125) {
        phi_400_ = 0u;
    } else {
        phi_400_ = select(2u, 1u, (_e117 == _e125));
    }
    let _e143 = phi_400_;
    let _e144 = (_e143 == 2u);
    if _e144 {
        phi_406_ = 0u;
    } else {
        phi_406_ = (_e143 + 1u);
    }
    let _e147 = phi_406_;
    let _e148 = (_e147 == 2u);
    if _e148 {
        phi_412_ = 0u;
    } else {
        phi_412_ = (_e147 + 1u);
    }
    let _e151 = phi_412_;
    let _e152 = (_e147 == 0u);
    let _e154 = select(select(_e88.y, _e88.x, _e152), _e88.z, _e148);
    let _e155 = (_e151 == 0u);
    let _e157 = (_e151 == 2u);
    let _e158 = select(select(_e88.y, _e88.x, _e155), _e88.z, _e157);
    let _e159 = (_e143 == 0u);
    let _e161 = select(select(_e88.y, _e88.x, _e159), _e88.z, _e144);
    let _e163 = select(select(_e95.y, _e95.x, _e152), _e95.z, _e148);
    let _e165 = select(select(_e95.y, _e95.x, _e155), _e95.z, _e157);
    let _e167 = select(select(_e95.y, _e95.x, _e159), _e95.z, _e144);
    let _e168 = (_e113 - 1u);
    let _e169 = (_e121 - 1u);
    let _e171 = select(_e168, _e169, (_e169 < _e168));
    let _e172 = (_e107 - 1u);
    let _e173 = (_e109 - 1u);
    let _e175 = select(_e172, _e173, (_e173 < _e172));
    let _e176 = (_e111 - 1u);
    let _e178 = select(_e175, _e176, (_e176 < _e175));
    let _e179 = (_e115 - 1u);
    let _e180 = (_e117 - 1u);
    let _e182 = select(_e179, _e180, (_e180 < _e179));
    let _e183 = (_e119 - 1u);
    let _e185 = select(_e182, _e183, (_e183 < _e182));
    let _e187 = select(_e178, _e185, (_e185 < _e178));
    if (((select(_e187, _e171, (_e171 < _e187)) >= 8388607u) && (_e125 < 2130706432u)) && (bitcast<u32>((_e105 + 126i)) <= 253u)) {
        let _e452 = bitcast<i32>((_e125 >> bitcast<u32>(23i)));
        let _e453 = (_e452 - 127i);
        let _e454 = (_e105 + _e453);
        let _e459 = bitcast<f32>((bitcast<u32>((_e105 + 127i)) << bitcast<u32>(23i)));
        let _e464 = bitcast<f32>((bitcast<u32>((254i - _e452)) << bitcast<u32>(23i)));
        if (_e113 >= 2139095040u) {
            phi_574_ = 255i;
        } else {
            phi_574_ = (bitcast<i32>((_e113 >> bitcast<u32>(23i))) + _e454);
        }
        let _e479 = phi_574_;
        if (_e113 == 0u) {
            phi_580_ = 0u;
        } else {
            phi_580_ = (_e113 | 8388608u);
        }
        let _e483 = phi_580_;
        if (_e479 <= 0i) {
            phi_600_ = u32();
            phi_601_ = true;
        } else {
            let _e490 = (_e483 == 0u);
            if _e490 {
                phi_599_ = u32();
            } else {
                phi_599_ = select(((bitcast<u32>(_e479) << bitcast<u32>(23i)) | (_e483 & 8388607u)), 2139095039u, (_e479 >= 255i));
            }
            let _e494 = phi_599_;
            phi_600_ = _e494;
            phi_601_ = _e490;
        }
        let _e496 = phi_600_;
        let _e498 = phi_601_;
        if (_e121 >= 2139095040u) {
            phi_619_ = 255i;
        } else {
            phi_619_ = (bitcast<i32>((_e121 >> bitcast<u32>(23i))) + _e454);
        }
        let _e509 = phi_619_;
        if (_e121 == 0u) {
            phi_625_ = 0u;
        } else {
            phi_625_ = (_e121 | 8388608u);
        }
        let _e513 = phi_625_;
        if (_e509 <= 0i) {
            phi_645_ = u32();
            phi_646_ = true;
        } else {
            let _e520 = (_e513 == 0u);
            if _e520 {
                phi_644_ = u32();
            } else {
                phi_644_ = select(((bitcast<u32>(_e509) << bitcast<u32>(23i)) | (_e513 & 8388607u)), 2139095039u, (_e509 >= 255i));
            }
            let _e524 = phi_644_;
            phi_645_ = _e524;
            phi_646_ = _e520;
        }
        let _e526 = phi_645_;
        let _e528 = phi_646_;
        phi_1023_ = SlimbvhTypeC(array<f32, 3>((_e154 * _e459), (_e158 * _e459), (_e161 * _e459)), array<f32, 3>((_e163 * _e464), (_e165 * _e464), (_e167 * _e464)), bitcast<f32>(((_e112 & 2147483648u) | select(_e496, 0u, _e498))), bitcast<f32>(((_e120 & 2147483648u) | select(_e526, 0u, _e528))), _e453);
    } else {
        let _e200 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e125, _e138))) & 2147483647u);
        if (_e200 >= 8388608u) {
            phi_677_ = (bitcast<i32>((_e200 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_677_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e200)), 32u, (_e200 == 0u))));
        }
        let _e214 = phi_677_;
        let _e215 = (_e105 + _e214);
        if (_e105 < -126i) {
            phi_688_ = -126i;
        } else {
            phi_688_ = select(_e105, 127i, (_e105 > 127i));
        }
        let _e220 = phi_688_;
        let _e225 = bitcast<f32>((bitcast<u32>((_e220 + 127i)) << bitcast<u32>(23i)));
        let _e231 = bitcast<f32>((bitcast<u32>(((_e105 - _e220) + 127i)) << bitcast<u32>(23i)));
        let _e232 = bitcast<u32>(_e154);
        let _e234 = ((_e232 & 2139095040u) != 0u);
        let _e249 = bitcast<u32>(_e158);
        let _e251 = ((_e249 & 2139095040u) != 0u);
        let _e266 = bitcast<u32>(_e161);
        let _e268 = ((_e266 & 2139095040u) != 0u);
        let _e284 = -(_e214);
        if (_e284 < -126i) {
            phi_802_ = -126i;
        } else {
            phi_802_ = select(_e284, 127i, (_e284 > 127i));
        }
        let _e289 = phi_802_;
        let _e294 = bitcast<f32>((bitcast<u32>((_e289 + 127i)) << bitcast<u32>(23i)));
        let _e300 = bitcast<f32>((bitcast<u32>(((_e284 - _e289) + 127i)) << bitcast<u32>(23i)));
        let _e301 = bitcast<u32>(_e163);
        let _e303 = ((_e301 & 2139095040u) != 0u);
        let _e318 = bitcast<u32>(_e165);
        let _e320 = ((_e318 & 2139095040u) != 0u);
        let _e335 = bitcast<u32>(_e167);
        let _e337 = ((_e335 & 2139095040u) != 0u);
        let _e359 = ((_e113 & 8388607u) | (select(0u, 1u, ((_e113 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e362 = bitcast<i32>((_e113 >> bitcast<u32>(23i)));
        let _e369 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e359)), 32u, (_e359 == 0u))) - 8i);
        if (_e362 == 255i) {
            phi_931_ = 255i;
        } else {
            phi_931_ = (((_e362 + select(0i, 1i, (_e362 == 0i))) - _e369) + _e215);
        }
        let _e377 = phi_931_;
        let _e381 = (_e359 << bitcast<u32>(((_e369 & 31i) & 31i)));
        if (_e377 <= 0i) {
            phi_954_ = u32();
            phi_955_ = true;
        } else {
            let _e388 = (_e381 == 0u);
            if _e388 {
                phi_953_ = u32();
            } else {
                phi_953_ = select(((bitcast<u32>(_e377) << bitcast<u32>(23i)) | (_e381 & 8388607u)), 2139095039u, (_e377 >= 255i));
            }
            let _e392 = phi_953_;
            phi_954_ = _e392;
            phi_955_ = _e388;
        }
        let _e394 = phi_954_;
        let _e396 = phi_955_;
        let _e407 = ((_e121 & 8388607u) | (select(0u, 1u, ((_e121 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e410 = bitcast<i32>((_e121 >> bitcast<u32>(23i)));
        let _e417 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e407)), 32u, (_e407 == 0u))) - 8i);
        if (_e410 == 255i) {
            phi_989_ = 255i;
        } else {
            phi_989_ = (((_e410 + select(0i, 1i, (_e410 == 0i))) - _e417) + _e215);
        }
        let _e425 = phi_989_;
        let _e429 = (_e407 << bitcast<u32>(((_e417 & 31i) & 31i)));
        if (_e425 <= 0i) {
            phi_1012_ = u32();
            phi_1013_ = true;
        } else {
            let _e436 = (_e429 == 0u);
            if _e436 {
                phi_1011_ = u32();
            } else {
                phi_1011_ = select(((bitcast<u32>(_e425) << bitcast<u32>(23i)) | (_e429 & 8388607u)), 2139095039u, (_e425 >= 255i));
            }
            let _e440 = phi_1011_;
            phi_1012_ = _e440;
            phi_1013_ = _e436;
        }
        let _e442 = phi_1012_;
        let _e444 = phi_1013_;
        phi_1023_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e232 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e232 & 2147483648u))), _e154, _e234) * _e225) * select(0.00000011920929f, 1f, _e234)) * _e231), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e249 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e249 & 2147483648u))), _e158, _e251) * _e225) * select(0.00000011920929f, 1f, _e251)) * _e231), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e266 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e266 & 2147483648u))), _e161, _e268) * _e225) * select(0.00000011920929f, 1f, _e268)) * _e231)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e301 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e301 & 2147483648u))), _e163, _e303) * _e294) * select(0.00000011920929f, 1f, _e303)) * _e300), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e165, _e320) * _e294) * select(0.00000011920929f, 1f, _e320)) * _e300), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e335 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e335 & 2147483648u))), _e167, _e337) * _e294) * select(0.00000011920929f, 1f, _e337)) * _e300)), bitcast<f32>(((_e112 & 2147483648u) | select(_e394, 0u, _e396))), bitcast<f32>(((_e120 & 2147483648u) | select(_e442, 0u, _e444))), _e214);
    }
    let _e535 = phi_1023_;
    let _e550 = (bitcast<f32>((bitcast<u32>(_e535.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e553 = bitcast<f32>((bitcast<u32>(_e535.member[0]) & 2147483647u));
    let _e554 = (_e553 * 0.00000011920929f);
    let _e557 = select(select(0.00000000000011368684f, _e554, (_e554 > 0.00000000000011368684f)), 0f, _e550);
    let _e558 = select(0f, _e535.member_1[0], _e550);
    let _e559 = (_e535.member[0] + _e557);
    let _e560 = (_e535.member[0] - _e557);
    let _e562 = select(38685626000000000000000000f, (1f / _e535.member_1[0]), _e550);
    let _e566 = (bitcast<f32>((bitcast<u32>(_e535.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e569 = bitcast<f32>((bitcast<u32>(_e535.member[1]) & 2147483647u));
    let _e570 = (_e569 * 0.00000011920929f);
    let _e573 = select(select(0.00000000000011368684f, _e570, (_e570 > 0.00000000000011368684f)), 0f, _e566);
    let _e574 = select(0f, _e535.member_1[1], _e566);
    let _e575 = (_e535.member[1] + _e573);
    let _e576 = (_e535.member[1] - _e573);
    let _e578 = select(38685626000000000000000000f, (1f / _e535.member_1[1]), _e566);
    let _e582 = (bitcast<f32>((bitcast<u32>(_e535.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e585 = bitcast<f32>((bitcast<u32>(_e535.member[2]) & 2147483647u));
    let _e586 = (_e585 * 0.00000011920929f);
    let _e589 = select(select(0.00000000000011368684f, _e586, (_e586 > 0.00000000000011368684f)), 0f, _e582);
    let _e590 = select(0f, _e535.member_1[2], _e582);
    let _e591 = (_e535.member[2] + _e589);
    let _e592 = (_e535.member[2] - _e589);
    let _e594 = select(38685626000000000000000000f, (1f / _e535.member_1[2]), _e582);
    let _e596 = select(_e569, _e553, (_e553 > _e569));
    let _e600 = (_e138 && (select(_e585, _e596, (_e596 > _e585)) <= 1099511600000f));
    let _e601 = select(0f, _e535.member_3, _e600);
    let _e602 = select(1f, _e535.member_2, _e600);
    let _e604 = slimbvh_lane.member;
    if (_e604 < 64u) {
        let _e606 = (_e604 % 64u);
        let _e607 = slimbvh_any_will_do.member;
        if (_e607 == 1u) {
            phi_1225_ = SlimbvhTypeK(SlimbvhTypeG(_e76, _e601), true);
        } else {
            phi_1225_ = SlimbvhTypeK(SlimbvhTypeG(_e76, _e601), false);
        }
        let _e614 = phi_1225_;
        phi_1240_ = _e614;
        phi_1243_ = select(4294967295u, 0u, (_e602 <= _e601));
        phi_1245_ = 0u;
        phi_1247_ = (_e79 + 1u);
        loop {
            let _e623 = phi_1240_;
            let _e625 = phi_1243_;
            let _e627 = phi_1245_;
            let _e629 = phi_1247_;
            local_5 = _e625;
            local_6 = _e623;
            let _e630 = (_e625 <= 32u);
            if _e630 {
                phi_1256_ = _e625;
                phi_1259_ = _e627;
                phi_1261_ = _e629;
                loop {
                    let _e632 = phi_1256_;
                    let _e634 = phi_1259_;
                    let _e636 = phi_1261_;
                    local_1 = _e634;
                    local_2 = _e634;
                    local_3 = _e632;
                    local_8 = _e632;
                    local_9 = _e634;
                    local_10 = _e636;
                    let _e637 = (_e632 <= 32u);
                    let _e640 = (_e637 && !((_e634 >= _e79)));
                    local = _e637;
                    if _e640 {
                        let _e645 = slimbvh_nodes.member[_e634][3u][0u];
                        let _e650 = slimbvh_nodes.member[_e634][3u][1u];
                        let _e655 = slimbvh_nodes.member[_e634][((_e147 & 3u) % 4u)];
                        let _e660 = slimbvh_nodes.member[_e634][((_e151 & 3u) % 4u)];
                        let _e665 = slimbvh_nodes.member[_e634][((_e143 & 3u) % 4u)];
                        let _e666 = bitcast<u32>(_e645);
                        let _e667 = bitcast<u32>(_e650);
                        let _e678 = ((_e655.x - _e559) * _e562);
                        let _e679 = ((_e655.y - _e559) * _e562);
                        let _e680 = ((_e655.z - _e560) * _e562);
                        let _e681 = ((_e655.w - _e560) * _e562);
                        let _e682 = vec4<f32>(_e678, _e679, _e680, _e681);
                        let _e691 = ((_e660.x - _e575) * _e578);
                        let _e692 = ((_e660.y - _e575) * _e578);
                        let _e693 = ((_e660.z - _e576) * _e578);
                        let _e694 = ((_e660.w - _e576) * _e578);
                        let _e695 = vec4<f32>(_e691, _e692, _e693, _e694);
                        let _e704 = ((_e665.x - _e591) * _e594);
                        let _e705 = ((_e665.y - _e591) * _e594);
                        let _e706 = ((_e665.z - _e592) * _e594);
                        let _e707 = ((_e665.w - _e592) * _e594);
                        let _e708 = vec4<f32>(_e704, _e705, _e706, _e707);
                        let _e709 = vec4<f32>(_e680, _e681, _e678, _e679);
                        let _e710 = min(_e682, _e709);
                        let _e711 = vec4<f32>(_e693, _e694, _e691, _e692);
                        let _e712 = min(_e695, _e711);
                        let _e713 = vec4<f32>(_e706, _e707, _e704, _e705);
                        let _e714 = min(_e708, _e713);
                        let _e715 = max(_e682, _e709);
                        let _e716 = max(_e695, _e711);
                        let _e717 = max(_e708, _e713);
                        let _e746 = max(max(max(_e710.x, _e712.x), _e714.x), _e602);
                        let _e747 = max(max(max(_e710.y, _e712.y), _e714.y), _e602);
                        let _e750 = (_e746 <= min((min(min(_e715.x, _e716.x), _e717.x) + (max(_e717.x, -(_e714.x)) * 0.0000019073523f)), _e623.member.member_1));
                        let _e751 = (_e747 <= min((min(min(_e715.y, _e716.y), _e717.y) + (max(_e717.y, -(_e714.y)) * 0.0000019073523f)), _e623.member.member_1));
                        if (_e750 || _e751) {
                            let _e763 = (_e750 && (((_e746 <= _e747) != _e614.member_1) || !(_e751)));
                            if (_e750 && _e751) {
                                slimbvh_stacks[(((_e632 % 32u) * 64u) + _e606)] = select(_e666, _e667, _e763);
                                phi_1525_ = (_e632 + 1u);
                            } else {
                                phi_1525_ = _e632;
                            }
                            let _e773 = phi_1525_;
                            phi_1541_ = _e773;
                            phi_1542_ = select(_e667, _e666, _e763);
                        } else {
                            let _e755 = (_e632 - 1u);
                            let _e760 = slimbvh_stacks[(((_e755 % 32u) * 64u) + _e606)];
                            phi_1541_ = _e755;
                            phi_1542_ = _e760;
                        }
                        let _e775 = phi_1541_;
                        let _e777 = phi_1542_;
                        let _e778 = (_e636 - 1u);
                        phi_1257_ = select(_e775, 4294967295u, (_e778 == 0u));
                        phi_1260_ = _e777;
                        phi_1262_ = _e778;
                    } else {
                        phi_1257_ = u32();
                        phi_1260_ = u32();
                        phi_1262_ = u32();
                    }
                    let _e782 = phi_1257_;
                    let _e784 = phi_1260_;
                    let _e786 = phi_1262_;
                    continue;
                    continuing {
                        phi_1256_ = _e782;
                        phi_1259_ = _e784;
                        phi_1261_ = _e786;
                        break if !(_e640);
                    }
                }
                let _e789 = local;
                if _e789 {
                    let _e791 = local_1;
                    let _e794 = local_2;
                    phi_1558_ = _e623;
                    phi_1561_ = SlimbvhTypeD(0u, ((_e794 >> bitcast<u32>(28u)) & 7u));
                    loop {
                        let _e800 = phi_1558_;
                        let _e802 = phi_1561_;
                        local_4 = _e800;
                        local_7 = _e800;
                        if (_e802.member < _e802.member_1) {
                            phi_1562_ = SlimbvhTypeD((_e802.member + 1u), _e802.member_1);
                            phi_1584_ = SlimbvhTypeD(1u, _e802.member);
                        } else {
                            phi_1562_ = _e802;
                            phi_1584_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                        }
                        let _e815 = phi_1562_;
                        let _e817 = phi_1584_;
                        let _e821 = (bitcast<i32>(_e817.member) != 0i);
                        if _e821 {
                            let _e822 = ((_e791 & 268435455u) + _e817.member_1);
                            let _e823 = (_e822 / 2u);
                            let _e824 = (_e822 % 2u);
                            let _e825 = (_e823 >= arrayLength((&slimbvh_triangles.member)));
                            if _e825 {
                                phi_1664_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e826 = (2u * _e824);
                                let _e830 = slimbvh_triangles.member[_e823][_e826];
                                let _e835 = slimbvh_triangles.member[_e823][(_e826 + 1u)];
                                let _e840 = slimbvh_triangles.member[_e823][(_e826 + 2u)];
                                if (_e824 == 0u) {
                                    phi_1663_ = array<vec4<f32>, 3>(_e830, _e835, _e840);
                                } else {
                                    phi_1663_ = array<vec4<f32>, 3>(vec4<f32>(_e830.z, _e830.w, _e835.x, _e835.y), vec4<f32>(_e835.z, _e835.w, _e840.x, _e840.y), vec4<f32>(_e840.z, _e840.w, 0f, 0f));
                                }
                                let _e858 = phi_1663_;
                                phi_1664_ = _e858;
                            }
                            let _e860 = phi_1664_;
                            let _e863 = bitcast<u32>(_e860[2].y);
                            if _e825 {
                                phi_1739_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e864 = (2u * _e824);
                                let _e868 = slimbvh_triangles.member[_e823][_e864];
                                let _e873 = slimbvh_triangles.member[_e823][(_e864 + 1u)];
                                let _e878 = slimbvh_triangles.member[_e823][(_e864 + 2u)];
                                if (_e824 == 0u) {
                                    phi_1738_ = array<vec4<f32>, 3>(_e868, _e873, _e878);
                                } else {
                                    phi_1738_ = array<vec4<f32>, 3>(vec4<f32>(_e868.z, _e868.w, _e873.x, _e873.y), vec4<f32>(_e873.z, _e873.w, _e878.x, _e878.y), vec4<f32>(_e878.z, _e878.w, 0f, 0f));
                                }
                                let _e896 = phi_1738_;
                                phi_1739_ = _e896;
                            }
                            let _e898 = phi_1739_;
                            if _e152 {
                                phi_1763_ = array<f32, 3>(_e898[0].x, _e898[0].y, _e898[0].z);
                            } else {
                                if (_e147 == 1u) {
                                    phi_1762_ = array<f32, 3>(_e898[0].y, _e898[0].z, _e898[0].x);
                                } else {
                                    phi_1762_ = array<f32, 3>(_e898[0].z, _e898[0].x, _e898[0].y);
                                }
                                let _e921 = phi_1762_;
                                phi_1763_ = _e921;
                            }
                            let _e924 = phi_1763_;
                            if _e152 {
                                phi_1778_ = array<f32, 3>(_e898[0].w, _e898[1].x, _e898[1].y);
                            } else {
                                if (_e147 == 1u) {
                                    phi_1777_ = array<f32, 3>(_e898[1].x, _e898[1].y, _e898[0].w);
                                } else {
                                    phi_1777_ = array<f32, 3>(_e898[1].y, _e898[0].w, _e898[1].x);
                                }
                                let _e929 = phi_1777_;
                                phi_1778_ = _e929;
                            }
                            let _e932 = phi_1778_;
                            if _e152 {
                                phi_1793_ = array<f32, 3>(_e898[1].z, _e898[1].w, _e898[2].x);
                            } else {
                                if (_e147 == 1u) {
                                    phi_1792_ = array<f32, 3>(_e898[1].w, _e898[2].x, _e898[1].z);
                                } else {
                                    phi_1792_ = array<f32, 3>(_e898[2].x, _e898[1].z, _e898[1].w);
                                }
                                let _e937 = phi_1792_;
                                phi_1793_ = _e937;
                            }
                            let _e940 = phi_1793_;
                            let _e954 = (_e924[2] - _e535.member[2]);
                            let _e957 = (((_e924[0] - _e535.member[0]) * _e590) - (_e954 * _e558));
                            let _e960 = (((_e924[1] - _e535.member[1]) * _e590) - (_e954 * _e574));
                            let _e963 = (_e932[2] - _e535.member[2]);
                            let _e966 = (((_e932[0] - _e535.member[0]) * _e590) - (_e963 * _e558));
                            let _e969 = (((_e932[1] - _e535.member[1]) * _e590) - (_e963 * _e574));
                            let _e972 = (_e940[2] - _e535.member[2]);
                            let _e975 = (((_e940[0] - _e535.member[0]) * _e590) - (_e972 * _e558));
                            let _e978 = (((_e940[1] - _e535.member[1]) * _e590) - (_e972 * _e574));
                            let _e979 = (_e975 * _e969);
                            let _e980 = (_e978 * _e966);
                            let _e981 = (_e957 * _e978);
                            let _e982 = (_e960 * _e975);
                            let _e983 = (_e966 * _e960);
                            let _e984 = (_e969 * _e957);
                            let _e989 = (((_e979 >= _e980) && (_e981 >= _e982)) && (_e983 >= _e984));
                            let _e995 = (_e989 || (((_e979 <= _e980) && (_e981 <= _e982)) && (_e983 <= _e984)));
                            if _e995 {
                                let _e997 = select(-1f, 1f, _e989);
                                let _e999 = ((_e979 - _e980) * _e997);
                                let _e1001 = select(0f, _e999, (_e999 > 0f));
                                let _e1003 = ((_e981 - _e982) * _e997);
                                let _e1005 = select(0f, _e1003, (_e1003 > 0f));
                                let _e1007 = ((_e983 - _e984) * _e997);
                                let _e1009 = select(0f, _e1007, (_e1007 > 0f));
                                let _e1011 = ((_e1001 + _e1005) + _e1009);
                                let _e1026 = ((min(min(_e924[0], _e932[0]), _e940[0]) - _e559) * _e562);
                                let _e1027 = ((max(max(_e924[0], _e932[0]), _e940[0]) - _e560) * _e562);
                                let _e1028 = vec4<f32>(_e1026, f32(), _e1027, f32());
                                let _e1031 = ((min(min(_e924[1], _e932[1]), _e940[1]) - _e575) * _e578);
                                let _e1032 = ((max(max(_e924[1], _e932[1]), _e940[1]) - _e576) * _e578);
                                let _e1033 = vec4<f32>(_e1031, f32(), _e1032, f32());
                                let _e1036 = ((min(min(_e924[2], _e932[2]), _e940[2]) - _e591) * _e594);
                                let _e1037 = ((max(max(_e924[2], _e932[2]), _e940[2]) - _e592) * _e594);
                                let _e1038 = vec4<f32>(_e1036, f32(), _e1037, f32());
                                let _e1039 = vec4<f32>(_e1027, f32(), _e1026, f32());
                                let _e1041 = vec4<f32>(_e1032, f32(), _e1031, f32());
                                let _e1043 = vec4<f32>(_e1037, f32(), _e1036, f32());
                                let _e1052 = max(max(min(_e1028, _e1039).x, min(_e1033, _e1041).x), min(_e1038, _e1043).x);
                                let _e1057 = min(min(max(_e1028, _e1039).x, max(_e1033, _e1041).x), max(_e1038, _e1043).x);
                                let _e1062 = max(_e1052, _e602);
                                let _e1084 = (((((_e995 && (_e1011 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e957, _e966), _e975) <= 0f) && (max(max(_e957, _e966), _e975) >= 0f))) && ((min(min(_e960, _e969), _e978) <= 0f) && (max(max(_e960, _e969), _e978) >= 0f))) && (_e1062 <= (_e1057 + (max(max(_e1038, _e1043).x, -(min(_e1038, _e1043).x)) * 0.0000019073523f)))) && (_e1062 <= _e800.member.member_1));
                                if _e1084 {
                                    let _e1089 = (_e932[0] - _e924[0]);
                                    let _e1090 = (_e932[1] - _e924[1]);
                                    let _e1091 = (_e932[2] - _e924[2]);
                                    let _e1092 = vec3<f32>(_e1089, _e1090, _e1091);
                                    let _e1093 = (_e940[0] - _e932[0]);
                                    let _e1094 = (_e940[1] - _e932[1]);
                                    let _e1095 = (_e940[2] - _e932[2]);
                                    let _e1096 = vec3<f32>(_e1093, _e1094, _e1095);
                                    let _e1097 = (_e924[0] - _e940[0]);
                                    let _e1098 = (_e924[1] - _e940[1]);
                                    let _e1099 = (_e924[2] - _e940[2]);
                                    let _e1100 = vec3<f32>(_e1097, _e1098, _e1099);
                                    let _e1111 = max(max(bitcast<f32>((bitcast<u32>(_e1089) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1090) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1091) & 2147483647u)));
                                    let _e1122 = max(max(bitcast<f32>((bitcast<u32>(_e1093) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1094) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1095) & 2147483647u)));
                                    let _e1135 = max(max(_e1111, _e1122), max(max(bitcast<f32>((bitcast<u32>(_e1097) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1098) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1099) & 2147483647u))));
                                    if (_e1111 == _e1135) {
                                        phi_2126_ = _e969;
                                        phi_2127_ = _e966;
                                        phi_2128_ = _e960;
                                        phi_2129_ = _e957;
                                        phi_2130_ = vec3<f32>(_e924[0], _e924[1], _e924[2]);
                                        phi_2131_ = _e1100;
                                        phi_2132_ = _e1096;
                                        phi_2133_ = _e1092;
                                    } else {
                                        let _e1137 = (_e1122 == _e1135);
                                        let _e1142 = vec3(_e1137);
                                        phi_2126_ = select(_e960, _e978, _e1137);
                                        phi_2127_ = select(_e957, _e975, _e1137);
                                        phi_2128_ = select(_e978, _e969, _e1137);
                                        phi_2129_ = select(_e975, _e966, _e1137);
                                        phi_2130_ = select(vec3<f32>(_e940[0], _e940[1], _e940[2]), vec3<f32>(_e932[0], _e932[1], _e932[2]), _e1142);
                                        phi_2131_ = select(_e1096, _e1092, _e1142);
                                        phi_2132_ = select(_e1092, _e1100, _e1142);
                                        phi_2133_ = select(_e1100, _e1096, _e1142);
                                    }
                                    let _e1148 = phi_2126_;
                                    let _e1150 = phi_2127_;
                                    let _e1152 = phi_2128_;
                                    let _e1154 = phi_2129_;
                                    let _e1156 = phi_2130_;
                                    let _e1158 = phi_2131_;
                                    let _e1160 = phi_2132_;
                                    let _e1162 = phi_2133_;
                                    let _e1169 = ((_e1160.y * _e1158.z) - (_e1158.y * _e1160.z));
                                    let _e1174 = ((_e1160.z * _e1158.x) - (_e1158.z * _e1160.x));
                                    let _e1177 = ((_e1160.x * _e1158.y) - (_e1158.x * _e1160.y));
                                    let _e1180 = ((_e1001 >= _e1005) && (_e1001 >= _e1009));
                                    let _e1181 = (_e1005 >= _e1009);
                                    let _e1195 = (((_e1169 * (select(select(_e940[0], _e932[0], _e1181), _e924[0], _e1180) - _e535.member[0])) + (_e1174 * (select(select(_e940[1], _e932[1], _e1181), _e924[1], _e1180) - _e535.member[1]))) + (_e1177 * (select(select(_e940[2], _e932[2], _e1181), _e924[2], _e1180) - _e535.member[2])));
                                    let _e1200 = (((_e1169 * _e558) + (_e1174 * _e574)) + (_e1177 * _e590));
                                    let _e1201 = (_e1150 - _e1154);
                                    let _e1202 = (_e1148 - _e1152);
                                    let _e1205 = ((_e1201 * _e1201) + (_e1202 * _e1202));
                                    let _e1212 = (-(((_e1154 * _e1201) + (_e1152 * _e1202))) / select(0.000000000000000000000000000000000000011754944f, _e1205, (_e1205 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e1214 = select(1f, _e1212, (_e1212 < 1f));
                                    let _e1216 = select(0f, _e1214, (_e1214 > 0f));
                                    let _e1225 = ((_e1156.x + (_e1162.x * _e1216)) - _e535.member[0]);
                                    let _e1228 = ((_e1156.y + (_e1162.y * _e1216)) - _e535.member[1]);
                                    let _e1231 = ((_e1156.z + (_e1162.z * _e1216)) - _e535.member[2]);
                                    let _e1296 = ((bitcast<f32>((bitcast<u32>(((((_e1169 * _e1225) + (_e1174 * _e1228)) + (_e1177 * _e1231)) - _e1195)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1225) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1228) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1231) & 2147483647u))), _e1135)) * max(max(bitcast<f32>((bitcast<u32>(_e1169) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1174) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1177) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1200) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1160.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1160.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1160.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1158.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1158.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1158.z) & 2147483647u)))))));
                                    let _e1297 = (_e1195 / _e1200);
                                    if (_e1084 && !(_e1296)) {
                                        let _e1300 = (_e1231 / _e590);
                                        let _e1308 = (((_e1169 * (_e1225 - (_e558 * _e1300))) + (_e1174 * (_e1228 - (_e574 * _e1300)))) / _e1200);
                                        phi_2312_ = select(select(_e1300, (_e1300 + _e1308), (bitcast<f32>((bitcast<u32>(_e1308) & 2147483647u)) <= _e1135)), _e1297, _e1296);
                                    } else {
                                        phi_2312_ = _e1297;
                                    }
                                    let _e1317 = phi_2312_;
                                    let _e1319 = select(_e1057, _e1317, (_e1317 < _e1057));
                                    let _e1321 = select(_e1052, _e1319, (_e1319 > _e1052));
                                    let _e1324 = select(_e1321, 0f, (bitcast<u32>(_e1321) == 2147483648u));
                                    let _e1325 = (1f / _e1011);
                                    phi_2338_ = SlimbvhTypeE(_e1324, (_e1005 * _e1325), (_e1009 * _e1325), ((_e1084 && (_e1324 >= _e602)) && (_e1324 <= _e800.member.member_1)));
                                    phi_2339_ = SlimbvhTypeE();
                                } else {
                                    phi_2338_ = SlimbvhTypeE();
                                    phi_2339_ = SlimbvhTypeE(0f, 0f, 0f, _e1084);
                                }
                                let _e1334 = phi_2338_;
                                let _e1336 = phi_2339_;
                                phi_2342_ = _e1334;
                                phi_2343_ = _e1336;
                                phi_2344_ = select(true, false, _e1084);
                            } else {
                                phi_2342_ = SlimbvhTypeE();
                                phi_2343_ = SlimbvhTypeE(0f, 0f, 0f, _e995);
                                phi_2344_ = true;
                            }
                            let _e1339 = phi_2342_;
                            let _e1341 = phi_2343_;
                            let _e1343 = phi_2344_;
                            if _e1343 {
                                phi_2348_ = _e1341;
                            } else {
                                phi_2348_ = _e1339;
                            }
                            let _e1345 = phi_2348_;
                            if _e1345.member_3 {
                                phi_2357_ = SlimbvhTypeF(_e1345.member, _e1345.member_1, _e1345.member_2, _e863);
                            } else {
                                phi_2357_ = _e76;
                            }
                            let _e1352 = phi_2357_;
                            if (_e1352.member_3 != 4294967295u) {
                                if (_e863 != 4294967295u) {
                                    if (_e1352.member < _e800.member.member.member) {
                                        phi_2383_ = true;
                                    } else {
                                        if (_e1352.member == _e800.member.member.member) {
                                            phi_2382_ = (_e1352.member_3 < _e800.member.member.member_3);
                                        } else {
                                            phi_2382_ = false;
                                        }
                                        let _e1367 = phi_2382_;
                                        phi_2383_ = _e1367;
                                    }
                                    let _e1369 = phi_2383_;
                                    if _e1369 {
                                        phi_2390_ = SlimbvhTypeK(SlimbvhTypeG(_e1352, _e1352.member), _e800.member_1);
                                    } else {
                                        phi_2390_ = _e800;
                                    }
                                    let _e1375 = phi_2390_;
                                    if _e1375.member_1 {
                                        phi_2396_ = SlimbvhTypeK(SlimbvhTypeG(_e1375.member.member, bitcast<f32>(4286578687u)), _e1375.member_1);
                                    } else {
                                        phi_2396_ = _e1375;
                                    }
                                    let _e1384 = phi_2396_;
                                    phi_2397_ = _e1384;
                                } else {
                                    phi_2397_ = _e800;
                                }
                                let _e1386 = phi_2397_;
                                phi_2398_ = _e1386;
                            } else {
                                phi_2398_ = _e800;
                            }
                            let _e1388 = phi_2398_;
                            phi_1559_ = _e1388;
                        } else {
                            phi_1559_ = SlimbvhTypeK();
                        }
                        let _e1390 = phi_1559_;
                        continue;
                        continuing {
                            phi_1558_ = _e1390;
                            phi_1561_ = _e815;
                            break if !(_e821);
                        }
                    }
                    let _e1393 = local_3;
                    let _e1394 = (_e1393 - 1u);
                    let _e1399 = slimbvh_stacks[(((_e1394 % 32u) * 64u) + _e606)];
                    let _e1401 = local_4;
                    let _e1651 = local_7;
                    phi_2420_ = _e1651;
                    phi_2421_ = select(_e1394, 4294967295u, (_e602 > _e1401.member.member_1));
                    phi_2422_ = _e1399;
                } else {
                    phi_2420_ = _e623;
                    let _e1654 = local_8;
                    phi_2421_ = _e1654;
                    let _e1657 = local_9;
                    phi_2422_ = _e1657;
                }
                let _e1407 = phi_2420_;
                let _e1409 = phi_2421_;
                let _e1411 = phi_2422_;
                phi_1241_ = _e1407;
                phi_1244_ = _e1409;
                phi_1246_ = _e1411;
                let _e1663 = local_10;
                phi_1248_ = _e1663;
            } else {
                phi_1241_ = SlimbvhTypeK();
                phi_1244_ = u32();
                phi_1246_ = u32();
                phi_1248_ = u32();
            }
            let _e1413 = phi_1241_;
            let _e1415 = phi_1244_;
            let _e1417 = phi_1246_;
            let _e1419 = phi_1248_;
            continue;
            continuing {
                phi_1240_ = _e1413;
                phi_1243_ = _e1415;
                phi_1245_ = _e1417;
                phi_1247_ = _e1419;
                break if !(_e630);
            }
        }
        let _e1422 = local_5;
        let _e1423 = (_e1422 == 4294967295u);
        let _e1425 = local_6;
        if (_e1425.member.member.member_3 != 4294967295u) {
            let _e1431 = -((_e105 + _e535.member_4));
            let _e1432 = bitcast<u32>(_e1425.member.member.member);
            let _e1436 = (bitcast<i32>((_e1432 >> bitcast<u32>(23i))) & 255i);
            let _e1437 = (_e1436 + _e1431);
            if (_e1436 == 255i) {
                phi_2478_ = _e1425.member.member.member;
            } else {
                if (_e1436 > 0i) {
                    if (_e1437 > 0i) {
                        let _e1441 = (_e1437 < 255i);
                        if _e1441 {
                            phi_2457_ = bitcast<f32>((_e1432 + bitcast<u32>((_e1431 << bitcast<u32>(23i)))));
                        } else {
                            phi_2457_ = f32();
                        }
                        let _e1448 = phi_2457_;
                        phi_2459_ = _e1448;
                        phi_2460_ = select(true, false, _e1441);
                    } else {
                        phi_2459_ = f32();
                        phi_2460_ = true;
                    }
                    let _e1451 = phi_2459_;
                    let _e1453 = phi_2460_;
                    phi_2461_ = _e1451;
                    phi_2462_ = _e1453;
                } else {
                    phi_2461_ = f32();
                    phi_2462_ = true;
                }
                let _e1455 = phi_2461_;
                let _e1457 = phi_2462_;
                if _e1457 {
                    let _e1458 = (_e1432 & 2147483648u);
                    let _e1465 = ((_e1432 & 8388607u) | (select(0u, 1u, ((_e1432 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e1469 = (_e1465 == 0u);
                    if _e1469 {
                        phi_2915_ = bitcast<f32>(_e1458);
                    } else {
                        let _e1474 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1465)), 32u, _e1469) - 8u);
                        let _e1477 = (_e1465 << bitcast<u32>((_e1474 & 31u)));
                        let _e1479 = ((_e1437 + select(0i, 1i, (_e1436 == 0i))) - bitcast<i32>(_e1474));
                        if (_e1479 >= 255i) {
                            phi_2905_ = bitcast<f32>((_e1458 | 2139095040u));
                            phi_2906_ = f32();
                            phi_2907_ = true;
                        } else {
                            let _e1481 = (_e1479 > 0i);
                            if _e1481 {
                                phi_2899_ = bitcast<f32>(((_e1458 | (bitcast<u32>(_e1479) << bitcast<u32>(23i))) | (_e1477 & 8388607u)));
                                phi_2900_ = f32();
                            } else {
                                if (_e1479 < -24i) {
                                    phi_2865_ = 26u;
                                } else {
                                    phi_2865_ = bitcast<u32>((1i - _e1479));
                                }
                                let _e1486 = phi_2865_;
                                let _e1487 = (_e1486 & 31u);
                                let _e1489 = (_e1477 >> bitcast<u32>(_e1487));
                                let _e1493 = (_e1477 & ((1u << bitcast<u32>(_e1487)) - 1u));
                                let _e1497 = (1u << bitcast<u32>(((_e1486 - 1u) & 31u)));
                                if (_e1493 > _e1497) {
                                    phi_2886_ = true;
                                } else {
                                    if (_e1493 == _e1497) {
                                        phi_2883_ = ((_e1489 & 1u) == 1u);
                                    } else {
                                        phi_2883_ = false;
                                    }
                                    let _e1503 = phi_2883_;
                                    phi_2886_ = _e1503;
                                }
                                let _e1505 = phi_2886_;
                                phi_2899_ = f32();
                                phi_2900_ = bitcast<f32>((_e1458 | (_e1489 + select(0u, 1u, _e1505))));
                            }
                            let _e1518 = phi_2899_;
                            let _e1520 = phi_2900_;
                            phi_2905_ = _e1518;
                            phi_2906_ = _e1520;
                            phi_2907_ = _e1481;
                        }
                        let _e1524 = phi_2905_;
                        let _e1526 = phi_2906_;
                        let _e1528 = phi_2907_;
                        phi_2915_ = select(_e1526, _e1524, _e1528);
                    }
                    let _e1532 = phi_2915_;
                    phi_2477_ = _e1532;
                } else {
                    phi_2477_ = _e1455;
                }
                let _e1534 = phi_2477_;
                phi_2478_ = _e1534;
            }
            let _e1536 = phi_2478_;
            let _e1537 = bitcast<u32>(_e1536);
            if ((_e1537 & 2147483647u) >= 2139095040u) {
                phi_2490_ = bitcast<f32>(((_e1537 & 2147483648u) | 2139095039u));
            } else {
                phi_2490_ = _e1536;
            }
            let _e1544 = phi_2490_;
            phi_2495_ = SlimbvhTypeF(_e1544, _e1425.member.member.member_1, _e1425.member.member.member_2, _e1425.member.member.member_3);
        } else {
            phi_2495_ = _e76;
        }
        let _e1549 = phi_2495_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1549.member), bitcast<u32>(_e1549.member_1), bitcast<u32>(_e1549.member_2), _e1549.member_3);
        phi_2508_ = _e1423;
        phi_2509_ = _e1423;
        phi_2510_ = select(true, false, _e1423);
    } else {
        phi_2508_ = bool();
        phi_2509_ = false;
        phi_2510_ = true;
    }
    let _e1560 = phi_2508_;
    let _e1562 = phi_2509_;
    let _e1564 = phi_2510_;
    if _e1564 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e1560, _e1562, _e1564)));
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
