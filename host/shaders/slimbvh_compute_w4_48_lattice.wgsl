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
    var phi_610_: u32;
    var phi_616_: u32;
    var phi_622_: u32;
    var phi_887_: i32;
    var phi_898_: i32;
    var phi_1012_: i32;
    var phi_1141_: i32;
    var phi_1163_: u32;
    var phi_1164_: u32;
    var phi_1165_: bool;
    var phi_1199_: i32;
    var phi_1221_: u32;
    var phi_1222_: u32;
    var phi_1223_: bool;
    var phi_784_: i32;
    var phi_790_: u32;
    var phi_809_: u32;
    var phi_810_: u32;
    var phi_811_: bool;
    var phi_829_: i32;
    var phi_835_: u32;
    var phi_854_: u32;
    var phi_855_: u32;
    var phi_856_: bool;
    var phi_1233_: SlimbvhTypeC;
    var phi_1479_: SlimbvhTypeP;
    var phi_1542_: array<f32, 3>;
    var phi_1543_: array<f32, 3>;
    var phi_1561_: array<f32, 3>;
    var phi_1562_: array<f32, 3>;
    var phi_1735_: SlimbvhTypeP;
    var phi_1738_: u32;
    var phi_1740_: u32;
    var phi_1742_: u32;
    var phi_1751_: u32;
    var phi_1754_: u32;
    var phi_1756_: u32;
    var phi_1863_: SlimbvhTypeJ;
    var phi_1864_: SlimbvhTypeJ;
    var phi_1923_: SlimbvhTypeJ;
    var phi_1924_: SlimbvhTypeJ;
    var phi_1983_: SlimbvhTypeJ;
    var phi_1984_: SlimbvhTypeJ;
    var phi_2474_: u32;
    var phi_2487_: u32;
    var phi_2500_: u32;
    var phi_2513_: u32;
    var phi_5259_: SlimbvhTypeD;
    var phi_5271_: SlimbvhTypeD;
    var phi_5283_: SlimbvhTypeD;
    var phi_5295_: SlimbvhTypeD;
    var phi_5307_: SlimbvhTypeD;
    var phi_2597_: u32;
    var phi_2602_: u32;
    var phi_2603_: u32;
    var phi_2657_: u32;
    var phi_2658_: u32;
    var phi_1752_: u32;
    var phi_1755_: u32;
    var phi_1757_: u32;
    var local: bool;
    var local_1: u32;
    var phi_2843_: u32;
    var phi_2848_: u32;
    var phi_2891_: SlimbvhTypeM;
    var phi_2898_: SlimbvhTypeP;
    var phi_2901_: SlimbvhTypeD;
    var phi_2902_: SlimbvhTypeD;
    var phi_2924_: SlimbvhTypeD;
    var phi_2949_: u32;
    var phi_2972_: u32;
    var phi_2981_: u32;
    var phi_2991_: u32;
    var phi_3450_: u32;
    var phi_3463_: u32;
    var phi_3476_: u32;
    var phi_3502_: u32;
    var phi_3515_: u32;
    var phi_3528_: u32;
    var phi_3554_: u32;
    var phi_3567_: u32;
    var phi_3580_: u32;
    var phi_3172_: u32;
    var phi_3185_: u32;
    var phi_3195_: u32;
    var phi_3216_: u32;
    var phi_3237_: u32;
    var phi_3264_: u32;
    var phi_3277_: u32;
    var phi_3287_: u32;
    var phi_3308_: u32;
    var phi_3329_: u32;
    var phi_3356_: u32;
    var phi_3369_: u32;
    var phi_3379_: u32;
    var phi_3400_: u32;
    var phi_3421_: u32;
    var phi_3033_: u32;
    var phi_3079_: u32;
    var phi_3125_: u32;
    var phi_3592_: array<array<f32, 3>, 3>;
    var phi_3957_: f32;
    var phi_3958_: f32;
    var phi_3959_: f32;
    var phi_3960_: f32;
    var phi_3961_: vec3<f32>;
    var phi_3962_: vec3<f32>;
    var phi_3963_: vec3<f32>;
    var phi_3964_: vec3<f32>;
    var phi_4143_: f32;
    var phi_4169_: SlimbvhTypeE;
    var phi_4170_: SlimbvhTypeE;
    var phi_4173_: SlimbvhTypeE;
    var phi_4174_: SlimbvhTypeE;
    var phi_4175_: bool;
    var phi_4179_: SlimbvhTypeE;
    var phi_4188_: SlimbvhTypeF;
    var phi_4241_: i32;
    var phi_4381_: SlimbvhTypeH;
    var phi_4405_: u32;
    var phi_4434_: vec3<f32>;
    var phi_4435_: vec3<f32>;
    var phi_4453_: vec3<f32>;
    var phi_4454_: vec3<f32>;
    var phi_4472_: vec3<f32>;
    var phi_4473_: vec3<f32>;
    var phi_4509_: vec3<f32>;
    var phi_4691_: f32;
    var phi_4709_: bool;
    var phi_4710_: bool;
    var phi_4729_: bool;
    var phi_4730_: bool;
    var phi_4737_: SlimbvhTypeP;
    var phi_4743_: SlimbvhTypeP;
    var phi_4744_: SlimbvhTypeP;
    var phi_4745_: SlimbvhTypeP;
    var phi_2899_: SlimbvhTypeP;
    var local_2: u32;
    var local_3: u32;
    var phi_4836_: u32;
    var phi_4837_: u32;
    var local_4: SlimbvhTypeP;
    var phi_4846_: SlimbvhTypeP;
    var phi_4847_: u32;
    var phi_4848_: u32;
    var phi_1736_: SlimbvhTypeP;
    var phi_1739_: u32;
    var phi_1741_: u32;
    var phi_1743_: u32;
    var local_5: u32;
    var local_6: SlimbvhTypeP;
    var phi_4885_: f32;
    var phi_4887_: f32;
    var phi_4888_: bool;
    var phi_4889_: f32;
    var phi_4890_: bool;
    var phi_5538_: u32;
    var phi_5556_: bool;
    var phi_5559_: bool;
    var phi_5572_: f32;
    var phi_5573_: f32;
    var phi_5578_: f32;
    var phi_5579_: f32;
    var phi_5580_: bool;
    var phi_5588_: f32;
    var phi_4905_: f32;
    var phi_4906_: f32;
    var phi_4918_: f32;
    var phi_4923_: SlimbvhTypeF;
    var phi_4936_: bool;
    var phi_4937_: bool;
    var phi_4938_: bool;
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
    let _e181 = slimbvh_exponent.member[1u];
    let _e184 = slimbvh_exponent.member[2u];
    let _e185 = slimbvh_origin.member;
    let _e191 = slimbvh_origin.member[3u];
    let _e192 = slimbvh_direction.member;
    let _e198 = slimbvh_direction.member[3u];
    let _e201 = slimbvh_exponent.member[0u];
    let _e202 = bitcast<i32>(_e201);
    let _e204 = (bitcast<u32>(_e185.x) & 2147483647u);
    let _e206 = (bitcast<u32>(_e185.y) & 2147483647u);
    let _e208 = (bitcast<u32>(_e185.z) & 2147483647u);
    let _e209 = bitcast<u32>(_e191);
    let _e210 = (_e209 & 2147483647u);
    let _e212 = (bitcast<u32>(_e192.x) & 2147483647u);
    let _e214 = (bitcast<u32>(_e192.y) & 2147483647u);
    let _e216 = (bitcast<u32>(_e192.z) & 2147483647u);
    let _e217 = bitcast<u32>(_e198);
    let _e218 = (_e217 & 2147483647u);
    let _e220 = select(_e214, _e212, (_e214 < _e212));
    let _e222 = select(_e216, _e220, (_e216 < _e220));
    let _e224 = select(_e204, _e222, (_e204 < _e222));
    let _e226 = select(_e206, _e224, (_e206 < _e224));
    let _e228 = select(_e208, _e226, (_e208 < _e226));
    let _e235 = (((select(_e210, _e228, (_e210 < _e228)) < 2139095040u) && (_e218 <= 2139095040u)) && (_e222 > 0u));
    if (_e212 == _e222) {
        phi_610_ = 0u;
    } else {
        phi_610_ = select(2u, 1u, (_e214 == _e222));
    }
    let _e240 = phi_610_;
    let _e241 = (_e240 == 2u);
    if _e241 {
        phi_616_ = 0u;
    } else {
        phi_616_ = (_e240 + 1u);
    }
    let _e244 = phi_616_;
    let _e245 = (_e244 == 2u);
    if _e245 {
        phi_622_ = 0u;
    } else {
        phi_622_ = (_e244 + 1u);
    }
    let _e248 = phi_622_;
    let _e249 = (_e244 == 0u);
    let _e251 = select(select(_e185.y, _e185.x, _e249), _e185.z, _e245);
    let _e252 = (_e248 == 0u);
    let _e254 = (_e248 == 2u);
    let _e255 = select(select(_e185.y, _e185.x, _e252), _e185.z, _e254);
    let _e256 = (_e240 == 0u);
    let _e258 = select(select(_e185.y, _e185.x, _e256), _e185.z, _e241);
    let _e260 = select(select(_e192.y, _e192.x, _e249), _e192.z, _e245);
    let _e262 = select(select(_e192.y, _e192.x, _e252), _e192.z, _e254);
    let _e264 = select(select(_e192.y, _e192.x, _e256), _e192.z, _e241);
    let _e265 = (_e210 - 1u);
    let _e266 = (_e218 - 1u);
    let _e268 = select(_e265, _e266, (_e266 < _e265));
    let _e269 = (_e204 - 1u);
    let _e270 = (_e206 - 1u);
    let _e272 = select(_e269, _e270, (_e270 < _e269));
    let _e273 = (_e208 - 1u);
    let _e275 = select(_e272, _e273, (_e273 < _e272));
    let _e276 = (_e212 - 1u);
    let _e277 = (_e214 - 1u);
    let _e279 = select(_e276, _e277, (_e277 < _e276));
    let _e280 = (_e216 - 1u);
    let _e282 = select(_e279, _e280, (_e280 < _e279));
    let _e284 = select(_e275, _e282, (_e282 < _e275));
    if (((select(_e284, _e268, (_e268 < _e284)) >= 8388607u) && (_e222 < 2130706432u)) && (bitcast<u32>((_e202 + 126i)) <= 253u)) {
        let _e549 = bitcast<i32>((_e222 >> bitcast<u32>(23i)));
        let _e550 = (_e549 - 127i);
        let _e551 = (_e202 + _e550);
        let _e556 = bitcast<f32>((bitcast<u32>((_e202 + 127i)) << bitcast<u32>(23i)));
        let _e561 = bitcast<f32>((bitcast<u32>((254i - _e549)) << bitcast<u32>(23i)));
        if (_e210 >= 2139095040u) {
            phi_784_ = 255i;
        } else {
            phi_784_ = (bitcast<i32>((_e210 >> bitcast<u32>(23i))) + _e551);
        }
        let _e576 = phi_784_;
        if (_e210 == 0u) {
            phi_790_ = 0u;
        } else {
            phi_790_ = (_e210 | 8388608u);
        }
        let _e580 = phi_790_;
        if (_e576 <= 0i) {
            phi_810_ = u32();
            phi_811_ = true;
        } else {
            let _e587 = (_e580 == 0u);
            if _e587 {
                phi_809_ = u32();
            } else {
                phi_809_ = select(((bitcast<u32>(_e576) << bitcast<u32>(23i)) | (_e580 & 8388607u)), 2139095039u, (_e576 >= 255i));
            }
            let _e591 = phi_809_;
            phi_810_ = _e591;
            phi_811_ = _e587;
        }
        let _e593 = phi_810_;
        let _e595 = phi_811_;
        if (_e218 >= 2139095040u) {
            phi_829_ = 255i;
        } else {
            phi_829_ = (bitcast<i32>((_e218 >> bitcast<u32>(23i))) + _e551);
        }
        let _e606 = phi_829_;
        if (_e218 == 0u) {
            phi_835_ = 0u;
        } else {
            phi_835_ = (_e218 | 8388608u);
        }
        let _e610 = phi_835_;
        if (_e606 <= 0i) {
            phi_855_ = u32();
            phi_856_ = true;
        } else {
            let _e617 = (_e610 == 0u);
            if _e617 {
                phi_854_ = u32();
            } else {
                phi_854_ = select(((bitcast<u32>(_e606) << bitcast<u32>(23i)) | (_e610 & 8388607u)), 2139095039u, (_e606 >= 255i));
            }
            let _e621 = phi_854_;
            phi_855_ = _e621;
            phi_856_ = _e617;
        }
        let _e623 = phi_855_;
        let _e625 = phi_856_;
        phi_1233_ = SlimbvhTypeC(array<f32, 3>((_e251 * _e556), (_e255 * _e556), (_e258 * _e556)), array<f32, 3>((_e260 * _e561), (_e262 * _e561), (_e264 * _e561)), bitcast<f32>(((_e209 & 2147483648u) | select(_e593, 0u, _e595))), bitcast<f32>(((_e217 & 2147483648u) | select(_e623, 0u, _e625))), _e550);
    } else {
        let _e297 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e222, _e235))) & 2147483647u);
        if (_e297 >= 8388608u) {
            phi_887_ = (bitcast<i32>((_e297 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_887_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e297)), 32u, (_e297 == 0u))));
        }
        let _e311 = phi_887_;
        let _e312 = (_e202 + _e311);
        if (_e202 < -126i) {
            phi_898_ = -126i;
        } else {
            phi_898_ = select(_e202, 127i, (_e202 > 127i));
        }
        let _e317 = phi_898_;
        let _e322 = bitcast<f32>((bitcast<u32>((_e317 + 127i)) << bitcast<u32>(23i)));
        let _e328 = bitcast<f32>((bitcast<u32>(((_e202 - _e317) + 127i)) << bitcast<u32>(23i)));
        let _e329 = bitcast<u32>(_e251);
        let _e331 = ((_e329 & 2139095040u) != 0u);
        let _e346 = bitcast<u32>(_e255);
        let _e348 = ((_e346 & 2139095040u) != 0u);
        let _e363 = bitcast<u32>(_e258);
        let _e365 = ((_e363 & 2139095040u) != 0u);
        let _e381 = -(_e311);
        if (_e381 < -126i) {
            phi_1012_ = -126i;
        } else {
            phi_1012_ = select(_e381, 127i, (_e381 > 127i));
        }
        let _e386 = phi_1012_;
        let _e391 = bitcast<f32>((bitcast<u32>((_e386 + 127i)) << bitcast<u32>(23i)));
        let _e397 = bitcast<f32>((bitcast<u32>(((_e381 - _e386) + 127i)) << bitcast<u32>(23i)));
        let _e398 = bitcast<u32>(_e260);
        let _e400 = ((_e398 & 2139095040u) != 0u);
        let _e415 = bitcast<u32>(_e262);
        let _e417 = ((_e415 & 2139095040u) != 0u);
        let _e432 = bitcast<u32>(_e264);
        let _e434 = ((_e432 & 2139095040u) != 0u);
        let _e456 = ((_e210 & 8388607u) | (select(0u, 1u, ((_e210 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e459 = bitcast<i32>((_e210 >> bitcast<u32>(23i)));
        let _e466 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e456)), 32u, (_e456 == 0u))) - 8i);
        if (_e459 == 255i) {
            phi_1141_ = 255i;
        } else {
            phi_1141_ = (((_e459 + select(0i, 1i, (_e459 == 0i))) - _e466) + _e312);
        }
        let _e474 = phi_1141_;
        let _e478 = (_e456 << bitcast<u32>(((_e466 & 31i) & 31i)));
        if (_e474 <= 0i) {
            phi_1164_ = u32();
            phi_1165_ = true;
        } else {
            let _e485 = (_e478 == 0u);
            if _e485 {
                phi_1163_ = u32();
            } else {
                phi_1163_ = select(((bitcast<u32>(_e474) << bitcast<u32>(23i)) | (_e478 & 8388607u)), 2139095039u, (_e474 >= 255i));
            }
            let _e489 = phi_1163_;
            phi_1164_ = _e489;
            phi_1165_ = _e485;
        }
        let _e491 = phi_1164_;
        let _e493 = phi_1165_;
        let _e504 = ((_e218 & 8388607u) | (select(0u, 1u, ((_e218 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e507 = bitcast<i32>((_e218 >> bitcast<u32>(23i)));
        let _e514 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e504)), 32u, (_e504 == 0u))) - 8i);
        if (_e507 == 255i) {
            phi_1199_ = 255i;
        } else {
            phi_1199_ = (((_e507 + select(0i, 1i, (_e507 == 0i))) - _e514) + _e312);
        }
        let _e522 = phi_1199_;
        let _e526 = (_e504 << bitcast<u32>(((_e514 & 31i) & 31i)));
        if (_e522 <= 0i) {
            phi_1222_ = u32();
            phi_1223_ = true;
        } else {
            let _e533 = (_e526 == 0u);
            if _e533 {
                phi_1221_ = u32();
            } else {
                phi_1221_ = select(((bitcast<u32>(_e522) << bitcast<u32>(23i)) | (_e526 & 8388607u)), 2139095039u, (_e522 >= 255i));
            }
            let _e537 = phi_1221_;
            phi_1222_ = _e537;
            phi_1223_ = _e533;
        }
        let _e539 = phi_1222_;
        let _e541 = phi_1223_;
        phi_1233_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e329 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e329 & 2147483648u))), _e251, _e331) * _e322) * select(0.00000011920929f, 1f, _e331)) * _e328), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e346 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e346 & 2147483648u))), _e255, _e348) * _e322) * select(0.00000011920929f, 1f, _e348)) * _e328), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e363 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e363 & 2147483648u))), _e258, _e365) * _e322) * select(0.00000011920929f, 1f, _e365)) * _e328)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e398 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e398 & 2147483648u))), _e260, _e400) * _e391) * select(0.00000011920929f, 1f, _e400)) * _e397), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e415 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e415 & 2147483648u))), _e262, _e417) * _e391) * select(0.00000011920929f, 1f, _e417)) * _e397), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e432 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e432 & 2147483648u))), _e264, _e434) * _e391) * select(0.00000011920929f, 1f, _e434)) * _e397)), bitcast<f32>(((_e209 & 2147483648u) | select(_e491, 0u, _e493))), bitcast<f32>(((_e217 & 2147483648u) | select(_e539, 0u, _e541))), _e311);
    }
    let _e632 = phi_1233_;
    let _e647 = (bitcast<f32>((bitcast<u32>(_e632.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e650 = bitcast<f32>((bitcast<u32>(_e632.member[0]) & 2147483647u));
    let _e651 = (_e650 * 0.00000011920929f);
    let _e654 = select(select(0.00000000000011368684f, _e651, (_e651 > 0.00000000000011368684f)), 0f, _e647);
    let _e655 = select(0f, _e632.member_1[0], _e647);
    let _e656 = (_e632.member[0] + _e654);
    let _e657 = (_e632.member[0] - _e654);
    let _e659 = select(38685626000000000000000000f, (1f / _e632.member_1[0]), _e647);
    let _e663 = (bitcast<f32>((bitcast<u32>(_e632.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e666 = bitcast<f32>((bitcast<u32>(_e632.member[1]) & 2147483647u));
    let _e667 = (_e666 * 0.00000011920929f);
    let _e670 = select(select(0.00000000000011368684f, _e667, (_e667 > 0.00000000000011368684f)), 0f, _e663);
    let _e671 = select(0f, _e632.member_1[1], _e663);
    let _e672 = (_e632.member[1] + _e670);
    let _e673 = (_e632.member[1] - _e670);
    let _e675 = select(38685626000000000000000000f, (1f / _e632.member_1[1]), _e663);
    let _e679 = (bitcast<f32>((bitcast<u32>(_e632.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e682 = bitcast<f32>((bitcast<u32>(_e632.member[2]) & 2147483647u));
    let _e683 = (_e682 * 0.00000011920929f);
    let _e686 = select(select(0.00000000000011368684f, _e683, (_e683 > 0.00000000000011368684f)), 0f, _e679);
    let _e687 = select(0f, _e632.member_1[2], _e679);
    let _e688 = (_e632.member[2] + _e686);
    let _e689 = (_e632.member[2] - _e686);
    let _e691 = select(38685626000000000000000000f, (1f / _e632.member_1[2]), _e679);
    let _e693 = select(_e666, _e650, (_e650 > _e666));
    let _e697 = (_e235 && (select(_e682, _e693, (_e693 > _e682)) <= 1099511600000f));
    let _e698 = select(0f, _e632.member_3, _e697);
    let _e699 = select(1f, _e632.member_2, _e697);
    let _e703 = slimbvh_question.member[1u];
    let _e704 = slimbvh_lane.member;
    if (_e704 < 64u) {
        let _e706 = (_e704 % 64u);
        let _e709 = slimbvh_question.member[0u];
        if (_e709 == 1u) {
            phi_1479_ = SlimbvhTypeP(SlimbvhTypeI(_e123, _e698), true);
        } else {
            phi_1479_ = SlimbvhTypeP(SlimbvhTypeI(_e123, _e698), false);
        }
        let _e716 = phi_1479_;
        let _e721 = (_e244 & 3u);
        let _e722 = (_e248 & 3u);
        let _e723 = (_e240 & 3u);
        let _e736 = (f32(bitcast<i32>(_e142)) * _e178);
        let _e738 = (f32(bitcast<i32>(_e146)) * _e178);
        let _e740 = (f32(bitcast<i32>(_e150)) * _e178);
        let _e741 = (_e721 == 0u);
        if _e741 {
            phi_1543_ = array<f32, 3>(_e736, _e738, _e740);
        } else {
            if (_e721 == 1u) {
                phi_1542_ = array<f32, 3>(_e738, _e740, _e736);
            } else {
                phi_1542_ = array<f32, 3>(_e740, _e736, _e738);
            }
            let _e746 = phi_1542_;
            phi_1543_ = _e746;
        }
        let _e749 = phi_1543_;
        let _e751 = (f32(bitcast<i32>(_e158)) * _e178);
        let _e753 = (f32(bitcast<i32>(_e162)) * _e178);
        let _e755 = (f32(bitcast<i32>(_e166)) * _e178);
        if _e741 {
            phi_1562_ = array<f32, 3>(_e751, _e753, _e755);
        } else {
            if (_e721 == 1u) {
                phi_1561_ = array<f32, 3>(_e753, _e755, _e751);
            } else {
                phi_1561_ = array<f32, 3>(_e755, _e751, _e753);
            }
            let _e760 = phi_1561_;
            phi_1562_ = _e760;
        }
        let _e763 = phi_1562_;
        let _e774 = ((_e749[0] - _e656) * _e659);
        let _e775 = ((_e763[0] - _e657) * _e659);
        let _e776 = vec4<f32>(_e774, f32(), _e775, f32());
        let _e779 = ((_e749[1] - _e672) * _e675);
        let _e780 = ((_e763[1] - _e673) * _e675);
        let _e781 = vec4<f32>(_e779, f32(), _e780, f32());
        let _e784 = ((_e749[2] - _e688) * _e691);
        let _e785 = ((_e763[2] - _e689) * _e691);
        let _e786 = vec4<f32>(_e784, f32(), _e785, f32());
        let _e787 = vec4<f32>(_e775, f32(), _e774, f32());
        let _e789 = vec4<f32>(_e780, f32(), _e779, f32());
        let _e791 = vec4<f32>(_e785, f32(), _e784, f32());
        phi_1735_ = _e716;
        phi_1738_ = select(4294967295u, select(4294967295u, 0u, (_e699 <= _e698)), (max(max(max(min(_e776, _e787).x, min(_e781, _e789).x), min(_e786, _e791).x), _e699) <= min((min(min(max(_e776, _e787).x, max(_e781, _e789).x), max(_e786, _e791).x) + (max(max(_e786, _e791).x, -(min(_e786, _e791).x)) * 0.0000019073523f)), _e716.member.member_1)));
        phi_1740_ = select(0u, 4294967295u, (_e127 == 0u));
        phi_1742_ = (_e127 + 1u);
        loop {
            let _e815 = phi_1735_;
            let _e817 = phi_1738_;
            let _e819 = phi_1740_;
            let _e821 = phi_1742_;
            local_5 = _e817;
            local_6 = _e815;
            let _e822 = (_e817 <= 32u);
            if _e822 {
                phi_1751_ = _e817;
                phi_1754_ = _e819;
                phi_1756_ = _e821;
                loop {
                    let _e824 = phi_1751_;
                    let _e826 = phi_1754_;
                    let _e828 = phi_1756_;
                    local_1 = _e826;
                    local_2 = _e824;
                    local_3 = _e824;
                    local_8 = _e824;
                    local_9 = _e826;
                    local_10 = _e828;
                    let _e829 = (_e824 <= 32u);
                    let _e831 = (_e826 + _e181);
                    let _e835 = (_e829 && !(((_e826 >= _e127) || (_e831 >= _e127))));
                    local = _e829;
                    if _e835 {
                        let _e840 = slimbvh_nodes.member[_e831][select(_e721, 2u, (2u < _e721))];
                        let _e845 = slimbvh_nodes.member[_e831][select(_e722, 2u, (2u < _e722))];
                        let _e850 = slimbvh_nodes.member[_e831][select(_e723, 2u, (2u < _e723))];
                        let _e853 = bitcast<u32>(_e178);
                        let _e858 = bitcast<f32>(_e840.x);
                        let _e859 = bitcast<f32>((_e853 + ((_e840.w & 31u) << bitcast<u32>(23i))));
                        let _e860 = (_e858 + _e859);
                        if ((bitcast<u32>(_e659) >> bitcast<u32>(31i)) == 0u) {
                            phi_1863_ = SlimbvhTypeJ(_e840.z, _e860);
                            phi_1864_ = SlimbvhTypeJ(_e840.y, _e858);
                        } else {
                            phi_1863_ = SlimbvhTypeJ(_e840.y, _e858);
                            phi_1864_ = SlimbvhTypeJ(_e840.z, _e860);
                        }
                        let _e871 = phi_1863_;
                        let _e873 = phi_1864_;
                        let _e912 = bitcast<f32>(_e845.x);
                        let _e913 = bitcast<f32>((_e853 + ((_e845.w & 31u) << bitcast<u32>(23i))));
                        let _e914 = (_e912 + _e913);
                        if ((bitcast<u32>(_e675) >> bitcast<u32>(31i)) == 0u) {
                            phi_1923_ = SlimbvhTypeJ(_e845.z, _e914);
                            phi_1924_ = SlimbvhTypeJ(_e845.y, _e912);
                        } else {
                            phi_1923_ = SlimbvhTypeJ(_e845.y, _e912);
                            phi_1924_ = SlimbvhTypeJ(_e845.z, _e914);
                        }
                        let _e925 = phi_1923_;
                        let _e927 = phi_1924_;
                        let _e966 = bitcast<f32>(_e850.x);
                        let _e967 = bitcast<f32>((_e853 + ((_e850.w & 31u) << bitcast<u32>(23i))));
                        let _e968 = (_e966 + _e967);
                        if ((bitcast<u32>(_e691) >> bitcast<u32>(31i)) == 0u) {
                            phi_1983_ = SlimbvhTypeJ(_e850.z, _e968);
                            phi_1984_ = SlimbvhTypeJ(_e850.y, _e966);
                        } else {
                            phi_1983_ = SlimbvhTypeJ(_e850.y, _e966);
                            phi_1984_ = SlimbvhTypeJ(_e850.z, _e968);
                        }
                        let _e979 = phi_1983_;
                        let _e981 = phi_1984_;
                        let _e1016 = (_e859 * _e659);
                        let _e1019 = bitcast<f32>((bitcast<u32>(_e1016) & 2147483647u));
                        let _e1023 = (((_e873.member_1 - _e656) * _e659) + (_e1019 * -0.00012207031f));
                        let _e1035 = (((_e871.member_1 - _e657) * _e659) + (_e1019 * 0.00012207031f));
                        let _e1044 = (_e913 * _e675);
                        let _e1047 = bitcast<f32>((bitcast<u32>(_e1044) & 2147483647u));
                        let _e1051 = (((_e927.member_1 - _e672) * _e675) + (_e1047 * -0.00012207031f));
                        let _e1063 = (((_e925.member_1 - _e673) * _e675) + (_e1047 * 0.00012207031f));
                        let _e1072 = (_e967 * _e691);
                        let _e1075 = bitcast<f32>((bitcast<u32>(_e1072) & 2147483647u));
                        let _e1079 = (((_e981.member_1 - _e688) * _e691) + (_e1075 * -0.00012207031f));
                        let _e1084 = ((f32((_e981.member & 255u)) * _e1072) + _e1079);
                        let _e1085 = ((f32(((_e981.member >> bitcast<u32>(8u)) & 255u)) * _e1072) + _e1079);
                        let _e1086 = ((f32(((_e981.member >> bitcast<u32>(16u)) & 255u)) * _e1072) + _e1079);
                        let _e1087 = ((f32(((_e981.member >> bitcast<u32>(24u)) & 255u)) * _e1072) + _e1079);
                        let _e1091 = (((_e979.member_1 - _e689) * _e691) + (_e1075 * 0.00012207031f));
                        let _e1096 = ((f32((_e979.member & 255u)) * _e1072) + _e1091);
                        let _e1097 = ((f32(((_e979.member >> bitcast<u32>(8u)) & 255u)) * _e1072) + _e1091);
                        let _e1098 = ((f32(((_e979.member >> bitcast<u32>(16u)) & 255u)) * _e1072) + _e1091);
                        let _e1099 = ((f32(((_e979.member >> bitcast<u32>(24u)) & 255u)) * _e1072) + _e1091);
                        let _e1132 = max(max(max(((f32((_e873.member & 255u)) * _e1016) + _e1023), ((f32((_e927.member & 255u)) * _e1044) + _e1051)), _e1084), _e699);
                        let _e1133 = max(max(max(((f32(((_e873.member >> bitcast<u32>(8u)) & 255u)) * _e1016) + _e1023), ((f32(((_e927.member >> bitcast<u32>(8u)) & 255u)) * _e1044) + _e1051)), _e1085), _e699);
                        let _e1134 = max(max(max(((f32(((_e873.member >> bitcast<u32>(16u)) & 255u)) * _e1016) + _e1023), ((f32(((_e927.member >> bitcast<u32>(16u)) & 255u)) * _e1044) + _e1051)), _e1086), _e699);
                        let _e1135 = max(max(max(((f32(((_e873.member >> bitcast<u32>(24u)) & 255u)) * _e1016) + _e1023), ((f32(((_e927.member >> bitcast<u32>(24u)) & 255u)) * _e1044) + _e1051)), _e1087), _e699);
                        let _e1140 = (_e815.member.member_1 + (bitcast<f32>((bitcast<u32>(_e815.member.member_1) & 2147483647u)) * 0.0000004768374f));
                        if (_e1132 <= min((min(min(((f32((_e871.member & 255u)) * _e1016) + _e1035), ((f32((_e925.member & 255u)) * _e1044) + _e1063)), _e1096) + (max(_e1096, -(_e1084)) * 0.0000023841915f)), _e1140)) {
                            phi_2474_ = (((bitcast<u32>(_e1132) ^ select(0u, 4294967288u, _e716.member_1)) & 2147483640u) | 4u);
                        } else {
                            phi_2474_ = 4294967288u;
                        }
                        let _e1155 = phi_2474_;
                        if (_e1133 <= min((min(min(((f32(((_e871.member >> bitcast<u32>(8u)) & 255u)) * _e1016) + _e1035), ((f32(((_e925.member >> bitcast<u32>(8u)) & 255u)) * _e1044) + _e1063)), _e1097) + (max(_e1097, -(_e1085)) * 0.0000023841915f)), _e1140)) {
                            phi_2487_ = ((((bitcast<u32>(_e1133) ^ select(0u, 4294967288u, _e716.member_1)) & 2147483640u) | 4u) | 1u);
                        } else {
                            phi_2487_ = 4294967288u;
                        }
                        let _e1163 = phi_2487_;
                        if (_e1134 <= min((min(min(((f32(((_e871.member >> bitcast<u32>(16u)) & 255u)) * _e1016) + _e1035), ((f32(((_e925.member >> bitcast<u32>(16u)) & 255u)) * _e1044) + _e1063)), _e1098) + (max(_e1098, -(_e1086)) * 0.0000023841915f)), _e1140)) {
                            phi_2500_ = ((((bitcast<u32>(_e1134) ^ select(0u, 4294967288u, _e716.member_1)) & 2147483640u) | 4u) | 2u);
                        } else {
                            phi_2500_ = 4294967288u;
                        }
                        let _e1171 = phi_2500_;
                        if (_e1135 <= min((min(min(((f32(((_e871.member >> bitcast<u32>(24u)) & 255u)) * _e1016) + _e1035), ((f32(((_e925.member >> bitcast<u32>(24u)) & 255u)) * _e1044) + _e1063)), _e1099) + (max(_e1099, -(_e1087)) * 0.0000023841915f)), _e1140)) {
                            phi_2513_ = ((((bitcast<u32>(_e1135) ^ select(0u, 4294967288u, _e716.member_1)) & 2147483640u) | 4u) | 3u);
                        } else {
                            phi_2513_ = 4294967288u;
                        }
                        let _e1179 = phi_2513_;
                        if (_e1155 < _e1163) {
                            phi_5259_ = SlimbvhTypeD(_e1155, _e1163);
                        } else {
                            phi_5259_ = SlimbvhTypeD(_e1163, _e1155);
                        }
                        let _e1184 = phi_5259_;
                        if (_e1171 < _e1179) {
                            phi_5271_ = SlimbvhTypeD(_e1171, _e1179);
                        } else {
                            phi_5271_ = SlimbvhTypeD(_e1179, _e1171);
                        }
                        let _e1191 = phi_5271_;
                        if (_e1184.member < _e1191.member) {
                            phi_5283_ = SlimbvhTypeD(_e1184.member, _e1191.member);
                        } else {
                            phi_5283_ = SlimbvhTypeD(_e1191.member, _e1184.member);
                        }
                        let _e1198 = phi_5283_;
                        if (_e1184.member_1 < _e1191.member_1) {
                            phi_5295_ = SlimbvhTypeD(_e1184.member_1, _e1191.member_1);
                        } else {
                            phi_5295_ = SlimbvhTypeD(_e1191.member_1, _e1184.member_1);
                        }
                        let _e1205 = phi_5295_;
                        if (_e1205.member < _e1198.member_1) {
                            phi_5307_ = SlimbvhTypeD(_e1205.member, _e1198.member_1);
                        } else {
                            phi_5307_ = SlimbvhTypeD(_e1198.member_1, _e1205.member);
                        }
                        let _e1212 = phi_5307_;
                        let _e1227 = (((_e1198.member & 7u) | ((_e1212.member & 7u) << bitcast<u32>(3u))) | (((_e1212.member_1 & 7u) | ((_e1205.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                        if (_e1227 == 0u) {
                            let _e1247 = (_e824 - 1u);
                            let _e1252 = slimbvh_stacks[(((_e1247 % 32u) * 64u) + _e706)];
                            let _e1253 = (_e1252 & 511u);
                            let _e1255 = (_e1253 >> bitcast<u32>(3u));
                            let _e1258 = ((_e1255 == 0u) || (_e1247 == 4294967295u));
                            if _e1258 {
                            } else {
                                slimbvh_stacks[(((_e1247 % 32u) * 64u) + _e706)] = (((_e1252 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1255);
                            }
                            phi_2602_ = select(_e824, _e1247, _e1258);
                            phi_2603_ = (((_e1252 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1253 & 3u) & 3u));
                        } else {
                            let _e1230 = (_e1227 >> bitcast<u32>(3u));
                            if (_e1230 == 0u) {
                                phi_2597_ = _e824;
                            } else {
                                slimbvh_stacks[(((_e824 % 32u) * 64u) + _e706)] = ((_e831 << bitcast<u32>(9u)) | _e1230);
                                phi_2597_ = (_e824 + 1u);
                            }
                            let _e1241 = phi_2597_;
                            phi_2602_ = _e1241;
                            phi_2603_ = ((_e831 << bitcast<u32>(2i)) | ((_e1227 & 3u) & 3u));
                        }
                        let _e1273 = phi_2602_;
                        let _e1275 = phi_2603_;
                        let _e1277 = (_e1275 >> bitcast<u32>(2i));
                        if (_e1277 < _e127) {
                            let _e1282 = slimbvh_nodes.member[_e1277][1u][3u];
                            let _e1286 = slimbvh_nodes.member[_e1277][2u][3u];
                            let _e1291 = (_e1286 >> bitcast<u32>(20u));
                            let _e1292 = (_e1275 & 3u);
                            if (((_e1291 >> bitcast<u32>((((3u * _e1292) & 31u) & 31u))) & 7u) == 7u) {
                                let _e1304 = ((_e1291 | (_e1291 << bitcast<u32>(10i))) & 4128831u);
                                phi_2657_ = (((_e1282 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e1304 | (_e1304 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e1292) & 31u) & 31u))) & 255u));
                            } else {
                                phi_2657_ = (2147483648u | _e1275);
                            }
                            let _e1322 = phi_2657_;
                            phi_2658_ = _e1322;
                        } else {
                            phi_2658_ = 4294967295u;
                        }
                        let _e1324 = phi_2658_;
                        let _e1325 = (_e828 - 1u);
                        phi_1752_ = select(_e1273, 4294967295u, (_e1325 == 0u));
                        phi_1755_ = _e1324;
                        phi_1757_ = _e1325;
                    } else {
                        phi_1752_ = u32();
                        phi_1755_ = u32();
                        phi_1757_ = u32();
                    }
                    let _e1329 = phi_1752_;
                    let _e1331 = phi_1755_;
                    let _e1333 = phi_1757_;
                    continue;
                    continuing {
                        phi_1751_ = _e1329;
                        phi_1754_ = _e1331;
                        phi_1756_ = _e1333;
                        break if !(_e835);
                    }
                }
                let _e1336 = local;
                if _e1336 {
                    let _e1338 = local_1;
                    let _e1339 = (_e1338 & 2147483647u);
                    let _e1341 = (_e1339 >> bitcast<u32>(2i));
                    if (_e1341 >= _e127) {
                        phi_2891_ = SlimbvhTypeM(SlimbvhTypeL(vec4<f32>(0f, 0f, 0f, 0f), 0u), 0u, 0u);
                    } else {
                        let _e1347 = slimbvh_nodes.member[_e1341][select(_e721, 2u, (2u < _e721))];
                        let _e1356 = slimbvh_nodes.member[_e1341][select(_e722, 2u, (2u < _e722))];
                        let _e1365 = slimbvh_nodes.member[_e1341][select(_e723, 2u, (2u < _e723))];
                        let _e1373 = slimbvh_nodes.member[_e1341][0u][3u];
                        let _e1377 = slimbvh_nodes.member[_e1341][1u][3u];
                        let _e1381 = slimbvh_nodes.member[_e1341][2u][3u];
                        let _e1394 = (_e1381 >> bitcast<u32>(20u));
                        let _e1402 = (((_e1381 >> bitcast<u32>(7u)) & 8191u) | ((_e1377 >> bitcast<u32>(29u)) << bitcast<u32>(13u)));
                        let _e1405 = ((_e1381 >> bitcast<u32>(5u)) & 3u);
                        let _e1406 = (_e1339 & 3u);
                        let _e1412 = ((_e1394 >> bitcast<u32>((((3u * _e1406) & 31u) & 31u))) & 7u);
                        if (_e1412 == 7u) {
                            let _e1465 = ((_e1394 | (_e1394 << bitcast<u32>(10i))) & 4128831u);
                            phi_2843_ = (((_e1377 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e1465 | (_e1465 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e1406) & 31u) & 31u))) & 255u));
                        } else {
                            let _e1417 = ((_e1394 | (_e1394 << bitcast<u32>(10i))) & 4128831u);
                            let _e1421 = ((_e1417 | (_e1417 << bitcast<u32>(5i))) & 117901063u);
                            let _e1427 = (_e1421 - (7u * (((_e1421 + 16843009u) >> bitcast<u32>(3i)) & 16843009u)));
                            let _e1435 = ((_e1402 | (_e1402 << bitcast<u32>(8i))) & 16711935u);
                            phi_2843_ = ((2147483648u | (_e1412 << bitcast<u32>(28u))) | ((((_e1373 >> bitcast<u32>(5u)) | (((_e1377 >> bitcast<u32>(28u)) & 1u) << bitcast<u32>(27u))) + (((((((((_e1435 | (_e1435 << bitcast<u32>(4i))) & 252645135u) + (3u * (((_e1427 + 117901063u) >> bitcast<u32>(3i)) & 16843009u))) * (_e1405 + 1u)) + _e1427) + ((_e1427 >> bitcast<u32>(1i)) & 50529027u)) * 16843008u) >> bitcast<u32>((((8u * _e1406) & 31u) & 31u))) & 255u)) & 268435455u));
                        }
                        let _e1483 = phi_2843_;
                        switch bitcast<i32>(_e1405) {
                            case 0: {
                                phi_2848_ = 0u;
                                break;
                            }
                            case 1: {
                                phi_2848_ = 1u;
                                break;
                            }
                            default: {
                                phi_2848_ = 2u;
                                break;
                            }
                        }
                        let _e1486 = phi_2848_;
                        let _e1489 = (((8u * _e1406) & 31u) & 31u);
                        phi_2891_ = SlimbvhTypeM(SlimbvhTypeL(vec4<f32>((bitcast<f32>(_e1347.x) + (f32((((_e1347.y >> bitcast<u32>(_e1489)) & 255u) << bitcast<u32>(((_e1347.w & 31u) & 31u)))) * _e178)), (bitcast<f32>(_e1356.x) + (f32((((_e1356.y >> bitcast<u32>(_e1489)) & 255u) << bitcast<u32>(((_e1356.w & 31u) & 31u)))) * _e178)), (bitcast<f32>(_e1365.x) + (f32((((_e1365.y >> bitcast<u32>(_e1489)) & 255u) << bitcast<u32>(((_e1365.w & 31u) & 31u)))) * _e178)), 0f), _e1486), (_e1483 & 268435455u), ((_e1483 >> bitcast<u32>(28u)) & 7u));
                    }
                    let _e1528 = phi_2891_;
                    let _e1530 = (_e1528.member_1 + _e184);
                    phi_2898_ = _e815;
                    phi_2901_ = SlimbvhTypeD(0u, _e1528.member_2);
                    loop {
                        let _e1535 = phi_2898_;
                        let _e1537 = phi_2901_;
                        local_4 = _e1535;
                        local_7 = _e1535;
                        if (_e1537.member < _e1537.member_1) {
                            phi_2902_ = SlimbvhTypeD((_e1537.member + 1u), _e1537.member_1);
                            phi_2924_ = SlimbvhTypeD(1u, _e1537.member);
                        } else {
                            phi_2902_ = _e1537;
                            phi_2924_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                        }
                        let _e1550 = phi_2902_;
                        let _e1552 = phi_2924_;
                        let _e1556 = (bitcast<i32>(_e1552.member) != 0i);
                        if _e1556 {
                            let _e1558 = (_e1530 + (_e1528.member_2 / 2u));
                            let _e1559 = (_e1558 + _e1552.member_1);
                            if (_e1559 < _e130) {
                                let _e1562 = slimbvh_triangles.member[_e1559];
                                phi_2949_ = _e1562;
                            } else {
                                phi_2949_ = 4294967295u;
                            }
                            let _e1564 = phi_2949_;
                            let _e1565 = (_e1552.member_1 - 1u);
                            let _e1568 = (_e1530 + (_e1565 >> bitcast<u32>(1i)));
                            if (_e1568 < _e130) {
                                let _e1571 = slimbvh_triangles.member[_e1568];
                                phi_2972_ = _e1571;
                            } else {
                                phi_2972_ = 0u;
                            }
                            let _e1573 = phi_2972_;
                            if (_e1552.member_1 == 0u) {
                                phi_2981_ = 2080u;
                            } else {
                                phi_2981_ = (_e1573 >> bitcast<u32>(((16u * (_e1565 & 1u)) & 31u)));
                            }
                            let _e1581 = phi_2981_;
                            let _e1582 = (_e1558 + _e1528.member_2);
                            switch bitcast<i32>(_e1528.member.member_1) {
                                case 0: {
                                    phi_2991_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2991_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2991_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2991_ = u32();
                                    break;
                                }
                            }
                            let _e1586 = phi_2991_;
                            let _e1589 = (_e1582 + ((_e1581 & 31u) * _e1586));
                            let _e1594 = (_e1582 + (((_e1581 >> bitcast<u32>(5u)) & 31u) * _e1586));
                            let _e1599 = (_e1582 + (((_e1581 >> bitcast<u32>(10u)) & 31u) * _e1586));
                            switch bitcast<i32>(_e1528.member.member_1) {
                                case 0: {
                                    if (_e1589 < _e130) {
                                        let _e1876 = slimbvh_triangles.member[_e1589];
                                        phi_3033_ = _e1876;
                                    } else {
                                        phi_3033_ = 0u;
                                    }
                                    let _e1878 = phi_3033_;
                                    let _e1881 = ((10u * _e244) & 31u);
                                    let _e1892 = ((10u * _e248) & 31u);
                                    let _e1903 = ((10u * _e240) & 31u);
                                    if (_e1594 < _e130) {
                                        let _e1915 = slimbvh_triangles.member[_e1594];
                                        phi_3079_ = _e1915;
                                    } else {
                                        phi_3079_ = 0u;
                                    }
                                    let _e1917 = phi_3079_;
                                    if (_e1599 < _e130) {
                                        let _e1945 = slimbvh_triangles.member[_e1599];
                                        phi_3125_ = _e1945;
                                    } else {
                                        phi_3125_ = 0u;
                                    }
                                    let _e1947 = phi_3125_;
                                    phi_3592_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1528.member.member.x + ((bitcast<f32>((1258291200u | ((_e1878 >> bitcast<u32>(_e1881)) & 1023u))) - 8388608f) * _e178)), (_e1528.member.member.y + ((bitcast<f32>((1258291200u | ((_e1878 >> bitcast<u32>(_e1892)) & 1023u))) - 8388608f) * _e178)), (_e1528.member.member.z + ((bitcast<f32>((1258291200u | ((_e1878 >> bitcast<u32>(_e1903)) & 1023u))) - 8388608f) * _e178))), array<f32, 3>((_e1528.member.member.x + ((bitcast<f32>((1258291200u | ((_e1917 >> bitcast<u32>(_e1881)) & 1023u))) - 8388608f) * _e178)), (_e1528.member.member.y + ((bitcast<f32>((1258291200u | ((_e1917 >> bitcast<u32>(_e1892)) & 1023u))) - 8388608f) * _e178)), (_e1528.member.member.z + ((bitcast<f32>((1258291200u | ((_e1917 >> bitcast<u32>(_e1903)) & 1023u))) - 8388608f) * _e178))), array<f32, 3>((_e1528.member.member.x + ((bitcast<f32>((1258291200u | ((_e1947 >> bitcast<u32>(_e1881)) & 1023u))) - 8388608f) * _e178)), (_e1528.member.member.y + ((bitcast<f32>((1258291200u | ((_e1947 >> bitcast<u32>(_e1892)) & 1023u))) - 8388608f) * _e178)), (_e1528.member.member.z + ((bitcast<f32>((1258291200u | ((_e1947 >> bitcast<u32>(_e1903)) & 1023u))) - 8388608f) * _e178))));
                                    break;
                                }
                                case 1: {
                                    if (_e1589 < _e130) {
                                        let _e1689 = slimbvh_triangles.member[_e1589];
                                        phi_3172_ = _e1689;
                                    } else {
                                        phi_3172_ = 0u;
                                    }
                                    let _e1691 = phi_3172_;
                                    let _e1692 = (_e1589 + 1u);
                                    if (_e1692 < _e130) {
                                        let _e1695 = slimbvh_triangles.member[_e1692];
                                        phi_3185_ = _e1695;
                                    } else {
                                        phi_3185_ = 0u;
                                    }
                                    let _e1697 = phi_3185_;
                                    let _e1699 = (_e244 == 1u);
                                    if _e1699 {
                                        phi_3195_ = ((_e1691 >> bitcast<u32>(21i)) | (_e1697 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3195_ = (_e1697 >> bitcast<u32>(10i));
                                    }
                                    let _e1708 = phi_3195_;
                                    let _e1717 = (_e248 == 1u);
                                    if _e1717 {
                                        phi_3216_ = ((_e1691 >> bitcast<u32>(21i)) | (_e1697 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3216_ = (_e1697 >> bitcast<u32>(10i));
                                    }
                                    let _e1726 = phi_3216_;
                                    let _e1735 = (_e240 == 1u);
                                    if _e1735 {
                                        phi_3237_ = ((_e1691 >> bitcast<u32>(21i)) | (_e1697 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3237_ = (_e1697 >> bitcast<u32>(10i));
                                    }
                                    let _e1744 = phi_3237_;
                                    if (_e1594 < _e130) {
                                        let _e1755 = slimbvh_triangles.member[_e1594];
                                        phi_3264_ = _e1755;
                                    } else {
                                        phi_3264_ = 0u;
                                    }
                                    let _e1757 = phi_3264_;
                                    let _e1758 = (_e1594 + 1u);
                                    if (_e1758 < _e130) {
                                        let _e1761 = slimbvh_triangles.member[_e1758];
                                        phi_3277_ = _e1761;
                                    } else {
                                        phi_3277_ = 0u;
                                    }
                                    let _e1763 = phi_3277_;
                                    if _e1699 {
                                        phi_3287_ = ((_e1757 >> bitcast<u32>(21i)) | (_e1763 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3287_ = (_e1763 >> bitcast<u32>(10i));
                                    }
                                    let _e1772 = phi_3287_;
                                    if _e1717 {
                                        phi_3308_ = ((_e1757 >> bitcast<u32>(21i)) | (_e1763 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3308_ = (_e1763 >> bitcast<u32>(10i));
                                    }
                                    let _e1788 = phi_3308_;
                                    if _e1735 {
                                        phi_3329_ = ((_e1757 >> bitcast<u32>(21i)) | (_e1763 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3329_ = (_e1763 >> bitcast<u32>(10i));
                                    }
                                    let _e1804 = phi_3329_;
                                    if (_e1599 < _e130) {
                                        let _e1815 = slimbvh_triangles.member[_e1599];
                                        phi_3356_ = _e1815;
                                    } else {
                                        phi_3356_ = 0u;
                                    }
                                    let _e1817 = phi_3356_;
                                    let _e1818 = (_e1599 + 1u);
                                    if (_e1818 < _e130) {
                                        let _e1821 = slimbvh_triangles.member[_e1818];
                                        phi_3369_ = _e1821;
                                    } else {
                                        phi_3369_ = 0u;
                                    }
                                    let _e1823 = phi_3369_;
                                    if _e1699 {
                                        phi_3379_ = ((_e1817 >> bitcast<u32>(21i)) | (_e1823 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3379_ = (_e1823 >> bitcast<u32>(10i));
                                    }
                                    let _e1832 = phi_3379_;
                                    if _e1717 {
                                        phi_3400_ = ((_e1817 >> bitcast<u32>(21i)) | (_e1823 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3400_ = (_e1823 >> bitcast<u32>(10i));
                                    }
                                    let _e1848 = phi_3400_;
                                    if _e1735 {
                                        phi_3421_ = ((_e1817 >> bitcast<u32>(21i)) | (_e1823 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3421_ = (_e1823 >> bitcast<u32>(10i));
                                    }
                                    let _e1864 = phi_3421_;
                                    phi_3592_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1528.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1708, _e1691, _e249) & 2097151u))) - 8388608f) * _e178)), (_e1528.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1726, _e1691, _e252) & 2097151u))) - 8388608f) * _e178)), (_e1528.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1744, _e1691, _e256) & 2097151u))) - 8388608f) * _e178))), array<f32, 3>((_e1528.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1772, _e1757, _e249) & 2097151u))) - 8388608f) * _e178)), (_e1528.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1788, _e1757, _e252) & 2097151u))) - 8388608f) * _e178)), (_e1528.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1804, _e1757, _e256) & 2097151u))) - 8388608f) * _e178))), array<f32, 3>((_e1528.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1832, _e1817, _e249) & 2097151u))) - 8388608f) * _e178)), (_e1528.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1848, _e1817, _e252) & 2097151u))) - 8388608f) * _e178)), (_e1528.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1864, _e1817, _e256) & 2097151u))) - 8388608f) * _e178))));
                                    break;
                                }
                                case 2: {
                                    let _e1602 = (_e1589 + _e244);
                                    if (_e1602 < _e130) {
                                        let _e1605 = slimbvh_triangles.member[_e1602];
                                        phi_3450_ = _e1605;
                                    } else {
                                        phi_3450_ = 0u;
                                    }
                                    let _e1607 = phi_3450_;
                                    let _e1608 = (_e1589 + _e248);
                                    if (_e1608 < _e130) {
                                        let _e1611 = slimbvh_triangles.member[_e1608];
                                        phi_3463_ = _e1611;
                                    } else {
                                        phi_3463_ = 0u;
                                    }
                                    let _e1613 = phi_3463_;
                                    let _e1614 = (_e1589 + _e240);
                                    if (_e1614 < _e130) {
                                        let _e1617 = slimbvh_triangles.member[_e1614];
                                        phi_3476_ = _e1617;
                                    } else {
                                        phi_3476_ = 0u;
                                    }
                                    let _e1619 = phi_3476_;
                                    let _e1630 = (_e1594 + _e244);
                                    if (_e1630 < _e130) {
                                        let _e1633 = slimbvh_triangles.member[_e1630];
                                        phi_3502_ = _e1633;
                                    } else {
                                        phi_3502_ = 0u;
                                    }
                                    let _e1635 = phi_3502_;
                                    let _e1636 = (_e1594 + _e248);
                                    if (_e1636 < _e130) {
                                        let _e1639 = slimbvh_triangles.member[_e1636];
                                        phi_3515_ = _e1639;
                                    } else {
                                        phi_3515_ = 0u;
                                    }
                                    let _e1641 = phi_3515_;
                                    let _e1642 = (_e1594 + _e240);
                                    if (_e1642 < _e130) {
                                        let _e1645 = slimbvh_triangles.member[_e1642];
                                        phi_3528_ = _e1645;
                                    } else {
                                        phi_3528_ = 0u;
                                    }
                                    let _e1647 = phi_3528_;
                                    let _e1658 = (_e1599 + _e244);
                                    if (_e1658 < _e130) {
                                        let _e1661 = slimbvh_triangles.member[_e1658];
                                        phi_3554_ = _e1661;
                                    } else {
                                        phi_3554_ = 0u;
                                    }
                                    let _e1663 = phi_3554_;
                                    let _e1664 = (_e1599 + _e248);
                                    if (_e1664 < _e130) {
                                        let _e1667 = slimbvh_triangles.member[_e1664];
                                        phi_3567_ = _e1667;
                                    } else {
                                        phi_3567_ = 0u;
                                    }
                                    let _e1669 = phi_3567_;
                                    let _e1670 = (_e1599 + _e240);
                                    if (_e1670 < _e130) {
                                        let _e1673 = slimbvh_triangles.member[_e1670];
                                        phi_3580_ = _e1673;
                                    } else {
                                        phi_3580_ = 0u;
                                    }
                                    let _e1675 = phi_3580_;
                                    phi_3592_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1607)) * _e178), (f32(bitcast<i32>(_e1613)) * _e178), (f32(bitcast<i32>(_e1619)) * _e178)), array<f32, 3>((f32(bitcast<i32>(_e1635)) * _e178), (f32(bitcast<i32>(_e1641)) * _e178), (f32(bitcast<i32>(_e1647)) * _e178)), array<f32, 3>((f32(bitcast<i32>(_e1663)) * _e178), (f32(bitcast<i32>(_e1669)) * _e178), (f32(bitcast<i32>(_e1675)) * _e178)));
                                    break;
                                }
                                default: {
                                    phi_3592_ = array<array<f32, 3>, 3>();
                                    break;
                                }
                            }
                            let _e1975 = phi_3592_;
                            let _e1992 = (_e1975[0][2] - _e632.member[2]);
                            let _e1995 = (((_e1975[0][0] - _e632.member[0]) * _e687) - (_e1992 * _e655));
                            let _e1998 = (((_e1975[0][1] - _e632.member[1]) * _e687) - (_e1992 * _e671));
                            let _e2001 = (_e1975[1][2] - _e632.member[2]);
                            let _e2004 = (((_e1975[1][0] - _e632.member[0]) * _e687) - (_e2001 * _e655));
                            let _e2007 = (((_e1975[1][1] - _e632.member[1]) * _e687) - (_e2001 * _e671));
                            let _e2010 = (_e1975[2][2] - _e632.member[2]);
                            let _e2013 = (((_e1975[2][0] - _e632.member[0]) * _e687) - (_e2010 * _e655));
                            let _e2016 = (((_e1975[2][1] - _e632.member[1]) * _e687) - (_e2010 * _e671));
                            let _e2017 = (_e2013 * _e2007);
                            let _e2018 = (_e2016 * _e2004);
                            let _e2019 = (_e1995 * _e2016);
                            let _e2020 = (_e1998 * _e2013);
                            let _e2021 = (_e2004 * _e1998);
                            let _e2022 = (_e2007 * _e1995);
                            let _e2027 = (((_e2017 >= _e2018) && (_e2019 >= _e2020)) && (_e2021 >= _e2022));
                            let _e2033 = (_e2027 || (((_e2017 <= _e2018) && (_e2019 <= _e2020)) && (_e2021 <= _e2022)));
                            if _e2033 {
                                let _e2035 = select(-1f, 1f, _e2027);
                                let _e2037 = ((_e2017 - _e2018) * _e2035);
                                let _e2039 = select(0f, _e2037, (_e2037 > 0f));
                                let _e2041 = ((_e2019 - _e2020) * _e2035);
                                let _e2043 = select(0f, _e2041, (_e2041 > 0f));
                                let _e2045 = ((_e2021 - _e2022) * _e2035);
                                let _e2047 = select(0f, _e2045, (_e2045 > 0f));
                                let _e2049 = ((_e2039 + _e2043) + _e2047);
                                let _e2064 = ((min(min(_e1975[0][0], _e1975[1][0]), _e1975[2][0]) - _e656) * _e659);
                                let _e2065 = ((max(max(_e1975[0][0], _e1975[1][0]), _e1975[2][0]) - _e657) * _e659);
                                let _e2066 = vec4<f32>(_e2064, f32(), _e2065, f32());
                                let _e2069 = ((min(min(_e1975[0][1], _e1975[1][1]), _e1975[2][1]) - _e672) * _e675);
                                let _e2070 = ((max(max(_e1975[0][1], _e1975[1][1]), _e1975[2][1]) - _e673) * _e675);
                                let _e2071 = vec4<f32>(_e2069, f32(), _e2070, f32());
                                let _e2074 = ((min(min(_e1975[0][2], _e1975[1][2]), _e1975[2][2]) - _e688) * _e691);
                                let _e2075 = ((max(max(_e1975[0][2], _e1975[1][2]), _e1975[2][2]) - _e689) * _e691);
                                let _e2076 = vec4<f32>(_e2074, f32(), _e2075, f32());
                                let _e2077 = vec4<f32>(_e2065, f32(), _e2064, f32());
                                let _e2079 = vec4<f32>(_e2070, f32(), _e2069, f32());
                                let _e2081 = vec4<f32>(_e2075, f32(), _e2074, f32());
                                let _e2090 = max(max(min(_e2066, _e2077).x, min(_e2071, _e2079).x), min(_e2076, _e2081).x);
                                let _e2095 = min(min(max(_e2066, _e2077).x, max(_e2071, _e2079).x), max(_e2076, _e2081).x);
                                let _e2100 = max(_e2090, _e699);
                                let _e2122 = (((((_e2033 && (_e2049 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1995, _e2004), _e2013) <= 0f) && (max(max(_e1995, _e2004), _e2013) >= 0f))) && ((min(min(_e1998, _e2007), _e2016) <= 0f) && (max(max(_e1998, _e2007), _e2016) >= 0f))) && (_e2100 <= (_e2095 + (max(max(_e2076, _e2081).x, -(min(_e2076, _e2081).x)) * 0.0000019073523f)))) && (_e2100 <= _e1535.member.member_1));
                                if _e2122 {
                                    let _e2127 = (_e1975[1][0] - _e1975[0][0]);
                                    let _e2128 = (_e1975[1][1] - _e1975[0][1]);
                                    let _e2129 = (_e1975[1][2] - _e1975[0][2]);
                                    let _e2130 = vec3<f32>(_e2127, _e2128, _e2129);
                                    let _e2131 = (_e1975[2][0] - _e1975[1][0]);
                                    let _e2132 = (_e1975[2][1] - _e1975[1][1]);
                                    let _e2133 = (_e1975[2][2] - _e1975[1][2]);
                                    let _e2134 = vec3<f32>(_e2131, _e2132, _e2133);
                                    let _e2135 = (_e1975[0][0] - _e1975[2][0]);
                                    let _e2136 = (_e1975[0][1] - _e1975[2][1]);
                                    let _e2137 = (_e1975[0][2] - _e1975[2][2]);
                                    let _e2138 = vec3<f32>(_e2135, _e2136, _e2137);
                                    let _e2149 = max(max(bitcast<f32>((bitcast<u32>(_e2127) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2128) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2129) & 2147483647u)));
                                    let _e2160 = max(max(bitcast<f32>((bitcast<u32>(_e2131) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2132) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2133) & 2147483647u)));
                                    let _e2173 = max(max(_e2149, _e2160), max(max(bitcast<f32>((bitcast<u32>(_e2135) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2136) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2137) & 2147483647u))));
                                    if (_e2149 == _e2173) {
                                        phi_3957_ = _e2007;
                                        phi_3958_ = _e2004;
                                        phi_3959_ = _e1998;
                                        phi_3960_ = _e1995;
                                        phi_3961_ = vec3<f32>(_e1975[0][0], _e1975[0][1], _e1975[0][2]);
                                        phi_3962_ = _e2138;
                                        phi_3963_ = _e2134;
                                        phi_3964_ = _e2130;
                                    } else {
                                        let _e2175 = (_e2160 == _e2173);
                                        let _e2180 = vec3(_e2175);
                                        phi_3957_ = select(_e1998, _e2016, _e2175);
                                        phi_3958_ = select(_e1995, _e2013, _e2175);
                                        phi_3959_ = select(_e2016, _e2007, _e2175);
                                        phi_3960_ = select(_e2013, _e2004, _e2175);
                                        phi_3961_ = select(vec3<f32>(_e1975[2][0], _e1975[2][1], _e1975[2][2]), vec3<f32>(_e1975[1][0], _e1975[1][1], _e1975[1][2]), _e2180);
                                        phi_3962_ = select(_e2134, _e2130, _e2180);
                                        phi_3963_ = select(_e2130, _e2138, _e2180);
                                        phi_3964_ = select(_e2138, _e2134, _e2180);
                                    }
                                    let _e2186 = phi_3957_;
                                    let _e2188 = phi_3958_;
                                    let _e2190 = phi_3959_;
                                    let _e2192 = phi_3960_;
                                    let _e2194 = phi_3961_;
                                    let _e2196 = phi_3962_;
                                    let _e2198 = phi_3963_;
                                    let _e2200 = phi_3964_;
                                    let _e2207 = ((_e2198.y * _e2196.z) - (_e2196.y * _e2198.z));
                                    let _e2212 = ((_e2198.z * _e2196.x) - (_e2196.z * _e2198.x));
                                    let _e2215 = ((_e2198.x * _e2196.y) - (_e2196.x * _e2198.y));
                                    let _e2218 = ((_e2039 >= _e2043) && (_e2039 >= _e2047));
                                    let _e2219 = (_e2043 >= _e2047);
                                    let _e2233 = (((_e2207 * (select(select(_e1975[2][0], _e1975[1][0], _e2219), _e1975[0][0], _e2218) - _e632.member[0])) + (_e2212 * (select(select(_e1975[2][1], _e1975[1][1], _e2219), _e1975[0][1], _e2218) - _e632.member[1]))) + (_e2215 * (select(select(_e1975[2][2], _e1975[1][2], _e2219), _e1975[0][2], _e2218) - _e632.member[2])));
                                    let _e2238 = (((_e2207 * _e655) + (_e2212 * _e671)) + (_e2215 * _e687));
                                    let _e2239 = (_e2188 - _e2192);
                                    let _e2240 = (_e2186 - _e2190);
                                    let _e2243 = ((_e2239 * _e2239) + (_e2240 * _e2240));
                                    let _e2250 = (-(((_e2192 * _e2239) + (_e2190 * _e2240))) / select(0.000000000000000000000000000000000000011754944f, _e2243, (_e2243 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e2252 = select(1f, _e2250, (_e2250 < 1f));
                                    let _e2254 = select(0f, _e2252, (_e2252 > 0f));
                                    let _e2263 = ((_e2194.x + (_e2200.x * _e2254)) - _e632.member[0]);
                                    let _e2266 = ((_e2194.y + (_e2200.y * _e2254)) - _e632.member[1]);
                                    let _e2269 = ((_e2194.z + (_e2200.z * _e2254)) - _e632.member[2]);
                                    let _e2334 = ((bitcast<f32>((bitcast<u32>(((((_e2207 * _e2263) + (_e2212 * _e2266)) + (_e2215 * _e2269)) - _e2233)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e2263) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2266) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2269) & 2147483647u))), _e2173)) * max(max(bitcast<f32>((bitcast<u32>(_e2207) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2212) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2215) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e2238) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e2198.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2198.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2198.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e2196.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2196.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2196.z) & 2147483647u)))))));
                                    let _e2335 = (_e2233 / _e2238);
                                    if (_e2122 && !(_e2334)) {
                                        let _e2338 = (_e2269 / _e687);
                                        let _e2346 = (((_e2207 * (_e2263 - (_e655 * _e2338))) + (_e2212 * (_e2266 - (_e671 * _e2338)))) / _e2238);
                                        phi_4143_ = select(select(_e2338, (_e2338 + _e2346), (bitcast<f32>((bitcast<u32>(_e2346) & 2147483647u)) <= _e2173)), _e2335, _e2334);
                                    } else {
                                        phi_4143_ = _e2335;
                                    }
                                    let _e2355 = phi_4143_;
                                    let _e2357 = select(_e2095, _e2355, (_e2355 < _e2095));
                                    let _e2359 = select(_e2090, _e2357, (_e2357 > _e2090));
                                    let _e2362 = select(_e2359, 0f, (bitcast<u32>(_e2359) == 2147483648u));
                                    let _e2363 = (1f / _e2049);
                                    phi_4169_ = SlimbvhTypeE(_e2362, (_e2043 * _e2363), (_e2047 * _e2363), ((_e2122 && (_e2362 >= _e699)) && (_e2362 <= _e1535.member.member_1)));
                                    phi_4170_ = SlimbvhTypeE();
                                } else {
                                    phi_4169_ = SlimbvhTypeE();
                                    phi_4170_ = SlimbvhTypeE(0f, 0f, 0f, _e2122);
                                }
                                let _e2372 = phi_4169_;
                                let _e2374 = phi_4170_;
                                phi_4173_ = _e2372;
                                phi_4174_ = _e2374;
                                phi_4175_ = select(true, false, _e2122);
                            } else {
                                phi_4173_ = SlimbvhTypeE();
                                phi_4174_ = SlimbvhTypeE(0f, 0f, 0f, _e2033);
                                phi_4175_ = true;
                            }
                            let _e2377 = phi_4173_;
                            let _e2379 = phi_4174_;
                            let _e2381 = phi_4175_;
                            if _e2381 {
                                phi_4179_ = _e2379;
                            } else {
                                phi_4179_ = _e2377;
                            }
                            let _e2383 = phi_4179_;
                            if _e2383.member_3 {
                                phi_4188_ = SlimbvhTypeF(_e2383.member, _e2383.member_1, _e2383.member_2, _e1564);
                            } else {
                                phi_4188_ = _e123;
                            }
                            let _e2390 = phi_4188_;
                            if (_e2390.member_3 != 4294967295u) {
                                let _e2396 = slimbvh_target.member[0u][0u];
                                let _e2400 = slimbvh_target.member[0u][1u];
                                let _e2404 = slimbvh_target.member[0u][2u];
                                let _e2408 = slimbvh_target.member[0u][3u];
                                let _e2412 = slimbvh_target.member[1u][0u];
                                let _e2416 = slimbvh_target.member[1u][1u];
                                let _e2420 = slimbvh_target.member[1u][2u];
                                let _e2424 = slimbvh_target.member[1u][3u];
                                let _e2425 = bitcast<f32>(_e2396);
                                let _e2426 = bitcast<f32>(_e2400);
                                let _e2427 = bitcast<f32>(_e2404);
                                let _e2429 = bitcast<f32>(_e2412);
                                let _e2430 = array<u32, 3>(_e2416, _e2420, _e2424);
                                if (_e202 < -126i) {
                                    phi_4241_ = -126i;
                                } else {
                                    phi_4241_ = select(_e202, 127i, (_e202 > 127i));
                                }
                                let _e2436 = phi_4241_;
                                let _e2441 = bitcast<f32>((bitcast<u32>((_e2436 + 127i)) << bitcast<u32>(23i)));
                                let _e2447 = bitcast<f32>((bitcast<u32>(((_e202 - _e2436) + 127i)) << bitcast<u32>(23i)));
                                if (_e2408 == 0u) {
                                    phi_4381_ = SlimbvhTypeH(array<f32, 3>(_e2425, _e2426, _e2427), _e2408, _e2429, _e2430);
                                } else {
                                    let _e2449 = bitcast<u32>(_e2425);
                                    let _e2451 = ((_e2449 & 2139095040u) != 0u);
                                    let _e2466 = bitcast<u32>(_e2426);
                                    let _e2468 = ((_e2466 & 2139095040u) != 0u);
                                    let _e2483 = bitcast<u32>(_e2427);
                                    let _e2485 = ((_e2483 & 2139095040u) != 0u);
                                    let _e2501 = bitcast<u32>(_e2429);
                                    let _e2503 = ((_e2501 & 2139095040u) != 0u);
                                    phi_4381_ = SlimbvhTypeH(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2449 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2449 & 2147483648u))), _e2425, _e2451) * _e2441) * select(0.00000011920929f, 1f, _e2451)) * _e2447), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2466 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2466 & 2147483648u))), _e2426, _e2468) * _e2441) * select(0.00000011920929f, 1f, _e2468)) * _e2447), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2483 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2483 & 2147483648u))), _e2427, _e2485) * _e2441) * select(0.00000011920929f, 1f, _e2485)) * _e2447)), _e2408, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2501 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2501 & 2147483648u))), _e2429, _e2503) * _e2441) * select(0.00000011920929f, 1f, _e2503)) * _e2447), _e2430);
                                }
                                let _e2520 = phi_4381_;
                                if (_e1564 == _e703) {
                                    phi_4710_ = false;
                                } else {
                                    let _e2522 = (_e1564 / 16u);
                                    if (_e2522 < arrayLength((&slimbvh_sides.member))) {
                                        let _e2525 = slimbvh_sides.member[_e2522];
                                        phi_4405_ = _e2525;
                                    } else {
                                        phi_4405_ = 0u;
                                    }
                                    let _e2527 = phi_4405_;
                                    let _e2536 = (bitcast<i32>((_e2527 << bitcast<u32>(((30u - ((_e1564 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                    let _e2537 = (_e2536 == 0i);
                                    if _e2537 {
                                        phi_4709_ = true;
                                    } else {
                                        if _e249 {
                                            phi_4435_ = vec3<f32>(_e1975[0][0], _e1975[0][1], _e1975[0][2]);
                                        } else {
                                            if (_e244 == 1u) {
                                                phi_4434_ = vec3<f32>(_e1975[0][2], _e1975[0][0], _e1975[0][1]);
                                            } else {
                                                phi_4434_ = vec3<f32>(_e1975[0][1], _e1975[0][2], _e1975[0][0]);
                                            }
                                            let _e2542 = phi_4434_;
                                            phi_4435_ = _e2542;
                                        }
                                        let _e2545 = phi_4435_;
                                        if _e249 {
                                            phi_4454_ = vec3<f32>(_e1975[1][0], _e1975[1][1], _e1975[1][2]);
                                        } else {
                                            if (_e244 == 1u) {
                                                phi_4453_ = vec3<f32>(_e1975[1][2], _e1975[1][0], _e1975[1][1]);
                                            } else {
                                                phi_4453_ = vec3<f32>(_e1975[1][1], _e1975[1][2], _e1975[1][0]);
                                            }
                                            let _e2550 = phi_4453_;
                                            phi_4454_ = _e2550;
                                        }
                                        let _e2553 = phi_4454_;
                                        if _e249 {
                                            phi_4473_ = vec3<f32>(_e1975[2][0], _e1975[2][1], _e1975[2][2]);
                                        } else {
                                            if (_e244 == 1u) {
                                                phi_4472_ = vec3<f32>(_e1975[2][2], _e1975[2][0], _e1975[2][1]);
                                            } else {
                                                phi_4472_ = vec3<f32>(_e1975[2][1], _e1975[2][2], _e1975[2][0]);
                                            }
                                            let _e2558 = phi_4472_;
                                            phi_4473_ = _e2558;
                                        }
                                        let _e2561 = phi_4473_;
                                        let _e2564 = (_e2553.x - _e2545.x);
                                        let _e2567 = (_e2553.y - _e2545.y);
                                        let _e2570 = (_e2553.z - _e2545.z);
                                        let _e2572 = (_e2561.x - _e2545.x);
                                        let _e2574 = (_e2561.y - _e2545.y);
                                        let _e2576 = (_e2561.z - _e2545.z);
                                        if (_e2520.member_1 == 1u) {
                                            phi_4509_ = (vec3<f32>(_e2520.member[0], _e2520.member[1], _e2520.member[2]) - _e2545);
                                        } else {
                                            phi_4509_ = vec3<f32>(_e2520.member[0], _e2520.member[1], _e2520.member[2]);
                                        }
                                        let _e2591 = phi_4509_;
                                        let _e2597 = bitcast<f32>((bitcast<u32>((_e2564 * _e2574)) ^ _e2520.member_3[0]));
                                        let _e2601 = bitcast<f32>((bitcast<u32>((_e2567 * _e2572)) ^ _e2520.member_3[0]));
                                        let _e2605 = bitcast<f32>((bitcast<u32>((_e2567 * _e2576)) ^ _e2520.member_3[0]));
                                        let _e2609 = bitcast<f32>((bitcast<u32>((_e2570 * _e2574)) ^ _e2520.member_3[0]));
                                        let _e2613 = bitcast<f32>((bitcast<u32>((_e2570 * _e2572)) ^ _e2520.member_3[0]));
                                        let _e2617 = bitcast<f32>((bitcast<u32>((_e2564 * _e2576)) ^ _e2520.member_3[0]));
                                        let _e2618 = (_e2605 - _e2609);
                                        let _e2619 = (_e2613 - _e2617);
                                        let _e2620 = (_e2597 - _e2601);
                                        let _e2644 = (bitcast<f32>((bitcast<u32>(_e2605) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2609) & 2147483647u)));
                                        let _e2651 = (bitcast<f32>((bitcast<u32>(_e2613) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2617) & 2147483647u)));
                                        let _e2658 = (bitcast<f32>((bitcast<u32>(_e2597) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2601) & 2147483647u)));
                                        if (_e2520.member_2 == 0f) {
                                            phi_4691_ = 0f;
                                        } else {
                                            let _e2688 = bitcast<f32>((bitcast<u32>(_e2618) & 2147483647u));
                                            let _e2691 = bitcast<f32>((bitcast<u32>(_e2619) & 2147483647u));
                                            let _e2694 = bitcast<f32>((bitcast<u32>(_e2620) & 2147483647u));
                                            let _e2696 = select(_e2694, _e2691, (_e2691 > _e2694));
                                            let _e2700 = select(_e2694, _e2691, (_e2691 < _e2694));
                                            let _e2704 = select(_e2691, _e2688, (_e2688 < _e2691));
                                            let _e2706 = select(_e2691, _e2688, (_e2688 > _e2691));
                                            let _e2708 = select(_e2694, _e2706, (_e2706 < _e2694));
                                            phi_4691_ = bitcast<f32>((bitcast<u32>((_e2520.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2696, _e2688, (_e2688 > _e2696)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2708, _e2704, (_e2704 > _e2708)))) ^ _e2520.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2700, _e2688, (_e2688 < _e2700)))) ^ _e2520.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2644 + _e2651) + _e2658))) ^ _e2520.member_3[0]))) * 1.0000005f)) ^ _e2520.member_3[0])))) ^ _e2520.member_3[0]));
                                        }
                                        let _e2735 = phi_4691_;
                                        phi_4709_ = (_e2537 || !(((((bitcast<f32>((bitcast<u32>((_e2591.x * _e2618)) ^ _e2520.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2591.y * _e2619)) ^ _e2520.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2591.z * _e2620)) ^ _e2520.member_3[0]))) * f32(-(_e2536))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2591.x) & 2147483647u)) * _e2644)) ^ _e2520.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2591.y) & 2147483647u)) * _e2651)) ^ _e2520.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2591.z) & 2147483647u)) * _e2658)) ^ _e2520.member_3[0]))))) ^ _e2520.member_3[0])) + _e2735) + 0.0000000000000000000000000000000000001880791f))));
                                    }
                                    let _e2749 = phi_4709_;
                                    phi_4710_ = _e2749;
                                }
                                let _e2751 = phi_4710_;
                                if _e2751 {
                                    if (_e2390.member < _e1535.member.member.member) {
                                        phi_4730_ = true;
                                    } else {
                                        if (_e2390.member == _e1535.member.member.member) {
                                            phi_4729_ = (_e2390.member_3 < _e1535.member.member.member_3);
                                        } else {
                                            phi_4729_ = false;
                                        }
                                        let _e2763 = phi_4729_;
                                        phi_4730_ = _e2763;
                                    }
                                    let _e2765 = phi_4730_;
                                    if _e2765 {
                                        phi_4737_ = SlimbvhTypeP(SlimbvhTypeI(_e2390, _e2390.member), _e1535.member_1);
                                    } else {
                                        phi_4737_ = _e1535;
                                    }
                                    let _e2771 = phi_4737_;
                                    if _e2771.member_1 {
                                        phi_4743_ = SlimbvhTypeP(SlimbvhTypeI(_e2771.member.member, bitcast<f32>(4286578687u)), _e2771.member_1);
                                    } else {
                                        phi_4743_ = _e2771;
                                    }
                                    let _e2780 = phi_4743_;
                                    phi_4744_ = _e2780;
                                } else {
                                    phi_4744_ = _e1535;
                                }
                                let _e2782 = phi_4744_;
                                phi_4745_ = _e2782;
                            } else {
                                phi_4745_ = _e1535;
                            }
                            let _e2784 = phi_4745_;
                            phi_2899_ = _e2784;
                        } else {
                            phi_2899_ = SlimbvhTypeP();
                        }
                        let _e2786 = phi_2899_;
                        continue;
                        continuing {
                            phi_2898_ = _e2786;
                            phi_2901_ = _e1550;
                            break if !(_e1556);
                        }
                    }
                    let _e2789 = local_2;
                    let _e2790 = (_e2789 - 1u);
                    let _e2795 = slimbvh_stacks[(((_e2790 % 32u) * 64u) + _e706)];
                    let _e2796 = (_e2795 & 511u);
                    let _e2798 = (_e2796 >> bitcast<u32>(3u));
                    let _e2801 = ((_e2798 == 0u) || (_e2790 == 4294967295u));
                    if _e2801 {
                    } else {
                        slimbvh_stacks[(((_e2790 % 32u) * 64u) + _e706)] = (((_e2795 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2798);
                    }
                    let _e2808 = local_3;
                    let _e2816 = (((_e2795 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2796 & 3u) & 3u));
                    let _e2818 = (_e2816 >> bitcast<u32>(2i));
                    if (_e2818 < _e127) {
                        let _e2823 = slimbvh_nodes.member[_e2818][1u][3u];
                        let _e2827 = slimbvh_nodes.member[_e2818][2u][3u];
                        let _e2832 = (_e2827 >> bitcast<u32>(20u));
                        let _e2833 = (_e2816 & 3u);
                        if (((_e2832 >> bitcast<u32>((((3u * _e2833) & 31u) & 31u))) & 7u) == 7u) {
                            let _e2845 = ((_e2832 | (_e2832 << bitcast<u32>(10i))) & 4128831u);
                            phi_4836_ = (((_e2823 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e2845 | (_e2845 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e2833) & 31u) & 31u))) & 255u));
                        } else {
                            phi_4836_ = (2147483648u | _e2816);
                        }
                        let _e2863 = phi_4836_;
                        phi_4837_ = _e2863;
                    } else {
                        phi_4837_ = 4294967295u;
                    }
                    let _e2865 = phi_4837_;
                    let _e2867 = local_4;
                    let _e3178 = local_7;
                    phi_4846_ = _e3178;
                    phi_4847_ = select(select(_e2808, _e2790, _e2801), 4294967295u, (_e699 > _e2867.member.member_1));
                    phi_4848_ = _e2865;
                } else {
                    phi_4846_ = _e815;
                    let _e3181 = local_8;
                    phi_4847_ = _e3181;
                    let _e3184 = local_9;
                    phi_4848_ = _e3184;
                }
                let _e2873 = phi_4846_;
                let _e2875 = phi_4847_;
                let _e2877 = phi_4848_;
                phi_1736_ = _e2873;
                phi_1739_ = _e2875;
                phi_1741_ = _e2877;
                let _e3190 = local_10;
                phi_1743_ = _e3190;
            } else {
                phi_1736_ = SlimbvhTypeP();
                phi_1739_ = u32();
                phi_1741_ = u32();
                phi_1743_ = u32();
            }
            let _e2879 = phi_1736_;
            let _e2881 = phi_1739_;
            let _e2883 = phi_1741_;
            let _e2885 = phi_1743_;
            continue;
            continuing {
                phi_1735_ = _e2879;
                phi_1738_ = _e2881;
                phi_1740_ = _e2883;
                phi_1742_ = _e2885;
                break if !(_e822);
            }
        }
        let _e2888 = local_5;
        let _e2889 = (_e2888 == 4294967295u);
        let _e2891 = local_6;
        if (_e2891.member.member.member_3 != 4294967295u) {
            let _e2897 = -((_e202 + _e632.member_4));
            let _e2898 = bitcast<u32>(_e2891.member.member.member);
            let _e2902 = (bitcast<i32>((_e2898 >> bitcast<u32>(23i))) & 255i);
            let _e2903 = (_e2902 + _e2897);
            if (_e2902 == 255i) {
                phi_4906_ = _e2891.member.member.member;
            } else {
                if (_e2902 > 0i) {
                    if (_e2903 > 0i) {
                        let _e2907 = (_e2903 < 255i);
                        if _e2907 {
                            phi_4885_ = bitcast<f32>((_e2898 + bitcast<u32>((_e2897 << bitcast<u32>(23i)))));
                        } else {
                            phi_4885_ = f32();
                        }
                        let _e2914 = phi_4885_;
                        phi_4887_ = _e2914;
                        phi_4888_ = select(true, false, _e2907);
                    } else {
                        phi_4887_ = f32();
                        phi_4888_ = true;
                    }
                    let _e2917 = phi_4887_;
                    let _e2919 = phi_4888_;
                    phi_4889_ = _e2917;
                    phi_4890_ = _e2919;
                } else {
                    phi_4889_ = f32();
                    phi_4890_ = true;
                }
                let _e2921 = phi_4889_;
                let _e2923 = phi_4890_;
                if _e2923 {
                    let _e2924 = (_e2898 & 2147483648u);
                    let _e2931 = ((_e2898 & 8388607u) | (select(0u, 1u, ((_e2898 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e2935 = (_e2931 == 0u);
                    if _e2935 {
                        phi_5588_ = bitcast<f32>(_e2924);
                    } else {
                        let _e2940 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2931)), 32u, _e2935) - 8u);
                        let _e2943 = (_e2931 << bitcast<u32>((_e2940 & 31u)));
                        let _e2945 = ((_e2903 + select(0i, 1i, (_e2902 == 0i))) - bitcast<i32>(_e2940));
                        if (_e2945 >= 255i) {
                            phi_5578_ = bitcast<f32>((_e2924 | 2139095040u));
                            phi_5579_ = f32();
                            phi_5580_ = true;
                        } else {
                            let _e2947 = (_e2945 > 0i);
                            if _e2947 {
                                phi_5572_ = bitcast<f32>(((_e2924 | (bitcast<u32>(_e2945) << bitcast<u32>(23i))) | (_e2943 & 8388607u)));
                                phi_5573_ = f32();
                            } else {
                                if (_e2945 < -24i) {
                                    phi_5538_ = 26u;
                                } else {
                                    phi_5538_ = bitcast<u32>((1i - _e2945));
                                }
                                let _e2952 = phi_5538_;
                                let _e2953 = (_e2952 & 31u);
                                let _e2955 = (_e2943 >> bitcast<u32>(_e2953));
                                let _e2959 = (_e2943 & ((1u << bitcast<u32>(_e2953)) - 1u));
                                let _e2963 = (1u << bitcast<u32>(((_e2952 - 1u) & 31u)));
                                if (_e2959 > _e2963) {
                                    phi_5559_ = true;
                                } else {
                                    if (_e2959 == _e2963) {
                                        phi_5556_ = ((_e2955 & 1u) == 1u);
                                    } else {
                                        phi_5556_ = false;
                                    }
                                    let _e2969 = phi_5556_;
                                    phi_5559_ = _e2969;
                                }
                                let _e2971 = phi_5559_;
                                phi_5572_ = f32();
                                phi_5573_ = bitcast<f32>((_e2924 | (_e2955 + select(0u, 1u, _e2971))));
                            }
                            let _e2984 = phi_5572_;
                            let _e2986 = phi_5573_;
                            phi_5578_ = _e2984;
                            phi_5579_ = _e2986;
                            phi_5580_ = _e2947;
                        }
                        let _e2990 = phi_5578_;
                        let _e2992 = phi_5579_;
                        let _e2994 = phi_5580_;
                        phi_5588_ = select(_e2992, _e2990, _e2994);
                    }
                    let _e2998 = phi_5588_;
                    phi_4905_ = _e2998;
                } else {
                    phi_4905_ = _e2921;
                }
                let _e3000 = phi_4905_;
                phi_4906_ = _e3000;
            }
            let _e3002 = phi_4906_;
            let _e3003 = bitcast<u32>(_e3002);
            if ((_e3003 & 2147483647u) >= 2139095040u) {
                phi_4918_ = bitcast<f32>(((_e3003 & 2147483648u) | 2139095039u));
            } else {
                phi_4918_ = _e3002;
            }
            let _e3010 = phi_4918_;
            phi_4923_ = SlimbvhTypeF(_e3010, _e2891.member.member.member_1, _e2891.member.member.member_2, _e2891.member.member.member_3);
        } else {
            phi_4923_ = _e123;
        }
        let _e3015 = phi_4923_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e3015.member), bitcast<u32>(_e3015.member_1), bitcast<u32>(_e3015.member_2), _e3015.member_3);
        phi_4936_ = _e2889;
        phi_4937_ = _e2889;
        phi_4938_ = select(true, false, _e2889);
    } else {
        phi_4936_ = bool();
        phi_4937_ = false;
        phi_4938_ = true;
    }
    let _e3026 = phi_4936_;
    let _e3028 = phi_4937_;
    let _e3030 = phi_4938_;
    if _e3030 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e3026, _e3028, _e3030)));
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
