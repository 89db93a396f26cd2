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
    member: array<u32>,
}

struct SlimbvhTypeC {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
    member_2: f32,
    member_3: f32,
    member_4: i32,
}

struct SlimbvhTypeD {
    member: u32,
    member_1: u32,
}

struct SlimbvhTypeE {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct SlimbvhTypeF {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct SlimbvhTypeG {
    member: array<vec4<u32>, 2>,
}

struct SlimbvhTypeH {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct SlimbvhTypeI {
    member: SlimbvhTypeF,
    member_1: f32,
}

struct SlimbvhTypeJ {
    member: array<vec4<u32>, 3>,
    member_1: array<u32, 4>,
}

struct SlimbvhTypeK {
    member: array<SlimbvhTypeJ>,
}

struct SlimbvhTypeL {
    member: u32,
    member_1: f32,
}

struct SlimbvhTypeM {
    member: vec4<f32>,
    member_1: u32,
}

struct SlimbvhTypeN {
    member: SlimbvhTypeM,
    member_1: u32,
    member_2: u32,
}

struct SlimbvhTypeO {
    member: vec4<f32>,
}

struct SlimbvhTypeP {
    member: vec2<u32>,
}

struct SlimbvhTypeQ {
    member: SlimbvhTypeI,
    member_1: bool,
}

@group(0) @binding(0) 
var<uniform> slimbvh_exponent: SlimbvhTypeA;

@group(0) @binding(4) 
var<storage> slimbvh_sides: SlimbvhTypeB;

@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeK;

@group(0) @binding(2) 
var<storage> slimbvh_triangles: SlimbvhTypeB;

@group(0) @binding(3) 
var<uniform> slimbvh_root: SlimbvhTypeG;

@group(0) @binding(5) 
var<uniform> slimbvh_target: SlimbvhTypeG;

var<private> slimbvh_origin: SlimbvhTypeO;

var<private> slimbvh_direction: SlimbvhTypeO;

var<private> slimbvh_question: SlimbvhTypeP;

var<private> slimbvh_hit: SlimbvhTypeA;

fn slimbvh_trace() {
    var local: array<u32, 128>;
    var phi_733_: u32;
    var phi_739_: u32;
    var phi_745_: u32;
    var phi_1010_: i32;
    var phi_1021_: i32;
    var phi_1135_: i32;
    var phi_1264_: i32;
    var phi_1286_: u32;
    var phi_1287_: u32;
    var phi_1288_: bool;
    var phi_1322_: i32;
    var phi_1344_: u32;
    var phi_1345_: u32;
    var phi_1346_: bool;
    var phi_907_: i32;
    var phi_913_: u32;
    var phi_932_: u32;
    var phi_933_: u32;
    var phi_934_: bool;
    var phi_952_: i32;
    var phi_958_: u32;
    var phi_977_: u32;
    var phi_978_: u32;
    var phi_979_: bool;
    var phi_1356_: SlimbvhTypeC;
    var phi_1595_: SlimbvhTypeQ;
    var phi_1658_: array<f32, 3>;
    var phi_1659_: array<f32, 3>;
    var phi_1677_: array<f32, 3>;
    var phi_1678_: array<f32, 3>;
    var phi_1851_: SlimbvhTypeQ;
    var phi_1854_: u32;
    var phi_1856_: u32;
    var phi_1858_: u32;
    var phi_1867_: u32;
    var phi_1870_: u32;
    var phi_1872_: u32;
    var phi_1979_: SlimbvhTypeL;
    var phi_1980_: SlimbvhTypeL;
    var phi_2039_: SlimbvhTypeL;
    var phi_2040_: SlimbvhTypeL;
    var phi_2099_: SlimbvhTypeL;
    var phi_2100_: SlimbvhTypeL;
    var phi_2584_: u32;
    var phi_2597_: u32;
    var phi_2610_: u32;
    var phi_2623_: u32;
    var phi_5258_: SlimbvhTypeD;
    var phi_5270_: SlimbvhTypeD;
    var phi_5282_: SlimbvhTypeD;
    var phi_5294_: SlimbvhTypeD;
    var phi_5306_: SlimbvhTypeD;
    var phi_2704_: u32;
    var phi_2709_: u32;
    var phi_2710_: u32;
    var phi_2740_: u32;
    var phi_2741_: u32;
    var phi_1868_: u32;
    var phi_1871_: u32;
    var phi_1873_: u32;
    var local_1: bool;
    var local_2: u32;
    var phi_2891_: u32;
    var phi_2952_: u32;
    var phi_2955_: SlimbvhTypeN;
    var phi_2962_: SlimbvhTypeQ;
    var phi_2965_: SlimbvhTypeD;
    var phi_2966_: SlimbvhTypeD;
    var phi_2988_: SlimbvhTypeD;
    var phi_3003_: u32;
    var phi_3014_: u32;
    var phi_3030_: u32;
    var phi_3043_: u32;
    var phi_3054_: u32;
    var phi_3498_: u32;
    var phi_3511_: u32;
    var phi_3524_: u32;
    var phi_3550_: u32;
    var phi_3563_: u32;
    var phi_3576_: u32;
    var phi_3602_: u32;
    var phi_3615_: u32;
    var phi_3628_: u32;
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
    var phi_3404_: u32;
    var phi_3417_: u32;
    var phi_3427_: u32;
    var phi_3448_: u32;
    var phi_3469_: u32;
    var phi_3081_: u32;
    var phi_3127_: u32;
    var phi_3173_: u32;
    var phi_3640_: array<array<f32, 3>, 3>;
    var phi_4005_: f32;
    var phi_4006_: f32;
    var phi_4007_: f32;
    var phi_4008_: f32;
    var phi_4009_: vec3<f32>;
    var phi_4010_: vec3<f32>;
    var phi_4011_: vec3<f32>;
    var phi_4012_: vec3<f32>;
    var phi_4191_: f32;
    var phi_4217_: SlimbvhTypeE;
    var phi_4218_: SlimbvhTypeE;
    var phi_4221_: SlimbvhTypeE;
    var phi_4222_: SlimbvhTypeE;
    var phi_4223_: bool;
    var phi_4227_: SlimbvhTypeE;
    var phi_4236_: SlimbvhTypeF;
    var phi_4289_: i32;
    var phi_4429_: SlimbvhTypeH;
    var phi_4453_: u32;
    var phi_4482_: vec3<f32>;
    var phi_4483_: vec3<f32>;
    var phi_4501_: vec3<f32>;
    var phi_4502_: vec3<f32>;
    var phi_4520_: vec3<f32>;
    var phi_4521_: vec3<f32>;
    var phi_4557_: vec3<f32>;
    var phi_4739_: f32;
    var phi_4757_: bool;
    var phi_4758_: bool;
    var phi_4777_: bool;
    var phi_4778_: bool;
    var phi_4785_: SlimbvhTypeQ;
    var phi_4791_: SlimbvhTypeQ;
    var phi_4792_: SlimbvhTypeQ;
    var phi_4793_: SlimbvhTypeQ;
    var phi_2963_: SlimbvhTypeQ;
    var local_3: u32;
    var local_4: u32;
    var phi_4858_: u32;
    var phi_4859_: u32;
    var local_5: SlimbvhTypeQ;
    var phi_4868_: SlimbvhTypeQ;
    var phi_4869_: u32;
    var phi_4870_: u32;
    var phi_1852_: SlimbvhTypeQ;
    var phi_1855_: u32;
    var phi_1857_: u32;
    var phi_1859_: u32;
    var local_6: SlimbvhTypeQ;
    var phi_4906_: f32;
    var phi_4908_: f32;
    var phi_4909_: bool;
    var phi_4910_: f32;
    var phi_4911_: bool;
    var phi_5537_: u32;
    var phi_5555_: bool;
    var phi_5558_: bool;
    var phi_5571_: f32;
    var phi_5572_: f32;
    var phi_5577_: f32;
    var phi_5578_: f32;
    var phi_5579_: bool;
    var phi_5587_: f32;
    var phi_4926_: f32;
    var phi_4927_: f32;
    var phi_4939_: f32;
    var phi_4944_: SlimbvhTypeF;
    var local_7: SlimbvhTypeQ;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e105 = SlimbvhTypeF(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e109 = arrayLength((&slimbvh_nodes.member));
    let _e112 = arrayLength((&slimbvh_triangles.member));
    let _e122 = slimbvh_root.member[0u][0u];
    let _e126 = slimbvh_root.member[0u][1u];
    let _e130 = slimbvh_root.member[0u][2u];
    let _e134 = slimbvh_root.member[0u][3u];
    let _e138 = slimbvh_root.member[1u][0u];
    let _e142 = slimbvh_root.member[1u][1u];
    let _e146 = slimbvh_root.member[1u][2u];
    let _e158 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e134) + 127i)) << bitcast<u32>(23i)));
    let _e161 = slimbvh_exponent.member[1u];
    let _e164 = slimbvh_exponent.member[2u];
    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    let _e165 = slimbvh_origin.member;
    let _e171 = slimbvh_origin.member[3u];
    let _e172 = slimbvh_direction.member;
    let _e178 = slimbvh_direction.member[3u];
    let _e181 = slimbvh_exponent.member[0u];
    let _e182 = bitcast<i32>(_e181);
    let _e184 = (bitcast<u32>(_e165.x) & 2147483647u);
    let _e186 = (bitcast<u32>(_e165.y) & 2147483647u);
    let _e188 = (bitcast<u32>(_e165.z) & 2147483647u);
    let _e189 = bitcast<u32>(_e171);
    let _e190 = (_e189 & 2147483647u);
    let _e192 = (bitcast<u32>(_e172.x) & 2147483647u);
    let _e194 = (bitcast<u32>(_e172.y) & 2147483647u);
    let _e196 = (bitcast<u32>(_e172.z) & 2147483647u);
    let _e197 = bitcast<u32>(_e178);
    let _e198 = (_e197 & 2147483647u);
    let _e200 = select(_e194, _e192, (_e194 < _e192));
    let _e202 = select(_e196, _e200, (_e196 < _e200));
    let _e204 = select(_e184, _e202, (_e184 < _e202));
    let _e206 = select(_e186, _e204, (_e186 < _e204));
    let _e208 = select(_e188, _e206, (_e188 < _e206));
    let _e215 = (((select(_e190, _e208, (_e190 < _e208)) < 2139095040u) && (_e198 <= 2139095040u)) && (_e202 > 0u));
    if (_e192 == _e202) {
        phi_733_ = 0u;
    } else {
        phi_733_ = select(2u, 1u, (_e194 == _e202));
    }
    let _e220 = phi_733_;
    let _e221 = (_e220 == 2u);
    if _e221 {
        phi_739_ = 0u;
    } else {
        phi_739_ = (_e220 + 1u);
    }
    let _e224 = phi_739_;
    let _e225 = (_e224 == 2u);
    if _e225 {
        phi_745_ = 0u;
    } else {
        phi_745_ = (_e224 + 1u);
    }
    let _e228 = phi_745_;
    let _e229 = (_e224 == 0u);
    let _e231 = select(select(_e165.y, _e165.x, _e229), _e165.z, _e225);
    let _e232 = (_e228 == 0u);
    let _e234 = (_e228 == 2u);
    let _e235 = select(select(_e165.y, _e165.x, _e232), _e165.z, _e234);
    let _e236 = (_e220 == 0u);
    let _e238 = select(select(_e165.y, _e165.x, _e236), _e165.z, _e221);
    let _e240 = select(select(_e172.y, _e172.x, _e229), _e172.z, _e225);
    let _e242 = select(select(_e172.y, _e172.x, _e232), _e172.z, _e234);
    let _e244 = select(select(_e172.y, _e172.x, _e236), _e172.z, _e221);
    let _e245 = (_e190 - 1u);
    let _e246 = (_e198 - 1u);
    let _e248 = select(_e245, _e246, (_e246 < _e245));
    let _e249 = (_e184 - 1u);
    let _e250 = (_e186 - 1u);
    let _e252 = select(_e249, _e250, (_e250 < _e249));
    let _e253 = (_e188 - 1u);
    let _e255 = select(_e252, _e253, (_e253 < _e252));
    let _e256 = (_e192 - 1u);
    let _e257 = (_e194 - 1u);
    let _e259 = select(_e256, _e257, (_e257 < _e256));
    let _e260 = (_e196 - 1u);
    let _e262 = select(_e259, _e260, (_e260 < _e259));
    let _e264 = select(_e255, _e262, (_e262 < _e255));
    if (((select(_e264, _e248, (_e248 < _e264)) >= 8388607u) && (_e202 < 2130706432u)) && (bitcast<u32>((_e182 + 126i)) <= 253u)) {
        let _e529 = bitcast<i32>((_e202 >> bitcast<u32>(23i)));
        let _e530 = (_e529 - 127i);
        let _e531 = (_e182 + _e530);
        let _e536 = bitcast<f32>((bitcast<u32>((_e182 + 127i)) << bitcast<u32>(23i)));
        let _e541 = bitcast<f32>((bitcast<u32>((254i - _e529)) << bitcast<u32>(23i)));
        if (_e190 >= 2139095040u) {
            phi_907_ = 255i;
        } else {
            phi_907_ = (bitcast<i32>((_e190 >> bitcast<u32>(23i))) + _e531);
        }
        let _e556 = phi_907_;
        if (_e190 == 0u) {
            phi_913_ = 0u;
        } else {
            phi_913_ = (_e190 | 8388608u);
        }
        let _e560 = phi_913_;
        if (_e556 <= 0i) {
            phi_933_ = u32();
            phi_934_ = true;
        } else {
            let _e567 = (_e560 == 0u);
            if _e567 {
                phi_932_ = u32();
            } else {
                phi_932_ = select(((bitcast<u32>(_e556) << bitcast<u32>(23i)) | (_e560 & 8388607u)), 2139095039u, (_e556 >= 255i));
            }
            let _e571 = phi_932_;
            phi_933_ = _e571;
            phi_934_ = _e567;
        }
        let _e573 = phi_933_;
        let _e575 = phi_934_;
        if (_e198 >= 2139095040u) {
            phi_952_ = 255i;
        } else {
            phi_952_ = (bitcast<i32>((_e198 >> bitcast<u32>(23i))) + _e531);
        }
        let _e586 = phi_952_;
        if (_e198 == 0u) {
            phi_958_ = 0u;
        } else {
            phi_958_ = (_e198 | 8388608u);
        }
        let _e590 = phi_958_;
        if (_e586 <= 0i) {
            phi_978_ = u32();
            phi_979_ = true;
        } else {
            let _e597 = (_e590 == 0u);
            if _e597 {
                phi_977_ = u32();
            } else {
                phi_977_ = select(((bitcast<u32>(_e586) << bitcast<u32>(23i)) | (_e590 & 8388607u)), 2139095039u, (_e586 >= 255i));
            }
            let _e601 = phi_977_;
            phi_978_ = _e601;
            phi_979_ = _e597;
        }
        let _e603 = phi_978_;
        let _e605 = phi_979_;
        phi_1356_ = SlimbvhTypeC(array<f32, 3>((_e231 * _e536), (_e235 * _e536), (_e238 * _e536)), array<f32, 3>((_e240 * _e541), (_e242 * _e541), (_e244 * _e541)), bitcast<f32>(((_e189 & 2147483648u) | select(_e573, 0u, _e575))), bitcast<f32>(((_e197 & 2147483648u) | select(_e603, 0u, _e605))), _e530);
    } else {
        let _e277 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e202, _e215))) & 2147483647u);
        if (_e277 >= 8388608u) {
            phi_1010_ = (bitcast<i32>((_e277 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_1010_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e277)), 32u, (_e277 == 0u))));
        }
        let _e291 = phi_1010_;
        let _e292 = (_e182 + _e291);
        if (_e182 < -126i) {
            phi_1021_ = -126i;
        } else {
            phi_1021_ = select(_e182, 127i, (_e182 > 127i));
        }
        let _e297 = phi_1021_;
        let _e302 = bitcast<f32>((bitcast<u32>((_e297 + 127i)) << bitcast<u32>(23i)));
        let _e308 = bitcast<f32>((bitcast<u32>(((_e182 - _e297) + 127i)) << bitcast<u32>(23i)));
        let _e309 = bitcast<u32>(_e231);
        let _e311 = ((_e309 & 2139095040u) != 0u);
        let _e326 = bitcast<u32>(_e235);
        let _e328 = ((_e326 & 2139095040u) != 0u);
        let _e343 = bitcast<u32>(_e238);
        let _e345 = ((_e343 & 2139095040u) != 0u);
        let _e361 = -(_e291);
        if (_e361 < -126i) {
            phi_1135_ = -126i;
        } else {
            phi_1135_ = select(_e361, 127i, (_e361 > 127i));
        }
        let _e366 = phi_1135_;
        let _e371 = bitcast<f32>((bitcast<u32>((_e366 + 127i)) << bitcast<u32>(23i)));
        let _e377 = bitcast<f32>((bitcast<u32>(((_e361 - _e366) + 127i)) << bitcast<u32>(23i)));
        let _e378 = bitcast<u32>(_e240);
        let _e380 = ((_e378 & 2139095040u) != 0u);
        let _e395 = bitcast<u32>(_e242);
        let _e397 = ((_e395 & 2139095040u) != 0u);
        let _e412 = bitcast<u32>(_e244);
        let _e414 = ((_e412 & 2139095040u) != 0u);
        let _e436 = ((_e190 & 8388607u) | (select(0u, 1u, ((_e190 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e439 = bitcast<i32>((_e190 >> bitcast<u32>(23i)));
        let _e446 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e436)), 32u, (_e436 == 0u))) - 8i);
        if (_e439 == 255i) {
            phi_1264_ = 255i;
        } else {
            phi_1264_ = (((_e439 + select(0i, 1i, (_e439 == 0i))) - _e446) + _e292);
        }
        let _e454 = phi_1264_;
        let _e458 = (_e436 << bitcast<u32>(((_e446 & 31i) & 31i)));
        if (_e454 <= 0i) {
            phi_1287_ = u32();
            phi_1288_ = true;
        } else {
            let _e465 = (_e458 == 0u);
            if _e465 {
                phi_1286_ = u32();
            } else {
                phi_1286_ = select(((bitcast<u32>(_e454) << bitcast<u32>(23i)) | (_e458 & 8388607u)), 2139095039u, (_e454 >= 255i));
            }
            let _e469 = phi_1286_;
            phi_1287_ = _e469;
            phi_1288_ = _e465;
        }
        let _e471 = phi_1287_;
        let _e473 = phi_1288_;
        let _e484 = ((_e198 & 8388607u) | (select(0u, 1u, ((_e198 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e487 = bitcast<i32>((_e198 >> bitcast<u32>(23i)));
        let _e494 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e484)), 32u, (_e484 == 0u))) - 8i);
        if (_e487 == 255i) {
            phi_1322_ = 255i;
        } else {
            phi_1322_ = (((_e487 + select(0i, 1i, (_e487 == 0i))) - _e494) + _e292);
        }
        let _e502 = phi_1322_;
        let _e506 = (_e484 << bitcast<u32>(((_e494 & 31i) & 31i)));
        if (_e502 <= 0i) {
            phi_1345_ = u32();
            phi_1346_ = true;
        } else {
            let _e513 = (_e506 == 0u);
            if _e513 {
                phi_1344_ = u32();
            } else {
                phi_1344_ = select(((bitcast<u32>(_e502) << bitcast<u32>(23i)) | (_e506 & 8388607u)), 2139095039u, (_e502 >= 255i));
            }
            let _e517 = phi_1344_;
            phi_1345_ = _e517;
            phi_1346_ = _e513;
        }
        let _e519 = phi_1345_;
        let _e521 = phi_1346_;
        phi_1356_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e309 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e309 & 2147483648u))), _e231, _e311) * _e302) * select(0.00000011920929f, 1f, _e311)) * _e308), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e326 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e326 & 2147483648u))), _e235, _e328) * _e302) * select(0.00000011920929f, 1f, _e328)) * _e308), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e343 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e343 & 2147483648u))), _e238, _e345) * _e302) * select(0.00000011920929f, 1f, _e345)) * _e308)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e378 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e378 & 2147483648u))), _e240, _e380) * _e371) * select(0.00000011920929f, 1f, _e380)) * _e377), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e395 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e395 & 2147483648u))), _e242, _e397) * _e371) * select(0.00000011920929f, 1f, _e397)) * _e377), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e412 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e412 & 2147483648u))), _e244, _e414) * _e371) * select(0.00000011920929f, 1f, _e414)) * _e377)), bitcast<f32>(((_e189 & 2147483648u) | select(_e471, 0u, _e473))), bitcast<f32>(((_e197 & 2147483648u) | select(_e519, 0u, _e521))), _e291);
    }
    let _e612 = phi_1356_;
    let _e627 = (bitcast<f32>((bitcast<u32>(_e612.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e630 = bitcast<f32>((bitcast<u32>(_e612.member[0]) & 2147483647u));
    let _e631 = (_e630 * 0.00000011920929f);
    let _e634 = select(select(0.00000000000011368684f, _e631, (_e631 > 0.00000000000011368684f)), 0f, _e627);
    let _e635 = select(0f, _e612.member_1[0], _e627);
    let _e636 = (_e612.member[0] + _e634);
    let _e637 = (_e612.member[0] - _e634);
    let _e639 = select(38685626000000000000000000f, (1f / _e612.member_1[0]), _e627);
    let _e643 = (bitcast<f32>((bitcast<u32>(_e612.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e646 = bitcast<f32>((bitcast<u32>(_e612.member[1]) & 2147483647u));
    let _e647 = (_e646 * 0.00000011920929f);
    let _e650 = select(select(0.00000000000011368684f, _e647, (_e647 > 0.00000000000011368684f)), 0f, _e643);
    let _e651 = select(0f, _e612.member_1[1], _e643);
    let _e652 = (_e612.member[1] + _e650);
    let _e653 = (_e612.member[1] - _e650);
    let _e655 = select(38685626000000000000000000f, (1f / _e612.member_1[1]), _e643);
    let _e659 = (bitcast<f32>((bitcast<u32>(_e612.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e662 = bitcast<f32>((bitcast<u32>(_e612.member[2]) & 2147483647u));
    let _e663 = (_e662 * 0.00000011920929f);
    let _e666 = select(select(0.00000000000011368684f, _e663, (_e663 > 0.00000000000011368684f)), 0f, _e659);
    let _e667 = select(0f, _e612.member_1[2], _e659);
    let _e668 = (_e612.member[2] + _e666);
    let _e669 = (_e612.member[2] - _e666);
    let _e671 = select(38685626000000000000000000f, (1f / _e612.member_1[2]), _e659);
    let _e673 = select(_e646, _e630, (_e630 > _e646));
    let _e677 = (_e215 && (select(_e662, _e673, (_e673 > _e662)) <= 1099511600000f));
    let _e678 = select(0f, _e612.member_3, _e677);
    let _e679 = select(1f, _e612.member_2, _e677);
    let _e683 = slimbvh_question.member[1u];
    let _e686 = slimbvh_question.member[0u];
    if (_e686 == 1u) {
        phi_1595_ = SlimbvhTypeQ(SlimbvhTypeI(_e105, _e678), true);
    } else {
        phi_1595_ = SlimbvhTypeQ(SlimbvhTypeI(_e105, _e678), false);
    }
    let _e693 = phi_1595_;
    let _e698 = (_e224 & 3u);
    let _e699 = (_e228 & 3u);
    let _e700 = (_e220 & 3u);
    let _e703 = (bitcast<u32>(_e639) >> bitcast<u32>(31i));
    let _e706 = (bitcast<u32>(_e655) >> bitcast<u32>(31i));
    let _e709 = (bitcast<u32>(_e671) >> bitcast<u32>(31i));
    let _e713 = (f32(bitcast<i32>(_e122)) * _e158);
    let _e715 = (f32(bitcast<i32>(_e126)) * _e158);
    let _e717 = (f32(bitcast<i32>(_e130)) * _e158);
    let _e718 = (_e698 == 0u);
    if _e718 {
        phi_1659_ = array<f32, 3>(_e713, _e715, _e717);
    } else {
        if (_e698 == 1u) {
            phi_1658_ = array<f32, 3>(_e715, _e717, _e713);
        } else {
            phi_1658_ = array<f32, 3>(_e717, _e713, _e715);
        }
        let _e723 = phi_1658_;
        phi_1659_ = _e723;
    }
    let _e726 = phi_1659_;
    let _e728 = (f32(bitcast<i32>(_e138)) * _e158);
    let _e730 = (f32(bitcast<i32>(_e142)) * _e158);
    let _e732 = (f32(bitcast<i32>(_e146)) * _e158);
    if _e718 {
        phi_1678_ = array<f32, 3>(_e728, _e730, _e732);
    } else {
        if (_e698 == 1u) {
            phi_1677_ = array<f32, 3>(_e730, _e732, _e728);
        } else {
            phi_1677_ = array<f32, 3>(_e732, _e728, _e730);
        }
        let _e737 = phi_1677_;
        phi_1678_ = _e737;
    }
    let _e740 = phi_1678_;
    let _e751 = ((_e726[0] - _e636) * _e639);
    let _e752 = ((_e740[0] - _e637) * _e639);
    let _e753 = vec4<f32>(_e751, f32(), _e752, f32());
    let _e756 = ((_e726[1] - _e652) * _e655);
    let _e757 = ((_e740[1] - _e653) * _e655);
    let _e758 = vec4<f32>(_e756, f32(), _e757, f32());
    let _e761 = ((_e726[2] - _e668) * _e671);
    let _e762 = ((_e740[2] - _e669) * _e671);
    let _e763 = vec4<f32>(_e761, f32(), _e762, f32());
    let _e764 = vec4<f32>(_e752, f32(), _e751, f32());
    let _e766 = vec4<f32>(_e757, f32(), _e756, f32());
    let _e768 = vec4<f32>(_e762, f32(), _e761, f32());
    phi_1851_ = _e693;
    phi_1854_ = select(4294967295u, select(4294967295u, 0u, (_e679 <= _e678)), (max(max(max(min(_e753, _e764).x, min(_e758, _e766).x), min(_e763, _e768).x), _e679) <= min((min(min(max(_e753, _e764).x, max(_e758, _e766).x), max(_e763, _e768).x) + (max(max(_e763, _e768).x, -(min(_e763, _e768).x)) * 0.0000019073523f)), _e693.member.member_1)));
    phi_1856_ = select(0u, 4294967295u, (_e109 == 0u));
    phi_1858_ = (_e109 + 1u);
    loop {
        let _e792 = phi_1851_;
        let _e794 = phi_1854_;
        let _e796 = phi_1856_;
        let _e798 = phi_1858_;
        local_6 = _e792;
        let _e799 = (_e794 <= 2147483647u);
        if _e799 {
            phi_1867_ = _e794;
            phi_1870_ = _e796;
            phi_1872_ = _e798;
            loop {
                let _e801 = phi_1867_;
                let _e803 = phi_1870_;
                let _e805 = phi_1872_;
                local_2 = _e803;
                local_3 = _e801;
                local_4 = _e801;
                local_8 = _e801;
                local_9 = _e803;
                local_10 = _e805;
                let _e806 = (_e801 <= 2147483647u);
                let _e808 = (_e803 + _e161);
                let _e812 = (_e806 && !(((_e803 >= _e109) || (_e808 >= _e109))));
                local_1 = _e806;
                if _e812 {
                    let _e818 = slimbvh_nodes.member[_e808].member[select(_e698, 2u, (2u < _e698))];
                    let _e824 = slimbvh_nodes.member[_e808].member[select(_e699, 2u, (2u < _e699))];
                    let _e830 = slimbvh_nodes.member[_e808].member[select(_e700, 2u, (2u < _e700))];
                    let _e833 = bitcast<u32>(_e158);
                    let _e838 = bitcast<f32>(_e818.x);
                    let _e843 = (_e838 + (f32((_e818.w >> bitcast<u32>(5u))) * _e158));
                    if (_e703 == 0u) {
                        phi_1979_ = SlimbvhTypeL(_e818.z, _e843);
                        phi_1980_ = SlimbvhTypeL(_e818.y, _e838);
                    } else {
                        phi_1979_ = SlimbvhTypeL(_e818.y, _e838);
                        phi_1980_ = SlimbvhTypeL(_e818.z, _e843);
                    }
                    let _e854 = phi_1979_;
                    let _e856 = phi_1980_;
                    let _e860 = bitcast<f32>(((_e833 + ((_e818.w & 31u) << bitcast<u32>(23i))) ^ (_e703 << bitcast<u32>(31i))));
                    let _e900 = bitcast<f32>(_e824.x);
                    let _e905 = (_e900 + (f32((_e824.w >> bitcast<u32>(5u))) * _e158));
                    if (_e706 == 0u) {
                        phi_2039_ = SlimbvhTypeL(_e824.z, _e905);
                        phi_2040_ = SlimbvhTypeL(_e824.y, _e900);
                    } else {
                        phi_2039_ = SlimbvhTypeL(_e824.y, _e900);
                        phi_2040_ = SlimbvhTypeL(_e824.z, _e905);
                    }
                    let _e916 = phi_2039_;
                    let _e918 = phi_2040_;
                    let _e922 = bitcast<f32>(((_e833 + ((_e824.w & 31u) << bitcast<u32>(23i))) ^ (_e706 << bitcast<u32>(31i))));
                    let _e962 = bitcast<f32>(_e830.x);
                    let _e967 = (_e962 + (f32((_e830.w >> bitcast<u32>(5u))) * _e158));
                    if (_e709 == 0u) {
                        phi_2099_ = SlimbvhTypeL(_e830.z, _e967);
                        phi_2100_ = SlimbvhTypeL(_e830.y, _e962);
                    } else {
                        phi_2099_ = SlimbvhTypeL(_e830.y, _e962);
                        phi_2100_ = SlimbvhTypeL(_e830.z, _e967);
                    }
                    let _e978 = phi_2099_;
                    let _e980 = phi_2100_;
                    let _e984 = bitcast<f32>(((_e833 + ((_e830.w & 31u) << bitcast<u32>(23i))) ^ (_e709 << bitcast<u32>(31i))));
                    let _e1020 = (_e860 * _e639);
                    let _e1027 = (((_e856.member_1 - _e636) * _e639) + (bitcast<f32>((bitcast<u32>(_e1020) & 2147483647u)) * -0.00012207031f));
                    let _e1036 = (-(_e860) * _e639);
                    let _e1043 = (((_e854.member_1 - _e637) * _e639) + (bitcast<f32>((bitcast<u32>(_e1036) & 2147483647u)) * 0.00012207031f));
                    let _e1052 = (_e922 * _e655);
                    let _e1059 = (((_e918.member_1 - _e652) * _e655) + (bitcast<f32>((bitcast<u32>(_e1052) & 2147483647u)) * -0.00012207031f));
                    let _e1068 = (-(_e922) * _e655);
                    let _e1075 = (((_e916.member_1 - _e653) * _e655) + (bitcast<f32>((bitcast<u32>(_e1068) & 2147483647u)) * 0.00012207031f));
                    let _e1084 = (_e984 * _e671);
                    let _e1091 = (((_e980.member_1 - _e668) * _e671) + (bitcast<f32>((bitcast<u32>(_e1084) & 2147483647u)) * -0.00012207031f));
                    let _e1096 = ((f32((_e980.member & 255u)) * _e1084) + _e1091);
                    let _e1097 = ((f32(((_e980.member >> bitcast<u32>(8u)) & 255u)) * _e1084) + _e1091);
                    let _e1098 = ((f32(((_e980.member >> bitcast<u32>(16u)) & 255u)) * _e1084) + _e1091);
                    let _e1099 = ((f32(((_e980.member >> bitcast<u32>(24u)) & 255u)) * _e1084) + _e1091);
                    let _e1100 = (-(_e984) * _e671);
                    let _e1107 = (((_e978.member_1 - _e669) * _e671) + (bitcast<f32>((bitcast<u32>(_e1100) & 2147483647u)) * 0.00012207031f));
                    let _e1112 = ((f32((_e978.member & 255u)) * _e1100) + _e1107);
                    let _e1113 = ((f32(((_e978.member >> bitcast<u32>(8u)) & 255u)) * _e1100) + _e1107);
                    let _e1114 = ((f32(((_e978.member >> bitcast<u32>(16u)) & 255u)) * _e1100) + _e1107);
                    let _e1115 = ((f32(((_e978.member >> bitcast<u32>(24u)) & 255u)) * _e1100) + _e1107);
                    let _e1148 = max(max(max(((f32((_e856.member & 255u)) * _e1020) + _e1027), ((f32((_e918.member & 255u)) * _e1052) + _e1059)), _e1096), _e679);
                    let _e1149 = max(max(max(((f32(((_e856.member >> bitcast<u32>(8u)) & 255u)) * _e1020) + _e1027), ((f32(((_e918.member >> bitcast<u32>(8u)) & 255u)) * _e1052) + _e1059)), _e1097), _e679);
                    let _e1150 = max(max(max(((f32(((_e856.member >> bitcast<u32>(16u)) & 255u)) * _e1020) + _e1027), ((f32(((_e918.member >> bitcast<u32>(16u)) & 255u)) * _e1052) + _e1059)), _e1098), _e679);
                    let _e1151 = max(max(max(((f32(((_e856.member >> bitcast<u32>(24u)) & 255u)) * _e1020) + _e1027), ((f32(((_e918.member >> bitcast<u32>(24u)) & 255u)) * _e1052) + _e1059)), _e1099), _e679);
                    let _e1156 = (_e792.member.member_1 + (bitcast<f32>((bitcast<u32>(_e792.member.member_1) & 2147483647u)) * 0.0000004768374f));
                    if (_e1148 <= min((min(min(((f32((_e854.member & 255u)) * _e1036) + _e1043), ((f32((_e916.member & 255u)) * _e1068) + _e1075)), _e1112) + (max(_e1112, -(_e1096)) * 0.0000023841915f)), _e1156)) {
                        phi_2584_ = (((bitcast<u32>(_e1148) ^ select(0u, 4294967288u, _e693.member_1)) & 2147483640u) | 4u);
                    } else {
                        phi_2584_ = 4294967288u;
                    }
                    let _e1171 = phi_2584_;
                    if (_e1149 <= min((min(min(((f32(((_e854.member >> bitcast<u32>(8u)) & 255u)) * _e1036) + _e1043), ((f32(((_e916.member >> bitcast<u32>(8u)) & 255u)) * _e1068) + _e1075)), _e1113) + (max(_e1113, -(_e1097)) * 0.0000023841915f)), _e1156)) {
                        phi_2597_ = ((((bitcast<u32>(_e1149) ^ select(0u, 4294967288u, _e693.member_1)) & 2147483640u) | 4u) | 1u);
                    } else {
                        phi_2597_ = 4294967288u;
                    }
                    let _e1179 = phi_2597_;
                    if (_e1150 <= min((min(min(((f32(((_e854.member >> bitcast<u32>(16u)) & 255u)) * _e1036) + _e1043), ((f32(((_e916.member >> bitcast<u32>(16u)) & 255u)) * _e1068) + _e1075)), _e1114) + (max(_e1114, -(_e1098)) * 0.0000023841915f)), _e1156)) {
                        phi_2610_ = ((((bitcast<u32>(_e1150) ^ select(0u, 4294967288u, _e693.member_1)) & 2147483640u) | 4u) | 2u);
                    } else {
                        phi_2610_ = 4294967288u;
                    }
                    let _e1187 = phi_2610_;
                    if (_e1151 <= min((min(min(((f32(((_e854.member >> bitcast<u32>(24u)) & 255u)) * _e1036) + _e1043), ((f32(((_e916.member >> bitcast<u32>(24u)) & 255u)) * _e1068) + _e1075)), _e1115) + (max(_e1115, -(_e1099)) * 0.0000023841915f)), _e1156)) {
                        phi_2623_ = ((((bitcast<u32>(_e1151) ^ select(0u, 4294967288u, _e693.member_1)) & 2147483640u) | 4u) | 3u);
                    } else {
                        phi_2623_ = 4294967288u;
                    }
                    let _e1195 = phi_2623_;
                    if (_e1171 < _e1179) {
                        phi_5258_ = SlimbvhTypeD(_e1171, _e1179);
                    } else {
                        phi_5258_ = SlimbvhTypeD(_e1179, _e1171);
                    }
                    let _e1200 = phi_5258_;
                    if (_e1187 < _e1195) {
                        phi_5270_ = SlimbvhTypeD(_e1187, _e1195);
                    } else {
                        phi_5270_ = SlimbvhTypeD(_e1195, _e1187);
                    }
                    let _e1207 = phi_5270_;
                    if (_e1200.member < _e1207.member) {
                        phi_5282_ = SlimbvhTypeD(_e1200.member, _e1207.member);
                    } else {
                        phi_5282_ = SlimbvhTypeD(_e1207.member, _e1200.member);
                    }
                    let _e1214 = phi_5282_;
                    if (_e1200.member_1 < _e1207.member_1) {
                        phi_5294_ = SlimbvhTypeD(_e1200.member_1, _e1207.member_1);
                    } else {
                        phi_5294_ = SlimbvhTypeD(_e1207.member_1, _e1200.member_1);
                    }
                    let _e1221 = phi_5294_;
                    if (_e1221.member < _e1214.member_1) {
                        phi_5306_ = SlimbvhTypeD(_e1221.member, _e1214.member_1);
                    } else {
                        phi_5306_ = SlimbvhTypeD(_e1214.member_1, _e1221.member);
                    }
                    let _e1228 = phi_5306_;
                    let _e1243 = (((_e1214.member & 7u) | ((_e1228.member & 7u) << bitcast<u32>(3u))) | (((_e1228.member_1 & 7u) | ((_e1221.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                    if (_e1243 == 0u) {
                        let _e1261 = (_e801 - 1u);
                        let _e1264 = local[(_e1261 % 128u)];
                        let _e1265 = (_e1264 & 511u);
                        let _e1267 = (_e1265 >> bitcast<u32>(3u));
                        let _e1270 = ((_e1267 == 0u) || (_e1261 == 4294967295u));
                        if _e1270 {
                        } else {
                            local[(_e1261 % 128u)] = (((_e1264 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1267);
                        }
                        phi_2709_ = select(_e801, _e1261, _e1270);
                        phi_2710_ = (((_e1264 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1265 & 3u) & 3u));
                    } else {
                        let _e1246 = (_e1243 >> bitcast<u32>(3u));
                        if (_e1246 == 0u) {
                            phi_2704_ = _e801;
                        } else {
                            local[(_e801 % 128u)] = ((_e808 << bitcast<u32>(9u)) | _e1246);
                            phi_2704_ = (_e801 + 1u);
                        }
                        let _e1255 = phi_2704_;
                        phi_2709_ = _e1255;
                        phi_2710_ = ((_e808 << bitcast<u32>(2i)) | ((_e1243 & 3u) & 3u));
                    }
                    let _e1285 = phi_2709_;
                    let _e1287 = phi_2710_;
                    let _e1289 = (_e1287 >> bitcast<u32>(2i));
                    if (_e1289 < _e109) {
                        let _e1295 = slimbvh_nodes.member[_e1289].member_1[(_e1287 & 3u)];
                        if ((_e1295 & 2147483648u) != 0u) {
                            phi_2740_ = (2147483648u | _e1287);
                        } else {
                            phi_2740_ = _e1295;
                        }
                        let _e1300 = phi_2740_;
                        phi_2741_ = _e1300;
                    } else {
                        phi_2741_ = 4294967295u;
                    }
                    let _e1302 = phi_2741_;
                    let _e1303 = (_e805 - 1u);
                    phi_1868_ = select(_e1285, 4294967295u, (_e1303 == 0u));
                    phi_1871_ = _e1302;
                    phi_1873_ = _e1303;
                } else {
                    phi_1868_ = u32();
                    phi_1871_ = u32();
                    phi_1873_ = u32();
                }
                let _e1307 = phi_1868_;
                let _e1309 = phi_1871_;
                let _e1311 = phi_1873_;
                continue;
                continuing {
                    phi_1867_ = _e1307;
                    phi_1870_ = _e1309;
                    phi_1872_ = _e1311;
                    break if !(_e812);
                }
            }
            let _e1314 = local_1;
            if _e1314 {
                let _e1316 = local_2;
                let _e1317 = (_e1316 & 2147483647u);
                let _e1319 = (_e1317 >> bitcast<u32>(2i));
                if (_e1319 >= _e109) {
                    phi_2955_ = SlimbvhTypeN(SlimbvhTypeM(vec4<f32>(0f, 0f, 0f, 0f), 0u), 0u, 0u);
                } else {
                    let _e1326 = slimbvh_nodes.member[_e1319].member[select(_e698, 2u, (2u < _e698))];
                    let _e1337 = slimbvh_nodes.member[_e1319].member[select(_e699, 2u, (2u < _e699))];
                    let _e1348 = slimbvh_nodes.member[_e1319].member[select(_e700, 2u, (2u < _e700))];
                    let _e1354 = (_e1317 & 3u);
                    let _e1357 = (((8u * _e1354) & 31u) & 31u);
                    let _e1365 = ((_e1326.w & 31u) & 31u);
                    let _e1367 = (((_e1326.y >> bitcast<u32>(_e1357)) & 255u) << bitcast<u32>(_e1365));
                    let _e1381 = ((_e1337.w & 31u) & 31u);
                    let _e1383 = (((_e1337.y >> bitcast<u32>(_e1357)) & 255u) << bitcast<u32>(_e1381));
                    let _e1397 = ((_e1348.w & 31u) & 31u);
                    let _e1399 = (((_e1348.y >> bitcast<u32>(_e1357)) & 255u) << bitcast<u32>(_e1397));
                    let _e1407 = (((((_e1326.w >> bitcast<u32>(5u)) - (((_e1326.z >> bitcast<u32>(_e1357)) & 255u) << bitcast<u32>(_e1365))) - _e1367) | (((_e1337.w >> bitcast<u32>(5u)) - (((_e1337.z >> bitcast<u32>(_e1357)) & 255u) << bitcast<u32>(_e1381))) - _e1383)) | (((_e1348.w >> bitcast<u32>(5u)) - (((_e1348.z >> bitcast<u32>(_e1357)) & 255u) << bitcast<u32>(_e1397))) - _e1399));
                    if (_e1407 < 1024u) {
                        phi_2891_ = 0u;
                    } else {
                        phi_2891_ = select(2u, 1u, (_e1407 < 2097152u));
                    }
                    let _e1412 = phi_2891_;
                    let _e1427 = slimbvh_nodes.member[_e1319].member_1[_e1354];
                    if ((_e1427 & 2147483648u) != 0u) {
                        phi_2952_ = ((_e1427 >> bitcast<u32>(28u)) & 7u);
                    } else {
                        phi_2952_ = 0u;
                    }
                    let _e1434 = phi_2952_;
                    phi_2955_ = SlimbvhTypeN(SlimbvhTypeM(vec4<f32>((bitcast<f32>(_e1326.x) + (f32(_e1367) * _e158)), (bitcast<f32>(_e1337.x) + (f32(_e1383) * _e158)), (bitcast<f32>(_e1348.x) + (f32(_e1399) * _e158)), 0f), _e1412), (_e1427 & 268435455u), _e1434);
                }
                let _e1438 = phi_2955_;
                let _e1440 = (_e1438.member_1 + _e164);
                phi_2962_ = _e792;
                phi_2965_ = SlimbvhTypeD(0u, _e1438.member_2);
                loop {
                    let _e1445 = phi_2962_;
                    let _e1447 = phi_2965_;
                    local_5 = _e1445;
                    local_7 = _e1445;
                    if (_e1447.member < _e1447.member_1) {
                        phi_2966_ = SlimbvhTypeD((_e1447.member + 1u), _e1447.member_1);
                        phi_2988_ = SlimbvhTypeD(1u, _e1447.member);
                    } else {
                        phi_2966_ = _e1447;
                        phi_2988_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                    }
                    let _e1460 = phi_2966_;
                    let _e1462 = phi_2988_;
                    let _e1466 = (bitcast<i32>(_e1462.member) != 0i);
                    if _e1466 {
                        switch bitcast<i32>(_e1438.member.member_1) {
                            case 0: {
                                phi_3003_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_3003_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_3003_ = 3u;
                                break;
                            }
                            default: {
                                phi_3003_ = u32();
                                break;
                            }
                        }
                        let _e1470 = phi_3003_;
                        switch bitcast<i32>(_e1438.member.member_1) {
                            case 0: {
                                phi_3014_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_3014_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_3014_ = 3u;
                                break;
                            }
                            default: {
                                phi_3014_ = u32();
                                break;
                            }
                        }
                        let _e1477 = phi_3014_;
                        let _e1479 = ((_e1440 + (_e1462.member_1 * ((3u * _e1470) + 1u))) + (3u * _e1477));
                        if (_e1479 < _e112) {
                            let _e1482 = slimbvh_triangles.member[_e1479];
                            phi_3030_ = _e1482;
                        } else {
                            phi_3030_ = 4294967295u;
                        }
                        let _e1484 = phi_3030_;
                        switch bitcast<i32>(_e1438.member.member_1) {
                            case 0: {
                                phi_3043_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_3043_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_3043_ = 3u;
                                break;
                            }
                            default: {
                                phi_3043_ = u32();
                                break;
                            }
                        }
                        let _e1487 = phi_3043_;
                        let _e1491 = (_e1440 + (_e1462.member_1 * ((3u * _e1487) + 1u)));
                        switch bitcast<i32>(_e1438.member.member_1) {
                            case 0: {
                                phi_3054_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_3054_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_3054_ = 3u;
                                break;
                            }
                            default: {
                                phi_3054_ = u32();
                                break;
                            }
                        }
                        let _e1494 = phi_3054_;
                        let _e1495 = (_e1491 + _e1494);
                        let _e1497 = (_e1491 + (2u * _e1494));
                        switch bitcast<i32>(_e1438.member.member_1) {
                            case 0: {
                                if (_e1491 < _e112) {
                                    let _e1774 = slimbvh_triangles.member[_e1491];
                                    phi_3081_ = _e1774;
                                } else {
                                    phi_3081_ = 0u;
                                }
                                let _e1776 = phi_3081_;
                                let _e1779 = ((10u * _e224) & 31u);
                                let _e1790 = ((10u * _e228) & 31u);
                                let _e1801 = ((10u * _e220) & 31u);
                                if (_e1495 < _e112) {
                                    let _e1813 = slimbvh_triangles.member[_e1495];
                                    phi_3127_ = _e1813;
                                } else {
                                    phi_3127_ = 0u;
                                }
                                let _e1815 = phi_3127_;
                                if (_e1497 < _e112) {
                                    let _e1843 = slimbvh_triangles.member[_e1497];
                                    phi_3173_ = _e1843;
                                } else {
                                    phi_3173_ = 0u;
                                }
                                let _e1845 = phi_3173_;
                                phi_3640_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1438.member.member.x + ((bitcast<f32>((1258291200u | ((_e1776 >> bitcast<u32>(_e1779)) & 1023u))) - 8388608f) * _e158)), (_e1438.member.member.y + ((bitcast<f32>((1258291200u | ((_e1776 >> bitcast<u32>(_e1790)) & 1023u))) - 8388608f) * _e158)), (_e1438.member.member.z + ((bitcast<f32>((1258291200u | ((_e1776 >> bitcast<u32>(_e1801)) & 1023u))) - 8388608f) * _e158))), array<f32, 3>((_e1438.member.member.x + ((bitcast<f32>((1258291200u | ((_e1815 >> bitcast<u32>(_e1779)) & 1023u))) - 8388608f) * _e158)), (_e1438.member.member.y + ((bitcast<f32>((1258291200u | ((_e1815 >> bitcast<u32>(_e1790)) & 1023u))) - 8388608f) * _e158)), (_e1438.member.member.z + ((bitcast<f32>((1258291200u | ((_e1815 >> bitcast<u32>(_e1801)) & 1023u))) - 8388608f) * _e158))), array<f32, 3>((_e1438.member.member.x + ((bitcast<f32>((1258291200u | ((_e1845 >> bitcast<u32>(_e1779)) & 1023u))) - 8388608f) * _e158)), (_e1438.member.member.y + ((bitcast<f32>((1258291200u | ((_e1845 >> bitcast<u32>(_e1790)) & 1023u))) - 8388608f) * _e158)), (_e1438.member.member.z + ((bitcast<f32>((1258291200u | ((_e1845 >> bitcast<u32>(_e1801)) & 1023u))) - 8388608f) * _e158))));
                                break;
                            }
                            case 1: {
                                if (_e1491 < _e112) {
                                    let _e1587 = slimbvh_triangles.member[_e1491];
                                    phi_3220_ = _e1587;
                                } else {
                                    phi_3220_ = 0u;
                                }
                                let _e1589 = phi_3220_;
                                let _e1590 = (_e1491 + 1u);
                                if (_e1590 < _e112) {
                                    let _e1593 = slimbvh_triangles.member[_e1590];
                                    phi_3233_ = _e1593;
                                } else {
                                    phi_3233_ = 0u;
                                }
                                let _e1595 = phi_3233_;
                                let _e1597 = (_e224 == 1u);
                                if _e1597 {
                                    phi_3243_ = ((_e1589 >> bitcast<u32>(21i)) | (_e1595 << bitcast<u32>(11i)));
                                } else {
                                    phi_3243_ = (_e1595 >> bitcast<u32>(10i));
                                }
                                let _e1606 = phi_3243_;
                                let _e1615 = (_e228 == 1u);
                                if _e1615 {
                                    phi_3264_ = ((_e1589 >> bitcast<u32>(21i)) | (_e1595 << bitcast<u32>(11i)));
                                } else {
                                    phi_3264_ = (_e1595 >> bitcast<u32>(10i));
                                }
                                let _e1624 = phi_3264_;
                                let _e1633 = (_e220 == 1u);
                                if _e1633 {
                                    phi_3285_ = ((_e1589 >> bitcast<u32>(21i)) | (_e1595 << bitcast<u32>(11i)));
                                } else {
                                    phi_3285_ = (_e1595 >> bitcast<u32>(10i));
                                }
                                let _e1642 = phi_3285_;
                                if (_e1495 < _e112) {
                                    let _e1653 = slimbvh_triangles.member[_e1495];
                                    phi_3312_ = _e1653;
                                } else {
                                    phi_3312_ = 0u;
                                }
                                let _e1655 = phi_3312_;
                                let _e1656 = (_e1495 + 1u);
                                if (_e1656 < _e112) {
                                    let _e1659 = slimbvh_triangles.member[_e1656];
                                    phi_3325_ = _e1659;
                                } else {
                                    phi_3325_ = 0u;
                                }
                                let _e1661 = phi_3325_;
                                if _e1597 {
                                    phi_3335_ = ((_e1655 >> bitcast<u32>(21i)) | (_e1661 << bitcast<u32>(11i)));
                                } else {
                                    phi_3335_ = (_e1661 >> bitcast<u32>(10i));
                                }
                                let _e1670 = phi_3335_;
                                if _e1615 {
                                    phi_3356_ = ((_e1655 >> bitcast<u32>(21i)) | (_e1661 << bitcast<u32>(11i)));
                                } else {
                                    phi_3356_ = (_e1661 >> bitcast<u32>(10i));
                                }
                                let _e1686 = phi_3356_;
                                if _e1633 {
                                    phi_3377_ = ((_e1655 >> bitcast<u32>(21i)) | (_e1661 << bitcast<u32>(11i)));
                                } else {
                                    phi_3377_ = (_e1661 >> bitcast<u32>(10i));
                                }
                                let _e1702 = phi_3377_;
                                if (_e1497 < _e112) {
                                    let _e1713 = slimbvh_triangles.member[_e1497];
                                    phi_3404_ = _e1713;
                                } else {
                                    phi_3404_ = 0u;
                                }
                                let _e1715 = phi_3404_;
                                let _e1716 = (_e1497 + 1u);
                                if (_e1716 < _e112) {
                                    let _e1719 = slimbvh_triangles.member[_e1716];
                                    phi_3417_ = _e1719;
                                } else {
                                    phi_3417_ = 0u;
                                }
                                let _e1721 = phi_3417_;
                                if _e1597 {
                                    phi_3427_ = ((_e1715 >> bitcast<u32>(21i)) | (_e1721 << bitcast<u32>(11i)));
                                } else {
                                    phi_3427_ = (_e1721 >> bitcast<u32>(10i));
                                }
                                let _e1730 = phi_3427_;
                                if _e1615 {
                                    phi_3448_ = ((_e1715 >> bitcast<u32>(21i)) | (_e1721 << bitcast<u32>(11i)));
                                } else {
                                    phi_3448_ = (_e1721 >> bitcast<u32>(10i));
                                }
                                let _e1746 = phi_3448_;
                                if _e1633 {
                                    phi_3469_ = ((_e1715 >> bitcast<u32>(21i)) | (_e1721 << bitcast<u32>(11i)));
                                } else {
                                    phi_3469_ = (_e1721 >> bitcast<u32>(10i));
                                }
                                let _e1762 = phi_3469_;
                                phi_3640_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1438.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1606, _e1589, _e229) & 2097151u))) - 8388608f) * _e158)), (_e1438.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1624, _e1589, _e232) & 2097151u))) - 8388608f) * _e158)), (_e1438.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1642, _e1589, _e236) & 2097151u))) - 8388608f) * _e158))), array<f32, 3>((_e1438.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1670, _e1655, _e229) & 2097151u))) - 8388608f) * _e158)), (_e1438.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1686, _e1655, _e232) & 2097151u))) - 8388608f) * _e158)), (_e1438.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1702, _e1655, _e236) & 2097151u))) - 8388608f) * _e158))), array<f32, 3>((_e1438.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1730, _e1715, _e229) & 2097151u))) - 8388608f) * _e158)), (_e1438.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1746, _e1715, _e232) & 2097151u))) - 8388608f) * _e158)), (_e1438.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1762, _e1715, _e236) & 2097151u))) - 8388608f) * _e158))));
                                break;
                            }
                            case 2: {
                                let _e1500 = (_e1491 + _e224);
                                if (_e1500 < _e112) {
                                    let _e1503 = slimbvh_triangles.member[_e1500];
                                    phi_3498_ = _e1503;
                                } else {
                                    phi_3498_ = 0u;
                                }
                                let _e1505 = phi_3498_;
                                let _e1506 = (_e1491 + _e228);
                                if (_e1506 < _e112) {
                                    let _e1509 = slimbvh_triangles.member[_e1506];
                                    phi_3511_ = _e1509;
                                } else {
                                    phi_3511_ = 0u;
                                }
                                let _e1511 = phi_3511_;
                                let _e1512 = (_e1491 + _e220);
                                if (_e1512 < _e112) {
                                    let _e1515 = slimbvh_triangles.member[_e1512];
                                    phi_3524_ = _e1515;
                                } else {
                                    phi_3524_ = 0u;
                                }
                                let _e1517 = phi_3524_;
                                let _e1528 = (_e1495 + _e224);
                                if (_e1528 < _e112) {
                                    let _e1531 = slimbvh_triangles.member[_e1528];
                                    phi_3550_ = _e1531;
                                } else {
                                    phi_3550_ = 0u;
                                }
                                let _e1533 = phi_3550_;
                                let _e1534 = (_e1495 + _e228);
                                if (_e1534 < _e112) {
                                    let _e1537 = slimbvh_triangles.member[_e1534];
                                    phi_3563_ = _e1537;
                                } else {
                                    phi_3563_ = 0u;
                                }
                                let _e1539 = phi_3563_;
                                let _e1540 = (_e1495 + _e220);
                                if (_e1540 < _e112) {
                                    let _e1543 = slimbvh_triangles.member[_e1540];
                                    phi_3576_ = _e1543;
                                } else {
                                    phi_3576_ = 0u;
                                }
                                let _e1545 = phi_3576_;
                                let _e1556 = (_e1497 + _e224);
                                if (_e1556 < _e112) {
                                    let _e1559 = slimbvh_triangles.member[_e1556];
                                    phi_3602_ = _e1559;
                                } else {
                                    phi_3602_ = 0u;
                                }
                                let _e1561 = phi_3602_;
                                let _e1562 = (_e1497 + _e228);
                                if (_e1562 < _e112) {
                                    let _e1565 = slimbvh_triangles.member[_e1562];
                                    phi_3615_ = _e1565;
                                } else {
                                    phi_3615_ = 0u;
                                }
                                let _e1567 = phi_3615_;
                                let _e1568 = (_e1497 + _e220);
                                if (_e1568 < _e112) {
                                    let _e1571 = slimbvh_triangles.member[_e1568];
                                    phi_3628_ = _e1571;
                                } else {
                                    phi_3628_ = 0u;
                                }
                                let _e1573 = phi_3628_;
                                phi_3640_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1505)) * _e158), (f32(bitcast<i32>(_e1511)) * _e158), (f32(bitcast<i32>(_e1517)) * _e158)), array<f32, 3>((f32(bitcast<i32>(_e1533)) * _e158), (f32(bitcast<i32>(_e1539)) * _e158), (f32(bitcast<i32>(_e1545)) * _e158)), array<f32, 3>((f32(bitcast<i32>(_e1561)) * _e158), (f32(bitcast<i32>(_e1567)) * _e158), (f32(bitcast<i32>(_e1573)) * _e158)));
                                break;
                            }
                            default: {
                                phi_3640_ = array<array<f32, 3>, 3>();
                                break;
                            }
                        }
                        let _e1873 = phi_3640_;
                        let _e1890 = (_e1873[0][2] - _e612.member[2]);
                        let _e1893 = (((_e1873[0][0] - _e612.member[0]) * _e667) - (_e1890 * _e635));
                        let _e1896 = (((_e1873[0][1] - _e612.member[1]) * _e667) - (_e1890 * _e651));
                        let _e1899 = (_e1873[1][2] - _e612.member[2]);
                        let _e1902 = (((_e1873[1][0] - _e612.member[0]) * _e667) - (_e1899 * _e635));
                        let _e1905 = (((_e1873[1][1] - _e612.member[1]) * _e667) - (_e1899 * _e651));
                        let _e1908 = (_e1873[2][2] - _e612.member[2]);
                        let _e1911 = (((_e1873[2][0] - _e612.member[0]) * _e667) - (_e1908 * _e635));
                        let _e1914 = (((_e1873[2][1] - _e612.member[1]) * _e667) - (_e1908 * _e651));
                        let _e1915 = (_e1911 * _e1905);
                        let _e1916 = (_e1914 * _e1902);
                        let _e1917 = (_e1893 * _e1914);
                        let _e1918 = (_e1896 * _e1911);
                        let _e1919 = (_e1902 * _e1896);
                        let _e1920 = (_e1905 * _e1893);
                        let _e1925 = (((_e1915 >= _e1916) && (_e1917 >= _e1918)) && (_e1919 >= _e1920));
                        let _e1931 = (_e1925 || (((_e1915 <= _e1916) && (_e1917 <= _e1918)) && (_e1919 <= _e1920)));
                        if _e1931 {
                            let _e1933 = select(-1f, 1f, _e1925);
                            let _e1935 = ((_e1915 - _e1916) * _e1933);
                            let _e1937 = select(0f, _e1935, (_e1935 > 0f));
                            let _e1939 = ((_e1917 - _e1918) * _e1933);
                            let _e1941 = select(0f, _e1939, (_e1939 > 0f));
                            let _e1943 = ((_e1919 - _e1920) * _e1933);
                            let _e1945 = select(0f, _e1943, (_e1943 > 0f));
                            let _e1947 = ((_e1937 + _e1941) + _e1945);
                            let _e1962 = ((min(min(_e1873[0][0], _e1873[1][0]), _e1873[2][0]) - _e636) * _e639);
                            let _e1963 = ((max(max(_e1873[0][0], _e1873[1][0]), _e1873[2][0]) - _e637) * _e639);
                            let _e1964 = vec4<f32>(_e1962, f32(), _e1963, f32());
                            let _e1967 = ((min(min(_e1873[0][1], _e1873[1][1]), _e1873[2][1]) - _e652) * _e655);
                            let _e1968 = ((max(max(_e1873[0][1], _e1873[1][1]), _e1873[2][1]) - _e653) * _e655);
                            let _e1969 = vec4<f32>(_e1967, f32(), _e1968, f32());
                            let _e1972 = ((min(min(_e1873[0][2], _e1873[1][2]), _e1873[2][2]) - _e668) * _e671);
                            let _e1973 = ((max(max(_e1873[0][2], _e1873[1][2]), _e1873[2][2]) - _e669) * _e671);
                            let _e1974 = vec4<f32>(_e1972, f32(), _e1973, f32());
                            let _e1975 = vec4<f32>(_e1963, f32(), _e1962, f32());
                            let _e1977 = vec4<f32>(_e1968, f32(), _e1967, f32());
                            let _e1979 = vec4<f32>(_e1973, f32(), _e1972, f32());
                            let _e1988 = max(max(min(_e1964, _e1975).x, min(_e1969, _e1977).x), min(_e1974, _e1979).x);
                            let _e1993 = min(min(max(_e1964, _e1975).x, max(_e1969, _e1977).x), max(_e1974, _e1979).x);
                            let _e1998 = max(_e1988, _e679);
                            let _e2020 = (((((_e1931 && (_e1947 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1893, _e1902), _e1911) <= 0f) && (max(max(_e1893, _e1902), _e1911) >= 0f))) && ((min(min(_e1896, _e1905), _e1914) <= 0f) && (max(max(_e1896, _e1905), _e1914) >= 0f))) && (_e1998 <= (_e1993 + (max(max(_e1974, _e1979).x, -(min(_e1974, _e1979).x)) * 0.0000019073523f)))) && (_e1998 <= _e1445.member.member_1));
                            if _e2020 {
                                let _e2025 = (_e1873[1][0] - _e1873[0][0]);
                                let _e2026 = (_e1873[1][1] - _e1873[0][1]);
                                let _e2027 = (_e1873[1][2] - _e1873[0][2]);
                                let _e2028 = vec3<f32>(_e2025, _e2026, _e2027);
                                let _e2029 = (_e1873[2][0] - _e1873[1][0]);
                                let _e2030 = (_e1873[2][1] - _e1873[1][1]);
                                let _e2031 = (_e1873[2][2] - _e1873[1][2]);
                                let _e2032 = vec3<f32>(_e2029, _e2030, _e2031);
                                let _e2033 = (_e1873[0][0] - _e1873[2][0]);
                                let _e2034 = (_e1873[0][1] - _e1873[2][1]);
                                let _e2035 = (_e1873[0][2] - _e1873[2][2]);
                                let _e2036 = vec3<f32>(_e2033, _e2034, _e2035);
                                let _e2047 = max(max(bitcast<f32>((bitcast<u32>(_e2025) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2026) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2027) & 2147483647u)));
                                let _e2058 = max(max(bitcast<f32>((bitcast<u32>(_e2029) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2030) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2031) & 2147483647u)));
                                let _e2071 = max(max(_e2047, _e2058), max(max(bitcast<f32>((bitcast<u32>(_e2033) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2034) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2035) & 2147483647u))));
                                if (_e2047 == _e2071) {
                                    phi_4005_ = _e1905;
                                    phi_4006_ = _e1902;
                                    phi_4007_ = _e1896;
                                    phi_4008_ = _e1893;
                                    phi_4009_ = vec3<f32>(_e1873[0][0], _e1873[0][1], _e1873[0][2]);
                                    phi_4010_ = _e2036;
                                    phi_4011_ = _e2032;
                                    phi_4012_ = _e2028;
                                } else {
                                    let _e2073 = (_e2058 == _e2071);
                                    let _e2078 = vec3(_e2073);
                                    phi_4005_ = select(_e1896, _e1914, _e2073);
                                    phi_4006_ = select(_e1893, _e1911, _e2073);
                                    phi_4007_ = select(_e1914, _e1905, _e2073);
                                    phi_4008_ = select(_e1911, _e1902, _e2073);
                                    phi_4009_ = select(vec3<f32>(_e1873[2][0], _e1873[2][1], _e1873[2][2]), vec3<f32>(_e1873[1][0], _e1873[1][1], _e1873[1][2]), _e2078);
                                    phi_4010_ = select(_e2032, _e2028, _e2078);
                                    phi_4011_ = select(_e2028, _e2036, _e2078);
                                    phi_4012_ = select(_e2036, _e2032, _e2078);
                                }
                                let _e2084 = phi_4005_;
                                let _e2086 = phi_4006_;
                                let _e2088 = phi_4007_;
                                let _e2090 = phi_4008_;
                                let _e2092 = phi_4009_;
                                let _e2094 = phi_4010_;
                                let _e2096 = phi_4011_;
                                let _e2098 = phi_4012_;
                                let _e2105 = ((_e2096.y * _e2094.z) - (_e2094.y * _e2096.z));
                                let _e2110 = ((_e2096.z * _e2094.x) - (_e2094.z * _e2096.x));
                                let _e2113 = ((_e2096.x * _e2094.y) - (_e2094.x * _e2096.y));
                                let _e2116 = ((_e1937 >= _e1941) && (_e1937 >= _e1945));
                                let _e2117 = (_e1941 >= _e1945);
                                let _e2131 = (((_e2105 * (select(select(_e1873[2][0], _e1873[1][0], _e2117), _e1873[0][0], _e2116) - _e612.member[0])) + (_e2110 * (select(select(_e1873[2][1], _e1873[1][1], _e2117), _e1873[0][1], _e2116) - _e612.member[1]))) + (_e2113 * (select(select(_e1873[2][2], _e1873[1][2], _e2117), _e1873[0][2], _e2116) - _e612.member[2])));
                                let _e2136 = (((_e2105 * _e635) + (_e2110 * _e651)) + (_e2113 * _e667));
                                let _e2137 = (_e2086 - _e2090);
                                let _e2138 = (_e2084 - _e2088);
                                let _e2141 = ((_e2137 * _e2137) + (_e2138 * _e2138));
                                let _e2148 = (-(((_e2090 * _e2137) + (_e2088 * _e2138))) / select(0.000000000000000000000000000000000000011754944f, _e2141, (_e2141 > 0.000000000000000000000000000000000000011754944f)));
                                let _e2150 = select(1f, _e2148, (_e2148 < 1f));
                                let _e2152 = select(0f, _e2150, (_e2150 > 0f));
                                let _e2161 = ((_e2092.x + (_e2098.x * _e2152)) - _e612.member[0]);
                                let _e2164 = ((_e2092.y + (_e2098.y * _e2152)) - _e612.member[1]);
                                let _e2167 = ((_e2092.z + (_e2098.z * _e2152)) - _e612.member[2]);
                                let _e2232 = ((bitcast<f32>((bitcast<u32>(((((_e2105 * _e2161) + (_e2110 * _e2164)) + (_e2113 * _e2167)) - _e2131)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e2161) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2164) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2167) & 2147483647u))), _e2071)) * max(max(bitcast<f32>((bitcast<u32>(_e2105) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2110) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2113) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e2136) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e2096.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2096.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2096.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e2094.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2094.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2094.z) & 2147483647u)))))));
                                let _e2233 = (_e2131 / _e2136);
                                if (_e2020 && !(_e2232)) {
                                    let _e2236 = (_e2167 / _e667);
                                    let _e2244 = (((_e2105 * (_e2161 - (_e635 * _e2236))) + (_e2110 * (_e2164 - (_e651 * _e2236)))) / _e2136);
                                    phi_4191_ = select(select(_e2236, (_e2236 + _e2244), (bitcast<f32>((bitcast<u32>(_e2244) & 2147483647u)) <= _e2071)), _e2233, _e2232);
                                } else {
                                    phi_4191_ = _e2233;
                                }
                                let _e2253 = phi_4191_;
                                let _e2255 = select(_e1993, _e2253, (_e2253 < _e1993));
                                let _e2257 = select(_e1988, _e2255, (_e2255 > _e1988));
                                let _e2260 = select(_e2257, 0f, (bitcast<u32>(_e2257) == 2147483648u));
                                let _e2261 = (1f / _e1947);
                                phi_4217_ = SlimbvhTypeE(_e2260, (_e1941 * _e2261), (_e1945 * _e2261), ((_e2020 && (_e2260 >= _e679)) && (_e2260 <= _e1445.member.member_1)));
                                phi_4218_ = SlimbvhTypeE();
                            } else {
                                phi_4217_ = SlimbvhTypeE();
                                phi_4218_ = SlimbvhTypeE(0f, 0f, 0f, _e2020);
                            }
                            let _e2270 = phi_4217_;
                            let _e2272 = phi_4218_;
                            phi_4221_ = _e2270;
                            phi_4222_ = _e2272;
                            phi_4223_ = select(true, false, _e2020);
                        } else {
                            phi_4221_ = SlimbvhTypeE();
                            phi_4222_ = SlimbvhTypeE(0f, 0f, 0f, _e1931);
                            phi_4223_ = true;
                        }
                        let _e2275 = phi_4221_;
                        let _e2277 = phi_4222_;
                        let _e2279 = phi_4223_;
                        if _e2279 {
                            phi_4227_ = _e2277;
                        } else {
                            phi_4227_ = _e2275;
                        }
                        let _e2281 = phi_4227_;
                        if _e2281.member_3 {
                            phi_4236_ = SlimbvhTypeF(_e2281.member, _e2281.member_1, _e2281.member_2, _e1484);
                        } else {
                            phi_4236_ = _e105;
                        }
                        let _e2288 = phi_4236_;
                        if (_e2288.member_3 != 4294967295u) {
                            let _e2294 = slimbvh_target.member[0u][0u];
                            let _e2298 = slimbvh_target.member[0u][1u];
                            let _e2302 = slimbvh_target.member[0u][2u];
                            let _e2306 = slimbvh_target.member[0u][3u];
                            let _e2310 = slimbvh_target.member[1u][0u];
                            let _e2314 = slimbvh_target.member[1u][1u];
                            let _e2318 = slimbvh_target.member[1u][2u];
                            let _e2322 = slimbvh_target.member[1u][3u];
                            let _e2323 = bitcast<f32>(_e2294);
                            let _e2324 = bitcast<f32>(_e2298);
                            let _e2325 = bitcast<f32>(_e2302);
                            let _e2327 = bitcast<f32>(_e2310);
                            let _e2328 = array<u32, 3>(_e2314, _e2318, _e2322);
                            if (_e182 < -126i) {
                                phi_4289_ = -126i;
                            } else {
                                phi_4289_ = select(_e182, 127i, (_e182 > 127i));
                            }
                            let _e2334 = phi_4289_;
                            let _e2339 = bitcast<f32>((bitcast<u32>((_e2334 + 127i)) << bitcast<u32>(23i)));
                            let _e2345 = bitcast<f32>((bitcast<u32>(((_e182 - _e2334) + 127i)) << bitcast<u32>(23i)));
                            if (_e2306 == 0u) {
                                phi_4429_ = SlimbvhTypeH(array<f32, 3>(_e2323, _e2324, _e2325), _e2306, _e2327, _e2328);
                            } else {
                                let _e2347 = bitcast<u32>(_e2323);
                                let _e2349 = ((_e2347 & 2139095040u) != 0u);
                                let _e2364 = bitcast<u32>(_e2324);
                                let _e2366 = ((_e2364 & 2139095040u) != 0u);
                                let _e2381 = bitcast<u32>(_e2325);
                                let _e2383 = ((_e2381 & 2139095040u) != 0u);
                                let _e2399 = bitcast<u32>(_e2327);
                                let _e2401 = ((_e2399 & 2139095040u) != 0u);
                                phi_4429_ = SlimbvhTypeH(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2347 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2347 & 2147483648u))), _e2323, _e2349) * _e2339) * select(0.00000011920929f, 1f, _e2349)) * _e2345), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2364 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2364 & 2147483648u))), _e2324, _e2366) * _e2339) * select(0.00000011920929f, 1f, _e2366)) * _e2345), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2381 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2381 & 2147483648u))), _e2325, _e2383) * _e2339) * select(0.00000011920929f, 1f, _e2383)) * _e2345)), _e2306, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2399 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2399 & 2147483648u))), _e2327, _e2401) * _e2339) * select(0.00000011920929f, 1f, _e2401)) * _e2345), _e2328);
                            }
                            let _e2418 = phi_4429_;
                            if (_e1484 == _e683) {
                                phi_4758_ = false;
                            } else {
                                let _e2420 = (_e1484 / 16u);
                                if (_e2420 < arrayLength((&slimbvh_sides.member))) {
                                    let _e2423 = slimbvh_sides.member[_e2420];
                                    phi_4453_ = _e2423;
                                } else {
                                    phi_4453_ = 0u;
                                }
                                let _e2425 = phi_4453_;
                                let _e2434 = (bitcast<i32>((_e2425 << bitcast<u32>(((30u - ((_e1484 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                let _e2435 = (_e2434 == 0i);
                                if _e2435 {
                                    phi_4757_ = true;
                                } else {
                                    if _e229 {
                                        phi_4483_ = vec3<f32>(_e1873[0][0], _e1873[0][1], _e1873[0][2]);
                                    } else {
                                        if (_e224 == 1u) {
                                            phi_4482_ = vec3<f32>(_e1873[0][2], _e1873[0][0], _e1873[0][1]);
                                        } else {
                                            phi_4482_ = vec3<f32>(_e1873[0][1], _e1873[0][2], _e1873[0][0]);
                                        }
                                        let _e2440 = phi_4482_;
                                        phi_4483_ = _e2440;
                                    }
                                    let _e2443 = phi_4483_;
                                    if _e229 {
                                        phi_4502_ = vec3<f32>(_e1873[1][0], _e1873[1][1], _e1873[1][2]);
                                    } else {
                                        if (_e224 == 1u) {
                                            phi_4501_ = vec3<f32>(_e1873[1][2], _e1873[1][0], _e1873[1][1]);
                                        } else {
                                            phi_4501_ = vec3<f32>(_e1873[1][1], _e1873[1][2], _e1873[1][0]);
                                        }
                                        let _e2448 = phi_4501_;
                                        phi_4502_ = _e2448;
                                    }
                                    let _e2451 = phi_4502_;
                                    if _e229 {
                                        phi_4521_ = vec3<f32>(_e1873[2][0], _e1873[2][1], _e1873[2][2]);
                                    } else {
                                        if (_e224 == 1u) {
                                            phi_4520_ = vec3<f32>(_e1873[2][2], _e1873[2][0], _e1873[2][1]);
                                        } else {
                                            phi_4520_ = vec3<f32>(_e1873[2][1], _e1873[2][2], _e1873[2][0]);
                                        }
                                        let _e2456 = phi_4520_;
                                        phi_4521_ = _e2456;
                                    }
                                    let _e2459 = phi_4521_;
                                    let _e2462 = (_e2451.x - _e2443.x);
                                    let _e2465 = (_e2451.y - _e2443.y);
                                    let _e2468 = (_e2451.z - _e2443.z);
                                    let _e2470 = (_e2459.x - _e2443.x);
                                    let _e2472 = (_e2459.y - _e2443.y);
                                    let _e2474 = (_e2459.z - _e2443.z);
                                    if (_e2418.member_1 == 1u) {
                                        phi_4557_ = (vec3<f32>(_e2418.member[0], _e2418.member[1], _e2418.member[2]) - _e2443);
                                    } else {
                                        phi_4557_ = vec3<f32>(_e2418.member[0], _e2418.member[1], _e2418.member[2]);
                                    }
                                    let _e2489 = phi_4557_;
                                    let _e2495 = bitcast<f32>((bitcast<u32>((_e2462 * _e2472)) ^ _e2418.member_3[0]));
                                    let _e2499 = bitcast<f32>((bitcast<u32>((_e2465 * _e2470)) ^ _e2418.member_3[0]));
                                    let _e2503 = bitcast<f32>((bitcast<u32>((_e2465 * _e2474)) ^ _e2418.member_3[0]));
                                    let _e2507 = bitcast<f32>((bitcast<u32>((_e2468 * _e2472)) ^ _e2418.member_3[0]));
                                    let _e2511 = bitcast<f32>((bitcast<u32>((_e2468 * _e2470)) ^ _e2418.member_3[0]));
                                    let _e2515 = bitcast<f32>((bitcast<u32>((_e2462 * _e2474)) ^ _e2418.member_3[0]));
                                    let _e2516 = (_e2503 - _e2507);
                                    let _e2517 = (_e2511 - _e2515);
                                    let _e2518 = (_e2495 - _e2499);
                                    let _e2542 = (bitcast<f32>((bitcast<u32>(_e2503) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2507) & 2147483647u)));
                                    let _e2549 = (bitcast<f32>((bitcast<u32>(_e2511) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2515) & 2147483647u)));
                                    let _e2556 = (bitcast<f32>((bitcast<u32>(_e2495) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2499) & 2147483647u)));
                                    if (_e2418.member_2 == 0f) {
                                        phi_4739_ = 0f;
                                    } else {
                                        let _e2586 = bitcast<f32>((bitcast<u32>(_e2516) & 2147483647u));
                                        let _e2589 = bitcast<f32>((bitcast<u32>(_e2517) & 2147483647u));
                                        let _e2592 = bitcast<f32>((bitcast<u32>(_e2518) & 2147483647u));
                                        let _e2594 = select(_e2592, _e2589, (_e2589 > _e2592));
                                        let _e2598 = select(_e2592, _e2589, (_e2589 < _e2592));
                                        let _e2602 = select(_e2589, _e2586, (_e2586 < _e2589));
                                        let _e2604 = select(_e2589, _e2586, (_e2586 > _e2589));
                                        let _e2606 = select(_e2592, _e2604, (_e2604 < _e2592));
                                        phi_4739_ = bitcast<f32>((bitcast<u32>((_e2418.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2594, _e2586, (_e2586 > _e2594)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2606, _e2602, (_e2602 > _e2606)))) ^ _e2418.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2598, _e2586, (_e2586 < _e2598)))) ^ _e2418.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2542 + _e2549) + _e2556))) ^ _e2418.member_3[0]))) * 1.0000005f)) ^ _e2418.member_3[0])))) ^ _e2418.member_3[0]));
                                    }
                                    let _e2633 = phi_4739_;
                                    phi_4757_ = (_e2435 || !(((((bitcast<f32>((bitcast<u32>((_e2489.x * _e2516)) ^ _e2418.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2489.y * _e2517)) ^ _e2418.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2489.z * _e2518)) ^ _e2418.member_3[0]))) * f32(-(_e2434))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2489.x) & 2147483647u)) * _e2542)) ^ _e2418.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2489.y) & 2147483647u)) * _e2549)) ^ _e2418.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2489.z) & 2147483647u)) * _e2556)) ^ _e2418.member_3[0]))))) ^ _e2418.member_3[0])) + _e2633) + 0.0000000000000000000000000000000000001880791f))));
                                }
                                let _e2647 = phi_4757_;
                                phi_4758_ = _e2647;
                            }
                            let _e2649 = phi_4758_;
                            if _e2649 {
                                if (_e2288.member < _e1445.member.member.member) {
                                    phi_4778_ = true;
                                } else {
                                    if (_e2288.member == _e1445.member.member.member) {
                                        phi_4777_ = (_e2288.member_3 < _e1445.member.member.member_3);
                                    } else {
                                        phi_4777_ = false;
                                    }
                                    let _e2661 = phi_4777_;
                                    phi_4778_ = _e2661;
                                }
                                let _e2663 = phi_4778_;
                                if _e2663 {
                                    phi_4785_ = SlimbvhTypeQ(SlimbvhTypeI(_e2288, _e2288.member), _e1445.member_1);
                                } else {
                                    phi_4785_ = _e1445;
                                }
                                let _e2669 = phi_4785_;
                                if _e2669.member_1 {
                                    phi_4791_ = SlimbvhTypeQ(SlimbvhTypeI(_e2669.member.member, bitcast<f32>(4286578687u)), _e2669.member_1);
                                } else {
                                    phi_4791_ = _e2669;
                                }
                                let _e2678 = phi_4791_;
                                phi_4792_ = _e2678;
                            } else {
                                phi_4792_ = _e1445;
                            }
                            let _e2680 = phi_4792_;
                            phi_4793_ = _e2680;
                        } else {
                            phi_4793_ = _e1445;
                        }
                        let _e2682 = phi_4793_;
                        phi_2963_ = _e2682;
                    } else {
                        phi_2963_ = SlimbvhTypeQ();
                    }
                    let _e2684 = phi_2963_;
                    continue;
                    continuing {
                        phi_2962_ = _e2684;
                        phi_2965_ = _e1460;
                        break if !(_e1466);
                    }
                }
                let _e2687 = local_3;
                let _e2688 = (_e2687 - 1u);
                let _e2691 = local[(_e2688 % 128u)];
                let _e2692 = (_e2691 & 511u);
                let _e2694 = (_e2692 >> bitcast<u32>(3u));
                let _e2697 = ((_e2694 == 0u) || (_e2688 == 4294967295u));
                if _e2697 {
                } else {
                    local[(_e2688 % 128u)] = (((_e2691 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2694);
                }
                let _e2704 = local_4;
                let _e2712 = (((_e2691 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2692 & 3u) & 3u));
                let _e2714 = (_e2712 >> bitcast<u32>(2i));
                if (_e2714 < _e109) {
                    let _e2720 = slimbvh_nodes.member[_e2714].member_1[(_e2712 & 3u)];
                    if ((_e2720 & 2147483648u) != 0u) {
                        phi_4858_ = (2147483648u | _e2712);
                    } else {
                        phi_4858_ = _e2720;
                    }
                    let _e2725 = phi_4858_;
                    phi_4859_ = _e2725;
                } else {
                    phi_4859_ = 4294967295u;
                }
                let _e2727 = phi_4859_;
                let _e2729 = local_5;
                let _e3028 = local_7;
                phi_4868_ = _e3028;
                phi_4869_ = select(select(_e2704, _e2688, _e2697), 4294967295u, (_e679 > _e2729.member.member_1));
                phi_4870_ = _e2727;
            } else {
                phi_4868_ = _e792;
                let _e3031 = local_8;
                phi_4869_ = _e3031;
                let _e3034 = local_9;
                phi_4870_ = _e3034;
            }
            let _e2735 = phi_4868_;
            let _e2737 = phi_4869_;
            let _e2739 = phi_4870_;
            phi_1852_ = _e2735;
            phi_1855_ = _e2737;
            phi_1857_ = _e2739;
            let _e3040 = local_10;
            phi_1859_ = _e3040;
        } else {
            phi_1852_ = SlimbvhTypeQ();
            phi_1855_ = u32();
            phi_1857_ = u32();
            phi_1859_ = u32();
        }
        let _e2741 = phi_1852_;
        let _e2743 = phi_1855_;
        let _e2745 = phi_1857_;
        let _e2747 = phi_1859_;
        continue;
        continuing {
            phi_1851_ = _e2741;
            phi_1854_ = _e2743;
            phi_1856_ = _e2745;
            phi_1858_ = _e2747;
            break if !(_e799);
        }
    }
    let _e2750 = local_6;
    if (_e2750.member.member.member_3 != 4294967295u) {
        let _e2756 = -((_e182 + _e612.member_4));
        let _e2757 = bitcast<u32>(_e2750.member.member.member);
        let _e2761 = (bitcast<i32>((_e2757 >> bitcast<u32>(23i))) & 255i);
        let _e2762 = (_e2761 + _e2756);
        if (_e2761 == 255i) {
            phi_4927_ = _e2750.member.member.member;
        } else {
            if (_e2761 > 0i) {
                if (_e2762 > 0i) {
                    let _e2766 = (_e2762 < 255i);
                    if _e2766 {
                        phi_4906_ = bitcast<f32>((_e2757 + bitcast<u32>((_e2756 << bitcast<u32>(23i)))));
                    } else {
                        phi_4906_ = f32();
                    }
                    let _e2773 = phi_4906_;
                    phi_4908_ = _e2773;
                    phi_4909_ = select(true, false, _e2766);
                } else {
                    phi_4908_ = f32();
                    phi_4909_ = true;
                }
                let _e2776 = phi_4908_;
                let _e2778 = phi_4909_;
                phi_4910_ = _e2776;
                phi_4911_ = _e2778;
            } else {
                phi_4910_ = f32();
                phi_4911_ = true;
            }
            let _e2780 = phi_4910_;
            let _e2782 = phi_4911_;
            if _e2782 {
                let _e2783 = (_e2757 & 2147483648u);
                let _e2790 = ((_e2757 & 8388607u) | (select(0u, 1u, ((_e2757 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e2794 = (_e2790 == 0u);
                if _e2794 {
                    phi_5587_ = bitcast<f32>(_e2783);
                } else {
                    let _e2799 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2790)), 32u, _e2794) - 8u);
                    let _e2802 = (_e2790 << bitcast<u32>((_e2799 & 31u)));
                    let _e2804 = ((_e2762 + select(0i, 1i, (_e2761 == 0i))) - bitcast<i32>(_e2799));
                    if (_e2804 >= 255i) {
                        phi_5577_ = bitcast<f32>((_e2783 | 2139095040u));
                        phi_5578_ = f32();
                        phi_5579_ = true;
                    } else {
                        let _e2806 = (_e2804 > 0i);
                        if _e2806 {
                            phi_5571_ = bitcast<f32>(((_e2783 | (bitcast<u32>(_e2804) << bitcast<u32>(23i))) | (_e2802 & 8388607u)));
                            phi_5572_ = f32();
                        } else {
                            if (_e2804 < -24i) {
                                phi_5537_ = 26u;
                            } else {
                                phi_5537_ = bitcast<u32>((1i - _e2804));
                            }
                            let _e2811 = phi_5537_;
                            let _e2812 = (_e2811 & 31u);
                            let _e2814 = (_e2802 >> bitcast<u32>(_e2812));
                            let _e2818 = (_e2802 & ((1u << bitcast<u32>(_e2812)) - 1u));
                            let _e2822 = (1u << bitcast<u32>(((_e2811 - 1u) & 31u)));
                            if (_e2818 > _e2822) {
                                phi_5558_ = true;
                            } else {
                                if (_e2818 == _e2822) {
                                    phi_5555_ = ((_e2814 & 1u) == 1u);
                                } else {
                                    phi_5555_ = false;
                                }
                                let _e2828 = phi_5555_;
                                phi_5558_ = _e2828;
                            }
                            let _e2830 = phi_5558_;
                            phi_5571_ = f32();
                            phi_5572_ = bitcast<f32>((_e2783 | (_e2814 + select(0u, 1u, _e2830))));
                        }
                        let _e2843 = phi_5571_;
                        let _e2845 = phi_5572_;
                        phi_5577_ = _e2843;
                        phi_5578_ = _e2845;
                        phi_5579_ = _e2806;
                    }
                    let _e2849 = phi_5577_;
                    let _e2851 = phi_5578_;
                    let _e2853 = phi_5579_;
                    phi_5587_ = select(_e2851, _e2849, _e2853);
                }
                let _e2857 = phi_5587_;
                phi_4926_ = _e2857;
            } else {
                phi_4926_ = _e2780;
            }
            let _e2859 = phi_4926_;
            phi_4927_ = _e2859;
        }
        let _e2861 = phi_4927_;
        let _e2862 = bitcast<u32>(_e2861);
        if ((_e2862 & 2147483647u) >= 2139095040u) {
            phi_4939_ = bitcast<f32>(((_e2862 & 2147483648u) | 2139095039u));
        } else {
            phi_4939_ = _e2861;
        }
        let _e2869 = phi_4939_;
        phi_4944_ = SlimbvhTypeF(_e2869, _e2750.member.member.member_1, _e2750.member.member.member_2, _e2750.member.member.member_3);
    } else {
        phi_4944_ = _e105;
    }
    let _e2874 = phi_4944_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2874.member), bitcast<u32>(_e2874.member_1), bitcast<u32>(_e2874.member_2), _e2874.member_3);
    return;
}

struct SlimbvhTypeR {
    member: array<vec4<f32>, 3>,
}

struct SlimbvhTypeS {
    member: vec2<f32>,
}

struct SlimbvhTypeT {
    member: array<vec4<f32>, 5>,
}

var<private> slimbvh_corners: SlimbvhTypeR;

var<private> slimbvh_weights: SlimbvhTypeS;

var<private> slimbvh_from: SlimbvhTypeO;

var<private> slimbvh_point: SlimbvhTypeT;

fn slimbvh_find_surface() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var phi_214_: i32;
    var phi_708_: i32;
    var phi_739_: i32;
    var phi_758_: vec3<f32>;
    var phi_898_: SlimbvhTypeD;
    var phi_899_: SlimbvhTypeD;
    var phi_922_: SlimbvhTypeD;
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
    phi_898_ = SlimbvhTypeD(0u, 3u);
    loop {
        let _e463 = phi_898_;
        if (_e463.member < _e463.member_1) {
            phi_899_ = SlimbvhTypeD((_e463.member + 1u), _e463.member_1);
            phi_922_ = SlimbvhTypeD(1u, _e463.member);
        } else {
            phi_899_ = _e463;
            phi_922_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
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
