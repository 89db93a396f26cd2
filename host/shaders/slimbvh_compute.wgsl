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
    var phi_446_: u32;
    var phi_452_: u32;
    var phi_458_: u32;
    var phi_723_: i32;
    var phi_734_: i32;
    var phi_848_: i32;
    var phi_977_: i32;
    var phi_999_: u32;
    var phi_1000_: u32;
    var phi_1001_: bool;
    var phi_1035_: i32;
    var phi_1057_: u32;
    var phi_1058_: u32;
    var phi_1059_: bool;
    var phi_620_: i32;
    var phi_626_: u32;
    var phi_645_: u32;
    var phi_646_: u32;
    var phi_647_: bool;
    var phi_665_: i32;
    var phi_671_: u32;
    var phi_690_: u32;
    var phi_691_: u32;
    var phi_692_: bool;
    var phi_1069_: SlimbvhTypeD;
    var phi_1281_: SlimbvhTypeN;
    var phi_1297_: SlimbvhTypeN;
    var phi_1300_: u32;
    var phi_1302_: u32;
    var phi_1304_: u32;
    var phi_1313_: u32;
    var phi_1316_: u32;
    var phi_1318_: u32;
    var phi_1596_: u32;
    var phi_1612_: u32;
    var phi_1613_: u32;
    var phi_1314_: u32;
    var phi_1317_: u32;
    var phi_1319_: u32;
    var local: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_1630_: SlimbvhTypeN;
    var phi_1633_: SlimbvhTypeE;
    var phi_1634_: SlimbvhTypeE;
    var phi_1656_: SlimbvhTypeE;
    var phi_1735_: array<vec4<f32>, 3>;
    var phi_1736_: array<vec4<f32>, 3>;
    var phi_1810_: array<vec4<f32>, 3>;
    var phi_1811_: array<vec4<f32>, 3>;
    var phi_1834_: array<f32, 3>;
    var phi_1835_: array<f32, 3>;
    var phi_1849_: array<f32, 3>;
    var phi_1850_: array<f32, 3>;
    var phi_1864_: array<f32, 3>;
    var phi_1865_: array<f32, 3>;
    var phi_2198_: f32;
    var phi_2199_: f32;
    var phi_2200_: f32;
    var phi_2201_: f32;
    var phi_2202_: vec3<f32>;
    var phi_2203_: vec3<f32>;
    var phi_2204_: vec3<f32>;
    var phi_2205_: vec3<f32>;
    var phi_2384_: f32;
    var phi_2410_: SlimbvhTypeF;
    var phi_2411_: SlimbvhTypeF;
    var phi_2414_: SlimbvhTypeF;
    var phi_2415_: SlimbvhTypeF;
    var phi_2416_: bool;
    var phi_2420_: SlimbvhTypeF;
    var phi_2429_: SlimbvhTypeG;
    var phi_2476_: i32;
    var phi_2616_: SlimbvhTypeI;
    var phi_2640_: u32;
    var phi_2668_: vec3<f32>;
    var phi_2669_: vec3<f32>;
    var phi_2686_: vec3<f32>;
    var phi_2687_: vec3<f32>;
    var phi_2704_: vec3<f32>;
    var phi_2705_: vec3<f32>;
    var phi_2741_: vec3<f32>;
    var phi_2923_: f32;
    var phi_2941_: bool;
    var phi_2942_: bool;
    var phi_2961_: bool;
    var phi_2962_: bool;
    var phi_2969_: SlimbvhTypeN;
    var phi_2975_: SlimbvhTypeN;
    var phi_2976_: SlimbvhTypeN;
    var phi_2977_: SlimbvhTypeN;
    var phi_1631_: SlimbvhTypeN;
    var local_3: u32;
    var local_4: SlimbvhTypeN;
    var phi_2999_: SlimbvhTypeN;
    var phi_3000_: u32;
    var phi_3001_: u32;
    var phi_1298_: SlimbvhTypeN;
    var phi_1301_: u32;
    var phi_1303_: u32;
    var phi_1305_: u32;
    var local_5: u32;
    var local_6: SlimbvhTypeN;
    var phi_3036_: f32;
    var phi_3038_: f32;
    var phi_3039_: bool;
    var phi_3040_: f32;
    var phi_3041_: bool;
    var phi_3444_: u32;
    var phi_3462_: bool;
    var phi_3465_: bool;
    var phi_3478_: f32;
    var phi_3479_: f32;
    var phi_3484_: f32;
    var phi_3485_: f32;
    var phi_3486_: bool;
    var phi_3494_: f32;
    var phi_3056_: f32;
    var phi_3057_: f32;
    var phi_3069_: f32;
    var phi_3074_: SlimbvhTypeG;
    var phi_3087_: bool;
    var phi_3088_: bool;
    var phi_3089_: bool;
    var local_7: SlimbvhTypeN;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e87 = SlimbvhTypeG(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e91 = arrayLength((&slimbvh_nodes.member));
    let _e104 = slimbvh_exponent.member[1u];
    let _e107 = slimbvh_exponent.member[2u];
    let _e108 = slimbvh_origin.member;
    let _e114 = slimbvh_origin.member[3u];
    let _e115 = slimbvh_direction.member;
    let _e121 = slimbvh_direction.member[3u];
    let _e124 = slimbvh_exponent.member[0u];
    let _e125 = bitcast<i32>(_e124);
    let _e127 = (bitcast<u32>(_e108.x) & 2147483647u);
    let _e129 = (bitcast<u32>(_e108.y) & 2147483647u);
    let _e131 = (bitcast<u32>(_e108.z) & 2147483647u);
    let _e132 = bitcast<u32>(_e114);
    let _e133 = (_e132 & 2147483647u);
    let _e135 = (bitcast<u32>(_e115.x) & 2147483647u);
    let _e137 = (bitcast<u32>(_e115.y) & 2147483647u);
    let _e139 = (bitcast<u32>(_e115.z) & 2147483647u);
    let _e140 = bitcast<u32>(_e121);
    let _e141 = (_e140 & 2147483647u);
    let _e143 = select(_e137, _e135, (_e137 < _e135));
    let _e145 = select(_e139, _e143, (_e139 < _e143));
    let _e147 = select(_e127, _e145, (_e127 < _e145));
    let _e149 = select(_e129, _e147, (_e129 < _e147));
    let _e151 = select(_e131, _e149, (_e131 < _e149));
    let _e158 = (((select(_e133, _e151, (_e133 < _e151)) < 2139095040u) && (_e141 <= 2139095040u)) && (_e145 > 0u));
    if (_e135 == _e145) {
        phi_446_ = 0u;
    } else {
        phi_446_ = select(2u, 1u, (_e137 == _e145));
    }
    let _e163 = phi_446_;
    let _e164 = (_e163 == 2u);
    if _e164 {
        phi_452_ = 0u;
    } else {
        phi_452_ = (_e163 + 1u);
    }
    let _e167 = phi_452_;
    let _e168 = (_e167 == 2u);
    if _e168 {
        phi_458_ = 0u;
    } else {
        phi_458_ = (_e167 + 1u);
    }
    let _e171 = phi_458_;
    let _e172 = (_e167 == 0u);
    let _e174 = select(select(_e108.y, _e108.x, _e172), _e108.z, _e168);
    let _e175 = (_e171 == 0u);
    let _e177 = (_e171 == 2u);
    let _e178 = select(select(_e108.y, _e108.x, _e175), _e108.z, _e177);
    let _e179 = (_e163 == 0u);
    let _e181 = select(select(_e108.y, _e108.x, _e179), _e108.z, _e164);
    let _e183 = select(select(_e115.y, _e115.x, _e172), _e115.z, _e168);
    let _e185 = select(select(_e115.y, _e115.x, _e175), _e115.z, _e177);
    let _e187 = select(select(_e115.y, _e115.x, _e179), _e115.z, _e164);
    let _e188 = (_e133 - 1u);
    let _e189 = (_e141 - 1u);
    let _e191 = select(_e188, _e189, (_e189 < _e188));
    let _e192 = (_e127 - 1u);
    let _e193 = (_e129 - 1u);
    let _e195 = select(_e192, _e193, (_e193 < _e192));
    let _e196 = (_e131 - 1u);
    let _e198 = select(_e195, _e196, (_e196 < _e195));
    let _e199 = (_e135 - 1u);
    let _e200 = (_e137 - 1u);
    let _e202 = select(_e199, _e200, (_e200 < _e199));
    let _e203 = (_e139 - 1u);
    let _e205 = select(_e202, _e203, (_e203 < _e202));
    let _e207 = select(_e198, _e205, (_e205 < _e198));
    if (((select(_e207, _e191, (_e191 < _e207)) >= 8388607u) && (_e145 < 2130706432u)) && (bitcast<u32>((_e125 + 126i)) <= 253u)) {
        let _e472 = bitcast<i32>((_e145 >> bitcast<u32>(23i)));
        let _e473 = (_e472 - 127i);
        let _e474 = (_e125 + _e473);
        let _e479 = bitcast<f32>((bitcast<u32>((_e125 + 127i)) << bitcast<u32>(23i)));
        let _e484 = bitcast<f32>((bitcast<u32>((254i - _e472)) << bitcast<u32>(23i)));
        if (_e133 >= 2139095040u) {
            phi_620_ = 255i;
        } else {
            phi_620_ = (bitcast<i32>((_e133 >> bitcast<u32>(23i))) + _e474);
        }
        let _e499 = phi_620_;
        if (_e133 == 0u) {
            phi_626_ = 0u;
        } else {
            phi_626_ = (_e133 | 8388608u);
        }
        let _e503 = phi_626_;
        if (_e499 <= 0i) {
            phi_646_ = u32();
            phi_647_ = true;
        } else {
            let _e510 = (_e503 == 0u);
            if _e510 {
                phi_645_ = u32();
            } else {
                phi_645_ = select(((bitcast<u32>(_e499) << bitcast<u32>(23i)) | (_e503 & 8388607u)), 2139095039u, (_e499 >= 255i));
            }
            let _e514 = phi_645_;
            phi_646_ = _e514;
            phi_647_ = _e510;
        }
        let _e516 = phi_646_;
        let _e518 = phi_647_;
        if (_e141 >= 2139095040u) {
            phi_665_ = 255i;
        } else {
            phi_665_ = (bitcast<i32>((_e141 >> bitcast<u32>(23i))) + _e474);
        }
        let _e529 = phi_665_;
        if (_e141 == 0u) {
            phi_671_ = 0u;
        } else {
            phi_671_ = (_e141 | 8388608u);
        }
        let _e533 = phi_671_;
        if (_e529 <= 0i) {
            phi_691_ = u32();
            phi_692_ = true;
        } else {
            let _e540 = (_e533 == 0u);
            if _e540 {
                phi_690_ = u32();
            } else {
                phi_690_ = select(((bitcast<u32>(_e529) << bitcast<u32>(23i)) | (_e533 & 8388607u)), 2139095039u, (_e529 >= 255i));
            }
            let _e544 = phi_690_;
            phi_691_ = _e544;
            phi_692_ = _e540;
        }
        let _e546 = phi_691_;
        let _e548 = phi_692_;
        phi_1069_ = SlimbvhTypeD(array<f32, 3>((_e174 * _e479), (_e178 * _e479), (_e181 * _e479)), array<f32, 3>((_e183 * _e484), (_e185 * _e484), (_e187 * _e484)), bitcast<f32>(((_e132 & 2147483648u) | select(_e516, 0u, _e518))), bitcast<f32>(((_e140 & 2147483648u) | select(_e546, 0u, _e548))), _e473);
    } else {
        let _e220 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e145, _e158))) & 2147483647u);
        if (_e220 >= 8388608u) {
            phi_723_ = (bitcast<i32>((_e220 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_723_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e220)), 32u, (_e220 == 0u))));
        }
        let _e234 = phi_723_;
        let _e235 = (_e125 + _e234);
        if (_e125 < -126i) {
            phi_734_ = -126i;
        } else {
            phi_734_ = select(_e125, 127i, (_e125 > 127i));
        }
        let _e240 = phi_734_;
        let _e245 = bitcast<f32>((bitcast<u32>((_e240 + 127i)) << bitcast<u32>(23i)));
        let _e251 = bitcast<f32>((bitcast<u32>(((_e125 - _e240) + 127i)) << bitcast<u32>(23i)));
        let _e252 = bitcast<u32>(_e174);
        let _e254 = ((_e252 & 2139095040u) != 0u);
        let _e269 = bitcast<u32>(_e178);
        let _e271 = ((_e269 & 2139095040u) != 0u);
        let _e286 = bitcast<u32>(_e181);
        let _e288 = ((_e286 & 2139095040u) != 0u);
        let _e304 = -(_e234);
        if (_e304 < -126i) {
            phi_848_ = -126i;
        } else {
            phi_848_ = select(_e304, 127i, (_e304 > 127i));
        }
        let _e309 = phi_848_;
        let _e314 = bitcast<f32>((bitcast<u32>((_e309 + 127i)) << bitcast<u32>(23i)));
        let _e320 = bitcast<f32>((bitcast<u32>(((_e304 - _e309) + 127i)) << bitcast<u32>(23i)));
        let _e321 = bitcast<u32>(_e183);
        let _e323 = ((_e321 & 2139095040u) != 0u);
        let _e338 = bitcast<u32>(_e185);
        let _e340 = ((_e338 & 2139095040u) != 0u);
        let _e355 = bitcast<u32>(_e187);
        let _e357 = ((_e355 & 2139095040u) != 0u);
        let _e379 = ((_e133 & 8388607u) | (select(0u, 1u, ((_e133 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e382 = bitcast<i32>((_e133 >> bitcast<u32>(23i)));
        let _e389 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e379)), 32u, (_e379 == 0u))) - 8i);
        if (_e382 == 255i) {
            phi_977_ = 255i;
        } else {
            phi_977_ = (((_e382 + select(0i, 1i, (_e382 == 0i))) - _e389) + _e235);
        }
        let _e397 = phi_977_;
        let _e401 = (_e379 << bitcast<u32>(((_e389 & 31i) & 31i)));
        if (_e397 <= 0i) {
            phi_1000_ = u32();
            phi_1001_ = true;
        } else {
            let _e408 = (_e401 == 0u);
            if _e408 {
                phi_999_ = u32();
            } else {
                phi_999_ = select(((bitcast<u32>(_e397) << bitcast<u32>(23i)) | (_e401 & 8388607u)), 2139095039u, (_e397 >= 255i));
            }
            let _e412 = phi_999_;
            phi_1000_ = _e412;
            phi_1001_ = _e408;
        }
        let _e414 = phi_1000_;
        let _e416 = phi_1001_;
        let _e427 = ((_e141 & 8388607u) | (select(0u, 1u, ((_e141 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e430 = bitcast<i32>((_e141 >> bitcast<u32>(23i)));
        let _e437 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e427)), 32u, (_e427 == 0u))) - 8i);
        if (_e430 == 255i) {
            phi_1035_ = 255i;
        } else {
            phi_1035_ = (((_e430 + select(0i, 1i, (_e430 == 0i))) - _e437) + _e235);
        }
        let _e445 = phi_1035_;
        let _e449 = (_e427 << bitcast<u32>(((_e437 & 31i) & 31i)));
        if (_e445 <= 0i) {
            phi_1058_ = u32();
            phi_1059_ = true;
        } else {
            let _e456 = (_e449 == 0u);
            if _e456 {
                phi_1057_ = u32();
            } else {
                phi_1057_ = select(((bitcast<u32>(_e445) << bitcast<u32>(23i)) | (_e449 & 8388607u)), 2139095039u, (_e445 >= 255i));
            }
            let _e460 = phi_1057_;
            phi_1058_ = _e460;
            phi_1059_ = _e456;
        }
        let _e462 = phi_1058_;
        let _e464 = phi_1059_;
        phi_1069_ = SlimbvhTypeD(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e252 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e252 & 2147483648u))), _e174, _e254) * _e245) * select(0.00000011920929f, 1f, _e254)) * _e251), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e269 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e269 & 2147483648u))), _e178, _e271) * _e245) * select(0.00000011920929f, 1f, _e271)) * _e251), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e286 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e286 & 2147483648u))), _e181, _e288) * _e245) * select(0.00000011920929f, 1f, _e288)) * _e251)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e321 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e321 & 2147483648u))), _e183, _e323) * _e314) * select(0.00000011920929f, 1f, _e323)) * _e320), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e338 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e338 & 2147483648u))), _e185, _e340) * _e314) * select(0.00000011920929f, 1f, _e340)) * _e320), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e355 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e355 & 2147483648u))), _e187, _e357) * _e314) * select(0.00000011920929f, 1f, _e357)) * _e320)), bitcast<f32>(((_e132 & 2147483648u) | select(_e414, 0u, _e416))), bitcast<f32>(((_e140 & 2147483648u) | select(_e462, 0u, _e464))), _e234);
    }
    let _e555 = phi_1069_;
    let _e570 = (bitcast<f32>((bitcast<u32>(_e555.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e573 = bitcast<f32>((bitcast<u32>(_e555.member[0]) & 2147483647u));
    let _e574 = (_e573 * 0.00000011920929f);
    let _e577 = select(select(0.00000000000011368684f, _e574, (_e574 > 0.00000000000011368684f)), 0f, _e570);
    let _e578 = select(0f, _e555.member_1[0], _e570);
    let _e579 = (_e555.member[0] + _e577);
    let _e580 = (_e555.member[0] - _e577);
    let _e582 = select(38685626000000000000000000f, (1f / _e555.member_1[0]), _e570);
    let _e586 = (bitcast<f32>((bitcast<u32>(_e555.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e589 = bitcast<f32>((bitcast<u32>(_e555.member[1]) & 2147483647u));
    let _e590 = (_e589 * 0.00000011920929f);
    let _e593 = select(select(0.00000000000011368684f, _e590, (_e590 > 0.00000000000011368684f)), 0f, _e586);
    let _e594 = select(0f, _e555.member_1[1], _e586);
    let _e595 = (_e555.member[1] + _e593);
    let _e596 = (_e555.member[1] - _e593);
    let _e598 = select(38685626000000000000000000f, (1f / _e555.member_1[1]), _e586);
    let _e602 = (bitcast<f32>((bitcast<u32>(_e555.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e605 = bitcast<f32>((bitcast<u32>(_e555.member[2]) & 2147483647u));
    let _e606 = (_e605 * 0.00000011920929f);
    let _e609 = select(select(0.00000000000011368684f, _e606, (_e606 > 0.00000000000011368684f)), 0f, _e602);
    let _e610 = select(0f, _e555.member_1[2], _e602);
    let _e611 = (_e555.member[2] + _e609);
    let _e612 = (_e555.member[2] - _e609);
    let _e614 = select(38685626000000000000000000f, (1f / _e555.member_1[2]), _e602);
    let _e616 = select(_e589, _e573, (_e573 > _e589));
    let _e620 = (_e158 && (select(_e605, _e616, (_e616 > _e605)) <= 1099511600000f));
    let _e621 = select(0f, _e555.member_3, _e620);
    let _e622 = select(1f, _e555.member_2, _e620);
    let _e626 = slimbvh_question.member[1u];
    let _e627 = slimbvh_lane.member;
    if (_e627 < 64u) {
        let _e629 = (_e627 % 64u);
        let _e632 = slimbvh_question.member[0u];
        if (_e632 == 1u) {
            phi_1281_ = SlimbvhTypeN(SlimbvhTypeJ(_e87, _e621), true);
        } else {
            phi_1281_ = SlimbvhTypeN(SlimbvhTypeJ(_e87, _e621), false);
        }
        let _e639 = phi_1281_;
        phi_1297_ = _e639;
        phi_1300_ = select(4294967295u, 0u, (_e622 <= _e621));
        phi_1302_ = 0u;
        phi_1304_ = (_e91 + 1u);
        loop {
            let _e648 = phi_1297_;
            let _e650 = phi_1300_;
            let _e652 = phi_1302_;
            let _e654 = phi_1304_;
            local_5 = _e650;
            local_6 = _e648;
            let _e655 = (_e650 <= 32u);
            if _e655 {
                phi_1313_ = _e650;
                phi_1316_ = _e652;
                phi_1318_ = _e654;
                loop {
                    let _e657 = phi_1313_;
                    let _e659 = phi_1316_;
                    let _e661 = phi_1318_;
                    local_1 = _e659;
                    local_2 = _e659;
                    local_3 = _e657;
                    local_8 = _e657;
                    local_9 = _e659;
                    local_10 = _e661;
                    let _e662 = (_e657 <= 32u);
                    let _e664 = (_e659 + _e104);
                    let _e668 = (_e662 && !(((_e659 >= _e91) || (_e664 >= _e91))));
                    local = _e662;
                    if _e668 {
                        let _e672 = slimbvh_nodes.member[_e664][3u][0u];
                        let _e676 = slimbvh_nodes.member[_e664][3u][1u];
                        let _e680 = slimbvh_nodes.member[_e664][((_e167 & 3u) % 4u)];
                        let _e684 = slimbvh_nodes.member[_e664][((_e171 & 3u) % 4u)];
                        let _e688 = slimbvh_nodes.member[_e664][((_e163 & 3u) % 4u)];
                        let _e689 = bitcast<u32>(_e672);
                        let _e690 = bitcast<u32>(_e676);
                        let _e701 = ((_e680.x - _e579) * _e582);
                        let _e702 = ((_e680.y - _e579) * _e582);
                        let _e703 = ((_e680.z - _e580) * _e582);
                        let _e704 = ((_e680.w - _e580) * _e582);
                        let _e705 = vec4<f32>(_e701, _e702, _e703, _e704);
                        let _e714 = ((_e684.x - _e595) * _e598);
                        let _e715 = ((_e684.y - _e595) * _e598);
                        let _e716 = ((_e684.z - _e596) * _e598);
                        let _e717 = ((_e684.w - _e596) * _e598);
                        let _e718 = vec4<f32>(_e714, _e715, _e716, _e717);
                        let _e727 = ((_e688.x - _e611) * _e614);
                        let _e728 = ((_e688.y - _e611) * _e614);
                        let _e729 = ((_e688.z - _e612) * _e614);
                        let _e730 = ((_e688.w - _e612) * _e614);
                        let _e731 = vec4<f32>(_e727, _e728, _e729, _e730);
                        let _e732 = vec4<f32>(_e703, _e704, _e701, _e702);
                        let _e733 = min(_e705, _e732);
                        let _e734 = vec4<f32>(_e716, _e717, _e714, _e715);
                        let _e735 = min(_e718, _e734);
                        let _e736 = vec4<f32>(_e729, _e730, _e727, _e728);
                        let _e737 = min(_e731, _e736);
                        let _e738 = max(_e705, _e732);
                        let _e739 = max(_e718, _e734);
                        let _e740 = max(_e731, _e736);
                        let _e769 = max(max(max(_e733.x, _e735.x), _e737.x), _e622);
                        let _e770 = max(max(max(_e733.y, _e735.y), _e737.y), _e622);
                        let _e773 = (_e769 <= min((min(min(_e738.x, _e739.x), _e740.x) + (max(_e740.x, -(_e737.x)) * 0.0000019073523f)), _e648.member.member_1));
                        let _e774 = (_e770 <= min((min(min(_e738.y, _e739.y), _e740.y) + (max(_e740.y, -(_e737.y)) * 0.0000019073523f)), _e648.member.member_1));
                        if (_e773 || _e774) {
                            let _e786 = (_e773 && (((_e769 <= _e770) != _e639.member_1) || !(_e774)));
                            if (_e773 && _e774) {
                                slimbvh_stacks[(((_e657 % 32u) * 64u) + _e629)] = select(_e689, _e690, _e786);
                                phi_1596_ = (_e657 + 1u);
                            } else {
                                phi_1596_ = _e657;
                            }
                            let _e796 = phi_1596_;
                            phi_1612_ = _e796;
                            phi_1613_ = select(_e690, _e689, _e786);
                        } else {
                            let _e778 = (_e657 - 1u);
                            let _e783 = slimbvh_stacks[(((_e778 % 32u) * 64u) + _e629)];
                            phi_1612_ = _e778;
                            phi_1613_ = _e783;
                        }
                        let _e798 = phi_1612_;
                        let _e800 = phi_1613_;
                        let _e801 = (_e661 - 1u);
                        phi_1314_ = select(_e798, 4294967295u, (_e801 == 0u));
                        phi_1317_ = _e800;
                        phi_1319_ = _e801;
                    } else {
                        phi_1314_ = u32();
                        phi_1317_ = u32();
                        phi_1319_ = u32();
                    }
                    let _e805 = phi_1314_;
                    let _e807 = phi_1317_;
                    let _e809 = phi_1319_;
                    continue;
                    continuing {
                        phi_1313_ = _e805;
                        phi_1316_ = _e807;
                        phi_1318_ = _e809;
                        break if !(_e668);
                    }
                }
                let _e812 = local;
                if _e812 {
                    let _e814 = local_1;
                    let _e817 = local_2;
                    phi_1630_ = _e648;
                    phi_1633_ = SlimbvhTypeE(0u, ((_e817 >> bitcast<u32>(28u)) & 7u));
                    loop {
                        let _e824 = phi_1630_;
                        let _e826 = phi_1633_;
                        local_4 = _e824;
                        local_7 = _e824;
                        if (_e826.member < _e826.member_1) {
                            phi_1634_ = SlimbvhTypeE((_e826.member + 1u), _e826.member_1);
                            phi_1656_ = SlimbvhTypeE(1u, _e826.member);
                        } else {
                            phi_1634_ = _e826;
                            phi_1656_ = SlimbvhTypeE(0u, SlimbvhTypeE().member_1);
                        }
                        let _e839 = phi_1634_;
                        let _e841 = phi_1656_;
                        let _e845 = (bitcast<i32>(_e841.member) != 0i);
                        if _e845 {
                            let _e846 = (((_e814 & 268435455u) + _e107) + _e841.member_1);
                            let _e847 = (_e846 / 2u);
                            let _e848 = (_e846 % 2u);
                            let _e849 = (_e847 >= arrayLength((&slimbvh_triangles.member)));
                            if _e849 {
                                phi_1736_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e850 = (2u * _e848);
                                let _e854 = slimbvh_triangles.member[_e847][_e850];
                                let _e859 = slimbvh_triangles.member[_e847][(_e850 + 1u)];
                                let _e864 = slimbvh_triangles.member[_e847][(_e850 + 2u)];
                                if (_e848 == 0u) {
                                    phi_1735_ = array<vec4<f32>, 3>(_e854, _e859, _e864);
                                } else {
                                    phi_1735_ = array<vec4<f32>, 3>(vec4<f32>(_e854.z, _e854.w, _e859.x, _e859.y), vec4<f32>(_e859.z, _e859.w, _e864.x, _e864.y), vec4<f32>(_e864.z, _e864.w, 0f, 0f));
                                }
                                let _e882 = phi_1735_;
                                phi_1736_ = _e882;
                            }
                            let _e884 = phi_1736_;
                            let _e887 = bitcast<u32>(_e884[2].y);
                            if _e849 {
                                phi_1811_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                            } else {
                                let _e888 = (2u * _e848);
                                let _e892 = slimbvh_triangles.member[_e847][_e888];
                                let _e897 = slimbvh_triangles.member[_e847][(_e888 + 1u)];
                                let _e902 = slimbvh_triangles.member[_e847][(_e888 + 2u)];
                                if (_e848 == 0u) {
                                    phi_1810_ = array<vec4<f32>, 3>(_e892, _e897, _e902);
                                } else {
                                    phi_1810_ = array<vec4<f32>, 3>(vec4<f32>(_e892.z, _e892.w, _e897.x, _e897.y), vec4<f32>(_e897.z, _e897.w, _e902.x, _e902.y), vec4<f32>(_e902.z, _e902.w, 0f, 0f));
                                }
                                let _e920 = phi_1810_;
                                phi_1811_ = _e920;
                            }
                            let _e922 = phi_1811_;
                            if _e172 {
                                phi_1835_ = array<f32, 3>(_e922[0].x, _e922[0].y, _e922[0].z);
                            } else {
                                if (_e167 == 1u) {
                                    phi_1834_ = array<f32, 3>(_e922[0].y, _e922[0].z, _e922[0].x);
                                } else {
                                    phi_1834_ = array<f32, 3>(_e922[0].z, _e922[0].x, _e922[0].y);
                                }
                                let _e945 = phi_1834_;
                                phi_1835_ = _e945;
                            }
                            let _e948 = phi_1835_;
                            if _e172 {
                                phi_1850_ = array<f32, 3>(_e922[0].w, _e922[1].x, _e922[1].y);
                            } else {
                                if (_e167 == 1u) {
                                    phi_1849_ = array<f32, 3>(_e922[1].x, _e922[1].y, _e922[0].w);
                                } else {
                                    phi_1849_ = array<f32, 3>(_e922[1].y, _e922[0].w, _e922[1].x);
                                }
                                let _e953 = phi_1849_;
                                phi_1850_ = _e953;
                            }
                            let _e956 = phi_1850_;
                            if _e172 {
                                phi_1865_ = array<f32, 3>(_e922[1].z, _e922[1].w, _e922[2].x);
                            } else {
                                if (_e167 == 1u) {
                                    phi_1864_ = array<f32, 3>(_e922[1].w, _e922[2].x, _e922[1].z);
                                } else {
                                    phi_1864_ = array<f32, 3>(_e922[2].x, _e922[1].z, _e922[1].w);
                                }
                                let _e961 = phi_1864_;
                                phi_1865_ = _e961;
                            }
                            let _e964 = phi_1865_;
                            let _e978 = (_e948[2] - _e555.member[2]);
                            let _e981 = (((_e948[0] - _e555.member[0]) * _e610) - (_e978 * _e578));
                            let _e984 = (((_e948[1] - _e555.member[1]) * _e610) - (_e978 * _e594));
                            let _e987 = (_e956[2] - _e555.member[2]);
                            let _e990 = (((_e956[0] - _e555.member[0]) * _e610) - (_e987 * _e578));
                            let _e993 = (((_e956[1] - _e555.member[1]) * _e610) - (_e987 * _e594));
                            let _e996 = (_e964[2] - _e555.member[2]);
                            let _e999 = (((_e964[0] - _e555.member[0]) * _e610) - (_e996 * _e578));
                            let _e1002 = (((_e964[1] - _e555.member[1]) * _e610) - (_e996 * _e594));
                            let _e1003 = (_e999 * _e993);
                            let _e1004 = (_e1002 * _e990);
                            let _e1005 = (_e981 * _e1002);
                            let _e1006 = (_e984 * _e999);
                            let _e1007 = (_e990 * _e984);
                            let _e1008 = (_e993 * _e981);
                            let _e1013 = (((_e1003 >= _e1004) && (_e1005 >= _e1006)) && (_e1007 >= _e1008));
                            let _e1019 = (_e1013 || (((_e1003 <= _e1004) && (_e1005 <= _e1006)) && (_e1007 <= _e1008)));
                            if _e1019 {
                                let _e1021 = select(-1f, 1f, _e1013);
                                let _e1023 = ((_e1003 - _e1004) * _e1021);
                                let _e1025 = select(0f, _e1023, (_e1023 > 0f));
                                let _e1027 = ((_e1005 - _e1006) * _e1021);
                                let _e1029 = select(0f, _e1027, (_e1027 > 0f));
                                let _e1031 = ((_e1007 - _e1008) * _e1021);
                                let _e1033 = select(0f, _e1031, (_e1031 > 0f));
                                let _e1035 = ((_e1025 + _e1029) + _e1033);
                                let _e1050 = ((min(min(_e948[0], _e956[0]), _e964[0]) - _e579) * _e582);
                                let _e1051 = ((max(max(_e948[0], _e956[0]), _e964[0]) - _e580) * _e582);
                                let _e1052 = vec4<f32>(_e1050, f32(), _e1051, f32());
                                let _e1055 = ((min(min(_e948[1], _e956[1]), _e964[1]) - _e595) * _e598);
                                let _e1056 = ((max(max(_e948[1], _e956[1]), _e964[1]) - _e596) * _e598);
                                let _e1057 = vec4<f32>(_e1055, f32(), _e1056, f32());
                                let _e1060 = ((min(min(_e948[2], _e956[2]), _e964[2]) - _e611) * _e614);
                                let _e1061 = ((max(max(_e948[2], _e956[2]), _e964[2]) - _e612) * _e614);
                                let _e1062 = vec4<f32>(_e1060, f32(), _e1061, f32());
                                let _e1063 = vec4<f32>(_e1051, f32(), _e1050, f32());
                                let _e1065 = vec4<f32>(_e1056, f32(), _e1055, f32());
                                let _e1067 = vec4<f32>(_e1061, f32(), _e1060, f32());
                                let _e1076 = max(max(min(_e1052, _e1063).x, min(_e1057, _e1065).x), min(_e1062, _e1067).x);
                                let _e1081 = min(min(max(_e1052, _e1063).x, max(_e1057, _e1065).x), max(_e1062, _e1067).x);
                                let _e1086 = max(_e1076, _e622);
                                let _e1108 = (((((_e1019 && (_e1035 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e981, _e990), _e999) <= 0f) && (max(max(_e981, _e990), _e999) >= 0f))) && ((min(min(_e984, _e993), _e1002) <= 0f) && (max(max(_e984, _e993), _e1002) >= 0f))) && (_e1086 <= (_e1081 + (max(max(_e1062, _e1067).x, -(min(_e1062, _e1067).x)) * 0.0000019073523f)))) && (_e1086 <= _e824.member.member_1));
                                if _e1108 {
                                    let _e1113 = (_e956[0] - _e948[0]);
                                    let _e1114 = (_e956[1] - _e948[1]);
                                    let _e1115 = (_e956[2] - _e948[2]);
                                    let _e1116 = vec3<f32>(_e1113, _e1114, _e1115);
                                    let _e1117 = (_e964[0] - _e956[0]);
                                    let _e1118 = (_e964[1] - _e956[1]);
                                    let _e1119 = (_e964[2] - _e956[2]);
                                    let _e1120 = vec3<f32>(_e1117, _e1118, _e1119);
                                    let _e1121 = (_e948[0] - _e964[0]);
                                    let _e1122 = (_e948[1] - _e964[1]);
                                    let _e1123 = (_e948[2] - _e964[2]);
                                    let _e1124 = vec3<f32>(_e1121, _e1122, _e1123);
                                    let _e1135 = max(max(bitcast<f32>((bitcast<u32>(_e1113) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1114) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1115) & 2147483647u)));
                                    let _e1146 = max(max(bitcast<f32>((bitcast<u32>(_e1117) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1118) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1119) & 2147483647u)));
                                    let _e1159 = max(max(_e1135, _e1146), max(max(bitcast<f32>((bitcast<u32>(_e1121) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1122) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1123) & 2147483647u))));
                                    if (_e1135 == _e1159) {
                                        phi_2198_ = _e993;
                                        phi_2199_ = _e990;
                                        phi_2200_ = _e984;
                                        phi_2201_ = _e981;
                                        phi_2202_ = vec3<f32>(_e948[0], _e948[1], _e948[2]);
                                        phi_2203_ = _e1124;
                                        phi_2204_ = _e1120;
                                        phi_2205_ = _e1116;
                                    } else {
                                        let _e1161 = (_e1146 == _e1159);
                                        let _e1166 = vec3(_e1161);
                                        phi_2198_ = select(_e984, _e1002, _e1161);
                                        phi_2199_ = select(_e981, _e999, _e1161);
                                        phi_2200_ = select(_e1002, _e993, _e1161);
                                        phi_2201_ = select(_e999, _e990, _e1161);
                                        phi_2202_ = select(vec3<f32>(_e964[0], _e964[1], _e964[2]), vec3<f32>(_e956[0], _e956[1], _e956[2]), _e1166);
                                        phi_2203_ = select(_e1120, _e1116, _e1166);
                                        phi_2204_ = select(_e1116, _e1124, _e1166);
                                        phi_2205_ = select(_e1124, _e1120, _e1166);
                                    }
                                    let _e1172 = phi_2198_;
                                    let _e1174 = phi_2199_;
                                    let _e1176 = phi_2200_;
                                    let _e1178 = phi_2201_;
                                    let _e1180 = phi_2202_;
                                    let _e1182 = phi_2203_;
                                    let _e1184 = phi_2204_;
                                    let _e1186 = phi_2205_;
                                    let _e1193 = ((_e1184.y * _e1182.z) - (_e1182.y * _e1184.z));
                                    let _e1198 = ((_e1184.z * _e1182.x) - (_e1182.z * _e1184.x));
                                    let _e1201 = ((_e1184.x * _e1182.y) - (_e1182.x * _e1184.y));
                                    let _e1204 = ((_e1025 >= _e1029) && (_e1025 >= _e1033));
                                    let _e1205 = (_e1029 >= _e1033);
                                    let _e1219 = (((_e1193 * (select(select(_e964[0], _e956[0], _e1205), _e948[0], _e1204) - _e555.member[0])) + (_e1198 * (select(select(_e964[1], _e956[1], _e1205), _e948[1], _e1204) - _e555.member[1]))) + (_e1201 * (select(select(_e964[2], _e956[2], _e1205), _e948[2], _e1204) - _e555.member[2])));
                                    let _e1224 = (((_e1193 * _e578) + (_e1198 * _e594)) + (_e1201 * _e610));
                                    let _e1225 = (_e1174 - _e1178);
                                    let _e1226 = (_e1172 - _e1176);
                                    let _e1229 = ((_e1225 * _e1225) + (_e1226 * _e1226));
                                    let _e1236 = (-(((_e1178 * _e1225) + (_e1176 * _e1226))) / select(0.000000000000000000000000000000000000011754944f, _e1229, (_e1229 > 0.000000000000000000000000000000000000011754944f)));
                                    let _e1238 = select(1f, _e1236, (_e1236 < 1f));
                                    let _e1240 = select(0f, _e1238, (_e1238 > 0f));
                                    let _e1249 = ((_e1180.x + (_e1186.x * _e1240)) - _e555.member[0]);
                                    let _e1252 = ((_e1180.y + (_e1186.y * _e1240)) - _e555.member[1]);
                                    let _e1255 = ((_e1180.z + (_e1186.z * _e1240)) - _e555.member[2]);
                                    let _e1320 = ((bitcast<f32>((bitcast<u32>(((((_e1193 * _e1249) + (_e1198 * _e1252)) + (_e1201 * _e1255)) - _e1219)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1249) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1252) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1255) & 2147483647u))), _e1159)) * max(max(bitcast<f32>((bitcast<u32>(_e1193) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1198) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1201) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1224) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1184.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1184.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1184.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1182.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1182.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1182.z) & 2147483647u)))))));
                                    let _e1321 = (_e1219 / _e1224);
                                    if (_e1108 && !(_e1320)) {
                                        let _e1324 = (_e1255 / _e610);
                                        let _e1332 = (((_e1193 * (_e1249 - (_e578 * _e1324))) + (_e1198 * (_e1252 - (_e594 * _e1324)))) / _e1224);
                                        phi_2384_ = select(select(_e1324, (_e1324 + _e1332), (bitcast<f32>((bitcast<u32>(_e1332) & 2147483647u)) <= _e1159)), _e1321, _e1320);
                                    } else {
                                        phi_2384_ = _e1321;
                                    }
                                    let _e1341 = phi_2384_;
                                    let _e1343 = select(_e1081, _e1341, (_e1341 < _e1081));
                                    let _e1345 = select(_e1076, _e1343, (_e1343 > _e1076));
                                    let _e1348 = select(_e1345, 0f, (bitcast<u32>(_e1345) == 2147483648u));
                                    let _e1349 = (1f / _e1035);
                                    phi_2410_ = SlimbvhTypeF(_e1348, (_e1029 * _e1349), (_e1033 * _e1349), ((_e1108 && (_e1348 >= _e622)) && (_e1348 <= _e824.member.member_1)));
                                    phi_2411_ = SlimbvhTypeF();
                                } else {
                                    phi_2410_ = SlimbvhTypeF();
                                    phi_2411_ = SlimbvhTypeF(0f, 0f, 0f, _e1108);
                                }
                                let _e1358 = phi_2410_;
                                let _e1360 = phi_2411_;
                                phi_2414_ = _e1358;
                                phi_2415_ = _e1360;
                                phi_2416_ = select(true, false, _e1108);
                            } else {
                                phi_2414_ = SlimbvhTypeF();
                                phi_2415_ = SlimbvhTypeF(0f, 0f, 0f, _e1019);
                                phi_2416_ = true;
                            }
                            let _e1363 = phi_2414_;
                            let _e1365 = phi_2415_;
                            let _e1367 = phi_2416_;
                            if _e1367 {
                                phi_2420_ = _e1365;
                            } else {
                                phi_2420_ = _e1363;
                            }
                            let _e1369 = phi_2420_;
                            if _e1369.member_3 {
                                phi_2429_ = SlimbvhTypeG(_e1369.member, _e1369.member_1, _e1369.member_2, _e887);
                            } else {
                                phi_2429_ = _e87;
                            }
                            let _e1376 = phi_2429_;
                            if (_e1376.member_3 != 4294967295u) {
                                let _e1382 = slimbvh_target.member[0u][0u];
                                let _e1386 = slimbvh_target.member[0u][1u];
                                let _e1390 = slimbvh_target.member[0u][2u];
                                let _e1394 = slimbvh_target.member[0u][3u];
                                let _e1398 = slimbvh_target.member[1u][0u];
                                let _e1402 = slimbvh_target.member[1u][1u];
                                let _e1406 = slimbvh_target.member[1u][2u];
                                let _e1410 = slimbvh_target.member[1u][3u];
                                let _e1411 = bitcast<f32>(_e1382);
                                let _e1412 = bitcast<f32>(_e1386);
                                let _e1413 = bitcast<f32>(_e1390);
                                let _e1415 = bitcast<f32>(_e1398);
                                let _e1416 = array<u32, 3>(_e1402, _e1406, _e1410);
                                if (_e125 < -126i) {
                                    phi_2476_ = -126i;
                                } else {
                                    phi_2476_ = select(_e125, 127i, (_e125 > 127i));
                                }
                                let _e1422 = phi_2476_;
                                let _e1427 = bitcast<f32>((bitcast<u32>((_e1422 + 127i)) << bitcast<u32>(23i)));
                                let _e1433 = bitcast<f32>((bitcast<u32>(((_e125 - _e1422) + 127i)) << bitcast<u32>(23i)));
                                if (_e1394 == 0u) {
                                    phi_2616_ = SlimbvhTypeI(array<f32, 3>(_e1411, _e1412, _e1413), _e1394, _e1415, _e1416);
                                } else {
                                    let _e1435 = bitcast<u32>(_e1411);
                                    let _e1437 = ((_e1435 & 2139095040u) != 0u);
                                    let _e1452 = bitcast<u32>(_e1412);
                                    let _e1454 = ((_e1452 & 2139095040u) != 0u);
                                    let _e1469 = bitcast<u32>(_e1413);
                                    let _e1471 = ((_e1469 & 2139095040u) != 0u);
                                    let _e1487 = bitcast<u32>(_e1415);
                                    let _e1489 = ((_e1487 & 2139095040u) != 0u);
                                    phi_2616_ = SlimbvhTypeI(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1435 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1435 & 2147483648u))), _e1411, _e1437) * _e1427) * select(0.00000011920929f, 1f, _e1437)) * _e1433), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1452 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1452 & 2147483648u))), _e1412, _e1454) * _e1427) * select(0.00000011920929f, 1f, _e1454)) * _e1433), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1469 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1469 & 2147483648u))), _e1413, _e1471) * _e1427) * select(0.00000011920929f, 1f, _e1471)) * _e1433)), _e1394, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1487 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1487 & 2147483648u))), _e1415, _e1489) * _e1427) * select(0.00000011920929f, 1f, _e1489)) * _e1433), _e1416);
                                }
                                let _e1506 = phi_2616_;
                                if (_e887 == _e626) {
                                    phi_2942_ = false;
                                } else {
                                    let _e1508 = (_e887 / 16u);
                                    if (_e1508 < arrayLength((&slimbvh_sides.member))) {
                                        let _e1511 = slimbvh_sides.member[_e1508];
                                        phi_2640_ = _e1511;
                                    } else {
                                        phi_2640_ = 0u;
                                    }
                                    let _e1513 = phi_2640_;
                                    let _e1522 = (bitcast<i32>((_e1513 << bitcast<u32>(((30u - ((_e887 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                    let _e1523 = (_e1522 == 0i);
                                    if _e1523 {
                                        phi_2941_ = true;
                                    } else {
                                        if _e172 {
                                            phi_2669_ = vec3<f32>(_e948[0], _e948[1], _e948[2]);
                                        } else {
                                            if (_e167 == 1u) {
                                                phi_2668_ = vec3<f32>(_e948[2], _e948[0], _e948[1]);
                                            } else {
                                                phi_2668_ = vec3<f32>(_e948[1], _e948[2], _e948[0]);
                                            }
                                            let _e1528 = phi_2668_;
                                            phi_2669_ = _e1528;
                                        }
                                        let _e1531 = phi_2669_;
                                        if _e172 {
                                            phi_2687_ = vec3<f32>(_e956[0], _e956[1], _e956[2]);
                                        } else {
                                            if (_e167 == 1u) {
                                                phi_2686_ = vec3<f32>(_e956[2], _e956[0], _e956[1]);
                                            } else {
                                                phi_2686_ = vec3<f32>(_e956[1], _e956[2], _e956[0]);
                                            }
                                            let _e1536 = phi_2686_;
                                            phi_2687_ = _e1536;
                                        }
                                        let _e1539 = phi_2687_;
                                        if _e172 {
                                            phi_2705_ = vec3<f32>(_e964[0], _e964[1], _e964[2]);
                                        } else {
                                            if (_e167 == 1u) {
                                                phi_2704_ = vec3<f32>(_e964[2], _e964[0], _e964[1]);
                                            } else {
                                                phi_2704_ = vec3<f32>(_e964[1], _e964[2], _e964[0]);
                                            }
                                            let _e1544 = phi_2704_;
                                            phi_2705_ = _e1544;
                                        }
                                        let _e1547 = phi_2705_;
                                        let _e1550 = (_e1539.x - _e1531.x);
                                        let _e1553 = (_e1539.y - _e1531.y);
                                        let _e1556 = (_e1539.z - _e1531.z);
                                        let _e1558 = (_e1547.x - _e1531.x);
                                        let _e1560 = (_e1547.y - _e1531.y);
                                        let _e1562 = (_e1547.z - _e1531.z);
                                        if (_e1506.member_1 == 1u) {
                                            phi_2741_ = (vec3<f32>(_e1506.member[0], _e1506.member[1], _e1506.member[2]) - _e1531);
                                        } else {
                                            phi_2741_ = vec3<f32>(_e1506.member[0], _e1506.member[1], _e1506.member[2]);
                                        }
                                        let _e1577 = phi_2741_;
                                        let _e1583 = bitcast<f32>((bitcast<u32>((_e1550 * _e1560)) ^ _e1506.member_3[0]));
                                        let _e1587 = bitcast<f32>((bitcast<u32>((_e1553 * _e1558)) ^ _e1506.member_3[0]));
                                        let _e1591 = bitcast<f32>((bitcast<u32>((_e1553 * _e1562)) ^ _e1506.member_3[0]));
                                        let _e1595 = bitcast<f32>((bitcast<u32>((_e1556 * _e1560)) ^ _e1506.member_3[0]));
                                        let _e1599 = bitcast<f32>((bitcast<u32>((_e1556 * _e1558)) ^ _e1506.member_3[0]));
                                        let _e1603 = bitcast<f32>((bitcast<u32>((_e1550 * _e1562)) ^ _e1506.member_3[0]));
                                        let _e1604 = (_e1591 - _e1595);
                                        let _e1605 = (_e1599 - _e1603);
                                        let _e1606 = (_e1583 - _e1587);
                                        let _e1630 = (bitcast<f32>((bitcast<u32>(_e1591) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1595) & 2147483647u)));
                                        let _e1637 = (bitcast<f32>((bitcast<u32>(_e1599) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1603) & 2147483647u)));
                                        let _e1644 = (bitcast<f32>((bitcast<u32>(_e1583) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1587) & 2147483647u)));
                                        if (_e1506.member_2 == 0f) {
                                            phi_2923_ = 0f;
                                        } else {
                                            let _e1674 = bitcast<f32>((bitcast<u32>(_e1604) & 2147483647u));
                                            let _e1677 = bitcast<f32>((bitcast<u32>(_e1605) & 2147483647u));
                                            let _e1680 = bitcast<f32>((bitcast<u32>(_e1606) & 2147483647u));
                                            let _e1682 = select(_e1680, _e1677, (_e1677 > _e1680));
                                            let _e1686 = select(_e1680, _e1677, (_e1677 < _e1680));
                                            let _e1690 = select(_e1677, _e1674, (_e1674 < _e1677));
                                            let _e1692 = select(_e1677, _e1674, (_e1674 > _e1677));
                                            let _e1694 = select(_e1680, _e1692, (_e1692 < _e1680));
                                            phi_2923_ = bitcast<f32>((bitcast<u32>((_e1506.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1682, _e1674, (_e1674 > _e1682)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1694, _e1690, (_e1690 > _e1694)))) ^ _e1506.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1686, _e1674, (_e1674 < _e1686)))) ^ _e1506.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1630 + _e1637) + _e1644))) ^ _e1506.member_3[0]))) * 1.0000005f)) ^ _e1506.member_3[0])))) ^ _e1506.member_3[0]));
                                        }
                                        let _e1721 = phi_2923_;
                                        phi_2941_ = (_e1523 || !(((((bitcast<f32>((bitcast<u32>((_e1577.x * _e1604)) ^ _e1506.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1577.y * _e1605)) ^ _e1506.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1577.z * _e1606)) ^ _e1506.member_3[0]))) * f32(-(_e1522))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1577.x) & 2147483647u)) * _e1630)) ^ _e1506.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1577.y) & 2147483647u)) * _e1637)) ^ _e1506.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1577.z) & 2147483647u)) * _e1644)) ^ _e1506.member_3[0]))))) ^ _e1506.member_3[0])) + _e1721) + 0.0000000000000000000000000000000000001880791f))));
                                    }
                                    let _e1735 = phi_2941_;
                                    phi_2942_ = _e1735;
                                }
                                let _e1737 = phi_2942_;
                                if _e1737 {
                                    if (_e1376.member < _e824.member.member.member) {
                                        phi_2962_ = true;
                                    } else {
                                        if (_e1376.member == _e824.member.member.member) {
                                            phi_2961_ = (_e1376.member_3 < _e824.member.member.member_3);
                                        } else {
                                            phi_2961_ = false;
                                        }
                                        let _e1749 = phi_2961_;
                                        phi_2962_ = _e1749;
                                    }
                                    let _e1751 = phi_2962_;
                                    if _e1751 {
                                        phi_2969_ = SlimbvhTypeN(SlimbvhTypeJ(_e1376, _e1376.member), _e824.member_1);
                                    } else {
                                        phi_2969_ = _e824;
                                    }
                                    let _e1757 = phi_2969_;
                                    if _e1757.member_1 {
                                        phi_2975_ = SlimbvhTypeN(SlimbvhTypeJ(_e1757.member.member, bitcast<f32>(4286578687u)), _e1757.member_1);
                                    } else {
                                        phi_2975_ = _e1757;
                                    }
                                    let _e1766 = phi_2975_;
                                    phi_2976_ = _e1766;
                                } else {
                                    phi_2976_ = _e824;
                                }
                                let _e1768 = phi_2976_;
                                phi_2977_ = _e1768;
                            } else {
                                phi_2977_ = _e824;
                            }
                            let _e1770 = phi_2977_;
                            phi_1631_ = _e1770;
                        } else {
                            phi_1631_ = SlimbvhTypeN();
                        }
                        let _e1772 = phi_1631_;
                        continue;
                        continuing {
                            phi_1630_ = _e1772;
                            phi_1633_ = _e839;
                            break if !(_e845);
                        }
                    }
                    let _e1775 = local_3;
                    let _e1776 = (_e1775 - 1u);
                    let _e1781 = slimbvh_stacks[(((_e1776 % 32u) * 64u) + _e629)];
                    let _e1783 = local_4;
                    let _e2046 = local_7;
                    phi_2999_ = _e2046;
                    phi_3000_ = select(_e1776, 4294967295u, (_e622 > _e1783.member.member_1));
                    phi_3001_ = _e1781;
                } else {
                    phi_2999_ = _e648;
                    let _e2049 = local_8;
                    phi_3000_ = _e2049;
                    let _e2052 = local_9;
                    phi_3001_ = _e2052;
                }
                let _e1789 = phi_2999_;
                let _e1791 = phi_3000_;
                let _e1793 = phi_3001_;
                phi_1298_ = _e1789;
                phi_1301_ = _e1791;
                phi_1303_ = _e1793;
                let _e2058 = local_10;
                phi_1305_ = _e2058;
            } else {
                phi_1298_ = SlimbvhTypeN();
                phi_1301_ = u32();
                phi_1303_ = u32();
                phi_1305_ = u32();
            }
            let _e1795 = phi_1298_;
            let _e1797 = phi_1301_;
            let _e1799 = phi_1303_;
            let _e1801 = phi_1305_;
            continue;
            continuing {
                phi_1297_ = _e1795;
                phi_1300_ = _e1797;
                phi_1302_ = _e1799;
                phi_1304_ = _e1801;
                break if !(_e655);
            }
        }
        let _e1804 = local_5;
        let _e1805 = (_e1804 == 4294967295u);
        let _e1807 = local_6;
        if (_e1807.member.member.member_3 != 4294967295u) {
            let _e1813 = -((_e125 + _e555.member_4));
            let _e1814 = bitcast<u32>(_e1807.member.member.member);
            let _e1818 = (bitcast<i32>((_e1814 >> bitcast<u32>(23i))) & 255i);
            let _e1819 = (_e1818 + _e1813);
            if (_e1818 == 255i) {
                phi_3057_ = _e1807.member.member.member;
            } else {
                if (_e1818 > 0i) {
                    if (_e1819 > 0i) {
                        let _e1823 = (_e1819 < 255i);
                        if _e1823 {
                            phi_3036_ = bitcast<f32>((_e1814 + bitcast<u32>((_e1813 << bitcast<u32>(23i)))));
                        } else {
                            phi_3036_ = f32();
                        }
                        let _e1830 = phi_3036_;
                        phi_3038_ = _e1830;
                        phi_3039_ = select(true, false, _e1823);
                    } else {
                        phi_3038_ = f32();
                        phi_3039_ = true;
                    }
                    let _e1833 = phi_3038_;
                    let _e1835 = phi_3039_;
                    phi_3040_ = _e1833;
                    phi_3041_ = _e1835;
                } else {
                    phi_3040_ = f32();
                    phi_3041_ = true;
                }
                let _e1837 = phi_3040_;
                let _e1839 = phi_3041_;
                if _e1839 {
                    let _e1840 = (_e1814 & 2147483648u);
                    let _e1847 = ((_e1814 & 8388607u) | (select(0u, 1u, ((_e1814 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e1851 = (_e1847 == 0u);
                    if _e1851 {
                        phi_3494_ = bitcast<f32>(_e1840);
                    } else {
                        let _e1856 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1847)), 32u, _e1851) - 8u);
                        let _e1859 = (_e1847 << bitcast<u32>((_e1856 & 31u)));
                        let _e1861 = ((_e1819 + select(0i, 1i, (_e1818 == 0i))) - bitcast<i32>(_e1856));
                        if (_e1861 >= 255i) {
                            phi_3484_ = bitcast<f32>((_e1840 | 2139095040u));
                            phi_3485_ = f32();
                            phi_3486_ = true;
                        } else {
                            let _e1863 = (_e1861 > 0i);
                            if _e1863 {
                                phi_3478_ = bitcast<f32>(((_e1840 | (bitcast<u32>(_e1861) << bitcast<u32>(23i))) | (_e1859 & 8388607u)));
                                phi_3479_ = f32();
                            } else {
                                if (_e1861 < -24i) {
                                    phi_3444_ = 26u;
                                } else {
                                    phi_3444_ = bitcast<u32>((1i - _e1861));
                                }
                                let _e1868 = phi_3444_;
                                let _e1869 = (_e1868 & 31u);
                                let _e1871 = (_e1859 >> bitcast<u32>(_e1869));
                                let _e1875 = (_e1859 & ((1u << bitcast<u32>(_e1869)) - 1u));
                                let _e1879 = (1u << bitcast<u32>(((_e1868 - 1u) & 31u)));
                                if (_e1875 > _e1879) {
                                    phi_3465_ = true;
                                } else {
                                    if (_e1875 == _e1879) {
                                        phi_3462_ = ((_e1871 & 1u) == 1u);
                                    } else {
                                        phi_3462_ = false;
                                    }
                                    let _e1885 = phi_3462_;
                                    phi_3465_ = _e1885;
                                }
                                let _e1887 = phi_3465_;
                                phi_3478_ = f32();
                                phi_3479_ = bitcast<f32>((_e1840 | (_e1871 + select(0u, 1u, _e1887))));
                            }
                            let _e1900 = phi_3478_;
                            let _e1902 = phi_3479_;
                            phi_3484_ = _e1900;
                            phi_3485_ = _e1902;
                            phi_3486_ = _e1863;
                        }
                        let _e1906 = phi_3484_;
                        let _e1908 = phi_3485_;
                        let _e1910 = phi_3486_;
                        phi_3494_ = select(_e1908, _e1906, _e1910);
                    }
                    let _e1914 = phi_3494_;
                    phi_3056_ = _e1914;
                } else {
                    phi_3056_ = _e1837;
                }
                let _e1916 = phi_3056_;
                phi_3057_ = _e1916;
            }
            let _e1918 = phi_3057_;
            let _e1919 = bitcast<u32>(_e1918);
            if ((_e1919 & 2147483647u) >= 2139095040u) {
                phi_3069_ = bitcast<f32>(((_e1919 & 2147483648u) | 2139095039u));
            } else {
                phi_3069_ = _e1918;
            }
            let _e1926 = phi_3069_;
            phi_3074_ = SlimbvhTypeG(_e1926, _e1807.member.member.member_1, _e1807.member.member.member_2, _e1807.member.member.member_3);
        } else {
            phi_3074_ = _e87;
        }
        let _e1931 = phi_3074_;
        slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1931.member), bitcast<u32>(_e1931.member_1), bitcast<u32>(_e1931.member_2), _e1931.member_3);
        phi_3087_ = _e1805;
        phi_3088_ = _e1805;
        phi_3089_ = select(true, false, _e1805);
    } else {
        phi_3087_ = bool();
        phi_3088_ = false;
        phi_3089_ = true;
    }
    let _e1942 = phi_3087_;
    let _e1944 = phi_3088_;
    let _e1946 = phi_3089_;
    if _e1946 {
        slimbvh_hit.member = vec4<u32>(2139095039u, 0u, 0u, 4294967295u);
    }
    slimbvh_overflowed.member = select(0u, 1u, !(select(_e1942, _e1944, _e1946)));
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
