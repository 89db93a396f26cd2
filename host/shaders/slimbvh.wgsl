// Made by slimbvh's shader builder from its Rust: rays traced from your own WGSL. Put this text before yours, bind the
// tree's exponent, nodes, triangles, if it has one its root, sides and target to group 0, and call
//
//   slimbvh_closest_hit(origin, t_min, direction, t_max) -> SlimbvhHit
//   slimbvh_any_hit(origin, t_min, direction, t_max) -> bool
//
// from any stage. t is in units of the direction's length; a miss has the primitive 0xffffffff. The stack is private
// memory, up to 1 KiB an invocation: in compute shaders the functions of the text slimbvh_compute are faster.
//
//   slimbvh_surface(v0, v1, v2, hit, direction) -> SlimbvhSurface { position, error, normal, side, leave, enter }
//   slimbvh_closest_hit_from(origin, t_min, direction, t_max, skip) -> SlimbvhHit
//   slimbvh_any_hit_from(origin, t_min, direction, t_max, skip) -> bool
//
// send rays from where one hit: from the corners of the triangle, the hit and its ray's direction to the surface there. A
// shadow or mirror ray begins at leave, a refracted one at enter, and skip is the primitive that was hit.

struct SlimbvhTypeA {
    member: vec4<u32>,
}

struct SlimbvhTypeB {
    member: array<array<vec4<f32>, 5>>,
}

struct SlimbvhTypeC {
    member: array<u32>,
}

struct SlimbvhTypeD {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
    member_2: f32,
    member_3: f32,
    member_4: i32,
}

struct SlimbvhTypeE {
    member: u32,
    member_1: u32,
}

