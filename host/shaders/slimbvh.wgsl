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
    member: array<vec4<u32>, 2>,
}

struct SlimbvhTypeC {
    member: array<array<vec4<f32>, 5>>,
}

struct SlimbvhTypeD {
    member: array<u32>,
}

struct SlimbvhTypeE {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
    member_2: f32,
    member_3: f32,
    member_4: i32,
}

struct SlimbvhTypeF {
    member: u32,
    member_1: u32,
}

struct SlimbvhTypeG {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct SlimbvhTypeH {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct SlimbvhTypeI {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct SlimbvhTypeJ {
    member: SlimbvhTypeH,
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
var<storage> slimbvh_triangles: SlimbvhTypeC;

@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeK;

@group(0) @binding(3) 
var<storage> slimbvh_sides: SlimbvhTypeD;

@group(0) @binding(4) 
var<uniform> slimbvh_target: SlimbvhTypeB;

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
    var phi_1055_: SlimbvhTypeE;
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
    var phi_1614_: SlimbvhTypeF;
    var phi_1615_: SlimbvhTypeF;
    var phi_1637_: SlimbvhTypeF;
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
    var phi_2391_: SlimbvhTypeG;
    var phi_2392_: SlimbvhTypeG;
    var phi_2395_: SlimbvhTypeG;
    var phi_2396_: SlimbvhTypeG;
    var phi_2397_: bool;
    var phi_2401_: SlimbvhTypeG;
    var phi_2410_: SlimbvhTypeH;
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
    var phi_3064_: SlimbvhTypeH;
    var local_8: SlimbvhTypeN;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e85 = SlimbvhTypeH(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
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
        phi_1055_ = SlimbvhTypeE(array<f32, 3>((_e163 * _e468), (_e167 * _e468), (_e170 * _e468)), array<f32, 3>((_e172 * _e473), (_e174 * _e473), (_e176 * _e473)), bitcast<f32>(((_e121 & 2147483648u) | select(_e505, 0u, _e507))), bitcast<f32>(((_e129 & 2147483648u) | select(_e535, 0u, _e537))), _e462);
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
        phi_1055_ = SlimbvhTypeE(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e241 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e241 & 2147483648u))), _e163, _e243) * _e234) * select(0.00000011920929f, 1f, _e243)) * _e240), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e258 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e258 & 2147483648u))), _e167, _e260) * _e234) * select(0.00000011920929f, 1f, _e260)) * _e240), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e275 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e275 & 2147483648u))), _e170, _e277) * _e234) * select(0.00000011920929f, 1f, _e277)) * _e240)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e310 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e310 & 2147483648u))), _e172, _e312) * _e303) * select(0.00000011920929f, 1f, _e312)) * _e309), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e327 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e327 & 2147483648u))), _e174, _e329) * _e303) * select(0.00000011920929f, 1f, _e329)) * _e309), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e344 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e344 & 2147483648u))), _e176, _e346) * _e303) * select(0.00000011920929f, 1f, _e346)) * _e309)), bitcast<f32>(((_e121 & 2147483648u) | select(_e403, 0u, _e405))), bitcast<f32>(((_e129 & 2147483648u) | select(_e451, 0u, _e453))), _e223);
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
                phi_1614_ = SlimbvhTypeF(0u, ((_e808 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e814 = phi_1611_;
                    let _e816 = phi_1614_;
                    local_6 = _e814;
                    local_8 = _e814;
                    if (_e816.member < _e816.member_1) {
                        phi_1615_ = SlimbvhTypeF((_e816.member + 1u), _e816.member_1);
                        phi_1637_ = SlimbvhTypeF(1u, _e816.member);
                    } else {
                        phi_1615_ = _e816;
                        phi_1637_ = SlimbvhTypeF(0u, SlimbvhTypeF().member_1);
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
                                phi_2391_ = SlimbvhTypeG(_e1338, (_e1019 * _e1339), (_e1023 * _e1339), ((_e1098 && (_e1338 >= _e611)) && (_e1338 <= _e814.member.member_1)));
                                phi_2392_ = SlimbvhTypeG();
                            } else {
                                phi_2391_ = SlimbvhTypeG();
                                phi_2392_ = SlimbvhTypeG(0f, 0f, 0f, _e1098);
                            }
                            let _e1348 = phi_2391_;
                            let _e1350 = phi_2392_;
                            phi_2395_ = _e1348;
                            phi_2396_ = _e1350;
                            phi_2397_ = select(true, false, _e1098);
                        } else {
                            phi_2395_ = SlimbvhTypeG();
                            phi_2396_ = SlimbvhTypeG(0f, 0f, 0f, _e1009);
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
                            phi_2410_ = SlimbvhTypeH(_e1359.member, _e1359.member_1, _e1359.member_2, _e877);
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
        phi_3064_ = SlimbvhTypeH(_e1916, _e1797.member.member.member_1, _e1797.member.member.member_2, _e1797.member.member.member_3);
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
    var phi_219_: i32;
    var phi_720_: i32;
    var phi_751_: i32;
    var phi_770_: vec3<f32>;
    var phi_2156_: f32;
    var phi_2160_: f32;
    var phi_2161_: bool;
    var phi_2164_: f32;
    var phi_2165_: bool;
    var phi_2937_: u32;
    var phi_2956_: bool;
    var phi_2958_: bool;
    var phi_2964_: f32;
    var phi_2965_: f32;
    var phi_2967_: f32;
    var phi_2968_: f32;
    var phi_2969_: bool;
    var phi_2975_: f32;
    var phi_2180_: f32;
    var phi_2182_: f32;
    var phi_2195_: f32;
    var phi_2217_: f32;
    var phi_2221_: f32;
    var phi_2222_: bool;
    var phi_2225_: f32;
    var phi_2226_: bool;
    var phi_3011_: u32;
    var phi_3030_: bool;
    var phi_3032_: bool;
    var phi_3038_: f32;
    var phi_3039_: f32;
    var phi_3041_: f32;
    var phi_3042_: f32;
    var phi_3043_: bool;
    var phi_3049_: f32;
    var phi_2241_: f32;
    var phi_2243_: f32;
    var phi_2256_: f32;
    var phi_2277_: f32;
    var phi_2281_: f32;
    var phi_2282_: bool;
    var phi_2285_: f32;
    var phi_2286_: bool;
    var phi_3085_: u32;
    var phi_3104_: bool;
    var phi_3106_: bool;
    var phi_3112_: f32;
    var phi_3113_: f32;
    var phi_3115_: f32;
    var phi_3116_: f32;
    var phi_3117_: bool;
    var phi_3123_: f32;
    var phi_2301_: f32;
    var phi_2303_: f32;
    var phi_2326_: f32;
    var phi_2330_: f32;
    var phi_2331_: bool;
    var phi_2334_: f32;
    var phi_2335_: bool;
    var phi_3159_: u32;
    var phi_3178_: bool;
    var phi_3180_: bool;
    var phi_3186_: f32;
    var phi_3187_: f32;
    var phi_3189_: f32;
    var phi_3190_: f32;
    var phi_3191_: bool;
    var phi_3197_: f32;
    var phi_2350_: f32;
    var phi_2352_: f32;
    var phi_2360_: bool;
    var phi_2377_: f32;
    var phi_2379_: f32;
    var phi_2382_: f32;
    var phi_2405_: f32;
    var phi_2409_: f32;
    var phi_2410_: bool;
    var phi_2413_: f32;
    var phi_2414_: bool;
    var phi_3233_: u32;
    var phi_3252_: bool;
    var phi_3254_: bool;
    var phi_3260_: f32;
    var phi_3261_: f32;
    var phi_3263_: f32;
    var phi_3264_: f32;
    var phi_3265_: bool;
    var phi_3271_: f32;
    var phi_2429_: f32;
    var phi_2431_: f32;
    var phi_2444_: f32;
    var phi_2466_: f32;
    var phi_2470_: f32;
    var phi_2471_: bool;
    var phi_2474_: f32;
    var phi_2475_: bool;
    var phi_3307_: u32;
    var phi_3326_: bool;
    var phi_3328_: bool;
    var phi_3334_: f32;
    var phi_3335_: f32;
    var phi_3337_: f32;
    var phi_3338_: f32;
    var phi_3339_: bool;
    var phi_3345_: f32;
    var phi_2490_: f32;
    var phi_2492_: f32;
    var phi_2505_: f32;
    var phi_2526_: f32;
    var phi_2530_: f32;
    var phi_2531_: bool;
    var phi_2534_: f32;
    var phi_2535_: bool;
    var phi_3381_: u32;
    var phi_3400_: bool;
    var phi_3402_: bool;
    var phi_3408_: f32;
    var phi_3409_: f32;
    var phi_3411_: f32;
    var phi_3412_: f32;
    var phi_3413_: bool;
    var phi_3419_: f32;
    var phi_2550_: f32;
    var phi_2552_: f32;
    var phi_2575_: f32;
    var phi_2579_: f32;
    var phi_2580_: bool;
    var phi_2583_: f32;
    var phi_2584_: bool;
    var phi_3455_: u32;
    var phi_3474_: bool;
    var phi_3476_: bool;
    var phi_3482_: f32;
    var phi_3483_: f32;
    var phi_3485_: f32;
    var phi_3486_: f32;
    var phi_3487_: bool;
    var phi_3493_: f32;
    var phi_2599_: f32;
    var phi_2601_: f32;
    var phi_2609_: bool;
    var phi_2626_: f32;
    var phi_2628_: f32;
    var phi_2631_: f32;
    var phi_2654_: f32;
    var phi_2658_: f32;
    var phi_2659_: bool;
    var phi_2662_: f32;
    var phi_2663_: bool;
    var phi_3529_: u32;
    var phi_3548_: bool;
    var phi_3550_: bool;
    var phi_3556_: f32;
    var phi_3557_: f32;
    var phi_3559_: f32;
    var phi_3560_: f32;
    var phi_3561_: bool;
    var phi_3567_: f32;
    var phi_2678_: f32;
    var phi_2680_: f32;
    var phi_2693_: f32;
    var phi_2715_: f32;
    var phi_2719_: f32;
    var phi_2720_: bool;
    var phi_2723_: f32;
    var phi_2724_: bool;
    var phi_3603_: u32;
    var phi_3622_: bool;
    var phi_3624_: bool;
    var phi_3630_: f32;
    var phi_3631_: f32;
    var phi_3633_: f32;
    var phi_3634_: f32;
    var phi_3635_: bool;
    var phi_3641_: f32;
    var phi_2739_: f32;
    var phi_2741_: f32;
    var phi_2754_: f32;
    var phi_2775_: f32;
    var phi_2779_: f32;
    var phi_2780_: bool;
    var phi_2783_: f32;
    var phi_2784_: bool;
    var phi_3677_: u32;
    var phi_3696_: bool;
    var phi_3698_: bool;
    var phi_3704_: f32;
    var phi_3705_: f32;
    var phi_3707_: f32;
    var phi_3708_: f32;
    var phi_3709_: bool;
    var phi_3715_: f32;
    var phi_2799_: f32;
    var phi_2801_: f32;
    var phi_2824_: f32;
    var phi_2828_: f32;
    var phi_2829_: bool;
    var phi_2832_: f32;
    var phi_2833_: bool;
    var phi_3751_: u32;
    var phi_3770_: bool;
    var phi_3772_: bool;
    var phi_3778_: f32;
    var phi_3779_: f32;
    var phi_3781_: f32;
    var phi_3782_: f32;
    var phi_3783_: bool;
    var phi_3789_: f32;
    var phi_2848_: f32;
    var phi_2850_: f32;
    var phi_2858_: bool;
    var phi_2875_: f32;
    var phi_2877_: f32;
    var phi_2880_: f32;
    var phi_1016_: f32;
    var phi_1017_: f32;
    var phi_1039_: f32;
    var phi_1040_: f32;
    var phi_1042_: f32;
    var phi_1043_: f32;
    var phi_1064_: f32;
    var phi_1065_: f32;
    var phi_1087_: f32;
    var phi_1088_: f32;
    var phi_1090_: f32;
    var phi_1091_: f32;
    var phi_1112_: f32;
    var phi_1113_: f32;
    var phi_1135_: f32;
    var phi_1136_: f32;
    var phi_1138_: f32;
    var phi_1139_: f32;
    var phi_1205_: f32;
    var phi_1206_: f32;
    var phi_1228_: f32;
    var phi_1229_: f32;
    var phi_1231_: f32;
    var phi_1232_: f32;
    var phi_1253_: f32;
    var phi_1254_: f32;
    var phi_1276_: f32;
    var phi_1277_: f32;
    var phi_1279_: f32;
    var phi_1280_: f32;
    var phi_1301_: f32;
    var phi_1302_: f32;
    var phi_1324_: f32;
    var phi_1325_: f32;
    var phi_1327_: f32;
    var phi_1328_: f32;

    let _e47 = bitcast<f32>(2139095039u);
    let _e51 = slimbvh_corners.member[0u];
    let _e57 = slimbvh_corners.member[1u];
    let _e63 = slimbvh_corners.member[2u];
    let _e69 = slimbvh_exponent.member[0u];
    let _e70 = bitcast<i32>(_e69);
    if (_e70 < -126i) {
        phi_219_ = -126i;
    } else {
        phi_219_ = select(_e70, 127i, (_e70 > 127i));
    }
    let _e75 = phi_219_;
    let _e80 = bitcast<f32>((bitcast<u32>((_e75 + 127i)) << bitcast<u32>(23i)));
    let _e86 = bitcast<f32>((bitcast<u32>(((_e70 - _e75) + 127i)) << bitcast<u32>(23i)));
    let _e87 = bitcast<u32>(_e51.x);
    let _e89 = ((_e87 & 2139095040u) != 0u);
    let _e103 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e87 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e87 & 2147483648u))), _e51.x, _e89) * _e80) * select(0.00000011920929f, 1f, _e89)) * _e86);
    let _e108 = select(_e103, 0f, (bitcast<f32>((bitcast<u32>(_e103) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e109 = bitcast<u32>(_e51.y);
    let _e111 = ((_e109 & 2139095040u) != 0u);
    let _e125 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e109 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e109 & 2147483648u))), _e51.y, _e111) * _e80) * select(0.00000011920929f, 1f, _e111)) * _e86);
    let _e130 = select(_e125, 0f, (bitcast<f32>((bitcast<u32>(_e125) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e131 = bitcast<u32>(_e51.z);
    let _e133 = ((_e131 & 2139095040u) != 0u);
    let _e147 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e131 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e131 & 2147483648u))), _e51.z, _e133) * _e80) * select(0.00000011920929f, 1f, _e133)) * _e86);
    let _e152 = select(_e147, 0f, (bitcast<f32>((bitcast<u32>(_e147) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e153 = bitcast<u32>(_e57.x);
    let _e155 = ((_e153 & 2139095040u) != 0u);
    let _e169 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e153 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e153 & 2147483648u))), _e57.x, _e155) * _e80) * select(0.00000011920929f, 1f, _e155)) * _e86);
    let _e174 = select(_e169, 0f, (bitcast<f32>((bitcast<u32>(_e169) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e175 = bitcast<u32>(_e57.y);
    let _e177 = ((_e175 & 2139095040u) != 0u);
    let _e191 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e175 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e175 & 2147483648u))), _e57.y, _e177) * _e80) * select(0.00000011920929f, 1f, _e177)) * _e86);
    let _e196 = select(_e191, 0f, (bitcast<f32>((bitcast<u32>(_e191) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e197 = bitcast<u32>(_e57.z);
    let _e199 = ((_e197 & 2139095040u) != 0u);
    let _e213 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e197 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e197 & 2147483648u))), _e57.z, _e199) * _e80) * select(0.00000011920929f, 1f, _e199)) * _e86);
    let _e218 = select(_e213, 0f, (bitcast<f32>((bitcast<u32>(_e213) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e219 = bitcast<u32>(_e63.x);
    let _e221 = ((_e219 & 2139095040u) != 0u);
    let _e235 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e219 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e219 & 2147483648u))), _e63.x, _e221) * _e80) * select(0.00000011920929f, 1f, _e221)) * _e86);
    let _e240 = select(_e235, 0f, (bitcast<f32>((bitcast<u32>(_e235) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e241 = bitcast<u32>(_e63.y);
    let _e243 = ((_e241 & 2139095040u) != 0u);
    let _e257 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e241 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e241 & 2147483648u))), _e63.y, _e243) * _e80) * select(0.00000011920929f, 1f, _e243)) * _e86);
    let _e262 = select(_e257, 0f, (bitcast<f32>((bitcast<u32>(_e257) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e263 = bitcast<u32>(_e63.z);
    let _e265 = ((_e263 & 2139095040u) != 0u);
    let _e279 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e263 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e263 & 2147483648u))), _e63.z, _e265) * _e80) * select(0.00000011920929f, 1f, _e265)) * _e86);
    let _e284 = select(_e279, 0f, (bitcast<f32>((bitcast<u32>(_e279) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
    let _e287 = slimbvh_weights.member[0u];
    let _e290 = slimbvh_weights.member[1u];
    let _e291 = slimbvh_from.member;
    let _e296 = ((1f - _e287) - _e290);
    let _e298 = select(0f, _e296, (_e296 > 0f));
    let _e300 = select(1f, _e287, (_e287 < 1f));
    let _e302 = select(1f, _e290, (_e290 < 1f));
    let _e303 = (_e108 * _e298);
    let _e304 = (_e130 * _e298);
    let _e305 = (_e152 * _e298);
    let _e306 = (_e174 * _e300);
    let _e307 = (_e196 * _e300);
    let _e308 = (_e218 * _e300);
    let _e309 = (_e240 * _e302);
    let _e310 = (_e262 * _e302);
    let _e311 = (_e284 * _e302);
    let _e315 = ((_e303 + _e306) + _e309);
    let _e316 = ((_e304 + _e307) + _e310);
    let _e317 = ((_e305 + _e308) + _e311);
    let _e354 = (_e174 - _e108);
    let _e355 = (_e196 - _e130);
    let _e356 = (_e218 - _e152);
    let _e357 = (_e240 - _e108);
    let _e358 = (_e262 - _e130);
    let _e359 = (_e284 - _e152);
    let _e362 = ((_e355 * _e359) - (_e358 * _e356));
    let _e365 = ((_e356 * _e357) - (_e359 * _e354));
    let _e368 = ((_e354 * _e358) - (_e357 * _e355));
    let _e371 = bitcast<f32>((bitcast<u32>(_e362) & 2147483647u));
    let _e374 = bitcast<f32>((bitcast<u32>(_e365) & 2147483647u));
    let _e376 = select(_e374, _e371, (_e371 > _e374));
    let _e379 = bitcast<f32>((bitcast<u32>(_e368) & 2147483647u));
    let _e381 = select(_e379, _e376, (_e376 > _e379));
    if (_e381 < 0.000000000000000000000000000000000000011754944f) {
        phi_770_ = vec3<f32>(0f, 0f, 0f);
    } else {
        let _e384 = (bitcast<u32>(_e381) & 2147483647u);
        let _e385 = (_e384 >= 8388608u);
        if _e385 {
            phi_720_ = (bitcast<i32>((_e384 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_720_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e384)), 32u, (_e384 == 0u))));
        }
        let _e398 = phi_720_;
        let _e405 = bitcast<f32>((bitcast<u32>(((_e398 / -2i) + 127i)) << bitcast<u32>(23i)));
        if _e385 {
            phi_751_ = (bitcast<i32>((_e384 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_751_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e384)), 32u, (_e384 == 0u))));
        }
        let _e421 = phi_751_;
        let _e427 = bitcast<f32>((bitcast<u32>((((_e398 / 2i) - _e421) + 127i)) << bitcast<u32>(23i)));
        let _e428 = ((_e362 * _e405) * _e427);
        let _e429 = ((_e365 * _e405) * _e427);
        let _e430 = ((_e368 * _e405) * _e427);
        let _e436 = sqrt((((_e428 * _e428) + (_e429 * _e429)) + (_e430 * _e430)));
        phi_770_ = vec3<f32>((_e428 / _e436), (_e429 / _e436), (_e430 / _e436));
    }
    let _e442 = phi_770_;
    let _e452 = select(1f, -1f, ((((_e442.x * _e291.x) + (_e442.y * _e291.y)) + (_e442.z * _e291.z)) > 0f));
    let _e453 = (_e442 * _e452);
    let _e454 = ((((bitcast<f32>((bitcast<u32>(_e303) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e306) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e309) & 2147483647u))) * 0.00000071525625f) + 0.000000000000000000000000000000000000047019774f);
    let _e455 = -(_e70);
    let _e456 = bitcast<u32>(_e315);
    let _e460 = (bitcast<i32>((_e456 >> bitcast<u32>(23i))) & 255i);
    let _e461 = (_e460 + _e455);
    if (_e460 == 255i) {
        phi_2182_ = _e315;
    } else {
        if (_e460 > 0i) {
            if (_e461 > 0i) {
                let _e465 = (_e461 < 255i);
                if _e465 {
                    phi_2156_ = bitcast<f32>((_e456 + bitcast<u32>((_e455 << bitcast<u32>(23i)))));
                } else {
                    phi_2156_ = f32();
                }
                let _e472 = phi_2156_;
                phi_2160_ = _e472;
                phi_2161_ = select(true, false, _e465);
            } else {
                phi_2160_ = f32();
                phi_2161_ = true;
            }
            let _e475 = phi_2160_;
            let _e477 = phi_2161_;
            phi_2164_ = _e475;
            phi_2165_ = _e477;
        } else {
            phi_2164_ = f32();
            phi_2165_ = true;
        }
        let _e479 = phi_2164_;
        let _e481 = phi_2165_;
        if _e481 {
            let _e482 = (_e456 & 2147483648u);
            let _e489 = ((_e456 & 8388607u) | (select(0u, 1u, ((_e456 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
            let _e493 = (_e489 == 0u);
            if _e493 {
                phi_2975_ = bitcast<f32>(_e482);
            } else {
                let _e499 = (select((bitcast<u32>(31i) - firstLeadingBit(_e489)), 32u, _e493) - 8u);
                let _e502 = (_e489 << bitcast<u32>((_e499 & 31u)));
                let _e504 = ((_e461 + select(0i, 1i, (_e460 == 0i))) - bitcast<i32>(_e499));
                if (_e504 >= 255i) {
                    phi_2967_ = bitcast<f32>((_e482 | 2139095040u));
                    phi_2968_ = f32();
                    phi_2969_ = true;
                } else {
                    let _e508 = (_e504 > 0i);
                    if _e508 {
                        phi_2964_ = bitcast<f32>(((_e482 | (bitcast<u32>(_e504) << bitcast<u32>(23i))) | (_e502 & 8388607u)));
                        phi_2965_ = f32();
                    } else {
                        if (_e504 < -24i) {
                            phi_2937_ = 26u;
                        } else {
                            phi_2937_ = bitcast<u32>((1i - _e504));
                        }
                        let _e520 = phi_2937_;
                        let _e521 = (_e520 & 31u);
                        let _e523 = (_e502 >> bitcast<u32>(_e521));
                        let _e527 = (_e502 & ((1u << bitcast<u32>(_e521)) - 1u));
                        let _e531 = (1u << bitcast<u32>(((_e520 - 1u) & 31u)));
                        if (_e527 > _e531) {
                            phi_2958_ = true;
                        } else {
                            if (_e527 == _e531) {
                                phi_2956_ = ((_e523 & 1u) == 1u);
                            } else {
                                phi_2956_ = false;
                            }
                            let _e537 = phi_2956_;
                            phi_2958_ = _e537;
                        }
                        let _e539 = phi_2958_;
                        phi_2964_ = f32();
                        phi_2965_ = bitcast<f32>((_e482 | (_e523 + select(0u, 1u, _e539))));
                    }
                    let _e545 = phi_2964_;
                    let _e547 = phi_2965_;
                    phi_2967_ = _e545;
                    phi_2968_ = _e547;
                    phi_2969_ = _e508;
                }
                let _e549 = phi_2967_;
                let _e551 = phi_2968_;
                let _e553 = phi_2969_;
                phi_2975_ = select(_e551, _e549, _e553);
            }
            let _e556 = phi_2975_;
            phi_2180_ = _e556;
        } else {
            phi_2180_ = _e479;
        }
        let _e558 = phi_2180_;
        phi_2182_ = _e558;
    }
    let _e560 = phi_2182_;
    let _e561 = bitcast<u32>(_e560);
    if (bitcast<f32>((_e561 & 2147483647u)) > _e47) {
        phi_2195_ = bitcast<f32>(((_e561 & 2147483648u) | 2139095039u));
    } else {
        phi_2195_ = _e560;
    }
    let _e569 = phi_2195_;
    let _e570 = bitcast<u32>(_e454);
    let _e574 = (bitcast<i32>((_e570 >> bitcast<u32>(23i))) & 255i);
    let _e575 = (_e574 + _e455);
    if (_e574 == 255i) {
        phi_2243_ = _e454;
    } else {
        if (_e574 > 0i) {
            if (_e575 > 0i) {
                let _e579 = (_e575 < 255i);
                if _e579 {
                    phi_2217_ = bitcast<f32>((_e570 + bitcast<u32>((_e455 << bitcast<u32>(23i)))));
                } else {
                    phi_2217_ = f32();
                }
                let _e586 = phi_2217_;
                phi_2221_ = _e586;
                phi_2222_ = select(true, false, _e579);
            } else {
                phi_2221_ = f32();
                phi_2222_ = true;
            }
            let _e589 = phi_2221_;
            let _e591 = phi_2222_;
            phi_2225_ = _e589;
            phi_2226_ = _e591;
        } else {
            phi_2225_ = f32();
            phi_2226_ = true;
        }
        let _e593 = phi_2225_;
        let _e595 = phi_2226_;
        if _e595 {
            let _e596 = (_e570 & 2147483648u);
            let _e603 = ((_e570 & 8388607u) | (select(0u, 1u, ((_e570 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
            let _e607 = (_e603 == 0u);
            if _e607 {
                phi_3049_ = bitcast<f32>(_e596);
            } else {
                let _e613 = (select((bitcast<u32>(31i) - firstLeadingBit(_e603)), 32u, _e607) - 8u);
                let _e616 = (_e603 << bitcast<u32>((_e613 & 31u)));
                let _e618 = ((_e575 + select(0i, 1i, (_e574 == 0i))) - bitcast<i32>(_e613));
                if (_e618 >= 255i) {
                    phi_3041_ = bitcast<f32>((_e596 | 2139095040u));
                    phi_3042_ = f32();
                    phi_3043_ = true;
                } else {
                    let _e622 = (_e618 > 0i);
                    if _e622 {
                        phi_3038_ = bitcast<f32>(((_e596 | (bitcast<u32>(_e618) << bitcast<u32>(23i))) | (_e616 & 8388607u)));
                        phi_3039_ = f32();
                    } else {
                        if (_e618 < -24i) {
                            phi_3011_ = 26u;
                        } else {
                            phi_3011_ = bitcast<u32>((1i - _e618));
                        }
                        let _e634 = phi_3011_;
                        let _e635 = (_e634 & 31u);
                        let _e637 = (_e616 >> bitcast<u32>(_e635));
                        let _e641 = (_e616 & ((1u << bitcast<u32>(_e635)) - 1u));
                        let _e645 = (1u << bitcast<u32>(((_e634 - 1u) & 31u)));
                        if (_e641 > _e645) {
                            phi_3032_ = true;
                        } else {
                            if (_e641 == _e645) {
                                phi_3030_ = ((_e637 & 1u) == 1u);
                            } else {
                                phi_3030_ = false;
                            }
                            let _e651 = phi_3030_;
                            phi_3032_ = _e651;
                        }
                        let _e653 = phi_3032_;
                        phi_3038_ = f32();
                        phi_3039_ = bitcast<f32>((_e596 | (_e637 + select(0u, 1u, _e653))));
                    }
                    let _e659 = phi_3038_;
                    let _e661 = phi_3039_;
                    phi_3041_ = _e659;
                    phi_3042_ = _e661;
                    phi_3043_ = _e622;
                }
                let _e663 = phi_3041_;
                let _e665 = phi_3042_;
                let _e667 = phi_3043_;
                phi_3049_ = select(_e665, _e663, _e667);
            }
            let _e670 = phi_3049_;
            phi_2241_ = _e670;
        } else {
            phi_2241_ = _e593;
        }
        let _e672 = phi_2241_;
        phi_2243_ = _e672;
    }
    let _e674 = phi_2243_;
    let _e675 = bitcast<u32>(_e674);
    if (bitcast<f32>((_e675 & 2147483647u)) > _e47) {
        phi_2256_ = bitcast<f32>(((_e675 & 2147483648u) | 2139095039u));
    } else {
        phi_2256_ = _e674;
    }
    let _e683 = phi_2256_;
    let _e684 = bitcast<u32>(_e569);
    let _e688 = (bitcast<i32>((_e684 >> bitcast<u32>(23i))) & 255i);
    let _e689 = (_e688 + _e70);
    if (_e688 == 255i) {
        phi_2303_ = _e569;
    } else {
        if (_e688 > 0i) {
            if (_e689 > 0i) {
                let _e693 = (_e689 < 255i);
                if _e693 {
                    phi_2277_ = bitcast<f32>((_e684 + bitcast<u32>((_e70 << bitcast<u32>(23i)))));
                } else {
                    phi_2277_ = f32();
                }
                let _e700 = phi_2277_;
                phi_2281_ = _e700;
                phi_2282_ = select(true, false, _e693);
            } else {
                phi_2281_ = f32();
                phi_2282_ = true;
            }
            let _e703 = phi_2281_;
            let _e705 = phi_2282_;
            phi_2285_ = _e703;
            phi_2286_ = _e705;
        } else {
            phi_2285_ = f32();
            phi_2286_ = true;
        }
        let _e707 = phi_2285_;
        let _e709 = phi_2286_;
        if _e709 {
            let _e710 = (_e684 & 2147483648u);
            let _e717 = ((_e684 & 8388607u) | (select(0u, 1u, ((_e684 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
            let _e721 = (_e717 == 0u);
            if _e721 {
                phi_3123_ = bitcast<f32>(_e710);
            } else {
                let _e727 = (select((bitcast<u32>(31i) - firstLeadingBit(_e717)), 32u, _e721) - 8u);
                let _e730 = (_e717 << bitcast<u32>((_e727 & 31u)));
                let _e732 = ((_e689 + select(0i, 1i, (_e688 == 0i))) - bitcast<i32>(_e727));
                if (_e732 >= 255i) {
                    phi_3115_ = bitcast<f32>((_e710 | 2139095040u));
                    phi_3116_ = f32();
                    phi_3117_ = true;
                } else {
                    let _e736 = (_e732 > 0i);
                    if _e736 {
                        phi_3112_ = bitcast<f32>(((_e710 | (bitcast<u32>(_e732) << bitcast<u32>(23i))) | (_e730 & 8388607u)));
                        phi_3113_ = f32();
                    } else {
                        if (_e732 < -24i) {
                            phi_3085_ = 26u;
                        } else {
                            phi_3085_ = bitcast<u32>((1i - _e732));
                        }
                        let _e748 = phi_3085_;
                        let _e749 = (_e748 & 31u);
                        let _e751 = (_e730 >> bitcast<u32>(_e749));
                        let _e755 = (_e730 & ((1u << bitcast<u32>(_e749)) - 1u));
                        let _e759 = (1u << bitcast<u32>(((_e748 - 1u) & 31u)));
                        if (_e755 > _e759) {
                            phi_3106_ = true;
                        } else {
                            if (_e755 == _e759) {
                                phi_3104_ = ((_e751 & 1u) == 1u);
                            } else {
                                phi_3104_ = false;
                            }
                            let _e765 = phi_3104_;
                            phi_3106_ = _e765;
                        }
                        let _e767 = phi_3106_;
                        phi_3112_ = f32();
                        phi_3113_ = bitcast<f32>((_e710 | (_e751 + select(0u, 1u, _e767))));
                    }
                    let _e773 = phi_3112_;
                    let _e775 = phi_3113_;
                    phi_3115_ = _e773;
                    phi_3116_ = _e775;
                    phi_3117_ = _e736;
                }
                let _e777 = phi_3115_;
                let _e779 = phi_3116_;
                let _e781 = phi_3117_;
                phi_3123_ = select(_e779, _e777, _e781);
            }
            let _e784 = phi_3123_;
            phi_2301_ = _e784;
        } else {
            phi_2301_ = _e707;
        }
        let _e786 = phi_2301_;
        phi_2303_ = _e786;
    }
    let _e788 = phi_2303_;
    if (_e788 == _e315) {
        let _e790 = bitcast<u32>(_e683);
        let _e794 = (bitcast<i32>((_e790 >> bitcast<u32>(23i))) & 255i);
        let _e795 = (_e794 + _e70);
        if (_e794 == 255i) {
            phi_2352_ = _e683;
        } else {
            if (_e794 > 0i) {
                if (_e795 > 0i) {
                    let _e799 = (_e795 < 255i);
                    if _e799 {
                        phi_2326_ = bitcast<f32>((_e790 + bitcast<u32>((_e70 << bitcast<u32>(23i)))));
                    } else {
                        phi_2326_ = f32();
                    }
                    let _e806 = phi_2326_;
                    phi_2330_ = _e806;
                    phi_2331_ = select(true, false, _e799);
                } else {
                    phi_2330_ = f32();
                    phi_2331_ = true;
                }
                let _e809 = phi_2330_;
                let _e811 = phi_2331_;
                phi_2334_ = _e809;
                phi_2335_ = _e811;
            } else {
                phi_2334_ = f32();
                phi_2335_ = true;
            }
            let _e813 = phi_2334_;
            let _e815 = phi_2335_;
            if _e815 {
                let _e816 = (_e790 & 2147483648u);
                let _e823 = ((_e790 & 8388607u) | (select(0u, 1u, ((_e790 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e827 = (_e823 == 0u);
                if _e827 {
                    phi_3197_ = bitcast<f32>(_e816);
                } else {
                    let _e833 = (select((bitcast<u32>(31i) - firstLeadingBit(_e823)), 32u, _e827) - 8u);
                    let _e836 = (_e823 << bitcast<u32>((_e833 & 31u)));
                    let _e838 = ((_e795 + select(0i, 1i, (_e794 == 0i))) - bitcast<i32>(_e833));
                    if (_e838 >= 255i) {
                        phi_3189_ = bitcast<f32>((_e816 | 2139095040u));
                        phi_3190_ = f32();
                        phi_3191_ = true;
                    } else {
                        let _e842 = (_e838 > 0i);
                        if _e842 {
                            phi_3186_ = bitcast<f32>(((_e816 | (bitcast<u32>(_e838) << bitcast<u32>(23i))) | (_e836 & 8388607u)));
                            phi_3187_ = f32();
                        } else {
                            if (_e838 < -24i) {
                                phi_3159_ = 26u;
                            } else {
                                phi_3159_ = bitcast<u32>((1i - _e838));
                            }
                            let _e854 = phi_3159_;
                            let _e855 = (_e854 & 31u);
                            let _e857 = (_e836 >> bitcast<u32>(_e855));
                            let _e861 = (_e836 & ((1u << bitcast<u32>(_e855)) - 1u));
                            let _e865 = (1u << bitcast<u32>(((_e854 - 1u) & 31u)));
                            if (_e861 > _e865) {
                                phi_3180_ = true;
                            } else {
                                if (_e861 == _e865) {
                                    phi_3178_ = ((_e857 & 1u) == 1u);
                                } else {
                                    phi_3178_ = false;
                                }
                                let _e871 = phi_3178_;
                                phi_3180_ = _e871;
                            }
                            let _e873 = phi_3180_;
                            phi_3186_ = f32();
                            phi_3187_ = bitcast<f32>((_e816 | (_e857 + select(0u, 1u, _e873))));
                        }
                        let _e879 = phi_3186_;
                        let _e881 = phi_3187_;
                        phi_3189_ = _e879;
                        phi_3190_ = _e881;
                        phi_3191_ = _e842;
                    }
                    let _e883 = phi_3189_;
                    let _e885 = phi_3190_;
                    let _e887 = phi_3191_;
                    phi_3197_ = select(_e885, _e883, _e887);
                }
                let _e890 = phi_3197_;
                phi_2350_ = _e890;
            } else {
                phi_2350_ = _e813;
            }
            let _e892 = phi_2350_;
            phi_2352_ = _e892;
        }
        let _e894 = phi_2352_;
        phi_2360_ = select(true, false, (_e894 == _e454));
    } else {
        phi_2360_ = true;
    }
    let _e898 = phi_2360_;
    if _e898 {
        let _e899 = bitcast<u32>(_e683);
        if ((_e899 & 2147483647u) == 0u) {
            phi_2379_ = 0.000000000000000000000000000000000000000000001f;
        } else {
            if ((_e899 >> bitcast<u32>(31i)) == 0u) {
                phi_2377_ = bitcast<f32>((_e899 + 1u));
            } else {
                phi_2377_ = bitcast<f32>((_e899 - 1u));
            }
            let _e910 = phi_2377_;
            phi_2379_ = _e910;
        }
        let _e912 = phi_2379_;
        phi_2382_ = _e912;
    } else {
        phi_2382_ = _e683;
    }
    let _e914 = phi_2382_;
    let _e915 = ((((bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e307) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e310) & 2147483647u))) * 0.00000071525625f) + 0.000000000000000000000000000000000000047019774f);
    let _e916 = bitcast<u32>(_e316);
    let _e920 = (bitcast<i32>((_e916 >> bitcast<u32>(23i))) & 255i);
    let _e921 = (_e920 + _e455);
    if (_e920 == 255i) {
        phi_2431_ = _e316;
    } else {
        if (_e920 > 0i) {
            if (_e921 > 0i) {
                let _e925 = (_e921 < 255i);
                if _e925 {
                    phi_2405_ = bitcast<f32>((_e916 + bitcast<u32>((_e455 << bitcast<u32>(23i)))));
                } else {
                    phi_2405_ = f32();
                }
                let _e932 = phi_2405_;
                phi_2409_ = _e932;
                phi_2410_ = select(true, false, _e925);
            } else {
                phi_2409_ = f32();
                phi_2410_ = true;
            }
            let _e935 = phi_2409_;
            let _e937 = phi_2410_;
            phi_2413_ = _e935;
            phi_2414_ = _e937;
        } else {
            phi_2413_ = f32();
            phi_2414_ = true;
        }
        let _e939 = phi_2413_;
        let _e941 = phi_2414_;
        if _e941 {
            let _e942 = (_e916 & 2147483648u);
            let _e949 = ((_e916 & 8388607u) | (select(0u, 1u, ((_e916 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
            let _e953 = (_e949 == 0u);
            if _e953 {
                phi_3271_ = bitcast<f32>(_e942);
            } else {
                let _e959 = (select((bitcast<u32>(31i) - firstLeadingBit(_e949)), 32u, _e953) - 8u);
                let _e962 = (_e949 << bitcast<u32>((_e959 & 31u)));
                let _e964 = ((_e921 + select(0i, 1i, (_e920 == 0i))) - bitcast<i32>(_e959));
                if (_e964 >= 255i) {
                    phi_3263_ = bitcast<f32>((_e942 | 2139095040u));
                    phi_3264_ = f32();
                    phi_3265_ = true;
                } else {
                    let _e968 = (_e964 > 0i);
                    if _e968 {
                        phi_3260_ = bitcast<f32>(((_e942 | (bitcast<u32>(_e964) << bitcast<u32>(23i))) | (_e962 & 8388607u)));
                        phi_3261_ = f32();
                    } else {
                        if (_e964 < -24i) {
                            phi_3233_ = 26u;
                        } else {
                            phi_3233_ = bitcast<u32>((1i - _e964));
                        }
                        let _e980 = phi_3233_;
                        let _e981 = (_e980 & 31u);
                        let _e983 = (_e962 >> bitcast<u32>(_e981));
                        let _e987 = (_e962 & ((1u << bitcast<u32>(_e981)) - 1u));
                        let _e991 = (1u << bitcast<u32>(((_e980 - 1u) & 31u)));
                        if (_e987 > _e991) {
                            phi_3254_ = true;
                        } else {
                            if (_e987 == _e991) {
                                phi_3252_ = ((_e983 & 1u) == 1u);
                            } else {
                                phi_3252_ = false;
                            }
                            let _e997 = phi_3252_;
                            phi_3254_ = _e997;
                        }
                        let _e999 = phi_3254_;
                        phi_3260_ = f32();
                        phi_3261_ = bitcast<f32>((_e942 | (_e983 + select(0u, 1u, _e999))));
                    }
                    let _e1005 = phi_3260_;
                    let _e1007 = phi_3261_;
                    phi_3263_ = _e1005;
                    phi_3264_ = _e1007;
                    phi_3265_ = _e968;
                }
                let _e1009 = phi_3263_;
                let _e1011 = phi_3264_;
                let _e1013 = phi_3265_;
                phi_3271_ = select(_e1011, _e1009, _e1013);
            }
            let _e1016 = phi_3271_;
            phi_2429_ = _e1016;
        } else {
            phi_2429_ = _e939;
        }
        let _e1018 = phi_2429_;
        phi_2431_ = _e1018;
    }
    let _e1020 = phi_2431_;
    let _e1021 = bitcast<u32>(_e1020);
    if (bitcast<f32>((_e1021 & 2147483647u)) > _e47) {
        phi_2444_ = bitcast<f32>(((_e1021 & 2147483648u) | 2139095039u));
    } else {
        phi_2444_ = _e1020;
    }
    let _e1029 = phi_2444_;
    let _e1030 = bitcast<u32>(_e915);
    let _e1034 = (bitcast<i32>((_e1030 >> bitcast<u32>(23i))) & 255i);
    let _e1035 = (_e1034 + _e455);
    if (_e1034 == 255i) {
        phi_2492_ = _e915;
    } else {
        if (_e1034 > 0i) {
            if (_e1035 > 0i) {
                let _e1039 = (_e1035 < 255i);
                if _e1039 {
                    phi_2466_ = bitcast<f32>((_e1030 + bitcast<u32>((_e455 << bitcast<u32>(23i)))));
                } else {
                    phi_2466_ = f32();
                }
                let _e1046 = phi_2466_;
                phi_2470_ = _e1046;
                phi_2471_ = select(true, false, _e1039);
            } else {
                phi_2470_ = f32();
                phi_2471_ = true;
            }
            let _e1049 = phi_2470_;
            let _e1051 = phi_2471_;
            phi_2474_ = _e1049;
            phi_2475_ = _e1051;
        } else {
            phi_2474_ = f32();
            phi_2475_ = true;
        }
        let _e1053 = phi_2474_;
        let _e1055 = phi_2475_;
        if _e1055 {
            let _e1056 = (_e1030 & 2147483648u);
            let _e1063 = ((_e1030 & 8388607u) | (select(0u, 1u, ((_e1030 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
            let _e1067 = (_e1063 == 0u);
            if _e1067 {
                phi_3345_ = bitcast<f32>(_e1056);
            } else {
                let _e1073 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1063)), 32u, _e1067) - 8u);
                let _e1076 = (_e1063 << bitcast<u32>((_e1073 & 31u)));
                let _e1078 = ((_e1035 + select(0i, 1i, (_e1034 == 0i))) - bitcast<i32>(_e1073));
                if (_e1078 >= 255i) {
                    phi_3337_ = bitcast<f32>((_e1056 | 2139095040u));
                    phi_3338_ = f32();
                    phi_3339_ = true;
                } else {
                    let _e1082 = (_e1078 > 0i);
                    if _e1082 {
                        phi_3334_ = bitcast<f32>(((_e1056 | (bitcast<u32>(_e1078) << bitcast<u32>(23i))) | (_e1076 & 8388607u)));
                        phi_3335_ = f32();
                    } else {
                        if (_e1078 < -24i) {
                            phi_3307_ = 26u;
                        } else {
                            phi_3307_ = bitcast<u32>((1i - _e1078));
                        }
                        let _e1094 = phi_3307_;
                        let _e1095 = (_e1094 & 31u);
                        let _e1097 = (_e1076 >> bitcast<u32>(_e1095));
                        let _e1101 = (_e1076 & ((1u << bitcast<u32>(_e1095)) - 1u));
                        let _e1105 = (1u << bitcast<u32>(((_e1094 - 1u) & 31u)));
                        if (_e1101 > _e1105) {
                            phi_3328_ = true;
                        } else {
                            if (_e1101 == _e1105) {
                                phi_3326_ = ((_e1097 & 1u) == 1u);
                            } else {
                                phi_3326_ = false;
                            }
                            let _e1111 = phi_3326_;
                            phi_3328_ = _e1111;
                        }
                        let _e1113 = phi_3328_;
                        phi_3334_ = f32();
                        phi_3335_ = bitcast<f32>((_e1056 | (_e1097 + select(0u, 1u, _e1113))));
                    }
                    let _e1119 = phi_3334_;
                    let _e1121 = phi_3335_;
                    phi_3337_ = _e1119;
                    phi_3338_ = _e1121;
                    phi_3339_ = _e1082;
                }
                let _e1123 = phi_3337_;
                let _e1125 = phi_3338_;
                let _e1127 = phi_3339_;
                phi_3345_ = select(_e1125, _e1123, _e1127);
            }
            let _e1130 = phi_3345_;
            phi_2490_ = _e1130;
        } else {
            phi_2490_ = _e1053;
        }
        let _e1132 = phi_2490_;
        phi_2492_ = _e1132;
    }
    let _e1134 = phi_2492_;
    let _e1135 = bitcast<u32>(_e1134);
    if (bitcast<f32>((_e1135 & 2147483647u)) > _e47) {
        phi_2505_ = bitcast<f32>(((_e1135 & 2147483648u) | 2139095039u));
    } else {
        phi_2505_ = _e1134;
    }
    let _e1143 = phi_2505_;
    let _e1144 = bitcast<u32>(_e1029);
    let _e1148 = (bitcast<i32>((_e1144 >> bitcast<u32>(23i))) & 255i);
    let _e1149 = (_e1148 + _e70);
    if (_e1148 == 255i) {
        phi_2552_ = _e1029;
    } else {
        if (_e1148 > 0i) {
            if (_e1149 > 0i) {
                let _e1153 = (_e1149 < 255i);
                if _e1153 {
                    phi_2526_ = bitcast<f32>((_e1144 + bitcast<u32>((_e70 << bitcast<u32>(23i)))));
                } else {
                    phi_2526_ = f32();
                }
                let _e1160 = phi_2526_;
                phi_2530_ = _e1160;
                phi_2531_ = select(true, false, _e1153);
            } else {
                phi_2530_ = f32();
                phi_2531_ = true;
            }
            let _e1163 = phi_2530_;
            let _e1165 = phi_2531_;
            phi_2534_ = _e1163;
            phi_2535_ = _e1165;
        } else {
            phi_2534_ = f32();
            phi_2535_ = true;
        }
        let _e1167 = phi_2534_;
        let _e1169 = phi_2535_;
        if _e1169 {
            let _e1170 = (_e1144 & 2147483648u);
            let _e1177 = ((_e1144 & 8388607u) | (select(0u, 1u, ((_e1144 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
            let _e1181 = (_e1177 == 0u);
            if _e1181 {
                phi_3419_ = bitcast<f32>(_e1170);
            } else {
                let _e1187 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1177)), 32u, _e1181) - 8u);
                let _e1190 = (_e1177 << bitcast<u32>((_e1187 & 31u)));
                let _e1192 = ((_e1149 + select(0i, 1i, (_e1148 == 0i))) - bitcast<i32>(_e1187));
                if (_e1192 >= 255i) {
                    phi_3411_ = bitcast<f32>((_e1170 | 2139095040u));
                    phi_3412_ = f32();
                    phi_3413_ = true;
                } else {
                    let _e1196 = (_e1192 > 0i);
                    if _e1196 {
                        phi_3408_ = bitcast<f32>(((_e1170 | (bitcast<u32>(_e1192) << bitcast<u32>(23i))) | (_e1190 & 8388607u)));
                        phi_3409_ = f32();
                    } else {
                        if (_e1192 < -24i) {
                            phi_3381_ = 26u;
                        } else {
                            phi_3381_ = bitcast<u32>((1i - _e1192));
                        }
                        let _e1208 = phi_3381_;
                        let _e1209 = (_e1208 & 31u);
                        let _e1211 = (_e1190 >> bitcast<u32>(_e1209));
                        let _e1215 = (_e1190 & ((1u << bitcast<u32>(_e1209)) - 1u));
                        let _e1219 = (1u << bitcast<u32>(((_e1208 - 1u) & 31u)));
                        if (_e1215 > _e1219) {
                            phi_3402_ = true;
                        } else {
                            if (_e1215 == _e1219) {
                                phi_3400_ = ((_e1211 & 1u) == 1u);
                            } else {
                                phi_3400_ = false;
                            }
                            let _e1225 = phi_3400_;
                            phi_3402_ = _e1225;
                        }
                        let _e1227 = phi_3402_;
                        phi_3408_ = f32();
                        phi_3409_ = bitcast<f32>((_e1170 | (_e1211 + select(0u, 1u, _e1227))));
                    }
                    let _e1233 = phi_3408_;
                    let _e1235 = phi_3409_;
                    phi_3411_ = _e1233;
                    phi_3412_ = _e1235;
                    phi_3413_ = _e1196;
                }
                let _e1237 = phi_3411_;
                let _e1239 = phi_3412_;
                let _e1241 = phi_3413_;
                phi_3419_ = select(_e1239, _e1237, _e1241);
            }
            let _e1244 = phi_3419_;
            phi_2550_ = _e1244;
        } else {
            phi_2550_ = _e1167;
        }
        let _e1246 = phi_2550_;
        phi_2552_ = _e1246;
    }
    let _e1248 = phi_2552_;
    if (_e1248 == _e316) {
        let _e1250 = bitcast<u32>(_e1143);
        let _e1254 = (bitcast<i32>((_e1250 >> bitcast<u32>(23i))) & 255i);
        let _e1255 = (_e1254 + _e70);
        if (_e1254 == 255i) {
            phi_2601_ = _e1143;
        } else {
            if (_e1254 > 0i) {
                if (_e1255 > 0i) {
                    let _e1259 = (_e1255 < 255i);
                    if _e1259 {
                        phi_2575_ = bitcast<f32>((_e1250 + bitcast<u32>((_e70 << bitcast<u32>(23i)))));
                    } else {
                        phi_2575_ = f32();
                    }
                    let _e1266 = phi_2575_;
                    phi_2579_ = _e1266;
                    phi_2580_ = select(true, false, _e1259);
                } else {
                    phi_2579_ = f32();
                    phi_2580_ = true;
                }
                let _e1269 = phi_2579_;
                let _e1271 = phi_2580_;
                phi_2583_ = _e1269;
                phi_2584_ = _e1271;
            } else {
                phi_2583_ = f32();
                phi_2584_ = true;
            }
            let _e1273 = phi_2583_;
            let _e1275 = phi_2584_;
            if _e1275 {
                let _e1276 = (_e1250 & 2147483648u);
                let _e1283 = ((_e1250 & 8388607u) | (select(0u, 1u, ((_e1250 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e1287 = (_e1283 == 0u);
                if _e1287 {
                    phi_3493_ = bitcast<f32>(_e1276);
                } else {
                    let _e1293 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1283)), 32u, _e1287) - 8u);
                    let _e1296 = (_e1283 << bitcast<u32>((_e1293 & 31u)));
                    let _e1298 = ((_e1255 + select(0i, 1i, (_e1254 == 0i))) - bitcast<i32>(_e1293));
                    if (_e1298 >= 255i) {
                        phi_3485_ = bitcast<f32>((_e1276 | 2139095040u));
                        phi_3486_ = f32();
                        phi_3487_ = true;
                    } else {
                        let _e1302 = (_e1298 > 0i);
                        if _e1302 {
                            phi_3482_ = bitcast<f32>(((_e1276 | (bitcast<u32>(_e1298) << bitcast<u32>(23i))) | (_e1296 & 8388607u)));
                            phi_3483_ = f32();
                        } else {
                            if (_e1298 < -24i) {
                                phi_3455_ = 26u;
                            } else {
                                phi_3455_ = bitcast<u32>((1i - _e1298));
                            }
                            let _e1314 = phi_3455_;
                            let _e1315 = (_e1314 & 31u);
                            let _e1317 = (_e1296 >> bitcast<u32>(_e1315));
                            let _e1321 = (_e1296 & ((1u << bitcast<u32>(_e1315)) - 1u));
                            let _e1325 = (1u << bitcast<u32>(((_e1314 - 1u) & 31u)));
                            if (_e1321 > _e1325) {
                                phi_3476_ = true;
                            } else {
                                if (_e1321 == _e1325) {
                                    phi_3474_ = ((_e1317 & 1u) == 1u);
                                } else {
                                    phi_3474_ = false;
                                }
                                let _e1331 = phi_3474_;
                                phi_3476_ = _e1331;
                            }
                            let _e1333 = phi_3476_;
                            phi_3482_ = f32();
                            phi_3483_ = bitcast<f32>((_e1276 | (_e1317 + select(0u, 1u, _e1333))));
                        }
                        let _e1339 = phi_3482_;
                        let _e1341 = phi_3483_;
                        phi_3485_ = _e1339;
                        phi_3486_ = _e1341;
                        phi_3487_ = _e1302;
                    }
                    let _e1343 = phi_3485_;
                    let _e1345 = phi_3486_;
                    let _e1347 = phi_3487_;
                    phi_3493_ = select(_e1345, _e1343, _e1347);
                }
                let _e1350 = phi_3493_;
                phi_2599_ = _e1350;
            } else {
                phi_2599_ = _e1273;
            }
            let _e1352 = phi_2599_;
            phi_2601_ = _e1352;
        }
        let _e1354 = phi_2601_;
        phi_2609_ = select(true, false, (_e1354 == _e915));
    } else {
        phi_2609_ = true;
    }
    let _e1358 = phi_2609_;
    if _e1358 {
        let _e1359 = bitcast<u32>(_e1143);
        if ((_e1359 & 2147483647u) == 0u) {
            phi_2628_ = 0.000000000000000000000000000000000000000000001f;
        } else {
            if ((_e1359 >> bitcast<u32>(31i)) == 0u) {
                phi_2626_ = bitcast<f32>((_e1359 + 1u));
            } else {
                phi_2626_ = bitcast<f32>((_e1359 - 1u));
            }
            let _e1370 = phi_2626_;
            phi_2628_ = _e1370;
        }
        let _e1372 = phi_2628_;
        phi_2631_ = _e1372;
    } else {
        phi_2631_ = _e1143;
    }
    let _e1374 = phi_2631_;
    let _e1375 = ((((bitcast<f32>((bitcast<u32>(_e305) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e308) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e311) & 2147483647u))) * 0.00000071525625f) + 0.000000000000000000000000000000000000047019774f);
    let _e1376 = bitcast<u32>(_e317);
    let _e1380 = (bitcast<i32>((_e1376 >> bitcast<u32>(23i))) & 255i);
    let _e1381 = (_e1380 + _e455);
    if (_e1380 == 255i) {
        phi_2680_ = _e317;
    } else {
        if (_e1380 > 0i) {
            if (_e1381 > 0i) {
                let _e1385 = (_e1381 < 255i);
                if _e1385 {
                    phi_2654_ = bitcast<f32>((_e1376 + bitcast<u32>((_e455 << bitcast<u32>(23i)))));
                } else {
                    phi_2654_ = f32();
                }
                let _e1392 = phi_2654_;
                phi_2658_ = _e1392;
                phi_2659_ = select(true, false, _e1385);
            } else {
                phi_2658_ = f32();
                phi_2659_ = true;
            }
            let _e1395 = phi_2658_;
            let _e1397 = phi_2659_;
            phi_2662_ = _e1395;
            phi_2663_ = _e1397;
        } else {
            phi_2662_ = f32();
            phi_2663_ = true;
        }
        let _e1399 = phi_2662_;
        let _e1401 = phi_2663_;
        if _e1401 {
            let _e1402 = (_e1376 & 2147483648u);
            let _e1409 = ((_e1376 & 8388607u) | (select(0u, 1u, ((_e1376 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
            let _e1413 = (_e1409 == 0u);
            if _e1413 {
                phi_3567_ = bitcast<f32>(_e1402);
            } else {
                let _e1419 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1409)), 32u, _e1413) - 8u);
                let _e1422 = (_e1409 << bitcast<u32>((_e1419 & 31u)));
                let _e1424 = ((_e1381 + select(0i, 1i, (_e1380 == 0i))) - bitcast<i32>(_e1419));
                if (_e1424 >= 255i) {
                    phi_3559_ = bitcast<f32>((_e1402 | 2139095040u));
                    phi_3560_ = f32();
                    phi_3561_ = true;
                } else {
                    let _e1428 = (_e1424 > 0i);
                    if _e1428 {
                        phi_3556_ = bitcast<f32>(((_e1402 | (bitcast<u32>(_e1424) << bitcast<u32>(23i))) | (_e1422 & 8388607u)));
                        phi_3557_ = f32();
                    } else {
                        if (_e1424 < -24i) {
                            phi_3529_ = 26u;
                        } else {
                            phi_3529_ = bitcast<u32>((1i - _e1424));
                        }
                        let _e1440 = phi_3529_;
                        let _e1441 = (_e1440 & 31u);
                        let _e1443 = (_e1422 >> bitcast<u32>(_e1441));
                        let _e1447 = (_e1422 & ((1u << bitcast<u32>(_e1441)) - 1u));
                        let _e1451 = (1u << bitcast<u32>(((_e1440 - 1u) & 31u)));
                        if (_e1447 > _e1451) {
                            phi_3550_ = true;
                        } else {
                            if (_e1447 == _e1451) {
                                phi_3548_ = ((_e1443 & 1u) == 1u);
                            } else {
                                phi_3548_ = false;
                            }
                            let _e1457 = phi_3548_;
                            phi_3550_ = _e1457;
                        }
                        let _e1459 = phi_3550_;
                        phi_3556_ = f32();
                        phi_3557_ = bitcast<f32>((_e1402 | (_e1443 + select(0u, 1u, _e1459))));
                    }
                    let _e1465 = phi_3556_;
                    let _e1467 = phi_3557_;
                    phi_3559_ = _e1465;
                    phi_3560_ = _e1467;
                    phi_3561_ = _e1428;
                }
                let _e1469 = phi_3559_;
                let _e1471 = phi_3560_;
                let _e1473 = phi_3561_;
                phi_3567_ = select(_e1471, _e1469, _e1473);
            }
            let _e1476 = phi_3567_;
            phi_2678_ = _e1476;
        } else {
            phi_2678_ = _e1399;
        }
        let _e1478 = phi_2678_;
        phi_2680_ = _e1478;
    }
    let _e1480 = phi_2680_;
    let _e1481 = bitcast<u32>(_e1480);
    if (bitcast<f32>((_e1481 & 2147483647u)) > _e47) {
        phi_2693_ = bitcast<f32>(((_e1481 & 2147483648u) | 2139095039u));
    } else {
        phi_2693_ = _e1480;
    }
    let _e1489 = phi_2693_;
    let _e1490 = bitcast<u32>(_e1375);
    let _e1494 = (bitcast<i32>((_e1490 >> bitcast<u32>(23i))) & 255i);
    let _e1495 = (_e1494 + _e455);
    if (_e1494 == 255i) {
        phi_2741_ = _e1375;
    } else {
        if (_e1494 > 0i) {
            if (_e1495 > 0i) {
                let _e1499 = (_e1495 < 255i);
                if _e1499 {
                    phi_2715_ = bitcast<f32>((_e1490 + bitcast<u32>((_e455 << bitcast<u32>(23i)))));
                } else {
                    phi_2715_ = f32();
                }
                let _e1506 = phi_2715_;
                phi_2719_ = _e1506;
                phi_2720_ = select(true, false, _e1499);
            } else {
                phi_2719_ = f32();
                phi_2720_ = true;
            }
            let _e1509 = phi_2719_;
            let _e1511 = phi_2720_;
            phi_2723_ = _e1509;
            phi_2724_ = _e1511;
        } else {
            phi_2723_ = f32();
            phi_2724_ = true;
        }
        let _e1513 = phi_2723_;
        let _e1515 = phi_2724_;
        if _e1515 {
            let _e1516 = (_e1490 & 2147483648u);
            let _e1523 = ((_e1490 & 8388607u) | (select(0u, 1u, ((_e1490 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
            let _e1527 = (_e1523 == 0u);
            if _e1527 {
                phi_3641_ = bitcast<f32>(_e1516);
            } else {
                let _e1533 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1523)), 32u, _e1527) - 8u);
                let _e1536 = (_e1523 << bitcast<u32>((_e1533 & 31u)));
                let _e1538 = ((_e1495 + select(0i, 1i, (_e1494 == 0i))) - bitcast<i32>(_e1533));
                if (_e1538 >= 255i) {
                    phi_3633_ = bitcast<f32>((_e1516 | 2139095040u));
                    phi_3634_ = f32();
                    phi_3635_ = true;
                } else {
                    let _e1542 = (_e1538 > 0i);
                    if _e1542 {
                        phi_3630_ = bitcast<f32>(((_e1516 | (bitcast<u32>(_e1538) << bitcast<u32>(23i))) | (_e1536 & 8388607u)));
                        phi_3631_ = f32();
                    } else {
                        if (_e1538 < -24i) {
                            phi_3603_ = 26u;
                        } else {
                            phi_3603_ = bitcast<u32>((1i - _e1538));
                        }
                        let _e1554 = phi_3603_;
                        let _e1555 = (_e1554 & 31u);
                        let _e1557 = (_e1536 >> bitcast<u32>(_e1555));
                        let _e1561 = (_e1536 & ((1u << bitcast<u32>(_e1555)) - 1u));
                        let _e1565 = (1u << bitcast<u32>(((_e1554 - 1u) & 31u)));
                        if (_e1561 > _e1565) {
                            phi_3624_ = true;
                        } else {
                            if (_e1561 == _e1565) {
                                phi_3622_ = ((_e1557 & 1u) == 1u);
                            } else {
                                phi_3622_ = false;
                            }
                            let _e1571 = phi_3622_;
                            phi_3624_ = _e1571;
                        }
                        let _e1573 = phi_3624_;
                        phi_3630_ = f32();
                        phi_3631_ = bitcast<f32>((_e1516 | (_e1557 + select(0u, 1u, _e1573))));
                    }
                    let _e1579 = phi_3630_;
                    let _e1581 = phi_3631_;
                    phi_3633_ = _e1579;
                    phi_3634_ = _e1581;
                    phi_3635_ = _e1542;
                }
                let _e1583 = phi_3633_;
                let _e1585 = phi_3634_;
                let _e1587 = phi_3635_;
                phi_3641_ = select(_e1585, _e1583, _e1587);
            }
            let _e1590 = phi_3641_;
            phi_2739_ = _e1590;
        } else {
            phi_2739_ = _e1513;
        }
        let _e1592 = phi_2739_;
        phi_2741_ = _e1592;
    }
    let _e1594 = phi_2741_;
    let _e1595 = bitcast<u32>(_e1594);
    if (bitcast<f32>((_e1595 & 2147483647u)) > _e47) {
        phi_2754_ = bitcast<f32>(((_e1595 & 2147483648u) | 2139095039u));
    } else {
        phi_2754_ = _e1594;
    }
    let _e1603 = phi_2754_;
    let _e1604 = bitcast<u32>(_e1489);
    let _e1608 = (bitcast<i32>((_e1604 >> bitcast<u32>(23i))) & 255i);
    let _e1609 = (_e1608 + _e70);
    if (_e1608 == 255i) {
        phi_2801_ = _e1489;
    } else {
        if (_e1608 > 0i) {
            if (_e1609 > 0i) {
                let _e1613 = (_e1609 < 255i);
                if _e1613 {
                    phi_2775_ = bitcast<f32>((_e1604 + bitcast<u32>((_e70 << bitcast<u32>(23i)))));
                } else {
                    phi_2775_ = f32();
                }
                let _e1620 = phi_2775_;
                phi_2779_ = _e1620;
                phi_2780_ = select(true, false, _e1613);
            } else {
                phi_2779_ = f32();
                phi_2780_ = true;
            }
            let _e1623 = phi_2779_;
            let _e1625 = phi_2780_;
            phi_2783_ = _e1623;
            phi_2784_ = _e1625;
        } else {
            phi_2783_ = f32();
            phi_2784_ = true;
        }
        let _e1627 = phi_2783_;
        let _e1629 = phi_2784_;
        if _e1629 {
            let _e1630 = (_e1604 & 2147483648u);
            let _e1637 = ((_e1604 & 8388607u) | (select(0u, 1u, ((_e1604 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
            let _e1641 = (_e1637 == 0u);
            if _e1641 {
                phi_3715_ = bitcast<f32>(_e1630);
            } else {
                let _e1647 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1637)), 32u, _e1641) - 8u);
                let _e1650 = (_e1637 << bitcast<u32>((_e1647 & 31u)));
                let _e1652 = ((_e1609 + select(0i, 1i, (_e1608 == 0i))) - bitcast<i32>(_e1647));
                if (_e1652 >= 255i) {
                    phi_3707_ = bitcast<f32>((_e1630 | 2139095040u));
                    phi_3708_ = f32();
                    phi_3709_ = true;
                } else {
                    let _e1656 = (_e1652 > 0i);
                    if _e1656 {
                        phi_3704_ = bitcast<f32>(((_e1630 | (bitcast<u32>(_e1652) << bitcast<u32>(23i))) | (_e1650 & 8388607u)));
                        phi_3705_ = f32();
                    } else {
                        if (_e1652 < -24i) {
                            phi_3677_ = 26u;
                        } else {
                            phi_3677_ = bitcast<u32>((1i - _e1652));
                        }
                        let _e1668 = phi_3677_;
                        let _e1669 = (_e1668 & 31u);
                        let _e1671 = (_e1650 >> bitcast<u32>(_e1669));
                        let _e1675 = (_e1650 & ((1u << bitcast<u32>(_e1669)) - 1u));
                        let _e1679 = (1u << bitcast<u32>(((_e1668 - 1u) & 31u)));
                        if (_e1675 > _e1679) {
                            phi_3698_ = true;
                        } else {
                            if (_e1675 == _e1679) {
                                phi_3696_ = ((_e1671 & 1u) == 1u);
                            } else {
                                phi_3696_ = false;
                            }
                            let _e1685 = phi_3696_;
                            phi_3698_ = _e1685;
                        }
                        let _e1687 = phi_3698_;
                        phi_3704_ = f32();
                        phi_3705_ = bitcast<f32>((_e1630 | (_e1671 + select(0u, 1u, _e1687))));
                    }
                    let _e1693 = phi_3704_;
                    let _e1695 = phi_3705_;
                    phi_3707_ = _e1693;
                    phi_3708_ = _e1695;
                    phi_3709_ = _e1656;
                }
                let _e1697 = phi_3707_;
                let _e1699 = phi_3708_;
                let _e1701 = phi_3709_;
                phi_3715_ = select(_e1699, _e1697, _e1701);
            }
            let _e1704 = phi_3715_;
            phi_2799_ = _e1704;
        } else {
            phi_2799_ = _e1627;
        }
        let _e1706 = phi_2799_;
        phi_2801_ = _e1706;
    }
    let _e1708 = phi_2801_;
    if (_e1708 == _e317) {
        let _e1710 = bitcast<u32>(_e1603);
        let _e1714 = (bitcast<i32>((_e1710 >> bitcast<u32>(23i))) & 255i);
        let _e1715 = (_e1714 + _e70);
        if (_e1714 == 255i) {
            phi_2850_ = _e1603;
        } else {
            if (_e1714 > 0i) {
                if (_e1715 > 0i) {
                    let _e1719 = (_e1715 < 255i);
                    if _e1719 {
                        phi_2824_ = bitcast<f32>((_e1710 + bitcast<u32>((_e70 << bitcast<u32>(23i)))));
                    } else {
                        phi_2824_ = f32();
                    }
                    let _e1726 = phi_2824_;
                    phi_2828_ = _e1726;
                    phi_2829_ = select(true, false, _e1719);
                } else {
                    phi_2828_ = f32();
                    phi_2829_ = true;
                }
                let _e1729 = phi_2828_;
                let _e1731 = phi_2829_;
                phi_2832_ = _e1729;
                phi_2833_ = _e1731;
            } else {
                phi_2832_ = f32();
                phi_2833_ = true;
            }
            let _e1733 = phi_2832_;
            let _e1735 = phi_2833_;
            if _e1735 {
                let _e1736 = (_e1710 & 2147483648u);
                let _e1743 = ((_e1710 & 8388607u) | (select(0u, 1u, ((_e1710 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e1747 = (_e1743 == 0u);
                if _e1747 {
                    phi_3789_ = bitcast<f32>(_e1736);
                } else {
                    let _e1753 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1743)), 32u, _e1747) - 8u);
                    let _e1756 = (_e1743 << bitcast<u32>((_e1753 & 31u)));
                    let _e1758 = ((_e1715 + select(0i, 1i, (_e1714 == 0i))) - bitcast<i32>(_e1753));
                    if (_e1758 >= 255i) {
                        phi_3781_ = bitcast<f32>((_e1736 | 2139095040u));
                        phi_3782_ = f32();
                        phi_3783_ = true;
                    } else {
                        let _e1762 = (_e1758 > 0i);
                        if _e1762 {
                            phi_3778_ = bitcast<f32>(((_e1736 | (bitcast<u32>(_e1758) << bitcast<u32>(23i))) | (_e1756 & 8388607u)));
                            phi_3779_ = f32();
                        } else {
                            if (_e1758 < -24i) {
                                phi_3751_ = 26u;
                            } else {
                                phi_3751_ = bitcast<u32>((1i - _e1758));
                            }
                            let _e1774 = phi_3751_;
                            let _e1775 = (_e1774 & 31u);
                            let _e1777 = (_e1756 >> bitcast<u32>(_e1775));
                            let _e1781 = (_e1756 & ((1u << bitcast<u32>(_e1775)) - 1u));
                            let _e1785 = (1u << bitcast<u32>(((_e1774 - 1u) & 31u)));
                            if (_e1781 > _e1785) {
                                phi_3772_ = true;
                            } else {
                                if (_e1781 == _e1785) {
                                    phi_3770_ = ((_e1777 & 1u) == 1u);
                                } else {
                                    phi_3770_ = false;
                                }
                                let _e1791 = phi_3770_;
                                phi_3772_ = _e1791;
                            }
                            let _e1793 = phi_3772_;
                            phi_3778_ = f32();
                            phi_3779_ = bitcast<f32>((_e1736 | (_e1777 + select(0u, 1u, _e1793))));
                        }
                        let _e1799 = phi_3778_;
                        let _e1801 = phi_3779_;
                        phi_3781_ = _e1799;
                        phi_3782_ = _e1801;
                        phi_3783_ = _e1762;
                    }
                    let _e1803 = phi_3781_;
                    let _e1805 = phi_3782_;
                    let _e1807 = phi_3783_;
                    phi_3789_ = select(_e1805, _e1803, _e1807);
                }
                let _e1810 = phi_3789_;
                phi_2848_ = _e1810;
            } else {
                phi_2848_ = _e1733;
            }
            let _e1812 = phi_2848_;
            phi_2850_ = _e1812;
        }
        let _e1814 = phi_2850_;
        phi_2858_ = select(true, false, (_e1814 == _e1375));
    } else {
        phi_2858_ = true;
    }
    let _e1818 = phi_2858_;
    if _e1818 {
        let _e1819 = bitcast<u32>(_e1603);
        if ((_e1819 & 2147483647u) == 0u) {
            phi_2877_ = 0.000000000000000000000000000000000000000000001f;
        } else {
            if ((_e1819 >> bitcast<u32>(31i)) == 0u) {
                phi_2875_ = bitcast<f32>((_e1819 + 1u));
            } else {
                phi_2875_ = bitcast<f32>((_e1819 - 1u));
            }
            let _e1830 = phi_2875_;
            phi_2877_ = _e1830;
        }
        let _e1832 = phi_2877_;
        phi_2880_ = _e1832;
    } else {
        phi_2880_ = _e1603;
    }
    let _e1834 = phi_2880_;
    slimbvh_point.member[0u] = vec4<f32>(_e569, _e1029, _e1489, _e452);
    slimbvh_point.member[1u] = vec4<f32>(_e914, _e1374, _e1834, 0f);
    slimbvh_point.member[2u] = vec4<f32>(_e453.x, _e453.y, _e453.z, 0f);
    let _e1848 = select(_e1374, _e914, (_e914 > _e1374));
    let _e1850 = select(_e1834, _e1848, (_e1848 > _e1834));
    let _e1862 = (_e1850 * ((bitcast<f32>((bitcast<u32>(_e453.x) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e453.y) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e453.z) & 2147483647u))));
    let _e1866 = (_e569 + (_e453.x * _e1862));
    let _e1867 = (_e1029 + (_e453.y * _e1862));
    let _e1868 = (_e1489 + (_e453.z * _e1862));
    if (_e453.x > 0f) {
        let _e1870 = bitcast<u32>(_e1866);
        if ((_e1870 & 2147483647u) == 0u) {
            phi_1017_ = 0.000000000000000000000000000000000000000000001f;
        } else {
            if ((_e1870 >> bitcast<u32>(31i)) == 0u) {
                phi_1016_ = bitcast<f32>((_e1870 + 1u));
            } else {
                phi_1016_ = bitcast<f32>((_e1870 - 1u));
            }
            let _e1881 = phi_1016_;
            phi_1017_ = _e1881;
        }
        let _e1883 = phi_1017_;
        phi_1043_ = _e1883;
    } else {
        if (_e453.x < 0f) {
            let _e1886 = bitcast<u32>(-(_e1866));
            if ((_e1886 & 2147483647u) == 0u) {
                phi_1040_ = 0.000000000000000000000000000000000000000000001f;
            } else {
                if ((_e1886 >> bitcast<u32>(31i)) == 0u) {
                    phi_1039_ = bitcast<f32>((_e1886 + 1u));
                } else {
                    phi_1039_ = bitcast<f32>((_e1886 - 1u));
                }
                let _e1897 = phi_1039_;
                phi_1040_ = _e1897;
            }
            let _e1899 = phi_1040_;
            phi_1042_ = -(_e1899);
        } else {
            phi_1042_ = _e1866;
        }
        let _e1902 = phi_1042_;
        phi_1043_ = _e1902;
    }
    let _e1904 = phi_1043_;
    if (_e453.y > 0f) {
        let _e1906 = bitcast<u32>(_e1867);
        if ((_e1906 & 2147483647u) == 0u) {
            phi_1065_ = 0.000000000000000000000000000000000000000000001f;
        } else {
            if ((_e1906 >> bitcast<u32>(31i)) == 0u) {
                phi_1064_ = bitcast<f32>((_e1906 + 1u));
            } else {
                phi_1064_ = bitcast<f32>((_e1906 - 1u));
            }
            let _e1917 = phi_1064_;
            phi_1065_ = _e1917;
        }
        let _e1919 = phi_1065_;
        phi_1091_ = _e1919;
    } else {
        if (_e453.y < 0f) {
            let _e1922 = bitcast<u32>(-(_e1867));
            if ((_e1922 & 2147483647u) == 0u) {
                phi_1088_ = 0.000000000000000000000000000000000000000000001f;
            } else {
                if ((_e1922 >> bitcast<u32>(31i)) == 0u) {
                    phi_1087_ = bitcast<f32>((_e1922 + 1u));
                } else {
                    phi_1087_ = bitcast<f32>((_e1922 - 1u));
                }
                let _e1933 = phi_1087_;
                phi_1088_ = _e1933;
            }
            let _e1935 = phi_1088_;
            phi_1090_ = -(_e1935);
        } else {
            phi_1090_ = _e1867;
        }
        let _e1938 = phi_1090_;
        phi_1091_ = _e1938;
    }
    let _e1940 = phi_1091_;
    if (_e453.z > 0f) {
        let _e1942 = bitcast<u32>(_e1868);
        if ((_e1942 & 2147483647u) == 0u) {
            phi_1113_ = 0.000000000000000000000000000000000000000000001f;
        } else {
            if ((_e1942 >> bitcast<u32>(31i)) == 0u) {
                phi_1112_ = bitcast<f32>((_e1942 + 1u));
            } else {
                phi_1112_ = bitcast<f32>((_e1942 - 1u));
            }
            let _e1953 = phi_1112_;
            phi_1113_ = _e1953;
        }
        let _e1955 = phi_1113_;
        phi_1139_ = _e1955;
    } else {
        if (_e453.z < 0f) {
            let _e1958 = bitcast<u32>(-(_e1868));
            if ((_e1958 & 2147483647u) == 0u) {
                phi_1136_ = 0.000000000000000000000000000000000000000000001f;
            } else {
                if ((_e1958 >> bitcast<u32>(31i)) == 0u) {
                    phi_1135_ = bitcast<f32>((_e1958 + 1u));
                } else {
                    phi_1135_ = bitcast<f32>((_e1958 - 1u));
                }
                let _e1969 = phi_1135_;
                phi_1136_ = _e1969;
            }
            let _e1971 = phi_1136_;
            phi_1138_ = -(_e1971);
        } else {
            phi_1138_ = _e1868;
        }
        let _e1974 = phi_1138_;
        phi_1139_ = _e1974;
    }
    let _e1976 = phi_1139_;
    slimbvh_point.member[3u] = vec4<f32>(_e1904, _e1940, _e1976, 0f);
    let _e1980 = (_e453.x * -1f);
    let _e1981 = (_e453.y * -1f);
    let _e1982 = (_e453.z * -1f);
    let _e1994 = (_e1850 * ((bitcast<f32>((bitcast<u32>(_e1980) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1981) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e1982) & 2147483647u))));
    let _e1998 = (_e569 + (_e1980 * _e1994));
    let _e1999 = (_e1029 + (_e1981 * _e1994));
    let _e2000 = (_e1489 + (_e1982 * _e1994));
    if (_e1980 > 0f) {
        let _e2002 = bitcast<u32>(_e1998);
        if ((_e2002 & 2147483647u) == 0u) {
            phi_1206_ = 0.000000000000000000000000000000000000000000001f;
        } else {
            if ((_e2002 >> bitcast<u32>(31i)) == 0u) {
                phi_1205_ = bitcast<f32>((_e2002 + 1u));
            } else {
                phi_1205_ = bitcast<f32>((_e2002 - 1u));
            }
            let _e2013 = phi_1205_;
            phi_1206_ = _e2013;
        }
        let _e2015 = phi_1206_;
        phi_1232_ = _e2015;
    } else {
        if (_e1980 < 0f) {
            let _e2018 = bitcast<u32>(-(_e1998));
            if ((_e2018 & 2147483647u) == 0u) {
                phi_1229_ = 0.000000000000000000000000000000000000000000001f;
            } else {
                if ((_e2018 >> bitcast<u32>(31i)) == 0u) {
                    phi_1228_ = bitcast<f32>((_e2018 + 1u));
                } else {
                    phi_1228_ = bitcast<f32>((_e2018 - 1u));
                }
                let _e2029 = phi_1228_;
                phi_1229_ = _e2029;
            }
            let _e2031 = phi_1229_;
            phi_1231_ = -(_e2031);
        } else {
            phi_1231_ = _e1998;
        }
        let _e2034 = phi_1231_;
        phi_1232_ = _e2034;
    }
    let _e2036 = phi_1232_;
    if (_e1981 > 0f) {
        let _e2038 = bitcast<u32>(_e1999);
        if ((_e2038 & 2147483647u) == 0u) {
            phi_1254_ = 0.000000000000000000000000000000000000000000001f;
        } else {
            if ((_e2038 >> bitcast<u32>(31i)) == 0u) {
                phi_1253_ = bitcast<f32>((_e2038 + 1u));
            } else {
                phi_1253_ = bitcast<f32>((_e2038 - 1u));
            }
            let _e2049 = phi_1253_;
            phi_1254_ = _e2049;
        }
        let _e2051 = phi_1254_;
        phi_1280_ = _e2051;
    } else {
        if (_e1981 < 0f) {
            let _e2054 = bitcast<u32>(-(_e1999));
            if ((_e2054 & 2147483647u) == 0u) {
                phi_1277_ = 0.000000000000000000000000000000000000000000001f;
            } else {
                if ((_e2054 >> bitcast<u32>(31i)) == 0u) {
                    phi_1276_ = bitcast<f32>((_e2054 + 1u));
                } else {
                    phi_1276_ = bitcast<f32>((_e2054 - 1u));
                }
                let _e2065 = phi_1276_;
                phi_1277_ = _e2065;
            }
            let _e2067 = phi_1277_;
            phi_1279_ = -(_e2067);
        } else {
            phi_1279_ = _e1999;
        }
        let _e2070 = phi_1279_;
        phi_1280_ = _e2070;
    }
    let _e2072 = phi_1280_;
    if (_e1982 > 0f) {
        let _e2074 = bitcast<u32>(_e2000);
        if ((_e2074 & 2147483647u) == 0u) {
            phi_1302_ = 0.000000000000000000000000000000000000000000001f;
        } else {
            if ((_e2074 >> bitcast<u32>(31i)) == 0u) {
                phi_1301_ = bitcast<f32>((_e2074 + 1u));
            } else {
                phi_1301_ = bitcast<f32>((_e2074 - 1u));
            }
            let _e2085 = phi_1301_;
            phi_1302_ = _e2085;
        }
        let _e2087 = phi_1302_;
        phi_1328_ = _e2087;
    } else {
        if (_e1982 < 0f) {
            let _e2090 = bitcast<u32>(-(_e2000));
            if ((_e2090 & 2147483647u) == 0u) {
                phi_1325_ = 0.000000000000000000000000000000000000000000001f;
            } else {
                if ((_e2090 >> bitcast<u32>(31i)) == 0u) {
                    phi_1324_ = bitcast<f32>((_e2090 + 1u));
                } else {
                    phi_1324_ = bitcast<f32>((_e2090 - 1u));
                }
                let _e2101 = phi_1324_;
                phi_1325_ = _e2101;
            }
            let _e2103 = phi_1325_;
            phi_1327_ = -(_e2103);
        } else {
            phi_1327_ = _e2000;
        }
        let _e2106 = phi_1327_;
        phi_1328_ = _e2106;
    }
    let _e2108 = phi_1328_;
    slimbvh_point.member[4u] = vec4<f32>(_e2036, _e2072, _e2108, 0f);
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
