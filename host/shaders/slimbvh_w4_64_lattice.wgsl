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
    member: array<vec4<u32>, 3>,
    member_1: array<u32, 4>,
}

struct SlimbvhTypeJ {
    member: array<SlimbvhTypeI>,
}

struct SlimbvhTypeK {
    member: u32,
    member_1: f32,
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
    member: u32,
}

struct SlimbvhTypeP {
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

var<private> slimbvh_origin: SlimbvhTypeN;

var<private> slimbvh_direction: SlimbvhTypeN;

var<private> slimbvh_any_will_do: SlimbvhTypeO;

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
    var phi_1327_: SlimbvhTypeC;
    var phi_1556_: SlimbvhTypeP;
    var phi_1619_: array<f32, 3>;
    var phi_1620_: array<f32, 3>;
    var phi_1638_: array<f32, 3>;
    var phi_1639_: array<f32, 3>;
    var phi_1812_: SlimbvhTypeP;
    var phi_1815_: u32;
    var phi_1817_: u32;
    var phi_1819_: u32;
    var phi_1828_: u32;
    var phi_1831_: u32;
    var phi_1833_: u32;
    var phi_1929_: SlimbvhTypeK;
    var phi_1930_: SlimbvhTypeK;
    var phi_1975_: SlimbvhTypeK;
    var phi_1976_: SlimbvhTypeK;
    var phi_2021_: SlimbvhTypeK;
    var phi_2022_: SlimbvhTypeK;
    var phi_2498_: u32;
    var phi_2511_: u32;
    var phi_2524_: u32;
    var phi_2537_: u32;
    var phi_4712_: SlimbvhTypeD;
    var phi_4724_: SlimbvhTypeD;
    var phi_4736_: SlimbvhTypeD;
    var phi_4748_: SlimbvhTypeD;
    var phi_4760_: SlimbvhTypeD;
    var phi_2618_: u32;
    var phi_2623_: u32;
    var phi_2624_: u32;
    var phi_2653_: u32;
    var phi_2660_: u32;
    var phi_2661_: u32;
    var phi_1829_: u32;
    var phi_1832_: u32;
    var phi_1834_: u32;
    var local_1: bool;
    var local_2: u32;
    var phi_2816_: u32;
    var phi_2877_: u32;
    var phi_2885_: u32;
    var phi_2888_: SlimbvhTypeM;
    var phi_2892_: SlimbvhTypeP;
    var phi_2895_: SlimbvhTypeD;
    var phi_2896_: SlimbvhTypeD;
    var phi_2918_: SlimbvhTypeD;
    var phi_2935_: u32;
    var phi_2946_: u32;
    var phi_2962_: u32;
    var phi_2977_: u32;
    var phi_3442_: u32;
    var phi_3460_: u32;
    var phi_3478_: u32;
    var phi_3501_: u32;
    var phi_3519_: u32;
    var phi_3537_: u32;
    var phi_3560_: u32;
    var phi_3578_: u32;
    var phi_3596_: u32;
    var phi_3150_: u32;
    var phi_3165_: u32;
    var phi_3175_: u32;
    var phi_3196_: u32;
    var phi_3217_: u32;
    var phi_3247_: u32;
    var phi_3262_: u32;
    var phi_3272_: u32;
    var phi_3293_: u32;
    var phi_3314_: u32;
    var phi_3344_: u32;
    var phi_3359_: u32;
    var phi_3369_: u32;
    var phi_3390_: u32;
    var phi_3411_: u32;
    var phi_3003_: u32;
    var phi_3052_: u32;
    var phi_3101_: u32;
    var phi_3602_: array<array<f32, 3>, 3>;
    var phi_3967_: f32;
    var phi_3968_: f32;
    var phi_3969_: f32;
    var phi_3970_: f32;
    var phi_3971_: vec3<f32>;
    var phi_3972_: vec3<f32>;
    var phi_3973_: vec3<f32>;
    var phi_3974_: vec3<f32>;
    var phi_4153_: f32;
    var phi_4179_: SlimbvhTypeE;
    var phi_4180_: SlimbvhTypeE;
    var phi_4183_: SlimbvhTypeE;
    var phi_4184_: SlimbvhTypeE;
    var phi_4185_: bool;
    var phi_4189_: SlimbvhTypeE;
    var phi_4198_: SlimbvhTypeF;
    var phi_4225_: bool;
    var phi_4226_: bool;
    var phi_4233_: SlimbvhTypeP;
    var phi_4239_: SlimbvhTypeP;
    var phi_4240_: SlimbvhTypeP;
    var phi_4241_: SlimbvhTypeP;
    var phi_2893_: SlimbvhTypeP;
    var local_3: u32;
    var local_4: u32;
    var phi_4305_: u32;
    var phi_4312_: u32;
    var phi_4313_: u32;
    var local_5: SlimbvhTypeP;
    var phi_4322_: SlimbvhTypeP;
    var phi_4323_: u32;
    var phi_4324_: u32;
    var phi_1813_: SlimbvhTypeP;
    var phi_1816_: u32;
    var phi_1818_: u32;
    var phi_1820_: u32;
    var local_6: SlimbvhTypeP;
    var phi_4360_: f32;
    var phi_4362_: f32;
    var phi_4363_: bool;
    var phi_4364_: f32;
    var phi_4365_: bool;
    var phi_4991_: u32;
    var phi_5009_: bool;
    var phi_5012_: bool;
    var phi_5025_: f32;
    var phi_5026_: f32;
    var phi_5031_: f32;
    var phi_5032_: f32;
    var phi_5033_: bool;
    var phi_5041_: f32;
    var phi_4380_: f32;
    var phi_4381_: f32;
    var phi_4393_: f32;
    var phi_4398_: SlimbvhTypeF;
    var local_7: SlimbvhTypeP;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    let _e96 = SlimbvhTypeF(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e100 = arrayLength((&slimbvh_nodes.member));
    let _e103 = arrayLength((&slimbvh_triangles.member));
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
        phi_1327_ = SlimbvhTypeC(array<f32, 3>((_e214 * _e519), (_e218 * _e519), (_e221 * _e519)), array<f32, 3>((_e223 * _e524), (_e225 * _e524), (_e227 * _e524)), bitcast<f32>(((_e172 & 2147483648u) | select(_e556, 0u, _e558))), bitcast<f32>(((_e180 & 2147483648u) | select(_e586, 0u, _e588))), _e513);
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
        phi_1327_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e292 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e292 & 2147483648u))), _e214, _e294) * _e285) * select(0.00000011920929f, 1f, _e294)) * _e291), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e309 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e309 & 2147483648u))), _e218, _e311) * _e285) * select(0.00000011920929f, 1f, _e311)) * _e291), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e326 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e326 & 2147483648u))), _e221, _e328) * _e285) * select(0.00000011920929f, 1f, _e328)) * _e291)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e361 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e361 & 2147483648u))), _e223, _e363) * _e354) * select(0.00000011920929f, 1f, _e363)) * _e360), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e378 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e378 & 2147483648u))), _e225, _e380) * _e354) * select(0.00000011920929f, 1f, _e380)) * _e360), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e395 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e395 & 2147483648u))), _e227, _e397) * _e354) * select(0.00000011920929f, 1f, _e397)) * _e360)), bitcast<f32>(((_e172 & 2147483648u) | select(_e454, 0u, _e456))), bitcast<f32>(((_e180 & 2147483648u) | select(_e502, 0u, _e504))), _e274);
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
    let _e664 = slimbvh_any_will_do.member;
    if (_e664 == 1u) {
        phi_1556_ = SlimbvhTypeP(SlimbvhTypeH(_e96, _e661), true);
    } else {
        phi_1556_ = SlimbvhTypeP(SlimbvhTypeH(_e96, _e661), false);
    }
    let _e671 = phi_1556_;
    let _e676 = (_e207 & 3u);
    let _e677 = (_e211 & 3u);
    let _e678 = (_e203 & 3u);
    let _e681 = (bitcast<u32>(_e622) >> bitcast<u32>(31i));
    let _e684 = (bitcast<u32>(_e638) >> bitcast<u32>(31i));
    let _e687 = (bitcast<u32>(_e654) >> bitcast<u32>(31i));
    let _e691 = (f32(bitcast<i32>(_e111)) * _e147);
    let _e693 = (f32(bitcast<i32>(_e115)) * _e147);
    let _e695 = (f32(bitcast<i32>(_e119)) * _e147);
    let _e696 = (_e676 == 0u);
    if _e696 {
        phi_1620_ = array<f32, 3>(_e691, _e693, _e695);
    } else {
        if (_e676 == 1u) {
            phi_1619_ = array<f32, 3>(_e693, _e695, _e691);
        } else {
            phi_1619_ = array<f32, 3>(_e695, _e691, _e693);
        }
        let _e701 = phi_1619_;
        phi_1620_ = _e701;
    }
    let _e704 = phi_1620_;
    let _e706 = (f32(bitcast<i32>(_e127)) * _e147);
    let _e708 = (f32(bitcast<i32>(_e131)) * _e147);
    let _e710 = (f32(bitcast<i32>(_e135)) * _e147);
    if _e696 {
        phi_1639_ = array<f32, 3>(_e706, _e708, _e710);
    } else {
        if (_e676 == 1u) {
            phi_1638_ = array<f32, 3>(_e708, _e710, _e706);
        } else {
            phi_1638_ = array<f32, 3>(_e710, _e706, _e708);
        }
        let _e715 = phi_1638_;
        phi_1639_ = _e715;
    }
    let _e718 = phi_1639_;
    let _e729 = ((_e704[0] - _e619) * _e622);
    let _e730 = ((_e718[0] - _e620) * _e622);
    let _e731 = vec4<f32>(_e729, f32(), _e730, f32());
    let _e734 = ((_e704[1] - _e635) * _e638);
    let _e735 = ((_e718[1] - _e636) * _e638);
    let _e736 = vec4<f32>(_e734, f32(), _e735, f32());
    let _e739 = ((_e704[2] - _e651) * _e654);
    let _e740 = ((_e718[2] - _e652) * _e654);
    let _e741 = vec4<f32>(_e739, f32(), _e740, f32());
    let _e742 = vec4<f32>(_e730, f32(), _e729, f32());
    let _e744 = vec4<f32>(_e735, f32(), _e734, f32());
    let _e746 = vec4<f32>(_e740, f32(), _e739, f32());
    phi_1812_ = _e671;
    phi_1815_ = select(4294967295u, select(4294967295u, 0u, (_e662 <= _e661)), (max(max(max(min(_e731, _e742).x, min(_e736, _e744).x), min(_e741, _e746).x), _e662) <= min((min(min(max(_e731, _e742).x, max(_e736, _e744).x), max(_e741, _e746).x) + (max(max(_e741, _e746).x, -(min(_e741, _e746).x)) * 0.0000019073523f)), _e671.member.member_1)));
    phi_1817_ = select(0u, 4294967295u, (_e100 == 0u));
    phi_1819_ = (_e100 + 1u);
    loop {
        let _e770 = phi_1812_;
        let _e772 = phi_1815_;
        let _e774 = phi_1817_;
        let _e776 = phi_1819_;
        local_6 = _e770;
        let _e777 = (_e772 <= 2147483647u);
        if _e777 {
            phi_1828_ = _e772;
            phi_1831_ = _e774;
            phi_1833_ = _e776;
            loop {
                let _e779 = phi_1828_;
                let _e781 = phi_1831_;
                let _e783 = phi_1833_;
                local_2 = _e781;
                local_3 = _e779;
                local_4 = _e779;
                local_8 = _e779;
                local_9 = _e781;
                local_10 = _e783;
                let _e784 = (_e779 <= 2147483647u);
                let _e787 = (_e784 && !((_e781 >= _e100)));
                local_1 = _e784;
                if _e787 {
                    let _e793 = slimbvh_nodes.member[_e781].member[select(_e676, 2u, (2u < _e676))];
                    let _e799 = slimbvh_nodes.member[_e781].member[select(_e677, 2u, (2u < _e677))];
                    let _e805 = slimbvh_nodes.member[_e781].member[select(_e678, 2u, (2u < _e678))];
                    let _e808 = bitcast<u32>(_e147);
                    let _e813 = bitcast<f32>(_e793.x);
                    let _e818 = (_e813 + (f32((_e793.w >> bitcast<u32>(5u))) * _e147));
                    if (_e681 == 0u) {
                        phi_1929_ = SlimbvhTypeK(_e793.z, _e818);
                        phi_1930_ = SlimbvhTypeK(_e793.y, _e813);
                    } else {
                        phi_1929_ = SlimbvhTypeK(_e793.y, _e813);
                        phi_1930_ = SlimbvhTypeK(_e793.z, _e818);
                    }
                    let _e829 = phi_1929_;
                    let _e831 = phi_1930_;
                    let _e835 = bitcast<f32>(((_e808 + ((_e793.w & 31u) << bitcast<u32>(23i))) ^ (_e681 << bitcast<u32>(31i))));
                    let _e875 = bitcast<f32>(_e799.x);
                    let _e880 = (_e875 + (f32((_e799.w >> bitcast<u32>(5u))) * _e147));
                    if (_e684 == 0u) {
                        phi_1975_ = SlimbvhTypeK(_e799.z, _e880);
                        phi_1976_ = SlimbvhTypeK(_e799.y, _e875);
                    } else {
                        phi_1975_ = SlimbvhTypeK(_e799.y, _e875);
                        phi_1976_ = SlimbvhTypeK(_e799.z, _e880);
                    }
                    let _e891 = phi_1975_;
                    let _e893 = phi_1976_;
                    let _e897 = bitcast<f32>(((_e808 + ((_e799.w & 31u) << bitcast<u32>(23i))) ^ (_e684 << bitcast<u32>(31i))));
                    let _e937 = bitcast<f32>(_e805.x);
                    let _e942 = (_e937 + (f32((_e805.w >> bitcast<u32>(5u))) * _e147));
                    if (_e687 == 0u) {
                        phi_2021_ = SlimbvhTypeK(_e805.z, _e942);
                        phi_2022_ = SlimbvhTypeK(_e805.y, _e937);
                    } else {
                        phi_2021_ = SlimbvhTypeK(_e805.y, _e937);
                        phi_2022_ = SlimbvhTypeK(_e805.z, _e942);
                    }
                    let _e953 = phi_2021_;
                    let _e955 = phi_2022_;
                    let _e959 = bitcast<f32>(((_e808 + ((_e805.w & 31u) << bitcast<u32>(23i))) ^ (_e687 << bitcast<u32>(31i))));
                    let _e995 = (_e835 * _e622);
                    let _e1002 = (((_e831.member_1 - _e619) * _e622) + (bitcast<f32>((bitcast<u32>(_e995) & 2147483647u)) * -0.00012207031f));
                    let _e1011 = (-(_e835) * _e622);
                    let _e1018 = (((_e829.member_1 - _e620) * _e622) + (bitcast<f32>((bitcast<u32>(_e1011) & 2147483647u)) * 0.00012207031f));
                    let _e1027 = (_e897 * _e638);
                    let _e1034 = (((_e893.member_1 - _e635) * _e638) + (bitcast<f32>((bitcast<u32>(_e1027) & 2147483647u)) * -0.00012207031f));
                    let _e1043 = (-(_e897) * _e638);
                    let _e1050 = (((_e891.member_1 - _e636) * _e638) + (bitcast<f32>((bitcast<u32>(_e1043) & 2147483647u)) * 0.00012207031f));
                    let _e1059 = (_e959 * _e654);
                    let _e1066 = (((_e955.member_1 - _e651) * _e654) + (bitcast<f32>((bitcast<u32>(_e1059) & 2147483647u)) * -0.00012207031f));
                    let _e1071 = ((f32((_e955.member & 255u)) * _e1059) + _e1066);
                    let _e1072 = ((f32(((_e955.member >> bitcast<u32>(8u)) & 255u)) * _e1059) + _e1066);
                    let _e1073 = ((f32(((_e955.member >> bitcast<u32>(16u)) & 255u)) * _e1059) + _e1066);
                    let _e1074 = ((f32(((_e955.member >> bitcast<u32>(24u)) & 255u)) * _e1059) + _e1066);
                    let _e1075 = (-(_e959) * _e654);
                    let _e1082 = (((_e953.member_1 - _e652) * _e654) + (bitcast<f32>((bitcast<u32>(_e1075) & 2147483647u)) * 0.00012207031f));
                    let _e1087 = ((f32((_e953.member & 255u)) * _e1075) + _e1082);
                    let _e1088 = ((f32(((_e953.member >> bitcast<u32>(8u)) & 255u)) * _e1075) + _e1082);
                    let _e1089 = ((f32(((_e953.member >> bitcast<u32>(16u)) & 255u)) * _e1075) + _e1082);
                    let _e1090 = ((f32(((_e953.member >> bitcast<u32>(24u)) & 255u)) * _e1075) + _e1082);
                    let _e1123 = max(max(max(((f32((_e831.member & 255u)) * _e995) + _e1002), ((f32((_e893.member & 255u)) * _e1027) + _e1034)), _e1071), _e662);
                    let _e1124 = max(max(max(((f32(((_e831.member >> bitcast<u32>(8u)) & 255u)) * _e995) + _e1002), ((f32(((_e893.member >> bitcast<u32>(8u)) & 255u)) * _e1027) + _e1034)), _e1072), _e662);
                    let _e1125 = max(max(max(((f32(((_e831.member >> bitcast<u32>(16u)) & 255u)) * _e995) + _e1002), ((f32(((_e893.member >> bitcast<u32>(16u)) & 255u)) * _e1027) + _e1034)), _e1073), _e662);
                    let _e1126 = max(max(max(((f32(((_e831.member >> bitcast<u32>(24u)) & 255u)) * _e995) + _e1002), ((f32(((_e893.member >> bitcast<u32>(24u)) & 255u)) * _e1027) + _e1034)), _e1074), _e662);
                    let _e1131 = (_e770.member.member_1 + (bitcast<f32>((bitcast<u32>(_e770.member.member_1) & 2147483647u)) * 0.0000004768374f));
                    if (_e1123 <= min((min(min(((f32((_e829.member & 255u)) * _e1011) + _e1018), ((f32((_e891.member & 255u)) * _e1043) + _e1050)), _e1087) + (max(_e1087, -(_e1071)) * 0.0000023841915f)), _e1131)) {
                        phi_2498_ = (((bitcast<u32>(_e1123) ^ select(0u, 4294967288u, _e671.member_1)) & 2147483640u) | 4u);
                    } else {
                        phi_2498_ = 4294967288u;
                    }
                    let _e1146 = phi_2498_;
                    if (_e1124 <= min((min(min(((f32(((_e829.member >> bitcast<u32>(8u)) & 255u)) * _e1011) + _e1018), ((f32(((_e891.member >> bitcast<u32>(8u)) & 255u)) * _e1043) + _e1050)), _e1088) + (max(_e1088, -(_e1072)) * 0.0000023841915f)), _e1131)) {
                        phi_2511_ = ((((bitcast<u32>(_e1124) ^ select(0u, 4294967288u, _e671.member_1)) & 2147483640u) | 4u) | 1u);
                    } else {
                        phi_2511_ = 4294967288u;
                    }
                    let _e1154 = phi_2511_;
                    if (_e1125 <= min((min(min(((f32(((_e829.member >> bitcast<u32>(16u)) & 255u)) * _e1011) + _e1018), ((f32(((_e891.member >> bitcast<u32>(16u)) & 255u)) * _e1043) + _e1050)), _e1089) + (max(_e1089, -(_e1073)) * 0.0000023841915f)), _e1131)) {
                        phi_2524_ = ((((bitcast<u32>(_e1125) ^ select(0u, 4294967288u, _e671.member_1)) & 2147483640u) | 4u) | 2u);
                    } else {
                        phi_2524_ = 4294967288u;
                    }
                    let _e1162 = phi_2524_;
                    if (_e1126 <= min((min(min(((f32(((_e829.member >> bitcast<u32>(24u)) & 255u)) * _e1011) + _e1018), ((f32(((_e891.member >> bitcast<u32>(24u)) & 255u)) * _e1043) + _e1050)), _e1090) + (max(_e1090, -(_e1074)) * 0.0000023841915f)), _e1131)) {
                        phi_2537_ = ((((bitcast<u32>(_e1126) ^ select(0u, 4294967288u, _e671.member_1)) & 2147483640u) | 4u) | 3u);
                    } else {
                        phi_2537_ = 4294967288u;
                    }
                    let _e1170 = phi_2537_;
                    if (_e1146 < _e1154) {
                        phi_4712_ = SlimbvhTypeD(_e1146, _e1154);
                    } else {
                        phi_4712_ = SlimbvhTypeD(_e1154, _e1146);
                    }
                    let _e1175 = phi_4712_;
                    if (_e1162 < _e1170) {
                        phi_4724_ = SlimbvhTypeD(_e1162, _e1170);
                    } else {
                        phi_4724_ = SlimbvhTypeD(_e1170, _e1162);
                    }
                    let _e1182 = phi_4724_;
                    if (_e1175.member < _e1182.member) {
                        phi_4736_ = SlimbvhTypeD(_e1175.member, _e1182.member);
                    } else {
                        phi_4736_ = SlimbvhTypeD(_e1182.member, _e1175.member);
                    }
                    let _e1189 = phi_4736_;
                    if (_e1175.member_1 < _e1182.member_1) {
                        phi_4748_ = SlimbvhTypeD(_e1175.member_1, _e1182.member_1);
                    } else {
                        phi_4748_ = SlimbvhTypeD(_e1182.member_1, _e1175.member_1);
                    }
                    let _e1196 = phi_4748_;
                    if (_e1196.member < _e1189.member_1) {
                        phi_4760_ = SlimbvhTypeD(_e1196.member, _e1189.member_1);
                    } else {
                        phi_4760_ = SlimbvhTypeD(_e1189.member_1, _e1196.member);
                    }
                    let _e1203 = phi_4760_;
                    let _e1218 = (((_e1189.member & 7u) | ((_e1203.member & 7u) << bitcast<u32>(3u))) | (((_e1203.member_1 & 7u) | ((_e1196.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                    if (_e1218 == 0u) {
                        let _e1236 = (_e779 - 1u);
                        let _e1239 = local[(_e1236 % 128u)];
                        let _e1240 = (_e1239 & 511u);
                        let _e1242 = (_e1240 >> bitcast<u32>(3u));
                        let _e1245 = ((_e1242 == 0u) || (_e1236 == 4294967295u));
                        if _e1245 {
                        } else {
                            local[(_e1236 % 128u)] = (((_e1239 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1242);
                        }
                        phi_2623_ = select(_e779, _e1236, _e1245);
                        phi_2624_ = (((_e1239 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1240 & 3u) & 3u));
                    } else {
                        let _e1221 = (_e1218 >> bitcast<u32>(3u));
                        if (_e1221 == 0u) {
                            phi_2618_ = _e779;
                        } else {
                            local[(_e779 % 128u)] = ((_e781 << bitcast<u32>(9u)) | _e1221);
                            phi_2618_ = (_e779 + 1u);
                        }
                        let _e1230 = phi_2618_;
                        phi_2623_ = _e1230;
                        phi_2624_ = ((_e781 << bitcast<u32>(2i)) | ((_e1218 & 3u) & 3u));
                    }
                    let _e1260 = phi_2623_;
                    let _e1262 = phi_2624_;
                    let _e1264 = (_e1262 >> bitcast<u32>(2i));
                    if (_e1264 >= _e100) {
                        phi_2661_ = 4294967295u;
                    } else {
                        if (_e1264 < _e100) {
                            let _e1271 = slimbvh_nodes.member[_e1264].member_1[(_e1262 & 3u)];
                            phi_2653_ = _e1271;
                        } else {
                            phi_2653_ = 2147483648u;
                        }
                        let _e1273 = phi_2653_;
                        if ((_e1273 & 2147483648u) != 0u) {
                            phi_2660_ = (2147483648u | _e1262);
                        } else {
                            phi_2660_ = _e1273;
                        }
                        let _e1278 = phi_2660_;
                        phi_2661_ = _e1278;
                    }
                    let _e1280 = phi_2661_;
                    let _e1281 = (_e783 - 1u);
                    phi_1829_ = select(_e1260, 4294967295u, (_e1281 == 0u));
                    phi_1832_ = _e1280;
                    phi_1834_ = _e1281;
                } else {
                    phi_1829_ = u32();
                    phi_1832_ = u32();
                    phi_1834_ = u32();
                }
                let _e1285 = phi_1829_;
                let _e1287 = phi_1832_;
                let _e1289 = phi_1834_;
                continue;
                continuing {
                    phi_1828_ = _e1285;
                    phi_1831_ = _e1287;
                    phi_1833_ = _e1289;
                    break if !(_e787);
                }
            }
            let _e1292 = local_1;
            if _e1292 {
                let _e1294 = local_2;
                let _e1295 = (_e1294 & 2147483647u);
                let _e1297 = (_e1295 >> bitcast<u32>(2i));
                if (_e1297 >= _e100) {
                    phi_2888_ = SlimbvhTypeM(SlimbvhTypeL(vec4<f32>(0f, 0f, 0f, 0f), 0u), 0u, 0u);
                } else {
                    let _e1304 = slimbvh_nodes.member[_e1297].member[select(_e676, 2u, (2u < _e676))];
                    let _e1315 = slimbvh_nodes.member[_e1297].member[select(_e677, 2u, (2u < _e677))];
                    let _e1326 = slimbvh_nodes.member[_e1297].member[select(_e678, 2u, (2u < _e678))];
                    let _e1332 = (_e1295 & 3u);
                    let _e1335 = (((8u * _e1332) & 31u) & 31u);
                    let _e1343 = ((_e1304.w & 31u) & 31u);
                    let _e1345 = (((_e1304.y >> bitcast<u32>(_e1335)) & 255u) << bitcast<u32>(_e1343));
                    let _e1359 = ((_e1315.w & 31u) & 31u);
                    let _e1361 = (((_e1315.y >> bitcast<u32>(_e1335)) & 255u) << bitcast<u32>(_e1359));
                    let _e1375 = ((_e1326.w & 31u) & 31u);
                    let _e1377 = (((_e1326.y >> bitcast<u32>(_e1335)) & 255u) << bitcast<u32>(_e1375));
                    let _e1385 = (((((_e1304.w >> bitcast<u32>(5u)) - (((_e1304.z >> bitcast<u32>(_e1335)) & 255u) << bitcast<u32>(_e1343))) - _e1345) | (((_e1315.w >> bitcast<u32>(5u)) - (((_e1315.z >> bitcast<u32>(_e1335)) & 255u) << bitcast<u32>(_e1359))) - _e1361)) | (((_e1326.w >> bitcast<u32>(5u)) - (((_e1326.z >> bitcast<u32>(_e1335)) & 255u) << bitcast<u32>(_e1375))) - _e1377));
                    if (_e1385 < 1024u) {
                        phi_2816_ = 0u;
                    } else {
                        phi_2816_ = select(2u, 1u, (_e1385 < 2097152u));
                    }
                    let _e1390 = phi_2816_;
                    if (_e1297 < _e100) {
                        let _e1406 = slimbvh_nodes.member[_e1297].member_1[_e1332];
                        phi_2877_ = _e1406;
                    } else {
                        phi_2877_ = 2147483648u;
                    }
                    let _e1408 = phi_2877_;
                    if ((_e1408 & 2147483648u) != 0u) {
                        phi_2885_ = ((_e1408 >> bitcast<u32>(28u)) & 7u);
                    } else {
                        phi_2885_ = 0u;
                    }
                    let _e1415 = phi_2885_;
                    phi_2888_ = SlimbvhTypeM(SlimbvhTypeL(vec4<f32>((bitcast<f32>(_e1304.x) + (f32(_e1345) * _e147)), (bitcast<f32>(_e1315.x) + (f32(_e1361) * _e147)), (bitcast<f32>(_e1326.x) + (f32(_e1377) * _e147)), 0f), _e1390), (_e1408 & 268435455u), _e1415);
                }
                let _e1419 = phi_2888_;
                phi_2892_ = _e770;
                phi_2895_ = SlimbvhTypeD(0u, _e1419.member_2);
                loop {
                    let _e1423 = phi_2892_;
                    let _e1425 = phi_2895_;
                    local_5 = _e1423;
                    local_7 = _e1423;
                    if (_e1425.member < _e1425.member_1) {
                        phi_2896_ = SlimbvhTypeD((_e1425.member + 1u), _e1425.member_1);
                        phi_2918_ = SlimbvhTypeD(1u, _e1425.member);
                    } else {
                        phi_2896_ = _e1425;
                        phi_2918_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                    }
                    let _e1438 = phi_2896_;
                    let _e1440 = phi_2918_;
                    let _e1444 = (bitcast<i32>(_e1440.member) != 0i);
                    if _e1444 {
                        switch bitcast<i32>(_e1419.member.member_1) {
                            case 0: {
                                phi_2935_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_2935_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_2935_ = 3u;
                                break;
                            }
                            default: {
                                phi_2935_ = u32();
                                break;
                            }
                        }
                        let _e1450 = phi_2935_;
                        switch bitcast<i32>(_e1419.member.member_1) {
                            case 0: {
                                phi_2946_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_2946_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_2946_ = 3u;
                                break;
                            }
                            default: {
                                phi_2946_ = u32();
                                break;
                            }
                        }
                        let _e1457 = phi_2946_;
                        let _e1459 = ((_e1419.member_1 + (_e1440.member_1 * ((3u * _e1450) + 1u))) + (3u * _e1457));
                        if (_e1459 < _e103) {
                            let _e1462 = slimbvh_triangles.member[_e1459];
                            phi_2962_ = _e1462;
                        } else {
                            phi_2962_ = 4294967295u;
                        }
                        let _e1464 = phi_2962_;
                        switch bitcast<i32>(_e1419.member.member_1) {
                            case 0: {
                                phi_2977_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_2977_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_2977_ = 3u;
                                break;
                            }
                            default: {
                                phi_2977_ = u32();
                                break;
                            }
                        }
                        let _e1468 = phi_2977_;
                        let _e1472 = (_e1419.member_1 + (_e1440.member_1 * ((3u * _e1468) + 1u)));
                        switch bitcast<i32>(_e1419.member.member_1) {
                            case 0: {
                                if (_e1472 < _e103) {
                                    let _e1752 = slimbvh_triangles.member[_e1472];
                                    phi_3003_ = _e1752;
                                } else {
                                    phi_3003_ = 0u;
                                }
                                let _e1754 = phi_3003_;
                                let _e1757 = ((10u * _e207) & 31u);
                                let _e1768 = ((10u * _e211) & 31u);
                                let _e1779 = ((10u * _e203) & 31u);
                                let _e1789 = (_e1472 + 1u);
                                if (_e1789 < _e103) {
                                    let _e1792 = slimbvh_triangles.member[_e1789];
                                    phi_3052_ = _e1792;
                                } else {
                                    phi_3052_ = 0u;
                                }
                                let _e1794 = phi_3052_;
                                let _e1820 = (_e1472 + 2u);
                                if (_e1820 < _e103) {
                                    let _e1823 = slimbvh_triangles.member[_e1820];
                                    phi_3101_ = _e1823;
                                } else {
                                    phi_3101_ = 0u;
                                }
                                let _e1825 = phi_3101_;
                                phi_3602_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1419.member.member.x + ((bitcast<f32>((1258291200u | ((_e1754 >> bitcast<u32>(_e1757)) & 1023u))) - 8388608f) * _e147)), (_e1419.member.member.y + ((bitcast<f32>((1258291200u | ((_e1754 >> bitcast<u32>(_e1768)) & 1023u))) - 8388608f) * _e147)), (_e1419.member.member.z + ((bitcast<f32>((1258291200u | ((_e1754 >> bitcast<u32>(_e1779)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e1419.member.member.x + ((bitcast<f32>((1258291200u | ((_e1794 >> bitcast<u32>(_e1757)) & 1023u))) - 8388608f) * _e147)), (_e1419.member.member.y + ((bitcast<f32>((1258291200u | ((_e1794 >> bitcast<u32>(_e1768)) & 1023u))) - 8388608f) * _e147)), (_e1419.member.member.z + ((bitcast<f32>((1258291200u | ((_e1794 >> bitcast<u32>(_e1779)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e1419.member.member.x + ((bitcast<f32>((1258291200u | ((_e1825 >> bitcast<u32>(_e1757)) & 1023u))) - 8388608f) * _e147)), (_e1419.member.member.y + ((bitcast<f32>((1258291200u | ((_e1825 >> bitcast<u32>(_e1768)) & 1023u))) - 8388608f) * _e147)), (_e1419.member.member.z + ((bitcast<f32>((1258291200u | ((_e1825 >> bitcast<u32>(_e1779)) & 1023u))) - 8388608f) * _e147))));
                                break;
                            }
                            case 1: {
                                if (_e1472 < _e103) {
                                    let _e1563 = slimbvh_triangles.member[_e1472];
                                    phi_3150_ = _e1563;
                                } else {
                                    phi_3150_ = 0u;
                                }
                                let _e1565 = phi_3150_;
                                let _e1566 = (_e1472 + 1u);
                                if (_e1566 < _e103) {
                                    let _e1569 = slimbvh_triangles.member[_e1566];
                                    phi_3165_ = _e1569;
                                } else {
                                    phi_3165_ = 0u;
                                }
                                let _e1571 = phi_3165_;
                                let _e1573 = (_e207 == 1u);
                                if _e1573 {
                                    phi_3175_ = ((_e1565 >> bitcast<u32>(21i)) | (_e1571 << bitcast<u32>(11i)));
                                } else {
                                    phi_3175_ = (_e1571 >> bitcast<u32>(10i));
                                }
                                let _e1582 = phi_3175_;
                                let _e1591 = (_e211 == 1u);
                                if _e1591 {
                                    phi_3196_ = ((_e1565 >> bitcast<u32>(21i)) | (_e1571 << bitcast<u32>(11i)));
                                } else {
                                    phi_3196_ = (_e1571 >> bitcast<u32>(10i));
                                }
                                let _e1600 = phi_3196_;
                                let _e1609 = (_e203 == 1u);
                                if _e1609 {
                                    phi_3217_ = ((_e1565 >> bitcast<u32>(21i)) | (_e1571 << bitcast<u32>(11i)));
                                } else {
                                    phi_3217_ = (_e1571 >> bitcast<u32>(10i));
                                }
                                let _e1618 = phi_3217_;
                                let _e1627 = (_e1472 + 2u);
                                if (_e1627 < _e103) {
                                    let _e1630 = slimbvh_triangles.member[_e1627];
                                    phi_3247_ = _e1630;
                                } else {
                                    phi_3247_ = 0u;
                                }
                                let _e1632 = phi_3247_;
                                let _e1633 = (_e1472 + 3u);
                                if (_e1633 < _e103) {
                                    let _e1636 = slimbvh_triangles.member[_e1633];
                                    phi_3262_ = _e1636;
                                } else {
                                    phi_3262_ = 0u;
                                }
                                let _e1638 = phi_3262_;
                                if _e1573 {
                                    phi_3272_ = ((_e1632 >> bitcast<u32>(21i)) | (_e1638 << bitcast<u32>(11i)));
                                } else {
                                    phi_3272_ = (_e1638 >> bitcast<u32>(10i));
                                }
                                let _e1647 = phi_3272_;
                                if _e1591 {
                                    phi_3293_ = ((_e1632 >> bitcast<u32>(21i)) | (_e1638 << bitcast<u32>(11i)));
                                } else {
                                    phi_3293_ = (_e1638 >> bitcast<u32>(10i));
                                }
                                let _e1663 = phi_3293_;
                                if _e1609 {
                                    phi_3314_ = ((_e1632 >> bitcast<u32>(21i)) | (_e1638 << bitcast<u32>(11i)));
                                } else {
                                    phi_3314_ = (_e1638 >> bitcast<u32>(10i));
                                }
                                let _e1679 = phi_3314_;
                                let _e1688 = (_e1472 + 4u);
                                if (_e1688 < _e103) {
                                    let _e1691 = slimbvh_triangles.member[_e1688];
                                    phi_3344_ = _e1691;
                                } else {
                                    phi_3344_ = 0u;
                                }
                                let _e1693 = phi_3344_;
                                let _e1694 = (_e1472 + 5u);
                                if (_e1694 < _e103) {
                                    let _e1697 = slimbvh_triangles.member[_e1694];
                                    phi_3359_ = _e1697;
                                } else {
                                    phi_3359_ = 0u;
                                }
                                let _e1699 = phi_3359_;
                                if _e1573 {
                                    phi_3369_ = ((_e1693 >> bitcast<u32>(21i)) | (_e1699 << bitcast<u32>(11i)));
                                } else {
                                    phi_3369_ = (_e1699 >> bitcast<u32>(10i));
                                }
                                let _e1708 = phi_3369_;
                                if _e1591 {
                                    phi_3390_ = ((_e1693 >> bitcast<u32>(21i)) | (_e1699 << bitcast<u32>(11i)));
                                } else {
                                    phi_3390_ = (_e1699 >> bitcast<u32>(10i));
                                }
                                let _e1724 = phi_3390_;
                                if _e1609 {
                                    phi_3411_ = ((_e1693 >> bitcast<u32>(21i)) | (_e1699 << bitcast<u32>(11i)));
                                } else {
                                    phi_3411_ = (_e1699 >> bitcast<u32>(10i));
                                }
                                let _e1740 = phi_3411_;
                                phi_3602_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1419.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1582, _e1565, _e212) & 2097151u))) - 8388608f) * _e147)), (_e1419.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1600, _e1565, _e215) & 2097151u))) - 8388608f) * _e147)), (_e1419.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1618, _e1565, _e219) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e1419.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1647, _e1632, _e212) & 2097151u))) - 8388608f) * _e147)), (_e1419.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1663, _e1632, _e215) & 2097151u))) - 8388608f) * _e147)), (_e1419.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1679, _e1632, _e219) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e1419.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1708, _e1693, _e212) & 2097151u))) - 8388608f) * _e147)), (_e1419.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1724, _e1693, _e215) & 2097151u))) - 8388608f) * _e147)), (_e1419.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1740, _e1693, _e219) & 2097151u))) - 8388608f) * _e147))));
                                break;
                            }
                            case 2: {
                                let _e1474 = (_e1472 + _e207);
                                if (_e1474 < _e103) {
                                    let _e1477 = slimbvh_triangles.member[_e1474];
                                    phi_3442_ = _e1477;
                                } else {
                                    phi_3442_ = 0u;
                                }
                                let _e1479 = phi_3442_;
                                let _e1483 = (_e1472 + _e211);
                                if (_e1483 < _e103) {
                                    let _e1486 = slimbvh_triangles.member[_e1483];
                                    phi_3460_ = _e1486;
                                } else {
                                    phi_3460_ = 0u;
                                }
                                let _e1488 = phi_3460_;
                                let _e1492 = (_e1472 + _e203);
                                if (_e1492 < _e103) {
                                    let _e1495 = slimbvh_triangles.member[_e1492];
                                    phi_3478_ = _e1495;
                                } else {
                                    phi_3478_ = 0u;
                                }
                                let _e1497 = phi_3478_;
                                let _e1502 = (_e1472 + 3u);
                                let _e1503 = (_e1502 + _e207);
                                if (_e1503 < _e103) {
                                    let _e1506 = slimbvh_triangles.member[_e1503];
                                    phi_3501_ = _e1506;
                                } else {
                                    phi_3501_ = 0u;
                                }
                                let _e1508 = phi_3501_;
                                let _e1512 = (_e1502 + _e211);
                                if (_e1512 < _e103) {
                                    let _e1515 = slimbvh_triangles.member[_e1512];
                                    phi_3519_ = _e1515;
                                } else {
                                    phi_3519_ = 0u;
                                }
                                let _e1517 = phi_3519_;
                                let _e1521 = (_e1502 + _e203);
                                if (_e1521 < _e103) {
                                    let _e1524 = slimbvh_triangles.member[_e1521];
                                    phi_3537_ = _e1524;
                                } else {
                                    phi_3537_ = 0u;
                                }
                                let _e1526 = phi_3537_;
                                let _e1531 = (_e1472 + 6u);
                                let _e1532 = (_e1531 + _e207);
                                if (_e1532 < _e103) {
                                    let _e1535 = slimbvh_triangles.member[_e1532];
                                    phi_3560_ = _e1535;
                                } else {
                                    phi_3560_ = 0u;
                                }
                                let _e1537 = phi_3560_;
                                let _e1541 = (_e1531 + _e211);
                                if (_e1541 < _e103) {
                                    let _e1544 = slimbvh_triangles.member[_e1541];
                                    phi_3578_ = _e1544;
                                } else {
                                    phi_3578_ = 0u;
                                }
                                let _e1546 = phi_3578_;
                                let _e1550 = (_e1531 + _e203);
                                if (_e1550 < _e103) {
                                    let _e1553 = slimbvh_triangles.member[_e1550];
                                    phi_3596_ = _e1553;
                                } else {
                                    phi_3596_ = 0u;
                                }
                                let _e1555 = phi_3596_;
                                phi_3602_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1479)) * _e147), (f32(bitcast<i32>(_e1488)) * _e147), (f32(bitcast<i32>(_e1497)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1508)) * _e147), (f32(bitcast<i32>(_e1517)) * _e147), (f32(bitcast<i32>(_e1526)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1537)) * _e147), (f32(bitcast<i32>(_e1546)) * _e147), (f32(bitcast<i32>(_e1555)) * _e147)));
                                break;
                            }
                            default: {
                                phi_3602_ = array<array<f32, 3>, 3>();
                                break;
                            }
                        }
                        let _e1853 = phi_3602_;
                        let _e1870 = (_e1853[0][2] - _e595.member[2]);
                        let _e1873 = (((_e1853[0][0] - _e595.member[0]) * _e650) - (_e1870 * _e618));
                        let _e1876 = (((_e1853[0][1] - _e595.member[1]) * _e650) - (_e1870 * _e634));
                        let _e1879 = (_e1853[1][2] - _e595.member[2]);
                        let _e1882 = (((_e1853[1][0] - _e595.member[0]) * _e650) - (_e1879 * _e618));
                        let _e1885 = (((_e1853[1][1] - _e595.member[1]) * _e650) - (_e1879 * _e634));
                        let _e1888 = (_e1853[2][2] - _e595.member[2]);
                        let _e1891 = (((_e1853[2][0] - _e595.member[0]) * _e650) - (_e1888 * _e618));
                        let _e1894 = (((_e1853[2][1] - _e595.member[1]) * _e650) - (_e1888 * _e634));
                        let _e1895 = (_e1891 * _e1885);
                        let _e1896 = (_e1894 * _e1882);
                        let _e1897 = (_e1873 * _e1894);
                        let _e1898 = (_e1876 * _e1891);
                        let _e1899 = (_e1882 * _e1876);
                        let _e1900 = (_e1885 * _e1873);
                        let _e1905 = (((_e1895 >= _e1896) && (_e1897 >= _e1898)) && (_e1899 >= _e1900));
                        let _e1911 = (_e1905 || (((_e1895 <= _e1896) && (_e1897 <= _e1898)) && (_e1899 <= _e1900)));
                        if _e1911 {
                            let _e1913 = select(-1f, 1f, _e1905);
                            let _e1915 = ((_e1895 - _e1896) * _e1913);
                            let _e1917 = select(0f, _e1915, (_e1915 > 0f));
                            let _e1919 = ((_e1897 - _e1898) * _e1913);
                            let _e1921 = select(0f, _e1919, (_e1919 > 0f));
                            let _e1923 = ((_e1899 - _e1900) * _e1913);
                            let _e1925 = select(0f, _e1923, (_e1923 > 0f));
                            let _e1927 = ((_e1917 + _e1921) + _e1925);
                            let _e1942 = ((min(min(_e1853[0][0], _e1853[1][0]), _e1853[2][0]) - _e619) * _e622);
                            let _e1943 = ((max(max(_e1853[0][0], _e1853[1][0]), _e1853[2][0]) - _e620) * _e622);
                            let _e1944 = vec4<f32>(_e1942, f32(), _e1943, f32());
                            let _e1947 = ((min(min(_e1853[0][1], _e1853[1][1]), _e1853[2][1]) - _e635) * _e638);
                            let _e1948 = ((max(max(_e1853[0][1], _e1853[1][1]), _e1853[2][1]) - _e636) * _e638);
                            let _e1949 = vec4<f32>(_e1947, f32(), _e1948, f32());
                            let _e1952 = ((min(min(_e1853[0][2], _e1853[1][2]), _e1853[2][2]) - _e651) * _e654);
                            let _e1953 = ((max(max(_e1853[0][2], _e1853[1][2]), _e1853[2][2]) - _e652) * _e654);
                            let _e1954 = vec4<f32>(_e1952, f32(), _e1953, f32());
                            let _e1955 = vec4<f32>(_e1943, f32(), _e1942, f32());
                            let _e1957 = vec4<f32>(_e1948, f32(), _e1947, f32());
                            let _e1959 = vec4<f32>(_e1953, f32(), _e1952, f32());
                            let _e1968 = max(max(min(_e1944, _e1955).x, min(_e1949, _e1957).x), min(_e1954, _e1959).x);
                            let _e1973 = min(min(max(_e1944, _e1955).x, max(_e1949, _e1957).x), max(_e1954, _e1959).x);
                            let _e1978 = max(_e1968, _e662);
                            let _e2000 = (((((_e1911 && (_e1927 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1873, _e1882), _e1891) <= 0f) && (max(max(_e1873, _e1882), _e1891) >= 0f))) && ((min(min(_e1876, _e1885), _e1894) <= 0f) && (max(max(_e1876, _e1885), _e1894) >= 0f))) && (_e1978 <= (_e1973 + (max(max(_e1954, _e1959).x, -(min(_e1954, _e1959).x)) * 0.0000019073523f)))) && (_e1978 <= _e1423.member.member_1));
                            if _e2000 {
                                let _e2005 = (_e1853[1][0] - _e1853[0][0]);
                                let _e2006 = (_e1853[1][1] - _e1853[0][1]);
                                let _e2007 = (_e1853[1][2] - _e1853[0][2]);
                                let _e2008 = vec3<f32>(_e2005, _e2006, _e2007);
                                let _e2009 = (_e1853[2][0] - _e1853[1][0]);
                                let _e2010 = (_e1853[2][1] - _e1853[1][1]);
                                let _e2011 = (_e1853[2][2] - _e1853[1][2]);
                                let _e2012 = vec3<f32>(_e2009, _e2010, _e2011);
                                let _e2013 = (_e1853[0][0] - _e1853[2][0]);
                                let _e2014 = (_e1853[0][1] - _e1853[2][1]);
                                let _e2015 = (_e1853[0][2] - _e1853[2][2]);
                                let _e2016 = vec3<f32>(_e2013, _e2014, _e2015);
                                let _e2027 = max(max(bitcast<f32>((bitcast<u32>(_e2005) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2006) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2007) & 2147483647u)));
                                let _e2038 = max(max(bitcast<f32>((bitcast<u32>(_e2009) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2010) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2011) & 2147483647u)));
                                let _e2051 = max(max(_e2027, _e2038), max(max(bitcast<f32>((bitcast<u32>(_e2013) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2014) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2015) & 2147483647u))));
                                if (_e2027 == _e2051) {
                                    phi_3967_ = _e1885;
                                    phi_3968_ = _e1882;
                                    phi_3969_ = _e1876;
                                    phi_3970_ = _e1873;
                                    phi_3971_ = vec3<f32>(_e1853[0][0], _e1853[0][1], _e1853[0][2]);
                                    phi_3972_ = _e2016;
                                    phi_3973_ = _e2012;
                                    phi_3974_ = _e2008;
                                } else {
                                    let _e2053 = (_e2038 == _e2051);
                                    let _e2058 = vec3(_e2053);
                                    phi_3967_ = select(_e1876, _e1894, _e2053);
                                    phi_3968_ = select(_e1873, _e1891, _e2053);
                                    phi_3969_ = select(_e1894, _e1885, _e2053);
                                    phi_3970_ = select(_e1891, _e1882, _e2053);
                                    phi_3971_ = select(vec3<f32>(_e1853[2][0], _e1853[2][1], _e1853[2][2]), vec3<f32>(_e1853[1][0], _e1853[1][1], _e1853[1][2]), _e2058);
                                    phi_3972_ = select(_e2012, _e2008, _e2058);
                                    phi_3973_ = select(_e2008, _e2016, _e2058);
                                    phi_3974_ = select(_e2016, _e2012, _e2058);
                                }
                                let _e2064 = phi_3967_;
                                let _e2066 = phi_3968_;
                                let _e2068 = phi_3969_;
                                let _e2070 = phi_3970_;
                                let _e2072 = phi_3971_;
                                let _e2074 = phi_3972_;
                                let _e2076 = phi_3973_;
                                let _e2078 = phi_3974_;
                                let _e2085 = ((_e2076.y * _e2074.z) - (_e2074.y * _e2076.z));
                                let _e2090 = ((_e2076.z * _e2074.x) - (_e2074.z * _e2076.x));
                                let _e2093 = ((_e2076.x * _e2074.y) - (_e2074.x * _e2076.y));
                                let _e2096 = ((_e1917 >= _e1921) && (_e1917 >= _e1925));
                                let _e2097 = (_e1921 >= _e1925);
                                let _e2111 = (((_e2085 * (select(select(_e1853[2][0], _e1853[1][0], _e2097), _e1853[0][0], _e2096) - _e595.member[0])) + (_e2090 * (select(select(_e1853[2][1], _e1853[1][1], _e2097), _e1853[0][1], _e2096) - _e595.member[1]))) + (_e2093 * (select(select(_e1853[2][2], _e1853[1][2], _e2097), _e1853[0][2], _e2096) - _e595.member[2])));
                                let _e2116 = (((_e2085 * _e618) + (_e2090 * _e634)) + (_e2093 * _e650));
                                let _e2117 = (_e2066 - _e2070);
                                let _e2118 = (_e2064 - _e2068);
                                let _e2121 = ((_e2117 * _e2117) + (_e2118 * _e2118));
                                let _e2128 = (-(((_e2070 * _e2117) + (_e2068 * _e2118))) / select(0.000000000000000000000000000000000000011754944f, _e2121, (_e2121 > 0.000000000000000000000000000000000000011754944f)));
                                let _e2130 = select(1f, _e2128, (_e2128 < 1f));
                                let _e2132 = select(0f, _e2130, (_e2130 > 0f));
                                let _e2141 = ((_e2072.x + (_e2078.x * _e2132)) - _e595.member[0]);
                                let _e2144 = ((_e2072.y + (_e2078.y * _e2132)) - _e595.member[1]);
                                let _e2147 = ((_e2072.z + (_e2078.z * _e2132)) - _e595.member[2]);
                                let _e2212 = ((bitcast<f32>((bitcast<u32>(((((_e2085 * _e2141) + (_e2090 * _e2144)) + (_e2093 * _e2147)) - _e2111)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e2141) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2144) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2147) & 2147483647u))), _e2051)) * max(max(bitcast<f32>((bitcast<u32>(_e2085) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2090) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2093) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e2116) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e2076.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2076.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2076.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e2074.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2074.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2074.z) & 2147483647u)))))));
                                let _e2213 = (_e2111 / _e2116);
                                if (_e2000 && !(_e2212)) {
                                    let _e2216 = (_e2147 / _e650);
                                    let _e2224 = (((_e2085 * (_e2141 - (_e618 * _e2216))) + (_e2090 * (_e2144 - (_e634 * _e2216)))) / _e2116);
                                    phi_4153_ = select(select(_e2216, (_e2216 + _e2224), (bitcast<f32>((bitcast<u32>(_e2224) & 2147483647u)) <= _e2051)), _e2213, _e2212);
                                } else {
                                    phi_4153_ = _e2213;
                                }
                                let _e2233 = phi_4153_;
                                let _e2235 = select(_e1973, _e2233, (_e2233 < _e1973));
                                let _e2237 = select(_e1968, _e2235, (_e2235 > _e1968));
                                let _e2240 = select(_e2237, 0f, (bitcast<u32>(_e2237) == 2147483648u));
                                let _e2241 = (1f / _e1927);
                                phi_4179_ = SlimbvhTypeE(_e2240, (_e1921 * _e2241), (_e1925 * _e2241), ((_e2000 && (_e2240 >= _e662)) && (_e2240 <= _e1423.member.member_1)));
                                phi_4180_ = SlimbvhTypeE();
                            } else {
                                phi_4179_ = SlimbvhTypeE();
                                phi_4180_ = SlimbvhTypeE(0f, 0f, 0f, _e2000);
                            }
                            let _e2250 = phi_4179_;
                            let _e2252 = phi_4180_;
                            phi_4183_ = _e2250;
                            phi_4184_ = _e2252;
                            phi_4185_ = select(true, false, _e2000);
                        } else {
                            phi_4183_ = SlimbvhTypeE();
                            phi_4184_ = SlimbvhTypeE(0f, 0f, 0f, _e1911);
                            phi_4185_ = true;
                        }
                        let _e2255 = phi_4183_;
                        let _e2257 = phi_4184_;
                        let _e2259 = phi_4185_;
                        if _e2259 {
                            phi_4189_ = _e2257;
                        } else {
                            phi_4189_ = _e2255;
                        }
                        let _e2261 = phi_4189_;
                        if _e2261.member_3 {
                            phi_4198_ = SlimbvhTypeF(_e2261.member, _e2261.member_1, _e2261.member_2, _e1464);
                        } else {
                            phi_4198_ = _e96;
                        }
                        let _e2268 = phi_4198_;
                        if (_e2268.member_3 != 4294967295u) {
                            if (_e1464 != 4294967295u) {
                                if (_e2268.member < _e1423.member.member.member) {
                                    phi_4226_ = true;
                                } else {
                                    if (_e2268.member == _e1423.member.member.member) {
                                        phi_4225_ = (_e2268.member_3 < _e1423.member.member.member_3);
                                    } else {
                                        phi_4225_ = false;
                                    }
                                    let _e2283 = phi_4225_;
                                    phi_4226_ = _e2283;
                                }
                                let _e2285 = phi_4226_;
                                if _e2285 {
                                    phi_4233_ = SlimbvhTypeP(SlimbvhTypeH(_e2268, _e2268.member), _e1423.member_1);
                                } else {
                                    phi_4233_ = _e1423;
                                }
                                let _e2291 = phi_4233_;
                                if _e2291.member_1 {
                                    phi_4239_ = SlimbvhTypeP(SlimbvhTypeH(_e2291.member.member, bitcast<f32>(4286578687u)), _e2291.member_1);
                                } else {
                                    phi_4239_ = _e2291;
                                }
                                let _e2300 = phi_4239_;
                                phi_4240_ = _e2300;
                            } else {
                                phi_4240_ = _e1423;
                            }
                            let _e2302 = phi_4240_;
                            phi_4241_ = _e2302;
                        } else {
                            phi_4241_ = _e1423;
                        }
                        let _e2304 = phi_4241_;
                        phi_2893_ = _e2304;
                    } else {
                        phi_2893_ = SlimbvhTypeP();
                    }
                    let _e2306 = phi_2893_;
                    continue;
                    continuing {
                        phi_2892_ = _e2306;
                        phi_2895_ = _e1438;
                        break if !(_e1444);
                    }
                }
                let _e2309 = local_3;
                let _e2310 = (_e2309 - 1u);
                let _e2313 = local[(_e2310 % 128u)];
                let _e2314 = (_e2313 & 511u);
                let _e2316 = (_e2314 >> bitcast<u32>(3u));
                let _e2319 = ((_e2316 == 0u) || (_e2310 == 4294967295u));
                if _e2319 {
                } else {
                    local[(_e2310 % 128u)] = (((_e2313 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2316);
                }
                let _e2326 = local_4;
                let _e2334 = (((_e2313 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2314 & 3u) & 3u));
                let _e2336 = (_e2334 >> bitcast<u32>(2i));
                if (_e2336 >= _e100) {
                    phi_4313_ = 4294967295u;
                } else {
                    if (_e2336 < _e100) {
                        let _e2343 = slimbvh_nodes.member[_e2336].member_1[(_e2334 & 3u)];
                        phi_4305_ = _e2343;
                    } else {
                        phi_4305_ = 2147483648u;
                    }
                    let _e2345 = phi_4305_;
                    if ((_e2345 & 2147483648u) != 0u) {
                        phi_4312_ = (2147483648u | _e2334);
                    } else {
                        phi_4312_ = _e2345;
                    }
                    let _e2350 = phi_4312_;
                    phi_4313_ = _e2350;
                }
                let _e2352 = phi_4313_;
                let _e2354 = local_5;
                let _e2642 = local_7;
                phi_4322_ = _e2642;
                phi_4323_ = select(select(_e2326, _e2310, _e2319), 4294967295u, (_e662 > _e2354.member.member_1));
                phi_4324_ = _e2352;
            } else {
                phi_4322_ = _e770;
                let _e2645 = local_8;
                phi_4323_ = _e2645;
                let _e2648 = local_9;
                phi_4324_ = _e2648;
            }
            let _e2360 = phi_4322_;
            let _e2362 = phi_4323_;
            let _e2364 = phi_4324_;
            phi_1813_ = _e2360;
            phi_1816_ = _e2362;
            phi_1818_ = _e2364;
            let _e2654 = local_10;
            phi_1820_ = _e2654;
        } else {
            phi_1813_ = SlimbvhTypeP();
            phi_1816_ = u32();
            phi_1818_ = u32();
            phi_1820_ = u32();
        }
        let _e2366 = phi_1813_;
        let _e2368 = phi_1816_;
        let _e2370 = phi_1818_;
        let _e2372 = phi_1820_;
        continue;
        continuing {
            phi_1812_ = _e2366;
            phi_1815_ = _e2368;
            phi_1817_ = _e2370;
            phi_1819_ = _e2372;
            break if !(_e777);
        }
    }
    let _e2375 = local_6;
    if (_e2375.member.member.member_3 != 4294967295u) {
        let _e2381 = -((_e165 + _e595.member_4));
        let _e2382 = bitcast<u32>(_e2375.member.member.member);
        let _e2386 = (bitcast<i32>((_e2382 >> bitcast<u32>(23i))) & 255i);
        let _e2387 = (_e2386 + _e2381);
        if (_e2386 == 255i) {
            phi_4381_ = _e2375.member.member.member;
        } else {
            if (_e2386 > 0i) {
                if (_e2387 > 0i) {
                    let _e2391 = (_e2387 < 255i);
                    if _e2391 {
                        phi_4360_ = bitcast<f32>((_e2382 + bitcast<u32>((_e2381 << bitcast<u32>(23i)))));
                    } else {
                        phi_4360_ = f32();
                    }
                    let _e2398 = phi_4360_;
                    phi_4362_ = _e2398;
                    phi_4363_ = select(true, false, _e2391);
                } else {
                    phi_4362_ = f32();
                    phi_4363_ = true;
                }
                let _e2401 = phi_4362_;
                let _e2403 = phi_4363_;
                phi_4364_ = _e2401;
                phi_4365_ = _e2403;
            } else {
                phi_4364_ = f32();
                phi_4365_ = true;
            }
            let _e2405 = phi_4364_;
            let _e2407 = phi_4365_;
            if _e2407 {
                let _e2408 = (_e2382 & 2147483648u);
                let _e2415 = ((_e2382 & 8388607u) | (select(0u, 1u, ((_e2382 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e2419 = (_e2415 == 0u);
                if _e2419 {
                    phi_5041_ = bitcast<f32>(_e2408);
                } else {
                    let _e2424 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2415)), 32u, _e2419) - 8u);
                    let _e2427 = (_e2415 << bitcast<u32>((_e2424 & 31u)));
                    let _e2429 = ((_e2387 + select(0i, 1i, (_e2386 == 0i))) - bitcast<i32>(_e2424));
                    if (_e2429 >= 255i) {
                        phi_5031_ = bitcast<f32>((_e2408 | 2139095040u));
                        phi_5032_ = f32();
                        phi_5033_ = true;
                    } else {
                        let _e2431 = (_e2429 > 0i);
                        if _e2431 {
                            phi_5025_ = bitcast<f32>(((_e2408 | (bitcast<u32>(_e2429) << bitcast<u32>(23i))) | (_e2427 & 8388607u)));
                            phi_5026_ = f32();
                        } else {
                            if (_e2429 < -24i) {
                                phi_4991_ = 26u;
                            } else {
                                phi_4991_ = bitcast<u32>((1i - _e2429));
                            }
                            let _e2436 = phi_4991_;
                            let _e2437 = (_e2436 & 31u);
                            let _e2439 = (_e2427 >> bitcast<u32>(_e2437));
                            let _e2443 = (_e2427 & ((1u << bitcast<u32>(_e2437)) - 1u));
                            let _e2447 = (1u << bitcast<u32>(((_e2436 - 1u) & 31u)));
                            if (_e2443 > _e2447) {
                                phi_5012_ = true;
                            } else {
                                if (_e2443 == _e2447) {
                                    phi_5009_ = ((_e2439 & 1u) == 1u);
                                } else {
                                    phi_5009_ = false;
                                }
                                let _e2453 = phi_5009_;
                                phi_5012_ = _e2453;
                            }
                            let _e2455 = phi_5012_;
                            phi_5025_ = f32();
                            phi_5026_ = bitcast<f32>((_e2408 | (_e2439 + select(0u, 1u, _e2455))));
                        }
                        let _e2468 = phi_5025_;
                        let _e2470 = phi_5026_;
                        phi_5031_ = _e2468;
                        phi_5032_ = _e2470;
                        phi_5033_ = _e2431;
                    }
                    let _e2474 = phi_5031_;
                    let _e2476 = phi_5032_;
                    let _e2478 = phi_5033_;
                    phi_5041_ = select(_e2476, _e2474, _e2478);
                }
                let _e2482 = phi_5041_;
                phi_4380_ = _e2482;
            } else {
                phi_4380_ = _e2405;
            }
            let _e2484 = phi_4380_;
            phi_4381_ = _e2484;
        }
        let _e2486 = phi_4381_;
        let _e2487 = bitcast<u32>(_e2486);
        if ((_e2487 & 2147483647u) >= 2139095040u) {
            phi_4393_ = bitcast<f32>(((_e2487 & 2147483648u) | 2139095039u));
        } else {
            phi_4393_ = _e2486;
        }
        let _e2494 = phi_4393_;
        phi_4398_ = SlimbvhTypeF(_e2494, _e2375.member.member.member_1, _e2375.member.member.member_2, _e2375.member.member.member_3);
    } else {
        phi_4398_ = _e96;
    }
    let _e2499 = phi_4398_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2499.member), bitcast<u32>(_e2499.member_1), bitcast<u32>(_e2499.member_2), _e2499.member_3);
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
