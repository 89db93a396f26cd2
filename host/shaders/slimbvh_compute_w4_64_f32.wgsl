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
    var phi_577_: u32;
    var phi_583_: u32;
    var phi_589_: u32;
    var phi_854_: i32;
    var phi_865_: i32;
    var phi_979_: i32;
    var phi_1108_: i32;
    var phi_1130_: u32;
    var phi_1131_: u32;
    var phi_1132_: bool;
    var phi_1166_: i32;
    var phi_1188_: u32;
    var phi_1189_: u32;
    var phi_1190_: bool;
    var phi_751_: i32;
    var phi_757_: u32;
    var phi_776_: u32;
    var phi_777_: u32;
    var phi_778_: bool;
    var phi_796_: i32;
    var phi_802_: u32;
    var phi_821_: u32;
    var phi_822_: u32;
    var phi_823_: bool;
    var phi_1200_: SlimbvhTypeD;
    var phi_1446_: SlimbvhTypeP;
    var phi_1509_: array<f32, 3>;
    var phi_1510_: array<f32, 3>;
    var phi_1528_: array<f32, 3>;
    var phi_1529_: array<f32, 3>;
    var phi_1702_: SlimbvhTypeP;
    var phi_1705_: u32;
    var phi_1707_: u32;
    var phi_1709_: u32;
    var phi_1718_: u32;
    var phi_1721_: u32;
    var phi_1723_: u32;
    var phi_1830_: SlimbvhTypeM;
    var phi_1831_: SlimbvhTypeM;
    var phi_1890_: SlimbvhTypeM;
    var phi_1891_: SlimbvhTypeM;
    var phi_1950_: SlimbvhTypeM;
    var phi_1951_: SlimbvhTypeM;
    var phi_2435_: u32;
    var phi_2448_: u32;
    var phi_2461_: u32;
    var phi_2474_: u32;
    var phi_4473_: SlimbvhTypeE;
    var phi_4485_: SlimbvhTypeE;
    var phi_4497_: SlimbvhTypeE;
    var phi_4509_: SlimbvhTypeE;
    var phi_4521_: SlimbvhTypeE;
    var phi_2558_: u32;
    var phi_2563_: u32;
    var phi_2564_: u32;
    var phi_2588_: u32;
    var phi_1719_: u32;
    var phi_1722_: u32;
    var phi_1724_: u32;
    var local: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_2605_: SlimbvhTypeP;
    var phi_2608_: SlimbvhTypeE;
    var phi_2609_: SlimbvhTypeE;
    var phi_2631_: SlimbvhTypeE;
    var phi_2710_: array<vec4<f32>, 3>;
    var phi_2711_: array<vec4<f32>, 3>;
    var phi_2791_: array<vec4<f32>, 3>;
    var phi_2792_: array<vec4<f32>, 3>;
    var phi_2815_: array<f32, 3>;
    var phi_2816_: array<f32, 3>;
    var phi_2830_: array<f32, 3>;
    var phi_2831_: array<f32, 3>;
    var phi_2845_: array<f32, 3>;
    var phi_2846_: array<f32, 3>;
    var phi_3205_: f32;
    var phi_3206_: f32;
    var phi_3207_: f32;
    var phi_3208_: f32;
    var phi_3209_: vec3<f32>;
    var phi_3210_: vec3<f32>;
    var phi_3211_: vec3<f32>;
    var phi_3212_: vec3<f32>;
    var phi_3391_: f32;
    var phi_3417_: SlimbvhTypeF;
    var phi_3418_: SlimbvhTypeF;
    var phi_3421_: SlimbvhTypeF;
    var phi_3422_: SlimbvhTypeF;
    var phi_3423_: bool;
    var phi_3427_: SlimbvhTypeF;
    var phi_3436_: SlimbvhTypeG;
    var phi_3489_: i32;
    var phi_3629_: SlimbvhTypeI;
    var phi_3653_: u32;
    var phi_3681_: vec3<f32>;
    var phi_3682_: vec3<f32>;
    var phi_3699_: vec3<f32>;
    var phi_3700_: vec3<f32>;
    var phi_3717_: vec3<f32>;
    var phi_3718_: vec3<f32>;
    var phi_3754_: vec3<f32>;
    var phi_3936_: f32;
    var phi_3954_: bool;
    var phi_3955_: bool;
    var phi_3974_: bool;
    var phi_3975_: bool;
    var phi_3982_: SlimbvhTypeP;
    var phi_3988_: SlimbvhTypeP;
    var phi_3989_: SlimbvhTypeP;
    var phi_3990_: SlimbvhTypeP;
    var phi_2606_: SlimbvhTypeP;
    var local_3: u32;
    var local_4: u32;
    var phi_4051_: u32;
    var local_5: SlimbvhTypeP;
    var phi_4060_: SlimbvhTypeP;
    var phi_4061_: u32;
    var phi_4062_: u32;
    var phi_1703_: SlimbvhTypeP;
    var phi_1706_: u32;
    var phi_1708_: u32;
    var phi_1710_: u32;
    var local_6: u32;
    var local_7: SlimbvhTypeP;
    var phi_4099_: f32;
    var phi_4101_: f32;
    var phi_4102_: bool;
    var phi_4103_: f32;
    var phi_4104_: bool;
    var phi_4752_: u32;
    var phi_4770_: bool;
    var phi_4773_: bool;
    var phi_4786_: f32;
    var phi_4787_: f32;
    var phi_4792_: f32;
    var phi_4793_: f32;
    var phi_4794_: bool;
    var phi_4802_: f32;
    var phi_4119_: f32;
    var phi_4120_: f32;
    var phi_4132_: f32;
    var phi_4137_: SlimbvhTypeG;
    var phi_4150_: bool;
    var phi_4151_: bool;
    var phi_4152_: bool;
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
    let _e156 = slimbvh_exponent.member[1u];
    let _e159 = slimbvh_exponent.member[2u];
    let _e160 = slimbvh_origin.member;
    let _e166 = slimbvh_origin.member[3u];
    let _e167 = slimbvh_direction.member;
    let _e173 = slimbvh_direction.member[3u];
    let _e176 = slimbvh_exponent.member[0u];
    let _e177 = bitcast<i32>(_e176);
    let _e179 = (bitcast<u32>(_e160.x) & 2147483647u);
    let _e181 = (bitcast<u32>(_e160.y) & 2147483647u);
    let _e183 = (bitcast<u32>(_e160.z) & 2147483647u);
    let _e184 = bitcast<u32>(_e166);
    let _e185 = (_e184 & 2147483647u);
    let _e187 = (bitcast<u32>(_e167.x) & 2147483647u);
    let _e189 = (bitcast<u32>(_e167.y) & 2147483647u);
    let _e191 = (bitcast<u32>(_e167.z) & 2147483647u);
    let _e192 = bitcast<u32>(_e173);
    let _e193 = (_e192 & 2147483647u);
    let _e195 = select(_e189, _e187, (_e189 < _e187));
    let _e197 = select(_e191, _e195, (_e191 < _e195));
    let _e199 = select(_e179, _e197, (_e179 < _e197));
    let _e201 = select(_e181, _e199, (_e181 < _e199));
    let _e203 = select(_e183, _e201, (_e183 < _e201));
    let _e210 = (((select(_e185, _e203, (_e185 < _e203)) < 2139095040u) && (_e193 <= 2139095040u)) && (_e197 > 0u));
    if (_e187 == _e197) {
        phi_577_ = 0u;
    } else {
        phi_577_ = select(2u, 1u, (_e189 == _e197));
    }
    let _e215 = phi_577_;
    let _e216 = (_e215 == 2u);
    if _e216 {
        phi_583_ = 0u;
    } else {
        phi_583_ = (_e215 + 1u);
    }
    let _e219 = phi_583_;
    let _e220 = (_e219 == 2u);
    if _e220 {
        phi_589_ = 0u;
    } else {
        phi_589_ = (_e219 + 1u);
    }
    let _e223 = phi_589_;
    let _e224 = (_e219 == 0u);
    let _e226 = select(select(_e160.y, _e160.x, _e224), _e160.z, _e220);
    let _e227 = (_e223 == 0u);
    let _e229 = (_e223 == 2u);
    let _e230 = select(select(_e160.y, _e160.x, _e227), _e160.z, _e229);
    let _e231 = (_e215 == 0u);
    let _e233 = select(select(_e160.y, _e160.x, _e231), _e160.z, _e216);
    let _e235 = select(select(_e167.y, _e167.x, _e224), _e167.z, _e220);
    let _e237 = select(select(_e167.y, _e167.x, _e227), _e167.z, _e229);
    let _e239 = select(select(_e167.y, _e167.x, _e231), _e167.z, _e216);
    let _e240 = (_e185 - 1u);
    let _e241 = (_e193 - 1u);
    let _e243 = select(_e240, _e241, (_e241 < _e240));
    let _e244 = (_e179 - 1u);
    let _e245 = (_e181 - 1u);
    let _e247 = select(_e244, _e245, (_e245 < _e244));
    let _e248 = (_e183 - 1u);
    let _e250 = select(_e247, _e248, (_e248 < _e247));
    let _e251 = (_e187 - 1u);
    let _e252 = (_e189 - 1u);
    let _e254 = select(_e251, _e252, (_e252 < _e251));
    let _e255 = (_e191 - 1u);
    let _e257 = select(_e254, _e255, (_e255 < _e254));
    let _e259 = select(_e250, _e257, (_e257 < _e250));
    if (((select(_e259, _e243, (_e243 < _e259)) >= 8388607u) && (_e197 < 2130706432u)) && (bitcast<u32>((_e177 + 126i)) <= 253u)) {
        let _e524 = bitcast<i32>((_e197 >> bitcast<u32>(23i)));
        let _e525 = (_e524 - 127i);
        let _e526 = (_e177 + _e525);
        let _e531 = bitcast<f32>((bitcast<u32>((_e177 + 127i)) << bitcast<u32>(23i)));
        let _e536 = bitcast<f32>((bitcast<u32>((254i - _e524)) << bitcast<u32>(23i)));
        if (_e185 >= 2139095040u) {
            phi_751_ = 255i;
        } else {
            phi_751_ = (bitcast<i32>((_e185 >> bitcast<u32>(23i))) + _e526);
        }
        let _e551 = phi_751_;
        if (_e185 == 0u) {
            phi_757_ = 0u;
        } else {
            phi_757_ = (_e185 | 8388608u);
        }
        let _e555 = phi_757_;
        if (_e551 <= 0i) {
            phi_777_ = u32();
            phi_778_ = true;
        } else {
            let _e562 = (_e555 == 0u);
            if _e562 {
                phi_776_ = u32();
            } else {
                phi_776_ = select(((bitcast<u32>(_e551) << bitcast<u32>(23i)) | (_e555 & 8388607u)), 2139095039u, (_e551 >= 255i));
            }
            let _e566 = phi_776_;
            phi_777_ = _e566;
            phi_778_ = _e562;
        }
        let _e568 = phi_777_;
        let _e570 = phi_778_;
        if (_e193 >= 2139095040u) {
            phi_796_ = 255i;
        } else {
            phi_796_ = (bitcast<i32>((_e193 >> bitcast<u32>(23i))) + _e526);
        }
        let _e581 = phi_796_;
        if (_e193 == 0u) {
            phi_802_ = 0u;
        } else {
            phi_802_ = (_e193 | 8388608u);
        }
        let _e585 = phi_802_;
        if (_e581 <= 0i) {
            phi_822_ = u32();
            phi_823_ = true;
        } else {
            let _e592 = (_e585 == 0u);
            if _e592 {
                phi_821_ = u32();
            } else {
                phi_821_ = select(((bitcast<u32>(_e581) << bitcast<u32>(23i)) | (_e585 & 8388607u)), 2139095039u, (_e581 >= 255i));
            }
            let _e596 = phi_821_;
            phi_822_ = _e596;
            phi_823_ = _e592;
        }
        let _e598 = phi_822_;
        let _e600 = phi_823_;
        phi_1200_ = SlimbvhTypeD(array<f32, 3>((_e226 * _e531), (_e230 * _e531), (_e233 * _e531)), array<f32, 3>((_e235 * _e536), (_e237 * _e536), (_e239 * _e536)), bitcast<f32>(((_e184 & 2147483648u) | select(_e568, 0u, _e570))), bitcast<f32>(((_e192 & 2147483648u) | select(_e598, 0u, _e600))), _e525);
    } else {
        let _e272 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e197, _e210))) & 2147483647u);
        if (_e272 >= 8388608u) {
            phi_854_ = (bitcast<i32>((_e272 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_854_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e272)), 32u, (_e272 == 0u))));
        }
        let _e286 = phi_854_;
        let _e287 = (_e177 + _e286);
        if (_e177 < -126i) {
            phi_865_ = -126i;
        } else {
            phi_865_ = select(_e177, 127i, (_e177 > 127i));
        }
        let _e292 = phi_865_;
        let _e297 = bitcast<f32>((bitcast<u32>((_e292 + 127i)) << bitcast<u32>(23i)));
        let _e303 = bitcast<f32>((bitcast<u32>(((_e177 - _e292) + 127i)) << bitcast<u32>(23i)));
        let _e304 = bitcast<u32>(_e226);
        let _e306 = ((_e304 & 2139095040u) != 0u);
        let _e321 = bitcast<u32>(_e230);
        let _e323 = ((_e321 & 2139095040u) != 0u);
        let _e338 = bitcast<u32>(_e233);
        let _e340 = ((_e338 & 2139095040u) != 0u);
        let _e356 = -(_e286);
        if (_e356 < -126i) {
            phi_979_ = -126i;
        } else {
            phi_979_ = select(_e356, 127i, (_e356 > 127i));
        }
        let _e361 = phi_979_;
        let _e366 = bitcast<f32>((bitcast<u32>((_e361 + 127i)) << bitcast<u32>(23i)));
        let _e372 = bitcast<f32>((bitcast<u32>(((_e356 - _e361) + 127i)) << bitcast<u32>(23i)));
        let _e373 = bitcast<u32>(_e235);
        let _e375 = ((_e373 & 2139095040u) != 0u);
        let _e390 = bitcast<u32>(_e237);
        let _e392 = ((_e390 & 2139095040u) != 0u);
        let _e407 = bitcast<u32>(_e239);
        let _e409 = ((_e407 & 2139095040u) != 0u);
        let _e431 = ((_e185 & 8388607u) | (select(0u, 1u, ((_e185 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e434 = bitcast<i32>((_e185 >> bitcast<u32>(23i)));
        let _e441 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e431)), 32u, (_e431 == 0u))) - 8i);
        if (_e434 == 255i) {
            phi_1108_ = 255i;
        } else {
            phi_1108_ = (((_e434 + select(0i, 1i, (_e434 == 0i))) - _e441) + _e287);
        }
        let _e449 = phi_1108_;
        let _e453 = (_e431 << bitcast<u32>(((_e441 & 31i) & 31i)));
        if (_e449 <= 0i) {
            phi_1131_ = u32();
            phi_1132_ = true;
        } else {
            let _e460 = (_e453 == 0u);
            if _e460 {
                phi_1130_ = u32();
            } else {
                phi_1130_ = select(((bitcast<u32>(_e449) << bitcast<u32>(23i)) | (_e453 & 8388607u)), 2139095039u, (_e449 >= 255i));
            }
            let _e464 = phi_1130_;
            phi_1131_ = _e464;
            phi_1132_ = _e460;
        }
        let _e466 = phi_1131_;
        let _e468 = phi_1132_;
        let _e479 = ((_e193 & 8388607u) | (select(0u, 1u, ((_e193 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e482 = bitcast<i32>((_e193 >> bitcast<u32>(23i)));
        let _e489 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e479)), 32u, (_e479 == 0u))) - 8i);
        if (_e482 == 255i) {
            phi_1166_ = 255i;
        } else {
            phi_1166_ = (((_e482 + select(0i, 1i, (_e482 == 0i))) - _e489) + _e287);
        }
        let _e497 = phi_1166_;
        let _e501 = (_e479 << bitcast<u32>(((_e489 & 31i) & 31i)));
        if (_e497 <= 0i) {
            phi_1189_ = u32();
            phi_1190_ = true;
        } else {
            let _e508 = (_e501 == 0u);
            if _e508 {
                phi_1188_ = u32();
            } else {
                phi_1188_ = select(((bitcast<u32>(_e497) << bitcast<u32>(23i)) | (_e501 & 8388607u)), 2139095039u, (_e497 >= 255i));
            }
            let _e512 = phi_1188_;
            phi_1189_ = _e512;
            phi_1190_ = _e508;
        }
        let _e514 = phi_1189_;
        let _e516 = phi_1190_;
        phi_1200_ = SlimbvhTypeD(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e304 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e304 & 2147483648u))), _e226, _e306) * _e297) * select(0.00000011920929f, 1f, _e306)) * _e303), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e321 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e321 & 2147483648u))), _e230, _e323) * _e297) * select(0.00000011920929f, 1f, _e323)) * _e303), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e338 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e338 & 2147483648u))), _e233, _e340) * _e297) * select(0.00000011920929f, 1f, _e340)) * _e303)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e373 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e373 & 2147483648u))), _e235, _e375) * _e366) * select(0.00000011920929f, 1f, _e375)) * _e372), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e390 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e390 & 2147483648u))), _e237, _e392) * _e366) * select(0.00000011920929f, 1f, _e392)) * _e372), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e407 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e407 & 2147483648u))), _e239, _e409) * _e366) * select(0.00000011920929f, 1f, _e409)) * _e372)), bitcast<f32>(((_e184 & 2147483648u) | select(_e466, 0u, _e468))), bitcast<f32>(((_e192 & 2147483648u) | select(_e514, 0u, _e516))), _e286);
    }
    let _e607 = phi_1200_;
    let _e622 = (bitcast<f32>((bitcast<u32>(_e607.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e625 = bitcast<f32>((bitcast<u32>(_e607.member[0]) & 2147483647u));
    let _e626 = (_e625 * 0.00000011920929f);
    let _e629 = select(select(0.00000000000011368684f, _e626, (_e626 > 0.00000000000011368684f)), 0f, _e622);
    let _e630 = select(0f, _e607.member_1[0], _e622);
    let _e631 = (_e607.member[0] + _e629);
    let _e632 = (_e607.member[0] - _e629);
    let _e634 = select(38685626000000000000000000f, (1f / _e607.member_1[0]), _e622);
    let _e638 = (bitcast<f32>((bitcast<u32>(_e607.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e641 = bitcast<f32>((bitcast<u32>(_e607.member[1]) & 2147483647u));
    let _e642 = (_e641 * 0.00000011920929f);
    let _e645 = select(select(0.00000000000011368684f, _e642, (_e642 > 0.00000000000011368684f)), 0f, _e638);
    let _e646 = select(0f, _e607.member_1[1], _e638);
    let _e647 = (_e607.member[1] + _e645);
    let _e648 = (_e607.member[1] - _e645);
    let _e650 = select(38685626000000000000000000f, (1f / _e607.member_1[1]), _e638);
    let _e654 = (bitcast<f32>((bitcast<u32>(_e607.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e657 = bitcast<f32>((bitcast<u32>(_e607.member[2]) & 2147483647u));
    let _e658 = (_e657 * 0.00000011920929f);
    let _e661 = select(select(0.00000000000011368684f, _e658, (_e658 > 0.00000000000011368684f)), 0f, _e654);
    let _e662 = select(0f, _e607.member_1[2], _e654);
    let _e663 = (_e607.member[2] + _e661);
    let _e664 = (_e607.member[2] - _e661);
    let _e666 = select(38685626000000000000000000f, (1f / _e607.member_1[2]), _e654);
    let _e668 = select(_e641, _e625, (_e625 > _e641));
    let _e672 = (_e210 && (select(_e657, _e668, (_e668 > _e657)) <= 1099511600000f));
    let _e673 = select(0f, _e607.member_3, _e672);
    let _e674 = select(1f, _e607.member_2, _e672);
    let _e678 = slimbvh_question.member[1u];
    let _e679 = slimbvh_lane.member;
    if (_e679 < 64u) {
        let _e681 = (_e679 % 64u);
        let _e684 = slimbvh_question.member[0u];
        if (_e684 == 1u) {
            phi_1446_ = SlimbvhTypeP(SlimbvhTypeJ(_e99, _e673), true);
        } else {
            phi_1446_ = SlimbvhTypeP(SlimbvhTypeJ(_e99, _e673), false);
        }
        let _e691 = phi_1446_;
        let _e696 = (_e219 & 3u);
        let _e697 = (_e223 & 3u);
        let _e698 = (_e215 & 3u);
        let _e701 = (bitcast<u32>(_e634) >> bitcast<u32>(31i));
        let _e704 = (bitcast<u32>(_e650) >> bitcast<u32>(31i));
        let _e707 = (bitcast<u32>(_e666) >> bitcast<u32>(31i));
        let _e711 = (f32(bitcast<i32>(_e117)) * _e153);
        let _e713 = (f32(bitcast<i32>(_e121)) * _e153);
        let _e715 = (f32(bitcast<i32>(_e125)) * _e153);
        let _e716 = (_e696 == 0u);
        if _e716 {
            phi_1510_ = array<f32, 3>(_e711, _e713, _e715);
        } else {
            if (_e696 == 1u) {
                phi_1509_ = array<f32, 3>(_e713, _e715, _e711);
            } else {
                phi_1509_ = array<f32, 3>(_e715, _e711, _e713);
            }
            let _e721 = phi_1509_;
            phi_1510_ = _e721;
        }
        let _e724 = phi_1510_;
        let _e726 = (f32(bitcast<i32>(_e133)) * _e153);
        let _e728 = (f32(bitcast<i32>(_e137)) * _e153);
        let _e730 = (f32(bitcast<i32>(_e141)) * _e153);
        if _e716 {
            phi_1529_ = array<f32, 3>(_e726, _e728, _e730);
        } else {
            if (_e696 == 1u) {
                phi_1528_ = array<f32, 3>(_e728, _e730, _e726);
            } else {
                phi_1528_ = array<f32, 3>(_e730, _e726, _e728);
            }
            let _e735 = phi_1528_;
            phi_1529_ = _e735;
        }
        let _e738 = phi_1529_;
        let _e749 = ((_e724[0] - _e631) * _e634);
        let _e750 = ((_e738[0] - _e632) * _e634);
        let _e751 = vec4<f32>(_e749, f32(), _e750, f32());
        let _e754 = ((_e724[1] - _e647) * _e650);
        let _e755 = ((_e738[1] - _e648) * _e650);
        let _e756 = vec4<f32>(_e754, f32(), _e755, f32());
        let _e759 = ((_e724[2] - _e663) * _e666);
        let _e760 = ((_e738[2] - _e664) * _e666);
        let _e761 = vec4<f32>(_e759, f32(), _e760, f32());
        let _e762 = vec4<f32>(_e750, f32(), _e749, f32());
        let _e764 = vec4<f32>(_e755, f32(), _e754, f32());
        let _e766 = vec4<f32>(_e760, f32(), _e759, f32());
        phi_1702_ = _e691;
        phi_1705_ = select(4294967295u, select(4294967295u, 0u, (_e674 <= _e673)), (max(max(max(min(_e751, _e762).x, min(_e756, _e764).x), min(_e761, _e766).x), _e674) <= min((min(min(max(_e751, _e762).x, max(_e756, _e764).x), max(_e761, _e766).x) + (max(max(_e761, _e766).x, -(min(_e761, _e766).x)) * 0.0000019073523f)), _e691.member.member_1)));
        phi_1707_ = select(0u, 2147483648u, (_e103 == 0u));
        phi_1709_ = (_e103 + 1u);
        loop {
            let _e790 = phi_1702_;
            let _e792 = phi_1705_;
            let _e794 = phi_1707_;
            let _e796 = phi_1709_;
            local_6 = _e792;
            local_7 = _e790;
            let _e797 = (_e792 <= 32u);
            if _e797 {
                phi_1718_ = _e792;
                phi_1721_ = _e794;
                phi_1723_ = _e796;
                loop {
                    let _e799 = phi_1718_;
                    let _e801 = phi_1721_;
                    let _e803 = phi_1723_;
                    local_1 = _e801;
                    local_2 = _e801;
                    local_3 = _e799;
                    local_4 = _e799;
                    local_9 = _e799;
                    local_10 = _e801;
                    local_11 = _e803;
                    let _e804 = (_e799 <= 32u);
                    let _e806 = (_e801 + _e156);
                    let _e810 = (_e804 && !(((_e801 >= _e103) || (_e806 >= _e103))));
                    local = _e804;
                    if _e810 {
                        let _e816 = slimbvh_nodes.member[_e806].member[select(_e696, 2u, (2u < _e696))];
                        let _e822 = slimbvh_nodes.member[_e806].member[select(_e697, 2u, (2u < _e697))];
                        let _e828 = slimbvh_nodes.member[_e806].member[select(_e698, 2u, (2u < _e698))];
                        let _e831 = bitcast<u32>(_e153);
                        let _e836 = bitcast<f32>(_e816.x);
                        let _e841 = (_e836 + (f32((_e816.w >> bitcast<u32>(5u))) * _e153));
                        if (_e701 == 0u) {
                            phi_1830_ = SlimbvhTypeM(_e816.z, _e841);
                            phi_1831_ = SlimbvhTypeM(_e816.y, _e836);
                        } else {
                            phi_1830_ = SlimbvhTypeM(_e816.y, _e836);
                            phi_1831_ = SlimbvhTypeM(_e816.z, _e841);
                        }
                        let _e852 = phi_1830_;
                        let _e854 = phi_1831_;
                        let _e858 = bitcast<f32>(((_e831 + ((_e816.w & 31u) << bitcast<u32>(23i))) ^ (_e701 << bitcast<u32>(31i))));
                        let _e898 = bitcast<f32>(_e822.x);
                        let _e903 = (_e898 + (f32((_e822.w >> bitcast<u32>(5u))) * _e153));
                        if (_e704 == 0u) {
                            phi_1890_ = SlimbvhTypeM(_e822.z, _e903);
                            phi_1891_ = SlimbvhTypeM(_e822.y, _e898);
                        } else {
                            phi_1890_ = SlimbvhTypeM(_e822.y, _e898);
                            phi_1891_ = SlimbvhTypeM(_e822.z, _e903);
                        }
                        let _e914 = phi_1890_;
                        let _e916 = phi_1891_;
                        let _e920 = bitcast<f32>(((_e831 + ((_e822.w & 31u) << bitcast<u32>(23i))) ^ (_e704 << bitcast<u32>(31i))));
                        let _e960 = bitcast<f32>(_e828.x);
                        let _e965 = (_e960 + (f32((_e828.w >> bitcast<u32>(5u))) * _e153));
                        if (_e707 == 0u) {
                            phi_1950_ = SlimbvhTypeM(_e828.z, _e965);
                            phi_1951_ = SlimbvhTypeM(_e828.y, _e960);
                        } else {
                            phi_1950_ = SlimbvhTypeM(_e828.y, _e960);
                            phi_1951_ = SlimbvhTypeM(_e828.z, _e965);
                        }
                        let _e976 = phi_1950_;
                        let _e978 = phi_1951_;
                        let _e982 = bitcast<f32>(((_e831 + ((_e828.w & 31u) << bitcast<u32>(23i))) ^ (_e707 << bitcast<u32>(31i))));
                        let _e1018 = (_e858 * _e634);
                        let _e1025 = (((_e854.member_1 - _e631) * _e634) + (bitcast<f32>((bitcast<u32>(_e1018) & 2147483647u)) * -0.00012207031f));
                        let _e1034 = (-(_e858) * _e634);
                        let _e1041 = (((_e852.member_1 - _e632) * _e634) + (bitcast<f32>((bitcast<u32>(_e1034) & 2147483647u)) * 0.00012207031f));
                        let _e1050 = (_e920 * _e650);
                        let _e1057 = (((_e916.member_1 - _e647) * _e650) + (bitcast<f32>((bitcast<u32>(_e1050) & 2147483647u)) * -0.00012207031f));
                        let _e1066 = (-(_e920) * _e650);
                        let _e1073 = (((_e914.member_1 - _e648) * _e650) + (bitcast<f32>((bitcast<u32>(_e1066) & 2147483647u)) * 0.00012207031f));
                        let _e1082 = (_e982 * _e666);
                        let _e1089 = (((_e978.member_1 - _e663) * _e666) + (bitcast<f32>((bitcast<u32>(_e1082) & 2147483647u)) * -0.00012207031f));
                        let _e1094 = ((f32((_e978.member & 255u)) * _e1082) + _e1089);
                        let _e1095 = ((f32(((_e978.member >> bitcast<u32>(8u)) & 255u)) * _e1082) + _e1089);
                        let _e1096 = ((f32(((_e978.member >> bitcast<u32>(16u)) & 255u)) * _e1082) + _e1089);
                        let _e1097 = ((f32(((_e978.member >> bitcast<u32>(24u)) & 255u)) * _e1082) + _e1089);
                        let _e1098 = (-(_e982) * _e666);
                        let _e1105 = (((_e976.member_1 - _e664) * _e666) + (bitcast<f32>((bitcast<u32>(_e1098) & 2147483647u)) * 0.00012207031f));
                        let _e1110 = ((f32((_e976.member & 255u)) * _e1098) + _e1105);
                        let _e1111 = ((f32(((_e976.member >> bitcast<u32>(8u)) & 255u)) * _e1098) + _e1105);
                        let _e1112 = ((f32(((_e976.member >> bitcast<u32>(16u)) & 255u)) * _e1098) + _e1105);
                        let _e1113 = ((f32(((_e976.member >> bitcast<u32>(24u)) & 255u)) * _e1098) + _e1105);
                        let _e1146 = max(max(max(((f32((_e854.member & 255u)) * _e1018) + _e1025), ((f32((_e916.member & 255u)) * _e1050) + _e1057)), _e1094), _e674);
                        let _e1147 = max(max(max(((f32(((_e854.member >> bitcast<u32>(8u)) & 255u)) * _e1018) + _e1025), ((f32(((_e916.member >> bitcast<u32>(8u)) & 255u)) * _e1050) + _e1057)), _e1095), _e674);
                        let _e1148 = max(max(max(((f32(((_e854.member >> bitcast<u32>(16u)) & 255u)) * _e1018) + _e1025), ((f32(((_e916.member >> bitcast<u32>(16u)) & 255u)) * _e1050) + _e1057)), _e1096), _e674);
                        let _e1149 = max(max(max(((f32(((_e854.member >> bitcast<u32>(24u)) & 255u)) * _e1018) + _e1025), ((f32(((_e916.member >> bitcast<u32>(24u)) & 255u)) * _e1050) + _e1057)), _e1097), _e674);
                        let _e1154 = (_e790.member.member_1 + (bitcast<f32>((bitcast<u32>(_e790.member.member_1) & 2147483647u)) * 0.0000004768374f));
                        if (_e1146 <= min((min(min(((f32((_e852.member & 255u)) * _e1034) + _e1041), ((f32((_e914.member & 255u)) * _e1066) + _e1073)), _e1110) + (max(_e1110, -(_e1094)) * 0.0000023841915f)), _e1154)) {
                            phi_2435_ = (((bitcast<u32>(_e1146) ^ select(0u, 4294967288u, _e691.member_1)) & 2147483640u) | 4u);
                        } else {
                            phi_2435_ = 4294967288u;
                        }
                        let _e1169 = phi_2435_;
                        if (_e1147 <= min((min(min(((f32(((_e852.member >> bitcast<u32>(8u)) & 255u)) * _e1034) + _e1041), ((f32(((_e914.member >> bitcast<u32>(8u)) & 255u)) * _e1066) + _e1073)), _e1111) + (max(_e1111, -(_e1095)) * 0.0000023841915f)), _e1154)) {
                            phi_2448_ = ((((bitcast<u32>(_e1147) ^ select(0u, 4294967288u, _e691.member_1)) & 2147483640u) | 4u) | 1u);
                        } else {
                            phi_2448_ = 4294967288u;
                        }
                        let _e1177 = phi_2448_;
                        if (_e1148 <= min((min(min(((f32(((_e852.member >> bitcast<u32>(16u)) & 255u)) * _e1034) + _e1041), ((f32(((_e914.member >> bitcast<u32>(16u)) & 255u)) * _e1066) + _e1073)), _e1112) + (max(_e1112, -(_e1096)) * 0.0000023841915f)), _e1154)) {
                            phi_2461_ = ((((bitcast<u32>(_e1148) ^ select(0u, 4294967288u, _e691.member_1)) & 2147483640u) | 4u) | 2u);
                        } else {
                            phi_2461_ = 4294967288u;
                        }
                        let _e1185 = phi_2461_;
                        if (_e1149 <= min((min(min(((f32(((_e852.member >> bitcast<u32>(24u)) & 255u)) * _e1034) + _e1041), ((f32(((_e914.member >> bitcast<u32>(24u)) & 255u)) * _e1066) + _e1073)), _e1113) + (max(_e1113, -(_e1097)) * 0.0000023841915f)), _e1154)) {
                            phi_2474_ = ((((bitcast<u32>(_e1149) ^ select(0u, 4294967288u, _e691.member_1)) & 2147483640u) | 4u) | 3u);
                        } else {
                            phi_2474_ = 4294967288u;
                        }
                        let _e1193 = phi_2474_;
                        if (_e1169 < _e1177) {
                            phi_4473_ = SlimbvhTypeE(_e1169, _e1177);
                        } else {
                            phi_4473_ = SlimbvhTypeE(_e1177, _e1169);
                        }
                        let _e1198 = phi_4473_;
                        if (_e1185 < _e1193) {
                            phi_4485_ = SlimbvhTypeE(_e1185, _e1193);
                        } else {
                            phi_4485_ = SlimbvhTypeE(_e1193, _e1185);
                        }
                        let _e1205 = phi_4485_;
                        if (_e1198.member < _e1205.member) {
                            phi_4497_ = SlimbvhTypeE(_e1198.member, _e1205.member);
                        } else {
                            phi_4497_ = SlimbvhTypeE(_e1205.member, _e1198.member);
                        }
                        let _e1212 = phi_4497_;
                        if (_e1198.member_1 < _e1205.member_1) {
                            phi_4509_ = SlimbvhTypeE(_e1198.member_1, _e1205.member_1);
                        } else {
                            phi_4509_ = SlimbvhTypeE(_e1205.member_1, _e1198.member_1);
                        }
                        let _e1219 = phi_4509_;
                        if (_e1219.member < _e1212.member_1) {
                            phi_4521_ = SlimbvhTypeE(_e1219.member, _e1212.member_1);
                        } else {
                            phi_4521_ = SlimbvhTypeE(_e1212.member_1, _e1219.member);
                        }
                        let _e1226 = phi_4521_;
                        let _e1241 = (((_e1212.member & 7u) | ((_e1226.member & 7u) << bitcast<u32>(3u))) | (((_e1226.member_1 & 7u) | ((_e1219.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                        if (_e1241 == 0u) {
                            let _e1261 = (_e799 - 1u);
                            let _e1266 = slimbvh_stacks[(((_e1261 % 32u) * 64u) + _e681)];
                            let _e1267 = (_e1266 & 511u);
                            let _e1269 = (_e1267 >> bitcast<u32>(3u));
                            let _e1272 = ((_e1269 == 0u) || (_e1261 == 4294967295u));
                            if _e1272 {
                            } else {
                                slimbvh_stacks[(((_e1261 % 32u) * 64u) + _e681)] = (((_e1266 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1269);
                            }
                            phi_2563_ = select(_e799, _e1261, _e1272);
                            phi_2564_ = (((_e1266 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1267 & 3u) & 3u));
                        } else {
                            let _e1244 = (_e1241 >> bitcast<u32>(3u));
                            if (_e1244 == 0u) {
                                phi_2558_ = _e799;
                            } else {
                                slimbvh_stacks[(((_e799 % 32u) * 64u) + _e681)] = ((_e806 << bitcast<u32>(9u)) | _e1244);
                                phi_2558_ = (_e799 + 1u);
                            }
                            let _e1255 = phi_2558_;
                            phi_2563_ = _e1255;
                            phi_2564_ = ((_e806 << bitcast<u32>(2i)) | ((_e1241 & 3u) & 3u));
                        }
                        let _e1287 = phi_2563_;
                        let _e1289 = phi_2564_;
                        let _e1291 = (_e1289 >> bitcast<u32>(2i));
                        if (_e1291 < _e103) {
                            let _e1297 = slimbvh_nodes.member[_e1291].member_1[(_e1289 & 3u)];
                            phi_2588_ = _e1297;
                        } else {
                            phi_2588_ = 2147483648u;
                        }
                        let _e1299 = phi_2588_;
                        let _e1300 = (_e803 - 1u);
                        phi_1719_ = select(_e1287, 4294967295u, (_e1300 == 0u));
                        phi_1722_ = _e1299;
                        phi_1724_ = _e1300;
                    } else {
                        phi_1719_ = u32();
                        phi_1722_ = u32();
                        phi_1724_ = u32();
                    }
                    let _e1304 = phi_1719_;
                    let _e1306 = phi_1722_;
                    let _e1308 = phi_1724_;
                    continue;
                    continuing {
                        phi_1718_ = _e1304;
                        phi_1721_ = _e1306;
                        phi_1723_ = _e1308;
                        break if !(_e810);
                    }
                }
                let _e1311 = local;
                if _e1311 {
                    let _e1313 = local_1;
                    let _e1316 = local_2;
                    phi_2605_ = _e790;
                    phi_2608_ = SlimbvhTypeE(0u, ((_e1316 >> bitcast<u32>(28u)) & 7u));
                    loop {
                        let _e1323 = phi_2605_;
                        let _e1325 = phi_2608_;
                        local_5 = _e1323;
                        local_8 = _e1323;
                        if (_e1325.member < _e1325.member_1) {
                            phi_2609_ = SlimbvhTypeE((_e1325.member + 1u), _e1325.member_1);
                            phi_2631_ = SlimbvhTypeE(1u, _e1325.member);
                        } else {
                            phi_2609_ = _e1325;
                            phi_2631_ = SlimbvhTypeE(0u, SlimbvhTypeE().member_1);
                        }
                        let _e1338 = phi_2609_;
                        let _e1340 = phi_2631_;
                        let _e1344 = (bitcast<i32>(_e1340.member) != 0i);
                        if _e1344 {
                            let _e1345 = (((_e1313 & 268435455u) + _e159) + _e1340.member_1);
                            let _e1346 = (_e1345 / 2u);
                            let _e1347 = (_e1345 % 2u);
                            let _e1348 = (_e1346 >= arrayLength((&slimbvh_triangles.member)));
                            if _e1348 {
                                phi_2711_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e1349 = (2u * _e1347);
                                let _e1353 = slimbvh_triangles.member[_e1346][_e1349];
                                let _e1358 = slimbvh_triangles.member[_e1346][(_e1349 + 1u)];
                                let _e1363 = slimbvh_triangles.member[_e1346][(_e1349 + 2u)];
                                if (_e1347 == 0u) {
                                    phi_2710_ = array<vec4<f32>, 3>(_e1353, _e1358, _e1363);
                                } else {
                                    phi_2710_ = array<vec4<f32>, 3>(vec4<f32>(_e1353.z, _e1353.w, _e1358.x, _e1358.y), vec4<f32>(_e1358.z, _e1358.w, _e1363.x, _e1363.y), vec4<f32>(_e1363.z, _e1363.w, 0f, 0f));
                                }
                                let _e1381 = phi_2710_;
                                phi_2711_ = _e1381;
                            }
                            let _e1383 = phi_2711_;
                            let _e1386 = bitcast<u32>(_e1383[2].y);
                            if _e1348 {
                                phi_2792_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e1387 = (2u * _e1347);
                                let _e1391 = slimbvh_triangles.member[_e1346][_e1387];
                                let _e1396 = slimbvh_triangles.member[_e1346][(_e1387 + 1u)];
                                let _e1401 = slimbvh_triangles.member[_e1346][(_e1387 + 2u)];
                                if (_e1347 == 0u) {
                                    phi_2791_ = array<vec4<f32>, 3>(_e1391, _e1396, _e1401);
                                } else {
                                    phi_2791_ = array<vec4<f32>, 3>(vec4<f32>(_e1391.z, _e1391.w, _e1396.x, _e1396.y), vec4<f32>(_e1396.z, _e1396.w, _e1401.x, _e1401.y), vec4<f32>(_e1401.z, _e1401.w, 0f, 0f));
                                }
                                let _e1419 = phi_2791_;
                                phi_2792_ = _e1419;
                            }
                            let _e1421 = phi_2792_;
                            if _e224 {
                                phi_2816_ = array<f32, 3>(_e1421[0].x, _e1421[0].y, _e1421[0].z);
                            } else {
                                if (_e219 == 1u) {
                                    phi_2815_ = array<f32, 3>(_e1421[0].y, _e1421[0].z, _e1421[0].x);
                                } else {
                                    phi_2815_ = array<f32, 3>(_e1421[0].z, _e1421[0].x, _e1421[0].y);
                                }
                                let _e1444 = phi_2815_;
                                phi_2816_ = _e1444;
                            }
                            let _e1447 = phi_2816_;
                            if _e224 {
                                phi_2831_ = array<f32, 3>(_e1421[0].w, _e1421[1].x, _e1421[1].y);
                            } else {
                                if (_e219 == 1u) {
                                    phi_2830_ = array<f32, 3>(_e1421[1].x, _e1421[1].y, _e1421[0].w);
                                } else {
                                    phi_2830_ = array<f32, 3>(_e1421[1].y, _e1421[0].w, _e1421[1].x);
                                }
                                let _e1452 = phi_2830_;
                                phi_2831_ = _e1452;
                            }
                            let _e1455 = phi_2831_;
                            if _e224 {
                                phi_2846_ = array<f32, 3>(_e1421[1].z, _e1421[1].w, _e1421[2].x);
                            } else {
                                if (_e219 == 1u) {
                                    phi_2845_ = array<f32, 3>(_e1421[1].w, _e1421[2].x, _e1421[1].z);
                                } else {
                                    phi_2845_ = array<f32, 3>(_e1421[2].x, _e1421[1].z, _e1421[1].w);
                                }
                                let _e1460 = phi_2845_;
                                phi_2846_ = _e1460;
                            }
                            let _e1463 = phi_2846_;
                            let _e1477 = (_e1447[2] - _e607.member[2]);
                            let _e1480 = (((_e1447[0] - _e607.member[0]) * _e662) - (_e1477 * _e630));
                            let _e1483 = (((_e1447[1] - _e607.member[1]) * _e662) - (_e1477 * _e646));
                            let _e1486 = (_e1455[2] - _e607.member[2]);
                            let _e1489 = (((_e1455[0] - _e607.member[0]) * _e662) - (_e1486 * _e630));
                            let _e1492 = (((_e1455[1] - _e607.member[1]) * _e662) - (_e1486 * _e646));
                            let _e1495 = (_e1463[2] - _e607.member[2]);
                            let _e1498 = (((_e1463[0] - _e607.member[0]) * _e662) - (_e1495 * _e630));
                            let _e1501 = (((_e1463[1] - _e607.member[1]) * _e662) - (_e1495 * _e646));
                            let _e1502 = (_e1498 * _e1492);
                            let _e1503 = (_e1501 * _e1489);
                            let _e1504 = (_e1480 * _e1501);
                            let _e1505 = (_e1483 * _e1498);
                            let _e1506 = (_e1489 * _e1483);
                            let _e1507 = (_e1492 * _e1480);
                            let _e1512 = (((_e1502 >= _e1503) && (_e1504 >= _e1505)) && (_e1506 >= _e1507));
                            let _e1518 = (_e1512 || (((_e1502 <= _e1503) && (_e1504 <= _e1505)) && (_e1506 <= _e1507)));
                            if _e1518 {
                                let _e1520 = select(-1f, 1f, _e1512);
                                let _e1522 = ((_e1502 - _e1503) * _e1520);
                                let _e1524 = select(0f, _e1522, (_e1522 > 0f));
                                let _e1526 = ((_e1504 - _e1505) * _e1520);
                                let _e1528 = select(0f, _e1526, (_e1526 > 0f));
                                let _e1530 = ((_e1506 - _e1507) * _e1520);
                                let _e1532 = select(0f, _e1530, (_e1530 > 0f));
                                let _e1534 = ((_e1524 + _e1528) + _e1532);
                                let _e1549 = ((min(min(_e1447[0], _e1455[0]), _e1463[0]) - _e631) * _e634);
                                let _e1550 = ((max(max(_e1447[0], _e1455[0]), _e1463[0]) - _e632) * _e634);
                                let _e1551 = vec4<f32>(_e1549, f32(), _e1550, f32());
                                let _e1554 = ((min(min(_e1447[1], _e1455[1]), _e1463[1]) - _e647) * _e650);
                                let _e1555 = ((max(max(_e1447[1], _e1455[1]), _e1463[1]) - _e648) * _e650);
                                let _e1556 = vec4<f32>(_e1554, f32(), _e1555, f32());
                                let _e1559 = ((min(min(_e1447[2], _e1455[2]), _e1463[2]) - _e663) * _e666);
                                let _e1560 = ((max(max(_e1447[2], _e1455[2]), _e1463[2]) - _e664) * _e666);
                                let _e1561 = vec4<f32>(_e1559, f32(), _e1560, f32());
                                let _e1562 = vec4<f32>(_e1550, f32(), _e1549, f32());
                                let _e1564 = vec4<f32>(_e1555, f32(), _e1554, f32());
                                let _e1566 = vec4<f32>(_e1560, f32(), _e1559, f32());
                                let _e1575 = max(max(min(_e1551, _e1562).x, min(_e1556, _e1564).x), min(_e1561, _e1566).x);
                                let _e1580 = min(min(max(_e1551, _e1562).x, max(_e1556, _e1564).x), max(_e1561, _e1566).x);
                                let _e1585 = max(_e1575, _e674);
                                let _e1607 = (((((_e1518 && (_e1534 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1480, _e1489), _e1498) <= 0f) && (max(max(_e1480, _e1489), _e1498) >= 0f))) && ((min(min(_e1483, _e1492), _e1501) <= 0f) && (max(max(_e1483, _e1492), _e1501) >= 0f))) && (_e1585 <= (_e1580 + (max(max(_e1561, _e1566).x, -(min(_e1561, _e1566).x)) * 0.0000019073523f)))) && (_e1585 <= _e1323.member.member_1));
                                if _e1607 {
                                    let _e1612 = (_e1455[0] - _e1447[0]);
                                    let _e1613 = (_e1455[1] - _e1447[1]);
                                    let _e1614 = (_e1455[2] - _e1447[2]);
                                    let _e1615 = vec3<f32>(_e1612, _e1613, _e1614);
                                    let _e1616 = (_e1463[0] - _e1455[0]);
                                    let _e1617 = (_e1463[1] - _e1455[1]);
                                    let _e1618 = (_e1463[2] - _e1455[2]);
                                    let _e1619 = vec3<f32>(_e1616, _e1617, _e1618);
                                    let _e1620 = (_e1447[0] - _e1463[0]);
                                    let _e1621 = (_e1447[1] - _e1463[1]);
                                    let _e1622 = (_e1447[2] - _e1463[2]);
                                    let _e1623 = vec3<f32>(_e1620, _e1621, _e1622);
                                    let _e1634 = max(max(bitcast<f32>((bitcast<u32>(_e1612) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1613) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1614) & 2147483647u)));
                                    let _e1645 = max(max(bitcast<f32>((bitcast<u32>(_e1616) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1617) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1618) & 2147483647u)));
                                    let _e1658 = max(max(_e1634, _e1645), max(max(bitcast<f32>((bitcast<u32>(_e1620) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1621) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1622) & 2147483647u))));
                                    if (_e1634 == _e1658) {
                                        phi_3205_ = _e1492;
                                        phi_3206_ = _e1489;
                                        phi_3207_ = _e1483;
                                        phi_3208_ = _e1480;
                                        phi_3209_ = vec3<f32>(_e1447[0], _e1447[1], _e1447[2]);
                                        phi_3210_ = _e1623;
                                        phi_3211_ = _e1619;
                                        phi_3212_ = _e1615;
                                    } else {
                                        let _e1660 = (_e1645 == _e1658);
                                        let _e1665 = vec3(_e1660);
                                        phi_3205_ = select(_e1483, _e1501, _e1660);
                                        phi_3206_ = select(_e1480, _e1498, _e1660);
                                        phi_3207_ = select(_e1501, _e1492, _e1660);
                                        phi_3208_ = select(_e1498, _e1489, _e1660);
                                        phi_3209_ = select(vec3<f32>(_e1463[0], _e1463[1], _e1463[2]), vec3<f32>(_e1455[0], _e1455[1], _e1455[2]), _e1665);
                                        phi_3210_ = select(_e1619, _e1615, _e1665);
                                        phi_3211_ = select(_e1615, _e1623, _e1665);
                                        phi_3212_ = select(_e1623, _e1619, _e1665);
                                    }
                                    let _e1671 = phi_3205_;
                                    let _e1673 = phi_3206_;
                                    let _e1675 = phi_3207_;
                                    let _e1677 = phi_3208_;
                                    let _e1679 = phi_3209_;
                                    let _e1681 = phi_3210_;
                                    let _e1683 = phi_3211_;
                                    let _e1685 = phi_3212_;
                                    let _e1692 = ((_e1683.y * _e1681.z) - (_e1681.y * _e1683.z));
                                    let _e1697 = ((_e1683.z * _e1681.x) - (_e1681.z * _e1683.x));
                                    let _e1700 = ((_e1683.x * _e1681.y) - (_e1681.x * _e1683.y));
                                    let _e1703 = ((_e1524 >= _e1528) && (_e1524 >= _e1532));
                                    let _e1704 = (_e1528 >= _e1532);
                                    let _e1718 = (((_e1692 * (select(select(_e1463[0], _e1455[0], _e1704), _e1447[0], _e1703) - _e607.member[0])) + (_e1697 * (select(select(_e1463[1], _e1455[1], _e1704), _e1447[1], _e1703) - _e607.member[1]))) + (_e1700 * (select(select(_e1463[2], _e1455[2], _e1704), _e1447[2], _e1703) - _e607.member[2])));
                                    let _e1723 = (((_e1692 * _e630) + (_e1697 * _e646)) + (_e1700 * _e662));
                                    let _e1724 = (_e1673 - _e1677);
                                    let _e1725 = (_e1671 - _e1675);
                                    let _e1728 = ((_e1724 * _e1724) + (_e1725 * _e1725));
                                    let _e1735 = (-(((_e1677 * _e1724) + (_e1675 * _e1725))) / select(0.000000000000000000000000000000000000011754944f, _e1728, (_e1728 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e1737 = select(1f, _e1735, (_e1735 < 1f));
                                    let _e1739 = select(0f, _e1737, (_e1737 > 0f));
                                    let _e1748 = ((_e1679.x + (_e1685.x * _e1739)) - _e607.member[0]);
                                    let _e1751 = ((_e1679.y + (_e1685.y * _e1739)) - _e607.member[1]);
                                    let _e1754 = ((_e1679.z + (_e1685.z * _e1739)) - _e607.member[2]);
                                    let _e1819 = ((bitcast<f32>((bitcast<u32>(((((_e1692 * _e1748) + (_e1697 * _e1751)) + (_e1700 * _e1754)) - _e1718)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1748) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1751) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1754) & 2147483647u))), _e1658)) * max(max(bitcast<f32>((bitcast<u32>(_e1692) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1697) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1700) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1723) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1683.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1683.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1683.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1681.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1681.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1681.z) & 2147483647u)))))));
                                    let _e1820 = (_e1718 / _e1723);
                                    if (_e1607 && !(_e1819)) {
                                        let _e1823 = (_e1754 / _e662);
                                        let _e1831 = (((_e1692 * (_e1748 - (_e630 * _e1823))) + (_e1697 * (_e1751 - (_e646 * _e1823)))) / _e1723);
                                        phi_3391_ = select(select(_e1823, (_e1823 + _e1831), (bitcast<f32>((bitcast<u32>(_e1831) & 2147483647u)) <= _e1658)), _e1820, _e1819);
                                    } else {
                                        phi_3391_ = _e1820;
                                    }
                                    let _e1840 = phi_3391_;
                                    let _e1842 = select(_e1580, _e1840, (_e1840 < _e1580));
                                    let _e1844 = select(_e1575, _e1842, (_e1842 > _e1575));
                                    let _e1847 = select(_e1844, 0f, (bitcast<u32>(_e1844) == 2147483648u));
                                    let _e1848 = (1f / _e1534);
                                    phi_3417_ = SlimbvhTypeF(_e1847, (_e1528 * _e1848), (_e1532 * _e1848), ((_e1607 && (_e1847 >= _e674)) && (_e1847 <= _e1323.member.member_1)));
                                    phi_3418_ = SlimbvhTypeF();
                                } else {
                                    phi_3417_ = SlimbvhTypeF();
                                    phi_3418_ = SlimbvhTypeF(0f, 0f, 0f, _e1607);
                                }
                                let _e1857 = phi_3417_;
                                let _e1859 = phi_3418_;
                                phi_3421_ = _e1857;
                                phi_3422_ = _e1859;
                                phi_3423_ = select(true, false, _e1607);
                            } else {
                                phi_3421_ = SlimbvhTypeF();
                                phi_3422_ = SlimbvhTypeF(0f, 0f, 0f, _e1518);
                                phi_3423_ = true;
                            }
                            let _e1862 = phi_3421_;
                            let _e1864 = phi_3422_;
                            let _e1866 = phi_3423_;
                            if _e1866 {
                                phi_3427_ = _e1864;
                            } else {
                                phi_3427_ = _e1862;
                            }
                            let _e1868 = phi_3427_;
                            if _e1868.member_3 {
                                phi_3436_ = SlimbvhTypeG(_e1868.member, _e1868.member_1, _e1868.member_2, _e1386);
                            } else {
                                phi_3436_ = _e99;
                            }
                            let _e1875 = phi_3436_;
                            if (_e1875.member_3 != 4294967295u) {
                                let _e1881 = slimbvh_target.member[0u][0u];
                                let _e1885 = slimbvh_target.member[0u][1u];
                                let _e1889 = slimbvh_target.member[0u][2u];
                                let _e1893 = slimbvh_target.member[0u][3u];
                                let _e1897 = slimbvh_target.member[1u][0u];
                                let _e1901 = slimbvh_target.member[1u][1u];
                                let _e1905 = slimbvh_target.member[1u][2u];
                                let _e1909 = slimbvh_target.member[1u][3u];
                                let _e1910 = bitcast<f32>(_e1881);
                                let _e1911 = bitcast<f32>(_e1885);
                                let _e1912 = bitcast<f32>(_e1889);
                                let _e1914 = bitcast<f32>(_e1897);
                                let _e1915 = array<u32, 3>(_e1901, _e1905, _e1909);
                                if (_e177 < -126i) {
                                    phi_3489_ = -126i;
                                } else {
                                    phi_3489_ = select(_e177, 127i, (_e177 > 127i));
                                }
                                let _e1921 = phi_3489_;
                                let _e1926 = bitcast<f32>((bitcast<u32>((_e1921 + 127i)) << bitcast<u32>(23i)));
                                let _e1932 = bitcast<f32>((bitcast<u32>(((_e177 - _e1921) + 127i)) << bitcast<u32>(23i)));
                                if (_e1893 == 0u) {
                                    phi_3629_ = SlimbvhTypeI(array<f32, 3>(_e1910, _e1911, _e1912), _e1893, _e1914, _e1915);
                                } else {
                                    let _e1934 = bitcast<u32>(_e1910);
                                    let _e1936 = ((_e1934 & 2139095040u) != 0u);
                                    let _e1951 = bitcast<u32>(_e1911);
                                    let _e1953 = ((_e1951 & 2139095040u) != 0u);
                                    let _e1968 = bitcast<u32>(_e1912);
                                    let _e1970 = ((_e1968 & 2139095040u) != 0u);
                                    let _e1986 = bitcast<u32>(_e1914);
                                    let _e1988 = ((_e1986 & 2139095040u) != 0u);
                                    phi_3629_ = SlimbvhTypeI(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1934 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1934 & 2147483648u))), _e1910, _e1936) * _e1926) * select(0.00000011920929f, 1f, _e1936)) * _e1932), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1951 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1951 & 2147483648u))), _e1911, _e1953) * _e1926) * select(0.00000011920929f, 1f, _e1953)) * _e1932), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1968 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1968 & 2147483648u))), _e1912, _e1970) * _e1926) * select(0.00000011920929f, 1f, _e1970)) * _e1932)), _e1893, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1986 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1986 & 2147483648u))), _e1914, _e1988) * _e1926) * select(0.00000011920929f, 1f, _e1988)) * _e1932), _e1915);
                                }
                                let _e2005 = phi_3629_;
                                if (_e1386 == _e678) {
                                    phi_3955_ = false;
                                } else {
                                    let _e2007 = (_e1386 / 16u);
                                    if (_e2007 < arrayLength((&slimbvh_sides.member))) {
                                        let _e2010 = slimbvh_sides.member[_e2007];
                                        phi_3653_ = _e2010;
                                    } else {
                                        phi_3653_ = 0u;
                                    }
                                    let _e2012 = phi_3653_;
                                    let _e2021 = (bitcast<i32>((_e2012 << bitcast<u32>(((30u - ((_e1386 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                    let _e2022 = (_e2021 == 0i);
                                    if _e2022 {
                                        phi_3954_ = true;
                                    } else {
                                        if _e224 {
                                            phi_3682_ = vec3<f32>(_e1447[0], _e1447[1], _e1447[2]);
                                        } else {
                                            if (_e219 == 1u) {
                                                phi_3681_ = vec3<f32>(_e1447[2], _e1447[0], _e1447[1]);
                                            } else {
                                                phi_3681_ = vec3<f32>(_e1447[1], _e1447[2], _e1447[0]);
                                            }
                                            let _e2027 = phi_3681_;
                                            phi_3682_ = _e2027;
                                        }
                                        let _e2030 = phi_3682_;
                                        if _e224 {
                                            phi_3700_ = vec3<f32>(_e1455[0], _e1455[1], _e1455[2]);
                                        } else {
                                            if (_e219 == 1u) {
                                                phi_3699_ = vec3<f32>(_e1455[2], _e1455[0], _e1455[1]);
                                            } else {
                                                phi_3699_ = vec3<f32>(_e1455[1], _e1455[2], _e1455[0]);
                                            }
                                            let _e2035 = phi_3699_;
                                            phi_3700_ = _e2035;
                                        }
                                        let _e2038 = phi_3700_;
                                        if _e224 {
                                            phi_3718_ = vec3<f32>(_e1463[0], _e1463[1], _e1463[2]);
                                        } else {
                                            if (_e219 == 1u) {
                                                phi_3717_ = vec3<f32>(_e1463[2], _e1463[0], _e1463[1]);
                                            } else {
                                                phi_3717_ = vec3<f32>(_e1463[1], _e1463[2], _e1463[0]);
                                            }
                                            let _e2043 = phi_3717_;
                                            phi_3718_ = _e2043;
                                        }
                                        let _e2046 = phi_3718_;
                                        let _e2049 = (_e2038.x - _e2030.x);
                                        let _e2052 = (_e2038.y - _e2030.y);
                                        let _e2055 = (_e2038.z - _e2030.z);
                                        let _e2057 = (_e2046.x - _e2030.x);
                                        let _e2059 = (_e2046.y - _e2030.y);
                                        let _e2061 = (_e2046.z - _e2030.z);
                                        if (_e2005.member_1 == 1u) {
                                            phi_3754_ = (vec3<f32>(_e2005.member[0], _e2005.member[1], _e2005.member[2]) - _e2030);
                                        } else {
                                            phi_3754_ = vec3<f32>(_e2005.member[0], _e2005.member[1], _e2005.member[2]);
                                        }
                                        let _e2076 = phi_3754_;
                                        let _e2082 = bitcast<f32>((bitcast<u32>((_e2049 * _e2059)) ^ _e2005.member_3[0]));
                                        let _e2086 = bitcast<f32>((bitcast<u32>((_e2052 * _e2057)) ^ _e2005.member_3[0]));
                                        let _e2090 = bitcast<f32>((bitcast<u32>((_e2052 * _e2061)) ^ _e2005.member_3[0]));
                                        let _e2094 = bitcast<f32>((bitcast<u32>((_e2055 * _e2059)) ^ _e2005.member_3[0]));
                                        let _e2098 = bitcast<f32>((bitcast<u32>((_e2055 * _e2057)) ^ _e2005.member_3[0]));
                                        let _e2102 = bitcast<f32>((bitcast<u32>((_e2049 * _e2061)) ^ _e2005.member_3[0]));
                                        let _e2103 = (_e2090 - _e2094);
                                        let _e2104 = (_e2098 - _e2102);
                                        let _e2105 = (_e2082 - _e2086);
                                        let _e2129 = (bitcast<f32>((bitcast<u32>(_e2090) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2094) & 2147483647u)));
                                        let _e2136 = (bitcast<f32>((bitcast<u32>(_e2098) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2102) & 2147483647u)));
                                        let _e2143 = (bitcast<f32>((bitcast<u32>(_e2082) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2086) & 2147483647u)));
                                        if (_e2005.member_2 == 0f) {
                                            phi_3936_ = 0f;
                                        } else {
                                            let _e2173 = bitcast<f32>((bitcast<u32>(_e2103) & 2147483647u));
                                            let _e2176 = bitcast<f32>((bitcast<u32>(_e2104) & 2147483647u));
                                            let _e2179 = bitcast<f32>((bitcast<u32>(_e2105) & 2147483647u));
                                            let _e2181 = select(_e2179, _e2176, (_e2176 > _e2179));
                                            let _e2185 = select(_e2179, _e2176, (_e2176 < _e2179));
                                            let _e2189 = select(_e2176, _e2173, (_e2173 < _e2176));
                                            let _e2191 = select(_e2176, _e2173, (_e2173 > _e2176));
                                            let _e2193 = select(_e2179, _e2191, (_e2191 < _e2179));
                                            phi_3936_ = bitcast<f32>((bitcast<u32>((_e2005.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2181, _e2173, (_e2173 > _e2181)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2193, _e2189, (_e2189 > _e2193)))) ^ _e2005.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2185, _e2173, (_e2173 < _e2185)))) ^ _e2005.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2129 + _e2136) + _e2143))) ^ _e2005.member_3[0]))) * 1.0000005f)) ^ _e2005.member_3[0])))) ^ _e2005.member_3[0]));
                                        }
                                        let _e2220 = phi_3936_;
                                        phi_3954_ = (_e2022 || !(((((bitcast<f32>((bitcast<u32>((_e2076.x * _e2103)) ^ _e2005.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2076.y * _e2104)) ^ _e2005.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2076.z * _e2105)) ^ _e2005.member_3[0]))) * f32(-(_e2021))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2076.x) & 2147483647u)) * _e2129)) ^ _e2005.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2076.y) & 2147483647u)) * _e2136)) ^ _e2005.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2076.z) & 2147483647u)) * _e2143)) ^ _e2005.member_3[0]))))) ^ _e2005.member_3[0])) + _e2220) + 0.0000000000000000000000000000000000001880791f))));
                                    }
                                    let _e2234 = phi_3954_;
                                    phi_3955_ = _e2234;
                                }
                                let _e2236 = phi_3955_;
                                if _e2236 {
                                    if (_e1875.member < _e1323.member.member.member) {
                                        phi_3975_ = true;
                                    } else {
                                        if (_e1875.member == _e1323.member.member.member) {
                                            phi_3974_ = (_e1875.member_3 < _e1323.member.member.member_3);
                                        } else {
                                            phi_3974_ = false;
                                        }
                                        let _e2248 = phi_3974_;
                                        phi_3975_ = _e2248;
                                    }
                                    let _e2250 = phi_3975_;
                                    if _e2250 {
                                        phi_3982_ = SlimbvhTypeP(SlimbvhTypeJ(_e1875, _e1875.member), _e1323.member_1);
                                    } else {
                                        phi_3982_ = _e1323;
                                    }
                                    let _e2256 = phi_3982_;
                                    if _e2256.member_1 {
                                        phi_3988_ = SlimbvhTypeP(SlimbvhTypeJ(_e2256.member.member, bitcast<f32>(4286578687u)), _e2256.member_1);
                                    } else {
                                        phi_3988_ = _e2256;
                                    }
                                    let _e2265 = phi_3988_;
                                    phi_3989_ = _e2265;
                                } else {
                                    phi_3989_ = _e1323;
                                }
                                let _e2267 = phi_3989_;
                                phi_3990_ = _e2267;
                            } else {
                                phi_3990_ = _e1323;
                            }
                            let _e2269 = phi_3990_;
                            phi_2606_ = _e2269;
                        } else {
                            phi_2606_ = SlimbvhTypeP();
                        }
                        let _e2271 = phi_2606_;
                        continue;
                        continuing {
                            phi_2605_ = _e2271;
                            phi_2608_ = _e1338;
                            break if !(_e1344);
                        }
                    }
                    let _e2274 = local_3;
                    let _e2275 = (_e2274 - 1u);
                    let _e2280 = slimbvh_stacks[(((_e2275 % 32u) * 64u) + _e681)];
                    let _e2281 = (_e2280 & 511u);
                    let _e2283 = (_e2281 >> bitcast<u32>(3u));
                    let _e2286 = ((_e2283 == 0u) || (_e2275 == 4294967295u));
                    if _e2286 {
                    } else {
                        slimbvh_stacks[(((_e2275 % 32u) * 64u) + _e681)] = (((_e2280 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2283);
                    }
                    let _e2293 = local_4;
                    let _e2301 = (((_e2280 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2281 & 3u) & 3u));
                    let _e2303 = (_e2301 >> bitcast<u32>(2i));
                    if (_e2303 < _e103) {
                        let _e2309 = slimbvh_nodes.member[_e2303].member_1[(_e2301 & 3u)];
                        phi_4051_ = _e2309;
                    } else {
                        phi_4051_ = 2147483648u;
                    }
                    let _e2311 = phi_4051_;
                    let _e2313 = local_5;
                    let _e2598 = local_8;
                    phi_4060_ = _e2598;
                    phi_4061_ = select(select(_e2293, _e2275, _e2286), 4294967295u, (_e674 > _e2313.member.member_1));
                    phi_4062_ = _e2311;
                } else {
                    phi_4060_ = _e790;
                    let _e2601 = local_9;
                    phi_4061_ = _e2601;
                    let _e2604 = local_10;
                    phi_4062_ = _e2604;
                }
                let _e2319 = phi_4060_;
                let _e2321 = phi_4061_;
                let _e2323 = phi_4062_;
                phi_1703_ = _e2319;
                phi_1706_ = _e2321;
                phi_1708_ = _e2323;
                let _e2610 = local_11;
                phi_1710_ = _e2610;
            } else {
                phi_1703_ = SlimbvhTypeP();
                phi_1706_ = u32();
                phi_1708_ = u32();
                phi_1710_ = u32();
            }
            let _e2325 = phi_1703_;
            let _e2327 = phi_1706_;
            let _e2329 = phi_1708_;
            let _e2331 = phi_1710_;
            continue;
            continuing {
                phi_1702_ = _e2325;
                phi_1705_ = _e2327;
                phi_1707_ = _e2329;
                phi_1709_ = _e2331;
                break if !(_e797);
            }
        }
        let _e2334 = local_6;
        let _e2335 = (_e2334 == 4294967295u);
        let _e2337 = local_7;
        if (_e2337.member.member.member_3 != 4294967295u) {
            let _e2343 = -((_e177 + _e607.member_4));
            let _e2344 = bitcast<u32>(_e2337.member.member.member);
            let _e2348 = (bitcast<i32>((_e2344 >> bitcast<u32>(23i))) & 255i);
            let _e2349 = (_e2348 + _e2343);
            if (_e2348 == 255i) {
                phi_4120_ = _e2337.member.member.member;
            } else {
                if (_e2348 > 0i) {
                    if (_e2349 > 0i) {
                        let _e2353 = (_e2349 < 255i);
                        if _e2353 {
                            phi_4099_ = bitcast<f32>((_e2344 + bitcast<u32>((_e2343 << bitcast<u32>(23i)))));
                        } else {
                            phi_4099_ = f32();
                        }
                        let _e2360 = phi_4099_;
                        phi_4101_ = _e2360;
                        phi_4102_ = select(true, false, _e2353);
                    } else {
                        phi_4101_ = f32();
                        phi_4102_ = true;
                    }
                    let _e2363 = phi_4101_;
                    let _e2365 = phi_4102_;
                    phi_4103_ = _e2363;
                    phi_4104_ = _e2365;
                } else {
                    phi_4103_ = f32();
                    phi_4104_ = true;
                }
                let _e2367 = phi_4103_;
                let _e2369 = phi_4104_;
                if _e2369 {
                    let _e2370 = (_e2344 & 2147483648u);
                    let _e2377 = ((_e2344 & 8388607u) | (select(0u, 1u, ((_e2344 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e2381 = (_e2377 == 0u);
                    if _e2381 {
                        phi_4802_ = bitcast<f32>(_e2370);
                    } else {
                        let _e2386 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2377)), 32u, _e2381) - 8u);
                        let _e2389 = (_e2377 << bitcast<u32>((_e2386 & 31u)));
                        let _e2391 = ((_e2349 + select(0i, 1i, (_e2348 == 0i))) - bitcast<i32>(_e2386));
                        if (_e2391 >= 255i) {
                            phi_4792_ = bitcast<f32>((_e2370 | 2139095040u));
                            phi_4793_ = f32();
                            phi_4794_ = true;
                        } else {
                            let _e2393 = (_e2391 > 0i);
                            if _e2393 {
                                phi_4786_ = bitcast<f32>(((_e2370 | (bitcast<u32>(_e2391) << bitcast<u32>(23i))) | (_e2389 & 8388607u)));
                                phi_4787_ = f32();
                            } else {
                                if (_e2391 < -24i) {
                                    phi_4752_ = 26u;
                                } else {
                                    phi_4752_ = bitcast<u32>((1i - _e2391));
                                }
                                let _e2398 = phi_4752_;
                                let _e2399 = (_e2398 & 31u);
                                let _e2401 = (_e2389 >> bitcast<u32>(_e2399));
                                let _e2405 = (_e2389 & ((1u << bitcast<u32>(_e2399)) - 1u));
                                let _e2409 = (1u << bitcast<u32>(((_e2398 - 1u) & 31u)));
                                if (_e2405 > _e2409) {
                                    phi_4773_ = true;
                                } else {
                                    if (_e2405 == _e2409) {
                                        phi_4770_ = ((_e2401 & 1u) == 1u);
                                    } else {
                                        phi_4770_ = false;
                                    }
                                    let _e2415 = phi_4770_;
                                    phi_4773_ = _e2415;
                                }
                                let _e2417 = phi_4773_;
                                phi_4786_ = f32();
                                phi_4787_ = bitcast<f32>((_e2370 | (_e2401 + select(0u, 1u, _e2417))));
                            }
                            let _e2430 = phi_4786_;
                            let _e2432 = phi_4787_;
                            phi_4792_ = _e2430;
                            phi_4793_ = _e2432;
                            phi_4794_ = _e2393;
                        }
                        let _e2436 = phi_4792_;
                        let _e2438 = phi_4793_;
                        let _e2440 = phi_4794_;
                        phi_4802_ = select(_e2438, _e2436, _e2440);
                    }
                    let _e2444 = phi_4802_;
                    phi_4119_ = _e2444;
                } else {
                    phi_4119_ = _e2367;
                }
                let _e2446 = phi_4119_;
                phi_4120_ = _e2446;
            }
            let _e2448 = phi_4120_;
            let _e2449 = bitcast<u32>(_e2448);
            if ((_e2449 & 2147483647u) >= 2139095040u) {
                phi_4132_ = bitcast<f32>(((_e2449 & 2147483648u) | 2139095039u));
            } else {
                phi_4132_ = _e2448;
            }
            let _e2456 = phi_4132_;
            phi_4137_ = SlimbvhTypeG(_e2456, _e2337.member.member.member_1, _e2337.member.member.member_2, _e2337.member.member.member_3);
        } else {
            phi_4137_ = _e99;
        }
        let _e2461 = phi_4137_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2461.member), bitcast<u32>(_e2461.member_1), bitcast<u32>(_e2461.member_2), _e2461.member_3);
        phi_4150_ = _e2335;
        phi_4151_ = _e2335;
        phi_4152_ = select(true, false, _e2335);
    } else {
        phi_4150_ = bool();
        phi_4151_ = false;
        phi_4152_ = true;
    }
    let _e2472 = phi_4150_;
    let _e2474 = phi_4151_;
    let _e2476 = phi_4152_;
    if _e2476 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e2472, _e2474, _e2476)));
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
