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
var<storage> slimbvh_sides: SlimbvhTypeC;

@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeL;

@group(0) @binding(2) 
var<storage> slimbvh_triangles: SlimbvhTypeB;

@group(0) @binding(3) 
var<uniform> slimbvh_root: SlimbvhTypeH;

@group(0) @binding(5) 
var<uniform> slimbvh_target: SlimbvhTypeH;

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
    var phi_1327_: SlimbvhTypeD;
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
    var phi_4559_: SlimbvhTypeE;
    var phi_4571_: SlimbvhTypeE;
    var phi_4583_: SlimbvhTypeE;
    var phi_4595_: SlimbvhTypeE;
    var phi_4607_: SlimbvhTypeE;
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
    var phi_2719_: SlimbvhTypeE;
    var phi_2720_: SlimbvhTypeE;
    var phi_2742_: SlimbvhTypeE;
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
    var phi_3528_: SlimbvhTypeF;
    var phi_3529_: SlimbvhTypeF;
    var phi_3532_: SlimbvhTypeF;
    var phi_3533_: SlimbvhTypeF;
    var phi_3534_: bool;
    var phi_3538_: SlimbvhTypeF;
    var phi_3547_: SlimbvhTypeG;
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
    var phi_4245_: SlimbvhTypeG;
    var local_8: SlimbvhTypeP;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e95 = SlimbvhTypeG(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
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
        phi_1327_ = SlimbvhTypeD(array<f32, 3>((_e214 * _e519), (_e218 * _e519), (_e221 * _e519)), array<f32, 3>((_e223 * _e524), (_e225 * _e524), (_e227 * _e524)), bitcast<f32>(((_e172 & 2147483648u) | select(_e556, 0u, _e558))), bitcast<f32>(((_e180 & 2147483648u) | select(_e586, 0u, _e588))), _e513);
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
        phi_1327_ = SlimbvhTypeD(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e292 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e292 & 2147483648u))), _e214, _e294) * _e285) * select(0.00000011920929f, 1f, _e294)) * _e291), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e309 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e309 & 2147483648u))), _e218, _e311) * _e285) * select(0.00000011920929f, 1f, _e311)) * _e291), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e326 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e326 & 2147483648u))), _e221, _e328) * _e285) * select(0.00000011920929f, 1f, _e328)) * _e291)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e361 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e361 & 2147483648u))), _e223, _e363) * _e354) * select(0.00000011920929f, 1f, _e363)) * _e360), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e378 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e378 & 2147483648u))), _e225, _e380) * _e354) * select(0.00000011920929f, 1f, _e380)) * _e360), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e395 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e395 & 2147483648u))), _e227, _e397) * _e354) * select(0.00000011920929f, 1f, _e397)) * _e360)), bitcast<f32>(((_e172 & 2147483648u) | select(_e454, 0u, _e456))), bitcast<f32>(((_e180 & 2147483648u) | select(_e502, 0u, _e504))), _e274);
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
                        phi_4559_ = SlimbvhTypeE(_e1151, _e1159);
                    } else {
                        phi_4559_ = SlimbvhTypeE(_e1159, _e1151);
                    }
                    let _e1180 = phi_4559_;
                    if (_e1167 < _e1175) {
                        phi_4571_ = SlimbvhTypeE(_e1167, _e1175);
                    } else {
                        phi_4571_ = SlimbvhTypeE(_e1175, _e1167);
                    }
                    let _e1187 = phi_4571_;
                    if (_e1180.member < _e1187.member) {
                        phi_4583_ = SlimbvhTypeE(_e1180.member, _e1187.member);
                    } else {
                        phi_4583_ = SlimbvhTypeE(_e1187.member, _e1180.member);
                    }
                    let _e1194 = phi_4583_;
                    if (_e1180.member_1 < _e1187.member_1) {
                        phi_4595_ = SlimbvhTypeE(_e1180.member_1, _e1187.member_1);
                    } else {
                        phi_4595_ = SlimbvhTypeE(_e1187.member_1, _e1180.member_1);
                    }
                    let _e1201 = phi_4595_;
                    if (_e1201.member < _e1194.member_1) {
                        phi_4607_ = SlimbvhTypeE(_e1201.member, _e1194.member_1);
                    } else {
                        phi_4607_ = SlimbvhTypeE(_e1194.member_1, _e1201.member);
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
                phi_2719_ = SlimbvhTypeE(0u, ((_e1294 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e1300 = phi_2716_;
                    let _e1302 = phi_2719_;
                    local_6 = _e1300;
                    local_8 = _e1300;
                    if (_e1302.member < _e1302.member_1) {
                        phi_2720_ = SlimbvhTypeE((_e1302.member + 1u), _e1302.member_1);
                        phi_2742_ = SlimbvhTypeE(1u, _e1302.member);
                    } else {
                        phi_2720_ = _e1302;
                        phi_2742_ = SlimbvhTypeE(0u, SlimbvhTypeE().member_1);
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
                                phi_3528_ = SlimbvhTypeF(_e1824, (_e1505 * _e1825), (_e1509 * _e1825), ((_e1584 && (_e1824 >= _e662)) && (_e1824 <= _e1300.member.member_1)));
                                phi_3529_ = SlimbvhTypeF();
                            } else {
                                phi_3528_ = SlimbvhTypeF();
                                phi_3529_ = SlimbvhTypeF(0f, 0f, 0f, _e1584);
                            }
                            let _e1834 = phi_3528_;
                            let _e1836 = phi_3529_;
                            phi_3532_ = _e1834;
                            phi_3533_ = _e1836;
                            phi_3534_ = select(true, false, _e1584);
                        } else {
                            phi_3532_ = SlimbvhTypeF();
                            phi_3533_ = SlimbvhTypeF(0f, 0f, 0f, _e1495);
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
                            phi_3547_ = SlimbvhTypeG(_e1845.member, _e1845.member_1, _e1845.member_2, _e1363);
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
        phi_4245_ = SlimbvhTypeG(_e2428, _e2309.member.member.member_1, _e2309.member.member.member_2, _e2309.member.member.member_3);
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
