// Made by slimbvh's shader builder from its Rust: rays traced from your own WGSL. Put this text before yours, bind the
// tree's exponent, nodes and triangles to group 0, and call
//
//   slimbvh_closest_hit(origin, t_min, direction, t_max) -> SlimbvhHit
//   slimbvh_any_hit(origin, t_min, direction, t_max) -> bool
//
// from any stage. t is in units of the direction's length; a miss has the primitive 0xffffffff.

struct SlimbvhTypeA {
    member: u32,
    member_1: u32,
}

struct SlimbvhTypeB {
    member: vec4<u32>,
}

struct SlimbvhTypeC {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct SlimbvhTypeD {
    member: array<array<vec4<f32>, 4>>,
}

struct SlimbvhTypeE {
    member: array<array<vec4<f32>, 5>>,
}

struct SlimbvhTypeF {
    member: vec4<f32>,
}

struct SlimbvhTypeG {
    member: u32,
}

struct SlimbvhTypeH {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
    member_2: f32,
    member_3: f32,
    member_4: i32,
}

struct SlimbvhTypeI {
    member: SlimbvhTypeC,
    member_1: f32,
}

struct SlimbvhTypeJ {
    member: SlimbvhTypeI,
    member_1: bool,
}

struct SlimbvhTypeK {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

@group(0) @binding(0) 
var<uniform> slimbvh_exponent: SlimbvhTypeB;
@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeD;
@group(0) @binding(2) 
var<storage> slimbvh_triangles: SlimbvhTypeE;
var<private> slimbvh_origin: SlimbvhTypeF;
var<private> slimbvh_direction: SlimbvhTypeF;
var<private> slimbvh_any_will_do: SlimbvhTypeG;
var<private> slimbvh_hit: SlimbvhTypeB;

fn slimbvh_trace() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_266_: u32;
    var phi_272_: u32;
    var phi_278_: u32;
    var phi_543_: i32;
    var phi_554_: i32;
    var phi_668_: i32;
    var phi_797_: i32;
    var phi_819_: u32;
    var phi_820_: u32;
    var phi_821_: bool;
    var phi_855_: i32;
    var phi_877_: u32;
    var phi_878_: u32;
    var phi_879_: bool;
    var phi_440_: i32;
    var phi_446_: u32;
    var phi_465_: u32;
    var phi_466_: u32;
    var phi_467_: bool;
    var phi_485_: i32;
    var phi_491_: u32;
    var phi_510_: u32;
    var phi_511_: u32;
    var phi_512_: bool;
    var phi_889_: SlimbvhTypeH;
    var phi_1084_: SlimbvhTypeJ;
    var phi_1098_: SlimbvhTypeJ;
    var phi_1101_: u32;
    var phi_1103_: u32;
    var phi_1105_: u32;
    var phi_1114_: u32;
    var phi_1117_: u32;
    var phi_1119_: u32;
    var phi_1398_: u32;
    var phi_1373_: u32;
    var phi_1399_: u32;
    var phi_1400_: u32;
    var phi_1115_: u32;
    var phi_1118_: u32;
    var phi_1120_: u32;
    var local_2: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1416_: SlimbvhTypeJ;
    var phi_1419_: SlimbvhTypeA;
    var phi_1420_: SlimbvhTypeA;
    var phi_1442_: SlimbvhTypeA;
    var phi_1521_: array<vec4<f32>, 3>;
    var phi_1522_: array<vec4<f32>, 3>;
    var phi_1596_: array<vec4<f32>, 3>;
    var phi_1597_: array<vec4<f32>, 3>;
    var phi_1620_: array<f32, 3>;
    var phi_1621_: array<f32, 3>;
    var phi_1635_: array<f32, 3>;
    var phi_1636_: array<f32, 3>;
    var phi_1650_: array<f32, 3>;
    var phi_1651_: array<f32, 3>;
    var phi_1967_: f32;
    var phi_1968_: f32;
    var phi_1969_: f32;
    var phi_1970_: f32;
    var phi_1971_: vec3<f32>;
    var phi_1972_: vec3<f32>;
    var phi_1973_: vec3<f32>;
    var phi_1974_: vec3<f32>;
    var phi_2153_: f32;
    var phi_2179_: SlimbvhTypeK;
    var phi_2180_: SlimbvhTypeK;
    var phi_2183_: SlimbvhTypeK;
    var phi_2184_: SlimbvhTypeK;
    var phi_2185_: bool;
    var phi_2189_: SlimbvhTypeK;
    var phi_2198_: SlimbvhTypeC;
    var phi_2223_: bool;
    var phi_2224_: bool;
    var phi_2231_: SlimbvhTypeJ;
    var phi_2237_: SlimbvhTypeJ;
    var phi_2238_: SlimbvhTypeJ;
    var phi_2239_: SlimbvhTypeJ;
    var phi_1417_: SlimbvhTypeJ;
    var local_5: u32;
    var local_6: SlimbvhTypeJ;
    var phi_2264_: u32;
    var phi_2271_: SlimbvhTypeJ;
    var phi_2272_: u32;
    var phi_2273_: u32;
    var phi_1099_: SlimbvhTypeJ;
    var phi_1102_: u32;
    var phi_1104_: u32;
    var phi_1106_: u32;
    var local_7: SlimbvhTypeJ;
    var phi_2307_: f32;
    var phi_2309_: f32;
    var phi_2310_: bool;
    var phi_2311_: f32;
    var phi_2312_: bool;
    var phi_2595_: u32;
    var phi_2613_: bool;
    var phi_2616_: bool;
    var phi_2629_: f32;
    var phi_2630_: f32;
    var phi_2635_: f32;
    var phi_2636_: f32;
    var phi_2637_: bool;
    var phi_2645_: f32;
    var phi_2327_: f32;
    var phi_2328_: f32;
    var phi_2340_: f32;
    var phi_2345_: SlimbvhTypeC;
    var local_8: SlimbvhTypeJ;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e72 = SlimbvhTypeC(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e74 = arrayLength((&slimbvh_nodes.member));
    let _e81 = slimbvh_origin.member;
    let _e87 = slimbvh_origin.member[3u];
    let _e88 = slimbvh_direction.member;
    let _e94 = slimbvh_direction.member[3u];
    let _e97 = slimbvh_exponent.member[0u];
    let _e98 = bitcast<i32>(_e97);
    let _e100 = (bitcast<u32>(_e81.x) & 2147483647u);
    let _e102 = (bitcast<u32>(_e81.y) & 2147483647u);
    let _e104 = (bitcast<u32>(_e81.z) & 2147483647u);
    let _e105 = bitcast<u32>(_e87);
    let _e106 = (_e105 & 2147483647u);
    let _e108 = (bitcast<u32>(_e88.x) & 2147483647u);
    let _e110 = (bitcast<u32>(_e88.y) & 2147483647u);
    let _e112 = (bitcast<u32>(_e88.z) & 2147483647u);
    let _e113 = bitcast<u32>(_e94);
    let _e114 = (_e113 & 2147483647u);
    let _e116 = select(_e110, _e108, (_e110 < _e108));
    let _e118 = select(_e112, _e116, (_e112 < _e116));
    let _e120 = select(_e100, _e118, (_e100 < _e118));
    let _e122 = select(_e102, _e120, (_e102 < _e120));
    let _e124 = select(_e104, _e122, (_e104 < _e122));
    let _e131 = (((select(_e106, _e124, (_e106 < _e124)) < 2139095040u) && (_e114 <= 2139095040u)) && (_e118 > 0u));
    if (_e108 == _e118) {
        phi_266_ = 0u;
    } else {
        phi_266_ = select(2u, 1u, (_e110 == _e118));
    }
    let _e136 = phi_266_;
    let _e137 = (_e136 == 2u);
    if _e137 {
        phi_272_ = 0u;
    } else {
        phi_272_ = (_e136 + 1u);
    }
    let _e140 = phi_272_;
    let _e141 = (_e140 == 2u);
    if _e141 {
        phi_278_ = 0u;
    } else {
        phi_278_ = (_e140 + 1u);
    }
    let _e144 = phi_278_;
    let _e145 = (_e140 == 0u);
    let _e147 = select(select(_e81.y, _e81.x, _e145), _e81.z, _e141);
    let _e148 = (_e144 == 0u);
    let _e150 = (_e144 == 2u);
    let _e151 = select(select(_e81.y, _e81.x, _e148), _e81.z, _e150);
    let _e152 = (_e136 == 0u);
    let _e154 = select(select(_e81.y, _e81.x, _e152), _e81.z, _e137);
    let _e156 = select(select(_e88.y, _e88.x, _e145), _e88.z, _e141);
    let _e158 = select(select(_e88.y, _e88.x, _e148), _e88.z, _e150);
    let _e160 = select(select(_e88.y, _e88.x, _e152), _e88.z, _e137);
    let _e161 = (_e106 - 1u);
    let _e162 = (_e114 - 1u);
    let _e164 = select(_e161, _e162, (_e162 < _e161));
    let _e165 = (_e100 - 1u);
    let _e166 = (_e102 - 1u);
    let _e168 = select(_e165, _e166, (_e166 < _e165));
    let _e169 = (_e104 - 1u);
    let _e171 = select(_e168, _e169, (_e169 < _e168));
    let _e172 = (_e108 - 1u);
    let _e173 = (_e110 - 1u);
    let _e175 = select(_e172, _e173, (_e173 < _e172));
    let _e176 = (_e112 - 1u);
    let _e178 = select(_e175, _e176, (_e176 < _e175));
    let _e180 = select(_e171, _e178, (_e178 < _e171));
    if ((((select(_e180, _e164, (_e164 < _e180)) >= 8388607u) && (_e118 < 2130706432u)) && (_e98 >= -126i)) && (_e98 <= 127i)) {
        let _e445 = bitcast<i32>((_e118 >> bitcast<u32>(23i)));
        let _e446 = (_e445 - 127i);
        let _e447 = (_e98 + _e446);
        let _e452 = bitcast<f32>((bitcast<u32>((_e98 + 127i)) << bitcast<u32>(23i)));
        let _e457 = bitcast<f32>((bitcast<u32>((254i - _e445)) << bitcast<u32>(23i)));
        if (_e106 >= 2139095040u) {
            phi_440_ = 255i;
        } else {
            phi_440_ = (bitcast<i32>((_e106 >> bitcast<u32>(23i))) + _e447);
        }
        let _e472 = phi_440_;
        if (_e106 == 0u) {
            phi_446_ = 0u;
        } else {
            phi_446_ = (_e106 | 8388608u);
        }
        let _e476 = phi_446_;
        if (_e472 <= 0i) {
            phi_466_ = u32();
            phi_467_ = true;
        } else {
            let _e483 = (_e476 == 0u);
            if _e483 {
                phi_465_ = u32();
            } else {
                phi_465_ = select(((bitcast<u32>(_e472) << bitcast<u32>(23i)) | (_e476 & 8388607u)), 2139095039u, (_e472 >= 255i));
            }
            let _e487 = phi_465_;
            phi_466_ = _e487;
            phi_467_ = _e483;
        }
        let _e489 = phi_466_;
        let _e491 = phi_467_;
        if (_e114 >= 2139095040u) {
            phi_485_ = 255i;
        } else {
            phi_485_ = (bitcast<i32>((_e114 >> bitcast<u32>(23i))) + _e447);
        }
        let _e502 = phi_485_;
        if (_e114 == 0u) {
            phi_491_ = 0u;
        } else {
            phi_491_ = (_e114 | 8388608u);
        }
        let _e506 = phi_491_;
        if (_e502 <= 0i) {
            phi_511_ = u32();
            phi_512_ = true;
        } else {
            let _e513 = (_e506 == 0u);
            if _e513 {
                phi_510_ = u32();
            } else {
                phi_510_ = select(((bitcast<u32>(_e502) << bitcast<u32>(23i)) | (_e506 & 8388607u)), 2139095039u, (_e502 >= 255i));
            }
            let _e517 = phi_510_;
            phi_511_ = _e517;
            phi_512_ = _e513;
        }
        let _e519 = phi_511_;
        let _e521 = phi_512_;
        phi_889_ = SlimbvhTypeH(array<f32, 3>((_e147 * _e452), (_e151 * _e452), (_e154 * _e452)), array<f32, 3>((_e156 * _e457), (_e158 * _e457), (_e160 * _e457)), bitcast<f32>(((_e105 & 2147483648u) | select(_e489, 0u, _e491))), bitcast<f32>(((_e113 & 2147483648u) | select(_e519, 0u, _e521))), _e446);
    } else {
        let _e193 = (bitcast<u32>(bitcast<f32>(select(1065353216u, _e118, _e131))) & 2147483647u);
        if (_e193 >= 8388608u) {
            phi_543_ = (bitcast<i32>((_e193 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_543_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e193)), 32u, (_e193 == 0u))));
        }
        let _e207 = phi_543_;
        let _e208 = (_e98 + _e207);
        if (_e98 < -126i) {
            phi_554_ = -126i;
        } else {
            phi_554_ = select(_e98, 127i, (_e98 > 127i));
        }
        let _e213 = phi_554_;
        let _e218 = bitcast<f32>((bitcast<u32>((_e213 + 127i)) << bitcast<u32>(23i)));
        let _e224 = bitcast<f32>((bitcast<u32>(((_e98 - _e213) + 127i)) << bitcast<u32>(23i)));
        let _e225 = bitcast<u32>(_e147);
        let _e227 = ((_e225 & 2139095040u) != 0u);
        let _e242 = bitcast<u32>(_e151);
        let _e244 = ((_e242 & 2139095040u) != 0u);
        let _e259 = bitcast<u32>(_e154);
        let _e261 = ((_e259 & 2139095040u) != 0u);
        let _e277 = -(_e207);
        if (_e277 < -126i) {
            phi_668_ = -126i;
        } else {
            phi_668_ = select(_e277, 127i, (_e277 > 127i));
        }
        let _e282 = phi_668_;
        let _e287 = bitcast<f32>((bitcast<u32>((_e282 + 127i)) << bitcast<u32>(23i)));
        let _e293 = bitcast<f32>((bitcast<u32>(((_e277 - _e282) + 127i)) << bitcast<u32>(23i)));
        let _e294 = bitcast<u32>(_e156);
        let _e296 = ((_e294 & 2139095040u) != 0u);
        let _e311 = bitcast<u32>(_e158);
        let _e313 = ((_e311 & 2139095040u) != 0u);
        let _e328 = bitcast<u32>(_e160);
        let _e330 = ((_e328 & 2139095040u) != 0u);
        let _e352 = ((_e106 & 8388607u) | (select(0u, 1u, ((_e106 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e355 = bitcast<i32>((_e106 >> bitcast<u32>(23i)));
        let _e362 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e352)), 32u, (_e352 == 0u))) - 8i);
        if (_e355 == 255i) {
            phi_797_ = 255i;
        } else {
            phi_797_ = (((_e355 + select(0i, 1i, (_e355 == 0i))) - _e362) + _e208);
        }
        let _e370 = phi_797_;
        let _e374 = (_e352 << bitcast<u32>(((_e362 & 31i) & 31i)));
        if (_e370 <= 0i) {
            phi_820_ = u32();
            phi_821_ = true;
        } else {
            let _e381 = (_e374 == 0u);
            if _e381 {
                phi_819_ = u32();
            } else {
                phi_819_ = select(((bitcast<u32>(_e370) << bitcast<u32>(23i)) | (_e374 & 8388607u)), 2139095039u, (_e370 >= 255i));
            }
            let _e385 = phi_819_;
            phi_820_ = _e385;
            phi_821_ = _e381;
        }
        let _e387 = phi_820_;
        let _e389 = phi_821_;
        let _e400 = ((_e114 & 8388607u) | (select(0u, 1u, ((_e114 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e403 = bitcast<i32>((_e114 >> bitcast<u32>(23i)));
        let _e410 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e400)), 32u, (_e400 == 0u))) - 8i);
        if (_e403 == 255i) {
            phi_855_ = 255i;
        } else {
            phi_855_ = (((_e403 + select(0i, 1i, (_e403 == 0i))) - _e410) + _e208);
        }
        let _e418 = phi_855_;
        let _e422 = (_e400 << bitcast<u32>(((_e410 & 31i) & 31i)));
        if (_e418 <= 0i) {
            phi_878_ = u32();
            phi_879_ = true;
        } else {
            let _e429 = (_e422 == 0u);
            if _e429 {
                phi_877_ = u32();
            } else {
                phi_877_ = select(((bitcast<u32>(_e418) << bitcast<u32>(23i)) | (_e422 & 8388607u)), 2139095039u, (_e418 >= 255i));
            }
            let _e433 = phi_877_;
            phi_878_ = _e433;
            phi_879_ = _e429;
        }
        let _e435 = phi_878_;
        let _e437 = phi_879_;
        phi_889_ = SlimbvhTypeH(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e225 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e225 & 2147483648u))), _e147, _e227) * _e218) * select(0.00000011920929f, 1f, _e227)) * _e224), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e242 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e242 & 2147483648u))), _e151, _e244) * _e218) * select(0.00000011920929f, 1f, _e244)) * _e224), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e259 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e259 & 2147483648u))), _e154, _e261) * _e218) * select(0.00000011920929f, 1f, _e261)) * _e224)), array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e294 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e294 & 2147483648u))), _e156, _e296) * _e287) * select(0.00000011920929f, 1f, _e296)) * _e293), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e311 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e311 & 2147483648u))), _e158, _e313) * _e287) * select(0.00000011920929f, 1f, _e313)) * _e293), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e328 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e328 & 2147483648u))), _e160, _e330) * _e287) * select(0.00000011920929f, 1f, _e330)) * _e293)), bitcast<f32>(((_e105 & 2147483648u) | select(_e387, 0u, _e389))), bitcast<f32>(((_e113 & 2147483648u) | select(_e435, 0u, _e437))), _e207);
    }
    let _e528 = phi_889_;
    let _e543 = (bitcast<f32>((bitcast<u32>(_e528.member_1[0]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e546 = bitcast<f32>((bitcast<u32>(_e528.member[0]) & 2147483647u));
    let _e547 = (_e546 * 0.00000011920929f);
    let _e550 = select(select(0.00000000000011368684f, _e547, (_e547 > 0.00000000000011368684f)), 0f, _e543);
    let _e551 = select(0f, _e528.member_1[0], _e543);
    let _e552 = (_e528.member[0] + _e550);
    let _e553 = (_e528.member[0] - _e550);
    let _e555 = select(38685626000000000000000000f, (1f / _e528.member_1[0]), _e543);
    let _e559 = (bitcast<f32>((bitcast<u32>(_e528.member_1[1]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e562 = bitcast<f32>((bitcast<u32>(_e528.member[1]) & 2147483647u));
    let _e563 = (_e562 * 0.00000011920929f);
    let _e566 = select(select(0.00000000000011368684f, _e563, (_e563 > 0.00000000000011368684f)), 0f, _e559);
    let _e567 = select(0f, _e528.member_1[1], _e559);
    let _e568 = (_e528.member[1] + _e566);
    let _e569 = (_e528.member[1] - _e566);
    let _e571 = select(38685626000000000000000000f, (1f / _e528.member_1[1]), _e559);
    let _e575 = (bitcast<f32>((bitcast<u32>(_e528.member_1[2]) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e578 = bitcast<f32>((bitcast<u32>(_e528.member[2]) & 2147483647u));
    let _e579 = (_e578 * 0.00000011920929f);
    let _e582 = select(select(0.00000000000011368684f, _e579, (_e579 > 0.00000000000011368684f)), 0f, _e575);
    let _e583 = select(0f, _e528.member_1[2], _e575);
    let _e584 = (_e528.member[2] + _e582);
    let _e585 = (_e528.member[2] - _e582);
    let _e587 = select(38685626000000000000000000f, (1f / _e528.member_1[2]), _e575);
    let _e589 = select(_e562, _e546, (_e546 > _e562));
    let _e593 = (_e131 && (select(_e578, _e589, (_e589 > _e578)) <= 1099511600000f));
    let _e594 = select(0f, _e528.member_3, _e593);
    let _e595 = select(1f, _e528.member_2, _e593);
    let _e597 = slimbvh_any_will_do.member;
    if (_e597 == 1u) {
        phi_1084_ = SlimbvhTypeJ(SlimbvhTypeI(_e72, _e594), true);
    } else {
        phi_1084_ = SlimbvhTypeJ(SlimbvhTypeI(_e72, _e594), false);
    }
    let _e604 = phi_1084_;
    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
    phi_1098_ = _e604;
    phi_1101_ = 0u;
    phi_1103_ = select(4294967295u, 0u, (_e595 <= _e594));
    phi_1105_ = (_e74 + 1u);
    loop {
        let _e612 = phi_1098_;
        let _e614 = phi_1101_;
        let _e616 = phi_1103_;
        let _e618 = phi_1105_;
        local_7 = _e612;
        let _e619 = (_e616 <= 2147483647u);
        if _e619 {
            phi_1114_ = _e614;
            phi_1117_ = _e616;
            phi_1119_ = _e618;
            loop {
                let _e621 = phi_1114_;
                let _e623 = phi_1117_;
                let _e625 = phi_1119_;
                local_3 = _e621;
                local_4 = _e621;
                local_5 = _e623;
                local_9 = _e621;
                local_10 = _e623;
                local_11 = _e625;
                let _e626 = (_e623 <= 2147483647u);
                let _e629 = (_e626 && !((_e621 >= _e74)));
                local_2 = _e626;
                if _e629 {
                    let _e634 = slimbvh_nodes.member[_e621][3u][0u];
                    let _e639 = slimbvh_nodes.member[_e621][3u][1u];
                    let _e644 = slimbvh_nodes.member[_e621][((_e140 & 3u) % 4u)];
                    let _e649 = slimbvh_nodes.member[_e621][((_e144 & 3u) % 4u)];
                    let _e654 = slimbvh_nodes.member[_e621][((_e136 & 3u) % 4u)];
                    let _e655 = bitcast<u32>(_e634);
                    let _e656 = bitcast<u32>(_e639);
                    let _e667 = ((_e644.x - _e552) * _e555);
                    let _e668 = ((_e644.y - _e552) * _e555);
                    let _e669 = ((_e644.z - _e553) * _e555);
                    let _e670 = ((_e644.w - _e553) * _e555);
                    let _e679 = ((_e649.x - _e568) * _e571);
                    let _e680 = ((_e649.y - _e568) * _e571);
                    let _e681 = ((_e649.z - _e569) * _e571);
                    let _e682 = ((_e649.w - _e569) * _e571);
                    let _e691 = ((_e654.x - _e584) * _e587);
                    let _e692 = ((_e654.y - _e584) * _e587);
                    let _e693 = ((_e654.z - _e585) * _e587);
                    let _e694 = ((_e654.w - _e585) * _e587);
                    let _e695 = min(_e691, _e693);
                    let _e696 = min(_e692, _e694);
                    let _e697 = max(_e691, _e693);
                    let _e698 = max(_e692, _e694);
                    let _e723 = max(max(max(min(_e667, _e669), min(_e679, _e681)), _e695), _e595);
                    let _e724 = max(max(max(min(_e668, _e670), min(_e680, _e682)), _e696), _e595);
                    let _e727 = (_e723 <= min((min(min(max(_e667, _e669), max(_e679, _e681)), _e697) + (max(_e697, -(_e695)) * 0.0000019073523f)), _e612.member.member_1));
                    let _e728 = (_e724 <= min((min(min(max(_e668, _e670), max(_e680, _e682)), _e698) + (max(_e698, -(_e696)) * 0.0000019073523f)), _e612.member.member_1));
                    if (_e727 || _e728) {
                        let _e742 = (_e727 && ((_e723 <= _e724) || !(_e728)));
                        if (_e727 && _e728) {
                            let _e747 = (_e623 % 128u);
                            local_1[_e747] = select(_e655, _e656, _e742);
                            local[_e747] = select(_e723, _e724, _e742);
                            phi_1373_ = (_e623 + 1u);
                        } else {
                            phi_1373_ = _e623;
                        }
                        let _e752 = phi_1373_;
                        phi_1399_ = select(_e656, _e655, _e742);
                        phi_1400_ = _e752;
                    } else {
                        let _e731 = (_e623 - 1u);
                        let _e732 = (_e731 % 128u);
                        let _e734 = local[_e732];
                        if (_e734 <= _e612.member.member_1) {
                            let _e737 = local_1[_e732];
                            phi_1398_ = _e737;
                        } else {
                            phi_1398_ = 2147483648u;
                        }
                        let _e739 = phi_1398_;
                        phi_1399_ = _e739;
                        phi_1400_ = _e731;
                    }
                    let _e754 = phi_1399_;
                    let _e756 = phi_1400_;
                    let _e757 = (_e625 - 1u);
                    phi_1115_ = _e754;
                    phi_1118_ = select(_e756, 4294967295u, (_e757 == 0u));
                    phi_1120_ = _e757;
                } else {
                    phi_1115_ = u32();
                    phi_1118_ = u32();
                    phi_1120_ = u32();
                }
                let _e761 = phi_1115_;
                let _e763 = phi_1118_;
                let _e765 = phi_1120_;
                continue;
                continuing {
                    phi_1114_ = _e761;
                    phi_1117_ = _e763;
                    phi_1119_ = _e765;
                    break if !(_e629);
                }
            }
            let _e768 = local_2;
            if _e768 {
                let _e770 = local_3;
                let _e773 = local_4;
                phi_1416_ = _e612;
                phi_1419_ = SlimbvhTypeA(0u, ((_e773 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e779 = phi_1416_;
                    let _e781 = phi_1419_;
                    local_6 = _e779;
                    local_8 = _e779;
                    if (_e781.member < _e781.member_1) {
                        phi_1420_ = SlimbvhTypeA((_e781.member + 1u), _e781.member_1);
                        phi_1442_ = SlimbvhTypeA(1u, _e781.member);
                    } else {
                        phi_1420_ = _e781;
                        phi_1442_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                    }
                    let _e794 = phi_1420_;
                    let _e796 = phi_1442_;
                    let _e800 = (bitcast<i32>(_e796.member) != 0i);
                    if _e800 {
                        let _e801 = ((_e770 & 268435455u) + _e796.member_1);
                        let _e802 = (_e801 / 2u);
                        let _e803 = (_e801 % 2u);
                        let _e804 = (_e802 >= arrayLength((&slimbvh_triangles.member)));
                        if _e804 {
                            phi_1522_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e805 = (2u * _e803);
                            let _e809 = slimbvh_triangles.member[_e802][_e805];
                            let _e814 = slimbvh_triangles.member[_e802][(_e805 + 1u)];
                            let _e819 = slimbvh_triangles.member[_e802][(_e805 + 2u)];
                            if (_e803 == 0u) {
                                phi_1521_ = array<vec4<f32>, 3>(_e809, _e814, _e819);
                            } else {
                                phi_1521_ = array<vec4<f32>, 3>(vec4<f32>(_e809.z, _e809.w, _e814.x, _e814.y), vec4<f32>(_e814.z, _e814.w, _e819.x, _e819.y), vec4<f32>(_e819.z, _e819.w, 0f, 0f));
                            }
                            let _e837 = phi_1521_;
                            phi_1522_ = _e837;
                        }
                        let _e839 = phi_1522_;
                        let _e842 = bitcast<u32>(_e839[2].y);
                        if _e804 {
                            phi_1597_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e843 = (2u * _e803);
                            let _e847 = slimbvh_triangles.member[_e802][_e843];
                            let _e852 = slimbvh_triangles.member[_e802][(_e843 + 1u)];
                            let _e857 = slimbvh_triangles.member[_e802][(_e843 + 2u)];
                            if (_e803 == 0u) {
                                phi_1596_ = array<vec4<f32>, 3>(_e847, _e852, _e857);
                            } else {
                                phi_1596_ = array<vec4<f32>, 3>(vec4<f32>(_e847.z, _e847.w, _e852.x, _e852.y), vec4<f32>(_e852.z, _e852.w, _e857.x, _e857.y), vec4<f32>(_e857.z, _e857.w, 0f, 0f));
                            }
                            let _e875 = phi_1596_;
                            phi_1597_ = _e875;
                        }
                        let _e877 = phi_1597_;
                        if _e145 {
                            phi_1621_ = array<f32, 3>(_e877[0].x, _e877[0].y, _e877[0].z);
                        } else {
                            if (_e140 == 1u) {
                                phi_1620_ = array<f32, 3>(_e877[0].y, _e877[0].z, _e877[0].x);
                            } else {
                                phi_1620_ = array<f32, 3>(_e877[0].z, _e877[0].x, _e877[0].y);
                            }
                            let _e900 = phi_1620_;
                            phi_1621_ = _e900;
                        }
                        let _e903 = phi_1621_;
                        if _e145 {
                            phi_1636_ = array<f32, 3>(_e877[0].w, _e877[1].x, _e877[1].y);
                        } else {
                            if (_e140 == 1u) {
                                phi_1635_ = array<f32, 3>(_e877[1].x, _e877[1].y, _e877[0].w);
                            } else {
                                phi_1635_ = array<f32, 3>(_e877[1].y, _e877[0].w, _e877[1].x);
                            }
                            let _e908 = phi_1635_;
                            phi_1636_ = _e908;
                        }
                        let _e911 = phi_1636_;
                        if _e145 {
                            phi_1651_ = array<f32, 3>(_e877[1].z, _e877[1].w, _e877[2].x);
                        } else {
                            if (_e140 == 1u) {
                                phi_1650_ = array<f32, 3>(_e877[1].w, _e877[2].x, _e877[1].z);
                            } else {
                                phi_1650_ = array<f32, 3>(_e877[2].x, _e877[1].z, _e877[1].w);
                            }
                            let _e916 = phi_1650_;
                            phi_1651_ = _e916;
                        }
                        let _e919 = phi_1651_;
                        let _e933 = (_e903[2] - _e528.member[2]);
                        let _e936 = (((_e903[0] - _e528.member[0]) * _e583) - (_e933 * _e551));
                        let _e939 = (((_e903[1] - _e528.member[1]) * _e583) - (_e933 * _e567));
                        let _e942 = (_e911[2] - _e528.member[2]);
                        let _e945 = (((_e911[0] - _e528.member[0]) * _e583) - (_e942 * _e551));
                        let _e948 = (((_e911[1] - _e528.member[1]) * _e583) - (_e942 * _e567));
                        let _e951 = (_e919[2] - _e528.member[2]);
                        let _e954 = (((_e919[0] - _e528.member[0]) * _e583) - (_e951 * _e551));
                        let _e957 = (((_e919[1] - _e528.member[1]) * _e583) - (_e951 * _e567));
                        let _e958 = (_e954 * _e948);
                        let _e959 = (_e957 * _e945);
                        let _e960 = (_e936 * _e957);
                        let _e961 = (_e939 * _e954);
                        let _e962 = (_e945 * _e939);
                        let _e963 = (_e948 * _e936);
                        let _e968 = (((_e958 >= _e959) && (_e960 >= _e961)) && (_e962 >= _e963));
                        let _e974 = (_e968 || (((_e958 <= _e959) && (_e960 <= _e961)) && (_e962 <= _e963)));
                        if _e974 {
                            let _e976 = select(-1f, 1f, _e968);
                            let _e978 = ((_e958 - _e959) * _e976);
                            let _e980 = select(0f, _e978, (_e978 > 0f));
                            let _e982 = ((_e960 - _e961) * _e976);
                            let _e984 = select(0f, _e982, (_e982 > 0f));
                            let _e986 = ((_e962 - _e963) * _e976);
                            let _e988 = select(0f, _e986, (_e986 > 0f));
                            let _e990 = ((_e980 + _e984) + _e988);
                            let _e1005 = ((min(min(_e903[0], _e911[0]), _e919[0]) - _e552) * _e555);
                            let _e1006 = ((max(max(_e903[0], _e911[0]), _e919[0]) - _e553) * _e555);
                            let _e1009 = ((min(min(_e903[1], _e911[1]), _e919[1]) - _e568) * _e571);
                            let _e1010 = ((max(max(_e903[1], _e911[1]), _e919[1]) - _e569) * _e571);
                            let _e1013 = ((min(min(_e903[2], _e911[2]), _e919[2]) - _e584) * _e587);
                            let _e1014 = ((max(max(_e903[2], _e911[2]), _e919[2]) - _e585) * _e587);
                            let _e1015 = min(_e1013, _e1014);
                            let _e1016 = max(_e1013, _e1014);
                            let _e1020 = max(max(min(_e1005, _e1006), min(_e1009, _e1010)), _e1015);
                            let _e1024 = min(min(max(_e1005, _e1006), max(_e1009, _e1010)), _e1016);
                            let _e1029 = max(_e1020, _e595);
                            let _e1051 = (((((_e974 && (_e990 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e936, _e945), _e954) <= 0f) && (max(max(_e936, _e945), _e954) >= 0f))) && ((min(min(_e939, _e948), _e957) <= 0f) && (max(max(_e939, _e948), _e957) >= 0f))) && (_e1029 <= (_e1024 + (max(_e1016, -(_e1015)) * 0.0000019073523f)))) && (_e1029 <= _e779.member.member_1));
                            if _e1051 {
                                let _e1056 = (_e911[0] - _e903[0]);
                                let _e1057 = (_e911[1] - _e903[1]);
                                let _e1058 = (_e911[2] - _e903[2]);
                                let _e1059 = vec3<f32>(_e1056, _e1057, _e1058);
                                let _e1060 = (_e919[0] - _e911[0]);
                                let _e1061 = (_e919[1] - _e911[1]);
                                let _e1062 = (_e919[2] - _e911[2]);
                                let _e1063 = vec3<f32>(_e1060, _e1061, _e1062);
                                let _e1064 = (_e903[0] - _e919[0]);
                                let _e1065 = (_e903[1] - _e919[1]);
                                let _e1066 = (_e903[2] - _e919[2]);
                                let _e1067 = vec3<f32>(_e1064, _e1065, _e1066);
                                let _e1078 = max(max(bitcast<f32>((bitcast<u32>(_e1056) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1057) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1058) & 2147483647u)));
                                let _e1089 = max(max(bitcast<f32>((bitcast<u32>(_e1060) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1061) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1062) & 2147483647u)));
                                let _e1102 = max(max(_e1078, _e1089), max(max(bitcast<f32>((bitcast<u32>(_e1064) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1065) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1066) & 2147483647u))));
                                if (_e1078 == _e1102) {
                                    phi_1967_ = _e948;
                                    phi_1968_ = _e945;
                                    phi_1969_ = _e939;
                                    phi_1970_ = _e936;
                                    phi_1971_ = vec3<f32>(_e903[0], _e903[1], _e903[2]);
                                    phi_1972_ = _e1067;
                                    phi_1973_ = _e1063;
                                    phi_1974_ = _e1059;
                                } else {
                                    let _e1104 = (_e1089 == _e1102);
                                    let _e1109 = vec3(_e1104);
                                    phi_1967_ = select(_e939, _e957, _e1104);
                                    phi_1968_ = select(_e936, _e954, _e1104);
                                    phi_1969_ = select(_e957, _e948, _e1104);
                                    phi_1970_ = select(_e954, _e945, _e1104);
                                    phi_1971_ = select(vec3<f32>(_e919[0], _e919[1], _e919[2]), vec3<f32>(_e911[0], _e911[1], _e911[2]), _e1109);
                                    phi_1972_ = select(_e1063, _e1059, _e1109);
                                    phi_1973_ = select(_e1059, _e1067, _e1109);
                                    phi_1974_ = select(_e1067, _e1063, _e1109);
                                }
                                let _e1115 = phi_1967_;
                                let _e1117 = phi_1968_;
                                let _e1119 = phi_1969_;
                                let _e1121 = phi_1970_;
                                let _e1123 = phi_1971_;
                                let _e1125 = phi_1972_;
                                let _e1127 = phi_1973_;
                                let _e1129 = phi_1974_;
                                let _e1136 = ((_e1127.y * _e1125.z) - (_e1125.y * _e1127.z));
                                let _e1141 = ((_e1127.z * _e1125.x) - (_e1125.z * _e1127.x));
                                let _e1144 = ((_e1127.x * _e1125.y) - (_e1125.x * _e1127.y));
                                let _e1147 = ((_e980 >= _e984) && (_e980 >= _e988));
                                let _e1148 = (_e984 >= _e988);
                                let _e1162 = (((_e1136 * (select(select(_e919[0], _e911[0], _e1148), _e903[0], _e1147) - _e528.member[0])) + (_e1141 * (select(select(_e919[1], _e911[1], _e1148), _e903[1], _e1147) - _e528.member[1]))) + (_e1144 * (select(select(_e919[2], _e911[2], _e1148), _e903[2], _e1147) - _e528.member[2])));
                                let _e1167 = (((_e1136 * _e551) + (_e1141 * _e567)) + (_e1144 * _e583));
                                let _e1168 = (_e1117 - _e1121);
                                let _e1169 = (_e1115 - _e1119);
                                let _e1172 = ((_e1168 * _e1168) + (_e1169 * _e1169));
                                let _e1179 = (-(((_e1121 * _e1168) + (_e1119 * _e1169))) / select(0.000000000000000000000000000000000000011754944f, _e1172, (_e1172 > 0.000000000000000000000000000000000000011754944f)));
                                let _e1181 = select(1f, _e1179, (_e1179 < 1f));
                                let _e1183 = select(0f, _e1181, (_e1181 > 0f));
                                let _e1192 = ((_e1123.x + (_e1129.x * _e1183)) - _e528.member[0]);
                                let _e1195 = ((_e1123.y + (_e1129.y * _e1183)) - _e528.member[1]);
                                let _e1198 = ((_e1123.z + (_e1129.z * _e1183)) - _e528.member[2]);
                                let _e1263 = ((bitcast<f32>((bitcast<u32>(((((_e1136 * _e1192) + (_e1141 * _e1195)) + (_e1144 * _e1198)) - _e1162)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1192) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1195) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1198) & 2147483647u))), _e1102)) * max(max(bitcast<f32>((bitcast<u32>(_e1136) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1141) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1144) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1167) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1127.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1127.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1127.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1125.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1125.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1125.z) & 2147483647u)))))));
                                let _e1264 = (_e1162 / _e1167);
                                if (_e1051 && !(_e1263)) {
                                    let _e1267 = (_e1198 / _e583);
                                    let _e1275 = (((_e1136 * (_e1192 - (_e551 * _e1267))) + (_e1141 * (_e1195 - (_e567 * _e1267)))) / _e1167);
                                    phi_2153_ = select(select(_e1267, (_e1267 + _e1275), (bitcast<f32>((bitcast<u32>(_e1275) & 2147483647u)) <= _e1102)), _e1264, _e1263);
                                } else {
                                    phi_2153_ = _e1264;
                                }
                                let _e1284 = phi_2153_;
                                let _e1286 = select(_e1024, _e1284, (_e1284 < _e1024));
                                let _e1288 = select(_e1020, _e1286, (_e1286 > _e1020));
                                let _e1291 = select(_e1288, 0f, (bitcast<u32>(_e1288) == 2147483648u));
                                let _e1292 = (1f / _e990);
                                phi_2179_ = SlimbvhTypeK(_e1291, (_e984 * _e1292), (_e988 * _e1292), ((_e1051 && (_e1291 >= _e595)) && (_e1291 <= _e779.member.member_1)));
                                phi_2180_ = SlimbvhTypeK();
                            } else {
                                phi_2179_ = SlimbvhTypeK();
                                phi_2180_ = SlimbvhTypeK(0f, 0f, 0f, _e1051);
                            }
                            let _e1301 = phi_2179_;
                            let _e1303 = phi_2180_;
                            phi_2183_ = _e1301;
                            phi_2184_ = _e1303;
                            phi_2185_ = select(true, false, _e1051);
                        } else {
                            phi_2183_ = SlimbvhTypeK();
                            phi_2184_ = SlimbvhTypeK(0f, 0f, 0f, _e974);
                            phi_2185_ = true;
                        }
                        let _e1306 = phi_2183_;
                        let _e1308 = phi_2184_;
                        let _e1310 = phi_2185_;
                        if _e1310 {
                            phi_2189_ = _e1308;
                        } else {
                            phi_2189_ = _e1306;
                        }
                        let _e1312 = phi_2189_;
                        if _e1312.member_3 {
                            phi_2198_ = SlimbvhTypeC(_e1312.member, _e1312.member_1, _e1312.member_2, _e842);
                        } else {
                            phi_2198_ = _e72;
                        }
                        let _e1319 = phi_2198_;
                        if (_e1319.member_3 != 4294967295u) {
                            if (_e842 != 4294967295u) {
                                if (_e1319.member < _e779.member.member.member) {
                                    phi_2224_ = true;
                                } else {
                                    if (_e1319.member == _e779.member.member.member) {
                                        phi_2223_ = (_e1319.member_3 < _e779.member.member.member_3);
                                    } else {
                                        phi_2223_ = false;
                                    }
                                    let _e1334 = phi_2223_;
                                    phi_2224_ = _e1334;
                                }
                                let _e1336 = phi_2224_;
                                if _e1336 {
                                    phi_2231_ = SlimbvhTypeJ(SlimbvhTypeI(_e1319, _e1319.member), _e779.member_1);
                                } else {
                                    phi_2231_ = _e779;
                                }
                                let _e1342 = phi_2231_;
                                if _e1342.member_1 {
                                    phi_2237_ = SlimbvhTypeJ(SlimbvhTypeI(_e1342.member.member, bitcast<f32>(4286578687u)), _e1342.member_1);
                                } else {
                                    phi_2237_ = _e1342;
                                }
                                let _e1351 = phi_2237_;
                                phi_2238_ = _e1351;
                            } else {
                                phi_2238_ = _e779;
                            }
                            let _e1353 = phi_2238_;
                            phi_2239_ = _e1353;
                        } else {
                            phi_2239_ = _e779;
                        }
                        let _e1355 = phi_2239_;
                        phi_1417_ = _e1355;
                    } else {
                        phi_1417_ = SlimbvhTypeJ();
                    }
                    let _e1357 = phi_1417_;
                    continue;
                    continuing {
                        phi_1416_ = _e1357;
                        phi_1419_ = _e794;
                        break if !(_e800);
                    }
                }
                let _e1360 = local_5;
                let _e1361 = (_e1360 - 1u);
                let _e1362 = (_e1361 % 128u);
                let _e1364 = local[_e1362];
                let _e1366 = local_6;
                if (_e1364 <= _e1366.member.member_1) {
                    let _e1371 = local_1[_e1362];
                    phi_2264_ = _e1371;
                } else {
                    phi_2264_ = 2147483648u;
                }
                let _e1373 = phi_2264_;
                let _e1610 = local_8;
                phi_2271_ = _e1610;
                phi_2272_ = _e1373;
                phi_2273_ = select(_e1361, 4294967295u, (_e595 > _e1366.member.member_1));
            } else {
                phi_2271_ = _e612;
                let _e1613 = local_9;
                phi_2272_ = _e1613;
                let _e1616 = local_10;
                phi_2273_ = _e1616;
            }
            let _e1377 = phi_2271_;
            let _e1379 = phi_2272_;
            let _e1381 = phi_2273_;
            phi_1099_ = _e1377;
            phi_1102_ = _e1379;
            phi_1104_ = _e1381;
            let _e1622 = local_11;
            phi_1106_ = _e1622;
        } else {
            phi_1099_ = SlimbvhTypeJ();
            phi_1102_ = u32();
            phi_1104_ = u32();
            phi_1106_ = u32();
        }
        let _e1383 = phi_1099_;
        let _e1385 = phi_1102_;
        let _e1387 = phi_1104_;
        let _e1389 = phi_1106_;
        continue;
        continuing {
            phi_1098_ = _e1383;
            phi_1101_ = _e1385;
            phi_1103_ = _e1387;
            phi_1105_ = _e1389;
            break if !(_e619);
        }
    }
    let _e1392 = local_7;
    if (_e1392.member.member.member_3 != 4294967295u) {
        let _e1398 = -((_e98 + _e528.member_4));
        let _e1399 = bitcast<u32>(_e1392.member.member.member);
        let _e1403 = (bitcast<i32>((_e1399 >> bitcast<u32>(23i))) & 255i);
        let _e1404 = (_e1403 + _e1398);
        if (_e1403 == 255i) {
            phi_2328_ = _e1392.member.member.member;
        } else {
            if (_e1403 > 0i) {
                if (_e1404 > 0i) {
                    let _e1408 = (_e1404 < 255i);
                    if _e1408 {
                        phi_2307_ = bitcast<f32>((_e1399 + bitcast<u32>((_e1398 << bitcast<u32>(23i)))));
                    } else {
                        phi_2307_ = f32();
                    }
                    let _e1415 = phi_2307_;
                    phi_2309_ = _e1415;
                    phi_2310_ = select(true, false, _e1408);
                } else {
                    phi_2309_ = f32();
                    phi_2310_ = true;
                }
                let _e1418 = phi_2309_;
                let _e1420 = phi_2310_;
                phi_2311_ = _e1418;
                phi_2312_ = _e1420;
            } else {
                phi_2311_ = f32();
                phi_2312_ = true;
            }
            let _e1422 = phi_2311_;
            let _e1424 = phi_2312_;
            if _e1424 {
                let _e1425 = (_e1399 & 2147483648u);
                let _e1432 = ((_e1399 & 8388607u) | (select(0u, 1u, ((_e1399 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e1436 = (_e1432 == 0u);
                if _e1436 {
                    phi_2645_ = bitcast<f32>(_e1425);
                } else {
                    let _e1441 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1432)), 32u, _e1436) - 8u);
                    let _e1444 = (_e1432 << bitcast<u32>((_e1441 & 31u)));
                    let _e1446 = ((_e1404 + select(0i, 1i, (_e1403 == 0i))) - bitcast<i32>(_e1441));
                    if (_e1446 >= 255i) {
                        phi_2635_ = bitcast<f32>((_e1425 | 2139095040u));
                        phi_2636_ = f32();
                        phi_2637_ = true;
                    } else {
                        let _e1448 = (_e1446 > 0i);
                        if _e1448 {
                            phi_2629_ = bitcast<f32>(((_e1425 | (bitcast<u32>(_e1446) << bitcast<u32>(23i))) | (_e1444 & 8388607u)));
                            phi_2630_ = f32();
                        } else {
                            if (_e1446 < -24i) {
                                phi_2595_ = 26u;
                            } else {
                                phi_2595_ = bitcast<u32>((1i - _e1446));
                            }
                            let _e1453 = phi_2595_;
                            let _e1454 = (_e1453 & 31u);
                            let _e1456 = (_e1444 >> bitcast<u32>(_e1454));
                            let _e1460 = (_e1444 & ((1u << bitcast<u32>(_e1454)) - 1u));
                            let _e1464 = (1u << bitcast<u32>(((_e1453 - 1u) & 31u)));
                            if (_e1460 > _e1464) {
                                phi_2616_ = true;
                            } else {
                                if (_e1460 == _e1464) {
                                    phi_2613_ = ((_e1456 & 1u) == 1u);
                                } else {
                                    phi_2613_ = false;
                                }
                                let _e1470 = phi_2613_;
                                phi_2616_ = _e1470;
                            }
                            let _e1472 = phi_2616_;
                            phi_2629_ = f32();
                            phi_2630_ = bitcast<f32>((_e1425 | (_e1456 + select(0u, 1u, _e1472))));
                        }
                        let _e1485 = phi_2629_;
                        let _e1487 = phi_2630_;
                        phi_2635_ = _e1485;
                        phi_2636_ = _e1487;
                        phi_2637_ = _e1448;
                    }
                    let _e1491 = phi_2635_;
                    let _e1493 = phi_2636_;
                    let _e1495 = phi_2637_;
                    phi_2645_ = select(_e1493, _e1491, _e1495);
                }
                let _e1499 = phi_2645_;
                phi_2327_ = _e1499;
            } else {
                phi_2327_ = _e1422;
            }
            let _e1501 = phi_2327_;
            phi_2328_ = _e1501;
        }
        let _e1503 = phi_2328_;
        let _e1504 = bitcast<u32>(_e1503);
        if ((_e1504 & 2147483647u) >= 2139095040u) {
            phi_2340_ = bitcast<f32>(((_e1504 & 2147483648u) | 2139095039u));
        } else {
            phi_2340_ = _e1503;
        }
        let _e1511 = phi_2340_;
        phi_2345_ = SlimbvhTypeC(_e1511, _e1392.member.member.member_1, _e1392.member.member.member_2, _e1392.member.member.member_3);
    } else {
        phi_2345_ = _e72;
    }
    let _e1516 = phi_2345_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1516.member), bitcast<u32>(_e1516.member_1), bitcast<u32>(_e1516.member_2), _e1516.member_3);
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
