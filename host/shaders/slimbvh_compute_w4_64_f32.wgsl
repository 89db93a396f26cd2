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

struct SlimbvhTypeT {
    member: u32,
}

var<workgroup> slimbvh_stacks: array<u32, 2048>;

var<private> slimbvh_lane: SlimbvhTypeT;

var<private> slimbvh_overflowed: SlimbvhTypeT;

fn slimbvh_trace_in_group() {
    var phi_570_: u32;
    var phi_576_: u32;
    var phi_582_: u32;
    var phi_847_: i32;
    var phi_858_: i32;
    var phi_972_: i32;
    var phi_1101_: i32;
    var phi_1123_: u32;
    var phi_1124_: u32;
    var phi_1125_: bool;
    var phi_1159_: i32;
    var phi_1181_: u32;
    var phi_1182_: u32;
    var phi_1183_: bool;
    var phi_744_: i32;
    var phi_750_: u32;
    var phi_769_: u32;
    var phi_770_: u32;
    var phi_771_: bool;
    var phi_789_: i32;
    var phi_795_: u32;
    var phi_814_: u32;
    var phi_815_: u32;
    var phi_816_: bool;
    var phi_1193_: SlimbvhTypeD;
    var phi_1439_: SlimbvhTypeP;
    var phi_1502_: array<f32, 3>;
    var phi_1503_: array<f32, 3>;
    var phi_1521_: array<f32, 3>;
    var phi_1522_: array<f32, 3>;
    var phi_1695_: SlimbvhTypeP;
    var phi_1698_: u32;
    var phi_1700_: u32;
    var phi_1702_: u32;
    var phi_1711_: u32;
    var phi_1714_: u32;
    var phi_1716_: u32;
    var phi_1818_: SlimbvhTypeM;
    var phi_1819_: SlimbvhTypeM;
    var phi_1878_: SlimbvhTypeM;
    var phi_1879_: SlimbvhTypeM;
    var phi_1938_: SlimbvhTypeM;
    var phi_1939_: SlimbvhTypeM;
    var phi_2423_: u32;
    var phi_2436_: u32;
    var phi_2449_: u32;
    var phi_2462_: u32;
    var phi_4460_: SlimbvhTypeE;
    var phi_4472_: SlimbvhTypeE;
    var phi_4484_: SlimbvhTypeE;
    var phi_4496_: SlimbvhTypeE;
    var phi_4508_: SlimbvhTypeE;
    var phi_2546_: u32;
    var phi_2551_: u32;
    var phi_2552_: u32;
    var phi_2576_: u32;
    var phi_1712_: u32;
    var phi_1715_: u32;
    var phi_1717_: u32;
    var local: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_2592_: SlimbvhTypeP;
    var phi_2595_: SlimbvhTypeE;
    var phi_2596_: SlimbvhTypeE;
    var phi_2618_: SlimbvhTypeE;
    var phi_2697_: array<vec4<f32>, 3>;
    var phi_2698_: array<vec4<f32>, 3>;
    var phi_2778_: array<vec4<f32>, 3>;
    var phi_2779_: array<vec4<f32>, 3>;
    var phi_2802_: array<f32, 3>;
    var phi_2803_: array<f32, 3>;
    var phi_2817_: array<f32, 3>;
    var phi_2818_: array<f32, 3>;
    var phi_2832_: array<f32, 3>;
    var phi_2833_: array<f32, 3>;
    var phi_3192_: f32;
    var phi_3193_: f32;
    var phi_3194_: f32;
    var phi_3195_: f32;
    var phi_3196_: vec3<f32>;
    var phi_3197_: vec3<f32>;
    var phi_3198_: vec3<f32>;
    var phi_3199_: vec3<f32>;
    var phi_3378_: f32;
    var phi_3404_: SlimbvhTypeF;
    var phi_3405_: SlimbvhTypeF;
    var phi_3408_: SlimbvhTypeF;
    var phi_3409_: SlimbvhTypeF;
    var phi_3410_: bool;
    var phi_3414_: SlimbvhTypeF;
    var phi_3423_: SlimbvhTypeG;
    var phi_3476_: i32;
    var phi_3616_: SlimbvhTypeI;
    var phi_3640_: u32;
    var phi_3668_: vec3<f32>;
    var phi_3669_: vec3<f32>;
    var phi_3686_: vec3<f32>;
    var phi_3687_: vec3<f32>;
    var phi_3704_: vec3<f32>;
    var phi_3705_: vec3<f32>;
    var phi_3741_: vec3<f32>;
    var phi_3923_: f32;
    var phi_3941_: bool;
    var phi_3942_: bool;
    var phi_3961_: bool;
    var phi_3962_: bool;
    var phi_3969_: SlimbvhTypeP;
    var phi_3975_: SlimbvhTypeP;
    var phi_3976_: SlimbvhTypeP;
    var phi_3977_: SlimbvhTypeP;
    var phi_2593_: SlimbvhTypeP;
    var local_3: u32;
    var local_4: u32;
    var phi_4038_: u32;
    var local_5: SlimbvhTypeP;
    var phi_4047_: SlimbvhTypeP;
    var phi_4048_: u32;
    var phi_4049_: u32;
    var phi_1696_: SlimbvhTypeP;
    var phi_1699_: u32;
    var phi_1701_: u32;
    var phi_1703_: u32;
    var local_6: u32;
    var local_7: SlimbvhTypeP;
    var phi_4086_: f32;
    var phi_4088_: f32;
    var phi_4089_: bool;
    var phi_4090_: f32;
    var phi_4091_: bool;
    var phi_4739_: u32;
    var phi_4757_: bool;
    var phi_4760_: bool;
    var phi_4773_: f32;
    var phi_4774_: f32;
    var phi_4779_: f32;
    var phi_4780_: f32;
    var phi_4781_: bool;
    var phi_4789_: f32;
    var phi_4106_: f32;
    var phi_4107_: f32;
    var phi_4119_: f32;
    var phi_4124_: SlimbvhTypeG;
    var phi_4137_: bool;
    var phi_4138_: bool;
    var phi_4139_: bool;
    var local_8: SlimbvhTypeP;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e99 = SlimbvhTypeG(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e103 = arrayLength((&slimbvh_nodes.member));
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
        phi_570_ = 0u;
    } else {
        phi_570_ = select(2u, 1u, (_e183 == _e191));
    }
    let _e209 = phi_570_;
    let _e210 = (_e209 == 2u);
    if _e210 {
        phi_576_ = 0u;
    } else {
        phi_576_ = (_e209 + 1u);
    }
    let _e213 = phi_576_;
    let _e214 = (_e213 == 2u);
    if _e214 {
        phi_582_ = 0u;
    } else {
        phi_582_ = (_e213 + 1u);
    }
    let _e217 = phi_582_;
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
            phi_744_ = 255i;
        } else {
            phi_744_ = (bitcast<i32>((_e179 >> bitcast<u32>(23i))) + _e520);
        }
        let _e545 = phi_744_;
        if (_e179 == 0u) {
            phi_750_ = 0u;
        } else {
            phi_750_ = (_e179 | 8388608u);
        }
        let _e549 = phi_750_;
        if (_e545 <= 0i) {
            phi_770_ = u32();
            phi_771_ = true;
        } else {
            let _e556 = (_e549 == 0u);
            if _e556 {
                phi_769_ = u32();
            } else {
                phi_769_ = select(((bitcast<u32>(_e545) << bitcast<u32>(23i)) | (_e549 & 8388607u)), 2139095039u, (_e545 >= 255i));
            }
            let _e560 = phi_769_;
            phi_770_ = _e560;
            phi_771_ = _e556;
        }
        let _e562 = phi_770_;
        let _e564 = phi_771_;
        if (_e187 >= 2139095040u) {
            phi_789_ = 255i;
        } else {
            phi_789_ = (bitcast<i32>((_e187 >> bitcast<u32>(23i))) + _e520);
        }
        let _e575 = phi_789_;
        if (_e187 == 0u) {
            phi_795_ = 0u;
        } else {
            phi_795_ = (_e187 | 8388608u);
        }
        let _e579 = phi_795_;
        if (_e575 <= 0i) {
            phi_815_ = u32();
            phi_816_ = true;
        } else {
            let _e586 = (_e579 == 0u);
            if _e586 {
                phi_814_ = u32();
            } else {
                phi_814_ = select(((bitcast<u32>(_e575) << bitcast<u32>(23i)) | (_e579 & 8388607u)), 2139095039u, (_e575 >= 255i));
            }
            let _e590 = phi_814_;
            phi_815_ = _e590;
            phi_816_ = _e586;
        }
        let _e592 = phi_815_;
        let _e594 = phi_816_;
        phi_1193_ = SlimbvhTypeD(array<f32, 3>((_e220 * _e525), (_e224 * _e525), (_e227 * _e525)), array<f32, 3>((_e229 * _e530), (_e231 * _e530), (_e233 * _e530)), bitcast<f32>(((_e178 & 2147483648u) | select(_e562, 0u, _e564))), bitcast<f32>(((_e186 & 2147483648u) | select(_e592, 0u, _e594))), _e519);
    } else {
        let _e266 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e191, _e204))) & 2147483647u);
        if (_e266 >= 8388608u) {
            phi_847_ = (bitcast<i32>((_e266 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_847_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e266)), 32u, (_e266 == 0u))));
        }
        let _e280 = phi_847_;
        let _e281 = (_e171 + _e280);
        if (_e171 < -126i) {
            phi_858_ = -126i;
        } else {
            phi_858_ = select(_e171, 127i, (_e171 > 127i));
        }
        let _e286 = phi_858_;
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
            phi_972_ = -126i;
        } else {
            phi_972_ = select(_e350, 127i, (_e350 > 127i));
        }
        let _e355 = phi_972_;
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
            phi_1101_ = 255i;
        } else {
            phi_1101_ = (((_e428 + select(0i, 1i, (_e428 == 0i))) - _e435) + _e281);
        }
        let _e443 = phi_1101_;
        let _e447 = (_e425 << bitcast<u32>(((_e435 & 31i) & 31i)));
        if (_e443 <= 0i) {
            phi_1124_ = u32();
            phi_1125_ = true;
        } else {
            let _e454 = (_e447 == 0u);
            if _e454 {
                phi_1123_ = u32();
            } else {
                phi_1123_ = select(((bitcast<u32>(_e443) << bitcast<u32>(23i)) | (_e447 & 8388607u)), 2139095039u, (_e443 >= 255i));
            }
            let _e458 = phi_1123_;
            phi_1124_ = _e458;
            phi_1125_ = _e454;
        }
        let _e460 = phi_1124_;
        let _e462 = phi_1125_;
        let _e473 = ((_e187 & 8388607u) | (select(0u, 1u, ((_e187 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e476 = bitcast<i32>((_e187 >> bitcast<u32>(23i)));
        let _e483 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e473)), 32u, (_e473 == 0u))) - 8i);
        if (_e476 == 255i) {
            phi_1159_ = 255i;
        } else {
            phi_1159_ = (((_e476 + select(0i, 1i, (_e476 == 0i))) - _e483) + _e281);
        }
        let _e491 = phi_1159_;
        let _e495 = (_e473 << bitcast<u32>(((_e483 & 31i) & 31i)));
        if (_e491 <= 0i) {
            phi_1182_ = u32();
            phi_1183_ = true;
        } else {
            let _e502 = (_e495 == 0u);
            if _e502 {
                phi_1181_ = u32();
            } else {
                phi_1181_ = select(((bitcast<u32>(_e491) << bitcast<u32>(23i)) | (_e495 & 8388607u)), 2139095039u, (_e491 >= 255i));
            }
            let _e506 = phi_1181_;
            phi_1182_ = _e506;
            phi_1183_ = _e502;
        }
        let _e508 = phi_1182_;
        let _e510 = phi_1183_;
        phi_1193_ = SlimbvhTypeD(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e298 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e298 & 2147483648u))), _e220, _e300) * _e291) * select(0.00000011920929f, 1f, _e300)) * _e297), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e224, _e317) * _e291) * select(0.00000011920929f, 1f, _e317)) * _e297), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e332 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e332 & 2147483648u))), _e227, _e334) * _e291) * select(0.00000011920929f, 1f, _e334)) * _e297)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e367 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e367 & 2147483648u))), _e229, _e369) * _e360) * select(0.00000011920929f, 1f, _e369)) * _e366), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e231, _e386) * _e360) * select(0.00000011920929f, 1f, _e386)) * _e366), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e401 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e401 & 2147483648u))), _e233, _e403) * _e360) * select(0.00000011920929f, 1f, _e403)) * _e366)), bitcast<f32>(((_e178 & 2147483648u) | select(_e460, 0u, _e462))), bitcast<f32>(((_e186 & 2147483648u) | select(_e508, 0u, _e510))), _e280);
    }
    let _e601 = phi_1193_;
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
    let _e672 = slimbvh_question.member[1u];
    let _e673 = slimbvh_lane.member;
    if (_e673 < 64u) {
        let _e675 = (_e673 % 64u);
        let _e678 = slimbvh_question.member[0u];
        if (_e678 == 1u) {
            phi_1439_ = SlimbvhTypeP(SlimbvhTypeJ(_e99, _e667), true);
        } else {
            phi_1439_ = SlimbvhTypeP(SlimbvhTypeJ(_e99, _e667), false);
        }
        let _e685 = phi_1439_;
        let _e690 = (_e213 & 3u);
        let _e691 = (_e217 & 3u);
        let _e692 = (_e209 & 3u);
        let _e695 = (bitcast<u32>(_e628) >> bitcast<u32>(31i));
        let _e698 = (bitcast<u32>(_e644) >> bitcast<u32>(31i));
        let _e701 = (bitcast<u32>(_e660) >> bitcast<u32>(31i));
        let _e705 = (f32(bitcast<i32>(_e117)) * _e153);
        let _e707 = (f32(bitcast<i32>(_e121)) * _e153);
        let _e709 = (f32(bitcast<i32>(_e125)) * _e153);
        let _e710 = (_e690 == 0u);
        if _e710 {
            phi_1503_ = array<f32, 3>(_e705, _e707, _e709);
        } else {
            if (_e690 == 1u) {
                phi_1502_ = array<f32, 3>(_e707, _e709, _e705);
            } else {
                phi_1502_ = array<f32, 3>(_e709, _e705, _e707);
            }
            let _e715 = phi_1502_;
            phi_1503_ = _e715;
        }
        let _e718 = phi_1503_;
        let _e720 = (f32(bitcast<i32>(_e133)) * _e153);
        let _e722 = (f32(bitcast<i32>(_e137)) * _e153);
        let _e724 = (f32(bitcast<i32>(_e141)) * _e153);
        if _e710 {
            phi_1522_ = array<f32, 3>(_e720, _e722, _e724);
        } else {
            if (_e690 == 1u) {
                phi_1521_ = array<f32, 3>(_e722, _e724, _e720);
            } else {
                phi_1521_ = array<f32, 3>(_e724, _e720, _e722);
            }
            let _e729 = phi_1521_;
            phi_1522_ = _e729;
        }
        let _e732 = phi_1522_;
        let _e743 = ((_e718[0] - _e625) * _e628);
        let _e744 = ((_e732[0] - _e626) * _e628);
        let _e745 = vec4<f32>(_e743, f32(), _e744, f32());
        let _e748 = ((_e718[1] - _e641) * _e644);
        let _e749 = ((_e732[1] - _e642) * _e644);
        let _e750 = vec4<f32>(_e748, f32(), _e749, f32());
        let _e753 = ((_e718[2] - _e657) * _e660);
        let _e754 = ((_e732[2] - _e658) * _e660);
        let _e755 = vec4<f32>(_e753, f32(), _e754, f32());
        let _e756 = vec4<f32>(_e744, f32(), _e743, f32());
        let _e758 = vec4<f32>(_e749, f32(), _e748, f32());
        let _e760 = vec4<f32>(_e754, f32(), _e753, f32());
        phi_1695_ = _e685;
        phi_1698_ = select(4294967295u, select(4294967295u, 0u, (_e668 <= _e667)), (max(max(max(min(_e745, _e756).x, min(_e750, _e758).x), min(_e755, _e760).x), _e668) <= min((min(min(max(_e745, _e756).x, max(_e750, _e758).x), max(_e755, _e760).x) + (max(max(_e755, _e760).x, -(min(_e755, _e760).x)) * 0.0000019073523f)), _e685.member.member_1)));
        phi_1700_ = select(0u, 2147483648u, (_e103 == 0u));
        phi_1702_ = (_e103 + 1u);
        loop {
            let _e784 = phi_1695_;
            let _e786 = phi_1698_;
            let _e788 = phi_1700_;
            let _e790 = phi_1702_;
            local_6 = _e786;
            local_7 = _e784;
            let _e791 = (_e786 <= 32u);
            if _e791 {
                phi_1711_ = _e786;
                phi_1714_ = _e788;
                phi_1716_ = _e790;
                loop {
                    let _e793 = phi_1711_;
                    let _e795 = phi_1714_;
                    let _e797 = phi_1716_;
                    local_1 = _e795;
                    local_2 = _e795;
                    local_3 = _e793;
                    local_4 = _e793;
                    local_9 = _e793;
                    local_10 = _e795;
                    local_11 = _e797;
                    let _e798 = (_e793 <= 32u);
                    let _e801 = (_e798 && !((_e795 >= _e103)));
                    local = _e798;
                    if _e801 {
                        let _e807 = slimbvh_nodes.member[_e795].member[select(_e690, 2u, (2u < _e690))];
                        let _e813 = slimbvh_nodes.member[_e795].member[select(_e691, 2u, (2u < _e691))];
                        let _e819 = slimbvh_nodes.member[_e795].member[select(_e692, 2u, (2u < _e692))];
                        let _e822 = bitcast<u32>(_e153);
                        let _e827 = bitcast<f32>(_e807.x);
                        let _e832 = (_e827 + (f32((_e807.w >> bitcast<u32>(5u))) * _e153));
                        if (_e695 == 0u) {
                            phi_1818_ = SlimbvhTypeM(_e807.z, _e832);
                            phi_1819_ = SlimbvhTypeM(_e807.y, _e827);
                        } else {
                            phi_1818_ = SlimbvhTypeM(_e807.y, _e827);
                            phi_1819_ = SlimbvhTypeM(_e807.z, _e832);
                        }
                        let _e843 = phi_1818_;
                        let _e845 = phi_1819_;
                        let _e849 = bitcast<f32>(((_e822 + ((_e807.w & 31u) << bitcast<u32>(23i))) ^ (_e695 << bitcast<u32>(31i))));
                        let _e889 = bitcast<f32>(_e813.x);
                        let _e894 = (_e889 + (f32((_e813.w >> bitcast<u32>(5u))) * _e153));
                        if (_e698 == 0u) {
                            phi_1878_ = SlimbvhTypeM(_e813.z, _e894);
                            phi_1879_ = SlimbvhTypeM(_e813.y, _e889);
                        } else {
                            phi_1878_ = SlimbvhTypeM(_e813.y, _e889);
                            phi_1879_ = SlimbvhTypeM(_e813.z, _e894);
                        }
                        let _e905 = phi_1878_;
                        let _e907 = phi_1879_;
                        let _e911 = bitcast<f32>(((_e822 + ((_e813.w & 31u) << bitcast<u32>(23i))) ^ (_e698 << bitcast<u32>(31i))));
                        let _e951 = bitcast<f32>(_e819.x);
                        let _e956 = (_e951 + (f32((_e819.w >> bitcast<u32>(5u))) * _e153));
                        if (_e701 == 0u) {
                            phi_1938_ = SlimbvhTypeM(_e819.z, _e956);
                            phi_1939_ = SlimbvhTypeM(_e819.y, _e951);
                        } else {
                            phi_1938_ = SlimbvhTypeM(_e819.y, _e951);
                            phi_1939_ = SlimbvhTypeM(_e819.z, _e956);
                        }
                        let _e967 = phi_1938_;
                        let _e969 = phi_1939_;
                        let _e973 = bitcast<f32>(((_e822 + ((_e819.w & 31u) << bitcast<u32>(23i))) ^ (_e701 << bitcast<u32>(31i))));
                        let _e1009 = (_e849 * _e628);
                        let _e1016 = (((_e845.member_1 - _e625) * _e628) + (bitcast<f32>((bitcast<u32>(_e1009) & 2147483647u)) * -0.00012207031f));
                        let _e1025 = (-(_e849) * _e628);
                        let _e1032 = (((_e843.member_1 - _e626) * _e628) + (bitcast<f32>((bitcast<u32>(_e1025) & 2147483647u)) * 0.00012207031f));
                        let _e1041 = (_e911 * _e644);
                        let _e1048 = (((_e907.member_1 - _e641) * _e644) + (bitcast<f32>((bitcast<u32>(_e1041) & 2147483647u)) * -0.00012207031f));
                        let _e1057 = (-(_e911) * _e644);
                        let _e1064 = (((_e905.member_1 - _e642) * _e644) + (bitcast<f32>((bitcast<u32>(_e1057) & 2147483647u)) * 0.00012207031f));
                        let _e1073 = (_e973 * _e660);
                        let _e1080 = (((_e969.member_1 - _e657) * _e660) + (bitcast<f32>((bitcast<u32>(_e1073) & 2147483647u)) * -0.00012207031f));
                        let _e1085 = ((f32((_e969.member & 255u)) * _e1073) + _e1080);
                        let _e1086 = ((f32(((_e969.member >> bitcast<u32>(8u)) & 255u)) * _e1073) + _e1080);
                        let _e1087 = ((f32(((_e969.member >> bitcast<u32>(16u)) & 255u)) * _e1073) + _e1080);
                        let _e1088 = ((f32(((_e969.member >> bitcast<u32>(24u)) & 255u)) * _e1073) + _e1080);
                        let _e1089 = (-(_e973) * _e660);
                        let _e1096 = (((_e967.member_1 - _e658) * _e660) + (bitcast<f32>((bitcast<u32>(_e1089) & 2147483647u)) * 0.00012207031f));
                        let _e1101 = ((f32((_e967.member & 255u)) * _e1089) + _e1096);
                        let _e1102 = ((f32(((_e967.member >> bitcast<u32>(8u)) & 255u)) * _e1089) + _e1096);
                        let _e1103 = ((f32(((_e967.member >> bitcast<u32>(16u)) & 255u)) * _e1089) + _e1096);
                        let _e1104 = ((f32(((_e967.member >> bitcast<u32>(24u)) & 255u)) * _e1089) + _e1096);
                        let _e1137 = max(max(max(((f32((_e845.member & 255u)) * _e1009) + _e1016), ((f32((_e907.member & 255u)) * _e1041) + _e1048)), _e1085), _e668);
                        let _e1138 = max(max(max(((f32(((_e845.member >> bitcast<u32>(8u)) & 255u)) * _e1009) + _e1016), ((f32(((_e907.member >> bitcast<u32>(8u)) & 255u)) * _e1041) + _e1048)), _e1086), _e668);
                        let _e1139 = max(max(max(((f32(((_e845.member >> bitcast<u32>(16u)) & 255u)) * _e1009) + _e1016), ((f32(((_e907.member >> bitcast<u32>(16u)) & 255u)) * _e1041) + _e1048)), _e1087), _e668);
                        let _e1140 = max(max(max(((f32(((_e845.member >> bitcast<u32>(24u)) & 255u)) * _e1009) + _e1016), ((f32(((_e907.member >> bitcast<u32>(24u)) & 255u)) * _e1041) + _e1048)), _e1088), _e668);
                        let _e1145 = (_e784.member.member_1 + (bitcast<f32>((bitcast<u32>(_e784.member.member_1) & 2147483647u)) * 0.0000004768374f));
                        if (_e1137 <= min((min(min(((f32((_e843.member & 255u)) * _e1025) + _e1032), ((f32((_e905.member & 255u)) * _e1057) + _e1064)), _e1101) + (max(_e1101, -(_e1085)) * 0.0000023841915f)), _e1145)) {
                            phi_2423_ = (((bitcast<u32>(_e1137) ^ select(0u, 4294967288u, _e685.member_1)) & 2147483640u) | 4u);
                        } else {
                            phi_2423_ = 4294967288u;
                        }
                        let _e1160 = phi_2423_;
                        if (_e1138 <= min((min(min(((f32(((_e843.member >> bitcast<u32>(8u)) & 255u)) * _e1025) + _e1032), ((f32(((_e905.member >> bitcast<u32>(8u)) & 255u)) * _e1057) + _e1064)), _e1102) + (max(_e1102, -(_e1086)) * 0.0000023841915f)), _e1145)) {
                            phi_2436_ = ((((bitcast<u32>(_e1138) ^ select(0u, 4294967288u, _e685.member_1)) & 2147483640u) | 4u) | 1u);
                        } else {
                            phi_2436_ = 4294967288u;
                        }
                        let _e1168 = phi_2436_;
                        if (_e1139 <= min((min(min(((f32(((_e843.member >> bitcast<u32>(16u)) & 255u)) * _e1025) + _e1032), ((f32(((_e905.member >> bitcast<u32>(16u)) & 255u)) * _e1057) + _e1064)), _e1103) + (max(_e1103, -(_e1087)) * 0.0000023841915f)), _e1145)) {
                            phi_2449_ = ((((bitcast<u32>(_e1139) ^ select(0u, 4294967288u, _e685.member_1)) & 2147483640u) | 4u) | 2u);
                        } else {
                            phi_2449_ = 4294967288u;
                        }
                        let _e1176 = phi_2449_;
                        if (_e1140 <= min((min(min(((f32(((_e843.member >> bitcast<u32>(24u)) & 255u)) * _e1025) + _e1032), ((f32(((_e905.member >> bitcast<u32>(24u)) & 255u)) * _e1057) + _e1064)), _e1104) + (max(_e1104, -(_e1088)) * 0.0000023841915f)), _e1145)) {
                            phi_2462_ = ((((bitcast<u32>(_e1140) ^ select(0u, 4294967288u, _e685.member_1)) & 2147483640u) | 4u) | 3u);
                        } else {
                            phi_2462_ = 4294967288u;
                        }
                        let _e1184 = phi_2462_;
                        if (_e1160 < _e1168) {
                            phi_4460_ = SlimbvhTypeE(_e1160, _e1168);
                        } else {
                            phi_4460_ = SlimbvhTypeE(_e1168, _e1160);
                        }
                        let _e1189 = phi_4460_;
                        if (_e1176 < _e1184) {
                            phi_4472_ = SlimbvhTypeE(_e1176, _e1184);
                        } else {
                            phi_4472_ = SlimbvhTypeE(_e1184, _e1176);
                        }
                        let _e1196 = phi_4472_;
                        if (_e1189.member < _e1196.member) {
                            phi_4484_ = SlimbvhTypeE(_e1189.member, _e1196.member);
                        } else {
                            phi_4484_ = SlimbvhTypeE(_e1196.member, _e1189.member);
                        }
                        let _e1203 = phi_4484_;
                        if (_e1189.member_1 < _e1196.member_1) {
                            phi_4496_ = SlimbvhTypeE(_e1189.member_1, _e1196.member_1);
                        } else {
                            phi_4496_ = SlimbvhTypeE(_e1196.member_1, _e1189.member_1);
                        }
                        let _e1210 = phi_4496_;
                        if (_e1210.member < _e1203.member_1) {
                            phi_4508_ = SlimbvhTypeE(_e1210.member, _e1203.member_1);
                        } else {
                            phi_4508_ = SlimbvhTypeE(_e1203.member_1, _e1210.member);
                        }
                        let _e1217 = phi_4508_;
                        let _e1232 = (((_e1203.member & 7u) | ((_e1217.member & 7u) << bitcast<u32>(3u))) | (((_e1217.member_1 & 7u) | ((_e1210.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                        if (_e1232 == 0u) {
                            let _e1252 = (_e793 - 1u);
                            let _e1257 = slimbvh_stacks[(((_e1252 % 32u) * 64u) + _e675)];
                            let _e1258 = (_e1257 & 511u);
                            let _e1260 = (_e1258 >> bitcast<u32>(3u));
                            let _e1263 = ((_e1260 == 0u) || (_e1252 == 4294967295u));
                            if _e1263 {
                            } else {
                                slimbvh_stacks[(((_e1252 % 32u) * 64u) + _e675)] = (((_e1257 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1260);
                            }
                            phi_2551_ = select(_e793, _e1252, _e1263);
                            phi_2552_ = (((_e1257 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1258 & 3u) & 3u));
                        } else {
                            let _e1235 = (_e1232 >> bitcast<u32>(3u));
                            if (_e1235 == 0u) {
                                phi_2546_ = _e793;
                            } else {
                                slimbvh_stacks[(((_e793 % 32u) * 64u) + _e675)] = ((_e795 << bitcast<u32>(9u)) | _e1235);
                                phi_2546_ = (_e793 + 1u);
                            }
                            let _e1246 = phi_2546_;
                            phi_2551_ = _e1246;
                            phi_2552_ = ((_e795 << bitcast<u32>(2i)) | ((_e1232 & 3u) & 3u));
                        }
                        let _e1278 = phi_2551_;
                        let _e1280 = phi_2552_;
                        let _e1282 = (_e1280 >> bitcast<u32>(2i));
                        if (_e1282 < _e103) {
                            let _e1288 = slimbvh_nodes.member[_e1282].member_1[(_e1280 & 3u)];
                            phi_2576_ = _e1288;
                        } else {
                            phi_2576_ = 2147483648u;
                        }
                        let _e1290 = phi_2576_;
                        let _e1291 = (_e797 - 1u);
                        phi_1712_ = select(_e1278, 4294967295u, (_e1291 == 0u));
                        phi_1715_ = _e1290;
                        phi_1717_ = _e1291;
                    } else {
                        phi_1712_ = u32();
                        phi_1715_ = u32();
                        phi_1717_ = u32();
                    }
                    let _e1295 = phi_1712_;
                    let _e1297 = phi_1715_;
                    let _e1299 = phi_1717_;
                    continue;
                    continuing {
                        phi_1711_ = _e1295;
                        phi_1714_ = _e1297;
                        phi_1716_ = _e1299;
                        break if !(_e801);
                    }
                }
                let _e1302 = local;
                if _e1302 {
                    let _e1304 = local_1;
                    let _e1307 = local_2;
                    phi_2592_ = _e784;
                    phi_2595_ = SlimbvhTypeE(0u, ((_e1307 >> bitcast<u32>(28u)) & 7u));
                    loop {
                        let _e1313 = phi_2592_;
                        let _e1315 = phi_2595_;
                        local_5 = _e1313;
                        local_8 = _e1313;
                        if (_e1315.member < _e1315.member_1) {
                            phi_2596_ = SlimbvhTypeE((_e1315.member + 1u), _e1315.member_1);
                            phi_2618_ = SlimbvhTypeE(1u, _e1315.member);
                        } else {
                            phi_2596_ = _e1315;
                            phi_2618_ = SlimbvhTypeE(0u, SlimbvhTypeE().member_1);
                        }
                        let _e1328 = phi_2596_;
                        let _e1330 = phi_2618_;
                        let _e1334 = (bitcast<i32>(_e1330.member) != 0i);
                        if _e1334 {
                            let _e1335 = ((_e1304 & 268435455u) + _e1330.member_1);
                            let _e1336 = (_e1335 / 2u);
                            let _e1337 = (_e1335 % 2u);
                            let _e1338 = (_e1336 >= arrayLength((&slimbvh_triangles.member)));
                            if _e1338 {
                                phi_2698_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e1339 = (2u * _e1337);
                                let _e1343 = slimbvh_triangles.member[_e1336][_e1339];
                                let _e1348 = slimbvh_triangles.member[_e1336][(_e1339 + 1u)];
                                let _e1353 = slimbvh_triangles.member[_e1336][(_e1339 + 2u)];
                                if (_e1337 == 0u) {
                                    phi_2697_ = array<vec4<f32>, 3>(_e1343, _e1348, _e1353);
                                } else {
                                    phi_2697_ = array<vec4<f32>, 3>(vec4<f32>(_e1343.z, _e1343.w, _e1348.x, _e1348.y), vec4<f32>(_e1348.z, _e1348.w, _e1353.x, _e1353.y), vec4<f32>(_e1353.z, _e1353.w, 0f, 0f));
                                }
                                let _e1371 = phi_2697_;
                                phi_2698_ = _e1371;
                            }
                            let _e1373 = phi_2698_;
                            let _e1376 = bitcast<u32>(_e1373[2].y);
                            if _e1338 {
                                phi_2779_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e1377 = (2u * _e1337);
                                let _e1381 = slimbvh_triangles.member[_e1336][_e1377];
                                let _e1386 = slimbvh_triangles.member[_e1336][(_e1377 + 1u)];
                                let _e1391 = slimbvh_triangles.member[_e1336][(_e1377 + 2u)];
                                if (_e1337 == 0u) {
                                    phi_2778_ = array<vec4<f32>, 3>(_e1381, _e1386, _e1391);
                                } else {
                                    phi_2778_ = array<vec4<f32>, 3>(vec4<f32>(_e1381.z, _e1381.w, _e1386.x, _e1386.y), vec4<f32>(_e1386.z, _e1386.w, _e1391.x, _e1391.y), vec4<f32>(_e1391.z, _e1391.w, 0f, 0f));
                                }
                                let _e1409 = phi_2778_;
                                phi_2779_ = _e1409;
                            }
                            let _e1411 = phi_2779_;
                            if _e218 {
                                phi_2803_ = array<f32, 3>(_e1411[0].x, _e1411[0].y, _e1411[0].z);
                            } else {
                                if (_e213 == 1u) {
                                    phi_2802_ = array<f32, 3>(_e1411[0].y, _e1411[0].z, _e1411[0].x);
                                } else {
                                    phi_2802_ = array<f32, 3>(_e1411[0].z, _e1411[0].x, _e1411[0].y);
                                }
                                let _e1434 = phi_2802_;
                                phi_2803_ = _e1434;
                            }
                            let _e1437 = phi_2803_;
                            if _e218 {
                                phi_2818_ = array<f32, 3>(_e1411[0].w, _e1411[1].x, _e1411[1].y);
                            } else {
                                if (_e213 == 1u) {
                                    phi_2817_ = array<f32, 3>(_e1411[1].x, _e1411[1].y, _e1411[0].w);
                                } else {
                                    phi_2817_ = array<f32, 3>(_e1411[1].y, _e1411[0].w, _e1411[1].x);
                                }
                                let _e1442 = phi_2817_;
                                phi_2818_ = _e1442;
                            }
                            let _e1445 = phi_2818_;
                            if _e218 {
                                phi_2833_ = array<f32, 3>(_e1411[1].z, _e1411[1].w, _e1411[2].x);
                            } else {
                                if (_e213 == 1u) {
                                    phi_2832_ = array<f32, 3>(_e1411[1].w, _e1411[2].x, _e1411[1].z);
                                } else {
                                    phi_2832_ = array<f32, 3>(_e1411[2].x, _e1411[1].z, _e1411[1].w);
                                }
                                let _e1450 = phi_2832_;
                                phi_2833_ = _e1450;
                            }
                            let _e1453 = phi_2833_;
                            let _e1467 = (_e1437[2] - _e601.member[2]);
                            let _e1470 = (((_e1437[0] - _e601.member[0]) * _e656) - (_e1467 * _e624));
                            let _e1473 = (((_e1437[1] - _e601.member[1]) * _e656) - (_e1467 * _e640));
                            let _e1476 = (_e1445[2] - _e601.member[2]);
                            let _e1479 = (((_e1445[0] - _e601.member[0]) * _e656) - (_e1476 * _e624));
                            let _e1482 = (((_e1445[1] - _e601.member[1]) * _e656) - (_e1476 * _e640));
                            let _e1485 = (_e1453[2] - _e601.member[2]);
                            let _e1488 = (((_e1453[0] - _e601.member[0]) * _e656) - (_e1485 * _e624));
                            let _e1491 = (((_e1453[1] - _e601.member[1]) * _e656) - (_e1485 * _e640));
                            let _e1492 = (_e1488 * _e1482);
                            let _e1493 = (_e1491 * _e1479);
                            let _e1494 = (_e1470 * _e1491);
                            let _e1495 = (_e1473 * _e1488);
                            let _e1496 = (_e1479 * _e1473);
                            let _e1497 = (_e1482 * _e1470);
                            let _e1502 = (((_e1492 >= _e1493) && (_e1494 >= _e1495)) && (_e1496 >= _e1497));
                            let _e1508 = (_e1502 || (((_e1492 <= _e1493) && (_e1494 <= _e1495)) && (_e1496 <= _e1497)));
                            if _e1508 {
                                let _e1510 = select(-1f, 1f, _e1502);
                                let _e1512 = ((_e1492 - _e1493) * _e1510);
                                let _e1514 = select(0f, _e1512, (_e1512 > 0f));
                                let _e1516 = ((_e1494 - _e1495) * _e1510);
                                let _e1518 = select(0f, _e1516, (_e1516 > 0f));
                                let _e1520 = ((_e1496 - _e1497) * _e1510);
                                let _e1522 = select(0f, _e1520, (_e1520 > 0f));
                                let _e1524 = ((_e1514 + _e1518) + _e1522);
                                let _e1539 = ((min(min(_e1437[0], _e1445[0]), _e1453[0]) - _e625) * _e628);
                                let _e1540 = ((max(max(_e1437[0], _e1445[0]), _e1453[0]) - _e626) * _e628);
                                let _e1541 = vec4<f32>(_e1539, f32(), _e1540, f32());
                                let _e1544 = ((min(min(_e1437[1], _e1445[1]), _e1453[1]) - _e641) * _e644);
                                let _e1545 = ((max(max(_e1437[1], _e1445[1]), _e1453[1]) - _e642) * _e644);
                                let _e1546 = vec4<f32>(_e1544, f32(), _e1545, f32());
                                let _e1549 = ((min(min(_e1437[2], _e1445[2]), _e1453[2]) - _e657) * _e660);
                                let _e1550 = ((max(max(_e1437[2], _e1445[2]), _e1453[2]) - _e658) * _e660);
                                let _e1551 = vec4<f32>(_e1549, f32(), _e1550, f32());
                                let _e1552 = vec4<f32>(_e1540, f32(), _e1539, f32());
                                let _e1554 = vec4<f32>(_e1545, f32(), _e1544, f32());
                                let _e1556 = vec4<f32>(_e1550, f32(), _e1549, f32());
                                let _e1565 = max(max(min(_e1541, _e1552).x, min(_e1546, _e1554).x), min(_e1551, _e1556).x);
                                let _e1570 = min(min(max(_e1541, _e1552).x, max(_e1546, _e1554).x), max(_e1551, _e1556).x);
                                let _e1575 = max(_e1565, _e668);
                                let _e1597 = (((((_e1508 && (_e1524 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1470, _e1479), _e1488) <= 0f) && (max(max(_e1470, _e1479), _e1488) >= 0f))) && ((min(min(_e1473, _e1482), _e1491) <= 0f) && (max(max(_e1473, _e1482), _e1491) >= 0f))) && (_e1575 <= (_e1570 + (max(max(_e1551, _e1556).x, -(min(_e1551, _e1556).x)) * 0.0000019073523f)))) && (_e1575 <= _e1313.member.member_1));
                                if _e1597 {
                                    let _e1602 = (_e1445[0] - _e1437[0]);
                                    let _e1603 = (_e1445[1] - _e1437[1]);
                                    let _e1604 = (_e1445[2] - _e1437[2]);
                                    let _e1605 = vec3<f32>(_e1602, _e1603, _e1604);
                                    let _e1606 = (_e1453[0] - _e1445[0]);
                                    let _e1607 = (_e1453[1] - _e1445[1]);
                                    let _e1608 = (_e1453[2] - _e1445[2]);
                                    let _e1609 = vec3<f32>(_e1606, _e1607, _e1608);
                                    let _e1610 = (_e1437[0] - _e1453[0]);
                                    let _e1611 = (_e1437[1] - _e1453[1]);
                                    let _e1612 = (_e1437[2] - _e1453[2]);
                                    let _e1613 = vec3<f32>(_e1610, _e1611, _e1612);
                                    let _e1624 = max(max(bitcast<f32>((bitcast<u32>(_e1602) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1603) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1604) & 2147483647u)));
                                    let _e1635 = max(max(bitcast<f32>((bitcast<u32>(_e1606) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1607) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1608) & 2147483647u)));
                                    let _e1648 = max(max(_e1624, _e1635), max(max(bitcast<f32>((bitcast<u32>(_e1610) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1611) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1612) & 2147483647u))));
                                    if (_e1624 == _e1648) {
                                        phi_3192_ = _e1482;
                                        phi_3193_ = _e1479;
                                        phi_3194_ = _e1473;
                                        phi_3195_ = _e1470;
                                        phi_3196_ = vec3<f32>(_e1437[0], _e1437[1], _e1437[2]);
                                        phi_3197_ = _e1613;
                                        phi_3198_ = _e1609;
                                        phi_3199_ = _e1605;
                                    } else {
                                        let _e1650 = (_e1635 == _e1648);
                                        let _e1655 = vec3(_e1650);
                                        phi_3192_ = select(_e1473, _e1491, _e1650);
                                        phi_3193_ = select(_e1470, _e1488, _e1650);
                                        phi_3194_ = select(_e1491, _e1482, _e1650);
                                        phi_3195_ = select(_e1488, _e1479, _e1650);
                                        phi_3196_ = select(vec3<f32>(_e1453[0], _e1453[1], _e1453[2]), vec3<f32>(_e1445[0], _e1445[1], _e1445[2]), _e1655);
                                        phi_3197_ = select(_e1609, _e1605, _e1655);
                                        phi_3198_ = select(_e1605, _e1613, _e1655);
                                        phi_3199_ = select(_e1613, _e1609, _e1655);
                                    }
                                    let _e1661 = phi_3192_;
                                    let _e1663 = phi_3193_;
                                    let _e1665 = phi_3194_;
                                    let _e1667 = phi_3195_;
                                    let _e1669 = phi_3196_;
                                    let _e1671 = phi_3197_;
                                    let _e1673 = phi_3198_;
                                    let _e1675 = phi_3199_;
                                    let _e1682 = ((_e1673.y * _e1671.z) - (_e1671.y * _e1673.z));
                                    let _e1687 = ((_e1673.z * _e1671.x) - (_e1671.z * _e1673.x));
                                    let _e1690 = ((_e1673.x * _e1671.y) - (_e1671.x * _e1673.y));
                                    let _e1693 = ((_e1514 >= _e1518) && (_e1514 >= _e1522));
                                    let _e1694 = (_e1518 >= _e1522);
                                    let _e1708 = (((_e1682 * (select(select(_e1453[0], _e1445[0], _e1694), _e1437[0], _e1693) - _e601.member[0])) + (_e1687 * (select(select(_e1453[1], _e1445[1], _e1694), _e1437[1], _e1693) - _e601.member[1]))) + (_e1690 * (select(select(_e1453[2], _e1445[2], _e1694), _e1437[2], _e1693) - _e601.member[2])));
                                    let _e1713 = (((_e1682 * _e624) + (_e1687 * _e640)) + (_e1690 * _e656));
                                    let _e1714 = (_e1663 - _e1667);
                                    let _e1715 = (_e1661 - _e1665);
                                    let _e1718 = ((_e1714 * _e1714) + (_e1715 * _e1715));
                                    let _e1725 = (-(((_e1667 * _e1714) + (_e1665 * _e1715))) / select(0.000000000000000000000000000000000000011754944f, _e1718, (_e1718 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e1727 = select(1f, _e1725, (_e1725 < 1f));
                                    let _e1729 = select(0f, _e1727, (_e1727 > 0f));
                                    let _e1738 = ((_e1669.x + (_e1675.x * _e1729)) - _e601.member[0]);
                                    let _e1741 = ((_e1669.y + (_e1675.y * _e1729)) - _e601.member[1]);
                                    let _e1744 = ((_e1669.z + (_e1675.z * _e1729)) - _e601.member[2]);
                                    let _e1809 = ((bitcast<f32>((bitcast<u32>(((((_e1682 * _e1738) + (_e1687 * _e1741)) + (_e1690 * _e1744)) - _e1708)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1738) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1741) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1744) & 2147483647u))), _e1648)) * max(max(bitcast<f32>((bitcast<u32>(_e1682) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1687) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1690) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1713) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1673.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1673.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1673.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1671.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1671.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1671.z) & 2147483647u)))))));
                                    let _e1810 = (_e1708 / _e1713);
                                    if (_e1597 && !(_e1809)) {
                                        let _e1813 = (_e1744 / _e656);
                                        let _e1821 = (((_e1682 * (_e1738 - (_e624 * _e1813))) + (_e1687 * (_e1741 - (_e640 * _e1813)))) / _e1713);
                                        phi_3378_ = select(select(_e1813, (_e1813 + _e1821), (bitcast<f32>((bitcast<u32>(_e1821) & 2147483647u)) <= _e1648)), _e1810, _e1809);
                                    } else {
                                        phi_3378_ = _e1810;
                                    }
                                    let _e1830 = phi_3378_;
                                    let _e1832 = select(_e1570, _e1830, (_e1830 < _e1570));
                                    let _e1834 = select(_e1565, _e1832, (_e1832 > _e1565));
                                    let _e1837 = select(_e1834, 0f, (bitcast<u32>(_e1834) == 2147483648u));
                                    let _e1838 = (1f / _e1524);
                                    phi_3404_ = SlimbvhTypeF(_e1837, (_e1518 * _e1838), (_e1522 * _e1838), ((_e1597 && (_e1837 >= _e668)) && (_e1837 <= _e1313.member.member_1)));
                                    phi_3405_ = SlimbvhTypeF();
                                } else {
                                    phi_3404_ = SlimbvhTypeF();
                                    phi_3405_ = SlimbvhTypeF(0f, 0f, 0f, _e1597);
                                }
                                let _e1847 = phi_3404_;
                                let _e1849 = phi_3405_;
                                phi_3408_ = _e1847;
                                phi_3409_ = _e1849;
                                phi_3410_ = select(true, false, _e1597);
                            } else {
                                phi_3408_ = SlimbvhTypeF();
                                phi_3409_ = SlimbvhTypeF(0f, 0f, 0f, _e1508);
                                phi_3410_ = true;
                            }
                            let _e1852 = phi_3408_;
                            let _e1854 = phi_3409_;
                            let _e1856 = phi_3410_;
                            if _e1856 {
                                phi_3414_ = _e1854;
                            } else {
                                phi_3414_ = _e1852;
                            }
                            let _e1858 = phi_3414_;
                            if _e1858.member_3 {
                                phi_3423_ = SlimbvhTypeG(_e1858.member, _e1858.member_1, _e1858.member_2, _e1376);
                            } else {
                                phi_3423_ = _e99;
                            }
                            let _e1865 = phi_3423_;
                            if (_e1865.member_3 != 4294967295u) {
                                let _e1871 = slimbvh_target.member[0u][0u];
                                let _e1875 = slimbvh_target.member[0u][1u];
                                let _e1879 = slimbvh_target.member[0u][2u];
                                let _e1883 = slimbvh_target.member[0u][3u];
                                let _e1887 = slimbvh_target.member[1u][0u];
                                let _e1891 = slimbvh_target.member[1u][1u];
                                let _e1895 = slimbvh_target.member[1u][2u];
                                let _e1899 = slimbvh_target.member[1u][3u];
                                let _e1900 = bitcast<f32>(_e1871);
                                let _e1901 = bitcast<f32>(_e1875);
                                let _e1902 = bitcast<f32>(_e1879);
                                let _e1904 = bitcast<f32>(_e1887);
                                let _e1905 = array<u32, 3>(_e1891, _e1895, _e1899);
                                if (_e171 < -126i) {
                                    phi_3476_ = -126i;
                                } else {
                                    phi_3476_ = select(_e171, 127i, (_e171 > 127i));
                                }
                                let _e1911 = phi_3476_;
                                let _e1916 = bitcast<f32>((bitcast<u32>((_e1911 + 127i)) << bitcast<u32>(23i)));
                                let _e1922 = bitcast<f32>((bitcast<u32>(((_e171 - _e1911) + 127i)) << bitcast<u32>(23i)));
                                if (_e1883 == 0u) {
                                    phi_3616_ = SlimbvhTypeI(array<f32, 3>(_e1900, _e1901, _e1902), _e1883, _e1904, _e1905);
                                } else {
                                    let _e1924 = bitcast<u32>(_e1900);
                                    let _e1926 = ((_e1924 & 2139095040u) != 0u);
                                    let _e1941 = bitcast<u32>(_e1901);
                                    let _e1943 = ((_e1941 & 2139095040u) != 0u);
                                    let _e1958 = bitcast<u32>(_e1902);
                                    let _e1960 = ((_e1958 & 2139095040u) != 0u);
                                    let _e1976 = bitcast<u32>(_e1904);
                                    let _e1978 = ((_e1976 & 2139095040u) != 0u);
                                    phi_3616_ = SlimbvhTypeI(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1924 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1924 & 2147483648u))), _e1900, _e1926) * _e1916) * select(0.00000011920929f, 1f, _e1926)) * _e1922), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1941 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1941 & 2147483648u))), _e1901, _e1943) * _e1916) * select(0.00000011920929f, 1f, _e1943)) * _e1922), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1958 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1958 & 2147483648u))), _e1902, _e1960) * _e1916) * select(0.00000011920929f, 1f, _e1960)) * _e1922)), _e1883, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1976 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1976 & 2147483648u))), _e1904, _e1978) * _e1916) * select(0.00000011920929f, 1f, _e1978)) * _e1922), _e1905);
                                }
                                let _e1995 = phi_3616_;
                                if (_e1376 == _e672) {
                                    phi_3942_ = false;
                                } else {
                                    let _e1997 = (_e1376 / 16u);
                                    if (_e1997 < arrayLength((&slimbvh_sides.member))) {
                                        let _e2000 = slimbvh_sides.member[_e1997];
                                        phi_3640_ = _e2000;
                                    } else {
                                        phi_3640_ = 0u;
                                    }
                                    let _e2002 = phi_3640_;
                                    let _e2011 = (bitcast<i32>((_e2002 << bitcast<u32>(((30u - ((_e1376 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                    let _e2012 = (_e2011 == 0i);
                                    if _e2012 {
                                        phi_3941_ = true;
                                    } else {
                                        if _e218 {
                                            phi_3669_ = vec3<f32>(_e1437[0], _e1437[1], _e1437[2]);
                                        } else {
                                            if (_e213 == 1u) {
                                                phi_3668_ = vec3<f32>(_e1437[2], _e1437[0], _e1437[1]);
                                            } else {
                                                phi_3668_ = vec3<f32>(_e1437[1], _e1437[2], _e1437[0]);
                                            }
                                            let _e2017 = phi_3668_;
                                            phi_3669_ = _e2017;
                                        }
                                        let _e2020 = phi_3669_;
                                        if _e218 {
                                            phi_3687_ = vec3<f32>(_e1445[0], _e1445[1], _e1445[2]);
                                        } else {
                                            if (_e213 == 1u) {
                                                phi_3686_ = vec3<f32>(_e1445[2], _e1445[0], _e1445[1]);
                                            } else {
                                                phi_3686_ = vec3<f32>(_e1445[1], _e1445[2], _e1445[0]);
                                            }
                                            let _e2025 = phi_3686_;
                                            phi_3687_ = _e2025;
                                        }
                                        let _e2028 = phi_3687_;
                                        if _e218 {
                                            phi_3705_ = vec3<f32>(_e1453[0], _e1453[1], _e1453[2]);
                                        } else {
                                            if (_e213 == 1u) {
                                                phi_3704_ = vec3<f32>(_e1453[2], _e1453[0], _e1453[1]);
                                            } else {
                                                phi_3704_ = vec3<f32>(_e1453[1], _e1453[2], _e1453[0]);
                                            }
                                            let _e2033 = phi_3704_;
                                            phi_3705_ = _e2033;
                                        }
                                        let _e2036 = phi_3705_;
                                        let _e2039 = (_e2028.x - _e2020.x);
                                        let _e2042 = (_e2028.y - _e2020.y);
                                        let _e2045 = (_e2028.z - _e2020.z);
                                        let _e2047 = (_e2036.x - _e2020.x);
                                        let _e2049 = (_e2036.y - _e2020.y);
                                        let _e2051 = (_e2036.z - _e2020.z);
                                        if (_e1995.member_1 == 1u) {
                                            phi_3741_ = (vec3<f32>(_e1995.member[0], _e1995.member[1], _e1995.member[2]) - _e2020);
                                        } else {
                                            phi_3741_ = vec3<f32>(_e1995.member[0], _e1995.member[1], _e1995.member[2]);
                                        }
                                        let _e2066 = phi_3741_;
                                        let _e2072 = bitcast<f32>((bitcast<u32>((_e2039 * _e2049)) ^ _e1995.member_3[0]));
                                        let _e2076 = bitcast<f32>((bitcast<u32>((_e2042 * _e2047)) ^ _e1995.member_3[0]));
                                        let _e2080 = bitcast<f32>((bitcast<u32>((_e2042 * _e2051)) ^ _e1995.member_3[0]));
                                        let _e2084 = bitcast<f32>((bitcast<u32>((_e2045 * _e2049)) ^ _e1995.member_3[0]));
                                        let _e2088 = bitcast<f32>((bitcast<u32>((_e2045 * _e2047)) ^ _e1995.member_3[0]));
                                        let _e2092 = bitcast<f32>((bitcast<u32>((_e2039 * _e2051)) ^ _e1995.member_3[0]));
                                        let _e2093 = (_e2080 - _e2084);
                                        let _e2094 = (_e2088 - _e2092);
                                        let _e2095 = (_e2072 - _e2076);
                                        let _e2119 = (bitcast<f32>((bitcast<u32>(_e2080) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2084) & 2147483647u)));
                                        let _e2126 = (bitcast<f32>((bitcast<u32>(_e2088) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2092) & 2147483647u)));
                                        let _e2133 = (bitcast<f32>((bitcast<u32>(_e2072) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2076) & 2147483647u)));
                                        if (_e1995.member_2 == 0f) {
                                            phi_3923_ = 0f;
                                        } else {
                                            let _e2163 = bitcast<f32>((bitcast<u32>(_e2093) & 2147483647u));
                                            let _e2166 = bitcast<f32>((bitcast<u32>(_e2094) & 2147483647u));
                                            let _e2169 = bitcast<f32>((bitcast<u32>(_e2095) & 2147483647u));
                                            let _e2171 = select(_e2169, _e2166, (_e2166 > _e2169));
                                            let _e2175 = select(_e2169, _e2166, (_e2166 < _e2169));
                                            let _e2179 = select(_e2166, _e2163, (_e2163 < _e2166));
                                            let _e2181 = select(_e2166, _e2163, (_e2163 > _e2166));
                                            let _e2183 = select(_e2169, _e2181, (_e2181 < _e2169));
                                            phi_3923_ = bitcast<f32>((bitcast<u32>((_e1995.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2171, _e2163, (_e2163 > _e2171)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2183, _e2179, (_e2179 > _e2183)))) ^ _e1995.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2175, _e2163, (_e2163 < _e2175)))) ^ _e1995.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2119 + _e2126) + _e2133))) ^ _e1995.member_3[0]))) * 1.0000005f)) ^ _e1995.member_3[0])))) ^ _e1995.member_3[0]));
                                        }
                                        let _e2210 = phi_3923_;
                                        phi_3941_ = (_e2012 || !(((((bitcast<f32>((bitcast<u32>((_e2066.x * _e2093)) ^ _e1995.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2066.y * _e2094)) ^ _e1995.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2066.z * _e2095)) ^ _e1995.member_3[0]))) * f32(-(_e2011))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2066.x) & 2147483647u)) * _e2119)) ^ _e1995.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2066.y) & 2147483647u)) * _e2126)) ^ _e1995.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2066.z) & 2147483647u)) * _e2133)) ^ _e1995.member_3[0]))))) ^ _e1995.member_3[0])) + _e2210) + 0.0000000000000000000000000000000000001880791f))));
                                    }
                                    let _e2224 = phi_3941_;
                                    phi_3942_ = _e2224;
                                }
                                let _e2226 = phi_3942_;
                                if _e2226 {
                                    if (_e1865.member < _e1313.member.member.member) {
                                        phi_3962_ = true;
                                    } else {
                                        if (_e1865.member == _e1313.member.member.member) {
                                            phi_3961_ = (_e1865.member_3 < _e1313.member.member.member_3);
                                        } else {
                                            phi_3961_ = false;
                                        }
                                        let _e2238 = phi_3961_;
                                        phi_3962_ = _e2238;
                                    }
                                    let _e2240 = phi_3962_;
                                    if _e2240 {
                                        phi_3969_ = SlimbvhTypeP(SlimbvhTypeJ(_e1865, _e1865.member), _e1313.member_1);
                                    } else {
                                        phi_3969_ = _e1313;
                                    }
                                    let _e2246 = phi_3969_;
                                    if _e2246.member_1 {
                                        phi_3975_ = SlimbvhTypeP(SlimbvhTypeJ(_e2246.member.member, bitcast<f32>(4286578687u)), _e2246.member_1);
                                    } else {
                                        phi_3975_ = _e2246;
                                    }
                                    let _e2255 = phi_3975_;
                                    phi_3976_ = _e2255;
                                } else {
                                    phi_3976_ = _e1313;
                                }
                                let _e2257 = phi_3976_;
                                phi_3977_ = _e2257;
                            } else {
                                phi_3977_ = _e1313;
                            }
                            let _e2259 = phi_3977_;
                            phi_2593_ = _e2259;
                        } else {
                            phi_2593_ = SlimbvhTypeP();
                        }
                        let _e2261 = phi_2593_;
                        continue;
                        continuing {
                            phi_2592_ = _e2261;
                            phi_2595_ = _e1328;
                            break if !(_e1334);
                        }
                    }
                    let _e2264 = local_3;
                    let _e2265 = (_e2264 - 1u);
                    let _e2270 = slimbvh_stacks[(((_e2265 % 32u) * 64u) + _e675)];
                    let _e2271 = (_e2270 & 511u);
                    let _e2273 = (_e2271 >> bitcast<u32>(3u));
                    let _e2276 = ((_e2273 == 0u) || (_e2265 == 4294967295u));
                    if _e2276 {
                    } else {
                        slimbvh_stacks[(((_e2265 % 32u) * 64u) + _e675)] = (((_e2270 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2273);
                    }
                    let _e2283 = local_4;
                    let _e2291 = (((_e2270 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2271 & 3u) & 3u));
                    let _e2293 = (_e2291 >> bitcast<u32>(2i));
                    if (_e2293 < _e103) {
                        let _e2299 = slimbvh_nodes.member[_e2293].member_1[(_e2291 & 3u)];
                        phi_4038_ = _e2299;
                    } else {
                        phi_4038_ = 2147483648u;
                    }
                    let _e2301 = phi_4038_;
                    let _e2303 = local_5;
                    let _e2588 = local_8;
                    phi_4047_ = _e2588;
                    phi_4048_ = select(select(_e2283, _e2265, _e2276), 4294967295u, (_e668 > _e2303.member.member_1));
                    phi_4049_ = _e2301;
                } else {
                    phi_4047_ = _e784;
                    let _e2591 = local_9;
                    phi_4048_ = _e2591;
                    let _e2594 = local_10;
                    phi_4049_ = _e2594;
                }
                let _e2309 = phi_4047_;
                let _e2311 = phi_4048_;
                let _e2313 = phi_4049_;
                phi_1696_ = _e2309;
                phi_1699_ = _e2311;
                phi_1701_ = _e2313;
                let _e2600 = local_11;
                phi_1703_ = _e2600;
            } else {
                phi_1696_ = SlimbvhTypeP();
                phi_1699_ = u32();
                phi_1701_ = u32();
                phi_1703_ = u32();
            }
            let _e2315 = phi_1696_;
            let _e2317 = phi_1699_;
            let _e2319 = phi_1701_;
            let _e2321 = phi_1703_;
            continue;
            continuing {
                phi_1695_ = _e2315;
                phi_1698_ = _e2317;
                phi_1700_ = _e2319;
                phi_1702_ = _e2321;
                break if !(_e791);
            }
        }
        let _e2324 = local_6;
        let _e2325 = (_e2324 == 4294967295u);
        let _e2327 = local_7;
        if (_e2327.member.member.member_3 != 4294967295u) {
            let _e2333 = -((_e171 + _e601.member_4));
            let _e2334 = bitcast<u32>(_e2327.member.member.member);
            let _e2338 = (bitcast<i32>((_e2334 >> bitcast<u32>(23i))) & 255i);
            let _e2339 = (_e2338 + _e2333);
            if (_e2338 == 255i) {
                phi_4107_ = _e2327.member.member.member;
            } else {
                if (_e2338 > 0i) {
                    if (_e2339 > 0i) {
                        let _e2343 = (_e2339 < 255i);
                        if _e2343 {
                            phi_4086_ = bitcast<f32>((_e2334 + bitcast<u32>((_e2333 << bitcast<u32>(23i)))));
                        } else {
                            phi_4086_ = f32();
                        }
                        let _e2350 = phi_4086_;
                        phi_4088_ = _e2350;
                        phi_4089_ = select(true, false, _e2343);
                    } else {
                        phi_4088_ = f32();
                        phi_4089_ = true;
                    }
                    let _e2353 = phi_4088_;
                    let _e2355 = phi_4089_;
                    phi_4090_ = _e2353;
                    phi_4091_ = _e2355;
                } else {
                    phi_4090_ = f32();
                    phi_4091_ = true;
                }
                let _e2357 = phi_4090_;
                let _e2359 = phi_4091_;
                if _e2359 {
                    let _e2360 = (_e2334 & 2147483648u);
                    let _e2367 = ((_e2334 & 8388607u) | (select(0u, 1u, ((_e2334 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e2371 = (_e2367 == 0u);
                    if _e2371 {
                        phi_4789_ = bitcast<f32>(_e2360);
                    } else {
                        let _e2376 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2367)), 32u, _e2371) - 8u);
                        let _e2379 = (_e2367 << bitcast<u32>((_e2376 & 31u)));
                        let _e2381 = ((_e2339 + select(0i, 1i, (_e2338 == 0i))) - bitcast<i32>(_e2376));
                        if (_e2381 >= 255i) {
                            phi_4779_ = bitcast<f32>((_e2360 | 2139095040u));
                            phi_4780_ = f32();
                            phi_4781_ = true;
                        } else {
                            let _e2383 = (_e2381 > 0i);
                            if _e2383 {
                                phi_4773_ = bitcast<f32>(((_e2360 | (bitcast<u32>(_e2381) << bitcast<u32>(23i))) | (_e2379 & 8388607u)));
                                phi_4774_ = f32();
                            } else {
                                if (_e2381 < -24i) {
                                    phi_4739_ = 26u;
                                } else {
                                    phi_4739_ = bitcast<u32>((1i - _e2381));
                                }
                                let _e2388 = phi_4739_;
                                let _e2389 = (_e2388 & 31u);
                                let _e2391 = (_e2379 >> bitcast<u32>(_e2389));
                                let _e2395 = (_e2379 & ((1u << bitcast<u32>(_e2389)) - 1u));
                                let _e2399 = (1u << bitcast<u32>(((_e2388 - 1u) & 31u)));
                                if (_e2395 > _e2399) {
                                    phi_4760_ = true;
                                } else {
                                    if (_e2395 == _e2399) {
                                        phi_4757_ = ((_e2391 & 1u) == 1u);
                                    } else {
                                        phi_4757_ = false;
                                    }
                                    let _e2405 = phi_4757_;
                                    phi_4760_ = _e2405;
                                }
                                let _e2407 = phi_4760_;
                                phi_4773_ = f32();
                                phi_4774_ = bitcast<f32>((_e2360 | (_e2391 + select(0u, 1u, _e2407))));
                            }
                            let _e2420 = phi_4773_;
                            let _e2422 = phi_4774_;
                            phi_4779_ = _e2420;
                            phi_4780_ = _e2422;
                            phi_4781_ = _e2383;
                        }
                        let _e2426 = phi_4779_;
                        let _e2428 = phi_4780_;
                        let _e2430 = phi_4781_;
                        phi_4789_ = select(_e2428, _e2426, _e2430);
                    }
                    let _e2434 = phi_4789_;
                    phi_4106_ = _e2434;
                } else {
                    phi_4106_ = _e2357;
                }
                let _e2436 = phi_4106_;
                phi_4107_ = _e2436;
            }
            let _e2438 = phi_4107_;
            let _e2439 = bitcast<u32>(_e2438);
            if ((_e2439 & 2147483647u) >= 2139095040u) {
                phi_4119_ = bitcast<f32>(((_e2439 & 2147483648u) | 2139095039u));
            } else {
                phi_4119_ = _e2438;
            }
            let _e2446 = phi_4119_;
            phi_4124_ = SlimbvhTypeG(_e2446, _e2327.member.member.member_1, _e2327.member.member.member_2, _e2327.member.member.member_3);
        } else {
            phi_4124_ = _e99;
        }
        let _e2451 = phi_4124_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2451.member), bitcast<u32>(_e2451.member_1), bitcast<u32>(_e2451.member_2), _e2451.member_3);
        phi_4137_ = _e2325;
        phi_4138_ = _e2325;
        phi_4139_ = select(true, false, _e2325);
    } else {
        phi_4137_ = bool();
        phi_4138_ = false;
        phi_4139_ = true;
    }
    let _e2462 = phi_4137_;
    let _e2464 = phi_4138_;
    let _e2466 = phi_4139_;
    if _e2466 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e2462, _e2464, _e2466)));
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
