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
    member: array<vec4<u32>, 3>,
    member_1: array<u32, 4>,
}

struct SlimbvhTypeL {
    member: array<SlimbvhTypeK>,
}

struct SlimbvhTypeM {
    member: u32,
    member_1: f32,
}

struct SlimbvhTypeN {
    member: vec4<f32>,
}

struct SlimbvhTypeO {
    member: vec2<u32>,
}

struct SlimbvhTypeP {
    member: SlimbvhTypeJ,
    member_1: bool,
}

@group(0) @binding(0) 
var<uniform> slimbvh_exponent: SlimbvhTypeA;

@group(0) @binding(4) 
var<storage> slimbvh_sides: SlimbvhTypeD;

@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeL;

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
    var phi_704_: u32;
    var phi_710_: u32;
    var phi_716_: u32;
    var phi_981_: i32;
    var phi_992_: i32;
    var phi_1106_: i32;
    var phi_1235_: i32;
    var phi_1257_: u32;
    var phi_1258_: u32;
    var phi_1259_: bool;
    var phi_1293_: i32;
    var phi_1315_: u32;
    var phi_1316_: u32;
    var phi_1317_: bool;
    var phi_878_: i32;
    var phi_884_: u32;
    var phi_903_: u32;
    var phi_904_: u32;
    var phi_905_: bool;
    var phi_923_: i32;
    var phi_929_: u32;
    var phi_948_: u32;
    var phi_949_: u32;
    var phi_950_: bool;
    var phi_1327_: SlimbvhTypeE;
    var phi_1566_: SlimbvhTypeP;
    var phi_1629_: array<f32, 3>;
    var phi_1630_: array<f32, 3>;
    var phi_1648_: array<f32, 3>;
    var phi_1649_: array<f32, 3>;
    var phi_1822_: SlimbvhTypeP;
    var phi_1825_: u32;
    var phi_1827_: u32;
    var phi_1829_: u32;
    var phi_1838_: u32;
    var phi_1841_: u32;
    var phi_1843_: u32;
    var phi_1945_: SlimbvhTypeM;
    var phi_1946_: SlimbvhTypeM;
    var phi_2005_: SlimbvhTypeM;
    var phi_2006_: SlimbvhTypeM;
    var phi_2065_: SlimbvhTypeM;
    var phi_2066_: SlimbvhTypeM;
    var phi_2550_: u32;
    var phi_2563_: u32;
    var phi_2576_: u32;
    var phi_2589_: u32;
    var phi_4559_: SlimbvhTypeF;
    var phi_4571_: SlimbvhTypeF;
    var phi_4583_: SlimbvhTypeF;
    var phi_4595_: SlimbvhTypeF;
    var phi_4607_: SlimbvhTypeF;
    var phi_2670_: u32;
    var phi_2675_: u32;
    var phi_2676_: u32;
    var phi_2700_: u32;
    var phi_1839_: u32;
    var phi_1842_: u32;
    var phi_1844_: u32;
    var local_1: bool;
    var local_2: u32;
    var local_3: u32;
    var phi_2716_: SlimbvhTypeP;
    var phi_2719_: SlimbvhTypeF;
    var phi_2720_: SlimbvhTypeF;
    var phi_2742_: SlimbvhTypeF;
    var phi_2821_: array<vec4<f32>, 3>;
    var phi_2822_: array<vec4<f32>, 3>;
    var phi_2902_: array<vec4<f32>, 3>;
    var phi_2903_: array<vec4<f32>, 3>;
    var phi_2926_: array<f32, 3>;
    var phi_2927_: array<f32, 3>;
    var phi_2941_: array<f32, 3>;
    var phi_2942_: array<f32, 3>;
    var phi_2956_: array<f32, 3>;
    var phi_2957_: array<f32, 3>;
    var phi_3316_: f32;
    var phi_3317_: f32;
    var phi_3318_: f32;
    var phi_3319_: f32;
    var phi_3320_: vec3<f32>;
    var phi_3321_: vec3<f32>;
    var phi_3322_: vec3<f32>;
    var phi_3323_: vec3<f32>;
    var phi_3502_: f32;
    var phi_3528_: SlimbvhTypeG;
    var phi_3529_: SlimbvhTypeG;
    var phi_3532_: SlimbvhTypeG;
    var phi_3533_: SlimbvhTypeG;
    var phi_3534_: bool;
    var phi_3538_: SlimbvhTypeG;
    var phi_3547_: SlimbvhTypeH;
    var phi_3600_: i32;
    var phi_3740_: SlimbvhTypeI;
    var phi_3764_: u32;
    var phi_3792_: vec3<f32>;
    var phi_3793_: vec3<f32>;
    var phi_3810_: vec3<f32>;
    var phi_3811_: vec3<f32>;
    var phi_3828_: vec3<f32>;
    var phi_3829_: vec3<f32>;
    var phi_3865_: vec3<f32>;
    var phi_4047_: f32;
    var phi_4065_: bool;
    var phi_4066_: bool;
    var phi_4085_: bool;
    var phi_4086_: bool;
    var phi_4093_: SlimbvhTypeP;
    var phi_4099_: SlimbvhTypeP;
    var phi_4100_: SlimbvhTypeP;
    var phi_4101_: SlimbvhTypeP;
    var phi_2717_: SlimbvhTypeP;
    var local_4: u32;
    var local_5: u32;
    var phi_4160_: u32;
    var local_6: SlimbvhTypeP;
    var phi_4169_: SlimbvhTypeP;
    var phi_4170_: u32;
    var phi_4171_: u32;
    var phi_1823_: SlimbvhTypeP;
    var phi_1826_: u32;
    var phi_1828_: u32;
    var phi_1830_: u32;
    var local_7: SlimbvhTypeP;
    var phi_4207_: f32;
    var phi_4209_: f32;
    var phi_4210_: bool;
    var phi_4211_: f32;
    var phi_4212_: bool;
    var phi_4838_: u32;
    var phi_4856_: bool;
    var phi_4859_: bool;
    var phi_4872_: f32;
    var phi_4873_: f32;
    var phi_4878_: f32;
    var phi_4879_: f32;
    var phi_4880_: bool;
    var phi_4888_: f32;
    var phi_4227_: f32;
    var phi_4228_: f32;
    var phi_4240_: f32;
    var phi_4245_: SlimbvhTypeH;
    var local_8: SlimbvhTypeP;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e95 = SlimbvhTypeH(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e99 = arrayLength((&slimbvh_nodes.member));
    let _e111 = slimbvh_root.member[0u][0u];
    let _e115 = slimbvh_root.member[0u][1u];
    let _e119 = slimbvh_root.member[0u][2u];
    let _e123 = slimbvh_root.member[0u][3u];
    let _e127 = slimbvh_root.member[1u][0u];
    let _e131 = slimbvh_root.member[1u][1u];
    let _e135 = slimbvh_root.member[1u][2u];
    let _e147 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e123) + 127i)) << bitcast<u32>(23i)));
    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    let _e148 = slimbvh_origin.member;
    let _e154 = slimbvh_origin.member[3u];
    let _e155 = slimbvh_direction.member;
    let _e161 = slimbvh_direction.member[3u];
    let _e164 = slimbvh_exponent.member[0u];
    let _e165 = bitcast<i32>(_e164);
    let _e167 = (bitcast<u32>(_e148.x) & 2147483647u);
    let _e169 = (bitcast<u32>(_e148.y) & 2147483647u);
    let _e171 = (bitcast<u32>(_e148.z) & 2147483647u);
    let _e172 = bitcast<u32>(_e154);
    let _e173 = (_e172 & 2147483647u);
    let _e175 = (bitcast<u32>(_e155.x) & 2147483647u);
    let _e177 = (bitcast<u32>(_e155.y) & 2147483647u);
    let _e179 = (bitcast<u32>(_e155.z) & 2147483647u);
    let _e180 = bitcast<u32>(_e161);
    let _e181 = (_e180 & 2147483647u);
    let _e183 = select(_e177, _e175, (_e177 < _e175));
    let _e185 = select(_e179, _e183, (_e179 < _e183));
    let _e187 = select(_e167, _e185, (_e167 < _e185));
    let _e189 = select(_e169, _e187, (_e169 < _e187));
    let _e191 = select(_e171, _e189, (_e171 < _e189));
    let _e198 = (((select(_e173, _e191, (_e173 < _e191)) < 2139095040u) && (_e181 <= 2139095040u)) && (_e185 > 0u));
    if (_e175 == _e185) {
        phi_704_ = 0u;
    } else {
        phi_704_ = select(2u, 1u, (_e177 == _e185));
    }
    let _e203 = phi_704_;
    let _e204 = (_e203 == 2u);
    if _e204 {
        phi_710_ = 0u;
    } else {
        phi_710_ = (_e203 + 1u);
    }
    let _e207 = phi_710_;
    let _e208 = (_e207 == 2u);
    if _e208 {
        phi_716_ = 0u;
    } else {
        phi_716_ = (_e207 + 1u);
    }
    let _e211 = phi_716_;
    let _e212 = (_e207 == 0u);
    let _e214 = select(select(_e148.y, _e148.x, _e212), _e148.z, _e208);
    let _e215 = (_e211 == 0u);
    let _e217 = (_e211 == 2u);
    let _e218 = select(select(_e148.y, _e148.x, _e215), _e148.z, _e217);
    let _e219 = (_e203 == 0u);
    let _e221 = select(select(_e148.y, _e148.x, _e219), _e148.z, _e204);
    let _e223 = select(select(_e155.y, _e155.x, _e212), _e155.z, _e208);
    let _e225 = select(select(_e155.y, _e155.x, _e215), _e155.z, _e217);
    let _e227 = select(select(_e155.y, _e155.x, _e219), _e155.z, _e204);
    let _e228 = (_e173 - 1u);
    let _e229 = (_e181 - 1u);
    let _e231 = select(_e228, _e229, (_e229 < _e228));
    let _e232 = (_e167 - 1u);
    let _e233 = (_e169 - 1u);
    let _e235 = select(_e232, _e233, (_e233 < _e232));
    let _e236 = (_e171 - 1u);
    let _e238 = select(_e235, _e236, (_e236 < _e235));
    let _e239 = (_e175 - 1u);
    let _e240 = (_e177 - 1u);
    let _e242 = select(_e239, _e240, (_e240 < _e239));
    let _e243 = (_e179 - 1u);
    let _e245 = select(_e242, _e243, (_e243 < _e242));
    let _e247 = select(_e238, _e245, (_e245 < _e238));
    if (((select(_e247, _e231, (_e231 < _e247)) >= 8388607u) && (_e185 < 2130706432u)) && (bitcast<u32>((_e165 + 126i)) <= 253u)) {
        let _e512 = bitcast<i32>((_e185 >> bitcast<u32>(23i)));
        let _e513 = (_e512 - 127i);
        let _e514 = (_e165 + _e513);
        let _e519 = bitcast<f32>((bitcast<u32>((_e165 + 127i)) << bitcast<u32>(23i)));
        let _e524 = bitcast<f32>((bitcast<u32>((254i - _e512)) << bitcast<u32>(23i)));
        if (_e173 >= 2139095040u) {
            phi_878_ = 255i;
        } else {
            phi_878_ = (bitcast<i32>((_e173 >> bitcast<u32>(23i))) + _e514);
        }
        let _e539 = phi_878_;
        if (_e173 == 0u) {
            phi_884_ = 0u;
        } else {
            phi_884_ = (_e173 | 8388608u);
        }
        let _e543 = phi_884_;
        if (_e539 <= 0i) {
            phi_904_ = u32();
            phi_905_ = true;
        } else {
            let _e550 = (_e543 == 0u);
            if _e550 {
                phi_903_ = u32();
            } else {
                phi_903_ = select(((bitcast<u32>(_e539) << bitcast<u32>(23i)) | (_e543 & 8388607u)), 2139095039u, (_e539 >= 255i));
            }
            let _e554 = phi_903_;
            phi_904_ = _e554;
            phi_905_ = _e550;
        }
        let _e556 = phi_904_;
        let _e558 = phi_905_;
        if (_e181 >= 2139095040u) {
            phi_923_ = 255i;
        } else {
            phi_923_ = (bitcast<i32>((_e181 >> bitcast<u32>(23i))) + _e514);
        }
        let _e569 = phi_923_;
        if (_e181 == 0u) {
            phi_929_ = 0u;
        } else {
            phi_929_ = (_e181 | 8388608u);
        }
        let _e573 = phi_929_;
        if (_e569 <= 0i) {
            phi_949_ = u32();
            phi_950_ = true;
        } else {
            let _e580 = (_e573 == 0u);
            if _e580 {
                phi_948_ = u32();
            } else {
                phi_948_ = select(((bitcast<u32>(_e569) << bitcast<u32>(23i)) | (_e573 & 8388607u)), 2139095039u, (_e569 >= 255i));
            }
            let _e584 = phi_948_;
            phi_949_ = _e584;
            phi_950_ = _e580;
        }
        let _e586 = phi_949_;
        let _e588 = phi_950_;
        phi_1327_ = SlimbvhTypeE(array<f32, 3>((_e214 * _e519), (_e218 * _e519), (_e221 * _e519)), array<f32, 3>((_e223 * _e524), (_e225 * _e524), (_e227 * _e524)), bitcast<f32>(((_e172 & 2147483648u) | select(_e556, 0u, _e558))), bitcast<f32>(((_e180 & 2147483648u) | select(_e586, 0u, _e588))), _e513);
    } else {
        let _e260 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e185, _e198))) & 2147483647u);
        if (_e260 >= 8388608u) {
            phi_981_ = (bitcast<i32>((_e260 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_981_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e260)), 32u, (_e260 == 0u))));
        }
        let _e274 = phi_981_;
        let _e275 = (_e165 + _e274);
        if (_e165 < -126i) {
            phi_992_ = -126i;
        } else {
            phi_992_ = select(_e165, 127i, (_e165 > 127i));
        }
        let _e280 = phi_992_;
        let _e285 = bitcast<f32>((bitcast<u32>((_e280 + 127i)) << bitcast<u32>(23i)));
        let _e291 = bitcast<f32>((bitcast<u32>(((_e165 - _e280) + 127i)) << bitcast<u32>(23i)));
        let _e292 = bitcast<u32>(_e214);
        let _e294 = ((_e292 & 2139095040u) != 0u);
        let _e309 = bitcast<u32>(_e218);
        let _e311 = ((_e309 & 2139095040u) != 0u);
        let _e326 = bitcast<u32>(_e221);
        let _e328 = ((_e326 & 2139095040u) != 0u);
        let _e344 = -(_e274);
        if (_e344 < -126i) {
            phi_1106_ = -126i;
        } else {
            phi_1106_ = select(_e344, 127i, (_e344 > 127i));
        }
        let _e349 = phi_1106_;
        let _e354 = bitcast<f32>((bitcast<u32>((_e349 + 127i)) << bitcast<u32>(23i)));
        let _e360 = bitcast<f32>((bitcast<u32>(((_e344 - _e349) + 127i)) << bitcast<u32>(23i)));
        let _e361 = bitcast<u32>(_e223);
        let _e363 = ((_e361 & 2139095040u) != 0u);
        let _e378 = bitcast<u32>(_e225);
        let _e380 = ((_e378 & 2139095040u) != 0u);
        let _e395 = bitcast<u32>(_e227);
        let _e397 = ((_e395 & 2139095040u) != 0u);
        let _e419 = ((_e173 & 8388607u) | (select(0u, 1u, ((_e173 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e422 = bitcast<i32>((_e173 >> bitcast<u32>(23i)));
        let _e429 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e419)), 32u, (_e419 == 0u))) - 8i);
        if (_e422 == 255i) {
            phi_1235_ = 255i;
        } else {
            phi_1235_ = (((_e422 + select(0i, 1i, (_e422 == 0i))) - _e429) + _e275);
        }
        let _e437 = phi_1235_;
        let _e441 = (_e419 << bitcast<u32>(((_e429 & 31i) & 31i)));
        if (_e437 <= 0i) {
            phi_1258_ = u32();
            phi_1259_ = true;
        } else {
            let _e448 = (_e441 == 0u);
            if _e448 {
                phi_1257_ = u32();
            } else {
                phi_1257_ = select(((bitcast<u32>(_e437) << bitcast<u32>(23i)) | (_e441 & 8388607u)), 2139095039u, (_e437 >= 255i));
            }
            let _e452 = phi_1257_;
            phi_1258_ = _e452;
            phi_1259_ = _e448;
        }
        let _e454 = phi_1258_;
        let _e456 = phi_1259_;
        let _e467 = ((_e181 & 8388607u) | (select(0u, 1u, ((_e181 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e470 = bitcast<i32>((_e181 >> bitcast<u32>(23i)));
        let _e477 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e467)), 32u, (_e467 == 0u))) - 8i);
        if (_e470 == 255i) {
            phi_1293_ = 255i;
        } else {
            phi_1293_ = (((_e470 + select(0i, 1i, (_e470 == 0i))) - _e477) + _e275);
        }
        let _e485 = phi_1293_;
        let _e489 = (_e467 << bitcast<u32>(((_e477 & 31i) & 31i)));
        if (_e485 <= 0i) {
            phi_1316_ = u32();
            phi_1317_ = true;
        } else {
            let _e496 = (_e489 == 0u);
            if _e496 {
                phi_1315_ = u32();
            } else {
                phi_1315_ = select(((bitcast<u32>(_e485) << bitcast<u32>(23i)) | (_e489 & 8388607u)), 2139095039u, (_e485 >= 255i));
            }
            let _e500 = phi_1315_;
            phi_1316_ = _e500;
            phi_1317_ = _e496;
        }
        let _e502 = phi_1316_;
        let _e504 = phi_1317_;
        phi_1327_ = SlimbvhTypeE(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e292 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e292 & 2147483648u))), _e214, _e294) * _e285) * select(0.00000011920929f, 1f, _e294)) * _e291), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e309 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e309 & 2147483648u))), _e218, _e311) * _e285) * select(0.00000011920929f, 1f, _e311)) * _e291), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e326 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e326 & 2147483648u))), _e221, _e328) * _e285) * select(0.00000011920929f, 1f, _e328)) * _e291)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e361 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e361 & 2147483648u))), _e223, _e363) * _e354) * select(0.00000011920929f, 1f, _e363)) * _e360), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e378 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e378 & 2147483648u))), _e225, _e380) * _e354) * select(0.00000011920929f, 1f, _e380)) * _e360), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e395 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e395 & 2147483648u))), _e227, _e397) * _e354) * select(0.00000011920929f, 1f, _e397)) * _e360)), bitcast<f32>(((_e172 & 2147483648u) | select(_e454, 0u, _e456))), bitcast<f32>(((_e180 & 2147483648u) | select(_e502, 0u, _e504))), _e274);
    }
    let _e595 = phi_1327_;
    let _e610 = (bitcast<f32>((bitcast<u32>(_e595.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e613 = bitcast<f32>((bitcast<u32>(_e595.member[0]) & 2147483647u));
    let _e614 = (_e613 * 0.00000011920929f);
    let _e617 = select(select(0.00000000000011368684f, _e614, (_e614 > 0.00000000000011368684f)), 0f, _e610);
    let _e618 = select(0f, _e595.member_1[0], _e610);
    let _e619 = (_e595.member[0] + _e617);
    let _e620 = (_e595.member[0] - _e617);
    let _e622 = select(38685626000000000000000000f, (1f / _e595.member_1[0]), _e610);
    let _e626 = (bitcast<f32>((bitcast<u32>(_e595.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e629 = bitcast<f32>((bitcast<u32>(_e595.member[1]) & 2147483647u));
    let _e630 = (_e629 * 0.00000011920929f);
    let _e633 = select(select(0.00000000000011368684f, _e630, (_e630 > 0.00000000000011368684f)), 0f, _e626);
    let _e634 = select(0f, _e595.member_1[1], _e626);
    let _e635 = (_e595.member[1] + _e633);
    let _e636 = (_e595.member[1] - _e633);
    let _e638 = select(38685626000000000000000000f, (1f / _e595.member_1[1]), _e626);
    let _e642 = (bitcast<f32>((bitcast<u32>(_e595.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e645 = bitcast<f32>((bitcast<u32>(_e595.member[2]) & 2147483647u));
    let _e646 = (_e645 * 0.00000011920929f);
    let _e649 = select(select(0.00000000000011368684f, _e646, (_e646 > 0.00000000000011368684f)), 0f, _e642);
    let _e650 = select(0f, _e595.member_1[2], _e642);
    let _e651 = (_e595.member[2] + _e649);
    let _e652 = (_e595.member[2] - _e649);
    let _e654 = select(38685626000000000000000000f, (1f / _e595.member_1[2]), _e642);
    let _e656 = select(_e629, _e613, (_e613 > _e629));
    let _e660 = (_e198 && (select(_e645, _e656, (_e656 > _e645)) <= 1099511600000f));
    let _e661 = select(0f, _e595.member_3, _e660);
    let _e662 = select(1f, _e595.member_2, _e660);
    let _e666 = slimbvh_question.member[1u];
    let _e669 = slimbvh_question.member[0u];
    if (_e669 == 1u) {
        phi_1566_ = SlimbvhTypeP(SlimbvhTypeJ(_e95, _e661), true);
    } else {
        phi_1566_ = SlimbvhTypeP(SlimbvhTypeJ(_e95, _e661), false);
    }
    let _e676 = phi_1566_;
    let _e681 = (_e207 & 3u);
    let _e682 = (_e211 & 3u);
    let _e683 = (_e203 & 3u);
    let _e686 = (bitcast<u32>(_e622) >> bitcast<u32>(31i));
    let _e689 = (bitcast<u32>(_e638) >> bitcast<u32>(31i));
    let _e692 = (bitcast<u32>(_e654) >> bitcast<u32>(31i));
    let _e696 = (f32(bitcast<i32>(_e111)) * _e147);
    let _e698 = (f32(bitcast<i32>(_e115)) * _e147);
    let _e700 = (f32(bitcast<i32>(_e119)) * _e147);
    let _e701 = (_e681 == 0u);
    if _e701 {
        phi_1630_ = array<f32, 3>(_e696, _e698, _e700);
    } else {
        if (_e681 == 1u) {
            phi_1629_ = array<f32, 3>(_e698, _e700, _e696);
        } else {
            phi_1629_ = array<f32, 3>(_e700, _e696, _e698);
        }
        let _e706 = phi_1629_;
        phi_1630_ = _e706;
    }
    let _e709 = phi_1630_;
    let _e711 = (f32(bitcast<i32>(_e127)) * _e147);
    let _e713 = (f32(bitcast<i32>(_e131)) * _e147);
    let _e715 = (f32(bitcast<i32>(_e135)) * _e147);
    if _e701 {
        phi_1649_ = array<f32, 3>(_e711, _e713, _e715);
    } else {
        if (_e681 == 1u) {
            phi_1648_ = array<f32, 3>(_e713, _e715, _e711);
        } else {
            phi_1648_ = array<f32, 3>(_e715, _e711, _e713);
        }
        let _e720 = phi_1648_;
        phi_1649_ = _e720;
    }
    let _e723 = phi_1649_;
    let _e734 = ((_e709[0] - _e619) * _e622);
    let _e735 = ((_e723[0] - _e620) * _e622);
    let _e736 = vec4<f32>(_e734, f32(), _e735, f32());
    let _e739 = ((_e709[1] - _e635) * _e638);
    let _e740 = ((_e723[1] - _e636) * _e638);
    let _e741 = vec4<f32>(_e739, f32(), _e740, f32());
    let _e744 = ((_e709[2] - _e651) * _e654);
    let _e745 = ((_e723[2] - _e652) * _e654);
    let _e746 = vec4<f32>(_e744, f32(), _e745, f32());
    let _e747 = vec4<f32>(_e735, f32(), _e734, f32());
    let _e749 = vec4<f32>(_e740, f32(), _e739, f32());
    let _e751 = vec4<f32>(_e745, f32(), _e744, f32());
    phi_1822_ = _e676;
    phi_1825_ = select(4294967295u, select(4294967295u, 0u, (_e662 <= _e661)), (max(max(max(min(_e736, _e747).x, min(_e741, _e749).x), min(_e746, _e751).x), _e662) <= min((min(min(max(_e736, _e747).x, max(_e741, _e749).x), max(_e746, _e751).x) + (max(max(_e746, _e751).x, -(min(_e746, _e751).x)) * 0.0000019073523f)), _e676.member.member_1)));
    phi_1827_ = select(0u, 2147483648u, (_e99 == 0u));
    phi_1829_ = (_e99 + 1u);
    loop {
        let _e775 = phi_1822_;
        let _e777 = phi_1825_;
        let _e779 = phi_1827_;
        let _e781 = phi_1829_;
        local_7 = _e775;
        let _e782 = (_e777 <= 2147483647u);
        if _e782 {
            phi_1838_ = _e777;
            phi_1841_ = _e779;
            phi_1843_ = _e781;
            loop {
                let _e784 = phi_1838_;
                let _e786 = phi_1841_;
                let _e788 = phi_1843_;
                local_2 = _e786;
                local_3 = _e786;
                local_4 = _e784;
                local_5 = _e784;
                local_9 = _e784;
                local_10 = _e786;
                local_11 = _e788;
                let _e789 = (_e784 <= 2147483647u);
                let _e792 = (_e789 && !((_e786 >= _e99)));
                local_1 = _e789;
                if _e792 {
                    let _e798 = slimbvh_nodes.member[_e786].member[select(_e681, 2u, (2u < _e681))];
                    let _e804 = slimbvh_nodes.member[_e786].member[select(_e682, 2u, (2u < _e682))];
                    let _e810 = slimbvh_nodes.member[_e786].member[select(_e683, 2u, (2u < _e683))];
                    let _e813 = bitcast<u32>(_e147);
                    let _e818 = bitcast<f32>(_e798.x);
                    let _e823 = (_e818 + (f32((_e798.w >> bitcast<u32>(5u))) * _e147));
                    if (_e686 == 0u) {
                        phi_1945_ = SlimbvhTypeM(_e798.z, _e823);
                        phi_1946_ = SlimbvhTypeM(_e798.y, _e818);
                    } else {
                        phi_1945_ = SlimbvhTypeM(_e798.y, _e818);
                        phi_1946_ = SlimbvhTypeM(_e798.z, _e823);
                    }
                    let _e834 = phi_1945_;
                    let _e836 = phi_1946_;
                    let _e840 = bitcast<f32>(((_e813 + ((_e798.w & 31u) << bitcast<u32>(23i))) ^ (_e686 << bitcast<u32>(31i))));
                    let _e880 = bitcast<f32>(_e804.x);
                    let _e885 = (_e880 + (f32((_e804.w >> bitcast<u32>(5u))) * _e147));
                    if (_e689 == 0u) {
                        phi_2005_ = SlimbvhTypeM(_e804.z, _e885);
                        phi_2006_ = SlimbvhTypeM(_e804.y, _e880);
                    } else {
                        phi_2005_ = SlimbvhTypeM(_e804.y, _e880);
                        phi_2006_ = SlimbvhTypeM(_e804.z, _e885);
                    }
                    let _e896 = phi_2005_;
                    let _e898 = phi_2006_;
                    let _e902 = bitcast<f32>(((_e813 + ((_e804.w & 31u) << bitcast<u32>(23i))) ^ (_e689 << bitcast<u32>(31i))));
                    let _e942 = bitcast<f32>(_e810.x);
                    let _e947 = (_e942 + (f32((_e810.w >> bitcast<u32>(5u))) * _e147));
                    if (_e692 == 0u) {
                        phi_2065_ = SlimbvhTypeM(_e810.z, _e947);
                        phi_2066_ = SlimbvhTypeM(_e810.y, _e942);
                    } else {
                        phi_2065_ = SlimbvhTypeM(_e810.y, _e942);
                        phi_2066_ = SlimbvhTypeM(_e810.z, _e947);
                    }
                    let _e958 = phi_2065_;
                    let _e960 = phi_2066_;
                    let _e964 = bitcast<f32>(((_e813 + ((_e810.w & 31u) << bitcast<u32>(23i))) ^ (_e692 << bitcast<u32>(31i))));
                    let _e1000 = (_e840 * _e622);
                    let _e1007 = (((_e836.member_1 - _e619) * _e622) + (bitcast<f32>((bitcast<u32>(_e1000) & 2147483647u)) * -0.00012207031f));
                    let _e1016 = (-(_e840) * _e622);
                    let _e1023 = (((_e834.member_1 - _e620) * _e622) + (bitcast<f32>((bitcast<u32>(_e1016) & 2147483647u)) * 0.00012207031f));
                    let _e1032 = (_e902 * _e638);
                    let _e1039 = (((_e898.member_1 - _e635) * _e638) + (bitcast<f32>((bitcast<u32>(_e1032) & 2147483647u)) * -0.00012207031f));
                    let _e1048 = (-(_e902) * _e638);
                    let _e1055 = (((_e896.member_1 - _e636) * _e638) + (bitcast<f32>((bitcast<u32>(_e1048) & 2147483647u)) * 0.00012207031f));
                    let _e1064 = (_e964 * _e654);
                    let _e1071 = (((_e960.member_1 - _e651) * _e654) + (bitcast<f32>((bitcast<u32>(_e1064) & 2147483647u)) * -0.00012207031f));
                    let _e1076 = ((f32((_e960.member & 255u)) * _e1064) + _e1071);
                    let _e1077 = ((f32(((_e960.member >> bitcast<u32>(8u)) & 255u)) * _e1064) + _e1071);
                    let _e1078 = ((f32(((_e960.member >> bitcast<u32>(16u)) & 255u)) * _e1064) + _e1071);
                    let _e1079 = ((f32(((_e960.member >> bitcast<u32>(24u)) & 255u)) * _e1064) + _e1071);
                    let _e1080 = (-(_e964) * _e654);
                    let _e1087 = (((_e958.member_1 - _e652) * _e654) + (bitcast<f32>((bitcast<u32>(_e1080) & 2147483647u)) * 0.00012207031f));
                    let _e1092 = ((f32((_e958.member & 255u)) * _e1080) + _e1087);
                    let _e1093 = ((f32(((_e958.member >> bitcast<u32>(8u)) & 255u)) * _e1080) + _e1087);
                    let _e1094 = ((f32(((_e958.member >> bitcast<u32>(16u)) & 255u)) * _e1080) + _e1087);
                    let _e1095 = ((f32(((_e958.member >> bitcast<u32>(24u)) & 255u)) * _e1080) + _e1087);
                    let _e1128 = max(max(max(((f32((_e836.member & 255u)) * _e1000) + _e1007), ((f32((_e898.member & 255u)) * _e1032) + _e1039)), _e1076), _e662);
                    let _e1129 = max(max(max(((f32(((_e836.member >> bitcast<u32>(8u)) & 255u)) * _e1000) + _e1007), ((f32(((_e898.member >> bitcast<u32>(8u)) & 255u)) * _e1032) + _e1039)), _e1077), _e662);
                    let _e1130 = max(max(max(((f32(((_e836.member >> bitcast<u32>(16u)) & 255u)) * _e1000) + _e1007), ((f32(((_e898.member >> bitcast<u32>(16u)) & 255u)) * _e1032) + _e1039)), _e1078), _e662);
                    let _e1131 = max(max(max(((f32(((_e836.member >> bitcast<u32>(24u)) & 255u)) * _e1000) + _e1007), ((f32(((_e898.member >> bitcast<u32>(24u)) & 255u)) * _e1032) + _e1039)), _e1079), _e662);
                    let _e1136 = (_e775.member.member_1 + (bitcast<f32>((bitcast<u32>(_e775.member.member_1) & 2147483647u)) * 0.0000004768374f));
                    if (_e1128 <= min((min(min(((f32((_e834.member & 255u)) * _e1016) + _e1023), ((f32((_e896.member & 255u)) * _e1048) + _e1055)), _e1092) + (max(_e1092, -(_e1076)) * 0.0000023841915f)), _e1136)) {
                        phi_2550_ = (((bitcast<u32>(_e1128) ^ select(0u, 4294967288u, _e676.member_1)) & 2147483640u) | 4u);
                    } else {
                        phi_2550_ = 4294967288u;
                    }
                    let _e1151 = phi_2550_;
                    if (_e1129 <= min((min(min(((f32(((_e834.member >> bitcast<u32>(8u)) & 255u)) * _e1016) + _e1023), ((f32(((_e896.member >> bitcast<u32>(8u)) & 255u)) * _e1048) + _e1055)), _e1093) + (max(_e1093, -(_e1077)) * 0.0000023841915f)), _e1136)) {
                        phi_2563_ = ((((bitcast<u32>(_e1129) ^ select(0u, 4294967288u, _e676.member_1)) & 2147483640u) | 4u) | 1u);
                    } else {
                        phi_2563_ = 4294967288u;
                    }
                    let _e1159 = phi_2563_;
                    if (_e1130 <= min((min(min(((f32(((_e834.member >> bitcast<u32>(16u)) & 255u)) * _e1016) + _e1023), ((f32(((_e896.member >> bitcast<u32>(16u)) & 255u)) * _e1048) + _e1055)), _e1094) + (max(_e1094, -(_e1078)) * 0.0000023841915f)), _e1136)) {
                        phi_2576_ = ((((bitcast<u32>(_e1130) ^ select(0u, 4294967288u, _e676.member_1)) & 2147483640u) | 4u) | 2u);
                    } else {
                        phi_2576_ = 4294967288u;
                    }
                    let _e1167 = phi_2576_;
                    if (_e1131 <= min((min(min(((f32(((_e834.member >> bitcast<u32>(24u)) & 255u)) * _e1016) + _e1023), ((f32(((_e896.member >> bitcast<u32>(24u)) & 255u)) * _e1048) + _e1055)), _e1095) + (max(_e1095, -(_e1079)) * 0.0000023841915f)), _e1136)) {
                        phi_2589_ = ((((bitcast<u32>(_e1131) ^ select(0u, 4294967288u, _e676.member_1)) & 2147483640u) | 4u) | 3u);
                    } else {
                        phi_2589_ = 4294967288u;
                    }
                    let _e1175 = phi_2589_;
                    if (_e1151 < _e1159) {
                        phi_4559_ = SlimbvhTypeF(_e1151, _e1159);
                    } else {
                        phi_4559_ = SlimbvhTypeF(_e1159, _e1151);
                    }
                    let _e1180 = phi_4559_;
                    if (_e1167 < _e1175) {
                        phi_4571_ = SlimbvhTypeF(_e1167, _e1175);
                    } else {
                        phi_4571_ = SlimbvhTypeF(_e1175, _e1167);
                    }
                    let _e1187 = phi_4571_;
                    if (_e1180.member < _e1187.member) {
                        phi_4583_ = SlimbvhTypeF(_e1180.member, _e1187.member);
                    } else {
                        phi_4583_ = SlimbvhTypeF(_e1187.member, _e1180.member);
                    }
                    let _e1194 = phi_4583_;
                    if (_e1180.member_1 < _e1187.member_1) {
                        phi_4595_ = SlimbvhTypeF(_e1180.member_1, _e1187.member_1);
                    } else {
                        phi_4595_ = SlimbvhTypeF(_e1187.member_1, _e1180.member_1);
                    }
                    let _e1201 = phi_4595_;
                    if (_e1201.member < _e1194.member_1) {
                        phi_4607_ = SlimbvhTypeF(_e1201.member, _e1194.member_1);
                    } else {
                        phi_4607_ = SlimbvhTypeF(_e1194.member_1, _e1201.member);
                    }
                    let _e1208 = phi_4607_;
                    let _e1223 = (((_e1194.member & 7u) | ((_e1208.member & 7u) << bitcast<u32>(3u))) | (((_e1208.member_1 & 7u) | ((_e1201.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                    if (_e1223 == 0u) {
                        let _e1241 = (_e784 - 1u);
                        let _e1244 = local[(_e1241 % 128u)];
                        let _e1245 = (_e1244 & 511u);
                        let _e1247 = (_e1245 >> bitcast<u32>(3u));
                        let _e1250 = ((_e1247 == 0u) || (_e1241 == 4294967295u));
                        if _e1250 {
                        } else {
                            local[(_e1241 % 128u)] = (((_e1244 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1247);
                        }
                        phi_2675_ = select(_e784, _e1241, _e1250);
                        phi_2676_ = (((_e1244 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1245 & 3u) & 3u));
                    } else {
                        let _e1226 = (_e1223 >> bitcast<u32>(3u));
                        if (_e1226 == 0u) {
                            phi_2670_ = _e784;
                        } else {
                            local[(_e784 % 128u)] = ((_e786 << bitcast<u32>(9u)) | _e1226);
                            phi_2670_ = (_e784 + 1u);
                        }
                        let _e1235 = phi_2670_;
                        phi_2675_ = _e1235;
                        phi_2676_ = ((_e786 << bitcast<u32>(2i)) | ((_e1223 & 3u) & 3u));
                    }
                    let _e1265 = phi_2675_;
                    let _e1267 = phi_2676_;
                    let _e1269 = (_e1267 >> bitcast<u32>(2i));
                    if (_e1269 < _e99) {
                        let _e1275 = slimbvh_nodes.member[_e1269].member_1[(_e1267 & 3u)];
                        phi_2700_ = _e1275;
                    } else {
                        phi_2700_ = 2147483648u;
                    }
                    let _e1277 = phi_2700_;
                    let _e1278 = (_e788 - 1u);
                    phi_1839_ = select(_e1265, 4294967295u, (_e1278 == 0u));
                    phi_1842_ = _e1277;
                    phi_1844_ = _e1278;
                } else {
                    phi_1839_ = u32();
                    phi_1842_ = u32();
                    phi_1844_ = u32();
                }
                let _e1282 = phi_1839_;
                let _e1284 = phi_1842_;
                let _e1286 = phi_1844_;
                continue;
                continuing {
                    phi_1838_ = _e1282;
                    phi_1841_ = _e1284;
                    phi_1843_ = _e1286;
                    break if !(_e792);
                }
            }
            let _e1289 = local_1;
            if _e1289 {
                let _e1291 = local_2;
                let _e1294 = local_3;
                phi_2716_ = _e775;
                phi_2719_ = SlimbvhTypeF(0u, ((_e1294 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e1300 = phi_2716_;
                    let _e1302 = phi_2719_;
                    local_6 = _e1300;
                    local_8 = _e1300;
                    if (_e1302.member < _e1302.member_1) {
                        phi_2720_ = SlimbvhTypeF((_e1302.member + 1u), _e1302.member_1);
                        phi_2742_ = SlimbvhTypeF(1u, _e1302.member);
                    } else {
                        phi_2720_ = _e1302;
                        phi_2742_ = SlimbvhTypeF(0u, SlimbvhTypeF().member_1);
                    }
                    let _e1315 = phi_2720_;
                    let _e1317 = phi_2742_;
                    let _e1321 = (bitcast<i32>(_e1317.member) != 0i);
                    if _e1321 {
                        let _e1322 = ((_e1291 & 268435455u) + _e1317.member_1);
                        let _e1323 = (_e1322 / 2u);
                        let _e1324 = (_e1322 % 2u);
                        let _e1325 = (_e1323 >= arrayLength((&slimbvh_triangles.member)));
                        if _e1325 {
                            phi_2822_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e1326 = (2u * _e1324);
                            let _e1330 = slimbvh_triangles.member[_e1323][_e1326];
                            let _e1335 = slimbvh_triangles.member[_e1323][(_e1326 + 1u)];
                            let _e1340 = slimbvh_triangles.member[_e1323][(_e1326 + 2u)];
                            if (_e1324 == 0u) {
                                phi_2821_ = array<vec4<f32>, 3>(_e1330, _e1335, _e1340);
                            } else {
                                phi_2821_ = array<vec4<f32>, 3>(vec4<f32>(_e1330.z, _e1330.w, _e1335.x, _e1335.y), vec4<f32>(_e1335.z, _e1335.w, _e1340.x, _e1340.y), vec4<f32>(_e1340.z, _e1340.w, 0f, 0f));
                            }
                            let _e1358 = phi_2821_;
                            phi_2822_ = _e1358;
                        }
                        let _e1360 = phi_2822_;
                        let _e1363 = bitcast<u32>(_e1360[2].y);
                        if _e1325 {
                            phi_2903_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e1364 = (2u * _e1324);
                            let _e1368 = slimbvh_triangles.member[_e1323][_e1364];
                            let _e1373 = slimbvh_triangles.member[_e1323][(_e1364 + 1u)];
                            let _e1378 = slimbvh_triangles.member[_e1323][(_e1364 + 2u)];
                            if (_e1324 == 0u) {
                                phi_2902_ = array<vec4<f32>, 3>(_e1368, _e1373, _e1378);
                            } else {
                                phi_2902_ = array<vec4<f32>, 3>(vec4<f32>(_e1368.z, _e1368.w, _e1373.x, _e1373.y), vec4<f32>(_e1373.z, _e1373.w, _e1378.x, _e1378.y), vec4<f32>(_e1378.z, _e1378.w, 0f, 0f));
                            }
                            let _e1396 = phi_2902_;
                            phi_2903_ = _e1396;
                        }
                        let _e1398 = phi_2903_;
                        if _e212 {
                            phi_2927_ = array<f32, 3>(_e1398[0].x, _e1398[0].y, _e1398[0].z);
                        } else {
                            if (_e207 == 1u) {
                                phi_2926_ = array<f32, 3>(_e1398[0].y, _e1398[0].z, _e1398[0].x);
                            } else {
                                phi_2926_ = array<f32, 3>(_e1398[0].z, _e1398[0].x, _e1398[0].y);
                            }
                            let _e1421 = phi_2926_;
                            phi_2927_ = _e1421;
                        }
                        let _e1424 = phi_2927_;
                        if _e212 {
                            phi_2942_ = array<f32, 3>(_e1398[0].w, _e1398[1].x, _e1398[1].y);
                        } else {
                            if (_e207 == 1u) {
                                phi_2941_ = array<f32, 3>(_e1398[1].x, _e1398[1].y, _e1398[0].w);
                            } else {
                                phi_2941_ = array<f32, 3>(_e1398[1].y, _e1398[0].w, _e1398[1].x);
                            }
                            let _e1429 = phi_2941_;
                            phi_2942_ = _e1429;
                        }
                        let _e1432 = phi_2942_;
                        if _e212 {
                            phi_2957_ = array<f32, 3>(_e1398[1].z, _e1398[1].w, _e1398[2].x);
                        } else {
                            if (_e207 == 1u) {
                                phi_2956_ = array<f32, 3>(_e1398[1].w, _e1398[2].x, _e1398[1].z);
                            } else {
                                phi_2956_ = array<f32, 3>(_e1398[2].x, _e1398[1].z, _e1398[1].w);
                            }
                            let _e1437 = phi_2956_;
                            phi_2957_ = _e1437;
                        }
                        let _e1440 = phi_2957_;
                        let _e1454 = (_e1424[2] - _e595.member[2]);
                        let _e1457 = (((_e1424[0] - _e595.member[0]) * _e650) - (_e1454 * _e618));
                        let _e1460 = (((_e1424[1] - _e595.member[1]) * _e650) - (_e1454 * _e634));
                        let _e1463 = (_e1432[2] - _e595.member[2]);
                        let _e1466 = (((_e1432[0] - _e595.member[0]) * _e650) - (_e1463 * _e618));
                        let _e1469 = (((_e1432[1] - _e595.member[1]) * _e650) - (_e1463 * _e634));
                        let _e1472 = (_e1440[2] - _e595.member[2]);
                        let _e1475 = (((_e1440[0] - _e595.member[0]) * _e650) - (_e1472 * _e618));
                        let _e1478 = (((_e1440[1] - _e595.member[1]) * _e650) - (_e1472 * _e634));
                        let _e1479 = (_e1475 * _e1469);
                        let _e1480 = (_e1478 * _e1466);
                        let _e1481 = (_e1457 * _e1478);
                        let _e1482 = (_e1460 * _e1475);
                        let _e1483 = (_e1466 * _e1460);
                        let _e1484 = (_e1469 * _e1457);
                        let _e1489 = (((_e1479 >= _e1480) && (_e1481 >= _e1482)) && (_e1483 >= _e1484));
                        let _e1495 = (_e1489 || (((_e1479 <= _e1480) && (_e1481 <= _e1482)) && (_e1483 <= _e1484)));
                        if _e1495 {
                            let _e1497 = select(-1f, 1f, _e1489);
                            let _e1499 = ((_e1479 - _e1480) * _e1497);
                            let _e1501 = select(0f, _e1499, (_e1499 > 0f));
                            let _e1503 = ((_e1481 - _e1482) * _e1497);
                            let _e1505 = select(0f, _e1503, (_e1503 > 0f));
                            let _e1507 = ((_e1483 - _e1484) * _e1497);
                            let _e1509 = select(0f, _e1507, (_e1507 > 0f));
                            let _e1511 = ((_e1501 + _e1505) + _e1509);
                            let _e1526 = ((min(min(_e1424[0], _e1432[0]), _e1440[0]) - _e619) * _e622);
                            let _e1527 = ((max(max(_e1424[0], _e1432[0]), _e1440[0]) - _e620) * _e622);
                            let _e1528 = vec4<f32>(_e1526, f32(), _e1527, f32());
                            let _e1531 = ((min(min(_e1424[1], _e1432[1]), _e1440[1]) - _e635) * _e638);
                            let _e1532 = ((max(max(_e1424[1], _e1432[1]), _e1440[1]) - _e636) * _e638);
                            let _e1533 = vec4<f32>(_e1531, f32(), _e1532, f32());
                            let _e1536 = ((min(min(_e1424[2], _e1432[2]), _e1440[2]) - _e651) * _e654);
                            let _e1537 = ((max(max(_e1424[2], _e1432[2]), _e1440[2]) - _e652) * _e654);
                            let _e1538 = vec4<f32>(_e1536, f32(), _e1537, f32());
                            let _e1539 = vec4<f32>(_e1527, f32(), _e1526, f32());
                            let _e1541 = vec4<f32>(_e1532, f32(), _e1531, f32());
                            let _e1543 = vec4<f32>(_e1537, f32(), _e1536, f32());
                            let _e1552 = max(max(min(_e1528, _e1539).x, min(_e1533, _e1541).x), min(_e1538, _e1543).x);
                            let _e1557 = min(min(max(_e1528, _e1539).x, max(_e1533, _e1541).x), max(_e1538, _e1543).x);
                            let _e1562 = max(_e1552, _e662);
                            let _e1584 = (((((_e1495 && (_e1511 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1457, _e1466), _e1475) <= 0f) && (max(max(_e1457, _e1466), _e1475) >= 0f))) && ((min(min(_e1460, _e1469), _e1478) <= 0f) && (max(max(_e1460, _e1469), _e1478) >= 0f))) && (_e1562 <= (_e1557 + (max(max(_e1538, _e1543).x, -(min(_e1538, _e1543).x)) * 0.0000019073523f)))) && (_e1562 <= _e1300.member.member_1));
                            if _e1584 {
                                let _e1589 = (_e1432[0] - _e1424[0]);
                                let _e1590 = (_e1432[1] - _e1424[1]);
                                let _e1591 = (_e1432[2] - _e1424[2]);
                                let _e1592 = vec3<f32>(_e1589, _e1590, _e1591);
                                let _e1593 = (_e1440[0] - _e1432[0]);
                                let _e1594 = (_e1440[1] - _e1432[1]);
                                let _e1595 = (_e1440[2] - _e1432[2]);
                                let _e1596 = vec3<f32>(_e1593, _e1594, _e1595);
                                let _e1597 = (_e1424[0] - _e1440[0]);
                                let _e1598 = (_e1424[1] - _e1440[1]);
                                let _e1599 = (_e1424[2] - _e1440[2]);
                                let _e1600 = vec3<f32>(_e1597, _e1598, _e1599);
                                let _e1611 = max(max(bitcast<f32>((bitcast<u32>(_e1589) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1590) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1591) & 2147483647u)));
                                let _e1622 = max(max(bitcast<f32>((bitcast<u32>(_e1593) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1594) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1595) & 2147483647u)));
                                let _e1635 = max(max(_e1611, _e1622), max(max(bitcast<f32>((bitcast<u32>(_e1597) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1598) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1599) & 2147483647u))));
                                if (_e1611 == _e1635) {
                                    phi_3316_ = _e1469;
                                    phi_3317_ = _e1466;
                                    phi_3318_ = _e1460;
                                    phi_3319_ = _e1457;
                                    phi_3320_ = vec3<f32>(_e1424[0], _e1424[1], _e1424[2]);
                                    phi_3321_ = _e1600;
                                    phi_3322_ = _e1596;
                                    phi_3323_ = _e1592;
                                } else {
                                    let _e1637 = (_e1622 == _e1635);
                                    let _e1642 = vec3(_e1637);
                                    phi_3316_ = select(_e1460, _e1478, _e1637);
                                    phi_3317_ = select(_e1457, _e1475, _e1637);
                                    phi_3318_ = select(_e1478, _e1469, _e1637);
                                    phi_3319_ = select(_e1475, _e1466, _e1637);
                                    phi_3320_ = select(vec3<f32>(_e1440[0], _e1440[1], _e1440[2]), vec3<f32>(_e1432[0], _e1432[1], _e1432[2]), _e1642);
                                    phi_3321_ = select(_e1596, _e1592, _e1642);
                                    phi_3322_ = select(_e1592, _e1600, _e1642);
                                    phi_3323_ = select(_e1600, _e1596, _e1642);
                                }
                                let _e1648 = phi_3316_;
                                let _e1650 = phi_3317_;
                                let _e1652 = phi_3318_;
                                let _e1654 = phi_3319_;
                                let _e1656 = phi_3320_;
                                let _e1658 = phi_3321_;
                                let _e1660 = phi_3322_;
                                let _e1662 = phi_3323_;
                                let _e1669 = ((_e1660.y * _e1658.z) - (_e1658.y * _e1660.z));
                                let _e1674 = ((_e1660.z * _e1658.x) - (_e1658.z * _e1660.x));
                                let _e1677 = ((_e1660.x * _e1658.y) - (_e1658.x * _e1660.y));
                                let _e1680 = ((_e1501 >= _e1505) && (_e1501 >= _e1509));
                                let _e1681 = (_e1505 >= _e1509);
                                let _e1695 = (((_e1669 * (select(select(_e1440[0], _e1432[0], _e1681), _e1424[0], _e1680) - _e595.member[0])) + (_e1674 * (select(select(_e1440[1], _e1432[1], _e1681), _e1424[1], _e1680) - _e595.member[1]))) + (_e1677 * (select(select(_e1440[2], _e1432[2], _e1681), _e1424[2], _e1680) - _e595.member[2])));
                                let _e1700 = (((_e1669 * _e618) + (_e1674 * _e634)) + (_e1677 * _e650));
                                let _e1701 = (_e1650 - _e1654);
                                let _e1702 = (_e1648 - _e1652);
                                let _e1705 = ((_e1701 * _e1701) + (_e1702 * _e1702));
                                let _e1712 = (-(((_e1654 * _e1701) + (_e1652 * _e1702))) / select(0.000000000000000000000000000000000000011754944f, _e1705, (_e1705 > 0.000000000000000000000000000000000000011754944f)));
                                let _e1714 = select(1f, _e1712, (_e1712 < 1f));
                                let _e1716 = select(0f, _e1714, (_e1714 > 0f));
                                let _e1725 = ((_e1656.x + (_e1662.x * _e1716)) - _e595.member[0]);
                                let _e1728 = ((_e1656.y + (_e1662.y * _e1716)) - _e595.member[1]);
                                let _e1731 = ((_e1656.z + (_e1662.z * _e1716)) - _e595.member[2]);
                                let _e1796 = ((bitcast<f32>((bitcast<u32>(((((_e1669 * _e1725) + (_e1674 * _e1728)) + (_e1677 * _e1731)) - _e1695)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1725) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1728) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1731) & 2147483647u))), _e1635)) * max(max(bitcast<f32>((bitcast<u32>(_e1669) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1674) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1677) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1700) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1660.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1660.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1660.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1658.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1658.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1658.z) & 2147483647u)))))));
                                let _e1797 = (_e1695 / _e1700);
                                if (_e1584 && !(_e1796)) {
                                    let _e1800 = (_e1731 / _e650);
                                    let _e1808 = (((_e1669 * (_e1725 - (_e618 * _e1800))) + (_e1674 * (_e1728 - (_e634 * _e1800)))) / _e1700);
                                    phi_3502_ = select(select(_e1800, (_e1800 + _e1808), (bitcast<f32>((bitcast<u32>(_e1808) & 2147483647u)) <= _e1635)), _e1797, _e1796);
                                } else {
                                    phi_3502_ = _e1797;
                                }
                                let _e1817 = phi_3502_;
                                let _e1819 = select(_e1557, _e1817, (_e1817 < _e1557));
                                let _e1821 = select(_e1552, _e1819, (_e1819 > _e1552));
                                let _e1824 = select(_e1821, 0f, (bitcast<u32>(_e1821) == 2147483648u));
                                let _e1825 = (1f / _e1511);
                                phi_3528_ = SlimbvhTypeG(_e1824, (_e1505 * _e1825), (_e1509 * _e1825), ((_e1584 && (_e1824 >= _e662)) && (_e1824 <= _e1300.member.member_1)));
                                phi_3529_ = SlimbvhTypeG();
                            } else {
                                phi_3528_ = SlimbvhTypeG();
                                phi_3529_ = SlimbvhTypeG(0f, 0f, 0f, _e1584);
                            }
                            let _e1834 = phi_3528_;
                            let _e1836 = phi_3529_;
                            phi_3532_ = _e1834;
                            phi_3533_ = _e1836;
                            phi_3534_ = select(true, false, _e1584);
                        } else {
                            phi_3532_ = SlimbvhTypeG();
                            phi_3533_ = SlimbvhTypeG(0f, 0f, 0f, _e1495);
                            phi_3534_ = true;
                        }
                        let _e1839 = phi_3532_;
                        let _e1841 = phi_3533_;
                        let _e1843 = phi_3534_;
                        if _e1843 {
                            phi_3538_ = _e1841;
                        } else {
                            phi_3538_ = _e1839;
                        }
                        let _e1845 = phi_3538_;
                        if _e1845.member_3 {
                            phi_3547_ = SlimbvhTypeH(_e1845.member, _e1845.member_1, _e1845.member_2, _e1363);
                        } else {
                            phi_3547_ = _e95;
                        }
                        let _e1852 = phi_3547_;
                        if (_e1852.member_3 != 4294967295u) {
                            let _e1858 = slimbvh_target.member[0u][0u];
                            let _e1862 = slimbvh_target.member[0u][1u];
                            let _e1866 = slimbvh_target.member[0u][2u];
                            let _e1870 = slimbvh_target.member[0u][3u];
                            let _e1874 = slimbvh_target.member[1u][0u];
                            let _e1878 = slimbvh_target.member[1u][1u];
                            let _e1882 = slimbvh_target.member[1u][2u];
                            let _e1886 = slimbvh_target.member[1u][3u];
                            let _e1887 = bitcast<f32>(_e1858);
                            let _e1888 = bitcast<f32>(_e1862);
                            let _e1889 = bitcast<f32>(_e1866);
                            let _e1891 = bitcast<f32>(_e1874);
                            let _e1892 = array<u32, 3>(_e1878, _e1882, _e1886);
                            if (_e165 < -126i) {
                                phi_3600_ = -126i;
                            } else {
                                phi_3600_ = select(_e165, 127i, (_e165 > 127i));
                            }
                            let _e1898 = phi_3600_;
                            let _e1903 = bitcast<f32>((bitcast<u32>((_e1898 + 127i)) << bitcast<u32>(23i)));
                            let _e1909 = bitcast<f32>((bitcast<u32>(((_e165 - _e1898) + 127i)) << bitcast<u32>(23i)));
                            if (_e1870 == 0u) {
                                phi_3740_ = SlimbvhTypeI(array<f32, 3>(_e1887, _e1888, _e1889), _e1870, _e1891, _e1892);
                            } else {
                                let _e1911 = bitcast<u32>(_e1887);
                                let _e1913 = ((_e1911 & 2139095040u) != 0u);
                                let _e1928 = bitcast<u32>(_e1888);
                                let _e1930 = ((_e1928 & 2139095040u) != 0u);
                                let _e1945 = bitcast<u32>(_e1889);
                                let _e1947 = ((_e1945 & 2139095040u) != 0u);
                                let _e1963 = bitcast<u32>(_e1891);
                                let _e1965 = ((_e1963 & 2139095040u) != 0u);
                                phi_3740_ = SlimbvhTypeI(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1911 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1911 & 2147483648u))), _e1887, _e1913) * _e1903) * select(0.00000011920929f, 1f, _e1913)) * _e1909), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1928 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1928 & 2147483648u))), _e1888, _e1930) * _e1903) * select(0.00000011920929f, 1f, _e1930)) * _e1909), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1945 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1945 & 2147483648u))), _e1889, _e1947) * _e1903) * select(0.00000011920929f, 1f, _e1947)) * _e1909)), _e1870, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1963 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1963 & 2147483648u))), _e1891, _e1965) * _e1903) * select(0.00000011920929f, 1f, _e1965)) * _e1909), _e1892);
                            }
                            let _e1982 = phi_3740_;
                            if (_e1363 == _e666) {
                                phi_4066_ = false;
                            } else {
                                let _e1984 = (_e1363 / 16u);
                                if (_e1984 < arrayLength((&slimbvh_sides.member))) {
                                    let _e1987 = slimbvh_sides.member[_e1984];
                                    phi_3764_ = _e1987;
                                } else {
                                    phi_3764_ = 0u;
                                }
                                let _e1989 = phi_3764_;
                                let _e1998 = (bitcast<i32>((_e1989 << bitcast<u32>(((30u - ((_e1363 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                let _e1999 = (_e1998 == 0i);
                                if _e1999 {
                                    phi_4065_ = true;
                                } else {
                                    if _e212 {
                                        phi_3793_ = vec3<f32>(_e1424[0], _e1424[1], _e1424[2]);
                                    } else {
                                        if (_e207 == 1u) {
                                            phi_3792_ = vec3<f32>(_e1424[2], _e1424[0], _e1424[1]);
                                        } else {
                                            phi_3792_ = vec3<f32>(_e1424[1], _e1424[2], _e1424[0]);
                                        }
                                        let _e2004 = phi_3792_;
                                        phi_3793_ = _e2004;
                                    }
                                    let _e2007 = phi_3793_;
                                    if _e212 {
                                        phi_3811_ = vec3<f32>(_e1432[0], _e1432[1], _e1432[2]);
                                    } else {
                                        if (_e207 == 1u) {
                                            phi_3810_ = vec3<f32>(_e1432[2], _e1432[0], _e1432[1]);
                                        } else {
                                            phi_3810_ = vec3<f32>(_e1432[1], _e1432[2], _e1432[0]);
                                        }
                                        let _e2012 = phi_3810_;
                                        phi_3811_ = _e2012;
                                    }
                                    let _e2015 = phi_3811_;
                                    if _e212 {
                                        phi_3829_ = vec3<f32>(_e1440[0], _e1440[1], _e1440[2]);
                                    } else {
                                        if (_e207 == 1u) {
                                            phi_3828_ = vec3<f32>(_e1440[2], _e1440[0], _e1440[1]);
                                        } else {
                                            phi_3828_ = vec3<f32>(_e1440[1], _e1440[2], _e1440[0]);
                                        }
                                        let _e2020 = phi_3828_;
                                        phi_3829_ = _e2020;
                                    }
                                    let _e2023 = phi_3829_;
                                    let _e2026 = (_e2015.x - _e2007.x);
                                    let _e2029 = (_e2015.y - _e2007.y);
                                    let _e2032 = (_e2015.z - _e2007.z);
                                    let _e2034 = (_e2023.x - _e2007.x);
                                    let _e2036 = (_e2023.y - _e2007.y);
                                    let _e2038 = (_e2023.z - _e2007.z);
                                    if (_e1982.member_1 == 1u) {
                                        phi_3865_ = (vec3<f32>(_e1982.member[0], _e1982.member[1], _e1982.member[2]) - _e2007);
                                    } else {
                                        phi_3865_ = vec3<f32>(_e1982.member[0], _e1982.member[1], _e1982.member[2]);
                                    }
                                    let _e2053 = phi_3865_;
                                    let _e2059 = bitcast<f32>((bitcast<u32>((_e2026 * _e2036)) ^ _e1982.member_3[0]));
                                    let _e2063 = bitcast<f32>((bitcast<u32>((_e2029 * _e2034)) ^ _e1982.member_3[0]));
                                    let _e2067 = bitcast<f32>((bitcast<u32>((_e2029 * _e2038)) ^ _e1982.member_3[0]));
                                    let _e2071 = bitcast<f32>((bitcast<u32>((_e2032 * _e2036)) ^ _e1982.member_3[0]));
                                    let _e2075 = bitcast<f32>((bitcast<u32>((_e2032 * _e2034)) ^ _e1982.member_3[0]));
                                    let _e2079 = bitcast<f32>((bitcast<u32>((_e2026 * _e2038)) ^ _e1982.member_3[0]));
                                    let _e2080 = (_e2067 - _e2071);
                                    let _e2081 = (_e2075 - _e2079);
                                    let _e2082 = (_e2059 - _e2063);
                                    let _e2106 = (bitcast<f32>((bitcast<u32>(_e2067) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2071) & 2147483647u)));
                                    let _e2113 = (bitcast<f32>((bitcast<u32>(_e2075) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2079) & 2147483647u)));
                                    let _e2120 = (bitcast<f32>((bitcast<u32>(_e2059) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2063) & 2147483647u)));
                                    if (_e1982.member_2 == 0f) {
                                        phi_4047_ = 0f;
                                    } else {
                                        let _e2150 = bitcast<f32>((bitcast<u32>(_e2080) & 2147483647u));
                                        let _e2153 = bitcast<f32>((bitcast<u32>(_e2081) & 2147483647u));
                                        let _e2156 = bitcast<f32>((bitcast<u32>(_e2082) & 2147483647u));
                                        let _e2158 = select(_e2156, _e2153, (_e2153 > _e2156));
                                        let _e2162 = select(_e2156, _e2153, (_e2153 < _e2156));
                                        let _e2166 = select(_e2153, _e2150, (_e2150 < _e2153));
                                        let _e2168 = select(_e2153, _e2150, (_e2150 > _e2153));
                                        let _e2170 = select(_e2156, _e2168, (_e2168 < _e2156));
                                        phi_4047_ = bitcast<f32>((bitcast<u32>((_e1982.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2158, _e2150, (_e2150 > _e2158)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2170, _e2166, (_e2166 > _e2170)))) ^ _e1982.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2162, _e2150, (_e2150 < _e2162)))) ^ _e1982.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2106 + _e2113) + _e2120))) ^ _e1982.member_3[0]))) * 1.0000005f)) ^ _e1982.member_3[0])))) ^ _e1982.member_3[0]));
                                    }
                                    let _e2197 = phi_4047_;
                                    phi_4065_ = (_e1999 || !(((((bitcast<f32>((bitcast<u32>((_e2053.x * _e2080)) ^ _e1982.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2053.y * _e2081)) ^ _e1982.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2053.z * _e2082)) ^ _e1982.member_3[0]))) * f32(-(_e1998))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2053.x) & 2147483647u)) * _e2106)) ^ _e1982.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2053.y) & 2147483647u)) * _e2113)) ^ _e1982.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2053.z) & 2147483647u)) * _e2120)) ^ _e1982.member_3[0]))))) ^ _e1982.member_3[0])) + _e2197) + 0.0000000000000000000000000000000000001880791f))));
                                }
                                let _e2211 = phi_4065_;
                                phi_4066_ = _e2211;
                            }
                            let _e2213 = phi_4066_;
                            if _e2213 {
                                if (_e1852.member < _e1300.member.member.member) {
                                    phi_4086_ = true;
                                } else {
                                    if (_e1852.member == _e1300.member.member.member) {
                                        phi_4085_ = (_e1852.member_3 < _e1300.member.member.member_3);
                                    } else {
                                        phi_4085_ = false;
                                    }
                                    let _e2225 = phi_4085_;
                                    phi_4086_ = _e2225;
                                }
                                let _e2227 = phi_4086_;
                                if _e2227 {
                                    phi_4093_ = SlimbvhTypeP(SlimbvhTypeJ(_e1852, _e1852.member), _e1300.member_1);
                                } else {
                                    phi_4093_ = _e1300;
                                }
                                let _e2233 = phi_4093_;
                                if _e2233.member_1 {
                                    phi_4099_ = SlimbvhTypeP(SlimbvhTypeJ(_e2233.member.member, bitcast<f32>(4286578687u)), _e2233.member_1);
                                } else {
                                    phi_4099_ = _e2233;
                                }
                                let _e2242 = phi_4099_;
                                phi_4100_ = _e2242;
                            } else {
                                phi_4100_ = _e1300;
                            }
                            let _e2244 = phi_4100_;
                            phi_4101_ = _e2244;
                        } else {
                            phi_4101_ = _e1300;
                        }
                        let _e2246 = phi_4101_;
                        phi_2717_ = _e2246;
                    } else {
                        phi_2717_ = SlimbvhTypeP();
                    }
                    let _e2248 = phi_2717_;
                    continue;
                    continuing {
                        phi_2716_ = _e2248;
                        phi_2719_ = _e1315;
                        break if !(_e1321);
                    }
                }
                let _e2251 = local_4;
                let _e2252 = (_e2251 - 1u);
                let _e2255 = local[(_e2252 % 128u)];
                let _e2256 = (_e2255 & 511u);
                let _e2258 = (_e2256 >> bitcast<u32>(3u));
                let _e2261 = ((_e2258 == 0u) || (_e2252 == 4294967295u));
                if _e2261 {
                } else {
                    local[(_e2252 % 128u)] = (((_e2255 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2258);
                }
                let _e2268 = local_5;
                let _e2276 = (((_e2255 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2256 & 3u) & 3u));
                let _e2278 = (_e2276 >> bitcast<u32>(2i));
                if (_e2278 < _e99) {
                    let _e2284 = slimbvh_nodes.member[_e2278].member_1[(_e2276 & 3u)];
                    phi_4160_ = _e2284;
                } else {
                    phi_4160_ = 2147483648u;
                }
                let _e2286 = phi_4160_;
                let _e2288 = local_6;
                let _e2560 = local_8;
                phi_4169_ = _e2560;
                phi_4170_ = select(select(_e2268, _e2252, _e2261), 4294967295u, (_e662 > _e2288.member.member_1));
                phi_4171_ = _e2286;
            } else {
                phi_4169_ = _e775;
                let _e2563 = local_9;
                phi_4170_ = _e2563;
                let _e2566 = local_10;
                phi_4171_ = _e2566;
            }
            let _e2294 = phi_4169_;
            let _e2296 = phi_4170_;
            let _e2298 = phi_4171_;
            phi_1823_ = _e2294;
            phi_1826_ = _e2296;
            phi_1828_ = _e2298;
            let _e2572 = local_11;
            phi_1830_ = _e2572;
        } else {
            phi_1823_ = SlimbvhTypeP();
            phi_1826_ = u32();
            phi_1828_ = u32();
            phi_1830_ = u32();
        }
        let _e2300 = phi_1823_;
        let _e2302 = phi_1826_;
        let _e2304 = phi_1828_;
        let _e2306 = phi_1830_;
        continue;
        continuing {
            phi_1822_ = _e2300;
            phi_1825_ = _e2302;
            phi_1827_ = _e2304;
            phi_1829_ = _e2306;
            break if !(_e782);
        }
    }
    let _e2309 = local_7;
    if (_e2309.member.member.member_3 != 4294967295u) {
        let _e2315 = -((_e165 + _e595.member_4));
        let _e2316 = bitcast<u32>(_e2309.member.member.member);
        let _e2320 = (bitcast<i32>((_e2316 >> bitcast<u32>(23i))) & 255i);
        let _e2321 = (_e2320 + _e2315);
        if (_e2320 == 255i) {
            phi_4228_ = _e2309.member.member.member;
        } else {
            if (_e2320 > 0i) {
                if (_e2321 > 0i) {
                    let _e2325 = (_e2321 < 255i);
                    if _e2325 {
                        phi_4207_ = bitcast<f32>((_e2316 + bitcast<u32>((_e2315 << bitcast<u32>(23i)))));
                    } else {
                        phi_4207_ = f32();
                    }
                    let _e2332 = phi_4207_;
                    phi_4209_ = _e2332;
                    phi_4210_ = select(true, false, _e2325);
                } else {
                    phi_4209_ = f32();
                    phi_4210_ = true;
                }
                let _e2335 = phi_4209_;
                let _e2337 = phi_4210_;
                phi_4211_ = _e2335;
                phi_4212_ = _e2337;
            } else {
                phi_4211_ = f32();
                phi_4212_ = true;
            }
            let _e2339 = phi_4211_;
            let _e2341 = phi_4212_;
            if _e2341 {
                let _e2342 = (_e2316 & 2147483648u);
                let _e2349 = ((_e2316 & 8388607u) | (select(0u, 1u, ((_e2316 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e2353 = (_e2349 == 0u);
                if _e2353 {
                    phi_4888_ = bitcast<f32>(_e2342);
                } else {
                    let _e2358 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2349)), 32u, _e2353) - 8u);
                    let _e2361 = (_e2349 << bitcast<u32>((_e2358 & 31u)));
                    let _e2363 = ((_e2321 + select(0i, 1i, (_e2320 == 0i))) - bitcast<i32>(_e2358));
                    if (_e2363 >= 255i) {
                        phi_4878_ = bitcast<f32>((_e2342 | 2139095040u));
                        phi_4879_ = f32();
                        phi_4880_ = true;
                    } else {
                        let _e2365 = (_e2363 > 0i);
                        if _e2365 {
                            phi_4872_ = bitcast<f32>(((_e2342 | (bitcast<u32>(_e2363) << bitcast<u32>(23i))) | (_e2361 & 8388607u)));
                            phi_4873_ = f32();
                        } else {
                            if (_e2363 < -24i) {
                                phi_4838_ = 26u;
                            } else {
                                phi_4838_ = bitcast<u32>((1i - _e2363));
                            }
                            let _e2370 = phi_4838_;
                            let _e2371 = (_e2370 & 31u);
                            let _e2373 = (_e2361 >> bitcast<u32>(_e2371));
                            let _e2377 = (_e2361 & ((1u << bitcast<u32>(_e2371)) - 1u));
                            let _e2381 = (1u << bitcast<u32>(((_e2370 - 1u) & 31u)));
                            if (_e2377 > _e2381) {
                                phi_4859_ = true;
                            } else {
                                if (_e2377 == _e2381) {
                                    phi_4856_ = ((_e2373 & 1u) == 1u);
                                } else {
                                    phi_4856_ = false;
                                }
                                let _e2387 = phi_4856_;
                                phi_4859_ = _e2387;
                            }
                            let _e2389 = phi_4859_;
                            phi_4872_ = f32();
                            phi_4873_ = bitcast<f32>((_e2342 | (_e2373 + select(0u, 1u, _e2389))));
                        }
                        let _e2402 = phi_4872_;
                        let _e2404 = phi_4873_;
                        phi_4878_ = _e2402;
                        phi_4879_ = _e2404;
                        phi_4880_ = _e2365;
                    }
                    let _e2408 = phi_4878_;
                    let _e2410 = phi_4879_;
                    let _e2412 = phi_4880_;
                    phi_4888_ = select(_e2410, _e2408, _e2412);
                }
                let _e2416 = phi_4888_;
                phi_4227_ = _e2416;
            } else {
                phi_4227_ = _e2339;
            }
            let _e2418 = phi_4227_;
            phi_4228_ = _e2418;
        }
        let _e2420 = phi_4228_;
        let _e2421 = bitcast<u32>(_e2420);
        if ((_e2421 & 2147483647u) >= 2139095040u) {
            phi_4240_ = bitcast<f32>(((_e2421 & 2147483648u) | 2139095039u));
        } else {
            phi_4240_ = _e2420;
        }
        let _e2428 = phi_4240_;
        phi_4245_ = SlimbvhTypeH(_e2428, _e2309.member.member.member_1, _e2309.member.member.member_2, _e2309.member.member.member_3);
    } else {
        phi_4245_ = _e95;
    }
    let _e2433 = phi_4245_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2433.member), bitcast<u32>(_e2433.member_1), bitcast<u32>(_e2433.member_2), _e2433.member_3);
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
