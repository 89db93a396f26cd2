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
    var phi_2751_: bool;
    var phi_840_: SlimbvhTypeK;
    var phi_843_: bool;
    var phi_845_: u32;
    var phi_847_: u32;
    var phi_849_: u32;
    var phi_860_: bool;
    var phi_892_: bool;
    var phi_893_: u32;
    var phi_894_: u32;
    var phi_2066_: SlimbvhTypeL;
    var phi_2428_: u32;
    var phi_2456_: u32;
    var phi_2457_: u32;
    var phi_2458_: u32;
    var phi_2460_: u32;
    var phi_2461_: u32;
    var phi_2462_: bool;
    var phi_2471_: u32;
    var phi_2476_: bool;
    var phi_2478_: u32;
    var phi_909_: SlimbvhTypeK;
    var phi_912_: SlimbvhTypeA;
    var phi_913_: SlimbvhTypeA;
    var phi_935_: SlimbvhTypeA;
    var phi_956_: u32;
    var phi_1048_: array<array<f32, 3>, 3>;
    var phi_1200_: bool;
    var phi_1229_: bool;
    var phi_1648_: f32;
    var phi_1649_: f32;
    var phi_1650_: f32;
    var phi_1651_: f32;
    var phi_1652_: vec3<f32>;
    var phi_1653_: vec3<f32>;
    var phi_1654_: vec3<f32>;
    var phi_1655_: vec3<f32>;
    var phi_1692_: bool;
    var phi_1701_: vec3<f32>;
    var phi_1866_: f32;
    var phi_1868_: f32;
    var phi_1869_: bool;
    var phi_1889_: f32;
    var phi_1890_: f32;
    var phi_1913_: SlimbvhTypeE;
    var phi_1915_: SlimbvhTypeE;
    var phi_1916_: bool;
    var phi_1920_: SlimbvhTypeE;
    var phi_1921_: SlimbvhTypeE;
    var phi_1922_: SlimbvhTypeE;
    var phi_1923_: bool;
    var phi_1927_: SlimbvhTypeE;
    var phi_1928_: bool;
    var phi_1929_: SlimbvhTypeE;
    var phi_1930_: bool;
    var phi_1931_: bool;
    var phi_1932_: SlimbvhTypeE;
    var phi_1933_: bool;
    var phi_1934_: bool;
    var phi_1942_: SlimbvhTypeE;
    var phi_1943_: bool;
    var phi_1947_: SlimbvhTypeE;
    var phi_1972_: bool;
    var phi_1973_: bool;
    var phi_1980_: SlimbvhTypeK;
    var phi_1981_: SlimbvhTypeK;
    var phi_1982_: SlimbvhTypeK;
    var phi_910_: SlimbvhTypeK;
    var phi_2745_: bool;
    var local_2: SlimbvhTypeK;
    var local_3: SlimbvhTypeK;
    var phi_1989_: bool;
    var phi_2910_: bool;
    var phi_2482_: SlimbvhTypeK;
    var phi_2483_: bool;
    var phi_2484_: u32;
    var phi_2485_: u32;
    var phi_2909_: bool;
    var phi_2486_: SlimbvhTypeK;
    var phi_2487_: bool;
    var phi_2488_: u32;
    var phi_2489_: u32;
    var phi_2490_: u32;
    var phi_2908_: bool;
    var phi_2491_: SlimbvhTypeK;
    var phi_2492_: bool;
    var phi_2493_: u32;
    var phi_2494_: u32;
    var phi_2495_: u32;
    var phi_2907_: bool;
    var phi_841_: SlimbvhTypeK;
    var phi_844_: bool;
    var phi_846_: u32;
    var phi_848_: u32;
    var phi_850_: u32;
    var phi_2496_: bool;
    var phi_2906_: bool;
    var local_4: SlimbvhTypeK;
    var phi_2534_: f32;
    var phi_2536_: f32;
    var phi_2537_: bool;
    var phi_2538_: f32;
    var phi_2539_: bool;
    var phi_2690_: u32;
    var phi_2708_: bool;
    var phi_2711_: bool;
    var phi_2724_: f32;
    var phi_2725_: f32;
    var phi_2730_: f32;
    var phi_2731_: f32;
    var phi_2732_: bool;
    var phi_2740_: f32;
    var phi_2554_: f32;
    var phi_2555_: f32;
    var phi_2567_: f32;
    var phi_2572_: SlimbvhTypeE;
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
            phi_2751_ = false;
            phi_840_ = _e497;
            phi_843_ = (_e489 <= _e497.member.member_1);
            phi_845_ = ((3u * _e74) + 1u);
            phi_847_ = 0u;
            phi_849_ = select(0u, 2147483648u, (_e74 == 0u));
            loop {
                let _e506 = phi_2751_;
                let _e508 = phi_840_;
                let _e510 = phi_843_;
                let _e512 = phi_845_;
                let _e514 = phi_847_;
                let _e516 = phi_849_;
                local_4 = _e508;
                if _e510 {
                    phi_860_ = true;
                } else {
                    phi_860_ = (_e514 > 0u);
                }
                let _e519 = phi_860_;
                if _e519 {
                    let _e520 = (_e512 > 0u);
                    if _e520 {
                        if _e510 {
                            phi_892_ = _e510;
                            phi_893_ = _e514;
                            phi_894_ = _e516;
                        } else {
                            let _e521 = (_e514 - 1u);
                            let _e522 = (_e521 % 128u);
                            let _e523 = (_e522 < 128u);
                            if _e523 {
                            } else {
                                phi_2906_ = true;
                                break;
                            }
                            let _e525 = local_1[_e522];
                            if _e523 {
                            } else {
                                phi_2906_ = true;
                                break;
                            }
                            let _e527 = local[_e522];
                            phi_892_ = (_e527 <= _e508.member.member_1);
                            phi_893_ = _e521;
                            phi_894_ = _e525;
                        }
                        let _e532 = phi_892_;
                        let _e534 = phi_893_;
                        let _e536 = phi_894_;
                        if _e532 {
                            if ((_e536 & 2147483648u) != 0u) {
                                phi_909_ = _e508;
                                phi_912_ = SlimbvhTypeA(0u, ((_e536 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e735 = phi_909_;
                                    let _e737 = phi_912_;
                                    local_2 = _e735;
                                    local_3 = _e735;
                                    local_5 = _e735;
                                    if (_e737.member < _e737.member_1) {
                                        phi_913_ = SlimbvhTypeA((_e737.member + 1u), _e737.member_1);
                                        phi_935_ = SlimbvhTypeA(1u, _e737.member);
                                    } else {
                                        phi_913_ = _e737;
                                        phi_935_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                                    }
                                    let _e750 = phi_913_;
                                    let _e752 = phi_935_;
                                    let _e756 = (bitcast<i32>(_e752.member) != 0i);
                                    if _e756 {
                                        let _e757 = ((_e536 & 268435455u) + _e752.member_1);
                                        let _e758 = (_e757 < _e76);
                                        if _e758 {
                                            if _e758 {
                                            } else {
                                                phi_2745_ = true;
                                                break;
                                            }
                                            let _e762 = slimbvh_triangles.member[_e757].member_1;
                                            phi_956_ = _e762;
                                        } else {
                                            phi_956_ = 4294967295u;
                                        }
                                        let _e764 = phi_956_;
                                        if (_e757 >= _e76) {
                                            phi_1048_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                        } else {
                                            if _e758 {
                                            } else {
                                                phi_2745_ = true;
                                                break;
                                            }
                                            let _e766 = (_e169 % 3u);
                                            let _e767 = (_e168 % 3u);
                                            let _e768 = (_e170 % 3u);
                                            if (_e766 < 9u) {
                                            } else {
                                                phi_2745_ = true;
                                                break;
                                            }
                                            let _e774 = slimbvh_triangles.member[_e757].member[_e766];
                                            if (_e767 < 9u) {
                                            } else {
                                                phi_2745_ = true;
                                                break;
                                            }
                                            let _e780 = slimbvh_triangles.member[_e757].member[_e767];
                                            if (_e768 < 9u) {
                                            } else {
                                                phi_2745_ = true;
                                                break;
                                            }
                                            let _e786 = slimbvh_triangles.member[_e757].member[_e768];
                                            let _e788 = (3u + _e766);
                                            if (_e788 < 9u) {
                                            } else {
                                                phi_2745_ = true;
                                                break;
                                            }
                                            let _e794 = slimbvh_triangles.member[_e757].member[_e788];
                                            let _e795 = (3u + _e767);
                                            if (_e795 < 9u) {
                                            } else {
                                                phi_2745_ = true;
                                                break;
                                            }
                                            let _e801 = slimbvh_triangles.member[_e757].member[_e795];
                                            let _e802 = (3u + _e768);
                                            if (_e802 < 9u) {
                                            } else {
                                                phi_2745_ = true;
                                                break;
                                            }
                                            let _e808 = slimbvh_triangles.member[_e757].member[_e802];
                                            let _e810 = (6u + _e766);
                                            if (_e810 < 9u) {
                                            } else {
                                                phi_2745_ = true;
                                                break;
                                            }
                                            let _e816 = slimbvh_triangles.member[_e757].member[_e810];
                                            let _e817 = (6u + _e767);
                                            if (_e817 < 9u) {
                                            } else {
                                                phi_2745_ = true;
                                                break;
                                            }
                                            let _e823 = slimbvh_triangles.member[_e757].member[_e817];
                                            let _e824 = (6u + _e768);
                                            if (_e824 < 9u) {
                                            } else {
                                                phi_2745_ = true;
                                                break;
                                            }
                                            let _e830 = slimbvh_triangles.member[_e757].member[_e824];
                                            phi_1048_ = array<array<f32, 3>, 3>(array<f32, 3>(_e774, _e780, _e786), array<f32, 3>(_e794, _e801, _e808), array<f32, 3>(_e816, _e823, _e830));
                                        }
                                        let _e834 = phi_1048_;
                                        let _e843 = (_e834[0][2] - _e340);
                                        let _e846 = (((_e834[0][0] - _e224) * _e374) - (_e843 * _e258));
                                        let _e849 = (((_e834[0][1] - _e282) * _e374) - (_e843 * _e316));
                                        let _e856 = (_e834[1][2] - _e340);
                                        let _e859 = (((_e834[1][0] - _e224) * _e374) - (_e856 * _e258));
                                        let _e862 = (((_e834[1][1] - _e282) * _e374) - (_e856 * _e316));
                                        let _e869 = (_e834[2][2] - _e340);
                                        let _e872 = (((_e834[2][0] - _e224) * _e374) - (_e869 * _e258));
                                        let _e875 = (((_e834[2][1] - _e282) * _e374) - (_e869 * _e316));
                                        let _e876 = (_e872 * _e862);
                                        let _e877 = (_e875 * _e859);
                                        let _e878 = (_e846 * _e875);
                                        let _e879 = (_e849 * _e872);
                                        let _e880 = (_e859 * _e849);
                                        let _e881 = (_e862 * _e846);
                                        let _e886 = (((_e876 >= _e877) && (_e878 >= _e879)) && (_e880 >= _e881));
                                        if (_e886 || (((_e876 <= _e877) && (_e878 <= _e879)) && (_e880 <= _e881))) {
                                            let _e893 = select(-1f, 1f, _e886);
                                            let _e895 = ((_e876 - _e877) * _e893);
                                            let _e897 = select(0f, _e895, (_e895 > 0f));
                                            let _e899 = ((_e878 - _e879) * _e893);
                                            let _e901 = select(0f, _e899, (_e899 > 0f));
                                            let _e903 = ((_e880 - _e881) * _e893);
                                            let _e905 = select(0f, _e903, (_e903 > 0f));
                                            let _e907 = ((_e897 + _e901) + _e905);
                                            if (_e907 < 0.000000000000000000000000000000000000011754944f) {
                                                phi_1932_ = SlimbvhTypeE();
                                                phi_1933_ = true;
                                                phi_1934_ = false;
                                            } else {
                                                let _e910 = select(_e859, _e846, (_e846 < _e859));
                                                if (select(_e872, _e910, (_e910 < _e872)) > 0f) {
                                                    phi_1200_ = true;
                                                } else {
                                                    let _e915 = select(_e859, _e846, (_e846 > _e859));
                                                    phi_1200_ = (select(_e872, _e915, (_e915 > _e872)) < 0f);
                                                }
                                                let _e920 = phi_1200_;
                                                if _e920 {
                                                    phi_1929_ = SlimbvhTypeE();
                                                    phi_1930_ = true;
                                                    phi_1931_ = false;
                                                } else {
                                                    let _e922 = select(_e862, _e849, (_e849 < _e862));
                                                    if (select(_e875, _e922, (_e922 < _e875)) > 0f) {
                                                        phi_1229_ = true;
                                                    } else {
                                                        let _e927 = select(_e862, _e849, (_e849 > _e862));
                                                        phi_1229_ = (select(_e875, _e927, (_e927 > _e875)) < 0f);
                                                    }
                                                    let _e932 = phi_1229_;
                                                    if _e932 {
                                                        phi_1927_ = SlimbvhTypeE();
                                                        phi_1928_ = false;
                                                    } else {
                                                        let _e934 = select(_e834[1][0], _e834[0][0], (_e834[0][0] < _e834[1][0]));
                                                        let _e938 = select(_e834[1][0], _e834[0][0], (_e834[0][0] > _e834[1][0]));
                                                        let _e942 = select(_e834[1][1], _e834[0][1], (_e834[0][1] < _e834[1][1]));
                                                        let _e946 = select(_e834[1][1], _e834[0][1], (_e834[0][1] > _e834[1][1]));
                                                        let _e950 = select(_e834[1][2], _e834[0][2], (_e834[0][2] < _e834[1][2]));
                                                        let _e954 = select(_e834[1][2], _e834[0][2], (_e834[0][2] > _e834[1][2]));
                                                        let _e959 = ((select(_e834[2][0], _e934, (_e934 < _e834[2][0])) - _e256) * _e261);
                                                        let _e960 = ((select(_e834[2][0], _e938, (_e938 > _e834[2][0])) - _e257) * _e261);
                                                        let _e963 = ((select(_e834[2][1], _e942, (_e942 < _e834[2][1])) - _e314) * _e319);
                                                        let _e964 = ((select(_e834[2][1], _e946, (_e946 > _e834[2][1])) - _e315) * _e319);
                                                        let _e967 = ((select(_e834[2][2], _e950, (_e950 < _e834[2][2])) - _e372) * _e377);
                                                        let _e968 = ((select(_e834[2][2], _e954, (_e954 > _e834[2][2])) - _e373) * _e377);
                                                        let _e970 = select(_e968, _e967, (_e967 < _e968));
                                                        let _e972 = select(_e968, _e967, (_e967 > _e968));
                                                        let _e974 = select(_e960, _e959, (_e959 < _e960));
                                                        let _e976 = select(_e964, _e963, (_e963 < _e964));
                                                        let _e978 = select(_e976, _e974, (_e974 > _e976));
                                                        let _e980 = select(_e970, _e978, (_e978 > _e970));
                                                        let _e982 = select(_e960, _e959, (_e959 > _e960));
                                                        let _e984 = select(_e964, _e963, (_e963 > _e964));
                                                        let _e986 = select(_e984, _e982, (_e982 < _e984));
                                                        let _e988 = select(_e972, _e986, (_e986 < _e972));
                                                        let _e989 = -(_e970);
                                                        let _e995 = select(_e489, _e980, (_e980 > _e489));
                                                        if (_e995 > (_e988 + (select(_e989, _e972, (_e972 > _e989)) * 0.0000019073523f))) {
                                                            phi_1922_ = SlimbvhTypeE();
                                                            phi_1923_ = true;
                                                        } else {
                                                            let _e997 = (_e995 > _e735.member.member_1);
                                                            if _e997 {
                                                                phi_1921_ = SlimbvhTypeE();
                                                            } else {
                                                                let _e998 = vec3<f32>(_e834[0][0], _e834[0][1], _e834[0][2]);
                                                                let _e999 = vec3<f32>(_e834[1][0], _e834[1][1], _e834[1][2]);
                                                                let _e1000 = vec3<f32>(_e834[2][0], _e834[2][1], _e834[2][2]);
                                                                let _e1001 = (_e834[1][0] - _e834[0][0]);
                                                                let _e1002 = (_e834[1][1] - _e834[0][1]);
                                                                let _e1003 = (_e834[1][2] - _e834[0][2]);
                                                                let _e1004 = vec3<f32>(_e1001, _e1002, _e1003);
                                                                let _e1005 = (_e834[2][0] - _e834[1][0]);
                                                                let _e1006 = (_e834[2][1] - _e834[1][1]);
                                                                let _e1007 = (_e834[2][2] - _e834[1][2]);
                                                                let _e1008 = vec3<f32>(_e1005, _e1006, _e1007);
                                                                let _e1009 = (_e834[0][0] - _e834[2][0]);
                                                                let _e1010 = (_e834[0][1] - _e834[2][1]);
                                                                let _e1011 = (_e834[0][2] - _e834[2][2]);
                                                                let _e1012 = vec3<f32>(_e1009, _e1010, _e1011);
                                                                let _e1015 = bitcast<f32>((bitcast<u32>(_e1001) & 2147483647u));
                                                                let _e1018 = bitcast<f32>((bitcast<u32>(_e1002) & 2147483647u));
                                                                let _e1020 = select(_e1018, _e1015, (_e1015 > _e1018));
                                                                let _e1023 = bitcast<f32>((bitcast<u32>(_e1003) & 2147483647u));
                                                                let _e1025 = select(_e1023, _e1020, (_e1020 > _e1023));
                                                                let _e1028 = bitcast<f32>((bitcast<u32>(_e1005) & 2147483647u));
                                                                let _e1031 = bitcast<f32>((bitcast<u32>(_e1006) & 2147483647u));
                                                                let _e1033 = select(_e1031, _e1028, (_e1028 > _e1031));
                                                                let _e1036 = bitcast<f32>((bitcast<u32>(_e1007) & 2147483647u));
                                                                let _e1038 = select(_e1036, _e1033, (_e1033 > _e1036));
                                                                let _e1041 = bitcast<f32>((bitcast<u32>(_e1009) & 2147483647u));
                                                                let _e1044 = bitcast<f32>((bitcast<u32>(_e1010) & 2147483647u));
                                                                let _e1046 = select(_e1044, _e1041, (_e1041 > _e1044));
                                                                let _e1049 = bitcast<f32>((bitcast<u32>(_e1011) & 2147483647u));
                                                                let _e1051 = select(_e1049, _e1046, (_e1046 > _e1049));
                                                                let _e1053 = select(_e1038, _e1025, (_e1025 > _e1038));
                                                                let _e1055 = select(_e1051, _e1053, (_e1053 > _e1051));
                                                                if (_e1025 == _e1055) {
                                                                    phi_1648_ = _e862;
                                                                    phi_1649_ = _e859;
                                                                    phi_1650_ = _e849;
                                                                    phi_1651_ = _e846;
                                                                    phi_1652_ = _e998;
                                                                    phi_1653_ = _e1012;
                                                                    phi_1654_ = _e1008;
                                                                    phi_1655_ = _e1004;
                                                                } else {
                                                                    let _e1057 = (_e1038 == _e1055);
                                                                    let _e1062 = vec3(_e1057);
                                                                    phi_1648_ = select(_e849, _e875, _e1057);
                                                                    phi_1649_ = select(_e846, _e872, _e1057);
                                                                    phi_1650_ = select(_e875, _e862, _e1057);
                                                                    phi_1651_ = select(_e872, _e859, _e1057);
                                                                    phi_1652_ = select(_e1000, _e999, _e1062);
                                                                    phi_1653_ = select(_e1008, _e1004, _e1062);
                                                                    phi_1654_ = select(_e1004, _e1012, _e1062);
                                                                    phi_1655_ = select(_e1012, _e1008, _e1062);
                                                                }
                                                                let _e1068 = phi_1648_;
                                                                let _e1070 = phi_1649_;
                                                                let _e1072 = phi_1650_;
                                                                let _e1074 = phi_1651_;
                                                                let _e1076 = phi_1652_;
                                                                let _e1078 = phi_1653_;
                                                                let _e1080 = phi_1654_;
                                                                let _e1082 = phi_1655_;
                                                                let _e1089 = ((_e1080.y * _e1078.z) - (_e1078.y * _e1080.z));
                                                                let _e1094 = ((_e1080.z * _e1078.x) - (_e1078.z * _e1080.x));
                                                                let _e1097 = ((_e1080.x * _e1078.y) - (_e1078.x * _e1080.y));
                                                                if (_e897 >= _e901) {
                                                                    phi_1692_ = select(true, false, (_e897 >= _e905));
                                                                } else {
                                                                    phi_1692_ = true;
                                                                }
                                                                let _e1102 = phi_1692_;
                                                                if _e1102 {
                                                                    phi_1701_ = select(_e1000, _e999, vec3((_e901 >= _e905)));
                                                                } else {
                                                                    phi_1701_ = _e998;
                                                                }
                                                                let _e1107 = phi_1701_;
                                                                let _e1118 = (((_e1089 * (_e1107.x - _e224)) + (_e1094 * (_e1107.y - _e282))) + (_e1097 * (_e1107.z - _e340)));
                                                                let _e1123 = (((_e1089 * _e258) + (_e1094 * _e316)) + (_e1097 * _e374));
                                                                let _e1124 = (_e1070 - _e1074);
                                                                let _e1125 = (_e1068 - _e1072);
                                                                let _e1133 = (-(((_e1074 * _e1124) + (_e1072 * _e1125))) / ((_e1124 * _e1124) + (_e1125 * _e1125)));
                                                                let _e1135 = select(1f, _e1133, (_e1133 < 1f));
                                                                let _e1137 = select(0f, _e1135, (_e1135 > 0f));
                                                                let _e1150 = ((_e1076.x + (_e1082.x * _e1137)) - _e224);
                                                                let _e1151 = ((_e1076.y + (_e1082.y * _e1137)) - _e282);
                                                                let _e1152 = ((_e1076.z + (_e1082.z * _e1137)) - _e340);
                                                                let _e1153 = (_e1152 / _e374);
                                                                let _e1165 = bitcast<f32>((bitcast<u32>(_e1150) & 2147483647u));
                                                                let _e1168 = bitcast<f32>((bitcast<u32>(_e1151) & 2147483647u));
                                                                let _e1170 = select(_e1168, _e1165, (_e1165 > _e1168));
                                                                let _e1173 = bitcast<f32>((bitcast<u32>(_e1152) & 2147483647u));
                                                                let _e1175 = select(_e1173, _e1170, (_e1170 > _e1173));
                                                                let _e1181 = bitcast<f32>((bitcast<u32>(_e1089) & 2147483647u));
                                                                let _e1184 = bitcast<f32>((bitcast<u32>(_e1094) & 2147483647u));
                                                                let _e1186 = select(_e1184, _e1181, (_e1181 > _e1184));
                                                                let _e1189 = bitcast<f32>((bitcast<u32>(_e1097) & 2147483647u));
                                                                if (bitcast<f32>((bitcast<u32>(((((_e1089 * _e1150) + (_e1094 * _e1151)) + (_e1097 * _e1152)) - _e1118)) & 2147483647u)) <= ((0.0000009536743f * select(_e1055, _e1175, (_e1175 > _e1055))) * select(_e1189, _e1186, (_e1186 > _e1189)))) {
                                                                    let _e1199 = bitcast<f32>((bitcast<u32>(_e1080.x) & 2147483647u));
                                                                    let _e1202 = bitcast<f32>((bitcast<u32>(_e1080.y) & 2147483647u));
                                                                    let _e1204 = select(_e1202, _e1199, (_e1199 > _e1202));
                                                                    let _e1207 = bitcast<f32>((bitcast<u32>(_e1080.z) & 2147483647u));
                                                                    let _e1213 = bitcast<f32>((bitcast<u32>(_e1078.x) & 2147483647u));
                                                                    let _e1216 = bitcast<f32>((bitcast<u32>(_e1078.y) & 2147483647u));
                                                                    let _e1218 = select(_e1216, _e1213, (_e1213 > _e1216));
                                                                    let _e1221 = bitcast<f32>((bitcast<u32>(_e1078.z) & 2147483647u));
                                                                    let _e1225 = (bitcast<f32>((bitcast<u32>(_e1123) & 2147483647u)) > ((0.0000038146973f * select(_e1207, _e1204, (_e1204 > _e1207))) * select(_e1221, _e1218, (_e1218 > _e1221))));
                                                                    if _e1225 {
                                                                        phi_1866_ = (_e1118 / _e1123);
                                                                    } else {
                                                                        phi_1866_ = f32();
                                                                    }
                                                                    let _e1228 = phi_1866_;
                                                                    phi_1868_ = _e1228;
                                                                    phi_1869_ = select(true, false, _e1225);
                                                                } else {
                                                                    phi_1868_ = f32();
                                                                    phi_1869_ = true;
                                                                }
                                                                let _e1231 = phi_1868_;
                                                                let _e1233 = phi_1869_;
                                                                if _e1233 {
                                                                    let _e1241 = (((_e1089 * (_e1150 - (_e258 * _e1153))) + (_e1094 * (_e1151 - (_e316 * _e1153)))) / _e1123);
                                                                    if (bitcast<f32>((bitcast<u32>(_e1241) & 2147483647u)) <= _e1055) {
                                                                        phi_1889_ = (_e1153 + _e1241);
                                                                    } else {
                                                                        phi_1889_ = _e1153;
                                                                    }
                                                                    let _e1248 = phi_1889_;
                                                                    phi_1890_ = _e1248;
                                                                } else {
                                                                    phi_1890_ = _e1231;
                                                                }
                                                                let _e1250 = phi_1890_;
                                                                let _e1252 = select(_e988, _e1250, (_e1250 < _e988));
                                                                let _e1254 = select(_e980, _e1252, (_e1252 > _e980));
                                                                if (_e1254 >= _e489) {
                                                                    let _e1256 = (_e1254 <= _e735.member.member_1);
                                                                    if _e1256 {
                                                                        let _e1257 = (1f / _e907);
                                                                        phi_1913_ = SlimbvhTypeE(_e1254, (_e901 * _e1257), (_e905 * _e1257), _e764);
                                                                    } else {
                                                                        phi_1913_ = SlimbvhTypeE();
                                                                    }
                                                                    let _e1262 = phi_1913_;
                                                                    phi_1915_ = _e1262;
                                                                    phi_1916_ = select(true, false, _e1256);
                                                                } else {
                                                                    phi_1915_ = SlimbvhTypeE();
                                                                    phi_1916_ = true;
                                                                }
                                                                let _e1265 = phi_1915_;
                                                                let _e1267 = phi_1916_;
                                                                if _e1267 {
                                                                    phi_1920_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1920_ = _e1265;
                                                                }
                                                                let _e1269 = phi_1920_;
                                                                phi_1921_ = _e1269;
                                                            }
                                                            let _e1271 = phi_1921_;
                                                            phi_1922_ = _e1271;
                                                            phi_1923_ = _e997;
                                                        }
                                                        let _e1273 = phi_1922_;
                                                        let _e1275 = phi_1923_;
                                                        phi_1927_ = _e1273;
                                                        phi_1928_ = _e1275;
                                                    }
                                                    let _e1277 = phi_1927_;
                                                    let _e1279 = phi_1928_;
                                                    phi_1929_ = _e1277;
                                                    phi_1930_ = _e932;
                                                    phi_1931_ = _e1279;
                                                }
                                                let _e1281 = phi_1929_;
                                                let _e1283 = phi_1930_;
                                                let _e1285 = phi_1931_;
                                                phi_1932_ = _e1281;
                                                phi_1933_ = _e1283;
                                                phi_1934_ = _e1285;
                                            }
                                            let _e1287 = phi_1932_;
                                            let _e1289 = phi_1933_;
                                            let _e1291 = phi_1934_;
                                            phi_1942_ = _e1287;
                                            phi_1943_ = select(_e1291, true, _e1289);
                                        } else {
                                            phi_1942_ = SlimbvhTypeE();
                                            phi_1943_ = true;
                                        }
                                        let _e1294 = phi_1942_;
                                        let _e1296 = phi_1943_;
                                        if _e1296 {
                                            phi_1947_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                        } else {
                                            phi_1947_ = _e1294;
                                        }
                                        let _e1298 = phi_1947_;
                                        if (_e1298.member_3 != 4294967295u) {
                                            if (_e764 != 4294967295u) {
                                                if (_e1298.member < _e735.member.member.member) {
                                                    phi_1973_ = true;
                                                } else {
                                                    if (_e1298.member == _e735.member.member.member) {
                                                        phi_1972_ = (_e1298.member_3 < _e735.member.member.member_3);
                                                    } else {
                                                        phi_1972_ = false;
                                                    }
                                                    let _e1313 = phi_1972_;
                                                    phi_1973_ = _e1313;
                                                }
                                                let _e1315 = phi_1973_;
                                                if _e1315 {
                                                    phi_1980_ = SlimbvhTypeK(SlimbvhTypeJ(_e1298, _e1298.member), _e735.member_1);
                                                } else {
                                                    phi_1980_ = _e735;
                                                }
                                                let _e1321 = phi_1980_;
                                                phi_1981_ = _e1321;
                                            } else {
                                                phi_1981_ = _e735;
                                            }
                                            let _e1323 = phi_1981_;
                                            phi_1982_ = _e1323;
                                        } else {
                                            phi_1982_ = _e735;
                                        }
                                        let _e1325 = phi_1982_;
                                        phi_910_ = _e1325;
                                    } else {
                                        phi_910_ = SlimbvhTypeK();
                                    }
                                    let _e1327 = phi_910_;
                                    continue;
                                    continuing {
                                        phi_909_ = _e1327;
                                        phi_912_ = _e750;
                                        phi_2745_ = _e506;
                                        break if !(_e756);
                                    }
                                }
                                let _e1330 = phi_2745_;
                                phi_2906_ = _e1330;
                                if _e1330 {
                                    break;
                                }
                                let _e1332 = local_2;
                                if _e1332.member_1 {
                                    let _e1335 = local_3;
                                    phi_1989_ = (_e1335.member.member.member_3 != 4294967295u);
                                } else {
                                    phi_1989_ = false;
                                }
                                let _e1341 = phi_1989_;
                                phi_2910_ = _e1330;
                                let _e1627 = local_5;
                                phi_2482_ = _e1627;
                                phi_2483_ = false;
                                phi_2484_ = select(_e534, 0u, _e1341);
                                phi_2485_ = _e536;
                            } else {
                                if (_e536 >= _e74) {
                                    phi_2066_ = SlimbvhTypeL(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                } else {
                                    if (_e536 < _e74) {
                                    } else {
                                        phi_2906_ = true;
                                        break;
                                    }
                                    let _e546 = (_e169 % 3u);
                                    if (_e546 < 3u) {
                                    } else {
                                        phi_2906_ = true;
                                        break;
                                    }
                                    let _e552 = slimbvh_nodes.member[_e536].member[_e546];
                                    let _e558 = (_e168 % 3u);
                                    if (_e558 < 3u) {
                                    } else {
                                        phi_2906_ = true;
                                        break;
                                    }
                                    let _e564 = slimbvh_nodes.member[_e536].member[_e558];
                                    let _e570 = (_e170 % 3u);
                                    if (_e570 < 3u) {
                                    } else {
                                        phi_2906_ = true;
                                        break;
                                    }
                                    let _e576 = slimbvh_nodes.member[_e536].member[_e570];
                                    let _e586 = slimbvh_nodes.member[_e536].member_1;
                                    let _e590 = slimbvh_nodes.member[_e536].member_2;
                                    phi_2066_ = SlimbvhTypeL(array<vec4<f32>, 3>(vec4<f32>(_e552[0], _e552[1], _e552[2], _e552[3]), vec4<f32>(_e564[0], _e564[1], _e564[2], _e564[3]), vec4<f32>(_e576[0], _e576[1], _e576[2], _e576[3])), _e586, _e590);
                                }
                                let _e593 = phi_2066_;
                                let _e606 = ((_e593.member[0].x - _e256) * _e261);
                                let _e607 = ((_e593.member[0].y - _e256) * _e261);
                                let _e608 = ((_e593.member[0].z - _e257) * _e261);
                                let _e609 = ((_e593.member[0].w - _e257) * _e261);
                                let _e619 = ((_e593.member[1].x - _e314) * _e319);
                                let _e620 = ((_e593.member[1].y - _e314) * _e319);
                                let _e621 = ((_e593.member[1].z - _e315) * _e319);
                                let _e622 = ((_e593.member[1].w - _e315) * _e319);
                                let _e632 = ((_e593.member[2].x - _e372) * _e377);
                                let _e633 = ((_e593.member[2].y - _e372) * _e377);
                                let _e634 = ((_e593.member[2].z - _e373) * _e377);
                                let _e635 = ((_e593.member[2].w - _e373) * _e377);
                                let _e637 = select(_e634, _e632, (_e632 < _e634));
                                let _e639 = select(_e635, _e633, (_e633 < _e635));
                                let _e641 = select(_e634, _e632, (_e632 > _e634));
                                let _e643 = select(_e635, _e633, (_e633 > _e635));
                                let _e645 = select(_e608, _e606, (_e606 < _e608));
                                let _e647 = select(_e609, _e607, (_e607 < _e609));
                                let _e649 = select(_e621, _e619, (_e619 < _e621));
                                let _e651 = select(_e622, _e620, (_e620 < _e622));
                                let _e653 = select(_e649, _e645, (_e645 > _e649));
                                let _e655 = select(_e651, _e647, (_e647 > _e651));
                                let _e657 = select(_e637, _e653, (_e653 > _e637));
                                let _e659 = select(_e639, _e655, (_e655 > _e639));
                                let _e661 = select(_e608, _e606, (_e606 > _e608));
                                let _e663 = select(_e609, _e607, (_e607 > _e609));
                                let _e665 = select(_e621, _e619, (_e619 > _e621));
                                let _e667 = select(_e622, _e620, (_e620 > _e622));
                                let _e669 = select(_e665, _e661, (_e661 < _e665));
                                let _e671 = select(_e667, _e663, (_e663 < _e667));
                                let _e676 = -(_e637);
                                let _e677 = -(_e639);
                                let _e684 = (select(_e641, _e669, (_e669 < _e641)) + (select(_e676, _e641, (_e641 > _e676)) * 0.0000019073523f));
                                let _e685 = (select(_e643, _e671, (_e671 < _e643)) + (select(_e677, _e643, (_e643 > _e677)) * 0.0000019073523f));
                                let _e687 = select(_e489, _e657, (_e657 > _e489));
                                let _e689 = select(_e489, _e659, (_e659 > _e489));
                                let _e694 = (_e687 <= select(_e508.member.member_1, _e684, (_e684 < _e508.member.member_1)));
                                let _e695 = (_e689 <= select(_e508.member.member_1, _e685, (_e685 < _e508.member.member_1)));
                                let _e696 = (_e687 <= _e689);
                                if _e694 {
                                    if _e695 {
                                        if _e696 {
                                            phi_2428_ = _e593.member_2;
                                        } else {
                                            phi_2428_ = _e593.member_1;
                                        }
                                        let _e700 = phi_2428_;
                                        let _e703 = (_e534 % 128u);
                                        let _e704 = (_e703 < 128u);
                                        if _e704 {
                                        } else {
                                            phi_2906_ = true;
                                            break;
                                        }
                                        local_1[_e703] = _e700;
                                        if _e704 {
                                        } else {
                                            phi_2906_ = true;
                                            break;
                                        }
                                        local[_e703] = select(_e689, _e687, !(_e696));
                                        if _e696 {
                                            phi_2456_ = _e593.member_1;
                                        } else {
                                            phi_2456_ = _e593.member_2;
                                        }
                                        let _e711 = phi_2456_;
                                        phi_2457_ = (_e534 + 1u);
                                        phi_2458_ = _e711;
                                    } else {
                                        phi_2457_ = u32();
                                        phi_2458_ = u32();
                                    }
                                    let _e713 = phi_2457_;
                                    let _e715 = phi_2458_;
                                    phi_2460_ = _e713;
                                    phi_2461_ = _e715;
                                    phi_2462_ = select(true, false, _e695);
                                } else {
                                    phi_2460_ = u32();
                                    phi_2461_ = u32();
                                    phi_2462_ = true;
                                }
                                let _e718 = phi_2460_;
                                let _e720 = phi_2461_;
                                let _e722 = phi_2462_;
                                if _e722 {
                                    if _e694 {
                                        phi_2471_ = _e593.member_1;
                                    } else {
                                        phi_2471_ = _e593.member_2;
                                    }
                                    let _e726 = phi_2471_;
                                    phi_2476_ = select(_e695, true, _e694);
                                    phi_2478_ = _e726;
                                } else {
                                    phi_2476_ = _e532;
                                    phi_2478_ = _e720;
                                }
                                let _e729 = phi_2476_;
                                let _e731 = phi_2478_;
                                phi_2910_ = _e506;
                                phi_2482_ = _e508;
                                phi_2483_ = _e729;
                                phi_2484_ = select(_e718, _e534, _e722);
                                phi_2485_ = _e731;
                            }
                            let _e1344 = phi_2910_;
                            let _e1346 = phi_2482_;
                            let _e1348 = phi_2483_;
                            let _e1350 = phi_2484_;
                            let _e1352 = phi_2485_;
                            phi_2909_ = _e1344;
                            phi_2486_ = _e1346;
                            phi_2487_ = _e1348;
                            phi_2488_ = (_e512 - 1u);
                            phi_2489_ = _e1350;
                            phi_2490_ = _e1352;
                        } else {
                            phi_2909_ = _e506;
                            phi_2486_ = _e508;
                            phi_2487_ = _e532;
                            phi_2488_ = _e512;
                            phi_2489_ = _e534;
                            phi_2490_ = _e536;
                        }
                        let _e1354 = phi_2909_;
                        let _e1356 = phi_2486_;
                        let _e1358 = phi_2487_;
                        let _e1360 = phi_2488_;
                        let _e1362 = phi_2489_;
                        let _e1364 = phi_2490_;
                        phi_2908_ = _e1354;
                        phi_2491_ = _e1356;
                        phi_2492_ = _e1358;
                        phi_2493_ = _e1360;
                        phi_2494_ = _e1362;
                        phi_2495_ = _e1364;
                    } else {
                        phi_2908_ = _e506;
                        phi_2491_ = SlimbvhTypeK();
                        phi_2492_ = bool();
                        phi_2493_ = u32();
                        phi_2494_ = u32();
                        phi_2495_ = u32();
                    }
                    let _e1366 = phi_2908_;
                    let _e1368 = phi_2491_;
                    let _e1370 = phi_2492_;
                    let _e1372 = phi_2493_;
                    let _e1374 = phi_2494_;
                    let _e1376 = phi_2495_;
                    phi_2907_ = _e1366;
                    phi_841_ = _e1368;
                    phi_844_ = _e1370;
                    phi_846_ = _e1372;
                    phi_848_ = _e1374;
                    phi_850_ = _e1376;
                    phi_2496_ = _e520;
                } else {
                    phi_2907_ = _e506;
                    phi_841_ = SlimbvhTypeK();
                    phi_844_ = bool();
                    phi_846_ = u32();
                    phi_848_ = u32();
                    phi_850_ = u32();
                    phi_2496_ = false;
                }
                let _e1378 = phi_2907_;
                let _e1380 = phi_841_;
                let _e1382 = phi_844_;
                let _e1384 = phi_846_;
                let _e1386 = phi_848_;
                let _e1388 = phi_850_;
                let _e1390 = phi_2496_;
                continue;
                continuing {
                    phi_2751_ = _e1378;
                    phi_840_ = _e1380;
                    phi_843_ = _e1382;
                    phi_845_ = _e1384;
                    phi_847_ = _e1386;
                    phi_849_ = _e1388;
                    phi_2906_ = _e1378;
                    break if !(_e1390);
                }
            }
            let _e1393 = phi_2906_;
            if _e1393 {
                break;
            }
            let _e1395 = local_4;
            if (_e1395.member.member.member_3 != 4294967295u) {
                let _e1401 = -(_e391);
                let _e1402 = bitcast<u32>(_e1395.member.member.member);
                let _e1406 = (bitcast<i32>((_e1402 >> bitcast<u32>(23i))) & 255i);
                let _e1407 = (_e1406 + _e1401);
                if (_e1406 == 255i) {
                    phi_2555_ = _e1395.member.member.member;
                } else {
                    if (_e1406 > 0i) {
                        if (_e1407 > 0i) {
                            let _e1411 = (_e1407 < 255i);
                            if _e1411 {
                                phi_2534_ = bitcast<f32>((_e1402 + bitcast<u32>((_e1401 << bitcast<u32>(23i)))));
                            } else {
                                phi_2534_ = f32();
                            }
                            let _e1418 = phi_2534_;
                            phi_2536_ = _e1418;
                            phi_2537_ = select(true, false, _e1411);
                        } else {
                            phi_2536_ = f32();
                            phi_2537_ = true;
                        }
                        let _e1421 = phi_2536_;
                        let _e1423 = phi_2537_;
                        phi_2538_ = _e1421;
                        phi_2539_ = _e1423;
                    } else {
                        phi_2538_ = f32();
                        phi_2539_ = true;
                    }
                    let _e1425 = phi_2538_;
                    let _e1427 = phi_2539_;
                    if _e1427 {
                        let _e1428 = (_e1402 & 2147483648u);
                        let _e1435 = ((_e1402 & 8388607u) | (select(0u, 1u, ((_e1402 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e1439 = (_e1435 == 0u);
                        if _e1439 {
                            phi_2740_ = bitcast<f32>(_e1428);
                        } else {
                            let _e1444 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1435)), 32u, _e1439) - 8u);
                            let _e1447 = (_e1435 << bitcast<u32>((_e1444 & 31u)));
                            let _e1449 = ((_e1407 + select(0i, 1i, (_e1406 == 0i))) - bitcast<i32>(_e1444));
                            if (_e1449 >= 255i) {
                                phi_2730_ = bitcast<f32>((_e1428 | 2139095040u));
                                phi_2731_ = f32();
                                phi_2732_ = true;
                            } else {
                                let _e1451 = (_e1449 > 0i);
                                if _e1451 {
                                    phi_2724_ = bitcast<f32>(((_e1428 | (bitcast<u32>(_e1449) << bitcast<u32>(23i))) | (_e1447 & 8388607u)));
                                    phi_2725_ = f32();
                                } else {
                                    if (_e1449 < -24i) {
                                        phi_2690_ = 26u;
                                    } else {
                                        phi_2690_ = bitcast<u32>((1i - _e1449));
                                    }
                                    let _e1456 = phi_2690_;
                                    let _e1457 = (_e1456 & 31u);
                                    let _e1459 = (_e1447 >> bitcast<u32>(_e1457));
                                    let _e1463 = (_e1447 & ((1u << bitcast<u32>(_e1457)) - 1u));
                                    let _e1467 = (1u << bitcast<u32>(((_e1456 - 1u) & 31u)));
                                    if (_e1463 > _e1467) {
                                        phi_2711_ = true;
                                    } else {
                                        if (_e1463 == _e1467) {
                                            phi_2708_ = ((_e1459 & 1u) == 1u);
                                        } else {
                                            phi_2708_ = false;
                                        }
                                        let _e1473 = phi_2708_;
                                        phi_2711_ = _e1473;
                                    }
                                    let _e1475 = phi_2711_;
                                    phi_2724_ = f32();
                                    phi_2725_ = bitcast<f32>((_e1428 | (_e1459 + select(0u, 1u, _e1475))));
                                }
                                let _e1488 = phi_2724_;
                                let _e1490 = phi_2725_;
                                phi_2730_ = _e1488;
                                phi_2731_ = _e1490;
                                phi_2732_ = _e1451;
                            }
                            let _e1494 = phi_2730_;
                            let _e1496 = phi_2731_;
                            let _e1498 = phi_2732_;
                            phi_2740_ = select(_e1496, _e1494, _e1498);
                        }
                        let _e1502 = phi_2740_;
                        phi_2554_ = _e1502;
                    } else {
                        phi_2554_ = _e1425;
                    }
                    let _e1504 = phi_2554_;
                    phi_2555_ = _e1504;
                }
                let _e1506 = phi_2555_;
                let _e1507 = bitcast<u32>(_e1506);
                if ((_e1507 & 2147483647u) >= 2139095040u) {
                    phi_2567_ = bitcast<f32>(((_e1507 & 2147483648u) | 2139095039u));
                } else {
                    phi_2567_ = _e1506;
                }
                let _e1514 = phi_2567_;
                phi_2572_ = SlimbvhTypeE(_e1514, _e1395.member.member.member_1, _e1395.member.member.member_2, _e1395.member.member.member_3);
            } else {
                phi_2572_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
            }
            let _e1519 = phi_2572_;
            slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1519.member), bitcast<u32>(_e1519.member_1), bitcast<u32>(_e1519.member_2), _e1519.member_3);
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
