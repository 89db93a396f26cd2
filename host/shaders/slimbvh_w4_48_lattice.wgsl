// Made by slimbvh's shader builder from its Rust: rays traced from your own WGSL. Put this text before yours, bind the
// tree's exponent, nodes, triangles and, if it has one, root to group 0, and call
//
//   slimbvh_closest_hit(origin, t_min, direction, t_max) -> SlimbvhHit
//   slimbvh_any_hit(origin, t_min, direction, t_max) -> bool
//
// from any stage. t is in units of the direction's length; a miss has the primitive 0xffffffff. The stack is private
// memory, up to 1 KiB an invocation: in compute shaders the functions of the text slimbvh_compute are faster.

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
    member: SlimbvhTypeF,
    member_1: f32,
}

struct SlimbvhTypeI {
    member: u32,
    member_1: f32,
}

struct SlimbvhTypeJ {
    member: array<array<vec4<u32>, 3>>,
}

struct SlimbvhTypeK {
    member: vec4<f32>,
    member_1: u32,
}

struct SlimbvhTypeL {
    member: SlimbvhTypeK,
    member_1: u32,
    member_2: u32,
}

struct SlimbvhTypeM {
    member: vec4<f32>,
}

struct SlimbvhTypeN {
    member: u32,
}

struct SlimbvhTypeO {
    member: SlimbvhTypeH,
    member_1: bool,
}

@group(0) @binding(0) 
var<uniform> slimbvh_exponent: SlimbvhTypeA;

@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeJ;

@group(0) @binding(2) 
var<storage> slimbvh_triangles: SlimbvhTypeB;

@group(0) @binding(3) 
var<uniform> slimbvh_root: SlimbvhTypeG;

var<private> slimbvh_origin: SlimbvhTypeM;

var<private> slimbvh_direction: SlimbvhTypeM;

var<private> slimbvh_any_will_do: SlimbvhTypeN;

var<private> slimbvh_hit: SlimbvhTypeA;

