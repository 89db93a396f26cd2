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
    member: array<array<vec4<f32>, 4>>,
}

struct SlimbvhTypeL {
    member: vec4<f32>,
}

struct SlimbvhTypeM {
    member: vec2<u32>,
}

struct SlimbvhTypeN {
    member: SlimbvhTypeJ,
    member_1: bool,
}

@group(0) @binding(0) 
var<uniform> slimbvh_exponent: SlimbvhTypeA;

@group(0) @binding(2) 
var<storage> slimbvh_triangles: SlimbvhTypeB;

@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeK;

@group(0) @binding(3) 
var<storage> slimbvh_sides: SlimbvhTypeC;

@group(0) @binding(4) 
var<uniform> slimbvh_target: SlimbvhTypeH;

var<private> slimbvh_origin: SlimbvhTypeL;

var<private> slimbvh_direction: SlimbvhTypeL;

var<private> slimbvh_question: SlimbvhTypeM;

var<private> slimbvh_hit: SlimbvhTypeA;

fn slimbvh_trace() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_444_: u32;
    var phi_450_: u32;
    var phi_456_: u32;
    var phi_721_: i32;
    var phi_732_: i32;
    var phi_846_: i32;
    var phi_975_: i32;
    var phi_997_: u32;
    var phi_998_: u32;
    var phi_999_: bool;
    var phi_1033_: i32;
    var phi_1055_: u32;
    var phi_1056_: u32;
    var phi_1057_: bool;
    var phi_618_: i32;
    var phi_624_: u32;
    var phi_643_: u32;
    var phi_644_: u32;
    var phi_645_: bool;
    var phi_663_: i32;
    var phi_669_: u32;
    var phi_688_: u32;
    var phi_689_: u32;
    var phi_690_: bool;
    var phi_1067_: SlimbvhTypeD;
    var phi_1272_: SlimbvhTypeN;
    var phi_1288_: SlimbvhTypeN;
    var phi_1291_: u32;
    var phi_1293_: u32;
    var phi_1295_: u32;
    var phi_1304_: u32;
    var phi_1307_: u32;
    var phi_1309_: u32;
    var phi_1620_: u32;
    var phi_1595_: u32;
    var phi_1621_: u32;
    var phi_1622_: u32;
    var phi_1305_: u32;
    var phi_1308_: u32;
    var phi_1310_: u32;
    var local_2: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1639_: SlimbvhTypeN;
    var phi_1642_: SlimbvhTypeE;
    var phi_1643_: SlimbvhTypeE;
    var phi_1665_: SlimbvhTypeE;
    var phi_1744_: array<vec4<f32>, 3>;
    var phi_1745_: array<vec4<f32>, 3>;
    var phi_1819_: array<vec4<f32>, 3>;
    var phi_1820_: array<vec4<f32>, 3>;
    var phi_1843_: array<f32, 3>;
    var phi_1844_: array<f32, 3>;
    var phi_1858_: array<f32, 3>;
    var phi_1859_: array<f32, 3>;
    var phi_1873_: array<f32, 3>;
    var phi_1874_: array<f32, 3>;
    var phi_2207_: f32;
    var phi_2208_: f32;
    var phi_2209_: f32;
    var phi_2210_: f32;
    var phi_2211_: vec3<f32>;
    var phi_2212_: vec3<f32>;
    var phi_2213_: vec3<f32>;
    var phi_2214_: vec3<f32>;
    var phi_2393_: f32;
    var phi_2419_: SlimbvhTypeF;
    var phi_2420_: SlimbvhTypeF;
    var phi_2423_: SlimbvhTypeF;
    var phi_2424_: SlimbvhTypeF;
    var phi_2425_: bool;
    var phi_2429_: SlimbvhTypeF;
    var phi_2438_: SlimbvhTypeG;
    var phi_2485_: i32;
    var phi_2625_: SlimbvhTypeI;
    var phi_2649_: u32;
    var phi_2677_: vec3<f32>;
    var phi_2678_: vec3<f32>;
    var phi_2695_: vec3<f32>;
    var phi_2696_: vec3<f32>;
    var phi_2713_: vec3<f32>;
    var phi_2714_: vec3<f32>;
    var phi_2750_: vec3<f32>;
    var phi_2932_: f32;
    var phi_2950_: bool;
    var phi_2951_: bool;
    var phi_2970_: bool;
    var phi_2971_: bool;
    var phi_2978_: SlimbvhTypeN;
    var phi_2984_: SlimbvhTypeN;
    var phi_2985_: SlimbvhTypeN;
    var phi_2986_: SlimbvhTypeN;
    var phi_1640_: SlimbvhTypeN;
    var local_5: u32;
    var local_6: SlimbvhTypeN;
    var phi_3011_: u32;
    var phi_3018_: SlimbvhTypeN;
    var phi_3019_: u32;
    var phi_3020_: u32;
    var phi_1289_: SlimbvhTypeN;
    var phi_1292_: u32;
    var phi_1294_: u32;
    var phi_1296_: u32;
    var local_7: SlimbvhTypeN;
    var phi_3054_: f32;
    var phi_3056_: f32;
    var phi_3057_: bool;
    var phi_3058_: f32;
    var phi_3059_: bool;
    var phi_3440_: u32;
    var phi_3458_: bool;
    var phi_3461_: bool;
    var phi_3474_: f32;
    var phi_3475_: f32;
    var phi_3480_: f32;
    var phi_3481_: f32;
    var phi_3482_: bool;
    var phi_3490_: f32;
    var phi_3074_: f32;
    var phi_3075_: f32;
    var phi_3087_: f32;
    var phi_3092_: SlimbvhTypeG;
    var local_8: SlimbvhTypeN;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e85 = SlimbvhTypeG(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e89 = arrayLength((&slimbvh_nodes.member));
    let _e100 = slimbvh_exponent.member[1u];
    let _e103 = slimbvh_exponent.member[2u];
    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
    let _e104 = slimbvh_origin.member;
    let _e110 = slimbvh_origin.member[3u];
    let _e111 = slimbvh_direction.member;
    let _e117 = slimbvh_direction.member[3u];
    let _e120 = slimbvh_exponent.member[0u];
    let _e121 = bitcast<i32>(_e120);
    let _e123 = (bitcast<u32>(_e104.x) & 2147483647u);
    let _e125 = (bitcast<u32>(_e104.y) & 2147483647u);
    let _e127 = (bitcast<u32>(_e104.z) & 2147483647u);
    let _e128 = bitcast<u32>(_e110);
    let _e129 = (_e128 & 2147483647u);
    let _e131 = (bitcast<u32>(_e111.x) & 2147483647u);
    let _e133 = (bitcast<u32>(_e111.y) & 2147483647u);
    let _e135 = (bitcast<u32>(_e111.z) & 2147483647u);
    let _e136 = bitcast<u32>(_e117);
    let _e137 = (_e136 & 2147483647u);
    let _e139 = select(_e133, _e131, (_e133 < _e131));
    let _e141 = select(_e135, _e139, (_e135 < _e139));
    let _e143 = select(_e123, _e141, (_e123 < _e141));
    let _e145 = select(_e125, _e143, (_e125 < _e143));
    let _e147 = select(_e127, _e145, (_e127 < _e145));
    let _e154 = (((select(_e129, _e147, (_e129 < _e147)) < 2139095040u) && (_e137 <= 2139095040u)) && (_e141 > 0u));
    if (_e131 == _e141) {
        phi_444_ = 0u;
    } else {
        phi_444_ = select(2u, 1u, (_e133 == _e141));
    }
    let _e159 = phi_444_;
    let _e160 = (_e159 == 2u);
    if _e160 {
        phi_450_ = 0u;
    } else {
        phi_450_ = (_e159 + 1u);
    }
    let _e163 = phi_450_;
    let _e164 = (_e163 == 2u);
    if _e164 {
        phi_456_ = 0u;
    } else {
        phi_456_ = (_e163 + 1u);
    }
    let _e167 = phi_456_;
    let _e168 = (_e163 == 0u);
    let _e170 = select(select(_e104.y, _e104.x, _e168), _e104.z, _e164);
    let _e171 = (_e167 == 0u);
    let _e173 = (_e167 == 2u);
    let _e174 = select(select(_e104.y, _e104.x, _e171), _e104.z, _e173);
    let _e175 = (_e159 == 0u);
    let _e177 = select(select(_e104.y, _e104.x, _e175), _e104.z, _e160);
    let _e179 = select(select(_e111.y, _e111.x, _e168), _e111.z, _e164);
    let _e181 = select(select(_e111.y, _e111.x, _e171), _e111.z, _e173);
    let _e183 = select(select(_e111.y, _e111.x, _e175), _e111.z, _e160);
    let _e184 = (_e129 - 1u);
    let _e185 = (_e137 - 1u);
    let _e187 = select(_e184, _e185, (_e185 < _e184));
    let _e188 = (_e123 - 1u);
    let _e189 = (_e125 - 1u);
    let _e191 = select(_e188, _e189, (_e189 < _e188));
    let _e192 = (_e127 - 1u);
    let _e194 = select(_e191, _e192, (_e192 < _e191));
    let _e195 = (_e131 - 1u);
    let _e196 = (_e133 - 1u);
    let _e198 = select(_e195, _e196, (_e196 < _e195));
    let _e199 = (_e135 - 1u);
    let _e201 = select(_e198, _e199, (_e199 < _e198));
    let _e203 = select(_e194, _e201, (_e201 < _e194));
    if (((select(_e203, _e187, (_e187 < _e203)) >= 8388607u) && (_e141 < 2130706432u)) && (bitcast<u32>((_e121 + 126i)) <= 253u)) {
        let _e468 = bitcast<i32>((_e141 >> bitcast<u32>(23i)));
        let _e469 = (_e468 - 127i);
        let _e470 = (_e121 + _e469);
        let _e475 = bitcast<f32>((bitcast<u32>((_e121 + 127i)) << bitcast<u32>(23i)));
        let _e480 = bitcast<f32>((bitcast<u32>((254i - _e468)) << bitcast<u32>(23i)));
        if (_e129 >= 2139095040u) {
            phi_618_ = 255i;
        } else {
            phi_618_ = (bitcast<i32>((_e129 >> bitcast<u32>(23i))) + _e470);
        }
        let _e495 = phi_618_;
        if (_e129 == 0u) {
            phi_624_ = 0u;
        } else {
            phi_624_ = (_e129 | 8388608u);
        }
        let _e499 = phi_624_;
        if (_e495 <= 0i) {
            phi_644_ = u32();
            phi_645_ = true;
        } else {
            let _e506 = (_e499 == 0u);
            if _e506 {
                phi_643_ = u32();
            } else {
                phi_643_ = select(((bitcast<u32>(_e495) << bitcast<u32>(23i)) | (_e499 & 8388607u)), 2139095039u, (_e495 >= 255i));
            }
            let _e510 = phi_643_;
            phi_644_ = _e510;
            phi_645_ = _e506;
        }
        let _e512 = phi_644_;
        let _e514 = phi_645_;
        if (_e137 >= 2139095040u) {
            phi_663_ = 255i;
        } else {
            phi_663_ = (bitcast<i32>((_e137 >> bitcast<u32>(23i))) + _e470);
        }
        let _e525 = phi_663_;
        if (_e137 == 0u) {
            phi_669_ = 0u;
        } else {
            phi_669_ = (_e137 | 8388608u);
        }
        let _e529 = phi_669_;
        if (_e525 <= 0i) {
            phi_689_ = u32();
            phi_690_ = true;
        } else {
            let _e536 = (_e529 == 0u);
            if _e536 {
                phi_688_ = u32();
            } else {
                phi_688_ = select(((bitcast<u32>(_e525) << bitcast<u32>(23i)) | (_e529 & 8388607u)), 2139095039u, (_e525 >= 255i));
            }
            let _e540 = phi_688_;
            phi_689_ = _e540;
            phi_690_ = _e536;
        }
        let _e542 = phi_689_;
        let _e544 = phi_690_;
        phi_1067_ = SlimbvhTypeD(array<f32, 3>((_e170 * _e475), (_e174 * _e475), (_e177 * _e475)), array<f32, 3>((_e179 * _e480), (_e181 * _e480), (_e183 * _e480)), bitcast<f32>(((_e128 & 2147483648u) | select(_e512, 0u, _e514))), bitcast<f32>(((_e136 & 2147483648u) | select(_e542, 0u, _e544))), _e469);
    } else {
        let _e216 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e141, _e154))) & 2147483647u);
        if (_e216 >= 8388608u) {
            phi_721_ = (bitcast<i32>((_e216 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_721_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e216)), 32u, (_e216 == 0u))));
        }
        let _e230 = phi_721_;
        let _e231 = (_e121 + _e230);
        if (_e121 < -126i) {
            phi_732_ = -126i;
        } else {
            phi_732_ = select(_e121, 127i, (_e121 > 127i));
        }
        let _e236 = phi_732_;
        let _e241 = bitcast<f32>((bitcast<u32>((_e236 + 127i)) << bitcast<u32>(23i)));
        let _e247 = bitcast<f32>((bitcast<u32>(((_e121 - _e236) + 127i)) << bitcast<u32>(23i)));
        let _e248 = bitcast<u32>(_e170);
        let _e250 = ((_e248 & 2139095040u) != 0u);
        let _e265 = bitcast<u32>(_e174);
        let _e267 = ((_e265 & 2139095040u) != 0u);
        let _e282 = bitcast<u32>(_e177);
        let _e284 = ((_e282 & 2139095040u) != 0u);
        let _e300 = -(_e230);
        if (_e300 < -126i) {
            phi_846_ = -126i;
        } else {
            phi_846_ = select(_e300, 127i, (_e300 > 127i));
        }
        let _e305 = phi_846_;
        let _e310 = bitcast<f32>((bitcast<u32>((_e305 + 127i)) << bitcast<u32>(23i)));
        let _e316 = bitcast<f32>((bitcast<u32>(((_e300 - _e305) + 127i)) << bitcast<u32>(23i)));
        let _e317 = bitcast<u32>(_e179);
        let _e319 = ((_e317 & 2139095040u) != 0u);
        let _e334 = bitcast<u32>(_e181);
        let _e336 = ((_e334 & 2139095040u) != 0u);
        let _e351 = bitcast<u32>(_e183);
        let _e353 = ((_e351 & 2139095040u) != 0u);
        let _e375 = ((_e129 & 8388607u) | (select(0u, 1u, ((_e129 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e378 = bitcast<i32>((_e129 >> bitcast<u32>(23i)));
        let _e385 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e375)), 32u, (_e375 == 0u))) - 8i);
        if (_e378 == 255i) {
            phi_975_ = 255i;
        } else {
            phi_975_ = (((_e378 + select(0i, 1i, (_e378 == 0i))) - _e385) + _e231);
        }
        let _e393 = phi_975_;
        let _e397 = (_e375 << bitcast<u32>(((_e385 & 31i) & 31i)));
        if (_e393 <= 0i) {
            phi_998_ = u32();
            phi_999_ = true;
        } else {
            let _e404 = (_e397 == 0u);
            if _e404 {
                phi_997_ = u32();
            } else {
                phi_997_ = select(((bitcast<u32>(_e393) << bitcast<u32>(23i)) | (_e397 & 8388607u)), 2139095039u, (_e393 >= 255i));
            }
            let _e408 = phi_997_;
            phi_998_ = _e408;
            phi_999_ = _e404;
        }
        let _e410 = phi_998_;
        let _e412 = phi_999_;
        let _e423 = ((_e137 & 8388607u) | (select(0u, 1u, ((_e137 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e426 = bitcast<i32>((_e137 >> bitcast<u32>(23i)));
        let _e433 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e423)), 32u, (_e423 == 0u))) - 8i);
        if (_e426 == 255i) {
            phi_1033_ = 255i;
        } else {
            phi_1033_ = (((_e426 + select(0i, 1i, (_e426 == 0i))) - _e433) + _e231);
        }
        let _e441 = phi_1033_;
        let _e445 = (_e423 << bitcast<u32>(((_e433 & 31i) & 31i)));
        if (_e441 <= 0i) {
            phi_1056_ = u32();
            phi_1057_ = true;
        } else {
            let _e452 = (_e445 == 0u);
            if _e452 {
                phi_1055_ = u32();
            } else {
                phi_1055_ = select(((bitcast<u32>(_e441) << bitcast<u32>(23i)) | (_e445 & 8388607u)), 2139095039u, (_e441 >= 255i));
            }
            let _e456 = phi_1055_;
            phi_1056_ = _e456;
            phi_1057_ = _e452;
        }
        let _e458 = phi_1056_;
        let _e460 = phi_1057_;
        phi_1067_ = SlimbvhTypeD(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e248 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e248 & 2147483648u))), _e170, _e250) * _e241) * select(0.00000011920929f, 1f, _e250)) * _e247), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e265 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e265 & 2147483648u))), _e174, _e267) * _e241) * select(0.00000011920929f, 1f, _e267)) * _e247), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e282 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e282 & 2147483648u))), _e177, _e284) * _e241) * select(0.00000011920929f, 1f, _e284)) * _e247)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e317 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e317 & 2147483648u))), _e179, _e319) * _e310) * select(0.00000011920929f, 1f, _e319)) * _e316), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e334 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e334 & 2147483648u))), _e181, _e336) * _e310) * select(0.00000011920929f, 1f, _e336)) * _e316), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e351 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e351 & 2147483648u))), _e183, _e353) * _e310) * select(0.00000011920929f, 1f, _e353)) * _e316)), bitcast<f32>(((_e128 & 2147483648u) | select(_e410, 0u, _e412))), bitcast<f32>(((_e136 & 2147483648u) | select(_e458, 0u, _e460))), _e230);
    }
    let _e551 = phi_1067_;
    let _e566 = (bitcast<f32>((bitcast<u32>(_e551.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e569 = bitcast<f32>((bitcast<u32>(_e551.member[0]) & 2147483647u));
    let _e570 = (_e569 * 0.00000011920929f);
    let _e573 = select(select(0.00000000000011368684f, _e570, (_e570 > 0.00000000000011368684f)), 0f, _e566);
    let _e574 = select(0f, _e551.member_1[0], _e566);
    let _e575 = (_e551.member[0] + _e573);
    let _e576 = (_e551.member[0] - _e573);
    let _e578 = select(38685626000000000000000000f, (1f / _e551.member_1[0]), _e566);
    let _e582 = (bitcast<f32>((bitcast<u32>(_e551.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e585 = bitcast<f32>((bitcast<u32>(_e551.member[1]) & 2147483647u));
    let _e586 = (_e585 * 0.00000011920929f);
    let _e589 = select(select(0.00000000000011368684f, _e586, (_e586 > 0.00000000000011368684f)), 0f, _e582);
    let _e590 = select(0f, _e551.member_1[1], _e582);
    let _e591 = (_e551.member[1] + _e589);
    let _e592 = (_e551.member[1] - _e589);
    let _e594 = select(38685626000000000000000000f, (1f / _e551.member_1[1]), _e582);
    let _e598 = (bitcast<f32>((bitcast<u32>(_e551.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e601 = bitcast<f32>((bitcast<u32>(_e551.member[2]) & 2147483647u));
    let _e602 = (_e601 * 0.00000011920929f);
    let _e605 = select(select(0.00000000000011368684f, _e602, (_e602 > 0.00000000000011368684f)), 0f, _e598);
    let _e606 = select(0f, _e551.member_1[2], _e598);
    let _e607 = (_e551.member[2] + _e605);
    let _e608 = (_e551.member[2] - _e605);
    let _e610 = select(38685626000000000000000000f, (1f / _e551.member_1[2]), _e598);
    let _e612 = select(_e585, _e569, (_e569 > _e585));
    let _e616 = (_e154 && (select(_e601, _e612, (_e612 > _e601)) <= 1099511600000f));
    let _e617 = select(0f, _e551.member_3, _e616);
    let _e618 = select(1f, _e551.member_2, _e616);
    let _e622 = slimbvh_question.member[1u];
    let _e625 = slimbvh_question.member[0u];
    if (_e625 == 1u) {
        phi_1272_ = SlimbvhTypeN(SlimbvhTypeJ(_e85, _e617), true);
    } else {
        phi_1272_ = SlimbvhTypeN(SlimbvhTypeJ(_e85, _e617), false);
    }
    let _e632 = phi_1272_;
    phi_1288_ = _e632;
    phi_1291_ = select(4294967295u, 0u, (_e618 <= _e617));
    phi_1293_ = 0u;
    phi_1295_ = (_e89 + 1u);
    loop {
        let _e641 = phi_1288_;
        let _e643 = phi_1291_;
        let _e645 = phi_1293_;
        let _e647 = phi_1295_;
        local_7 = _e641;
        let _e648 = (_e643 <= 2147483647u);
        if _e648 {
            phi_1304_ = _e643;
            phi_1307_ = _e645;
            phi_1309_ = _e647;
            loop {
                let _e650 = phi_1304_;
                let _e652 = phi_1307_;
                let _e654 = phi_1309_;
                local_3 = _e652;
                local_4 = _e652;
                local_5 = _e650;
                local_9 = _e650;
                local_10 = _e652;
                local_11 = _e654;
                let _e655 = (_e650 <= 2147483647u);
                let _e657 = (_e652 + _e100);
                let _e661 = (_e655 && !(((_e652 >= _e89) || (_e657 >= _e89))));
                local_2 = _e655;
                if _e661 {
                    let _e665 = slimbvh_nodes.member[_e657][3u][0u];
                    let _e669 = slimbvh_nodes.member[_e657][3u][1u];
                    let _e673 = slimbvh_nodes.member[_e657][((_e163 & 3u) % 4u)];
                    let _e677 = slimbvh_nodes.member[_e657][((_e167 & 3u) % 4u)];
                    let _e681 = slimbvh_nodes.member[_e657][((_e159 & 3u) % 4u)];
                    let _e682 = bitcast<u32>(_e665);
                    let _e683 = bitcast<u32>(_e669);
                    let _e694 = ((_e673.x - _e575) * _e578);
                    let _e695 = ((_e673.y - _e575) * _e578);
                    let _e696 = ((_e673.z - _e576) * _e578);
                    let _e697 = ((_e673.w - _e576) * _e578);
                    let _e698 = vec4<f32>(_e694, _e695, _e696, _e697);
                    let _e707 = ((_e677.x - _e591) * _e594);
                    let _e708 = ((_e677.y - _e591) * _e594);
                    let _e709 = ((_e677.z - _e592) * _e594);
                    let _e710 = ((_e677.w - _e592) * _e594);
                    let _e711 = vec4<f32>(_e707, _e708, _e709, _e710);
                    let _e720 = ((_e681.x - _e607) * _e610);
                    let _e721 = ((_e681.y - _e607) * _e610);
                    let _e722 = ((_e681.z - _e608) * _e610);
                    let _e723 = ((_e681.w - _e608) * _e610);
                    let _e724 = vec4<f32>(_e720, _e721, _e722, _e723);
                    let _e725 = vec4<f32>(_e696, _e697, _e694, _e695);
                    let _e726 = min(_e698, _e725);
                    let _e727 = vec4<f32>(_e709, _e710, _e707, _e708);
                    let _e728 = min(_e711, _e727);
                    let _e729 = vec4<f32>(_e722, _e723, _e720, _e721);
                    let _e730 = min(_e724, _e729);
                    let _e731 = max(_e698, _e725);
                    let _e732 = max(_e711, _e727);
                    let _e733 = max(_e724, _e729);
                    let _e762 = max(max(max(_e726.x, _e728.x), _e730.x), _e618);
                    let _e763 = max(max(max(_e726.y, _e728.y), _e730.y), _e618);
                    let _e766 = (_e762 <= min((min(min(_e731.x, _e732.x), _e733.x) + (max(_e733.x, -(_e730.x)) * 0.0000019073523f)), _e641.member.member_1));
                    let _e767 = (_e763 <= min((min(min(_e731.y, _e732.y), _e733.y) + (max(_e733.y, -(_e730.y)) * 0.0000019073523f)), _e641.member.member_1));
                    if (_e766 || _e767) {
                        let _e782 = (_e766 && (((_e762 <= _e763) != _e632.member_1) || !(_e767)));
                        if (_e766 && _e767) {
                            let _e787 = (_e650 % 128u);
                            local_1[_e787] = select(_e682, _e683, _e782);
                            local[_e787] = select(_e762, _e763, _e782);
                            phi_1595_ = (_e650 + 1u);
                        } else {
                            phi_1595_ = _e650;
                        }
                        let _e792 = phi_1595_;
                        phi_1621_ = _e792;
                        phi_1622_ = select(_e683, _e682, _e782);
                    } else {
                        let _e771 = (_e650 - 1u);
                        let _e772 = (_e771 % 128u);
                        let _e774 = local[_e772];
                        if (_e774 <= _e641.member.member_1) {
                            let _e777 = local_1[_e772];
                            phi_1620_ = _e777;
                        } else {
                            phi_1620_ = 2147483648u;
                        }
                        let _e779 = phi_1620_;
                        phi_1621_ = _e771;
                        phi_1622_ = _e779;
                    }
                    let _e794 = phi_1621_;
                    let _e796 = phi_1622_;
                    let _e797 = (_e654 - 1u);
                    phi_1305_ = select(_e794, 4294967295u, (_e797 == 0u));
                    phi_1308_ = _e796;
                    phi_1310_ = _e797;
                } else {
                    phi_1305_ = u32();
                    phi_1308_ = u32();
                    phi_1310_ = u32();
                }
                let _e801 = phi_1305_;
                let _e803 = phi_1308_;
                let _e805 = phi_1310_;
                continue;
                continuing {
                    phi_1304_ = _e801;
                    phi_1307_ = _e803;
                    phi_1309_ = _e805;
                    break if !(_e661);
                }
            }
            let _e808 = local_2;
            if _e808 {
                let _e810 = local_3;
                let _e813 = local_4;
                phi_1639_ = _e641;
                phi_1642_ = SlimbvhTypeE(0u, ((_e813 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e820 = phi_1639_;
                    let _e822 = phi_1642_;
                    local_6 = _e820;
                    local_8 = _e820;
                    if (_e822.member < _e822.member_1) {
                        phi_1643_ = SlimbvhTypeE((_e822.member + 1u), _e822.member_1);
                        phi_1665_ = SlimbvhTypeE(1u, _e822.member);
                    } else {
                        phi_1643_ = _e822;
                        phi_1665_ = SlimbvhTypeE(0u, SlimbvhTypeE().member_1);
                    }
                    let _e835 = phi_1643_;
                    let _e837 = phi_1665_;
                    let _e841 = (bitcast<i32>(_e837.member) != 0i);
                    if _e841 {
                        let _e842 = (((_e810 & 268435455u) + _e103) + _e837.member_1);
                        let _e843 = (_e842 / 2u);
                        let _e844 = (_e842 % 2u);
                        let _e845 = (_e843 >= arrayLength((&slimbvh_triangles.member)));
                        if _e845 {
                            phi_1745_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e846 = (2u * _e844);
                            let _e850 = slimbvh_triangles.member[_e843][_e846];
                            let _e855 = slimbvh_triangles.member[_e843][(_e846 + 1u)];
                            let _e860 = slimbvh_triangles.member[_e843][(_e846 + 2u)];
                            if (_e844 == 0u) {
                                phi_1744_ = array<vec4<f32>, 3>(_e850, _e855, _e860);
                            } else {
                                phi_1744_ = array<vec4<f32>, 3>(vec4<f32>(_e850.z, _e850.w, _e855.x, _e855.y), vec4<f32>(_e855.z, _e855.w, _e860.x, _e860.y), vec4<f32>(_e860.z, _e860.w, 0f, 0f));
                            }
                            let _e878 = phi_1744_;
                            phi_1745_ = _e878;
                        }
                        let _e880 = phi_1745_;
                        let _e883 = bitcast<u32>(_e880[2].y);
                        if _e845 {
                            phi_1820_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e884 = (2u * _e844);
                            let _e888 = slimbvh_triangles.member[_e843][_e884];
                            let _e893 = slimbvh_triangles.member[_e843][(_e884 + 1u)];
                            let _e898 = slimbvh_triangles.member[_e843][(_e884 + 2u)];
                            if (_e844 == 0u) {
                                phi_1819_ = array<vec4<f32>, 3>(_e888, _e893, _e898);
                            } else {
                                phi_1819_ = array<vec4<f32>, 3>(vec4<f32>(_e888.z, _e888.w, _e893.x, _e893.y), vec4<f32>(_e893.z, _e893.w, _e898.x, _e898.y), vec4<f32>(_e898.z, _e898.w, 0f, 0f));
                            }
                            let _e916 = phi_1819_;
                            phi_1820_ = _e916;
                        }
                        let _e918 = phi_1820_;
                        if _e168 {
                            phi_1844_ = array<f32, 3>(_e918[0].x, _e918[0].y, _e918[0].z);
                        } else {
                            if (_e163 == 1u) {
                                phi_1843_ = array<f32, 3>(_e918[0].y, _e918[0].z, _e918[0].x);
                            } else {
                                phi_1843_ = array<f32, 3>(_e918[0].z, _e918[0].x, _e918[0].y);
                            }
                            let _e941 = phi_1843_;
                            phi_1844_ = _e941;
                        }
                        let _e944 = phi_1844_;
                        if _e168 {
                            phi_1859_ = array<f32, 3>(_e918[0].w, _e918[1].x, _e918[1].y);
                        } else {
                            if (_e163 == 1u) {
                                phi_1858_ = array<f32, 3>(_e918[1].x, _e918[1].y, _e918[0].w);
                            } else {
                                phi_1858_ = array<f32, 3>(_e918[1].y, _e918[0].w, _e918[1].x);
                            }
                            let _e949 = phi_1858_;
                            phi_1859_ = _e949;
                        }
                        let _e952 = phi_1859_;
                        if _e168 {
                            phi_1874_ = array<f32, 3>(_e918[1].z, _e918[1].w, _e918[2].x);
                        } else {
                            if (_e163 == 1u) {
                                phi_1873_ = array<f32, 3>(_e918[1].w, _e918[2].x, _e918[1].z);
                            } else {
                                phi_1873_ = array<f32, 3>(_e918[2].x, _e918[1].z, _e918[1].w);
                            }
                            let _e957 = phi_1873_;
                            phi_1874_ = _e957;
                        }
                        let _e960 = phi_1874_;
                        let _e974 = (_e944[2] - _e551.member[2]);
                        let _e977 = (((_e944[0] - _e551.member[0]) * _e606) - (_e974 * _e574));
                        let _e980 = (((_e944[1] - _e551.member[1]) * _e606) - (_e974 * _e590));
                        let _e983 = (_e952[2] - _e551.member[2]);
                        let _e986 = (((_e952[0] - _e551.member[0]) * _e606) - (_e983 * _e574));
                        let _e989 = (((_e952[1] - _e551.member[1]) * _e606) - (_e983 * _e590));
                        let _e992 = (_e960[2] - _e551.member[2]);
                        let _e995 = (((_e960[0] - _e551.member[0]) * _e606) - (_e992 * _e574));
                        let _e998 = (((_e960[1] - _e551.member[1]) * _e606) - (_e992 * _e590));
                        let _e999 = (_e995 * _e989);
                        let _e1000 = (_e998 * _e986);
                        let _e1001 = (_e977 * _e998);
                        let _e1002 = (_e980 * _e995);
                        let _e1003 = (_e986 * _e980);
                        let _e1004 = (_e989 * _e977);
                        let _e1009 = (((_e999 >= _e1000) && (_e1001 >= _e1002)) && (_e1003 >= _e1004));
                        let _e1015 = (_e1009 || (((_e999 <= _e1000) && (_e1001 <= _e1002)) && (_e1003 <= _e1004)));
                        if _e1015 {
                            let _e1017 = select(-1f, 1f, _e1009);
                            let _e1019 = ((_e999 - _e1000) * _e1017);
                            let _e1021 = select(0f, _e1019, (_e1019 > 0f));
                            let _e1023 = ((_e1001 - _e1002) * _e1017);
                            let _e1025 = select(0f, _e1023, (_e1023 > 0f));
                            let _e1027 = ((_e1003 - _e1004) * _e1017);
                            let _e1029 = select(0f, _e1027, (_e1027 > 0f));
                            let _e1031 = ((_e1021 + _e1025) + _e1029);
                            let _e1046 = ((min(min(_e944[0], _e952[0]), _e960[0]) - _e575) * _e578);
                            let _e1047 = ((max(max(_e944[0], _e952[0]), _e960[0]) - _e576) * _e578);
                            let _e1048 = vec4<f32>(_e1046, f32(), _e1047, f32());
                            let _e1051 = ((min(min(_e944[1], _e952[1]), _e960[1]) - _e591) * _e594);
                            let _e1052 = ((max(max(_e944[1], _e952[1]), _e960[1]) - _e592) * _e594);
                            let _e1053 = vec4<f32>(_e1051, f32(), _e1052, f32());
                            let _e1056 = ((min(min(_e944[2], _e952[2]), _e960[2]) - _e607) * _e610);
                            let _e1057 = ((max(max(_e944[2], _e952[2]), _e960[2]) - _e608) * _e610);
                            let _e1058 = vec4<f32>(_e1056, f32(), _e1057, f32());
                            let _e1059 = vec4<f32>(_e1047, f32(), _e1046, f32());
                            let _e1061 = vec4<f32>(_e1052, f32(), _e1051, f32());
                            let _e1063 = vec4<f32>(_e1057, f32(), _e1056, f32());
                            let _e1072 = max(max(min(_e1048, _e1059).x, min(_e1053, _e1061).x), min(_e1058, _e1063).x);
                            let _e1077 = min(min(max(_e1048, _e1059).x, max(_e1053, _e1061).x), max(_e1058, _e1063).x);
                            let _e1082 = max(_e1072, _e618);
                            let _e1104 = (((((_e1015 && (_e1031 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e977, _e986), _e995) <= 0f) && (max(max(_e977, _e986), _e995) >= 0f))) && ((min(min(_e980, _e989), _e998) <= 0f) && (max(max(_e980, _e989), _e998) >= 0f))) && (_e1082 <= (_e1077 + (max(max(_e1058, _e1063).x, -(min(_e1058, _e1063).x)) * 0.0000019073523f)))) && (_e1082 <= _e820.member.member_1));
                            if _e1104 {
                                let _e1109 = (_e952[0] - _e944[0]);
                                let _e1110 = (_e952[1] - _e944[1]);
                                let _e1111 = (_e952[2] - _e944[2]);
                                let _e1112 = vec3<f32>(_e1109, _e1110, _e1111);
                                let _e1113 = (_e960[0] - _e952[0]);
                                let _e1114 = (_e960[1] - _e952[1]);
                                let _e1115 = (_e960[2] - _e952[2]);
                                let _e1116 = vec3<f32>(_e1113, _e1114, _e1115);
                                let _e1117 = (_e944[0] - _e960[0]);
                                let _e1118 = (_e944[1] - _e960[1]);
                                let _e1119 = (_e944[2] - _e960[2]);
                                let _e1120 = vec3<f32>(_e1117, _e1118, _e1119);
                                let _e1131 = max(max(bitcast<f32>((bitcast<u32>(_e1109) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1110) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1111) & 2147483647u)));
                                let _e1142 = max(max(bitcast<f32>((bitcast<u32>(_e1113) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1114) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1115) & 2147483647u)));
                                let _e1155 = max(max(_e1131, _e1142), max(max(bitcast<f32>((bitcast<u32>(_e1117) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1118) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1119) & 2147483647u))));
                                if (_e1131 == _e1155) {
                                    phi_2207_ = _e989;
                                    phi_2208_ = _e986;
                                    phi_2209_ = _e980;
                                    phi_2210_ = _e977;
                                    phi_2211_ = vec3<f32>(_e944[0], _e944[1], _e944[2]);
                                    phi_2212_ = _e1120;
                                    phi_2213_ = _e1116;
                                    phi_2214_ = _e1112;
                                } else {
                                    let _e1157 = (_e1142 == _e1155);
                                    let _e1162 = vec3(_e1157);
                                    phi_2207_ = select(_e980, _e998, _e1157);
                                    phi_2208_ = select(_e977, _e995, _e1157);
                                    phi_2209_ = select(_e998, _e989, _e1157);
                                    phi_2210_ = select(_e995, _e986, _e1157);
                                    phi_2211_ = select(vec3<f32>(_e960[0], _e960[1], _e960[2]), vec3<f32>(_e952[0], _e952[1], _e952[2]), _e1162);
                                    phi_2212_ = select(_e1116, _e1112, _e1162);
                                    phi_2213_ = select(_e1112, _e1120, _e1162);
                                    phi_2214_ = select(_e1120, _e1116, _e1162);
                                }
                                let _e1168 = phi_2207_;
                                let _e1170 = phi_2208_;
                                let _e1172 = phi_2209_;
                                let _e1174 = phi_2210_;
                                let _e1176 = phi_2211_;
                                let _e1178 = phi_2212_;
                                let _e1180 = phi_2213_;
                                let _e1182 = phi_2214_;
                                let _e1189 = ((_e1180.y * _e1178.z) - (_e1178.y * _e1180.z));
                                let _e1194 = ((_e1180.z * _e1178.x) - (_e1178.z * _e1180.x));
                                let _e1197 = ((_e1180.x * _e1178.y) - (_e1178.x * _e1180.y));
                                let _e1200 = ((_e1021 >= _e1025) && (_e1021 >= _e1029));
                                let _e1201 = (_e1025 >= _e1029);
                                let _e1215 = (((_e1189 * (select(select(_e960[0], _e952[0], _e1201), _e944[0], _e1200) - _e551.member[0])) + (_e1194 * (select(select(_e960[1], _e952[1], _e1201), _e944[1], _e1200) - _e551.member[1]))) + (_e1197 * (select(select(_e960[2], _e952[2], _e1201), _e944[2], _e1200) - _e551.member[2])));
                                let _e1220 = (((_e1189 * _e574) + (_e1194 * _e590)) + (_e1197 * _e606));
                                let _e1221 = (_e1170 - _e1174);
                                let _e1222 = (_e1168 - _e1172);
                                let _e1225 = ((_e1221 * _e1221) + (_e1222 * _e1222));
                                let _e1232 = (-(((_e1174 * _e1221) + (_e1172 * _e1222))) / select(0.000000000000000000000000000000000000011754944f, _e1225, (_e1225 > 0.000000000000000000000000000000000000011754944f)));
                                let _e1234 = select(1f, _e1232, (_e1232 < 1f));
                                let _e1236 = select(0f, _e1234, (_e1234 > 0f));
                                let _e1245 = ((_e1176.x + (_e1182.x * _e1236)) - _e551.member[0]);
                                let _e1248 = ((_e1176.y + (_e1182.y * _e1236)) - _e551.member[1]);
                                let _e1251 = ((_e1176.z + (_e1182.z * _e1236)) - _e551.member[2]);
                                let _e1316 = ((bitcast<f32>((bitcast<u32>(((((_e1189 * _e1245) + (_e1194 * _e1248)) + (_e1197 * _e1251)) - _e1215)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1245) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1248) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1251) & 2147483647u))), _e1155)) * max(max(bitcast<f32>((bitcast<u32>(_e1189) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1194) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1197) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1220) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1180.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1180.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1180.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1178.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1178.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1178.z) & 2147483647u)))))));
                                let _e1317 = (_e1215 / _e1220);
                                if (_e1104 && !(_e1316)) {
                                    let _e1320 = (_e1251 / _e606);
                                    let _e1328 = (((_e1189 * (_e1245 - (_e574 * _e1320))) + (_e1194 * (_e1248 - (_e590 * _e1320)))) / _e1220);
                                    phi_2393_ = select(select(_e1320, (_e1320 + _e1328), (bitcast<f32>((bitcast<u32>(_e1328) & 2147483647u)) <= _e1155)), _e1317, _e1316);
                                } else {
                                    phi_2393_ = _e1317;
                                }
                                let _e1337 = phi_2393_;
                                let _e1339 = select(_e1077, _e1337, (_e1337 < _e1077));
                                let _e1341 = select(_e1072, _e1339, (_e1339 > _e1072));
                                let _e1344 = select(_e1341, 0f, (bitcast<u32>(_e1341) == 2147483648u));
                                let _e1345 = (1f / _e1031);
                                phi_2419_ = SlimbvhTypeF(_e1344, (_e1025 * _e1345), (_e1029 * _e1345), ((_e1104 && (_e1344 >= _e618)) && (_e1344 <= _e820.member.member_1)));
                                phi_2420_ = SlimbvhTypeF();
                            } else {
                                phi_2419_ = SlimbvhTypeF();
                                phi_2420_ = SlimbvhTypeF(0f, 0f, 0f, _e1104);
                            }
                            let _e1354 = phi_2419_;
                            let _e1356 = phi_2420_;
                            phi_2423_ = _e1354;
                            phi_2424_ = _e1356;
                            phi_2425_ = select(true, false, _e1104);
                        } else {
                            phi_2423_ = SlimbvhTypeF();
                            phi_2424_ = SlimbvhTypeF(0f, 0f, 0f, _e1015);
                            phi_2425_ = true;
                        }
                        let _e1359 = phi_2423_;
                        let _e1361 = phi_2424_;
                        let _e1363 = phi_2425_;
                        if _e1363 {
                            phi_2429_ = _e1361;
                        } else {
                            phi_2429_ = _e1359;
                        }
                        let _e1365 = phi_2429_;
                        if _e1365.member_3 {
                            phi_2438_ = SlimbvhTypeG(_e1365.member, _e1365.member_1, _e1365.member_2, _e883);
                        } else {
                            phi_2438_ = _e85;
                        }
                        let _e1372 = phi_2438_;
                        if (_e1372.member_3 != 4294967295u) {
                            let _e1378 = slimbvh_target.member[0u][0u];
                            let _e1382 = slimbvh_target.member[0u][1u];
                            let _e1386 = slimbvh_target.member[0u][2u];
                            let _e1390 = slimbvh_target.member[0u][3u];
                            let _e1394 = slimbvh_target.member[1u][0u];
                            let _e1398 = slimbvh_target.member[1u][1u];
                            let _e1402 = slimbvh_target.member[1u][2u];
                            let _e1406 = slimbvh_target.member[1u][3u];
                            let _e1407 = bitcast<f32>(_e1378);
                            let _e1408 = bitcast<f32>(_e1382);
                            let _e1409 = bitcast<f32>(_e1386);
                            let _e1411 = bitcast<f32>(_e1394);
                            let _e1412 = array<u32, 3>(_e1398, _e1402, _e1406);
                            if (_e121 < -126i) {
                                phi_2485_ = -126i;
                            } else {
                                phi_2485_ = select(_e121, 127i, (_e121 > 127i));
                            }
                            let _e1418 = phi_2485_;
                            let _e1423 = bitcast<f32>((bitcast<u32>((_e1418 + 127i)) << bitcast<u32>(23i)));
                            let _e1429 = bitcast<f32>((bitcast<u32>(((_e121 - _e1418) + 127i)) << bitcast<u32>(23i)));
                            if (_e1390 == 0u) {
                                phi_2625_ = SlimbvhTypeI(array<f32, 3>(_e1407, _e1408, _e1409), _e1390, _e1411, _e1412);
                            } else {
                                let _e1431 = bitcast<u32>(_e1407);
                                let _e1433 = ((_e1431 & 2139095040u) != 0u);
                                let _e1448 = bitcast<u32>(_e1408);
                                let _e1450 = ((_e1448 & 2139095040u) != 0u);
                                let _e1465 = bitcast<u32>(_e1409);
                                let _e1467 = ((_e1465 & 2139095040u) != 0u);
                                let _e1483 = bitcast<u32>(_e1411);
                                let _e1485 = ((_e1483 & 2139095040u) != 0u);
                                phi_2625_ = SlimbvhTypeI(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1431 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1431 & 2147483648u))), _e1407, _e1433) * _e1423) * select(0.00000011920929f, 1f, _e1433)) * _e1429), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1448 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1448 & 2147483648u))), _e1408, _e1450) * _e1423) * select(0.00000011920929f, 1f, _e1450)) * _e1429), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1465 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1465 & 2147483648u))), _e1409, _e1467) * _e1423) * select(0.00000011920929f, 1f, _e1467)) * _e1429)), _e1390, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e1483 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e1483 & 2147483648u))), _e1411, _e1485) * _e1423) * select(0.00000011920929f, 1f, _e1485)) * _e1429), _e1412);
                            }
                            let _e1502 = phi_2625_;
                            if (_e883 == _e622) {
                                phi_2951_ = false;
                            } else {
                                let _e1504 = (_e883 / 16u);
                                if (_e1504 < arrayLength((&slimbvh_sides.member))) {
                                    let _e1507 = slimbvh_sides.member[_e1504];
                                    phi_2649_ = _e1507;
                                } else {
                                    phi_2649_ = 0u;
                                }
                                let _e1509 = phi_2649_;
                                let _e1518 = (bitcast<i32>((_e1509 << bitcast<u32>(((30u - ((_e883 % 16u) * 2u)) & 31u)))) >> bitcast<u32>(30i));
                                let _e1519 = (_e1518 == 0i);
                                if _e1519 {
                                    phi_2950_ = true;
                                } else {
                                    if _e168 {
                                        phi_2678_ = vec3<f32>(_e944[0], _e944[1], _e944[2]);
                                    } else {
                                        if (_e163 == 1u) {
                                            phi_2677_ = vec3<f32>(_e944[2], _e944[0], _e944[1]);
                                        } else {
                                            phi_2677_ = vec3<f32>(_e944[1], _e944[2], _e944[0]);
                                        }
                                        let _e1524 = phi_2677_;
                                        phi_2678_ = _e1524;
                                    }
                                    let _e1527 = phi_2678_;
                                    if _e168 {
                                        phi_2696_ = vec3<f32>(_e952[0], _e952[1], _e952[2]);
                                    } else {
                                        if (_e163 == 1u) {
                                            phi_2695_ = vec3<f32>(_e952[2], _e952[0], _e952[1]);
                                        } else {
                                            phi_2695_ = vec3<f32>(_e952[1], _e952[2], _e952[0]);
                                        }
                                        let _e1532 = phi_2695_;
                                        phi_2696_ = _e1532;
                                    }
                                    let _e1535 = phi_2696_;
                                    if _e168 {
                                        phi_2714_ = vec3<f32>(_e960[0], _e960[1], _e960[2]);
                                    } else {
                                        if (_e163 == 1u) {
                                            phi_2713_ = vec3<f32>(_e960[2], _e960[0], _e960[1]);
                                        } else {
                                            phi_2713_ = vec3<f32>(_e960[1], _e960[2], _e960[0]);
                                        }
                                        let _e1540 = phi_2713_;
                                        phi_2714_ = _e1540;
                                    }
                                    let _e1543 = phi_2714_;
                                    let _e1546 = (_e1535.x - _e1527.x);
                                    let _e1549 = (_e1535.y - _e1527.y);
                                    let _e1552 = (_e1535.z - _e1527.z);
                                    let _e1554 = (_e1543.x - _e1527.x);
                                    let _e1556 = (_e1543.y - _e1527.y);
                                    let _e1558 = (_e1543.z - _e1527.z);
                                    if (_e1502.member_1 == 1u) {
                                        phi_2750_ = (vec3<f32>(_e1502.member[0], _e1502.member[1], _e1502.member[2]) - _e1527);
                                    } else {
                                        phi_2750_ = vec3<f32>(_e1502.member[0], _e1502.member[1], _e1502.member[2]);
                                    }
                                    let _e1573 = phi_2750_;
                                    let _e1579 = bitcast<f32>((bitcast<u32>((_e1546 * _e1556)) ^ _e1502.member_3[0]));
                                    let _e1583 = bitcast<f32>((bitcast<u32>((_e1549 * _e1554)) ^ _e1502.member_3[0]));
                                    let _e1587 = bitcast<f32>((bitcast<u32>((_e1549 * _e1558)) ^ _e1502.member_3[0]));
                                    let _e1591 = bitcast<f32>((bitcast<u32>((_e1552 * _e1556)) ^ _e1502.member_3[0]));
                                    let _e1595 = bitcast<f32>((bitcast<u32>((_e1552 * _e1554)) ^ _e1502.member_3[0]));
                                    let _e1599 = bitcast<f32>((bitcast<u32>((_e1546 * _e1558)) ^ _e1502.member_3[0]));
                                    let _e1600 = (_e1587 - _e1591);
                                    let _e1601 = (_e1595 - _e1599);
                                    let _e1602 = (_e1579 - _e1583);
                                    let _e1626 = (bitcast<f32>((bitcast<u32>(_e1587) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1591) & 2147483647u)));
                                    let _e1633 = (bitcast<f32>((bitcast<u32>(_e1595) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1599) & 2147483647u)));
                                    let _e1640 = (bitcast<f32>((bitcast<u32>(_e1579) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1583) & 2147483647u)));
                                    if (_e1502.member_2 == 0f) {
                                        phi_2932_ = 0f;
                                    } else {
                                        let _e1670 = bitcast<f32>((bitcast<u32>(_e1600) & 2147483647u));
                                        let _e1673 = bitcast<f32>((bitcast<u32>(_e1601) & 2147483647u));
                                        let _e1676 = bitcast<f32>((bitcast<u32>(_e1602) & 2147483647u));
                                        let _e1678 = select(_e1676, _e1673, (_e1673 > _e1676));
                                        let _e1682 = select(_e1676, _e1673, (_e1673 < _e1676));
                                        let _e1686 = select(_e1673, _e1670, (_e1670 < _e1673));
                                        let _e1688 = select(_e1673, _e1670, (_e1670 > _e1673));
                                        let _e1690 = select(_e1676, _e1688, (_e1688 < _e1676));
                                        phi_2932_ = bitcast<f32>((bitcast<u32>((_e1502.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1678, _e1670, (_e1670 > _e1678)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1690, _e1686, (_e1686 > _e1690)))) ^ _e1502.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1682, _e1670, (_e1670 < _e1682)))) ^ _e1502.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1626 + _e1633) + _e1640))) ^ _e1502.member_3[0]))) * 1.0000005f)) ^ _e1502.member_3[0])))) ^ _e1502.member_3[0]));
                                    }
                                    let _e1717 = phi_2932_;
                                    phi_2950_ = (_e1519 || !(((((bitcast<f32>((bitcast<u32>((_e1573.x * _e1600)) ^ _e1502.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1573.y * _e1601)) ^ _e1502.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1573.z * _e1602)) ^ _e1502.member_3[0]))) * f32(-(_e1518))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1573.x) & 2147483647u)) * _e1626)) ^ _e1502.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1573.y) & 2147483647u)) * _e1633)) ^ _e1502.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1573.z) & 2147483647u)) * _e1640)) ^ _e1502.member_3[0]))))) ^ _e1502.member_3[0])) + _e1717) + 0.0000000000000000000000000000000000001880791f))));
                                }
                                let _e1731 = phi_2950_;
                                phi_2951_ = _e1731;
                            }
                            let _e1733 = phi_2951_;
                            if _e1733 {
                                if (_e1372.member < _e820.member.member.member) {
                                    phi_2971_ = true;
                                } else {
                                    if (_e1372.member == _e820.member.member.member) {
                                        phi_2970_ = (_e1372.member_3 < _e820.member.member.member_3);
                                    } else {
                                        phi_2970_ = false;
                                    }
                                    let _e1745 = phi_2970_;
                                    phi_2971_ = _e1745;
                                }
                                let _e1747 = phi_2971_;
                                if _e1747 {
                                    phi_2978_ = SlimbvhTypeN(SlimbvhTypeJ(_e1372, _e1372.member), _e820.member_1);
                                } else {
                                    phi_2978_ = _e820;
                                }
                                let _e1753 = phi_2978_;
                                if _e1753.member_1 {
                                    phi_2984_ = SlimbvhTypeN(SlimbvhTypeJ(_e1753.member.member, bitcast<f32>(4286578687u)), _e1753.member_1);
                                } else {
                                    phi_2984_ = _e1753;
                                }
                                let _e1762 = phi_2984_;
                                phi_2985_ = _e1762;
                            } else {
                                phi_2985_ = _e820;
                            }
                            let _e1764 = phi_2985_;
                            phi_2986_ = _e1764;
                        } else {
                            phi_2986_ = _e820;
                        }
                        let _e1766 = phi_2986_;
                        phi_1640_ = _e1766;
                    } else {
                        phi_1640_ = SlimbvhTypeN();
                    }
                    let _e1768 = phi_1640_;
                    continue;
                    continuing {
                        phi_1639_ = _e1768;
                        phi_1642_ = _e835;
                        break if !(_e841);
                    }
                }
                let _e1771 = local_5;
                let _e1772 = (_e1771 - 1u);
                let _e1773 = (_e1772 % 128u);
                let _e1775 = local[_e1773];
                let _e1777 = local_6;
                if (_e1775 <= _e1777.member.member_1) {
                    let _e1782 = local_1[_e1773];
                    phi_3011_ = _e1782;
                } else {
                    phi_3011_ = 2147483648u;
                }
                let _e1784 = phi_3011_;
                let _e2034 = local_8;
                phi_3018_ = _e2034;
                phi_3019_ = select(_e1772, 4294967295u, (_e618 > _e1777.member.member_1));
                phi_3020_ = _e1784;
            } else {
                phi_3018_ = _e641;
                let _e2037 = local_9;
                phi_3019_ = _e2037;
                let _e2040 = local_10;
                phi_3020_ = _e2040;
            }
            let _e1788 = phi_3018_;
            let _e1790 = phi_3019_;
            let _e1792 = phi_3020_;
            phi_1289_ = _e1788;
            phi_1292_ = _e1790;
            phi_1294_ = _e1792;
            let _e2046 = local_11;
            phi_1296_ = _e2046;
        } else {
            phi_1289_ = SlimbvhTypeN();
            phi_1292_ = u32();
            phi_1294_ = u32();
            phi_1296_ = u32();
        }
        let _e1794 = phi_1289_;
        let _e1796 = phi_1292_;
        let _e1798 = phi_1294_;
        let _e1800 = phi_1296_;
        continue;
        continuing {
            phi_1288_ = _e1794;
            phi_1291_ = _e1796;
            phi_1293_ = _e1798;
            phi_1295_ = _e1800;
            break if !(_e648);
        }
    }
    let _e1803 = local_7;
    if (_e1803.member.member.member_3 != 4294967295u) {
        let _e1809 = -((_e121 + _e551.member_4));
        let _e1810 = bitcast<u32>(_e1803.member.member.member);
        let _e1814 = (bitcast<i32>((_e1810 >> bitcast<u32>(23i))) & 255i);
        let _e1815 = (_e1814 + _e1809);
        if (_e1814 == 255i) {
            phi_3075_ = _e1803.member.member.member;
        } else {
            if (_e1814 > 0i) {
                if (_e1815 > 0i) {
                    let _e1819 = (_e1815 < 255i);
                    if _e1819 {
                        phi_3054_ = bitcast<f32>((_e1810 + bitcast<u32>((_e1809 << bitcast<u32>(23i)))));
                    } else {
                        phi_3054_ = f32();
                    }
                    let _e1826 = phi_3054_;
                    phi_3056_ = _e1826;
                    phi_3057_ = select(true, false, _e1819);
                } else {
                    phi_3056_ = f32();
                    phi_3057_ = true;
                }
                let _e1829 = phi_3056_;
                let _e1831 = phi_3057_;
                phi_3058_ = _e1829;
                phi_3059_ = _e1831;
            } else {
                phi_3058_ = f32();
                phi_3059_ = true;
            }
            let _e1833 = phi_3058_;
            let _e1835 = phi_3059_;
            if _e1835 {
                let _e1836 = (_e1810 & 2147483648u);
                let _e1843 = ((_e1810 & 8388607u) | (select(0u, 1u, ((_e1810 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e1847 = (_e1843 == 0u);
                if _e1847 {
                    phi_3490_ = bitcast<f32>(_e1836);
                } else {
                    let _e1852 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1843)), 32u, _e1847) - 8u);
                    let _e1855 = (_e1843 << bitcast<u32>((_e1852 & 31u)));
                    let _e1857 = ((_e1815 + select(0i, 1i, (_e1814 == 0i))) - bitcast<i32>(_e1852));
                    if (_e1857 >= 255i) {
                        phi_3480_ = bitcast<f32>((_e1836 | 2139095040u));
                        phi_3481_ = f32();
                        phi_3482_ = true;
                    } else {
                        let _e1859 = (_e1857 > 0i);
                        if _e1859 {
                            phi_3474_ = bitcast<f32>(((_e1836 | (bitcast<u32>(_e1857) << bitcast<u32>(23i))) | (_e1855 & 8388607u)));
                            phi_3475_ = f32();
                        } else {
                            if (_e1857 < -24i) {
                                phi_3440_ = 26u;
                            } else {
                                phi_3440_ = bitcast<u32>((1i - _e1857));
                            }
                            let _e1864 = phi_3440_;
                            let _e1865 = (_e1864 & 31u);
                            let _e1867 = (_e1855 >> bitcast<u32>(_e1865));
                            let _e1871 = (_e1855 & ((1u << bitcast<u32>(_e1865)) - 1u));
                            let _e1875 = (1u << bitcast<u32>(((_e1864 - 1u) & 31u)));
                            if (_e1871 > _e1875) {
                                phi_3461_ = true;
                            } else {
                                if (_e1871 == _e1875) {
                                    phi_3458_ = ((_e1867 & 1u) == 1u);
                                } else {
                                    phi_3458_ = false;
                                }
                                let _e1881 = phi_3458_;
                                phi_3461_ = _e1881;
                            }
                            let _e1883 = phi_3461_;
                            phi_3474_ = f32();
                            phi_3475_ = bitcast<f32>((_e1836 | (_e1867 + select(0u, 1u, _e1883))));
                        }
                        let _e1896 = phi_3474_;
                        let _e1898 = phi_3475_;
                        phi_3480_ = _e1896;
                        phi_3481_ = _e1898;
                        phi_3482_ = _e1859;
                    }
                    let _e1902 = phi_3480_;
                    let _e1904 = phi_3481_;
                    let _e1906 = phi_3482_;
                    phi_3490_ = select(_e1904, _e1902, _e1906);
                }
                let _e1910 = phi_3490_;
                phi_3074_ = _e1910;
            } else {
                phi_3074_ = _e1833;
            }
            let _e1912 = phi_3074_;
            phi_3075_ = _e1912;
        }
        let _e1914 = phi_3075_;
        let _e1915 = bitcast<u32>(_e1914);
        if ((_e1915 & 2147483647u) >= 2139095040u) {
            phi_3087_ = bitcast<f32>(((_e1915 & 2147483648u) | 2139095039u));
        } else {
            phi_3087_ = _e1914;
        }
        let _e1922 = phi_3087_;
        phi_3092_ = SlimbvhTypeG(_e1922, _e1803.member.member.member_1, _e1803.member.member.member_2, _e1803.member.member.member_3);
    } else {
        phi_3092_ = _e85;
    }
    let _e1927 = phi_3092_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1927.member), bitcast<u32>(_e1927.member_1), bitcast<u32>(_e1927.member_2), _e1927.member_3);
    return;
}

struct SlimbvhTypeO {
    member: array<vec4<f32>, 3>,
}

struct SlimbvhTypeP {
    member: vec2<f32>,
}

struct SlimbvhTypeQ {
    member: array<vec4<f32>, 5>,
}

var<private> slimbvh_corners: SlimbvhTypeO;

var<private> slimbvh_weights: SlimbvhTypeP;

var<private> slimbvh_from: SlimbvhTypeL;

var<private> slimbvh_point: SlimbvhTypeQ;

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
