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
                            let _e1532 = (_e1503.member_1 + (_e1503.member_2 / 2u));
                            let _e1533 = (_e1532 + _e1524.member_1);
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
                            let _e1556 = (_e1532 + _e1503.member_2);
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
                            let _e1560 = phi_2947_;
                            let _e1563 = (_e1556 + ((_e1555 & 31u) * _e1560));
                            let _e1568 = (_e1556 + (((_e1555 >> bitcast<u32>(5u)) & 31u) * _e1560));
                            let _e1573 = (_e1556 + (((_e1555 >> bitcast<u32>(10u)) & 31u) * _e1560));
                            switch bitcast<i32>(_e1503.member.member_1) {
                                case 0: {
                                    if (_e1563 < _e121) {
                                        let _e1850 = slimbvh_triangles.member[_e1563];
                                        phi_2989_ = _e1850;
                                    } else {
                                        phi_2989_ = 0u;
                                    }
                                    let _e1852 = phi_2989_;
                                    let _e1855 = ((10u * _e227) & 31u);
                                    let _e1866 = ((10u * _e231) & 31u);
                                    let _e1877 = ((10u * _e223) & 31u);
                                    if (_e1568 < _e121) {
                                        let _e1889 = slimbvh_triangles.member[_e1568];
                                        phi_3035_ = _e1889;
                                    } else {
                                        phi_3035_ = 0u;
                                    }
                                    let _e1891 = phi_3035_;
                                    if (_e1573 < _e121) {
                                        let _e1919 = slimbvh_triangles.member[_e1573];
                                        phi_3081_ = _e1919;
                                    } else {
                                        phi_3081_ = 0u;
                                    }
                                    let _e1921 = phi_3081_;
                                    phi_3548_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1503.member.member.x + ((bitcast<f32>((1258291200u | ((_e1852 >> bitcast<u32>(_e1855)) & 1023u))) - 8388608f) * _e167)), (_e1503.member.member.y + ((bitcast<f32>((1258291200u | ((_e1852 >> bitcast<u32>(_e1866)) & 1023u))) - 8388608f) * _e167)), (_e1503.member.member.z + ((bitcast<f32>((1258291200u | ((_e1852 >> bitcast<u32>(_e1877)) & 1023u))) - 8388608f) * _e167))), array<f32, 3>((_e1503.member.member.x + ((bitcast<f32>((1258291200u | ((_e1891 >> bitcast<u32>(_e1855)) & 1023u))) - 8388608f) * _e167)), (_e1503.member.member.y + ((bitcast<f32>((1258291200u | ((_e1891 >> bitcast<u32>(_e1866)) & 1023u))) - 8388608f) * _e167)), (_e1503.member.member.z + ((bitcast<f32>((1258291200u | ((_e1891 >> bitcast<u32>(_e1877)) & 1023u))) - 8388608f) * _e167))), array<f32, 3>((_e1503.member.member.x + ((bitcast<f32>((1258291200u | ((_e1921 >> bitcast<u32>(_e1855)) & 1023u))) - 8388608f) * _e167)), (_e1503.member.member.y + ((bitcast<f32>((1258291200u | ((_e1921 >> bitcast<u32>(_e1866)) & 1023u))) - 8388608f) * _e167)), (_e1503.member.member.z + ((bitcast<f32>((1258291200u | ((_e1921 >> bitcast<u32>(_e1877)) & 1023u))) - 8388608f) * _e167))));
                                    break;
                                }
                                case 1: {
                                    if (_e1563 < _e121) {
                                        let _e1663 = slimbvh_triangles.member[_e1563];
                                        phi_3128_ = _e1663;
                                    } else {
                                        phi_3128_ = 0u;
                                    }
                                    let _e1665 = phi_3128_;
                                    let _e1666 = (_e1563 + 1u);
                                    if (_e1666 < _e121) {
                                        let _e1669 = slimbvh_triangles.member[_e1666];
                                        phi_3141_ = _e1669;
                                    } else {
                                        phi_3141_ = 0u;
                                    }
                                    let _e1671 = phi_3141_;
                                    let _e1673 = (_e227 == 1u);
                                    if _e1673 {
                                        phi_3151_ = ((_e1665 >> bitcast<u32>(21i)) | (_e1671 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3151_ = (_e1671 >> bitcast<u32>(10i));
                                    }
                                    let _e1682 = phi_3151_;
                                    let _e1691 = (_e231 == 1u);
                                    if _e1691 {
                                        phi_3172_ = ((_e1665 >> bitcast<u32>(21i)) | (_e1671 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3172_ = (_e1671 >> bitcast<u32>(10i));
                                    }
                                    let _e1700 = phi_3172_;
                                    let _e1709 = (_e223 == 1u);
                                    if _e1709 {
                                        phi_3193_ = ((_e1665 >> bitcast<u32>(21i)) | (_e1671 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3193_ = (_e1671 >> bitcast<u32>(10i));
                                    }
                                    let _e1718 = phi_3193_;
                                    if (_e1568 < _e121) {
                                        let _e1729 = slimbvh_triangles.member[_e1568];
                                        phi_3220_ = _e1729;
                                    } else {
                                        phi_3220_ = 0u;
                                    }
                                    let _e1731 = phi_3220_;
                                    let _e1732 = (_e1568 + 1u);
                                    if (_e1732 < _e121) {
                                        let _e1735 = slimbvh_triangles.member[_e1732];
                                        phi_3233_ = _e1735;
                                    } else {
                                        phi_3233_ = 0u;
                                    }
                                    let _e1737 = phi_3233_;
                                    if _e1673 {
                                        phi_3243_ = ((_e1731 >> bitcast<u32>(21i)) | (_e1737 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3243_ = (_e1737 >> bitcast<u32>(10i));
                                    }
                                    let _e1746 = phi_3243_;
                                    if _e1691 {
                                        phi_3264_ = ((_e1731 >> bitcast<u32>(21i)) | (_e1737 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3264_ = (_e1737 >> bitcast<u32>(10i));
                                    }
                                    let _e1762 = phi_3264_;
                                    if _e1709 {
                                        phi_3285_ = ((_e1731 >> bitcast<u32>(21i)) | (_e1737 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3285_ = (_e1737 >> bitcast<u32>(10i));
                                    }
                                    let _e1778 = phi_3285_;
                                    if (_e1573 < _e121) {
                                        let _e1789 = slimbvh_triangles.member[_e1573];
                                        phi_3312_ = _e1789;
                                    } else {
                                        phi_3312_ = 0u;
                                    }
                                    let _e1791 = phi_3312_;
                                    let _e1792 = (_e1573 + 1u);
                                    if (_e1792 < _e121) {
                                        let _e1795 = slimbvh_triangles.member[_e1792];
                                        phi_3325_ = _e1795;
                                    } else {
                                        phi_3325_ = 0u;
                                    }
                                    let _e1797 = phi_3325_;
                                    if _e1673 {
                                        phi_3335_ = ((_e1791 >> bitcast<u32>(21i)) | (_e1797 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3335_ = (_e1797 >> bitcast<u32>(10i));
                                    }
                                    let _e1806 = phi_3335_;
                                    if _e1691 {
                                        phi_3356_ = ((_e1791 >> bitcast<u32>(21i)) | (_e1797 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3356_ = (_e1797 >> bitcast<u32>(10i));
                                    }
                                    let _e1822 = phi_3356_;
                                    if _e1709 {
                                        phi_3377_ = ((_e1791 >> bitcast<u32>(21i)) | (_e1797 << bitcast<u32>(11i)));
                                    } else {
                                        phi_3377_ = (_e1797 >> bitcast<u32>(10i));
                                    }
                                    let _e1838 = phi_3377_;
                                    phi_3548_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1503.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1682, _e1665, _e232) & 2097151u))) - 8388608f) * _e167)), (_e1503.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1700, _e1665, _e235) & 2097151u))) - 8388608f) * _e167)), (_e1503.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1718, _e1665, _e239) & 2097151u))) - 8388608f) * _e167))), array<f32, 3>((_e1503.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1746, _e1731, _e232) & 2097151u))) - 8388608f) * _e167)), (_e1503.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1762, _e1731, _e235) & 2097151u))) - 8388608f) * _e167)), (_e1503.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1778, _e1731, _e239) & 2097151u))) - 8388608f) * _e167))), array<f32, 3>((_e1503.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1806, _e1791, _e232) & 2097151u))) - 8388608f) * _e167)), (_e1503.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1822, _e1791, _e235) & 2097151u))) - 8388608f) * _e167)), (_e1503.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1838, _e1791, _e239) & 2097151u))) - 8388608f) * _e167))));
                                    break;
                                }
                                case 2: {
                                    let _e1576 = (_e1563 + _e227);
                                    if (_e1576 < _e121) {
                                        let _e1579 = slimbvh_triangles.member[_e1576];
                                        phi_3406_ = _e1579;
                                    } else {
                                        phi_3406_ = 0u;
                                    }
                                    let _e1581 = phi_3406_;
                                    let _e1582 = (_e1563 + _e231);
                                    if (_e1582 < _e121) {
                                        let _e1585 = slimbvh_triangles.member[_e1582];
                                        phi_3419_ = _e1585;
                                    } else {
                                        phi_3419_ = 0u;
                                    }
                                    let _e1587 = phi_3419_;
                                    let _e1588 = (_e1563 + _e223);
                                    if (_e1588 < _e121) {
                                        let _e1591 = slimbvh_triangles.member[_e1588];
                                        phi_3432_ = _e1591;
                                    } else {
                                        phi_3432_ = 0u;
                                    }
                                    let _e1593 = phi_3432_;
                                    let _e1604 = (_e1568 + _e227);
                                    if (_e1604 < _e121) {
                                        let _e1607 = slimbvh_triangles.member[_e1604];
                                        phi_3458_ = _e1607;
                                    } else {
                                        phi_3458_ = 0u;
                                    }
                                    let _e1609 = phi_3458_;
                                    let _e1610 = (_e1568 + _e231);
                                    if (_e1610 < _e121) {
                                        let _e1613 = slimbvh_triangles.member[_e1610];
                                        phi_3471_ = _e1613;
                                    } else {
                                        phi_3471_ = 0u;
                                    }
                                    let _e1615 = phi_3471_;
                                    let _e1616 = (_e1568 + _e223);
                                    if (_e1616 < _e121) {
                                        let _e1619 = slimbvh_triangles.member[_e1616];
                                        phi_3484_ = _e1619;
                                    } else {
                                        phi_3484_ = 0u;
                                    }
                                    let _e1621 = phi_3484_;
                                    let _e1632 = (_e1573 + _e227);
                                    if (_e1632 < _e121) {
                                        let _e1635 = slimbvh_triangles.member[_e1632];
                                        phi_3510_ = _e1635;
                                    } else {
                                        phi_3510_ = 0u;
                                    }
                                    let _e1637 = phi_3510_;
                                    let _e1638 = (_e1573 + _e231);
                                    if (_e1638 < _e121) {
                                        let _e1641 = slimbvh_triangles.member[_e1638];
                                        phi_3523_ = _e1641;
                                    } else {
                                        phi_3523_ = 0u;
                                    }
                                    let _e1643 = phi_3523_;
                                    let _e1644 = (_e1573 + _e223);
                                    if (_e1644 < _e121) {
                                        let _e1647 = slimbvh_triangles.member[_e1644];
                                        phi_3536_ = _e1647;
                                    } else {
                                        phi_3536_ = 0u;
                                    }
                                    let _e1649 = phi_3536_;
                                    phi_3548_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1581)) * _e167), (f32(bitcast<i32>(_e1587)) * _e167), (f32(bitcast<i32>(_e1593)) * _e167)), array<f32, 3>((f32(bitcast<i32>(_e1609)) * _e167), (f32(bitcast<i32>(_e1615)) * _e167), (f32(bitcast<i32>(_e1621)) * _e167)), array<f32, 3>((f32(bitcast<i32>(_e1637)) * _e167), (f32(bitcast<i32>(_e1643)) * _e167), (f32(bitcast<i32>(_e1649)) * _e167)));
                                    break;
                                }
                                default: {
                                    phi_3548_ = array<array<f32, 3>, 3>();
                                    break;
                                }
                            }
                            let _e1949 = phi_3548_;
                            let _e1966 = (_e1949[0][2] - _e615.member[2]);
                            let _e1969 = (((_e1949[0][0] - _e615.member[0]) * _e670) - (_e1966 * _e638));
                            let _e1972 = (((_e1949[0][1] - _e615.member[1]) * _e670) - (_e1966 * _e654));
                            let _e1975 = (_e1949[1][2] - _e615.member[2]);
                            let _e1978 = (((_e1949[1][0] - _e615.member[0]) * _e670) - (_e1975 * _e638));
                            let _e1981 = (((_e1949[1][1] - _e615.member[1]) * _e670) - (_e1975 * _e654));
                            let _e1984 = (_e1949[2][2] - _e615.member[2]);
                            let _e1987 = (((_e1949[2][0] - _e615.member[0]) * _e670) - (_e1984 * _e638));
                            let _e1990 = (((_e1949[2][1] - _e615.member[1]) * _e670) - (_e1984 * _e654));
                            let _e1991 = (_e1987 * _e1981);
                            let _e1992 = (_e1990 * _e1978);
                            let _e1993 = (_e1969 * _e1990);
                            let _e1994 = (_e1972 * _e1987);
                            let _e1995 = (_e1978 * _e1972);
                            let _e1996 = (_e1981 * _e1969);
                            let _e2001 = (((_e1991 >= _e1992) && (_e1993 >= _e1994)) && (_e1995 >= _e1996));
                            let _e2007 = (_e2001 || (((_e1991 <= _e1992) && (_e1993 <= _e1994)) && (_e1995 <= _e1996)));
                            if _e2007 {
                                let _e2009 = select(-1f, 1f, _e2001);
                                let _e2011 = ((_e1991 - _e1992) * _e2009);
                                let _e2013 = select(0f, _e2011, (_e2011 > 0f));
                                let _e2015 = ((_e1993 - _e1994) * _e2009);
                                let _e2017 = select(0f, _e2015, (_e2015 > 0f));
                                let _e2019 = ((_e1995 - _e1996) * _e2009);
                                let _e2021 = select(0f, _e2019, (_e2019 > 0f));
                                let _e2023 = ((_e2013 + _e2017) + _e2021);
                                let _e2038 = ((min(min(_e1949[0][0], _e1949[1][0]), _e1949[2][0]) - _e639) * _e642);
                                let _e2039 = ((max(max(_e1949[0][0], _e1949[1][0]), _e1949[2][0]) - _e640) * _e642);
                                let _e2040 = vec4<f32>(_e2038, f32(), _e2039, f32());
                                let _e2043 = ((min(min(_e1949[0][1], _e1949[1][1]), _e1949[2][1]) - _e655) * _e658);
                                let _e2044 = ((max(max(_e1949[0][1], _e1949[1][1]), _e1949[2][1]) - _e656) * _e658);
                                let _e2045 = vec4<f32>(_e2043, f32(), _e2044, f32());
                                let _e2048 = ((min(min(_e1949[0][2], _e1949[1][2]), _e1949[2][2]) - _e671) * _e674);
                                let _e2049 = ((max(max(_e1949[0][2], _e1949[1][2]), _e1949[2][2]) - _e672) * _e674);
                                let _e2050 = vec4<f32>(_e2048, f32(), _e2049, f32());
                                let _e2051 = vec4<f32>(_e2039, f32(), _e2038, f32());
                                let _e2053 = vec4<f32>(_e2044, f32(), _e2043, f32());
                                let _e2055 = vec4<f32>(_e2049, f32(), _e2048, f32());
                                let _e2064 = max(max(min(_e2040, _e2051).x, min(_e2045, _e2053).x), min(_e2050, _e2055).x);
                                let _e2069 = min(min(max(_e2040, _e2051).x, max(_e2045, _e2053).x), max(_e2050, _e2055).x);
                                let _e2074 = max(_e2064, _e682);
                                let _e2096 = (((((_e2007 && (_e2023 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1969, _e1978), _e1987) <= 0f) && (max(max(_e1969, _e1978), _e1987) >= 0f))) && ((min(min(_e1972, _e1981), _e1990) <= 0f) && (max(max(_e1972, _e1981), _e1990) >= 0f))) && (_e2074 <= (_e2069 + (max(max(_e2050, _e2055).x, -(min(_e2050, _e2055).x)) * 0.0000019073523f)))) && (_e2074 <= _e1507.member.member_1));
                                if _e2096 {
                                    let _e2101 = (_e1949[1][0] - _e1949[0][0]);
                                    let _e2102 = (_e1949[1][1] - _e1949[0][1]);
                                    let _e2103 = (_e1949[1][2] - _e1949[0][2]);
                                    let _e2104 = vec3<f32>(_e2101, _e2102, _e2103);
                                    let _e2105 = (_e1949[2][0] - _e1949[1][0]);
                                    let _e2106 = (_e1949[2][1] - _e1949[1][1]);
                                    let _e2107 = (_e1949[2][2] - _e1949[1][2]);
                                    let _e2108 = vec3<f32>(_e2105, _e2106, _e2107);
                                    let _e2109 = (_e1949[0][0] - _e1949[2][0]);
                                    let _e2110 = (_e1949[0][1] - _e1949[2][1]);
                                    let _e2111 = (_e1949[0][2] - _e1949[2][2]);
                                    let _e2112 = vec3<f32>(_e2109, _e2110, _e2111);
                                    let _e2123 = max(max(bitcast<f32>((bitcast<u32>(_e2101) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2102) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2103) & 2147483647u)));
                                    let _e2134 = max(max(bitcast<f32>((bitcast<u32>(_e2105) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2106) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2107) & 2147483647u)));
                                    let _e2147 = max(max(_e2123, _e2134), max(max(bitcast<f32>((bitcast<u32>(_e2109) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2110) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2111) & 2147483647u))));
                                    if (_e2123 == _e2147) {
                                        phi_3913_ = _e1981;
                                        phi_3914_ = _e1978;
                                        phi_3915_ = _e1972;
                                        phi_3916_ = _e1969;
                                        phi_3917_ = vec3<f32>(_e1949[0][0], _e1949[0][1], _e1949[0][2]);
                                        phi_3918_ = _e2112;
                                        phi_3919_ = _e2108;
                                        phi_3920_ = _e2104;
                                    } else {
                                        let _e2149 = (_e2134 == _e2147);
                                        let _e2154 = vec3(_e2149);
                                        phi_3913_ = select(_e1972, _e1990, _e2149);
                                        phi_3914_ = select(_e1969, _e1987, _e2149);
                                        phi_3915_ = select(_e1990, _e1981, _e2149);
                                        phi_3916_ = select(_e1987, _e1978, _e2149);
                                        phi_3917_ = select(vec3<f32>(_e1949[2][0], _e1949[2][1], _e1949[2][2]), vec3<f32>(_e1949[1][0], _e1949[1][1], _e1949[1][2]), _e2154);
                                        phi_3918_ = select(_e2108, _e2104, _e2154);
                                        phi_3919_ = select(_e2104, _e2112, _e2154);
                                        phi_3920_ = select(_e2112, _e2108, _e2154);
                                    }
                                    let _e2160 = phi_3913_;
                                    let _e2162 = phi_3914_;
                                    let _e2164 = phi_3915_;
                                    let _e2166 = phi_3916_;
                                    let _e2168 = phi_3917_;
                                    let _e2170 = phi_3918_;
                                    let _e2172 = phi_3919_;
                                    let _e2174 = phi_3920_;
                                    let _e2181 = ((_e2172.y * _e2170.z) - (_e2170.y * _e2172.z));
                                    let _e2186 = ((_e2172.z * _e2170.x) - (_e2170.z * _e2172.x));
                                    let _e2189 = ((_e2172.x * _e2170.y) - (_e2170.x * _e2172.y));
                                    let _e2192 = ((_e2013 >= _e2017) && (_e2013 >= _e2021));
                                    let _e2193 = (_e2017 >= _e2021);
                                    let _e2207 = (((_e2181 * (select(select(_e1949[2][0], _e1949[1][0], _e2193), _e1949[0][0], _e2192) - _e615.member[0])) + (_e2186 * (select(select(_e1949[2][1], _e1949[1][1], _e2193), _e1949[0][1], _e2192) - _e615.member[1]))) + (_e2189 * (select(select(_e1949[2][2], _e1949[1][2], _e2193), _e1949[0][2], _e2192) - _e615.member[2])));
                                    let _e2212 = (((_e2181 * _e638) + (_e2186 * _e654)) + (_e2189 * _e670));
                                    let _e2213 = (_e2162 - _e2166);
                                    let _e2214 = (_e2160 - _e2164);
                                    let _e2217 = ((_e2213 * _e2213) + (_e2214 * _e2214));
                                    let _e2224 = (-(((_e2166 * _e2213) + (_e2164 * _e2214))) / select(0.000000000000000000000000000000000000011754944f, _e2217, (_e2217 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e2226 = select(1f, _e2224, (_e2224 < 1f));
                                    let _e2228 = select(0f, _e2226, (_e2226 > 0f));
                                    let _e2237 = ((_e2168.x + (_e2174.x * _e2228)) - _e615.member[0]);
                                    let _e2240 = ((_e2168.y + (_e2174.y * _e2228)) - _e615.member[1]);
                                    let _e2243 = ((_e2168.z + (_e2174.z * _e2228)) - _e615.member[2]);
                                    let _e2308 = ((bitcast<f32>((bitcast<u32>(((((_e2181 * _e2237) + (_e2186 * _e2240)) + (_e2189 * _e2243)) - _e2207)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e2237) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2240) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2243) & 2147483647u))), _e2147)) * max(max(bitcast<f32>((bitcast<u32>(_e2181) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2186) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2189) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e2212) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e2172.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2172.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2172.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e2170.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2170.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2170.z) & 2147483647u)))))));
                                    let _e2309 = (_e2207 / _e2212);
                                    if (_e2096 && !(_e2308)) {
                                        let _e2312 = (_e2243 / _e670);
                                        let _e2320 = (((_e2181 * (_e2237 - (_e638 * _e2312))) + (_e2186 * (_e2240 - (_e654 * _e2312)))) / _e2212);
                                        phi_4099_ = select(select(_e2312, (_e2312 + _e2320), (bitcast<f32>((bitcast<u32>(_e2320) & 2147483647u)) <= _e2147)), _e2309, _e2308);
                                    } else {
                                        phi_4099_ = _e2309;
                                    }
                                    let _e2329 = phi_4099_;
                                    let _e2331 = select(_e2069, _e2329, (_e2329 < _e2069));
                                    let _e2333 = select(_e2064, _e2331, (_e2331 > _e2064));
                                    let _e2336 = select(_e2333, 0f, (bitcast<u32>(_e2333) == 2147483648u));
                                    let _e2337 = (1f / _e2023);
                                    phi_4125_ = SlimbvhTypeE(_e2336, (_e2017 * _e2337), (_e2021 * _e2337), ((_e2096 && (_e2336 >= _e682)) && (_e2336 <= _e1507.member.member_1)));
                                    phi_4126_ = SlimbvhTypeE();
                                } else {
                                    phi_4125_ = SlimbvhTypeE();
                                    phi_4126_ = SlimbvhTypeE(0f, 0f, 0f, _e2096);
                                }
                                let _e2346 = phi_4125_;
                                let _e2348 = phi_4126_;
                                phi_4129_ = _e2346;
                                phi_4130_ = _e2348;
                                phi_4131_ = select(true, false, _e2096);
                            } else {
                                phi_4129_ = SlimbvhTypeE();
                                phi_4130_ = SlimbvhTypeE(0f, 0f, 0f, _e2007);
                                phi_4131_ = true;
                            }
                            let _e2351 = phi_4129_;
                            let _e2353 = phi_4130_;
                            let _e2355 = phi_4131_;
                            if _e2355 {
                                phi_4135_ = _e2353;
                            } else {
                                phi_4135_ = _e2351;
                            }
                            let _e2357 = phi_4135_;
                            if _e2357.member_3 {
                                phi_4144_ = SlimbvhTypeF(_e2357.member, _e2357.member_1, _e2357.member_2, _e1538);
                            } else {
                                phi_4144_ = _e114;
                            }
                            let _e2364 = phi_4144_;
                            if (_e2364.member_3 != 4294967295u) {
                                if (_e1538 != 4294967295u) {
                                    if (_e2364.member < _e1507.member.member.member) {
                                        phi_4172_ = true;
                                    } else {
                                        if (_e2364.member == _e1507.member.member.member) {
                                            phi_4171_ = (_e2364.member_3 < _e1507.member.member.member_3);
                                        } else {
                                            phi_4171_ = false;
                                        }
                                        let _e2379 = phi_4171_;
                                        phi_4172_ = _e2379;
                                    }
                                    let _e2381 = phi_4172_;
                                    if _e2381 {
                                        phi_4179_ = SlimbvhTypeO(SlimbvhTypeH(_e2364, _e2364.member), _e1507.member_1);
                                    } else {
                                        phi_4179_ = _e1507;
                                    }
                                    let _e2387 = phi_4179_;
                                    if _e2387.member_1 {
                                        phi_4185_ = SlimbvhTypeO(SlimbvhTypeH(_e2387.member.member, bitcast<f32>(4286578687u)), _e2387.member_1);
                                    } else {
                                        phi_4185_ = _e2387;
                                    }
                                    let _e2396 = phi_4185_;
                                    phi_4186_ = _e2396;
                                } else {
                                    phi_4186_ = _e1507;
                                }
                                let _e2398 = phi_4186_;
                                phi_4187_ = _e2398;
                            } else {
                                phi_4187_ = _e1507;
                            }
                            let _e2400 = phi_4187_;
                            phi_2852_ = _e2400;
                        } else {
                            phi_2852_ = SlimbvhTypeO();
                        }
                        let _e2402 = phi_2852_;
                        continue;
                        continuing {
                            phi_2851_ = _e2402;
                            phi_2854_ = _e1522;
                            break if !(_e1528);
                        }
                    }
                    let _e2405 = local_2;
                    let _e2406 = (_e2405 - 1u);
                    let _e2411 = slimbvh_stacks[(((_e2406 % 32u) * 64u) + _e686)];
                    let _e2412 = (_e2411 & 511u);
                    let _e2414 = (_e2412 >> bitcast<u32>(3u));
                    let _e2417 = ((_e2414 == 0u) || (_e2406 == 4294967295u));
                    if _e2417 {
                    } else {
                        slimbvh_stacks[(((_e2406 % 32u) * 64u) + _e686)] = (((_e2411 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2414);
                    }
                    let _e2424 = local_3;
                    let _e2432 = (((_e2411 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2412 & 3u) & 3u));
                    let _e2434 = (_e2432 >> bitcast<u32>(2i));
                    if (_e2434 < _e118) {
                        let _e2439 = slimbvh_nodes.member[_e2434][1u][3u];
                        let _e2443 = slimbvh_nodes.member[_e2434][2u][3u];
                        let _e2448 = (_e2443 >> bitcast<u32>(20u));
                        let _e2449 = (_e2432 & 3u);
                        if (((_e2448 >> bitcast<u32>((((3u * _e2449) & 31u) & 31u))) & 7u) == 7u) {
                            let _e2461 = ((_e2448 | (_e2448 << bitcast<u32>(10i))) & 4128831u);
                            phi_4278_ = (((_e2439 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e2461 | (_e2461 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e2449) & 31u) & 31u))) & 255u));
                        } else {
                            phi_4278_ = (2147483648u | _e2432);
                        }
                        let _e2479 = phi_4278_;
                        phi_4279_ = _e2479;
                    } else {
                        phi_4279_ = 4294967295u;
                    }
                    let _e2481 = phi_4279_;
                    let _e2483 = local_4;
                    let _e2781 = local_7;
                    phi_4288_ = _e2781;
                    phi_4289_ = select(select(_e2424, _e2406, _e2417), 4294967295u, (_e682 > _e2483.member.member_1));
                    phi_4290_ = _e2481;
                } else {
                    phi_4288_ = _e793;
                    let _e2784 = local_8;
                    phi_4289_ = _e2784;
                    let _e2787 = local_9;
                    phi_4290_ = _e2787;
                }
                let _e2489 = phi_4288_;
                let _e2491 = phi_4289_;
                let _e2493 = phi_4290_;
                phi_1697_ = _e2489;
                phi_1700_ = _e2491;
                phi_1702_ = _e2493;
                let _e2793 = local_10;
                phi_1704_ = _e2793;
            } else {
                phi_1697_ = SlimbvhTypeO();
                phi_1700_ = u32();
                phi_1702_ = u32();
                phi_1704_ = u32();
            }
            let _e2495 = phi_1697_;
            let _e2497 = phi_1700_;
            let _e2499 = phi_1702_;
            let _e2501 = phi_1704_;
            continue;
            continuing {
                phi_1696_ = _e2495;
                phi_1699_ = _e2497;
                phi_1701_ = _e2499;
                phi_1703_ = _e2501;
                break if !(_e800);
            }
        }
        let _e2504 = local_5;
        let _e2505 = (_e2504 == 4294967295u);
        let _e2507 = local_6;
        if (_e2507.member.member.member_3 != 4294967295u) {
            let _e2513 = -((_e185 + _e615.member_4));
            let _e2514 = bitcast<u32>(_e2507.member.member.member);
            let _e2518 = (bitcast<i32>((_e2514 >> bitcast<u32>(23i))) & 255i);
            let _e2519 = (_e2518 + _e2513);
            if (_e2518 == 255i) {
                phi_4348_ = _e2507.member.member.member;
            } else {
                if (_e2518 > 0i) {
                    if (_e2519 > 0i) {
                        let _e2523 = (_e2519 < 255i);
                        if _e2523 {
                            phi_4327_ = bitcast<f32>((_e2514 + bitcast<u32>((_e2513 << bitcast<u32>(23i)))));
                        } else {
                            phi_4327_ = f32();
                        }
                        let _e2530 = phi_4327_;
                        phi_4329_ = _e2530;
                        phi_4330_ = select(true, false, _e2523);
                    } else {
                        phi_4329_ = f32();
                        phi_4330_ = true;
                    }
                    let _e2533 = phi_4329_;
                    let _e2535 = phi_4330_;
                    phi_4331_ = _e2533;
                    phi_4332_ = _e2535;
                } else {
                    phi_4331_ = f32();
                    phi_4332_ = true;
                }
                let _e2537 = phi_4331_;
                let _e2539 = phi_4332_;
                if _e2539 {
                    let _e2540 = (_e2514 & 2147483648u);
                    let _e2547 = ((_e2514 & 8388607u) | (select(0u, 1u, ((_e2514 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e2551 = (_e2547 == 0u);
                    if _e2551 {
                        phi_5030_ = bitcast<f32>(_e2540);
                    } else {
                        let _e2556 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2547)), 32u, _e2551) - 8u);
                        let _e2559 = (_e2547 << bitcast<u32>((_e2556 & 31u)));
                        let _e2561 = ((_e2519 + select(0i, 1i, (_e2518 == 0i))) - bitcast<i32>(_e2556));
                        if (_e2561 >= 255i) {
                            phi_5020_ = bitcast<f32>((_e2540 | 2139095040u));
                            phi_5021_ = f32();
                            phi_5022_ = true;
                        } else {
                            let _e2563 = (_e2561 > 0i);
                            if _e2563 {
                                phi_5014_ = bitcast<f32>(((_e2540 | (bitcast<u32>(_e2561) << bitcast<u32>(23i))) | (_e2559 & 8388607u)));
                                phi_5015_ = f32();
                            } else {
                                if (_e2561 < -24i) {
                                    phi_4980_ = 26u;
                                } else {
                                    phi_4980_ = bitcast<u32>((1i - _e2561));
                                }
                                let _e2568 = phi_4980_;
                                let _e2569 = (_e2568 & 31u);
                                let _e2571 = (_e2559 >> bitcast<u32>(_e2569));
                                let _e2575 = (_e2559 & ((1u << bitcast<u32>(_e2569)) - 1u));
                                let _e2579 = (1u << bitcast<u32>(((_e2568 - 1u) & 31u)));
                                if (_e2575 > _e2579) {
                                    phi_5001_ = true;
                                } else {
                                    if (_e2575 == _e2579) {
                                        phi_4998_ = ((_e2571 & 1u) == 1u);
                                    } else {
                                        phi_4998_ = false;
                                    }
                                    let _e2585 = phi_4998_;
                                    phi_5001_ = _e2585;
                                }
                                let _e2587 = phi_5001_;
                                phi_5014_ = f32();
                                phi_5015_ = bitcast<f32>((_e2540 | (_e2571 + select(0u, 1u, _e2587))));
                            }
                            let _e2600 = phi_5014_;
                            let _e2602 = phi_5015_;
                            phi_5020_ = _e2600;
                            phi_5021_ = _e2602;
                            phi_5022_ = _e2563;
                        }
                        let _e2606 = phi_5020_;
                        let _e2608 = phi_5021_;
                        let _e2610 = phi_5022_;
                        phi_5030_ = select(_e2608, _e2606, _e2610);
                    }
                    let _e2614 = phi_5030_;
                    phi_4347_ = _e2614;
                } else {
                    phi_4347_ = _e2537;
                }
                let _e2616 = phi_4347_;
                phi_4348_ = _e2616;
            }
            let _e2618 = phi_4348_;
            let _e2619 = bitcast<u32>(_e2618);
            if ((_e2619 & 2147483647u) >= 2139095040u) {
                phi_4360_ = bitcast<f32>(((_e2619 & 2147483648u) | 2139095039u));
            } else {
                phi_4360_ = _e2618;
            }
            let _e2626 = phi_4360_;
            phi_4365_ = SlimbvhTypeF(_e2626, _e2507.member.member.member_1, _e2507.member.member.member_2, _e2507.member.member.member_3);
        } else {
            phi_4365_ = _e114;
        }
        let _e2631 = phi_4365_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2631.member), bitcast<u32>(_e2631.member_1), bitcast<u32>(_e2631.member_2), _e2631.member_3);
        phi_4378_ = _e2505;
        phi_4379_ = _e2505;
        phi_4380_ = select(true, false, _e2505);
    } else {
        phi_4378_ = bool();
        phi_4379_ = false;
        phi_4380_ = true;
    }
    let _e2642 = phi_4378_;
    let _e2644 = phi_4379_;
    let _e2646 = phi_4380_;
    if _e2646 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e2642, _e2644, _e2646)));
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
