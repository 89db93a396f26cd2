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
    var phi_711_: u32;
    var phi_717_: u32;
    var phi_723_: u32;
    var phi_988_: i32;
    var phi_999_: i32;
    var phi_1113_: i32;
    var phi_1242_: i32;
    var phi_1264_: u32;
    var phi_1265_: u32;
    var phi_1266_: bool;
    var phi_1300_: i32;
    var phi_1322_: u32;
    var phi_1323_: u32;
    var phi_1324_: bool;
    var phi_885_: i32;
    var phi_891_: u32;
    var phi_910_: u32;
    var phi_911_: u32;
    var phi_912_: bool;
    var phi_930_: i32;
    var phi_936_: u32;
    var phi_955_: u32;
    var phi_956_: u32;
    var phi_957_: bool;
    var phi_1334_: SlimbvhTypeD;
    var phi_1573_: SlimbvhTypeP;
    var phi_1636_: array<f32, 3>;
    var phi_1637_: array<f32, 3>;
    var phi_1655_: array<f32, 3>;
    var phi_1656_: array<f32, 3>;
    var phi_1829_: SlimbvhTypeP;
    var phi_1832_: u32;
    var phi_1834_: u32;
    var phi_1836_: u32;
    var phi_1845_: u32;
    var phi_1848_: u32;
    var phi_1850_: u32;
    var phi_1957_: SlimbvhTypeM;
    var phi_1958_: SlimbvhTypeM;
    var phi_2017_: SlimbvhTypeM;
    var phi_2018_: SlimbvhTypeM;
    var phi_2077_: SlimbvhTypeM;
    var phi_2078_: SlimbvhTypeM;
    var phi_2562_: u32;
    var phi_2575_: u32;
    var phi_2588_: u32;
    var phi_2601_: u32;
    var phi_4572_: SlimbvhTypeE;
    var phi_4584_: SlimbvhTypeE;
    var phi_4596_: SlimbvhTypeE;
    var phi_4608_: SlimbvhTypeE;
    var phi_4620_: SlimbvhTypeE;
    var phi_2682_: u32;
    var phi_2687_: u32;
    var phi_2688_: u32;
    var phi_2712_: u32;
    var phi_1846_: u32;
    var phi_1849_: u32;
    var phi_1851_: u32;
    var local_1: bool;
    var local_2: u32;
    var local_3: u32;
    var phi_2729_: SlimbvhTypeP;
    var phi_2732_: SlimbvhTypeE;
    var phi_2733_: SlimbvhTypeE;
    var phi_2755_: SlimbvhTypeE;
    var phi_2834_: array<vec4<f32>, 3>;
    var phi_2835_: array<vec4<f32>, 3>;
    var phi_2915_: array<vec4<f32>, 3>;
    var phi_2916_: array<vec4<f32>, 3>;
    var phi_2939_: array<f32, 3>;
    var phi_2940_: array<f32, 3>;
    var phi_2954_: array<f32, 3>;
    var phi_2955_: array<f32, 3>;
    var phi_2969_: array<f32, 3>;
    var phi_2970_: array<f32, 3>;
    var phi_3329_: f32;
    var phi_3330_: f32;
    var phi_3331_: f32;
    var phi_3332_: f32;
    var phi_3333_: vec3<f32>;
    var phi_3334_: vec3<f32>;
    var phi_3335_: vec3<f32>;
    var phi_3336_: vec3<f32>;
    var phi_3515_: f32;
    var phi_3541_: SlimbvhTypeF;
    var phi_3542_: SlimbvhTypeF;
    var phi_3545_: SlimbvhTypeF;
    var phi_3546_: SlimbvhTypeF;
    var phi_3547_: bool;
    var phi_3551_: SlimbvhTypeF;
    var phi_3560_: SlimbvhTypeG;
    var phi_3613_: i32;
    var phi_3753_: SlimbvhTypeI;
    var phi_3777_: u32;
    var phi_3805_: vec3<f32>;
    var phi_3806_: vec3<f32>;
    var phi_3823_: vec3<f32>;
    var phi_3824_: vec3<f32>;
    var phi_3841_: vec3<f32>;
    var phi_3842_: vec3<f32>;
    var phi_3878_: vec3<f32>;
    var phi_4060_: f32;
    var phi_4078_: bool;
    var phi_4079_: bool;
    var phi_4098_: bool;
    var phi_4099_: bool;
    var phi_4106_: SlimbvhTypeP;
    var phi_4112_: SlimbvhTypeP;
    var phi_4113_: SlimbvhTypeP;
    var phi_4114_: SlimbvhTypeP;
    var phi_2730_: SlimbvhTypeP;
    var local_4: u32;
    var local_5: u32;
    var phi_4173_: u32;
    var local_6: SlimbvhTypeP;
    var phi_4182_: SlimbvhTypeP;
    var phi_4183_: u32;
    var phi_4184_: u32;
    var phi_1830_: SlimbvhTypeP;
    var phi_1833_: u32;
    var phi_1835_: u32;
    var phi_1837_: u32;
    var local_7: SlimbvhTypeP;
    var phi_4220_: f32;
    var phi_4222_: f32;
    var phi_4223_: bool;
    var phi_4224_: f32;
    var phi_4225_: bool;
    var phi_4851_: u32;
    var phi_4869_: bool;
    var phi_4872_: bool;
    var phi_4885_: f32;
    var phi_4886_: f32;
    var phi_4891_: f32;
    var phi_4892_: f32;
    var phi_4893_: bool;
    var phi_4901_: f32;
    var phi_4240_: f32;
    var phi_4241_: f32;
    var phi_4253_: f32;
    var phi_4258_: SlimbvhTypeG;
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
    let _e150 = slimbvh_exponent.member[1u];
    let _e153 = slimbvh_exponent.member[2u];
    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    let _e154 = slimbvh_origin.member;
    let _e160 = slimbvh_origin.member[3u];
    let _e161 = slimbvh_direction.member;
    let _e167 = slimbvh_direction.member[3u];
    let _e170 = slimbvh_exponent.member[0u];
    let _e171 = bitcast<i32>(_e170);
    let _e173 = (bitcast<u32>(_e154.x) & 2147483647u);
    let _e175 = (bitcast<u32>(_e154.y) & 2147483647u);
    let _e177 = (bitcast<u32>(_e154.z) & 2147483647u);
    let _e178 = bitcast<u32>(_e160);
    let _e179 = (_e178 & 2147483647u);
    let _e181 = (bitcast<u32>(_e161.x) & 2147483647u);
    let _e183 = (bitcast<u32>(_e161.y) & 2147483647u);
    let _e185 = (bitcast<u32>(_e161.z) & 2147483647u);
    let _e186 = bitcast<u32>(_e167);
    let _e187 = (_e186 & 2147483647u);
    let _e189 = select(_e183, _e181, (_e183 < _e181));
    let _e191 = select(_e185, _e189, (_e185 < _e189));
    let _e193 = select(_e173, _e191, (_e173 < _e191));
    let _e195 = select(_e175, _e193, (_e175 < _e193));
    let _e197 = select(_e177, _e195, (_e177 < _e195));
    let _e204 = (((select(_e179, _e197, (_e179 < _e197)) < 2139095040u) && (_e187 <= 2139095040u)) && (_e191 > 0u));
    if (_e181 == _e191) {
        phi_711_ = 0u;
    } else {
        phi_711_ = select(2u, 1u, (_e183 == _e191));
    }
    let _e209 = phi_711_;
    let _e210 = (_e209 == 2u);
    if _e210 {
        phi_717_ = 0u;
    } else {
        phi_717_ = (_e209 + 1u);
    }
    let _e213 = phi_717_;
    let _e214 = (_e213 == 2u);
    if _e214 {
        phi_723_ = 0u;
    } else {
        phi_723_ = (_e213 + 1u);
    }
    let _e217 = phi_723_;
    let _e218 = (_e213 == 0u);
    let _e220 = select(select(_e154.y, _e154.x, _e218), _e154.z, _e214);
    let _e221 = (_e217 == 0u);
    let _e223 = (_e217 == 2u);
    let _e224 = select(select(_e154.y, _e154.x, _e221), _e154.z, _e223);
    let _e225 = (_e209 == 0u);
    let _e227 = select(select(_e154.y, _e154.x, _e225), _e154.z, _e210);
    let _e229 = select(select(_e161.y, _e161.x, _e218), _e161.z, _e214);
    let _e231 = select(select(_e161.y, _e161.x, _e221), _e161.z, _e223);
    let _e233 = select(select(_e161.y, _e161.x, _e225), _e161.z, _e210);
    let _e234 = (_e179 - 1u);
    let _e235 = (_e187 - 1u);
    let _e237 = select(_e234, _e235, (_e235 < _e234));
    let _e238 = (_e173 - 1u);
    let _e239 = (_e175 - 1u);
    let _e241 = select(_e238, _e239, (_e239 < _e238));
    let _e242 = (_e177 - 1u);
    let _e244 = select(_e241, _e242, (_e242 < _e241));
    let _e245 = (_e181 - 1u);
    let _e246 = (_e183 - 1u);
    let _e248 = select(_e245, _e246, (_e246 < _e245));
    let _e249 = (_e185 - 1u);
    let _e251 = select(_e248, _e249, (_e249 < _e248));
    let _e253 = select(_e244, _e251, (_e251 < _e244));
    if (((select(_e253, _e237, (_e237 < _e253)) >= 8388607u) && (_e191 < 2130706432u)) && (bitcast<u32>((_e171 + 126i)) <= 253u)) {
        let _e518 = bitcast<i32>((_e191 >> bitcast<u32>(23i)));
        let _e519 = (_e518 - 127i);
        let _e520 = (_e171 + _e519);
        let _e525 = bitcast<f32>((bitcast<u32>((_e171 + 127i)) << bitcast<u32>(23i)));
        let _e530 = bitcast<f32>((bitcast<u32>((254i - _e518)) << bitcast<u32>(23i)));
        if (_e179 >= 2139095040u) {
            phi_885_ = 255i;
        } else {
            phi_885_ = (bitcast<i32>((_e179 >> bitcast<u32>(23i))) + _e520);
        }
        let _e545 = phi_885_;
        if (_e179 == 0u) {
            phi_891_ = 0u;
        } else {
            phi_891_ = (_e179 | 8388608u);
        }
        let _e549 = phi_891_;
        if (_e545 <= 0i) {
            phi_911_ = u32();
            phi_912_ = true;
        } else {
            let _e556 = (_e549 == 0u);
            if _e556 {
                phi_910_ = u32();
            } else {
                phi_910_ = select(((bitcast<u32>(_e545) << bitcast<u32>(23i)) | (_e549 & 8388607u)), 2139095039u, (_e545 >= 255i));
            }
            let _e560 = phi_910_;
            phi_911_ = _e560;
            phi_912_ = _e556;
        }
        let _e562 = phi_911_;
        let _e564 = phi_912_;
        if (_e187 >= 2139095040u) {
            phi_930_ = 255i;
        } else {
            phi_930_ = (bitcast<i32>((_e187 >> bitcast<u32>(23i))) + _e520);
        }
        let _e575 = phi_930_;
        if (_e187 == 0u) {
            phi_936_ = 0u;
        } else {
            phi_936_ = (_e187 | 8388608u);
        }
        let _e579 = phi_936_;
        if (_e575 <= 0i) {
            phi_956_ = u32();
            phi_957_ = true;
        } else {
            let _e586 = (_e579 == 0u);
            if _e586 {
                phi_955_ = u32();
            } else {
                phi_955_ = select(((bitcast<u32>(_e575) << bitcast<u32>(23i)) | (_e579 & 8388607u)), 2139095039u, (_e575 >= 255i));
            }
            let _e590 = phi_955_;
            phi_956_ = _e590;
            phi_957_ = _e586;
        }
        let _e592 = phi_956_;
        let _e594 = phi_957_;
        phi_1334_ = SlimbvhTypeD(array<f32, 3>((_e220 * _e525), (_e224 * _e525), (_e227 * _e525)), array<f32, 3>((_e229 * _e530), (_e231 * _e530), (_e233 * _e530)), bitcast<f32>(((_e178 & 2147483648u) | select(_e562, 0u, _e564))), bitcast<f32>(((_e186 & 2147483648u) | select(_e592, 0u, _e594))), _e519);
    } else {
        let _e266 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e191, _e204))) & 2147483647u);
        if (_e266 >= 8388608u) {
            phi_988_ = (bitcast<i32>((_e266 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_988_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e266)), 32u, (_e266 == 0u))));
        }
        let _e280 = phi_988_;
        let _e281 = (_e171 + _e280);
        if (_e171 < -126i) {
            phi_999_ = -126i;
        } else {
            phi_999_ = select(_e171, 127i, (_e171 > 127i));
        }
        let _e286 = phi_999_;
        let _e291 = bitcast<f32>((bitcast<u32>((_e286 + 127i)) << bitcast<u32>(23i)));
        let _e297 = bitcast<f32>((bitcast<u32>(((_e171 - _e286) + 127i)) << bitcast<u32>(23i)));
        let _e298 = bitcast<u32>(_e220);
        let _e300 = ((_e298 & 2139095040u) != 0u);
        let _e315 = bitcast<u32>(_e224);
        let _e317 = ((_e315 & 2139095040u) != 0u);
        let _e332 = bitcast<u32>(_e227);
        let _e334 = ((_e332 & 2139095040u) != 0u);
        let _e350 = -(_e280);
        if (_e350 < -126i) {
            phi_1113_ = -126i;
        } else {
            phi_1113_ = select(_e350, 127i, (_e350 > 127i));
        }
        let _e355 = phi_1113_;
        let _e360 = bitcast<f32>((bitcast<u32>((_e355 + 127i)) << bitcast<u32>(23i)));
        let _e366 = bitcast<f32>((bitcast<u32>(((_e350 - _e355) + 127i)) << bitcast<u32>(23i)));
        let _e367 = bitcast<u32>(_e229);
        let _e369 = ((_e367 & 2139095040u) != 0u);
        let _e384 = bitcast<u32>(_e231);
        let _e386 = ((_e384 & 2139095040u) != 0u);
        let _e401 = bitcast<u32>(_e233);
        let _e403 = ((_e401 & 2139095040u) != 0u);
        let _e425 = ((_e179 & 8388607u) | (select(0u, 1u, ((_e179 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e428 = bitcast<i32>((_e179 >> bitcast<u32>(23i)));
        let _e435 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e425)), 32u, (_e425 == 0u))) - 8i);
        if (_e428 == 255i) {
            phi_1242_ = 255i;
        } else {
            phi_1242_ = (((_e428 + select(0i, 1i, (_e428 == 0i))) - _e435) + _e281);
        }
        let _e443 = phi_1242_;
        let _e447 = (_e425 << bitcast<u32>(((_e435 & 31i) & 31i)));
        if (_e443 <= 0i) {
            phi_1265_ = u32();
            phi_1266_ = true;
        } else {
            let _e454 = (_e447 == 0u);
            if _e454 {
                phi_1264_ = u32();
            } else {
                phi_1264_ = select(((bitcast<u32>(_e443) << bitcast<u32>(23i)) | (_e447 & 8388607u)), 2139095039u, (_e443 >= 255i));
            }
            let _e458 = phi_1264_;
            phi_1265_ = _e458;
            phi_1266_ = _e454;
        }
        let _e460 = phi_1265_;
        let _e462 = phi_1266_;
        let _e473 = ((_e187 & 8388607u) | (select(0u, 1u, ((_e187 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e476 = bitcast<i32>((_e187 >> bitcast<u32>(23i)));
        let _e483 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e473)), 32u, (_e473 == 0u))) - 8i);
        if (_e476 == 255i) {
            phi_1300_ = 255i;
        } else {
            phi_1300_ = (((_e476 + select(0i, 1i, (_e476 == 0i))) - _e483) + _e281);
        }
        let _e491 = phi_1300_;
        let _e495 = (_e473 << bitcast<u32>(((_e483 & 31i) & 31i)));
        if (_e491 <= 0i) {
            phi_1323_ = u32();
            phi_1324_ = true;
        } else {
            let _e502 = (_e495 == 0u);
            if _e502 {
                phi_1322_ = u32();
            } else {
                phi_1322_ = select(((bitcast<u32>(_e491) << bitcast<u32>(23i)) | (_e495 & 8388607u)), 2139095039u, (_e491 >= 255i));
            }
            let _e506 = phi_1322_;
            phi_1323_ = _e506;
            phi_1324_ = _e502;
        }
        let _e508 = phi_1323_;
        let _e510 = phi_1324_;
        phi_1334_ = SlimbvhTypeD(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e298 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e298 & 2147483648u))), _e220, _e300) * _e291) * select(0.00000011920929f, 1f, _e300)) * _e297), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e224, _e317) * _e291) * select(0.00000011920929f, 1f, _e317)) * _e297), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e332 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e332 & 2147483648u))), _e227, _e334) * _e291) * select(0.00000011920929f, 1f, _e334)) * _e297)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e367 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e367 & 2147483648u))), _e229, _e369) * _e360) * select(0.00000011920929f, 1f, _e369)) * _e366), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e231, _e386) * _e360) * select(0.00000011920929f, 1f, _e386)) * _e366), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e401 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e401 & 2147483648u))), _e233, _e403) * _e360) * select(0.00000011920929f, 1f, _e403)) * _e366)), bitcast<f32>(((_e178 & 2147483648u) | select(_e460, 0u, _e462))), bitcast<f32>(((_e186 & 2147483648u) | select(_e508, 0u, _e510))), _e280);
    }
    let _e601 = phi_1334_;
    let _e616 = (bitcast<f32>((bitcast<u32>(_e601.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e619 = bitcast<f32>((bitcast<u32>(_e601.member[0]) & 2147483647u));
    let _e620 = (_e619 * 0.00000011920929f);
    let _e623 = select(select(0.00000000000011368684f, _e620, (_e620 > 0.00000000000011368684f)), 0f, _e616);
    let _e624 = select(0f, _e601.member_1[0], _e616);
    let _e625 = (_e601.member[0] + _e623);
    let _e626 = (_e601.member[0] - _e623);
    let _e628 = select(38685626000000000000000000f, (1f / _e601.member_1[0]), _e616);
    let _e632 = (bitcast<f32>((bitcast<u32>(_e601.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e635 = bitcast<f32>((bitcast<u32>(_e601.member[1]) & 2147483647u));
    let _e636 = (_e635 * 0.00000011920929f);
    let _e639 = select(select(0.00000000000011368684f, _e636, (_e636 > 0.00000000000011368684f)), 0f, _e632);
    let _e640 = select(0f, _e601.member_1[1], _e632);
    let _e641 = (_e601.member[1] + _e639);
    let _e642 = (_e601.member[1] - _e639);
    let _e644 = select(38685626000000000000000000f, (1f / _e601.member_1[1]), _e632);
    let _e648 = (bitcast<f32>((bitcast<u32>(_e601.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e651 = bitcast<f32>((bitcast<u32>(_e601.member[2]) & 2147483647u));
    let _e652 = (_e651 * 0.00000011920929f);
    let _e655 = select(select(0.00000000000011368684f, _e652, (_e652 > 0.00000000000011368684f)), 0f, _e648);
    let _e656 = select(0f, _e601.member_1[2], _e648);
    let _e657 = (_e601.member[2] + _e655);
    let _e658 = (_e601.member[2] - _e655);
    let _e660 = select(38685626000000000000000000f, (1f / _e601.member_1[2]), _e648);
    let _e662 = select(_e635, _e619, (_e619 > _e635));
    let _e666 = (_e204 && (select(_e651, _e662, (_e662 > _e651)) <= 1099511600000f));
    let _e667 = select(0f, _e601.member_3, _e666);
    let _e668 = select(1f, _e601.member_2, _e666);
    let _e672 = slimbvh_question.member[1u];
    let _e675 = slimbvh_question.member[0u];
    if (_e675 == 1u) {
        phi_1573_ = SlimbvhTypeP(SlimbvhTypeJ(_e95, _e667), true);
    } else {
        phi_1573_ = SlimbvhTypeP(SlimbvhTypeJ(_e95, _e667), false);
    }
    let _e682 = phi_1573_;
    let _e687 = (_e213 & 3u);
    let _e688 = (_e217 & 3u);
    let _e689 = (_e209 & 3u);
    let _e692 = (bitcast<u32>(_e628) >> bitcast<u32>(31i));
    let _e695 = (bitcast<u32>(_e644) >> bitcast<u32>(31i));
    let _e698 = (bitcast<u32>(_e660) >> bitcast<u32>(31i));
    let _e702 = (f32(bitcast<i32>(_e111)) * _e147);
    let _e704 = (f32(bitcast<i32>(_e115)) * _e147);
    let _e706 = (f32(bitcast<i32>(_e119)) * _e147);
    let _e707 = (_e687 == 0u);
    if _e707 {
        phi_1637_ = array<f32, 3>(_e702, _e704, _e706);
    } else {
        if (_e687 == 1u) {
            phi_1636_ = array<f32, 3>(_e704, _e706, _e702);
        } else {
            phi_1636_ = array<f32, 3>(_e706, _e702, _e704);
        }
        let _e712 = phi_1636_;
        phi_1637_ = _e712;
    }
    let _e715 = phi_1637_;
    let _e717 = (f32(bitcast<i32>(_e127)) * _e147);
    let _e719 = (f32(bitcast<i32>(_e131)) * _e147);
    let _e721 = (f32(bitcast<i32>(_e135)) * _e147);
    if _e707 {
        phi_1656_ = array<f32, 3>(_e717, _e719, _e721);
    } else {
        if (_e687 == 1u) {
            phi_1655_ = array<f32, 3>(_e719, _e721, _e717);
        } else {
            phi_1655_ = array<f32, 3>(_e721, _e717, _e719);
        }
        let _e726 = phi_1655_;
        phi_1656_ = _e726;
    }
    let _e729 = phi_1656_;
    let _e740 = ((_e715[0] - _e625) * _e628);
    let _e741 = ((_e729[0] - _e626) * _e628);
    let _e742 = vec4<f32>(_e740, f32(), _e741, f32());
    let _e745 = ((_e715[1] - _e641) * _e644);
    let _e746 = ((_e729[1] - _e642) * _e644);
    let _e747 = vec4<f32>(_e745, f32(), _e746, f32());
    let _e750 = ((_e715[2] - _e657) * _e660);
    let _e751 = ((_e729[2] - _e658) * _e660);
    let _e752 = vec4<f32>(_e750, f32(), _e751, f32());
    let _e753 = vec4<f32>(_e741, f32(), _e740, f32());
    let _e755 = vec4<f32>(_e746, f32(), _e745, f32());
    let _e757 = vec4<f32>(_e751, f32(), _e750, f32());
    phi_1829_ = _e682;
    phi_1832_ = select(4294967295u, select(4294967295u, 0u, (_e668 <= _e667)), (max(max(max(min(_e742, _e753).x, min(_e747, _e755).x), min(_e752, _e757).x), _e668) <= min((min(min(max(_e742, _e753).x, max(_e747, _e755).x), max(_e752, _e757).x) + (max(max(_e752, _e757).x, -(min(_e752, _e757).x)) * 0.0000019073523f)), _e682.member.member_1)));
    phi_1834_ = select(0u, 2147483648u, (_e99 == 0u));
    phi_1836_ = (_e99 + 1u);
    loop {
        let _e781 = phi_1829_;
        let _e783 = phi_1832_;
        let _e785 = phi_1834_;
        let _e787 = phi_1836_;
        local_7 = _e781;
        let _e788 = (_e783 <= 2147483647u);
        if _e788 {
            phi_1845_ = _e783;
            phi_1848_ = _e785;
            phi_1850_ = _e787;
            loop {
                let _e790 = phi_1845_;
                let _e792 = phi_1848_;
                let _e794 = phi_1850_;
                local_2 = _e792;
                local_3 = _e792;
                local_4 = _e790;
                local_5 = _e790;
                local_9 = _e790;
                local_10 = _e792;
                local_11 = _e794;
                let _e795 = (_e790 <= 2147483647u);
                let _e797 = (_e792 + _e150);
                let _e801 = (_e795 && !(((_e792 >= _e99) || (_e797 >= _e99))));
                local_1 = _e795;
                if _e801 {
                    let _e807 = slimbvh_nodes.member[_e797].member[select(_e687, 2u, (2u < _e687))];
                    let _e813 = slimbvh_nodes.member[_e797].member[select(_e688, 2u, (2u < _e688))];
                    let _e819 = slimbvh_nodes.member[_e797].member[select(_e689, 2u, (2u < _e689))];
                    let _e822 = bitcast<u32>(_e147);
                    let _e827 = bitcast<f32>(_e807.x);
                    let _e832 = (_e827 + (f32((_e807.w >> bitcast<u32>(5u))) * _e147));
                    if (_e692 == 0u) {
                        phi_1957_ = SlimbvhTypeM(_e807.z, _e832);
                        phi_1958_ = SlimbvhTypeM(_e807.y, _e827);
                    } else {
                        phi_1957_ = SlimbvhTypeM(_e807.y, _e827);
                        phi_1958_ = SlimbvhTypeM(_e807.z, _e832);
                    }
                    let _e843 = phi_1957_;
                    let _e845 = phi_1958_;
                    let _e849 = bitcast<f32>(((_e822 + ((_e807.w & 31u) << bitcast<u32>(23i))) ^ (_e692 << bitcast<u32>(31i))));
                    let _e889 = bitcast<f32>(_e813.x);
                    let _e894 = (_e889 + (f32((_e813.w >> bitcast<u32>(5u))) * _e147));
                    if (_e695 == 0u) {
                        phi_2017_ = SlimbvhTypeM(_e813.z, _e894);
                        phi_2018_ = SlimbvhTypeM(_e813.y, _e889);
                    } else {
                        phi_2017_ = SlimbvhTypeM(_e813.y, _e889);
                        phi_2018_ = SlimbvhTypeM(_e813.z, _e894);
                    }
                    let _e905 = phi_2017_;
                    let _e907 = phi_2018_;
                    let _e911 = bitcast<f32>(((_e822 + ((_e813.w & 31u) << bitcast<u32>(23i))) ^ (_e695 << bitcast<u32>(31i))));
                    let _e951 = bitcast<f32>(_e819.x);
                    let _e956 = (_e951 + (f32((_e819.w >> bitcast<u32>(5u))) * _e147));
                    if (_e698 == 0u) {
                        phi_2077_ = SlimbvhTypeM(_e819.z, _e956);
                        phi_2078_ = SlimbvhTypeM(_e819.y, _e951);
                    } else {
                        phi_2077_ = SlimbvhTypeM(_e819.y, _e951);
                        phi_2078_ = SlimbvhTypeM(_e819.z, _e956);
                    }
                    let _e967 = phi_2077_;
                    let _e969 = phi_2078_;
                    let _e973 = bitcast<f32>(((_e822 + ((_e819.w & 31u) << bitcast<u32>(23i))) ^ (_e698 << bitcast<u32>(31i))));
                    let _e1009 = (_e849 * _e628);
                    let _e1016 = (((_e845.member_1 - _e625) * _e628) + (bitcast<f32>((bitcast<u32>(_e1009) & 2147483647u)) * -0.00012207031f));
                    let _e1025 = (-(_e849) * _e628);
                    let _e1032 = (((_e843.member_1 - _e626) * _e628) + (bitcast<f32>((bitcast<u32>(_e1025) & 2147483647u)) * 0.00012207031f));
                    let _e1041 = (_e911 * _e644);
                    let _e1048 = (((_e907.member_1 - _e641) * _e644) + (bitcast<f32>((bitcast<u32>(_e1041) & 2147483647u)) * -0.00012207031f));
                    let _e1057 = (-(_e911) * _e644);
                    let _e1064 = (((_e905.member_1 - _e642) * _e644) + (bitcast<f32>((bitcast<u32>(_e1057) & 2147483647u)) * 0.00012207031f));
                    let _e1073 = (_e973 * _e660);
                    let _e1080 = (((_e969.member_1 - _e657) * _e660) + (bitcast<f32>((bitcast<u32>(_e1073) & 2147483647u)) * -0.00012207031f));
                    let _e1085 = ((f32((_e969.member & 255u)) * _e1073) + _e1080);
                    let _e1086 = ((f32(((_e969.member >> bitcast<u32>(8u)) & 255u)) * _e1073) + _e1080);
                    let _e1087 = ((f32(((_e969.member >> bitcast<u32>(16u)) & 255u)) * _e1073) + _e1080);
                    let _e1088 = ((f32(((_e969.member >> bitcast<u32>(24u)) & 255u)) * _e1073) + _e1080);
                    let _e1089 = (-(_e973) * _e660);
                    let _e1096 = (((_e967.member_1 - _e658) * _e660) + (bitcast<f32>((bitcast<u32>(_e1089) & 2147483647u)) * 0.00012207031f));
                    let _e1101 = ((f32((_e967.member & 255u)) * _e1089) + _e1096);
                    let _e1102 = ((f32(((_e967.member >> bitcast<u32>(8u)) & 255u)) * _e1089) + _e1096);
                    let _e1103 = ((f32(((_e967.member >> bitcast<u32>(16u)) & 255u)) * _e1089) + _e1096);
                    let _e1104 = ((f32(((_e967.member >> bitcast<u32>(24u)) & 255u)) * _e1089) + _e1096);
                    let _e1137 = max(max(max(((f32((_e845.member & 255u)) * _e1009) + _e1016), ((f32((_e907.member & 255u)) * _e1041) + _e1048)), _e1085), _e668);
                    let _e1138 = max(max(max(((f32(((_e845.member >> bitcast<u32>(8u)) & 255u)) * _e1009) + _e1016), ((f32(((_e907.member >> bitcast<u32>(8u)) & 255u)) * _e1041) + _e1048)), _e1086), _e668);
                    let _e1139 = max(max(max(((f32(((_e845.member >> bitcast<u32>(16u)) & 255u)) * _e1009) + _e1016), ((f32(((_e907.member >> bitcast<u32>(16u)) & 255u)) * _e1041) + _e1048)), _e1087), _e668);
                    let _e1140 = max(max(max(((f32(((_e845.member >> bitcast<u32>(24u)) & 255u)) * _e1009) + _e1016), ((f32(((_e907.member >> bitcast<u32>(24u)) & 255u)) * _e1041) + _e1048)), _e1088), _e668);
                    let _e1145 = (_e781.member.member_1 + (bitcast<f32>((bitcast<u32>(_e781.member.member_1) & 2147483647u)) * 0.0000004768374f));
                    if (_e1137 <= min((min(min(((f32((_e843.member & 255u)) * _e1025) + _e1032), ((f32((_e905.member & 255u)) * _e1057) + _e1064)), _e1101) + (max(_e1101, -(_e1085)) * 0.0000023841915f)), _e1145)) {
                        phi_2562_ = (((bitcast<u32>(_e1137) ^ select(0u, 4294967288u, _e682.member_1)) & 2147483640u) | 4u);
                    } else {
                        phi_2562_ = 4294967288u;
                    }
                    let _e1160 = phi_2562_;
                    if (_e1138 <= min((min(min(((f32(((_e843.member >> bitcast<u32>(8u)) & 255u)) * _e1025) + _e1032), ((f32(((_e905.member >> bitcast<u32>(8u)) & 255u)) * _e1057) + _e1064)), _e1102) + (max(_e1102, -(_e1086)) * 0.0000023841915f)), _e1145)) {
                        phi_2575_ = ((((bitcast<u32>(_e1138) ^ select(0u, 4294967288u, _e682.member_1)) & 2147483640u) | 4u) | 1u);
                    } else {
                        phi_2575_ = 4294967288u;
                    }
                    let _e1168 = phi_2575_;
                    if (_e1139 <= min((min(min(((f32(((_e843.member >> bitcast<u32>(16u)) & 255u)) * _e1025) + _e1032), ((f32(((_e905.member >> bitcast<u32>(16u)) & 255u)) * _e1057) + _e1064)), _e1103) + (max(_e1103, -(_e1087)) * 0.0000023841915f)), _e1145)) {
                        phi_2588_ = ((((bitcast<u32>(_e1139) ^ select(0u, 4294967288u, _e682.member_1)) & 2147483640u) | 4u) | 2u);
                    } else {
                        phi_2588_ = 4294967288u;
                    }
                    let _e1176 = phi_2588_;
                    if (_e1140 <= min((min(min(((f32(((_e843.member >> bitcast<u32>(24u)) & 255u)) * _e1025) + _e1032), ((f32(((_e905.member >> bitcast<u32>(24u)) & 255u)) * _e1057) + _e1064)), _e1104) + (max(_e1104, -(_e1088)) * 0.0000023841915f)), _e1145)) {
                        phi_2601_ = ((((bitcast<u32>(_e1140) ^ select(0u, 4294967288u, _e682.member_1)) & 2147483640u) | 4u) | 3u);
                    } else {
                        phi_2601_ = 4294967288u;
                    }
                    let _e1184 = phi_2601_;
                    if (_e1160 < _e1168) {
                        phi_4572_ = SlimbvhTypeE(_e1160, _e1168);
                    } else {
                        phi_4572_ = SlimbvhTypeE(_e1168, _e1160);
                    }
                    let _e1189 = phi_4572_;
                    if (_e1176 < _e1184) {
                        phi_4584_ = SlimbvhTypeE(_e1176, _e1184);
                    } else {
                        phi_4584_ = SlimbvhTypeE(_e1184, _e1176);
                    }
                    let _e1196 = phi_4584_;
                    if (_e1189.member < _e1196.member) {
                        phi_4596_ = SlimbvhTypeE(_e1189.member, _e1196.member);
                    } else {
                        phi_4596_ = SlimbvhTypeE(_e1196.member, _e1189.member);
                    }
                    let _e1203 = phi_4596_;
                    if (_e1189.member_1 < _e1196.member_1) {
                        phi_4608_ = SlimbvhTypeE(_e1189.member_1, _e1196.member_1);
                    } else {
                        phi_4608_ = SlimbvhTypeE(_e1196.member_1, _e1189.member_1);
                    }
                    let _e1210 = phi_4608_;
                    if (_e1210.member < _e1203.member_1) {
                        phi_4620_ = SlimbvhTypeE(_e1210.member, _e1203.member_1);
                    } else {
                        phi_4620_ = SlimbvhTypeE(_e1203.member_1, _e1210.member);
                    }
                    let _e1217 = phi_4620_;
                    let _e1232 = (((_e1203.member & 7u) | ((_e1217.member & 7u) << bitcast<u32>(3u))) | (((_e1217.member_1 & 7u) | ((_e1210.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                    if (_e1232 == 0u) {
                        let _e1250 = (_e790 - 1u);
                        let _e1253 = local[(_e1250 % 128u)];
                        let _e1254 = (_e1253 & 511u);
                        let _e1256 = (_e1254 >> bitcast<u32>(3u));
                        let _e1259 = ((_e1256 == 0u) || (_e1250 == 4294967295u));
                        if _e1259 {
                        } else {
                            local[(_e1250 % 128u)] = (((_e1253 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1256);
                        }
                        phi_2687_ = select(_e790, _e1250, _e1259);
                        phi_2688_ = (((_e1253 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1254 & 3u) & 3u));
                    } else {
                        let _e1235 = (_e1232 >> bitcast<u32>(3u));
                        if (_e1235 == 0u) {
                            phi_2682_ = _e790;
                        } else {
                            local[(_e790 % 128u)] = ((_e797 << bitcast<u32>(9u)) | _e1235);
                            phi_2682_ = (_e790 + 1u);
                        }
                        let _e1244 = phi_2682_;
                        phi_2687_ = _e1244;
                        phi_2688_ = ((_e797 << bitcast<u32>(2i)) | ((_e1232 & 3u) & 3u));
                    }
                    let _e1274 = phi_2687_;
                    let _e1276 = phi_2688_;
                    let _e1278 = (_e1276 >> bitcast<u32>(2i));
                    if (_e1278 < _e99) {
                        let _e1284 = slimbvh_nodes.member[_e1278].member_1[(_e1276 & 3u)];
                        phi_2712_ = _e1284;
                    } else {
                        phi_2712_ = 2147483648u;
                    }
                    let _e1286 = phi_2712_;
                    let _e1287 = (_e794 - 1u);
                    phi_1846_ = select(_e1274, 4294967295u, (_e1287 == 0u));
                    phi_1849_ = _e1286;
                    phi_1851_ = _e1287;
                } else {
                    phi_1846_ = u32();
                    phi_1849_ = u32();
                    phi_1851_ = u32();
                }
                let _e1291 = phi_1846_;
                let _e1293 = phi_1849_;
                let _e1295 = phi_1851_;
                continue;
                continuing {
                    phi_1845_ = _e1291;
                    phi_1848_ = _e1293;
                    phi_1850_ = _e1295;
                    break if !(_e801);
                }
            }
            let _e1298 = local_1;
            if _e1298 {
                let _e1300 = local_2;
                let _e1303 = local_3;
                phi_2729_ = _e781;
                phi_2732_ = SlimbvhTypeE(0u, ((_e1303 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e1310 = phi_2729_;
                    let _e1312 = phi_2732_;
                    local_6 = _e1310;
                    local_8 = _e1310;
                    if (_e1312.member < _e1312.member_1) {
                        phi_2733_ = SlimbvhTypeE((_e1312.member + 1u), _e1312.member_1);
                        phi_2755_ = SlimbvhTypeE(1u, _e1312.member);
                    } else {
                        phi_2733_ = _e1312;
                        phi_2755_ = SlimbvhTypeE(0u, SlimbvhTypeE().member_1);
                    }
                    let _e1325 = phi_2733_;
                    let _e1327 = phi_2755_;
                    let _e1331 = (bitcast<i32>(_e1327.member) != 0i);
                    if _e1331 {
                        let _e1332 = (((_e1300 & 268435455u) + _e153) + _e1327.member_1);
                        let _e1333 = (_e1332 / 2u);
                        let _e1334 = (_e1332 % 2u);
                        let _e1335 = (_e1333 >= arrayLength((&slimbvh_triangles.member)));
                        if _e1335 {
                            phi_2835_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e1336 = (2u * _e1334);
                            let _e1340 = slimbvh_triangles.member[_e1333][_e1336];
                            let _e1345 = slimbvh_triangles.member[_e1333][(_e1336 + 1u)];
                            let _e1350 = slimbvh_triangles.member[_e1333][(_e1336 + 2u)];
                            if (_e1334 == 0u) {
                                phi_2834_ = array<vec4<f32>, 3>(_e1340, _e1345, _e1350);
                            } else {
                                phi_2834_ = array<vec4<f32>, 3>(vec4<f32>(_e1340.z, _e1340.w, _e1345.x, _e1345.y), vec4<f32>(_e1345.z, _e1345.w, _e1350.x, _e1350.y), vec4<f32>(_e1350.z, _e1350.w, 0f, 0f));
                            }
                            let _e1368 = phi_2834_;
                            phi_2835_ = _e1368;
                        }
                        let _e1370 = phi_2835_;
                        let _e1373 = bitcast<u32>(_e1370[2].y);
                        if _e1335 {
                            phi_2916_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e1374 = (2u * _e1334);
                            let _e1378 = slimbvh_triangles.member[_e1333][_e1374];
                            let _e1383 = slimbvh_triangles.member[_e1333][(_e1374 + 1u)];
                            let _e1388 = slimbvh_triangles.member[_e1333][(_e1374 + 2u)];
                            if (_e1334 == 0u) {
                                phi_2915_ = array<vec4<f32>, 3>(_e1378, _e1383, _e1388);
                            } else {
                                phi_2915_ = array<vec4<f32>, 3>(vec4<f32>(_e1378.z, _e1378.w, _e1383.x, _e1383.y), vec4<f32>(_e1383.z, _e1383.w, _e1388.x, _e1388.y), vec4<f32>(_e1388.z, _e1388.w, 0f, 0f));
                            }
                            let _e1406 = phi_2915_;
                            phi_2916_ = _e1406;
                        }
                        let _e1408 = phi_2916_;
                        if _e218 {
                            phi_2940_ = array<f32, 3>(_e1408[0].x, _e1408[0].y, _e1408[0].z);
                        } else {
                            if (_e213 == 1u) {
                                phi_2939_ = array<f32, 3>(_e1408[0].y, _e1408[0].z, _e1408[0].x);
                            } else {
                                phi_2939_ = array<f32, 3>(_e1408[0].z, _e1408[0].x, _e1408[0].y);
                            }
                            let _e1431 = phi_2939_;
                            phi_2940_ = _e1431;
                        }
                        let _e1434 = phi_2940_;
                        if _e218 {
                            phi_2955_ = array<f32, 3>(_e1408[0].w, _e1408[1].x, _e1408[1].y);
                        } else {
                            if (_e213 == 1u) {
                                phi_2954_ = array<f32, 3>(_e1408[1].x, _e1408[1].y, _e1408[0].w);
                            } else {
                                phi_2954_ = array<f32, 3>(_e1408[1].y, _e1408[0].w, _e1408[1].x);
                            }
                            let _e1439 = phi_2954_;
                            phi_2955_ = _e1439;
                        }
                        let _e1442 = phi_2955_;
                        if _e218 {
                            phi_2970_ = array<f32, 3>(_e1408[1].z, _e1408[1].w, _e1408[2].x);
                        } else {
                            if (_e213 == 1u) {
                                phi_2969_ = array<f32, 3>(_e1408[1].w, _e1408[2].x, _e1408[1].z);
                            } else {
                                phi_2969_ = array<f32, 3>(_e1408[2].x, _e1408[1].z, _e1408[1].w);
                            }
                            let _e1447 = phi_2969_;
                            phi_2970_ = _e1447;
                        }
                        let _e1450 = phi_2970_;
                        let _e1464 = (_e1434[2] - _e601.member[2]);
                        let _e1467 = (((_e1434[0] - _e601.member[0]) * _e656) - (_e1464 * _e624));
                        let _e1470 = (((_e1434[1] - _e601.member[1]) * _e656) - (_e1464 * _e640));
                        let _e1473 = (_e1442[2] - _e601.member[2]);
                        let _e1476 = (((_e1442[0] - _e601.member[0]) * _e656) - (_e1473 * _e624));
                        let _e1479 = (((_e1442[1] - _e601.member[1]) * _e656) - (_e1473 * _e640));
                        let _e1482 = (_e1450[2] - _e601.member[2]);
                        let _e1485 = (((_e1450[0] - _e601.member[0]) * _e656) - (_e1482 * _e624));
                        let _e1488 = (((_e1450[1] - _e601.member[1]) * _e656) - (_e1482 * _e640));
                        let _e1489 = (_e1485 * _e1479);
                        let _e1490 = (_e1488 * _e1476);
                        let _e1491 = (_e1467 * _e1488);
                        let _e1492 = (_e1470 * _e1485);
                        let _e1493 = (_e1476 * _e1470);
                        let _e1494 = (_e1479 * _e1467);
                        let _e1499 = (((_e1489 >= _e1490) && (_e1491 >= _e1492)) && (_e1493 >= _e1494));
                        let _e1505 = (_e1499 || (((_e1489 <= _e1490) && (_e1491 <= _e1492)) && (_e1493 <= _e1494)));
                        if _e1505 {
                            let _e1507 = select(-1f, 1f, _e1499);
                            let _e1509 = ((_e1489 - _e1490) * _e1507);
                            let _e1511 = select(0f, _e1509, (_e1509 > 0f));
                            let _e1513 = ((_e1491 - _e1492) * _e1507);
                            let _e1515 = select(0f, _e1513, (_e1513 > 0f));
                            let _e1517 = ((_e1493 - _e1494) * _e1507);
                            let _e1519 = select(0f, _e1517, (_e1517 > 0f));
                            let _e1521 = ((_e1511 + _e1515) + _e1519);
                            let _e1536 = ((min(min(_e1434[0], _e1442[0]), _e1450[0]) - _e625) * _e628);
                            let _e1537 = ((max(max(_e1434[0], _e1442[0]), _e1450[0]) - _e626) * _e628);
                            let _e1538 = vec4<f32>(_e1536, f32(), _e1537, f32());
                            let _e1541 = ((min(min(_e1434[1], _e1442[1]), _e1450[1]) - _e641) * _e644);
                            let _e1542 = ((max(max(_e1434[1], _e1442[1]), _e1450[1]) - _e642) * _e644);
                            let _e1543 = vec4<f32>(_e1541, f32(), _e1542, f32());
                            let _e1546 = ((min(min(_e1434[2], _e1442[2]), _e1450[2]) - _e657) * _e660);
                            let _e1547 = ((max(max(_e1434[2], _e1442[2]), _e1450[2]) - _e658) * _e660);
                            let _e1548 = vec4<f32>(_e1546, f32(), _e1547, f32());
                            let _e1549 = vec4<f32>(_e1537, f32(), _e1536, f32());
                            let _e1551 = vec4<f32>(_e1542, f32(), _e1541, f32());
                            let _e1553 = vec4<f32>(_e1547, f32(), _e1546, f32());
                            let _e1562 = max(max(min(_e1538, _e1549).x, min(_e1543, _e1551).x), min(_e1548, _e1553).x);
                            let _e1567 = min(min(max(_e1538, _e1549).x, max(_e1543, _e1551).x), max(_e1548, _e1553).x);
                            let _e1572 = max(_e1562, _e668);
                            let _e1594 = (((((_e1505 && (_e1521 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1467, _e1476), _e1485) <= 0f) && (max(max(_e1467, _e1476), _e1485) >= 0f))) && ((min(min(_e1470, _e1479), _e1488) <= 0f) && (max(max(_e1470, _e1479), _e1488) >= 0f))) && (_e1572 <= (_e1567 + (max(max(_e1548, _e1553).x, -(min(_e1548, _e1553).x)) * 0.0000019073523f)))) && (_e1572 <= _e1310.member.member_1));
                            if _e1594 {
                                let _e1599 = (_e1442[0] - _e1434[0]);
                                let _e1600 = (_e1442[1] - _e1434[1]);
                                let _e1601 = (_e1442[2] - _e1434[2]);
                                let _e1602 = vec3<f32>(_e1599, _e1600, _e1601);
                                let _e1603 = (_e1450[0] - _e1442[0]);
                                let _e1604 = (_e1450[1] - _e1442[1]);
                                let _e1605 = (_e1450[2] - _e1442[2]);
                                let _e1606 = vec3<f32>(_e1603, _e1604, _e1605);
                                let _e1607 = (_e1434[0] - _e1450[0]);
                                let _e1608 = (_e1434[1] - _e1450[1]);
                                let _e1609 = (_e1434[2] - _e1450[2]);
                                let _e1610 = vec3<f32>(_e1607, _e1608, _e1609);
                                let _e1621 = max(max(bitcast<f32>((bitcast<u32>(_e1599) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1600) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1601) & 2147483647u)));
                                let _e1632 = max(max(bitcast<f32>((bitcast<u32>(_e1603) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1604) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1605) & 2147483647u)));
                                let _e1645 = max(max(_e1621, _e1632), max(max(bitcast<f32>((bitcast<u32>(_e1607) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1608) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1609) & 2147483647u))));
                                if (_e1621 == _e1645) {
                                    phi_3329_ = _e1479;
                                    phi_3330_ = _e1476;
                                    phi_3331_ = _e1470;
                                    phi_3332_ = _e1467;
                                    phi_3333_ = vec3<f32>(_e1434[0], _e1434[1], _e1434[2]);
                                    phi_3334_ = _e1610;
                                    phi_3335_ = _e1606;
                                    phi_3336_ = _e1602;
                                } else {
                                    let _e1647 = (_e1632 == _e1645);
                                    let _e1652 = vec3(_e1647);
                                    phi_3329_ = select(_e1470, _e1488, _e1647);
                                    phi_3330_ = select(_e1467, _e1485, _e1647);
                                    phi_3331_ = select(_e1488, _e1479, _e1647);
                                    phi_3332_ = select(_e1485, _e1476, _e1647);
                                    phi_3333_ = select(vec3<f32>(_e1450[0], _e1450[1], _e1450[2]), vec3<f32>(_e1442[0], _e1442[1], _e1442[2]), _e1652);
                                    phi_3334_ = select(_e1606, _e1602, _e1652);
                                    phi_3335_ = select(_e1602, _e1610, _e1652);
                                    phi_3336_ = select(_e1610, _e1606, _e1652);
                                }
                                let _e1658 = phi_3329_;
                                let _e1660 = phi_3330_;
                                let _e1662 = phi_3331_;
                                let _e1664 = phi_3332_;
                                let _e1666 = phi_3333_;
                                let _e1668 = phi_3334_;
                                let _e1670 = phi_3335_;
                                let _e1672 = phi_3336_;
                                let _e1679 = ((_e1670.y * _e1668.z) - (_e1668.y * _e1670.z));
                                let _e1684 = ((_e1670.z * _e1668.x) - (_e1668.z * _e1670.x));
                                let _e1687 = ((_e1670.x * _e1668.y) - (_e1668.x * _e1670.y));
                                let _e1690 = ((_e1511 >= _e1515) && (_e1511 >= _e1519));
                                let _e1691 = (_e1515 >= _e1519);
                                let _e1705 = (((_e1679 * (select(select(_e1450[0], _e1442[0], _e1691), _e1434[0], _e1690) - _e601.member[0])) + (_e1684 * (select(select(_e1450[1], _e1442[1], _e1691), _e1434[1], _e1690) - _e601.member[1]))) + (_e1687 * (select(select(_e1450[2], _e1442[2], _e1691), _e1434[2], _e1690) - _e601.member[2])));
                                let _e1710 = (((_e1679 * _e624) + (_e1684 * _e640)) + (_e1687 * _e656));
                                let _e1711 = (_e1660 - _e1664);
                                let _e1712 = (_e1658 - _e1662);
                                let _e1715 = ((_e1711 * _e1711) + (_e1712 * _e1712));
                                let _e1722 = (-(((_e1664 * _e1711) + (_e1662 * _e1712))) / select(0.000000000000000000000000000000000000011754944f, _e1715, (_e1715 > 0.000000000000000000000000000000000000011754944f)));
                                let _e1724 = select(1f, _e1722, (_e1722 < 1f));
                                let _e1726 = select(0f, _e1724, (_e1724 > 0f));
                                let _e1735 = ((_e1666.x + (_e1672.x * _e1726)) - _e601.member[0]);
                                let _e1738 = ((_e1666.y + (_e1672.y * _e1726)) - _e601.member[1]);
                                let _e1741 = ((_e1666.z + (_e1672.z * _e1726)) - _e601.member[2]);
                                let _e1806 = ((bitcast<f32>((bitcast<u32>(((((_e1679 * _e1735) + (_e1684 * _e1738)) + (_e1687 * _e1741)) - _e1705)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1735) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1738) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1741) & 2147483647u))), _e1645)) * max(max(bitcast<f32>((bitcast<u32>(_e1679) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1684) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1687) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1710) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1670.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1670.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1670.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1668.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1668.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1668.z) & 2147483647u)))))));
                                let _e1807 = (_e1705 / _e1710);
                                if (_e1594 && !(_e1806)) {
                                    let _e1810 = (_e1741 / _e656);
                                    let _e1818 = (((_e1679 * (_e1735 - (_e624 * _e1810))) + (_e1684 * (_e1738 - (_e640 * _e1810)))) / _e1710);
                                    phi_3515_ = select(select(_e1810, (_e1810 + _e1818), (bitcast<f32>((bitcast<u32>(_e1818) & 2147483647u)) <= _e1645)), _e1807, _e1806);
                                } else {
                                    phi_3515_ = _e1807;
                                }
                                let _e1827 = phi_3515_;
                                let _e1829 = select(_e1567, _e1827, (_e1827 < _e1567));
                                let _e1831 = select(_e1562, _e1829, (_e1829 > _e1562));
                                let _e1834 = select(_e1831, 0f, (bitcast<u32>(_e1831) == 2147483648u));
                                let _e1835 = (1f / _e1521);
                                phi_3541_ = SlimbvhTypeF(_e1834, (_e1515 * _e1835), (_e1519 * _e1835), ((_e1594 && (_e1834 >= _e668)) && (_e1834 <= _e1310.member.member_1)));
                                phi_3542_ = SlimbvhTypeF();
                            } else {
                                phi_3541_ = SlimbvhTypeF();
                                phi_3542_ = SlimbvhTypeF(0f, 0f, 0f, _e1594);
                            }
                            let _e1844 = phi_3541_;
                            let _e1846 = phi_3542_;
                            phi_3545_ = _e1844;
                            phi_3546_ = _e1846;
                            phi_3547_ = select(true, false, _e1594);
                        } else {
                            phi_3545_ = SlimbvhTypeF();
                            phi_3546_ = SlimbvhTypeF(0f, 0f, 0f, _e1505);
                            phi_3547_ = true;
                        }
                        let _e1849 = phi_3545_;
                        let _e1851 = phi_3546_;
                        let _e1853 = phi_3547_;
                        if _e1853 {
                            phi_3551_ = _e1851;
                        } else {
                            phi_3551_ = _e1849;
                        }
                        let _e1855 = phi_3551_;
                        if _e1855.member_3 {
                            phi_3560_ = SlimbvhTypeG(_e1855.member, _e1855.member_1, _e1855.member_2, _e1373);
                        } else {
                            phi_3560_ = _e95;
                        }
                        let _e1862 = phi_3560_;
                        if (_e1862.member_3 != 4294967295u) {
                            let _e1868 = slimbvh_target.member[0u][0u];
                            let _e1872 = slimbvh_target.member[0u][1u];
                            let _e1876 = slimbvh_target.member[0u][2u];
                            let _e1880 = slimbvh_target.member[0u][3u];
                            let _e1884 = slimbvh_target.member[1u][0u];
                            let _e1888 = slimbvh_target.member[1u][1u];
                            let _e1892 = slimbvh_target.member[1u][2u];
                            let _e1896 = slimbvh_target.member[1u][3u];
                            let _e1897 = bitcast<f32>(_e1868);
                            let _e1898 = bitcast<f32>(_e1872);
                            let _e1899 = bitcast<f32>(_e1876);
                            let _e1901 = bitcast<f32>(_e1884);
                            let _e1902 = array<u32, 3>(_e1888, _e1892, _e1896);
                            if (_e171 < -126i) {
                                phi_3613_ = -126i;
                            } else {
                                phi_3613_ = select(_e171, 127i, (_e171 > 127i));
                            }
                            let _e1908 = phi_3613_;
                            let _e1913 = bitcast<f32>((bitcast<u32>((_e1908 + 127i)) << bitcast<u32>(23i)));
                            let _e1919 = bitcast<f32>((bitcast<u32>(((_e171 - _e1908) + 127i)) << bitcast<u32>(23i)));
                            if (_e1880 == 0u) {
                                phi_3753_ = SlimbvhTypeI(array<f32, 3>(_e1897, _e1898, _e1899), _e1880, _e1901, _e1902);
                            } else {
                                let _e1921 = bitcast<u32>(_e1897);
                                let _e1923 = ((_e1921 & 2139095040u) != 0u);
                                let _e1938 = bitcast<u32>(_e1898);
                                let _e1940 = ((_e1938 & 2139095040u) != 0u);
                                let _e1955 = bitcast<u32>(_e1899);
                                let _e1957 = ((_e1955 & 2139095040u) != 0u);
                                let _e1973 = bitcast<u32>(_e1901);
                                let _e1975 = ((_e1973 & 2139095040u) != 0u);
                                phi_3753_ = SlimbvhTypeI(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1921 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1921 & 2147483648u))), _e1897, _e1923) * _e1913) * select(0.00000011920929f, 1f, _e1923)) * _e1919), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1938 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1938 & 2147483648u))), _e1898, _e1940) * _e1913) * select(0.00000011920929f, 1f, _e1940)) * _e1919), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1955 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1955 & 2147483648u))), _e1899, _e1957) * _e1913) * select(0.00000011920929f, 1f, _e1957)) * _e1919)), _e1880, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1973 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1973 & 2147483648u))), _e1901, _e1975) * _e1913) * select(0.00000011920929f, 1f, _e1975)) * _e1919), _e1902);
                            }
                            let _e1992 = phi_3753_;
                            if (_e1373 == _e672) {
                                phi_4079_ = false;
                            } else {
                                let _e1994 = (_e1373 / 16u);
                                if (_e1994 < arrayLength((&slimbvh_sides.member))) {
                                    let _e1997 = slimbvh_sides.member[_e1994];
                                    phi_3777_ = _e1997;
                                } else {
                                    phi_3777_ = 0u;
                                }
                                let _e1999 = phi_3777_;
                                let _e2008 = (bitcast<i32>((_e1999 << bitcast<u32>(((30u - ((_e1373 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                let _e2009 = (_e2008 == 0i);
                                if _e2009 {
                                    phi_4078_ = true;
                                } else {
                                    if _e218 {
                                        phi_3806_ = vec3<f32>(_e1434[0], _e1434[1], _e1434[2]);
                                    } else {
                                        if (_e213 == 1u) {
                                            phi_3805_ = vec3<f32>(_e1434[2], _e1434[0], _e1434[1]);
                                        } else {
                                            phi_3805_ = vec3<f32>(_e1434[1], _e1434[2], _e1434[0]);
                                        }
                                        let _e2014 = phi_3805_;
                                        phi_3806_ = _e2014;
                                    }
                                    let _e2017 = phi_3806_;
                                    if _e218 {
                                        phi_3824_ = vec3<f32>(_e1442[0], _e1442[1], _e1442[2]);
                                    } else {
                                        if (_e213 == 1u) {
                                            phi_3823_ = vec3<f32>(_e1442[2], _e1442[0], _e1442[1]);
                                        } else {
                                            phi_3823_ = vec3<f32>(_e1442[1], _e1442[2], _e1442[0]);
                                        }
                                        let _e2022 = phi_3823_;
                                        phi_3824_ = _e2022;
                                    }
                                    let _e2025 = phi_3824_;
                                    if _e218 {
                                        phi_3842_ = vec3<f32>(_e1450[0], _e1450[1], _e1450[2]);
                                    } else {
                                        if (_e213 == 1u) {
                                            phi_3841_ = vec3<f32>(_e1450[2], _e1450[0], _e1450[1]);
                                        } else {
                                            phi_3841_ = vec3<f32>(_e1450[1], _e1450[2], _e1450[0]);
                                        }
                                        let _e2030 = phi_3841_;
                                        phi_3842_ = _e2030;
                                    }
                                    let _e2033 = phi_3842_;
                                    let _e2036 = (_e2025.x - _e2017.x);
                                    let _e2039 = (_e2025.y - _e2017.y);
                                    let _e2042 = (_e2025.z - _e2017.z);
                                    let _e2044 = (_e2033.x - _e2017.x);
                                    let _e2046 = (_e2033.y - _e2017.y);
                                    let _e2048 = (_e2033.z - _e2017.z);
                                    if (_e1992.member_1 == 1u) {
                                        phi_3878_ = (vec3<f32>(_e1992.member[0], _e1992.member[1], _e1992.member[2]) - _e2017);
                                    } else {
                                        phi_3878_ = vec3<f32>(_e1992.member[0], _e1992.member[1], _e1992.member[2]);
                                    }
                                    let _e2063 = phi_3878_;
                                    let _e2069 = bitcast<f32>((bitcast<u32>((_e2036 * _e2046)) ^ _e1992.member_3[0]));
                                    let _e2073 = bitcast<f32>((bitcast<u32>((_e2039 * _e2044)) ^ _e1992.member_3[0]));
                                    let _e2077 = bitcast<f32>((bitcast<u32>((_e2039 * _e2048)) ^ _e1992.member_3[0]));
                                    let _e2081 = bitcast<f32>((bitcast<u32>((_e2042 * _e2046)) ^ _e1992.member_3[0]));
                                    let _e2085 = bitcast<f32>((bitcast<u32>((_e2042 * _e2044)) ^ _e1992.member_3[0]));
                                    let _e2089 = bitcast<f32>((bitcast<u32>((_e2036 * _e2048)) ^ _e1992.member_3[0]));
                                    let _e2090 = (_e2077 - _e2081);
                                    let _e2091 = (_e2085 - _e2089);
                                    let _e2092 = (_e2069 - _e2073);
                                    let _e2116 = (bitcast<f32>((bitcast<u32>(_e2077) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2081) & 2147483647u)));
                                    let _e2123 = (bitcast<f32>((bitcast<u32>(_e2085) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2089) & 2147483647u)));
                                    let _e2130 = (bitcast<f32>((bitcast<u32>(_e2069) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2073) & 2147483647u)));
                                    if (_e1992.member_2 == 0f) {
                                        phi_4060_ = 0f;
                                    } else {
                                        let _e2160 = bitcast<f32>((bitcast<u32>(_e2090) & 2147483647u));
                                        let _e2163 = bitcast<f32>((bitcast<u32>(_e2091) & 2147483647u));
                                        let _e2166 = bitcast<f32>((bitcast<u32>(_e2092) & 2147483647u));
                                        let _e2168 = select(_e2166, _e2163, (_e2163 > _e2166));
                                        let _e2172 = select(_e2166, _e2163, (_e2163 < _e2166));
                                        let _e2176 = select(_e2163, _e2160, (_e2160 < _e2163));
                                        let _e2178 = select(_e2163, _e2160, (_e2160 > _e2163));
                                        let _e2180 = select(_e2166, _e2178, (_e2178 < _e2166));
                                        phi_4060_ = bitcast<f32>((bitcast<u32>((_e1992.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2168, _e2160, (_e2160 > _e2168)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2180, _e2176, (_e2176 > _e2180)))) ^ _e1992.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2172, _e2160, (_e2160 < _e2172)))) ^ _e1992.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2116 + _e2123) + _e2130))) ^ _e1992.member_3[0]))) * 1.0000005f)) ^ _e1992.member_3[0])))) ^ _e1992.member_3[0]));
                                    }
                                    let _e2207 = phi_4060_;
                                    phi_4078_ = (_e2009 || !(((((bitcast<f32>((bitcast<u32>((_e2063.x * _e2090)) ^ _e1992.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2063.y * _e2091)) ^ _e1992.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2063.z * _e2092)) ^ _e1992.member_3[0]))) * f32(-(_e2008))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2063.x) & 2147483647u)) * _e2116)) ^ _e1992.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2063.y) & 2147483647u)) * _e2123)) ^ _e1992.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2063.z) & 2147483647u)) * _e2130)) ^ _e1992.member_3[0]))))) ^ _e1992.member_3[0])) + _e2207) + 0.0000000000000000000000000000000000001880791f))));
                                }
                                let _e2221 = phi_4078_;
                                phi_4079_ = _e2221;
                            }
                            let _e2223 = phi_4079_;
                            if _e2223 {
                                if (_e1862.member < _e1310.member.member.member) {
                                    phi_4099_ = true;
                                } else {
                                    if (_e1862.member == _e1310.member.member.member) {
                                        phi_4098_ = (_e1862.member_3 < _e1310.member.member.member_3);
                                    } else {
                                        phi_4098_ = false;
                                    }
                                    let _e2235 = phi_4098_;
                                    phi_4099_ = _e2235;
                                }
                                let _e2237 = phi_4099_;
                                if _e2237 {
                                    phi_4106_ = SlimbvhTypeP(SlimbvhTypeJ(_e1862, _e1862.member), _e1310.member_1);
                                } else {
                                    phi_4106_ = _e1310;
                                }
                                let _e2243 = phi_4106_;
                                if _e2243.member_1 {
                                    phi_4112_ = SlimbvhTypeP(SlimbvhTypeJ(_e2243.member.member, bitcast<f32>(4286578687u)), _e2243.member_1);
                                } else {
                                    phi_4112_ = _e2243;
                                }
                                let _e2252 = phi_4112_;
                                phi_4113_ = _e2252;
                            } else {
                                phi_4113_ = _e1310;
                            }
                            let _e2254 = phi_4113_;
                            phi_4114_ = _e2254;
                        } else {
                            phi_4114_ = _e1310;
                        }
                        let _e2256 = phi_4114_;
                        phi_2730_ = _e2256;
                    } else {
                        phi_2730_ = SlimbvhTypeP();
                    }
                    let _e2258 = phi_2730_;
                    continue;
                    continuing {
                        phi_2729_ = _e2258;
                        phi_2732_ = _e1325;
                        break if !(_e1331);
                    }
                }
                let _e2261 = local_4;
                let _e2262 = (_e2261 - 1u);
                let _e2265 = local[(_e2262 % 128u)];
                let _e2266 = (_e2265 & 511u);
                let _e2268 = (_e2266 >> bitcast<u32>(3u));
                let _e2271 = ((_e2268 == 0u) || (_e2262 == 4294967295u));
                if _e2271 {
                } else {
                    local[(_e2262 % 128u)] = (((_e2265 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2268);
                }
                let _e2278 = local_5;
                let _e2286 = (((_e2265 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2266 & 3u) & 3u));
                let _e2288 = (_e2286 >> bitcast<u32>(2i));
                if (_e2288 < _e99) {
                    let _e2294 = slimbvh_nodes.member[_e2288].member_1[(_e2286 & 3u)];
                    phi_4173_ = _e2294;
                } else {
                    phi_4173_ = 2147483648u;
                }
                let _e2296 = phi_4173_;
                let _e2298 = local_6;
                let _e2570 = local_8;
                phi_4182_ = _e2570;
                phi_4183_ = select(select(_e2278, _e2262, _e2271), 4294967295u, (_e668 > _e2298.member.member_1));
                phi_4184_ = _e2296;
            } else {
                phi_4182_ = _e781;
                let _e2573 = local_9;
                phi_4183_ = _e2573;
                let _e2576 = local_10;
                phi_4184_ = _e2576;
            }
            let _e2304 = phi_4182_;
            let _e2306 = phi_4183_;
            let _e2308 = phi_4184_;
            phi_1830_ = _e2304;
            phi_1833_ = _e2306;
            phi_1835_ = _e2308;
            let _e2582 = local_11;
            phi_1837_ = _e2582;
        } else {
            phi_1830_ = SlimbvhTypeP();
            phi_1833_ = u32();
            phi_1835_ = u32();
            phi_1837_ = u32();
        }
        let _e2310 = phi_1830_;
        let _e2312 = phi_1833_;
        let _e2314 = phi_1835_;
        let _e2316 = phi_1837_;
        continue;
        continuing {
            phi_1829_ = _e2310;
            phi_1832_ = _e2312;
            phi_1834_ = _e2314;
            phi_1836_ = _e2316;
            break if !(_e788);
        }
    }
    let _e2319 = local_7;
    if (_e2319.member.member.member_3 != 4294967295u) {
        let _e2325 = -((_e171 + _e601.member_4));
        let _e2326 = bitcast<u32>(_e2319.member.member.member);
        let _e2330 = (bitcast<i32>((_e2326 >> bitcast<u32>(23i))) & 255i);
        let _e2331 = (_e2330 + _e2325);
        if (_e2330 == 255i) {
            phi_4241_ = _e2319.member.member.member;
        } else {
            if (_e2330 > 0i) {
                if (_e2331 > 0i) {
                    let _e2335 = (_e2331 < 255i);
                    if _e2335 {
                        phi_4220_ = bitcast<f32>((_e2326 + bitcast<u32>((_e2325 << bitcast<u32>(23i)))));
                    } else {
                        phi_4220_ = f32();
                    }
                    let _e2342 = phi_4220_;
                    phi_4222_ = _e2342;
                    phi_4223_ = select(true, false, _e2335);
                } else {
                    phi_4222_ = f32();
                    phi_4223_ = true;
                }
                let _e2345 = phi_4222_;
                let _e2347 = phi_4223_;
                phi_4224_ = _e2345;
                phi_4225_ = _e2347;
            } else {
                phi_4224_ = f32();
                phi_4225_ = true;
            }
            let _e2349 = phi_4224_;
            let _e2351 = phi_4225_;
            if _e2351 {
                let _e2352 = (_e2326 & 2147483648u);
                let _e2359 = ((_e2326 & 8388607u) | (select(0u, 1u, ((_e2326 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e2363 = (_e2359 == 0u);
                if _e2363 {
                    phi_4901_ = bitcast<f32>(_e2352);
                } else {
                    let _e2368 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2359)), 32u, _e2363) - 8u);
                    let _e2371 = (_e2359 << bitcast<u32>((_e2368 & 31u)));
                    let _e2373 = ((_e2331 + select(0i, 1i, (_e2330 == 0i))) - bitcast<i32>(_e2368));
                    if (_e2373 >= 255i) {
                        phi_4891_ = bitcast<f32>((_e2352 | 2139095040u));
                        phi_4892_ = f32();
                        phi_4893_ = true;
                    } else {
                        let _e2375 = (_e2373 > 0i);
                        if _e2375 {
                            phi_4885_ = bitcast<f32>(((_e2352 | (bitcast<u32>(_e2373) << bitcast<u32>(23i))) | (_e2371 & 8388607u)));
                            phi_4886_ = f32();
                        } else {
                            if (_e2373 < -24i) {
                                phi_4851_ = 26u;
                            } else {
                                phi_4851_ = bitcast<u32>((1i - _e2373));
                            }
                            let _e2380 = phi_4851_;
                            let _e2381 = (_e2380 & 31u);
                            let _e2383 = (_e2371 >> bitcast<u32>(_e2381));
                            let _e2387 = (_e2371 & ((1u << bitcast<u32>(_e2381)) - 1u));
                            let _e2391 = (1u << bitcast<u32>(((_e2380 - 1u) & 31u)));
                            if (_e2387 > _e2391) {
                                phi_4872_ = true;
                            } else {
                                if (_e2387 == _e2391) {
                                    phi_4869_ = ((_e2383 & 1u) == 1u);
                                } else {
                                    phi_4869_ = false;
                                }
                                let _e2397 = phi_4869_;
                                phi_4872_ = _e2397;
                            }
                            let _e2399 = phi_4872_;
                            phi_4885_ = f32();
                            phi_4886_ = bitcast<f32>((_e2352 | (_e2383 + select(0u, 1u, _e2399))));
                        }
                        let _e2412 = phi_4885_;
                        let _e2414 = phi_4886_;
                        phi_4891_ = _e2412;
                        phi_4892_ = _e2414;
                        phi_4893_ = _e2375;
                    }
                    let _e2418 = phi_4891_;
                    let _e2420 = phi_4892_;
                    let _e2422 = phi_4893_;
                    phi_4901_ = select(_e2420, _e2418, _e2422);
                }
                let _e2426 = phi_4901_;
                phi_4240_ = _e2426;
            } else {
                phi_4240_ = _e2349;
            }
            let _e2428 = phi_4240_;
            phi_4241_ = _e2428;
        }
        let _e2430 = phi_4241_;
        let _e2431 = bitcast<u32>(_e2430);
        if ((_e2431 & 2147483647u) >= 2139095040u) {
            phi_4253_ = bitcast<f32>(((_e2431 & 2147483648u) | 2139095039u));
        } else {
            phi_4253_ = _e2430;
        }
        let _e2438 = phi_4253_;
        phi_4258_ = SlimbvhTypeG(_e2438, _e2319.member.member.member_1, _e2319.member.member.member_2, _e2319.member.member.member_3);
    } else {
        phi_4258_ = _e95;
    }
    let _e2443 = phi_4258_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2443.member), bitcast<u32>(_e2443.member_1), bitcast<u32>(_e2443.member_2), _e2443.member_3);
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
