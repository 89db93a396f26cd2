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
    var phi_630_: u32;
    var phi_636_: u32;
    var phi_642_: u32;
    var phi_907_: i32;
    var phi_918_: i32;
    var phi_1032_: i32;
    var phi_1161_: i32;
    var phi_1183_: u32;
    var phi_1184_: u32;
    var phi_1185_: bool;
    var phi_1219_: i32;
    var phi_1241_: u32;
    var phi_1242_: u32;
    var phi_1243_: bool;
    var phi_804_: i32;
    var phi_810_: u32;
    var phi_829_: u32;
    var phi_830_: u32;
    var phi_831_: bool;
    var phi_849_: i32;
    var phi_855_: u32;
    var phi_874_: u32;
    var phi_875_: u32;
    var phi_876_: bool;
    var phi_1253_: SlimbvhTypeF;
    var phi_1492_: SlimbvhTypeO;
    var phi_1533_: SlimbvhTypeO;
    var phi_1536_: u32;
    var phi_1538_: u32;
    var phi_1540_: u32;
    var phi_1549_: u32;
    var phi_1552_: u32;
    var phi_1554_: u32;
    var phi_2011_: u32;
    var phi_2024_: u32;
    var phi_2037_: u32;
    var phi_2050_: u32;
    var phi_3780_: SlimbvhTypeG;
    var phi_3792_: SlimbvhTypeG;
    var phi_3804_: SlimbvhTypeG;
    var phi_3816_: SlimbvhTypeG;
    var phi_3828_: SlimbvhTypeG;
    var phi_2131_: u32;
    var phi_2136_: u32;
    var phi_2137_: u32;
    var phi_2161_: u32;
    var phi_1550_: u32;
    var phi_1553_: u32;
    var phi_1555_: u32;
    var local_1: bool;
    var local_2: u32;
    var local_3: u32;
    var phi_2178_: SlimbvhTypeO;
    var phi_2181_: SlimbvhTypeG;
    var phi_2182_: SlimbvhTypeG;
    var phi_2204_: SlimbvhTypeG;
    var phi_2283_: array<vec4<f32>, 3>;
    var phi_2284_: array<vec4<f32>, 3>;
    var phi_2364_: array<vec4<f32>, 3>;
    var phi_2365_: array<vec4<f32>, 3>;
    var phi_2388_: array<f32, 3>;
    var phi_2389_: array<f32, 3>;
    var phi_2403_: array<f32, 3>;
    var phi_2404_: array<f32, 3>;
    var phi_2418_: array<f32, 3>;
    var phi_2419_: array<f32, 3>;
    var phi_2778_: f32;
    var phi_2779_: f32;
    var phi_2780_: f32;
    var phi_2781_: f32;
    var phi_2782_: vec3<f32>;
    var phi_2783_: vec3<f32>;
    var phi_2784_: vec3<f32>;
    var phi_2785_: vec3<f32>;
    var phi_2964_: f32;
    var phi_2990_: SlimbvhTypeH;
    var phi_2991_: SlimbvhTypeH;
    var phi_2994_: SlimbvhTypeH;
    var phi_2995_: SlimbvhTypeH;
    var phi_2996_: bool;
    var phi_3000_: SlimbvhTypeH;
    var phi_3009_: SlimbvhTypeI;
    var phi_3062_: i32;
    var phi_3202_: SlimbvhTypeK;
    var phi_3226_: u32;
    var phi_3254_: vec3<f32>;
    var phi_3255_: vec3<f32>;
    var phi_3272_: vec3<f32>;
    var phi_3273_: vec3<f32>;
    var phi_3290_: vec3<f32>;
    var phi_3291_: vec3<f32>;
    var phi_3327_: vec3<f32>;
    var phi_3509_: f32;
    var phi_3527_: bool;
    var phi_3528_: bool;
    var phi_3547_: bool;
    var phi_3548_: bool;
    var phi_3555_: SlimbvhTypeO;
    var phi_3561_: SlimbvhTypeO;
    var phi_3562_: SlimbvhTypeO;
    var phi_3563_: SlimbvhTypeO;
    var phi_2179_: SlimbvhTypeO;
    var local_4: u32;
    var local_5: u32;
    var phi_3622_: u32;
    var local_6: SlimbvhTypeO;
    var phi_3631_: SlimbvhTypeO;
    var phi_3632_: u32;
    var phi_3633_: u32;
    var phi_1534_: SlimbvhTypeO;
    var phi_1537_: u32;
    var phi_1539_: u32;
    var phi_1541_: u32;
    var local_7: SlimbvhTypeO;
    var phi_3669_: f32;
    var phi_3671_: f32;
    var phi_3672_: bool;
    var phi_3673_: f32;
    var phi_3674_: bool;
    var phi_4059_: u32;
    var phi_4077_: bool;
    var phi_4080_: bool;
    var phi_4093_: f32;
    var phi_4094_: f32;
    var phi_4099_: f32;
    var phi_4100_: f32;
    var phi_4101_: bool;
    var phi_4109_: f32;
    var phi_3689_: f32;
    var phi_3690_: f32;
    var phi_3702_: f32;
    var phi_3707_: SlimbvhTypeI;
    var local_8: SlimbvhTypeO;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e89 = SlimbvhTypeI(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e93 = arrayLength((&slimbvh_nodes.member));
    let _e104 = slimbvh_exponent.member[1u];
    let _e107 = slimbvh_exponent.member[2u];
    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    let _e108 = slimbvh_origin.member;
    let _e114 = slimbvh_origin.member[3u];
    let _e115 = slimbvh_direction.member;
    let _e121 = slimbvh_direction.member[3u];
    let _e124 = slimbvh_exponent.member[0u];
    let _e125 = bitcast<i32>(_e124);
    let _e127 = (bitcast<u32>(_e108.x) & 2147483647u);
    let _e129 = (bitcast<u32>(_e108.y) & 2147483647u);
    let _e131 = (bitcast<u32>(_e108.z) & 2147483647u);
    let _e132 = bitcast<u32>(_e114);
    let _e133 = (_e132 & 2147483647u);
    let _e135 = (bitcast<u32>(_e115.x) & 2147483647u);
    let _e137 = (bitcast<u32>(_e115.y) & 2147483647u);
    let _e139 = (bitcast<u32>(_e115.z) & 2147483647u);
    let _e140 = bitcast<u32>(_e121);
    let _e141 = (_e140 & 2147483647u);
    let _e143 = select(_e137, _e135, (_e137 < _e135));
    let _e145 = select(_e139, _e143, (_e139 < _e143));
    let _e147 = select(_e127, _e145, (_e127 < _e145));
    let _e149 = select(_e129, _e147, (_e129 < _e147));
    let _e151 = select(_e131, _e149, (_e131 < _e149));
    let _e158 = (((select(_e133, _e151, (_e133 < _e151)) < 2139095040u) && (_e141 <= 2139095040u)) && (_e145 > 0u));
    if (_e135 == _e145) {
        phi_630_ = 0u;
    } else {
        phi_630_ = select(2u, 1u, (_e137 == _e145));
    }
    let _e163 = phi_630_;
    let _e164 = (_e163 == 2u);
    if _e164 {
        phi_636_ = 0u;
    } else {
        phi_636_ = (_e163 + 1u);
    }
    let _e167 = phi_636_;
    let _e168 = (_e167 == 2u);
    if _e168 {
        phi_642_ = 0u;
    } else {
        phi_642_ = (_e167 + 1u);
    }
    let _e171 = phi_642_;
    let _e172 = (_e167 == 0u);
    let _e174 = select(select(_e108.y, _e108.x, _e172), _e108.z, _e168);
    let _e175 = (_e171 == 0u);
    let _e177 = (_e171 == 2u);
    let _e178 = select(select(_e108.y, _e108.x, _e175), _e108.z, _e177);
    let _e179 = (_e163 == 0u);
    let _e181 = select(select(_e108.y, _e108.x, _e179), _e108.z, _e164);
    let _e183 = select(select(_e115.y, _e115.x, _e172), _e115.z, _e168);
    let _e185 = select(select(_e115.y, _e115.x, _e175), _e115.z, _e177);
    let _e187 = select(select(_e115.y, _e115.x, _e179), _e115.z, _e164);
    let _e188 = (_e133 - 1u);
    let _e189 = (_e141 - 1u);
    let _e191 = select(_e188, _e189, (_e189 < _e188));
    let _e192 = (_e127 - 1u);
    let _e193 = (_e129 - 1u);
    let _e195 = select(_e192, _e193, (_e193 < _e192));
    let _e196 = (_e131 - 1u);
    let _e198 = select(_e195, _e196, (_e196 < _e195));
    let _e199 = (_e135 - 1u);
    let _e200 = (_e137 - 1u);
    let _e202 = select(_e199, _e200, (_e200 < _e199));
    let _e203 = (_e139 - 1u);
    let _e205 = select(_e202, _e203, (_e203 < _e202));
    let _e207 = select(_e198, _e205, (_e205 < _e198));
    if (((select(_e207, _e191, (_e191 < _e207)) >= 8388607u) && (_e145 < 2130706432u)) && (bitcast<u32>((_e125 + 126i)) <= 253u)) {
        let _e472 = bitcast<i32>((_e145 >> bitcast<u32>(23i)));
        let _e473 = (_e472 - 127i);
        let _e474 = (_e125 + _e473);
        let _e479 = bitcast<f32>((bitcast<u32>((_e125 + 127i)) << bitcast<u32>(23i)));
        let _e484 = bitcast<f32>((bitcast<u32>((254i - _e472)) << bitcast<u32>(23i)));
        if (_e133 >= 2139095040u) {
            phi_804_ = 255i;
        } else {
            phi_804_ = (bitcast<i32>((_e133 >> bitcast<u32>(23i))) + _e474);
        }
        let _e499 = phi_804_;
        if (_e133 == 0u) {
            phi_810_ = 0u;
        } else {
            phi_810_ = (_e133 | 8388608u);
        }
        let _e503 = phi_810_;
        if (_e499 <= 0i) {
            phi_830_ = u32();
            phi_831_ = true;
        } else {
            let _e510 = (_e503 == 0u);
            if _e510 {
                phi_829_ = u32();
            } else {
                phi_829_ = select(((bitcast<u32>(_e499) << bitcast<u32>(23i)) | (_e503 & 8388607u)), 2139095039u, (_e499 >= 255i));
            }
            let _e514 = phi_829_;
            phi_830_ = _e514;
            phi_831_ = _e510;
        }
        let _e516 = phi_830_;
        let _e518 = phi_831_;
        if (_e141 >= 2139095040u) {
            phi_849_ = 255i;
        } else {
            phi_849_ = (bitcast<i32>((_e141 >> bitcast<u32>(23i))) + _e474);
        }
        let _e529 = phi_849_;
        if (_e141 == 0u) {
            phi_855_ = 0u;
        } else {
            phi_855_ = (_e141 | 8388608u);
        }
        let _e533 = phi_855_;
        if (_e529 <= 0i) {
            phi_875_ = u32();
            phi_876_ = true;
        } else {
            let _e540 = (_e533 == 0u);
            if _e540 {
                phi_874_ = u32();
            } else {
                phi_874_ = select(((bitcast<u32>(_e529) << bitcast<u32>(23i)) | (_e533 & 8388607u)), 2139095039u, (_e529 >= 255i));
            }
            let _e544 = phi_874_;
            phi_875_ = _e544;
            phi_876_ = _e540;
        }
        let _e546 = phi_875_;
        let _e548 = phi_876_;
        phi_1253_ = SlimbvhTypeF(array<f32, 3>((_e174 * _e479), (_e178 * _e479), (_e181 * _e479)), array<f32, 3>((_e183 * _e484), (_e185 * _e484), (_e187 * _e484)), bitcast<f32>(((_e132 & 2147483648u) | select(_e516, 0u, _e518))), bitcast<f32>(((_e140 & 2147483648u) | select(_e546, 0u, _e548))), _e473);
    } else {
        let _e220 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e145, _e158))) & 2147483647u);
        if (_e220 >= 8388608u) {
            phi_907_ = (bitcast<i32>((_e220 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_907_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e220)), 32u, (_e220 == 0u))));
        }
        let _e234 = phi_907_;
        let _e235 = (_e125 + _e234);
        if (_e125 < -126i) {
            phi_918_ = -126i;
        } else {
            phi_918_ = select(_e125, 127i, (_e125 > 127i));
        }
        let _e240 = phi_918_;
        let _e245 = bitcast<f32>((bitcast<u32>((_e240 + 127i)) << bitcast<u32>(23i)));
        let _e251 = bitcast<f32>((bitcast<u32>(((_e125 - _e240) + 127i)) << bitcast<u32>(23i)));
        let _e252 = bitcast<u32>(_e174);
        let _e254 = ((_e252 & 2139095040u) != 0u);
        let _e269 = bitcast<u32>(_e178);
        let _e271 = ((_e269 & 2139095040u) != 0u);
        let _e286 = bitcast<u32>(_e181);
        let _e288 = ((_e286 & 2139095040u) != 0u);
        let _e304 = -(_e234);
        if (_e304 < -126i) {
            phi_1032_ = -126i;
        } else {
            phi_1032_ = select(_e304, 127i, (_e304 > 127i));
        }
        let _e309 = phi_1032_;
        let _e314 = bitcast<f32>((bitcast<u32>((_e309 + 127i)) << bitcast<u32>(23i)));
        let _e320 = bitcast<f32>((bitcast<u32>(((_e304 - _e309) + 127i)) << bitcast<u32>(23i)));
        let _e321 = bitcast<u32>(_e183);
        let _e323 = ((_e321 & 2139095040u) != 0u);
        let _e338 = bitcast<u32>(_e185);
        let _e340 = ((_e338 & 2139095040u) != 0u);
        let _e355 = bitcast<u32>(_e187);
        let _e357 = ((_e355 & 2139095040u) != 0u);
        let _e379 = ((_e133 & 8388607u) | (select(0u, 1u, ((_e133 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e382 = bitcast<i32>((_e133 >> bitcast<u32>(23i)));
        let _e389 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e379)), 32u, (_e379 == 0u))) - 8i);
        if (_e382 == 255i) {
            phi_1161_ = 255i;
        } else {
            phi_1161_ = (((_e382 + select(0i, 1i, (_e382 == 0i))) - _e389) + _e235);
        }
        let _e397 = phi_1161_;
        let _e401 = (_e379 << bitcast<u32>(((_e389 & 31i) & 31i)));
        if (_e397 <= 0i) {
            phi_1184_ = u32();
            phi_1185_ = true;
        } else {
            let _e408 = (_e401 == 0u);
            if _e408 {
                phi_1183_ = u32();
            } else {
                phi_1183_ = select(((bitcast<u32>(_e397) << bitcast<u32>(23i)) | (_e401 & 8388607u)), 2139095039u, (_e397 >= 255i));
            }
            let _e412 = phi_1183_;
            phi_1184_ = _e412;
            phi_1185_ = _e408;
        }
        let _e414 = phi_1184_;
        let _e416 = phi_1185_;
        let _e427 = ((_e141 & 8388607u) | (select(0u, 1u, ((_e141 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e430 = bitcast<i32>((_e141 >> bitcast<u32>(23i)));
        let _e437 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e427)), 32u, (_e427 == 0u))) - 8i);
        if (_e430 == 255i) {
            phi_1219_ = 255i;
        } else {
            phi_1219_ = (((_e430 + select(0i, 1i, (_e430 == 0i))) - _e437) + _e235);
        }
        let _e445 = phi_1219_;
        let _e449 = (_e427 << bitcast<u32>(((_e437 & 31i) & 31i)));
        if (_e445 <= 0i) {
            phi_1242_ = u32();
            phi_1243_ = true;
        } else {
            let _e456 = (_e449 == 0u);
            if _e456 {
                phi_1241_ = u32();
            } else {
                phi_1241_ = select(((bitcast<u32>(_e445) << bitcast<u32>(23i)) | (_e449 & 8388607u)), 2139095039u, (_e445 >= 255i));
            }
            let _e460 = phi_1241_;
            phi_1242_ = _e460;
            phi_1243_ = _e456;
        }
        let _e462 = phi_1242_;
        let _e464 = phi_1243_;
        phi_1253_ = SlimbvhTypeF(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e252 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e252 & 2147483648u))), _e174, _e254) * _e245) * select(0.00000011920929f, 1f, _e254)) * _e251), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e269 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e269 & 2147483648u))), _e178, _e271) * _e245) * select(0.00000011920929f, 1f, _e271)) * _e251), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e286 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e286 & 2147483648u))), _e181, _e288) * _e245) * select(0.00000011920929f, 1f, _e288)) * _e251)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e321 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e321 & 2147483648u))), _e183, _e323) * _e314) * select(0.00000011920929f, 1f, _e323)) * _e320), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e338 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e338 & 2147483648u))), _e185, _e340) * _e314) * select(0.00000011920929f, 1f, _e340)) * _e320), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e355 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e355 & 2147483648u))), _e187, _e357) * _e314) * select(0.00000011920929f, 1f, _e357)) * _e320)), bitcast<f32>(((_e132 & 2147483648u) | select(_e414, 0u, _e416))), bitcast<f32>(((_e140 & 2147483648u) | select(_e462, 0u, _e464))), _e234);
    }
    let _e555 = phi_1253_;
    let _e570 = (bitcast<f32>((bitcast<u32>(_e555.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e573 = bitcast<f32>((bitcast<u32>(_e555.member[0]) & 2147483647u));
    let _e574 = (_e573 * 0.00000011920929f);
    let _e577 = select(select(0.00000000000011368684f, _e574, (_e574 > 0.00000000000011368684f)), 0f, _e570);
    let _e578 = select(0f, _e555.member_1[0], _e570);
    let _e579 = (_e555.member[0] + _e577);
    let _e580 = (_e555.member[0] - _e577);
    let _e582 = select(38685626000000000000000000f, (1f / _e555.member_1[0]), _e570);
    let _e586 = (bitcast<f32>((bitcast<u32>(_e555.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e589 = bitcast<f32>((bitcast<u32>(_e555.member[1]) & 2147483647u));
    let _e590 = (_e589 * 0.00000011920929f);
    let _e593 = select(select(0.00000000000011368684f, _e590, (_e590 > 0.00000000000011368684f)), 0f, _e586);
    let _e594 = select(0f, _e555.member_1[1], _e586);
    let _e595 = (_e555.member[1] + _e593);
    let _e596 = (_e555.member[1] - _e593);
    let _e598 = select(38685626000000000000000000f, (1f / _e555.member_1[1]), _e586);
    let _e602 = (bitcast<f32>((bitcast<u32>(_e555.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e605 = bitcast<f32>((bitcast<u32>(_e555.member[2]) & 2147483647u));
    let _e606 = (_e605 * 0.00000011920929f);
    let _e609 = select(select(0.00000000000011368684f, _e606, (_e606 > 0.00000000000011368684f)), 0f, _e602);
    let _e610 = select(0f, _e555.member_1[2], _e602);
    let _e611 = (_e555.member[2] + _e609);
    let _e612 = (_e555.member[2] - _e609);
    let _e614 = select(38685626000000000000000000f, (1f / _e555.member_1[2]), _e602);
    let _e616 = select(_e589, _e573, (_e573 > _e589));
    let _e620 = (_e158 && (select(_e605, _e616, (_e616 > _e605)) <= 1099511600000f));
    let _e621 = select(0f, _e555.member_3, _e620);
    let _e622 = select(1f, _e555.member_2, _e620);
    let _e626 = slimbvh_question.member[1u];
    let _e629 = slimbvh_question.member[0u];
    if (_e629 == 1u) {
        phi_1492_ = SlimbvhTypeO(SlimbvhTypeL(_e89, _e621), true);
    } else {
        phi_1492_ = SlimbvhTypeO(SlimbvhTypeL(_e89, _e621), false);
    }
    let _e636 = phi_1492_;
    phi_1533_ = _e636;
    phi_1536_ = select(4294967295u, 0u, (_e622 <= _e621));
    phi_1538_ = 0u;
    phi_1540_ = (_e93 + 1u);
    loop {
        let _e654 = phi_1533_;
        let _e656 = phi_1536_;
        let _e658 = phi_1538_;
        let _e660 = phi_1540_;
        local_7 = _e654;
        let _e661 = (_e656 <= 2147483647u);
        if _e661 {
            phi_1549_ = _e656;
            phi_1552_ = _e658;
            phi_1554_ = _e660;
            loop {
                let _e663 = phi_1549_;
                let _e665 = phi_1552_;
                let _e667 = phi_1554_;
                local_2 = _e665;
                local_3 = _e665;
                local_4 = _e663;
                local_5 = _e663;
                local_9 = _e663;
                local_10 = _e665;
                local_11 = _e667;
                let _e668 = (_e663 <= 2147483647u);
                let _e670 = (_e665 + _e104);
                let _e674 = (_e668 && !(((_e665 >= _e93) || (_e670 >= _e93))));
                local_1 = _e668;
                if _e674 {
                    let _e676 = ((2u * (_e167 & 3u)) + (bitcast<u32>(_e582) >> bitcast<u32>(31i)));
                    let _e678 = ((2u * (_e171 & 3u)) + (bitcast<u32>(_e598) >> bitcast<u32>(31i)));
                    let _e680 = ((2u * (_e163 & 3u)) + (bitcast<u32>(_e614) >> bitcast<u32>(31i)));
                    let _e686 = slimbvh_nodes.member[_e670].member[select(_e676, 5u, (5u < _e676))];
                    let _e692 = slimbvh_nodes.member[_e670].member[select(_e678, 5u, (5u < _e678))];
                    let _e698 = slimbvh_nodes.member[_e670].member[select(_e680, 5u, (5u < _e680))];
                    let _e699 = (_e676 ^ 1u);
                    let _e705 = slimbvh_nodes.member[_e670].member[select(_e699, 5u, (5u < _e699))];
                    let _e706 = (_e678 ^ 1u);
                    let _e712 = slimbvh_nodes.member[_e670].member[select(_e706, 5u, (5u < _e706))];
                    let _e713 = (_e680 ^ 1u);
                    let _e719 = slimbvh_nodes.member[_e670].member[select(_e713, 5u, (5u < _e713))];
                    let _e778 = ((_e698.x - _e611) * _e614);
                    let _e779 = ((_e698.y - _e611) * _e614);
                    let _e780 = ((_e698.z - _e611) * _e614);
                    let _e781 = ((_e698.w - _e611) * _e614);
                    let _e790 = ((_e719.x - _e612) * _e614);
                    let _e791 = ((_e719.y - _e612) * _e614);
                    let _e792 = ((_e719.z - _e612) * _e614);
                    let _e793 = ((_e719.w - _e612) * _e614);
                    let _e826 = max(max(max(((_e686.x - _e579) * _e582), ((_e692.x - _e595) * _e598)), _e778), _e622);
                    let _e827 = max(max(max(((_e686.y - _e579) * _e582), ((_e692.y - _e595) * _e598)), _e779), _e622);
                    let _e828 = max(max(max(((_e686.z - _e579) * _e582), ((_e692.z - _e595) * _e598)), _e780), _e622);
                    let _e829 = max(max(max(((_e686.w - _e579) * _e582), ((_e692.w - _e595) * _e598)), _e781), _e622);
                    if (_e826 <= min((min(min(((_e705.x - _e580) * _e582), ((_e712.x - _e596) * _e598)), _e790) + (max(_e790, -(_e778)) * 0.0000019073523f)), _e654.member.member_1)) {
                        phi_2011_ = (((bitcast<u32>(_e826) ^ select(0u, 4294967288u, _e636.member_1)) & 2147483640u) | 4u);
                    } else {
                        phi_2011_ = 4294967288u;
                    }
                    let _e844 = phi_2011_;
                    if (_e827 <= min((min(min(((_e705.y - _e580) * _e582), ((_e712.y - _e596) * _e598)), _e791) + (max(_e791, -(_e779)) * 0.0000019073523f)), _e654.member.member_1)) {
                        phi_2024_ = ((((bitcast<u32>(_e827) ^ select(0u, 4294967288u, _e636.member_1)) & 2147483640u) | 4u) | 1u);
                    } else {
                        phi_2024_ = 4294967288u;
                    }
                    let _e852 = phi_2024_;
                    if (_e828 <= min((min(min(((_e705.z - _e580) * _e582), ((_e712.z - _e596) * _e598)), _e792) + (max(_e792, -(_e780)) * 0.0000019073523f)), _e654.member.member_1)) {
                        phi_2037_ = ((((bitcast<u32>(_e828) ^ select(0u, 4294967288u, _e636.member_1)) & 2147483640u) | 4u) | 2u);
                    } else {
                        phi_2037_ = 4294967288u;
                    }
                    let _e860 = phi_2037_;
                    if (_e829 <= min((min(min(((_e705.w - _e580) * _e582), ((_e712.w - _e596) * _e598)), _e793) + (max(_e793, -(_e781)) * 0.0000019073523f)), _e654.member.member_1)) {
                        phi_2050_ = ((((bitcast<u32>(_e829) ^ select(0u, 4294967288u, _e636.member_1)) & 2147483640u) | 4u) | 3u);
                    } else {
                        phi_2050_ = 4294967288u;
                    }
                    let _e868 = phi_2050_;
                    if (_e844 < _e852) {
                        phi_3780_ = SlimbvhTypeG(_e844, _e852);
                    } else {
                        phi_3780_ = SlimbvhTypeG(_e852, _e844);
                    }
                    let _e873 = phi_3780_;
                    if (_e860 < _e868) {
                        phi_3792_ = SlimbvhTypeG(_e860, _e868);
                    } else {
                        phi_3792_ = SlimbvhTypeG(_e868, _e860);
                    }
                    let _e880 = phi_3792_;
                    if (_e873.member < _e880.member) {
                        phi_3804_ = SlimbvhTypeG(_e873.member, _e880.member);
                    } else {
                        phi_3804_ = SlimbvhTypeG(_e880.member, _e873.member);
                    }
                    let _e887 = phi_3804_;
                    if (_e873.member_1 < _e880.member_1) {
                        phi_3816_ = SlimbvhTypeG(_e873.member_1, _e880.member_1);
                    } else {
                        phi_3816_ = SlimbvhTypeG(_e880.member_1, _e873.member_1);
                    }
                    let _e894 = phi_3816_;
                    if (_e894.member < _e887.member_1) {
                        phi_3828_ = SlimbvhTypeG(_e894.member, _e887.member_1);
                    } else {
                        phi_3828_ = SlimbvhTypeG(_e887.member_1, _e894.member);
                    }
                    let _e901 = phi_3828_;
                    let _e916 = (((_e887.member & 7u) | ((_e901.member & 7u) << bitcast<u32>(3u))) | (((_e901.member_1 & 7u) | ((_e894.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                    if (_e916 == 0u) {
                        let _e934 = (_e663 - 1u);
                        let _e937 = local[(_e934 % 128u)];
                        let _e938 = (_e937 & 511u);
                        let _e940 = (_e938 >> bitcast<u32>(3u));
                        let _e943 = ((_e940 == 0u) || (_e934 == 4294967295u));
                        if _e943 {
                        } else {
                            local[(_e934 % 128u)] = (((_e937 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e940);
                        }
                        phi_2136_ = select(_e663, _e934, _e943);
                        phi_2137_ = (((_e937 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e938 & 3u) & 3u));
                    } else {
                        let _e919 = (_e916 >> bitcast<u32>(3u));
                        if (_e919 == 0u) {
                            phi_2131_ = _e663;
                        } else {
                            local[(_e663 % 128u)] = ((_e670 << bitcast<u32>(9u)) | _e919);
                            phi_2131_ = (_e663 + 1u);
                        }
                        let _e928 = phi_2131_;
                        phi_2136_ = _e928;
                        phi_2137_ = ((_e670 << bitcast<u32>(2i)) | ((_e916 & 3u) & 3u));
                    }
                    let _e958 = phi_2136_;
                    let _e960 = phi_2137_;
                    let _e962 = (_e960 >> bitcast<u32>(2i));
                    if (_e962 < _e93) {
                        let _e968 = slimbvh_nodes.member[_e962].member_1[(_e960 & 3u)];
                        phi_2161_ = _e968;
                    } else {
                        phi_2161_ = 2147483648u;
                    }
                    let _e970 = phi_2161_;
                    let _e971 = (_e667 - 1u);
                    phi_1550_ = select(_e958, 4294967295u, (_e971 == 0u));
                    phi_1553_ = _e970;
                    phi_1555_ = _e971;
                } else {
                    phi_1550_ = u32();
                    phi_1553_ = u32();
                    phi_1555_ = u32();
                }
                let _e975 = phi_1550_;
                let _e977 = phi_1553_;
                let _e979 = phi_1555_;
                continue;
                continuing {
                    phi_1549_ = _e975;
                    phi_1552_ = _e977;
                    phi_1554_ = _e979;
                    break if !(_e674);
                }
            }
            let _e982 = local_1;
            if _e982 {
                let _e984 = local_2;
                let _e987 = local_3;
                phi_2178_ = _e654;
                phi_2181_ = SlimbvhTypeG(0u, ((_e987 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e994 = phi_2178_;
                    let _e996 = phi_2181_;
                    local_6 = _e994;
                    local_8 = _e994;
                    if (_e996.member < _e996.member_1) {
                        phi_2182_ = SlimbvhTypeG((_e996.member + 1u), _e996.member_1);
                        phi_2204_ = SlimbvhTypeG(1u, _e996.member);
                    } else {
                        phi_2182_ = _e996;
                        phi_2204_ = SlimbvhTypeG(0u, SlimbvhTypeG().member_1);
                    }
                    let _e1009 = phi_2182_;
                    let _e1011 = phi_2204_;
                    let _e1015 = (bitcast<i32>(_e1011.member) != 0i);
                    if _e1015 {
                        let _e1016 = (((_e984 & 268435455u) + _e107) + _e1011.member_1);
                        let _e1017 = (_e1016 / 2u);
                        let _e1018 = (_e1016 % 2u);
                        let _e1019 = (_e1017 >= arrayLength((&slimbvh_triangles.member)));
                        if _e1019 {
                            phi_2284_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e1020 = (2u * _e1018);
                            let _e1024 = slimbvh_triangles.member[_e1017][_e1020];
                            let _e1029 = slimbvh_triangles.member[_e1017][(_e1020 + 1u)];
                            let _e1034 = slimbvh_triangles.member[_e1017][(_e1020 + 2u)];
                            if (_e1018 == 0u) {
                                phi_2283_ = array<vec4<f32>, 3>(_e1024, _e1029, _e1034);
                            } else {
                                phi_2283_ = array<vec4<f32>, 3>(vec4<f32>(_e1024.z, _e1024.w, _e1029.x, _e1029.y), vec4<f32>(_e1029.z, _e1029.w, _e1034.x, _e1034.y), vec4<f32>(_e1034.z, _e1034.w, 0f, 0f));
                            }
                            let _e1052 = phi_2283_;
                            phi_2284_ = _e1052;
                        }
                        let _e1054 = phi_2284_;
                        let _e1057 = bitcast<u32>(_e1054[2].y);
                        if _e1019 {
                            phi_2365_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e1058 = (2u * _e1018);
                            let _e1062 = slimbvh_triangles.member[_e1017][_e1058];
                            let _e1067 = slimbvh_triangles.member[_e1017][(_e1058 + 1u)];
                            let _e1072 = slimbvh_triangles.member[_e1017][(_e1058 + 2u)];
                            if (_e1018 == 0u) {
                                phi_2364_ = array<vec4<f32>, 3>(_e1062, _e1067, _e1072);
                            } else {
                                phi_2364_ = array<vec4<f32>, 3>(vec4<f32>(_e1062.z, _e1062.w, _e1067.x, _e1067.y), vec4<f32>(_e1067.z, _e1067.w, _e1072.x, _e1072.y), vec4<f32>(_e1072.z, _e1072.w, 0f, 0f));
                            }
                            let _e1090 = phi_2364_;
                            phi_2365_ = _e1090;
                        }
                        let _e1092 = phi_2365_;
                        if _e172 {
                            phi_2389_ = array<f32, 3>(_e1092[0].x, _e1092[0].y, _e1092[0].z);
                        } else {
                            if (_e167 == 1u) {
                                phi_2388_ = array<f32, 3>(_e1092[0].y, _e1092[0].z, _e1092[0].x);
                            } else {
                                phi_2388_ = array<f32, 3>(_e1092[0].z, _e1092[0].x, _e1092[0].y);
                            }
                            let _e1115 = phi_2388_;
                            phi_2389_ = _e1115;
                        }
                        let _e1118 = phi_2389_;
                        if _e172 {
                            phi_2404_ = array<f32, 3>(_e1092[0].w, _e1092[1].x, _e1092[1].y);
                        } else {
                            if (_e167 == 1u) {
                                phi_2403_ = array<f32, 3>(_e1092[1].x, _e1092[1].y, _e1092[0].w);
                            } else {
                                phi_2403_ = array<f32, 3>(_e1092[1].y, _e1092[0].w, _e1092[1].x);
                            }
                            let _e1123 = phi_2403_;
                            phi_2404_ = _e1123;
                        }
                        let _e1126 = phi_2404_;
                        if _e172 {
                            phi_2419_ = array<f32, 3>(_e1092[1].z, _e1092[1].w, _e1092[2].x);
                        } else {
                            if (_e167 == 1u) {
                                phi_2418_ = array<f32, 3>(_e1092[1].w, _e1092[2].x, _e1092[1].z);
                            } else {
                                phi_2418_ = array<f32, 3>(_e1092[2].x, _e1092[1].z, _e1092[1].w);
                            }
                            let _e1131 = phi_2418_;
                            phi_2419_ = _e1131;
                        }
                        let _e1134 = phi_2419_;
                        let _e1148 = (_e1118[2] - _e555.member[2]);
                        let _e1151 = (((_e1118[0] - _e555.member[0]) * _e610) - (_e1148 * _e578));
                        let _e1154 = (((_e1118[1] - _e555.member[1]) * _e610) - (_e1148 * _e594));
                        let _e1157 = (_e1126[2] - _e555.member[2]);
                        let _e1160 = (((_e1126[0] - _e555.member[0]) * _e610) - (_e1157 * _e578));
                        let _e1163 = (((_e1126[1] - _e555.member[1]) * _e610) - (_e1157 * _e594));
                        let _e1166 = (_e1134[2] - _e555.member[2]);
                        let _e1169 = (((_e1134[0] - _e555.member[0]) * _e610) - (_e1166 * _e578));
                        let _e1172 = (((_e1134[1] - _e555.member[1]) * _e610) - (_e1166 * _e594));
                        let _e1173 = (_e1169 * _e1163);
                        let _e1174 = (_e1172 * _e1160);
                        let _e1175 = (_e1151 * _e1172);
                        let _e1176 = (_e1154 * _e1169);
                        let _e1177 = (_e1160 * _e1154);
                        let _e1178 = (_e1163 * _e1151);
                        let _e1183 = (((_e1173 >= _e1174) && (_e1175 >= _e1176)) && (_e1177 >= _e1178));
                        let _e1189 = (_e1183 || (((_e1173 <= _e1174) && (_e1175 <= _e1176)) && (_e1177 <= _e1178)));
                        if _e1189 {
                            let _e1191 = select(-1f, 1f, _e1183);
                            let _e1193 = ((_e1173 - _e1174) * _e1191);
                            let _e1195 = select(0f, _e1193, (_e1193 > 0f));
                            let _e1197 = ((_e1175 - _e1176) * _e1191);
                            let _e1199 = select(0f, _e1197, (_e1197 > 0f));
                            let _e1201 = ((_e1177 - _e1178) * _e1191);
                            let _e1203 = select(0f, _e1201, (_e1201 > 0f));
                            let _e1205 = ((_e1195 + _e1199) + _e1203);
                            let _e1220 = ((min(min(_e1118[0], _e1126[0]), _e1134[0]) - _e579) * _e582);
                            let _e1221 = ((max(max(_e1118[0], _e1126[0]), _e1134[0]) - _e580) * _e582);
                            let _e1222 = vec4<f32>(_e1220, f32(), _e1221, f32());
                            let _e1225 = ((min(min(_e1118[1], _e1126[1]), _e1134[1]) - _e595) * _e598);
                            let _e1226 = ((max(max(_e1118[1], _e1126[1]), _e1134[1]) - _e596) * _e598);
                            let _e1227 = vec4<f32>(_e1225, f32(), _e1226, f32());
                            let _e1230 = ((min(min(_e1118[2], _e1126[2]), _e1134[2]) - _e611) * _e614);
                            let _e1231 = ((max(max(_e1118[2], _e1126[2]), _e1134[2]) - _e612) * _e614);
                            let _e1232 = vec4<f32>(_e1230, f32(), _e1231, f32());
                            let _e1233 = vec4<f32>(_e1221, f32(), _e1220, f32());
                            let _e1235 = vec4<f32>(_e1226, f32(), _e1225, f32());
                            let _e1237 = vec4<f32>(_e1231, f32(), _e1230, f32());
                            let _e1246 = max(max(min(_e1222, _e1233).x, min(_e1227, _e1235).x), min(_e1232, _e1237).x);
                            let _e1251 = min(min(max(_e1222, _e1233).x, max(_e1227, _e1235).x), max(_e1232, _e1237).x);
                            let _e1256 = max(_e1246, _e622);
                            let _e1278 = (((((_e1189 && (_e1205 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1151, _e1160), _e1169) <= 0f) && (max(max(_e1151, _e1160), _e1169) >= 0f))) && ((min(min(_e1154, _e1163), _e1172) <= 0f) && (max(max(_e1154, _e1163), _e1172) >= 0f))) && (_e1256 <= (_e1251 + (max(max(_e1232, _e1237).x, -(min(_e1232, _e1237).x)) * 0.0000019073523f)))) && (_e1256 <= _e994.member.member_1));
                            if _e1278 {
                                let _e1283 = (_e1126[0] - _e1118[0]);
                                let _e1284 = (_e1126[1] - _e1118[1]);
                                let _e1285 = (_e1126[2] - _e1118[2]);
                                let _e1286 = vec3<f32>(_e1283, _e1284, _e1285);
                                let _e1287 = (_e1134[0] - _e1126[0]);
                                let _e1288 = (_e1134[1] - _e1126[1]);
                                let _e1289 = (_e1134[2] - _e1126[2]);
                                let _e1290 = vec3<f32>(_e1287, _e1288, _e1289);
                                let _e1291 = (_e1118[0] - _e1134[0]);
                                let _e1292 = (_e1118[1] - _e1134[1]);
                                let _e1293 = (_e1118[2] - _e1134[2]);
                                let _e1294 = vec3<f32>(_e1291, _e1292, _e1293);
                                let _e1305 = max(max(bitcast<f32>((bitcast<u32>(_e1283) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1284) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1285) & 2147483647u)));
                                let _e1316 = max(max(bitcast<f32>((bitcast<u32>(_e1287) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1288) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1289) & 2147483647u)));
                                let _e1329 = max(max(_e1305, _e1316), max(max(bitcast<f32>((bitcast<u32>(_e1291) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1292) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1293) & 2147483647u))));
                                if (_e1305 == _e1329) {
                                    phi_2778_ = _e1163;
                                    phi_2779_ = _e1160;
                                    phi_2780_ = _e1154;
                                    phi_2781_ = _e1151;
                                    phi_2782_ = vec3<f32>(_e1118[0], _e1118[1], _e1118[2]);
                                    phi_2783_ = _e1294;
                                    phi_2784_ = _e1290;
                                    phi_2785_ = _e1286;
                                } else {
                                    let _e1331 = (_e1316 == _e1329);
                                    let _e1336 = vec3(_e1331);
                                    phi_2778_ = select(_e1154, _e1172, _e1331);
                                    phi_2779_ = select(_e1151, _e1169, _e1331);
                                    phi_2780_ = select(_e1172, _e1163, _e1331);
                                    phi_2781_ = select(_e1169, _e1160, _e1331);
                                    phi_2782_ = select(vec3<f32>(_e1134[0], _e1134[1], _e1134[2]), vec3<f32>(_e1126[0], _e1126[1], _e1126[2]), _e1336);
                                    phi_2783_ = select(_e1290, _e1286, _e1336);
                                    phi_2784_ = select(_e1286, _e1294, _e1336);
                                    phi_2785_ = select(_e1294, _e1290, _e1336);
                                }
                                let _e1342 = phi_2778_;
                                let _e1344 = phi_2779_;
                                let _e1346 = phi_2780_;
                                let _e1348 = phi_2781_;
                                let _e1350 = phi_2782_;
                                let _e1352 = phi_2783_;
                                let _e1354 = phi_2784_;
                                let _e1356 = phi_2785_;
                                let _e1363 = ((_e1354.y * _e1352.z) - (_e1352.y * _e1354.z));
                                let _e1368 = ((_e1354.z * _e1352.x) - (_e1352.z * _e1354.x));
                                let _e1371 = ((_e1354.x * _e1352.y) - (_e1352.x * _e1354.y));
                                let _e1374 = ((_e1195 >= _e1199) && (_e1195 >= _e1203));
                                let _e1375 = (_e1199 >= _e1203);
                                let _e1389 = (((_e1363 * (select(select(_e1134[0], _e1126[0], _e1375), _e1118[0], _e1374) - _e555.member[0])) + (_e1368 * (select(select(_e1134[1], _e1126[1], _e1375), _e1118[1], _e1374) - _e555.member[1]))) + (_e1371 * (select(select(_e1134[2], _e1126[2], _e1375), _e1118[2], _e1374) - _e555.member[2])));
                                let _e1394 = (((_e1363 * _e578) + (_e1368 * _e594)) + (_e1371 * _e610));
                                let _e1395 = (_e1344 - _e1348);
                                let _e1396 = (_e1342 - _e1346);
                                let _e1399 = ((_e1395 * _e1395) + (_e1396 * _e1396));
                                let _e1406 = (-(((_e1348 * _e1395) + (_e1346 * _e1396))) / select(0.000000000000000000000000000000000000011754944f, _e1399, (_e1399 > 0.000000000000000000000000000000000000011754944f)));
                                let _e1408 = select(1f, _e1406, (_e1406 < 1f));
                                let _e1410 = select(0f, _e1408, (_e1408 > 0f));
                                let _e1419 = ((_e1350.x + (_e1356.x * _e1410)) - _e555.member[0]);
                                let _e1422 = ((_e1350.y + (_e1356.y * _e1410)) - _e555.member[1]);
                                let _e1425 = ((_e1350.z + (_e1356.z * _e1410)) - _e555.member[2]);
                                let _e1490 = ((bitcast<f32>((bitcast<u32>(((((_e1363 * _e1419) + (_e1368 * _e1422)) + (_e1371 * _e1425)) - _e1389)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1419) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1422) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1425) & 2147483647u))), _e1329)) * max(max(bitcast<f32>((bitcast<u32>(_e1363) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1368) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1371) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1394) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1354.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1354.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1354.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1352.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1352.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1352.z) & 2147483647u)))))));
                                let _e1491 = (_e1389 / _e1394);
                                if (_e1278 && !(_e1490)) {
                                    let _e1494 = (_e1425 / _e610);
                                    let _e1502 = (((_e1363 * (_e1419 - (_e578 * _e1494))) + (_e1368 * (_e1422 - (_e594 * _e1494)))) / _e1394);
                                    phi_2964_ = select(select(_e1494, (_e1494 + _e1502), (bitcast<f32>((bitcast<u32>(_e1502) & 2147483647u)) <= _e1329)), _e1491, _e1490);
                                } else {
                                    phi_2964_ = _e1491;
                                }
                                let _e1511 = phi_2964_;
                                let _e1513 = select(_e1251, _e1511, (_e1511 < _e1251));
                                let _e1515 = select(_e1246, _e1513, (_e1513 > _e1246));
                                let _e1518 = select(_e1515, 0f, (bitcast<u32>(_e1515) == 2147483648u));
                                let _e1519 = (1f / _e1205);
                                phi_2990_ = SlimbvhTypeH(_e1518, (_e1199 * _e1519), (_e1203 * _e1519), ((_e1278 && (_e1518 >= _e622)) && (_e1518 <= _e994.member.member_1)));
                                phi_2991_ = SlimbvhTypeH();
                            } else {
                                phi_2990_ = SlimbvhTypeH();
                                phi_2991_ = SlimbvhTypeH(0f, 0f, 0f, _e1278);
                            }
                            let _e1528 = phi_2990_;
                            let _e1530 = phi_2991_;
                            phi_2994_ = _e1528;
                            phi_2995_ = _e1530;
                            phi_2996_ = select(true, false, _e1278);
                        } else {
                            phi_2994_ = SlimbvhTypeH();
                            phi_2995_ = SlimbvhTypeH(0f, 0f, 0f, _e1189);
                            phi_2996_ = true;
                        }
                        let _e1533 = phi_2994_;
                        let _e1535 = phi_2995_;
                        let _e1537 = phi_2996_;
                        if _e1537 {
                            phi_3000_ = _e1535;
                        } else {
                            phi_3000_ = _e1533;
                        }
                        let _e1539 = phi_3000_;
                        if _e1539.member_3 {
                            phi_3009_ = SlimbvhTypeI(_e1539.member, _e1539.member_1, _e1539.member_2, _e1057);
                        } else {
                            phi_3009_ = _e89;
                        }
                        let _e1546 = phi_3009_;
                        if (_e1546.member_3 != 4294967295u) {
                            let _e1552 = slimbvh_target.member[0u][0u];
                            let _e1556 = slimbvh_target.member[0u][1u];
                            let _e1560 = slimbvh_target.member[0u][2u];
                            let _e1564 = slimbvh_target.member[0u][3u];
                            let _e1568 = slimbvh_target.member[1u][0u];
                            let _e1572 = slimbvh_target.member[1u][1u];
                            let _e1576 = slimbvh_target.member[1u][2u];
                            let _e1580 = slimbvh_target.member[1u][3u];
                            let _e1581 = bitcast<f32>(_e1552);
                            let _e1582 = bitcast<f32>(_e1556);
                            let _e1583 = bitcast<f32>(_e1560);
                            let _e1585 = bitcast<f32>(_e1568);
                            let _e1586 = array<u32, 3>(_e1572, _e1576, _e1580);
                            if (_e125 < -126i) {
                                phi_3062_ = -126i;
                            } else {
                                phi_3062_ = select(_e125, 127i, (_e125 > 127i));
                            }
                            let _e1592 = phi_3062_;
                            let _e1597 = bitcast<f32>((bitcast<u32>((_e1592 + 127i)) << bitcast<u32>(23i)));
                            let _e1603 = bitcast<f32>((bitcast<u32>(((_e125 - _e1592) + 127i)) << bitcast<u32>(23i)));
                            if (_e1564 == 0u) {
                                phi_3202_ = SlimbvhTypeK(array<f32, 3>(_e1581, _e1582, _e1583), _e1564, _e1585, _e1586);
                            } else {
                                let _e1605 = bitcast<u32>(_e1581);
                                let _e1607 = ((_e1605 & 2139095040u) != 0u);
                                let _e1622 = bitcast<u32>(_e1582);
                                let _e1624 = ((_e1622 & 2139095040u) != 0u);
                                let _e1639 = bitcast<u32>(_e1583);
                                let _e1641 = ((_e1639 & 2139095040u) != 0u);
                                let _e1657 = bitcast<u32>(_e1585);
                                let _e1659 = ((_e1657 & 2139095040u) != 0u);
                                phi_3202_ = SlimbvhTypeK(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1605 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1605 & 2147483648u))), _e1581, _e1607) * _e1597) * select(0.00000011920929f, 1f, _e1607)) * _e1603), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1622 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1622 & 2147483648u))), _e1582, _e1624) * _e1597) * select(0.00000011920929f, 1f, _e1624)) * _e1603), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1639 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1639 & 2147483648u))), _e1583, _e1641) * _e1597) * select(0.00000011920929f, 1f, _e1641)) * _e1603)), _e1564, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1657 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1657 & 2147483648u))), _e1585, _e1659) * _e1597) * select(0.00000011920929f, 1f, _e1659)) * _e1603), _e1586);
                            }
                            let _e1676 = phi_3202_;
                            if (_e1057 == _e626) {
                                phi_3528_ = false;
                            } else {
                                let _e1678 = (_e1057 / 16u);
                                if (_e1678 < arrayLength((&slimbvh_sides.member))) {
                                    let _e1681 = slimbvh_sides.member[_e1678];
                                    phi_3226_ = _e1681;
                                } else {
                                    phi_3226_ = 0u;
                                }
                                let _e1683 = phi_3226_;
                                let _e1692 = (bitcast<i32>((_e1683 << bitcast<u32>(((30u - ((_e1057 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                let _e1693 = (_e1692 == 0i);
                                if _e1693 {
                                    phi_3527_ = true;
                                } else {
                                    if _e172 {
                                        phi_3255_ = vec3<f32>(_e1118[0], _e1118[1], _e1118[2]);
                                    } else {
                                        if (_e167 == 1u) {
                                            phi_3254_ = vec3<f32>(_e1118[2], _e1118[0], _e1118[1]);
                                        } else {
                                            phi_3254_ = vec3<f32>(_e1118[1], _e1118[2], _e1118[0]);
                                        }
                                        let _e1698 = phi_3254_;
                                        phi_3255_ = _e1698;
                                    }
                                    let _e1701 = phi_3255_;
                                    if _e172 {
                                        phi_3273_ = vec3<f32>(_e1126[0], _e1126[1], _e1126[2]);
                                    } else {
                                        if (_e167 == 1u) {
                                            phi_3272_ = vec3<f32>(_e1126[2], _e1126[0], _e1126[1]);
                                        } else {
                                            phi_3272_ = vec3<f32>(_e1126[1], _e1126[2], _e1126[0]);
                                        }
                                        let _e1706 = phi_3272_;
                                        phi_3273_ = _e1706;
                                    }
                                    let _e1709 = phi_3273_;
                                    if _e172 {
                                        phi_3291_ = vec3<f32>(_e1134[0], _e1134[1], _e1134[2]);
                                    } else {
                                        if (_e167 == 1u) {
                                            phi_3290_ = vec3<f32>(_e1134[2], _e1134[0], _e1134[1]);
                                        } else {
                                            phi_3290_ = vec3<f32>(_e1134[1], _e1134[2], _e1134[0]);
                                        }
                                        let _e1714 = phi_3290_;
                                        phi_3291_ = _e1714;
                                    }
                                    let _e1717 = phi_3291_;
                                    let _e1720 = (_e1709.x - _e1701.x);
                                    let _e1723 = (_e1709.y - _e1701.y);
                                    let _e1726 = (_e1709.z - _e1701.z);
                                    let _e1728 = (_e1717.x - _e1701.x);
                                    let _e1730 = (_e1717.y - _e1701.y);
                                    let _e1732 = (_e1717.z - _e1701.z);
                                    if (_e1676.member_1 == 1u) {
                                        phi_3327_ = (vec3<f32>(_e1676.member[0], _e1676.member[1], _e1676.member[2]) - _e1701);
                                    } else {
                                        phi_3327_ = vec3<f32>(_e1676.member[0], _e1676.member[1], _e1676.member[2]);
                                    }
                                    let _e1747 = phi_3327_;
                                    let _e1753 = bitcast<f32>((bitcast<u32>((_e1720 * _e1730)) ^ _e1676.member_3[0]));
                                    let _e1757 = bitcast<f32>((bitcast<u32>((_e1723 * _e1728)) ^ _e1676.member_3[0]));
                                    let _e1761 = bitcast<f32>((bitcast<u32>((_e1723 * _e1732)) ^ _e1676.member_3[0]));
                                    let _e1765 = bitcast<f32>((bitcast<u32>((_e1726 * _e1730)) ^ _e1676.member_3[0]));
                                    let _e1769 = bitcast<f32>((bitcast<u32>((_e1726 * _e1728)) ^ _e1676.member_3[0]));
                                    let _e1773 = bitcast<f32>((bitcast<u32>((_e1720 * _e1732)) ^ _e1676.member_3[0]));
                                    let _e1774 = (_e1761 - _e1765);
                                    let _e1775 = (_e1769 - _e1773);
                                    let _e1776 = (_e1753 - _e1757);
                                    let _e1800 = (bitcast<f32>((bitcast<u32>(_e1761) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1765) & 2147483647u)));
                                    let _e1807 = (bitcast<f32>((bitcast<u32>(_e1769) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1773) & 2147483647u)));
                                    let _e1814 = (bitcast<f32>((bitcast<u32>(_e1753) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1757) & 2147483647u)));
                                    if (_e1676.member_2 == 0f) {
                                        phi_3509_ = 0f;
                                    } else {
                                        let _e1844 = bitcast<f32>((bitcast<u32>(_e1774) & 2147483647u));
                                        let _e1847 = bitcast<f32>((bitcast<u32>(_e1775) & 2147483647u));
                                        let _e1850 = bitcast<f32>((bitcast<u32>(_e1776) & 2147483647u));
                                        let _e1852 = select(_e1850, _e1847, (_e1847 > _e1850));
                                        let _e1856 = select(_e1850, _e1847, (_e1847 < _e1850));
                                        let _e1860 = select(_e1847, _e1844, (_e1844 < _e1847));
                                        let _e1862 = select(_e1847, _e1844, (_e1844 > _e1847));
                                        let _e1864 = select(_e1850, _e1862, (_e1862 < _e1850));
                                        phi_3509_ = bitcast<f32>((bitcast<u32>((_e1676.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1852, _e1844, (_e1844 > _e1852)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1864, _e1860, (_e1860 > _e1864)))) ^ _e1676.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1856, _e1844, (_e1844 < _e1856)))) ^ _e1676.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1800 + _e1807) + _e1814))) ^ _e1676.member_3[0]))) * 1.0000005f)) ^ _e1676.member_3[0])))) ^ _e1676.member_3[0]));
                                    }
                                    let _e1891 = phi_3509_;
                                    phi_3527_ = (_e1693 || !(((((bitcast<f32>((bitcast<u32>((_e1747.x * _e1774)) ^ _e1676.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1747.y * _e1775)) ^ _e1676.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1747.z * _e1776)) ^ _e1676.member_3[0]))) * f32(-(_e1692))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1747.x) & 2147483647u)) * _e1800)) ^ _e1676.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1747.y) & 2147483647u)) * _e1807)) ^ _e1676.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1747.z) & 2147483647u)) * _e1814)) ^ _e1676.member_3[0]))))) ^ _e1676.member_3[0])) + _e1891) + 0.0000000000000000000000000000000000001880791f))));
                                }
                                let _e1905 = phi_3527_;
                                phi_3528_ = _e1905;
                            }
                            let _e1907 = phi_3528_;
                            if _e1907 {
                                if (_e1546.member < _e994.member.member.member) {
                                    phi_3548_ = true;
                                } else {
                                    if (_e1546.member == _e994.member.member.member) {
                                        phi_3547_ = (_e1546.member_3 < _e994.member.member.member_3);
                                    } else {
                                        phi_3547_ = false;
                                    }
                                    let _e1919 = phi_3547_;
                                    phi_3548_ = _e1919;
                                }
                                let _e1921 = phi_3548_;
                                if _e1921 {
                                    phi_3555_ = SlimbvhTypeO(SlimbvhTypeL(_e1546, _e1546.member), _e994.member_1);
                                } else {
                                    phi_3555_ = _e994;
                                }
                                let _e1927 = phi_3555_;
                                if _e1927.member_1 {
                                    phi_3561_ = SlimbvhTypeO(SlimbvhTypeL(_e1927.member.member, bitcast<f32>(4286578687u)), _e1927.member_1);
                                } else {
                                    phi_3561_ = _e1927;
                                }
                                let _e1936 = phi_3561_;
                                phi_3562_ = _e1936;
                            } else {
                                phi_3562_ = _e994;
                            }
                            let _e1938 = phi_3562_;
                            phi_3563_ = _e1938;
                        } else {
                            phi_3563_ = _e994;
                        }
                        let _e1940 = phi_3563_;
                        phi_2179_ = _e1940;
                    } else {
                        phi_2179_ = SlimbvhTypeO();
                    }
                    let _e1942 = phi_2179_;
                    continue;
                    continuing {
                        phi_2178_ = _e1942;
                        phi_2181_ = _e1009;
                        break if !(_e1015);
                    }
                }
                let _e1945 = local_4;
                let _e1946 = (_e1945 - 1u);
                let _e1949 = local[(_e1946 % 128u)];
                let _e1950 = (_e1949 & 511u);
                let _e1952 = (_e1950 >> bitcast<u32>(3u));
                let _e1955 = ((_e1952 == 0u) || (_e1946 == 4294967295u));
                if _e1955 {
                } else {
                    local[(_e1946 % 128u)] = (((_e1949 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1952);
                }
                let _e1962 = local_5;
                let _e1970 = (((_e1949 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1950 & 3u) & 3u));
                let _e1972 = (_e1970 >> bitcast<u32>(2i));
                if (_e1972 < _e93) {
                    let _e1978 = slimbvh_nodes.member[_e1972].member_1[(_e1970 & 3u)];
                    phi_3622_ = _e1978;
                } else {
                    phi_3622_ = 2147483648u;
                }
                let _e1980 = phi_3622_;
                let _e1982 = local_6;
                let _e2244 = local_8;
                phi_3631_ = _e2244;
                phi_3632_ = select(select(_e1962, _e1946, _e1955), 4294967295u, (_e622 > _e1982.member.member_1));
                phi_3633_ = _e1980;
            } else {
                phi_3631_ = _e654;
                let _e2247 = local_9;
                phi_3632_ = _e2247;
                let _e2250 = local_10;
                phi_3633_ = _e2250;
            }
            let _e1988 = phi_3631_;
            let _e1990 = phi_3632_;
            let _e1992 = phi_3633_;
            phi_1534_ = _e1988;
            phi_1537_ = _e1990;
            phi_1539_ = _e1992;
            let _e2256 = local_11;
            phi_1541_ = _e2256;
        } else {
            phi_1534_ = SlimbvhTypeO();
            phi_1537_ = u32();
            phi_1539_ = u32();
            phi_1541_ = u32();
        }
        let _e1994 = phi_1534_;
        let _e1996 = phi_1537_;
        let _e1998 = phi_1539_;
        let _e2000 = phi_1541_;
        continue;
        continuing {
            phi_1533_ = _e1994;
            phi_1536_ = _e1996;
            phi_1538_ = _e1998;
            phi_1540_ = _e2000;
            break if !(_e661);
        }
    }
    let _e2003 = local_7;
    if (_e2003.member.member.member_3 != 4294967295u) {
        let _e2009 = -((_e125 + _e555.member_4));
        let _e2010 = bitcast<u32>(_e2003.member.member.member);
        let _e2014 = (bitcast<i32>((_e2010 >> bitcast<u32>(23i))) & 255i);
        let _e2015 = (_e2014 + _e2009);
        if (_e2014 == 255i) {
            phi_3690_ = _e2003.member.member.member;
        } else {
            if (_e2014 > 0i) {
                if (_e2015 > 0i) {
                    let _e2019 = (_e2015 < 255i);
                    if _e2019 {
                        phi_3669_ = bitcast<f32>((_e2010 + bitcast<u32>((_e2009 << bitcast<u32>(23i)))));
                    } else {
                        phi_3669_ = f32();
                    }
                    let _e2026 = phi_3669_;
                    phi_3671_ = _e2026;
                    phi_3672_ = select(true, false, _e2019);
                } else {
                    phi_3671_ = f32();
                    phi_3672_ = true;
                }
                let _e2029 = phi_3671_;
                let _e2031 = phi_3672_;
                phi_3673_ = _e2029;
                phi_3674_ = _e2031;
            } else {
                phi_3673_ = f32();
                phi_3674_ = true;
            }
            let _e2033 = phi_3673_;
            let _e2035 = phi_3674_;
            if _e2035 {
                let _e2036 = (_e2010 & 2147483648u);
                let _e2043 = ((_e2010 & 8388607u) | (select(0u, 1u, ((_e2010 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e2047 = (_e2043 == 0u);
                if _e2047 {
                    phi_4109_ = bitcast<f32>(_e2036);
                } else {
                    let _e2052 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2043)), 32u, _e2047) - 8u);
                    let _e2055 = (_e2043 << bitcast<u32>((_e2052 & 31u)));
                    let _e2057 = ((_e2015 + select(0i, 1i, (_e2014 == 0i))) - bitcast<i32>(_e2052));
                    if (_e2057 >= 255i) {
                        phi_4099_ = bitcast<f32>((_e2036 | 2139095040u));
                        phi_4100_ = f32();
                        phi_4101_ = true;
                    } else {
                        let _e2059 = (_e2057 > 0i);
                        if _e2059 {
                            phi_4093_ = bitcast<f32>(((_e2036 | (bitcast<u32>(_e2057) << bitcast<u32>(23i))) | (_e2055 & 8388607u)));
                            phi_4094_ = f32();
                        } else {
                            if (_e2057 < -24i) {
                                phi_4059_ = 26u;
                            } else {
                                phi_4059_ = bitcast<u32>((1i - _e2057));
                            }
                            let _e2064 = phi_4059_;
                            let _e2065 = (_e2064 & 31u);
                            let _e2067 = (_e2055 >> bitcast<u32>(_e2065));
                            let _e2071 = (_e2055 & ((1u << bitcast<u32>(_e2065)) - 1u));
                            let _e2075 = (1u << bitcast<u32>(((_e2064 - 1u) & 31u)));
                            if (_e2071 > _e2075) {
                                phi_4080_ = true;
                            } else {
                                if (_e2071 == _e2075) {
                                    phi_4077_ = ((_e2067 & 1u) == 1u);
                                } else {
                                    phi_4077_ = false;
                                }
                                let _e2081 = phi_4077_;
                                phi_4080_ = _e2081;
                            }
                            let _e2083 = phi_4080_;
                            phi_4093_ = f32();
                            phi_4094_ = bitcast<f32>((_e2036 | (_e2067 + select(0u, 1u, _e2083))));
                        }
                        let _e2096 = phi_4093_;
                        let _e2098 = phi_4094_;
                        phi_4099_ = _e2096;
                        phi_4100_ = _e2098;
                        phi_4101_ = _e2059;
                    }
                    let _e2102 = phi_4099_;
                    let _e2104 = phi_4100_;
                    let _e2106 = phi_4101_;
                    phi_4109_ = select(_e2104, _e2102, _e2106);
                }
                let _e2110 = phi_4109_;
                phi_3689_ = _e2110;
            } else {
                phi_3689_ = _e2033;
            }
            let _e2112 = phi_3689_;
            phi_3690_ = _e2112;
        }
        let _e2114 = phi_3690_;
        let _e2115 = bitcast<u32>(_e2114);
        if ((_e2115 & 2147483647u) >= 2139095040u) {
            phi_3702_ = bitcast<f32>(((_e2115 & 2147483648u) | 2139095039u));
        } else {
            phi_3702_ = _e2114;
        }
        let _e2122 = phi_3702_;
        phi_3707_ = SlimbvhTypeI(_e2122, _e2003.member.member.member_1, _e2003.member.member.member_2, _e2003.member.member.member_3);
    } else {
        phi_3707_ = _e89;
    }
    let _e2127 = phi_3707_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2127.member), bitcast<u32>(_e2127.member_1), bitcast<u32>(_e2127.member_2), _e2127.member_3);
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
