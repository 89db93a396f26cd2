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
    member: array<f32, 3>,
    member_1: array<f32, 3>,
    member_2: f32,
    member_3: f32,
    member_4: i32,
}

struct SlimbvhTypeF {
    member: u32,
    member_1: u32,
}

struct SlimbvhTypeG {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct SlimbvhTypeH {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct SlimbvhTypeI {
    member: SlimbvhTypeH,
    member_1: f32,
}

struct SlimbvhTypeJ {
    member: vec4<f32>,
}

struct SlimbvhTypeK {
    member: u32,
}

struct SlimbvhTypeL {
    member: SlimbvhTypeI,
    member_1: bool,
}

@group(0) @binding(0) 
var<uniform> slimbvh_exponent: SlimbvhTypeA;

@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeC;

@group(0) @binding(2) 
var<storage> slimbvh_triangles: SlimbvhTypeD;

var<private> slimbvh_origin: SlimbvhTypeJ;

var<private> slimbvh_direction: SlimbvhTypeJ;

var<private> slimbvh_any_will_do: SlimbvhTypeK;

var<private> slimbvh_hit: SlimbvhTypeA;

fn slimbvh_trace() {
    var local: array<u32, 128>;
    var phi_586_: u32;
    var phi_592_: u32;
    var phi_598_: u32;
    var phi_863_: i32;
    var phi_874_: i32;
    var phi_988_: i32;
    var phi_1117_: i32;
    var phi_1139_: u32;
    var phi_1140_: u32;
    var phi_1141_: bool;
    var phi_1175_: i32;
    var phi_1197_: u32;
    var phi_1198_: u32;
    var phi_1199_: bool;
    var phi_760_: i32;
    var phi_766_: u32;
    var phi_785_: u32;
    var phi_786_: u32;
    var phi_787_: bool;
    var phi_805_: i32;
    var phi_811_: u32;
    var phi_830_: u32;
    var phi_831_: u32;
    var phi_832_: bool;
    var phi_1209_: SlimbvhTypeE;
    var phi_1438_: SlimbvhTypeL;
    var phi_1478_: SlimbvhTypeL;
    var phi_1481_: u32;
    var phi_1483_: u32;
    var phi_1485_: u32;
    var phi_1494_: u32;
    var phi_1497_: u32;
    var phi_1499_: u32;
    var phi_1936_: u32;
    var phi_1949_: u32;
    var phi_1962_: u32;
    var phi_1975_: u32;
    var phi_3187_: SlimbvhTypeF;
    var phi_3199_: SlimbvhTypeF;
    var phi_3211_: SlimbvhTypeF;
    var phi_3223_: SlimbvhTypeF;
    var phi_3235_: SlimbvhTypeF;
    var phi_2056_: u32;
    var phi_2061_: u32;
    var phi_2062_: u32;
    var phi_2083_: u32;
    var phi_1495_: u32;
    var phi_1498_: u32;
    var phi_1500_: u32;
    var local_1: bool;
    var local_2: u32;
    var local_3: u32;
    var phi_2099_: SlimbvhTypeL;
    var phi_2102_: SlimbvhTypeF;
    var phi_2103_: SlimbvhTypeF;
    var phi_2125_: SlimbvhTypeF;
    var phi_2204_: array<vec4<f32>, 3>;
    var phi_2205_: array<vec4<f32>, 3>;
    var phi_2285_: array<vec4<f32>, 3>;
    var phi_2286_: array<vec4<f32>, 3>;
    var phi_2309_: array<f32, 3>;
    var phi_2310_: array<f32, 3>;
    var phi_2324_: array<f32, 3>;
    var phi_2325_: array<f32, 3>;
    var phi_2339_: array<f32, 3>;
    var phi_2340_: array<f32, 3>;
    var phi_2699_: f32;
    var phi_2700_: f32;
    var phi_2701_: f32;
    var phi_2702_: f32;
    var phi_2703_: vec3<f32>;
    var phi_2704_: vec3<f32>;
    var phi_2705_: vec3<f32>;
    var phi_2706_: vec3<f32>;
    var phi_2885_: f32;
    var phi_2911_: SlimbvhTypeG;
    var phi_2912_: SlimbvhTypeG;
    var phi_2915_: SlimbvhTypeG;
    var phi_2916_: SlimbvhTypeG;
    var phi_2917_: bool;
    var phi_2921_: SlimbvhTypeG;
    var phi_2930_: SlimbvhTypeH;
    var phi_2957_: bool;
    var phi_2958_: bool;
    var phi_2965_: SlimbvhTypeL;
    var phi_2971_: SlimbvhTypeL;
    var phi_2972_: SlimbvhTypeL;
    var phi_2973_: SlimbvhTypeL;
    var phi_2100_: SlimbvhTypeL;
    var local_4: u32;
    var local_5: u32;
    var phi_3029_: u32;
    var local_6: SlimbvhTypeL;
    var phi_3038_: SlimbvhTypeL;
    var phi_3039_: u32;
    var phi_3040_: u32;
    var phi_1479_: SlimbvhTypeL;
    var phi_1482_: u32;
    var phi_1484_: u32;
    var phi_1486_: u32;
    var local_7: SlimbvhTypeL;
    var phi_3076_: f32;
    var phi_3078_: f32;
    var phi_3079_: bool;
    var phi_3080_: f32;
    var phi_3081_: bool;
    var phi_3466_: u32;
    var phi_3484_: bool;
    var phi_3487_: bool;
    var phi_3500_: f32;
    var phi_3501_: f32;
    var phi_3506_: f32;
    var phi_3507_: f32;
    var phi_3508_: bool;
    var phi_3516_: f32;
    var phi_3096_: f32;
    var phi_3097_: f32;
    var phi_3109_: f32;
    var phi_3114_: SlimbvhTypeH;
    var local_8: SlimbvhTypeL;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e78 = SlimbvhTypeH(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e81 = arrayLength((&slimbvh_nodes.member));
    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    let _e88 = slimbvh_origin.member;
    let _e94 = slimbvh_origin.member[3u];
    let _e95 = slimbvh_direction.member;
    let _e101 = slimbvh_direction.member[3u];
    let _e104 = slimbvh_exponent.member[0u];
    let _e105 = bitcast<i32>(_e104);
    let _e107 = (bitcast<u32>(_e88.x) & 2147483647u);
    let _e109 = (bitcast<u32>(_e88.y) & 2147483647u);
    let _e111 = (bitcast<u32>(_e88.z) & 2147483647u);
    let _e112 = bitcast<u32>(_e94);
    let _e113 = (_e112 & 2147483647u);
    let _e115 = (bitcast<u32>(_e95.x) & 2147483647u);
    let _e117 = (bitcast<u32>(_e95.y) & 2147483647u);
    let _e119 = (bitcast<u32>(_e95.z) & 2147483647u);
    let _e120 = bitcast<u32>(_e101);
    let _e121 = (_e120 & 2147483647u);
    let _e123 = select(_e117, _e115, (_e117 < _e115));
    let _e125 = select(_e119, _e123, (_e119 < _e123));
    let _e127 = select(_e107, _e125, (_e107 < _e125));
    let _e129 = select(_e109, _e127, (_e109 < _e127));
    let _e131 = select(_e111, _e129, (_e111 < _e129));
    let _e138 = (((select(_e113, _e131, (_e113 < _e131)) < 2139095040u) && (_e121 <= 2139095040u)) && (_e125 > 0u));
    if (_e115 == _e125) {
        phi_586_ = 0u;
    } else {
        phi_586_ = select(2u, 1u, (_e117 == _e125));
    }
    let _e143 = phi_586_;
    let _e144 = (_e143 == 2u);
    if _e144 {
        phi_592_ = 0u;
    } else {
        phi_592_ = (_e143 + 1u);
    }
    let _e147 = phi_592_;
    let _e148 = (_e147 == 2u);
    if _e148 {
        phi_598_ = 0u;
    } else {
        phi_598_ = (_e147 + 1u);
    }
    let _e151 = phi_598_;
    let _e152 = (_e147 == 0u);
    let _e154 = select(select(_e88.y, _e88.x, _e152), _e88.z, _e148);
    let _e155 = (_e151 == 0u);
    let _e157 = (_e151 == 2u);
    let _e158 = select(select(_e88.y, _e88.x, _e155), _e88.z, _e157);
    let _e159 = (_e143 == 0u);
    let _e161 = select(select(_e88.y, _e88.x, _e159), _e88.z, _e144);
    let _e163 = select(select(_e95.y, _e95.x, _e152), _e95.z, _e148);
    let _e165 = select(select(_e95.y, _e95.x, _e155), _e95.z, _e157);
    let _e167 = select(select(_e95.y, _e95.x, _e159), _e95.z, _e144);
    let _e168 = (_e113 - 1u);
    let _e169 = (_e121 - 1u);
    let _e171 = select(_e168, _e169, (_e169 < _e168));
    let _e172 = (_e107 - 1u);
    let _e173 = (_e109 - 1u);
    let _e175 = select(_e172, _e173, (_e173 < _e172));
    let _e176 = (_e111 - 1u);
    let _e178 = select(_e175, _e176, (_e176 < _e175));
    let _e179 = (_e115 - 1u);
    let _e180 = (_e117 - 1u);
    let _e182 = select(_e179, _e180, (_e180 < _e179));
    let _e183 = (_e119 - 1u);
    let _e185 = select(_e182, _e183, (_e183 < _e182));
    let _e187 = select(_e178, _e185, (_e185 < _e178));
    if (((select(_e187, _e171, (_e171 < _e187)) >= 8388607u) && (_e125 < 2130706432u)) && (bitcast<u32>((_e105 + 126i)) <= 253u)) {
        let _e452 = bitcast<i32>((_e125 >> bitcast<u32>(23i)));
        let _e453 = (_e452 - 127i);
        let _e454 = (_e105 + _e453);
        let _e459 = bitcast<f32>((bitcast<u32>((_e105 + 127i)) << bitcast<u32>(23i)));
        let _e464 = bitcast<f32>((bitcast<u32>((254i - _e452)) << bitcast<u32>(23i)));
        if (_e113 >= 2139095040u) {
            phi_760_ = 255i;
        } else {
            phi_760_ = (bitcast<i32>((_e113 >> bitcast<u32>(23i))) + _e454);
        }
        let _e479 = phi_760_;
        if (_e113 == 0u) {
            phi_766_ = 0u;
        } else {
            phi_766_ = (_e113 | 8388608u);
        }
        let _e483 = phi_766_;
        if (_e479 <= 0i) {
            phi_786_ = u32();
            phi_787_ = true;
        } else {
            let _e490 = (_e483 == 0u);
            if _e490 {
                phi_785_ = u32();
            } else {
                phi_785_ = select(((bitcast<u32>(_e479) << bitcast<u32>(23i)) | (_e483 & 8388607u)), 2139095039u, (_e479 >= 255i));
            }
            let _e494 = phi_785_;
            phi_786_ = _e494;
            phi_787_ = _e490;
        }
        let _e496 = phi_786_;
        let _e498 = phi_787_;
        if (_e121 >= 2139095040u) {
            phi_805_ = 255i;
        } else {
            phi_805_ = (bitcast<i32>((_e121 >> bitcast<u32>(23i))) + _e454);
        }
        let _e509 = phi_805_;
        if (_e121 == 0u) {
            phi_811_ = 0u;
        } else {
            phi_811_ = (_e121 | 8388608u);
        }
        let _e513 = phi_811_;
        if (_e509 <= 0i) {
            phi_831_ = u32();
            phi_832_ = true;
        } else {
            let _e520 = (_e513 == 0u);
            if _e520 {
                phi_830_ = u32();
            } else {
                phi_830_ = select(((bitcast<u32>(_e509) << bitcast<u32>(23i)) | (_e513 & 8388607u)), 2139095039u, (_e509 >= 255i));
            }
            let _e524 = phi_830_;
            phi_831_ = _e524;
            phi_832_ = _e520;
        }
        let _e526 = phi_831_;
        let _e528 = phi_832_;
        phi_1209_ = SlimbvhTypeE(array<f32, 3>((_e154 * _e459), (_e158 * _e459), (_e161 * _e459)), array<f32, 3>((_e163 * _e464), (_e165 * _e464), (_e167 * _e464)), bitcast<f32>(((_e112 & 2147483648u) | select(_e496, 0u, _e498))), bitcast<f32>(((_e120 & 2147483648u) | select(_e526, 0u, _e528))), _e453);
    } else {
        let _e200 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e125, _e138))) & 2147483647u);
        if (_e200 >= 8388608u) {
            phi_863_ = (bitcast<i32>((_e200 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_863_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e200)), 32u, (_e200 == 0u))));
        }
        let _e214 = phi_863_;
        let _e215 = (_e105 + _e214);
        if (_e105 < -126i) {
            phi_874_ = -126i;
        } else {
            phi_874_ = select(_e105, 127i, (_e105 > 127i));
        }
        let _e220 = phi_874_;
        let _e225 = bitcast<f32>((bitcast<u32>((_e220 + 127i)) << bitcast<u32>(23i)));
        let _e231 = bitcast<f32>((bitcast<u32>(((_e105 - _e220) + 127i)) << bitcast<u32>(23i)));
        let _e232 = bitcast<u32>(_e154);
        let _e234 = ((_e232 & 2139095040u) != 0u);
        let _e249 = bitcast<u32>(_e158);
        let _e251 = ((_e249 & 2139095040u) != 0u);
        let _e266 = bitcast<u32>(_e161);
        let _e268 = ((_e266 & 2139095040u) != 0u);
        let _e284 = -(_e214);
        if (_e284 < -126i) {
            phi_988_ = -126i;
        } else {
            phi_988_ = select(_e284, 127i, (_e284 > 127i));
        }
        let _e289 = phi_988_;
        let _e294 = bitcast<f32>((bitcast<u32>((_e289 + 127i)) << bitcast<u32>(23i)));
        let _e300 = bitcast<f32>((bitcast<u32>(((_e284 - _e289) + 127i)) << bitcast<u32>(23i)));
        let _e301 = bitcast<u32>(_e163);
        let _e303 = ((_e301 & 2139095040u) != 0u);
        let _e318 = bitcast<u32>(_e165);
        let _e320 = ((_e318 & 2139095040u) != 0u);
        let _e335 = bitcast<u32>(_e167);
        let _e337 = ((_e335 & 2139095040u) != 0u);
        let _e359 = ((_e113 & 8388607u) | (select(0u, 1u, ((_e113 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e362 = bitcast<i32>((_e113 >> bitcast<u32>(23i)));
        let _e369 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e359)), 32u, (_e359 == 0u))) - 8i);
        if (_e362 == 255i) {
            phi_1117_ = 255i;
        } else {
            phi_1117_ = (((_e362 + select(0i, 1i, (_e362 == 0i))) - _e369) + _e215);
        }
        let _e377 = phi_1117_;
        let _e381 = (_e359 << bitcast<u32>(((_e369 & 31i) & 31i)));
        if (_e377 <= 0i) {
            phi_1140_ = u32();
            phi_1141_ = true;
        } else {
            let _e388 = (_e381 == 0u);
            if _e388 {
                phi_1139_ = u32();
            } else {
                phi_1139_ = select(((bitcast<u32>(_e377) << bitcast<u32>(23i)) | (_e381 & 8388607u)), 2139095039u, (_e377 >= 255i));
            }
            let _e392 = phi_1139_;
            phi_1140_ = _e392;
            phi_1141_ = _e388;
        }
        let _e394 = phi_1140_;
        let _e396 = phi_1141_;
        let _e407 = ((_e121 & 8388607u) | (select(0u, 1u, ((_e121 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e410 = bitcast<i32>((_e121 >> bitcast<u32>(23i)));
        let _e417 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e407)), 32u, (_e407 == 0u))) - 8i);
        if (_e410 == 255i) {
            phi_1175_ = 255i;
        } else {
            phi_1175_ = (((_e410 + select(0i, 1i, (_e410 == 0i))) - _e417) + _e215);
        }
        let _e425 = phi_1175_;
        let _e429 = (_e407 << bitcast<u32>(((_e417 & 31i) & 31i)));
        if (_e425 <= 0i) {
            phi_1198_ = u32();
            phi_1199_ = true;
        } else {
            let _e436 = (_e429 == 0u);
            if _e436 {
                phi_1197_ = u32();
            } else {
                phi_1197_ = select(((bitcast<u32>(_e425) << bitcast<u32>(23i)) | (_e429 & 8388607u)), 2139095039u, (_e425 >= 255i));
            }
            let _e440 = phi_1197_;
            phi_1198_ = _e440;
            phi_1199_ = _e436;
        }
        let _e442 = phi_1198_;
        let _e444 = phi_1199_;
        phi_1209_ = SlimbvhTypeE(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e232 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e232 & 2147483648u))), _e154, _e234) * _e225) * select(0.00000011920929f, 1f, _e234)) * _e231), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e249 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e249 & 2147483648u))), _e158, _e251) * _e225) * select(0.00000011920929f, 1f, _e251)) * _e231), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e266 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e266 & 2147483648u))), _e161, _e268) * _e225) * select(0.00000011920929f, 1f, _e268)) * _e231)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e301 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e301 & 2147483648u))), _e163, _e303) * _e294) * select(0.00000011920929f, 1f, _e303)) * _e300), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e165, _e320) * _e294) * select(0.00000011920929f, 1f, _e320)) * _e300), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e335 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e335 & 2147483648u))), _e167, _e337) * _e294) * select(0.00000011920929f, 1f, _e337)) * _e300)), bitcast<f32>(((_e112 & 2147483648u) | select(_e394, 0u, _e396))), bitcast<f32>(((_e120 & 2147483648u) | select(_e442, 0u, _e444))), _e214);
    }
    let _e535 = phi_1209_;
    let _e550 = (bitcast<f32>((bitcast<u32>(_e535.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e553 = bitcast<f32>((bitcast<u32>(_e535.member[0]) & 2147483647u));
    let _e554 = (_e553 * 0.00000011920929f);
    let _e557 = select(select(0.00000000000011368684f, _e554, (_e554 > 0.00000000000011368684f)), 0f, _e550);
    let _e558 = select(0f, _e535.member_1[0], _e550);
    let _e559 = (_e535.member[0] + _e557);
    let _e560 = (_e535.member[0] - _e557);
    let _e562 = select(38685626000000000000000000f, (1f / _e535.member_1[0]), _e550);
    let _e566 = (bitcast<f32>((bitcast<u32>(_e535.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e569 = bitcast<f32>((bitcast<u32>(_e535.member[1]) & 2147483647u));
    let _e570 = (_e569 * 0.00000011920929f);
    let _e573 = select(select(0.00000000000011368684f, _e570, (_e570 > 0.00000000000011368684f)), 0f, _e566);
    let _e574 = select(0f, _e535.member_1[1], _e566);
    let _e575 = (_e535.member[1] + _e573);
    let _e576 = (_e535.member[1] - _e573);
    let _e578 = select(38685626000000000000000000f, (1f / _e535.member_1[1]), _e566);
    let _e582 = (bitcast<f32>((bitcast<u32>(_e535.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e585 = bitcast<f32>((bitcast<u32>(_e535.member[2]) & 2147483647u));
    let _e586 = (_e585 * 0.00000011920929f);
    let _e589 = select(select(0.00000000000011368684f, _e586, (_e586 > 0.00000000000011368684f)), 0f, _e582);
    let _e590 = select(0f, _e535.member_1[2], _e582);
    let _e591 = (_e535.member[2] + _e589);
    let _e592 = (_e535.member[2] - _e589);
    let _e594 = select(38685626000000000000000000f, (1f / _e535.member_1[2]), _e582);
    let _e596 = select(_e569, _e553, (_e553 > _e569));
    let _e600 = (_e138 && (select(_e585, _e596, (_e596 > _e585)) <= 1099511600000f));
    let _e601 = select(0f, _e535.member_3, _e600);
    let _e602 = select(1f, _e535.member_2, _e600);
    let _e604 = slimbvh_any_will_do.member;
    if (_e604 == 1u) {
        phi_1438_ = SlimbvhTypeL(SlimbvhTypeI(_e78, _e601), true);
    } else {
        phi_1438_ = SlimbvhTypeL(SlimbvhTypeI(_e78, _e601), false);
    }
    let _e611 = phi_1438_;
    phi_1478_ = _e611;
    phi_1481_ = select(4294967295u, 0u, (_e602 <= _e601));
    phi_1483_ = 0u;
    phi_1485_ = (_e81 + 1u);
    loop {
        let _e629 = phi_1478_;
        let _e631 = phi_1481_;
        let _e633 = phi_1483_;
        let _e635 = phi_1485_;
        local_7 = _e629;
        let _e636 = (_e631 <= 2147483647u);
        if _e636 {
            phi_1494_ = _e631;
            phi_1497_ = _e633;
            phi_1499_ = _e635;
            loop {
                let _e638 = phi_1494_;
                let _e640 = phi_1497_;
                let _e642 = phi_1499_;
                local_2 = _e640;
                local_3 = _e640;
                local_4 = _e638;
                local_5 = _e638;
                local_9 = _e638;
                local_10 = _e640;
                local_11 = _e642;
                let _e643 = (_e638 <= 2147483647u);
                let _e646 = (_e643 && !((_e640 >= _e81)));
                local_1 = _e643;
                if _e646 {
                    let _e648 = ((2u * (_e147 & 3u)) + (bitcast<u32>(_e562) >> bitcast<u32>(31i)));
                    let _e650 = ((2u * (_e151 & 3u)) + (bitcast<u32>(_e578) >> bitcast<u32>(31i)));
                    let _e652 = ((2u * (_e143 & 3u)) + (bitcast<u32>(_e594) >> bitcast<u32>(31i)));
                    let _e659 = slimbvh_nodes.member[_e640].member[select(_e648, 5u, (5u < _e648))];
                    let _e666 = slimbvh_nodes.member[_e640].member[select(_e650, 5u, (5u < _e650))];
                    let _e673 = slimbvh_nodes.member[_e640].member[select(_e652, 5u, (5u < _e652))];
                    let _e674 = (_e648 ^ 1u);
                    let _e681 = slimbvh_nodes.member[_e640].member[select(_e674, 5u, (5u < _e674))];
                    let _e682 = (_e650 ^ 1u);
                    let _e689 = slimbvh_nodes.member[_e640].member[select(_e682, 5u, (5u < _e682))];
                    let _e690 = (_e652 ^ 1u);
                    let _e697 = slimbvh_nodes.member[_e640].member[select(_e690, 5u, (5u < _e690))];
                    let _e756 = ((_e673.x - _e591) * _e594);
                    let _e757 = ((_e673.y - _e591) * _e594);
                    let _e758 = ((_e673.z - _e591) * _e594);
                    let _e759 = ((_e673.w - _e591) * _e594);
                    let _e768 = ((_e697.x - _e592) * _e594);
                    let _e769 = ((_e697.y - _e592) * _e594);
                    let _e770 = ((_e697.z - _e592) * _e594);
                    let _e771 = ((_e697.w - _e592) * _e594);
                    let _e804 = max(max(max(((_e659.x - _e559) * _e562), ((_e666.x - _e575) * _e578)), _e756), _e602);
                    let _e805 = max(max(max(((_e659.y - _e559) * _e562), ((_e666.y - _e575) * _e578)), _e757), _e602);
                    let _e806 = max(max(max(((_e659.z - _e559) * _e562), ((_e666.z - _e575) * _e578)), _e758), _e602);
                    let _e807 = max(max(max(((_e659.w - _e559) * _e562), ((_e666.w - _e575) * _e578)), _e759), _e602);
                    if (_e804 <= min((min(min(((_e681.x - _e560) * _e562), ((_e689.x - _e576) * _e578)), _e768) + (max(_e768, -(_e756)) * 0.0000019073523f)), _e629.member.member_1)) {
                        phi_1936_ = (((bitcast<u32>(_e804) ^ select(0u, 4294967288u, _e611.member_1)) & 2147483640u) | 4u);
                    } else {
                        phi_1936_ = 4294967288u;
                    }
                    let _e822 = phi_1936_;
                    if (_e805 <= min((min(min(((_e681.y - _e560) * _e562), ((_e689.y - _e576) * _e578)), _e769) + (max(_e769, -(_e757)) * 0.0000019073523f)), _e629.member.member_1)) {
                        phi_1949_ = ((((bitcast<u32>(_e805) ^ select(0u, 4294967288u, _e611.member_1)) & 2147483640u) | 4u) | 1u);
                    } else {
                        phi_1949_ = 4294967288u;
                    }
                    let _e830 = phi_1949_;
                    if (_e806 <= min((min(min(((_e681.z - _e560) * _e562), ((_e689.z - _e576) * _e578)), _e770) + (max(_e770, -(_e758)) * 0.0000019073523f)), _e629.member.member_1)) {
                        phi_1962_ = ((((bitcast<u32>(_e806) ^ select(0u, 4294967288u, _e611.member_1)) & 2147483640u) | 4u) | 2u);
                    } else {
                        phi_1962_ = 4294967288u;
                    }
                    let _e838 = phi_1962_;
                    if (_e807 <= min((min(min(((_e681.w - _e560) * _e562), ((_e689.w - _e576) * _e578)), _e771) + (max(_e771, -(_e759)) * 0.0000019073523f)), _e629.member.member_1)) {
                        phi_1975_ = ((((bitcast<u32>(_e807) ^ select(0u, 4294967288u, _e611.member_1)) & 2147483640u) | 4u) | 3u);
                    } else {
                        phi_1975_ = 4294967288u;
                    }
                    let _e846 = phi_1975_;
                    if (_e822 < _e830) {
                        phi_3187_ = SlimbvhTypeF(_e822, _e830);
                    } else {
                        phi_3187_ = SlimbvhTypeF(_e830, _e822);
                    }
                    let _e851 = phi_3187_;
                    if (_e838 < _e846) {
                        phi_3199_ = SlimbvhTypeF(_e838, _e846);
                    } else {
                        phi_3199_ = SlimbvhTypeF(_e846, _e838);
                    }
                    let _e858 = phi_3199_;
                    if (_e851.member < _e858.member) {
                        phi_3211_ = SlimbvhTypeF(_e851.member, _e858.member);
                    } else {
                        phi_3211_ = SlimbvhTypeF(_e858.member, _e851.member);
                    }
                    let _e865 = phi_3211_;
                    if (_e851.member_1 < _e858.member_1) {
                        phi_3223_ = SlimbvhTypeF(_e851.member_1, _e858.member_1);
                    } else {
                        phi_3223_ = SlimbvhTypeF(_e858.member_1, _e851.member_1);
                    }
                    let _e872 = phi_3223_;
                    if (_e872.member < _e865.member_1) {
                        phi_3235_ = SlimbvhTypeF(_e872.member, _e865.member_1);
                    } else {
                        phi_3235_ = SlimbvhTypeF(_e865.member_1, _e872.member);
                    }
                    let _e879 = phi_3235_;
                    let _e894 = (((_e865.member & 7u) | ((_e879.member & 7u) << bitcast<u32>(3u))) | (((_e879.member_1 & 7u) | ((_e872.member_1 & 7u) << bitcast<u32>(3u))) << bitcast<u32>(6u)));
                    if (_e894 == 0u) {
                        let _e912 = (_e638 - 1u);
                        let _e915 = local[(_e912 % 128u)];
                        let _e916 = (_e915 & 511u);
                        let _e918 = (_e916 >> bitcast<u32>(3u));
                        let _e921 = ((_e918 == 0u) || (_e912 == 4294967295u));
                        if _e921 {
                        } else {
                            local[(_e912 % 128u)] = (((_e915 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e918);
                        }
                        phi_2061_ = select(_e638, _e912, _e921);
                        phi_2062_ = (((_e915 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e916 & 3u) & 3u));
                    } else {
                        let _e897 = (_e894 >> bitcast<u32>(3u));
                        if (_e897 == 0u) {
                            phi_2056_ = _e638;
                        } else {
                            local[(_e638 % 128u)] = ((_e640 << bitcast<u32>(9u)) | _e897);
                            phi_2056_ = (_e638 + 1u);
                        }
                        let _e906 = phi_2056_;
                        phi_2061_ = _e906;
                        phi_2062_ = ((_e640 << bitcast<u32>(2i)) | ((_e894 & 3u) & 3u));
                    }
                    let _e936 = phi_2061_;
                    let _e938 = phi_2062_;
                    let _e940 = (_e938 >> bitcast<u32>(2i));
                    if (_e940 < _e81) {
                        let _e947 = slimbvh_nodes.member[_e940].member_1[(_e938 & 3u)];
                        phi_2083_ = _e947;
                    } else {
                        phi_2083_ = 2147483648u;
                    }
                    let _e949 = phi_2083_;
                    let _e950 = (_e642 - 1u);
                    phi_1495_ = select(_e936, 4294967295u, (_e950 == 0u));
                    phi_1498_ = _e949;
                    phi_1500_ = _e950;
                } else {
                    phi_1495_ = u32();
                    phi_1498_ = u32();
                    phi_1500_ = u32();
                }
                let _e954 = phi_1495_;
                let _e956 = phi_1498_;
                let _e958 = phi_1500_;
                continue;
                continuing {
                    phi_1494_ = _e954;
                    phi_1497_ = _e956;
                    phi_1499_ = _e958;
                    break if !(_e646);
                }
            }
            let _e961 = local_1;
            if _e961 {
                let _e963 = local_2;
                let _e966 = local_3;
                phi_2099_ = _e629;
                phi_2102_ = SlimbvhTypeF(0u, ((_e966 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e972 = phi_2099_;
                    let _e974 = phi_2102_;
                    local_6 = _e972;
                    local_8 = _e972;
                    if (_e974.member < _e974.member_1) {
                        phi_2103_ = SlimbvhTypeF((_e974.member + 1u), _e974.member_1);
                        phi_2125_ = SlimbvhTypeF(1u, _e974.member);
                    } else {
                        phi_2103_ = _e974;
                        phi_2125_ = SlimbvhTypeF(0u, SlimbvhTypeF().member_1);
                    }
                    let _e987 = phi_2103_;
                    let _e989 = phi_2125_;
                    let _e993 = (bitcast<i32>(_e989.member) != 0i);
                    if _e993 {
                        let _e994 = ((_e963 & 268435455u) + _e989.member_1);
                        let _e995 = (_e994 / 2u);
                        let _e996 = (_e994 % 2u);
                        let _e997 = (_e995 >= arrayLength((&slimbvh_triangles.member)));
                        if _e997 {
                            phi_2205_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e998 = (2u * _e996);
                            let _e1002 = slimbvh_triangles.member[_e995][_e998];
                            let _e1007 = slimbvh_triangles.member[_e995][(_e998 + 1u)];
                            let _e1012 = slimbvh_triangles.member[_e995][(_e998 + 2u)];
                            if (_e996 == 0u) {
                                phi_2204_ = array<vec4<f32>, 3>(_e1002, _e1007, _e1012);
                            } else {
                                phi_2204_ = array<vec4<f32>, 3>(vec4<f32>(_e1002.z, _e1002.w, _e1007.x, _e1007.y), vec4<f32>(_e1007.z, _e1007.w, _e1012.x, _e1012.y), vec4<f32>(_e1012.z, _e1012.w, 0f, 0f));
                            }
                            let _e1030 = phi_2204_;
                            phi_2205_ = _e1030;
                        }
                        let _e1032 = phi_2205_;
                        let _e1035 = bitcast<u32>(_e1032[2].y);
                        if _e997 {
                            phi_2286_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e1036 = (2u * _e996);
                            let _e1040 = slimbvh_triangles.member[_e995][_e1036];
                            let _e1045 = slimbvh_triangles.member[_e995][(_e1036 + 1u)];
                            let _e1050 = slimbvh_triangles.member[_e995][(_e1036 + 2u)];
                            if (_e996 == 0u) {
                                phi_2285_ = array<vec4<f32>, 3>(_e1040, _e1045, _e1050);
                            } else {
                                phi_2285_ = array<vec4<f32>, 3>(vec4<f32>(_e1040.z, _e1040.w, _e1045.x, _e1045.y), vec4<f32>(_e1045.z, _e1045.w, _e1050.x, _e1050.y), vec4<f32>(_e1050.z, _e1050.w, 0f, 0f));
                            }
                            let _e1068 = phi_2285_;
                            phi_2286_ = _e1068;
                        }
                        let _e1070 = phi_2286_;
                        if _e152 {
                            phi_2310_ = array<f32, 3>(_e1070[0].x, _e1070[0].y, _e1070[0].z);
                        } else {
                            if (_e147 == 1u) {
                                phi_2309_ = array<f32, 3>(_e1070[0].y, _e1070[0].z, _e1070[0].x);
                            } else {
                                phi_2309_ = array<f32, 3>(_e1070[0].z, _e1070[0].x, _e1070[0].y);
                            }
                            let _e1093 = phi_2309_;
                            phi_2310_ = _e1093;
                        }
                        let _e1096 = phi_2310_;
                        if _e152 {
                            phi_2325_ = array<f32, 3>(_e1070[0].w, _e1070[1].x, _e1070[1].y);
                        } else {
                            if (_e147 == 1u) {
                                phi_2324_ = array<f32, 3>(_e1070[1].x, _e1070[1].y, _e1070[0].w);
                            } else {
                                phi_2324_ = array<f32, 3>(_e1070[1].y, _e1070[0].w, _e1070[1].x);
                            }
                            let _e1101 = phi_2324_;
                            phi_2325_ = _e1101;
                        }
                        let _e1104 = phi_2325_;
                        if _e152 {
                            phi_2340_ = array<f32, 3>(_e1070[1].z, _e1070[1].w, _e1070[2].x);
                        } else {
                            if (_e147 == 1u) {
                                phi_2339_ = array<f32, 3>(_e1070[1].w, _e1070[2].x, _e1070[1].z);
                            } else {
                                phi_2339_ = array<f32, 3>(_e1070[2].x, _e1070[1].z, _e1070[1].w);
                            }
                            let _e1109 = phi_2339_;
                            phi_2340_ = _e1109;
                        }
                        let _e1112 = phi_2340_;
                        let _e1126 = (_e1096[2] - _e535.member[2]);
                        let _e1129 = (((_e1096[0] - _e535.member[0]) * _e590) - (_e1126 * _e558));
                        let _e1132 = (((_e1096[1] - _e535.member[1]) * _e590) - (_e1126 * _e574));
                        let _e1135 = (_e1104[2] - _e535.member[2]);
                        let _e1138 = (((_e1104[0] - _e535.member[0]) * _e590) - (_e1135 * _e558));
                        let _e1141 = (((_e1104[1] - _e535.member[1]) * _e590) - (_e1135 * _e574));
                        let _e1144 = (_e1112[2] - _e535.member[2]);
                        let _e1147 = (((_e1112[0] - _e535.member[0]) * _e590) - (_e1144 * _e558));
                        let _e1150 = (((_e1112[1] - _e535.member[1]) * _e590) - (_e1144 * _e574));
                        let _e1151 = (_e1147 * _e1141);
                        let _e1152 = (_e1150 * _e1138);
                        let _e1153 = (_e1129 * _e1150);
                        let _e1154 = (_e1132 * _e1147);
                        let _e1155 = (_e1138 * _e1132);
                        let _e1156 = (_e1141 * _e1129);
                        let _e1161 = (((_e1151 >= _e1152) && (_e1153 >= _e1154)) && (_e1155 >= _e1156));
                        let _e1167 = (_e1161 || (((_e1151 <= _e1152) && (_e1153 <= _e1154)) && (_e1155 <= _e1156)));
                        if _e1167 {
                            let _e1169 = select(-1f, 1f, _e1161);
                            let _e1171 = ((_e1151 - _e1152) * _e1169);
                            let _e1173 = select(0f, _e1171, (_e1171 > 0f));
                            let _e1175 = ((_e1153 - _e1154) * _e1169);
                            let _e1177 = select(0f, _e1175, (_e1175 > 0f));
                            let _e1179 = ((_e1155 - _e1156) * _e1169);
                            let _e1181 = select(0f, _e1179, (_e1179 > 0f));
                            let _e1183 = ((_e1173 + _e1177) + _e1181);
                            let _e1198 = ((min(min(_e1096[0], _e1104[0]), _e1112[0]) - _e559) * _e562);
                            let _e1199 = ((max(max(_e1096[0], _e1104[0]), _e1112[0]) - _e560) * _e562);
                            let _e1200 = vec4<f32>(_e1198, f32(), _e1199, f32());
                            let _e1203 = ((min(min(_e1096[1], _e1104[1]), _e1112[1]) - _e575) * _e578);
                            let _e1204 = ((max(max(_e1096[1], _e1104[1]), _e1112[1]) - _e576) * _e578);
                            let _e1205 = vec4<f32>(_e1203, f32(), _e1204, f32());
                            let _e1208 = ((min(min(_e1096[2], _e1104[2]), _e1112[2]) - _e591) * _e594);
                            let _e1209 = ((max(max(_e1096[2], _e1104[2]), _e1112[2]) - _e592) * _e594);
                            let _e1210 = vec4<f32>(_e1208, f32(), _e1209, f32());
                            let _e1211 = vec4<f32>(_e1199, f32(), _e1198, f32());
                            let _e1213 = vec4<f32>(_e1204, f32(), _e1203, f32());
                            let _e1215 = vec4<f32>(_e1209, f32(), _e1208, f32());
                            let _e1224 = max(max(min(_e1200, _e1211).x, min(_e1205, _e1213).x), min(_e1210, _e1215).x);
                            let _e1229 = min(min(max(_e1200, _e1211).x, max(_e1205, _e1213).x), max(_e1210, _e1215).x);
                            let _e1234 = max(_e1224, _e602);
                            let _e1256 = (((((_e1167 && (_e1183 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e1129, _e1138), _e1147) <= 0f) && (max(max(_e1129, _e1138), _e1147) >= 0f))) && ((min(min(_e1132, _e1141), _e1150) <= 0f) && (max(max(_e1132, _e1141), _e1150) >= 0f))) && (_e1234 <= (_e1229 + (max(max(_e1210, _e1215).x, -(min(_e1210, _e1215).x)) * 0.0000019073523f)))) && (_e1234 <= _e972.member.member_1));
                            if _e1256 {
                                let _e1261 = (_e1104[0] - _e1096[0]);
                                let _e1262 = (_e1104[1] - _e1096[1]);
                                let _e1263 = (_e1104[2] - _e1096[2]);
                                let _e1264 = vec3<f32>(_e1261, _e1262, _e1263);
                                let _e1265 = (_e1112[0] - _e1104[0]);
                                let _e1266 = (_e1112[1] - _e1104[1]);
                                let _e1267 = (_e1112[2] - _e1104[2]);
                                let _e1268 = vec3<f32>(_e1265, _e1266, _e1267);
                                let _e1269 = (_e1096[0] - _e1112[0]);
                                let _e1270 = (_e1096[1] - _e1112[1]);
                                let _e1271 = (_e1096[2] - _e1112[2]);
                                let _e1272 = vec3<f32>(_e1269, _e1270, _e1271);
                                let _e1283 = max(max(bitcast<f32>((bitcast<u32>(_e1261) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1262) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1263) & 2147483647u)));
                                let _e1294 = max(max(bitcast<f32>((bitcast<u32>(_e1265) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1266) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1267) & 2147483647u)));
                                let _e1307 = max(max(_e1283, _e1294), max(max(bitcast<f32>((bitcast<u32>(_e1269) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1270) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1271) & 2147483647u))));
                                if (_e1283 == _e1307) {
                                    phi_2699_ = _e1141;
                                    phi_2700_ = _e1138;
                                    phi_2701_ = _e1132;
                                    phi_2702_ = _e1129;
                                    phi_2703_ = vec3<f32>(_e1096[0], _e1096[1], _e1096[2]);
                                    phi_2704_ = _e1272;
                                    phi_2705_ = _e1268;
                                    phi_2706_ = _e1264;
                                } else {
                                    let _e1309 = (_e1294 == _e1307);
                                    let _e1314 = vec3(_e1309);
                                    phi_2699_ = select(_e1132, _e1150, _e1309);
                                    phi_2700_ = select(_e1129, _e1147, _e1309);
                                    phi_2701_ = select(_e1150, _e1141, _e1309);
                                    phi_2702_ = select(_e1147, _e1138, _e1309);
                                    phi_2703_ = select(vec3<f32>(_e1112[0], _e1112[1], _e1112[2]), vec3<f32>(_e1104[0], _e1104[1], _e1104[2]), _e1314);
                                    phi_2704_ = select(_e1268, _e1264, _e1314);
                                    phi_2705_ = select(_e1264, _e1272, _e1314);
                                    phi_2706_ = select(_e1272, _e1268, _e1314);
                                }
                                let _e1320 = phi_2699_;
                                let _e1322 = phi_2700_;
                                let _e1324 = phi_2701_;
                                let _e1326 = phi_2702_;
                                let _e1328 = phi_2703_;
                                let _e1330 = phi_2704_;
                                let _e1332 = phi_2705_;
                                let _e1334 = phi_2706_;
                                let _e1341 = ((_e1332.y * _e1330.z) - (_e1330.y * _e1332.z));
                                let _e1346 = ((_e1332.z * _e1330.x) - (_e1330.z * _e1332.x));
                                let _e1349 = ((_e1332.x * _e1330.y) - (_e1330.x * _e1332.y));
                                let _e1352 = ((_e1173 >= _e1177) && (_e1173 >= _e1181));
                                let _e1353 = (_e1177 >= _e1181);
                                let _e1367 = (((_e1341 * (select(select(_e1112[0], _e1104[0], _e1353), _e1096[0], _e1352) - _e535.member[0])) + (_e1346 * (select(select(_e1112[1], _e1104[1], _e1353), _e1096[1], _e1352) - _e535.member[1]))) + (_e1349 * (select(select(_e1112[2], _e1104[2], _e1353), _e1096[2], _e1352) - _e535.member[2])));
                                let _e1372 = (((_e1341 * _e558) + (_e1346 * _e574)) + (_e1349 * _e590));
                                let _e1373 = (_e1322 - _e1326);
                                let _e1374 = (_e1320 - _e1324);
                                let _e1377 = ((_e1373 * _e1373) + (_e1374 * _e1374));
                                let _e1384 = (-(((_e1326 * _e1373) + (_e1324 * _e1374))) / select(0.000000000000000000000000000000000000011754944f, _e1377, (_e1377 > 0.000000000000000000000000000000000000011754944f)));
                                let _e1386 = select(1f, _e1384, (_e1384 < 1f));
                                let _e1388 = select(0f, _e1386, (_e1386 > 0f));
                                let _e1397 = ((_e1328.x + (_e1334.x * _e1388)) - _e535.member[0]);
                                let _e1400 = ((_e1328.y + (_e1334.y * _e1388)) - _e535.member[1]);
                                let _e1403 = ((_e1328.z + (_e1334.z * _e1388)) - _e535.member[2]);
                                let _e1468 = ((bitcast<f32>((bitcast<u32>(((((_e1341 * _e1397) + (_e1346 * _e1400)) + (_e1349 * _e1403)) - _e1367)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1397) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1400) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1403) & 2147483647u))), _e1307)) * max(max(bitcast<f32>((bitcast<u32>(_e1341) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1346) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1349) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1372) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1332.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1332.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1332.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1330.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1330.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1330.z) & 2147483647u)))))));
                                let _e1469 = (_e1367 / _e1372);
                                if (_e1256 && !(_e1468)) {
                                    let _e1472 = (_e1403 / _e590);
                                    let _e1480 = (((_e1341 * (_e1397 - (_e558 * _e1472))) + (_e1346 * (_e1400 - (_e574 * _e1472)))) / _e1372);
                                    phi_2885_ = select(select(_e1472, (_e1472 + _e1480), (bitcast<f32>((bitcast<u32>(_e1480) & 2147483647u)) <= _e1307)), _e1469, _e1468);
                                } else {
                                    phi_2885_ = _e1469;
                                }
                                let _e1489 = phi_2885_;
                                let _e1491 = select(_e1229, _e1489, (_e1489 < _e1229));
                                let _e1493 = select(_e1224, _e1491, (_e1491 > _e1224));
                                let _e1496 = select(_e1493, 0f, (bitcast<u32>(_e1493) == 2147483648u));
                                let _e1497 = (1f / _e1183);
                                phi_2911_ = SlimbvhTypeG(_e1496, (_e1177 * _e1497), (_e1181 * _e1497), ((_e1256 && (_e1496 >= _e602)) && (_e1496 <= _e972.member.member_1)));
                                phi_2912_ = SlimbvhTypeG();
                            } else {
                                phi_2911_ = SlimbvhTypeG();
                                phi_2912_ = SlimbvhTypeG(0f, 0f, 0f, _e1256);
                            }
                            let _e1506 = phi_2911_;
                            let _e1508 = phi_2912_;
                            phi_2915_ = _e1506;
                            phi_2916_ = _e1508;
                            phi_2917_ = select(true, false, _e1256);
                        } else {
                            phi_2915_ = SlimbvhTypeG();
                            phi_2916_ = SlimbvhTypeG(0f, 0f, 0f, _e1167);
                            phi_2917_ = true;
                        }
                        let _e1511 = phi_2915_;
                        let _e1513 = phi_2916_;
                        let _e1515 = phi_2917_;
                        if _e1515 {
                            phi_2921_ = _e1513;
                        } else {
                            phi_2921_ = _e1511;
                        }
                        let _e1517 = phi_2921_;
                        if _e1517.member_3 {
                            phi_2930_ = SlimbvhTypeH(_e1517.member, _e1517.member_1, _e1517.member_2, _e1035);
                        } else {
                            phi_2930_ = _e78;
                        }
                        let _e1524 = phi_2930_;
                        if (_e1524.member_3 != 4294967295u) {
                            if (_e1035 != 4294967295u) {
                                if (_e1524.member < _e972.member.member.member) {
                                    phi_2958_ = true;
                                } else {
                                    if (_e1524.member == _e972.member.member.member) {
                                        phi_2957_ = (_e1524.member_3 < _e972.member.member.member_3);
                                    } else {
                                        phi_2957_ = false;
                                    }
                                    let _e1539 = phi_2957_;
                                    phi_2958_ = _e1539;
                                }
                                let _e1541 = phi_2958_;
                                if _e1541 {
                                    phi_2965_ = SlimbvhTypeL(SlimbvhTypeI(_e1524, _e1524.member), _e972.member_1);
                                } else {
                                    phi_2965_ = _e972;
                                }
                                let _e1547 = phi_2965_;
                                if _e1547.member_1 {
                                    phi_2971_ = SlimbvhTypeL(SlimbvhTypeI(_e1547.member.member, bitcast<f32>(4286578687u)), _e1547.member_1);
                                } else {
                                    phi_2971_ = _e1547;
                                }
                                let _e1556 = phi_2971_;
                                phi_2972_ = _e1556;
                            } else {
                                phi_2972_ = _e972;
                            }
                            let _e1558 = phi_2972_;
                            phi_2973_ = _e1558;
                        } else {
                            phi_2973_ = _e972;
                        }
                        let _e1560 = phi_2973_;
                        phi_2100_ = _e1560;
                    } else {
                        phi_2100_ = SlimbvhTypeL();
                    }
                    let _e1562 = phi_2100_;
                    continue;
                    continuing {
                        phi_2099_ = _e1562;
                        phi_2102_ = _e987;
                        break if !(_e993);
                    }
                }
                let _e1565 = local_4;
                let _e1566 = (_e1565 - 1u);
                let _e1569 = local[(_e1566 % 128u)];
                let _e1570 = (_e1569 & 511u);
                let _e1572 = (_e1570 >> bitcast<u32>(3u));
                let _e1575 = ((_e1572 == 0u) || (_e1566 == 4294967295u));
                if _e1575 {
                } else {
                    local[(_e1566 % 128u)] = (((_e1569 >> bitcast<u32>(9u)) << bitcast<u32>(9u)) | _e1572);
                }
                let _e1582 = local_5;
                let _e1590 = (((_e1569 >> bitcast<u32>(9u)) << bitcast<u32>(2i)) | ((_e1570 & 3u) & 3u));
                let _e1592 = (_e1590 >> bitcast<u32>(2i));
                if (_e1592 < _e81) {
                    let _e1599 = slimbvh_nodes.member[_e1592].member_1[(_e1590 & 3u)];
                    phi_3029_ = _e1599;
                } else {
                    phi_3029_ = 2147483648u;
                }
                let _e1601 = phi_3029_;
                let _e1603 = local_6;
                let _e1852 = local_8;
                phi_3038_ = _e1852;
                phi_3039_ = select(select(_e1582, _e1566, _e1575), 4294967295u, (_e602 > _e1603.member.member_1));
                phi_3040_ = _e1601;
            } else {
                phi_3038_ = _e629;
                let _e1855 = local_9;
                phi_3039_ = _e1855;
                let _e1858 = local_10;
                phi_3040_ = _e1858;
            }
            let _e1609 = phi_3038_;
            let _e1611 = phi_3039_;
            let _e1613 = phi_3040_;
            phi_1479_ = _e1609;
            phi_1482_ = _e1611;
            phi_1484_ = _e1613;
            let _e1864 = local_11;
            phi_1486_ = _e1864;
        } else {
            phi_1479_ = SlimbvhTypeL();
            phi_1482_ = u32();
            phi_1484_ = u32();
            phi_1486_ = u32();
        }
        let _e1615 = phi_1479_;
        let _e1617 = phi_1482_;
        let _e1619 = phi_1484_;
        let _e1621 = phi_1486_;
        continue;
        continuing {
            phi_1478_ = _e1615;
            phi_1481_ = _e1617;
            phi_1483_ = _e1619;
            phi_1485_ = _e1621;
            break if !(_e636);
        }
    }
    let _e1624 = local_7;
    if (_e1624.member.member.member_3 != 4294967295u) {
        let _e1630 = -((_e105 + _e535.member_4));
        let _e1631 = bitcast<u32>(_e1624.member.member.member);
        let _e1635 = (bitcast<i32>((_e1631 >> bitcast<u32>(23i))) & 255i);
        let _e1636 = (_e1635 + _e1630);
        if (_e1635 == 255i) {
            phi_3097_ = _e1624.member.member.member;
        } else {
            if (_e1635 > 0i) {
                if (_e1636 > 0i) {
                    let _e1640 = (_e1636 < 255i);
                    if _e1640 {
                        phi_3076_ = bitcast<f32>((_e1631 + bitcast<u32>((_e1630 << bitcast<u32>(23i)))));
                    } else {
                        phi_3076_ = f32();
                    }
                    let _e1647 = phi_3076_;
                    phi_3078_ = _e1647;
                    phi_3079_ = select(true, false, _e1640);
                } else {
                    phi_3078_ = f32();
                    phi_3079_ = true;
                }
                let _e1650 = phi_3078_;
                let _e1652 = phi_3079_;
                phi_3080_ = _e1650;
                phi_3081_ = _e1652;
            } else {
                phi_3080_ = f32();
                phi_3081_ = true;
            }
            let _e1654 = phi_3080_;
            let _e1656 = phi_3081_;
            if _e1656 {
                let _e1657 = (_e1631 & 2147483648u);
                let _e1664 = ((_e1631 & 8388607u) | (select(0u, 1u, ((_e1631 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e1668 = (_e1664 == 0u);
                if _e1668 {
                    phi_3516_ = bitcast<f32>(_e1657);
                } else {
                    let _e1673 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1664)), 32u, _e1668) - 8u);
                    let _e1676 = (_e1664 << bitcast<u32>((_e1673 & 31u)));
                    let _e1678 = ((_e1636 + select(0i, 1i, (_e1635 == 0i))) - bitcast<i32>(_e1673));
                    if (_e1678 >= 255i) {
                        phi_3506_ = bitcast<f32>((_e1657 | 2139095040u));
                        phi_3507_ = f32();
                        phi_3508_ = true;
                    } else {
                        let _e1680 = (_e1678 > 0i);
                        if _e1680 {
                            phi_3500_ = bitcast<f32>(((_e1657 | (bitcast<u32>(_e1678) << bitcast<u32>(23i))) | (_e1676 & 8388607u)));
                            phi_3501_ = f32();
                        } else {
                            if (_e1678 < -24i) {
                                phi_3466_ = 26u;
                            } else {
                                phi_3466_ = bitcast<u32>((1i - _e1678));
                            }
                            let _e1685 = phi_3466_;
                            let _e1686 = (_e1685 & 31u);
                            let _e1688 = (_e1676 >> bitcast<u32>(_e1686));
                            let _e1692 = (_e1676 & ((1u << bitcast<u32>(_e1686)) - 1u));
                            let _e1696 = (1u << bitcast<u32>(((_e1685 - 1u) & 31u)));
                            if (_e1692 > _e1696) {
                                phi_3487_ = true;
                            } else {
                                if (_e1692 == _e1696) {
                                    phi_3484_ = ((_e1688 & 1u) == 1u);
                                } else {
                                    phi_3484_ = false;
                                }
                                let _e1702 = phi_3484_;
                                phi_3487_ = _e1702;
                            }
                            let _e1704 = phi_3487_;
                            phi_3500_ = f32();
                            phi_3501_ = bitcast<f32>((_e1657 | (_e1688 + select(0u, 1u, _e1704))));
                        }
                        let _e1717 = phi_3500_;
                        let _e1719 = phi_3501_;
                        phi_3506_ = _e1717;
                        phi_3507_ = _e1719;
                        phi_3508_ = _e1680;
                    }
                    let _e1723 = phi_3506_;
                    let _e1725 = phi_3507_;
                    let _e1727 = phi_3508_;
                    phi_3516_ = select(_e1725, _e1723, _e1727);
                }
                let _e1731 = phi_3516_;
                phi_3096_ = _e1731;
            } else {
                phi_3096_ = _e1654;
            }
            let _e1733 = phi_3096_;
            phi_3097_ = _e1733;
        }
        let _e1735 = phi_3097_;
        let _e1736 = bitcast<u32>(_e1735);
        if ((_e1736 & 2147483647u) >= 2139095040u) {
            phi_3109_ = bitcast<f32>(((_e1736 & 2147483648u) | 2139095039u));
        } else {
            phi_3109_ = _e1735;
        }
        let _e1743 = phi_3109_;
        phi_3114_ = SlimbvhTypeH(_e1743, _e1624.member.member.member_1, _e1624.member.member.member_2, _e1624.member.member.member_3);
    } else {
        phi_3114_ = _e78;
    }
    let _e1748 = phi_3114_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1748.member), bitcast<u32>(_e1748.member_1), bitcast<u32>(_e1748.member_2), _e1748.member_3);
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
