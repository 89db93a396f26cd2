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
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct SlimbvhTypeI {
    member: SlimbvhTypeG,
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
var<storage> slimbvh_sides: SlimbvhTypeC;

@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeK;

@group(0) @binding(2) 
var<storage> slimbvh_triangles: SlimbvhTypeC;

@group(0) @binding(3) 
var<uniform> slimbvh_root: SlimbvhTypeB;

@group(0) @binding(5) 
var<uniform> slimbvh_target: SlimbvhTypeB;

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
    var phi_1360_: SlimbvhTypeD;
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
    var phi_5346_: SlimbvhTypeE;
    var phi_5358_: SlimbvhTypeE;
    var phi_5370_: SlimbvhTypeE;
    var phi_5382_: SlimbvhTypeE;
    var phi_5394_: SlimbvhTypeE;
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
    var phi_3010_: SlimbvhTypeE;
    var phi_3011_: SlimbvhTypeE;
    var phi_3033_: SlimbvhTypeE;
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
    var phi_4281_: SlimbvhTypeF;
    var phi_4282_: SlimbvhTypeF;
    var phi_4285_: SlimbvhTypeF;
    var phi_4286_: SlimbvhTypeF;
    var phi_4287_: bool;
    var phi_4291_: SlimbvhTypeF;
    var phi_4300_: SlimbvhTypeG;
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
    var phi_5032_: SlimbvhTypeG;
    var local_7: SlimbvhTypeP;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e119 = SlimbvhTypeG(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
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
        phi_1360_ = SlimbvhTypeD(array<f32, 3>((_e239 * _e544), (_e243 * _e544), (_e246 * _e544)), array<f32, 3>((_e248 * _e549), (_e250 * _e549), (_e252 * _e549)), bitcast<f32>(((_e197 & 2147483648u) | select(_e581, 0u, _e583))), bitcast<f32>(((_e205 & 2147483648u) | select(_e611, 0u, _e613))), _e538);
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
        phi_1360_ = SlimbvhTypeD(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e317 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e317 & 2147483648u))), _e239, _e319) * _e310) * select(0.00000011920929f, 1f, _e319)) * _e316), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e334 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e334 & 2147483648u))), _e243, _e336) * _e310) * select(0.00000011920929f, 1f, _e336)) * _e316), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e351 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e351 & 2147483648u))), _e246, _e353) * _e310) * select(0.00000011920929f, 1f, _e353)) * _e316)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e386 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e386 & 2147483648u))), _e248, _e388) * _e379) * select(0.00000011920929f, 1f, _e388)) * _e385), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e403 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e403 & 2147483648u))), _e250, _e405) * _e379) * select(0.00000011920929f, 1f, _e405)) * _e385), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e420 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e420 & 2147483648u))), _e252, _e422) * _e379) * select(0.00000011920929f, 1f, _e422)) * _e385)), bitcast<f32>(((_e197 & 2147483648u) | select(_e479, 0u, _e481))), bitcast<f32>(((_e205 & 2147483648u) | select(_e527, 0u, _e529))), _e299);
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
                        phi_5346_ = SlimbvhTypeE(_e1137, _e1145);
                    } else {
                        phi_5346_ = SlimbvhTypeE(_e1145, _e1137);
                    }
                    let _e1166 = phi_5346_;
                    if (_e1153 < _e1161) {
                        phi_5358_ = SlimbvhTypeE(_e1153, _e1161);
                    } else {
                        phi_5358_ = SlimbvhTypeE(_e1161, _e1153);
                    }
                    let _e1173 = phi_5358_;
                    if (_e1166.member < _e1173.member) {
                        phi_5370_ = SlimbvhTypeE(_e1166.member, _e1173.member);
                    } else {
                        phi_5370_ = SlimbvhTypeE(_e1173.member, _e1166.member);
                    }
                    let _e1180 = phi_5370_;
                    if (_e1166.member_1 < _e1173.member_1) {
                        phi_5382_ = SlimbvhTypeE(_e1166.member_1, _e1173.member_1);
                    } else {
                        phi_5382_ = SlimbvhTypeE(_e1173.member_1, _e1166.member_1);
                    }
                    let _e1187 = phi_5382_;
                    if (_e1187.member < _e1180.member_1) {
                        phi_5394_ = SlimbvhTypeE(_e1187.member, _e1180.member_1);
                    } else {
                        phi_5394_ = SlimbvhTypeE(_e1180.member_1, _e1187.member);
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
                phi_3010_ = SlimbvhTypeE(0u, _e1506.member_2);
                loop {
                    let _e1510 = phi_3007_;
                    let _e1512 = phi_3010_;
                    local_5 = _e1510;
                    local_7 = _e1510;
                    if (_e1512.member < _e1512.member_1) {
                        phi_3011_ = SlimbvhTypeE((_e1512.member + 1u), _e1512.member_1);
                        phi_3033_ = SlimbvhTypeE(1u, _e1512.member);
                    } else {
                        phi_3011_ = _e1512;
                        phi_3033_ = SlimbvhTypeE(0u, SlimbvhTypeE().member_1);
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
                                phi_4281_ = SlimbvhTypeF(_e2339, (_e2020 * _e2340), (_e2024 * _e2340), ((_e2099 && (_e2339 >= _e687)) && (_e2339 <= _e1510.member.member_1)));
                                phi_4282_ = SlimbvhTypeF();
                            } else {
                                phi_4281_ = SlimbvhTypeF();
                                phi_4282_ = SlimbvhTypeF(0f, 0f, 0f, _e2099);
                            }
                            let _e2349 = phi_4281_;
                            let _e2351 = phi_4282_;
                            phi_4285_ = _e2349;
                            phi_4286_ = _e2351;
                            phi_4287_ = select(true, false, _e2099);
                        } else {
                            phi_4285_ = SlimbvhTypeF();
                            phi_4286_ = SlimbvhTypeF(0f, 0f, 0f, _e2010);
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
                            phi_4300_ = SlimbvhTypeG(_e2360.member, _e2360.member_1, _e2360.member_2, _e1541);
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
        phi_5032_ = SlimbvhTypeG(_e2982, _e2863.member.member.member_1, _e2863.member.member.member_2, _e2863.member.member.member_3);
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
