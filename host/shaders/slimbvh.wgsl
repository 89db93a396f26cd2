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
    member: SlimbvhTypeC,
    member_1: f32,
}

struct SlimbvhTypeI {
    member: SlimbvhTypeH,
    member_1: bool,
}

struct SlimbvhTypeJ {
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
    var phi_250_: i32;
    var phi_251_: i32;
    var phi_261_: bool;
    var phi_271_: u32;
    var phi_272_: u32;
    var phi_274_: bool;
    var phi_279_: u32;
    var phi_292_: i32;
    var phi_312_: i32;
    var phi_737_: i32;
    var phi_759_: u32;
    var phi_760_: u32;
    var phi_795_: i32;
    var phi_817_: u32;
    var phi_818_: u32;
    var phi_826_: f32;
    var phi_827_: f32;
    var phi_841_: SlimbvhTypeI;
    var phi_2390_: bool;
    var phi_855_: SlimbvhTypeI;
    var phi_858_: u32;
    var phi_860_: u32;
    var phi_862_: u32;
    var phi_871_: u32;
    var phi_874_: u32;
    var phi_876_: u32;
    var phi_1155_: u32;
    var phi_1130_: u32;
    var phi_1156_: u32;
    var phi_1157_: u32;
    var phi_872_: u32;
    var phi_875_: u32;
    var phi_877_: u32;
    var phi_2387_: bool;
    var local_2: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1173_: SlimbvhTypeI;
    var phi_1176_: SlimbvhTypeA;
    var phi_1177_: SlimbvhTypeA;
    var phi_1199_: SlimbvhTypeA;
    var phi_1278_: array<vec4<f32>, 3>;
    var phi_1279_: array<vec4<f32>, 3>;
    var phi_1353_: array<vec4<f32>, 3>;
    var phi_1354_: array<vec4<f32>, 3>;
    var phi_1377_: array<f32, 3>;
    var phi_1378_: array<f32, 3>;
    var phi_1392_: array<f32, 3>;
    var phi_1393_: array<f32, 3>;
    var phi_1407_: array<f32, 3>;
    var phi_1408_: array<f32, 3>;
    var phi_1724_: f32;
    var phi_1725_: f32;
    var phi_1726_: f32;
    var phi_1727_: f32;
    var phi_1728_: vec3<f32>;
    var phi_1729_: vec3<f32>;
    var phi_1730_: vec3<f32>;
    var phi_1731_: vec3<f32>;
    var phi_1910_: f32;
    var phi_1936_: SlimbvhTypeJ;
    var phi_1937_: SlimbvhTypeJ;
    var phi_1940_: SlimbvhTypeJ;
    var phi_1941_: SlimbvhTypeJ;
    var phi_1942_: bool;
    var phi_1946_: SlimbvhTypeJ;
    var phi_1955_: SlimbvhTypeC;
    var phi_1980_: bool;
    var phi_1981_: bool;
    var phi_1988_: SlimbvhTypeI;
    var phi_1994_: SlimbvhTypeI;
    var phi_1995_: SlimbvhTypeI;
    var phi_1996_: SlimbvhTypeI;
    var phi_1174_: SlimbvhTypeI;
    var phi_2464_: bool;
    var local_5: u32;
    var local_6: SlimbvhTypeI;
    var phi_2021_: u32;
    var phi_2511_: bool;
    var phi_2028_: SlimbvhTypeI;
    var phi_2029_: u32;
    var phi_2030_: u32;
    var phi_2510_: bool;
    var phi_856_: SlimbvhTypeI;
    var phi_859_: u32;
    var phi_861_: u32;
    var phi_863_: u32;
    var phi_2509_: bool;
    var local_7: SlimbvhTypeI;
    var phi_2064_: f32;
    var phi_2066_: f32;
    var phi_2067_: bool;
    var phi_2068_: f32;
    var phi_2069_: bool;
    var phi_2332_: u32;
    var phi_2350_: bool;
    var phi_2353_: bool;
    var phi_2366_: f32;
    var phi_2367_: f32;
    var phi_2372_: f32;
    var phi_2373_: f32;
    var phi_2374_: bool;
    var phi_2382_: f32;
    var phi_2084_: f32;
    var phi_2085_: f32;
    var phi_2097_: f32;
    var phi_2102_: SlimbvhTypeC;
    var local_8: SlimbvhTypeI;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e70 = arrayLength((&slimbvh_nodes.member));
            let _e72 = arrayLength((&slimbvh_triangles.member));
            let _e77 = slimbvh_origin.member;
            let _e83 = slimbvh_origin.member[3u];
            let _e84 = slimbvh_direction.member;
            let _e90 = slimbvh_direction.member[3u];
            let _e93 = slimbvh_exponent.member[0u];
            let _e94 = bitcast<i32>(_e93);
            let _e96 = (bitcast<u32>(_e84.x) & 2147483647u);
            let _e98 = (bitcast<u32>(_e84.y) & 2147483647u);
            let _e100 = (bitcast<u32>(_e84.z) & 2147483647u);
            let _e102 = (bitcast<u32>(_e77.x) & 2147483647u);
            let _e104 = (bitcast<u32>(_e77.y) & 2147483647u);
            let _e106 = (bitcast<u32>(_e77.z) & 2147483647u);
            let _e108 = select(_e98, _e96, (_e98 < _e96));
            let _e110 = select(_e100, _e108, (_e100 < _e108));
            let _e112 = select(_e102, _e110, (_e102 < _e110));
            let _e114 = select(_e104, _e112, (_e104 < _e112));
            let _e116 = select(_e106, _e114, (_e106 < _e114));
            let _e117 = bitcast<u32>(_e83);
            let _e118 = (_e117 & 2147483647u);
            let _e122 = bitcast<u32>(_e90);
            let _e123 = (_e122 & 2147483647u);
            let _e127 = (((select(_e118, _e116, (_e118 < _e116)) < 2139095040u) && (_e123 <= 2139095040u)) && (_e110 > 0u));
            if _e127 {
                let _e130 = (bitcast<u32>(bitcast<f32>(_e110)) & 2147483647u);
                if (_e130 >= 8388608u) {
                    phi_250_ = (bitcast<i32>((_e130 >> bitcast<u32>(23i))) - 127i);
                } else {
                    phi_250_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e130)), 32u, (_e130 == 0u))));
                }
                let _e144 = phi_250_;
                phi_251_ = _e144;
            } else {
                phi_251_ = 0i;
            }
            let _e146 = phi_251_;
            let _e147 = (_e96 == _e110);
            if _e147 {
                phi_261_ = true;
            } else {
                phi_261_ = (_e98 == _e110);
            }
            let _e150 = phi_261_;
            let _e151 = select(1u, 0u, _e147);
            if _e150 {
                let _e152 = (_e151 + 1u);
                phi_271_ = _e152;
                phi_272_ = _e152;
                phi_274_ = select(true, false, (_e152 == 2u));
            } else {
                phi_271_ = u32();
                phi_272_ = 0u;
                phi_274_ = true;
            }
            let _e156 = phi_271_;
            let _e158 = phi_272_;
            let _e160 = phi_274_;
            if _e160 {
                phi_279_ = (_e158 + 1u);
            } else {
                phi_279_ = 0u;
            }
            let _e164 = phi_279_;
            let _e165 = select(_e156, _e158, _e160);
            let _e166 = select(_e151, select(2u, _e151, _e150), _e160);
            if (_e94 < -126i) {
                phi_292_ = -126i;
            } else {
                phi_292_ = select(_e94, 127i, (_e94 > 127i));
            }
            let _e171 = phi_292_;
            let _e176 = bitcast<f32>((bitcast<u32>((_e171 + 127i)) << bitcast<u32>(23i)));
            let _e182 = bitcast<f32>((bitcast<u32>(((_e94 - _e171) + 127i)) << bitcast<u32>(23i)));
            let _e183 = -(_e146);
            if (_e183 < -126i) {
                phi_312_ = -126i;
            } else {
                phi_312_ = select(_e183, 127i, (_e183 > 127i));
            }
            let _e188 = phi_312_;
            let _e193 = bitcast<f32>((bitcast<u32>((_e188 + 127i)) << bitcast<u32>(23i)));
            let _e199 = bitcast<f32>((bitcast<u32>(((_e183 - _e188) + 127i)) << bitcast<u32>(23i)));
            let _e200 = (_e165 == 0u);
            let _e202 = (_e165 == 2u);
            let _e203 = select(select(_e77.y, _e77.x, _e200), _e77.z, _e202);
            let _e204 = bitcast<u32>(_e203);
            let _e206 = ((_e204 & 2139095040u) != 0u);
            let _e220 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e204 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e204 & 2147483648u))), _e203, _e206) * _e176) * select(0.00000011920929f, 1f, _e206)) * _e182);
            let _e222 = select(select(_e84.y, _e84.x, _e200), _e84.z, _e202);
            let _e223 = bitcast<u32>(_e222);
            let _e225 = ((_e223 & 2139095040u) != 0u);
            let _e239 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e223 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e223 & 2147483648u))), _e222, _e225) * _e193) * select(0.00000011920929f, 1f, _e225)) * _e199);
            let _e243 = (bitcast<f32>((bitcast<u32>(_e239) & 2147483647u)) >= 0.00000000000000000086736174f);
            let _e246 = bitcast<f32>((bitcast<u32>(_e220) & 2147483647u));
            let _e247 = (_e246 * 0.00000011920929f);
            let _e250 = select(select(0.00000000000011368684f, _e247, (_e247 > 0.00000000000011368684f)), 0f, _e243);
            let _e251 = select(0f, _e239, _e243);
            let _e252 = (_e220 + _e250);
            let _e253 = (_e220 - _e250);
            let _e255 = select(38685626000000000000000000f, (1f / _e239), _e243);
            let _e256 = (_e164 == 0u);
            let _e258 = (_e164 == 2u);
            let _e259 = select(select(_e77.y, _e77.x, _e256), _e77.z, _e258);
            let _e260 = bitcast<u32>(_e259);
            let _e262 = ((_e260 & 2139095040u) != 0u);
            let _e276 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e260 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e260 & 2147483648u))), _e259, _e262) * _e176) * select(0.00000011920929f, 1f, _e262)) * _e182);
            let _e278 = select(select(_e84.y, _e84.x, _e256), _e84.z, _e258);
            let _e279 = bitcast<u32>(_e278);
            let _e281 = ((_e279 & 2139095040u) != 0u);
            let _e295 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e279 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e279 & 2147483648u))), _e278, _e281) * _e193) * select(0.00000011920929f, 1f, _e281)) * _e199);
            let _e299 = (bitcast<f32>((bitcast<u32>(_e295) & 2147483647u)) >= 0.00000000000000000086736174f);
            let _e302 = bitcast<f32>((bitcast<u32>(_e276) & 2147483647u));
            let _e303 = (_e302 * 0.00000011920929f);
            let _e306 = select(select(0.00000000000011368684f, _e303, (_e303 > 0.00000000000011368684f)), 0f, _e299);
            let _e307 = select(0f, _e295, _e299);
            let _e308 = (_e276 + _e306);
            let _e309 = (_e276 - _e306);
            let _e311 = select(38685626000000000000000000f, (1f / _e295), _e299);
            let _e312 = (_e166 == 0u);
            let _e314 = (_e166 == 2u);
            let _e315 = select(select(_e77.y, _e77.x, _e312), _e77.z, _e314);
            let _e316 = bitcast<u32>(_e315);
            let _e318 = ((_e316 & 2139095040u) != 0u);
            let _e332 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e316 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e316 & 2147483648u))), _e315, _e318) * _e176) * select(0.00000011920929f, 1f, _e318)) * _e182);
            let _e334 = select(select(_e84.y, _e84.x, _e312), _e84.z, _e314);
            let _e335 = bitcast<u32>(_e334);
            let _e337 = ((_e335 & 2139095040u) != 0u);
            let _e351 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e335 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e335 & 2147483648u))), _e334, _e337) * _e193) * select(0.00000011920929f, 1f, _e337)) * _e199);
            let _e355 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) >= 0.00000000000000000086736174f);
            let _e358 = bitcast<f32>((bitcast<u32>(_e332) & 2147483647u));
            let _e359 = (_e358 * 0.00000011920929f);
            let _e362 = select(select(0.00000000000011368684f, _e359, (_e359 > 0.00000000000011368684f)), 0f, _e355);
            let _e363 = select(0f, _e351, _e355);
            let _e364 = (_e332 + _e362);
            let _e365 = (_e332 - _e362);
            let _e367 = select(38685626000000000000000000f, (1f / _e351), _e355);
            let _e369 = select(_e302, _e246, (_e246 > _e302));
            let _e372 = (_e94 + _e146);
            if (_e127 && (select(_e358, _e369, (_e369 > _e358)) <= 1099511600000f)) {
                let _e382 = ((_e118 & 8388607u) | (select(0u, 1u, ((_e118 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e385 = bitcast<i32>((_e118 >> bitcast<u32>(23i)));
                let _e389 = (_e382 == 0u);
                let _e392 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e382)), 32u, _e389)) - 8i);
                if (_e385 == 255i) {
                    phi_737_ = 255i;
                } else {
                    phi_737_ = (((_e385 + select(0i, 1i, (_e385 == 0i))) - _e392) + _e372);
                }
                let _e400 = phi_737_;
                let _e410 = (_e400 <= 0i);
                if _e410 {
                    phi_760_ = u32();
                } else {
                    if _e389 {
                        phi_759_ = u32();
                    } else {
                        phi_759_ = select(((bitcast<u32>(_e400) << bitcast<u32>(23i)) | ((_e382 << bitcast<u32>(((_e392 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e400 >= 255i));
                    }
                    let _e414 = phi_759_;
                    phi_760_ = _e414;
                }
                let _e416 = phi_760_;
                let _e428 = ((_e123 & 8388607u) | (select(0u, 1u, ((_e123 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e431 = bitcast<i32>((_e123 >> bitcast<u32>(23i)));
                let _e435 = (_e428 == 0u);
                let _e438 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e428)), 32u, _e435)) - 8i);
                if (_e431 == 255i) {
                    phi_795_ = 255i;
                } else {
                    phi_795_ = (((_e431 + select(0i, 1i, (_e431 == 0i))) - _e438) + _e372);
                }
                let _e446 = phi_795_;
                let _e456 = (_e446 <= 0i);
                if _e456 {
                    phi_818_ = u32();
                } else {
                    if _e435 {
                        phi_817_ = u32();
                    } else {
                        phi_817_ = select(((bitcast<u32>(_e446) << bitcast<u32>(23i)) | ((_e428 << bitcast<u32>(((_e438 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e446 >= 255i));
                    }
                    let _e460 = phi_817_;
                    phi_818_ = _e460;
                }
                let _e462 = phi_818_;
                phi_826_ = bitcast<f32>(((_e122 & 2147483648u) | select(_e462, 0u, select(_e435, true, _e456))));
                phi_827_ = bitcast<f32>(((_e117 & 2147483648u) | select(_e416, 0u, select(_e389, true, _e410))));
            } else {
                phi_826_ = 0f;
                phi_827_ = 1f;
            }
            let _e468 = phi_826_;
            let _e470 = phi_827_;
            let _e471 = slimbvh_any_will_do.member;
            if (_e471 == 1u) {
                phi_841_ = SlimbvhTypeI(SlimbvhTypeH(SlimbvhTypeC(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e468), true);
            } else {
                phi_841_ = SlimbvhTypeI(SlimbvhTypeH(SlimbvhTypeC(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e468), false);
            }
            let _e478 = phi_841_;
            local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
            local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
            phi_2390_ = false;
            phi_855_ = _e478;
            phi_858_ = 0u;
            phi_860_ = select(4294967295u, 0u, (_e470 <= _e468));
            phi_862_ = (_e70 + 1u);
            loop {
                let _e486 = phi_2390_;
                let _e488 = phi_855_;
                let _e490 = phi_858_;
                let _e492 = phi_860_;
                let _e494 = phi_862_;
                local_7 = _e488;
                let _e495 = (_e492 <= 2147483647u);
                if _e495 {
                    phi_871_ = _e490;
                    phi_874_ = _e492;
                    phi_876_ = _e494;
                    loop {
                        let _e497 = phi_871_;
                        let _e499 = phi_874_;
                        let _e501 = phi_876_;
                        local_3 = _e497;
                        local_4 = _e497;
                        local_5 = _e499;
                        local_9 = _e497;
                        local_10 = _e499;
                        local_11 = _e501;
                        let _e502 = (_e499 <= 2147483647u);
                        let _e505 = (_e502 && !((_e497 >= _e70)));
                        local_2 = _e502;
                        if _e505 {
                            let _e506 = (_e497 < _e70);
                            if _e506 {
                            } else {
                                phi_2387_ = true;
                                break;
                            }
                            let _e511 = slimbvh_nodes.member[_e497][3u][0u];
                            let _e516 = slimbvh_nodes.member[_e497][3u][1u];
                            if _e506 {
                            } else {
                                phi_2387_ = true;
                                break;
                            }
                            let _e517 = ((_e165 & 3u) % 4u);
                            if (_e517 < 4u) {
                            } else {
                                phi_2387_ = true;
                                break;
                            }
                            let _e522 = slimbvh_nodes.member[_e497][_e517];
                            if _e506 {
                            } else {
                                phi_2387_ = true;
                                break;
                            }
                            let _e523 = ((_e164 & 3u) % 4u);
                            if (_e523 < 4u) {
                            } else {
                                phi_2387_ = true;
                                break;
                            }
                            let _e528 = slimbvh_nodes.member[_e497][_e523];
                            if _e506 {
                            } else {
                                phi_2387_ = true;
                                break;
                            }
                            let _e529 = ((_e166 & 3u) % 4u);
                            if (_e529 < 4u) {
                            } else {
                                phi_2387_ = true;
                                break;
                            }
                            let _e534 = slimbvh_nodes.member[_e497][_e529];
                            let _e535 = bitcast<u32>(_e511);
                            let _e536 = bitcast<u32>(_e516);
                            let _e547 = ((_e522.x - _e252) * _e255);
                            let _e548 = ((_e522.y - _e252) * _e255);
                            let _e549 = ((_e522.z - _e253) * _e255);
                            let _e550 = ((_e522.w - _e253) * _e255);
                            let _e559 = ((_e528.x - _e308) * _e311);
                            let _e560 = ((_e528.y - _e308) * _e311);
                            let _e561 = ((_e528.z - _e309) * _e311);
                            let _e562 = ((_e528.w - _e309) * _e311);
                            let _e571 = ((_e534.x - _e364) * _e367);
                            let _e572 = ((_e534.y - _e364) * _e367);
                            let _e573 = ((_e534.z - _e365) * _e367);
                            let _e574 = ((_e534.w - _e365) * _e367);
                            let _e575 = min(_e571, _e573);
                            let _e576 = min(_e572, _e574);
                            let _e577 = max(_e571, _e573);
                            let _e578 = max(_e572, _e574);
                            let _e603 = max(max(max(min(_e547, _e549), min(_e559, _e561)), _e575), _e470);
                            let _e604 = max(max(max(min(_e548, _e550), min(_e560, _e562)), _e576), _e470);
                            let _e607 = (_e603 <= min((min(min(max(_e547, _e549), max(_e559, _e561)), _e577) + (max(_e577, -(_e575)) * 0.0000019073523f)), _e488.member.member_1));
                            let _e608 = (_e604 <= min((min(min(max(_e548, _e550), max(_e560, _e562)), _e578) + (max(_e578, -(_e576)) * 0.0000019073523f)), _e488.member.member_1));
                            if (_e607 || _e608) {
                                let _e623 = (_e607 && ((_e603 <= _e604) || !(_e608)));
                                if (_e607 && _e608) {
                                    let _e628 = (_e499 % 128u);
                                    let _e629 = (_e628 < 128u);
                                    if _e629 {
                                    } else {
                                        phi_2387_ = true;
                                        break;
                                    }
                                    local_1[_e628] = select(_e535, _e536, _e623);
                                    if _e629 {
                                    } else {
                                        phi_2387_ = true;
                                        break;
                                    }
                                    local[_e628] = select(_e603, _e604, _e623);
                                    phi_1130_ = (_e499 + 1u);
                                } else {
                                    phi_1130_ = _e499;
                                }
                                let _e634 = phi_1130_;
                                phi_1156_ = select(_e536, _e535, _e623);
                                phi_1157_ = _e634;
                            } else {
                                let _e611 = (_e499 - 1u);
                                let _e612 = (_e611 % 128u);
                                let _e613 = (_e612 < 128u);
                                if _e613 {
                                } else {
                                    phi_2387_ = true;
                                    break;
                                }
                                let _e615 = local[_e612];
                                if (_e615 <= _e488.member.member_1) {
                                    if _e613 {
                                    } else {
                                        phi_2387_ = true;
                                        break;
                                    }
                                    let _e618 = local_1[_e612];
                                    phi_1155_ = _e618;
                                } else {
                                    phi_1155_ = 2147483648u;
                                }
                                let _e620 = phi_1155_;
                                phi_1156_ = _e620;
                                phi_1157_ = _e611;
                            }
                            let _e636 = phi_1156_;
                            let _e638 = phi_1157_;
                            let _e639 = (_e501 - 1u);
                            phi_872_ = _e636;
                            phi_875_ = select(_e638, 4294967295u, (_e639 == 0u));
                            phi_877_ = _e639;
                        } else {
                            phi_872_ = u32();
                            phi_875_ = u32();
                            phi_877_ = u32();
                        }
                        let _e643 = phi_872_;
                        let _e645 = phi_875_;
                        let _e647 = phi_877_;
                        continue;
                        continuing {
                            phi_871_ = _e643;
                            phi_874_ = _e645;
                            phi_876_ = _e647;
                            phi_2387_ = _e486;
                            break if !(_e505);
                        }
                    }
                    let _e650 = phi_2387_;
                    phi_2509_ = _e650;
                    if _e650 {
                        break;
                    }
                    let _e652 = local_2;
                    if _e652 {
                        let _e654 = local_3;
                        let _e657 = local_4;
                        phi_1173_ = _e488;
                        phi_1176_ = SlimbvhTypeA(0u, ((_e657 >> bitcast<u32>(28u)) & 7u));
                        loop {
                            let _e663 = phi_1173_;
                            let _e665 = phi_1176_;
                            local_6 = _e663;
                            local_8 = _e663;
                            if (_e665.member < _e665.member_1) {
                                phi_1177_ = SlimbvhTypeA((_e665.member + 1u), _e665.member_1);
                                phi_1199_ = SlimbvhTypeA(1u, _e665.member);
                            } else {
                                phi_1177_ = _e665;
                                phi_1199_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                            }
                            let _e678 = phi_1177_;
                            let _e680 = phi_1199_;
                            let _e684 = (bitcast<i32>(_e680.member) != 0i);
                            if _e684 {
                                let _e685 = ((_e654 & 268435455u) + _e680.member_1);
                                let _e686 = (_e685 / 2u);
                                let _e687 = (_e685 % 2u);
                                let _e688 = (_e686 >= _e72);
                                if _e688 {
                                    phi_1279_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                                } else {
                                    let _e689 = (_e686 < _e72);
                                    if _e689 {
                                    } else {
                                        phi_2464_ = true;
                                        break;
                                    }
                                    let _e690 = (2u * _e687);
                                    if (_e690 < 5u) {
                                    } else {
                                        phi_2464_ = true;
                                        break;
                                    }
                                    let _e695 = slimbvh_triangles.member[_e686][_e690];
                                    if _e689 {
                                    } else {
                                        phi_2464_ = true;
                                        break;
                                    }
                                    let _e696 = (_e690 + 1u);
                                    if (_e696 < 5u) {
                                    } else {
                                        phi_2464_ = true;
                                        break;
                                    }
                                    let _e701 = slimbvh_triangles.member[_e686][_e696];
                                    if _e689 {
                                    } else {
                                        phi_2464_ = true;
                                        break;
                                    }
                                    let _e702 = (_e690 + 2u);
                                    if (_e702 < 5u) {
                                    } else {
                                        phi_2464_ = true;
                                        break;
                                    }
                                    let _e707 = slimbvh_triangles.member[_e686][_e702];
                                    if (_e687 == 0u) {
                                        phi_1278_ = array<vec4<f32>, 3>(_e695, _e701, _e707);
                                    } else {
                                        phi_1278_ = array<vec4<f32>, 3>(vec4<f32>(_e695.z, _e695.w, _e701.x, _e701.y), vec4<f32>(_e701.z, _e701.w, _e707.x, _e707.y), vec4<f32>(_e707.z, _e707.w, 0f, 0f));
                                    }
                                    let _e725 = phi_1278_;
                                    phi_1279_ = _e725;
                                }
                                let _e727 = phi_1279_;
                                let _e730 = bitcast<u32>(_e727[2].y);
                                if _e688 {
                                    phi_1354_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                                } else {
                                    let _e731 = (_e686 < _e72);
                                    if _e731 {
                                    } else {
                                        phi_2464_ = true;
                                        break;
                                    }
                                    let _e732 = (2u * _e687);
                                    if (_e732 < 5u) {
                                    } else {
                                        phi_2464_ = true;
                                        break;
                                    }
                                    let _e737 = slimbvh_triangles.member[_e686][_e732];
                                    if _e731 {
                                    } else {
                                        phi_2464_ = true;
                                        break;
                                    }
                                    let _e738 = (_e732 + 1u);
                                    if (_e738 < 5u) {
                                    } else {
                                        phi_2464_ = true;
                                        break;
                                    }
                                    let _e743 = slimbvh_triangles.member[_e686][_e738];
                                    if _e731 {
                                    } else {
                                        phi_2464_ = true;
                                        break;
                                    }
                                    let _e744 = (_e732 + 2u);
                                    if (_e744 < 5u) {
                                    } else {
                                        phi_2464_ = true;
                                        break;
                                    }
                                    let _e749 = slimbvh_triangles.member[_e686][_e744];
                                    if (_e687 == 0u) {
                                        phi_1353_ = array<vec4<f32>, 3>(_e737, _e743, _e749);
                                    } else {
                                        phi_1353_ = array<vec4<f32>, 3>(vec4<f32>(_e737.z, _e737.w, _e743.x, _e743.y), vec4<f32>(_e743.z, _e743.w, _e749.x, _e749.y), vec4<f32>(_e749.z, _e749.w, 0f, 0f));
                                    }
                                    let _e767 = phi_1353_;
                                    phi_1354_ = _e767;
                                }
                                let _e769 = phi_1354_;
                                if _e200 {
                                    phi_1378_ = array<f32, 3>(_e769[0].x, _e769[0].y, _e769[0].z);
                                } else {
                                    if (_e165 == 1u) {
                                        phi_1377_ = array<f32, 3>(_e769[0].y, _e769[0].z, _e769[0].x);
                                    } else {
                                        phi_1377_ = array<f32, 3>(_e769[0].z, _e769[0].x, _e769[0].y);
                                    }
                                    let _e792 = phi_1377_;
                                    phi_1378_ = _e792;
                                }
                                let _e795 = phi_1378_;
                                if _e200 {
                                    phi_1393_ = array<f32, 3>(_e769[0].w, _e769[1].x, _e769[1].y);
                                } else {
                                    if (_e165 == 1u) {
                                        phi_1392_ = array<f32, 3>(_e769[1].x, _e769[1].y, _e769[0].w);
                                    } else {
                                        phi_1392_ = array<f32, 3>(_e769[1].y, _e769[0].w, _e769[1].x);
                                    }
                                    let _e800 = phi_1392_;
                                    phi_1393_ = _e800;
                                }
                                let _e803 = phi_1393_;
                                if _e200 {
                                    phi_1408_ = array<f32, 3>(_e769[1].z, _e769[1].w, _e769[2].x);
                                } else {
                                    if (_e165 == 1u) {
                                        phi_1407_ = array<f32, 3>(_e769[1].w, _e769[2].x, _e769[1].z);
                                    } else {
                                        phi_1407_ = array<f32, 3>(_e769[2].x, _e769[1].z, _e769[1].w);
                                    }
                                    let _e808 = phi_1407_;
                                    phi_1408_ = _e808;
                                }
                                let _e811 = phi_1408_;
                                let _e825 = (_e795[2] - _e332);
                                let _e828 = (((_e795[0] - _e220) * _e363) - (_e825 * _e251));
                                let _e831 = (((_e795[1] - _e276) * _e363) - (_e825 * _e307));
                                let _e834 = (_e803[2] - _e332);
                                let _e837 = (((_e803[0] - _e220) * _e363) - (_e834 * _e251));
                                let _e840 = (((_e803[1] - _e276) * _e363) - (_e834 * _e307));
                                let _e843 = (_e811[2] - _e332);
                                let _e846 = (((_e811[0] - _e220) * _e363) - (_e843 * _e251));
                                let _e849 = (((_e811[1] - _e276) * _e363) - (_e843 * _e307));
                                let _e850 = (_e846 * _e840);
                                let _e851 = (_e849 * _e837);
                                let _e852 = (_e828 * _e849);
                                let _e853 = (_e831 * _e846);
                                let _e854 = (_e837 * _e831);
                                let _e855 = (_e840 * _e828);
                                let _e860 = (((_e850 >= _e851) && (_e852 >= _e853)) && (_e854 >= _e855));
                                let _e866 = (_e860 || (((_e850 <= _e851) && (_e852 <= _e853)) && (_e854 <= _e855)));
                                if _e866 {
                                    let _e868 = select(-1f, 1f, _e860);
                                    let _e870 = ((_e850 - _e851) * _e868);
                                    let _e872 = select(0f, _e870, (_e870 > 0f));
                                    let _e874 = ((_e852 - _e853) * _e868);
                                    let _e876 = select(0f, _e874, (_e874 > 0f));
                                    let _e878 = ((_e854 - _e855) * _e868);
                                    let _e880 = select(0f, _e878, (_e878 > 0f));
                                    let _e882 = ((_e872 + _e876) + _e880);
                                    let _e897 = ((min(min(_e795[0], _e803[0]), _e811[0]) - _e252) * _e255);
                                    let _e898 = ((max(max(_e795[0], _e803[0]), _e811[0]) - _e253) * _e255);
                                    let _e901 = ((min(min(_e795[1], _e803[1]), _e811[1]) - _e308) * _e311);
                                    let _e902 = ((max(max(_e795[1], _e803[1]), _e811[1]) - _e309) * _e311);
                                    let _e905 = ((min(min(_e795[2], _e803[2]), _e811[2]) - _e364) * _e367);
                                    let _e906 = ((max(max(_e795[2], _e803[2]), _e811[2]) - _e365) * _e367);
                                    let _e907 = min(_e905, _e906);
                                    let _e908 = max(_e905, _e906);
                                    let _e912 = max(max(min(_e897, _e898), min(_e901, _e902)), _e907);
                                    let _e916 = min(min(max(_e897, _e898), max(_e901, _e902)), _e908);
                                    let _e921 = max(_e912, _e470);
                                    let _e943 = (((((_e866 && (_e882 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e828, _e837), _e846) <= 0f) && (max(max(_e828, _e837), _e846) >= 0f))) && ((min(min(_e831, _e840), _e849) <= 0f) && (max(max(_e831, _e840), _e849) >= 0f))) && (_e921 <= (_e916 + (max(_e908, -(_e907)) * 0.0000019073523f)))) && (_e921 <= _e663.member.member_1));
                                    if _e943 {
                                        let _e948 = (_e803[0] - _e795[0]);
                                        let _e949 = (_e803[1] - _e795[1]);
                                        let _e950 = (_e803[2] - _e795[2]);
                                        let _e951 = vec3<f32>(_e948, _e949, _e950);
                                        let _e952 = (_e811[0] - _e803[0]);
                                        let _e953 = (_e811[1] - _e803[1]);
                                        let _e954 = (_e811[2] - _e803[2]);
                                        let _e955 = vec3<f32>(_e952, _e953, _e954);
                                        let _e956 = (_e795[0] - _e811[0]);
                                        let _e957 = (_e795[1] - _e811[1]);
                                        let _e958 = (_e795[2] - _e811[2]);
                                        let _e959 = vec3<f32>(_e956, _e957, _e958);
                                        let _e970 = max(max(bitcast<f32>((bitcast<u32>(_e948) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e949) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e950) & 2147483647u)));
                                        let _e981 = max(max(bitcast<f32>((bitcast<u32>(_e952) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e953) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e954) & 2147483647u)));
                                        let _e994 = max(max(_e970, _e981), max(max(bitcast<f32>((bitcast<u32>(_e956) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e957) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e958) & 2147483647u))));
                                        if (_e970 == _e994) {
                                            phi_1724_ = _e840;
                                            phi_1725_ = _e837;
                                            phi_1726_ = _e831;
                                            phi_1727_ = _e828;
                                            phi_1728_ = vec3<f32>(_e795[0], _e795[1], _e795[2]);
                                            phi_1729_ = _e959;
                                            phi_1730_ = _e955;
                                            phi_1731_ = _e951;
                                        } else {
                                            let _e996 = (_e981 == _e994);
                                            let _e1001 = vec3(_e996);
                                            phi_1724_ = select(_e831, _e849, _e996);
                                            phi_1725_ = select(_e828, _e846, _e996);
                                            phi_1726_ = select(_e849, _e840, _e996);
                                            phi_1727_ = select(_e846, _e837, _e996);
                                            phi_1728_ = select(vec3<f32>(_e811[0], _e811[1], _e811[2]), vec3<f32>(_e803[0], _e803[1], _e803[2]), _e1001);
                                            phi_1729_ = select(_e955, _e951, _e1001);
                                            phi_1730_ = select(_e951, _e959, _e1001);
                                            phi_1731_ = select(_e959, _e955, _e1001);
                                        }
                                        let _e1007 = phi_1724_;
                                        let _e1009 = phi_1725_;
                                        let _e1011 = phi_1726_;
                                        let _e1013 = phi_1727_;
                                        let _e1015 = phi_1728_;
                                        let _e1017 = phi_1729_;
                                        let _e1019 = phi_1730_;
                                        let _e1021 = phi_1731_;
                                        let _e1028 = ((_e1019.y * _e1017.z) - (_e1017.y * _e1019.z));
                                        let _e1033 = ((_e1019.z * _e1017.x) - (_e1017.z * _e1019.x));
                                        let _e1036 = ((_e1019.x * _e1017.y) - (_e1017.x * _e1019.y));
                                        let _e1039 = ((_e872 >= _e876) && (_e872 >= _e880));
                                        let _e1040 = (_e876 >= _e880);
                                        let _e1054 = (((_e1028 * (select(select(_e811[0], _e803[0], _e1040), _e795[0], _e1039) - _e220)) + (_e1033 * (select(select(_e811[1], _e803[1], _e1040), _e795[1], _e1039) - _e276))) + (_e1036 * (select(select(_e811[2], _e803[2], _e1040), _e795[2], _e1039) - _e332)));
                                        let _e1059 = (((_e1028 * _e251) + (_e1033 * _e307)) + (_e1036 * _e363));
                                        let _e1060 = (_e1009 - _e1013);
                                        let _e1061 = (_e1007 - _e1011);
                                        let _e1064 = ((_e1060 * _e1060) + (_e1061 * _e1061));
                                        let _e1071 = (-(((_e1013 * _e1060) + (_e1011 * _e1061))) / select(0.000000000000000000000000000000000000011754944f, _e1064, (_e1064 > 0.000000000000000000000000000000000000011754944f)));
                                        let _e1073 = select(1f, _e1071, (_e1071 < 1f));
                                        let _e1075 = select(0f, _e1073, (_e1073 > 0f));
                                        let _e1084 = ((_e1015.x + (_e1021.x * _e1075)) - _e220);
                                        let _e1087 = ((_e1015.y + (_e1021.y * _e1075)) - _e276);
                                        let _e1090 = ((_e1015.z + (_e1021.z * _e1075)) - _e332);
                                        let _e1155 = ((bitcast<f32>((bitcast<u32>(((((_e1028 * _e1084) + (_e1033 * _e1087)) + (_e1036 * _e1090)) - _e1054)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1084) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1087) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1090) & 2147483647u))), _e994)) * max(max(bitcast<f32>((bitcast<u32>(_e1028) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1033) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1036) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1059) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1019.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1019.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1019.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1017.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1017.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1017.z) & 2147483647u)))))));
                                        let _e1156 = (_e1054 / _e1059);
                                        if (_e943 && !(_e1155)) {
                                            let _e1159 = (_e1090 / _e363);
                                            let _e1167 = (((_e1028 * (_e1084 - (_e251 * _e1159))) + (_e1033 * (_e1087 - (_e307 * _e1159)))) / _e1059);
                                            phi_1910_ = select(select(_e1159, (_e1159 + _e1167), (bitcast<f32>((bitcast<u32>(_e1167) & 2147483647u)) <= _e994)), _e1156, _e1155);
                                        } else {
                                            phi_1910_ = _e1156;
                                        }
                                        let _e1176 = phi_1910_;
                                        let _e1178 = select(_e916, _e1176, (_e1176 < _e916));
                                        let _e1180 = select(_e912, _e1178, (_e1178 > _e912));
                                        let _e1183 = select(_e1180, 0f, (bitcast<u32>(_e1180) == 2147483648u));
                                        let _e1184 = (1f / _e882);
                                        phi_1936_ = SlimbvhTypeJ(_e1183, (_e876 * _e1184), (_e880 * _e1184), ((_e943 && (_e1183 >= _e470)) && (_e1183 <= _e663.member.member_1)));
                                        phi_1937_ = SlimbvhTypeJ();
                                    } else {
                                        phi_1936_ = SlimbvhTypeJ();
                                        phi_1937_ = SlimbvhTypeJ(0f, 0f, 0f, _e943);
                                    }
                                    let _e1193 = phi_1936_;
                                    let _e1195 = phi_1937_;
                                    phi_1940_ = _e1193;
                                    phi_1941_ = _e1195;
                                    phi_1942_ = select(true, false, _e943);
                                } else {
                                    phi_1940_ = SlimbvhTypeJ();
                                    phi_1941_ = SlimbvhTypeJ(0f, 0f, 0f, _e866);
                                    phi_1942_ = true;
                                }
                                let _e1198 = phi_1940_;
                                let _e1200 = phi_1941_;
                                let _e1202 = phi_1942_;
                                if _e1202 {
                                    phi_1946_ = _e1200;
                                } else {
                                    phi_1946_ = _e1198;
                                }
                                let _e1204 = phi_1946_;
                                if _e1204.member_3 {
                                    phi_1955_ = SlimbvhTypeC(_e1204.member, _e1204.member_1, _e1204.member_2, _e730);
                                } else {
                                    phi_1955_ = SlimbvhTypeC(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                }
                                let _e1211 = phi_1955_;
                                if (_e1211.member_3 != 4294967295u) {
                                    if (_e730 != 4294967295u) {
                                        if (_e1211.member < _e663.member.member.member) {
                                            phi_1981_ = true;
                                        } else {
                                            if (_e1211.member == _e663.member.member.member) {
                                                phi_1980_ = (_e1211.member_3 < _e663.member.member.member_3);
                                            } else {
                                                phi_1980_ = false;
                                            }
                                            let _e1226 = phi_1980_;
                                            phi_1981_ = _e1226;
                                        }
                                        let _e1228 = phi_1981_;
                                        if _e1228 {
                                            phi_1988_ = SlimbvhTypeI(SlimbvhTypeH(_e1211, _e1211.member), _e663.member_1);
                                        } else {
                                            phi_1988_ = _e663;
                                        }
                                        let _e1234 = phi_1988_;
                                        if _e1234.member_1 {
                                            phi_1994_ = SlimbvhTypeI(SlimbvhTypeH(_e1234.member.member, -340282350000000000000000000000000000000f), _e1234.member_1);
                                        } else {
                                            phi_1994_ = _e1234;
                                        }
                                        let _e1243 = phi_1994_;
                                        phi_1995_ = _e1243;
                                    } else {
                                        phi_1995_ = _e663;
                                    }
                                    let _e1245 = phi_1995_;
                                    phi_1996_ = _e1245;
                                } else {
                                    phi_1996_ = _e663;
                                }
                                let _e1247 = phi_1996_;
                                phi_1174_ = _e1247;
                            } else {
                                phi_1174_ = SlimbvhTypeI();
                            }
                            let _e1249 = phi_1174_;
                            continue;
                            continuing {
                                phi_1173_ = _e1249;
                                phi_1176_ = _e678;
                                phi_2464_ = _e650;
                                break if !(_e684);
                            }
                        }
                        let _e1252 = phi_2464_;
                        phi_2509_ = _e1252;
                        if _e1252 {
                            break;
                        }
                        let _e1254 = local_5;
                        let _e1255 = (_e1254 - 1u);
                        let _e1256 = (_e1255 % 128u);
                        let _e1257 = (_e1256 < 128u);
                        if _e1257 {
                        } else {
                            phi_2509_ = true;
                            break;
                        }
                        let _e1259 = local[_e1256];
                        let _e1261 = local_6;
                        if (_e1259 <= _e1261.member.member_1) {
                            if _e1257 {
                            } else {
                                phi_2509_ = true;
                                break;
                            }
                            let _e1266 = local_1[_e1256];
                            phi_2021_ = _e1266;
                        } else {
                            phi_2021_ = 2147483648u;
                        }
                        let _e1268 = phi_2021_;
                        phi_2511_ = _e1252;
                        let _e1507 = local_8;
                        phi_2028_ = _e1507;
                        phi_2029_ = _e1268;
                        phi_2030_ = select(_e1255, 4294967295u, (_e470 > _e1261.member.member_1));
                    } else {
                        phi_2511_ = _e650;
                        phi_2028_ = _e488;
                        let _e1510 = local_9;
                        phi_2029_ = _e1510;
                        let _e1513 = local_10;
                        phi_2030_ = _e1513;
                    }
                    let _e1272 = phi_2511_;
                    let _e1274 = phi_2028_;
                    let _e1276 = phi_2029_;
                    let _e1278 = phi_2030_;
                    phi_2510_ = _e1272;
                    phi_856_ = _e1274;
                    phi_859_ = _e1276;
                    phi_861_ = _e1278;
                    let _e1520 = local_11;
                    phi_863_ = _e1520;
                } else {
                    phi_2510_ = _e486;
                    phi_856_ = SlimbvhTypeI();
                    phi_859_ = u32();
                    phi_861_ = u32();
                    phi_863_ = u32();
                }
                let _e1280 = phi_2510_;
                let _e1282 = phi_856_;
                let _e1284 = phi_859_;
                let _e1286 = phi_861_;
                let _e1288 = phi_863_;
                continue;
                continuing {
                    phi_2390_ = _e1280;
                    phi_855_ = _e1282;
                    phi_858_ = _e1284;
                    phi_860_ = _e1286;
                    phi_862_ = _e1288;
                    phi_2509_ = _e1280;
                    break if !(_e495);
                }
            }
            let _e1291 = phi_2509_;
            if _e1291 {
                break;
            }
            let _e1293 = local_7;
            if (_e1293.member.member.member_3 != 4294967295u) {
                let _e1299 = -(_e372);
                let _e1300 = bitcast<u32>(_e1293.member.member.member);
                let _e1304 = (bitcast<i32>((_e1300 >> bitcast<u32>(23i))) & 255i);
                let _e1305 = (_e1304 + _e1299);
                if (_e1304 == 255i) {
                    phi_2085_ = _e1293.member.member.member;
                } else {
                    if (_e1304 > 0i) {
                        if (_e1305 > 0i) {
                            let _e1309 = (_e1305 < 255i);
                            if _e1309 {
                                phi_2064_ = bitcast<f32>((_e1300 + bitcast<u32>((_e1299 << bitcast<u32>(23i)))));
                            } else {
                                phi_2064_ = f32();
                            }
                            let _e1316 = phi_2064_;
                            phi_2066_ = _e1316;
                            phi_2067_ = select(true, false, _e1309);
                        } else {
                            phi_2066_ = f32();
                            phi_2067_ = true;
                        }
                        let _e1319 = phi_2066_;
                        let _e1321 = phi_2067_;
                        phi_2068_ = _e1319;
                        phi_2069_ = _e1321;
                    } else {
                        phi_2068_ = f32();
                        phi_2069_ = true;
                    }
                    let _e1323 = phi_2068_;
                    let _e1325 = phi_2069_;
                    if _e1325 {
                        let _e1326 = (_e1300 & 2147483648u);
                        let _e1333 = ((_e1300 & 8388607u) | (select(0u, 1u, ((_e1300 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e1337 = (_e1333 == 0u);
                        if _e1337 {
                            phi_2382_ = bitcast<f32>(_e1326);
                        } else {
                            let _e1342 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1333)), 32u, _e1337) - 8u);
                            let _e1345 = (_e1333 << bitcast<u32>((_e1342 & 31u)));
                            let _e1347 = ((_e1305 + select(0i, 1i, (_e1304 == 0i))) - bitcast<i32>(_e1342));
                            if (_e1347 >= 255i) {
                                phi_2372_ = bitcast<f32>((_e1326 | 2139095040u));
                                phi_2373_ = f32();
                                phi_2374_ = true;
                            } else {
                                let _e1349 = (_e1347 > 0i);
                                if _e1349 {
                                    phi_2366_ = bitcast<f32>(((_e1326 | (bitcast<u32>(_e1347) << bitcast<u32>(23i))) | (_e1345 & 8388607u)));
                                    phi_2367_ = f32();
                                } else {
                                    if (_e1347 < -24i) {
                                        phi_2332_ = 26u;
                                    } else {
                                        phi_2332_ = bitcast<u32>((1i - _e1347));
                                    }
                                    let _e1354 = phi_2332_;
                                    let _e1355 = (_e1354 & 31u);
                                    let _e1357 = (_e1345 >> bitcast<u32>(_e1355));
                                    let _e1361 = (_e1345 & ((1u << bitcast<u32>(_e1355)) - 1u));
                                    let _e1365 = (1u << bitcast<u32>(((_e1354 - 1u) & 31u)));
                                    if (_e1361 > _e1365) {
                                        phi_2353_ = true;
                                    } else {
                                        if (_e1361 == _e1365) {
                                            phi_2350_ = ((_e1357 & 1u) == 1u);
                                        } else {
                                            phi_2350_ = false;
                                        }
                                        let _e1371 = phi_2350_;
                                        phi_2353_ = _e1371;
                                    }
                                    let _e1373 = phi_2353_;
                                    phi_2366_ = f32();
                                    phi_2367_ = bitcast<f32>((_e1326 | (_e1357 + select(0u, 1u, _e1373))));
                                }
                                let _e1386 = phi_2366_;
                                let _e1388 = phi_2367_;
                                phi_2372_ = _e1386;
                                phi_2373_ = _e1388;
                                phi_2374_ = _e1349;
                            }
                            let _e1392 = phi_2372_;
                            let _e1394 = phi_2373_;
                            let _e1396 = phi_2374_;
                            phi_2382_ = select(_e1394, _e1392, _e1396);
                        }
                        let _e1400 = phi_2382_;
                        phi_2084_ = _e1400;
                    } else {
                        phi_2084_ = _e1323;
                    }
                    let _e1402 = phi_2084_;
                    phi_2085_ = _e1402;
                }
                let _e1404 = phi_2085_;
                let _e1405 = bitcast<u32>(_e1404);
                if ((_e1405 & 2147483647u) >= 2139095040u) {
                    phi_2097_ = bitcast<f32>(((_e1405 & 2147483648u) | 2139095039u));
                } else {
                    phi_2097_ = _e1404;
                }
                let _e1412 = phi_2097_;
                phi_2102_ = SlimbvhTypeC(_e1412, _e1293.member.member.member_1, _e1293.member.member.member_2, _e1293.member.member.member_3);
            } else {
                phi_2102_ = SlimbvhTypeC(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
            }
            let _e1417 = phi_2102_;
            slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1417.member), bitcast<u32>(_e1417.member_1), bitcast<u32>(_e1417.member_2), _e1417.member_3);
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
