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
    member: array<f32, 9>,
    member_1: u32,
}

struct SlimbvhTypeD {
    member: array<SlimbvhTypeC>,
}

struct SlimbvhTypeE {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct SlimbvhTypeF {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct SlimbvhTypeG {
    member: array<SlimbvhTypeF>,
}

struct SlimbvhTypeH {
    member: vec4<f32>,
}

struct SlimbvhTypeI {
    member: u32,
}

struct SlimbvhTypeJ {
    member: SlimbvhTypeE,
    member_1: f32,
}

struct SlimbvhTypeK {
    member: SlimbvhTypeJ,
    member_1: bool,
}

struct SlimbvhTypeL {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

@group(0) @binding(0) 
var<uniform> slimbvh_exponent: SlimbvhTypeB;
@group(0) @binding(1) 
var<storage> slimbvh_nodes: SlimbvhTypeG;
@group(0) @binding(2) 
var<storage> slimbvh_triangles: SlimbvhTypeD;
var<private> slimbvh_origin: SlimbvhTypeH;
var<private> slimbvh_direction: SlimbvhTypeH;
var<private> slimbvh_any_will_do: SlimbvhTypeI;
var<private> slimbvh_hit: SlimbvhTypeB;

fn slimbvh_trace() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_249_: i32;
    var phi_250_: i32;
    var phi_260_: bool;
    var phi_270_: u32;
    var phi_271_: u32;
    var phi_273_: bool;
    var phi_278_: u32;
    var phi_290_: i32;
    var phi_310_: i32;
    var phi_422_: f32;
    var phi_433_: f32;
    var phi_536_: f32;
    var phi_547_: f32;
    var phi_650_: f32;
    var phi_661_: f32;
    var phi_714_: i32;
    var phi_736_: u32;
    var phi_737_: u32;
    var phi_772_: i32;
    var phi_794_: u32;
    var phi_795_: u32;
    var phi_803_: f32;
    var phi_804_: f32;
    var phi_814_: SlimbvhTypeK;
    var phi_2635_: bool;
    var phi_824_: SlimbvhTypeK;
    var phi_827_: u32;
    var phi_829_: u32;
    var phi_831_: bool;
    var phi_833_: u32;
    var phi_844_: bool;
    var phi_876_: u32;
    var phi_877_: bool;
    var phi_878_: u32;
    var phi_1971_: SlimbvhTypeL;
    var phi_2315_: u32;
    var phi_2343_: u32;
    var phi_2344_: u32;
    var phi_2345_: u32;
    var phi_2347_: u32;
    var phi_2348_: u32;
    var phi_2349_: bool;
    var phi_2358_: u32;
    var phi_2363_: u32;
    var phi_2364_: bool;
    var phi_893_: SlimbvhTypeK;
    var phi_896_: SlimbvhTypeA;
    var phi_897_: SlimbvhTypeA;
    var phi_919_: SlimbvhTypeA;
    var phi_940_: u32;
    var phi_1029_: array<array<f32, 3>, 3>;
    var phi_1146_: bool;
    var phi_1175_: bool;
    var phi_1576_: f32;
    var phi_1577_: f32;
    var phi_1578_: f32;
    var phi_1579_: f32;
    var phi_1580_: vec3<f32>;
    var phi_1581_: vec3<f32>;
    var phi_1582_: vec3<f32>;
    var phi_1583_: vec3<f32>;
    var phi_1614_: bool;
    var phi_1623_: vec3<f32>;
    var phi_1788_: f32;
    var phi_1790_: f32;
    var phi_1791_: bool;
    var phi_1811_: f32;
    var phi_1812_: f32;
    var phi_1835_: SlimbvhTypeE;
    var phi_1837_: SlimbvhTypeE;
    var phi_1838_: bool;
    var phi_1842_: SlimbvhTypeE;
    var phi_1843_: SlimbvhTypeE;
    var phi_1844_: SlimbvhTypeE;
    var phi_1845_: bool;
    var phi_1849_: SlimbvhTypeE;
    var phi_1850_: bool;
    var phi_1851_: SlimbvhTypeE;
    var phi_1852_: bool;
    var phi_1853_: bool;
    var phi_1854_: SlimbvhTypeE;
    var phi_1855_: bool;
    var phi_1856_: bool;
    var phi_1864_: SlimbvhTypeE;
    var phi_1865_: bool;
    var phi_1869_: SlimbvhTypeE;
    var phi_1894_: bool;
    var phi_1895_: bool;
    var phi_1902_: SlimbvhTypeK;
    var phi_1903_: SlimbvhTypeK;
    var phi_1904_: SlimbvhTypeK;
    var phi_894_: SlimbvhTypeK;
    var phi_2629_: bool;
    var local_2: SlimbvhTypeK;
    var local_3: SlimbvhTypeK;
    var phi_1911_: bool;
    var phi_2794_: bool;
    var phi_2366_: SlimbvhTypeK;
    var phi_2367_: u32;
    var phi_2368_: bool;
    var phi_2369_: u32;
    var phi_2793_: bool;
    var phi_2370_: SlimbvhTypeK;
    var phi_2371_: u32;
    var phi_2372_: u32;
    var phi_2373_: bool;
    var phi_2374_: u32;
    var phi_2792_: bool;
    var phi_2375_: SlimbvhTypeK;
    var phi_2376_: u32;
    var phi_2377_: u32;
    var phi_2378_: bool;
    var phi_2379_: u32;
    var phi_2791_: bool;
    var phi_825_: SlimbvhTypeK;
    var phi_828_: u32;
    var phi_830_: u32;
    var phi_832_: bool;
    var phi_834_: u32;
    var phi_2380_: bool;
    var phi_2790_: bool;
    var local_4: SlimbvhTypeK;
    var phi_2418_: f32;
    var phi_2420_: f32;
    var phi_2421_: bool;
    var phi_2422_: f32;
    var phi_2423_: bool;
    var phi_2574_: u32;
    var phi_2592_: bool;
    var phi_2595_: bool;
    var phi_2608_: f32;
    var phi_2609_: f32;
    var phi_2614_: f32;
    var phi_2615_: f32;
    var phi_2616_: bool;
    var phi_2624_: f32;
    var phi_2438_: f32;
    var phi_2439_: f32;
    var phi_2451_: f32;
    var phi_2456_: SlimbvhTypeE;
    var local_5: SlimbvhTypeK;

