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
    var phi_581_: u32;
    var phi_587_: u32;
    var phi_593_: u32;
    var phi_858_: i32;
    var phi_869_: i32;
    var phi_983_: i32;
    var phi_1112_: i32;
    var phi_1134_: u32;
    var phi_1135_: u32;
    var phi_1136_: bool;
    var phi_1170_: i32;
    var phi_1192_: u32;
    var phi_1193_: u32;
    var phi_1194_: bool;
    var phi_755_: i32;
    var phi_761_: u32;
    var phi_780_: u32;
    var phi_781_: u32;
    var phi_782_: bool;
    var phi_800_: i32;
    var phi_806_: u32;
    var phi_825_: u32;
    var phi_826_: u32;
    var phi_827_: bool;
    var phi_1204_: SlimbvhTypeC;
    var phi_1440_: SlimbvhTypeO;
    var phi_1503_: array<f32, 3>;
    var phi_1504_: array<f32, 3>;
    var phi_1522_: array<f32, 3>;
    var phi_1523_: array<f32, 3>;
    var phi_1696_: SlimbvhTypeO;
    var phi_1699_: u32;
    var phi_1701_: u32;
    var phi_1703_: u32;
    var phi_1712_: u32;
    var phi_1715_: u32;
    var phi_1717_: u32;
    var phi_1819_: SlimbvhTypeI;
    var phi_1820_: SlimbvhTypeI;
    var phi_1879_: SlimbvhTypeI;
    var phi_1880_: SlimbvhTypeI;
    var phi_1939_: SlimbvhTypeI;
    var phi_1940_: SlimbvhTypeI;
    var phi_2430_: u32;
    var phi_2443_: u32;
    var phi_2456_: u32;
    var phi_2469_: u32;
    var phi_4701_: SlimbvhTypeD;
    var phi_4713_: SlimbvhTypeD;
    var phi_4725_: SlimbvhTypeD;
    var phi_4737_: SlimbvhTypeD;
    var phi_4749_: SlimbvhTypeD;
    var phi_2553_: u32;
    var phi_2558_: u32;
    var phi_2559_: u32;
    var phi_2613_: u32;
    var phi_2614_: u32;
    var phi_1713_: u32;
    var phi_1716_: u32;
    var phi_1718_: u32;
    var local: bool;
    var local_1: u32;
    var phi_2799_: u32;
    var phi_2804_: u32;
    var phi_2847_: SlimbvhTypeL;
    var phi_2851_: SlimbvhTypeO;
    var phi_2854_: SlimbvhTypeD;
    var phi_2855_: SlimbvhTypeD;
    var phi_2877_: SlimbvhTypeD;
    var phi_2905_: u32;
    var phi_2928_: u32;
    var phi_2937_: u32;
    var phi_2947_: u32;
    var phi_3406_: u32;
    var phi_3419_: u32;
    var phi_3432_: u32;
    var phi_3458_: u32;
    var phi_3471_: u32;
    var phi_3484_: u32;
    var phi_3510_: u32;
    var phi_3523_: u32;
    var phi_3536_: u32;
    var phi_3128_: u32;
    var phi_3141_: u32;
    var phi_3151_: u32;
    var phi_3172_: u32;
    var phi_3193_: u32;
    var phi_3220_: u32;
    var phi_3233_: u32;
    var phi_3243_: u32;
    var phi_3264_: u32;
    var phi_3285_: u32;
    var phi_3312_: u32;
    var phi_3325_: u32;
    var phi_3335_: u32;
    var phi_3356_: u32;
    var phi_3377_: u32;
    var phi_2989_: u32;
    var phi_3035_: u32;
    var phi_3081_: u32;
    var phi_3548_: array<array<f32, 3>, 3>;
    var phi_3913_: f32;
    var phi_3914_: f32;
    var phi_3915_: f32;
    var phi_3916_: f32;
    var phi_3917_: vec3<f32>;
    var phi_3918_: vec3<f32>;
    var phi_3919_: vec3<f32>;
    var phi_3920_: vec3<f32>;
    var phi_4099_: f32;
    var phi_4125_: SlimbvhTypeE;
    var phi_4126_: SlimbvhTypeE;
    var phi_4129_: SlimbvhTypeE;
    var phi_4130_: SlimbvhTypeE;
    var phi_4131_: bool;
    var phi_4135_: SlimbvhTypeE;
    var phi_4144_: SlimbvhTypeF;
    var phi_4171_: bool;
    var phi_4172_: bool;
    var phi_4179_: SlimbvhTypeO;
    var phi_4185_: SlimbvhTypeO;
    var phi_4186_: SlimbvhTypeO;
    var phi_4187_: SlimbvhTypeO;
    var phi_2852_: SlimbvhTypeO;
    var local_2: u32;
    var local_3: u32;
    var phi_4278_: u32;
    var phi_4279_: u32;
    var local_4: SlimbvhTypeO;
    var phi_4288_: SlimbvhTypeO;
    var phi_4289_: u32;
    var phi_4290_: u32;
    var phi_1697_: SlimbvhTypeO;
    var phi_1700_: u32;
    var phi_1702_: u32;
    var phi_1704_: u32;
    var local_5: u32;
    var local_6: SlimbvhTypeO;
    var phi_4327_: f32;
    var phi_4329_: f32;
    var phi_4330_: bool;
    var phi_4331_: f32;
    var phi_4332_: bool;
    var phi_4980_: u32;
    var phi_4998_: bool;
    var phi_5001_: bool;
    var phi_5014_: f32;
    var phi_5015_: f32;
    var phi_5020_: f32;
    var phi_5021_: f32;
    var phi_5022_: bool;
    var phi_5030_: f32;
    var phi_4347_: f32;
    var phi_4348_: f32;
    var phi_4360_: f32;
    var phi_4365_: SlimbvhTypeF;
    var phi_4378_: bool;
    var phi_4379_: bool;
    var phi_4380_: bool;
    var local_7: SlimbvhTypeO;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e114 = SlimbvhTypeF(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e118 = arrayLength((&slimbvh_nodes.member));
    let _e121 = arrayLength((&slimbvh_triangles.member));
    let _e131 = slimbvh_root.member[0u][0u];
    let _e135 = slimbvh_root.member[0u][1u];
    let _e139 = slimbvh_root.member[0u][2u];
    let _e143 = slimbvh_root.member[0u][3u];
    let _e147 = slimbvh_root.member[1u][0u];
    let _e151 = slimbvh_root.member[1u][1u];
    let _e155 = slimbvh_root.member[1u][2u];
    let _e167 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e143) + 127i)) << bitcast<u32>(23i)));
    let _e168 = slimbvh_origin.member;
    let _e174 = slimbvh_origin.member[3u];
    let _e175 = slimbvh_direction.member;
    let _e181 = slimbvh_direction.member[3u];
    let _e184 = slimbvh_exponent.member[0u];
    let _e185 = bitcast<i32>(_e184);
    let _e187 = (bitcast<u32>(_e168.x) & 2147483647u);
    let _e189 = (bitcast<u32>(_e168.y) & 2147483647u);
    let _e191 = (bitcast<u32>(_e168.z) & 2147483647u);
    let _e192 = bitcast<u32>(_e174);
    let _e193 = (_e192 & 2147483647u);
    let _e195 = (bitcast<u32>(_e175.x) & 2147483647u);
    let _e197 = (bitcast<u32>(_e175.y) & 2147483647u);
    let _e199 = (bitcast<u32>(_e175.z) & 2147483647u);
    let _e200 = bitcast<u32>(_e181);
    let _e201 = (_e200 & 2147483647u);
    let _e203 = select(_e197, _e195, (_e197 < _e195));
    let _e205 = select(_e199, _e203, (_e199 < _e203));
    let _e207 = select(_e187, _e205, (_e187 < _e205));
    let _e209 = select(_e189, _e207, (_e189 < _e207));
    let _e211 = select(_e191, _e209, (_e191 < _e209));
    let _e218 = (((select(_e193, _e211, (_e193 < _e211)) < 2139095040u) && (_e201 <= 2139095040u)) && (_e205 > 0u));
    if (_e195 == _e205) {
        phi_581_ = 0u;
    } else {
        phi_581_ = select(2u, 1u, (_e197 == _e205));
    }
    let _e223 = phi_581_;
    let _e224 = (_e223 == 2u);
    if _e224 {
        phi_587_ = 0u;
    } else {
        phi_587_ = (_e223 + 1u);
    }
    let _e227 = phi_587_;
    let _e228 = (_e227 == 2u);
    if _e228 {
        phi_593_ = 0u;
    } else {
        phi_593_ = (_e227 + 1u);
    }
    let _e231 = phi_593_;
    let _e232 = (_e227 == 0u);
    let _e234 = select(select(_e168.y, _e168.x, _e232), _e168.z, _e228);
    let _e235 = (_e231 == 0u);
    let _e237 = (_e231 == 2u);
    let _e238 = select(select(_e168.y, _e168.x, _e235), _e168.z, _e237);
    let _e239 = (_e223 == 0u);
    let _e241 = select(select(_e168.y, _e168.x, _e239), _e168.z, _e224);
    let _e243 = select(select(_e175.y, _e175.x, _e232), _e175.z, _e228);
    let _e245 = select(select(_e175.y, _e175.x, _e235), _e175.z, _e237);
    let _e247 = select(select(_e175.y, _e175.x, _e239), _e175.z, _e224);
    let _e248 = (_e193 - 1u);
    let _e249 = (_e201 - 1u);
    let _e251 = select(_e248, _e249, (_e249 < _e248));
    let _e252 = (_e187 - 1u);
    let _e253 = (_e189 - 1u);
    let _e255 = select(_e252, _e253, (_e253 < _e252));
    let _e256 = (_e191 - 1u);
    let _e258 = select(_e255, _e256, (_e256 < _e255));
    let _e259 = (_e195 - 1u);
    let _e260 = (_e197 - 1u);
    let _e262 = select(_e259, _e260, (_e260 < _e259));
    let _e263 = (_e199 - 1u);
    let _e265 = select(_e262, _e263, (_e263 < _e262));
    let _e267 = select(_e258, _e265, (_e265 < _e258));
    if (((select(_e267, _e251, (_e251 < _e267)) >= 8388607u) && (_e205 < 2130706432u)) && (bitcast<u32>((_e185 + 126i)) <= 253u)) {
        let _e532 = bitcast<i32>((_e205 >> bitcast<u32>(23i)));
        let _e533 = (_e532 - 127i);
        let _e534 = (_e185 + _e533);
        let _e539 = bitcast<f32>((bitcast<u32>((_e185 + 127i)) << bitcast<u32>(23i)));
        let _e544 = bitcast<f32>((bitcast<u32>((254i - _e532)) << bitcast<u32>(23i)));
        if (_e193 >= 2139095040u) {
            phi_755_ = 255i;
        } else {
            phi_755_ = (bitcast<i32>((_e193 >> bitcast<u32>(23i))) + _e534);
        }
        let _e559 = phi_755_;
        if (_e193 == 0u) {
            phi_761_ = 0u;
        } else {
            phi_761_ = (_e193 | 8388608u);
        }
        let _e563 = phi_761_;
        if (_e559 <= 0i) {
            phi_781_ = u32();
            phi_782_ = true;
        } else {
            let _e570 = (_e563 == 0u);
            if _e570 {
                phi_780_ = u32();
            } else {
                phi_780_ = select(((bitcast<u32>(_e559) << bitcast<u32>(23i)) | (_e563 & 8388607u)), 2139095039u, (_e559 >= 255i));
            }
            let _e574 = phi_780_;
            phi_781_ = _e574;
            phi_782_ = _e570;
        }
        let _e576 = phi_781_;
        let _e578 = phi_782_;
        if (_e201 >= 2139095040u) {
            phi_800_ = 255i;
        } else {
            phi_800_ = (bitcast<i32>((_e201 >> bitcast<u32>(23i))) + _e534);
        }
        let _e589 = phi_800_;
        if (_e201 == 0u) {
            phi_806_ = 0u;
        } else {
            phi_806_ = (_e201 | 8388608u);
        }
        let _e593 = phi_806_;
        if (_e589 <= 0i) {
            phi_826_ = u32();
            phi_827_ = true;
        } else {
            let _e600 = (_e593 == 0u);
            if _e600 {
                phi_825_ = u32();
            } else {
                phi_825_ = select(((bitcast<u32>(_e589) << bitcast<u32>(23i)) | (_e593 & 8388607u)), 2139095039u, (_e589 >= 255i));
            }
            let _e604 = phi_825_;
            phi_826_ = _e604;
            phi_827_ = _e600;
        }
        let _e606 = phi_826_;
        let _e608 = phi_827_;
        phi_1204_ = SlimbvhTypeC(array<f32, 3>((_e234 * _e539), (_e238 * _e539), (_e241 * _e539)), array<f32, 3>((_e243 * _e544), (_e245 * _e544), (_e247 * _e544)), bitcast<f32>(((_e192 & 2147483648u) | select(_e576, 0u, _e578))), bitcast<f32>(((_e200 & 2147483648u) | select(_e606, 0u, _e608))), _e533);
    } else {
        let _e280 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e205, _e218))) & 2147483647u);
        if (_e280 >= 8388608u) {
            phi_858_ = (bitcast<i32>((_e280 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_858_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e280)), 32u, (_e280 == 0u))));
        }
        let _e294 = phi_858_;
        let _e295 = (_e185 + _e294);
        if (_e185 < -126i) {
            phi_869_ = -126i;
        } else {
            phi_869_ = select(_e185, 127i, (_e185 > 127i));
        }
        let _e300 = phi_869_;
        let _e305 = bitcast<f32>((bitcast<u32>((_e300 + 127i)) << bitcast<u32>(23i)));
        let _e311 = bitcast<f32>((bitcast<u32>(((_e185 - _e300) + 127i)) << bitcast<u32>(23i)));
        let _e312 = bitcast<u32>(_e234);
        let _e314 = ((_e312 & 2139095040u) != 0u);
        let _e329 = bitcast<u32>(_e238);
        let _e331 = ((_e329 & 2139095040u) != 0u);
        let _e346 = bitcast<u32>(_e241);
        let _e348 = ((_e346 & 2139095040u) != 0u);
        let _e364 = -(_e294);
        if (_e364 < -126i) {
            phi_983_ = -126i;
        } else {
            phi_983_ = select(_e364, 127i, (_e364 > 127i));
        }
        let _e369 = phi_983_;
        let _e374 = bitcast<f32>((bitcast<u32>((_e369 + 127i)) << bitcast<u32>(23i)));
        let _e380 = bitcast<f32>((bitcast<u32>(((_e364 - _e369) + 127i)) << bitcast<u32>(23i)));
        let _e381 = bitcast<u32>(_e243);
        let _e383 = ((_e381 & 2139095040u) != 0u);
        let _e398 = bitcast<u32>(_e245);
        let _e400 = ((_e398 & 2139095040u) != 0u);
        let _e415 = bitcast<u32>(_e247);
        let _e417 = ((_e415 & 2139095040u) != 0u);
        let _e439 = ((_e193 & 8388607u) | (select(0u, 1u, ((_e193 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e442 = bitcast<i32>((_e193 >> bitcast<u32>(23i)));
        let _e449 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e439)), 32u, (_e439 == 0u))) - 8i);
        if (_e442 == 255i) {
            phi_1112_ = 255i;
        } else {
            phi_1112_ = (((_e442 + select(0i, 1i, (_e442 == 0i))) - _e449) + _e295);
        }
        let _e457 = phi_1112_;
        let _e461 = (_e439 << bitcast<u32>(((_e449 & 31i) & 31i)));
        if (_e457 <= 0i) {
            phi_1135_ = u32();
            phi_1136_ = true;
        } else {
            let _e468 = (_e461 == 0u);
            if _e468 {
                phi_1134_ = u32();
            } else {
                phi_1134_ = select(((bitcast<u32>(_e457) << bitcast<u32>(23i)) | (_e461 & 8388607u)), 2139095039u, (_e457 >= 255i));
            }
            let _e472 = phi_1134_;
            phi_1135_ = _e472;
            phi_1136_ = _e468;
        }
        let _e474 = phi_1135_;
        let _e476 = phi_1136_;
        let _e487 = ((_e201 & 8388607u) | (select(0u, 1u, ((_e201 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e490 = bitcast<i32>((_e201 >> bitcast<u32>(23i)));
        let _e497 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e487)), 32u, (_e487 == 0u))) - 8i);
        if (_e490 == 255i) {
            phi_1170_ = 255i;
        } else {
            phi_1170_ = (((_e490 + select(0i, 1i, (_e490 == 0i))) - _e497) + _e295);
        }
        let _e505 = phi_1170_;
        let _e509 = (_e487 << bitcast<u32>(((_e497 & 31i) & 31i)));
        if (_e505 <= 0i) {
            phi_1193_ = u32();
            phi_1194_ = true;
        } else {
            let _e516 = (_e509 == 0u);
            if _e516 {
                phi_1192_ = u32();
            } else {
                phi_1192_ = select(((bitcast<u32>(_e505) << bitcast<u32>(23i)) | (_e509 & 8388607u)), 2139095039u, (_e505 >= 255i));
            }
            let _e520 = phi_1192_;
            phi_1193_ = _e520;
            phi_1194_ = _e516;
        }
        let _e522 = phi_1193_;
        let _e524 = phi_1194_;
        phi_1204_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e312 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e312 & 2147483648u))), _e234, _e314) * _e305) * select(0.00000011920929f, 1f, _e314)) * _e311), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e329 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e329 & 2147483648u))), _e238, _e331) * _e305) * select(0.00000011920929f, 1f, _e331)) * _e311), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e346 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e346 & 2147483648u))), _e241, _e348) * _e305) * select(0.00000011920929f, 1f, _e348)) * _e311)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e381 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e381 & 2147483648u))), _e243, _e383) * _e374) * select(0.00000011920929f, 1f, _e383)) * _e380), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e398 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e398 & 2147483648u))), _e245, _e400) * _e374) * select(0.00000011920929f, 1f, _e400)) * _e380), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e415 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e415 & 2147483648u))), _e247, _e417) * _e374) * select(0.00000011920929f, 1f, _e417)) * _e380)), bitcast<f32>(((_e192 & 2147483648u) | select(_e474, 0u, _e476))), bitcast<f32>(((_e200 & 2147483648u) | select(_e522, 0u, _e524))), _e294);
    }
    let _e615 = phi_1204_;
    let _e630 = (bitcast<f32>((bitcast<u32>(_e615.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e633 = bitcast<f32>((bitcast<u32>(_e615.member[0]) & 2147483647u));
    let _e634 = (_e633 * 0.00000011920929f);
    let _e637 = select(select(0.00000000000011368684f, _e634, (_e634 > 0.00000000000011368684f)), 0f, _e630);
    let _e638 = select(0f, _e615.member_1[0], _e630);
    let _e639 = (_e615.member[0] + _e637);
    let _e640 = (_e615.member[0] - _e637);
    let _e642 = select(38685626000000000000000000f, (1f / _e615.member_1[0]), _e630);
    let _e646 = (bitcast<f32>((bitcast<u32>(_e615.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e649 = bitcast<f32>((bitcast<u32>(_e615.member[1]) & 2147483647u));
    let _e650 = (_e649 * 0.00000011920929f);
    let _e653 = select(select(0.00000000000011368684f, _e650, (_e650 > 0.00000000000011368684f)), 0f, _e646);
    let _e654 = select(0f, _e615.member_1[1], _e646);
    let _e655 = (_e615.member[1] + _e653);
    let _e656 = (_e615.member[1] - _e653);
    let _e658 = select(38685626000000000000000000f, (1f / _e615.member_1[1]), _e646);
    let _e662 = (bitcast<f32>((bitcast<u32>(_e615.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e665 = bitcast<f32>((bitcast<u32>(_e615.member[2]) & 2147483647u));
    let _e666 = (_e665 * 0.00000011920929f);
    let _e669 = select(select(0.00000000000011368684f, _e666, (_e666 > 0.00000000000011368684f)), 0f, _e662);
    let _e670 = select(0f, _e615.member_1[2], _e662);
    let _e671 = (_e615.member[2] + _e669);
    let _e672 = (_e615.member[2] - _e669);
    let _e674 = select(38685626000000000000000000f, (1f / _e615.member_1[2]), _e662);
    let _e676 = select(_e649, _e633, (_e633 > _e649));
    let _e680 = (_e218 && (select(_e665, _e676, (_e676 > _e665)) <= 1099511600000f));
    let _e681 = select(0f, _e615.member_3, _e680);
    let _e682 = select(1f, _e615.member_2, _e680);
    let _e684 = slimbvh_lane.member;
    if (_e684 < 64u) {
        let _e686 = (_e684 % 64u);
        let _e687 = slimbvh_any_will_do.member;
        if (_e687 == 1u) {
            phi_1440_ = SlimbvhTypeO(SlimbvhTypeH(_e114, _e681), true);
        } else {
            phi_1440_ = SlimbvhTypeO(SlimbvhTypeH(_e114, _e681), false);
        }
        let _e694 = phi_1440_;
        let _e699 = (_e227 & 3u);
        let _e700 = (_e231 & 3u);
        let _e701 = (_e223 & 3u);
        let _e714 = (f32(bitcast<i32>(_e131)) * _e167);
        let _e716 = (f32(bitcast<i32>(_e135)) * _e167);
        let _e718 = (f32(bitcast<i32>(_e139)) * _e167);
        let _e719 = (_e699 == 0u);
        if _e719 {
            phi_1504_ = array<f32, 3>(_e714, _e716, _e718);
        } else {
            if (_e699 == 1u) {
                phi_1503_ = array<f32, 3>(_e716, _e718, _e714);
            } else {
                phi_1503_ = array<f32, 3>(_e718, _e714, _e716);
            }
            let _e724 = phi_1503_;
            phi_1504_ = _e724;
        }
        let _e727 = phi_1504_;
        let _e729 = (f32(bitcast<i32>(_e147)) * _e167);
        let _e731 = (f32(bitcast<i32>(_e151)) * _e167);
        let _e733 = (f32(bitcast<i32>(_e155)) * _e167);
        if _e719 {
            phi_1523_ = array<f32, 3>(_e729, _e731, _e733);
        } else {
            if (_e699 == 1u) {
                phi_1522_ = array<f32, 3>(_e731, _e733, _e729);
            } else {
                phi_1522_ = array<f32, 3>(_e733, _e729, _e731);
            }
            let _e738 = phi_1522_;
            phi_1523_ = _e738;
        }
        let _e741 = phi_1523_;
        let _e752 = ((_e727[0] - _e639) * _e642);
        let _e753 = ((_e741[0] - _e640) * _e642);
        let _e754 = vec4<f32>(_e752, f32(), _e753, f32());
        let _e757 = ((_e727[1] - _e655) * _e658);
        let _e758 = ((_e741[1] - _e656) * _e658);
        let _e759 = vec4<f32>(_e757, f32(), _e758, f32());
        let _e762 = ((_e727[2] - _e671) * _e674);
        let _e763 = ((_e741[2] - _e672) * _e674);
        let _e764 = vec4<f32>(_e762, f32(), _e763, f32());
        let _e765 = vec4<f32>(_e753, f32(), _e752, f32());
        let _e767 = vec4<f32>(_e758, f32(), _e757, f32());
        let _e769 = vec4<f32>(_e763, f32(), _e762, f32());
        phi_1696_ = _e694;
        phi_1699_ = select(4294967295u, select(4294967295u, 0u, (_e682 <= _e681)), (max(max(max(min(_e754, _e765).x, min(_e759, _e767).x), min(_e764, _e769).x), _e682) <= min((min(min(max(_e754, _e765).x, max(_e759, _e767).x), max(_e764, _e769).x) + (max(max(_e764, _e769).x, -(min(_e764, _e769).x)) * 0.0000019073523f)), _e694.member.member_1)));
        phi_1701_ = select(0u, 4294967295u, (_e118 == 0u));
        phi_1703_ = (_e118 + 1u);
        loop {
            let _e793 = phi_1696_;
            let _e795 = phi_1699_;
            let _e797 = phi_1701_;
            let _e799 = phi_1703_;
            local_5 = _e795;
            local_6 = _e793;
            let _e800 = (_e795 <= 32u);
            if _e800 {
                phi_1712_ = _e795;
                phi_1715_ = _e797;
                phi_1717_ = _e799;
                loop {
                    let _e802 = phi_1712_;
                    let _e804 = phi_1715_;
                    let _e806 = phi_1717_;
                    local_1 = _e804;
                    local_2 = _e802;
                    local_3 = _e802;
                    local_8 = _e802;
                    local_9 = _e804;
                    local_10 = _e806;
                    let _e807 = (_e802 <= 32u);
                    let _e810 = (_e807 && !((_e804 >= _e118)));
                    local = _e807;
                    if _e810 {
                        let _e815 = slimbvh_nodes.member[_e804][select(_e699, 2u, (2u < _e699))];
                        let _e820 = slimbvh_nodes.member[_e804][select(_e700, 2u, (2u < _e700))];
                        let _e825 = slimbvh_nodes.member[_e804][select(_e701, 2u, (2u < _e701))];
                        let _e828 = bitcast<u32>(_e167);
                        let _e833 = bitcast<f32>(_e815.x);
                        let _e834 = bitcast<f32>((_e828 + ((_e815.w & 31u) << bitcast<u32>(23i))));
                        let _e835 = (_e833 + _e834);
                        if ((bitcast<u32>(_e642) >> bitcast<u32>(31i)) == 0u) {
                            phi_1819_ = SlimbvhTypeI(_e815.z, _e835);
                            phi_1820_ = SlimbvhTypeI(_e815.y, _e833);
                        } else {
                            phi_1819_ = SlimbvhTypeI(_e815.y, _e833);
                            phi_1820_ = SlimbvhTypeI(_e815.z, _e835);
                        }
                        let _e846 = phi_1819_;
                        let _e848 = phi_1820_;
                        let _e887 = bitcast<f32>(_e820.x);
                        let _e888 = bitcast<f32>((_e828 + ((_e820.w & 31u) << bitcast<u32>(23i))));
                        let _e889 = (_e887 + _e888);
                        if ((bitcast<u32>(_e658) >> bitcast<u32>(31i)) == 0u) {
                            phi_1879_ = SlimbvhTypeI(_e820.z, _e889);
                            phi_1880_ = SlimbvhTypeI(_e820.y, _e887);
                        } else {
                            phi_1879_ = SlimbvhTypeI(_e820.y, _e887);
                            phi_1880_ = SlimbvhTypeI(_e820.z, _e889);
                        }
                        let _e900 = phi_1879_;
                        let _e902 = phi_1880_;
                        let _e941 = bitcast<f32>(_e825.x);
                        let _e942 = bitcast<f32>((_e828 + ((_e825.w & 31u) << bitcast<u32>(23i))));
                        let _e943 = (_e941 + _e942);
                        if ((bitcast<u32>(_e674) >> bitcast<u32>(31i)) == 0u) {
                            phi_1939_ = SlimbvhTypeI(_e825.z, _e943);
                            phi_1940_ = SlimbvhTypeI(_e825.y, _e941);
                        } else {
                            phi_1939_ = SlimbvhTypeI(_e825.y, _e941);
                            phi_1940_ = SlimbvhTypeI(_e825.z, _e943);
                        }
                        let _e954 = phi_1939_;
                        let _e956 = phi_1940_;
                        let _e991 = (_e834 * _e642);
                        let _e994 = bitcast<f32>((bitcast<u32>(_e991) & 2147483647u));
                        let _e998 = (((_e848.member_1 - _e639) * _e642) + (_e994 * -0.00012207031f));
                        let _e1010 = (((_e846.member_1 - _e640) * _e642) + (_e994 * 0.00012207031f));
                        let _e1019 = (_e888 * _e658);
                        let _e1022 = bitcast<f32>((bitcast<u32>(_e1019) & 2147483647u));
                        let _e1026 = (((_e902.member_1 - _e655) * _e658) + (_e1022 * -0.00012207031f));
                        let _e1038 = (((_e900.member_1 - _e656) * _e658) + (_e1022 * 0.00012207031f));
                        let _e1047 = (_e942 * _e674);
                        let _e1050 = bitcast<f32>((bitcast<u32>(_e1047) & 2147483647u));
                        let _e1054 = (((_e956.member_1 - _e671) * _e674) + (_e1050 * -0.00012207031f));
                        let _e1059 = ((f32((_e956.member & 255u)) * _e1047) + _e1054);
                        let _e1060 = ((f32(((_e956.member >> bitcast<u32>(8u)) & 255u)) * _e1047) + _e1054);
                        let _e1061 = ((f32(((_e956.member >> bitcast<u32>(16u)) & 255u)) * _e1047) + _e1054);
                        let _e1062 = ((f32(((_e956.member >> bitcast<u32>(24u)) & 255u)) * _e1047) + _e1054);
                        let _e1066 = (((_e954.member_1 - _e672) * _e674) + (_e1050 * 0.00012207031f));
                        let _e1071 = ((f32((_e954.member & 255u)) * _e1047) + _e1066);
                        let _e1072 = ((f32(((_e954.member >> bitcast<u32>(8u)) & 255u)) * _e1047) + _e1066);
                        let _e1073 = ((f32(((_e954.member >> bitcast<u32>(16u)) & 255u)) * _e1047) + _e1066);
                        let _e1074 = ((f32(((_e954.member >> bitcast<u32>(24u)) & 255u)) * _e1047) + _e1066);
                        let _e1107 = max(max(max(((f32((_e848.member & 255u)) * _e991) + _e998), ((f32((_e902.member & 255u)) * _e1019) + _e1026)), _e1059), _e682);
                        let _e1108 = max(max(max(((f32(((_e848.member >> bitcast<u32>(8u)) & 255u)) * _e991) + _e998), ((f32(((_e902.member >> bitcast<u32>(8u)) & 255u)) * _e1019) + _e1026)), _e1060), _e682);
                        let _e1109 = max(max(max(((f32(((_e848.member >> bitcast<u32>(16u)) & 255u)) * _e991) + _e998), ((f32(((_e902.member >> bitcast<u32>(16u)) & 255u)) * _e1019) + _e1026)), _e1061), _e682);
                        let _e1110 = max(max(max(((f32(((_e848.member >> bitcast<u32>(24u)) & 255u)) * _e991) + _e998), ((f32(((_e902.member >> bitcast<u32>(24u)) & 255u)) * _e1019) + _e1026)), _e1062), _e682);
                        let _e1115 = (_e793.member.member_1 + (bitcast<f32>((bitcast<u32>(_e793.member.member_1) & 2147483647u)) * 0.0000004768374f));
                        if (_e1107 <= min((min(min(((f32((_e846.member & 255u)) * _e991) + _e1010), ((f32((_e900.member & 255u)) * _e1019) + _e1038)), _e1071) + (max(_e1071, -(_e1059)) * 0.0000023841915f)), _e1115)) {
                            phi_2430_ = (((bitcast<u32>(_e1107) ^ select(0u, 4294967288u, _e694.member_1)) & 2147483640u) | 4u);
                        } else {
                            phi_2430_ = 4294967288u;
                        }
                        let _e1130 = phi_2430_;
                        if (_e1108 <= min((min(min(((f32(((_e846.member >> bitcast<u32>(8u)) & 255u)) * _e991) + _e1010), ((f32(((_e900.member >> bitcast<u32>(8u)) & 255u)) * _e1019) + _e1038)), _e1072) + (max(_e1072, -(_e1060)) * 0.0000023841915f)), _e1115)) {
                            phi_2443_ = ((((bitcast<u32>(_e1108) ^ select(0u, 4294967288u, _e694.member_1)) & 2147483640u) | 4u) | 1u);
                        } else {
                            phi_2443_ = 4294967288u;
                        }
                        let _e1138 = phi_2443_;
                        if (_e1109 <= min((min(min(((f32(((_e846.member >> bitcast<u32>(16u)) & 255u)) * _e991) + _e1010), ((f32(((_e900.member >> bitcast<u32>(16u)) & 255u)) * _e1019) + _e1038)), _e1073) + (max(_e1073, -(_e1061)) * 0.0000023841915f)), _e1115)) {
                            phi_2456_ = ((((bitcast<u32>(_e1109) ^ select(0u, 4294967288u, _e694.member_1)) & 2147483640u) | 4u) | 2u);
                        } else {
                            phi_2456_ = 4294967288u;
                        }
                        let _e1146 = phi_2456_;
                        if (_e1110 <= min((min(min(((f32(((_e846.member >> bitcast<u32>(24u)) & 255u)) * _e991) + _e1010), ((f32(((_e900.member >> bitcast<u32>(24u)) & 255u)) * _e1019) + _e1038)), _e1074) + (max(_e1074, -(_e1062)) * 0.0000023841915f)), _e1115)) {
                            phi_2469_ = ((((bitcast<u32>(_e1110) ^ select(0u, 4294967288u, _e694.member_1)) & 2147483640u) | 4u) | 3u);
                        } else {
                            phi_2469_ = 4294967288u;
                        }
                        let _e1154 = phi_2469_;
                        if (_e1130 < _e1138) {
                            phi_4701_ = SlimbvhTypeD(_e1130, _e1138);
                        } else {
                            phi_4701_ = SlimbvhTypeD(_e1138, _e1130);
                        }
                        let _e1159 = phi_4701_;
                        if (_e1146 < _e1154) {
                            phi_4713_ = SlimbvhTypeD(_e1146, _e1154);
                        } else {
                            phi_4713_ = SlimbvhTypeD(_e1154, _e1146);
                        }
                        let _e1166 = phi_4713_;
                        if (_e1159.member < _e1166.member) {
                            phi_4725_ = SlimbvhTypeD(_e1159.member, _e1166.member);
                        } else {
                            phi_4725_ = SlimbvhTypeD(_e1166.member, _e1159.member);
                        }
                        let _e1173 = phi_4725_;
                        if (_e1159.member_1 < _e1166.member_1) {
                            phi_4737_ = SlimbvhTypeD(_e1159.member_1, _e1166.member_1);
                        } else {
                            phi_4737_ = SlimbvhTypeD(_e1166.member_1, _e1159.member_1);
                        }
                        let _e1180 = phi_4737_;
                        if (_e1180.member < _e1173.member_1) {
                            phi_4749_ = SlimbvhTypeD(_e1180.member, _e1173.member_1);
                        } else {
                            phi_4749_ = SlimbvhTypeD(_e1173.member_1, _e1180.member);
                        }
                        let _e1187 = phi_4749_;
                        let _e1202 = (((_e1173.member & 7u) | ((_e1187.member & 7u) << bitcast<u32>(3u))) | (((_e1187.member_1 & 7u) | ((_e1180.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                        if (_e1202 == 0u) {
                            let _e1222 = (_e802 - 1u);
                            let _e1227 = slimbvh_stacks[(((_e1222 % 32u) * 64u) + _e686)];
                            let _e1228 = (_e1227 & 511u);
                            let _e1230 = (_e1228 >> bitcast<u32>(3u));
                            let _e1233 = ((_e1230 == 0u) || (_e1222 == 4294967295u));
                            if _e1233 {
                            } else {
                                slimbvh_stacks[(((_e1222 % 32u) * 64u) + _e686)] = (((_e1227 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1230);
                            }
                            phi_2558_ = select(_e802, _e1222, _e1233);
                            phi_2559_ = (((_e1227 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1228 & 3u) & 3u));
                        } else {
                            let _e1205 = (_e1202 >> bitcast<u32>(3u));
                            if (_e1205 == 0u) {
                                phi_2553_ = _e802;
                            } else {
                                slimbvh_stacks[(((_e802 % 32u) * 64u) + _e686)] = ((_e804 << bitcast<u32>(9u)) | _e1205);
                                phi_2553_ = (_e802 + 1u);
                            }
                            let _e1216 = phi_2553_;
                            phi_2558_ = _e1216;
                            phi_2559_ = ((_e804 << bitcast<u32>(2i)) | ((_e1202 & 3u) & 3u));
                        }
                        let _e1248 = phi_2558_;
                        let _e1250 = phi_2559_;
                        let _e1252 = (_e1250 >> bitcast<u32>(2i));
                        if (_e1252 < _e118) {
                            let _e1257 = slimbvh_nodes.member[_e1252][1u][3u];
                            let _e1261 = slimbvh_nodes.member[_e1252][2u][3u];
                            let _e1266 = (_e1261 >> bitcast<u32>(20u));
                            let _e1267 = (_e1250 & 3u);
                            if (((_e1266 >> bitcast<u32>((((3u * _e1267) & 31u) & 31u))) & 7u) == 7u) {
                                let _e1279 = ((_e1266 | (_e1266 << bitcast<u32>(10i))) & 4128831u);
                                phi_2613_ = (((_e1257 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e1279 | (_e1279 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e1267) & 31u) & 31u))) & 255u));
                            } else {
                                phi_2613_ = (2147483648u | _e1250);
                            }
                            let _e1297 = phi_2613_;
                            phi_2614_ = _e1297;
                        } else {
                            phi_2614_ = 4294967295u;
                        }
                        let _e1299 = phi_2614_;
                        let _e1300 = (_e806 - 1u);
                        phi_1713_ = select(_e1248, 4294967295u, (_e1300 == 0u));
                        phi_1716_ = _e1299;
                        phi_1718_ = _e1300;
                    } else {
                        phi_1713_ = u32();
                        phi_1716_ = u32();
                        phi_1718_ = u32();
                    }
                    let _e1304 = phi_1713_;
                    let _e1306 = phi_1716_;
                    let _e1308 = phi_1718_;
                    continue;
                    continuing {
                        phi_1712_ = _e1304;
                        phi_1715_ = _e1306;
                        phi_1717_ = _e1308;
                        break if !(_e810);
                    }
                }
                let _e1311 = local;
                if _e1311 {
                    let _e1313 = local_1;
                    let _e1314 = (_e1313 & 2147483647u);
                    let _e1316 = (_e1314 >> bitcast<u32>(2i));
                    if (_e1316 >= _e118) {
                        phi_2847_ = SlimbvhTypeL(SlimbvhTypeK(vec4<f32>(0f, 0f, 0f, 0f), 0u), 0u, 0u);
                    } else {
                        let _e1322 = slimbvh_nodes.member[_e1316][select(_e699, 2u, (2u < _e699))];
                        let _e1331 = slimbvh_nodes.member[_e1316][select(_e700, 2u, (2u < _e700))];
                        let _e1340 = slimbvh_nodes.member[_e1316][select(_e701, 2u, (2u < _e701))];
                        let _e1348 = slimbvh_nodes.member[_e1316][0u][3u];
                        let _e1352 = slimbvh_nodes.member[_e1316][1u][3u];
                        let _e1356 = slimbvh_nodes.member[_e1316][2u][3u];
                        let _e1369 = (_e1356 >> bitcast<u32>(20u));
                        let _e1377 = (((_e1356 >> bitcast<u32>(7u)) & 8191u) | ((_e1352 >> bitcast<u32>(29u)) << bitcast<u32>(13u)));
                        let _e1380 = ((_e1356 >> bitcast<u32>(5u)) & 3u);
                        let _e1381 = (_e1314 & 3u);
                        let _e1387 = ((_e1369 >> bitcast<u32>((((3u * _e1381) & 31u) & 31u))) & 7u);
                        if (_e1387 == 7u) {
                            let _e1440 = ((_e1369 | (_e1369 << bitcast<u32>(10i))) & 4128831u);
                            phi_2799_ = (((_e1352 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e1440 | (_e1440 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e1381) & 31u) & 31u))) & 255u));
                        } else {
                            let _e1392 = ((_e1369 | (_e1369 << bitcast<u32>(10i))) & 4128831u);
                            let _e1396 = ((_e1392 | (_e1392 << bitcast<u32>(5i))) & 117901063u);
                            let _e1402 = (_e1396 - (7u * (((_e1396 + 16843009u) >> bitcast<u32>(3i)) & 16843009u)));
                            let _e1410 = ((_e1377 | (_e1377 << bitcast<u32>(8i))) & 16711935u);
                            phi_2799_ = ((2147483648u | (_e1387 << bitcast<u32>(28u))) | ((((_e1348 >> bitcast<u32>(5u)) | (((_e1352 >> bitcast<u32>(28u)) & 1u) << bitcast<u32>(27u))) + (((((((((_e1410 | (_e1410 << bitcast<u32>(4i))) & 252645135u) + (3u * (((_e1402 + 117901063u) >> bitcast<u32>(3i)) & 16843009u))) * (_e1380 + 1u)) + _e1402) + ((_e1402 >> bitcast<u32>(1i)) & 50529027u)) * 16843008u) >> bitcast<u32>((((8u * _e1381) & 31u) & 31u))) & 255u)) & 268435455u));
                        }
                        let _e1458 = phi_2799_;
                        switch bitcast<i32>(_e1380) {
                            case 0: {
                                phi_2804_ = 0u;
                                break;
                            }
                            case 1: {
                                phi_2804_ = 1u;
                                break;
                            }
                            default: {
                                phi_2804_ = 2u;
                                break;
                            }
                        }
                        let _e1461 = phi_2804_;
                        let _e1464 = (((8u * _e1381) & 31u) & 31u);
                        phi_2847_ = SlimbvhTypeL(SlimbvhTypeK(vec4<f32>((bitcast<f32>(_e1322.x) + (f32((((_e1322.y >> bitcast<u32>(_e1464)) & 255u) << bitcast<u32>(((_e1322.w & 31u) & 31u)))) * _e167)), (bitcast<f32>(_e1331.x) + (f32((((_e1331.y >> bitcast<u32>(_e1464)) & 255u) << bitcast<u32>(((_e1331.w & 31u) & 31u)))) * _e167)), (bitcast<f32>(_e1340.x) + (f32((((_e1340.y >> bitcast<u32>(_e1464)) & 255u) << bitcast<u32>(((_e1340.w & 31u) & 31u)))) * _e167)), 0f), _e1461), (_e1458 & 268435455u), ((_e1458 >> bitcast<u32>(28u)) & 7u));
                    }
                    let _e1503 = phi_2847_;
                    phi_2851_ = _e793;
                    phi_2854_ = SlimbvhTypeD(0u, _e1503.member_2);
                    loop {
                        let _e1507 = phi_2851_;
                        let _e1509 = phi_2854_;
                        local_4 = _e1507;
                        local_7 = _e1507;
                        if (_e1509.member < _e1509.member_1) {
                            phi_2855_ = SlimbvhTypeD((_e1509.member + 1u), _e1509.member_1);
                            phi_2877_ = SlimbvhTypeD(1u, _e1509.member);
                        } else {
                            phi_2855_ = _e1509;
                            phi_2877_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                        }
                        let _e1522 = phi_2855_;
                        let _e1524 = phi_2877_;
                        let _e1528 = (bitcast<i32>(_e1524.member) != 0i);
                        if _e1528 {
                            let _e1531 = (_e1503.member_2 / 2u);
                            let _e1533 = (_e1503.member_1 + (_e1531 + _e1524.member_1));
                            if (_e1533 < _e121) {
                                let _e1536 = slimbvh_triangles.member[_e1533];
                                phi_2905_ = _e1536;
                            } else {
                                phi_2905_ = 4294967295u;
                            }
                            let _e1538 = phi_2905_;
                            let _e1539 = (_e1524.member_1 - 1u);
                            let _e1542 = (_e1503.member_1 + (_e1539 >> bitcast<u32>(1i)));
                            if (_e1542 < _e121) {
                                let _e1545 = slimbvh_triangles.member[_e1542];
                                phi_2928_ = _e1545;
                            } else {
                                phi_2928_ = 0u;
                            }
                            let _e1547 = phi_2928_;
                            if (_e1524.member_1 == 0u) {
                                phi_2937_ = 2080u;
                            } else {
                                phi_2937_ = (_e1547 >> bitcast<u32>(((16u * (_e1539 & 1u)) & 31u)));
                            }
                            let _e1555 = phi_2937_;
                            let _e1557 = (_e1503.member_1 + (_e1531 + _e1503.member_2));
                            switch bitcast<i32>(_e1503.member.member_1) {
                                case 0: {
                                    phi_2947_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2947_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2947_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2947_ = u32();
                                    break;
                                }
                            }
                            let _e1561 = phi_2947_;
                            let _e1564 = (_e1557 + ((_e1555 & 31u) * _e1561));
                            let _e1569 = (_e1557 + (((_e1555 >> bitcast<u32>(5u)) & 31u) * _e1561));
                            let _e1574 = (_e1557 + (((_e1555 >> bitcast<u32>(10u)) & 31u) * _e1561));
                            switch bitcast<i32>(_e1503.member.member_1) {
                                case 0: {
                                    if (_e1564 < _e121) {
                                        let _e1851 = slimbvh_triangles.member[_e1564];
                                        phi_2989_ = _e1851;
                                    } else {
                                        phi_2989_ = 0u;
                                    }
                                    let _e1853 = phi_2989_;
                                    let _e1856 = ((10u * _e227) & 31u);
                                    let _e1867 = ((10u * _e231) & 31u);
                                    let _e1878 = ((10u * _e223) & 31u);
                                    if (_e1569 < _e121) {
                                        let _e1890 = slimbvh_triangles.member[_e1569];
                                        phi_3035_ = _e1890;
                                    } else {
                                        phi_3035_ = 0u;
                                    }
                                    let _e1892 = phi_3035_;
                                    if (_e1574 < _e121) {
                                        let _e1920 = slimbvh_triangles.member[_e1574];
                                        phi_3081_ = _e1920;
                                    } else {
                                        phi_3081_ = 0u;
                                    }
                                    let _e1922 = phi_3081_;
                                    phi_3548_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1503.member.member.x + ((bitcast<f32>((1258291200u | ((_e1853 >> bitcast<u32>(_e1856)) & 1023u))) - 8388608f) * _e167)), (_e1503.member.member.y + ((bitcast<f32>((1258291200u | ((_e1853 >> bitcast<u32>(_e1867)) & 1023u))) - 8388608f) * _e167)), (_e1503.member.member.z + ((bitcast<f32>((1258291200u | ((_e1853 >> bitcast<u32>(_e1878)) & 1023u))) - 8388608f) * _e167))), array<f32, 3>((_e1503.member.member.x + ((bitcast<f32>((1258291200u | ((_e1892 >> bitcast<u32>(_e1856)) & 1023u))) - 8388608f) * _e167)), (_e1503.member.member.y + ((bitcast<f32>((1258291200u | ((_e1892 >> bitcast<u32>(_e1867)) & 1023u))) - 8388608f) * _e167)), (_e1503.member.member.z + ((bitcast<f32>((1258291200u | ((_e1892 >> bitcast<u32>(_e1878)) & 1023u))) - 8388608f) * _e167))), array<f32, 3>((_e1503.member.member.x + ((bitcast<f32>((1258291200u | ((_e1922 >> bitcast<u32>(_e1856)) & 1023u))) - 8388608f) * _e167)), (_e1503.member.member.y + ((bitcast<f32>((1258291200u | ((_e1922 >> bitcast<u32>(_e1867)) & 1023u))) - 8388608f) * _e167)), (_e1503.member.member.z + ((bitcast<f32>((1258291200u | ((_e1922 >> bitcast<u32>(_e1878)) & 1023u))) - 8388608f) * _e167))));
                                    break;
                                }
                                case 1: {
                                    if (_e1564 < _e121) {
                                        let _e1664 = slimbvh_triangles.member[_e1564];
                                        phi_3128_ = _e1664;
                                    } else {
                                        phi_3128_ = 0u;
                                    }
                                    let _e1666 = phi_3128_;
                                    let _e1667 = (_e1564 + 1u);
                                    if (_e1667 < _e121) {
                                        let _e1670 = slimbvh_triangles.member[_e1667];
                                        phi_3141_ = _e1670;
                                    } else {
                                        phi_3141_ = 0u;
                                    }
                                    let _e1672 = phi_3141_;
                                    let _e1674 = (_e227 == 1u);
                                    if _e1674 {
                                        phi_3151_ = ((_e1666 >> bitcast<u32>(21i)) | (_e1672 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3151_ = (_e1672 >> bitcast<u32>(10i));
                                    }
                                    let _e1683 = phi_3151_;
                                    let _e1692 = (_e231 == 1u);
                                    if _e1692 {
                                        phi_3172_ = ((_e1666 >> bitcast<u32>(21i)) | (_e1672 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3172_ = (_e1672 >> bitcast<u32>(10i));
                                    }
                                    let _e1701 = phi_3172_;
                                    let _e1710 = (_e223 == 1u);
                                    if _e1710 {
                                        phi_3193_ = ((_e1666 >> bitcast<u32>(21i)) | (_e1672 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3193_ = (_e1672 >> bitcast<u32>(10i));
                                    }
                                    let _e1719 = phi_3193_;
                                    if (_e1569 < _e121) {
                                        let _e1730 = slimbvh_triangles.member[_e1569];
                                        phi_3220_ = _e1730;
                                    } else {
                                        phi_3220_ = 0u;
                                    }
                                    let _e1732 = phi_3220_;
                                    let _e1733 = (_e1569 + 1u);
                                    if (_e1733 < _e121) {
                                        let _e1736 = slimbvh_triangles.member[_e1733];
                                        phi_3233_ = _e1736;
                                    } else {
                                        phi_3233_ = 0u;
                                    }
                                    let _e1738 = phi_3233_;
                                    if _e1674 {
                                        phi_3243_ = ((_e1732 >> bitcast<u32>(21i)) | (_e1738 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3243_ = (_e1738 >> bitcast<u32>(10i));
                                    }
                                    let _e1747 = phi_3243_;
                                    if _e1692 {
                                        phi_3264_ = ((_e1732 >> bitcast<u32>(21i)) | (_e1738 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3264_ = (_e1738 >> bitcast<u32>(10i));
                                    }
                                    let _e1763 = phi_3264_;
                                    if _e1710 {
                                        phi_3285_ = ((_e1732 >> bitcast<u32>(21i)) | (_e1738 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3285_ = (_e1738 >> bitcast<u32>(10i));
                                    }
                                    let _e1779 = phi_3285_;
                                    if (_e1574 < _e121) {
                                        let _e1790 = slimbvh_triangles.member[_e1574];
                                        phi_3312_ = _e1790;
                                    } else {
                                        phi_3312_ = 0u;
                                    }
                                    let _e1792 = phi_3312_;
                                    let _e1793 = (_e1574 + 1u);
                                    if (_e1793 < _e121) {
                                        let _e1796 = slimbvh_triangles.member[_e1793];
                                        phi_3325_ = _e1796;
                                    } else {
                                        phi_3325_ = 0u;
                                    }
                                    let _e1798 = phi_3325_;
                                    if _e1674 {
                                        phi_3335_ = ((_e1792 >> bitcast<u32>(21i)) | (_e1798 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3335_ = (_e1798 >> bitcast<u32>(10i));
                                    }
                                    let _e1807 = phi_3335_;
                                    if _e1692 {
                                        phi_3356_ = ((_e1792 >> bitcast<u32>(21i)) | (_e1798 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3356_ = (_e1798 >> bitcast<u32>(10i));
                                    }
                                    let _e1823 = phi_3356_;
                                    if _e1710 {
                                        phi_3377_ = ((_e1792 >> bitcast<u32>(21i)) | (_e1798 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3377_ = (_e1798 >> bitcast<u32>(10i));
                                    }
                                    let _e1839 = phi_3377_;
                                    phi_3548_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1503.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1683, _e1666, _e232) & 2097151u))) - 8388608f) * _e167)), (_e1503.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1701, _e1666, _e235) & 2097151u))) - 8388608f) * _e167)), (_e1503.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1719, _e1666, _e239) & 2097151u))) - 8388608f) * _e167))), array<f32, 3>((_e1503.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1747, _e1732, _e232) & 2097151u))) - 8388608f) * _e167)), (_e1503.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1763, _e1732, _e235) & 2097151u))) - 8388608f) * _e167)), (_e1503.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1779, _e1732, _e239) & 2097151u))) - 8388608f) * _e167))), array<f32, 3>((_e1503.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1807, _e1792, _e232) & 2097151u))) - 8388608f) * _e167)), (_e1503.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1823, _e1792, _e235) & 2097151u))) - 8388608f) * _e167)), (_e1503.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1839, _e1792, _e239) & 2097151u))) - 8388608f) * _e167))));
                                    break;
                                }
                                case 2: {
                                    let _e1577 = (_e1564 + _e227);
                                    if (_e1577 < _e121) {
                                        let _e1580 = slimbvh_triangles.member[_e1577];
                                        phi_3406_ = _e1580;
                                    } else {
                                        phi_3406_ = 0u;
                                    }
                                    let _e1582 = phi_3406_;
                                    let _e1583 = (_e1564 + _e231);
                                    if (_e1583 < _e121) {
                                        let _e1586 = slimbvh_triangles.member[_e1583];
                                        phi_3419_ = _e1586;
                                    } else {
                                        phi_3419_ = 0u;
                                    }
                                    let _e1588 = phi_3419_;
                                    let _e1589 = (_e1564 + _e223);
                                    if (_e1589 < _e121) {
                                        let _e1592 = slimbvh_triangles.member[_e1589];
                                        phi_3432_ = _e1592;
                                    } else {
                                        phi_3432_ = 0u;
                                    }
                                    let _e1594 = phi_3432_;
                                    let _e1605 = (_e1569 + _e227);
                                    if (_e1605 < _e121) {
                                        let _e1608 = slimbvh_triangles.member[_e1605];
                                        phi_3458_ = _e1608;
                                    } else {
                                        phi_3458_ = 0u;
                                    }
                                    let _e1610 = phi_3458_;
                                    let _e1611 = (_e1569 + _e231);
                                    if (_e1611 < _e121) {
                                        let _e1614 = slimbvh_triangles.member[_e1611];
                                        phi_3471_ = _e1614;
                                    } else {
                                        phi_3471_ = 0u;
                                    }
                                    let _e1616 = phi_3471_;
                                    let _e1617 = (_e1569 + _e223);
                                    if (_e1617 < _e121) {
                                        let _e1620 = slimbvh_triangles.member[_e1617];
                                        phi_3484_ = _e1620;
                                    } else {
                                        phi_3484_ = 0u;
                                    }
                                    let _e1622 = phi_3484_;
                                    let _e1633 = (_e1574 + _e227);
                                    if (_e1633 < _e121) {
                                        let _e1636 = slimbvh_triangles.member[_e1633];
                                        phi_3510_ = _e1636;
                                    } else {
                                        phi_3510_ = 0u;
                                    }
                                    let _e1638 = phi_3510_;
                                    let _e1639 = (_e1574 + _e231);
                                    if (_e1639 < _e121) {
                                        let _e1642 = slimbvh_triangles.member[_e1639];
                                        phi_3523_ = _e1642;
                                    } else {
                                        phi_3523_ = 0u;
                                    }
                                    let _e1644 = phi_3523_;
                                    let _e1645 = (_e1574 + _e223);
                                    if (_e1645 < _e121) {
                                        let _e1648 = slimbvh_triangles.member[_e1645];
                                        phi_3536_ = _e1648;
                                    } else {
                                        phi_3536_ = 0u;
                                    }
                                    let _e1650 = phi_3536_;
                                    phi_3548_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1582)) * _e167), (f32(bitcast<i32>(_e1588)) * _e167), (f32(bitcast<i32>(_e1594)) * _e167)), array<f32, 3>((f32(bitcast<i32>(_e1610)) * _e167), (f32(bitcast<i32>(_e1616)) * _e167), (f32(bitcast<i32>(_e1622)) * _e167)), array<f32, 3>((f32(bitcast<i32>(_e1638)) * _e167), (f32(bitcast<i32>(_e1644)) * _e167), (f32(bitcast<i32>(_e1650)) * _e167)));
                                    break;
                                }
                                default: {
                                    phi_3548_ = array<array<f32, 3>, 3>();
                                    break;
                                }
                            }
                            let _e1950 = phi_3548_;
                            let _e1967 = (_e1950[0][2] - _e615.member[2]);
                            let _e1970 = (((_e1950[0][0] - _e615.member[0]) * _e670) - (_e1967 * _e638));
                            let _e1973 = (((_e1950[0][1] - _e615.member[1]) * _e670) - (_e1967 * _e654));
                            let _e1976 = (_e1950[1][2] - _e615.member[2]);
                            let _e1979 = (((_e1950[1][0] - _e615.member[0]) * _e670) - (_e1976 * _e638));
                            let _e1982 = (((_e1950[1][1] - _e615.member[1]) * _e670) - (_e1976 * _e654));
                            let _e1985 = (_e1950[2][2] - _e615.member[2]);
                            let _e1988 = (((_e1950[2][0] - _e615.member[0]) * _e670) - (_e1985 * _e638));
                            let _e1991 = (((_e1950[2][1] - _e615.member[1]) * _e670) - (_e1985 * _e654));
                            let _e1992 = (_e1988 * _e1982);
                            let _e1993 = (_e1991 * _e1979);
                            let _e1994 = (_e1970 * _e1991);
                            let _e1995 = (_e1973 * _e1988);
                            let _e1996 = (_e1979 * _e1973);
                            let _e1997 = (_e1982 * _e1970);
                            let _e2002 = (((_e1992 >= _e1993) && (_e1994 >= _e1995)) && (_e1996 >= _e1997));
                            let _e2008 = (_e2002 || (((_e1992 <= _e1993) && (_e1994 <= _e1995)) && (_e1996 <= _e1997)));
                            if _e2008 {
                                let _e2010 = select(-1f, 1f, _e2002);
                                let _e2012 = ((_e1992 - _e1993) * _e2010);
                                let _e2014 = select(0f, _e2012, (_e2012 > 0f));
                                let _e2016 = ((_e1994 - _e1995) * _e2010);
                                let _e2018 = select(0f, _e2016, (_e2016 > 0f));
                                let _e2020 = ((_e1996 - _e1997) * _e2010);
                                let _e2022 = select(0f, _e2020, (_e2020 > 0f));
                                let _e2024 = ((_e2014 + _e2018) + _e2022);
                                let _e2039 = ((min(min(_e1950[0][0], _e1950[1][0]), _e1950[2][0]) - _e639) * _e642);
                                let _e2040 = ((max(max(_e1950[0][0], _e1950[1][0]), _e1950[2][0]) - _e640) * _e642);
                                let _e2041 = vec4<f32>(_e2039, f32(), _e2040, f32());
                                let _e2044 = ((min(min(_e1950[0][1], _e1950[1][1]), _e1950[2][1]) - _e655) * _e658);
                                let _e2045 = ((max(max(_e1950[0][1], _e1950[1][1]), _e1950[2][1]) - _e656) * _e658);
                                let _e2046 = vec4<f32>(_e2044, f32(), _e2045, f32());
                                let _e2049 = ((min(min(_e1950[0][2], _e1950[1][2]), _e1950[2][2]) - _e671) * _e674);
                                let _e2050 = ((max(max(_e1950[0][2], _e1950[1][2]), _e1950[2][2]) - _e672) * _e674);
                                let _e2051 = vec4<f32>(_e2049, f32(), _e2050, f32());
                                let _e2052 = vec4<f32>(_e2040, f32(), _e2039, f32());
                                let _e2054 = vec4<f32>(_e2045, f32(), _e2044, f32());
                                let _e2056 = vec4<f32>(_e2050, f32(), _e2049, f32());
                                let _e2065 = max(max(min(_e2041, _e2052).x, min(_e2046, _e2054).x), min(_e2051, _e2056).x);
                                let _e2070 = min(min(max(_e2041, _e2052).x, max(_e2046, _e2054).x), max(_e2051, _e2056).x);
                                let _e2075 = max(_e2065, _e682);
                                let _e2097 = (((((_e2008 && (_e2024 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1970, _e1979), _e1988) <= 0f) && (max(max(_e1970, _e1979), _e1988) >= 0f))) && ((min(min(_e1973, _e1982), _e1991) <= 0f) && (max(max(_e1973, _e1982), _e1991) >= 0f))) && (_e2075 <= (_e2070 + (max(max(_e2051, _e2056).x, -(min(_e2051, _e2056).x)) * 0.0000019073523f)))) && (_e2075 <= _e1507.member.member_1));
                                if _e2097 {
                                    let _e2102 = (_e1950[1][0] - _e1950[0][0]);
                                    let _e2103 = (_e1950[1][1] - _e1950[0][1]);
                                    let _e2104 = (_e1950[1][2] - _e1950[0][2]);
                                    let _e2105 = vec3<f32>(_e2102, _e2103, _e2104);
                                    let _e2106 = (_e1950[2][0] - _e1950[1][0]);
                                    let _e2107 = (_e1950[2][1] - _e1950[1][1]);
                                    let _e2108 = (_e1950[2][2] - _e1950[1][2]);
                                    let _e2109 = vec3<f32>(_e2106, _e2107, _e2108);
                                    let _e2110 = (_e1950[0][0] - _e1950[2][0]);
                                    let _e2111 = (_e1950[0][1] - _e1950[2][1]);
                                    let _e2112 = (_e1950[0][2] - _e1950[2][2]);
                                    let _e2113 = vec3<f32>(_e2110, _e2111, _e2112);
                                    let _e2124 = max(max(bitcast<f32>((bitcast<u32>(_e2102) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2103) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2104) & 2147483647u)));
                                    let _e2135 = max(max(bitcast<f32>((bitcast<u32>(_e2106) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2107) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2108) & 2147483647u)));
                                    let _e2148 = max(max(_e2124, _e2135), max(max(bitcast<f32>((bitcast<u32>(_e2110) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2111) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2112) & 2147483647u))));
                                    if (_e2124 == _e2148) {
                                        phi_3913_ = _e1982;
                                        phi_3914_ = _e1979;
                                        phi_3915_ = _e1973;
                                        phi_3916_ = _e1970;
                                        phi_3917_ = vec3<f32>(_e1950[0][0], _e1950[0][1], _e1950[0][2]);
                                        phi_3918_ = _e2113;
                                        phi_3919_ = _e2109;
                                        phi_3920_ = _e2105;
                                    } else {
                                        let _e2150 = (_e2135 == _e2148);
                                        let _e2155 = vec3(_e2150);
                                        phi_3913_ = select(_e1973, _e1991, _e2150);
                                        phi_3914_ = select(_e1970, _e1988, _e2150);
                                        phi_3915_ = select(_e1991, _e1982, _e2150);
                                        phi_3916_ = select(_e1988, _e1979, _e2150);
                                        phi_3917_ = select(vec3<f32>(_e1950[2][0], _e1950[2][1], _e1950[2][2]), vec3<f32>(_e1950[1][0], _e1950[1][1], _e1950[1][2]), _e2155);
                                        phi_3918_ = select(_e2109, _e2105, _e2155);
                                        phi_3919_ = select(_e2105, _e2113, _e2155);
                                        phi_3920_ = select(_e2113, _e2109, _e2155);
                                    }
                                    let _e2161 = phi_3913_;
                                    let _e2163 = phi_3914_;
                                    let _e2165 = phi_3915_;
                                    let _e2167 = phi_3916_;
                                    let _e2169 = phi_3917_;
                                    let _e2171 = phi_3918_;
                                    let _e2173 = phi_3919_;
                                    let _e2175 = phi_3920_;
                                    let _e2182 = ((_e2173.y * _e2171.z) - (_e2171.y * _e2173.z));
                                    let _e2187 = ((_e2173.z * _e2171.x) - (_e2171.z * _e2173.x));
                                    let _e2190 = ((_e2173.x * _e2171.y) - (_e2171.x * _e2173.y));
                                    let _e2193 = ((_e2014 >= _e2018) && (_e2014 >= _e2022));
                                    let _e2194 = (_e2018 >= _e2022);
                                    let _e2208 = (((_e2182 * (select(select(_e1950[2][0], _e1950[1][0], _e2194), _e1950[0][0], _e2193) - _e615.member[0])) + (_e2187 * (select(select(_e1950[2][1], _e1950[1][1], _e2194), _e1950[0][1], _e2193) - _e615.member[1]))) + (_e2190 * (select(select(_e1950[2][2], _e1950[1][2], _e2194), _e1950[0][2], _e2193) - _e615.member[2])));
                                    let _e2213 = (((_e2182 * _e638) + (_e2187 * _e654)) + (_e2190 * _e670));
                                    let _e2214 = (_e2163 - _e2167);
                                    let _e2215 = (_e2161 - _e2165);
                                    let _e2218 = ((_e2214 * _e2214) + (_e2215 * _e2215));
                                    let _e2225 = (-(((_e2167 * _e2214) + (_e2165 * _e2215))) / select(0.000000000000000000000000000000000000011754944f, _e2218, (_e2218 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e2227 = select(1f, _e2225, (_e2225 < 1f));
                                    let _e2229 = select(0f, _e2227, (_e2227 > 0f));
                                    let _e2238 = ((_e2169.x + (_e2175.x * _e2229)) - _e615.member[0]);
                                    let _e2241 = ((_e2169.y + (_e2175.y * _e2229)) - _e615.member[1]);
                                    let _e2244 = ((_e2169.z + (_e2175.z * _e2229)) - _e615.member[2]);
                                    let _e2309 = ((bitcast<f32>((bitcast<u32>(((((_e2182 * _e2238) + (_e2187 * _e2241)) + (_e2190 * _e2244)) - _e2208)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e2238) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2241) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2244) & 2147483647u))), _e2148)) * max(max(bitcast<f32>((bitcast<u32>(_e2182) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2187) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2190) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e2213) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e2173.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2173.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2173.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e2171.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2171.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2171.z) & 2147483647u)))))));
                                    let _e2310 = (_e2208 / _e2213);
                                    if (_e2097 && !(_e2309)) {
                                        let _e2313 = (_e2244 / _e670);
                                        let _e2321 = (((_e2182 * (_e2238 - (_e638 * _e2313))) + (_e2187 * (_e2241 - (_e654 * _e2313)))) / _e2213);
                                        phi_4099_ = select(select(_e2313, (_e2313 + _e2321), (bitcast<f32>((bitcast<u32>(_e2321) & 2147483647u)) <= _e2148)), _e2310, _e2309);
                                    } else {
                                        phi_4099_ = _e2310;
                                    }
                                    let _e2330 = phi_4099_;
                                    let _e2332 = select(_e2070, _e2330, (_e2330 < _e2070));
                                    let _e2334 = select(_e2065, _e2332, (_e2332 > _e2065));
                                    let _e2337 = select(_e2334, 0f, (bitcast<u32>(_e2334) == 2147483648u));
                                    let _e2338 = (1f / _e2024);
                                    phi_4125_ = SlimbvhTypeE(_e2337, (_e2018 * _e2338), (_e2022 * _e2338), ((_e2097 && (_e2337 >= _e682)) && (_e2337 <= _e1507.member.member_1)));
                                    phi_4126_ = SlimbvhTypeE();
                                } else {
                                    phi_4125_ = SlimbvhTypeE();
                                    phi_4126_ = SlimbvhTypeE(0f, 0f, 0f, _e2097);
                                }
                                let _e2347 = phi_4125_;
                                let _e2349 = phi_4126_;
                                phi_4129_ = _e2347;
                                phi_4130_ = _e2349;
                                phi_4131_ = select(true, false, _e2097);
                            } else {
                                phi_4129_ = SlimbvhTypeE();
                                phi_4130_ = SlimbvhTypeE(0f, 0f, 0f, _e2008);
                                phi_4131_ = true;
                            }
                            let _e2352 = phi_4129_;
                            let _e2354 = phi_4130_;
                            let _e2356 = phi_4131_;
                            if _e2356 {
                                phi_4135_ = _e2354;
                            } else {
                                phi_4135_ = _e2352;
                            }
                            let _e2358 = phi_4135_;
                            if _e2358.member_3 {
                                phi_4144_ = SlimbvhTypeF(_e2358.member, _e2358.member_1, _e2358.member_2, _e1538);
                            } else {
                                phi_4144_ = _e114;
                            }
                            let _e2365 = phi_4144_;
                            if (_e2365.member_3 != 4294967295u) {
                                if (_e1538 != 4294967295u) {
                                    if (_e2365.member < _e1507.member.member.member) {
                                        phi_4172_ = true;
                                    } else {
                                        if (_e2365.member == _e1507.member.member.member) {
                                            phi_4171_ = (_e2365.member_3 < _e1507.member.member.member_3);
                                        } else {
                                            phi_4171_ = false;
                                        }
                                        let _e2380 = phi_4171_;
                                        phi_4172_ = _e2380;
                                    }
                                    let _e2382 = phi_4172_;
                                    if _e2382 {
                                        phi_4179_ = SlimbvhTypeO(SlimbvhTypeH(_e2365, _e2365.member), _e1507.member_1);
                                    } else {
                                        phi_4179_ = _e1507;
                                    }
                                    let _e2388 = phi_4179_;
                                    if _e2388.member_1 {
                                        phi_4185_ = SlimbvhTypeO(SlimbvhTypeH(_e2388.member.member, bitcast<f32>(4286578687u)), _e2388.member_1);
                                    } else {
                                        phi_4185_ = _e2388;
                                    }
                                    let _e2397 = phi_4185_;
                                    phi_4186_ = _e2397;
                                } else {
                                    phi_4186_ = _e1507;
                                }
                                let _e2399 = phi_4186_;
                                phi_4187_ = _e2399;
                            } else {
                                phi_4187_ = _e1507;
                            }
                            let _e2401 = phi_4187_;
                            phi_2852_ = _e2401;
                        } else {
                            phi_2852_ = SlimbvhTypeO();
                        }
                        let _e2403 = phi_2852_;
                        continue;
                        continuing {
                            phi_2851_ = _e2403;
                            phi_2854_ = _e1522;
                            break if !(_e1528);
                        }
                    }
                    let _e2406 = local_2;
                    let _e2407 = (_e2406 - 1u);
                    let _e2412 = slimbvh_stacks[(((_e2407 % 32u) * 64u) + _e686)];
                    let _e2413 = (_e2412 & 511u);
                    let _e2415 = (_e2413 >> bitcast<u32>(3u));
                    let _e2418 = ((_e2415 == 0u) || (_e2407 == 4294967295u));
                    if _e2418 {
                    } else {
                        slimbvh_stacks[(((_e2407 % 32u) * 64u) + _e686)] = (((_e2412 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2415);
                    }
                    let _e2425 = local_3;
                    let _e2433 = (((_e2412 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2413 & 3u) & 3u));
                    let _e2435 = (_e2433 >> bitcast<u32>(2i));
                    if (_e2435 < _e118) {
                        let _e2440 = slimbvh_nodes.member[_e2435][1u][3u];
                        let _e2444 = slimbvh_nodes.member[_e2435][2u][3u];
                        let _e2449 = (_e2444 >> bitcast<u32>(20u));
                        let _e2450 = (_e2433 & 3u);
                        if (((_e2449 >> bitcast<u32>((((3u * _e2450) & 31u) & 31u))) & 7u) == 7u) {
                            let _e2462 = ((_e2449 | (_e2449 << bitcast<u32>(10i))) & 4128831u);
                            phi_4278_ = (((_e2440 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e2462 | (_e2462 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e2450) & 31u) & 31u))) & 255u));
                        } else {
                            phi_4278_ = (2147483648u | _e2433);
                        }
                        let _e2480 = phi_4278_;
                        phi_4279_ = _e2480;
                    } else {
                        phi_4279_ = 4294967295u;
                    }
                    let _e2482 = phi_4279_;
                    let _e2484 = local_4;
                    let _e2782 = local_7;
                    phi_4288_ = _e2782;
                    phi_4289_ = select(select(_e2425, _e2407, _e2418), 4294967295u, (_e682 > _e2484.member.member_1));
                    phi_4290_ = _e2482;
                } else {
                    phi_4288_ = _e793;
                    let _e2785 = local_8;
                    phi_4289_ = _e2785;
                    let _e2788 = local_9;
                    phi_4290_ = _e2788;
                }
                let _e2490 = phi_4288_;
                let _e2492 = phi_4289_;
                let _e2494 = phi_4290_;
                phi_1697_ = _e2490;
                phi_1700_ = _e2492;
                phi_1702_ = _e2494;
                let _e2794 = local_10;
                phi_1704_ = _e2794;
            } else {
                phi_1697_ = SlimbvhTypeO();
                phi_1700_ = u32();
                phi_1702_ = u32();
                phi_1704_ = u32();
            }
            let _e2496 = phi_1697_;
            let _e2498 = phi_1700_;
            let _e2500 = phi_1702_;
            let _e2502 = phi_1704_;
            continue;
            continuing {
                phi_1696_ = _e2496;
                phi_1699_ = _e2498;
                phi_1701_ = _e2500;
                phi_1703_ = _e2502;
                break if !(_e800);
            }
        }
        let _e2505 = local_5;
        let _e2506 = (_e2505 == 4294967295u);
        let _e2508 = local_6;
        if (_e2508.member.member.member_3 != 4294967295u) {
            let _e2514 = -((_e185 + _e615.member_4));
            let _e2515 = bitcast<u32>(_e2508.member.member.member);
            let _e2519 = (bitcast<i32>((_e2515 >> bitcast<u32>(23i))) & 255i);
            let _e2520 = (_e2519 + _e2514);
            if (_e2519 == 255i) {
                phi_4348_ = _e2508.member.member.member;
            } else {
                if (_e2519 > 0i) {
                    if (_e2520 > 0i) {
                        let _e2524 = (_e2520 < 255i);
                        if _e2524 {
                            phi_4327_ = bitcast<f32>((_e2515 + bitcast<u32>((_e2514 << bitcast<u32>(23i)))));
                        } else {
                            phi_4327_ = f32();
                        }
                        let _e2531 = phi_4327_;
                        phi_4329_ = _e2531;
                        phi_4330_ = select(true, false, _e2524);
                    } else {
                        phi_4329_ = f32();
                        phi_4330_ = true;
                    }
                    let _e2534 = phi_4329_;
                    let _e2536 = phi_4330_;
                    phi_4331_ = _e2534;
                    phi_4332_ = _e2536;
                } else {
                    phi_4331_ = f32();
                    phi_4332_ = true;
                }
                let _e2538 = phi_4331_;
                let _e2540 = phi_4332_;
                if _e2540 {
                    let _e2541 = (_e2515 & 2147483648u);
                    let _e2548 = ((_e2515 & 8388607u) | (select(0u, 1u, ((_e2515 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e2552 = (_e2548 == 0u);
                    if _e2552 {
                        phi_5030_ = bitcast<f32>(_e2541);
                    } else {
                        let _e2557 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2548)), 32u, _e2552) - 8u);
                        let _e2560 = (_e2548 << bitcast<u32>((_e2557 & 31u)));
                        let _e2562 = ((_e2520 + select(0i, 1i, (_e2519 == 0i))) - bitcast<i32>(_e2557));
                        if (_e2562 >= 255i) {
                            phi_5020_ = bitcast<f32>((_e2541 | 2139095040u));
                            phi_5021_ = f32();
                            phi_5022_ = true;
                        } else {
                            let _e2564 = (_e2562 > 0i);
                            if _e2564 {
                                phi_5014_ = bitcast<f32>(((_e2541 | (bitcast<u32>(_e2562) << bitcast<u32>(23i))) | (_e2560 & 8388607u)));
                                phi_5015_ = f32();
                            } else {
                                if (_e2562 < -24i) {
                                    phi_4980_ = 26u;
                                } else {
                                    phi_4980_ = bitcast<u32>((1i - _e2562));
                                }
                                let _e2569 = phi_4980_;
                                let _e2570 = (_e2569 & 31u);
                                let _e2572 = (_e2560 >> bitcast<u32>(_e2570));
                                let _e2576 = (_e2560 & ((1u << bitcast<u32>(_e2570)) - 1u));
                                let _e2580 = (1u << bitcast<u32>(((_e2569 - 1u) & 31u)));
                                if (_e2576 > _e2580) {
                                    phi_5001_ = true;
                                } else {
                                    if (_e2576 == _e2580) {
                                        phi_4998_ = ((_e2572 & 1u) == 1u);
                                    } else {
                                        phi_4998_ = false;
                                    }
                                    let _e2586 = phi_4998_;
                                    phi_5001_ = _e2586;
                                }
                                let _e2588 = phi_5001_;
                                phi_5014_ = f32();
                                phi_5015_ = bitcast<f32>((_e2541 | (_e2572 + select(0u, 1u, _e2588))));
                            }
                            let _e2601 = phi_5014_;
                            let _e2603 = phi_5015_;
                            phi_5020_ = _e2601;
                            phi_5021_ = _e2603;
                            phi_5022_ = _e2564;
                        }
                        let _e2607 = phi_5020_;
                        let _e2609 = phi_5021_;
                        let _e2611 = phi_5022_;
                        phi_5030_ = select(_e2609, _e2607, _e2611);
                    }
                    let _e2615 = phi_5030_;
                    phi_4347_ = _e2615;
                } else {
                    phi_4347_ = _e2538;
                }
                let _e2617 = phi_4347_;
                phi_4348_ = _e2617;
            }
            let _e2619 = phi_4348_;
            let _e2620 = bitcast<u32>(_e2619);
            if ((_e2620 & 2147483647u) >= 2139095040u) {
                phi_4360_ = bitcast<f32>(((_e2620 & 2147483648u) | 2139095039u));
            } else {
                phi_4360_ = _e2619;
            }
            let _e2627 = phi_4360_;
            phi_4365_ = SlimbvhTypeF(_e2627, _e2508.member.member.member_1, _e2508.member.member.member_2, _e2508.member.member.member_3);
        } else {
            phi_4365_ = _e114;
        }
        let _e2632 = phi_4365_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2632.member), bitcast<u32>(_e2632.member_1), bitcast<u32>(_e2632.member_2), _e2632.member_3);
        phi_4378_ = _e2506;
        phi_4379_ = _e2506;
        phi_4380_ = select(true, false, _e2506);
    } else {
        phi_4378_ = bool();
        phi_4379_ = false;
        phi_4380_ = true;
    }
    let _e2643 = phi_4378_;
    let _e2645 = phi_4379_;
    let _e2647 = phi_4380_;
    if _e2647 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e2643, _e2645, _e2647)));
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
