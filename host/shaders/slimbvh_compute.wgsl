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

struct SlimbvhTypeR {
    member: u32,
}

var<workgroup> slimbvh_stacks: array<u32, 2048>;

var<private> slimbvh_lane: SlimbvhTypeR;

var<private> slimbvh_overflowed: SlimbvhTypeR;

fn slimbvh_trace_in_group() {
    var phi_434_: u32;
    var phi_440_: u32;
    var phi_446_: u32;
    var phi_711_: i32;
    var phi_722_: i32;
    var phi_836_: i32;
    var phi_965_: i32;
    var phi_987_: u32;
    var phi_988_: u32;
    var phi_989_: bool;
    var phi_1023_: i32;
    var phi_1045_: u32;
    var phi_1046_: u32;
    var phi_1047_: bool;
    var phi_608_: i32;
    var phi_614_: u32;
    var phi_633_: u32;
    var phi_634_: u32;
    var phi_635_: bool;
    var phi_653_: i32;
    var phi_659_: u32;
    var phi_678_: u32;
    var phi_679_: u32;
    var phi_680_: bool;
    var phi_1057_: SlimbvhTypeD;
    var phi_1269_: SlimbvhTypeN;
    var phi_1284_: SlimbvhTypeN;
    var phi_1287_: u32;
    var phi_1289_: u32;
    var phi_1291_: u32;
    var phi_1300_: u32;
    var phi_1303_: u32;
    var phi_1305_: u32;
    var phi_1569_: u32;
    var phi_1585_: u32;
    var phi_1586_: u32;
    var phi_1301_: u32;
    var phi_1304_: u32;
    var phi_1306_: u32;
    var local: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_1602_: SlimbvhTypeN;
    var phi_1605_: SlimbvhTypeE;
    var phi_1606_: SlimbvhTypeE;
    var phi_1628_: SlimbvhTypeE;
    var phi_1707_: array<vec4<f32>, 3>;
    var phi_1708_: array<vec4<f32>, 3>;
    var phi_1782_: array<vec4<f32>, 3>;
    var phi_1783_: array<vec4<f32>, 3>;
    var phi_1806_: array<f32, 3>;
    var phi_1807_: array<f32, 3>;
    var phi_1821_: array<f32, 3>;
    var phi_1822_: array<f32, 3>;
    var phi_1836_: array<f32, 3>;
    var phi_1837_: array<f32, 3>;
    var phi_2170_: f32;
    var phi_2171_: f32;
    var phi_2172_: f32;
    var phi_2173_: f32;
    var phi_2174_: vec3<f32>;
    var phi_2175_: vec3<f32>;
    var phi_2176_: vec3<f32>;
    var phi_2177_: vec3<f32>;
    var phi_2356_: f32;
    var phi_2382_: SlimbvhTypeF;
    var phi_2383_: SlimbvhTypeF;
    var phi_2386_: SlimbvhTypeF;
    var phi_2387_: SlimbvhTypeF;
    var phi_2388_: bool;
    var phi_2392_: SlimbvhTypeF;
    var phi_2401_: SlimbvhTypeG;
    var phi_2448_: i32;
    var phi_2588_: SlimbvhTypeI;
    var phi_2612_: u32;
    var phi_2640_: vec3<f32>;
    var phi_2641_: vec3<f32>;
    var phi_2658_: vec3<f32>;
    var phi_2659_: vec3<f32>;
    var phi_2676_: vec3<f32>;
    var phi_2677_: vec3<f32>;
    var phi_2713_: vec3<f32>;
    var phi_2895_: f32;
    var phi_2913_: bool;
    var phi_2914_: bool;
    var phi_2933_: bool;
    var phi_2934_: bool;
    var phi_2941_: SlimbvhTypeN;
    var phi_2947_: SlimbvhTypeN;
    var phi_2948_: SlimbvhTypeN;
    var phi_2949_: SlimbvhTypeN;
    var phi_1603_: SlimbvhTypeN;
    var local_3: u32;
    var local_4: SlimbvhTypeN;
    var phi_2971_: SlimbvhTypeN;
    var phi_2972_: u32;
    var phi_2973_: u32;
    var phi_1285_: SlimbvhTypeN;
    var phi_1288_: u32;
    var phi_1290_: u32;
    var phi_1292_: u32;
    var local_5: u32;
    var local_6: SlimbvhTypeN;
    var phi_3008_: f32;
    var phi_3010_: f32;
    var phi_3011_: bool;
    var phi_3012_: f32;
    var phi_3013_: bool;
    var phi_3416_: u32;
    var phi_3434_: bool;
    var phi_3437_: bool;
    var phi_3450_: f32;
    var phi_3451_: f32;
    var phi_3456_: f32;
    var phi_3457_: f32;
    var phi_3458_: bool;
    var phi_3466_: f32;
    var phi_3028_: f32;
    var phi_3029_: f32;
    var phi_3041_: f32;
    var phi_3046_: SlimbvhTypeG;
    var phi_3059_: bool;
    var phi_3060_: bool;
    var phi_3061_: bool;
    var local_7: SlimbvhTypeN;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e87 = SlimbvhTypeG(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e90 = arrayLength((&slimbvh_nodes.member));
    let _e101 = slimbvh_origin.member;
    let _e107 = slimbvh_origin.member[3u];
    let _e108 = slimbvh_direction.member;
    let _e114 = slimbvh_direction.member[3u];
    let _e117 = slimbvh_exponent.member[0u];
    let _e118 = bitcast<i32>(_e117);
    let _e120 = (bitcast<u32>(_e101.x) & 2147483647u);
    let _e122 = (bitcast<u32>(_e101.y) & 2147483647u);
    let _e124 = (bitcast<u32>(_e101.z) & 2147483647u);
    let _e125 = bitcast<u32>(_e107);
    let _e126 = (_e125 & 2147483647u);
    let _e128 = (bitcast<u32>(_e108.x) & 2147483647u);
    let _e130 = (bitcast<u32>(_e108.y) & 2147483647u);
    let _e132 = (bitcast<u32>(_e108.z) & 2147483647u);
    let _e133 = bitcast<u32>(_e114);
    let _e134 = (_e133 & 2147483647u);
    let _e136 = select(_e130, _e128, (_e130 < _e128));
    let _e138 = select(_e132, _e136, (_e132 < _e136));
    let _e140 = select(_e120, _e138, (_e120 < _e138));
    let _e142 = select(_e122, _e140, (_e122 < _e140));
    let _e144 = select(_e124, _e142, (_e124 < _e142));
    let _e151 = (((select(_e126, _e144, (_e126 < _e144)) < 2139095040u) && (_e134 <= 2139095040u)) && (_e138 > 0u));
    if (_e128 == _e138) {
        phi_434_ = 0u;
    } else {
        phi_434_ = select(2u, 1u, (_e130 == _e138));
    }
    let _e156 = phi_434_;
    let _e157 = (_e156 == 2u);
    if _e157 {
        phi_440_ = 0u;
    } else {
        phi_440_ = (_e156 + 1u);
    }
    let _e160 = phi_440_;
    let _e161 = (_e160 == 2u);
    if _e161 {
        phi_446_ = 0u;
    } else {
        phi_446_ = (_e160 + 1u);
    }
    let _e164 = phi_446_;
    let _e165 = (_e160 == 0u);
    let _e167 = select(select(_e101.y, _e101.x, _e165), _e101.z, _e161);
    let _e168 = (_e164 == 0u);
    let _e170 = (_e164 == 2u);
    let _e171 = select(select(_e101.y, _e101.x, _e168), _e101.z, _e170);
    let _e172 = (_e156 == 0u);
    let _e174 = select(select(_e101.y, _e101.x, _e172), _e101.z, _e157);
    let _e176 = select(select(_e108.y, _e108.x, _e165), _e108.z, _e161);
    let _e178 = select(select(_e108.y, _e108.x, _e168), _e108.z, _e170);
    let _e180 = select(select(_e108.y, _e108.x, _e172), _e108.z, _e157);
    let _e181 = (_e126 - 1u);
    let _e182 = (_e134 - 1u);
    let _e184 = select(_e181, _e182, (_e182 < _e181));
    let _e185 = (_e120 - 1u);
    let _e186 = (_e122 - 1u);
    let _e188 = select(_e185, _e186, (_e186 < _e185));
    let _e189 = (_e124 - 1u);
    let _e191 = select(_e188, _e189, (_e189 < _e188));
    let _e192 = (_e128 - 1u);
    let _e193 = (_e130 - 1u);
    let _e195 = select(_e192, _e193, (_e193 < _e192));
    let _e196 = (_e132 - 1u);
    let _e198 = select(_e195, _e196, (_e196 < _e195));
    let _e200 = select(_e191, _e198, (_e198 < _e191));
    if (((select(_e200, _e184, (_e184 < _e200)) >= 8388607u) && (_e138 < 2130706432u)) && (bitcast<u32>((_e118 + 126i)) <= 253u)) {
        let _e465 = bitcast<i32>((_e138 >> bitcast<u32>(23i)));
        let _e466 = (_e465 - 127i);
        let _e467 = (_e118 + _e466);
        let _e472 = bitcast<f32>((bitcast<u32>((_e118 + 127i)) << bitcast<u32>(23i)));
        let _e477 = bitcast<f32>((bitcast<u32>((254i - _e465)) << bitcast<u32>(23i)));
        if (_e126 >= 2139095040u) {
            phi_608_ = 255i;
        } else {
            phi_608_ = (bitcast<i32>((_e126 >> bitcast<u32>(23i))) + _e467);
        }
        let _e492 = phi_608_;
        if (_e126 == 0u) {
            phi_614_ = 0u;
        } else {
            phi_614_ = (_e126 | 8388608u);
        }
        let _e496 = phi_614_;
        if (_e492 <= 0i) {
            phi_634_ = u32();
            phi_635_ = true;
        } else {
            let _e503 = (_e496 == 0u);
            if _e503 {
                phi_633_ = u32();
            } else {
                phi_633_ = select(((bitcast<u32>(_e492) << bitcast<u32>(23i)) | (_e496 & 8388607u)), 2139095039u, (_e492 >= 255i));
            }
            let _e507 = phi_633_;
            phi_634_ = _e507;
            phi_635_ = _e503;
        }
        let _e509 = phi_634_;
        let _e511 = phi_635_;
        if (_e134 >= 2139095040u) {
            phi_653_ = 255i;
        } else {
            phi_653_ = (bitcast<i32>((_e134 >> bitcast<u32>(23i))) + _e467);
        }
        let _e522 = phi_653_;
        if (_e134 == 0u) {
            phi_659_ = 0u;
        } else {
            phi_659_ = (_e134 | 8388608u);
        }
        let _e526 = phi_659_;
        if (_e522 <= 0i) {
            phi_679_ = u32();
            phi_680_ = true;
        } else {
            let _e533 = (_e526 == 0u);
            if _e533 {
                phi_678_ = u32();
            } else {
                phi_678_ = select(((bitcast<u32>(_e522) << bitcast<u32>(23i)) | (_e526 & 8388607u)), 2139095039u, (_e522 >= 255i));
            }
            let _e537 = phi_678_;
            phi_679_ = _e537;
            phi_680_ = _e533;
        }
        let _e539 = phi_679_;
        let _e541 = phi_680_;
        phi_1057_ = SlimbvhTypeD(array<f32, 3>((_e167 * _e472), (_e171 * _e472), (_e174 * _e472)), array<f32, 3>((_e176 * _e477), (_e178 * _e477), (_e180 * _e477)), bitcast<f32>(((_e125 & 2147483648u) | select(_e509, 0u, _e511))), bitcast<f32>(((_e133 & 2147483648u) | select(_e539, 0u, _e541))), _e466);
    } else {
        let _e213 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e138, _e151))) & 2147483647u);
        if (_e213 >= 8388608u) {
            phi_711_ = (bitcast<i32>((_e213 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_711_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e213)), 32u, (_e213 == 0u))));
        }
        let _e227 = phi_711_;
        let _e228 = (_e118 + _e227);
        if (_e118 < -126i) {
            phi_722_ = -126i;
        } else {
            phi_722_ = select(_e118, 127i, (_e118 > 127i));
        }
        let _e233 = phi_722_;
        let _e238 = bitcast<f32>((bitcast<u32>((_e233 + 127i)) << bitcast<u32>(23i)));
        let _e244 = bitcast<f32>((bitcast<u32>(((_e118 - _e233) + 127i)) << bitcast<u32>(23i)));
        let _e245 = bitcast<u32>(_e167);
        let _e247 = ((_e245 & 2139095040u) != 0u);
        let _e262 = bitcast<u32>(_e171);
        let _e264 = ((_e262 & 2139095040u) != 0u);
        let _e279 = bitcast<u32>(_e174);
        let _e281 = ((_e279 & 2139095040u) != 0u);
        let _e297 = -(_e227);
        if (_e297 < -126i) {
            phi_836_ = -126i;
        } else {
            phi_836_ = select(_e297, 127i, (_e297 > 127i));
        }
        let _e302 = phi_836_;
        let _e307 = bitcast<f32>((bitcast<u32>((_e302 + 127i)) << bitcast<u32>(23i)));
        let _e313 = bitcast<f32>((bitcast<u32>(((_e297 - _e302) + 127i)) << bitcast<u32>(23i)));
        let _e314 = bitcast<u32>(_e176);
        let _e316 = ((_e314 & 2139095040u) != 0u);
        let _e331 = bitcast<u32>(_e178);
        let _e333 = ((_e331 & 2139095040u) != 0u);
        let _e348 = bitcast<u32>(_e180);
        let _e350 = ((_e348 & 2139095040u) != 0u);
        let _e372 = ((_e126 & 8388607u) | (select(0u, 1u, ((_e126 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e375 = bitcast<i32>((_e126 >> bitcast<u32>(23i)));
        let _e382 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e372)), 32u, (_e372 == 0u))) - 8i);
        if (_e375 == 255i) {
            phi_965_ = 255i;
        } else {
            phi_965_ = (((_e375 + select(0i, 1i, (_e375 == 0i))) - _e382) + _e228);
        }
        let _e390 = phi_965_;
        let _e394 = (_e372 << bitcast<u32>(((_e382 & 31i) & 31i)));
        if (_e390 <= 0i) {
            phi_988_ = u32();
            phi_989_ = true;
        } else {
            let _e401 = (_e394 == 0u);
            if _e401 {
                phi_987_ = u32();
            } else {
                phi_987_ = select(((bitcast<u32>(_e390) << bitcast<u32>(23i)) | (_e394 & 8388607u)), 2139095039u, (_e390 >= 255i));
            }
            let _e405 = phi_987_;
            phi_988_ = _e405;
            phi_989_ = _e401;
        }
        let _e407 = phi_988_;
        let _e409 = phi_989_;
        let _e420 = ((_e134 & 8388607u) | (select(0u, 1u, ((_e134 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e423 = bitcast<i32>((_e134 >> bitcast<u32>(23i)));
        let _e430 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e420)), 32u, (_e420 == 0u))) - 8i);
        if (_e423 == 255i) {
            phi_1023_ = 255i;
        } else {
            phi_1023_ = (((_e423 + select(0i, 1i, (_e423 == 0i))) - _e430) + _e228);
        }
        let _e438 = phi_1023_;
        let _e442 = (_e420 << bitcast<u32>(((_e430 & 31i) & 31i)));
        if (_e438 <= 0i) {
            phi_1046_ = u32();
            phi_1047_ = true;
        } else {
            let _e449 = (_e442 == 0u);
            if _e449 {
                phi_1045_ = u32();
            } else {
                phi_1045_ = select(((bitcast<u32>(_e438) << bitcast<u32>(23i)) | (_e442 & 8388607u)), 2139095039u, (_e438 >= 255i));
            }
            let _e453 = phi_1045_;
            phi_1046_ = _e453;
            phi_1047_ = _e449;
        }
        let _e455 = phi_1046_;
        let _e457 = phi_1047_;
        phi_1057_ = SlimbvhTypeD(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e245 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e245 & 2147483648u))), _e167, _e247) * _e238) * select(0.00000011920929f, 1f, _e247)) * _e244), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e262 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e262 & 2147483648u))), _e171, _e264) * _e238) * select(0.00000011920929f, 1f, _e264)) * _e244), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e279 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e279 & 2147483648u))), _e174, _e281) * _e238) * select(0.00000011920929f, 1f, _e281)) * _e244)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e314 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e314 & 2147483648u))), _e176, _e316) * _e307) * select(0.00000011920929f, 1f, _e316)) * _e313), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e331 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e331 & 2147483648u))), _e178, _e333) * _e307) * select(0.00000011920929f, 1f, _e333)) * _e313), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e348 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e348 & 2147483648u))), _e180, _e350) * _e307) * select(0.00000011920929f, 1f, _e350)) * _e313)), bitcast<f32>(((_e125 & 2147483648u) | select(_e407, 0u, _e409))), bitcast<f32>(((_e133 & 2147483648u) | select(_e455, 0u, _e457))), _e227);
    }
    let _e548 = phi_1057_;
    let _e563 = (bitcast<f32>((bitcast<u32>(_e548.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e566 = bitcast<f32>((bitcast<u32>(_e548.member[0]) & 2147483647u));
    let _e567 = (_e566 * 0.00000011920929f);
    let _e570 = select(select(0.00000000000011368684f, _e567, (_e567 > 0.00000000000011368684f)), 0f, _e563);
    let _e571 = select(0f, _e548.member_1[0], _e563);
    let _e572 = (_e548.member[0] + _e570);
    let _e573 = (_e548.member[0] - _e570);
    let _e575 = select(38685626000000000000000000f, (1f / _e548.member_1[0]), _e563);
    let _e579 = (bitcast<f32>((bitcast<u32>(_e548.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e582 = bitcast<f32>((bitcast<u32>(_e548.member[1]) & 2147483647u));
    let _e583 = (_e582 * 0.00000011920929f);
    let _e586 = select(select(0.00000000000011368684f, _e583, (_e583 > 0.00000000000011368684f)), 0f, _e579);
    let _e587 = select(0f, _e548.member_1[1], _e579);
    let _e588 = (_e548.member[1] + _e586);
    let _e589 = (_e548.member[1] - _e586);
    let _e591 = select(38685626000000000000000000f, (1f / _e548.member_1[1]), _e579);
    let _e595 = (bitcast<f32>((bitcast<u32>(_e548.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e598 = bitcast<f32>((bitcast<u32>(_e548.member[2]) & 2147483647u));
    let _e599 = (_e598 * 0.00000011920929f);
    let _e602 = select(select(0.00000000000011368684f, _e599, (_e599 > 0.00000000000011368684f)), 0f, _e595);
    let _e603 = select(0f, _e548.member_1[2], _e595);
    let _e604 = (_e548.member[2] + _e602);
    let _e605 = (_e548.member[2] - _e602);
    let _e607 = select(38685626000000000000000000f, (1f / _e548.member_1[2]), _e595);
    let _e609 = select(_e582, _e566, (_e566 > _e582));
    let _e613 = (_e151 && (select(_e598, _e609, (_e609 > _e598)) <= 1099511600000f));
    let _e614 = select(0f, _e548.member_3, _e613);
    let _e615 = select(1f, _e548.member_2, _e613);
    let _e619 = slimbvh_question.member[1u];
    let _e620 = slimbvh_lane.member;
    if (_e620 < 64u) {
        let _e622 = (_e620 % 64u);
        let _e625 = slimbvh_question.member[0u];
        if (_e625 == 1u) {
            phi_1269_ = SlimbvhTypeN(SlimbvhTypeJ(_e87, _e614), true);
        } else {
            phi_1269_ = SlimbvhTypeN(SlimbvhTypeJ(_e87, _e614), false);
        }
        let _e632 = phi_1269_;
        phi_1284_ = _e632;
        phi_1287_ = select(4294967295u, 0u, (_e615 <= _e614));
        phi_1289_ = 0u;
        phi_1291_ = (_e90 + 1u);
        loop {
            let _e641 = phi_1284_;
            let _e643 = phi_1287_;
            let _e645 = phi_1289_;
            let _e647 = phi_1291_;
            local_5 = _e643;
            local_6 = _e641;
            let _e648 = (_e643 <= 32u);
            if _e648 {
                phi_1300_ = _e643;
                phi_1303_ = _e645;
                phi_1305_ = _e647;
                loop {
                    let _e650 = phi_1300_;
                    let _e652 = phi_1303_;
                    let _e654 = phi_1305_;
                    local_1 = _e652;
                    local_2 = _e652;
                    local_3 = _e650;
                    local_8 = _e650;
                    local_9 = _e652;
                    local_10 = _e654;
                    let _e655 = (_e650 <= 32u);
                    let _e658 = (_e655 && !((_e652 >= _e90)));
                    local = _e655;
                    if _e658 {
                        let _e663 = slimbvh_nodes.member[_e652][3u][0u];
                        let _e668 = slimbvh_nodes.member[_e652][3u][1u];
                        let _e673 = slimbvh_nodes.member[_e652][((_e160 & 3u) % 4u)];
                        let _e678 = slimbvh_nodes.member[_e652][((_e164 & 3u) % 4u)];
                        let _e683 = slimbvh_nodes.member[_e652][((_e156 & 3u) % 4u)];
                        let _e684 = bitcast<u32>(_e663);
                        let _e685 = bitcast<u32>(_e668);
                        let _e696 = ((_e673.x - _e572) * _e575);
                        let _e697 = ((_e673.y - _e572) * _e575);
                        let _e698 = ((_e673.z - _e573) * _e575);
                        let _e699 = ((_e673.w - _e573) * _e575);
                        let _e700 = vec4<f32>(_e696, _e697, _e698, _e699);
                        let _e709 = ((_e678.x - _e588) * _e591);
                        let _e710 = ((_e678.y - _e588) * _e591);
                        let _e711 = ((_e678.z - _e589) * _e591);
                        let _e712 = ((_e678.w - _e589) * _e591);
                        let _e713 = vec4<f32>(_e709, _e710, _e711, _e712);
                        let _e722 = ((_e683.x - _e604) * _e607);
                        let _e723 = ((_e683.y - _e604) * _e607);
                        let _e724 = ((_e683.z - _e605) * _e607);
                        let _e725 = ((_e683.w - _e605) * _e607);
                        let _e726 = vec4<f32>(_e722, _e723, _e724, _e725);
                        let _e727 = vec4<f32>(_e698, _e699, _e696, _e697);
                        let _e728 = min(_e700, _e727);
                        let _e729 = vec4<f32>(_e711, _e712, _e709, _e710);
                        let _e730 = min(_e713, _e729);
                        let _e731 = vec4<f32>(_e724, _e725, _e722, _e723);
                        let _e732 = min(_e726, _e731);
                        let _e733 = max(_e700, _e727);
                        let _e734 = max(_e713, _e729);
                        let _e735 = max(_e726, _e731);
                        let _e764 = max(max(max(_e728.x, _e730.x), _e732.x), _e615);
                        let _e765 = max(max(max(_e728.y, _e730.y), _e732.y), _e615);
                        let _e768 = (_e764 <= min((min(min(_e733.x, _e734.x), _e735.x) + (max(_e735.x, -(_e732.x)) * 0.0000019073523f)), _e641.member.member_1));
                        let _e769 = (_e765 <= min((min(min(_e733.y, _e734.y), _e735.y) + (max(_e735.y, -(_e732.y)) * 0.0000019073523f)), _e641.member.member_1));
                        if (_e768 || _e769) {
                            let _e781 = (_e768 && (((_e764 <= _e765) != _e632.member_1) || !(_e769)));
                            if (_e768 && _e769) {
                                slimbvh_stacks[(((_e650 % 32u) * 64u) + _e622)] = select(_e684, _e685, _e781);
                                phi_1569_ = (_e650 + 1u);
                            } else {
                                phi_1569_ = _e650;
                            }
                            let _e791 = phi_1569_;
                            phi_1585_ = _e791;
                            phi_1586_ = select(_e685, _e684, _e781);
                        } else {
                            let _e773 = (_e650 - 1u);
                            let _e778 = slimbvh_stacks[(((_e773 % 32u) * 64u) + _e622)];
                            phi_1585_ = _e773;
                            phi_1586_ = _e778;
                        }
                        let _e793 = phi_1585_;
                        let _e795 = phi_1586_;
                        let _e796 = (_e654 - 1u);
                        phi_1301_ = select(_e793, 4294967295u, (_e796 == 0u));
                        phi_1304_ = _e795;
                        phi_1306_ = _e796;
                    } else {
                        phi_1301_ = u32();
                        phi_1304_ = u32();
                        phi_1306_ = u32();
                    }
                    let _e800 = phi_1301_;
                    let _e802 = phi_1304_;
                    let _e804 = phi_1306_;
                    continue;
                    continuing {
                        phi_1300_ = _e800;
                        phi_1303_ = _e802;
                        phi_1305_ = _e804;
                        break if !(_e658);
                    }
                }
                let _e807 = local;
                if _e807 {
                    let _e809 = local_1;
                    let _e812 = local_2;
                    phi_1602_ = _e641;
                    phi_1605_ = SlimbvhTypeE(0u, ((_e812 >> bitcast<u32>(28u)) & 7u));
                    loop {
                        let _e818 = phi_1602_;
                        let _e820 = phi_1605_;
                        local_4 = _e818;
                        local_7 = _e818;
                        if (_e820.member < _e820.member_1) {
                            phi_1606_ = SlimbvhTypeE((_e820.member + 1u), _e820.member_1);
                            phi_1628_ = SlimbvhTypeE(1u, _e820.member);
                        } else {
                            phi_1606_ = _e820;
                            phi_1628_ = SlimbvhTypeE(0u, SlimbvhTypeE().member_1);
                        }
                        let _e833 = phi_1606_;
                        let _e835 = phi_1628_;
                        let _e839 = (bitcast<i32>(_e835.member) != 0i);
                        if _e839 {
                            let _e840 = ((_e809 & 268435455u) + _e835.member_1);
                            let _e841 = (_e840 / 2u);
                            let _e842 = (_e840 % 2u);
                            let _e843 = (_e841 >= arrayLength((&slimbvh_triangles.member)));
                            if _e843 {
                                phi_1708_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e844 = (2u * _e842);
                                let _e848 = slimbvh_triangles.member[_e841][_e844];
                                let _e853 = slimbvh_triangles.member[_e841][(_e844 + 1u)];
                                let _e858 = slimbvh_triangles.member[_e841][(_e844 + 2u)];
                                if (_e842 == 0u) {
                                    phi_1707_ = array<vec4<f32>, 3>(_e848, _e853, _e858);
                                } else {
                                    phi_1707_ = array<vec4<f32>, 3>(vec4<f32>(_e848.z, _e848.w, _e853.x, _e853.y), vec4<f32>(_e853.z, _e853.w, _e858.x, _e858.y), vec4<f32>(_e858.z, _e858.w, 0f, 0f));
                                }
                                let _e876 = phi_1707_;
                                phi_1708_ = _e876;
                            }
                            let _e878 = phi_1708_;
                            let _e881 = bitcast<u32>(_e878[2].y);
                            if _e843 {
                                phi_1783_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e882 = (2u * _e842);
                                let _e886 = slimbvh_triangles.member[_e841][_e882];
                                let _e891 = slimbvh_triangles.member[_e841][(_e882 + 1u)];
                                let _e896 = slimbvh_triangles.member[_e841][(_e882 + 2u)];
                                if (_e842 == 0u) {
                                    phi_1782_ = array<vec4<f32>, 3>(_e886, _e891, _e896);
                                } else {
                                    phi_1782_ = array<vec4<f32>, 3>(vec4<f32>(_e886.z, _e886.w, _e891.x, _e891.y), vec4<f32>(_e891.z, _e891.w, _e896.x, _e896.y), vec4<f32>(_e896.z, _e896.w, 0f, 0f));
                                }
                                let _e914 = phi_1782_;
                                phi_1783_ = _e914;
                            }
                            let _e916 = phi_1783_;
                            if _e165 {
                                phi_1807_ = array<f32, 3>(_e916[0].x, _e916[0].y, _e916[0].z);
                            } else {
                                if (_e160 == 1u) {
                                    phi_1806_ = array<f32, 3>(_e916[0].y, _e916[0].z, _e916[0].x);
                                } else {
                                    phi_1806_ = array<f32, 3>(_e916[0].z, _e916[0].x, _e916[0].y);
                                }
                                let _e939 = phi_1806_;
                                phi_1807_ = _e939;
                            }
                            let _e942 = phi_1807_;
                            if _e165 {
                                phi_1822_ = array<f32, 3>(_e916[0].w, _e916[1].x, _e916[1].y);
                            } else {
                                if (_e160 == 1u) {
                                    phi_1821_ = array<f32, 3>(_e916[1].x, _e916[1].y, _e916[0].w);
                                } else {
                                    phi_1821_ = array<f32, 3>(_e916[1].y, _e916[0].w, _e916[1].x);
                                }
                                let _e947 = phi_1821_;
                                phi_1822_ = _e947;
                            }
                            let _e950 = phi_1822_;
                            if _e165 {
                                phi_1837_ = array<f32, 3>(_e916[1].z, _e916[1].w, _e916[2].x);
                            } else {
                                if (_e160 == 1u) {
                                    phi_1836_ = array<f32, 3>(_e916[1].w, _e916[2].x, _e916[1].z);
                                } else {
                                    phi_1836_ = array<f32, 3>(_e916[2].x, _e916[1].z, _e916[1].w);
                                }
                                let _e955 = phi_1836_;
                                phi_1837_ = _e955;
                            }
                            let _e958 = phi_1837_;
                            let _e972 = (_e942[2] - _e548.member[2]);
                            let _e975 = (((_e942[0] - _e548.member[0]) * _e603) - (_e972 * _e571));
                            let _e978 = (((_e942[1] - _e548.member[1]) * _e603) - (_e972 * _e587));
                            let _e981 = (_e950[2] - _e548.member[2]);
                            let _e984 = (((_e950[0] - _e548.member[0]) * _e603) - (_e981 * _e571));
                            let _e987 = (((_e950[1] - _e548.member[1]) * _e603) - (_e981 * _e587));
                            let _e990 = (_e958[2] - _e548.member[2]);
                            let _e993 = (((_e958[0] - _e548.member[0]) * _e603) - (_e990 * _e571));
                            let _e996 = (((_e958[1] - _e548.member[1]) * _e603) - (_e990 * _e587));
                            let _e997 = (_e993 * _e987);
                            let _e998 = (_e996 * _e984);
                            let _e999 = (_e975 * _e996);
                            let _e1000 = (_e978 * _e993);
                            let _e1001 = (_e984 * _e978);
                            let _e1002 = (_e987 * _e975);
                            let _e1007 = (((_e997 >= _e998) && (_e999 >= _e1000)) && (_e1001 >= _e1002));
                            let _e1013 = (_e1007 || (((_e997 <= _e998) && (_e999 <= _e1000)) && (_e1001 <= _e1002)));
                            if _e1013 {
                                let _e1015 = select(-1f, 1f, _e1007);
                                let _e1017 = ((_e997 - _e998) * _e1015);
                                let _e1019 = select(0f, _e1017, (_e1017 > 0f));
                                let _e1021 = ((_e999 - _e1000) * _e1015);
                                let _e1023 = select(0f, _e1021, (_e1021 > 0f));
                                let _e1025 = ((_e1001 - _e1002) * _e1015);
                                let _e1027 = select(0f, _e1025, (_e1025 > 0f));
                                let _e1029 = ((_e1019 + _e1023) + _e1027);
                                let _e1044 = ((min(min(_e942[0], _e950[0]), _e958[0]) - _e572) * _e575);
                                let _e1045 = ((max(max(_e942[0], _e950[0]), _e958[0]) - _e573) * _e575);
                                let _e1046 = vec4<f32>(_e1044, f32(), _e1045, f32());
                                let _e1049 = ((min(min(_e942[1], _e950[1]), _e958[1]) - _e588) * _e591);
                                let _e1050 = ((max(max(_e942[1], _e950[1]), _e958[1]) - _e589) * _e591);
                                let _e1051 = vec4<f32>(_e1049, f32(), _e1050, f32());
                                let _e1054 = ((min(min(_e942[2], _e950[2]), _e958[2]) - _e604) * _e607);
                                let _e1055 = ((max(max(_e942[2], _e950[2]), _e958[2]) - _e605) * _e607);
                                let _e1056 = vec4<f32>(_e1054, f32(), _e1055, f32());
                                let _e1057 = vec4<f32>(_e1045, f32(), _e1044, f32());
                                let _e1059 = vec4<f32>(_e1050, f32(), _e1049, f32());
                                let _e1061 = vec4<f32>(_e1055, f32(), _e1054, f32());
                                let _e1070 = max(max(min(_e1046, _e1057).x, min(_e1051, _e1059).x), min(_e1056, _e1061).x);
                                let _e1075 = min(min(max(_e1046, _e1057).x, max(_e1051, _e1059).x), max(_e1056, _e1061).x);
                                let _e1080 = max(_e1070, _e615);
                                let _e1102 = (((((_e1013 && (_e1029 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e975, _e984), _e993) <= 0f) && (max(max(_e975, _e984), _e993) >= 0f))) && ((min(min(_e978, _e987), _e996) <= 0f) && (max(max(_e978, _e987), _e996) >= 0f))) && (_e1080 <= (_e1075 + (max(max(_e1056, _e1061).x, -(min(_e1056, _e1061).x)) * 0.0000019073523f)))) && (_e1080 <= _e818.member.member_1));
                                if _e1102 {
                                    let _e1107 = (_e950[0] - _e942[0]);
                                    let _e1108 = (_e950[1] - _e942[1]);
                                    let _e1109 = (_e950[2] - _e942[2]);
                                    let _e1110 = vec3<f32>(_e1107, _e1108, _e1109);
                                    let _e1111 = (_e958[0] - _e950[0]);
                                    let _e1112 = (_e958[1] - _e950[1]);
                                    let _e1113 = (_e958[2] - _e950[2]);
                                    let _e1114 = vec3<f32>(_e1111, _e1112, _e1113);
                                    let _e1115 = (_e942[0] - _e958[0]);
                                    let _e1116 = (_e942[1] - _e958[1]);
                                    let _e1117 = (_e942[2] - _e958[2]);
                                    let _e1118 = vec3<f32>(_e1115, _e1116, _e1117);
                                    let _e1129 = max(max(bitcast<f32>((bitcast<u32>(_e1107) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1108) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1109) & 2147483647u)));
                                    let _e1140 = max(max(bitcast<f32>((bitcast<u32>(_e1111) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1112) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1113) & 2147483647u)));
                                    let _e1153 = max(max(_e1129, _e1140), max(max(bitcast<f32>((bitcast<u32>(_e1115) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1116) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1117) & 2147483647u))));
                                    if (_e1129 == _e1153) {
                                        phi_2170_ = _e987;
                                        phi_2171_ = _e984;
                                        phi_2172_ = _e978;
                                        phi_2173_ = _e975;
                                        phi_2174_ = vec3<f32>(_e942[0], _e942[1], _e942[2]);
                                        phi_2175_ = _e1118;
                                        phi_2176_ = _e1114;
                                        phi_2177_ = _e1110;
                                    } else {
                                        let _e1155 = (_e1140 == _e1153);
                                        let _e1160 = vec3(_e1155);
                                        phi_2170_ = select(_e978, _e996, _e1155);
                                        phi_2171_ = select(_e975, _e993, _e1155);
                                        phi_2172_ = select(_e996, _e987, _e1155);
                                        phi_2173_ = select(_e993, _e984, _e1155);
                                        phi_2174_ = select(vec3<f32>(_e958[0], _e958[1], _e958[2]), vec3<f32>(_e950[0], _e950[1], _e950[2]), _e1160);
                                        phi_2175_ = select(_e1114, _e1110, _e1160);
                                        phi_2176_ = select(_e1110, _e1118, _e1160);
                                        phi_2177_ = select(_e1118, _e1114, _e1160);
                                    }
                                    let _e1166 = phi_2170_;
                                    let _e1168 = phi_2171_;
                                    let _e1170 = phi_2172_;
                                    let _e1172 = phi_2173_;
                                    let _e1174 = phi_2174_;
                                    let _e1176 = phi_2175_;
                                    let _e1178 = phi_2176_;
                                    let _e1180 = phi_2177_;
                                    let _e1187 = ((_e1178.y * _e1176.z) - (_e1176.y * _e1178.z));
                                    let _e1192 = ((_e1178.z * _e1176.x) - (_e1176.z * _e1178.x));
                                    let _e1195 = ((_e1178.x * _e1176.y) - (_e1176.x * _e1178.y));
                                    let _e1198 = ((_e1019 >= _e1023) && (_e1019 >= _e1027));
                                    let _e1199 = (_e1023 >= _e1027);
                                    let _e1213 = (((_e1187 * (select(select(_e958[0], _e950[0], _e1199), _e942[0], _e1198) - _e548.member[0])) + (_e1192 * (select(select(_e958[1], _e950[1], _e1199), _e942[1], _e1198) - _e548.member[1]))) + (_e1195 * (select(select(_e958[2], _e950[2], _e1199), _e942[2], _e1198) - _e548.member[2])));
                                    let _e1218 = (((_e1187 * _e571) + (_e1192 * _e587)) + (_e1195 * _e603));
                                    let _e1219 = (_e1168 - _e1172);
                                    let _e1220 = (_e1166 - _e1170);
                                    let _e1223 = ((_e1219 * _e1219) + (_e1220 * _e1220));
                                    let _e1230 = (-(((_e1172 * _e1219) + (_e1170 * _e1220))) / select(0.000000000000000000000000000000000000011754944f, _e1223, (_e1223 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e1232 = select(1f, _e1230, (_e1230 < 1f));
                                    let _e1234 = select(0f, _e1232, (_e1232 > 0f));
                                    let _e1243 = ((_e1174.x + (_e1180.x * _e1234)) - _e548.member[0]);
                                    let _e1246 = ((_e1174.y + (_e1180.y * _e1234)) - _e548.member[1]);
                                    let _e1249 = ((_e1174.z + (_e1180.z * _e1234)) - _e548.member[2]);
                                    let _e1314 = ((bitcast<f32>((bitcast<u32>(((((_e1187 * _e1243) + (_e1192 * _e1246)) + (_e1195 * _e1249)) - _e1213)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1243) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1246) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1249) & 2147483647u))), _e1153)) * max(max(bitcast<f32>((bitcast<u32>(_e1187) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1192) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1195) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1218) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1178.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1178.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1178.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1176.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1176.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1176.z) & 2147483647u)))))));
                                    let _e1315 = (_e1213 / _e1218);
                                    if (_e1102 && !(_e1314)) {
                                        let _e1318 = (_e1249 / _e603);
                                        let _e1326 = (((_e1187 * (_e1243 - (_e571 * _e1318))) + (_e1192 * (_e1246 - (_e587 * _e1318)))) / _e1218);
                                        phi_2356_ = select(select(_e1318, (_e1318 + _e1326), (bitcast<f32>((bitcast<u32>(_e1326) & 2147483647u)) <= _e1153)), _e1315, _e1314);
                                    } else {
                                        phi_2356_ = _e1315;
                                    }
                                    let _e1335 = phi_2356_;
                                    let _e1337 = select(_e1075, _e1335, (_e1335 < _e1075));
                                    let _e1339 = select(_e1070, _e1337, (_e1337 > _e1070));
                                    let _e1342 = select(_e1339, 0f, (bitcast<u32>(_e1339) == 2147483648u));
                                    let _e1343 = (1f / _e1029);
                                    phi_2382_ = SlimbvhTypeF(_e1342, (_e1023 * _e1343), (_e1027 * _e1343), ((_e1102 && (_e1342 >= _e615)) && (_e1342 <= _e818.member.member_1)));
                                    phi_2383_ = SlimbvhTypeF();
                                } else {
                                    phi_2382_ = SlimbvhTypeF();
                                    phi_2383_ = SlimbvhTypeF(0f, 0f, 0f, _e1102);
                                }
                                let _e1352 = phi_2382_;
                                let _e1354 = phi_2383_;
                                phi_2386_ = _e1352;
                                phi_2387_ = _e1354;
                                phi_2388_ = select(true, false, _e1102);
                            } else {
                                phi_2386_ = SlimbvhTypeF();
                                phi_2387_ = SlimbvhTypeF(0f, 0f, 0f, _e1013);
                                phi_2388_ = true;
                            }
                            let _e1357 = phi_2386_;
                            let _e1359 = phi_2387_;
                            let _e1361 = phi_2388_;
                            if _e1361 {
                                phi_2392_ = _e1359;
                            } else {
                                phi_2392_ = _e1357;
                            }
                            let _e1363 = phi_2392_;
                            if _e1363.member_3 {
                                phi_2401_ = SlimbvhTypeG(_e1363.member, _e1363.member_1, _e1363.member_2, _e881);
                            } else {
                                phi_2401_ = _e87;
                            }
                            let _e1370 = phi_2401_;
                            if (_e1370.member_3 != 4294967295u) {
                                let _e1376 = slimbvh_target.member[0u][0u];
                                let _e1380 = slimbvh_target.member[0u][1u];
                                let _e1384 = slimbvh_target.member[0u][2u];
                                let _e1388 = slimbvh_target.member[0u][3u];
                                let _e1392 = slimbvh_target.member[1u][0u];
                                let _e1396 = slimbvh_target.member[1u][1u];
                                let _e1400 = slimbvh_target.member[1u][2u];
                                let _e1404 = slimbvh_target.member[1u][3u];
                                let _e1405 = bitcast<f32>(_e1376);
                                let _e1406 = bitcast<f32>(_e1380);
                                let _e1407 = bitcast<f32>(_e1384);
                                let _e1409 = bitcast<f32>(_e1392);
                                let _e1410 = array<u32, 3>(_e1396, _e1400, _e1404);
                                if (_e118 < -126i) {
                                    phi_2448_ = -126i;
                                } else {
                                    phi_2448_ = select(_e118, 127i, (_e118 > 127i));
                                }
                                let _e1416 = phi_2448_;
                                let _e1421 = bitcast<f32>((bitcast<u32>((_e1416 + 127i)) << bitcast<u32>(23i)));
                                let _e1427 = bitcast<f32>((bitcast<u32>(((_e118 - _e1416) + 127i)) << bitcast<u32>(23i)));
                                if (_e1388 == 0u) {
                                    phi_2588_ = SlimbvhTypeI(array<f32, 3>(_e1405, _e1406, _e1407), _e1388, _e1409, _e1410);
                                } else {
                                    let _e1429 = bitcast<u32>(_e1405);
                                    let _e1431 = ((_e1429 & 2139095040u) != 0u);
                                    let _e1446 = bitcast<u32>(_e1406);
                                    let _e1448 = ((_e1446 & 2139095040u) != 0u);
                                    let _e1463 = bitcast<u32>(_e1407);
                                    let _e1465 = ((_e1463 & 2139095040u) != 0u);
                                    let _e1481 = bitcast<u32>(_e1409);
                                    let _e1483 = ((_e1481 & 2139095040u) != 0u);
                                    phi_2588_ = SlimbvhTypeI(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1429 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1429 & 2147483648u))), _e1405, _e1431) * _e1421) * select(0.00000011920929f, 1f, _e1431)) * _e1427), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1446 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1446 & 2147483648u))), _e1406, _e1448) * _e1421) * select(0.00000011920929f, 1f, _e1448)) * _e1427), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1463 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1463 & 2147483648u))), _e1407, _e1465) * _e1421) * select(0.00000011920929f, 1f, _e1465)) * _e1427)), _e1388, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1481 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1481 & 2147483648u))), _e1409, _e1483) * _e1421) * select(0.00000011920929f, 1f, _e1483)) * _e1427), _e1410);
                                }
                                let _e1500 = phi_2588_;
                                if (_e881 == _e619) {
                                    phi_2914_ = false;
                                } else {
                                    let _e1502 = (_e881 / 16u);
                                    if (_e1502 < arrayLength((&slimbvh_sides.member))) {
                                        let _e1505 = slimbvh_sides.member[_e1502];
                                        phi_2612_ = _e1505;
                                    } else {
                                        phi_2612_ = 0u;
                                    }
                                    let _e1507 = phi_2612_;
                                    let _e1516 = (bitcast<i32>((_e1507 << bitcast<u32>(((30u - ((_e881 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                    let _e1517 = (_e1516 == 0i);
                                    if _e1517 {
                                        phi_2913_ = true;
                                    } else {
                                        if _e165 {
                                            phi_2641_ = vec3<f32>(_e942[0], _e942[1], _e942[2]);
                                        } else {
                                            if (_e160 == 1u) {
                                                phi_2640_ = vec3<f32>(_e942[2], _e942[0], _e942[1]);
                                            } else {
                                                phi_2640_ = vec3<f32>(_e942[1], _e942[2], _e942[0]);
                                            }
                                            let _e1522 = phi_2640_;
                                            phi_2641_ = _e1522;
                                        }
                                        let _e1525 = phi_2641_;
                                        if _e165 {
                                            phi_2659_ = vec3<f32>(_e950[0], _e950[1], _e950[2]);
                                        } else {
                                            if (_e160 == 1u) {
                                                phi_2658_ = vec3<f32>(_e950[2], _e950[0], _e950[1]);
                                            } else {
                                                phi_2658_ = vec3<f32>(_e950[1], _e950[2], _e950[0]);
                                            }
                                            let _e1530 = phi_2658_;
                                            phi_2659_ = _e1530;
                                        }
                                        let _e1533 = phi_2659_;
                                        if _e165 {
                                            phi_2677_ = vec3<f32>(_e958[0], _e958[1], _e958[2]);
                                        } else {
                                            if (_e160 == 1u) {
                                                phi_2676_ = vec3<f32>(_e958[2], _e958[0], _e958[1]);
                                            } else {
                                                phi_2676_ = vec3<f32>(_e958[1], _e958[2], _e958[0]);
                                            }
                                            let _e1538 = phi_2676_;
                                            phi_2677_ = _e1538;
                                        }
                                        let _e1541 = phi_2677_;
                                        let _e1544 = (_e1533.x - _e1525.x);
                                        let _e1547 = (_e1533.y - _e1525.y);
                                        let _e1550 = (_e1533.z - _e1525.z);
                                        let _e1552 = (_e1541.x - _e1525.x);
                                        let _e1554 = (_e1541.y - _e1525.y);
                                        let _e1556 = (_e1541.z - _e1525.z);
                                        if (_e1500.member_1 == 1u) {
                                            phi_2713_ = (vec3<f32>(_e1500.member[0], _e1500.member[1], _e1500.member[2]) - _e1525);
                                        } else {
                                            phi_2713_ = vec3<f32>(_e1500.member[0], _e1500.member[1], _e1500.member[2]);
                                        }
                                        let _e1571 = phi_2713_;
                                        let _e1577 = bitcast<f32>((bitcast<u32>((_e1544 * _e1554)) ^ _e1500.member_3[0]));
                                        let _e1581 = bitcast<f32>((bitcast<u32>((_e1547 * _e1552)) ^ _e1500.member_3[0]));
                                        let _e1585 = bitcast<f32>((bitcast<u32>((_e1547 * _e1556)) ^ _e1500.member_3[0]));
                                        let _e1589 = bitcast<f32>((bitcast<u32>((_e1550 * _e1554)) ^ _e1500.member_3[0]));
                                        let _e1593 = bitcast<f32>((bitcast<u32>((_e1550 * _e1552)) ^ _e1500.member_3[0]));
                                        let _e1597 = bitcast<f32>((bitcast<u32>((_e1544 * _e1556)) ^ _e1500.member_3[0]));
                                        let _e1598 = (_e1585 - _e1589);
                                        let _e1599 = (_e1593 - _e1597);
                                        let _e1600 = (_e1577 - _e1581);
                                        let _e1624 = (bitcast<f32>((bitcast<u32>(_e1585) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1589) & 2147483647u)));
                                        let _e1631 = (bitcast<f32>((bitcast<u32>(_e1593) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1597) & 2147483647u)));
                                        let _e1638 = (bitcast<f32>((bitcast<u32>(_e1577) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1581) & 2147483647u)));
                                        if (_e1500.member_2 == 0f) {
                                            phi_2895_ = 0f;
                                        } else {
                                            let _e1668 = bitcast<f32>((bitcast<u32>(_e1598) & 2147483647u));
                                            let _e1671 = bitcast<f32>((bitcast<u32>(_e1599) & 2147483647u));
                                            let _e1674 = bitcast<f32>((bitcast<u32>(_e1600) & 2147483647u));
                                            let _e1676 = select(_e1674, _e1671, (_e1671 > _e1674));
                                            let _e1680 = select(_e1674, _e1671, (_e1671 < _e1674));
                                            let _e1684 = select(_e1671, _e1668, (_e1668 < _e1671));
                                            let _e1686 = select(_e1671, _e1668, (_e1668 > _e1671));
                                            let _e1688 = select(_e1674, _e1686, (_e1686 < _e1674));
                                            phi_2895_ = bitcast<f32>((bitcast<u32>((_e1500.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1676, _e1668, (_e1668 > _e1676)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1688, _e1684, (_e1684 > _e1688)))) ^ _e1500.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1680, _e1668, (_e1668 < _e1680)))) ^ _e1500.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1624 + _e1631) + _e1638))) ^ _e1500.member_3[0]))) * 1.0000005f)) ^ _e1500.member_3[0])))) ^ _e1500.member_3[0]));
                                        }
                                        let _e1715 = phi_2895_;
                                        phi_2913_ = (_e1517 || !(((((bitcast<f32>((bitcast<u32>((_e1571.x * _e1598)) ^ _e1500.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1571.y * _e1599)) ^ _e1500.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1571.z * _e1600)) ^ _e1500.member_3[0]))) * f32(-(_e1516))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1571.x) & 2147483647u)) * _e1624)) ^ _e1500.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1571.y) & 2147483647u)) * _e1631)) ^ _e1500.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1571.z) & 2147483647u)) * _e1638)) ^ _e1500.member_3[0]))))) ^ _e1500.member_3[0])) + _e1715) + 0.0000000000000000000000000000000000001880791f))));
                                    }
                                    let _e1729 = phi_2913_;
                                    phi_2914_ = _e1729;
                                }
                                let _e1731 = phi_2914_;
                                if _e1731 {
                                    if (_e1370.member < _e818.member.member.member) {
                                        phi_2934_ = true;
                                    } else {
                                        if (_e1370.member == _e818.member.member.member) {
                                            phi_2933_ = (_e1370.member_3 < _e818.member.member.member_3);
                                        } else {
                                            phi_2933_ = false;
                                        }
                                        let _e1743 = phi_2933_;
                                        phi_2934_ = _e1743;
                                    }
                                    let _e1745 = phi_2934_;
                                    if _e1745 {
                                        phi_2941_ = SlimbvhTypeN(SlimbvhTypeJ(_e1370, _e1370.member), _e818.member_1);
                                    } else {
                                        phi_2941_ = _e818;
                                    }
                                    let _e1751 = phi_2941_;
                                    if _e1751.member_1 {
                                        phi_2947_ = SlimbvhTypeN(SlimbvhTypeJ(_e1751.member.member, bitcast<f32>(4286578687u)), _e1751.member_1);
                                    } else {
                                        phi_2947_ = _e1751;
                                    }
                                    let _e1760 = phi_2947_;
                                    phi_2948_ = _e1760;
                                } else {
                                    phi_2948_ = _e818;
                                }
                                let _e1762 = phi_2948_;
                                phi_2949_ = _e1762;
                            } else {
                                phi_2949_ = _e818;
                            }
                            let _e1764 = phi_2949_;
                            phi_1603_ = _e1764;
                        } else {
                            phi_1603_ = SlimbvhTypeN();
                        }
                        let _e1766 = phi_1603_;
                        continue;
                        continuing {
                            phi_1602_ = _e1766;
                            phi_1605_ = _e833;
                            break if !(_e839);
                        }
                    }
                    let _e1769 = local_3;
                    let _e1770 = (_e1769 - 1u);
                    let _e1775 = slimbvh_stacks[(((_e1770 % 32u) * 64u) + _e622)];
                    let _e1777 = local_4;
                    let _e2040 = local_7;
                    phi_2971_ = _e2040;
                    phi_2972_ = select(_e1770, 4294967295u, (_e615 > _e1777.member.member_1));
                    phi_2973_ = _e1775;
                } else {
                    phi_2971_ = _e641;
                    let _e2043 = local_8;
                    phi_2972_ = _e2043;
                    let _e2046 = local_9;
                    phi_2973_ = _e2046;
                }
                let _e1783 = phi_2971_;
                let _e1785 = phi_2972_;
                let _e1787 = phi_2973_;
                phi_1285_ = _e1783;
                phi_1288_ = _e1785;
                phi_1290_ = _e1787;
                let _e2052 = local_10;
                phi_1292_ = _e2052;
            } else {
                phi_1285_ = SlimbvhTypeN();
                phi_1288_ = u32();
                phi_1290_ = u32();
                phi_1292_ = u32();
            }
            let _e1789 = phi_1285_;
            let _e1791 = phi_1288_;
            let _e1793 = phi_1290_;
            let _e1795 = phi_1292_;
            continue;
            continuing {
                phi_1284_ = _e1789;
                phi_1287_ = _e1791;
                phi_1289_ = _e1793;
                phi_1291_ = _e1795;
                break if !(_e648);
            }
        }
        let _e1798 = local_5;
        let _e1799 = (_e1798 == 4294967295u);
        let _e1801 = local_6;
        if (_e1801.member.member.member_3 != 4294967295u) {
            let _e1807 = -((_e118 + _e548.member_4));
            let _e1808 = bitcast<u32>(_e1801.member.member.member);
            let _e1812 = (bitcast<i32>((_e1808 >> bitcast<u32>(23i))) & 255i);
            let _e1813 = (_e1812 + _e1807);
            if (_e1812 == 255i) {
                phi_3029_ = _e1801.member.member.member;
            } else {
                if (_e1812 > 0i) {
                    if (_e1813 > 0i) {
                        let _e1817 = (_e1813 < 255i);
                        if _e1817 {
                            phi_3008_ = bitcast<f32>((_e1808 + bitcast<u32>((_e1807 << bitcast<u32>(23i)))));
                        } else {
                            phi_3008_ = f32();
                        }
                        let _e1824 = phi_3008_;
                        phi_3010_ = _e1824;
                        phi_3011_ = select(true, false, _e1817);
                    } else {
                        phi_3010_ = f32();
                        phi_3011_ = true;
                    }
                    let _e1827 = phi_3010_;
                    let _e1829 = phi_3011_;
                    phi_3012_ = _e1827;
                    phi_3013_ = _e1829;
                } else {
                    phi_3012_ = f32();
                    phi_3013_ = true;
                }
                let _e1831 = phi_3012_;
                let _e1833 = phi_3013_;
                if _e1833 {
                    let _e1834 = (_e1808 & 2147483648u);
                    let _e1841 = ((_e1808 & 8388607u) | (select(0u, 1u, ((_e1808 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e1845 = (_e1841 == 0u);
                    if _e1845 {
                        phi_3466_ = bitcast<f32>(_e1834);
                    } else {
                        let _e1850 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1841)), 32u, _e1845) - 8u);
                        let _e1853 = (_e1841 << bitcast<u32>((_e1850 & 31u)));
                        let _e1855 = ((_e1813 + select(0i, 1i, (_e1812 == 0i))) - bitcast<i32>(_e1850));
                        if (_e1855 >= 255i) {
                            phi_3456_ = bitcast<f32>((_e1834 | 2139095040u));
                            phi_3457_ = f32();
                            phi_3458_ = true;
                        } else {
                            let _e1857 = (_e1855 > 0i);
                            if _e1857 {
                                phi_3450_ = bitcast<f32>(((_e1834 | (bitcast<u32>(_e1855) << bitcast<u32>(23i))) | (_e1853 & 8388607u)));
                                phi_3451_ = f32();
                            } else {
                                if (_e1855 < -24i) {
                                    phi_3416_ = 26u;
                                } else {
                                    phi_3416_ = bitcast<u32>((1i - _e1855));
                                }
                                let _e1862 = phi_3416_;
                                let _e1863 = (_e1862 & 31u);
                                let _e1865 = (_e1853 >> bitcast<u32>(_e1863));
                                let _e1869 = (_e1853 & ((1u << bitcast<u32>(_e1863)) - 1u));
                                let _e1873 = (1u << bitcast<u32>(((_e1862 - 1u) & 31u)));
                                if (_e1869 > _e1873) {
                                    phi_3437_ = true;
                                } else {
                                    if (_e1869 == _e1873) {
                                        phi_3434_ = ((_e1865 & 1u) == 1u);
                                    } else {
                                        phi_3434_ = false;
                                    }
                                    let _e1879 = phi_3434_;
                                    phi_3437_ = _e1879;
                                }
                                let _e1881 = phi_3437_;
                                phi_3450_ = f32();
                                phi_3451_ = bitcast<f32>((_e1834 | (_e1865 + select(0u, 1u, _e1881))));
                            }
                            let _e1894 = phi_3450_;
                            let _e1896 = phi_3451_;
                            phi_3456_ = _e1894;
                            phi_3457_ = _e1896;
                            phi_3458_ = _e1857;
                        }
                        let _e1900 = phi_3456_;
                        let _e1902 = phi_3457_;
                        let _e1904 = phi_3458_;
                        phi_3466_ = select(_e1902, _e1900, _e1904);
                    }
                    let _e1908 = phi_3466_;
                    phi_3028_ = _e1908;
                } else {
                    phi_3028_ = _e1831;
                }
                let _e1910 = phi_3028_;
                phi_3029_ = _e1910;
            }
            let _e1912 = phi_3029_;
            let _e1913 = bitcast<u32>(_e1912);
            if ((_e1913 & 2147483647u) >= 2139095040u) {
                phi_3041_ = bitcast<f32>(((_e1913 & 2147483648u) | 2139095039u));
            } else {
                phi_3041_ = _e1912;
            }
            let _e1920 = phi_3041_;
            phi_3046_ = SlimbvhTypeG(_e1920, _e1801.member.member.member_1, _e1801.member.member.member_2, _e1801.member.member.member_3);
        } else {
            phi_3046_ = _e87;
        }
        let _e1925 = phi_3046_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1925.member), bitcast<u32>(_e1925.member_1), bitcast<u32>(_e1925.member_2), _e1925.member_3);
        phi_3059_ = _e1799;
        phi_3060_ = _e1799;
        phi_3061_ = select(true, false, _e1799);
    } else {
        phi_3059_ = bool();
        phi_3060_ = false;
        phi_3061_ = true;
    }
    let _e1936 = phi_3059_;
    let _e1938 = phi_3060_;
    let _e1940 = phi_3061_;
    if _e1940 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e1936, _e1938, _e1940)));
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
