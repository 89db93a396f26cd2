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
    var phi_361_: u32;
    var phi_367_: u32;
    var phi_373_: u32;
    var phi_638_: i32;
    var phi_649_: i32;
    var phi_763_: i32;
    var phi_892_: i32;
    var phi_914_: u32;
    var phi_915_: u32;
    var phi_916_: bool;
    var phi_950_: i32;
    var phi_972_: u32;
    var phi_973_: u32;
    var phi_974_: bool;
    var phi_535_: i32;
    var phi_541_: u32;
    var phi_560_: u32;
    var phi_561_: u32;
    var phi_562_: bool;
    var phi_580_: i32;
    var phi_586_: u32;
    var phi_605_: u32;
    var phi_606_: u32;
    var phi_607_: bool;
    var phi_984_: SlimbvhTypeF;
    var phi_1179_: SlimbvhTypeK;
    var phi_1194_: SlimbvhTypeK;
    var phi_1197_: u32;
    var phi_1199_: u32;
    var phi_1201_: u32;
    var phi_1210_: u32;
    var phi_1213_: u32;
    var phi_1215_: u32;
    var phi_1495_: u32;
    var phi_1470_: u32;
    var phi_1496_: u32;
    var phi_1497_: u32;
    var phi_1211_: u32;
    var phi_1214_: u32;
    var phi_1216_: u32;
    var local_2: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1513_: SlimbvhTypeK;
    var phi_1516_: SlimbvhTypeA;
    var phi_1517_: SlimbvhTypeA;
    var phi_1539_: SlimbvhTypeA;
    var phi_1618_: array<vec4<f32>, 3>;
    var phi_1619_: array<vec4<f32>, 3>;
    var phi_1693_: array<vec4<f32>, 3>;
    var phi_1694_: array<vec4<f32>, 3>;
    var phi_1717_: array<f32, 3>;
    var phi_1718_: array<f32, 3>;
    var phi_1732_: array<f32, 3>;
    var phi_1733_: array<f32, 3>;
    var phi_1747_: array<f32, 3>;
    var phi_1748_: array<f32, 3>;
    var phi_2064_: f32;
    var phi_2065_: f32;
    var phi_2066_: f32;
    var phi_2067_: f32;
    var phi_2068_: vec3<f32>;
    var phi_2069_: vec3<f32>;
    var phi_2070_: vec3<f32>;
    var phi_2071_: vec3<f32>;
    var phi_2250_: f32;
    var phi_2276_: SlimbvhTypeH;
    var phi_2277_: SlimbvhTypeH;
    var phi_2280_: SlimbvhTypeH;
    var phi_2281_: SlimbvhTypeH;
    var phi_2282_: bool;
    var phi_2286_: SlimbvhTypeH;
    var phi_2295_: SlimbvhTypeC;
    var phi_2320_: bool;
    var phi_2321_: bool;
    var phi_2328_: SlimbvhTypeK;
    var phi_2334_: SlimbvhTypeK;
    var phi_2335_: SlimbvhTypeK;
    var phi_2336_: SlimbvhTypeK;
    var phi_1514_: SlimbvhTypeK;
    var local_5: u32;
    var local_6: SlimbvhTypeK;
    var phi_2361_: u32;
    var phi_2368_: SlimbvhTypeK;
    var phi_2369_: u32;
    var phi_2370_: u32;
    var phi_1195_: SlimbvhTypeK;
    var phi_1198_: u32;
    var phi_1200_: u32;
    var phi_1202_: u32;
    var local_7: SlimbvhTypeK;
    var phi_2404_: f32;
    var phi_2406_: f32;
    var phi_2407_: bool;
    var phi_2408_: f32;
    var phi_2409_: bool;
    var phi_2597_: u32;
    var phi_2615_: bool;
    var phi_2618_: bool;
    var phi_2631_: f32;
    var phi_2632_: f32;
    var phi_2637_: f32;
    var phi_2638_: f32;
    var phi_2639_: bool;
    var phi_2647_: f32;
    var phi_2424_: f32;
    var phi_2425_: f32;
    var phi_2437_: f32;
    var phi_2442_: SlimbvhTypeC;
    var local_8: SlimbvhTypeK;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e72 = SlimbvhTypeC(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e74 = arrayLength((&slimbvh_nodes.member));
    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
    let _e81 = slimbvh_origin.member;
    let _e87 = slimbvh_origin.member[3u];
    let _e88 = slimbvh_direction.member;
    let _e94 = slimbvh_direction.member[3u];
    let _e97 = slimbvh_exponent.member[0u];
    let _e98 = bitcast<i32>(_e97);
    let _e100 = (bitcast<u32>(_e81.x) & 2147483647u);
    let _e102 = (bitcast<u32>(_e81.y) & 2147483647u);
    let _e104 = (bitcast<u32>(_e81.z) & 2147483647u);
    let _e105 = bitcast<u32>(_e87);
    let _e106 = (_e105 & 2147483647u);
    let _e108 = (bitcast<u32>(_e88.x) & 2147483647u);
    let _e110 = (bitcast<u32>(_e88.y) & 2147483647u);
    let _e112 = (bitcast<u32>(_e88.z) & 2147483647u);
    let _e113 = bitcast<u32>(_e94);
    let _e114 = (_e113 & 2147483647u);
    let _e116 = select(_e110, _e108, (_e110 < _e108));
    let _e118 = select(_e112, _e116, (_e112 < _e116));
    let _e120 = select(_e100, _e118, (_e100 < _e118));
    let _e122 = select(_e102, _e120, (_e102 < _e120));
    let _e124 = select(_e104, _e122, (_e104 < _e122));
    let _e131 = (((select(_e106, _e124, (_e106 < _e124)) < 2139095040u) && (_e114 <= 2139095040u)) && (_e118 > 0u));
    if (_e108 == _e118) {
        phi_361_ = 0u;
    } else {
        phi_361_ = select(2u, 1u, (_e110 == _e118));
    }
    let _e136 = phi_361_;
    let _e137 = (_e136 == 2u);
    if _e137 {
        phi_367_ = 0u;
    } else {
        phi_367_ = (_e136 + 1u);
    }
    let _e140 = phi_367_;
    let _e141 = (_e140 == 2u);
    if _e141 {
        phi_373_ = 0u;
    } else {
        phi_373_ = (_e140 + 1u);
    }
    let _e144 = phi_373_;
    let _e145 = (_e140 == 0u);
    let _e147 = select(select(_e81.y, _e81.x, _e145), _e81.z, _e141);
    let _e148 = (_e144 == 0u);
    let _e150 = (_e144 == 2u);
    let _e151 = select(select(_e81.y, _e81.x, _e148), _e81.z, _e150);
    let _e152 = (_e136 == 0u);
    let _e154 = select(select(_e81.y, _e81.x, _e152), _e81.z, _e137);
    let _e156 = select(select(_e88.y, _e88.x, _e145), _e88.z, _e141);
    let _e158 = select(select(_e88.y, _e88.x, _e148), _e88.z, _e150);
    let _e160 = select(select(_e88.y, _e88.x, _e152), _e88.z, _e137);
    let _e161 = (_e106 - 1u);
    let _e162 = (_e114 - 1u);
    let _e164 = select(_e161, _e162, (_e162 < _e161));
    let _e165 = (_e100 - 1u);
    let _e166 = (_e102 - 1u);
    let _e168 = select(_e165, _e166, (_e166 < _e165));
    let _e169 = (_e104 - 1u);
    let _e171 = select(_e168, _e169, (_e169 < _e168));
    let _e172 = (_e108 - 1u);
    let _e173 = (_e110 - 1u);
    let _e175 = select(_e172, _e173, (_e173 < _e172));
    let _e176 = (_e112 - 1u);
    let _e178 = select(_e175, _e176, (_e176 < _e175));
    let _e180 = select(_e171, _e178, (_e178 < _e171));
    if ((((select(_e180, _e164, (_e164 < _e180)) >= 8388607u) && (_e118 < 2130706432u)) && (_e98 >= -126i)) && (_e98 <= 127i)) {
        let _e445 = bitcast<i32>((_e118 >> bitcast<u32>(23i)));
        let _e446 = (_e445 - 127i);
        let _e447 = (_e98 + _e446);
        let _e452 = bitcast<f32>((bitcast<u32>((_e98 + 127i)) << bitcast<u32>(23i)));
        let _e457 = bitcast<f32>((bitcast<u32>((254i - _e445)) << bitcast<u32>(23i)));
        if (_e106 >= 2139095040u) {
            phi_535_ = 255i;
        } else {
            phi_535_ = (bitcast<i32>((_e106 >> bitcast<u32>(23i))) + _e447);
        }
        let _e472 = phi_535_;
        if (_e106 == 0u) {
            phi_541_ = 0u;
        } else {
            phi_541_ = (_e106 | 8388608u);
        }
        let _e476 = phi_541_;
        if (_e472 <= 0i) {
            phi_561_ = u32();
            phi_562_ = true;
        } else {
            let _e483 = (_e476 == 0u);
            if _e483 {
                phi_560_ = u32();
            } else {
                phi_560_ = select(((bitcast<u32>(_e472) << bitcast<u32>(23i)) | (_e476 & 8388607u)), 2139095039u, (_e472 >= 255i));
            }
            let _e487 = phi_560_;
            phi_561_ = _e487;
            phi_562_ = _e483;
        }
        let _e489 = phi_561_;
        let _e491 = phi_562_;
        if (_e114 >= 2139095040u) {
            phi_580_ = 255i;
        } else {
            phi_580_ = (bitcast<i32>((_e114 >> bitcast<u32>(23i))) + _e447);
        }
        let _e502 = phi_580_;
        if (_e114 == 0u) {
            phi_586_ = 0u;
        } else {
            phi_586_ = (_e114 | 8388608u);
        }
        let _e506 = phi_586_;
        if (_e502 <= 0i) {
            phi_606_ = u32();
            phi_607_ = true;
        } else {
            let _e513 = (_e506 == 0u);
            if _e513 {
                phi_605_ = u32();
            } else {
                phi_605_ = select(((bitcast<u32>(_e502) << bitcast<u32>(23i)) | (_e506 & 8388607u)), 2139095039u, (_e502 >= 255i));
            }
            let _e517 = phi_605_;
            phi_606_ = _e517;
            phi_607_ = _e513;
        }
        let _e519 = phi_606_;
        let _e521 = phi_607_;
        phi_984_ = SlimbvhTypeF(array<f32, 3>((_e147 * _e452), (_e151 * _e452), (_e154 * _e452)), array<f32, 3>((_e156 * _e457), (_e158 * _e457), (_e160 * _e457)), bitcast<f32>(((_e105 & 2147483648u) | select(_e489, 0u, _e491))), bitcast<f32>(((_e113 & 2147483648u) | select(_e519, 0u, _e521))), _e446);
    } else {
        let _e193 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e118, _e131))) & 2147483647u);
        if (_e193 >= 8388608u) {
            phi_638_ = (bitcast<i32>((_e193 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_638_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e193)), 32u, (_e193 == 0u))));
        }
        let _e207 = phi_638_;
        let _e208 = (_e98 + _e207);
        if (_e98 < -126i) {
            phi_649_ = -126i;
        } else {
            phi_649_ = select(_e98, 127i, (_e98 > 127i));
        }
        let _e213 = phi_649_;
        let _e218 = bitcast<f32>((bitcast<u32>((_e213 + 127i)) << bitcast<u32>(23i)));
        let _e224 = bitcast<f32>((bitcast<u32>(((_e98 - _e213) + 127i)) << bitcast<u32>(23i)));
        let _e225 = bitcast<u32>(_e147);
        let _e227 = ((_e225 & 2139095040u) != 0u);
        let _e242 = bitcast<u32>(_e151);
        let _e244 = ((_e242 & 2139095040u) != 0u);
        let _e259 = bitcast<u32>(_e154);
        let _e261 = ((_e259 & 2139095040u) != 0u);
        let _e277 = -(_e207);
        if (_e277 < -126i) {
            phi_763_ = -126i;
        } else {
            phi_763_ = select(_e277, 127i, (_e277 > 127i));
        }
        let _e282 = phi_763_;
        let _e287 = bitcast<f32>((bitcast<u32>((_e282 + 127i)) << bitcast<u32>(23i)));
        let _e293 = bitcast<f32>((bitcast<u32>(((_e277 - _e282) + 127i)) << bitcast<u32>(23i)));
        let _e294 = bitcast<u32>(_e156);
        let _e296 = ((_e294 & 2139095040u) != 0u);
        let _e311 = bitcast<u32>(_e158);
        let _e313 = ((_e311 & 2139095040u) != 0u);
        let _e328 = bitcast<u32>(_e160);
        let _e330 = ((_e328 & 2139095040u) != 0u);
        let _e352 = ((_e106 & 8388607u) | (select(0u, 1u, ((_e106 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e355 = bitcast<i32>((_e106 >> bitcast<u32>(23i)));
        let _e362 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e352)), 32u, (_e352 == 0u))) - 8i);
        if (_e355 == 255i) {
            phi_892_ = 255i;
        } else {
            phi_892_ = (((_e355 + select(0i, 1i, (_e355 == 0i))) - _e362) + _e208);
        }
        let _e370 = phi_892_;
        let _e374 = (_e352 << bitcast<u32>(((_e362 & 31i) & 31i)));
        if (_e370 <= 0i) {
            phi_915_ = u32();
            phi_916_ = true;
        } else {
            let _e381 = (_e374 == 0u);
            if _e381 {
                phi_914_ = u32();
            } else {
                phi_914_ = select(((bitcast<u32>(_e370) << bitcast<u32>(23i)) | (_e374 & 8388607u)), 2139095039u, (_e370 >= 255i));
            }
            let _e385 = phi_914_;
            phi_915_ = _e385;
            phi_916_ = _e381;
        }
        let _e387 = phi_915_;
        let _e389 = phi_916_;
        let _e400 = ((_e114 & 8388607u) | (select(0u, 1u, ((_e114 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e403 = bitcast<i32>((_e114 >> bitcast<u32>(23i)));
        let _e410 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e400)), 32u, (_e400 == 0u))) - 8i);
        if (_e403 == 255i) {
            phi_950_ = 255i;
        } else {
            phi_950_ = (((_e403 + select(0i, 1i, (_e403 == 0i))) - _e410) + _e208);
        }
        let _e418 = phi_950_;
        let _e422 = (_e400 << bitcast<u32>(((_e410 & 31i) & 31i)));
        if (_e418 <= 0i) {
            phi_973_ = u32();
            phi_974_ = true;
        } else {
            let _e429 = (_e422 == 0u);
            if _e429 {
                phi_972_ = u32();
            } else {
                phi_972_ = select(((bitcast<u32>(_e418) << bitcast<u32>(23i)) | (_e422 & 8388607u)), 2139095039u, (_e418 >= 255i));
            }
            let _e433 = phi_972_;
            phi_973_ = _e433;
            phi_974_ = _e429;
        }
        let _e435 = phi_973_;
        let _e437 = phi_974_;
        phi_984_ = SlimbvhTypeF(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e225 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e225 & 2147483648u))), _e147, _e227) * _e218) * select(0.00000011920929f, 1f, _e227)) * _e224), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e242 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e242 & 2147483648u))), _e151, _e244) * _e218) * select(0.00000011920929f, 1f, _e244)) * _e224), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e259 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e259 & 2147483648u))), _e154, _e261) * _e218) * select(0.00000011920929f, 1f, _e261)) * _e224)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e294 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e294 & 2147483648u))), _e156, _e296) * _e287) * select(0.00000011920929f, 1f, _e296)) * _e293), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e311 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e311 & 2147483648u))), _e158, _e313) * _e287) * select(0.00000011920929f, 1f, _e313)) * _e293), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e328 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e328 & 2147483648u))), _e160, _e330) * _e287) * select(0.00000011920929f, 1f, _e330)) * _e293)), bitcast<f32>(((_e105 & 2147483648u) | select(_e387, 0u, _e389))), bitcast<f32>(((_e113 & 2147483648u) | select(_e435, 0u, _e437))), _e207);
    }
    let _e528 = phi_984_;
    let _e543 = (bitcast<f32>((bitcast<u32>(_e528.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e546 = bitcast<f32>((bitcast<u32>(_e528.member[0]) & 2147483647u));
    let _e547 = (_e546 * 0.00000011920929f);
    let _e550 = select(select(0.00000000000011368684f, _e547, (_e547 > 0.00000000000011368684f)), 0f, _e543);
    let _e551 = select(0f, _e528.member_1[0], _e543);
    let _e552 = (_e528.member[0] + _e550);
    let _e553 = (_e528.member[0] - _e550);
    let _e555 = select(38685626000000000000000000f, (1f / _e528.member_1[0]), _e543);
    let _e559 = (bitcast<f32>((bitcast<u32>(_e528.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e562 = bitcast<f32>((bitcast<u32>(_e528.member[1]) & 2147483647u));
    let _e563 = (_e562 * 0.00000011920929f);
    let _e566 = select(select(0.00000000000011368684f, _e563, (_e563 > 0.00000000000011368684f)), 0f, _e559);
    let _e567 = select(0f, _e528.member_1[1], _e559);
    let _e568 = (_e528.member[1] + _e566);
    let _e569 = (_e528.member[1] - _e566);
    let _e571 = select(38685626000000000000000000f, (1f / _e528.member_1[1]), _e559);
    let _e575 = (bitcast<f32>((bitcast<u32>(_e528.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e578 = bitcast<f32>((bitcast<u32>(_e528.member[2]) & 2147483647u));
    let _e579 = (_e578 * 0.00000011920929f);
    let _e582 = select(select(0.00000000000011368684f, _e579, (_e579 > 0.00000000000011368684f)), 0f, _e575);
    let _e583 = select(0f, _e528.member_1[2], _e575);
    let _e584 = (_e528.member[2] + _e582);
    let _e585 = (_e528.member[2] - _e582);
    let _e587 = select(38685626000000000000000000f, (1f / _e528.member_1[2]), _e575);
    let _e589 = select(_e562, _e546, (_e546 > _e562));
    let _e593 = (_e131 && (select(_e578, _e589, (_e589 > _e578)) <= 1099511600000f));
    let _e594 = select(0f, _e528.member_3, _e593);
    let _e595 = select(1f, _e528.member_2, _e593);
    let _e597 = slimbvh_any_will_do.member;
    if (_e597 == 1u) {
        phi_1179_ = SlimbvhTypeK(SlimbvhTypeG(_e72, _e594), true);
    } else {
        phi_1179_ = SlimbvhTypeK(SlimbvhTypeG(_e72, _e594), false);
    }
    let _e604 = phi_1179_;
    phi_1194_ = _e604;
    phi_1197_ = 0u;
    phi_1199_ = select(4294967295u, 0u, (_e595 <= _e594));
    phi_1201_ = (_e74 + 1u);
    loop {
        let _e613 = phi_1194_;
        let _e615 = phi_1197_;
        let _e617 = phi_1199_;
        let _e619 = phi_1201_;
        local_7 = _e613;
        let _e620 = (_e617 <= 2147483647u);
        if _e620 {
            phi_1210_ = _e615;
            phi_1213_ = _e617;
            phi_1215_ = _e619;
            loop {
                let _e622 = phi_1210_;
                let _e624 = phi_1213_;
                let _e626 = phi_1215_;
                local_3 = _e622;
                local_4 = _e622;
                local_5 = _e624;
                local_9 = _e622;
                local_10 = _e624;
                local_11 = _e626;
                let _e627 = (_e624 <= 2147483647u);
                let _e630 = (_e627 && !((_e622 >= _e74)));
                local_2 = _e627;
                if _e630 {
                    let _e635 = slimbvh_nodes.member[_e622][3u][0u];
                    let _e640 = slimbvh_nodes.member[_e622][3u][1u];
                    let _e645 = slimbvh_nodes.member[_e622][((_e140 & 3u) % 4u)];
                    let _e650 = slimbvh_nodes.member[_e622][((_e144 & 3u) % 4u)];
                    let _e655 = slimbvh_nodes.member[_e622][((_e136 & 3u) % 4u)];
                    let _e656 = bitcast<u32>(_e635);
                    let _e657 = bitcast<u32>(_e640);
                    let _e668 = ((_e645.x - _e552) * _e555);
                    let _e669 = ((_e645.y - _e552) * _e555);
                    let _e670 = ((_e645.z - _e553) * _e555);
                    let _e671 = ((_e645.w - _e553) * _e555);
                    let _e680 = ((_e650.x - _e568) * _e571);
                    let _e681 = ((_e650.y - _e568) * _e571);
                    let _e682 = ((_e650.z - _e569) * _e571);
                    let _e683 = ((_e650.w - _e569) * _e571);
                    let _e692 = ((_e655.x - _e584) * _e587);
                    let _e693 = ((_e655.y - _e584) * _e587);
                    let _e694 = ((_e655.z - _e585) * _e587);
                    let _e695 = ((_e655.w - _e585) * _e587);
                    let _e696 = min(_e692, _e694);
                    let _e697 = min(_e693, _e695);
                    let _e698 = max(_e692, _e694);
                    let _e699 = max(_e693, _e695);
                    let _e724 = max(max(max(min(_e668, _e670), min(_e680, _e682)), _e696), _e595);
                    let _e725 = max(max(max(min(_e669, _e671), min(_e681, _e683)), _e697), _e595);
                    let _e728 = (_e724 <= min((min(min(max(_e668, _e670), max(_e680, _e682)), _e698) + (max(_e698, -(_e696)) * 0.0000019073523f)), _e613.member.member_1));
                    let _e729 = (_e725 <= min((min(min(max(_e669, _e671), max(_e681, _e683)), _e699) + (max(_e699, -(_e697)) * 0.0000019073523f)), _e613.member.member_1));
                    if (_e728 || _e729) {
                        let _e744 = (_e728 && (((_e724 <= _e725) != _e604.member_1) || !(_e729)));
                        if (_e728 && _e729) {
                            let _e749 = (_e624 % 128u);
                            local_1[_e749] = select(_e656, _e657, _e744);
                            local[_e749] = select(_e724, _e725, _e744);
                            phi_1470_ = (_e624 + 1u);
                        } else {
                            phi_1470_ = _e624;
                        }
                        let _e754 = phi_1470_;
                        phi_1496_ = select(_e657, _e656, _e744);
                        phi_1497_ = _e754;
                    } else {
                        let _e733 = (_e624 - 1u);
                        let _e734 = (_e733 % 128u);
                        let _e736 = local[_e734];
                        if (_e736 <= _e613.member.member_1) {
                            let _e739 = local_1[_e734];
                            phi_1495_ = _e739;
                        } else {
                            phi_1495_ = 2147483648u;
                        }
                        let _e741 = phi_1495_;
                        phi_1496_ = _e741;
                        phi_1497_ = _e733;
                    }
                    let _e756 = phi_1496_;
                    let _e758 = phi_1497_;
                    let _e759 = (_e626 - 1u);
                    phi_1211_ = _e756;
                    phi_1214_ = select(_e758, 4294967295u, (_e759 == 0u));
                    phi_1216_ = _e759;
                } else {
                    phi_1211_ = u32();
                    phi_1214_ = u32();
                    phi_1216_ = u32();
                }
                let _e763 = phi_1211_;
                let _e765 = phi_1214_;
                let _e767 = phi_1216_;
                continue;
                continuing {
                    phi_1210_ = _e763;
                    phi_1213_ = _e765;
                    phi_1215_ = _e767;
                    break if !(_e630);
                }
            }
            let _e770 = local_2;
            if _e770 {
                let _e772 = local_3;
                let _e775 = local_4;
                phi_1513_ = _e613;
                phi_1516_ = SlimbvhTypeA(0u, ((_e775 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e781 = phi_1513_;
                    let _e783 = phi_1516_;
                    local_6 = _e781;
                    local_8 = _e781;
                    if (_e783.member < _e783.member_1) {
                        phi_1517_ = SlimbvhTypeA((_e783.member + 1u), _e783.member_1);
                        phi_1539_ = SlimbvhTypeA(1u, _e783.member);
                    } else {
                        phi_1517_ = _e783;
                        phi_1539_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                    }
                    let _e796 = phi_1517_;
                    let _e798 = phi_1539_;
                    let _e802 = (bitcast<i32>(_e798.member) != 0i);
                    if _e802 {
                        let _e803 = ((_e772 & 268435455u) + _e798.member_1);
                        let _e804 = (_e803 / 2u);
                        let _e805 = (_e803 % 2u);
                        let _e806 = (_e804 >= arrayLength((&slimbvh_triangles.member)));
                        if _e806 {
                            phi_1619_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e807 = (2u * _e805);
                            let _e811 = slimbvh_triangles.member[_e804][_e807];
                            let _e816 = slimbvh_triangles.member[_e804][(_e807 + 1u)];
                            let _e821 = slimbvh_triangles.member[_e804][(_e807 + 2u)];
                            if (_e805 == 0u) {
                                phi_1618_ = array<vec4<f32>, 3>(_e811, _e816, _e821);
                            } else {
                                phi_1618_ = array<vec4<f32>, 3>(vec4<f32>(_e811.z, _e811.w, _e816.x, _e816.y), vec4<f32>(_e816.z, _e816.w, _e821.x, _e821.y), vec4<f32>(_e821.z, _e821.w, 0f, 0f));
                            }
                            let _e839 = phi_1618_;
                            phi_1619_ = _e839;
                        }
                        let _e841 = phi_1619_;
                        let _e844 = bitcast<u32>(_e841[2].y);
                        if _e806 {
                            phi_1694_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e845 = (2u * _e805);
                            let _e849 = slimbvh_triangles.member[_e804][_e845];
                            let _e854 = slimbvh_triangles.member[_e804][(_e845 + 1u)];
                            let _e859 = slimbvh_triangles.member[_e804][(_e845 + 2u)];
                            if (_e805 == 0u) {
                                phi_1693_ = array<vec4<f32>, 3>(_e849, _e854, _e859);
                            } else {
                                phi_1693_ = array<vec4<f32>, 3>(vec4<f32>(_e849.z, _e849.w, _e854.x, _e854.y), vec4<f32>(_e854.z, _e854.w, _e859.x, _e859.y), vec4<f32>(_e859.z, _e859.w, 0f, 0f));
                            }
                            let _e877 = phi_1693_;
                            phi_1694_ = _e877;
                        }
                        let _e879 = phi_1694_;
                        if _e145 {
                            phi_1718_ = array<f32, 3>(_e879[0].x, _e879[0].y, _e879[0].z);
                        } else {
                            if (_e140 == 1u) {
                                phi_1717_ = array<f32, 3>(_e879[0].y, _e879[0].z, _e879[0].x);
                            } else {
                                phi_1717_ = array<f32, 3>(_e879[0].z, _e879[0].x, _e879[0].y);
                            }
                            let _e902 = phi_1717_;
                            phi_1718_ = _e902;
                        }
                        let _e905 = phi_1718_;
                        if _e145 {
                            phi_1733_ = array<f32, 3>(_e879[0].w, _e879[1].x, _e879[1].y);
                        } else {
                            if (_e140 == 1u) {
                                phi_1732_ = array<f32, 3>(_e879[1].x, _e879[1].y, _e879[0].w);
                            } else {
                                phi_1732_ = array<f32, 3>(_e879[1].y, _e879[0].w, _e879[1].x);
                            }
                            let _e910 = phi_1732_;
                            phi_1733_ = _e910;
                        }
                        let _e913 = phi_1733_;
                        if _e145 {
                            phi_1748_ = array<f32, 3>(_e879[1].z, _e879[1].w, _e879[2].x);
                        } else {
                            if (_e140 == 1u) {
                                phi_1747_ = array<f32, 3>(_e879[1].w, _e879[2].x, _e879[1].z);
                            } else {
                                phi_1747_ = array<f32, 3>(_e879[2].x, _e879[1].z, _e879[1].w);
                            }
                            let _e918 = phi_1747_;
                            phi_1748_ = _e918;
                        }
                        let _e921 = phi_1748_;
                        let _e935 = (_e905[2] - _e528.member[2]);
                        let _e938 = (((_e905[0] - _e528.member[0]) * _e583) - (_e935 * _e551));
                        let _e941 = (((_e905[1] - _e528.member[1]) * _e583) - (_e935 * _e567));
                        let _e944 = (_e913[2] - _e528.member[2]);
                        let _e947 = (((_e913[0] - _e528.member[0]) * _e583) - (_e944 * _e551));
                        let _e950 = (((_e913[1] - _e528.member[1]) * _e583) - (_e944 * _e567));
                        let _e953 = (_e921[2] - _e528.member[2]);
                        let _e956 = (((_e921[0] - _e528.member[0]) * _e583) - (_e953 * _e551));
                        let _e959 = (((_e921[1] - _e528.member[1]) * _e583) - (_e953 * _e567));
                        let _e960 = (_e956 * _e950);
                        let _e961 = (_e959 * _e947);
                        let _e962 = (_e938 * _e959);
                        let _e963 = (_e941 * _e956);
                        let _e964 = (_e947 * _e941);
                        let _e965 = (_e950 * _e938);
                        let _e970 = (((_e960 >= _e961) && (_e962 >= _e963)) && (_e964 >= _e965));
                        let _e976 = (_e970 || (((_e960 <= _e961) && (_e962 <= _e963)) && (_e964 <= _e965)));
                        if _e976 {
                            let _e978 = select(-1f, 1f, _e970);
                            let _e980 = ((_e960 - _e961) * _e978);
                            let _e982 = select(0f, _e980, (_e980 > 0f));
                            let _e984 = ((_e962 - _e963) * _e978);
                            let _e986 = select(0f, _e984, (_e984 > 0f));
                            let _e988 = ((_e964 - _e965) * _e978);
                            let _e990 = select(0f, _e988, (_e988 > 0f));
                            let _e992 = ((_e982 + _e986) + _e990);
                            let _e1007 = ((min(min(_e905[0], _e913[0]), _e921[0]) - _e552) * _e555);
                            let _e1008 = ((max(max(_e905[0], _e913[0]), _e921[0]) - _e553) * _e555);
                            let _e1011 = ((min(min(_e905[1], _e913[1]), _e921[1]) - _e568) * _e571);
                            let _e1012 = ((max(max(_e905[1], _e913[1]), _e921[1]) - _e569) * _e571);
                            let _e1015 = ((min(min(_e905[2], _e913[2]), _e921[2]) - _e584) * _e587);
                            let _e1016 = ((max(max(_e905[2], _e913[2]), _e921[2]) - _e585) * _e587);
                            let _e1017 = min(_e1015, _e1016);
                            let _e1018 = max(_e1015, _e1016);
                            let _e1022 = max(max(min(_e1007, _e1008), min(_e1011, _e1012)), _e1017);
                            let _e1026 = min(min(max(_e1007, _e1008), max(_e1011, _e1012)), _e1018);
                            let _e1031 = max(_e1022, _e595);
                            let _e1053 = (((((_e976 && (_e992 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e938, _e947), _e956) <= 0f) && (max(max(_e938, _e947), _e956) >= 0f))) && ((min(min(_e941, _e950), _e959) <= 0f) && (max(max(_e941, _e950), _e959) >= 0f))) && (_e1031 <= (_e1026 + (max(_e1018, -(_e1017)) * 0.0000019073523f)))) && (_e1031 <= _e781.member.member_1));
                            if _e1053 {
                                let _e1058 = (_e913[0] - _e905[0]);
                                let _e1059 = (_e913[1] - _e905[1]);
                                let _e1060 = (_e913[2] - _e905[2]);
                                let _e1061 = vec3<f32>(_e1058, _e1059, _e1060);
                                let _e1062 = (_e921[0] - _e913[0]);
                                let _e1063 = (_e921[1] - _e913[1]);
                                let _e1064 = (_e921[2] - _e913[2]);
                                let _e1065 = vec3<f32>(_e1062, _e1063, _e1064);
                                let _e1066 = (_e905[0] - _e921[0]);
                                let _e1067 = (_e905[1] - _e921[1]);
                                let _e1068 = (_e905[2] - _e921[2]);
                                let _e1069 = vec3<f32>(_e1066, _e1067, _e1068);
                                let _e1080 = max(max(bitcast<f32>((bitcast<u32>(_e1058) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1059) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1060) & 2147483647u)));
                                let _e1091 = max(max(bitcast<f32>((bitcast<u32>(_e1062) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1063) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1064) & 2147483647u)));
                                let _e1104 = max(max(_e1080, _e1091), max(max(bitcast<f32>((bitcast<u32>(_e1066) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1067) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1068) & 2147483647u))));
                                if (_e1080 == _e1104) {
                                    phi_2064_ = _e950;
                                    phi_2065_ = _e947;
                                    phi_2066_ = _e941;
                                    phi_2067_ = _e938;
                                    phi_2068_ = vec3<f32>(_e905[0], _e905[1], _e905[2]);
                                    phi_2069_ = _e1069;
                                    phi_2070_ = _e1065;
                                    phi_2071_ = _e1061;
                                } else {
                                    let _e1106 = (_e1091 == _e1104);
                                    let _e1111 = vec3(_e1106);
                                    phi_2064_ = select(_e941, _e959, _e1106);
                                    phi_2065_ = select(_e938, _e956, _e1106);
                                    phi_2066_ = select(_e959, _e950, _e1106);
                                    phi_2067_ = select(_e956, _e947, _e1106);
                                    phi_2068_ = select(vec3<f32>(_e921[0], _e921[1], _e921[2]), vec3<f32>(_e913[0], _e913[1], _e913[2]), _e1111);
                                    phi_2069_ = select(_e1065, _e1061, _e1111);
                                    phi_2070_ = select(_e1061, _e1069, _e1111);
                                    phi_2071_ = select(_e1069, _e1065, _e1111);
                                }
                                let _e1117 = phi_2064_;
                                let _e1119 = phi_2065_;
                                let _e1121 = phi_2066_;
                                let _e1123 = phi_2067_;
                                let _e1125 = phi_2068_;
                                let _e1127 = phi_2069_;
                                let _e1129 = phi_2070_;
                                let _e1131 = phi_2071_;
                                let _e1138 = ((_e1129.y * _e1127.z) - (_e1127.y * _e1129.z));
                                let _e1143 = ((_e1129.z * _e1127.x) - (_e1127.z * _e1129.x));
                                let _e1146 = ((_e1129.x * _e1127.y) - (_e1127.x * _e1129.y));
                                let _e1149 = ((_e982 >= _e986) && (_e982 >= _e990));
                                let _e1150 = (_e986 >= _e990);
                                let _e1164 = (((_e1138 * (select(select(_e921[0], _e913[0], _e1150), _e905[0], _e1149) - _e528.member[0])) + (_e1143 * (select(select(_e921[1], _e913[1], _e1150), _e905[1], _e1149) - _e528.member[1]))) + (_e1146 * (select(select(_e921[2], _e913[2], _e1150), _e905[2], _e1149) - _e528.member[2])));
                                let _e1169 = (((_e1138 * _e551) + (_e1143 * _e567)) + (_e1146 * _e583));
                                let _e1170 = (_e1119 - _e1123);
                                let _e1171 = (_e1117 - _e1121);
                                let _e1174 = ((_e1170 * _e1170) + (_e1171 * _e1171));
                                let _e1181 = (-(((_e1123 * _e1170) + (_e1121 * _e1171))) / select(0.000000000000000000000000000000000000011754944f, _e1174, (_e1174 > 0.000000000000000000000000000000000000011754944f)));
                                let _e1183 = select(1f, _e1181, (_e1181 < 1f));
                                let _e1185 = select(0f, _e1183, (_e1183 > 0f));
                                let _e1194 = ((_e1125.x + (_e1131.x * _e1185)) - _e528.member[0]);
                                let _e1197 = ((_e1125.y + (_e1131.y * _e1185)) - _e528.member[1]);
                                let _e1200 = ((_e1125.z + (_e1131.z * _e1185)) - _e528.member[2]);
                                let _e1265 = ((bitcast<f32>((bitcast<u32>(((((_e1138 * _e1194) + (_e1143 * _e1197)) + (_e1146 * _e1200)) - _e1164)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1194) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1197) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1200) & 2147483647u))), _e1104)) * max(max(bitcast<f32>((bitcast<u32>(_e1138) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1143) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1146) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1169) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1129.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1129.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1129.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1127.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1127.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1127.z) & 2147483647u)))))));
                                let _e1266 = (_e1164 / _e1169);
                                if (_e1053 && !(_e1265)) {
                                    let _e1269 = (_e1200 / _e583);
                                    let _e1277 = (((_e1138 * (_e1194 - (_e551 * _e1269))) + (_e1143 * (_e1197 - (_e567 * _e1269)))) / _e1169);
                                    phi_2250_ = select(select(_e1269, (_e1269 + _e1277), (bitcast<f32>((bitcast<u32>(_e1277) & 2147483647u)) <= _e1104)), _e1266, _e1265);
                                } else {
                                    phi_2250_ = _e1266;
                                }
                                let _e1286 = phi_2250_;
                                let _e1288 = select(_e1026, _e1286, (_e1286 < _e1026));
                                let _e1290 = select(_e1022, _e1288, (_e1288 > _e1022));
                                let _e1293 = select(_e1290, 0f, (bitcast<u32>(_e1290) == 2147483648u));
                                let _e1294 = (1f / _e992);
                                phi_2276_ = SlimbvhTypeH(_e1293, (_e986 * _e1294), (_e990 * _e1294), ((_e1053 && (_e1293 >= _e595)) && (_e1293 <= _e781.member.member_1)));
                                phi_2277_ = SlimbvhTypeH();
                            } else {
                                phi_2276_ = SlimbvhTypeH();
                                phi_2277_ = SlimbvhTypeH(0f, 0f, 0f, _e1053);
                            }
                            let _e1303 = phi_2276_;
                            let _e1305 = phi_2277_;
                            phi_2280_ = _e1303;
                            phi_2281_ = _e1305;
                            phi_2282_ = select(true, false, _e1053);
                        } else {
                            phi_2280_ = SlimbvhTypeH();
                            phi_2281_ = SlimbvhTypeH(0f, 0f, 0f, _e976);
                            phi_2282_ = true;
                        }
                        let _e1308 = phi_2280_;
                        let _e1310 = phi_2281_;
                        let _e1312 = phi_2282_;
                        if _e1312 {
                            phi_2286_ = _e1310;
                        } else {
                            phi_2286_ = _e1308;
                        }
                        let _e1314 = phi_2286_;
                        if _e1314.member_3 {
                            phi_2295_ = SlimbvhTypeC(_e1314.member, _e1314.member_1, _e1314.member_2, _e844);
                        } else {
                            phi_2295_ = _e72;
                        }
                        let _e1321 = phi_2295_;
                        if (_e1321.member_3 != 4294967295u) {
                            if (_e844 != 4294967295u) {
                                if (_e1321.member < _e781.member.member.member) {
                                    phi_2321_ = true;
                                } else {
                                    if (_e1321.member == _e781.member.member.member) {
                                        phi_2320_ = (_e1321.member_3 < _e781.member.member.member_3);
                                    } else {
                                        phi_2320_ = false;
                                    }
                                    let _e1336 = phi_2320_;
                                    phi_2321_ = _e1336;
                                }
                                let _e1338 = phi_2321_;
                                if _e1338 {
                                    phi_2328_ = SlimbvhTypeK(SlimbvhTypeG(_e1321, _e1321.member), _e781.member_1);
                                } else {
                                    phi_2328_ = _e781;
                                }
                                let _e1344 = phi_2328_;
                                if _e1344.member_1 {
                                    phi_2334_ = SlimbvhTypeK(SlimbvhTypeG(_e1344.member.member, bitcast<f32>(4286578687u)), _e1344.member_1);
                                } else {
                                    phi_2334_ = _e1344;
                                }
                                let _e1353 = phi_2334_;
                                phi_2335_ = _e1353;
                            } else {
                                phi_2335_ = _e781;
                            }
                            let _e1355 = phi_2335_;
                            phi_2336_ = _e1355;
                        } else {
                            phi_2336_ = _e781;
                        }
                        let _e1357 = phi_2336_;
                        phi_1514_ = _e1357;
                    } else {
                        phi_1514_ = SlimbvhTypeK();
                    }
                    let _e1359 = phi_1514_;
                    continue;
                    continuing {
                        phi_1513_ = _e1359;
                        phi_1516_ = _e796;
                        break if !(_e802);
                    }
                }
                let _e1362 = local_5;
                let _e1363 = (_e1362 - 1u);
                let _e1364 = (_e1363 % 128u);
                let _e1366 = local[_e1364];
                let _e1368 = local_6;
                if (_e1366 <= _e1368.member.member_1) {
                    let _e1373 = local_1[_e1364];
                    phi_2361_ = _e1373;
                } else {
                    phi_2361_ = 2147483648u;
                }
                let _e1375 = phi_2361_;
                let _e1612 = local_8;
                phi_2368_ = _e1612;
                phi_2369_ = _e1375;
                phi_2370_ = select(_e1363, 4294967295u, (_e595 > _e1368.member.member_1));
            } else {
                phi_2368_ = _e613;
                let _e1615 = local_9;
                phi_2369_ = _e1615;
                let _e1618 = local_10;
                phi_2370_ = _e1618;
            }
            let _e1379 = phi_2368_;
            let _e1381 = phi_2369_;
            let _e1383 = phi_2370_;
            phi_1195_ = _e1379;
            phi_1198_ = _e1381;
            phi_1200_ = _e1383;
            let _e1624 = local_11;
            phi_1202_ = _e1624;
        } else {
            phi_1195_ = SlimbvhTypeK();
            phi_1198_ = u32();
            phi_1200_ = u32();
            phi_1202_ = u32();
        }
        let _e1385 = phi_1195_;
        let _e1387 = phi_1198_;
        let _e1389 = phi_1200_;
        let _e1391 = phi_1202_;
        continue;
        continuing {
            phi_1194_ = _e1385;
            phi_1197_ = _e1387;
            phi_1199_ = _e1389;
            phi_1201_ = _e1391;
            break if !(_e620);
        }
    }
    let _e1394 = local_7;
    if (_e1394.member.member.member_3 != 4294967295u) {
        let _e1400 = -((_e98 + _e528.member_4));
        let _e1401 = bitcast<u32>(_e1394.member.member.member);
        let _e1405 = (bitcast<i32>((_e1401 >> bitcast<u32>(23i))) & 255i);
        let _e1406 = (_e1405 + _e1400);
        if (_e1405 == 255i) {
            phi_2425_ = _e1394.member.member.member;
        } else {
            if (_e1405 > 0i) {
                if (_e1406 > 0i) {
                    let _e1410 = (_e1406 < 255i);
                    if _e1410 {
                        phi_2404_ = bitcast<f32>((_e1401 + bitcast<u32>((_e1400 << bitcast<u32>(23i)))));
                    } else {
                        phi_2404_ = f32();
                    }
                    let _e1417 = phi_2404_;
                    phi_2406_ = _e1417;
                    phi_2407_ = select(true, false, _e1410);
                } else {
                    phi_2406_ = f32();
                    phi_2407_ = true;
                }
                let _e1420 = phi_2406_;
                let _e1422 = phi_2407_;
                phi_2408_ = _e1420;
                phi_2409_ = _e1422;
            } else {
                phi_2408_ = f32();
                phi_2409_ = true;
            }
            let _e1424 = phi_2408_;
            let _e1426 = phi_2409_;
            if _e1426 {
                let _e1427 = (_e1401 & 2147483648u);
                let _e1434 = ((_e1401 & 8388607u) | (select(0u, 1u, ((_e1401 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e1438 = (_e1434 == 0u);
                if _e1438 {
                    phi_2647_ = bitcast<f32>(_e1427);
                } else {
                    let _e1443 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1434)), 32u, _e1438) - 8u);
                    let _e1446 = (_e1434 << bitcast<u32>((_e1443 & 31u)));
                    let _e1448 = ((_e1406 + select(0i, 1i, (_e1405 == 0i))) - bitcast<i32>(_e1443));
                    if (_e1448 >= 255i) {
                        phi_2637_ = bitcast<f32>((_e1427 | 2139095040u));
                        phi_2638_ = f32();
                        phi_2639_ = true;
                    } else {
                        let _e1450 = (_e1448 > 0i);
                        if _e1450 {
                            phi_2631_ = bitcast<f32>(((_e1427 | (bitcast<u32>(_e1448) << bitcast<u32>(23i))) | (_e1446 & 8388607u)));
                            phi_2632_ = f32();
                        } else {
                            if (_e1448 < -24i) {
                                phi_2597_ = 26u;
                            } else {
                                phi_2597_ = bitcast<u32>((1i - _e1448));
                            }
                            let _e1455 = phi_2597_;
                            let _e1456 = (_e1455 & 31u);
                            let _e1458 = (_e1446 >> bitcast<u32>(_e1456));
                            let _e1462 = (_e1446 & ((1u << bitcast<u32>(_e1456)) - 1u));
                            let _e1466 = (1u << bitcast<u32>(((_e1455 - 1u) & 31u)));
                            if (_e1462 > _e1466) {
                                phi_2618_ = true;
                            } else {
                                if (_e1462 == _e1466) {
                                    phi_2615_ = ((_e1458 & 1u) == 1u);
                                } else {
                                    phi_2615_ = false;
                                }
                                let _e1472 = phi_2615_;
                                phi_2618_ = _e1472;
                            }
                            let _e1474 = phi_2618_;
                            phi_2631_ = f32();
                            phi_2632_ = bitcast<f32>((_e1427 | (_e1458 + select(0u, 1u, _e1474))));
                        }
                        let _e1487 = phi_2631_;
                        let _e1489 = phi_2632_;
                        phi_2637_ = _e1487;
                        phi_2638_ = _e1489;
                        phi_2639_ = _e1450;
                    }
                    let _e1493 = phi_2637_;
                    let _e1495 = phi_2638_;
                    let _e1497 = phi_2639_;
                    phi_2647_ = select(_e1495, _e1493, _e1497);
                }
                let _e1501 = phi_2647_;
                phi_2424_ = _e1501;
            } else {
                phi_2424_ = _e1424;
            }
            let _e1503 = phi_2424_;
            phi_2425_ = _e1503;
        }
        let _e1505 = phi_2425_;
        let _e1506 = bitcast<u32>(_e1505);
        if ((_e1506 & 2147483647u) >= 2139095040u) {
            phi_2437_ = bitcast<f32>(((_e1506 & 2147483648u) | 2139095039u));
        } else {
            phi_2437_ = _e1505;
        }
        let _e1513 = phi_2437_;
        phi_2442_ = SlimbvhTypeC(_e1513, _e1394.member.member.member_1, _e1394.member.member.member_2, _e1394.member.member.member_3);
    } else {
        phi_2442_ = _e72;
    }
    let _e1518 = phi_2442_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1518.member), bitcast<u32>(_e1518.member_1), bitcast<u32>(_e1518.member_2), _e1518.member_3);
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
