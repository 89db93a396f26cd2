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
    member: SlimbvhTypeF,
    member_1: f32,
}

struct SlimbvhTypeH {
    member: array<array<vec4<f32>, 4>>,
}

struct SlimbvhTypeI {
    member: vec4<f32>,
}

struct SlimbvhTypeJ {
    member: u32,
}

struct SlimbvhTypeK {
    member: SlimbvhTypeG,
    member_1: bool,
}

@group(0) @binding(0) 
var<uniform> slimbvh_exponent: SlimbvhTypeA;

@group(0) @binding(2) 
var<storage> slimbvh_triangles: SlimbvhTypeB;

@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeH;

var<private> slimbvh_origin: SlimbvhTypeI;

var<private> slimbvh_direction: SlimbvhTypeI;

var<private> slimbvh_any_will_do: SlimbvhTypeJ;

var<private> slimbvh_hit: SlimbvhTypeA;

fn slimbvh_trace() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_399_: u32;
    var phi_405_: u32;
    var phi_411_: u32;
    var phi_676_: i32;
    var phi_687_: i32;
    var phi_801_: i32;
    var phi_930_: i32;
    var phi_952_: u32;
    var phi_953_: u32;
    var phi_954_: bool;
    var phi_988_: i32;
    var phi_1010_: u32;
    var phi_1011_: u32;
    var phi_1012_: bool;
    var phi_573_: i32;
    var phi_579_: u32;
    var phi_598_: u32;
    var phi_599_: u32;
    var phi_600_: bool;
    var phi_618_: i32;
    var phi_624_: u32;
    var phi_643_: u32;
    var phi_644_: u32;
    var phi_645_: bool;
    var phi_1022_: SlimbvhTypeC;
    var phi_1217_: SlimbvhTypeK;
    var phi_1232_: SlimbvhTypeK;
    var phi_1235_: u32;
    var phi_1237_: u32;
    var phi_1239_: u32;
    var phi_1248_: u32;
    var phi_1251_: u32;
    var phi_1253_: u32;
    var phi_1550_: u32;
    var phi_1525_: u32;
    var phi_1551_: u32;
    var phi_1552_: u32;
    var phi_1249_: u32;
    var phi_1252_: u32;
    var phi_1254_: u32;
    var local_2: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1568_: SlimbvhTypeK;
    var phi_1571_: SlimbvhTypeD;
    var phi_1572_: SlimbvhTypeD;
    var phi_1594_: SlimbvhTypeD;
    var phi_1673_: array<vec4<f32>, 3>;
    var phi_1674_: array<vec4<f32>, 3>;
    var phi_1748_: array<vec4<f32>, 3>;
    var phi_1749_: array<vec4<f32>, 3>;
    var phi_1772_: array<f32, 3>;
    var phi_1773_: array<f32, 3>;
    var phi_1787_: array<f32, 3>;
    var phi_1788_: array<f32, 3>;
    var phi_1802_: array<f32, 3>;
    var phi_1803_: array<f32, 3>;
    var phi_2136_: f32;
    var phi_2137_: f32;
    var phi_2138_: f32;
    var phi_2139_: f32;
    var phi_2140_: vec3<f32>;
    var phi_2141_: vec3<f32>;
    var phi_2142_: vec3<f32>;
    var phi_2143_: vec3<f32>;
    var phi_2322_: f32;
    var phi_2348_: SlimbvhTypeE;
    var phi_2349_: SlimbvhTypeE;
    var phi_2352_: SlimbvhTypeE;
    var phi_2353_: SlimbvhTypeE;
    var phi_2354_: bool;
    var phi_2358_: SlimbvhTypeE;
    var phi_2367_: SlimbvhTypeF;
    var phi_2392_: bool;
    var phi_2393_: bool;
    var phi_2400_: SlimbvhTypeK;
    var phi_2406_: SlimbvhTypeK;
    var phi_2407_: SlimbvhTypeK;
    var phi_2408_: SlimbvhTypeK;
    var phi_1569_: SlimbvhTypeK;
    var local_5: u32;
    var local_6: SlimbvhTypeK;
    var phi_2433_: u32;
    var phi_2440_: SlimbvhTypeK;
    var phi_2441_: u32;
    var phi_2442_: u32;
    var phi_1233_: SlimbvhTypeK;
    var phi_1236_: u32;
    var phi_1238_: u32;
    var phi_1240_: u32;
    var local_7: SlimbvhTypeK;
    var phi_2476_: f32;
    var phi_2478_: f32;
    var phi_2479_: bool;
    var phi_2480_: f32;
    var phi_2481_: bool;
    var phi_2862_: u32;
    var phi_2880_: bool;
    var phi_2883_: bool;
    var phi_2896_: f32;
    var phi_2897_: f32;
    var phi_2902_: f32;
    var phi_2903_: f32;
    var phi_2904_: bool;
    var phi_2912_: f32;
    var phi_2496_: f32;
    var phi_2497_: f32;
    var phi_2509_: f32;
    var phi_2514_: SlimbvhTypeF;
    var local_8: SlimbvhTypeK;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e74 = SlimbvhTypeF(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e77 = arrayLength((&slimbvh_nodes.member));
    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
    let _e84 = slimbvh_origin.member;
    let _e90 = slimbvh_origin.member[3u];
    let _e91 = slimbvh_direction.member;
    let _e97 = slimbvh_direction.member[3u];
    let _e100 = slimbvh_exponent.member[0u];
    let _e101 = bitcast<i32>(_e100);
    let _e103 = (bitcast<u32>(_e84.x) & 2147483647u);
    let _e105 = (bitcast<u32>(_e84.y) & 2147483647u);
    let _e107 = (bitcast<u32>(_e84.z) & 2147483647u);
    let _e108 = bitcast<u32>(_e90);
    let _e109 = (_e108 & 2147483647u);
    let _e111 = (bitcast<u32>(_e91.x) & 2147483647u);
    let _e113 = (bitcast<u32>(_e91.y) & 2147483647u);
    let _e115 = (bitcast<u32>(_e91.z) & 2147483647u);
    let _e116 = bitcast<u32>(_e97);
    let _e117 = (_e116 & 2147483647u);
    let _e119 = select(_e113, _e111, (_e113 < _e111));
    let _e121 = select(_e115, _e119, (_e115 < _e119));
    let _e123 = select(_e103, _e121, (_e103 < _e121));
    let _e125 = select(_e105, _e123, (_e105 < _e123));
    let _e127 = select(_e107, _e125, (_e107 < _e125));
    let _e134 = (((select(_e109, _e127, (_e109 < _e127)) < 2139095040u) && (_e117 <= 2139095040u)) && (_e121 > 0u));
    if (_e111 == _e121) {
        phi_399_ = 0u;
    } else {
        phi_399_ = select(2u, 1u, (_e113 == _e121));
    }
    let _e139 = phi_399_;
    let _e140 = (_e139 == 2u);
    if _e140 {
        phi_405_ = 0u;
    } else {
        phi_405_ = (_e139 + 1u);
    }
    let _e143 = phi_405_;
    let _e144 = (_e143 == 2u);
    if _e144 {
        phi_411_ = 0u;
    } else {
        phi_411_ = (_e143 + 1u);
    }
    let _e147 = phi_411_;
    let _e148 = (_e143 == 0u);
    let _e150 = select(select(_e84.y, _e84.x, _e148), _e84.z, _e144);
    let _e151 = (_e147 == 0u);
    let _e153 = (_e147 == 2u);
    let _e154 = select(select(_e84.y, _e84.x, _e151), _e84.z, _e153);
    let _e155 = (_e139 == 0u);
    let _e157 = select(select(_e84.y, _e84.x, _e155), _e84.z, _e140);
    let _e159 = select(select(_e91.y, _e91.x, _e148), _e91.z, _e144);
    let _e161 = select(select(_e91.y, _e91.x, _e151), _e91.z, _e153);
    let _e163 = select(select(_e91.y, _e91.x, _e155), _e91.z, _e140);
    let _e164 = (_e109 - 1u);
    let _e165 = (_e117 - 1u);
    let _e167 = select(_e164, _e165, (_e165 < _e164));
    let _e168 = (_e103 - 1u);
    let _e169 = (_e105 - 1u);
    let _e171 = select(_e168, _e169, (_e169 < _e168));
    let _e172 = (_e107 - 1u);
    let _e174 = select(_e171, _e172, (_e172 < _e171));
    let _e175 = (_e111 - 1u);
    let _e176 = (_e113 - 1u);
    let _e178 = select(_e175, _e176, (_e176 < _e175));
    let _e179 = (_e115 - 1u);
    let _e181 = select(_e178, _e179, (_e179 < _e178));
    let _e183 = select(_e174, _e181, (_e181 < _e174));
    if (((select(_e183, _e167, (_e167 < _e183)) >= 8388607u) && (_e121 < 2130706432u)) && (bitcast<u32>((_e101 + 126i)) <= 253u)) {
        let _e448 = bitcast<i32>((_e121 >> bitcast<u32>(23i)));
        let _e449 = (_e448 - 127i);
        let _e450 = (_e101 + _e449);
        let _e455 = bitcast<f32>((bitcast<u32>((_e101 + 127i)) << bitcast<u32>(23i)));
        let _e460 = bitcast<f32>((bitcast<u32>((254i - _e448)) << bitcast<u32>(23i)));
        if (_e109 >= 2139095040u) {
            phi_573_ = 255i;
        } else {
            phi_573_ = (bitcast<i32>((_e109 >> bitcast<u32>(23i))) + _e450);
        }
        let _e475 = phi_573_;
        if (_e109 == 0u) {
            phi_579_ = 0u;
        } else {
            phi_579_ = (_e109 | 8388608u);
        }
        let _e479 = phi_579_;
        if (_e475 <= 0i) {
            phi_599_ = u32();
            phi_600_ = true;
        } else {
            let _e486 = (_e479 == 0u);
            if _e486 {
                phi_598_ = u32();
            } else {
                phi_598_ = select(((bitcast<u32>(_e475) << bitcast<u32>(23i)) | (_e479 & 8388607u)), 2139095039u, (_e475 >= 255i));
            }
            let _e490 = phi_598_;
            phi_599_ = _e490;
            phi_600_ = _e486;
        }
        let _e492 = phi_599_;
        let _e494 = phi_600_;
        if (_e117 >= 2139095040u) {
            phi_618_ = 255i;
        } else {
            phi_618_ = (bitcast<i32>((_e117 >> bitcast<u32>(23i))) + _e450);
        }
        let _e505 = phi_618_;
        if (_e117 == 0u) {
            phi_624_ = 0u;
        } else {
            phi_624_ = (_e117 | 8388608u);
        }
        let _e509 = phi_624_;
        if (_e505 <= 0i) {
            phi_644_ = u32();
            phi_645_ = true;
        } else {
            let _e516 = (_e509 == 0u);
            if _e516 {
                phi_643_ = u32();
            } else {
                phi_643_ = select(((bitcast<u32>(_e505) << bitcast<u32>(23i)) | (_e509 & 8388607u)), 2139095039u, (_e505 >= 255i));
            }
            let _e520 = phi_643_;
            phi_644_ = _e520;
            phi_645_ = _e516;
        }
        let _e522 = phi_644_;
        let _e524 = phi_645_;
        phi_1022_ = SlimbvhTypeC(array<f32, 3>((_e150 * _e455), (_e154 * _e455), (_e157 * _e455)), array<f32, 3>((_e159 * _e460), (_e161 * _e460), (_e163 * _e460)), bitcast<f32>(((_e108 & 2147483648u) | select(_e492, 0u, _e494))), bitcast<f32>(((_e116 & 2147483648u) | select(_e522, 0u, _e524))), _e449);
    } else {
        let _e196 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e121, _e134))) & 2147483647u);
        if (_e196 >= 8388608u) {
            phi_676_ = (bitcast<i32>((_e196 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_676_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e196)), 32u, (_e196 == 0u))));
        }
        let _e210 = phi_676_;
        let _e211 = (_e101 + _e210);
        if (_e101 < -126i) {
            phi_687_ = -126i;
        } else {
            phi_687_ = select(_e101, 127i, (_e101 > 127i));
        }
        let _e216 = phi_687_;
        let _e221 = bitcast<f32>((bitcast<u32>((_e216 + 127i)) << bitcast<u32>(23i)));
        let _e227 = bitcast<f32>((bitcast<u32>(((_e101 - _e216) + 127i)) << bitcast<u32>(23i)));
        let _e228 = bitcast<u32>(_e150);
        let _e230 = ((_e228 & 2139095040u) != 0u);
        let _e245 = bitcast<u32>(_e154);
        let _e247 = ((_e245 & 2139095040u) != 0u);
        let _e262 = bitcast<u32>(_e157);
        let _e264 = ((_e262 & 2139095040u) != 0u);
        let _e280 = -(_e210);
        if (_e280 < -126i) {
            phi_801_ = -126i;
        } else {
            phi_801_ = select(_e280, 127i, (_e280 > 127i));
        }
        let _e285 = phi_801_;
        let _e290 = bitcast<f32>((bitcast<u32>((_e285 + 127i)) << bitcast<u32>(23i)));
        let _e296 = bitcast<f32>((bitcast<u32>(((_e280 - _e285) + 127i)) << bitcast<u32>(23i)));
        let _e297 = bitcast<u32>(_e159);
        let _e299 = ((_e297 & 2139095040u) != 0u);
        let _e314 = bitcast<u32>(_e161);
        let _e316 = ((_e314 & 2139095040u) != 0u);
        let _e331 = bitcast<u32>(_e163);
        let _e333 = ((_e331 & 2139095040u) != 0u);
        let _e355 = ((_e109 & 8388607u) | (select(0u, 1u, ((_e109 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e358 = bitcast<i32>((_e109 >> bitcast<u32>(23i)));
        let _e365 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e355)), 32u, (_e355 == 0u))) - 8i);
        if (_e358 == 255i) {
            phi_930_ = 255i;
        } else {
            phi_930_ = (((_e358 + select(0i, 1i, (_e358 == 0i))) - _e365) + _e211);
        }
        let _e373 = phi_930_;
        let _e377 = (_e355 << bitcast<u32>(((_e365 & 31i) & 31i)));
        if (_e373 <= 0i) {
            phi_953_ = u32();
            phi_954_ = true;
        } else {
            let _e384 = (_e377 == 0u);
            if _e384 {
                phi_952_ = u32();
            } else {
                phi_952_ = select(((bitcast<u32>(_e373) << bitcast<u32>(23i)) | (_e377 & 8388607u)), 2139095039u, (_e373 >= 255i));
            }
            let _e388 = phi_952_;
            phi_953_ = _e388;
            phi_954_ = _e384;
        }
        let _e390 = phi_953_;
        let _e392 = phi_954_;
        let _e403 = ((_e117 & 8388607u) | (select(0u, 1u, ((_e117 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e406 = bitcast<i32>((_e117 >> bitcast<u32>(23i)));
        let _e413 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e403)), 32u, (_e403 == 0u))) - 8i);
        if (_e406 == 255i) {
            phi_988_ = 255i;
        } else {
            phi_988_ = (((_e406 + select(0i, 1i, (_e406 == 0i))) - _e413) + _e211);
        }
        let _e421 = phi_988_;
        let _e425 = (_e403 << bitcast<u32>(((_e413 & 31i) & 31i)));
        if (_e421 <= 0i) {
            phi_1011_ = u32();
            phi_1012_ = true;
        } else {
            let _e432 = (_e425 == 0u);
            if _e432 {
                phi_1010_ = u32();
            } else {
                phi_1010_ = select(((bitcast<u32>(_e421) << bitcast<u32>(23i)) | (_e425 & 8388607u)), 2139095039u, (_e421 >= 255i));
            }
            let _e436 = phi_1010_;
            phi_1011_ = _e436;
            phi_1012_ = _e432;
        }
        let _e438 = phi_1011_;
        let _e440 = phi_1012_;
        phi_1022_ = SlimbvhTypeC(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e228 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e228 & 2147483648u))), _e150, _e230) * _e221) * select(0.00000011920929f, 1f, _e230)) * _e227), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e245 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e245 & 2147483648u))), _e154, _e247) * _e221) * select(0.00000011920929f, 1f, _e247)) * _e227), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e262 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e262 & 2147483648u))), _e157, _e264) * _e221) * select(0.00000011920929f, 1f, _e264)) * _e227)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e297 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e297 & 2147483648u))), _e159, _e299) * _e290) * select(0.00000011920929f, 1f, _e299)) * _e296), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e314 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e314 & 2147483648u))), _e161, _e316) * _e290) * select(0.00000011920929f, 1f, _e316)) * _e296), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e331 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e331 & 2147483648u))), _e163, _e333) * _e290) * select(0.00000011920929f, 1f, _e333)) * _e296)), bitcast<f32>(((_e108 & 2147483648u) | select(_e390, 0u, _e392))), bitcast<f32>(((_e116 & 2147483648u) | select(_e438, 0u, _e440))), _e210);
    }
    let _e531 = phi_1022_;
    let _e546 = (bitcast<f32>((bitcast<u32>(_e531.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e549 = bitcast<f32>((bitcast<u32>(_e531.member[0]) & 2147483647u));
    let _e550 = (_e549 * 0.00000011920929f);
    let _e553 = select(select(0.00000000000011368684f, _e550, (_e550 > 0.00000000000011368684f)), 0f, _e546);
    let _e554 = select(0f, _e531.member_1[0], _e546);
    let _e555 = (_e531.member[0] + _e553);
    let _e556 = (_e531.member[0] - _e553);
    let _e558 = select(38685626000000000000000000f, (1f / _e531.member_1[0]), _e546);
    let _e562 = (bitcast<f32>((bitcast<u32>(_e531.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e565 = bitcast<f32>((bitcast<u32>(_e531.member[1]) & 2147483647u));
    let _e566 = (_e565 * 0.00000011920929f);
    let _e569 = select(select(0.00000000000011368684f, _e566, (_e566 > 0.00000000000011368684f)), 0f, _e562);
    let _e570 = select(0f, _e531.member_1[1], _e562);
    let _e571 = (_e531.member[1] + _e569);
    let _e572 = (_e531.member[1] - _e569);
    let _e574 = select(38685626000000000000000000f, (1f / _e531.member_1[1]), _e562);
    let _e578 = (bitcast<f32>((bitcast<u32>(_e531.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e581 = bitcast<f32>((bitcast<u32>(_e531.member[2]) & 2147483647u));
    let _e582 = (_e581 * 0.00000011920929f);
    let _e585 = select(select(0.00000000000011368684f, _e582, (_e582 > 0.00000000000011368684f)), 0f, _e578);
    let _e586 = select(0f, _e531.member_1[2], _e578);
    let _e587 = (_e531.member[2] + _e585);
    let _e588 = (_e531.member[2] - _e585);
    let _e590 = select(38685626000000000000000000f, (1f / _e531.member_1[2]), _e578);
    let _e592 = select(_e565, _e549, (_e549 > _e565));
    let _e596 = (_e134 && (select(_e581, _e592, (_e592 > _e581)) <= 1099511600000f));
    let _e597 = select(0f, _e531.member_3, _e596);
    let _e598 = select(1f, _e531.member_2, _e596);
    let _e600 = slimbvh_any_will_do.member;
    if (_e600 == 1u) {
        phi_1217_ = SlimbvhTypeK(SlimbvhTypeG(_e74, _e597), true);
    } else {
        phi_1217_ = SlimbvhTypeK(SlimbvhTypeG(_e74, _e597), false);
    }
    let _e607 = phi_1217_;
    phi_1232_ = _e607;
    phi_1235_ = select(4294967295u, 0u, (_e598 <= _e597));
    phi_1237_ = 0u;
    phi_1239_ = (_e77 + 1u);
    loop {
        let _e616 = phi_1232_;
        let _e618 = phi_1235_;
        let _e620 = phi_1237_;
        let _e622 = phi_1239_;
        local_7 = _e616;
        let _e623 = (_e618 <= 2147483647u);
        if _e623 {
            phi_1248_ = _e618;
            phi_1251_ = _e620;
            phi_1253_ = _e622;
            loop {
                let _e625 = phi_1248_;
                let _e627 = phi_1251_;
                let _e629 = phi_1253_;
                local_3 = _e627;
                local_4 = _e627;
                local_5 = _e625;
                local_9 = _e625;
                local_10 = _e627;
                local_11 = _e629;
                let _e630 = (_e625 <= 2147483647u);
                let _e633 = (_e630 && !((_e627 >= _e77)));
                local_2 = _e630;
                if _e633 {
                    let _e638 = slimbvh_nodes.member[_e627][3u][0u];
                    let _e643 = slimbvh_nodes.member[_e627][3u][1u];
                    let _e648 = slimbvh_nodes.member[_e627][((_e143 & 3u) % 4u)];
                    let _e653 = slimbvh_nodes.member[_e627][((_e147 & 3u) % 4u)];
                    let _e658 = slimbvh_nodes.member[_e627][((_e139 & 3u) % 4u)];
                    let _e659 = bitcast<u32>(_e638);
                    let _e660 = bitcast<u32>(_e643);
                    let _e671 = ((_e648.x - _e555) * _e558);
                    let _e672 = ((_e648.y - _e555) * _e558);
                    let _e673 = ((_e648.z - _e556) * _e558);
                    let _e674 = ((_e648.w - _e556) * _e558);
                    let _e675 = vec4<f32>(_e671, _e672, _e673, _e674);
                    let _e684 = ((_e653.x - _e571) * _e574);
                    let _e685 = ((_e653.y - _e571) * _e574);
                    let _e686 = ((_e653.z - _e572) * _e574);
                    let _e687 = ((_e653.w - _e572) * _e574);
                    let _e688 = vec4<f32>(_e684, _e685, _e686, _e687);
                    let _e697 = ((_e658.x - _e587) * _e590);
                    let _e698 = ((_e658.y - _e587) * _e590);
                    let _e699 = ((_e658.z - _e588) * _e590);
                    let _e700 = ((_e658.w - _e588) * _e590);
                    let _e701 = vec4<f32>(_e697, _e698, _e699, _e700);
                    let _e702 = vec4<f32>(_e673, _e674, _e671, _e672);
                    let _e703 = min(_e675, _e702);
                    let _e704 = vec4<f32>(_e686, _e687, _e684, _e685);
                    let _e705 = min(_e688, _e704);
                    let _e706 = vec4<f32>(_e699, _e700, _e697, _e698);
                    let _e707 = min(_e701, _e706);
                    let _e708 = max(_e675, _e702);
                    let _e709 = max(_e688, _e704);
                    let _e710 = max(_e701, _e706);
                    let _e739 = max(max(max(_e703.x, _e705.x), _e707.x), _e598);
                    let _e740 = max(max(max(_e703.y, _e705.y), _e707.y), _e598);
                    let _e743 = (_e739 <= min((min(min(_e708.x, _e709.x), _e710.x) + (max(_e710.x, -(_e707.x)) * 0.0000019073523f)), _e616.member.member_1));
                    let _e744 = (_e740 <= min((min(min(_e708.y, _e709.y), _e710.y) + (max(_e710.y, -(_e707.y)) * 0.0000019073523f)), _e616.member.member_1));
                    if (_e743 || _e744) {
                        let _e759 = (_e743 && (((_e739 <= _e740) != _e607.member_1) || !(_e744)));
                        if (_e743 && _e744) {
                            let _e764 = (_e625 % 128u);
                            local_1[_e764] = select(_e659, _e660, _e759);
                            local[_e764] = select(_e739, _e740, _e759);
                            phi_1525_ = (_e625 + 1u);
                        } else {
                            phi_1525_ = _e625;
                        }
                        let _e769 = phi_1525_;
                        phi_1551_ = _e769;
                        phi_1552_ = select(_e660, _e659, _e759);
                    } else {
                        let _e748 = (_e625 - 1u);
                        let _e749 = (_e748 % 128u);
                        let _e751 = local[_e749];
                        if (_e751 <= _e616.member.member_1) {
                            let _e754 = local_1[_e749];
                            phi_1550_ = _e754;
                        } else {
                            phi_1550_ = 2147483648u;
                        }
                        let _e756 = phi_1550_;
                        phi_1551_ = _e748;
                        phi_1552_ = _e756;
                    }
                    let _e771 = phi_1551_;
                    let _e773 = phi_1552_;
                    let _e774 = (_e629 - 1u);
                    phi_1249_ = select(_e771, 4294967295u, (_e774 == 0u));
                    phi_1252_ = _e773;
                    phi_1254_ = _e774;
                } else {
                    phi_1249_ = u32();
                    phi_1252_ = u32();
                    phi_1254_ = u32();
                }
                let _e778 = phi_1249_;
                let _e780 = phi_1252_;
                let _e782 = phi_1254_;
                continue;
                continuing {
                    phi_1248_ = _e778;
                    phi_1251_ = _e780;
                    phi_1253_ = _e782;
                    break if !(_e633);
                }
            }
            let _e785 = local_2;
            if _e785 {
                let _e787 = local_3;
                let _e790 = local_4;
                phi_1568_ = _e616;
                phi_1571_ = SlimbvhTypeD(0u, ((_e790 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e796 = phi_1568_;
                    let _e798 = phi_1571_;
                    local_6 = _e796;
                    local_8 = _e796;
                    if (_e798.member < _e798.member_1) {
                        phi_1572_ = SlimbvhTypeD((_e798.member + 1u), _e798.member_1);
                        phi_1594_ = SlimbvhTypeD(1u, _e798.member);
                    } else {
                        phi_1572_ = _e798;
                        phi_1594_ = SlimbvhTypeD(0u, SlimbvhTypeD().member_1);
                    }
                    let _e811 = phi_1572_;
                    let _e813 = phi_1594_;
                    let _e817 = (bitcast<i32>(_e813.member) != 0i);
                    if _e817 {
                        let _e818 = ((_e787 & 268435455u) + _e813.member_1);
                        let _e819 = (_e818 / 2u);
                        let _e820 = (_e818 % 2u);
                        let _e821 = (_e819 >= arrayLength((&slimbvh_triangles.member)));
                        if _e821 {
                            phi_1674_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e822 = (2u * _e820);
                            let _e826 = slimbvh_triangles.member[_e819][_e822];
                            let _e831 = slimbvh_triangles.member[_e819][(_e822 + 1u)];
                            let _e836 = slimbvh_triangles.member[_e819][(_e822 + 2u)];
                            if (_e820 == 0u) {
                                phi_1673_ = array<vec4<f32>, 3>(_e826, _e831, _e836);
                            } else {
                                phi_1673_ = array<vec4<f32>, 3>(vec4<f32>(_e826.z, _e826.w, _e831.x, _e831.y), vec4<f32>(_e831.z, _e831.w, _e836.x, _e836.y), vec4<f32>(_e836.z, _e836.w, 0f, 0f));
                            }
                            let _e854 = phi_1673_;
                            phi_1674_ = _e854;
                        }
                        let _e856 = phi_1674_;
                        let _e859 = bitcast<u32>(_e856[2].y);
                        if _e821 {
                            phi_1749_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e860 = (2u * _e820);
                            let _e864 = slimbvh_triangles.member[_e819][_e860];
                            let _e869 = slimbvh_triangles.member[_e819][(_e860 + 1u)];
                            let _e874 = slimbvh_triangles.member[_e819][(_e860 + 2u)];
                            if (_e820 == 0u) {
                                phi_1748_ = array<vec4<f32>, 3>(_e864, _e869, _e874);
                            } else {
                                phi_1748_ = array<vec4<f32>, 3>(vec4<f32>(_e864.z, _e864.w, _e869.x, _e869.y), vec4<f32>(_e869.z, _e869.w, _e874.x, _e874.y), vec4<f32>(_e874.z, _e874.w, 0f, 0f));
                            }
                            let _e892 = phi_1748_;
                            phi_1749_ = _e892;
                        }
                        let _e894 = phi_1749_;
                        if _e148 {
                            phi_1773_ = array<f32, 3>(_e894[0].x, _e894[0].y, _e894[0].z);
                        } else {
                            if (_e143 == 1u) {
                                phi_1772_ = array<f32, 3>(_e894[0].y, _e894[0].z, _e894[0].x);
                            } else {
                                phi_1772_ = array<f32, 3>(_e894[0].z, _e894[0].x, _e894[0].y);
                            }
                            let _e917 = phi_1772_;
                            phi_1773_ = _e917;
                        }
                        let _e920 = phi_1773_;
                        if _e148 {
                            phi_1788_ = array<f32, 3>(_e894[0].w, _e894[1].x, _e894[1].y);
                        } else {
                            if (_e143 == 1u) {
                                phi_1787_ = array<f32, 3>(_e894[1].x, _e894[1].y, _e894[0].w);
                            } else {
                                phi_1787_ = array<f32, 3>(_e894[1].y, _e894[0].w, _e894[1].x);
                            }
                            let _e925 = phi_1787_;
                            phi_1788_ = _e925;
                        }
                        let _e928 = phi_1788_;
                        if _e148 {
                            phi_1803_ = array<f32, 3>(_e894[1].z, _e894[1].w, _e894[2].x);
                        } else {
                            if (_e143 == 1u) {
                                phi_1802_ = array<f32, 3>(_e894[1].w, _e894[2].x, _e894[1].z);
                            } else {
                                phi_1802_ = array<f32, 3>(_e894[2].x, _e894[1].z, _e894[1].w);
                            }
                            let _e933 = phi_1802_;
                            phi_1803_ = _e933;
                        }
                        let _e936 = phi_1803_;
                        let _e950 = (_e920[2] - _e531.member[2]);
                        let _e953 = (((_e920[0] - _e531.member[0]) * _e586) - (_e950 * _e554));
                        let _e956 = (((_e920[1] - _e531.member[1]) * _e586) - (_e950 * _e570));
                        let _e959 = (_e928[2] - _e531.member[2]);
                        let _e962 = (((_e928[0] - _e531.member[0]) * _e586) - (_e959 * _e554));
                        let _e965 = (((_e928[1] - _e531.member[1]) * _e586) - (_e959 * _e570));
                        let _e968 = (_e936[2] - _e531.member[2]);
                        let _e971 = (((_e936[0] - _e531.member[0]) * _e586) - (_e968 * _e554));
                        let _e974 = (((_e936[1] - _e531.member[1]) * _e586) - (_e968 * _e570));
                        let _e975 = (_e971 * _e965);
                        let _e976 = (_e974 * _e962);
                        let _e977 = (_e953 * _e974);
                        let _e978 = (_e956 * _e971);
                        let _e979 = (_e962 * _e956);
                        let _e980 = (_e965 * _e953);
                        let _e985 = (((_e975 >= _e976) && (_e977 >= _e978)) && (_e979 >= _e980));
                        let _e991 = (_e985 || (((_e975 <= _e976) && (_e977 <= _e978)) && (_e979 <= _e980)));
                        if _e991 {
                            let _e993 = select(-1f, 1f, _e985);
                            let _e995 = ((_e975 - _e976) * _e993);
                            let _e997 = select(0f, _e995, (_e995 > 0f));
                            let _e999 = ((_e977 - _e978) * _e993);
                            let _e1001 = select(0f, _e999, (_e999 > 0f));
                            let _e1003 = ((_e979 - _e980) * _e993);
                            let _e1005 = select(0f, _e1003, (_e1003 > 0f));
                            let _e1007 = ((_e997 + _e1001) + _e1005);
                            let _e1022 = ((min(min(_e920[0], _e928[0]), _e936[0]) - _e555) * _e558);
                            let _e1023 = ((max(max(_e920[0], _e928[0]), _e936[0]) - _e556) * _e558);
                            let _e1024 = vec4<f32>(_e1022, f32(), _e1023, f32());
                            let _e1027 = ((min(min(_e920[1], _e928[1]), _e936[1]) - _e571) * _e574);
                            let _e1028 = ((max(max(_e920[1], _e928[1]), _e936[1]) - _e572) * _e574);
                            let _e1029 = vec4<f32>(_e1027, f32(), _e1028, f32());
                            let _e1032 = ((min(min(_e920[2], _e928[2]), _e936[2]) - _e587) * _e590);
                            let _e1033 = ((max(max(_e920[2], _e928[2]), _e936[2]) - _e588) * _e590);
                            let _e1034 = vec4<f32>(_e1032, f32(), _e1033, f32());
                            let _e1035 = vec4<f32>(_e1023, f32(), _e1022, f32());
                            let _e1037 = vec4<f32>(_e1028, f32(), _e1027, f32());
                            let _e1039 = vec4<f32>(_e1033, f32(), _e1032, f32());
                            let _e1048 = max(max(min(_e1024, _e1035).x, min(_e1029, _e1037).x), min(_e1034, _e1039).x);
                            let _e1053 = min(min(max(_e1024, _e1035).x, max(_e1029, _e1037).x), max(_e1034, _e1039).x);
                            let _e1058 = max(_e1048, _e598);
                            let _e1080 = (((((_e991 && (_e1007 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e953, _e962), _e971) <= 0f) && (max(max(_e953, _e962), _e971) >= 0f))) && ((min(min(_e956, _e965), _e974) <= 0f) && (max(max(_e956, _e965), _e974) >= 0f))) && (_e1058 <= (_e1053 + (max(max(_e1034, _e1039).x, -(min(_e1034, _e1039).x)) * 0.0000019073523f)))) && (_e1058 <= _e796.member.member_1));
                            if _e1080 {
                                let _e1085 = (_e928[0] - _e920[0]);
                                let _e1086 = (_e928[1] - _e920[1]);
                                let _e1087 = (_e928[2] - _e920[2]);
                                let _e1088 = vec3<f32>(_e1085, _e1086, _e1087);
                                let _e1089 = (_e936[0] - _e928[0]);
                                let _e1090 = (_e936[1] - _e928[1]);
                                let _e1091 = (_e936[2] - _e928[2]);
                                let _e1092 = vec3<f32>(_e1089, _e1090, _e1091);
                                let _e1093 = (_e920[0] - _e936[0]);
                                let _e1094 = (_e920[1] - _e936[1]);
                                let _e1095 = (_e920[2] - _e936[2]);
                                let _e1096 = vec3<f32>(_e1093, _e1094, _e1095);
                                let _e1107 = max(max(bitcast<f32>((bitcast<u32>(_e1085) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1086) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1087) & 2147483647u)));
                                let _e1118 = max(max(bitcast<f32>((bitcast<u32>(_e1089) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1090) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1091) & 2147483647u)));
                                let _e1131 = max(max(_e1107, _e1118), max(max(bitcast<f32>((bitcast<u32>(_e1093) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1094) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1095) & 2147483647u))));
                                if (_e1107 == _e1131) {
                                    phi_2136_ = _e965;
                                    phi_2137_ = _e962;
                                    phi_2138_ = _e956;
                                    phi_2139_ = _e953;
                                    phi_2140_ = vec3<f32>(_e920[0], _e920[1], _e920[2]);
                                    phi_2141_ = _e1096;
                                    phi_2142_ = _e1092;
                                    phi_2143_ = _e1088;
                                } else {
                                    let _e1133 = (_e1118 == _e1131);
                                    let _e1138 = vec3(_e1133);
                                    phi_2136_ = select(_e956, _e974, _e1133);
                                    phi_2137_ = select(_e953, _e971, _e1133);
                                    phi_2138_ = select(_e974, _e965, _e1133);
                                    phi_2139_ = select(_e971, _e962, _e1133);
                                    phi_2140_ = select(vec3<f32>(_e936[0], _e936[1], _e936[2]), vec3<f32>(_e928[0], _e928[1], _e928[2]), _e1138);
                                    phi_2141_ = select(_e1092, _e1088, _e1138);
                                    phi_2142_ = select(_e1088, _e1096, _e1138);
                                    phi_2143_ = select(_e1096, _e1092, _e1138);
                                }
                                let _e1144 = phi_2136_;
                                let _e1146 = phi_2137_;
                                let _e1148 = phi_2138_;
                                let _e1150 = phi_2139_;
                                let _e1152 = phi_2140_;
                                let _e1154 = phi_2141_;
                                let _e1156 = phi_2142_;
                                let _e1158 = phi_2143_;
                                let _e1165 = ((_e1156.y * _e1154.z) - (_e1154.y * _e1156.z));
                                let _e1170 = ((_e1156.z * _e1154.x) - (_e1154.z * _e1156.x));
                                let _e1173 = ((_e1156.x * _e1154.y) - (_e1154.x * _e1156.y));
                                let _e1176 = ((_e997 >= _e1001) && (_e997 >= _e1005));
                                let _e1177 = (_e1001 >= _e1005);
                                let _e1191 = (((_e1165 * (select(select(_e936[0], _e928[0], _e1177), _e920[0], _e1176) - _e531.member[0])) + (_e1170 * (select(select(_e936[1], _e928[1], _e1177), _e920[1], _e1176) - _e531.member[1]))) + (_e1173 * (select(select(_e936[2], _e928[2], _e1177), _e920[2], _e1176) - _e531.member[2])));
                                let _e1196 = (((_e1165 * _e554) + (_e1170 * _e570)) + (_e1173 * _e586));
                                let _e1197 = (_e1146 - _e1150);
                                let _e1198 = (_e1144 - _e1148);
                                let _e1201 = ((_e1197 * _e1197) + (_e1198 * _e1198));
                                let _e1208 = (-(((_e1150 * _e1197) + (_e1148 * _e1198))) / select(0.000000000000000000000000000000000000011754944f, _e1201, (_e1201 > 0.000000000000000000000000000000000000011754944f)));
                                let _e1210 = select(1f, _e1208, (_e1208 < 1f));
                                let _e1212 = select(0f, _e1210, (_e1210 > 0f));
                                let _e1221 = ((_e1152.x + (_e1158.x * _e1212)) - _e531.member[0]);
                                let _e1224 = ((_e1152.y + (_e1158.y * _e1212)) - _e531.member[1]);
                                let _e1227 = ((_e1152.z + (_e1158.z * _e1212)) - _e531.member[2]);
                                let _e1292 = ((bitcast<f32>((bitcast<u32>(((((_e1165 * _e1221) + (_e1170 * _e1224)) + (_e1173 * _e1227)) - _e1191)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1224) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1227) & 2147483647u))), _e1131)) * max(max(bitcast<f32>((bitcast<u32>(_e1165) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1170) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1173) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1196) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1156.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1156.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1156.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1154.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1154.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1154.z) & 2147483647u)))))));
                                let _e1293 = (_e1191 / _e1196);
                                if (_e1080 && !(_e1292)) {
                                    let _e1296 = (_e1227 / _e586);
                                    let _e1304 = (((_e1165 * (_e1221 - (_e554 * _e1296))) + (_e1170 * (_e1224 - (_e570 * _e1296)))) / _e1196);
                                    phi_2322_ = select(select(_e1296, (_e1296 + _e1304), (bitcast<f32>((bitcast<u32>(_e1304) & 2147483647u)) <= _e1131)), _e1293, _e1292);
                                } else {
                                    phi_2322_ = _e1293;
                                }
                                let _e1313 = phi_2322_;
                                let _e1315 = select(_e1053, _e1313, (_e1313 < _e1053));
                                let _e1317 = select(_e1048, _e1315, (_e1315 > _e1048));
                                let _e1320 = select(_e1317, 0f, (bitcast<u32>(_e1317) == 2147483648u));
                                let _e1321 = (1f / _e1007);
                                phi_2348_ = SlimbvhTypeE(_e1320, (_e1001 * _e1321), (_e1005 * _e1321), ((_e1080 && (_e1320 >= _e598)) && (_e1320 <= _e796.member.member_1)));
                                phi_2349_ = SlimbvhTypeE();
                            } else {
                                phi_2348_ = SlimbvhTypeE();
                                phi_2349_ = SlimbvhTypeE(0f, 0f, 0f, _e1080);
                            }
                            let _e1330 = phi_2348_;
                            let _e1332 = phi_2349_;
                            phi_2352_ = _e1330;
                            phi_2353_ = _e1332;
                            phi_2354_ = select(true, false, _e1080);
                        } else {
                            phi_2352_ = SlimbvhTypeE();
                            phi_2353_ = SlimbvhTypeE(0f, 0f, 0f, _e991);
                            phi_2354_ = true;
                        }
                        let _e1335 = phi_2352_;
                        let _e1337 = phi_2353_;
                        let _e1339 = phi_2354_;
                        if _e1339 {
                            phi_2358_ = _e1337;
                        } else {
                            phi_2358_ = _e1335;
                        }
                        let _e1341 = phi_2358_;
                        if _e1341.member_3 {
                            phi_2367_ = SlimbvhTypeF(_e1341.member, _e1341.member_1, _e1341.member_2, _e859);
                        } else {
                            phi_2367_ = _e74;
                        }
                        let _e1348 = phi_2367_;
                        if (_e1348.member_3 != 4294967295u) {
                            if (_e859 != 4294967295u) {
                                if (_e1348.member < _e796.member.member.member) {
                                    phi_2393_ = true;
                                } else {
                                    if (_e1348.member == _e796.member.member.member) {
                                        phi_2392_ = (_e1348.member_3 < _e796.member.member.member_3);
                                    } else {
                                        phi_2392_ = false;
                                    }
                                    let _e1363 = phi_2392_;
                                    phi_2393_ = _e1363;
                                }
                                let _e1365 = phi_2393_;
                                if _e1365 {
                                    phi_2400_ = SlimbvhTypeK(SlimbvhTypeG(_e1348, _e1348.member), _e796.member_1);
                                } else {
                                    phi_2400_ = _e796;
                                }
                                let _e1371 = phi_2400_;
                                if _e1371.member_1 {
                                    phi_2406_ = SlimbvhTypeK(SlimbvhTypeG(_e1371.member.member, bitcast<f32>(4286578687u)), _e1371.member_1);
                                } else {
                                    phi_2406_ = _e1371;
                                }
                                let _e1380 = phi_2406_;
                                phi_2407_ = _e1380;
                            } else {
                                phi_2407_ = _e796;
                            }
                            let _e1382 = phi_2407_;
                            phi_2408_ = _e1382;
                        } else {
                            phi_2408_ = _e796;
                        }
                        let _e1384 = phi_2408_;
                        phi_1569_ = _e1384;
                    } else {
                        phi_1569_ = SlimbvhTypeK();
                    }
                    let _e1386 = phi_1569_;
                    continue;
                    continuing {
                        phi_1568_ = _e1386;
                        phi_1571_ = _e811;
                        break if !(_e817);
                    }
                }
                let _e1389 = local_5;
                let _e1390 = (_e1389 - 1u);
                let _e1391 = (_e1390 % 128u);
                let _e1393 = local[_e1391];
                let _e1395 = local_6;
                if (_e1393 <= _e1395.member.member_1) {
                    let _e1400 = local_1[_e1391];
                    phi_2433_ = _e1400;
                } else {
                    phi_2433_ = 2147483648u;
                }
                let _e1402 = phi_2433_;
                let _e1639 = local_8;
                phi_2440_ = _e1639;
                phi_2441_ = select(_e1390, 4294967295u, (_e598 > _e1395.member.member_1));
                phi_2442_ = _e1402;
            } else {
                phi_2440_ = _e616;
                let _e1642 = local_9;
                phi_2441_ = _e1642;
                let _e1645 = local_10;
                phi_2442_ = _e1645;
            }
            let _e1406 = phi_2440_;
            let _e1408 = phi_2441_;
            let _e1410 = phi_2442_;
            phi_1233_ = _e1406;
            phi_1236_ = _e1408;
            phi_1238_ = _e1410;
            let _e1651 = local_11;
            phi_1240_ = _e1651;
        } else {
            phi_1233_ = SlimbvhTypeK();
            phi_1236_ = u32();
            phi_1238_ = u32();
            phi_1240_ = u32();
        }
        let _e1412 = phi_1233_;
        let _e1414 = phi_1236_;
        let _e1416 = phi_1238_;
        let _e1418 = phi_1240_;
        continue;
        continuing {
            phi_1232_ = _e1412;
            phi_1235_ = _e1414;
            phi_1237_ = _e1416;
            phi_1239_ = _e1418;
            break if !(_e623);
        }
    }
    let _e1421 = local_7;
    if (_e1421.member.member.member_3 != 4294967295u) {
        let _e1427 = -((_e101 + _e531.member_4));
        let _e1428 = bitcast<u32>(_e1421.member.member.member);
        let _e1432 = (bitcast<i32>((_e1428 >> bitcast<u32>(23i))) & 255i);
        let _e1433 = (_e1432 + _e1427);
        if (_e1432 == 255i) {
            phi_2497_ = _e1421.member.member.member;
        } else {
            if (_e1432 > 0i) {
                if (_e1433 > 0i) {
                    let _e1437 = (_e1433 < 255i);
                    if _e1437 {
                        phi_2476_ = bitcast<f32>((_e1428 + bitcast<u32>((_e1427 << bitcast<u32>(23i)))));
                    } else {
                        phi_2476_ = f32();
                    }
                    let _e1444 = phi_2476_;
                    phi_2478_ = _e1444;
                    phi_2479_ = select(true, false, _e1437);
                } else {
                    phi_2478_ = f32();
                    phi_2479_ = true;
                }
                let _e1447 = phi_2478_;
                let _e1449 = phi_2479_;
                phi_2480_ = _e1447;
                phi_2481_ = _e1449;
            } else {
                phi_2480_ = f32();
                phi_2481_ = true;
            }
            let _e1451 = phi_2480_;
            let _e1453 = phi_2481_;
            if _e1453 {
                let _e1454 = (_e1428 & 2147483648u);
                let _e1461 = ((_e1428 & 8388607u) | (select(0u, 1u, ((_e1428 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e1465 = (_e1461 == 0u);
                if _e1465 {
                    phi_2912_ = bitcast<f32>(_e1454);
                } else {
                    let _e1470 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1461)), 32u, _e1465) - 8u);
                    let _e1473 = (_e1461 << bitcast<u32>((_e1470 & 31u)));
                    let _e1475 = ((_e1433 + select(0i, 1i, (_e1432 == 0i))) - bitcast<i32>(_e1470));
                    if (_e1475 >= 255i) {
                        phi_2902_ = bitcast<f32>((_e1454 | 2139095040u));
                        phi_2903_ = f32();
                        phi_2904_ = true;
                    } else {
                        let _e1477 = (_e1475 > 0i);
                        if _e1477 {
                            phi_2896_ = bitcast<f32>(((_e1454 | (bitcast<u32>(_e1475) << bitcast<u32>(23i))) | (_e1473 & 8388607u)));
                            phi_2897_ = f32();
                        } else {
                            if (_e1475 < -24i) {
                                phi_2862_ = 26u;
                            } else {
                                phi_2862_ = bitcast<u32>((1i - _e1475));
                            }
                            let _e1482 = phi_2862_;
                            let _e1483 = (_e1482 & 31u);
                            let _e1485 = (_e1473 >> bitcast<u32>(_e1483));
                            let _e1489 = (_e1473 & ((1u << bitcast<u32>(_e1483)) - 1u));
                            let _e1493 = (1u << bitcast<u32>(((_e1482 - 1u) & 31u)));
                            if (_e1489 > _e1493) {
                                phi_2883_ = true;
                            } else {
                                if (_e1489 == _e1493) {
                                    phi_2880_ = ((_e1485 & 1u) == 1u);
                                } else {
                                    phi_2880_ = false;
                                }
                                let _e1499 = phi_2880_;
                                phi_2883_ = _e1499;
                            }
                            let _e1501 = phi_2883_;
                            phi_2896_ = f32();
                            phi_2897_ = bitcast<f32>((_e1454 | (_e1485 + select(0u, 1u, _e1501))));
                        }
                        let _e1514 = phi_2896_;
                        let _e1516 = phi_2897_;
                        phi_2902_ = _e1514;
                        phi_2903_ = _e1516;
                        phi_2904_ = _e1477;
                    }
                    let _e1520 = phi_2902_;
                    let _e1522 = phi_2903_;
                    let _e1524 = phi_2904_;
                    phi_2912_ = select(_e1522, _e1520, _e1524);
                }
                let _e1528 = phi_2912_;
                phi_2496_ = _e1528;
            } else {
                phi_2496_ = _e1451;
            }
            let _e1530 = phi_2496_;
            phi_2497_ = _e1530;
        }
        let _e1532 = phi_2497_;
        let _e1533 = bitcast<u32>(_e1532);
        if ((_e1533 & 2147483647u) >= 2139095040u) {
            phi_2509_ = bitcast<f32>(((_e1533 & 2147483648u) | 2139095039u));
        } else {
            phi_2509_ = _e1532;
        }
        let _e1540 = phi_2509_;
        phi_2514_ = SlimbvhTypeF(_e1540, _e1421.member.member.member_1, _e1421.member.member.member_2, _e1421.member.member.member_3);
    } else {
        phi_2514_ = _e74;
    }
    let _e1545 = phi_2514_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1545.member), bitcast<u32>(_e1545.member_1), bitcast<u32>(_e1545.member_2), _e1545.member_3);
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
