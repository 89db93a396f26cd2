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

var<private> slimbvh_lane: SlimbvhTypeK;

var<private> slimbvh_overflowed: SlimbvhTypeK;

fn slimbvh_trace_in_group() {
    var phi_450_: u32;
    var phi_456_: u32;
    var phi_462_: u32;
    var phi_727_: i32;
    var phi_738_: i32;
    var phi_852_: i32;
    var phi_981_: i32;
    var phi_1003_: u32;
    var phi_1004_: u32;
    var phi_1005_: bool;
    var phi_1039_: i32;
    var phi_1061_: u32;
    var phi_1062_: u32;
    var phi_1063_: bool;
    var phi_624_: i32;
    var phi_630_: u32;
    var phi_649_: u32;
    var phi_650_: u32;
    var phi_651_: bool;
    var phi_669_: i32;
    var phi_675_: u32;
    var phi_694_: u32;
    var phi_695_: u32;
    var phi_696_: bool;
    var phi_1073_: SlimbvhTypeE;
    var phi_1309_: SlimbvhTypeL;
    var phi_1349_: SlimbvhTypeL;
    var phi_1352_: u32;
    var phi_1354_: u32;
    var phi_1356_: u32;
    var phi_1365_: u32;
    var phi_1368_: u32;
    var phi_1370_: u32;
    var phi_1807_: u32;
    var phi_1820_: u32;
    var phi_1833_: u32;
    var phi_1846_: u32;
    var phi_3086_: SlimbvhTypeF;
    var phi_3098_: SlimbvhTypeF;
    var phi_3110_: SlimbvhTypeF;
    var phi_3122_: SlimbvhTypeF;
    var phi_3134_: SlimbvhTypeF;
    var phi_1930_: u32;
    var phi_1935_: u32;
    var phi_1936_: u32;
    var phi_1957_: u32;
    var phi_1366_: u32;
    var phi_1369_: u32;
    var phi_1371_: u32;
    var local: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_1973_: SlimbvhTypeL;
    var phi_1976_: SlimbvhTypeF;
    var phi_1977_: SlimbvhTypeF;
    var phi_1999_: SlimbvhTypeF;
    var phi_2078_: array<vec4<f32>, 3>;
    var phi_2079_: array<vec4<f32>, 3>;
    var phi_2159_: array<vec4<f32>, 3>;
    var phi_2160_: array<vec4<f32>, 3>;
    var phi_2183_: array<f32, 3>;
    var phi_2184_: array<f32, 3>;
    var phi_2198_: array<f32, 3>;
    var phi_2199_: array<f32, 3>;
    var phi_2213_: array<f32, 3>;
    var phi_2214_: array<f32, 3>;
    var phi_2573_: f32;
    var phi_2574_: f32;
    var phi_2575_: f32;
    var phi_2576_: f32;
    var phi_2577_: vec3<f32>;
    var phi_2578_: vec3<f32>;
    var phi_2579_: vec3<f32>;
    var phi_2580_: vec3<f32>;
    var phi_2759_: f32;
    var phi_2785_: SlimbvhTypeG;
    var phi_2786_: SlimbvhTypeG;
    var phi_2789_: SlimbvhTypeG;
    var phi_2790_: SlimbvhTypeG;
    var phi_2791_: bool;
    var phi_2795_: SlimbvhTypeG;
    var phi_2804_: SlimbvhTypeH;
    var phi_2831_: bool;
    var phi_2832_: bool;
    var phi_2839_: SlimbvhTypeL;
    var phi_2845_: SlimbvhTypeL;
    var phi_2846_: SlimbvhTypeL;
    var phi_2847_: SlimbvhTypeL;
    var phi_1974_: SlimbvhTypeL;
    var local_3: u32;
    var local_4: u32;
    var phi_2905_: u32;
    var local_5: SlimbvhTypeL;
    var phi_2914_: SlimbvhTypeL;
    var phi_2915_: u32;
    var phi_2916_: u32;
    var phi_1350_: SlimbvhTypeL;
    var phi_1353_: u32;
    var phi_1355_: u32;
    var phi_1357_: u32;
    var local_6: u32;
    var local_7: SlimbvhTypeL;
    var phi_2953_: f32;
    var phi_2955_: f32;
    var phi_2956_: bool;
    var phi_2957_: f32;
    var phi_2958_: bool;
    var phi_3365_: u32;
    var phi_3383_: bool;
    var phi_3386_: bool;
    var phi_3399_: f32;
    var phi_3400_: f32;
    var phi_3405_: f32;
    var phi_3406_: f32;
    var phi_3407_: bool;
    var phi_3415_: f32;
    var phi_2973_: f32;
    var phi_2974_: f32;
    var phi_2986_: f32;
    var phi_2991_: SlimbvhTypeH;
    var phi_3004_: bool;
    var phi_3005_: bool;
    var phi_3006_: bool;
    var local_8: SlimbvhTypeL;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e82 = SlimbvhTypeH(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e85 = arrayLength((&slimbvh_nodes.member));
    let _e94 = slimbvh_origin.member;
    let _e100 = slimbvh_origin.member[3u];
    let _e101 = slimbvh_direction.member;
    let _e107 = slimbvh_direction.member[3u];
    let _e110 = slimbvh_exponent.member[0u];
    let _e111 = bitcast<i32>(_e110);
    let _e113 = (bitcast<u32>(_e94.x) & 2147483647u);
    let _e115 = (bitcast<u32>(_e94.y) & 2147483647u);
    let _e117 = (bitcast<u32>(_e94.z) & 2147483647u);
    let _e118 = bitcast<u32>(_e100);
    let _e119 = (_e118 & 2147483647u);
    let _e121 = (bitcast<u32>(_e101.x) & 2147483647u);
    let _e123 = (bitcast<u32>(_e101.y) & 2147483647u);
    let _e125 = (bitcast<u32>(_e101.z) & 2147483647u);
    let _e126 = bitcast<u32>(_e107);
    let _e127 = (_e126 & 2147483647u);
    let _e129 = select(_e123, _e121, (_e123 < _e121));
    let _e131 = select(_e125, _e129, (_e125 < _e129));
    let _e133 = select(_e113, _e131, (_e113 < _e131));
    let _e135 = select(_e115, _e133, (_e115 < _e133));
    let _e137 = select(_e117, _e135, (_e117 < _e135));
    let _e144 = (((select(_e119, _e137, (_e119 < _e137)) < 2139095040u) && (_e127 <= 2139095040u)) && (_e131 > 0u));
    if (_e121 == _e131) {
        phi_450_ = 0u;
    } else {
        phi_450_ = select(2u, 1u, (_e123 == _e131));
    }
    let _e149 = phi_450_;
    let _e150 = (_e149 == 2u);
    if _e150 {
        phi_456_ = 0u;
    } else {
        phi_456_ = (_e149 + 1u);
    }
    let _e153 = phi_456_;
    let _e154 = (_e153 == 2u);
    if _e154 {
        phi_462_ = 0u;
    } else {
        phi_462_ = (_e153 + 1u);
    }
    let _e157 = phi_462_;
    let _e158 = (_e153 == 0u);
    let _e160 = select(select(_e94.y, _e94.x, _e158), _e94.z, _e154);
    let _e161 = (_e157 == 0u);
    let _e163 = (_e157 == 2u);
    let _e164 = select(select(_e94.y, _e94.x, _e161), _e94.z, _e163);
    let _e165 = (_e149 == 0u);
    let _e167 = select(select(_e94.y, _e94.x, _e165), _e94.z, _e150);
    let _e169 = select(select(_e101.y, _e101.x, _e158), _e101.z, _e154);
    let _e171 = select(select(_e101.y, _e101.x, _e161), _e101.z, _e163);
    let _e173 = select(select(_e101.y, _e101.x, _e165), _e101.z, _e150);
    let _e174 = (_e119 - 1u);
    let _e175 = (_e127 - 1u);
    let _e177 = select(_e174, _e175, (_e175 < _e174));
    let _e178 = (_e113 - 1u);
    let _e179 = (_e115 - 1u);
    let _e181 = select(_e178, _e179, (_e179 < _e178));
    let _e182 = (_e117 - 1u);
    let _e184 = select(_e181, _e182, (_e182 < _e181));
    let _e185 = (_e121 - 1u);
    let _e186 = (_e123 - 1u);
    let _e188 = select(_e185, _e186, (_e186 < _e185));
    let _e189 = (_e125 - 1u);
    let _e191 = select(_e188, _e189, (_e189 < _e188));
    let _e193 = select(_e184, _e191, (_e191 < _e184));
    if (((select(_e193, _e177, (_e177 < _e193)) >= 8388607u) && (_e131 < 2130706432u)) && (bitcast<u32>((_e111 + 126i)) <= 253u)) {
        let _e458 = bitcast<i32>((_e131 >> bitcast<u32>(23i)));
        let _e459 = (_e458 - 127i);
        let _e460 = (_e111 + _e459);
        let _e465 = bitcast<f32>((bitcast<u32>((_e111 + 127i)) << bitcast<u32>(23i)));
        let _e470 = bitcast<f32>((bitcast<u32>((254i - _e458)) << bitcast<u32>(23i)));
        if (_e119 >= 2139095040u) {
            phi_624_ = 255i;
        } else {
            phi_624_ = (bitcast<i32>((_e119 >> bitcast<u32>(23i))) + _e460);
        }
        let _e485 = phi_624_;
        if (_e119 == 0u) {
            phi_630_ = 0u;
        } else {
            phi_630_ = (_e119 | 8388608u);
        }
        let _e489 = phi_630_;
        if (_e485 <= 0i) {
            phi_650_ = u32();
            phi_651_ = true;
        } else {
            let _e496 = (_e489 == 0u);
            if _e496 {
                phi_649_ = u32();
            } else {
                phi_649_ = select(((bitcast<u32>(_e485) << bitcast<u32>(23i)) | (_e489 & 8388607u)), 2139095039u, (_e485 >= 255i));
            }
            let _e500 = phi_649_;
            phi_650_ = _e500;
            phi_651_ = _e496;
        }
        let _e502 = phi_650_;
        let _e504 = phi_651_;
        if (_e127 >= 2139095040u) {
            phi_669_ = 255i;
        } else {
            phi_669_ = (bitcast<i32>((_e127 >> bitcast<u32>(23i))) + _e460);
        }
        let _e515 = phi_669_;
        if (_e127 == 0u) {
            phi_675_ = 0u;
        } else {
            phi_675_ = (_e127 | 8388608u);
        }
        let _e519 = phi_675_;
        if (_e515 <= 0i) {
            phi_695_ = u32();
            phi_696_ = true;
        } else {
            let _e526 = (_e519 == 0u);
            if _e526 {
                phi_694_ = u32();
            } else {
                phi_694_ = select(((bitcast<u32>(_e515) << bitcast<u32>(23i)) | (_e519 & 8388607u)), 2139095039u, (_e515 >= 255i));
            }
            let _e530 = phi_694_;
            phi_695_ = _e530;
            phi_696_ = _e526;
        }
        let _e532 = phi_695_;
        let _e534 = phi_696_;
        phi_1073_ = SlimbvhTypeE(array<f32, 3>((_e160 * _e465), (_e164 * _e465), (_e167 * _e465)), array<f32, 3>((_e169 * _e470), (_e171 * _e470), (_e173 * _e470)), bitcast<f32>(((_e118 & 2147483648u) | select(_e502, 0u, _e504))), bitcast<f32>(((_e126 & 2147483648u) | select(_e532, 0u, _e534))), _e459);
    } else {
        let _e206 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e131, _e144))) & 2147483647u);
        if (_e206 >= 8388608u) {
            phi_727_ = (bitcast<i32>((_e206 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_727_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e206)), 32u, (_e206 == 0u))));
        }
        let _e220 = phi_727_;
        let _e221 = (_e111 + _e220);
        if (_e111 < -126i) {
            phi_738_ = -126i;
        } else {
            phi_738_ = select(_e111, 127i, (_e111 > 127i));
        }
        let _e226 = phi_738_;
        let _e231 = bitcast<f32>((bitcast<u32>((_e226 + 127i)) << bitcast<u32>(23i)));
        let _e237 = bitcast<f32>((bitcast<u32>(((_e111 - _e226) + 127i)) << bitcast<u32>(23i)));
        let _e238 = bitcast<u32>(_e160);
        let _e240 = ((_e238 & 2139095040u) != 0u);
        let _e255 = bitcast<u32>(_e164);
        let _e257 = ((_e255 & 2139095040u) != 0u);
        let _e272 = bitcast<u32>(_e167);
        let _e274 = ((_e272 & 2139095040u) != 0u);
        let _e290 = -(_e220);
        if (_e290 < -126i) {
            phi_852_ = -126i;
        } else {
            phi_852_ = select(_e290, 127i, (_e290 > 127i));
        }
        let _e295 = phi_852_;
        let _e300 = bitcast<f32>((bitcast<u32>((_e295 + 127i)) << bitcast<u32>(23i)));
        let _e306 = bitcast<f32>((bitcast<u32>(((_e290 - _e295) + 127i)) << bitcast<u32>(23i)));
        let _e307 = bitcast<u32>(_e169);
        let _e309 = ((_e307 & 2139095040u) != 0u);
        let _e324 = bitcast<u32>(_e171);
        let _e326 = ((_e324 & 2139095040u) != 0u);
        let _e341 = bitcast<u32>(_e173);
        let _e343 = ((_e341 & 2139095040u) != 0u);
        let _e365 = ((_e119 & 8388607u) | (select(0u, 1u, ((_e119 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e368 = bitcast<i32>((_e119 >> bitcast<u32>(23i)));
        let _e375 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e365)), 32u, (_e365 == 0u))) - 8i);
        if (_e368 == 255i) {
            phi_981_ = 255i;
        } else {
            phi_981_ = (((_e368 + select(0i, 1i, (_e368 == 0i))) - _e375) + _e221);
        }
        let _e383 = phi_981_;
        let _e387 = (_e365 << bitcast<u32>(((_e375 & 31i) & 31i)));
        if (_e383 <= 0i) {
            phi_1004_ = u32();
            phi_1005_ = true;
        } else {
            let _e394 = (_e387 == 0u);
            if _e394 {
                phi_1003_ = u32();
            } else {
                phi_1003_ = select(((bitcast<u32>(_e383) << bitcast<u32>(23i)) | (_e387 & 8388607u)), 2139095039u, (_e383 >= 255i));
            }
            let _e398 = phi_1003_;
            phi_1004_ = _e398;
            phi_1005_ = _e394;
        }
        let _e400 = phi_1004_;
        let _e402 = phi_1005_;
        let _e413 = ((_e127 & 8388607u) | (select(0u, 1u, ((_e127 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e416 = bitcast<i32>((_e127 >> bitcast<u32>(23i)));
        let _e423 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e413)), 32u, (_e413 == 0u))) - 8i);
        if (_e416 == 255i) {
            phi_1039_ = 255i;
        } else {
            phi_1039_ = (((_e416 + select(0i, 1i, (_e416 == 0i))) - _e423) + _e221);
        }
        let _e431 = phi_1039_;
        let _e435 = (_e413 << bitcast<u32>(((_e423 & 31i) & 31i)));
        if (_e431 <= 0i) {
            phi_1062_ = u32();
            phi_1063_ = true;
        } else {
            let _e442 = (_e435 == 0u);
            if _e442 {
                phi_1061_ = u32();
            } else {
                phi_1061_ = select(((bitcast<u32>(_e431) << bitcast<u32>(23i)) | (_e435 & 8388607u)), 2139095039u, (_e431 >= 255i));
            }
            let _e446 = phi_1061_;
            phi_1062_ = _e446;
            phi_1063_ = _e442;
        }
        let _e448 = phi_1062_;
        let _e450 = phi_1063_;
        phi_1073_ = SlimbvhTypeE(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e238 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e238 & 2147483648u))), _e160, _e240) * _e231) * select(0.00000011920929f, 1f, _e240)) * _e237), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e255 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e255 & 2147483648u))), _e164, _e257) * _e231) * select(0.00000011920929f, 1f, _e257)) * _e237), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e272 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e272 & 2147483648u))), _e167, _e274) * _e231) * select(0.00000011920929f, 1f, _e274)) * _e237)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e307 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e307 & 2147483648u))), _e169, _e309) * _e300) * select(0.00000011920929f, 1f, _e309)) * _e306), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e324 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e324 & 2147483648u))), _e171, _e326) * _e300) * select(0.00000011920929f, 1f, _e326)) * _e306), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e341 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e341 & 2147483648u))), _e173, _e343) * _e300) * select(0.00000011920929f, 1f, _e343)) * _e306)), bitcast<f32>(((_e118 & 2147483648u) | select(_e400, 0u, _e402))), bitcast<f32>(((_e126 & 2147483648u) | select(_e448, 0u, _e450))), _e220);
    }
    let _e541 = phi_1073_;
    let _e556 = (bitcast<f32>((bitcast<u32>(_e541.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e559 = bitcast<f32>((bitcast<u32>(_e541.member[0]) & 2147483647u));
    let _e560 = (_e559 * 0.00000011920929f);
    let _e563 = select(select(0.00000000000011368684f, _e560, (_e560 > 0.00000000000011368684f)), 0f, _e556);
    let _e564 = select(0f, _e541.member_1[0], _e556);
    let _e565 = (_e541.member[0] + _e563);
    let _e566 = (_e541.member[0] - _e563);
    let _e568 = select(38685626000000000000000000f, (1f / _e541.member_1[0]), _e556);
    let _e572 = (bitcast<f32>((bitcast<u32>(_e541.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e575 = bitcast<f32>((bitcast<u32>(_e541.member[1]) & 2147483647u));
    let _e576 = (_e575 * 0.00000011920929f);
    let _e579 = select(select(0.00000000000011368684f, _e576, (_e576 > 0.00000000000011368684f)), 0f, _e572);
    let _e580 = select(0f, _e541.member_1[1], _e572);
    let _e581 = (_e541.member[1] + _e579);
    let _e582 = (_e541.member[1] - _e579);
    let _e584 = select(38685626000000000000000000f, (1f / _e541.member_1[1]), _e572);
    let _e588 = (bitcast<f32>((bitcast<u32>(_e541.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e591 = bitcast<f32>((bitcast<u32>(_e541.member[2]) & 2147483647u));
    let _e592 = (_e591 * 0.00000011920929f);
    let _e595 = select(select(0.00000000000011368684f, _e592, (_e592 > 0.00000000000011368684f)), 0f, _e588);
    let _e596 = select(0f, _e541.member_1[2], _e588);
    let _e597 = (_e541.member[2] + _e595);
    let _e598 = (_e541.member[2] - _e595);
    let _e600 = select(38685626000000000000000000f, (1f / _e541.member_1[2]), _e588);
    let _e602 = select(_e575, _e559, (_e559 > _e575));
    let _e606 = (_e144 && (select(_e591, _e602, (_e602 > _e591)) <= 1099511600000f));
    let _e607 = select(0f, _e541.member_3, _e606);
    let _e608 = select(1f, _e541.member_2, _e606);
    let _e610 = slimbvh_lane.member;
    if (_e610 < 64u) {
        let _e612 = (_e610 % 64u);
        let _e613 = slimbvh_any_will_do.member;
        if (_e613 == 1u) {
            phi_1309_ = SlimbvhTypeL(SlimbvhTypeI(_e82, _e607), true);
        } else {
            phi_1309_ = SlimbvhTypeL(SlimbvhTypeI(_e82, _e607), false);
        }
        let _e620 = phi_1309_;
        phi_1349_ = _e620;
        phi_1352_ = select(4294967295u, 0u, (_e608 <= _e607));
        phi_1354_ = 0u;
        phi_1356_ = (_e85 + 1u);
        loop {
            let _e638 = phi_1349_;
            let _e640 = phi_1352_;
            let _e642 = phi_1354_;
            let _e644 = phi_1356_;
            local_6 = _e640;
            local_7 = _e638;
            let _e645 = (_e640 <= 32u);
            if _e645 {
                phi_1365_ = _e640;
                phi_1368_ = _e642;
                phi_1370_ = _e644;
                loop {
                    let _e647 = phi_1365_;
                    let _e649 = phi_1368_;
                    let _e651 = phi_1370_;
                    local_1 = _e649;
                    local_2 = _e649;
                    local_3 = _e647;
                    local_4 = _e647;
                    local_9 = _e647;
                    local_10 = _e649;
                    local_11 = _e651;
                    let _e652 = (_e647 <= 32u);
                    let _e655 = (_e652 && !((_e649 >= _e85)));
                    local = _e652;
                    if _e655 {
                        let _e657 = ((2u * (_e153 & 3u)) + (bitcast<u32>(_e568) >> bitcast<u32>(31i)));
                        let _e659 = ((2u * (_e157 & 3u)) + (bitcast<u32>(_e584) >> bitcast<u32>(31i)));
                        let _e661 = ((2u * (_e149 & 3u)) + (bitcast<u32>(_e600) >> bitcast<u32>(31i)));
                        let _e668 = slimbvh_nodes.member[_e649].member[select(_e657, 5u, (5u < _e657))];
                        let _e675 = slimbvh_nodes.member[_e649].member[select(_e659, 5u, (5u < _e659))];
                        let _e682 = slimbvh_nodes.member[_e649].member[select(_e661, 5u, (5u < _e661))];
                        let _e683 = (_e657 ^ 1u);
                        let _e690 = slimbvh_nodes.member[_e649].member[select(_e683, 5u, (5u < _e683))];
                        let _e691 = (_e659 ^ 1u);
                        let _e698 = slimbvh_nodes.member[_e649].member[select(_e691, 5u, (5u < _e691))];
                        let _e699 = (_e661 ^ 1u);
                        let _e706 = slimbvh_nodes.member[_e649].member[select(_e699, 5u, (5u < _e699))];
                        let _e765 = ((_e682.x - _e597) * _e600);
                        let _e766 = ((_e682.y - _e597) * _e600);
                        let _e767 = ((_e682.z - _e597) * _e600);
                        let _e768 = ((_e682.w - _e597) * _e600);
                        let _e777 = ((_e706.x - _e598) * _e600);
                        let _e778 = ((_e706.y - _e598) * _e600);
                        let _e779 = ((_e706.z - _e598) * _e600);
                        let _e780 = ((_e706.w - _e598) * _e600);
                        let _e813 = max(max(max(((_e668.x - _e565) * _e568), ((_e675.x - _e581) * _e584)), _e765), _e608);
                        let _e814 = max(max(max(((_e668.y - _e565) * _e568), ((_e675.y - _e581) * _e584)), _e766), _e608);
                        let _e815 = max(max(max(((_e668.z - _e565) * _e568), ((_e675.z - _e581) * _e584)), _e767), _e608);
                        let _e816 = max(max(max(((_e668.w - _e565) * _e568), ((_e675.w - _e581) * _e584)), _e768), _e608);
                        if (_e813 <= min((min(min(((_e690.x - _e566) * _e568), ((_e698.x - _e582) * _e584)), _e777) + (max(_e777, -(_e765)) * 0.0000019073523f)), _e638.member.member_1)) {
                            phi_1807_ = (((bitcast<u32>(_e813) ^ select(0u, 4294967288u, _e620.member_1)) & 2147483640u) | 4u);
                        } else {
                            phi_1807_ = 4294967288u;
                        }
                        let _e831 = phi_1807_;
                        if (_e814 <= min((min(min(((_e690.y - _e566) * _e568), ((_e698.y - _e582) * _e584)), _e778) + (max(_e778, -(_e766)) * 0.0000019073523f)), _e638.member.member_1)) {
                            phi_1820_ = ((((bitcast<u32>(_e814) ^ select(0u, 4294967288u, _e620.member_1)) & 2147483640u) | 4u) | 1u);
                        } else {
                            phi_1820_ = 4294967288u;
                        }
                        let _e839 = phi_1820_;
                        if (_e815 <= min((min(min(((_e690.z - _e566) * _e568), ((_e698.z - _e582) * _e584)), _e779) + (max(_e779, -(_e767)) * 0.0000019073523f)), _e638.member.member_1)) {
                            phi_1833_ = ((((bitcast<u32>(_e815) ^ select(0u, 4294967288u, _e620.member_1)) & 2147483640u) | 4u) | 2u);
                        } else {
                            phi_1833_ = 4294967288u;
                        }
                        let _e847 = phi_1833_;
                        if (_e816 <= min((min(min(((_e690.w - _e566) * _e568), ((_e698.w - _e582) * _e584)), _e780) + (max(_e780, -(_e768)) * 0.0000019073523f)), _e638.member.member_1)) {
                            phi_1846_ = ((((bitcast<u32>(_e816) ^ select(0u, 4294967288u, _e620.member_1)) & 2147483640u) | 4u) | 3u);
                        } else {
                            phi_1846_ = 4294967288u;
                        }
                        let _e855 = phi_1846_;
                        if (_e831 < _e839) {
                            phi_3086_ = SlimbvhTypeF(_e831, _e839);
                        } else {
                            phi_3086_ = SlimbvhTypeF(_e839, _e831);
                        }
                        let _e860 = phi_3086_;
                        if (_e847 < _e855) {
                            phi_3098_ = SlimbvhTypeF(_e847, _e855);
                        } else {
                            phi_3098_ = SlimbvhTypeF(_e855, _e847);
                        }
                        let _e867 = phi_3098_;
                        if (_e860.member < _e867.member) {
                            phi_3110_ = SlimbvhTypeF(_e860.member, _e867.member);
                        } else {
                            phi_3110_ = SlimbvhTypeF(_e867.member, _e860.member);
                        }
                        let _e874 = phi_3110_;
                        if (_e860.member_1 < _e867.member_1) {
                            phi_3122_ = SlimbvhTypeF(_e860.member_1, _e867.member_1);
                        } else {
                            phi_3122_ = SlimbvhTypeF(_e867.member_1, _e860.member_1);
                        }
                        let _e881 = phi_3122_;
                        if (_e881.member < _e874.member_1) {
                            phi_3134_ = SlimbvhTypeF(_e881.member, _e874.member_1);
                        } else {
                            phi_3134_ = SlimbvhTypeF(_e874.member_1, _e881.member);
                        }
                        let _e888 = phi_3134_;
                        let _e903 = (((_e874.member & 7u) | ((_e888.member & 7u) << bitcast<u32>(3u))) | (((_e888.member_1 & 7u) | ((_e881.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                        if (_e903 == 0u) {
                            let _e923 = (_e647 - 1u);
                            let _e928 = slimbvh_stacks[(((_e923 % 32u) * 64u) + _e612)];
                            let _e929 = (_e928 & 511u);
                            let _e931 = (_e929 >> bitcast<u32>(3u));
                            let _e934 = ((_e931 == 0u) || (_e923 == 4294967295u));
                            if _e934 {
                            } else {
                                slimbvh_stacks[(((_e923 % 32u) * 64u) + _e612)] = (((_e928 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e931);
                            }
                            phi_1935_ = select(_e647, _e923, _e934);
                            phi_1936_ = (((_e928 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e929 & 3u) & 3u));
                        } else {
                            let _e906 = (_e903 >> bitcast<u32>(3u));
                            if (_e906 == 0u) {
                                phi_1930_ = _e647;
                            } else {
                                slimbvh_stacks[(((_e647 % 32u) * 64u) + _e612)] = ((_e649 << bitcast<u32>(9u)) | _e906);
                                phi_1930_ = (_e647 + 1u);
                            }
                            let _e917 = phi_1930_;
                            phi_1935_ = _e917;
                            phi_1936_ = ((_e649 << bitcast<u32>(2i)) | ((_e903 & 3u) & 3u));
                        }
                        let _e949 = phi_1935_;
                        let _e951 = phi_1936_;
                        let _e953 = (_e951 >> bitcast<u32>(2i));
                        if (_e953 < _e85) {
                            let _e960 = slimbvh_nodes.member[_e953].member_1[(_e951 & 3u)];
                            phi_1957_ = _e960;
                        } else {
                            phi_1957_ = 2147483648u;
                        }
                        let _e962 = phi_1957_;
                        let _e963 = (_e651 - 1u);
                        phi_1366_ = select(_e949, 4294967295u, (_e963 == 0u));
                        phi_1369_ = _e962;
                        phi_1371_ = _e963;
                    } else {
                        phi_1366_ = u32();
                        phi_1369_ = u32();
                        phi_1371_ = u32();
                    }
                    let _e967 = phi_1366_;
                    let _e969 = phi_1369_;
                    let _e971 = phi_1371_;
                    continue;
                    continuing {
                        phi_1365_ = _e967;
                        phi_1368_ = _e969;
                        phi_1370_ = _e971;
                        break if !(_e655);
                    }
                }
                let _e974 = local;
                if _e974 {
                    let _e976 = local_1;
                    let _e979 = local_2;
                    phi_1973_ = _e638;
                    phi_1976_ = SlimbvhTypeF(0u, ((_e979 >> bitcast<u32>(28u)) & 7u));
                    loop {
                        let _e985 = phi_1973_;
                        let _e987 = phi_1976_;
                        local_5 = _e985;
                        local_8 = _e985;
                        if (_e987.member < _e987.member_1) {
                            phi_1977_ = SlimbvhTypeF((_e987.member + 1u), _e987.member_1);
                            phi_1999_ = SlimbvhTypeF(1u, _e987.member);
                        } else {
                            phi_1977_ = _e987;
                            phi_1999_ = SlimbvhTypeF(0u, SlimbvhTypeF().member_1);
                        }
                        let _e1000 = phi_1977_;
                        let _e1002 = phi_1999_;
                        let _e1006 = (bitcast<i32>(_e1002.member) != 0i);
                        if _e1006 {
                            let _e1007 = ((_e976 & 268435455u) + _e1002.member_1);
                            let _e1008 = (_e1007 / 2u);
                            let _e1009 = (_e1007 % 2u);
                            let _e1010 = (_e1008 >= arrayLength((&slimbvh_triangles.member)));
                            if _e1010 {
                                phi_2079_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e1011 = (2u * _e1009);
                                let _e1015 = slimbvh_triangles.member[_e1008][_e1011];
                                let _e1020 = slimbvh_triangles.member[_e1008][(_e1011 + 1u)];
                                let _e1025 = slimbvh_triangles.member[_e1008][(_e1011 + 2u)];
                                if (_e1009 == 0u) {
                                    phi_2078_ = array<vec4<f32>, 3>(_e1015, _e1020, _e1025);
                                } else {
                                    phi_2078_ = array<vec4<f32>, 3>(vec4<f32>(_e1015.z, _e1015.w, _e1020.x, _e1020.y), vec4<f32>(_e1020.z, _e1020.w, _e1025.x, _e1025.y), vec4<f32>(_e1025.z, _e1025.w, 0f, 0f));
                                }
                                let _e1043 = phi_2078_;
                                phi_2079_ = _e1043;
                            }
                            let _e1045 = phi_2079_;
                            let _e1048 = bitcast<u32>(_e1045[2].y);
                            if _e1010 {
                                phi_2160_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e1049 = (2u * _e1009);
                                let _e1053 = slimbvh_triangles.member[_e1008][_e1049];
                                let _e1058 = slimbvh_triangles.member[_e1008][(_e1049 + 1u)];
                                let _e1063 = slimbvh_triangles.member[_e1008][(_e1049 + 2u)];
                                if (_e1009 == 0u) {
                                    phi_2159_ = array<vec4<f32>, 3>(_e1053, _e1058, _e1063);
                                } else {
                                    phi_2159_ = array<vec4<f32>, 3>(vec4<f32>(_e1053.z, _e1053.w, _e1058.x, _e1058.y), vec4<f32>(_e1058.z, _e1058.w, _e1063.x, _e1063.y), vec4<f32>(_e1063.z, _e1063.w, 0f, 0f));
                                }
                                let _e1081 = phi_2159_;
                                phi_2160_ = _e1081;
                            }
                            let _e1083 = phi_2160_;
                            if _e158 {
                                phi_2184_ = array<f32, 3>(_e1083[0].x, _e1083[0].y, _e1083[0].z);
                            } else {
                                if (_e153 == 1u) {
                                    phi_2183_ = array<f32, 3>(_e1083[0].y, _e1083[0].z, _e1083[0].x);
                                } else {
                                    phi_2183_ = array<f32, 3>(_e1083[0].z, _e1083[0].x, _e1083[0].y);
                                }
                                let _e1106 = phi_2183_;
                                phi_2184_ = _e1106;
                            }
                            let _e1109 = phi_2184_;
                            if _e158 {
                                phi_2199_ = array<f32, 3>(_e1083[0].w, _e1083[1].x, _e1083[1].y);
                            } else {
                                if (_e153 == 1u) {
                                    phi_2198_ = array<f32, 3>(_e1083[1].x, _e1083[1].y, _e1083[0].w);
                                } else {
                                    phi_2198_ = array<f32, 3>(_e1083[1].y, _e1083[0].w, _e1083[1].x);
                                }
                                let _e1114 = phi_2198_;
                                phi_2199_ = _e1114;
                            }
                            let _e1117 = phi_2199_;
                            if _e158 {
                                phi_2214_ = array<f32, 3>(_e1083[1].z, _e1083[1].w, _e1083[2].x);
                            } else {
                                if (_e153 == 1u) {
                                    phi_2213_ = array<f32, 3>(_e1083[1].w, _e1083[2].x, _e1083[1].z);
                                } else {
                                    phi_2213_ = array<f32, 3>(_e1083[2].x, _e1083[1].z, _e1083[1].w);
                                }
                                let _e1122 = phi_2213_;
                                phi_2214_ = _e1122;
                            }
                            let _e1125 = phi_2214_;
                            let _e1139 = (_e1109[2] - _e541.member[2]);
                            let _e1142 = (((_e1109[0] - _e541.member[0]) * _e596) - (_e1139 * _e564));
                            let _e1145 = (((_e1109[1] - _e541.member[1]) * _e596) - (_e1139 * _e580));
                            let _e1148 = (_e1117[2] - _e541.member[2]);
                            let _e1151 = (((_e1117[0] - _e541.member[0]) * _e596) - (_e1148 * _e564));
                            let _e1154 = (((_e1117[1] - _e541.member[1]) * _e596) - (_e1148 * _e580));
                            let _e1157 = (_e1125[2] - _e541.member[2]);
                            let _e1160 = (((_e1125[0] - _e541.member[0]) * _e596) - (_e1157 * _e564));
                            let _e1163 = (((_e1125[1] - _e541.member[1]) * _e596) - (_e1157 * _e580));
                            let _e1164 = (_e1160 * _e1154);
                            let _e1165 = (_e1163 * _e1151);
                            let _e1166 = (_e1142 * _e1163);
                            let _e1167 = (_e1145 * _e1160);
                            let _e1168 = (_e1151 * _e1145);
                            let _e1169 = (_e1154 * _e1142);
                            let _e1174 = (((_e1164 >= _e1165) && (_e1166 >= _e1167)) && (_e1168 >= _e1169));
                            let _e1180 = (_e1174 || (((_e1164 <= _e1165) && (_e1166 <= _e1167)) && (_e1168 <= _e1169)));
                            if _e1180 {
                                let _e1182 = select(-1f, 1f, _e1174);
                                let _e1184 = ((_e1164 - _e1165) * _e1182);
                                let _e1186 = select(0f, _e1184, (_e1184 > 0f));
                                let _e1188 = ((_e1166 - _e1167) * _e1182);
                                let _e1190 = select(0f, _e1188, (_e1188 > 0f));
                                let _e1192 = ((_e1168 - _e1169) * _e1182);
                                let _e1194 = select(0f, _e1192, (_e1192 > 0f));
                                let _e1196 = ((_e1186 + _e1190) + _e1194);
                                let _e1211 = ((min(min(_e1109[0], _e1117[0]), _e1125[0]) - _e565) * _e568);
                                let _e1212 = ((max(max(_e1109[0], _e1117[0]), _e1125[0]) - _e566) * _e568);
                                let _e1213 = vec4<f32>(_e1211, f32(), _e1212, f32());
                                let _e1216 = ((min(min(_e1109[1], _e1117[1]), _e1125[1]) - _e581) * _e584);
                                let _e1217 = ((max(max(_e1109[1], _e1117[1]), _e1125[1]) - _e582) * _e584);
                                let _e1218 = vec4<f32>(_e1216, f32(), _e1217, f32());
                                let _e1221 = ((min(min(_e1109[2], _e1117[2]), _e1125[2]) - _e597) * _e600);
                                let _e1222 = ((max(max(_e1109[2], _e1117[2]), _e1125[2]) - _e598) * _e600);
                                let _e1223 = vec4<f32>(_e1221, f32(), _e1222, f32());
                                let _e1224 = vec4<f32>(_e1212, f32(), _e1211, f32());
                                let _e1226 = vec4<f32>(_e1217, f32(), _e1216, f32());
                                let _e1228 = vec4<f32>(_e1222, f32(), _e1221, f32());
                                let _e1237 = max(max(min(_e1213, _e1224).x, min(_e1218, _e1226).x), min(_e1223, _e1228).x);
                                let _e1242 = min(min(max(_e1213, _e1224).x, max(_e1218, _e1226).x), max(_e1223, _e1228).x);
                                let _e1247 = max(_e1237, _e608);
                                let _e1269 = (((((_e1180 && (_e1196 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1142, _e1151), _e1160) <= 0f) && (max(max(_e1142, _e1151), _e1160) >= 0f))) && ((min(min(_e1145, _e1154), _e1163) <= 0f) && (max(max(_e1145, _e1154), _e1163) >= 0f))) && (_e1247 <= (_e1242 + (max(max(_e1223, _e1228).x, -(min(_e1223, _e1228).x)) * 0.0000019073523f)))) && (_e1247 <= _e985.member.member_1));
                                if _e1269 {
                                    let _e1274 = (_e1117[0] - _e1109[0]);
                                    let _e1275 = (_e1117[1] - _e1109[1]);
                                    let _e1276 = (_e1117[2] - _e1109[2]);
                                    let _e1277 = vec3<f32>(_e1274, _e1275, _e1276);
                                    let _e1278 = (_e1125[0] - _e1117[0]);
                                    let _e1279 = (_e1125[1] - _e1117[1]);
                                    let _e1280 = (_e1125[2] - _e1117[2]);
                                    let _e1281 = vec3<f32>(_e1278, _e1279, _e1280);
                                    let _e1282 = (_e1109[0] - _e1125[0]);
                                    let _e1283 = (_e1109[1] - _e1125[1]);
                                    let _e1284 = (_e1109[2] - _e1125[2]);
                                    let _e1285 = vec3<f32>(_e1282, _e1283, _e1284);
                                    let _e1296 = max(max(bitcast<f32>((bitcast<u32>(_e1274) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1275) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1276) & 2147483647u)));
                                    let _e1307 = max(max(bitcast<f32>((bitcast<u32>(_e1278) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1279) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1280) & 2147483647u)));
                                    let _e1320 = max(max(_e1296, _e1307), max(max(bitcast<f32>((bitcast<u32>(_e1282) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1283) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1284) & 2147483647u))));
                                    if (_e1296 == _e1320) {
                                        phi_2573_ = _e1154;
                                        phi_2574_ = _e1151;
                                        phi_2575_ = _e1145;
                                        phi_2576_ = _e1142;
                                        phi_2577_ = vec3<f32>(_e1109[0], _e1109[1], _e1109[2]);
                                        phi_2578_ = _e1285;
                                        phi_2579_ = _e1281;
                                        phi_2580_ = _e1277;
                                    } else {
                                        let _e1322 = (_e1307 == _e1320);
                                        let _e1327 = vec3(_e1322);
                                        phi_2573_ = select(_e1145, _e1163, _e1322);
                                        phi_2574_ = select(_e1142, _e1160, _e1322);
                                        phi_2575_ = select(_e1163, _e1154, _e1322);
                                        phi_2576_ = select(_e1160, _e1151, _e1322);
                                        phi_2577_ = select(vec3<f32>(_e1125[0], _e1125[1], _e1125[2]), vec3<f32>(_e1117[0], _e1117[1], _e1117[2]), _e1327);
                                        phi_2578_ = select(_e1281, _e1277, _e1327);
                                        phi_2579_ = select(_e1277, _e1285, _e1327);
                                        phi_2580_ = select(_e1285, _e1281, _e1327);
                                    }
                                    let _e1333 = phi_2573_;
                                    let _e1335 = phi_2574_;
                                    let _e1337 = phi_2575_;
                                    let _e1339 = phi_2576_;
                                    let _e1341 = phi_2577_;
                                    let _e1343 = phi_2578_;
                                    let _e1345 = phi_2579_;
                                    let _e1347 = phi_2580_;
                                    let _e1354 = ((_e1345.y * _e1343.z) - (_e1343.y * _e1345.z));
                                    let _e1359 = ((_e1345.z * _e1343.x) - (_e1343.z * _e1345.x));
                                    let _e1362 = ((_e1345.x * _e1343.y) - (_e1343.x * _e1345.y));
                                    let _e1365 = ((_e1186 >= _e1190) && (_e1186 >= _e1194));
                                    let _e1366 = (_e1190 >= _e1194);
                                    let _e1380 = (((_e1354 * (select(select(_e1125[0], _e1117[0], _e1366), _e1109[0], _e1365) - _e541.member[0])) + (_e1359 * (select(select(_e1125[1], _e1117[1], _e1366), _e1109[1], _e1365) - _e541.member[1]))) + (_e1362 * (select(select(_e1125[2], _e1117[2], _e1366), _e1109[2], _e1365) - _e541.member[2])));
                                    let _e1385 = (((_e1354 * _e564) + (_e1359 * _e580)) + (_e1362 * _e596));
                                    let _e1386 = (_e1335 - _e1339);
                                    let _e1387 = (_e1333 - _e1337);
                                    let _e1390 = ((_e1386 * _e1386) + (_e1387 * _e1387));
                                    let _e1397 = (-(((_e1339 * _e1386) + (_e1337 * _e1387))) / select(0.000000000000000000000000000000000000011754944f, _e1390, (_e1390 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e1399 = select(1f, _e1397, (_e1397 < 1f));
                                    let _e1401 = select(0f, _e1399, (_e1399 > 0f));
                                    let _e1410 = ((_e1341.x + (_e1347.x * _e1401)) - _e541.member[0]);
                                    let _e1413 = ((_e1341.y + (_e1347.y * _e1401)) - _e541.member[1]);
                                    let _e1416 = ((_e1341.z + (_e1347.z * _e1401)) - _e541.member[2]);
                                    let _e1481 = ((bitcast<f32>((bitcast<u32>(((((_e1354 * _e1410) + (_e1359 * _e1413)) + (_e1362 * _e1416)) - _e1380)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1410) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1413) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1416) & 2147483647u))), _e1320)) * max(max(bitcast<f32>((bitcast<u32>(_e1354) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1362) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1385) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1345.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1345.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1345.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1343.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1343.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1343.z) & 2147483647u)))))));
                                    let _e1482 = (_e1380 / _e1385);
                                    if (_e1269 && !(_e1481)) {
                                        let _e1485 = (_e1416 / _e596);
                                        let _e1493 = (((_e1354 * (_e1410 - (_e564 * _e1485))) + (_e1359 * (_e1413 - (_e580 * _e1485)))) / _e1385);
                                        phi_2759_ = select(select(_e1485, (_e1485 + _e1493), (bitcast<f32>((bitcast<u32>(_e1493) & 2147483647u)) <= _e1320)), _e1482, _e1481);
                                    } else {
                                        phi_2759_ = _e1482;
                                    }
                                    let _e1502 = phi_2759_;
                                    let _e1504 = select(_e1242, _e1502, (_e1502 < _e1242));
                                    let _e1506 = select(_e1237, _e1504, (_e1504 > _e1237));
                                    let _e1509 = select(_e1506, 0f, (bitcast<u32>(_e1506) == 2147483648u));
                                    let _e1510 = (1f / _e1196);
                                    phi_2785_ = SlimbvhTypeG(_e1509, (_e1190 * _e1510), (_e1194 * _e1510), ((_e1269 && (_e1509 >= _e608)) && (_e1509 <= _e985.member.member_1)));
                                    phi_2786_ = SlimbvhTypeG();
                                } else {
                                    phi_2785_ = SlimbvhTypeG();
                                    phi_2786_ = SlimbvhTypeG(0f, 0f, 0f, _e1269);
                                }
                                let _e1519 = phi_2785_;
                                let _e1521 = phi_2786_;
                                phi_2789_ = _e1519;
                                phi_2790_ = _e1521;
                                phi_2791_ = select(true, false, _e1269);
                            } else {
                                phi_2789_ = SlimbvhTypeG();
                                phi_2790_ = SlimbvhTypeG(0f, 0f, 0f, _e1180);
                                phi_2791_ = true;
                            }
                            let _e1524 = phi_2789_;
                            let _e1526 = phi_2790_;
                            let _e1528 = phi_2791_;
                            if _e1528 {
                                phi_2795_ = _e1526;
                            } else {
                                phi_2795_ = _e1524;
                            }
                            let _e1530 = phi_2795_;
                            if _e1530.member_3 {
                                phi_2804_ = SlimbvhTypeH(_e1530.member, _e1530.member_1, _e1530.member_2, _e1048);
                            } else {
                                phi_2804_ = _e82;
                            }
                            let _e1537 = phi_2804_;
                            if (_e1537.member_3 != 4294967295u) {
                                if (_e1048 != 4294967295u) {
                                    if (_e1537.member < _e985.member.member.member) {
                                        phi_2832_ = true;
                                    } else {
                                        if (_e1537.member == _e985.member.member.member) {
                                            phi_2831_ = (_e1537.member_3 < _e985.member.member.member_3);
                                        } else {
                                            phi_2831_ = false;
                                        }
                                        let _e1552 = phi_2831_;
                                        phi_2832_ = _e1552;
                                    }
                                    let _e1554 = phi_2832_;
                                    if _e1554 {
                                        phi_2839_ = SlimbvhTypeL(SlimbvhTypeI(_e1537, _e1537.member), _e985.member_1);
                                    } else {
                                        phi_2839_ = _e985;
                                    }
                                    let _e1560 = phi_2839_;
                                    if _e1560.member_1 {
                                        phi_2845_ = SlimbvhTypeL(SlimbvhTypeI(_e1560.member.member, bitcast<f32>(4286578687u)), _e1560.member_1);
                                    } else {
                                        phi_2845_ = _e1560;
                                    }
                                    let _e1569 = phi_2845_;
                                    phi_2846_ = _e1569;
                                } else {
                                    phi_2846_ = _e985;
                                }
                                let _e1571 = phi_2846_;
                                phi_2847_ = _e1571;
                            } else {
                                phi_2847_ = _e985;
                            }
                            let _e1573 = phi_2847_;
                            phi_1974_ = _e1573;
                        } else {
                            phi_1974_ = SlimbvhTypeL();
                        }
                        let _e1575 = phi_1974_;
                        continue;
                        continuing {
                            phi_1973_ = _e1575;
                            phi_1976_ = _e1000;
                            break if !(_e1006);
                        }
                    }
                    let _e1578 = local_3;
                    let _e1579 = (_e1578 - 1u);
                    let _e1584 = slimbvh_stacks[(((_e1579 % 32u) * 64u) + _e612)];
                    let _e1585 = (_e1584 & 511u);
                    let _e1587 = (_e1585 >> bitcast<u32>(3u));
                    let _e1590 = ((_e1587 == 0u) || (_e1579 == 4294967295u));
                    if _e1590 {
                    } else {
                        slimbvh_stacks[(((_e1579 % 32u) * 64u) + _e612)] = (((_e1584 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1587);
                    }
                    let _e1597 = local_4;
                    let _e1605 = (((_e1584 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1585 & 3u) & 3u));
                    let _e1607 = (_e1605 >> bitcast<u32>(2i));
                    if (_e1607 < _e85) {
                        let _e1614 = slimbvh_nodes.member[_e1607].member_1[(_e1605 & 3u)];
                        phi_2905_ = _e1614;
                    } else {
                        phi_2905_ = 2147483648u;
                    }
                    let _e1616 = phi_2905_;
                    let _e1618 = local_5;
                    let _e1880 = local_8;
                    phi_2914_ = _e1880;
                    phi_2915_ = select(select(_e1597, _e1579, _e1590), 4294967295u, (_e608 > _e1618.member.member_1));
                    phi_2916_ = _e1616;
                } else {
                    phi_2914_ = _e638;
                    let _e1883 = local_9;
                    phi_2915_ = _e1883;
                    let _e1886 = local_10;
                    phi_2916_ = _e1886;
                }
                let _e1624 = phi_2914_;
                let _e1626 = phi_2915_;
                let _e1628 = phi_2916_;
                phi_1350_ = _e1624;
                phi_1353_ = _e1626;
                phi_1355_ = _e1628;
                let _e1892 = local_11;
                phi_1357_ = _e1892;
            } else {
                phi_1350_ = SlimbvhTypeL();
                phi_1353_ = u32();
                phi_1355_ = u32();
                phi_1357_ = u32();
            }
            let _e1630 = phi_1350_;
            let _e1632 = phi_1353_;
            let _e1634 = phi_1355_;
            let _e1636 = phi_1357_;
            continue;
            continuing {
                phi_1349_ = _e1630;
                phi_1352_ = _e1632;
                phi_1354_ = _e1634;
                phi_1356_ = _e1636;
                break if !(_e645);
            }
        }
        let _e1639 = local_6;
        let _e1640 = (_e1639 == 4294967295u);
        let _e1642 = local_7;
        if (_e1642.member.member.member_3 != 4294967295u) {
            let _e1648 = -((_e111 + _e541.member_4));
            let _e1649 = bitcast<u32>(_e1642.member.member.member);
            let _e1653 = (bitcast<i32>((_e1649 >> bitcast<u32>(23i))) & 255i);
            let _e1654 = (_e1653 + _e1648);
            if (_e1653 == 255i) {
                phi_2974_ = _e1642.member.member.member;
            } else {
                if (_e1653 > 0i) {
                    if (_e1654 > 0i) {
                        let _e1658 = (_e1654 < 255i);
                        if _e1658 {
                            phi_2953_ = bitcast<f32>((_e1649 + bitcast<u32>((_e1648 << bitcast<u32>(23i)))));
                        } else {
                            phi_2953_ = f32();
                        }
                        let _e1665 = phi_2953_;
                        phi_2955_ = _e1665;
                        phi_2956_ = select(true, false, _e1658);
                    } else {
                        phi_2955_ = f32();
                        phi_2956_ = true;
                    }
                    let _e1668 = phi_2955_;
                    let _e1670 = phi_2956_;
                    phi_2957_ = _e1668;
                    phi_2958_ = _e1670;
                } else {
                    phi_2957_ = f32();
                    phi_2958_ = true;
                }
                let _e1672 = phi_2957_;
                let _e1674 = phi_2958_;
                if _e1674 {
                    let _e1675 = (_e1649 & 2147483648u);
                    let _e1682 = ((_e1649 & 8388607u) | (select(0u, 1u, ((_e1649 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e1686 = (_e1682 == 0u);
                    if _e1686 {
                        phi_3415_ = bitcast<f32>(_e1675);
                    } else {
                        let _e1691 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1682)), 32u, _e1686) - 8u);
                        let _e1694 = (_e1682 << bitcast<u32>((_e1691 & 31u)));
                        let _e1696 = ((_e1654 + select(0i, 1i, (_e1653 == 0i))) - bitcast<i32>(_e1691));
                        if (_e1696 >= 255i) {
                            phi_3405_ = bitcast<f32>((_e1675 | 2139095040u));
                            phi_3406_ = f32();
                            phi_3407_ = true;
                        } else {
                            let _e1698 = (_e1696 > 0i);
                            if _e1698 {
                                phi_3399_ = bitcast<f32>(((_e1675 | (bitcast<u32>(_e1696) << bitcast<u32>(23i))) | (_e1694 & 8388607u)));
                                phi_3400_ = f32();
                            } else {
                                if (_e1696 < -24i) {
                                    phi_3365_ = 26u;
                                } else {
                                    phi_3365_ = bitcast<u32>((1i - _e1696));
                                }
                                let _e1703 = phi_3365_;
                                let _e1704 = (_e1703 & 31u);
                                let _e1706 = (_e1694 >> bitcast<u32>(_e1704));
                                let _e1710 = (_e1694 & ((1u << bitcast<u32>(_e1704)) - 1u));
                                let _e1714 = (1u << bitcast<u32>(((_e1703 - 1u) & 31u)));
                                if (_e1710 > _e1714) {
                                    phi_3386_ = true;
                                } else {
                                    if (_e1710 == _e1714) {
                                        phi_3383_ = ((_e1706 & 1u) == 1u);
                                    } else {
                                        phi_3383_ = false;
                                    }
                                    let _e1720 = phi_3383_;
                                    phi_3386_ = _e1720;
                                }
                                let _e1722 = phi_3386_;
                                phi_3399_ = f32();
                                phi_3400_ = bitcast<f32>((_e1675 | (_e1706 + select(0u, 1u, _e1722))));
                            }
                            let _e1735 = phi_3399_;
                            let _e1737 = phi_3400_;
                            phi_3405_ = _e1735;
                            phi_3406_ = _e1737;
                            phi_3407_ = _e1698;
                        }
                        let _e1741 = phi_3405_;
                        let _e1743 = phi_3406_;
                        let _e1745 = phi_3407_;
                        phi_3415_ = select(_e1743, _e1741, _e1745);
                    }
                    let _e1749 = phi_3415_;
                    phi_2973_ = _e1749;
                } else {
                    phi_2973_ = _e1672;
                }
                let _e1751 = phi_2973_;
                phi_2974_ = _e1751;
            }
            let _e1753 = phi_2974_;
            let _e1754 = bitcast<u32>(_e1753);
            if ((_e1754 & 2147483647u) >= 2139095040u) {
                phi_2986_ = bitcast<f32>(((_e1754 & 2147483648u) | 2139095039u));
            } else {
                phi_2986_ = _e1753;
            }
            let _e1761 = phi_2986_;
            phi_2991_ = SlimbvhTypeH(_e1761, _e1642.member.member.member_1, _e1642.member.member.member_2, _e1642.member.member.member_3);
        } else {
            phi_2991_ = _e82;
        }
        let _e1766 = phi_2991_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1766.member), bitcast<u32>(_e1766.member_1), bitcast<u32>(_e1766.member_2), _e1766.member_3);
        phi_3004_ = _e1640;
        phi_3005_ = _e1640;
        phi_3006_ = select(true, false, _e1640);
    } else {
        phi_3004_ = bool();
        phi_3005_ = false;
        phi_3006_ = true;
    }
    let _e1777 = phi_3004_;
    let _e1779 = phi_3005_;
    let _e1781 = phi_3006_;
    if _e1781 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e1777, _e1779, _e1781)));
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
