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
    var phi_726_: u32;
    var phi_732_: u32;
    var phi_738_: u32;
    var phi_1003_: i32;
    var phi_1014_: i32;
    var phi_1128_: i32;
    var phi_1257_: i32;
    var phi_1279_: u32;
    var phi_1280_: u32;
    var phi_1281_: bool;
    var phi_1315_: i32;
    var phi_1337_: u32;
    var phi_1338_: u32;
    var phi_1339_: bool;
    var phi_900_: i32;
    var phi_906_: u32;
    var phi_925_: u32;
    var phi_926_: u32;
    var phi_927_: bool;
    var phi_945_: i32;
    var phi_951_: u32;
    var phi_970_: u32;
    var phi_971_: u32;
    var phi_972_: bool;
    var phi_1349_: SlimbvhTypeC;
    var phi_1588_: SlimbvhTypeQ;
    var phi_1651_: array<f32, 3>;
    var phi_1652_: array<f32, 3>;
    var phi_1670_: array<f32, 3>;
    var phi_1671_: array<f32, 3>;
    var phi_1844_: SlimbvhTypeQ;
    var phi_1847_: u32;
    var phi_1849_: u32;
    var phi_1851_: u32;
    var phi_1860_: u32;
    var phi_1863_: u32;
    var phi_1865_: u32;
    var phi_1967_: SlimbvhTypeL;
    var phi_1968_: SlimbvhTypeL;
    var phi_2027_: SlimbvhTypeL;
    var phi_2028_: SlimbvhTypeL;
    var phi_2087_: SlimbvhTypeL;
    var phi_2088_: SlimbvhTypeL;
    var phi_2572_: u32;
    var phi_2585_: u32;
    var phi_2598_: u32;
    var phi_2611_: u32;
    var phi_5246_: SlimbvhTypeD;
    var phi_5258_: SlimbvhTypeD;
    var phi_5270_: SlimbvhTypeD;
    var phi_5282_: SlimbvhTypeD;
    var phi_5294_: SlimbvhTypeD;
    var phi_2692_: u32;
    var phi_2697_: u32;
    var phi_2698_: u32;
    var phi_2728_: u32;
    var phi_2729_: u32;
    var phi_1861_: u32;
    var phi_1864_: u32;
    var phi_1866_: u32;
    var local_1: bool;
    var local_2: u32;
    var phi_2879_: u32;
    var phi_2940_: u32;
    var phi_2943_: SlimbvhTypeN;
    var phi_2947_: SlimbvhTypeQ;
    var phi_2950_: SlimbvhTypeD;
    var phi_2951_: SlimbvhTypeD;
    var phi_2973_: SlimbvhTypeD;
    var phi_2991_: u32;
    var phi_3002_: u32;
    var phi_3018_: u32;
    var phi_3031_: u32;
    var phi_3042_: u32;
    var phi_3486_: u32;
    var phi_3499_: u32;
    var phi_3512_: u32;
    var phi_3538_: u32;
    var phi_3551_: u32;
    var phi_3564_: u32;
    var phi_3590_: u32;
    var phi_3603_: u32;
    var phi_3616_: u32;
    var phi_3208_: u32;
    var phi_3221_: u32;
    var phi_3231_: u32;
    var phi_3252_: u32;
    var phi_3273_: u32;
    var phi_3300_: u32;
    var phi_3313_: u32;
    var phi_3323_: u32;
    var phi_3344_: u32;
    var phi_3365_: u32;
    var phi_3392_: u32;
    var phi_3405_: u32;
    var phi_3415_: u32;
    var phi_3436_: u32;
    var phi_3457_: u32;
    var phi_3069_: u32;
    var phi_3115_: u32;
    var phi_3161_: u32;
    var phi_3628_: array<array<f32, 3>, 3>;
    var phi_3993_: f32;
    var phi_3994_: f32;
    var phi_3995_: f32;
    var phi_3996_: f32;
    var phi_3997_: vec3<f32>;
    var phi_3998_: vec3<f32>;
    var phi_3999_: vec3<f32>;
    var phi_4000_: vec3<f32>;
    var phi_4179_: f32;
    var phi_4205_: SlimbvhTypeE;
    var phi_4206_: SlimbvhTypeE;
    var phi_4209_: SlimbvhTypeE;
    var phi_4210_: SlimbvhTypeE;
    var phi_4211_: bool;
    var phi_4215_: SlimbvhTypeE;
    var phi_4224_: SlimbvhTypeF;
    var phi_4277_: i32;
    var phi_4417_: SlimbvhTypeH;
    var phi_4441_: u32;
    var phi_4470_: vec3<f32>;
    var phi_4471_: vec3<f32>;
    var phi_4489_: vec3<f32>;
    var phi_4490_: vec3<f32>;
    var phi_4508_: vec3<f32>;
    var phi_4509_: vec3<f32>;
    var phi_4545_: vec3<f32>;
    var phi_4727_: f32;
    var phi_4745_: bool;
    var phi_4746_: bool;
    var phi_4765_: bool;
    var phi_4766_: bool;
    var phi_4773_: SlimbvhTypeQ;
    var phi_4779_: SlimbvhTypeQ;
    var phi_4780_: SlimbvhTypeQ;
    var phi_4781_: SlimbvhTypeQ;
    var phi_2948_: SlimbvhTypeQ;
    var local_3: u32;
    var local_4: u32;
    var phi_4846_: u32;
    var phi_4847_: u32;
    var local_5: SlimbvhTypeQ;
    var phi_4856_: SlimbvhTypeQ;
    var phi_4857_: u32;
    var phi_4858_: u32;
    var phi_1845_: SlimbvhTypeQ;
    var phi_1848_: u32;
    var phi_1850_: u32;
    var phi_1852_: u32;
    var local_6: SlimbvhTypeQ;
    var phi_4894_: f32;
    var phi_4896_: f32;
    var phi_4897_: bool;
    var phi_4898_: f32;
    var phi_4899_: bool;
    var phi_5525_: u32;
    var phi_5543_: bool;
    var phi_5546_: bool;
    var phi_5559_: f32;
    var phi_5560_: f32;
    var phi_5565_: f32;
    var phi_5566_: f32;
    var phi_5567_: bool;
    var phi_5575_: f32;
    var phi_4914_: f32;
    var phi_4915_: f32;
    var phi_4927_: f32;
    var phi_4932_: SlimbvhTypeF;
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
    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    let _e159 = slimbvh_origin.member;
    let _e165 = slimbvh_origin.member[3u];
    let _e166 = slimbvh_direction.member;
    let _e172 = slimbvh_direction.member[3u];
    let _e175 = slimbvh_exponent.member[0u];
    let _e176 = bitcast<i32>(_e175);
    let _e178 = (bitcast<u32>(_e159.x) & 2147483647u);
    let _e180 = (bitcast<u32>(_e159.y) & 2147483647u);
    let _e182 = (bitcast<u32>(_e159.z) & 2147483647u);
    let _e183 = bitcast<u32>(_e165);
    let _e184 = (_e183 & 2147483647u);
    let _e186 = (bitcast<u32>(_e166.x) & 2147483647u);
    let _e188 = (bitcast<u32>(_e166.y) & 2147483647u);
    let _e190 = (bitcast<u32>(_e166.z) & 2147483647u);
    let _e191 = bitcast<u32>(_e172);
    let _e192 = (_e191 & 2147483647u);
    let _e194 = select(_e188, _e186, (_e188 < _e186));
    let _e196 = select(_e190, _e194, (_e190 < _e194));
    let _e198 = select(_e178, _e196, (_e178 < _e196));
    let _e200 = select(_e180, _e198, (_e180 < _e198));
    let _e202 = select(_e182, _e200, (_e182 < _e200));
    let _e209 = (((select(_e184, _e202, (_e184 < _e202)) < 2139095040u) && (_e192 <= 2139095040u)) && (_e196 > 0u));
    if (_e186 == _e196) {
        phi_726_ = 0u;
    } else {
        phi_726_ = select(2u, 1u, (_e188 == _e196));
    }
    let _e214 = phi_726_;
    let _e215 = (_e214 == 2u);
    if _e215 {
        phi_732_ = 0u;
    } else {
        phi_732_ = (_e214 + 1u);
    }
    let _e218 = phi_732_;
    let _e219 = (_e218 == 2u);
    if _e219 {
        phi_738_ = 0u;
    } else {
        phi_738_ = (_e218 + 1u);
    }
    let _e222 = phi_738_;
    let _e223 = (_e218 == 0u);
    let _e225 = select(select(_e159.y, _e159.x, _e223), _e159.z, _e219);
    let _e226 = (_e222 == 0u);
    let _e228 = (_e222 == 2u);
    let _e229 = select(select(_e159.y, _e159.x, _e226), _e159.z, _e228);
    let _e230 = (_e214 == 0u);
    let _e232 = select(select(_e159.y, _e159.x, _e230), _e159.z, _e215);
    let _e234 = select(select(_e166.y, _e166.x, _e223), _e166.z, _e219);
    let _e236 = select(select(_e166.y, _e166.x, _e226), _e166.z, _e228);
    let _e238 = select(select(_e166.y, _e166.x, _e230), _e166.z, _e215);
    let _e239 = (_e184 - 1u);
    let _e240 = (_e192 - 1u);
    let _e242 = select(_e239, _e240, (_e240 < _e239));
    let _e243 = (_e178 - 1u);
    let _e244 = (_e180 - 1u);
    let _e246 = select(_e243, _e244, (_e244 < _e243));
    let _e247 = (_e182 - 1u);
    let _e249 = select(_e246, _e247, (_e247 < _e246));
    let _e250 = (_e186 - 1u);
    let _e251 = (_e188 - 1u);
    let _e253 = select(_e250, _e251, (_e251 < _e250));
    let _e254 = (_e190 - 1u);
    let _e256 = select(_e253, _e254, (_e254 < _e253));
    let _e258 = select(_e249, _e256, (_e256 < _e249));
    if (((select(_e258, _e242, (_e242 < _e258)) >= 8388607u) && (_e196 < 2130706432u)) && (bitcast<u32>((_e176 + 126i)) <= 253u)) {
        let _e523 = bitcast<i32>((_e196 >> bitcast<u32>(23i)));
        let _e524 = (_e523 - 127i);
        let _e525 = (_e176 + _e524);
        let _e530 = bitcast<f32>((bitcast<u32>((_e176 + 127i)) << bitcast<u32>(23i)));
        let _e535 = bitcast<f32>((bitcast<u32>((254i - _e523)) << bitcast<u32>(23i)));
        if (_e184 >= 2139095040u) {
            phi_900_ = 255i;
        } else {
            phi_900_ = (bitcast<i32>((_e184 >> bitcast<u32>(23i))) + _e525);
        }
        let _e550 = phi_900_;
        if (_e184 == 0u) {
            phi_906_ = 0u;
        } else {
            phi_906_ = (_e184 | 8388608u);
        }
        let _e554 = phi_906_;
        if (_e550 <= 0i) {
            phi_926_ = u32();
            phi_927_ = true;
        } else {
            let _e561 = (_e554 == 0u);
            if _e561 {
                phi_925_ = u32();
            } else {
                phi_925_ = select(((bitcast<u32>(_e550) << bitcast<u32>(23i)) | (_e554 & 8388607u)), 2139095039u, (_e550 >= 255i));
            }
            let _e565 = phi_925_;
            phi_926_ = _e565;
            phi_927_ = _e561;
        }
        let _e567 = phi_926_;
        let _e569 = phi_927_;
        if (_e192 >= 2139095040u) {
            phi_945_ = 255i;
        } else {
            phi_945_ = (bitcast<i32>((_e192 >> bitcast<u32>(23i))) + _e525);
        }
        let _e580 = phi_945_;
        if (_e192 == 0u) {
            phi_951_ = 0u;
        } else {
            phi_951_ = (_e192 | 8388608u);
        }
        let _e584 = phi_951_;
        if (_e580 <= 0i) {
            phi_971_ = u32();
            phi_972_ = true;
        } else {
            let _e591 = (_e584 == 0u);
            if _e591 {
                phi_970_ = u32();
            } else {
                phi_970_ = select(((bitcast<u32>(_e580) << bitcast<u32>(23i)) | (_e584 & 8388607u)), 2139095039u, (_e580 >= 255i));
            }
            let _e595 = phi_970_;
            phi_971_ = _e595;
            phi_972_ = _e591;
        }
        let _e597 = phi_971_;
        let _e599 = phi_972_;
        phi_1349_ = SlimbvhTypeC(array<f32, 3>((_e225 * _e530), (_e229 * _e530), (_e232 * _e530)), array<f32, 3>((_e234 * _e535), (_e236 * _e535), (_e238 * _e535)), bitcast<f32>(((_e183 & 2147483648u) | select(_e567, 0u, _e569))), bitcast<f32>(((_e191 & 2147483648u) | select(_e597, 0u, _e599))), _e524);
    } else {
        let _e271 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e196, _e209))) & 2147483647u);
        if (_e271 >= 8388608u) {
            phi_1003_ = (bitcast<i32>((_e271 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_1003_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e271)), 32u, (_e271 == 0u))));
        }
        let _e285 = phi_1003_;
        let _e286 = (_e176 + _e285);
        if (_e176 < -126i) {
            phi_1014_ = -126i;
        } else {
            phi_1014_ = select(_e176, 127i, (_e176 > 127i));
        }
        let _e291 = phi_1014_;
        let _e296 = bitcast<f32>((bitcast<u32>((_e291 + 127i)) << bitcast<u32>(23i)));
        let _e302 = bitcast<f32>((bitcast<u32>(((_e176 - _e291) + 127i)) << bitcast<u32>(23i)));
        let _e303 = bitcast<u32>(_e225);
        let _e305 = ((_e303 & 2139095040u) != 0u);
        let _e320 = bitcast<u32>(_e229);
        let _e322 = ((_e320 & 2139095040u) != 0u);
        let _e337 = bitcast<u32>(_e232);
        let _e339 = ((_e337 & 2139095040u) != 0u);
        let _e355 = -(_e285);
        if (_e355 < -126i) {
            phi_1128_ = -126i;
        } else {
            phi_1128_ = select(_e355, 127i, (_e355 > 127i));
        }
        let _e360 = phi_1128_;
        let _e365 = bitcast<f32>((bitcast<u32>((_e360 + 127i)) << bitcast<u32>(23i)));
        let _e371 = bitcast<f32>((bitcast<u32>(((_e355 - _e360) + 127i)) << bitcast<u32>(23i)));
        let _e372 = bitcast<u32>(_e234);
        let _e374 = ((_e372 & 2139095040u) != 0u);
        let _e389 = bitcast<u32>(_e236);
        let _e391 = ((_e389 & 2139095040u) != 0u);
        let _e406 = bitcast<u32>(_e238);
        let _e408 = ((_e406 & 2139095040u) != 0u);
        let _e430 = ((_e184 & 8388607u) | (select(0u, 1u, ((_e184 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e433 = bitcast<i32>((_e184 >> bitcast<u32>(23i)));
        let _e440 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e430)), 32u, (_e430 == 0u))) - 8i);
        if (_e433 == 255i) {
            phi_1257_ = 255i;
        } else {
            phi_1257_ = (((_e433 + select(0i, 1i, (_e433 == 0i))) - _e440) + _e286);
        }
        let _e448 = phi_1257_;
        let _e452 = (_e430 << bitcast<u32>(((_e440 & 31i) & 31i)));
        if (_e448 <= 0i) {
            phi_1280_ = u32();
            phi_1281_ = true;
        } else {
            let _e459 = (_e452 == 0u);
            if _e459 {
                phi_1279_ = u32();
            } else {
                phi_1279_ = select(((bitcast<u32>(_e448) << bitcast<u32>(23i)) | (_e452 & 8388607u)), 2139095039u, (_e448 >= 255i));
            }
            let _e463 = phi_1279_;
            phi_1280_ = _e463;
            phi_1281_ = _e459;
        }
        let _e465 = phi_1280_;
        let _e467 = phi_1281_;
        let _e478 = ((_e192 & 8388607u) | (select(0u, 1u, ((_e192 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e481 = bitcast<i32>((_e192 >> bitcast<u32>(23i)));
        let _e488 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e478)), 32u, (_e478 == 0u))) - 8i);
        if (_e481 == 255i) {
            phi_1315_ = 255i;
        } else {
            phi_1315_ = (((_e481 + select(0i, 1i, (_e481 == 0i))) - _e488) + _e286);
        }
        let _e496 = phi_1315_;
        let _e500 = (_e478 << bitcast<u32>(((_e488 & 31i) & 31i)));
        if (_e496 <= 0i) {
            phi_1338_ = u32();
            phi_1339_ = true;
        } else {
            let _e507 = (_e500 == 0u);
            if _e507 {
                phi_1337_ = u32();
            } else {
                phi_1337_ = select(((bitcast<u32>(_e496) << bitcast<u32>(23i)) | (_e500 & 8388607u)), 2139095039u, (_e496 >= 255i));
            }
            let _e511 = phi_1337_;
            phi_1338_ = _e511;
            phi_1339_ = _e507;
        }
        let _e513 = phi_1338_;
        let _e515 = phi_1339_;
        phi_1349_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e303 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e303 & 2147483648u))), _e225, _e305) * _e296) * select(0.00000011920929f, 1f, _e305)) * _e302), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e320 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e320 & 2147483648u))), _e229, _e322) * _e296) * select(0.00000011920929f, 1f, _e322)) * _e302), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e232, _e339) * _e296) * select(0.00000011920929f, 1f, _e339)) * _e302)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e372 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e372 & 2147483648u))), _e234, _e374) * _e365) * select(0.00000011920929f, 1f, _e374)) * _e371), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e389 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e389 & 2147483648u))), _e236, _e391) * _e365) * select(0.00000011920929f, 1f, _e391)) * _e371), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e406 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e406 & 2147483648u))), _e238, _e408) * _e365) * select(0.00000011920929f, 1f, _e408)) * _e371)), bitcast<f32>(((_e183 & 2147483648u) | select(_e465, 0u, _e467))), bitcast<f32>(((_e191 & 2147483648u) | select(_e513, 0u, _e515))), _e285);
    }
    let _e606 = phi_1349_;
    let _e621 = (bitcast<f32>((bitcast<u32>(_e606.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e624 = bitcast<f32>((bitcast<u32>(_e606.member[0]) & 2147483647u));
    let _e625 = (_e624 * 0.00000011920929f);
    let _e628 = select(select(0.00000000000011368684f, _e625, (_e625 > 0.00000000000011368684f)), 0f, _e621);
    let _e629 = select(0f, _e606.member_1[0], _e621);
    let _e630 = (_e606.member[0] + _e628);
    let _e631 = (_e606.member[0] - _e628);
    let _e633 = select(38685626000000000000000000f, (1f / _e606.member_1[0]), _e621);
    let _e637 = (bitcast<f32>((bitcast<u32>(_e606.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e640 = bitcast<f32>((bitcast<u32>(_e606.member[1]) & 2147483647u));
    let _e641 = (_e640 * 0.00000011920929f);
    let _e644 = select(select(0.00000000000011368684f, _e641, (_e641 > 0.00000000000011368684f)), 0f, _e637);
    let _e645 = select(0f, _e606.member_1[1], _e637);
    let _e646 = (_e606.member[1] + _e644);
    let _e647 = (_e606.member[1] - _e644);
    let _e649 = select(38685626000000000000000000f, (1f / _e606.member_1[1]), _e637);
    let _e653 = (bitcast<f32>((bitcast<u32>(_e606.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e656 = bitcast<f32>((bitcast<u32>(_e606.member[2]) & 2147483647u));
    let _e657 = (_e656 * 0.00000011920929f);
    let _e660 = select(select(0.00000000000011368684f, _e657, (_e657 > 0.00000000000011368684f)), 0f, _e653);
    let _e661 = select(0f, _e606.member_1[2], _e653);
    let _e662 = (_e606.member[2] + _e660);
    let _e663 = (_e606.member[2] - _e660);
    let _e665 = select(38685626000000000000000000f, (1f / _e606.member_1[2]), _e653);
    let _e667 = select(_e640, _e624, (_e624 > _e640));
    let _e671 = (_e209 && (select(_e656, _e667, (_e667 > _e656)) <= 1099511600000f));
    let _e672 = select(0f, _e606.member_3, _e671);
    let _e673 = select(1f, _e606.member_2, _e671);
    let _e677 = slimbvh_question.member[1u];
    let _e680 = slimbvh_question.member[0u];
    if (_e680 == 1u) {
        phi_1588_ = SlimbvhTypeQ(SlimbvhTypeI(_e105, _e672), true);
    } else {
        phi_1588_ = SlimbvhTypeQ(SlimbvhTypeI(_e105, _e672), false);
    }
    let _e687 = phi_1588_;
    let _e692 = (_e218 & 3u);
    let _e693 = (_e222 & 3u);
    let _e694 = (_e214 & 3u);
    let _e697 = (bitcast<u32>(_e633) >> bitcast<u32>(31i));
    let _e700 = (bitcast<u32>(_e649) >> bitcast<u32>(31i));
    let _e703 = (bitcast<u32>(_e665) >> bitcast<u32>(31i));
    let _e707 = (f32(bitcast<i32>(_e122)) * _e158);
    let _e709 = (f32(bitcast<i32>(_e126)) * _e158);
    let _e711 = (f32(bitcast<i32>(_e130)) * _e158);
    let _e712 = (_e692 == 0u);
    if _e712 {
        phi_1652_ = array<f32, 3>(_e707, _e709, _e711);
    } else {
        if (_e692 == 1u) {
            phi_1651_ = array<f32, 3>(_e709, _e711, _e707);
        } else {
            phi_1651_ = array<f32, 3>(_e711, _e707, _e709);
        }
        let _e717 = phi_1651_;
        phi_1652_ = _e717;
    }
    let _e720 = phi_1652_;
    let _e722 = (f32(bitcast<i32>(_e138)) * _e158);
    let _e724 = (f32(bitcast<i32>(_e142)) * _e158);
    let _e726 = (f32(bitcast<i32>(_e146)) * _e158);
    if _e712 {
        phi_1671_ = array<f32, 3>(_e722, _e724, _e726);
    } else {
        if (_e692 == 1u) {
            phi_1670_ = array<f32, 3>(_e724, _e726, _e722);
        } else {
            phi_1670_ = array<f32, 3>(_e726, _e722, _e724);
        }
        let _e731 = phi_1670_;
        phi_1671_ = _e731;
    }
    let _e734 = phi_1671_;
    let _e745 = ((_e720[0] - _e630) * _e633);
    let _e746 = ((_e734[0] - _e631) * _e633);
    let _e747 = vec4<f32>(_e745, f32(), _e746, f32());
    let _e750 = ((_e720[1] - _e646) * _e649);
    let _e751 = ((_e734[1] - _e647) * _e649);
    let _e752 = vec4<f32>(_e750, f32(), _e751, f32());
    let _e755 = ((_e720[2] - _e662) * _e665);
    let _e756 = ((_e734[2] - _e663) * _e665);
    let _e757 = vec4<f32>(_e755, f32(), _e756, f32());
    let _e758 = vec4<f32>(_e746, f32(), _e745, f32());
    let _e760 = vec4<f32>(_e751, f32(), _e750, f32());
    let _e762 = vec4<f32>(_e756, f32(), _e755, f32());
    phi_1844_ = _e687;
    phi_1847_ = select(4294967295u, select(4294967295u, 0u, (_e673 <= _e672)), (max(max(max(min(_e747, _e758).x, min(_e752, _e760).x), min(_e757, _e762).x), _e673) <= min((min(min(max(_e747, _e758).x, max(_e752, _e760).x), max(_e757, _e762).x) + (max(max(_e757, _e762).x, -(min(_e757, _e762).x)) * 0.0000019073523f)), _e687.member.member_1)));
    phi_1849_ = select(0u, 4294967295u, (_e109 == 0u));
    phi_1851_ = (_e109 + 1u);
    loop {
        let _e786 = phi_1844_;
        let _e788 = phi_1847_;
        let _e790 = phi_1849_;
        let _e792 = phi_1851_;
        local_6 = _e786;
        let _e793 = (_e788 <= 2147483647u);
        if _e793 {
            phi_1860_ = _e788;
            phi_1863_ = _e790;
            phi_1865_ = _e792;
            loop {
                let _e795 = phi_1860_;
                let _e797 = phi_1863_;
                let _e799 = phi_1865_;
                local_2 = _e797;
                local_3 = _e795;
                local_4 = _e795;
                local_8 = _e795;
                local_9 = _e797;
                local_10 = _e799;
                let _e800 = (_e795 <= 2147483647u);
                let _e803 = (_e800 && !((_e797 >= _e109)));
                local_1 = _e800;
                if _e803 {
                    let _e809 = slimbvh_nodes.member[_e797].member[select(_e692, 2u, (2u < _e692))];
                    let _e815 = slimbvh_nodes.member[_e797].member[select(_e693, 2u, (2u < _e693))];
                    let _e821 = slimbvh_nodes.member[_e797].member[select(_e694, 2u, (2u < _e694))];
                    let _e824 = bitcast<u32>(_e158);
                    let _e829 = bitcast<f32>(_e809.x);
                    let _e834 = (_e829 + (f32((_e809.w >> bitcast<u32>(5u))) * _e158));
                    if (_e697 == 0u) {
                        phi_1967_ = SlimbvhTypeL(_e809.z, _e834);
                        phi_1968_ = SlimbvhTypeL(_e809.y, _e829);
                    } else {
                        phi_1967_ = SlimbvhTypeL(_e809.y, _e829);
                        phi_1968_ = SlimbvhTypeL(_e809.z, _e834);
                    }
                    let _e845 = phi_1967_;
                    let _e847 = phi_1968_;
                    let _e851 = bitcast<f32>(((_e824 + ((_e809.w & 31u) << bitcast<u32>(23i))) ^ (_e697 << bitcast<u32>(31i))));
                    let _e891 = bitcast<f32>(_e815.x);
                    let _e896 = (_e891 + (f32((_e815.w >> bitcast<u32>(5u))) * _e158));
                    if (_e700 == 0u) {
                        phi_2027_ = SlimbvhTypeL(_e815.z, _e896);
                        phi_2028_ = SlimbvhTypeL(_e815.y, _e891);
                    } else {
                        phi_2027_ = SlimbvhTypeL(_e815.y, _e891);
                        phi_2028_ = SlimbvhTypeL(_e815.z, _e896);
                    }
                    let _e907 = phi_2027_;
                    let _e909 = phi_2028_;
                    let _e913 = bitcast<f32>(((_e824 + ((_e815.w & 31u) << bitcast<u32>(23i))) ^ (_e700 << bitcast<u32>(31i))));
                    let _e953 = bitcast<f32>(_e821.x);
                    let _e958 = (_e953 + (f32((_e821.w >> bitcast<u32>(5u))) * _e158));
                    if (_e703 == 0u) {
                        phi_2087_ = SlimbvhTypeL(_e821.z, _e958);
                        phi_2088_ = SlimbvhTypeL(_e821.y, _e953);
                    } else {
                        phi_2087_ = SlimbvhTypeL(_e821.y, _e953);
                        phi_2088_ = SlimbvhTypeL(_e821.z, _e958);
                    }
                    let _e969 = phi_2087_;
                    let _e971 = phi_2088_;
                    let _e975 = bitcast<f32>(((_e824 + ((_e821.w & 31u) << bitcast<u32>(23i))) ^ (_e703 << bitcast<u32>(31i))));
                    let _e1011 = (_e851 * _e633);
                    let _e1018 = (((_e847.member_1 - _e630) * _e633) + (bitcast<f32>((bitcast<u32>(_e1011) & 2147483647u)) * -0.00012207031f));
                    let _e1027 = (-(_e851) * _e633);
                    let _e1034 = (((_e845.member_1 - _e631) * _e633) + (bitcast<f32>((bitcast<u32>(_e1027) & 2147483647u)) * 0.00012207031f));
                    let _e1043 = (_e913 * _e649);
                    let _e1050 = (((_e909.member_1 - _e646) * _e649) + (bitcast<f32>((bitcast<u32>(_e1043) & 2147483647u)) * -0.00012207031f));
                    let _e1059 = (-(_e913) * _e649);
                    let _e1066 = (((_e907.member_1 - _e647) * _e649) + (bitcast<f32>((bitcast<u32>(_e1059) & 2147483647u)) * 0.00012207031f));
                    let _e1075 = (_e975 * _e665);
                    let _e1082 = (((_e971.member_1 - _e662) * _e665) + (bitcast<f32>((bitcast<u32>(_e1075) & 2147483647u)) * -0.00012207031f));
                    let _e1087 = ((f32((_e971.member & 255u)) * _e1075) + _e1082);
                    let _e1088 = ((f32(((_e971.member >> bitcast<u32>(8u)) & 255u)) * _e1075) + _e1082);
                    let _e1089 = ((f32(((_e971.member >> bitcast<u32>(16u)) & 255u)) * _e1075) + _e1082);
                    let _e1090 = ((f32(((_e971.member >> bitcast<u32>(24u)) & 255u)) * _e1075) + _e1082);
                    let _e1091 = (-(_e975) * _e665);
                    let _e1098 = (((_e969.member_1 - _e663) * _e665) + (bitcast<f32>((bitcast<u32>(_e1091) & 2147483647u)) * 0.00012207031f));
                    let _e1103 = ((f32((_e969.member & 255u)) * _e1091) + _e1098);
                    let _e1104 = ((f32(((_e969.member >> bitcast<u32>(8u)) & 255u)) * _e1091) + _e1098);
                    let _e1105 = ((f32(((_e969.member >> bitcast<u32>(16u)) & 255u)) * _e1091) + _e1098);
                    let _e1106 = ((f32(((_e969.member >> bitcast<u32>(24u)) & 255u)) * _e1091) + _e1098);
                    let _e1139 = max(max(max(((f32((_e847.member & 255u)) * _e1011) + _e1018), ((f32((_e909.member & 255u)) * _e1043) + _e1050)), _e1087), _e673);
                    let _e1140 = max(max(max(((f32(((_e847.member >> bitcast<u32>(8u)) & 255u)) * _e1011) + _e1018), ((f32(((_e909.member >> bitcast<u32>(8u)) & 255u)) * _e1043) + _e1050)), _e1088), _e673);
                    let _e1141 = max(max(max(((f32(((_e847.member >> bitcast<u32>(16u)) & 255u)) * _e1011) + _e1018), ((f32(((_e909.member >> bitcast<u32>(16u)) & 255u)) * _e1043) + _e1050)), _e1089), _e673);
                    let _e1142 = max(max(max(((f32(((_e847.member >> bitcast<u32>(24u)) & 255u)) * _e1011) + _e1018), ((f32(((_e909.member >> bitcast<u32>(24u)) & 255u)) * _e1043) + _e1050)), _e1090), _e673);
                    let _e1147 = (_e786.member.member_1 + (bitcast<f32>((bitcast<u32>(_e786.member.member_1) & 2147483647u)) * 0.0000004768374f));
                    if (_e1139 <= min((min(min(((f32((_e845.member & 255u)) * _e1027) + _e1034), ((f32((_e907.member & 255u)) * _e1059) + _e1066)), _e1103) + (max(_e1103, -(_e1087)) * 0.0000023841915f)), _e1147)) {
                        phi_2572_ = (((bitcast<u32>(_e1139) ^ select(0u, 4294967288u, _e687.member_1)) & 2147483640u) | 4u);
                    } else {
                        phi_2572_ = 4294967288u;
                    }
                    let _e1162 = phi_2572_;
                    if (_e1140 <= min((min(min(((f32(((_e845.member >> bitcast<u32>(8u)) & 255u)) * _e1027) + _e1034), ((f32(((_e907.member >> bitcast<u32>(8u)) & 255u)) * _e1059) + _e1066)), _e1104) + (max(_e1104, -(_e1088)) * 0.0000023841915f)), _e1147)) {
                        phi_2585_ = ((((bitcast<u32>(_e1140) ^ select(0u, 4294967288u, _e687.member_1)) & 2147483640u) | 4u) | 1u);
                    } else {
                        phi_2585_ = 4294967288u;
                    }
                    let _e1170 = phi_2585_;
                    if (_e1141 <= min((min(min(((f32(((_e845.member >> bitcast<u32>(16u)) & 255u)) * _e1027) + _e1034), ((f32(((_e907.member >> bitcast<u32>(16u)) & 255u)) * _e1059) + _e1066)), _e1105) + (max(_e1105, -(_e1089)) * 0.0000023841915f)), _e1147)) {
                        phi_2598_ = ((((bitcast<u32>(_e1141) ^ select(0u, 4294967288u, _e687.member_1)) & 2147483640u) | 4u) | 2u);
                    } else {
                        phi_2598_ = 4294967288u;
                    }
                    let _e1178 = phi_2598_;
                    if (_e1142 <= min((min(min(((f32(((_e845.member >> bitcast<u32>(24u)) & 255u)) * _e1027) + _e1034), ((f32(((_e907.member >> bitcast<u32>(24u)) & 255u)) * _e1059) + _e1066)), _e1106) + (max(_e1106, -(_e1090)) * 0.0000023841915f)), _e1147)) {
                        phi_2611_ = ((((bitcast<u32>(_e1142) ^ select(0u, 4294967288u, _e687.member_1)) & 2147483640u) | 4u) | 3u);
                    } else {
                        phi_2611_ = 4294967288u;
                    }
                    let _e1186 = phi_2611_;
                    if (_e1162 < _e1170) {
                        phi_5246_ = SlimbvhTypeD(_e1162, _e1170);
                    } else {
                        phi_5246_ = SlimbvhTypeD(_e1170, _e1162);
                    }
                    let _e1191 = phi_5246_;
                    if (_e1178 < _e1186) {
                        phi_5258_ = SlimbvhTypeD(_e1178, _e1186);
                    } else {
                        phi_5258_ = SlimbvhTypeD(_e1186, _e1178);
                    }
                    let _e1198 = phi_5258_;
                    if (_e1191.member < _e1198.member) {
                        phi_5270_ = SlimbvhTypeD(_e1191.member, _e1198.member);
                    } else {
                        phi_5270_ = SlimbvhTypeD(_e1198.member, _e1191.member);
                    }
                    let _e1205 = phi_5270_;
                    if (_e1191.member_1 < _e1198.member_1) {
                        phi_5282_ = SlimbvhTypeD(_e1191.member_1, _e1198.member_1);
                    } else {
                        phi_5282_ = SlimbvhTypeD(_e1198.member_1, _e1191.member_1);
                    }
                    let _e1212 = phi_5282_;
                    if (_e1212.member < _e1205.member_1) {
                        phi_5294_ = SlimbvhTypeD(_e1212.member, _e1205.member_1);
                    } else {
                        phi_5294_ = SlimbvhTypeD(_e1205.member_1, _e1212.member);
                    }
                    let _e1219 = phi_5294_;
                    let _e1234 = (((_e1205.member & 7u) | ((_e1219.member & 7u) << bitcast<u32>(3u))) | (((_e1219.member_1 & 7u) | ((_e1212.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                    if (_e1234 == 0u) {
                        let _e1252 = (_e795 - 1u);
                        let _e1255 = local[(_e1252 % 128u)];
                        let _e1256 = (_e1255 & 511u);
                        let _e1258 = (_e1256 >> bitcast<u32>(3u));
                        let _e1261 = ((_e1258 == 0u) || (_e1252 == 4294967295u));
                        if _e1261 {
                        } else {
                            local[(_e1252 % 128u)] = (((_e1255 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1258);
                        }
                        phi_2697_ = select(_e795, _e1252, _e1261);
                        phi_2698_ = (((_e1255 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1256 & 3u) & 3u));
                    } else {
                        let _e1237 = (_e1234 >> bitcast<u32>(3u));
                        if (_e1237 == 0u) {
                            phi_2692_ = _e795;
                        } else {
                            local[(_e795 % 128u)] = ((_e797 << bitcast<u32>(9u)) | _e1237);
                            phi_2692_ = (_e795 + 1u);
                        }
                        let _e1246 = phi_2692_;
                        phi_2697_ = _e1246;
                        phi_2698_ = ((_e797 << bitcast<u32>(2i)) | ((_e1234 & 3u) & 3u));
                    }
                    let _e1276 = phi_2697_;
                    let _e1278 = phi_2698_;
                    let _e1280 = (_e1278 >> bitcast<u32>(2i));
                    if (_e1280 < _e109) {
                        let _e1286 = slimbvh_nodes.member[_e1280].member_1[(_e1278 & 3u)];
                        if ((_e1286 & 2147483648u) != 0u) {
                            phi_2728_ = (2147483648u | _e1278);
                        } else {
                            phi_2728_ = _e1286;
                        }
                        let _e1291 = phi_2728_;
                        phi_2729_ = _e1291;
                    } else {
                        phi_2729_ = 4294967295u;
                    }
                    let _e1293 = phi_2729_;
                    let _e1294 = (_e799 - 1u);
                    phi_1861_ = select(_e1276, 4294967295u, (_e1294 == 0u));
                    phi_1864_ = _e1293;
                    phi_1866_ = _e1294;
                } else {
                    phi_1861_ = u32();
                    phi_1864_ = u32();
                    phi_1866_ = u32();
                }
                let _e1298 = phi_1861_;
                let _e1300 = phi_1864_;
                let _e1302 = phi_1866_;
                continue;
                continuing {
                    phi_1860_ = _e1298;
                    phi_1863_ = _e1300;
                    phi_1865_ = _e1302;
                    break if !(_e803);
                }
            }
            let _e1305 = local_1;
            if _e1305 {
                let _e1307 = local_2;
                let _e1308 = (_e1307 & 2147483647u);
                let _e1310 = (_e1308 >> bitcast<u32>(2i));
                if (_e1310 >= _e109) {
                    phi_2943_ = SlimbvhTypeN(SlimbvhTypeM(vec4<f32>(0f, 0f, 0f, 0f), 0u), 0u, 0u);
                } else {
                    let _e1317 = slimbvh_nodes.member[_e1310].member[select(_e692, 2u, (2u < _e692))];
                    let _e1328 = slimbvh_nodes.member[_e1310].member[select(_e693, 2u, (2u < _e693))];
                    let _e1339 = slimbvh_nodes.member[_e1310].member[select(_e694, 2u, (2u < _e694))];
                    let _e1345 = (_e1308 & 3u);
                    let _e1348 = (((8u * _e1345) & 31u) & 31u);
                    let _e1356 = ((_e1317.w & 31u) & 31u);
                    let _e1358 = (((_e1317.y >> bitcast<u32>(_e1348)) & 255u) << bitcast<u32>(_e1356));
                    let _e1372 = ((_e1328.w & 31u) & 31u);
                    let _e1374 = (((_e1328.y >> bitcast<u32>(_e1348)) & 255u) << bitcast<u32>(_e1372));
                    let _e1388 = ((_e1339.w & 31u) & 31u);
                    let _e1390 = (((_e1339.y >> bitcast<u32>(_e1348)) & 255u) << bitcast<u32>(_e1388));
                    let _e1398 = (((((_e1317.w >> bitcast<u32>(5u)) - (((_e1317.z >> bitcast<u32>(_e1348)) & 255u) << bitcast<u32>(_e1356))) - _e1358) | (((_e1328.w >> bitcast<u32>(5u)) - (((_e1328.z >> bitcast<u32>(_e1348)) & 255u) << bitcast<u32>(_e1372))) - _e1374)) | (((_e1339.w >> bitcast<u32>(5u)) - (((_e1339.z >> bitcast<u32>(_e1348)) & 255u) << bitcast<u32>(_e1388))) - _e1390));
                    if (_e1398 < 1024u) {
                        phi_2879_ = 0u;
                    } else {
                        phi_2879_ = select(2u, 1u, (_e1398 < 2097152u));
                    }
                    let _e1403 = phi_2879_;
                    let _e1418 = slimbvh_nodes.member[_e1310].member_1[_e1345];
                    if ((_e1418 & 2147483648u) != 0u) {
                        phi_2940_ = ((_e1418 >> bitcast<u32>(28u)) & 7u);
                    } else {
                        phi_2940_ = 0u;
                    }
                    let _e1425 = phi_2940_;
                    phi_2943_ = SlimbvhTypeN(SlimbvhTypeM(vec4<f32>((bitcast<f32>(_e1317.x) + (f32(_e1358) * _e158)), (bitcast<f32>(_e1328.x) + (f32(_e1374) * _e158)), (bitcast<f32>(_e1339.x) + (f32(_e1390) * _e158)), 0f), _e1403), (_e1418 & 268435455u), _e1425);
                }
                let _e1429 = phi_2943_;
                phi_2947_ = _e786;
                phi_2950_ = SlimbvhTypeD(0u, _e1429.member_2);
                loop {
                    let _e1433 = phi_2947_;
                    let _e1435 = phi_2950_;
                    local_5 = _e1433;
                    local_7 = _e1433;
                    if (_e1435.member < _e1435.member_1) {
                        phi_2951_ = SlimbvhTypeD((_e1435.member + 1u), _e1435.member_1);
                        phi_2973_ = SlimbvhTypeD(1u, _e1435.member);
                    } else {
                        phi_2951_ = _e1435;
                        phi_2973_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                    }
                    let _e1448 = phi_2951_;
                    let _e1450 = phi_2973_;
                    let _e1454 = (bitcast<i32>(_e1450.member) != 0i);
                    if _e1454 {
                        switch bitcast<i32>(_e1429.member.member_1) {
                            case 0: {
                                phi_2991_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_2991_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_2991_ = 3u;
                                break;
                            }
                            default: {
                                phi_2991_ = u32();
                                break;
                            }
                        }
                        let _e1460 = phi_2991_;
                        switch bitcast<i32>(_e1429.member.member_1) {
                            case 0: {
                                phi_3002_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_3002_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_3002_ = 3u;
                                break;
                            }
                            default: {
                                phi_3002_ = u32();
                                break;
                            }
                        }
                        let _e1467 = phi_3002_;
                        let _e1469 = ((_e1429.member_1 + (_e1450.member_1 * ((3u * _e1460) + 1u))) + (3u * _e1467));
                        if (_e1469 < _e112) {
                            let _e1472 = slimbvh_triangles.member[_e1469];
                            phi_3018_ = _e1472;
                        } else {
                            phi_3018_ = 4294967295u;
                        }
                        let _e1474 = phi_3018_;
                        switch bitcast<i32>(_e1429.member.member_1) {
                            case 0: {
                                phi_3031_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_3031_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_3031_ = 3u;
                                break;
                            }
                            default: {
                                phi_3031_ = u32();
                                break;
                            }
                        }
                        let _e1477 = phi_3031_;
                        let _e1481 = (_e1429.member_1 + (_e1450.member_1 * ((3u * _e1477) + 1u)));
                        switch bitcast<i32>(_e1429.member.member_1) {
                            case 0: {
                                phi_3042_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_3042_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_3042_ = 3u;
                                break;
                            }
                            default: {
                                phi_3042_ = u32();
                                break;
                            }
                        }
                        let _e1484 = phi_3042_;
                        let _e1485 = (_e1481 + _e1484);
                        let _e1487 = (_e1481 + (2u * _e1484));
                        switch bitcast<i32>(_e1429.member.member_1) {
                            case 0: {
                                if (_e1481 < _e112) {
                                    let _e1764 = slimbvh_triangles.member[_e1481];
                                    phi_3069_ = _e1764;
                                } else {
                                    phi_3069_ = 0u;
                                }
                                let _e1766 = phi_3069_;
                                let _e1769 = ((10u * _e218) & 31u);
                                let _e1780 = ((10u * _e222) & 31u);
                                let _e1791 = ((10u * _e214) & 31u);
                                if (_e1485 < _e112) {
                                    let _e1803 = slimbvh_triangles.member[_e1485];
                                    phi_3115_ = _e1803;
                                } else {
                                    phi_3115_ = 0u;
                                }
                                let _e1805 = phi_3115_;
                                if (_e1487 < _e112) {
                                    let _e1833 = slimbvh_triangles.member[_e1487];
                                    phi_3161_ = _e1833;
                                } else {
                                    phi_3161_ = 0u;
                                }
                                let _e1835 = phi_3161_;
                                phi_3628_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1429.member.member.x + ((bitcast<f32>((1258291200u | ((_e1766 >> bitcast<u32>(_e1769)) & 1023u))) - 8388608f) * _e158)), (_e1429.member.member.y + ((bitcast<f32>((1258291200u | ((_e1766 >> bitcast<u32>(_e1780)) & 1023u))) - 8388608f) * _e158)), (_e1429.member.member.z + ((bitcast<f32>((1258291200u | ((_e1766 >> bitcast<u32>(_e1791)) & 1023u))) - 8388608f) * _e158))), array<f32, 3>((_e1429.member.member.x + ((bitcast<f32>((1258291200u | ((_e1805 >> bitcast<u32>(_e1769)) & 1023u))) - 8388608f) * _e158)), (_e1429.member.member.y + ((bitcast<f32>((1258291200u | ((_e1805 >> bitcast<u32>(_e1780)) & 1023u))) - 8388608f) * _e158)), (_e1429.member.member.z + ((bitcast<f32>((1258291200u | ((_e1805 >> bitcast<u32>(_e1791)) & 1023u))) - 8388608f) * _e158))), array<f32, 3>((_e1429.member.member.x + ((bitcast<f32>((1258291200u | ((_e1835 >> bitcast<u32>(_e1769)) & 1023u))) - 8388608f) * _e158)), (_e1429.member.member.y + ((bitcast<f32>((1258291200u | ((_e1835 >> bitcast<u32>(_e1780)) & 1023u))) - 8388608f) * _e158)), (_e1429.member.member.z + ((bitcast<f32>((1258291200u | ((_e1835 >> bitcast<u32>(_e1791)) & 1023u))) - 8388608f) * _e158))));
                                break;
                            }
                            case 1: {
                                if (_e1481 < _e112) {
                                    let _e1577 = slimbvh_triangles.member[_e1481];
                                    phi_3208_ = _e1577;
                                } else {
                                    phi_3208_ = 0u;
                                }
                                let _e1579 = phi_3208_;
                                let _e1580 = (_e1481 + 1u);
                                if (_e1580 < _e112) {
                                    let _e1583 = slimbvh_triangles.member[_e1580];
                                    phi_3221_ = _e1583;
                                } else {
                                    phi_3221_ = 0u;
                                }
                                let _e1585 = phi_3221_;
                                let _e1587 = (_e218 == 1u);
                                if _e1587 {
                                    phi_3231_ = ((_e1579 >> bitcast<u32>(21i)) | (_e1585 << bitcast<u32>(11i)));
                                } else {
                                    phi_3231_ = (_e1585 >> bitcast<u32>(10i));
                                }
                                let _e1596 = phi_3231_;
                                let _e1605 = (_e222 == 1u);
                                if _e1605 {
                                    phi_3252_ = ((_e1579 >> bitcast<u32>(21i)) | (_e1585 << bitcast<u32>(11i)));
                                } else {
                                    phi_3252_ = (_e1585 >> bitcast<u32>(10i));
                                }
                                let _e1614 = phi_3252_;
                                let _e1623 = (_e214 == 1u);
                                if _e1623 {
                                    phi_3273_ = ((_e1579 >> bitcast<u32>(21i)) | (_e1585 << bitcast<u32>(11i)));
                                } else {
                                    phi_3273_ = (_e1585 >> bitcast<u32>(10i));
                                }
                                let _e1632 = phi_3273_;
                                if (_e1485 < _e112) {
                                    let _e1643 = slimbvh_triangles.member[_e1485];
                                    phi_3300_ = _e1643;
                                } else {
                                    phi_3300_ = 0u;
                                }
                                let _e1645 = phi_3300_;
                                let _e1646 = (_e1485 + 1u);
                                if (_e1646 < _e112) {
                                    let _e1649 = slimbvh_triangles.member[_e1646];
                                    phi_3313_ = _e1649;
                                } else {
                                    phi_3313_ = 0u;
                                }
                                let _e1651 = phi_3313_;
                                if _e1587 {
                                    phi_3323_ = ((_e1645 >> bitcast<u32>(21i)) | (_e1651 << bitcast<u32>(11i)));
                                } else {
                                    phi_3323_ = (_e1651 >> bitcast<u32>(10i));
                                }
                                let _e1660 = phi_3323_;
                                if _e1605 {
                                    phi_3344_ = ((_e1645 >> bitcast<u32>(21i)) | (_e1651 << bitcast<u32>(11i)));
                                } else {
                                    phi_3344_ = (_e1651 >> bitcast<u32>(10i));
                                }
                                let _e1676 = phi_3344_;
                                if _e1623 {
                                    phi_3365_ = ((_e1645 >> bitcast<u32>(21i)) | (_e1651 << bitcast<u32>(11i)));
                                } else {
                                    phi_3365_ = (_e1651 >> bitcast<u32>(10i));
                                }
                                let _e1692 = phi_3365_;
                                if (_e1487 < _e112) {
                                    let _e1703 = slimbvh_triangles.member[_e1487];
                                    phi_3392_ = _e1703;
                                } else {
                                    phi_3392_ = 0u;
                                }
                                let _e1705 = phi_3392_;
                                let _e1706 = (_e1487 + 1u);
                                if (_e1706 < _e112) {
                                    let _e1709 = slimbvh_triangles.member[_e1706];
                                    phi_3405_ = _e1709;
                                } else {
                                    phi_3405_ = 0u;
                                }
                                let _e1711 = phi_3405_;
                                if _e1587 {
                                    phi_3415_ = ((_e1705 >> bitcast<u32>(21i)) | (_e1711 << bitcast<u32>(11i)));
                                } else {
                                    phi_3415_ = (_e1711 >> bitcast<u32>(10i));
                                }
                                let _e1720 = phi_3415_;
                                if _e1605 {
                                    phi_3436_ = ((_e1705 >> bitcast<u32>(21i)) | (_e1711 << bitcast<u32>(11i)));
                                } else {
                                    phi_3436_ = (_e1711 >> bitcast<u32>(10i));
                                }
                                let _e1736 = phi_3436_;
                                if _e1623 {
                                    phi_3457_ = ((_e1705 >> bitcast<u32>(21i)) | (_e1711 << bitcast<u32>(11i)));
                                } else {
                                    phi_3457_ = (_e1711 >> bitcast<u32>(10i));
                                }
                                let _e1752 = phi_3457_;
                                phi_3628_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1429.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1596, _e1579, _e223) & 2097151u))) - 8388608f) * _e158)), (_e1429.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1614, _e1579, _e226) & 2097151u))) - 8388608f) * _e158)), (_e1429.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1632, _e1579, _e230) & 2097151u))) - 8388608f) * _e158))), array<f32, 3>((_e1429.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1660, _e1645, _e223) & 2097151u))) - 8388608f) * _e158)), (_e1429.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1676, _e1645, _e226) & 2097151u))) - 8388608f) * _e158)), (_e1429.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1692, _e1645, _e230) & 2097151u))) - 8388608f) * _e158))), array<f32, 3>((_e1429.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1720, _e1705, _e223) & 2097151u))) - 8388608f) * _e158)), (_e1429.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1736, _e1705, _e226) & 2097151u))) - 8388608f) * _e158)), (_e1429.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1752, _e1705, _e230) & 2097151u))) - 8388608f) * _e158))));
                                break;
                            }
                            case 2: {
                                let _e1490 = (_e1481 + _e218);
                                if (_e1490 < _e112) {
                                    let _e1493 = slimbvh_triangles.member[_e1490];
                                    phi_3486_ = _e1493;
                                } else {
                                    phi_3486_ = 0u;
                                }
                                let _e1495 = phi_3486_;
                                let _e1496 = (_e1481 + _e222);
                                if (_e1496 < _e112) {
                                    let _e1499 = slimbvh_triangles.member[_e1496];
                                    phi_3499_ = _e1499;
                                } else {
                                    phi_3499_ = 0u;
                                }
                                let _e1501 = phi_3499_;
                                let _e1502 = (_e1481 + _e214);
                                if (_e1502 < _e112) {
                                    let _e1505 = slimbvh_triangles.member[_e1502];
                                    phi_3512_ = _e1505;
                                } else {
                                    phi_3512_ = 0u;
                                }
                                let _e1507 = phi_3512_;
                                let _e1518 = (_e1485 + _e218);
                                if (_e1518 < _e112) {
                                    let _e1521 = slimbvh_triangles.member[_e1518];
                                    phi_3538_ = _e1521;
                                } else {
                                    phi_3538_ = 0u;
                                }
                                let _e1523 = phi_3538_;
                                let _e1524 = (_e1485 + _e222);
                                if (_e1524 < _e112) {
                                    let _e1527 = slimbvh_triangles.member[_e1524];
                                    phi_3551_ = _e1527;
                                } else {
                                    phi_3551_ = 0u;
                                }
                                let _e1529 = phi_3551_;
                                let _e1530 = (_e1485 + _e214);
                                if (_e1530 < _e112) {
                                    let _e1533 = slimbvh_triangles.member[_e1530];
                                    phi_3564_ = _e1533;
                                } else {
                                    phi_3564_ = 0u;
                                }
                                let _e1535 = phi_3564_;
                                let _e1546 = (_e1487 + _e218);
                                if (_e1546 < _e112) {
                                    let _e1549 = slimbvh_triangles.member[_e1546];
                                    phi_3590_ = _e1549;
                                } else {
                                    phi_3590_ = 0u;
                                }
                                let _e1551 = phi_3590_;
                                let _e1552 = (_e1487 + _e222);
                                if (_e1552 < _e112) {
                                    let _e1555 = slimbvh_triangles.member[_e1552];
                                    phi_3603_ = _e1555;
                                } else {
                                    phi_3603_ = 0u;
                                }
                                let _e1557 = phi_3603_;
                                let _e1558 = (_e1487 + _e214);
                                if (_e1558 < _e112) {
                                    let _e1561 = slimbvh_triangles.member[_e1558];
                                    phi_3616_ = _e1561;
                                } else {
                                    phi_3616_ = 0u;
                                }
                                let _e1563 = phi_3616_;
                                phi_3628_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1495)) * _e158), (f32(bitcast<i32>(_e1501)) * _e158), (f32(bitcast<i32>(_e1507)) * _e158)), array<f32, 3>((f32(bitcast<i32>(_e1523)) * _e158), (f32(bitcast<i32>(_e1529)) * _e158), (f32(bitcast<i32>(_e1535)) * _e158)), array<f32, 3>((f32(bitcast<i32>(_e1551)) * _e158), (f32(bitcast<i32>(_e1557)) * _e158), (f32(bitcast<i32>(_e1563)) * _e158)));
                                break;
                            }
                            default: {
                                phi_3628_ = array<array<f32, 3>, 3>();
                                break;
                            }
                        }
                        let _e1863 = phi_3628_;
                        let _e1880 = (_e1863[0][2] - _e606.member[2]);
                        let _e1883 = (((_e1863[0][0] - _e606.member[0]) * _e661) - (_e1880 * _e629));
                        let _e1886 = (((_e1863[0][1] - _e606.member[1]) * _e661) - (_e1880 * _e645));
                        let _e1889 = (_e1863[1][2] - _e606.member[2]);
                        let _e1892 = (((_e1863[1][0] - _e606.member[0]) * _e661) - (_e1889 * _e629));
                        let _e1895 = (((_e1863[1][1] - _e606.member[1]) * _e661) - (_e1889 * _e645));
                        let _e1898 = (_e1863[2][2] - _e606.member[2]);
                        let _e1901 = (((_e1863[2][0] - _e606.member[0]) * _e661) - (_e1898 * _e629));
                        let _e1904 = (((_e1863[2][1] - _e606.member[1]) * _e661) - (_e1898 * _e645));
                        let _e1905 = (_e1901 * _e1895);
                        let _e1906 = (_e1904 * _e1892);
                        let _e1907 = (_e1883 * _e1904);
                        let _e1908 = (_e1886 * _e1901);
                        let _e1909 = (_e1892 * _e1886);
                        let _e1910 = (_e1895 * _e1883);
                        let _e1915 = (((_e1905 >= _e1906) && (_e1907 >= _e1908)) && (_e1909 >= _e1910));
                        let _e1921 = (_e1915 || (((_e1905 <= _e1906) && (_e1907 <= _e1908)) && (_e1909 <= _e1910)));
                        if _e1921 {
                            let _e1923 = select(-1f, 1f, _e1915);
                            let _e1925 = ((_e1905 - _e1906) * _e1923);
                            let _e1927 = select(0f, _e1925, (_e1925 > 0f));
                            let _e1929 = ((_e1907 - _e1908) * _e1923);
                            let _e1931 = select(0f, _e1929, (_e1929 > 0f));
                            let _e1933 = ((_e1909 - _e1910) * _e1923);
                            let _e1935 = select(0f, _e1933, (_e1933 > 0f));
                            let _e1937 = ((_e1927 + _e1931) + _e1935);
                            let _e1952 = ((min(min(_e1863[0][0], _e1863[1][0]), _e1863[2][0]) - _e630) * _e633);
                            let _e1953 = ((max(max(_e1863[0][0], _e1863[1][0]), _e1863[2][0]) - _e631) * _e633);
                            let _e1954 = vec4<f32>(_e1952, f32(), _e1953, f32());
                            let _e1957 = ((min(min(_e1863[0][1], _e1863[1][1]), _e1863[2][1]) - _e646) * _e649);
                            let _e1958 = ((max(max(_e1863[0][1], _e1863[1][1]), _e1863[2][1]) - _e647) * _e649);
                            let _e1959 = vec4<f32>(_e1957, f32(), _e1958, f32());
                            let _e1962 = ((min(min(_e1863[0][2], _e1863[1][2]), _e1863[2][2]) - _e662) * _e665);
                            let _e1963 = ((max(max(_e1863[0][2], _e1863[1][2]), _e1863[2][2]) - _e663) * _e665);
                            let _e1964 = vec4<f32>(_e1962, f32(), _e1963, f32());
                            let _e1965 = vec4<f32>(_e1953, f32(), _e1952, f32());
                            let _e1967 = vec4<f32>(_e1958, f32(), _e1957, f32());
                            let _e1969 = vec4<f32>(_e1963, f32(), _e1962, f32());
                            let _e1978 = max(max(min(_e1954, _e1965).x, min(_e1959, _e1967).x), min(_e1964, _e1969).x);
                            let _e1983 = min(min(max(_e1954, _e1965).x, max(_e1959, _e1967).x), max(_e1964, _e1969).x);
                            let _e1988 = max(_e1978, _e673);
                            let _e2010 = (((((_e1921 && (_e1937 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1883, _e1892), _e1901) <= 0f) && (max(max(_e1883, _e1892), _e1901) >= 0f))) && ((min(min(_e1886, _e1895), _e1904) <= 0f) && (max(max(_e1886, _e1895), _e1904) >= 0f))) && (_e1988 <= (_e1983 + (max(max(_e1964, _e1969).x, -(min(_e1964, _e1969).x)) * 0.0000019073523f)))) && (_e1988 <= _e1433.member.member_1));
                            if _e2010 {
                                let _e2015 = (_e1863[1][0] - _e1863[0][0]);
                                let _e2016 = (_e1863[1][1] - _e1863[0][1]);
                                let _e2017 = (_e1863[1][2] - _e1863[0][2]);
                                let _e2018 = vec3<f32>(_e2015, _e2016, _e2017);
                                let _e2019 = (_e1863[2][0] - _e1863[1][0]);
                                let _e2020 = (_e1863[2][1] - _e1863[1][1]);
                                let _e2021 = (_e1863[2][2] - _e1863[1][2]);
                                let _e2022 = vec3<f32>(_e2019, _e2020, _e2021);
                                let _e2023 = (_e1863[0][0] - _e1863[2][0]);
                                let _e2024 = (_e1863[0][1] - _e1863[2][1]);
                                let _e2025 = (_e1863[0][2] - _e1863[2][2]);
                                let _e2026 = vec3<f32>(_e2023, _e2024, _e2025);
                                let _e2037 = max(max(bitcast<f32>((bitcast<u32>(_e2015) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2016) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2017) & 2147483647u)));
                                let _e2048 = max(max(bitcast<f32>((bitcast<u32>(_e2019) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2020) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2021) & 2147483647u)));
                                let _e2061 = max(max(_e2037, _e2048), max(max(bitcast<f32>((bitcast<u32>(_e2023) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2024) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2025) & 2147483647u))));
                                if (_e2037 == _e2061) {
                                    phi_3993_ = _e1895;
                                    phi_3994_ = _e1892;
                                    phi_3995_ = _e1886;
                                    phi_3996_ = _e1883;
                                    phi_3997_ = vec3<f32>(_e1863[0][0], _e1863[0][1], _e1863[0][2]);
                                    phi_3998_ = _e2026;
                                    phi_3999_ = _e2022;
                                    phi_4000_ = _e2018;
                                } else {
                                    let _e2063 = (_e2048 == _e2061);
                                    let _e2068 = vec3(_e2063);
                                    phi_3993_ = select(_e1886, _e1904, _e2063);
                                    phi_3994_ = select(_e1883, _e1901, _e2063);
                                    phi_3995_ = select(_e1904, _e1895, _e2063);
                                    phi_3996_ = select(_e1901, _e1892, _e2063);
                                    phi_3997_ = select(vec3<f32>(_e1863[2][0], _e1863[2][1], _e1863[2][2]), vec3<f32>(_e1863[1][0], _e1863[1][1], _e1863[1][2]), _e2068);
                                    phi_3998_ = select(_e2022, _e2018, _e2068);
                                    phi_3999_ = select(_e2018, _e2026, _e2068);
                                    phi_4000_ = select(_e2026, _e2022, _e2068);
                                }
                                let _e2074 = phi_3993_;
                                let _e2076 = phi_3994_;
                                let _e2078 = phi_3995_;
                                let _e2080 = phi_3996_;
                                let _e2082 = phi_3997_;
                                let _e2084 = phi_3998_;
                                let _e2086 = phi_3999_;
                                let _e2088 = phi_4000_;
                                let _e2095 = ((_e2086.y * _e2084.z) - (_e2084.y * _e2086.z));
                                let _e2100 = ((_e2086.z * _e2084.x) - (_e2084.z * _e2086.x));
                                let _e2103 = ((_e2086.x * _e2084.y) - (_e2084.x * _e2086.y));
                                let _e2106 = ((_e1927 >= _e1931) && (_e1927 >= _e1935));
                                let _e2107 = (_e1931 >= _e1935);
                                let _e2121 = (((_e2095 * (select(select(_e1863[2][0], _e1863[1][0], _e2107), _e1863[0][0], _e2106) - _e606.member[0])) + (_e2100 * (select(select(_e1863[2][1], _e1863[1][1], _e2107), _e1863[0][1], _e2106) - _e606.member[1]))) + (_e2103 * (select(select(_e1863[2][2], _e1863[1][2], _e2107), _e1863[0][2], _e2106) - _e606.member[2])));
                                let _e2126 = (((_e2095 * _e629) + (_e2100 * _e645)) + (_e2103 * _e661));
                                let _e2127 = (_e2076 - _e2080);
                                let _e2128 = (_e2074 - _e2078);
                                let _e2131 = ((_e2127 * _e2127) + (_e2128 * _e2128));
                                let _e2138 = (-(((_e2080 * _e2127) + (_e2078 * _e2128))) / select(0.000000000000000000000000000000000000011754944f, _e2131, (_e2131 > 0.000000000000000000000000000000000000011754944f)));
                                let _e2140 = select(1f, _e2138, (_e2138 < 1f));
                                let _e2142 = select(0f, _e2140, (_e2140 > 0f));
                                let _e2151 = ((_e2082.x + (_e2088.x * _e2142)) - _e606.member[0]);
                                let _e2154 = ((_e2082.y + (_e2088.y * _e2142)) - _e606.member[1]);
                                let _e2157 = ((_e2082.z + (_e2088.z * _e2142)) - _e606.member[2]);
                                let _e2222 = ((bitcast<f32>((bitcast<u32>(((((_e2095 * _e2151) + (_e2100 * _e2154)) + (_e2103 * _e2157)) - _e2121)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e2151) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2154) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2157) & 2147483647u))), _e2061)) * max(max(bitcast<f32>((bitcast<u32>(_e2095) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2100) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2103) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e2126) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e2086.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2086.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2086.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e2084.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2084.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2084.z) & 2147483647u)))))));
                                let _e2223 = (_e2121 / _e2126);
                                if (_e2010 && !(_e2222)) {
                                    let _e2226 = (_e2157 / _e661);
                                    let _e2234 = (((_e2095 * (_e2151 - (_e629 * _e2226))) + (_e2100 * (_e2154 - (_e645 * _e2226)))) / _e2126);
                                    phi_4179_ = select(select(_e2226, (_e2226 + _e2234), (bitcast<f32>((bitcast<u32>(_e2234) & 2147483647u)) <= _e2061)), _e2223, _e2222);
                                } else {
                                    phi_4179_ = _e2223;
                                }
                                let _e2243 = phi_4179_;
                                let _e2245 = select(_e1983, _e2243, (_e2243 < _e1983));
                                let _e2247 = select(_e1978, _e2245, (_e2245 > _e1978));
                                let _e2250 = select(_e2247, 0f, (bitcast<u32>(_e2247) == 2147483648u));
                                let _e2251 = (1f / _e1937);
                                phi_4205_ = SlimbvhTypeE(_e2250, (_e1931 * _e2251), (_e1935 * _e2251), ((_e2010 && (_e2250 >= _e673)) && (_e2250 <= _e1433.member.member_1)));
                                phi_4206_ = SlimbvhTypeE();
                            } else {
                                phi_4205_ = SlimbvhTypeE();
                                phi_4206_ = SlimbvhTypeE(0f, 0f, 0f, _e2010);
                            }
                            let _e2260 = phi_4205_;
                            let _e2262 = phi_4206_;
                            phi_4209_ = _e2260;
                            phi_4210_ = _e2262;
                            phi_4211_ = select(true, false, _e2010);
                        } else {
                            phi_4209_ = SlimbvhTypeE();
                            phi_4210_ = SlimbvhTypeE(0f, 0f, 0f, _e1921);
                            phi_4211_ = true;
                        }
                        let _e2265 = phi_4209_;
                        let _e2267 = phi_4210_;
                        let _e2269 = phi_4211_;
                        if _e2269 {
                            phi_4215_ = _e2267;
                        } else {
                            phi_4215_ = _e2265;
                        }
                        let _e2271 = phi_4215_;
                        if _e2271.member_3 {
                            phi_4224_ = SlimbvhTypeF(_e2271.member, _e2271.member_1, _e2271.member_2, _e1474);
                        } else {
                            phi_4224_ = _e105;
                        }
                        let _e2278 = phi_4224_;
                        if (_e2278.member_3 != 4294967295u) {
                            let _e2284 = slimbvh_target.member[0u][0u];
                            let _e2288 = slimbvh_target.member[0u][1u];
                            let _e2292 = slimbvh_target.member[0u][2u];
                            let _e2296 = slimbvh_target.member[0u][3u];
                            let _e2300 = slimbvh_target.member[1u][0u];
                            let _e2304 = slimbvh_target.member[1u][1u];
                            let _e2308 = slimbvh_target.member[1u][2u];
                            let _e2312 = slimbvh_target.member[1u][3u];
                            let _e2313 = bitcast<f32>(_e2284);
                            let _e2314 = bitcast<f32>(_e2288);
                            let _e2315 = bitcast<f32>(_e2292);
                            let _e2317 = bitcast<f32>(_e2300);
                            let _e2318 = array<u32, 3>(_e2304, _e2308, _e2312);
                            if (_e176 < -126i) {
                                phi_4277_ = -126i;
                            } else {
                                phi_4277_ = select(_e176, 127i, (_e176 > 127i));
                            }
                            let _e2324 = phi_4277_;
                            let _e2329 = bitcast<f32>((bitcast<u32>((_e2324 + 127i)) << bitcast<u32>(23i)));
                            let _e2335 = bitcast<f32>((bitcast<u32>(((_e176 - _e2324) + 127i)) << bitcast<u32>(23i)));
                            if (_e2296 == 0u) {
                                phi_4417_ = SlimbvhTypeH(array<f32, 3>(_e2313, _e2314, _e2315), _e2296, _e2317, _e2318);
                            } else {
                                let _e2337 = bitcast<u32>(_e2313);
                                let _e2339 = ((_e2337 & 2139095040u) != 0u);
                                let _e2354 = bitcast<u32>(_e2314);
                                let _e2356 = ((_e2354 & 2139095040u) != 0u);
                                let _e2371 = bitcast<u32>(_e2315);
                                let _e2373 = ((_e2371 & 2139095040u) != 0u);
                                let _e2389 = bitcast<u32>(_e2317);
                                let _e2391 = ((_e2389 & 2139095040u) != 0u);
                                phi_4417_ = SlimbvhTypeH(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2337 & 2147483648u))), _e2313, _e2339) * _e2329) * select(0.00000011920929f, 1f, _e2339)) * _e2335), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2354 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2354 & 2147483648u))), _e2314, _e2356) * _e2329) * select(0.00000011920929f, 1f, _e2356)) * _e2335), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2371 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2371 & 2147483648u))), _e2315, _e2373) * _e2329) * select(0.00000011920929f, 1f, _e2373)) * _e2335)), _e2296, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e2389 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e2389 & 2147483648u))), _e2317, _e2391) * _e2329) * select(0.00000011920929f, 1f, _e2391)) * _e2335), _e2318);
                            }
                            let _e2408 = phi_4417_;
                            if (_e1474 == _e677) {
                                phi_4746_ = false;
                            } else {
                                let _e2410 = (_e1474 / 16u);
                                if (_e2410 < arrayLength((&slimbvh_sides.member))) {
                                    let _e2413 = slimbvh_sides.member[_e2410];
                                    phi_4441_ = _e2413;
                                } else {
                                    phi_4441_ = 0u;
                                }
                                let _e2415 = phi_4441_;
                                let _e2424 = (bitcast<i32>((_e2415 << bitcast<u32>(((30u - ((_e1474 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                let _e2425 = (_e2424 == 0i);
                                if _e2425 {
                                    phi_4745_ = true;
                                } else {
                                    if _e223 {
                                        phi_4471_ = vec3<f32>(_e1863[0][0], _e1863[0][1], _e1863[0][2]);
                                    } else {
                                        if (_e218 == 1u) {
                                            phi_4470_ = vec3<f32>(_e1863[0][2], _e1863[0][0], _e1863[0][1]);
                                        } else {
                                            phi_4470_ = vec3<f32>(_e1863[0][1], _e1863[0][2], _e1863[0][0]);
                                        }
                                        let _e2430 = phi_4470_;
                                        phi_4471_ = _e2430;
                                    }
                                    let _e2433 = phi_4471_;
                                    if _e223 {
                                        phi_4490_ = vec3<f32>(_e1863[1][0], _e1863[1][1], _e1863[1][2]);
                                    } else {
                                        if (_e218 == 1u) {
                                            phi_4489_ = vec3<f32>(_e1863[1][2], _e1863[1][0], _e1863[1][1]);
                                        } else {
                                            phi_4489_ = vec3<f32>(_e1863[1][1], _e1863[1][2], _e1863[1][0]);
                                        }
                                        let _e2438 = phi_4489_;
                                        phi_4490_ = _e2438;
                                    }
                                    let _e2441 = phi_4490_;
                                    if _e223 {
                                        phi_4509_ = vec3<f32>(_e1863[2][0], _e1863[2][1], _e1863[2][2]);
                                    } else {
                                        if (_e218 == 1u) {
                                            phi_4508_ = vec3<f32>(_e1863[2][2], _e1863[2][0], _e1863[2][1]);
                                        } else {
                                            phi_4508_ = vec3<f32>(_e1863[2][1], _e1863[2][2], _e1863[2][0]);
                                        }
                                        let _e2446 = phi_4508_;
                                        phi_4509_ = _e2446;
                                    }
                                    let _e2449 = phi_4509_;
                                    let _e2452 = (_e2441.x - _e2433.x);
                                    let _e2455 = (_e2441.y - _e2433.y);
                                    let _e2458 = (_e2441.z - _e2433.z);
                                    let _e2460 = (_e2449.x - _e2433.x);
                                    let _e2462 = (_e2449.y - _e2433.y);
                                    let _e2464 = (_e2449.z - _e2433.z);
                                    if (_e2408.member_1 == 1u) {
                                        phi_4545_ = (vec3<f32>(_e2408.member[0], _e2408.member[1], _e2408.member[2]) - _e2433);
                                    } else {
                                        phi_4545_ = vec3<f32>(_e2408.member[0], _e2408.member[1], _e2408.member[2]);
                                    }
                                    let _e2479 = phi_4545_;
                                    let _e2485 = bitcast<f32>((bitcast<u32>((_e2452 * _e2462)) ^ _e2408.member_3[0]));
                                    let _e2489 = bitcast<f32>((bitcast<u32>((_e2455 * _e2460)) ^ _e2408.member_3[0]));
                                    let _e2493 = bitcast<f32>((bitcast<u32>((_e2455 * _e2464)) ^ _e2408.member_3[0]));
                                    let _e2497 = bitcast<f32>((bitcast<u32>((_e2458 * _e2462)) ^ _e2408.member_3[0]));
                                    let _e2501 = bitcast<f32>((bitcast<u32>((_e2458 * _e2460)) ^ _e2408.member_3[0]));
                                    let _e2505 = bitcast<f32>((bitcast<u32>((_e2452 * _e2464)) ^ _e2408.member_3[0]));
                                    let _e2506 = (_e2493 - _e2497);
                                    let _e2507 = (_e2501 - _e2505);
                                    let _e2508 = (_e2485 - _e2489);
                                    let _e2532 = (bitcast<f32>((bitcast<u32>(_e2493) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2497) & 2147483647u)));
                                    let _e2539 = (bitcast<f32>((bitcast<u32>(_e2501) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2505) & 2147483647u)));
                                    let _e2546 = (bitcast<f32>((bitcast<u32>(_e2485) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2489) & 2147483647u)));
                                    if (_e2408.member_2 == 0f) {
                                        phi_4727_ = 0f;
                                    } else {
                                        let _e2576 = bitcast<f32>((bitcast<u32>(_e2506) & 2147483647u));
                                        let _e2579 = bitcast<f32>((bitcast<u32>(_e2507) & 2147483647u));
                                        let _e2582 = bitcast<f32>((bitcast<u32>(_e2508) & 2147483647u));
                                        let _e2584 = select(_e2582, _e2579, (_e2579 > _e2582));
                                        let _e2588 = select(_e2582, _e2579, (_e2579 < _e2582));
                                        let _e2592 = select(_e2579, _e2576, (_e2576 < _e2579));
                                        let _e2594 = select(_e2579, _e2576, (_e2576 > _e2579));
                                        let _e2596 = select(_e2582, _e2594, (_e2594 < _e2582));
                                        phi_4727_ = bitcast<f32>((bitcast<u32>((_e2408.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2584, _e2576, (_e2576 > _e2584)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2596, _e2592, (_e2592 > _e2596)))) ^ _e2408.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2588, _e2576, (_e2576 < _e2588)))) ^ _e2408.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2532 + _e2539) + _e2546))) ^ _e2408.member_3[0]))) * 1.0000005f)) ^ _e2408.member_3[0])))) ^ _e2408.member_3[0]));
                                    }
                                    let _e2623 = phi_4727_;
                                    phi_4745_ = (_e2425 || !(((((bitcast<f32>((bitcast<u32>((_e2479.x * _e2506)) ^ _e2408.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2479.y * _e2507)) ^ _e2408.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2479.z * _e2508)) ^ _e2408.member_3[0]))) * f32(-(_e2424))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2479.x) & 2147483647u)) * _e2532)) ^ _e2408.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2479.y) & 2147483647u)) * _e2539)) ^ _e2408.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2479.z) & 2147483647u)) * _e2546)) ^ _e2408.member_3[0]))))) ^ _e2408.member_3[0])) + _e2623) + 0.0000000000000000000000000000000000001880791f))));
                                }
                                let _e2637 = phi_4745_;
                                phi_4746_ = _e2637;
                            }
                            let _e2639 = phi_4746_;
                            if _e2639 {
                                if (_e2278.member < _e1433.member.member.member) {
                                    phi_4766_ = true;
                                } else {
                                    if (_e2278.member == _e1433.member.member.member) {
                                        phi_4765_ = (_e2278.member_3 < _e1433.member.member.member_3);
                                    } else {
                                        phi_4765_ = false;
                                    }
                                    let _e2651 = phi_4765_;
                                    phi_4766_ = _e2651;
                                }
                                let _e2653 = phi_4766_;
                                if _e2653 {
                                    phi_4773_ = SlimbvhTypeQ(SlimbvhTypeI(_e2278, _e2278.member), _e1433.member_1);
                                } else {
                                    phi_4773_ = _e1433;
                                }
                                let _e2659 = phi_4773_;
                                if _e2659.member_1 {
                                    phi_4779_ = SlimbvhTypeQ(SlimbvhTypeI(_e2659.member.member, bitcast<f32>(4286578687u)), _e2659.member_1);
                                } else {
                                    phi_4779_ = _e2659;
                                }
                                let _e2668 = phi_4779_;
                                phi_4780_ = _e2668;
                            } else {
                                phi_4780_ = _e1433;
                            }
                            let _e2670 = phi_4780_;
                            phi_4781_ = _e2670;
                        } else {
                            phi_4781_ = _e1433;
                        }
                        let _e2672 = phi_4781_;
                        phi_2948_ = _e2672;
                    } else {
                        phi_2948_ = SlimbvhTypeQ();
                    }
                    let _e2674 = phi_2948_;
                    continue;
                    continuing {
                        phi_2947_ = _e2674;
                        phi_2950_ = _e1448;
                        break if !(_e1454);
                    }
                }
                let _e2677 = local_3;
                let _e2678 = (_e2677 - 1u);
                let _e2681 = local[(_e2678 % 128u)];
                let _e2682 = (_e2681 & 511u);
                let _e2684 = (_e2682 >> bitcast<u32>(3u));
                let _e2687 = ((_e2684 == 0u) || (_e2678 == 4294967295u));
                if _e2687 {
                } else {
                    local[(_e2678 % 128u)] = (((_e2681 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2684);
                }
                let _e2694 = local_4;
                let _e2702 = (((_e2681 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2682 & 3u) & 3u));
                let _e2704 = (_e2702 >> bitcast<u32>(2i));
                if (_e2704 < _e109) {
                    let _e2710 = slimbvh_nodes.member[_e2704].member_1[(_e2702 & 3u)];
                    if ((_e2710 & 2147483648u) != 0u) {
                        phi_4846_ = (2147483648u | _e2702);
                    } else {
                        phi_4846_ = _e2710;
                    }
                    let _e2715 = phi_4846_;
                    phi_4847_ = _e2715;
                } else {
                    phi_4847_ = 4294967295u;
                }
                let _e2717 = phi_4847_;
                let _e2719 = local_5;
                let _e3018 = local_7;
                phi_4856_ = _e3018;
                phi_4857_ = select(select(_e2694, _e2678, _e2687), 4294967295u, (_e673 > _e2719.member.member_1));
                phi_4858_ = _e2717;
            } else {
                phi_4856_ = _e786;
                let _e3021 = local_8;
                phi_4857_ = _e3021;
                let _e3024 = local_9;
                phi_4858_ = _e3024;
            }
            let _e2725 = phi_4856_;
            let _e2727 = phi_4857_;
            let _e2729 = phi_4858_;
            phi_1845_ = _e2725;
            phi_1848_ = _e2727;
            phi_1850_ = _e2729;
            let _e3030 = local_10;
            phi_1852_ = _e3030;
        } else {
            phi_1845_ = SlimbvhTypeQ();
            phi_1848_ = u32();
            phi_1850_ = u32();
            phi_1852_ = u32();
        }
        let _e2731 = phi_1845_;
        let _e2733 = phi_1848_;
        let _e2735 = phi_1850_;
        let _e2737 = phi_1852_;
        continue;
        continuing {
            phi_1844_ = _e2731;
            phi_1847_ = _e2733;
            phi_1849_ = _e2735;
            phi_1851_ = _e2737;
            break if !(_e793);
        }
    }
    let _e2740 = local_6;
    if (_e2740.member.member.member_3 != 4294967295u) {
        let _e2746 = -((_e176 + _e606.member_4));
        let _e2747 = bitcast<u32>(_e2740.member.member.member);
        let _e2751 = (bitcast<i32>((_e2747 >> bitcast<u32>(23i))) & 255i);
        let _e2752 = (_e2751 + _e2746);
        if (_e2751 == 255i) {
            phi_4915_ = _e2740.member.member.member;
        } else {
            if (_e2751 > 0i) {
                if (_e2752 > 0i) {
                    let _e2756 = (_e2752 < 255i);
                    if _e2756 {
                        phi_4894_ = bitcast<f32>((_e2747 + bitcast<u32>((_e2746 << bitcast<u32>(23i)))));
                    } else {
                        phi_4894_ = f32();
                    }
                    let _e2763 = phi_4894_;
                    phi_4896_ = _e2763;
                    phi_4897_ = select(true, false, _e2756);
                } else {
                    phi_4896_ = f32();
                    phi_4897_ = true;
                }
                let _e2766 = phi_4896_;
                let _e2768 = phi_4897_;
                phi_4898_ = _e2766;
                phi_4899_ = _e2768;
            } else {
                phi_4898_ = f32();
                phi_4899_ = true;
            }
            let _e2770 = phi_4898_;
            let _e2772 = phi_4899_;
            if _e2772 {
                let _e2773 = (_e2747 & 2147483648u);
                let _e2780 = ((_e2747 & 8388607u) | (select(0u, 1u, ((_e2747 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e2784 = (_e2780 == 0u);
                if _e2784 {
                    phi_5575_ = bitcast<f32>(_e2773);
                } else {
                    let _e2789 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2780)), 32u, _e2784) - 8u);
                    let _e2792 = (_e2780 << bitcast<u32>((_e2789 & 31u)));
                    let _e2794 = ((_e2752 + select(0i, 1i, (_e2751 == 0i))) - bitcast<i32>(_e2789));
                    if (_e2794 >= 255i) {
                        phi_5565_ = bitcast<f32>((_e2773 | 2139095040u));
                        phi_5566_ = f32();
                        phi_5567_ = true;
                    } else {
                        let _e2796 = (_e2794 > 0i);
                        if _e2796 {
                            phi_5559_ = bitcast<f32>(((_e2773 | (bitcast<u32>(_e2794) << bitcast<u32>(23i))) | (_e2792 & 8388607u)));
                            phi_5560_ = f32();
                        } else {
                            if (_e2794 < -24i) {
                                phi_5525_ = 26u;
                            } else {
                                phi_5525_ = bitcast<u32>((1i - _e2794));
                            }
                            let _e2801 = phi_5525_;
                            let _e2802 = (_e2801 & 31u);
                            let _e2804 = (_e2792 >> bitcast<u32>(_e2802));
                            let _e2808 = (_e2792 & ((1u << bitcast<u32>(_e2802)) - 1u));
                            let _e2812 = (1u << bitcast<u32>(((_e2801 - 1u) & 31u)));
                            if (_e2808 > _e2812) {
                                phi_5546_ = true;
                            } else {
                                if (_e2808 == _e2812) {
                                    phi_5543_ = ((_e2804 & 1u) == 1u);
                                } else {
                                    phi_5543_ = false;
                                }
                                let _e2818 = phi_5543_;
                                phi_5546_ = _e2818;
                            }
                            let _e2820 = phi_5546_;
                            phi_5559_ = f32();
                            phi_5560_ = bitcast<f32>((_e2773 | (_e2804 + select(0u, 1u, _e2820))));
                        }
                        let _e2833 = phi_5559_;
                        let _e2835 = phi_5560_;
                        phi_5565_ = _e2833;
                        phi_5566_ = _e2835;
                        phi_5567_ = _e2796;
                    }
                    let _e2839 = phi_5565_;
                    let _e2841 = phi_5566_;
                    let _e2843 = phi_5567_;
                    phi_5575_ = select(_e2841, _e2839, _e2843);
                }
                let _e2847 = phi_5575_;
                phi_4914_ = _e2847;
            } else {
                phi_4914_ = _e2770;
            }
            let _e2849 = phi_4914_;
            phi_4915_ = _e2849;
        }
        let _e2851 = phi_4915_;
        let _e2852 = bitcast<u32>(_e2851);
        if ((_e2852 & 2147483647u) >= 2139095040u) {
            phi_4927_ = bitcast<f32>(((_e2852 & 2147483648u) | 2139095039u));
        } else {
            phi_4927_ = _e2851;
        }
        let _e2859 = phi_4927_;
        phi_4932_ = SlimbvhTypeF(_e2859, _e2740.member.member.member_1, _e2740.member.member.member_2, _e2740.member.member.member_3);
    } else {
        phi_4932_ = _e105;
    }
    let _e2864 = phi_4932_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2864.member), bitcast<u32>(_e2864.member_1), bitcast<u32>(_e2864.member_2), _e2864.member_3);
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
