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
    member: array<vec4<f32>, 6>,
    member_1: array<u32, 4>,
    member_2: array<u32, 4>,
}

struct SlimbvhTypeD {
    member: array<SlimbvhTypeC>,
}

struct SlimbvhTypeE {
    member: array<array<vec4<f32>, 5>>,
}

struct SlimbvhTypeF {
    member: array<u32>,
}

struct SlimbvhTypeG {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
    member_2: f32,
    member_3: f32,
    member_4: i32,
}

struct SlimbvhTypeH {
    member: u32,
    member_1: u32,
}

struct SlimbvhTypeI {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct SlimbvhTypeJ {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct SlimbvhTypeK {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct SlimbvhTypeL {
    member: SlimbvhTypeJ,
    member_1: f32,
}

struct SlimbvhTypeM {
    member: vec4<f32>,
}

struct SlimbvhTypeN {
    member: vec2<u32>,
}

struct SlimbvhTypeO {
    member: SlimbvhTypeL,
    member_1: bool,
}

@group(0) @binding(0) 
var<uniform> slimbvh_exponent: SlimbvhTypeA;

@group(0) @binding(2) 
var<storage> slimbvh_triangles: SlimbvhTypeE;

@group(0) @binding(3) 
var<storage> slimbvh_sides: SlimbvhTypeF;

@group(0) @binding(4) 
var<uniform> slimbvh_target: SlimbvhTypeB;

var<private> slimbvh_origin: SlimbvhTypeM;

var<private> slimbvh_direction: SlimbvhTypeM;

var<private> slimbvh_question: SlimbvhTypeN;

var<private> slimbvh_hit: SlimbvhTypeA;

@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeD;

fn slimbvh_trace() {
    var local: array<u32, 128>;
    var phi_618_: u32;
    var phi_624_: u32;
    var phi_630_: u32;
    var phi_895_: i32;
    var phi_906_: i32;
    var phi_1020_: i32;
    var phi_1149_: i32;
    var phi_1171_: u32;
    var phi_1172_: u32;
    var phi_1173_: bool;
    var phi_1207_: i32;
    var phi_1229_: u32;
    var phi_1230_: u32;
    var phi_1231_: bool;
    var phi_792_: i32;
    var phi_798_: u32;
    var phi_817_: u32;
    var phi_818_: u32;
    var phi_819_: bool;
    var phi_837_: i32;
    var phi_843_: u32;
    var phi_862_: u32;
    var phi_863_: u32;
    var phi_864_: bool;
    var phi_1241_: SlimbvhTypeG;
    var phi_1480_: SlimbvhTypeO;
    var phi_1520_: SlimbvhTypeO;
    var phi_1523_: u32;
    var phi_1525_: u32;
    var phi_1527_: u32;
    var phi_1536_: u32;
    var phi_1539_: u32;
    var phi_1541_: u32;
    var phi_1978_: u32;
    var phi_1991_: u32;
    var phi_2004_: u32;
    var phi_2017_: u32;
    var phi_3740_: SlimbvhTypeH;
    var phi_3752_: SlimbvhTypeH;
    var phi_3764_: SlimbvhTypeH;
    var phi_3776_: SlimbvhTypeH;
    var phi_3788_: SlimbvhTypeH;
    var phi_2098_: u32;
    var phi_2103_: u32;
    var phi_2104_: u32;
    var phi_2125_: u32;
    var phi_1537_: u32;
    var phi_1540_: u32;
    var phi_1542_: u32;
    var local_1: bool;
    var local_2: u32;
    var local_3: u32;
    var phi_2141_: SlimbvhTypeO;
    var phi_2144_: SlimbvhTypeH;
    var phi_2145_: SlimbvhTypeH;
    var phi_2167_: SlimbvhTypeH;
    var phi_2246_: array<vec4<f32>, 3>;
    var phi_2247_: array<vec4<f32>, 3>;
    var phi_2327_: array<vec4<f32>, 3>;
    var phi_2328_: array<vec4<f32>, 3>;
    var phi_2351_: array<f32, 3>;
    var phi_2352_: array<f32, 3>;
    var phi_2366_: array<f32, 3>;
    var phi_2367_: array<f32, 3>;
    var phi_2381_: array<f32, 3>;
    var phi_2382_: array<f32, 3>;
    var phi_2741_: f32;
    var phi_2742_: f32;
    var phi_2743_: f32;
    var phi_2744_: f32;
    var phi_2745_: vec3<f32>;
    var phi_2746_: vec3<f32>;
    var phi_2747_: vec3<f32>;
    var phi_2748_: vec3<f32>;
    var phi_2927_: f32;
    var phi_2953_: SlimbvhTypeI;
    var phi_2954_: SlimbvhTypeI;
    var phi_2957_: SlimbvhTypeI;
    var phi_2958_: SlimbvhTypeI;
    var phi_2959_: bool;
    var phi_2963_: SlimbvhTypeI;
    var phi_2972_: SlimbvhTypeJ;
    var phi_3025_: i32;
    var phi_3165_: SlimbvhTypeK;
    var phi_3189_: u32;
    var phi_3217_: vec3<f32>;
    var phi_3218_: vec3<f32>;
    var phi_3235_: vec3<f32>;
    var phi_3236_: vec3<f32>;
    var phi_3253_: vec3<f32>;
    var phi_3254_: vec3<f32>;
    var phi_3290_: vec3<f32>;
    var phi_3472_: f32;
    var phi_3490_: bool;
    var phi_3491_: bool;
    var phi_3510_: bool;
    var phi_3511_: bool;
    var phi_3518_: SlimbvhTypeO;
    var phi_3524_: SlimbvhTypeO;
    var phi_3525_: SlimbvhTypeO;
    var phi_3526_: SlimbvhTypeO;
    var phi_2142_: SlimbvhTypeO;
    var local_4: u32;
    var local_5: u32;
    var phi_3582_: u32;
    var local_6: SlimbvhTypeO;
    var phi_3591_: SlimbvhTypeO;
    var phi_3592_: u32;
    var phi_3593_: u32;
    var phi_1521_: SlimbvhTypeO;
    var phi_1524_: u32;
    var phi_1526_: u32;
    var phi_1528_: u32;
    var local_7: SlimbvhTypeO;
    var phi_3629_: f32;
    var phi_3631_: f32;
    var phi_3632_: bool;
    var phi_3633_: f32;
    var phi_3634_: bool;
    var phi_4019_: u32;
    var phi_4037_: bool;
    var phi_4040_: bool;
    var phi_4053_: f32;
    var phi_4054_: f32;
    var phi_4059_: f32;
    var phi_4060_: f32;
    var phi_4061_: bool;
    var phi_4069_: f32;
    var phi_3649_: f32;
    var phi_3650_: f32;
    var phi_3662_: f32;
    var phi_3667_: SlimbvhTypeJ;
    var local_8: SlimbvhTypeO;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e89 = SlimbvhTypeJ(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e92 = arrayLength((&slimbvh_nodes.member));
    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    let _e101 = slimbvh_origin.member;
    let _e107 = slimbvh_origin.member[3u];
    let _e108 = slimbvh_direction.member;
    let _e114 = slimbvh_direction.member[3u];
    let _e117 = slimbvh_exponent.member[0u];
    let _e118 = bitcast<i32>(_e117);
    let _e120 = (bitcast<u32>(_e101.x) & 2147483647u);
    let _e122 = (bitcast<u32>(_e101.y) & 2147483647u);
    let _e124 = (bitcast<u32>(_e101.z) & 2147483647u);
    let _e125 = bitcast<u32>(_e107);
    let _e126 = (_e125 & 2147483647u);
    let _e128 = (bitcast<u32>(_e108.x) & 2147483647u);
    let _e130 = (bitcast<u32>(_e108.y) & 2147483647u);
    let _e132 = (bitcast<u32>(_e108.z) & 2147483647u);
    let _e133 = bitcast<u32>(_e114);
    let _e134 = (_e133 & 2147483647u);
    let _e136 = select(_e130, _e128, (_e130 < _e128));
    let _e138 = select(_e132, _e136, (_e132 < _e136));
    let _e140 = select(_e120, _e138, (_e120 < _e138));
    let _e142 = select(_e122, _e140, (_e122 < _e140));
    let _e144 = select(_e124, _e142, (_e124 < _e142));
    let _e151 = (((select(_e126, _e144, (_e126 < _e144)) < 2139095040u) && (_e134 <= 2139095040u)) && (_e138 > 0u));
    if (_e128 == _e138) {
        phi_618_ = 0u;
    } else {
        phi_618_ = select(2u, 1u, (_e130 == _e138));
    }
    let _e156 = phi_618_;
    let _e157 = (_e156 == 2u);
    if _e157 {
        phi_624_ = 0u;
    } else {
        phi_624_ = (_e156 + 1u);
    }
    let _e160 = phi_624_;
    let _e161 = (_e160 == 2u);
    if _e161 {
        phi_630_ = 0u;
    } else {
        phi_630_ = (_e160 + 1u);
    }
    let _e164 = phi_630_;
    let _e165 = (_e160 == 0u);
    let _e167 = select(select(_e101.y, _e101.x, _e165), _e101.z, _e161);
    let _e168 = (_e164 == 0u);
    let _e170 = (_e164 == 2u);
    let _e171 = select(select(_e101.y, _e101.x, _e168), _e101.z, _e170);
    let _e172 = (_e156 == 0u);
    let _e174 = select(select(_e101.y, _e101.x, _e172), _e101.z, _e157);
    let _e176 = select(select(_e108.y, _e108.x, _e165), _e108.z, _e161);
    let _e178 = select(select(_e108.y, _e108.x, _e168), _e108.z, _e170);
    let _e180 = select(select(_e108.y, _e108.x, _e172), _e108.z, _e157);
    let _e181 = (_e126 - 1u);
    let _e182 = (_e134 - 1u);
    let _e184 = select(_e181, _e182, (_e182 < _e181));
    let _e185 = (_e120 - 1u);
    let _e186 = (_e122 - 1u);
    let _e188 = select(_e185, _e186, (_e186 < _e185));
    let _e189 = (_e124 - 1u);
    let _e191 = select(_e188, _e189, (_e189 < _e188));
    let _e192 = (_e128 - 1u);
    let _e193 = (_e130 - 1u);
    let _e195 = select(_e192, _e193, (_e193 < _e192));
    let _e196 = (_e132 - 1u);
    let _e198 = select(_e195, _e196, (_e196 < _e195));
    let _e200 = select(_e191, _e198, (_e198 < _e191));
    if (((select(_e200, _e184, (_e184 < _e200)) >= 8388607u) && (_e138 < 2130706432u)) && (bitcast<u32>((_e118 + 126i)) <= 253u)) {
        let _e465 = bitcast<i32>((_e138 >> bitcast<u32>(23i)));
        let _e466 = (_e465 - 127i);
        let _e467 = (_e118 + _e466);
        let _e472 = bitcast<f32>((bitcast<u32>((_e118 + 127i)) << bitcast<u32>(23i)));
        let _e477 = bitcast<f32>((bitcast<u32>((254i - _e465)) << bitcast<u32>(23i)));
        if (_e126 >= 2139095040u) {
            phi_792_ = 255i;
        } else {
            phi_792_ = (bitcast<i32>((_e126 >> bitcast<u32>(23i))) + _e467);
        }
        let _e492 = phi_792_;
        if (_e126 == 0u) {
            phi_798_ = 0u;
        } else {
            phi_798_ = (_e126 | 8388608u);
        }
        let _e496 = phi_798_;
        if (_e492 <= 0i) {
            phi_818_ = u32();
            phi_819_ = true;
        } else {
            let _e503 = (_e496 == 0u);
            if _e503 {
                phi_817_ = u32();
            } else {
                phi_817_ = select(((bitcast<u32>(_e492) << bitcast<u32>(23i)) | (_e496 & 8388607u)), 2139095039u, (_e492 >= 255i));
            }
            let _e507 = phi_817_;
            phi_818_ = _e507;
            phi_819_ = _e503;
        }
        let _e509 = phi_818_;
        let _e511 = phi_819_;
        if (_e134 >= 2139095040u) {
            phi_837_ = 255i;
        } else {
            phi_837_ = (bitcast<i32>((_e134 >> bitcast<u32>(23i))) + _e467);
        }
        let _e522 = phi_837_;
        if (_e134 == 0u) {
            phi_843_ = 0u;
        } else {
            phi_843_ = (_e134 | 8388608u);
        }
        let _e526 = phi_843_;
        if (_e522 <= 0i) {
            phi_863_ = u32();
            phi_864_ = true;
        } else {
            let _e533 = (_e526 == 0u);
            if _e533 {
                phi_862_ = u32();
            } else {
                phi_862_ = select(((bitcast<u32>(_e522) << bitcast<u32>(23i)) | (_e526 & 8388607u)), 2139095039u, (_e522 >= 255i));
            }
            let _e537 = phi_862_;
            phi_863_ = _e537;
            phi_864_ = _e533;
        }
        let _e539 = phi_863_;
        let _e541 = phi_864_;
        phi_1241_ = SlimbvhTypeG(array<f32, 3>((_e167 * _e472), (_e171 * _e472), (_e174 * _e472)), array<f32, 3>((_e176 * _e477), (_e178 * _e477), (_e180 * _e477)), bitcast<f32>(((_e125 & 2147483648u) | select(_e509, 0u, _e511))), bitcast<f32>(((_e133 & 2147483648u) | select(_e539, 0u, _e541))), _e466);
    } else {
        let _e213 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e138, _e151))) & 2147483647u);
        if (_e213 >= 8388608u) {
            phi_895_ = (bitcast<i32>((_e213 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_895_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e213)), 32u, (_e213 == 0u))));
        }
        let _e227 = phi_895_;
        let _e228 = (_e118 + _e227);
        if (_e118 < -126i) {
            phi_906_ = -126i;
        } else {
            phi_906_ = select(_e118, 127i, (_e118 > 127i));
        }
        let _e233 = phi_906_;
        let _e238 = bitcast<f32>((bitcast<u32>((_e233 + 127i)) << bitcast<u32>(23i)));
        let _e244 = bitcast<f32>((bitcast<u32>(((_e118 - _e233) + 127i)) << bitcast<u32>(23i)));
        let _e245 = bitcast<u32>(_e167);
        let _e247 = ((_e245 & 2139095040u) != 0u);
        let _e262 = bitcast<u32>(_e171);
        let _e264 = ((_e262 & 2139095040u) != 0u);
        let _e279 = bitcast<u32>(_e174);
        let _e281 = ((_e279 & 2139095040u) != 0u);
        let _e297 = -(_e227);
        if (_e297 < -126i) {
            phi_1020_ = -126i;
        } else {
            phi_1020_ = select(_e297, 127i, (_e297 > 127i));
        }
        let _e302 = phi_1020_;
        let _e307 = bitcast<f32>((bitcast<u32>((_e302 + 127i)) << bitcast<u32>(23i)));
        let _e313 = bitcast<f32>((bitcast<u32>(((_e297 - _e302) + 127i)) << bitcast<u32>(23i)));
        let _e314 = bitcast<u32>(_e176);
        let _e316 = ((_e314 & 2139095040u) != 0u);
        let _e331 = bitcast<u32>(_e178);
        let _e333 = ((_e331 & 2139095040u) != 0u);
        let _e348 = bitcast<u32>(_e180);
        let _e350 = ((_e348 & 2139095040u) != 0u);
        let _e372 = ((_e126 & 8388607u) | (select(0u, 1u, ((_e126 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e375 = bitcast<i32>((_e126 >> bitcast<u32>(23i)));
        let _e382 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e372)), 32u, (_e372 == 0u))) - 8i);
        if (_e375 == 255i) {
            phi_1149_ = 255i;
        } else {
            phi_1149_ = (((_e375 + select(0i, 1i, (_e375 == 0i))) - _e382) + _e228);
        }
        let _e390 = phi_1149_;
        let _e394 = (_e372 << bitcast<u32>(((_e382 & 31i) & 31i)));
        if (_e390 <= 0i) {
            phi_1172_ = u32();
            phi_1173_ = true;
        } else {
            let _e401 = (_e394 == 0u);
            if _e401 {
                phi_1171_ = u32();
            } else {
                phi_1171_ = select(((bitcast<u32>(_e390) << bitcast<u32>(23i)) | (_e394 & 8388607u)), 2139095039u, (_e390 >= 255i));
            }
            let _e405 = phi_1171_;
            phi_1172_ = _e405;
            phi_1173_ = _e401;
        }
        let _e407 = phi_1172_;
        let _e409 = phi_1173_;
        let _e420 = ((_e134 & 8388607u) | (select(0u, 1u, ((_e134 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e423 = bitcast<i32>((_e134 >> bitcast<u32>(23i)));
        let _e430 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e420)), 32u, (_e420 == 0u))) - 8i);
        if (_e423 == 255i) {
            phi_1207_ = 255i;
        } else {
            phi_1207_ = (((_e423 + select(0i, 1i, (_e423 == 0i))) - _e430) + _e228);
        }
        let _e438 = phi_1207_;
        let _e442 = (_e420 << bitcast<u32>(((_e430 & 31i) & 31i)));
        if (_e438 <= 0i) {
            phi_1230_ = u32();
            phi_1231_ = true;
        } else {
            let _e449 = (_e442 == 0u);
            if _e449 {
                phi_1229_ = u32();
            } else {
                phi_1229_ = select(((bitcast<u32>(_e438) << bitcast<u32>(23i)) | (_e442 & 8388607u)), 2139095039u, (_e438 >= 255i));
            }
            let _e453 = phi_1229_;
            phi_1230_ = _e453;
            phi_1231_ = _e449;
        }
        let _e455 = phi_1230_;
        let _e457 = phi_1231_;
        phi_1241_ = SlimbvhTypeG(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e245 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e245 & 2147483648u))), _e167, _e247) * _e238) * select(0.00000011920929f, 1f, _e247)) * _e244), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e262 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e262 & 2147483648u))), _e171, _e264) * _e238) * select(0.00000011920929f, 1f, _e264)) * _e244), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e279 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e279 & 2147483648u))), _e174, _e281) * _e238) * select(0.00000011920929f, 1f, _e281)) * _e244)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e314 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e314 & 2147483648u))), _e176, _e316) * _e307) * select(0.00000011920929f, 1f, _e316)) * _e313), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e331 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e331 & 2147483648u))), _e178, _e333) * _e307) * select(0.00000011920929f, 1f, _e333)) * _e313), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e348 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e348 & 2147483648u))), _e180, _e350) * _e307) * select(0.00000011920929f, 1f, _e350)) * _e313)), bitcast<f32>(((_e125 & 2147483648u) | select(_e407, 0u, _e409))), bitcast<f32>(((_e133 & 2147483648u) | select(_e455, 0u, _e457))), _e227);
    }
    let _e548 = phi_1241_;
    let _e563 = (bitcast<f32>((bitcast<u32>(_e548.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e566 = bitcast<f32>((bitcast<u32>(_e548.member[0]) & 2147483647u));
    let _e567 = (_e566 * 0.00000011920929f);
    let _e570 = select(select(0.00000000000011368684f, _e567, (_e567 > 0.00000000000011368684f)), 0f, _e563);
    let _e571 = select(0f, _e548.member_1[0], _e563);
    let _e572 = (_e548.member[0] + _e570);
    let _e573 = (_e548.member[0] - _e570);
    let _e575 = select(38685626000000000000000000f, (1f / _e548.member_1[0]), _e563);
    let _e579 = (bitcast<f32>((bitcast<u32>(_e548.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e582 = bitcast<f32>((bitcast<u32>(_e548.member[1]) & 2147483647u));
    let _e583 = (_e582 * 0.00000011920929f);
    let _e586 = select(select(0.00000000000011368684f, _e583, (_e583 > 0.00000000000011368684f)), 0f, _e579);
    let _e587 = select(0f, _e548.member_1[1], _e579);
    let _e588 = (_e548.member[1] + _e586);
    let _e589 = (_e548.member[1] - _e586);
    let _e591 = select(38685626000000000000000000f, (1f / _e548.member_1[1]), _e579);
    let _e595 = (bitcast<f32>((bitcast<u32>(_e548.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e598 = bitcast<f32>((bitcast<u32>(_e548.member[2]) & 2147483647u));
    let _e599 = (_e598 * 0.00000011920929f);
    let _e602 = select(select(0.00000000000011368684f, _e599, (_e599 > 0.00000000000011368684f)), 0f, _e595);
    let _e603 = select(0f, _e548.member_1[2], _e595);
    let _e604 = (_e548.member[2] + _e602);
    let _e605 = (_e548.member[2] - _e602);
    let _e607 = select(38685626000000000000000000f, (1f / _e548.member_1[2]), _e595);
    let _e609 = select(_e582, _e566, (_e566 > _e582));
    let _e613 = (_e151 && (select(_e598, _e609, (_e609 > _e598)) <= 1099511600000f));
    let _e614 = select(0f, _e548.member_3, _e613);
    let _e615 = select(1f, _e548.member_2, _e613);
    let _e619 = slimbvh_question.member[1u];
    let _e622 = slimbvh_question.member[0u];
    if (_e622 == 1u) {
        phi_1480_ = SlimbvhTypeO(SlimbvhTypeL(_e89, _e614), true);
    } else {
        phi_1480_ = SlimbvhTypeO(SlimbvhTypeL(_e89, _e614), false);
    }
    let _e629 = phi_1480_;
    phi_1520_ = _e629;
    phi_1523_ = select(4294967295u, 0u, (_e615 <= _e614));
    phi_1525_ = 0u;
    phi_1527_ = (_e92 + 1u);
    loop {
        let _e647 = phi_1520_;
        let _e649 = phi_1523_;
        let _e651 = phi_1525_;
        let _e653 = phi_1527_;
        local_7 = _e647;
        let _e654 = (_e649 <= 2147483647u);
        if _e654 {
            phi_1536_ = _e649;
            phi_1539_ = _e651;
            phi_1541_ = _e653;
            loop {
                let _e656 = phi_1536_;
                let _e658 = phi_1539_;
                let _e660 = phi_1541_;
                local_2 = _e658;
                local_3 = _e658;
                local_4 = _e656;
                local_5 = _e656;
                local_9 = _e656;
                local_10 = _e658;
                local_11 = _e660;
                let _e661 = (_e656 <= 2147483647u);
                let _e664 = (_e661 && !((_e658 >= _e92)));
                local_1 = _e661;
                if _e664 {
                    let _e666 = ((2u * (_e160 & 3u)) + (bitcast<u32>(_e575) >> bitcast<u32>(31i)));
                    let _e668 = ((2u * (_e164 & 3u)) + (bitcast<u32>(_e591) >> bitcast<u32>(31i)));
                    let _e670 = ((2u * (_e156 & 3u)) + (bitcast<u32>(_e607) >> bitcast<u32>(31i)));
                    let _e677 = slimbvh_nodes.member[_e658].member[select(_e666, 5u, (5u < _e666))];
                    let _e684 = slimbvh_nodes.member[_e658].member[select(_e668, 5u, (5u < _e668))];
                    let _e691 = slimbvh_nodes.member[_e658].member[select(_e670, 5u, (5u < _e670))];
                    let _e692 = (_e666 ^ 1u);
                    let _e699 = slimbvh_nodes.member[_e658].member[select(_e692, 5u, (5u < _e692))];
                    let _e700 = (_e668 ^ 1u);
                    let _e707 = slimbvh_nodes.member[_e658].member[select(_e700, 5u, (5u < _e700))];
                    let _e708 = (_e670 ^ 1u);
                    let _e715 = slimbvh_nodes.member[_e658].member[select(_e708, 5u, (5u < _e708))];
                    let _e774 = ((_e691.x - _e604) * _e607);
                    let _e775 = ((_e691.y - _e604) * _e607);
                    let _e776 = ((_e691.z - _e604) * _e607);
                    let _e777 = ((_e691.w - _e604) * _e607);
                    let _e786 = ((_e715.x - _e605) * _e607);
                    let _e787 = ((_e715.y - _e605) * _e607);
                    let _e788 = ((_e715.z - _e605) * _e607);
                    let _e789 = ((_e715.w - _e605) * _e607);
                    let _e822 = max(max(max(((_e677.x - _e572) * _e575), ((_e684.x - _e588) * _e591)), _e774), _e615);
                    let _e823 = max(max(max(((_e677.y - _e572) * _e575), ((_e684.y - _e588) * _e591)), _e775), _e615);
                    let _e824 = max(max(max(((_e677.z - _e572) * _e575), ((_e684.z - _e588) * _e591)), _e776), _e615);
                    let _e825 = max(max(max(((_e677.w - _e572) * _e575), ((_e684.w - _e588) * _e591)), _e777), _e615);
                    if (_e822 <= min((min(min(((_e699.x - _e573) * _e575), ((_e707.x - _e589) * _e591)), _e786) + (max(_e786, -(_e774)) * 0.0000019073523f)), _e647.member.member_1)) {
                        phi_1978_ = (((bitcast<u32>(_e822) ^ select(0u, 4294967288u, _e629.member_1)) & 2147483640u) | 4u);
                    } else {
                        phi_1978_ = 4294967288u;
                    }
                    let _e840 = phi_1978_;
                    if (_e823 <= min((min(min(((_e699.y - _e573) * _e575), ((_e707.y - _e589) * _e591)), _e787) + (max(_e787, -(_e775)) * 0.0000019073523f)), _e647.member.member_1)) {
                        phi_1991_ = ((((bitcast<u32>(_e823) ^ select(0u, 4294967288u, _e629.member_1)) & 2147483640u) | 4u) | 1u);
                    } else {
                        phi_1991_ = 4294967288u;
                    }
                    let _e848 = phi_1991_;
                    if (_e824 <= min((min(min(((_e699.z - _e573) * _e575), ((_e707.z - _e589) * _e591)), _e788) + (max(_e788, -(_e776)) * 0.0000019073523f)), _e647.member.member_1)) {
                        phi_2004_ = ((((bitcast<u32>(_e824) ^ select(0u, 4294967288u, _e629.member_1)) & 2147483640u) | 4u) | 2u);
                    } else {
                        phi_2004_ = 4294967288u;
                    }
                    let _e856 = phi_2004_;
                    if (_e825 <= min((min(min(((_e699.w - _e573) * _e575), ((_e707.w - _e589) * _e591)), _e789) + (max(_e789, -(_e777)) * 0.0000019073523f)), _e647.member.member_1)) {
                        phi_2017_ = ((((bitcast<u32>(_e825) ^ select(0u, 4294967288u, _e629.member_1)) & 2147483640u) | 4u) | 3u);
                    } else {
                        phi_2017_ = 4294967288u;
                    }
                    let _e864 = phi_2017_;
                    if (_e840 < _e848) {
                        phi_3740_ = SlimbvhTypeH(_e840, _e848);
                    } else {
                        phi_3740_ = SlimbvhTypeH(_e848, _e840);
                    }
                    let _e869 = phi_3740_;
                    if (_e856 < _e864) {
                        phi_3752_ = SlimbvhTypeH(_e856, _e864);
                    } else {
                        phi_3752_ = SlimbvhTypeH(_e864, _e856);
                    }
                    let _e876 = phi_3752_;
                    if (_e869.member < _e876.member) {
                        phi_3764_ = SlimbvhTypeH(_e869.member, _e876.member);
                    } else {
                        phi_3764_ = SlimbvhTypeH(_e876.member, _e869.member);
                    }
                    let _e883 = phi_3764_;
                    if (_e869.member_1 < _e876.member_1) {
                        phi_3776_ = SlimbvhTypeH(_e869.member_1, _e876.member_1);
                    } else {
                        phi_3776_ = SlimbvhTypeH(_e876.member_1, _e869.member_1);
                    }
                    let _e890 = phi_3776_;
                    if (_e890.member < _e883.member_1) {
                        phi_3788_ = SlimbvhTypeH(_e890.member, _e883.member_1);
                    } else {
                        phi_3788_ = SlimbvhTypeH(_e883.member_1, _e890.member);
                    }
                    let _e897 = phi_3788_;
                    let _e912 = (((_e883.member & 7u) | ((_e897.member & 7u) << bitcast<u32>(3u))) | (((_e897.member_1 & 7u) | ((_e890.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                    if (_e912 == 0u) {
                        let _e930 = (_e656 - 1u);
                        let _e933 = local[(_e930 % 128u)];
                        let _e934 = (_e933 & 511u);
                        let _e936 = (_e934 >> bitcast<u32>(3u));
                        let _e939 = ((_e936 == 0u) || (_e930 == 4294967295u));
                        if _e939 {
                        } else {
                            local[(_e930 % 128u)] = (((_e933 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e936);
                        }
                        phi_2103_ = select(_e656, _e930, _e939);
                        phi_2104_ = (((_e933 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e934 & 3u) & 3u));
                    } else {
                        let _e915 = (_e912 >> bitcast<u32>(3u));
                        if (_e915 == 0u) {
                            phi_2098_ = _e656;
                        } else {
                            local[(_e656 % 128u)] = ((_e658 << bitcast<u32>(9u)) | _e915);
                            phi_2098_ = (_e656 + 1u);
                        }
                        let _e924 = phi_2098_;
                        phi_2103_ = _e924;
                        phi_2104_ = ((_e658 << bitcast<u32>(2i)) | ((_e912 & 3u) & 3u));
                    }
                    let _e954 = phi_2103_;
                    let _e956 = phi_2104_;
                    let _e958 = (_e956 >> bitcast<u32>(2i));
                    if (_e958 < _e92) {
                        let _e965 = slimbvh_nodes.member[_e958].member_1[(_e956 & 3u)];
                        phi_2125_ = _e965;
                    } else {
                        phi_2125_ = 2147483648u;
                    }
                    let _e967 = phi_2125_;
                    let _e968 = (_e660 - 1u);
                    phi_1537_ = select(_e954, 4294967295u, (_e968 == 0u));
                    phi_1540_ = _e967;
                    phi_1542_ = _e968;
                } else {
                    phi_1537_ = u32();
                    phi_1540_ = u32();
                    phi_1542_ = u32();
                }
                let _e972 = phi_1537_;
                let _e974 = phi_1540_;
                let _e976 = phi_1542_;
                continue;
                continuing {
                    phi_1536_ = _e972;
                    phi_1539_ = _e974;
                    phi_1541_ = _e976;
                    break if !(_e664);
                }
            }
            let _e979 = local_1;
            if _e979 {
                let _e981 = local_2;
                let _e984 = local_3;
                phi_2141_ = _e647;
                phi_2144_ = SlimbvhTypeH(0u, ((_e984 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e990 = phi_2141_;
                    let _e992 = phi_2144_;
                    local_6 = _e990;
                    local_8 = _e990;
                    if (_e992.member < _e992.member_1) {
                        phi_2145_ = SlimbvhTypeH((_e992.member + 1u), _e992.member_1);
                        phi_2167_ = SlimbvhTypeH(1u, _e992.member);
                    } else {
                        phi_2145_ = _e992;
                        phi_2167_ = SlimbvhTypeH(0u, SlimbvhTypeH().member_1);
                    }
                    let _e1005 = phi_2145_;
                    let _e1007 = phi_2167_;
                    let _e1011 = (bitcast<i32>(_e1007.member) != 0i);
                    if _e1011 {
                        let _e1012 = ((_e981 & 268435455u) + _e1007.member_1);
                        let _e1013 = (_e1012 / 2u);
                        let _e1014 = (_e1012 % 2u);
                        let _e1015 = (_e1013 >= arrayLength((&slimbvh_triangles.member)));
                        if _e1015 {
                            phi_2247_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e1016 = (2u * _e1014);
                            let _e1020 = slimbvh_triangles.member[_e1013][_e1016];
                            let _e1025 = slimbvh_triangles.member[_e1013][(_e1016 + 1u)];
                            let _e1030 = slimbvh_triangles.member[_e1013][(_e1016 + 2u)];
                            if (_e1014 == 0u) {
                                phi_2246_ = array<vec4<f32>, 3>(_e1020, _e1025, _e1030);
                            } else {
                                phi_2246_ = array<vec4<f32>, 3>(vec4<f32>(_e1020.z, _e1020.w, _e1025.x, _e1025.y), vec4<f32>(_e1025.z, _e1025.w, _e1030.x, _e1030.y), vec4<f32>(_e1030.z, _e1030.w, 0f, 0f));
                            }
                            let _e1048 = phi_2246_;
                            phi_2247_ = _e1048;
                        }
                        let _e1050 = phi_2247_;
                        let _e1053 = bitcast<u32>(_e1050[2].y);
                        if _e1015 {
                            phi_2328_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e1054 = (2u * _e1014);
                            let _e1058 = slimbvh_triangles.member[_e1013][_e1054];
                            let _e1063 = slimbvh_triangles.member[_e1013][(_e1054 + 1u)];
                            let _e1068 = slimbvh_triangles.member[_e1013][(_e1054 + 2u)];
                            if (_e1014 == 0u) {
                                phi_2327_ = array<vec4<f32>, 3>(_e1058, _e1063, _e1068);
                            } else {
                                phi_2327_ = array<vec4<f32>, 3>(vec4<f32>(_e1058.z, _e1058.w, _e1063.x, _e1063.y), vec4<f32>(_e1063.z, _e1063.w, _e1068.x, _e1068.y), vec4<f32>(_e1068.z, _e1068.w, 0f, 0f));
                            }
                            let _e1086 = phi_2327_;
                            phi_2328_ = _e1086;
                        }
                        let _e1088 = phi_2328_;
                        if _e165 {
                            phi_2352_ = array<f32, 3>(_e1088[0].x, _e1088[0].y, _e1088[0].z);
                        } else {
                            if (_e160 == 1u) {
                                phi_2351_ = array<f32, 3>(_e1088[0].y, _e1088[0].z, _e1088[0].x);
                            } else {
                                phi_2351_ = array<f32, 3>(_e1088[0].z, _e1088[0].x, _e1088[0].y);
                            }
                            let _e1111 = phi_2351_;
                            phi_2352_ = _e1111;
                        }
                        let _e1114 = phi_2352_;
                        if _e165 {
                            phi_2367_ = array<f32, 3>(_e1088[0].w, _e1088[1].x, _e1088[1].y);
                        } else {
                            if (_e160 == 1u) {
                                phi_2366_ = array<f32, 3>(_e1088[1].x, _e1088[1].y, _e1088[0].w);
                            } else {
                                phi_2366_ = array<f32, 3>(_e1088[1].y, _e1088[0].w, _e1088[1].x);
                            }
                            let _e1119 = phi_2366_;
                            phi_2367_ = _e1119;
                        }
                        let _e1122 = phi_2367_;
                        if _e165 {
                            phi_2382_ = array<f32, 3>(_e1088[1].z, _e1088[1].w, _e1088[2].x);
                        } else {
                            if (_e160 == 1u) {
                                phi_2381_ = array<f32, 3>(_e1088[1].w, _e1088[2].x, _e1088[1].z);
                            } else {
                                phi_2381_ = array<f32, 3>(_e1088[2].x, _e1088[1].z, _e1088[1].w);
                            }
                            let _e1127 = phi_2381_;
                            phi_2382_ = _e1127;
                        }
                        let _e1130 = phi_2382_;
                        let _e1144 = (_e1114[2] - _e548.member[2]);
                        let _e1147 = (((_e1114[0] - _e548.member[0]) * _e603) - (_e1144 * _e571));
                        let _e1150 = (((_e1114[1] - _e548.member[1]) * _e603) - (_e1144 * _e587));
                        let _e1153 = (_e1122[2] - _e548.member[2]);
                        let _e1156 = (((_e1122[0] - _e548.member[0]) * _e603) - (_e1153 * _e571));
                        let _e1159 = (((_e1122[1] - _e548.member[1]) * _e603) - (_e1153 * _e587));
                        let _e1162 = (_e1130[2] - _e548.member[2]);
                        let _e1165 = (((_e1130[0] - _e548.member[0]) * _e603) - (_e1162 * _e571));
                        let _e1168 = (((_e1130[1] - _e548.member[1]) * _e603) - (_e1162 * _e587));
                        let _e1169 = (_e1165 * _e1159);
                        let _e1170 = (_e1168 * _e1156);
                        let _e1171 = (_e1147 * _e1168);
                        let _e1172 = (_e1150 * _e1165);
                        let _e1173 = (_e1156 * _e1150);
                        let _e1174 = (_e1159 * _e1147);
                        let _e1179 = (((_e1169 >= _e1170) && (_e1171 >= _e1172)) && (_e1173 >= _e1174));
                        let _e1185 = (_e1179 || (((_e1169 <= _e1170) && (_e1171 <= _e1172)) && (_e1173 <= _e1174)));
                        if _e1185 {
                            let _e1187 = select(-1f, 1f, _e1179);
                            let _e1189 = ((_e1169 - _e1170) * _e1187);
                            let _e1191 = select(0f, _e1189, (_e1189 > 0f));
                            let _e1193 = ((_e1171 - _e1172) * _e1187);
                            let _e1195 = select(0f, _e1193, (_e1193 > 0f));
                            let _e1197 = ((_e1173 - _e1174) * _e1187);
                            let _e1199 = select(0f, _e1197, (_e1197 > 0f));
                            let _e1201 = ((_e1191 + _e1195) + _e1199);
                            let _e1216 = ((min(min(_e1114[0], _e1122[0]), _e1130[0]) - _e572) * _e575);
                            let _e1217 = ((max(max(_e1114[0], _e1122[0]), _e1130[0]) - _e573) * _e575);
                            let _e1218 = vec4<f32>(_e1216, f32(), _e1217, f32());
                            let _e1221 = ((min(min(_e1114[1], _e1122[1]), _e1130[1]) - _e588) * _e591);
                            let _e1222 = ((max(max(_e1114[1], _e1122[1]), _e1130[1]) - _e589) * _e591);
                            let _e1223 = vec4<f32>(_e1221, f32(), _e1222, f32());
                            let _e1226 = ((min(min(_e1114[2], _e1122[2]), _e1130[2]) - _e604) * _e607);
                            let _e1227 = ((max(max(_e1114[2], _e1122[2]), _e1130[2]) - _e605) * _e607);
                            let _e1228 = vec4<f32>(_e1226, f32(), _e1227, f32());
                            let _e1229 = vec4<f32>(_e1217, f32(), _e1216, f32());
                            let _e1231 = vec4<f32>(_e1222, f32(), _e1221, f32());
                            let _e1233 = vec4<f32>(_e1227, f32(), _e1226, f32());
                            let _e1242 = max(max(min(_e1218, _e1229).x, min(_e1223, _e1231).x), min(_e1228, _e1233).x);
                            let _e1247 = min(min(max(_e1218, _e1229).x, max(_e1223, _e1231).x), max(_e1228, _e1233).x);
                            let _e1252 = max(_e1242, _e615);
                            let _e1274 = (((((_e1185 && (_e1201 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1147, _e1156), _e1165) <= 0f) && (max(max(_e1147, _e1156), _e1165) >= 0f))) && ((min(min(_e1150, _e1159), _e1168) <= 0f) && (max(max(_e1150, _e1159), _e1168) >= 0f))) && (_e1252 <= (_e1247 + (max(max(_e1228, _e1233).x, -(min(_e1228, _e1233).x)) * 0.0000019073523f)))) && (_e1252 <= _e990.member.member_1));
                            if _e1274 {
                                let _e1279 = (_e1122[0] - _e1114[0]);
                                let _e1280 = (_e1122[1] - _e1114[1]);
                                let _e1281 = (_e1122[2] - _e1114[2]);
                                let _e1282 = vec3<f32>(_e1279, _e1280, _e1281);
                                let _e1283 = (_e1130[0] - _e1122[0]);
                                let _e1284 = (_e1130[1] - _e1122[1]);
                                let _e1285 = (_e1130[2] - _e1122[2]);
                                let _e1286 = vec3<f32>(_e1283, _e1284, _e1285);
                                let _e1287 = (_e1114[0] - _e1130[0]);
                                let _e1288 = (_e1114[1] - _e1130[1]);
                                let _e1289 = (_e1114[2] - _e1130[2]);
                                let _e1290 = vec3<f32>(_e1287, _e1288, _e1289);
                                let _e1301 = max(max(bitcast<f32>((bitcast<u32>(_e1279) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1280) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1281) & 2147483647u)));
                                let _e1312 = max(max(bitcast<f32>((bitcast<u32>(_e1283) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1284) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1285) & 2147483647u)));
                                let _e1325 = max(max(_e1301, _e1312), max(max(bitcast<f32>((bitcast<u32>(_e1287) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1288) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1289) & 2147483647u))));
                                if (_e1301 == _e1325) {
                                    phi_2741_ = _e1159;
                                    phi_2742_ = _e1156;
                                    phi_2743_ = _e1150;
                                    phi_2744_ = _e1147;
                                    phi_2745_ = vec3<f32>(_e1114[0], _e1114[1], _e1114[2]);
                                    phi_2746_ = _e1290;
                                    phi_2747_ = _e1286;
                                    phi_2748_ = _e1282;
                                } else {
                                    let _e1327 = (_e1312 == _e1325);
                                    let _e1332 = vec3(_e1327);
                                    phi_2741_ = select(_e1150, _e1168, _e1327);
                                    phi_2742_ = select(_e1147, _e1165, _e1327);
                                    phi_2743_ = select(_e1168, _e1159, _e1327);
                                    phi_2744_ = select(_e1165, _e1156, _e1327);
                                    phi_2745_ = select(vec3<f32>(_e1130[0], _e1130[1], _e1130[2]), vec3<f32>(_e1122[0], _e1122[1], _e1122[2]), _e1332);
                                    phi_2746_ = select(_e1286, _e1282, _e1332);
                                    phi_2747_ = select(_e1282, _e1290, _e1332);
                                    phi_2748_ = select(_e1290, _e1286, _e1332);
                                }
                                let _e1338 = phi_2741_;
                                let _e1340 = phi_2742_;
                                let _e1342 = phi_2743_;
                                let _e1344 = phi_2744_;
                                let _e1346 = phi_2745_;
                                let _e1348 = phi_2746_;
                                let _e1350 = phi_2747_;
                                let _e1352 = phi_2748_;
                                let _e1359 = ((_e1350.y * _e1348.z) - (_e1348.y * _e1350.z));
                                let _e1364 = ((_e1350.z * _e1348.x) - (_e1348.z * _e1350.x));
                                let _e1367 = ((_e1350.x * _e1348.y) - (_e1348.x * _e1350.y));
                                let _e1370 = ((_e1191 >= _e1195) && (_e1191 >= _e1199));
                                let _e1371 = (_e1195 >= _e1199);
                                let _e1385 = (((_e1359 * (select(select(_e1130[0], _e1122[0], _e1371), _e1114[0], _e1370) - _e548.member[0])) + (_e1364 * (select(select(_e1130[1], _e1122[1], _e1371), _e1114[1], _e1370) - _e548.member[1]))) + (_e1367 * (select(select(_e1130[2], _e1122[2], _e1371), _e1114[2], _e1370) - _e548.member[2])));
                                let _e1390 = (((_e1359 * _e571) + (_e1364 * _e587)) + (_e1367 * _e603));
                                let _e1391 = (_e1340 - _e1344);
                                let _e1392 = (_e1338 - _e1342);
                                let _e1395 = ((_e1391 * _e1391) + (_e1392 * _e1392));
                                let _e1402 = (-(((_e1344 * _e1391) + (_e1342 * _e1392))) / select(0.000000000000000000000000000000000000011754944f, _e1395, (_e1395 > 0.000000000000000000000000000000000000011754944f)));
                                let _e1404 = select(1f, _e1402, (_e1402 < 1f));
                                let _e1406 = select(0f, _e1404, (_e1404 > 0f));
                                let _e1415 = ((_e1346.x + (_e1352.x * _e1406)) - _e548.member[0]);
                                let _e1418 = ((_e1346.y + (_e1352.y * _e1406)) - _e548.member[1]);
                                let _e1421 = ((_e1346.z + (_e1352.z * _e1406)) - _e548.member[2]);
                                let _e1486 = ((bitcast<f32>((bitcast<u32>(((((_e1359 * _e1415) + (_e1364 * _e1418)) + (_e1367 * _e1421)) - _e1385)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1415) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1418) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1421) & 2147483647u))), _e1325)) * max(max(bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1364) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1367) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1390) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1350.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1350.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1350.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1348.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1348.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1348.z) & 2147483647u)))))));
                                let _e1487 = (_e1385 / _e1390);
                                if (_e1274 && !(_e1486)) {
                                    let _e1490 = (_e1421 / _e603);
                                    let _e1498 = (((_e1359 * (_e1415 - (_e571 * _e1490))) + (_e1364 * (_e1418 - (_e587 * _e1490)))) / _e1390);
                                    phi_2927_ = select(select(_e1490, (_e1490 + _e1498), (bitcast<f32>((bitcast<u32>(_e1498) & 2147483647u)) <= _e1325)), _e1487, _e1486);
                                } else {
                                    phi_2927_ = _e1487;
                                }
                                let _e1507 = phi_2927_;
                                let _e1509 = select(_e1247, _e1507, (_e1507 < _e1247));
                                let _e1511 = select(_e1242, _e1509, (_e1509 > _e1242));
                                let _e1514 = select(_e1511, 0f, (bitcast<u32>(_e1511) == 2147483648u));
                                let _e1515 = (1f / _e1201);
                                phi_2953_ = SlimbvhTypeI(_e1514, (_e1195 * _e1515), (_e1199 * _e1515), ((_e1274 && (_e1514 >= _e615)) && (_e1514 <= _e990.member.member_1)));
                                phi_2954_ = SlimbvhTypeI();
                            } else {
                                phi_2953_ = SlimbvhTypeI();
                                phi_2954_ = SlimbvhTypeI(0f, 0f, 0f, _e1274);
                            }
                            let _e1524 = phi_2953_;
                            let _e1526 = phi_2954_;
                            phi_2957_ = _e1524;
                            phi_2958_ = _e1526;
                            phi_2959_ = select(true, false, _e1274);
                        } else {
                            phi_2957_ = SlimbvhTypeI();
                            phi_2958_ = SlimbvhTypeI(0f, 0f, 0f, _e1185);
                            phi_2959_ = true;
                        }
                        let _e1529 = phi_2957_;
                        let _e1531 = phi_2958_;
                        let _e1533 = phi_2959_;
                        if _e1533 {
                            phi_2963_ = _e1531;
                        } else {
                            phi_2963_ = _e1529;
                        }
                        let _e1535 = phi_2963_;
                        if _e1535.member_3 {
                            phi_2972_ = SlimbvhTypeJ(_e1535.member, _e1535.member_1, _e1535.member_2, _e1053);
                        } else {
                            phi_2972_ = _e89;
                        }
                        let _e1542 = phi_2972_;
                        if (_e1542.member_3 != 4294967295u) {
                            let _e1548 = slimbvh_target.member[0u][0u];
                            let _e1552 = slimbvh_target.member[0u][1u];
                            let _e1556 = slimbvh_target.member[0u][2u];
                            let _e1560 = slimbvh_target.member[0u][3u];
                            let _e1564 = slimbvh_target.member[1u][0u];
                            let _e1568 = slimbvh_target.member[1u][1u];
                            let _e1572 = slimbvh_target.member[1u][2u];
                            let _e1576 = slimbvh_target.member[1u][3u];
                            let _e1577 = bitcast<f32>(_e1548);
                            let _e1578 = bitcast<f32>(_e1552);
                            let _e1579 = bitcast<f32>(_e1556);
                            let _e1581 = bitcast<f32>(_e1564);
                            let _e1582 = array<u32, 3>(_e1568, _e1572, _e1576);
                            if (_e118 < -126i) {
                                phi_3025_ = -126i;
                            } else {
                                phi_3025_ = select(_e118, 127i, (_e118 > 127i));
                            }
                            let _e1588 = phi_3025_;
                            let _e1593 = bitcast<f32>((bitcast<u32>((_e1588 + 127i)) << bitcast<u32>(23i)));
                            let _e1599 = bitcast<f32>((bitcast<u32>(((_e118 - _e1588) + 127i)) << bitcast<u32>(23i)));
                            if (_e1560 == 0u) {
                                phi_3165_ = SlimbvhTypeK(array<f32, 3>(_e1577, _e1578, _e1579), _e1560, _e1581, _e1582);
                            } else {
                                let _e1601 = bitcast<u32>(_e1577);
                                let _e1603 = ((_e1601 & 2139095040u) != 0u);
                                let _e1618 = bitcast<u32>(_e1578);
                                let _e1620 = ((_e1618 & 2139095040u) != 0u);
                                let _e1635 = bitcast<u32>(_e1579);
                                let _e1637 = ((_e1635 & 2139095040u) != 0u);
                                let _e1653 = bitcast<u32>(_e1581);
                                let _e1655 = ((_e1653 & 2139095040u) != 0u);
                                phi_3165_ = SlimbvhTypeK(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1601 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1601 & 2147483648u))), _e1577, _e1603) * _e1593) * select(0.00000011920929f, 1f, _e1603)) * _e1599), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1618 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1618 & 2147483648u))), _e1578, _e1620) * _e1593) * select(0.00000011920929f, 1f, _e1620)) * _e1599), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1635 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1635 & 2147483648u))), _e1579, _e1637) * _e1593) * select(0.00000011920929f, 1f, _e1637)) * _e1599)), _e1560, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1653 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1653 & 2147483648u))), _e1581, _e1655) * _e1593) * select(0.00000011920929f, 1f, _e1655)) * _e1599), _e1582);
                            }
                            let _e1672 = phi_3165_;
                            if (_e1053 == _e619) {
                                phi_3491_ = false;
                            } else {
                                let _e1674 = (_e1053 / 16u);
                                if (_e1674 < arrayLength((&slimbvh_sides.member))) {
                                    let _e1677 = slimbvh_sides.member[_e1674];
                                    phi_3189_ = _e1677;
                                } else {
                                    phi_3189_ = 0u;
                                }
                                let _e1679 = phi_3189_;
                                let _e1688 = (bitcast<i32>((_e1679 << bitcast<u32>(((30u - ((_e1053 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                let _e1689 = (_e1688 == 0i);
                                if _e1689 {
                                    phi_3490_ = true;
                                } else {
                                    if _e165 {
                                        phi_3218_ = vec3<f32>(_e1114[0], _e1114[1], _e1114[2]);
                                    } else {
                                        if (_e160 == 1u) {
                                            phi_3217_ = vec3<f32>(_e1114[2], _e1114[0], _e1114[1]);
                                        } else {
                                            phi_3217_ = vec3<f32>(_e1114[1], _e1114[2], _e1114[0]);
                                        }
                                        let _e1694 = phi_3217_;
                                        phi_3218_ = _e1694;
                                    }
                                    let _e1697 = phi_3218_;
                                    if _e165 {
                                        phi_3236_ = vec3<f32>(_e1122[0], _e1122[1], _e1122[2]);
                                    } else {
                                        if (_e160 == 1u) {
                                            phi_3235_ = vec3<f32>(_e1122[2], _e1122[0], _e1122[1]);
                                        } else {
                                            phi_3235_ = vec3<f32>(_e1122[1], _e1122[2], _e1122[0]);
                                        }
                                        let _e1702 = phi_3235_;
                                        phi_3236_ = _e1702;
                                    }
                                    let _e1705 = phi_3236_;
                                    if _e165 {
                                        phi_3254_ = vec3<f32>(_e1130[0], _e1130[1], _e1130[2]);
                                    } else {
                                        if (_e160 == 1u) {
                                            phi_3253_ = vec3<f32>(_e1130[2], _e1130[0], _e1130[1]);
                                        } else {
                                            phi_3253_ = vec3<f32>(_e1130[1], _e1130[2], _e1130[0]);
                                        }
                                        let _e1710 = phi_3253_;
                                        phi_3254_ = _e1710;
                                    }
                                    let _e1713 = phi_3254_;
                                    let _e1716 = (_e1705.x - _e1697.x);
                                    let _e1719 = (_e1705.y - _e1697.y);
                                    let _e1722 = (_e1705.z - _e1697.z);
                                    let _e1724 = (_e1713.x - _e1697.x);
                                    let _e1726 = (_e1713.y - _e1697.y);
                                    let _e1728 = (_e1713.z - _e1697.z);
                                    if (_e1672.member_1 == 1u) {
                                        phi_3290_ = (vec3<f32>(_e1672.member[0], _e1672.member[1], _e1672.member[2]) - _e1697);
                                    } else {
                                        phi_3290_ = vec3<f32>(_e1672.member[0], _e1672.member[1], _e1672.member[2]);
                                    }
                                    let _e1743 = phi_3290_;
                                    let _e1749 = bitcast<f32>((bitcast<u32>((_e1716 * _e1726)) ^ _e1672.member_3[0]));
                                    let _e1753 = bitcast<f32>((bitcast<u32>((_e1719 * _e1724)) ^ _e1672.member_3[0]));
                                    let _e1757 = bitcast<f32>((bitcast<u32>((_e1719 * _e1728)) ^ _e1672.member_3[0]));
                                    let _e1761 = bitcast<f32>((bitcast<u32>((_e1722 * _e1726)) ^ _e1672.member_3[0]));
                                    let _e1765 = bitcast<f32>((bitcast<u32>((_e1722 * _e1724)) ^ _e1672.member_3[0]));
                                    let _e1769 = bitcast<f32>((bitcast<u32>((_e1716 * _e1728)) ^ _e1672.member_3[0]));
                                    let _e1770 = (_e1757 - _e1761);
                                    let _e1771 = (_e1765 - _e1769);
                                    let _e1772 = (_e1749 - _e1753);
                                    let _e1796 = (bitcast<f32>((bitcast<u32>(_e1757) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1761) & 2147483647u)));
                                    let _e1803 = (bitcast<f32>((bitcast<u32>(_e1765) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1769) & 2147483647u)));
                                    let _e1810 = (bitcast<f32>((bitcast<u32>(_e1749) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1753) & 2147483647u)));
                                    if (_e1672.member_2 == 0f) {
                                        phi_3472_ = 0f;
                                    } else {
                                        let _e1840 = bitcast<f32>((bitcast<u32>(_e1770) & 2147483647u));
                                        let _e1843 = bitcast<f32>((bitcast<u32>(_e1771) & 2147483647u));
                                        let _e1846 = bitcast<f32>((bitcast<u32>(_e1772) & 2147483647u));
                                        let _e1848 = select(_e1846, _e1843, (_e1843 > _e1846));
                                        let _e1852 = select(_e1846, _e1843, (_e1843 < _e1846));
                                        let _e1856 = select(_e1843, _e1840, (_e1840 < _e1843));
                                        let _e1858 = select(_e1843, _e1840, (_e1840 > _e1843));
                                        let _e1860 = select(_e1846, _e1858, (_e1858 < _e1846));
                                        phi_3472_ = bitcast<f32>((bitcast<u32>((_e1672.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1848, _e1840, (_e1840 > _e1848)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1860, _e1856, (_e1856 > _e1860)))) ^ _e1672.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1852, _e1840, (_e1840 < _e1852)))) ^ _e1672.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1796 + _e1803) + _e1810))) ^ _e1672.member_3[0]))) * 1.0000005f)) ^ _e1672.member_3[0])))) ^ _e1672.member_3[0]));
                                    }
                                    let _e1887 = phi_3472_;
                                    phi_3490_ = (_e1689 || !(((((bitcast<f32>((bitcast<u32>((_e1743.x * _e1770)) ^ _e1672.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1743.y * _e1771)) ^ _e1672.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1743.z * _e1772)) ^ _e1672.member_3[0]))) * f32(-(_e1688))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1743.x) & 2147483647u)) * _e1796)) ^ _e1672.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1743.y) & 2147483647u)) * _e1803)) ^ _e1672.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1743.z) & 2147483647u)) * _e1810)) ^ _e1672.member_3[0]))))) ^ _e1672.member_3[0])) + _e1887) + 0.0000000000000000000000000000000000001880791f))));
                                }
                                let _e1901 = phi_3490_;
                                phi_3491_ = _e1901;
                            }
                            let _e1903 = phi_3491_;
                            if _e1903 {
                                if (_e1542.member < _e990.member.member.member) {
                                    phi_3511_ = true;
                                } else {
                                    if (_e1542.member == _e990.member.member.member) {
                                        phi_3510_ = (_e1542.member_3 < _e990.member.member.member_3);
                                    } else {
                                        phi_3510_ = false;
                                    }
                                    let _e1915 = phi_3510_;
                                    phi_3511_ = _e1915;
                                }
                                let _e1917 = phi_3511_;
                                if _e1917 {
                                    phi_3518_ = SlimbvhTypeO(SlimbvhTypeL(_e1542, _e1542.member), _e990.member_1);
                                } else {
                                    phi_3518_ = _e990;
                                }
                                let _e1923 = phi_3518_;
                                if _e1923.member_1 {
                                    phi_3524_ = SlimbvhTypeO(SlimbvhTypeL(_e1923.member.member, bitcast<f32>(4286578687u)), _e1923.member_1);
                                } else {
                                    phi_3524_ = _e1923;
                                }
                                let _e1932 = phi_3524_;
                                phi_3525_ = _e1932;
                            } else {
                                phi_3525_ = _e990;
                            }
                            let _e1934 = phi_3525_;
                            phi_3526_ = _e1934;
                        } else {
                            phi_3526_ = _e990;
                        }
                        let _e1936 = phi_3526_;
                        phi_2142_ = _e1936;
                    } else {
                        phi_2142_ = SlimbvhTypeO();
                    }
                    let _e1938 = phi_2142_;
                    continue;
                    continuing {
                        phi_2141_ = _e1938;
                        phi_2144_ = _e1005;
                        break if !(_e1011);
                    }
                }
                let _e1941 = local_4;
                let _e1942 = (_e1941 - 1u);
                let _e1945 = local[(_e1942 % 128u)];
                let _e1946 = (_e1945 & 511u);
                let _e1948 = (_e1946 >> bitcast<u32>(3u));
                let _e1951 = ((_e1948 == 0u) || (_e1942 == 4294967295u));
                if _e1951 {
                } else {
                    local[(_e1942 % 128u)] = (((_e1945 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1948);
                }
                let _e1958 = local_5;
                let _e1966 = (((_e1945 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1946 & 3u) & 3u));
                let _e1968 = (_e1966 >> bitcast<u32>(2i));
                if (_e1968 < _e92) {
                    let _e1975 = slimbvh_nodes.member[_e1968].member_1[(_e1966 & 3u)];
                    phi_3582_ = _e1975;
                } else {
                    phi_3582_ = 2147483648u;
                }
                let _e1977 = phi_3582_;
                let _e1979 = local_6;
                let _e2241 = local_8;
                phi_3591_ = _e2241;
                phi_3592_ = select(select(_e1958, _e1942, _e1951), 4294967295u, (_e615 > _e1979.member.member_1));
                phi_3593_ = _e1977;
            } else {
                phi_3591_ = _e647;
                let _e2244 = local_9;
                phi_3592_ = _e2244;
                let _e2247 = local_10;
                phi_3593_ = _e2247;
            }
            let _e1985 = phi_3591_;
            let _e1987 = phi_3592_;
            let _e1989 = phi_3593_;
            phi_1521_ = _e1985;
            phi_1524_ = _e1987;
            phi_1526_ = _e1989;
            let _e2253 = local_11;
            phi_1528_ = _e2253;
        } else {
            phi_1521_ = SlimbvhTypeO();
            phi_1524_ = u32();
            phi_1526_ = u32();
            phi_1528_ = u32();
        }
        let _e1991 = phi_1521_;
        let _e1993 = phi_1524_;
        let _e1995 = phi_1526_;
        let _e1997 = phi_1528_;
        continue;
        continuing {
            phi_1520_ = _e1991;
            phi_1523_ = _e1993;
            phi_1525_ = _e1995;
            phi_1527_ = _e1997;
            break if !(_e654);
        }
    }
    let _e2000 = local_7;
    if (_e2000.member.member.member_3 != 4294967295u) {
        let _e2006 = -((_e118 + _e548.member_4));
        let _e2007 = bitcast<u32>(_e2000.member.member.member);
        let _e2011 = (bitcast<i32>((_e2007 >> bitcast<u32>(23i))) & 255i);
        let _e2012 = (_e2011 + _e2006);
        if (_e2011 == 255i) {
            phi_3650_ = _e2000.member.member.member;
        } else {
            if (_e2011 > 0i) {
                if (_e2012 > 0i) {
                    let _e2016 = (_e2012 < 255i);
                    if _e2016 {
                        phi_3629_ = bitcast<f32>((_e2007 + bitcast<u32>((_e2006 << bitcast<u32>(23i)))));
                    } else {
                        phi_3629_ = f32();
                    }
                    let _e2023 = phi_3629_;
                    phi_3631_ = _e2023;
                    phi_3632_ = select(true, false, _e2016);
                } else {
                    phi_3631_ = f32();
                    phi_3632_ = true;
                }
                let _e2026 = phi_3631_;
                let _e2028 = phi_3632_;
                phi_3633_ = _e2026;
                phi_3634_ = _e2028;
            } else {
                phi_3633_ = f32();
                phi_3634_ = true;
            }
            let _e2030 = phi_3633_;
            let _e2032 = phi_3634_;
            if _e2032 {
                let _e2033 = (_e2007 & 2147483648u);
                let _e2040 = ((_e2007 & 8388607u) | (select(0u, 1u, ((_e2007 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e2044 = (_e2040 == 0u);
                if _e2044 {
                    phi_4069_ = bitcast<f32>(_e2033);
                } else {
                    let _e2049 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2040)), 32u, _e2044) - 8u);
                    let _e2052 = (_e2040 << bitcast<u32>((_e2049 & 31u)));
                    let _e2054 = ((_e2012 + select(0i, 1i, (_e2011 == 0i))) - bitcast<i32>(_e2049));
                    if (_e2054 >= 255i) {
                        phi_4059_ = bitcast<f32>((_e2033 | 2139095040u));
                        phi_4060_ = f32();
                        phi_4061_ = true;
                    } else {
                        let _e2056 = (_e2054 > 0i);
                        if _e2056 {
                            phi_4053_ = bitcast<f32>(((_e2033 | (bitcast<u32>(_e2054) << bitcast<u32>(23i))) | (_e2052 & 8388607u)));
                            phi_4054_ = f32();
                        } else {
                            if (_e2054 < -24i) {
                                phi_4019_ = 26u;
                            } else {
                                phi_4019_ = bitcast<u32>((1i - _e2054));
                            }
                            let _e2061 = phi_4019_;
                            let _e2062 = (_e2061 & 31u);
                            let _e2064 = (_e2052 >> bitcast<u32>(_e2062));
                            let _e2068 = (_e2052 & ((1u << bitcast<u32>(_e2062)) - 1u));
                            let _e2072 = (1u << bitcast<u32>(((_e2061 - 1u) & 31u)));
                            if (_e2068 > _e2072) {
                                phi_4040_ = true;
                            } else {
                                if (_e2068 == _e2072) {
                                    phi_4037_ = ((_e2064 & 1u) == 1u);
                                } else {
                                    phi_4037_ = false;
                                }
                                let _e2078 = phi_4037_;
                                phi_4040_ = _e2078;
                            }
                            let _e2080 = phi_4040_;
                            phi_4053_ = f32();
                            phi_4054_ = bitcast<f32>((_e2033 | (_e2064 + select(0u, 1u, _e2080))));
                        }
                        let _e2093 = phi_4053_;
                        let _e2095 = phi_4054_;
                        phi_4059_ = _e2093;
                        phi_4060_ = _e2095;
                        phi_4061_ = _e2056;
                    }
                    let _e2099 = phi_4059_;
                    let _e2101 = phi_4060_;
                    let _e2103 = phi_4061_;
                    phi_4069_ = select(_e2101, _e2099, _e2103);
                }
                let _e2107 = phi_4069_;
                phi_3649_ = _e2107;
            } else {
                phi_3649_ = _e2030;
            }
            let _e2109 = phi_3649_;
            phi_3650_ = _e2109;
        }
        let _e2111 = phi_3650_;
        let _e2112 = bitcast<u32>(_e2111);
        if ((_e2112 & 2147483647u) >= 2139095040u) {
            phi_3662_ = bitcast<f32>(((_e2112 & 2147483648u) | 2139095039u));
        } else {
            phi_3662_ = _e2111;
        }
        let _e2119 = phi_3662_;
        phi_3667_ = SlimbvhTypeJ(_e2119, _e2000.member.member.member_1, _e2000.member.member.member_2, _e2000.member.member.member_3);
    } else {
        phi_3667_ = _e89;
    }
    let _e2124 = phi_3667_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2124.member), bitcast<u32>(_e2124.member_1), bitcast<u32>(_e2124.member_2), _e2124.member_3);
    return;
}

struct SlimbvhTypeP {
    member: array<vec4<f32>, 3>,
}

struct SlimbvhTypeQ {
    member: vec2<f32>,
}

struct SlimbvhTypeR {
    member: array<vec4<f32>, 5>,
}

var<private> slimbvh_corners: SlimbvhTypeP;

var<private> slimbvh_weights: SlimbvhTypeQ;

var<private> slimbvh_from: SlimbvhTypeM;

var<private> slimbvh_point: SlimbvhTypeR;

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
