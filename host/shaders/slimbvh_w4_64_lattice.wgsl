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
var<storage> slimbvh_sides: SlimbvhTypeC;

@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeK;

@group(0) @binding(2) 
var<storage> slimbvh_triangles: SlimbvhTypeC;

@group(0) @binding(3) 
var<uniform> slimbvh_root: SlimbvhTypeB;

@group(0) @binding(5) 
var<uniform> slimbvh_target: SlimbvhTypeB;

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
    var phi_1349_: SlimbvhTypeD;
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
    var phi_5246_: SlimbvhTypeE;
    var phi_5258_: SlimbvhTypeE;
    var phi_5270_: SlimbvhTypeE;
    var phi_5282_: SlimbvhTypeE;
    var phi_5294_: SlimbvhTypeE;
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
    var phi_2950_: SlimbvhTypeE;
    var phi_2951_: SlimbvhTypeE;
    var phi_2973_: SlimbvhTypeE;
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
    var phi_4205_: SlimbvhTypeF;
    var phi_4206_: SlimbvhTypeF;
    var phi_4209_: SlimbvhTypeF;
    var phi_4210_: SlimbvhTypeF;
    var phi_4211_: bool;
    var phi_4215_: SlimbvhTypeF;
    var phi_4224_: SlimbvhTypeG;
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
    var phi_4932_: SlimbvhTypeG;
    var local_7: SlimbvhTypeQ;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e105 = SlimbvhTypeG(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
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
        phi_1349_ = SlimbvhTypeD(array<f32, 3>((_e225 * _e530), (_e229 * _e530), (_e232 * _e530)), array<f32, 3>((_e234 * _e535), (_e236 * _e535), (_e238 * _e535)), bitcast<f32>(((_e183 & 2147483648u) | select(_e567, 0u, _e569))), bitcast<f32>(((_e191 & 2147483648u) | select(_e597, 0u, _e599))), _e524);
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
        phi_1349_ = SlimbvhTypeD(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e303 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e303 & 2147483648u))), _e225, _e305) * _e296) * select(0.00000011920929f, 1f, _e305)) * _e302), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e320 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e320 & 2147483648u))), _e229, _e322) * _e296) * select(0.00000011920929f, 1f, _e322)) * _e302), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e232, _e339) * _e296) * select(0.00000011920929f, 1f, _e339)) * _e302)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e372 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e372 & 2147483648u))), _e234, _e374) * _e365) * select(0.00000011920929f, 1f, _e374)) * _e371), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e389 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e389 & 2147483648u))), _e236, _e391) * _e365) * select(0.00000011920929f, 1f, _e391)) * _e371), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e406 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e406 & 2147483648u))), _e238, _e408) * _e365) * select(0.00000011920929f, 1f, _e408)) * _e371)), bitcast<f32>(((_e183 & 2147483648u) | select(_e465, 0u, _e467))), bitcast<f32>(((_e191 & 2147483648u) | select(_e513, 0u, _e515))), _e285);
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
                        phi_5246_ = SlimbvhTypeE(_e1162, _e1170);
                    } else {
                        phi_5246_ = SlimbvhTypeE(_e1170, _e1162);
                    }
                    let _e1191 = phi_5246_;
                    if (_e1178 < _e1186) {
                        phi_5258_ = SlimbvhTypeE(_e1178, _e1186);
                    } else {
                        phi_5258_ = SlimbvhTypeE(_e1186, _e1178);
                    }
                    let _e1198 = phi_5258_;
                    if (_e1191.member < _e1198.member) {
                        phi_5270_ = SlimbvhTypeE(_e1191.member, _e1198.member);
                    } else {
                        phi_5270_ = SlimbvhTypeE(_e1198.member, _e1191.member);
                    }
                    let _e1205 = phi_5270_;
                    if (_e1191.member_1 < _e1198.member_1) {
                        phi_5282_ = SlimbvhTypeE(_e1191.member_1, _e1198.member_1);
                    } else {
                        phi_5282_ = SlimbvhTypeE(_e1198.member_1, _e1191.member_1);
                    }
                    let _e1212 = phi_5282_;
                    if (_e1212.member < _e1205.member_1) {
                        phi_5294_ = SlimbvhTypeE(_e1212.member, _e1205.member_1);
                    } else {
                        phi_5294_ = SlimbvhTypeE(_e1205.member_1, _e1212.member);
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
                phi_2950_ = SlimbvhTypeE(0u, _e1429.member_2);
                loop {
                    let _e1433 = phi_2947_;
                    let _e1435 = phi_2950_;
                    local_5 = _e1433;
                    local_7 = _e1433;
                    if (_e1435.member < _e1435.member_1) {
                        phi_2951_ = SlimbvhTypeE((_e1435.member + 1u), _e1435.member_1);
                        phi_2973_ = SlimbvhTypeE(1u, _e1435.member);
                    } else {
                        phi_2951_ = _e1435;
                        phi_2973_ = SlimbvhTypeE(0u, SlimbvhTypeE().member_1);
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
                                phi_4205_ = SlimbvhTypeF(_e2250, (_e1931 * _e2251), (_e1935 * _e2251), ((_e2010 && (_e2250 >= _e673)) && (_e2250 <= _e1433.member.member_1)));
                                phi_4206_ = SlimbvhTypeF();
                            } else {
                                phi_4205_ = SlimbvhTypeF();
                                phi_4206_ = SlimbvhTypeF(0f, 0f, 0f, _e2010);
                            }
                            let _e2260 = phi_4205_;
                            let _e2262 = phi_4206_;
                            phi_4209_ = _e2260;
                            phi_4210_ = _e2262;
                            phi_4211_ = select(true, false, _e2010);
                        } else {
                            phi_4209_ = SlimbvhTypeF();
                            phi_4210_ = SlimbvhTypeF(0f, 0f, 0f, _e1921);
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
                            phi_4224_ = SlimbvhTypeG(_e2271.member, _e2271.member_1, _e2271.member_2, _e1474);
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
        phi_4932_ = SlimbvhTypeG(_e2859, _e2740.member.member.member_1, _e2740.member.member.member_2, _e2740.member.member.member_3);
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