    switch bitcast<i32>(0u) {
        default: {
            let _e74 = arrayLength((&slimbvh_nodes.member));
            let _e76 = arrayLength((&slimbvh_triangles.member));
            let _e81 = slimbvh_origin.member;
            let _e87 = slimbvh_origin.member[3u];
            let _e88 = slimbvh_direction.member;
            let _e94 = slimbvh_direction.member[3u];
            let _e97 = slimbvh_exponent.member[0u];
            let _e98 = bitcast<i32>(_e97);
            let _e100 = (bitcast<u32>(_e88.x) & 2147483647u);
            let _e102 = (bitcast<u32>(_e88.y) & 2147483647u);
            let _e104 = (bitcast<u32>(_e88.z) & 2147483647u);
            let _e106 = (bitcast<u32>(_e81.x) & 2147483647u);
            let _e108 = (bitcast<u32>(_e81.y) & 2147483647u);
            let _e110 = (bitcast<u32>(_e81.z) & 2147483647u);
            let _e112 = select(_e102, _e100, (_e102 < _e100));
            let _e114 = select(_e104, _e112, (_e104 < _e112));
            let _e116 = select(_e106, _e114, (_e106 < _e114));
            let _e118 = select(_e108, _e116, (_e108 < _e116));
            let _e120 = select(_e110, _e118, (_e110 < _e118));
            let _e121 = bitcast<u32>(_e87);
            let _e122 = (_e121 & 2147483647u);
            let _e126 = bitcast<u32>(_e94);
            let _e127 = (_e126 & 2147483647u);
            let _e131 = (((select(_e122, _e120, (_e122 < _e120)) < 2139095040u) && (_e127 <= 2139095040u)) && (_e114 > 0u));
            if _e131 {
                let _e134 = (bitcast<u32>(bitcast<f32>(_e114)) & 2147483647u);
                if (_e134 >= 8388608u) {
                    phi_249_ = (bitcast<i32>((_e134 >> bitcast<u32>(23i))) - 127i);
                } else {
                    phi_249_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e134)), 32u, (_e134 == 0u))));
                }
                let _e148 = phi_249_;
                phi_250_ = _e148;
            } else {
                phi_250_ = 0i;
            }
            let _e150 = phi_250_;
            let _e151 = (_e100 == _e114);
            if _e151 {
                phi_260_ = true;
            } else {
                phi_260_ = (_e102 == _e114);
            }
            let _e154 = phi_260_;
            let _e155 = select(1u, 0u, _e151);
            if _e154 {
                let _e156 = (_e155 + 1u);
                phi_270_ = _e156;
                phi_271_ = _e156;
                phi_273_ = select(true, false, (_e156 == 2u));
            } else {
                phi_270_ = u32();
                phi_271_ = 0u;
                phi_273_ = true;
            }
            let _e160 = phi_270_;
            let _e162 = phi_271_;
            let _e164 = phi_273_;
            if _e164 {
                phi_278_ = (_e162 + 1u);
            } else {
                phi_278_ = 0u;
            }
            let _e168 = phi_278_;
            let _e169 = select(_e160, _e162, _e164);
            let _e170 = select(_e155, select(2u, _e155, _e154), _e164);
            if (_e98 < -126i) {
                phi_290_ = -126i;
            } else {
                phi_290_ = select(_e98, 127i, (_e98 > 127i));
            }
            let _e175 = phi_290_;
            let _e180 = bitcast<f32>((bitcast<u32>((_e175 + 127i)) << bitcast<u32>(23i)));
            let _e186 = bitcast<f32>((bitcast<u32>(((_e98 - _e175) + 127i)) << bitcast<u32>(23i)));
            let _e187 = -(_e150);
            if (_e187 < -126i) {
                phi_310_ = -126i;
            } else {
                phi_310_ = select(_e187, 127i, (_e187 > 127i));
            }
            let _e192 = phi_310_;
            let _e197 = bitcast<f32>((bitcast<u32>((_e192 + 127i)) << bitcast<u32>(23i)));
            let _e203 = bitcast<f32>((bitcast<u32>(((_e187 - _e192) + 127i)) << bitcast<u32>(23i)));
            let _e204 = (_e169 == 0u);
            let _e206 = (_e169 == 2u);
            let _e207 = select(select(_e81.y, _e81.x, _e204), _e81.z, _e206);
            let _e208 = bitcast<u32>(_e207);
            let _e210 = ((_e208 & 2139095040u) != 0u);
            let _e224 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e208 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e208 & 2147483648u))), _e207, _e210) * _e180) * select(0.00000011920929f, 1f, _e210)) * _e186);
            let _e226 = select(select(_e88.y, _e88.x, _e204), _e88.z, _e206);
            let _e227 = bitcast<u32>(_e226);
            let _e229 = ((_e227 & 2139095040u) != 0u);
            let _e243 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e227 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e227 & 2147483648u))), _e226, _e229) * _e197) * select(0.00000011920929f, 1f, _e229)) * _e203);
            let _e247 = (bitcast<f32>((bitcast<u32>(_e243) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e247 {
                let _e251 = (bitcast<f32>((bitcast<u32>(_e224) & 2147483647u)) * 0.00000011920929f);
                phi_422_ = select(0.00000000000011368684f, _e251, (_e251 > 0.00000000000011368684f));
            } else {
                phi_422_ = 0f;
            }
            let _e255 = phi_422_;
            let _e256 = (_e224 + _e255);
            let _e257 = (_e224 - _e255);
            let _e258 = select(_e243, 0f, _e247);
            if _e247 {
                phi_433_ = 38685626000000000000000000f;
            } else {
                phi_433_ = (1f / _e243);
            }
            let _e261 = phi_433_;
            let _e262 = (_e168 == 0u);
            let _e264 = (_e168 == 2u);
            let _e265 = select(select(_e81.y, _e81.x, _e262), _e81.z, _e264);
            let _e266 = bitcast<u32>(_e265);
            let _e268 = ((_e266 & 2139095040u) != 0u);
            let _e282 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e266 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e266 & 2147483648u))), _e265, _e268) * _e180) * select(0.00000011920929f, 1f, _e268)) * _e186);
            let _e284 = select(select(_e88.y, _e88.x, _e262), _e88.z, _e264);
            let _e285 = bitcast<u32>(_e284);
            let _e287 = ((_e285 & 2139095040u) != 0u);
            let _e301 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e285 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e285 & 2147483648u))), _e284, _e287) * _e197) * select(0.00000011920929f, 1f, _e287)) * _e203);
            let _e305 = (bitcast<f32>((bitcast<u32>(_e301) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e305 {
                let _e309 = (bitcast<f32>((bitcast<u32>(_e282) & 2147483647u)) * 0.00000011920929f);
                phi_536_ = select(0.00000000000011368684f, _e309, (_e309 > 0.00000000000011368684f));
            } else {
                phi_536_ = 0f;
            }
            let _e313 = phi_536_;
            let _e314 = (_e282 + _e313);
            let _e315 = (_e282 - _e313);
            let _e316 = select(_e301, 0f, _e305);
            if _e305 {
                phi_547_ = 38685626000000000000000000f;
            } else {
                phi_547_ = (1f / _e301);
            }
            let _e319 = phi_547_;
            let _e320 = (_e170 == 0u);
            let _e322 = (_e170 == 2u);
            let _e323 = select(select(_e81.y, _e81.x, _e320), _e81.z, _e322);
            let _e324 = bitcast<u32>(_e323);
            let _e326 = ((_e324 & 2139095040u) != 0u);
            let _e340 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e324 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e324 & 2147483648u))), _e323, _e326) * _e180) * select(0.00000011920929f, 1f, _e326)) * _e186);
            let _e342 = select(select(_e88.y, _e88.x, _e320), _e88.z, _e322);
            let _e343 = bitcast<u32>(_e342);
            let _e345 = ((_e343 & 2139095040u) != 0u);
            let _e359 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e343 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e343 & 2147483648u))), _e342, _e345) * _e197) * select(0.00000011920929f, 1f, _e345)) * _e203);
            let _e363 = (bitcast<f32>((bitcast<u32>(_e359) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e363 {
                let _e367 = (bitcast<f32>((bitcast<u32>(_e340) & 2147483647u)) * 0.00000011920929f);
                phi_650_ = select(0.00000000000011368684f, _e367, (_e367 > 0.00000000000011368684f));
            } else {
                phi_650_ = 0f;
            }
            let _e371 = phi_650_;
            let _e372 = (_e340 + _e371);
            let _e373 = (_e340 - _e371);
            let _e374 = select(_e359, 0f, _e363);
            if _e363 {
                phi_661_ = 38685626000000000000000000f;
            } else {
                phi_661_ = (1f / _e359);
            }
            let _e377 = phi_661_;
            let _e380 = bitcast<f32>((bitcast<u32>(_e224) & 2147483647u));
            let _e383 = bitcast<f32>((bitcast<u32>(_e282) & 2147483647u));
            let _e385 = select(_e383, _e380, (_e380 > _e383));
            let _e388 = bitcast<f32>((bitcast<u32>(_e340) & 2147483647u));
            let _e391 = (_e98 + _e150);
            if (_e131 && (select(_e388, _e385, (_e385 > _e388)) <= 1099511600000f)) {
                let _e401 = ((_e122 & 8388607u) | (select(0u, 1u, ((_e122 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e404 = bitcast<i32>((_e122 >> bitcast<u32>(23i)));
                let _e408 = (_e401 == 0u);
                let _e411 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e401)), 32u, _e408)) - 8i);
                if (_e404 == 255i) {
                    phi_714_ = 255i;
                } else {
                    phi_714_ = (((_e404 + select(0i, 1i, (_e404 == 0i))) - _e411) + _e391);
                }
                let _e419 = phi_714_;
                let _e429 = (_e419 <= 0i);
                if _e429 {
                    phi_737_ = u32();
                } else {
                    if _e408 {
                        phi_736_ = u32();
                    } else {
                        phi_736_ = select(((bitcast<u32>(_e419) << bitcast<u32>(23i)) | ((_e401 << bitcast<u32>(((_e411 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e419 >= 255i));
                    }
                    let _e433 = phi_736_;
                    phi_737_ = _e433;
                }
                let _e435 = phi_737_;
                let _e447 = ((_e127 & 8388607u) | (select(0u, 1u, ((_e127 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e450 = bitcast<i32>((_e127 >> bitcast<u32>(23i)));
                let _e454 = (_e447 == 0u);
                let _e457 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e447)), 32u, _e454)) - 8i);
                if (_e450 == 255i) {
                    phi_772_ = 255i;
                } else {
                    phi_772_ = (((_e450 + select(0i, 1i, (_e450 == 0i))) - _e457) + _e391);
                }
                let _e465 = phi_772_;
                let _e475 = (_e465 <= 0i);
                if _e475 {
                    phi_795_ = u32();
                } else {
                    if _e454 {
                        phi_794_ = u32();
                    } else {
                        phi_794_ = select(((bitcast<u32>(_e465) << bitcast<u32>(23i)) | ((_e447 << bitcast<u32>(((_e457 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e465 >= 255i));
                    }
                    let _e479 = phi_794_;
                    phi_795_ = _e479;
                }
                let _e481 = phi_795_;
                phi_803_ = bitcast<f32>(((_e126 & 2147483648u) | select(_e481, 0u, select(_e454, true, _e475))));
                phi_804_ = bitcast<f32>(((_e121 & 2147483648u) | select(_e435, 0u, select(_e408, true, _e429))));
            } else {
                phi_803_ = 0f;
                phi_804_ = 1f;
            }
            let _e487 = phi_803_;
            let _e489 = phi_804_;
            let _e490 = slimbvh_any_will_do.member;
            if (_e490 == 1u) {
                phi_814_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e487), true);
            } else {
                phi_814_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e487), false);
            }
            let _e497 = phi_814_;
            local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
            local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
            phi_2635_ = false;
            phi_824_ = _e497;
            phi_827_ = select(0u, 2147483648u, (_e74 == 0u));
            phi_829_ = ((3u * _e74) + 1u);
            phi_831_ = (_e489 <= _e487);
            phi_833_ = 0u;
            loop {
                let _e504 = phi_2635_;
                let _e506 = phi_824_;
                let _e508 = phi_827_;
                let _e510 = phi_829_;
                let _e512 = phi_831_;
                let _e514 = phi_833_;
                local_4 = _e506;
                if _e512 {
                    phi_844_ = true;
                } else {
                    phi_844_ = (_e514 > 0u);
                }
                let _e517 = phi_844_;
                if _e517 {
                    let _e518 = (_e510 > 0u);
                    if _e518 {
                        if _e512 {
                            phi_876_ = _e508;
                            phi_877_ = _e512;
                            phi_878_ = _e514;
                        } else {
                            let _e519 = (_e514 - 1u);
                            let _e520 = (_e519 % 128u);
                            let _e521 = (_e520 < 128u);
                            if _e521 {
                            } else {
                                phi_2790_ = true;
                                break;
                            }
                            let _e523 = local_1[_e520];
                            if _e521 {
                            } else {
                                phi_2790_ = true;
                                break;
                            }
                            let _e525 = local[_e520];
                            phi_876_ = _e523;
                            phi_877_ = (_e525 <= _e506.member.member_1);
                            phi_878_ = _e519;
                        }
                        let _e530 = phi_876_;
                        let _e532 = phi_877_;
                        let _e534 = phi_878_;
                        if _e532 {
                            if ((_e530 & 2147483648u) != 0u) {
                                phi_893_ = _e506;
                                phi_896_ = SlimbvhTypeA(0u, ((_e530 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e733 = phi_893_;
                                    let _e735 = phi_896_;
                                    local_2 = _e733;
                                    local_3 = _e733;
                                    local_5 = _e733;
                                    if (_e735.member < _e735.member_1) {
                                        phi_897_ = SlimbvhTypeA((_e735.member + 1u), _e735.member_1);
                                        phi_919_ = SlimbvhTypeA(1u, _e735.member);
                                    } else {
                                        phi_897_ = _e735;
                                        phi_919_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                                    }
                                    let _e748 = phi_897_;
                                    let _e750 = phi_919_;
                                    let _e754 = (bitcast<i32>(_e750.member) != 0i);
                                    if _e754 {
                                        let _e755 = ((_e530 & 268435455u) + _e750.member_1);
                                        let _e756 = (_e755 < _e76);
                                        if _e756 {
                                            if _e756 {
                                            } else {
                                                phi_2629_ = true;
                                                break;
                                            }
                                            let _e760 = slimbvh_triangles.member[_e755].member_1;
                                            phi_940_ = _e760;
                                        } else {
                                            phi_940_ = 4294967295u;
                                        }
                                        let _e762 = phi_940_;
                                        if (_e755 >= _e76) {
                                            phi_1029_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                        } else {
                                            if _e756 {
                                            } else {
                                                phi_2629_ = true;
                                                break;
                                            }
                                            let _e764 = (_e169 % 3u);
                                            let _e765 = (_e168 % 3u);
                                            let _e766 = (_e170 % 3u);
                                            if (_e764 < 9u) {
                                            } else {
                                                phi_2629_ = true;
                                                break;
                                            }
                                            let _e772 = slimbvh_triangles.member[_e755].member[_e764];
                                            if (_e765 < 9u) {
                                            } else {
                                                phi_2629_ = true;
                                                break;
                                            }
                                            let _e778 = slimbvh_triangles.member[_e755].member[_e765];
                                            if (_e766 < 9u) {
                                            } else {
                                                phi_2629_ = true;
                                                break;
                                            }
                                            let _e784 = slimbvh_triangles.member[_e755].member[_e766];
                                            let _e786 = (3u + _e764);
                                            if (_e786 < 9u) {
                                            } else {
                                                phi_2629_ = true;
                                                break;
                                            }
                                            let _e792 = slimbvh_triangles.member[_e755].member[_e786];
                                            let _e793 = (3u + _e765);
                                            if (_e793 < 9u) {
                                            } else {
                                                phi_2629_ = true;
                                                break;
                                            }
                                            let _e799 = slimbvh_triangles.member[_e755].member[_e793];
                                            let _e800 = (3u + _e766);
                                            if (_e800 < 9u) {
                                            } else {
                                                phi_2629_ = true;
                                                break;
                                            }
                                            let _e806 = slimbvh_triangles.member[_e755].member[_e800];
                                            let _e808 = (6u + _e764);
                                            if (_e808 < 9u) {
                                            } else {
                                                phi_2629_ = true;
                                                break;
                                            }
                                            let _e814 = slimbvh_triangles.member[_e755].member[_e808];
                                            let _e815 = (6u + _e765);
                                            if (_e815 < 9u) {
                                            } else {
                                                phi_2629_ = true;
                                                break;
                                            }
                                            let _e821 = slimbvh_triangles.member[_e755].member[_e815];
                                            let _e822 = (6u + _e766);
                                            if (_e822 < 9u) {
                                            } else {
                                                phi_2629_ = true;
                                                break;
                                            }
                                            let _e828 = slimbvh_triangles.member[_e755].member[_e822];
                                            phi_1029_ = array<array<f32, 3>, 3>(array<f32, 3>(_e772, _e778, _e784), array<f32, 3>(_e792, _e799, _e806), array<f32, 3>(_e814, _e821, _e828));
                                        }
                                        let _e832 = phi_1029_;
                                        let _e841 = (_e832[0][2] - _e340);
                                        let _e844 = (((_e832[0][0] - _e224) * _e374) - (_e841 * _e258));
                                        let _e847 = (((_e832[0][1] - _e282) * _e374) - (_e841 * _e316));
                                        let _e854 = (_e832[1][2] - _e340);
                                        let _e857 = (((_e832[1][0] - _e224) * _e374) - (_e854 * _e258));
                                        let _e860 = (((_e832[1][1] - _e282) * _e374) - (_e854 * _e316));
                                        let _e867 = (_e832[2][2] - _e340);
                                        let _e870 = (((_e832[2][0] - _e224) * _e374) - (_e867 * _e258));
                                        let _e873 = (((_e832[2][1] - _e282) * _e374) - (_e867 * _e316));
                                        let _e874 = (_e870 * _e860);
                                        let _e875 = (_e873 * _e857);
                                        let _e876 = (_e844 * _e873);
                                        let _e877 = (_e847 * _e870);
                                        let _e878 = (_e857 * _e847);
                                        let _e879 = (_e860 * _e844);
                                        let _e884 = (((_e874 >= _e875) && (_e876 >= _e877)) && (_e878 >= _e879));
                                        if (_e884 || (((_e874 <= _e875) && (_e876 <= _e877)) && (_e878 <= _e879))) {
                                            let _e891 = select(-1f, 1f, _e884);
                                            let _e893 = ((_e874 - _e875) * _e891);
                                            let _e895 = select(0f, _e893, (_e893 > 0f));
                                            let _e897 = ((_e876 - _e877) * _e891);
                                            let _e899 = select(0f, _e897, (_e897 > 0f));
                                            let _e901 = ((_e878 - _e879) * _e891);
                                            let _e903 = select(0f, _e901, (_e901 > 0f));
                                            let _e905 = ((_e895 + _e899) + _e903);
                                            if (_e905 < 0.000000000000000000000000000000000000011754944f) {
                                                phi_1854_ = SlimbvhTypeE();
                                                phi_1855_ = true;
                                                phi_1856_ = false;
                                            } else {
                                                let _e908 = select(_e857, _e844, (_e844 < _e857));
                                                if (select(_e870, _e908, (_e908 < _e870)) > 0f) {
                                                    phi_1146_ = true;
                                                } else {
                                                    let _e913 = select(_e857, _e844, (_e844 > _e857));
                                                    phi_1146_ = (select(_e870, _e913, (_e913 > _e870)) < 0f);
                                                }
                                                let _e918 = phi_1146_;
                                                if _e918 {
                                                    phi_1851_ = SlimbvhTypeE();
                                                    phi_1852_ = true;
                                                    phi_1853_ = false;
                                                } else {
                                                    let _e920 = select(_e860, _e847, (_e847 < _e860));
                                                    if (select(_e873, _e920, (_e920 < _e873)) > 0f) {
                                                        phi_1175_ = true;
                                                    } else {
                                                        let _e925 = select(_e860, _e847, (_e847 > _e860));
                                                        phi_1175_ = (select(_e873, _e925, (_e925 > _e873)) < 0f);
                                                    }
                                                    let _e930 = phi_1175_;
                                                    if _e930 {
                                                        phi_1849_ = SlimbvhTypeE();
                                                        phi_1850_ = false;
                                                    } else {
                                                        let _e932 = select(_e832[1][0], _e832[0][0], (_e832[0][0] < _e832[1][0]));
                                                        let _e936 = select(_e832[1][0], _e832[0][0], (_e832[0][0] > _e832[1][0]));
                                                        let _e940 = select(_e832[1][1], _e832[0][1], (_e832[0][1] < _e832[1][1]));
                                                        let _e944 = select(_e832[1][1], _e832[0][1], (_e832[0][1] > _e832[1][1]));
                                                        let _e948 = select(_e832[1][2], _e832[0][2], (_e832[0][2] < _e832[1][2]));
                                                        let _e952 = select(_e832[1][2], _e832[0][2], (_e832[0][2] > _e832[1][2]));
                                                        let _e957 = ((select(_e832[2][0], _e932, (_e932 < _e832[2][0])) - _e256) * _e261);
                                                        let _e958 = ((select(_e832[2][0], _e936, (_e936 > _e832[2][0])) - _e257) * _e261);
                                                        let _e961 = ((select(_e832[2][1], _e940, (_e940 < _e832[2][1])) - _e314) * _e319);
                                                        let _e962 = ((select(_e832[2][1], _e944, (_e944 > _e832[2][1])) - _e315) * _e319);
                                                        let _e965 = ((select(_e832[2][2], _e948, (_e948 < _e832[2][2])) - _e372) * _e377);
                                                        let _e966 = ((select(_e832[2][2], _e952, (_e952 > _e832[2][2])) - _e373) * _e377);
                                                        let _e968 = select(_e966, _e965, (_e965 < _e966));
                                                        let _e970 = select(_e966, _e965, (_e965 > _e966));
                                                        let _e972 = select(_e958, _e957, (_e957 < _e958));
                                                        let _e974 = select(_e962, _e961, (_e961 < _e962));
                                                        let _e976 = select(_e974, _e972, (_e972 > _e974));
                                                        let _e978 = select(_e968, _e976, (_e976 > _e968));
                                                        let _e980 = select(_e958, _e957, (_e957 > _e958));
                                                        let _e982 = select(_e962, _e961, (_e961 > _e962));
                                                        let _e984 = select(_e982, _e980, (_e980 < _e982));
                                                        let _e986 = select(_e970, _e984, (_e984 < _e970));
                                                        let _e987 = -(_e968);
                                                        let _e993 = select(_e489, _e978, (_e978 > _e489));
                                                        if (_e993 > (_e986 + (select(_e987, _e970, (_e970 > _e987)) * 0.0000019073523f))) {
                                                            phi_1844_ = SlimbvhTypeE();
                                                            phi_1845_ = true;
                                                        } else {
                                                            let _e995 = (_e993 > _e733.member.member_1);
                                                            if _e995 {
                                                                phi_1843_ = SlimbvhTypeE();
                                                            } else {
                                                                let _e996 = vec3<f32>(_e832[0][0], _e832[0][1], _e832[0][2]);
                                                                let _e997 = vec3<f32>(_e832[1][0], _e832[1][1], _e832[1][2]);
                                                                let _e998 = vec3<f32>(_e832[2][0], _e832[2][1], _e832[2][2]);
                                                                let _e999 = (_e832[1][0] - _e832[0][0]);
                                                                let _e1000 = (_e832[1][1] - _e832[0][1]);
                                                                let _e1001 = (_e832[1][2] - _e832[0][2]);
                                                                let _e1002 = vec3<f32>(_e999, _e1000, _e1001);
                                                                let _e1003 = (_e832[2][0] - _e832[1][0]);
                                                                let _e1004 = (_e832[2][1] - _e832[1][1]);
                                                                let _e1005 = (_e832[2][2] - _e832[1][2]);
                                                                let _e1006 = vec3<f32>(_e1003, _e1004, _e1005);
                                                                let _e1007 = (_e832[0][0] - _e832[2][0]);
                                                                let _e1008 = (_e832[0][1] - _e832[2][1]);
                                                                let _e1009 = (_e832[0][2] - _e832[2][2]);
                                                                let _e1010 = vec3<f32>(_e1007, _e1008, _e1009);
                                                                let _e1013 = bitcast<f32>((bitcast<u32>(_e999) & 2147483647u));
                                                                let _e1016 = bitcast<f32>((bitcast<u32>(_e1000) & 2147483647u));
                                                                let _e1018 = select(_e1016, _e1013, (_e1013 > _e1016));
                                                                let _e1021 = bitcast<f32>((bitcast<u32>(_e1001) & 2147483647u));
                                                                let _e1023 = select(_e1021, _e1018, (_e1018 > _e1021));
                                                                let _e1026 = bitcast<f32>((bitcast<u32>(_e1003) & 2147483647u));
                                                                let _e1029 = bitcast<f32>((bitcast<u32>(_e1004) & 2147483647u));
                                                                let _e1031 = select(_e1029, _e1026, (_e1026 > _e1029));
                                                                let _e1034 = bitcast<f32>((bitcast<u32>(_e1005) & 2147483647u));
                                                                let _e1036 = select(_e1034, _e1031, (_e1031 > _e1034));
                                                                let _e1039 = bitcast<f32>((bitcast<u32>(_e1007) & 2147483647u));
                                                                let _e1042 = bitcast<f32>((bitcast<u32>(_e1008) & 2147483647u));
                                                                let _e1044 = select(_e1042, _e1039, (_e1039 > _e1042));
                                                                let _e1047 = bitcast<f32>((bitcast<u32>(_e1009) & 2147483647u));
                                                                let _e1049 = select(_e1047, _e1044, (_e1044 > _e1047));
                                                                let _e1051 = select(_e1036, _e1023, (_e1023 > _e1036));
                                                                let _e1053 = select(_e1049, _e1051, (_e1051 > _e1049));
                                                                if (_e1023 == _e1053) {
                                                                    phi_1576_ = _e860;
                                                                    phi_1577_ = _e857;
                                                                    phi_1578_ = _e847;
                                                                    phi_1579_ = _e844;
                                                                    phi_1580_ = _e996;
                                                                    phi_1581_ = _e1010;
                                                                    phi_1582_ = _e1006;
                                                                    phi_1583_ = _e1002;
                                                                } else {
                                                                    let _e1055 = (_e1036 == _e1053);
                                                                    let _e1060 = vec3(_e1055);
                                                                    phi_1576_ = select(_e847, _e873, _e1055);
                                                                    phi_1577_ = select(_e844, _e870, _e1055);
                                                                    phi_1578_ = select(_e873, _e860, _e1055);
                                                                    phi_1579_ = select(_e870, _e857, _e1055);
                                                                    phi_1580_ = select(_e998, _e997, _e1060);
                                                                    phi_1581_ = select(_e1006, _e1002, _e1060);
                                                                    phi_1582_ = select(_e1002, _e1010, _e1060);
                                                                    phi_1583_ = select(_e1010, _e1006, _e1060);
                                                                }
                                                                let _e1066 = phi_1576_;
                                                                let _e1068 = phi_1577_;
                                                                let _e1070 = phi_1578_;
                                                                let _e1072 = phi_1579_;
                                                                let _e1074 = phi_1580_;
                                                                let _e1076 = phi_1581_;
                                                                let _e1078 = phi_1582_;
                                                                let _e1080 = phi_1583_;
                                                                let _e1087 = ((_e1078.y * _e1076.z) - (_e1076.y * _e1078.z));
                                                                let _e1092 = ((_e1078.z * _e1076.x) - (_e1076.z * _e1078.x));
                                                                let _e1095 = ((_e1078.x * _e1076.y) - (_e1076.x * _e1078.y));
                                                                if (_e895 >= _e899) {
                                                                    phi_1614_ = select(true, false, (_e895 >= _e903));
                                                                } else {
                                                                    phi_1614_ = true;
                                                                }
                                                                let _e1100 = phi_1614_;
                                                                if _e1100 {
                                                                    phi_1623_ = select(_e998, _e997, vec3((_e899 >= _e903)));
                                                                } else {
                                                                    phi_1623_ = _e996;
                                                                }
                                                                let _e1105 = phi_1623_;
                                                                let _e1116 = (((_e1087 * (_e1105.x - _e224)) + (_e1092 * (_e1105.y - _e282))) + (_e1095 * (_e1105.z - _e340)));
                                                                let _e1121 = (((_e1087 * _e258) + (_e1092 * _e316)) + (_e1095 * _e374));
                                                                let _e1122 = (_e1068 - _e1072);
                                                                let _e1123 = (_e1066 - _e1070);
                                                                let _e1131 = (-(((_e1072 * _e1122) + (_e1070 * _e1123))) / ((_e1122 * _e1122) + (_e1123 * _e1123)));
                                                                let _e1133 = select(1f, _e1131, (_e1131 < 1f));
                                                                let _e1135 = select(0f, _e1133, (_e1133 > 0f));
                                                                let _e1148 = ((_e1074.x + (_e1080.x * _e1135)) - _e224);
                                                                let _e1149 = ((_e1074.y + (_e1080.y * _e1135)) - _e282);
                                                                let _e1150 = ((_e1074.z + (_e1080.z * _e1135)) - _e340);
                                                                let _e1151 = (_e1150 / _e374);
                                                                let _e1163 = bitcast<f32>((bitcast<u32>(_e1148) & 2147483647u));
                                                                let _e1166 = bitcast<f32>((bitcast<u32>(_e1149) & 2147483647u));
                                                                let _e1168 = select(_e1166, _e1163, (_e1163 > _e1166));
                                                                let _e1171 = bitcast<f32>((bitcast<u32>(_e1150) & 2147483647u));
                                                                let _e1173 = select(_e1171, _e1168, (_e1168 > _e1171));
                                                                let _e1179 = bitcast<f32>((bitcast<u32>(_e1087) & 2147483647u));
                                                                let _e1182 = bitcast<f32>((bitcast<u32>(_e1092) & 2147483647u));
                                                                let _e1184 = select(_e1182, _e1179, (_e1179 > _e1182));
                                                                let _e1187 = bitcast<f32>((bitcast<u32>(_e1095) & 2147483647u));
                                                                if (bitcast<f32>((bitcast<u32>(((((_e1087 * _e1148) + (_e1092 * _e1149)) + (_e1095 * _e1150)) - _e1116)) & 2147483647u)) <= ((0.0000009536743f * select(_e1053, _e1173, (_e1173 > _e1053))) * select(_e1187, _e1184, (_e1184 > _e1187)))) {
                                                                    let _e1197 = bitcast<f32>((bitcast<u32>(_e1078.x) & 2147483647u));
                                                                    let _e1200 = bitcast<f32>((bitcast<u32>(_e1078.y) & 2147483647u));
                                                                    let _e1202 = select(_e1200, _e1197, (_e1197 > _e1200));
                                                                    let _e1205 = bitcast<f32>((bitcast<u32>(_e1078.z) & 2147483647u));
                                                                    let _e1211 = bitcast<f32>((bitcast<u32>(_e1076.x) & 2147483647u));
                                                                    let _e1214 = bitcast<f32>((bitcast<u32>(_e1076.y) & 2147483647u));
                                                                    let _e1216 = select(_e1214, _e1211, (_e1211 > _e1214));
                                                                    let _e1219 = bitcast<f32>((bitcast<u32>(_e1076.z) & 2147483647u));
                                                                    let _e1223 = (bitcast<f32>((bitcast<u32>(_e1121) & 2147483647u)) > ((0.0000038146973f * select(_e1205, _e1202, (_e1202 > _e1205))) * select(_e1219, _e1216, (_e1216 > _e1219))));
                                                                    if _e1223 {
                                                                        phi_1788_ = (_e1116 / _e1121);
                                                                    } else {
                                                                        phi_1788_ = f32();
                                                                    }
                                                                    let _e1226 = phi_1788_;
                                                                    phi_1790_ = _e1226;
                                                                    phi_1791_ = select(true, false, _e1223);
                                                                } else {
                                                                    phi_1790_ = f32();
                                                                    phi_1791_ = true;
                                                                }
                                                                let _e1229 = phi_1790_;
                                                                let _e1231 = phi_1791_;
                                                                if _e1231 {
                                                                    let _e1239 = (((_e1087 * (_e1148 - (_e258 * _e1151))) + (_e1092 * (_e1149 - (_e316 * _e1151)))) / _e1121);
                                                                    if (bitcast<f32>((bitcast<u32>(_e1239) & 2147483647u)) <= _e1053) {
                                                                        phi_1811_ = (_e1151 + _e1239);
                                                                    } else {
                                                                        phi_1811_ = _e1151;
                                                                    }
                                                                    let _e1246 = phi_1811_;
                                                                    phi_1812_ = _e1246;
                                                                } else {
                                                                    phi_1812_ = _e1229;
                                                                }
                                                                let _e1248 = phi_1812_;
                                                                let _e1250 = select(_e986, _e1248, (_e1248 < _e986));
                                                                let _e1252 = select(_e978, _e1250, (_e1250 > _e978));
                                                                if (_e1252 >= _e489) {
                                                                    let _e1254 = (_e1252 <= _e733.member.member_1);
                                                                    if _e1254 {
                                                                        let _e1255 = (1f / _e905);
                                                                        phi_1835_ = SlimbvhTypeE(_e1252, (_e899 * _e1255), (_e903 * _e1255), _e762);
                                                                    } else {
                                                                        phi_1835_ = SlimbvhTypeE();
                                                                    }
                                                                    let _e1260 = phi_1835_;
                                                                    phi_1837_ = _e1260;
                                                                    phi_1838_ = select(true, false, _e1254);
                                                                } else {
                                                                    phi_1837_ = SlimbvhTypeE();
                                                                    phi_1838_ = true;
                                                                }
                                                                let _e1263 = phi_1837_;
                                                                let _e1265 = phi_1838_;
                                                                if _e1265 {
                                                                    phi_1842_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1842_ = _e1263;
                                                                }
                                                                let _e1267 = phi_1842_;
                                                                phi_1843_ = _e1267;
                                                            }
                                                            let _e1269 = phi_1843_;
                                                            phi_1844_ = _e1269;
                                                            phi_1845_ = _e995;
                                                        }
                                                        let _e1271 = phi_1844_;
                                                        let _e1273 = phi_1845_;
                                                        phi_1849_ = _e1271;
                                                        phi_1850_ = _e1273;
                                                    }
                                                    let _e1275 = phi_1849_;
                                                    let _e1277 = phi_1850_;
                                                    phi_1851_ = _e1275;
                                                    phi_1852_ = _e930;
                                                    phi_1853_ = _e1277;
                                                }
                                                let _e1279 = phi_1851_;
                                                let _e1281 = phi_1852_;
                                                let _e1283 = phi_1853_;
                                                phi_1854_ = _e1279;
                                                phi_1855_ = _e1281;
                                                phi_1856_ = _e1283;
                                            }
                                            let _e1285 = phi_1854_;
                                            let _e1287 = phi_1855_;
                                            let _e1289 = phi_1856_;
                                            phi_1864_ = _e1285;
                                            phi_1865_ = select(_e1289, true, _e1287);
                                        } else {
                                            phi_1864_ = SlimbvhTypeE();
                                            phi_1865_ = true;
                                        }
                                        let _e1292 = phi_1864_;
                                        let _e1294 = phi_1865_;
                                        if _e1294 {
                                            phi_1869_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                        } else {
                                            phi_1869_ = _e1292;
                                        }
                                        let _e1296 = phi_1869_;
                                        if (_e1296.member_3 != 4294967295u) {
                                            if (_e762 != 4294967295u) {
                                                if (_e1296.member < _e733.member.member.member) {
                                                    phi_1895_ = true;
                                                } else {
                                                    if (_e1296.member == _e733.member.member.member) {
                                                        phi_1894_ = (_e1296.member_3 < _e733.member.member.member_3);
                                                    } else {
                                                        phi_1894_ = false;
                                                    }
                                                    let _e1311 = phi_1894_;
                                                    phi_1895_ = _e1311;
                                                }
                                                let _e1313 = phi_1895_;
                                                if _e1313 {
                                                    phi_1902_ = SlimbvhTypeK(SlimbvhTypeJ(_e1296, _e1296.member), _e733.member_1);
                                                } else {
                                                    phi_1902_ = _e733;
                                                }
                                                let _e1319 = phi_1902_;
                                                phi_1903_ = _e1319;
                                            } else {
                                                phi_1903_ = _e733;
                                            }
                                            let _e1321 = phi_1903_;
                                            phi_1904_ = _e1321;
                                        } else {
                                            phi_1904_ = _e733;
                                        }
                                        let _e1323 = phi_1904_;
                                        phi_894_ = _e1323;
                                    } else {
                                        phi_894_ = SlimbvhTypeK();
                                    }
                                    let _e1325 = phi_894_;
                                    continue;
                                    continuing {
                                        phi_893_ = _e1325;
                                        phi_896_ = _e748;
                                        phi_2629_ = _e504;
                                        break if !(_e754);
                                    }
                                }
                                let _e1328 = phi_2629_;
                                phi_2790_ = _e1328;
                                if _e1328 {
                                    break;
                                }
                                let _e1330 = local_2;
                                if _e1330.member_1 {
                                    let _e1333 = local_3;
                                    phi_1911_ = (_e1333.member.member.member_3 != 4294967295u);
                                } else {
                                    phi_1911_ = false;
                                }
                                let _e1339 = phi_1911_;
                                phi_2794_ = _e1328;
                                let _e1625 = local_5;
                                phi_2366_ = _e1625;
                                phi_2367_ = _e530;
                                phi_2368_ = false;
                                phi_2369_ = select(_e534, 0u, _e1339);
                            } else {
                                if (_e530 >= _e74) {
                                    phi_1971_ = SlimbvhTypeL(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                } else {
                                    if (_e530 < _e74) {
                                    } else {
                                        phi_2790_ = true;
                                        break;
                                    }
                                    let _e544 = (_e169 % 3u);
                                    if (_e544 < 3u) {
                                    } else {
                                        phi_2790_ = true;
                                        break;
                                    }
                                    let _e550 = slimbvh_nodes.member[_e530].member[_e544];
                                    let _e556 = (_e168 % 3u);
                                    if (_e556 < 3u) {
                                    } else {
                                        phi_2790_ = true;
                                        break;
                                    }
                                    let _e562 = slimbvh_nodes.member[_e530].member[_e556];
                                    let _e568 = (_e170 % 3u);
                                    if (_e568 < 3u) {
                                    } else {
                                        phi_2790_ = true;
                                        break;
                                    }
                                    let _e574 = slimbvh_nodes.member[_e530].member[_e568];
                                    let _e584 = slimbvh_nodes.member[_e530].member_1;
                                    let _e588 = slimbvh_nodes.member[_e530].member_2;
                                    phi_1971_ = SlimbvhTypeL(array<vec4<f32>, 3>(vec4<f32>(_e550[0], _e550[1], _e550[2], _e550[3]), vec4<f32>(_e562[0], _e562[1], _e562[2], _e562[3]), vec4<f32>(_e574[0], _e574[1], _e574[2], _e574[3])), _e584, _e588);
                                }
                                let _e591 = phi_1971_;
                                let _e604 = ((_e591.member[0].x - _e256) * _e261);
                                let _e605 = ((_e591.member[0].y - _e256) * _e261);
                                let _e606 = ((_e591.member[0].z - _e257) * _e261);
                                let _e607 = ((_e591.member[0].w - _e257) * _e261);
                                let _e617 = ((_e591.member[1].x - _e314) * _e319);
                                let _e618 = ((_e591.member[1].y - _e314) * _e319);
                                let _e619 = ((_e591.member[1].z - _e315) * _e319);
                                let _e620 = ((_e591.member[1].w - _e315) * _e319);
                                let _e630 = ((_e591.member[2].x - _e372) * _e377);
                                let _e631 = ((_e591.member[2].y - _e372) * _e377);
                                let _e632 = ((_e591.member[2].z - _e373) * _e377);
                                let _e633 = ((_e591.member[2].w - _e373) * _e377);
                                let _e635 = select(_e632, _e630, (_e630 < _e632));
                                let _e637 = select(_e633, _e631, (_e631 < _e633));
                                let _e639 = select(_e632, _e630, (_e630 > _e632));
                                let _e641 = select(_e633, _e631, (_e631 > _e633));
                                let _e643 = select(_e606, _e604, (_e604 < _e606));
                                let _e645 = select(_e607, _e605, (_e605 < _e607));
                                let _e647 = select(_e619, _e617, (_e617 < _e619));
                                let _e649 = select(_e620, _e618, (_e618 < _e620));
                                let _e651 = select(_e647, _e643, (_e643 > _e647));
                                let _e653 = select(_e649, _e645, (_e645 > _e649));
                                let _e655 = select(_e635, _e651, (_e651 > _e635));
                                let _e657 = select(_e637, _e653, (_e653 > _e637));
                                let _e659 = select(_e606, _e604, (_e604 > _e606));
                                let _e661 = select(_e607, _e605, (_e605 > _e607));
                                let _e663 = select(_e619, _e617, (_e617 > _e619));
                                let _e665 = select(_e620, _e618, (_e618 > _e620));
                                let _e667 = select(_e663, _e659, (_e659 < _e663));
                                let _e669 = select(_e665, _e661, (_e661 < _e665));
                                let _e674 = -(_e635);
                                let _e675 = -(_e637);
                                let _e682 = (select(_e639, _e667, (_e667 < _e639)) + (select(_e674, _e639, (_e639 > _e674)) * 0.0000019073523f));
                                let _e683 = (select(_e641, _e669, (_e669 < _e641)) + (select(_e675, _e641, (_e641 > _e675)) * 0.0000019073523f));
                                let _e685 = select(_e489, _e655, (_e655 > _e489));
                                let _e687 = select(_e489, _e657, (_e657 > _e489));
                                let _e692 = (_e685 <= select(_e506.member.member_1, _e682, (_e682 < _e506.member.member_1)));
                                let _e693 = (_e687 <= select(_e506.member.member_1, _e683, (_e683 < _e506.member.member_1)));
                                let _e694 = (_e685 <= _e687);
                                if _e692 {
                                    if _e693 {
                                        if _e694 {
                                            phi_2315_ = _e591.member_2;
                                        } else {
                                            phi_2315_ = _e591.member_1;
                                        }
                                        let _e698 = phi_2315_;
                                        let _e701 = (_e534 % 128u);
                                        let _e702 = (_e701 < 128u);
                                        if _e702 {
                                        } else {
                                            phi_2790_ = true;
                                            break;
                                        }
                                        local_1[_e701] = _e698;
                                        if _e702 {
                                        } else {
                                            phi_2790_ = true;
                                            break;
                                        }
                                        local[_e701] = select(_e687, _e685, (_e685 > _e687));
                                        if _e694 {
                                            phi_2343_ = _e591.member_1;
                                        } else {
                                            phi_2343_ = _e591.member_2;
                                        }
                                        let _e709 = phi_2343_;
                                        phi_2344_ = _e709;
                                        phi_2345_ = (_e534 + 1u);
                                    } else {
                                        phi_2344_ = u32();
                                        phi_2345_ = u32();
                                    }
                                    let _e711 = phi_2344_;
                                    let _e713 = phi_2345_;
                                    phi_2347_ = _e711;
                                    phi_2348_ = _e713;
                                    phi_2349_ = select(true, false, _e693);
                                } else {
                                    phi_2347_ = u32();
                                    phi_2348_ = u32();
                                    phi_2349_ = true;
                                }
                                let _e716 = phi_2347_;
                                let _e718 = phi_2348_;
                                let _e720 = phi_2349_;
                                if _e720 {
                                    if _e692 {
                                        phi_2358_ = _e591.member_1;
                                    } else {
                                        phi_2358_ = _e591.member_2;
                                    }
                                    let _e724 = phi_2358_;
                                    phi_2363_ = _e724;
                                    phi_2364_ = select(_e693, true, _e692);
                                } else {
                                    phi_2363_ = _e716;
                                    phi_2364_ = _e532;
                                }
                                let _e727 = phi_2363_;
                                let _e729 = phi_2364_;
                                phi_2794_ = _e504;
                                phi_2366_ = _e506;
                                phi_2367_ = _e727;
                                phi_2368_ = _e729;
                                phi_2369_ = select(_e718, _e534, _e720);
                            }
                            let _e1342 = phi_2794_;
                            let _e1344 = phi_2366_;
                            let _e1346 = phi_2367_;
                            let _e1348 = phi_2368_;
                            let _e1350 = phi_2369_;
                            phi_2793_ = _e1342;
                            phi_2370_ = _e1344;
                            phi_2371_ = _e1346;
                            phi_2372_ = (_e510 - 1u);
                            phi_2373_ = _e1348;
                            phi_2374_ = _e1350;
                        } else {
                            phi_2793_ = _e504;
                            phi_2370_ = _e506;
                            phi_2371_ = _e530;
                            phi_2372_ = _e510;
                            phi_2373_ = _e532;
                            phi_2374_ = _e534;
                        }
                        let _e1352 = phi_2793_;
                        let _e1354 = phi_2370_;
                        let _e1356 = phi_2371_;
                        let _e1358 = phi_2372_;
                        let _e1360 = phi_2373_;
                        let _e1362 = phi_2374_;
                        phi_2792_ = _e1352;
                        phi_2375_ = _e1354;
                        phi_2376_ = _e1356;
                        phi_2377_ = _e1358;
                        phi_2378_ = _e1360;
                        phi_2379_ = _e1362;
                    } else {
                        phi_2792_ = _e504;
                        phi_2375_ = SlimbvhTypeK();
                        phi_2376_ = u32();
                        phi_2377_ = u32();
                        phi_2378_ = bool();
                        phi_2379_ = u32();
                    }
                    let _e1364 = phi_2792_;
                    let _e1366 = phi_2375_;
                    let _e1368 = phi_2376_;
                    let _e1370 = phi_2377_;
                    let _e1372 = phi_2378_;
                    let _e1374 = phi_2379_;
                    phi_2791_ = _e1364;
                    phi_825_ = _e1366;
                    phi_828_ = _e1368;
                    phi_830_ = _e1370;
                    phi_832_ = _e1372;
                    phi_834_ = _e1374;
                    phi_2380_ = _e518;
                } else {
                    phi_2791_ = _e504;
                    phi_825_ = SlimbvhTypeK();
                    phi_828_ = u32();
                    phi_830_ = u32();
                    phi_832_ = bool();
                    phi_834_ = u32();
                    phi_2380_ = false;
                }
                let _e1376 = phi_2791_;
                let _e1378 = phi_825_;
                let _e1380 = phi_828_;
                let _e1382 = phi_830_;
                let _e1384 = phi_832_;
                let _e1386 = phi_834_;
                let _e1388 = phi_2380_;
                continue;
                continuing {
                    phi_2635_ = _e1376;
                    phi_824_ = _e1378;
                    phi_827_ = _e1380;
                    phi_829_ = _e1382;
                    phi_831_ = _e1384;
                    phi_833_ = _e1386;
                    phi_2790_ = _e1376;
                    break if !(_e1388);
                }
            }
            let _e1391 = phi_2790_;
            if _e1391 {
                break;
            }
            let _e1393 = local_4;
            if (_e1393.member.member.member_3 != 4294967295u) {
                let _e1399 = -(_e391);
                let _e1400 = bitcast<u32>(_e1393.member.member.member);
                let _e1404 = (bitcast<i32>((_e1400 >> bitcast<u32>(23i))) & 255i);
                let _e1405 = (_e1404 + _e1399);
                if (_e1404 == 255i) {
                    phi_2439_ = _e1393.member.member.member;
                } else {
                    if (_e1404 > 0i) {
                        if (_e1405 > 0i) {
                            let _e1409 = (_e1405 < 255i);
                            if _e1409 {
                                phi_2418_ = bitcast<f32>((_e1400 + bitcast<u32>((_e1399 << bitcast<u32>(23i)))));
                            } else {
                                phi_2418_ = f32();
                            }
                            let _e1416 = phi_2418_;
                            phi_2420_ = _e1416;
                            phi_2421_ = select(true, false, _e1409);
                        } else {
                            phi_2420_ = f32();
                            phi_2421_ = true;
                        }
                        let _e1419 = phi_2420_;
                        let _e1421 = phi_2421_;
                        phi_2422_ = _e1419;
                        phi_2423_ = _e1421;
                    } else {
                        phi_2422_ = f32();
                        phi_2423_ = true;
                    }
                    let _e1423 = phi_2422_;
                    let _e1425 = phi_2423_;
                    if _e1425 {
                        let _e1426 = (_e1400 & 2147483648u);
                        let _e1433 = ((_e1400 & 8388607u) | (select(0u, 1u, ((_e1400 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e1437 = (_e1433 == 0u);
                        if _e1437 {
                            phi_2624_ = bitcast<f32>(_e1426);
                        } else {
                            let _e1442 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1433)), 32u, _e1437) - 8u);
                            let _e1445 = (_e1433 << bitcast<u32>((_e1442 & 31u)));
                            let _e1447 = ((_e1405 + select(0i, 1i, (_e1404 == 0i))) - bitcast<i32>(_e1442));
                            if (_e1447 >= 255i) {
                                phi_2614_ = bitcast<f32>((_e1426 | 2139095040u));
                                phi_2615_ = f32();
                                phi_2616_ = true;
                            } else {
                                let _e1449 = (_e1447 > 0i);
                                if _e1449 {
                                    phi_2608_ = bitcast<f32>(((_e1426 | (bitcast<u32>(_e1447) << bitcast<u32>(23i))) | (_e1445 & 8388607u)));
                                    phi_2609_ = f32();
                                } else {
                                    if (_e1447 < -24i) {
                                        phi_2574_ = 26u;
                                    } else {
                                        phi_2574_ = bitcast<u32>((1i - _e1447));
                                    }
                                    let _e1454 = phi_2574_;
                                    let _e1455 = (_e1454 & 31u);
                                    let _e1457 = (_e1445 >> bitcast<u32>(_e1455));
                                    let _e1461 = (_e1445 & ((1u << bitcast<u32>(_e1455)) - 1u));
                                    let _e1465 = (1u << bitcast<u32>(((_e1454 - 1u) & 31u)));
                                    if (_e1461 > _e1465) {
                                        phi_2595_ = true;
                                    } else {
                                        if (_e1461 == _e1465) {
                                            phi_2592_ = ((_e1457 & 1u) == 1u);
                                        } else {
                                            phi_2592_ = false;
                                        }
                                        let _e1471 = phi_2592_;
                                        phi_2595_ = _e1471;
                                    }
                                    let _e1473 = phi_2595_;
                                    phi_2608_ = f32();
                                    phi_2609_ = bitcast<f32>((_e1426 | (_e1457 + select(0u, 1u, _e1473))));
                                }
                                let _e1486 = phi_2608_;
                                let _e1488 = phi_2609_;
                                phi_2614_ = _e1486;
                                phi_2615_ = _e1488;
                                phi_2616_ = _e1449;
                            }
                            let _e1492 = phi_2614_;
                            let _e1494 = phi_2615_;
                            let _e1496 = phi_2616_;
                            phi_2624_ = select(_e1494, _e1492, _e1496);
                        }
                        let _e1500 = phi_2624_;
                        phi_2438_ = _e1500;
                    } else {
                        phi_2438_ = _e1423;
                    }
                    let _e1502 = phi_2438_;
                    phi_2439_ = _e1502;
                }
                let _e1504 = phi_2439_;
                let _e1505 = bitcast<u32>(_e1504);
                if ((_e1505 & 2147483647u) >= 2139095040u) {
                    phi_2451_ = bitcast<f32>(((_e1505 & 2147483648u) | 2139095039u));
                } else {
                    phi_2451_ = _e1504;
                }
                let _e1512 = phi_2451_;
                phi_2456_ = SlimbvhTypeE(_e1512, _e1393.member.member.member_1, _e1393.member.member.member_2, _e1393.member.member.member_3);
            } else {
                phi_2456_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
            }
            let _e1517 = phi_2456_;
            slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1517.member), bitcast<u32>(_e1517.member_1), bitcast<u32>(_e1517.member_2), _e1517.member_3);
            break;
        }
    }
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