fn slimbvh_trace() {
    var local: array<u32, 128>;
    var phi_717_: u32;
    var phi_723_: u32;
    var phi_729_: u32;
    var phi_994_: i32;
    var phi_1005_: i32;
    var phi_1119_: i32;
    var phi_1248_: i32;
    var phi_1270_: u32;
    var phi_1271_: u32;
    var phi_1272_: bool;
    var phi_1306_: i32;
    var phi_1328_: u32;
    var phi_1329_: u32;
    var phi_1330_: bool;
    var phi_891_: i32;
    var phi_897_: u32;
    var phi_916_: u32;
    var phi_917_: u32;
    var phi_918_: bool;
    var phi_936_: i32;
    var phi_942_: u32;
    var phi_961_: u32;
    var phi_962_: u32;
    var phi_963_: bool;
    var phi_1340_: SlimbvhTypeC;
    var phi_1569_: SlimbvhTypeO;
    var phi_1632_: array<f32, 3>;
    var phi_1633_: array<f32, 3>;
    var phi_1651_: array<f32, 3>;
    var phi_1652_: array<f32, 3>;
    var phi_1825_: SlimbvhTypeO;
    var phi_1828_: u32;
    var phi_1830_: u32;
    var phi_1832_: u32;
    var phi_1841_: u32;
    var phi_1844_: u32;
    var phi_1846_: u32;
    var phi_1948_: SlimbvhTypeI;
    var phi_1949_: SlimbvhTypeI;
    var phi_2008_: SlimbvhTypeI;
    var phi_2009_: SlimbvhTypeI;
    var phi_2068_: SlimbvhTypeI;
    var phi_2069_: SlimbvhTypeI;
    var phi_2559_: u32;
    var phi_2572_: u32;
    var phi_2585_: u32;
    var phi_2598_: u32;
    var phi_4802_: SlimbvhTypeD;
    var phi_4814_: SlimbvhTypeD;
    var phi_4826_: SlimbvhTypeD;
    var phi_4838_: SlimbvhTypeD;
    var phi_4850_: SlimbvhTypeD;
    var phi_2679_: u32;
    var phi_2684_: u32;
    var phi_2685_: u32;
    var phi_2739_: u32;
    var phi_2740_: u32;
    var phi_1842_: u32;
    var phi_1845_: u32;
    var phi_1847_: u32;
    var local_1: bool;
    var local_2: u32;
    var phi_2925_: u32;
    var phi_2930_: u32;
    var phi_2973_: SlimbvhTypeL;
    var phi_2977_: SlimbvhTypeO;
    var phi_2980_: SlimbvhTypeD;
    var phi_2981_: SlimbvhTypeD;
    var phi_3003_: SlimbvhTypeD;
    var phi_3031_: u32;
    var phi_3054_: u32;
    var phi_3063_: u32;
    var phi_3073_: u32;
    var phi_3532_: u32;
    var phi_3545_: u32;
    var phi_3558_: u32;
    var phi_3584_: u32;
    var phi_3597_: u32;
    var phi_3610_: u32;
    var phi_3636_: u32;
    var phi_3649_: u32;
    var phi_3662_: u32;
    var phi_3254_: u32;
    var phi_3267_: u32;
    var phi_3277_: u32;
    var phi_3298_: u32;
    var phi_3319_: u32;
    var phi_3346_: u32;
    var phi_3359_: u32;
    var phi_3369_: u32;
    var phi_3390_: u32;
    var phi_3411_: u32;
    var phi_3438_: u32;
    var phi_3451_: u32;
    var phi_3461_: u32;
    var phi_3482_: u32;
    var phi_3503_: u32;
    var phi_3115_: u32;
    var phi_3161_: u32;
    var phi_3207_: u32;
    var phi_3674_: array<array<f32, 3>, 3>;
    var phi_4039_: f32;
    var phi_4040_: f32;
    var phi_4041_: f32;
    var phi_4042_: f32;
    var phi_4043_: vec3<f32>;
    var phi_4044_: vec3<f32>;
    var phi_4045_: vec3<f32>;
    var phi_4046_: vec3<f32>;
    var phi_4225_: f32;
    var phi_4251_: SlimbvhTypeE;
    var phi_4252_: SlimbvhTypeE;
    var phi_4255_: SlimbvhTypeE;
    var phi_4256_: SlimbvhTypeE;
    var phi_4257_: bool;
    var phi_4261_: SlimbvhTypeE;
    var phi_4270_: SlimbvhTypeF;
    var phi_4297_: bool;
    var phi_4298_: bool;
    var phi_4305_: SlimbvhTypeO;
    var phi_4311_: SlimbvhTypeO;
    var phi_4312_: SlimbvhTypeO;
    var phi_4313_: SlimbvhTypeO;
    var phi_2978_: SlimbvhTypeO;
    var local_3: u32;
    var local_4: u32;
    var phi_4402_: u32;
    var phi_4403_: u32;
    var local_5: SlimbvhTypeO;
    var phi_4412_: SlimbvhTypeO;
    var phi_4413_: u32;
    var phi_4414_: u32;
    var phi_1826_: SlimbvhTypeO;
    var phi_1829_: u32;
    var phi_1831_: u32;
    var phi_1833_: u32;
    var local_6: SlimbvhTypeO;
    var phi_4450_: f32;
    var phi_4452_: f32;
    var phi_4453_: bool;
    var phi_4454_: f32;
    var phi_4455_: bool;
    var phi_5081_: u32;
    var phi_5099_: bool;
    var phi_5102_: bool;
    var phi_5115_: f32;
    var phi_5116_: f32;
    var phi_5121_: f32;
    var phi_5122_: f32;
    var phi_5123_: bool;
    var phi_5131_: f32;
    var phi_4470_: f32;
    var phi_4471_: f32;
    var phi_4483_: f32;
    var phi_4488_: SlimbvhTypeF;
    var local_7: SlimbvhTypeO;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e110 = SlimbvhTypeF(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e114 = arrayLength((&slimbvh_nodes.member));
    let _e117 = arrayLength((&slimbvh_triangles.member));
    let _e125 = slimbvh_root.member[0u][0u];
    let _e129 = slimbvh_root.member[0u][1u];
    let _e133 = slimbvh_root.member[0u][2u];
    let _e137 = slimbvh_root.member[0u][3u];
    let _e141 = slimbvh_root.member[1u][0u];
    let _e145 = slimbvh_root.member[1u][1u];
    let _e149 = slimbvh_root.member[1u][2u];
    let _e161 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e137) + 127i)) << bitcast<u32>(23i)));
    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    let _e162 = slimbvh_origin.member;
    let _e168 = slimbvh_origin.member[3u];
    let _e169 = slimbvh_direction.member;
    let _e175 = slimbvh_direction.member[3u];
    let _e178 = slimbvh_exponent.member[0u];
    let _e179 = bitcast<i32>(_e178);
    let _e181 = (bitcast<u32>(_e162.x) & 2147483647u);
    let _e183 = (bitcast<u32>(_e162.y) & 2147483647u);
    let _e185 = (bitcast<u32>(_e162.z) & 2147483647u);
    let _e186 = bitcast<u32>(_e168);
    let _e187 = (_e186 & 2147483647u);
    let _e189 = (bitcast<u32>(_e169.x) & 2147483647u);
    let _e191 = (bitcast<u32>(_e169.y) & 2147483647u);
    let _e193 = (bitcast<u32>(_e169.z) & 2147483647u);
    let _e194 = bitcast<u32>(_e175);
    let _e195 = (_e194 & 2147483647u);
    let _e197 = select(_e191, _e189, (_e191 < _e189));
    let _e199 = select(_e193, _e197, (_e193 < _e197));
    let _e201 = select(_e181, _e199, (_e181 < _e199));
    let _e203 = select(_e183, _e201, (_e183 < _e201));
    let _e205 = select(_e185, _e203, (_e185 < _e203));
    let _e212 = (((select(_e187, _e205, (_e187 < _e205)) < 2139095040u) && (_e195 <= 2139095040u)) && (_e199 > 0u));
    if (_e189 == _e199) {
        phi_717_ = 0u;
    } else {
        phi_717_ = select(2u, 1u, (_e191 == _e199));
    }
    let _e217 = phi_717_;
    let _e218 = (_e217 == 2u);
    if _e218 {
        phi_723_ = 0u;
    } else {
        phi_723_ = (_e217 + 1u);
    }
    let _e221 = phi_723_;
    let _e222 = (_e221 == 2u);
    if _e222 {
        phi_729_ = 0u;
    } else {
        phi_729_ = (_e221 + 1u);
    }
    let _e225 = phi_729_;
    let _e226 = (_e221 == 0u);
    let _e228 = select(select(_e162.y, _e162.x, _e226), _e162.z, _e222);
    let _e229 = (_e225 == 0u);
    let _e231 = (_e225 == 2u);
    let _e232 = select(select(_e162.y, _e162.x, _e229), _e162.z, _e231);
    let _e233 = (_e217 == 0u);
    let _e235 = select(select(_e162.y, _e162.x, _e233), _e162.z, _e218);
    let _e237 = select(select(_e169.y, _e169.x, _e226), _e169.z, _e222);
    let _e239 = select(select(_e169.y, _e169.x, _e229), _e169.z, _e231);
    let _e241 = select(select(_e169.y, _e169.x, _e233), _e169.z, _e218);
    let _e242 = (_e187 - 1u);
    let _e243 = (_e195 - 1u);
    let _e245 = select(_e242, _e243, (_e243 < _e242));
    let _e246 = (_e181 - 1u);
    let _e247 = (_e183 - 1u);
    let _e249 = select(_e246, _e247, (_e247 < _e246));
    let _e250 = (_e185 - 1u);
    let _e252 = select(_e249, _e250, (_e250 < _e249));
    let _e253 = (_e189 - 1u);
    let _e254 = (_e191 - 1u);
    let _e256 = select(_e253, _e254, (_e254 < _e253));
    let _e257 = (_e193 - 1u);
    let _e259 = select(_e256, _e257, (_e257 < _e256));
    let _e261 = select(_e252, _e259, (_e259 < _e252));
    if (((select(_e261, _e245, (_e245 < _e261)) >= 8388607u) && (_e199 < 2130706432u)) && (bitcast<u32>((_e179 + 126i)) <= 253u)) {
        let _e526 = bitcast<i32>((_e199 >> bitcast<u32>(23i)));
        let _e527 = (_e526 - 127i);
        let _e528 = (_e179 + _e527);
        let _e533 = bitcast<f32>((bitcast<u32>((_e179 + 127i)) << bitcast<u32>(23i)));
        let _e538 = bitcast<f32>((bitcast<u32>((254i - _e526)) << bitcast<u32>(23i)));
        if (_e187 >= 2139095040u) {
            phi_891_ = 255i;
        } else {
            phi_891_ = (bitcast<i32>((_e187 >> bitcast<u32>(23i))) + _e528);
        }
        let _e553 = phi_891_;
        if (_e187 == 0u) {
            phi_897_ = 0u;
        } else {
            phi_897_ = (_e187 | 8388608u);
        }
        let _e557 = phi_897_;
        if (_e553 <= 0i) {
            phi_917_ = u32();
            phi_918_ = true;
        } else {
            let _e564 = (_e557 == 0u);
            if _e564 {
                phi_916_ = u32();
            } else {
                phi_916_ = select(((bitcast<u32>(_e553) << bitcast<u32>(23i)) | (_e557 & 8388607u)), 2139095039u, (_e553 >= 255i));
            }
            let _e568 = phi_916_;
            phi_917_ = _e568;
            phi_918_ = _e564;
        }
        let _e570 = phi_917_;
        let _e572 = phi_918_;
        if (_e195 >= 2139095040u) {
            phi_936_ = 255i;
        } else {
            phi_936_ = (bitcast<i32>((_e195 >> bitcast<u32>(23i))) + _e528);
        }
        let _e583 = phi_936_;
        if (_e195 == 0u) {
            phi_942_ = 0u;
        } else {
            phi_942_ = (_e195 | 8388608u);
        }
        let _e587 = phi_942_;
        if (_e583 <= 0i) {
            phi_962_ = u32();
            phi_963_ = true;
        } else {
            let _e594 = (_e587 == 0u);
            if _e594 {
                phi_961_ = u32();
            } else {
                phi_961_ = select(((bitcast<u32>(_e583) << bitcast<u32>(23i)) | (_e587 & 8388607u)), 2139095039u, (_e583 >= 255i));
            }
            let _e598 = phi_961_;
            phi_962_ = _e598;
            phi_963_ = _e594;
        }
        let _e600 = phi_962_;
        let _e602 = phi_963_;
        phi_1340_ = SlimbvhTypeC(array<f32, 3>((_e228 * _e533), (_e232 * _e533), (_e235 * _e533)), array<f32, 3>((_e237 * _e538), (_e239 * _e538), (_e241 * _e538)), bitcast<f32>(((_e186 & 2147483648u) | select(_e570, 0u, _e572))), bitcast<f32>(((_e194 & 2147483648u) | select(_e600, 0u, _e602))), _e527);
    } else {
        let _e274 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e199, _e212))) & 2147483647u);
        if (_e274 >= 8388608u) {
            phi_994_ = (bitcast<i32>((_e274 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_994_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e274)), 32u, (_e274 == 0u))));
        }
        let _e288 = phi_994_;
        let _e289 = (_e179 + _e288);
        if (_e179 < -126i) {
            phi_1005_ = -126i;
        } else {
            phi_1005_ = select(_e179, 127i, (_e179 > 127i));
        }
        let _e294 = phi_1005_;
        let _e299 = bitcast<f32>((bitcast<u32>((_e294 + 127i)) << bitcast<u32>(23i)));
        let _e305 = bitcast<f32>((bitcast<u32>(((_e179 - _e294) + 127i)) << bitcast<u32>(23i)));
        let _e306 = bitcast<u32>(_e228);
        let _e308 = ((_e306 & 2139095040u) != 0u);
        let _e323 = bitcast<u32>(_e232);
        let _e325 = ((_e323 & 2139095040u) != 0u);
        let _e340 = bitcast<u32>(_e235);
        let _e342 = ((_e340 & 2139095040u) != 0u);
        let _e358 = -(_e288);
        if (_e358 < -126i) {
            phi_1119_ = -126i;
        } else {
            phi_1119_ = select(_e358, 127i, (_e358 > 127i));
        }
        let _e363 = phi_1119_;
        let _e368 = bitcast<f32>((bitcast<u32>((_e363 + 127i)) << bitcast<u32>(23i)));
        let _e374 = bitcast<f32>((bitcast<u32>(((_e358 - _e363) + 127i)) << bitcast<u32>(23i)));
        let _e375 = bitcast<u32>(_e237);
        let _e377 = ((_e375 & 2139095040u) != 0u);
        let _e392 = bitcast<u32>(_e239);
        let _e394 = ((_e392 & 2139095040u) != 0u);
        let _e409 = bitcast<u32>(_e241);
        let _e411 = ((_e409 & 2139095040u) != 0u);
        let _e433 = ((_e187 & 8388607u) | (select(0u, 1u, ((_e187 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e436 = bitcast<i32>((_e187 >> bitcast<u32>(23i)));
        let _e443 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e433)), 32u, (_e433 == 0u))) - 8i);
        if (_e436 == 255i) {
            phi_1248_ = 255i;
        } else {
            phi_1248_ = (((_e436 + select(0i, 1i, (_e436 == 0i))) - _e443) + _e289);
        }
        let _e451 = phi_1248_;
        let _e455 = (_e433 << bitcast<u32>(((_e443 & 31i) & 31i)));
        if (_e451 <= 0i) {
            phi_1271_ = u32();
            phi_1272_ = true;
        } else {
            let _e462 = (_e455 == 0u);
            if _e462 {
                phi_1270_ = u32();
            } else {
                phi_1270_ = select(((bitcast<u32>(_e451) << bitcast<u32>(23i)) | (_e455 & 8388607u)), 2139095039u, (_e451 >= 255i));
            }
            let _e466 = phi_1270_;
            phi_1271_ = _e466;
            phi_1272_ = _e462;
        }
        let _e468 = phi_1271_;
        let _e470 = phi_1272_;
        let _e481 = ((_e195 & 8388607u) | (select(0u, 1u, ((_e195 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e484 = bitcast<i32>((_e195 >> bitcast<u32>(23i)));
        let _e491 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e481)), 32u, (_e481 == 0u))) - 8i);
        if (_e484 == 255i) {
            phi_1306_ = 255i;
        } else {
            phi_1306_ = (((_e484 + select(0i, 1i, (_e484 == 0i))) - _e491) + _e289);
        }
        let _e499 = phi_1306_;
        let _e503 = (_e481 << bitcast<u32>(((_e491 & 31i) & 31i)));
        if (_e499 <= 0i) {
            phi_1329_ = u32();
            phi_1330_ = true;
        } else {
            let _e510 = (_e503 == 0u);
            if _e510 {
                phi_1328_ = u32();
            } else {
                phi_1328_ = select(((bitcast<u32>(_e499) << bitcast<u32>(23i)) | (_e503 & 8388607u)), 2139095039u, (_e499 >= 255i));
            }
            let _e514 = phi_1328_;
            phi_1329_ = _e514;
            phi_1330_ = _e510;
        }
        let _e516 = phi_1329_;
        let _e518 = phi_1330_;
        phi_1340_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e306 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e306 & 2147483648u))), _e228, _e308) * _e299) * select(0.00000011920929f, 1f, _e308)) * _e305), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e323 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e323 & 2147483648u))), _e232, _e325) * _e299) * select(0.00000011920929f, 1f, _e325)) * _e305), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e340 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e340 & 2147483648u))), _e235, _e342) * _e299) * select(0.00000011920929f, 1f, _e342)) * _e305)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e375 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e375 & 2147483648u))), _e237, _e377) * _e368) * select(0.00000011920929f, 1f, _e377)) * _e374), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e392 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e392 & 2147483648u))), _e239, _e394) * _e368) * select(0.00000011920929f, 1f, _e394)) * _e374), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e409 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e409 & 2147483648u))), _e241, _e411) * _e368) * select(0.00000011920929f, 1f, _e411)) * _e374)), bitcast<f32>(((_e186 & 2147483648u) | select(_e468, 0u, _e470))), bitcast<f32>(((_e194 & 2147483648u) | select(_e516, 0u, _e518))), _e288);
    }
    let _e609 = phi_1340_;
    let _e624 = (bitcast<f32>((bitcast<u32>(_e609.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e627 = bitcast<f32>((bitcast<u32>(_e609.member[0]) & 2147483647u));
    let _e628 = (_e627 * 0.00000011920929f);
    let _e631 = select(select(0.00000000000011368684f, _e628, (_e628 > 0.00000000000011368684f)), 0f, _e624);
    let _e632 = select(0f, _e609.member_1[0], _e624);
    let _e633 = (_e609.member[0] + _e631);
    let _e634 = (_e609.member[0] - _e631);
    let _e636 = select(38685626000000000000000000f, (1f / _e609.member_1[0]), _e624);
    let _e640 = (bitcast<f32>((bitcast<u32>(_e609.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e643 = bitcast<f32>((bitcast<u32>(_e609.member[1]) & 2147483647u));
    let _e644 = (_e643 * 0.00000011920929f);
    let _e647 = select(select(0.00000000000011368684f, _e644, (_e644 > 0.00000000000011368684f)), 0f, _e640);
    let _e648 = select(0f, _e609.member_1[1], _e640);
    let _e649 = (_e609.member[1] + _e647);
    let _e650 = (_e609.member[1] - _e647);
    let _e652 = select(38685626000000000000000000f, (1f / _e609.member_1[1]), _e640);
    let _e656 = (bitcast<f32>((bitcast<u32>(_e609.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e659 = bitcast<f32>((bitcast<u32>(_e609.member[2]) & 2147483647u));
    let _e660 = (_e659 * 0.00000011920929f);
    let _e663 = select(select(0.00000000000011368684f, _e660, (_e660 > 0.00000000000011368684f)), 0f, _e656);
    let _e664 = select(0f, _e609.member_1[2], _e656);
    let _e665 = (_e609.member[2] + _e663);
    let _e666 = (_e609.member[2] - _e663);
    let _e668 = select(38685626000000000000000000f, (1f / _e609.member_1[2]), _e656);
    let _e670 = select(_e643, _e627, (_e627 > _e643));
    let _e674 = (_e212 && (select(_e659, _e670, (_e670 > _e659)) <= 1099511600000f));
    let _e675 = select(0f, _e609.member_3, _e674);
    let _e676 = select(1f, _e609.member_2, _e674);
    let _e678 = slimbvh_any_will_do.member;
    if (_e678 == 1u) {
        phi_1569_ = SlimbvhTypeO(SlimbvhTypeH(_e110, _e675), true);
    } else {
        phi_1569_ = SlimbvhTypeO(SlimbvhTypeH(_e110, _e675), false);
    }
    let _e685 = phi_1569_;
    let _e690 = (_e221 & 3u);
    let _e691 = (_e225 & 3u);
    let _e692 = (_e217 & 3u);
    let _e705 = (f32(bitcast<i32>(_e125)) * _e161);
    let _e707 = (f32(bitcast<i32>(_e129)) * _e161);
    let _e709 = (f32(bitcast<i32>(_e133)) * _e161);
    let _e710 = (_e690 == 0u);
    if _e710 {
        phi_1633_ = array<f32, 3>(_e705, _e707, _e709);
    } else {
        if (_e690 == 1u) {
            phi_1632_ = array<f32, 3>(_e707, _e709, _e705);
        } else {
            phi_1632_ = array<f32, 3>(_e709, _e705, _e707);
        }
        let _e715 = phi_1632_;
        phi_1633_ = _e715;
    }
    let _e718 = phi_1633_;
    let _e720 = (f32(bitcast<i32>(_e141)) * _e161);
    let _e722 = (f32(bitcast<i32>(_e145)) * _e161);
    let _e724 = (f32(bitcast<i32>(_e149)) * _e161);
    if _e710 {
        phi_1652_ = array<f32, 3>(_e720, _e722, _e724);
    } else {
        if (_e690 == 1u) {
            phi_1651_ = array<f32, 3>(_e722, _e724, _e720);
        } else {
            phi_1651_ = array<f32, 3>(_e724, _e720, _e722);
        }
        let _e729 = phi_1651_;
        phi_1652_ = _e729;
    }
    let _e732 = phi_1652_;
    let _e743 = ((_e718[0] - _e633) * _e636);
    let _e744 = ((_e732[0] - _e634) * _e636);
    let _e745 = vec4<f32>(_e743, f32(), _e744, f32());
    let _e748 = ((_e718[1] - _e649) * _e652);
    let _e749 = ((_e732[1] - _e650) * _e652);
    let _e750 = vec4<f32>(_e748, f32(), _e749, f32());
    let _e753 = ((_e718[2] - _e665) * _e668);
    let _e754 = ((_e732[2] - _e666) * _e668);
    let _e755 = vec4<f32>(_e753, f32(), _e754, f32());
    let _e756 = vec4<f32>(_e744, f32(), _e743, f32());
    let _e758 = vec4<f32>(_e749, f32(), _e748, f32());
    let _e760 = vec4<f32>(_e754, f32(), _e753, f32());
    phi_1825_ = _e685;
    phi_1828_ = select(4294967295u, select(4294967295u, 0u, (_e676 <= _e675)), (max(max(max(min(_e745, _e756).x, min(_e750, _e758).x), min(_e755, _e760).x), _e676) <= min((min(min(max(_e745, _e756).x, max(_e750, _e758).x), max(_e755, _e760).x) + (max(max(_e755, _e760).x, -(min(_e755, _e760).x)) * 0.0000019073523f)), _e685.member.member_1)));
    phi_1830_ = select(0u, 4294967295u, (_e114 == 0u));
    phi_1832_ = (_e114 + 1u);
    loop {
        let _e784 = phi_1825_;
        let _e786 = phi_1828_;
        let _e788 = phi_1830_;
        let _e790 = phi_1832_;
        local_6 = _e784;
        let _e791 = (_e786 <= 2147483647u);
        if _e791 {
            phi_1841_ = _e786;
            phi_1844_ = _e788;
            phi_1846_ = _e790;
            loop {
                let _e793 = phi_1841_;
                let _e795 = phi_1844_;
                let _e797 = phi_1846_;
                local_2 = _e795;
                local_3 = _e793;
                local_4 = _e793;
                local_8 = _e793;
                local_9 = _e795;
                local_10 = _e797;
                let _e798 = (_e793 <= 2147483647u);
                let _e801 = (_e798 && !((_e795 >= _e114)));
                local_1 = _e798;
                if _e801 {
                    let _e806 = slimbvh_nodes.member[_e795][select(_e690, 2u, (2u < _e690))];
                    let _e811 = slimbvh_nodes.member[_e795][select(_e691, 2u, (2u < _e691))];
                    let _e816 = slimbvh_nodes.member[_e795][select(_e692, 2u, (2u < _e692))];
                    let _e819 = bitcast<u32>(_e161);
                    let _e824 = bitcast<f32>(_e806.x);
                    let _e825 = bitcast<f32>((_e819 + ((_e806.w & 31u) << bitcast<u32>(23i))));
                    let _e826 = (_e824 + _e825);
                    if ((bitcast<u32>(_e636) >> bitcast<u32>(31i)) == 0u) {
                        phi_1948_ = SlimbvhTypeI(_e806.z, _e826);
                        phi_1949_ = SlimbvhTypeI(_e806.y, _e824);
                    } else {
                        phi_1948_ = SlimbvhTypeI(_e806.y, _e824);
                        phi_1949_ = SlimbvhTypeI(_e806.z, _e826);
                    }
                    let _e837 = phi_1948_;
                    let _e839 = phi_1949_;
                    let _e878 = bitcast<f32>(_e811.x);
                    let _e879 = bitcast<f32>((_e819 + ((_e811.w & 31u) << bitcast<u32>(23i))));
                    let _e880 = (_e878 + _e879);
                    if ((bitcast<u32>(_e652) >> bitcast<u32>(31i)) == 0u) {
                        phi_2008_ = SlimbvhTypeI(_e811.z, _e880);
                        phi_2009_ = SlimbvhTypeI(_e811.y, _e878);
                    } else {
                        phi_2008_ = SlimbvhTypeI(_e811.y, _e878);
                        phi_2009_ = SlimbvhTypeI(_e811.z, _e880);
                    }
                    let _e891 = phi_2008_;
                    let _e893 = phi_2009_;
                    let _e932 = bitcast<f32>(_e816.x);
                    let _e933 = bitcast<f32>((_e819 + ((_e816.w & 31u) << bitcast<u32>(23i))));
                    let _e934 = (_e932 + _e933);
                    if ((bitcast<u32>(_e668) >> bitcast<u32>(31i)) == 0u) {
                        phi_2068_ = SlimbvhTypeI(_e816.z, _e934);
                        phi_2069_ = SlimbvhTypeI(_e816.y, _e932);
                    } else {
                        phi_2068_ = SlimbvhTypeI(_e816.y, _e932);
                        phi_2069_ = SlimbvhTypeI(_e816.z, _e934);
                    }
                    let _e945 = phi_2068_;
                    let _e947 = phi_2069_;
                    let _e982 = (_e825 * _e636);
                    let _e985 = bitcast<f32>((bitcast<u32>(_e982) & 2147483647u));
                    let _e989 = (((_e839.member_1 - _e633) * _e636) + (_e985 * -0.00012207031f));
                    let _e1001 = (((_e837.member_1 - _e634) * _e636) + (_e985 * 0.00012207031f));
                    let _e1010 = (_e879 * _e652);
                    let _e1013 = bitcast<f32>((bitcast<u32>(_e1010) & 2147483647u));
                    let _e1017 = (((_e893.member_1 - _e649) * _e652) + (_e1013 * -0.00012207031f));
                    let _e1029 = (((_e891.member_1 - _e650) * _e652) + (_e1013 * 0.00012207031f));
                    let _e1038 = (_e933 * _e668);
                    let _e1041 = bitcast<f32>((bitcast<u32>(_e1038) & 2147483647u));
                    let _e1045 = (((_e947.member_1 - _e665) * _e668) + (_e1041 * -0.00012207031f));
                    let _e1050 = ((f32((_e947.member & 255u)) * _e1038) + _e1045);
                    let _e1051 = ((f32(((_e947.member >> bitcast<u32>(8u)) & 255u)) * _e1038) + _e1045);
                    let _e1052 = ((f32(((_e947.member >> bitcast<u32>(16u)) & 255u)) * _e1038) + _e1045);
                    let _e1053 = ((f32(((_e947.member >> bitcast<u32>(24u)) & 255u)) * _e1038) + _e1045);
                    let _e1057 = (((_e945.member_1 - _e666) * _e668) + (_e1041 * 0.00012207031f));
                    let _e1062 = ((f32((_e945.member & 255u)) * _e1038) + _e1057);
                    let _e1063 = ((f32(((_e945.member >> bitcast<u32>(8u)) & 255u)) * _e1038) + _e1057);
                    let _e1064 = ((f32(((_e945.member >> bitcast<u32>(16u)) & 255u)) * _e1038) + _e1057);
                    let _e1065 = ((f32(((_e945.member >> bitcast<u32>(24u)) & 255u)) * _e1038) + _e1057);
                    let _e1098 = max(max(max(((f32((_e839.member & 255u)) * _e982) + _e989), ((f32((_e893.member & 255u)) * _e1010) + _e1017)), _e1050), _e676);
                    let _e1099 = max(max(max(((f32(((_e839.member >> bitcast<u32>(8u)) & 255u)) * _e982) + _e989), ((f32(((_e893.member >> bitcast<u32>(8u)) & 255u)) * _e1010) + _e1017)), _e1051), _e676);
                    let _e1100 = max(max(max(((f32(((_e839.member >> bitcast<u32>(16u)) & 255u)) * _e982) + _e989), ((f32(((_e893.member >> bitcast<u32>(16u)) & 255u)) * _e1010) + _e1017)), _e1052), _e676);
                    let _e1101 = max(max(max(((f32(((_e839.member >> bitcast<u32>(24u)) & 255u)) * _e982) + _e989), ((f32(((_e893.member >> bitcast<u32>(24u)) & 255u)) * _e1010) + _e1017)), _e1053), _e676);
                    let _e1106 = (_e784.member.member_1 + (bitcast<f32>((bitcast<u32>(_e784.member.member_1) & 2147483647u)) * 0.0000004768374f));
                    if (_e1098 <= min((min(min(((f32((_e837.member & 255u)) * _e982) + _e1001), ((f32((_e891.member & 255u)) * _e1010) + _e1029)), _e1062) + (max(_e1062, -(_e1050)) * 0.0000023841915f)), _e1106)) {
                        phi_2559_ = (((bitcast<u32>(_e1098) ^ select(0u, 4294967288u, _e685.member_1)) & 2147483640u) | 4u);
                    } else {
                        phi_2559_ = 4294967288u;
                    }
                    let _e1121 = phi_2559_;
                    if (_e1099 <= min((min(min(((f32(((_e837.member >> bitcast<u32>(8u)) & 255u)) * _e982) + _e1001), ((f32(((_e891.member >> bitcast<u32>(8u)) & 255u)) * _e1010) + _e1029)), _e1063) + (max(_e1063, -(_e1051)) * 0.0000023841915f)), _e1106)) {
                        phi_2572_ = ((((bitcast<u32>(_e1099) ^ select(0u, 4294967288u, _e685.member_1)) & 2147483640u) | 4u) | 1u);
                    } else {
                        phi_2572_ = 4294967288u;
                    }
                    let _e1129 = phi_2572_;
                    if (_e1100 <= min((min(min(((f32(((_e837.member >> bitcast<u32>(16u)) & 255u)) * _e982) + _e1001), ((f32(((_e891.member >> bitcast<u32>(16u)) & 255u)) * _e1010) + _e1029)), _e1064) + (max(_e1064, -(_e1052)) * 0.0000023841915f)), _e1106)) {
                        phi_2585_ = ((((bitcast<u32>(_e1100) ^ select(0u, 4294967288u, _e685.member_1)) & 2147483640u) | 4u) | 2u);
                    } else {
                        phi_2585_ = 4294967288u;
                    }
                    let _e1137 = phi_2585_;
                    if (_e1101 <= min((min(min(((f32(((_e837.member >> bitcast<u32>(24u)) & 255u)) * _e982) + _e1001), ((f32(((_e891.member >> bitcast<u32>(24u)) & 255u)) * _e1010) + _e1029)), _e1065) + (max(_e1065, -(_e1053)) * 0.0000023841915f)), _e1106)) {
                        phi_2598_ = ((((bitcast<u32>(_e1101) ^ select(0u, 4294967288u, _e685.member_1)) & 2147483640u) | 4u) | 3u);
                    } else {
                        phi_2598_ = 4294967288u;
                    }
                    let _e1145 = phi_2598_;
                    if (_e1121 < _e1129) {
                        phi_4802_ = SlimbvhTypeD(_e1121, _e1129);
                    } else {
                        phi_4802_ = SlimbvhTypeD(_e1129, _e1121);
                    }
                    let _e1150 = phi_4802_;
                    if (_e1137 < _e1145) {
                        phi_4814_ = SlimbvhTypeD(_e1137, _e1145);
                    } else {
                        phi_4814_ = SlimbvhTypeD(_e1145, _e1137);
                    }
                    let _e1157 = phi_4814_;
                    if (_e1150.member < _e1157.member) {
                        phi_4826_ = SlimbvhTypeD(_e1150.member, _e1157.member);
                    } else {
                        phi_4826_ = SlimbvhTypeD(_e1157.member, _e1150.member);
                    }
                    let _e1164 = phi_4826_;
                    if (_e1150.member_1 < _e1157.member_1) {
                        phi_4838_ = SlimbvhTypeD(_e1150.member_1, _e1157.member_1);
                    } else {
                        phi_4838_ = SlimbvhTypeD(_e1157.member_1, _e1150.member_1);
                    }
                    let _e1171 = phi_4838_;
                    if (_e1171.member < _e1164.member_1) {
                        phi_4850_ = SlimbvhTypeD(_e1171.member, _e1164.member_1);
                    } else {
                        phi_4850_ = SlimbvhTypeD(_e1164.member_1, _e1171.member);
                    }
                    let _e1178 = phi_4850_;
                    let _e1193 = (((_e1164.member & 7u) | ((_e1178.member & 7u) << bitcast<u32>(3u))) | (((_e1178.member_1 & 7u) | ((_e1171.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                    if (_e1193 == 0u) {
                        let _e1211 = (_e793 - 1u);
                        let _e1214 = local[(_e1211 % 128u)];
                        let _e1215 = (_e1214 & 511u);
                        let _e1217 = (_e1215 >> bitcast<u32>(3u));
                        let _e1220 = ((_e1217 == 0u) || (_e1211 == 4294967295u));
                        if _e1220 {
                        } else {
                            local[(_e1211 % 128u)] = (((_e1214 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1217);
                        }
                        phi_2684_ = select(_e793, _e1211, _e1220);
                        phi_2685_ = (((_e1214 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1215 & 3u) & 3u));
                    } else {
                        let _e1196 = (_e1193 >> bitcast<u32>(3u));
                        if (_e1196 == 0u) {
                            phi_2679_ = _e793;
                        } else {
                            local[(_e793 % 128u)] = ((_e795 << bitcast<u32>(9u)) | _e1196);
                            phi_2679_ = (_e793 + 1u);
                        }
                        let _e1205 = phi_2679_;
                        phi_2684_ = _e1205;
                        phi_2685_ = ((_e795 << bitcast<u32>(2i)) | ((_e1193 & 3u) & 3u));
                    }
                    let _e1235 = phi_2684_;
                    let _e1237 = phi_2685_;
                    let _e1239 = (_e1237 >> bitcast<u32>(2i));
                    if (_e1239 < _e114) {
                        let _e1244 = slimbvh_nodes.member[_e1239][1u][3u];
                        let _e1248 = slimbvh_nodes.member[_e1239][2u][3u];
                        let _e1253 = (_e1248 >> bitcast<u32>(20u));
                        let _e1254 = (_e1237 & 3u);
                        if (((_e1253 >> bitcast<u32>((((3u * _e1254) & 31u) & 31u))) & 7u) == 7u) {
                            let _e1266 = ((_e1253 | (_e1253 << bitcast<u32>(10i))) & 4128831u);
                            phi_2739_ = (((_e1244 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e1266 | (_e1266 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e1254) & 31u) & 31u))) & 255u));
                        } else {
                            phi_2739_ = (2147483648u | _e1237);
                        }
                        let _e1284 = phi_2739_;
                        phi_2740_ = _e1284;
                    } else {
                        phi_2740_ = 4294967295u;
                    }
                    let _e1286 = phi_2740_;
                    let _e1287 = (_e797 - 1u);
                    phi_1842_ = select(_e1235, 4294967295u, (_e1287 == 0u));
                    phi_1845_ = _e1286;
                    phi_1847_ = _e1287;
                } else {
                    phi_1842_ = u32();
                    phi_1845_ = u32();
                    phi_1847_ = u32();
                }
                let _e1291 = phi_1842_;
                let _e1293 = phi_1845_;
                let _e1295 = phi_1847_;
                continue;
                continuing {
                    phi_1841_ = _e1291;
                    phi_1844_ = _e1293;
                    phi_1846_ = _e1295;
                    break if !(_e801);
                }
            }
            let _e1298 = local_1;
            if _e1298 {
                let _e1300 = local_2;
                let _e1301 = (_e1300 & 2147483647u);
                let _e1303 = (_e1301 >> bitcast<u32>(2i));
                if (_e1303 >= _e114) {
                    phi_2973_ = SlimbvhTypeL(SlimbvhTypeK(vec4<f32>(0f, 0f, 0f, 0f), 0u), 0u, 0u);
                } else {
                    let _e1309 = slimbvh_nodes.member[_e1303][select(_e690, 2u, (2u < _e690))];
                    let _e1318 = slimbvh_nodes.member[_e1303][select(_e691, 2u, (2u < _e691))];
                    let _e1327 = slimbvh_nodes.member[_e1303][select(_e692, 2u, (2u < _e692))];
                    let _e1335 = slimbvh_nodes.member[_e1303][0u][3u];
                    let _e1339 = slimbvh_nodes.member[_e1303][1u][3u];
                    let _e1343 = slimbvh_nodes.member[_e1303][2u][3u];
                    let _e1356 = (_e1343 >> bitcast<u32>(20u));
                    let _e1364 = (((_e1343 >> bitcast<u32>(7u)) & 8191u) | ((_e1339 >> bitcast<u32>(29u)) << bitcast<u32>(13u)));
                    let _e1367 = ((_e1343 >> bitcast<u32>(5u)) & 3u);
                    let _e1368 = (_e1301 & 3u);
                    let _e1374 = ((_e1356 >> bitcast<u32>((((3u * _e1368) & 31u) & 31u))) & 7u);
                    if (_e1374 == 7u) {
                        let _e1427 = ((_e1356 | (_e1356 << bitcast<u32>(10i))) & 4128831u);
                        phi_2925_ = (((_e1339 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e1427 | (_e1427 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e1368) & 31u) & 31u))) & 255u));
                    } else {
                        let _e1379 = ((_e1356 | (_e1356 << bitcast<u32>(10i))) & 4128831u);
                        let _e1383 = ((_e1379 | (_e1379 << bitcast<u32>(5i))) & 117901063u);
                        let _e1389 = (_e1383 - (7u * (((_e1383 + 16843009u) >> bitcast<u32>(3i)) & 16843009u)));
                        let _e1397 = ((_e1364 | (_e1364 << bitcast<u32>(8i))) & 16711935u);
                        phi_2925_ = ((2147483648u | (_e1374 << bitcast<u32>(28u))) | ((((_e1335 >> bitcast<u32>(5u)) | (((_e1339 >> bitcast<u32>(28u)) & 1u) << bitcast<u32>(27u))) + (((((((((_e1397 | (_e1397 << bitcast<u32>(4i))) & 252645135u) + (3u * (((_e1389 + 117901063u) >> bitcast<u32>(3i)) & 16843009u))) * (_e1367 + 1u)) + _e1389) + ((_e1389 >> bitcast<u32>(1i)) & 50529027u)) * 16843008u) >> bitcast<u32>((((8u * _e1368) & 31u) & 31u))) & 255u)) & 268435455u));
                    }
                    let _e1445 = phi_2925_;
                    switch bitcast<i32>(_e1367) {
                        case 0: {
                            phi_2930_ = 0u;
                            break;
                        }
                        case 1: {
                            phi_2930_ = 1u;
                            break;
                        }
                        default: {
                            phi_2930_ = 2u;
                            break;
                        }
                    }
                    let _e1448 = phi_2930_;
                    let _e1451 = (((8u * _e1368) & 31u) & 31u);
                    phi_2973_ = SlimbvhTypeL(SlimbvhTypeK(vec4<f32>((bitcast<f32>(_e1309.x) + (f32((((_e1309.y >> bitcast<u32>(_e1451)) & 255u) << bitcast<u32>(((_e1309.w & 31u) & 31u)))) * _e161)), (bitcast<f32>(_e1318.x) + (f32((((_e1318.y >> bitcast<u32>(_e1451)) & 255u) << bitcast<u32>(((_e1318.w & 31u) & 31u)))) * _e161)), (bitcast<f32>(_e1327.x) + (f32((((_e1327.y >> bitcast<u32>(_e1451)) & 255u) << bitcast<u32>(((_e1327.w & 31u) & 31u)))) * _e161)), 0f), _e1448), (_e1445 & 268435455u), ((_e1445 >> bitcast<u32>(28u)) & 7u));
                }
                let _e1490 = phi_2973_;
                phi_2977_ = _e784;
                phi_2980_ = SlimbvhTypeD(0u, _e1490.member_2);
                loop {
                    let _e1494 = phi_2977_;
                    let _e1496 = phi_2980_;
                    local_5 = _e1494;
                    local_7 = _e1494;
                    if (_e1496.member < _e1496.member_1) {
                        phi_2981_ = SlimbvhTypeD((_e1496.member + 1u), _e1496.member_1);
                        phi_3003_ = SlimbvhTypeD(1u, _e1496.member);
                    } else {
                        phi_2981_ = _e1496;
                        phi_3003_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                    }
                    let _e1509 = phi_2981_;
                    let _e1511 = phi_3003_;
                    let _e1515 = (bitcast<i32>(_e1511.member) != 0i);
                    if _e1515 {
                        let _e1519 = (_e1490.member_1 + (_e1490.member_2 / 2u));
                        let _e1520 = (_e1519 + _e1511.member_1);
                        if (_e1520 < _e117) {
                            let _e1523 = slimbvh_triangles.member[_e1520];
                            phi_3031_ = _e1523;
                        } else {
                            phi_3031_ = 4294967295u;
                        }
                        let _e1525 = phi_3031_;
                        let _e1526 = (_e1511.member_1 - 1u);
                        let _e1529 = (_e1490.member_1 + (_e1526 >> bitcast<u32>(1i)));
                        if (_e1529 < _e117) {
                            let _e1532 = slimbvh_triangles.member[_e1529];
                            phi_3054_ = _e1532;
                        } else {
                            phi_3054_ = 0u;
                        }
                        let _e1534 = phi_3054_;
                        if (_e1511.member_1 == 0u) {
                            phi_3063_ = 2080u;
                        } else {
                            phi_3063_ = (_e1534 >> bitcast<u32>(((16u * (_e1526 & 1u)) & 31u)));
                        }
                        let _e1542 = phi_3063_;
                        let _e1543 = (_e1519 + _e1490.member_2);
                        switch bitcast<i32>(_e1490.member.member_1) {
                            case 0: {
                                phi_3073_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_3073_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_3073_ = 3u;
                                break;
                            }
                            default: {
                                phi_3073_ = u32();
                                break;
                            }
                        }
                        let _e1547 = phi_3073_;
                        let _e1550 = (_e1543 + ((_e1542 & 31u) * _e1547));
                        let _e1555 = (_e1543 + (((_e1542 >> bitcast<u32>(5u)) & 31u) * _e1547));
                        let _e1560 = (_e1543 + (((_e1542 >> bitcast<u32>(10u)) & 31u) * _e1547));
                        switch bitcast<i32>(_e1490.member.member_1) {
                            case 0: {
                                if (_e1550 < _e117) {
                                    let _e1837 = slimbvh_triangles.member[_e1550];
                                    phi_3115_ = _e1837;
                                } else {
                                    phi_3115_ = 0u;
                                }
                                let _e1839 = phi_3115_;
                                let _e1842 = ((10u * _e221) & 31u);
                                let _e1853 = ((10u * _e225) & 31u);
                                let _e1864 = ((10u * _e217) & 31u);
                                if (_e1555 < _e117) {
                                    let _e1876 = slimbvh_triangles.member[_e1555];
                                    phi_3161_ = _e1876;
                                } else {
                                    phi_3161_ = 0u;
                                }
                                let _e1878 = phi_3161_;
                                if (_e1560 < _e117) {
                                    let _e1906 = slimbvh_triangles.member[_e1560];
                                    phi_3207_ = _e1906;
                                } else {
                                    phi_3207_ = 0u;
                                }
                                let _e1908 = phi_3207_;
                                phi_3674_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1490.member.member.x + ((bitcast<f32>((1258291200u | ((_e1839 >> bitcast<u32>(_e1842)) & 1023u))) - 8388608f) * _e161)), (_e1490.member.member.y + ((bitcast<f32>((1258291200u | ((_e1839 >> bitcast<u32>(_e1853)) & 1023u))) - 8388608f) * _e161)), (_e1490.member.member.z + ((bitcast<f32>((1258291200u | ((_e1839 >> bitcast<u32>(_e1864)) & 1023u))) - 8388608f) * _e161))), array<f32, 3>((_e1490.member.member.x + ((bitcast<f32>((1258291200u | ((_e1878 >> bitcast<u32>(_e1842)) & 1023u))) - 8388608f) * _e161)), (_e1490.member.member.y + ((bitcast<f32>((1258291200u | ((_e1878 >> bitcast<u32>(_e1853)) & 1023u))) - 8388608f) * _e161)), (_e1490.member.member.z + ((bitcast<f32>((1258291200u | ((_e1878 >> bitcast<u32>(_e1864)) & 1023u))) - 8388608f) * _e161))), array<f32, 3>((_e1490.member.member.x + ((bitcast<f32>((1258291200u | ((_e1908 >> bitcast<u32>(_e1842)) & 1023u))) - 8388608f) * _e161)), (_e1490.member.member.y + ((bitcast<f32>((1258291200u | ((_e1908 >> bitcast<u32>(_e1853)) & 1023u))) - 8388608f) * _e161)), (_e1490.member.member.z + ((bitcast<f32>((1258291200u | ((_e1908 >> bitcast<u32>(_e1864)) & 1023u))) - 8388608f) * _e161))));
                                break;
                            }
                            case 1: {
                                if (_e1550 < _e117) {
                                    let _e1650 = slimbvh_triangles.member[_e1550];
                                    phi_3254_ = _e1650;
                                } else {
                                    phi_3254_ = 0u;
                                }
                                let _e1652 = phi_3254_;
                                let _e1653 = (_e1550 + 1u);
                                if (_e1653 < _e117) {
                                    let _e1656 = slimbvh_triangles.member[_e1653];
                                    phi_3267_ = _e1656;
                                } else {
                                    phi_3267_ = 0u;
                                }
                                let _e1658 = phi_3267_;
                                let _e1660 = (_e221 == 1u);
                                if _e1660 {
                                    phi_3277_ = ((_e1652 >> bitcast<u32>(21i)) | (_e1658 << bitcast<u32>(11i)));
                                } else {
                                    phi_3277_ = (_e1658 >> bitcast<u32>(10i));
                                }
                                let _e1669 = phi_3277_;
                                let _e1678 = (_e225 == 1u);
                                if _e1678 {
                                    phi_3298_ = ((_e1652 >> bitcast<u32>(21i)) | (_e1658 << bitcast<u32>(11i)));
                                } else {
                                    phi_3298_ = (_e1658 >> bitcast<u32>(10i));
                                }
                                let _e1687 = phi_3298_;
                                let _e1696 = (_e217 == 1u);
                                if _e1696 {
                                    phi_3319_ = ((_e1652 >> bitcast<u32>(21i)) | (_e1658 << bitcast<u32>(11i)));
                                } else {
                                    phi_3319_ = (_e1658 >> bitcast<u32>(10i));
                                }
                                let _e1705 = phi_3319_;
                                if (_e1555 < _e117) {
                                    let _e1716 = slimbvh_triangles.member[_e1555];
                                    phi_3346_ = _e1716;
                                } else {
                                    phi_3346_ = 0u;
                                }
                                let _e1718 = phi_3346_;
                                let _e1719 = (_e1555 + 1u);
                                if (_e1719 < _e117) {
                                    let _e1722 = slimbvh_triangles.member[_e1719];
                                    phi_3359_ = _e1722;
                                } else {
                                    phi_3359_ = 0u;
                                }
                                let _e1724 = phi_3359_;
                                if _e1660 {
                                    phi_3369_ = ((_e1718 >> bitcast<u32>(21i)) | (_e1724 << bitcast<u32>(11i)));
                                } else {
                                    phi_3369_ = (_e1724 >> bitcast<u32>(10i));
                                }
                                let _e1733 = phi_3369_;
                                if _e1678 {
                                    phi_3390_ = ((_e1718 >> bitcast<u32>(21i)) | (_e1724 << bitcast<u32>(11i)));
                                } else {
                                    phi_3390_ = (_e1724 >> bitcast<u32>(10i));
                                }
                                let _e1749 = phi_3390_;
                                if _e1696 {
                                    phi_3411_ = ((_e1718 >> bitcast<u32>(21i)) | (_e1724 << bitcast<u32>(11i)));
                                } else {
                                    phi_3411_ = (_e1724 >> bitcast<u32>(10i));
                                }
                                let _e1765 = phi_3411_;
                                if (_e1560 < _e117) {
                                    let _e1776 = slimbvh_triangles.member[_e1560];
                                    phi_3438_ = _e1776;
                                } else {
                                    phi_3438_ = 0u;
                                }
                                let _e1778 = phi_3438_;
                                let _e1779 = (_e1560 + 1u);
                                if (_e1779 < _e117) {
                                    let _e1782 = slimbvh_triangles.member[_e1779];
                                    phi_3451_ = _e1782;
                                } else {
                                    phi_3451_ = 0u;
                                }
                                let _e1784 = phi_3451_;
                                if _e1660 {
                                    phi_3461_ = ((_e1778 >> bitcast<u32>(21i)) | (_e1784 << bitcast<u32>(11i)));
                                } else {
                                    phi_3461_ = (_e1784 >> bitcast<u32>(10i));
                                }
                                let _e1793 = phi_3461_;
                                if _e1678 {
                                    phi_3482_ = ((_e1778 >> bitcast<u32>(21i)) | (_e1784 << bitcast<u32>(11i)));
                                } else {
                                    phi_3482_ = (_e1784 >> bitcast<u32>(10i));
                                }
                                let _e1809 = phi_3482_;
                                if _e1696 {
                                    phi_3503_ = ((_e1778 >> bitcast<u32>(21i)) | (_e1784 << bitcast<u32>(11i)));
                                } else {
                                    phi_3503_ = (_e1784 >> bitcast<u32>(10i));
                                }
                                let _e1825 = phi_3503_;
                                phi_3674_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1490.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1669, _e1652, _e226) & 2097151u))) - 8388608f) * _e161)), (_e1490.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1687, _e1652, _e229) & 2097151u))) - 8388608f) * _e161)), (_e1490.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1705, _e1652, _e233) & 2097151u))) - 8388608f) * _e161))), array<f32, 3>((_e1490.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1733, _e1718, _e226) & 2097151u))) - 8388608f) * _e161)), (_e1490.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1749, _e1718, _e229) & 2097151u))) - 8388608f) * _e161)), (_e1490.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1765, _e1718, _e233) & 2097151u))) - 8388608f) * _e161))), array<f32, 3>((_e1490.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1793, _e1778, _e226) & 2097151u))) - 8388608f) * _e161)), (_e1490.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1809, _e1778, _e229) & 2097151u))) - 8388608f) * _e161)), (_e1490.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1825, _e1778, _e233) & 2097151u))) - 8388608f) * _e161))));
                                break;
                            }
                            case 2: {
                                let _e1563 = (_e1550 + _e221);
                                if (_e1563 < _e117) {
                                    let _e1566 = slimbvh_triangles.member[_e1563];
                                    phi_3532_ = _e1566;
                                } else {
                                    phi_3532_ = 0u;
                                }
                                let _e1568 = phi_3532_;
                                let _e1569 = (_e1550 + _e225);
                                if (_e1569 < _e117) {
                                    let _e1572 = slimbvh_triangles.member[_e1569];
                                    phi_3545_ = _e1572;
                                } else {
                                    phi_3545_ = 0u;
                                }
                                let _e1574 = phi_3545_;
                                let _e1575 = (_e1550 + _e217);
                                if (_e1575 < _e117) {
                                    let _e1578 = slimbvh_triangles.member[_e1575];
                                    phi_3558_ = _e1578;
                                } else {
                                    phi_3558_ = 0u;
                                }
                                let _e1580 = phi_3558_;
                                let _e1591 = (_e1555 + _e221);
                                if (_e1591 < _e117) {
                                    let _e1594 = slimbvh_triangles.member[_e1591];
                                    phi_3584_ = _e1594;
                                } else {
                                    phi_3584_ = 0u;
                                }
                                let _e1596 = phi_3584_;
                                let _e1597 = (_e1555 + _e225);
                                if (_e1597 < _e117) {
                                    let _e1600 = slimbvh_triangles.member[_e1597];
                                    phi_3597_ = _e1600;
                                } else {
                                    phi_3597_ = 0u;
                                }
                                let _e1602 = phi_3597_;
                                let _e1603 = (_e1555 + _e217);
                                if (_e1603 < _e117) {
                                    let _e1606 = slimbvh_triangles.member[_e1603];
                                    phi_3610_ = _e1606;
                                } else {
                                    phi_3610_ = 0u;
                                }
                                let _e1608 = phi_3610_;
                                let _e1619 = (_e1560 + _e221);
                                if (_e1619 < _e117) {
                                    let _e1622 = slimbvh_triangles.member[_e1619];
                                    phi_3636_ = _e1622;
                                } else {
                                    phi_3636_ = 0u;
                                }
                                let _e1624 = phi_3636_;
                                let _e1625 = (_e1560 + _e225);
                                if (_e1625 < _e117) {
                                    let _e1628 = slimbvh_triangles.member[_e1625];
                                    phi_3649_ = _e1628;
                                } else {
                                    phi_3649_ = 0u;
                                }
                                let _e1630 = phi_3649_;
                                let _e1631 = (_e1560 + _e217);
                                if (_e1631 < _e117) {
                                    let _e1634 = slimbvh_triangles.member[_e1631];
                                    phi_3662_ = _e1634;
                                } else {
                                    phi_3662_ = 0u;
                                }
                                let _e1636 = phi_3662_;
                                phi_3674_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1568)) * _e161), (f32(bitcast<i32>(_e1574)) * _e161), (f32(bitcast<i32>(_e1580)) * _e161)), array<f32, 3>((f32(bitcast<i32>(_e1596)) * _e161), (f32(bitcast<i32>(_e1602)) * _e161), (f32(bitcast<i32>(_e1608)) * _e161)), array<f32, 3>((f32(bitcast<i32>(_e1624)) * _e161), (f32(bitcast<i32>(_e1630)) * _e161), (f32(bitcast<i32>(_e1636)) * _e161)));
                                break;
                            }
                            default: {
                                phi_3674_ = array<array<f32, 3>, 3>();
                                break;
                            }
                        }
                        let _e1936 = phi_3674_;
                        let _e1953 = (_e1936[0][2] - _e609.member[2]);
                        let _e1956 = (((_e1936[0][0] - _e609.member[0]) * _e664) - (_e1953 * _e632));
                        let _e1959 = (((_e1936[0][1] - _e609.member[1]) * _e664) - (_e1953 * _e648));
                        let _e1962 = (_e1936[1][2] - _e609.member[2]);
                        let _e1965 = (((_e1936[1][0] - _e609.member[0]) * _e664) - (_e1962 * _e632));
                        let _e1968 = (((_e1936[1][1] - _e609.member[1]) * _e664) - (_e1962 * _e648));
                        let _e1971 = (_e1936[2][2] - _e609.member[2]);
                        let _e1974 = (((_e1936[2][0] - _e609.member[0]) * _e664) - (_e1971 * _e632));
                        let _e1977 = (((_e1936[2][1] - _e609.member[1]) * _e664) - (_e1971 * _e648));
                        let _e1978 = (_e1974 * _e1968);
                        let _e1979 = (_e1977 * _e1965);
                        let _e1980 = (_e1956 * _e1977);
                        let _e1981 = (_e1959 * _e1974);
                        let _e1982 = (_e1965 * _e1959);
                        let _e1983 = (_e1968 * _e1956);
                        let _e1988 = (((_e1978 >= _e1979) && (_e1980 >= _e1981)) && (_e1982 >= _e1983));
                        let _e1994 = (_e1988 || (((_e1978 <= _e1979) && (_e1980 <= _e1981)) && (_e1982 <= _e1983)));
                        if _e1994 {
                            let _e1996 = select(-1f, 1f, _e1988);
                            let _e1998 = ((_e1978 - _e1979) * _e1996);
                            let _e2000 = select(0f, _e1998, (_e1998 > 0f));
                            let _e2002 = ((_e1980 - _e1981) * _e1996);
                            let _e2004 = select(0f, _e2002, (_e2002 > 0f));
                            let _e2006 = ((_e1982 - _e1983) * _e1996);
                            let _e2008 = select(0f, _e2006, (_e2006 > 0f));
                            let _e2010 = ((_e2000 + _e2004) + _e2008);
                            let _e2025 = ((min(min(_e1936[0][0], _e1936[1][0]), _e1936[2][0]) - _e633) * _e636);
                            let _e2026 = ((max(max(_e1936[0][0], _e1936[1][0]), _e1936[2][0]) - _e634) * _e636);
                            let _e2027 = vec4<f32>(_e2025, f32(), _e2026, f32());
                            let _e2030 = ((min(min(_e1936[0][1], _e1936[1][1]), _e1936[2][1]) - _e649) * _e652);
                            let _e2031 = ((max(max(_e1936[0][1], _e1936[1][1]), _e1936[2][1]) - _e650) * _e652);
                            let _e2032 = vec4<f32>(_e2030, f32(), _e2031, f32());
                            let _e2035 = ((min(min(_e1936[0][2], _e1936[1][2]), _e1936[2][2]) - _e665) * _e668);
                            let _e2036 = ((max(max(_e1936[0][2], _e1936[1][2]), _e1936[2][2]) - _e666) * _e668);
                            let _e2037 = vec4<f32>(_e2035, f32(), _e2036, f32());
                            let _e2038 = vec4<f32>(_e2026, f32(), _e2025, f32());
                            let _e2040 = vec4<f32>(_e2031, f32(), _e2030, f32());
                            let _e2042 = vec4<f32>(_e2036, f32(), _e2035, f32());
                            let _e2051 = max(max(min(_e2027, _e2038).x, min(_e2032, _e2040).x), min(_e2037, _e2042).x);
                            let _e2056 = min(min(max(_e2027, _e2038).x, max(_e2032, _e2040).x), max(_e2037, _e2042).x);
                            let _e2061 = max(_e2051, _e676);
                            let _e2083 = (((((_e1994 && (_e2010 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1956, _e1965), _e1974) <= 0f) && (max(max(_e1956, _e1965), _e1974) >= 0f))) && ((min(min(_e1959, _e1968), _e1977) <= 0f) && (max(max(_e1959, _e1968), _e1977) >= 0f))) && (_e2061 <= (_e2056 + (max(max(_e2037, _e2042).x, -(min(_e2037, _e2042).x)) * 0.0000019073523f)))) && (_e2061 <= _e1494.member.member_1));
                            if _e2083 {
                                let _e2088 = (_e1936[1][0] - _e1936[0][0]);
                                let _e2089 = (_e1936[1][1] - _e1936[0][1]);
                                let _e2090 = (_e1936[1][2] - _e1936[0][2]);
                                let _e2091 = vec3<f32>(_e2088, _e2089, _e2090);
                                let _e2092 = (_e1936[2][0] - _e1936[1][0]);
                                let _e2093 = (_e1936[2][1] - _e1936[1][1]);
                                let _e2094 = (_e1936[2][2] - _e1936[1][2]);
                                let _e2095 = vec3<f32>(_e2092, _e2093, _e2094);
                                let _e2096 = (_e1936[0][0] - _e1936[2][0]);
                                let _e2097 = (_e1936[0][1] - _e1936[2][1]);
                                let _e2098 = (_e1936[0][2] - _e1936[2][2]);
                                let _e2099 = vec3<f32>(_e2096, _e2097, _e2098);
                                let _e2110 = max(max(bitcast<f32>((bitcast<u32>(_e2088) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2089) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2090) & 2147483647u)));
                                let _e2121 = max(max(bitcast<f32>((bitcast<u32>(_e2092) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2093) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2094) & 2147483647u)));
                                let _e2134 = max(max(_e2110, _e2121), max(max(bitcast<f32>((bitcast<u32>(_e2096) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2097) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2098) & 2147483647u))));
                                if (_e2110 == _e2134) {
                                    phi_4039_ = _e1968;
                                    phi_4040_ = _e1965;
                                    phi_4041_ = _e1959;
                                    phi_4042_ = _e1956;
                                    phi_4043_ = vec3<f32>(_e1936[0][0], _e1936[0][1], _e1936[0][2]);
                                    phi_4044_ = _e2099;
                                    phi_4045_ = _e2095;
                                    phi_4046_ = _e2091;
                                } else {
                                    let _e2136 = (_e2121 == _e2134);
                                    let _e2141 = vec3(_e2136);
                                    phi_4039_ = select(_e1959, _e1977, _e2136);
                                    phi_4040_ = select(_e1956, _e1974, _e2136);
                                    phi_4041_ = select(_e1977, _e1968, _e2136);
                                    phi_4042_ = select(_e1974, _e1965, _e2136);
                                    phi_4043_ = select(vec3<f32>(_e1936[2][0], _e1936[2][1], _e1936[2][2]), vec3<f32>(_e1936[1][0], _e1936[1][1], _e1936[1][2]), _e2141);
                                    phi_4044_ = select(_e2095, _e2091, _e2141);
                                    phi_4045_ = select(_e2091, _e2099, _e2141);
                                    phi_4046_ = select(_e2099, _e2095, _e2141);
                                }
                                let _e2147 = phi_4039_;
                                let _e2149 = phi_4040_;
                                let _e2151 = phi_4041_;
                                let _e2153 = phi_4042_;
                                let _e2155 = phi_4043_;
                                let _e2157 = phi_4044_;
                                let _e2159 = phi_4045_;
                                let _e2161 = phi_4046_;
                                let _e2168 = ((_e2159.y * _e2157.z) - (_e2157.y * _e2159.z));
                                let _e2173 = ((_e2159.z * _e2157.x) - (_e2157.z * _e2159.x));
                                let _e2176 = ((_e2159.x * _e2157.y) - (_e2157.x * _e2159.y));
                                let _e2179 = ((_e2000 >= _e2004) && (_e2000 >= _e2008));
                                let _e2180 = (_e2004 >= _e2008);
                                let _e2194 = (((_e2168 * (select(select(_e1936[2][0], _e1936[1][0], _e2180), _e1936[0][0], _e2179) - _e609.member[0])) + (_e2173 * (select(select(_e1936[2][1], _e1936[1][1], _e2180), _e1936[0][1], _e2179) - _e609.member[1]))) + (_e2176 * (select(select(_e1936[2][2], _e1936[1][2], _e2180), _e1936[0][2], _e2179) - _e609.member[2])));
                                let _e2199 = (((_e2168 * _e632) + (_e2173 * _e648)) + (_e2176 * _e664));
                                let _e2200 = (_e2149 - _e2153);
                                let _e2201 = (_e2147 - _e2151);
                                let _e2204 = ((_e2200 * _e2200) + (_e2201 * _e2201));
                                let _e2211 = (-(((_e2153 * _e2200) + (_e2151 * _e2201))) / select(0.000000000000000000000000000000000000011754944f, _e2204, (_e2204 > 0.000000000000000000000000000000000000011754944f)));
                                let _e2213 = select(1f, _e2211, (_e2211 < 1f));
                                let _e2215 = select(0f, _e2213, (_e2213 > 0f));
                                let _e2224 = ((_e2155.x + (_e2161.x * _e2215)) - _e609.member[0]);
                                let _e2227 = ((_e2155.y + (_e2161.y * _e2215)) - _e609.member[1]);
                                let _e2230 = ((_e2155.z + (_e2161.z * _e2215)) - _e609.member[2]);
                                let _e2295 = ((bitcast<f32>((bitcast<u32>(((((_e2168 * _e2224) + (_e2173 * _e2227)) + (_e2176 * _e2230)) - _e2194)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e2224) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2227) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2230) & 2147483647u))), _e2134)) * max(max(bitcast<f32>((bitcast<u32>(_e2168) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2173) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2176) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e2199) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e2159.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2159.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2159.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e2157.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2157.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2157.z) & 2147483647u)))))));
                                let _e2296 = (_e2194 / _e2199);
                                if (_e2083 && !(_e2295)) {
                                    let _e2299 = (_e2230 / _e664);
                                    let _e2307 = (((_e2168 * (_e2224 - (_e632 * _e2299))) + (_e2173 * (_e2227 - (_e648 * _e2299)))) / _e2199);
                                    phi_4225_ = select(select(_e2299, (_e2299 + _e2307), (bitcast<f32>((bitcast<u32>(_e2307) & 2147483647u)) <= _e2134)), _e2296, _e2295);
                                } else {
                                    phi_4225_ = _e2296;
                                }
                                let _e2316 = phi_4225_;
                                let _e2318 = select(_e2056, _e2316, (_e2316 < _e2056));
                                let _e2320 = select(_e2051, _e2318, (_e2318 > _e2051));
                                let _e2323 = select(_e2320, 0f, (bitcast<u32>(_e2320) == 2147483648u));
                                let _e2324 = (1f / _e2010);
                                phi_4251_ = SlimbvhTypeE(_e2323, (_e2004 * _e2324), (_e2008 * _e2324), ((_e2083 && (_e2323 >= _e676)) && (_e2323 <= _e1494.member.member_1)));
                                phi_4252_ = SlimbvhTypeE();
                            } else {
                                phi_4251_ = SlimbvhTypeE();
                                phi_4252_ = SlimbvhTypeE(0f, 0f, 0f, _e2083);
                            }
                            let _e2333 = phi_4251_;
                            let _e2335 = phi_4252_;
                            phi_4255_ = _e2333;
                            phi_4256_ = _e2335;
                            phi_4257_ = select(true, false, _e2083);
                        } else {
                            phi_4255_ = SlimbvhTypeE();
                            phi_4256_ = SlimbvhTypeE(0f, 0f, 0f, _e1994);
                            phi_4257_ = true;
                        }
                        let _e2338 = phi_4255_;
                        let _e2340 = phi_4256_;
                        let _e2342 = phi_4257_;
                        if _e2342 {
                            phi_4261_ = _e2340;
                        } else {
                            phi_4261_ = _e2338;
                        }
                        let _e2344 = phi_4261_;
                        if _e2344.member_3 {
                            phi_4270_ = SlimbvhTypeF(_e2344.member, _e2344.member_1, _e2344.member_2, _e1525);
                        } else {
                            phi_4270_ = _e110;
                        }
                        let _e2351 = phi_4270_;
                        if (_e2351.member_3 != 4294967295u) {
                            if (_e1525 != 4294967295u) {
                                if (_e2351.member < _e1494.member.member.member) {
                                    phi_4298_ = true;
                                } else {
                                    if (_e2351.member == _e1494.member.member.member) {
                                        phi_4297_ = (_e2351.member_3 < _e1494.member.member.member_3);
                                    } else {
                                        phi_4297_ = false;
                                    }
                                    let _e2366 = phi_4297_;
                                    phi_4298_ = _e2366;
                                }
                                let _e2368 = phi_4298_;
                                if _e2368 {
                                    phi_4305_ = SlimbvhTypeO(SlimbvhTypeH(_e2351, _e2351.member), _e1494.member_1);
                                } else {
                                    phi_4305_ = _e1494;
                                }
                                let _e2374 = phi_4305_;
                                if _e2374.member_1 {
                                    phi_4311_ = SlimbvhTypeO(SlimbvhTypeH(_e2374.member.member, bitcast<f32>(4286578687u)), _e2374.member_1);
                                } else {
                                    phi_4311_ = _e2374;
                                }
                                let _e2383 = phi_4311_;
                                phi_4312_ = _e2383;
                            } else {
                                phi_4312_ = _e1494;
                            }
                            let _e2385 = phi_4312_;
                            phi_4313_ = _e2385;
                        } else {
                            phi_4313_ = _e1494;
                        }
                        let _e2387 = phi_4313_;
                        phi_2978_ = _e2387;
                    } else {
                        phi_2978_ = SlimbvhTypeO();
                    }
                    let _e2389 = phi_2978_;
                    continue;
                    continuing {
                        phi_2977_ = _e2389;
                        phi_2980_ = _e1509;
                        break if !(_e1515);
                    }
                }
                let _e2392 = local_3;
                let _e2393 = (_e2392 - 1u);
                let _e2396 = local[(_e2393 % 128u)];
                let _e2397 = (_e2396 & 511u);
                let _e2399 = (_e2397 >> bitcast<u32>(3u));
                let _e2402 = ((_e2399 == 0u) || (_e2393 == 4294967295u));
                if _e2402 {
                } else {
                    local[(_e2393 % 128u)] = (((_e2396 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2399);
                }
                let _e2409 = local_4;
                let _e2417 = (((_e2396 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2397 & 3u) & 3u));
                let _e2419 = (_e2417 >> bitcast<u32>(2i));
                if (_e2419 < _e114) {
                    let _e2424 = slimbvh_nodes.member[_e2419][1u][3u];
                    let _e2428 = slimbvh_nodes.member[_e2419][2u][3u];
                    let _e2433 = (_e2428 >> bitcast<u32>(20u));
                    let _e2434 = (_e2417 & 3u);
                    if (((_e2433 >> bitcast<u32>((((3u * _e2434) & 31u) & 31u))) & 7u) == 7u) {
                        let _e2446 = ((_e2433 | (_e2433 << bitcast<u32>(10i))) & 4128831u);
                        phi_4402_ = (((_e2424 >> bitcast<u32>(5u)) & 8388607u) + ((((((((_e2446 | (_e2446 << bitcast<u32>(5i))) & 117901063u) + 16843009u) >> bitcast<u32>(3i)) & 16843009u) * 16843008u) >> bitcast<u32>((((8u * _e2434) & 31u) & 31u))) & 255u));
                    } else {
                        phi_4402_ = (2147483648u | _e2417);
                    }
                    let _e2464 = phi_4402_;
                    phi_4403_ = _e2464;
                } else {
                    phi_4403_ = 4294967295u;
                }
                let _e2466 = phi_4403_;
                let _e2468 = local_5;
                let _e2753 = local_7;
                phi_4412_ = _e2753;
                phi_4413_ = select(select(_e2409, _e2393, _e2402), 4294967295u, (_e676 > _e2468.member.member_1));
                phi_4414_ = _e2466;
            } else {
                phi_4412_ = _e784;
                let _e2756 = local_8;
                phi_4413_ = _e2756;
                let _e2759 = local_9;
                phi_4414_ = _e2759;
            }
            let _e2474 = phi_4412_;
            let _e2476 = phi_4413_;
            let _e2478 = phi_4414_;
            phi_1826_ = _e2474;
            phi_1829_ = _e2476;
            phi_1831_ = _e2478;
            let _e2765 = local_10;
            phi_1833_ = _e2765;
        } else {
            phi_1826_ = SlimbvhTypeO();
            phi_1829_ = u32();
            phi_1831_ = u32();
            phi_1833_ = u32();
        }
        let _e2480 = phi_1826_;
        let _e2482 = phi_1829_;
        let _e2484 = phi_1831_;
        let _e2486 = phi_1833_;
        continue;
        continuing {
            phi_1825_ = _e2480;
            phi_1828_ = _e2482;
            phi_1830_ = _e2484;
            phi_1832_ = _e2486;
            break if !(_e791);
        }
    }
    let _e2489 = local_6;
    if (_e2489.member.member.member_3 != 4294967295u) {
        let _e2495 = -((_e179 + _e609.member_4));
        let _e2496 = bitcast<u32>(_e2489.member.member.member);
        let _e2500 = (bitcast<i32>((_e2496 >> bitcast<u32>(23i))) & 255i);
        let _e2501 = (_e2500 + _e2495);
        if (_e2500 == 255i) {
            phi_4471_ = _e2489.member.member.member;
        } else {
            if (_e2500 > 0i) {
                if (_e2501 > 0i) {
                    let _e2505 = (_e2501 < 255i);
                    if _e2505 {
                        phi_4450_ = bitcast<f32>((_e2496 + bitcast<u32>((_e2495 << bitcast<u32>(23i)))));
                    } else {
                        phi_4450_ = f32();
                    }
                    let _e2512 = phi_4450_;
                    phi_4452_ = _e2512;
                    phi_4453_ = select(true, false, _e2505);
                } else {
                    phi_4452_ = f32();
                    phi_4453_ = true;
                }
                let _e2515 = phi_4452_;
                let _e2517 = phi_4453_;
                phi_4454_ = _e2515;
                phi_4455_ = _e2517;
            } else {
                phi_4454_ = f32();
                phi_4455_ = true;
            }
            let _e2519 = phi_4454_;
            let _e2521 = phi_4455_;
            if _e2521 {
                let _e2522 = (_e2496 & 2147483648u);
                let _e2529 = ((_e2496 & 8388607u) | (select(0u, 1u, ((_e2496 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e2533 = (_e2529 == 0u);
                if _e2533 {
                    phi_5131_ = bitcast<f32>(_e2522);
                } else {
                    let _e2538 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2529)), 32u, _e2533) - 8u);
                    let _e2541 = (_e2529 << bitcast<u32>((_e2538 & 31u)));
                    let _e2543 = ((_e2501 + select(0i, 1i, (_e2500 == 0i))) - bitcast<i32>(_e2538));
                    if (_e2543 >= 255i) {
                        phi_5121_ = bitcast<f32>((_e2522 | 2139095040u));
                        phi_5122_ = f32();
                        phi_5123_ = true;
                    } else {
                        let _e2545 = (_e2543 > 0i);
                        if _e2545 {
                            phi_5115_ = bitcast<f32>(((_e2522 | (bitcast<u32>(_e2543) << bitcast<u32>(23i))) | (_e2541 & 8388607u)));
                            phi_5116_ = f32();
                        } else {
                            if (_e2543 < -24i) {
                                phi_5081_ = 26u;
                            } else {
                                phi_5081_ = bitcast<u32>((1i - _e2543));
                            }
                            let _e2550 = phi_5081_;
                            let _e2551 = (_e2550 & 31u);
                            let _e2553 = (_e2541 >> bitcast<u32>(_e2551));
                            let _e2557 = (_e2541 & ((1u << bitcast<u32>(_e2551)) - 1u));
                            let _e2561 = (1u << bitcast<u32>(((_e2550 - 1u) & 31u)));
                            if (_e2557 > _e2561) {
                                phi_5102_ = true;
                            } else {
                                if (_e2557 == _e2561) {
                                    phi_5099_ = ((_e2553 & 1u) == 1u);
                                } else {
                                    phi_5099_ = false;
                                }
                                let _e2567 = phi_5099_;
                                phi_5102_ = _e2567;
                            }
                            let _e2569 = phi_5102_;
                            phi_5115_ = f32();
                            phi_5116_ = bitcast<f32>((_e2522 | (_e2553 + select(0u, 1u, _e2569))));
                        }
                        let _e2582 = phi_5115_;
                        let _e2584 = phi_5116_;
                        phi_5121_ = _e2582;
                        phi_5122_ = _e2584;
                        phi_5123_ = _e2545;
                    }
                    let _e2588 = phi_5121_;
                    let _e2590 = phi_5122_;
                    let _e2592 = phi_5123_;
                    phi_5131_ = select(_e2590, _e2588, _e2592);
                }
                let _e2596 = phi_5131_;
                phi_4470_ = _e2596;
            } else {
                phi_4470_ = _e2519;
            }
            let _e2598 = phi_4470_;
            phi_4471_ = _e2598;
        }
        let _e2600 = phi_4471_;
        let _e2601 = bitcast<u32>(_e2600);
        if ((_e2601 & 2147483647u) >= 2139095040u) {
            phi_4483_ = bitcast<f32>(((_e2601 & 2147483648u) | 2139095039u));
        } else {
            phi_4483_ = _e2600;
        }
        let _e2608 = phi_4483_;
        phi_4488_ = SlimbvhTypeF(_e2608, _e2489.member.member.member_1, _e2489.member.member.member_2, _e2489.member.member.member_3);
    } else {
        phi_4488_ = _e110;
    }
    let _e2613 = phi_4488_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2613.member), bitcast<u32>(_e2613.member_1), bitcast<u32>(_e2613.member_2), _e2613.member_3);
    return;
}

struct SlimbvhHit {
    t: f32,
    u: f32,
    v: f32,
    primitive: u32,
}

fn slimbvh_closest_hit(origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> SlimbvhHit {
    slimbvh_origin.member = vec4<f32>(origin, t_min);
    slimbvh_direction.member = vec4<f32>(direction, t_max);
    slimbvh_any_will_do.member = 0u;
    slimbvh_trace();
    let hit = slimbvh_hit.member;
    return SlimbvhHit(bitcast<f32>(hit.x), bitcast<f32>(hit.y), bitcast<f32>(hit.z), hit.w);
}

fn slimbvh_any_hit(origin: vec3<f32>, t_min: f32, direction: vec3<f32>, t_max: f32) -> bool {
    slimbvh_origin.member = vec4<f32>(origin, t_min);
    slimbvh_direction.member = vec4<f32>(direction, t_max);
    slimbvh_any_will_do.member = 1u;
    slimbvh_trace();
    return slimbvh_hit.member.w != 0xffffffffu;
}