struct SlimbvhTypeF {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct SlimbvhTypeG {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct SlimbvhTypeH {
    member: array<vec4<u32>, 2>,
}

struct SlimbvhTypeI {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct SlimbvhTypeJ {
    member: SlimbvhTypeG,
    member_1: f32,
}

struct SlimbvhTypeK {
    member: array<array<vec4<f32>, 4>>,
}

struct SlimbvhTypeL {
    member: vec4<f32>,
}

struct SlimbvhTypeM {
    member: vec2<u32>,
}

struct SlimbvhTypeN {
    member: SlimbvhTypeJ,
    member_1: bool,
}

@group(0) @binding(0) 
var<uniform> slimbvh_exponent: SlimbvhTypeA;

@group(0) @binding(2) 
var<storage> slimbvh_triangles: SlimbvhTypeB;

@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeK;

@group(0) @binding(3) 
var<storage> slimbvh_sides: SlimbvhTypeC;

@group(0) @binding(4) 
var<uniform> slimbvh_target: SlimbvhTypeH;

var<private> slimbvh_origin: SlimbvhTypeL;

var<private> slimbvh_direction: SlimbvhTypeL;

var<private> slimbvh_question: SlimbvhTypeM;

var<private> slimbvh_hit: SlimbvhTypeA;

fn slimbvh_trace() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_432_: u32;
    var phi_438_: u32;
    var phi_444_: u32;
    var phi_709_: i32;
    var phi_720_: i32;
    var phi_834_: i32;
    var phi_963_: i32;
    var phi_985_: u32;
    var phi_986_: u32;
    var phi_987_: bool;
    var phi_1021_: i32;
    var phi_1043_: u32;
    var phi_1044_: u32;
    var phi_1045_: bool;
    var phi_606_: i32;
    var phi_612_: u32;
    var phi_631_: u32;
    var phi_632_: u32;
    var phi_633_: bool;
    var phi_651_: i32;
    var phi_657_: u32;
    var phi_676_: u32;
    var phi_677_: u32;
    var phi_678_: bool;
    var phi_1055_: SlimbvhTypeD;
    var phi_1260_: SlimbvhTypeN;
    var phi_1275_: SlimbvhTypeN;
    var phi_1278_: u32;
    var phi_1280_: u32;
    var phi_1282_: u32;
    var phi_1291_: u32;
    var phi_1294_: u32;
    var phi_1296_: u32;
    var phi_1593_: u32;
    var phi_1568_: u32;
    var phi_1594_: u32;
    var phi_1595_: u32;
    var phi_1292_: u32;
    var phi_1295_: u32;
    var phi_1297_: u32;
    var local_2: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1611_: SlimbvhTypeN;
    var phi_1614_: SlimbvhTypeE;
    var phi_1615_: SlimbvhTypeE;
    var phi_1637_: SlimbvhTypeE;
    var phi_1716_: array<vec4<f32>, 3>;
    var phi_1717_: array<vec4<f32>, 3>;
    var phi_1791_: array<vec4<f32>, 3>;
    var phi_1792_: array<vec4<f32>, 3>;
    var phi_1815_: array<f32, 3>;
    var phi_1816_: array<f32, 3>;
    var phi_1830_: array<f32, 3>;
    var phi_1831_: array<f32, 3>;
    var phi_1845_: array<f32, 3>;
    var phi_1846_: array<f32, 3>;
    var phi_2179_: f32;
    var phi_2180_: f32;
    var phi_2181_: f32;
    var phi_2182_: f32;
    var phi_2183_: vec3<f32>;
    var phi_2184_: vec3<f32>;
    var phi_2185_: vec3<f32>;
    var phi_2186_: vec3<f32>;
    var phi_2365_: f32;
    var phi_2391_: SlimbvhTypeF;
    var phi_2392_: SlimbvhTypeF;
    var phi_2395_: SlimbvhTypeF;
    var phi_2396_: SlimbvhTypeF;
    var phi_2397_: bool;
    var phi_2401_: SlimbvhTypeF;
    var phi_2410_: SlimbvhTypeG;
    var phi_2457_: i32;
    var phi_2597_: SlimbvhTypeI;
    var phi_2621_: u32;
    var phi_2649_: vec3<f32>;
    var phi_2650_: vec3<f32>;
    var phi_2667_: vec3<f32>;
    var phi_2668_: vec3<f32>;
    var phi_2685_: vec3<f32>;
    var phi_2686_: vec3<f32>;
    var phi_2722_: vec3<f32>;
    var phi_2904_: f32;
    var phi_2922_: bool;
    var phi_2923_: bool;
    var phi_2942_: bool;
    var phi_2943_: bool;
    var phi_2950_: SlimbvhTypeN;
    var phi_2956_: SlimbvhTypeN;
    var phi_2957_: SlimbvhTypeN;
    var phi_2958_: SlimbvhTypeN;
    var phi_1612_: SlimbvhTypeN;
    var local_5: u32;
    var local_6: SlimbvhTypeN;
    var phi_2983_: u32;
    var phi_2990_: SlimbvhTypeN;
    var phi_2991_: u32;
    var phi_2992_: u32;
    var phi_1276_: SlimbvhTypeN;
    var phi_1279_: u32;
    var phi_1281_: u32;
    var phi_1283_: u32;
    var local_7: SlimbvhTypeN;
    var phi_3026_: f32;
    var phi_3028_: f32;
    var phi_3029_: bool;
    var phi_3030_: f32;
    var phi_3031_: bool;
    var phi_3412_: u32;
    var phi_3430_: bool;
    var phi_3433_: bool;
    var phi_3446_: f32;
    var phi_3447_: f32;
    var phi_3452_: f32;
    var phi_3453_: f32;
    var phi_3454_: bool;
    var phi_3462_: f32;
    var phi_3046_: f32;
    var phi_3047_: f32;
    var phi_3059_: f32;
    var phi_3064_: SlimbvhTypeG;
    var local_8: SlimbvhTypeN;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e85 = SlimbvhTypeG(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e88 = arrayLength((&slimbvh_nodes.member));
    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
    let _e97 = slimbvh_origin.member;
    let _e103 = slimbvh_origin.member[3u];
    let _e104 = slimbvh_direction.member;
    let _e110 = slimbvh_direction.member[3u];
    let _e113 = slimbvh_exponent.member[0u];
    let _e114 = bitcast<i32>(_e113);
    let _e116 = (bitcast<u32>(_e97.x) & 2147483647u);
    let _e118 = (bitcast<u32>(_e97.y) & 2147483647u);
    let _e120 = (bitcast<u32>(_e97.z) & 2147483647u);
    let _e121 = bitcast<u32>(_e103);
    let _e122 = (_e121 & 2147483647u);
    let _e124 = (bitcast<u32>(_e104.x) & 2147483647u);
    let _e126 = (bitcast<u32>(_e104.y) & 2147483647u);
    let _e128 = (bitcast<u32>(_e104.z) & 2147483647u);
    let _e129 = bitcast<u32>(_e110);
    let _e130 = (_e129 & 2147483647u);
    let _e132 = select(_e126, _e124, (_e126 < _e124));
    let _e134 = select(_e128, _e132, (_e128 < _e132));
    let _e136 = select(_e116, _e134, (_e116 < _e134));
    let _e138 = select(_e118, _e136, (_e118 < _e136));
    let _e140 = select(_e120, _e138, (_e120 < _e138));
    let _e147 = (((select(_e122, _e140, (_e122 < _e140)) < 2139095040u) && (_e130 <= 2139095040u)) && (_e134 > 0u));
    if (_e124 == _e134) {
        phi_432_ = 0u;
    } else {
        phi_432_ = select(2u, 1u, (_e126 == _e134));
    }
    let _e152 = phi_432_;
    let _e153 = (_e152 == 2u);
    if _e153 {
        phi_438_ = 0u;
    } else {
        phi_438_ = (_e152 + 1u);
    }
    let _e156 = phi_438_;
    let _e157 = (_e156 == 2u);
    if _e157 {
        phi_444_ = 0u;
    } else {
        phi_444_ = (_e156 + 1u);
    }
    let _e160 = phi_444_;
    let _e161 = (_e156 == 0u);
    let _e163 = select(select(_e97.y, _e97.x, _e161), _e97.z, _e157);
    let _e164 = (_e160 == 0u);
    let _e166 = (_e160 == 2u);
    let _e167 = select(select(_e97.y, _e97.x, _e164), _e97.z, _e166);
    let _e168 = (_e152 == 0u);
    let _e170 = select(select(_e97.y, _e97.x, _e168), _e97.z, _e153);
    let _e172 = select(select(_e104.y, _e104.x, _e161), _e104.z, _e157);
    let _e174 = select(select(_e104.y, _e104.x, _e164), _e104.z, _e166);
    let _e176 = select(select(_e104.y, _e104.x, _e168), _e104.z, _e153);
    let _e177 = (_e122 - 1u);
    let _e178 = (_e130 - 1u);
    let _e180 = select(_e177, _e178, (_e178 < _e177));
    let _e181 = (_e116 - 1u);
    let _e182 = (_e118 - 1u);
    let _e184 = select(_e181, _e182, (_e182 < _e181));
    let _e185 = (_e120 - 1u);
    let _e187 = select(_e184, _e185, (_e185 < _e184));
    let _e188 = (_e124 - 1u);
    let _e189 = (_e126 - 1u);
    let _e191 = select(_e188, _e189, (_e189 < _e188));
    let _e192 = (_e128 - 1u);
    let _e194 = select(_e191, _e192, (_e192 < _e191));
    let _e196 = select(_e187, _e194, (_e194 < _e187));
    if (((select(_e196, _e180, (_e180 < _e196)) >= 8388607u) && (_e134 < 2130706432u)) && (bitcast<u32>((_e114 + 126i)) <= 253u)) {
        let _e461 = bitcast<i32>((_e134 >> bitcast<u32>(23i)));
        let _e462 = (_e461 - 127i);
        let _e463 = (_e114 + _e462);
        let _e468 = bitcast<f32>((bitcast<u32>((_e114 + 127i)) << bitcast<u32>(23i)));
        let _e473 = bitcast<f32>((bitcast<u32>((254i - _e461)) << bitcast<u32>(23i)));
        if (_e122 >= 2139095040u) {
            phi_606_ = 255i;
        } else {
            phi_606_ = (bitcast<i32>((_e122 >> bitcast<u32>(23i))) + _e463);
        }
        let _e488 = phi_606_;
        if (_e122 == 0u) {
            phi_612_ = 0u;
        } else {
            phi_612_ = (_e122 | 8388608u);
        }
        let _e492 = phi_612_;
        if (_e488 <= 0i) {
            phi_632_ = u32();
            phi_633_ = true;
        } else {
            let _e499 = (_e492 == 0u);
            if _e499 {
                phi_631_ = u32();
            } else {
                phi_631_ = select(((bitcast<u32>(_e488) << bitcast<u32>(23i)) | (_e492 & 8388607u)), 2139095039u, (_e488 >= 255i));
            }
            let _e503 = phi_631_;
            phi_632_ = _e503;
            phi_633_ = _e499;
        }
        let _e505 = phi_632_;
        let _e507 = phi_633_;
        if (_e130 >= 2139095040u) {
            phi_651_ = 255i;
        } else {
            phi_651_ = (bitcast<i32>((_e130 >> bitcast<u32>(23i))) + _e463);
        }
        let _e518 = phi_651_;
        if (_e130 == 0u) {
            phi_657_ = 0u;
        } else {
            phi_657_ = (_e130 | 8388608u);
        }
        let _e522 = phi_657_;
        if (_e518 <= 0i) {
            phi_677_ = u32();
            phi_678_ = true;
        } else {
            let _e529 = (_e522 == 0u);
            if _e529 {
                phi_676_ = u32();
            } else {
                phi_676_ = select(((bitcast<u32>(_e518) << bitcast<u32>(23i)) | (_e522 & 8388607u)), 2139095039u, (_e518 >= 255i));
            }
            let _e533 = phi_676_;
            phi_677_ = _e533;
            phi_678_ = _e529;
        }
        let _e535 = phi_677_;
        let _e537 = phi_678_;
        phi_1055_ = SlimbvhTypeD(array<f32, 3>((_e163 * _e468), (_e167 * _e468), (_e170 * _e468)), array<f32, 3>((_e172 * _e473), (_e174 * _e473), (_e176 * _e473)), bitcast<f32>(((_e121 & 2147483648u) | select(_e505, 0u, _e507))), bitcast<f32>(((_e129 & 2147483648u) | select(_e535, 0u, _e537))), _e462);
    } else {
        let _e209 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e134, _e147))) & 2147483647u);
        if (_e209 >= 8388608u) {
            phi_709_ = (bitcast<i32>((_e209 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_709_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e209)), 32u, (_e209 == 0u))));
        }
        let _e223 = phi_709_;
        let _e224 = (_e114 + _e223);
        if (_e114 < -126i) {
            phi_720_ = -126i;
        } else {
            phi_720_ = select(_e114, 127i, (_e114 > 127i));
        }
        let _e229 = phi_720_;
        let _e234 = bitcast<f32>((bitcast<u32>((_e229 + 127i)) << bitcast<u32>(23i)));
        let _e240 = bitcast<f32>((bitcast<u32>(((_e114 - _e229) + 127i)) << bitcast<u32>(23i)));
        let _e241 = bitcast<u32>(_e163);
        let _e243 = ((_e241 & 2139095040u) != 0u);
        let _e258 = bitcast<u32>(_e167);
        let _e260 = ((_e258 & 2139095040u) != 0u);
        let _e275 = bitcast<u32>(_e170);
        let _e277 = ((_e275 & 2139095040u) != 0u);
        let _e293 = -(_e223);
        if (_e293 < -126i) {
            phi_834_ = -126i;
        } else {
            phi_834_ = select(_e293, 127i, (_e293 > 127i));
        }
        let _e298 = phi_834_;
        let _e303 = bitcast<f32>((bitcast<u32>((_e298 + 127i)) << bitcast<u32>(23i)));
        let _e309 = bitcast<f32>((bitcast<u32>(((_e293 - _e298) + 127i)) << bitcast<u32>(23i)));
        let _e310 = bitcast<u32>(_e172);
        let _e312 = ((_e310 & 2139095040u) != 0u);
        let _e327 = bitcast<u32>(_e174);
        let _e329 = ((_e327 & 2139095040u) != 0u);
        let _e344 = bitcast<u32>(_e176);
        let _e346 = ((_e344 & 2139095040u) != 0u);
        let _e368 = ((_e122 & 8388607u) | (select(0u, 1u, ((_e122 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e371 = bitcast<i32>((_e122 >> bitcast<u32>(23i)));
        let _e378 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e368)), 32u, (_e368 == 0u))) - 8i);
        if (_e371 == 255i) {
            phi_963_ = 255i;
        } else {
            phi_963_ = (((_e371 + select(0i, 1i, (_e371 == 0i))) - _e378) + _e224);
        }
        let _e386 = phi_963_;
        let _e390 = (_e368 << bitcast<u32>(((_e378 & 31i) & 31i)));
        if (_e386 <= 0i) {
            phi_986_ = u32();
            phi_987_ = true;
        } else {
            let _e397 = (_e390 == 0u);
            if _e397 {
                phi_985_ = u32();
            } else {
                phi_985_ = select(((bitcast<u32>(_e386) << bitcast<u32>(23i)) | (_e390 & 8388607u)), 2139095039u, (_e386 >= 255i));
            }
            let _e401 = phi_985_;
            phi_986_ = _e401;
            phi_987_ = _e397;
        }
        let _e403 = phi_986_;
        let _e405 = phi_987_;
        let _e416 = ((_e130 & 8388607u) | (select(0u, 1u, ((_e130 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e419 = bitcast<i32>((_e130 >> bitcast<u32>(23i)));
        let _e426 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e416)), 32u, (_e416 == 0u))) - 8i);
        if (_e419 == 255i) {
            phi_1021_ = 255i;
        } else {
            phi_1021_ = (((_e419 + select(0i, 1i, (_e419 == 0i))) - _e426) + _e224);
        }
        let _e434 = phi_1021_;
        let _e438 = (_e416 << bitcast<u32>(((_e426 & 31i) & 31i)));
        if (_e434 <= 0i) {
            phi_1044_ = u32();
            phi_1045_ = true;
        } else {
            let _e445 = (_e438 == 0u);
            if _e445 {
                phi_1043_ = u32();
            } else {
                phi_1043_ = select(((bitcast<u32>(_e434) << bitcast<u32>(23i)) | (_e438 & 8388607u)), 2139095039u, (_e434 >= 255i));
            }
            let _e449 = phi_1043_;
            phi_1044_ = _e449;
            phi_1045_ = _e445;
        }
        let _e451 = phi_1044_;
        let _e453 = phi_1045_;
        phi_1055_ = SlimbvhTypeD(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e241 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e241 & 2147483648u))), _e163, _e243) * _e234) * select(0.00000011920929f, 1f, _e243)) * _e240), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e258 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e258 & 2147483648u))), _e167, _e260) * _e234) * select(0.00000011920929f, 1f, _e260)) * _e240), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e275 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e275 & 2147483648u))), _e170, _e277) * _e234) * select(0.00000011920929f, 1f, _e277)) * _e240)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e310 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e310 & 2147483648u))), _e172, _e312) * _e303) * select(0.00000011920929f, 1f, _e312)) * _e309), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e327 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e327 & 2147483648u))), _e174, _e329) * _e303) * select(0.00000011920929f, 1f, _e329)) * _e309), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e344 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e344 & 2147483648u))), _e176, _e346) * _e303) * select(0.00000011920929f, 1f, _e346)) * _e309)), bitcast<f32>(((_e121 & 2147483648u) | select(_e403, 0u, _e405))), bitcast<f32>(((_e129 & 2147483648u) | select(_e451, 0u, _e453))), _e223);
    }
    let _e544 = phi_1055_;
    let _e559 = (bitcast<f32>((bitcast<u32>(_e544.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e562 = bitcast<f32>((bitcast<u32>(_e544.member[0]) & 2147483647u));
    let _e563 = (_e562 * 0.00000011920929f);
    let _e566 = select(select(0.00000000000011368684f, _e563, (_e563 > 0.00000000000011368684f)), 0f, _e559);
    let _e567 = select(0f, _e544.member_1[0], _e559);
    let _e568 = (_e544.member[0] + _e566);
    let _e569 = (_e544.member[0] - _e566);
    let _e571 = select(38685626000000000000000000f, (1f / _e544.member_1[0]), _e559);
    let _e575 = (bitcast<f32>((bitcast<u32>(_e544.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e578 = bitcast<f32>((bitcast<u32>(_e544.member[1]) & 2147483647u));
    let _e579 = (_e578 * 0.00000011920929f);
    let _e582 = select(select(0.00000000000011368684f, _e579, (_e579 > 0.00000000000011368684f)), 0f, _e575);
    let _e583 = select(0f, _e544.member_1[1], _e575);
    let _e584 = (_e544.member[1] + _e582);
    let _e585 = (_e544.member[1] - _e582);
    let _e587 = select(38685626000000000000000000f, (1f / _e544.member_1[1]), _e575);
    let _e591 = (bitcast<f32>((bitcast<u32>(_e544.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e594 = bitcast<f32>((bitcast<u32>(_e544.member[2]) & 2147483647u));
    let _e595 = (_e594 * 0.00000011920929f);
    let _e598 = select(select(0.00000000000011368684f, _e595, (_e595 > 0.00000000000011368684f)), 0f, _e591);
    let _e599 = select(0f, _e544.member_1[2], _e591);
    let _e600 = (_e544.member[2] + _e598);
    let _e601 = (_e544.member[2] - _e598);
    let _e603 = select(38685626000000000000000000f, (1f / _e544.member_1[2]), _e591);
    let _e605 = select(_e578, _e562, (_e562 > _e578));
    let _e609 = (_e147 && (select(_e594, _e605, (_e605 > _e594)) <= 1099511600000f));
    let _e610 = select(0f, _e544.member_3, _e609);
    let _e611 = select(1f, _e544.member_2, _e609);
    let _e615 = slimbvh_question.member[1u];
    let _e618 = slimbvh_question.member[0u];
    if (_e618 == 1u) {
        phi_1260_ = SlimbvhTypeN(SlimbvhTypeJ(_e85, _e610), true);
    } else {
        phi_1260_ = SlimbvhTypeN(SlimbvhTypeJ(_e85, _e610), false);
    }
    let _e625 = phi_1260_;
    phi_1275_ = _e625;
    phi_1278_ = select(4294967295u, 0u, (_e611 <= _e610));
    phi_1280_ = 0u;
    phi_1282_ = (_e88 + 1u);
    loop {
        let _e634 = phi_1275_;
        let _e636 = phi_1278_;
        let _e638 = phi_1280_;
        let _e640 = phi_1282_;
        local_7 = _e634;
        let _e641 = (_e636 <= 2147483647u);
        if _e641 {
            phi_1291_ = _e636;
            phi_1294_ = _e638;
            phi_1296_ = _e640;
            loop {
                let _e643 = phi_1291_;
                let _e645 = phi_1294_;
                let _e647 = phi_1296_;
                local_3 = _e645;
                local_4 = _e645;
                local_5 = _e643;
                local_9 = _e643;
                local_10 = _e645;
                local_11 = _e647;
                let _e648 = (_e643 <= 2147483647u);
                let _e651 = (_e648 && !((_e645 >= _e88)));
                local_2 = _e648;
                if _e651 {
                    let _e656 = slimbvh_nodes.member[_e645][3u][0u];
                    let _e661 = slimbvh_nodes.member[_e645][3u][1u];
                    let _e666 = slimbvh_nodes.member[_e645][((_e156 & 3u) % 4u)];
                    let _e671 = slimbvh_nodes.member[_e645][((_e160 & 3u) % 4u)];
                    let _e676 = slimbvh_nodes.member[_e645][((_e152 & 3u) % 4u)];
                    let _e677 = bitcast<u32>(_e656);
                    let _e678 = bitcast<u32>(_e661);
                    let _e689 = ((_e666.x - _e568) * _e571);
                    let _e690 = ((_e666.y - _e568) * _e571);
                    let _e691 = ((_e666.z - _e569) * _e571);
                    let _e692 = ((_e666.w - _e569) * _e571);
                    let _e693 = vec4<f32>(_e689, _e690, _e691, _e692);
                    let _e702 = ((_e671.x - _e584) * _e587);
                    let _e703 = ((_e671.y - _e584) * _e587);
                    let _e704 = ((_e671.z - _e585) * _e587);
                    let _e705 = ((_e671.w - _e585) * _e587);
                    let _e706 = vec4<f32>(_e702, _e703, _e704, _e705);
                    let _e715 = ((_e676.x - _e600) * _e603);
                    let _e716 = ((_e676.y - _e600) * _e603);
                    let _e717 = ((_e676.z - _e601) * _e603);
                    let _e718 = ((_e676.w - _e601) * _e603);
                    let _e719 = vec4<f32>(_e715, _e716, _e717, _e718);
                    let _e720 = vec4<f32>(_e691, _e692, _e689, _e690);
                    let _e721 = min(_e693, _e720);
                    let _e722 = vec4<f32>(_e704, _e705, _e702, _e703);
                    let _e723 = min(_e706, _e722);
                    let _e724 = vec4<f32>(_e717, _e718, _e715, _e716);
                    let _e725 = min(_e719, _e724);
                    let _e726 = max(_e693, _e720);
                    let _e727 = max(_e706, _e722);
                    let _e728 = max(_e719, _e724);
                    let _e757 = max(max(max(_e721.x, _e723.x), _e725.x), _e611);
                    let _e758 = max(max(max(_e721.y, _e723.y), _e725.y), _e611);
                    let _e761 = (_e757 <= min((min(min(_e726.x, _e727.x), _e728.x) + (max(_e728.x, -(_e725.x)) * 0.0000019073523f)), _e634.member.member_1));
                    let _e762 = (_e758 <= min((min(min(_e726.y, _e727.y), _e728.y) + (max(_e728.y, -(_e725.y)) * 0.0000019073523f)), _e634.member.member_1));
                    if (_e761 || _e762) {
                        let _e777 = (_e761 && (((_e757 <= _e758) != _e625.member_1) || !(_e762)));
                        if (_e761 && _e762) {
                            let _e782 = (_e643 % 128u);
                            local_1[_e782] = select(_e677, _e678, _e777);
                            local[_e782] = select(_e757, _e758, _e777);
                            phi_1568_ = (_e643 + 1u);
                        } else {
                            phi_1568_ = _e643;
                        }
                        let _e787 = phi_1568_;
                        phi_1594_ = _e787;
                        phi_1595_ = select(_e678, _e677, _e777);
                    } else {
                        let _e766 = (_e643 - 1u);
                        let _e767 = (_e766 % 128u);
                        let _e769 = local[_e767];
                        if (_e769 <= _e634.member.member_1) {
                            let _e772 = local_1[_e767];
                            phi_1593_ = _e772;
                        } else {
                            phi_1593_ = 2147483648u;
                        }
                        let _e774 = phi_1593_;
                        phi_1594_ = _e766;
                        phi_1595_ = _e774;
                    }
                    let _e789 = phi_1594_;
                    let _e791 = phi_1595_;
                    let _e792 = (_e647 - 1u);
                    phi_1292_ = select(_e789, 4294967295u, (_e792 == 0u));
                    phi_1295_ = _e791;
                    phi_1297_ = _e792;
                } else {
                    phi_1292_ = u32();
                    phi_1295_ = u32();
                    phi_1297_ = u32();
                }
                let _e796 = phi_1292_;
                let _e798 = phi_1295_;
                let _e800 = phi_1297_;
                continue;
                continuing {
                    phi_1291_ = _e796;
                    phi_1294_ = _e798;
                    phi_1296_ = _e800;
                    break if !(_e651);
                }
            }
            let _e803 = local_2;
            if _e803 {
                let _e805 = local_3;
                let _e808 = local_4;
                phi_1611_ = _e634;
                phi_1614_ = SlimbvhTypeE(0u, ((_e808 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e814 = phi_1611_;
                    let _e816 = phi_1614_;
                    local_6 = _e814;
                    local_8 = _e814;
                    if (_e816.member < _e816.member_1) {
                        phi_1615_ = SlimbvhTypeE((_e816.member + 1u), _e816.member_1);
                        phi_1637_ = SlimbvhTypeE(1u, _e816.member);
                    } else {
                        phi_1615_ = _e816;
                        phi_1637_ = SlimbvhTypeE(0u, SlimbvhTypeE().member_1);
                    }
                    let _e829 = phi_1615_;
                    let _e831 = phi_1637_;
                    let _e835 = (bitcast<i32>(_e831.member) != 0i);
                    if _e835 {
                        let _e836 = ((_e805 & 268435455u) + _e831.member_1);
                        let _e837 = (_e836 / 2u);
                        let _e838 = (_e836 % 2u);
                        let _e839 = (_e837 >= arrayLength((&slimbvh_triangles.member)));
                        if _e839 {
                            phi_1717_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e840 = (2u * _e838);
                            let _e844 = slimbvh_triangles.member[_e837][_e840];
                            let _e849 = slimbvh_triangles.member[_e837][(_e840 + 1u)];
                            let _e854 = slimbvh_triangles.member[_e837][(_e840 + 2u)];
                            if (_e838 == 0u) {
                                phi_1716_ = array<vec4<f32>, 3>(_e844, _e849, _e854);
                            } else {
                                phi_1716_ = array<vec4<f32>, 3>(vec4<f32>(_e844.z, _e844.w, _e849.x, _e849.y), vec4<f32>(_e849.z, _e849.w, _e854.x, _e854.y), vec4<f32>(_e854.z, _e854.w, 0f, 0f));
                            }
                            let _e872 = phi_1716_;
                            phi_1717_ = _e872;
                        }
                        let _e874 = phi_1717_;
                        let _e877 = bitcast<u32>(_e874[2].y);
                        if _e839 {
                            phi_1792_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e878 = (2u * _e838);
                            let _e882 = slimbvh_triangles.member[_e837][_e878];
                            let _e887 = slimbvh_triangles.member[_e837][(_e878 + 1u)];
                            let _e892 = slimbvh_triangles.member[_e837][(_e878 + 2u)];
                            if (_e838 == 0u) {
                                phi_1791_ = array<vec4<f32>, 3>(_e882, _e887, _e892);
                            } else {
                                phi_1791_ = array<vec4<f32>, 3>(vec4<f32>(_e882.z, _e882.w, _e887.x, _e887.y), vec4<f32>(_e887.z, _e887.w, _e892.x, _e892.y), vec4<f32>(_e892.z, _e892.w, 0f, 0f));
                            }
                            let _e910 = phi_1791_;
                            phi_1792_ = _e910;
                        }
                        let _e912 = phi_1792_;
                        if _e161 {
                            phi_1816_ = array<f32, 3>(_e912[0].x, _e912[0].y, _e912[0].z);
                        } else {
                            if (_e156 == 1u) {
                                phi_1815_ = array<f32, 3>(_e912[0].y, _e912[0].z, _e912[0].x);
                            } else {
                                phi_1815_ = array<f32, 3>(_e912[0].z, _e912[0].x, _e912[0].y);
                            }
                            let _e935 = phi_1815_;
                            phi_1816_ = _e935;
                        }
                        let _e938 = phi_1816_;
                        if _e161 {
                            phi_1831_ = array<f32, 3>(_e912[0].w, _e912[1].x, _e912[1].y);
                        } else {
                            if (_e156 == 1u) {
                                phi_1830_ = array<f32, 3>(_e912[1].x, _e912[1].y, _e912[0].w);
                            } else {
                                phi_1830_ = array<f32, 3>(_e912[1].y, _e912[0].w, _e912[1].x);
                            }
                            let _e943 = phi_1830_;
                            phi_1831_ = _e943;
                        }
                        let _e946 = phi_1831_;
                        if _e161 {
                            phi_1846_ = array<f32, 3>(_e912[1].z, _e912[1].w, _e912[2].x);
                        } else {
                            if (_e156 == 1u) {
                                phi_1845_ = array<f32, 3>(_e912[1].w, _e912[2].x, _e912[1].z);
                            } else {
                                phi_1845_ = array<f32, 3>(_e912[2].x, _e912[1].z, _e912[1].w);
                            }
                            let _e951 = phi_1845_;
                            phi_1846_ = _e951;
                        }
                        let _e954 = phi_1846_;
                        let _e968 = (_e938[2] - _e544.member[2]);
                        let _e971 = (((_e938[0] - _e544.member[0]) * _e599) - (_e968 * _e567));
                        let _e974 = (((_e938[1] - _e544.member[1]) * _e599) - (_e968 * _e583));
                        let _e977 = (_e946[2] - _e544.member[2]);
                        let _e980 = (((_e946[0] - _e544.member[0]) * _e599) - (_e977 * _e567));
                        let _e983 = (((_e946[1] - _e544.member[1]) * _e599) - (_e977 * _e583));
                        let _e986 = (_e954[2] - _e544.member[2]);
                        let _e989 = (((_e954[0] - _e544.member[0]) * _e599) - (_e986 * _e567));
                        let _e992 = (((_e954[1] - _e544.member[1]) * _e599) - (_e986 * _e583));
                        let _e993 = (_e989 * _e983);
                        let _e994 = (_e992 * _e980);
                        let _e995 = (_e971 * _e992);
                        let _e996 = (_e974 * _e989);
                        let _e997 = (_e980 * _e974);
                        let _e998 = (_e983 * _e971);
                        let _e1003 = (((_e993 >= _e994) && (_e995 >= _e996)) && (_e997 >= _e998));
                        let _e1009 = (_e1003 || (((_e993 <= _e994) && (_e995 <= _e996)) && (_e997 <= _e998)));
                        if _e1009 {
                            let _e1011 = select(-1f, 1f, _e1003);
                            let _e1013 = ((_e993 - _e994) * _e1011);
                            let _e1015 = select(0f, _e1013, (_e1013 > 0f));
                            let _e1017 = ((_e995 - _e996) * _e1011);
                            let _e1019 = select(0f, _e1017, (_e1017 > 0f));
                            let _e1021 = ((_e997 - _e998) * _e1011);
                            let _e1023 = select(0f, _e1021, (_e1021 > 0f));
                            let _e1025 = ((_e1015 + _e1019) + _e1023);
                            let _e1040 = ((min(min(_e938[0], _e946[0]), _e954[0]) - _e568) * _e571);
                            let _e1041 = ((max(max(_e938[0], _e946[0]), _e954[0]) - _e569) * _e571);
                            let _e1042 = vec4<f32>(_e1040, f32(), _e1041, f32());
                            let _e1045 = ((min(min(_e938[1], _e946[1]), _e954[1]) - _e584) * _e587);
                            let _e1046 = ((max(max(_e938[1], _e946[1]), _e954[1]) - _e585) * _e587);
                            let _e1047 = vec4<f32>(_e1045, f32(), _e1046, f32());
                            let _e1050 = ((min(min(_e938[2], _e946[2]), _e954[2]) - _e600) * _e603);
                            let _e1051 = ((max(max(_e938[2], _e946[2]), _e954[2]) - _e601) * _e603);
                            let _e1052 = vec4<f32>(_e1050, f32(), _e1051, f32());
                            let _e1053 = vec4<f32>(_e1041, f32(), _e1040, f32());
                            let _e1055 = vec4<f32>(_e1046, f32(), _e1045, f32());
                            let _e1057 = vec4<f32>(_e1051, f32(), _e1050, f32());
                            let _e1066 = max(max(min(_e1042, _e1053).x, min(_e1047, _e1055).x), min(_e1052, _e1057).x);
                            let _e1071 = min(min(max(_e1042, _e1053).x, max(_e1047, _e1055).x), max(_e1052, _e1057).x);
                            let _e1076 = max(_e1066, _e611);
                            let _e1098 = (((((_e1009 && (_e1025 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e971, _e980), _e989) <= 0f) && (max(max(_e971, _e980), _e989) >= 0f))) && ((min(min(_e974, _e983), _e992) <= 0f) && (max(max(_e974, _e983), _e992) >= 0f))) && (_e1076 <= (_e1071 + (max(max(_e1052, _e1057).x, -(min(_e1052, _e1057).x)) * 0.0000019073523f)))) && (_e1076 <= _e814.member.member_1));
                            if _e1098 {
                                let _e1103 = (_e946[0] - _e938[0]);
                                let _e1104 = (_e946[1] - _e938[1]);
                                let _e1105 = (_e946[2] - _e938[2]);
                                let _e1106 = vec3<f32>(_e1103, _e1104, _e1105);
                                let _e1107 = (_e954[0] - _e946[0]);
                                let _e1108 = (_e954[1] - _e946[1]);
                                let _e1109 = (_e954[2] - _e946[2]);
                                let _e1110 = vec3<f32>(_e1107, _e1108, _e1109);
                                let _e1111 = (_e938[0] - _e954[0]);
                                let _e1112 = (_e938[1] - _e954[1]);
                                let _e1113 = (_e938[2] - _e954[2]);
                                let _e1114 = vec3<f32>(_e1111, _e1112, _e1113);
                                let _e1125 = max(max(bitcast<f32>((bitcast<u32>(_e1103) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1104) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1105) & 2147483647u)));
                                let _e1136 = max(max(bitcast<f32>((bitcast<u32>(_e1107) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1108) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1109) & 2147483647u)));
                                let _e1149 = max(max(_e1125, _e1136), max(max(bitcast<f32>((bitcast<u32>(_e1111) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1112) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1113) & 2147483647u))));
                                if (_e1125 == _e1149) {
                                    phi_2179_ = _e983;
                                    phi_2180_ = _e980;
                                    phi_2181_ = _e974;
                                    phi_2182_ = _e971;
                                    phi_2183_ = vec3<f32>(_e938[0], _e938[1], _e938[2]);
                                    phi_2184_ = _e1114;
                                    phi_2185_ = _e1110;
                                    phi_2186_ = _e1106;
                                } else {
                                    let _e1151 = (_e1136 == _e1149);
                                    let _e1156 = vec3(_e1151);
                                    phi_2179_ = select(_e974, _e992, _e1151);
                                    phi_2180_ = select(_e971, _e989, _e1151);
                                    phi_2181_ = select(_e992, _e983, _e1151);
                                    phi_2182_ = select(_e989, _e980, _e1151);
                                    phi_2183_ = select(vec3<f32>(_e954[0], _e954[1], _e954[2]), vec3<f32>(_e946[0], _e946[1], _e946[2]), _e1156);
                                    phi_2184_ = select(_e1110, _e1106, _e1156);
                                    phi_2185_ = select(_e1106, _e1114, _e1156);
                                    phi_2186_ = select(_e1114, _e1110, _e1156);
                                }
                                let _e1162 = phi_2179_;
                                let _e1164 = phi_2180_;
                                let _e1166 = phi_2181_;
                                let _e1168 = phi_2182_;
                                let _e1170 = phi_2183_;
                                let _e1172 = phi_2184_;
                                let _e1174 = phi_2185_;
                                let _e1176 = phi_2186_;
                                let _e1183 = ((_e1174.y * _e1172.z) - (_e1172.y * _e1174.z));
                                let _e1188 = ((_e1174.z * _e1172.x) - (_e1172.z * _e1174.x));
                                let _e1191 = ((_e1174.x * _e1172.y) - (_e1172.x * _e1174.y));
                                let _e1194 = ((_e1015 >= _e1019) && (_e1015 >= _e1023));
                                let _e1195 = (_e1019 >= _e1023);
                                let _e1209 = (((_e1183 * (select(select(_e954[0], _e946[0], _e1195), _e938[0], _e1194) - _e544.member[0])) + (_e1188 * (select(select(_e954[1], _e946[1], _e1195), _e938[1], _e1194) - _e544.member[1]))) + (_e1191 * (select(select(_e954[2], _e946[2], _e1195), _e938[2], _e1194) - _e544.member[2])));
                                let _e1214 = (((_e1183 * _e567) + (_e1188 * _e583)) + (_e1191 * _e599));
                                let _e1215 = (_e1164 - _e1168);
                                let _e1216 = (_e1162 - _e1166);
                                let _e1219 = ((_e1215 * _e1215) + (_e1216 * _e1216));
                                let _e1226 = (-(((_e1168 * _e1215) + (_e1166 * _e1216))) / select(0.000000000000000000000000000000000000011754944f, _e1219, (_e1219 > 0.000000000000000000000000000000000000011754944f)));
                                let _e1228 = select(1f, _e1226, (_e1226 < 1f));
                                let _e1230 = select(0f, _e1228, (_e1228 > 0f));
                                let _e1239 = ((_e1170.x + (_e1176.x * _e1230)) - _e544.member[0]);
                                let _e1242 = ((_e1170.y + (_e1176.y * _e1230)) - _e544.member[1]);
                                let _e1245 = ((_e1170.z + (_e1176.z * _e1230)) - _e544.member[2]);
                                let _e1310 = ((bitcast<f32>((bitcast<u32>(((((_e1183 * _e1239) + (_e1188 * _e1242)) + (_e1191 * _e1245)) - _e1209)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1239) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1242) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1245) & 2147483647u))), _e1149)) * max(max(bitcast<f32>((bitcast<u32>(_e1183) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1188) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1191) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1214) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1174.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1174.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1174.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1172.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1172.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1172.z) & 2147483647u)))))));
                                let _e1311 = (_e1209 / _e1214);
                                if (_e1098 && !(_e1310)) {
                                    let _e1314 = (_e1245 / _e599);
                                    let _e1322 = (((_e1183 * (_e1239 - (_e567 * _e1314))) + (_e1188 * (_e1242 - (_e583 * _e1314)))) / _e1214);
                                    phi_2365_ = select(select(_e1314, (_e1314 + _e1322), (bitcast<f32>((bitcast<u32>(_e1322) & 2147483647u)) <= _e1149)), _e1311, _e1310);
                                } else {
                                    phi_2365_ = _e1311;
                                }
                                let _e1331 = phi_2365_;
                                let _e1333 = select(_e1071, _e1331, (_e1331 < _e1071));
                                let _e1335 = select(_e1066, _e1333, (_e1333 > _e1066));
                                let _e1338 = select(_e1335, 0f, (bitcast<u32>(_e1335) == 2147483648u));
                                let _e1339 = (1f / _e1025);
                                phi_2391_ = SlimbvhTypeF(_e1338, (_e1019 * _e1339), (_e1023 * _e1339), ((_e1098 && (_e1338 >= _e611)) && (_e1338 <= _e814.member.member_1)));
                                phi_2392_ = SlimbvhTypeF();
                            } else {
                                phi_2391_ = SlimbvhTypeF();
                                phi_2392_ = SlimbvhTypeF(0f, 0f, 0f, _e1098);
                            }
                            let _e1348 = phi_2391_;
                            let _e1350 = phi_2392_;
                            phi_2395_ = _e1348;
                            phi_2396_ = _e1350;
                            phi_2397_ = select(true, false, _e1098);
                        } else {
                            phi_2395_ = SlimbvhTypeF();
                            phi_2396_ = SlimbvhTypeF(0f, 0f, 0f, _e1009);
                            phi_2397_ = true;
                        }
                        let _e1353 = phi_2395_;
                        let _e1355 = phi_2396_;
                        let _e1357 = phi_2397_;
                        if _e1357 {
                            phi_2401_ = _e1355;
                        } else {
                            phi_2401_ = _e1353;
                        }
                        let _e1359 = phi_2401_;
                        if _e1359.member_3 {
                            phi_2410_ = SlimbvhTypeG(_e1359.member, _e1359.member_1, _e1359.member_2, _e877);
                        } else {
                            phi_2410_ = _e85;
                        }
                        let _e1366 = phi_2410_;
                        if (_e1366.member_3 != 4294967295u) {
                            let _e1372 = slimbvh_target.member[0u][0u];
                            let _e1376 = slimbvh_target.member[0u][1u];
                            let _e1380 = slimbvh_target.member[0u][2u];
                            let _e1384 = slimbvh_target.member[0u][3u];
                            let _e1388 = slimbvh_target.member[1u][0u];
                            let _e1392 = slimbvh_target.member[1u][1u];
                            let _e1396 = slimbvh_target.member[1u][2u];
                            let _e1400 = slimbvh_target.member[1u][3u];
                            let _e1401 = bitcast<f32>(_e1372);
                            let _e1402 = bitcast<f32>(_e1376);
                            let _e1403 = bitcast<f32>(_e1380);
                            let _e1405 = bitcast<f32>(_e1388);
                            let _e1406 = array<u32, 3>(_e1392, _e1396, _e1400);
                            if (_e114 < -126i) {
                                phi_2457_ = -126i;
                            } else {
                                phi_2457_ = select(_e114, 127i, (_e114 > 127i));
                            }
                            let _e1412 = phi_2457_;
                            let _e1417 = bitcast<f32>((bitcast<u32>((_e1412 + 127i)) << bitcast<u32>(23i)));
                            let _e1423 = bitcast<f32>((bitcast<u32>(((_e114 - _e1412) + 127i)) << bitcast<u32>(23i)));
                            if (_e1384 == 0u) {
                                phi_2597_ = SlimbvhTypeI(array<f32, 3>(_e1401, _e1402, _e1403), _e1384, _e1405, _e1406);
                            } else {
                                let _e1425 = bitcast<u32>(_e1401);
                                let _e1427 = ((_e1425 & 2139095040u) != 0u);
                                let _e1442 = bitcast<u32>(_e1402);
                                let _e1444 = ((_e1442 & 2139095040u) != 0u);
                                let _e1459 = bitcast<u32>(_e1403);
                                let _e1461 = ((_e1459 & 2139095040u) != 0u);
                                let _e1477 = bitcast<u32>(_e1405);
                                let _e1479 = ((_e1477 & 2139095040u) != 0u);
                                phi_2597_ = SlimbvhTypeI(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1425 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1425 & 2147483648u))), _e1401, _e1427) * _e1417) * select(0.00000011920929f, 1f, _e1427)) * _e1423), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1442 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1442 & 2147483648u))), _e1402, _e1444) * _e1417) * select(0.00000011920929f, 1f, _e1444)) * _e1423), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1459 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1459 & 2147483648u))), _e1403, _e1461) * _e1417) * select(0.00000011920929f, 1f, _e1461)) * _e1423)), _e1384, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1477 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1477 & 2147483648u))), _e1405, _e1479) * _e1417) * select(0.00000011920929f, 1f, _e1479)) * _e1423), _e1406);
                            }
                            let _e1496 = phi_2597_;
                            if (_e877 == _e615) {
                                phi_2923_ = false;
                            } else {
                                let _e1498 = (_e877 / 16u);
                                if (_e1498 < arrayLength((&slimbvh_sides.member))) {
                                    let _e1501 = slimbvh_sides.member[_e1498];
                                    phi_2621_ = _e1501;
                                } else {
                                    phi_2621_ = 0u;
                                }
                                let _e1503 = phi_2621_;
                                let _e1512 = (bitcast<i32>((_e1503 << bitcast<u32>(((30u - ((_e877 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                let _e1513 = (_e1512 == 0i);
                                if _e1513 {
                                    phi_2922_ = true;
                                } else {
                                    if _e161 {
                                        phi_2650_ = vec3<f32>(_e938[0], _e938[1], _e938[2]);
                                    } else {
                                        if (_e156 == 1u) {
                                            phi_2649_ = vec3<f32>(_e938[2], _e938[0], _e938[1]);
                                        } else {
                                            phi_2649_ = vec3<f32>(_e938[1], _e938[2], _e938[0]);
                                        }
                                        let _e1518 = phi_2649_;
                                        phi_2650_ = _e1518;
                                    }
                                    let _e1521 = phi_2650_;
                                    if _e161 {
                                        phi_2668_ = vec3<f32>(_e946[0], _e946[1], _e946[2]);
                                    } else {
                                        if (_e156 == 1u) {
                                            phi_2667_ = vec3<f32>(_e946[2], _e946[0], _e946[1]);
                                        } else {
                                            phi_2667_ = vec3<f32>(_e946[1], _e946[2], _e946[0]);
                                        }
                                        let _e1526 = phi_2667_;
                                        phi_2668_ = _e1526;
                                    }
                                    let _e1529 = phi_2668_;
                                    if _e161 {
                                        phi_2686_ = vec3<f32>(_e954[0], _e954[1], _e954[2]);
                                    } else {
                                        if (_e156 == 1u) {
                                            phi_2685_ = vec3<f32>(_e954[2], _e954[0], _e954[1]);
                                        } else {
                                            phi_2685_ = vec3<f32>(_e954[1], _e954[2], _e954[0]);
                                        }
                                        let _e1534 = phi_2685_;
                                        phi_2686_ = _e1534;
                                    }
                                    let _e1537 = phi_2686_;
                                    let _e1540 = (_e1529.x - _e1521.x);
                                    let _e1543 = (_e1529.y - _e1521.y);
                                    let _e1546 = (_e1529.z - _e1521.z);
                                    let _e1548 = (_e1537.x - _e1521.x);
                                    let _e1550 = (_e1537.y - _e1521.y);
                                    let _e1552 = (_e1537.z - _e1521.z);
                                    if (_e1496.member_1 == 1u) {
                                        phi_2722_ = (vec3<f32>(_e1496.member[0], _e1496.member[1], _e1496.member[2]) - _e1521);
                                    } else {
                                        phi_2722_ = vec3<f32>(_e1496.member[0], _e1496.member[1], _e1496.member[2]);
                                    }
                                    let _e1567 = phi_2722_;
                                    let _e1573 = bitcast<f32>((bitcast<u32>((_e1540 * _e1550)) ^ _e1496.member_3[0]));
                                    let _e1577 = bitcast<f32>((bitcast<u32>((_e1543 * _e1548)) ^ _e1496.member_3[0]));
                                    let _e1581 = bitcast<f32>((bitcast<u32>((_e1543 * _e1552)) ^ _e1496.member_3[0]));
                                    let _e1585 = bitcast<f32>((bitcast<u32>((_e1546 * _e1550)) ^ _e1496.member_3[0]));
                                    let _e1589 = bitcast<f32>((bitcast<u32>((_e1546 * _e1548)) ^ _e1496.member_3[0]));
                                    let _e1593 = bitcast<f32>((bitcast<u32>((_e1540 * _e1552)) ^ _e1496.member_3[0]));
                                    let _e1594 = (_e1581 - _e1585);
                                    let _e1595 = (_e1589 - _e1593);
                                    let _e1596 = (_e1573 - _e1577);
                                    let _e1620 = (bitcast<f32>((bitcast<u32>(_e1581) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1585) & 2147483647u)));
                                    let _e1627 = (bitcast<f32>((bitcast<u32>(_e1589) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1593) & 2147483647u)));
                                    let _e1634 = (bitcast<f32>((bitcast<u32>(_e1573) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1577) & 2147483647u)));
                                    if (_e1496.member_2 == 0f) {
                                        phi_2904_ = 0f;
                                    } else {
                                        let _e1664 = bitcast<f32>((bitcast<u32>(_e1594) & 2147483647u));
                                        let _e1667 = bitcast<f32>((bitcast<u32>(_e1595) & 2147483647u));
                                        let _e1670 = bitcast<f32>((bitcast<u32>(_e1596) & 2147483647u));
                                        let _e1672 = select(_e1670, _e1667, (_e1667 > _e1670));
                                        let _e1676 = select(_e1670, _e1667, (_e1667 < _e1670));
                                        let _e1680 = select(_e1667, _e1664, (_e1664 < _e1667));
                                        let _e1682 = select(_e1667, _e1664, (_e1664 > _e1667));
                                        let _e1684 = select(_e1670, _e1682, (_e1682 < _e1670));
                                        phi_2904_ = bitcast<f32>((bitcast<u32>((_e1496.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1672, _e1664, (_e1664 > _e1672)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1684, _e1680, (_e1680 > _e1684)))) ^ _e1496.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1676, _e1664, (_e1664 < _e1676)))) ^ _e1496.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1620 + _e1627) + _e1634))) ^ _e1496.member_3[0]))) * 1.0000005f)) ^ _e1496.member_3[0])))) ^ _e1496.member_3[0]));
                                    }
                                    let _e1711 = phi_2904_;
                                    phi_2922_ = (_e1513 || !(((((bitcast<f32>((bitcast<u32>((_e1567.x * _e1594)) ^ _e1496.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1567.y * _e1595)) ^ _e1496.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1567.z * _e1596)) ^ _e1496.member_3[0]))) * f32(-(_e1512))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1567.x) & 2147483647u)) * _e1620)) ^ _e1496.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1567.y) & 2147483647u)) * _e1627)) ^ _e1496.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1567.z) & 2147483647u)) * _e1634)) ^ _e1496.member_3[0]))))) ^ _e1496.member_3[0])) + _e1711) + 0.0000000000000000000000000000000000001880791f))));
                                }
                                let _e1725 = phi_2922_;
                                phi_2923_ = _e1725;
                            }
                            let _e1727 = phi_2923_;
                            if _e1727 {
                                if (_e1366.member < _e814.member.member.member) {
                                    phi_2943_ = true;
                                } else {
                                    if (_e1366.member == _e814.member.member.member) {
                                        phi_2942_ = (_e1366.member_3 < _e814.member.member.member_3);
                                    } else {
                                        phi_2942_ = false;
                                    }
                                    let _e1739 = phi_2942_;
                                    phi_2943_ = _e1739;
                                }
                                let _e1741 = phi_2943_;
                                if _e1741 {
                                    phi_2950_ = SlimbvhTypeN(SlimbvhTypeJ(_e1366, _e1366.member), _e814.member_1);
                                } else {
                                    phi_2950_ = _e814;
                                }
                                let _e1747 = phi_2950_;
                                if _e1747.member_1 {
                                    phi_2956_ = SlimbvhTypeN(SlimbvhTypeJ(_e1747.member.member, bitcast<f32>(4286578687u)), _e1747.member_1);
                                } else {
                                    phi_2956_ = _e1747;
                                }
                                let _e1756 = phi_2956_;
                                phi_2957_ = _e1756;
                            } else {
                                phi_2957_ = _e814;
                            }
                            let _e1758 = phi_2957_;
                            phi_2958_ = _e1758;
                        } else {
                            phi_2958_ = _e814;
                        }
                        let _e1760 = phi_2958_;
                        phi_1612_ = _e1760;
                    } else {
                        phi_1612_ = SlimbvhTypeN();
                    }
                    let _e1762 = phi_1612_;
                    continue;
                    continuing {
                        phi_1611_ = _e1762;
                        phi_1614_ = _e829;
                        break if !(_e835);
                    }
                }
                let _e1765 = local_5;
                let _e1766 = (_e1765 - 1u);
                let _e1767 = (_e1766 % 128u);
                let _e1769 = local[_e1767];
                let _e1771 = local_6;
                if (_e1769 <= _e1771.member.member_1) {
                    let _e1776 = local_1[_e1767];
                    phi_2983_ = _e1776;
                } else {
                    phi_2983_ = 2147483648u;
                }
                let _e1778 = phi_2983_;
                let _e2028 = local_8;
                phi_2990_ = _e2028;
                phi_2991_ = select(_e1766, 4294967295u, (_e611 > _e1771.member.member_1));
                phi_2992_ = _e1778;
            } else {
                phi_2990_ = _e634;
                let _e2031 = local_9;
                phi_2991_ = _e2031;
                let _e2034 = local_10;
                phi_2992_ = _e2034;
            }
            let _e1782 = phi_2990_;
            let _e1784 = phi_2991_;
            let _e1786 = phi_2992_;
            phi_1276_ = _e1782;
            phi_1279_ = _e1784;
            phi_1281_ = _e1786;
            let _e2040 = local_11;
            phi_1283_ = _e2040;
        } else {
            phi_1276_ = SlimbvhTypeN();
            phi_1279_ = u32();
            phi_1281_ = u32();
            phi_1283_ = u32();
        }
        let _e1788 = phi_1276_;
        let _e1790 = phi_1279_;
        let _e1792 = phi_1281_;
        let _e1794 = phi_1283_;
        continue;
        continuing {
            phi_1275_ = _e1788;
            phi_1278_ = _e1790;
            phi_1280_ = _e1792;
            phi_1282_ = _e1794;
            break if !(_e641);
        }
    }
    let _e1797 = local_7;
    if (_e1797.member.member.member_3 != 4294967295u) {
        let _e1803 = -((_e114 + _e544.member_4));
        let _e1804 = bitcast<u32>(_e1797.member.member.member);
        let _e1808 = (bitcast<i32>((_e1804 >> bitcast<u32>(23i))) & 255i);
        let _e1809 = (_e1808 + _e1803);
        if (_e1808 == 255i) {
            phi_3047_ = _e1797.member.member.member;
        } else {
            if (_e1808 > 0i) {
                if (_e1809 > 0i) {
                    let _e1813 = (_e1809 < 255i);
                    if _e1813 {
                        phi_3026_ = bitcast<f32>((_e1804 + bitcast<u32>((_e1803 << bitcast<u32>(23i)))));
                    } else {
                        phi_3026_ = f32();
                    }
                    let _e1820 = phi_3026_;
                    phi_3028_ = _e1820;
                    phi_3029_ = select(true, false, _e1813);
                } else {
                    phi_3028_ = f32();
                    phi_3029_ = true;
                }
                let _e1823 = phi_3028_;
                let _e1825 = phi_3029_;
                phi_3030_ = _e1823;
                phi_3031_ = _e1825;
            } else {
                phi_3030_ = f32();
                phi_3031_ = true;
            }
            let _e1827 = phi_3030_;
            let _e1829 = phi_3031_;
            if _e1829 {
                let _e1830 = (_e1804 & 2147483648u);
                let _e1837 = ((_e1804 & 8388607u) | (select(0u, 1u, ((_e1804 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e1841 = (_e1837 == 0u);
                if _e1841 {
                    phi_3462_ = bitcast<f32>(_e1830);
                } else {
                    let _e1846 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1837)), 32u, _e1841) - 8u);
                    let _e1849 = (_e1837 << bitcast<u32>((_e1846 & 31u)));
                    let _e1851 = ((_e1809 + select(0i, 1i, (_e1808 == 0i))) - bitcast<i32>(_e1846));
                    if (_e1851 >= 255i) {
                        phi_3452_ = bitcast<f32>((_e1830 | 2139095040u));
                        phi_3453_ = f32();
                        phi_3454_ = true;
                    } else {
                        let _e1853 = (_e1851 > 0i);
                        if _e1853 {
                            phi_3446_ = bitcast<f32>(((_e1830 | (bitcast<u32>(_e1851) << bitcast<u32>(23i))) | (_e1849 & 8388607u)));
                            phi_3447_ = f32();
                        } else {
                            if (_e1851 < -24i) {
                                phi_3412_ = 26u;
                            } else {
                                phi_3412_ = bitcast<u32>((1i - _e1851));
                            }
                            let _e1858 = phi_3412_;
                            let _e1859 = (_e1858 & 31u);
                            let _e1861 = (_e1849 >> bitcast<u32>(_e1859));
                            let _e1865 = (_e1849 & ((1u << bitcast<u32>(_e1859)) - 1u));
                            let _e1869 = (1u << bitcast<u32>(((_e1858 - 1u) & 31u)));
                            if (_e1865 > _e1869) {
                                phi_3433_ = true;
                            } else {
                                if (_e1865 == _e1869) {
                                    phi_3430_ = ((_e1861 & 1u) == 1u);
                                } else {
                                    phi_3430_ = false;
                                }
                                let _e1875 = phi_3430_;
                                phi_3433_ = _e1875;
                            }
                            let _e1877 = phi_3433_;
                            phi_3446_ = f32();
                            phi_3447_ = bitcast<f32>((_e1830 | (_e1861 + select(0u, 1u, _e1877))));
                        }
                        let _e1890 = phi_3446_;
                        let _e1892 = phi_3447_;
                        phi_3452_ = _e1890;
                        phi_3453_ = _e1892;
                        phi_3454_ = _e1853;
                    }
                    let _e1896 = phi_3452_;
                    let _e1898 = phi_3453_;
                    let _e1900 = phi_3454_;
                    phi_3462_ = select(_e1898, _e1896, _e1900);
                }
                let _e1904 = phi_3462_;
                phi_3046_ = _e1904;
            } else {
                phi_3046_ = _e1827;
            }
            let _e1906 = phi_3046_;
            phi_3047_ = _e1906;
        }
        let _e1908 = phi_3047_;
        let _e1909 = bitcast<u32>(_e1908);
        if ((_e1909 & 2147483647u) >= 2139095040u) {
            phi_3059_ = bitcast<f32>(((_e1909 & 2147483648u) | 2139095039u));
        } else {
            phi_3059_ = _e1908;
        }
        let _e1916 = phi_3059_;
        phi_3064_ = SlimbvhTypeG(_e1916, _e1797.member.member.member_1, _e1797.member.member.member_2, _e1797.member.member.member_3);
    } else {
        phi_3064_ = _e85;
    }
    let _e1921 = phi_3064_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1921.member), bitcast<u32>(_e1921.member_1), bitcast<u32>(_e1921.member_2), _e1921.member_3);
    return;
}

