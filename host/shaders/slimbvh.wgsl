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
    var phi_256_: i32;
    var phi_257_: i32;
    var phi_267_: bool;
    var phi_277_: u32;
    var phi_278_: u32;
    var phi_280_: bool;
    var phi_285_: u32;
    var phi_298_: i32;
    var phi_318_: i32;
    var phi_430_: f32;
    var phi_442_: f32;
    var phi_545_: f32;
    var phi_557_: f32;
    var phi_660_: f32;
    var phi_672_: f32;
    var phi_725_: i32;
    var phi_747_: u32;
    var phi_748_: u32;
    var phi_783_: i32;
    var phi_805_: u32;
    var phi_806_: u32;
    var phi_814_: f32;
    var phi_815_: f32;
    var phi_829_: SlimbvhTypeK;
    var phi_2747_: bool;
    var phi_839_: SlimbvhTypeK;
    var phi_842_: u32;
    var phi_844_: bool;
    var phi_846_: u32;
    var phi_848_: u32;
    var phi_859_: bool;
    var phi_891_: bool;
    var phi_892_: u32;
    var phi_893_: u32;
    var phi_908_: SlimbvhTypeK;
    var phi_911_: SlimbvhTypeA;
    var phi_912_: SlimbvhTypeA;
    var phi_934_: SlimbvhTypeA;
    var phi_955_: u32;
    var phi_1047_: array<array<f32, 3>, 3>;
    var phi_1199_: bool;
    var phi_1228_: bool;
    var phi_1647_: f32;
    var phi_1648_: f32;
    var phi_1649_: f32;
    var phi_1650_: f32;
    var phi_1651_: vec3<f32>;
    var phi_1652_: vec3<f32>;
    var phi_1653_: vec3<f32>;
    var phi_1654_: vec3<f32>;
    var phi_1691_: bool;
    var phi_1700_: vec3<f32>;
    var phi_1865_: f32;
    var phi_1867_: f32;
    var phi_1868_: bool;
    var phi_1888_: f32;
    var phi_1889_: f32;
    var phi_1912_: SlimbvhTypeE;
    var phi_1914_: SlimbvhTypeE;
    var phi_1915_: bool;
    var phi_1919_: SlimbvhTypeE;
    var phi_1920_: SlimbvhTypeE;
    var phi_1921_: SlimbvhTypeE;
    var phi_1922_: bool;
    var phi_1926_: SlimbvhTypeE;
    var phi_1927_: bool;
    var phi_1928_: SlimbvhTypeE;
    var phi_1929_: bool;
    var phi_1930_: bool;
    var phi_1931_: SlimbvhTypeE;
    var phi_1932_: bool;
    var phi_1933_: bool;
    var phi_1941_: SlimbvhTypeE;
    var phi_1942_: bool;
    var phi_1946_: SlimbvhTypeE;
    var phi_1971_: bool;
    var phi_1972_: bool;
    var phi_1979_: SlimbvhTypeK;
    var phi_1980_: SlimbvhTypeK;
    var phi_1981_: SlimbvhTypeK;
    var phi_909_: SlimbvhTypeK;
    var phi_2741_: bool;
    var phi_2937_: bool;
    var phi_1982_: SlimbvhTypeK;
    var phi_2047_: SlimbvhTypeL;
    var phi_2409_: u32;
    var phi_2436_: u32;
    var phi_2437_: u32;
    var phi_2438_: u32;
    var phi_2440_: u32;
    var phi_2441_: u32;
    var phi_2442_: bool;
    var phi_2451_: u32;
    var phi_2456_: bool;
    var phi_2458_: u32;
    var phi_2462_: bool;
    var phi_2463_: u32;
    var phi_2464_: u32;
    var phi_2474_: bool;
    var phi_2480_: u32;
    var phi_2905_: bool;
    var phi_2482_: SlimbvhTypeK;
    var phi_2483_: u32;
    var phi_2484_: bool;
    var phi_2485_: u32;
    var phi_2486_: u32;
    var phi_2904_: bool;
    var phi_2487_: SlimbvhTypeK;
    var phi_2488_: u32;
    var phi_2489_: bool;
    var phi_2490_: u32;
    var phi_2491_: u32;
    var phi_2903_: bool;
    var phi_840_: SlimbvhTypeK;
    var phi_843_: u32;
    var phi_845_: bool;
    var phi_847_: u32;
    var phi_849_: u32;
    var phi_2492_: bool;
    var phi_2902_: bool;
    var local_2: SlimbvhTypeK;
    var phi_2530_: f32;
    var phi_2532_: f32;
    var phi_2533_: bool;
    var phi_2534_: f32;
    var phi_2535_: bool;
    var phi_2686_: u32;
    var phi_2704_: bool;
    var phi_2707_: bool;
    var phi_2720_: f32;
    var phi_2721_: f32;
    var phi_2726_: f32;
    var phi_2727_: f32;
    var phi_2728_: bool;
    var phi_2736_: f32;
    var phi_2550_: f32;
    var phi_2551_: f32;
    var phi_2563_: f32;
    var phi_2568_: SlimbvhTypeE;
    var local_3: SlimbvhTypeK;

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
                    phi_256_ = (bitcast<i32>((_e134 >> bitcast<u32>(23i))) - 127i);
                } else {
                    phi_256_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e134)), 32u, (_e134 == 0u))));
                }
                let _e148 = phi_256_;
                phi_257_ = _e148;
            } else {
                phi_257_ = 0i;
            }
            let _e150 = phi_257_;
            let _e151 = (_e100 == _e114);
            if _e151 {
                phi_267_ = true;
            } else {
                phi_267_ = (_e102 == _e114);
            }
            let _e154 = phi_267_;
            let _e155 = select(1u, 0u, _e151);
            if _e154 {
                let _e156 = (_e155 + 1u);
                phi_277_ = _e156;
                phi_278_ = _e156;
                phi_280_ = select(true, false, (_e156 == 2u));
            } else {
                phi_277_ = u32();
                phi_278_ = 0u;
                phi_280_ = true;
            }
            let _e160 = phi_277_;
            let _e162 = phi_278_;
            let _e164 = phi_280_;
            if _e164 {
                phi_285_ = (_e162 + 1u);
            } else {
                phi_285_ = 0u;
            }
            let _e168 = phi_285_;
            let _e169 = select(_e160, _e162, _e164);
            let _e170 = select(_e155, select(2u, _e155, _e154), _e164);
            if (_e98 < -126i) {
                phi_298_ = -126i;
            } else {
                phi_298_ = select(_e98, 127i, (_e98 > 127i));
            }
            let _e175 = phi_298_;
            let _e180 = bitcast<f32>((bitcast<u32>((_e175 + 127i)) << bitcast<u32>(23i)));
            let _e186 = bitcast<f32>((bitcast<u32>(((_e98 - _e175) + 127i)) << bitcast<u32>(23i)));
            let _e187 = -(_e150);
            if (_e187 < -126i) {
                phi_318_ = -126i;
            } else {
                phi_318_ = select(_e187, 127i, (_e187 > 127i));
            }
            let _e192 = phi_318_;
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
                phi_430_ = select(0.00000000000011368684f, _e251, (_e251 > 0.00000000000011368684f));
            } else {
                phi_430_ = 0f;
            }
            let _e255 = phi_430_;
            let _e256 = (_e224 + _e255);
            let _e257 = (_e224 - _e255);
            let _e258 = select(_e243, 0f, _e247);
            if _e247 {
                phi_442_ = 38685626000000000000000000f;
            } else {
                phi_442_ = (1f / _e243);
            }
            let _e261 = phi_442_;
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
                phi_545_ = select(0.00000000000011368684f, _e309, (_e309 > 0.00000000000011368684f));
            } else {
                phi_545_ = 0f;
            }
            let _e313 = phi_545_;
            let _e314 = (_e282 + _e313);
            let _e315 = (_e282 - _e313);
            let _e316 = select(_e301, 0f, _e305);
            if _e305 {
                phi_557_ = 38685626000000000000000000f;
            } else {
                phi_557_ = (1f / _e301);
            }
            let _e319 = phi_557_;
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
                phi_660_ = select(0.00000000000011368684f, _e367, (_e367 > 0.00000000000011368684f));
            } else {
                phi_660_ = 0f;
            }
            let _e371 = phi_660_;
            let _e372 = (_e340 + _e371);
            let _e373 = (_e340 - _e371);
            let _e374 = select(_e359, 0f, _e363);
            if _e363 {
                phi_672_ = 38685626000000000000000000f;
            } else {
                phi_672_ = (1f / _e359);
            }
            let _e377 = phi_672_;
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
                    phi_725_ = 255i;
                } else {
                    phi_725_ = (((_e404 + select(0i, 1i, (_e404 == 0i))) - _e411) + _e391);
                }
                let _e419 = phi_725_;
                let _e429 = (_e419 <= 0i);
                if _e429 {
                    phi_748_ = u32();
                } else {
                    if _e408 {
                        phi_747_ = u32();
                    } else {
                        phi_747_ = select(((bitcast<u32>(_e419) << bitcast<u32>(23i)) | ((_e401 << bitcast<u32>(((_e411 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e419 >= 255i));
                    }
                    let _e433 = phi_747_;
                    phi_748_ = _e433;
                }
                let _e435 = phi_748_;
                let _e447 = ((_e127 & 8388607u) | (select(0u, 1u, ((_e127 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e450 = bitcast<i32>((_e127 >> bitcast<u32>(23i)));
                let _e454 = (_e447 == 0u);
                let _e457 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e447)), 32u, _e454)) - 8i);
                if (_e450 == 255i) {
                    phi_783_ = 255i;
                } else {
                    phi_783_ = (((_e450 + select(0i, 1i, (_e450 == 0i))) - _e457) + _e391);
                }
                let _e465 = phi_783_;
                let _e475 = (_e465 <= 0i);
                if _e475 {
                    phi_806_ = u32();
                } else {
                    if _e454 {
                        phi_805_ = u32();
                    } else {
                        phi_805_ = select(((bitcast<u32>(_e465) << bitcast<u32>(23i)) | ((_e447 << bitcast<u32>(((_e457 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e465 >= 255i));
                    }
                    let _e479 = phi_805_;
                    phi_806_ = _e479;
                }
                let _e481 = phi_806_;
                phi_814_ = bitcast<f32>(((_e126 & 2147483648u) | select(_e481, 0u, select(_e454, true, _e475))));
                phi_815_ = bitcast<f32>(((_e121 & 2147483648u) | select(_e435, 0u, select(_e408, true, _e429))));
            } else {
                phi_814_ = 0f;
                phi_815_ = 1f;
            }
            let _e487 = phi_814_;
            let _e489 = phi_815_;
            let _e490 = slimbvh_any_will_do.member;
            if (_e490 == 1u) {
                phi_829_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e487), true);
            } else {
                phi_829_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e487), false);
            }
            let _e497 = phi_829_;
            local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
            local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
            phi_2747_ = false;
            phi_839_ = _e497;
            phi_842_ = ((3u * _e74) + 1u);
            phi_844_ = (_e489 <= _e487);
            phi_846_ = 0u;
            phi_848_ = select(0u, 2147483648u, (_e74 == 0u));
            loop {
                let _e504 = phi_2747_;
                let _e506 = phi_839_;
                let _e508 = phi_842_;
                let _e510 = phi_844_;
                let _e512 = phi_846_;
                let _e514 = phi_848_;
                local_2 = _e506;
                if _e510 {
                    phi_859_ = true;
                } else {
                    phi_859_ = (_e512 > 0u);
                }
                let _e517 = phi_859_;
                if _e517 {
                    let _e518 = (_e508 > 0u);
                    if _e518 {
                        if _e510 {
                            phi_891_ = _e510;
                            phi_892_ = _e512;
                            phi_893_ = _e514;
                        } else {
                            let _e519 = (_e512 - 1u);
                            let _e520 = (_e519 % 128u);
                            let _e521 = (_e520 < 128u);
                            if _e521 {
                            } else {
                                phi_2902_ = true;
                                break;
                            }
                            let _e523 = local_1[_e520];
                            if _e521 {
                            } else {
                                phi_2902_ = true;
                                break;
                            }
                            let _e525 = local[_e520];
                            phi_891_ = (_e525 <= _e506.member.member_1);
                            phi_892_ = _e519;
                            phi_893_ = _e523;
                        }
                        let _e530 = phi_891_;
                        let _e532 = phi_892_;
                        let _e534 = phi_893_;
                        if _e530 {
                            let _e537 = ((_e534 & 2147483648u) != 0u);
                            if _e537 {
                                phi_908_ = _e506;
                                phi_911_ = SlimbvhTypeA(0u, ((_e534 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e544 = phi_908_;
                                    let _e546 = phi_911_;
                                    local_3 = _e544;
                                    if (_e546.member < _e546.member_1) {
                                        phi_912_ = SlimbvhTypeA((_e546.member + 1u), _e546.member_1);
                                        phi_934_ = SlimbvhTypeA(1u, _e546.member);
                                    } else {
                                        phi_912_ = _e546;
                                        phi_934_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                                    }
                                    let _e559 = phi_912_;
                                    let _e561 = phi_934_;
                                    let _e565 = (bitcast<i32>(_e561.member) != 0i);
                                    if _e565 {
                                        let _e566 = ((_e534 & 268435455u) + _e561.member_1);
                                        let _e567 = (_e566 < _e76);
                                        if _e567 {
                                            if _e567 {
                                            } else {
                                                phi_2741_ = true;
                                                break;
                                            }
                                            let _e571 = slimbvh_triangles.member[_e566].member_1;
                                            phi_955_ = _e571;
                                        } else {
                                            phi_955_ = 4294967295u;
                                        }
                                        let _e573 = phi_955_;
                                        if (_e566 >= _e76) {
                                            phi_1047_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                        } else {
                                            if _e567 {
                                            } else {
                                                phi_2741_ = true;
                                                break;
                                            }
                                            let _e575 = (_e169 % 3u);
                                            let _e576 = (_e168 % 3u);
                                            let _e577 = (_e170 % 3u);
                                            if (_e575 < 9u) {
                                            } else {
                                                phi_2741_ = true;
                                                break;
                                            }
                                            let _e583 = slimbvh_triangles.member[_e566].member[_e575];
                                            if (_e576 < 9u) {
                                            } else {
                                                phi_2741_ = true;
                                                break;
                                            }
                                            let _e589 = slimbvh_triangles.member[_e566].member[_e576];
                                            if (_e577 < 9u) {
                                            } else {
                                                phi_2741_ = true;
                                                break;
                                            }
                                            let _e595 = slimbvh_triangles.member[_e566].member[_e577];
                                            let _e597 = (3u + _e575);
                                            if (_e597 < 9u) {
                                            } else {
                                                phi_2741_ = true;
                                                break;
                                            }
                                            let _e603 = slimbvh_triangles.member[_e566].member[_e597];
                                            let _e604 = (3u + _e576);
                                            if (_e604 < 9u) {
                                            } else {
                                                phi_2741_ = true;
                                                break;
                                            }
                                            let _e610 = slimbvh_triangles.member[_e566].member[_e604];
                                            let _e611 = (3u + _e577);
                                            if (_e611 < 9u) {
                                            } else {
                                                phi_2741_ = true;
                                                break;
                                            }
                                            let _e617 = slimbvh_triangles.member[_e566].member[_e611];
                                            let _e619 = (6u + _e575);
                                            if (_e619 < 9u) {
                                            } else {
                                                phi_2741_ = true;
                                                break;
                                            }
                                            let _e625 = slimbvh_triangles.member[_e566].member[_e619];
                                            let _e626 = (6u + _e576);
                                            if (_e626 < 9u) {
                                            } else {
                                                phi_2741_ = true;
                                                break;
                                            }
                                            let _e632 = slimbvh_triangles.member[_e566].member[_e626];
                                            let _e633 = (6u + _e577);
                                            if (_e633 < 9u) {
                                            } else {
                                                phi_2741_ = true;
                                                break;
                                            }
                                            let _e639 = slimbvh_triangles.member[_e566].member[_e633];
                                            phi_1047_ = array<array<f32, 3>, 3>(array<f32, 3>(_e583, _e589, _e595), array<f32, 3>(_e603, _e610, _e617), array<f32, 3>(_e625, _e632, _e639));
                                        }
                                        let _e643 = phi_1047_;
                                        let _e652 = (_e643[0][2] - _e340);
                                        let _e655 = (((_e643[0][0] - _e224) * _e374) - (_e652 * _e258));
                                        let _e658 = (((_e643[0][1] - _e282) * _e374) - (_e652 * _e316));
                                        let _e665 = (_e643[1][2] - _e340);
                                        let _e668 = (((_e643[1][0] - _e224) * _e374) - (_e665 * _e258));
                                        let _e671 = (((_e643[1][1] - _e282) * _e374) - (_e665 * _e316));
                                        let _e678 = (_e643[2][2] - _e340);
                                        let _e681 = (((_e643[2][0] - _e224) * _e374) - (_e678 * _e258));
                                        let _e684 = (((_e643[2][1] - _e282) * _e374) - (_e678 * _e316));
                                        let _e685 = (_e681 * _e671);
                                        let _e686 = (_e684 * _e668);
                                        let _e687 = (_e655 * _e684);
                                        let _e688 = (_e658 * _e681);
                                        let _e689 = (_e668 * _e658);
                                        let _e690 = (_e671 * _e655);
                                        let _e695 = (((_e685 >= _e686) && (_e687 >= _e688)) && (_e689 >= _e690));
                                        if (_e695 || (((_e685 <= _e686) && (_e687 <= _e688)) && (_e689 <= _e690))) {
                                            let _e702 = select(-1f, 1f, _e695);
                                            let _e704 = ((_e685 - _e686) * _e702);
                                            let _e706 = select(0f, _e704, (_e704 > 0f));
                                            let _e708 = ((_e687 - _e688) * _e702);
                                            let _e710 = select(0f, _e708, (_e708 > 0f));
                                            let _e712 = ((_e689 - _e690) * _e702);
                                            let _e714 = select(0f, _e712, (_e712 > 0f));
                                            let _e716 = ((_e706 + _e710) + _e714);
                                            if (_e716 < 0.000000000000000000000000000000000000011754944f) {
                                                phi_1931_ = SlimbvhTypeE();
                                                phi_1932_ = true;
                                                phi_1933_ = false;
                                            } else {
                                                let _e719 = select(_e668, _e655, (_e655 < _e668));
                                                if (select(_e681, _e719, (_e719 < _e681)) > 0f) {
                                                    phi_1199_ = true;
                                                } else {
                                                    let _e724 = select(_e668, _e655, (_e655 > _e668));
                                                    phi_1199_ = (select(_e681, _e724, (_e724 > _e681)) < 0f);
                                                }
                                                let _e729 = phi_1199_;
                                                if _e729 {
                                                    phi_1928_ = SlimbvhTypeE();
                                                    phi_1929_ = true;
                                                    phi_1930_ = false;
                                                } else {
                                                    let _e731 = select(_e671, _e658, (_e658 < _e671));
                                                    if (select(_e684, _e731, (_e731 < _e684)) > 0f) {
                                                        phi_1228_ = true;
                                                    } else {
                                                        let _e736 = select(_e671, _e658, (_e658 > _e671));
                                                        phi_1228_ = (select(_e684, _e736, (_e736 > _e684)) < 0f);
                                                    }
                                                    let _e741 = phi_1228_;
                                                    if _e741 {
                                                        phi_1926_ = SlimbvhTypeE();
                                                        phi_1927_ = false;
                                                    } else {
                                                        let _e743 = select(_e643[1][0], _e643[0][0], (_e643[0][0] < _e643[1][0]));
                                                        let _e747 = select(_e643[1][0], _e643[0][0], (_e643[0][0] > _e643[1][0]));
                                                        let _e751 = select(_e643[1][1], _e643[0][1], (_e643[0][1] < _e643[1][1]));
                                                        let _e755 = select(_e643[1][1], _e643[0][1], (_e643[0][1] > _e643[1][1]));
                                                        let _e759 = select(_e643[1][2], _e643[0][2], (_e643[0][2] < _e643[1][2]));
                                                        let _e763 = select(_e643[1][2], _e643[0][2], (_e643[0][2] > _e643[1][2]));
                                                        let _e768 = ((select(_e643[2][0], _e743, (_e743 < _e643[2][0])) - _e256) * _e261);
                                                        let _e769 = ((select(_e643[2][0], _e747, (_e747 > _e643[2][0])) - _e257) * _e261);
                                                        let _e772 = ((select(_e643[2][1], _e751, (_e751 < _e643[2][1])) - _e314) * _e319);
                                                        let _e773 = ((select(_e643[2][1], _e755, (_e755 > _e643[2][1])) - _e315) * _e319);
                                                        let _e776 = ((select(_e643[2][2], _e759, (_e759 < _e643[2][2])) - _e372) * _e377);
                                                        let _e777 = ((select(_e643[2][2], _e763, (_e763 > _e643[2][2])) - _e373) * _e377);
                                                        let _e779 = select(_e777, _e776, (_e776 < _e777));
                                                        let _e781 = select(_e777, _e776, (_e776 > _e777));
                                                        let _e783 = select(_e769, _e768, (_e768 < _e769));
                                                        let _e785 = select(_e773, _e772, (_e772 < _e773));
                                                        let _e787 = select(_e785, _e783, (_e783 > _e785));
                                                        let _e789 = select(_e779, _e787, (_e787 > _e779));
                                                        let _e791 = select(_e769, _e768, (_e768 > _e769));
                                                        let _e793 = select(_e773, _e772, (_e772 > _e773));
                                                        let _e795 = select(_e793, _e791, (_e791 < _e793));
                                                        let _e797 = select(_e781, _e795, (_e795 < _e781));
                                                        let _e798 = -(_e779);
                                                        let _e804 = select(_e489, _e789, (_e789 > _e489));
                                                        if (_e804 > (_e797 + (select(_e798, _e781, (_e781 > _e798)) * 0.0000019073523f))) {
                                                            phi_1921_ = SlimbvhTypeE();
                                                            phi_1922_ = true;
                                                        } else {
                                                            let _e806 = (_e804 > _e544.member.member_1);
                                                            if _e806 {
                                                                phi_1920_ = SlimbvhTypeE();
                                                            } else {
                                                                let _e807 = vec3<f32>(_e643[0][0], _e643[0][1], _e643[0][2]);
                                                                let _e808 = vec3<f32>(_e643[1][0], _e643[1][1], _e643[1][2]);
                                                                let _e809 = vec3<f32>(_e643[2][0], _e643[2][1], _e643[2][2]);
                                                                let _e810 = (_e643[1][0] - _e643[0][0]);
                                                                let _e811 = (_e643[1][1] - _e643[0][1]);
                                                                let _e812 = (_e643[1][2] - _e643[0][2]);
                                                                let _e813 = vec3<f32>(_e810, _e811, _e812);
                                                                let _e814 = (_e643[2][0] - _e643[1][0]);
                                                                let _e815 = (_e643[2][1] - _e643[1][1]);
                                                                let _e816 = (_e643[2][2] - _e643[1][2]);
                                                                let _e817 = vec3<f32>(_e814, _e815, _e816);
                                                                let _e818 = (_e643[0][0] - _e643[2][0]);
                                                                let _e819 = (_e643[0][1] - _e643[2][1]);
                                                                let _e820 = (_e643[0][2] - _e643[2][2]);
                                                                let _e821 = vec3<f32>(_e818, _e819, _e820);
                                                                let _e824 = bitcast<f32>((bitcast<u32>(_e810) & 2147483647u));
                                                                let _e827 = bitcast<f32>((bitcast<u32>(_e811) & 2147483647u));
                                                                let _e829 = select(_e827, _e824, (_e824 > _e827));
                                                                let _e832 = bitcast<f32>((bitcast<u32>(_e812) & 2147483647u));
                                                                let _e834 = select(_e832, _e829, (_e829 > _e832));
                                                                let _e837 = bitcast<f32>((bitcast<u32>(_e814) & 2147483647u));
                                                                let _e840 = bitcast<f32>((bitcast<u32>(_e815) & 2147483647u));
                                                                let _e842 = select(_e840, _e837, (_e837 > _e840));
                                                                let _e845 = bitcast<f32>((bitcast<u32>(_e816) & 2147483647u));
                                                                let _e847 = select(_e845, _e842, (_e842 > _e845));
                                                                let _e850 = bitcast<f32>((bitcast<u32>(_e818) & 2147483647u));
                                                                let _e853 = bitcast<f32>((bitcast<u32>(_e819) & 2147483647u));
                                                                let _e855 = select(_e853, _e850, (_e850 > _e853));
                                                                let _e858 = bitcast<f32>((bitcast<u32>(_e820) & 2147483647u));
                                                                let _e860 = select(_e858, _e855, (_e855 > _e858));
                                                                let _e862 = select(_e847, _e834, (_e834 > _e847));
                                                                let _e864 = select(_e860, _e862, (_e862 > _e860));
                                                                if (_e834 == _e864) {
                                                                    phi_1647_ = _e671;
                                                                    phi_1648_ = _e668;
                                                                    phi_1649_ = _e658;
                                                                    phi_1650_ = _e655;
                                                                    phi_1651_ = _e807;
                                                                    phi_1652_ = _e821;
                                                                    phi_1653_ = _e817;
                                                                    phi_1654_ = _e813;
                                                                } else {
                                                                    let _e866 = (_e847 == _e864);
                                                                    let _e871 = vec3(_e866);
                                                                    phi_1647_ = select(_e658, _e684, _e866);
                                                                    phi_1648_ = select(_e655, _e681, _e866);
                                                                    phi_1649_ = select(_e684, _e671, _e866);
                                                                    phi_1650_ = select(_e681, _e668, _e866);
                                                                    phi_1651_ = select(_e809, _e808, _e871);
                                                                    phi_1652_ = select(_e817, _e813, _e871);
                                                                    phi_1653_ = select(_e813, _e821, _e871);
                                                                    phi_1654_ = select(_e821, _e817, _e871);
                                                                }
                                                                let _e877 = phi_1647_;
                                                                let _e879 = phi_1648_;
                                                                let _e881 = phi_1649_;
                                                                let _e883 = phi_1650_;
                                                                let _e885 = phi_1651_;
                                                                let _e887 = phi_1652_;
                                                                let _e889 = phi_1653_;
                                                                let _e891 = phi_1654_;
                                                                let _e898 = ((_e889.y * _e887.z) - (_e887.y * _e889.z));
                                                                let _e903 = ((_e889.z * _e887.x) - (_e887.z * _e889.x));
                                                                let _e906 = ((_e889.x * _e887.y) - (_e887.x * _e889.y));
                                                                if (_e706 >= _e710) {
                                                                    phi_1691_ = select(true, false, (_e706 >= _e714));
                                                                } else {
                                                                    phi_1691_ = true;
                                                                }
                                                                let _e911 = phi_1691_;
                                                                if _e911 {
                                                                    phi_1700_ = select(_e809, _e808, vec3((_e710 >= _e714)));
                                                                } else {
                                                                    phi_1700_ = _e807;
                                                                }
                                                                let _e916 = phi_1700_;
                                                                let _e927 = (((_e898 * (_e916.x - _e224)) + (_e903 * (_e916.y - _e282))) + (_e906 * (_e916.z - _e340)));
                                                                let _e932 = (((_e898 * _e258) + (_e903 * _e316)) + (_e906 * _e374));
                                                                let _e933 = (_e879 - _e883);
                                                                let _e934 = (_e877 - _e881);
                                                                let _e942 = (-(((_e883 * _e933) + (_e881 * _e934))) / ((_e933 * _e933) + (_e934 * _e934)));
                                                                let _e944 = select(1f, _e942, (_e942 < 1f));
                                                                let _e946 = select(0f, _e944, (_e944 > 0f));
                                                                let _e959 = ((_e885.x + (_e891.x * _e946)) - _e224);
                                                                let _e960 = ((_e885.y + (_e891.y * _e946)) - _e282);
                                                                let _e961 = ((_e885.z + (_e891.z * _e946)) - _e340);
                                                                let _e962 = (_e961 / _e374);
                                                                let _e974 = bitcast<f32>((bitcast<u32>(_e959) & 2147483647u));
                                                                let _e977 = bitcast<f32>((bitcast<u32>(_e960) & 2147483647u));
                                                                let _e979 = select(_e977, _e974, (_e974 > _e977));
                                                                let _e982 = bitcast<f32>((bitcast<u32>(_e961) & 2147483647u));
                                                                let _e984 = select(_e982, _e979, (_e979 > _e982));
                                                                let _e990 = bitcast<f32>((bitcast<u32>(_e898) & 2147483647u));
                                                                let _e993 = bitcast<f32>((bitcast<u32>(_e903) & 2147483647u));
                                                                let _e995 = select(_e993, _e990, (_e990 > _e993));
                                                                let _e998 = bitcast<f32>((bitcast<u32>(_e906) & 2147483647u));
                                                                if (bitcast<f32>((bitcast<u32>(((((_e898 * _e959) + (_e903 * _e960)) + (_e906 * _e961)) - _e927)) & 2147483647u)) <= ((0.0000009536743f * select(_e864, _e984, (_e984 > _e864))) * select(_e998, _e995, (_e995 > _e998)))) {
                                                                    let _e1008 = bitcast<f32>((bitcast<u32>(_e889.x) & 2147483647u));
                                                                    let _e1011 = bitcast<f32>((bitcast<u32>(_e889.y) & 2147483647u));
                                                                    let _e1013 = select(_e1011, _e1008, (_e1008 > _e1011));
                                                                    let _e1016 = bitcast<f32>((bitcast<u32>(_e889.z) & 2147483647u));
                                                                    let _e1022 = bitcast<f32>((bitcast<u32>(_e887.x) & 2147483647u));
                                                                    let _e1025 = bitcast<f32>((bitcast<u32>(_e887.y) & 2147483647u));
                                                                    let _e1027 = select(_e1025, _e1022, (_e1022 > _e1025));
                                                                    let _e1030 = bitcast<f32>((bitcast<u32>(_e887.z) & 2147483647u));
                                                                    let _e1034 = (bitcast<f32>((bitcast<u32>(_e932) & 2147483647u)) > ((0.0000038146973f * select(_e1016, _e1013, (_e1013 > _e1016))) * select(_e1030, _e1027, (_e1027 > _e1030))));
                                                                    if _e1034 {
                                                                        phi_1865_ = (_e927 / _e932);
                                                                    } else {
                                                                        phi_1865_ = f32();
                                                                    }
                                                                    let _e1037 = phi_1865_;
                                                                    phi_1867_ = _e1037;
                                                                    phi_1868_ = select(true, false, _e1034);
                                                                } else {
                                                                    phi_1867_ = f32();
                                                                    phi_1868_ = true;
                                                                }
                                                                let _e1040 = phi_1867_;
                                                                let _e1042 = phi_1868_;
                                                                if _e1042 {
                                                                    let _e1050 = (((_e898 * (_e959 - (_e258 * _e962))) + (_e903 * (_e960 - (_e316 * _e962)))) / _e932);
                                                                    if (bitcast<f32>((bitcast<u32>(_e1050) & 2147483647u)) <= _e864) {
                                                                        phi_1888_ = (_e962 + _e1050);
                                                                    } else {
                                                                        phi_1888_ = _e962;
                                                                    }
                                                                    let _e1057 = phi_1888_;
                                                                    phi_1889_ = _e1057;
                                                                } else {
                                                                    phi_1889_ = _e1040;
                                                                }
                                                                let _e1059 = phi_1889_;
                                                                let _e1061 = select(_e797, _e1059, (_e1059 < _e797));
                                                                let _e1063 = select(_e789, _e1061, (_e1061 > _e789));
                                                                if (_e1063 >= _e489) {
                                                                    let _e1065 = (_e1063 <= _e544.member.member_1);
                                                                    if _e1065 {
                                                                        let _e1066 = (1f / _e716);
                                                                        phi_1912_ = SlimbvhTypeE(_e1063, (_e710 * _e1066), (_e714 * _e1066), _e573);
                                                                    } else {
                                                                        phi_1912_ = SlimbvhTypeE();
                                                                    }
                                                                    let _e1071 = phi_1912_;
                                                                    phi_1914_ = _e1071;
                                                                    phi_1915_ = select(true, false, _e1065);
                                                                } else {
                                                                    phi_1914_ = SlimbvhTypeE();
                                                                    phi_1915_ = true;
                                                                }
                                                                let _e1074 = phi_1914_;
                                                                let _e1076 = phi_1915_;
                                                                if _e1076 {
                                                                    phi_1919_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1919_ = _e1074;
                                                                }
                                                                let _e1078 = phi_1919_;
                                                                phi_1920_ = _e1078;
                                                            }
                                                            let _e1080 = phi_1920_;
                                                            phi_1921_ = _e1080;
                                                            phi_1922_ = _e806;
                                                        }
                                                        let _e1082 = phi_1921_;
                                                        let _e1084 = phi_1922_;
                                                        phi_1926_ = _e1082;
                                                        phi_1927_ = _e1084;
                                                    }
                                                    let _e1086 = phi_1926_;
                                                    let _e1088 = phi_1927_;
                                                    phi_1928_ = _e1086;
                                                    phi_1929_ = _e741;
                                                    phi_1930_ = _e1088;
                                                }
                                                let _e1090 = phi_1928_;
                                                let _e1092 = phi_1929_;
                                                let _e1094 = phi_1930_;
                                                phi_1931_ = _e1090;
                                                phi_1932_ = _e1092;
                                                phi_1933_ = _e1094;
                                            }
                                            let _e1096 = phi_1931_;
                                            let _e1098 = phi_1932_;
                                            let _e1100 = phi_1933_;
                                            phi_1941_ = _e1096;
                                            phi_1942_ = select(_e1100, true, _e1098);
                                        } else {
                                            phi_1941_ = SlimbvhTypeE();
                                            phi_1942_ = true;
                                        }
                                        let _e1103 = phi_1941_;
                                        let _e1105 = phi_1942_;
                                        if _e1105 {
                                            phi_1946_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                        } else {
                                            phi_1946_ = _e1103;
                                        }
                                        let _e1107 = phi_1946_;
                                        if (_e1107.member_3 != 4294967295u) {
                                            if (_e573 != 4294967295u) {
                                                if (_e1107.member < _e544.member.member.member) {
                                                    phi_1972_ = true;
                                                } else {
                                                    if (_e1107.member == _e544.member.member.member) {
                                                        phi_1971_ = (_e1107.member_3 < _e544.member.member.member_3);
                                                    } else {
                                                        phi_1971_ = false;
                                                    }
                                                    let _e1122 = phi_1971_;
                                                    phi_1972_ = _e1122;
                                                }
                                                let _e1124 = phi_1972_;
                                                if _e1124 {
                                                    phi_1979_ = SlimbvhTypeK(SlimbvhTypeJ(_e1107, _e1107.member), _e544.member_1);
                                                } else {
                                                    phi_1979_ = _e544;
                                                }
                                                let _e1130 = phi_1979_;
                                                phi_1980_ = _e1130;
                                            } else {
                                                phi_1980_ = _e544;
                                            }
                                            let _e1132 = phi_1980_;
                                            phi_1981_ = _e1132;
                                        } else {
                                            phi_1981_ = _e544;
                                        }
                                        let _e1134 = phi_1981_;
                                        phi_909_ = _e1134;
                                    } else {
                                        phi_909_ = SlimbvhTypeK();
                                    }
                                    let _e1136 = phi_909_;
                                    continue;
                                    continuing {
                                        phi_908_ = _e1136;
                                        phi_911_ = _e559;
                                        phi_2741_ = _e504;
                                        break if !(_e565);
                                    }
                                }
                                let _e1139 = phi_2741_;
                                phi_2902_ = _e1139;
                                if _e1139 {
                                    break;
                                }
                                phi_2937_ = _e1139;
                                let _e1610 = local_3;
                                phi_1982_ = _e1610;
                            } else {
                                phi_2937_ = _e504;
                                phi_1982_ = _e506;
                            }
                            let _e1141 = phi_2937_;
                            let _e1143 = phi_1982_;
                            if _e537 {
                                phi_2462_ = bool();
                                phi_2463_ = u32();
                                phi_2464_ = u32();
                            } else {
                                if (_e534 >= _e74) {
                                    phi_2047_ = SlimbvhTypeL(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                } else {
                                    if (_e534 < _e74) {
                                    } else {
                                        phi_2902_ = true;
                                        break;
                                    }
                                    let _e1146 = (_e169 % 3u);
                                    if (_e1146 < 3u) {
                                    } else {
                                        phi_2902_ = true;
                                        break;
                                    }
                                    let _e1152 = slimbvh_nodes.member[_e534].member[_e1146];
                                    let _e1158 = (_e168 % 3u);
                                    if (_e1158 < 3u) {
                                    } else {
                                        phi_2902_ = true;
                                        break;
                                    }
                                    let _e1164 = slimbvh_nodes.member[_e534].member[_e1158];
                                    let _e1170 = (_e170 % 3u);
                                    if (_e1170 < 3u) {
                                    } else {
                                        phi_2902_ = true;
                                        break;
                                    }
                                    let _e1176 = slimbvh_nodes.member[_e534].member[_e1170];
                                    let _e1186 = slimbvh_nodes.member[_e534].member_1;
                                    let _e1190 = slimbvh_nodes.member[_e534].member_2;
                                    phi_2047_ = SlimbvhTypeL(array<vec4<f32>, 3>(vec4<f32>(_e1152[0], _e1152[1], _e1152[2], _e1152[3]), vec4<f32>(_e1164[0], _e1164[1], _e1164[2], _e1164[3]), vec4<f32>(_e1176[0], _e1176[1], _e1176[2], _e1176[3])), _e1186, _e1190);
                                }
                                let _e1193 = phi_2047_;
                                let _e1206 = ((_e1193.member[0].x - _e256) * _e261);
                                let _e1207 = ((_e1193.member[0].y - _e256) * _e261);
                                let _e1208 = ((_e1193.member[0].z - _e257) * _e261);
                                let _e1209 = ((_e1193.member[0].w - _e257) * _e261);
                                let _e1219 = ((_e1193.member[1].x - _e314) * _e319);
                                let _e1220 = ((_e1193.member[1].y - _e314) * _e319);
                                let _e1221 = ((_e1193.member[1].z - _e315) * _e319);
                                let _e1222 = ((_e1193.member[1].w - _e315) * _e319);
                                let _e1232 = ((_e1193.member[2].x - _e372) * _e377);
                                let _e1233 = ((_e1193.member[2].y - _e372) * _e377);
                                let _e1234 = ((_e1193.member[2].z - _e373) * _e377);
                                let _e1235 = ((_e1193.member[2].w - _e373) * _e377);
                                let _e1237 = select(_e1234, _e1232, (_e1232 < _e1234));
                                let _e1239 = select(_e1235, _e1233, (_e1233 < _e1235));
                                let _e1241 = select(_e1234, _e1232, (_e1232 > _e1234));
                                let _e1243 = select(_e1235, _e1233, (_e1233 > _e1235));
                                let _e1245 = select(_e1208, _e1206, (_e1206 < _e1208));
                                let _e1247 = select(_e1209, _e1207, (_e1207 < _e1209));
                                let _e1249 = select(_e1221, _e1219, (_e1219 < _e1221));
                                let _e1251 = select(_e1222, _e1220, (_e1220 < _e1222));
                                let _e1253 = select(_e1249, _e1245, (_e1245 > _e1249));
                                let _e1255 = select(_e1251, _e1247, (_e1247 > _e1251));
                                let _e1257 = select(_e1237, _e1253, (_e1253 > _e1237));
                                let _e1259 = select(_e1239, _e1255, (_e1255 > _e1239));
                                let _e1261 = select(_e1208, _e1206, (_e1206 > _e1208));
                                let _e1263 = select(_e1209, _e1207, (_e1207 > _e1209));
                                let _e1265 = select(_e1221, _e1219, (_e1219 > _e1221));
                                let _e1267 = select(_e1222, _e1220, (_e1220 > _e1222));
                                let _e1269 = select(_e1265, _e1261, (_e1261 < _e1265));
                                let _e1271 = select(_e1267, _e1263, (_e1263 < _e1267));
                                let _e1276 = -(_e1237);
                                let _e1277 = -(_e1239);
                                let _e1284 = (select(_e1241, _e1269, (_e1269 < _e1241)) + (select(_e1276, _e1241, (_e1241 > _e1276)) * 0.0000019073523f));
                                let _e1285 = (select(_e1243, _e1271, (_e1271 < _e1243)) + (select(_e1277, _e1243, (_e1243 > _e1277)) * 0.0000019073523f));
                                let _e1287 = select(_e489, _e1257, (_e1257 > _e489));
                                let _e1289 = select(_e489, _e1259, (_e1259 > _e489));
                                let _e1294 = (_e1287 <= select(_e1143.member.member_1, _e1284, (_e1284 < _e1143.member.member_1)));
                                let _e1295 = (_e1289 <= select(_e1143.member.member_1, _e1285, (_e1285 < _e1143.member.member_1)));
                                let _e1296 = (_e1287 <= _e1289);
                                if _e1294 {
                                    if _e1295 {
                                        if _e1296 {
                                            phi_2409_ = _e1193.member_2;
                                        } else {
                                            phi_2409_ = _e1193.member_1;
                                        }
                                        let _e1300 = phi_2409_;
                                        let _e1302 = (_e532 % 128u);
                                        let _e1303 = (_e1302 < 128u);
                                        if _e1303 {
                                        } else {
                                            phi_2902_ = true;
                                            break;
                                        }
                                        local_1[_e1302] = _e1300;
                                        if _e1303 {
                                        } else {
                                            phi_2902_ = true;
                                            break;
                                        }
                                        local[_e1302] = select(_e1287, _e1289, _e1296);
                                        if _e1296 {
                                            phi_2436_ = _e1193.member_1;
                                        } else {
                                            phi_2436_ = _e1193.member_2;
                                        }
                                        let _e1310 = phi_2436_;
                                        phi_2437_ = (_e532 + 1u);
                                        phi_2438_ = _e1310;
                                    } else {
                                        phi_2437_ = u32();
                                        phi_2438_ = u32();
                                    }
                                    let _e1312 = phi_2437_;
                                    let _e1314 = phi_2438_;
                                    phi_2440_ = _e1312;
                                    phi_2441_ = _e1314;
                                    phi_2442_ = select(true, false, _e1295);
                                } else {
                                    phi_2440_ = u32();
                                    phi_2441_ = u32();
                                    phi_2442_ = true;
                                }
                                let _e1317 = phi_2440_;
                                let _e1319 = phi_2441_;
                                let _e1321 = phi_2442_;
                                if _e1321 {
                                    if _e1294 {
                                        phi_2451_ = _e1193.member_1;
                                    } else {
                                        phi_2451_ = _e1193.member_2;
                                    }
                                    let _e1325 = phi_2451_;
                                    phi_2456_ = select(_e1295, true, _e1294);
                                    phi_2458_ = _e1325;
                                } else {
                                    phi_2456_ = _e530;
                                    phi_2458_ = _e1319;
                                }
                                let _e1328 = phi_2456_;
                                let _e1330 = phi_2458_;
                                phi_2462_ = _e1328;
                                phi_2463_ = select(_e1317, _e532, _e1321);
                                phi_2464_ = _e1330;
                            }
                            let _e1333 = phi_2462_;
                            let _e1335 = phi_2463_;
                            let _e1337 = phi_2464_;
                            if _e537 {
                                if _e1143.member_1 {
                                    phi_2474_ = (_e1143.member.member.member_3 != 4294967295u);
                                } else {
                                    phi_2474_ = false;
                                }
                                let _e1344 = phi_2474_;
                                phi_2480_ = select(_e532, 0u, _e1344);
                            } else {
                                phi_2480_ = _e1335;
                            }
                            let _e1347 = phi_2480_;
                            phi_2905_ = _e1141;
                            phi_2482_ = _e1143;
                            phi_2483_ = (_e508 - 1u);
                            phi_2484_ = select(_e1333, false, _e537);
                            phi_2485_ = _e1347;
                            phi_2486_ = select(_e1337, _e534, _e537);
                        } else {
                            phi_2905_ = _e504;
                            phi_2482_ = _e506;
                            phi_2483_ = _e508;
                            phi_2484_ = _e530;
                            phi_2485_ = _e532;
                            phi_2486_ = _e534;
                        }
                        let _e1351 = phi_2905_;
                        let _e1353 = phi_2482_;
                        let _e1355 = phi_2483_;
                        let _e1357 = phi_2484_;
                        let _e1359 = phi_2485_;
                        let _e1361 = phi_2486_;
                        phi_2904_ = _e1351;
                        phi_2487_ = _e1353;
                        phi_2488_ = _e1355;
                        phi_2489_ = _e1357;
                        phi_2490_ = _e1359;
                        phi_2491_ = _e1361;
                    } else {
                        phi_2904_ = _e504;
                        phi_2487_ = SlimbvhTypeK();
                        phi_2488_ = u32();
                        phi_2489_ = bool();
                        phi_2490_ = u32();
                        phi_2491_ = u32();
                    }
                    let _e1363 = phi_2904_;
                    let _e1365 = phi_2487_;
                    let _e1367 = phi_2488_;
                    let _e1369 = phi_2489_;
                    let _e1371 = phi_2490_;
                    let _e1373 = phi_2491_;
                    phi_2903_ = _e1363;
                    phi_840_ = _e1365;
                    phi_843_ = _e1367;
                    phi_845_ = _e1369;
                    phi_847_ = _e1371;
                    phi_849_ = _e1373;
                    phi_2492_ = _e518;
                } else {
                    phi_2903_ = _e504;
                    phi_840_ = SlimbvhTypeK();
                    phi_843_ = u32();
                    phi_845_ = bool();
                    phi_847_ = u32();
                    phi_849_ = u32();
                    phi_2492_ = false;
                }
                let _e1375 = phi_2903_;
                let _e1377 = phi_840_;
                let _e1379 = phi_843_;
                let _e1381 = phi_845_;
                let _e1383 = phi_847_;
                let _e1385 = phi_849_;
                let _e1387 = phi_2492_;
                continue;
                continuing {
                    phi_2747_ = _e1375;
                    phi_839_ = _e1377;
                    phi_842_ = _e1379;
                    phi_844_ = _e1381;
                    phi_846_ = _e1383;
                    phi_848_ = _e1385;
                    phi_2902_ = _e1375;
                    break if !(_e1387);
                }
            }
            let _e1390 = phi_2902_;
            if _e1390 {
                break;
            }
            let _e1392 = local_2;
            if (_e1392.member.member.member_3 != 4294967295u) {
                let _e1398 = -(_e391);
                let _e1399 = bitcast<u32>(_e1392.member.member.member);
                let _e1403 = (bitcast<i32>((_e1399 >> bitcast<u32>(23i))) & 255i);
                let _e1404 = (_e1403 + _e1398);
                if (_e1403 == 255i) {
                    phi_2551_ = _e1392.member.member.member;
                } else {
                    if (_e1403 > 0i) {
                        if (_e1404 > 0i) {
                            let _e1408 = (_e1404 < 255i);
                            if _e1408 {
                                phi_2530_ = bitcast<f32>((_e1399 + bitcast<u32>((_e1398 << bitcast<u32>(23i)))));
                            } else {
                                phi_2530_ = f32();
                            }
                            let _e1415 = phi_2530_;
                            phi_2532_ = _e1415;
                            phi_2533_ = select(true, false, _e1408);
                        } else {
                            phi_2532_ = f32();
                            phi_2533_ = true;
                        }
                        let _e1418 = phi_2532_;
                        let _e1420 = phi_2533_;
                        phi_2534_ = _e1418;
                        phi_2535_ = _e1420;
                    } else {
                        phi_2534_ = f32();
                        phi_2535_ = true;
                    }
                    let _e1422 = phi_2534_;
                    let _e1424 = phi_2535_;
                    if _e1424 {
                        let _e1425 = (_e1399 & 2147483648u);
                        let _e1432 = ((_e1399 & 8388607u) | (select(0u, 1u, ((_e1399 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e1436 = (_e1432 == 0u);
                        if _e1436 {
                            phi_2736_ = bitcast<f32>(_e1425);
                        } else {
                            let _e1441 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1432)), 32u, _e1436) - 8u);
                            let _e1444 = (_e1432 << bitcast<u32>((_e1441 & 31u)));
                            let _e1446 = ((_e1404 + select(0i, 1i, (_e1403 == 0i))) - bitcast<i32>(_e1441));
                            if (_e1446 >= 255i) {
                                phi_2726_ = bitcast<f32>((_e1425 | 2139095040u));
                                phi_2727_ = f32();
                                phi_2728_ = true;
                            } else {
                                let _e1448 = (_e1446 > 0i);
                                if _e1448 {
                                    phi_2720_ = bitcast<f32>(((_e1425 | (bitcast<u32>(_e1446) << bitcast<u32>(23i))) | (_e1444 & 8388607u)));
                                    phi_2721_ = f32();
                                } else {
                                    if (_e1446 < -24i) {
                                        phi_2686_ = 26u;
                                    } else {
                                        phi_2686_ = bitcast<u32>((1i - _e1446));
                                    }
                                    let _e1453 = phi_2686_;
                                    let _e1454 = (_e1453 & 31u);
                                    let _e1456 = (_e1444 >> bitcast<u32>(_e1454));
                                    let _e1460 = (_e1444 & ((1u << bitcast<u32>(_e1454)) - 1u));
                                    let _e1464 = (1u << bitcast<u32>(((_e1453 - 1u) & 31u)));
                                    if (_e1460 > _e1464) {
                                        phi_2707_ = true;
                                    } else {
                                        if (_e1460 == _e1464) {
                                            phi_2704_ = ((_e1456 & 1u) == 1u);
                                        } else {
                                            phi_2704_ = false;
                                        }
                                        let _e1470 = phi_2704_;
                                        phi_2707_ = _e1470;
                                    }
                                    let _e1472 = phi_2707_;
                                    phi_2720_ = f32();
                                    phi_2721_ = bitcast<f32>((_e1425 | (_e1456 + select(0u, 1u, _e1472))));
                                }
                                let _e1485 = phi_2720_;
                                let _e1487 = phi_2721_;
                                phi_2726_ = _e1485;
                                phi_2727_ = _e1487;
                                phi_2728_ = _e1448;
                            }
                            let _e1491 = phi_2726_;
                            let _e1493 = phi_2727_;
                            let _e1495 = phi_2728_;
                            phi_2736_ = select(_e1493, _e1491, _e1495);
                        }
                        let _e1499 = phi_2736_;
                        phi_2550_ = _e1499;
                    } else {
                        phi_2550_ = _e1422;
                    }
                    let _e1501 = phi_2550_;
                    phi_2551_ = _e1501;
                }
                let _e1503 = phi_2551_;
                let _e1504 = bitcast<u32>(_e1503);
                if ((_e1504 & 2147483647u) >= 2139095040u) {
                    phi_2563_ = bitcast<f32>(((_e1504 & 2147483648u) | 2139095039u));
                } else {
                    phi_2563_ = _e1503;
                }
                let _e1511 = phi_2563_;
                phi_2568_ = SlimbvhTypeE(_e1511, _e1392.member.member.member_1, _e1392.member.member.member_2, _e1392.member.member.member_3);
            } else {
                phi_2568_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
            }
            let _e1516 = phi_2568_;
            slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1516.member), bitcast<u32>(_e1516.member_1), bitcast<u32>(_e1516.member_2), _e1516.member_3);
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
