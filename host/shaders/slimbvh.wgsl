// Made by slimbvh's shader builder from its Rust: rays traced from your own WGSL. Put this text before yours, bind the
// tree's exponent, nodes and triangles to group 0, and call
//
//   slimbvh_closest_hit(origin, t_min, direction, t_max) -> SlimbvhHit
//   slimbvh_any_hit(origin, t_min, direction, t_max) -> bool
//
// from any stage. t is in units of the direction's length; a miss has the primitive 0xffffffff. The stack is private
// memory, 1 KiB an invocation: in compute shaders the functions of slimbvh_compute.wgsl are faster.

struct SlimbvhTypeA {
    member: u32,
    member_1: u32,
}

struct SlimbvhTypeB {
    member: vec4<u32>,
}

struct SlimbvhTypeC {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct SlimbvhTypeD {
    member: array<array<vec4<f32>, 4>>,
}

struct SlimbvhTypeE {
    member: array<array<vec4<f32>, 5>>,
}

struct SlimbvhTypeF {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
    member_2: f32,
    member_3: f32,
    member_4: i32,
}

struct SlimbvhTypeG {
    member: SlimbvhTypeC,
    member_1: f32,
}

struct SlimbvhTypeH {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct SlimbvhTypeI {
    member: vec4<f32>,
}

struct SlimbvhTypeJ {
    member: u32,
}

struct SlimbvhTypeK {
    member: SlimbvhTypeG,
    member_1: bool,
}

@group(0) @binding(0) 
var<uniform> slimbvh_exponent: SlimbvhTypeB;

@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeD;

@group(0) @binding(2) 
var<storage> slimbvh_triangles: SlimbvhTypeE;

var<private> slimbvh_origin: SlimbvhTypeI;

var<private> slimbvh_direction: SlimbvhTypeI;

var<private> slimbvh_any_will_do: SlimbvhTypeJ;

var<private> slimbvh_hit: SlimbvhTypeB;

fn slimbvh_trace() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_363_: u32;
    var phi_369_: u32;
    var phi_375_: u32;
    var phi_640_: i32;
    var phi_651_: i32;
    var phi_765_: i32;
    var phi_894_: i32;
    var phi_916_: u32;
    var phi_917_: u32;
    var phi_918_: bool;
    var phi_952_: i32;
    var phi_974_: u32;
    var phi_975_: u32;
    var phi_976_: bool;
    var phi_537_: i32;
    var phi_543_: u32;
    var phi_562_: u32;
    var phi_563_: u32;
    var phi_564_: bool;
    var phi_582_: i32;
    var phi_588_: u32;
    var phi_607_: u32;
    var phi_608_: u32;
    var phi_609_: bool;
    var phi_986_: SlimbvhTypeF;
    var phi_1181_: SlimbvhTypeK;
    var phi_1196_: SlimbvhTypeK;
    var phi_1199_: u32;
    var phi_1201_: u32;
    var phi_1203_: u32;
    var phi_1212_: u32;
    var phi_1215_: u32;
    var phi_1217_: u32;
    var phi_1497_: u32;
    var phi_1472_: u32;
    var phi_1498_: u32;
    var phi_1499_: u32;
    var phi_1213_: u32;
    var phi_1216_: u32;
    var phi_1218_: u32;
    var local_2: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1515_: SlimbvhTypeK;
    var phi_1518_: SlimbvhTypeA;
    var phi_1519_: SlimbvhTypeA;
    var phi_1541_: SlimbvhTypeA;
    var phi_1620_: array<vec4<f32>, 3>;
    var phi_1621_: array<vec4<f32>, 3>;
    var phi_1695_: array<vec4<f32>, 3>;
    var phi_1696_: array<vec4<f32>, 3>;
    var phi_1719_: array<f32, 3>;
    var phi_1720_: array<f32, 3>;
    var phi_1734_: array<f32, 3>;
    var phi_1735_: array<f32, 3>;
    var phi_1749_: array<f32, 3>;
    var phi_1750_: array<f32, 3>;
    var phi_2066_: f32;
    var phi_2067_: f32;
    var phi_2068_: f32;
    var phi_2069_: f32;
    var phi_2070_: vec3<f32>;
    var phi_2071_: vec3<f32>;
    var phi_2072_: vec3<f32>;
    var phi_2073_: vec3<f32>;
    var phi_2252_: f32;
    var phi_2278_: SlimbvhTypeH;
    var phi_2279_: SlimbvhTypeH;
    var phi_2282_: SlimbvhTypeH;
    var phi_2283_: SlimbvhTypeH;
    var phi_2284_: bool;
    var phi_2288_: SlimbvhTypeH;
    var phi_2297_: SlimbvhTypeC;
    var phi_2322_: bool;
    var phi_2323_: bool;
    var phi_2330_: SlimbvhTypeK;
    var phi_2336_: SlimbvhTypeK;
    var phi_2337_: SlimbvhTypeK;
    var phi_2338_: SlimbvhTypeK;
    var phi_1516_: SlimbvhTypeK;
    var local_5: u32;
    var local_6: SlimbvhTypeK;
    var phi_2363_: u32;
    var phi_2370_: SlimbvhTypeK;
    var phi_2371_: u32;
    var phi_2372_: u32;
    var phi_1197_: SlimbvhTypeK;
    var phi_1200_: u32;
    var phi_1202_: u32;
    var phi_1204_: u32;
    var local_7: SlimbvhTypeK;
    var phi_2406_: f32;
    var phi_2408_: f32;
    var phi_2409_: bool;
    var phi_2410_: f32;
    var phi_2411_: bool;
    var phi_2599_: u32;
    var phi_2617_: bool;
    var phi_2620_: bool;
    var phi_2633_: f32;
    var phi_2634_: f32;
    var phi_2639_: f32;
    var phi_2640_: f32;
    var phi_2641_: bool;
    var phi_2649_: f32;
    var phi_2426_: f32;
    var phi_2427_: f32;
    var phi_2439_: f32;
    var phi_2444_: SlimbvhTypeC;
    var local_8: SlimbvhTypeK;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e74 = SlimbvhTypeC(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e76 = arrayLength((&slimbvh_nodes.member));
    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
    let _e83 = slimbvh_origin.member;
    let _e89 = slimbvh_origin.member[3u];
    let _e90 = slimbvh_direction.member;
    let _e96 = slimbvh_direction.member[3u];
    let _e99 = slimbvh_exponent.member[0u];
    let _e100 = bitcast<i32>(_e99);
    let _e102 = (bitcast<u32>(_e83.x) & 2147483647u);
    let _e104 = (bitcast<u32>(_e83.y) & 2147483647u);
    let _e106 = (bitcast<u32>(_e83.z) & 2147483647u);
    let _e107 = bitcast<u32>(_e89);
    let _e108 = (_e107 & 2147483647u);
    let _e110 = (bitcast<u32>(_e90.x) & 2147483647u);
    let _e112 = (bitcast<u32>(_e90.y) & 2147483647u);
    let _e114 = (bitcast<u32>(_e90.z) & 2147483647u);
    let _e115 = bitcast<u32>(_e96);
    let _e116 = (_e115 & 2147483647u);
    let _e118 = select(_e112, _e110, (_e112 < _e110));
    let _e120 = select(_e114, _e118, (_e114 < _e118));
    let _e122 = select(_e102, _e120, (_e102 < _e120));
    let _e124 = select(_e104, _e122, (_e104 < _e122));
    let _e126 = select(_e106, _e124, (_e106 < _e124));
    let _e133 = (((select(_e108, _e126, (_e108 < _e126)) < 2139095040u) && (_e116 <= 2139095040u)) && (_e120 > 0u));
    if (_e110 == _e120) {
        phi_363_ = 0u;
    } else {
        phi_363_ = select(2u, 1u, (_e112 == _e120));
    }
    let _e138 = phi_363_;
    let _e139 = (_e138 == 2u);
    if _e139 {
        phi_369_ = 0u;
    } else {
        phi_369_ = (_e138 + 1u);
    }
    let _e142 = phi_369_;
    let _e143 = (_e142 == 2u);
    if _e143 {
        phi_375_ = 0u;
    } else {
        phi_375_ = (_e142 + 1u);
    }
    let _e146 = phi_375_;
    let _e147 = (_e142 == 0u);
    let _e149 = select(select(_e83.y, _e83.x, _e147), _e83.z, _e143);
    let _e150 = (_e146 == 0u);
    let _e152 = (_e146 == 2u);
    let _e153 = select(select(_e83.y, _e83.x, _e150), _e83.z, _e152);
    let _e154 = (_e138 == 0u);
    let _e156 = select(select(_e83.y, _e83.x, _e154), _e83.z, _e139);
    let _e158 = select(select(_e90.y, _e90.x, _e147), _e90.z, _e143);
    let _e160 = select(select(_e90.y, _e90.x, _e150), _e90.z, _e152);
    let _e162 = select(select(_e90.y, _e90.x, _e154), _e90.z, _e139);
    let _e163 = (_e108 - 1u);
    let _e164 = (_e116 - 1u);
    let _e166 = select(_e163, _e164, (_e164 < _e163));
    let _e167 = (_e102 - 1u);
    let _e168 = (_e104 - 1u);
    let _e170 = select(_e167, _e168, (_e168 < _e167));
    let _e171 = (_e106 - 1u);
    let _e173 = select(_e170, _e171, (_e171 < _e170));
    let _e174 = (_e110 - 1u);
    let _e175 = (_e112 - 1u);
    let _e177 = select(_e174, _e175, (_e175 < _e174));
    let _e178 = (_e114 - 1u);
    let _e180 = select(_e177, _e178, (_e178 < _e177));
    let _e182 = select(_e173, _e180, (_e180 < _e173));
    if (((select(_e182, _e166, (_e166 < _e182)) >= 8388607u) && (_e120 < 2130706432u)) && (bitcast<u32>((_e100 + 126i)) <= 253u)) {
        let _e447 = bitcast<i32>((_e120 >> bitcast<u32>(23i)));
        let _e448 = (_e447 - 127i);
        let _e449 = (_e100 + _e448);
        let _e454 = bitcast<f32>((bitcast<u32>((_e100 + 127i)) << bitcast<u32>(23i)));
        let _e459 = bitcast<f32>((bitcast<u32>((254i - _e447)) << bitcast<u32>(23i)));
        if (_e108 >= 2139095040u) {
            phi_537_ = 255i;
        } else {
            phi_537_ = (bitcast<i32>((_e108 >> bitcast<u32>(23i))) + _e449);
        }
        let _e474 = phi_537_;
        if (_e108 == 0u) {
            phi_543_ = 0u;
        } else {
            phi_543_ = (_e108 | 8388608u);
        }
        let _e478 = phi_543_;
        if (_e474 <= 0i) {
            phi_563_ = u32();
            phi_564_ = true;
        } else {
            let _e485 = (_e478 == 0u);
            if _e485 {
                phi_562_ = u32();
            } else {
                phi_562_ = select(((bitcast<u32>(_e474) << bitcast<u32>(23i)) | (_e478 & 8388607u)), 2139095039u, (_e474 >= 255i));
            }
            let _e489 = phi_562_;
            phi_563_ = _e489;
            phi_564_ = _e485;
        }
        let _e491 = phi_563_;
        let _e493 = phi_564_;
        if (_e116 >= 2139095040u) {
            phi_582_ = 255i;
        } else {
            phi_582_ = (bitcast<i32>((_e116 >> bitcast<u32>(23i))) + _e449);
        }
        let _e504 = phi_582_;
        if (_e116 == 0u) {
            phi_588_ = 0u;
        } else {
            phi_588_ = (_e116 | 8388608u);
        }
        let _e508 = phi_588_;
        if (_e504 <= 0i) {
            phi_608_ = u32();
            phi_609_ = true;
        } else {
            let _e515 = (_e508 == 0u);
            if _e515 {
                phi_607_ = u32();
            } else {
                phi_607_ = select(((bitcast<u32>(_e504) << bitcast<u32>(23i)) | (_e508 & 8388607u)), 2139095039u, (_e504 >= 255i));
            }
            let _e519 = phi_607_;
            phi_608_ = _e519;
            phi_609_ = _e515;
        }
        let _e521 = phi_608_;
        let _e523 = phi_609_;
        phi_986_ = SlimbvhTypeF(array<f32, 3>((_e149 * _e454), (_e153 * _e454), (_e156 * _e454)), array<f32, 3>((_e158 * _e459), (_e160 * _e459), (_e162 * _e459)), bitcast<f32>(((_e107 & 2147483648u) | select(_e491, 0u, _e493))), bitcast<f32>(((_e115 & 2147483648u) | select(_e521, 0u, _e523))), _e448);
    } else {
        let _e195 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e120, _e133))) & 2147483647u);
        if (_e195 >= 8388608u) {
            phi_640_ = (bitcast<i32>((_e195 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_640_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e195)), 32u, (_e195 == 0u))));
        }
        let _e209 = phi_640_;
        let _e210 = (_e100 + _e209);
        if (_e100 < -126i) {
            phi_651_ = -126i;
        } else {
            phi_651_ = select(_e100, 127i, (_e100 > 127i));
        }
        let _e215 = phi_651_;
        let _e220 = bitcast<f32>((bitcast<u32>((_e215 + 127i)) << bitcast<u32>(23i)));
        let _e226 = bitcast<f32>((bitcast<u32>(((_e100 - _e215) + 127i)) << bitcast<u32>(23i)));
        let _e227 = bitcast<u32>(_e149);
        let _e229 = ((_e227 & 2139095040u) != 0u);
        let _e244 = bitcast<u32>(_e153);
        let _e246 = ((_e244 & 2139095040u) != 0u);
        let _e261 = bitcast<u32>(_e156);
        let _e263 = ((_e261 & 2139095040u) != 0u);
        let _e279 = -(_e209);
        if (_e279 < -126i) {
            phi_765_ = -126i;
        } else {
            phi_765_ = select(_e279, 127i, (_e279 > 127i));
        }
        let _e284 = phi_765_;
        let _e289 = bitcast<f32>((bitcast<u32>((_e284 + 127i)) << bitcast<u32>(23i)));
        let _e295 = bitcast<f32>((bitcast<u32>(((_e279 - _e284) + 127i)) << bitcast<u32>(23i)));
        let _e296 = bitcast<u32>(_e158);
        let _e298 = ((_e296 & 2139095040u) != 0u);
        let _e313 = bitcast<u32>(_e160);
        let _e315 = ((_e313 & 2139095040u) != 0u);
        let _e330 = bitcast<u32>(_e162);
        let _e332 = ((_e330 & 2139095040u) != 0u);
        let _e354 = ((_e108 & 8388607u) | (select(0u, 1u, ((_e108 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e357 = bitcast<i32>((_e108 >> bitcast<u32>(23i)));
        let _e364 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e354)), 32u, (_e354 == 0u))) - 8i);
        if (_e357 == 255i) {
            phi_894_ = 255i;
        } else {
            phi_894_ = (((_e357 + select(0i, 1i, (_e357 == 0i))) - _e364) + _e210);
        }
        let _e372 = phi_894_;
        let _e376 = (_e354 << bitcast<u32>(((_e364 & 31i) & 31i)));
        if (_e372 <= 0i) {
            phi_917_ = u32();
            phi_918_ = true;
        } else {
            let _e383 = (_e376 == 0u);
            if _e383 {
                phi_916_ = u32();
            } else {
                phi_916_ = select(((bitcast<u32>(_e372) << bitcast<u32>(23i)) | (_e376 & 8388607u)), 2139095039u, (_e372 >= 255i));
            }
            let _e387 = phi_916_;
            phi_917_ = _e387;
            phi_918_ = _e383;
        }
        let _e389 = phi_917_;
        let _e391 = phi_918_;
        let _e402 = ((_e116 & 8388607u) | (select(0u, 1u, ((_e116 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e405 = bitcast<i32>((_e116 >> bitcast<u32>(23i)));
        let _e412 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e402)), 32u, (_e402 == 0u))) - 8i);
        if (_e405 == 255i) {
            phi_952_ = 255i;
        } else {
            phi_952_ = (((_e405 + select(0i, 1i, (_e405 == 0i))) - _e412) + _e210);
        }
        let _e420 = phi_952_;
        let _e424 = (_e402 << bitcast<u32>(((_e412 & 31i) & 31i)));
        if (_e420 <= 0i) {
            phi_975_ = u32();
            phi_976_ = true;
        } else {
            let _e431 = (_e424 == 0u);
            if _e431 {
                phi_974_ = u32();
            } else {
                phi_974_ = select(((bitcast<u32>(_e420) << bitcast<u32>(23i)) | (_e424 & 8388607u)), 2139095039u, (_e420 >= 255i));
            }
            let _e435 = phi_974_;
            phi_975_ = _e435;
            phi_976_ = _e431;
        }
        let _e437 = phi_975_;
        let _e439 = phi_976_;
        phi_986_ = SlimbvhTypeF(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e227 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e227 & 2147483648u))), _e149, _e229) * _e220) * select(0.00000011920929f, 1f, _e229)) * _e226), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e244 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e244 & 2147483648u))), _e153, _e246) * _e220) * select(0.00000011920929f, 1f, _e246)) * _e226), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e261 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e261 & 2147483648u))), _e156, _e263) * _e220) * select(0.00000011920929f, 1f, _e263)) * _e226)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e296 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e296 & 2147483648u))), _e158, _e298) * _e289) * select(0.00000011920929f, 1f, _e298)) * _e295), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e313 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e313 & 2147483648u))), _e160, _e315) * _e289) * select(0.00000011920929f, 1f, _e315)) * _e295), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e330 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e330 & 2147483648u))), _e162, _e332) * _e289) * select(0.00000011920929f, 1f, _e332)) * _e295)), bitcast<f32>(((_e107 & 2147483648u) | select(_e389, 0u, _e391))), bitcast<f32>(((_e115 & 2147483648u) | select(_e437, 0u, _e439))), _e209);
    }
    let _e530 = phi_986_;
    let _e545 = (bitcast<f32>((bitcast<u32>(_e530.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e548 = bitcast<f32>((bitcast<u32>(_e530.member[0]) & 2147483647u));
    let _e549 = (_e548 * 0.00000011920929f);
    let _e552 = select(select(0.00000000000011368684f, _e549, (_e549 > 0.00000000000011368684f)), 0f, _e545);
    let _e553 = select(0f, _e530.member_1[0], _e545);
    let _e554 = (_e530.member[0] + _e552);
    let _e555 = (_e530.member[0] - _e552);
    let _e557 = select(38685626000000000000000000f, (1f / _e530.member_1[0]), _e545);
    let _e561 = (bitcast<f32>((bitcast<u32>(_e530.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e564 = bitcast<f32>((bitcast<u32>(_e530.member[1]) & 2147483647u));
    let _e565 = (_e564 * 0.00000011920929f);
    let _e568 = select(select(0.00000000000011368684f, _e565, (_e565 > 0.00000000000011368684f)), 0f, _e561);
    let _e569 = select(0f, _e530.member_1[1], _e561);
    let _e570 = (_e530.member[1] + _e568);
    let _e571 = (_e530.member[1] - _e568);
    let _e573 = select(38685626000000000000000000f, (1f / _e530.member_1[1]), _e561);
    let _e577 = (bitcast<f32>((bitcast<u32>(_e530.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e580 = bitcast<f32>((bitcast<u32>(_e530.member[2]) & 2147483647u));
    let _e581 = (_e580 * 0.00000011920929f);
    let _e584 = select(select(0.00000000000011368684f, _e581, (_e581 > 0.00000000000011368684f)), 0f, _e577);
    let _e585 = select(0f, _e530.member_1[2], _e577);
    let _e586 = (_e530.member[2] + _e584);
    let _e587 = (_e530.member[2] - _e584);
    let _e589 = select(38685626000000000000000000f, (1f / _e530.member_1[2]), _e577);
    let _e591 = select(_e564, _e548, (_e548 > _e564));
    let _e595 = (_e133 && (select(_e580, _e591, (_e591 > _e580)) <= 1099511600000f));
    let _e596 = select(0f, _e530.member_3, _e595);
    let _e597 = select(1f, _e530.member_2, _e595);
    let _e599 = slimbvh_any_will_do.member;
    if (_e599 == 1u) {
        phi_1181_ = SlimbvhTypeK(SlimbvhTypeG(_e74, _e596), true);
    } else {
        phi_1181_ = SlimbvhTypeK(SlimbvhTypeG(_e74, _e596), false);
    }
    let _e606 = phi_1181_;
    phi_1196_ = _e606;
    phi_1199_ = 0u;
    phi_1201_ = select(4294967295u, 0u, (_e597 <= _e596));
    phi_1203_ = (_e76 + 1u);
    loop {
        let _e615 = phi_1196_;
        let _e617 = phi_1199_;
        let _e619 = phi_1201_;
        let _e621 = phi_1203_;
        local_7 = _e615;
        let _e622 = (_e619 <= 2147483647u);
        if _e622 {
            phi_1212_ = _e617;
            phi_1215_ = _e619;
            phi_1217_ = _e621;
            loop {
                let _e624 = phi_1212_;
                let _e626 = phi_1215_;
                let _e628 = phi_1217_;
                local_3 = _e624;
                local_4 = _e624;
                local_5 = _e626;
                local_9 = _e624;
                local_10 = _e626;
                local_11 = _e628;
                let _e629 = (_e626 <= 2147483647u);
                let _e632 = (_e629 && !((_e624 >= _e76)));
                local_2 = _e629;
                if _e632 {
                    let _e637 = slimbvh_nodes.member[_e624][3u][0u];
                    let _e642 = slimbvh_nodes.member[_e624][3u][1u];
                    let _e647 = slimbvh_nodes.member[_e624][((_e142 & 3u) % 4u)];
                    let _e652 = slimbvh_nodes.member[_e624][((_e146 & 3u) % 4u)];
                    let _e657 = slimbvh_nodes.member[_e624][((_e138 & 3u) % 4u)];
                    let _e658 = bitcast<u32>(_e637);
                    let _e659 = bitcast<u32>(_e642);
                    let _e670 = ((_e647.x - _e554) * _e557);
                    let _e671 = ((_e647.y - _e554) * _e557);
                    let _e672 = ((_e647.z - _e555) * _e557);
                    let _e673 = ((_e647.w - _e555) * _e557);
                    let _e682 = ((_e652.x - _e570) * _e573);
                    let _e683 = ((_e652.y - _e570) * _e573);
                    let _e684 = ((_e652.z - _e571) * _e573);
                    let _e685 = ((_e652.w - _e571) * _e573);
                    let _e694 = ((_e657.x - _e586) * _e589);
                    let _e695 = ((_e657.y - _e586) * _e589);
                    let _e696 = ((_e657.z - _e587) * _e589);
                    let _e697 = ((_e657.w - _e587) * _e589);
                    let _e698 = min(_e694, _e696);
                    let _e699 = min(_e695, _e697);
                    let _e700 = max(_e694, _e696);
                    let _e701 = max(_e695, _e697);
                    let _e726 = max(max(max(min(_e670, _e672), min(_e682, _e684)), _e698), _e597);
                    let _e727 = max(max(max(min(_e671, _e673), min(_e683, _e685)), _e699), _e597);
                    let _e730 = (_e726 <= min((min(min(max(_e670, _e672), max(_e682, _e684)), _e700) + (max(_e700, -(_e698)) * 0.0000019073523f)), _e615.member.member_1));
                    let _e731 = (_e727 <= min((min(min(max(_e671, _e673), max(_e683, _e685)), _e701) + (max(_e701, -(_e699)) * 0.0000019073523f)), _e615.member.member_1));
                    if (_e730 || _e731) {
                        let _e746 = (_e730 && (((_e726 <= _e727) != _e606.member_1) || !(_e731)));
                        if (_e730 && _e731) {
                            let _e751 = (_e626 % 128u);
                            local_1[_e751] = select(_e658, _e659, _e746);
                            local[_e751] = select(_e726, _e727, _e746);
                            phi_1472_ = (_e626 + 1u);
                        } else {
                            phi_1472_ = _e626;
                        }
                        let _e756 = phi_1472_;
                        phi_1498_ = select(_e659, _e658, _e746);
                        phi_1499_ = _e756;
                    } else {
                        let _e735 = (_e626 - 1u);
                        let _e736 = (_e735 % 128u);
                        let _e738 = local[_e736];
                        if (_e738 <= _e615.member.member_1) {
                            let _e741 = local_1[_e736];
                            phi_1497_ = _e741;
                        } else {
                            phi_1497_ = 2147483648u;
                        }
                        let _e743 = phi_1497_;
                        phi_1498_ = _e743;
                        phi_1499_ = _e735;
                    }
                    let _e758 = phi_1498_;
                    let _e760 = phi_1499_;
                    let _e761 = (_e628 - 1u);
                    phi_1213_ = _e758;
                    phi_1216_ = select(_e760, 4294967295u, (_e761 == 0u));
                    phi_1218_ = _e761;
                } else {
                    phi_1213_ = u32();
                    phi_1216_ = u32();
                    phi_1218_ = u32();
                }
                let _e765 = phi_1213_;
                let _e767 = phi_1216_;
                let _e769 = phi_1218_;
                continue;
                continuing {
                    phi_1212_ = _e765;
                    phi_1215_ = _e767;
                    phi_1217_ = _e769;
                    break if !(_e632);
                }
            }
            let _e772 = local_2;
            if _e772 {
                let _e774 = local_3;
                let _e777 = local_4;
                phi_1515_ = _e615;
                phi_1518_ = SlimbvhTypeA(0u, ((_e777 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e783 = phi_1515_;
                    let _e785 = phi_1518_;
                    local_6 = _e783;
                    local_8 = _e783;
                    if (_e785.member < _e785.member_1) {
                        phi_1519_ = SlimbvhTypeA((_e785.member + 1u), _e785.member_1);
                        phi_1541_ = SlimbvhTypeA(1u, _e785.member);
                    } else {
                        phi_1519_ = _e785;
                        phi_1541_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                    }
                    let _e798 = phi_1519_;
                    let _e800 = phi_1541_;
                    let _e804 = (bitcast<i32>(_e800.member) != 0i);
                    if _e804 {
                        let _e805 = ((_e774 & 268435455u) + _e800.member_1);
                        let _e806 = (_e805 / 2u);
                        let _e807 = (_e805 % 2u);
                        let _e808 = (_e806 >= arrayLength((&slimbvh_triangles.member)));
                        if _e808 {
                            phi_1621_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e809 = (2u * _e807);
                            let _e813 = slimbvh_triangles.member[_e806][_e809];
                            let _e818 = slimbvh_triangles.member[_e806][(_e809 + 1u)];
                            let _e823 = slimbvh_triangles.member[_e806][(_e809 + 2u)];
                            if (_e807 == 0u) {
                                phi_1620_ = array<vec4<f32>, 3>(_e813, _e818, _e823);
                            } else {
                                phi_1620_ = array<vec4<f32>, 3>(vec4<f32>(_e813.z, _e813.w, _e818.x, _e818.y), vec4<f32>(_e818.z, _e818.w, _e823.x, _e823.y), vec4<f32>(_e823.z, _e823.w, 0f, 0f));
                            }
                            let _e841 = phi_1620_;
                            phi_1621_ = _e841;
                        }
                        let _e843 = phi_1621_;
                        let _e846 = bitcast<u32>(_e843[2].y);
                        if _e808 {
                            phi_1696_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e847 = (2u * _e807);
                            let _e851 = slimbvh_triangles.member[_e806][_e847];
                            let _e856 = slimbvh_triangles.member[_e806][(_e847 + 1u)];
                            let _e861 = slimbvh_triangles.member[_e806][(_e847 + 2u)];
                            if (_e807 == 0u) {
                                phi_1695_ = array<vec4<f32>, 3>(_e851, _e856, _e861);
                            } else {
                                phi_1695_ = array<vec4<f32>, 3>(vec4<f32>(_e851.z, _e851.w, _e856.x, _e856.y), vec4<f32>(_e856.z, _e856.w, _e861.x, _e861.y), vec4<f32>(_e861.z, _e861.w, 0f, 0f));
                            }
                            let _e879 = phi_1695_;
                            phi_1696_ = _e879;
                        }
                        let _e881 = phi_1696_;
                        if _e147 {
                            phi_1720_ = array<f32, 3>(_e881[0].x, _e881[0].y, _e881[0].z);
                        } else {
                            if (_e142 == 1u) {
                                phi_1719_ = array<f32, 3>(_e881[0].y, _e881[0].z, _e881[0].x);
                            } else {
                                phi_1719_ = array<f32, 3>(_e881[0].z, _e881[0].x, _e881[0].y);
                            }
                            let _e904 = phi_1719_;
                            phi_1720_ = _e904;
                        }
                        let _e907 = phi_1720_;
                        if _e147 {
                            phi_1735_ = array<f32, 3>(_e881[0].w, _e881[1].x, _e881[1].y);
                        } else {
                            if (_e142 == 1u) {
                                phi_1734_ = array<f32, 3>(_e881[1].x, _e881[1].y, _e881[0].w);
                            } else {
                                phi_1734_ = array<f32, 3>(_e881[1].y, _e881[0].w, _e881[1].x);
                            }
                            let _e912 = phi_1734_;
                            phi_1735_ = _e912;
                        }
                        let _e915 = phi_1735_;
                        if _e147 {
                            phi_1750_ = array<f32, 3>(_e881[1].z, _e881[1].w, _e881[2].x);
                        } else {
                            if (_e142 == 1u) {
                                phi_1749_ = array<f32, 3>(_e881[1].w, _e881[2].x, _e881[1].z);
                            } else {
                                phi_1749_ = array<f32, 3>(_e881[2].x, _e881[1].z, _e881[1].w);
                            }
                            let _e920 = phi_1749_;
                            phi_1750_ = _e920;
                        }
                        let _e923 = phi_1750_;
                        let _e937 = (_e907[2] - _e530.member[2]);
                        let _e940 = (((_e907[0] - _e530.member[0]) * _e585) - (_e937 * _e553));
                        let _e943 = (((_e907[1] - _e530.member[1]) * _e585) - (_e937 * _e569));
                        let _e946 = (_e915[2] - _e530.member[2]);
                        let _e949 = (((_e915[0] - _e530.member[0]) * _e585) - (_e946 * _e553));
                        let _e952 = (((_e915[1] - _e530.member[1]) * _e585) - (_e946 * _e569));
                        let _e955 = (_e923[2] - _e530.member[2]);
                        let _e958 = (((_e923[0] - _e530.member[0]) * _e585) - (_e955 * _e553));
                        let _e961 = (((_e923[1] - _e530.member[1]) * _e585) - (_e955 * _e569));
                        let _e962 = (_e958 * _e952);
                        let _e963 = (_e961 * _e949);
                        let _e964 = (_e940 * _e961);
                        let _e965 = (_e943 * _e958);
                        let _e966 = (_e949 * _e943);
                        let _e967 = (_e952 * _e940);
                        let _e972 = (((_e962 >= _e963) && (_e964 >= _e965)) && (_e966 >= _e967));
                        let _e978 = (_e972 || (((_e962 <= _e963) && (_e964 <= _e965)) && (_e966 <= _e967)));
                        if _e978 {
                            let _e980 = select(-1f, 1f, _e972);
                            let _e982 = ((_e962 - _e963) * _e980);
                            let _e984 = select(0f, _e982, (_e982 > 0f));
                            let _e986 = ((_e964 - _e965) * _e980);
                            let _e988 = select(0f, _e986, (_e986 > 0f));
                            let _e990 = ((_e966 - _e967) * _e980);
                            let _e992 = select(0f, _e990, (_e990 > 0f));
                            let _e994 = ((_e984 + _e988) + _e992);
                            let _e1009 = ((min(min(_e907[0], _e915[0]), _e923[0]) - _e554) * _e557);
                            let _e1010 = ((max(max(_e907[0], _e915[0]), _e923[0]) - _e555) * _e557);
                            let _e1013 = ((min(min(_e907[1], _e915[1]), _e923[1]) - _e570) * _e573);
                            let _e1014 = ((max(max(_e907[1], _e915[1]), _e923[1]) - _e571) * _e573);
                            let _e1017 = ((min(min(_e907[2], _e915[2]), _e923[2]) - _e586) * _e589);
                            let _e1018 = ((max(max(_e907[2], _e915[2]), _e923[2]) - _e587) * _e589);
                            let _e1019 = min(_e1017, _e1018);
                            let _e1020 = max(_e1017, _e1018);
                            let _e1024 = max(max(min(_e1009, _e1010), min(_e1013, _e1014)), _e1019);
                            let _e1028 = min(min(max(_e1009, _e1010), max(_e1013, _e1014)), _e1020);
                            let _e1033 = max(_e1024, _e597);
                            let _e1055 = (((((_e978 && (_e994 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e940, _e949), _e958) <= 0f) && (max(max(_e940, _e949), _e958) >= 0f))) && ((min(min(_e943, _e952), _e961) <= 0f) && (max(max(_e943, _e952), _e961) >= 0f))) && (_e1033 <= (_e1028 + (max(_e1020, -(_e1019)) * 0.0000019073523f)))) && (_e1033 <= _e783.member.member_1));
                            if _e1055 {
                                let _e1060 = (_e915[0] - _e907[0]);
                                let _e1061 = (_e915[1] - _e907[1]);
                                let _e1062 = (_e915[2] - _e907[2]);
                                let _e1063 = vec3<f32>(_e1060, _e1061, _e1062);
                                let _e1064 = (_e923[0] - _e915[0]);
                                let _e1065 = (_e923[1] - _e915[1]);
                                let _e1066 = (_e923[2] - _e915[2]);
                                let _e1067 = vec3<f32>(_e1064, _e1065, _e1066);
                                let _e1068 = (_e907[0] - _e923[0]);
                                let _e1069 = (_e907[1] - _e923[1]);
                                let _e1070 = (_e907[2] - _e923[2]);
                                let _e1071 = vec3<f32>(_e1068, _e1069, _e1070);
                                let _e1082 = max(max(bitcast<f32>((bitcast<u32>(_e1060) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1061) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1062) & 2147483647u)));
                                let _e1093 = max(max(bitcast<f32>((bitcast<u32>(_e1064) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1065) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1066) & 2147483647u)));
                                let _e1106 = max(max(_e1082, _e1093), max(max(bitcast<f32>((bitcast<u32>(_e1068) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1069) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1070) & 2147483647u))));
                                if (_e1082 == _e1106) {
                                    phi_2066_ = _e952;
                                    phi_2067_ = _e949;
                                    phi_2068_ = _e943;
                                    phi_2069_ = _e940;
                                    phi_2070_ = vec3<f32>(_e907[0], _e907[1], _e907[2]);
                                    phi_2071_ = _e1071;
                                    phi_2072_ = _e1067;
                                    phi_2073_ = _e1063;
                                } else {
                                    let _e1108 = (_e1093 == _e1106);
                                    let _e1113 = vec3(_e1108);
                                    phi_2066_ = select(_e943, _e961, _e1108);
                                    phi_2067_ = select(_e940, _e958, _e1108);
                                    phi_2068_ = select(_e961, _e952, _e1108);
                                    phi_2069_ = select(_e958, _e949, _e1108);
                                    phi_2070_ = select(vec3<f32>(_e923[0], _e923[1], _e923[2]), vec3<f32>(_e915[0], _e915[1], _e915[2]), _e1113);
                                    phi_2071_ = select(_e1067, _e1063, _e1113);
                                    phi_2072_ = select(_e1063, _e1071, _e1113);
                                    phi_2073_ = select(_e1071, _e1067, _e1113);
                                }
                                let _e1119 = phi_2066_;
                                let _e1121 = phi_2067_;
                                let _e1123 = phi_2068_;
                                let _e1125 = phi_2069_;
                                let _e1127 = phi_2070_;
                                let _e1129 = phi_2071_;
                                let _e1131 = phi_2072_;
                                let _e1133 = phi_2073_;
                                let _e1140 = ((_e1131.y * _e1129.z) - (_e1129.y * _e1131.z));
                                let _e1145 = ((_e1131.z * _e1129.x) - (_e1129.z * _e1131.x));
                                let _e1148 = ((_e1131.x * _e1129.y) - (_e1129.x * _e1131.y));
                                let _e1151 = ((_e984 >= _e988) && (_e984 >= _e992));
                                let _e1152 = (_e988 >= _e992);
                                let _e1166 = (((_e1140 * (select(select(_e923[0], _e915[0], _e1152), _e907[0], _e1151) - _e530.member[0])) + (_e1145 * (select(select(_e923[1], _e915[1], _e1152), _e907[1], _e1151) - _e530.member[1]))) + (_e1148 * (select(select(_e923[2], _e915[2], _e1152), _e907[2], _e1151) - _e530.member[2])));
                                let _e1171 = (((_e1140 * _e553) + (_e1145 * _e569)) + (_e1148 * _e585));
                                let _e1172 = (_e1121 - _e1125);
                                let _e1173 = (_e1119 - _e1123);
                                let _e1176 = ((_e1172 * _e1172) + (_e1173 * _e1173));
                                let _e1183 = (-(((_e1125 * _e1172) + (_e1123 * _e1173))) / select(0.000000000000000000000000000000000000011754944f, _e1176, (_e1176 > 0.000000000000000000000000000000000000011754944f)));
                                let _e1185 = select(1f, _e1183, (_e1183 < 1f));
                                let _e1187 = select(0f, _e1185, (_e1185 > 0f));
                                let _e1196 = ((_e1127.x + (_e1133.x * _e1187)) - _e530.member[0]);
                                let _e1199 = ((_e1127.y + (_e1133.y * _e1187)) - _e530.member[1]);
                                let _e1202 = ((_e1127.z + (_e1133.z * _e1187)) - _e530.member[2]);
                                let _e1267 = ((bitcast<f32>((bitcast<u32>(((((_e1140 * _e1196) + (_e1145 * _e1199)) + (_e1148 * _e1202)) - _e1166)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1196) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1199) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1202) & 2147483647u))), _e1106)) * max(max(bitcast<f32>((bitcast<u32>(_e1140) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1145) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1148) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1171) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1131.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1131.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1131.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1129.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1129.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1129.z) & 2147483647u)))))));
                                let _e1268 = (_e1166 / _e1171);
                                if (_e1055 && !(_e1267)) {
                                    let _e1271 = (_e1202 / _e585);
                                    let _e1279 = (((_e1140 * (_e1196 - (_e553 * _e1271))) + (_e1145 * (_e1199 - (_e569 * _e1271)))) / _e1171);
                                    phi_2252_ = select(select(_e1271, (_e1271 + _e1279), (bitcast<f32>((bitcast<u32>(_e1279) & 2147483647u)) <= _e1106)), _e1268, _e1267);
                                } else {
                                    phi_2252_ = _e1268;
                                }
                                let _e1288 = phi_2252_;
                                let _e1290 = select(_e1028, _e1288, (_e1288 < _e1028));
                                let _e1292 = select(_e1024, _e1290, (_e1290 > _e1024));
                                let _e1295 = select(_e1292, 0f, (bitcast<u32>(_e1292) == 2147483648u));
                                let _e1296 = (1f / _e994);
                                phi_2278_ = SlimbvhTypeH(_e1295, (_e988 * _e1296), (_e992 * _e1296), ((_e1055 && (_e1295 >= _e597)) && (_e1295 <= _e783.member.member_1)));
                                phi_2279_ = SlimbvhTypeH();
                            } else {
                                phi_2278_ = SlimbvhTypeH();
                                phi_2279_ = SlimbvhTypeH(0f, 0f, 0f, _e1055);
                            }
                            let _e1305 = phi_2278_;
                            let _e1307 = phi_2279_;
                            phi_2282_ = _e1305;
                            phi_2283_ = _e1307;
                            phi_2284_ = select(true, false, _e1055);
                        } else {
                            phi_2282_ = SlimbvhTypeH();
                            phi_2283_ = SlimbvhTypeH(0f, 0f, 0f, _e978);
                            phi_2284_ = true;
                        }
                        let _e1310 = phi_2282_;
                        let _e1312 = phi_2283_;
                        let _e1314 = phi_2284_;
                        if _e1314 {
                            phi_2288_ = _e1312;
                        } else {
                            phi_2288_ = _e1310;
                        }
                        let _e1316 = phi_2288_;
                        if _e1316.member_3 {
                            phi_2297_ = SlimbvhTypeC(_e1316.member, _e1316.member_1, _e1316.member_2, _e846);
                        } else {
                            phi_2297_ = _e74;
                        }
                        let _e1323 = phi_2297_;
                        if (_e1323.member_3 != 4294967295u) {
                            if (_e846 != 4294967295u) {
                                if (_e1323.member < _e783.member.member.member) {
                                    phi_2323_ = true;
                                } else {
                                    if (_e1323.member == _e783.member.member.member) {
                                        phi_2322_ = (_e1323.member_3 < _e783.member.member.member_3);
                                    } else {
                                        phi_2322_ = false;
                                    }
                                    let _e1338 = phi_2322_;
                                    phi_2323_ = _e1338;
                                }
                                let _e1340 = phi_2323_;
                                if _e1340 {
                                    phi_2330_ = SlimbvhTypeK(SlimbvhTypeG(_e1323, _e1323.member), _e783.member_1);
                                } else {
                                    phi_2330_ = _e783;
                                }
                                let _e1346 = phi_2330_;
                                if _e1346.member_1 {
                                    phi_2336_ = SlimbvhTypeK(SlimbvhTypeG(_e1346.member.member, bitcast<f32>(4286578687u)), _e1346.member_1);
                                } else {
                                    phi_2336_ = _e1346;
                                }
                                let _e1355 = phi_2336_;
                                phi_2337_ = _e1355;
                            } else {
                                phi_2337_ = _e783;
                            }
                            let _e1357 = phi_2337_;
                            phi_2338_ = _e1357;
                        } else {
                            phi_2338_ = _e783;
                        }
                        let _e1359 = phi_2338_;
                        phi_1516_ = _e1359;
                    } else {
                        phi_1516_ = SlimbvhTypeK();
                    }
                    let _e1361 = phi_1516_;
                    continue;
                    continuing {
                        phi_1515_ = _e1361;
                        phi_1518_ = _e798;
                        break if !(_e804);
                    }
                }
                let _e1364 = local_5;
                let _e1365 = (_e1364 - 1u);
                let _e1366 = (_e1365 % 128u);
                let _e1368 = local[_e1366];
                let _e1370 = local_6;
                if (_e1368 <= _e1370.member.member_1) {
                    let _e1375 = local_1[_e1366];
                    phi_2363_ = _e1375;
                } else {
                    phi_2363_ = 2147483648u;
                }
                let _e1377 = phi_2363_;
                let _e1614 = local_8;
                phi_2370_ = _e1614;
                phi_2371_ = _e1377;
                phi_2372_ = select(_e1365, 4294967295u, (_e597 > _e1370.member.member_1));
            } else {
                phi_2370_ = _e615;
                let _e1617 = local_9;
                phi_2371_ = _e1617;
                let _e1620 = local_10;
                phi_2372_ = _e1620;
            }
            let _e1381 = phi_2370_;
            let _e1383 = phi_2371_;
            let _e1385 = phi_2372_;
            phi_1197_ = _e1381;
            phi_1200_ = _e1383;
            phi_1202_ = _e1385;
            let _e1626 = local_11;
            phi_1204_ = _e1626;
        } else {
            phi_1197_ = SlimbvhTypeK();
            phi_1200_ = u32();
            phi_1202_ = u32();
            phi_1204_ = u32();
        }
        let _e1387 = phi_1197_;
        let _e1389 = phi_1200_;
        let _e1391 = phi_1202_;
        let _e1393 = phi_1204_;
        continue;
        continuing {
            phi_1196_ = _e1387;
            phi_1199_ = _e1389;
            phi_1201_ = _e1391;
            phi_1203_ = _e1393;
            break if !(_e622);
        }
    }
    let _e1396 = local_7;
    if (_e1396.member.member.member_3 != 4294967295u) {
        let _e1402 = -((_e100 + _e530.member_4));
        let _e1403 = bitcast<u32>(_e1396.member.member.member);
        let _e1407 = (bitcast<i32>((_e1403 >> bitcast<u32>(23i))) & 255i);
        let _e1408 = (_e1407 + _e1402);
        if (_e1407 == 255i) {
            phi_2427_ = _e1396.member.member.member;
        } else {
            if (_e1407 > 0i) {
                if (_e1408 > 0i) {
                    let _e1412 = (_e1408 < 255i);
                    if _e1412 {
                        phi_2406_ = bitcast<f32>((_e1403 + bitcast<u32>((_e1402 << bitcast<u32>(23i)))));
                    } else {
                        phi_2406_ = f32();
                    }
                    let _e1419 = phi_2406_;
                    phi_2408_ = _e1419;
                    phi_2409_ = select(true, false, _e1412);
                } else {
                    phi_2408_ = f32();
                    phi_2409_ = true;
                }
                let _e1422 = phi_2408_;
                let _e1424 = phi_2409_;
                phi_2410_ = _e1422;
                phi_2411_ = _e1424;
            } else {
                phi_2410_ = f32();
                phi_2411_ = true;
            }
            let _e1426 = phi_2410_;
            let _e1428 = phi_2411_;
            if _e1428 {
                let _e1429 = (_e1403 & 2147483648u);
                let _e1436 = ((_e1403 & 8388607u) | (select(0u, 1u, ((_e1403 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e1440 = (_e1436 == 0u);
                if _e1440 {
                    phi_2649_ = bitcast<f32>(_e1429);
                } else {
                    let _e1445 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1436)), 32u, _e1440) - 8u);
                    let _e1448 = (_e1436 << bitcast<u32>((_e1445 & 31u)));
                    let _e1450 = ((_e1408 + select(0i, 1i, (_e1407 == 0i))) - bitcast<i32>(_e1445));
                    if (_e1450 >= 255i) {
                        phi_2639_ = bitcast<f32>((_e1429 | 2139095040u));
                        phi_2640_ = f32();
                        phi_2641_ = true;
                    } else {
                        let _e1452 = (_e1450 > 0i);
                        if _e1452 {
                            phi_2633_ = bitcast<f32>(((_e1429 | (bitcast<u32>(_e1450) << bitcast<u32>(23i))) | (_e1448 & 8388607u)));
                            phi_2634_ = f32();
                        } else {
                            if (_e1450 < -24i) {
                                phi_2599_ = 26u;
                            } else {
                                phi_2599_ = bitcast<u32>((1i - _e1450));
                            }
                            let _e1457 = phi_2599_;
                            let _e1458 = (_e1457 & 31u);
                            let _e1460 = (_e1448 >> bitcast<u32>(_e1458));
                            let _e1464 = (_e1448 & ((1u << bitcast<u32>(_e1458)) - 1u));
                            let _e1468 = (1u << bitcast<u32>(((_e1457 - 1u) & 31u)));
                            if (_e1464 > _e1468) {
                                phi_2620_ = true;
                            } else {
                                if (_e1464 == _e1468) {
                                    phi_2617_ = ((_e1460 & 1u) == 1u);
                                } else {
                                    phi_2617_ = false;
                                }
                                let _e1474 = phi_2617_;
                                phi_2620_ = _e1474;
                            }
                            let _e1476 = phi_2620_;
                            phi_2633_ = f32();
                            phi_2634_ = bitcast<f32>((_e1429 | (_e1460 + select(0u, 1u, _e1476))));
                        }
                        let _e1489 = phi_2633_;
                        let _e1491 = phi_2634_;
                        phi_2639_ = _e1489;
                        phi_2640_ = _e1491;
                        phi_2641_ = _e1452;
                    }
                    let _e1495 = phi_2639_;
                    let _e1497 = phi_2640_;
                    let _e1499 = phi_2641_;
                    phi_2649_ = select(_e1497, _e1495, _e1499);
                }
                let _e1503 = phi_2649_;
                phi_2426_ = _e1503;
            } else {
                phi_2426_ = _e1426;
            }
            let _e1505 = phi_2426_;
            phi_2427_ = _e1505;
        }
        let _e1507 = phi_2427_;
        let _e1508 = bitcast<u32>(_e1507);
        if ((_e1508 & 2147483647u) >= 2139095040u) {
            phi_2439_ = bitcast<f32>(((_e1508 & 2147483648u) | 2139095039u));
        } else {
            phi_2439_ = _e1507;
        }
        let _e1515 = phi_2439_;
        phi_2444_ = SlimbvhTypeC(_e1515, _e1396.member.member.member_1, _e1396.member.member.member_2, _e1396.member.member.member_3);
    } else {
        phi_2444_ = _e74;
    }
    let _e1520 = phi_2444_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1520.member), bitcast<u32>(_e1520.member_1), bitcast<u32>(_e1520.member_2), _e1520.member_3);
    return;
}

struct SlimbvhHit {
    t: f32,
    u: f32,
    v: f32,
    primitive: u32,
}

fn slimbvh_closest_hit(origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> SlimbvhHit {
    slimbvh_origin.member = vec4<f32>(origin, t_min);
    slimbvh_direction.member = vec4<f32>(direction, t_max);
    slimbvh_any_will_do.member = 0u;
    slimbvh_trace();
    let hit = slimbvh_hit.member;
    return SlimbvhHit(bitcast<f32>(hit.x), bitcast<f32>(hit.y), bitcast<f32>(hit.z), hit.w);
}

fn slimbvh_any_hit(origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> bool {
    slimbvh_origin.member = vec4<f32>(origin, t_min);
    slimbvh_direction.member = vec4<f32>(direction, t_max);
    slimbvh_any_will_do.member = 1u;
    slimbvh_trace();
    return slimbvh_hit.member.w != 0xffffffffu;
}
