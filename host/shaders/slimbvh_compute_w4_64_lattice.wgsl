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

var<private> slimbvh_lane: SlimbvhTypeO;

var<private> slimbvh_overflowed: SlimbvhTypeO;

fn slimbvh_trace_in_group() {
    var phi_569_: u32;
    var phi_575_: u32;
    var phi_581_: u32;
    var phi_846_: i32;
    var phi_857_: i32;
    var phi_971_: i32;
    var phi_1100_: i32;
    var phi_1122_: u32;
    var phi_1123_: u32;
    var phi_1124_: bool;
    var phi_1158_: i32;
    var phi_1180_: u32;
    var phi_1181_: u32;
    var phi_1182_: bool;
    var phi_743_: i32;
    var phi_749_: u32;
    var phi_768_: u32;
    var phi_769_: u32;
    var phi_770_: bool;
    var phi_788_: i32;
    var phi_794_: u32;
    var phi_813_: u32;
    var phi_814_: u32;
    var phi_815_: bool;
    var phi_1192_: SlimbvhTypeC;
    var phi_1428_: SlimbvhTypeP;
    var phi_1491_: array<f32, 3>;
    var phi_1492_: array<f32, 3>;
    var phi_1510_: array<f32, 3>;
    var phi_1511_: array<f32, 3>;
    var phi_1684_: SlimbvhTypeP;
    var phi_1687_: u32;
    var phi_1689_: u32;
    var phi_1691_: u32;
    var phi_1700_: u32;
    var phi_1703_: u32;
    var phi_1705_: u32;
    var phi_1807_: SlimbvhTypeK;
    var phi_1808_: SlimbvhTypeK;
    var phi_1867_: SlimbvhTypeK;
    var phi_1868_: SlimbvhTypeK;
    var phi_1927_: SlimbvhTypeK;
    var phi_1928_: SlimbvhTypeK;
    var phi_2412_: u32;
    var phi_2425_: u32;
    var phi_2438_: u32;
    var phi_2451_: u32;
    var phi_4600_: SlimbvhTypeD;
    var phi_4612_: SlimbvhTypeD;
    var phi_4624_: SlimbvhTypeD;
    var phi_4636_: SlimbvhTypeD;
    var phi_4648_: SlimbvhTypeD;
    var phi_2535_: u32;
    var phi_2540_: u32;
    var phi_2541_: u32;
    var phi_2571_: u32;
    var phi_2572_: u32;
    var phi_1701_: u32;
    var phi_1704_: u32;
    var phi_1706_: u32;
    var local: bool;
    var local_1: u32;
    var phi_2722_: u32;
    var phi_2783_: u32;
    var phi_2786_: SlimbvhTypeM;
    var phi_2790_: SlimbvhTypeP;
    var phi_2793_: SlimbvhTypeD;
    var phi_2794_: SlimbvhTypeD;
    var phi_2816_: SlimbvhTypeD;
    var phi_2834_: u32;
    var phi_2845_: u32;
    var phi_2861_: u32;
    var phi_2874_: u32;
    var phi_2885_: u32;
    var phi_3329_: u32;
    var phi_3342_: u32;
    var phi_3355_: u32;
    var phi_3381_: u32;
    var phi_3394_: u32;
    var phi_3407_: u32;
    var phi_3433_: u32;
    var phi_3446_: u32;
    var phi_3459_: u32;
    var phi_3051_: u32;
    var phi_3064_: u32;
    var phi_3074_: u32;
    var phi_3095_: u32;
    var phi_3116_: u32;
    var phi_3143_: u32;
    var phi_3156_: u32;
    var phi_3166_: u32;
    var phi_3187_: u32;
    var phi_3208_: u32;
    var phi_3235_: u32;
    var phi_3248_: u32;
    var phi_3258_: u32;
    var phi_3279_: u32;
    var phi_3300_: u32;
    var phi_2912_: u32;
    var phi_2958_: u32;
    var phi_3004_: u32;
    var phi_3471_: array<array<f32, 3>, 3>;
    var phi_3836_: f32;
    var phi_3837_: f32;
    var phi_3838_: f32;
    var phi_3839_: f32;
    var phi_3840_: vec3<f32>;
    var phi_3841_: vec3<f32>;
    var phi_3842_: vec3<f32>;
    var phi_3843_: vec3<f32>;
    var phi_4022_: f32;
    var phi_4048_: SlimbvhTypeE;
    var phi_4049_: SlimbvhTypeE;
    var phi_4052_: SlimbvhTypeE;
    var phi_4053_: SlimbvhTypeE;
    var phi_4054_: bool;
    var phi_4058_: SlimbvhTypeE;
    var phi_4067_: SlimbvhTypeF;
    var phi_4094_: bool;
    var phi_4095_: bool;
    var phi_4102_: SlimbvhTypeP;
    var phi_4108_: SlimbvhTypeP;
    var phi_4109_: SlimbvhTypeP;
    var phi_4110_: SlimbvhTypeP;
    var phi_2791_: SlimbvhTypeP;
    var local_2: u32;
    var local_3: u32;
    var phi_4177_: u32;
    var phi_4178_: u32;
    var local_4: SlimbvhTypeP;
    var phi_4187_: SlimbvhTypeP;
    var phi_4188_: u32;
    var phi_4189_: u32;
    var phi_1685_: SlimbvhTypeP;
    var phi_1688_: u32;
    var phi_1690_: u32;
    var phi_1692_: u32;
    var local_5: u32;
    var local_6: SlimbvhTypeP;
    var phi_4226_: f32;
    var phi_4228_: f32;
    var phi_4229_: bool;
    var phi_4230_: f32;
    var phi_4231_: bool;
    var phi_4879_: u32;
    var phi_4897_: bool;
    var phi_4900_: bool;
    var phi_4913_: f32;
    var phi_4914_: f32;
    var phi_4919_: f32;
    var phi_4920_: f32;
    var phi_4921_: bool;
    var phi_4929_: f32;
    var phi_4246_: f32;
    var phi_4247_: f32;
    var phi_4259_: f32;
    var phi_4264_: SlimbvhTypeF;
    var phi_4277_: bool;
    var phi_4278_: bool;
    var phi_4279_: bool;
    var local_7: SlimbvhTypeP;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e100 = SlimbvhTypeF(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e104 = arrayLength((&slimbvh_nodes.member));
    let _e107 = arrayLength((&slimbvh_triangles.member));
    let _e117 = slimbvh_root.member[0u][0u];
    let _e121 = slimbvh_root.member[0u][1u];
    let _e125 = slimbvh_root.member[0u][2u];
    let _e129 = slimbvh_root.member[0u][3u];
    let _e133 = slimbvh_root.member[1u][0u];
    let _e137 = slimbvh_root.member[1u][1u];
    let _e141 = slimbvh_root.member[1u][2u];
    let _e153 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e129) + 127i)) << bitcast<u32>(23i)));
    let _e154 = slimbvh_origin.member;
    let _e160 = slimbvh_origin.member[3u];
    let _e161 = slimbvh_direction.member;
    let _e167 = slimbvh_direction.member[3u];
    let _e170 = slimbvh_exponent.member[0u];
    let _e171 = bitcast<i32>(_e170);
    let _e173 = (bitcast<u32>(_e154.x) & 2147483647u);
    let _e175 = (bitcast<u32>(_e154.y) & 2147483647u);
    let _e177 = (bitcast<u32>(_e154.z) & 2147483647u);
    let _e178 = bitcast<u32>(_e160);
    let _e179 = (_e178 & 2147483647u);
    let _e181 = (bitcast<u32>(_e161.x) & 2147483647u);
    let _e183 = (bitcast<u32>(_e161.y) & 2147483647u);
    let _e185 = (bitcast<u32>(_e161.z) & 2147483647u);
    let _e186 = bitcast<u32>(_e167);
    let _e187 = (_e186 & 2147483647u);
    let _e189 = select(_e183, _e181, (_e183 < _e181));
    let _e191 = select(_e185, _e189, (_e185 < _e189));
    let _e193 = select(_e173, _e191, (_e173 < _e191));
    let _e195 = select(_e175, _e193, (_e175 < _e193));
    let _e197 = select(_e177, _e195, (_e177 < _e195));
    let _e204 = (((select(_e179, _e197, (_e179 < _e197)) < 2139095040u) && (_e187 <= 2139095040u)) && (_e191 > 0u));
    if (_e181 == _e191) {
        phi_569_ = 0u;
    } else {
        phi_569_ = select(2u, 1u, (_e183 == _e191));
    }
    let _e209 = phi_569_;
    let _e210 = (_e209 == 2u);
    if _e210 {
        phi_575_ = 0u;
    } else {
        phi_575_ = (_e209 + 1u);
    }
    let _e213 = phi_575_;
    let _e214 = (_e213 == 2u);
    if _e214 {
        phi_581_ = 0u;
    } else {
        phi_581_ = (_e213 + 1u);
    }
    let _e217 = phi_581_;
    let _e218 = (_e213 == 0u);
    let _e220 = select(select(_e154.y, _e154.x, _e218), _e154.z, _e214);
    let _e221 = (_e217 == 0u);
    let _e223 = (_e217 == 2u);
    let _e224 = select(select(_e154.y, _e154.x, _e221), _e154.z, _e223);
    let _e225 = (_e209 == 0u);
    let _e227 = select(select(_e154.y, _e154.x, _e225), _e154.z, _e210);
    let _e229 = select(select(_e161.y, _e161.x, _e218), _e161.z, _e214);
    let _e231 = select(select(_e161.y, _e161.x, _e221), _e161.z, _e223);
    let _e233 = select(select(_e161.y, _e161.x, _e225), _e161.z, _e210);
    let _e234 = (_e179 - 1u);
    let _e235 = (_e187 - 1u);
    let _e237 = select(_e234, _e235, (_e235 < _e234));
    let _e238 = (_e173 - 1u);
    let _e239 = (_e175 - 1u);
    let _e241 = select(_e238, _e239, (_e239 < _e238));
    let _e242 = (_e177 - 1u);
    let _e244 = select(_e241, _e242, (_e242 < _e241));
    let _e245 = (_e181 - 1u);
    let _e246 = (_e183 - 1u);
    let _e248 = select(_e245, _e246, (_e246 < _e245));
    let _e249 = (_e185 - 1u);
    let _e251 = select(_e248, _e249, (_e249 < _e248));
    let _e253 = select(_e244, _e251, (_e251 < _e244));
    if (((select(_e253, _e237, (_e237 < _e253)) >= 8388607u) && (_e191 < 2130706432u)) && (bitcast<u32>((_e171 + 126i)) <= 253u)) {
        let _e518 = bitcast<i32>((_e191 >> bitcast<u32>(23i)));
        let _e519 = (_e518 - 127i);
        let _e520 = (_e171 + _e519);
        let _e525 = bitcast<f32>((bitcast<u32>((_e171 + 127i)) << bitcast<u32>(23i)));
        let _e530 = bitcast<f32>((bitcast<u32>((254i - _e518)) << bitcast<u32>(23i)));
        if (_e179 >= 2139095040u) {
            phi_743_ = 255i;
        } else {
            phi_743_ = (bitcast<i32>((_e179 >> bitcast<u32>(23i))) + _e520);
        }
        let _e545 = phi_743_;
        if (_e179 == 0u) {
            phi_749_ = 0u;
        } else {
            phi_749_ = (_e179 | 8388608u);
        }
        let _e549 = phi_749_;
        if (_e545 <= 0i) {
            phi_769_ = u32();
            phi_770_ = true;
        } else {
            let _e556 = (_e549 == 0u);
            if _e556 {
                phi_768_ = u32();
            } else {
                phi_768_ = select(((bitcast<u32>(_e545) << bitcast<u32>(23i)) | (_e549 & 8388607u)), 2139095039u, (_e545 >= 255i));
            }
            let _e560 = phi_768_;
            phi_769_ = _e560;
            phi_770_ = _e556;
        }
        let _e562 = phi_769_;
        let _e564 = phi_770_;
        if (_e187 >= 2139095040u) {
            phi_788_ = 255i;
        } else {
            phi_788_ = (bitcast<i32>((_e187 >> bitcast<u32>(23i))) + _e520);
        }
        let _e575 = phi_788_;
        if (_e187 == 0u) {
            phi_794_ = 0u;
        } else {
            phi_794_ = (_e187 | 8388608u);
        }
        let _e579 = phi_794_;
        if (_e575 <= 0i) {
            phi_814_ = u32();
            phi_815_ = true;
        } else {
            let _e586 = (_e579 == 0u);
            if _e586 {
                phi_813_ = u32();
            } else {
                phi_813_ = select(((bitcast<u32>(_e575) << bitcast<u32>(23i)) | (_e579 & 8388607u)), 2139095039u, (_e575 >= 255i));
            }
            let _e590 = phi_813_;
            phi_814_ = _e590;
            phi_815_ = _e586;
        }
        let _e592 = phi_814_;
        let _e594 = phi_815_;
        phi_1192_ = SlimbvhTypeC(array<f32, 3>((_e220 * _e525), (_e224 * _e525), (_e227 * _e525)), array<f32, 3>((_e229 * _e530), (_e231 * _e530), (_e233 * _e530)), bitcast<f32>(((_e178 & 2147483648u) | select(_e562, 0u, _e564))), bitcast<f32>(((_e186 & 2147483648u) | select(_e592, 0u, _e594))), _e519);
    } else {
        let _e266 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e191, _e204))) & 2147483647u);
        if (_e266 >= 8388608u) {
            phi_846_ = (bitcast<i32>((_e266 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_846_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e266)), 32u, (_e266 == 0u))));
        }
        let _e280 = phi_846_;
        let _e281 = (_e171 + _e280);
        if (_e171 < -126i) {
            phi_857_ = -126i;
        } else {
            phi_857_ = select(_e171, 127i, (_e171 > 127i));
        }
        let _e286 = phi_857_;
        let _e291 = bitcast<f32>((bitcast<u32>((_e286 + 127i)) << bitcast<u32>(23i)));
        let _e297 = bitcast<f32>((bitcast<u32>(((_e171 - _e286) + 127i)) << bitcast<u32>(23i)));
        let _e298 = bitcast<u32>(_e220);
        let _e300 = ((_e298 & 2139095040u) != 0u);
        let _e315 = bitcast<u32>(_e224);
        let _e317 = ((_e315 & 2139095040u) != 0u);
        let _e332 = bitcast<u32>(_e227);
        let _e334 = ((_e332 & 2139095040u) != 0u);
        let _e350 = -(_e280);
        if (_e350 < -126i) {
            phi_971_ = -126i;
        } else {
            phi_971_ = select(_e350, 127i, (_e350 > 127i));
        }
        let _e355 = phi_971_;
        let _e360 = bitcast<f32>((bitcast<u32>((_e355 + 127i)) << bitcast<u32>(23i)));
        let _e366 = bitcast<f32>((bitcast<u32>(((_e350 - _e355) + 127i)) << bitcast<u32>(23i)));
        let _e367 = bitcast<u32>(_e229);
        let _e369 = ((_e367 & 2139095040u) != 0u);
        let _e384 = bitcast<u32>(_e231);
        let _e386 = ((_e384 & 2139095040u) != 0u);
        let _e401 = bitcast<u32>(_e233);
        let _e403 = ((_e401 & 2139095040u) != 0u);
        let _e425 = ((_e179 & 8388607u) | (select(0u, 1u, ((_e179 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e428 = bitcast<i32>((_e179 >> bitcast<u32>(23i)));
        let _e435 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e425)), 32u, (_e425 == 0u))) - 8i);
        if (_e428 == 255i) {
            phi_1100_ = 255i;
        } else {
            phi_1100_ = (((_e428 + select(0i, 1i, (_e428 == 0i))) - _e435) + _e281);
        }
        let _e443 = phi_1100_;
        let _e447 = (_e425 << bitcast<u32>(((_e435 & 31i) & 31i)));
        if (_e443 <= 0i) {
            phi_1123_ = u32();
            phi_1124_ = true;
        } else {
            let _e454 = (_e447 == 0u);
            if _e454 {
                phi_1122_ = u32();
            } else {
                phi_1122_ = select(((bitcast<u32>(_e443) << bitcast<u32>(23i)) | (_e447 & 8388607u)), 2139095039u, (_e443 >= 255i));
            }
            let _e458 = phi_1122_;
            phi_1123_ = _e458;
            phi_1124_ = _e454;
        }
        let _e460 = phi_1123_;
        let _e462 = phi_1124_;
        let _e473 = ((_e187 & 8388607u) | (select(0u, 1u, ((_e187 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e476 = bitcast<i32>((_e187 >> bitcast<u32>(23i)));
        let _e483 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e473)), 32u, (_e473 == 0u))) - 8i);
        if (_e476 == 255i) {
            phi_1158_ = 255i;
        } else {
            phi_1158_ = (((_e476 + select(0i, 1i, (_e476 == 0i))) - _e483) + _e281);
        }
        let _e491 = phi_1158_;
        let _e495 = (_e473 << bitcast<u32>(((_e483 & 31i) & 31i)));
        if (_e491 <= 0i) {
            phi_1181_ = u32();
            phi_1182_ = true;
        } else {
            let _e502 = (_e495 == 0u);
            if _e502 {
                phi_1180_ = u32();
            } else {
                phi_1180_ = select(((bitcast<u32>(_e491) << bitcast<u32>(23i)) | (_e495 & 8388607u)), 2139095039u, (_e491 >= 255i));
            }
            let _e506 = phi_1180_;
            phi_1181_ = _e506;
            phi_1182_ = _e502;
        }
        let _e508 = phi_1181_;
        let _e510 = phi_1182_;
        phi_1192_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e298 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e298 & 2147483648u))), _e220, _e300) * _e291) * select(0.00000011920929f, 1f, _e300)) * _e297), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e224, _e317) * _e291) * select(0.00000011920929f, 1f, _e317)) * _e297), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e332 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e332 & 2147483648u))), _e227, _e334) * _e291) * select(0.00000011920929f, 1f, _e334)) * _e297)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e367 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e367 & 2147483648u))), _e229, _e369) * _e360) * select(0.00000011920929f, 1f, _e369)) * _e366), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e231, _e386) * _e360) * select(0.00000011920929f, 1f, _e386)) * _e366), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e401 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e401 & 2147483648u))), _e233, _e403) * _e360) * select(0.00000011920929f, 1f, _e403)) * _e366)), bitcast<f32>(((_e178 & 2147483648u) | select(_e460, 0u, _e462))), bitcast<f32>(((_e186 & 2147483648u) | select(_e508, 0u, _e510))), _e280);
    }
    let _e601 = phi_1192_;
    let _e616 = (bitcast<f32>((bitcast<u32>(_e601.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e619 = bitcast<f32>((bitcast<u32>(_e601.member[0]) & 2147483647u));
    let _e620 = (_e619 * 0.00000011920929f);
    let _e623 = select(select(0.00000000000011368684f, _e620, (_e620 > 0.00000000000011368684f)), 0f, _e616);
    let _e624 = select(0f, _e601.member_1[0], _e616);
    let _e625 = (_e601.member[0] + _e623);
    let _e626 = (_e601.member[0] - _e623);
    let _e628 = select(38685626000000000000000000f, (1f / _e601.member_1[0]), _e616);
    let _e632 = (bitcast<f32>((bitcast<u32>(_e601.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e635 = bitcast<f32>((bitcast<u32>(_e601.member[1]) & 2147483647u));
    let _e636 = (_e635 * 0.00000011920929f);
    let _e639 = select(select(0.00000000000011368684f, _e636, (_e636 > 0.00000000000011368684f)), 0f, _e632);
    let _e640 = select(0f, _e601.member_1[1], _e632);
    let _e641 = (_e601.member[1] + _e639);
    let _e642 = (_e601.member[1] - _e639);
    let _e644 = select(38685626000000000000000000f, (1f / _e601.member_1[1]), _e632);
    let _e648 = (bitcast<f32>((bitcast<u32>(_e601.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e651 = bitcast<f32>((bitcast<u32>(_e601.member[2]) & 2147483647u));
    let _e652 = (_e651 * 0.00000011920929f);
    let _e655 = select(select(0.00000000000011368684f, _e652, (_e652 > 0.00000000000011368684f)), 0f, _e648);
    let _e656 = select(0f, _e601.member_1[2], _e648);
    let _e657 = (_e601.member[2] + _e655);
    let _e658 = (_e601.member[2] - _e655);
    let _e660 = select(38685626000000000000000000f, (1f / _e601.member_1[2]), _e648);
    let _e662 = select(_e635, _e619, (_e619 > _e635));
    let _e666 = (_e204 && (select(_e651, _e662, (_e662 > _e651)) <= 1099511600000f));
    let _e667 = select(0f, _e601.member_3, _e666);
    let _e668 = select(1f, _e601.member_2, _e666);
    let _e670 = slimbvh_lane.member;
    if (_e670 < 64u) {
        let _e672 = (_e670 % 64u);
        let _e673 = slimbvh_any_will_do.member;
        if (_e673 == 1u) {
            phi_1428_ = SlimbvhTypeP(SlimbvhTypeH(_e100, _e667), true);
        } else {
            phi_1428_ = SlimbvhTypeP(SlimbvhTypeH(_e100, _e667), false);
        }
        let _e680 = phi_1428_;
        let _e685 = (_e213 & 3u);
        let _e686 = (_e217 & 3u);
        let _e687 = (_e209 & 3u);
        let _e690 = (bitcast<u32>(_e628) >> bitcast<u32>(31i));
        let _e693 = (bitcast<u32>(_e644) >> bitcast<u32>(31i));
        let _e696 = (bitcast<u32>(_e660) >> bitcast<u32>(31i));
        let _e700 = (f32(bitcast<i32>(_e117)) * _e153);
        let _e702 = (f32(bitcast<i32>(_e121)) * _e153);
        let _e704 = (f32(bitcast<i32>(_e125)) * _e153);
        let _e705 = (_e685 == 0u);
        if _e705 {
            phi_1492_ = array<f32, 3>(_e700, _e702, _e704);
        } else {
            if (_e685 == 1u) {
                phi_1491_ = array<f32, 3>(_e702, _e704, _e700);
            } else {
                phi_1491_ = array<f32, 3>(_e704, _e700, _e702);
            }
            let _e710 = phi_1491_;
            phi_1492_ = _e710;
        }
        let _e713 = phi_1492_;
        let _e715 = (f32(bitcast<i32>(_e133)) * _e153);
        let _e717 = (f32(bitcast<i32>(_e137)) * _e153);
        let _e719 = (f32(bitcast<i32>(_e141)) * _e153);
        if _e705 {
            phi_1511_ = array<f32, 3>(_e715, _e717, _e719);
        } else {
            if (_e685 == 1u) {
                phi_1510_ = array<f32, 3>(_e717, _e719, _e715);
            } else {
                phi_1510_ = array<f32, 3>(_e719, _e715, _e717);
            }
            let _e724 = phi_1510_;
            phi_1511_ = _e724;
        }
        let _e727 = phi_1511_;
        let _e738 = ((_e713[0] - _e625) * _e628);
        let _e739 = ((_e727[0] - _e626) * _e628);
        let _e740 = vec4<f32>(_e738, f32(), _e739, f32());
        let _e743 = ((_e713[1] - _e641) * _e644);
        let _e744 = ((_e727[1] - _e642) * _e644);
        let _e745 = vec4<f32>(_e743, f32(), _e744, f32());
        let _e748 = ((_e713[2] - _e657) * _e660);
        let _e749 = ((_e727[2] - _e658) * _e660);
        let _e750 = vec4<f32>(_e748, f32(), _e749, f32());
        let _e751 = vec4<f32>(_e739, f32(), _e738, f32());
        let _e753 = vec4<f32>(_e744, f32(), _e743, f32());
        let _e755 = vec4<f32>(_e749, f32(), _e748, f32());
        phi_1684_ = _e680;
        phi_1687_ = select(4294967295u, select(4294967295u, 0u, (_e668 <= _e667)), (max(max(max(min(_e740, _e751).x, min(_e745, _e753).x), min(_e750, _e755).x), _e668) <= min((min(min(max(_e740, _e751).x, max(_e745, _e753).x), max(_e750, _e755).x) + (max(max(_e750, _e755).x, -(min(_e750, _e755).x)) * 0.0000019073523f)), _e680.member.member_1)));
        phi_1689_ = select(0u, 4294967295u, (_e104 == 0u));
        phi_1691_ = (_e104 + 1u);
        loop {
            let _e779 = phi_1684_;
            let _e781 = phi_1687_;
            let _e783 = phi_1689_;
            let _e785 = phi_1691_;
            local_5 = _e781;
            local_6 = _e779;
            let _e786 = (_e781 <= 32u);
            if _e786 {
                phi_1700_ = _e781;
                phi_1703_ = _e783;
                phi_1705_ = _e785;
                loop {
                    let _e788 = phi_1700_;
                    let _e790 = phi_1703_;
                    let _e792 = phi_1705_;
                    local_1 = _e790;
                    local_2 = _e788;
                    local_3 = _e788;
                    local_8 = _e788;
                    local_9 = _e790;
                    local_10 = _e792;
                    let _e793 = (_e788 <= 32u);
                    let _e796 = (_e793 && !((_e790 >= _e104)));
                    local = _e793;
                    if _e796 {
                        let _e802 = slimbvh_nodes.member[_e790].member[select(_e685, 2u, (2u < _e685))];
                        let _e808 = slimbvh_nodes.member[_e790].member[select(_e686, 2u, (2u < _e686))];
                        let _e814 = slimbvh_nodes.member[_e790].member[select(_e687, 2u, (2u < _e687))];
                        let _e817 = bitcast<u32>(_e153);
                        let _e822 = bitcast<f32>(_e802.x);
                        let _e827 = (_e822 + (f32((_e802.w >> bitcast<u32>(5u))) * _e153));
                        if (_e690 == 0u) {
                            phi_1807_ = SlimbvhTypeK(_e802.z, _e827);
                            phi_1808_ = SlimbvhTypeK(_e802.y, _e822);
                        } else {
                            phi_1807_ = SlimbvhTypeK(_e802.y, _e822);
                            phi_1808_ = SlimbvhTypeK(_e802.z, _e827);
                        }
                        let _e838 = phi_1807_;
                        let _e840 = phi_1808_;
                        let _e844 = bitcast<f32>(((_e817 + ((_e802.w & 31u) << bitcast<u32>(23i))) ^ (_e690 << bitcast<u32>(31i))));
                        let _e884 = bitcast<f32>(_e808.x);
                        let _e889 = (_e884 + (f32((_e808.w >> bitcast<u32>(5u))) * _e153));
                        if (_e693 == 0u) {
                            phi_1867_ = SlimbvhTypeK(_e808.z, _e889);
                            phi_1868_ = SlimbvhTypeK(_e808.y, _e884);
                        } else {
                            phi_1867_ = SlimbvhTypeK(_e808.y, _e884);
                            phi_1868_ = SlimbvhTypeK(_e808.z, _e889);
                        }
                        let _e900 = phi_1867_;
                        let _e902 = phi_1868_;
                        let _e906 = bitcast<f32>(((_e817 + ((_e808.w & 31u) << bitcast<u32>(23i))) ^ (_e693 << bitcast<u32>(31i))));
                        let _e946 = bitcast<f32>(_e814.x);
                        let _e951 = (_e946 + (f32((_e814.w >> bitcast<u32>(5u))) * _e153));
                        if (_e696 == 0u) {
                            phi_1927_ = SlimbvhTypeK(_e814.z, _e951);
                            phi_1928_ = SlimbvhTypeK(_e814.y, _e946);
                        } else {
                            phi_1927_ = SlimbvhTypeK(_e814.y, _e946);
                            phi_1928_ = SlimbvhTypeK(_e814.z, _e951);
                        }
                        let _e962 = phi_1927_;
                        let _e964 = phi_1928_;
                        let _e968 = bitcast<f32>(((_e817 + ((_e814.w & 31u) << bitcast<u32>(23i))) ^ (_e696 << bitcast<u32>(31i))));
                        let _e1004 = (_e844 * _e628);
                        let _e1011 = (((_e840.member_1 - _e625) * _e628) + (bitcast<f32>((bitcast<u32>(_e1004) & 2147483647u)) * -0.00012207031f));
                        let _e1020 = (-(_e844) * _e628);
                        let _e1027 = (((_e838.member_1 - _e626) * _e628) + (bitcast<f32>((bitcast<u32>(_e1020) & 2147483647u)) * 0.00012207031f));
                        let _e1036 = (_e906 * _e644);
                        let _e1043 = (((_e902.member_1 - _e641) * _e644) + (bitcast<f32>((bitcast<u32>(_e1036) & 2147483647u)) * -0.00012207031f));
                        let _e1052 = (-(_e906) * _e644);
                        let _e1059 = (((_e900.member_1 - _e642) * _e644) + (bitcast<f32>((bitcast<u32>(_e1052) & 2147483647u)) * 0.00012207031f));
                        let _e1068 = (_e968 * _e660);
                        let _e1075 = (((_e964.member_1 - _e657) * _e660) + (bitcast<f32>((bitcast<u32>(_e1068) & 2147483647u)) * -0.00012207031f));
                        let _e1080 = ((f32((_e964.member & 255u)) * _e1068) + _e1075);
                        let _e1081 = ((f32(((_e964.member >> bitcast<u32>(8u)) & 255u)) * _e1068) + _e1075);
                        let _e1082 = ((f32(((_e964.member >> bitcast<u32>(16u)) & 255u)) * _e1068) + _e1075);
                        let _e1083 = ((f32(((_e964.member >> bitcast<u32>(24u)) & 255u)) * _e1068) + _e1075);
                        let _e1084 = (-(_e968) * _e660);
                        let _e1091 = (((_e962.member_1 - _e658) * _e660) + (bitcast<f32>((bitcast<u32>(_e1084) & 2147483647u)) * 0.00012207031f));
                        let _e1096 = ((f32((_e962.member & 255u)) * _e1084) + _e1091);
                        let _e1097 = ((f32(((_e962.member >> bitcast<u32>(8u)) & 255u)) * _e1084) + _e1091);
                        let _e1098 = ((f32(((_e962.member >> bitcast<u32>(16u)) & 255u)) * _e1084) + _e1091);
                        let _e1099 = ((f32(((_e962.member >> bitcast<u32>(24u)) & 255u)) * _e1084) + _e1091);
                        let _e1132 = max(max(max(((f32((_e840.member & 255u)) * _e1004) + _e1011), ((f32((_e902.member & 255u)) * _e1036) + _e1043)), _e1080), _e668);
                        let _e1133 = max(max(max(((f32(((_e840.member >> bitcast<u32>(8u)) & 255u)) * _e1004) + _e1011), ((f32(((_e902.member >> bitcast<u32>(8u)) & 255u)) * _e1036) + _e1043)), _e1081), _e668);
                        let _e1134 = max(max(max(((f32(((_e840.member >> bitcast<u32>(16u)) & 255u)) * _e1004) + _e1011), ((f32(((_e902.member >> bitcast<u32>(16u)) & 255u)) * _e1036) + _e1043)), _e1082), _e668);
                        let _e1135 = max(max(max(((f32(((_e840.member >> bitcast<u32>(24u)) & 255u)) * _e1004) + _e1011), ((f32(((_e902.member >> bitcast<u32>(24u)) & 255u)) * _e1036) + _e1043)), _e1083), _e668);
                        let _e1140 = (_e779.member.member_1 + (bitcast<f32>((bitcast<u32>(_e779.member.member_1) & 2147483647u)) * 0.0000004768374f));
                        if (_e1132 <= min((min(min(((f32((_e838.member & 255u)) * _e1020) + _e1027), ((f32((_e900.member & 255u)) * _e1052) + _e1059)), _e1096) + (max(_e1096, -(_e1080)) * 0.0000023841915f)), _e1140)) {
                            phi_2412_ = (((bitcast<u32>(_e1132) ^ select(0u, 4294967288u, _e680.member_1)) & 2147483640u) | 4u);
                        } else {
                            phi_2412_ = 4294967288u;
                        }
                        let _e1155 = phi_2412_;
                        if (_e1133 <= min((min(min(((f32(((_e838.member >> bitcast<u32>(8u)) & 255u)) * _e1020) + _e1027), ((f32(((_e900.member >> bitcast<u32>(8u)) & 255u)) * _e1052) + _e1059)), _e1097) + (max(_e1097, -(_e1081)) * 0.0000023841915f)), _e1140)) {
                            phi_2425_ = ((((bitcast<u32>(_e1133) ^ select(0u, 4294967288u, _e680.member_1)) & 2147483640u) | 4u) | 1u);
                        } else {
                            phi_2425_ = 4294967288u;
                        }
                        let _e1163 = phi_2425_;
                        if (_e1134 <= min((min(min(((f32(((_e838.member >> bitcast<u32>(16u)) & 255u)) * _e1020) + _e1027), ((f32(((_e900.member >> bitcast<u32>(16u)) & 255u)) * _e1052) + _e1059)), _e1098) + (max(_e1098, -(_e1082)) * 0.0000023841915f)), _e1140)) {
                            phi_2438_ = ((((bitcast<u32>(_e1134) ^ select(0u, 4294967288u, _e680.member_1)) & 2147483640u) | 4u) | 2u);
                        } else {
                            phi_2438_ = 4294967288u;
                        }
                        let _e1171 = phi_2438_;
                        if (_e1135 <= min((min(min(((f32(((_e838.member >> bitcast<u32>(24u)) & 255u)) * _e1020) + _e1027), ((f32(((_e900.member >> bitcast<u32>(24u)) & 255u)) * _e1052) + _e1059)), _e1099) + (max(_e1099, -(_e1083)) * 0.0000023841915f)), _e1140)) {
                            phi_2451_ = ((((bitcast<u32>(_e1135) ^ select(0u, 4294967288u, _e680.member_1)) & 2147483640u) | 4u) | 3u);
                        } else {
                            phi_2451_ = 4294967288u;
                        }
                        let _e1179 = phi_2451_;
                        if (_e1155 < _e1163) {
                            phi_4600_ = SlimbvhTypeD(_e1155, _e1163);
                        } else {
                            phi_4600_ = SlimbvhTypeD(_e1163, _e1155);
                        }
                        let _e1184 = phi_4600_;
                        if (_e1171 < _e1179) {
                            phi_4612_ = SlimbvhTypeD(_e1171, _e1179);
                        } else {
                            phi_4612_ = SlimbvhTypeD(_e1179, _e1171);
                        }
                        let _e1191 = phi_4612_;
                        if (_e1184.member < _e1191.member) {
                            phi_4624_ = SlimbvhTypeD(_e1184.member, _e1191.member);
                        } else {
                            phi_4624_ = SlimbvhTypeD(_e1191.member, _e1184.member);
                        }
                        let _e1198 = phi_4624_;
                        if (_e1184.member_1 < _e1191.member_1) {
                            phi_4636_ = SlimbvhTypeD(_e1184.member_1, _e1191.member_1);
                        } else {
                            phi_4636_ = SlimbvhTypeD(_e1191.member_1, _e1184.member_1);
                        }
                        let _e1205 = phi_4636_;
                        if (_e1205.member < _e1198.member_1) {
                            phi_4648_ = SlimbvhTypeD(_e1205.member, _e1198.member_1);
                        } else {
                            phi_4648_ = SlimbvhTypeD(_e1198.member_1, _e1205.member);
                        }
                        let _e1212 = phi_4648_;
                        let _e1227 = (((_e1198.member & 7u) | ((_e1212.member & 7u) << bitcast<u32>(3u))) | (((_e1212.member_1 & 7u) | ((_e1205.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                        if (_e1227 == 0u) {
                            let _e1247 = (_e788 - 1u);
                            let _e1252 = slimbvh_stacks[(((_e1247 % 32u) * 64u) + _e672)];
                            let _e1253 = (_e1252 & 511u);
                            let _e1255 = (_e1253 >> bitcast<u32>(3u));
                            let _e1258 = ((_e1255 == 0u) || (_e1247 == 4294967295u));
                            if _e1258 {
                            } else {
                                slimbvh_stacks[(((_e1247 % 32u) * 64u) + _e672)] = (((_e1252 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1255);
                            }
                            phi_2540_ = select(_e788, _e1247, _e1258);
                            phi_2541_ = (((_e1252 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1253 & 3u) & 3u));
                        } else {
                            let _e1230 = (_e1227 >> bitcast<u32>(3u));
                            if (_e1230 == 0u) {
                                phi_2535_ = _e788;
                            } else {
                                slimbvh_stacks[(((_e788 % 32u) * 64u) + _e672)] = ((_e790 << bitcast<u32>(9u)) | _e1230);
                                phi_2535_ = (_e788 + 1u);
                            }
                            let _e1241 = phi_2535_;
                            phi_2540_ = _e1241;
                            phi_2541_ = ((_e790 << bitcast<u32>(2i)) | ((_e1227 & 3u) & 3u));
                        }
                        let _e1273 = phi_2540_;
                        let _e1275 = phi_2541_;
                        let _e1277 = (_e1275 >> bitcast<u32>(2i));
                        if (_e1277 < _e104) {
                            let _e1283 = slimbvh_nodes.member[_e1277].member_1[(_e1275 & 3u)];
                            if ((_e1283 & 2147483648u) != 0u) {
                                phi_2571_ = (2147483648u | _e1275);
                            } else {
                                phi_2571_ = _e1283;
                            }
                            let _e1288 = phi_2571_;
                            phi_2572_ = _e1288;
                        } else {
                            phi_2572_ = 4294967295u;
                        }
                        let _e1290 = phi_2572_;
                        let _e1291 = (_e792 - 1u);
                        phi_1701_ = select(_e1273, 4294967295u, (_e1291 == 0u));
                        phi_1704_ = _e1290;
                        phi_1706_ = _e1291;
                    } else {
                        phi_1701_ = u32();
                        phi_1704_ = u32();
                        phi_1706_ = u32();
                    }
                    let _e1295 = phi_1701_;
                    let _e1297 = phi_1704_;
                    let _e1299 = phi_1706_;
                    continue;
                    continuing {
                        phi_1700_ = _e1295;
                        phi_1703_ = _e1297;
                        phi_1705_ = _e1299;
                        break if !(_e796);
                    }
                }
                let _e1302 = local;
                if _e1302 {
                    let _e1304 = local_1;
                    let _e1305 = (_e1304 & 2147483647u);
                    let _e1307 = (_e1305 >> bitcast<u32>(2i));
                    if (_e1307 >= _e104) {
                        phi_2786_ = SlimbvhTypeM(SlimbvhTypeL(vec4<f32>(0f, 0f, 0f, 0f), 0u), 0u, 0u);
                    } else {
                        let _e1314 = slimbvh_nodes.member[_e1307].member[select(_e685, 2u, (2u < _e685))];
                        let _e1325 = slimbvh_nodes.member[_e1307].member[select(_e686, 2u, (2u < _e686))];
                        let _e1336 = slimbvh_nodes.member[_e1307].member[select(_e687, 2u, (2u < _e687))];
                        let _e1342 = (_e1305 & 3u);
                        let _e1345 = (((8u * _e1342) & 31u) & 31u);
                        let _e1353 = ((_e1314.w & 31u) & 31u);
                        let _e1355 = (((_e1314.y >> bitcast<u32>(_e1345)) & 255u) << bitcast<u32>(_e1353));
                        let _e1369 = ((_e1325.w & 31u) & 31u);
                        let _e1371 = (((_e1325.y >> bitcast<u32>(_e1345)) & 255u) << bitcast<u32>(_e1369));
                        let _e1385 = ((_e1336.w & 31u) & 31u);
                        let _e1387 = (((_e1336.y >> bitcast<u32>(_e1345)) & 255u) << bitcast<u32>(_e1385));
                        let _e1395 = (((((_e1314.w >> bitcast<u32>(5u)) - (((_e1314.z >> bitcast<u32>(_e1345)) & 255u) << bitcast<u32>(_e1353))) - _e1355) | (((_e1325.w >> bitcast<u32>(5u)) - (((_e1325.z >> bitcast<u32>(_e1345)) & 255u) << bitcast<u32>(_e1369))) - _e1371)) | (((_e1336.w >> bitcast<u32>(5u)) - (((_e1336.z >> bitcast<u32>(_e1345)) & 255u) << bitcast<u32>(_e1385))) - _e1387));
                        if (_e1395 < 1024u) {
                            phi_2722_ = 0u;
                        } else {
                            phi_2722_ = select(2u, 1u, (_e1395 < 2097152u));
                        }
                        let _e1400 = phi_2722_;
                        let _e1415 = slimbvh_nodes.member[_e1307].member_1[_e1342];
                        if ((_e1415 & 2147483648u) != 0u) {
                            phi_2783_ = ((_e1415 >> bitcast<u32>(28u)) & 7u);
                        } else {
                            phi_2783_ = 0u;
                        }
                        let _e1422 = phi_2783_;
                        phi_2786_ = SlimbvhTypeM(SlimbvhTypeL(vec4<f32>((bitcast<f32>(_e1314.x) + (f32(_e1355) * _e153)), (bitcast<f32>(_e1325.x) + (f32(_e1371) * _e153)), (bitcast<f32>(_e1336.x) + (f32(_e1387) * _e153)), 0f), _e1400), (_e1415 & 268435455u), _e1422);
                    }
                    let _e1426 = phi_2786_;
                    phi_2790_ = _e779;
                    phi_2793_ = SlimbvhTypeD(0u, _e1426.member_2);
                    loop {
                        let _e1430 = phi_2790_;
                        let _e1432 = phi_2793_;
                        local_4 = _e1430;
                        local_7 = _e1430;
                        if (_e1432.member < _e1432.member_1) {
                            phi_2794_ = SlimbvhTypeD((_e1432.member + 1u), _e1432.member_1);
                            phi_2816_ = SlimbvhTypeD(1u, _e1432.member);
                        } else {
                            phi_2794_ = _e1432;
                            phi_2816_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                        }
                        let _e1445 = phi_2794_;
                        let _e1447 = phi_2816_;
                        let _e1451 = (bitcast<i32>(_e1447.member) != 0i);
                        if _e1451 {
                            switch bitcast<i32>(_e1426.member.member_1) {
                                case 0: {
                                    phi_2834_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2834_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2834_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2834_ = u32();
                                    break;
                                }
                            }
                            let _e1457 = phi_2834_;
                            switch bitcast<i32>(_e1426.member.member_1) {
                                case 0: {
                                    phi_2845_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2845_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2845_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2845_ = u32();
                                    break;
                                }
                            }
                            let _e1464 = phi_2845_;
                            let _e1466 = ((_e1426.member_1 + (_e1447.member_1 * ((3u * _e1457) + 1u))) + (3u * _e1464));
                            if (_e1466 < _e107) {
                                let _e1469 = slimbvh_triangles.member[_e1466];
                                phi_2861_ = _e1469;
                            } else {
                                phi_2861_ = 4294967295u;
                            }
                            let _e1471 = phi_2861_;
                            switch bitcast<i32>(_e1426.member.member_1) {
                                case 0: {
                                    phi_2874_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2874_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2874_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2874_ = u32();
                                    break;
                                }
                            }
                            let _e1474 = phi_2874_;
                            let _e1478 = (_e1426.member_1 + (_e1447.member_1 * ((3u * _e1474) + 1u)));
                            switch bitcast<i32>(_e1426.member.member_1) {
                                case 0: {
                                    phi_2885_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2885_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2885_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2885_ = u32();
                                    break;
                                }
                            }
                            let _e1481 = phi_2885_;
                            let _e1482 = (_e1478 + _e1481);
                            let _e1484 = (_e1478 + (2u * _e1481));
                            switch bitcast<i32>(_e1426.member.member_1) {
                                case 0: {
                                    if (_e1478 < _e107) {
                                        let _e1761 = slimbvh_triangles.member[_e1478];
                                        phi_2912_ = _e1761;
                                    } else {
                                        phi_2912_ = 0u;
                                    }
                                    let _e1763 = phi_2912_;
                                    let _e1766 = ((10u * _e213) & 31u);
                                    let _e1777 = ((10u * _e217) & 31u);
                                    let _e1788 = ((10u * _e209) & 31u);
                                    if (_e1482 < _e107) {
                                        let _e1800 = slimbvh_triangles.member[_e1482];
                                        phi_2958_ = _e1800;
                                    } else {
                                        phi_2958_ = 0u;
                                    }
                                    let _e1802 = phi_2958_;
                                    if (_e1484 < _e107) {
                                        let _e1830 = slimbvh_triangles.member[_e1484];
                                        phi_3004_ = _e1830;
                                    } else {
                                        phi_3004_ = 0u;
                                    }
                                    let _e1832 = phi_3004_;
                                    phi_3471_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1426.member.member.x + ((bitcast<f32>((1258291200u | ((_e1763 >> bitcast<u32>(_e1766)) & 1023u))) - 8388608f) * _e153)), (_e1426.member.member.y + ((bitcast<f32>((1258291200u | ((_e1763 >> bitcast<u32>(_e1777)) & 1023u))) - 8388608f) * _e153)), (_e1426.member.member.z + ((bitcast<f32>((1258291200u | ((_e1763 >> bitcast<u32>(_e1788)) & 1023u))) - 8388608f) * _e153))), array<f32, 3>((_e1426.member.member.x + ((bitcast<f32>((1258291200u | ((_e1802 >> bitcast<u32>(_e1766)) & 1023u))) - 8388608f) * _e153)), (_e1426.member.member.y + ((bitcast<f32>((1258291200u | ((_e1802 >> bitcast<u32>(_e1777)) & 1023u))) - 8388608f) * _e153)), (_e1426.member.member.z + ((bitcast<f32>((1258291200u | ((_e1802 >> bitcast<u32>(_e1788)) & 1023u))) - 8388608f) * _e153))), array<f32, 3>((_e1426.member.member.x + ((bitcast<f32>((1258291200u | ((_e1832 >> bitcast<u32>(_e1766)) & 1023u))) - 8388608f) * _e153)), (_e1426.member.member.y + ((bitcast<f32>((1258291200u | ((_e1832 >> bitcast<u32>(_e1777)) & 1023u))) - 8388608f) * _e153)), (_e1426.member.member.z + ((bitcast<f32>((1258291200u | ((_e1832 >> bitcast<u32>(_e1788)) & 1023u))) - 8388608f) * _e153))));
                                    break;
                                }
                                case 1: {
                                    if (_e1478 < _e107) {
                                        let _e1574 = slimbvh_triangles.member[_e1478];
                                        phi_3051_ = _e1574;
                                    } else {
                                        phi_3051_ = 0u;
                                    }
                                    let _e1576 = phi_3051_;
                                    let _e1577 = (_e1478 + 1u);
                                    if (_e1577 < _e107) {
                                        let _e1580 = slimbvh_triangles.member[_e1577];
                                        phi_3064_ = _e1580;
                                    } else {
                                        phi_3064_ = 0u;
                                    }
                                    let _e1582 = phi_3064_;
                                    let _e1584 = (_e213 == 1u);
                                    if _e1584 {
                                        phi_3074_ = ((_e1576 >> bitcast<u32>(21i)) | (_e1582 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3074_ = (_e1582 >> bitcast<u32>(10i));
                                    }
                                    let _e1593 = phi_3074_;
                                    let _e1602 = (_e217 == 1u);
                                    if _e1602 {
                                        phi_3095_ = ((_e1576 >> bitcast<u32>(21i)) | (_e1582 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3095_ = (_e1582 >> bitcast<u32>(10i));
                                    }
                                    let _e1611 = phi_3095_;
                                    let _e1620 = (_e209 == 1u);
                                    if _e1620 {
                                        phi_3116_ = ((_e1576 >> bitcast<u32>(21i)) | (_e1582 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3116_ = (_e1582 >> bitcast<u32>(10i));
                                    }
                                    let _e1629 = phi_3116_;
                                    if (_e1482 < _e107) {
                                        let _e1640 = slimbvh_triangles.member[_e1482];
                                        phi_3143_ = _e1640;
                                    } else {
                                        phi_3143_ = 0u;
                                    }
                                    let _e1642 = phi_3143_;
                                    let _e1643 = (_e1482 + 1u);
                                    if (_e1643 < _e107) {
                                        let _e1646 = slimbvh_triangles.member[_e1643];
                                        phi_3156_ = _e1646;
                                    } else {
                                        phi_3156_ = 0u;
                                    }
                                    let _e1648 = phi_3156_;
                                    if _e1584 {
                                        phi_3166_ = ((_e1642 >> bitcast<u32>(21i)) | (_e1648 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3166_ = (_e1648 >> bitcast<u32>(10i));
                                    }
                                    let _e1657 = phi_3166_;
                                    if _e1602 {
                                        phi_3187_ = ((_e1642 >> bitcast<u32>(21i)) | (_e1648 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3187_ = (_e1648 >> bitcast<u32>(10i));
                                    }
                                    let _e1673 = phi_3187_;
                                    if _e1620 {
                                        phi_3208_ = ((_e1642 >> bitcast<u32>(21i)) | (_e1648 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3208_ = (_e1648 >> bitcast<u32>(10i));
                                    }
                                    let _e1689 = phi_3208_;
                                    if (_e1484 < _e107) {
                                        let _e1700 = slimbvh_triangles.member[_e1484];
                                        phi_3235_ = _e1700;
                                    } else {
                                        phi_3235_ = 0u;
                                    }
                                    let _e1702 = phi_3235_;
                                    let _e1703 = (_e1484 + 1u);
                                    if (_e1703 < _e107) {
                                        let _e1706 = slimbvh_triangles.member[_e1703];
                                        phi_3248_ = _e1706;
                                    } else {
                                        phi_3248_ = 0u;
                                    }
                                    let _e1708 = phi_3248_;
                                    if _e1584 {
                                        phi_3258_ = ((_e1702 >> bitcast<u32>(21i)) | (_e1708 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3258_ = (_e1708 >> bitcast<u32>(10i));
                                    }
                                    let _e1717 = phi_3258_;
                                    if _e1602 {
                                        phi_3279_ = ((_e1702 >> bitcast<u32>(21i)) | (_e1708 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3279_ = (_e1708 >> bitcast<u32>(10i));
                                    }
                                    let _e1733 = phi_3279_;
                                    if _e1620 {
                                        phi_3300_ = ((_e1702 >> bitcast<u32>(21i)) | (_e1708 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3300_ = (_e1708 >> bitcast<u32>(10i));
                                    }
                                    let _e1749 = phi_3300_;
                                    phi_3471_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1426.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1593, _e1576, _e218) & 2097151u))) - 8388608f) * _e153)), (_e1426.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1611, _e1576, _e221) & 2097151u))) - 8388608f) * _e153)), (_e1426.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1629, _e1576, _e225) & 2097151u))) - 8388608f) * _e153))), array<f32, 3>((_e1426.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1657, _e1642, _e218) & 2097151u))) - 8388608f) * _e153)), (_e1426.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1673, _e1642, _e221) & 2097151u))) - 8388608f) * _e153)), (_e1426.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1689, _e1642, _e225) & 2097151u))) - 8388608f) * _e153))), array<f32, 3>((_e1426.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1717, _e1702, _e218) & 2097151u))) - 8388608f) * _e153)), (_e1426.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1733, _e1702, _e221) & 2097151u))) - 8388608f) * _e153)), (_e1426.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1749, _e1702, _e225) & 2097151u))) - 8388608f) * _e153))));
                                    break;
                                }
                                case 2: {
                                    let _e1487 = (_e1478 + _e213);
                                    if (_e1487 < _e107) {
                                        let _e1490 = slimbvh_triangles.member[_e1487];
                                        phi_3329_ = _e1490;
                                    } else {
                                        phi_3329_ = 0u;
                                    }
                                    let _e1492 = phi_3329_;
                                    let _e1493 = (_e1478 + _e217);
                                    if (_e1493 < _e107) {
                                        let _e1496 = slimbvh_triangles.member[_e1493];
                                        phi_3342_ = _e1496;
                                    } else {
                                        phi_3342_ = 0u;
                                    }
                                    let _e1498 = phi_3342_;
                                    let _e1499 = (_e1478 + _e209);
                                    if (_e1499 < _e107) {
                                        let _e1502 = slimbvh_triangles.member[_e1499];
                                        phi_3355_ = _e1502;
                                    } else {
                                        phi_3355_ = 0u;
                                    }
                                    let _e1504 = phi_3355_;
                                    let _e1515 = (_e1482 + _e213);
                                    if (_e1515 < _e107) {
                                        let _e1518 = slimbvh_triangles.member[_e1515];
                                        phi_3381_ = _e1518;
                                    } else {
                                        phi_3381_ = 0u;
                                    }
                                    let _e1520 = phi_3381_;
                                    let _e1521 = (_e1482 + _e217);
                                    if (_e1521 < _e107) {
                                        let _e1524 = slimbvh_triangles.member[_e1521];
                                        phi_3394_ = _e1524;
                                    } else {
                                        phi_3394_ = 0u;
                                    }
                                    let _e1526 = phi_3394_;
                                    let _e1527 = (_e1482 + _e209);
                                    if (_e1527 < _e107) {
                                        let _e1530 = slimbvh_triangles.member[_e1527];
                                        phi_3407_ = _e1530;
                                    } else {
                                        phi_3407_ = 0u;
                                    }
                                    let _e1532 = phi_3407_;
                                    let _e1543 = (_e1484 + _e213);
                                    if (_e1543 < _e107) {
                                        let _e1546 = slimbvh_triangles.member[_e1543];
                                        phi_3433_ = _e1546;
                                    } else {
                                        phi_3433_ = 0u;
                                    }
                                    let _e1548 = phi_3433_;
                                    let _e1549 = (_e1484 + _e217);
                                    if (_e1549 < _e107) {
                                        let _e1552 = slimbvh_triangles.member[_e1549];
                                        phi_3446_ = _e1552;
                                    } else {
                                        phi_3446_ = 0u;
                                    }
                                    let _e1554 = phi_3446_;
                                    let _e1555 = (_e1484 + _e209);
                                    if (_e1555 < _e107) {
                                        let _e1558 = slimbvh_triangles.member[_e1555];
                                        phi_3459_ = _e1558;
                                    } else {
                                        phi_3459_ = 0u;
                                    }
                                    let _e1560 = phi_3459_;
                                    phi_3471_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1492)) * _e153), (f32(bitcast<i32>(_e1498)) * _e153), (f32(bitcast<i32>(_e1504)) * _e153)), array<f32, 3>((f32(bitcast<i32>(_e1520)) * _e153), (f32(bitcast<i32>(_e1526)) * _e153), (f32(bitcast<i32>(_e1532)) * _e153)), array<f32, 3>((f32(bitcast<i32>(_e1548)) * _e153), (f32(bitcast<i32>(_e1554)) * _e153), (f32(bitcast<i32>(_e1560)) * _e153)));
                                    break;
                                }
                                default: {
                                    phi_3471_ = array<array<f32, 3>, 3>();
                                    break;
                                }
                            }
                            let _e1860 = phi_3471_;
                            let _e1877 = (_e1860[0][2] - _e601.member[2]);
                            let _e1880 = (((_e1860[0][0] - _e601.member[0]) * _e656) - (_e1877 * _e624));
                            let _e1883 = (((_e1860[0][1] - _e601.member[1]) * _e656) - (_e1877 * _e640));
                            let _e1886 = (_e1860[1][2] - _e601.member[2]);
                            let _e1889 = (((_e1860[1][0] - _e601.member[0]) * _e656) - (_e1886 * _e624));
                            let _e1892 = (((_e1860[1][1] - _e601.member[1]) * _e656) - (_e1886 * _e640));
                            let _e1895 = (_e1860[2][2] - _e601.member[2]);
                            let _e1898 = (((_e1860[2][0] - _e601.member[0]) * _e656) - (_e1895 * _e624));
                            let _e1901 = (((_e1860[2][1] - _e601.member[1]) * _e656) - (_e1895 * _e640));
                            let _e1902 = (_e1898 * _e1892);
                            let _e1903 = (_e1901 * _e1889);
                            let _e1904 = (_e1880 * _e1901);
                            let _e1905 = (_e1883 * _e1898);
                            let _e1906 = (_e1889 * _e1883);
                            let _e1907 = (_e1892 * _e1880);
                            let _e1912 = (((_e1902 >= _e1903) && (_e1904 >= _e1905)) && (_e1906 >= _e1907));
                            let _e1918 = (_e1912 || (((_e1902 <= _e1903) && (_e1904 <= _e1905)) && (_e1906 <= _e1907)));
                            if _e1918 {
                                let _e1920 = select(-1f, 1f, _e1912);
                                let _e1922 = ((_e1902 - _e1903) * _e1920);
                                let _e1924 = select(0f, _e1922, (_e1922 > 0f));
                                let _e1926 = ((_e1904 - _e1905) * _e1920);
                                let _e1928 = select(0f, _e1926, (_e1926 > 0f));
                                let _e1930 = ((_e1906 - _e1907) * _e1920);
                                let _e1932 = select(0f, _e1930, (_e1930 > 0f));
                                let _e1934 = ((_e1924 + _e1928) + _e1932);
                                let _e1949 = ((min(min(_e1860[0][0], _e1860[1][0]), _e1860[2][0]) - _e625) * _e628);
                                let _e1950 = ((max(max(_e1860[0][0], _e1860[1][0]), _e1860[2][0]) - _e626) * _e628);
                                let _e1951 = vec4<f32>(_e1949, f32(), _e1950, f32());
                                let _e1954 = ((min(min(_e1860[0][1], _e1860[1][1]), _e1860[2][1]) - _e641) * _e644);
                                let _e1955 = ((max(max(_e1860[0][1], _e1860[1][1]), _e1860[2][1]) - _e642) * _e644);
                                let _e1956 = vec4<f32>(_e1954, f32(), _e1955, f32());
                                let _e1959 = ((min(min(_e1860[0][2], _e1860[1][2]), _e1860[2][2]) - _e657) * _e660);
                                let _e1960 = ((max(max(_e1860[0][2], _e1860[1][2]), _e1860[2][2]) - _e658) * _e660);
                                let _e1961 = vec4<f32>(_e1959, f32(), _e1960, f32());
                                let _e1962 = vec4<f32>(_e1950, f32(), _e1949, f32());
                                let _e1964 = vec4<f32>(_e1955, f32(), _e1954, f32());
                                let _e1966 = vec4<f32>(_e1960, f32(), _e1959, f32());
                                let _e1975 = max(max(min(_e1951, _e1962).x, min(_e1956, _e1964).x), min(_e1961, _e1966).x);
                                let _e1980 = min(min(max(_e1951, _e1962).x, max(_e1956, _e1964).x), max(_e1961, _e1966).x);
                                let _e1985 = max(_e1975, _e668);
                                let _e2007 = (((((_e1918 && (_e1934 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1880, _e1889), _e1898) <= 0f) && (max(max(_e1880, _e1889), _e1898) >= 0f))) && ((min(min(_e1883, _e1892), _e1901) <= 0f) && (max(max(_e1883, _e1892), _e1901) >= 0f))) && (_e1985 <= (_e1980 + (max(max(_e1961, _e1966).x, -(min(_e1961, _e1966).x)) * 0.0000019073523f)))) && (_e1985 <= _e1430.member.member_1));
                                if _e2007 {
                                    let _e2012 = (_e1860[1][0] - _e1860[0][0]);
                                    let _e2013 = (_e1860[1][1] - _e1860[0][1]);
                                    let _e2014 = (_e1860[1][2] - _e1860[0][2]);
                                    let _e2015 = vec3<f32>(_e2012, _e2013, _e2014);
                                    let _e2016 = (_e1860[2][0] - _e1860[1][0]);
                                    let _e2017 = (_e1860[2][1] - _e1860[1][1]);
                                    let _e2018 = (_e1860[2][2] - _e1860[1][2]);
                                    let _e2019 = vec3<f32>(_e2016, _e2017, _e2018);
                                    let _e2020 = (_e1860[0][0] - _e1860[2][0]);
                                    let _e2021 = (_e1860[0][1] - _e1860[2][1]);
                                    let _e2022 = (_e1860[0][2] - _e1860[2][2]);
                                    let _e2023 = vec3<f32>(_e2020, _e2021, _e2022);
                                    let _e2034 = max(max(bitcast<f32>((bitcast<u32>(_e2012) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2013) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2014) & 2147483647u)));
                                    let _e2045 = max(max(bitcast<f32>((bitcast<u32>(_e2016) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2017) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2018) & 2147483647u)));
                                    let _e2058 = max(max(_e2034, _e2045), max(max(bitcast<f32>((bitcast<u32>(_e2020) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2021) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2022) & 2147483647u))));
                                    if (_e2034 == _e2058) {
                                        phi_3836_ = _e1892;
                                        phi_3837_ = _e1889;
                                        phi_3838_ = _e1883;
                                        phi_3839_ = _e1880;
                                        phi_3840_ = vec3<f32>(_e1860[0][0], _e1860[0][1], _e1860[0][2]);
                                        phi_3841_ = _e2023;
                                        phi_3842_ = _e2019;
                                        phi_3843_ = _e2015;
                                    } else {
                                        let _e2060 = (_e2045 == _e2058);
                                        let _e2065 = vec3(_e2060);
                                        phi_3836_ = select(_e1883, _e1901, _e2060);
                                        phi_3837_ = select(_e1880, _e1898, _e2060);
                                        phi_3838_ = select(_e1901, _e1892, _e2060);
                                        phi_3839_ = select(_e1898, _e1889, _e2060);
                                        phi_3840_ = select(vec3<f32>(_e1860[2][0], _e1860[2][1], _e1860[2][2]), vec3<f32>(_e1860[1][0], _e1860[1][1], _e1860[1][2]), _e2065);
                                        phi_3841_ = select(_e2019, _e2015, _e2065);
                                        phi_3842_ = select(_e2015, _e2023, _e2065);
                                        phi_3843_ = select(_e2023, _e2019, _e2065);
                                    }
                                    let _e2071 = phi_3836_;
                                    let _e2073 = phi_3837_;
                                    let _e2075 = phi_3838_;
                                    let _e2077 = phi_3839_;
                                    let _e2079 = phi_3840_;
                                    let _e2081 = phi_3841_;
                                    let _e2083 = phi_3842_;
                                    let _e2085 = phi_3843_;
                                    let _e2092 = ((_e2083.y * _e2081.z) - (_e2081.y * _e2083.z));
                                    let _e2097 = ((_e2083.z * _e2081.x) - (_e2081.z * _e2083.x));
                                    let _e2100 = ((_e2083.x * _e2081.y) - (_e2081.x * _e2083.y));
                                    let _e2103 = ((_e1924 >= _e1928) && (_e1924 >= _e1932));
                                    let _e2104 = (_e1928 >= _e1932);
                                    let _e2118 = (((_e2092 * (select(select(_e1860[2][0], _e1860[1][0], _e2104), _e1860[0][0], _e2103) - _e601.member[0])) + (_e2097 * (select(select(_e1860[2][1], _e1860[1][1], _e2104), _e1860[0][1], _e2103) - _e601.member[1]))) + (_e2100 * (select(select(_e1860[2][2], _e1860[1][2], _e2104), _e1860[0][2], _e2103) - _e601.member[2])));
                                    let _e2123 = (((_e2092 * _e624) + (_e2097 * _e640)) + (_e2100 * _e656));
                                    let _e2124 = (_e2073 - _e2077);
                                    let _e2125 = (_e2071 - _e2075);
                                    let _e2128 = ((_e2124 * _e2124) + (_e2125 * _e2125));
                                    let _e2135 = (-(((_e2077 * _e2124) + (_e2075 * _e2125))) / select(0.000000000000000000000000000000000000011754944f, _e2128, (_e2128 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e2137 = select(1f, _e2135, (_e2135 < 1f));
                                    let _e2139 = select(0f, _e2137, (_e2137 > 0f));
                                    let _e2148 = ((_e2079.x + (_e2085.x * _e2139)) - _e601.member[0]);
                                    let _e2151 = ((_e2079.y + (_e2085.y * _e2139)) - _e601.member[1]);
                                    let _e2154 = ((_e2079.z + (_e2085.z * _e2139)) - _e601.member[2]);
                                    let _e2219 = ((bitcast<f32>((bitcast<u32>(((((_e2092 * _e2148) + (_e2097 * _e2151)) + (_e2100 * _e2154)) - _e2118)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e2148) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2151) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2154) & 2147483647u))), _e2058)) * max(max(bitcast<f32>((bitcast<u32>(_e2092) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2097) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2100) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e2123) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e2083.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2083.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2083.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e2081.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2081.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2081.z) & 2147483647u)))))));
                                    let _e2220 = (_e2118 / _e2123);
                                    if (_e2007 && !(_e2219)) {
                                        let _e2223 = (_e2154 / _e656);
                                        let _e2231 = (((_e2092 * (_e2148 - (_e624 * _e2223))) + (_e2097 * (_e2151 - (_e640 * _e2223)))) / _e2123);
                                        phi_4022_ = select(select(_e2223, (_e2223 + _e2231), (bitcast<f32>((bitcast<u32>(_e2231) & 2147483647u)) <= _e2058)), _e2220, _e2219);
                                    } else {
                                        phi_4022_ = _e2220;
                                    }
                                    let _e2240 = phi_4022_;
                                    let _e2242 = select(_e1980, _e2240, (_e2240 < _e1980));
                                    let _e2244 = select(_e1975, _e2242, (_e2242 > _e1975));
                                    let _e2247 = select(_e2244, 0f, (bitcast<u32>(_e2244) == 2147483648u));
                                    let _e2248 = (1f / _e1934);
                                    phi_4048_ = SlimbvhTypeE(_e2247, (_e1928 * _e2248), (_e1932 * _e2248), ((_e2007 && (_e2247 >= _e668)) && (_e2247 <= _e1430.member.member_1)));
                                    phi_4049_ = SlimbvhTypeE();
                                } else {
                                    phi_4048_ = SlimbvhTypeE();
                                    phi_4049_ = SlimbvhTypeE(0f, 0f, 0f, _e2007);
                                }
                                let _e2257 = phi_4048_;
                                let _e2259 = phi_4049_;
                                phi_4052_ = _e2257;
                                phi_4053_ = _e2259;
                                phi_4054_ = select(true, false, _e2007);
                            } else {
                                phi_4052_ = SlimbvhTypeE();
                                phi_4053_ = SlimbvhTypeE(0f, 0f, 0f, _e1918);
                                phi_4054_ = true;
                            }
                            let _e2262 = phi_4052_;
                            let _e2264 = phi_4053_;
                            let _e2266 = phi_4054_;
                            if _e2266 {
                                phi_4058_ = _e2264;
                            } else {
                                phi_4058_ = _e2262;
                            }
                            let _e2268 = phi_4058_;
                            if _e2268.member_3 {
                                phi_4067_ = SlimbvhTypeF(_e2268.member, _e2268.member_1, _e2268.member_2, _e1471);
                            } else {
                                phi_4067_ = _e100;
                            }
                            let _e2275 = phi_4067_;
                            if (_e2275.member_3 != 4294967295u) {
                                if (_e1471 != 4294967295u) {
                                    if (_e2275.member < _e1430.member.member.member) {
                                        phi_4095_ = true;
                                    } else {
                                        if (_e2275.member == _e1430.member.member.member) {
                                            phi_4094_ = (_e2275.member_3 < _e1430.member.member.member_3);
                                        } else {
                                            phi_4094_ = false;
                                        }
                                        let _e2290 = phi_4094_;
                                        phi_4095_ = _e2290;
                                    }
                                    let _e2292 = phi_4095_;
                                    if _e2292 {
                                        phi_4102_ = SlimbvhTypeP(SlimbvhTypeH(_e2275, _e2275.member), _e1430.member_1);
                                    } else {
                                        phi_4102_ = _e1430;
                                    }
                                    let _e2298 = phi_4102_;
                                    if _e2298.member_1 {
                                        phi_4108_ = SlimbvhTypeP(SlimbvhTypeH(_e2298.member.member, bitcast<f32>(4286578687u)), _e2298.member_1);
                                    } else {
                                        phi_4108_ = _e2298;
                                    }
                                    let _e2307 = phi_4108_;
                                    phi_4109_ = _e2307;
                                } else {
                                    phi_4109_ = _e1430;
                                }
                                let _e2309 = phi_4109_;
                                phi_4110_ = _e2309;
                            } else {
                                phi_4110_ = _e1430;
                            }
                            let _e2311 = phi_4110_;
                            phi_2791_ = _e2311;
                        } else {
                            phi_2791_ = SlimbvhTypeP();
                        }
                        let _e2313 = phi_2791_;
                        continue;
                        continuing {
                            phi_2790_ = _e2313;
                            phi_2793_ = _e1445;
                            break if !(_e1451);
                        }
                    }
                    let _e2316 = local_2;
                    let _e2317 = (_e2316 - 1u);
                    let _e2322 = slimbvh_stacks[(((_e2317 % 32u) * 64u) + _e672)];
                    let _e2323 = (_e2322 & 511u);
                    let _e2325 = (_e2323 >> bitcast<u32>(3u));
                    let _e2328 = ((_e2325 == 0u) || (_e2317 == 4294967295u));
                    if _e2328 {
                    } else {
                        slimbvh_stacks[(((_e2317 % 32u) * 64u) + _e672)] = (((_e2322 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2325);
                    }
                    let _e2335 = local_3;
                    let _e2343 = (((_e2322 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2323 & 3u) & 3u));
                    let _e2345 = (_e2343 >> bitcast<u32>(2i));
                    if (_e2345 < _e104) {
                        let _e2351 = slimbvh_nodes.member[_e2345].member_1[(_e2343 & 3u)];
                        if ((_e2351 & 2147483648u) != 0u) {
                            phi_4177_ = (2147483648u | _e2343);
                        } else {
                            phi_4177_ = _e2351;
                        }
                        let _e2356 = phi_4177_;
                        phi_4178_ = _e2356;
                    } else {
                        phi_4178_ = 4294967295u;
                    }
                    let _e2358 = phi_4178_;
                    let _e2360 = local_4;
                    let _e2659 = local_7;
                    phi_4187_ = _e2659;
                    phi_4188_ = select(select(_e2335, _e2317, _e2328), 4294967295u, (_e668 > _e2360.member.member_1));
                    phi_4189_ = _e2358;
                } else {
                    phi_4187_ = _e779;
                    let _e2662 = local_8;
                    phi_4188_ = _e2662;
                    let _e2665 = local_9;
                    phi_4189_ = _e2665;
                }
                let _e2366 = phi_4187_;
                let _e2368 = phi_4188_;
                let _e2370 = phi_4189_;
                phi_1685_ = _e2366;
                phi_1688_ = _e2368;
                phi_1690_ = _e2370;
                let _e2671 = local_10;
                phi_1692_ = _e2671;
            } else {
                phi_1685_ = SlimbvhTypeP();
                phi_1688_ = u32();
                phi_1690_ = u32();
                phi_1692_ = u32();
            }
            let _e2372 = phi_1685_;
            let _e2374 = phi_1688_;
            let _e2376 = phi_1690_;
            let _e2378 = phi_1692_;
            continue;
            continuing {
                phi_1684_ = _e2372;
                phi_1687_ = _e2374;
                phi_1689_ = _e2376;
                phi_1691_ = _e2378;
                break if !(_e786);
            }
        }
        let _e2381 = local_5;
        let _e2382 = (_e2381 == 4294967295u);
        let _e2384 = local_6;
        if (_e2384.member.member.member_3 != 4294967295u) {
            let _e2390 = -((_e171 + _e601.member_4));
            let _e2391 = bitcast<u32>(_e2384.member.member.member);
            let _e2395 = (bitcast<i32>((_e2391 >> bitcast<u32>(23i))) & 255i);
            let _e2396 = (_e2395 + _e2390);
            if (_e2395 == 255i) {
                phi_4247_ = _e2384.member.member.member;
            } else {
                if (_e2395 > 0i) {
                    if (_e2396 > 0i) {
                        let _e2400 = (_e2396 < 255i);
                        if _e2400 {
                            phi_4226_ = bitcast<f32>((_e2391 + bitcast<u32>((_e2390 << bitcast<u32>(23i)))));
                        } else {
                            phi_4226_ = f32();
                        }
                        let _e2407 = phi_4226_;
                        phi_4228_ = _e2407;
                        phi_4229_ = select(true, false, _e2400);
                    } else {
                        phi_4228_ = f32();
                        phi_4229_ = true;
                    }
                    let _e2410 = phi_4228_;
                    let _e2412 = phi_4229_;
                    phi_4230_ = _e2410;
                    phi_4231_ = _e2412;
                } else {
                    phi_4230_ = f32();
                    phi_4231_ = true;
                }
                let _e2414 = phi_4230_;
                let _e2416 = phi_4231_;
                if _e2416 {
                    let _e2417 = (_e2391 & 2147483648u);
                    let _e2424 = ((_e2391 & 8388607u) | (select(0u, 1u, ((_e2391 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e2428 = (_e2424 == 0u);
                    if _e2428 {
                        phi_4929_ = bitcast<f32>(_e2417);
                    } else {
                        let _e2433 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2424)), 32u, _e2428) - 8u);
                        let _e2436 = (_e2424 << bitcast<u32>((_e2433 & 31u)));
                        let _e2438 = ((_e2396 + select(0i, 1i, (_e2395 == 0i))) - bitcast<i32>(_e2433));
                        if (_e2438 >= 255i) {
                            phi_4919_ = bitcast<f32>((_e2417 | 2139095040u));
                            phi_4920_ = f32();
                            phi_4921_ = true;
                        } else {
                            let _e2440 = (_e2438 > 0i);
                            if _e2440 {
                                phi_4913_ = bitcast<f32>(((_e2417 | (bitcast<u32>(_e2438) << bitcast<u32>(23i))) | (_e2436 & 8388607u)));
                                phi_4914_ = f32();
                            } else {
                                if (_e2438 < -24i) {
                                    phi_4879_ = 26u;
                                } else {
                                    phi_4879_ = bitcast<u32>((1i - _e2438));
                                }
                                let _e2445 = phi_4879_;
                                let _e2446 = (_e2445 & 31u);
                                let _e2448 = (_e2436 >> bitcast<u32>(_e2446));
                                let _e2452 = (_e2436 & ((1u << bitcast<u32>(_e2446)) - 1u));
                                let _e2456 = (1u << bitcast<u32>(((_e2445 - 1u) & 31u)));
                                if (_e2452 > _e2456) {
                                    phi_4900_ = true;
                                } else {
                                    if (_e2452 == _e2456) {
                                        phi_4897_ = ((_e2448 & 1u) == 1u);
                                    } else {
                                        phi_4897_ = false;
                                    }
                                    let _e2462 = phi_4897_;
                                    phi_4900_ = _e2462;
                                }
                                let _e2464 = phi_4900_;
                                phi_4913_ = f32();
                                phi_4914_ = bitcast<f32>((_e2417 | (_e2448 + select(0u, 1u, _e2464))));
                            }
                            let _e2477 = phi_4913_;
                            let _e2479 = phi_4914_;
                            phi_4919_ = _e2477;
                            phi_4920_ = _e2479;
                            phi_4921_ = _e2440;
                        }
                        let _e2483 = phi_4919_;
                        let _e2485 = phi_4920_;
                        let _e2487 = phi_4921_;
                        phi_4929_ = select(_e2485, _e2483, _e2487);
                    }
                    let _e2491 = phi_4929_;
                    phi_4246_ = _e2491;
                } else {
                    phi_4246_ = _e2414;
                }
                let _e2493 = phi_4246_;
                phi_4247_ = _e2493;
            }
            let _e2495 = phi_4247_;
            let _e2496 = bitcast<u32>(_e2495);
            if ((_e2496 & 2147483647u) >= 2139095040u) {
                phi_4259_ = bitcast<f32>(((_e2496 & 2147483648u) | 2139095039u));
            } else {
                phi_4259_ = _e2495;
            }
            let _e2503 = phi_4259_;
            phi_4264_ = SlimbvhTypeF(_e2503, _e2384.member.member.member_1, _e2384.member.member.member_2, _e2384.member.member.member_3);
        } else {
            phi_4264_ = _e100;
        }
        let _e2508 = phi_4264_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2508.member), bitcast<u32>(_e2508.member_1), bitcast<u32>(_e2508.member_2), _e2508.member_3);
        phi_4277_ = _e2382;
        phi_4278_ = _e2382;
        phi_4279_ = select(true, false, _e2382);
    } else {
        phi_4277_ = bool();
        phi_4278_ = false;
        phi_4279_ = true;
    }
    let _e2519 = phi_4277_;
    let _e2521 = phi_4278_;
    let _e2523 = phi_4279_;
    if _e2523 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e2519, _e2521, _e2523)));
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
