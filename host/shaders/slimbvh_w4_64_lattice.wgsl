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
    var phi_705_: u32;
    var phi_711_: u32;
    var phi_717_: u32;
    var phi_982_: i32;
    var phi_993_: i32;
    var phi_1107_: i32;
    var phi_1236_: i32;
    var phi_1258_: u32;
    var phi_1259_: u32;
    var phi_1260_: bool;
    var phi_1294_: i32;
    var phi_1316_: u32;
    var phi_1317_: u32;
    var phi_1318_: bool;
    var phi_879_: i32;
    var phi_885_: u32;
    var phi_904_: u32;
    var phi_905_: u32;
    var phi_906_: bool;
    var phi_924_: i32;
    var phi_930_: u32;
    var phi_949_: u32;
    var phi_950_: u32;
    var phi_951_: bool;
    var phi_1328_: SlimbvhTypeC;
    var phi_1557_: SlimbvhTypeP;
    var phi_1620_: array<f32, 3>;
    var phi_1621_: array<f32, 3>;
    var phi_1639_: array<f32, 3>;
    var phi_1640_: array<f32, 3>;
    var phi_1813_: SlimbvhTypeP;
    var phi_1816_: u32;
    var phi_1818_: u32;
    var phi_1820_: u32;
    var phi_1829_: u32;
    var phi_1832_: u32;
    var phi_1834_: u32;
    var phi_1936_: SlimbvhTypeK;
    var phi_1937_: SlimbvhTypeK;
    var phi_1996_: SlimbvhTypeK;
    var phi_1997_: SlimbvhTypeK;
    var phi_2056_: SlimbvhTypeK;
    var phi_2057_: SlimbvhTypeK;
    var phi_2541_: u32;
    var phi_2554_: u32;
    var phi_2567_: u32;
    var phi_2580_: u32;
    var phi_4701_: SlimbvhTypeD;
    var phi_4713_: SlimbvhTypeD;
    var phi_4725_: SlimbvhTypeD;
    var phi_4737_: SlimbvhTypeD;
    var phi_4749_: SlimbvhTypeD;
    var phi_2661_: u32;
    var phi_2666_: u32;
    var phi_2667_: u32;
    var phi_2697_: u32;
    var phi_2698_: u32;
    var phi_1830_: u32;
    var phi_1833_: u32;
    var phi_1835_: u32;
    var local_1: bool;
    var local_2: u32;
    var phi_2848_: u32;
    var phi_2909_: u32;
    var phi_2912_: SlimbvhTypeM;
    var phi_2916_: SlimbvhTypeP;
    var phi_2919_: SlimbvhTypeD;
    var phi_2920_: SlimbvhTypeD;
    var phi_2942_: SlimbvhTypeD;
    var phi_2960_: u32;
    var phi_2971_: u32;
    var phi_2987_: u32;
    var phi_3000_: u32;
    var phi_3011_: u32;
    var phi_3455_: u32;
    var phi_3468_: u32;
    var phi_3481_: u32;
    var phi_3507_: u32;
    var phi_3520_: u32;
    var phi_3533_: u32;
    var phi_3559_: u32;
    var phi_3572_: u32;
    var phi_3585_: u32;
    var phi_3177_: u32;
    var phi_3190_: u32;
    var phi_3200_: u32;
    var phi_3221_: u32;
    var phi_3242_: u32;
    var phi_3269_: u32;
    var phi_3282_: u32;
    var phi_3292_: u32;
    var phi_3313_: u32;
    var phi_3334_: u32;
    var phi_3361_: u32;
    var phi_3374_: u32;
    var phi_3384_: u32;
    var phi_3405_: u32;
    var phi_3426_: u32;
    var phi_3038_: u32;
    var phi_3084_: u32;
    var phi_3130_: u32;
    var phi_3597_: array<array<f32, 3>, 3>;
    var phi_3962_: f32;
    var phi_3963_: f32;
    var phi_3964_: f32;
    var phi_3965_: f32;
    var phi_3966_: vec3<f32>;
    var phi_3967_: vec3<f32>;
    var phi_3968_: vec3<f32>;
    var phi_3969_: vec3<f32>;
    var phi_4148_: f32;
    var phi_4174_: SlimbvhTypeE;
    var phi_4175_: SlimbvhTypeE;
    var phi_4178_: SlimbvhTypeE;
    var phi_4179_: SlimbvhTypeE;
    var phi_4180_: bool;
    var phi_4184_: SlimbvhTypeE;
    var phi_4193_: SlimbvhTypeF;
    var phi_4220_: bool;
    var phi_4221_: bool;
    var phi_4228_: SlimbvhTypeP;
    var phi_4234_: SlimbvhTypeP;
    var phi_4235_: SlimbvhTypeP;
    var phi_4236_: SlimbvhTypeP;
    var phi_2917_: SlimbvhTypeP;
    var local_3: u32;
    var local_4: u32;
    var phi_4301_: u32;
    var phi_4302_: u32;
    var local_5: SlimbvhTypeP;
    var phi_4311_: SlimbvhTypeP;
    var phi_4312_: u32;
    var phi_4313_: u32;
    var phi_1814_: SlimbvhTypeP;
    var phi_1817_: u32;
    var phi_1819_: u32;
    var phi_1821_: u32;
    var local_6: SlimbvhTypeP;
    var phi_4349_: f32;
    var phi_4351_: f32;
    var phi_4352_: bool;
    var phi_4353_: f32;
    var phi_4354_: bool;
    var phi_4980_: u32;
    var phi_4998_: bool;
    var phi_5001_: bool;
    var phi_5014_: f32;
    var phi_5015_: f32;
    var phi_5020_: f32;
    var phi_5021_: f32;
    var phi_5022_: bool;
    var phi_5030_: f32;
    var phi_4369_: f32;
    var phi_4370_: f32;
    var phi_4382_: f32;
    var phi_4387_: SlimbvhTypeF;
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
        phi_705_ = 0u;
    } else {
        phi_705_ = select(2u, 1u, (_e177 == _e185));
    }
    let _e203 = phi_705_;
    let _e204 = (_e203 == 2u);
    if _e204 {
        phi_711_ = 0u;
    } else {
        phi_711_ = (_e203 + 1u);
    }
    let _e207 = phi_711_;
    let _e208 = (_e207 == 2u);
    if _e208 {
        phi_717_ = 0u;
    } else {
        phi_717_ = (_e207 + 1u);
    }
    let _e211 = phi_717_;
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
            phi_879_ = 255i;
        } else {
            phi_879_ = (bitcast<i32>((_e173 >> bitcast<u32>(23i))) + _e514);
        }
        let _e539 = phi_879_;
        if (_e173 == 0u) {
            phi_885_ = 0u;
        } else {
            phi_885_ = (_e173 | 8388608u);
        }
        let _e543 = phi_885_;
        if (_e539 <= 0i) {
            phi_905_ = u32();
            phi_906_ = true;
        } else {
            let _e550 = (_e543 == 0u);
            if _e550 {
                phi_904_ = u32();
            } else {
                phi_904_ = select(((bitcast<u32>(_e539) << bitcast<u32>(23i)) | (_e543 & 8388607u)), 2139095039u, (_e539 >= 255i));
            }
            let _e554 = phi_904_;
            phi_905_ = _e554;
            phi_906_ = _e550;
        }
        let _e556 = phi_905_;
        let _e558 = phi_906_;
        if (_e181 >= 2139095040u) {
            phi_924_ = 255i;
        } else {
            phi_924_ = (bitcast<i32>((_e181 >> bitcast<u32>(23i))) + _e514);
        }
        let _e569 = phi_924_;
        if (_e181 == 0u) {
            phi_930_ = 0u;
        } else {
            phi_930_ = (_e181 | 8388608u);
        }
        let _e573 = phi_930_;
        if (_e569 <= 0i) {
            phi_950_ = u32();
            phi_951_ = true;
        } else {
            let _e580 = (_e573 == 0u);
            if _e580 {
                phi_949_ = u32();
            } else {
                phi_949_ = select(((bitcast<u32>(_e569) << bitcast<u32>(23i)) | (_e573 & 8388607u)), 2139095039u, (_e569 >= 255i));
            }
            let _e584 = phi_949_;
            phi_950_ = _e584;
            phi_951_ = _e580;
        }
        let _e586 = phi_950_;
        let _e588 = phi_951_;
        phi_1328_ = SlimbvhTypeC(array<f32, 3>((_e214 * _e519), (_e218 * _e519), (_e221 * _e519)), array<f32, 3>((_e223 * _e524), (_e225 * _e524), (_e227 * _e524)), bitcast<f32>(((_e172 & 2147483648u) | select(_e556, 0u, _e558))), bitcast<f32>(((_e180 & 2147483648u) | select(_e586, 0u, _e588))), _e513);
    } else {
        let _e260 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e185, _e198))) & 2147483647u);
        if (_e260 >= 8388608u) {
            phi_982_ = (bitcast<i32>((_e260 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_982_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e260)), 32u, (_e260 == 0u))));
        }
        let _e274 = phi_982_;
        let _e275 = (_e165 + _e274);
        if (_e165 < -126i) {
            phi_993_ = -126i;
        } else {
            phi_993_ = select(_e165, 127i, (_e165 > 127i));
        }
        let _e280 = phi_993_;
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
            phi_1107_ = -126i;
        } else {
            phi_1107_ = select(_e344, 127i, (_e344 > 127i));
        }
        let _e349 = phi_1107_;
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
            phi_1236_ = 255i;
        } else {
            phi_1236_ = (((_e422 + select(0i, 1i, (_e422 == 0i))) - _e429) + _e275);
        }
        let _e437 = phi_1236_;
        let _e441 = (_e419 << bitcast<u32>(((_e429 & 31i) & 31i)));
        if (_e437 <= 0i) {
            phi_1259_ = u32();
            phi_1260_ = true;
        } else {
            let _e448 = (_e441 == 0u);
            if _e448 {
                phi_1258_ = u32();
            } else {
                phi_1258_ = select(((bitcast<u32>(_e437) << bitcast<u32>(23i)) | (_e441 & 8388607u)), 2139095039u, (_e437 >= 255i));
            }
            let _e452 = phi_1258_;
            phi_1259_ = _e452;
            phi_1260_ = _e448;
        }
        let _e454 = phi_1259_;
        let _e456 = phi_1260_;
        let _e467 = ((_e181 & 8388607u) | (select(0u, 1u, ((_e181 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e470 = bitcast<i32>((_e181 >> bitcast<u32>(23i)));
        let _e477 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e467)), 32u, (_e467 == 0u))) - 8i);
        if (_e470 == 255i) {
            phi_1294_ = 255i;
        } else {
            phi_1294_ = (((_e470 + select(0i, 1i, (_e470 == 0i))) - _e477) + _e275);
        }
        let _e485 = phi_1294_;
        let _e489 = (_e467 << bitcast<u32>(((_e477 & 31i) & 31i)));
        if (_e485 <= 0i) {
            phi_1317_ = u32();
            phi_1318_ = true;
        } else {
            let _e496 = (_e489 == 0u);
            if _e496 {
                phi_1316_ = u32();
            } else {
                phi_1316_ = select(((bitcast<u32>(_e485) << bitcast<u32>(23i)) | (_e489 & 8388607u)), 2139095039u, (_e485 >= 255i));
            }
            let _e500 = phi_1316_;
            phi_1317_ = _e500;
            phi_1318_ = _e496;
        }
        let _e502 = phi_1317_;
        let _e504 = phi_1318_;
        phi_1328_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e292 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e292 & 2147483648u))), _e214, _e294) * _e285) * select(0.00000011920929f, 1f, _e294)) * _e291), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e309 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e309 & 2147483648u))), _e218, _e311) * _e285) * select(0.00000011920929f, 1f, _e311)) * _e291), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e326 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e326 & 2147483648u))), _e221, _e328) * _e285) * select(0.00000011920929f, 1f, _e328)) * _e291)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e361 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e361 & 2147483648u))), _e223, _e363) * _e354) * select(0.00000011920929f, 1f, _e363)) * _e360), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e378 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e378 & 2147483648u))), _e225, _e380) * _e354) * select(0.00000011920929f, 1f, _e380)) * _e360), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e395 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e395 & 2147483648u))), _e227, _e397) * _e354) * select(0.00000011920929f, 1f, _e397)) * _e360)), bitcast<f32>(((_e172 & 2147483648u) | select(_e454, 0u, _e456))), bitcast<f32>(((_e180 & 2147483648u) | select(_e502, 0u, _e504))), _e274);
    }
    let _e595 = phi_1328_;
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
        phi_1557_ = SlimbvhTypeP(SlimbvhTypeH(_e96, _e661), true);
    } else {
        phi_1557_ = SlimbvhTypeP(SlimbvhTypeH(_e96, _e661), false);
    }
    let _e671 = phi_1557_;
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
        phi_1621_ = array<f32, 3>(_e691, _e693, _e695);
    } else {
        if (_e676 == 1u) {
            phi_1620_ = array<f32, 3>(_e693, _e695, _e691);
        } else {
            phi_1620_ = array<f32, 3>(_e695, _e691, _e693);
        }
        let _e701 = phi_1620_;
        phi_1621_ = _e701;
    }
    let _e704 = phi_1621_;
    let _e706 = (f32(bitcast<i32>(_e127)) * _e147);
    let _e708 = (f32(bitcast<i32>(_e131)) * _e147);
    let _e710 = (f32(bitcast<i32>(_e135)) * _e147);
    if _e696 {
        phi_1640_ = array<f32, 3>(_e706, _e708, _e710);
    } else {
        if (_e676 == 1u) {
            phi_1639_ = array<f32, 3>(_e708, _e710, _e706);
        } else {
            phi_1639_ = array<f32, 3>(_e710, _e706, _e708);
        }
        let _e715 = phi_1639_;
        phi_1640_ = _e715;
    }
    let _e718 = phi_1640_;
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
    phi_1813_ = _e671;
    phi_1816_ = select(4294967295u, select(4294967295u, 0u, (_e662 <= _e661)), (max(max(max(min(_e731, _e742).x, min(_e736, _e744).x), min(_e741, _e746).x), _e662) <= min((min(min(max(_e731, _e742).x, max(_e736, _e744).x), max(_e741, _e746).x) + (max(max(_e741, _e746).x, -(min(_e741, _e746).x)) * 0.0000019073523f)), _e671.member.member_1)));
    phi_1818_ = select(0u, 4294967295u, (_e100 == 0u));
    phi_1820_ = (_e100 + 1u);
    loop {
        let _e770 = phi_1813_;
        let _e772 = phi_1816_;
        let _e774 = phi_1818_;
        let _e776 = phi_1820_;
        local_6 = _e770;
        let _e777 = (_e772 <= 2147483647u);
        if _e777 {
            phi_1829_ = _e772;
            phi_1832_ = _e774;
            phi_1834_ = _e776;
            loop {
                let _e779 = phi_1829_;
                let _e781 = phi_1832_;
                let _e783 = phi_1834_;
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
                        phi_1936_ = SlimbvhTypeK(_e793.z, _e818);
                        phi_1937_ = SlimbvhTypeK(_e793.y, _e813);
                    } else {
                        phi_1936_ = SlimbvhTypeK(_e793.y, _e813);
                        phi_1937_ = SlimbvhTypeK(_e793.z, _e818);
                    }
                    let _e829 = phi_1936_;
                    let _e831 = phi_1937_;
                    let _e835 = bitcast<f32>(((_e808 + ((_e793.w & 31u) << bitcast<u32>(23i))) ^ (_e681 << bitcast<u32>(31i))));
                    let _e875 = bitcast<f32>(_e799.x);
                    let _e880 = (_e875 + (f32((_e799.w >> bitcast<u32>(5u))) * _e147));
                    if (_e684 == 0u) {
                        phi_1996_ = SlimbvhTypeK(_e799.z, _e880);
                        phi_1997_ = SlimbvhTypeK(_e799.y, _e875);
                    } else {
                        phi_1996_ = SlimbvhTypeK(_e799.y, _e875);
                        phi_1997_ = SlimbvhTypeK(_e799.z, _e880);
                    }
                    let _e891 = phi_1996_;
                    let _e893 = phi_1997_;
                    let _e897 = bitcast<f32>(((_e808 + ((_e799.w & 31u) << bitcast<u32>(23i))) ^ (_e684 << bitcast<u32>(31i))));
                    let _e937 = bitcast<f32>(_e805.x);
                    let _e942 = (_e937 + (f32((_e805.w >> bitcast<u32>(5u))) * _e147));
                    if (_e687 == 0u) {
                        phi_2056_ = SlimbvhTypeK(_e805.z, _e942);
                        phi_2057_ = SlimbvhTypeK(_e805.y, _e937);
                    } else {
                        phi_2056_ = SlimbvhTypeK(_e805.y, _e937);
                        phi_2057_ = SlimbvhTypeK(_e805.z, _e942);
                    }
                    let _e953 = phi_2056_;
                    let _e955 = phi_2057_;
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
                        phi_2541_ = (((bitcast<u32>(_e1123) ^ select(0u, 4294967288u, _e671.member_1)) & 2147483640u) | 4u);
                    } else {
                        phi_2541_ = 4294967288u;
                    }
                    let _e1146 = phi_2541_;
                    if (_e1124 <= min((min(min(((f32(((_e829.member >> bitcast<u32>(8u)) & 255u)) * _e1011) + _e1018), ((f32(((_e891.member >> bitcast<u32>(8u)) & 255u)) * _e1043) + _e1050)), _e1088) + (max(_e1088, -(_e1072)) * 0.0000023841915f)), _e1131)) {
                        phi_2554_ = ((((bitcast<u32>(_e1124) ^ select(0u, 4294967288u, _e671.member_1)) & 2147483640u) | 4u) | 1u);
                    } else {
                        phi_2554_ = 4294967288u;
                    }
                    let _e1154 = phi_2554_;
                    if (_e1125 <= min((min(min(((f32(((_e829.member >> bitcast<u32>(16u)) & 255u)) * _e1011) + _e1018), ((f32(((_e891.member >> bitcast<u32>(16u)) & 255u)) * _e1043) + _e1050)), _e1089) + (max(_e1089, -(_e1073)) * 0.0000023841915f)), _e1131)) {
                        phi_2567_ = ((((bitcast<u32>(_e1125) ^ select(0u, 4294967288u, _e671.member_1)) & 2147483640u) | 4u) | 2u);
                    } else {
                        phi_2567_ = 4294967288u;
                    }
                    let _e1162 = phi_2567_;
                    if (_e1126 <= min((min(min(((f32(((_e829.member >> bitcast<u32>(24u)) & 255u)) * _e1011) + _e1018), ((f32(((_e891.member >> bitcast<u32>(24u)) & 255u)) * _e1043) + _e1050)), _e1090) + (max(_e1090, -(_e1074)) * 0.0000023841915f)), _e1131)) {
                        phi_2580_ = ((((bitcast<u32>(_e1126) ^ select(0u, 4294967288u, _e671.member_1)) & 2147483640u) | 4u) | 3u);
                    } else {
                        phi_2580_ = 4294967288u;
                    }
                    let _e1170 = phi_2580_;
                    if (_e1146 < _e1154) {
                        phi_4701_ = SlimbvhTypeD(_e1146, _e1154);
                    } else {
                        phi_4701_ = SlimbvhTypeD(_e1154, _e1146);
                    }
                    let _e1175 = phi_4701_;
                    if (_e1162 < _e1170) {
                        phi_4713_ = SlimbvhTypeD(_e1162, _e1170);
                    } else {
                        phi_4713_ = SlimbvhTypeD(_e1170, _e1162);
                    }
                    let _e1182 = phi_4713_;
                    if (_e1175.member < _e1182.member) {
                        phi_4725_ = SlimbvhTypeD(_e1175.member, _e1182.member);
                    } else {
                        phi_4725_ = SlimbvhTypeD(_e1182.member, _e1175.member);
                    }
                    let _e1189 = phi_4725_;
                    if (_e1175.member_1 < _e1182.member_1) {
                        phi_4737_ = SlimbvhTypeD(_e1175.member_1, _e1182.member_1);
                    } else {
                        phi_4737_ = SlimbvhTypeD(_e1182.member_1, _e1175.member_1);
                    }
                    let _e1196 = phi_4737_;
                    if (_e1196.member < _e1189.member_1) {
                        phi_4749_ = SlimbvhTypeD(_e1196.member, _e1189.member_1);
                    } else {
                        phi_4749_ = SlimbvhTypeD(_e1189.member_1, _e1196.member);
                    }
                    let _e1203 = phi_4749_;
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
                        phi_2666_ = select(_e779, _e1236, _e1245);
                        phi_2667_ = (((_e1239 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1240 & 3u) & 3u));
                    } else {
                        let _e1221 = (_e1218 >> bitcast<u32>(3u));
                        if (_e1221 == 0u) {
                            phi_2661_ = _e779;
                        } else {
                            local[(_e779 % 128u)] = ((_e781 << bitcast<u32>(9u)) | _e1221);
                            phi_2661_ = (_e779 + 1u);
                        }
                        let _e1230 = phi_2661_;
                        phi_2666_ = _e1230;
                        phi_2667_ = ((_e781 << bitcast<u32>(2i)) | ((_e1218 & 3u) & 3u));
                    }
                    let _e1260 = phi_2666_;
                    let _e1262 = phi_2667_;
                    let _e1264 = (_e1262 >> bitcast<u32>(2i));
                    if (_e1264 < _e100) {
                        let _e1270 = slimbvh_nodes.member[_e1264].member_1[(_e1262 & 3u)];
                        if ((_e1270 & 2147483648u) != 0u) {
                            phi_2697_ = (2147483648u | _e1262);
                        } else {
                            phi_2697_ = _e1270;
                        }
                        let _e1275 = phi_2697_;
                        phi_2698_ = _e1275;
                    } else {
                        phi_2698_ = 4294967295u;
                    }
                    let _e1277 = phi_2698_;
                    let _e1278 = (_e783 - 1u);
                    phi_1830_ = select(_e1260, 4294967295u, (_e1278 == 0u));
                    phi_1833_ = _e1277;
                    phi_1835_ = _e1278;
                } else {
                    phi_1830_ = u32();
                    phi_1833_ = u32();
                    phi_1835_ = u32();
                }
                let _e1282 = phi_1830_;
                let _e1284 = phi_1833_;
                let _e1286 = phi_1835_;
                continue;
                continuing {
                    phi_1829_ = _e1282;
                    phi_1832_ = _e1284;
                    phi_1834_ = _e1286;
                    break if !(_e787);
                }
            }
            let _e1289 = local_1;
            if _e1289 {
                let _e1291 = local_2;
                let _e1292 = (_e1291 & 2147483647u);
                let _e1294 = (_e1292 >> bitcast<u32>(2i));
                if (_e1294 >= _e100) {
                    phi_2912_ = SlimbvhTypeM(SlimbvhTypeL(vec4<f32>(0f, 0f, 0f, 0f), 0u), 0u, 0u);
                } else {
                    let _e1301 = slimbvh_nodes.member[_e1294].member[select(_e676, 2u, (2u < _e676))];
                    let _e1312 = slimbvh_nodes.member[_e1294].member[select(_e677, 2u, (2u < _e677))];
                    let _e1323 = slimbvh_nodes.member[_e1294].member[select(_e678, 2u, (2u < _e678))];
                    let _e1329 = (_e1292 & 3u);
                    let _e1332 = (((8u * _e1329) & 31u) & 31u);
                    let _e1340 = ((_e1301.w & 31u) & 31u);
                    let _e1342 = (((_e1301.y >> bitcast<u32>(_e1332)) & 255u) << bitcast<u32>(_e1340));
                    let _e1356 = ((_e1312.w & 31u) & 31u);
                    let _e1358 = (((_e1312.y >> bitcast<u32>(_e1332)) & 255u) << bitcast<u32>(_e1356));
                    let _e1372 = ((_e1323.w & 31u) & 31u);
                    let _e1374 = (((_e1323.y >> bitcast<u32>(_e1332)) & 255u) << bitcast<u32>(_e1372));
                    let _e1382 = (((((_e1301.w >> bitcast<u32>(5u)) - (((_e1301.z >> bitcast<u32>(_e1332)) & 255u) << bitcast<u32>(_e1340))) - _e1342) | (((_e1312.w >> bitcast<u32>(5u)) - (((_e1312.z >> bitcast<u32>(_e1332)) & 255u) << bitcast<u32>(_e1356))) - _e1358)) | (((_e1323.w >> bitcast<u32>(5u)) - (((_e1323.z >> bitcast<u32>(_e1332)) & 255u) << bitcast<u32>(_e1372))) - _e1374));
                    if (_e1382 < 1024u) {
                        phi_2848_ = 0u;
                    } else {
                        phi_2848_ = select(2u, 1u, (_e1382 < 2097152u));
                    }
                    let _e1387 = phi_2848_;
                    let _e1402 = slimbvh_nodes.member[_e1294].member_1[_e1329];
                    if ((_e1402 & 2147483648u) != 0u) {
                        phi_2909_ = ((_e1402 >> bitcast<u32>(28u)) & 7u);
                    } else {
                        phi_2909_ = 0u;
                    }
                    let _e1409 = phi_2909_;
                    phi_2912_ = SlimbvhTypeM(SlimbvhTypeL(vec4<f32>((bitcast<f32>(_e1301.x) + (f32(_e1342) * _e147)), (bitcast<f32>(_e1312.x) + (f32(_e1358) * _e147)), (bitcast<f32>(_e1323.x) + (f32(_e1374) * _e147)), 0f), _e1387), (_e1402 & 268435455u), _e1409);
                }
                let _e1413 = phi_2912_;
                phi_2916_ = _e770;
                phi_2919_ = SlimbvhTypeD(0u, _e1413.member_2);
                loop {
                    let _e1417 = phi_2916_;
                    let _e1419 = phi_2919_;
                    local_5 = _e1417;
                    local_7 = _e1417;
                    if (_e1419.member < _e1419.member_1) {
                        phi_2920_ = SlimbvhTypeD((_e1419.member + 1u), _e1419.member_1);
                        phi_2942_ = SlimbvhTypeD(1u, _e1419.member);
                    } else {
                        phi_2920_ = _e1419;
                        phi_2942_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                    }
                    let _e1432 = phi_2920_;
                    let _e1434 = phi_2942_;
                    let _e1438 = (bitcast<i32>(_e1434.member) != 0i);
                    if _e1438 {
                        switch bitcast<i32>(_e1413.member.member_1) {
                            case 0: {
                                phi_2960_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_2960_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_2960_ = 3u;
                                break;
                            }
                            default: {
                                phi_2960_ = u32();
                                break;
                            }
                        }
                        let _e1444 = phi_2960_;
                        switch bitcast<i32>(_e1413.member.member_1) {
                            case 0: {
                                phi_2971_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_2971_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_2971_ = 3u;
                                break;
                            }
                            default: {
                                phi_2971_ = u32();
                                break;
                            }
                        }
                        let _e1451 = phi_2971_;
                        let _e1453 = ((_e1413.member_1 + (_e1434.member_1 * ((3u * _e1444) + 1u))) + (3u * _e1451));
                        if (_e1453 < _e103) {
                            let _e1456 = slimbvh_triangles.member[_e1453];
                            phi_2987_ = _e1456;
                        } else {
                            phi_2987_ = 4294967295u;
                        }
                        let _e1458 = phi_2987_;
                        switch bitcast<i32>(_e1413.member.member_1) {
                            case 0: {
                                phi_3000_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_3000_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_3000_ = 3u;
                                break;
                            }
                            default: {
                                phi_3000_ = u32();
                                break;
                            }
                        }
                        let _e1461 = phi_3000_;
                        let _e1465 = (_e1413.member_1 + (_e1434.member_1 * ((3u * _e1461) + 1u)));
                        switch bitcast<i32>(_e1413.member.member_1) {
                            case 0: {
                                phi_3011_ = 1u;
                                break;
                            }
                            case 1: {
                                phi_3011_ = 2u;
                                break;
                            }
                            case 2: {
                                phi_3011_ = 3u;
                                break;
                            }
                            default: {
                                phi_3011_ = u32();
                                break;
                            }
                        }
                        let _e1468 = phi_3011_;
                        let _e1469 = (_e1465 + _e1468);
                        let _e1471 = (_e1465 + (2u * _e1468));
                        switch bitcast<i32>(_e1413.member.member_1) {
                            case 0: {
                                if (_e1465 < _e103) {
                                    let _e1748 = slimbvh_triangles.member[_e1465];
                                    phi_3038_ = _e1748;
                                } else {
                                    phi_3038_ = 0u;
                                }
                                let _e1750 = phi_3038_;
                                let _e1753 = ((10u * _e207) & 31u);
                                let _e1764 = ((10u * _e211) & 31u);
                                let _e1775 = ((10u * _e203) & 31u);
                                if (_e1469 < _e103) {
                                    let _e1787 = slimbvh_triangles.member[_e1469];
                                    phi_3084_ = _e1787;
                                } else {
                                    phi_3084_ = 0u;
                                }
                                let _e1789 = phi_3084_;
                                if (_e1471 < _e103) {
                                    let _e1817 = slimbvh_triangles.member[_e1471];
                                    phi_3130_ = _e1817;
                                } else {
                                    phi_3130_ = 0u;
                                }
                                let _e1819 = phi_3130_;
                                phi_3597_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1413.member.member.x + ((bitcast<f32>((1258291200u | ((_e1750 >> bitcast<u32>(_e1753)) & 1023u))) - 8388608f) * _e147)), (_e1413.member.member.y + ((bitcast<f32>((1258291200u | ((_e1750 >> bitcast<u32>(_e1764)) & 1023u))) - 8388608f) * _e147)), (_e1413.member.member.z + ((bitcast<f32>((1258291200u | ((_e1750 >> bitcast<u32>(_e1775)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e1413.member.member.x + ((bitcast<f32>((1258291200u | ((_e1789 >> bitcast<u32>(_e1753)) & 1023u))) - 8388608f) * _e147)), (_e1413.member.member.y + ((bitcast<f32>((1258291200u | ((_e1789 >> bitcast<u32>(_e1764)) & 1023u))) - 8388608f) * _e147)), (_e1413.member.member.z + ((bitcast<f32>((1258291200u | ((_e1789 >> bitcast<u32>(_e1775)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e1413.member.member.x + ((bitcast<f32>((1258291200u | ((_e1819 >> bitcast<u32>(_e1753)) & 1023u))) - 8388608f) * _e147)), (_e1413.member.member.y + ((bitcast<f32>((1258291200u | ((_e1819 >> bitcast<u32>(_e1764)) & 1023u))) - 8388608f) * _e147)), (_e1413.member.member.z + ((bitcast<f32>((1258291200u | ((_e1819 >> bitcast<u32>(_e1775)) & 1023u))) - 8388608f) * _e147))));
                                break;
                            }
                            case 1: {
                                if (_e1465 < _e103) {
                                    let _e1561 = slimbvh_triangles.member[_e1465];
                                    phi_3177_ = _e1561;
                                } else {
                                    phi_3177_ = 0u;
                                }
                                let _e1563 = phi_3177_;
                                let _e1564 = (_e1465 + 1u);
                                if (_e1564 < _e103) {
                                    let _e1567 = slimbvh_triangles.member[_e1564];
                                    phi_3190_ = _e1567;
                                } else {
                                    phi_3190_ = 0u;
                                }
                                let _e1569 = phi_3190_;
                                let _e1571 = (_e207 == 1u);
                                if _e1571 {
                                    phi_3200_ = ((_e1563 >> bitcast<u32>(21i)) | (_e1569 << bitcast<u32>(11i)));
                                } else {
                                    phi_3200_ = (_e1569 >> bitcast<u32>(10i));
                                }
                                let _e1580 = phi_3200_;
                                let _e1589 = (_e211 == 1u);
                                if _e1589 {
                                    phi_3221_ = ((_e1563 >> bitcast<u32>(21i)) | (_e1569 << bitcast<u32>(11i)));
                                } else {
                                    phi_3221_ = (_e1569 >> bitcast<u32>(10i));
                                }
                                let _e1598 = phi_3221_;
                                let _e1607 = (_e203 == 1u);
                                if _e1607 {
                                    phi_3242_ = ((_e1563 >> bitcast<u32>(21i)) | (_e1569 << bitcast<u32>(11i)));
                                } else {
                                    phi_3242_ = (_e1569 >> bitcast<u32>(10i));
                                }
                                let _e1616 = phi_3242_;
                                if (_e1469 < _e103) {
                                    let _e1627 = slimbvh_triangles.member[_e1469];
                                    phi_3269_ = _e1627;
                                } else {
                                    phi_3269_ = 0u;
                                }
                                let _e1629 = phi_3269_;
                                let _e1630 = (_e1469 + 1u);
                                if (_e1630 < _e103) {
                                    let _e1633 = slimbvh_triangles.member[_e1630];
                                    phi_3282_ = _e1633;
                                } else {
                                    phi_3282_ = 0u;
                                }
                                let _e1635 = phi_3282_;
                                if _e1571 {
                                    phi_3292_ = ((_e1629 >> bitcast<u32>(21i)) | (_e1635 << bitcast<u32>(11i)));
                                } else {
                                    phi_3292_ = (_e1635 >> bitcast<u32>(10i));
                                }
                                let _e1644 = phi_3292_;
                                if _e1589 {
                                    phi_3313_ = ((_e1629 >> bitcast<u32>(21i)) | (_e1635 << bitcast<u32>(11i)));
                                } else {
                                    phi_3313_ = (_e1635 >> bitcast<u32>(10i));
                                }
                                let _e1660 = phi_3313_;
                                if _e1607 {
                                    phi_3334_ = ((_e1629 >> bitcast<u32>(21i)) | (_e1635 << bitcast<u32>(11i)));
                                } else {
                                    phi_3334_ = (_e1635 >> bitcast<u32>(10i));
                                }
                                let _e1676 = phi_3334_;
                                if (_e1471 < _e103) {
                                    let _e1687 = slimbvh_triangles.member[_e1471];
                                    phi_3361_ = _e1687;
                                } else {
                                    phi_3361_ = 0u;
                                }
                                let _e1689 = phi_3361_;
                                let _e1690 = (_e1471 + 1u);
                                if (_e1690 < _e103) {
                                    let _e1693 = slimbvh_triangles.member[_e1690];
                                    phi_3374_ = _e1693;
                                } else {
                                    phi_3374_ = 0u;
                                }
                                let _e1695 = phi_3374_;
                                if _e1571 {
                                    phi_3384_ = ((_e1689 >> bitcast<u32>(21i)) | (_e1695 << bitcast<u32>(11i)));
                                } else {
                                    phi_3384_ = (_e1695 >> bitcast<u32>(10i));
                                }
                                let _e1704 = phi_3384_;
                                if _e1589 {
                                    phi_3405_ = ((_e1689 >> bitcast<u32>(21i)) | (_e1695 << bitcast<u32>(11i)));
                                } else {
                                    phi_3405_ = (_e1695 >> bitcast<u32>(10i));
                                }
                                let _e1720 = phi_3405_;
                                if _e1607 {
                                    phi_3426_ = ((_e1689 >> bitcast<u32>(21i)) | (_e1695 << bitcast<u32>(11i)));
                                } else {
                                    phi_3426_ = (_e1695 >> bitcast<u32>(10i));
                                }
                                let _e1736 = phi_3426_;
                                phi_3597_ = array<array<f32, 3>, 3>(array<f32, 3>((_e1413.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1580, _e1563, _e212) & 2097151u))) - 8388608f) * _e147)), (_e1413.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1598, _e1563, _e215) & 2097151u))) - 8388608f) * _e147)), (_e1413.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1616, _e1563, _e219) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e1413.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1644, _e1629, _e212) & 2097151u))) - 8388608f) * _e147)), (_e1413.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1660, _e1629, _e215) & 2097151u))) - 8388608f) * _e147)), (_e1413.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1676, _e1629, _e219) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e1413.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1704, _e1689, _e212) & 2097151u))) - 8388608f) * _e147)), (_e1413.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1720, _e1689, _e215) & 2097151u))) - 8388608f) * _e147)), (_e1413.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1736, _e1689, _e219) & 2097151u))) - 8388608f) * _e147))));
                                break;
                            }
                            case 2: {
                                let _e1474 = (_e1465 + _e207);
                                if (_e1474 < _e103) {
                                    let _e1477 = slimbvh_triangles.member[_e1474];
                                    phi_3455_ = _e1477;
                                } else {
                                    phi_3455_ = 0u;
                                }
                                let _e1479 = phi_3455_;
                                let _e1480 = (_e1465 + _e211);
                                if (_e1480 < _e103) {
                                    let _e1483 = slimbvh_triangles.member[_e1480];
                                    phi_3468_ = _e1483;
                                } else {
                                    phi_3468_ = 0u;
                                }
                                let _e1485 = phi_3468_;
                                let _e1486 = (_e1465 + _e203);
                                if (_e1486 < _e103) {
                                    let _e1489 = slimbvh_triangles.member[_e1486];
                                    phi_3481_ = _e1489;
                                } else {
                                    phi_3481_ = 0u;
                                }
                                let _e1491 = phi_3481_;
                                let _e1502 = (_e1469 + _e207);
                                if (_e1502 < _e103) {
                                    let _e1505 = slimbvh_triangles.member[_e1502];
                                    phi_3507_ = _e1505;
                                } else {
                                    phi_3507_ = 0u;
                                }
                                let _e1507 = phi_3507_;
                                let _e1508 = (_e1469 + _e211);
                                if (_e1508 < _e103) {
                                    let _e1511 = slimbvh_triangles.member[_e1508];
                                    phi_3520_ = _e1511;
                                } else {
                                    phi_3520_ = 0u;
                                }
                                let _e1513 = phi_3520_;
                                let _e1514 = (_e1469 + _e203);
                                if (_e1514 < _e103) {
                                    let _e1517 = slimbvh_triangles.member[_e1514];
                                    phi_3533_ = _e1517;
                                } else {
                                    phi_3533_ = 0u;
                                }
                                let _e1519 = phi_3533_;
                                let _e1530 = (_e1471 + _e207);
                                if (_e1530 < _e103) {
                                    let _e1533 = slimbvh_triangles.member[_e1530];
                                    phi_3559_ = _e1533;
                                } else {
                                    phi_3559_ = 0u;
                                }
                                let _e1535 = phi_3559_;
                                let _e1536 = (_e1471 + _e211);
                                if (_e1536 < _e103) {
                                    let _e1539 = slimbvh_triangles.member[_e1536];
                                    phi_3572_ = _e1539;
                                } else {
                                    phi_3572_ = 0u;
                                }
                                let _e1541 = phi_3572_;
                                let _e1542 = (_e1471 + _e203);
                                if (_e1542 < _e103) {
                                    let _e1545 = slimbvh_triangles.member[_e1542];
                                    phi_3585_ = _e1545;
                                } else {
                                    phi_3585_ = 0u;
                                }
                                let _e1547 = phi_3585_;
                                phi_3597_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1479)) * _e147), (f32(bitcast<i32>(_e1485)) * _e147), (f32(bitcast<i32>(_e1491)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1507)) * _e147), (f32(bitcast<i32>(_e1513)) * _e147), (f32(bitcast<i32>(_e1519)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1535)) * _e147), (f32(bitcast<i32>(_e1541)) * _e147), (f32(bitcast<i32>(_e1547)) * _e147)));
                                break;
                            }
                            default: {
                                phi_3597_ = array<array<f32, 3>, 3>();
                                break;
                            }
                        }
                        let _e1847 = phi_3597_;
                        let _e1864 = (_e1847[0][2] - _e595.member[2]);
                        let _e1867 = (((_e1847[0][0] - _e595.member[0]) * _e650) - (_e1864 * _e618));
                        let _e1870 = (((_e1847[0][1] - _e595.member[1]) * _e650) - (_e1864 * _e634));
                        let _e1873 = (_e1847[1][2] - _e595.member[2]);
                        let _e1876 = (((_e1847[1][0] - _e595.member[0]) * _e650) - (_e1873 * _e618));
                        let _e1879 = (((_e1847[1][1] - _e595.member[1]) * _e650) - (_e1873 * _e634));
                        let _e1882 = (_e1847[2][2] - _e595.member[2]);
                        let _e1885 = (((_e1847[2][0] - _e595.member[0]) * _e650) - (_e1882 * _e618));
                        let _e1888 = (((_e1847[2][1] - _e595.member[1]) * _e650) - (_e1882 * _e634));
                        let _e1889 = (_e1885 * _e1879);
                        let _e1890 = (_e1888 * _e1876);
                        let _e1891 = (_e1867 * _e1888);
                        let _e1892 = (_e1870 * _e1885);
                        let _e1893 = (_e1876 * _e1870);
                        let _e1894 = (_e1879 * _e1867);
                        let _e1899 = (((_e1889 >= _e1890) && (_e1891 >= _e1892)) && (_e1893 >= _e1894));
                        let _e1905 = (_e1899 || (((_e1889 <= _e1890) && (_e1891 <= _e1892)) && (_e1893 <= _e1894)));
                        if _e1905 {
                            let _e1907 = select(-1f, 1f, _e1899);
                            let _e1909 = ((_e1889 - _e1890) * _e1907);
                            let _e1911 = select(0f, _e1909, (_e1909 > 0f));
                            let _e1913 = ((_e1891 - _e1892) * _e1907);
                            let _e1915 = select(0f, _e1913, (_e1913 > 0f));
                            let _e1917 = ((_e1893 - _e1894) * _e1907);
                            let _e1919 = select(0f, _e1917, (_e1917 > 0f));
                            let _e1921 = ((_e1911 + _e1915) + _e1919);
                            let _e1936 = ((min(min(_e1847[0][0], _e1847[1][0]), _e1847[2][0]) - _e619) * _e622);
                            let _e1937 = ((max(max(_e1847[0][0], _e1847[1][0]), _e1847[2][0]) - _e620) * _e622);
                            let _e1938 = vec4<f32>(_e1936, f32(), _e1937, f32());
                            let _e1941 = ((min(min(_e1847[0][1], _e1847[1][1]), _e1847[2][1]) - _e635) * _e638);
                            let _e1942 = ((max(max(_e1847[0][1], _e1847[1][1]), _e1847[2][1]) - _e636) * _e638);
                            let _e1943 = vec4<f32>(_e1941, f32(), _e1942, f32());
                            let _e1946 = ((min(min(_e1847[0][2], _e1847[1][2]), _e1847[2][2]) - _e651) * _e654);
                            let _e1947 = ((max(max(_e1847[0][2], _e1847[1][2]), _e1847[2][2]) - _e652) * _e654);
                            let _e1948 = vec4<f32>(_e1946, f32(), _e1947, f32());
                            let _e1949 = vec4<f32>(_e1937, f32(), _e1936, f32());
                            let _e1951 = vec4<f32>(_e1942, f32(), _e1941, f32());
                            let _e1953 = vec4<f32>(_e1947, f32(), _e1946, f32());
                            let _e1962 = max(max(min(_e1938, _e1949).x, min(_e1943, _e1951).x), min(_e1948, _e1953).x);
                            let _e1967 = min(min(max(_e1938, _e1949).x, max(_e1943, _e1951).x), max(_e1948, _e1953).x);
                            let _e1972 = max(_e1962, _e662);
                            let _e1994 = (((((_e1905 && (_e1921 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1867, _e1876), _e1885) <= 0f) && (max(max(_e1867, _e1876), _e1885) >= 0f))) && ((min(min(_e1870, _e1879), _e1888) <= 0f) && (max(max(_e1870, _e1879), _e1888) >= 0f))) && (_e1972 <= (_e1967 + (max(max(_e1948, _e1953).x, -(min(_e1948, _e1953).x)) * 0.0000019073523f)))) && (_e1972 <= _e1417.member.member_1));
                            if _e1994 {
                                let _e1999 = (_e1847[1][0] - _e1847[0][0]);
                                let _e2000 = (_e1847[1][1] - _e1847[0][1]);
                                let _e2001 = (_e1847[1][2] - _e1847[0][2]);
                                let _e2002 = vec3<f32>(_e1999, _e2000, _e2001);
                                let _e2003 = (_e1847[2][0] - _e1847[1][0]);
                                let _e2004 = (_e1847[2][1] - _e1847[1][1]);
                                let _e2005 = (_e1847[2][2] - _e1847[1][2]);
                                let _e2006 = vec3<f32>(_e2003, _e2004, _e2005);
                                let _e2007 = (_e1847[0][0] - _e1847[2][0]);
                                let _e2008 = (_e1847[0][1] - _e1847[2][1]);
                                let _e2009 = (_e1847[0][2] - _e1847[2][2]);
                                let _e2010 = vec3<f32>(_e2007, _e2008, _e2009);
                                let _e2021 = max(max(bitcast<f32>((bitcast<u32>(_e1999) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2000) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2001) & 2147483647u)));
                                let _e2032 = max(max(bitcast<f32>((bitcast<u32>(_e2003) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2004) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2005) & 2147483647u)));
                                let _e2045 = max(max(_e2021, _e2032), max(max(bitcast<f32>((bitcast<u32>(_e2007) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2008) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2009) & 2147483647u))));
                                if (_e2021 == _e2045) {
                                    phi_3962_ = _e1879;
                                    phi_3963_ = _e1876;
                                    phi_3964_ = _e1870;
                                    phi_3965_ = _e1867;
                                    phi_3966_ = vec3<f32>(_e1847[0][0], _e1847[0][1], _e1847[0][2]);
                                    phi_3967_ = _e2010;
                                    phi_3968_ = _e2006;
                                    phi_3969_ = _e2002;
                                } else {
                                    let _e2047 = (_e2032 == _e2045);
                                    let _e2052 = vec3(_e2047);
                                    phi_3962_ = select(_e1870, _e1888, _e2047);
                                    phi_3963_ = select(_e1867, _e1885, _e2047);
                                    phi_3964_ = select(_e1888, _e1879, _e2047);
                                    phi_3965_ = select(_e1885, _e1876, _e2047);
                                    phi_3966_ = select(vec3<f32>(_e1847[2][0], _e1847[2][1], _e1847[2][2]), vec3<f32>(_e1847[1][0], _e1847[1][1], _e1847[1][2]), _e2052);
                                    phi_3967_ = select(_e2006, _e2002, _e2052);
                                    phi_3968_ = select(_e2002, _e2010, _e2052);
                                    phi_3969_ = select(_e2010, _e2006, _e2052);
                                }
                                let _e2058 = phi_3962_;
                                let _e2060 = phi_3963_;
                                let _e2062 = phi_3964_;
                                let _e2064 = phi_3965_;
                                let _e2066 = phi_3966_;
                                let _e2068 = phi_3967_;
                                let _e2070 = phi_3968_;
                                let _e2072 = phi_3969_;
                                let _e2079 = ((_e2070.y * _e2068.z) - (_e2068.y * _e2070.z));
                                let _e2084 = ((_e2070.z * _e2068.x) - (_e2068.z * _e2070.x));
                                let _e2087 = ((_e2070.x * _e2068.y) - (_e2068.x * _e2070.y));
                                let _e2090 = ((_e1911 >= _e1915) && (_e1911 >= _e1919));
                                let _e2091 = (_e1915 >= _e1919);
                                let _e2105 = (((_e2079 * (select(select(_e1847[2][0], _e1847[1][0], _e2091), _e1847[0][0], _e2090) - _e595.member[0])) + (_e2084 * (select(select(_e1847[2][1], _e1847[1][1], _e2091), _e1847[0][1], _e2090) - _e595.member[1]))) + (_e2087 * (select(select(_e1847[2][2], _e1847[1][2], _e2091), _e1847[0][2], _e2090) - _e595.member[2])));
                                let _e2110 = (((_e2079 * _e618) + (_e2084 * _e634)) + (_e2087 * _e650));
                                let _e2111 = (_e2060 - _e2064);
                                let _e2112 = (_e2058 - _e2062);
                                let _e2115 = ((_e2111 * _e2111) + (_e2112 * _e2112));
                                let _e2122 = (-(((_e2064 * _e2111) + (_e2062 * _e2112))) / select(0.000000000000000000000000000000000000011754944f, _e2115, (_e2115 > 0.000000000000000000000000000000000000011754944f)));
                                let _e2124 = select(1f, _e2122, (_e2122 < 1f));
                                let _e2126 = select(0f, _e2124, (_e2124 > 0f));
                                let _e2135 = ((_e2066.x + (_e2072.x * _e2126)) - _e595.member[0]);
                                let _e2138 = ((_e2066.y + (_e2072.y * _e2126)) - _e595.member[1]);
                                let _e2141 = ((_e2066.z + (_e2072.z * _e2126)) - _e595.member[2]);
                                let _e2206 = ((bitcast<f32>((bitcast<u32>(((((_e2079 * _e2135) + (_e2084 * _e2138)) + (_e2087 * _e2141)) - _e2105)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e2135) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2138) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2141) & 2147483647u))), _e2045)) * max(max(bitcast<f32>((bitcast<u32>(_e2079) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2084) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2087) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e2110) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e2070.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2070.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2070.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e2068.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e2068.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e2068.z) & 2147483647u)))))));
                                let _e2207 = (_e2105 / _e2110);
                                if (_e1994 && !(_e2206)) {
                                    let _e2210 = (_e2141 / _e650);
                                    let _e2218 = (((_e2079 * (_e2135 - (_e618 * _e2210))) + (_e2084 * (_e2138 - (_e634 * _e2210)))) / _e2110);
                                    phi_4148_ = select(select(_e2210, (_e2210 + _e2218), (bitcast<f32>((bitcast<u32>(_e2218) & 2147483647u)) <= _e2045)), _e2207, _e2206);
                                } else {
                                    phi_4148_ = _e2207;
                                }
                                let _e2227 = phi_4148_;
                                let _e2229 = select(_e1967, _e2227, (_e2227 < _e1967));
                                let _e2231 = select(_e1962, _e2229, (_e2229 > _e1962));
                                let _e2234 = select(_e2231, 0f, (bitcast<u32>(_e2231) == 2147483648u));
                                let _e2235 = (1f / _e1921);
                                phi_4174_ = SlimbvhTypeE(_e2234, (_e1915 * _e2235), (_e1919 * _e2235), ((_e1994 && (_e2234 >= _e662)) && (_e2234 <= _e1417.member.member_1)));
                                phi_4175_ = SlimbvhTypeE();
                            } else {
                                phi_4174_ = SlimbvhTypeE();
                                phi_4175_ = SlimbvhTypeE(0f, 0f, 0f, _e1994);
                            }
                            let _e2244 = phi_4174_;
                            let _e2246 = phi_4175_;
                            phi_4178_ = _e2244;
                            phi_4179_ = _e2246;
                            phi_4180_ = select(true, false, _e1994);
                        } else {
                            phi_4178_ = SlimbvhTypeE();
                            phi_4179_ = SlimbvhTypeE(0f, 0f, 0f, _e1905);
                            phi_4180_ = true;
                        }
                        let _e2249 = phi_4178_;
                        let _e2251 = phi_4179_;
                        let _e2253 = phi_4180_;
                        if _e2253 {
                            phi_4184_ = _e2251;
                        } else {
                            phi_4184_ = _e2249;
                        }
                        let _e2255 = phi_4184_;
                        if _e2255.member_3 {
                            phi_4193_ = SlimbvhTypeF(_e2255.member, _e2255.member_1, _e2255.member_2, _e1458);
                        } else {
                            phi_4193_ = _e96;
                        }
                        let _e2262 = phi_4193_;
                        if (_e2262.member_3 != 4294967295u) {
                            if (_e1458 != 4294967295u) {
                                if (_e2262.member < _e1417.member.member.member) {
                                    phi_4221_ = true;
                                } else {
                                    if (_e2262.member == _e1417.member.member.member) {
                                        phi_4220_ = (_e2262.member_3 < _e1417.member.member.member_3);
                                    } else {
                                        phi_4220_ = false;
                                    }
                                    let _e2277 = phi_4220_;
                                    phi_4221_ = _e2277;
                                }
                                let _e2279 = phi_4221_;
                                if _e2279 {
                                    phi_4228_ = SlimbvhTypeP(SlimbvhTypeH(_e2262, _e2262.member), _e1417.member_1);
                                } else {
                                    phi_4228_ = _e1417;
                                }
                                let _e2285 = phi_4228_;
                                if _e2285.member_1 {
                                    phi_4234_ = SlimbvhTypeP(SlimbvhTypeH(_e2285.member.member, bitcast<f32>(4286578687u)), _e2285.member_1);
                                } else {
                                    phi_4234_ = _e2285;
                                }
                                let _e2294 = phi_4234_;
                                phi_4235_ = _e2294;
                            } else {
                                phi_4235_ = _e1417;
                            }
                            let _e2296 = phi_4235_;
                            phi_4236_ = _e2296;
                        } else {
                            phi_4236_ = _e1417;
                        }
                        let _e2298 = phi_4236_;
                        phi_2917_ = _e2298;
                    } else {
                        phi_2917_ = SlimbvhTypeP();
                    }
                    let _e2300 = phi_2917_;
                    continue;
                    continuing {
                        phi_2916_ = _e2300;
                        phi_2919_ = _e1432;
                        break if !(_e1438);
                    }
                }
                let _e2303 = local_3;
                let _e2304 = (_e2303 - 1u);
                let _e2307 = local[(_e2304 % 128u)];
                let _e2308 = (_e2307 & 511u);
                let _e2310 = (_e2308 >> bitcast<u32>(3u));
                let _e2313 = ((_e2310 == 0u) || (_e2304 == 4294967295u));
                if _e2313 {
                } else {
                    local[(_e2304 % 128u)] = (((_e2307 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e2310);
                }
                let _e2320 = local_4;
                let _e2328 = (((_e2307 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e2308 & 3u) & 3u));
                let _e2330 = (_e2328 >> bitcast<u32>(2i));
                if (_e2330 < _e100) {
                    let _e2336 = slimbvh_nodes.member[_e2330].member_1[(_e2328 & 3u)];
                    if ((_e2336 & 2147483648u) != 0u) {
                        phi_4301_ = (2147483648u | _e2328);
                    } else {
                        phi_4301_ = _e2336;
                    }
                    let _e2341 = phi_4301_;
                    phi_4302_ = _e2341;
                } else {
                    phi_4302_ = 4294967295u;
                }
                let _e2343 = phi_4302_;
                let _e2345 = local_5;
                let _e2631 = local_7;
                phi_4311_ = _e2631;
                phi_4312_ = select(select(_e2320, _e2304, _e2313), 4294967295u, (_e662 > _e2345.member.member_1));
                phi_4313_ = _e2343;
            } else {
                phi_4311_ = _e770;
                let _e2634 = local_8;
                phi_4312_ = _e2634;
                let _e2637 = local_9;
                phi_4313_ = _e2637;
            }
            let _e2351 = phi_4311_;
            let _e2353 = phi_4312_;
            let _e2355 = phi_4313_;
            phi_1814_ = _e2351;
            phi_1817_ = _e2353;
            phi_1819_ = _e2355;
            let _e2643 = local_10;
            phi_1821_ = _e2643;
        } else {
            phi_1814_ = SlimbvhTypeP();
            phi_1817_ = u32();
            phi_1819_ = u32();
            phi_1821_ = u32();
        }
        let _e2357 = phi_1814_;
        let _e2359 = phi_1817_;
        let _e2361 = phi_1819_;
        let _e2363 = phi_1821_;
        continue;
        continuing {
            phi_1813_ = _e2357;
            phi_1816_ = _e2359;
            phi_1818_ = _e2361;
            phi_1820_ = _e2363;
            break if !(_e777);
        }
    }
    let _e2366 = local_6;
    if (_e2366.member.member.member_3 != 4294967295u) {
        let _e2372 = -((_e165 + _e595.member_4));
        let _e2373 = bitcast<u32>(_e2366.member.member.member);
        let _e2377 = (bitcast<i32>((_e2373 >> bitcast<u32>(23i))) & 255i);
        let _e2378 = (_e2377 + _e2372);
        if (_e2377 == 255i) {
            phi_4370_ = _e2366.member.member.member;
        } else {
            if (_e2377 > 0i) {
                if (_e2378 > 0i) {
                    let _e2382 = (_e2378 < 255i);
                    if _e2382 {
                        phi_4349_ = bitcast<f32>((_e2373 + bitcast<u32>((_e2372 << bitcast<u32>(23i)))));
                    } else {
                        phi_4349_ = f32();
                    }
                    let _e2389 = phi_4349_;
                    phi_4351_ = _e2389;
                    phi_4352_ = select(true, false, _e2382);
                } else {
                    phi_4351_ = f32();
                    phi_4352_ = true;
                }
                let _e2392 = phi_4351_;
                let _e2394 = phi_4352_;
                phi_4353_ = _e2392;
                phi_4354_ = _e2394;
            } else {
                phi_4353_ = f32();
                phi_4354_ = true;
            }
            let _e2396 = phi_4353_;
            let _e2398 = phi_4354_;
            if _e2398 {
                let _e2399 = (_e2373 & 2147483648u);
                let _e2406 = ((_e2373 & 8388607u) | (select(0u, 1u, ((_e2373 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e2410 = (_e2406 == 0u);
                if _e2410 {
                    phi_5030_ = bitcast<f32>(_e2399);
                } else {
                    let _e2415 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2406)), 32u, _e2410) - 8u);
                    let _e2418 = (_e2406 << bitcast<u32>((_e2415 & 31u)));
                    let _e2420 = ((_e2378 + select(0i, 1i, (_e2377 == 0i))) - bitcast<i32>(_e2415));
                    if (_e2420 >= 255i) {
                        phi_5020_ = bitcast<f32>((_e2399 | 2139095040u));
                        phi_5021_ = f32();
                        phi_5022_ = true;
                    } else {
                        let _e2422 = (_e2420 > 0i);
                        if _e2422 {
                            phi_5014_ = bitcast<f32>(((_e2399 | (bitcast<u32>(_e2420) << bitcast<u32>(23i))) | (_e2418 & 8388607u)));
                            phi_5015_ = f32();
                        } else {
                            if (_e2420 < -24i) {
                                phi_4980_ = 26u;
                            } else {
                                phi_4980_ = bitcast<u32>((1i - _e2420));
                            }
                            let _e2427 = phi_4980_;
                            let _e2428 = (_e2427 & 31u);
                            let _e2430 = (_e2418 >> bitcast<u32>(_e2428));
                            let _e2434 = (_e2418 & ((1u << bitcast<u32>(_e2428)) - 1u));
                            let _e2438 = (1u << bitcast<u32>(((_e2427 - 1u) & 31u)));
                            if (_e2434 > _e2438) {
                                phi_5001_ = true;
                            } else {
                                if (_e2434 == _e2438) {
                                    phi_4998_ = ((_e2430 & 1u) == 1u);
                                } else {
                                    phi_4998_ = false;
                                }
                                let _e2444 = phi_4998_;
                                phi_5001_ = _e2444;
                            }
                            let _e2446 = phi_5001_;
                            phi_5014_ = f32();
                            phi_5015_ = bitcast<f32>((_e2399 | (_e2430 + select(0u, 1u, _e2446))));
                        }
                        let _e2459 = phi_5014_;
                        let _e2461 = phi_5015_;
                        phi_5020_ = _e2459;
                        phi_5021_ = _e2461;
                        phi_5022_ = _e2422;
                    }
                    let _e2465 = phi_5020_;
                    let _e2467 = phi_5021_;
                    let _e2469 = phi_5022_;
                    phi_5030_ = select(_e2467, _e2465, _e2469);
                }
                let _e2473 = phi_5030_;
                phi_4369_ = _e2473;
            } else {
                phi_4369_ = _e2396;
            }
            let _e2475 = phi_4369_;
            phi_4370_ = _e2475;
        }
        let _e2477 = phi_4370_;
        let _e2478 = bitcast<u32>(_e2477);
        if ((_e2478 & 2147483647u) >= 2139095040u) {
            phi_4382_ = bitcast<f32>(((_e2478 & 2147483648u) | 2139095039u));
        } else {
            phi_4382_ = _e2477;
        }
        let _e2485 = phi_4382_;
        phi_4387_ = SlimbvhTypeF(_e2485, _e2366.member.member.member_1, _e2366.member.member.member_2, _e2366.member.member.member_3);
    } else {
        phi_4387_ = _e96;
    }
    let _e2490 = phi_4387_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2490.member), bitcast<u32>(_e2490.member_1), bitcast<u32>(_e2490.member_2), _e2490.member_3);
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
