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
    var phi_677_: u32;
    var phi_683_: u32;
    var phi_689_: u32;
    var phi_954_: i32;
    var phi_965_: i32;
    var phi_1079_: i32;
    var phi_1208_: i32;
    var phi_1230_: u32;
    var phi_1231_: u32;
    var phi_1232_: bool;
    var phi_1266_: i32;
    var phi_1288_: u32;
    var phi_1289_: u32;
    var phi_1290_: bool;
    var phi_851_: i32;
    var phi_857_: u32;
    var phi_876_: u32;
    var phi_877_: u32;
    var phi_878_: bool;
    var phi_896_: i32;
    var phi_902_: u32;
    var phi_921_: u32;
    var phi_922_: u32;
    var phi_923_: bool;
    var phi_1300_: SlimbvhTypeC;
    var phi_1529_: SlimbvhTypeN;
    var phi_1592_: array<f32, 3>;
    var phi_1593_: array<f32, 3>;
    var phi_1611_: array<f32, 3>;
    var phi_1612_: array<f32, 3>;
    var phi_1785_: SlimbvhTypeN;
    var phi_1788_: u32;
    var phi_1790_: u32;
    var phi_1792_: u32;
    var phi_1801_: u32;
    var phi_1804_: u32;
    var phi_1806_: u32;
    var phi_1908_: SlimbvhTypeK;
    var phi_1909_: SlimbvhTypeK;
    var phi_1968_: SlimbvhTypeK;
    var phi_1969_: SlimbvhTypeK;
    var phi_2028_: SlimbvhTypeK;
    var phi_2029_: SlimbvhTypeK;
    var phi_2513_: u32;
    var phi_2526_: u32;
    var phi_2539_: u32;
    var phi_2552_: u32;
    var phi_4011_: SlimbvhTypeD;
    var phi_4023_: SlimbvhTypeD;
    var phi_4035_: SlimbvhTypeD;
    var phi_4047_: SlimbvhTypeD;
    var phi_4059_: SlimbvhTypeD;
    var phi_2633_: u32;
    var phi_2638_: u32;
    var phi_2639_: u32;
    var phi_2663_: u32;
    var phi_1802_: u32;
    var phi_1805_: u32;
    var phi_1807_: u32;
    var local_1: bool;
    var local_2: u32;
    var local_3: u32;
    var phi_2679_: SlimbvhTypeN;
    var phi_2682_: SlimbvhTypeD;
    var phi_2683_: SlimbvhTypeD;
    var phi_2705_: SlimbvhTypeD;
    var phi_2784_: array<vec4<f32>, 3>;
    var phi_2785_: array<vec4<f32>, 3>;
    var phi_2865_: array<vec4<f32>, 3>;
    var phi_2866_: array<vec4<f32>, 3>;
    var phi_2889_: array<f32, 3>;
    var phi_2890_: array<f32, 3>;
    var phi_2904_: array<f32, 3>;
    var phi_2905_: array<f32, 3>;
    var phi_2919_: array<f32, 3>;
    var phi_2920_: array<f32, 3>;
    var phi_3279_: f32;
    var phi_3280_: f32;
    var phi_3281_: f32;
    var phi_3282_: f32;
    var phi_3283_: vec3<f32>;
    var phi_3284_: vec3<f32>;
    var phi_3285_: vec3<f32>;
    var phi_3286_: vec3<f32>;
    var phi_3465_: f32;
    var phi_3491_: SlimbvhTypeE;
    var phi_3492_: SlimbvhTypeE;
    var phi_3495_: SlimbvhTypeE;
    var phi_3496_: SlimbvhTypeE;
    var phi_3497_: bool;
    var phi_3501_: SlimbvhTypeE;
    var phi_3510_: SlimbvhTypeF;
    var phi_3537_: bool;
    var phi_3538_: bool;
    var phi_3545_: SlimbvhTypeN;
    var phi_3551_: SlimbvhTypeN;
    var phi_3552_: SlimbvhTypeN;
    var phi_3553_: SlimbvhTypeN;
    var phi_2680_: SlimbvhTypeN;
    var local_4: u32;
    var local_5: u32;
    var phi_3612_: u32;
    var local_6: SlimbvhTypeN;
    var phi_3621_: SlimbvhTypeN;
    var phi_3622_: u32;
    var phi_3623_: u32;
    var phi_1786_: SlimbvhTypeN;
    var phi_1789_: u32;
    var phi_1791_: u32;
    var phi_1793_: u32;
    var local_7: SlimbvhTypeN;
    var phi_3659_: f32;
    var phi_3661_: f32;
    var phi_3662_: bool;
    var phi_3663_: f32;
    var phi_3664_: bool;
    var phi_4290_: u32;
    var phi_4308_: bool;
    var phi_4311_: bool;
    var phi_4324_: f32;
    var phi_4325_: f32;
    var phi_4330_: f32;
    var phi_4331_: f32;
    var phi_4332_: bool;
    var phi_4340_: f32;
    var phi_3679_: f32;
    var phi_3680_: f32;
    var phi_3692_: f32;
    var phi_3697_: SlimbvhTypeF;
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
        phi_677_ = 0u;
    } else {
        phi_677_ = select(2u, 1u, (_e166 == _e174));
    }
    let _e192 = phi_677_;
    let _e193 = (_e192 == 2u);
    if _e193 {
        phi_683_ = 0u;
    } else {
        phi_683_ = (_e192 + 1u);
    }
    let _e196 = phi_683_;
    let _e197 = (_e196 == 2u);
    if _e197 {
        phi_689_ = 0u;
    } else {
        phi_689_ = (_e196 + 1u);
    }
    let _e200 = phi_689_;
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
            phi_851_ = 255i;
        } else {
            phi_851_ = (bitcast<i32>((_e162 >> bitcast<u32>(23i))) + _e503);
        }
        let _e528 = phi_851_;
        if (_e162 == 0u) {
            phi_857_ = 0u;
        } else {
            phi_857_ = (_e162 | 8388608u);
        }
        let _e532 = phi_857_;
        if (_e528 <= 0i) {
            phi_877_ = u32();
            phi_878_ = true;
        } else {
            let _e539 = (_e532 == 0u);
            if _e539 {
                phi_876_ = u32();
            } else {
                phi_876_ = select(((bitcast<u32>(_e528) << bitcast<u32>(23i)) | (_e532 & 8388607u)), 2139095039u, (_e528 >= 255i));
            }
            let _e543 = phi_876_;
            phi_877_ = _e543;
            phi_878_ = _e539;
        }
        let _e545 = phi_877_;
        let _e547 = phi_878_;
        if (_e170 >= 2139095040u) {
            phi_896_ = 255i;
        } else {
            phi_896_ = (bitcast<i32>((_e170 >> bitcast<u32>(23i))) + _e503);
        }
        let _e558 = phi_896_;
        if (_e170 == 0u) {
            phi_902_ = 0u;
        } else {
            phi_902_ = (_e170 | 8388608u);
        }
        let _e562 = phi_902_;
        if (_e558 <= 0i) {
            phi_922_ = u32();
            phi_923_ = true;
        } else {
            let _e569 = (_e562 == 0u);
            if _e569 {
                phi_921_ = u32();
            } else {
                phi_921_ = select(((bitcast<u32>(_e558) << bitcast<u32>(23i)) | (_e562 & 8388607u)), 2139095039u, (_e558 >= 255i));
            }
            let _e573 = phi_921_;
            phi_922_ = _e573;
            phi_923_ = _e569;
        }
        let _e575 = phi_922_;
        let _e577 = phi_923_;
        phi_1300_ = SlimbvhTypeC(array<f32, 3>((_e203 * _e508), (_e207 * _e508), (_e210 * _e508)), array<f32, 3>((_e212 * _e513), (_e214 * _e513), (_e216 * _e513)), bitcast<f32>(((_e161 & 2147483648u) | select(_e545, 0u, _e547))), bitcast<f32>(((_e169 & 2147483648u) | select(_e575, 0u, _e577))), _e502);
    } else {
        let _e249 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e174, _e187))) & 2147483647u);
        if (_e249 >= 8388608u) {
            phi_954_ = (bitcast<i32>((_e249 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_954_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e249)), 32u, (_e249 == 0u))));
        }
        let _e263 = phi_954_;
        let _e264 = (_e154 + _e263);
        if (_e154 < -126i) {
            phi_965_ = -126i;
        } else {
            phi_965_ = select(_e154, 127i, (_e154 > 127i));
        }
        let _e269 = phi_965_;
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
            phi_1079_ = -126i;
        } else {
            phi_1079_ = select(_e333, 127i, (_e333 > 127i));
        }
        let _e338 = phi_1079_;
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
            phi_1208_ = 255i;
        } else {
            phi_1208_ = (((_e411 + select(0i, 1i, (_e411 == 0i))) - _e418) + _e264);
        }
        let _e426 = phi_1208_;
        let _e430 = (_e408 << bitcast<u32>(((_e418 & 31i) & 31i)));
        if (_e426 <= 0i) {
            phi_1231_ = u32();
            phi_1232_ = true;
        } else {
            let _e437 = (_e430 == 0u);
            if _e437 {
                phi_1230_ = u32();
            } else {
                phi_1230_ = select(((bitcast<u32>(_e426) << bitcast<u32>(23i)) | (_e430 & 8388607u)), 2139095039u, (_e426 >= 255i));
            }
            let _e441 = phi_1230_;
            phi_1231_ = _e441;
            phi_1232_ = _e437;
        }
        let _e443 = phi_1231_;
        let _e445 = phi_1232_;
        let _e456 = ((_e170 & 8388607u) | (select(0u, 1u, ((_e170 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e459 = bitcast<i32>((_e170 >> bitcast<u32>(23i)));
        let _e466 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e456)), 32u, (_e456 == 0u))) - 8i);
        if (_e459 == 255i) {
            phi_1266_ = 255i;
        } else {
            phi_1266_ = (((_e459 + select(0i, 1i, (_e459 == 0i))) - _e466) + _e264);
        }
        let _e474 = phi_1266_;
        let _e478 = (_e456 << bitcast<u32>(((_e466 & 31i) & 31i)));
        if (_e474 <= 0i) {
            phi_1289_ = u32();
            phi_1290_ = true;
        } else {
            let _e485 = (_e478 == 0u);
            if _e485 {
                phi_1288_ = u32();
            } else {
                phi_1288_ = select(((bitcast<u32>(_e474) << bitcast<u32>(23i)) | (_e478 & 8388607u)), 2139095039u, (_e474 >= 255i));
            }
            let _e489 = phi_1288_;
            phi_1289_ = _e489;
            phi_1290_ = _e485;
        }
        let _e491 = phi_1289_;
        let _e493 = phi_1290_;
        phi_1300_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e281 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e281 & 2147483648u))), _e203, _e283) * _e274) * select(0.00000011920929f, 1f, _e283)) * _e280), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e298 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e298 & 2147483648u))), _e207, _e300) * _e274) * select(0.00000011920929f, 1f, _e300)) * _e280), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e210, _e317) * _e274) * select(0.00000011920929f, 1f, _e317)) * _e280)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e350 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e350 & 2147483648u))), _e212, _e352) * _e343) * select(0.00000011920929f, 1f, _e352)) * _e349), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e367 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e367 & 2147483648u))), _e214, _e369) * _e343) * select(0.00000011920929f, 1f, _e369)) * _e349), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e216, _e386) * _e343) * select(0.00000011920929f, 1f, _e386)) * _e349)), bitcast<f32>(((_e161 & 2147483648u) | select(_e443, 0u, _e445))), bitcast<f32>(((_e169 & 2147483648u) | select(_e491, 0u, _e493))), _e263);
    }
    let _e584 = phi_1300_;
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
        phi_1529_ = SlimbvhTypeN(SlimbvhTypeH(_e86, _e650), true);
    } else {
        phi_1529_ = SlimbvhTypeN(SlimbvhTypeH(_e86, _e650), false);
    }
    let _e660 = phi_1529_;
    let _e665 = (_e196 & 3u);
    let _e666 = (_e200 & 3u);
    let _e667 = (_e192 & 3u);
    let _e670 = (bitcast<u32>(_e611) >> bitcast<u32>(31i));
    let _e673 = (bitcast<u32>(_e627) >> bitcast<u32>(31i));
    let _e676 = (bitcast<u32>(_e643) >> bitcast<u32>(31i));
    let _e680 = (f32(bitcast<i32>(_e100)) * _e136);
    let _e682 = (f32(bitcast<i32>(_e104)) * _e136);
    let _e684 = (f32(bitcast<i32>(_e108)) * _e136);
    let _e685 = (_e665 == 0u);
    if _e685 {
        phi_1593_ = array<f32, 3>(_e680, _e682, _e684);
    } else {
        if (_e665 == 1u) {
            phi_1592_ = array<f32, 3>(_e682, _e684, _e680);
        } else {
            phi_1592_ = array<f32, 3>(_e684, _e680, _e682);
        }
        let _e690 = phi_1592_;
        phi_1593_ = _e690;
    }
    let _e693 = phi_1593_;
    let _e695 = (f32(bitcast<i32>(_e116)) * _e136);
    let _e697 = (f32(bitcast<i32>(_e120)) * _e136);
    let _e699 = (f32(bitcast<i32>(_e124)) * _e136);
    if _e685 {
        phi_1612_ = array<f32, 3>(_e695, _e697, _e699);
    } else {
        if (_e665 == 1u) {
            phi_1611_ = array<f32, 3>(_e697, _e699, _e695);
        } else {
            phi_1611_ = array<f32, 3>(_e699, _e695, _e697);
        }
        let _e704 = phi_1611_;
        phi_1612_ = _e704;
    }
    let _e707 = phi_1612_;
    let _e718 = ((_e693[0] - _e608) * _e611);
    let _e719 = ((_e707[0] - _e609) * _e611);
    let _e720 = vec4<f32>(_e718, f32(), _e719, f32());
    let _e723 = ((_e693[1] - _e624) * _e627);
    let _e724 = ((_e707[1] - _e625) * _e627);
    let _e725 = vec4<f32>(_e723, f32(), _e724, f32());
    let _e728 = ((_e693[2] - _e640) * _e643);
    let _e729 = ((_e707[2] - _e641) * _e643);
    let _e730 = vec4<f32>(_e728, f32(), _e729, f32());
    let _e731 = vec4<f32>(_e719, f32(), _e718, f32());
    let _e733 = vec4<f32>(_e724, f32(), _e723, f32());
    let _e735 = vec4<f32>(_e729, f32(), _e728, f32());
    phi_1785_ = _e660;
    phi_1788_ = select(4294967295u, select(4294967295u, 0u, (_e651 <= _e650)), (max(max(max(min(_e720, _e731).x, min(_e725, _e733).x), min(_e730, _e735).x), _e651) <= min((min(min(max(_e720, _e731).x, max(_e725, _e733).x), max(_e730, _e735).x) + (max(max(_e730, _e735).x, -(min(_e730, _e735).x)) * 0.0000019073523f)), _e660.member.member_1)));
    phi_1790_ = select(0u, 2147483648u, (_e90 == 0u));
    phi_1792_ = (_e90 + 1u);
    loop {
        let _e759 = phi_1785_;
        let _e761 = phi_1788_;
        let _e763 = phi_1790_;
        let _e765 = phi_1792_;
        local_7 = _e759;
        let _e766 = (_e761 <= 2147483647u);
        if _e766 {
            phi_1801_ = _e761;
            phi_1804_ = _e763;
            phi_1806_ = _e765;
            loop {
                let _e768 = phi_1801_;
                let _e770 = phi_1804_;
                let _e772 = phi_1806_;
                local_2 = _e770;
                local_3 = _e770;
                local_4 = _e768;
                local_5 = _e768;
                local_9 = _e768;
                local_10 = _e770;
                local_11 = _e772;
                let _e773 = (_e768 <= 2147483647u);
                let _e776 = (_e773 && !((_e770 >= _e90)));
                local_1 = _e773;
                if _e776 {
                    let _e782 = slimbvh_nodes.member[_e770].member[select(_e665, 2u, (2u < _e665))];
                    let _e788 = slimbvh_nodes.member[_e770].member[select(_e666, 2u, (2u < _e666))];
                    let _e794 = slimbvh_nodes.member[_e770].member[select(_e667, 2u, (2u < _e667))];
                    let _e797 = bitcast<u32>(_e136);
                    let _e802 = bitcast<f32>(_e782.x);
                    let _e807 = (_e802 + (f32((_e782.w >> bitcast<u32>(5u))) * _e136));
                    if (_e670 == 0u) {
                        phi_1908_ = SlimbvhTypeK(_e782.z, _e807);
                        phi_1909_ = SlimbvhTypeK(_e782.y, _e802);
                    } else {
                        phi_1908_ = SlimbvhTypeK(_e782.y, _e802);
                        phi_1909_ = SlimbvhTypeK(_e782.z, _e807);
                    }
                    let _e818 = phi_1908_;
                    let _e820 = phi_1909_;
                    let _e824 = bitcast<f32>(((_e797 + ((_e782.w & 31u) << bitcast<u32>(23i))) ^ (_e670 << bitcast<u32>(31i))));
                    let _e864 = bitcast<f32>(_e788.x);
                    let _e869 = (_e864 + (f32((_e788.w >> bitcast<u32>(5u))) * _e136));
                    if (_e673 == 0u) {
                        phi_1968_ = SlimbvhTypeK(_e788.z, _e869);
                        phi_1969_ = SlimbvhTypeK(_e788.y, _e864);
                    } else {
                        phi_1968_ = SlimbvhTypeK(_e788.y, _e864);
                        phi_1969_ = SlimbvhTypeK(_e788.z, _e869);
                    }
                    let _e880 = phi_1968_;
                    let _e882 = phi_1969_;
                    let _e886 = bitcast<f32>(((_e797 + ((_e788.w & 31u) << bitcast<u32>(23i))) ^ (_e673 << bitcast<u32>(31i))));
                    let _e926 = bitcast<f32>(_e794.x);
                    let _e931 = (_e926 + (f32((_e794.w >> bitcast<u32>(5u))) * _e136));
                    if (_e676 == 0u) {
                        phi_2028_ = SlimbvhTypeK(_e794.z, _e931);
                        phi_2029_ = SlimbvhTypeK(_e794.y, _e926);
                    } else {
                        phi_2028_ = SlimbvhTypeK(_e794.y, _e926);
                        phi_2029_ = SlimbvhTypeK(_e794.z, _e931);
                    }
                    let _e942 = phi_2028_;
                    let _e944 = phi_2029_;
                    let _e948 = bitcast<f32>(((_e797 + ((_e794.w & 31u) << bitcast<u32>(23i))) ^ (_e676 << bitcast<u32>(31i))));
                    let _e984 = (_e824 * _e611);
                    let _e991 = (((_e820.member_1 - _e608) * _e611) + (bitcast<f32>((bitcast<u32>(_e984) & 2147483647u)) * -0.00012207031f));
                    let _e1000 = (-(_e824) * _e611);
                    let _e1007 = (((_e818.member_1 - _e609) * _e611) + (bitcast<f32>((bitcast<u32>(_e1000) & 2147483647u)) * 0.00012207031f));
                    let _e1016 = (_e886 * _e627);
                    let _e1023 = (((_e882.member_1 - _e624) * _e627) + (bitcast<f32>((bitcast<u32>(_e1016) & 2147483647u)) * -0.00012207031f));
                    let _e1032 = (-(_e886) * _e627);
                    let _e1039 = (((_e880.member_1 - _e625) * _e627) + (bitcast<f32>((bitcast<u32>(_e1032) & 2147483647u)) * 0.00012207031f));
                    let _e1048 = (_e948 * _e643);
                    let _e1055 = (((_e944.member_1 - _e640) * _e643) + (bitcast<f32>((bitcast<u32>(_e1048) & 2147483647u)) * -0.00012207031f));
                    let _e1060 = ((f32((_e944.member & 255u)) * _e1048) + _e1055);
                    let _e1061 = ((f32(((_e944.member >> bitcast<u32>(8u)) & 255u)) * _e1048) + _e1055);
                    let _e1062 = ((f32(((_e944.member >> bitcast<u32>(16u)) & 255u)) * _e1048) + _e1055);
                    let _e1063 = ((f32(((_e944.member >> bitcast<u32>(24u)) & 255u)) * _e1048) + _e1055);
                    let _e1064 = (-(_e948) * _e643);
                    let _e1071 = (((_e942.member_1 - _e641) * _e643) + (bitcast<f32>((bitcast<u32>(_e1064) & 2147483647u)) * 0.00012207031f));
                    let _e1076 = ((f32((_e942.member & 255u)) * _e1064) + _e1071);
                    let _e1077 = ((f32(((_e942.member >> bitcast<u32>(8u)) & 255u)) * _e1064) + _e1071);
                    let _e1078 = ((f32(((_e942.member >> bitcast<u32>(16u)) & 255u)) * _e1064) + _e1071);
                    let _e1079 = ((f32(((_e942.member >> bitcast<u32>(24u)) & 255u)) * _e1064) + _e1071);
                    let _e1112 = max(max(max(((f32((_e820.member & 255u)) * _e984) + _e991), ((f32((_e882.member & 255u)) * _e1016) + _e1023)), _e1060), _e651);
                    let _e1113 = max(max(max(((f32(((_e820.member >> bitcast<u32>(8u)) & 255u)) * _e984) + _e991), ((f32(((_e882.member >> bitcast<u32>(8u)) & 255u)) * _e1016) + _e1023)), _e1061), _e651);
                    let _e1114 = max(max(max(((f32(((_e820.member >> bitcast<u32>(16u)) & 255u)) * _e984) + _e991), ((f32(((_e882.member >> bitcast<u32>(16u)) & 255u)) * _e1016) + _e1023)), _e1062), _e651);
                    let _e1115 = max(max(max(((f32(((_e820.member >> bitcast<u32>(24u)) & 255u)) * _e984) + _e991), ((f32(((_e882.member >> bitcast<u32>(24u)) & 255u)) * _e1016) + _e1023)), _e1063), _e651);
                    let _e1120 = (_e759.member.member_1 + (bitcast<f32>((bitcast<u32>(_e759.member.member_1) & 2147483647u)) * 0.0000004768374f));
                    if (_e1112 <= min((min(min(((f32((_e818.member & 255u)) * _e1000) + _e1007), ((f32((_e880.member & 255u)) * _e1032) + _e1039)), _e1076) + (max(_e1076, -(_e1060)) * 0.0000023841915f)), _e1120)) {
                        phi_2513_ = (((bitcast<u32>(_e1112) ^ select(0u, 4294967288u, _e660.member_1)) & 2147483640u) | 4u);
                    } else {
                        phi_2513_ = 4294967288u;
                    }
                    let _e1135 = phi_2513_;
                    if (_e1113 <= min((min(min(((f32(((_e818.member >> bitcast<u32>(8u)) & 255u)) * _e1000) + _e1007), ((f32(((_e880.member >> bitcast<u32>(8u)) & 255u)) * _e1032) + _e1039)), _e1077) + (max(_e1077, -(_e1061)) * 0.0000023841915f)), _e1120)) {
                        phi_2526_ = ((((bitcast<u32>(_e1113) ^ select(0u, 4294967288u, _e660.member_1)) & 2147483640u) | 4u) | 1u);
                    } else {
                        phi_2526_ = 4294967288u;
                    }
                    let _e1143 = phi_2526_;
                    if (_e1114 <= min((min(min(((f32(((_e818.member >> bitcast<u32>(16u)) & 255u)) * _e1000) + _e1007), ((f32(((_e880.member >> bitcast<u32>(16u)) & 255u)) * _e1032) + _e1039)), _e1078) + (max(_e1078, -(_e1062)) * 0.0000023841915f)), _e1120)) {
                        phi_2539_ = ((((bitcast<u32>(_e1114) ^ select(0u, 4294967288u, _e660.member_1)) & 2147483640u) | 4u) | 2u);
                    } else {
                        phi_2539_ = 4294967288u;
                    }
                    let _e1151 = phi_2539_;
                    if (_e1115 <= min((min(min(((f32(((_e818.member >> bitcast<u32>(24u)) & 255u)) * _e1000) + _e1007), ((f32(((_e880.member >> bitcast<u32>(24u)) & 255u)) * _e1032) + _e1039)), _e1079) + (max(_e1079, -(_e1063)) * 0.0000023841915f)), _e1120)) {
                        phi_2552_ = ((((bitcast<u32>(_e1115) ^ select(0u, 4294967288u, _e660.member_1)) & 2147483640u) | 4u) | 3u);
                    } else {
                        phi_2552_ = 4294967288u;
                    }
                    let _e1159 = phi_2552_;
                    if (_e1135 < _e1143) {
                        phi_4011_ = SlimbvhTypeD(_e1135, _e1143);
                    } else {
                        phi_4011_ = SlimbvhTypeD(_e1143, _e1135);
                    }
                    let _e1164 = phi_4011_;
                    if (_e1151 < _e1159) {
                        phi_4023_ = SlimbvhTypeD(_e1151, _e1159);
                    } else {
                        phi_4023_ = SlimbvhTypeD(_e1159, _e1151);
                    }
                    let _e1171 = phi_4023_;
                    if (_e1164.member < _e1171.member) {
                        phi_4035_ = SlimbvhTypeD(_e1164.member, _e1171.member);
                    } else {
                        phi_4035_ = SlimbvhTypeD(_e1171.member, _e1164.member);
                    }
                    let _e1178 = phi_4035_;
                    if (_e1164.member_1 < _e1171.member_1) {
                        phi_4047_ = SlimbvhTypeD(_e1164.member_1, _e1171.member_1);
                    } else {
                        phi_4047_ = SlimbvhTypeD(_e1171.member_1, _e1164.member_1);
                    }
                    let _e1185 = phi_4047_;
                    if (_e1185.member < _e1178.member_1) {
                        phi_4059_ = SlimbvhTypeD(_e1185.member, _e1178.member_1);
                    } else {
                        phi_4059_ = SlimbvhTypeD(_e1178.member_1, _e1185.member);
                    }
                    let _e1192 = phi_4059_;
                    let _e1207 = (((_e1178.member & 7u) | ((_e1192.member & 7u) << bitcast<u32>(3u))) | (((_e1192.member_1 & 7u) | ((_e1185.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                    if (_e1207 == 0u) {
                        let _e1225 = (_e768 - 1u);
                        let _e1228 = local[(_e1225 % 128u)];
                        let _e1229 = (_e1228 & 511u);
                        let _e1231 = (_e1229 >> bitcast<u32>(3u));
                        let _e1234 = ((_e1231 == 0u) || (_e1225 == 4294967295u));
                        if _e1234 {
                        } else {
                            local[(_e1225 % 128u)] = (((_e1228 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1231);
                        }
                        phi_2638_ = select(_e768, _e1225, _e1234);
                        phi_2639_ = (((_e1228 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1229 & 3u) & 3u));
                    } else {
                        let _e1210 = (_e1207 >> bitcast<u32>(3u));
                        if (_e1210 == 0u) {
                            phi_2633_ = _e768;
                        } else {
                            local[(_e768 % 128u)] = ((_e770 << bitcast<u32>(9u)) | _e1210);
                            phi_2633_ = (_e768 + 1u);
                        }
                        let _e1219 = phi_2633_;
                        phi_2638_ = _e1219;
                        phi_2639_ = ((_e770 << bitcast<u32>(2i)) | ((_e1207 & 3u) & 3u));
                    }
                    let _e1249 = phi_2638_;
                    let _e1251 = phi_2639_;
                    let _e1253 = (_e1251 >> bitcast<u32>(2i));
                    if (_e1253 < _e90) {
                        let _e1259 = slimbvh_nodes.member[_e1253].member_1[(_e1251 & 3u)];
                        phi_2663_ = _e1259;
                    } else {
                        phi_2663_ = 2147483648u;
                    }
                    let _e1261 = phi_2663_;
                    let _e1262 = (_e772 - 1u);
                    phi_1802_ = select(_e1249, 4294967295u, (_e1262 == 0u));
                    phi_1805_ = _e1261;
                    phi_1807_ = _e1262;
                } else {
                    phi_1802_ = u32();
                    phi_1805_ = u32();
                    phi_1807_ = u32();
                }
                let _e1266 = phi_1802_;
                let _e1268 = phi_1805_;
                let _e1270 = phi_1807_;
                continue;
                continuing {
                    phi_1801_ = _e1266;
                    phi_1804_ = _e1268;
                    phi_1806_ = _e1270;
                    break if !(_e776);
                }
            }
            let _e1273 = local_1;
            if _e1273 {
                let _e1275 = local_2;
                let _e1278 = local_3;
                phi_2679_ = _e759;
                phi_2682_ = SlimbvhTypeD(0u, ((_e1278 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e1284 = phi_2679_;
                    let _e1286 = phi_2682_;
                    local_6 = _e1284;
                    local_8 = _e1284;
                    if (_e1286.member < _e1286.member_1) {
                        phi_2683_ = SlimbvhTypeD((_e1286.member + 1u), _e1286.member_1);
                        phi_2705_ = SlimbvhTypeD(1u, _e1286.member);
                    } else {
                        phi_2683_ = _e1286;
                        phi_2705_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                    }
                    let _e1299 = phi_2683_;
                    let _e1301 = phi_2705_;
                    let _e1305 = (bitcast<i32>(_e1301.member) != 0i);
                    if _e1305 {
                        let _e1306 = ((_e1275 & 268435455u) + _e1301.member_1);
                        let _e1307 = (_e1306 / 2u);
                        let _e1308 = (_e1306 % 2u);
                        let _e1309 = (_e1307 >= arrayLength((&slimbvh_triangles.member)));
                        if _e1309 {
                            phi_2785_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e1310 = (2u * _e1308);
                            let _e1314 = slimbvh_triangles.member[_e1307][_e1310];
                            let _e1319 = slimbvh_triangles.member[_e1307][(_e1310 + 1u)];
                            let _e1324 = slimbvh_triangles.member[_e1307][(_e1310 + 2u)];
                            if (_e1308 == 0u) {
                                phi_2784_ = array<vec4<f32>, 3>(_e1314, _e1319, _e1324);
                            } else {
                                phi_2784_ = array<vec4<f32>, 3>(vec4<f32>(_e1314.z, _e1314.w, _e1319.x, _e1319.y), vec4<f32>(_e1319.z, _e1319.w, _e1324.x, _e1324.y), vec4<f32>(_e1324.z, _e1324.w, 0f, 0f));
                            }
                            let _e1342 = phi_2784_;
                            phi_2785_ = _e1342;
                        }
                        let _e1344 = phi_2785_;
                        let _e1347 = bitcast<u32>(_e1344[2].y);
                        if _e1309 {
                            phi_2866_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e1348 = (2u * _e1308);
                            let _e1352 = slimbvh_triangles.member[_e1307][_e1348];
                            let _e1357 = slimbvh_triangles.member[_e1307][(_e1348 + 1u)];
                            let _e1362 = slimbvh_triangles.member[_e1307][(_e1348 + 2u)];
                            if (_e1308 == 0u) {
                                phi_2865_ = array<vec4<f32>, 3>(_e1352, _e1357, _e1362);
                            } else {
                                phi_2865_ = array<vec4<f32>, 3>(vec4<f32>(_e1352.z, _e1352.w, _e1357.x, _e1357.y), vec4<f32>(_e1357.z, _e1357.w, _e1362.x, _e1362.y), vec4<f32>(_e1362.z, _e1362.w, 0f, 0f));
                            }
                            let _e1380 = phi_2865_;
                            phi_2866_ = _e1380;
                        }
                        let _e1382 = phi_2866_;
                        if _e201 {
                            phi_2890_ = array<f32, 3>(_e1382[0].x, _e1382[0].y, _e1382[0].z);
                        } else {
                            if (_e196 == 1u) {
                                phi_2889_ = array<f32, 3>(_e1382[0].y, _e1382[0].z, _e1382[0].x);
                            } else {
                                phi_2889_ = array<f32, 3>(_e1382[0].z, _e1382[0].x, _e1382[0].y);
                            }
                            let _e1405 = phi_2889_;
                            phi_2890_ = _e1405;
                        }
                        let _e1408 = phi_2890_;
                        if _e201 {
                            phi_2905_ = array<f32, 3>(_e1382[0].w, _e1382[1].x, _e1382[1].y);
                        } else {
                            if (_e196 == 1u) {
                                phi_2904_ = array<f32, 3>(_e1382[1].x, _e1382[1].y, _e1382[0].w);
                            } else {
                                phi_2904_ = array<f32, 3>(_e1382[1].y, _e1382[0].w, _e1382[1].x);
                            }
                            let _e1413 = phi_2904_;
                            phi_2905_ = _e1413;
                        }
                        let _e1416 = phi_2905_;
                        if _e201 {
                            phi_2920_ = array<f32, 3>(_e1382[1].z, _e1382[1].w, _e1382[2].x);
                        } else {
                            if (_e196 == 1u) {
                                phi_2919_ = array<f32, 3>(_e1382[1].w, _e1382[2].x, _e1382[1].z);
                            } else {
                                phi_2919_ = array<f32, 3>(_e1382[2].x, _e1382[1].z, _e1382[1].w);
                            }
                            let _e1421 = phi_2919_;
                            phi_2920_ = _e1421;
                        }
                        let _e1424 = phi_2920_;
                        let _e1438 = (_e1408[2] - _e584.member[2]);
                        let _e1441 = (((_e1408[0] - _e584.member[0]) * _e639) - (_e1438 * _e607));
                        let _e1444 = (((_e1408[1] - _e584.member[1]) * _e639) - (_e1438 * _e623));
                        let _e1447 = (_e1416[2] - _e584.member[2]);
                        let _e1450 = (((_e1416[0] - _e584.member[0]) * _e639) - (_e1447 * _e607));
                        let _e1453 = (((_e1416[1] - _e584.member[1]) * _e639) - (_e1447 * _e623));
                        let _e1456 = (_e1424[2] - _e584.member[2]);
                        let _e1459 = (((_e1424[0] - _e584.member[0]) * _e639) - (_e1456 * _e607));
                        let _e1462 = (((_e1424[1] - _e584.member[1]) * _e639) - (_e1456 * _e623));
                        let _e1463 = (_e1459 * _e1453);
                        let _e1464 = (_e1462 * _e1450);
                        let _e1465 = (_e1441 * _e1462);
                        let _e1466 = (_e1444 * _e1459);
                        let _e1467 = (_e1450 * _e1444);
                        let _e1468 = (_e1453 * _e1441);
                        let _e1473 = (((_e1463 >= _e1464) && (_e1465 >= _e1466)) && (_e1467 >= _e1468));
                        let _e1479 = (_e1473 || (((_e1463 <= _e1464) && (_e1465 <= _e1466)) && (_e1467 <= _e1468)));
                        if _e1479 {
                            let _e1481 = select(-1f, 1f, _e1473);
                            let _e1483 = ((_e1463 - _e1464) * _e1481);
                            let _e1485 = select(0f, _e1483, (_e1483 > 0f));
                            let _e1487 = ((_e1465 - _e1466) * _e1481);
                            let _e1489 = select(0f, _e1487, (_e1487 > 0f));
                            let _e1491 = ((_e1467 - _e1468) * _e1481);
                            let _e1493 = select(0f, _e1491, (_e1491 > 0f));
                            let _e1495 = ((_e1485 + _e1489) + _e1493);
                            let _e1510 = ((min(min(_e1408[0], _e1416[0]), _e1424[0]) - _e608) * _e611);
                            let _e1511 = ((max(max(_e1408[0], _e1416[0]), _e1424[0]) - _e609) * _e611);
                            let _e1512 = vec4<f32>(_e1510, f32(), _e1511, f32());
                            let _e1515 = ((min(min(_e1408[1], _e1416[1]), _e1424[1]) - _e624) * _e627);
                            let _e1516 = ((max(max(_e1408[1], _e1416[1]), _e1424[1]) - _e625) * _e627);
                            let _e1517 = vec4<f32>(_e1515, f32(), _e1516, f32());
                            let _e1520 = ((min(min(_e1408[2], _e1416[2]), _e1424[2]) - _e640) * _e643);
                            let _e1521 = ((max(max(_e1408[2], _e1416[2]), _e1424[2]) - _e641) * _e643);
                            let _e1522 = vec4<f32>(_e1520, f32(), _e1521, f32());
                            let _e1523 = vec4<f32>(_e1511, f32(), _e1510, f32());
                            let _e1525 = vec4<f32>(_e1516, f32(), _e1515, f32());
                            let _e1527 = vec4<f32>(_e1521, f32(), _e1520, f32());
                            let _e1536 = max(max(min(_e1512, _e1523).x, min(_e1517, _e1525).x), min(_e1522, _e1527).x);
                            let _e1541 = min(min(max(_e1512, _e1523).x, max(_e1517, _e1525).x), max(_e1522, _e1527).x);
                            let _e1546 = max(_e1536, _e651);
                            let _e1568 = (((((_e1479 && (_e1495 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1441, _e1450), _e1459) <= 0f) && (max(max(_e1441, _e1450), _e1459) >= 0f))) && ((min(min(_e1444, _e1453), _e1462) <= 0f) && (max(max(_e1444, _e1453), _e1462) >= 0f))) && (_e1546 <= (_e1541 + (max(max(_e1522, _e1527).x, -(min(_e1522, _e1527).x)) * 0.0000019073523f)))) && (_e1546 <= _e1284.member.member_1));
                            if _e1568 {
                                let _e1573 = (_e1416[0] - _e1408[0]);
                                let _e1574 = (_e1416[1] - _e1408[1]);
                                let _e1575 = (_e1416[2] - _e1408[2]);
                                let _e1576 = vec3<f32>(_e1573, _e1574, _e1575);
                                let _e1577 = (_e1424[0] - _e1416[0]);
                                let _e1578 = (_e1424[1] - _e1416[1]);
                                let _e1579 = (_e1424[2] - _e1416[2]);
                                let _e1580 = vec3<f32>(_e1577, _e1578, _e1579);
                                let _e1581 = (_e1408[0] - _e1424[0]);
                                let _e1582 = (_e1408[1] - _e1424[1]);
                                let _e1583 = (_e1408[2] - _e1424[2]);
                                let _e1584 = vec3<f32>(_e1581, _e1582, _e1583);
                                let _e1595 = max(max(bitcast<f32>((bitcast<u32>(_e1573) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1574) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1575) & 2147483647u)));
                                let _e1606 = max(max(bitcast<f32>((bitcast<u32>(_e1577) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1578) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1579) & 2147483647u)));
                                let _e1619 = max(max(_e1595, _e1606), max(max(bitcast<f32>((bitcast<u32>(_e1581) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1582) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1583) & 2147483647u))));
                                if (_e1595 == _e1619) {
                                    phi_3279_ = _e1453;
                                    phi_3280_ = _e1450;
                                    phi_3281_ = _e1444;
                                    phi_3282_ = _e1441;
                                    phi_3283_ = vec3<f32>(_e1408[0], _e1408[1], _e1408[2]);
                                    phi_3284_ = _e1584;
                                    phi_3285_ = _e1580;
                                    phi_3286_ = _e1576;
                                } else {
                                    let _e1621 = (_e1606 == _e1619);
                                    let _e1626 = vec3(_e1621);
                                    phi_3279_ = select(_e1444, _e1462, _e1621);
                                    phi_3280_ = select(_e1441, _e1459, _e1621);
                                    phi_3281_ = select(_e1462, _e1453, _e1621);
                                    phi_3282_ = select(_e1459, _e1450, _e1621);
                                    phi_3283_ = select(vec3<f32>(_e1424[0], _e1424[1], _e1424[2]), vec3<f32>(_e1416[0], _e1416[1], _e1416[2]), _e1626);
                                    phi_3284_ = select(_e1580, _e1576, _e1626);
                                    phi_3285_ = select(_e1576, _e1584, _e1626);
                                    phi_3286_ = select(_e1584, _e1580, _e1626);
                                }
                                let _e1632 = phi_3279_;
                                let _e1634 = phi_3280_;
                                let _e1636 = phi_3281_;
                                let _e1638 = phi_3282_;
                                let _e1640 = phi_3283_;
                                let _e1642 = phi_3284_;
                                let _e1644 = phi_3285_;
                                let _e1646 = phi_3286_;
                                let _e1653 = ((_e1644.y * _e1642.z) - (_e1642.y * _e1644.z));
                                let _e1658 = ((_e1644.z * _e1642.x) - (_e1642.z * _e1644.x));
                                let _e1661 = ((_e1644.x * _e1642.y) - (_e1642.x * _e1644.y));
                                let _e1664 = ((_e1485 >= _e1489) && (_e1485 >= _e1493));
                                let _e1665 = (_e1489 >= _e1493);
                                let _e1679 = (((_e1653 * (select(select(_e1424[0], _e1416[0], _e1665), _e1408[0], _e1664) - _e584.member[0])) + (_e1658 * (select(select(_e1424[1], _e1416[1], _e1665), _e1408[1], _e1664) - _e584.member[1]))) + (_e1661 * (select(select(_e1424[2], _e1416[2], _e1665), _e1408[2], _e1664) - _e584.member[2])));
                                let _e1684 = (((_e1653 * _e607) + (_e1658 * _e623)) + (_e1661 * _e639));
                                let _e1685 = (_e1634 - _e1638);
                                let _e1686 = (_e1632 - _e1636);
                                let _e1689 = ((_e1685 * _e1685) + (_e1686 * _e1686));
                                let _e1696 = (-(((_e1638 * _e1685) + (_e1636 * _e1686))) / select(0.000000000000000000000000000000000000011754944f, _e1689, (_e1689 > 0.000000000000000000000000000000000000011754944f)));
                                let _e1698 = select(1f, _e1696, (_e1696 < 1f));
                                let _e1700 = select(0f, _e1698, (_e1698 > 0f));
                                let _e1709 = ((_e1640.x + (_e1646.x * _e1700)) - _e584.member[0]);
                                let _e1712 = ((_e1640.y + (_e1646.y * _e1700)) - _e584.member[1]);
                                let _e1715 = ((_e1640.z + (_e1646.z * _e1700)) - _e584.member[2]);
                                let _e1780 = ((bitcast<f32>((bitcast<u32>(((((_e1653 * _e1709) + (_e1658 * _e1712)) + (_e1661 * _e1715)) - _e1679)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1709) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1712) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1715) & 2147483647u))), _e1619)) * max(max(bitcast<f32>((bitcast<u32>(_e1653) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1658) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1661) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1684) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1644.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1644.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1644.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1642.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1642.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1642.z) & 2147483647u)))))));
                                let _e1781 = (_e1679 / _e1684);
                                if (_e1568 && !(_e1780)) {
                                    let _e1784 = (_e1715 / _e639);
                                    let _e1792 = (((_e1653 * (_e1709 - (_e607 * _e1784))) + (_e1658 * (_e1712 - (_e623 * _e1784)))) / _e1684);
                                    phi_3465_ = select(select(_e1784, (_e1784 + _e1792), (bitcast<f32>((bitcast<u32>(_e1792) & 2147483647u)) <= _e1619)), _e1781, _e1780);
                                } else {
                                    phi_3465_ = _e1781;
                                }
                                let _e1801 = phi_3465_;
                                let _e1803 = select(_e1541, _e1801, (_e1801 < _e1541));
                                let _e1805 = select(_e1536, _e1803, (_e1803 > _e1536));
                                let _e1808 = select(_e1805, 0f, (bitcast<u32>(_e1805) == 2147483648u));
                                let _e1809 = (1f / _e1495);
                                phi_3491_ = SlimbvhTypeE(_e1808, (_e1489 * _e1809), (_e1493 * _e1809), ((_e1568 && (_e1808 >= _e651)) && (_e1808 <= _e1284.member.member_1)));
                                phi_3492_ = SlimbvhTypeE();
                            } else {
                                phi_3491_ = SlimbvhTypeE();
                                phi_3492_ = SlimbvhTypeE(0f, 0f, 0f, _e1568);
                            }
                            let _e1818 = phi_3491_;
                            let _e1820 = phi_3492_;
                            phi_3495_ = _e1818;
                            phi_3496_ = _e1820;
                            phi_3497_ = select(true, false, _e1568);
                        } else {
                            phi_3495_ = SlimbvhTypeE();
                            phi_3496_ = SlimbvhTypeE(0f, 0f, 0f, _e1479);
                            phi_3497_ = true;
                        }
                        let _e1823 = phi_3495_;
                        let _e1825 = phi_3496_;
                        let _e1827 = phi_3497_;
                        if _e1827 {
                            phi_3501_ = _e1825;
                        } else {
                            phi_3501_ = _e1823;
                        }
                        let _e1829 = phi_3501_;
                        if _e1829.member_3 {
                            phi_3510_ = SlimbvhTypeF(_e1829.member, _e1829.member_1, _e1829.member_2, _e1347);
                        } else {
                            phi_3510_ = _e86;
                        }
                        let _e1836 = phi_3510_;
                        if (_e1836.member_3 != 4294967295u) {
                            if (_e1347 != 4294967295u) {
                                if (_e1836.member < _e1284.member.member.member) {
                                    phi_3538_ = true;
                                } else {
                                    if (_e1836.member == _e1284.member.member.member) {
                                        phi_3537_ = (_e1836.member_3 < _e1284.member.member.member_3);
                                    } else {
                                        phi_3537_ = false;
                                    }
                                    let _e1851 = phi_3537_;
                                    phi_3538_ = _e1851;
                                }
                                let _e1853 = phi_3538_;
                                if _e1853 {
                                    phi_3545_ = SlimbvhTypeN(SlimbvhTypeH(_e1836, _e1836.member), _e1284.member_1);
                                } else {
                                    phi_3545_ = _e1284;
                                }
                                let _e1859 = phi_3545_;
                                if _e1859.member_1 {
                                    phi_3551_ = SlimbvhTypeN(SlimbvhTypeH(_e1859.member.member, bitcast<f32>(4286578687u)), _e1859.member_1);
                                } else {
                                    phi_3551_ = _e1859;
                                }
                                let _e1868 = phi_3551_;
                                phi_3552_ = _e1868;
                            } else {
                                phi_3552_ = _e1284;
                            }
                            let _e1870 = phi_3552_;
                            phi_3553_ = _e1870;
                        } else {
                            phi_3553_ = _e1284;
                        }
                        let _e1872 = phi_3553_;
                        phi_2680_ = _e1872;
                    } else {
                        phi_2680_ = SlimbvhTypeN();
                    }
                    let _e1874 = phi_2680_;
                    continue;
                    continuing {
                        phi_2679_ = _e1874;
                        phi_2682_ = _e1299;
                        break if !(_e1305);
                    }
                }
                let _e1877 = local_4;
                let _e1878 = (_e1877 - 1u);
                let _e1881 = local[(_e1878 % 128u)];
                let _e1882 = (_e1881 & 511u);
                let _e1884 = (_e1882 >> bitcast<u32>(3u));
                let _e1887 = ((_e1884 == 0u) || (_e1878 == 4294967295u));
                if _e1887 {
                } else {
                    local[(_e1878 % 128u)] = (((_e1881 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1884);
                }
                let _e1894 = local_5;
                let _e1902 = (((_e1881 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1882 & 3u) & 3u));
                let _e1904 = (_e1902 >> bitcast<u32>(2i));
                if (_e1904 < _e90) {
                    let _e1910 = slimbvh_nodes.member[_e1904].member_1[(_e1902 & 3u)];
                    phi_3612_ = _e1910;
                } else {
                    phi_3612_ = 2147483648u;
                }
                let _e1912 = phi_3612_;
                let _e1914 = local_6;
                let _e2173 = local_8;
                phi_3621_ = _e2173;
                phi_3622_ = select(select(_e1894, _e1878, _e1887), 4294967295u, (_e651 > _e1914.member.member_1));
                phi_3623_ = _e1912;
            } else {
                phi_3621_ = _e759;
                let _e2176 = local_9;
                phi_3622_ = _e2176;
                let _e2179 = local_10;
                phi_3623_ = _e2179;
            }
            let _e1920 = phi_3621_;
            let _e1922 = phi_3622_;
            let _e1924 = phi_3623_;
            phi_1786_ = _e1920;
            phi_1789_ = _e1922;
            phi_1791_ = _e1924;
            let _e2185 = local_11;
            phi_1793_ = _e2185;
        } else {
            phi_1786_ = SlimbvhTypeN();
            phi_1789_ = u32();
            phi_1791_ = u32();
            phi_1793_ = u32();
        }
        let _e1926 = phi_1786_;
        let _e1928 = phi_1789_;
        let _e1930 = phi_1791_;
        let _e1932 = phi_1793_;
        continue;
        continuing {
            phi_1785_ = _e1926;
            phi_1788_ = _e1928;
            phi_1790_ = _e1930;
            phi_1792_ = _e1932;
            break if !(_e766);
        }
    }
    let _e1935 = local_7;
    if (_e1935.member.member.member_3 != 4294967295u) {
        let _e1941 = -((_e154 + _e584.member_4));
        let _e1942 = bitcast<u32>(_e1935.member.member.member);
        let _e1946 = (bitcast<i32>((_e1942 >> bitcast<u32>(23i))) & 255i);
        let _e1947 = (_e1946 + _e1941);
        if (_e1946 == 255i) {
            phi_3680_ = _e1935.member.member.member;
        } else {
            if (_e1946 > 0i) {
                if (_e1947 > 0i) {
                    let _e1951 = (_e1947 < 255i);
                    if _e1951 {
                        phi_3659_ = bitcast<f32>((_e1942 + bitcast<u32>((_e1941 << bitcast<u32>(23i)))));
                    } else {
                        phi_3659_ = f32();
                    }
                    let _e1958 = phi_3659_;
                    phi_3661_ = _e1958;
                    phi_3662_ = select(true, false, _e1951);
                } else {
                    phi_3661_ = f32();
                    phi_3662_ = true;
                }
                let _e1961 = phi_3661_;
                let _e1963 = phi_3662_;
                phi_3663_ = _e1961;
                phi_3664_ = _e1963;
            } else {
                phi_3663_ = f32();
                phi_3664_ = true;
            }
            let _e1965 = phi_3663_;
            let _e1967 = phi_3664_;
            if _e1967 {
                let _e1968 = (_e1942 & 2147483648u);
                let _e1975 = ((_e1942 & 8388607u) | (select(0u, 1u, ((_e1942 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e1979 = (_e1975 == 0u);
                if _e1979 {
                    phi_4340_ = bitcast<f32>(_e1968);
                } else {
                    let _e1984 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1975)), 32u, _e1979) - 8u);
                    let _e1987 = (_e1975 << bitcast<u32>((_e1984 & 31u)));
                    let _e1989 = ((_e1947 + select(0i, 1i, (_e1946 == 0i))) - bitcast<i32>(_e1984));
                    if (_e1989 >= 255i) {
                        phi_4330_ = bitcast<f32>((_e1968 | 2139095040u));
                        phi_4331_ = f32();
                        phi_4332_ = true;
                    } else {
                        let _e1991 = (_e1989 > 0i);
                        if _e1991 {
                            phi_4324_ = bitcast<f32>(((_e1968 | (bitcast<u32>(_e1989) << bitcast<u32>(23i))) | (_e1987 & 8388607u)));
                            phi_4325_ = f32();
                        } else {
                            if (_e1989 < -24i) {
                                phi_4290_ = 26u;
                            } else {
                                phi_4290_ = bitcast<u32>((1i - _e1989));
                            }
                            let _e1996 = phi_4290_;
                            let _e1997 = (_e1996 & 31u);
                            let _e1999 = (_e1987 >> bitcast<u32>(_e1997));
                            let _e2003 = (_e1987 & ((1u << bitcast<u32>(_e1997)) - 1u));
                            let _e2007 = (1u << bitcast<u32>(((_e1996 - 1u) & 31u)));
                            if (_e2003 > _e2007) {
                                phi_4311_ = true;
                            } else {
                                if (_e2003 == _e2007) {
                                    phi_4308_ = ((_e1999 & 1u) == 1u);
                                } else {
                                    phi_4308_ = false;
                                }
                                let _e2013 = phi_4308_;
                                phi_4311_ = _e2013;
                            }
                            let _e2015 = phi_4311_;
                            phi_4324_ = f32();
                            phi_4325_ = bitcast<f32>((_e1968 | (_e1999 + select(0u, 1u, _e2015))));
                        }
                        let _e2028 = phi_4324_;
                        let _e2030 = phi_4325_;
                        phi_4330_ = _e2028;
                        phi_4331_ = _e2030;
                        phi_4332_ = _e1991;
                    }
                    let _e2034 = phi_4330_;
                    let _e2036 = phi_4331_;
                    let _e2038 = phi_4332_;
                    phi_4340_ = select(_e2036, _e2034, _e2038);
                }
                let _e2042 = phi_4340_;
                phi_3679_ = _e2042;
            } else {
                phi_3679_ = _e1965;
            }
            let _e2044 = phi_3679_;
            phi_3680_ = _e2044;
        }
        let _e2046 = phi_3680_;
        let _e2047 = bitcast<u32>(_e2046);
        if ((_e2047 & 2147483647u) >= 2139095040u) {
            phi_3692_ = bitcast<f32>(((_e2047 & 2147483648u) | 2139095039u));
        } else {
            phi_3692_ = _e2046;
        }
        let _e2054 = phi_3692_;
        phi_3697_ = SlimbvhTypeF(_e2054, _e1935.member.member.member_1, _e1935.member.member.member_2, _e1935.member.member.member_3);
    } else {
        phi_3697_ = _e86;
    }
    let _e2059 = phi_3697_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e2059.member), bitcast<u32>(_e2059.member_1), bitcast<u32>(_e2059.member_2), _e2059.member_3);
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
