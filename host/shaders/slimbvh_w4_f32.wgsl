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
    member: array<vec4<f32>, 6>,
    member_1: array<u32, 4>,
    member_2: array<u32, 4>,
}

struct SlimbvhTypeC {
    member: array<SlimbvhTypeB>,
}

struct SlimbvhTypeD {
    member: array<array<vec4<f32>, 5>>,
}

struct SlimbvhTypeE {
    member: array<u32>,
}

struct SlimbvhTypeF {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
    member_2: f32,
    member_3: f32,
    member_4: i32,
}

struct SlimbvhTypeG {
    member: u32,
    member_1: u32,
}

struct SlimbvhTypeH {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct SlimbvhTypeI {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct SlimbvhTypeJ {
    member: array<vec4<u32>, 2>,
}

struct SlimbvhTypeK {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct SlimbvhTypeL {
    member: SlimbvhTypeI,
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
var<storage> slimbvh_triangles: SlimbvhTypeD;

@group(0) @binding(3) 
var<storage> slimbvh_sides: SlimbvhTypeE;

@group(0) @binding(4) 
var<uniform> slimbvh_target: SlimbvhTypeJ;

var<private> slimbvh_origin: SlimbvhTypeM;

var<private> slimbvh_direction: SlimbvhTypeM;

var<private> slimbvh_question: SlimbvhTypeN;

var<private> slimbvh_hit: SlimbvhTypeA;

@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeC;

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
    var phi_1241_: SlimbvhTypeF;
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
    var phi_3740_: SlimbvhTypeG;
    var phi_3752_: SlimbvhTypeG;
    var phi_3764_: SlimbvhTypeG;
    var phi_3776_: SlimbvhTypeG;
    var phi_3788_: SlimbvhTypeG;
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
    var phi_2144_: SlimbvhTypeG;
    var phi_2145_: SlimbvhTypeG;
    var phi_2167_: SlimbvhTypeG;
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
    var phi_2953_: SlimbvhTypeH;
    var phi_2954_: SlimbvhTypeH;
    var phi_2957_: SlimbvhTypeH;
    var phi_2958_: SlimbvhTypeH;
    var phi_2959_: bool;
    var phi_2963_: SlimbvhTypeH;
    var phi_2972_: SlimbvhTypeI;
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
    var phi_3667_: SlimbvhTypeI;
    var local_8: SlimbvhTypeO;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e89 = SlimbvhTypeI(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
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
        phi_1241_ = SlimbvhTypeF(array<f32, 3>((_e167 * _e472), (_e171 * _e472), (_e174 * _e472)), array<f32, 3>((_e176 * _e477), (_e178 * _e477), (_e180 * _e477)), bitcast<f32>(((_e125 & 2147483648u) | select(_e509, 0u, _e511))), bitcast<f32>(((_e133 & 2147483648u) | select(_e539, 0u, _e541))), _e466);
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
        phi_1241_ = SlimbvhTypeF(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e245 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e245 & 2147483648u))), _e167, _e247) * _e238) * select(0.00000011920929f, 1f, _e247)) * _e244), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e262 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e262 & 2147483648u))), _e171, _e264) * _e238) * select(0.00000011920929f, 1f, _e264)) * _e244), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e279 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e279 & 2147483648u))), _e174, _e281) * _e238) * select(0.00000011920929f, 1f, _e281)) * _e244)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e314 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e314 & 2147483648u))), _e176, _e316) * _e307) * select(0.00000011920929f, 1f, _e316)) * _e313), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e331 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e331 & 2147483648u))), _e178, _e333) * _e307) * select(0.00000011920929f, 1f, _e333)) * _e313), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e348 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e348 & 2147483648u))), _e180, _e350) * _e307) * select(0.00000011920929f, 1f, _e350)) * _e313)), bitcast<f32>(((_e125 & 2147483648u) | select(_e407, 0u, _e409))), bitcast<f32>(((_e133 & 2147483648u) | select(_e455, 0u, _e457))), _e227);
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
                        phi_3740_ = SlimbvhTypeG(_e840, _e848);
                    } else {
                        phi_3740_ = SlimbvhTypeG(_e848, _e840);
                    }
                    let _e869 = phi_3740_;
                    if (_e856 < _e864) {
                        phi_3752_ = SlimbvhTypeG(_e856, _e864);
                    } else {
                        phi_3752_ = SlimbvhTypeG(_e864, _e856);
                    }
                    let _e876 = phi_3752_;
                    if (_e869.member < _e876.member) {
                        phi_3764_ = SlimbvhTypeG(_e869.member, _e876.member);
                    } else {
                        phi_3764_ = SlimbvhTypeG(_e876.member, _e869.member);
                    }
                    let _e883 = phi_3764_;
                    if (_e869.member_1 < _e876.member_1) {
                        phi_3776_ = SlimbvhTypeG(_e869.member_1, _e876.member_1);
                    } else {
                        phi_3776_ = SlimbvhTypeG(_e876.member_1, _e869.member_1);
                    }
                    let _e890 = phi_3776_;
                    if (_e890.member < _e883.member_1) {
                        phi_3788_ = SlimbvhTypeG(_e890.member, _e883.member_1);
                    } else {
                        phi_3788_ = SlimbvhTypeG(_e883.member_1, _e890.member);
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
                phi_2144_ = SlimbvhTypeG(0u, ((_e984 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e990 = phi_2141_;
                    let _e992 = phi_2144_;
                    local_6 = _e990;
                    local_8 = _e990;
                    if (_e992.member < _e992.member_1) {
                        phi_2145_ = SlimbvhTypeG((_e992.member + 1u), _e992.member_1);
                        phi_2167_ = SlimbvhTypeG(1u, _e992.member);
                    } else {
                        phi_2145_ = _e992;
                        phi_2167_ = SlimbvhTypeG(0u, SlimbvhTypeG().member_1);
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
                                phi_2953_ = SlimbvhTypeH(_e1514, (_e1195 * _e1515), (_e1199 * _e1515), ((_e1274 && (_e1514 >= _e615)) && (_e1514 <= _e990.member.member_1)));
                                phi_2954_ = SlimbvhTypeH();
                            } else {
                                phi_2953_ = SlimbvhTypeH();
                                phi_2954_ = SlimbvhTypeH(0f, 0f, 0f, _e1274);
                            }
                            let _e1524 = phi_2953_;
                            let _e1526 = phi_2954_;
                            phi_2957_ = _e1524;
                            phi_2958_ = _e1526;
                            phi_2959_ = select(true, false, _e1274);
                        } else {
                            phi_2957_ = SlimbvhTypeH();
                            phi_2958_ = SlimbvhTypeH(0f, 0f, 0f, _e1185);
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
                            phi_2972_ = SlimbvhTypeI(_e1535.member, _e1535.member_1, _e1535.member_2, _e1053);
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
        phi_3667_ = SlimbvhTypeI(_e2119, _e2000.member.member.member_1, _e2000.member.member.member_2, _e2000.member.member.member_3);
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
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var phi_214_: i32;
    var phi_708_: i32;
    var phi_739_: i32;
    var phi_758_: vec3<f32>;
    var phi_898_: SlimbvhTypeG;
    var phi_899_: SlimbvhTypeG;
    var phi_922_: SlimbvhTypeG;
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
    phi_898_ = SlimbvhTypeG(0u, 3u);
    loop {
        let _e463 = phi_898_;
        if (_e463.member < _e463.member_1) {
            phi_899_ = SlimbvhTypeG((_e463.member + 1u), _e463.member_1);
            phi_922_ = SlimbvhTypeG(1u, _e463.member);
        } else {
            phi_899_ = _e463;
            phi_922_ = SlimbvhTypeG(0u, SlimbvhTypeG().member_1);
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
