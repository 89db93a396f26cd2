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
    var phi_568_: u32;
    var phi_574_: u32;
    var phi_580_: u32;
    var phi_845_: i32;
    var phi_856_: i32;
    var phi_970_: i32;
    var phi_1099_: i32;
    var phi_1121_: u32;
    var phi_1122_: u32;
    var phi_1123_: bool;
    var phi_1157_: i32;
    var phi_1179_: u32;
    var phi_1180_: u32;
    var phi_1181_: bool;
    var phi_742_: i32;
    var phi_748_: u32;
    var phi_767_: u32;
    var phi_768_: u32;
    var phi_769_: bool;
    var phi_787_: i32;
    var phi_793_: u32;
    var phi_812_: u32;
    var phi_813_: u32;
    var phi_814_: bool;
    var phi_1191_: SlimbvhTypeC;
    var phi_1427_: SlimbvhTypeP;
    var phi_1490_: array<f32, 3>;
    var phi_1491_: array<f32, 3>;
    var phi_1509_: array<f32, 3>;
    var phi_1510_: array<f32, 3>;
    var phi_1683_: SlimbvhTypeP;
    var phi_1686_: u32;
    var phi_1688_: u32;
    var phi_1690_: u32;
    var phi_1699_: u32;
    var phi_1702_: u32;
    var phi_1704_: u32;
    var phi_1800_: SlimbvhTypeK;
    var phi_1801_: SlimbvhTypeK;
    var phi_1846_: SlimbvhTypeK;
    var phi_1847_: SlimbvhTypeK;
    var phi_1892_: SlimbvhTypeK;
    var phi_1893_: SlimbvhTypeK;
    var phi_2369_: u32;
    var phi_2382_: u32;
    var phi_2395_: u32;
    var phi_2408_: u32;
    var phi_4611_: SlimbvhTypeD;
    var phi_4623_: SlimbvhTypeD;
    var phi_4635_: SlimbvhTypeD;
    var phi_4647_: SlimbvhTypeD;
    var phi_4659_: SlimbvhTypeD;
    var phi_2492_: u32;
    var phi_2497_: u32;
    var phi_2498_: u32;
    var phi_2527_: u32;
    var phi_2534_: u32;
    var phi_2535_: u32;
    var phi_1700_: u32;
    var phi_1703_: u32;
    var phi_1705_: u32;
    var local: bool;
    var local_1: u32;
    var phi_2690_: u32;
    var phi_2751_: u32;
    var phi_2759_: u32;
    var phi_2762_: SlimbvhTypeM;
    var phi_2766_: SlimbvhTypeP;
    var phi_2769_: SlimbvhTypeD;
    var phi_2770_: SlimbvhTypeD;
    var phi_2792_: SlimbvhTypeD;
    var phi_2809_: u32;
    var phi_2820_: u32;
    var phi_2836_: u32;
    var phi_2851_: u32;
    var phi_3316_: u32;
    var phi_3334_: u32;
    var phi_3352_: u32;
    var phi_3375_: u32;
    var phi_3393_: u32;
    var phi_3411_: u32;
    var phi_3434_: u32;
    var phi_3452_: u32;
    var phi_3470_: u32;
    var phi_3024_: u32;
    var phi_3039_: u32;
    var phi_3049_: u32;
    var phi_3070_: u32;
    var phi_3091_: u32;
    var phi_3121_: u32;
    var phi_3136_: u32;
    var phi_3146_: u32;
    var phi_3167_: u32;
    var phi_3188_: u32;
    var phi_3218_: u32;
    var phi_3233_: u32;
    var phi_3243_: u32;
    var phi_3264_: u32;
    var phi_3285_: u32;
    var phi_2877_: u32;
    var phi_2926_: u32;
    var phi_2975_: u32;
    var phi_3476_: array<array<f32, 3>, 3>;
    var phi_3841_: f32;
    var phi_3842_: f32;
    var phi_3843_: f32;
    var phi_3844_: f32;
    var phi_3845_: vec3<f32>;
    var phi_3846_: vec3<f32>;
    var phi_3847_: vec3<f32>;
    var phi_3848_: vec3<f32>;
    var phi_4027_: f32;
    var phi_4053_: SlimbvhTypeE;
    var phi_4054_: SlimbvhTypeE;
    var phi_4057_: SlimbvhTypeE;
    var phi_4058_: SlimbvhTypeE;
    var phi_4059_: bool;
    var phi_4063_: SlimbvhTypeE;
    var phi_4072_: SlimbvhTypeF;
    var phi_4099_: bool;
    var phi_4100_: bool;
    var phi_4107_: SlimbvhTypeP;
    var phi_4113_: SlimbvhTypeP;
    var phi_4114_: SlimbvhTypeP;
    var phi_4115_: SlimbvhTypeP;
    var phi_2767_: SlimbvhTypeP;
    var local_2: u32;
    var local_3: u32;
    var phi_4181_: u32;
    var phi_4188_: u32;
    var phi_4189_: u32;
    var local_4: SlimbvhTypeP;
    var phi_4198_: SlimbvhTypeP;
    var phi_4199_: u32;
    var phi_4200_: u32;
    var phi_1684_: SlimbvhTypeP;
    var phi_1687_: u32;
    var phi_1689_: u32;
    var phi_1691_: u32;
    var local_5: u32;
    var local_6: SlimbvhTypeP;
    var phi_4237_: f32;
    var phi_4239_: f32;
    var phi_4240_: bool;
    var phi_4241_: f32;
    var phi_4242_: bool;
    var phi_4890_: u32;
    var phi_4908_: bool;
    var phi_4911_: bool;
    var phi_4924_: f32;
    var phi_4925_: f32;
    var phi_4930_: f32;
    var phi_4931_: f32;
    var phi_4932_: bool;
    var phi_4940_: f32;
    var phi_4257_: f32;
    var phi_4258_: f32;
    var phi_4270_: f32;
    var phi_4275_: SlimbvhTypeF;
    var phi_4288_: bool;
    var phi_4289_: bool;
    var phi_4290_: bool;
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
        phi_568_ = 0u;
    } else {
        phi_568_ = select(2u, 1u, (_e183 == _e191));
    }
    let _e209 = phi_568_;
    let _e210 = (_e209 == 2u);
    if _e210 {
        phi_574_ = 0u;
    } else {
        phi_574_ = (_e209 + 1u);
    }
    let _e213 = phi_574_;
    let _e214 = (_e213 == 2u);
    if _e214 {
        phi_580_ = 0u;
    } else {
        phi_580_ = (_e213 + 1u);
    }
    let _e217 = phi_580_;
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
            phi_742_ = 255i;
        } else {
            phi_742_ = (bitcast<i32>((_e179 >> bitcast<u32>(23i))) + _e520);
        }
        let _e545 = phi_742_;
        if (_e179 == 0u) {
            phi_748_ = 0u;
        } else {
            phi_748_ = (_e179 | 8388608u);
        }
        let _e549 = phi_748_;
        if (_e545 <= 0i) {
            phi_768_ = u32();
            phi_769_ = true;
        } else {
            let _e556 = (_e549 == 0u);
            if _e556 {
                phi_767_ = u32();
            } else {
                phi_767_ = select(((bitcast<u32>(_e545) << bitcast<u32>(23i)) | (_e549 & 8388607u)), 2139095039u, (_e545 >= 255i));
            }
            let _e560 = phi_767_;
            phi_768_ = _e560;
            phi_769_ = _e556;
        }
        let _e562 = phi_768_;
        let _e564 = phi_769_;
        if (_e187 >= 2139095040u) {
            phi_787_ = 255i;
        } else {
            phi_787_ = (bitcast<i32>((_e187 >> bitcast<u32>(23i))) + _e520);
        }
        let _e575 = phi_787_;
        if (_e187 == 0u) {
            phi_793_ = 0u;
        } else {
            phi_793_ = (_e187 | 8388608u);
        }
        let _e579 = phi_793_;
        if (_e575 <= 0i) {
            phi_813_ = u32();
            phi_814_ = true;
        } else {
            let _e586 = (_e579 == 0u);
            if _e586 {
                phi_812_ = u32();
            } else {
                phi_812_ = select(((bitcast<u32>(_e575) << bitcast<u32>(23i)) | (_e579 & 8388607u)), 2139095039u, (_e575 >= 255i));
            }
            let _e590 = phi_812_;
            phi_813_ = _e590;
            phi_814_ = _e586;
        }
        let _e592 = phi_813_;
        let _e594 = phi_814_;
        phi_1191_ = SlimbvhTypeC(array<f32, 3>((_e220 * _e525), (_e224 * _e525), (_e227 * _e525)), array<f32, 3>((_e229 * _e530), (_e231 * _e530), (_e233 * _e530)), bitcast<f32>(((_e178 & 2147483648u) | select(_e562, 0u, _e564))), bitcast<f32>(((_e186 & 2147483648u) | select(_e592, 0u, _e594))), _e519);
    } else {
        let _e266 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e191, _e204))) & 2147483647u);
        if (_e266 >= 8388608u) {
            phi_845_ = (bitcast<i32>((_e266 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_845_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e266)), 32u, (_e266 == 0u))));
        }
        let _e280 = phi_845_;
        let _e281 = (_e171 + _e280);
        if (_e171 < -126i) {
            phi_856_ = -126i;
        } else {
            phi_856_ = select(_e171, 127i, (_e171 > 127i));
        }
        let _e286 = phi_856_;
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
            phi_970_ = -126i;
        } else {
            phi_970_ = select(_e350, 127i, (_e350 > 127i));
        }
        let _e355 = phi_970_;
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
            phi_1099_ = 255i;
        } else {
            phi_1099_ = (((_e428 + select(0i, 1i, (_e428 == 0i))) - _e435) + _e281);
        }
        let _e443 = phi_1099_;
        let _e447 = (_e425 << bitcast<u32>(((_e435 & 31i) & 31i)));
        if (_e443 <= 0i) {
            phi_1122_ = u32();
            phi_1123_ = true;
        } else {
            let _e454 = (_e447 == 0u);
            if _e454 {
                phi_1121_ = u32();
            } else {
                phi_1121_ = select(((bitcast<u32>(_e443) << bitcast<u32>(23i)) | (_e447 & 8388607u)), 2139095039u, (_e443 >= 255i));
            }
            let _e458 = phi_1121_;
            phi_1122_ = _e458;
            phi_1123_ = _e454;
        }
        let _e460 = phi_1122_;
        let _e462 = phi_1123_;
        let _e473 = ((_e187 & 8388607u) | (select(0u, 1u, ((_e187 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e476 = bitcast<i32>((_e187 >> bitcast<u32>(23i)));
        let _e483 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e473)), 32u, (_e473 == 0u))) - 8i);
        if (_e476 == 255i) {
            phi_1157_ = 255i;
        } else {
            phi_1157_ = (((_e476 + select(0i, 1i, (_e476 == 0i))) - _e483) + _e281);
        }
        let _e491 = phi_1157_;
        let _e495 = (_e473 << bitcast<u32>(((_e483 & 31i) & 31i)));
        if (_e491 <= 0i) {
            phi_1180_ = u32();
            phi_1181_ = true;
        } else {
            let _e502 = (_e495 == 0u);
            if _e502 {
                phi_1179_ = u32();
            } else {
                phi_1179_ = select(((bitcast<u32>(_e491) << bitcast<u32>(23i)) | (_e495 & 8388607u)), 2139095039u, (_e491 >= 255i));
            }
            let _e506 = phi_1179_;
            phi_1180_ = _e506;
            phi_1181_ = _e502;
        }
        let _e508 = phi_1180_;
        let _e510 = phi_1181_;
        phi_1191_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e298 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e298 & 2147483648u))), _e220, _e300) * _e291) * select(0.00000011920929f, 1f, _e300)) * _e297), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e224, _e317) * _e291) * select(0.00000011920929f, 1f, _e317)) * _e297), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e332 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e332 & 2147483648u))), _e227, _e334) * _e291) * select(0.00000011920929f, 1f, _e334)) * _e297)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e367 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e367 & 2147483648u))), _e229, _e369) * _e360) * select(0.00000011920929f, 1f, _e369)) * _e366), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e231, _e386) * _e360) * select(0.00000011920929f, 1f, _e386)) * _e366), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e401 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e401 & 2147483648u))), _e233, _e403) * _e360) * select(0.00000011920929f, 1f, _e403)) * _e366)), bitcast<f32>(((_e178 & 2147483648u) | select(_e460, 0u, _e462))), bitcast<f32>(((_e186 & 2147483648u) | select(_e508, 0u, _e510))), _e280);
    }
    let _e601 = phi_1191_;
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
            phi_1427_ = SlimbvhTypeP(SlimbvhTypeH(_e100, _e667), true);
        } else {
            phi_1427_ = SlimbvhTypeP(SlimbvhTypeH(_e100, _e667), false);
        }
        let _e680 = phi_1427_;
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
            phi_1491_ = array<f32, 3>(_e700, _e702, _e704);
        } else {
            if (_e685 == 1u) {
                phi_1490_ = array<f32, 3>(_e702, _e704, _e700);
            } else {
                phi_1490_ = array<f32, 3>(_e704, _e700, _e702);
            }
            let _e710 = phi_1490_;
            phi_1491_ = _e710;
        }
        let _e713 = phi_1491_;
        let _e715 = (f32(bitcast<i32>(_e133)) * _e153);
        let _e717 = (f32(bitcast<i32>(_e137)) * _e153);
        let _e719 = (f32(bitcast<i32>(_e141)) * _e153);
        if _e705 {
            phi_1510_ = array<f32, 3>(_e715, _e717, _e719);
        } else {
            if (_e685 == 1u) {
                phi_1509_ = array<f32, 3>(_e717, _e719, _e715);
            } else {
                phi_1509_ = array<f32, 3>(_e719, _e715, _e717);
            }
            let _e724 = phi_1509_;
            phi_1510_ = _e724;
        }
        let _e727 = phi_1510_;
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
        phi_1683_ = _e680;
        phi_1686_ = select(4294967295u, select(4294967295u, 0u, (_e668 <= _e667)), (max(max(max(min(_e740, _e751).x, min(_e745, _e753).x), min(_e750, _e755).x), _e668) <= min((min(min(max(_e740, _e751).x, max(_e745, _e753).x), max(_e750, _e755).x) + (max(max(_e750, _e755).x, -(min(_e750, _e755).x)) * 0.0000019073523f)), _e680.member.member_1)));
        phi_1688_ = select(0u, 4294967295u, (_e104 == 0u));
        phi_1690_ = (_e104 + 1u);
        loop {
            let _e779 = phi_1683_;
            let _e781 = phi_1686_;
            let _e783 = phi_1688_;
            let _e785 = phi_1690_;
            local_5 = _e781;
            local_6 = _e779;
            let _e786 = (_e781 <= 32u);
            if _e786 {
                phi_1699_ = _e781;
                phi_1702_ = _e783;
                phi_1704_ = _e785;
                loop {
                    let _e788 = phi_1699_;
                    let _e790 = phi_1702_;
                    let _e792 = phi_1704_;
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
                            phi_1800_ = SlimbvhTypeK(_e802.z, _e827);
                            phi_1801_ = SlimbvhTypeK(_e802.y, _e822);
                        } else {
                            phi_1800_ = SlimbvhTypeK(_e802.y, _e822);
                            phi_1801_ = SlimbvhTypeK(_e802.z, _e827);
                        }
                        let _e838 = phi_1800_;
                        let _e840 = phi_1801_;
                        let _e844 = bitcast<f32>(((_e817 + ((_e802.w & 31u) << bitcast<u32>(23i))) ^ (_e690 << bitcast<u32>(31i))));
                        let _e884 = bitcast<f32>(_e808.x);
                        let _e889 = (_e884 + (f32((_e808.w >> bitcast<u32>(5u))) * _e153));
                        if (_e693 == 0u) {
                            phi_1846_ = SlimbvhTypeK(_e808.z, _e889);
                            phi_1847_ = SlimbvhTypeK(_e808.y, _e884);
                        } else {
                            phi_1846_ = SlimbvhTypeK(_e808.y, _e884);
                            phi_1847_ = SlimbvhTypeK(_e808.z, _e889);
                        }
                        let _e900 = phi_1846_;
                        let _e902 = phi_1847_;
                        let _e906 = bitcast<f32>(((_e817 + ((_e808.w & 31u) << bitcast<u32>(23i))) ^ (_e693 << bitcast<u32>(31i))));
                        let _e946 = bitcast<f32>(_e814.x);
                        let _e951 = (_e946 + (f32((_e814.w >> bitcast<u32>(5u))) * _e153));
                        if (_e696 == 0u) {
                            phi_1892_ = SlimbvhTypeK(_e814.z, _e951);
                            phi_1893_ = SlimbvhTypeK(_e814.y, _e946);
                        } else {
                            phi_1892_ = SlimbvhTypeK(_e814.y, _e946);
                            phi_1893_ = SlimbvhTypeK(_e814.z, _e951);
                        }
                        let _e962 = phi_1892_;
                        let _e964 = phi_1893_;
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
                            phi_2369_ = (((bitcast<u32>(_e1132) ^ select(0u, 4294967288u, _e680.member_1)) & 2147483640u) | 4u);
                        } else {
                            phi_2369_ = 4294967288u;
                        }
                        let _e1155 = phi_2369_;
                        if (_e1133 <= min((min(min(((f32(((_e838.member >> bitcast<u32>(8u)) & 255u)) * _e1020) + _e1027), ((f32(((_e900.member >> bitcast<u32>(8u)) & 255u)) * _e1052) + _e1059)), _e1097) + (max(_e1097, -(_e1081)) * 0.0000023841915f)), _e1140)) {
                            phi_2382_ = ((((bitcast<u32>(_e1133) ^ select(0u, 4294967288u, _e680.member_1)) & 2147483640u) | 4u) | 1u);
                        } else {
                            phi_2382_ = 4294967288u;
                        }
                        let _e1163 = phi_2382_;
                        if (_e1134 <= min((min(min(((f32(((_e838.member >> bitcast<u32>(16u)) & 255u)) * _e1020) + _e1027), ((f32(((_e900.member >> bitcast<u32>(16u)) & 255u)) * _e1052) + _e1059)), _e1098) + (max(_e1098, -(_e1082)) * 0.0000023841915f)), _e1140)) {
                            phi_2395_ = ((((bitcast<u32>(_e1134) ^ select(0u, 4294967288u, _e680.member_1)) & 2147483640u) | 4u) | 2u);
                        } else {
                            phi_2395_ = 4294967288u;
                        }
                        let _e1171 = phi_2395_;
                        if (_e1135 <= min((min(min(((f32(((_e838.member >> bitcast<u32>(24u)) & 255u)) * _e1020) + _e1027), ((f32(((_e900.member >> bitcast<u32>(24u)) & 255u)) * _e1052) + _e1059)), _e1099) + (max(_e1099, -(_e1083)) * 0.0000023841915f)), _e1140)) {
                            phi_2408_ = ((((bitcast<u32>(_e1135) ^ select(0u, 4294967288u, _e680.member_1)) & 2147483640u) | 4u) | 3u);
                        } else {
                            phi_2408_ = 4294967288u;
                        }
                        let _e1179 = phi_2408_;
                        if (_e1155 < _e1163) {
                            phi_4611_ = SlimbvhTypeD(_e1155, _e1163);
                        } else {
                            phi_4611_ = SlimbvhTypeD(_e1163, _e1155);
                        }
                        let _e1184 = phi_4611_;
                        if (_e1171 < _e1179) {
                            phi_4623_ = SlimbvhTypeD(_e1171, _e1179);
                        } else {
                            phi_4623_ = SlimbvhTypeD(_e1179, _e1171);
                        }
                        let _e1191 = phi_4623_;
                        if (_e1184.member < _e1191.member) {
                            phi_4635_ = SlimbvhTypeD(_e1184.member, _e1191.member);
                        } else {
                            phi_4635_ = SlimbvhTypeD(_e1191.member, _e1184.member);
                        }
                        let _e1198 = phi_4635_;
                        if (_e1184.member_1 < _e1191.member_1) {
                            phi_4647_ = SlimbvhTypeD(_e1184.member_1, _e1191.member_1);
                        } else {
                            phi_4647_ = SlimbvhTypeD(_e1191.member_1, _e1184.member_1);
                        }
                        let _e1205 = phi_4647_;
                        if (_e1205.member < _e1198.member_1) {
                            phi_4659_ = SlimbvhTypeD(_e1205.member, _e1198.member_1);
                        } else {
                            phi_4659_ = SlimbvhTypeD(_e1198.member_1, _e1205.member);
                        }
                        let _e1212 = phi_4659_;
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
                            phi_2497_ = select(_e788, _e1247, _e1258);
                            phi_2498_ = (((_e1252 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1253 & 3u) & 3u));
                        } else {
                            let _e1230 = (_e1227 >> bitcast<u32>(3u));
                            if (_e1230 == 0u) {
                                phi_2492_ = _e788;
                            } else {
                                slimbvh_stacks[(((_e788 % 32u) * 64u) + _e672)] = ((_e790 << bitcast<u32>(9u)) | _e1230);
                                phi_2492_ = (_e788 + 1u);
                            }
                            let _e1241 = phi_2492_;
                            phi_2497_ = _e1241;
                            phi_2498_ = ((_e790 << bitcast<u32>(2i)) | ((_e1227 & 3u) & 3u));
                        }
                        let _e1273 = phi_2497_;
                        let _e1275 = phi_2498_;
                        let _e1277 = (_e1275 >> bitcast<u32>(2i));
                        if (_e1277 >= _e104) {
                            phi_2535_ = 4294967295u;
                        } else {
                            if (_e1277 < _e104) {
                                let _e1284 = slimbvh_nodes.member[_e1277].member_1[(_e1275 & 3u)];
                                phi_2527_ = _e1284;
                            } else {
                                phi_2527_ = 2147483648u;
                            }
                            let _e1286 = phi_2527_;
                            if ((_e1286 & 2147483648u) != 0u) {
                                phi_2534_ = (2147483648u | _e1275);
                            } else {
                                phi_2534_ = _e1286;
                            }
                            let _e1291 = phi_2534_;
                            phi_2535_ = _e1291;
                        }
                        let _e1293 = phi_2535_;
                        let _e1294 = (_e792 - 1u);
                        phi_1700_ = select(_e1273, 4294967295u, (_e1294 == 0u));
                        phi_1703_ = _e1293;
                        phi_1705_ = _e1294;
                    } else {
                        phi_1700_ = u32();
                        phi_1703_ = u32();
                        phi_1705_ = u32();
                    }
                    let _e1298 = phi_1700_;
                    let _e1300 = phi_1703_;
                    let _e1302 = phi_1705_;
                    continue;
                    continuing {
                        phi_1699_ = _e1298;
                        phi_1702_ = _e1300;
                        phi_1704_ = _e1302;
                        break if !(_e796);
                    }
                }
                let _e1305 = local;
                if _e1305 {
                    let _e1307 = local_1;
                    let _e1308 = (_e1307 & 2147483647u);
                    let _e1310 = (_e1308 >> bitcast<u32>(2i));
                    if (_e1310 >= _e104) {
                        phi_2762_ = SlimbvhTypeM(SlimbvhTypeL(vec4<f32>(0f, 0f, 0f, 0f), 0u), 0u, 0u);
                    } else {
                        let _e1317 = slimbvh_nodes.member[_e1310].member[select(_e685, 2u, (2u < _e685))];
                        let _e1328 = slimbvh_nodes.member[_e1310].member[select(_e686, 2u, (2u < _e686))];
                        let _e1339 = slimbvh_nodes.member[_e1310].member[select(_e687, 2u, (2u < _e687))];
                        let _e1345 = (_e1308 & 3u);
                        let _e1348 = (((8u * _e1345) & 31u) & 31u);
                        let _e1356 = ((_e1317.w & 31u) & 31u);
                        let _e1358 = (((_e1317.y >> bitcast<u32>(_e1348)) & 255u) << bitcast<u32>(_e1356));
                        let _e1372 = ((_e1328.w & 31u) & 31u);
                        let _e1374 = (((_e1328.y >> bitcast<u32>(_e1348)) & 255u) << bitcast<u32>(_e1372));
                        let _e1388 = ((_e1339.w & 31u) & 31u);
                        let _e1390 = (((_e1339.y >> bitcast<u32>(_e1348)) & 255u) << bitcast<u32>(_e1388));
                        let _e1398 = (((((_e1317.w >> bitcast<u32>(5u)) - (((_e1317.z >> bitcast<u32>(_e1348)) & 255u) << bitcast<u32>(_e1356))) - _e1358) | (((_e1328.w >> bitcast<u32>(5u)) - (((_e1328.z >> bitcast<u32>(_e1348)) & 255u) << bitcast<u32>(_e1372))) - _e1374)) | (((_e1339.w >> bitcast<u32>(5u)) - (((_e1339.z >> bitcast<u32>(_e1348)) & 255u) << bitcast<u32>(_e1388))) - _e1390));
                        if (_e1398 < 1024u) {
                            phi_2690_ = 0u;
                        } else {
                            phi_2690_ = select(2u, 1u, (_e1398 < 2097152u));
                        }
                        let _e1403 = phi_2690_;
                        if (_e1310 < _e104) {
                            let _e1419 = slimbvh_nodes.member[_e1310].member_1[_e1345];
                            phi_2751_ = _e1419;
                        } else {
                            phi_2751_ = 2147483648u;
                        }
                        let _e1421 = phi_2751_;
                        if ((_e1421 & 2147483648u) != 0u) {
                            phi_2759_ = ((_e1421 >> bitcast<u32>(28u)) & 7u);
                        } else {
                            phi_2759_ = 0u;
                        }
                        let _e1428 = phi_2759_;
                        phi_2762_ = SlimbvhTypeM(SlimbvhTypeL(vec4<f32>((bitcast<f32>(_e1317.x) + (f32(_e1358) * _e153)), (bitcast<f32>(_e1328.x) + (f32(_e1374) * _e153)), (bitcast<f32>(_e1339.x) + (f32(_e1390) * _e153)), 0f), _e1403), (_e1421 & 268435455u), _e1428);
                    }
                    let _e1432 = phi_2762_;
                    phi_2766_ = _e779;
                    phi_2769_ = SlimbvhTypeD(0u, _e1432.member_2);
                    loop {
                        let _e1436 = phi_2766_;
                        let _e1438 = phi_2769_;
                        local_4 = _e1436;
                        local_7 = _e1436;
                        if (_e1438.member < _e1438.member_1) {
                            phi_2770_ = SlimbvhTypeD((_e1438.member + 1u), _e1438.member_1);
                            phi_2792_ = SlimbvhTypeD(1u, _e1438.member);
                        } else {
                            phi_2770_ = _e1438;
                            phi_2792_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                        }
                        let _e1451 = phi_2770_;
                        let _e1453 = phi_2792_;
                        let _e1457 = (bitcast<i32>(_e1453.member) != 0i);
                        if _e1457 {
                            switch bitcast<i32>(_e1432.member.member_1) {
                                case 0: {
                                    phi_2809_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2809_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2809_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2809_ = u32();
                                    break;
                                }
                            }
                            let _e1463 = phi_2809_;
                            switch bitcast<i32>(_e1432.member.member_1) {
                                case 0: {
                                    phi_2820_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2820_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2820_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2820_ = u32();
                                    break;
                                }
                            }
                            let _e1470 = phi_2820_;
                            let _e1472 = ((_e1432.member_1 + (_e1453.member_1 * ((3u * _e1463) + 1u))) + (3u * _e1470));
                            if (_e1472 < _e107) {
                                let _e1475 = slimbvh_triangles.member[_e1472];
                                phi_2836_ = _e1475;
                            } else {
                                phi_2836_ = 4294967295u;
                            }
                            let _e1477 = phi_2836_;
                            switch bitcast<i32>(_e1432.member.member_1) {
                                case 0: {
                                    phi_2851_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2851_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2851_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2851_ = u32();
                                    break;
                                }
                            }
                            let _e1481 = phi_2851_;
                            let _e1485 = (_e1432.member_1 + (_e1453.member_1 * ((3u * _e1481) + 1u)));
                            switch bitcast<i32>(_e1432.member.member_1) {
                                case 0: {
                                    if (_e1485 < _e107) {
                                        let _e1765 = slimbvh_triangles.member[_e1485];
                                        phi_2877_ = _e1765;
                                    } else {
                                        phi_2877_ = 0u;
                                    }
                                    let _e1767 = phi_2877_;
                                    let _e1770 = ((10u * _e213) & 31u);
                                    let _e1781 = ((10u * _e217) & 31u);
                                    let _e1792 = ((10u * _e209) & 31u);
                                    let _e1802 = (_e1485 + 1u);
                                    if (_e1802 < _e107) {
                                        let _e1805 = slimbvh_triangles.member[_e1802];
                                        phi_2926_ = _e1805;
                                    } else {
                                        phi_2926_ = 0u;
                                    }
                                    let _e1807 = phi_2926_;
                                    let _e1833 = (_e1485 + 2u);
                                    if (_e1833 < _e107) {
                                        let _e1836 = slimbvh_triangles.member[_e1833];
                                        phi_2975_ = _e1836;
                                    } else {
                                        phi_2975_ = 0u;
                                    }
                                    let _e1838 = phi_2975_;
                                    phi_3476_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1432.member.member.x + ((bitcast<f32>((1258291200u | ((_e1767 >> bitcast<u32>(_e1770)) & 1023u))) - 8388608f) * _e153)), (_e1432.member.member.y + ((bitcast<f32>((1258291200u | ((_e1767 >> bitcast<u32>(_e1781)) & 1023u))) - 8388608f) * _e153)), (_e1432.member.member.z + ((bitcast<f32>((1258291200u | ((_e1767 >> bitcast<u32>(_e1792)) & 1023u))) - 8388608f) * _e153))), array<f32, 3>((_e1432.member.member.x + ((bitcast<f32>((1258291200u | ((_e1807 >> bitcast<u32>(_e1770)) & 1023u))) - 8388608f) * _e153)), (_e1432.member.member.y + ((bitcast<f32>((1258291200u | ((_e1807 >> bitcast<u32>(_e1781)) & 1023u))) - 8388608f) * _e153)), (_e1432.member.member.z + ((bitcast<f32>((1258291200u | ((_e1807 >> bitcast<u32>(_e1792)) & 1023u))) - 8388608f) * _e153))), array<f32, 3>((_e1432.member.member.x + ((bitcast<f32>((1258291200u | ((_e1838 >> bitcast<u32>(_e1770)) & 1023u))) - 8388608f) * _e153)), (_e1432.member.member.y + ((bitcast<f32>((1258291200u | ((_e1838 >> bitcast<u32>(_e1781)) & 1023u))) - 8388608f) * _e153)), (_e1432.member.member.z + ((bitcast<f32>((1258291200u | ((_e1838 >> bitcast<u32>(_e1792)) & 1023u))) - 8388608f) * _e153))));
                                    break;
                                }
                                case 1: {
                                    if (_e1485 < _e107) {
                                        let _e1576 = slimbvh_triangles.member[_e1485];
                                        phi_3024_ = _e1576;
                                    } else {
                                        phi_3024_ = 0u;
                                    }
                                    let _e1578 = phi_3024_;
                                    let _e1579 = (_e1485 + 1u);
                                    if (_e1579 < _e107) {
                                        let _e1582 = slimbvh_triangles.member[_e1579];
                                        phi_3039_ = _e1582;
                                    } else {
                                        phi_3039_ = 0u;
                                    }
                                    let _e1584 = phi_3039_;
                                    let _e1586 = (_e213 == 1u);
                                    if _e1586 {
                                        phi_3049_ = ((_e1578 >> bitcast<u32>(21i)) | (_e1584 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3049_ = (_e1584 >> bitcast<u32>(10i));
                                    }
                                    let _e1595 = phi_3049_;
                                    let _e1604 = (_e217 == 1u);
                                    if _e1604 {
                                        phi_3070_ = ((_e1578 >> bitcast<u32>(21i)) | (_e1584 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3070_ = (_e1584 >> bitcast<u32>(10i));
                                    }
                                    let _e1613 = phi_3070_;
                                    let _e1622 = (_e209 == 1u);
                                    if _e1622 {
                                        phi_3091_ = ((_e1578 >> bitcast<u32>(21i)) | (_e1584 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3091_ = (_e1584 >> bitcast<u32>(10i));
                                    }
                                    let _e1631 = phi_3091_;
                                    let _e1640 = (_e1485 + 2u);
                                    if (_e1640 < _e107) {
                                        let _e1643 = slimbvh_triangles.member[_e1640];
                                        phi_3121_ = _e1643;
                                    } else {
                                        phi_3121_ = 0u;
                                    }
                                    let _e1645 = phi_3121_;
                                    let _e1646 = (_e1485 + 3u);
                                    if (_e1646 < _e107) {
                                        let _e1649 = slimbvh_triangles.member[_e1646];
                                        phi_3136_ = _e1649;
                                    } else {
                                        phi_3136_ = 0u;
                                    }
                                    let _e1651 = phi_3136_;
                                    if _e1586 {
                                        phi_3146_ = ((_e1645 >> bitcast<u32>(21i)) | (_e1651 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3146_ = (_e1651 >> bitcast<u32>(10i));
                                    }
                                    let _e1660 = phi_3146_;
                                    if _e1604 {
                                        phi_3167_ = ((_e1645 >> bitcast<u32>(21i)) | (_e1651 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3167_ = (_e1651 >> bitcast<u32>(10i));
                                    }
                                    let _e1676 = phi_3167_;
                                    if _e1622 {
                                        phi_3188_ = ((_e1645 >> bitcast<u32>(21i)) | (_e1651 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3188_ = (_e1651 >> bitcast<u32>(10i));
                                    }
                                    let _e1692 = phi_3188_;
                                    let _e1701 = (_e1485 + 4u);
                                    if (_e1701 < _e107) {
                                        let _e1704 = slimbvh_triangles.member[_e1701];
                                        phi_3218_ = _e1704;
                                    } else {
                                        phi_3218_ = 0u;
                                    }
                                    let _e1706 = phi_3218_;
                                    let _e1707 = (_e1485 + 5u);
                                    if (_e1707 < _e107) {
                                        let _e1710 = slimbvh_triangles.member[_e1707];
                                        phi_3233_ = _e1710;
                                    } else {
                                        phi_3233_ = 0u;
                                    }
                                    let _e1712 = phi_3233_;
                                    if _e1586 {
                                        phi_3243_ = ((_e1706 >> bitcast<u32>(21i)) | (_e1712 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3243_ = (_e1712 >> bitcast<u32>(10i));
                                    }
                                    let _e1721 = phi_3243_;
                                    if _e1604 {
                                        phi_3264_ = ((_e1706 >> bitcast<u32>(21i)) | (_e1712 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3264_ = (_e1712 >> bitcast<u32>(10i));
                                    }
                                    let _e1737 = phi_3264_;
                                    if _e1622 {
                                        phi_3285_ = ((_e1706 >> bitcast<u32>(21i)) | (_e1712 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3285_ = (_e1712 >> bitcast<u32>(10i));
                                    }
                                    let _e1753 = phi_3285_;
                                    phi_3476_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1432.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1595, _e1578, _e218) & 2097151u))) - 8388608f) * _e153)), (_e1432.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1613, _e1578, _e221) & 2097151u))) - 8388608f) * _e153)), (_e1432.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1631, _e1578, _e225) & 2097151u))) - 8388608f) * _e153))), array<f32, 3>((_e1432.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1660, _e1645, _e218) & 2097151u))) - 8388608f) * _e153)), (_e1432.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1676, _e1645, _e221) & 2097151u))) - 8388608f) * _e153)), (_e1432.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1692, _e1645, _e225) & 2097151u))) - 8388608f) * _e153))), array<f32, 3>((_e1432.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1721, _e1706, _e218) & 2097151u))) - 8388608f) * _e153)), (_e1432.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1737, _e1706, _e221) & 2097151u))) - 8388608f) * _e153)), (_e1432.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1753, _e1706, _e225) & 2097151u))) - 8388608f) * _e153))));
                                    break;
                                }
                                case 2: {
                                    let _e1487 = (_e1485 + _e213);
                                    if (_e1487 < _e107) {
                                        let _e1490 = slimbvh_triangles.member[_e1487];
                                        phi_3316_ = _e1490;
                                    } else {
                                        phi_3316_ = 0u;
                                    }
                                    let _e1492 = phi_3316_;
                                    let _e1496 = (_e1485 + _e217);
                                    if (_e1496 < _e107) {
                                        let _e1499 = slimbvh_triangles.member[_e1496];
                                        phi_3334_ = _e1499;
                                    } else {
                                        phi_3334_ = 0u;
                                    }
                                    let _e1501 = phi_3334_;
                                    let _e1505 = (_e1485 + _e209);
                                    if (_e1505 < _e107) {
                                        let _e1508 = slimbvh_triangles.member[_e1505];
                                        phi_3352_ = _e1508;
                                    } else {
                                        phi_3352_ = 0u;
                                    }
                                    let _e1510 = phi_3352_;
                                    let _e1515 = (_e1485 + 3u);
                                    let _e1516 = (_e1515 + _e213);
                                    if (_e1516 < _e107) {
                                        let _e1519 = slimbvh_triangles.member[_e1516];
                                        phi_3375_ = _e1519;
                                    } else {
                                        phi_3375_ = 0u;
                                    }
                                    let _e1521 = phi_3375_;
                                    let _e1525 = (_e1515 + _e217);
                                    if (_e1525 < _e107) {
                                        let _e1528 = slimbvh_triangles.member[_e1525];
                                        phi_3393_ = _e1528;
                                    } else {
                                        phi_3393_ = 0u;
                                    }
                                    let _e1530 = phi_3393_;
                                    let _e1534 = (_e1515 + _e209);
                                    if (_e1534 < _e107) {
                                        let _e1537 = slimbvh_triangles.member[_e1534];
                                        phi_3411_ = _e1537;
                                    } else {
                                        phi_3411_ = 0u;
                                    }
                                    let _e1539 = phi_3411_;
                                    let _e1544 = (_e1485 + 6u);
                                    let _e1545 = (_e1544 + _e213);
                                    if (_e1545 < _e107) {
                                        let _e1548 = slimbvh_triangles.member[_e1545];
                                        phi_3434_ = _e1548;
                                    } else {
                                        phi_3434_ = 0u;
                                    }
                                    let _e1550 = phi_3434_;
                                    let _e1554 = (_e1544 + _e217);
                                    if (_e1554 < _e107) {
                                        let _e1557 = slimbvh_triangles.member[_e1554];
                                        phi_3452_ = _e1557;
                                    } else {
                                        phi_3452_ = 0u;
                                    }
                                    let _e1559 = phi_3452_;
                                    let _e1563 = (_e1544 + _e209);
                                    if (_e1563 < _e107) {
                                        let _e1566 = slimbvh_triangles.member[_e1563];
                                        phi_3470_ = _e1566;
                                    } else {
                                        phi_3470_ = 0u;
                                    }
                                    let _e1568 = phi_3470_;
                                    phi_3476_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1492)) * _e153), (f32(bitcast<i32>(_e1501)) * _e153), (f32(bitcast<i32>(_e1510)) * _e153)), array<f32, 3>((f32(bitcast<i32>(_e1521)) * _e153), (f32(bitcast<i32>(_e1530)) * _e153), (f32(bitcast<i32>(_e1539)) * _e153)), array<f32, 3>((f32(bitcast<i32>(_e1550)) * _e153), (f32(bitcast<i32>(_e1559)) * _e153), (f32(bitcast<i32>(_e1568)) * _e153)));
                                    break;
                                }
                                default: {
                                    phi_3476_ = array<array<f32, 3>, 3>();
                                    break;
                                }
                            }
                            let _e1866 = phi_3476_;
                            let _e1883 = (_e1866[0][2] - _e601.member[2]);
                            let _e1886 = (((_e1866[0][0] - _e601.member[0]) * _e656) - (_e1883 * _e624));
                            let _e1889 = (((_e1866[0][1] - _e601.member[1]) * _e656) - (_e1883 * _e640));
                            let _e1892 = (_e1866[1][2] - _e601.member[2]);
                            let _e1895 = (((_e1866[1][0] - _e601.member[0]) * _e656) - (_e1892 * _e624));
                            let _e1898 = (((_e1866[1][1] - _e601.member[1]) * _e656) - (_e1892 * _e640));
                            let _e1901 = (_e1866[2][2] - _e601.member[2]);
                            let _e1904 = (((_e1866[2][0] - _e601.member[0]) * _e656) - (_e1901 * _e624));
                            let _e1907 = (((_e1866[2][1] - _e601.member[1]) * _e656) - (_e1901 * _e640));
                            let _e1908 = (_e1904 * _e1898);
                            let _e1909 = (_e1907 * _e1895);
                            let _e1910 = (_e1886 * _e1907);
                            let _e1911 = (_e1889 * _e1904);
                            let _e1912 = (_e1895 * _e1889);
                            let _e1913 = (_e1898 * _e1886);
                            let _e1918 = (((_e1908 >= _e1909) && (_e1910 >= _e1911)) && (_e1912 >= _e1913));
                            let _e1924 = (_e1918 || (((_e1908 <= _e1909) && (_e1910 <= _e1911)) && (_e1912 <= _e1913)));
                            if _e1924 {
                                let _e1926 = select(-1f, 1f, _e1918);
                                let _e1928 = ((_e1908 - _e1909) * _e1926);
                                let _e1930 = select(0f, _e1928, (_e1928 > 0f));
                                let _e1932 = ((_e1910 - _e1911) * _e1926);
                                let _e1934 = select(0f, _e1932, (_e1932 > 0f));
                                let _e1936 = ((_e1912 - _e1913) * _e1926);
                                let _e1938 = select(0f, _e1936, (_e1936 > 0f));
                                let _e1940 = ((_e1930 + _e1934) + _e1938);
                                let _e1955 = ((min(min(_e1866[0][0], _e1866[1][0]), _e1866[2][0]) - _e625) * _e628);
                                let _e1956 = ((max(max(_e1866[0][0], _e1866[1][0]), _e1866[2][0]) - _e626) * _e628);
                                let _e1957 = vec4<f32>(_e1955, f32(), _e1956, f32());
                                let _e1960 = ((min(min(_e1866[0][1], _e1866[1][1]), _e1866[2][1]) - _e641) * _e644);
                                let _e1961 = ((max(max(_e1866[0][1], _e1866[1][1]), _e1866[2][1]) - _e642) * _e644);
                                let _e1962 = vec4<f32>(_e1960, f32(), _e1961, f32());
                                let _e1965 = ((min(min(_e1866[0][2], _e1866[1][2]), _e1866[2][2]) - _e657) * _e660);
                                let _e1966 = ((max(max(_e1866[0][2], _e1866[1][2]), _e1866[2][2]) - _e658) * _e660);
                                let _e1967 = vec4<f32>(_e1965, f32(), _e1966, f32());
                                let _e1968 = vec4<f32>(_e1956, f32(), _e1955, f32());
                                let _e1970 = vec4<f32>(_e1961, f32(), _e1960, f32());
                                let _e1972 = vec4<f32>(_e1966, f32(), _e1965, f32());
                                let _e1981 = max(max(min(_e1957, _e1968).x, min(_e1962, _e1970).x), min(_e1967, _e1972).x);
                                let _e1986 = min(min(max(_e1957, _e1968).x, max(_e1962, _e1970).x), max(_e1967, _e1972).x);
                                let _e1991 = max(_e1981, _e668);
                                let _e2013 = (((((_e1924 && (_e1940 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1886, _e1895), _e1904) <= 0f) && (max(max(_e1886, _e1895), _e1904) >= 0f))) && ((min(min(_e1889, _e1898), _e1907) <= 0f) && (max(max(_e1889, _e1898), _e1907) >= 0f))) && (_e1991 <= (_e1986 + (max(max(_e1967, _e1972).x, -(min(_e1967, _e1972).x)) * 0.0000019073523f)))) && (_e1991 <= _e1436.member.member_1));
                                if _e2013 {
                                    let _e2018 = (_e1866[1][0] - _e1866[0][0]);
                                    let _e2019 = (_e1866[1][1] - _e1866[0][1]);
                                    let _e2020 = (_e1866[1][2] - _e1866[0][2]);
                                    let _e2021 = vec3<f32>(_e2018, _e2019, _e2020);
                                    let _e2022 = (_e1866[2][0] - _e1866[1][0]);
                                    let _e2023 = (_e1866[2][1] - _e1866[1][1]);
                                    let _e2024 = (_e1866[2][2] - _e1866[1][2]);
                                    let _e2025 = vec3<f32>(_e2022, _e2023, _e2024);
                                    let _e2026 = (_e1866[0][0] - _e1866[2][0]);
                                    let _e2027 = (_e1866[0][1] - _e1866[2][1]);
                                    let _e2028 = (_e1866[0][2] - _e1866[2][2]);
                                    let _e2029 = vec3<f32>(_e2026, _e2027, _e2028);
                                    let _e2040 = max(max(bitcast<f32>((bitcast<u32>(_e2018) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2019) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2020) & 2147483647u)));
                                    let _e2051 = max(max(bitcast<f32>((bitcast<u32>(_e2022) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2023) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2024) & 2147483647u)));
                                    let _e2064 = max(max(_e2040, _e2051), max(max(bitcast<f32>((bitcast<u32>(_e2026) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2027) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2028) & 2147483647u))));
                                    if (_e2040 == _e2064) {
                                        phi_3841_ = _e1898;
                                        phi_3842_ = _e1895;
                                        phi_3843_ = _e1889;
                                        phi_3844_ = _e1886;
                                        phi_3845_ = vec3<f32>(_e1866[0][0], _e1866[0][1], _e1866[0][2]);
                                        phi_3846_ = _e2029;
                                        phi_3847_ = _e2025;
                                        phi_3848_ = _e2021;
                                    } else {
                                        let _e2066 = (_e2051 == _e2064);
                                        let _e2071 = vec3(_e2066);
                                        phi_3841_ = select(_e1889, _e1907, _e2066);
                                        phi_3842_ = select(_e1886, _e1904, _e2066);
                                        phi_3843_ = select(_e1907, _e1898, _e2066);
                                        phi_3844_ = select(_e1904, _e1895, _e2066);
                                        phi_3845_ = select(vec3<f32>(_e1866[2][0], _e1866[2][1], _e1866[2][2]), vec3<f32>(_e1866[1][0], _e1866[1][1], _e1866[1][2]), _e2071);
                                        phi_3846_ = select(_e2025, _e2021, _e2071);
                                        phi_3847_ = select(_e2021, _e2029, _e2071);
                                        phi_3848_ = select(_e2029, _e2025, _e2071);
                                    }
                                    let _e2077 = phi_3841_;
                                    let _e2079 = phi_3842_;
                                    let _e2081 = phi_3843_;
                                    let _e2083 = phi_3844_;
                                    let _e2085 = phi_3845_;
                                    let _e2087 = phi_3846_;
                                    let _e2089 = phi_3847_;
                                    let _e2091 = phi_3848_;
                                    let _e2098 = ((_e2089.y * _e2087.z) - (_e2087.y * _e2089.z));
                                    let _e2103 = ((_e2089.z * _e2087.x) - (_e2087.z * _e2089.x));
                                    let _e2106 = ((_e2089.x * _e2087.y) - (_e2087.x * _e2089.y));
                                    let _e2109 = ((_e1930 >= _e1934) && (_e1930 >= _e1938));
                                    let _e2110 = (_e1934 >= _e1938);
                                    let _e2124 = (((_e2098 * (select(select(_e1866[2][0], _e1866[1][0], _e2110), _e1866[0][0], _e2109) - _e601.member[0])) + (_e2103 * (select(select(_e1866[2][1], _e1866[1][1], _e2110), _e1866[0][1], _e2109) - _e601.member[1]))) + (_e2106 * (select(select(_e1866[2][2], _e1866[1][2], _e2110), _e1866[0][2], _e2109) - _e601.member[2])));
                                    let _e2129 = (((_e2098 * _e624) + (_e2103 * _e640)) + (_e2106 * _e656));
                                    let _e2130 = (_e2079 - _e2083);
                                    let _e2131 = (_e2077 - _e2081);
                                    let _e2134 = ((_e2130 * _e2130) + (_e2131 * _e2131));
                                    let _e2141 = (-(((_e2083 * _e2130) + (_e2081 * _e2131))) / select(0.000000000000000000000000000000000000011754944f, _e2134, (_e2134 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e2143 = select(1f, _e2141, (_e2141 < 1f));
                                    let _e2145 = select(0f, _e2143, (_e2143 > 0f));
                                    let _e2154 = ((_e2085.x + (_e2091.x * _e2145)) - _e601.member[0]);
                                    let _e2157 = ((_e2085.y + (_e2091.y * _e2145)) - _e601.member[1]);
                                    let _e2160 = ((_e2085.z + (_e2091.z * _e2145)) - _e601.member[2]);
                                    let _e2225 = ((bitcast<f32>((bitcast<u32>(((((_e2098 * _e2154) + (_e2103 * _e2157)) + (_e2106 * _e2160)) - _e2124)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e2154) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2157) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2160) & 2147483647u))), _e2064)) * max(max(bitcast<f32>((bitcast<u32>(_e2098) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2103) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2106) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e2129) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e2089.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2089.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2089.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e2087.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2087.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2087.z) & 2147483647u)))))));
                                    let _e2226 = (_e2124 / _e2129);
                                    if (_e2013 && !(_e2225)) {
                                        let _e2229 = (_e2160 / _e656);
                                        let _e2237 = (((_e2098 * (_e2154 - (_e624 * _e2229))) + (_e2103 * (_e2157 - (_e640 * _e2229)))) / _e2129);
                                        phi_4027_ = select(select(_e2229, (_e2229 + _e2237), (bitcast<f32>((bitcast<u32>(_e2237) & 2147483647u)) <= _e2064)), _e2226, _e2225);
                                    } else {
                                        phi_4027_ = _e2226;
                                    }
                                    let _e2246 = phi_4027_;
                                    let _e2248 = select(_e1986, _e2246, (_e2246 < _e1986));
                                    let _e2250 = select(_e1981, _e2248, (_e2248 > _e1981));
                                    let _e2253 = select(_e2250, 0f, (bitcast<u32>(_e2250) == 2147483648u));
                                    let _e2254 = (1f / _e1940);
                                    phi_4053_ = SlimbvhTypeE(_e2253, (_e1934 * _e2254), (_e1938 * _e2254), ((_e2013 && (_e2253 >= _e668)) && (_e2253 <= _e1436.member.member_1)));
                                    phi_4054_ = SlimbvhTypeE();
                                } else {
                                    phi_4053_ = SlimbvhTypeE();
                                    phi_4054_ = SlimbvhTypeE(0f, 0f, 0f, _e2013);
                                }
                                let _e2263 = phi_4053_;
                                let _e2265 = phi_4054_;
                                phi_4057_ = _e2263;
                                phi_4058_ = _e2265;
                                phi_4059_ = select(true, false, _e2013);
                            } else {
                                phi_4057_ = SlimbvhTypeE();
                                phi_4058_ = SlimbvhTypeE(0f, 0f, 0f, _e1924);
                                phi_4059_ = true;
                            }
                            let _e2268 = phi_4057_;
                            let _e2270 = phi_4058_;
                            let _e2272 = phi_4059_;
                            if _e2272 {
                                phi_4063_ = _e2270;
                            } else {
                                phi_4063_ = _e2268;
                            }
                            let _e2274 = phi_4063_;
                            if _e2274.member_3 {
                                phi_4072_ = SlimbvhTypeF(_e2274.member, _e2274.member_1, _e2274.member_2, _e1477);
                            } else {
                                phi_4072_ = _e100;
                            }
                            let _e2281 = phi_4072_;
                            if (_e2281.member_3 != 4294967295u) {
                                if (_e1477 != 4294967295u) {
                                    if (_e2281.member < _e1436.member.member.member) {
                                        phi_4100_ = true;
                                    } else {
                                        if (_e2281.member == _e1436.member.member.member) {
                                            phi_4099_ = (_e2281.member_3 < _e1436.member.member.member_3);
                                        } else {
                                            phi_4099_ = false;
                                        }
                                        let _e2296 = phi_4099_;
                                        phi_4100_ = _e2296;
                                    }
                                    let _e2298 = phi_4100_;
                                    if _e2298 {
                                        phi_4107_ = SlimbvhTypeP(SlimbvhTypeH(_e2281, _e2281.member), _e1436.member_1);
                                    } else {
                                        phi_4107_ = _e1436;
                                    }
                                    let _e2304 = phi_4107_;
                                    if _e2304.member_1 {
                                        phi_4113_ = SlimbvhTypeP(SlimbvhTypeH(_e2304.member.member, bitcast<f32>(4286578687u)), _e2304.member_1);
                                    } else {
                                        phi_4113_ = _e2304;
                                    }
                                    let _e2313 = phi_4113_;
                                    phi_4114_ = _e2313;
                                } else {
                                    phi_4114_ = _e1436;
                                }
                                let _e2315 = phi_4114_;
                                phi_4115_ = _e2315;
                            } else {
                                phi_4115_ = _e1436;
                            }
                            let _e2317 = phi_4115_;
                            phi_2767_ = _e2317;
                        } else {
                            phi_2767_ = SlimbvhTypeP();
                        }
                        let _e2319 = phi_2767_;
                        continue;
                        continuing {
                            phi_2766_ = _e2319;
                            phi_2769_ = _e1451;
                            break if !(_e1457);
                        }
                    }
                    let _e2322 = local_2;
                    let _e2323 = (_e2322 - 1u);
                    let _e2328 = slimbvh_stacks[(((_e2323 % 32u) * 64u) + _e672)];
                    let _e2329 = (_e2328 & 511u);
                    let _e2331 = (_e2329 >> bitcast<u32>(3u));
                    let _e2334 = ((_e2331 == 0u) || (_e2323 == 4294967295u));
                    if _e2334 {
                    } else {
                        slimbvh_stacks[(((_e2323 % 32u) * 64u) + _e672)] = (((_e2328 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2331);
                    }
                    let _e2341 = local_3;
                    let _e2349 = (((_e2328 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2329 & 3u) & 3u));
                    let _e2351 = (_e2349 >> bitcast<u32>(2i));
                    if (_e2351 >= _e104) {
                        phi_4189_ = 4294967295u;
                    } else {
                        if (_e2351 < _e104) {
                            let _e2358 = slimbvh_nodes.member[_e2351].member_1[(_e2349 & 3u)];
                            phi_4181_ = _e2358;
                        } else {
                            phi_4181_ = 2147483648u;
                        }
                        let _e2360 = phi_4181_;
                        if ((_e2360 & 2147483648u) != 0u) {
                            phi_4188_ = (2147483648u | _e2349);
                        } else {
                            phi_4188_ = _e2360;
                        }
                        let _e2365 = phi_4188_;
                        phi_4189_ = _e2365;
                    }
                    let _e2367 = phi_4189_;
                    let _e2369 = local_4;
                    let _e2670 = local_7;
                    phi_4198_ = _e2670;
                    phi_4199_ = select(select(_e2341, _e2323, _e2334), 4294967295u, (_e668 > _e2369.member.member_1));
                    phi_4200_ = _e2367;
                } else {
                    phi_4198_ = _e779;
                    let _e2673 = local_8;
                    phi_4199_ = _e2673;
                    let _e2676 = local_9;
                    phi_4200_ = _e2676;
                }
                let _e2375 = phi_4198_;
                let _e2377 = phi_4199_;
                let _e2379 = phi_4200_;
                phi_1684_ = _e2375;
                phi_1687_ = _e2377;
                phi_1689_ = _e2379;
                let _e2682 = local_10;
                phi_1691_ = _e2682;
            } else {
                phi_1684_ = SlimbvhTypeP();
                phi_1687_ = u32();
                phi_1689_ = u32();
                phi_1691_ = u32();
            }
            let _e2381 = phi_1684_;
            let _e2383 = phi_1687_;
            let _e2385 = phi_1689_;
            let _e2387 = phi_1691_;
            continue;
            continuing {
                phi_1683_ = _e2381;
                phi_1686_ = _e2383;
                phi_1688_ = _e2385;
                phi_1690_ = _e2387;
                break if !(_e786);
            }
        }
        let _e2390 = local_5;
        let _e2391 = (_e2390 == 4294967295u);
        let _e2393 = local_6;
        if (_e2393.member.member.member_3 != 4294967295u) {
            let _e2399 = -((_e171 + _e601.member_4));
            let _e2400 = bitcast<u32>(_e2393.member.member.member);
            let _e2404 = (bitcast<i32>((_e2400 >> bitcast<u32>(23i))) & 255i);
            let _e2405 = (_e2404 + _e2399);
            if (_e2404 == 255i) {
                phi_4258_ = _e2393.member.member.member;
            } else {
                if (_e2404 > 0i) {
                    if (_e2405 > 0i) {
                        let _e2409 = (_e2405 < 255i);
                        if _e2409 {
                            phi_4237_ = bitcast<f32>((_e2400 + bitcast<u32>((_e2399 << bitcast<u32>(23i)))));
                        } else {
                            phi_4237_ = f32();
                        }
                        let _e2416 = phi_4237_;
                        phi_4239_ = _e2416;
                        phi_4240_ = select(true, false, _e2409);
                    } else {
                        phi_4239_ = f32();
                        phi_4240_ = true;
                    }
                    let _e2419 = phi_4239_;
                    let _e2421 = phi_4240_;
                    phi_4241_ = _e2419;
                    phi_4242_ = _e2421;
                } else {
                    phi_4241_ = f32();
                    phi_4242_ = true;
                }
                let _e2423 = phi_4241_;
                let _e2425 = phi_4242_;
                if _e2425 {
                    let _e2426 = (_e2400 & 2147483648u);
                    let _e2433 = ((_e2400 & 8388607u) | (select(0u, 1u, ((_e2400 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e2437 = (_e2433 == 0u);
                    if _e2437 {
                        phi_4940_ = bitcast<f32>(_e2426);
                    } else {
                        let _e2442 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2433)), 32u, _e2437) - 8u);
                        let _e2445 = (_e2433 << bitcast<u32>((_e2442 & 31u)));
                        let _e2447 = ((_e2405 + select(0i, 1i, (_e2404 == 0i))) - bitcast<i32>(_e2442));
                        if (_e2447 >= 255i) {
                            phi_4930_ = bitcast<f32>((_e2426 | 2139095040u));
                            phi_4931_ = f32();
                            phi_4932_ = true;
                        } else {
                            let _e2449 = (_e2447 > 0i);
                            if _e2449 {
                                phi_4924_ = bitcast<f32>(((_e2426 | (bitcast<u32>(_e2447) << bitcast<u32>(23i))) | (_e2445 & 8388607u)));
                                phi_4925_ = f32();
                            } else {
                                if (_e2447 < -24i) {
                                    phi_4890_ = 26u;
                                } else {
                                    phi_4890_ = bitcast<u32>((1i - _e2447));
                                }
                                let _e2454 = phi_4890_;
                                let _e2455 = (_e2454 & 31u);
                                let _e2457 = (_e2445 >> bitcast<u32>(_e2455));
                                let _e2461 = (_e2445 & ((1u << bitcast<u32>(_e2455)) - 1u));
                                let _e2465 = (1u << bitcast<u32>(((_e2454 - 1u) & 31u)));
                                if (_e2461 > _e2465) {
                                    phi_4911_ = true;
                                } else {
                                    if (_e2461 == _e2465) {
                                        phi_4908_ = ((_e2457 & 1u) == 1u);
                                    } else {
                                        phi_4908_ = false;
                                    }
                                    let _e2471 = phi_4908_;
                                    phi_4911_ = _e2471;
                                }
                                let _e2473 = phi_4911_;
                                phi_4924_ = f32();
                                phi_4925_ = bitcast<f32>((_e2426 | (_e2457 + select(0u, 1u, _e2473))));
                            }
                            let _e2486 = phi_4924_;
                            let _e2488 = phi_4925_;
                            phi_4930_ = _e2486;
                            phi_4931_ = _e2488;
                            phi_4932_ = _e2449;
                        }
                        let _e2492 = phi_4930_;
                        let _e2494 = phi_4931_;
                        let _e2496 = phi_4932_;
                        phi_4940_ = select(_e2494, _e2492, _e2496);
                    }
                    let _e2500 = phi_4940_;
                    phi_4257_ = _e2500;
                } else {
                    phi_4257_ = _e2423;
                }
                let _e2502 = phi_4257_;
                phi_4258_ = _e2502;
            }
            let _e2504 = phi_4258_;
            let _e2505 = bitcast<u32>(_e2504);
            if ((_e2505 & 2147483647u) >= 2139095040u) {
                phi_4270_ = bitcast<f32>(((_e2505 & 2147483648u) | 2139095039u));
            } else {
                phi_4270_ = _e2504;
            }
            let _e2512 = phi_4270_;
            phi_4275_ = SlimbvhTypeF(_e2512, _e2393.member.member.member_1, _e2393.member.member.member_2, _e2393.member.member.member_3);
        } else {
            phi_4275_ = _e100;
        }
        let _e2517 = phi_4275_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2517.member), bitcast<u32>(_e2517.member_1), bitcast<u32>(_e2517.member_2), _e2517.member_3);
        phi_4288_ = _e2391;
        phi_4289_ = _e2391;
        phi_4290_ = select(true, false, _e2391);
    } else {
        phi_4288_ = bool();
        phi_4289_ = false;
        phi_4290_ = true;
    }
    let _e2528 = phi_4288_;
    let _e2530 = phi_4289_;
    let _e2532 = phi_4290_;
    if _e2532 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e2528, _e2530, _e2532)));
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
