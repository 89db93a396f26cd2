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
    var phi_847_: u32;
    var phi_2407_: bool;
    var phi_865_: SlimbvhTypeI;
    var phi_868_: u32;
    var phi_870_: u32;
    var phi_872_: u32;
    var phi_881_: u32;
    var phi_884_: u32;
    var phi_886_: u32;
    var phi_1172_: u32;
    var phi_1147_: u32;
    var phi_1173_: u32;
    var phi_1174_: u32;
    var phi_882_: u32;
    var phi_885_: u32;
    var phi_887_: u32;
    var phi_2404_: bool;
    var local_2: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1190_: SlimbvhTypeI;
    var phi_1193_: SlimbvhTypeA;
    var phi_1194_: SlimbvhTypeA;
    var phi_1216_: SlimbvhTypeA;
    var phi_1296_: array<vec4<f32>, 3>;
    var phi_1371_: array<vec4<f32>, 3>;
    var phi_1394_: array<f32, 3>;
    var phi_1395_: array<f32, 3>;
    var phi_1409_: array<f32, 3>;
    var phi_1410_: array<f32, 3>;
    var phi_1424_: array<f32, 3>;
    var phi_1425_: array<f32, 3>;
    var phi_1741_: f32;
    var phi_1742_: f32;
    var phi_1743_: f32;
    var phi_1744_: f32;
    var phi_1745_: vec3<f32>;
    var phi_1746_: vec3<f32>;
    var phi_1747_: vec3<f32>;
    var phi_1748_: vec3<f32>;
    var phi_1927_: f32;
    var phi_1953_: SlimbvhTypeJ;
    var phi_1954_: SlimbvhTypeJ;
    var phi_1957_: SlimbvhTypeJ;
    var phi_1958_: SlimbvhTypeJ;
    var phi_1959_: bool;
    var phi_1963_: SlimbvhTypeJ;
    var phi_1972_: SlimbvhTypeC;
    var phi_1997_: bool;
    var phi_1998_: bool;
    var phi_2005_: SlimbvhTypeI;
    var phi_2011_: SlimbvhTypeI;
    var phi_2012_: SlimbvhTypeI;
    var phi_2013_: SlimbvhTypeI;
    var phi_1191_: SlimbvhTypeI;
    var phi_2483_: bool;
    var local_5: u32;
    var local_6: SlimbvhTypeI;
    var phi_2038_: u32;
    var phi_2530_: bool;
    var phi_2045_: SlimbvhTypeI;
    var phi_2046_: u32;
    var phi_2047_: u32;
    var phi_2529_: bool;
    var phi_866_: SlimbvhTypeI;
    var phi_869_: u32;
    var phi_871_: u32;
    var phi_873_: u32;
    var phi_2528_: bool;
    var local_7: SlimbvhTypeI;
    var phi_2081_: f32;
    var phi_2083_: f32;
    var phi_2084_: bool;
    var phi_2085_: f32;
    var phi_2086_: bool;
    var phi_2349_: u32;
    var phi_2367_: bool;
    var phi_2370_: bool;
    var phi_2383_: f32;
    var phi_2384_: f32;
    var phi_2389_: f32;
    var phi_2390_: f32;
    var phi_2391_: bool;
    var phi_2399_: f32;
    var phi_2101_: f32;
    var phi_2102_: f32;
    var phi_2114_: f32;
    var phi_2119_: SlimbvhTypeC;
    var local_8: SlimbvhTypeI;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e68 = arrayLength((&slimbvh_nodes.member));
            let _e70 = arrayLength((&slimbvh_triangles.member));
            let _e75 = slimbvh_origin.member;
            let _e81 = slimbvh_origin.member[3u];
            let _e82 = slimbvh_direction.member;
            let _e88 = slimbvh_direction.member[3u];
            let _e91 = slimbvh_exponent.member[0u];
            let _e92 = bitcast<i32>(_e91);
            let _e94 = (bitcast<u32>(_e82.x) & 2147483647u);
            let _e96 = (bitcast<u32>(_e82.y) & 2147483647u);
            let _e98 = (bitcast<u32>(_e82.z) & 2147483647u);
            let _e100 = (bitcast<u32>(_e75.x) & 2147483647u);
            let _e102 = (bitcast<u32>(_e75.y) & 2147483647u);
            let _e104 = (bitcast<u32>(_e75.z) & 2147483647u);
            let _e106 = select(_e96, _e94, (_e96 < _e94));
            let _e108 = select(_e98, _e106, (_e98 < _e106));
            let _e110 = select(_e100, _e108, (_e100 < _e108));
            let _e112 = select(_e102, _e110, (_e102 < _e110));
            let _e114 = select(_e104, _e112, (_e104 < _e112));
            let _e115 = bitcast<u32>(_e81);
            let _e116 = (_e115 & 2147483647u);
            let _e120 = bitcast<u32>(_e88);
            let _e121 = (_e120 & 2147483647u);
            let _e125 = (((select(_e116, _e114, (_e116 < _e114)) < 2139095040u) && (_e121 <= 2139095040u)) && (_e108 > 0u));
            if _e125 {
                let _e128 = (bitcast<u32>(bitcast<f32>(_e108)) & 2147483647u);
                if (_e128 >= 8388608u) {
                    phi_250_ = (bitcast<i32>((_e128 >> bitcast<u32>(23i))) - 127i);
                } else {
                    phi_250_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e128)), 32u, (_e128 == 0u))));
                }
                let _e142 = phi_250_;
                phi_251_ = _e142;
            } else {
                phi_251_ = 0i;
            }
            let _e144 = phi_251_;
            let _e145 = (_e94 == _e108);
            if _e145 {
                phi_261_ = true;
            } else {
                phi_261_ = (_e96 == _e108);
            }
            let _e148 = phi_261_;
            let _e149 = select(1u, 0u, _e145);
            if _e148 {
                let _e150 = (_e149 + 1u);
                phi_271_ = _e150;
                phi_272_ = _e150;
                phi_274_ = select(true, false, (_e150 == 2u));
            } else {
                phi_271_ = u32();
                phi_272_ = 0u;
                phi_274_ = true;
            }
            let _e154 = phi_271_;
            let _e156 = phi_272_;
            let _e158 = phi_274_;
            if _e158 {
                phi_279_ = (_e156 + 1u);
            } else {
                phi_279_ = 0u;
            }
            let _e162 = phi_279_;
            let _e163 = select(_e154, _e156, _e158);
            let _e164 = select(_e149, select(2u, _e149, _e148), _e158);
            if (_e92 < -126i) {
                phi_292_ = -126i;
            } else {
                phi_292_ = select(_e92, 127i, (_e92 > 127i));
            }
            let _e169 = phi_292_;
            let _e174 = bitcast<f32>((bitcast<u32>((_e169 + 127i)) << bitcast<u32>(23i)));
            let _e180 = bitcast<f32>((bitcast<u32>(((_e92 - _e169) + 127i)) << bitcast<u32>(23i)));
            let _e181 = -(_e144);
            if (_e181 < -126i) {
                phi_312_ = -126i;
            } else {
                phi_312_ = select(_e181, 127i, (_e181 > 127i));
            }
            let _e186 = phi_312_;
            let _e191 = bitcast<f32>((bitcast<u32>((_e186 + 127i)) << bitcast<u32>(23i)));
            let _e197 = bitcast<f32>((bitcast<u32>(((_e181 - _e186) + 127i)) << bitcast<u32>(23i)));
            let _e198 = (_e163 == 0u);
            let _e200 = (_e163 == 2u);
            let _e201 = select(select(_e75.y, _e75.x, _e198), _e75.z, _e200);
            let _e202 = bitcast<u32>(_e201);
            let _e204 = ((_e202 & 2139095040u) != 0u);
            let _e218 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e202 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e202 & 2147483648u))), _e201, _e204) * _e174) * select(0.00000011920929f, 1f, _e204)) * _e180);
            let _e220 = select(select(_e82.y, _e82.x, _e198), _e82.z, _e200);
            let _e221 = bitcast<u32>(_e220);
            let _e223 = ((_e221 & 2139095040u) != 0u);
            let _e237 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e221 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e221 & 2147483648u))), _e220, _e223) * _e191) * select(0.00000011920929f, 1f, _e223)) * _e197);
            let _e241 = (bitcast<f32>((bitcast<u32>(_e237) & 2147483647u)) >= 0.00000000000000000086736174f);
            let _e244 = bitcast<f32>((bitcast<u32>(_e218) & 2147483647u));
            let _e245 = (_e244 * 0.00000011920929f);
            let _e248 = select(select(0.00000000000011368684f, _e245, (_e245 > 0.00000000000011368684f)), 0f, _e241);
            let _e249 = select(0f, _e237, _e241);
            let _e250 = (_e218 + _e248);
            let _e251 = (_e218 - _e248);
            let _e253 = select(38685626000000000000000000f, (1f / _e237), _e241);
            let _e254 = (_e162 == 0u);
            let _e256 = (_e162 == 2u);
            let _e257 = select(select(_e75.y, _e75.x, _e254), _e75.z, _e256);
            let _e258 = bitcast<u32>(_e257);
            let _e260 = ((_e258 & 2139095040u) != 0u);
            let _e274 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e258 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e258 & 2147483648u))), _e257, _e260) * _e174) * select(0.00000011920929f, 1f, _e260)) * _e180);
            let _e276 = select(select(_e82.y, _e82.x, _e254), _e82.z, _e256);
            let _e277 = bitcast<u32>(_e276);
            let _e279 = ((_e277 & 2139095040u) != 0u);
            let _e293 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e277 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e277 & 2147483648u))), _e276, _e279) * _e191) * select(0.00000011920929f, 1f, _e279)) * _e197);
            let _e297 = (bitcast<f32>((bitcast<u32>(_e293) & 2147483647u)) >= 0.00000000000000000086736174f);
            let _e300 = bitcast<f32>((bitcast<u32>(_e274) & 2147483647u));
            let _e301 = (_e300 * 0.00000011920929f);
            let _e304 = select(select(0.00000000000011368684f, _e301, (_e301 > 0.00000000000011368684f)), 0f, _e297);
            let _e305 = select(0f, _e293, _e297);
            let _e306 = (_e274 + _e304);
            let _e307 = (_e274 - _e304);
            let _e309 = select(38685626000000000000000000f, (1f / _e293), _e297);
            let _e310 = (_e164 == 0u);
            let _e312 = (_e164 == 2u);
            let _e313 = select(select(_e75.y, _e75.x, _e310), _e75.z, _e312);
            let _e314 = bitcast<u32>(_e313);
            let _e316 = ((_e314 & 2139095040u) != 0u);
            let _e330 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e314 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e314 & 2147483648u))), _e313, _e316) * _e174) * select(0.00000011920929f, 1f, _e316)) * _e180);
            let _e332 = select(select(_e82.y, _e82.x, _e310), _e82.z, _e312);
            let _e333 = bitcast<u32>(_e332);
            let _e335 = ((_e333 & 2139095040u) != 0u);
            let _e349 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e333 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e333 & 2147483648u))), _e332, _e335) * _e191) * select(0.00000011920929f, 1f, _e335)) * _e197);
            let _e353 = (bitcast<f32>((bitcast<u32>(_e349) & 2147483647u)) >= 0.00000000000000000086736174f);
            let _e356 = bitcast<f32>((bitcast<u32>(_e330) & 2147483647u));
            let _e357 = (_e356 * 0.00000011920929f);
            let _e360 = select(select(0.00000000000011368684f, _e357, (_e357 > 0.00000000000011368684f)), 0f, _e353);
            let _e361 = select(0f, _e349, _e353);
            let _e362 = (_e330 + _e360);
            let _e363 = (_e330 - _e360);
            let _e365 = select(38685626000000000000000000f, (1f / _e349), _e353);
            let _e367 = select(_e300, _e244, (_e244 > _e300));
            let _e370 = (_e92 + _e144);
            if (_e125 && (select(_e356, _e367, (_e367 > _e356)) <= 1099511600000f)) {
                let _e380 = ((_e116 & 8388607u) | (select(0u, 1u, ((_e116 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e383 = bitcast<i32>((_e116 >> bitcast<u32>(23i)));
                let _e387 = (_e380 == 0u);
                let _e390 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e380)), 32u, _e387)) - 8i);
                if (_e383 == 255i) {
                    phi_737_ = 255i;
                } else {
                    phi_737_ = (((_e383 + select(0i, 1i, (_e383 == 0i))) - _e390) + _e370);
                }
                let _e398 = phi_737_;
                let _e408 = (_e398 <= 0i);
                if _e408 {
                    phi_760_ = u32();
                } else {
                    if _e387 {
                        phi_759_ = u32();
                    } else {
                        phi_759_ = select(((bitcast<u32>(_e398) << bitcast<u32>(23i)) | ((_e380 << bitcast<u32>(((_e390 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e398 >= 255i));
                    }
                    let _e412 = phi_759_;
                    phi_760_ = _e412;
                }
                let _e414 = phi_760_;
                let _e426 = ((_e121 & 8388607u) | (select(0u, 1u, ((_e121 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e429 = bitcast<i32>((_e121 >> bitcast<u32>(23i)));
                let _e433 = (_e426 == 0u);
                let _e436 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e426)), 32u, _e433)) - 8i);
                if (_e429 == 255i) {
                    phi_795_ = 255i;
                } else {
                    phi_795_ = (((_e429 + select(0i, 1i, (_e429 == 0i))) - _e436) + _e370);
                }
                let _e444 = phi_795_;
                let _e454 = (_e444 <= 0i);
                if _e454 {
                    phi_818_ = u32();
                } else {
                    if _e433 {
                        phi_817_ = u32();
                    } else {
                        phi_817_ = select(((bitcast<u32>(_e444) << bitcast<u32>(23i)) | ((_e426 << bitcast<u32>(((_e436 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e444 >= 255i));
                    }
                    let _e458 = phi_817_;
                    phi_818_ = _e458;
                }
                let _e460 = phi_818_;
                phi_826_ = bitcast<f32>(((_e120 & 2147483648u) | select(_e460, 0u, select(_e433, true, _e454))));
                phi_827_ = bitcast<f32>(((_e115 & 2147483648u) | select(_e414, 0u, select(_e387, true, _e408))));
            } else {
                phi_826_ = 0f;
                phi_827_ = 1f;
            }
            let _e466 = phi_826_;
            let _e468 = phi_827_;
            let _e469 = slimbvh_any_will_do.member;
            if (_e469 == 1u) {
                phi_841_ = SlimbvhTypeI(SlimbvhTypeH(SlimbvhTypeC(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e466), true);
            } else {
                phi_841_ = SlimbvhTypeI(SlimbvhTypeH(SlimbvhTypeC(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e466), false);
            }
            let _e476 = phi_841_;
            local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
            local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
            if (_e68 == 0u) {
                phi_847_ = 0u;
            } else {
                phi_847_ = (_e68 + 1u);
            }
            let _e480 = phi_847_;
            phi_2407_ = false;
            phi_865_ = _e476;
            phi_868_ = 0u;
            phi_870_ = select(4294967295u, 0u, (((_e468 <= _e466) && (_e480 > 0u)) && !((_e70 == 0u))));
            phi_872_ = _e480;
            loop {
                let _e492 = phi_2407_;
                let _e494 = phi_865_;
                let _e496 = phi_868_;
                let _e498 = phi_870_;
                let _e500 = phi_872_;
                local_7 = _e494;
                let _e501 = (_e498 <= 2147483647u);
                if _e501 {
                    phi_881_ = _e496;
                    phi_884_ = _e498;
                    phi_886_ = _e500;
                    loop {
                        let _e503 = phi_881_;
                        let _e505 = phi_884_;
                        let _e507 = phi_886_;
                        local_3 = _e503;
                        local_4 = _e503;
                        local_5 = _e505;
                        local_9 = _e503;
                        local_10 = _e505;
                        local_11 = _e507;
                        let _e508 = (_e505 <= 2147483647u);
                        let _e512 = (_e508 && !(((_e503 & 2147483648u) != 0u)));
                        local_2 = _e508;
                        if _e512 {
                            let _e513 = (_e68 - 1u);
                            let _e515 = select(_e503, _e513, (_e513 < _e503));
                            let _e516 = (_e515 < _e68);
                            if _e516 {
                            } else {
                                phi_2404_ = true;
                                break;
                            }
                            let _e521 = slimbvh_nodes.member[_e515][3u][0u];
                            let _e526 = slimbvh_nodes.member[_e515][3u][1u];
                            if _e516 {
                            } else {
                                phi_2404_ = true;
                                break;
                            }
                            let _e527 = ((_e163 & 3u) % 4u);
                            if (_e527 < 4u) {
                            } else {
                                phi_2404_ = true;
                                break;
                            }
                            let _e532 = slimbvh_nodes.member[_e515][_e527];
                            if _e516 {
                            } else {
                                phi_2404_ = true;
                                break;
                            }
                            let _e533 = ((_e162 & 3u) % 4u);
                            if (_e533 < 4u) {
                            } else {
                                phi_2404_ = true;
                                break;
                            }
                            let _e538 = slimbvh_nodes.member[_e515][_e533];
                            if _e516 {
                            } else {
                                phi_2404_ = true;
                                break;
                            }
                            let _e539 = ((_e164 & 3u) % 4u);
                            if (_e539 < 4u) {
                            } else {
                                phi_2404_ = true;
                                break;
                            }
                            let _e544 = slimbvh_nodes.member[_e515][_e539];
                            let _e545 = bitcast<u32>(_e521);
                            let _e546 = bitcast<u32>(_e526);
                            let _e557 = ((_e532.x - _e250) * _e253);
                            let _e558 = ((_e532.y - _e250) * _e253);
                            let _e559 = ((_e532.z - _e251) * _e253);
                            let _e560 = ((_e532.w - _e251) * _e253);
                            let _e569 = ((_e538.x - _e306) * _e309);
                            let _e570 = ((_e538.y - _e306) * _e309);
                            let _e571 = ((_e538.z - _e307) * _e309);
                            let _e572 = ((_e538.w - _e307) * _e309);
                            let _e581 = ((_e544.x - _e362) * _e365);
                            let _e582 = ((_e544.y - _e362) * _e365);
                            let _e583 = ((_e544.z - _e363) * _e365);
                            let _e584 = ((_e544.w - _e363) * _e365);
                            let _e585 = min(_e581, _e583);
                            let _e586 = min(_e582, _e584);
                            let _e587 = max(_e581, _e583);
                            let _e588 = max(_e582, _e584);
                            let _e613 = max(max(max(min(_e557, _e559), min(_e569, _e571)), _e585), _e468);
                            let _e614 = max(max(max(min(_e558, _e560), min(_e570, _e572)), _e586), _e468);
                            let _e617 = (_e613 <= min((min(min(max(_e557, _e559), max(_e569, _e571)), _e587) + (max(_e587, -(_e585)) * 0.0000019073523f)), _e494.member.member_1));
                            let _e618 = (_e614 <= min((min(min(max(_e558, _e560), max(_e570, _e572)), _e588) + (max(_e588, -(_e586)) * 0.0000019073523f)), _e494.member.member_1));
                            if (_e617 || _e618) {
                                let _e633 = (_e617 && ((_e613 <= _e614) || !(_e618)));
                                if (_e617 && _e618) {
                                    let _e638 = (_e505 % 128u);
                                    let _e639 = (_e638 < 128u);
                                    if _e639 {
                                    } else {
                                        phi_2404_ = true;
                                        break;
                                    }
                                    local_1[_e638] = select(_e545, _e546, _e633);
                                    if _e639 {
                                    } else {
                                        phi_2404_ = true;
                                        break;
                                    }
                                    local[_e638] = select(_e613, _e614, _e633);
                                    phi_1147_ = (_e505 + 1u);
                                } else {
                                    phi_1147_ = _e505;
                                }
                                let _e644 = phi_1147_;
                                phi_1173_ = select(_e546, _e545, _e633);
                                phi_1174_ = _e644;
                            } else {
                                let _e621 = (_e505 - 1u);
                                let _e622 = (_e621 % 128u);
                                let _e623 = (_e622 < 128u);
                                if _e623 {
                                } else {
                                    phi_2404_ = true;
                                    break;
                                }
                                let _e625 = local[_e622];
                                if (_e625 <= _e494.member.member_1) {
                                    if _e623 {
                                    } else {
                                        phi_2404_ = true;
                                        break;
                                    }
                                    let _e628 = local_1[_e622];
                                    phi_1172_ = _e628;
                                } else {
                                    phi_1172_ = 2147483648u;
                                }
                                let _e630 = phi_1172_;
                                phi_1173_ = _e630;
                                phi_1174_ = _e621;
                            }
                            let _e646 = phi_1173_;
                            let _e648 = phi_1174_;
                            let _e649 = (_e507 - 1u);
                            phi_882_ = _e646;
                            phi_885_ = select(_e648, 4294967295u, (_e649 == 0u));
                            phi_887_ = _e649;
                        } else {
                            phi_882_ = u32();
                            phi_885_ = u32();
                            phi_887_ = u32();
                        }
                        let _e653 = phi_882_;
                        let _e655 = phi_885_;
                        let _e657 = phi_887_;
                        continue;
                        continuing {
                            phi_881_ = _e653;
                            phi_884_ = _e655;
                            phi_886_ = _e657;
                            phi_2404_ = _e492;
                            break if !(_e512);
                        }
                    }
                    let _e660 = phi_2404_;
                    phi_2528_ = _e660;
                    if _e660 {
                        break;
                    }
                    let _e662 = local_2;
                    if _e662 {
                        let _e664 = local_3;
                        let _e667 = local_4;
                        phi_1190_ = _e494;
                        phi_1193_ = SlimbvhTypeA(0u, ((_e667 >> bitcast<u32>(28u)) & 7u));
                        loop {
                            let _e673 = phi_1190_;
                            let _e675 = phi_1193_;
                            local_6 = _e673;
                            local_8 = _e673;
                            if (_e675.member < _e675.member_1) {
                                phi_1194_ = SlimbvhTypeA((_e675.member + 1u), _e675.member_1);
                                phi_1216_ = SlimbvhTypeA(1u, _e675.member);
                            } else {
                                phi_1194_ = _e675;
                                phi_1216_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                            }
                            let _e688 = phi_1194_;
                            let _e690 = phi_1216_;
                            let _e694 = (bitcast<i32>(_e690.member) != 0i);
                            if _e694 {
                                let _e695 = ((_e664 & 268435455u) + _e690.member_1);
                                let _e696 = (_e70 - 1u);
                                let _e697 = (_e695 / 2u);
                                let _e699 = select(_e697, _e696, (_e696 < _e697));
                                let _e700 = (_e695 % 2u);
                                let _e701 = (_e699 < _e70);
                                if _e701 {
                                } else {
                                    phi_2483_ = true;
                                    break;
                                }
                                let _e702 = (2u * _e700);
                                let _e703 = (_e702 < 5u);
                                if _e703 {
                                } else {
                                    phi_2483_ = true;
                                    break;
                                }
                                let _e707 = slimbvh_triangles.member[_e699][_e702];
                                if _e701 {
                                } else {
                                    phi_2483_ = true;
                                    break;
                                }
                                let _e708 = (_e702 + 1u);
                                let _e709 = (_e708 < 5u);
                                if _e709 {
                                } else {
                                    phi_2483_ = true;
                                    break;
                                }
                                let _e713 = slimbvh_triangles.member[_e699][_e708];
                                if _e701 {
                                } else {
                                    phi_2483_ = true;
                                    break;
                                }
                                let _e714 = (_e702 + 2u);
                                let _e715 = (_e714 < 5u);
                                if _e715 {
                                } else {
                                    phi_2483_ = true;
                                    break;
                                }
                                let _e719 = slimbvh_triangles.member[_e699][_e714];
                                let _e720 = (_e700 == 0u);
                                if _e720 {
                                    phi_1296_ = array<vec4<f32>, 3>(_e707, _e713, _e719);
                                } else {
                                    phi_1296_ = array<vec4<f32>, 3>(vec4<f32>(_e707.z, _e707.w, _e713.x, _e713.y), vec4<f32>(_e713.z, _e713.w, _e719.x, _e719.y), vec4<f32>(_e719.z, _e719.w, 0f, 0f));
                                }
                                let _e737 = phi_1296_;
                                let _e740 = bitcast<u32>(_e737[2].y);
                                if _e701 {
                                } else {
                                    phi_2483_ = true;
                                    break;
                                }
                                if _e703 {
                                } else {
                                    phi_2483_ = true;
                                    break;
                                }
                                if _e701 {
                                } else {
                                    phi_2483_ = true;
                                    break;
                                }
                                if _e709 {
                                } else {
                                    phi_2483_ = true;
                                    break;
                                }
                                if _e701 {
                                } else {
                                    phi_2483_ = true;
                                    break;
                                }
                                if _e715 {
                                } else {
                                    phi_2483_ = true;
                                    break;
                                }
                                if _e720 {
                                    phi_1371_ = array<vec4<f32>, 3>(_e707, _e713, _e719);
                                } else {
                                    phi_1371_ = array<vec4<f32>, 3>(vec4<f32>(_e707.z, _e707.w, _e713.x, _e713.y), vec4<f32>(_e713.z, _e713.w, _e719.x, _e719.y), vec4<f32>(_e719.z, _e719.w, 0f, 0f));
                                }
                                let _e757 = phi_1371_;
                                if _e198 {
                                    phi_1395_ = array<f32, 3>(_e757[0].x, _e757[0].y, _e757[0].z);
                                } else {
                                    if (_e163 == 1u) {
                                        phi_1394_ = array<f32, 3>(_e757[0].y, _e757[0].z, _e757[0].x);
                                    } else {
                                        phi_1394_ = array<f32, 3>(_e757[0].z, _e757[0].x, _e757[0].y);
                                    }
                                    let _e780 = phi_1394_;
                                    phi_1395_ = _e780;
                                }
                                let _e783 = phi_1395_;
                                if _e198 {
                                    phi_1410_ = array<f32, 3>(_e757[0].w, _e757[1].x, _e757[1].y);
                                } else {
                                    if (_e163 == 1u) {
                                        phi_1409_ = array<f32, 3>(_e757[1].x, _e757[1].y, _e757[0].w);
                                    } else {
                                        phi_1409_ = array<f32, 3>(_e757[1].y, _e757[0].w, _e757[1].x);
                                    }
                                    let _e788 = phi_1409_;
                                    phi_1410_ = _e788;
                                }
                                let _e791 = phi_1410_;
                                if _e198 {
                                    phi_1425_ = array<f32, 3>(_e757[1].z, _e757[1].w, _e757[2].x);
                                } else {
                                    if (_e163 == 1u) {
                                        phi_1424_ = array<f32, 3>(_e757[1].w, _e757[2].x, _e757[1].z);
                                    } else {
                                        phi_1424_ = array<f32, 3>(_e757[2].x, _e757[1].z, _e757[1].w);
                                    }
                                    let _e796 = phi_1424_;
                                    phi_1425_ = _e796;
                                }
                                let _e799 = phi_1425_;
                                let _e813 = (_e783[2] - _e330);
                                let _e816 = (((_e783[0] - _e218) * _e361) - (_e813 * _e249));
                                let _e819 = (((_e783[1] - _e274) * _e361) - (_e813 * _e305));
                                let _e822 = (_e791[2] - _e330);
                                let _e825 = (((_e791[0] - _e218) * _e361) - (_e822 * _e249));
                                let _e828 = (((_e791[1] - _e274) * _e361) - (_e822 * _e305));
                                let _e831 = (_e799[2] - _e330);
                                let _e834 = (((_e799[0] - _e218) * _e361) - (_e831 * _e249));
                                let _e837 = (((_e799[1] - _e274) * _e361) - (_e831 * _e305));
                                let _e838 = (_e834 * _e828);
                                let _e839 = (_e837 * _e825);
                                let _e840 = (_e816 * _e837);
                                let _e841 = (_e819 * _e834);
                                let _e842 = (_e825 * _e819);
                                let _e843 = (_e828 * _e816);
                                let _e848 = (((_e838 >= _e839) && (_e840 >= _e841)) && (_e842 >= _e843));
                                let _e854 = (_e848 || (((_e838 <= _e839) && (_e840 <= _e841)) && (_e842 <= _e843)));
                                if _e854 {
                                    let _e856 = select(-1f, 1f, _e848);
                                    let _e858 = ((_e838 - _e839) * _e856);
                                    let _e860 = select(0f, _e858, (_e858 > 0f));
                                    let _e862 = ((_e840 - _e841) * _e856);
                                    let _e864 = select(0f, _e862, (_e862 > 0f));
                                    let _e866 = ((_e842 - _e843) * _e856);
                                    let _e868 = select(0f, _e866, (_e866 > 0f));
                                    let _e870 = ((_e860 + _e864) + _e868);
                                    let _e885 = ((min(min(_e783[0], _e791[0]), _e799[0]) - _e250) * _e253);
                                    let _e886 = ((max(max(_e783[0], _e791[0]), _e799[0]) - _e251) * _e253);
                                    let _e889 = ((min(min(_e783[1], _e791[1]), _e799[1]) - _e306) * _e309);
                                    let _e890 = ((max(max(_e783[1], _e791[1]), _e799[1]) - _e307) * _e309);
                                    let _e893 = ((min(min(_e783[2], _e791[2]), _e799[2]) - _e362) * _e365);
                                    let _e894 = ((max(max(_e783[2], _e791[2]), _e799[2]) - _e363) * _e365);
                                    let _e895 = min(_e893, _e894);
                                    let _e896 = max(_e893, _e894);
                                    let _e900 = max(max(min(_e885, _e886), min(_e889, _e890)), _e895);
                                    let _e904 = min(min(max(_e885, _e886), max(_e889, _e890)), _e896);
                                    let _e909 = max(_e900, _e468);
                                    let _e931 = (((((_e854 && (_e870 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e816, _e825), _e834) <= 0f) && (max(max(_e816, _e825), _e834) >= 0f))) && ((min(min(_e819, _e828), _e837) <= 0f) && (max(max(_e819, _e828), _e837) >= 0f))) && (_e909 <= (_e904 + (max(_e896, -(_e895)) * 0.0000019073523f)))) && (_e909 <= _e673.member.member_1));
                                    if _e931 {
                                        let _e936 = (_e791[0] - _e783[0]);
                                        let _e937 = (_e791[1] - _e783[1]);
                                        let _e938 = (_e791[2] - _e783[2]);
                                        let _e939 = vec3<f32>(_e936, _e937, _e938);
                                        let _e940 = (_e799[0] - _e791[0]);
                                        let _e941 = (_e799[1] - _e791[1]);
                                        let _e942 = (_e799[2] - _e791[2]);
                                        let _e943 = vec3<f32>(_e940, _e941, _e942);
                                        let _e944 = (_e783[0] - _e799[0]);
                                        let _e945 = (_e783[1] - _e799[1]);
                                        let _e946 = (_e783[2] - _e799[2]);
                                        let _e947 = vec3<f32>(_e944, _e945, _e946);
                                        let _e958 = max(max(bitcast<f32>((bitcast<u32>(_e936) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e937) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e938) & 2147483647u)));
                                        let _e969 = max(max(bitcast<f32>((bitcast<u32>(_e940) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e941) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e942) & 2147483647u)));
                                        let _e982 = max(max(_e958, _e969), max(max(bitcast<f32>((bitcast<u32>(_e944) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e945) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e946) & 2147483647u))));
                                        if (_e958 == _e982) {
                                            phi_1741_ = _e828;
                                            phi_1742_ = _e825;
                                            phi_1743_ = _e819;
                                            phi_1744_ = _e816;
                                            phi_1745_ = vec3<f32>(_e783[0], _e783[1], _e783[2]);
                                            phi_1746_ = _e947;
                                            phi_1747_ = _e943;
                                            phi_1748_ = _e939;
                                        } else {
                                            let _e984 = (_e969 == _e982);
                                            let _e989 = vec3(_e984);
                                            phi_1741_ = select(_e819, _e837, _e984);
                                            phi_1742_ = select(_e816, _e834, _e984);
                                            phi_1743_ = select(_e837, _e828, _e984);
                                            phi_1744_ = select(_e834, _e825, _e984);
                                            phi_1745_ = select(vec3<f32>(_e799[0], _e799[1], _e799[2]), vec3<f32>(_e791[0], _e791[1], _e791[2]), _e989);
                                            phi_1746_ = select(_e943, _e939, _e989);
                                            phi_1747_ = select(_e939, _e947, _e989);
                                            phi_1748_ = select(_e947, _e943, _e989);
                                        }
                                        let _e995 = phi_1741_;
                                        let _e997 = phi_1742_;
                                        let _e999 = phi_1743_;
                                        let _e1001 = phi_1744_;
                                        let _e1003 = phi_1745_;
                                        let _e1005 = phi_1746_;
                                        let _e1007 = phi_1747_;
                                        let _e1009 = phi_1748_;
                                        let _e1016 = ((_e1007.y * _e1005.z) - (_e1005.y * _e1007.z));
                                        let _e1021 = ((_e1007.z * _e1005.x) - (_e1005.z * _e1007.x));
                                        let _e1024 = ((_e1007.x * _e1005.y) - (_e1005.x * _e1007.y));
                                        let _e1027 = ((_e860 >= _e864) && (_e860 >= _e868));
                                        let _e1028 = (_e864 >= _e868);
                                        let _e1042 = (((_e1016 * (select(select(_e799[0], _e791[0], _e1028), _e783[0], _e1027) - _e218)) + (_e1021 * (select(select(_e799[1], _e791[1], _e1028), _e783[1], _e1027) - _e274))) + (_e1024 * (select(select(_e799[2], _e791[2], _e1028), _e783[2], _e1027) - _e330)));
                                        let _e1047 = (((_e1016 * _e249) + (_e1021 * _e305)) + (_e1024 * _e361));
                                        let _e1048 = (_e997 - _e1001);
                                        let _e1049 = (_e995 - _e999);
                                        let _e1052 = ((_e1048 * _e1048) + (_e1049 * _e1049));
                                        let _e1059 = (-(((_e1001 * _e1048) + (_e999 * _e1049))) / select(0.000000000000000000000000000000000000011754944f, _e1052, (_e1052 > 0.000000000000000000000000000000000000011754944f)));
                                        let _e1061 = select(1f, _e1059, (_e1059 < 1f));
                                        let _e1063 = select(0f, _e1061, (_e1061 > 0f));
                                        let _e1072 = ((_e1003.x + (_e1009.x * _e1063)) - _e218);
                                        let _e1075 = ((_e1003.y + (_e1009.y * _e1063)) - _e274);
                                        let _e1078 = ((_e1003.z + (_e1009.z * _e1063)) - _e330);
                                        let _e1143 = ((bitcast<f32>((bitcast<u32>(((((_e1016 * _e1072) + (_e1021 * _e1075)) + (_e1024 * _e1078)) - _e1042)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1072) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1075) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1078) & 2147483647u))), _e982)) * max(max(bitcast<f32>((bitcast<u32>(_e1016) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1021) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1024) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1047) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1007.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1007.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1007.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1005.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1005.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1005.z) & 2147483647u)))))));
                                        let _e1144 = (_e1042 / _e1047);
                                        if (_e931 && !(_e1143)) {
                                            let _e1147 = (_e1078 / _e361);
                                            let _e1155 = (((_e1016 * (_e1072 - (_e249 * _e1147))) + (_e1021 * (_e1075 - (_e305 * _e1147)))) / _e1047);
                                            phi_1927_ = select(select(_e1147, (_e1147 + _e1155), (bitcast<f32>((bitcast<u32>(_e1155) & 2147483647u)) <= _e982)), _e1144, _e1143);
                                        } else {
                                            phi_1927_ = _e1144;
                                        }
                                        let _e1164 = phi_1927_;
                                        let _e1166 = select(_e904, _e1164, (_e1164 < _e904));
                                        let _e1168 = select(_e900, _e1166, (_e1166 > _e900));
                                        let _e1171 = select(_e1168, 0f, (bitcast<u32>(_e1168) == 2147483648u));
                                        let _e1172 = (1f / _e870);
                                        phi_1953_ = SlimbvhTypeJ(_e1171, (_e864 * _e1172), (_e868 * _e1172), ((_e931 && (_e1171 >= _e468)) && (_e1171 <= _e673.member.member_1)));
                                        phi_1954_ = SlimbvhTypeJ();
                                    } else {
                                        phi_1953_ = SlimbvhTypeJ();
                                        phi_1954_ = SlimbvhTypeJ(0f, 0f, 0f, _e931);
                                    }
                                    let _e1181 = phi_1953_;
                                    let _e1183 = phi_1954_;
                                    phi_1957_ = _e1181;
                                    phi_1958_ = _e1183;
                                    phi_1959_ = select(true, false, _e931);
                                } else {
                                    phi_1957_ = SlimbvhTypeJ();
                                    phi_1958_ = SlimbvhTypeJ(0f, 0f, 0f, _e854);
                                    phi_1959_ = true;
                                }
                                let _e1186 = phi_1957_;
                                let _e1188 = phi_1958_;
                                let _e1190 = phi_1959_;
                                if _e1190 {
                                    phi_1963_ = _e1188;
                                } else {
                                    phi_1963_ = _e1186;
                                }
                                let _e1192 = phi_1963_;
                                if _e1192.member_3 {
                                    phi_1972_ = SlimbvhTypeC(_e1192.member, _e1192.member_1, _e1192.member_2, _e740);
                                } else {
                                    phi_1972_ = SlimbvhTypeC(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                }
                                let _e1199 = phi_1972_;
                                if (_e1199.member_3 != 4294967295u) {
                                    if (_e740 != 4294967295u) {
                                        if (_e1199.member < _e673.member.member.member) {
                                            phi_1998_ = true;
                                        } else {
                                            if (_e1199.member == _e673.member.member.member) {
                                                phi_1997_ = (_e1199.member_3 < _e673.member.member.member_3);
                                            } else {
                                                phi_1997_ = false;
                                            }
                                            let _e1214 = phi_1997_;
                                            phi_1998_ = _e1214;
                                        }
                                        let _e1216 = phi_1998_;
                                        if _e1216 {
                                            phi_2005_ = SlimbvhTypeI(SlimbvhTypeH(_e1199, _e1199.member), _e673.member_1);
                                        } else {
                                            phi_2005_ = _e673;
                                        }
                                        let _e1222 = phi_2005_;
                                        if _e1222.member_1 {
                                            phi_2011_ = SlimbvhTypeI(SlimbvhTypeH(_e1222.member.member, -340282350000000000000000000000000000000f), _e1222.member_1);
                                        } else {
                                            phi_2011_ = _e1222;
                                        }
                                        let _e1231 = phi_2011_;
                                        phi_2012_ = _e1231;
                                    } else {
                                        phi_2012_ = _e673;
                                    }
                                    let _e1233 = phi_2012_;
                                    phi_2013_ = _e1233;
                                } else {
                                    phi_2013_ = _e673;
                                }
                                let _e1235 = phi_2013_;
                                phi_1191_ = _e1235;
                            } else {
                                phi_1191_ = SlimbvhTypeI();
                            }
                            let _e1237 = phi_1191_;
                            continue;
                            continuing {
                                phi_1190_ = _e1237;
                                phi_1193_ = _e688;
                                phi_2483_ = _e660;
                                break if !(_e694);
                            }
                        }
                        let _e1240 = phi_2483_;
                        phi_2528_ = _e1240;
                        if _e1240 {
                            break;
                        }
                        let _e1242 = local_5;
                        let _e1243 = (_e1242 - 1u);
                        let _e1244 = (_e1243 % 128u);
                        let _e1245 = (_e1244 < 128u);
                        if _e1245 {
                        } else {
                            phi_2528_ = true;
                            break;
                        }
                        let _e1247 = local[_e1244];
                        let _e1249 = local_6;
                        if (_e1247 <= _e1249.member.member_1) {
                            if _e1245 {
                            } else {
                                phi_2528_ = true;
                                break;
                            }
                            let _e1254 = local_1[_e1244];
                            phi_2038_ = _e1254;
                        } else {
                            phi_2038_ = 2147483648u;
                        }
                        let _e1256 = phi_2038_;
                        phi_2530_ = _e1240;
                        let _e1494 = local_8;
                        phi_2045_ = _e1494;
                        phi_2046_ = _e1256;
                        phi_2047_ = select(_e1243, 4294967295u, (_e468 > _e1249.member.member_1));
                    } else {
                        phi_2530_ = _e660;
                        phi_2045_ = _e494;
                        let _e1497 = local_9;
                        phi_2046_ = _e1497;
                        let _e1500 = local_10;
                        phi_2047_ = _e1500;
                    }
                    let _e1260 = phi_2530_;
                    let _e1262 = phi_2045_;
                    let _e1264 = phi_2046_;
                    let _e1266 = phi_2047_;
                    phi_2529_ = _e1260;
                    phi_866_ = _e1262;
                    phi_869_ = _e1264;
                    phi_871_ = _e1266;
                    let _e1507 = local_11;
                    phi_873_ = _e1507;
                } else {
                    phi_2529_ = _e492;
                    phi_866_ = SlimbvhTypeI();
                    phi_869_ = u32();
                    phi_871_ = u32();
                    phi_873_ = u32();
                }
                let _e1268 = phi_2529_;
                let _e1270 = phi_866_;
                let _e1272 = phi_869_;
                let _e1274 = phi_871_;
                let _e1276 = phi_873_;
                continue;
                continuing {
                    phi_2407_ = _e1268;
                    phi_865_ = _e1270;
                    phi_868_ = _e1272;
                    phi_870_ = _e1274;
                    phi_872_ = _e1276;
                    phi_2528_ = _e1268;
                    break if !(_e501);
                }
            }
            let _e1279 = phi_2528_;
            if _e1279 {
                break;
            }
            let _e1281 = local_7;
            if (_e1281.member.member.member_3 != 4294967295u) {
                let _e1287 = -(_e370);
                let _e1288 = bitcast<u32>(_e1281.member.member.member);
                let _e1292 = (bitcast<i32>((_e1288 >> bitcast<u32>(23i))) & 255i);
                let _e1293 = (_e1292 + _e1287);
                if (_e1292 == 255i) {
                    phi_2102_ = _e1281.member.member.member;
                } else {
                    if (_e1292 > 0i) {
                        if (_e1293 > 0i) {
                            let _e1297 = (_e1293 < 255i);
                            if _e1297 {
                                phi_2081_ = bitcast<f32>((_e1288 + bitcast<u32>((_e1287 << bitcast<u32>(23i)))));
                            } else {
                                phi_2081_ = f32();
                            }
                            let _e1304 = phi_2081_;
                            phi_2083_ = _e1304;
                            phi_2084_ = select(true, false, _e1297);
                        } else {
                            phi_2083_ = f32();
                            phi_2084_ = true;
                        }
                        let _e1307 = phi_2083_;
                        let _e1309 = phi_2084_;
                        phi_2085_ = _e1307;
                        phi_2086_ = _e1309;
                    } else {
                        phi_2085_ = f32();
                        phi_2086_ = true;
                    }
                    let _e1311 = phi_2085_;
                    let _e1313 = phi_2086_;
                    if _e1313 {
                        let _e1314 = (_e1288 & 2147483648u);
                        let _e1321 = ((_e1288 & 8388607u) | (select(0u, 1u, ((_e1288 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e1325 = (_e1321 == 0u);
                        if _e1325 {
                            phi_2399_ = bitcast<f32>(_e1314);
                        } else {
                            let _e1330 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1321)), 32u, _e1325) - 8u);
                            let _e1333 = (_e1321 << bitcast<u32>((_e1330 & 31u)));
                            let _e1335 = ((_e1293 + select(0i, 1i, (_e1292 == 0i))) - bitcast<i32>(_e1330));
                            if (_e1335 >= 255i) {
                                phi_2389_ = bitcast<f32>((_e1314 | 2139095040u));
                                phi_2390_ = f32();
                                phi_2391_ = true;
                            } else {
                                let _e1337 = (_e1335 > 0i);
                                if _e1337 {
                                    phi_2383_ = bitcast<f32>(((_e1314 | (bitcast<u32>(_e1335) << bitcast<u32>(23i))) | (_e1333 & 8388607u)));
                                    phi_2384_ = f32();
                                } else {
                                    if (_e1335 < -24i) {
                                        phi_2349_ = 26u;
                                    } else {
                                        phi_2349_ = bitcast<u32>((1i - _e1335));
                                    }
                                    let _e1342 = phi_2349_;
                                    let _e1343 = (_e1342 & 31u);
                                    let _e1345 = (_e1333 >> bitcast<u32>(_e1343));
                                    let _e1349 = (_e1333 & ((1u << bitcast<u32>(_e1343)) - 1u));
                                    let _e1353 = (1u << bitcast<u32>(((_e1342 - 1u) & 31u)));
                                    if (_e1349 > _e1353) {
                                        phi_2370_ = true;
                                    } else {
                                        if (_e1349 == _e1353) {
                                            phi_2367_ = ((_e1345 & 1u) == 1u);
                                        } else {
                                            phi_2367_ = false;
                                        }
                                        let _e1359 = phi_2367_;
                                        phi_2370_ = _e1359;
                                    }
                                    let _e1361 = phi_2370_;
                                    phi_2383_ = f32();
                                    phi_2384_ = bitcast<f32>((_e1314 | (_e1345 + select(0u, 1u, _e1361))));
                                }
                                let _e1374 = phi_2383_;
                                let _e1376 = phi_2384_;
                                phi_2389_ = _e1374;
                                phi_2390_ = _e1376;
                                phi_2391_ = _e1337;
                            }
                            let _e1380 = phi_2389_;
                            let _e1382 = phi_2390_;
                            let _e1384 = phi_2391_;
                            phi_2399_ = select(_e1382, _e1380, _e1384);
                        }
                        let _e1388 = phi_2399_;
                        phi_2101_ = _e1388;
                    } else {
                        phi_2101_ = _e1311;
                    }
                    let _e1390 = phi_2101_;
                    phi_2102_ = _e1390;
                }
                let _e1392 = phi_2102_;
                let _e1393 = bitcast<u32>(_e1392);
                if ((_e1393 & 2147483647u) >= 2139095040u) {
                    phi_2114_ = bitcast<f32>(((_e1393 & 2147483648u) | 2139095039u));
                } else {
                    phi_2114_ = _e1392;
                }
                let _e1400 = phi_2114_;
                phi_2119_ = SlimbvhTypeC(_e1400, _e1281.member.member.member_1, _e1281.member.member.member_2, _e1281.member.member.member_3);
            } else {
                phi_2119_ = SlimbvhTypeC(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
            }
            let _e1405 = phi_2119_;
            slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1405.member), bitcast<u32>(_e1405.member_1), bitcast<u32>(_e1405.member_2), _e1405.member_3);
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
