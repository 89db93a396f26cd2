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
    var phi_744_: u32;
    var phi_750_: u32;
    var phi_756_: u32;
    var phi_1021_: i32;
    var phi_1032_: i32;
    var phi_1146_: i32;
    var phi_1275_: i32;
    var phi_1297_: u32;
    var phi_1298_: u32;
    var phi_1299_: bool;
    var phi_1333_: i32;
    var phi_1355_: u32;
    var phi_1356_: u32;
    var phi_1357_: bool;
    var phi_918_: i32;
    var phi_924_: u32;
    var phi_943_: u32;
    var phi_944_: u32;
    var phi_945_: bool;
    var phi_963_: i32;
    var phi_969_: u32;
    var phi_988_: u32;
    var phi_989_: u32;
    var phi_990_: bool;
    var phi_1367_: SlimbvhTypeC;
    var phi_1606_: SlimbvhTypeP;
    var phi_1669_: array<f32, 3>;
    var phi_1670_: array<f32, 3>;
    var phi_1688_: array<f32, 3>;
    var phi_1689_: array<f32, 3>;
    var phi_1862_: SlimbvhTypeP;
    var phi_1865_: u32;
    var phi_1867_: u32;
    var phi_1869_: u32;
    var phi_1878_: u32;
    var phi_1881_: u32;
    var phi_1883_: u32;
    var phi_1990_: SlimbvhTypeJ;
    var phi_1991_: SlimbvhTypeJ;
    var phi_2050_: SlimbvhTypeJ;
    var phi_2051_: SlimbvhTypeJ;
    var phi_2110_: SlimbvhTypeJ;
    var phi_2111_: SlimbvhTypeJ;
    var phi_2601_: u32;
    var phi_2614_: u32;
    var phi_2627_: u32;
    var phi_2640_: u32;
    var phi_5358_: SlimbvhTypeD;
    var phi_5370_: SlimbvhTypeD;
    var phi_5382_: SlimbvhTypeD;
    var phi_5394_: SlimbvhTypeD;
    var phi_5406_: SlimbvhTypeD;
    var phi_2721_: u32;
    var phi_2726_: u32;
    var phi_2727_: u32;
    var phi_2781_: u32;
    var phi_2782_: u32;
    var phi_1879_: u32;
    var phi_1882_: u32;
    var phi_1884_: u32;
    var local_1: bool;
    var local_2: u32;
    var phi_2967_: u32;
    var phi_2972_: u32;
    var phi_3015_: SlimbvhTypeM;
    var phi_3022_: SlimbvhTypeP;
    var phi_3025_: SlimbvhTypeD;
    var phi_3026_: SlimbvhTypeD;
    var phi_3048_: SlimbvhTypeD;
    var phi_3073_: u32;
    var phi_3096_: u32;
    var phi_3105_: u32;
    var phi_3115_: u32;
    var phi_3574_: u32;
    var phi_3587_: u32;
    var phi_3600_: u32;
    var phi_3626_: u32;
    var phi_3639_: u32;
    var phi_3652_: u32;
    var phi_3678_: u32;
    var phi_3691_: u32;
    var phi_3704_: u32;
    var phi_3296_: u32;
    var phi_3309_: u32;
    var phi_3319_: u32;
    var phi_3340_: u32;
    var phi_3361_: u32;
    var phi_3388_: u32;
    var phi_3401_: u32;
    var phi_3411_: u32;
    var phi_3432_: u32;
    var phi_3453_: u32;
    var phi_3480_: u32;
    var phi_3493_: u32;
    var phi_3503_: u32;
    var phi_3524_: u32;
    var phi_3545_: u32;
    var phi_3157_: u32;
    var phi_3203_: u32;
    var phi_3249_: u32;
    var phi_3716_: array<array<f32, 3>, 3>;
    var phi_4081_: f32;
    var phi_4082_: f32;
    var phi_4083_: f32;
    var phi_4084_: f32;
    var phi_4085_: vec3<f32>;
    var phi_4086_: vec3<f32>;
    var phi_4087_: vec3<f32>;
    var phi_4088_: vec3<f32>;
    var phi_4267_: f32;
    var phi_4293_: SlimbvhTypeE;
    var phi_4294_: SlimbvhTypeE;
    var phi_4297_: SlimbvhTypeE;
    var phi_4298_: SlimbvhTypeE;
    var phi_4299_: bool;
    var phi_4303_: SlimbvhTypeE;
    var phi_4312_: SlimbvhTypeF;
    var phi_4365_: i32;
    var phi_4505_: SlimbvhTypeH;
    var phi_4529_: u32;
    var phi_4558_: vec3<f32>;
    var phi_4559_: vec3<f32>;
    var phi_4577_: vec3<f32>;
    var phi_4578_: vec3<f32>;
    var phi_4596_: vec3<f32>;
    var phi_4597_: vec3<f32>;
    var phi_4633_: vec3<f32>;
    var phi_4815_: f32;
    var phi_4833_: bool;
    var phi_4834_: bool;
    var phi_4853_: bool;
    var phi_4854_: bool;
    var phi_4861_: SlimbvhTypeP;
    var phi_4867_: SlimbvhTypeP;
    var phi_4868_: SlimbvhTypeP;
    var phi_4869_: SlimbvhTypeP;
    var phi_3023_: SlimbvhTypeP;
    var local_3: u32;
    var local_4: u32;
    var phi_4958_: u32;
    var phi_4959_: u32;
    var local_5: SlimbvhTypeP;
    var phi_4968_: SlimbvhTypeP;
    var phi_4969_: u32;
    var phi_4970_: u32;
    var phi_1863_: SlimbvhTypeP;
    var phi_1866_: u32;
    var phi_1868_: u32;
    var phi_1870_: u32;
    var local_6: SlimbvhTypeP;
    var phi_5006_: f32;
    var phi_5008_: f32;
    var phi_5009_: bool;
    var phi_5010_: f32;
    var phi_5011_: bool;
    var phi_5637_: u32;
    var phi_5655_: bool;
    var phi_5658_: bool;
    var phi_5671_: f32;
    var phi_5672_: f32;
    var phi_5677_: f32;
    var phi_5678_: f32;
    var phi_5679_: bool;
    var phi_5687_: f32;
    var phi_5026_: f32;
    var phi_5027_: f32;
    var phi_5039_: f32;
    var phi_5044_: SlimbvhTypeF;
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
    let _e175 = slimbvh_exponent.member[1u];
    let _e178 = slimbvh_exponent.member[2u];
    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    let _e179 = slimbvh_origin.member;
    let _e185 = slimbvh_origin.member[3u];
    let _e186 = slimbvh_direction.member;
    let _e192 = slimbvh_direction.member[3u];
    let _e195 = slimbvh_exponent.member[0u];
    let _e196 = bitcast<i32>(_e195);
    let _e198 = (bitcast<u32>(_e179.x) & 2147483647u);
    let _e200 = (bitcast<u32>(_e179.y) & 2147483647u);
    let _e202 = (bitcast<u32>(_e179.z) & 2147483647u);
    let _e203 = bitcast<u32>(_e185);
    let _e204 = (_e203 & 2147483647u);
    let _e206 = (bitcast<u32>(_e186.x) & 2147483647u);
    let _e208 = (bitcast<u32>(_e186.y) & 2147483647u);
    let _e210 = (bitcast<u32>(_e186.z) & 2147483647u);
    let _e211 = bitcast<u32>(_e192);
    let _e212 = (_e211 & 2147483647u);
    let _e214 = select(_e208, _e206, (_e208 < _e206));
    let _e216 = select(_e210, _e214, (_e210 < _e214));
    let _e218 = select(_e198, _e216, (_e198 < _e216));
    let _e220 = select(_e200, _e218, (_e200 < _e218));
    let _e222 = select(_e202, _e220, (_e202 < _e220));
    let _e229 = (((select(_e204, _e222, (_e204 < _e222)) < 2139095040u) && (_e212 <= 2139095040u)) && (_e216 > 0u));
    if (_e206 == _e216) {
        phi_744_ = 0u;
    } else {
        phi_744_ = select(2u, 1u, (_e208 == _e216));
    }
    let _e234 = phi_744_;
    let _e235 = (_e234 == 2u);
    if _e235 {
        phi_750_ = 0u;
    } else {
        phi_750_ = (_e234 + 1u);
    }
    let _e238 = phi_750_;
    let _e239 = (_e238 == 2u);
    if _e239 {
        phi_756_ = 0u;
    } else {
        phi_756_ = (_e238 + 1u);
    }
    let _e242 = phi_756_;
    let _e243 = (_e238 == 0u);
    let _e245 = select(select(_e179.y, _e179.x, _e243), _e179.z, _e239);
    let _e246 = (_e242 == 0u);
    let _e248 = (_e242 == 2u);
    let _e249 = select(select(_e179.y, _e179.x, _e246), _e179.z, _e248);
    let _e250 = (_e234 == 0u);
    let _e252 = select(select(_e179.y, _e179.x, _e250), _e179.z, _e235);
    let _e254 = select(select(_e186.y, _e186.x, _e243), _e186.z, _e239);
    let _e256 = select(select(_e186.y, _e186.x, _e246), _e186.z, _e248);
    let _e258 = select(select(_e186.y, _e186.x, _e250), _e186.z, _e235);
    let _e259 = (_e204 - 1u);
    let _e260 = (_e212 - 1u);
    let _e262 = select(_e259, _e260, (_e260 < _e259));
    let _e263 = (_e198 - 1u);
    let _e264 = (_e200 - 1u);
    let _e266 = select(_e263, _e264, (_e264 < _e263));
    let _e267 = (_e202 - 1u);
    let _e269 = select(_e266, _e267, (_e267 < _e266));
    let _e270 = (_e206 - 1u);
    let _e271 = (_e208 - 1u);
    let _e273 = select(_e270, _e271, (_e271 < _e270));
    let _e274 = (_e210 - 1u);
    let _e276 = select(_e273, _e274, (_e274 < _e273));
    let _e278 = select(_e269, _e276, (_e276 < _e269));
    if (((select(_e278, _e262, (_e262 < _e278)) >= 8388607u) && (_e216 < 2130706432u)) && (bitcast<u32>((_e196 + 126i)) <= 253u)) {
        let _e543 = bitcast<i32>((_e216 >> bitcast<u32>(23i)));
        let _e544 = (_e543 - 127i);
        let _e545 = (_e196 + _e544);
        let _e550 = bitcast<f32>((bitcast<u32>((_e196 + 127i)) << bitcast<u32>(23i)));
        let _e555 = bitcast<f32>((bitcast<u32>((254i - _e543)) << bitcast<u32>(23i)));
        if (_e204 >= 2139095040u) {
            phi_918_ = 255i;
        } else {
            phi_918_ = (bitcast<i32>((_e204 >> bitcast<u32>(23i))) + _e545);
        }
        let _e570 = phi_918_;
        if (_e204 == 0u) {
            phi_924_ = 0u;
        } else {
            phi_924_ = (_e204 | 8388608u);
        }
        let _e574 = phi_924_;
        if (_e570 <= 0i) {
            phi_944_ = u32();
            phi_945_ = true;
        } else {
            let _e581 = (_e574 == 0u);
            if _e581 {
                phi_943_ = u32();
            } else {
                phi_943_ = select(((bitcast<u32>(_e570) << bitcast<u32>(23i)) | (_e574 & 8388607u)), 2139095039u, (_e570 >= 255i));
            }
            let _e585 = phi_943_;
            phi_944_ = _e585;
            phi_945_ = _e581;
        }
        let _e587 = phi_944_;
        let _e589 = phi_945_;
        if (_e212 >= 2139095040u) {
            phi_963_ = 255i;
        } else {
            phi_963_ = (bitcast<i32>((_e212 >> bitcast<u32>(23i))) + _e545);
        }
        let _e600 = phi_963_;
        if (_e212 == 0u) {
            phi_969_ = 0u;
        } else {
            phi_969_ = (_e212 | 8388608u);
        }
        let _e604 = phi_969_;
        if (_e600 <= 0i) {
            phi_989_ = u32();
            phi_990_ = true;
        } else {
            let _e611 = (_e604 == 0u);
            if _e611 {
                phi_988_ = u32();
            } else {
                phi_988_ = select(((bitcast<u32>(_e600) << bitcast<u32>(23i)) | (_e604 & 8388607u)), 2139095039u, (_e600 >= 255i));
            }
            let _e615 = phi_988_;
            phi_989_ = _e615;
            phi_990_ = _e611;
        }
        let _e617 = phi_989_;
        let _e619 = phi_990_;
        phi_1367_ = SlimbvhTypeC(array<f32, 3>((_e245 * _e550), (_e249 * _e550), (_e252 * _e550)), array<f32, 3>((_e254 * _e555), (_e256 * _e555), (_e258 * _e555)), bitcast<f32>(((_e203 & 2147483648u) | select(_e587, 0u, _e589))), bitcast<f32>(((_e211 & 2147483648u) | select(_e617, 0u, _e619))), _e544);
    } else {
        let _e291 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e216, _e229))) & 2147483647u);
        if (_e291 >= 8388608u) {
            phi_1021_ = (bitcast<i32>((_e291 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_1021_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e291)), 32u, (_e291 == 0u))));
        }
        let _e305 = phi_1021_;
        let _e306 = (_e196 + _e305);
        if (_e196 < -126i) {
            phi_1032_ = -126i;
        } else {
            phi_1032_ = select(_e196, 127i, (_e196 > 127i));
        }
        let _e311 = phi_1032_;
        let _e316 = bitcast<f32>((bitcast<u32>((_e311 + 127i)) << bitcast<u32>(23i)));
        let _e322 = bitcast<f32>((bitcast<u32>(((_e196 - _e311) + 127i)) << bitcast<u32>(23i)));
        let _e323 = bitcast<u32>(_e245);
        let _e325 = ((_e323 & 2139095040u) != 0u);
        let _e340 = bitcast<u32>(_e249);
        let _e342 = ((_e340 & 2139095040u) != 0u);
        let _e357 = bitcast<u32>(_e252);
        let _e359 = ((_e357 & 2139095040u) != 0u);
        let _e375 = -(_e305);
        if (_e375 < -126i) {
            phi_1146_ = -126i;
        } else {
            phi_1146_ = select(_e375, 127i, (_e375 > 127i));
        }
        let _e380 = phi_1146_;
        let _e385 = bitcast<f32>((bitcast<u32>((_e380 + 127i)) << bitcast<u32>(23i)));
        let _e391 = bitcast<f32>((bitcast<u32>(((_e375 - _e380) + 127i)) << bitcast<u32>(23i)));
        let _e392 = bitcast<u32>(_e254);
        let _e394 = ((_e392 & 2139095040u) != 0u);
        let _e409 = bitcast<u32>(_e256);
        let _e411 = ((_e409 & 2139095040u) != 0u);
        let _e426 = bitcast<u32>(_e258);
        let _e428 = ((_e426 & 2139095040u) != 0u);
        let _e450 = ((_e204 & 8388607u) | (select(0u, 1u, ((_e204 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e453 = bitcast<i32>((_e204 >> bitcast<u32>(23i)));
        let _e460 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e450)), 32u, (_e450 == 0u))) - 8i);
        if (_e453 == 255i) {
            phi_1275_ = 255i;
        } else {
            phi_1275_ = (((_e453 + select(0i, 1i, (_e453 == 0i))) - _e460) + _e306);
        }
        let _e468 = phi_1275_;
        let _e472 = (_e450 << bitcast<u32>(((_e460 & 31i) & 31i)));
        if (_e468 <= 0i) {
            phi_1298_ = u32();
            phi_1299_ = true;
        } else {
            let _e479 = (_e472 == 0u);
            if _e479 {
                phi_1297_ = u32();
            } else {
                phi_1297_ = select(((bitcast<u32>(_e468) << bitcast<u32>(23i)) | (_e472 & 8388607u)), 2139095039u, (_e468 >= 255i));
            }
            let _e483 = phi_1297_;
            phi_1298_ = _e483;
            phi_1299_ = _e479;
        }
        let _e485 = phi_1298_;
        let _e487 = phi_1299_;
        let _e498 = ((_e212 & 8388607u) | (select(0u, 1u, ((_e212 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e501 = bitcast<i32>((_e212 >> bitcast<u32>(23i)));
        let _e508 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e498)), 32u, (_e498 == 0u))) - 8i);
        if (_e501 == 255i) {
            phi_1333_ = 255i;
        } else {
            phi_1333_ = (((_e501 + select(0i, 1i, (_e501 == 0i))) - _e508) + _e306);
        }
        let _e516 = phi_1333_;
        let _e520 = (_e498 << bitcast<u32>(((_e508 & 31i) & 31i)));
        if (_e516 <= 0i) {
            phi_1356_ = u32();
            phi_1357_ = true;
        } else {
            let _e527 = (_e520 == 0u);
            if _e527 {
                phi_1355_ = u32();
            } else {
                phi_1355_ = select(((bitcast<u32>(_e516) << bitcast<u32>(23i)) | (_e520 & 8388607u)), 2139095039u, (_e516 >= 255i));
            }
            let _e531 = phi_1355_;
            phi_1356_ = _e531;
            phi_1357_ = _e527;
        }
        let _e533 = phi_1356_;
        let _e535 = phi_1357_;
        phi_1367_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e323 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e323 & 2147483648u))), _e245, _e325) * _e316) * select(0.00000011920929f, 1f, _e325)) * _e322), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e340 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e340 & 2147483648u))), _e249, _e342) * _e316) * select(0.00000011920929f, 1f, _e342)) * _e322), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e357 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e357 & 2147483648u))), _e252, _e359) * _e316) * select(0.00000011920929f, 1f, _e359)) * _e322)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e392 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e392 & 2147483648u))), _e254, _e394) * _e385) * select(0.00000011920929f, 1f, _e394)) * _e391), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e409 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e409 & 2147483648u))), _e256, _e411) * _e385) * select(0.00000011920929f, 1f, _e411)) * _e391), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e426 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e426 & 2147483648u))), _e258, _e428) * _e385) * select(0.00000011920929f, 1f, _e428)) * _e391)), bitcast<f32>(((_e203 & 2147483648u) | select(_e485, 0u, _e487))), bitcast<f32>(((_e211 & 2147483648u) | select(_e533, 0u, _e535))), _e305);
    }
    let _e626 = phi_1367_;
    let _e641 = (bitcast<f32>((bitcast<u32>(_e626.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e644 = bitcast<f32>((bitcast<u32>(_e626.member[0]) & 2147483647u));
    let _e645 = (_e644 * 0.00000011920929f);
    let _e648 = select(select(0.00000000000011368684f, _e645, (_e645 > 0.00000000000011368684f)), 0f, _e641);
    let _e649 = select(0f, _e626.member_1[0], _e641);
    let _e650 = (_e626.member[0] + _e648);
    let _e651 = (_e626.member[0] - _e648);
    let _e653 = select(38685626000000000000000000f, (1f / _e626.member_1[0]), _e641);
    let _e657 = (bitcast<f32>((bitcast<u32>(_e626.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e660 = bitcast<f32>((bitcast<u32>(_e626.member[1]) & 2147483647u));
    let _e661 = (_e660 * 0.00000011920929f);
    let _e664 = select(select(0.00000000000011368684f, _e661, (_e661 > 0.00000000000011368684f)), 0f, _e657);
    let _e665 = select(0f, _e626.member_1[1], _e657);
    let _e666 = (_e626.member[1] + _e664);
    let _e667 = (_e626.member[1] - _e664);
    let _e669 = select(38685626000000000000000000f, (1f / _e626.member_1[1]), _e657);
    let _e673 = (bitcast<f32>((bitcast<u32>(_e626.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e676 = bitcast<f32>((bitcast<u32>(_e626.member[2]) & 2147483647u));
    let _e677 = (_e676 * 0.00000011920929f);
    let _e680 = select(select(0.00000000000011368684f, _e677, (_e677 > 0.00000000000011368684f)), 0f, _e673);
    let _e681 = select(0f, _e626.member_1[2], _e673);
    let _e682 = (_e626.member[2] + _e680);
    let _e683 = (_e626.member[2] - _e680);
    let _e685 = select(38685626000000000000000000f, (1f / _e626.member_1[2]), _e673);
    let _e687 = select(_e660, _e644, (_e644 > _e660));
    let _e691 = (_e229 && (select(_e676, _e687, (_e687 > _e676)) <= 1099511600000f));
    let _e692 = select(0f, _e626.member_3, _e691);
    let _e693 = select(1f, _e626.member_2, _e691);
    let _e697 = slimbvh_question.member[1u];
    let _e700 = slimbvh_question.member[0u];
    if (_e700 == 1u) {
        phi_1606_ = SlimbvhTypeP(SlimbvhTypeI(_e119, _e692), true);
    } else {
        phi_1606_ = SlimbvhTypeP(SlimbvhTypeI(_e119, _e692), false);
    }
    let _e707 = phi_1606_;
    let _e712 = (_e238 & 3u);
    let _e713 = (_e242 & 3u);
    let _e714 = (_e234 & 3u);
    let _e727 = (f32(bitcast<i32>(_e136)) * _e172);
    let _e729 = (f32(bitcast<i32>(_e140)) * _e172);
    let _e731 = (f32(bitcast<i32>(_e144)) * _e172);
    let _e732 = (_e712 == 0u);
    if _e732 {
        phi_1670_ = array<f32, 3>(_e727, _e729, _e731);
    } else {
        if (_e712 == 1u) {
            phi_1669_ = array<f32, 3>(_e729, _e731, _e727);
        } else {
            phi_1669_ = array<f32, 3>(_e731, _e727, _e729);
        }
        let _e737 = phi_1669_;
        phi_1670_ = _e737;
    }
    let _e740 = phi_1670_;
    let _e742 = (f32(bitcast<i32>(_e152)) * _e172);
    let _e744 = (f32(bitcast<i32>(_e156)) * _e172);
    let _e746 = (f32(bitcast<i32>(_e160)) * _e172);
    if _e732 {
        phi_1689_ = array<f32, 3>(_e742, _e744, _e746);
    } else {
        if (_e712 == 1u) {
            phi_1688_ = array<f32, 3>(_e744, _e746, _e742);
        } else {
            phi_1688_ = array<f32, 3>(_e746, _e742, _e744);
        }
        let _e751 = phi_1688_;
        phi_1689_ = _e751;
    }
    let _e754 = phi_1689_;
    let _e765 = ((_e740[0] - _e650) * _e653);
    let _e766 = ((_e754[0] - _e651) * _e653);
    let _e767 = vec4<f32>(_e765, f32(), _e766, f32());
    let _e770 = ((_e740[1] - _e666) * _e669);
    let _e771 = ((_e754[1] - _e667) * _e669);
    let _e772 = vec4<f32>(_e770, f32(), _e771, f32());
    let _e775 = ((_e740[2] - _e682) * _e685);
    let _e776 = ((_e754[2] - _e683) * _e685);
    let _e777 = vec4<f32>(_e775, f32(), _e776, f32());
    let _e778 = vec4<f32>(_e766, f32(), _e765, f32());
    let _e780 = vec4<f32>(_e771, f32(), _e770, f32());
    let _e782 = vec4<f32>(_e776, f32(), _e775, f32());
    phi_1862_ = _e707;
    phi_1865_ = select(4294967295u, select(4294967295u, 0u, (_e693 <= _e692)), (max(max(max(min(_e767, _e778).x, min(_e772, _e780).x), min(_e777, _e782).x), _e693) <= min((min(min(max(_e767, _e778).x, max(_e772, _e780).x), max(_e777, _e782).x) + (max(max(_e777, _e782).x, -(min(_e777, _e782).x)) * 0.0000019073523f)), _e707.member.member_1)));
    phi_1867_ = select(0u, 4294967295u, (_e123 == 0u));
    phi_1869_ = (_e123 + 1u);
    loop {
        let _e806 = phi_1862_;
        let _e808 = phi_1865_;
        let _e810 = phi_1867_;
        let _e812 = phi_1869_;
        local_6 = _e806;
        let _e813 = (_e808 <= 2147483647u);
        if _e813 {
            phi_1878_ = _e808;
            phi_1881_ = _e810;
            phi_1883_ = _e812;
            loop {
                let _e815 = phi_1878_;
                let _e817 = phi_1881_;
                let _e819 = phi_1883_;
                local_2 = _e817;
                local_3 = _e815;
                local_4 = _e815;
                local_8 = _e815;
                local_9 = _e817;
                local_10 = _e819;
                let _e820 = (_e815 <= 2147483647u);
                let _e822 = (_e817 + _e175);
                let _e826 = (_e820 && !(((_e817 >= _e123) || (_e822 >= _e123))));
                local_1 = _e820;
                if _e826 {
                    let _e831 = slimbvh_nodes.member[_e822][select(_e712, 2u, (2u < _e712))];
                    let _e836 = slimbvh_nodes.member[_e822][select(_e713, 2u, (2u < _e713))];
                    let _e841 = slimbvh_nodes.member[_e822][select(_e714, 2u, (2u < _e714))];
                    let _e844 = bitcast<u32>(_e172);
                    let _e849 = bitcast<f32>(_e831.x);
                    let _e850 = bitcast<f32>((_e844 + ((_e831.w & 31u) << bitcast<u32>(23i))));
                    let _e851 = (_e849 + _e850);
                    if ((bitcast<u32>(_e653) >> bitcast<u32>(31i)) == 0u) {
                        phi_1990_ = SlimbvhTypeJ(_e831.z, _e851);
                        phi_1991_ = SlimbvhTypeJ(_e831.y, _e849);
                    } else {
                        phi_1990_ = SlimbvhTypeJ(_e831.y, _e849);
                        phi_1991_ = SlimbvhTypeJ(_e831.z, _e851);
                    }
                    let _e862 = phi_1990_;
                    let _e864 = phi_1991_;
                    let _e903 = bitcast<f32>(_e836.x);
                    let _e904 = bitcast<f32>((_e844 + ((_e836.w & 31u) << bitcast<u32>(23i))));
                    let _e905 = (_e903 + _e904);
                    if ((bitcast<u32>(_e669) >> bitcast<u32>(31i)) == 0u) {
                        phi_2050_ = SlimbvhTypeJ(_e836.z, _e905);
                        phi_2051_ = SlimbvhTypeJ(_e836.y, _e903);
                    } else {
                        phi_2050_ = SlimbvhTypeJ(_e836.y, _e903);
                        phi_2051_ = SlimbvhTypeJ(_e836.z, _e905);
                    }
                    let _e916 = phi_2050_;
                    let _e918 = phi_2051_;
                    let _e957 = bitcast<f32>(_e841.x);
                    let _e958 = bitcast<f32>((_e844 + ((_e841.w & 31u) << bitcast<u32>(23i))));
                    let _e959 = (_e957 + _e958);
                    if ((bitcast<u32>(_e685) >> bitcast<u32>(31i)) == 0u) {
                        phi_2110_ = SlimbvhTypeJ(_e841.z, _e959);
                        phi_2111_ = SlimbvhTypeJ(_e841.y, _e957);
                    } else {
                        phi_2110_ = SlimbvhTypeJ(_e841.y, _e957);
                        phi_2111_ = SlimbvhTypeJ(_e841.z, _e959);
                    }
                    let _e970 = phi_2110_;
                    let _e972 = phi_2111_;
                    let _e1007 = (_e850 * _e653);
                    let _e1010 = bitcast<f32>((bitcast<u32>(_e1007) & 2147483647u));
                    let _e1014 = (((_e864.member_1 - _e650) * _e653) + (_e1010 * -0.00012207031f));
                    let _e1026 = (((_e862.member_1 - _e651) * _e653) + (_e1010 * 0.00012207031f));
                    let _e1035 = (_e904 * _e669);
                    let _e1038 = bitcast<f32>((bitcast<u32>(_e1035) & 2147483647u));
                    let _e1042 = (((_e918.member_1 - _e666) * _e669) + (_e1038 * -0.00012207031f));
                    let _e1054 = (((_e916.member_1 - _e667) * _e669) + (_e1038 * 0.00012207031f));
                    let _e1063 = (_e958 * _e685);
                    let _e1066 = bitcast<f32>((bitcast<u32>(_e1063) & 2147483647u));
                    let _e1070 = (((_e972.member_1 - _e682) * _e685) + (_e1066 * -0.00012207031f));
                    let _e1075 = ((f32((_e972.member & 255u)) * _e1063) + _e1070);
                    let _e1076 = ((f32(((_e972.member >> bitcast<u32>(8u)) & 255u)) * _e1063) + _e1070);
                    let _e1077 = ((f32(((_e972.member >> bitcast<u32>(16u)) & 255u)) * _e1063) + _e1070);
                    let _e1078 = ((f32(((_e972.member >> bitcast<u32>(24u)) & 255u)) * _e1063) + _e1070);
                    let _e1082 = (((_e970.member_1 - _e683) * _e685) + (_e1066 * 0.00012207031f));
                    let _e1087 = ((f32((_e970.member & 255u)) * _e1063) + _e1082);
                    let _e1088 = ((f32(((_e970.member >> bitcast<u32>(8u)) & 255u)) * _e1063) + _e1082);
                    let _e1089 = ((f32(((_e970.member >> bitcast<u32>(16u)) & 255u)) * _e1063) + _e1082);
                    let _e1090 = ((f32(((_e970.member >> bitcast<u32>(24u)) & 255u)) * _e1063) + _e1082);
                    let _e1123 = max(max(max(((f32((_e864.member & 255u)) * _e1007) + _e1014), ((f32((_e918.member & 255u)) * _e1035) + _e1042)), _e1075), _e693);
                    let _e1124 = max(max(max(((f32(((_e864.member >> bitcast<u32>(8u)) & 255u)) * _e1007) + _e1014), ((f32(((_e918.member >> bitcast<u32>(8u)) & 255u)) * _e1035) + _e1042)), _e1076), _e693);
                    let _e1125 = max(max(max(((f32(((_e864.member >> bitcast<u32>(16u)) & 255u)) * _e1007) + _e1014), ((f32(((_e918.member >> bitcast<u32>(16u)) & 255u)) * _e1035) + _e1042)), _e1077), _e693);
                    let _e1126 = max(max(max(((f32(((_e864.member >> bitcast<u32>(24u)) & 255u)) * _e1007) + _e1014), ((f32(((_e918.member >> bitcast<u32>(24u)) & 255u)) * _e1035) + _e1042)), _e1078), _e693);
                    let _e1131 = (_e806.member.member_1 + (bitcast<f32>((bitcast<u32>(_e806.member.member_1) & 2147483647u)) * 0.0000004768374f));
                    if (_e1123 <= min((min(min(((f32((_e862.member & 255u)) * _e1007) + _e1026), ((f32((_e916.member & 255u)) * _e1035) + _e1054)), _e1087) + (max(_e1087, -(_e1075)) * 0.0000023841915f)), _e1131)) {
                        phi_2601_ = (((bitcast<u32>(_e1123) ^ select(0u, 4294967288u, _e707.member_1)) & 2147483640u) | 4u);
                    } else {
                        phi_2601_ = 4294967288u;
                    }
                    let _e1146 = phi_2601_;
                    if (_e1124 <= min((min(min(((f32(((_e862.member >> bitcast<u32>(8u)) & 255u)) * _e1007) + _e1026), ((f32(((_e916.member >> bitcast<u32>(8u)) & 255u)) * _e1035) + _e1054)), _e1088) + (max(_e1088, -(_e1076)) * 0.0000023841915f)), _e1131)) {
                        phi_2614_ = ((((bitcast<u32>(_e1124) ^ select(0u, 4294967288u, _e707.member_1)) & 2147483640u) | 4u) | 1u);
                    } else {
                        phi_2614_ = 4294967288u;
                    }
                    let _e1154 = phi_2614_;
                    if (_e1125 <= min((min(min(((f32(((_e862.member >> bitcast<u32>(16u)) & 255u)) * _e1007) + _e1026), ((f32(((_e916.member >> bitcast<u32>(16u)) & 255u)) * _e1035) + _e1054)), _e1089) + (max(_e1089, -(_e1077)) * 0.0000023841915f)), _e1131)) {
                        phi_2627_ = ((((bitcast<u32>(_e1125) ^ select(0u, 4294967288u, _e707.member_1)) & 2147483640u) | 4u) | 2u);
                    } else {
                        phi_2627_ = 4294967288u;
                    }
                    let _e1162 = phi_2627_;
                    if (_e1126 <= min((min(min(((f32(((_e862.member >> bitcast<u32>(24u)) & 255u)) * _e1007) + _e1026), ((f32(((_e916.member >> bitcast<u32>(24u)) & 255u)) * _e1035) + _e1054)), _e1090) + (max(_e1090, -(_e1078)) * 0.0000023841915f)), _e1131)) {
                        phi_2640_ = ((((bitcast<u32>(_e1126) ^ select(0u, 4294967288u, _e707.member_1)) & 2147483640u) | 4u) | 3u);
                    } else {
                        phi_2640_ = 4294967288u;
                    }
                    let _e1170 = phi_2640_;
                    if (_e1146 < _e1154) {
                        phi_5358_ = SlimbvhTypeD(_e1146, _e1154);
                    } else {
                        phi_5358_ = SlimbvhTypeD(_e1154, _e1146);
                    }
                    let _e1175 = phi_5358_;
                    if (_e1162 < _e1170) {
                        phi_5370_ = SlimbvhTypeD(_e1162, _e1170);
                    } else {
                        phi_5370_ = SlimbvhTypeD(_e1170, _e1162);
                    }
                    let _e1182 = phi_5370_;
                    if (_e1175.member < _e1182.member) {
                        phi_5382_ = SlimbvhTypeD(_e1175.member, _e1182.member);
                    } else {
                        phi_5382_ = SlimbvhTypeD(_e1182.member, _e1175.member);
                    }
                    let _e1189 = phi_5382_;
                    if (_e1175.member_1 < _e1182.member_1) {
                        phi_5394_ = SlimbvhTypeD(_e1175.member_1, _e1182.member_1);
                    } else {
                        phi_5394_ = SlimbvhTypeD(_e1182.member_1, _e1175.member_1);
                    }
                    let _e1196 = phi_5394_;
                    if (_e1196.member < _e1189.member_1) {
                        phi_5406_ = SlimbvhTypeD(_e1196.member, _e1189.member_1);
                    } else {
                        phi_5406_ = SlimbvhTypeD(_e1189.member_1, _e1196.member);
                    }
                    let _e1203 = phi_5406_;
                    let _e1218 = (((_e1189.member & 7u) | ((_e1203.member & 7u) << bitcast<u32>(3u))) | (((_e1203.member_1 & 7u) | ((_e1196.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                    if (_e1218 == 0u) {
                        let _e1236 = (_e815 - 1u);
                        let _e1239 = local[(_e1236 % 128u)];
                        let _e1240 = (_e1239 & 511u);
                        let _e1242 = (_e1240 >> bitcast<u32>(3u));
                        let _e1245 = ((_e1242 == 0u) || (_e1236 == 4294967295u));
                        if _e1245 {
                        } else {
                            local[(_e1236 % 128u)] = (((_e1239 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1242);
                        }
                        phi_2726_ = select(_e815, _e1236, _e1245);
                        phi_2727_ = (((_e1239 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1240 & 3u) & 3u));
                    } else {
                        let _e1221 = (_e1218 >> bitcast<u32>(3u));
                        if (_e1221 == 0u) {
                            phi_2721_ = _e815;
                        } else {
                            local[(_e815 % 128u)] = ((_e822 << bitcast<u32>(9u)) | _e1221);
                            phi_2721_ = (_e815 + 1u);
                        }
                        let _e1230 = phi_2721_;
                        phi_2726_ = _e1230;
                        phi_2727_ = ((_e822 << bitcast<u32>(2i)) | ((_e1218 & 3u) & 3u));
                    }
                    let _e1260 = phi_2726_;
                    let _e1262 = phi_2727_;
                    let _e1264 = (_e1262 >> bitcast<u32>(2i));
                    if (_e1264 < _e123) {
                        let _e1269 = slimbvh_nodes.member[_e1264][1u][3u];
                        let _e1273 = slimbvh_nodes.member[_e1264][2u][3u];
                        let _e1278 = (_e1273 >> bitcast<u32>(20u));
                        let _e1279 = (_e1262 & 3u);
                        if (((_e1278 >> bitcast<u32>((((3u * _e1279) & 31u) & 31u))) & 7u) == 7u) {
                            let _e1291 = ((_e1278 | (_e1278 << bitcast<u32>(10i))) & 4128831u);
                            phi_2781_ = (((_e1269 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e1291 | (_e1291 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e1279) & 31u) & 31u))) & 255u));
                        } else {
                            phi_2781_ = (2147483648u | _e1262);
                        }
                        let _e1309 = phi_2781_;
                        phi_2782_ = _e1309;
                    } else {
                        phi_2782_ = 4294967295u;
                    }
                    let _e1311 = phi_2782_;
                    let _e1312 = (_e819 - 1u);
                    phi_1879_ = select(_e1260, 4294967295u, (_e1312 == 0u));
                    phi_1882_ = _e1311;
                    phi_1884_ = _e1312;
                } else {
                    phi_1879_ = u32();
                    phi_1882_ = u32();
                    phi_1884_ = u32();
                }
                let _e1316 = phi_1879_;
                let _e1318 = phi_1882_;
                let _e1320 = phi_1884_;
                continue;
                continuing {
                    phi_1878_ = _e1316;
                    phi_1881_ = _e1318;
                    phi_1883_ = _e1320;
                    break if !(_e826);
                }
            }
            let _e1323 = local_1;
            if _e1323 {
                let _e1325 = local_2;
                let _e1326 = (_e1325 & 2147483647u);
                let _e1328 = (_e1326 >> bitcast<u32>(2i));
                if (_e1328 >= _e123) {
                    phi_3015_ = SlimbvhTypeM(SlimbvhTypeL(vec4<f32>(0f, 0f, 0f, 0f), 0u), 0u, 0u);
                } else {
                    let _e1334 = slimbvh_nodes.member[_e1328][select(_e712, 2u, (2u < _e712))];
                    let _e1343 = slimbvh_nodes.member[_e1328][select(_e713, 2u, (2u < _e713))];
                    let _e1352 = slimbvh_nodes.member[_e1328][select(_e714, 2u, (2u < _e714))];
                    let _e1360 = slimbvh_nodes.member[_e1328][0u][3u];
                    let _e1364 = slimbvh_nodes.member[_e1328][1u][3u];
                    let _e1368 = slimbvh_nodes.member[_e1328][2u][3u];
                    let _e1381 = (_e1368 >> bitcast<u32>(20u));
                    let _e1389 = (((_e1368 >> bitcast<u32>(7u)) & 8191u) | ((_e1364 >> bitcast<u32>(29u)) << bitcast<u32>(13u)));
                    let _e1392 = ((_e1368 >> bitcast<u32>(5u)) & 3u);
                    let _e1393 = (_e1326 & 3u);
                    let _e1399 = ((_e1381 >> bitcast<u32>((((3u * _e1393) & 31u) & 31u))) & 7u);
                    if (_e1399 == 7u) {
                        let _e1452 = ((_e1381 | (_e1381 << bitcast<u32>(10i))) & 4128831u);
                        phi_2967_ = (((_e1364 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e1452 | (_e1452 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e1393) & 31u) & 31u))) & 255u));
                    } else {
                        let _e1404 = ((_e1381 | (_e1381 << bitcast<u32>(10i))) & 4128831u);
                        let _e1408 = ((_e1404 | (_e1404 << bitcast<u32>(5i))) & 117901063u);
                        let _e1414 = (_e1408 - (7u * (((_e1408 + 16843009u) >> bitcast<u32>(3i)) & 16843009u)));
                        let _e1422 = ((_e1389 | (_e1389 << bitcast<u32>(8i))) & 16711935u);
                        phi_2967_ = ((2147483648u | (_e1399 << bitcast<u32>(28u))) | ((((_e1360 >> bitcast<u32>(5u)) | (((_e1364 >> bitcast<u32>(28u)) & 1u) << bitcast<u32>(27u))) + (((((((((_e1422 | (_e1422 << bitcast<u32>(4i))) & 252645135u) + (3u * (((_e1414 + 117901063u) >> bitcast<u32>(3i)) & 16843009u))) * (_e1392 + 1u)) + _e1414) + ((_e1414 >> bitcast<u32>(1i)) & 50529027u)) * 16843008u) >> bitcast<u32>((((8u * _e1393) & 31u) & 31u))) & 255u)) & 268435455u));
                    }
                    let _e1470 = phi_2967_;
                    switch bitcast<i32>(_e1392) {
                        case 0: {
                            phi_2972_ = 0u;
                            break;
                        }
                        case 1: {
                            phi_2972_ = 1u;
                            break;
                        }
                        default: {
                            phi_2972_ = 2u;
                            break;
                        }
                    }
                    let _e1473 = phi_2972_;
                    let _e1476 = (((8u * _e1393) & 31u) & 31u);
                    phi_3015_ = SlimbvhTypeM(SlimbvhTypeL(vec4<f32>((bitcast<f32>(_e1334.x) + (f32((((_e1334.y >> bitcast<u32>(_e1476)) & 255u) << bitcast<u32>(((_e1334.w & 31u) & 31u)))) * _e172)), (bitcast<f32>(_e1343.x) + (f32((((_e1343.y >> bitcast<u32>(_e1476)) & 255u) << bitcast<u32>(((_e1343.w & 31u) & 31u)))) * _e172)), (bitcast<f32>(_e1352.x) + (f32((((_e1352.y >> bitcast<u32>(_e1476)) & 255u) << bitcast<u32>(((_e1352.w & 31u) & 31u)))) * _e172)), 0f), _e1473), (_e1470 & 268435455u), ((_e1470 >> bitcast<u32>(28u)) & 7u));
                }
                let _e1515 = phi_3015_;
                let _e1517 = (_e1515.member_1 + _e178);
                phi_3022_ = _e806;
                phi_3025_ = SlimbvhTypeD(0u, _e1515.member_2);
                loop {
                    let _e1522 = phi_3022_;
                    let _e1524 = phi_3025_;
                    local_5 = _e1522;
                    local_7 = _e1522;
                    if (_e1524.member < _e1524.member_1) {
                        phi_3026_ = SlimbvhTypeD((_e1524.member + 1u), _e1524.member_1);
                        phi_3048_ = SlimbvhTypeD(1u, _e1524.member);
                    } else {
                        phi_3026_ = _e1524;
                        phi_3048_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                    }
                    let _e1537 = phi_3026_;
                    let _e1539 = phi_3048_;
                    let _e1543 = (bitcast<i32>(_e1539.member) != 0i);
                    if _e1543 {
                        let _e1545 = (_e1517 + (_e1515.member_2 / 2u));
                        let _e1546 = (_e1545 + _e1539.member_1);
                        if (_e1546 < _e126) {
                            let _e1549 = slimbvh_triangles.member[_e1546];
                            phi_3073_ = _e1549;
                        } else {
                            phi_3073_ = 4294967295u;
                        }
                        let _e1551 = phi_3073_;
                        let _e1552 = (_e1539.member_1 - 1u);
                        let _e1555 = (_e1517 + (_e1552 >> bitcast<u32>(1i)));
                        if (_e1555 < _e126) {
                            let _e1558 = slimbvh_triangles.member[_e1555];
                            phi_3096_ = _e1558;
                        } else {
                            phi_3096_ = 0u;
                        }
                        let _e1560 = phi_3096_;
                        if (_e1539.member_1 == 0u) {
                            phi_3105_ = 2080u;
                        } else {
                            phi_3105_ = (_e1560 >> bitcast<u32>(((16u * (_e1552 & 1u)) & 31u)));
                        }
                        let _e1568 = phi_3105_;
                        let _e1569 = (_e1545 + _e1515.member_2);
                        switch bitcast<i32>(_e1515.member.member_1) {
                            case 0: {
                                phi_3115_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_3115_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_3115_ = 3u;
                                break;
                            }
                            default: {
                                phi_3115_ = u32();
                                break;
                            }
                        }
                        let _e1573 = phi_3115_;
                        let _e1576 = (_e1569 + ((_e1568 & 31u) * _e1573));
                        let _e1581 = (_e1569 + (((_e1568 >> bitcast<u32>(5u)) & 31u) * _e1573));
                        let _e1586 = (_e1569 + (((_e1568 >> bitcast<u32>(10u)) & 31u) * _e1573));
                        switch bitcast<i32>(_e1515.member.member_1) {
                            case 0: {
                                if (_e1576 < _e126) {
                                    let _e1863 = slimbvh_triangles.member[_e1576];
                                    phi_3157_ = _e1863;
                                } else {
                                    phi_3157_ = 0u;
                                }
                                let _e1865 = phi_3157_;
                                let _e1868 = ((10u * _e238) & 31u);
                                let _e1879 = ((10u * _e242) & 31u);
                                let _e1890 = ((10u * _e234) & 31u);
                                if (_e1581 < _e126) {
                                    let _e1902 = slimbvh_triangles.member[_e1581];
                                    phi_3203_ = _e1902;
                                } else {
                                    phi_3203_ = 0u;
                                }
                                let _e1904 = phi_3203_;
                                if (_e1586 < _e126) {
                                    let _e1932 = slimbvh_triangles.member[_e1586];
                                    phi_3249_ = _e1932;
                                } else {
                                    phi_3249_ = 0u;
                                }
                                let _e1934 = phi_3249_;
                                phi_3716_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1515.member.member.x + ((bitcast<f32>((1258291200u | ((_e1865 >> bitcast<u32>(_e1868)) & 1023u))) - 8388608f) * _e172)), (_e1515.member.member.y + ((bitcast<f32>((1258291200u | ((_e1865 >> bitcast<u32>(_e1879)) & 1023u))) - 8388608f) * _e172)), (_e1515.member.member.z + ((bitcast<f32>((1258291200u | ((_e1865 >> bitcast<u32>(_e1890)) & 1023u))) - 8388608f) * _e172))), array<f32, 3>((_e1515.member.member.x + ((bitcast<f32>((1258291200u | ((_e1904 >> bitcast<u32>(_e1868)) & 1023u))) - 8388608f) * _e172)), (_e1515.member.member.y + ((bitcast<f32>((1258291200u | ((_e1904 >> bitcast<u32>(_e1879)) & 1023u))) - 8388608f) * _e172)), (_e1515.member.member.z + ((bitcast<f32>((1258291200u | ((_e1904 >> bitcast<u32>(_e1890)) & 1023u))) - 8388608f) * _e172))), array<f32, 3>((_e1515.member.member.x + ((bitcast<f32>((1258291200u | ((_e1934 >> bitcast<u32>(_e1868)) & 1023u))) - 8388608f) * _e172)), (_e1515.member.member.y + ((bitcast<f32>((1258291200u | ((_e1934 >> bitcast<u32>(_e1879)) & 1023u))) - 8388608f) * _e172)), (_e1515.member.member.z + ((bitcast<f32>((1258291200u | ((_e1934 >> bitcast<u32>(_e1890)) & 1023u))) - 8388608f) * _e172))));
                                break;
                            }
                            case 1: {
                                if (_e1576 < _e126) {
                                    let _e1676 = slimbvh_triangles.member[_e1576];
                                    phi_3296_ = _e1676;
                                } else {
                                    phi_3296_ = 0u;
                                }
                                let _e1678 = phi_3296_;
                                let _e1679 = (_e1576 + 1u);
                                if (_e1679 < _e126) {
                                    let _e1682 = slimbvh_triangles.member[_e1679];
                                    phi_3309_ = _e1682;
                                } else {
                                    phi_3309_ = 0u;
                                }
                                let _e1684 = phi_3309_;
                                let _e1686 = (_e238 == 1u);
                                if _e1686 {
                                    phi_3319_ = ((_e1678 >> bitcast<u32>(21i)) | (_e1684 << bitcast<u32>(11i)));
                                } else {
                                    phi_3319_ = (_e1684 >> bitcast<u32>(10i));
                                }
                                let _e1695 = phi_3319_;
                                let _e1704 = (_e242 == 1u);
                                if _e1704 {
                                    phi_3340_ = ((_e1678 >> bitcast<u32>(21i)) | (_e1684 << bitcast<u32>(11i)));
                                } else {
                                    phi_3340_ = (_e1684 >> bitcast<u32>(10i));
                                }
                                let _e1713 = phi_3340_;
                                let _e1722 = (_e234 == 1u);
                                if _e1722 {
                                    phi_3361_ = ((_e1678 >> bitcast<u32>(21i)) | (_e1684 << bitcast<u32>(11i)));
                                } else {
                                    phi_3361_ = (_e1684 >> bitcast<u32>(10i));
                                }
                                let _e1731 = phi_3361_;
                                if (_e1581 < _e126) {
                                    let _e1742 = slimbvh_triangles.member[_e1581];
                                    phi_3388_ = _e1742;
                                } else {
                                    phi_3388_ = 0u;
                                }
                                let _e1744 = phi_3388_;
                                let _e1745 = (_e1581 + 1u);
                                if (_e1745 < _e126) {
                                    let _e1748 = slimbvh_triangles.member[_e1745];
                                    phi_3401_ = _e1748;
                                } else {
                                    phi_3401_ = 0u;
                                }
                                let _e1750 = phi_3401_;
                                if _e1686 {
                                    phi_3411_ = ((_e1744 >> bitcast<u32>(21i)) | (_e1750 << bitcast<u32>(11i)));
                                } else {
                                    phi_3411_ = (_e1750 >> bitcast<u32>(10i));
                                }
                                let _e1759 = phi_3411_;
                                if _e1704 {
                                    phi_3432_ = ((_e1744 >> bitcast<u32>(21i)) | (_e1750 << bitcast<u32>(11i)));
                                } else {
                                    phi_3432_ = (_e1750 >> bitcast<u32>(10i));
                                }
                                let _e1775 = phi_3432_;
                                if _e1722 {
                                    phi_3453_ = ((_e1744 >> bitcast<u32>(21i)) | (_e1750 << bitcast<u32>(11i)));
                                } else {
                                    phi_3453_ = (_e1750 >> bitcast<u32>(10i));
                                }
                                let _e1791 = phi_3453_;
                                if (_e1586 < _e126) {
                                    let _e1802 = slimbvh_triangles.member[_e1586];
                                    phi_3480_ = _e1802;
                                } else {
                                    phi_3480_ = 0u;
                                }
                                let _e1804 = phi_3480_;
                                let _e1805 = (_e1586 + 1u);
                                if (_e1805 < _e126) {
                                    let _e1808 = slimbvh_triangles.member[_e1805];
                                    phi_3493_ = _e1808;
                                } else {
                                    phi_3493_ = 0u;
                                }
                                let _e1810 = phi_3493_;
                                if _e1686 {
                                    phi_3503_ = ((_e1804 >> bitcast<u32>(21i)) | (_e1810 << bitcast<u32>(11i)));
                                } else {
                                    phi_3503_ = (_e1810 >> bitcast<u32>(10i));
                                }
                                let _e1819 = phi_3503_;
                                if _e1704 {
                                    phi_3524_ = ((_e1804 >> bitcast<u32>(21i)) | (_e1810 << bitcast<u32>(11i)));
                                } else {
                                    phi_3524_ = (_e1810 >> bitcast<u32>(10i));
                                }
                                let _e1835 = phi_3524_;
                                if _e1722 {
                                    phi_3545_ = ((_e1804 >> bitcast<u32>(21i)) | (_e1810 << bitcast<u32>(11i)));
                                } else {
                                    phi_3545_ = (_e1810 >> bitcast<u32>(10i));
                                }
                                let _e1851 = phi_3545_;
                                phi_3716_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1515.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1695, _e1678, _e243) & 2097151u))) - 8388608f) * _e172)), (_e1515.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1713, _e1678, _e246) & 2097151u))) - 8388608f) * _e172)), (_e1515.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1731, _e1678, _e250) & 2097151u))) - 8388608f) * _e172))), array<f32, 3>((_e1515.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1759, _e1744, _e243) & 2097151u))) - 8388608f) * _e172)), (_e1515.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1775, _e1744, _e246) & 2097151u))) - 8388608f) * _e172)), (_e1515.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1791, _e1744, _e250) & 2097151u))) - 8388608f) * _e172))), array<f32, 3>((_e1515.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1819, _e1804, _e243) & 2097151u))) - 8388608f) * _e172)), (_e1515.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1835, _e1804, _e246) & 2097151u))) - 8388608f) * _e172)), (_e1515.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1851, _e1804, _e250) & 2097151u))) - 8388608f) * _e172))));
                                break;
                            }
                            case 2: {
                                let _e1589 = (_e1576 + _e238);
                                if (_e1589 < _e126) {
                                    let _e1592 = slimbvh_triangles.member[_e1589];
                                    phi_3574_ = _e1592;
                                } else {
                                    phi_3574_ = 0u;
                                }
                                let _e1594 = phi_3574_;
                                let _e1595 = (_e1576 + _e242);
                                if (_e1595 < _e126) {
                                    let _e1598 = slimbvh_triangles.member[_e1595];
                                    phi_3587_ = _e1598;
                                } else {
                                    phi_3587_ = 0u;
                                }
                                let _e1600 = phi_3587_;
                                let _e1601 = (_e1576 + _e234);
                                if (_e1601 < _e126) {
                                    let _e1604 = slimbvh_triangles.member[_e1601];
                                    phi_3600_ = _e1604;
                                } else {
                                    phi_3600_ = 0u;
                                }
                                let _e1606 = phi_3600_;
                                let _e1617 = (_e1581 + _e238);
                                if (_e1617 < _e126) {
                                    let _e1620 = slimbvh_triangles.member[_e1617];
                                    phi_3626_ = _e1620;
                                } else {
                                    phi_3626_ = 0u;
                                }
                                let _e1622 = phi_3626_;
                                let _e1623 = (_e1581 + _e242);
                                if (_e1623 < _e126) {
                                    let _e1626 = slimbvh_triangles.member[_e1623];
                                    phi_3639_ = _e1626;
                                } else {
                                    phi_3639_ = 0u;
                                }
                                let _e1628 = phi_3639_;
                                let _e1629 = (_e1581 + _e234);
                                if (_e1629 < _e126) {
                                    let _e1632 = slimbvh_triangles.member[_e1629];
                                    phi_3652_ = _e1632;
                                } else {
                                    phi_3652_ = 0u;
                                }
                                let _e1634 = phi_3652_;
                                let _e1645 = (_e1586 + _e238);
                                if (_e1645 < _e126) {
                                    let _e1648 = slimbvh_triangles.member[_e1645];
                                    phi_3678_ = _e1648;
                                } else {
                                    phi_3678_ = 0u;
                                }
                                let _e1650 = phi_3678_;
                                let _e1651 = (_e1586 + _e242);
                                if (_e1651 < _e126) {
                                    let _e1654 = slimbvh_triangles.member[_e1651];
                                    phi_3691_ = _e1654;
                                } else {
                                    phi_3691_ = 0u;
                                }
                                let _e1656 = phi_3691_;
                                let _e1657 = (_e1586 + _e234);
                                if (_e1657 < _e126) {
                                    let _e1660 = slimbvh_triangles.member[_e1657];
                                    phi_3704_ = _e1660;
                                } else {
                                    phi_3704_ = 0u;
                                }
                                let _e1662 = phi_3704_;
                                phi_3716_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1594)) * _e172), (f32(bitcast<i32>(_e1600)) * _e172), (f32(bitcast<i32>(_e1606)) * _e172)), array<f32, 3>((f32(bitcast<i32>(_e1622)) * _e172), (f32(bitcast<i32>(_e1628)) * _e172), (f32(bitcast<i32>(_e1634)) * _e172)), array<f32, 3>((f32(bitcast<i32>(_e1650)) * _e172), (f32(bitcast<i32>(_e1656)) * _e172), (f32(bitcast<i32>(_e1662)) * _e172)));
                                break;
                            }
                            default: {
                                phi_3716_ = array<array<f32, 3>, 3>();
                                break;
                            }
                        }
                        let _e1962 = phi_3716_;
                        let _e1979 = (_e1962[0][2] - _e626.member[2]);
                        let _e1982 = (((_e1962[0][0] - _e626.member[0]) * _e681) - (_e1979 * _e649));
                        let _e1985 = (((_e1962[0][1] - _e626.member[1]) * _e681) - (_e1979 * _e665));
                        let _e1988 = (_e1962[1][2] - _e626.member[2]);
                        let _e1991 = (((_e1962[1][0] - _e626.member[0]) * _e681) - (_e1988 * _e649));
                        let _e1994 = (((_e1962[1][1] - _e626.member[1]) * _e681) - (_e1988 * _e665));
                        let _e1997 = (_e1962[2][2] - _e626.member[2]);
                        let _e2000 = (((_e1962[2][0] - _e626.member[0]) * _e681) - (_e1997 * _e649));
                        let _e2003 = (((_e1962[2][1] - _e626.member[1]) * _e681) - (_e1997 * _e665));
                        let _e2004 = (_e2000 * _e1994);
                        let _e2005 = (_e2003 * _e1991);
                        let _e2006 = (_e1982 * _e2003);
                        let _e2007 = (_e1985 * _e2000);
                        let _e2008 = (_e1991 * _e1985);
                        let _e2009 = (_e1994 * _e1982);
                        let _e2014 = (((_e2004 >= _e2005) && (_e2006 >= _e2007)) && (_e2008 >= _e2009));
                        let _e2020 = (_e2014 || (((_e2004 <= _e2005) && (_e2006 <= _e2007)) && (_e2008 <= _e2009)));
                        if _e2020 {
                            let _e2022 = select(-1f, 1f, _e2014);
                            let _e2024 = ((_e2004 - _e2005) * _e2022);
                            let _e2026 = select(0f, _e2024, (_e2024 > 0f));
                            let _e2028 = ((_e2006 - _e2007) * _e2022);
                            let _e2030 = select(0f, _e2028, (_e2028 > 0f));
                            let _e2032 = ((_e2008 - _e2009) * _e2022);
                            let _e2034 = select(0f, _e2032, (_e2032 > 0f));
                            let _e2036 = ((_e2026 + _e2030) + _e2034);
                            let _e2051 = ((min(min(_e1962[0][0], _e1962[1][0]), _e1962[2][0]) - _e650) * _e653);
                            let _e2052 = ((max(max(_e1962[0][0], _e1962[1][0]), _e1962[2][0]) - _e651) * _e653);
                            let _e2053 = vec4<f32>(_e2051, f32(), _e2052, f32());
                            let _e2056 = ((min(min(_e1962[0][1], _e1962[1][1]), _e1962[2][1]) - _e666) * _e669);
                            let _e2057 = ((max(max(_e1962[0][1], _e1962[1][1]), _e1962[2][1]) - _e667) * _e669);
                            let _e2058 = vec4<f32>(_e2056, f32(), _e2057, f32());
                            let _e2061 = ((min(min(_e1962[0][2], _e1962[1][2]), _e1962[2][2]) - _e682) * _e685);
                            let _e2062 = ((max(max(_e1962[0][2], _e1962[1][2]), _e1962[2][2]) - _e683) * _e685);
                            let _e2063 = vec4<f32>(_e2061, f32(), _e2062, f32());
                            let _e2064 = vec4<f32>(_e2052, f32(), _e2051, f32());
                            let _e2066 = vec4<f32>(_e2057, f32(), _e2056, f32());
                            let _e2068 = vec4<f32>(_e2062, f32(), _e2061, f32());
                            let _e2077 = max(max(min(_e2053, _e2064).x, min(_e2058, _e2066).x), min(_e2063, _e2068).x);
                            let _e2082 = min(min(max(_e2053, _e2064).x, max(_e2058, _e2066).x), max(_e2063, _e2068).x);
                            let _e2087 = max(_e2077, _e693);
                            let _e2109 = (((((_e2020 && (_e2036 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1982, _e1991), _e2000) <= 0f) && (max(max(_e1982, _e1991), _e2000) >= 0f))) && ((min(min(_e1985, _e1994), _e2003) <= 0f) && (max(max(_e1985, _e1994), _e2003) >= 0f))) && (_e2087 <= (_e2082 + (max(max(_e2063, _e2068).x, -(min(_e2063, _e2068).x)) * 0.0000019073523f)))) && (_e2087 <= _e1522.member.member_1));
                            if _e2109 {
                                let _e2114 = (_e1962[1][0] - _e1962[0][0]);
                                let _e2115 = (_e1962[1][1] - _e1962[0][1]);
                                let _e2116 = (_e1962[1][2] - _e1962[0][2]);
                                let _e2117 = vec3<f32>(_e2114, _e2115, _e2116);
                                let _e2118 = (_e1962[2][0] - _e1962[1][0]);
                                let _e2119 = (_e1962[2][1] - _e1962[1][1]);
                                let _e2120 = (_e1962[2][2] - _e1962[1][2]);
                                let _e2121 = vec3<f32>(_e2118, _e2119, _e2120);
                                let _e2122 = (_e1962[0][0] - _e1962[2][0]);
                                let _e2123 = (_e1962[0][1] - _e1962[2][1]);
                                let _e2124 = (_e1962[0][2] - _e1962[2][2]);
                                let _e2125 = vec3<f32>(_e2122, _e2123, _e2124);
                                let _e2136 = max(max(bitcast<f32>((bitcast<u32>(_e2114) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2115) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2116) & 2147483647u)));
                                let _e2147 = max(max(bitcast<f32>((bitcast<u32>(_e2118) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2119) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2120) & 2147483647u)));
                                let _e2160 = max(max(_e2136, _e2147), max(max(bitcast<f32>((bitcast<u32>(_e2122) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2123) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2124) & 2147483647u))));
                                if (_e2136 == _e2160) {
                                    phi_4081_ = _e1994;
                                    phi_4082_ = _e1991;
                                    phi_4083_ = _e1985;
                                    phi_4084_ = _e1982;
                                    phi_4085_ = vec3<f32>(_e1962[0][0], _e1962[0][1], _e1962[0][2]);
                                    phi_4086_ = _e2125;
                                    phi_4087_ = _e2121;
                                    phi_4088_ = _e2117;
                                } else {
                                    let _e2162 = (_e2147 == _e2160);
                                    let _e2167 = vec3(_e2162);
                                    phi_4081_ = select(_e1985, _e2003, _e2162);
                                    phi_4082_ = select(_e1982, _e2000, _e2162);
                                    phi_4083_ = select(_e2003, _e1994, _e2162);
                                    phi_4084_ = select(_e2000, _e1991, _e2162);
                                    phi_4085_ = select(vec3<f32>(_e1962[2][0], _e1962[2][1], _e1962[2][2]), vec3<f32>(_e1962[1][0], _e1962[1][1], _e1962[1][2]), _e2167);
                                    phi_4086_ = select(_e2121, _e2117, _e2167);
                                    phi_4087_ = select(_e2117, _e2125, _e2167);
                                    phi_4088_ = select(_e2125, _e2121, _e2167);
                                }
                                let _e2173 = phi_4081_;
                                let _e2175 = phi_4082_;
                                let _e2177 = phi_4083_;
                                let _e2179 = phi_4084_;
                                let _e2181 = phi_4085_;
                                let _e2183 = phi_4086_;
                                let _e2185 = phi_4087_;
                                let _e2187 = phi_4088_;
                                let _e2194 = ((_e2185.y * _e2183.z) - (_e2183.y * _e2185.z));
                                let _e2199 = ((_e2185.z * _e2183.x) - (_e2183.z * _e2185.x));
                                let _e2202 = ((_e2185.x * _e2183.y) - (_e2183.x * _e2185.y));
                                let _e2205 = ((_e2026 >= _e2030) && (_e2026 >= _e2034));
                                let _e2206 = (_e2030 >= _e2034);
                                let _e2220 = (((_e2194 * (select(select(_e1962[2][0], _e1962[1][0], _e2206), _e1962[0][0], _e2205) - _e626.member[0])) + (_e2199 * (select(select(_e1962[2][1], _e1962[1][1], _e2206), _e1962[0][1], _e2205) - _e626.member[1]))) + (_e2202 * (select(select(_e1962[2][2], _e1962[1][2], _e2206), _e1962[0][2], _e2205) - _e626.member[2])));
                                let _e2225 = (((_e2194 * _e649) + (_e2199 * _e665)) + (_e2202 * _e681));
                                let _e2226 = (_e2175 - _e2179);
                                let _e2227 = (_e2173 - _e2177);
                                let _e2230 = ((_e2226 * _e2226) + (_e2227 * _e2227));
                                let _e2237 = (-(((_e2179 * _e2226) + (_e2177 * _e2227))) / select(0.000000000000000000000000000000000000011754944f, _e2230, (_e2230 > 0.000000000000000000000000000000000000011754944f)));
                                let _e2239 = select(1f, _e2237, (_e2237 < 1f));
                                let _e2241 = select(0f, _e2239, (_e2239 > 0f));
                                let _e2250 = ((_e2181.x + (_e2187.x * _e2241)) - _e626.member[0]);
                                let _e2253 = ((_e2181.y + (_e2187.y * _e2241)) - _e626.member[1]);
                                let _e2256 = ((_e2181.z + (_e2187.z * _e2241)) - _e626.member[2]);
                                let _e2321 = ((bitcast<f32>((bitcast<u32>(((((_e2194 * _e2250) + (_e2199 * _e2253)) + (_e2202 * _e2256)) - _e2220)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e2250) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2253) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2256) & 2147483647u))), _e2160)) * max(max(bitcast<f32>((bitcast<u32>(_e2194) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2199) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2202) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e2225) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e2185.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2185.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2185.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e2183.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2183.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2183.z) & 2147483647u)))))));
                                let _e2322 = (_e2220 / _e2225);
                                if (_e2109 && !(_e2321)) {
                                    let _e2325 = (_e2256 / _e681);
                                    let _e2333 = (((_e2194 * (_e2250 - (_e649 * _e2325))) + (_e2199 * (_e2253 - (_e665 * _e2325)))) / _e2225);
                                    phi_4267_ = select(select(_e2325, (_e2325 + _e2333), (bitcast<f32>((bitcast<u32>(_e2333) & 2147483647u)) <= _e2160)), _e2322, _e2321);
                                } else {
                                    phi_4267_ = _e2322;
                                }
                                let _e2342 = phi_4267_;
                                let _e2344 = select(_e2082, _e2342, (_e2342 < _e2082));
                                let _e2346 = select(_e2077, _e2344, (_e2344 > _e2077));
                                let _e2349 = select(_e2346, 0f, (bitcast<u32>(_e2346) == 2147483648u));
                                let _e2350 = (1f / _e2036);
                                phi_4293_ = SlimbvhTypeE(_e2349, (_e2030 * _e2350), (_e2034 * _e2350), ((_e2109 && (_e2349 >= _e693)) && (_e2349 <= _e1522.member.member_1)));
                                phi_4294_ = SlimbvhTypeE();
                            } else {
                                phi_4293_ = SlimbvhTypeE();
                                phi_4294_ = SlimbvhTypeE(0f, 0f, 0f, _e2109);
                            }
                            let _e2359 = phi_4293_;
                            let _e2361 = phi_4294_;
                            phi_4297_ = _e2359;
                            phi_4298_ = _e2361;
                            phi_4299_ = select(true, false, _e2109);
                        } else {
                            phi_4297_ = SlimbvhTypeE();
                            phi_4298_ = SlimbvhTypeE(0f, 0f, 0f, _e2020);
                            phi_4299_ = true;
                        }
                        let _e2364 = phi_4297_;
                        let _e2366 = phi_4298_;
                        let _e2368 = phi_4299_;
                        if _e2368 {
                            phi_4303_ = _e2366;
                        } else {
                            phi_4303_ = _e2364;
                        }
                        let _e2370 = phi_4303_;
                        if _e2370.member_3 {
                            phi_4312_ = SlimbvhTypeF(_e2370.member, _e2370.member_1, _e2370.member_2, _e1551);
                        } else {
                            phi_4312_ = _e119;
                        }
                        let _e2377 = phi_4312_;
                        if (_e2377.member_3 != 4294967295u) {
                            let _e2383 = slimbvh_target.member[0u][0u];
                            let _e2387 = slimbvh_target.member[0u][1u];
                            let _e2391 = slimbvh_target.member[0u][2u];
                            let _e2395 = slimbvh_target.member[0u][3u];
                            let _e2399 = slimbvh_target.member[1u][0u];
                            let _e2403 = slimbvh_target.member[1u][1u];
                            let _e2407 = slimbvh_target.member[1u][2u];
                            let _e2411 = slimbvh_target.member[1u][3u];
                            let _e2412 = bitcast<f32>(_e2383);
                            let _e2413 = bitcast<f32>(_e2387);
                            let _e2414 = bitcast<f32>(_e2391);
                            let _e2416 = bitcast<f32>(_e2399);
                            let _e2417 = array<u32, 3>(_e2403, _e2407, _e2411);
                            if (_e196 < -126i) {
                                phi_4365_ = -126i;
                            } else {
                                phi_4365_ = select(_e196, 127i, (_e196 > 127i));
                            }
                            let _e2423 = phi_4365_;
                            let _e2428 = bitcast<f32>((bitcast<u32>((_e2423 + 127i)) << bitcast<u32>(23i)));
                            let _e2434 = bitcast<f32>((bitcast<u32>(((_e196 - _e2423) + 127i)) << bitcast<u32>(23i)));
                            if (_e2395 == 0u) {
                                phi_4505_ = SlimbvhTypeH(array<f32, 3>(_e2412, _e2413, _e2414), _e2395, _e2416, _e2417);
                            } else {
                                let _e2436 = bitcast<u32>(_e2412);
                                let _e2438 = ((_e2436 & 2139095040u) != 0u);
                                let _e2453 = bitcast<u32>(_e2413);
                                let _e2455 = ((_e2453 & 2139095040u) != 0u);
                                let _e2470 = bitcast<u32>(_e2414);
                                let _e2472 = ((_e2470 & 2139095040u) != 0u);
                                let _e2488 = bitcast<u32>(_e2416);
                                let _e2490 = ((_e2488 & 2139095040u) != 0u);
                                phi_4505_ = SlimbvhTypeH(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2436 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2436 & 2147483648u))), _e2412, _e2438) * _e2428) * select(0.00000011920929f, 1f, _e2438)) * _e2434), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2453 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2453 & 2147483648u))), _e2413, _e2455) * _e2428) * select(0.00000011920929f, 1f, _e2455)) * _e2434), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2470 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2470 & 2147483648u))), _e2414, _e2472) * _e2428) * select(0.00000011920929f, 1f, _e2472)) * _e2434)), _e2395, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2488 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2488 & 2147483648u))), _e2416, _e2490) * _e2428) * select(0.00000011920929f, 1f, _e2490)) * _e2434), _e2417);
                            }
                            let _e2507 = phi_4505_;
                            if (_e1551 == _e697) {
                                phi_4834_ = false;
                            } else {
                                let _e2509 = (_e1551 / 16u);
                                if (_e2509 < arrayLength((&slimbvh_sides.member))) {
                                    let _e2512 = slimbvh_sides.member[_e2509];
                                    phi_4529_ = _e2512;
                                } else {
                                    phi_4529_ = 0u;
                                }
                                let _e2514 = phi_4529_;
                                let _e2523 = (bitcast<i32>((_e2514 << bitcast<u32>(((30u - ((_e1551 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                let _e2524 = (_e2523 == 0i);
                                if _e2524 {
                                    phi_4833_ = true;
                                } else {
                                    if _e243 {
                                        phi_4559_ = vec3<f32>(_e1962[0][0], _e1962[0][1], _e1962[0][2]);
                                    } else {
                                        if (_e238 == 1u) {
                                            phi_4558_ = vec3<f32>(_e1962[0][2], _e1962[0][0], _e1962[0][1]);
                                        } else {
                                            phi_4558_ = vec3<f32>(_e1962[0][1], _e1962[0][2], _e1962[0][0]);
                                        }
                                        let _e2529 = phi_4558_;
                                        phi_4559_ = _e2529;
                                    }
                                    let _e2532 = phi_4559_;
                                    if _e243 {
                                        phi_4578_ = vec3<f32>(_e1962[1][0], _e1962[1][1], _e1962[1][2]);
                                    } else {
                                        if (_e238 == 1u) {
                                            phi_4577_ = vec3<f32>(_e1962[1][2], _e1962[1][0], _e1962[1][1]);
                                        } else {
                                            phi_4577_ = vec3<f32>(_e1962[1][1], _e1962[1][2], _e1962[1][0]);
                                        }
                                        let _e2537 = phi_4577_;
                                        phi_4578_ = _e2537;
                                    }
                                    let _e2540 = phi_4578_;
                                    if _e243 {
                                        phi_4597_ = vec3<f32>(_e1962[2][0], _e1962[2][1], _e1962[2][2]);
                                    } else {
                                        if (_e238 == 1u) {
                                            phi_4596_ = vec3<f32>(_e1962[2][2], _e1962[2][0], _e1962[2][1]);
                                        } else {
                                            phi_4596_ = vec3<f32>(_e1962[2][1], _e1962[2][2], _e1962[2][0]);
                                        }
                                        let _e2545 = phi_4596_;
                                        phi_4597_ = _e2545;
                                    }
                                    let _e2548 = phi_4597_;
                                    let _e2551 = (_e2540.x - _e2532.x);
                                    let _e2554 = (_e2540.y - _e2532.y);
                                    let _e2557 = (_e2540.z - _e2532.z);
                                    let _e2559 = (_e2548.x - _e2532.x);
                                    let _e2561 = (_e2548.y - _e2532.y);
                                    let _e2563 = (_e2548.z - _e2532.z);
                                    if (_e2507.member_1 == 1u) {
                                        phi_4633_ = (vec3<f32>(_e2507.member[0], _e2507.member[1], _e2507.member[2]) - _e2532);
                                    } else {
                                        phi_4633_ = vec3<f32>(_e2507.member[0], _e2507.member[1], _e2507.member[2]);
                                    }
                                    let _e2578 = phi_4633_;
                                    let _e2584 = bitcast<f32>((bitcast<u32>((_e2551 * _e2561)) ^ _e2507.member_3[0]));
                                    let _e2588 = bitcast<f32>((bitcast<u32>((_e2554 * _e2559)) ^ _e2507.member_3[0]));
                                    let _e2592 = bitcast<f32>((bitcast<u32>((_e2554 * _e2563)) ^ _e2507.member_3[0]));
                                    let _e2596 = bitcast<f32>((bitcast<u32>((_e2557 * _e2561)) ^ _e2507.member_3[0]));
                                    let _e2600 = bitcast<f32>((bitcast<u32>((_e2557 * _e2559)) ^ _e2507.member_3[0]));
                                    let _e2604 = bitcast<f32>((bitcast<u32>((_e2551 * _e2563)) ^ _e2507.member_3[0]));
                                    let _e2605 = (_e2592 - _e2596);
                                    let _e2606 = (_e2600 - _e2604);
                                    let _e2607 = (_e2584 - _e2588);
                                    let _e2631 = (bitcast<f32>((bitcast<u32>(_e2592) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2596) & 2147483647u)));
                                    let _e2638 = (bitcast<f32>((bitcast<u32>(_e2600) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2604) & 2147483647u)));
                                    let _e2645 = (bitcast<f32>((bitcast<u32>(_e2584) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2588) & 2147483647u)));
                                    if (_e2507.member_2 == 0f) {
                                        phi_4815_ = 0f;
                                    } else {
                                        let _e2675 = bitcast<f32>((bitcast<u32>(_e2605) & 2147483647u));
                                        let _e2678 = bitcast<f32>((bitcast<u32>(_e2606) & 2147483647u));
                                        let _e2681 = bitcast<f32>((bitcast<u32>(_e2607) & 2147483647u));
                                        let _e2683 = select(_e2681, _e2678, (_e2678 > _e2681));
                                        let _e2687 = select(_e2681, _e2678, (_e2678 < _e2681));
                                        let _e2691 = select(_e2678, _e2675, (_e2675 < _e2678));
                                        let _e2693 = select(_e2678, _e2675, (_e2675 > _e2678));
                                        let _e2695 = select(_e2681, _e2693, (_e2693 < _e2681));
                                        phi_4815_ = bitcast<f32>((bitcast<u32>((_e2507.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2683, _e2675, (_e2675 > _e2683)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2695, _e2691, (_e2691 > _e2695)))) ^ _e2507.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2687, _e2675, (_e2675 < _e2687)))) ^ _e2507.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2631 + _e2638) + _e2645))) ^ _e2507.member_3[0]))) * 1.0000005f)) ^ _e2507.member_3[0])))) ^ _e2507.member_3[0]));
                                    }
                                    let _e2722 = phi_4815_;
                                    phi_4833_ = (_e2524 || !(((((bitcast<f32>((bitcast<u32>((_e2578.x * _e2605)) ^ _e2507.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2578.y * _e2606)) ^ _e2507.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2578.z * _e2607)) ^ _e2507.member_3[0]))) * f32(-(_e2523))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2578.x) & 2147483647u)) * _e2631)) ^ _e2507.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2578.y) & 2147483647u)) * _e2638)) ^ _e2507.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2578.z) & 2147483647u)) * _e2645)) ^ _e2507.member_3[0]))))) ^ _e2507.member_3[0])) + _e2722) + 0.0000000000000000000000000000000000001880791f))));
                                }
                                let _e2736 = phi_4833_;
                                phi_4834_ = _e2736;
                            }
                            let _e2738 = phi_4834_;
                            if _e2738 {
                                if (_e2377.member < _e1522.member.member.member) {
                                    phi_4854_ = true;
                                } else {
                                    if (_e2377.member == _e1522.member.member.member) {
                                        phi_4853_ = (_e2377.member_3 < _e1522.member.member.member_3);
                                    } else {
                                        phi_4853_ = false;
                                    }
                                    let _e2750 = phi_4853_;
                                    phi_4854_ = _e2750;
                                }
                                let _e2752 = phi_4854_;
                                if _e2752 {
                                    phi_4861_ = SlimbvhTypeP(SlimbvhTypeI(_e2377, _e2377.member), _e1522.member_1);
                                } else {
                                    phi_4861_ = _e1522;
                                }
                                let _e2758 = phi_4861_;
                                if _e2758.member_1 {
                                    phi_4867_ = SlimbvhTypeP(SlimbvhTypeI(_e2758.member.member, bitcast<f32>(4286578687u)), _e2758.member_1);
                                } else {
                                    phi_4867_ = _e2758;
                                }
                                let _e2767 = phi_4867_;
                                phi_4868_ = _e2767;
                            } else {
                                phi_4868_ = _e1522;
                            }
                            let _e2769 = phi_4868_;
                            phi_4869_ = _e2769;
                        } else {
                            phi_4869_ = _e1522;
                        }
                        let _e2771 = phi_4869_;
                        phi_3023_ = _e2771;
                    } else {
                        phi_3023_ = SlimbvhTypeP();
                    }
                    let _e2773 = phi_3023_;
                    continue;
                    continuing {
                        phi_3022_ = _e2773;
                        phi_3025_ = _e1537;
                        break if !(_e1543);
                    }
                }
                let _e2776 = local_3;
                let _e2777 = (_e2776 - 1u);
                let _e2780 = local[(_e2777 % 128u)];
                let _e2781 = (_e2780 & 511u);
                let _e2783 = (_e2781 >> bitcast<u32>(3u));
                let _e2786 = ((_e2783 == 0u) || (_e2777 == 4294967295u));
                if _e2786 {
                } else {
                    local[(_e2777 % 128u)] = (((_e2780 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2783);
                }
                let _e2793 = local_4;
                let _e2801 = (((_e2780 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2781 & 3u) & 3u));
                let _e2803 = (_e2801 >> bitcast<u32>(2i));
                if (_e2803 < _e123) {
                    let _e2808 = slimbvh_nodes.member[_e2803][1u][3u];
                    let _e2812 = slimbvh_nodes.member[_e2803][2u][3u];
                    let _e2817 = (_e2812 >> bitcast<u32>(20u));
                    let _e2818 = (_e2801 & 3u);
                    if (((_e2817 >> bitcast<u32>((((3u * _e2818) & 31u) & 31u))) & 7u) == 7u) {
                        let _e2830 = ((_e2817 | (_e2817 << bitcast<u32>(10i))) & 4128831u);
                        phi_4958_ = (((_e2808 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e2830 | (_e2830 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e2818) & 31u) & 31u))) & 255u));
                    } else {
                        phi_4958_ = (2147483648u | _e2801);
                    }
                    let _e2848 = phi_4958_;
                    phi_4959_ = _e2848;
                } else {
                    phi_4959_ = 4294967295u;
                }
                let _e2850 = phi_4959_;
                let _e2852 = local_5;
                let _e3150 = local_7;
                phi_4968_ = _e3150;
                phi_4969_ = select(select(_e2793, _e2777, _e2786), 4294967295u, (_e693 > _e2852.member.member_1));
                phi_4970_ = _e2850;
            } else {
                phi_4968_ = _e806;
                let _e3153 = local_8;
                phi_4969_ = _e3153;
                let _e3156 = local_9;
                phi_4970_ = _e3156;
            }
            let _e2858 = phi_4968_;
            let _e2860 = phi_4969_;
            let _e2862 = phi_4970_;
            phi_1863_ = _e2858;
            phi_1866_ = _e2860;
            phi_1868_ = _e2862;
            let _e3162 = local_10;
            phi_1870_ = _e3162;
        } else {
            phi_1863_ = SlimbvhTypeP();
            phi_1866_ = u32();
            phi_1868_ = u32();
            phi_1870_ = u32();
        }
        let _e2864 = phi_1863_;
        let _e2866 = phi_1866_;
        let _e2868 = phi_1868_;
        let _e2870 = phi_1870_;
        continue;
        continuing {
            phi_1862_ = _e2864;
            phi_1865_ = _e2866;
            phi_1867_ = _e2868;
            phi_1869_ = _e2870;
            break if !(_e813);
        }
    }
    let _e2873 = local_6;
    if (_e2873.member.member.member_3 != 4294967295u) {
        let _e2879 = -((_e196 + _e626.member_4));
        let _e2880 = bitcast<u32>(_e2873.member.member.member);
        let _e2884 = (bitcast<i32>((_e2880 >> bitcast<u32>(23i))) & 255i);
        let _e2885 = (_e2884 + _e2879);
        if (_e2884 == 255i) {
            phi_5027_ = _e2873.member.member.member;
        } else {
            if (_e2884 > 0i) {
                if (_e2885 > 0i) {
                    let _e2889 = (_e2885 < 255i);
                    if _e2889 {
                        phi_5006_ = bitcast<f32>((_e2880 + bitcast<u32>((_e2879 << bitcast<u32>(23i)))));
                    } else {
                        phi_5006_ = f32();
                    }
                    let _e2896 = phi_5006_;
                    phi_5008_ = _e2896;
                    phi_5009_ = select(true, false, _e2889);
                } else {
                    phi_5008_ = f32();
                    phi_5009_ = true;
                }
                let _e2899 = phi_5008_;
                let _e2901 = phi_5009_;
                phi_5010_ = _e2899;
                phi_5011_ = _e2901;
            } else {
                phi_5010_ = f32();
                phi_5011_ = true;
            }
            let _e2903 = phi_5010_;
            let _e2905 = phi_5011_;
            if _e2905 {
                let _e2906 = (_e2880 & 2147483648u);
                let _e2913 = ((_e2880 & 8388607u) | (select(0u, 1u, ((_e2880 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e2917 = (_e2913 == 0u);
                if _e2917 {
                    phi_5687_ = bitcast<f32>(_e2906);
                } else {
                    let _e2922 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2913)), 32u, _e2917) - 8u);
                    let _e2925 = (_e2913 << bitcast<u32>((_e2922 & 31u)));
                    let _e2927 = ((_e2885 + select(0i, 1i, (_e2884 == 0i))) - bitcast<i32>(_e2922));
                    if (_e2927 >= 255i) {
                        phi_5677_ = bitcast<f32>((_e2906 | 2139095040u));
                        phi_5678_ = f32();
                        phi_5679_ = true;
                    } else {
                        let _e2929 = (_e2927 > 0i);
                        if _e2929 {
                            phi_5671_ = bitcast<f32>(((_e2906 | (bitcast<u32>(_e2927) << bitcast<u32>(23i))) | (_e2925 & 8388607u)));
                            phi_5672_ = f32();
                        } else {
                            if (_e2927 < -24i) {
                                phi_5637_ = 26u;
                            } else {
                                phi_5637_ = bitcast<u32>((1i - _e2927));
                            }
                            let _e2934 = phi_5637_;
                            let _e2935 = (_e2934 & 31u);
                            let _e2937 = (_e2925 >> bitcast<u32>(_e2935));
                            let _e2941 = (_e2925 & ((1u << bitcast<u32>(_e2935)) - 1u));
                            let _e2945 = (1u << bitcast<u32>(((_e2934 - 1u) & 31u)));
                            if (_e2941 > _e2945) {
                                phi_5658_ = true;
                            } else {
                                if (_e2941 == _e2945) {
                                    phi_5655_ = ((_e2937 & 1u) == 1u);
                                } else {
                                    phi_5655_ = false;
                                }
                                let _e2951 = phi_5655_;
                                phi_5658_ = _e2951;
                            }
                            let _e2953 = phi_5658_;
                            phi_5671_ = f32();
                            phi_5672_ = bitcast<f32>((_e2906 | (_e2937 + select(0u, 1u, _e2953))));
                        }
                        let _e2966 = phi_5671_;
                        let _e2968 = phi_5672_;
                        phi_5677_ = _e2966;
                        phi_5678_ = _e2968;
                        phi_5679_ = _e2929;
                    }
                    let _e2972 = phi_5677_;
                    let _e2974 = phi_5678_;
                    let _e2976 = phi_5679_;
                    phi_5687_ = select(_e2974, _e2972, _e2976);
                }
                let _e2980 = phi_5687_;
                phi_5026_ = _e2980;
            } else {
                phi_5026_ = _e2903;
            }
            let _e2982 = phi_5026_;
            phi_5027_ = _e2982;
        }
        let _e2984 = phi_5027_;
        let _e2985 = bitcast<u32>(_e2984);
        if ((_e2985 & 2147483647u) >= 2139095040u) {
            phi_5039_ = bitcast<f32>(((_e2985 & 2147483648u) | 2139095039u));
        } else {
            phi_5039_ = _e2984;
        }
        let _e2992 = phi_5039_;
        phi_5044_ = SlimbvhTypeF(_e2992, _e2873.member.member.member_1, _e2873.member.member.member_2, _e2873.member.member.member_3);
    } else {
        phi_5044_ = _e119;
    }
    let _e2997 = phi_5044_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2997.member), bitcast<u32>(_e2997.member_1), bitcast<u32>(_e2997.member_2), _e2997.member_3);
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