struct SlimbvhTypeO {
    member: array<vec4<f32>, 3>,
}

struct SlimbvhTypeP {
    member: vec2<f32>,
}

struct SlimbvhTypeQ {
    member: array<vec4<f32>, 5>,
}

var<private> slimbvh_corners: SlimbvhTypeO;

var<private> slimbvh_weights: SlimbvhTypeP;

var<private> slimbvh_from: SlimbvhTypeL;

var<private> slimbvh_point: SlimbvhTypeQ;

fn slimbvh_find_surface() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var phi_214_: i32;
    var phi_708_: i32;
    var phi_739_: i32;
    var phi_758_: vec3<f32>;
    var phi_898_: SlimbvhTypeE;
    var phi_899_: SlimbvhTypeE;
    var phi_922_: SlimbvhTypeE;
    var phi_971_: f32;
    var phi_973_: f32;
    var phi_974_: bool;
    var phi_975_: f32;
    var phi_976_: bool;
    var phi_1616_: u32;
    var phi_1634_: bool;
    var phi_1637_: bool;
    var phi_1650_: f32;
    var phi_1651_: f32;
    var phi_1656_: f32;
    var phi_1657_: f32;
    var phi_1658_: bool;
    var phi_1666_: f32;
    var phi_991_: f32;
    var phi_992_: f32;
    var phi_1005_: f32;
    var phi_1032_: f32;
    var phi_1034_: f32;
    var phi_1035_: bool;
    var phi_1036_: f32;
    var phi_1037_: bool;
    var phi_1690_: u32;
    var phi_1708_: bool;
    var phi_1711_: bool;
    var phi_1724_: f32;
    var phi_1725_: f32;
    var phi_1730_: f32;
    var phi_1731_: f32;
    var phi_1732_: bool;
    var phi_1740_: f32;
    var phi_1052_: f32;
    var phi_1053_: f32;
    var phi_1066_: f32;
    var phi_1092_: f32;
    var phi_1094_: f32;
    var phi_1095_: bool;
    var phi_1096_: f32;
    var phi_1097_: bool;
    var phi_1764_: u32;
    var phi_1782_: bool;
    var phi_1785_: bool;
    var phi_1798_: f32;
    var phi_1799_: f32;
    var phi_1804_: f32;
    var phi_1805_: f32;
    var phi_1806_: bool;
    var phi_1814_: f32;
    var phi_1112_: f32;
    var phi_1113_: f32;
    var phi_1143_: f32;
    var phi_1145_: f32;
    var phi_1146_: bool;
    var phi_1147_: f32;
    var phi_1148_: bool;
    var phi_1838_: u32;
    var phi_1856_: bool;
    var phi_1859_: bool;
    var phi_1872_: f32;
    var phi_1873_: f32;
    var phi_1878_: f32;
    var phi_1879_: f32;
    var phi_1880_: bool;
    var phi_1888_: f32;
    var phi_1163_: f32;
    var phi_1164_: f32;
    var phi_1170_: bool;
    var phi_1190_: f32;
    var phi_1191_: f32;
    var phi_1192_: f32;
    var phi_1307_: f32;
    var phi_1308_: f32;
    var phi_1310_: f32;
    var phi_1284_: f32;
    var phi_1285_: f32;
    var phi_1311_: f32;
    var phi_1355_: f32;
    var phi_1356_: f32;
    var phi_1358_: f32;
    var phi_1332_: f32;
    var phi_1333_: f32;
    var phi_1359_: f32;
    var phi_1403_: f32;
    var phi_1404_: f32;
    var phi_1406_: f32;
    var phi_1380_: f32;
    var phi_1381_: f32;
    var phi_1407_: f32;
    var phi_1490_: f32;
    var phi_1491_: f32;
    var phi_1493_: f32;
    var phi_1467_: f32;
    var phi_1468_: f32;
    var phi_1494_: f32;
    var phi_1538_: f32;
    var phi_1539_: f32;
    var phi_1541_: f32;
    var phi_1515_: f32;
    var phi_1516_: f32;
    var phi_1542_: f32;
    var phi_1586_: f32;
    var phi_1587_: f32;
    var phi_1589_: f32;
    var phi_1563_: f32;
    var phi_1564_: f32;
    var phi_1590_: f32;

    let _e51 = bitcast<f32>(2139095039u);
    let _e55 = slimbvh_corners.member[0u];
    let _e61 = slimbvh_corners.member[1u];
    let _e67 = slimbvh_corners.member[2u];
    let _e73 = slimbvh_exponent.member[0u];
    let _e74 = bitcast<i32>(_e73);
    if (_e74 < -126i) {
        phi_214_ = -126i;
    } else {
        phi_214_ = select(_e74, 127i, (_e74 > 127i));
    }
    let _e79 = phi_214_;
    let _e84 = bitcast<f32>((bitcast<u32>((_e79 + 127i)) << bitcast<u32>(23i)));
    let _e90 = bitcast<f32>((bitcast<u32>(((_e74 - _e79) + 127i)) << bitcast<u32>(23i)));
    let _e91 = bitcast<u32>(_e55.x);
    let _e93 = ((_e91 & 2139095040u) != 0u);
    let _e107 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e91 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e91 & 2147483648u))), _e55.x, _e93) * _e84) * select(0.00000011920929f, 1f, _e93)) * _e90);
    let _e112 = select(_e107, 0f, (bitcast<f32>((bitcast<u32>(_e107) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e113 = bitcast<u32>(_e55.y);
    let _e115 = ((_e113 & 2139095040u) != 0u);
    let _e129 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e113 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e113 & 2147483648u))), _e55.y, _e115) * _e84) * select(0.00000011920929f, 1f, _e115)) * _e90);
    let _e134 = select(_e129, 0f, (bitcast<f32>((bitcast<u32>(_e129) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e135 = bitcast<u32>(_e55.z);
    let _e137 = ((_e135 & 2139095040u) != 0u);
    let _e151 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e135 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e135 & 2147483648u))), _e55.z, _e137) * _e84) * select(0.00000011920929f, 1f, _e137)) * _e90);
    let _e156 = select(_e151, 0f, (bitcast<f32>((bitcast<u32>(_e151) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e157 = bitcast<u32>(_e61.x);
    let _e159 = ((_e157 & 2139095040u) != 0u);
    let _e173 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e157 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e157 & 2147483648u))), _e61.x, _e159) * _e84) * select(0.00000011920929f, 1f, _e159)) * _e90);
    let _e178 = select(_e173, 0f, (bitcast<f32>((bitcast<u32>(_e173) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e179 = bitcast<u32>(_e61.y);
    let _e181 = ((_e179 & 2139095040u) != 0u);
    let _e195 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e179 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e179 & 2147483648u))), _e61.y, _e181) * _e84) * select(0.00000011920929f, 1f, _e181)) * _e90);
    let _e200 = select(_e195, 0f, (bitcast<f32>((bitcast<u32>(_e195) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e201 = bitcast<u32>(_e61.z);
    let _e203 = ((_e201 & 2139095040u) != 0u);
    let _e217 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e201 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e201 & 2147483648u))), _e61.z, _e203) * _e84) * select(0.00000011920929f, 1f, _e203)) * _e90);
    let _e222 = select(_e217, 0f, (bitcast<f32>((bitcast<u32>(_e217) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e223 = bitcast<u32>(_e67.x);
    let _e225 = ((_e223 & 2139095040u) != 0u);
    let _e239 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e223 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e223 & 2147483648u))), _e67.x, _e225) * _e84) * select(0.00000011920929f, 1f, _e225)) * _e90);
    let _e244 = select(_e239, 0f, (bitcast<f32>((bitcast<u32>(_e239) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e245 = bitcast<u32>(_e67.y);
    let _e247 = ((_e245 & 2139095040u) != 0u);
    let _e261 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e245 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e245 & 2147483648u))), _e67.y, _e247) * _e84) * select(0.00000011920929f, 1f, _e247)) * _e90);
    let _e266 = select(_e261, 0f, (bitcast<f32>((bitcast<u32>(_e261) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e267 = bitcast<u32>(_e67.z);
    let _e269 = ((_e267 & 2139095040u) != 0u);
    let _e283 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e267 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e267 & 2147483648u))), _e67.z, _e269) * _e84) * select(0.00000011920929f, 1f, _e269)) * _e90);
    let _e288 = select(_e283, 0f, (bitcast<f32>((bitcast<u32>(_e283) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e291 = slimbvh_weights.member[0u];
    let _e294 = slimbvh_weights.member[1u];
    let _e295 = slimbvh_from.member;
    let _e300 = ((1f - _e291) - _e294);
    let _e302 = select(0f, _e300, (_e300 > 0f));
    let _e304 = select(1f, _e291, (_e291 < 1f));
    let _e306 = select(1f, _e294, (_e294 < 1f));
    let _e307 = (_e112 * _e302);
    let _e308 = (_e134 * _e302);
    let _e309 = (_e156 * _e302);
    let _e310 = (_e178 * _e304);
    let _e311 = (_e200 * _e304);
    let _e312 = (_e222 * _e304);
    let _e313 = (_e244 * _e306);
    let _e314 = (_e266 * _e306);
    let _e315 = (_e288 * _e306);
    let _e358 = (_e178 - _e112);
    let _e359 = (_e200 - _e134);
    let _e360 = (_e222 - _e156);
    let _e361 = (_e244 - _e112);
    let _e362 = (_e266 - _e134);
    let _e363 = (_e288 - _e156);
    let _e366 = ((_e359 * _e363) - (_e362 * _e360));
    let _e369 = ((_e360 * _e361) - (_e363 * _e358));
    let _e372 = ((_e358 * _e362) - (_e361 * _e359));
    let _e375 = bitcast<f32>((bitcast<u32>(_e366) & 2147483647u));
    let _e378 = bitcast<f32>((bitcast<u32>(_e369) & 2147483647u));
    let _e380 = select(_e378, _e375, (_e375 > _e378));
    let _e383 = bitcast<f32>((bitcast<u32>(_e372) & 2147483647u));
    let _e385 = select(_e383, _e380, (_e380 > _e383));
    if (_e385 < 0.000000000000000000000000000000000000011754944f) {
        phi_758_ = vec3<f32>(0f, 0f, 0f);
    } else {
        let _e388 = (bitcast<u32>(_e385) & 2147483647u);
        let _e389 = (_e388 >= 8388608u);
        if _e389 {
            phi_708_ = (bitcast<i32>((_e388 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_708_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e388)), 32u, (_e388 == 0u))));
        }
        let _e402 = phi_708_;
        let _e409 = bitcast<f32>((bitcast<u32>(((_e402 / -2i) + 127i)) << bitcast<u32>(23i)));
        if _e389 {
            phi_739_ = (bitcast<i32>((_e388 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_739_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e388)), 32u, (_e388 == 0u))));
        }
        let _e425 = phi_739_;
        let _e431 = bitcast<f32>((bitcast<u32>((((_e402 / 2i) - _e425) + 127i)) << bitcast<u32>(23i)));
        let _e432 = ((_e366 * _e409) * _e431);
        let _e433 = ((_e369 * _e409) * _e431);
        let _e434 = ((_e372 * _e409) * _e431);
        let _e440 = sqrt((((_e432 * _e432) + (_e433 * _e433)) + (_e434 * _e434)));
        phi_758_ = vec3<f32>((_e432 / _e440), (_e433 / _e440), (_e434 / _e440));
    }
    let _e446 = phi_758_;
    let _e456 = select(1f, -1f, ((((_e446.x * _e295.x) + (_e446.y * _e295.y)) + (_e446.z * _e295.z)) > 0f));
    let _e457 = (_e446.x * _e456);
    let _e458 = (_e446.y * _e456);
    let _e459 = (_e446.z * _e456);
    local = array<f32, 3>(((_e307 + _e310) + _e313), ((_e308 + _e311) + _e314), ((_e309 + _e312) + _e315));
    local_1 = array<f32, 3>((((bitcast<f32>((bitcast<u32>(_e307) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e310) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e313) & 2147483647u))) * 0.00000071525625f), (((bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e311) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e314) & 2147483647u))) * 0.00000071525625f), (((bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e312) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e315) & 2147483647u))) * 0.00000071525625f));
    phi_898_ = SlimbvhTypeE(0u, 3u);
    loop {
        let _e463 = phi_898_;
        if (_e463.member < _e463.member_1) {
            phi_899_ = SlimbvhTypeE((_e463.member + 1u), _e463.member_1);
            phi_922_ = SlimbvhTypeE(1u, _e463.member);
        } else {
            phi_899_ = _e463;
            phi_922_ = SlimbvhTypeE(0u, SlimbvhTypeE().member_1);
        }
        let _e476 = phi_899_;
        let _e478 = phi_922_;
        let _e482 = (bitcast<i32>(_e478.member) != 0i);
        if _e482 {
            let _e484 = local[_e478.member_1];
            let _e486 = local_1[_e478.member_1];
            let _e487 = (_e486 + 0.000000000000000000000000000000000000047019774f);
            let _e488 = -(_e74);
            let _e489 = bitcast<u32>(_e484);
            let _e493 = (bitcast<i32>((_e489 >> bitcast<u32>(23i))) & 255i);
            let _e494 = (_e493 + _e488);
            if (_e493 == 255i) {
                phi_992_ = _e484;
            } else {
                if (_e493 > 0i) {
                    if (_e494 > 0i) {
                        let _e498 = (_e494 < 255i);
                        if _e498 {
                            phi_971_ = bitcast<f32>((_e489 + bitcast<u32>((_e488 << bitcast<u32>(23i)))));
                        } else {
                            phi_971_ = f32();
                        }
                        let _e505 = phi_971_;
                        phi_973_ = _e505;
                        phi_974_ = select(true, false, _e498);
                    } else {
                        phi_973_ = f32();
                        phi_974_ = true;
                    }
                    let _e508 = phi_973_;
                    let _e510 = phi_974_;
                    phi_975_ = _e508;
                    phi_976_ = _e510;
                } else {
                    phi_975_ = f32();
                    phi_976_ = true;
                }
                let _e512 = phi_975_;
                let _e514 = phi_976_;
                if _e514 {
                    let _e515 = (_e489 & 2147483648u);
                    let _e522 = ((_e489 & 8388607u) | (select(0u, 1u, ((_e489 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e526 = (_e522 == 0u);
                    if _e526 {
                        phi_1666_ = bitcast<f32>(_e515);
                    } else {
                        let _e531 = (select((bitcast<u32>(31i) - firstLeadingBit(_e522)), 32u, _e526) - 8u);
                        let _e534 = (_e522 << bitcast<u32>((_e531 & 31u)));
                        let _e536 = ((_e494 + select(0i, 1i, (_e493 == 0i))) - bitcast<i32>(_e531));
                        if (_e536 >= 255i) {
                            phi_1656_ = bitcast<f32>((_e515 | 2139095040u));
                            phi_1657_ = f32();
                            phi_1658_ = true;
                        } else {
                            let _e538 = (_e536 > 0i);
                            if _e538 {
                                phi_1650_ = bitcast<f32>(((_e515 | (bitcast<u32>(_e536) << bitcast<u32>(23i))) | (_e534 & 8388607u)));
                                phi_1651_ = f32();
                            } else {
                                if (_e536 < -24i) {
                                    phi_1616_ = 26u;
                                } else {
                                    phi_1616_ = bitcast<u32>((1i - _e536));
                                }
                                let _e543 = phi_1616_;
                                let _e544 = (_e543 & 31u);
                                let _e546 = (_e534 >> bitcast<u32>(_e544));
                                let _e550 = (_e534 & ((1u << bitcast<u32>(_e544)) - 1u));
                                let _e554 = (1u << bitcast<u32>(((_e543 - 1u) & 31u)));
                                if (_e550 > _e554) {
                                    phi_1637_ = true;
                                } else {
                                    if (_e550 == _e554) {
                                        phi_1634_ = ((_e546 & 1u) == 1u);
                                    } else {
                                        phi_1634_ = false;
                                    }
                                    let _e560 = phi_1634_;
                                    phi_1637_ = _e560;
                                }
                                let _e562 = phi_1637_;
                                phi_1650_ = f32();
                                phi_1651_ = bitcast<f32>((_e515 | (_e546 + select(0u, 1u, _e562))));
                            }
                            let _e575 = phi_1650_;
                            let _e577 = phi_1651_;
                            phi_1656_ = _e575;
                            phi_1657_ = _e577;
                            phi_1658_ = _e538;
                        }
                        let _e581 = phi_1656_;
                        let _e583 = phi_1657_;
                        let _e585 = phi_1658_;
                        phi_1666_ = select(_e583, _e581, _e585);
                    }
                    let _e589 = phi_1666_;
                    phi_991_ = _e589;
                } else {
                    phi_991_ = _e512;
                }
                let _e591 = phi_991_;
                phi_992_ = _e591;
            }
            let _e593 = phi_992_;
            let _e594 = bitcast<u32>(_e593);
            if (bitcast<f32>((_e594 & 2147483647u)) > _e51) {
                phi_1005_ = bitcast<f32>(((_e594 & 2147483648u) | 2139095039u));
            } else {
                phi_1005_ = _e593;
            }
            let _e602 = phi_1005_;
            let _e603 = bitcast<u32>(_e487);
            let _e607 = (bitcast<i32>((_e603 >> bitcast<u32>(23i))) & 255i);
            let _e608 = (_e607 + _e488);
            if (_e607 == 255i) {
                phi_1053_ = _e487;
            } else {
                if (_e607 > 0i) {
                    if (_e608 > 0i) {
                        let _e612 = (_e608 < 255i);
                        if _e612 {
                            phi_1032_ = bitcast<f32>((_e603 + bitcast<u32>((_e488 << bitcast<u32>(23i)))));
                        } else {
                            phi_1032_ = f32();
                        }
                        let _e619 = phi_1032_;
                        phi_1034_ = _e619;
                        phi_1035_ = select(true, false, _e612);
                    } else {
                        phi_1034_ = f32();
                        phi_1035_ = true;
                    }
                    let _e622 = phi_1034_;
                    let _e624 = phi_1035_;
                    phi_1036_ = _e622;
                    phi_1037_ = _e624;
                } else {
                    phi_1036_ = f32();
                    phi_1037_ = true;
                }
                let _e626 = phi_1036_;
                let _e628 = phi_1037_;
                if _e628 {
                    let _e629 = (_e603 & 2147483648u);
                    let _e636 = ((_e603 & 8388607u) | (select(0u, 1u, ((_e603 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e640 = (_e636 == 0u);
                    if _e640 {
                        phi_1740_ = bitcast<f32>(_e629);
                    } else {
                        let _e645 = (select((bitcast<u32>(31i) - firstLeadingBit(_e636)), 32u, _e640) - 8u);
                        let _e648 = (_e636 << bitcast<u32>((_e645 & 31u)));
                        let _e650 = ((_e608 + select(0i, 1i, (_e607 == 0i))) - bitcast<i32>(_e645));
                        if (_e650 >= 255i) {
                            phi_1730_ = bitcast<f32>((_e629 | 2139095040u));
                            phi_1731_ = f32();
                            phi_1732_ = true;
                        } else {
                            let _e652 = (_e650 > 0i);
                            if _e652 {
                                phi_1724_ = bitcast<f32>(((_e629 | (bitcast<u32>(_e650) << bitcast<u32>(23i))) | (_e648 & 8388607u)));
                                phi_1725_ = f32();
                            } else {
                                if (_e650 < -24i) {
                                    phi_1690_ = 26u;
                                } else {
                                    phi_1690_ = bitcast<u32>((1i - _e650));
                                }
                                let _e657 = phi_1690_;
                                let _e658 = (_e657 & 31u);
                                let _e660 = (_e648 >> bitcast<u32>(_e658));
                                let _e664 = (_e648 & ((1u << bitcast<u32>(_e658)) - 1u));
                                let _e668 = (1u << bitcast<u32>(((_e657 - 1u) & 31u)));
                                if (_e664 > _e668) {
                                    phi_1711_ = true;
                                } else {
                                    if (_e664 == _e668) {
                                        phi_1708_ = ((_e660 & 1u) == 1u);
                                    } else {
                                        phi_1708_ = false;
                                    }
                                    let _e674 = phi_1708_;
                                    phi_1711_ = _e674;
                                }
                                let _e676 = phi_1711_;
                                phi_1724_ = f32();
                                phi_1725_ = bitcast<f32>((_e629 | (_e660 + select(0u, 1u, _e676))));
                            }
                            let _e689 = phi_1724_;
                            let _e691 = phi_1725_;
                            phi_1730_ = _e689;
                            phi_1731_ = _e691;
                            phi_1732_ = _e652;
                        }
                        let _e695 = phi_1730_;
                        let _e697 = phi_1731_;
                        let _e699 = phi_1732_;
                        phi_1740_ = select(_e697, _e695, _e699);
                    }
                    let _e703 = phi_1740_;
                    phi_1052_ = _e703;
                } else {
                    phi_1052_ = _e626;
                }
                let _e705 = phi_1052_;
                phi_1053_ = _e705;
            }
            let _e707 = phi_1053_;
            let _e708 = bitcast<u32>(_e707);
            if (bitcast<f32>((_e708 & 2147483647u)) > _e51) {
                phi_1066_ = bitcast<f32>(((_e708 & 2147483648u) | 2139095039u));
            } else {
                phi_1066_ = _e707;
            }
            let _e716 = phi_1066_;
            let _e717 = bitcast<u32>(_e602);
            let _e721 = (bitcast<i32>((_e717 >> bitcast<u32>(23i))) & 255i);
            let _e722 = (_e721 + _e74);
            if (_e721 == 255i) {
                phi_1113_ = _e602;
            } else {
                if (_e721 > 0i) {
                    if (_e722 > 0i) {
                        let _e726 = (_e722 < 255i);
                        if _e726 {
                            phi_1092_ = bitcast<f32>((_e717 + bitcast<u32>((_e74 << bitcast<u32>(23i)))));
                        } else {
                            phi_1092_ = f32();
                        }
                        let _e733 = phi_1092_;
                        phi_1094_ = _e733;
                        phi_1095_ = select(true, false, _e726);
                    } else {
                        phi_1094_ = f32();
                        phi_1095_ = true;
                    }
                    let _e736 = phi_1094_;
                    let _e738 = phi_1095_;
                    phi_1096_ = _e736;
                    phi_1097_ = _e738;
                } else {
                    phi_1096_ = f32();
                    phi_1097_ = true;
                }
                let _e740 = phi_1096_;
                let _e742 = phi_1097_;
                if _e742 {
                    let _e743 = (_e717 & 2147483648u);
                    let _e750 = ((_e717 & 8388607u) | (select(0u, 1u, ((_e717 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                    let _e754 = (_e750 == 0u);
                    if _e754 {
                        phi_1814_ = bitcast<f32>(_e743);
                    } else {
                        let _e759 = (select((bitcast<u32>(31i) - firstLeadingBit(_e750)), 32u, _e754) - 8u);
                        let _e762 = (_e750 << bitcast<u32>((_e759 & 31u)));
                        let _e764 = ((_e722 + select(0i, 1i, (_e721 == 0i))) - bitcast<i32>(_e759));
                        if (_e764 >= 255i) {
                            phi_1804_ = bitcast<f32>((_e743 | 2139095040u));
                            phi_1805_ = f32();
                            phi_1806_ = true;
                        } else {
                            let _e766 = (_e764 > 0i);
                            if _e766 {
                                phi_1798_ = bitcast<f32>(((_e743 | (bitcast<u32>(_e764) << bitcast<u32>(23i))) | (_e762 & 8388607u)));
                                phi_1799_ = f32();
                            } else {
                                if (_e764 < -24i) {
                                    phi_1764_ = 26u;
                                } else {
                                    phi_1764_ = bitcast<u32>((1i - _e764));
                                }
                                let _e771 = phi_1764_;
                                let _e772 = (_e771 & 31u);
                                let _e774 = (_e762 >> bitcast<u32>(_e772));
                                let _e778 = (_e762 & ((1u << bitcast<u32>(_e772)) - 1u));
                                let _e782 = (1u << bitcast<u32>(((_e771 - 1u) & 31u)));
                                if (_e778 > _e782) {
                                    phi_1785_ = true;
                                } else {
                                    if (_e778 == _e782) {
                                        phi_1782_ = ((_e774 & 1u) == 1u);
                                    } else {
                                        phi_1782_ = false;
                                    }
                                    let _e788 = phi_1782_;
                                    phi_1785_ = _e788;
                                }
                                let _e790 = phi_1785_;
                                phi_1798_ = f32();
                                phi_1799_ = bitcast<f32>((_e743 | (_e774 + select(0u, 1u, _e790))));
                            }
                            let _e803 = phi_1798_;
                            let _e805 = phi_1799_;
                            phi_1804_ = _e803;
                            phi_1805_ = _e805;
                            phi_1806_ = _e766;
                        }
                        let _e809 = phi_1804_;
                        let _e811 = phi_1805_;
                        let _e813 = phi_1806_;
                        phi_1814_ = select(_e811, _e809, _e813);
                    }
                    let _e817 = phi_1814_;
                    phi_1112_ = _e817;
                } else {
                    phi_1112_ = _e740;
                }
                let _e819 = phi_1112_;
                phi_1113_ = _e819;
            }
            let _e821 = phi_1113_;
            if (_e821 == _e484) {
                let _e823 = bitcast<u32>(_e716);
                let _e827 = (bitcast<i32>((_e823 >> bitcast<u32>(23i))) & 255i);
                let _e828 = (_e827 + _e74);
                if (_e827 == 255i) {
                    phi_1164_ = _e716;
                } else {
                    if (_e827 > 0i) {
                        if (_e828 > 0i) {
                            let _e832 = (_e828 < 255i);
                            if _e832 {
                                phi_1143_ = bitcast<f32>((_e823 + bitcast<u32>((_e74 << bitcast<u32>(23i)))));
                            } else {
                                phi_1143_ = f32();
                            }
                            let _e839 = phi_1143_;
                            phi_1145_ = _e839;
                            phi_1146_ = select(true, false, _e832);
                        } else {
                            phi_1145_ = f32();
                            phi_1146_ = true;
                        }
                        let _e842 = phi_1145_;
                        let _e844 = phi_1146_;
                        phi_1147_ = _e842;
                        phi_1148_ = _e844;
                    } else {
                        phi_1147_ = f32();
                        phi_1148_ = true;
                    }
                    let _e846 = phi_1147_;
                    let _e848 = phi_1148_;
                    if _e848 {
                        let _e849 = (_e823 & 2147483648u);
                        let _e856 = ((_e823 & 8388607u) | (select(0u, 1u, ((_e823 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e860 = (_e856 == 0u);
                        if _e860 {
                            phi_1888_ = bitcast<f32>(_e849);
                        } else {
                            let _e865 = (select((bitcast<u32>(31i) - firstLeadingBit(_e856)), 32u, _e860) - 8u);
                            let _e868 = (_e856 << bitcast<u32>((_e865 & 31u)));
                            let _e870 = ((_e828 + select(0i, 1i, (_e827 == 0i))) - bitcast<i32>(_e865));
                            if (_e870 >= 255i) {
                                phi_1878_ = bitcast<f32>((_e849 | 2139095040u));
                                phi_1879_ = f32();
                                phi_1880_ = true;
                            } else {
                                let _e872 = (_e870 > 0i);
                                if _e872 {
                                    phi_1872_ = bitcast<f32>(((_e849 | (bitcast<u32>(_e870) << bitcast<u32>(23i))) | (_e868 & 8388607u)));
                                    phi_1873_ = f32();
                                } else {
                                    if (_e870 < -24i) {
                                        phi_1838_ = 26u;
                                    } else {
                                        phi_1838_ = bitcast<u32>((1i - _e870));
                                    }
                                    let _e877 = phi_1838_;
                                    let _e878 = (_e877 & 31u);
                                    let _e880 = (_e868 >> bitcast<u32>(_e878));
                                    let _e884 = (_e868 & ((1u << bitcast<u32>(_e878)) - 1u));
                                    let _e888 = (1u << bitcast<u32>(((_e877 - 1u) & 31u)));
                                    if (_e884 > _e888) {
                                        phi_1859_ = true;
                                    } else {
                                        if (_e884 == _e888) {
                                            phi_1856_ = ((_e880 & 1u) == 1u);
                                        } else {
                                            phi_1856_ = false;
                                        }
                                        let _e894 = phi_1856_;
                                        phi_1859_ = _e894;
                                    }
                                    let _e896 = phi_1859_;
                                    phi_1872_ = f32();
                                    phi_1873_ = bitcast<f32>((_e849 | (_e880 + select(0u, 1u, _e896))));
                                }
                                let _e909 = phi_1872_;
                                let _e911 = phi_1873_;
                                phi_1878_ = _e909;
                                phi_1879_ = _e911;
                                phi_1880_ = _e872;
                            }
                            let _e915 = phi_1878_;
                            let _e917 = phi_1879_;
                            let _e919 = phi_1880_;
                            phi_1888_ = select(_e917, _e915, _e919);
                        }
                        let _e923 = phi_1888_;
                        phi_1163_ = _e923;
                    } else {
                        phi_1163_ = _e846;
                    }
                    let _e925 = phi_1163_;
                    phi_1164_ = _e925;
                }
                let _e927 = phi_1164_;
                phi_1170_ = select(true, false, (_e927 == _e487));
            } else {
                phi_1170_ = true;
            }
            let _e931 = phi_1170_;
            if _e931 {
                let _e932 = bitcast<u32>(_e716);
                if ((_e932 & 2147483647u) == 0u) {
                    phi_1191_ = 0.000000000000000000000000000000000000000000001f;
                } else {
                    if ((_e932 >> bitcast<u32>(31i)) == 0u) {
                        phi_1190_ = bitcast<f32>((_e932 + 1u));
                    } else {
                        phi_1190_ = bitcast<f32>((_e932 - 1u));
                    }
                    let _e943 = phi_1190_;
                    phi_1191_ = _e943;
                }
                let _e945 = phi_1191_;
                phi_1192_ = _e945;
            } else {
                phi_1192_ = _e716;
            }
            let _e947 = phi_1192_;
            local[_e478.member_1] = _e602;
            local_1[_e478.member_1] = _e947;
        }
        continue;
        continuing {
            phi_898_ = _e476;
            break if !(_e482);
        }
    }
    let _e949 = local;
    let _e953 = local_1;
    slimbvh_point.member[0u] = vec4<f32>(_e949[0], _e949[1], _e949[2], _e456);
    slimbvh_point.member[1u] = vec4<f32>(_e953[0], _e953[1], _e953[2], 0f);
    slimbvh_point.member[2u] = vec4<f32>(_e457, _e458, _e459, 0f);
    let _e967 = select(_e953[1], _e953[0], (_e953[0] > _e953[1]));
    let _e969 = select(_e953[2], _e967, (_e967 > _e953[2]));
    let _e981 = (_e969 * ((bitcast<f32>((bitcast<u32>(_e457) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e458) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e459) & 2147483647u))));
    let _e985 = (_e949[0] + (_e457 * _e981));
    let _e986 = (_e949[1] + (_e458 * _e981));
    let _e987 = (_e949[2] + (_e459 * _e981));
    if (_e457 > 0f) {
        let _e1008 = bitcast<u32>(_e985);
        if ((_e1008 & 2147483647u) == 0u) {
            phi_1285_ = 0.000000000000000000000000000000000000000000001f;
        } else {
            if ((_e1008 >> bitcast<u32>(31i)) == 0u) {
                phi_1284_ = bitcast<f32>((_e1008 + 1u));
            } else {
                phi_1284_ = bitcast<f32>((_e1008 - 1u));
            }
            let _e1019 = phi_1284_;
            phi_1285_ = _e1019;
        }
        let _e1021 = phi_1285_;
        phi_1311_ = _e1021;
    } else {
        if (_e457 < 0f) {
            let _e991 = bitcast<u32>(-(_e985));
            if ((_e991 & 2147483647u) == 0u) {
                phi_1308_ = 0.000000000000000000000000000000000000000000001f;
            } else {
                if ((_e991 >> bitcast<u32>(31i)) == 0u) {
                    phi_1307_ = bitcast<f32>((_e991 + 1u));
                } else {
                    phi_1307_ = bitcast<f32>((_e991 - 1u));
                }
                let _e1002 = phi_1307_;
                phi_1308_ = _e1002;
            }
            let _e1004 = phi_1308_;
            phi_1310_ = -(_e1004);
        } else {
            phi_1310_ = _e985;
        }
        let _e1007 = phi_1310_;
        phi_1311_ = _e1007;
    }
    let _e1023 = phi_1311_;
    if (_e458 > 0f) {
        let _e1044 = bitcast<u32>(_e986);
        if ((_e1044 & 2147483647u) == 0u) {
            phi_1333_ = 0.000000000000000000000000000000000000000000001f;
        } else {
            if ((_e1044 >> bitcast<u32>(31i)) == 0u) {
                phi_1332_ = bitcast<f32>((_e1044 + 1u));
            } else {
                phi_1332_ = bitcast<f32>((_e1044 - 1u));
            }
            let _e1055 = phi_1332_;
            phi_1333_ = _e1055;
        }
        let _e1057 = phi_1333_;
        phi_1359_ = _e1057;
    } else {
        if (_e458 < 0f) {
            let _e1027 = bitcast<u32>(-(_e986));
            if ((_e1027 & 2147483647u) == 0u) {
                phi_1356_ = 0.000000000000000000000000000000000000000000001f;
            } else {
                if ((_e1027 >> bitcast<u32>(31i)) == 0u) {
                    phi_1355_ = bitcast<f32>((_e1027 + 1u));
                } else {
                    phi_1355_ = bitcast<f32>((_e1027 - 1u));
                }
                let _e1038 = phi_1355_;
                phi_1356_ = _e1038;
            }
            let _e1040 = phi_1356_;
            phi_1358_ = -(_e1040);
        } else {
            phi_1358_ = _e986;
        }
        let _e1043 = phi_1358_;
        phi_1359_ = _e1043;
    }
    let _e1059 = phi_1359_;
    if (_e459 > 0f) {
        let _e1080 = bitcast<u32>(_e987);
        if ((_e1080 & 2147483647u) == 0u) {
            phi_1381_ = 0.000000000000000000000000000000000000000000001f;
        } else {
            if ((_e1080 >> bitcast<u32>(31i)) == 0u) {
                phi_1380_ = bitcast<f32>((_e1080 + 1u));
            } else {
                phi_1380_ = bitcast<f32>((_e1080 - 1u));
            }
            let _e1091 = phi_1380_;
            phi_1381_ = _e1091;
        }
        let _e1093 = phi_1381_;
        phi_1407_ = _e1093;
    } else {
        if (_e459 < 0f) {
            let _e1063 = bitcast<u32>(-(_e987));
            if ((_e1063 & 2147483647u) == 0u) {
                phi_1404_ = 0.000000000000000000000000000000000000000000001f;
            } else {
                if ((_e1063 >> bitcast<u32>(31i)) == 0u) {
                    phi_1403_ = bitcast<f32>((_e1063 + 1u));
                } else {
                    phi_1403_ = bitcast<f32>((_e1063 - 1u));
                }
                let _e1074 = phi_1403_;
                phi_1404_ = _e1074;
            }
            let _e1076 = phi_1404_;
            phi_1406_ = -(_e1076);
        } else {
            phi_1406_ = _e987;
        }
        let _e1079 = phi_1406_;
        phi_1407_ = _e1079;
    }
    let _e1095 = phi_1407_;
    slimbvh_point.member[3u] = vec4<f32>(_e1023, _e1059, _e1095, 0f);
    let _e1099 = (_e457 * -1f);
    let _e1100 = (_e458 * -1f);
    let _e1101 = (_e459 * -1f);
    let _e1113 = (_e969 * ((bitcast<f32>((bitcast<u32>(_e1099) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1100) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e1101) & 2147483647u))));
    let _e1117 = (_e949[0] + (_e1099 * _e1113));
    let _e1118 = (_e949[1] + (_e1100 * _e1113));
    let _e1119 = (_e949[2] + (_e1101 * _e1113));
    if (_e1099 > 0f) {
        let _e1140 = bitcast<u32>(_e1117);
        if ((_e1140 & 2147483647u) == 0u) {
            phi_1468_ = 0.000000000000000000000000000000000000000000001f;
        } else {
            if ((_e1140 >> bitcast<u32>(31i)) == 0u) {
                phi_1467_ = bitcast<f32>((_e1140 + 1u));
            } else {
                phi_1467_ = bitcast<f32>((_e1140 - 1u));
            }
            let _e1151 = phi_1467_;
            phi_1468_ = _e1151;
        }
        let _e1153 = phi_1468_;
        phi_1494_ = _e1153;
    } else {
        if (_e1099 < 0f) {
            let _e1123 = bitcast<u32>(-(_e1117));
            if ((_e1123 & 2147483647u) == 0u) {
                phi_1491_ = 0.000000000000000000000000000000000000000000001f;
            } else {
                if ((_e1123 >> bitcast<u32>(31i)) == 0u) {
                    phi_1490_ = bitcast<f32>((_e1123 + 1u));
                } else {
                    phi_1490_ = bitcast<f32>((_e1123 - 1u));
                }
                let _e1134 = phi_1490_;
                phi_1491_ = _e1134;
            }
            let _e1136 = phi_1491_;
            phi_1493_ = -(_e1136);
        } else {
            phi_1493_ = _e1117;
        }
        let _e1139 = phi_1493_;
        phi_1494_ = _e1139;
    }
    let _e1155 = phi_1494_;
    if (_e1100 > 0f) {
        let _e1176 = bitcast<u32>(_e1118);
        if ((_e1176 & 2147483647u) == 0u) {
            phi_1516_ = 0.000000000000000000000000000000000000000000001f;
        } else {
            if ((_e1176 >> bitcast<u32>(31i)) == 0u) {
                phi_1515_ = bitcast<f32>((_e1176 + 1u));
            } else {
                phi_1515_ = bitcast<f32>((_e1176 - 1u));
            }
            let _e1187 = phi_1515_;
            phi_1516_ = _e1187;
        }
        let _e1189 = phi_1516_;
        phi_1542_ = _e1189;
    } else {
        if (_e1100 < 0f) {
            let _e1159 = bitcast<u32>(-(_e1118));
            if ((_e1159 & 2147483647u) == 0u) {
                phi_1539_ = 0.000000000000000000000000000000000000000000001f;
            } else {
                if ((_e1159 >> bitcast<u32>(31i)) == 0u) {
                    phi_1538_ = bitcast<f32>((_e1159 + 1u));
                } else {
                    phi_1538_ = bitcast<f32>((_e1159 - 1u));
                }
                let _e1170 = phi_1538_;
                phi_1539_ = _e1170;
            }
            let _e1172 = phi_1539_;
            phi_1541_ = -(_e1172);
        } else {
            phi_1541_ = _e1118;
        }
        let _e1175 = phi_1541_;
        phi_1542_ = _e1175;
    }
    let _e1191 = phi_1542_;
    if (_e1101 > 0f) {
        let _e1212 = bitcast<u32>(_e1119);
        if ((_e1212 & 2147483647u) == 0u) {
            phi_1564_ = 0.000000000000000000000000000000000000000000001f;
        } else {
            if ((_e1212 >> bitcast<u32>(31i)) == 0u) {
                phi_1563_ = bitcast<f32>((_e1212 + 1u));
            } else {
                phi_1563_ = bitcast<f32>((_e1212 - 1u));
            }
            let _e1223 = phi_1563_;
            phi_1564_ = _e1223;
        }
        let _e1225 = phi_1564_;
        phi_1590_ = _e1225;
    } else {
        if (_e1101 < 0f) {
            let _e1195 = bitcast<u32>(-(_e1119));
            if ((_e1195 & 2147483647u) == 0u) {
                phi_1587_ = 0.000000000000000000000000000000000000000000001f;
            } else {
                if ((_e1195 >> bitcast<u32>(31i)) == 0u) {
                    phi_1586_ = bitcast<f32>((_e1195 + 1u));
                } else {
                    phi_1586_ = bitcast<f32>((_e1195 - 1u));
                }
                let _e1206 = phi_1586_;
                phi_1587_ = _e1206;
            }
            let _e1208 = phi_1587_;
            phi_1589_ = -(_e1208);
        } else {
            phi_1589_ = _e1119;
        }
        let _e1211 = phi_1589_;
        phi_1590_ = _e1211;
    }
    let _e1227 = phi_1590_;
    slimbvh_point.member[4u] = vec4<f32>(_e1155, _e1191, _e1227, 0f);
    return;
}

struct SlimbvhHit {
    t: f32,
    u: f32,
    v: f32,
    primitive: u32,
}

struct SlimbvhSurface {
    position: vec3<f32>,
    side: f32,
    error: vec3<f32>,
    normal: vec3<f32>,
    leave: vec3<f32>,
    enter: vec3<f32>,
}

fn slimbvh_closest_hit_from(origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32, skip: u32) -> SlimbvhHit {
    slimbvh_origin.member = vec4<f32>(origin, t_min);
    slimbvh_direction.member = vec4<f32>(direction, t_max);
    slimbvh_question.member = vec2<u32>(0u, skip);
    slimbvh_trace();
    let hit = slimbvh_hit.member;
    return SlimbvhHit(bitcast<f32>(hit.x), bitcast<f32>(hit.y), bitcast<f32>(hit.z), hit.w);
}

fn slimbvh_closest_hit(origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> SlimbvhHit {
    return slimbvh_closest_hit_from(origin, t_min, direction, t_max, 0xffffffffu);
}

fn slimbvh_any_hit_from(origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32, skip: u32) -> bool {
    slimbvh_origin.member = vec4<f32>(origin, t_min);
    slimbvh_direction.member = vec4<f32>(direction, t_max);
    slimbvh_question.member = vec2<u32>(1u, skip);
    slimbvh_trace();
    return slimbvh_hit.member.w != 0xffffffffu;
}

fn slimbvh_any_hit(origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> bool {
    return slimbvh_any_hit_from(origin, t_min, direction, t_max, 0xffffffffu);
}

fn slimbvh_surface(v0: vec3<f32>, v1: vec3<f32>, v2: vec3<f32>, hit: SlimbvhHit, direction: vec3<f32>) -> SlimbvhSurface {
    slimbvh_corners.member = array<vec4<f32>, 3>(vec4<f32>(v0, 0.0), vec4<f32>(v1, 0.0), vec4<f32>(v2, 0.0));
    slimbvh_weights.member = vec2<f32>(hit.u, hit.v);
    slimbvh_from.member = vec4<f32>(direction, 0.0);
    slimbvh_find_surface();
    let point = slimbvh_point.member;
    return SlimbvhSurface(point[0].xyz, point[0].w, point[1].xyz, point[2].xyz, point[3].xyz, point[4].xyz);
}
