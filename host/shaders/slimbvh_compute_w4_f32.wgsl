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

struct SlimbvhTypeS {
    member: u32,
}

var<workgroup> slimbvh_stacks: array<u32, 2048>;

var<private> slimbvh_lane: SlimbvhTypeS;

var<private> slimbvh_overflowed: SlimbvhTypeS;

fn slimbvh_trace_in_group() {
    var phi_496_: u32;
    var phi_502_: u32;
    var phi_508_: u32;
    var phi_773_: i32;
    var phi_784_: i32;
    var phi_898_: i32;
    var phi_1027_: i32;
    var phi_1049_: u32;
    var phi_1050_: u32;
    var phi_1051_: bool;
    var phi_1085_: i32;
    var phi_1107_: u32;
    var phi_1108_: u32;
    var phi_1109_: bool;
    var phi_670_: i32;
    var phi_676_: u32;
    var phi_695_: u32;
    var phi_696_: u32;
    var phi_697_: bool;
    var phi_715_: i32;
    var phi_721_: u32;
    var phi_740_: u32;
    var phi_741_: u32;
    var phi_742_: bool;
    var phi_1119_: SlimbvhTypeF;
    var phi_1365_: SlimbvhTypeO;
    var phi_1406_: SlimbvhTypeO;
    var phi_1409_: u32;
    var phi_1411_: u32;
    var phi_1413_: u32;
    var phi_1422_: u32;
    var phi_1425_: u32;
    var phi_1427_: u32;
    var phi_1884_: u32;
    var phi_1897_: u32;
    var phi_1910_: u32;
    var phi_1923_: u32;
    var phi_3681_: SlimbvhTypeG;
    var phi_3693_: SlimbvhTypeG;
    var phi_3705_: SlimbvhTypeG;
    var phi_3717_: SlimbvhTypeG;
    var phi_3729_: SlimbvhTypeG;
    var phi_2007_: u32;
    var phi_2012_: u32;
    var phi_2013_: u32;
    var phi_2037_: u32;
    var phi_1423_: u32;
    var phi_1426_: u32;
    var phi_1428_: u32;
    var local: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_2054_: SlimbvhTypeO;
    var phi_2057_: SlimbvhTypeG;
    var phi_2058_: SlimbvhTypeG;
    var phi_2080_: SlimbvhTypeG;
    var phi_2159_: array<vec4<f32>, 3>;
    var phi_2160_: array<vec4<f32>, 3>;
    var phi_2240_: array<vec4<f32>, 3>;
    var phi_2241_: array<vec4<f32>, 3>;
    var phi_2264_: array<f32, 3>;
    var phi_2265_: array<f32, 3>;
    var phi_2279_: array<f32, 3>;
    var phi_2280_: array<f32, 3>;
    var phi_2294_: array<f32, 3>;
    var phi_2295_: array<f32, 3>;
    var phi_2654_: f32;
    var phi_2655_: f32;
    var phi_2656_: f32;
    var phi_2657_: f32;
    var phi_2658_: vec3<f32>;
    var phi_2659_: vec3<f32>;
    var phi_2660_: vec3<f32>;
    var phi_2661_: vec3<f32>;
    var phi_2840_: f32;
    var phi_2866_: SlimbvhTypeH;
    var phi_2867_: SlimbvhTypeH;
    var phi_2870_: SlimbvhTypeH;
    var phi_2871_: SlimbvhTypeH;
    var phi_2872_: bool;
    var phi_2876_: SlimbvhTypeH;
    var phi_2885_: SlimbvhTypeI;
    var phi_2938_: i32;
    var phi_3078_: SlimbvhTypeK;
    var phi_3102_: u32;
    var phi_3130_: vec3<f32>;
    var phi_3131_: vec3<f32>;
    var phi_3148_: vec3<f32>;
    var phi_3149_: vec3<f32>;
    var phi_3166_: vec3<f32>;
    var phi_3167_: vec3<f32>;
    var phi_3203_: vec3<f32>;
    var phi_3385_: f32;
    var phi_3403_: bool;
    var phi_3404_: bool;
    var phi_3423_: bool;
    var phi_3424_: bool;
    var phi_3431_: SlimbvhTypeO;
    var phi_3437_: SlimbvhTypeO;
    var phi_3438_: SlimbvhTypeO;
    var phi_3439_: SlimbvhTypeO;
    var phi_2055_: SlimbvhTypeO;
    var local_3: u32;
    var local_4: u32;
    var phi_3500_: u32;
    var local_5: SlimbvhTypeO;
    var phi_3509_: SlimbvhTypeO;
    var phi_3510_: u32;
    var phi_3511_: u32;
    var phi_1407_: SlimbvhTypeO;
    var phi_1410_: u32;
    var phi_1412_: u32;
    var phi_1414_: u32;
    var local_6: u32;
    var local_7: SlimbvhTypeO;
    var phi_3548_: f32;
    var phi_3550_: f32;
    var phi_3551_: bool;
    var phi_3552_: f32;
    var phi_3553_: bool;
    var phi_3960_: u32;
    var phi_3978_: bool;
    var phi_3981_: bool;
    var phi_3994_: f32;
    var phi_3995_: f32;
    var phi_4000_: f32;
    var phi_4001_: f32;
    var phi_4002_: bool;
    var phi_4010_: f32;
    var phi_3568_: f32;
    var phi_3569_: f32;
    var phi_3581_: f32;
    var phi_3586_: SlimbvhTypeI;
    var phi_3599_: bool;
    var phi_3600_: bool;
    var phi_3601_: bool;
    var local_8: SlimbvhTypeO;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e93 = SlimbvhTypeI(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e97 = arrayLength((&slimbvh_nodes.member));
    let _e110 = slimbvh_exponent.member[1u];
    let _e113 = slimbvh_exponent.member[2u];
    let _e114 = slimbvh_origin.member;
    let _e120 = slimbvh_origin.member[3u];
    let _e121 = slimbvh_direction.member;
    let _e127 = slimbvh_direction.member[3u];
    let _e130 = slimbvh_exponent.member[0u];
    let _e131 = bitcast<i32>(_e130);
    let _e133 = (bitcast<u32>(_e114.x) & 2147483647u);
    let _e135 = (bitcast<u32>(_e114.y) & 2147483647u);
    let _e137 = (bitcast<u32>(_e114.z) & 2147483647u);
    let _e138 = bitcast<u32>(_e120);
    let _e139 = (_e138 & 2147483647u);
    let _e141 = (bitcast<u32>(_e121.x) & 2147483647u);
    let _e143 = (bitcast<u32>(_e121.y) & 2147483647u);
    let _e145 = (bitcast<u32>(_e121.z) & 2147483647u);
    let _e146 = bitcast<u32>(_e127);
    let _e147 = (_e146 & 2147483647u);
    let _e149 = select(_e143, _e141, (_e143 < _e141));
    let _e151 = select(_e145, _e149, (_e145 < _e149));
    let _e153 = select(_e133, _e151, (_e133 < _e151));
    let _e155 = select(_e135, _e153, (_e135 < _e153));
    let _e157 = select(_e137, _e155, (_e137 < _e155));
    let _e164 = (((select(_e139, _e157, (_e139 < _e157)) < 2139095040u) && (_e147 <= 2139095040u)) && (_e151 > 0u));
    if (_e141 == _e151) {
        phi_496_ = 0u;
    } else {
        phi_496_ = select(2u, 1u, (_e143 == _e151));
    }
    let _e169 = phi_496_;
    let _e170 = (_e169 == 2u);
    if _e170 {
        phi_502_ = 0u;
    } else {
        phi_502_ = (_e169 + 1u);
    }
    let _e173 = phi_502_;
    let _e174 = (_e173 == 2u);
    if _e174 {
        phi_508_ = 0u;
    } else {
        phi_508_ = (_e173 + 1u);
    }
    let _e177 = phi_508_;
    let _e178 = (_e173 == 0u);
    let _e180 = select(select(_e114.y, _e114.x, _e178), _e114.z, _e174);
    let _e181 = (_e177 == 0u);
    let _e183 = (_e177 == 2u);
    let _e184 = select(select(_e114.y, _e114.x, _e181), _e114.z, _e183);
    let _e185 = (_e169 == 0u);
    let _e187 = select(select(_e114.y, _e114.x, _e185), _e114.z, _e170);
    let _e189 = select(select(_e121.y, _e121.x, _e178), _e121.z, _e174);
    let _e191 = select(select(_e121.y, _e121.x, _e181), _e121.z, _e183);
    let _e193 = select(select(_e121.y, _e121.x, _e185), _e121.z, _e170);
    let _e194 = (_e139 - 1u);
    let _e195 = (_e147 - 1u);
    let _e197 = select(_e194, _e195, (_e195 < _e194));
    let _e198 = (_e133 - 1u);
    let _e199 = (_e135 - 1u);
    let _e201 = select(_e198, _e199, (_e199 < _e198));
    let _e202 = (_e137 - 1u);
    let _e204 = select(_e201, _e202, (_e202 < _e201));
    let _e205 = (_e141 - 1u);
    let _e206 = (_e143 - 1u);
    let _e208 = select(_e205, _e206, (_e206 < _e205));
    let _e209 = (_e145 - 1u);
    let _e211 = select(_e208, _e209, (_e209 < _e208));
    let _e213 = select(_e204, _e211, (_e211 < _e204));
    if (((select(_e213, _e197, (_e197 < _e213)) >= 8388607u) && (_e151 < 2130706432u)) && (bitcast<u32>((_e131 + 126i)) <= 253u)) {
        let _e478 = bitcast<i32>((_e151 >> bitcast<u32>(23i)));
        let _e479 = (_e478 - 127i);
        let _e480 = (_e131 + _e479);
        let _e485 = bitcast<f32>((bitcast<u32>((_e131 + 127i)) << bitcast<u32>(23i)));
        let _e490 = bitcast<f32>((bitcast<u32>((254i - _e478)) << bitcast<u32>(23i)));
        if (_e139 >= 2139095040u) {
            phi_670_ = 255i;
        } else {
            phi_670_ = (bitcast<i32>((_e139 >> bitcast<u32>(23i))) + _e480);
        }
        let _e505 = phi_670_;
        if (_e139 == 0u) {
            phi_676_ = 0u;
        } else {
            phi_676_ = (_e139 | 8388608u);
        }
        let _e509 = phi_676_;
        if (_e505 <= 0i) {
            phi_696_ = u32();
            phi_697_ = true;
        } else {
            let _e516 = (_e509 == 0u);
            if _e516 {
                phi_695_ = u32();
            } else {
                phi_695_ = select(((bitcast<u32>(_e505) << bitcast<u32>(23i)) | (_e509 & 8388607u)), 2139095039u, (_e505 >= 255i));
            }
            let _e520 = phi_695_;
            phi_696_ = _e520;
            phi_697_ = _e516;
        }
        let _e522 = phi_696_;
        let _e524 = phi_697_;
        if (_e147 >= 2139095040u) {
            phi_715_ = 255i;
        } else {
            phi_715_ = (bitcast<i32>((_e147 >> bitcast<u32>(23i))) + _e480);
        }
        let _e535 = phi_715_;
        if (_e147 == 0u) {
            phi_721_ = 0u;
        } else {
            phi_721_ = (_e147 | 8388608u);
        }
        let _e539 = phi_721_;
        if (_e535 <= 0i) {
            phi_741_ = u32();
            phi_742_ = true;
        } else {
            let _e546 = (_e539 == 0u);
            if _e546 {
                phi_740_ = u32();
            } else {
                phi_740_ = select(((bitcast<u32>(_e535) << bitcast<u32>(23i)) | (_e539 & 8388607u)), 2139095039u, (_e535 >= 255i));
            }
            let _e550 = phi_740_;
            phi_741_ = _e550;
            phi_742_ = _e546;
        }
        let _e552 = phi_741_;
        let _e554 = phi_742_;
        phi_1119_ = SlimbvhTypeF(array<f32, 3>((_e180 * _e485), (_e184 * _e485), (_e187 * _e485)), array<f32, 3>((_e189 * _e490), (_e191 * _e490), (_e193 * _e490)), bitcast<f32>(((_e138 & 2147483648u) | select(_e522, 0u, _e524))), bitcast<f32>(((_e146 & 2147483648u) | select(_e552, 0u, _e554))), _e479);
    } else {
        let _e226 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e151, _e164))) & 2147483647u);
        if (_e226 >= 8388608u) {
            phi_773_ = (bitcast<i32>((_e226 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_773_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u))));
        }
        let _e240 = phi_773_;
        let _e241 = (_e131 + _e240);
        if (_e131 < -126i) {
            phi_784_ = -126i;
        } else {
            phi_784_ = select(_e131, 127i, (_e131 > 127i));
        }
        let _e246 = phi_784_;
        let _e251 = bitcast<f32>((bitcast<u32>((_e246 + 127i)) << bitcast<u32>(23i)));
        let _e257 = bitcast<f32>((bitcast<u32>(((_e131 - _e246) + 127i)) << bitcast<u32>(23i)));
        let _e258 = bitcast<u32>(_e180);
        let _e260 = ((_e258 & 2139095040u) != 0u);
        let _e275 = bitcast<u32>(_e184);
        let _e277 = ((_e275 & 2139095040u) != 0u);
        let _e292 = bitcast<u32>(_e187);
        let _e294 = ((_e292 & 2139095040u) != 0u);
        let _e310 = -(_e240);
        if (_e310 < -126i) {
            phi_898_ = -126i;
        } else {
            phi_898_ = select(_e310, 127i, (_e310 > 127i));
        }
        let _e315 = phi_898_;
        let _e320 = bitcast<f32>((bitcast<u32>((_e315 + 127i)) << bitcast<u32>(23i)));
        let _e326 = bitcast<f32>((bitcast<u32>(((_e310 - _e315) + 127i)) << bitcast<u32>(23i)));
        let _e327 = bitcast<u32>(_e189);
        let _e329 = ((_e327 & 2139095040u) != 0u);
        let _e344 = bitcast<u32>(_e191);
        let _e346 = ((_e344 & 2139095040u) != 0u);
        let _e361 = bitcast<u32>(_e193);
        let _e363 = ((_e361 & 2139095040u) != 0u);
        let _e385 = ((_e139 & 8388607u) | (select(0u, 1u, ((_e139 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e388 = bitcast<i32>((_e139 >> bitcast<u32>(23i)));
        let _e395 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e385)), 32u, (_e385 == 0u))) - 8i);
        if (_e388 == 255i) {
            phi_1027_ = 255i;
        } else {
            phi_1027_ = (((_e388 + select(0i, 1i, (_e388 == 0i))) - _e395) + _e241);
        }
        let _e403 = phi_1027_;
        let _e407 = (_e385 << bitcast<u32>(((_e395 & 31i) & 31i)));
        if (_e403 <= 0i) {
            phi_1050_ = u32();
            phi_1051_ = true;
        } else {
            let _e414 = (_e407 == 0u);
            if _e414 {
                phi_1049_ = u32();
            } else {
                phi_1049_ = select(((bitcast<u32>(_e403) << bitcast<u32>(23i)) | (_e407 & 8388607u)), 2139095039u, (_e403 >= 255i));
            }
            let _e418 = phi_1049_;
            phi_1050_ = _e418;
            phi_1051_ = _e414;
        }
        let _e420 = phi_1050_;
        let _e422 = phi_1051_;
        let _e433 = ((_e147 & 8388607u) | (select(0u, 1u, ((_e147 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e436 = bitcast<i32>((_e147 >> bitcast<u32>(23i)));
        let _e443 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e433)), 32u, (_e433 == 0u))) - 8i);
        if (_e436 == 255i) {
            phi_1085_ = 255i;
        } else {
            phi_1085_ = (((_e436 + select(0i, 1i, (_e436 == 0i))) - _e443) + _e241);
        }
        let _e451 = phi_1085_;
        let _e455 = (_e433 << bitcast<u32>(((_e443 & 31i) & 31i)));
        if (_e451 <= 0i) {
            phi_1108_ = u32();
            phi_1109_ = true;
        } else {
            let _e462 = (_e455 == 0u);
            if _e462 {
                phi_1107_ = u32();
            } else {
                phi_1107_ = select(((bitcast<u32>(_e451) << bitcast<u32>(23i)) | (_e455 & 8388607u)), 2139095039u, (_e451 >= 255i));
            }
            let _e466 = phi_1107_;
            phi_1108_ = _e466;
            phi_1109_ = _e462;
        }
        let _e468 = phi_1108_;
        let _e470 = phi_1109_;
        phi_1119_ = SlimbvhTypeF(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e258 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e258 & 2147483648u))), _e180, _e260) * _e251) * select(0.00000011920929f, 1f, _e260)) * _e257), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e275 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e275 & 2147483648u))), _e184, _e277) * _e251) * select(0.00000011920929f, 1f, _e277)) * _e257), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e292 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e292 & 2147483648u))), _e187, _e294) * _e251) * select(0.00000011920929f, 1f, _e294)) * _e257)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e327 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e327 & 2147483648u))), _e189, _e329) * _e320) * select(0.00000011920929f, 1f, _e329)) * _e326), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e344 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e344 & 2147483648u))), _e191, _e346) * _e320) * select(0.00000011920929f, 1f, _e346)) * _e326), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e361 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e361 & 2147483648u))), _e193, _e363) * _e320) * select(0.00000011920929f, 1f, _e363)) * _e326)), bitcast<f32>(((_e138 & 2147483648u) | select(_e420, 0u, _e422))), bitcast<f32>(((_e146 & 2147483648u) | select(_e468, 0u, _e470))), _e240);
    }
    let _e561 = phi_1119_;
    let _e576 = (bitcast<f32>((bitcast<u32>(_e561.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e579 = bitcast<f32>((bitcast<u32>(_e561.member[0]) & 2147483647u));
    let _e580 = (_e579 * 0.00000011920929f);
    let _e583 = select(select(0.00000000000011368684f, _e580, (_e580 > 0.00000000000011368684f)), 0f, _e576);
    let _e584 = select(0f, _e561.member_1[0], _e576);
    let _e585 = (_e561.member[0] + _e583);
    let _e586 = (_e561.member[0] - _e583);
    let _e588 = select(38685626000000000000000000f, (1f / _e561.member_1[0]), _e576);
    let _e592 = (bitcast<f32>((bitcast<u32>(_e561.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e595 = bitcast<f32>((bitcast<u32>(_e561.member[1]) & 2147483647u));
    let _e596 = (_e595 * 0.00000011920929f);
    let _e599 = select(select(0.00000000000011368684f, _e596, (_e596 > 0.00000000000011368684f)), 0f, _e592);
    let _e600 = select(0f, _e561.member_1[1], _e592);
    let _e601 = (_e561.member[1] + _e599);
    let _e602 = (_e561.member[1] - _e599);
    let _e604 = select(38685626000000000000000000f, (1f / _e561.member_1[1]), _e592);
    let _e608 = (bitcast<f32>((bitcast<u32>(_e561.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e611 = bitcast<f32>((bitcast<u32>(_e561.member[2]) & 2147483647u));
    let _e612 = (_e611 * 0.00000011920929f);
    let _e615 = select(select(0.00000000000011368684f, _e612, (_e612 > 0.00000000000011368684f)), 0f, _e608);
    let _e616 = select(0f, _e561.member_1[2], _e608);
    let _e617 = (_e561.member[2] + _e615);
    let _e618 = (_e561.member[2] - _e615);
    let _e620 = select(38685626000000000000000000f, (1f / _e561.member_1[2]), _e608);
    let _e622 = select(_e595, _e579, (_e579 > _e595));
    let _e626 = (_e164 && (select(_e611, _e622, (_e622 > _e611)) <= 1099511600000f));
    let _e627 = select(0f, _e561.member_3, _e626);
    let _e628 = select(1f, _e561.member_2, _e626);
    let _e632 = slimbvh_question.member[1u];
    let _e633 = slimbvh_lane.member;
    if (_e633 < 64u) {
        let _e635 = (_e633 % 64u);
        let _e638 = slimbvh_question.member[0u];
        if (_e638 == 1u) {
            phi_1365_ = SlimbvhTypeO(SlimbvhTypeL(_e93, _e627), true);
        } else {
            phi_1365_ = SlimbvhTypeO(SlimbvhTypeL(_e93, _e627), false);
        }
        let _e645 = phi_1365_;
        phi_1406_ = _e645;
        phi_1409_ = select(4294967295u, 0u, (_e628 <= _e627));
        phi_1411_ = 0u;
        phi_1413_ = (_e97 + 1u);
        loop {
            let _e663 = phi_1406_;
            let _e665 = phi_1409_;
            let _e667 = phi_1411_;
            let _e669 = phi_1413_;
            local_6 = _e665;
            local_7 = _e663;
            let _e670 = (_e665 <= 32u);
            if _e670 {
                phi_1422_ = _e665;
                phi_1425_ = _e667;
                phi_1427_ = _e669;
                loop {
                    let _e672 = phi_1422_;
                    let _e674 = phi_1425_;
                    let _e676 = phi_1427_;
                    local_1 = _e674;
                    local_2 = _e674;
                    local_3 = _e672;
                    local_4 = _e672;
                    local_9 = _e672;
                    local_10 = _e674;
                    local_11 = _e676;
                    let _e677 = (_e672 <= 32u);
                    let _e679 = (_e674 + _e110);
                    let _e683 = (_e677 && !(((_e674 >= _e97) || (_e679 >= _e97))));
                    local = _e677;
                    if _e683 {
                        let _e685 = ((2u * (_e173 & 3u)) + (bitcast<u32>(_e588) >> bitcast<u32>(31i)));
                        let _e687 = ((2u * (_e177 & 3u)) + (bitcast<u32>(_e604) >> bitcast<u32>(31i)));
                        let _e689 = ((2u * (_e169 & 3u)) + (bitcast<u32>(_e620) >> bitcast<u32>(31i)));
                        let _e695 = slimbvh_nodes.member[_e679].member[select(_e685, 5u, (5u < _e685))];
                        let _e701 = slimbvh_nodes.member[_e679].member[select(_e687, 5u, (5u < _e687))];
                        let _e707 = slimbvh_nodes.member[_e679].member[select(_e689, 5u, (5u < _e689))];
                        let _e708 = (_e685 ^ 1u);
                        let _e714 = slimbvh_nodes.member[_e679].member[select(_e708, 5u, (5u < _e708))];
                        let _e715 = (_e687 ^ 1u);
                        let _e721 = slimbvh_nodes.member[_e679].member[select(_e715, 5u, (5u < _e715))];
                        let _e722 = (_e689 ^ 1u);
                        let _e728 = slimbvh_nodes.member[_e679].member[select(_e722, 5u, (5u < _e722))];
                        let _e787 = ((_e707.x - _e617) * _e620);
                        let _e788 = ((_e707.y - _e617) * _e620);
                        let _e789 = ((_e707.z - _e617) * _e620);
                        let _e790 = ((_e707.w - _e617) * _e620);
                        let _e799 = ((_e728.x - _e618) * _e620);
                        let _e800 = ((_e728.y - _e618) * _e620);
                        let _e801 = ((_e728.z - _e618) * _e620);
                        let _e802 = ((_e728.w - _e618) * _e620);
                        let _e835 = max(max(max(((_e695.x - _e585) * _e588), ((_e701.x - _e601) * _e604)), _e787), _e628);
                        let _e836 = max(max(max(((_e695.y - _e585) * _e588), ((_e701.y - _e601) * _e604)), _e788), _e628);
                        let _e837 = max(max(max(((_e695.z - _e585) * _e588), ((_e701.z - _e601) * _e604)), _e789), _e628);
                        let _e838 = max(max(max(((_e695.w - _e585) * _e588), ((_e701.w - _e601) * _e604)), _e790), _e628);
                        if (_e835 <= min((min(min(((_e714.x - _e586) * _e588), ((_e721.x - _e602) * _e604)), _e799) + (max(_e799, -(_e787)) * 0.0000019073523f)), _e663.member.member_1)) {
                            phi_1884_ = (((bitcast<u32>(_e835) ^ select(0u, 4294967288u, _e645.member_1)) & 2147483640u) | 4u);
                        } else {
                            phi_1884_ = 4294967288u;
                        }
                        let _e853 = phi_1884_;
                        if (_e836 <= min((min(min(((_e714.y - _e586) * _e588), ((_e721.y - _e602) * _e604)), _e800) + (max(_e800, -(_e788)) * 0.0000019073523f)), _e663.member.member_1)) {
                            phi_1897_ = ((((bitcast<u32>(_e836) ^ select(0u, 4294967288u, _e645.member_1)) & 2147483640u) | 4u) | 1u);
                        } else {
                            phi_1897_ = 4294967288u;
                        }
                        let _e861 = phi_1897_;
                        if (_e837 <= min((min(min(((_e714.z - _e586) * _e588), ((_e721.z - _e602) * _e604)), _e801) + (max(_e801, -(_e789)) * 0.0000019073523f)), _e663.member.member_1)) {
                            phi_1910_ = ((((bitcast<u32>(_e837) ^ select(0u, 4294967288u, _e645.member_1)) & 2147483640u) | 4u) | 2u);
                        } else {
                            phi_1910_ = 4294967288u;
                        }
                        let _e869 = phi_1910_;
                        if (_e838 <= min((min(min(((_e714.w - _e586) * _e588), ((_e721.w - _e602) * _e604)), _e802) + (max(_e802, -(_e790)) * 0.0000019073523f)), _e663.member.member_1)) {
                            phi_1923_ = ((((bitcast<u32>(_e838) ^ select(0u, 4294967288u, _e645.member_1)) & 2147483640u) | 4u) | 3u);
                        } else {
                            phi_1923_ = 4294967288u;
                        }
                        let _e877 = phi_1923_;
                        if (_e853 < _e861) {
                            phi_3681_ = SlimbvhTypeG(_e853, _e861);
                        } else {
                            phi_3681_ = SlimbvhTypeG(_e861, _e853);
                        }
                        let _e882 = phi_3681_;
                        if (_e869 < _e877) {
                            phi_3693_ = SlimbvhTypeG(_e869, _e877);
                        } else {
                            phi_3693_ = SlimbvhTypeG(_e877, _e869);
                        }
                        let _e889 = phi_3693_;
                        if (_e882.member < _e889.member) {
                            phi_3705_ = SlimbvhTypeG(_e882.member, _e889.member);
                        } else {
                            phi_3705_ = SlimbvhTypeG(_e889.member, _e882.member);
                        }
                        let _e896 = phi_3705_;
                        if (_e882.member_1 < _e889.member_1) {
                            phi_3717_ = SlimbvhTypeG(_e882.member_1, _e889.member_1);
                        } else {
                            phi_3717_ = SlimbvhTypeG(_e889.member_1, _e882.member_1);
                        }
                        let _e903 = phi_3717_;
                        if (_e903.member < _e896.member_1) {
                            phi_3729_ = SlimbvhTypeG(_e903.member, _e896.member_1);
                        } else {
                            phi_3729_ = SlimbvhTypeG(_e896.member_1, _e903.member);
                        }
                        let _e910 = phi_3729_;
                        let _e925 = (((_e896.member & 7u) | ((_e910.member & 7u) << bitcast<u32>(3u))) | (((_e910.member_1 & 7u) | ((_e903.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                        if (_e925 == 0u) {
                            let _e945 = (_e672 - 1u);
                            let _e950 = slimbvh_stacks[(((_e945 % 32u) * 64u) + _e635)];
                            let _e951 = (_e950 & 511u);
                            let _e953 = (_e951 >> bitcast<u32>(3u));
                            let _e956 = ((_e953 == 0u) || (_e945 == 4294967295u));
                            if _e956 {
                            } else {
                                slimbvh_stacks[(((_e945 % 32u) * 64u) + _e635)] = (((_e950 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e953);
                            }
                            phi_2012_ = select(_e672, _e945, _e956);
                            phi_2013_ = (((_e950 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e951 & 3u) & 3u));
                        } else {
                            let _e928 = (_e925 >> bitcast<u32>(3u));
                            if (_e928 == 0u) {
                                phi_2007_ = _e672;
                            } else {
                                slimbvh_stacks[(((_e672 % 32u) * 64u) + _e635)] = ((_e679 << bitcast<u32>(9u)) | _e928);
                                phi_2007_ = (_e672 + 1u);
                            }
                            let _e939 = phi_2007_;
                            phi_2012_ = _e939;
                            phi_2013_ = ((_e679 << bitcast<u32>(2i)) | ((_e925 & 3u) & 3u));
                        }
                        let _e971 = phi_2012_;
                        let _e973 = phi_2013_;
                        let _e975 = (_e973 >> bitcast<u32>(2i));
                        if (_e975 < _e97) {
                            let _e981 = slimbvh_nodes.member[_e975].member_1[(_e973 & 3u)];
                            phi_2037_ = _e981;
                        } else {
                            phi_2037_ = 2147483648u;
                        }
                        let _e983 = phi_2037_;
                        let _e984 = (_e676 - 1u);
                        phi_1423_ = select(_e971, 4294967295u, (_e984 == 0u));
                        phi_1426_ = _e983;
                        phi_1428_ = _e984;
                    } else {
                        phi_1423_ = u32();
                        phi_1426_ = u32();
                        phi_1428_ = u32();
                    }
                    let _e988 = phi_1423_;
                    let _e990 = phi_1426_;
                    let _e992 = phi_1428_;
                    continue;
                    continuing {
                        phi_1422_ = _e988;
                        phi_1425_ = _e990;
                        phi_1427_ = _e992;
                        break if !(_e683);
                    }
                }
                let _e995 = local;
                if _e995 {
                    let _e997 = local_1;
                    let _e1000 = local_2;
                    phi_2054_ = _e663;
                    phi_2057_ = SlimbvhTypeG(0u, ((_e1000 >> bitcast<u32>(28u)) & 7u));
                    loop {
                        let _e1007 = phi_2054_;
                        let _e1009 = phi_2057_;
                        local_5 = _e1007;
                        local_8 = _e1007;
                        if (_e1009.member < _e1009.member_1) {
                            phi_2058_ = SlimbvhTypeG((_e1009.member + 1u), _e1009.member_1);
                            phi_2080_ = SlimbvhTypeG(1u, _e1009.member);
                        } else {
                            phi_2058_ = _e1009;
                            phi_2080_ = SlimbvhTypeG(0u, SlimbvhTypeG().member_1);
                        }
                        let _e1022 = phi_2058_;
                        let _e1024 = phi_2080_;
                        let _e1028 = (bitcast<i32>(_e1024.member) != 0i);
                        if _e1028 {
                            let _e1029 = (((_e997 & 268435455u) + _e113) + _e1024.member_1);
                            let _e1030 = (_e1029 / 2u);
                            let _e1031 = (_e1029 % 2u);
                            let _e1032 = (_e1030 >= arrayLength((&slimbvh_triangles.member)));
                            if _e1032 {
                                phi_2160_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e1033 = (2u * _e1031);
                                let _e1037 = slimbvh_triangles.member[_e1030][_e1033];
                                let _e1042 = slimbvh_triangles.member[_e1030][(_e1033 + 1u)];
                                let _e1047 = slimbvh_triangles.member[_e1030][(_e1033 + 2u)];
                                if (_e1031 == 0u) {
                                    phi_2159_ = array<vec4<f32>, 3>(_e1037, _e1042, _e1047);
                                } else {
                                    phi_2159_ = array<vec4<f32>, 3>(vec4<f32>(_e1037.z, _e1037.w, _e1042.x, _e1042.y), vec4<f32>(_e1042.z, _e1042.w, _e1047.x, _e1047.y), vec4<f32>(_e1047.z, _e1047.w, 0f, 0f));
                                }
                                let _e1065 = phi_2159_;
                                phi_2160_ = _e1065;
                            }
                            let _e1067 = phi_2160_;
                            let _e1070 = bitcast<u32>(_e1067[2].y);
                            if _e1032 {
                                phi_2241_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e1071 = (2u * _e1031);
                                let _e1075 = slimbvh_triangles.member[_e1030][_e1071];
                                let _e1080 = slimbvh_triangles.member[_e1030][(_e1071 + 1u)];
                                let _e1085 = slimbvh_triangles.member[_e1030][(_e1071 + 2u)];
                                if (_e1031 == 0u) {
                                    phi_2240_ = array<vec4<f32>, 3>(_e1075, _e1080, _e1085);
                                } else {
                                    phi_2240_ = array<vec4<f32>, 3>(vec4<f32>(_e1075.z, _e1075.w, _e1080.x, _e1080.y), vec4<f32>(_e1080.z, _e1080.w, _e1085.x, _e1085.y), vec4<f32>(_e1085.z, _e1085.w, 0f, 0f));
                                }
                                let _e1103 = phi_2240_;
                                phi_2241_ = _e1103;
                            }
                            let _e1105 = phi_2241_;
                            if _e178 {
                                phi_2265_ = array<f32, 3>(_e1105[0].x, _e1105[0].y, _e1105[0].z);
                            } else {
                                if (_e173 == 1u) {
                                    phi_2264_ = array<f32, 3>(_e1105[0].y, _e1105[0].z, _e1105[0].x);
                                } else {
                                    phi_2264_ = array<f32, 3>(_e1105[0].z, _e1105[0].x, _e1105[0].y);
                                }
                                let _e1128 = phi_2264_;
                                phi_2265_ = _e1128;
                            }
                            let _e1131 = phi_2265_;
                            if _e178 {
                                phi_2280_ = array<f32, 3>(_e1105[0].w, _e1105[1].x, _e1105[1].y);
                            } else {
                                if (_e173 == 1u) {
                                    phi_2279_ = array<f32, 3>(_e1105[1].x, _e1105[1].y, _e1105[0].w);
                                } else {
                                    phi_2279_ = array<f32, 3>(_e1105[1].y, _e1105[0].w, _e1105[1].x);
                                }
                                let _e1136 = phi_2279_;
                                phi_2280_ = _e1136;
                            }
                            let _e1139 = phi_2280_;
                            if _e178 {
                                phi_2295_ = array<f32, 3>(_e1105[1].z, _e1105[1].w, _e1105[2].x);
                            } else {
                                if (_e173 == 1u) {
                                    phi_2294_ = array<f32, 3>(_e1105[1].w, _e1105[2].x, _e1105[1].z);
                                } else {
                                    phi_2294_ = array<f32, 3>(_e1105[2].x, _e1105[1].z, _e1105[1].w);
                                }
                                let _e1144 = phi_2294_;
                                phi_2295_ = _e1144;
                            }
                            let _e1147 = phi_2295_;
                            let _e1161 = (_e1131[2] - _e561.member[2]);
                            let _e1164 = (((_e1131[0] - _e561.member[0]) * _e616) - (_e1161 * _e584));
                            let _e1167 = (((_e1131[1] - _e561.member[1]) * _e616) - (_e1161 * _e600));
                            let _e1170 = (_e1139[2] - _e561.member[2]);
                            let _e1173 = (((_e1139[0] - _e561.member[0]) * _e616) - (_e1170 * _e584));
                            let _e1176 = (((_e1139[1] - _e561.member[1]) * _e616) - (_e1170 * _e600));
                            let _e1179 = (_e1147[2] - _e561.member[2]);
                            let _e1182 = (((_e1147[0] - _e561.member[0]) * _e616) - (_e1179 * _e584));
                            let _e1185 = (((_e1147[1] - _e561.member[1]) * _e616) - (_e1179 * _e600));
                            let _e1186 = (_e1182 * _e1176);
                            let _e1187 = (_e1185 * _e1173);
                            let _e1188 = (_e1164 * _e1185);
                            let _e1189 = (_e1167 * _e1182);
                            let _e1190 = (_e1173 * _e1167);
                            let _e1191 = (_e1176 * _e1164);
                            let _e1196 = (((_e1186 >= _e1187) && (_e1188 >= _e1189)) && (_e1190 >= _e1191));
                            let _e1202 = (_e1196 || (((_e1186 <= _e1187) && (_e1188 <= _e1189)) && (_e1190 <= _e1191)));
                            if _e1202 {
                                let _e1204 = select(-1f, 1f, _e1196);
                                let _e1206 = ((_e1186 - _e1187) * _e1204);
                                let _e1208 = select(0f, _e1206, (_e1206 > 0f));
                                let _e1210 = ((_e1188 - _e1189) * _e1204);
                                let _e1212 = select(0f, _e1210, (_e1210 > 0f));
                                let _e1214 = ((_e1190 - _e1191) * _e1204);
                                let _e1216 = select(0f, _e1214, (_e1214 > 0f));
                                let _e1218 = ((_e1208 + _e1212) + _e1216);
                                let _e1233 = ((min(min(_e1131[0], _e1139[0]), _e1147[0]) - _e585) * _e588);
                                let _e1234 = ((max(max(_e1131[0], _e1139[0]), _e1147[0]) - _e586) * _e588);
                                let _e1235 = vec4<f32>(_e1233, f32(), _e1234, f32());
                                let _e1238 = ((min(min(_e1131[1], _e1139[1]), _e1147[1]) - _e601) * _e604);
                                let _e1239 = ((max(max(_e1131[1], _e1139[1]), _e1147[1]) - _e602) * _e604);
                                let _e1240 = vec4<f32>(_e1238, f32(), _e1239, f32());
                                let _e1243 = ((min(min(_e1131[2], _e1139[2]), _e1147[2]) - _e617) * _e620);
                                let _e1244 = ((max(max(_e1131[2], _e1139[2]), _e1147[2]) - _e618) * _e620);
                                let _e1245 = vec4<f32>(_e1243, f32(), _e1244, f32());
                                let _e1246 = vec4<f32>(_e1234, f32(), _e1233, f32());
                                let _e1248 = vec4<f32>(_e1239, f32(), _e1238, f32());
                                let _e1250 = vec4<f32>(_e1244, f32(), _e1243, f32());
                                let _e1259 = max(max(min(_e1235, _e1246).x, min(_e1240, _e1248).x), min(_e1245, _e1250).x);
                                let _e1264 = min(min(max(_e1235, _e1246).x, max(_e1240, _e1248).x), max(_e1245, _e1250).x);
                                let _e1269 = max(_e1259, _e628);
                                let _e1291 = (((((_e1202 && (_e1218 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1164, _e1173), _e1182) <= 0f) && (max(max(_e1164, _e1173), _e1182) >= 0f))) && ((min(min(_e1167, _e1176), _e1185) <= 0f) && (max(max(_e1167, _e1176), _e1185) >= 0f))) && (_e1269 <= (_e1264 + (max(max(_e1245, _e1250).x, -(min(_e1245, _e1250).x)) * 0.0000019073523f)))) && (_e1269 <= _e1007.member.member_1));
                                if _e1291 {
                                    let _e1296 = (_e1139[0] - _e1131[0]);
                                    let _e1297 = (_e1139[1] - _e1131[1]);
                                    let _e1298 = (_e1139[2] - _e1131[2]);
                                    let _e1299 = vec3<f32>(_e1296, _e1297, _e1298);
                                    let _e1300 = (_e1147[0] - _e1139[0]);
                                    let _e1301 = (_e1147[1] - _e1139[1]);
                                    let _e1302 = (_e1147[2] - _e1139[2]);
                                    let _e1303 = vec3<f32>(_e1300, _e1301, _e1302);
                                    let _e1304 = (_e1131[0] - _e1147[0]);
                                    let _e1305 = (_e1131[1] - _e1147[1]);
                                    let _e1306 = (_e1131[2] - _e1147[2]);
                                    let _e1307 = vec3<f32>(_e1304, _e1305, _e1306);
                                    let _e1318 = max(max(bitcast<f32>((bitcast<u32>(_e1296) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1297) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1298) & 2147483647u)));
                                    let _e1329 = max(max(bitcast<f32>((bitcast<u32>(_e1300) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1301) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1302) & 2147483647u)));
                                    let _e1342 = max(max(_e1318, _e1329), max(max(bitcast<f32>((bitcast<u32>(_e1304) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1305) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1306) & 2147483647u))));
                                    if (_e1318 == _e1342) {
                                        phi_2654_ = _e1176;
                                        phi_2655_ = _e1173;
                                        phi_2656_ = _e1167;
                                        phi_2657_ = _e1164;
                                        phi_2658_ = vec3<f32>(_e1131[0], _e1131[1], _e1131[2]);
                                        phi_2659_ = _e1307;
                                        phi_2660_ = _e1303;
                                        phi_2661_ = _e1299;
                                    } else {
                                        let _e1344 = (_e1329 == _e1342);
                                        let _e1349 = vec3(_e1344);
                                        phi_2654_ = select(_e1167, _e1185, _e1344);
                                        phi_2655_ = select(_e1164, _e1182, _e1344);
                                        phi_2656_ = select(_e1185, _e1176, _e1344);
                                        phi_2657_ = select(_e1182, _e1173, _e1344);
                                        phi_2658_ = select(vec3<f32>(_e1147[0], _e1147[1], _e1147[2]), vec3<f32>(_e1139[0], _e1139[1], _e1139[2]), _e1349);
                                        phi_2659_ = select(_e1303, _e1299, _e1349);
                                        phi_2660_ = select(_e1299, _e1307, _e1349);
                                        phi_2661_ = select(_e1307, _e1303, _e1349);
                                    }
                                    let _e1355 = phi_2654_;
                                    let _e1357 = phi_2655_;
                                    let _e1359 = phi_2656_;
                                    let _e1361 = phi_2657_;
                                    let _e1363 = phi_2658_;
                                    let _e1365 = phi_2659_;
                                    let _e1367 = phi_2660_;
                                    let _e1369 = phi_2661_;
                                    let _e1376 = ((_e1367.y * _e1365.z) - (_e1365.y * _e1367.z));
                                    let _e1381 = ((_e1367.z * _e1365.x) - (_e1365.z * _e1367.x));
                                    let _e1384 = ((_e1367.x * _e1365.y) - (_e1365.x * _e1367.y));
                                    let _e1387 = ((_e1208 >= _e1212) && (_e1208 >= _e1216));
                                    let _e1388 = (_e1212 >= _e1216);
                                    let _e1402 = (((_e1376 * (select(select(_e1147[0], _e1139[0], _e1388), _e1131[0], _e1387) - _e561.member[0])) + (_e1381 * (select(select(_e1147[1], _e1139[1], _e1388), _e1131[1], _e1387) - _e561.member[1]))) + (_e1384 * (select(select(_e1147[2], _e1139[2], _e1388), _e1131[2], _e1387) - _e561.member[2])));
                                    let _e1407 = (((_e1376 * _e584) + (_e1381 * _e600)) + (_e1384 * _e616));
                                    let _e1408 = (_e1357 - _e1361);
                                    let _e1409 = (_e1355 - _e1359);
                                    let _e1412 = ((_e1408 * _e1408) + (_e1409 * _e1409));
                                    let _e1419 = (-(((_e1361 * _e1408) + (_e1359 * _e1409))) / select(0.000000000000000000000000000000000000011754944f, _e1412, (_e1412 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e1421 = select(1f, _e1419, (_e1419 < 1f));
                                    let _e1423 = select(0f, _e1421, (_e1421 > 0f));
                                    let _e1432 = ((_e1363.x + (_e1369.x * _e1423)) - _e561.member[0]);
                                    let _e1435 = ((_e1363.y + (_e1369.y * _e1423)) - _e561.member[1]);
                                    let _e1438 = ((_e1363.z + (_e1369.z * _e1423)) - _e561.member[2]);
                                    let _e1503 = ((bitcast<f32>((bitcast<u32>(((((_e1376 * _e1432) + (_e1381 * _e1435)) + (_e1384 * _e1438)) - _e1402)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1435) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u))), _e1342)) * max(max(bitcast<f32>((bitcast<u32>(_e1376) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1381) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1384) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1407) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1367.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1367.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1367.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1365.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1365.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1365.z) & 2147483647u)))))));
                                    let _e1504 = (_e1402 / _e1407);
                                    if (_e1291 && !(_e1503)) {
                                        let _e1507 = (_e1438 / _e616);
                                        let _e1515 = (((_e1376 * (_e1432 - (_e584 * _e1507))) + (_e1381 * (_e1435 - (_e600 * _e1507)))) / _e1407);
                                        phi_2840_ = select(select(_e1507, (_e1507 + _e1515), (bitcast<f32>((bitcast<u32>(_e1515) & 2147483647u)) <= _e1342)), _e1504, _e1503);
                                    } else {
                                        phi_2840_ = _e1504;
                                    }
                                    let _e1524 = phi_2840_;
                                    let _e1526 = select(_e1264, _e1524, (_e1524 < _e1264));
                                    let _e1528 = select(_e1259, _e1526, (_e1526 > _e1259));
                                    let _e1531 = select(_e1528, 0f, (bitcast<u32>(_e1528) == 2147483648u));
                                    let _e1532 = (1f / _e1218);
                                    phi_2866_ = SlimbvhTypeH(_e1531, (_e1212 * _e1532), (_e1216 * _e1532), ((_e1291 && (_e1531 >= _e628)) && (_e1531 <= _e1007.member.member_1)));
                                    phi_2867_ = SlimbvhTypeH();
                                } else {
                                    phi_2866_ = SlimbvhTypeH();
                                    phi_2867_ = SlimbvhTypeH(0f, 0f, 0f, _e1291);
                                }
                                let _e1541 = phi_2866_;
                                let _e1543 = phi_2867_;
                                phi_2870_ = _e1541;
                                phi_2871_ = _e1543;
                                phi_2872_ = select(true, false, _e1291);
                            } else {
                                phi_2870_ = SlimbvhTypeH();
                                phi_2871_ = SlimbvhTypeH(0f, 0f, 0f, _e1202);
                                phi_2872_ = true;
                            }
                            let _e1546 = phi_2870_;
                            let _e1548 = phi_2871_;
                            let _e1550 = phi_2872_;
                            if _e1550 {
                                phi_2876_ = _e1548;
                            } else {
                                phi_2876_ = _e1546;
                            }
                            let _e1552 = phi_2876_;
                            if _e1552.member_3 {
                                phi_2885_ = SlimbvhTypeI(_e1552.member, _e1552.member_1, _e1552.member_2, _e1070);
                            } else {
                                phi_2885_ = _e93;
                            }
                            let _e1559 = phi_2885_;
                            if (_e1559.member_3 != 4294967295u) {
                                let _e1565 = slimbvh_target.member[0u][0u];
                                let _e1569 = slimbvh_target.member[0u][1u];
                                let _e1573 = slimbvh_target.member[0u][2u];
                                let _e1577 = slimbvh_target.member[0u][3u];
                                let _e1581 = slimbvh_target.member[1u][0u];
                                let _e1585 = slimbvh_target.member[1u][1u];
                                let _e1589 = slimbvh_target.member[1u][2u];
                                let _e1593 = slimbvh_target.member[1u][3u];
                                let _e1594 = bitcast<f32>(_e1565);
                                let _e1595 = bitcast<f32>(_e1569);
                                let _e1596 = bitcast<f32>(_e1573);
                                let _e1598 = bitcast<f32>(_e1581);
                                let _e1599 = array<u32, 3>(_e1585, _e1589, _e1593);
                                if (_e131 < -126i) {
                                    phi_2938_ = -126i;
                                } else {
                                    phi_2938_ = select(_e131, 127i, (_e131 > 127i));
                                }
                                let _e1605 = phi_2938_;
                                let _e1610 = bitcast<f32>((bitcast<u32>((_e1605 + 127i)) << bitcast<u32>(23i)));
                                let _e1616 = bitcast<f32>((bitcast<u32>(((_e131 - _e1605) + 127i)) << bitcast<u32>(23i)));
                                if (_e1577 == 0u) {
                                    phi_3078_ = SlimbvhTypeK(array<f32, 3>(_e1594, _e1595, _e1596), _e1577, _e1598, _e1599);
                                } else {
                                    let _e1618 = bitcast<u32>(_e1594);
                                    let _e1620 = ((_e1618 & 2139095040u) != 0u);
                                    let _e1635 = bitcast<u32>(_e1595);
                                    let _e1637 = ((_e1635 & 2139095040u) != 0u);
                                    let _e1652 = bitcast<u32>(_e1596);
                                    let _e1654 = ((_e1652 & 2139095040u) != 0u);
                                    let _e1670 = bitcast<u32>(_e1598);
                                    let _e1672 = ((_e1670 & 2139095040u) != 0u);
                                    phi_3078_ = SlimbvhTypeK(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1618 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1618 & 2147483648u))), _e1594, _e1620) * _e1610) * select(0.00000011920929f, 1f, _e1620)) * _e1616), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1635 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1635 & 2147483648u))), _e1595, _e1637) * _e1610) * select(0.00000011920929f, 1f, _e1637)) * _e1616), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1652 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1652 & 2147483648u))), _e1596, _e1654) * _e1610) * select(0.00000011920929f, 1f, _e1654)) * _e1616)), _e1577, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1670 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1670 & 2147483648u))), _e1598, _e1672) * _e1610) * select(0.00000011920929f, 1f, _e1672)) * _e1616), _e1599);
                                }
                                let _e1689 = phi_3078_;
                                if (_e1070 == _e632) {
                                    phi_3404_ = false;
                                } else {
                                    let _e1691 = (_e1070 / 16u);
                                    if (_e1691 < arrayLength((&slimbvh_sides.member))) {
                                        let _e1694 = slimbvh_sides.member[_e1691];
                                        phi_3102_ = _e1694;
                                    } else {
                                        phi_3102_ = 0u;
                                    }
                                    let _e1696 = phi_3102_;
                                    let _e1705 = (bitcast<i32>((_e1696 << bitcast<u32>(((30u - ((_e1070 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                    let _e1706 = (_e1705 == 0i);
                                    if _e1706 {
                                        phi_3403_ = true;
                                    } else {
                                        if _e178 {
                                            phi_3131_ = vec3<f32>(_e1131[0], _e1131[1], _e1131[2]);
                                        } else {
                                            if (_e173 == 1u) {
                                                phi_3130_ = vec3<f32>(_e1131[2], _e1131[0], _e1131[1]);
                                            } else {
                                                phi_3130_ = vec3<f32>(_e1131[1], _e1131[2], _e1131[0]);
                                            }
                                            let _e1711 = phi_3130_;
                                            phi_3131_ = _e1711;
                                        }
                                        let _e1714 = phi_3131_;
                                        if _e178 {
                                            phi_3149_ = vec3<f32>(_e1139[0], _e1139[1], _e1139[2]);
                                        } else {
                                            if (_e173 == 1u) {
                                                phi_3148_ = vec3<f32>(_e1139[2], _e1139[0], _e1139[1]);
                                            } else {
                                                phi_3148_ = vec3<f32>(_e1139[1], _e1139[2], _e1139[0]);
                                            }
                                            let _e1719 = phi_3148_;
                                            phi_3149_ = _e1719;
                                        }
                                        let _e1722 = phi_3149_;
                                        if _e178 {
                                            phi_3167_ = vec3<f32>(_e1147[0], _e1147[1], _e1147[2]);
                                        } else {
                                            if (_e173 == 1u) {
                                                phi_3166_ = vec3<f32>(_e1147[2], _e1147[0], _e1147[1]);
                                            } else {
                                                phi_3166_ = vec3<f32>(_e1147[1], _e1147[2], _e1147[0]);
                                            }
                                            let _e1727 = phi_3166_;
                                            phi_3167_ = _e1727;
                                        }
                                        let _e1730 = phi_3167_;
                                        let _e1733 = (_e1722.x - _e1714.x);
                                        let _e1736 = (_e1722.y - _e1714.y);
                                        let _e1739 = (_e1722.z - _e1714.z);
                                        let _e1741 = (_e1730.x - _e1714.x);
                                        let _e1743 = (_e1730.y - _e1714.y);
                                        let _e1745 = (_e1730.z - _e1714.z);
                                        if (_e1689.member_1 == 1u) {
                                            phi_3203_ = (vec3<f32>(_e1689.member[0], _e1689.member[1], _e1689.member[2]) - _e1714);
                                        } else {
                                            phi_3203_ = vec3<f32>(_e1689.member[0], _e1689.member[1], _e1689.member[2]);
                                        }
                                        let _e1760 = phi_3203_;
                                        let _e1766 = bitcast<f32>((bitcast<u32>((_e1733 * _e1743)) ^ _e1689.member_3[0]));
                                        let _e1770 = bitcast<f32>((bitcast<u32>((_e1736 * _e1741)) ^ _e1689.member_3[0]));
                                        let _e1774 = bitcast<f32>((bitcast<u32>((_e1736 * _e1745)) ^ _e1689.member_3[0]));
                                        let _e1778 = bitcast<f32>((bitcast<u32>((_e1739 * _e1743)) ^ _e1689.member_3[0]));
                                        let _e1782 = bitcast<f32>((bitcast<u32>((_e1739 * _e1741)) ^ _e1689.member_3[0]));
                                        let _e1786 = bitcast<f32>((bitcast<u32>((_e1733 * _e1745)) ^ _e1689.member_3[0]));
                                        let _e1787 = (_e1774 - _e1778);
                                        let _e1788 = (_e1782 - _e1786);
                                        let _e1789 = (_e1766 - _e1770);
                                        let _e1813 = (bitcast<f32>((bitcast<u32>(_e1774) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1778) & 2147483647u)));
                                        let _e1820 = (bitcast<f32>((bitcast<u32>(_e1782) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1786) & 2147483647u)));
                                        let _e1827 = (bitcast<f32>((bitcast<u32>(_e1766) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1770) & 2147483647u)));
                                        if (_e1689.member_2 == 0f) {
                                            phi_3385_ = 0f;
                                        } else {
                                            let _e1857 = bitcast<f32>((bitcast<u32>(_e1787) & 2147483647u));
                                            let _e1860 = bitcast<f32>((bitcast<u32>(_e1788) & 2147483647u));
                                            let _e1863 = bitcast<f32>((bitcast<u32>(_e1789) & 2147483647u));
                                            let _e1865 = select(_e1863, _e1860, (_e1860 > _e1863));
                                            let _e1869 = select(_e1863, _e1860, (_e1860 < _e1863));
                                            let _e1873 = select(_e1860, _e1857, (_e1857 < _e1860));
                                            let _e1875 = select(_e1860, _e1857, (_e1857 > _e1860));
                                            let _e1877 = select(_e1863, _e1875, (_e1875 < _e1863));
                                            phi_3385_ = bitcast<f32>((bitcast<u32>((_e1689.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1865, _e1857, (_e1857 > _e1865)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1877, _e1873, (_e1873 > _e1877)))) ^ _e1689.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1869, _e1857, (_e1857 < _e1869)))) ^ _e1689.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1813 + _e1820) + _e1827))) ^ _e1689.member_3[0]))) * 1.0000005f)) ^ _e1689.member_3[0])))) ^ _e1689.member_3[0]));
                                        }
                                        let _e1904 = phi_3385_;
                                        phi_3403_ = (_e1706 || !(((((bitcast<f32>((bitcast<u32>((_e1760.x * _e1787)) ^ _e1689.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1760.y * _e1788)) ^ _e1689.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1760.z * _e1789)) ^ _e1689.member_3[0]))) * f32(-(_e1705))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1760.x) & 2147483647u)) * _e1813)) ^ _e1689.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1760.y) & 2147483647u)) * _e1820)) ^ _e1689.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1760.z) & 2147483647u)) * _e1827)) ^ _e1689.member_3[0]))))) ^ _e1689.member_3[0])) + _e1904) + 0.0000000000000000000000000000000000001880791f))));
                                    }
                                    let _e1918 = phi_3403_;
                                    phi_3404_ = _e1918;
                                }
                                let _e1920 = phi_3404_;
                                if _e1920 {
                                    if (_e1559.member < _e1007.member.member.member) {
                                        phi_3424_ = true;
                                    } else {
                                        if (_e1559.member == _e1007.member.member.member) {
                                            phi_3423_ = (_e1559.member_3 < _e1007.member.member.member_3);
                                        } else {
                                            phi_3423_ = false;
                                        }
                                        let _e1932 = phi_3423_;
                                        phi_3424_ = _e1932;
                                    }
                                    let _e1934 = phi_3424_;
                                    if _e1934 {
                                        phi_3431_ = SlimbvhTypeO(SlimbvhTypeL(_e1559, _e1559.member), _e1007.member_1);
                                    } else {
                                        phi_3431_ = _e1007;
                                    }
                                    let _e1940 = phi_3431_;
                                    if _e1940.member_1 {
                                        phi_3437_ = SlimbvhTypeO(SlimbvhTypeL(_e1940.member.member, bitcast<f32>(4286578687u)), _e1940.member_1);
                                    } else {
                                        phi_3437_ = _e1940;
                                    }
                                    let _e1949 = phi_3437_;
                                    phi_3438_ = _e1949;
                                } else {
                                    phi_3438_ = _e1007;
                                }
                                let _e1951 = phi_3438_;
                                phi_3439_ = _e1951;
                            } else {
                                phi_3439_ = _e1007;
                            }
                            let _e1953 = phi_3439_;
                            phi_2055_ = _e1953;
                        } else {
                            phi_2055_ = SlimbvhTypeO();
                        }
                        let _e1955 = phi_2055_;
                        continue;
                        continuing {
                            phi_2054_ = _e1955;
                            phi_2057_ = _e1022;
                            break if !(_e1028);
                        }
                    }
                    let _e1958 = local_3;
                    let _e1959 = (_e1958 - 1u);
                    let _e1964 = slimbvh_stacks[(((_e1959 % 32u) * 64u) + _e635)];
                    let _e1965 = (_e1964 & 511u);
                    let _e1967 = (_e1965 >> bitcast<u32>(3u));
                    let _e1970 = ((_e1967 == 0u) || (_e1959 == 4294967295u));
                    if _e1970 {
                    } else {
                        slimbvh_stacks[(((_e1959 % 32u) * 64u) + _e635)] = (((_e1964 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1967);
                    }
                    let _e1977 = local_4;
                    let _e1985 = (((_e1964 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1965 & 3u) & 3u));
                    let _e1987 = (_e1985 >> bitcast<u32>(2i));
                    if (_e1987 < _e97) {
                        let _e1993 = slimbvh_nodes.member[_e1987].member_1[(_e1985 & 3u)];
                        phi_3500_ = _e1993;
                    } else {
                        phi_3500_ = 2147483648u;
                    }
                    let _e1995 = phi_3500_;
                    let _e1997 = local_5;
                    let _e2272 = local_8;
                    phi_3509_ = _e2272;
                    phi_3510_ = select(select(_e1977, _e1959, _e1970), 4294967295u, (_e628 > _e1997.member.member_1));
                    phi_3511_ = _e1995;
                } else {
                    phi_3509_ = _e663;
                    let _e2275 = local_9;
                    phi_3510_ = _e2275;
                    let _e2278 = local_10;
                    phi_3511_ = _e2278;
                }
                let _e2003 = phi_3509_;
                let _e2005 = phi_3510_;
                let _e2007 = phi_3511_;
                phi_1407_ = _e2003;
                phi_1410_ = _e2005;
                phi_1412_ = _e2007;
                let _e2284 = local_11;
                phi_1414_ = _e2284;
            } else {
                phi_1407_ = SlimbvhTypeO();
                phi_1410_ = u32();
                phi_1412_ = u32();
                phi_1414_ = u32();
            }
            let _e2009 = phi_1407_;
            let _e2011 = phi_1410_;
            let _e2013 = phi_1412_;
            let _e2015 = phi_1414_;
            continue;
            continuing {
                phi_1406_ = _e2009;
                phi_1409_ = _e2011;
                phi_1411_ = _e2013;
                phi_1413_ = _e2015;
                break if !(_e670);
            }
        }
        let _e2018 = local_6;
        let _e2019 = (_e2018 == 4294967295u);
        let _e2021 = local_7;
        if (_e2021.member.member.member_3 != 4294967295u) {
            let _e2027 = -((_e131 + _e561.member_4));
            let _e2028 = bitcast<u32>(_e2021.member.member.member);
            let _e2032 = (bitcast<i32>((_e2028 >> bitcast<u32>(23i))) & 255i);
            let _e2033 = (_e2032 + _e2027);
            if (_e2032 == 255i) {
                phi_3569_ = _e2021.member.member.member;
            } else {
                if (_e2032 > 0i) {
                    if (_e2033 > 0i) {
                        let _e2037 = (_e2033 < 255i);
                        if _e2037 {
                            phi_3548_ = bitcast<f32>((_e2028 + bitcast<u32>((_e2027 << bitcast<u32>(23i)))));
                        } else {
                            phi_3548_ = f32();
                        }
                        let _e2044 = phi_3548_;
                        phi_3550_ = _e2044;
                        phi_3551_ = select(true, false, _e2037);
                    } else {
                        phi_3550_ = f32();
                        phi_3551_ = true;
                    }
                    let _e2047 = phi_3550_;
                    let _e2049 = phi_3551_;
                    phi_3552_ = _e2047;
                    phi_3553_ = _e2049;
                } else {
                    phi_3552_ = f32();
                    phi_3553_ = true;
                }
                let _e2051 = phi_3552_;
                let _e2053 = phi_3553_;
                if _e2053 {
                    let _e2054 = (_e2028 & 2147483648u);
                    let _e2061 = ((_e2028 & 8388607u) | (select(0u, 1u, ((_e2028 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e2065 = (_e2061 == 0u);
                    if _e2065 {
                        phi_4010_ = bitcast<f32>(_e2054);
                    } else {
                        let _e2070 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2061)), 32u, _e2065) - 8u);
                        let _e2073 = (_e2061 << bitcast<u32>((_e2070 & 31u)));
                        let _e2075 = ((_e2033 + select(0i, 1i, (_e2032 == 0i))) - bitcast<i32>(_e2070));
                        if (_e2075 >= 255i) {
                            phi_4000_ = bitcast<f32>((_e2054 | 2139095040u));
                            phi_4001_ = f32();
                            phi_4002_ = true;
                        } else {
                            let _e2077 = (_e2075 > 0i);
                            if _e2077 {
                                phi_3994_ = bitcast<f32>(((_e2054 | (bitcast<u32>(_e2075) << bitcast<u32>(23i))) | (_e2073 & 8388607u)));
                                phi_3995_ = f32();
                            } else {
                                if (_e2075 < -24i) {
                                    phi_3960_ = 26u;
                                } else {
                                    phi_3960_ = bitcast<u32>((1i - _e2075));
                                }
                                let _e2082 = phi_3960_;
                                let _e2083 = (_e2082 & 31u);
                                let _e2085 = (_e2073 >> bitcast<u32>(_e2083));
                                let _e2089 = (_e2073 & ((1u << bitcast<u32>(_e2083)) - 1u));
                                let _e2093 = (1u << bitcast<u32>(((_e2082 - 1u) & 31u)));
                                if (_e2089 > _e2093) {
                                    phi_3981_ = true;
                                } else {
                                    if (_e2089 == _e2093) {
                                        phi_3978_ = ((_e2085 & 1u) == 1u);
                                    } else {
                                        phi_3978_ = false;
                                    }
                                    let _e2099 = phi_3978_;
                                    phi_3981_ = _e2099;
                                }
                                let _e2101 = phi_3981_;
                                phi_3994_ = f32();
                                phi_3995_ = bitcast<f32>((_e2054 | (_e2085 + select(0u, 1u, _e2101))));
                            }
                            let _e2114 = phi_3994_;
                            let _e2116 = phi_3995_;
                            phi_4000_ = _e2114;
                            phi_4001_ = _e2116;
                            phi_4002_ = _e2077;
                        }
                        let _e2120 = phi_4000_;
                        let _e2122 = phi_4001_;
                        let _e2124 = phi_4002_;
                        phi_4010_ = select(_e2122, _e2120, _e2124);
                    }
                    let _e2128 = phi_4010_;
                    phi_3568_ = _e2128;
                } else {
                    phi_3568_ = _e2051;
                }
                let _e2130 = phi_3568_;
                phi_3569_ = _e2130;
            }
            let _e2132 = phi_3569_;
            let _e2133 = bitcast<u32>(_e2132);
            if ((_e2133 & 2147483647u) >= 2139095040u) {
                phi_3581_ = bitcast<f32>(((_e2133 & 2147483648u) | 2139095039u));
            } else {
                phi_3581_ = _e2132;
            }
            let _e2140 = phi_3581_;
            phi_3586_ = SlimbvhTypeI(_e2140, _e2021.member.member.member_1, _e2021.member.member.member_2, _e2021.member.member.member_3);
        } else {
            phi_3586_ = _e93;
        }
        let _e2145 = phi_3586_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2145.member), bitcast<u32>(_e2145.member_1), bitcast<u32>(_e2145.member_2), _e2145.member_3);
        phi_3599_ = _e2019;
        phi_3600_ = _e2019;
        phi_3601_ = select(true, false, _e2019);
    } else {
        phi_3599_ = bool();
        phi_3600_ = false;
        phi_3601_ = true;
    }
    let _e2156 = phi_3599_;
    let _e2158 = phi_3600_;
    let _e2160 = phi_3601_;
    if _e2160 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e2156, _e2158, _e2160)));
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
