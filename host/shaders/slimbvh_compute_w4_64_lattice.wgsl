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

struct SlimbvhTypeU {
    member: u32,
}

var<workgroup> slimbvh_stacks: array<u32, 2048>;

var<private> slimbvh_lane: SlimbvhTypeU;

var<private> slimbvh_overflowed: SlimbvhTypeU;

fn slimbvh_trace_in_group() {
    var phi_599_: u32;
    var phi_605_: u32;
    var phi_611_: u32;
    var phi_876_: i32;
    var phi_887_: i32;
    var phi_1001_: i32;
    var phi_1130_: i32;
    var phi_1152_: u32;
    var phi_1153_: u32;
    var phi_1154_: bool;
    var phi_1188_: i32;
    var phi_1210_: u32;
    var phi_1211_: u32;
    var phi_1212_: bool;
    var phi_773_: i32;
    var phi_779_: u32;
    var phi_798_: u32;
    var phi_799_: u32;
    var phi_800_: bool;
    var phi_818_: i32;
    var phi_824_: u32;
    var phi_843_: u32;
    var phi_844_: u32;
    var phi_845_: bool;
    var phi_1222_: SlimbvhTypeC;
    var phi_1468_: SlimbvhTypeQ;
    var phi_1531_: array<f32, 3>;
    var phi_1532_: array<f32, 3>;
    var phi_1550_: array<f32, 3>;
    var phi_1551_: array<f32, 3>;
    var phi_1724_: SlimbvhTypeQ;
    var phi_1727_: u32;
    var phi_1729_: u32;
    var phi_1731_: u32;
    var phi_1740_: u32;
    var phi_1743_: u32;
    var phi_1745_: u32;
    var phi_1852_: SlimbvhTypeL;
    var phi_1853_: SlimbvhTypeL;
    var phi_1912_: SlimbvhTypeL;
    var phi_1913_: SlimbvhTypeL;
    var phi_1972_: SlimbvhTypeL;
    var phi_1973_: SlimbvhTypeL;
    var phi_2457_: u32;
    var phi_2470_: u32;
    var phi_2483_: u32;
    var phi_2496_: u32;
    var phi_5159_: SlimbvhTypeD;
    var phi_5171_: SlimbvhTypeD;
    var phi_5183_: SlimbvhTypeD;
    var phi_5195_: SlimbvhTypeD;
    var phi_5207_: SlimbvhTypeD;
    var phi_2580_: u32;
    var phi_2585_: u32;
    var phi_2586_: u32;
    var phi_2616_: u32;
    var phi_2617_: u32;
    var phi_1741_: u32;
    var phi_1744_: u32;
    var phi_1746_: u32;
    var local: bool;
    var local_1: u32;
    var phi_2767_: u32;
    var phi_2828_: u32;
    var phi_2831_: SlimbvhTypeN;
    var phi_2838_: SlimbvhTypeQ;
    var phi_2841_: SlimbvhTypeD;
    var phi_2842_: SlimbvhTypeD;
    var phi_2864_: SlimbvhTypeD;
    var phi_2879_: u32;
    var phi_2890_: u32;
    var phi_2906_: u32;
    var phi_2919_: u32;
    var phi_2930_: u32;
    var phi_3374_: u32;
    var phi_3387_: u32;
    var phi_3400_: u32;
    var phi_3426_: u32;
    var phi_3439_: u32;
    var phi_3452_: u32;
    var phi_3478_: u32;
    var phi_3491_: u32;
    var phi_3504_: u32;
    var phi_3096_: u32;
    var phi_3109_: u32;
    var phi_3119_: u32;
    var phi_3140_: u32;
    var phi_3161_: u32;
    var phi_3188_: u32;
    var phi_3201_: u32;
    var phi_3211_: u32;
    var phi_3232_: u32;
    var phi_3253_: u32;
    var phi_3280_: u32;
    var phi_3293_: u32;
    var phi_3303_: u32;
    var phi_3324_: u32;
    var phi_3345_: u32;
    var phi_2957_: u32;
    var phi_3003_: u32;
    var phi_3049_: u32;
    var phi_3516_: array<array<f32, 3>, 3>;
    var phi_3881_: f32;
    var phi_3882_: f32;
    var phi_3883_: f32;
    var phi_3884_: f32;
    var phi_3885_: vec3<f32>;
    var phi_3886_: vec3<f32>;
    var phi_3887_: vec3<f32>;
    var phi_3888_: vec3<f32>;
    var phi_4067_: f32;
    var phi_4093_: SlimbvhTypeE;
    var phi_4094_: SlimbvhTypeE;
    var phi_4097_: SlimbvhTypeE;
    var phi_4098_: SlimbvhTypeE;
    var phi_4099_: bool;
    var phi_4103_: SlimbvhTypeE;
    var phi_4112_: SlimbvhTypeF;
    var phi_4165_: i32;
    var phi_4305_: SlimbvhTypeH;
    var phi_4329_: u32;
    var phi_4358_: vec3<f32>;
    var phi_4359_: vec3<f32>;
    var phi_4377_: vec3<f32>;
    var phi_4378_: vec3<f32>;
    var phi_4396_: vec3<f32>;
    var phi_4397_: vec3<f32>;
    var phi_4433_: vec3<f32>;
    var phi_4615_: f32;
    var phi_4633_: bool;
    var phi_4634_: bool;
    var phi_4653_: bool;
    var phi_4654_: bool;
    var phi_4661_: SlimbvhTypeQ;
    var phi_4667_: SlimbvhTypeQ;
    var phi_4668_: SlimbvhTypeQ;
    var phi_4669_: SlimbvhTypeQ;
    var phi_2839_: SlimbvhTypeQ;
    var local_2: u32;
    var local_3: u32;
    var phi_4736_: u32;
    var phi_4737_: u32;
    var local_4: SlimbvhTypeQ;
    var phi_4746_: SlimbvhTypeQ;
    var phi_4747_: u32;
    var phi_4748_: u32;
    var phi_1725_: SlimbvhTypeQ;
    var phi_1728_: u32;
    var phi_1730_: u32;
    var phi_1732_: u32;
    var local_5: u32;
    var local_6: SlimbvhTypeQ;
    var phi_4785_: f32;
    var phi_4787_: f32;
    var phi_4788_: bool;
    var phi_4789_: f32;
    var phi_4790_: bool;
    var phi_5438_: u32;
    var phi_5456_: bool;
    var phi_5459_: bool;
    var phi_5472_: f32;
    var phi_5473_: f32;
    var phi_5478_: f32;
    var phi_5479_: f32;
    var phi_5480_: bool;
    var phi_5488_: f32;
    var phi_4805_: f32;
    var phi_4806_: f32;
    var phi_4818_: f32;
    var phi_4823_: SlimbvhTypeF;
    var phi_4836_: bool;
    var phi_4837_: bool;
    var phi_4838_: bool;
    var local_7: SlimbvhTypeQ;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e109 = SlimbvhTypeF(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e113 = arrayLength((&slimbvh_nodes.member));
    let _e116 = arrayLength((&slimbvh_triangles.member));
    let _e128 = slimbvh_root.member[0u][0u];
    let _e132 = slimbvh_root.member[0u][1u];
    let _e136 = slimbvh_root.member[0u][2u];
    let _e140 = slimbvh_root.member[0u][3u];
    let _e144 = slimbvh_root.member[1u][0u];
    let _e148 = slimbvh_root.member[1u][1u];
    let _e152 = slimbvh_root.member[1u][2u];
    let _e164 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e140) + 127i)) << bitcast<u32>(23i)));
    let _e167 = slimbvh_exponent.member[1u];
    let _e170 = slimbvh_exponent.member[2u];
    let _e171 = slimbvh_origin.member;
    let _e177 = slimbvh_origin.member[3u];
    let _e178 = slimbvh_direction.member;
    let _e184 = slimbvh_direction.member[3u];
    let _e187 = slimbvh_exponent.member[0u];
    let _e188 = bitcast<i32>(_e187);
    let _e190 = (bitcast<u32>(_e171.x) & 2147483647u);
    let _e192 = (bitcast<u32>(_e171.y) & 2147483647u);
    let _e194 = (bitcast<u32>(_e171.z) & 2147483647u);
    let _e195 = bitcast<u32>(_e177);
    let _e196 = (_e195 & 2147483647u);
    let _e198 = (bitcast<u32>(_e178.x) & 2147483647u);
    let _e200 = (bitcast<u32>(_e178.y) & 2147483647u);
    let _e202 = (bitcast<u32>(_e178.z) & 2147483647u);
    let _e203 = bitcast<u32>(_e184);
    let _e204 = (_e203 & 2147483647u);
    let _e206 = select(_e200, _e198, (_e200 < _e198));
    let _e208 = select(_e202, _e206, (_e202 < _e206));
    let _e210 = select(_e190, _e208, (_e190 < _e208));
    let _e212 = select(_e192, _e210, (_e192 < _e210));
    let _e214 = select(_e194, _e212, (_e194 < _e212));
    let _e221 = (((select(_e196, _e214, (_e196 < _e214)) < 2139095040u) && (_e204 <= 2139095040u)) && (_e208 > 0u));
    if (_e198 == _e208) {
        phi_599_ = 0u;
    } else {
        phi_599_ = select(2u, 1u, (_e200 == _e208));
    }
    let _e226 = phi_599_;
    let _e227 = (_e226 == 2u);
    if _e227 {
        phi_605_ = 0u;
    } else {
        phi_605_ = (_e226 + 1u);
    }
    let _e230 = phi_605_;
    let _e231 = (_e230 == 2u);
    if _e231 {
        phi_611_ = 0u;
    } else {
        phi_611_ = (_e230 + 1u);
    }
    let _e234 = phi_611_;
    let _e235 = (_e230 == 0u);
    let _e237 = select(select(_e171.y, _e171.x, _e235), _e171.z, _e231);
    let _e238 = (_e234 == 0u);
    let _e240 = (_e234 == 2u);
    let _e241 = select(select(_e171.y, _e171.x, _e238), _e171.z, _e240);
    let _e242 = (_e226 == 0u);
    let _e244 = select(select(_e171.y, _e171.x, _e242), _e171.z, _e227);
    let _e246 = select(select(_e178.y, _e178.x, _e235), _e178.z, _e231);
    let _e248 = select(select(_e178.y, _e178.x, _e238), _e178.z, _e240);
    let _e250 = select(select(_e178.y, _e178.x, _e242), _e178.z, _e227);
    let _e251 = (_e196 - 1u);
    let _e252 = (_e204 - 1u);
    let _e254 = select(_e251, _e252, (_e252 < _e251));
    let _e255 = (_e190 - 1u);
    let _e256 = (_e192 - 1u);
    let _e258 = select(_e255, _e256, (_e256 < _e255));
    let _e259 = (_e194 - 1u);
    let _e261 = select(_e258, _e259, (_e259 < _e258));
    let _e262 = (_e198 - 1u);
    let _e263 = (_e200 - 1u);
    let _e265 = select(_e262, _e263, (_e263 < _e262));
    let _e266 = (_e202 - 1u);
    let _e268 = select(_e265, _e266, (_e266 < _e265));
    let _e270 = select(_e261, _e268, (_e268 < _e261));
    if (((select(_e270, _e254, (_e254 < _e270)) >= 8388607u) && (_e208 < 2130706432u)) && (bitcast<u32>((_e188 + 126i)) <= 253u)) {
        let _e535 = bitcast<i32>((_e208 >> bitcast<u32>(23i)));
        let _e536 = (_e535 - 127i);
        let _e537 = (_e188 + _e536);
        let _e542 = bitcast<f32>((bitcast<u32>((_e188 + 127i)) << bitcast<u32>(23i)));
        let _e547 = bitcast<f32>((bitcast<u32>((254i - _e535)) << bitcast<u32>(23i)));
        if (_e196 >= 2139095040u) {
            phi_773_ = 255i;
        } else {
            phi_773_ = (bitcast<i32>((_e196 >> bitcast<u32>(23i))) + _e537);
        }
        let _e562 = phi_773_;
        if (_e196 == 0u) {
            phi_779_ = 0u;
        } else {
            phi_779_ = (_e196 | 8388608u);
        }
        let _e566 = phi_779_;
        if (_e562 <= 0i) {
            phi_799_ = u32();
            phi_800_ = true;
        } else {
            let _e573 = (_e566 == 0u);
            if _e573 {
                phi_798_ = u32();
            } else {
                phi_798_ = select(((bitcast<u32>(_e562) << bitcast<u32>(23i)) | (_e566 & 8388607u)), 2139095039u, (_e562 >= 255i));
            }
            let _e577 = phi_798_;
            phi_799_ = _e577;
            phi_800_ = _e573;
        }
        let _e579 = phi_799_;
        let _e581 = phi_800_;
        if (_e204 >= 2139095040u) {
            phi_818_ = 255i;
        } else {
            phi_818_ = (bitcast<i32>((_e204 >> bitcast<u32>(23i))) + _e537);
        }
        let _e592 = phi_818_;
        if (_e204 == 0u) {
            phi_824_ = 0u;
        } else {
            phi_824_ = (_e204 | 8388608u);
        }
        let _e596 = phi_824_;
        if (_e592 <= 0i) {
            phi_844_ = u32();
            phi_845_ = true;
        } else {
            let _e603 = (_e596 == 0u);
            if _e603 {
                phi_843_ = u32();
            } else {
                phi_843_ = select(((bitcast<u32>(_e592) << bitcast<u32>(23i)) | (_e596 & 8388607u)), 2139095039u, (_e592 >= 255i));
            }
            let _e607 = phi_843_;
            phi_844_ = _e607;
            phi_845_ = _e603;
        }
        let _e609 = phi_844_;
        let _e611 = phi_845_;
        phi_1222_ = SlimbvhTypeC(array<f32, 3>((_e237 * _e542), (_e241 * _e542), (_e244 * _e542)), array<f32, 3>((_e246 * _e547), (_e248 * _e547), (_e250 * _e547)), bitcast<f32>(((_e195 & 2147483648u) | select(_e579, 0u, _e581))), bitcast<f32>(((_e203 & 2147483648u) | select(_e609, 0u, _e611))), _e536);
    } else {
        let _e283 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e208, _e221))) & 2147483647u);
        if (_e283 >= 8388608u) {
            phi_876_ = (bitcast<i32>((_e283 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_876_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e283)), 32u, (_e283 == 0u))));
        }
        let _e297 = phi_876_;
        let _e298 = (_e188 + _e297);
        if (_e188 < -126i) {
            phi_887_ = -126i;
        } else {
            phi_887_ = select(_e188, 127i, (_e188 > 127i));
        }
        let _e303 = phi_887_;
        let _e308 = bitcast<f32>((bitcast<u32>((_e303 + 127i)) << bitcast<u32>(23i)));
        let _e314 = bitcast<f32>((bitcast<u32>(((_e188 - _e303) + 127i)) << bitcast<u32>(23i)));
        let _e315 = bitcast<u32>(_e237);
        let _e317 = ((_e315 & 2139095040u) != 0u);
        let _e332 = bitcast<u32>(_e241);
        let _e334 = ((_e332 & 2139095040u) != 0u);
        let _e349 = bitcast<u32>(_e244);
        let _e351 = ((_e349 & 2139095040u) != 0u);
        let _e367 = -(_e297);
        if (_e367 < -126i) {
            phi_1001_ = -126i;
        } else {
            phi_1001_ = select(_e367, 127i, (_e367 > 127i));
        }
        let _e372 = phi_1001_;
        let _e377 = bitcast<f32>((bitcast<u32>((_e372 + 127i)) << bitcast<u32>(23i)));
        let _e383 = bitcast<f32>((bitcast<u32>(((_e367 - _e372) + 127i)) << bitcast<u32>(23i)));
        let _e384 = bitcast<u32>(_e246);
        let _e386 = ((_e384 & 2139095040u) != 0u);
        let _e401 = bitcast<u32>(_e248);
        let _e403 = ((_e401 & 2139095040u) != 0u);
        let _e418 = bitcast<u32>(_e250);
        let _e420 = ((_e418 & 2139095040u) != 0u);
        let _e442 = ((_e196 & 8388607u) | (select(0u, 1u, ((_e196 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e445 = bitcast<i32>((_e196 >> bitcast<u32>(23i)));
        let _e452 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e442)), 32u, (_e442 == 0u))) - 8i);
        if (_e445 == 255i) {
            phi_1130_ = 255i;
        } else {
            phi_1130_ = (((_e445 + select(0i, 1i, (_e445 == 0i))) - _e452) + _e298);
        }
        let _e460 = phi_1130_;
        let _e464 = (_e442 << bitcast<u32>(((_e452 & 31i) & 31i)));
        if (_e460 <= 0i) {
            phi_1153_ = u32();
            phi_1154_ = true;
        } else {
            let _e471 = (_e464 == 0u);
            if _e471 {
                phi_1152_ = u32();
            } else {
                phi_1152_ = select(((bitcast<u32>(_e460) << bitcast<u32>(23i)) | (_e464 & 8388607u)), 2139095039u, (_e460 >= 255i));
            }
            let _e475 = phi_1152_;
            phi_1153_ = _e475;
            phi_1154_ = _e471;
        }
        let _e477 = phi_1153_;
        let _e479 = phi_1154_;
        let _e490 = ((_e204 & 8388607u) | (select(0u, 1u, ((_e204 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e493 = bitcast<i32>((_e204 >> bitcast<u32>(23i)));
        let _e500 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e490)), 32u, (_e490 == 0u))) - 8i);
        if (_e493 == 255i) {
            phi_1188_ = 255i;
        } else {
            phi_1188_ = (((_e493 + select(0i, 1i, (_e493 == 0i))) - _e500) + _e298);
        }
        let _e508 = phi_1188_;
        let _e512 = (_e490 << bitcast<u32>(((_e500 & 31i) & 31i)));
        if (_e508 <= 0i) {
            phi_1211_ = u32();
            phi_1212_ = true;
        } else {
            let _e519 = (_e512 == 0u);
            if _e519 {
                phi_1210_ = u32();
            } else {
                phi_1210_ = select(((bitcast<u32>(_e508) << bitcast<u32>(23i)) | (_e512 & 8388607u)), 2139095039u, (_e508 >= 255i));
            }
            let _e523 = phi_1210_;
            phi_1211_ = _e523;
            phi_1212_ = _e519;
        }
        let _e525 = phi_1211_;
        let _e527 = phi_1212_;
        phi_1222_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e237, _e317) * _e308) * select(0.00000011920929f, 1f, _e317)) * _e314), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e332 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e332 & 2147483648u))), _e241, _e334) * _e308) * select(0.00000011920929f, 1f, _e334)) * _e314), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e349 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e349 & 2147483648u))), _e244, _e351) * _e308) * select(0.00000011920929f, 1f, _e351)) * _e314)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e246, _e386) * _e377) * select(0.00000011920929f, 1f, _e386)) * _e383), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e401 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e401 & 2147483648u))), _e248, _e403) * _e377) * select(0.00000011920929f, 1f, _e403)) * _e383), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e418 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e418 & 2147483648u))), _e250, _e420) * _e377) * select(0.00000011920929f, 1f, _e420)) * _e383)), bitcast<f32>(((_e195 & 2147483648u) | select(_e477, 0u, _e479))), bitcast<f32>(((_e203 & 2147483648u) | select(_e525, 0u, _e527))), _e297);
    }
    let _e618 = phi_1222_;
    let _e633 = (bitcast<f32>((bitcast<u32>(_e618.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e636 = bitcast<f32>((bitcast<u32>(_e618.member[0]) & 2147483647u));
    let _e637 = (_e636 * 0.00000011920929f);
    let _e640 = select(select(0.00000000000011368684f, _e637, (_e637 > 0.00000000000011368684f)), 0f, _e633);
    let _e641 = select(0f, _e618.member_1[0], _e633);
    let _e642 = (_e618.member[0] + _e640);
    let _e643 = (_e618.member[0] - _e640);
    let _e645 = select(38685626000000000000000000f, (1f / _e618.member_1[0]), _e633);
    let _e649 = (bitcast<f32>((bitcast<u32>(_e618.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e652 = bitcast<f32>((bitcast<u32>(_e618.member[1]) & 2147483647u));
    let _e653 = (_e652 * 0.00000011920929f);
    let _e656 = select(select(0.00000000000011368684f, _e653, (_e653 > 0.00000000000011368684f)), 0f, _e649);
    let _e657 = select(0f, _e618.member_1[1], _e649);
    let _e658 = (_e618.member[1] + _e656);
    let _e659 = (_e618.member[1] - _e656);
    let _e661 = select(38685626000000000000000000f, (1f / _e618.member_1[1]), _e649);
    let _e665 = (bitcast<f32>((bitcast<u32>(_e618.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e668 = bitcast<f32>((bitcast<u32>(_e618.member[2]) & 2147483647u));
    let _e669 = (_e668 * 0.00000011920929f);
    let _e672 = select(select(0.00000000000011368684f, _e669, (_e669 > 0.00000000000011368684f)), 0f, _e665);
    let _e673 = select(0f, _e618.member_1[2], _e665);
    let _e674 = (_e618.member[2] + _e672);
    let _e675 = (_e618.member[2] - _e672);
    let _e677 = select(38685626000000000000000000f, (1f / _e618.member_1[2]), _e665);
    let _e679 = select(_e652, _e636, (_e636 > _e652));
    let _e683 = (_e221 && (select(_e668, _e679, (_e679 > _e668)) <= 1099511600000f));
    let _e684 = select(0f, _e618.member_3, _e683);
    let _e685 = select(1f, _e618.member_2, _e683);
    let _e689 = slimbvh_question.member[1u];
    let _e690 = slimbvh_lane.member;
    if (_e690 < 64u) {
        let _e692 = (_e690 % 64u);
        let _e695 = slimbvh_question.member[0u];
        if (_e695 == 1u) {
            phi_1468_ = SlimbvhTypeQ(SlimbvhTypeI(_e109, _e684), true);
        } else {
            phi_1468_ = SlimbvhTypeQ(SlimbvhTypeI(_e109, _e684), false);
        }
        let _e702 = phi_1468_;
        let _e707 = (_e230 & 3u);
        let _e708 = (_e234 & 3u);
        let _e709 = (_e226 & 3u);
        let _e712 = (bitcast<u32>(_e645) >> bitcast<u32>(31i));
        let _e715 = (bitcast<u32>(_e661) >> bitcast<u32>(31i));
        let _e718 = (bitcast<u32>(_e677) >> bitcast<u32>(31i));
        let _e722 = (f32(bitcast<i32>(_e128)) * _e164);
        let _e724 = (f32(bitcast<i32>(_e132)) * _e164);
        let _e726 = (f32(bitcast<i32>(_e136)) * _e164);
        let _e727 = (_e707 == 0u);
        if _e727 {
            phi_1532_ = array<f32, 3>(_e722, _e724, _e726);
        } else {
            if (_e707 == 1u) {
                phi_1531_ = array<f32, 3>(_e724, _e726, _e722);
            } else {
                phi_1531_ = array<f32, 3>(_e726, _e722, _e724);
            }
            let _e732 = phi_1531_;
            phi_1532_ = _e732;
        }
        let _e735 = phi_1532_;
        let _e737 = (f32(bitcast<i32>(_e144)) * _e164);
        let _e739 = (f32(bitcast<i32>(_e148)) * _e164);
        let _e741 = (f32(bitcast<i32>(_e152)) * _e164);
        if _e727 {
            phi_1551_ = array<f32, 3>(_e737, _e739, _e741);
        } else {
            if (_e707 == 1u) {
                phi_1550_ = array<f32, 3>(_e739, _e741, _e737);
            } else {
                phi_1550_ = array<f32, 3>(_e741, _e737, _e739);
            }
            let _e746 = phi_1550_;
            phi_1551_ = _e746;
        }
        let _e749 = phi_1551_;
        let _e760 = ((_e735[0] - _e642) * _e645);
        let _e761 = ((_e749[0] - _e643) * _e645);
        let _e762 = vec4<f32>(_e760, f32(), _e761, f32());
        let _e765 = ((_e735[1] - _e658) * _e661);
        let _e766 = ((_e749[1] - _e659) * _e661);
        let _e767 = vec4<f32>(_e765, f32(), _e766, f32());
        let _e770 = ((_e735[2] - _e674) * _e677);
        let _e771 = ((_e749[2] - _e675) * _e677);
        let _e772 = vec4<f32>(_e770, f32(), _e771, f32());
        let _e773 = vec4<f32>(_e761, f32(), _e760, f32());
        let _e775 = vec4<f32>(_e766, f32(), _e765, f32());
        let _e777 = vec4<f32>(_e771, f32(), _e770, f32());
        phi_1724_ = _e702;
        phi_1727_ = select(4294967295u, select(4294967295u, 0u, (_e685 <= _e684)), (max(max(max(min(_e762, _e773).x, min(_e767, _e775).x), min(_e772, _e777).x), _e685) <= min((min(min(max(_e762, _e773).x, max(_e767, _e775).x), max(_e772, _e777).x) + (max(max(_e772, _e777).x, -(min(_e772, _e777).x)) * 0.0000019073523f)), _e702.member.member_1)));
        phi_1729_ = select(0u, 4294967295u, (_e113 == 0u));
        phi_1731_ = (_e113 + 1u);
        loop {
            let _e801 = phi_1724_;
            let _e803 = phi_1727_;
            let _e805 = phi_1729_;
            let _e807 = phi_1731_;
            local_5 = _e803;
            local_6 = _e801;
            let _e808 = (_e803 <= 32u);
            if _e808 {
                phi_1740_ = _e803;
                phi_1743_ = _e805;
                phi_1745_ = _e807;
                loop {
                    let _e810 = phi_1740_;
                    let _e812 = phi_1743_;
                    let _e814 = phi_1745_;
                    local_1 = _e812;
                    local_2 = _e810;
                    local_3 = _e810;
                    local_8 = _e810;
                    local_9 = _e812;
                    local_10 = _e814;
                    let _e815 = (_e810 <= 32u);
                    let _e817 = (_e812 + _e167);
                    let _e821 = (_e815 && !(((_e812 >= _e113) || (_e817 >= _e113))));
                    local = _e815;
                    if _e821 {
                        let _e827 = slimbvh_nodes.member[_e817].member[select(_e707, 2u, (2u < _e707))];
                        let _e833 = slimbvh_nodes.member[_e817].member[select(_e708, 2u, (2u < _e708))];
                        let _e839 = slimbvh_nodes.member[_e817].member[select(_e709, 2u, (2u < _e709))];
                        let _e842 = bitcast<u32>(_e164);
                        let _e847 = bitcast<f32>(_e827.x);
                        let _e852 = (_e847 + (f32((_e827.w >> bitcast<u32>(5u))) * _e164));
                        if (_e712 == 0u) {
                            phi_1852_ = SlimbvhTypeL(_e827.z, _e852);
                            phi_1853_ = SlimbvhTypeL(_e827.y, _e847);
                        } else {
                            phi_1852_ = SlimbvhTypeL(_e827.y, _e847);
                            phi_1853_ = SlimbvhTypeL(_e827.z, _e852);
                        }
                        let _e863 = phi_1852_;
                        let _e865 = phi_1853_;
                        let _e869 = bitcast<f32>(((_e842 + ((_e827.w & 31u) << bitcast<u32>(23i))) ^ (_e712 << bitcast<u32>(31i))));
                        let _e909 = bitcast<f32>(_e833.x);
                        let _e914 = (_e909 + (f32((_e833.w >> bitcast<u32>(5u))) * _e164));
                        if (_e715 == 0u) {
                            phi_1912_ = SlimbvhTypeL(_e833.z, _e914);
                            phi_1913_ = SlimbvhTypeL(_e833.y, _e909);
                        } else {
                            phi_1912_ = SlimbvhTypeL(_e833.y, _e909);
                            phi_1913_ = SlimbvhTypeL(_e833.z, _e914);
                        }
                        let _e925 = phi_1912_;
                        let _e927 = phi_1913_;
                        let _e931 = bitcast<f32>(((_e842 + ((_e833.w & 31u) << bitcast<u32>(23i))) ^ (_e715 << bitcast<u32>(31i))));
                        let _e971 = bitcast<f32>(_e839.x);
                        let _e976 = (_e971 + (f32((_e839.w >> bitcast<u32>(5u))) * _e164));
                        if (_e718 == 0u) {
                            phi_1972_ = SlimbvhTypeL(_e839.z, _e976);
                            phi_1973_ = SlimbvhTypeL(_e839.y, _e971);
                        } else {
                            phi_1972_ = SlimbvhTypeL(_e839.y, _e971);
                            phi_1973_ = SlimbvhTypeL(_e839.z, _e976);
                        }
                        let _e987 = phi_1972_;
                        let _e989 = phi_1973_;
                        let _e993 = bitcast<f32>(((_e842 + ((_e839.w & 31u) << bitcast<u32>(23i))) ^ (_e718 << bitcast<u32>(31i))));
                        let _e1029 = (_e869 * _e645);
                        let _e1036 = (((_e865.member_1 - _e642) * _e645) + (bitcast<f32>((bitcast<u32>(_e1029) & 2147483647u)) * -0.00012207031f));
                        let _e1045 = (-(_e869) * _e645);
                        let _e1052 = (((_e863.member_1 - _e643) * _e645) + (bitcast<f32>((bitcast<u32>(_e1045) & 2147483647u)) * 0.00012207031f));
                        let _e1061 = (_e931 * _e661);
                        let _e1068 = (((_e927.member_1 - _e658) * _e661) + (bitcast<f32>((bitcast<u32>(_e1061) & 2147483647u)) * -0.00012207031f));
                        let _e1077 = (-(_e931) * _e661);
                        let _e1084 = (((_e925.member_1 - _e659) * _e661) + (bitcast<f32>((bitcast<u32>(_e1077) & 2147483647u)) * 0.00012207031f));
                        let _e1093 = (_e993 * _e677);
                        let _e1100 = (((_e989.member_1 - _e674) * _e677) + (bitcast<f32>((bitcast<u32>(_e1093) & 2147483647u)) * -0.00012207031f));
                        let _e1105 = ((f32((_e989.member & 255u)) * _e1093) + _e1100);
                        let _e1106 = ((f32(((_e989.member >> bitcast<u32>(8u)) & 255u)) * _e1093) + _e1100);
                        let _e1107 = ((f32(((_e989.member >> bitcast<u32>(16u)) & 255u)) * _e1093) + _e1100);
                        let _e1108 = ((f32(((_e989.member >> bitcast<u32>(24u)) & 255u)) * _e1093) + _e1100);
                        let _e1109 = (-(_e993) * _e677);
                        let _e1116 = (((_e987.member_1 - _e675) * _e677) + (bitcast<f32>((bitcast<u32>(_e1109) & 2147483647u)) * 0.00012207031f));
                        let _e1121 = ((f32((_e987.member & 255u)) * _e1109) + _e1116);
                        let _e1122 = ((f32(((_e987.member >> bitcast<u32>(8u)) & 255u)) * _e1109) + _e1116);
                        let _e1123 = ((f32(((_e987.member >> bitcast<u32>(16u)) & 255u)) * _e1109) + _e1116);
                        let _e1124 = ((f32(((_e987.member >> bitcast<u32>(24u)) & 255u)) * _e1109) + _e1116);
                        let _e1157 = max(max(max(((f32((_e865.member & 255u)) * _e1029) + _e1036), ((f32((_e927.member & 255u)) * _e1061) + _e1068)), _e1105), _e685);
                        let _e1158 = max(max(max(((f32(((_e865.member >> bitcast<u32>(8u)) & 255u)) * _e1029) + _e1036), ((f32(((_e927.member >> bitcast<u32>(8u)) & 255u)) * _e1061) + _e1068)), _e1106), _e685);
                        let _e1159 = max(max(max(((f32(((_e865.member >> bitcast<u32>(16u)) & 255u)) * _e1029) + _e1036), ((f32(((_e927.member >> bitcast<u32>(16u)) & 255u)) * _e1061) + _e1068)), _e1107), _e685);
                        let _e1160 = max(max(max(((f32(((_e865.member >> bitcast<u32>(24u)) & 255u)) * _e1029) + _e1036), ((f32(((_e927.member >> bitcast<u32>(24u)) & 255u)) * _e1061) + _e1068)), _e1108), _e685);
                        let _e1165 = (_e801.member.member_1 + (bitcast<f32>((bitcast<u32>(_e801.member.member_1) & 2147483647u)) * 0.0000004768374f));
                        if (_e1157 <= min((min(min(((f32((_e863.member & 255u)) * _e1045) + _e1052), ((f32((_e925.member & 255u)) * _e1077) + _e1084)), _e1121) + (max(_e1121, -(_e1105)) * 0.0000023841915f)), _e1165)) {
                            phi_2457_ = (((bitcast<u32>(_e1157) ^ select(0u, 4294967288u, _e702.member_1)) & 2147483640u) | 4u);
                        } else {
                            phi_2457_ = 4294967288u;
                        }
                        let _e1180 = phi_2457_;
                        if (_e1158 <= min((min(min(((f32(((_e863.member >> bitcast<u32>(8u)) & 255u)) * _e1045) + _e1052), ((f32(((_e925.member >> bitcast<u32>(8u)) & 255u)) * _e1077) + _e1084)), _e1122) + (max(_e1122, -(_e1106)) * 0.0000023841915f)), _e1165)) {
                            phi_2470_ = ((((bitcast<u32>(_e1158) ^ select(0u, 4294967288u, _e702.member_1)) & 2147483640u) | 4u) | 1u);
                        } else {
                            phi_2470_ = 4294967288u;
                        }
                        let _e1188 = phi_2470_;
                        if (_e1159 <= min((min(min(((f32(((_e863.member >> bitcast<u32>(16u)) & 255u)) * _e1045) + _e1052), ((f32(((_e925.member >> bitcast<u32>(16u)) & 255u)) * _e1077) + _e1084)), _e1123) + (max(_e1123, -(_e1107)) * 0.0000023841915f)), _e1165)) {
                            phi_2483_ = ((((bitcast<u32>(_e1159) ^ select(0u, 4294967288u, _e702.member_1)) & 2147483640u) | 4u) | 2u);
                        } else {
                            phi_2483_ = 4294967288u;
                        }
                        let _e1196 = phi_2483_;
                        if (_e1160 <= min((min(min(((f32(((_e863.member >> bitcast<u32>(24u)) & 255u)) * _e1045) + _e1052), ((f32(((_e925.member >> bitcast<u32>(24u)) & 255u)) * _e1077) + _e1084)), _e1124) + (max(_e1124, -(_e1108)) * 0.0000023841915f)), _e1165)) {
                            phi_2496_ = ((((bitcast<u32>(_e1160) ^ select(0u, 4294967288u, _e702.member_1)) & 2147483640u) | 4u) | 3u);
                        } else {
                            phi_2496_ = 4294967288u;
                        }
                        let _e1204 = phi_2496_;
                        if (_e1180 < _e1188) {
                            phi_5159_ = SlimbvhTypeD(_e1180, _e1188);
                        } else {
                            phi_5159_ = SlimbvhTypeD(_e1188, _e1180);
                        }
                        let _e1209 = phi_5159_;
                        if (_e1196 < _e1204) {
                            phi_5171_ = SlimbvhTypeD(_e1196, _e1204);
                        } else {
                            phi_5171_ = SlimbvhTypeD(_e1204, _e1196);
                        }
                        let _e1216 = phi_5171_;
                        if (_e1209.member < _e1216.member) {
                            phi_5183_ = SlimbvhTypeD(_e1209.member, _e1216.member);
                        } else {
                            phi_5183_ = SlimbvhTypeD(_e1216.member, _e1209.member);
                        }
                        let _e1223 = phi_5183_;
                        if (_e1209.member_1 < _e1216.member_1) {
                            phi_5195_ = SlimbvhTypeD(_e1209.member_1, _e1216.member_1);
                        } else {
                            phi_5195_ = SlimbvhTypeD(_e1216.member_1, _e1209.member_1);
                        }
                        let _e1230 = phi_5195_;
                        if (_e1230.member < _e1223.member_1) {
                            phi_5207_ = SlimbvhTypeD(_e1230.member, _e1223.member_1);
                        } else {
                            phi_5207_ = SlimbvhTypeD(_e1223.member_1, _e1230.member);
                        }
                        let _e1237 = phi_5207_;
                        let _e1252 = (((_e1223.member & 7u) | ((_e1237.member & 7u) << bitcast<u32>(3u))) | (((_e1237.member_1 & 7u) | ((_e1230.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                        if (_e1252 == 0u) {
                            let _e1272 = (_e810 - 1u);
                            let _e1277 = slimbvh_stacks[(((_e1272 % 32u) * 64u) + _e692)];
                            let _e1278 = (_e1277 & 511u);
                            let _e1280 = (_e1278 >> bitcast<u32>(3u));
                            let _e1283 = ((_e1280 == 0u) || (_e1272 == 4294967295u));
                            if _e1283 {
                            } else {
                                slimbvh_stacks[(((_e1272 % 32u) * 64u) + _e692)] = (((_e1277 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1280);
                            }
                            phi_2585_ = select(_e810, _e1272, _e1283);
                            phi_2586_ = (((_e1277 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1278 & 3u) & 3u));
                        } else {
                            let _e1255 = (_e1252 >> bitcast<u32>(3u));
                            if (_e1255 == 0u) {
                                phi_2580_ = _e810;
                            } else {
                                slimbvh_stacks[(((_e810 % 32u) * 64u) + _e692)] = ((_e817 << bitcast<u32>(9u)) | _e1255);
                                phi_2580_ = (_e810 + 1u);
                            }
                            let _e1266 = phi_2580_;
                            phi_2585_ = _e1266;
                            phi_2586_ = ((_e817 << bitcast<u32>(2i)) | ((_e1252 & 3u) & 3u));
                        }
                        let _e1298 = phi_2585_;
                        let _e1300 = phi_2586_;
                        let _e1302 = (_e1300 >> bitcast<u32>(2i));
                        if (_e1302 < _e113) {
                            let _e1308 = slimbvh_nodes.member[_e1302].member_1[(_e1300 & 3u)];
                            if ((_e1308 & 2147483648u) != 0u) {
                                phi_2616_ = (2147483648u | _e1300);
                            } else {
                                phi_2616_ = _e1308;
                            }
                            let _e1313 = phi_2616_;
                            phi_2617_ = _e1313;
                        } else {
                            phi_2617_ = 4294967295u;
                        }
                        let _e1315 = phi_2617_;
                        let _e1316 = (_e814 - 1u);
                        phi_1741_ = select(_e1298, 4294967295u, (_e1316 == 0u));
                        phi_1744_ = _e1315;
                        phi_1746_ = _e1316;
                    } else {
                        phi_1741_ = u32();
                        phi_1744_ = u32();
                        phi_1746_ = u32();
                    }
                    let _e1320 = phi_1741_;
                    let _e1322 = phi_1744_;
                    let _e1324 = phi_1746_;
                    continue;
                    continuing {
                        phi_1740_ = _e1320;
                        phi_1743_ = _e1322;
                        phi_1745_ = _e1324;
                        break if !(_e821);
                    }
                }
                let _e1327 = local;
                if _e1327 {
                    let _e1329 = local_1;
                    let _e1330 = (_e1329 & 2147483647u);
                    let _e1332 = (_e1330 >> bitcast<u32>(2i));
                    if (_e1332 >= _e113) {
                        phi_2831_ = SlimbvhTypeN(SlimbvhTypeM(vec4<f32>(0f, 0f, 0f, 0f), 0u), 0u, 0u);
                    } else {
                        let _e1339 = slimbvh_nodes.member[_e1332].member[select(_e707, 2u, (2u < _e707))];
                        let _e1350 = slimbvh_nodes.member[_e1332].member[select(_e708, 2u, (2u < _e708))];
                        let _e1361 = slimbvh_nodes.member[_e1332].member[select(_e709, 2u, (2u < _e709))];
                        let _e1367 = (_e1330 & 3u);
                        let _e1370 = (((8u * _e1367) & 31u) & 31u);
                        let _e1378 = ((_e1339.w & 31u) & 31u);
                        let _e1380 = (((_e1339.y >> bitcast<u32>(_e1370)) & 255u) << bitcast<u32>(_e1378));
                        let _e1394 = ((_e1350.w & 31u) & 31u);
                        let _e1396 = (((_e1350.y >> bitcast<u32>(_e1370)) & 255u) << bitcast<u32>(_e1394));
                        let _e1410 = ((_e1361.w & 31u) & 31u);
                        let _e1412 = (((_e1361.y >> bitcast<u32>(_e1370)) & 255u) << bitcast<u32>(_e1410));
                        let _e1420 = (((((_e1339.w >> bitcast<u32>(5u)) - (((_e1339.z >> bitcast<u32>(_e1370)) & 255u) << bitcast<u32>(_e1378))) - _e1380) | (((_e1350.w >> bitcast<u32>(5u)) - (((_e1350.z >> bitcast<u32>(_e1370)) & 255u) << bitcast<u32>(_e1394))) - _e1396)) | (((_e1361.w >> bitcast<u32>(5u)) - (((_e1361.z >> bitcast<u32>(_e1370)) & 255u) << bitcast<u32>(_e1410))) - _e1412));
                        if (_e1420 < 1024u) {
                            phi_2767_ = 0u;
                        } else {
                            phi_2767_ = select(2u, 1u, (_e1420 < 2097152u));
                        }
                        let _e1425 = phi_2767_;
                        let _e1440 = slimbvh_nodes.member[_e1332].member_1[_e1367];
                        if ((_e1440 & 2147483648u) != 0u) {
                            phi_2828_ = ((_e1440 >> bitcast<u32>(28u)) & 7u);
                        } else {
                            phi_2828_ = 0u;
                        }
                        let _e1447 = phi_2828_;
                        phi_2831_ = SlimbvhTypeN(SlimbvhTypeM(vec4<f32>((bitcast<f32>(_e1339.x) + (f32(_e1380) * _e164)), (bitcast<f32>(_e1350.x) + (f32(_e1396) * _e164)), (bitcast<f32>(_e1361.x) + (f32(_e1412) * _e164)), 0f), _e1425), (_e1440 & 268435455u), _e1447);
                    }
                    let _e1451 = phi_2831_;
                    let _e1453 = (_e1451.member_1 + _e170);
                    phi_2838_ = _e801;
                    phi_2841_ = SlimbvhTypeD(0u, _e1451.member_2);
                    loop {
                        let _e1458 = phi_2838_;
                        let _e1460 = phi_2841_;
                        local_4 = _e1458;
                        local_7 = _e1458;
                        if (_e1460.member < _e1460.member_1) {
                            phi_2842_ = SlimbvhTypeD((_e1460.member + 1u), _e1460.member_1);
                            phi_2864_ = SlimbvhTypeD(1u, _e1460.member);
                        } else {
                            phi_2842_ = _e1460;
                            phi_2864_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                        }
                        let _e1473 = phi_2842_;
                        let _e1475 = phi_2864_;
                        let _e1479 = (bitcast<i32>(_e1475.member) != 0i);
                        if _e1479 {
                            switch bitcast<i32>(_e1451.member.member_1) {
                                case 0: {
                                    phi_2879_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2879_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2879_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2879_ = u32();
                                    break;
                                }
                            }
                            let _e1483 = phi_2879_;
                            switch bitcast<i32>(_e1451.member.member_1) {
                                case 0: {
                                    phi_2890_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2890_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2890_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2890_ = u32();
                                    break;
                                }
                            }
                            let _e1490 = phi_2890_;
                            let _e1492 = ((_e1453 + (_e1475.member_1 * ((3u * _e1483) + 1u))) + (3u * _e1490));
                            if (_e1492 < _e116) {
                                let _e1495 = slimbvh_triangles.member[_e1492];
                                phi_2906_ = _e1495;
                            } else {
                                phi_2906_ = 4294967295u;
                            }
                            let _e1497 = phi_2906_;
                            switch bitcast<i32>(_e1451.member.member_1) {
                                case 0: {
                                    phi_2919_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2919_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2919_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2919_ = u32();
                                    break;
                                }
                            }
                            let _e1500 = phi_2919_;
                            let _e1504 = (_e1453 + (_e1475.member_1 * ((3u * _e1500) + 1u)));
                            switch bitcast<i32>(_e1451.member.member_1) {
                                case 0: {
                                    phi_2930_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2930_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2930_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2930_ = u32();
                                    break;
                                }
                            }
                            let _e1507 = phi_2930_;
                            let _e1508 = (_e1504 + _e1507);
                            let _e1510 = (_e1504 + (2u * _e1507));
                            switch bitcast<i32>(_e1451.member.member_1) {
                                case 0: {
                                    if (_e1504 < _e116) {
                                        let _e1787 = slimbvh_triangles.member[_e1504];
                                        phi_2957_ = _e1787;
                                    } else {
                                        phi_2957_ = 0u;
                                    }
                                    let _e1789 = phi_2957_;
                                    let _e1792 = ((10u * _e230) & 31u);
                                    let _e1803 = ((10u * _e234) & 31u);
                                    let _e1814 = ((10u * _e226) & 31u);
                                    if (_e1508 < _e116) {
                                        let _e1826 = slimbvh_triangles.member[_e1508];
                                        phi_3003_ = _e1826;
                                    } else {
                                        phi_3003_ = 0u;
                                    }
                                    let _e1828 = phi_3003_;
                                    if (_e1510 < _e116) {
                                        let _e1856 = slimbvh_triangles.member[_e1510];
                                        phi_3049_ = _e1856;
                                    } else {
                                        phi_3049_ = 0u;
                                    }
                                    let _e1858 = phi_3049_;
                                    phi_3516_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1451.member.member.x + ((bitcast<f32>((1258291200u | ((_e1789 >> bitcast<u32>(_e1792)) & 1023u))) - 8388608f) * _e164)), (_e1451.member.member.y + ((bitcast<f32>((1258291200u | ((_e1789 >> bitcast<u32>(_e1803)) & 1023u))) - 8388608f) * _e164)), (_e1451.member.member.z + ((bitcast<f32>((1258291200u | ((_e1789 >> bitcast<u32>(_e1814)) & 1023u))) - 8388608f) * _e164))), array<f32, 3>((_e1451.member.member.x + ((bitcast<f32>((1258291200u | ((_e1828 >> bitcast<u32>(_e1792)) & 1023u))) - 8388608f) * _e164)), (_e1451.member.member.y + ((bitcast<f32>((1258291200u | ((_e1828 >> bitcast<u32>(_e1803)) & 1023u))) - 8388608f) * _e164)), (_e1451.member.member.z + ((bitcast<f32>((1258291200u | ((_e1828 >> bitcast<u32>(_e1814)) & 1023u))) - 8388608f) * _e164))), array<f32, 3>((_e1451.member.member.x + ((bitcast<f32>((1258291200u | ((_e1858 >> bitcast<u32>(_e1792)) & 1023u))) - 8388608f) * _e164)), (_e1451.member.member.y + ((bitcast<f32>((1258291200u | ((_e1858 >> bitcast<u32>(_e1803)) & 1023u))) - 8388608f) * _e164)), (_e1451.member.member.z + ((bitcast<f32>((1258291200u | ((_e1858 >> bitcast<u32>(_e1814)) & 1023u))) - 8388608f) * _e164))));
                                    break;
                                }
                                case 1: {
                                    if (_e1504 < _e116) {
                                        let _e1600 = slimbvh_triangles.member[_e1504];
                                        phi_3096_ = _e1600;
                                    } else {
                                        phi_3096_ = 0u;
                                    }
                                    let _e1602 = phi_3096_;
                                    let _e1603 = (_e1504 + 1u);
                                    if (_e1603 < _e116) {
                                        let _e1606 = slimbvh_triangles.member[_e1603];
                                        phi_3109_ = _e1606;
                                    } else {
                                        phi_3109_ = 0u;
                                    }
                                    let _e1608 = phi_3109_;
                                    let _e1610 = (_e230 == 1u);
                                    if _e1610 {
                                        phi_3119_ = ((_e1602 >> bitcast<u32>(21i)) | (_e1608 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3119_ = (_e1608 >> bitcast<u32>(10i));
                                    }
                                    let _e1619 = phi_3119_;
                                    let _e1628 = (_e234 == 1u);
                                    if _e1628 {
                                        phi_3140_ = ((_e1602 >> bitcast<u32>(21i)) | (_e1608 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3140_ = (_e1608 >> bitcast<u32>(10i));
                                    }
                                    let _e1637 = phi_3140_;
                                    let _e1646 = (_e226 == 1u);
                                    if _e1646 {
                                        phi_3161_ = ((_e1602 >> bitcast<u32>(21i)) | (_e1608 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3161_ = (_e1608 >> bitcast<u32>(10i));
                                    }
                                    let _e1655 = phi_3161_;
                                    if (_e1508 < _e116) {
                                        let _e1666 = slimbvh_triangles.member[_e1508];
                                        phi_3188_ = _e1666;
                                    } else {
                                        phi_3188_ = 0u;
                                    }
                                    let _e1668 = phi_3188_;
                                    let _e1669 = (_e1508 + 1u);
                                    if (_e1669 < _e116) {
                                        let _e1672 = slimbvh_triangles.member[_e1669];
                                        phi_3201_ = _e1672;
                                    } else {
                                        phi_3201_ = 0u;
                                    }
                                    let _e1674 = phi_3201_;
                                    if _e1610 {
                                        phi_3211_ = ((_e1668 >> bitcast<u32>(21i)) | (_e1674 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3211_ = (_e1674 >> bitcast<u32>(10i));
                                    }
                                    let _e1683 = phi_3211_;
                                    if _e1628 {
                                        phi_3232_ = ((_e1668 >> bitcast<u32>(21i)) | (_e1674 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3232_ = (_e1674 >> bitcast<u32>(10i));
                                    }
                                    let _e1699 = phi_3232_;
                                    if _e1646 {
                                        phi_3253_ = ((_e1668 >> bitcast<u32>(21i)) | (_e1674 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3253_ = (_e1674 >> bitcast<u32>(10i));
                                    }
                                    let _e1715 = phi_3253_;
                                    if (_e1510 < _e116) {
                                        let _e1726 = slimbvh_triangles.member[_e1510];
                                        phi_3280_ = _e1726;
                                    } else {
                                        phi_3280_ = 0u;
                                    }
                                    let _e1728 = phi_3280_;
                                    let _e1729 = (_e1510 + 1u);
                                    if (_e1729 < _e116) {
                                        let _e1732 = slimbvh_triangles.member[_e1729];
                                        phi_3293_ = _e1732;
                                    } else {
                                        phi_3293_ = 0u;
                                    }
                                    let _e1734 = phi_3293_;
                                    if _e1610 {
                                        phi_3303_ = ((_e1728 >> bitcast<u32>(21i)) | (_e1734 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3303_ = (_e1734 >> bitcast<u32>(10i));
                                    }
                                    let _e1743 = phi_3303_;
                                    if _e1628 {
                                        phi_3324_ = ((_e1728 >> bitcast<u32>(21i)) | (_e1734 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3324_ = (_e1734 >> bitcast<u32>(10i));
                                    }
                                    let _e1759 = phi_3324_;
                                    if _e1646 {
                                        phi_3345_ = ((_e1728 >> bitcast<u32>(21i)) | (_e1734 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3345_ = (_e1734 >> bitcast<u32>(10i));
                                    }
                                    let _e1775 = phi_3345_;
                                    phi_3516_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1451.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1619, _e1602, _e235) & 2097151u))) - 8388608f) * _e164)), (_e1451.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1637, _e1602, _e238) & 2097151u))) - 8388608f) * _e164)), (_e1451.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1655, _e1602, _e242) & 2097151u))) - 8388608f) * _e164))), array<f32, 3>((_e1451.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1683, _e1668, _e235) & 2097151u))) - 8388608f) * _e164)), (_e1451.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1699, _e1668, _e238) & 2097151u))) - 8388608f) * _e164)), (_e1451.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1715, _e1668, _e242) & 2097151u))) - 8388608f) * _e164))), array<f32, 3>((_e1451.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1743, _e1728, _e235) & 2097151u))) - 8388608f) * _e164)), (_e1451.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1759, _e1728, _e238) & 2097151u))) - 8388608f) * _e164)), (_e1451.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1775, _e1728, _e242) & 2097151u))) - 8388608f) * _e164))));
                                    break;
                                }
                                case 2: {
                                    let _e1513 = (_e1504 + _e230);
                                    if (_e1513 < _e116) {
                                        let _e1516 = slimbvh_triangles.member[_e1513];
                                        phi_3374_ = _e1516;
                                    } else {
                                        phi_3374_ = 0u;
                                    }
                                    let _e1518 = phi_3374_;
                                    let _e1519 = (_e1504 + _e234);
                                    if (_e1519 < _e116) {
                                        let _e1522 = slimbvh_triangles.member[_e1519];
                                        phi_3387_ = _e1522;
                                    } else {
                                        phi_3387_ = 0u;
                                    }
                                    let _e1524 = phi_3387_;
                                    let _e1525 = (_e1504 + _e226);
                                    if (_e1525 < _e116) {
                                        let _e1528 = slimbvh_triangles.member[_e1525];
                                        phi_3400_ = _e1528;
                                    } else {
                                        phi_3400_ = 0u;
                                    }
                                    let _e1530 = phi_3400_;
                                    let _e1541 = (_e1508 + _e230);
                                    if (_e1541 < _e116) {
                                        let _e1544 = slimbvh_triangles.member[_e1541];
                                        phi_3426_ = _e1544;
                                    } else {
                                        phi_3426_ = 0u;
                                    }
                                    let _e1546 = phi_3426_;
                                    let _e1547 = (_e1508 + _e234);
                                    if (_e1547 < _e116) {
                                        let _e1550 = slimbvh_triangles.member[_e1547];
                                        phi_3439_ = _e1550;
                                    } else {
                                        phi_3439_ = 0u;
                                    }
                                    let _e1552 = phi_3439_;
                                    let _e1553 = (_e1508 + _e226);
                                    if (_e1553 < _e116) {
                                        let _e1556 = slimbvh_triangles.member[_e1553];
                                        phi_3452_ = _e1556;
                                    } else {
                                        phi_3452_ = 0u;
                                    }
                                    let _e1558 = phi_3452_;
                                    let _e1569 = (_e1510 + _e230);
                                    if (_e1569 < _e116) {
                                        let _e1572 = slimbvh_triangles.member[_e1569];
                                        phi_3478_ = _e1572;
                                    } else {
                                        phi_3478_ = 0u;
                                    }
                                    let _e1574 = phi_3478_;
                                    let _e1575 = (_e1510 + _e234);
                                    if (_e1575 < _e116) {
                                        let _e1578 = slimbvh_triangles.member[_e1575];
                                        phi_3491_ = _e1578;
                                    } else {
                                        phi_3491_ = 0u;
                                    }
                                    let _e1580 = phi_3491_;
                                    let _e1581 = (_e1510 + _e226);
                                    if (_e1581 < _e116) {
                                        let _e1584 = slimbvh_triangles.member[_e1581];
                                        phi_3504_ = _e1584;
                                    } else {
                                        phi_3504_ = 0u;
                                    }
                                    let _e1586 = phi_3504_;
                                    phi_3516_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1518)) * _e164), (f32(bitcast<i32>(_e1524)) * _e164), (f32(bitcast<i32>(_e1530)) * _e164)), array<f32, 3>((f32(bitcast<i32>(_e1546)) * _e164), (f32(bitcast<i32>(_e1552)) * _e164), (f32(bitcast<i32>(_e1558)) * _e164)), array<f32, 3>((f32(bitcast<i32>(_e1574)) * _e164), (f32(bitcast<i32>(_e1580)) * _e164), (f32(bitcast<i32>(_e1586)) * _e164)));
                                    break;
                                }
                                default: {
                                    phi_3516_ = array<array<f32, 3>, 3>();
                                    break;
                                }
                            }
                            let _e1886 = phi_3516_;
                            let _e1903 = (_e1886[0][2] - _e618.member[2]);
                            let _e1906 = (((_e1886[0][0] - _e618.member[0]) * _e673) - (_e1903 * _e641));
                            let _e1909 = (((_e1886[0][1] - _e618.member[1]) * _e673) - (_e1903 * _e657));
                            let _e1912 = (_e1886[1][2] - _e618.member[2]);
                            let _e1915 = (((_e1886[1][0] - _e618.member[0]) * _e673) - (_e1912 * _e641));
                            let _e1918 = (((_e1886[1][1] - _e618.member[1]) * _e673) - (_e1912 * _e657));
                            let _e1921 = (_e1886[2][2] - _e618.member[2]);
                            let _e1924 = (((_e1886[2][0] - _e618.member[0]) * _e673) - (_e1921 * _e641));
                            let _e1927 = (((_e1886[2][1] - _e618.member[1]) * _e673) - (_e1921 * _e657));
                            let _e1928 = (_e1924 * _e1918);
                            let _e1929 = (_e1927 * _e1915);
                            let _e1930 = (_e1906 * _e1927);
                            let _e1931 = (_e1909 * _e1924);
                            let _e1932 = (_e1915 * _e1909);
                            let _e1933 = (_e1918 * _e1906);
                            let _e1938 = (((_e1928 >= _e1929) && (_e1930 >= _e1931)) && (_e1932 >= _e1933));
                            let _e1944 = (_e1938 || (((_e1928 <= _e1929) && (_e1930 <= _e1931)) && (_e1932 <= _e1933)));
                            if _e1944 {
                                let _e1946 = select(-1f, 1f, _e1938);
                                let _e1948 = ((_e1928 - _e1929) * _e1946);
                                let _e1950 = select(0f, _e1948, (_e1948 > 0f));
                                let _e1952 = ((_e1930 - _e1931) * _e1946);
                                let _e1954 = select(0f, _e1952, (_e1952 > 0f));
                                let _e1956 = ((_e1932 - _e1933) * _e1946);
                                let _e1958 = select(0f, _e1956, (_e1956 > 0f));
                                let _e1960 = ((_e1950 + _e1954) + _e1958);
                                let _e1975 = ((min(min(_e1886[0][0], _e1886[1][0]), _e1886[2][0]) - _e642) * _e645);
                                let _e1976 = ((max(max(_e1886[0][0], _e1886[1][0]), _e1886[2][0]) - _e643) * _e645);
                                let _e1977 = vec4<f32>(_e1975, f32(), _e1976, f32());
                                let _e1980 = ((min(min(_e1886[0][1], _e1886[1][1]), _e1886[2][1]) - _e658) * _e661);
                                let _e1981 = ((max(max(_e1886[0][1], _e1886[1][1]), _e1886[2][1]) - _e659) * _e661);
                                let _e1982 = vec4<f32>(_e1980, f32(), _e1981, f32());
                                let _e1985 = ((min(min(_e1886[0][2], _e1886[1][2]), _e1886[2][2]) - _e674) * _e677);
                                let _e1986 = ((max(max(_e1886[0][2], _e1886[1][2]), _e1886[2][2]) - _e675) * _e677);
                                let _e1987 = vec4<f32>(_e1985, f32(), _e1986, f32());
                                let _e1988 = vec4<f32>(_e1976, f32(), _e1975, f32());
                                let _e1990 = vec4<f32>(_e1981, f32(), _e1980, f32());
                                let _e1992 = vec4<f32>(_e1986, f32(), _e1985, f32());
                                let _e2001 = max(max(min(_e1977, _e1988).x, min(_e1982, _e1990).x), min(_e1987, _e1992).x);
                                let _e2006 = min(min(max(_e1977, _e1988).x, max(_e1982, _e1990).x), max(_e1987, _e1992).x);
                                let _e2011 = max(_e2001, _e685);
                                let _e2033 = (((((_e1944 && (_e1960 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1906, _e1915), _e1924) <= 0f) && (max(max(_e1906, _e1915), _e1924) >= 0f))) && ((min(min(_e1909, _e1918), _e1927) <= 0f) && (max(max(_e1909, _e1918), _e1927) >= 0f))) && (_e2011 <= (_e2006 + (max(max(_e1987, _e1992).x, -(min(_e1987, _e1992).x)) * 0.0000019073523f)))) && (_e2011 <= _e1458.member.member_1));
                                if _e2033 {
                                    let _e2038 = (_e1886[1][0] - _e1886[0][0]);
                                    let _e2039 = (_e1886[1][1] - _e1886[0][1]);
                                    let _e2040 = (_e1886[1][2] - _e1886[0][2]);
                                    let _e2041 = vec3<f32>(_e2038, _e2039, _e2040);
                                    let _e2042 = (_e1886[2][0] - _e1886[1][0]);
                                    let _e2043 = (_e1886[2][1] - _e1886[1][1]);
                                    let _e2044 = (_e1886[2][2] - _e1886[1][2]);
                                    let _e2045 = vec3<f32>(_e2042, _e2043, _e2044);
                                    let _e2046 = (_e1886[0][0] - _e1886[2][0]);
                                    let _e2047 = (_e1886[0][1] - _e1886[2][1]);
                                    let _e2048 = (_e1886[0][2] - _e1886[2][2]);
                                    let _e2049 = vec3<f32>(_e2046, _e2047, _e2048);
                                    let _e2060 = max(max(bitcast<f32>((bitcast<u32>(_e2038) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2039) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2040) & 2147483647u)));
                                    let _e2071 = max(max(bitcast<f32>((bitcast<u32>(_e2042) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2043) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2044) & 2147483647u)));
                                    let _e2084 = max(max(_e2060, _e2071), max(max(bitcast<f32>((bitcast<u32>(_e2046) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2047) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2048) & 2147483647u))));
                                    if (_e2060 == _e2084) {
                                        phi_3881_ = _e1918;
                                        phi_3882_ = _e1915;
                                        phi_3883_ = _e1909;
                                        phi_3884_ = _e1906;
                                        phi_3885_ = vec3<f32>(_e1886[0][0], _e1886[0][1], _e1886[0][2]);
                                        phi_3886_ = _e2049;
                                        phi_3887_ = _e2045;
                                        phi_3888_ = _e2041;
                                    } else {
                                        let _e2086 = (_e2071 == _e2084);
                                        let _e2091 = vec3(_e2086);
                                        phi_3881_ = select(_e1909, _e1927, _e2086);
                                        phi_3882_ = select(_e1906, _e1924, _e2086);
                                        phi_3883_ = select(_e1927, _e1918, _e2086);
                                        phi_3884_ = select(_e1924, _e1915, _e2086);
                                        phi_3885_ = select(vec3<f32>(_e1886[2][0], _e1886[2][1], _e1886[2][2]), vec3<f32>(_e1886[1][0], _e1886[1][1], _e1886[1][2]), _e2091);
                                        phi_3886_ = select(_e2045, _e2041, _e2091);
                                        phi_3887_ = select(_e2041, _e2049, _e2091);
                                        phi_3888_ = select(_e2049, _e2045, _e2091);
                                    }
                                    let _e2097 = phi_3881_;
                                    let _e2099 = phi_3882_;
                                    let _e2101 = phi_3883_;
                                    let _e2103 = phi_3884_;
                                    let _e2105 = phi_3885_;
                                    let _e2107 = phi_3886_;
                                    let _e2109 = phi_3887_;
                                    let _e2111 = phi_3888_;
                                    let _e2118 = ((_e2109.y * _e2107.z) - (_e2107.y * _e2109.z));
                                    let _e2123 = ((_e2109.z * _e2107.x) - (_e2107.z * _e2109.x));
                                    let _e2126 = ((_e2109.x * _e2107.y) - (_e2107.x * _e2109.y));
                                    let _e2129 = ((_e1950 >= _e1954) && (_e1950 >= _e1958));
                                    let _e2130 = (_e1954 >= _e1958);
                                    let _e2144 = (((_e2118 * (select(select(_e1886[2][0], _e1886[1][0], _e2130), _e1886[0][0], _e2129) - _e618.member[0])) + (_e2123 * (select(select(_e1886[2][1], _e1886[1][1], _e2130), _e1886[0][1], _e2129) - _e618.member[1]))) + (_e2126 * (select(select(_e1886[2][2], _e1886[1][2], _e2130), _e1886[0][2], _e2129) - _e618.member[2])));
                                    let _e2149 = (((_e2118 * _e641) + (_e2123 * _e657)) + (_e2126 * _e673));
                                    let _e2150 = (_e2099 - _e2103);
                                    let _e2151 = (_e2097 - _e2101);
                                    let _e2154 = ((_e2150 * _e2150) + (_e2151 * _e2151));
                                    let _e2161 = (-(((_e2103 * _e2150) + (_e2101 * _e2151))) / select(0.000000000000000000000000000000000000011754944f, _e2154, (_e2154 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e2163 = select(1f, _e2161, (_e2161 < 1f));
                                    let _e2165 = select(0f, _e2163, (_e2163 > 0f));
                                    let _e2174 = ((_e2105.x + (_e2111.x * _e2165)) - _e618.member[0]);
                                    let _e2177 = ((_e2105.y + (_e2111.y * _e2165)) - _e618.member[1]);
                                    let _e2180 = ((_e2105.z + (_e2111.z * _e2165)) - _e618.member[2]);
                                    let _e2245 = ((bitcast<f32>((bitcast<u32>(((((_e2118 * _e2174) + (_e2123 * _e2177)) + (_e2126 * _e2180)) - _e2144)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e2174) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2177) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2180) & 2147483647u))), _e2084)) * max(max(bitcast<f32>((bitcast<u32>(_e2118) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2123) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2126) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e2149) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e2109.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2109.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2109.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e2107.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2107.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2107.z) & 2147483647u)))))));
                                    let _e2246 = (_e2144 / _e2149);
                                    if (_e2033 && !(_e2245)) {
                                        let _e2249 = (_e2180 / _e673);
                                        let _e2257 = (((_e2118 * (_e2174 - (_e641 * _e2249))) + (_e2123 * (_e2177 - (_e657 * _e2249)))) / _e2149);
                                        phi_4067_ = select(select(_e2249, (_e2249 + _e2257), (bitcast<f32>((bitcast<u32>(_e2257) & 2147483647u)) <= _e2084)), _e2246, _e2245);
                                    } else {
                                        phi_4067_ = _e2246;
                                    }
                                    let _e2266 = phi_4067_;
                                    let _e2268 = select(_e2006, _e2266, (_e2266 < _e2006));
                                    let _e2270 = select(_e2001, _e2268, (_e2268 > _e2001));
                                    let _e2273 = select(_e2270, 0f, (bitcast<u32>(_e2270) == 2147483648u));
                                    let _e2274 = (1f / _e1960);
                                    phi_4093_ = SlimbvhTypeE(_e2273, (_e1954 * _e2274), (_e1958 * _e2274), ((_e2033 && (_e2273 >= _e685)) && (_e2273 <= _e1458.member.member_1)));
                                    phi_4094_ = SlimbvhTypeE();
                                } else {
                                    phi_4093_ = SlimbvhTypeE();
                                    phi_4094_ = SlimbvhTypeE(0f, 0f, 0f, _e2033);
                                }
                                let _e2283 = phi_4093_;
                                let _e2285 = phi_4094_;
                                phi_4097_ = _e2283;
                                phi_4098_ = _e2285;
                                phi_4099_ = select(true, false, _e2033);
                            } else {
                                phi_4097_ = SlimbvhTypeE();
                                phi_4098_ = SlimbvhTypeE(0f, 0f, 0f, _e1944);
                                phi_4099_ = true;
                            }
                            let _e2288 = phi_4097_;
                            let _e2290 = phi_4098_;
                            let _e2292 = phi_4099_;
                            if _e2292 {
                                phi_4103_ = _e2290;
                            } else {
                                phi_4103_ = _e2288;
                            }
                            let _e2294 = phi_4103_;
                            if _e2294.member_3 {
                                phi_4112_ = SlimbvhTypeF(_e2294.member, _e2294.member_1, _e2294.member_2, _e1497);
                            } else {
                                phi_4112_ = _e109;
                            }
                            let _e2301 = phi_4112_;
                            if (_e2301.member_3 != 4294967295u) {
                                let _e2307 = slimbvh_target.member[0u][0u];
                                let _e2311 = slimbvh_target.member[0u][1u];
                                let _e2315 = slimbvh_target.member[0u][2u];
                                let _e2319 = slimbvh_target.member[0u][3u];
                                let _e2323 = slimbvh_target.member[1u][0u];
                                let _e2327 = slimbvh_target.member[1u][1u];
                                let _e2331 = slimbvh_target.member[1u][2u];
                                let _e2335 = slimbvh_target.member[1u][3u];
                                let _e2336 = bitcast<f32>(_e2307);
                                let _e2337 = bitcast<f32>(_e2311);
                                let _e2338 = bitcast<f32>(_e2315);
                                let _e2340 = bitcast<f32>(_e2323);
                                let _e2341 = array<u32, 3>(_e2327, _e2331, _e2335);
                                if (_e188 < -126i) {
                                    phi_4165_ = -126i;
                                } else {
                                    phi_4165_ = select(_e188, 127i, (_e188 > 127i));
                                }
                                let _e2347 = phi_4165_;
                                let _e2352 = bitcast<f32>((bitcast<u32>((_e2347 + 127i)) << bitcast<u32>(23i)));
                                let _e2358 = bitcast<f32>((bitcast<u32>(((_e188 - _e2347) + 127i)) << bitcast<u32>(23i)));
                                if (_e2319 == 0u) {
                                    phi_4305_ = SlimbvhTypeH(array<f32, 3>(_e2336, _e2337, _e2338), _e2319, _e2340, _e2341);
                                } else {
                                    let _e2360 = bitcast<u32>(_e2336);
                                    let _e2362 = ((_e2360 & 2139095040u) != 0u);
                                    let _e2377 = bitcast<u32>(_e2337);
                                    let _e2379 = ((_e2377 & 2139095040u) != 0u);
                                    let _e2394 = bitcast<u32>(_e2338);
                                    let _e2396 = ((_e2394 & 2139095040u) != 0u);
                                    let _e2412 = bitcast<u32>(_e2340);
                                    let _e2414 = ((_e2412 & 2139095040u) != 0u);
                                    phi_4305_ = SlimbvhTypeH(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2360 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2360 & 2147483648u))), _e2336, _e2362) * _e2352) * select(0.00000011920929f, 1f, _e2362)) * _e2358), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2377 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2377 & 2147483648u))), _e2337, _e2379) * _e2352) * select(0.00000011920929f, 1f, _e2379)) * _e2358), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2394 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2394 & 2147483648u))), _e2338, _e2396) * _e2352) * select(0.00000011920929f, 1f, _e2396)) * _e2358)), _e2319, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2412 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2412 & 2147483648u))), _e2340, _e2414) * _e2352) * select(0.00000011920929f, 1f, _e2414)) * _e2358), _e2341);
                                }
                                let _e2431 = phi_4305_;
                                if (_e1497 == _e689) {
                                    phi_4634_ = false;
                                } else {
                                    let _e2433 = (_e1497 / 16u);
                                    if (_e2433 < arrayLength((&slimbvh_sides.member))) {
                                        let _e2436 = slimbvh_sides.member[_e2433];
                                        phi_4329_ = _e2436;
                                    } else {
                                        phi_4329_ = 0u;
                                    }
                                    let _e2438 = phi_4329_;
                                    let _e2447 = (bitcast<i32>((_e2438 << bitcast<u32>(((30u - ((_e1497 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                    let _e2448 = (_e2447 == 0i);
                                    if _e2448 {
                                        phi_4633_ = true;
                                    } else {
                                        if _e235 {
                                            phi_4359_ = vec3<f32>(_e1886[0][0], _e1886[0][1], _e1886[0][2]);
                                        } else {
                                            if (_e230 == 1u) {
                                                phi_4358_ = vec3<f32>(_e1886[0][2], _e1886[0][0], _e1886[0][1]);
                                            } else {
                                                phi_4358_ = vec3<f32>(_e1886[0][1], _e1886[0][2], _e1886[0][0]);
                                            }
                                            let _e2453 = phi_4358_;
                                            phi_4359_ = _e2453;
                                        }
                                        let _e2456 = phi_4359_;
                                        if _e235 {
                                            phi_4378_ = vec3<f32>(_e1886[1][0], _e1886[1][1], _e1886[1][2]);
                                        } else {
                                            if (_e230 == 1u) {
                                                phi_4377_ = vec3<f32>(_e1886[1][2], _e1886[1][0], _e1886[1][1]);
                                            } else {
                                                phi_4377_ = vec3<f32>(_e1886[1][1], _e1886[1][2], _e1886[1][0]);
                                            }
                                            let _e2461 = phi_4377_;
                                            phi_4378_ = _e2461;
                                        }
                                        let _e2464 = phi_4378_;
                                        if _e235 {
                                            phi_4397_ = vec3<f32>(_e1886[2][0], _e1886[2][1], _e1886[2][2]);
                                        } else {
                                            if (_e230 == 1u) {
                                                phi_4396_ = vec3<f32>(_e1886[2][2], _e1886[2][0], _e1886[2][1]);
                                            } else {
                                                phi_4396_ = vec3<f32>(_e1886[2][1], _e1886[2][2], _e1886[2][0]);
                                            }
                                            let _e2469 = phi_4396_;
                                            phi_4397_ = _e2469;
                                        }
                                        let _e2472 = phi_4397_;
                                        let _e2475 = (_e2464.x - _e2456.x);
                                        let _e2478 = (_e2464.y - _e2456.y);
                                        let _e2481 = (_e2464.z - _e2456.z);
                                        let _e2483 = (_e2472.x - _e2456.x);
                                        let _e2485 = (_e2472.y - _e2456.y);
                                        let _e2487 = (_e2472.z - _e2456.z);
                                        if (_e2431.member_1 == 1u) {
                                            phi_4433_ = (vec3<f32>(_e2431.member[0], _e2431.member[1], _e2431.member[2]) - _e2456);
                                        } else {
                                            phi_4433_ = vec3<f32>(_e2431.member[0], _e2431.member[1], _e2431.member[2]);
                                        }
                                        let _e2502 = phi_4433_;
                                        let _e2508 = bitcast<f32>((bitcast<u32>((_e2475 * _e2485)) ^ _e2431.member_3[0]));
                                        let _e2512 = bitcast<f32>((bitcast<u32>((_e2478 * _e2483)) ^ _e2431.member_3[0]));
                                        let _e2516 = bitcast<f32>((bitcast<u32>((_e2478 * _e2487)) ^ _e2431.member_3[0]));
                                        let _e2520 = bitcast<f32>((bitcast<u32>((_e2481 * _e2485)) ^ _e2431.member_3[0]));
                                        let _e2524 = bitcast<f32>((bitcast<u32>((_e2481 * _e2483)) ^ _e2431.member_3[0]));
                                        let _e2528 = bitcast<f32>((bitcast<u32>((_e2475 * _e2487)) ^ _e2431.member_3[0]));
                                        let _e2529 = (_e2516 - _e2520);
                                        let _e2530 = (_e2524 - _e2528);
                                        let _e2531 = (_e2508 - _e2512);
                                        let _e2555 = (bitcast<f32>((bitcast<u32>(_e2516) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2520) & 2147483647u)));
                                        let _e2562 = (bitcast<f32>((bitcast<u32>(_e2524) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2528) & 2147483647u)));
                                        let _e2569 = (bitcast<f32>((bitcast<u32>(_e2508) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2512) & 2147483647u)));
                                        if (_e2431.member_2 == 0f) {
                                            phi_4615_ = 0f;
                                        } else {
                                            let _e2599 = bitcast<f32>((bitcast<u32>(_e2529) & 2147483647u));
                                            let _e2602 = bitcast<f32>((bitcast<u32>(_e2530) & 2147483647u));
                                            let _e2605 = bitcast<f32>((bitcast<u32>(_e2531) & 2147483647u));
                                            let _e2607 = select(_e2605, _e2602, (_e2602 > _e2605));
                                            let _e2611 = select(_e2605, _e2602, (_e2602 < _e2605));
                                            let _e2615 = select(_e2602, _e2599, (_e2599 < _e2602));
                                            let _e2617 = select(_e2602, _e2599, (_e2599 > _e2602));
                                            let _e2619 = select(_e2605, _e2617, (_e2617 < _e2605));
                                            phi_4615_ = bitcast<f32>((bitcast<u32>((_e2431.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2607, _e2599, (_e2599 > _e2607)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2619, _e2615, (_e2615 > _e2619)))) ^ _e2431.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2611, _e2599, (_e2599 < _e2611)))) ^ _e2431.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2555 + _e2562) + _e2569))) ^ _e2431.member_3[0]))) * 1.0000005f)) ^ _e2431.member_3[0])))) ^ _e2431.member_3[0]));
                                        }
                                        let _e2646 = phi_4615_;
                                        phi_4633_ = (_e2448 || !(((((bitcast<f32>((bitcast<u32>((_e2502.x * _e2529)) ^ _e2431.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2502.y * _e2530)) ^ _e2431.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2502.z * _e2531)) ^ _e2431.member_3[0]))) * f32(-(_e2447))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2502.x) & 2147483647u)) * _e2555)) ^ _e2431.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2502.y) & 2147483647u)) * _e2562)) ^ _e2431.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2502.z) & 2147483647u)) * _e2569)) ^ _e2431.member_3[0]))))) ^ _e2431.member_3[0])) + _e2646) + 0.0000000000000000000000000000000000001880791f))));
                                    }
                                    let _e2660 = phi_4633_;
                                    phi_4634_ = _e2660;
                                }
                                let _e2662 = phi_4634_;
                                if _e2662 {
                                    if (_e2301.member < _e1458.member.member.member) {
                                        phi_4654_ = true;
                                    } else {
                                        if (_e2301.member == _e1458.member.member.member) {
                                            phi_4653_ = (_e2301.member_3 < _e1458.member.member.member_3);
                                        } else {
                                            phi_4653_ = false;
                                        }
                                        let _e2674 = phi_4653_;
                                        phi_4654_ = _e2674;
                                    }
                                    let _e2676 = phi_4654_;
                                    if _e2676 {
                                        phi_4661_ = SlimbvhTypeQ(SlimbvhTypeI(_e2301, _e2301.member), _e1458.member_1);
                                    } else {
                                        phi_4661_ = _e1458;
                                    }
                                    let _e2682 = phi_4661_;
                                    if _e2682.member_1 {
                                        phi_4667_ = SlimbvhTypeQ(SlimbvhTypeI(_e2682.member.member, bitcast<f32>(4286578687u)), _e2682.member_1);
                                    } else {
                                        phi_4667_ = _e2682;
                                    }
                                    let _e2691 = phi_4667_;
                                    phi_4668_ = _e2691;
                                } else {
                                    phi_4668_ = _e1458;
                                }
                                let _e2693 = phi_4668_;
                                phi_4669_ = _e2693;
                            } else {
                                phi_4669_ = _e1458;
                            }
                            let _e2695 = phi_4669_;
                            phi_2839_ = _e2695;
                        } else {
                            phi_2839_ = SlimbvhTypeQ();
                        }
                        let _e2697 = phi_2839_;
                        continue;
                        continuing {
                            phi_2838_ = _e2697;
                            phi_2841_ = _e1473;
                            break if !(_e1479);
                        }
                    }
                    let _e2700 = local_2;
                    let _e2701 = (_e2700 - 1u);
                    let _e2706 = slimbvh_stacks[(((_e2701 % 32u) * 64u) + _e692)];
                    let _e2707 = (_e2706 & 511u);
                    let _e2709 = (_e2707 >> bitcast<u32>(3u));
                    let _e2712 = ((_e2709 == 0u) || (_e2701 == 4294967295u));
                    if _e2712 {
                    } else {
                        slimbvh_stacks[(((_e2701 % 32u) * 64u) + _e692)] = (((_e2706 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2709);
                    }
                    let _e2719 = local_3;
                    let _e2727 = (((_e2706 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2707 & 3u) & 3u));
                    let _e2729 = (_e2727 >> bitcast<u32>(2i));
                    if (_e2729 < _e113) {
                        let _e2735 = slimbvh_nodes.member[_e2729].member_1[(_e2727 & 3u)];
                        if ((_e2735 & 2147483648u) != 0u) {
                            phi_4736_ = (2147483648u | _e2727);
                        } else {
                            phi_4736_ = _e2735;
                        }
                        let _e2740 = phi_4736_;
                        phi_4737_ = _e2740;
                    } else {
                        phi_4737_ = 4294967295u;
                    }
                    let _e2742 = phi_4737_;
                    let _e2744 = local_4;
                    let _e3056 = local_7;
                    phi_4746_ = _e3056;
                    phi_4747_ = select(select(_e2719, _e2701, _e2712), 4294967295u, (_e685 > _e2744.member.member_1));
                    phi_4748_ = _e2742;
                } else {
                    phi_4746_ = _e801;
                    let _e3059 = local_8;
                    phi_4747_ = _e3059;
                    let _e3062 = local_9;
                    phi_4748_ = _e3062;
                }
                let _e2750 = phi_4746_;
                let _e2752 = phi_4747_;
                let _e2754 = phi_4748_;
                phi_1725_ = _e2750;
                phi_1728_ = _e2752;
                phi_1730_ = _e2754;
                let _e3068 = local_10;
                phi_1732_ = _e3068;
            } else {
                phi_1725_ = SlimbvhTypeQ();
                phi_1728_ = u32();
                phi_1730_ = u32();
                phi_1732_ = u32();
            }
            let _e2756 = phi_1725_;
            let _e2758 = phi_1728_;
            let _e2760 = phi_1730_;
            let _e2762 = phi_1732_;
            continue;
            continuing {
                phi_1724_ = _e2756;
                phi_1727_ = _e2758;
                phi_1729_ = _e2760;
                phi_1731_ = _e2762;
                break if !(_e808);
            }
        }
        let _e2765 = local_5;
        let _e2766 = (_e2765 == 4294967295u);
        let _e2768 = local_6;
        if (_e2768.member.member.member_3 != 4294967295u) {
            let _e2774 = -((_e188 + _e618.member_4));
            let _e2775 = bitcast<u32>(_e2768.member.member.member);
            let _e2779 = (bitcast<i32>((_e2775 >> bitcast<u32>(23i))) & 255i);
            let _e2780 = (_e2779 + _e2774);
            if (_e2779 == 255i) {
                phi_4806_ = _e2768.member.member.member;
            } else {
                if (_e2779 > 0i) {
                    if (_e2780 > 0i) {
                        let _e2784 = (_e2780 < 255i);
                        if _e2784 {
                            phi_4785_ = bitcast<f32>((_e2775 + bitcast<u32>((_e2774 << bitcast<u32>(23i)))));
                        } else {
                            phi_4785_ = f32();
                        }
                        let _e2791 = phi_4785_;
                        phi_4787_ = _e2791;
                        phi_4788_ = select(true, false, _e2784);
                    } else {
                        phi_4787_ = f32();
                        phi_4788_ = true;
                    }
                    let _e2794 = phi_4787_;
                    let _e2796 = phi_4788_;
                    phi_4789_ = _e2794;
                    phi_4790_ = _e2796;
                } else {
                    phi_4789_ = f32();
                    phi_4790_ = true;
                }
                let _e2798 = phi_4789_;
                let _e2800 = phi_4790_;
                if _e2800 {
                    let _e2801 = (_e2775 & 2147483648u);
                    let _e2808 = ((_e2775 & 8388607u) | (select(0u, 1u, ((_e2775 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e2812 = (_e2808 == 0u);
                    if _e2812 {
                        phi_5488_ = bitcast<f32>(_e2801);
                    } else {
                        let _e2817 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2808)), 32u, _e2812) - 8u);
                        let _e2820 = (_e2808 << bitcast<u32>((_e2817 & 31u)));
                        let _e2822 = ((_e2780 + select(0i, 1i, (_e2779 == 0i))) - bitcast<i32>(_e2817));
                        if (_e2822 >= 255i) {
                            phi_5478_ = bitcast<f32>((_e2801 | 2139095040u));
                            phi_5479_ = f32();
                            phi_5480_ = true;
                        } else {
                            let _e2824 = (_e2822 > 0i);
                            if _e2824 {
                                phi_5472_ = bitcast<f32>(((_e2801 | (bitcast<u32>(_e2822) << bitcast<u32>(23i))) | (_e2820 & 8388607u)));
                                phi_5473_ = f32();
                            } else {
                                if (_e2822 < -24i) {
                                    phi_5438_ = 26u;
                                } else {
                                    phi_5438_ = bitcast<u32>((1i - _e2822));
                                }
                                let _e2829 = phi_5438_;
                                let _e2830 = (_e2829 & 31u);
                                let _e2832 = (_e2820 >> bitcast<u32>(_e2830));
                                let _e2836 = (_e2820 & ((1u << bitcast<u32>(_e2830)) - 1u));
                                let _e2840 = (1u << bitcast<u32>(((_e2829 - 1u) & 31u)));
                                if (_e2836 > _e2840) {
                                    phi_5459_ = true;
                                } else {
                                    if (_e2836 == _e2840) {
                                        phi_5456_ = ((_e2832 & 1u) == 1u);
                                    } else {
                                        phi_5456_ = false;
                                    }
                                    let _e2846 = phi_5456_;
                                    phi_5459_ = _e2846;
                                }
                                let _e2848 = phi_5459_;
                                phi_5472_ = f32();
                                phi_5473_ = bitcast<f32>((_e2801 | (_e2832 + select(0u, 1u, _e2848))));
                            }
                            let _e2861 = phi_5472_;
                            let _e2863 = phi_5473_;
                            phi_5478_ = _e2861;
                            phi_5479_ = _e2863;
                            phi_5480_ = _e2824;
                        }
                        let _e2867 = phi_5478_;
                        let _e2869 = phi_5479_;
                        let _e2871 = phi_5480_;
                        phi_5488_ = select(_e2869, _e2867, _e2871);
                    }
                    let _e2875 = phi_5488_;
                    phi_4805_ = _e2875;
                } else {
                    phi_4805_ = _e2798;
                }
                let _e2877 = phi_4805_;
                phi_4806_ = _e2877;
            }
            let _e2879 = phi_4806_;
            let _e2880 = bitcast<u32>(_e2879);
            if ((_e2880 & 2147483647u) >= 2139095040u) {
                phi_4818_ = bitcast<f32>(((_e2880 & 2147483648u) | 2139095039u));
            } else {
                phi_4818_ = _e2879;
            }
            let _e2887 = phi_4818_;
            phi_4823_ = SlimbvhTypeF(_e2887, _e2768.member.member.member_1, _e2768.member.member.member_2, _e2768.member.member.member_3);
        } else {
            phi_4823_ = _e109;
        }
        let _e2892 = phi_4823_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2892.member), bitcast<u32>(_e2892.member_1), bitcast<u32>(_e2892.member_2), _e2892.member_3);
        phi_4836_ = _e2766;
        phi_4837_ = _e2766;
        phi_4838_ = select(true, false, _e2766);
    } else {
        phi_4836_ = bool();
        phi_4837_ = false;
        phi_4838_ = true;
    }
    let _e2903 = phi_4836_;
    let _e2905 = phi_4837_;
    let _e2907 = phi_4838_;
    if _e2907 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e2903, _e2905, _e2907)));
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
