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
    var phi_603_: u32;
    var phi_609_: u32;
    var phi_615_: u32;
    var phi_880_: i32;
    var phi_891_: i32;
    var phi_1005_: i32;
    var phi_1134_: i32;
    var phi_1156_: u32;
    var phi_1157_: u32;
    var phi_1158_: bool;
    var phi_1192_: i32;
    var phi_1214_: u32;
    var phi_1215_: u32;
    var phi_1216_: bool;
    var phi_777_: i32;
    var phi_783_: u32;
    var phi_802_: u32;
    var phi_803_: u32;
    var phi_804_: bool;
    var phi_822_: i32;
    var phi_828_: u32;
    var phi_847_: u32;
    var phi_848_: u32;
    var phi_849_: bool;
    var phi_1226_: SlimbvhTypeC;
    var phi_1472_: SlimbvhTypeP;
    var phi_1535_: array<f32, 3>;
    var phi_1536_: array<f32, 3>;
    var phi_1554_: array<f32, 3>;
    var phi_1555_: array<f32, 3>;
    var phi_1728_: SlimbvhTypeP;
    var phi_1731_: u32;
    var phi_1733_: u32;
    var phi_1735_: u32;
    var phi_1744_: u32;
    var phi_1747_: u32;
    var phi_1749_: u32;
    var phi_1851_: SlimbvhTypeJ;
    var phi_1852_: SlimbvhTypeJ;
    var phi_1911_: SlimbvhTypeJ;
    var phi_1912_: SlimbvhTypeJ;
    var phi_1971_: SlimbvhTypeJ;
    var phi_1972_: SlimbvhTypeJ;
    var phi_2462_: u32;
    var phi_2475_: u32;
    var phi_2488_: u32;
    var phi_2501_: u32;
    var phi_5247_: SlimbvhTypeD;
    var phi_5259_: SlimbvhTypeD;
    var phi_5271_: SlimbvhTypeD;
    var phi_5283_: SlimbvhTypeD;
    var phi_5295_: SlimbvhTypeD;
    var phi_2585_: u32;
    var phi_2590_: u32;
    var phi_2591_: u32;
    var phi_2645_: u32;
    var phi_2646_: u32;
    var phi_1745_: u32;
    var phi_1748_: u32;
    var phi_1750_: u32;
    var local: bool;
    var local_1: u32;
    var phi_2831_: u32;
    var phi_2836_: u32;
    var phi_2879_: SlimbvhTypeM;
    var phi_2883_: SlimbvhTypeP;
    var phi_2886_: SlimbvhTypeD;
    var phi_2887_: SlimbvhTypeD;
    var phi_2909_: SlimbvhTypeD;
    var phi_2937_: u32;
    var phi_2960_: u32;
    var phi_2969_: u32;
    var phi_2979_: u32;
    var phi_3438_: u32;
    var phi_3451_: u32;
    var phi_3464_: u32;
    var phi_3490_: u32;
    var phi_3503_: u32;
    var phi_3516_: u32;
    var phi_3542_: u32;
    var phi_3555_: u32;
    var phi_3568_: u32;
    var phi_3160_: u32;
    var phi_3173_: u32;
    var phi_3183_: u32;
    var phi_3204_: u32;
    var phi_3225_: u32;
    var phi_3252_: u32;
    var phi_3265_: u32;
    var phi_3275_: u32;
    var phi_3296_: u32;
    var phi_3317_: u32;
    var phi_3344_: u32;
    var phi_3357_: u32;
    var phi_3367_: u32;
    var phi_3388_: u32;
    var phi_3409_: u32;
    var phi_3021_: u32;
    var phi_3067_: u32;
    var phi_3113_: u32;
    var phi_3580_: array<array<f32, 3>, 3>;
    var phi_3945_: f32;
    var phi_3946_: f32;
    var phi_3947_: f32;
    var phi_3948_: f32;
    var phi_3949_: vec3<f32>;
    var phi_3950_: vec3<f32>;
    var phi_3951_: vec3<f32>;
    var phi_3952_: vec3<f32>;
    var phi_4131_: f32;
    var phi_4157_: SlimbvhTypeE;
    var phi_4158_: SlimbvhTypeE;
    var phi_4161_: SlimbvhTypeE;
    var phi_4162_: SlimbvhTypeE;
    var phi_4163_: bool;
    var phi_4167_: SlimbvhTypeE;
    var phi_4176_: SlimbvhTypeF;
    var phi_4229_: i32;
    var phi_4369_: SlimbvhTypeH;
    var phi_4393_: u32;
    var phi_4422_: vec3<f32>;
    var phi_4423_: vec3<f32>;
    var phi_4441_: vec3<f32>;
    var phi_4442_: vec3<f32>;
    var phi_4460_: vec3<f32>;
    var phi_4461_: vec3<f32>;
    var phi_4497_: vec3<f32>;
    var phi_4679_: f32;
    var phi_4697_: bool;
    var phi_4698_: bool;
    var phi_4717_: bool;
    var phi_4718_: bool;
    var phi_4725_: SlimbvhTypeP;
    var phi_4731_: SlimbvhTypeP;
    var phi_4732_: SlimbvhTypeP;
    var phi_4733_: SlimbvhTypeP;
    var phi_2884_: SlimbvhTypeP;
    var local_2: u32;
    var local_3: u32;
    var phi_4824_: u32;
    var phi_4825_: u32;
    var local_4: SlimbvhTypeP;
    var phi_4834_: SlimbvhTypeP;
    var phi_4835_: u32;
    var phi_4836_: u32;
    var phi_1729_: SlimbvhTypeP;
    var phi_1732_: u32;
    var phi_1734_: u32;
    var phi_1736_: u32;
    var local_5: u32;
    var local_6: SlimbvhTypeP;
    var phi_4873_: f32;
    var phi_4875_: f32;
    var phi_4876_: bool;
    var phi_4877_: f32;
    var phi_4878_: bool;
    var phi_5526_: u32;
    var phi_5544_: bool;
    var phi_5547_: bool;
    var phi_5560_: f32;
    var phi_5561_: f32;
    var phi_5566_: f32;
    var phi_5567_: f32;
    var phi_5568_: bool;
    var phi_5576_: f32;
    var phi_4893_: f32;
    var phi_4894_: f32;
    var phi_4906_: f32;
    var phi_4911_: SlimbvhTypeF;
    var phi_4924_: bool;
    var phi_4925_: bool;
    var phi_4926_: bool;
    var local_7: SlimbvhTypeP;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e123 = SlimbvhTypeF(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e127 = arrayLength((&slimbvh_nodes.member));
    let _e130 = arrayLength((&slimbvh_triangles.member));
    let _e142 = slimbvh_root.member[0u][0u];
    let _e146 = slimbvh_root.member[0u][1u];
    let _e150 = slimbvh_root.member[0u][2u];
    let _e154 = slimbvh_root.member[0u][3u];
    let _e158 = slimbvh_root.member[1u][0u];
    let _e162 = slimbvh_root.member[1u][1u];
    let _e166 = slimbvh_root.member[1u][2u];
    let _e178 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e154) + 127i)) << bitcast<u32>(23i)));
    let _e179 = slimbvh_origin.member;
    let _e185 = slimbvh_origin.member[3u];
    let _e186 = slimbvh_direction.member;
    let _e192 = slimbvh_direction.member[3u];
    let _e195 = slimbvh_exponent.member[0u];
    let _e196 = bitcast<i32>(_e195);
    let _e198 = (bitcast<u32>(_e179.x) & 2147483647u);
    let _e200 = (bitcast<u32>(_e179.y) & 2147483647u);
    let _e202 = (bitcast<u32>(_e179.z) & 2147483647u);
    let _e203 = bitcast<u32>(_e185);
    let _e204 = (_e203 & 2147483647u);
    let _e206 = (bitcast<u32>(_e186.x) & 2147483647u);
    let _e208 = (bitcast<u32>(_e186.y) & 2147483647u);
    let _e210 = (bitcast<u32>(_e186.z) & 2147483647u);
    let _e211 = bitcast<u32>(_e192);
    let _e212 = (_e211 & 2147483647u);
    let _e214 = select(_e208, _e206, (_e208 < _e206));
    let _e216 = select(_e210, _e214, (_e210 < _e214));
    let _e218 = select(_e198, _e216, (_e198 < _e216));
    let _e220 = select(_e200, _e218, (_e200 < _e218));
    let _e222 = select(_e202, _e220, (_e202 < _e220));
    let _e229 = (((select(_e204, _e222, (_e204 < _e222)) < 2139095040u) && (_e212 <= 2139095040u)) && (_e216 > 0u));
    if (_e206 == _e216) {
        phi_603_ = 0u;
    } else {
        phi_603_ = select(2u, 1u, (_e208 == _e216));
    }
    let _e234 = phi_603_;
    let _e235 = (_e234 == 2u);
    if _e235 {
        phi_609_ = 0u;
    } else {
        phi_609_ = (_e234 + 1u);
    }
    let _e238 = phi_609_;
    let _e239 = (_e238 == 2u);
    if _e239 {
        phi_615_ = 0u;
    } else {
        phi_615_ = (_e238 + 1u);
    }
    let _e242 = phi_615_;
    let _e243 = (_e238 == 0u);
    let _e245 = select(select(_e179.y, _e179.x, _e243), _e179.z, _e239);
    let _e246 = (_e242 == 0u);
    let _e248 = (_e242 == 2u);
    let _e249 = select(select(_e179.y, _e179.x, _e246), _e179.z, _e248);
    let _e250 = (_e234 == 0u);
    let _e252 = select(select(_e179.y, _e179.x, _e250), _e179.z, _e235);
    let _e254 = select(select(_e186.y, _e186.x, _e243), _e186.z, _e239);
    let _e256 = select(select(_e186.y, _e186.x, _e246), _e186.z, _e248);
    let _e258 = select(select(_e186.y, _e186.x, _e250), _e186.z, _e235);
    let _e259 = (_e204 - 1u);
    let _e260 = (_e212 - 1u);
    let _e262 = select(_e259, _e260, (_e260 < _e259));
    let _e263 = (_e198 - 1u);
    let _e264 = (_e200 - 1u);
    let _e266 = select(_e263, _e264, (_e264 < _e263));
    let _e267 = (_e202 - 1u);
    let _e269 = select(_e266, _e267, (_e267 < _e266));
    let _e270 = (_e206 - 1u);
    let _e271 = (_e208 - 1u);
    let _e273 = select(_e270, _e271, (_e271 < _e270));
    let _e274 = (_e210 - 1u);
    let _e276 = select(_e273, _e274, (_e274 < _e273));
    let _e278 = select(_e269, _e276, (_e276 < _e269));
    if (((select(_e278, _e262, (_e262 < _e278)) >= 8388607u) && (_e216 < 2130706432u)) && (bitcast<u32>((_e196 + 126i)) <= 253u)) {
        let _e543 = bitcast<i32>((_e216 >> bitcast<u32>(23i)));
        let _e544 = (_e543 - 127i);
        let _e545 = (_e196 + _e544);
        let _e550 = bitcast<f32>((bitcast<u32>((_e196 + 127i)) << bitcast<u32>(23i)));
        let _e555 = bitcast<f32>((bitcast<u32>((254i - _e543)) << bitcast<u32>(23i)));
        if (_e204 >= 2139095040u) {
            phi_777_ = 255i;
        } else {
            phi_777_ = (bitcast<i32>((_e204 >> bitcast<u32>(23i))) + _e545);
        }
        let _e570 = phi_777_;
        if (_e204 == 0u) {
            phi_783_ = 0u;
        } else {
            phi_783_ = (_e204 | 8388608u);
        }
        let _e574 = phi_783_;
        if (_e570 <= 0i) {
            phi_803_ = u32();
            phi_804_ = true;
        } else {
            let _e581 = (_e574 == 0u);
            if _e581 {
                phi_802_ = u32();
            } else {
                phi_802_ = select(((bitcast<u32>(_e570) << bitcast<u32>(23i)) | (_e574 & 8388607u)), 2139095039u, (_e570 >= 255i));
            }
            let _e585 = phi_802_;
            phi_803_ = _e585;
            phi_804_ = _e581;
        }
        let _e587 = phi_803_;
        let _e589 = phi_804_;
        if (_e212 >= 2139095040u) {
            phi_822_ = 255i;
        } else {
            phi_822_ = (bitcast<i32>((_e212 >> bitcast<u32>(23i))) + _e545);
        }
        let _e600 = phi_822_;
        if (_e212 == 0u) {
            phi_828_ = 0u;
        } else {
            phi_828_ = (_e212 | 8388608u);
        }
        let _e604 = phi_828_;
        if (_e600 <= 0i) {
            phi_848_ = u32();
            phi_849_ = true;
        } else {
            let _e611 = (_e604 == 0u);
            if _e611 {
                phi_847_ = u32();
            } else {
                phi_847_ = select(((bitcast<u32>(_e600) << bitcast<u32>(23i)) | (_e604 & 8388607u)), 2139095039u, (_e600 >= 255i));
            }
            let _e615 = phi_847_;
            phi_848_ = _e615;
            phi_849_ = _e611;
        }
        let _e617 = phi_848_;
        let _e619 = phi_849_;
        phi_1226_ = SlimbvhTypeC(array<f32, 3>((_e245 * _e550), (_e249 * _e550), (_e252 * _e550)), array<f32, 3>((_e254 * _e555), (_e256 * _e555), (_e258 * _e555)), bitcast<f32>(((_e203 & 2147483648u) | select(_e587, 0u, _e589))), bitcast<f32>(((_e211 & 2147483648u) | select(_e617, 0u, _e619))), _e544);
    } else {
        let _e291 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e216, _e229))) & 2147483647u);
        if (_e291 >= 8388608u) {
            phi_880_ = (bitcast<i32>((_e291 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_880_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e291)), 32u, (_e291 == 0u))));
        }
        let _e305 = phi_880_;
        let _e306 = (_e196 + _e305);
        if (_e196 < -126i) {
            phi_891_ = -126i;
        } else {
            phi_891_ = select(_e196, 127i, (_e196 > 127i));
        }
        let _e311 = phi_891_;
        let _e316 = bitcast<f32>((bitcast<u32>((_e311 + 127i)) << bitcast<u32>(23i)));
        let _e322 = bitcast<f32>((bitcast<u32>(((_e196 - _e311) + 127i)) << bitcast<u32>(23i)));
        let _e323 = bitcast<u32>(_e245);
        let _e325 = ((_e323 & 2139095040u) != 0u);
        let _e340 = bitcast<u32>(_e249);
        let _e342 = ((_e340 & 2139095040u) != 0u);
        let _e357 = bitcast<u32>(_e252);
        let _e359 = ((_e357 & 2139095040u) != 0u);
        let _e375 = -(_e305);
        if (_e375 < -126i) {
            phi_1005_ = -126i;
        } else {
            phi_1005_ = select(_e375, 127i, (_e375 > 127i));
        }
        let _e380 = phi_1005_;
        let _e385 = bitcast<f32>((bitcast<u32>((_e380 + 127i)) << bitcast<u32>(23i)));
        let _e391 = bitcast<f32>((bitcast<u32>(((_e375 - _e380) + 127i)) << bitcast<u32>(23i)));
        let _e392 = bitcast<u32>(_e254);
        let _e394 = ((_e392 & 2139095040u) != 0u);
        let _e409 = bitcast<u32>(_e256);
        let _e411 = ((_e409 & 2139095040u) != 0u);
        let _e426 = bitcast<u32>(_e258);
        let _e428 = ((_e426 & 2139095040u) != 0u);
        let _e450 = ((_e204 & 8388607u) | (select(0u, 1u, ((_e204 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e453 = bitcast<i32>((_e204 >> bitcast<u32>(23i)));
        let _e460 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e450)), 32u, (_e450 == 0u))) - 8i);
        if (_e453 == 255i) {
            phi_1134_ = 255i;
        } else {
            phi_1134_ = (((_e453 + select(0i, 1i, (_e453 == 0i))) - _e460) + _e306);
        }
        let _e468 = phi_1134_;
        let _e472 = (_e450 << bitcast<u32>(((_e460 & 31i) & 31i)));
        if (_e468 <= 0i) {
            phi_1157_ = u32();
            phi_1158_ = true;
        } else {
            let _e479 = (_e472 == 0u);
            if _e479 {
                phi_1156_ = u32();
            } else {
                phi_1156_ = select(((bitcast<u32>(_e468) << bitcast<u32>(23i)) | (_e472 & 8388607u)), 2139095039u, (_e468 >= 255i));
            }
            let _e483 = phi_1156_;
            phi_1157_ = _e483;
            phi_1158_ = _e479;
        }
        let _e485 = phi_1157_;
        let _e487 = phi_1158_;
        let _e498 = ((_e212 & 8388607u) | (select(0u, 1u, ((_e212 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e501 = bitcast<i32>((_e212 >> bitcast<u32>(23i)));
        let _e508 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e498)), 32u, (_e498 == 0u))) - 8i);
        if (_e501 == 255i) {
            phi_1192_ = 255i;
        } else {
            phi_1192_ = (((_e501 + select(0i, 1i, (_e501 == 0i))) - _e508) + _e306);
        }
        let _e516 = phi_1192_;
        let _e520 = (_e498 << bitcast<u32>(((_e508 & 31i) & 31i)));
        if (_e516 <= 0i) {
            phi_1215_ = u32();
            phi_1216_ = true;
        } else {
            let _e527 = (_e520 == 0u);
            if _e527 {
                phi_1214_ = u32();
            } else {
                phi_1214_ = select(((bitcast<u32>(_e516) << bitcast<u32>(23i)) | (_e520 & 8388607u)), 2139095039u, (_e516 >= 255i));
            }
            let _e531 = phi_1214_;
            phi_1215_ = _e531;
            phi_1216_ = _e527;
        }
        let _e533 = phi_1215_;
        let _e535 = phi_1216_;
        phi_1226_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e323 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e323 & 2147483648u))), _e245, _e325) * _e316) * select(0.00000011920929f, 1f, _e325)) * _e322), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e340 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e340 & 2147483648u))), _e249, _e342) * _e316) * select(0.00000011920929f, 1f, _e342)) * _e322), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e357 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e357 & 2147483648u))), _e252, _e359) * _e316) * select(0.00000011920929f, 1f, _e359)) * _e322)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e392 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e392 & 2147483648u))), _e254, _e394) * _e385) * select(0.00000011920929f, 1f, _e394)) * _e391), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e409 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e409 & 2147483648u))), _e256, _e411) * _e385) * select(0.00000011920929f, 1f, _e411)) * _e391), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e426 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e426 & 2147483648u))), _e258, _e428) * _e385) * select(0.00000011920929f, 1f, _e428)) * _e391)), bitcast<f32>(((_e203 & 2147483648u) | select(_e485, 0u, _e487))), bitcast<f32>(((_e211 & 2147483648u) | select(_e533, 0u, _e535))), _e305);
    }
    let _e626 = phi_1226_;
    let _e641 = (bitcast<f32>((bitcast<u32>(_e626.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e644 = bitcast<f32>((bitcast<u32>(_e626.member[0]) & 2147483647u));
    let _e645 = (_e644 * 0.00000011920929f);
    let _e648 = select(select(0.00000000000011368684f, _e645, (_e645 > 0.00000000000011368684f)), 0f, _e641);
    let _e649 = select(0f, _e626.member_1[0], _e641);
    let _e650 = (_e626.member[0] + _e648);
    let _e651 = (_e626.member[0] - _e648);
    let _e653 = select(38685626000000000000000000f, (1f / _e626.member_1[0]), _e641);
    let _e657 = (bitcast<f32>((bitcast<u32>(_e626.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e660 = bitcast<f32>((bitcast<u32>(_e626.member[1]) & 2147483647u));
    let _e661 = (_e660 * 0.00000011920929f);
    let _e664 = select(select(0.00000000000011368684f, _e661, (_e661 > 0.00000000000011368684f)), 0f, _e657);
    let _e665 = select(0f, _e626.member_1[1], _e657);
    let _e666 = (_e626.member[1] + _e664);
    let _e667 = (_e626.member[1] - _e664);
    let _e669 = select(38685626000000000000000000f, (1f / _e626.member_1[1]), _e657);
    let _e673 = (bitcast<f32>((bitcast<u32>(_e626.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e676 = bitcast<f32>((bitcast<u32>(_e626.member[2]) & 2147483647u));
    let _e677 = (_e676 * 0.00000011920929f);
    let _e680 = select(select(0.00000000000011368684f, _e677, (_e677 > 0.00000000000011368684f)), 0f, _e673);
    let _e681 = select(0f, _e626.member_1[2], _e673);
    let _e682 = (_e626.member[2] + _e680);
    let _e683 = (_e626.member[2] - _e680);
    let _e685 = select(38685626000000000000000000f, (1f / _e626.member_1[2]), _e673);
    let _e687 = select(_e660, _e644, (_e644 > _e660));
    let _e691 = (_e229 && (select(_e676, _e687, (_e687 > _e676)) <= 1099511600000f));
    let _e692 = select(0f, _e626.member_3, _e691);
    let _e693 = select(1f, _e626.member_2, _e691);
    let _e697 = slimbvh_question.member[1u];
    let _e698 = slimbvh_lane.member;
    if (_e698 < 64u) {
        let _e700 = (_e698 % 64u);
        let _e703 = slimbvh_question.member[0u];
        if (_e703 == 1u) {
            phi_1472_ = SlimbvhTypeP(SlimbvhTypeI(_e123, _e692), true);
        } else {
            phi_1472_ = SlimbvhTypeP(SlimbvhTypeI(_e123, _e692), false);
        }
        let _e710 = phi_1472_;
        let _e715 = (_e238 & 3u);
        let _e716 = (_e242 & 3u);
        let _e717 = (_e234 & 3u);
        let _e730 = (f32(bitcast<i32>(_e142)) * _e178);
        let _e732 = (f32(bitcast<i32>(_e146)) * _e178);
        let _e734 = (f32(bitcast<i32>(_e150)) * _e178);
        let _e735 = (_e715 == 0u);
        if _e735 {
            phi_1536_ = array<f32, 3>(_e730, _e732, _e734);
        } else {
            if (_e715 == 1u) {
                phi_1535_ = array<f32, 3>(_e732, _e734, _e730);
            } else {
                phi_1535_ = array<f32, 3>(_e734, _e730, _e732);
            }
            let _e740 = phi_1535_;
            phi_1536_ = _e740;
        }
        let _e743 = phi_1536_;
        let _e745 = (f32(bitcast<i32>(_e158)) * _e178);
        let _e747 = (f32(bitcast<i32>(_e162)) * _e178);
        let _e749 = (f32(bitcast<i32>(_e166)) * _e178);
        if _e735 {
            phi_1555_ = array<f32, 3>(_e745, _e747, _e749);
        } else {
            if (_e715 == 1u) {
                phi_1554_ = array<f32, 3>(_e747, _e749, _e745);
            } else {
                phi_1554_ = array<f32, 3>(_e749, _e745, _e747);
            }
            let _e754 = phi_1554_;
            phi_1555_ = _e754;
        }
        let _e757 = phi_1555_;
        let _e768 = ((_e743[0] - _e650) * _e653);
        let _e769 = ((_e757[0] - _e651) * _e653);
        let _e770 = vec4<f32>(_e768, f32(), _e769, f32());
        let _e773 = ((_e743[1] - _e666) * _e669);
        let _e774 = ((_e757[1] - _e667) * _e669);
        let _e775 = vec4<f32>(_e773, f32(), _e774, f32());
        let _e778 = ((_e743[2] - _e682) * _e685);
        let _e779 = ((_e757[2] - _e683) * _e685);
        let _e780 = vec4<f32>(_e778, f32(), _e779, f32());
        let _e781 = vec4<f32>(_e769, f32(), _e768, f32());
        let _e783 = vec4<f32>(_e774, f32(), _e773, f32());
        let _e785 = vec4<f32>(_e779, f32(), _e778, f32());
        phi_1728_ = _e710;
        phi_1731_ = select(4294967295u, select(4294967295u, 0u, (_e693 <= _e692)), (max(max(max(min(_e770, _e781).x, min(_e775, _e783).x), min(_e780, _e785).x), _e693) <= min((min(min(max(_e770, _e781).x, max(_e775, _e783).x), max(_e780, _e785).x) + (max(max(_e780, _e785).x, -(min(_e780, _e785).x)) * 0.0000019073523f)), _e710.member.member_1)));
        phi_1733_ = select(0u, 4294967295u, (_e127 == 0u));
        phi_1735_ = (_e127 + 1u);
        loop {
            let _e809 = phi_1728_;
            let _e811 = phi_1731_;
            let _e813 = phi_1733_;
            let _e815 = phi_1735_;
            local_5 = _e811;
            local_6 = _e809;
            let _e816 = (_e811 <= 32u);
            if _e816 {
                phi_1744_ = _e811;
                phi_1747_ = _e813;
                phi_1749_ = _e815;
                loop {
                    let _e818 = phi_1744_;
                    let _e820 = phi_1747_;
                    let _e822 = phi_1749_;
                    local_1 = _e820;
                    local_2 = _e818;
                    local_3 = _e818;
                    local_8 = _e818;
                    local_9 = _e820;
                    local_10 = _e822;
                    let _e823 = (_e818 <= 32u);
                    let _e826 = (_e823 && !((_e820 >= _e127)));
                    local = _e823;
                    if _e826 {
                        let _e831 = slimbvh_nodes.member[_e820][select(_e715, 2u, (2u < _e715))];
                        let _e836 = slimbvh_nodes.member[_e820][select(_e716, 2u, (2u < _e716))];
                        let _e841 = slimbvh_nodes.member[_e820][select(_e717, 2u, (2u < _e717))];
                        let _e844 = bitcast<u32>(_e178);
                        let _e849 = bitcast<f32>(_e831.x);
                        let _e850 = bitcast<f32>((_e844 + ((_e831.w & 31u) << bitcast<u32>(23i))));
                        let _e851 = (_e849 + _e850);
                        if ((bitcast<u32>(_e653) >> bitcast<u32>(31i)) == 0u) {
                            phi_1851_ = SlimbvhTypeJ(_e831.z, _e851);
                            phi_1852_ = SlimbvhTypeJ(_e831.y, _e849);
                        } else {
                            phi_1851_ = SlimbvhTypeJ(_e831.y, _e849);
                            phi_1852_ = SlimbvhTypeJ(_e831.z, _e851);
                        }
                        let _e862 = phi_1851_;
                        let _e864 = phi_1852_;
                        let _e903 = bitcast<f32>(_e836.x);
                        let _e904 = bitcast<f32>((_e844 + ((_e836.w & 31u) << bitcast<u32>(23i))));
                        let _e905 = (_e903 + _e904);
                        if ((bitcast<u32>(_e669) >> bitcast<u32>(31i)) == 0u) {
                            phi_1911_ = SlimbvhTypeJ(_e836.z, _e905);
                            phi_1912_ = SlimbvhTypeJ(_e836.y, _e903);
                        } else {
                            phi_1911_ = SlimbvhTypeJ(_e836.y, _e903);
                            phi_1912_ = SlimbvhTypeJ(_e836.z, _e905);
                        }
                        let _e916 = phi_1911_;
                        let _e918 = phi_1912_;
                        let _e957 = bitcast<f32>(_e841.x);
                        let _e958 = bitcast<f32>((_e844 + ((_e841.w & 31u) << bitcast<u32>(23i))));
                        let _e959 = (_e957 + _e958);
                        if ((bitcast<u32>(_e685) >> bitcast<u32>(31i)) == 0u) {
                            phi_1971_ = SlimbvhTypeJ(_e841.z, _e959);
                            phi_1972_ = SlimbvhTypeJ(_e841.y, _e957);
                        } else {
                            phi_1971_ = SlimbvhTypeJ(_e841.y, _e957);
                            phi_1972_ = SlimbvhTypeJ(_e841.z, _e959);
                        }
                        let _e970 = phi_1971_;
                        let _e972 = phi_1972_;
                        let _e1007 = (_e850 * _e653);
                        let _e1010 = bitcast<f32>((bitcast<u32>(_e1007) & 2147483647u));
                        let _e1014 = (((_e864.member_1 - _e650) * _e653) + (_e1010 * -0.00012207031f));
                        let _e1026 = (((_e862.member_1 - _e651) * _e653) + (_e1010 * 0.00012207031f));
                        let _e1035 = (_e904 * _e669);
                        let _e1038 = bitcast<f32>((bitcast<u32>(_e1035) & 2147483647u));
                        let _e1042 = (((_e918.member_1 - _e666) * _e669) + (_e1038 * -0.00012207031f));
                        let _e1054 = (((_e916.member_1 - _e667) * _e669) + (_e1038 * 0.00012207031f));
                        let _e1063 = (_e958 * _e685);
                        let _e1066 = bitcast<f32>((bitcast<u32>(_e1063) & 2147483647u));
                        let _e1070 = (((_e972.member_1 - _e682) * _e685) + (_e1066 * -0.00012207031f));
                        let _e1075 = ((f32((_e972.member & 255u)) * _e1063) + _e1070);
                        let _e1076 = ((f32(((_e972.member >> bitcast<u32>(8u)) & 255u)) * _e1063) + _e1070);
                        let _e1077 = ((f32(((_e972.member >> bitcast<u32>(16u)) & 255u)) * _e1063) + _e1070);
                        let _e1078 = ((f32(((_e972.member >> bitcast<u32>(24u)) & 255u)) * _e1063) + _e1070);
                        let _e1082 = (((_e970.member_1 - _e683) * _e685) + (_e1066 * 0.00012207031f));
                        let _e1087 = ((f32((_e970.member & 255u)) * _e1063) + _e1082);
                        let _e1088 = ((f32(((_e970.member >> bitcast<u32>(8u)) & 255u)) * _e1063) + _e1082);
                        let _e1089 = ((f32(((_e970.member >> bitcast<u32>(16u)) & 255u)) * _e1063) + _e1082);
                        let _e1090 = ((f32(((_e970.member >> bitcast<u32>(24u)) & 255u)) * _e1063) + _e1082);
                        let _e1123 = max(max(max(((f32((_e864.member & 255u)) * _e1007) + _e1014), ((f32((_e918.member & 255u)) * _e1035) + _e1042)), _e1075), _e693);
                        let _e1124 = max(max(max(((f32(((_e864.member >> bitcast<u32>(8u)) & 255u)) * _e1007) + _e1014), ((f32(((_e918.member >> bitcast<u32>(8u)) & 255u)) * _e1035) + _e1042)), _e1076), _e693);
                        let _e1125 = max(max(max(((f32(((_e864.member >> bitcast<u32>(16u)) & 255u)) * _e1007) + _e1014), ((f32(((_e918.member >> bitcast<u32>(16u)) & 255u)) * _e1035) + _e1042)), _e1077), _e693);
                        let _e1126 = max(max(max(((f32(((_e864.member >> bitcast<u32>(24u)) & 255u)) * _e1007) + _e1014), ((f32(((_e918.member >> bitcast<u32>(24u)) & 255u)) * _e1035) + _e1042)), _e1078), _e693);
                        let _e1131 = (_e809.member.member_1 + (bitcast<f32>((bitcast<u32>(_e809.member.member_1) & 2147483647u)) * 0.0000004768374f));
                        if (_e1123 <= min((min(min(((f32((_e862.member & 255u)) * _e1007) + _e1026), ((f32((_e916.member & 255u)) * _e1035) + _e1054)), _e1087) + (max(_e1087, -(_e1075)) * 0.0000023841915f)), _e1131)) {
                            phi_2462_ = (((bitcast<u32>(_e1123) ^ select(0u, 4294967288u, _e710.member_1)) & 2147483640u) | 4u);
                        } else {
                            phi_2462_ = 4294967288u;
                        }
                        let _e1146 = phi_2462_;
                        if (_e1124 <= min((min(min(((f32(((_e862.member >> bitcast<u32>(8u)) & 255u)) * _e1007) + _e1026), ((f32(((_e916.member >> bitcast<u32>(8u)) & 255u)) * _e1035) + _e1054)), _e1088) + (max(_e1088, -(_e1076)) * 0.0000023841915f)), _e1131)) {
                            phi_2475_ = ((((bitcast<u32>(_e1124) ^ select(0u, 4294967288u, _e710.member_1)) & 2147483640u) | 4u) | 1u);
                        } else {
                            phi_2475_ = 4294967288u;
                        }
                        let _e1154 = phi_2475_;
                        if (_e1125 <= min((min(min(((f32(((_e862.member >> bitcast<u32>(16u)) & 255u)) * _e1007) + _e1026), ((f32(((_e916.member >> bitcast<u32>(16u)) & 255u)) * _e1035) + _e1054)), _e1089) + (max(_e1089, -(_e1077)) * 0.0000023841915f)), _e1131)) {
                            phi_2488_ = ((((bitcast<u32>(_e1125) ^ select(0u, 4294967288u, _e710.member_1)) & 2147483640u) | 4u) | 2u);
                        } else {
                            phi_2488_ = 4294967288u;
                        }
                        let _e1162 = phi_2488_;
                        if (_e1126 <= min((min(min(((f32(((_e862.member >> bitcast<u32>(24u)) & 255u)) * _e1007) + _e1026), ((f32(((_e916.member >> bitcast<u32>(24u)) & 255u)) * _e1035) + _e1054)), _e1090) + (max(_e1090, -(_e1078)) * 0.0000023841915f)), _e1131)) {
                            phi_2501_ = ((((bitcast<u32>(_e1126) ^ select(0u, 4294967288u, _e710.member_1)) & 2147483640u) | 4u) | 3u);
                        } else {
                            phi_2501_ = 4294967288u;
                        }
                        let _e1170 = phi_2501_;
                        if (_e1146 < _e1154) {
                            phi_5247_ = SlimbvhTypeD(_e1146, _e1154);
                        } else {
                            phi_5247_ = SlimbvhTypeD(_e1154, _e1146);
                        }
                        let _e1175 = phi_5247_;
                        if (_e1162 < _e1170) {
                            phi_5259_ = SlimbvhTypeD(_e1162, _e1170);
                        } else {
                            phi_5259_ = SlimbvhTypeD(_e1170, _e1162);
                        }
                        let _e1182 = phi_5259_;
                        if (_e1175.member < _e1182.member) {
                            phi_5271_ = SlimbvhTypeD(_e1175.member, _e1182.member);
                        } else {
                            phi_5271_ = SlimbvhTypeD(_e1182.member, _e1175.member);
                        }
                        let _e1189 = phi_5271_;
                        if (_e1175.member_1 < _e1182.member_1) {
                            phi_5283_ = SlimbvhTypeD(_e1175.member_1, _e1182.member_1);
                        } else {
                            phi_5283_ = SlimbvhTypeD(_e1182.member_1, _e1175.member_1);
                        }
                        let _e1196 = phi_5283_;
                        if (_e1196.member < _e1189.member_1) {
                            phi_5295_ = SlimbvhTypeD(_e1196.member, _e1189.member_1);
                        } else {
                            phi_5295_ = SlimbvhTypeD(_e1189.member_1, _e1196.member);
                        }
                        let _e1203 = phi_5295_;
                        let _e1218 = (((_e1189.member & 7u) | ((_e1203.member & 7u) << bitcast<u32>(3u))) | (((_e1203.member_1 & 7u) | ((_e1196.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                        if (_e1218 == 0u) {
                            let _e1238 = (_e818 - 1u);
                            let _e1243 = slimbvh_stacks[(((_e1238 % 32u) * 64u) + _e700)];
                            let _e1244 = (_e1243 & 511u);
                            let _e1246 = (_e1244 >> bitcast<u32>(3u));
                            let _e1249 = ((_e1246 == 0u) || (_e1238 == 4294967295u));
                            if _e1249 {
                            } else {
                                slimbvh_stacks[(((_e1238 % 32u) * 64u) + _e700)] = (((_e1243 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1246);
                            }
                            phi_2590_ = select(_e818, _e1238, _e1249);
                            phi_2591_ = (((_e1243 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1244 & 3u) & 3u));
                        } else {
                            let _e1221 = (_e1218 >> bitcast<u32>(3u));
                            if (_e1221 == 0u) {
                                phi_2585_ = _e818;
                            } else {
                                slimbvh_stacks[(((_e818 % 32u) * 64u) + _e700)] = ((_e820 << bitcast<u32>(9u)) | _e1221);
                                phi_2585_ = (_e818 + 1u);
                            }
                            let _e1232 = phi_2585_;
                            phi_2590_ = _e1232;
                            phi_2591_ = ((_e820 << bitcast<u32>(2i)) | ((_e1218 & 3u) & 3u));
                        }
                        let _e1264 = phi_2590_;
                        let _e1266 = phi_2591_;
                        let _e1268 = (_e1266 >> bitcast<u32>(2i));
                        if (_e1268 < _e127) {
                            let _e1273 = slimbvh_nodes.member[_e1268][1u][3u];
                            let _e1277 = slimbvh_nodes.member[_e1268][2u][3u];
                            let _e1282 = (_e1277 >> bitcast<u32>(20u));
                            let _e1283 = (_e1266 & 3u);
                            if (((_e1282 >> bitcast<u32>((((3u * _e1283) & 31u) & 31u))) & 7u) == 7u) {
                                let _e1295 = ((_e1282 | (_e1282 << bitcast<u32>(10i))) & 4128831u);
                                phi_2645_ = (((_e1273 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e1295 | (_e1295 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e1283) & 31u) & 31u))) & 255u));
                            } else {
                                phi_2645_ = (2147483648u | _e1266);
                            }
                            let _e1313 = phi_2645_;
                            phi_2646_ = _e1313;
                        } else {
                            phi_2646_ = 4294967295u;
                        }
                        let _e1315 = phi_2646_;
                        let _e1316 = (_e822 - 1u);
                        phi_1745_ = select(_e1264, 4294967295u, (_e1316 == 0u));
                        phi_1748_ = _e1315;
                        phi_1750_ = _e1316;
                    } else {
                        phi_1745_ = u32();
                        phi_1748_ = u32();
                        phi_1750_ = u32();
                    }
                    let _e1320 = phi_1745_;
                    let _e1322 = phi_1748_;
                    let _e1324 = phi_1750_;
                    continue;
                    continuing {
                        phi_1744_ = _e1320;
                        phi_1747_ = _e1322;
                        phi_1749_ = _e1324;
                        break if !(_e826);
                    }
                }
                let _e1327 = local;
                if _e1327 {
                    let _e1329 = local_1;
                    let _e1330 = (_e1329 & 2147483647u);
                    let _e1332 = (_e1330 >> bitcast<u32>(2i));
                    if (_e1332 >= _e127) {
                        phi_2879_ = SlimbvhTypeM(SlimbvhTypeL(vec4<f32>(0f, 0f, 0f, 0f), 0u), 0u, 0u);
                    } else {
                        let _e1338 = slimbvh_nodes.member[_e1332][select(_e715, 2u, (2u < _e715))];
                        let _e1347 = slimbvh_nodes.member[_e1332][select(_e716, 2u, (2u < _e716))];
                        let _e1356 = slimbvh_nodes.member[_e1332][select(_e717, 2u, (2u < _e717))];
                        let _e1364 = slimbvh_nodes.member[_e1332][0u][3u];
                        let _e1368 = slimbvh_nodes.member[_e1332][1u][3u];
                        let _e1372 = slimbvh_nodes.member[_e1332][2u][3u];
                        let _e1385 = (_e1372 >> bitcast<u32>(20u));
                        let _e1393 = (((_e1372 >> bitcast<u32>(7u)) & 8191u) | ((_e1368 >> bitcast<u32>(29u)) << bitcast<u32>(13u)));
                        let _e1396 = ((_e1372 >> bitcast<u32>(5u)) & 3u);
                        let _e1397 = (_e1330 & 3u);
                        let _e1403 = ((_e1385 >> bitcast<u32>((((3u * _e1397) & 31u) & 31u))) & 7u);
                        if (_e1403 == 7u) {
                            let _e1456 = ((_e1385 | (_e1385 << bitcast<u32>(10i))) & 4128831u);
                            phi_2831_ = (((_e1368 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e1456 | (_e1456 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e1397) & 31u) & 31u))) & 255u));
                        } else {
                            let _e1408 = ((_e1385 | (_e1385 << bitcast<u32>(10i))) & 4128831u);
                            let _e1412 = ((_e1408 | (_e1408 << bitcast<u32>(5i))) & 117901063u);
                            let _e1418 = (_e1412 - (7u * (((_e1412 + 16843009u) >> bitcast<u32>(3i)) & 16843009u)));
                            let _e1426 = ((_e1393 | (_e1393 << bitcast<u32>(8i))) & 16711935u);
                            phi_2831_ = ((2147483648u | (_e1403 << bitcast<u32>(28u))) | ((((_e1364 >> bitcast<u32>(5u)) | (((_e1368 >> bitcast<u32>(28u)) & 1u) << bitcast<u32>(27u))) + (((((((((_e1426 | (_e1426 << bitcast<u32>(4i))) & 252645135u) + (3u * (((_e1418 + 117901063u) >> bitcast<u32>(3i)) & 16843009u))) * (_e1396 + 1u)) + _e1418) + ((_e1418 >> bitcast<u32>(1i)) & 50529027u)) * 16843008u) >> bitcast<u32>((((8u * _e1397) & 31u) & 31u))) & 255u)) & 268435455u));
                        }
                        let _e1474 = phi_2831_;
                        switch bitcast<i32>(_e1396) {
                            case 0: {
                                phi_2836_ = 0u;
                                break;
                            }
                            case 1: {
                                phi_2836_ = 1u;
                                break;
                            }
                            default: {
                                phi_2836_ = 2u;
                                break;
                            }
                        }
                        let _e1477 = phi_2836_;
                        let _e1480 = (((8u * _e1397) & 31u) & 31u);
                        phi_2879_ = SlimbvhTypeM(SlimbvhTypeL(vec4<f32>((bitcast<f32>(_e1338.x) + (f32((((_e1338.y >> bitcast<u32>(_e1480)) & 255u) << bitcast<u32>(((_e1338.w & 31u) & 31u)))) * _e178)), (bitcast<f32>(_e1347.x) + (f32((((_e1347.y >> bitcast<u32>(_e1480)) & 255u) << bitcast<u32>(((_e1347.w & 31u) & 31u)))) * _e178)), (bitcast<f32>(_e1356.x) + (f32((((_e1356.y >> bitcast<u32>(_e1480)) & 255u) << bitcast<u32>(((_e1356.w & 31u) & 31u)))) * _e178)), 0f), _e1477), (_e1474 & 268435455u), ((_e1474 >> bitcast<u32>(28u)) & 7u));
                    }
                    let _e1519 = phi_2879_;
                    phi_2883_ = _e809;
                    phi_2886_ = SlimbvhTypeD(0u, _e1519.member_2);
                    loop {
                        let _e1523 = phi_2883_;
                        let _e1525 = phi_2886_;
                        local_4 = _e1523;
                        local_7 = _e1523;
                        if (_e1525.member < _e1525.member_1) {
                            phi_2887_ = SlimbvhTypeD((_e1525.member + 1u), _e1525.member_1);
                            phi_2909_ = SlimbvhTypeD(1u, _e1525.member);
                        } else {
                            phi_2887_ = _e1525;
                            phi_2909_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                        }
                        let _e1538 = phi_2887_;
                        let _e1540 = phi_2909_;
                        let _e1544 = (bitcast<i32>(_e1540.member) != 0i);
                        if _e1544 {
                            let _e1548 = (_e1519.member_1 + (_e1519.member_2 / 2u));
                            let _e1549 = (_e1548 + _e1540.member_1);
                            if (_e1549 < _e130) {
                                let _e1552 = slimbvh_triangles.member[_e1549];
                                phi_2937_ = _e1552;
                            } else {
                                phi_2937_ = 4294967295u;
                            }
                            let _e1554 = phi_2937_;
                            let _e1555 = (_e1540.member_1 - 1u);
                            let _e1558 = (_e1519.member_1 + (_e1555 >> bitcast<u32>(1i)));
                            if (_e1558 < _e130) {
                                let _e1561 = slimbvh_triangles.member[_e1558];
                                phi_2960_ = _e1561;
                            } else {
                                phi_2960_ = 0u;
                            }
                            let _e1563 = phi_2960_;
                            if (_e1540.member_1 == 0u) {
                                phi_2969_ = 2080u;
                            } else {
                                phi_2969_ = (_e1563 >> bitcast<u32>(((16u * (_e1555 & 1u)) & 31u)));
                            }
                            let _e1571 = phi_2969_;
                            let _e1572 = (_e1548 + _e1519.member_2);
                            switch bitcast<i32>(_e1519.member.member_1) {
                                case 0: {
                                    phi_2979_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2979_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2979_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2979_ = u32();
                                    break;
                                }
                            }
                            let _e1576 = phi_2979_;
                            let _e1579 = (_e1572 + ((_e1571 & 31u) * _e1576));
                            let _e1584 = (_e1572 + (((_e1571 >> bitcast<u32>(5u)) & 31u) * _e1576));
                            let _e1589 = (_e1572 + (((_e1571 >> bitcast<u32>(10u)) & 31u) * _e1576));
                            switch bitcast<i32>(_e1519.member.member_1) {
                                case 0: {
                                    if (_e1579 < _e130) {
                                        let _e1866 = slimbvh_triangles.member[_e1579];
                                        phi_3021_ = _e1866;
                                    } else {
                                        phi_3021_ = 0u;
                                    }
                                    let _e1868 = phi_3021_;
                                    let _e1871 = ((10u * _e238) & 31u);
                                    let _e1882 = ((10u * _e242) & 31u);
                                    let _e1893 = ((10u * _e234) & 31u);
                                    if (_e1584 < _e130) {
                                        let _e1905 = slimbvh_triangles.member[_e1584];
                                        phi_3067_ = _e1905;
                                    } else {
                                        phi_3067_ = 0u;
                                    }
                                    let _e1907 = phi_3067_;
                                    if (_e1589 < _e130) {
                                        let _e1935 = slimbvh_triangles.member[_e1589];
                                        phi_3113_ = _e1935;
                                    } else {
                                        phi_3113_ = 0u;
                                    }
                                    let _e1937 = phi_3113_;
                                    phi_3580_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1519.member.member.x + ((bitcast<f32>((1258291200u | ((_e1868 >> bitcast<u32>(_e1871)) & 1023u))) - 8388608f) * _e178)), (_e1519.member.member.y + ((bitcast<f32>((1258291200u | ((_e1868 >> bitcast<u32>(_e1882)) & 1023u))) - 8388608f) * _e178)), (_e1519.member.member.z + ((bitcast<f32>((1258291200u | ((_e1868 >> bitcast<u32>(_e1893)) & 1023u))) - 8388608f) * _e178))), array<f32, 3>((_e1519.member.member.x + ((bitcast<f32>((1258291200u | ((_e1907 >> bitcast<u32>(_e1871)) & 1023u))) - 8388608f) * _e178)), (_e1519.member.member.y + ((bitcast<f32>((1258291200u | ((_e1907 >> bitcast<u32>(_e1882)) & 1023u))) - 8388608f) * _e178)), (_e1519.member.member.z + ((bitcast<f32>((1258291200u | ((_e1907 >> bitcast<u32>(_e1893)) & 1023u))) - 8388608f) * _e178))), array<f32, 3>((_e1519.member.member.x + ((bitcast<f32>((1258291200u | ((_e1937 >> bitcast<u32>(_e1871)) & 1023u))) - 8388608f) * _e178)), (_e1519.member.member.y + ((bitcast<f32>((1258291200u | ((_e1937 >> bitcast<u32>(_e1882)) & 1023u))) - 8388608f) * _e178)), (_e1519.member.member.z + ((bitcast<f32>((1258291200u | ((_e1937 >> bitcast<u32>(_e1893)) & 1023u))) - 8388608f) * _e178))));
                                    break;
                                }
                                case 1: {
                                    if (_e1579 < _e130) {
                                        let _e1679 = slimbvh_triangles.member[_e1579];
                                        phi_3160_ = _e1679;
                                    } else {
                                        phi_3160_ = 0u;
                                    }
                                    let _e1681 = phi_3160_;
                                    let _e1682 = (_e1579 + 1u);
                                    if (_e1682 < _e130) {
                                        let _e1685 = slimbvh_triangles.member[_e1682];
                                        phi_3173_ = _e1685;
                                    } else {
                                        phi_3173_ = 0u;
                                    }
                                    let _e1687 = phi_3173_;
                                    let _e1689 = (_e238 == 1u);
                                    if _e1689 {
                                        phi_3183_ = ((_e1681 >> bitcast<u32>(21i)) | (_e1687 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3183_ = (_e1687 >> bitcast<u32>(10i));
                                    }
                                    let _e1698 = phi_3183_;
                                    let _e1707 = (_e242 == 1u);
                                    if _e1707 {
                                        phi_3204_ = ((_e1681 >> bitcast<u32>(21i)) | (_e1687 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3204_ = (_e1687 >> bitcast<u32>(10i));
                                    }
                                    let _e1716 = phi_3204_;
                                    let _e1725 = (_e234 == 1u);
                                    if _e1725 {
                                        phi_3225_ = ((_e1681 >> bitcast<u32>(21i)) | (_e1687 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3225_ = (_e1687 >> bitcast<u32>(10i));
                                    }
                                    let _e1734 = phi_3225_;
                                    if (_e1584 < _e130) {
                                        let _e1745 = slimbvh_triangles.member[_e1584];
                                        phi_3252_ = _e1745;
                                    } else {
                                        phi_3252_ = 0u;
                                    }
                                    let _e1747 = phi_3252_;
                                    let _e1748 = (_e1584 + 1u);
                                    if (_e1748 < _e130) {
                                        let _e1751 = slimbvh_triangles.member[_e1748];
                                        phi_3265_ = _e1751;
                                    } else {
                                        phi_3265_ = 0u;
                                    }
                                    let _e1753 = phi_3265_;
                                    if _e1689 {
                                        phi_3275_ = ((_e1747 >> bitcast<u32>(21i)) | (_e1753 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3275_ = (_e1753 >> bitcast<u32>(10i));
                                    }
                                    let _e1762 = phi_3275_;
                                    if _e1707 {
                                        phi_3296_ = ((_e1747 >> bitcast<u32>(21i)) | (_e1753 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3296_ = (_e1753 >> bitcast<u32>(10i));
                                    }
                                    let _e1778 = phi_3296_;
                                    if _e1725 {
                                        phi_3317_ = ((_e1747 >> bitcast<u32>(21i)) | (_e1753 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3317_ = (_e1753 >> bitcast<u32>(10i));
                                    }
                                    let _e1794 = phi_3317_;
                                    if (_e1589 < _e130) {
                                        let _e1805 = slimbvh_triangles.member[_e1589];
                                        phi_3344_ = _e1805;
                                    } else {
                                        phi_3344_ = 0u;
                                    }
                                    let _e1807 = phi_3344_;
                                    let _e1808 = (_e1589 + 1u);
                                    if (_e1808 < _e130) {
                                        let _e1811 = slimbvh_triangles.member[_e1808];
                                        phi_3357_ = _e1811;
                                    } else {
                                        phi_3357_ = 0u;
                                    }
                                    let _e1813 = phi_3357_;
                                    if _e1689 {
                                        phi_3367_ = ((_e1807 >> bitcast<u32>(21i)) | (_e1813 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3367_ = (_e1813 >> bitcast<u32>(10i));
                                    }
                                    let _e1822 = phi_3367_;
                                    if _e1707 {
                                        phi_3388_ = ((_e1807 >> bitcast<u32>(21i)) | (_e1813 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3388_ = (_e1813 >> bitcast<u32>(10i));
                                    }
                                    let _e1838 = phi_3388_;
                                    if _e1725 {
                                        phi_3409_ = ((_e1807 >> bitcast<u32>(21i)) | (_e1813 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3409_ = (_e1813 >> bitcast<u32>(10i));
                                    }
                                    let _e1854 = phi_3409_;
                                    phi_3580_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1519.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1698, _e1681, _e243) & 2097151u))) - 8388608f) * _e178)), (_e1519.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1716, _e1681, _e246) & 2097151u))) - 8388608f) * _e178)), (_e1519.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1734, _e1681, _e250) & 2097151u))) - 8388608f) * _e178))), array<f32, 3>((_e1519.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1762, _e1747, _e243) & 2097151u))) - 8388608f) * _e178)), (_e1519.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1778, _e1747, _e246) & 2097151u))) - 8388608f) * _e178)), (_e1519.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1794, _e1747, _e250) & 2097151u))) - 8388608f) * _e178))), array<f32, 3>((_e1519.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1822, _e1807, _e243) & 2097151u))) - 8388608f) * _e178)), (_e1519.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1838, _e1807, _e246) & 2097151u))) - 8388608f) * _e178)), (_e1519.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1854, _e1807, _e250) & 2097151u))) - 8388608f) * _e178))));
                                    break;
                                }
                                case 2: {
                                    let _e1592 = (_e1579 + _e238);
                                    if (_e1592 < _e130) {
                                        let _e1595 = slimbvh_triangles.member[_e1592];
                                        phi_3438_ = _e1595;
                                    } else {
                                        phi_3438_ = 0u;
                                    }
                                    let _e1597 = phi_3438_;
                                    let _e1598 = (_e1579 + _e242);
                                    if (_e1598 < _e130) {
                                        let _e1601 = slimbvh_triangles.member[_e1598];
                                        phi_3451_ = _e1601;
                                    } else {
                                        phi_3451_ = 0u;
                                    }
                                    let _e1603 = phi_3451_;
                                    let _e1604 = (_e1579 + _e234);
                                    if (_e1604 < _e130) {
                                        let _e1607 = slimbvh_triangles.member[_e1604];
                                        phi_3464_ = _e1607;
                                    } else {
                                        phi_3464_ = 0u;
                                    }
                                    let _e1609 = phi_3464_;
                                    let _e1620 = (_e1584 + _e238);
                                    if (_e1620 < _e130) {
                                        let _e1623 = slimbvh_triangles.member[_e1620];
                                        phi_3490_ = _e1623;
                                    } else {
                                        phi_3490_ = 0u;
                                    }
                                    let _e1625 = phi_3490_;
                                    let _e1626 = (_e1584 + _e242);
                                    if (_e1626 < _e130) {
                                        let _e1629 = slimbvh_triangles.member[_e1626];
                                        phi_3503_ = _e1629;
                                    } else {
                                        phi_3503_ = 0u;
                                    }
                                    let _e1631 = phi_3503_;
                                    let _e1632 = (_e1584 + _e234);
                                    if (_e1632 < _e130) {
                                        let _e1635 = slimbvh_triangles.member[_e1632];
                                        phi_3516_ = _e1635;
                                    } else {
                                        phi_3516_ = 0u;
                                    }
                                    let _e1637 = phi_3516_;
                                    let _e1648 = (_e1589 + _e238);
                                    if (_e1648 < _e130) {
                                        let _e1651 = slimbvh_triangles.member[_e1648];
                                        phi_3542_ = _e1651;
                                    } else {
                                        phi_3542_ = 0u;
                                    }
                                    let _e1653 = phi_3542_;
                                    let _e1654 = (_e1589 + _e242);
                                    if (_e1654 < _e130) {
                                        let _e1657 = slimbvh_triangles.member[_e1654];
                                        phi_3555_ = _e1657;
                                    } else {
                                        phi_3555_ = 0u;
                                    }
                                    let _e1659 = phi_3555_;
                                    let _e1660 = (_e1589 + _e234);
                                    if (_e1660 < _e130) {
                                        let _e1663 = slimbvh_triangles.member[_e1660];
                                        phi_3568_ = _e1663;
                                    } else {
                                        phi_3568_ = 0u;
                                    }
                                    let _e1665 = phi_3568_;
                                    phi_3580_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1597)) * _e178), (f32(bitcast<i32>(_e1603)) * _e178), (f32(bitcast<i32>(_e1609)) * _e178)), array<f32, 3>((f32(bitcast<i32>(_e1625)) * _e178), (f32(bitcast<i32>(_e1631)) * _e178), (f32(bitcast<i32>(_e1637)) * _e178)), array<f32, 3>((f32(bitcast<i32>(_e1653)) * _e178), (f32(bitcast<i32>(_e1659)) * _e178), (f32(bitcast<i32>(_e1665)) * _e178)));
                                    break;
                                }
                                default: {
                                    phi_3580_ = array<array<f32, 3>, 3>();
                                    break;
                                }
                            }
                            let _e1965 = phi_3580_;
                            let _e1982 = (_e1965[0][2] - _e626.member[2]);
                            let _e1985 = (((_e1965[0][0] - _e626.member[0]) * _e681) - (_e1982 * _e649));
                            let _e1988 = (((_e1965[0][1] - _e626.member[1]) * _e681) - (_e1982 * _e665));
                            let _e1991 = (_e1965[1][2] - _e626.member[2]);
                            let _e1994 = (((_e1965[1][0] - _e626.member[0]) * _e681) - (_e1991 * _e649));
                            let _e1997 = (((_e1965[1][1] - _e626.member[1]) * _e681) - (_e1991 * _e665));
                            let _e2000 = (_e1965[2][2] - _e626.member[2]);
                            let _e2003 = (((_e1965[2][0] - _e626.member[0]) * _e681) - (_e2000 * _e649));
                            let _e2006 = (((_e1965[2][1] - _e626.member[1]) * _e681) - (_e2000 * _e665));
                            let _e2007 = (_e2003 * _e1997);
                            let _e2008 = (_e2006 * _e1994);
                            let _e2009 = (_e1985 * _e2006);
                            let _e2010 = (_e1988 * _e2003);
                            let _e2011 = (_e1994 * _e1988);
                            let _e2012 = (_e1997 * _e1985);
                            let _e2017 = (((_e2007 >= _e2008) && (_e2009 >= _e2010)) && (_e2011 >= _e2012));
                            let _e2023 = (_e2017 || (((_e2007 <= _e2008) && (_e2009 <= _e2010)) && (_e2011 <= _e2012)));
                            if _e2023 {
                                let _e2025 = select(-1f, 1f, _e2017);
                                let _e2027 = ((_e2007 - _e2008) * _e2025);
                                let _e2029 = select(0f, _e2027, (_e2027 > 0f));
                                let _e2031 = ((_e2009 - _e2010) * _e2025);
                                let _e2033 = select(0f, _e2031, (_e2031 > 0f));
                                let _e2035 = ((_e2011 - _e2012) * _e2025);
                                let _e2037 = select(0f, _e2035, (_e2035 > 0f));
                                let _e2039 = ((_e2029 + _e2033) + _e2037);
                                let _e2054 = ((min(min(_e1965[0][0], _e1965[1][0]), _e1965[2][0]) - _e650) * _e653);
                                let _e2055 = ((max(max(_e1965[0][0], _e1965[1][0]), _e1965[2][0]) - _e651) * _e653);
                                let _e2056 = vec4<f32>(_e2054, f32(), _e2055, f32());
                                let _e2059 = ((min(min(_e1965[0][1], _e1965[1][1]), _e1965[2][1]) - _e666) * _e669);
                                let _e2060 = ((max(max(_e1965[0][1], _e1965[1][1]), _e1965[2][1]) - _e667) * _e669);
                                let _e2061 = vec4<f32>(_e2059, f32(), _e2060, f32());
                                let _e2064 = ((min(min(_e1965[0][2], _e1965[1][2]), _e1965[2][2]) - _e682) * _e685);
                                let _e2065 = ((max(max(_e1965[0][2], _e1965[1][2]), _e1965[2][2]) - _e683) * _e685);
                                let _e2066 = vec4<f32>(_e2064, f32(), _e2065, f32());
                                let _e2067 = vec4<f32>(_e2055, f32(), _e2054, f32());
                                let _e2069 = vec4<f32>(_e2060, f32(), _e2059, f32());
                                let _e2071 = vec4<f32>(_e2065, f32(), _e2064, f32());
                                let _e2080 = max(max(min(_e2056, _e2067).x, min(_e2061, _e2069).x), min(_e2066, _e2071).x);
                                let _e2085 = min(min(max(_e2056, _e2067).x, max(_e2061, _e2069).x), max(_e2066, _e2071).x);
                                let _e2090 = max(_e2080, _e693);
                                let _e2112 = (((((_e2023 && (_e2039 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1985, _e1994), _e2003) <= 0f) && (max(max(_e1985, _e1994), _e2003) >= 0f))) && ((min(min(_e1988, _e1997), _e2006) <= 0f) && (max(max(_e1988, _e1997), _e2006) >= 0f))) && (_e2090 <= (_e2085 + (max(max(_e2066, _e2071).x, -(min(_e2066, _e2071).x)) * 0.0000019073523f)))) && (_e2090 <= _e1523.member.member_1));
                                if _e2112 {
                                    let _e2117 = (_e1965[1][0] - _e1965[0][0]);
                                    let _e2118 = (_e1965[1][1] - _e1965[0][1]);
                                    let _e2119 = (_e1965[1][2] - _e1965[0][2]);
                                    let _e2120 = vec3<f32>(_e2117, _e2118, _e2119);
                                    let _e2121 = (_e1965[2][0] - _e1965[1][0]);
                                    let _e2122 = (_e1965[2][1] - _e1965[1][1]);
                                    let _e2123 = (_e1965[2][2] - _e1965[1][2]);
                                    let _e2124 = vec3<f32>(_e2121, _e2122, _e2123);
                                    let _e2125 = (_e1965[0][0] - _e1965[2][0]);
                                    let _e2126 = (_e1965[0][1] - _e1965[2][1]);
                                    let _e2127 = (_e1965[0][2] - _e1965[2][2]);
                                    let _e2128 = vec3<f32>(_e2125, _e2126, _e2127);
                                    let _e2139 = max(max(bitcast<f32>((bitcast<u32>(_e2117) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2118) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2119) & 2147483647u)));
                                    let _e2150 = max(max(bitcast<f32>((bitcast<u32>(_e2121) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2122) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2123) & 2147483647u)));
                                    let _e2163 = max(max(_e2139, _e2150), max(max(bitcast<f32>((bitcast<u32>(_e2125) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2126) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2127) & 2147483647u))));
                                    if (_e2139 == _e2163) {
                                        phi_3945_ = _e1997;
                                        phi_3946_ = _e1994;
                                        phi_3947_ = _e1988;
                                        phi_3948_ = _e1985;
                                        phi_3949_ = vec3<f32>(_e1965[0][0], _e1965[0][1], _e1965[0][2]);
                                        phi_3950_ = _e2128;
                                        phi_3951_ = _e2124;
                                        phi_3952_ = _e2120;
                                    } else {
                                        let _e2165 = (_e2150 == _e2163);
                                        let _e2170 = vec3(_e2165);
                                        phi_3945_ = select(_e1988, _e2006, _e2165);
                                        phi_3946_ = select(_e1985, _e2003, _e2165);
                                        phi_3947_ = select(_e2006, _e1997, _e2165);
                                        phi_3948_ = select(_e2003, _e1994, _e2165);
                                        phi_3949_ = select(vec3<f32>(_e1965[2][0], _e1965[2][1], _e1965[2][2]), vec3<f32>(_e1965[1][0], _e1965[1][1], _e1965[1][2]), _e2170);
                                        phi_3950_ = select(_e2124, _e2120, _e2170);
                                        phi_3951_ = select(_e2120, _e2128, _e2170);
                                        phi_3952_ = select(_e2128, _e2124, _e2170);
                                    }
                                    let _e2176 = phi_3945_;
                                    let _e2178 = phi_3946_;
                                    let _e2180 = phi_3947_;
                                    let _e2182 = phi_3948_;
                                    let _e2184 = phi_3949_;
                                    let _e2186 = phi_3950_;
                                    let _e2188 = phi_3951_;
                                    let _e2190 = phi_3952_;
                                    let _e2197 = ((_e2188.y * _e2186.z) - (_e2186.y * _e2188.z));
                                    let _e2202 = ((_e2188.z * _e2186.x) - (_e2186.z * _e2188.x));
                                    let _e2205 = ((_e2188.x * _e2186.y) - (_e2186.x * _e2188.y));
                                    let _e2208 = ((_e2029 >= _e2033) && (_e2029 >= _e2037));
                                    let _e2209 = (_e2033 >= _e2037);
                                    let _e2223 = (((_e2197 * (select(select(_e1965[2][0], _e1965[1][0], _e2209), _e1965[0][0], _e2208) - _e626.member[0])) + (_e2202 * (select(select(_e1965[2][1], _e1965[1][1], _e2209), _e1965[0][1], _e2208) - _e626.member[1]))) + (_e2205 * (select(select(_e1965[2][2], _e1965[1][2], _e2209), _e1965[0][2], _e2208) - _e626.member[2])));
                                    let _e2228 = (((_e2197 * _e649) + (_e2202 * _e665)) + (_e2205 * _e681));
                                    let _e2229 = (_e2178 - _e2182);
                                    let _e2230 = (_e2176 - _e2180);
                                    let _e2233 = ((_e2229 * _e2229) + (_e2230 * _e2230));
                                    let _e2240 = (-(((_e2182 * _e2229) + (_e2180 * _e2230))) / select(0.000000000000000000000000000000000000011754944f, _e2233, (_e2233 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e2242 = select(1f, _e2240, (_e2240 < 1f));
                                    let _e2244 = select(0f, _e2242, (_e2242 > 0f));
                                    let _e2253 = ((_e2184.x + (_e2190.x * _e2244)) - _e626.member[0]);
                                    let _e2256 = ((_e2184.y + (_e2190.y * _e2244)) - _e626.member[1]);
                                    let _e2259 = ((_e2184.z + (_e2190.z * _e2244)) - _e626.member[2]);
                                    let _e2324 = ((bitcast<f32>((bitcast<u32>(((((_e2197 * _e2253) + (_e2202 * _e2256)) + (_e2205 * _e2259)) - _e2223)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e2253) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2256) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2259) & 2147483647u))), _e2163)) * max(max(bitcast<f32>((bitcast<u32>(_e2197) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2202) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2205) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e2228) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e2188.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2188.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2188.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e2186.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2186.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2186.z) & 2147483647u)))))));
                                    let _e2325 = (_e2223 / _e2228);
                                    if (_e2112 && !(_e2324)) {
                                        let _e2328 = (_e2259 / _e681);
                                        let _e2336 = (((_e2197 * (_e2253 - (_e649 * _e2328))) + (_e2202 * (_e2256 - (_e665 * _e2328)))) / _e2228);
                                        phi_4131_ = select(select(_e2328, (_e2328 + _e2336), (bitcast<f32>((bitcast<u32>(_e2336) & 2147483647u)) <= _e2163)), _e2325, _e2324);
                                    } else {
                                        phi_4131_ = _e2325;
                                    }
                                    let _e2345 = phi_4131_;
                                    let _e2347 = select(_e2085, _e2345, (_e2345 < _e2085));
                                    let _e2349 = select(_e2080, _e2347, (_e2347 > _e2080));
                                    let _e2352 = select(_e2349, 0f, (bitcast<u32>(_e2349) == 2147483648u));
                                    let _e2353 = (1f / _e2039);
                                    phi_4157_ = SlimbvhTypeE(_e2352, (_e2033 * _e2353), (_e2037 * _e2353), ((_e2112 && (_e2352 >= _e693)) && (_e2352 <= _e1523.member.member_1)));
                                    phi_4158_ = SlimbvhTypeE();
                                } else {
                                    phi_4157_ = SlimbvhTypeE();
                                    phi_4158_ = SlimbvhTypeE(0f, 0f, 0f, _e2112);
                                }
                                let _e2362 = phi_4157_;
                                let _e2364 = phi_4158_;
                                phi_4161_ = _e2362;
                                phi_4162_ = _e2364;
                                phi_4163_ = select(true, false, _e2112);
                            } else {
                                phi_4161_ = SlimbvhTypeE();
                                phi_4162_ = SlimbvhTypeE(0f, 0f, 0f, _e2023);
                                phi_4163_ = true;
                            }
                            let _e2367 = phi_4161_;
                            let _e2369 = phi_4162_;
                            let _e2371 = phi_4163_;
                            if _e2371 {
                                phi_4167_ = _e2369;
                            } else {
                                phi_4167_ = _e2367;
                            }
                            let _e2373 = phi_4167_;
                            if _e2373.member_3 {
                                phi_4176_ = SlimbvhTypeF(_e2373.member, _e2373.member_1, _e2373.member_2, _e1554);
                            } else {
                                phi_4176_ = _e123;
                            }
                            let _e2380 = phi_4176_;
                            if (_e2380.member_3 != 4294967295u) {
                                let _e2386 = slimbvh_target.member[0u][0u];
                                let _e2390 = slimbvh_target.member[0u][1u];
                                let _e2394 = slimbvh_target.member[0u][2u];
                                let _e2398 = slimbvh_target.member[0u][3u];
                                let _e2402 = slimbvh_target.member[1u][0u];
                                let _e2406 = slimbvh_target.member[1u][1u];
                                let _e2410 = slimbvh_target.member[1u][2u];
                                let _e2414 = slimbvh_target.member[1u][3u];
                                let _e2415 = bitcast<f32>(_e2386);
                                let _e2416 = bitcast<f32>(_e2390);
                                let _e2417 = bitcast<f32>(_e2394);
                                let _e2419 = bitcast<f32>(_e2402);
                                let _e2420 = array<u32, 3>(_e2406, _e2410, _e2414);
                                if (_e196 < -126i) {
                                    phi_4229_ = -126i;
                                } else {
                                    phi_4229_ = select(_e196, 127i, (_e196 > 127i));
                                }
                                let _e2426 = phi_4229_;
                                let _e2431 = bitcast<f32>((bitcast<u32>((_e2426 + 127i)) << bitcast<u32>(23i)));
                                let _e2437 = bitcast<f32>((bitcast<u32>(((_e196 - _e2426) + 127i)) << bitcast<u32>(23i)));
                                if (_e2398 == 0u) {
                                    phi_4369_ = SlimbvhTypeH(array<f32, 3>(_e2415, _e2416, _e2417), _e2398, _e2419, _e2420);
                                } else {
                                    let _e2439 = bitcast<u32>(_e2415);
                                    let _e2441 = ((_e2439 & 2139095040u) != 0u);
                                    let _e2456 = bitcast<u32>(_e2416);
                                    let _e2458 = ((_e2456 & 2139095040u) != 0u);
                                    let _e2473 = bitcast<u32>(_e2417);
                                    let _e2475 = ((_e2473 & 2139095040u) != 0u);
                                    let _e2491 = bitcast<u32>(_e2419);
                                    let _e2493 = ((_e2491 & 2139095040u) != 0u);
                                    phi_4369_ = SlimbvhTypeH(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2439 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2439 & 2147483648u))), _e2415, _e2441) * _e2431) * select(0.00000011920929f, 1f, _e2441)) * _e2437), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2456 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2456 & 2147483648u))), _e2416, _e2458) * _e2431) * select(0.00000011920929f, 1f, _e2458)) * _e2437), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2473 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2473 & 2147483648u))), _e2417, _e2475) * _e2431) * select(0.00000011920929f, 1f, _e2475)) * _e2437)), _e2398, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2491 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2491 & 2147483648u))), _e2419, _e2493) * _e2431) * select(0.00000011920929f, 1f, _e2493)) * _e2437), _e2420);
                                }
                                let _e2510 = phi_4369_;
                                if (_e1554 == _e697) {
                                    phi_4698_ = false;
                                } else {
                                    let _e2512 = (_e1554 / 16u);
                                    if (_e2512 < arrayLength((&slimbvh_sides.member))) {
                                        let _e2515 = slimbvh_sides.member[_e2512];
                                        phi_4393_ = _e2515;
                                    } else {
                                        phi_4393_ = 0u;
                                    }
                                    let _e2517 = phi_4393_;
                                    let _e2526 = (bitcast<i32>((_e2517 << bitcast<u32>(((30u - ((_e1554 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                    let _e2527 = (_e2526 == 0i);
                                    if _e2527 {
                                        phi_4697_ = true;
                                    } else {
                                        if _e243 {
                                            phi_4423_ = vec3<f32>(_e1965[0][0], _e1965[0][1], _e1965[0][2]);
                                        } else {
                                            if (_e238 == 1u) {
                                                phi_4422_ = vec3<f32>(_e1965[0][2], _e1965[0][0], _e1965[0][1]);
                                            } else {
                                                phi_4422_ = vec3<f32>(_e1965[0][1], _e1965[0][2], _e1965[0][0]);
                                            }
                                            let _e2532 = phi_4422_;
                                            phi_4423_ = _e2532;
                                        }
                                        let _e2535 = phi_4423_;
                                        if _e243 {
                                            phi_4442_ = vec3<f32>(_e1965[1][0], _e1965[1][1], _e1965[1][2]);
                                        } else {
                                            if (_e238 == 1u) {
                                                phi_4441_ = vec3<f32>(_e1965[1][2], _e1965[1][0], _e1965[1][1]);
                                            } else {
                                                phi_4441_ = vec3<f32>(_e1965[1][1], _e1965[1][2], _e1965[1][0]);
                                            }
                                            let _e2540 = phi_4441_;
                                            phi_4442_ = _e2540;
                                        }
                                        let _e2543 = phi_4442_;
                                        if _e243 {
                                            phi_4461_ = vec3<f32>(_e1965[2][0], _e1965[2][1], _e1965[2][2]);
                                        } else {
                                            if (_e238 == 1u) {
                                                phi_4460_ = vec3<f32>(_e1965[2][2], _e1965[2][0], _e1965[2][1]);
                                            } else {
                                                phi_4460_ = vec3<f32>(_e1965[2][1], _e1965[2][2], _e1965[2][0]);
                                            }
                                            let _e2548 = phi_4460_;
                                            phi_4461_ = _e2548;
                                        }
                                        let _e2551 = phi_4461_;
                                        let _e2554 = (_e2543.x - _e2535.x);
                                        let _e2557 = (_e2543.y - _e2535.y);
                                        let _e2560 = (_e2543.z - _e2535.z);
                                        let _e2562 = (_e2551.x - _e2535.x);
                                        let _e2564 = (_e2551.y - _e2535.y);
                                        let _e2566 = (_e2551.z - _e2535.z);
                                        if (_e2510.member_1 == 1u) {
                                            phi_4497_ = (vec3<f32>(_e2510.member[0], _e2510.member[1], _e2510.member[2]) - _e2535);
                                        } else {
                                            phi_4497_ = vec3<f32>(_e2510.member[0], _e2510.member[1], _e2510.member[2]);
                                        }
                                        let _e2581 = phi_4497_;
                                        let _e2587 = bitcast<f32>((bitcast<u32>((_e2554 * _e2564)) ^ _e2510.member_3[0]));
                                        let _e2591 = bitcast<f32>((bitcast<u32>((_e2557 * _e2562)) ^ _e2510.member_3[0]));
                                        let _e2595 = bitcast<f32>((bitcast<u32>((_e2557 * _e2566)) ^ _e2510.member_3[0]));
                                        let _e2599 = bitcast<f32>((bitcast<u32>((_e2560 * _e2564)) ^ _e2510.member_3[0]));
                                        let _e2603 = bitcast<f32>((bitcast<u32>((_e2560 * _e2562)) ^ _e2510.member_3[0]));
                                        let _e2607 = bitcast<f32>((bitcast<u32>((_e2554 * _e2566)) ^ _e2510.member_3[0]));
                                        let _e2608 = (_e2595 - _e2599);
                                        let _e2609 = (_e2603 - _e2607);
                                        let _e2610 = (_e2587 - _e2591);
                                        let _e2634 = (bitcast<f32>((bitcast<u32>(_e2595) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2599) & 2147483647u)));
                                        let _e2641 = (bitcast<f32>((bitcast<u32>(_e2603) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2607) & 2147483647u)));
                                        let _e2648 = (bitcast<f32>((bitcast<u32>(_e2587) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2591) & 2147483647u)));
                                        if (_e2510.member_2 == 0f) {
                                            phi_4679_ = 0f;
                                        } else {
                                            let _e2678 = bitcast<f32>((bitcast<u32>(_e2608) & 2147483647u));
                                            let _e2681 = bitcast<f32>((bitcast<u32>(_e2609) & 2147483647u));
                                            let _e2684 = bitcast<f32>((bitcast<u32>(_e2610) & 2147483647u));
                                            let _e2686 = select(_e2684, _e2681, (_e2681 > _e2684));
                                            let _e2690 = select(_e2684, _e2681, (_e2681 < _e2684));
                                            let _e2694 = select(_e2681, _e2678, (_e2678 < _e2681));
                                            let _e2696 = select(_e2681, _e2678, (_e2678 > _e2681));
                                            let _e2698 = select(_e2684, _e2696, (_e2696 < _e2684));
                                            phi_4679_ = bitcast<f32>((bitcast<u32>((_e2510.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2686, _e2678, (_e2678 > _e2686)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2698, _e2694, (_e2694 > _e2698)))) ^ _e2510.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2690, _e2678, (_e2678 < _e2690)))) ^ _e2510.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2634 + _e2641) + _e2648))) ^ _e2510.member_3[0]))) * 1.0000005f)) ^ _e2510.member_3[0])))) ^ _e2510.member_3[0]));
                                        }
                                        let _e2725 = phi_4679_;
                                        phi_4697_ = (_e2527 || !(((((bitcast<f32>((bitcast<u32>((_e2581.x * _e2608)) ^ _e2510.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2581.y * _e2609)) ^ _e2510.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2581.z * _e2610)) ^ _e2510.member_3[0]))) * f32(-(_e2526))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2581.x) & 2147483647u)) * _e2634)) ^ _e2510.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2581.y) & 2147483647u)) * _e2641)) ^ _e2510.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2581.z) & 2147483647u)) * _e2648)) ^ _e2510.member_3[0]))))) ^ _e2510.member_3[0])) + _e2725) + 0.0000000000000000000000000000000000001880791f))));
                                    }
                                    let _e2739 = phi_4697_;
                                    phi_4698_ = _e2739;
                                }
                                let _e2741 = phi_4698_;
                                if _e2741 {
                                    if (_e2380.member < _e1523.member.member.member) {
                                        phi_4718_ = true;
                                    } else {
                                        if (_e2380.member == _e1523.member.member.member) {
                                            phi_4717_ = (_e2380.member_3 < _e1523.member.member.member_3);
                                        } else {
                                            phi_4717_ = false;
                                        }
                                        let _e2753 = phi_4717_;
                                        phi_4718_ = _e2753;
                                    }
                                    let _e2755 = phi_4718_;
                                    if _e2755 {
                                        phi_4725_ = SlimbvhTypeP(SlimbvhTypeI(_e2380, _e2380.member), _e1523.member_1);
                                    } else {
                                        phi_4725_ = _e1523;
                                    }
                                    let _e2761 = phi_4725_;
                                    if _e2761.member_1 {
                                        phi_4731_ = SlimbvhTypeP(SlimbvhTypeI(_e2761.member.member, bitcast<f32>(4286578687u)), _e2761.member_1);
                                    } else {
                                        phi_4731_ = _e2761;
                                    }
                                    let _e2770 = phi_4731_;
                                    phi_4732_ = _e2770;
                                } else {
                                    phi_4732_ = _e1523;
                                }
                                let _e2772 = phi_4732_;
                                phi_4733_ = _e2772;
                            } else {
                                phi_4733_ = _e1523;
                            }
                            let _e2774 = phi_4733_;
                            phi_2884_ = _e2774;
                        } else {
                            phi_2884_ = SlimbvhTypeP();
                        }
                        let _e2776 = phi_2884_;
                        continue;
                        continuing {
                            phi_2883_ = _e2776;
                            phi_2886_ = _e1538;
                            break if !(_e1544);
                        }
                    }
                    let _e2779 = local_2;
                    let _e2780 = (_e2779 - 1u);
                    let _e2785 = slimbvh_stacks[(((_e2780 % 32u) * 64u) + _e700)];
                    let _e2786 = (_e2785 & 511u);
                    let _e2788 = (_e2786 >> bitcast<u32>(3u));
                    let _e2791 = ((_e2788 == 0u) || (_e2780 == 4294967295u));
                    if _e2791 {
                    } else {
                        slimbvh_stacks[(((_e2780 % 32u) * 64u) + _e700)] = (((_e2785 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2788);
                    }
                    let _e2798 = local_3;
                    let _e2806 = (((_e2785 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2786 & 3u) & 3u));
                    let _e2808 = (_e2806 >> bitcast<u32>(2i));
                    if (_e2808 < _e127) {
                        let _e2813 = slimbvh_nodes.member[_e2808][1u][3u];
                        let _e2817 = slimbvh_nodes.member[_e2808][2u][3u];
                        let _e2822 = (_e2817 >> bitcast<u32>(20u));
                        let _e2823 = (_e2806 & 3u);
                        if (((_e2822 >> bitcast<u32>((((3u * _e2823) & 31u) & 31u))) & 7u) == 7u) {
                            let _e2835 = ((_e2822 | (_e2822 << bitcast<u32>(10i))) & 4128831u);
                            phi_4824_ = (((_e2813 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e2835 | (_e2835 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e2823) & 31u) & 31u))) & 255u));
                        } else {
                            phi_4824_ = (2147483648u | _e2806);
                        }
                        let _e2853 = phi_4824_;
                        phi_4825_ = _e2853;
                    } else {
                        phi_4825_ = 4294967295u;
                    }
                    let _e2855 = phi_4825_;
                    let _e2857 = local_4;
                    let _e3168 = local_7;
                    phi_4834_ = _e3168;
                    phi_4835_ = select(select(_e2798, _e2780, _e2791), 4294967295u, (_e693 > _e2857.member.member_1));
                    phi_4836_ = _e2855;
                } else {
                    phi_4834_ = _e809;
                    let _e3171 = local_8;
                    phi_4835_ = _e3171;
                    let _e3174 = local_9;
                    phi_4836_ = _e3174;
                }
                let _e2863 = phi_4834_;
                let _e2865 = phi_4835_;
                let _e2867 = phi_4836_;
                phi_1729_ = _e2863;
                phi_1732_ = _e2865;
                phi_1734_ = _e2867;
                let _e3180 = local_10;
                phi_1736_ = _e3180;
            } else {
                phi_1729_ = SlimbvhTypeP();
                phi_1732_ = u32();
                phi_1734_ = u32();
                phi_1736_ = u32();
            }
            let _e2869 = phi_1729_;
            let _e2871 = phi_1732_;
            let _e2873 = phi_1734_;
            let _e2875 = phi_1736_;
            continue;
            continuing {
                phi_1728_ = _e2869;
                phi_1731_ = _e2871;
                phi_1733_ = _e2873;
                phi_1735_ = _e2875;
                break if !(_e816);
            }
        }
        let _e2878 = local_5;
        let _e2879 = (_e2878 == 4294967295u);
        let _e2881 = local_6;
        if (_e2881.member.member.member_3 != 4294967295u) {
            let _e2887 = -((_e196 + _e626.member_4));
            let _e2888 = bitcast<u32>(_e2881.member.member.member);
            let _e2892 = (bitcast<i32>((_e2888 >> bitcast<u32>(23i))) & 255i);
            let _e2893 = (_e2892 + _e2887);
            if (_e2892 == 255i) {
                phi_4894_ = _e2881.member.member.member;
            } else {
                if (_e2892 > 0i) {
                    if (_e2893 > 0i) {
                        let _e2897 = (_e2893 < 255i);
                        if _e2897 {
                            phi_4873_ = bitcast<f32>((_e2888 + bitcast<u32>((_e2887 << bitcast<u32>(23i)))));
                        } else {
                            phi_4873_ = f32();
                        }
                        let _e2904 = phi_4873_;
                        phi_4875_ = _e2904;
                        phi_4876_ = select(true, false, _e2897);
                    } else {
                        phi_4875_ = f32();
                        phi_4876_ = true;
                    }
                    let _e2907 = phi_4875_;
                    let _e2909 = phi_4876_;
                    phi_4877_ = _e2907;
                    phi_4878_ = _e2909;
                } else {
                    phi_4877_ = f32();
                    phi_4878_ = true;
                }
                let _e2911 = phi_4877_;
                let _e2913 = phi_4878_;
                if _e2913 {
                    let _e2914 = (_e2888 & 2147483648u);
                    let _e2921 = ((_e2888 & 8388607u) | (select(0u, 1u, ((_e2888 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e2925 = (_e2921 == 0u);
                    if _e2925 {
                        phi_5576_ = bitcast<f32>(_e2914);
                    } else {
                        let _e2930 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2921)), 32u, _e2925) - 8u);
                        let _e2933 = (_e2921 << bitcast<u32>((_e2930 & 31u)));
                        let _e2935 = ((_e2893 + select(0i, 1i, (_e2892 == 0i))) - bitcast<i32>(_e2930));
                        if (_e2935 >= 255i) {
                            phi_5566_ = bitcast<f32>((_e2914 | 2139095040u));
                            phi_5567_ = f32();
                            phi_5568_ = true;
                        } else {
                            let _e2937 = (_e2935 > 0i);
                            if _e2937 {
                                phi_5560_ = bitcast<f32>(((_e2914 | (bitcast<u32>(_e2935) << bitcast<u32>(23i))) | (_e2933 & 8388607u)));
                                phi_5561_ = f32();
                            } else {
                                if (_e2935 < -24i) {
                                    phi_5526_ = 26u;
                                } else {
                                    phi_5526_ = bitcast<u32>((1i - _e2935));
                                }
                                let _e2942 = phi_5526_;
                                let _e2943 = (_e2942 & 31u);
                                let _e2945 = (_e2933 >> bitcast<u32>(_e2943));
                                let _e2949 = (_e2933 & ((1u << bitcast<u32>(_e2943)) - 1u));
                                let _e2953 = (1u << bitcast<u32>(((_e2942 - 1u) & 31u)));
                                if (_e2949 > _e2953) {
                                    phi_5547_ = true;
                                } else {
                                    if (_e2949 == _e2953) {
                                        phi_5544_ = ((_e2945 & 1u) == 1u);
                                    } else {
                                        phi_5544_ = false;
                                    }
                                    let _e2959 = phi_5544_;
                                    phi_5547_ = _e2959;
                                }
                                let _e2961 = phi_5547_;
                                phi_5560_ = f32();
                                phi_5561_ = bitcast<f32>((_e2914 | (_e2945 + select(0u, 1u, _e2961))));
                            }
                            let _e2974 = phi_5560_;
                            let _e2976 = phi_5561_;
                            phi_5566_ = _e2974;
                            phi_5567_ = _e2976;
                            phi_5568_ = _e2937;
                        }
                        let _e2980 = phi_5566_;
                        let _e2982 = phi_5567_;
                        let _e2984 = phi_5568_;
                        phi_5576_ = select(_e2982, _e2980, _e2984);
                    }
                    let _e2988 = phi_5576_;
                    phi_4893_ = _e2988;
                } else {
                    phi_4893_ = _e2911;
                }
                let _e2990 = phi_4893_;
                phi_4894_ = _e2990;
            }
            let _e2992 = phi_4894_;
            let _e2993 = bitcast<u32>(_e2992);
            if ((_e2993 & 2147483647u) >= 2139095040u) {
                phi_4906_ = bitcast<f32>(((_e2993 & 2147483648u) | 2139095039u));
            } else {
                phi_4906_ = _e2992;
            }
            let _e3000 = phi_4906_;
            phi_4911_ = SlimbvhTypeF(_e3000, _e2881.member.member.member_1, _e2881.member.member.member_2, _e2881.member.member.member_3);
        } else {
            phi_4911_ = _e123;
        }
        let _e3005 = phi_4911_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e3005.member), bitcast<u32>(_e3005.member_1), bitcast<u32>(_e3005.member_2), _e3005.member_3);
        phi_4924_ = _e2879;
        phi_4925_ = _e2879;
        phi_4926_ = select(true, false, _e2879);
    } else {
        phi_4924_ = bool();
        phi_4925_ = false;
        phi_4926_ = true;
    }
    let _e3016 = phi_4924_;
    let _e3018 = phi_4925_;
    let _e3020 = phi_4926_;
    if _e3020 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e3016, _e3018, _e3020)));
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
