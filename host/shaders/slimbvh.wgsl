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
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct SlimbvhTypeM {
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
    var phi_262_: i32;
    var phi_263_: i32;
    var phi_273_: bool;
    var phi_283_: u32;
    var phi_284_: u32;
    var phi_286_: bool;
    var phi_291_: u32;
    var phi_304_: i32;
    var phi_324_: i32;
    var phi_749_: i32;
    var phi_771_: u32;
    var phi_772_: u32;
    var phi_807_: i32;
    var phi_829_: u32;
    var phi_830_: u32;
    var phi_838_: f32;
    var phi_839_: f32;
    var phi_853_: SlimbvhTypeK;
    var phi_863_: SlimbvhTypeK;
    var phi_866_: bool;
    var phi_868_: u32;
    var phi_870_: u32;
    var phi_872_: u32;
    var phi_883_: bool;
    var phi_915_: bool;
    var phi_916_: u32;
    var phi_917_: u32;
    var phi_1944_: SlimbvhTypeM;
    var phi_2306_: u32;
    var phi_2333_: u32;
    var phi_2334_: u32;
    var phi_2335_: u32;
    var phi_2337_: u32;
    var phi_2338_: u32;
    var phi_2339_: bool;
    var phi_2348_: u32;
    var phi_2353_: bool;
    var phi_2354_: u32;
    var phi_932_: SlimbvhTypeK;
    var phi_935_: SlimbvhTypeA;
    var phi_936_: SlimbvhTypeA;
    var phi_958_: SlimbvhTypeA;
    var phi_979_: u32;
    var phi_1071_: array<array<f32, 3>, 3>;
    var phi_1601_: f32;
    var phi_1602_: f32;
    var phi_1603_: f32;
    var phi_1604_: f32;
    var phi_1605_: vec3<f32>;
    var phi_1606_: vec3<f32>;
    var phi_1607_: vec3<f32>;
    var phi_1608_: vec3<f32>;
    var phi_1799_: f32;
    var phi_1819_: SlimbvhTypeL;
    var phi_1820_: SlimbvhTypeL;
    var phi_1823_: SlimbvhTypeL;
    var phi_1824_: SlimbvhTypeL;
    var phi_1825_: bool;
    var phi_1829_: SlimbvhTypeL;
    var phi_1838_: SlimbvhTypeE;
    var phi_1863_: bool;
    var phi_1864_: bool;
    var phi_1871_: SlimbvhTypeK;
    var phi_1877_: SlimbvhTypeK;
    var phi_1878_: SlimbvhTypeK;
    var phi_1879_: SlimbvhTypeK;
    var phi_933_: SlimbvhTypeK;
    var local_2: SlimbvhTypeK;
    var phi_2356_: SlimbvhTypeK;
    var phi_2357_: bool;
    var phi_2358_: u32;
    var phi_2359_: u32;
    var phi_2360_: SlimbvhTypeK;
    var phi_2361_: bool;
    var phi_2362_: u32;
    var phi_2363_: u32;
    var phi_2364_: u32;
    var phi_2365_: SlimbvhTypeK;
    var phi_2366_: bool;
    var phi_2367_: u32;
    var phi_2368_: u32;
    var phi_2369_: u32;
    var phi_864_: SlimbvhTypeK;
    var phi_867_: bool;
    var phi_869_: u32;
    var phi_871_: u32;
    var phi_873_: u32;
    var phi_2370_: bool;
    var local_3: SlimbvhTypeK;
    var phi_2408_: f32;
    var phi_2410_: f32;
    var phi_2411_: bool;
    var phi_2412_: f32;
    var phi_2413_: bool;
    var phi_2722_: u32;
    var phi_2740_: bool;
    var phi_2743_: bool;
    var phi_2756_: f32;
    var phi_2757_: f32;
    var phi_2762_: f32;
    var phi_2763_: f32;
    var phi_2764_: bool;
    var phi_2772_: f32;
    var phi_2428_: f32;
    var phi_2429_: f32;
    var phi_2441_: f32;
    var phi_2446_: SlimbvhTypeE;
    var local_4: SlimbvhTypeK;

    let _e74 = SlimbvhTypeE(bitcast<f32>(2139095039u), 0f, 0f, 4294967295u);
    let _e76 = arrayLength((&slimbvh_nodes.member));
    let _e78 = arrayLength((&slimbvh_triangles.member));
    let _e83 = slimbvh_origin.member;
    let _e89 = slimbvh_origin.member[3u];
    let _e90 = slimbvh_direction.member;
    let _e96 = slimbvh_direction.member[3u];
    let _e99 = slimbvh_exponent.member[0u];
    let _e100 = bitcast<i32>(_e99);
    let _e102 = (bitcast<u32>(_e90.x) & 2147483647u);
    let _e104 = (bitcast<u32>(_e90.y) & 2147483647u);
    let _e106 = (bitcast<u32>(_e90.z) & 2147483647u);
    let _e108 = (bitcast<u32>(_e83.x) & 2147483647u);
    let _e110 = (bitcast<u32>(_e83.y) & 2147483647u);
    let _e112 = (bitcast<u32>(_e83.z) & 2147483647u);
    let _e114 = select(_e104, _e102, (_e104 < _e102));
    let _e116 = select(_e106, _e114, (_e106 < _e114));
    let _e118 = select(_e108, _e116, (_e108 < _e116));
    let _e120 = select(_e110, _e118, (_e110 < _e118));
    let _e122 = select(_e112, _e120, (_e112 < _e120));
    let _e123 = bitcast<u32>(_e89);
    let _e124 = (_e123 & 2147483647u);
    let _e128 = bitcast<u32>(_e96);
    let _e129 = (_e128 & 2147483647u);
    let _e133 = (((select(_e124, _e122, (_e124 < _e122)) < 2139095040u) && (_e129 <= 2139095040u)) && (_e116 > 0u));
    if _e133 {
        let _e136 = (bitcast<u32>(bitcast<f32>(_e116)) & 2147483647u);
        if (_e136 >= 8388608u) {
            phi_262_ = (bitcast<i32>((_e136 >> bitcast<u32>(23i))) - 127i);
        } else {
            phi_262_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e136)), 32u, (_e136 == 0u))));
        }
        let _e150 = phi_262_;
        phi_263_ = _e150;
    } else {
        phi_263_ = 0i;
    }
    let _e152 = phi_263_;
    let _e153 = (_e102 == _e116);
    if _e153 {
        phi_273_ = true;
    } else {
        phi_273_ = (_e104 == _e116);
    }
    let _e156 = phi_273_;
    let _e157 = select(1u, 0u, _e153);
    if _e156 {
        let _e158 = (_e157 + 1u);
        phi_283_ = _e158;
        phi_284_ = _e158;
        phi_286_ = select(true, false, (_e158 == 2u));
    } else {
        phi_283_ = u32();
        phi_284_ = 0u;
        phi_286_ = true;
    }
    let _e162 = phi_283_;
    let _e164 = phi_284_;
    let _e166 = phi_286_;
    if _e166 {
        phi_291_ = (_e164 + 1u);
    } else {
        phi_291_ = 0u;
    }
    let _e170 = phi_291_;
    let _e171 = select(_e162, _e164, _e166);
    let _e172 = select(_e157, select(2u, _e157, _e156), _e166);
    if (_e100 < -126i) {
        phi_304_ = -126i;
    } else {
        phi_304_ = select(_e100, 127i, (_e100 > 127i));
    }
    let _e177 = phi_304_;
    let _e182 = bitcast<f32>((bitcast<u32>((_e177 + 127i)) << bitcast<u32>(23i)));
    let _e188 = bitcast<f32>((bitcast<u32>(((_e100 - _e177) + 127i)) << bitcast<u32>(23i)));
    let _e189 = -(_e152);
    if (_e189 < -126i) {
        phi_324_ = -126i;
    } else {
        phi_324_ = select(_e189, 127i, (_e189 > 127i));
    }
    let _e194 = phi_324_;
    let _e199 = bitcast<f32>((bitcast<u32>((_e194 + 127i)) << bitcast<u32>(23i)));
    let _e205 = bitcast<f32>((bitcast<u32>(((_e189 - _e194) + 127i)) << bitcast<u32>(23i)));
    let _e206 = (_e171 == 0u);
    let _e208 = (_e171 == 2u);
    let _e209 = select(select(_e83.y, _e83.x, _e206), _e83.z, _e208);
    let _e210 = bitcast<u32>(_e209);
    let _e212 = ((_e210 & 2139095040u) != 0u);
    let _e226 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e210 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e210 & 2147483648u))), _e209, _e212) * _e182) * select(0.00000011920929f, 1f, _e212)) * _e188);
    let _e228 = select(select(_e90.y, _e90.x, _e206), _e90.z, _e208);
    let _e229 = bitcast<u32>(_e228);
    let _e231 = ((_e229 & 2139095040u) != 0u);
    let _e245 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e229 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e229 & 2147483648u))), _e228, _e231) * _e199) * select(0.00000011920929f, 1f, _e231)) * _e205);
    let _e249 = (bitcast<f32>((bitcast<u32>(_e245) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e252 = bitcast<f32>((bitcast<u32>(_e226) & 2147483647u));
    let _e253 = (_e252 * 0.00000011920929f);
    let _e256 = select(select(0.00000000000011368684f, _e253, (_e253 > 0.00000000000011368684f)), 0f, _e249);
    let _e257 = select(0f, _e245, _e249);
    let _e258 = (_e226 + _e256);
    let _e259 = (_e226 - _e256);
    let _e261 = select(38685626000000000000000000f, (1f / _e245), _e249);
    let _e262 = (_e170 == 0u);
    let _e264 = (_e170 == 2u);
    let _e265 = select(select(_e83.y, _e83.x, _e262), _e83.z, _e264);
    let _e266 = bitcast<u32>(_e265);
    let _e268 = ((_e266 & 2139095040u) != 0u);
    let _e282 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e266 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e266 & 2147483648u))), _e265, _e268) * _e182) * select(0.00000011920929f, 1f, _e268)) * _e188);
    let _e284 = select(select(_e90.y, _e90.x, _e262), _e90.z, _e264);
    let _e285 = bitcast<u32>(_e284);
    let _e287 = ((_e285 & 2139095040u) != 0u);
    let _e301 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e285 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e285 & 2147483648u))), _e284, _e287) * _e199) * select(0.00000011920929f, 1f, _e287)) * _e205);
    let _e305 = (bitcast<f32>((bitcast<u32>(_e301) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e308 = bitcast<f32>((bitcast<u32>(_e282) & 2147483647u));
    let _e309 = (_e308 * 0.00000011920929f);
    let _e312 = select(select(0.00000000000011368684f, _e309, (_e309 > 0.00000000000011368684f)), 0f, _e305);
    let _e313 = select(0f, _e301, _e305);
    let _e314 = (_e282 + _e312);
    let _e315 = (_e282 - _e312);
    let _e317 = select(38685626000000000000000000f, (1f / _e301), _e305);
    let _e318 = (_e172 == 0u);
    let _e320 = (_e172 == 2u);
    let _e321 = select(select(_e83.y, _e83.x, _e318), _e83.z, _e320);
    let _e322 = bitcast<u32>(_e321);
    let _e324 = ((_e322 & 2139095040u) != 0u);
    let _e338 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e322 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e322 & 2147483648u))), _e321, _e324) * _e182) * select(0.00000011920929f, 1f, _e324)) * _e188);
    let _e340 = select(select(_e90.y, _e90.x, _e318), _e90.z, _e320);
    let _e341 = bitcast<u32>(_e340);
    let _e343 = ((_e341 & 2139095040u) != 0u);
    let _e357 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e341 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e341 & 2147483648u))), _e340, _e343) * _e199) * select(0.00000011920929f, 1f, _e343)) * _e205);
    let _e361 = (bitcast<f32>((bitcast<u32>(_e357) & 2147483647u)) >= 0.00000000000000000086736174f);
    let _e364 = bitcast<f32>((bitcast<u32>(_e338) & 2147483647u));
    let _e365 = (_e364 * 0.00000011920929f);
    let _e368 = select(select(0.00000000000011368684f, _e365, (_e365 > 0.00000000000011368684f)), 0f, _e361);
    let _e369 = select(0f, _e357, _e361);
    let _e370 = (_e338 + _e368);
    let _e371 = (_e338 - _e368);
    let _e373 = select(38685626000000000000000000f, (1f / _e357), _e361);
    let _e375 = select(_e308, _e252, (_e252 > _e308));
    let _e378 = (_e100 + _e152);
    if (_e133 && (select(_e364, _e375, (_e375 > _e364)) <= 1099511600000f)) {
        let _e388 = ((_e124 & 8388607u) | (select(0u, 1u, ((_e124 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e391 = bitcast<i32>((_e124 >> bitcast<u32>(23i)));
        let _e395 = (_e388 == 0u);
        let _e398 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e388)), 32u, _e395)) - 8i);
        if (_e391 == 255i) {
            phi_749_ = 255i;
        } else {
            phi_749_ = (((_e391 + select(0i, 1i, (_e391 == 0i))) - _e398) + _e378);
        }
        let _e406 = phi_749_;
        let _e416 = (_e406 <= 0i);
        if _e416 {
            phi_772_ = u32();
        } else {
            if _e395 {
                phi_771_ = u32();
            } else {
                phi_771_ = select(((bitcast<u32>(_e406) << bitcast<u32>(23i)) | ((_e388 << bitcast<u32>(((_e398 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e406 >= 255i));
            }
            let _e420 = phi_771_;
            phi_772_ = _e420;
        }
        let _e422 = phi_772_;
        let _e434 = ((_e129 & 8388607u) | (select(0u, 1u, ((_e129 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
        let _e437 = bitcast<i32>((_e129 >> bitcast<u32>(23i)));
        let _e441 = (_e434 == 0u);
        let _e444 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e434)), 32u, _e441)) - 8i);
        if (_e437 == 255i) {
            phi_807_ = 255i;
        } else {
            phi_807_ = (((_e437 + select(0i, 1i, (_e437 == 0i))) - _e444) + _e378);
        }
        let _e452 = phi_807_;
        let _e462 = (_e452 <= 0i);
        if _e462 {
            phi_830_ = u32();
        } else {
            if _e441 {
                phi_829_ = u32();
            } else {
                phi_829_ = select(((bitcast<u32>(_e452) << bitcast<u32>(23i)) | ((_e434 << bitcast<u32>(((_e444 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e452 >= 255i));
            }
            let _e466 = phi_829_;
            phi_830_ = _e466;
        }
        let _e468 = phi_830_;
        phi_838_ = bitcast<f32>(((_e128 & 2147483648u) | select(_e468, 0u, select(_e441, true, _e462))));
        phi_839_ = bitcast<f32>(((_e123 & 2147483648u) | select(_e422, 0u, select(_e395, true, _e416))));
    } else {
        phi_838_ = 0f;
        phi_839_ = 1f;
    }
    let _e474 = phi_838_;
    let _e476 = phi_839_;
    let _e477 = slimbvh_any_will_do.member;
    if (_e477 == 1u) {
        phi_853_ = SlimbvhTypeK(SlimbvhTypeJ(_e74, _e474), true);
    } else {
        phi_853_ = SlimbvhTypeK(SlimbvhTypeJ(_e74, _e474), false);
    }
    let _e484 = phi_853_;
    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
    phi_863_ = _e484;
    phi_866_ = (_e476 <= _e474);
    phi_868_ = select(0u, 2147483648u, (_e76 == 0u));
    phi_870_ = 0u;
    phi_872_ = ((3u * _e76) + 1u);
    loop {
        let _e491 = phi_863_;
        let _e493 = phi_866_;
        let _e495 = phi_868_;
        let _e497 = phi_870_;
        let _e499 = phi_872_;
        local_3 = _e491;
        if _e493 {
            phi_883_ = true;
        } else {
            phi_883_ = (_e497 > 0u);
        }
        let _e502 = phi_883_;
        if _e502 {
            let _e503 = (_e499 > 0u);
            if _e503 {
                if _e493 {
                    phi_915_ = _e493;
                    phi_916_ = _e495;
                    phi_917_ = _e497;
                } else {
                    let _e504 = (_e497 - 1u);
                    let _e505 = (_e504 % 128u);
                    let _e507 = local_1[_e505];
                    let _e509 = local[_e505];
                    phi_915_ = (_e509 <= _e491.member.member_1);
                    phi_916_ = _e507;
                    phi_917_ = _e504;
                }
                let _e514 = phi_915_;
                let _e516 = phi_916_;
                let _e518 = phi_917_;
                if _e514 {
                    if ((_e516 & 2147483648u) != 0u) {
                        phi_932_ = _e491;
                        phi_935_ = SlimbvhTypeA(0u, ((_e516 >> bitcast<u32>(28u)) & 7u));
                        loop {
                            let _e711 = phi_932_;
                            let _e713 = phi_935_;
                            local_2 = _e711;
                            local_4 = _e711;
                            if (_e713.member < _e713.member_1) {
                                phi_936_ = SlimbvhTypeA((_e713.member + 1u), _e713.member_1);
                                phi_958_ = SlimbvhTypeA(1u, _e713.member);
                            } else {
                                phi_936_ = _e713;
                                phi_958_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                            }
                            let _e726 = phi_936_;
                            let _e728 = phi_958_;
                            let _e732 = (bitcast<i32>(_e728.member) != 0i);
                            if _e732 {
                                let _e733 = ((_e516 & 268435455u) + _e728.member_1);
                                if (_e733 < _e78) {
                                    let _e738 = slimbvh_triangles.member[_e733].member_1;
                                    phi_979_ = _e738;
                                } else {
                                    phi_979_ = 4294967295u;
                                }
                                let _e740 = phi_979_;
                                if (_e733 >= _e78) {
                                    phi_1071_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                } else {
                                    let _e742 = (_e171 % 3u);
                                    let _e743 = (_e170 % 3u);
                                    let _e744 = (_e172 % 3u);
                                    let _e749 = slimbvh_triangles.member[_e733].member[_e742];
                                    let _e754 = slimbvh_triangles.member[_e733].member[_e743];
                                    let _e759 = slimbvh_triangles.member[_e733].member[_e744];
                                    let _e766 = slimbvh_triangles.member[_e733].member[(3u + _e742)];
                                    let _e772 = slimbvh_triangles.member[_e733].member[(3u + _e743)];
                                    let _e778 = slimbvh_triangles.member[_e733].member[(3u + _e744)];
                                    let _e785 = slimbvh_triangles.member[_e733].member[(6u + _e742)];
                                    let _e791 = slimbvh_triangles.member[_e733].member[(6u + _e743)];
                                    let _e797 = slimbvh_triangles.member[_e733].member[(6u + _e744)];
                                    phi_1071_ = array<array<f32, 3>, 3>(array<f32, 3>(_e749, _e754, _e759), array<f32, 3>(_e766, _e772, _e778), array<f32, 3>(_e785, _e791, _e797));
                                }
                                let _e801 = phi_1071_;
                                let _e818 = (_e801[0][2] - _e338);
                                let _e821 = (((_e801[0][0] - _e226) * _e369) - (_e818 * _e257));
                                let _e824 = (((_e801[0][1] - _e282) * _e369) - (_e818 * _e313));
                                let _e827 = (_e801[1][2] - _e338);
                                let _e830 = (((_e801[1][0] - _e226) * _e369) - (_e827 * _e257));
                                let _e833 = (((_e801[1][1] - _e282) * _e369) - (_e827 * _e313));
                                let _e836 = (_e801[2][2] - _e338);
                                let _e839 = (((_e801[2][0] - _e226) * _e369) - (_e836 * _e257));
                                let _e842 = (((_e801[2][1] - _e282) * _e369) - (_e836 * _e313));
                                let _e843 = (_e839 * _e833);
                                let _e844 = (_e842 * _e830);
                                let _e845 = (_e821 * _e842);
                                let _e846 = (_e824 * _e839);
                                let _e847 = (_e830 * _e824);
                                let _e848 = (_e833 * _e821);
                                let _e853 = (((_e843 >= _e844) && (_e845 >= _e846)) && (_e847 >= _e848));
                                let _e859 = (_e853 || (((_e843 <= _e844) && (_e845 <= _e846)) && (_e847 <= _e848)));
                                if _e859 {
                                    let _e861 = select(-1f, 1f, _e853);
                                    let _e863 = ((_e843 - _e844) * _e861);
                                    let _e865 = select(0f, _e863, (_e863 > 0f));
                                    let _e867 = ((_e845 - _e846) * _e861);
                                    let _e869 = select(0f, _e867, (_e867 > 0f));
                                    let _e871 = ((_e847 - _e848) * _e861);
                                    let _e873 = select(0f, _e871, (_e871 > 0f));
                                    let _e875 = ((_e865 + _e869) + _e873);
                                    let _e877 = select(_e801[1][0], _e801[0][0], (_e801[0][0] < _e801[1][0]));
                                    let _e881 = select(_e801[1][0], _e801[0][0], (_e801[0][0] > _e801[1][0]));
                                    let _e885 = select(_e801[1][1], _e801[0][1], (_e801[0][1] < _e801[1][1]));
                                    let _e889 = select(_e801[1][1], _e801[0][1], (_e801[0][1] > _e801[1][1]));
                                    let _e893 = select(_e801[1][2], _e801[0][2], (_e801[0][2] < _e801[1][2]));
                                    let _e897 = select(_e801[1][2], _e801[0][2], (_e801[0][2] > _e801[1][2]));
                                    let _e902 = ((select(_e801[2][0], _e877, (_e877 < _e801[2][0])) - _e258) * _e261);
                                    let _e903 = ((select(_e801[2][0], _e881, (_e881 > _e801[2][0])) - _e259) * _e261);
                                    let _e906 = ((select(_e801[2][1], _e885, (_e885 < _e801[2][1])) - _e314) * _e317);
                                    let _e907 = ((select(_e801[2][1], _e889, (_e889 > _e801[2][1])) - _e315) * _e317);
                                    let _e910 = ((select(_e801[2][2], _e893, (_e893 < _e801[2][2])) - _e370) * _e373);
                                    let _e911 = ((select(_e801[2][2], _e897, (_e897 > _e801[2][2])) - _e371) * _e373);
                                    let _e913 = select(_e911, _e910, (_e910 < _e911));
                                    let _e915 = select(_e911, _e910, (_e910 > _e911));
                                    let _e917 = select(_e903, _e902, (_e902 < _e903));
                                    let _e919 = select(_e907, _e906, (_e906 < _e907));
                                    let _e921 = select(_e919, _e917, (_e917 > _e919));
                                    let _e923 = select(_e913, _e921, (_e921 > _e913));
                                    let _e925 = select(_e903, _e902, (_e902 > _e903));
                                    let _e927 = select(_e907, _e906, (_e906 > _e907));
                                    let _e929 = select(_e927, _e925, (_e925 < _e927));
                                    let _e931 = select(_e915, _e929, (_e929 < _e915));
                                    let _e932 = -(_e913);
                                    let _e938 = select(_e476, _e923, (_e923 > _e476));
                                    let _e942 = select(_e830, _e821, (_e821 < _e830));
                                    let _e947 = select(_e830, _e821, (_e821 > _e830));
                                    let _e954 = select(_e833, _e824, (_e824 < _e833));
                                    let _e959 = select(_e833, _e824, (_e824 > _e833));
                                    let _e968 = (((((_e859 && (_e875 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e839, _e942, (_e942 < _e839)) <= 0f) && (select(_e839, _e947, (_e947 > _e839)) >= 0f))) && ((select(_e842, _e954, (_e954 < _e842)) <= 0f) && (select(_e842, _e959, (_e959 > _e842)) >= 0f))) && (_e938 <= (_e931 + (select(_e932, _e915, (_e915 > _e932)) * 0.0000019073523f)))) && (_e938 <= _e711.member.member_1));
                                    if _e968 {
                                        let _e973 = (_e801[1][0] - _e801[0][0]);
                                        let _e974 = (_e801[1][1] - _e801[0][1]);
                                        let _e975 = (_e801[1][2] - _e801[0][2]);
                                        let _e976 = vec3<f32>(_e973, _e974, _e975);
                                        let _e977 = (_e801[2][0] - _e801[1][0]);
                                        let _e978 = (_e801[2][1] - _e801[1][1]);
                                        let _e979 = (_e801[2][2] - _e801[1][2]);
                                        let _e980 = vec3<f32>(_e977, _e978, _e979);
                                        let _e981 = (_e801[0][0] - _e801[2][0]);
                                        let _e982 = (_e801[0][1] - _e801[2][1]);
                                        let _e983 = (_e801[0][2] - _e801[2][2]);
                                        let _e984 = vec3<f32>(_e981, _e982, _e983);
                                        let _e987 = bitcast<f32>((bitcast<u32>(_e973) & 2147483647u));
                                        let _e990 = bitcast<f32>((bitcast<u32>(_e974) & 2147483647u));
                                        let _e992 = select(_e990, _e987, (_e987 > _e990));
                                        let _e995 = bitcast<f32>((bitcast<u32>(_e975) & 2147483647u));
                                        let _e997 = select(_e995, _e992, (_e992 > _e995));
                                        let _e1000 = bitcast<f32>((bitcast<u32>(_e977) & 2147483647u));
                                        let _e1003 = bitcast<f32>((bitcast<u32>(_e978) & 2147483647u));
                                        let _e1005 = select(_e1003, _e1000, (_e1000 > _e1003));
                                        let _e1008 = bitcast<f32>((bitcast<u32>(_e979) & 2147483647u));
                                        let _e1010 = select(_e1008, _e1005, (_e1005 > _e1008));
                                        let _e1013 = bitcast<f32>((bitcast<u32>(_e981) & 2147483647u));
                                        let _e1016 = bitcast<f32>((bitcast<u32>(_e982) & 2147483647u));
                                        let _e1018 = select(_e1016, _e1013, (_e1013 > _e1016));
                                        let _e1021 = bitcast<f32>((bitcast<u32>(_e983) & 2147483647u));
                                        let _e1023 = select(_e1021, _e1018, (_e1018 > _e1021));
                                        let _e1025 = select(_e1010, _e997, (_e997 > _e1010));
                                        let _e1027 = select(_e1023, _e1025, (_e1025 > _e1023));
                                        if (_e997 == _e1027) {
                                            phi_1601_ = _e833;
                                            phi_1602_ = _e830;
                                            phi_1603_ = _e824;
                                            phi_1604_ = _e821;
                                            phi_1605_ = vec3<f32>(_e801[0][0], _e801[0][1], _e801[0][2]);
                                            phi_1606_ = _e984;
                                            phi_1607_ = _e980;
                                            phi_1608_ = _e976;
                                        } else {
                                            let _e1029 = (_e1010 == _e1027);
                                            let _e1034 = vec3(_e1029);
                                            phi_1601_ = select(_e824, _e842, _e1029);
                                            phi_1602_ = select(_e821, _e839, _e1029);
                                            phi_1603_ = select(_e842, _e833, _e1029);
                                            phi_1604_ = select(_e839, _e830, _e1029);
                                            phi_1605_ = select(vec3<f32>(_e801[2][0], _e801[2][1], _e801[2][2]), vec3<f32>(_e801[1][0], _e801[1][1], _e801[1][2]), _e1034);
                                            phi_1606_ = select(_e980, _e976, _e1034);
                                            phi_1607_ = select(_e976, _e984, _e1034);
                                            phi_1608_ = select(_e984, _e980, _e1034);
                                        }
                                        let _e1040 = phi_1601_;
                                        let _e1042 = phi_1602_;
                                        let _e1044 = phi_1603_;
                                        let _e1046 = phi_1604_;
                                        let _e1048 = phi_1605_;
                                        let _e1050 = phi_1606_;
                                        let _e1052 = phi_1607_;
                                        let _e1054 = phi_1608_;
                                        let _e1061 = ((_e1052.y * _e1050.z) - (_e1050.y * _e1052.z));
                                        let _e1066 = ((_e1052.z * _e1050.x) - (_e1050.z * _e1052.x));
                                        let _e1069 = ((_e1052.x * _e1050.y) - (_e1050.x * _e1052.y));
                                        let _e1072 = ((_e865 >= _e869) && (_e865 >= _e873));
                                        let _e1073 = (_e869 >= _e873);
                                        let _e1087 = (((_e1061 * (select(select(_e801[2][0], _e801[1][0], _e1073), _e801[0][0], _e1072) - _e226)) + (_e1066 * (select(select(_e801[2][1], _e801[1][1], _e1073), _e801[0][1], _e1072) - _e282))) + (_e1069 * (select(select(_e801[2][2], _e801[1][2], _e1073), _e801[0][2], _e1072) - _e338)));
                                        let _e1092 = (((_e1061 * _e257) + (_e1066 * _e313)) + (_e1069 * _e369));
                                        let _e1093 = (_e1042 - _e1046);
                                        let _e1094 = (_e1040 - _e1044);
                                        let _e1097 = ((_e1093 * _e1093) + (_e1094 * _e1094));
                                        let _e1104 = (-(((_e1046 * _e1093) + (_e1044 * _e1094))) / select(0.000000000000000000000000000000000000011754944f, _e1097, (_e1097 > 0.000000000000000000000000000000000000011754944f)));
                                        let _e1106 = select(1f, _e1104, (_e1104 < 1f));
                                        let _e1108 = select(0f, _e1106, (_e1106 > 0f));
                                        let _e1117 = ((_e1048.x + (_e1054.x * _e1108)) - _e226);
                                        let _e1120 = ((_e1048.y + (_e1054.y * _e1108)) - _e282);
                                        let _e1123 = ((_e1048.z + (_e1054.z * _e1108)) - _e338);
                                        let _e1126 = bitcast<f32>((bitcast<u32>(_e1117) & 2147483647u));
                                        let _e1129 = bitcast<f32>((bitcast<u32>(_e1120) & 2147483647u));
                                        let _e1131 = select(_e1129, _e1126, (_e1126 > _e1129));
                                        let _e1134 = bitcast<f32>((bitcast<u32>(_e1123) & 2147483647u));
                                        let _e1136 = select(_e1134, _e1131, (_e1131 > _e1134));
                                        let _e1142 = bitcast<f32>((bitcast<u32>(_e1061) & 2147483647u));
                                        let _e1145 = bitcast<f32>((bitcast<u32>(_e1066) & 2147483647u));
                                        let _e1147 = select(_e1145, _e1142, (_e1142 > _e1145));
                                        let _e1150 = bitcast<f32>((bitcast<u32>(_e1069) & 2147483647u));
                                        let _e1169 = bitcast<f32>((bitcast<u32>(_e1052.x) & 2147483647u));
                                        let _e1172 = bitcast<f32>((bitcast<u32>(_e1052.y) & 2147483647u));
                                        let _e1174 = select(_e1172, _e1169, (_e1169 > _e1172));
                                        let _e1177 = bitcast<f32>((bitcast<u32>(_e1052.z) & 2147483647u));
                                        let _e1183 = bitcast<f32>((bitcast<u32>(_e1050.x) & 2147483647u));
                                        let _e1186 = bitcast<f32>((bitcast<u32>(_e1050.y) & 2147483647u));
                                        let _e1188 = select(_e1186, _e1183, (_e1183 > _e1186));
                                        let _e1191 = bitcast<f32>((bitcast<u32>(_e1050.z) & 2147483647u));
                                        let _e1197 = ((bitcast<f32>((bitcast<u32>(((((_e1061 * _e1117) + (_e1066 * _e1120)) + (_e1069 * _e1123)) - _e1087)) & 2147483647u)) <= ((0.0000009536743f * select(_e1027, _e1136, (_e1136 > _e1027))) * select(_e1150, _e1147, (_e1147 > _e1150)))) && !((bitcast<f32>((bitcast<u32>(_e1092) & 2147483647u)) <= ((0.0000038146973f * select(_e1177, _e1174, (_e1174 > _e1177))) * select(_e1191, _e1188, (_e1188 > _e1191))))));
                                        let _e1198 = (_e1087 / _e1092);
                                        if (_e968 && !(_e1197)) {
                                            let _e1201 = (_e1123 / _e369);
                                            let _e1209 = (((_e1061 * (_e1117 - (_e257 * _e1201))) + (_e1066 * (_e1120 - (_e313 * _e1201)))) / _e1092);
                                            phi_1799_ = select(select(_e1201, (_e1201 + _e1209), (bitcast<f32>((bitcast<u32>(_e1209) & 2147483647u)) <= _e1027)), _e1198, _e1197);
                                        } else {
                                            phi_1799_ = _e1198;
                                        }
                                        let _e1218 = phi_1799_;
                                        let _e1220 = select(_e931, _e1218, (_e1218 < _e931));
                                        let _e1222 = select(_e923, _e1220, (_e1220 > _e923));
                                        let _e1223 = (1f / _e875);
                                        phi_1819_ = SlimbvhTypeL(_e1222, (_e869 * _e1223), (_e873 * _e1223), ((_e968 && (_e1222 >= _e476)) && (_e1222 <= _e711.member.member_1)));
                                        phi_1820_ = SlimbvhTypeL();
                                    } else {
                                        phi_1819_ = SlimbvhTypeL();
                                        phi_1820_ = SlimbvhTypeL(0f, 0f, 0f, _e968);
                                    }
                                    let _e1232 = phi_1819_;
                                    let _e1234 = phi_1820_;
                                    phi_1823_ = _e1232;
                                    phi_1824_ = _e1234;
                                    phi_1825_ = select(true, false, _e968);
                                } else {
                                    phi_1823_ = SlimbvhTypeL();
                                    phi_1824_ = SlimbvhTypeL(0f, 0f, 0f, _e859);
                                    phi_1825_ = true;
                                }
                                let _e1237 = phi_1823_;
                                let _e1239 = phi_1824_;
                                let _e1241 = phi_1825_;
                                if _e1241 {
                                    phi_1829_ = _e1239;
                                } else {
                                    phi_1829_ = _e1237;
                                }
                                let _e1243 = phi_1829_;
                                if _e1243.member_3 {
                                    phi_1838_ = SlimbvhTypeE(_e1243.member, _e1243.member_1, _e1243.member_2, _e740);
                                } else {
                                    phi_1838_ = _e74;
                                }
                                let _e1250 = phi_1838_;
                                if (_e1250.member_3 != 4294967295u) {
                                    if (_e740 != 4294967295u) {
                                        if (_e1250.member < _e711.member.member.member) {
                                            phi_1864_ = true;
                                        } else {
                                            if (_e1250.member == _e711.member.member.member) {
                                                phi_1863_ = (_e1250.member_3 < _e711.member.member.member_3);
                                            } else {
                                                phi_1863_ = false;
                                            }
                                            let _e1265 = phi_1863_;
                                            phi_1864_ = _e1265;
                                        }
                                        let _e1267 = phi_1864_;
                                        if _e1267 {
                                            phi_1871_ = SlimbvhTypeK(SlimbvhTypeJ(_e1250, _e1250.member), _e711.member_1);
                                        } else {
                                            phi_1871_ = _e711;
                                        }
                                        let _e1273 = phi_1871_;
                                        if _e1273.member_1 {
                                            phi_1877_ = SlimbvhTypeK(SlimbvhTypeJ(_e1273.member.member, bitcast<f32>(4286578687u)), _e1273.member_1);
                                        } else {
                                            phi_1877_ = _e1273;
                                        }
                                        let _e1282 = phi_1877_;
                                        phi_1878_ = _e1282;
                                    } else {
                                        phi_1878_ = _e711;
                                    }
                                    let _e1284 = phi_1878_;
                                    phi_1879_ = _e1284;
                                } else {
                                    phi_1879_ = _e711;
                                }
                                let _e1286 = phi_1879_;
                                phi_933_ = _e1286;
                            } else {
                                phi_933_ = SlimbvhTypeK();
                            }
                            let _e1288 = phi_933_;
                            continue;
                            continuing {
                                phi_932_ = _e1288;
                                phi_935_ = _e726;
                                break if !(_e732);
                            }
                        }
                        let _e1291 = local_2;
                        let _e1541 = local_4;
                        phi_2356_ = _e1541;
                        phi_2357_ = false;
                        phi_2358_ = _e516;
                        phi_2359_ = select(_e518, 0u, (_e476 > _e1291.member.member_1));
                    } else {
                        if (_e516 >= _e76) {
                            phi_1944_ = SlimbvhTypeM(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                        } else {
                            let _e532 = slimbvh_nodes.member[_e516].member[(_e171 % 3u)];
                            let _e543 = slimbvh_nodes.member[_e516].member[(_e170 % 3u)];
                            let _e554 = slimbvh_nodes.member[_e516].member[(_e172 % 3u)];
                            let _e564 = slimbvh_nodes.member[_e516].member_1;
                            let _e568 = slimbvh_nodes.member[_e516].member_2;
                            phi_1944_ = SlimbvhTypeM(array<vec4<f32>, 3>(vec4<f32>(_e532[0], _e532[1], _e532[2], _e532[3]), vec4<f32>(_e543[0], _e543[1], _e543[2], _e543[3]), vec4<f32>(_e554[0], _e554[1], _e554[2], _e554[3])), _e564, _e568);
                        }
                        let _e571 = phi_1944_;
                        let _e584 = ((_e571.member[0].x - _e258) * _e261);
                        let _e585 = ((_e571.member[0].y - _e258) * _e261);
                        let _e586 = ((_e571.member[0].z - _e259) * _e261);
                        let _e587 = ((_e571.member[0].w - _e259) * _e261);
                        let _e597 = ((_e571.member[1].x - _e314) * _e317);
                        let _e598 = ((_e571.member[1].y - _e314) * _e317);
                        let _e599 = ((_e571.member[1].z - _e315) * _e317);
                        let _e600 = ((_e571.member[1].w - _e315) * _e317);
                        let _e610 = ((_e571.member[2].x - _e370) * _e373);
                        let _e611 = ((_e571.member[2].y - _e370) * _e373);
                        let _e612 = ((_e571.member[2].z - _e371) * _e373);
                        let _e613 = ((_e571.member[2].w - _e371) * _e373);
                        let _e615 = select(_e612, _e610, (_e610 < _e612));
                        let _e617 = select(_e613, _e611, (_e611 < _e613));
                        let _e619 = select(_e612, _e610, (_e610 > _e612));
                        let _e621 = select(_e613, _e611, (_e611 > _e613));
                        let _e623 = select(_e586, _e584, (_e584 < _e586));
                        let _e625 = select(_e587, _e585, (_e585 < _e587));
                        let _e627 = select(_e599, _e597, (_e597 < _e599));
                        let _e629 = select(_e600, _e598, (_e598 < _e600));
                        let _e631 = select(_e627, _e623, (_e623 > _e627));
                        let _e633 = select(_e629, _e625, (_e625 > _e629));
                        let _e635 = select(_e615, _e631, (_e631 > _e615));
                        let _e637 = select(_e617, _e633, (_e633 > _e617));
                        let _e639 = select(_e586, _e584, (_e584 > _e586));
                        let _e641 = select(_e587, _e585, (_e585 > _e587));
                        let _e643 = select(_e599, _e597, (_e597 > _e599));
                        let _e645 = select(_e600, _e598, (_e598 > _e600));
                        let _e647 = select(_e643, _e639, (_e639 < _e643));
                        let _e649 = select(_e645, _e641, (_e641 < _e645));
                        let _e654 = -(_e615);
                        let _e655 = -(_e617);
                        let _e662 = (select(_e619, _e647, (_e647 < _e619)) + (select(_e654, _e619, (_e619 > _e654)) * 0.0000019073523f));
                        let _e663 = (select(_e621, _e649, (_e649 < _e621)) + (select(_e655, _e621, (_e621 > _e655)) * 0.0000019073523f));
                        let _e665 = select(_e476, _e635, (_e635 > _e476));
                        let _e667 = select(_e476, _e637, (_e637 > _e476));
                        let _e672 = (_e665 <= select(_e491.member.member_1, _e662, (_e662 < _e491.member.member_1)));
                        let _e673 = (_e667 <= select(_e491.member.member_1, _e663, (_e663 < _e491.member.member_1)));
                        let _e674 = (_e665 <= _e667);
                        if _e672 {
                            if _e673 {
                                if _e674 {
                                    phi_2306_ = _e571.member_2;
                                } else {
                                    phi_2306_ = _e571.member_1;
                                }
                                let _e678 = phi_2306_;
                                let _e680 = (_e518 % 128u);
                                local_1[_e680] = _e678;
                                local[_e680] = select(_e665, _e667, _e674);
                                if _e674 {
                                    phi_2333_ = _e571.member_1;
                                } else {
                                    phi_2333_ = _e571.member_2;
                                }
                                let _e687 = phi_2333_;
                                phi_2334_ = _e687;
                                phi_2335_ = (_e518 + 1u);
                            } else {
                                phi_2334_ = u32();
                                phi_2335_ = u32();
                            }
                            let _e689 = phi_2334_;
                            let _e691 = phi_2335_;
                            phi_2337_ = _e689;
                            phi_2338_ = _e691;
                            phi_2339_ = select(true, false, _e673);
                        } else {
                            phi_2337_ = u32();
                            phi_2338_ = u32();
                            phi_2339_ = true;
                        }
                        let _e694 = phi_2337_;
                        let _e696 = phi_2338_;
                        let _e698 = phi_2339_;
                        if _e698 {
                            if _e672 {
                                phi_2348_ = _e571.member_1;
                            } else {
                                phi_2348_ = _e571.member_2;
                            }
                            let _e702 = phi_2348_;
                            phi_2353_ = select(_e673, true, _e672);
                            phi_2354_ = _e702;
                        } else {
                            phi_2353_ = _e514;
                            phi_2354_ = _e694;
                        }
                        let _e705 = phi_2353_;
                        let _e707 = phi_2354_;
                        phi_2356_ = _e491;
                        phi_2357_ = _e705;
                        phi_2358_ = _e707;
                        phi_2359_ = select(_e696, _e518, _e698);
                    }
                    let _e1297 = phi_2356_;
                    let _e1299 = phi_2357_;
                    let _e1301 = phi_2358_;
                    let _e1303 = phi_2359_;
                    phi_2360_ = _e1297;
                    phi_2361_ = _e1299;
                    phi_2362_ = _e1301;
                    phi_2363_ = _e1303;
                    phi_2364_ = (_e499 - 1u);
                } else {
                    phi_2360_ = _e491;
                    phi_2361_ = _e514;
                    phi_2362_ = _e516;
                    phi_2363_ = _e518;
                    phi_2364_ = _e499;
                }
                let _e1305 = phi_2360_;
                let _e1307 = phi_2361_;
                let _e1309 = phi_2362_;
                let _e1311 = phi_2363_;
                let _e1313 = phi_2364_;
                phi_2365_ = _e1305;
                phi_2366_ = _e1307;
                phi_2367_ = _e1309;
                phi_2368_ = _e1311;
                phi_2369_ = _e1313;
            } else {
                phi_2365_ = SlimbvhTypeK();
                phi_2366_ = bool();
                phi_2367_ = u32();
                phi_2368_ = u32();
                phi_2369_ = u32();
            }
            let _e1315 = phi_2365_;
            let _e1317 = phi_2366_;
            let _e1319 = phi_2367_;
            let _e1321 = phi_2368_;
            let _e1323 = phi_2369_;
            phi_864_ = _e1315;
            phi_867_ = _e1317;
            phi_869_ = _e1319;
            phi_871_ = _e1321;
            phi_873_ = _e1323;
            phi_2370_ = _e503;
        } else {
            phi_864_ = SlimbvhTypeK();
            phi_867_ = bool();
            phi_869_ = u32();
            phi_871_ = u32();
            phi_873_ = u32();
            phi_2370_ = false;
        }
        let _e1325 = phi_864_;
        let _e1327 = phi_867_;
        let _e1329 = phi_869_;
        let _e1331 = phi_871_;
        let _e1333 = phi_873_;
        let _e1335 = phi_2370_;
        continue;
        continuing {
            phi_863_ = _e1325;
            phi_866_ = _e1327;
            phi_868_ = _e1329;
            phi_870_ = _e1331;
            phi_872_ = _e1333;
            break if !(_e1335);
        }
    }
    let _e1338 = local_3;
    if (_e1338.member.member.member_3 != 4294967295u) {
        let _e1344 = -(_e378);
        let _e1345 = bitcast<u32>(_e1338.member.member.member);
        let _e1349 = (bitcast<i32>((_e1345 >> bitcast<u32>(23i))) & 255i);
        let _e1350 = (_e1349 + _e1344);
        if (_e1349 == 255i) {
            phi_2429_ = _e1338.member.member.member;
        } else {
            if (_e1349 > 0i) {
                if (_e1350 > 0i) {
                    let _e1354 = (_e1350 < 255i);
                    if _e1354 {
                        phi_2408_ = bitcast<f32>((_e1345 + bitcast<u32>((_e1344 << bitcast<u32>(23i)))));
                    } else {
                        phi_2408_ = f32();
                    }
                    let _e1361 = phi_2408_;
                    phi_2410_ = _e1361;
                    phi_2411_ = select(true, false, _e1354);
                } else {
                    phi_2410_ = f32();
                    phi_2411_ = true;
                }
                let _e1364 = phi_2410_;
                let _e1366 = phi_2411_;
                phi_2412_ = _e1364;
                phi_2413_ = _e1366;
            } else {
                phi_2412_ = f32();
                phi_2413_ = true;
            }
            let _e1368 = phi_2412_;
            let _e1370 = phi_2413_;
            if _e1370 {
                let _e1371 = (_e1345 & 2147483648u);
                let _e1378 = ((_e1345 & 8388607u) | (select(0u, 1u, ((_e1345 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e1382 = (_e1378 == 0u);
                if _e1382 {
                    phi_2772_ = bitcast<f32>(_e1371);
                } else {
                    let _e1387 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1378)), 32u, _e1382) - 8u);
                    let _e1390 = (_e1378 << bitcast<u32>((_e1387 & 31u)));
                    let _e1392 = ((_e1350 + select(0i, 1i, (_e1349 == 0i))) - bitcast<i32>(_e1387));
                    if (_e1392 >= 255i) {
                        phi_2762_ = bitcast<f32>((_e1371 | 2139095040u));
                        phi_2763_ = f32();
                        phi_2764_ = true;
                    } else {
                        let _e1394 = (_e1392 > 0i);
                        if _e1394 {
                            phi_2756_ = bitcast<f32>(((_e1371 | (bitcast<u32>(_e1392) << bitcast<u32>(23i))) | (_e1390 & 8388607u)));
                            phi_2757_ = f32();
                        } else {
                            if (_e1392 < -24i) {
                                phi_2722_ = 26u;
                            } else {
                                phi_2722_ = bitcast<u32>((1i - _e1392));
                            }
                            let _e1399 = phi_2722_;
                            let _e1400 = (_e1399 & 31u);
                            let _e1402 = (_e1390 >> bitcast<u32>(_e1400));
                            let _e1406 = (_e1390 & ((1u << bitcast<u32>(_e1400)) - 1u));
                            let _e1410 = (1u << bitcast<u32>(((_e1399 - 1u) & 31u)));
                            if (_e1406 > _e1410) {
                                phi_2743_ = true;
                            } else {
                                if (_e1406 == _e1410) {
                                    phi_2740_ = ((_e1402 & 1u) == 1u);
                                } else {
                                    phi_2740_ = false;
                                }
                                let _e1416 = phi_2740_;
                                phi_2743_ = _e1416;
                            }
                            let _e1418 = phi_2743_;
                            phi_2756_ = f32();
                            phi_2757_ = bitcast<f32>((_e1371 | (_e1402 + select(0u, 1u, _e1418))));
                        }
                        let _e1431 = phi_2756_;
                        let _e1433 = phi_2757_;
                        phi_2762_ = _e1431;
                        phi_2763_ = _e1433;
                        phi_2764_ = _e1394;
                    }
                    let _e1437 = phi_2762_;
                    let _e1439 = phi_2763_;
                    let _e1441 = phi_2764_;
                    phi_2772_ = select(_e1439, _e1437, _e1441);
                }
                let _e1445 = phi_2772_;
                phi_2428_ = _e1445;
            } else {
                phi_2428_ = _e1368;
            }
            let _e1447 = phi_2428_;
            phi_2429_ = _e1447;
        }
        let _e1449 = phi_2429_;
        let _e1450 = bitcast<u32>(_e1449);
        if ((_e1450 & 2147483647u) >= 2139095040u) {
            phi_2441_ = bitcast<f32>(((_e1450 & 2147483648u) | 2139095039u));
        } else {
            phi_2441_ = _e1449;
        }
        let _e1457 = phi_2441_;
        phi_2446_ = SlimbvhTypeE(_e1457, _e1338.member.member.member_1, _e1338.member.member.member_2, _e1338.member.member.member_3);
    } else {
        phi_2446_ = _e74;
    }
    let _e1462 = phi_2446_;
    slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1462.member), bitcast<u32>(_e1462.member_1), bitcast<u32>(_e1462.member_2), _e1462.member_3);
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
