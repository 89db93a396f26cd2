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

var<private> slimbvh_lane: SlimbvhTypeN;

var<private> slimbvh_overflowed: SlimbvhTypeN;

fn slimbvh_trace_in_group() {
    var phi_580_: u32;
    var phi_586_: u32;
    var phi_592_: u32;
    var phi_857_: i32;
    var phi_868_: i32;
    var phi_982_: i32;
    var phi_1111_: i32;
    var phi_1133_: u32;
    var phi_1134_: u32;
    var phi_1135_: bool;
    var phi_1169_: i32;
    var phi_1191_: u32;
    var phi_1192_: u32;
    var phi_1193_: bool;
    var phi_754_: i32;
    var phi_760_: u32;
    var phi_779_: u32;
    var phi_780_: u32;
    var phi_781_: bool;
    var phi_799_: i32;
    var phi_805_: u32;
    var phi_824_: u32;
    var phi_825_: u32;
    var phi_826_: bool;
    var phi_1203_: SlimbvhTypeC;
    var phi_1439_: SlimbvhTypeO;
    var phi_1502_: array<f32, 3>;
    var phi_1503_: array<f32, 3>;
    var phi_1521_: array<f32, 3>;
    var phi_1522_: array<f32, 3>;
    var phi_1695_: SlimbvhTypeO;
    var phi_1698_: u32;
    var phi_1700_: u32;
    var phi_1702_: u32;
    var phi_1711_: u32;
    var phi_1714_: u32;
    var phi_1716_: u32;
    var phi_1809_: SlimbvhTypeI;
    var phi_1810_: SlimbvhTypeI;
    var phi_1850_: SlimbvhTypeI;
    var phi_1851_: SlimbvhTypeI;
    var phi_1891_: SlimbvhTypeI;
    var phi_1892_: SlimbvhTypeI;
    var phi_2372_: u32;
    var phi_2385_: u32;
    var phi_2398_: u32;
    var phi_2411_: u32;
    var phi_4678_: SlimbvhTypeD;
    var phi_4690_: SlimbvhTypeD;
    var phi_4702_: SlimbvhTypeD;
    var phi_4714_: SlimbvhTypeD;
    var phi_4726_: SlimbvhTypeD;
    var phi_2495_: u32;
    var phi_2500_: u32;
    var phi_2501_: u32;
    var phi_2558_: u32;
    var phi_2559_: u32;
    var phi_1712_: u32;
    var phi_1715_: u32;
    var phi_1717_: u32;
    var local: bool;
    var local_1: u32;
    var phi_2689_: u32;
    var phi_2765_: u32;
    var phi_2808_: SlimbvhTypeL;
    var phi_2812_: SlimbvhTypeO;
    var phi_2815_: SlimbvhTypeD;
    var phi_2816_: SlimbvhTypeD;
    var phi_2838_: SlimbvhTypeD;
    var phi_2855_: u32;
    var phi_2866_: u32;
    var phi_2882_: u32;
    var phi_2897_: u32;
    var phi_3362_: u32;
    var phi_3380_: u32;
    var phi_3398_: u32;
    var phi_3421_: u32;
    var phi_3439_: u32;
    var phi_3457_: u32;
    var phi_3480_: u32;
    var phi_3498_: u32;
    var phi_3516_: u32;
    var phi_3070_: u32;
    var phi_3085_: u32;
    var phi_3095_: u32;
    var phi_3116_: u32;
    var phi_3137_: u32;
    var phi_3167_: u32;
    var phi_3182_: u32;
    var phi_3192_: u32;
    var phi_3213_: u32;
    var phi_3234_: u32;
    var phi_3264_: u32;
    var phi_3279_: u32;
    var phi_3289_: u32;
    var phi_3310_: u32;
    var phi_3331_: u32;
    var phi_2923_: u32;
    var phi_2972_: u32;
    var phi_3021_: u32;
    var phi_3522_: array<array<f32, 3>, 3>;
    var phi_3887_: f32;
    var phi_3888_: f32;
    var phi_3889_: f32;
    var phi_3890_: f32;
    var phi_3891_: vec3<f32>;
    var phi_3892_: vec3<f32>;
    var phi_3893_: vec3<f32>;
    var phi_3894_: vec3<f32>;
    var phi_4073_: f32;
    var phi_4099_: SlimbvhTypeE;
    var phi_4100_: SlimbvhTypeE;
    var phi_4103_: SlimbvhTypeE;
    var phi_4104_: SlimbvhTypeE;
    var phi_4105_: bool;
    var phi_4109_: SlimbvhTypeE;
    var phi_4118_: SlimbvhTypeF;
    var phi_4145_: bool;
    var phi_4146_: bool;
    var phi_4153_: SlimbvhTypeO;
    var phi_4159_: SlimbvhTypeO;
    var phi_4160_: SlimbvhTypeO;
    var phi_4161_: SlimbvhTypeO;
    var phi_2813_: SlimbvhTypeO;
    var local_2: u32;
    var local_3: u32;
    var phi_4255_: u32;
    var phi_4256_: u32;
    var local_4: SlimbvhTypeO;
    var phi_4265_: SlimbvhTypeO;
    var phi_4266_: u32;
    var phi_4267_: u32;
    var phi_1696_: SlimbvhTypeO;
    var phi_1699_: u32;
    var phi_1701_: u32;
    var phi_1703_: u32;
    var local_5: u32;
    var local_6: SlimbvhTypeO;
    var phi_4304_: f32;
    var phi_4306_: f32;
    var phi_4307_: bool;
    var phi_4308_: f32;
    var phi_4309_: bool;
    var phi_4957_: u32;
    var phi_4975_: bool;
    var phi_4978_: bool;
    var phi_4991_: f32;
    var phi_4992_: f32;
    var phi_4997_: f32;
    var phi_4998_: f32;
    var phi_4999_: bool;
    var phi_5007_: f32;
    var phi_4324_: f32;
    var phi_4325_: f32;
    var phi_4337_: f32;
    var phi_4342_: SlimbvhTypeF;
    var phi_4355_: bool;
    var phi_4356_: bool;
    var phi_4357_: bool;
    var local_7: SlimbvhTypeO;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e115 = SlimbvhTypeF(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e119 = arrayLength((&slimbvh_nodes.member));
    let _e122 = arrayLength((&slimbvh_triangles.member));
    let _e132 = slimbvh_root.member[0u][0u];
    let _e136 = slimbvh_root.member[0u][1u];
    let _e140 = slimbvh_root.member[0u][2u];
    let _e144 = slimbvh_root.member[0u][3u];
    let _e148 = slimbvh_root.member[1u][0u];
    let _e152 = slimbvh_root.member[1u][1u];
    let _e156 = slimbvh_root.member[1u][2u];
    let _e168 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e144) + 127i)) << bitcast<u32>(23i)));
    let _e169 = slimbvh_origin.member;
    let _e175 = slimbvh_origin.member[3u];
    let _e176 = slimbvh_direction.member;
    let _e182 = slimbvh_direction.member[3u];
    let _e185 = slimbvh_exponent.member[0u];
    let _e186 = bitcast<i32>(_e185);
    let _e188 = (bitcast<u32>(_e169.x) & 2147483647u);
    let _e190 = (bitcast<u32>(_e169.y) & 2147483647u);
    let _e192 = (bitcast<u32>(_e169.z) & 2147483647u);
    let _e193 = bitcast<u32>(_e175);
    let _e194 = (_e193 & 2147483647u);
    let _e196 = (bitcast<u32>(_e176.x) & 2147483647u);
    let _e198 = (bitcast<u32>(_e176.y) & 2147483647u);
    let _e200 = (bitcast<u32>(_e176.z) & 2147483647u);
    let _e201 = bitcast<u32>(_e182);
    let _e202 = (_e201 & 2147483647u);
    let _e204 = select(_e198, _e196, (_e198 < _e196));
    let _e206 = select(_e200, _e204, (_e200 < _e204));
    let _e208 = select(_e188, _e206, (_e188 < _e206));
    let _e210 = select(_e190, _e208, (_e190 < _e208));
    let _e212 = select(_e192, _e210, (_e192 < _e210));
    let _e219 = (((select(_e194, _e212, (_e194 < _e212)) < 2139095040u) && (_e202 <= 2139095040u)) && (_e206 > 0u));
    if (_e196 == _e206) {
        phi_580_ = 0u;
    } else {
        phi_580_ = select(2u, 1u, (_e198 == _e206));
    }
    let _e224 = phi_580_;
    let _e225 = (_e224 == 2u);
    if _e225 {
        phi_586_ = 0u;
    } else {
        phi_586_ = (_e224 + 1u);
    }
    let _e228 = phi_586_;
    let _e229 = (_e228 == 2u);
    if _e229 {
        phi_592_ = 0u;
    } else {
        phi_592_ = (_e228 + 1u);
    }
    let _e232 = phi_592_;
    let _e233 = (_e228 == 0u);
    let _e235 = select(select(_e169.y, _e169.x, _e233), _e169.z, _e229);
    let _e236 = (_e232 == 0u);
    let _e238 = (_e232 == 2u);
    let _e239 = select(select(_e169.y, _e169.x, _e236), _e169.z, _e238);
    let _e240 = (_e224 == 0u);
    let _e242 = select(select(_e169.y, _e169.x, _e240), _e169.z, _e225);
    let _e244 = select(select(_e176.y, _e176.x, _e233), _e176.z, _e229);
    let _e246 = select(select(_e176.y, _e176.x, _e236), _e176.z, _e238);
    let _e248 = select(select(_e176.y, _e176.x, _e240), _e176.z, _e225);
    let _e249 = (_e194 - 1u);
    let _e250 = (_e202 - 1u);
    let _e252 = select(_e249, _e250, (_e250 < _e249));
    let _e253 = (_e188 - 1u);
    let _e254 = (_e190 - 1u);
    let _e256 = select(_e253, _e254, (_e254 < _e253));
    let _e257 = (_e192 - 1u);
    let _e259 = select(_e256, _e257, (_e257 < _e256));
    let _e260 = (_e196 - 1u);
    let _e261 = (_e198 - 1u);
    let _e263 = select(_e260, _e261, (_e261 < _e260));
    let _e264 = (_e200 - 1u);
    let _e266 = select(_e263, _e264, (_e264 < _e263));
    let _e268 = select(_e259, _e266, (_e266 < _e259));
    if (((select(_e268, _e252, (_e252 < _e268)) >= 8388607u) && (_e206 < 2130706432u)) && (bitcast<u32>((_e186 + 126i)) <= 253u)) {
        let _e533 = bitcast<i32>((_e206 >> bitcast<u32>(23i)));
        let _e534 = (_e533 - 127i);
        let _e535 = (_e186 + _e534);
        let _e540 = bitcast<f32>((bitcast<u32>((_e186 + 127i)) << bitcast<u32>(23i)));
        let _e545 = bitcast<f32>((bitcast<u32>((254i - _e533)) << bitcast<u32>(23i)));
        if (_e194 >= 2139095040u) {
            phi_754_ = 255i;
        } else {
            phi_754_ = (bitcast<i32>((_e194 >> bitcast<u32>(23i))) + _e535);
        }
        let _e560 = phi_754_;
        if (_e194 == 0u) {
            phi_760_ = 0u;
        } else {
            phi_760_ = (_e194 | 8388608u);
        }
        let _e564 = phi_760_;
        if (_e560 <= 0i) {
            phi_780_ = u32();
            phi_781_ = true;
        } else {
            let _e571 = (_e564 == 0u);
            if _e571 {
                phi_779_ = u32();
            } else {
                phi_779_ = select(((bitcast<u32>(_e560) << bitcast<u32>(23i)) | (_e564 & 8388607u)), 2139095039u, (_e560 >= 255i));
            }
            let _e575 = phi_779_;
            phi_780_ = _e575;
            phi_781_ = _e571;
        }
        let _e577 = phi_780_;
        let _e579 = phi_781_;
        if (_e202 >= 2139095040u) {
            phi_799_ = 255i;
        } else {
            phi_799_ = (bitcast<i32>((_e202 >> bitcast<u32>(23i))) + _e535);
        }
        let _e590 = phi_799_;
        if (_e202 == 0u) {
            phi_805_ = 0u;
        } else {
            phi_805_ = (_e202 | 8388608u);
        }
        let _e594 = phi_805_;
        if (_e590 <= 0i) {
            phi_825_ = u32();
            phi_826_ = true;
        } else {
            let _e601 = (_e594 == 0u);
            if _e601 {
                phi_824_ = u32();
            } else {
                phi_824_ = select(((bitcast<u32>(_e590) << bitcast<u32>(23i)) | (_e594 & 8388607u)), 2139095039u, (_e590 >= 255i));
            }
            let _e605 = phi_824_;
            phi_825_ = _e605;
            phi_826_ = _e601;
        }
        let _e607 = phi_825_;
        let _e609 = phi_826_;
        phi_1203_ = SlimbvhTypeC(array<f32, 3>((_e235 * _e540), (_e239 * _e540), (_e242 * _e540)), array<f32, 3>((_e244 * _e545), (_e246 * _e545), (_e248 * _e545)), bitcast<f32>(((_e193 & 2147483648u) | select(_e577, 0u, _e579))), bitcast<f32>(((_e201 & 2147483648u) | select(_e607, 0u, _e609))), _e534);
    } else {
        let _e281 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e206, _e219))) & 2147483647u);
        if (_e281 >= 8388608u) {
            phi_857_ = (bitcast<i32>((_e281 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_857_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e281)), 32u, (_e281 == 0u))));
        }
        let _e295 = phi_857_;
        let _e296 = (_e186 + _e295);
        if (_e186 < -126i) {
            phi_868_ = -126i;
        } else {
            phi_868_ = select(_e186, 127i, (_e186 > 127i));
        }
        let _e301 = phi_868_;
        let _e306 = bitcast<f32>((bitcast<u32>((_e301 + 127i)) << bitcast<u32>(23i)));
        let _e312 = bitcast<f32>((bitcast<u32>(((_e186 - _e301) + 127i)) << bitcast<u32>(23i)));
        let _e313 = bitcast<u32>(_e235);
        let _e315 = ((_e313 & 2139095040u) != 0u);
        let _e330 = bitcast<u32>(_e239);
        let _e332 = ((_e330 & 2139095040u) != 0u);
        let _e347 = bitcast<u32>(_e242);
        let _e349 = ((_e347 & 2139095040u) != 0u);
        let _e365 = -(_e295);
        if (_e365 < -126i) {
            phi_982_ = -126i;
        } else {
            phi_982_ = select(_e365, 127i, (_e365 > 127i));
        }
        let _e370 = phi_982_;
        let _e375 = bitcast<f32>((bitcast<u32>((_e370 + 127i)) << bitcast<u32>(23i)));
        let _e381 = bitcast<f32>((bitcast<u32>(((_e365 - _e370) + 127i)) << bitcast<u32>(23i)));
        let _e382 = bitcast<u32>(_e244);
        let _e384 = ((_e382 & 2139095040u) != 0u);
        let _e399 = bitcast<u32>(_e246);
        let _e401 = ((_e399 & 2139095040u) != 0u);
        let _e416 = bitcast<u32>(_e248);
        let _e418 = ((_e416 & 2139095040u) != 0u);
        let _e440 = ((_e194 & 8388607u) | (select(0u, 1u, ((_e194 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e443 = bitcast<i32>((_e194 >> bitcast<u32>(23i)));
        let _e450 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e440)), 32u, (_e440 == 0u))) - 8i);
        if (_e443 == 255i) {
            phi_1111_ = 255i;
        } else {
            phi_1111_ = (((_e443 + select(0i, 1i, (_e443 == 0i))) - _e450) + _e296);
        }
        let _e458 = phi_1111_;
        let _e462 = (_e440 << bitcast<u32>(((_e450 & 31i) & 31i)));
        if (_e458 <= 0i) {
            phi_1134_ = u32();
            phi_1135_ = true;
        } else {
            let _e469 = (_e462 == 0u);
            if _e469 {
                phi_1133_ = u32();
            } else {
                phi_1133_ = select(((bitcast<u32>(_e458) << bitcast<u32>(23i)) | (_e462 & 8388607u)), 2139095039u, (_e458 >= 255i));
            }
            let _e473 = phi_1133_;
            phi_1134_ = _e473;
            phi_1135_ = _e469;
        }
        let _e475 = phi_1134_;
        let _e477 = phi_1135_;
        let _e488 = ((_e202 & 8388607u) | (select(0u, 1u, ((_e202 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e491 = bitcast<i32>((_e202 >> bitcast<u32>(23i)));
        let _e498 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e488)), 32u, (_e488 == 0u))) - 8i);
        if (_e491 == 255i) {
            phi_1169_ = 255i;
        } else {
            phi_1169_ = (((_e491 + select(0i, 1i, (_e491 == 0i))) - _e498) + _e296);
        }
        let _e506 = phi_1169_;
        let _e510 = (_e488 << bitcast<u32>(((_e498 & 31i) & 31i)));
        if (_e506 <= 0i) {
            phi_1192_ = u32();
            phi_1193_ = true;
        } else {
            let _e517 = (_e510 == 0u);
            if _e517 {
                phi_1191_ = u32();
            } else {
                phi_1191_ = select(((bitcast<u32>(_e506) << bitcast<u32>(23i)) | (_e510 & 8388607u)), 2139095039u, (_e506 >= 255i));
            }
            let _e521 = phi_1191_;
            phi_1192_ = _e521;
            phi_1193_ = _e517;
        }
        let _e523 = phi_1192_;
        let _e525 = phi_1193_;
        phi_1203_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e313 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e313 & 2147483648u))), _e235, _e315) * _e306) * select(0.00000011920929f, 1f, _e315)) * _e312), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e330 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e330 & 2147483648u))), _e239, _e332) * _e306) * select(0.00000011920929f, 1f, _e332)) * _e312), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e347 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e347 & 2147483648u))), _e242, _e349) * _e306) * select(0.00000011920929f, 1f, _e349)) * _e312)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e382 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e382 & 2147483648u))), _e244, _e384) * _e375) * select(0.00000011920929f, 1f, _e384)) * _e381), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e399 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e399 & 2147483648u))), _e246, _e401) * _e375) * select(0.00000011920929f, 1f, _e401)) * _e381), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e416 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e416 & 2147483648u))), _e248, _e418) * _e375) * select(0.00000011920929f, 1f, _e418)) * _e381)), bitcast<f32>(((_e193 & 2147483648u) | select(_e475, 0u, _e477))), bitcast<f32>(((_e201 & 2147483648u) | select(_e523, 0u, _e525))), _e295);
    }
    let _e616 = phi_1203_;
    let _e631 = (bitcast<f32>((bitcast<u32>(_e616.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e634 = bitcast<f32>((bitcast<u32>(_e616.member[0]) & 2147483647u));
    let _e635 = (_e634 * 0.00000011920929f);
    let _e638 = select(select(0.00000000000011368684f, _e635, (_e635 > 0.00000000000011368684f)), 0f, _e631);
    let _e639 = select(0f, _e616.member_1[0], _e631);
    let _e640 = (_e616.member[0] + _e638);
    let _e641 = (_e616.member[0] - _e638);
    let _e643 = select(38685626000000000000000000f, (1f / _e616.member_1[0]), _e631);
    let _e647 = (bitcast<f32>((bitcast<u32>(_e616.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e650 = bitcast<f32>((bitcast<u32>(_e616.member[1]) & 2147483647u));
    let _e651 = (_e650 * 0.00000011920929f);
    let _e654 = select(select(0.00000000000011368684f, _e651, (_e651 > 0.00000000000011368684f)), 0f, _e647);
    let _e655 = select(0f, _e616.member_1[1], _e647);
    let _e656 = (_e616.member[1] + _e654);
    let _e657 = (_e616.member[1] - _e654);
    let _e659 = select(38685626000000000000000000f, (1f / _e616.member_1[1]), _e647);
    let _e663 = (bitcast<f32>((bitcast<u32>(_e616.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e666 = bitcast<f32>((bitcast<u32>(_e616.member[2]) & 2147483647u));
    let _e667 = (_e666 * 0.00000011920929f);
    let _e670 = select(select(0.00000000000011368684f, _e667, (_e667 > 0.00000000000011368684f)), 0f, _e663);
    let _e671 = select(0f, _e616.member_1[2], _e663);
    let _e672 = (_e616.member[2] + _e670);
    let _e673 = (_e616.member[2] - _e670);
    let _e675 = select(38685626000000000000000000f, (1f / _e616.member_1[2]), _e663);
    let _e677 = select(_e650, _e634, (_e634 > _e650));
    let _e681 = (_e219 && (select(_e666, _e677, (_e677 > _e666)) <= 1099511600000f));
    let _e682 = select(0f, _e616.member_3, _e681);
    let _e683 = select(1f, _e616.member_2, _e681);
    let _e685 = slimbvh_lane.member;
    if (_e685 < 64u) {
        let _e687 = (_e685 % 64u);
        let _e688 = slimbvh_any_will_do.member;
        if (_e688 == 1u) {
            phi_1439_ = SlimbvhTypeO(SlimbvhTypeH(_e115, _e682), true);
        } else {
            phi_1439_ = SlimbvhTypeO(SlimbvhTypeH(_e115, _e682), false);
        }
        let _e695 = phi_1439_;
        let _e700 = (_e228 & 3u);
        let _e701 = (_e232 & 3u);
        let _e702 = (_e224 & 3u);
        let _e715 = (f32(bitcast<i32>(_e132)) * _e168);
        let _e717 = (f32(bitcast<i32>(_e136)) * _e168);
        let _e719 = (f32(bitcast<i32>(_e140)) * _e168);
        let _e720 = (_e700 == 0u);
        if _e720 {
            phi_1503_ = array<f32, 3>(_e715, _e717, _e719);
        } else {
            if (_e700 == 1u) {
                phi_1502_ = array<f32, 3>(_e717, _e719, _e715);
            } else {
                phi_1502_ = array<f32, 3>(_e719, _e715, _e717);
            }
            let _e725 = phi_1502_;
            phi_1503_ = _e725;
        }
        let _e728 = phi_1503_;
        let _e730 = (f32(bitcast<i32>(_e148)) * _e168);
        let _e732 = (f32(bitcast<i32>(_e152)) * _e168);
        let _e734 = (f32(bitcast<i32>(_e156)) * _e168);
        if _e720 {
            phi_1522_ = array<f32, 3>(_e730, _e732, _e734);
        } else {
            if (_e700 == 1u) {
                phi_1521_ = array<f32, 3>(_e732, _e734, _e730);
            } else {
                phi_1521_ = array<f32, 3>(_e734, _e730, _e732);
            }
            let _e739 = phi_1521_;
            phi_1522_ = _e739;
        }
        let _e742 = phi_1522_;
        let _e753 = ((_e728[0] - _e640) * _e643);
        let _e754 = ((_e742[0] - _e641) * _e643);
        let _e755 = vec4<f32>(_e753, f32(), _e754, f32());
        let _e758 = ((_e728[1] - _e656) * _e659);
        let _e759 = ((_e742[1] - _e657) * _e659);
        let _e760 = vec4<f32>(_e758, f32(), _e759, f32());
        let _e763 = ((_e728[2] - _e672) * _e675);
        let _e764 = ((_e742[2] - _e673) * _e675);
        let _e765 = vec4<f32>(_e763, f32(), _e764, f32());
        let _e766 = vec4<f32>(_e754, f32(), _e753, f32());
        let _e768 = vec4<f32>(_e759, f32(), _e758, f32());
        let _e770 = vec4<f32>(_e764, f32(), _e763, f32());
        phi_1695_ = _e695;
        phi_1698_ = select(4294967295u, select(4294967295u, 0u, (_e683 <= _e682)), (max(max(max(min(_e755, _e766).x, min(_e760, _e768).x), min(_e765, _e770).x), _e683) <= min((min(min(max(_e755, _e766).x, max(_e760, _e768).x), max(_e765, _e770).x) + (max(max(_e765, _e770).x, -(min(_e765, _e770).x)) * 0.0000019073523f)), _e695.member.member_1)));
        phi_1700_ = select(0u, 4294967295u, (_e119 == 0u));
        phi_1702_ = (_e119 + 1u);
        loop {
            let _e794 = phi_1695_;
            let _e796 = phi_1698_;
            let _e798 = phi_1700_;
            let _e800 = phi_1702_;
            local_5 = _e796;
            local_6 = _e794;
            let _e801 = (_e796 <= 32u);
            if _e801 {
                phi_1711_ = _e796;
                phi_1714_ = _e798;
                phi_1716_ = _e800;
                loop {
                    let _e803 = phi_1711_;
                    let _e805 = phi_1714_;
                    let _e807 = phi_1716_;
                    local_1 = _e805;
                    local_2 = _e803;
                    local_3 = _e803;
                    local_8 = _e803;
                    local_9 = _e805;
                    local_10 = _e807;
                    let _e808 = (_e803 <= 32u);
                    let _e811 = (_e808 && !((_e805 >= _e119)));
                    local = _e808;
                    if _e811 {
                        let _e816 = slimbvh_nodes.member[_e805][select(_e700, 2u, (2u < _e700))];
                        let _e821 = slimbvh_nodes.member[_e805][select(_e701, 2u, (2u < _e701))];
                        let _e826 = slimbvh_nodes.member[_e805][select(_e702, 2u, (2u < _e702))];
                        let _e829 = bitcast<u32>(_e168);
                        let _e834 = bitcast<f32>(_e816.x);
                        let _e835 = bitcast<f32>((_e829 + ((_e816.w & 31u) << bitcast<u32>(23i))));
                        let _e836 = (_e834 + _e835);
                        if ((bitcast<u32>(_e643) >> bitcast<u32>(31i)) == 0u) {
                            phi_1809_ = SlimbvhTypeI(_e816.z, _e836);
                            phi_1810_ = SlimbvhTypeI(_e816.y, _e834);
                        } else {
                            phi_1809_ = SlimbvhTypeI(_e816.y, _e834);
                            phi_1810_ = SlimbvhTypeI(_e816.z, _e836);
                        }
                        let _e847 = phi_1809_;
                        let _e849 = phi_1810_;
                        let _e888 = bitcast<f32>(_e821.x);
                        let _e889 = bitcast<f32>((_e829 + ((_e821.w & 31u) << bitcast<u32>(23i))));
                        let _e890 = (_e888 + _e889);
                        if ((bitcast<u32>(_e659) >> bitcast<u32>(31i)) == 0u) {
                            phi_1850_ = SlimbvhTypeI(_e821.z, _e890);
                            phi_1851_ = SlimbvhTypeI(_e821.y, _e888);
                        } else {
                            phi_1850_ = SlimbvhTypeI(_e821.y, _e888);
                            phi_1851_ = SlimbvhTypeI(_e821.z, _e890);
                        }
                        let _e901 = phi_1850_;
                        let _e903 = phi_1851_;
                        let _e942 = bitcast<f32>(_e826.x);
                        let _e943 = bitcast<f32>((_e829 + ((_e826.w & 31u) << bitcast<u32>(23i))));
                        let _e944 = (_e942 + _e943);
                        if ((bitcast<u32>(_e675) >> bitcast<u32>(31i)) == 0u) {
                            phi_1891_ = SlimbvhTypeI(_e826.z, _e944);
                            phi_1892_ = SlimbvhTypeI(_e826.y, _e942);
                        } else {
                            phi_1891_ = SlimbvhTypeI(_e826.y, _e942);
                            phi_1892_ = SlimbvhTypeI(_e826.z, _e944);
                        }
                        let _e955 = phi_1891_;
                        let _e957 = phi_1892_;
                        let _e992 = (_e835 * _e643);
                        let _e995 = bitcast<f32>((bitcast<u32>(_e992) & 2147483647u));
                        let _e999 = (((_e849.member_1 - _e640) * _e643) + (_e995 * -0.00012207031f));
                        let _e1011 = (((_e847.member_1 - _e641) * _e643) + (_e995 * 0.00012207031f));
                        let _e1020 = (_e889 * _e659);
                        let _e1023 = bitcast<f32>((bitcast<u32>(_e1020) & 2147483647u));
                        let _e1027 = (((_e903.member_1 - _e656) * _e659) + (_e1023 * -0.00012207031f));
                        let _e1039 = (((_e901.member_1 - _e657) * _e659) + (_e1023 * 0.00012207031f));
                        let _e1048 = (_e943 * _e675);
                        let _e1051 = bitcast<f32>((bitcast<u32>(_e1048) & 2147483647u));
                        let _e1055 = (((_e957.member_1 - _e672) * _e675) + (_e1051 * -0.00012207031f));
                        let _e1060 = ((f32((_e957.member & 255u)) * _e1048) + _e1055);
                        let _e1061 = ((f32(((_e957.member >> bitcast<u32>(8u)) & 255u)) * _e1048) + _e1055);
                        let _e1062 = ((f32(((_e957.member >> bitcast<u32>(16u)) & 255u)) * _e1048) + _e1055);
                        let _e1063 = ((f32(((_e957.member >> bitcast<u32>(24u)) & 255u)) * _e1048) + _e1055);
                        let _e1067 = (((_e955.member_1 - _e673) * _e675) + (_e1051 * 0.00012207031f));
                        let _e1072 = ((f32((_e955.member & 255u)) * _e1048) + _e1067);
                        let _e1073 = ((f32(((_e955.member >> bitcast<u32>(8u)) & 255u)) * _e1048) + _e1067);
                        let _e1074 = ((f32(((_e955.member >> bitcast<u32>(16u)) & 255u)) * _e1048) + _e1067);
                        let _e1075 = ((f32(((_e955.member >> bitcast<u32>(24u)) & 255u)) * _e1048) + _e1067);
                        let _e1108 = max(max(max(((f32((_e849.member & 255u)) * _e992) + _e999), ((f32((_e903.member & 255u)) * _e1020) + _e1027)), _e1060), _e683);
                        let _e1109 = max(max(max(((f32(((_e849.member >> bitcast<u32>(8u)) & 255u)) * _e992) + _e999), ((f32(((_e903.member >> bitcast<u32>(8u)) & 255u)) * _e1020) + _e1027)), _e1061), _e683);
                        let _e1110 = max(max(max(((f32(((_e849.member >> bitcast<u32>(16u)) & 255u)) * _e992) + _e999), ((f32(((_e903.member >> bitcast<u32>(16u)) & 255u)) * _e1020) + _e1027)), _e1062), _e683);
                        let _e1111 = max(max(max(((f32(((_e849.member >> bitcast<u32>(24u)) & 255u)) * _e992) + _e999), ((f32(((_e903.member >> bitcast<u32>(24u)) & 255u)) * _e1020) + _e1027)), _e1063), _e683);
                        let _e1116 = (_e794.member.member_1 + (bitcast<f32>((bitcast<u32>(_e794.member.member_1) & 2147483647u)) * 0.0000004768374f));
                        if (_e1108 <= min((min(min(((f32((_e847.member & 255u)) * _e992) + _e1011), ((f32((_e901.member & 255u)) * _e1020) + _e1039)), _e1072) + (max(_e1072, -(_e1060)) * 0.0000023841915f)), _e1116)) {
                            phi_2372_ = (((bitcast<u32>(_e1108) ^ select(0u, 4294967288u, _e695.member_1)) & 2147483640u) | 4u);
                        } else {
                            phi_2372_ = 4294967288u;
                        }
                        let _e1131 = phi_2372_;
                        if (_e1109 <= min((min(min(((f32(((_e847.member >> bitcast<u32>(8u)) & 255u)) * _e992) + _e1011), ((f32(((_e901.member >> bitcast<u32>(8u)) & 255u)) * _e1020) + _e1039)), _e1073) + (max(_e1073, -(_e1061)) * 0.0000023841915f)), _e1116)) {
                            phi_2385_ = ((((bitcast<u32>(_e1109) ^ select(0u, 4294967288u, _e695.member_1)) & 2147483640u) | 4u) | 1u);
                        } else {
                            phi_2385_ = 4294967288u;
                        }
                        let _e1139 = phi_2385_;
                        if (_e1110 <= min((min(min(((f32(((_e847.member >> bitcast<u32>(16u)) & 255u)) * _e992) + _e1011), ((f32(((_e901.member >> bitcast<u32>(16u)) & 255u)) * _e1020) + _e1039)), _e1074) + (max(_e1074, -(_e1062)) * 0.0000023841915f)), _e1116)) {
                            phi_2398_ = ((((bitcast<u32>(_e1110) ^ select(0u, 4294967288u, _e695.member_1)) & 2147483640u) | 4u) | 2u);
                        } else {
                            phi_2398_ = 4294967288u;
                        }
                        let _e1147 = phi_2398_;
                        if (_e1111 <= min((min(min(((f32(((_e847.member >> bitcast<u32>(24u)) & 255u)) * _e992) + _e1011), ((f32(((_e901.member >> bitcast<u32>(24u)) & 255u)) * _e1020) + _e1039)), _e1075) + (max(_e1075, -(_e1063)) * 0.0000023841915f)), _e1116)) {
                            phi_2411_ = ((((bitcast<u32>(_e1111) ^ select(0u, 4294967288u, _e695.member_1)) & 2147483640u) | 4u) | 3u);
                        } else {
                            phi_2411_ = 4294967288u;
                        }
                        let _e1155 = phi_2411_;
                        if (_e1131 < _e1139) {
                            phi_4678_ = SlimbvhTypeD(_e1131, _e1139);
                        } else {
                            phi_4678_ = SlimbvhTypeD(_e1139, _e1131);
                        }
                        let _e1160 = phi_4678_;
                        if (_e1147 < _e1155) {
                            phi_4690_ = SlimbvhTypeD(_e1147, _e1155);
                        } else {
                            phi_4690_ = SlimbvhTypeD(_e1155, _e1147);
                        }
                        let _e1167 = phi_4690_;
                        if (_e1160.member < _e1167.member) {
                            phi_4702_ = SlimbvhTypeD(_e1160.member, _e1167.member);
                        } else {
                            phi_4702_ = SlimbvhTypeD(_e1167.member, _e1160.member);
                        }
                        let _e1174 = phi_4702_;
                        if (_e1160.member_1 < _e1167.member_1) {
                            phi_4714_ = SlimbvhTypeD(_e1160.member_1, _e1167.member_1);
                        } else {
                            phi_4714_ = SlimbvhTypeD(_e1167.member_1, _e1160.member_1);
                        }
                        let _e1181 = phi_4714_;
                        if (_e1181.member < _e1174.member_1) {
                            phi_4726_ = SlimbvhTypeD(_e1181.member, _e1174.member_1);
                        } else {
                            phi_4726_ = SlimbvhTypeD(_e1174.member_1, _e1181.member);
                        }
                        let _e1188 = phi_4726_;
                        let _e1203 = (((_e1174.member & 7u) | ((_e1188.member & 7u) << bitcast<u32>(3u))) | (((_e1188.member_1 & 7u) | ((_e1181.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                        if (_e1203 == 0u) {
                            let _e1223 = (_e803 - 1u);
                            let _e1228 = slimbvh_stacks[(((_e1223 % 32u) * 64u) + _e687)];
                            let _e1229 = (_e1228 & 511u);
                            let _e1231 = (_e1229 >> bitcast<u32>(3u));
                            let _e1234 = ((_e1231 == 0u) || (_e1223 == 4294967295u));
                            if _e1234 {
                            } else {
                                slimbvh_stacks[(((_e1223 % 32u) * 64u) + _e687)] = (((_e1228 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1231);
                            }
                            phi_2500_ = select(_e803, _e1223, _e1234);
                            phi_2501_ = (((_e1228 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1229 & 3u) & 3u));
                        } else {
                            let _e1206 = (_e1203 >> bitcast<u32>(3u));
                            if (_e1206 == 0u) {
                                phi_2495_ = _e803;
                            } else {
                                slimbvh_stacks[(((_e803 % 32u) * 64u) + _e687)] = ((_e805 << bitcast<u32>(9u)) | _e1206);
                                phi_2495_ = (_e803 + 1u);
                            }
                            let _e1217 = phi_2495_;
                            phi_2500_ = _e1217;
                            phi_2501_ = ((_e805 << bitcast<u32>(2i)) | ((_e1203 & 3u) & 3u));
                        }
                        let _e1249 = phi_2500_;
                        let _e1251 = phi_2501_;
                        let _e1253 = (_e1251 >> bitcast<u32>(2i));
                        if (_e1253 >= _e119) {
                            phi_2559_ = 4294967295u;
                        } else {
                            let _e1258 = slimbvh_nodes.member[_e1253][0u][3u];
                            let _e1262 = slimbvh_nodes.member[_e1253][2u][3u];
                            let _e1273 = ((_e1262 >> bitcast<u32>(5u)) & 65535u);
                            let _e1274 = (_e1251 & 3u);
                            if (((_e1273 >> bitcast<u32>((((4u * _e1274) & 31u) & 31u))) & 8u) != 0u) {
                                let _e1286 = ((_e1273 | (_e1273 << bitcast<u32>(8i))) & 16711935u);
                                phi_2558_ = (((_e1258 >> bitcast<u32>(5u)) | (((_e1262 >> bitcast<u32>(21u)) & 1u) << bitcast<u32>(27u))) + (((((((_e1286 | (_e1286 << bitcast<u32>(4i))) & 252645135u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e1274) & 31u) & 31u))) & 255u));
                            } else {
                                phi_2558_ = (2147483648u | _e1251);
                            }
                            let _e1303 = phi_2558_;
                            phi_2559_ = _e1303;
                        }
                        let _e1305 = phi_2559_;
                        let _e1306 = (_e807 - 1u);
                        phi_1712_ = select(_e1249, 4294967295u, (_e1306 == 0u));
                        phi_1715_ = _e1305;
                        phi_1717_ = _e1306;
                    } else {
                        phi_1712_ = u32();
                        phi_1715_ = u32();
                        phi_1717_ = u32();
                    }
                    let _e1310 = phi_1712_;
                    let _e1312 = phi_1715_;
                    let _e1314 = phi_1717_;
                    continue;
                    continuing {
                        phi_1711_ = _e1310;
                        phi_1714_ = _e1312;
                        phi_1716_ = _e1314;
                        break if !(_e811);
                    }
                }
                let _e1317 = local;
                if _e1317 {
                    let _e1319 = local_1;
                    let _e1320 = (_e1319 & 2147483647u);
                    let _e1322 = (_e1320 >> bitcast<u32>(2i));
                    if (_e1322 >= _e119) {
                        phi_2808_ = SlimbvhTypeL(SlimbvhTypeK(vec4<f32>(0f, 0f, 0f, 0f), 0u), 0u, 0u);
                    } else {
                        let _e1328 = slimbvh_nodes.member[_e1322][select(_e700, 2u, (2u < _e700))];
                        let _e1337 = slimbvh_nodes.member[_e1322][select(_e701, 2u, (2u < _e701))];
                        let _e1346 = slimbvh_nodes.member[_e1322][select(_e702, 2u, (2u < _e702))];
                        let _e1354 = slimbvh_nodes.member[_e1322][0u][3u];
                        let _e1358 = slimbvh_nodes.member[_e1322][1u][3u];
                        let _e1362 = slimbvh_nodes.member[_e1322][2u][3u];
                        let _e1381 = ((_e1362 >> bitcast<u32>(5u)) & 65535u);
                        let _e1384 = ((_e1362 >> bitcast<u32>(23u)) & 255u);
                        let _e1385 = (_e1320 & 3u);
                        switch bitcast<i32>(((_e1384 >> bitcast<u32>((((2u * _e1385) & 31u) & 31u))) & 3u)) {
                            case 0: {
                                phi_2689_ = 0u;
                                break;
                            }
                            case 1: {
                                phi_2689_ = 1u;
                                break;
                            }
                            default: {
                                phi_2689_ = 2u;
                                break;
                            }
                        }
                        let _e1394 = phi_2689_;
                        let _e1399 = (_e1381 >> bitcast<u32>((((4u * _e1385) & 31u) & 31u)));
                        if ((_e1399 & 8u) != 0u) {
                            let _e1450 = ((_e1381 | (_e1381 << bitcast<u32>(8i))) & 16711935u);
                            phi_2765_ = (((_e1354 >> bitcast<u32>(5u)) | (((_e1362 >> bitcast<u32>(21u)) & 1u) << bitcast<u32>(27u))) + (((((((_e1450 | (_e1450 << bitcast<u32>(4i))) & 252645135u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e1385) & 31u) & 31u))) & 255u));
                        } else {
                            let _e1405 = ((_e1381 | (_e1381 << bitcast<u32>(8i))) & 16711935u);
                            let _e1410 = (((_e1405 | (_e1405 << bitcast<u32>(4i))) & 252645135u) & 117901063u);
                            let _e1414 = ((_e1384 | (_e1384 << bitcast<u32>(12i))) & 983055u);
                            let _e1418 = ((_e1414 | (_e1414 << bitcast<u32>(6i))) & 50529027u);
                            phi_2765_ = ((2147483648u | (((_e1399 & 15u) & 7u) << bitcast<u32>(28u))) | ((((_e1358 >> bitcast<u32>(5u)) | (((_e1362 >> bitcast<u32>(22u)) & 1u) << bitcast<u32>(27u))) + (((((4u * _e1410) + (3u * ((_e1410 & ((_e1418 & 16843009u) * 255u)) + (2u * (_e1410 & (((_e1418 >> bitcast<u32>(1i)) & 16843009u) * 255u)))))) * 16843008u) >> bitcast<u32>((((8u * _e1385) & 31u) & 31u))) & 255u)) & 268435455u));
                        }
                        let _e1467 = phi_2765_;
                        let _e1470 = (((8u * _e1385) & 31u) & 31u);
                        phi_2808_ = SlimbvhTypeL(SlimbvhTypeK(vec4<f32>((bitcast<f32>(_e1328.x) + (f32((((_e1328.y >> bitcast<u32>(_e1470)) & 255u) << bitcast<u32>(((_e1328.w & 31u) & 31u)))) * _e168)), (bitcast<f32>(_e1337.x) + (f32((((_e1337.y >> bitcast<u32>(_e1470)) & 255u) << bitcast<u32>(((_e1337.w & 31u) & 31u)))) * _e168)), (bitcast<f32>(_e1346.x) + (f32((((_e1346.y >> bitcast<u32>(_e1470)) & 255u) << bitcast<u32>(((_e1346.w & 31u) & 31u)))) * _e168)), 0f), _e1394), (_e1467 & 268435455u), ((_e1467 >> bitcast<u32>(28u)) & 7u));
                    }
                    let _e1509 = phi_2808_;
                    phi_2812_ = _e794;
                    phi_2815_ = SlimbvhTypeD(0u, _e1509.member_2);
                    loop {
                        let _e1513 = phi_2812_;
                        let _e1515 = phi_2815_;
                        local_4 = _e1513;
                        local_7 = _e1513;
                        if (_e1515.member < _e1515.member_1) {
                            phi_2816_ = SlimbvhTypeD((_e1515.member + 1u), _e1515.member_1);
                            phi_2838_ = SlimbvhTypeD(1u, _e1515.member);
                        } else {
                            phi_2816_ = _e1515;
                            phi_2838_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                        }
                        let _e1528 = phi_2816_;
                        let _e1530 = phi_2838_;
                        let _e1534 = (bitcast<i32>(_e1530.member) != 0i);
                        if _e1534 {
                            switch bitcast<i32>(_e1509.member.member_1) {
                                case 0: {
                                    phi_2855_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2855_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2855_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2855_ = u32();
                                    break;
                                }
                            }
                            let _e1540 = phi_2855_;
                            switch bitcast<i32>(_e1509.member.member_1) {
                                case 0: {
                                    phi_2866_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2866_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2866_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2866_ = u32();
                                    break;
                                }
                            }
                            let _e1547 = phi_2866_;
                            let _e1549 = ((_e1509.member_1 + (_e1530.member_1 * ((3u * _e1540) + 1u))) + (3u * _e1547));
                            if (_e1549 < _e122) {
                                let _e1552 = slimbvh_triangles.member[_e1549];
                                phi_2882_ = _e1552;
                            } else {
                                phi_2882_ = 4294967295u;
                            }
                            let _e1554 = phi_2882_;
                            switch bitcast<i32>(_e1509.member.member_1) {
                                case 0: {
                                    phi_2897_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2897_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2897_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2897_ = u32();
                                    break;
                                }
                            }
                            let _e1558 = phi_2897_;
                            let _e1562 = (_e1509.member_1 + (_e1530.member_1 * ((3u * _e1558) + 1u)));
                            switch bitcast<i32>(_e1509.member.member_1) {
                                case 0: {
                                    if (_e1562 < _e122) {
                                        let _e1842 = slimbvh_triangles.member[_e1562];
                                        phi_2923_ = _e1842;
                                    } else {
                                        phi_2923_ = 0u;
                                    }
                                    let _e1844 = phi_2923_;
                                    let _e1847 = ((10u * _e228) & 31u);
                                    let _e1858 = ((10u * _e232) & 31u);
                                    let _e1869 = ((10u * _e224) & 31u);
                                    let _e1879 = (_e1562 + 1u);
                                    if (_e1879 < _e122) {
                                        let _e1882 = slimbvh_triangles.member[_e1879];
                                        phi_2972_ = _e1882;
                                    } else {
                                        phi_2972_ = 0u;
                                    }
                                    let _e1884 = phi_2972_;
                                    let _e1910 = (_e1562 + 2u);
                                    if (_e1910 < _e122) {
                                        let _e1913 = slimbvh_triangles.member[_e1910];
                                        phi_3021_ = _e1913;
                                    } else {
                                        phi_3021_ = 0u;
                                    }
                                    let _e1915 = phi_3021_;
                                    phi_3522_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1509.member.member.x + ((bitcast<f32>((1258291200u | ((_e1844 >> bitcast<u32>(_e1847)) & 1023u))) - 8388608f) * _e168)), (_e1509.member.member.y + ((bitcast<f32>((1258291200u | ((_e1844 >> bitcast<u32>(_e1858)) & 1023u))) - 8388608f) * _e168)), (_e1509.member.member.z + ((bitcast<f32>((1258291200u | ((_e1844 >> bitcast<u32>(_e1869)) & 1023u))) - 8388608f) * _e168))), array<f32, 3>((_e1509.member.member.x + ((bitcast<f32>((1258291200u | ((_e1884 >> bitcast<u32>(_e1847)) & 1023u))) - 8388608f) * _e168)), (_e1509.member.member.y + ((bitcast<f32>((1258291200u | ((_e1884 >> bitcast<u32>(_e1858)) & 1023u))) - 8388608f) * _e168)), (_e1509.member.member.z + ((bitcast<f32>((1258291200u | ((_e1884 >> bitcast<u32>(_e1869)) & 1023u))) - 8388608f) * _e168))), array<f32, 3>((_e1509.member.member.x + ((bitcast<f32>((1258291200u | ((_e1915 >> bitcast<u32>(_e1847)) & 1023u))) - 8388608f) * _e168)), (_e1509.member.member.y + ((bitcast<f32>((1258291200u | ((_e1915 >> bitcast<u32>(_e1858)) & 1023u))) - 8388608f) * _e168)), (_e1509.member.member.z + ((bitcast<f32>((1258291200u | ((_e1915 >> bitcast<u32>(_e1869)) & 1023u))) - 8388608f) * _e168))));
                                    break;
                                }
                                case 1: {
                                    if (_e1562 < _e122) {
                                        let _e1653 = slimbvh_triangles.member[_e1562];
                                        phi_3070_ = _e1653;
                                    } else {
                                        phi_3070_ = 0u;
                                    }
                                    let _e1655 = phi_3070_;
                                    let _e1656 = (_e1562 + 1u);
                                    if (_e1656 < _e122) {
                                        let _e1659 = slimbvh_triangles.member[_e1656];
                                        phi_3085_ = _e1659;
                                    } else {
                                        phi_3085_ = 0u;
                                    }
                                    let _e1661 = phi_3085_;
                                    let _e1663 = (_e228 == 1u);
                                    if _e1663 {
                                        phi_3095_ = ((_e1655 >> bitcast<u32>(21i)) | (_e1661 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3095_ = (_e1661 >> bitcast<u32>(10i));
                                    }
                                    let _e1672 = phi_3095_;
                                    let _e1681 = (_e232 == 1u);
                                    if _e1681 {
                                        phi_3116_ = ((_e1655 >> bitcast<u32>(21i)) | (_e1661 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3116_ = (_e1661 >> bitcast<u32>(10i));
                                    }
                                    let _e1690 = phi_3116_;
                                    let _e1699 = (_e224 == 1u);
                                    if _e1699 {
                                        phi_3137_ = ((_e1655 >> bitcast<u32>(21i)) | (_e1661 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3137_ = (_e1661 >> bitcast<u32>(10i));
                                    }
                                    let _e1708 = phi_3137_;
                                    let _e1717 = (_e1562 + 2u);
                                    if (_e1717 < _e122) {
                                        let _e1720 = slimbvh_triangles.member[_e1717];
                                        phi_3167_ = _e1720;
                                    } else {
                                        phi_3167_ = 0u;
                                    }
                                    let _e1722 = phi_3167_;
                                    let _e1723 = (_e1562 + 3u);
                                    if (_e1723 < _e122) {
                                        let _e1726 = slimbvh_triangles.member[_e1723];
                                        phi_3182_ = _e1726;
                                    } else {
                                        phi_3182_ = 0u;
                                    }
                                    let _e1728 = phi_3182_;
                                    if _e1663 {
                                        phi_3192_ = ((_e1722 >> bitcast<u32>(21i)) | (_e1728 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3192_ = (_e1728 >> bitcast<u32>(10i));
                                    }
                                    let _e1737 = phi_3192_;
                                    if _e1681 {
                                        phi_3213_ = ((_e1722 >> bitcast<u32>(21i)) | (_e1728 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3213_ = (_e1728 >> bitcast<u32>(10i));
                                    }
                                    let _e1753 = phi_3213_;
                                    if _e1699 {
                                        phi_3234_ = ((_e1722 >> bitcast<u32>(21i)) | (_e1728 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3234_ = (_e1728 >> bitcast<u32>(10i));
                                    }
                                    let _e1769 = phi_3234_;
                                    let _e1778 = (_e1562 + 4u);
                                    if (_e1778 < _e122) {
                                        let _e1781 = slimbvh_triangles.member[_e1778];
                                        phi_3264_ = _e1781;
                                    } else {
                                        phi_3264_ = 0u;
                                    }
                                    let _e1783 = phi_3264_;
                                    let _e1784 = (_e1562 + 5u);
                                    if (_e1784 < _e122) {
                                        let _e1787 = slimbvh_triangles.member[_e1784];
                                        phi_3279_ = _e1787;
                                    } else {
                                        phi_3279_ = 0u;
                                    }
                                    let _e1789 = phi_3279_;
                                    if _e1663 {
                                        phi_3289_ = ((_e1783 >> bitcast<u32>(21i)) | (_e1789 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3289_ = (_e1789 >> bitcast<u32>(10i));
                                    }
                                    let _e1798 = phi_3289_;
                                    if _e1681 {
                                        phi_3310_ = ((_e1783 >> bitcast<u32>(21i)) | (_e1789 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3310_ = (_e1789 >> bitcast<u32>(10i));
                                    }
                                    let _e1814 = phi_3310_;
                                    if _e1699 {
                                        phi_3331_ = ((_e1783 >> bitcast<u32>(21i)) | (_e1789 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3331_ = (_e1789 >> bitcast<u32>(10i));
                                    }
                                    let _e1830 = phi_3331_;
                                    phi_3522_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1509.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1672, _e1655, _e233) & 2097151u))) - 8388608f) * _e168)), (_e1509.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1690, _e1655, _e236) & 2097151u))) - 8388608f) * _e168)), (_e1509.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1708, _e1655, _e240) & 2097151u))) - 8388608f) * _e168))), array<f32, 3>((_e1509.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1737, _e1722, _e233) & 2097151u))) - 8388608f) * _e168)), (_e1509.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1753, _e1722, _e236) & 2097151u))) - 8388608f) * _e168)), (_e1509.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1769, _e1722, _e240) & 2097151u))) - 8388608f) * _e168))), array<f32, 3>((_e1509.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1798, _e1783, _e233) & 2097151u))) - 8388608f) * _e168)), (_e1509.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1814, _e1783, _e236) & 2097151u))) - 8388608f) * _e168)), (_e1509.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1830, _e1783, _e240) & 2097151u))) - 8388608f) * _e168))));
                                    break;
                                }
                                case 2: {
                                    let _e1564 = (_e1562 + _e228);
                                    if (_e1564 < _e122) {
                                        let _e1567 = slimbvh_triangles.member[_e1564];
                                        phi_3362_ = _e1567;
                                    } else {
                                        phi_3362_ = 0u;
                                    }
                                    let _e1569 = phi_3362_;
                                    let _e1573 = (_e1562 + _e232);
                                    if (_e1573 < _e122) {
                                        let _e1576 = slimbvh_triangles.member[_e1573];
                                        phi_3380_ = _e1576;
                                    } else {
                                        phi_3380_ = 0u;
                                    }
                                    let _e1578 = phi_3380_;
                                    let _e1582 = (_e1562 + _e224);
                                    if (_e1582 < _e122) {
                                        let _e1585 = slimbvh_triangles.member[_e1582];
                                        phi_3398_ = _e1585;
                                    } else {
                                        phi_3398_ = 0u;
                                    }
                                    let _e1587 = phi_3398_;
                                    let _e1592 = (_e1562 + 3u);
                                    let _e1593 = (_e1592 + _e228);
                                    if (_e1593 < _e122) {
                                        let _e1596 = slimbvh_triangles.member[_e1593];
                                        phi_3421_ = _e1596;
                                    } else {
                                        phi_3421_ = 0u;
                                    }
                                    let _e1598 = phi_3421_;
                                    let _e1602 = (_e1592 + _e232);
                                    if (_e1602 < _e122) {
                                        let _e1605 = slimbvh_triangles.member[_e1602];
                                        phi_3439_ = _e1605;
                                    } else {
                                        phi_3439_ = 0u;
                                    }
                                    let _e1607 = phi_3439_;
                                    let _e1611 = (_e1592 + _e224);
                                    if (_e1611 < _e122) {
                                        let _e1614 = slimbvh_triangles.member[_e1611];
                                        phi_3457_ = _e1614;
                                    } else {
                                        phi_3457_ = 0u;
                                    }
                                    let _e1616 = phi_3457_;
                                    let _e1621 = (_e1562 + 6u);
                                    let _e1622 = (_e1621 + _e228);
                                    if (_e1622 < _e122) {
                                        let _e1625 = slimbvh_triangles.member[_e1622];
                                        phi_3480_ = _e1625;
                                    } else {
                                        phi_3480_ = 0u;
                                    }
                                    let _e1627 = phi_3480_;
                                    let _e1631 = (_e1621 + _e232);
                                    if (_e1631 < _e122) {
                                        let _e1634 = slimbvh_triangles.member[_e1631];
                                        phi_3498_ = _e1634;
                                    } else {
                                        phi_3498_ = 0u;
                                    }
                                    let _e1636 = phi_3498_;
                                    let _e1640 = (_e1621 + _e224);
                                    if (_e1640 < _e122) {
                                        let _e1643 = slimbvh_triangles.member[_e1640];
                                        phi_3516_ = _e1643;
                                    } else {
                                        phi_3516_ = 0u;
                                    }
                                    let _e1645 = phi_3516_;
                                    phi_3522_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1569)) * _e168), (f32(bitcast<i32>(_e1578)) * _e168), (f32(bitcast<i32>(_e1587)) * _e168)), array<f32, 3>((f32(bitcast<i32>(_e1598)) * _e168), (f32(bitcast<i32>(_e1607)) * _e168), (f32(bitcast<i32>(_e1616)) * _e168)), array<f32, 3>((f32(bitcast<i32>(_e1627)) * _e168), (f32(bitcast<i32>(_e1636)) * _e168), (f32(bitcast<i32>(_e1645)) * _e168)));
                                    break;
                                }
                                default: {
                                    phi_3522_ = array<array<f32, 3>, 3>();
                                    break;
                                }
                            }
                            let _e1943 = phi_3522_;
                            let _e1960 = (_e1943[0][2] - _e616.member[2]);
                            let _e1963 = (((_e1943[0][0] - _e616.member[0]) * _e671) - (_e1960 * _e639));
                            let _e1966 = (((_e1943[0][1] - _e616.member[1]) * _e671) - (_e1960 * _e655));
                            let _e1969 = (_e1943[1][2] - _e616.member[2]);
                            let _e1972 = (((_e1943[1][0] - _e616.member[0]) * _e671) - (_e1969 * _e639));
                            let _e1975 = (((_e1943[1][1] - _e616.member[1]) * _e671) - (_e1969 * _e655));
                            let _e1978 = (_e1943[2][2] - _e616.member[2]);
                            let _e1981 = (((_e1943[2][0] - _e616.member[0]) * _e671) - (_e1978 * _e639));
                            let _e1984 = (((_e1943[2][1] - _e616.member[1]) * _e671) - (_e1978 * _e655));
                            let _e1985 = (_e1981 * _e1975);
                            let _e1986 = (_e1984 * _e1972);
                            let _e1987 = (_e1963 * _e1984);
                            let _e1988 = (_e1966 * _e1981);
                            let _e1989 = (_e1972 * _e1966);
                            let _e1990 = (_e1975 * _e1963);
                            let _e1995 = (((_e1985 >= _e1986) && (_e1987 >= _e1988)) && (_e1989 >= _e1990));
                            let _e2001 = (_e1995 || (((_e1985 <= _e1986) && (_e1987 <= _e1988)) && (_e1989 <= _e1990)));
                            if _e2001 {
                                let _e2003 = select(-1f, 1f, _e1995);
                                let _e2005 = ((_e1985 - _e1986) * _e2003);
                                let _e2007 = select(0f, _e2005, (_e2005 > 0f));
                                let _e2009 = ((_e1987 - _e1988) * _e2003);
                                let _e2011 = select(0f, _e2009, (_e2009 > 0f));
                                let _e2013 = ((_e1989 - _e1990) * _e2003);
                                let _e2015 = select(0f, _e2013, (_e2013 > 0f));
                                let _e2017 = ((_e2007 + _e2011) + _e2015);
                                let _e2032 = ((min(min(_e1943[0][0], _e1943[1][0]), _e1943[2][0]) - _e640) * _e643);
                                let _e2033 = ((max(max(_e1943[0][0], _e1943[1][0]), _e1943[2][0]) - _e641) * _e643);
                                let _e2034 = vec4<f32>(_e2032, f32(), _e2033, f32());
                                let _e2037 = ((min(min(_e1943[0][1], _e1943[1][1]), _e1943[2][1]) - _e656) * _e659);
                                let _e2038 = ((max(max(_e1943[0][1], _e1943[1][1]), _e1943[2][1]) - _e657) * _e659);
                                let _e2039 = vec4<f32>(_e2037, f32(), _e2038, f32());
                                let _e2042 = ((min(min(_e1943[0][2], _e1943[1][2]), _e1943[2][2]) - _e672) * _e675);
                                let _e2043 = ((max(max(_e1943[0][2], _e1943[1][2]), _e1943[2][2]) - _e673) * _e675);
                                let _e2044 = vec4<f32>(_e2042, f32(), _e2043, f32());
                                let _e2045 = vec4<f32>(_e2033, f32(), _e2032, f32());
                                let _e2047 = vec4<f32>(_e2038, f32(), _e2037, f32());
                                let _e2049 = vec4<f32>(_e2043, f32(), _e2042, f32());
                                let _e2058 = max(max(min(_e2034, _e2045).x, min(_e2039, _e2047).x), min(_e2044, _e2049).x);
                                let _e2063 = min(min(max(_e2034, _e2045).x, max(_e2039, _e2047).x), max(_e2044, _e2049).x);
                                let _e2068 = max(_e2058, _e683);
                                let _e2090 = (((((_e2001 && (_e2017 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1963, _e1972), _e1981) <= 0f) && (max(max(_e1963, _e1972), _e1981) >= 0f))) && ((min(min(_e1966, _e1975), _e1984) <= 0f) && (max(max(_e1966, _e1975), _e1984) >= 0f))) && (_e2068 <= (_e2063 + (max(max(_e2044, _e2049).x, -(min(_e2044, _e2049).x)) * 0.0000019073523f)))) && (_e2068 <= _e1513.member.member_1));
                                if _e2090 {
                                    let _e2095 = (_e1943[1][0] - _e1943[0][0]);
                                    let _e2096 = (_e1943[1][1] - _e1943[0][1]);
                                    let _e2097 = (_e1943[1][2] - _e1943[0][2]);
                                    let _e2098 = vec3<f32>(_e2095, _e2096, _e2097);
                                    let _e2099 = (_e1943[2][0] - _e1943[1][0]);
                                    let _e2100 = (_e1943[2][1] - _e1943[1][1]);
                                    let _e2101 = (_e1943[2][2] - _e1943[1][2]);
                                    let _e2102 = vec3<f32>(_e2099, _e2100, _e2101);
                                    let _e2103 = (_e1943[0][0] - _e1943[2][0]);
                                    let _e2104 = (_e1943[0][1] - _e1943[2][1]);
                                    let _e2105 = (_e1943[0][2] - _e1943[2][2]);
                                    let _e2106 = vec3<f32>(_e2103, _e2104, _e2105);
                                    let _e2117 = max(max(bitcast<f32>((bitcast<u32>(_e2095) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2096) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2097) & 2147483647u)));
                                    let _e2128 = max(max(bitcast<f32>((bitcast<u32>(_e2099) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2100) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2101) & 2147483647u)));
                                    let _e2141 = max(max(_e2117, _e2128), max(max(bitcast<f32>((bitcast<u32>(_e2103) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2104) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2105) & 2147483647u))));
                                    if (_e2117 == _e2141) {
                                        phi_3887_ = _e1975;
                                        phi_3888_ = _e1972;
                                        phi_3889_ = _e1966;
                                        phi_3890_ = _e1963;
                                        phi_3891_ = vec3<f32>(_e1943[0][0], _e1943[0][1], _e1943[0][2]);
                                        phi_3892_ = _e2106;
                                        phi_3893_ = _e2102;
                                        phi_3894_ = _e2098;
                                    } else {
                                        let _e2143 = (_e2128 == _e2141);
                                        let _e2148 = vec3(_e2143);
                                        phi_3887_ = select(_e1966, _e1984, _e2143);
                                        phi_3888_ = select(_e1963, _e1981, _e2143);
                                        phi_3889_ = select(_e1984, _e1975, _e2143);
                                        phi_3890_ = select(_e1981, _e1972, _e2143);
                                        phi_3891_ = select(vec3<f32>(_e1943[2][0], _e1943[2][1], _e1943[2][2]), vec3<f32>(_e1943[1][0], _e1943[1][1], _e1943[1][2]), _e2148);
                                        phi_3892_ = select(_e2102, _e2098, _e2148);
                                        phi_3893_ = select(_e2098, _e2106, _e2148);
                                        phi_3894_ = select(_e2106, _e2102, _e2148);
                                    }
                                    let _e2154 = phi_3887_;
                                    let _e2156 = phi_3888_;
                                    let _e2158 = phi_3889_;
                                    let _e2160 = phi_3890_;
                                    let _e2162 = phi_3891_;
                                    let _e2164 = phi_3892_;
                                    let _e2166 = phi_3893_;
                                    let _e2168 = phi_3894_;
                                    let _e2175 = ((_e2166.y * _e2164.z) - (_e2164.y * _e2166.z));
                                    let _e2180 = ((_e2166.z * _e2164.x) - (_e2164.z * _e2166.x));
                                    let _e2183 = ((_e2166.x * _e2164.y) - (_e2164.x * _e2166.y));
                                    let _e2186 = ((_e2007 >= _e2011) && (_e2007 >= _e2015));
                                    let _e2187 = (_e2011 >= _e2015);
                                    let _e2201 = (((_e2175 * (select(select(_e1943[2][0], _e1943[1][0], _e2187), _e1943[0][0], _e2186) - _e616.member[0])) + (_e2180 * (select(select(_e1943[2][1], _e1943[1][1], _e2187), _e1943[0][1], _e2186) - _e616.member[1]))) + (_e2183 * (select(select(_e1943[2][2], _e1943[1][2], _e2187), _e1943[0][2], _e2186) - _e616.member[2])));
                                    let _e2206 = (((_e2175 * _e639) + (_e2180 * _e655)) + (_e2183 * _e671));
                                    let _e2207 = (_e2156 - _e2160);
                                    let _e2208 = (_e2154 - _e2158);
                                    let _e2211 = ((_e2207 * _e2207) + (_e2208 * _e2208));
                                    let _e2218 = (-(((_e2160 * _e2207) + (_e2158 * _e2208))) / select(0.000000000000000000000000000000000000011754944f, _e2211, (_e2211 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e2220 = select(1f, _e2218, (_e2218 < 1f));
                                    let _e2222 = select(0f, _e2220, (_e2220 > 0f));
                                    let _e2231 = ((_e2162.x + (_e2168.x * _e2222)) - _e616.member[0]);
                                    let _e2234 = ((_e2162.y + (_e2168.y * _e2222)) - _e616.member[1]);
                                    let _e2237 = ((_e2162.z + (_e2168.z * _e2222)) - _e616.member[2]);
                                    let _e2302 = ((bitcast<f32>((bitcast<u32>(((((_e2175 * _e2231) + (_e2180 * _e2234)) + (_e2183 * _e2237)) - _e2201)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e2231) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2234) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2237) & 2147483647u))), _e2141)) * max(max(bitcast<f32>((bitcast<u32>(_e2175) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2180) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2183) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e2206) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e2166.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2166.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2166.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e2164.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2164.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2164.z) & 2147483647u)))))));
                                    let _e2303 = (_e2201 / _e2206);
                                    if (_e2090 && !(_e2302)) {
                                        let _e2306 = (_e2237 / _e671);
                                        let _e2314 = (((_e2175 * (_e2231 - (_e639 * _e2306))) + (_e2180 * (_e2234 - (_e655 * _e2306)))) / _e2206);
                                        phi_4073_ = select(select(_e2306, (_e2306 + _e2314), (bitcast<f32>((bitcast<u32>(_e2314) & 2147483647u)) <= _e2141)), _e2303, _e2302);
                                    } else {
                                        phi_4073_ = _e2303;
                                    }
                                    let _e2323 = phi_4073_;
                                    let _e2325 = select(_e2063, _e2323, (_e2323 < _e2063));
                                    let _e2327 = select(_e2058, _e2325, (_e2325 > _e2058));
                                    let _e2330 = select(_e2327, 0f, (bitcast<u32>(_e2327) == 2147483648u));
                                    let _e2331 = (1f / _e2017);
                                    phi_4099_ = SlimbvhTypeE(_e2330, (_e2011 * _e2331), (_e2015 * _e2331), ((_e2090 && (_e2330 >= _e683)) && (_e2330 <= _e1513.member.member_1)));
                                    phi_4100_ = SlimbvhTypeE();
                                } else {
                                    phi_4099_ = SlimbvhTypeE();
                                    phi_4100_ = SlimbvhTypeE(0f, 0f, 0f, _e2090);
                                }
                                let _e2340 = phi_4099_;
                                let _e2342 = phi_4100_;
                                phi_4103_ = _e2340;
                                phi_4104_ = _e2342;
                                phi_4105_ = select(true, false, _e2090);
                            } else {
                                phi_4103_ = SlimbvhTypeE();
                                phi_4104_ = SlimbvhTypeE(0f, 0f, 0f, _e2001);
                                phi_4105_ = true;
                            }
                            let _e2345 = phi_4103_;
                            let _e2347 = phi_4104_;
                            let _e2349 = phi_4105_;
                            if _e2349 {
                                phi_4109_ = _e2347;
                            } else {
                                phi_4109_ = _e2345;
                            }
                            let _e2351 = phi_4109_;
                            if _e2351.member_3 {
                                phi_4118_ = SlimbvhTypeF(_e2351.member, _e2351.member_1, _e2351.member_2, _e1554);
                            } else {
                                phi_4118_ = _e115;
                            }
                            let _e2358 = phi_4118_;
                            if (_e2358.member_3 != 4294967295u) {
                                if (_e1554 != 4294967295u) {
                                    if (_e2358.member < _e1513.member.member.member) {
                                        phi_4146_ = true;
                                    } else {
                                        if (_e2358.member == _e1513.member.member.member) {
                                            phi_4145_ = (_e2358.member_3 < _e1513.member.member.member_3);
                                        } else {
                                            phi_4145_ = false;
                                        }
                                        let _e2373 = phi_4145_;
                                        phi_4146_ = _e2373;
                                    }
                                    let _e2375 = phi_4146_;
                                    if _e2375 {
                                        phi_4153_ = SlimbvhTypeO(SlimbvhTypeH(_e2358, _e2358.member), _e1513.member_1);
                                    } else {
                                        phi_4153_ = _e1513;
                                    }
                                    let _e2381 = phi_4153_;
                                    if _e2381.member_1 {
                                        phi_4159_ = SlimbvhTypeO(SlimbvhTypeH(_e2381.member.member, bitcast<f32>(4286578687u)), _e2381.member_1);
                                    } else {
                                        phi_4159_ = _e2381;
                                    }
                                    let _e2390 = phi_4159_;
                                    phi_4160_ = _e2390;
                                } else {
                                    phi_4160_ = _e1513;
                                }
                                let _e2392 = phi_4160_;
                                phi_4161_ = _e2392;
                            } else {
                                phi_4161_ = _e1513;
                            }
                            let _e2394 = phi_4161_;
                            phi_2813_ = _e2394;
                        } else {
                            phi_2813_ = SlimbvhTypeO();
                        }
                        let _e2396 = phi_2813_;
                        continue;
                        continuing {
                            phi_2812_ = _e2396;
                            phi_2815_ = _e1528;
                            break if !(_e1534);
                        }
                    }
                    let _e2399 = local_2;
                    let _e2400 = (_e2399 - 1u);
                    let _e2405 = slimbvh_stacks[(((_e2400 % 32u) * 64u) + _e687)];
                    let _e2406 = (_e2405 & 511u);
                    let _e2408 = (_e2406 >> bitcast<u32>(3u));
                    let _e2411 = ((_e2408 == 0u) || (_e2400 == 4294967295u));
                    if _e2411 {
                    } else {
                        slimbvh_stacks[(((_e2400 % 32u) * 64u) + _e687)] = (((_e2405 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2408);
                    }
                    let _e2418 = local_3;
                    let _e2426 = (((_e2405 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2406 & 3u) & 3u));
                    let _e2428 = (_e2426 >> bitcast<u32>(2i));
                    if (_e2428 >= _e119) {
                        phi_4256_ = 4294967295u;
                    } else {
                        let _e2433 = slimbvh_nodes.member[_e2428][0u][3u];
                        let _e2437 = slimbvh_nodes.member[_e2428][2u][3u];
                        let _e2448 = ((_e2437 >> bitcast<u32>(5u)) & 65535u);
                        let _e2449 = (_e2426 & 3u);
                        if (((_e2448 >> bitcast<u32>((((4u * _e2449) & 31u) & 31u))) & 8u) != 0u) {
                            let _e2461 = ((_e2448 | (_e2448 << bitcast<u32>(8i))) & 16711935u);
                            phi_4255_ = (((_e2433 >> bitcast<u32>(5u)) | (((_e2437 >> bitcast<u32>(21u)) & 1u) << bitcast<u32>(27u))) + (((((((_e2461 | (_e2461 << bitcast<u32>(4i))) & 252645135u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e2449) & 31u) & 31u))) & 255u));
                        } else {
                            phi_4255_ = (2147483648u | _e2426);
                        }
                        let _e2478 = phi_4255_;
                        phi_4256_ = _e2478;
                    }
                    let _e2480 = phi_4256_;
                    let _e2482 = local_4;
                    let _e2780 = local_7;
                    phi_4265_ = _e2780;
                    phi_4266_ = select(select(_e2418, _e2400, _e2411), 4294967295u, (_e683 > _e2482.member.member_1));
                    phi_4267_ = _e2480;
                } else {
                    phi_4265_ = _e794;
                    let _e2783 = local_8;
                    phi_4266_ = _e2783;
                    let _e2786 = local_9;
                    phi_4267_ = _e2786;
                }
                let _e2488 = phi_4265_;
                let _e2490 = phi_4266_;
                let _e2492 = phi_4267_;
                phi_1696_ = _e2488;
                phi_1699_ = _e2490;
                phi_1701_ = _e2492;
                let _e2792 = local_10;
                phi_1703_ = _e2792;
            } else {
                phi_1696_ = SlimbvhTypeO();
                phi_1699_ = u32();
                phi_1701_ = u32();
                phi_1703_ = u32();
            }
            let _e2494 = phi_1696_;
            let _e2496 = phi_1699_;
            let _e2498 = phi_1701_;
            let _e2500 = phi_1703_;
            continue;
            continuing {
                phi_1695_ = _e2494;
                phi_1698_ = _e2496;
                phi_1700_ = _e2498;
                phi_1702_ = _e2500;
                break if !(_e801);
            }
        }
        let _e2503 = local_5;
        let _e2504 = (_e2503 == 4294967295u);
        let _e2506 = local_6;
        if (_e2506.member.member.member_3 != 4294967295u) {
            let _e2512 = -((_e186 + _e616.member_4));
            let _e2513 = bitcast<u32>(_e2506.member.member.member);
            let _e2517 = (bitcast<i32>((_e2513 >> bitcast<u32>(23i))) & 255i);
            let _e2518 = (_e2517 + _e2512);
            if (_e2517 == 255i) {
                phi_4325_ = _e2506.member.member.member;
            } else {
                if (_e2517 > 0i) {
                    if (_e2518 > 0i) {
                        let _e2522 = (_e2518 < 255i);
                        if _e2522 {
                            phi_4304_ = bitcast<f32>((_e2513 + bitcast<u32>((_e2512 << bitcast<u32>(23i)))));
                        } else {
                            phi_4304_ = f32();
                        }
                        let _e2529 = phi_4304_;
                        phi_4306_ = _e2529;
                        phi_4307_ = select(true, false, _e2522);
                    } else {
                        phi_4306_ = f32();
                        phi_4307_ = true;
                    }
                    let _e2532 = phi_4306_;
                    let _e2534 = phi_4307_;
                    phi_4308_ = _e2532;
                    phi_4309_ = _e2534;
                } else {
                    phi_4308_ = f32();
                    phi_4309_ = true;
                }
                let _e2536 = phi_4308_;
                let _e2538 = phi_4309_;
                if _e2538 {
                    let _e2539 = (_e2513 & 2147483648u);
                    let _e2546 = ((_e2513 & 8388607u) | (select(0u, 1u, ((_e2513 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e2550 = (_e2546 == 0u);
                    if _e2550 {
                        phi_5007_ = bitcast<f32>(_e2539);
                    } else {
                        let _e2555 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2546)), 32u, _e2550) - 8u);
                        let _e2558 = (_e2546 << bitcast<u32>((_e2555 & 31u)));
                        let _e2560 = ((_e2518 + select(0i, 1i, (_e2517 == 0i))) - bitcast<i32>(_e2555));
                        if (_e2560 >= 255i) {
                            phi_4997_ = bitcast<f32>((_e2539 | 2139095040u));
                            phi_4998_ = f32();
                            phi_4999_ = true;
                        } else {
                            let _e2562 = (_e2560 > 0i);
                            if _e2562 {
                                phi_4991_ = bitcast<f32>(((_e2539 | (bitcast<u32>(_e2560) << bitcast<u32>(23i))) | (_e2558 & 8388607u)));
                                phi_4992_ = f32();
                            } else {
                                if (_e2560 < -24i) {
                                    phi_4957_ = 26u;
                                } else {
                                    phi_4957_ = bitcast<u32>((1i - _e2560));
                                }
                                let _e2567 = phi_4957_;
                                let _e2568 = (_e2567 & 31u);
                                let _e2570 = (_e2558 >> bitcast<u32>(_e2568));
                                let _e2574 = (_e2558 & ((1u << bitcast<u32>(_e2568)) - 1u));
                                let _e2578 = (1u << bitcast<u32>(((_e2567 - 1u) & 31u)));
                                if (_e2574 > _e2578) {
                                    phi_4978_ = true;
                                } else {
                                    if (_e2574 == _e2578) {
                                        phi_4975_ = ((_e2570 & 1u) == 1u);
                                    } else {
                                        phi_4975_ = false;
                                    }
                                    let _e2584 = phi_4975_;
                                    phi_4978_ = _e2584;
                                }
                                let _e2586 = phi_4978_;
                                phi_4991_ = f32();
                                phi_4992_ = bitcast<f32>((_e2539 | (_e2570 + select(0u, 1u, _e2586))));
                            }
                            let _e2599 = phi_4991_;
                            let _e2601 = phi_4992_;
                            phi_4997_ = _e2599;
                            phi_4998_ = _e2601;
                            phi_4999_ = _e2562;
                        }
                        let _e2605 = phi_4997_;
                        let _e2607 = phi_4998_;
                        let _e2609 = phi_4999_;
                        phi_5007_ = select(_e2607, _e2605, _e2609);
                    }
                    let _e2613 = phi_5007_;
                    phi_4324_ = _e2613;
                } else {
                    phi_4324_ = _e2536;
                }
                let _e2615 = phi_4324_;
                phi_4325_ = _e2615;
            }
            let _e2617 = phi_4325_;
            let _e2618 = bitcast<u32>(_e2617);
            if ((_e2618 & 2147483647u) >= 2139095040u) {
                phi_4337_ = bitcast<f32>(((_e2618 & 2147483648u) | 2139095039u));
            } else {
                phi_4337_ = _e2617;
            }
            let _e2625 = phi_4337_;
            phi_4342_ = SlimbvhTypeF(_e2625, _e2506.member.member.member_1, _e2506.member.member.member_2, _e2506.member.member.member_3);
        } else {
            phi_4342_ = _e115;
        }
        let _e2630 = phi_4342_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2630.member), bitcast<u32>(_e2630.member_1), bitcast<u32>(_e2630.member_2), _e2630.member_3);
        phi_4355_ = _e2504;
        phi_4356_ = _e2504;
        phi_4357_ = select(true, false, _e2504);
    } else {
        phi_4355_ = bool();
        phi_4356_ = false;
        phi_4357_ = true;
    }
    let _e2641 = phi_4355_;
    let _e2643 = phi_4356_;
    let _e2645 = phi_4357_;
    if _e2645 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e2641, _e2643, _e2645)));
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
