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
    var phi_251_: i32;
    var phi_252_: i32;
    var phi_262_: bool;
    var phi_272_: u32;
    var phi_273_: u32;
    var phi_275_: bool;
    var phi_280_: u32;
    var phi_293_: i32;
    var phi_313_: i32;
    var phi_738_: i32;
    var phi_760_: u32;
    var phi_761_: u32;
    var phi_796_: i32;
    var phi_818_: u32;
    var phi_819_: u32;
    var phi_827_: f32;
    var phi_828_: f32;
    var phi_842_: SlimbvhTypeI;
    var phi_856_: SlimbvhTypeI;
    var phi_859_: u32;
    var phi_861_: u32;
    var phi_863_: u32;
    var phi_872_: u32;
    var phi_875_: u32;
    var phi_877_: u32;
    var phi_1156_: u32;
    var phi_1131_: u32;
    var phi_1157_: u32;
    var phi_1158_: u32;
    var phi_873_: u32;
    var phi_876_: u32;
    var phi_878_: u32;
    var local_2: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1174_: SlimbvhTypeI;
    var phi_1177_: SlimbvhTypeA;
    var phi_1178_: SlimbvhTypeA;
    var phi_1200_: SlimbvhTypeA;
    var phi_1279_: array<vec4<f32>, 3>;
    var phi_1280_: array<vec4<f32>, 3>;
    var phi_1354_: array<vec4<f32>, 3>;
    var phi_1355_: array<vec4<f32>, 3>;
    var phi_1378_: array<f32, 3>;
    var phi_1379_: array<f32, 3>;
    var phi_1393_: array<f32, 3>;
    var phi_1394_: array<f32, 3>;
    var phi_1408_: array<f32, 3>;
    var phi_1409_: array<f32, 3>;
    var phi_1725_: f32;
    var phi_1726_: f32;
    var phi_1727_: f32;
    var phi_1728_: f32;
    var phi_1729_: vec3<f32>;
    var phi_1730_: vec3<f32>;
    var phi_1731_: vec3<f32>;
    var phi_1732_: vec3<f32>;
    var phi_1911_: f32;
    var phi_1937_: SlimbvhTypeJ;
    var phi_1938_: SlimbvhTypeJ;
    var phi_1941_: SlimbvhTypeJ;
    var phi_1942_: SlimbvhTypeJ;
    var phi_1943_: bool;
    var phi_1947_: SlimbvhTypeJ;
    var phi_1956_: SlimbvhTypeC;
    var phi_1981_: bool;
    var phi_1982_: bool;
    var phi_1989_: SlimbvhTypeI;
    var phi_1995_: SlimbvhTypeI;
    var phi_1996_: SlimbvhTypeI;
    var phi_1997_: SlimbvhTypeI;
    var phi_1175_: SlimbvhTypeI;
    var local_5: u32;
    var local_6: SlimbvhTypeI;
    var phi_2022_: u32;
    var phi_2029_: SlimbvhTypeI;
    var phi_2030_: u32;
    var phi_2031_: u32;
    var phi_857_: SlimbvhTypeI;
    var phi_860_: u32;
    var phi_862_: u32;
    var phi_864_: u32;
    var local_7: SlimbvhTypeI;
    var phi_2065_: f32;
    var phi_2067_: f32;
    var phi_2068_: bool;
    var phi_2069_: f32;
    var phi_2070_: bool;
    var phi_2323_: u32;
    var phi_2341_: bool;
    var phi_2344_: bool;
    var phi_2357_: f32;
    var phi_2358_: f32;
    var phi_2363_: f32;
    var phi_2364_: f32;
    var phi_2365_: bool;
    var phi_2373_: f32;
    var phi_2085_: f32;
    var phi_2086_: f32;
    var phi_2098_: f32;
    var phi_2103_: SlimbvhTypeC;
    var local_8: SlimbvhTypeI;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;

    let _e69 = SlimbvhTypeC(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e71 = arrayLength((&slimbvh_nodes.member));
    let _e78 = slimbvh_origin.member;
    let _e84 = slimbvh_origin.member[3u];
    let _e85 = slimbvh_direction.member;
    let _e91 = slimbvh_direction.member[3u];
    let _e94 = slimbvh_exponent.member[0u];
    let _e95 = bitcast<i32>(_e94);
    let _e97 = (bitcast<u32>(_e85.x) & 2147483647u);
    let _e99 = (bitcast<u32>(_e85.y) & 2147483647u);
    let _e101 = (bitcast<u32>(_e85.z) & 2147483647u);
    let _e103 = (bitcast<u32>(_e78.x) & 2147483647u);
    let _e105 = (bitcast<u32>(_e78.y) & 2147483647u);
    let _e107 = (bitcast<u32>(_e78.z) & 2147483647u);
    let _e109 = select(_e99, _e97, (_e99 < _e97));
    let _e111 = select(_e101, _e109, (_e101 < _e109));
    let _e113 = select(_e103, _e111, (_e103 < _e111));
    let _e115 = select(_e105, _e113, (_e105 < _e113));
    let _e117 = select(_e107, _e115, (_e107 < _e115));
    let _e118 = bitcast<u32>(_e84);
    let _e119 = (_e118 & 2147483647u);
    let _e123 = bitcast<u32>(_e91);
    let _e124 = (_e123 & 2147483647u);
    let _e128 = (((select(_e119, _e117, (_e119 < _e117)) < 2139095040u) && (_e124 <= 2139095040u)) && (_e111 > 0u));
    if _e128 {
        let _e131 = (bitcast<u32>(bitcast<f32>(_e111)) & 2147483647u);
        if (_e131 >= 8388608u) {
            phi_251_ = (bitcast<i32>((_e131 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_251_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e131)), 32u, (_e131 == 0u))));
        }
        let _e145 = phi_251_;
        phi_252_ = _e145;
    } else {
        phi_252_ = 0i;
    }
    let _e147 = phi_252_;
    let _e148 = (_e97 == _e111);
    if _e148 {
        phi_262_ = true;
    } else {
        phi_262_ = (_e99 == _e111);
    }
    let _e151 = phi_262_;
    let _e152 = select(1u, 0u, _e148);
    if _e151 {
        let _e153 = (_e152 + 1u);
        phi_272_ = _e153;
        phi_273_ = _e153;
        phi_275_ = select(true, false, (_e153 == 2u));
    } else {
        phi_272_ = u32();
        phi_273_ = 0u;
        phi_275_ = true;
    }
    let _e157 = phi_272_;
    let _e159 = phi_273_;
    let _e161 = phi_275_;
    if _e161 {
        phi_280_ = (_e159 + 1u);
    } else {
        phi_280_ = 0u;
    }
    let _e165 = phi_280_;
    let _e166 = select(_e157, _e159, _e161);
    let _e167 = select(_e152, select(2u, _e152, _e151), _e161);
    if (_e95 < -126i) {
        phi_293_ = -126i;
    } else {
        phi_293_ = select(_e95, 127i, (_e95 > 127i));
    }
    let _e172 = phi_293_;
    let _e177 = bitcast<f32>((bitcast<u32>((_e172 + 127i)) << bitcast<u32>(23i)));
    let _e183 = bitcast<f32>((bitcast<u32>(((_e95 - _e172) + 127i)) << bitcast<u32>(23i)));
    let _e184 = -(_e147);
    if (_e184 < -126i) {
        phi_313_ = -126i;
    } else {
        phi_313_ = select(_e184, 127i, (_e184 > 127i));
    }
    let _e189 = phi_313_;
    let _e194 = bitcast<f32>((bitcast<u32>((_e189 + 127i)) << bitcast<u32>(23i)));
    let _e200 = bitcast<f32>((bitcast<u32>(((_e184 - _e189) + 127i)) << bitcast<u32>(23i)));
    let _e201 = (_e166 == 0u);
    let _e203 = (_e166 == 2u);
    let _e204 = select(select(_e78.y, _e78.x, _e201), _e78.z, _e203);
    let _e205 = bitcast<u32>(_e204);
    let _e207 = ((_e205 & 2139095040u) != 0u);
    let _e221 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e205 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e205 & 2147483648u))), _e204, _e207) * _e177) * select(0.00000011920929f, 1f, _e207)) * _e183);
    let _e223 = select(select(_e85.y, _e85.x, _e201), _e85.z, _e203);
    let _e224 = bitcast<u32>(_e223);
    let _e226 = ((_e224 & 2139095040u) != 0u);
    let _e240 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e224 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e224 & 2147483648u))), _e223, _e226) * _e194) * select(0.00000011920929f, 1f, _e226)) * _e200);
    let _e244 = (bitcast<f32>((bitcast<u32>(_e240) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e247 = bitcast<f32>((bitcast<u32>(_e221) & 2147483647u));
    let _e248 = (_e247 * 0.00000011920929f);
    let _e251 = select(select(0.00000000000011368684f, _e248, (_e248 > 0.00000000000011368684f)), 0f, _e244);
    let _e252 = select(0f, _e240, _e244);
    let _e253 = (_e221 + _e251);
    let _e254 = (_e221 - _e251);
    let _e256 = select(38685626000000000000000000f, (1f / _e240), _e244);
    let _e257 = (_e165 == 0u);
    let _e259 = (_e165 == 2u);
    let _e260 = select(select(_e78.y, _e78.x, _e257), _e78.z, _e259);
    let _e261 = bitcast<u32>(_e260);
    let _e263 = ((_e261 & 2139095040u) != 0u);
    let _e277 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e261 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e261 & 2147483648u))), _e260, _e263) * _e177) * select(0.00000011920929f, 1f, _e263)) * _e183);
    let _e279 = select(select(_e85.y, _e85.x, _e257), _e85.z, _e259);
    let _e280 = bitcast<u32>(_e279);
    let _e282 = ((_e280 & 2139095040u) != 0u);
    let _e296 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e280 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e280 & 2147483648u))), _e279, _e282) * _e194) * select(0.00000011920929f, 1f, _e282)) * _e200);
    let _e300 = (bitcast<f32>((bitcast<u32>(_e296) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e303 = bitcast<f32>((bitcast<u32>(_e277) & 2147483647u));
    let _e304 = (_e303 * 0.00000011920929f);
    let _e307 = select(select(0.00000000000011368684f, _e304, (_e304 > 0.00000000000011368684f)), 0f, _e300);
    let _e308 = select(0f, _e296, _e300);
    let _e309 = (_e277 + _e307);
    let _e310 = (_e277 - _e307);
    let _e312 = select(38685626000000000000000000f, (1f / _e296), _e300);
    let _e313 = (_e167 == 0u);
    let _e315 = (_e167 == 2u);
    let _e316 = select(select(_e78.y, _e78.x, _e313), _e78.z, _e315);
    let _e317 = bitcast<u32>(_e316);
    let _e319 = ((_e317 & 2139095040u) != 0u);
    let _e333 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e317 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e317 & 2147483648u))), _e316, _e319) * _e177) * select(0.00000011920929f, 1f, _e319)) * _e183);
    let _e335 = select(select(_e85.y, _e85.x, _e313), _e85.z, _e315);
    let _e336 = bitcast<u32>(_e335);
    let _e338 = ((_e336 & 2139095040u) != 0u);
    let _e352 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e336 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e336 & 2147483648u))), _e335, _e338) * _e194) * select(0.00000011920929f, 1f, _e338)) * _e200);
    let _e356 = (bitcast<f32>((bitcast<u32>(_e352) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e359 = bitcast<f32>((bitcast<u32>(_e333) & 2147483647u));
    let _e360 = (_e359 * 0.00000011920929f);
    let _e363 = select(select(0.00000000000011368684f, _e360, (_e360 > 0.00000000000011368684f)), 0f, _e356);
    let _e364 = select(0f, _e352, _e356);
    let _e365 = (_e333 + _e363);
    let _e366 = (_e333 - _e363);
    let _e368 = select(38685626000000000000000000f, (1f / _e352), _e356);
    let _e370 = select(_e303, _e247, (_e247 > _e303));
    let _e373 = (_e95 + _e147);
    if (_e128 && (select(_e359, _e370, (_e370 > _e359)) <= 1099511600000f)) {
        let _e383 = ((_e119 & 8388607u) | (select(0u, 1u, ((_e119 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e386 = bitcast<i32>((_e119 >> bitcast<u32>(23i)));
        let _e390 = (_e383 == 0u);
        let _e393 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e383)), 32u, _e390)) - 8i);
        if (_e386 == 255i) {
            phi_738_ = 255i;
        } else {
            phi_738_ = (((_e386 + select(0i, 1i, (_e386 == 0i))) - _e393) + _e373);
        }
        let _e401 = phi_738_;
        let _e411 = (_e401 <= 0i);
        if _e411 {
            phi_761_ = u32();
        } else {
            if _e390 {
                phi_760_ = u32();
            } else {
                phi_760_ = select(((bitcast<u32>(_e401) << bitcast<u32>(23i)) | ((_e383 << bitcast<u32>(((_e393 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e401 >= 255i));
            }
            let _e415 = phi_760_;
            phi_761_ = _e415;
        }
        let _e417 = phi_761_;
        let _e429 = ((_e124 & 8388607u) | (select(0u, 1u, ((_e124 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e432 = bitcast<i32>((_e124 >> bitcast<u32>(23i)));
        let _e436 = (_e429 == 0u);
        let _e439 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e429)), 32u, _e436)) - 8i);
        if (_e432 == 255i) {
            phi_796_ = 255i;
        } else {
            phi_796_ = (((_e432 + select(0i, 1i, (_e432 == 0i))) - _e439) + _e373);
        }
        let _e447 = phi_796_;
        let _e457 = (_e447 <= 0i);
        if _e457 {
            phi_819_ = u32();
        } else {
            if _e436 {
                phi_818_ = u32();
            } else {
                phi_818_ = select(((bitcast<u32>(_e447) << bitcast<u32>(23i)) | ((_e429 << bitcast<u32>(((_e439 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e447 >= 255i));
            }
            let _e461 = phi_818_;
            phi_819_ = _e461;
        }
        let _e463 = phi_819_;
        phi_827_ = bitcast<f32>(((_e123 & 2147483648u) | select(_e463, 0u, select(_e436, true, _e457))));
        phi_828_ = bitcast<f32>(((_e118 & 2147483648u) | select(_e417, 0u, select(_e390, true, _e411))));
    } else {
        phi_827_ = 0f;
        phi_828_ = 1f;
    }
    let _e469 = phi_827_;
    let _e471 = phi_828_;
    let _e472 = slimbvh_any_will_do.member;
    if (_e472 == 1u) {
        phi_842_ = SlimbvhTypeI(SlimbvhTypeH(_e69, _e469), true);
    } else {
        phi_842_ = SlimbvhTypeI(SlimbvhTypeH(_e69, _e469), false);
    }
    let _e479 = phi_842_;
    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
    phi_856_ = _e479;
    phi_859_ = 0u;
    phi_861_ = select(4294967295u, 0u, (_e471 <= _e469));
    phi_863_ = (_e71 + 1u);
    loop {
        let _e487 = phi_856_;
        let _e489 = phi_859_;
        let _e491 = phi_861_;
        let _e493 = phi_863_;
        local_7 = _e487;
        let _e494 = (_e491 <= 2147483647u);
        if _e494 {
            phi_872_ = _e489;
            phi_875_ = _e491;
            phi_877_ = _e493;
            loop {
                let _e496 = phi_872_;
                let _e498 = phi_875_;
                let _e500 = phi_877_;
                local_3 = _e496;
                local_4 = _e496;
                local_5 = _e498;
                local_9 = _e496;
                local_10 = _e498;
                local_11 = _e500;
                let _e501 = (_e498 <= 2147483647u);
                let _e504 = (_e501 && !((_e496 >= _e71)));
                local_2 = _e501;
                if _e504 {
                    let _e509 = slimbvh_nodes.member[_e496][3u][0u];
                    let _e514 = slimbvh_nodes.member[_e496][3u][1u];
                    let _e519 = slimbvh_nodes.member[_e496][((_e166 & 3u) % 4u)];
                    let _e524 = slimbvh_nodes.member[_e496][((_e165 & 3u) % 4u)];
                    let _e529 = slimbvh_nodes.member[_e496][((_e167 & 3u) % 4u)];
                    let _e530 = bitcast<u32>(_e509);
                    let _e531 = bitcast<u32>(_e514);
                    let _e542 = ((_e519.x - _e253) * _e256);
                    let _e543 = ((_e519.y - _e253) * _e256);
                    let _e544 = ((_e519.z - _e254) * _e256);
                    let _e545 = ((_e519.w - _e254) * _e256);
                    let _e554 = ((_e524.x - _e309) * _e312);
                    let _e555 = ((_e524.y - _e309) * _e312);
                    let _e556 = ((_e524.z - _e310) * _e312);
                    let _e557 = ((_e524.w - _e310) * _e312);
                    let _e566 = ((_e529.x - _e365) * _e368);
                    let _e567 = ((_e529.y - _e365) * _e368);
                    let _e568 = ((_e529.z - _e366) * _e368);
                    let _e569 = ((_e529.w - _e366) * _e368);
                    let _e570 = min(_e566, _e568);
                    let _e571 = min(_e567, _e569);
                    let _e572 = max(_e566, _e568);
                    let _e573 = max(_e567, _e569);
                    let _e598 = max(max(max(min(_e542, _e544), min(_e554, _e556)), _e570), _e471);
                    let _e599 = max(max(max(min(_e543, _e545), min(_e555, _e557)), _e571), _e471);
                    let _e602 = (_e598 <= min((min(min(max(_e542, _e544), max(_e554, _e556)), _e572) + (max(_e572, -(_e570)) * 0.0000019073523f)), _e487.member.member_1));
                    let _e603 = (_e599 <= min((min(min(max(_e543, _e545), max(_e555, _e557)), _e573) + (max(_e573, -(_e571)) * 0.0000019073523f)), _e487.member.member_1));
                    if (_e602 || _e603) {
                        let _e617 = (_e602 && ((_e598 <= _e599) || !(_e603)));
                        if (_e602 && _e603) {
                            let _e622 = (_e498 % 128u);
                            local_1[_e622] = select(_e530, _e531, _e617);
                            local[_e622] = select(_e598, _e599, _e617);
                            phi_1131_ = (_e498 + 1u);
                        } else {
                            phi_1131_ = _e498;
                        }
                        let _e627 = phi_1131_;
                        phi_1157_ = select(_e531, _e530, _e617);
                        phi_1158_ = _e627;
                    } else {
                        let _e606 = (_e498 - 1u);
                        let _e607 = (_e606 % 128u);
                        let _e609 = local[_e607];
                        if (_e609 <= _e487.member.member_1) {
                            let _e612 = local_1[_e607];
                            phi_1156_ = _e612;
                        } else {
                            phi_1156_ = 2147483648u;
                        }
                        let _e614 = phi_1156_;
                        phi_1157_ = _e614;
                        phi_1158_ = _e606;
                    }
                    let _e629 = phi_1157_;
                    let _e631 = phi_1158_;
                    let _e632 = (_e500 - 1u);
                    phi_873_ = _e629;
                    phi_876_ = select(_e631, 4294967295u, (_e632 == 0u));
                    phi_878_ = _e632;
                } else {
                    phi_873_ = u32();
                    phi_876_ = u32();
                    phi_878_ = u32();
                }
                let _e636 = phi_873_;
                let _e638 = phi_876_;
                let _e640 = phi_878_;
                continue;
                continuing {
                    phi_872_ = _e636;
                    phi_875_ = _e638;
                    phi_877_ = _e640;
                    break if !(_e504);
                }
            }
            let _e643 = local_2;
            if _e643 {
                let _e645 = local_3;
                let _e648 = local_4;
                phi_1174_ = _e487;
                phi_1177_ = SlimbvhTypeA(0u, ((_e648 >> bitcast<u32>(28u)) & 7u));
                loop {
                    let _e654 = phi_1174_;
                    let _e656 = phi_1177_;
                    local_6 = _e654;
                    local_8 = _e654;
                    if (_e656.member < _e656.member_1) {
                        phi_1178_ = SlimbvhTypeA((_e656.member + 1u), _e656.member_1);
                        phi_1200_ = SlimbvhTypeA(1u, _e656.member);
                    } else {
                        phi_1178_ = _e656;
                        phi_1200_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                    }
                    let _e669 = phi_1178_;
                    let _e671 = phi_1200_;
                    let _e675 = (bitcast<i32>(_e671.member) != 0i);
                    if _e675 {
                        let _e676 = ((_e645 & 268435455u) + _e671.member_1);
                        let _e677 = (_e676 / 2u);
                        let _e678 = (_e676 % 2u);
                        let _e679 = (_e677 >= arrayLength((&slimbvh_triangles.member)));
                        if _e679 {
                            phi_1280_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e680 = (2u * _e678);
                            let _e684 = slimbvh_triangles.member[_e677][_e680];
                            let _e689 = slimbvh_triangles.member[_e677][(_e680 + 1u)];
                            let _e694 = slimbvh_triangles.member[_e677][(_e680 + 2u)];
                            if (_e678 == 0u) {
                                phi_1279_ = array<vec4<f32>, 3>(_e684, _e689, _e694);
                            } else {
                                phi_1279_ = array<vec4<f32>, 3>(vec4<f32>(_e684.z, _e684.w, _e689.x, _e689.y), vec4<f32>(_e689.z, _e689.w, _e694.x, _e694.y), vec4<f32>(_e694.z, _e694.w, 0f, 0f));
                            }
                            let _e712 = phi_1279_;
                            phi_1280_ = _e712;
                        }
                        let _e714 = phi_1280_;
                        let _e717 = bitcast<u32>(_e714[2].y);
                        if _e679 {
                            phi_1355_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                        } else {
                            let _e718 = (2u * _e678);
                            let _e722 = slimbvh_triangles.member[_e677][_e718];
                            let _e727 = slimbvh_triangles.member[_e677][(_e718 + 1u)];
                            let _e732 = slimbvh_triangles.member[_e677][(_e718 + 2u)];
                            if (_e678 == 0u) {
                                phi_1354_ = array<vec4<f32>, 3>(_e722, _e727, _e732);
                            } else {
                                phi_1354_ = array<vec4<f32>, 3>(vec4<f32>(_e722.z, _e722.w, _e727.x, _e727.y), vec4<f32>(_e727.z, _e727.w, _e732.x, _e732.y), vec4<f32>(_e732.z, _e732.w, 0f, 0f));
                            }
                            let _e750 = phi_1354_;
                            phi_1355_ = _e750;
                        }
                        let _e752 = phi_1355_;
                        if _e201 {
                            phi_1379_ = array<f32, 3>(_e752[0].x, _e752[0].y, _e752[0].z);
                        } else {
                            if (_e166 == 1u) {
                                phi_1378_ = array<f32, 3>(_e752[0].y, _e752[0].z, _e752[0].x);
                            } else {
                                phi_1378_ = array<f32, 3>(_e752[0].z, _e752[0].x, _e752[0].y);
                            }
                            let _e775 = phi_1378_;
                            phi_1379_ = _e775;
                        }
                        let _e778 = phi_1379_;
                        if _e201 {
                            phi_1394_ = array<f32, 3>(_e752[0].w, _e752[1].x, _e752[1].y);
                        } else {
                            if (_e166 == 1u) {
                                phi_1393_ = array<f32, 3>(_e752[1].x, _e752[1].y, _e752[0].w);
                            } else {
                                phi_1393_ = array<f32, 3>(_e752[1].y, _e752[0].w, _e752[1].x);
                            }
                            let _e783 = phi_1393_;
                            phi_1394_ = _e783;
                        }
                        let _e786 = phi_1394_;
                        if _e201 {
                            phi_1409_ = array<f32, 3>(_e752[1].z, _e752[1].w, _e752[2].x);
                        } else {
                            if (_e166 == 1u) {
                                phi_1408_ = array<f32, 3>(_e752[1].w, _e752[2].x, _e752[1].z);
                            } else {
                                phi_1408_ = array<f32, 3>(_e752[2].x, _e752[1].z, _e752[1].w);
                            }
                            let _e791 = phi_1408_;
                            phi_1409_ = _e791;
                        }
                        let _e794 = phi_1409_;
                        let _e808 = (_e778[2] - _e333);
                        let _e811 = (((_e778[0] - _e221) * _e364) - (_e808 * _e252));
                        let _e814 = (((_e778[1] - _e277) * _e364) - (_e808 * _e308));
                        let _e817 = (_e786[2] - _e333);
                        let _e820 = (((_e786[0] - _e221) * _e364) - (_e817 * _e252));
                        let _e823 = (((_e786[1] - _e277) * _e364) - (_e817 * _e308));
                        let _e826 = (_e794[2] - _e333);
                        let _e829 = (((_e794[0] - _e221) * _e364) - (_e826 * _e252));
                        let _e832 = (((_e794[1] - _e277) * _e364) - (_e826 * _e308));
                        let _e833 = (_e829 * _e823);
                        let _e834 = (_e832 * _e820);
                        let _e835 = (_e811 * _e832);
                        let _e836 = (_e814 * _e829);
                        let _e837 = (_e820 * _e814);
                        let _e838 = (_e823 * _e811);
                        let _e843 = (((_e833 >= _e834) && (_e835 >= _e836)) && (_e837 >= _e838));
                        let _e849 = (_e843 || (((_e833 <= _e834) && (_e835 <= _e836)) && (_e837 <= _e838)));
                        if _e849 {
                            let _e851 = select(-1f, 1f, _e843);
                            let _e853 = ((_e833 - _e834) * _e851);
                            let _e855 = select(0f, _e853, (_e853 > 0f));
                            let _e857 = ((_e835 - _e836) * _e851);
                            let _e859 = select(0f, _e857, (_e857 > 0f));
                            let _e861 = ((_e837 - _e838) * _e851);
                            let _e863 = select(0f, _e861, (_e861 > 0f));
                            let _e865 = ((_e855 + _e859) + _e863);
                            let _e880 = ((min(min(_e778[0], _e786[0]), _e794[0]) - _e253) * _e256);
                            let _e881 = ((max(max(_e778[0], _e786[0]), _e794[0]) - _e254) * _e256);
                            let _e884 = ((min(min(_e778[1], _e786[1]), _e794[1]) - _e309) * _e312);
                            let _e885 = ((max(max(_e778[1], _e786[1]), _e794[1]) - _e310) * _e312);
                            let _e888 = ((min(min(_e778[2], _e786[2]), _e794[2]) - _e365) * _e368);
                            let _e889 = ((max(max(_e778[2], _e786[2]), _e794[2]) - _e366) * _e368);
                            let _e890 = min(_e888, _e889);
                            let _e891 = max(_e888, _e889);
                            let _e895 = max(max(min(_e880, _e881), min(_e884, _e885)), _e890);
                            let _e899 = min(min(max(_e880, _e881), max(_e884, _e885)), _e891);
                            let _e904 = max(_e895, _e471);
                            let _e926 = (((((_e849 && (_e865 >= 0.000000000000000000000000000000000000011754944f)) && ((min(min(_e811, _e820), _e829) <= 0f) && (max(max(_e811, _e820), _e829) >= 0f))) && ((min(min(_e814, _e823), _e832) <= 0f) && (max(max(_e814, _e823), _e832) >= 0f))) && (_e904 <= (_e899 + (max(_e891, -(_e890)) * 0.0000019073523f)))) && (_e904 <= _e654.member.member_1));
                            if _e926 {
                                let _e931 = (_e786[0] - _e778[0]);
                                let _e932 = (_e786[1] - _e778[1]);
                                let _e933 = (_e786[2] - _e778[2]);
                                let _e934 = vec3<f32>(_e931, _e932, _e933);
                                let _e935 = (_e794[0] - _e786[0]);
                                let _e936 = (_e794[1] - _e786[1]);
                                let _e937 = (_e794[2] - _e786[2]);
                                let _e938 = vec3<f32>(_e935, _e936, _e937);
                                let _e939 = (_e778[0] - _e794[0]);
                                let _e940 = (_e778[1] - _e794[1]);
                                let _e941 = (_e778[2] - _e794[2]);
                                let _e942 = vec3<f32>(_e939, _e940, _e941);
                                let _e953 = max(max(bitcast<f32>((bitcast<u32>(_e931) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e932) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e933) & 2147483647u)));
                                let _e964 = max(max(bitcast<f32>((bitcast<u32>(_e935) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e936) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e937) & 2147483647u)));
                                let _e977 = max(max(_e953, _e964), max(max(bitcast<f32>((bitcast<u32>(_e939) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e940) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e941) & 2147483647u))));
                                if (_e953 == _e977) {
                                    phi_1725_ = _e823;
                                    phi_1726_ = _e820;
                                    phi_1727_ = _e814;
                                    phi_1728_ = _e811;
                                    phi_1729_ = vec3<f32>(_e778[0], _e778[1], _e778[2]);
                                    phi_1730_ = _e942;
                                    phi_1731_ = _e938;
                                    phi_1732_ = _e934;
                                } else {
                                    let _e979 = (_e964 == _e977);
                                    let _e984 = vec3(_e979);
                                    phi_1725_ = select(_e814, _e832, _e979);
                                    phi_1726_ = select(_e811, _e829, _e979);
                                    phi_1727_ = select(_e832, _e823, _e979);
                                    phi_1728_ = select(_e829, _e820, _e979);
                                    phi_1729_ = select(vec3<f32>(_e794[0], _e794[1], _e794[2]), vec3<f32>(_e786[0], _e786[1], _e786[2]), _e984);
                                    phi_1730_ = select(_e938, _e934, _e984);
                                    phi_1731_ = select(_e934, _e942, _e984);
                                    phi_1732_ = select(_e942, _e938, _e984);
                                }
                                let _e990 = phi_1725_;
                                let _e992 = phi_1726_;
                                let _e994 = phi_1727_;
                                let _e996 = phi_1728_;
                                let _e998 = phi_1729_;
                                let _e1000 = phi_1730_;
                                let _e1002 = phi_1731_;
                                let _e1004 = phi_1732_;
                                let _e1011 = ((_e1002.y * _e1000.z) - (_e1000.y * _e1002.z));
                                let _e1016 = ((_e1002.z * _e1000.x) - (_e1000.z * _e1002.x));
                                let _e1019 = ((_e1002.x * _e1000.y) - (_e1000.x * _e1002.y));
                                let _e1022 = ((_e855 >= _e859) && (_e855 >= _e863));
                                let _e1023 = (_e859 >= _e863);
                                let _e1037 = (((_e1011 * (select(select(_e794[0], _e786[0], _e1023), _e778[0], _e1022) - _e221)) + (_e1016 * (select(select(_e794[1], _e786[1], _e1023), _e778[1], _e1022) - _e277))) + (_e1019 * (select(select(_e794[2], _e786[2], _e1023), _e778[2], _e1022) - _e333)));
                                let _e1042 = (((_e1011 * _e252) + (_e1016 * _e308)) + (_e1019 * _e364));
                                let _e1043 = (_e992 - _e996);
                                let _e1044 = (_e990 - _e994);
                                let _e1047 = ((_e1043 * _e1043) + (_e1044 * _e1044));
                                let _e1054 = (-(((_e996 * _e1043) + (_e994 * _e1044))) / select(0.000000000000000000000000000000000000011754944f, _e1047, (_e1047 > 0.000000000000000000000000000000000000011754944f)));
                                let _e1056 = select(1f, _e1054, (_e1054 < 1f));
                                let _e1058 = select(0f, _e1056, (_e1056 > 0f));
                                let _e1067 = ((_e998.x + (_e1004.x * _e1058)) - _e221);
                                let _e1070 = ((_e998.y + (_e1004.y * _e1058)) - _e277);
                                let _e1073 = ((_e998.z + (_e1004.z * _e1058)) - _e333);
                                let _e1138 = ((bitcast<f32>((bitcast<u32>(((((_e1011 * _e1067) + (_e1016 * _e1070)) + (_e1019 * _e1073)) - _e1037)) & 2147483647u)) <= ((0.0000009536743f * max(max(max(bitcast<f32>((bitcast<u32>(_e1067) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1070) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1073) & 2147483647u))), _e977)) * max(max(bitcast<f32>((bitcast<u32>(_e1011) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1016) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1019) & 2147483647u))))) && !((bitcast<f32>((bitcast<u32>(_e1042) & 2147483647u)) <= ((0.0000038146973f * max(max(bitcast<f32>((bitcast<u32>(_e1002.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1002.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1002.z) & 2147483647u)))) * max(max(bitcast<f32>((bitcast<u32>(_e1000.x) & 2147483647u)), bitcast<f32>((bitcast<u32>(_e1000.y) & 2147483647u))), bitcast<f32>((bitcast<u32>(_e1000.z) & 2147483647u)))))));
                                let _e1139 = (_e1037 / _e1042);
                                if (_e926 && !(_e1138)) {
                                    let _e1142 = (_e1073 / _e364);
                                    let _e1150 = (((_e1011 * (_e1067 - (_e252 * _e1142))) + (_e1016 * (_e1070 - (_e308 * _e1142)))) / _e1042);
                                    phi_1911_ = select(select(_e1142, (_e1142 + _e1150), (bitcast<f32>((bitcast<u32>(_e1150) & 2147483647u)) <= _e977)), _e1139, _e1138);
                                } else {
                                    phi_1911_ = _e1139;
                                }
                                let _e1159 = phi_1911_;
                                let _e1161 = select(_e899, _e1159, (_e1159 < _e899));
                                let _e1163 = select(_e895, _e1161, (_e1161 > _e895));
                                let _e1166 = select(_e1163, 0f, (bitcast<u32>(_e1163) == 2147483648u));
                                let _e1167 = (1f / _e865);
                                phi_1937_ = SlimbvhTypeJ(_e1166, (_e859 * _e1167), (_e863 * _e1167), ((_e926 && (_e1166 >= _e471)) && (_e1166 <= _e654.member.member_1)));
                                phi_1938_ = SlimbvhTypeJ();
                            } else {
                                phi_1937_ = SlimbvhTypeJ();
                                phi_1938_ = SlimbvhTypeJ(0f, 0f, 0f, _e926);
                            }
                            let _e1176 = phi_1937_;
                            let _e1178 = phi_1938_;
                            phi_1941_ = _e1176;
                            phi_1942_ = _e1178;
                            phi_1943_ = select(true, false, _e926);
                        } else {
                            phi_1941_ = SlimbvhTypeJ();
                            phi_1942_ = SlimbvhTypeJ(0f, 0f, 0f, _e849);
                            phi_1943_ = true;
                        }
                        let _e1181 = phi_1941_;
                        let _e1183 = phi_1942_;
                        let _e1185 = phi_1943_;
                        if _e1185 {
                            phi_1947_ = _e1183;
                        } else {
                            phi_1947_ = _e1181;
                        }
                        let _e1187 = phi_1947_;
                        if _e1187.member_3 {
                            phi_1956_ = SlimbvhTypeC(_e1187.member, _e1187.member_1, _e1187.member_2, _e717);
                        } else {
                            phi_1956_ = _e69;
                        }
                        let _e1194 = phi_1956_;
                        if (_e1194.member_3 != 4294967295u) {
                            if (_e717 != 4294967295u) {
                                if (_e1194.member < _e654.member.member.member) {
                                    phi_1982_ = true;
                                } else {
                                    if (_e1194.member == _e654.member.member.member) {
                                        phi_1981_ = (_e1194.member_3 < _e654.member.member.member_3);
                                    } else {
                                        phi_1981_ = false;
                                    }
                                    let _e1209 = phi_1981_;
                                    phi_1982_ = _e1209;
                                }
                                let _e1211 = phi_1982_;
                                if _e1211 {
                                    phi_1989_ = SlimbvhTypeI(SlimbvhTypeH(_e1194, _e1194.member), _e654.member_1);
                                } else {
                                    phi_1989_ = _e654;
                                }
                                let _e1217 = phi_1989_;
                                if _e1217.member_1 {
                                    phi_1995_ = SlimbvhTypeI(SlimbvhTypeH(_e1217.member.member, bitcast<f32>(4286578687u)), _e1217.member_1);
                                } else {
                                    phi_1995_ = _e1217;
                                }
                                let _e1226 = phi_1995_;
                                phi_1996_ = _e1226;
                            } else {
                                phi_1996_ = _e654;
                            }
                            let _e1228 = phi_1996_;
                            phi_1997_ = _e1228;
                        } else {
                            phi_1997_ = _e654;
                        }
                        let _e1230 = phi_1997_;
                        phi_1175_ = _e1230;
                    } else {
                        phi_1175_ = SlimbvhTypeI();
                    }
                    let _e1232 = phi_1175_;
                    continue;
                    continuing {
                        phi_1174_ = _e1232;
                        phi_1177_ = _e669;
                        break if !(_e675);
                    }
                }
                let _e1235 = local_5;
                let _e1236 = (_e1235 - 1u);
                let _e1237 = (_e1236 % 128u);
                let _e1239 = local[_e1237];
                let _e1241 = local_6;
                if (_e1239 <= _e1241.member.member_1) {
                    let _e1246 = local_1[_e1237];
                    phi_2022_ = _e1246;
                } else {
                    phi_2022_ = 2147483648u;
                }
                let _e1248 = phi_2022_;
                let _e1477 = local_8;
                phi_2029_ = _e1477;
                phi_2030_ = _e1248;
                phi_2031_ = select(_e1236, 4294967295u, (_e471 > _e1241.member.member_1));
            } else {
                phi_2029_ = _e487;
                let _e1480 = local_9;
                phi_2030_ = _e1480;
                let _e1483 = local_10;
                phi_2031_ = _e1483;
            }
            let _e1252 = phi_2029_;
            let _e1254 = phi_2030_;
            let _e1256 = phi_2031_;
            phi_857_ = _e1252;
            phi_860_ = _e1254;
            phi_862_ = _e1256;
            let _e1489 = local_11;
            phi_864_ = _e1489;
        } else {
            phi_857_ = SlimbvhTypeI();
            phi_860_ = u32();
            phi_862_ = u32();
            phi_864_ = u32();
        }
        let _e1258 = phi_857_;
        let _e1260 = phi_860_;
        let _e1262 = phi_862_;
        let _e1264 = phi_864_;
        continue;
        continuing {
            phi_856_ = _e1258;
            phi_859_ = _e1260;
            phi_861_ = _e1262;
            phi_863_ = _e1264;
            break if !(_e494);
        }
    }
    let _e1267 = local_7;
    if (_e1267.member.member.member_3 != 4294967295u) {
        let _e1273 = -(_e373);
        let _e1274 = bitcast<u32>(_e1267.member.member.member);
        let _e1278 = (bitcast<i32>((_e1274 >> bitcast<u32>(23i))) & 255i);
        let _e1279 = (_e1278 + _e1273);
        if (_e1278 == 255i) {
            phi_2086_ = _e1267.member.member.member;
        } else {
            if (_e1278 > 0i) {
                if (_e1279 > 0i) {
                    let _e1283 = (_e1279 < 255i);
                    if _e1283 {
                        phi_2065_ = bitcast<f32>((_e1274 + bitcast<u32>((_e1273 << bitcast<u32>(23i)))));
                    } else {
                        phi_2065_ = f32();
                    }
                    let _e1290 = phi_2065_;
                    phi_2067_ = _e1290;
                    phi_2068_ = select(true, false, _e1283);
                } else {
                    phi_2067_ = f32();
                    phi_2068_ = true;
                }
                let _e1293 = phi_2067_;
                let _e1295 = phi_2068_;
                phi_2069_ = _e1293;
                phi_2070_ = _e1295;
            } else {
                phi_2069_ = f32();
                phi_2070_ = true;
            }
            let _e1297 = phi_2069_;
            let _e1299 = phi_2070_;
            if _e1299 {
                let _e1300 = (_e1274 & 2147483648u);
                let _e1307 = ((_e1274 & 8388607u) | (select(0u, 1u, ((_e1274 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e1311 = (_e1307 == 0u);
                if _e1311 {
                    phi_2373_ = bitcast<f32>(_e1300);
                } else {
                    let _e1316 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1307)), 32u, _e1311) - 8u);
                    let _e1319 = (_e1307 << bitcast<u32>((_e1316 & 31u)));
                    let _e1321 = ((_e1279 + select(0i, 1i, (_e1278 == 0i))) - bitcast<i32>(_e1316));
                    if (_e1321 >= 255i) {
                        phi_2363_ = bitcast<f32>((_e1300 | 2139095040u));
                        phi_2364_ = f32();
                        phi_2365_ = true;
                    } else {
                        let _e1323 = (_e1321 > 0i);
                        if _e1323 {
                            phi_2357_ = bitcast<f32>(((_e1300 | (bitcast<u32>(_e1321) << bitcast<u32>(23i))) | (_e1319 & 8388607u)));
                            phi_2358_ = f32();
                        } else {
                            if (_e1321 < -24i) {
                                phi_2323_ = 26u;
                            } else {
                                phi_2323_ = bitcast<u32>((1i - _e1321));
                            }
                            let _e1328 = phi_2323_;
                            let _e1329 = (_e1328 & 31u);
                            let _e1331 = (_e1319 >> bitcast<u32>(_e1329));
                            let _e1335 = (_e1319 & ((1u << bitcast<u32>(_e1329)) - 1u));
                            let _e1339 = (1u << bitcast<u32>(((_e1328 - 1u) & 31u)));
                            if (_e1335 > _e1339) {
                                phi_2344_ = true;
                            } else {
                                if (_e1335 == _e1339) {
                                    phi_2341_ = ((_e1331 & 1u) == 1u);
                                } else {
                                    phi_2341_ = false;
                                }
                                let _e1345 = phi_2341_;
                                phi_2344_ = _e1345;
                            }
                            let _e1347 = phi_2344_;
                            phi_2357_ = f32();
                            phi_2358_ = bitcast<f32>((_e1300 | (_e1331 + select(0u, 1u, _e1347))));
                        }
                        let _e1360 = phi_2357_;
                        let _e1362 = phi_2358_;
                        phi_2363_ = _e1360;
                        phi_2364_ = _e1362;
                        phi_2365_ = _e1323;
                    }
                    let _e1366 = phi_2363_;
                    let _e1368 = phi_2364_;
                    let _e1370 = phi_2365_;
                    phi_2373_ = select(_e1368, _e1366, _e1370);
                }
                let _e1374 = phi_2373_;
                phi_2085_ = _e1374;
            } else {
                phi_2085_ = _e1297;
            }
            let _e1376 = phi_2085_;
            phi_2086_ = _e1376;
        }
        let _e1378 = phi_2086_;
        let _e1379 = bitcast<u32>(_e1378);
        if ((_e1379 & 2147483647u) >= 2139095040u) {
            phi_2098_ = bitcast<f32>(((_e1379 & 2147483648u) | 2139095039u));
        } else {
            phi_2098_ = _e1378;
        }
        let _e1386 = phi_2098_;
        phi_2103_ = SlimbvhTypeC(_e1386, _e1267.member.member.member_1, _e1267.member.member.member_2, _e1267.member.member.member_3);
    } else {
        phi_2103_ = _e69;
    }
    let _e1391 = phi_2103_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1391.member), bitcast<u32>(_e1391.member_1), bitcast<u32>(_e1391.member_2), _e1391.member_3);
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
