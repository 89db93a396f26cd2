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
    var phi_592_: u32;
    var phi_598_: u32;
    var phi_604_: u32;
    var phi_869_: i32;
    var phi_880_: i32;
    var phi_994_: i32;
    var phi_1123_: i32;
    var phi_1145_: u32;
    var phi_1146_: u32;
    var phi_1147_: bool;
    var phi_1181_: i32;
    var phi_1203_: u32;
    var phi_1204_: u32;
    var phi_1205_: bool;
    var phi_766_: i32;
    var phi_772_: u32;
    var phi_791_: u32;
    var phi_792_: u32;
    var phi_793_: bool;
    var phi_811_: i32;
    var phi_817_: u32;
    var phi_836_: u32;
    var phi_837_: u32;
    var phi_838_: bool;
    var phi_1215_: SlimbvhTypeC;
    var phi_1461_: SlimbvhTypeQ;
    var phi_1524_: array<f32, 3>;
    var phi_1525_: array<f32, 3>;
    var phi_1543_: array<f32, 3>;
    var phi_1544_: array<f32, 3>;
    var phi_1717_: SlimbvhTypeQ;
    var phi_1720_: u32;
    var phi_1722_: u32;
    var phi_1724_: u32;
    var phi_1733_: u32;
    var phi_1736_: u32;
    var phi_1738_: u32;
    var phi_1840_: SlimbvhTypeL;
    var phi_1841_: SlimbvhTypeL;
    var phi_1900_: SlimbvhTypeL;
    var phi_1901_: SlimbvhTypeL;
    var phi_1960_: SlimbvhTypeL;
    var phi_1961_: SlimbvhTypeL;
    var phi_2445_: u32;
    var phi_2458_: u32;
    var phi_2471_: u32;
    var phi_2484_: u32;
    var phi_5147_: SlimbvhTypeD;
    var phi_5159_: SlimbvhTypeD;
    var phi_5171_: SlimbvhTypeD;
    var phi_5183_: SlimbvhTypeD;
    var phi_5195_: SlimbvhTypeD;
    var phi_2568_: u32;
    var phi_2573_: u32;
    var phi_2574_: u32;
    var phi_2604_: u32;
    var phi_2605_: u32;
    var phi_1734_: u32;
    var phi_1737_: u32;
    var phi_1739_: u32;
    var local: bool;
    var local_1: u32;
    var phi_2755_: u32;
    var phi_2816_: u32;
    var phi_2819_: SlimbvhTypeN;
    var phi_2823_: SlimbvhTypeQ;
    var phi_2826_: SlimbvhTypeD;
    var phi_2827_: SlimbvhTypeD;
    var phi_2849_: SlimbvhTypeD;
    var phi_2867_: u32;
    var phi_2878_: u32;
    var phi_2894_: u32;
    var phi_2907_: u32;
    var phi_2918_: u32;
    var phi_3362_: u32;
    var phi_3375_: u32;
    var phi_3388_: u32;
    var phi_3414_: u32;
    var phi_3427_: u32;
    var phi_3440_: u32;
    var phi_3466_: u32;
    var phi_3479_: u32;
    var phi_3492_: u32;
    var phi_3084_: u32;
    var phi_3097_: u32;
    var phi_3107_: u32;
    var phi_3128_: u32;
    var phi_3149_: u32;
    var phi_3176_: u32;
    var phi_3189_: u32;
    var phi_3199_: u32;
    var phi_3220_: u32;
    var phi_3241_: u32;
    var phi_3268_: u32;
    var phi_3281_: u32;
    var phi_3291_: u32;
    var phi_3312_: u32;
    var phi_3333_: u32;
    var phi_2945_: u32;
    var phi_2991_: u32;
    var phi_3037_: u32;
    var phi_3504_: array<array<f32, 3>, 3>;
    var phi_3869_: f32;
    var phi_3870_: f32;
    var phi_3871_: f32;
    var phi_3872_: f32;
    var phi_3873_: vec3<f32>;
    var phi_3874_: vec3<f32>;
    var phi_3875_: vec3<f32>;
    var phi_3876_: vec3<f32>;
    var phi_4055_: f32;
    var phi_4081_: SlimbvhTypeE;
    var phi_4082_: SlimbvhTypeE;
    var phi_4085_: SlimbvhTypeE;
    var phi_4086_: SlimbvhTypeE;
    var phi_4087_: bool;
    var phi_4091_: SlimbvhTypeE;
    var phi_4100_: SlimbvhTypeF;
    var phi_4153_: i32;
    var phi_4293_: SlimbvhTypeH;
    var phi_4317_: u32;
    var phi_4346_: vec3<f32>;
    var phi_4347_: vec3<f32>;
    var phi_4365_: vec3<f32>;
    var phi_4366_: vec3<f32>;
    var phi_4384_: vec3<f32>;
    var phi_4385_: vec3<f32>;
    var phi_4421_: vec3<f32>;
    var phi_4603_: f32;
    var phi_4621_: bool;
    var phi_4622_: bool;
    var phi_4641_: bool;
    var phi_4642_: bool;
    var phi_4649_: SlimbvhTypeQ;
    var phi_4655_: SlimbvhTypeQ;
    var phi_4656_: SlimbvhTypeQ;
    var phi_4657_: SlimbvhTypeQ;
    var phi_2824_: SlimbvhTypeQ;
    var local_2: u32;
    var local_3: u32;
    var phi_4724_: u32;
    var phi_4725_: u32;
    var local_4: SlimbvhTypeQ;
    var phi_4734_: SlimbvhTypeQ;
    var phi_4735_: u32;
    var phi_4736_: u32;
    var phi_1718_: SlimbvhTypeQ;
    var phi_1721_: u32;
    var phi_1723_: u32;
    var phi_1725_: u32;
    var local_5: u32;
    var local_6: SlimbvhTypeQ;
    var phi_4773_: f32;
    var phi_4775_: f32;
    var phi_4776_: bool;
    var phi_4777_: f32;
    var phi_4778_: bool;
    var phi_5426_: u32;
    var phi_5444_: bool;
    var phi_5447_: bool;
    var phi_5460_: f32;
    var phi_5461_: f32;
    var phi_5466_: f32;
    var phi_5467_: f32;
    var phi_5468_: bool;
    var phi_5476_: f32;
    var phi_4793_: f32;
    var phi_4794_: f32;
    var phi_4806_: f32;
    var phi_4811_: SlimbvhTypeF;
    var phi_4824_: bool;
    var phi_4825_: bool;
    var phi_4826_: bool;
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
    let _e165 = slimbvh_origin.member;
    let _e171 = slimbvh_origin.member[3u];
    let _e172 = slimbvh_direction.member;
    let _e178 = slimbvh_direction.member[3u];
    let _e181 = slimbvh_exponent.member[0u];
    let _e182 = bitcast<i32>(_e181);
    let _e184 = (bitcast<u32>(_e165.x) & 2147483647u);
    let _e186 = (bitcast<u32>(_e165.y) & 2147483647u);
    let _e188 = (bitcast<u32>(_e165.z) & 2147483647u);
    let _e189 = bitcast<u32>(_e171);
    let _e190 = (_e189 & 2147483647u);
    let _e192 = (bitcast<u32>(_e172.x) & 2147483647u);
    let _e194 = (bitcast<u32>(_e172.y) & 2147483647u);
    let _e196 = (bitcast<u32>(_e172.z) & 2147483647u);
    let _e197 = bitcast<u32>(_e178);
    let _e198 = (_e197 & 2147483647u);
    let _e200 = select(_e194, _e192, (_e194 < _e192));
    let _e202 = select(_e196, _e200, (_e196 < _e200));
    let _e204 = select(_e184, _e202, (_e184 < _e202));
    let _e206 = select(_e186, _e204, (_e186 < _e204));
    let _e208 = select(_e188, _e206, (_e188 < _e206));
    let _e215 = (((select(_e190, _e208, (_e190 < _e208)) < 2139095040u) && (_e198 <= 2139095040u)) && (_e202 > 0u));
    if (_e192 == _e202) {
        phi_592_ = 0u;
    } else {
        phi_592_ = select(2u, 1u, (_e194 == _e202));
    }
    let _e220 = phi_592_;
    let _e221 = (_e220 == 2u);
    if _e221 {
        phi_598_ = 0u;
    } else {
        phi_598_ = (_e220 + 1u);
    }
    let _e224 = phi_598_;
    let _e225 = (_e224 == 2u);
    if _e225 {
        phi_604_ = 0u;
    } else {
        phi_604_ = (_e224 + 1u);
    }
    let _e228 = phi_604_;
    let _e229 = (_e224 == 0u);
    let _e231 = select(select(_e165.y, _e165.x, _e229), _e165.z, _e225);
    let _e232 = (_e228 == 0u);
    let _e234 = (_e228 == 2u);
    let _e235 = select(select(_e165.y, _e165.x, _e232), _e165.z, _e234);
    let _e236 = (_e220 == 0u);
    let _e238 = select(select(_e165.y, _e165.x, _e236), _e165.z, _e221);
    let _e240 = select(select(_e172.y, _e172.x, _e229), _e172.z, _e225);
    let _e242 = select(select(_e172.y, _e172.x, _e232), _e172.z, _e234);
    let _e244 = select(select(_e172.y, _e172.x, _e236), _e172.z, _e221);
    let _e245 = (_e190 - 1u);
    let _e246 = (_e198 - 1u);
    let _e248 = select(_e245, _e246, (_e246 < _e245));
    let _e249 = (_e184 - 1u);
    let _e250 = (_e186 - 1u);
    let _e252 = select(_e249, _e250, (_e250 < _e249));
    let _e253 = (_e188 - 1u);
    let _e255 = select(_e252, _e253, (_e253 < _e252));
    let _e256 = (_e192 - 1u);
    let _e257 = (_e194 - 1u);
    let _e259 = select(_e256, _e257, (_e257 < _e256));
    let _e260 = (_e196 - 1u);
    let _e262 = select(_e259, _e260, (_e260 < _e259));
    let _e264 = select(_e255, _e262, (_e262 < _e255));
    if (((select(_e264, _e248, (_e248 < _e264)) >= 8388607u) && (_e202 < 2130706432u)) && (bitcast<u32>((_e182 + 126i)) <= 253u)) {
        let _e529 = bitcast<i32>((_e202 >> bitcast<u32>(23i)));
        let _e530 = (_e529 - 127i);
        let _e531 = (_e182 + _e530);
        let _e536 = bitcast<f32>((bitcast<u32>((_e182 + 127i)) << bitcast<u32>(23i)));
        let _e541 = bitcast<f32>((bitcast<u32>((254i - _e529)) << bitcast<u32>(23i)));
        if (_e190 >= 2139095040u) {
            phi_766_ = 255i;
        } else {
            phi_766_ = (bitcast<i32>((_e190 >> bitcast<u32>(23i))) + _e531);
        }
        let _e556 = phi_766_;
        if (_e190 == 0u) {
            phi_772_ = 0u;
        } else {
            phi_772_ = (_e190 | 8388608u);
        }
        let _e560 = phi_772_;
        if (_e556 <= 0i) {
            phi_792_ = u32();
            phi_793_ = true;
        } else {
            let _e567 = (_e560 == 0u);
            if _e567 {
                phi_791_ = u32();
            } else {
                phi_791_ = select(((bitcast<u32>(_e556) << bitcast<u32>(23i)) | (_e560 & 8388607u)), 2139095039u, (_e556 >= 255i));
            }
            let _e571 = phi_791_;
            phi_792_ = _e571;
            phi_793_ = _e567;
        }
        let _e573 = phi_792_;
        let _e575 = phi_793_;
        if (_e198 >= 2139095040u) {
            phi_811_ = 255i;
        } else {
            phi_811_ = (bitcast<i32>((_e198 >> bitcast<u32>(23i))) + _e531);
        }
        let _e586 = phi_811_;
        if (_e198 == 0u) {
            phi_817_ = 0u;
        } else {
            phi_817_ = (_e198 | 8388608u);
        }
        let _e590 = phi_817_;
        if (_e586 <= 0i) {
            phi_837_ = u32();
            phi_838_ = true;
        } else {
            let _e597 = (_e590 == 0u);
            if _e597 {
                phi_836_ = u32();
            } else {
                phi_836_ = select(((bitcast<u32>(_e586) << bitcast<u32>(23i)) | (_e590 & 8388607u)), 2139095039u, (_e586 >= 255i));
            }
            let _e601 = phi_836_;
            phi_837_ = _e601;
            phi_838_ = _e597;
        }
        let _e603 = phi_837_;
        let _e605 = phi_838_;
        phi_1215_ = SlimbvhTypeC(array<f32, 3>((_e231 * _e536), (_e235 * _e536), (_e238 * _e536)), array<f32, 3>((_e240 * _e541), (_e242 * _e541), (_e244 * _e541)), bitcast<f32>(((_e189 & 2147483648u) | select(_e573, 0u, _e575))), bitcast<f32>(((_e197 & 2147483648u) | select(_e603, 0u, _e605))), _e530);
    } else {
        let _e277 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e202, _e215))) & 2147483647u);
        if (_e277 >= 8388608u) {
            phi_869_ = (bitcast<i32>((_e277 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_869_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e277)), 32u, (_e277 == 0u))));
        }
        let _e291 = phi_869_;
        let _e292 = (_e182 + _e291);
        if (_e182 < -126i) {
            phi_880_ = -126i;
        } else {
            phi_880_ = select(_e182, 127i, (_e182 > 127i));
        }
        let _e297 = phi_880_;
        let _e302 = bitcast<f32>((bitcast<u32>((_e297 + 127i)) << bitcast<u32>(23i)));
        let _e308 = bitcast<f32>((bitcast<u32>(((_e182 - _e297) + 127i)) << bitcast<u32>(23i)));
        let _e309 = bitcast<u32>(_e231);
        let _e311 = ((_e309 & 2139095040u) != 0u);
        let _e326 = bitcast<u32>(_e235);
        let _e328 = ((_e326 & 2139095040u) != 0u);
        let _e343 = bitcast<u32>(_e238);
        let _e345 = ((_e343 & 2139095040u) != 0u);
        let _e361 = -(_e291);
        if (_e361 < -126i) {
            phi_994_ = -126i;
        } else {
            phi_994_ = select(_e361, 127i, (_e361 > 127i));
        }
        let _e366 = phi_994_;
        let _e371 = bitcast<f32>((bitcast<u32>((_e366 + 127i)) << bitcast<u32>(23i)));
        let _e377 = bitcast<f32>((bitcast<u32>(((_e361 - _e366) + 127i)) << bitcast<u32>(23i)));
        let _e378 = bitcast<u32>(_e240);
        let _e380 = ((_e378 & 2139095040u) != 0u);
        let _e395 = bitcast<u32>(_e242);
        let _e397 = ((_e395 & 2139095040u) != 0u);
        let _e412 = bitcast<u32>(_e244);
        let _e414 = ((_e412 & 2139095040u) != 0u);
        let _e436 = ((_e190 & 8388607u) | (select(0u, 1u, ((_e190 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e439 = bitcast<i32>((_e190 >> bitcast<u32>(23i)));
        let _e446 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e436)), 32u, (_e436 == 0u))) - 8i);
        if (_e439 == 255i) {
            phi_1123_ = 255i;
        } else {
            phi_1123_ = (((_e439 + select(0i, 1i, (_e439 == 0i))) - _e446) + _e292);
        }
        let _e454 = phi_1123_;
        let _e458 = (_e436 << bitcast<u32>(((_e446 & 31i) & 31i)));
        if (_e454 <= 0i) {
            phi_1146_ = u32();
            phi_1147_ = true;
        } else {
            let _e465 = (_e458 == 0u);
            if _e465 {
                phi_1145_ = u32();
            } else {
                phi_1145_ = select(((bitcast<u32>(_e454) << bitcast<u32>(23i)) | (_e458 & 8388607u)), 2139095039u, (_e454 >= 255i));
            }
            let _e469 = phi_1145_;
            phi_1146_ = _e469;
            phi_1147_ = _e465;
        }
        let _e471 = phi_1146_;
        let _e473 = phi_1147_;
        let _e484 = ((_e198 & 8388607u) | (select(0u, 1u, ((_e198 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e487 = bitcast<i32>((_e198 >> bitcast<u32>(23i)));
        let _e494 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e484)), 32u, (_e484 == 0u))) - 8i);
        if (_e487 == 255i) {
            phi_1181_ = 255i;
        } else {
            phi_1181_ = (((_e487 + select(0i, 1i, (_e487 == 0i))) - _e494) + _e292);
        }
        let _e502 = phi_1181_;
        let _e506 = (_e484 << bitcast<u32>(((_e494 & 31i) & 31i)));
        if (_e502 <= 0i) {
            phi_1204_ = u32();
            phi_1205_ = true;
        } else {
            let _e513 = (_e506 == 0u);
            if _e513 {
                phi_1203_ = u32();
            } else {
                phi_1203_ = select(((bitcast<u32>(_e502) << bitcast<u32>(23i)) | (_e506 & 8388607u)), 2139095039u, (_e502 >= 255i));
            }
            let _e517 = phi_1203_;
            phi_1204_ = _e517;
            phi_1205_ = _e513;
        }
        let _e519 = phi_1204_;
        let _e521 = phi_1205_;
        phi_1215_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e309 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e309 & 2147483648u))), _e231, _e311) * _e302) * select(0.00000011920929f, 1f, _e311)) * _e308), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e326 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e326 & 2147483648u))), _e235, _e328) * _e302) * select(0.00000011920929f, 1f, _e328)) * _e308), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e343 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e343 & 2147483648u))), _e238, _e345) * _e302) * select(0.00000011920929f, 1f, _e345)) * _e308)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e378 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e378 & 2147483648u))), _e240, _e380) * _e371) * select(0.00000011920929f, 1f, _e380)) * _e377), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e395 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e395 & 2147483648u))), _e242, _e397) * _e371) * select(0.00000011920929f, 1f, _e397)) * _e377), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e412 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e412 & 2147483648u))), _e244, _e414) * _e371) * select(0.00000011920929f, 1f, _e414)) * _e377)), bitcast<f32>(((_e189 & 2147483648u) | select(_e471, 0u, _e473))), bitcast<f32>(((_e197 & 2147483648u) | select(_e519, 0u, _e521))), _e291);
    }
    let _e612 = phi_1215_;
    let _e627 = (bitcast<f32>((bitcast<u32>(_e612.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e630 = bitcast<f32>((bitcast<u32>(_e612.member[0]) & 2147483647u));
    let _e631 = (_e630 * 0.00000011920929f);
    let _e634 = select(select(0.00000000000011368684f, _e631, (_e631 > 0.00000000000011368684f)), 0f, _e627);
    let _e635 = select(0f, _e612.member_1[0], _e627);
    let _e636 = (_e612.member[0] + _e634);
    let _e637 = (_e612.member[0] - _e634);
    let _e639 = select(38685626000000000000000000f, (1f / _e612.member_1[0]), _e627);
    let _e643 = (bitcast<f32>((bitcast<u32>(_e612.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e646 = bitcast<f32>((bitcast<u32>(_e612.member[1]) & 2147483647u));
    let _e647 = (_e646 * 0.00000011920929f);
    let _e650 = select(select(0.00000000000011368684f, _e647, (_e647 > 0.00000000000011368684f)), 0f, _e643);
    let _e651 = select(0f, _e612.member_1[1], _e643);
    let _e652 = (_e612.member[1] + _e650);
    let _e653 = (_e612.member[1] - _e650);
    let _e655 = select(38685626000000000000000000f, (1f / _e612.member_1[1]), _e643);
    let _e659 = (bitcast<f32>((bitcast<u32>(_e612.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e662 = bitcast<f32>((bitcast<u32>(_e612.member[2]) & 2147483647u));
    let _e663 = (_e662 * 0.00000011920929f);
    let _e666 = select(select(0.00000000000011368684f, _e663, (_e663 > 0.00000000000011368684f)), 0f, _e659);
    let _e667 = select(0f, _e612.member_1[2], _e659);
    let _e668 = (_e612.member[2] + _e666);
    let _e669 = (_e612.member[2] - _e666);
    let _e671 = select(38685626000000000000000000f, (1f / _e612.member_1[2]), _e659);
    let _e673 = select(_e646, _e630, (_e630 > _e646));
    let _e677 = (_e215 && (select(_e662, _e673, (_e673 > _e662)) <= 1099511600000f));
    let _e678 = select(0f, _e612.member_3, _e677);
    let _e679 = select(1f, _e612.member_2, _e677);
    let _e683 = slimbvh_question.member[1u];
    let _e684 = slimbvh_lane.member;
    if (_e684 < 64u) {
        let _e686 = (_e684 % 64u);
        let _e689 = slimbvh_question.member[0u];
        if (_e689 == 1u) {
            phi_1461_ = SlimbvhTypeQ(SlimbvhTypeI(_e109, _e678), true);
        } else {
            phi_1461_ = SlimbvhTypeQ(SlimbvhTypeI(_e109, _e678), false);
        }
        let _e696 = phi_1461_;
        let _e701 = (_e224 & 3u);
        let _e702 = (_e228 & 3u);
        let _e703 = (_e220 & 3u);
        let _e706 = (bitcast<u32>(_e639) >> bitcast<u32>(31i));
        let _e709 = (bitcast<u32>(_e655) >> bitcast<u32>(31i));
        let _e712 = (bitcast<u32>(_e671) >> bitcast<u32>(31i));
        let _e716 = (f32(bitcast<i32>(_e128)) * _e164);
        let _e718 = (f32(bitcast<i32>(_e132)) * _e164);
        let _e720 = (f32(bitcast<i32>(_e136)) * _e164);
        let _e721 = (_e701 == 0u);
        if _e721 {
            phi_1525_ = array<f32, 3>(_e716, _e718, _e720);
        } else {
            if (_e701 == 1u) {
                phi_1524_ = array<f32, 3>(_e718, _e720, _e716);
            } else {
                phi_1524_ = array<f32, 3>(_e720, _e716, _e718);
            }
            let _e726 = phi_1524_;
            phi_1525_ = _e726;
        }
        let _e729 = phi_1525_;
        let _e731 = (f32(bitcast<i32>(_e144)) * _e164);
        let _e733 = (f32(bitcast<i32>(_e148)) * _e164);
        let _e735 = (f32(bitcast<i32>(_e152)) * _e164);
        if _e721 {
            phi_1544_ = array<f32, 3>(_e731, _e733, _e735);
        } else {
            if (_e701 == 1u) {
                phi_1543_ = array<f32, 3>(_e733, _e735, _e731);
            } else {
                phi_1543_ = array<f32, 3>(_e735, _e731, _e733);
            }
            let _e740 = phi_1543_;
            phi_1544_ = _e740;
        }
        let _e743 = phi_1544_;
        let _e754 = ((_e729[0] - _e636) * _e639);
        let _e755 = ((_e743[0] - _e637) * _e639);
        let _e756 = vec4<f32>(_e754, f32(), _e755, f32());
        let _e759 = ((_e729[1] - _e652) * _e655);
        let _e760 = ((_e743[1] - _e653) * _e655);
        let _e761 = vec4<f32>(_e759, f32(), _e760, f32());
        let _e764 = ((_e729[2] - _e668) * _e671);
        let _e765 = ((_e743[2] - _e669) * _e671);
        let _e766 = vec4<f32>(_e764, f32(), _e765, f32());
        let _e767 = vec4<f32>(_e755, f32(), _e754, f32());
        let _e769 = vec4<f32>(_e760, f32(), _e759, f32());
        let _e771 = vec4<f32>(_e765, f32(), _e764, f32());
        phi_1717_ = _e696;
        phi_1720_ = select(4294967295u, select(4294967295u, 0u, (_e679 <= _e678)), (max(max(max(min(_e756, _e767).x, min(_e761, _e769).x), min(_e766, _e771).x), _e679) <= min((min(min(max(_e756, _e767).x, max(_e761, _e769).x), max(_e766, _e771).x) + (max(max(_e766, _e771).x, -(min(_e766, _e771).x)) * 0.0000019073523f)), _e696.member.member_1)));
        phi_1722_ = select(0u, 4294967295u, (_e113 == 0u));
        phi_1724_ = (_e113 + 1u);
        loop {
            let _e795 = phi_1717_;
            let _e797 = phi_1720_;
            let _e799 = phi_1722_;
            let _e801 = phi_1724_;
            local_5 = _e797;
            local_6 = _e795;
            let _e802 = (_e797 <= 32u);
            if _e802 {
                phi_1733_ = _e797;
                phi_1736_ = _e799;
                phi_1738_ = _e801;
                loop {
                    let _e804 = phi_1733_;
                    let _e806 = phi_1736_;
                    let _e808 = phi_1738_;
                    local_1 = _e806;
                    local_2 = _e804;
                    local_3 = _e804;
                    local_8 = _e804;
                    local_9 = _e806;
                    local_10 = _e808;
                    let _e809 = (_e804 <= 32u);
                    let _e812 = (_e809 && !((_e806 >= _e113)));
                    local = _e809;
                    if _e812 {
                        let _e818 = slimbvh_nodes.member[_e806].member[select(_e701, 2u, (2u < _e701))];
                        let _e824 = slimbvh_nodes.member[_e806].member[select(_e702, 2u, (2u < _e702))];
                        let _e830 = slimbvh_nodes.member[_e806].member[select(_e703, 2u, (2u < _e703))];
                        let _e833 = bitcast<u32>(_e164);
                        let _e838 = bitcast<f32>(_e818.x);
                        let _e843 = (_e838 + (f32((_e818.w >> bitcast<u32>(5u))) * _e164));
                        if (_e706 == 0u) {
                            phi_1840_ = SlimbvhTypeL(_e818.z, _e843);
                            phi_1841_ = SlimbvhTypeL(_e818.y, _e838);
                        } else {
                            phi_1840_ = SlimbvhTypeL(_e818.y, _e838);
                            phi_1841_ = SlimbvhTypeL(_e818.z, _e843);
                        }
                        let _e854 = phi_1840_;
                        let _e856 = phi_1841_;
                        let _e860 = bitcast<f32>(((_e833 + ((_e818.w & 31u) << bitcast<u32>(23i))) ^ (_e706 << bitcast<u32>(31i))));
                        let _e900 = bitcast<f32>(_e824.x);
                        let _e905 = (_e900 + (f32((_e824.w >> bitcast<u32>(5u))) * _e164));
                        if (_e709 == 0u) {
                            phi_1900_ = SlimbvhTypeL(_e824.z, _e905);
                            phi_1901_ = SlimbvhTypeL(_e824.y, _e900);
                        } else {
                            phi_1900_ = SlimbvhTypeL(_e824.y, _e900);
                            phi_1901_ = SlimbvhTypeL(_e824.z, _e905);
                        }
                        let _e916 = phi_1900_;
                        let _e918 = phi_1901_;
                        let _e922 = bitcast<f32>(((_e833 + ((_e824.w & 31u) << bitcast<u32>(23i))) ^ (_e709 << bitcast<u32>(31i))));
                        let _e962 = bitcast<f32>(_e830.x);
                        let _e967 = (_e962 + (f32((_e830.w >> bitcast<u32>(5u))) * _e164));
                        if (_e712 == 0u) {
                            phi_1960_ = SlimbvhTypeL(_e830.z, _e967);
                            phi_1961_ = SlimbvhTypeL(_e830.y, _e962);
                        } else {
                            phi_1960_ = SlimbvhTypeL(_e830.y, _e962);
                            phi_1961_ = SlimbvhTypeL(_e830.z, _e967);
                        }
                        let _e978 = phi_1960_;
                        let _e980 = phi_1961_;
                        let _e984 = bitcast<f32>(((_e833 + ((_e830.w & 31u) << bitcast<u32>(23i))) ^ (_e712 << bitcast<u32>(31i))));
                        let _e1020 = (_e860 * _e639);
                        let _e1027 = (((_e856.member_1 - _e636) * _e639) + (bitcast<f32>((bitcast<u32>(_e1020) & 2147483647u)) * -0.00012207031f));
                        let _e1036 = (-(_e860) * _e639);
                        let _e1043 = (((_e854.member_1 - _e637) * _e639) + (bitcast<f32>((bitcast<u32>(_e1036) & 2147483647u)) * 0.00012207031f));
                        let _e1052 = (_e922 * _e655);
                        let _e1059 = (((_e918.member_1 - _e652) * _e655) + (bitcast<f32>((bitcast<u32>(_e1052) & 2147483647u)) * -0.00012207031f));
                        let _e1068 = (-(_e922) * _e655);
                        let _e1075 = (((_e916.member_1 - _e653) * _e655) + (bitcast<f32>((bitcast<u32>(_e1068) & 2147483647u)) * 0.00012207031f));
                        let _e1084 = (_e984 * _e671);
                        let _e1091 = (((_e980.member_1 - _e668) * _e671) + (bitcast<f32>((bitcast<u32>(_e1084) & 2147483647u)) * -0.00012207031f));
                        let _e1096 = ((f32((_e980.member & 255u)) * _e1084) + _e1091);
                        let _e1097 = ((f32(((_e980.member >> bitcast<u32>(8u)) & 255u)) * _e1084) + _e1091);
                        let _e1098 = ((f32(((_e980.member >> bitcast<u32>(16u)) & 255u)) * _e1084) + _e1091);
                        let _e1099 = ((f32(((_e980.member >> bitcast<u32>(24u)) & 255u)) * _e1084) + _e1091);
                        let _e1100 = (-(_e984) * _e671);
                        let _e1107 = (((_e978.member_1 - _e669) * _e671) + (bitcast<f32>((bitcast<u32>(_e1100) & 2147483647u)) * 0.00012207031f));
                        let _e1112 = ((f32((_e978.member & 255u)) * _e1100) + _e1107);
                        let _e1113 = ((f32(((_e978.member >> bitcast<u32>(8u)) & 255u)) * _e1100) + _e1107);
                        let _e1114 = ((f32(((_e978.member >> bitcast<u32>(16u)) & 255u)) * _e1100) + _e1107);
                        let _e1115 = ((f32(((_e978.member >> bitcast<u32>(24u)) & 255u)) * _e1100) + _e1107);
                        let _e1148 = max(max(max(((f32((_e856.member & 255u)) * _e1020) + _e1027), ((f32((_e918.member & 255u)) * _e1052) + _e1059)), _e1096), _e679);
                        let _e1149 = max(max(max(((f32(((_e856.member >> bitcast<u32>(8u)) & 255u)) * _e1020) + _e1027), ((f32(((_e918.member >> bitcast<u32>(8u)) & 255u)) * _e1052) + _e1059)), _e1097), _e679);
                        let _e1150 = max(max(max(((f32(((_e856.member >> bitcast<u32>(16u)) & 255u)) * _e1020) + _e1027), ((f32(((_e918.member >> bitcast<u32>(16u)) & 255u)) * _e1052) + _e1059)), _e1098), _e679);
                        let _e1151 = max(max(max(((f32(((_e856.member >> bitcast<u32>(24u)) & 255u)) * _e1020) + _e1027), ((f32(((_e918.member >> bitcast<u32>(24u)) & 255u)) * _e1052) + _e1059)), _e1099), _e679);
                        let _e1156 = (_e795.member.member_1 + (bitcast<f32>((bitcast<u32>(_e795.member.member_1) & 2147483647u)) * 0.0000004768374f));
                        if (_e1148 <= min((min(min(((f32((_e854.member & 255u)) * _e1036) + _e1043), ((f32((_e916.member & 255u)) * _e1068) + _e1075)), _e1112) + (max(_e1112, -(_e1096)) * 0.0000023841915f)), _e1156)) {
                            phi_2445_ = (((bitcast<u32>(_e1148) ^ select(0u, 4294967288u, _e696.member_1)) & 2147483640u) | 4u);
                        } else {
                            phi_2445_ = 4294967288u;
                        }
                        let _e1171 = phi_2445_;
                        if (_e1149 <= min((min(min(((f32(((_e854.member >> bitcast<u32>(8u)) & 255u)) * _e1036) + _e1043), ((f32(((_e916.member >> bitcast<u32>(8u)) & 255u)) * _e1068) + _e1075)), _e1113) + (max(_e1113, -(_e1097)) * 0.0000023841915f)), _e1156)) {
                            phi_2458_ = ((((bitcast<u32>(_e1149) ^ select(0u, 4294967288u, _e696.member_1)) & 2147483640u) | 4u) | 1u);
                        } else {
                            phi_2458_ = 4294967288u;
                        }
                        let _e1179 = phi_2458_;
                        if (_e1150 <= min((min(min(((f32(((_e854.member >> bitcast<u32>(16u)) & 255u)) * _e1036) + _e1043), ((f32(((_e916.member >> bitcast<u32>(16u)) & 255u)) * _e1068) + _e1075)), _e1114) + (max(_e1114, -(_e1098)) * 0.0000023841915f)), _e1156)) {
                            phi_2471_ = ((((bitcast<u32>(_e1150) ^ select(0u, 4294967288u, _e696.member_1)) & 2147483640u) | 4u) | 2u);
                        } else {
                            phi_2471_ = 4294967288u;
                        }
                        let _e1187 = phi_2471_;
                        if (_e1151 <= min((min(min(((f32(((_e854.member >> bitcast<u32>(24u)) & 255u)) * _e1036) + _e1043), ((f32(((_e916.member >> bitcast<u32>(24u)) & 255u)) * _e1068) + _e1075)), _e1115) + (max(_e1115, -(_e1099)) * 0.0000023841915f)), _e1156)) {
                            phi_2484_ = ((((bitcast<u32>(_e1151) ^ select(0u, 4294967288u, _e696.member_1)) & 2147483640u) | 4u) | 3u);
                        } else {
                            phi_2484_ = 4294967288u;
                        }
                        let _e1195 = phi_2484_;
                        if (_e1171 < _e1179) {
                            phi_5147_ = SlimbvhTypeD(_e1171, _e1179);
                        } else {
                            phi_5147_ = SlimbvhTypeD(_e1179, _e1171);
                        }
                        let _e1200 = phi_5147_;
                        if (_e1187 < _e1195) {
                            phi_5159_ = SlimbvhTypeD(_e1187, _e1195);
                        } else {
                            phi_5159_ = SlimbvhTypeD(_e1195, _e1187);
                        }
                        let _e1207 = phi_5159_;
                        if (_e1200.member < _e1207.member) {
                            phi_5171_ = SlimbvhTypeD(_e1200.member, _e1207.member);
                        } else {
                            phi_5171_ = SlimbvhTypeD(_e1207.member, _e1200.member);
                        }
                        let _e1214 = phi_5171_;
                        if (_e1200.member_1 < _e1207.member_1) {
                            phi_5183_ = SlimbvhTypeD(_e1200.member_1, _e1207.member_1);
                        } else {
                            phi_5183_ = SlimbvhTypeD(_e1207.member_1, _e1200.member_1);
                        }
                        let _e1221 = phi_5183_;
                        if (_e1221.member < _e1214.member_1) {
                            phi_5195_ = SlimbvhTypeD(_e1221.member, _e1214.member_1);
                        } else {
                            phi_5195_ = SlimbvhTypeD(_e1214.member_1, _e1221.member);
                        }
                        let _e1228 = phi_5195_;
                        let _e1243 = (((_e1214.member & 7u) | ((_e1228.member & 7u) << bitcast<u32>(3u))) | (((_e1228.member_1 & 7u) | ((_e1221.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                        if (_e1243 == 0u) {
                            let _e1263 = (_e804 - 1u);
                            let _e1268 = slimbvh_stacks[(((_e1263 % 32u) * 64u) + _e686)];
                            let _e1269 = (_e1268 & 511u);
                            let _e1271 = (_e1269 >> bitcast<u32>(3u));
                            let _e1274 = ((_e1271 == 0u) || (_e1263 == 4294967295u));
                            if _e1274 {
                            } else {
                                slimbvh_stacks[(((_e1263 % 32u) * 64u) + _e686)] = (((_e1268 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1271);
                            }
                            phi_2573_ = select(_e804, _e1263, _e1274);
                            phi_2574_ = (((_e1268 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1269 & 3u) & 3u));
                        } else {
                            let _e1246 = (_e1243 >> bitcast<u32>(3u));
                            if (_e1246 == 0u) {
                                phi_2568_ = _e804;
                            } else {
                                slimbvh_stacks[(((_e804 % 32u) * 64u) + _e686)] = ((_e806 << bitcast<u32>(9u)) | _e1246);
                                phi_2568_ = (_e804 + 1u);
                            }
                            let _e1257 = phi_2568_;
                            phi_2573_ = _e1257;
                            phi_2574_ = ((_e806 << bitcast<u32>(2i)) | ((_e1243 & 3u) & 3u));
                        }
                        let _e1289 = phi_2573_;
                        let _e1291 = phi_2574_;
                        let _e1293 = (_e1291 >> bitcast<u32>(2i));
                        if (_e1293 < _e113) {
                            let _e1299 = slimbvh_nodes.member[_e1293].member_1[(_e1291 & 3u)];
                            if ((_e1299 & 2147483648u) != 0u) {
                                phi_2604_ = (2147483648u | _e1291);
                            } else {
                                phi_2604_ = _e1299;
                            }
                            let _e1304 = phi_2604_;
                            phi_2605_ = _e1304;
                        } else {
                            phi_2605_ = 4294967295u;
                        }
                        let _e1306 = phi_2605_;
                        let _e1307 = (_e808 - 1u);
                        phi_1734_ = select(_e1289, 4294967295u, (_e1307 == 0u));
                        phi_1737_ = _e1306;
                        phi_1739_ = _e1307;
                    } else {
                        phi_1734_ = u32();
                        phi_1737_ = u32();
                        phi_1739_ = u32();
                    }
                    let _e1311 = phi_1734_;
                    let _e1313 = phi_1737_;
                    let _e1315 = phi_1739_;
                    continue;
                    continuing {
                        phi_1733_ = _e1311;
                        phi_1736_ = _e1313;
                        phi_1738_ = _e1315;
                        break if !(_e812);
                    }
                }
                let _e1318 = local;
                if _e1318 {
                    let _e1320 = local_1;
                    let _e1321 = (_e1320 & 2147483647u);
                    let _e1323 = (_e1321 >> bitcast<u32>(2i));
                    if (_e1323 >= _e113) {
                        phi_2819_ = SlimbvhTypeN(SlimbvhTypeM(vec4<f32>(0f, 0f, 0f, 0f), 0u), 0u, 0u);
                    } else {
                        let _e1330 = slimbvh_nodes.member[_e1323].member[select(_e701, 2u, (2u < _e701))];
                        let _e1341 = slimbvh_nodes.member[_e1323].member[select(_e702, 2u, (2u < _e702))];
                        let _e1352 = slimbvh_nodes.member[_e1323].member[select(_e703, 2u, (2u < _e703))];
                        let _e1358 = (_e1321 & 3u);
                        let _e1361 = (((8u * _e1358) & 31u) & 31u);
                        let _e1369 = ((_e1330.w & 31u) & 31u);
                        let _e1371 = (((_e1330.y >> bitcast<u32>(_e1361)) & 255u) << bitcast<u32>(_e1369));
                        let _e1385 = ((_e1341.w & 31u) & 31u);
                        let _e1387 = (((_e1341.y >> bitcast<u32>(_e1361)) & 255u) << bitcast<u32>(_e1385));
                        let _e1401 = ((_e1352.w & 31u) & 31u);
                        let _e1403 = (((_e1352.y >> bitcast<u32>(_e1361)) & 255u) << bitcast<u32>(_e1401));
                        let _e1411 = (((((_e1330.w >> bitcast<u32>(5u)) - (((_e1330.z >> bitcast<u32>(_e1361)) & 255u) << bitcast<u32>(_e1369))) - _e1371) | (((_e1341.w >> bitcast<u32>(5u)) - (((_e1341.z >> bitcast<u32>(_e1361)) & 255u) << bitcast<u32>(_e1385))) - _e1387)) | (((_e1352.w >> bitcast<u32>(5u)) - (((_e1352.z >> bitcast<u32>(_e1361)) & 255u) << bitcast<u32>(_e1401))) - _e1403));
                        if (_e1411 < 1024u) {
                            phi_2755_ = 0u;
                        } else {
                            phi_2755_ = select(2u, 1u, (_e1411 < 2097152u));
                        }
                        let _e1416 = phi_2755_;
                        let _e1431 = slimbvh_nodes.member[_e1323].member_1[_e1358];
                        if ((_e1431 & 2147483648u) != 0u) {
                            phi_2816_ = ((_e1431 >> bitcast<u32>(28u)) & 7u);
                        } else {
                            phi_2816_ = 0u;
                        }
                        let _e1438 = phi_2816_;
                        phi_2819_ = SlimbvhTypeN(SlimbvhTypeM(vec4<f32>((bitcast<f32>(_e1330.x) + (f32(_e1371) * _e164)), (bitcast<f32>(_e1341.x) + (f32(_e1387) * _e164)), (bitcast<f32>(_e1352.x) + (f32(_e1403) * _e164)), 0f), _e1416), (_e1431 & 268435455u), _e1438);
                    }
                    let _e1442 = phi_2819_;
                    phi_2823_ = _e795;
                    phi_2826_ = SlimbvhTypeD(0u, _e1442.member_2);
                    loop {
                        let _e1446 = phi_2823_;
                        let _e1448 = phi_2826_;
                        local_4 = _e1446;
                        local_7 = _e1446;
                        if (_e1448.member < _e1448.member_1) {
                            phi_2827_ = SlimbvhTypeD((_e1448.member + 1u), _e1448.member_1);
                            phi_2849_ = SlimbvhTypeD(1u, _e1448.member);
                        } else {
                            phi_2827_ = _e1448;
                            phi_2849_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                        }
                        let _e1461 = phi_2827_;
                        let _e1463 = phi_2849_;
                        let _e1467 = (bitcast<i32>(_e1463.member) != 0i);
                        if _e1467 {
                            switch bitcast<i32>(_e1442.member.member_1) {
                                case 0: {
                                    phi_2867_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2867_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2867_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2867_ = u32();
                                    break;
                                }
                            }
                            let _e1473 = phi_2867_;
                            switch bitcast<i32>(_e1442.member.member_1) {
                                case 0: {
                                    phi_2878_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2878_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2878_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2878_ = u32();
                                    break;
                                }
                            }
                            let _e1480 = phi_2878_;
                            let _e1482 = ((_e1442.member_1 + (_e1463.member_1 * ((3u * _e1473) + 1u))) + (3u * _e1480));
                            if (_e1482 < _e116) {
                                let _e1485 = slimbvh_triangles.member[_e1482];
                                phi_2894_ = _e1485;
                            } else {
                                phi_2894_ = 4294967295u;
                            }
                            let _e1487 = phi_2894_;
                            switch bitcast<i32>(_e1442.member.member_1) {
                                case 0: {
                                    phi_2907_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2907_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2907_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2907_ = u32();
                                    break;
                                }
                            }
                            let _e1490 = phi_2907_;
                            let _e1494 = (_e1442.member_1 + (_e1463.member_1 * ((3u * _e1490) + 1u)));
                            switch bitcast<i32>(_e1442.member.member_1) {
                                case 0: {
                                    phi_2918_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2918_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2918_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2918_ = u32();
                                    break;
                                }
                            }
                            let _e1497 = phi_2918_;
                            let _e1498 = (_e1494 + _e1497);
                            let _e1500 = (_e1494 + (2u * _e1497));
                            switch bitcast<i32>(_e1442.member.member_1) {
                                case 0: {
                                    if (_e1494 < _e116) {
                                        let _e1777 = slimbvh_triangles.member[_e1494];
                                        phi_2945_ = _e1777;
                                    } else {
                                        phi_2945_ = 0u;
                                    }
                                    let _e1779 = phi_2945_;
                                    let _e1782 = ((10u * _e224) & 31u);
                                    let _e1793 = ((10u * _e228) & 31u);
                                    let _e1804 = ((10u * _e220) & 31u);
                                    if (_e1498 < _e116) {
                                        let _e1816 = slimbvh_triangles.member[_e1498];
                                        phi_2991_ = _e1816;
                                    } else {
                                        phi_2991_ = 0u;
                                    }
                                    let _e1818 = phi_2991_;
                                    if (_e1500 < _e116) {
                                        let _e1846 = slimbvh_triangles.member[_e1500];
                                        phi_3037_ = _e1846;
                                    } else {
                                        phi_3037_ = 0u;
                                    }
                                    let _e1848 = phi_3037_;
                                    phi_3504_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1442.member.member.x + ((bitcast<f32>((1258291200u | ((_e1779 >> bitcast<u32>(_e1782)) & 1023u))) - 8388608f) * _e164)), (_e1442.member.member.y + ((bitcast<f32>((1258291200u | ((_e1779 >> bitcast<u32>(_e1793)) & 1023u))) - 8388608f) * _e164)), (_e1442.member.member.z + ((bitcast<f32>((1258291200u | ((_e1779 >> bitcast<u32>(_e1804)) & 1023u))) - 8388608f) * _e164))), array<f32, 3>((_e1442.member.member.x + ((bitcast<f32>((1258291200u | ((_e1818 >> bitcast<u32>(_e1782)) & 1023u))) - 8388608f) * _e164)), (_e1442.member.member.y + ((bitcast<f32>((1258291200u | ((_e1818 >> bitcast<u32>(_e1793)) & 1023u))) - 8388608f) * _e164)), (_e1442.member.member.z + ((bitcast<f32>((1258291200u | ((_e1818 >> bitcast<u32>(_e1804)) & 1023u))) - 8388608f) * _e164))), array<f32, 3>((_e1442.member.member.x + ((bitcast<f32>((1258291200u | ((_e1848 >> bitcast<u32>(_e1782)) & 1023u))) - 8388608f) * _e164)), (_e1442.member.member.y + ((bitcast<f32>((1258291200u | ((_e1848 >> bitcast<u32>(_e1793)) & 1023u))) - 8388608f) * _e164)), (_e1442.member.member.z + ((bitcast<f32>((1258291200u | ((_e1848 >> bitcast<u32>(_e1804)) & 1023u))) - 8388608f) * _e164))));
                                    break;
                                }
                                case 1: {
                                    if (_e1494 < _e116) {
                                        let _e1590 = slimbvh_triangles.member[_e1494];
                                        phi_3084_ = _e1590;
                                    } else {
                                        phi_3084_ = 0u;
                                    }
                                    let _e1592 = phi_3084_;
                                    let _e1593 = (_e1494 + 1u);
                                    if (_e1593 < _e116) {
                                        let _e1596 = slimbvh_triangles.member[_e1593];
                                        phi_3097_ = _e1596;
                                    } else {
                                        phi_3097_ = 0u;
                                    }
                                    let _e1598 = phi_3097_;
                                    let _e1600 = (_e224 == 1u);
                                    if _e1600 {
                                        phi_3107_ = ((_e1592 >> bitcast<u32>(21i)) | (_e1598 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3107_ = (_e1598 >> bitcast<u32>(10i));
                                    }
                                    let _e1609 = phi_3107_;
                                    let _e1618 = (_e228 == 1u);
                                    if _e1618 {
                                        phi_3128_ = ((_e1592 >> bitcast<u32>(21i)) | (_e1598 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3128_ = (_e1598 >> bitcast<u32>(10i));
                                    }
                                    let _e1627 = phi_3128_;
                                    let _e1636 = (_e220 == 1u);
                                    if _e1636 {
                                        phi_3149_ = ((_e1592 >> bitcast<u32>(21i)) | (_e1598 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3149_ = (_e1598 >> bitcast<u32>(10i));
                                    }
                                    let _e1645 = phi_3149_;
                                    if (_e1498 < _e116) {
                                        let _e1656 = slimbvh_triangles.member[_e1498];
                                        phi_3176_ = _e1656;
                                    } else {
                                        phi_3176_ = 0u;
                                    }
                                    let _e1658 = phi_3176_;
                                    let _e1659 = (_e1498 + 1u);
                                    if (_e1659 < _e116) {
                                        let _e1662 = slimbvh_triangles.member[_e1659];
                                        phi_3189_ = _e1662;
                                    } else {
                                        phi_3189_ = 0u;
                                    }
                                    let _e1664 = phi_3189_;
                                    if _e1600 {
                                        phi_3199_ = ((_e1658 >> bitcast<u32>(21i)) | (_e1664 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3199_ = (_e1664 >> bitcast<u32>(10i));
                                    }
                                    let _e1673 = phi_3199_;
                                    if _e1618 {
                                        phi_3220_ = ((_e1658 >> bitcast<u32>(21i)) | (_e1664 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3220_ = (_e1664 >> bitcast<u32>(10i));
                                    }
                                    let _e1689 = phi_3220_;
                                    if _e1636 {
                                        phi_3241_ = ((_e1658 >> bitcast<u32>(21i)) | (_e1664 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3241_ = (_e1664 >> bitcast<u32>(10i));
                                    }
                                    let _e1705 = phi_3241_;
                                    if (_e1500 < _e116) {
                                        let _e1716 = slimbvh_triangles.member[_e1500];
                                        phi_3268_ = _e1716;
                                    } else {
                                        phi_3268_ = 0u;
                                    }
                                    let _e1718 = phi_3268_;
                                    let _e1719 = (_e1500 + 1u);
                                    if (_e1719 < _e116) {
                                        let _e1722 = slimbvh_triangles.member[_e1719];
                                        phi_3281_ = _e1722;
                                    } else {
                                        phi_3281_ = 0u;
                                    }
                                    let _e1724 = phi_3281_;
                                    if _e1600 {
                                        phi_3291_ = ((_e1718 >> bitcast<u32>(21i)) | (_e1724 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3291_ = (_e1724 >> bitcast<u32>(10i));
                                    }
                                    let _e1733 = phi_3291_;
                                    if _e1618 {
                                        phi_3312_ = ((_e1718 >> bitcast<u32>(21i)) | (_e1724 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3312_ = (_e1724 >> bitcast<u32>(10i));
                                    }
                                    let _e1749 = phi_3312_;
                                    if _e1636 {
                                        phi_3333_ = ((_e1718 >> bitcast<u32>(21i)) | (_e1724 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3333_ = (_e1724 >> bitcast<u32>(10i));
                                    }
                                    let _e1765 = phi_3333_;
                                    phi_3504_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1442.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1609, _e1592, _e229) & 2097151u))) - 8388608f) * _e164)), (_e1442.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1627, _e1592, _e232) & 2097151u))) - 8388608f) * _e164)), (_e1442.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1645, _e1592, _e236) & 2097151u))) - 8388608f) * _e164))), array<f32, 3>((_e1442.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1673, _e1658, _e229) & 2097151u))) - 8388608f) * _e164)), (_e1442.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1689, _e1658, _e232) & 2097151u))) - 8388608f) * _e164)), (_e1442.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1705, _e1658, _e236) & 2097151u))) - 8388608f) * _e164))), array<f32, 3>((_e1442.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1733, _e1718, _e229) & 2097151u))) - 8388608f) * _e164)), (_e1442.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1749, _e1718, _e232) & 2097151u))) - 8388608f) * _e164)), (_e1442.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1765, _e1718, _e236) & 2097151u))) - 8388608f) * _e164))));
                                    break;
                                }
                                case 2: {
                                    let _e1503 = (_e1494 + _e224);
                                    if (_e1503 < _e116) {
                                        let _e1506 = slimbvh_triangles.member[_e1503];
                                        phi_3362_ = _e1506;
                                    } else {
                                        phi_3362_ = 0u;
                                    }
                                    let _e1508 = phi_3362_;
                                    let _e1509 = (_e1494 + _e228);
                                    if (_e1509 < _e116) {
                                        let _e1512 = slimbvh_triangles.member[_e1509];
                                        phi_3375_ = _e1512;
                                    } else {
                                        phi_3375_ = 0u;
                                    }
                                    let _e1514 = phi_3375_;
                                    let _e1515 = (_e1494 + _e220);
                                    if (_e1515 < _e116) {
                                        let _e1518 = slimbvh_triangles.member[_e1515];
                                        phi_3388_ = _e1518;
                                    } else {
                                        phi_3388_ = 0u;
                                    }
                                    let _e1520 = phi_3388_;
                                    let _e1531 = (_e1498 + _e224);
                                    if (_e1531 < _e116) {
                                        let _e1534 = slimbvh_triangles.member[_e1531];
                                        phi_3414_ = _e1534;
                                    } else {
                                        phi_3414_ = 0u;
                                    }
                                    let _e1536 = phi_3414_;
                                    let _e1537 = (_e1498 + _e228);
                                    if (_e1537 < _e116) {
                                        let _e1540 = slimbvh_triangles.member[_e1537];
                                        phi_3427_ = _e1540;
                                    } else {
                                        phi_3427_ = 0u;
                                    }
                                    let _e1542 = phi_3427_;
                                    let _e1543 = (_e1498 + _e220);
                                    if (_e1543 < _e116) {
                                        let _e1546 = slimbvh_triangles.member[_e1543];
                                        phi_3440_ = _e1546;
                                    } else {
                                        phi_3440_ = 0u;
                                    }
                                    let _e1548 = phi_3440_;
                                    let _e1559 = (_e1500 + _e224);
                                    if (_e1559 < _e116) {
                                        let _e1562 = slimbvh_triangles.member[_e1559];
                                        phi_3466_ = _e1562;
                                    } else {
                                        phi_3466_ = 0u;
                                    }
                                    let _e1564 = phi_3466_;
                                    let _e1565 = (_e1500 + _e228);
                                    if (_e1565 < _e116) {
                                        let _e1568 = slimbvh_triangles.member[_e1565];
                                        phi_3479_ = _e1568;
                                    } else {
                                        phi_3479_ = 0u;
                                    }
                                    let _e1570 = phi_3479_;
                                    let _e1571 = (_e1500 + _e220);
                                    if (_e1571 < _e116) {
                                        let _e1574 = slimbvh_triangles.member[_e1571];
                                        phi_3492_ = _e1574;
                                    } else {
                                        phi_3492_ = 0u;
                                    }
                                    let _e1576 = phi_3492_;
                                    phi_3504_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1508)) * _e164), (f32(bitcast<i32>(_e1514)) * _e164), (f32(bitcast<i32>(_e1520)) * _e164)), array<f32, 3>((f32(bitcast<i32>(_e1536)) * _e164), (f32(bitcast<i32>(_e1542)) * _e164), (f32(bitcast<i32>(_e1548)) * _e164)), array<f32, 3>((f32(bitcast<i32>(_e1564)) * _e164), (f32(bitcast<i32>(_e1570)) * _e164), (f32(bitcast<i32>(_e1576)) * _e164)));
                                    break;
                                }
                                default: {
                                    phi_3504_ = array<array<f32, 3>, 3>();
                                    break;
                                }
                            }
                            let _e1876 = phi_3504_;
                            let _e1893 = (_e1876[0][2] - _e612.member[2]);
                            let _e1896 = (((_e1876[0][0] - _e612.member[0]) * _e667) - (_e1893 * _e635));
                            let _e1899 = (((_e1876[0][1] - _e612.member[1]) * _e667) - (_e1893 * _e651));
                            let _e1902 = (_e1876[1][2] - _e612.member[2]);
                            let _e1905 = (((_e1876[1][0] - _e612.member[0]) * _e667) - (_e1902 * _e635));
                            let _e1908 = (((_e1876[1][1] - _e612.member[1]) * _e667) - (_e1902 * _e651));
                            let _e1911 = (_e1876[2][2] - _e612.member[2]);
                            let _e1914 = (((_e1876[2][0] - _e612.member[0]) * _e667) - (_e1911 * _e635));
                            let _e1917 = (((_e1876[2][1] - _e612.member[1]) * _e667) - (_e1911 * _e651));
                            let _e1918 = (_e1914 * _e1908);
                            let _e1919 = (_e1917 * _e1905);
                            let _e1920 = (_e1896 * _e1917);
                            let _e1921 = (_e1899 * _e1914);
                            let _e1922 = (_e1905 * _e1899);
                            let _e1923 = (_e1908 * _e1896);
                            let _e1928 = (((_e1918 >= _e1919) && (_e1920 >= _e1921)) && (_e1922 >= _e1923));
                            let _e1934 = (_e1928 || (((_e1918 <= _e1919) && (_e1920 <= _e1921)) && (_e1922 <= _e1923)));
                            if _e1934 {
                                let _e1936 = select(-1f, 1f, _e1928);
                                let _e1938 = ((_e1918 - _e1919) * _e1936);
                                let _e1940 = select(0f, _e1938, (_e1938 > 0f));
                                let _e1942 = ((_e1920 - _e1921) * _e1936);
                                let _e1944 = select(0f, _e1942, (_e1942 > 0f));
                                let _e1946 = ((_e1922 - _e1923) * _e1936);
                                let _e1948 = select(0f, _e1946, (_e1946 > 0f));
                                let _e1950 = ((_e1940 + _e1944) + _e1948);
                                let _e1965 = ((min(min(_e1876[0][0], _e1876[1][0]), _e1876[2][0]) - _e636) * _e639);
                                let _e1966 = ((max(max(_e1876[0][0], _e1876[1][0]), _e1876[2][0]) - _e637) * _e639);
                                let _e1967 = vec4<f32>(_e1965, f32(), _e1966, f32());
                                let _e1970 = ((min(min(_e1876[0][1], _e1876[1][1]), _e1876[2][1]) - _e652) * _e655);
                                let _e1971 = ((max(max(_e1876[0][1], _e1876[1][1]), _e1876[2][1]) - _e653) * _e655);
                                let _e1972 = vec4<f32>(_e1970, f32(), _e1971, f32());
                                let _e1975 = ((min(min(_e1876[0][2], _e1876[1][2]), _e1876[2][2]) - _e668) * _e671);
                                let _e1976 = ((max(max(_e1876[0][2], _e1876[1][2]), _e1876[2][2]) - _e669) * _e671);
                                let _e1977 = vec4<f32>(_e1975, f32(), _e1976, f32());
                                let _e1978 = vec4<f32>(_e1966, f32(), _e1965, f32());
                                let _e1980 = vec4<f32>(_e1971, f32(), _e1970, f32());
                                let _e1982 = vec4<f32>(_e1976, f32(), _e1975, f32());
                                let _e1991 = max(max(min(_e1967, _e1978).x, min(_e1972, _e1980).x), min(_e1977, _e1982).x);
                                let _e1996 = min(min(max(_e1967, _e1978).x, max(_e1972, _e1980).x), max(_e1977, _e1982).x);
                                let _e2001 = max(_e1991, _e679);
                                let _e2023 = (((((_e1934 && (_e1950 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1896, _e1905), _e1914) <= 0f) && (max(max(_e1896, _e1905), _e1914) >= 0f))) && ((min(min(_e1899, _e1908), _e1917) <= 0f) && (max(max(_e1899, _e1908), _e1917) >= 0f))) && (_e2001 <= (_e1996 + (max(max(_e1977, _e1982).x, -(min(_e1977, _e1982).x)) * 0.0000019073523f)))) && (_e2001 <= _e1446.member.member_1));
                                if _e2023 {
                                    let _e2028 = (_e1876[1][0] - _e1876[0][0]);
                                    let _e2029 = (_e1876[1][1] - _e1876[0][1]);
                                    let _e2030 = (_e1876[1][2] - _e1876[0][2]);
                                    let _e2031 = vec3<f32>(_e2028, _e2029, _e2030);
                                    let _e2032 = (_e1876[2][0] - _e1876[1][0]);
                                    let _e2033 = (_e1876[2][1] - _e1876[1][1]);
                                    let _e2034 = (_e1876[2][2] - _e1876[1][2]);
                                    let _e2035 = vec3<f32>(_e2032, _e2033, _e2034);
                                    let _e2036 = (_e1876[0][0] - _e1876[2][0]);
                                    let _e2037 = (_e1876[0][1] - _e1876[2][1]);
                                    let _e2038 = (_e1876[0][2] - _e1876[2][2]);
                                    let _e2039 = vec3<f32>(_e2036, _e2037, _e2038);
                                    let _e2050 = max(max(bitcast<f32>((bitcast<u32>(_e2028) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2029) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2030) & 2147483647u)));
                                    let _e2061 = max(max(bitcast<f32>((bitcast<u32>(_e2032) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2033) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2034) & 2147483647u)));
                                    let _e2074 = max(max(_e2050, _e2061), max(max(bitcast<f32>((bitcast<u32>(_e2036) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2037) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2038) & 2147483647u))));
                                    if (_e2050 == _e2074) {
                                        phi_3869_ = _e1908;
                                        phi_3870_ = _e1905;
                                        phi_3871_ = _e1899;
                                        phi_3872_ = _e1896;
                                        phi_3873_ = vec3<f32>(_e1876[0][0], _e1876[0][1], _e1876[0][2]);
                                        phi_3874_ = _e2039;
                                        phi_3875_ = _e2035;
                                        phi_3876_ = _e2031;
                                    } else {
                                        let _e2076 = (_e2061 == _e2074);
                                        let _e2081 = vec3(_e2076);
                                        phi_3869_ = select(_e1899, _e1917, _e2076);
                                        phi_3870_ = select(_e1896, _e1914, _e2076);
                                        phi_3871_ = select(_e1917, _e1908, _e2076);
                                        phi_3872_ = select(_e1914, _e1905, _e2076);
                                        phi_3873_ = select(vec3<f32>(_e1876[2][0], _e1876[2][1], _e1876[2][2]), vec3<f32>(_e1876[1][0], _e1876[1][1], _e1876[1][2]), _e2081);
                                        phi_3874_ = select(_e2035, _e2031, _e2081);
                                        phi_3875_ = select(_e2031, _e2039, _e2081);
                                        phi_3876_ = select(_e2039, _e2035, _e2081);
                                    }
                                    let _e2087 = phi_3869_;
                                    let _e2089 = phi_3870_;
                                    let _e2091 = phi_3871_;
                                    let _e2093 = phi_3872_;
                                    let _e2095 = phi_3873_;
                                    let _e2097 = phi_3874_;
                                    let _e2099 = phi_3875_;
                                    let _e2101 = phi_3876_;
                                    let _e2108 = ((_e2099.y * _e2097.z) - (_e2097.y * _e2099.z));
                                    let _e2113 = ((_e2099.z * _e2097.x) - (_e2097.z * _e2099.x));
                                    let _e2116 = ((_e2099.x * _e2097.y) - (_e2097.x * _e2099.y));
                                    let _e2119 = ((_e1940 >= _e1944) && (_e1940 >= _e1948));
                                    let _e2120 = (_e1944 >= _e1948);
                                    let _e2134 = (((_e2108 * (select(select(_e1876[2][0], _e1876[1][0], _e2120), _e1876[0][0], _e2119) - _e612.member[0])) + (_e2113 * (select(select(_e1876[2][1], _e1876[1][1], _e2120), _e1876[0][1], _e2119) - _e612.member[1]))) + (_e2116 * (select(select(_e1876[2][2], _e1876[1][2], _e2120), _e1876[0][2], _e2119) - _e612.member[2])));
                                    let _e2139 = (((_e2108 * _e635) + (_e2113 * _e651)) + (_e2116 * _e667));
                                    let _e2140 = (_e2089 - _e2093);
                                    let _e2141 = (_e2087 - _e2091);
                                    let _e2144 = ((_e2140 * _e2140) + (_e2141 * _e2141));
                                    let _e2151 = (-(((_e2093 * _e2140) + (_e2091 * _e2141))) / select(0.000000000000000000000000000000000000011754944f, _e2144, (_e2144 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e2153 = select(1f, _e2151, (_e2151 < 1f));
                                    let _e2155 = select(0f, _e2153, (_e2153 > 0f));
                                    let _e2164 = ((_e2095.x + (_e2101.x * _e2155)) - _e612.member[0]);
                                    let _e2167 = ((_e2095.y + (_e2101.y * _e2155)) - _e612.member[1]);
                                    let _e2170 = ((_e2095.z + (_e2101.z * _e2155)) - _e612.member[2]);
                                    let _e2235 = ((bitcast<f32>((bitcast<u32>(((((_e2108 * _e2164) + (_e2113 * _e2167)) + (_e2116 * _e2170)) - _e2134)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e2164) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2167) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2170) & 2147483647u))), _e2074)) * max(max(bitcast<f32>((bitcast<u32>(_e2108) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2113) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2116) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e2139) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e2099.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2099.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2099.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e2097.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2097.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2097.z) & 2147483647u)))))));
                                    let _e2236 = (_e2134 / _e2139);
                                    if (_e2023 && !(_e2235)) {
                                        let _e2239 = (_e2170 / _e667);
                                        let _e2247 = (((_e2108 * (_e2164 - (_e635 * _e2239))) + (_e2113 * (_e2167 - (_e651 * _e2239)))) / _e2139);
                                        phi_4055_ = select(select(_e2239, (_e2239 + _e2247), (bitcast<f32>((bitcast<u32>(_e2247) & 2147483647u)) <= _e2074)), _e2236, _e2235);
                                    } else {
                                        phi_4055_ = _e2236;
                                    }
                                    let _e2256 = phi_4055_;
                                    let _e2258 = select(_e1996, _e2256, (_e2256 < _e1996));
                                    let _e2260 = select(_e1991, _e2258, (_e2258 > _e1991));
                                    let _e2263 = select(_e2260, 0f, (bitcast<u32>(_e2260) == 2147483648u));
                                    let _e2264 = (1f / _e1950);
                                    phi_4081_ = SlimbvhTypeE(_e2263, (_e1944 * _e2264), (_e1948 * _e2264), ((_e2023 && (_e2263 >= _e679)) && (_e2263 <= _e1446.member.member_1)));
                                    phi_4082_ = SlimbvhTypeE();
                                } else {
                                    phi_4081_ = SlimbvhTypeE();
                                    phi_4082_ = SlimbvhTypeE(0f, 0f, 0f, _e2023);
                                }
                                let _e2273 = phi_4081_;
                                let _e2275 = phi_4082_;
                                phi_4085_ = _e2273;
                                phi_4086_ = _e2275;
                                phi_4087_ = select(true, false, _e2023);
                            } else {
                                phi_4085_ = SlimbvhTypeE();
                                phi_4086_ = SlimbvhTypeE(0f, 0f, 0f, _e1934);
                                phi_4087_ = true;
                            }
                            let _e2278 = phi_4085_;
                            let _e2280 = phi_4086_;
                            let _e2282 = phi_4087_;
                            if _e2282 {
                                phi_4091_ = _e2280;
                            } else {
                                phi_4091_ = _e2278;
                            }
                            let _e2284 = phi_4091_;
                            if _e2284.member_3 {
                                phi_4100_ = SlimbvhTypeF(_e2284.member, _e2284.member_1, _e2284.member_2, _e1487);
                            } else {
                                phi_4100_ = _e109;
                            }
                            let _e2291 = phi_4100_;
                            if (_e2291.member_3 != 4294967295u) {
                                let _e2297 = slimbvh_target.member[0u][0u];
                                let _e2301 = slimbvh_target.member[0u][1u];
                                let _e2305 = slimbvh_target.member[0u][2u];
                                let _e2309 = slimbvh_target.member[0u][3u];
                                let _e2313 = slimbvh_target.member[1u][0u];
                                let _e2317 = slimbvh_target.member[1u][1u];
                                let _e2321 = slimbvh_target.member[1u][2u];
                                let _e2325 = slimbvh_target.member[1u][3u];
                                let _e2326 = bitcast<f32>(_e2297);
                                let _e2327 = bitcast<f32>(_e2301);
                                let _e2328 = bitcast<f32>(_e2305);
                                let _e2330 = bitcast<f32>(_e2313);
                                let _e2331 = array<u32, 3>(_e2317, _e2321, _e2325);
                                if (_e182 < -126i) {
                                    phi_4153_ = -126i;
                                } else {
                                    phi_4153_ = select(_e182, 127i, (_e182 > 127i));
                                }
                                let _e2337 = phi_4153_;
                                let _e2342 = bitcast<f32>((bitcast<u32>((_e2337 + 127i)) << bitcast<u32>(23i)));
                                let _e2348 = bitcast<f32>((bitcast<u32>(((_e182 - _e2337) + 127i)) << bitcast<u32>(23i)));
                                if (_e2309 == 0u) {
                                    phi_4293_ = SlimbvhTypeH(array<f32, 3>(_e2326, _e2327, _e2328), _e2309, _e2330, _e2331);
                                } else {
                                    let _e2350 = bitcast<u32>(_e2326);
                                    let _e2352 = ((_e2350 & 2139095040u) != 0u);
                                    let _e2367 = bitcast<u32>(_e2327);
                                    let _e2369 = ((_e2367 & 2139095040u) != 0u);
                                    let _e2384 = bitcast<u32>(_e2328);
                                    let _e2386 = ((_e2384 & 2139095040u) != 0u);
                                    let _e2402 = bitcast<u32>(_e2330);
                                    let _e2404 = ((_e2402 & 2139095040u) != 0u);
                                    phi_4293_ = SlimbvhTypeH(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2350 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2350 & 2147483648u))), _e2326, _e2352) * _e2342) * select(0.00000011920929f, 1f, _e2352)) * _e2348), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2367 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2367 & 2147483648u))), _e2327, _e2369) * _e2342) * select(0.00000011920929f, 1f, _e2369)) * _e2348), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2384 & 2147483648u))), _e2328, _e2386) * _e2342) * select(0.00000011920929f, 1f, _e2386)) * _e2348)), _e2309, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2402 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2402 & 2147483648u))), _e2330, _e2404) * _e2342) * select(0.00000011920929f, 1f, _e2404)) * _e2348), _e2331);
                                }
                                let _e2421 = phi_4293_;
                                if (_e1487 == _e683) {
                                    phi_4622_ = false;
                                } else {
                                    let _e2423 = (_e1487 / 16u);
                                    if (_e2423 < arrayLength((&slimbvh_sides.member))) {
                                        let _e2426 = slimbvh_sides.member[_e2423];
                                        phi_4317_ = _e2426;
                                    } else {
                                        phi_4317_ = 0u;
                                    }
                                    let _e2428 = phi_4317_;
                                    let _e2437 = (bitcast<i32>((_e2428 << bitcast<u32>(((30u - ((_e1487 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                    let _e2438 = (_e2437 == 0i);
                                    if _e2438 {
                                        phi_4621_ = true;
                                    } else {
                                        if _e229 {
                                            phi_4347_ = vec3<f32>(_e1876[0][0], _e1876[0][1], _e1876[0][2]);
                                        } else {
                                            if (_e224 == 1u) {
                                                phi_4346_ = vec3<f32>(_e1876[0][2], _e1876[0][0], _e1876[0][1]);
                                            } else {
                                                phi_4346_ = vec3<f32>(_e1876[0][1], _e1876[0][2], _e1876[0][0]);
                                            }
                                            let _e2443 = phi_4346_;
                                            phi_4347_ = _e2443;
                                        }
                                        let _e2446 = phi_4347_;
                                        if _e229 {
                                            phi_4366_ = vec3<f32>(_e1876[1][0], _e1876[1][1], _e1876[1][2]);
                                        } else {
                                            if (_e224 == 1u) {
                                                phi_4365_ = vec3<f32>(_e1876[1][2], _e1876[1][0], _e1876[1][1]);
                                            } else {
                                                phi_4365_ = vec3<f32>(_e1876[1][1], _e1876[1][2], _e1876[1][0]);
                                            }
                                            let _e2451 = phi_4365_;
                                            phi_4366_ = _e2451;
                                        }
                                        let _e2454 = phi_4366_;
                                        if _e229 {
                                            phi_4385_ = vec3<f32>(_e1876[2][0], _e1876[2][1], _e1876[2][2]);
                                        } else {
                                            if (_e224 == 1u) {
                                                phi_4384_ = vec3<f32>(_e1876[2][2], _e1876[2][0], _e1876[2][1]);
                                            } else {
                                                phi_4384_ = vec3<f32>(_e1876[2][1], _e1876[2][2], _e1876[2][0]);
                                            }
                                            let _e2459 = phi_4384_;
                                            phi_4385_ = _e2459;
                                        }
                                        let _e2462 = phi_4385_;
                                        let _e2465 = (_e2454.x - _e2446.x);
                                        let _e2468 = (_e2454.y - _e2446.y);
                                        let _e2471 = (_e2454.z - _e2446.z);
                                        let _e2473 = (_e2462.x - _e2446.x);
                                        let _e2475 = (_e2462.y - _e2446.y);
                                        let _e2477 = (_e2462.z - _e2446.z);
                                        if (_e2421.member_1 == 1u) {
                                            phi_4421_ = (vec3<f32>(_e2421.member[0], _e2421.member[1], _e2421.member[2]) - _e2446);
                                        } else {
                                            phi_4421_ = vec3<f32>(_e2421.member[0], _e2421.member[1], _e2421.member[2]);
                                        }
                                        let _e2492 = phi_4421_;
                                        let _e2498 = bitcast<f32>((bitcast<u32>((_e2465 * _e2475)) ^ _e2421.member_3[0]));
                                        let _e2502 = bitcast<f32>((bitcast<u32>((_e2468 * _e2473)) ^ _e2421.member_3[0]));
                                        let _e2506 = bitcast<f32>((bitcast<u32>((_e2468 * _e2477)) ^ _e2421.member_3[0]));
                                        let _e2510 = bitcast<f32>((bitcast<u32>((_e2471 * _e2475)) ^ _e2421.member_3[0]));
                                        let _e2514 = bitcast<f32>((bitcast<u32>((_e2471 * _e2473)) ^ _e2421.member_3[0]));
                                        let _e2518 = bitcast<f32>((bitcast<u32>((_e2465 * _e2477)) ^ _e2421.member_3[0]));
                                        let _e2519 = (_e2506 - _e2510);
                                        let _e2520 = (_e2514 - _e2518);
                                        let _e2521 = (_e2498 - _e2502);
                                        let _e2545 = (bitcast<f32>((bitcast<u32>(_e2506) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2510) & 2147483647u)));
                                        let _e2552 = (bitcast<f32>((bitcast<u32>(_e2514) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2518) & 2147483647u)));
                                        let _e2559 = (bitcast<f32>((bitcast<u32>(_e2498) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2502) & 2147483647u)));
                                        if (_e2421.member_2 == 0f) {
                                            phi_4603_ = 0f;
                                        } else {
                                            let _e2589 = bitcast<f32>((bitcast<u32>(_e2519) & 2147483647u));
                                            let _e2592 = bitcast<f32>((bitcast<u32>(_e2520) & 2147483647u));
                                            let _e2595 = bitcast<f32>((bitcast<u32>(_e2521) & 2147483647u));
                                            let _e2597 = select(_e2595, _e2592, (_e2592 > _e2595));
                                            let _e2601 = select(_e2595, _e2592, (_e2592 < _e2595));
                                            let _e2605 = select(_e2592, _e2589, (_e2589 < _e2592));
                                            let _e2607 = select(_e2592, _e2589, (_e2589 > _e2592));
                                            let _e2609 = select(_e2595, _e2607, (_e2607 < _e2595));
                                            phi_4603_ = bitcast<f32>((bitcast<u32>((_e2421.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2597, _e2589, (_e2589 > _e2597)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2609, _e2605, (_e2605 > _e2609)))) ^ _e2421.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2601, _e2589, (_e2589 < _e2601)))) ^ _e2421.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2545 + _e2552) + _e2559))) ^ _e2421.member_3[0]))) * 1.0000005f)) ^ _e2421.member_3[0])))) ^ _e2421.member_3[0]));
                                        }
                                        let _e2636 = phi_4603_;
                                        phi_4621_ = (_e2438 || !(((((bitcast<f32>((bitcast<u32>((_e2492.x * _e2519)) ^ _e2421.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2492.y * _e2520)) ^ _e2421.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2492.z * _e2521)) ^ _e2421.member_3[0]))) * f32(-(_e2437))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2492.x) & 2147483647u)) * _e2545)) ^ _e2421.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2492.y) & 2147483647u)) * _e2552)) ^ _e2421.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2492.z) & 2147483647u)) * _e2559)) ^ _e2421.member_3[0]))))) ^ _e2421.member_3[0])) + _e2636) + 0.0000000000000000000000000000000000001880791f))));
                                    }
                                    let _e2650 = phi_4621_;
                                    phi_4622_ = _e2650;
                                }
                                let _e2652 = phi_4622_;
                                if _e2652 {
                                    if (_e2291.member < _e1446.member.member.member) {
                                        phi_4642_ = true;
                                    } else {
                                        if (_e2291.member == _e1446.member.member.member) {
                                            phi_4641_ = (_e2291.member_3 < _e1446.member.member.member_3);
                                        } else {
                                            phi_4641_ = false;
                                        }
                                        let _e2664 = phi_4641_;
                                        phi_4642_ = _e2664;
                                    }
                                    let _e2666 = phi_4642_;
                                    if _e2666 {
                                        phi_4649_ = SlimbvhTypeQ(SlimbvhTypeI(_e2291, _e2291.member), _e1446.member_1);
                                    } else {
                                        phi_4649_ = _e1446;
                                    }
                                    let _e2672 = phi_4649_;
                                    if _e2672.member_1 {
                                        phi_4655_ = SlimbvhTypeQ(SlimbvhTypeI(_e2672.member.member, bitcast<f32>(4286578687u)), _e2672.member_1);
                                    } else {
                                        phi_4655_ = _e2672;
                                    }
                                    let _e2681 = phi_4655_;
                                    phi_4656_ = _e2681;
                                } else {
                                    phi_4656_ = _e1446;
                                }
                                let _e2683 = phi_4656_;
                                phi_4657_ = _e2683;
                            } else {
                                phi_4657_ = _e1446;
                            }
                            let _e2685 = phi_4657_;
                            phi_2824_ = _e2685;
                        } else {
                            phi_2824_ = SlimbvhTypeQ();
                        }
                        let _e2687 = phi_2824_;
                        continue;
                        continuing {
                            phi_2823_ = _e2687;
                            phi_2826_ = _e1461;
                            break if !(_e1467);
                        }
                    }
                    let _e2690 = local_2;
                    let _e2691 = (_e2690 - 1u);
                    let _e2696 = slimbvh_stacks[(((_e2691 % 32u) * 64u) + _e686)];
                    let _e2697 = (_e2696 & 511u);
                    let _e2699 = (_e2697 >> bitcast<u32>(3u));
                    let _e2702 = ((_e2699 == 0u) || (_e2691 == 4294967295u));
                    if _e2702 {
                    } else {
                        slimbvh_stacks[(((_e2691 % 32u) * 64u) + _e686)] = (((_e2696 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2699);
                    }
                    let _e2709 = local_3;
                    let _e2717 = (((_e2696 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2697 & 3u) & 3u));
                    let _e2719 = (_e2717 >> bitcast<u32>(2i));
                    if (_e2719 < _e113) {
                        let _e2725 = slimbvh_nodes.member[_e2719].member_1[(_e2717 & 3u)];
                        if ((_e2725 & 2147483648u) != 0u) {
                            phi_4724_ = (2147483648u | _e2717);
                        } else {
                            phi_4724_ = _e2725;
                        }
                        let _e2730 = phi_4724_;
                        phi_4725_ = _e2730;
                    } else {
                        phi_4725_ = 4294967295u;
                    }
                    let _e2732 = phi_4725_;
                    let _e2734 = local_4;
                    let _e3046 = local_7;
                    phi_4734_ = _e3046;
                    phi_4735_ = select(select(_e2709, _e2691, _e2702), 4294967295u, (_e679 > _e2734.member.member_1));
                    phi_4736_ = _e2732;
                } else {
                    phi_4734_ = _e795;
                    let _e3049 = local_8;
                    phi_4735_ = _e3049;
                    let _e3052 = local_9;
                    phi_4736_ = _e3052;
                }
                let _e2740 = phi_4734_;
                let _e2742 = phi_4735_;
                let _e2744 = phi_4736_;
                phi_1718_ = _e2740;
                phi_1721_ = _e2742;
                phi_1723_ = _e2744;
                let _e3058 = local_10;
                phi_1725_ = _e3058;
            } else {
                phi_1718_ = SlimbvhTypeQ();
                phi_1721_ = u32();
                phi_1723_ = u32();
                phi_1725_ = u32();
            }
            let _e2746 = phi_1718_;
            let _e2748 = phi_1721_;
            let _e2750 = phi_1723_;
            let _e2752 = phi_1725_;
            continue;
            continuing {
                phi_1717_ = _e2746;
                phi_1720_ = _e2748;
                phi_1722_ = _e2750;
                phi_1724_ = _e2752;
                break if !(_e802);
            }
        }
        let _e2755 = local_5;
        let _e2756 = (_e2755 == 4294967295u);
        let _e2758 = local_6;
        if (_e2758.member.member.member_3 != 4294967295u) {
            let _e2764 = -((_e182 + _e612.member_4));
            let _e2765 = bitcast<u32>(_e2758.member.member.member);
            let _e2769 = (bitcast<i32>((_e2765 >> bitcast<u32>(23i))) & 255i);
            let _e2770 = (_e2769 + _e2764);
            if (_e2769 == 255i) {
                phi_4794_ = _e2758.member.member.member;
            } else {
                if (_e2769 > 0i) {
                    if (_e2770 > 0i) {
                        let _e2774 = (_e2770 < 255i);
                        if _e2774 {
                            phi_4773_ = bitcast<f32>((_e2765 + bitcast<u32>((_e2764 << bitcast<u32>(23i)))));
                        } else {
                            phi_4773_ = f32();
                        }
                        let _e2781 = phi_4773_;
                        phi_4775_ = _e2781;
                        phi_4776_ = select(true, false, _e2774);
                    } else {
                        phi_4775_ = f32();
                        phi_4776_ = true;
                    }
                    let _e2784 = phi_4775_;
                    let _e2786 = phi_4776_;
                    phi_4777_ = _e2784;
                    phi_4778_ = _e2786;
                } else {
                    phi_4777_ = f32();
                    phi_4778_ = true;
                }
                let _e2788 = phi_4777_;
                let _e2790 = phi_4778_;
                if _e2790 {
                    let _e2791 = (_e2765 & 2147483648u);
                    let _e2798 = ((_e2765 & 8388607u) | (select(0u, 1u, ((_e2765 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e2802 = (_e2798 == 0u);
                    if _e2802 {
                        phi_5476_ = bitcast<f32>(_e2791);
                    } else {
                        let _e2807 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2798)), 32u, _e2802) - 8u);
                        let _e2810 = (_e2798 << bitcast<u32>((_e2807 & 31u)));
                        let _e2812 = ((_e2770 + select(0i, 1i, (_e2769 == 0i))) - bitcast<i32>(_e2807));
                        if (_e2812 >= 255i) {
                            phi_5466_ = bitcast<f32>((_e2791 | 2139095040u));
                            phi_5467_ = f32();
                            phi_5468_ = true;
                        } else {
                            let _e2814 = (_e2812 > 0i);
                            if _e2814 {
                                phi_5460_ = bitcast<f32>(((_e2791 | (bitcast<u32>(_e2812) << bitcast<u32>(23i))) | (_e2810 & 8388607u)));
                                phi_5461_ = f32();
                            } else {
                                if (_e2812 < -24i) {
                                    phi_5426_ = 26u;
                                } else {
                                    phi_5426_ = bitcast<u32>((1i - _e2812));
                                }
                                let _e2819 = phi_5426_;
                                let _e2820 = (_e2819 & 31u);
                                let _e2822 = (_e2810 >> bitcast<u32>(_e2820));
                                let _e2826 = (_e2810 & ((1u << bitcast<u32>(_e2820)) - 1u));
                                let _e2830 = (1u << bitcast<u32>(((_e2819 - 1u) & 31u)));
                                if (_e2826 > _e2830) {
                                    phi_5447_ = true;
                                } else {
                                    if (_e2826 == _e2830) {
                                        phi_5444_ = ((_e2822 & 1u) == 1u);
                                    } else {
                                        phi_5444_ = false;
                                    }
                                    let _e2836 = phi_5444_;
                                    phi_5447_ = _e2836;
                                }
                                let _e2838 = phi_5447_;
                                phi_5460_ = f32();
                                phi_5461_ = bitcast<f32>((_e2791 | (_e2822 + select(0u, 1u, _e2838))));
                            }
                            let _e2851 = phi_5460_;
                            let _e2853 = phi_5461_;
                            phi_5466_ = _e2851;
                            phi_5467_ = _e2853;
                            phi_5468_ = _e2814;
                        }
                        let _e2857 = phi_5466_;
                        let _e2859 = phi_5467_;
                        let _e2861 = phi_5468_;
                        phi_5476_ = select(_e2859, _e2857, _e2861);
                    }
                    let _e2865 = phi_5476_;
                    phi_4793_ = _e2865;
                } else {
                    phi_4793_ = _e2788;
                }
                let _e2867 = phi_4793_;
                phi_4794_ = _e2867;
            }
            let _e2869 = phi_4794_;
            let _e2870 = bitcast<u32>(_e2869);
            if ((_e2870 & 2147483647u) >= 2139095040u) {
                phi_4806_ = bitcast<f32>(((_e2870 & 2147483648u) | 2139095039u));
            } else {
                phi_4806_ = _e2869;
            }
            let _e2877 = phi_4806_;
            phi_4811_ = SlimbvhTypeF(_e2877, _e2758.member.member.member_1, _e2758.member.member.member_2, _e2758.member.member.member_3);
        } else {
            phi_4811_ = _e109;
        }
        let _e2882 = phi_4811_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2882.member), bitcast<u32>(_e2882.member_1), bitcast<u32>(_e2882.member_2), _e2882.member_3);
        phi_4824_ = _e2756;
        phi_4825_ = _e2756;
        phi_4826_ = select(true, false, _e2756);
    } else {
        phi_4824_ = bool();
        phi_4825_ = false;
        phi_4826_ = true;
    }
    let _e2893 = phi_4824_;
    let _e2895 = phi_4825_;
    let _e2897 = phi_4826_;
    if _e2897 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e2893, _e2895, _e2897)));
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
