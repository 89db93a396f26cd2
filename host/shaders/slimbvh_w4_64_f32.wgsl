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
    member: array<array<vec4<f32>, 5>>,
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
}

struct SlimbvhTypeM {
    member: u32,
}

struct SlimbvhTypeN {
    member: SlimbvhTypeH,
    member_1: bool,
}

@group(0) @binding(0) 
var<uniform> slimbvh_exponent: SlimbvhTypeA;

@group(0) @binding(2) 
var<storage> slimbvh_triangles: SlimbvhTypeB;

@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeJ;

@group(0) @binding(3) 
var<uniform> slimbvh_root: SlimbvhTypeG;

var<private> slimbvh_origin: SlimbvhTypeL;

var<private> slimbvh_direction: SlimbvhTypeL;

var<private> slimbvh_any_will_do: SlimbvhTypeM;

var<private> slimbvh_hit: SlimbvhTypeA;

fn slimbvh_trace() {
    var local: array<u32, 128>;
    var phi_676_: u32;
    var phi_682_: u32;
    var phi_688_: u32;
    var phi_953_: i32;
    var phi_964_: i32;
    var phi_1078_: i32;
    var phi_1207_: i32;
    var phi_1229_: u32;
    var phi_1230_: u32;
    var phi_1231_: bool;
    var phi_1265_: i32;
    var phi_1287_: u32;
    var phi_1288_: u32;
    var phi_1289_: bool;
    var phi_850_: i32;
    var phi_856_: u32;
    var phi_875_: u32;
    var phi_876_: u32;
    var phi_877_: bool;
    var phi_895_: i32;
    var phi_901_: u32;
    var phi_920_: u32;
    var phi_921_: u32;
    var phi_922_: bool;
    var phi_1299_: SlimbvhTypeC;
    var phi_1528_: SlimbvhTypeN;
    var phi_1585_: array<f32, 3>;
    var phi_1586_: array<f32, 3>;
    var phi_1604_: array<f32, 3>;
    var phi_1605_: array<f32, 3>;
    var phi_1778_: SlimbvhTypeN;
    var phi_1781_: u32;
    var phi_1783_: u32;
    var phi_1785_: u32;
    var phi_1794_: u32;
    var phi_1797_: u32;
    var phi_1799_: u32;
    var phi_1895_: SlimbvhTypeK;
    var phi_1896_: SlimbvhTypeK;
    var phi_1941_: SlimbvhTypeK;
    var phi_1942_: SlimbvhTypeK;
    var phi_1987_: SlimbvhTypeK;
    var phi_1988_: SlimbvhTypeK;
    var phi_2464_: u32;
    var phi_2477_: u32;
    var phi_2490_: u32;
    var phi_2503_: u32;
    var phi_3960_: SlimbvhTypeD;
    var phi_3972_: SlimbvhTypeD;
    var phi_3984_: SlimbvhTypeD;
    var phi_3996_: SlimbvhTypeD;
    var phi_4008_: SlimbvhTypeD;
    var phi_2584_: u32;
    var phi_2589_: u32;
    var phi_2590_: u32;
    var phi_2613_: u32;
    var phi_1795_: u32;
    var phi_1798_: u32;
    var phi_1800_: u32;
    var local_1: bool;
    var local_2: u32;
    var local_3: u32;
    var phi_2629_: SlimbvhTypeN;
    var phi_2632_: SlimbvhTypeD;
    var phi_2633_: SlimbvhTypeD;
    var phi_2655_: SlimbvhTypeD;
    var phi_2734_: array<vec4<f32>, 3>;
    var phi_2735_: array<vec4<f32>, 3>;
    var phi_2815_: array<vec4<f32>, 3>;
    var phi_2816_: array<vec4<f32>, 3>;
    var phi_2839_: array<f32, 3>;
    var phi_2840_: array<f32, 3>;
    var phi_2854_: array<f32, 3>;
    var phi_2855_: array<f32, 3>;
    var phi_2869_: array<f32, 3>;
    var phi_2870_: array<f32, 3>;
    var phi_3229_: f32;
    var phi_3230_: f32;
    var phi_3231_: f32;
    var phi_3232_: f32;
    var phi_3233_: vec3<f32>;
    var phi_3234_: vec3<f32>;
    var phi_3235_: vec3<f32>;
    var phi_3236_: vec3<f32>;
    var phi_3415_: f32;
    var phi_3441_: SlimbvhTypeE;
    var phi_3442_: SlimbvhTypeE;
    var phi_3445_: SlimbvhTypeE;
    var phi_3446_: SlimbvhTypeE;
    var phi_3447_: bool;
    var phi_3451_: SlimbvhTypeE;
    var phi_3460_: SlimbvhTypeF;
    var phi_3487_: bool;
    var phi_3488_: bool;
    var phi_3495_: SlimbvhTypeN;
    var phi_3501_: SlimbvhTypeN;
    var phi_3502_: SlimbvhTypeN;
    var phi_3503_: SlimbvhTypeN;
    var phi_2630_: SlimbvhTypeN;
    var local_4: u32;
    var local_5: u32;
    var phi_3561_: u32;
    var local_6: SlimbvhTypeN;
    var phi_3570_: SlimbvhTypeN;
    var phi_3571_: u32;
    var phi_3572_: u32;
    var phi_1779_: SlimbvhTypeN;
    var phi_1782_: u32;
    var phi_1784_: u32;
    var phi_1786_: u32;
    var local_7: SlimbvhTypeN;
    var phi_3608_: f32;
    var phi_3610_: f32;
    var phi_3611_: bool;
    var phi_3612_: f32;
    var phi_3613_: bool;
    var phi_4239_: u32;
    var phi_4257_: bool;
    var phi_4260_: bool;
    var phi_4273_: f32;
    var phi_4274_: f32;
    var phi_4279_: f32;
    var phi_4280_: f32;
    var phi_4281_: bool;
    var phi_4289_: f32;
    var phi_3628_: f32;
    var phi_3629_: f32;
    var phi_3641_: f32;
    var phi_3646_: SlimbvhTypeF;
    var local_8: SlimbvhTypeN;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e86 = SlimbvhTypeF(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e90 = arrayLength((&slimbvh_nodes.member));
    let _e100 = slimbvh_root.member[0u][0u];
    let _e104 = slimbvh_root.member[0u][1u];
    let _e108 = slimbvh_root.member[0u][2u];
    let _e112 = slimbvh_root.member[0u][3u];
    let _e116 = slimbvh_root.member[1u][0u];
    let _e120 = slimbvh_root.member[1u][1u];
    let _e124 = slimbvh_root.member[1u][2u];
    let _e136 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e112) + 127i)) << bitcast<u32>(23i)));
    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    let _e137 = slimbvh_origin.member;
    let _e143 = slimbvh_origin.member[3u];
    let _e144 = slimbvh_direction.member;
    let _e150 = slimbvh_direction.member[3u];
    let _e153 = slimbvh_exponent.member[0u];
    let _e154 = bitcast<i32>(_e153);
    let _e156 = (bitcast<u32>(_e137.x) & 2147483647u);
    let _e158 = (bitcast<u32>(_e137.y) & 2147483647u);
    let _e160 = (bitcast<u32>(_e137.z) & 2147483647u);
    let _e161 = bitcast<u32>(_e143);
    let _e162 = (_e161 & 2147483647u);
    let _e164 = (bitcast<u32>(_e144.x) & 2147483647u);
    let _e166 = (bitcast<u32>(_e144.y) & 2147483647u);
    let _e168 = (bitcast<u32>(_e144.z) & 2147483647u);
    let _e169 = bitcast<u32>(_e150);
    let _e170 = (_e169 & 2147483647u);
    let _e172 = select(_e166, _e164, (_e166 < _e164));
    let _e174 = select(_e168, _e172, (_e168 < _e172));
    let _e176 = select(_e156, _e174, (_e156 < _e174));
    let _e178 = select(_e158, _e176, (_e158 < _e176));
    let _e180 = select(_e160, _e178, (_e160 < _e178));
    let _e187 = (((select(_e162, _e180, (_e162 < _e180)) < 2139095040u) && (_e170 <= 2139095040u)) && (_e174 > 0u));
    if (_e164 == _e174) {
        phi_676_ = 0u;
    } else {
        phi_676_ = select(2u, 1u, (_e166 == _e174));
    }
    let _e192 = phi_676_;
    let _e193 = (_e192 == 2u);
    if _e193 {
        phi_682_ = 0u;
    } else {
        phi_682_ = (_e192 + 1u);
    }
    let _e196 = phi_682_;
    let _e197 = (_e196 == 2u);
    if _e197 {
        phi_688_ = 0u;
    } else {
        phi_688_ = (_e196 + 1u);
    }
    let _e200 = phi_688_;
    let _e201 = (_e196 == 0u);
    let _e203 = select(select(_e137.y, _e137.x, _e201), _e137.z, _e197);
    let _e204 = (_e200 == 0u);
    let _e206 = (_e200 == 2u);
    let _e207 = select(select(_e137.y, _e137.x, _e204), _e137.z, _e206);
    let _e208 = (_e192 == 0u);
    let _e210 = select(select(_e137.y, _e137.x, _e208), _e137.z, _e193);
    let _e212 = select(select(_e144.y, _e144.x, _e201), _e144.z, _e197);
    let _e214 = select(select(_e144.y, _e144.x, _e204), _e144.z, _e206);
    let _e216 = select(select(_e144.y, _e144.x, _e208), _e144.z, _e193);
    let _e217 = (_e162 - 1u);
    let _e218 = (_e170 - 1u);
    let _e220 = select(_e217, _e218, (_e218 < _e217));
    let _e221 = (_e156 - 1u);
    let _e222 = (_e158 - 1u);
    let _e224 = select(_e221, _e222, (_e222 < _e221));
    let _e225 = (_e160 - 1u);
    let _e227 = select(_e224, _e225, (_e225 < _e224));
    let _e228 = (_e164 - 1u);
    let _e229 = (_e166 - 1u);
    let _e231 = select(_e228, _e229, (_e229 < _e228));
    let _e232 = (_e168 - 1u);
    let _e234 = select(_e231, _e232, (_e232 < _e231));
    let _e236 = select(_e227, _e234, (_e234 < _e227));
    if (((select(_e236, _e220, (_e220 < _e236)) >= 8388607u) && (_e174 < 2130706432u)) && (bitcast<u32>((_e154 + 126i)) <= 253u)) {
        let _e501 = bitcast<i32>((_e174 >> bitcast<u32>(23i)));
        let _e502 = (_e501 - 127i);
        let _e503 = (_e154 + _e502);
        let _e508 = bitcast<f32>((bitcast<u32>((_e154 + 127i)) << bitcast<u32>(23i)));
        let _e513 = bitcast<f32>((bitcast<u32>((254i - _e501)) << bitcast<u32>(23i)));
        if (_e162 >= 2139095040u) {
            phi_850_ = 255i;
        } else {
            phi_850_ = (bitcast<i32>((_e162 >> bitcast<u32>(23i))) + _e503);
        }
        let _e528 = phi_850_;
        if (_e162 == 0u) {
            phi_856_ = 0u;
        } else {
            phi_856_ = (_e162 | 8388608u);
        }
        let _e532 = phi_856_;
        if (_e528 <= 0i) {
            phi_876_ = u32();
            phi_877_ = true;
        } else {
            let _e539 = (_e532 == 0u);
            if _e539 {
                phi_875_ = u32();
            } else {
                phi_875_ = select(((bitcast<u32>(_e528) << bitcast<u32>(23i)) | (_e532 & 8388607u)), 2139095039u, (_e528 >= 255i));
            }
            let _e543 = phi_875_;
            phi_876_ = _e543;
            phi_877_ = _e539;
        }
        let _e545 = phi_876_;
        let _e547 = phi_877_;
        if (_e170 >= 2139095040u) {
            phi_895_ = 255i;
        } else {
            phi_895_ = (bitcast<i32>((_e170 >> bitcast<u32>(23i))) + _e503);
        }
        let _e558 = phi_895_;
        if (_e170 == 0u) {
            phi_901_ = 0u;
        } else {
            phi_901_ = (_e170 | 8388608u);
        }
        let _e562 = phi_901_;
        if (_e558 <= 0i) {
            phi_921_ = u32();
            phi_922_ = true;
        } else {
            let _e569 = (_e562 == 0u);
            if _e569 {
                phi_920_ = u32();
            } else {
                phi_920_ = select(((bitcast<u32>(_e558) << bitcast<u32>(23i)) | (_e562 & 8388607u)), 2139095039u, (_e558 >= 255i));
            }
            let _e573 = phi_920_;
            phi_921_ = _e573;
            phi_922_ = _e569;
        }
        let _e575 = phi_921_;
        let _e577 = phi_922_;
        phi_1299_ = SlimbvhTypeC(array<f32, 3>((_e203 * _e508), (_e207 * _e508), (_e210 * _e508)), array<f32, 3>((_e212 * _e513), (_e214 * _e513), (_e216 * _e513)), bitcast<f32>(((_e161 & 2147483648u) | select(_e545, 0u, _e547))), bitcast<f32>(((_e169 & 2147483648u) | select(_e575, 0u, _e577))), _e502);
    } else {
        let _e249 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e174, _e187))) & 2147483647u);
        if (_e249 >= 8388608u) {
            phi_953_ = (bitcast<i32>((_e249 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_953_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e249)), 32u, (_e249 == 0u))));
        }
        let _e263 = phi_953_;
        let _e264 = (_e154 + _e263);
        if (_e154 < -126i) {
            phi_964_ = -126i;
        } else {
            phi_964_ = select(_e154, 127i, (_e154 > 127i));
        }
        let _e269 = phi_964_;
        let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
        let _e280 = bitcast<f32>((bitcast<u32>(((_e154 - _e269) + 127i)) << bitcast<u32>(23i)));
        let _e281 = bitcast<u32>(_e203);
        let _e283 = ((_e281 & 2139095040u) != 0u);
        let _e298 = bitcast<u32>(_e207);
        let _e300 = ((_e298 & 2139095040u) != 0u);
        let _e315 = bitcast<u32>(_e210);
        let _e317 = ((_e315 & 2139095040u) != 0u);
        let _e333 = -(_e263);
        if (_e333 < -126i) {
            phi_1078_ = -126i;
        } else {
            phi_1078_ = select(_e333, 127i, (_e333 > 127i));
        }
        let _e338 = phi_1078_;
        let _e343 = bitcast<f32>((bitcast<u32>((_e338 + 127i)) << bitcast<u32>(23i)));
        let _e349 = bitcast<f32>((bitcast<u32>(((_e333 - _e338) + 127i)) << bitcast<u32>(23i)));
        let _e350 = bitcast<u32>(_e212);
        let _e352 = ((_e350 & 2139095040u) != 0u);
        let _e367 = bitcast<u32>(_e214);
        let _e369 = ((_e367 & 2139095040u) != 0u);
        let _e384 = bitcast<u32>(_e216);
        let _e386 = ((_e384 & 2139095040u) != 0u);
        let _e408 = ((_e162 & 8388607u) | (select(0u, 1u, ((_e162 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e411 = bitcast<i32>((_e162 >> bitcast<u32>(23i)));
        let _e418 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e408)), 32u, (_e408 == 0u))) - 8i);
        if (_e411 == 255i) {
            phi_1207_ = 255i;
        } else {
            phi_1207_ = (((_e411 + select(0i, 1i, (_e411 == 0i))) - _e418) + _e264);
        }
        let _e426 = phi_1207_;
        let _e430 = (_e408 << bitcast<u32>(((_e418 & 31i) & 31i)));
        if (_e426 <= 0i) {
            phi_1230_ = u32();
            phi_1231_ = true;
        } else {
            let _e437 = (_e430 == 0u);
            if _e437 {
                phi_1229_ = u32();
            } else {
                phi_1229_ = select(((bitcast<u32>(_e426) << bitcast<u32>(23i)) | (_e430 & 8388607u)), 2139095039u, (_e426 >= 255i));
            }
            let _e441 = phi_1229_;
            phi_1230_ = _e441;
            phi_1231_ = _e437;
        }
        let _e443 = phi_1230_;
        let _e445 = phi_1231_;
        let _e456 = ((_e170 & 8388607u) | (select(0u, 1u, ((_e170 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e459 = bitcast<i32>((_e170 >> bitcast<u32>(23i)));
        let _e466 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e456)), 32u, (_e456 == 0u))) - 8i);
        if (_e459 == 255i) {
            phi_1265_ = 255i;
        } else {
            phi_1265_ = (((_e459 + select(0i, 1i, (_e459 == 0i))) - _e466) + _e264);
        }
        let _e474 = phi_1265_;
        let _e478 = (_e456 << bitcast<u32>(((_e466 & 31i) & 31i)));
        if (_e474 <= 0i) {
            phi_1288_ = u32();
            phi_1289_ = true;
        } else {
            let _e485 = (_e478 == 0u);
            if _e485 {
                phi_1287_ = u32();
            } else {
                phi_1287_ = select(((bitcast<u32>(_e474) << bitcast<u32>(23i)) | (_e478 & 8388607u)), 2139095039u, (_e474 >= 255i));
            }
            let _e489 = phi_1287_;
            phi_1288_ = _e489;
            phi_1289_ = _e485;
        }
        let _e491 = phi_1288_;
        let _e493 = phi_1289_;
        phi_1299_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e281 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e281 & 2147483648u))), _e203, _e283) * _e274) * select(0.00000011920929f, 1f, _e283)) * _e280), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e298 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e298 & 2147483648u))), _e207, _e300) * _e274) * select(0.00000011920929f, 1f, _e300)) * _e280), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e210, _e317) * _e274) * select(0.00000011920929f, 1f, _e317)) * _e280)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e350 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e350 & 2147483648u))), _e212, _e352) * _e343) * select(0.00000011920929f, 1f, _e352)) * _e349), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e367 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e367 & 2147483648u))), _e214, _e369) * _e343) * select(0.00000011920929f, 1f, _e369)) * _e349), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e216, _e386) * _e343) * select(0.00000011920929f, 1f, _e386)) * _e349)), bitcast<f32>(((_e161 & 2147483648u) | select(_e443, 0u, _e445))), bitcast<f32>(((_e169 & 2147483648u) | select(_e491, 0u, _e493))), _e263);
    }
    let _e584 = phi_1299_;
    let _e599 = (bitcast<f32>((bitcast<u32>(_e584.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e602 = bitcast<f32>((bitcast<u32>(_e584.member[0]) & 2147483647u));
    let _e603 = (_e602 * 0.00000011920929f);
    let _e606 = select(select(0.00000000000011368684f, _e603, (_e603 > 0.00000000000011368684f)), 0f, _e599);
    let _e607 = select(0f, _e584.member_1[0], _e599);
    let _e608 = (_e584.member[0] + _e606);
    let _e609 = (_e584.member[0] - _e606);
    let _e611 = select(38685626000000000000000000f, (1f / _e584.member_1[0]), _e599);
    let _e615 = (bitcast<f32>((bitcast<u32>(_e584.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e618 = bitcast<f32>((bitcast<u32>(_e584.member[1]) & 2147483647u));
    let _e619 = (_e618 * 0.00000011920929f);
    let _e622 = select(select(0.00000000000011368684f, _e619, (_e619 > 0.00000000000011368684f)), 0f, _e615);
    let _e623 = select(0f, _e584.member_1[1], _e615);
    let _e624 = (_e584.member[1] + _e622);
    let _e625 = (_e584.member[1] - _e622);
    let _e627 = select(38685626000000000000000000f, (1f / _e584.member_1[1]), _e615);
    let _e631 = (bitcast<f32>((bitcast<u32>(_e584.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e634 = bitcast<f32>((bitcast<u32>(_e584.member[2]) & 2147483647u));
    let _e635 = (_e634 * 0.00000011920929f);
    let _e638 = select(select(0.00000000000011368684f, _e635, (_e635 > 0.00000000000011368684f)), 0f, _e631);
    let _e639 = select(0f, _e584.member_1[2], _e631);
    let _e640 = (_e584.member[2] + _e638);
    let _e641 = (_e584.member[2] - _e638);
    let _e643 = select(38685626000000000000000000f, (1f / _e584.member_1[2]), _e631);
    let _e645 = select(_e618, _e602, (_e602 > _e618));
    let _e649 = (_e187 && (select(_e634, _e645, (_e645 > _e634)) <= 1099511600000f));
    let _e650 = select(0f, _e584.member_3, _e649);
    let _e651 = select(1f, _e584.member_2, _e649);
    let _e653 = slimbvh_any_will_do.member;
    if (_e653 == 1u) {
        phi_1528_ = SlimbvhTypeN(SlimbvhTypeH(_e86, _e650), true);
    } else {
        phi_1528_ = SlimbvhTypeN(SlimbvhTypeH(_e86, _e650), false);
    }
    let _e660 = phi_1528_;
    let _e665 = (_e196 & 3u);
    let _e666 = (_e200 & 3u);
    let _e667 = (_e192 & 3u);
    let _e670 = (bitcast<u32>(_e611) >> bitcast<u32>(31i));
    let _e673 = (bitcast<u32>(_e627) >> bitcast<u32>(31i));
    let _e676 = (bitcast<u32>(_e643) >> bitcast<u32>(31i));
    let _e678 = (f32(bitcast<i32>(_e100)) * _e136);
    let _e680 = (f32(bitcast<i32>(_e104)) * _e136);
    let _e682 = (f32(bitcast<i32>(_e108)) * _e136);
    let _e683 = (_e665 == 0u);
    if _e683 {
        phi_1586_ = array<f32, 3>(_e678, _e680, _e682);
    } else {
        if (_e665 == 1u) {
            phi_1585_ = array<f32, 3>(_e680, _e682, _e678);
        } else {
            phi_1585_ = array<f32, 3>(_e682, _e678, _e680);
        }
        let _e688 = phi_1585_;
        phi_1586_ = _e688;
    }
    let _e691 = phi_1586_;
    let _e693 = (f32(bitcast<i32>(_e116)) * _e136);
    let _e695 = (f32(bitcast<i32>(_e120)) * _e136);
    let _e697 = (f32(bitcast<i32>(_e124)) * _e136);
    if _e683 {
        phi_1605_ = array<f32, 3>(_e693, _e695, _e697);
    } else {
        if (_e665 == 1u) {
            phi_1604_ = array<f32, 3>(_e695, _e697, _e693);
        } else {
            phi_1604_ = array<f32, 3>(_e697, _e693, _e695);
        }
        let _e702 = phi_1604_;
        phi_1605_ = _e702;
    }
    let _e705 = phi_1605_;
    let _e716 = ((_e691[0] - _e608) * _e611);
    let _e717 = ((_e705[0] - _e609) * _e611);
    let _e718 = vec4<f32>(_e716, f32(), _e717, f32());
    let _e721 = ((_e691[1] - _e624) * _e627);
    let _e722 = ((_e705[1] - _e625) * _e627);
    let _e723 = vec4<f32>(_e721, f32(), _e722, f32());
    let _e726 = ((_e691[2] - _e640) * _e643);
    let _e727 = ((_e705[2] - _e641) * _e643);
    let _e728 = vec4<f32>(_e726, f32(), _e727, f32());
    let _e729 = vec4<f32>(_e717, f32(), _e716, f32());
    let _e731 = vec4<f32>(_e722, f32(), _e721, f32());
    let _e733 = vec4<f32>(_e727, f32(), _e726, f32());
    phi_1778_ = _e660;
    phi_1781_ = select(4294967295u, select(4294967295u, 0u, (_e651 <= _e650)), (max(max(max(min(_e718, _e729).x, min(_e723, _e731).x), min(_e728, _e733).x), _e651) <= min((min(min(max(_e718, _e729).x, max(_e723, _e731).x), max(_e728, _e733).x) + (max(max(_e728, _e733).x, -(min(_e728, _e733).x)) * 0.0000019073523f)), _e660.member.member_1)));
    phi_1783_ = 0u;
    phi_1785_ = (_e90 + 1u);
    loop {
        let _e757 = phi_1778_;
        let _e759 = phi_1781_;
        let _e761 = phi_1783_;
        let _e763 = phi_1785_;
        local_7 = _e757;
        let _e764 = (_e759 <= 2147483647u);
        if _e764 {
            phi_1794_ = _e759;
            phi_1797_ = _e761;
            phi_1799_ = _e763;
            loop {
                let _e766 = phi_1794_;
                let _e768 = phi_1797_;
                let _e770 = phi_1799_;
                local_2 = _e768;
                local_3 = _e768;
                local_4 = _e766;
                local_5 = _e766;
                local_9 = _e766;
                local_10 = _e768;
                local_11 = _e770;
                let _e771 = (_e766 <= 2147483647u);
                let _e774 = (_e771 && !((_e768 >= _e90)));
                local_1 = _e771;
                if _e774 {
                    let _e780 = slimbvh_nodes.member[_e768].member[select(_e665, 2u, (2u < _e665))];
                    let _e786 = slimbvh_nodes.member[_e768].member[select(_e666, 2u, (2u < _e666))];
                    let _e792 = slimbvh_nodes.member[_e768].member[select(_e667, 2u, (2u < _e667))];
                    let _e795 = bitcast<u32>(_e136);
                    let _e800 = bitcast<f32>(_e780.x);
                    let _e805 = (_e800 + (f32((_e780.w >> bitcast<u32>(5u))) * _e136));
                    if (_e670 == 0u) {
                        phi_1895_ = SlimbvhTypeK(_e780.z, _e805);
                        phi_1896_ = SlimbvhTypeK(_e780.y, _e800);
                    } else {
                        phi_1895_ = SlimbvhTypeK(_e780.y, _e800);
                        phi_1896_ = SlimbvhTypeK(_e780.z, _e805);
                    }
                    let _e816 = phi_1895_;
                    let _e818 = phi_1896_;
                    let _e822 = bitcast<f32>(((_e795 + ((_e780.w & 31u) << bitcast<u32>(23i))) ^ (_e670 << bitcast<u32>(31i))));
                    let _e862 = bitcast<f32>(_e786.x);
                    let _e867 = (_e862 + (f32((_e786.w >> bitcast<u32>(5u))) * _e136));
                    if (_e673 == 0u) {
                        phi_1941_ = SlimbvhTypeK(_e786.z, _e867);
                        phi_1942_ = SlimbvhTypeK(_e786.y, _e862);
                    } else {
                        phi_1941_ = SlimbvhTypeK(_e786.y, _e862);
                        phi_1942_ = SlimbvhTypeK(_e786.z, _e867);
                    }
                    let _e878 = phi_1941_;
                    let _e880 = phi_1942_;
                    let _e884 = bitcast<f32>(((_e795 + ((_e786.w & 31u) << bitcast<u32>(23i))) ^ (_e673 << bitcast<u32>(31i))));
                    let _e924 = bitcast<f32>(_e792.x);
                    let _e929 = (_e924 + (f32((_e792.w >> bitcast<u32>(5u))) * _e136));
                    if (_e676 == 0u) {
                        phi_1987_ = SlimbvhTypeK(_e792.z, _e929);
                        phi_1988_ = SlimbvhTypeK(_e792.y, _e924);
                    } else {
                        phi_1987_ = SlimbvhTypeK(_e792.y, _e924);
                        phi_1988_ = SlimbvhTypeK(_e792.z, _e929);
                    }
                    let _e940 = phi_1987_;
                    let _e942 = phi_1988_;
                    let _e946 = bitcast<f32>(((_e795 + ((_e792.w & 31u) << bitcast<u32>(23i))) ^ (_e676 << bitcast<u32>(31i))));
                    let _e982 = (_e822 * _e611);
                    let _e989 = (((_e818.member_1 - _e608) * _e611) + (bitcast<f32>((bitcast<u32>(_e982) & 2147483647u)) * -0.00012207031f));
                    let _e998 = (-(_e822) * _e611);
                    let _e1005 = (((_e816.member_1 - _e609) * _e611) + (bitcast<f32>((bitcast<u32>(_e998) & 2147483647u)) * 0.00012207031f));
                    let _e1014 = (_e884 * _e627);
                    let _e1021 = (((_e880.member_1 - _e624) * _e627) + (bitcast<f32>((bitcast<u32>(_e1014) & 2147483647u)) * -0.00012207031f));
                    let _e1030 = (-(_e884) * _e627);
                    let _e1037 = (((_e878.member_1 - _e625) * _e627) + (bitcast<f32>((bitcast<u32>(_e1030) & 2147483647u)) * 0.00012207031f));
                    let _e1046 = (_e946 * _e643);
                    let _e1053 = (((_e942.member_1 - _e640) * _e643) + (bitcast<f32>((bitcast<u32>(_e1046) & 2147483647u)) * -0.00012207031f));
                    let _e1058 = ((f32((_e942.member & 255u)) * _e1046) + _e1053);
                    let _e1059 = ((f32(((_e942.member >> bitcast<u32>(8u)) & 255u)) * _e1046) + _e1053);
                    let _e1060 = ((f32(((_e942.member >> bitcast<u32>(16u)) & 255u)) * _e1046) + _e1053);
                    let _e1061 = ((f32(((_e942.member >> bitcast<u32>(24u)) & 255u)) * _e1046) + _e1053);
                    let _e1062 = (-(_e946) * _e643);
                    let _e1069 = (((_e940.member_1 - _e641) * _e643) + (bitcast<f32>((bitcast<u32>(_e1062) & 2147483647u)) * 0.00012207031f));
                    let _e1074 = ((f32((_e940.member & 255u)) * _e1062) + _e1069);
                    let _e1075 = ((f32(((_e940.member >> bitcast<u32>(8u)) & 255u)) * _e1062) + _e1069);
                    let _e1076 = ((f32(((_e940.member >> bitcast<u32>(16u)) & 255u)) * _e1062) + _e1069);
                    let _e1077 = ((f32(((_e940.member >> bitcast<u32>(24u)) & 255u)) * _e1062) + _e1069);
                    let _e1110 = max(max(max(((f32((_e818.member & 255u)) * _e982) + _e989), ((f32((_e880.member & 255u)) * _e1014) + _e1021)), _e1058), _e651);
                    let _e1111 = max(max(max(((f32(((_e818.member >> bitcast<u32>(8u)) & 255u)) * _e982) + _e989), ((f32(((_e880.member >> bitcast<u32>(8u)) & 255u)) * _e1014) + _e1021)), _e1059), _e651);
                    let _e1112 = max(max(max(((f32(((_e818.member >> bitcast<u32>(16u)) & 255u)) * _e982) + _e989), ((f32(((_e880.member >> bitcast<u32>(16u)) & 255u)) * _e1014) + _e1021)), _e1060), _e651);
                    let _e1113 = max(max(max(((f32(((_e818.member >> bitcast<u32>(24u)) & 255u)) * _e982) + _e989), ((f32(((_e880.member >> bitcast<u32>(24u)) & 255u)) * _e1014) + _e1021)), _e1061), _e651);
                    let _e1118 = (_e757.member.member_1 + (bitcast<f32>((bitcast<u32>(_e757.member.member_1) & 2147483647u)) * 0.0000004768374f));
                    if (_e1110 <= min((min(min(((f32((_e816.member & 255u)) * _e998) + _e1005), ((f32((_e878.member & 255u)) * _e1030) + _e1037)), _e1074) + (max(_e1074, -(_e1058)) * 0.0000023841915f)), _e1118)) {
                        phi_2464_ = (((bitcast<u32>(_e1110) ^ select(0u, 4294967288u, _e660.member_1)) & 2147483640u) | 4u);
                    } else {
                        phi_2464_ = 4294967288u;
                    }
                    let _e1133 = phi_2464_;
                    if (_e1111 <= min((min(min(((f32(((_e816.member >> bitcast<u32>(8u)) & 255u)) * _e998) + _e1005), ((f32(((_e878.member >> bitcast<u32>(8u)) & 255u)) * _e1030) + _e1037)), _e1075) + (max(_e1075, -(_e1059)) * 0.0000023841915f)), _e1118)) {
                        phi_2477_ = ((((bitcast<u32>(_e1111) ^ select(0u, 4294967288u, _e660.member_1)) & 2147483640u) | 4u) | 1u);
                    } else {
                        phi_2477_ = 4294967288u;
                    }
                    let _e1141 = phi_2477_;
                    if (_e1112 <= min((min(min(((f32(((_e816.member >> bitcast<u32>(16u)) & 255u)) * _e998) + _e1005), ((f32(((_e878.member >> bitcast<u32>(16u)) & 255u)) * _e1030) + _e1037)), _e1076) + (max(_e1076, -(_e1060)) * 0.0000023841915f)), _e1118)) {
                        phi_2490_ = ((((bitcast<u32>(_e1112) ^ select(0u, 4294967288u, _e660.member_1)) & 2147483640u) | 4u) | 2u);
                    } else {
                        phi_2490_ = 4294967288u;
                    }
                    let _e1149 = phi_2490_;
                    if (_e1113 <= min((min(min(((f32(((_e816.member >> bitcast<u32>(24u)) & 255u)) * _e998) + _e1005), ((f32(((_e878.member >> bitcast<u32>(24u)) & 255u)) * _e1030) + _e1037)), _e1077) + (max(_e1077, -(_e1061)) * 0.0000023841915f)), _e1118)) {
                        phi_2503_ = ((((bitcast<u32>(_e1113) ^ select(0u, 4294967288u, _e660.member_1)) & 2147483640u) | 4u) | 3u);
                    } else {
                        phi_2503_ = 4294967288u;
                    }
                    let _e1157 = phi_2503_;
                    if (_e1133 < _e1141) {
                        phi_3960_ = SlimbvhTypeD(_e1133, _e1141);
                    } else {
                        phi_3960_ = SlimbvhTypeD(_e1141, _e1133);
                    }
                    let _e1162 = phi_3960_;
                    if (_e1149 < _e1157) {
                        phi_3972_ = SlimbvhTypeD(_e1149, _e1157);
                    } else {
                        phi_3972_ = SlimbvhTypeD(_e1157, _e1149);
                    }
                    let _e1169 = phi_3972_;
                    if (_e1162.member < _e1169.member) {
                        phi_3984_ = SlimbvhTypeD(_e1162.member, _e1169.member);
                    } else {
                        phi_3984_ = SlimbvhTypeD(_e1169.member, _e1162.member);
                    }
                    let _e1176 = phi_3984_;
                    if (_e1162.member_1 < _e1169.member_1) {
                        phi_3996_ = SlimbvhTypeD(_e1162.member_1, _e1169.member_1);
                    } else {
                        phi_3996_ = SlimbvhTypeD(_e1169.member_1, _e1162.member_1);
                    }
                    let _e1183 = phi_3996_;
                    if (_e1183.member < _e1176.member_1) {
                        phi_4008_ = SlimbvhTypeD(_e1183.member, _e1176.member_1);
                    } else {
                        phi_4008_ = SlimbvhTypeD(_e1176.member_1, _e1183.member);
                    }
                    let _e1190 = phi_4008_;
                    let _e1205 = (((_e1176.member & 7u) | ((_e1190.member & 7u) << bitcast<u32>(3u))) | (((_e1190.member_1 & 7u) | ((_e1183.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                    if (_e1205 == 0u) {
                        let _e1223 = (_e766 - 1u);
                        let _e1226 = local[(_e1223 % 128u)];
                        let _e1227 = (_e1226 & 511u);
                        let _e1229 = (_e1227 >> bitcast<u32>(3u));
                        let _e1232 = ((_e1229 == 0u) || (_e1223 == 4294967295u));
                        if _e1232 {
                        } else {
                            local[(_e1223 % 128u)] = (((_e1226 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1229);
                        }
                        phi_2589_ = select(_e766, _e1223, _e1232);
                        phi_2590_ = (((_e1226 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1227 & 3u) & 3u));
                    } else {
                        let _e1208 = (_e1205 >> bitcast<u32>(3u));
                        if (_e1208 == 0u) {
                            phi_2584_ = _e766;
                        } else {
                            local[(_e766 % 128u)] = ((_e768 << bitcast<u32>(9u)) | _e1208);
                            phi_2584_ = (_e766 + 1u);
                        }
                        let _e1217 = phi_2584_;
                        phi_2589_ = _e1217;
                        phi_2590_ = ((_e768 << bitcast<u32>(2i)) | ((_e1205 & 3u) & 3u));
                    }
                    let _e1247 = phi_2589_;
                    let _e1249 = phi_2590_;
                    let _e1251 = (_e1249 >> bitcast<u32>(2i));
                    if (_e1251 < _e90) {
                        let _e1257 = slimbvh_nodes.member[_e1251].member_1[(_e1249 & 3u)];
                        phi_2613_ = _e1257;
                    } else {
                        phi_2613_ = 2147483648u;
                    }
                    let _e1259 = phi_2613_;
                    let _e1260 = (_e770 - 1u);
                    phi_1795_ = select(_e1247, 4294967295u, (_e1260 == 0u));
                    phi_1798_ = _e1259;
                    phi_1800_ = _e1260;
                } else {
                    phi_1795_ = u32();
                    phi_1798_ = u32();
                    phi_1800_ = u32();
                }
                let _e1264 = phi_1795_;
                let _e1266 = phi_1798_;
                let _e1268 = phi_1800_;
                continue;
                continuing {
                    phi_1794_ = _e1264;
                    phi_1797_ = _e1266;
                    phi_1799_ = _e1268;
                    break if !(_e774);
                }
            }
            let _e1271 = local_1;
            if _e1271 {
                let _e1273 = local_2;
                let _e1276 = local_3;
                phi_2629_ = _e757;
                phi_2632_ = SlimbvhTypeD(0u, ((_e1276 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e1282 = phi_2629_;
                    let _e1284 = phi_2632_;
                    local_6 = _e1282;
                    local_8 = _e1282;
                    if (_e1284.member < _e1284.member_1) {
                        phi_2633_ = SlimbvhTypeD((_e1284.member + 1u), _e1284.member_1);
                        phi_2655_ = SlimbvhTypeD(1u, _e1284.member);
                    } else {
                        phi_2633_ = _e1284;
                        phi_2655_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                    }
                    let _e1297 = phi_2633_;
                    let _e1299 = phi_2655_;
                    let _e1303 = (bitcast<i32>(_e1299.member) != 0i);
                    if _e1303 {
                        let _e1304 = ((_e1273 & 268435455u) + _e1299.member_1);
                        let _e1305 = (_e1304 / 2u);
                        let _e1306 = (_e1304 % 2u);
                        let _e1307 = (_e1305 >= arrayLength((&slimbvh_triangles.member)));
                        if _e1307 {
                            phi_2735_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e1308 = (2u * _e1306);
                            let _e1312 = slimbvh_triangles.member[_e1305][_e1308];
                            let _e1317 = slimbvh_triangles.member[_e1305][(_e1308 + 1u)];
                            let _e1322 = slimbvh_triangles.member[_e1305][(_e1308 + 2u)];
                            if (_e1306 == 0u) {
                                phi_2734_ = array<vec4<f32>, 3>(_e1312, _e1317, _e1322);
                            } else {
                                phi_2734_ = array<vec4<f32>, 3>(vec4<f32>(_e1312.z, _e1312.w, _e1317.x, _e1317.y), vec4<f32>(_e1317.z, _e1317.w, _e1322.x, _e1322.y), vec4<f32>(_e1322.z, _e1322.w, 0f, 0f));
                            }
                            let _e1340 = phi_2734_;
                            phi_2735_ = _e1340;
                        }
                        let _e1342 = phi_2735_;
                        let _e1345 = bitcast<u32>(_e1342[2].y);
                        if _e1307 {
                            phi_2816_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e1346 = (2u * _e1306);
                            let _e1350 = slimbvh_triangles.member[_e1305][_e1346];
                            let _e1355 = slimbvh_triangles.member[_e1305][(_e1346 + 1u)];
                            let _e1360 = slimbvh_triangles.member[_e1305][(_e1346 + 2u)];
                            if (_e1306 == 0u) {
                                phi_2815_ = array<vec4<f32>, 3>(_e1350, _e1355, _e1360);
                            } else {
                                phi_2815_ = array<vec4<f32>, 3>(vec4<f32>(_e1350.z, _e1350.w, _e1355.x, _e1355.y), vec4<f32>(_e1355.z, _e1355.w, _e1360.x, _e1360.y), vec4<f32>(_e1360.z, _e1360.w, 0f, 0f));
                            }
                            let _e1378 = phi_2815_;
                            phi_2816_ = _e1378;
                        }
                        let _e1380 = phi_2816_;
                        if _e201 {
                            phi_2840_ = array<f32, 3>(_e1380[0].x, _e1380[0].y, _e1380[0].z);
                        } else {
                            if (_e196 == 1u) {
                                phi_2839_ = array<f32, 3>(_e1380[0].y, _e1380[0].z, _e1380[0].x);
                            } else {
                                phi_2839_ = array<f32, 3>(_e1380[0].z, _e1380[0].x, _e1380[0].y);
                            }
                            let _e1403 = phi_2839_;
                            phi_2840_ = _e1403;
                        }
                        let _e1406 = phi_2840_;
                        if _e201 {
                            phi_2855_ = array<f32, 3>(_e1380[0].w, _e1380[1].x, _e1380[1].y);
                        } else {
                            if (_e196 == 1u) {
                                phi_2854_ = array<f32, 3>(_e1380[1].x, _e1380[1].y, _e1380[0].w);
                            } else {
                                phi_2854_ = array<f32, 3>(_e1380[1].y, _e1380[0].w, _e1380[1].x);
                            }
                            let _e1411 = phi_2854_;
                            phi_2855_ = _e1411;
                        }
                        let _e1414 = phi_2855_;
                        if _e201 {
                            phi_2870_ = array<f32, 3>(_e1380[1].z, _e1380[1].w, _e1380[2].x);
                        } else {
                            if (_e196 == 1u) {
                                phi_2869_ = array<f32, 3>(_e1380[1].w, _e1380[2].x, _e1380[1].z);
                            } else {
                                phi_2869_ = array<f32, 3>(_e1380[2].x, _e1380[1].z, _e1380[1].w);
                            }
                            let _e1419 = phi_2869_;
                            phi_2870_ = _e1419;
                        }
                        let _e1422 = phi_2870_;
                        let _e1436 = (_e1406[2] - _e584.member[2]);
                        let _e1439 = (((_e1406[0] - _e584.member[0]) * _e639) - (_e1436 * _e607));
                        let _e1442 = (((_e1406[1] - _e584.member[1]) * _e639) - (_e1436 * _e623));
                        let _e1445 = (_e1414[2] - _e584.member[2]);
                        let _e1448 = (((_e1414[0] - _e584.member[0]) * _e639) - (_e1445 * _e607));
                        let _e1451 = (((_e1414[1] - _e584.member[1]) * _e639) - (_e1445 * _e623));
                        let _e1454 = (_e1422[2] - _e584.member[2]);
                        let _e1457 = (((_e1422[0] - _e584.member[0]) * _e639) - (_e1454 * _e607));
                        let _e1460 = (((_e1422[1] - _e584.member[1]) * _e639) - (_e1454 * _e623));
                        let _e1461 = (_e1457 * _e1451);
                        let _e1462 = (_e1460 * _e1448);
                        let _e1463 = (_e1439 * _e1460);
                        let _e1464 = (_e1442 * _e1457);
                        let _e1465 = (_e1448 * _e1442);
                        let _e1466 = (_e1451 * _e1439);
                        let _e1471 = (((_e1461 >= _e1462) && (_e1463 >= _e1464)) && (_e1465 >= _e1466));
                        let _e1477 = (_e1471 || (((_e1461 <= _e1462) && (_e1463 <= _e1464)) && (_e1465 <= _e1466)));
                        if _e1477 {
                            let _e1479 = select(-1f, 1f, _e1471);
                            let _e1481 = ((_e1461 - _e1462) * _e1479);
                            let _e1483 = select(0f, _e1481, (_e1481 > 0f));
                            let _e1485 = ((_e1463 - _e1464) * _e1479);
                            let _e1487 = select(0f, _e1485, (_e1485 > 0f));
                            let _e1489 = ((_e1465 - _e1466) * _e1479);
                            let _e1491 = select(0f, _e1489, (_e1489 > 0f));
                            let _e1493 = ((_e1483 + _e1487) + _e1491);
                            let _e1508 = ((min(min(_e1406[0], _e1414[0]), _e1422[0]) - _e608) * _e611);
                            let _e1509 = ((max(max(_e1406[0], _e1414[0]), _e1422[0]) - _e609) * _e611);
                            let _e1510 = vec4<f32>(_e1508, f32(), _e1509, f32());
                            let _e1513 = ((min(min(_e1406[1], _e1414[1]), _e1422[1]) - _e624) * _e627);
                            let _e1514 = ((max(max(_e1406[1], _e1414[1]), _e1422[1]) - _e625) * _e627);
                            let _e1515 = vec4<f32>(_e1513, f32(), _e1514, f32());
                            let _e1518 = ((min(min(_e1406[2], _e1414[2]), _e1422[2]) - _e640) * _e643);
                            let _e1519 = ((max(max(_e1406[2], _e1414[2]), _e1422[2]) - _e641) * _e643);
                            let _e1520 = vec4<f32>(_e1518, f32(), _e1519, f32());
                            let _e1521 = vec4<f32>(_e1509, f32(), _e1508, f32());
                            let _e1523 = vec4<f32>(_e1514, f32(), _e1513, f32());
                            let _e1525 = vec4<f32>(_e1519, f32(), _e1518, f32());
                            let _e1534 = max(max(min(_e1510, _e1521).x, min(_e1515, _e1523).x), min(_e1520, _e1525).x);
                            let _e1539 = min(min(max(_e1510, _e1521).x, max(_e1515, _e1523).x), max(_e1520, _e1525).x);
                            let _e1544 = max(_e1534, _e651);
                            let _e1566 = (((((_e1477 && (_e1493 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1439, _e1448), _e1457) <= 0f) && (max(max(_e1439, _e1448), _e1457) >= 0f))) && ((min(min(_e1442, _e1451), _e1460) <= 0f) && (max(max(_e1442, _e1451), _e1460) >= 0f))) && (_e1544 <= (_e1539 + (max(max(_e1520, _e1525).x, -(min(_e1520, _e1525).x)) * 0.0000019073523f)))) && (_e1544 <= _e1282.member.member_1));
                            if _e1566 {
                                let _e1571 = (_e1414[0] - _e1406[0]);
                                let _e1572 = (_e1414[1] - _e1406[1]);
                                let _e1573 = (_e1414[2] - _e1406[2]);
                                let _e1574 = vec3<f32>(_e1571, _e1572, _e1573);
                                let _e1575 = (_e1422[0] - _e1414[0]);
                                let _e1576 = (_e1422[1] - _e1414[1]);
                                let _e1577 = (_e1422[2] - _e1414[2]);
                                let _e1578 = vec3<f32>(_e1575, _e1576, _e1577);
                                let _e1579 = (_e1406[0] - _e1422[0]);
                                let _e1580 = (_e1406[1] - _e1422[1]);
                                let _e1581 = (_e1406[2] - _e1422[2]);
                                let _e1582 = vec3<f32>(_e1579, _e1580, _e1581);
                                let _e1593 = max(max(bitcast<f32>((bitcast<u32>(_e1571) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1572) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1573) & 2147483647u)));
                                let _e1604 = max(max(bitcast<f32>((bitcast<u32>(_e1575) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1576) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1577) & 2147483647u)));
                                let _e1617 = max(max(_e1593, _e1604), max(max(bitcast<f32>((bitcast<u32>(_e1579) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1580) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1581) & 2147483647u))));
                                if (_e1593 == _e1617) {
                                    phi_3229_ = _e1451;
                                    phi_3230_ = _e1448;
                                    phi_3231_ = _e1442;
                                    phi_3232_ = _e1439;
                                    phi_3233_ = vec3<f32>(_e1406[0], _e1406[1], _e1406[2]);
                                    phi_3234_ = _e1582;
                                    phi_3235_ = _e1578;
                                    phi_3236_ = _e1574;
                                } else {
                                    let _e1619 = (_e1604 == _e1617);
                                    let _e1624 = vec3(_e1619);
                                    phi_3229_ = select(_e1442, _e1460, _e1619);
                                    phi_3230_ = select(_e1439, _e1457, _e1619);
                                    phi_3231_ = select(_e1460, _e1451, _e1619);
                                    phi_3232_ = select(_e1457, _e1448, _e1619);
                                    phi_3233_ = select(vec3<f32>(_e1422[0], _e1422[1], _e1422[2]), vec3<f32>(_e1414[0], _e1414[1], _e1414[2]), _e1624);
                                    phi_3234_ = select(_e1578, _e1574, _e1624);
                                    phi_3235_ = select(_e1574, _e1582, _e1624);
                                    phi_3236_ = select(_e1582, _e1578, _e1624);
                                }
                                let _e1630 = phi_3229_;
                                let _e1632 = phi_3230_;
                                let _e1634 = phi_3231_;
                                let _e1636 = phi_3232_;
                                let _e1638 = phi_3233_;
                                let _e1640 = phi_3234_;
                                let _e1642 = phi_3235_;
                                let _e1644 = phi_3236_;
                                let _e1651 = ((_e1642.y * _e1640.z) - (_e1640.y * _e1642.z));
                                let _e1656 = ((_e1642.z * _e1640.x) - (_e1640.z * _e1642.x));
                                let _e1659 = ((_e1642.x * _e1640.y) - (_e1640.x * _e1642.y));
                                let _e1662 = ((_e1483 >= _e1487) && (_e1483 >= _e1491));
                                let _e1663 = (_e1487 >= _e1491);
                                let _e1677 = (((_e1651 * (select(select(_e1422[0], _e1414[0], _e1663), _e1406[0], _e1662) - _e584.member[0])) + (_e1656 * (select(select(_e1422[1], _e1414[1], _e1663), _e1406[1], _e1662) - _e584.member[1]))) + (_e1659 * (select(select(_e1422[2], _e1414[2], _e1663), _e1406[2], _e1662) - _e584.member[2])));
                                let _e1682 = (((_e1651 * _e607) + (_e1656 * _e623)) + (_e1659 * _e639));
                                let _e1683 = (_e1632 - _e1636);
                                let _e1684 = (_e1630 - _e1634);
                                let _e1687 = ((_e1683 * _e1683) + (_e1684 * _e1684));
                                let _e1694 = (-(((_e1636 * _e1683) + (_e1634 * _e1684))) / select(0.000000000000000000000000000000000000011754944f, _e1687, (_e1687 > 0.000000000000000000000000000000000000011754944f)));
                                let _e1696 = select(1f, _e1694, (_e1694 < 1f));
                                let _e1698 = select(0f, _e1696, (_e1696 > 0f));
                                let _e1707 = ((_e1638.x + (_e1644.x * _e1698)) - _e584.member[0]);
                                let _e1710 = ((_e1638.y + (_e1644.y * _e1698)) - _e584.member[1]);
                                let _e1713 = ((_e1638.z + (_e1644.z * _e1698)) - _e584.member[2]);
                                let _e1778 = ((bitcast<f32>((bitcast<u32>(((((_e1651 * _e1707) + (_e1656 * _e1710)) + (_e1659 * _e1713)) - _e1677)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1707) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1710) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1713) & 2147483647u))), _e1617)) * max(max(bitcast<f32>((bitcast<u32>(_e1651) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1656) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1659) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1682) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1642.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1642.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1642.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1640.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1640.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1640.z) & 2147483647u)))))));
                                let _e1779 = (_e1677 / _e1682);
                                if (_e1566 && !(_e1778)) {
                                    let _e1782 = (_e1713 / _e639);
                                    let _e1790 = (((_e1651 * (_e1707 - (_e607 * _e1782))) + (_e1656 * (_e1710 - (_e623 * _e1782)))) / _e1682);
                                    phi_3415_ = select(select(_e1782, (_e1782 + _e1790), (bitcast<f32>((bitcast<u32>(_e1790) & 2147483647u)) <= _e1617)), _e1779, _e1778);
                                } else {
                                    phi_3415_ = _e1779;
                                }
                                let _e1799 = phi_3415_;
                                let _e1801 = select(_e1539, _e1799, (_e1799 < _e1539));
                                let _e1803 = select(_e1534, _e1801, (_e1801 > _e1534));
                                let _e1806 = select(_e1803, 0f, (bitcast<u32>(_e1803) == 2147483648u));
                                let _e1807 = (1f / _e1493);
                                phi_3441_ = SlimbvhTypeE(_e1806, (_e1487 * _e1807), (_e1491 * _e1807), ((_e1566 && (_e1806 >= _e651)) && (_e1806 <= _e1282.member.member_1)));
                                phi_3442_ = SlimbvhTypeE();
                            } else {
                                phi_3441_ = SlimbvhTypeE();
                                phi_3442_ = SlimbvhTypeE(0f, 0f, 0f, _e1566);
                            }
                            let _e1816 = phi_3441_;
                            let _e1818 = phi_3442_;
                            phi_3445_ = _e1816;
                            phi_3446_ = _e1818;
                            phi_3447_ = select(true, false, _e1566);
                        } else {
                            phi_3445_ = SlimbvhTypeE();
                            phi_3446_ = SlimbvhTypeE(0f, 0f, 0f, _e1477);
                            phi_3447_ = true;
                        }
                        let _e1821 = phi_3445_;
                        let _e1823 = phi_3446_;
                        let _e1825 = phi_3447_;
                        if _e1825 {
                            phi_3451_ = _e1823;
                        } else {
                            phi_3451_ = _e1821;
                        }
                        let _e1827 = phi_3451_;
                        if _e1827.member_3 {
                            phi_3460_ = SlimbvhTypeF(_e1827.member, _e1827.member_1, _e1827.member_2, _e1345);
                        } else {
                            phi_3460_ = _e86;
                        }
                        let _e1834 = phi_3460_;
                        if (_e1834.member_3 != 4294967295u) {
                            if (_e1345 != 4294967295u) {
                                if (_e1834.member < _e1282.member.member.member) {
                                    phi_3488_ = true;
                                } else {
                                    if (_e1834.member == _e1282.member.member.member) {
                                        phi_3487_ = (_e1834.member_3 < _e1282.member.member.member_3);
                                    } else {
                                        phi_3487_ = false;
                                    }
                                    let _e1849 = phi_3487_;
                                    phi_3488_ = _e1849;
                                }
                                let _e1851 = phi_3488_;
                                if _e1851 {
                                    phi_3495_ = SlimbvhTypeN(SlimbvhTypeH(_e1834, _e1834.member), _e1282.member_1);
                                } else {
                                    phi_3495_ = _e1282;
                                }
                                let _e1857 = phi_3495_;
                                if _e1857.member_1 {
                                    phi_3501_ = SlimbvhTypeN(SlimbvhTypeH(_e1857.member.member, bitcast<f32>(4286578687u)), _e1857.member_1);
                                } else {
                                    phi_3501_ = _e1857;
                                }
                                let _e1866 = phi_3501_;
                                phi_3502_ = _e1866;
                            } else {
                                phi_3502_ = _e1282;
                            }
                            let _e1868 = phi_3502_;
                            phi_3503_ = _e1868;
                        } else {
                            phi_3503_ = _e1282;
                        }
                        let _e1870 = phi_3503_;
                        phi_2630_ = _e1870;
                    } else {
                        phi_2630_ = SlimbvhTypeN();
                    }
                    let _e1872 = phi_2630_;
                    continue;
                    continuing {
                        phi_2629_ = _e1872;
                        phi_2632_ = _e1297;
                        break if !(_e1303);
                    }
                }
                let _e1875 = local_4;
                let _e1876 = (_e1875 - 1u);
                let _e1879 = local[(_e1876 % 128u)];
                let _e1880 = (_e1879 & 511u);
                let _e1882 = (_e1880 >> bitcast<u32>(3u));
                let _e1885 = ((_e1882 == 0u) || (_e1876 == 4294967295u));
                if _e1885 {
                } else {
                    local[(_e1876 % 128u)] = (((_e1879 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1882);
                }
                let _e1892 = local_5;
                let _e1900 = (((_e1879 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1880 & 3u) & 3u));
                let _e1902 = (_e1900 >> bitcast<u32>(2i));
                if (_e1902 < _e90) {
                    let _e1908 = slimbvh_nodes.member[_e1902].member_1[(_e1900 & 3u)];
                    phi_3561_ = _e1908;
                } else {
                    phi_3561_ = 2147483648u;
                }
                let _e1910 = phi_3561_;
                let _e1912 = local_6;
                let _e2171 = local_8;
                phi_3570_ = _e2171;
                phi_3571_ = select(select(_e1892, _e1876, _e1885), 4294967295u, (_e651 > _e1912.member.member_1));
                phi_3572_ = _e1910;
            } else {
                phi_3570_ = _e757;
                let _e2174 = local_9;
                phi_3571_ = _e2174;
                let _e2177 = local_10;
                phi_3572_ = _e2177;
            }
            let _e1918 = phi_3570_;
            let _e1920 = phi_3571_;
            let _e1922 = phi_3572_;
            phi_1779_ = _e1918;
            phi_1782_ = _e1920;
            phi_1784_ = _e1922;
            let _e2183 = local_11;
            phi_1786_ = _e2183;
        } else {
            phi_1779_ = SlimbvhTypeN();
            phi_1782_ = u32();
            phi_1784_ = u32();
            phi_1786_ = u32();
        }
        let _e1924 = phi_1779_;
        let _e1926 = phi_1782_;
        let _e1928 = phi_1784_;
        let _e1930 = phi_1786_;
        continue;
        continuing {
            phi_1778_ = _e1924;
            phi_1781_ = _e1926;
            phi_1783_ = _e1928;
            phi_1785_ = _e1930;
            break if !(_e764);
        }
    }
    let _e1933 = local_7;
    if (_e1933.member.member.member_3 != 4294967295u) {
        let _e1939 = -((_e154 + _e584.member_4));
        let _e1940 = bitcast<u32>(_e1933.member.member.member);
        let _e1944 = (bitcast<i32>((_e1940 >> bitcast<u32>(23i))) & 255i);
        let _e1945 = (_e1944 + _e1939);
        if (_e1944 == 255i) {
            phi_3629_ = _e1933.member.member.member;
        } else {
            if (_e1944 > 0i) {
                if (_e1945 > 0i) {
                    let _e1949 = (_e1945 < 255i);
                    if _e1949 {
                        phi_3608_ = bitcast<f32>((_e1940 + bitcast<u32>((_e1939 << bitcast<u32>(23i)))));
                    } else {
                        phi_3608_ = f32();
                    }
                    let _e1956 = phi_3608_;
                    phi_3610_ = _e1956;
                    phi_3611_ = select(true, false, _e1949);
                } else {
                    phi_3610_ = f32();
                    phi_3611_ = true;
                }
                let _e1959 = phi_3610_;
                let _e1961 = phi_3611_;
                phi_3612_ = _e1959;
                phi_3613_ = _e1961;
            } else {
                phi_3612_ = f32();
                phi_3613_ = true;
            }
            let _e1963 = phi_3612_;
            let _e1965 = phi_3613_;
            if _e1965 {
                let _e1966 = (_e1940 & 2147483648u);
                let _e1973 = ((_e1940 & 8388607u) | (select(0u, 1u, ((_e1940 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e1977 = (_e1973 == 0u);
                if _e1977 {
                    phi_4289_ = bitcast<f32>(_e1966);
                } else {
                    let _e1982 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1973)), 32u, _e1977) - 8u);
                    let _e1985 = (_e1973 << bitcast<u32>((_e1982 & 31u)));
                    let _e1987 = ((_e1945 + select(0i, 1i, (_e1944 == 0i))) - bitcast<i32>(_e1982));
                    if (_e1987 >= 255i) {
                        phi_4279_ = bitcast<f32>((_e1966 | 2139095040u));
                        phi_4280_ = f32();
                        phi_4281_ = true;
                    } else {
                        let _e1989 = (_e1987 > 0i);
                        if _e1989 {
                            phi_4273_ = bitcast<f32>(((_e1966 | (bitcast<u32>(_e1987) << bitcast<u32>(23i))) | (_e1985 & 8388607u)));
                            phi_4274_ = f32();
                        } else {
                            if (_e1987 < -24i) {
                                phi_4239_ = 26u;
                            } else {
                                phi_4239_ = bitcast<u32>((1i - _e1987));
                            }
                            let _e1994 = phi_4239_;
                            let _e1995 = (_e1994 & 31u);
                            let _e1997 = (_e1985 >> bitcast<u32>(_e1995));
                            let _e2001 = (_e1985 & ((1u << bitcast<u32>(_e1995)) - 1u));
                            let _e2005 = (1u << bitcast<u32>(((_e1994 - 1u) & 31u)));
                            if (_e2001 > _e2005) {
                                phi_4260_ = true;
                            } else {
                                if (_e2001 == _e2005) {
                                    phi_4257_ = ((_e1997 & 1u) == 1u);
                                } else {
                                    phi_4257_ = false;
                                }
                                let _e2011 = phi_4257_;
                                phi_4260_ = _e2011;
                            }
                            let _e2013 = phi_4260_;
                            phi_4273_ = f32();
                            phi_4274_ = bitcast<f32>((_e1966 | (_e1997 + select(0u, 1u, _e2013))));
                        }
                        let _e2026 = phi_4273_;
                        let _e2028 = phi_4274_;
                        phi_4279_ = _e2026;
                        phi_4280_ = _e2028;
                        phi_4281_ = _e1989;
                    }
                    let _e2032 = phi_4279_;
                    let _e2034 = phi_4280_;
                    let _e2036 = phi_4281_;
                    phi_4289_ = select(_e2034, _e2032, _e2036);
                }
                let _e2040 = phi_4289_;
                phi_3628_ = _e2040;
            } else {
                phi_3628_ = _e1963;
            }
            let _e2042 = phi_3628_;
            phi_3629_ = _e2042;
        }
        let _e2044 = phi_3629_;
        let _e2045 = bitcast<u32>(_e2044);
        if ((_e2045 & 2147483647u) >= 2139095040u) {
            phi_3641_ = bitcast<f32>(((_e2045 & 2147483648u) | 2139095039u));
        } else {
            phi_3641_ = _e2044;
        }
        let _e2052 = phi_3641_;
        phi_3646_ = SlimbvhTypeF(_e2052, _e1933.member.member.member_1, _e1933.member.member.member_2, _e1933.member.member.member_3);
    } else {
        phi_3646_ = _e86;
    }
    let _e2057 = phi_3646_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2057.member), bitcast<u32>(_e2057.member_1), bitcast<u32>(_e2057.member_2), _e2057.member_3);
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
