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
    member: u32,
    member_1: f32,
}

struct SlimbvhTypeK {
    member: array<array<vec4<u32>, 3>>,
}

struct SlimbvhTypeL {
    member: vec4<f32>,
    member_1: u32,
}

struct SlimbvhTypeM {
    member: SlimbvhTypeL,
    member_1: u32,
    member_2: u32,
}

struct SlimbvhTypeN {
    member: vec4<f32>,
}

struct SlimbvhTypeO {
    member: vec2<u32>,
}

struct SlimbvhTypeP {
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

var<private> slimbvh_origin: SlimbvhTypeN;

var<private> slimbvh_direction: SlimbvhTypeN;

var<private> slimbvh_question: SlimbvhTypeO;

var<private> slimbvh_hit: SlimbvhTypeA;

fn slimbvh_trace() {
    var local: array<u32, 128>;
    var phi_737_: u32;
    var phi_743_: u32;
    var phi_749_: u32;
    var phi_1014_: i32;
    var phi_1025_: i32;
    var phi_1139_: i32;
    var phi_1268_: i32;
    var phi_1290_: u32;
    var phi_1291_: u32;
    var phi_1292_: bool;
    var phi_1326_: i32;
    var phi_1348_: u32;
    var phi_1349_: u32;
    var phi_1350_: bool;
    var phi_911_: i32;
    var phi_917_: u32;
    var phi_936_: u32;
    var phi_937_: u32;
    var phi_938_: bool;
    var phi_956_: i32;
    var phi_962_: u32;
    var phi_981_: u32;
    var phi_982_: u32;
    var phi_983_: bool;
    var phi_1360_: SlimbvhTypeC;
    var phi_1599_: SlimbvhTypeP;
    var phi_1662_: array<f32, 3>;
    var phi_1663_: array<f32, 3>;
    var phi_1681_: array<f32, 3>;
    var phi_1682_: array<f32, 3>;
    var phi_1855_: SlimbvhTypeP;
    var phi_1858_: u32;
    var phi_1860_: u32;
    var phi_1862_: u32;
    var phi_1871_: u32;
    var phi_1874_: u32;
    var phi_1876_: u32;
    var phi_1978_: SlimbvhTypeJ;
    var phi_1979_: SlimbvhTypeJ;
    var phi_2038_: SlimbvhTypeJ;
    var phi_2039_: SlimbvhTypeJ;
    var phi_2098_: SlimbvhTypeJ;
    var phi_2099_: SlimbvhTypeJ;
    var phi_2589_: u32;
    var phi_2602_: u32;
    var phi_2615_: u32;
    var phi_2628_: u32;
    var phi_5346_: SlimbvhTypeD;
    var phi_5358_: SlimbvhTypeD;
    var phi_5370_: SlimbvhTypeD;
    var phi_5382_: SlimbvhTypeD;
    var phi_5394_: SlimbvhTypeD;
    var phi_2709_: u32;
    var phi_2714_: u32;
    var phi_2715_: u32;
    var phi_2769_: u32;
    var phi_2770_: u32;
    var phi_1872_: u32;
    var phi_1875_: u32;
    var phi_1877_: u32;
    var local_1: bool;
    var local_2: u32;
    var phi_2955_: u32;
    var phi_2960_: u32;
    var phi_3003_: SlimbvhTypeM;
    var phi_3007_: SlimbvhTypeP;
    var phi_3010_: SlimbvhTypeD;
    var phi_3011_: SlimbvhTypeD;
    var phi_3033_: SlimbvhTypeD;
    var phi_3061_: u32;
    var phi_3084_: u32;
    var phi_3093_: u32;
    var phi_3103_: u32;
    var phi_3562_: u32;
    var phi_3575_: u32;
    var phi_3588_: u32;
    var phi_3614_: u32;
    var phi_3627_: u32;
    var phi_3640_: u32;
    var phi_3666_: u32;
    var phi_3679_: u32;
    var phi_3692_: u32;
    var phi_3284_: u32;
    var phi_3297_: u32;
    var phi_3307_: u32;
    var phi_3328_: u32;
    var phi_3349_: u32;
    var phi_3376_: u32;
    var phi_3389_: u32;
    var phi_3399_: u32;
    var phi_3420_: u32;
    var phi_3441_: u32;
    var phi_3468_: u32;
    var phi_3481_: u32;
    var phi_3491_: u32;
    var phi_3512_: u32;
    var phi_3533_: u32;
    var phi_3145_: u32;
    var phi_3191_: u32;
    var phi_3237_: u32;
    var phi_3704_: array<array<f32, 3>, 3>;
    var phi_4069_: f32;
    var phi_4070_: f32;
    var phi_4071_: f32;
    var phi_4072_: f32;
    var phi_4073_: vec3<f32>;
    var phi_4074_: vec3<f32>;
    var phi_4075_: vec3<f32>;
    var phi_4076_: vec3<f32>;
    var phi_4255_: f32;
    var phi_4281_: SlimbvhTypeE;
    var phi_4282_: SlimbvhTypeE;
    var phi_4285_: SlimbvhTypeE;
    var phi_4286_: SlimbvhTypeE;
    var phi_4287_: bool;
    var phi_4291_: SlimbvhTypeE;
    var phi_4300_: SlimbvhTypeF;
    var phi_4353_: i32;
    var phi_4493_: SlimbvhTypeH;
    var phi_4517_: u32;
    var phi_4546_: vec3<f32>;
    var phi_4547_: vec3<f32>;
    var phi_4565_: vec3<f32>;
    var phi_4566_: vec3<f32>;
    var phi_4584_: vec3<f32>;
    var phi_4585_: vec3<f32>;
    var phi_4621_: vec3<f32>;
    var phi_4803_: f32;
    var phi_4821_: bool;
    var phi_4822_: bool;
    var phi_4841_: bool;
    var phi_4842_: bool;
    var phi_4849_: SlimbvhTypeP;
    var phi_4855_: SlimbvhTypeP;
    var phi_4856_: SlimbvhTypeP;
    var phi_4857_: SlimbvhTypeP;
    var phi_3008_: SlimbvhTypeP;
    var local_3: u32;
    var local_4: u32;
    var phi_4946_: u32;
    var phi_4947_: u32;
    var local_5: SlimbvhTypeP;
    var phi_4956_: SlimbvhTypeP;
    var phi_4957_: u32;
    var phi_4958_: u32;
    var phi_1856_: SlimbvhTypeP;
    var phi_1859_: u32;
    var phi_1861_: u32;
    var phi_1863_: u32;
    var local_6: SlimbvhTypeP;
    var phi_4994_: f32;
    var phi_4996_: f32;
    var phi_4997_: bool;
    var phi_4998_: f32;
    var phi_4999_: bool;
    var phi_5625_: u32;
    var phi_5643_: bool;
    var phi_5646_: bool;
    var phi_5659_: f32;
    var phi_5660_: f32;
    var phi_5665_: f32;
    var phi_5666_: f32;
    var phi_5667_: bool;
    var phi_5675_: f32;
    var phi_5014_: f32;
    var phi_5015_: f32;
    var phi_5027_: f32;
    var phi_5032_: SlimbvhTypeF;
    var local_7: SlimbvhTypeP;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e119 = SlimbvhTypeF(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e123 = arrayLength((&slimbvh_nodes.member));
    let _e126 = arrayLength((&slimbvh_triangles.member));
    let _e136 = slimbvh_root.member[0u][0u];
    let _e140 = slimbvh_root.member[0u][1u];
    let _e144 = slimbvh_root.member[0u][2u];
    let _e148 = slimbvh_root.member[0u][3u];
    let _e152 = slimbvh_root.member[1u][0u];
    let _e156 = slimbvh_root.member[1u][1u];
    let _e160 = slimbvh_root.member[1u][2u];
    let _e172 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e148) + 127i)) << bitcast<u32>(23i)));
    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    let _e173 = slimbvh_origin.member;
    let _e179 = slimbvh_origin.member[3u];
    let _e180 = slimbvh_direction.member;
    let _e186 = slimbvh_direction.member[3u];
    let _e189 = slimbvh_exponent.member[0u];
    let _e190 = bitcast<i32>(_e189);
    let _e192 = (bitcast<u32>(_e173.x) & 2147483647u);
    let _e194 = (bitcast<u32>(_e173.y) & 2147483647u);
    let _e196 = (bitcast<u32>(_e173.z) & 2147483647u);
    let _e197 = bitcast<u32>(_e179);
    let _e198 = (_e197 & 2147483647u);
    let _e200 = (bitcast<u32>(_e180.x) & 2147483647u);
    let _e202 = (bitcast<u32>(_e180.y) & 2147483647u);
    let _e204 = (bitcast<u32>(_e180.z) & 2147483647u);
    let _e205 = bitcast<u32>(_e186);
    let _e206 = (_e205 & 2147483647u);
    let _e208 = select(_e202, _e200, (_e202 < _e200));
    let _e210 = select(_e204, _e208, (_e204 < _e208));
    let _e212 = select(_e192, _e210, (_e192 < _e210));
    let _e214 = select(_e194, _e212, (_e194 < _e212));
    let _e216 = select(_e196, _e214, (_e196 < _e214));
    let _e223 = (((select(_e198, _e216, (_e198 < _e216)) < 2139095040u) && (_e206 <= 2139095040u)) && (_e210 > 0u));
    if (_e200 == _e210) {
        phi_737_ = 0u;
    } else {
        phi_737_ = select(2u, 1u, (_e202 == _e210));
    }
    let _e228 = phi_737_;
    let _e229 = (_e228 == 2u);
    if _e229 {
        phi_743_ = 0u;
    } else {
        phi_743_ = (_e228 + 1u);
    }
    let _e232 = phi_743_;
    let _e233 = (_e232 == 2u);
    if _e233 {
        phi_749_ = 0u;
    } else {
        phi_749_ = (_e232 + 1u);
    }
    let _e236 = phi_749_;
    let _e237 = (_e232 == 0u);
    let _e239 = select(select(_e173.y, _e173.x, _e237), _e173.z, _e233);
    let _e240 = (_e236 == 0u);
    let _e242 = (_e236 == 2u);
    let _e243 = select(select(_e173.y, _e173.x, _e240), _e173.z, _e242);
    let _e244 = (_e228 == 0u);
    let _e246 = select(select(_e173.y, _e173.x, _e244), _e173.z, _e229);
    let _e248 = select(select(_e180.y, _e180.x, _e237), _e180.z, _e233);
    let _e250 = select(select(_e180.y, _e180.x, _e240), _e180.z, _e242);
    let _e252 = select(select(_e180.y, _e180.x, _e244), _e180.z, _e229);
    let _e253 = (_e198 - 1u);
    let _e254 = (_e206 - 1u);
    let _e256 = select(_e253, _e254, (_e254 < _e253));
    let _e257 = (_e192 - 1u);
    let _e258 = (_e194 - 1u);
    let _e260 = select(_e257, _e258, (_e258 < _e257));
    let _e261 = (_e196 - 1u);
    let _e263 = select(_e260, _e261, (_e261 < _e260));
    let _e264 = (_e200 - 1u);
    let _e265 = (_e202 - 1u);
    let _e267 = select(_e264, _e265, (_e265 < _e264));
    let _e268 = (_e204 - 1u);
    let _e270 = select(_e267, _e268, (_e268 < _e267));
    let _e272 = select(_e263, _e270, (_e270 < _e263));
    if (((select(_e272, _e256, (_e256 < _e272)) >= 8388607u) && (_e210 < 2130706432u)) && (bitcast<u32>((_e190 + 126i)) <= 253u)) {
        let _e537 = bitcast<i32>((_e210 >> bitcast<u32>(23i)));
        let _e538 = (_e537 - 127i);
        let _e539 = (_e190 + _e538);
        let _e544 = bitcast<f32>((bitcast<u32>((_e190 + 127i)) << bitcast<u32>(23i)));
        let _e549 = bitcast<f32>((bitcast<u32>((254i - _e537)) << bitcast<u32>(23i)));
        if (_e198 >= 2139095040u) {
            phi_911_ = 255i;
        } else {
            phi_911_ = (bitcast<i32>((_e198 >> bitcast<u32>(23i))) + _e539);
        }
        let _e564 = phi_911_;
        if (_e198 == 0u) {
            phi_917_ = 0u;
        } else {
            phi_917_ = (_e198 | 8388608u);
        }
        let _e568 = phi_917_;
        if (_e564 <= 0i) {
            phi_937_ = u32();
            phi_938_ = true;
        } else {
            let _e575 = (_e568 == 0u);
            if _e575 {
                phi_936_ = u32();
            } else {
                phi_936_ = select(((bitcast<u32>(_e564) << bitcast<u32>(23i)) | (_e568 & 8388607u)), 2139095039u, (_e564 >= 255i));
            }
            let _e579 = phi_936_;
            phi_937_ = _e579;
            phi_938_ = _e575;
        }
        let _e581 = phi_937_;
        let _e583 = phi_938_;
        if (_e206 >= 2139095040u) {
            phi_956_ = 255i;
        } else {
            phi_956_ = (bitcast<i32>((_e206 >> bitcast<u32>(23i))) + _e539);
        }
        let _e594 = phi_956_;
        if (_e206 == 0u) {
            phi_962_ = 0u;
        } else {
            phi_962_ = (_e206 | 8388608u);
        }
        let _e598 = phi_962_;
        if (_e594 <= 0i) {
            phi_982_ = u32();
            phi_983_ = true;
        } else {
            let _e605 = (_e598 == 0u);
            if _e605 {
                phi_981_ = u32();
            } else {
                phi_981_ = select(((bitcast<u32>(_e594) << bitcast<u32>(23i)) | (_e598 & 8388607u)), 2139095039u, (_e594 >= 255i));
            }
            let _e609 = phi_981_;
            phi_982_ = _e609;
            phi_983_ = _e605;
        }
        let _e611 = phi_982_;
        let _e613 = phi_983_;
        phi_1360_ = SlimbvhTypeC(array<f32, 3>((_e239 * _e544), (_e243 * _e544), (_e246 * _e544)), array<f32, 3>((_e248 * _e549), (_e250 * _e549), (_e252 * _e549)), bitcast<f32>(((_e197 & 2147483648u) | select(_e581, 0u, _e583))), bitcast<f32>(((_e205 & 2147483648u) | select(_e611, 0u, _e613))), _e538);
    } else {
        let _e285 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e210, _e223))) & 2147483647u);
        if (_e285 >= 8388608u) {
            phi_1014_ = (bitcast<i32>((_e285 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_1014_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e285)), 32u, (_e285 == 0u))));
        }
        let _e299 = phi_1014_;
        let _e300 = (_e190 + _e299);
        if (_e190 < -126i) {
            phi_1025_ = -126i;
        } else {
            phi_1025_ = select(_e190, 127i, (_e190 > 127i));
        }
        let _e305 = phi_1025_;
        let _e310 = bitcast<f32>((bitcast<u32>((_e305 + 127i)) << bitcast<u32>(23i)));
        let _e316 = bitcast<f32>((bitcast<u32>(((_e190 - _e305) + 127i)) << bitcast<u32>(23i)));
        let _e317 = bitcast<u32>(_e239);
        let _e319 = ((_e317 & 2139095040u) != 0u);
        let _e334 = bitcast<u32>(_e243);
        let _e336 = ((_e334 & 2139095040u) != 0u);
        let _e351 = bitcast<u32>(_e246);
        let _e353 = ((_e351 & 2139095040u) != 0u);
        let _e369 = -(_e299);
        if (_e369 < -126i) {
            phi_1139_ = -126i;
        } else {
            phi_1139_ = select(_e369, 127i, (_e369 > 127i));
        }
        let _e374 = phi_1139_;
        let _e379 = bitcast<f32>((bitcast<u32>((_e374 + 127i)) << bitcast<u32>(23i)));
        let _e385 = bitcast<f32>((bitcast<u32>(((_e369 - _e374) + 127i)) << bitcast<u32>(23i)));
        let _e386 = bitcast<u32>(_e248);
        let _e388 = ((_e386 & 2139095040u) != 0u);
        let _e403 = bitcast<u32>(_e250);
        let _e405 = ((_e403 & 2139095040u) != 0u);
        let _e420 = bitcast<u32>(_e252);
        let _e422 = ((_e420 & 2139095040u) != 0u);
        let _e444 = ((_e198 & 8388607u) | (select(0u, 1u, ((_e198 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e447 = bitcast<i32>((_e198 >> bitcast<u32>(23i)));
        let _e454 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e444)), 32u, (_e444 == 0u))) - 8i);
        if (_e447 == 255i) {
            phi_1268_ = 255i;
        } else {
            phi_1268_ = (((_e447 + select(0i, 1i, (_e447 == 0i))) - _e454) + _e300);
        }
        let _e462 = phi_1268_;
        let _e466 = (_e444 << bitcast<u32>(((_e454 & 31i) & 31i)));
        if (_e462 <= 0i) {
            phi_1291_ = u32();
            phi_1292_ = true;
        } else {
            let _e473 = (_e466 == 0u);
            if _e473 {
                phi_1290_ = u32();
            } else {
                phi_1290_ = select(((bitcast<u32>(_e462) << bitcast<u32>(23i)) | (_e466 & 8388607u)), 2139095039u, (_e462 >= 255i));
            }
            let _e477 = phi_1290_;
            phi_1291_ = _e477;
            phi_1292_ = _e473;
        }
        let _e479 = phi_1291_;
        let _e481 = phi_1292_;
        let _e492 = ((_e206 & 8388607u) | (select(0u, 1u, ((_e206 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e495 = bitcast<i32>((_e206 >> bitcast<u32>(23i)));
        let _e502 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e492)), 32u, (_e492 == 0u))) - 8i);
        if (_e495 == 255i) {
            phi_1326_ = 255i;
        } else {
            phi_1326_ = (((_e495 + select(0i, 1i, (_e495 == 0i))) - _e502) + _e300);
        }
        let _e510 = phi_1326_;
        let _e514 = (_e492 << bitcast<u32>(((_e502 & 31i) & 31i)));
        if (_e510 <= 0i) {
            phi_1349_ = u32();
            phi_1350_ = true;
        } else {
            let _e521 = (_e514 == 0u);
            if _e521 {
                phi_1348_ = u32();
            } else {
                phi_1348_ = select(((bitcast<u32>(_e510) << bitcast<u32>(23i)) | (_e514 & 8388607u)), 2139095039u, (_e510 >= 255i));
            }
            let _e525 = phi_1348_;
            phi_1349_ = _e525;
            phi_1350_ = _e521;
        }
        let _e527 = phi_1349_;
        let _e529 = phi_1350_;
        phi_1360_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e317 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e317 & 2147483648u))), _e239, _e319) * _e310) * select(0.00000011920929f, 1f, _e319)) * _e316), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e334 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e334 & 2147483648u))), _e243, _e336) * _e310) * select(0.00000011920929f, 1f, _e336)) * _e316), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e351 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e351 & 2147483648u))), _e246, _e353) * _e310) * select(0.00000011920929f, 1f, _e353)) * _e316)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e386 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e386 & 2147483648u))), _e248, _e388) * _e379) * select(0.00000011920929f, 1f, _e388)) * _e385), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e403 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e403 & 2147483648u))), _e250, _e405) * _e379) * select(0.00000011920929f, 1f, _e405)) * _e385), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e420 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e420 & 2147483648u))), _e252, _e422) * _e379) * select(0.00000011920929f, 1f, _e422)) * _e385)), bitcast<f32>(((_e197 & 2147483648u) | select(_e479, 0u, _e481))), bitcast<f32>(((_e205 & 2147483648u) | select(_e527, 0u, _e529))), _e299);
    }
    let _e620 = phi_1360_;
    let _e635 = (bitcast<f32>((bitcast<u32>(_e620.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e638 = bitcast<f32>((bitcast<u32>(_e620.member[0]) & 2147483647u));
    let _e639 = (_e638 * 0.00000011920929f);
    let _e642 = select(select(0.00000000000011368684f, _e639, (_e639 > 0.00000000000011368684f)), 0f, _e635);
    let _e643 = select(0f, _e620.member_1[0], _e635);
    let _e644 = (_e620.member[0] + _e642);
    let _e645 = (_e620.member[0] - _e642);
    let _e647 = select(38685626000000000000000000f, (1f / _e620.member_1[0]), _e635);
    let _e651 = (bitcast<f32>((bitcast<u32>(_e620.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e654 = bitcast<f32>((bitcast<u32>(_e620.member[1]) & 2147483647u));
    let _e655 = (_e654 * 0.00000011920929f);
    let _e658 = select(select(0.00000000000011368684f, _e655, (_e655 > 0.00000000000011368684f)), 0f, _e651);
    let _e659 = select(0f, _e620.member_1[1], _e651);
    let _e660 = (_e620.member[1] + _e658);
    let _e661 = (_e620.member[1] - _e658);
    let _e663 = select(38685626000000000000000000f, (1f / _e620.member_1[1]), _e651);
    let _e667 = (bitcast<f32>((bitcast<u32>(_e620.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e670 = bitcast<f32>((bitcast<u32>(_e620.member[2]) & 2147483647u));
    let _e671 = (_e670 * 0.00000011920929f);
    let _e674 = select(select(0.00000000000011368684f, _e671, (_e671 > 0.00000000000011368684f)), 0f, _e667);
    let _e675 = select(0f, _e620.member_1[2], _e667);
    let _e676 = (_e620.member[2] + _e674);
    let _e677 = (_e620.member[2] - _e674);
    let _e679 = select(38685626000000000000000000f, (1f / _e620.member_1[2]), _e667);
    let _e681 = select(_e654, _e638, (_e638 > _e654));
    let _e685 = (_e223 && (select(_e670, _e681, (_e681 > _e670)) <= 1099511600000f));
    let _e686 = select(0f, _e620.member_3, _e685);
    let _e687 = select(1f, _e620.member_2, _e685);
    let _e691 = slimbvh_question.member[1u];
    let _e694 = slimbvh_question.member[0u];
    if (_e694 == 1u) {
        phi_1599_ = SlimbvhTypeP(SlimbvhTypeI(_e119, _e686), true);
    } else {
        phi_1599_ = SlimbvhTypeP(SlimbvhTypeI(_e119, _e686), false);
    }
    let _e701 = phi_1599_;
    let _e706 = (_e232 & 3u);
    let _e707 = (_e236 & 3u);
    let _e708 = (_e228 & 3u);
    let _e721 = (f32(bitcast<i32>(_e136)) * _e172);
    let _e723 = (f32(bitcast<i32>(_e140)) * _e172);
    let _e725 = (f32(bitcast<i32>(_e144)) * _e172);
    let _e726 = (_e706 == 0u);
    if _e726 {
        phi_1663_ = array<f32, 3>(_e721, _e723, _e725);
    } else {
        if (_e706 == 1u) {
            phi_1662_ = array<f32, 3>(_e723, _e725, _e721);
        } else {
            phi_1662_ = array<f32, 3>(_e725, _e721, _e723);
        }
        let _e731 = phi_1662_;
        phi_1663_ = _e731;
    }
    let _e734 = phi_1663_;
    let _e736 = (f32(bitcast<i32>(_e152)) * _e172);
    let _e738 = (f32(bitcast<i32>(_e156)) * _e172);
    let _e740 = (f32(bitcast<i32>(_e160)) * _e172);
    if _e726 {
        phi_1682_ = array<f32, 3>(_e736, _e738, _e740);
    } else {
        if (_e706 == 1u) {
            phi_1681_ = array<f32, 3>(_e738, _e740, _e736);
        } else {
            phi_1681_ = array<f32, 3>(_e740, _e736, _e738);
        }
        let _e745 = phi_1681_;
        phi_1682_ = _e745;
    }
    let _e748 = phi_1682_;
    let _e759 = ((_e734[0] - _e644) * _e647);
    let _e760 = ((_e748[0] - _e645) * _e647);
    let _e761 = vec4<f32>(_e759, f32(), _e760, f32());
    let _e764 = ((_e734[1] - _e660) * _e663);
    let _e765 = ((_e748[1] - _e661) * _e663);
    let _e766 = vec4<f32>(_e764, f32(), _e765, f32());
    let _e769 = ((_e734[2] - _e676) * _e679);
    let _e770 = ((_e748[2] - _e677) * _e679);
    let _e771 = vec4<f32>(_e769, f32(), _e770, f32());
    let _e772 = vec4<f32>(_e760, f32(), _e759, f32());
    let _e774 = vec4<f32>(_e765, f32(), _e764, f32());
    let _e776 = vec4<f32>(_e770, f32(), _e769, f32());
    phi_1855_ = _e701;
    phi_1858_ = select(4294967295u, select(4294967295u, 0u, (_e687 <= _e686)), (max(max(max(min(_e761, _e772).x, min(_e766, _e774).x), min(_e771, _e776).x), _e687) <= min((min(min(max(_e761, _e772).x, max(_e766, _e774).x), max(_e771, _e776).x) + (max(max(_e771, _e776).x, -(min(_e771, _e776).x)) * 0.0000019073523f)), _e701.member.member_1)));
    phi_1860_ = select(0u, 4294967295u, (_e123 == 0u));
    phi_1862_ = (_e123 + 1u);
    loop {
        let _e800 = phi_1855_;
        let _e802 = phi_1858_;
        let _e804 = phi_1860_;
        let _e806 = phi_1862_;
        local_6 = _e800;
        let _e807 = (_e802 <= 2147483647u);
        if _e807 {
            phi_1871_ = _e802;
            phi_1874_ = _e804;
            phi_1876_ = _e806;
            loop {
                let _e809 = phi_1871_;
                let _e811 = phi_1874_;
                let _e813 = phi_1876_;
                local_2 = _e811;
                local_3 = _e809;
                local_4 = _e809;
                local_8 = _e809;
                local_9 = _e811;
                local_10 = _e813;
                let _e814 = (_e809 <= 2147483647u);
                let _e817 = (_e814 && !((_e811 >= _e123)));
                local_1 = _e814;
                if _e817 {
                    let _e822 = slimbvh_nodes.member[_e811][select(_e706, 2u, (2u < _e706))];
                    let _e827 = slimbvh_nodes.member[_e811][select(_e707, 2u, (2u < _e707))];
                    let _e832 = slimbvh_nodes.member[_e811][select(_e708, 2u, (2u < _e708))];
                    let _e835 = bitcast<u32>(_e172);
                    let _e840 = bitcast<f32>(_e822.x);
                    let _e841 = bitcast<f32>((_e835 + ((_e822.w & 31u) << bitcast<u32>(23i))));
                    let _e842 = (_e840 + _e841);
                    if ((bitcast<u32>(_e647) >> bitcast<u32>(31i)) == 0u) {
                        phi_1978_ = SlimbvhTypeJ(_e822.z, _e842);
                        phi_1979_ = SlimbvhTypeJ(_e822.y, _e840);
                    } else {
                        phi_1978_ = SlimbvhTypeJ(_e822.y, _e840);
                        phi_1979_ = SlimbvhTypeJ(_e822.z, _e842);
                    }
                    let _e853 = phi_1978_;
                    let _e855 = phi_1979_;
                    let _e894 = bitcast<f32>(_e827.x);
                    let _e895 = bitcast<f32>((_e835 + ((_e827.w & 31u) << bitcast<u32>(23i))));
                    let _e896 = (_e894 + _e895);
                    if ((bitcast<u32>(_e663) >> bitcast<u32>(31i)) == 0u) {
                        phi_2038_ = SlimbvhTypeJ(_e827.z, _e896);
                        phi_2039_ = SlimbvhTypeJ(_e827.y, _e894);
                    } else {
                        phi_2038_ = SlimbvhTypeJ(_e827.y, _e894);
                        phi_2039_ = SlimbvhTypeJ(_e827.z, _e896);
                    }
                    let _e907 = phi_2038_;
                    let _e909 = phi_2039_;
                    let _e948 = bitcast<f32>(_e832.x);
                    let _e949 = bitcast<f32>((_e835 + ((_e832.w & 31u) << bitcast<u32>(23i))));
                    let _e950 = (_e948 + _e949);
                    if ((bitcast<u32>(_e679) >> bitcast<u32>(31i)) == 0u) {
                        phi_2098_ = SlimbvhTypeJ(_e832.z, _e950);
                        phi_2099_ = SlimbvhTypeJ(_e832.y, _e948);
                    } else {
                        phi_2098_ = SlimbvhTypeJ(_e832.y, _e948);
                        phi_2099_ = SlimbvhTypeJ(_e832.z, _e950);
                    }
                    let _e961 = phi_2098_;
                    let _e963 = phi_2099_;
                    let _e998 = (_e841 * _e647);
                    let _e1001 = bitcast<f32>((bitcast<u32>(_e998) & 2147483647u));
                    let _e1005 = (((_e855.member_1 - _e644) * _e647) + (_e1001 * -0.00012207031f));
                    let _e1017 = (((_e853.member_1 - _e645) * _e647) + (_e1001 * 0.00012207031f));
                    let _e1026 = (_e895 * _e663);
                    let _e1029 = bitcast<f32>((bitcast<u32>(_e1026) & 2147483647u));
                    let _e1033 = (((_e909.member_1 - _e660) * _e663) + (_e1029 * -0.00012207031f));
                    let _e1045 = (((_e907.member_1 - _e661) * _e663) + (_e1029 * 0.00012207031f));
                    let _e1054 = (_e949 * _e679);
                    let _e1057 = bitcast<f32>((bitcast<u32>(_e1054) & 2147483647u));
                    let _e1061 = (((_e963.member_1 - _e676) * _e679) + (_e1057 * -0.00012207031f));
                    let _e1066 = ((f32((_e963.member & 255u)) * _e1054) + _e1061);
                    let _e1067 = ((f32(((_e963.member >> bitcast<u32>(8u)) & 255u)) * _e1054) + _e1061);
                    let _e1068 = ((f32(((_e963.member >> bitcast<u32>(16u)) & 255u)) * _e1054) + _e1061);
                    let _e1069 = ((f32(((_e963.member >> bitcast<u32>(24u)) & 255u)) * _e1054) + _e1061);
                    let _e1073 = (((_e961.member_1 - _e677) * _e679) + (_e1057 * 0.00012207031f));
                    let _e1078 = ((f32((_e961.member & 255u)) * _e1054) + _e1073);
                    let _e1079 = ((f32(((_e961.member >> bitcast<u32>(8u)) & 255u)) * _e1054) + _e1073);
                    let _e1080 = ((f32(((_e961.member >> bitcast<u32>(16u)) & 255u)) * _e1054) + _e1073);
                    let _e1081 = ((f32(((_e961.member >> bitcast<u32>(24u)) & 255u)) * _e1054) + _e1073);
                    let _e1114 = max(max(max(((f32((_e855.member & 255u)) * _e998) + _e1005), ((f32((_e909.member & 255u)) * _e1026) + _e1033)), _e1066), _e687);
                    let _e1115 = max(max(max(((f32(((_e855.member >> bitcast<u32>(8u)) & 255u)) * _e998) + _e1005), ((f32(((_e909.member >> bitcast<u32>(8u)) & 255u)) * _e1026) + _e1033)), _e1067), _e687);
                    let _e1116 = max(max(max(((f32(((_e855.member >> bitcast<u32>(16u)) & 255u)) * _e998) + _e1005), ((f32(((_e909.member >> bitcast<u32>(16u)) & 255u)) * _e1026) + _e1033)), _e1068), _e687);
                    let _e1117 = max(max(max(((f32(((_e855.member >> bitcast<u32>(24u)) & 255u)) * _e998) + _e1005), ((f32(((_e909.member >> bitcast<u32>(24u)) & 255u)) * _e1026) + _e1033)), _e1069), _e687);
                    let _e1122 = (_e800.member.member_1 + (bitcast<f32>((bitcast<u32>(_e800.member.member_1) & 2147483647u)) * 0.0000004768374f));
                    if (_e1114 <= min((min(min(((f32((_e853.member & 255u)) * _e998) + _e1017), ((f32((_e907.member & 255u)) * _e1026) + _e1045)), _e1078) + (max(_e1078, -(_e1066)) * 0.0000023841915f)), _e1122)) {
                        phi_2589_ = (((bitcast<u32>(_e1114) ^ select(0u, 4294967288u, _e701.member_1)) & 2147483640u) | 4u);
                    } else {
                        phi_2589_ = 4294967288u;
                    }
                    let _e1137 = phi_2589_;
                    if (_e1115 <= min((min(min(((f32(((_e853.member >> bitcast<u32>(8u)) & 255u)) * _e998) + _e1017), ((f32(((_e907.member >> bitcast<u32>(8u)) & 255u)) * _e1026) + _e1045)), _e1079) + (max(_e1079, -(_e1067)) * 0.0000023841915f)), _e1122)) {
                        phi_2602_ = ((((bitcast<u32>(_e1115) ^ select(0u, 4294967288u, _e701.member_1)) & 2147483640u) | 4u) | 1u);
                    } else {
                        phi_2602_ = 4294967288u;
                    }
                    let _e1145 = phi_2602_;
                    if (_e1116 <= min((min(min(((f32(((_e853.member >> bitcast<u32>(16u)) & 255u)) * _e998) + _e1017), ((f32(((_e907.member >> bitcast<u32>(16u)) & 255u)) * _e1026) + _e1045)), _e1080) + (max(_e1080, -(_e1068)) * 0.0000023841915f)), _e1122)) {
                        phi_2615_ = ((((bitcast<u32>(_e1116) ^ select(0u, 4294967288u, _e701.member_1)) & 2147483640u) | 4u) | 2u);
                    } else {
                        phi_2615_ = 4294967288u;
                    }
                    let _e1153 = phi_2615_;
                    if (_e1117 <= min((min(min(((f32(((_e853.member >> bitcast<u32>(24u)) & 255u)) * _e998) + _e1017), ((f32(((_e907.member >> bitcast<u32>(24u)) & 255u)) * _e1026) + _e1045)), _e1081) + (max(_e1081, -(_e1069)) * 0.0000023841915f)), _e1122)) {
                        phi_2628_ = ((((bitcast<u32>(_e1117) ^ select(0u, 4294967288u, _e701.member_1)) & 2147483640u) | 4u) | 3u);
                    } else {
                        phi_2628_ = 4294967288u;
                    }
                    let _e1161 = phi_2628_;
                    if (_e1137 < _e1145) {
                        phi_5346_ = SlimbvhTypeD(_e1137, _e1145);
                    } else {
                        phi_5346_ = SlimbvhTypeD(_e1145, _e1137);
                    }
                    let _e1166 = phi_5346_;
                    if (_e1153 < _e1161) {
                        phi_5358_ = SlimbvhTypeD(_e1153, _e1161);
                    } else {
                        phi_5358_ = SlimbvhTypeD(_e1161, _e1153);
                    }
                    let _e1173 = phi_5358_;
                    if (_e1166.member < _e1173.member) {
                        phi_5370_ = SlimbvhTypeD(_e1166.member, _e1173.member);
                    } else {
                        phi_5370_ = SlimbvhTypeD(_e1173.member, _e1166.member);
                    }
                    let _e1180 = phi_5370_;
                    if (_e1166.member_1 < _e1173.member_1) {
                        phi_5382_ = SlimbvhTypeD(_e1166.member_1, _e1173.member_1);
                    } else {
                        phi_5382_ = SlimbvhTypeD(_e1173.member_1, _e1166.member_1);
                    }
                    let _e1187 = phi_5382_;
                    if (_e1187.member < _e1180.member_1) {
                        phi_5394_ = SlimbvhTypeD(_e1187.member, _e1180.member_1);
                    } else {
                        phi_5394_ = SlimbvhTypeD(_e1180.member_1, _e1187.member);
                    }
                    let _e1194 = phi_5394_;
                    let _e1209 = (((_e1180.member & 7u) | ((_e1194.member & 7u) << bitcast<u32>(3u))) | (((_e1194.member_1 & 7u) | ((_e1187.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                    if (_e1209 == 0u) {
                        let _e1227 = (_e809 - 1u);
                        let _e1230 = local[(_e1227 % 128u)];
                        let _e1231 = (_e1230 & 511u);
                        let _e1233 = (_e1231 >> bitcast<u32>(3u));
                        let _e1236 = ((_e1233 == 0u) || (_e1227 == 4294967295u));
                        if _e1236 {
                        } else {
                            local[(_e1227 % 128u)] = (((_e1230 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1233);
                        }
                        phi_2714_ = select(_e809, _e1227, _e1236);
                        phi_2715_ = (((_e1230 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1231 & 3u) & 3u));
                    } else {
                        let _e1212 = (_e1209 >> bitcast<u32>(3u));
                        if (_e1212 == 0u) {
                            phi_2709_ = _e809;
                        } else {
                            local[(_e809 % 128u)] = ((_e811 << bitcast<u32>(9u)) | _e1212);
                            phi_2709_ = (_e809 + 1u);
                        }
                        let _e1221 = phi_2709_;
                        phi_2714_ = _e1221;
                        phi_2715_ = ((_e811 << bitcast<u32>(2i)) | ((_e1209 & 3u) & 3u));
                    }
                    let _e1251 = phi_2714_;
                    let _e1253 = phi_2715_;
                    let _e1255 = (_e1253 >> bitcast<u32>(2i));
                    if (_e1255 < _e123) {
                        let _e1260 = slimbvh_nodes.member[_e1255][1u][3u];
                        let _e1264 = slimbvh_nodes.member[_e1255][2u][3u];
                        let _e1269 = (_e1264 >> bitcast<u32>(20u));
                        let _e1270 = (_e1253 & 3u);
                        if (((_e1269 >> bitcast<u32>((((3u * _e1270) & 31u) & 31u))) & 7u) == 7u) {
                            let _e1282 = ((_e1269 | (_e1269 << bitcast<u32>(10i))) & 4128831u);
                            phi_2769_ = (((_e1260 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e1282 | (_e1282 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e1270) & 31u) & 31u))) & 255u));
                        } else {
                            phi_2769_ = (2147483648u | _e1253);
                        }
                        let _e1300 = phi_2769_;
                        phi_2770_ = _e1300;
                    } else {
                        phi_2770_ = 4294967295u;
                    }
                    let _e1302 = phi_2770_;
                    let _e1303 = (_e813 - 1u);
                    phi_1872_ = select(_e1251, 4294967295u, (_e1303 == 0u));
                    phi_1875_ = _e1302;
                    phi_1877_ = _e1303;
                } else {
                    phi_1872_ = u32();
                    phi_1875_ = u32();
                    phi_1877_ = u32();
                }
                let _e1307 = phi_1872_;
                let _e1309 = phi_1875_;
                let _e1311 = phi_1877_;
                continue;
                continuing {
                    phi_1871_ = _e1307;
                    phi_1874_ = _e1309;
                    phi_1876_ = _e1311;
                    break if !(_e817);
                }
            }
            let _e1314 = local_1;
            if _e1314 {
                let _e1316 = local_2;
                let _e1317 = (_e1316 & 2147483647u);
                let _e1319 = (_e1317 >> bitcast<u32>(2i));
                if (_e1319 >= _e123) {
                    phi_3003_ = SlimbvhTypeM(SlimbvhTypeL(vec4<f32>(0f, 0f, 0f, 0f), 0u), 0u, 0u);
                } else {
                    let _e1325 = slimbvh_nodes.member[_e1319][select(_e706, 2u, (2u < _e706))];
                    let _e1334 = slimbvh_nodes.member[_e1319][select(_e707, 2u, (2u < _e707))];
                    let _e1343 = slimbvh_nodes.member[_e1319][select(_e708, 2u, (2u < _e708))];
                    let _e1351 = slimbvh_nodes.member[_e1319][0u][3u];
                    let _e1355 = slimbvh_nodes.member[_e1319][1u][3u];
                    let _e1359 = slimbvh_nodes.member[_e1319][2u][3u];
                    let _e1372 = (_e1359 >> bitcast<u32>(20u));
                    let _e1380 = (((_e1359 >> bitcast<u32>(7u)) & 8191u) | ((_e1355 >> bitcast<u32>(29u)) << bitcast<u32>(13u)));
                    let _e1383 = ((_e1359 >> bitcast<u32>(5u)) & 3u);
                    let _e1384 = (_e1317 & 3u);
                    let _e1390 = ((_e1372 >> bitcast<u32>((((3u * _e1384) & 31u) & 31u))) & 7u);
                    if (_e1390 == 7u) {
                        let _e1443 = ((_e1372 | (_e1372 << bitcast<u32>(10i))) & 4128831u);
                        phi_2955_ = (((_e1355 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e1443 | (_e1443 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e1384) & 31u) & 31u))) & 255u));
                    } else {
                        let _e1395 = ((_e1372 | (_e1372 << bitcast<u32>(10i))) & 4128831u);
                        let _e1399 = ((_e1395 | (_e1395 << bitcast<u32>(5i))) & 117901063u);
                        let _e1405 = (_e1399 - (7u * (((_e1399 + 16843009u) >> bitcast<u32>(3i)) & 16843009u)));
                        let _e1413 = ((_e1380 | (_e1380 << bitcast<u32>(8i))) & 16711935u);
                        phi_2955_ = ((2147483648u | (_e1390 << bitcast<u32>(28u))) | ((((_e1351 >> bitcast<u32>(5u)) | (((_e1355 >> bitcast<u32>(28u)) & 1u) << bitcast<u32>(27u))) + (((((((((_e1413 | (_e1413 << bitcast<u32>(4i))) & 252645135u) + (3u * (((_e1405 + 117901063u) >> bitcast<u32>(3i)) & 16843009u))) * (_e1383 + 1u)) + _e1405) + ((_e1405 >> bitcast<u32>(1i)) & 50529027u)) * 16843008u) >> bitcast<u32>((((8u * _e1384) & 31u) & 31u))) & 255u)) & 268435455u));
                    }
                    let _e1461 = phi_2955_;
                    switch bitcast<i32>(_e1383) {
                        case 0: {
                            phi_2960_ = 0u;
                            break;
                        }
                        case 1: {
                            phi_2960_ = 1u;
                            break;
                        }
                        default: {
                            phi_2960_ = 2u;
                            break;
                        }
                    }
                    let _e1464 = phi_2960_;
                    let _e1467 = (((8u * _e1384) & 31u) & 31u);
                    phi_3003_ = SlimbvhTypeM(SlimbvhTypeL(vec4<f32>((bitcast<f32>(_e1325.x) + (f32((((_e1325.y >> bitcast<u32>(_e1467)) & 255u) << bitcast<u32>(((_e1325.w & 31u) & 31u)))) * _e172)), (bitcast<f32>(_e1334.x) + (f32((((_e1334.y >> bitcast<u32>(_e1467)) & 255u) << bitcast<u32>(((_e1334.w & 31u) & 31u)))) * _e172)), (bitcast<f32>(_e1343.x) + (f32((((_e1343.y >> bitcast<u32>(_e1467)) & 255u) << bitcast<u32>(((_e1343.w & 31u) & 31u)))) * _e172)), 0f), _e1464), (_e1461 & 268435455u), ((_e1461 >> bitcast<u32>(28u)) & 7u));
                }
                let _e1506 = phi_3003_;
                phi_3007_ = _e800;
                phi_3010_ = SlimbvhTypeD(0u, _e1506.member_2);
                loop {
                    let _e1510 = phi_3007_;
                    let _e1512 = phi_3010_;
                    local_5 = _e1510;
                    local_7 = _e1510;
                    if (_e1512.member < _e1512.member_1) {
                        phi_3011_ = SlimbvhTypeD((_e1512.member + 1u), _e1512.member_1);
                        phi_3033_ = SlimbvhTypeD(1u, _e1512.member);
                    } else {
                        phi_3011_ = _e1512;
                        phi_3033_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                    }
                    let _e1525 = phi_3011_;
                    let _e1527 = phi_3033_;
                    let _e1531 = (bitcast<i32>(_e1527.member) != 0i);
                    if _e1531 {
                        let _e1535 = (_e1506.member_1 + (_e1506.member_2 / 2u));
                        let _e1536 = (_e1535 + _e1527.member_1);
                        if (_e1536 < _e126) {
                            let _e1539 = slimbvh_triangles.member[_e1536];
                            phi_3061_ = _e1539;
                        } else {
                            phi_3061_ = 4294967295u;
                        }
                        let _e1541 = phi_3061_;
                        let _e1542 = (_e1527.member_1 - 1u);
                        let _e1545 = (_e1506.member_1 + (_e1542 >> bitcast<u32>(1i)));
                        if (_e1545 < _e126) {
                            let _e1548 = slimbvh_triangles.member[_e1545];
                            phi_3084_ = _e1548;
                        } else {
                            phi_3084_ = 0u;
                        }
                        let _e1550 = phi_3084_;
                        if (_e1527.member_1 == 0u) {
                            phi_3093_ = 2080u;
                        } else {
                            phi_3093_ = (_e1550 >> bitcast<u32>(((16u * (_e1542 & 1u)) & 31u)));
                        }
                        let _e1558 = phi_3093_;
                        let _e1559 = (_e1535 + _e1506.member_2);
                        switch bitcast<i32>(_e1506.member.member_1) {
                            case 0: {
                                phi_3103_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_3103_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_3103_ = 3u;
                                break;
                            }
                            default: {
                                phi_3103_ = u32();
                                break;
                            }
                        }
                        let _e1563 = phi_3103_;
                        let _e1566 = (_e1559 + ((_e1558 & 31u) * _e1563));
                        let _e1571 = (_e1559 + (((_e1558 >> bitcast<u32>(5u)) & 31u) * _e1563));
                        let _e1576 = (_e1559 + (((_e1558 >> bitcast<u32>(10u)) & 31u) * _e1563));
                        switch bitcast<i32>(_e1506.member.member_1) {
                            case 0: {
                                if (_e1566 < _e126) {
                                    let _e1853 = slimbvh_triangles.member[_e1566];
                                    phi_3145_ = _e1853;
                                } else {
                                    phi_3145_ = 0u;
                                }
                                let _e1855 = phi_3145_;
                                let _e1858 = ((10u * _e232) & 31u);
                                let _e1869 = ((10u * _e236) & 31u);
                                let _e1880 = ((10u * _e228) & 31u);
                                if (_e1571 < _e126) {
                                    let _e1892 = slimbvh_triangles.member[_e1571];
                                    phi_3191_ = _e1892;
                                } else {
                                    phi_3191_ = 0u;
                                }
                                let _e1894 = phi_3191_;
                                if (_e1576 < _e126) {
                                    let _e1922 = slimbvh_triangles.member[_e1576];
                                    phi_3237_ = _e1922;
                                } else {
                                    phi_3237_ = 0u;
                                }
                                let _e1924 = phi_3237_;
                                phi_3704_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1506.member.member.x + ((bitcast<f32>((1258291200u | ((_e1855 >> bitcast<u32>(_e1858)) & 1023u))) - 8388608f) * _e172)), (_e1506.member.member.y + ((bitcast<f32>((1258291200u | ((_e1855 >> bitcast<u32>(_e1869)) & 1023u))) - 8388608f) * _e172)), (_e1506.member.member.z + ((bitcast<f32>((1258291200u | ((_e1855 >> bitcast<u32>(_e1880)) & 1023u))) - 8388608f) * _e172))), array<f32, 3>((_e1506.member.member.x + ((bitcast<f32>((1258291200u | ((_e1894 >> bitcast<u32>(_e1858)) & 1023u))) - 8388608f) * _e172)), (_e1506.member.member.y + ((bitcast<f32>((1258291200u | ((_e1894 >> bitcast<u32>(_e1869)) & 1023u))) - 8388608f) * _e172)), (_e1506.member.member.z + ((bitcast<f32>((1258291200u | ((_e1894 >> bitcast<u32>(_e1880)) & 1023u))) - 8388608f) * _e172))), array<f32, 3>((_e1506.member.member.x + ((bitcast<f32>((1258291200u | ((_e1924 >> bitcast<u32>(_e1858)) & 1023u))) - 8388608f) * _e172)), (_e1506.member.member.y + ((bitcast<f32>((1258291200u | ((_e1924 >> bitcast<u32>(_e1869)) & 1023u))) - 8388608f) * _e172)), (_e1506.member.member.z + ((bitcast<f32>((1258291200u | ((_e1924 >> bitcast<u32>(_e1880)) & 1023u))) - 8388608f) * _e172))));
                                break;
                            }
                            case 1: {
                                if (_e1566 < _e126) {
                                    let _e1666 = slimbvh_triangles.member[_e1566];
                                    phi_3284_ = _e1666;
                                } else {
                                    phi_3284_ = 0u;
                                }
                                let _e1668 = phi_3284_;
                                let _e1669 = (_e1566 + 1u);
                                if (_e1669 < _e126) {
                                    let _e1672 = slimbvh_triangles.member[_e1669];
                                    phi_3297_ = _e1672;
                                } else {
                                    phi_3297_ = 0u;
                                }
                                let _e1674 = phi_3297_;
                                let _e1676 = (_e232 == 1u);
                                if _e1676 {
                                    phi_3307_ = ((_e1668 >> bitcast<u32>(21i)) | (_e1674 << bitcast<u32>(11i)));
                                } else {
                                    phi_3307_ = (_e1674 >> bitcast<u32>(10i));
                                }
                                let _e1685 = phi_3307_;
                                let _e1694 = (_e236 == 1u);
                                if _e1694 {
                                    phi_3328_ = ((_e1668 >> bitcast<u32>(21i)) | (_e1674 << bitcast<u32>(11i)));
                                } else {
                                    phi_3328_ = (_e1674 >> bitcast<u32>(10i));
                                }
                                let _e1703 = phi_3328_;
                                let _e1712 = (_e228 == 1u);
                                if _e1712 {
                                    phi_3349_ = ((_e1668 >> bitcast<u32>(21i)) | (_e1674 << bitcast<u32>(11i)));
                                } else {
                                    phi_3349_ = (_e1674 >> bitcast<u32>(10i));
                                }
                                let _e1721 = phi_3349_;
                                if (_e1571 < _e126) {
                                    let _e1732 = slimbvh_triangles.member[_e1571];
                                    phi_3376_ = _e1732;
                                } else {
                                    phi_3376_ = 0u;
                                }
                                let _e1734 = phi_3376_;
                                let _e1735 = (_e1571 + 1u);
                                if (_e1735 < _e126) {
                                    let _e1738 = slimbvh_triangles.member[_e1735];
                                    phi_3389_ = _e1738;
                                } else {
                                    phi_3389_ = 0u;
                                }
                                let _e1740 = phi_3389_;
                                if _e1676 {
                                    phi_3399_ = ((_e1734 >> bitcast<u32>(21i)) | (_e1740 << bitcast<u32>(11i)));
                                } else {
                                    phi_3399_ = (_e1740 >> bitcast<u32>(10i));
                                }
                                let _e1749 = phi_3399_;
                                if _e1694 {
                                    phi_3420_ = ((_e1734 >> bitcast<u32>(21i)) | (_e1740 << bitcast<u32>(11i)));
                                } else {
                                    phi_3420_ = (_e1740 >> bitcast<u32>(10i));
                                }
                                let _e1765 = phi_3420_;
                                if _e1712 {
                                    phi_3441_ = ((_e1734 >> bitcast<u32>(21i)) | (_e1740 << bitcast<u32>(11i)));
                                } else {
                                    phi_3441_ = (_e1740 >> bitcast<u32>(10i));
                                }
                                let _e1781 = phi_3441_;
                                if (_e1576 < _e126) {
                                    let _e1792 = slimbvh_triangles.member[_e1576];
                                    phi_3468_ = _e1792;
                                } else {
                                    phi_3468_ = 0u;
                                }
                                let _e1794 = phi_3468_;
                                let _e1795 = (_e1576 + 1u);
                                if (_e1795 < _e126) {
                                    let _e1798 = slimbvh_triangles.member[_e1795];
                                    phi_3481_ = _e1798;
                                } else {
                                    phi_3481_ = 0u;
                                }
                                let _e1800 = phi_3481_;
                                if _e1676 {
                                    phi_3491_ = ((_e1794 >> bitcast<u32>(21i)) | (_e1800 << bitcast<u32>(11i)));
                                } else {
                                    phi_3491_ = (_e1800 >> bitcast<u32>(10i));
                                }
                                let _e1809 = phi_3491_;
                                if _e1694 {
                                    phi_3512_ = ((_e1794 >> bitcast<u32>(21i)) | (_e1800 << bitcast<u32>(11i)));
                                } else {
                                    phi_3512_ = (_e1800 >> bitcast<u32>(10i));
                                }
                                let _e1825 = phi_3512_;
                                if _e1712 {
                                    phi_3533_ = ((_e1794 >> bitcast<u32>(21i)) | (_e1800 << bitcast<u32>(11i)));
                                } else {
                                    phi_3533_ = (_e1800 >> bitcast<u32>(10i));
                                }
                                let _e1841 = phi_3533_;
                                phi_3704_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1506.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1685, _e1668, _e237) & 2097151u))) - 8388608f) * _e172)), (_e1506.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1703, _e1668, _e240) & 2097151u))) - 8388608f) * _e172)), (_e1506.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1721, _e1668, _e244) & 2097151u))) - 8388608f) * _e172))), array<f32, 3>((_e1506.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1749, _e1734, _e237) & 2097151u))) - 8388608f) * _e172)), (_e1506.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1765, _e1734, _e240) & 2097151u))) - 8388608f) * _e172)), (_e1506.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1781, _e1734, _e244) & 2097151u))) - 8388608f) * _e172))), array<f32, 3>((_e1506.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1809, _e1794, _e237) & 2097151u))) - 8388608f) * _e172)), (_e1506.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1825, _e1794, _e240) & 2097151u))) - 8388608f) * _e172)), (_e1506.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1841, _e1794, _e244) & 2097151u))) - 8388608f) * _e172))));
                                break;
                            }
                            case 2: {
                                let _e1579 = (_e1566 + _e232);
                                if (_e1579 < _e126) {
                                    let _e1582 = slimbvh_triangles.member[_e1579];
                                    phi_3562_ = _e1582;
                                } else {
                                    phi_3562_ = 0u;
                                }
                                let _e1584 = phi_3562_;
                                let _e1585 = (_e1566 + _e236);
                                if (_e1585 < _e126) {
                                    let _e1588 = slimbvh_triangles.member[_e1585];
                                    phi_3575_ = _e1588;
                                } else {
                                    phi_3575_ = 0u;
                                }
                                let _e1590 = phi_3575_;
                                let _e1591 = (_e1566 + _e228);
                                if (_e1591 < _e126) {
                                    let _e1594 = slimbvh_triangles.member[_e1591];
                                    phi_3588_ = _e1594;
                                } else {
                                    phi_3588_ = 0u;
                                }
                                let _e1596 = phi_3588_;
                                let _e1607 = (_e1571 + _e232);
                                if (_e1607 < _e126) {
                                    let _e1610 = slimbvh_triangles.member[_e1607];
                                    phi_3614_ = _e1610;
                                } else {
                                    phi_3614_ = 0u;
                                }
                                let _e1612 = phi_3614_;
                                let _e1613 = (_e1571 + _e236);
                                if (_e1613 < _e126) {
                                    let _e1616 = slimbvh_triangles.member[_e1613];
                                    phi_3627_ = _e1616;
                                } else {
                                    phi_3627_ = 0u;
                                }
                                let _e1618 = phi_3627_;
                                let _e1619 = (_e1571 + _e228);
                                if (_e1619 < _e126) {
                                    let _e1622 = slimbvh_triangles.member[_e1619];
                                    phi_3640_ = _e1622;
                                } else {
                                    phi_3640_ = 0u;
                                }
                                let _e1624 = phi_3640_;
                                let _e1635 = (_e1576 + _e232);
                                if (_e1635 < _e126) {
                                    let _e1638 = slimbvh_triangles.member[_e1635];
                                    phi_3666_ = _e1638;
                                } else {
                                    phi_3666_ = 0u;
                                }
                                let _e1640 = phi_3666_;
                                let _e1641 = (_e1576 + _e236);
                                if (_e1641 < _e126) {
                                    let _e1644 = slimbvh_triangles.member[_e1641];
                                    phi_3679_ = _e1644;
                                } else {
                                    phi_3679_ = 0u;
                                }
                                let _e1646 = phi_3679_;
                                let _e1647 = (_e1576 + _e228);
                                if (_e1647 < _e126) {
                                    let _e1650 = slimbvh_triangles.member[_e1647];
                                    phi_3692_ = _e1650;
                                } else {
                                    phi_3692_ = 0u;
                                }
                                let _e1652 = phi_3692_;
                                phi_3704_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1584)) * _e172), (f32(bitcast<i32>(_e1590)) * _e172), (f32(bitcast<i32>(_e1596)) * _e172)), array<f32, 3>((f32(bitcast<i32>(_e1612)) * _e172), (f32(bitcast<i32>(_e1618)) * _e172), (f32(bitcast<i32>(_e1624)) * _e172)), array<f32, 3>((f32(bitcast<i32>(_e1640)) * _e172), (f32(bitcast<i32>(_e1646)) * _e172), (f32(bitcast<i32>(_e1652)) * _e172)));
                                break;
                            }
                            default: {
                                phi_3704_ = array<array<f32, 3>, 3>();
                                break;
                            }
                        }
                        let _e1952 = phi_3704_;
                        let _e1969 = (_e1952[0][2] - _e620.member[2]);
                        let _e1972 = (((_e1952[0][0] - _e620.member[0]) * _e675) - (_e1969 * _e643));
                        let _e1975 = (((_e1952[0][1] - _e620.member[1]) * _e675) - (_e1969 * _e659));
                        let _e1978 = (_e1952[1][2] - _e620.member[2]);
                        let _e1981 = (((_e1952[1][0] - _e620.member[0]) * _e675) - (_e1978 * _e643));
                        let _e1984 = (((_e1952[1][1] - _e620.member[1]) * _e675) - (_e1978 * _e659));
                        let _e1987 = (_e1952[2][2] - _e620.member[2]);
                        let _e1990 = (((_e1952[2][0] - _e620.member[0]) * _e675) - (_e1987 * _e643));
                        let _e1993 = (((_e1952[2][1] - _e620.member[1]) * _e675) - (_e1987 * _e659));
                        let _e1994 = (_e1990 * _e1984);
                        let _e1995 = (_e1993 * _e1981);
                        let _e1996 = (_e1972 * _e1993);
                        let _e1997 = (_e1975 * _e1990);
                        let _e1998 = (_e1981 * _e1975);
                        let _e1999 = (_e1984 * _e1972);
                        let _e2004 = (((_e1994 >= _e1995) && (_e1996 >= _e1997)) && (_e1998 >= _e1999));
                        let _e2010 = (_e2004 || (((_e1994 <= _e1995) && (_e1996 <= _e1997)) && (_e1998 <= _e1999)));
                        if _e2010 {
                            let _e2012 = select(-1f, 1f, _e2004);
                            let _e2014 = ((_e1994 - _e1995) * _e2012);
                            let _e2016 = select(0f, _e2014, (_e2014 > 0f));
                            let _e2018 = ((_e1996 - _e1997) * _e2012);
                            let _e2020 = select(0f, _e2018, (_e2018 > 0f));
                            let _e2022 = ((_e1998 - _e1999) * _e2012);
                            let _e2024 = select(0f, _e2022, (_e2022 > 0f));
                            let _e2026 = ((_e2016 + _e2020) + _e2024);
                            let _e2041 = ((min(min(_e1952[0][0], _e1952[1][0]), _e1952[2][0]) - _e644) * _e647);
                            let _e2042 = ((max(max(_e1952[0][0], _e1952[1][0]), _e1952[2][0]) - _e645) * _e647);
                            let _e2043 = vec4<f32>(_e2041, f32(), _e2042, f32());
                            let _e2046 = ((min(min(_e1952[0][1], _e1952[1][1]), _e1952[2][1]) - _e660) * _e663);
                            let _e2047 = ((max(max(_e1952[0][1], _e1952[1][1]), _e1952[2][1]) - _e661) * _e663);
                            let _e2048 = vec4<f32>(_e2046, f32(), _e2047, f32());
                            let _e2051 = ((min(min(_e1952[0][2], _e1952[1][2]), _e1952[2][2]) - _e676) * _e679);
                            let _e2052 = ((max(max(_e1952[0][2], _e1952[1][2]), _e1952[2][2]) - _e677) * _e679);
                            let _e2053 = vec4<f32>(_e2051, f32(), _e2052, f32());
                            let _e2054 = vec4<f32>(_e2042, f32(), _e2041, f32());
                            let _e2056 = vec4<f32>(_e2047, f32(), _e2046, f32());
                            let _e2058 = vec4<f32>(_e2052, f32(), _e2051, f32());
                            let _e2067 = max(max(min(_e2043, _e2054).x, min(_e2048, _e2056).x), min(_e2053, _e2058).x);
                            let _e2072 = min(min(max(_e2043, _e2054).x, max(_e2048, _e2056).x), max(_e2053, _e2058).x);
                            let _e2077 = max(_e2067, _e687);
                            let _e2099 = (((((_e2010 && (_e2026 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1972, _e1981), _e1990) <= 0f) && (max(max(_e1972, _e1981), _e1990) >= 0f))) && ((min(min(_e1975, _e1984), _e1993) <= 0f) && (max(max(_e1975, _e1984), _e1993) >= 0f))) && (_e2077 <= (_e2072 + (max(max(_e2053, _e2058).x, -(min(_e2053, _e2058).x)) * 0.0000019073523f)))) && (_e2077 <= _e1510.member.member_1));
                            if _e2099 {
                                let _e2104 = (_e1952[1][0] - _e1952[0][0]);
                                let _e2105 = (_e1952[1][1] - _e1952[0][1]);
                                let _e2106 = (_e1952[1][2] - _e1952[0][2]);
                                let _e2107 = vec3<f32>(_e2104, _e2105, _e2106);
                                let _e2108 = (_e1952[2][0] - _e1952[1][0]);
                                let _e2109 = (_e1952[2][1] - _e1952[1][1]);
                                let _e2110 = (_e1952[2][2] - _e1952[1][2]);
                                let _e2111 = vec3<f32>(_e2108, _e2109, _e2110);
                                let _e2112 = (_e1952[0][0] - _e1952[2][0]);
                                let _e2113 = (_e1952[0][1] - _e1952[2][1]);
                                let _e2114 = (_e1952[0][2] - _e1952[2][2]);
                                let _e2115 = vec3<f32>(_e2112, _e2113, _e2114);
                                let _e2126 = max(max(bitcast<f32>((bitcast<u32>(_e2104) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2105) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2106) & 2147483647u)));
                                let _e2137 = max(max(bitcast<f32>((bitcast<u32>(_e2108) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2109) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2110) & 2147483647u)));
                                let _e2150 = max(max(_e2126, _e2137), max(max(bitcast<f32>((bitcast<u32>(_e2112) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2113) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2114) & 2147483647u))));
                                if (_e2126 == _e2150) {
                                    phi_4069_ = _e1984;
                                    phi_4070_ = _e1981;
                                    phi_4071_ = _e1975;
                                    phi_4072_ = _e1972;
                                    phi_4073_ = vec3<f32>(_e1952[0][0], _e1952[0][1], _e1952[0][2]);
                                    phi_4074_ = _e2115;
                                    phi_4075_ = _e2111;
                                    phi_4076_ = _e2107;
                                } else {
                                    let _e2152 = (_e2137 == _e2150);
                                    let _e2157 = vec3(_e2152);
                                    phi_4069_ = select(_e1975, _e1993, _e2152);
                                    phi_4070_ = select(_e1972, _e1990, _e2152);
                                    phi_4071_ = select(_e1993, _e1984, _e2152);
                                    phi_4072_ = select(_e1990, _e1981, _e2152);
                                    phi_4073_ = select(vec3<f32>(_e1952[2][0], _e1952[2][1], _e1952[2][2]), vec3<f32>(_e1952[1][0], _e1952[1][1], _e1952[1][2]), _e2157);
                                    phi_4074_ = select(_e2111, _e2107, _e2157);
                                    phi_4075_ = select(_e2107, _e2115, _e2157);
                                    phi_4076_ = select(_e2115, _e2111, _e2157);
                                }
                                let _e2163 = phi_4069_;
                                let _e2165 = phi_4070_;
                                let _e2167 = phi_4071_;
                                let _e2169 = phi_4072_;
                                let _e2171 = phi_4073_;
                                let _e2173 = phi_4074_;
                                let _e2175 = phi_4075_;
                                let _e2177 = phi_4076_;
                                let _e2184 = ((_e2175.y * _e2173.z) - (_e2173.y * _e2175.z));
                                let _e2189 = ((_e2175.z * _e2173.x) - (_e2173.z * _e2175.x));
                                let _e2192 = ((_e2175.x * _e2173.y) - (_e2173.x * _e2175.y));
                                let _e2195 = ((_e2016 >= _e2020) && (_e2016 >= _e2024));
                                let _e2196 = (_e2020 >= _e2024);
                                let _e2210 = (((_e2184 * (select(select(_e1952[2][0], _e1952[1][0], _e2196), _e1952[0][0], _e2195) - _e620.member[0])) + (_e2189 * (select(select(_e1952[2][1], _e1952[1][1], _e2196), _e1952[0][1], _e2195) - _e620.member[1]))) + (_e2192 * (select(select(_e1952[2][2], _e1952[1][2], _e2196), _e1952[0][2], _e2195) - _e620.member[2])));
                                let _e2215 = (((_e2184 * _e643) + (_e2189 * _e659)) + (_e2192 * _e675));
                                let _e2216 = (_e2165 - _e2169);
                                let _e2217 = (_e2163 - _e2167);
                                let _e2220 = ((_e2216 * _e2216) + (_e2217 * _e2217));
                                let _e2227 = (-(((_e2169 * _e2216) + (_e2167 * _e2217))) / select(0.000000000000000000000000000000000000011754944f, _e2220, (_e2220 > 0.000000000000000000000000000000000000011754944f)));
                                let _e2229 = select(1f, _e2227, (_e2227 < 1f));
                                let _e2231 = select(0f, _e2229, (_e2229 > 0f));
                                let _e2240 = ((_e2171.x + (_e2177.x * _e2231)) - _e620.member[0]);
                                let _e2243 = ((_e2171.y + (_e2177.y * _e2231)) - _e620.member[1]);
                                let _e2246 = ((_e2171.z + (_e2177.z * _e2231)) - _e620.member[2]);
                                let _e2311 = ((bitcast<f32>((bitcast<u32>(((((_e2184 * _e2240) + (_e2189 * _e2243)) + (_e2192 * _e2246)) - _e2210)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e2240) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2243) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2246) & 2147483647u))), _e2150)) * max(max(bitcast<f32>((bitcast<u32>(_e2184) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2189) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2192) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e2215) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e2175.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2175.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2175.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e2173.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2173.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2173.z) & 2147483647u)))))));
                                let _e2312 = (_e2210 / _e2215);
                                if (_e2099 && !(_e2311)) {
                                    let _e2315 = (_e2246 / _e675);
                                    let _e2323 = (((_e2184 * (_e2240 - (_e643 * _e2315))) + (_e2189 * (_e2243 - (_e659 * _e2315)))) / _e2215);
                                    phi_4255_ = select(select(_e2315, (_e2315 + _e2323), (bitcast<f32>((bitcast<u32>(_e2323) & 2147483647u)) <= _e2150)), _e2312, _e2311);
                                } else {
                                    phi_4255_ = _e2312;
                                }
                                let _e2332 = phi_4255_;
                                let _e2334 = select(_e2072, _e2332, (_e2332 < _e2072));
                                let _e2336 = select(_e2067, _e2334, (_e2334 > _e2067));
                                let _e2339 = select(_e2336, 0f, (bitcast<u32>(_e2336) == 2147483648u));
                                let _e2340 = (1f / _e2026);
                                phi_4281_ = SlimbvhTypeE(_e2339, (_e2020 * _e2340), (_e2024 * _e2340), ((_e2099 && (_e2339 >= _e687)) && (_e2339 <= _e1510.member.member_1)));
                                phi_4282_ = SlimbvhTypeE();
                            } else {
                                phi_4281_ = SlimbvhTypeE();
                                phi_4282_ = SlimbvhTypeE(0f, 0f, 0f, _e2099);
                            }
                            let _e2349 = phi_4281_;
                            let _e2351 = phi_4282_;
                            phi_4285_ = _e2349;
                            phi_4286_ = _e2351;
                            phi_4287_ = select(true, false, _e2099);
                        } else {
                            phi_4285_ = SlimbvhTypeE();
                            phi_4286_ = SlimbvhTypeE(0f, 0f, 0f, _e2010);
                            phi_4287_ = true;
                        }
                        let _e2354 = phi_4285_;
                        let _e2356 = phi_4286_;
                        let _e2358 = phi_4287_;
                        if _e2358 {
                            phi_4291_ = _e2356;
                        } else {
                            phi_4291_ = _e2354;
                        }
                        let _e2360 = phi_4291_;
                        if _e2360.member_3 {
                            phi_4300_ = SlimbvhTypeF(_e2360.member, _e2360.member_1, _e2360.member_2, _e1541);
                        } else {
                            phi_4300_ = _e119;
                        }
                        let _e2367 = phi_4300_;
                        if (_e2367.member_3 != 4294967295u) {
                            let _e2373 = slimbvh_target.member[0u][0u];
                            let _e2377 = slimbvh_target.member[0u][1u];
                            let _e2381 = slimbvh_target.member[0u][2u];
                            let _e2385 = slimbvh_target.member[0u][3u];
                            let _e2389 = slimbvh_target.member[1u][0u];
                            let _e2393 = slimbvh_target.member[1u][1u];
                            let _e2397 = slimbvh_target.member[1u][2u];
                            let _e2401 = slimbvh_target.member[1u][3u];
                            let _e2402 = bitcast<f32>(_e2373);
                            let _e2403 = bitcast<f32>(_e2377);
                            let _e2404 = bitcast<f32>(_e2381);
                            let _e2406 = bitcast<f32>(_e2389);
                            let _e2407 = array<u32, 3>(_e2393, _e2397, _e2401);
                            if (_e190 < -126i) {
                                phi_4353_ = -126i;
                            } else {
                                phi_4353_ = select(_e190, 127i, (_e190 > 127i));
                            }
                            let _e2413 = phi_4353_;
                            let _e2418 = bitcast<f32>((bitcast<u32>((_e2413 + 127i)) << bitcast<u32>(23i)));
                            let _e2424 = bitcast<f32>((bitcast<u32>(((_e190 - _e2413) + 127i)) << bitcast<u32>(23i)));
                            if (_e2385 == 0u) {
                                phi_4493_ = SlimbvhTypeH(array<f32, 3>(_e2402, _e2403, _e2404), _e2385, _e2406, _e2407);
                            } else {
                                let _e2426 = bitcast<u32>(_e2402);
                                let _e2428 = ((_e2426 & 2139095040u) != 0u);
                                let _e2443 = bitcast<u32>(_e2403);
                                let _e2445 = ((_e2443 & 2139095040u) != 0u);
                                let _e2460 = bitcast<u32>(_e2404);
                                let _e2462 = ((_e2460 & 2139095040u) != 0u);
                                let _e2478 = bitcast<u32>(_e2406);
                                let _e2480 = ((_e2478 & 2139095040u) != 0u);
                                phi_4493_ = SlimbvhTypeH(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2426 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2426 & 2147483648u))), _e2402, _e2428) * _e2418) * select(0.00000011920929f, 1f, _e2428)) * _e2424), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2443 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2443 & 2147483648u))), _e2403, _e2445) * _e2418) * select(0.00000011920929f, 1f, _e2445)) * _e2424), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2460 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2460 & 2147483648u))), _e2404, _e2462) * _e2418) * select(0.00000011920929f, 1f, _e2462)) * _e2424)), _e2385, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2478 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2478 & 2147483648u))), _e2406, _e2480) * _e2418) * select(0.00000011920929f, 1f, _e2480)) * _e2424), _e2407);
                            }
                            let _e2497 = phi_4493_;
                            if (_e1541 == _e691) {
                                phi_4822_ = false;
                            } else {
                                let _e2499 = (_e1541 / 16u);
                                if (_e2499 < arrayLength((&slimbvh_sides.member))) {
                                    let _e2502 = slimbvh_sides.member[_e2499];
                                    phi_4517_ = _e2502;
                                } else {
                                    phi_4517_ = 0u;
                                }
                                let _e2504 = phi_4517_;
                                let _e2513 = (bitcast<i32>((_e2504 << bitcast<u32>(((30u - ((_e1541 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                let _e2514 = (_e2513 == 0i);
                                if _e2514 {
                                    phi_4821_ = true;
                                } else {
                                    if _e237 {
                                        phi_4547_ = vec3<f32>(_e1952[0][0], _e1952[0][1], _e1952[0][2]);
                                    } else {
                                        if (_e232 == 1u) {
                                            phi_4546_ = vec3<f32>(_e1952[0][2], _e1952[0][0], _e1952[0][1]);
                                        } else {
                                            phi_4546_ = vec3<f32>(_e1952[0][1], _e1952[0][2], _e1952[0][0]);
                                        }
                                        let _e2519 = phi_4546_;
                                        phi_4547_ = _e2519;
                                    }
                                    let _e2522 = phi_4547_;
                                    if _e237 {
                                        phi_4566_ = vec3<f32>(_e1952[1][0], _e1952[1][1], _e1952[1][2]);
                                    } else {
                                        if (_e232 == 1u) {
                                            phi_4565_ = vec3<f32>(_e1952[1][2], _e1952[1][0], _e1952[1][1]);
                                        } else {
                                            phi_4565_ = vec3<f32>(_e1952[1][1], _e1952[1][2], _e1952[1][0]);
                                        }
                                        let _e2527 = phi_4565_;
                                        phi_4566_ = _e2527;
                                    }
                                    let _e2530 = phi_4566_;
                                    if _e237 {
                                        phi_4585_ = vec3<f32>(_e1952[2][0], _e1952[2][1], _e1952[2][2]);
                                    } else {
                                        if (_e232 == 1u) {
                                            phi_4584_ = vec3<f32>(_e1952[2][2], _e1952[2][0], _e1952[2][1]);
                                        } else {
                                            phi_4584_ = vec3<f32>(_e1952[2][1], _e1952[2][2], _e1952[2][0]);
                                        }
                                        let _e2535 = phi_4584_;
                                        phi_4585_ = _e2535;
                                    }
                                    let _e2538 = phi_4585_;
                                    let _e2541 = (_e2530.x - _e2522.x);
                                    let _e2544 = (_e2530.y - _e2522.y);
                                    let _e2547 = (_e2530.z - _e2522.z);
                                    let _e2549 = (_e2538.x - _e2522.x);
                                    let _e2551 = (_e2538.y - _e2522.y);
                                    let _e2553 = (_e2538.z - _e2522.z);
                                    if (_e2497.member_1 == 1u) {
                                        phi_4621_ = (vec3<f32>(_e2497.member[0], _e2497.member[1], _e2497.member[2]) - _e2522);
                                    } else {
                                        phi_4621_ = vec3<f32>(_e2497.member[0], _e2497.member[1], _e2497.member[2]);
                                    }
                                    let _e2568 = phi_4621_;
                                    let _e2574 = bitcast<f32>((bitcast<u32>((_e2541 * _e2551)) ^ _e2497.member_3[0]));
                                    let _e2578 = bitcast<f32>((bitcast<u32>((_e2544 * _e2549)) ^ _e2497.member_3[0]));
                                    let _e2582 = bitcast<f32>((bitcast<u32>((_e2544 * _e2553)) ^ _e2497.member_3[0]));
                                    let _e2586 = bitcast<f32>((bitcast<u32>((_e2547 * _e2551)) ^ _e2497.member_3[0]));
                                    let _e2590 = bitcast<f32>((bitcast<u32>((_e2547 * _e2549)) ^ _e2497.member_3[0]));
                                    let _e2594 = bitcast<f32>((bitcast<u32>((_e2541 * _e2553)) ^ _e2497.member_3[0]));
                                    let _e2595 = (_e2582 - _e2586);
                                    let _e2596 = (_e2590 - _e2594);
                                    let _e2597 = (_e2574 - _e2578);
                                    let _e2621 = (bitcast<f32>((bitcast<u32>(_e2582) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2586) & 2147483647u)));
                                    let _e2628 = (bitcast<f32>((bitcast<u32>(_e2590) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2594) & 2147483647u)));
                                    let _e2635 = (bitcast<f32>((bitcast<u32>(_e2574) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2578) & 2147483647u)));
                                    if (_e2497.member_2 == 0f) {
                                        phi_4803_ = 0f;
                                    } else {
                                        let _e2665 = bitcast<f32>((bitcast<u32>(_e2595) & 2147483647u));
                                        let _e2668 = bitcast<f32>((bitcast<u32>(_e2596) & 2147483647u));
                                        let _e2671 = bitcast<f32>((bitcast<u32>(_e2597) & 2147483647u));
                                        let _e2673 = select(_e2671, _e2668, (_e2668 > _e2671));
                                        let _e2677 = select(_e2671, _e2668, (_e2668 < _e2671));
                                        let _e2681 = select(_e2668, _e2665, (_e2665 < _e2668));
                                        let _e2683 = select(_e2668, _e2665, (_e2665 > _e2668));
                                        let _e2685 = select(_e2671, _e2683, (_e2683 < _e2671));
                                        phi_4803_ = bitcast<f32>((bitcast<u32>((_e2497.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2673, _e2665, (_e2665 > _e2673)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2685, _e2681, (_e2681 > _e2685)))) ^ _e2497.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2677, _e2665, (_e2665 < _e2677)))) ^ _e2497.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2621 + _e2628) + _e2635))) ^ _e2497.member_3[0]))) * 1.0000005f)) ^ _e2497.member_3[0])))) ^ _e2497.member_3[0]));
                                    }
                                    let _e2712 = phi_4803_;
                                    phi_4821_ = (_e2514 || !(((((bitcast<f32>((bitcast<u32>((_e2568.x * _e2595)) ^ _e2497.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2568.y * _e2596)) ^ _e2497.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2568.z * _e2597)) ^ _e2497.member_3[0]))) * f32(-(_e2513))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2568.x) & 2147483647u)) * _e2621)) ^ _e2497.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2568.y) & 2147483647u)) * _e2628)) ^ _e2497.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2568.z) & 2147483647u)) * _e2635)) ^ _e2497.member_3[0]))))) ^ _e2497.member_3[0])) + _e2712) + 0.0000000000000000000000000000000000001880791f))));
                                }
                                let _e2726 = phi_4821_;
                                phi_4822_ = _e2726;
                            }
                            let _e2728 = phi_4822_;
                            if _e2728 {
                                if (_e2367.member < _e1510.member.member.member) {
                                    phi_4842_ = true;
                                } else {
                                    if (_e2367.member == _e1510.member.member.member) {
                                        phi_4841_ = (_e2367.member_3 < _e1510.member.member.member_3);
                                    } else {
                                        phi_4841_ = false;
                                    }
                                    let _e2740 = phi_4841_;
                                    phi_4842_ = _e2740;
                                }
                                let _e2742 = phi_4842_;
                                if _e2742 {
                                    phi_4849_ = SlimbvhTypeP(SlimbvhTypeI(_e2367, _e2367.member), _e1510.member_1);
                                } else {
                                    phi_4849_ = _e1510;
                                }
                                let _e2748 = phi_4849_;
                                if _e2748.member_1 {
                                    phi_4855_ = SlimbvhTypeP(SlimbvhTypeI(_e2748.member.member, bitcast<f32>(4286578687u)), _e2748.member_1);
                                } else {
                                    phi_4855_ = _e2748;
                                }
                                let _e2757 = phi_4855_;
                                phi_4856_ = _e2757;
                            } else {
                                phi_4856_ = _e1510;
                            }
                            let _e2759 = phi_4856_;
                            phi_4857_ = _e2759;
                        } else {
                            phi_4857_ = _e1510;
                        }
                        let _e2761 = phi_4857_;
                        phi_3008_ = _e2761;
                    } else {
                        phi_3008_ = SlimbvhTypeP();
                    }
                    let _e2763 = phi_3008_;
                    continue;
                    continuing {
                        phi_3007_ = _e2763;
                        phi_3010_ = _e1525;
                        break if !(_e1531);
                    }
                }
                let _e2766 = local_3;
                let _e2767 = (_e2766 - 1u);
                let _e2770 = local[(_e2767 % 128u)];
                let _e2771 = (_e2770 & 511u);
                let _e2773 = (_e2771 >> bitcast<u32>(3u));
                let _e2776 = ((_e2773 == 0u) || (_e2767 == 4294967295u));
                if _e2776 {
                } else {
                    local[(_e2767 % 128u)] = (((_e2770 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2773);
                }
                let _e2783 = local_4;
                let _e2791 = (((_e2770 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2771 & 3u) & 3u));
                let _e2793 = (_e2791 >> bitcast<u32>(2i));
                if (_e2793 < _e123) {
                    let _e2798 = slimbvh_nodes.member[_e2793][1u][3u];
                    let _e2802 = slimbvh_nodes.member[_e2793][2u][3u];
                    let _e2807 = (_e2802 >> bitcast<u32>(20u));
                    let _e2808 = (_e2791 & 3u);
                    if (((_e2807 >> bitcast<u32>((((3u * _e2808) & 31u) & 31u))) & 7u) == 7u) {
                        let _e2820 = ((_e2807 | (_e2807 << bitcast<u32>(10i))) & 4128831u);
                        phi_4946_ = (((_e2798 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e2820 | (_e2820 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e2808) & 31u) & 31u))) & 255u));
                    } else {
                        phi_4946_ = (2147483648u | _e2791);
                    }
                    let _e2838 = phi_4946_;
                    phi_4947_ = _e2838;
                } else {
                    phi_4947_ = 4294967295u;
                }
                let _e2840 = phi_4947_;
                let _e2842 = local_5;
                let _e3140 = local_7;
                phi_4956_ = _e3140;
                phi_4957_ = select(select(_e2783, _e2767, _e2776), 4294967295u, (_e687 > _e2842.member.member_1));
                phi_4958_ = _e2840;
            } else {
                phi_4956_ = _e800;
                let _e3143 = local_8;
                phi_4957_ = _e3143;
                let _e3146 = local_9;
                phi_4958_ = _e3146;
            }
            let _e2848 = phi_4956_;
            let _e2850 = phi_4957_;
            let _e2852 = phi_4958_;
            phi_1856_ = _e2848;
            phi_1859_ = _e2850;
            phi_1861_ = _e2852;
            let _e3152 = local_10;
            phi_1863_ = _e3152;
        } else {
            phi_1856_ = SlimbvhTypeP();
            phi_1859_ = u32();
            phi_1861_ = u32();
            phi_1863_ = u32();
        }
        let _e2854 = phi_1856_;
        let _e2856 = phi_1859_;
        let _e2858 = phi_1861_;
        let _e2860 = phi_1863_;
        continue;
        continuing {
            phi_1855_ = _e2854;
            phi_1858_ = _e2856;
            phi_1860_ = _e2858;
            phi_1862_ = _e2860;
            break if !(_e807);
        }
    }
    let _e2863 = local_6;
    if (_e2863.member.member.member_3 != 4294967295u) {
        let _e2869 = -((_e190 + _e620.member_4));
        let _e2870 = bitcast<u32>(_e2863.member.member.member);
        let _e2874 = (bitcast<i32>((_e2870 >> bitcast<u32>(23i))) & 255i);
        let _e2875 = (_e2874 + _e2869);
        if (_e2874 == 255i) {
            phi_5015_ = _e2863.member.member.member;
        } else {
            if (_e2874 > 0i) {
                if (_e2875 > 0i) {
                    let _e2879 = (_e2875 < 255i);
                    if _e2879 {
                        phi_4994_ = bitcast<f32>((_e2870 + bitcast<u32>((_e2869 << bitcast<u32>(23i)))));
                    } else {
                        phi_4994_ = f32();
                    }
                    let _e2886 = phi_4994_;
                    phi_4996_ = _e2886;
                    phi_4997_ = select(true, false, _e2879);
                } else {
                    phi_4996_ = f32();
                    phi_4997_ = true;
                }
                let _e2889 = phi_4996_;
                let _e2891 = phi_4997_;
                phi_4998_ = _e2889;
                phi_4999_ = _e2891;
            } else {
                phi_4998_ = f32();
                phi_4999_ = true;
            }
            let _e2893 = phi_4998_;
            let _e2895 = phi_4999_;
            if _e2895 {
                let _e2896 = (_e2870 & 2147483648u);
                let _e2903 = ((_e2870 & 8388607u) | (select(0u, 1u, ((_e2870 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e2907 = (_e2903 == 0u);
                if _e2907 {
                    phi_5675_ = bitcast<f32>(_e2896);
                } else {
                    let _e2912 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2903)), 32u, _e2907) - 8u);
                    let _e2915 = (_e2903 << bitcast<u32>((_e2912 & 31u)));
                    let _e2917 = ((_e2875 + select(0i, 1i, (_e2874 == 0i))) - bitcast<i32>(_e2912));
                    if (_e2917 >= 255i) {
                        phi_5665_ = bitcast<f32>((_e2896 | 2139095040u));
                        phi_5666_ = f32();
                        phi_5667_ = true;
                    } else {
                        let _e2919 = (_e2917 > 0i);
                        if _e2919 {
                            phi_5659_ = bitcast<f32>(((_e2896 | (bitcast<u32>(_e2917) << bitcast<u32>(23i))) | (_e2915 & 8388607u)));
                            phi_5660_ = f32();
                        } else {
                            if (_e2917 < -24i) {
                                phi_5625_ = 26u;
                            } else {
                                phi_5625_ = bitcast<u32>((1i - _e2917));
                            }
                            let _e2924 = phi_5625_;
                            let _e2925 = (_e2924 & 31u);
                            let _e2927 = (_e2915 >> bitcast<u32>(_e2925));
                            let _e2931 = (_e2915 & ((1u << bitcast<u32>(_e2925)) - 1u));
                            let _e2935 = (1u << bitcast<u32>(((_e2924 - 1u) & 31u)));
                            if (_e2931 > _e2935) {
                                phi_5646_ = true;
                            } else {
                                if (_e2931 == _e2935) {
                                    phi_5643_ = ((_e2927 & 1u) == 1u);
                                } else {
                                    phi_5643_ = false;
                                }
                                let _e2941 = phi_5643_;
                                phi_5646_ = _e2941;
                            }
                            let _e2943 = phi_5646_;
                            phi_5659_ = f32();
                            phi_5660_ = bitcast<f32>((_e2896 | (_e2927 + select(0u, 1u, _e2943))));
                        }
                        let _e2956 = phi_5659_;
                        let _e2958 = phi_5660_;
                        phi_5665_ = _e2956;
                        phi_5666_ = _e2958;
                        phi_5667_ = _e2919;
                    }
                    let _e2962 = phi_5665_;
                    let _e2964 = phi_5666_;
                    let _e2966 = phi_5667_;
                    phi_5675_ = select(_e2964, _e2962, _e2966);
                }
                let _e2970 = phi_5675_;
                phi_5014_ = _e2970;
            } else {
                phi_5014_ = _e2893;
            }
            let _e2972 = phi_5014_;
            phi_5015_ = _e2972;
        }
        let _e2974 = phi_5015_;
        let _e2975 = bitcast<u32>(_e2974);
        if ((_e2975 & 2147483647u) >= 2139095040u) {
            phi_5027_ = bitcast<f32>(((_e2975 & 2147483648u) | 2139095039u));
        } else {
            phi_5027_ = _e2974;
        }
        let _e2982 = phi_5027_;
        phi_5032_ = SlimbvhTypeF(_e2982, _e2863.member.member.member_1, _e2863.member.member.member_2, _e2863.member.member.member_3);
    } else {
        phi_5032_ = _e119;
    }
    let _e2987 = phi_5032_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2987.member), bitcast<u32>(_e2987.member_1), bitcast<u32>(_e2987.member_2), _e2987.member_3);
    return;
}

struct SlimbvhTypeQ {
    member: array<vec4<f32>, 3>,
}

struct SlimbvhTypeR {
    member: vec2<f32>,
}

struct SlimbvhTypeS {
    member: array<vec4<f32>, 5>,
}

var<private> slimbvh_corners: SlimbvhTypeQ;

var<private> slimbvh_weights: SlimbvhTypeR;

var<private> slimbvh_from: SlimbvhTypeN;

var<private> slimbvh_point: SlimbvhTypeS;

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
