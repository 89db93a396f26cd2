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
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
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
    var phi_257_: i32;
    var phi_258_: i32;
    var phi_268_: bool;
    var phi_278_: u32;
    var phi_279_: u32;
    var phi_281_: bool;
    var phi_286_: u32;
    var phi_299_: i32;
    var phi_319_: i32;
    var phi_744_: i32;
    var phi_766_: u32;
    var phi_767_: u32;
    var phi_802_: i32;
    var phi_824_: u32;
    var phi_825_: u32;
    var phi_833_: f32;
    var phi_834_: f32;
    var phi_848_: SlimbvhTypeI;
    var phi_2920_: bool;
    var phi_861_: SlimbvhTypeI;
    var phi_864_: u32;
    var phi_866_: i32;
    var phi_868_: u32;
    var phi_877_: u32;
    var phi_880_: i32;
    var phi_882_: u32;
    var phi_972_: SlimbvhTypeJ;
    var phi_1396_: u32;
    var phi_1335_: u32;
    var phi_1346_: u32;
    var phi_1369_: i32;
    var phi_1397_: u32;
    var phi_1398_: i32;
    var phi_1405_: u32;
    var phi_1406_: i32;
    var phi_1407_: u32;
    var phi_878_: u32;
    var phi_881_: i32;
    var phi_883_: u32;
    var phi_1409_: bool;
    var phi_2917_: bool;
    var local_2: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1423_: SlimbvhTypeI;
    var phi_1426_: SlimbvhTypeA;
    var phi_1427_: SlimbvhTypeA;
    var phi_1449_: SlimbvhTypeA;
    var phi_1533_: array<vec4<f32>, 3>;
    var phi_1534_: array<vec4<f32>, 3>;
    var phi_1537_: u32;
    var phi_1609_: array<vec4<f32>, 3>;
    var phi_1610_: array<vec4<f32>, 3>;
    var phi_1633_: array<f32, 3>;
    var phi_1634_: array<f32, 3>;
    var phi_1648_: array<f32, 3>;
    var phi_1649_: array<f32, 3>;
    var phi_1663_: array<f32, 3>;
    var phi_1664_: array<f32, 3>;
    var phi_2188_: f32;
    var phi_2189_: f32;
    var phi_2190_: f32;
    var phi_2191_: f32;
    var phi_2192_: vec3<f32>;
    var phi_2193_: vec3<f32>;
    var phi_2194_: vec3<f32>;
    var phi_2195_: vec3<f32>;
    var phi_2386_: f32;
    var phi_2406_: SlimbvhTypeK;
    var phi_2407_: SlimbvhTypeK;
    var phi_2410_: SlimbvhTypeK;
    var phi_2411_: SlimbvhTypeK;
    var phi_2412_: bool;
    var phi_2416_: SlimbvhTypeK;
    var phi_2425_: SlimbvhTypeC;
    var phi_2450_: bool;
    var phi_2451_: bool;
    var phi_2458_: SlimbvhTypeI;
    var phi_2464_: SlimbvhTypeI;
    var phi_2465_: SlimbvhTypeI;
    var phi_2466_: SlimbvhTypeI;
    var phi_1424_: SlimbvhTypeI;
    var phi_3023_: bool;
    var local_5: i32;
    var local_6: SlimbvhTypeI;
    var phi_2493_: u32;
    var phi_3119_: bool;
    var phi_2500_: SlimbvhTypeI;
    var phi_2501_: u32;
    var phi_2502_: i32;
    var phi_3118_: bool;
    var phi_862_: SlimbvhTypeI;
    var phi_865_: u32;
    var phi_867_: i32;
    var phi_869_: u32;
    var phi_3117_: bool;
    var local_7: SlimbvhTypeI;
    var phi_2536_: f32;
    var phi_2538_: f32;
    var phi_2539_: bool;
    var phi_2540_: f32;
    var phi_2541_: bool;
    var phi_2862_: u32;
    var phi_2880_: bool;
    var phi_2883_: bool;
    var phi_2896_: f32;
    var phi_2897_: f32;
    var phi_2902_: f32;
    var phi_2903_: f32;
    var phi_2904_: bool;
    var phi_2912_: f32;
    var phi_2556_: f32;
    var phi_2557_: f32;
    var phi_2569_: f32;
    var phi_2574_: SlimbvhTypeC;
    var local_8: SlimbvhTypeI;
    var local_9: u32;
    var local_10: i32;
    var local_11: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e73 = arrayLength((&slimbvh_nodes.member));
            let _e75 = arrayLength((&slimbvh_triangles.member));
            let _e80 = slimbvh_origin.member;
            let _e86 = slimbvh_origin.member[3u];
            let _e87 = slimbvh_direction.member;
            let _e93 = slimbvh_direction.member[3u];
            let _e96 = slimbvh_exponent.member[0u];
            let _e97 = bitcast<i32>(_e96);
            let _e99 = (bitcast<u32>(_e87.x) & 2147483647u);
            let _e101 = (bitcast<u32>(_e87.y) & 2147483647u);
            let _e103 = (bitcast<u32>(_e87.z) & 2147483647u);
            let _e105 = (bitcast<u32>(_e80.x) & 2147483647u);
            let _e107 = (bitcast<u32>(_e80.y) & 2147483647u);
            let _e109 = (bitcast<u32>(_e80.z) & 2147483647u);
            let _e111 = select(_e101, _e99, (_e101 < _e99));
            let _e113 = select(_e103, _e111, (_e103 < _e111));
            let _e115 = select(_e105, _e113, (_e105 < _e113));
            let _e117 = select(_e107, _e115, (_e107 < _e115));
            let _e119 = select(_e109, _e117, (_e109 < _e117));
            let _e120 = bitcast<u32>(_e86);
            let _e121 = (_e120 & 2147483647u);
            let _e125 = bitcast<u32>(_e93);
            let _e126 = (_e125 & 2147483647u);
            let _e130 = (((select(_e121, _e119, (_e121 < _e119)) < 2139095040u) && (_e126 <= 2139095040u)) && (_e113 > 0u));
            if _e130 {
                let _e133 = (bitcast<u32>(bitcast<f32>(_e113)) & 2147483647u);
                if (_e133 >= 8388608u) {
                    phi_257_ = (bitcast<i32>((_e133 >> bitcast<u32>(23i))) - 127i);
                } else {
                    phi_257_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e133)), 32u, (_e133 == 0u))));
                }
                let _e147 = phi_257_;
                phi_258_ = _e147;
            } else {
                phi_258_ = 0i;
            }
            let _e149 = phi_258_;
            let _e150 = (_e99 == _e113);
            if _e150 {
                phi_268_ = true;
            } else {
                phi_268_ = (_e101 == _e113);
            }
            let _e153 = phi_268_;
            let _e154 = select(1u, 0u, _e150);
            if _e153 {
                let _e155 = (_e154 + 1u);
                phi_278_ = _e155;
                phi_279_ = _e155;
                phi_281_ = select(true, false, (_e155 == 2u));
            } else {
                phi_278_ = u32();
                phi_279_ = 0u;
                phi_281_ = true;
            }
            let _e159 = phi_278_;
            let _e161 = phi_279_;
            let _e163 = phi_281_;
            if _e163 {
                phi_286_ = (_e161 + 1u);
            } else {
                phi_286_ = 0u;
            }
            let _e167 = phi_286_;
            let _e168 = select(_e159, _e161, _e163);
            let _e169 = select(_e154, select(2u, _e154, _e153), _e163);
            if (_e97 < -126i) {
                phi_299_ = -126i;
            } else {
                phi_299_ = select(_e97, 127i, (_e97 > 127i));
            }
            let _e174 = phi_299_;
            let _e179 = bitcast<f32>((bitcast<u32>((_e174 + 127i)) << bitcast<u32>(23i)));
            let _e185 = bitcast<f32>((bitcast<u32>(((_e97 - _e174) + 127i)) << bitcast<u32>(23i)));
            let _e186 = -(_e149);
            if (_e186 < -126i) {
                phi_319_ = -126i;
            } else {
                phi_319_ = select(_e186, 127i, (_e186 > 127i));
            }
            let _e191 = phi_319_;
            let _e196 = bitcast<f32>((bitcast<u32>((_e191 + 127i)) << bitcast<u32>(23i)));
            let _e202 = bitcast<f32>((bitcast<u32>(((_e186 - _e191) + 127i)) << bitcast<u32>(23i)));
            let _e203 = (_e168 == 0u);
            let _e205 = (_e168 == 2u);
            let _e206 = select(select(_e80.y, _e80.x, _e203), _e80.z, _e205);
            let _e207 = bitcast<u32>(_e206);
            let _e209 = ((_e207 & 2139095040u) != 0u);
            let _e223 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e207 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e207 & 2147483648u))), _e206, _e209) * _e179) * select(0.00000011920929f, 1f, _e209)) * _e185);
            let _e225 = select(select(_e87.y, _e87.x, _e203), _e87.z, _e205);
            let _e226 = bitcast<u32>(_e225);
            let _e228 = ((_e226 & 2139095040u) != 0u);
            let _e242 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e226 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e226 & 2147483648u))), _e225, _e228) * _e196) * select(0.00000011920929f, 1f, _e228)) * _e202);
            let _e246 = (bitcast<f32>((bitcast<u32>(_e242) & 2147483647u)) >= 0.00000000000000000086736174f);
            let _e249 = bitcast<f32>((bitcast<u32>(_e223) & 2147483647u));
            let _e250 = (_e249 * 0.00000011920929f);
            let _e253 = select(select(0.00000000000011368684f, _e250, (_e250 > 0.00000000000011368684f)), 0f, _e246);
            let _e254 = select(0f, _e242, _e246);
            let _e255 = (_e223 + _e253);
            let _e256 = (_e223 - _e253);
            let _e258 = select(38685626000000000000000000f, (1f / _e242), _e246);
            let _e259 = (_e167 == 0u);
            let _e261 = (_e167 == 2u);
            let _e262 = select(select(_e80.y, _e80.x, _e259), _e80.z, _e261);
            let _e263 = bitcast<u32>(_e262);
            let _e265 = ((_e263 & 2139095040u) != 0u);
            let _e279 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e263 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e263 & 2147483648u))), _e262, _e265) * _e179) * select(0.00000011920929f, 1f, _e265)) * _e185);
            let _e281 = select(select(_e87.y, _e87.x, _e259), _e87.z, _e261);
            let _e282 = bitcast<u32>(_e281);
            let _e284 = ((_e282 & 2139095040u) != 0u);
            let _e298 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e282 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e282 & 2147483648u))), _e281, _e284) * _e196) * select(0.00000011920929f, 1f, _e284)) * _e202);
            let _e302 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) >= 0.00000000000000000086736174f);
            let _e305 = bitcast<f32>((bitcast<u32>(_e279) & 2147483647u));
            let _e306 = (_e305 * 0.00000011920929f);
            let _e309 = select(select(0.00000000000011368684f, _e306, (_e306 > 0.00000000000011368684f)), 0f, _e302);
            let _e310 = select(0f, _e298, _e302);
            let _e311 = (_e279 + _e309);
            let _e312 = (_e279 - _e309);
            let _e314 = select(38685626000000000000000000f, (1f / _e298), _e302);
            let _e315 = (_e169 == 0u);
            let _e317 = (_e169 == 2u);
            let _e318 = select(select(_e80.y, _e80.x, _e315), _e80.z, _e317);
            let _e319 = bitcast<u32>(_e318);
            let _e321 = ((_e319 & 2139095040u) != 0u);
            let _e335 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e319 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e319 & 2147483648u))), _e318, _e321) * _e179) * select(0.00000011920929f, 1f, _e321)) * _e185);
            let _e337 = select(select(_e87.y, _e87.x, _e315), _e87.z, _e317);
            let _e338 = bitcast<u32>(_e337);
            let _e340 = ((_e338 & 2139095040u) != 0u);
            let _e354 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e338 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e338 & 2147483648u))), _e337, _e340) * _e196) * select(0.00000011920929f, 1f, _e340)) * _e202);
            let _e358 = (bitcast<f32>((bitcast<u32>(_e354) & 2147483647u)) >= 0.00000000000000000086736174f);
            let _e361 = bitcast<f32>((bitcast<u32>(_e335) & 2147483647u));
            let _e362 = (_e361 * 0.00000011920929f);
            let _e365 = select(select(0.00000000000011368684f, _e362, (_e362 > 0.00000000000011368684f)), 0f, _e358);
            let _e366 = select(0f, _e354, _e358);
            let _e367 = (_e335 + _e365);
            let _e368 = (_e335 - _e365);
            let _e370 = select(38685626000000000000000000f, (1f / _e354), _e358);
            let _e372 = select(_e305, _e249, (_e249 > _e305));
            let _e375 = (_e97 + _e149);
            if (_e130 && (select(_e361, _e372, (_e372 > _e361)) <= 1099511600000f)) {
                let _e385 = ((_e121 & 8388607u) | (select(0u, 1u, ((_e121 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e388 = bitcast<i32>((_e121 >> bitcast<u32>(23i)));
                let _e392 = (_e385 == 0u);
                let _e395 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e385)), 32u, _e392)) - 8i);
                if (_e388 == 255i) {
                    phi_744_ = 255i;
                } else {
                    phi_744_ = (((_e388 + select(0i, 1i, (_e388 == 0i))) - _e395) + _e375);
                }
                let _e403 = phi_744_;
                let _e413 = (_e403 <= 0i);
                if _e413 {
                    phi_767_ = u32();
                } else {
                    if _e392 {
                        phi_766_ = u32();
                    } else {
                        phi_766_ = select(((bitcast<u32>(_e403) << bitcast<u32>(23i)) | ((_e385 << bitcast<u32>(((_e395 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e403 >= 255i));
                    }
                    let _e417 = phi_766_;
                    phi_767_ = _e417;
                }
                let _e419 = phi_767_;
                let _e431 = ((_e126 & 8388607u) | (select(0u, 1u, ((_e126 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e434 = bitcast<i32>((_e126 >> bitcast<u32>(23i)));
                let _e438 = (_e431 == 0u);
                let _e441 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e431)), 32u, _e438)) - 8i);
                if (_e434 == 255i) {
                    phi_802_ = 255i;
                } else {
                    phi_802_ = (((_e434 + select(0i, 1i, (_e434 == 0i))) - _e441) + _e375);
                }
                let _e449 = phi_802_;
                let _e459 = (_e449 <= 0i);
                if _e459 {
                    phi_825_ = u32();
                } else {
                    if _e438 {
                        phi_824_ = u32();
                    } else {
                        phi_824_ = select(((bitcast<u32>(_e449) << bitcast<u32>(23i)) | ((_e431 << bitcast<u32>(((_e441 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e449 >= 255i));
                    }
                    let _e463 = phi_824_;
                    phi_825_ = _e463;
                }
                let _e465 = phi_825_;
                phi_833_ = bitcast<f32>(((_e125 & 2147483648u) | select(_e465, 0u, select(_e438, true, _e459))));
                phi_834_ = bitcast<f32>(((_e120 & 2147483648u) | select(_e419, 0u, select(_e392, true, _e413))));
            } else {
                phi_833_ = 0f;
                phi_834_ = 1f;
            }
            let _e471 = phi_833_;
            let _e473 = phi_834_;
            let _e474 = slimbvh_any_will_do.member;
            if (_e474 == 1u) {
                phi_848_ = SlimbvhTypeI(SlimbvhTypeH(SlimbvhTypeC(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e471), true);
            } else {
                phi_848_ = SlimbvhTypeI(SlimbvhTypeH(SlimbvhTypeC(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e471), false);
            }
            let _e481 = phi_848_;
            local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
            local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
            phi_2920_ = false;
            phi_861_ = _e481;
            phi_864_ = select(0u, 2147483648u, (_e73 == 0u));
            phi_866_ = select(-1i, 0i, (_e473 <= _e471));
            phi_868_ = (_e73 + 1u);
            loop {
                let _e488 = phi_2920_;
                let _e490 = phi_861_;
                let _e492 = phi_864_;
                let _e494 = phi_866_;
                let _e496 = phi_868_;
                local_7 = _e490;
                let _e497 = (_e494 > -1i);
                if _e497 {
                    phi_877_ = _e492;
                    phi_880_ = _e494;
                    phi_882_ = _e496;
                    loop {
                        let _e499 = phi_877_;
                        let _e501 = phi_880_;
                        let _e503 = phi_882_;
                        local_3 = _e499;
                        local_4 = _e499;
                        local_5 = _e501;
                        local_9 = _e499;
                        local_10 = _e501;
                        local_11 = _e503;
                        let _e504 = (_e501 > -1i);
                        local_2 = _e504;
                        if _e504 {
                            let _e506 = ((_e499 & 2147483648u) != 0u);
                            if _e506 {
                                phi_1405_ = u32();
                                phi_1406_ = i32();
                                phi_1407_ = u32();
                            } else {
                                if (_e499 >= _e73) {
                                    phi_972_ = SlimbvhTypeJ(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                } else {
                                    let _e508 = (_e499 < _e73);
                                    if _e508 {
                                    } else {
                                        phi_2917_ = true;
                                        break;
                                    }
                                    let _e513 = slimbvh_nodes.member[_e499][3u][0u];
                                    let _e518 = slimbvh_nodes.member[_e499][3u][1u];
                                    if _e508 {
                                    } else {
                                        phi_2917_ = true;
                                        break;
                                    }
                                    let _e519 = (_e168 % 3u);
                                    if (_e519 < 4u) {
                                    } else {
                                        phi_2917_ = true;
                                        break;
                                    }
                                    let _e524 = slimbvh_nodes.member[_e499][_e519];
                                    if _e508 {
                                    } else {
                                        phi_2917_ = true;
                                        break;
                                    }
                                    let _e525 = (_e167 % 3u);
                                    if (_e525 < 4u) {
                                    } else {
                                        phi_2917_ = true;
                                        break;
                                    }
                                    let _e530 = slimbvh_nodes.member[_e499][_e525];
                                    if _e508 {
                                    } else {
                                        phi_2917_ = true;
                                        break;
                                    }
                                    let _e531 = (_e169 % 3u);
                                    if (_e531 < 4u) {
                                    } else {
                                        phi_2917_ = true;
                                        break;
                                    }
                                    let _e536 = slimbvh_nodes.member[_e499][_e531];
                                    phi_972_ = SlimbvhTypeJ(array<vec4<f32>, 3>(_e524, _e530, _e536), bitcast<u32>(_e513), bitcast<u32>(_e518));
                                }
                                let _e542 = phi_972_;
                                let _e555 = ((_e542.member[0].x - _e255) * _e258);
                                let _e556 = ((_e542.member[0].y - _e255) * _e258);
                                let _e557 = ((_e542.member[0].z - _e256) * _e258);
                                let _e558 = ((_e542.member[0].w - _e256) * _e258);
                                let _e568 = ((_e542.member[1].x - _e311) * _e314);
                                let _e569 = ((_e542.member[1].y - _e311) * _e314);
                                let _e570 = ((_e542.member[1].z - _e312) * _e314);
                                let _e571 = ((_e542.member[1].w - _e312) * _e314);
                                let _e581 = ((_e542.member[2].x - _e367) * _e370);
                                let _e582 = ((_e542.member[2].y - _e367) * _e370);
                                let _e583 = ((_e542.member[2].z - _e368) * _e370);
                                let _e584 = ((_e542.member[2].w - _e368) * _e370);
                                let _e586 = select(_e583, _e581, (_e581 < _e583));
                                let _e588 = select(_e584, _e582, (_e582 < _e584));
                                let _e590 = select(_e583, _e581, (_e581 > _e583));
                                let _e592 = select(_e584, _e582, (_e582 > _e584));
                                let _e594 = select(_e557, _e555, (_e555 < _e557));
                                let _e596 = select(_e558, _e556, (_e556 < _e558));
                                let _e598 = select(_e570, _e568, (_e568 < _e570));
                                let _e600 = select(_e571, _e569, (_e569 < _e571));
                                let _e602 = select(_e598, _e594, (_e594 > _e598));
                                let _e604 = select(_e600, _e596, (_e596 > _e600));
                                let _e606 = select(_e586, _e602, (_e602 > _e586));
                                let _e608 = select(_e588, _e604, (_e604 > _e588));
                                let _e610 = select(_e557, _e555, (_e555 > _e557));
                                let _e612 = select(_e558, _e556, (_e556 > _e558));
                                let _e614 = select(_e570, _e568, (_e568 > _e570));
                                let _e616 = select(_e571, _e569, (_e569 > _e571));
                                let _e618 = select(_e614, _e610, (_e610 < _e614));
                                let _e620 = select(_e616, _e612, (_e612 < _e616));
                                let _e625 = -(_e586);
                                let _e626 = -(_e588);
                                let _e633 = (select(_e590, _e618, (_e618 < _e590)) + (select(_e625, _e590, (_e590 > _e625)) * 0.0000019073523f));
                                let _e634 = (select(_e592, _e620, (_e620 < _e592)) + (select(_e626, _e592, (_e592 > _e626)) * 0.0000019073523f));
                                let _e636 = select(_e473, _e606, (_e606 > _e473));
                                let _e638 = select(_e473, _e608, (_e608 > _e473));
                                let _e643 = (_e636 <= select(_e490.member.member_1, _e633, (_e633 < _e490.member.member_1)));
                                let _e644 = (_e638 <= select(_e490.member.member_1, _e634, (_e634 < _e490.member.member_1)));
                                if (_e643 || _e644) {
                                    let _e660 = (_e643 && ((_e636 <= _e638) || !(_e644)));
                                    if _e660 {
                                        phi_1335_ = _e542.member_1;
                                    } else {
                                        phi_1335_ = _e542.member_2;
                                    }
                                    let _e664 = phi_1335_;
                                    if (_e643 && _e644) {
                                        if _e660 {
                                            phi_1346_ = _e542.member_2;
                                        } else {
                                            phi_1346_ = _e542.member_1;
                                        }
                                        let _e669 = phi_1346_;
                                        let _e672 = (bitcast<u32>(_e501) % 128u);
                                        let _e673 = (_e672 < 128u);
                                        if _e673 {
                                        } else {
                                            phi_2917_ = true;
                                            break;
                                        }
                                        local_1[_e672] = _e669;
                                        if _e673 {
                                        } else {
                                            phi_2917_ = true;
                                            break;
                                        }
                                        local[_e672] = select(_e636, _e638, _e660);
                                        phi_1369_ = (_e501 + 1i);
                                    } else {
                                        phi_1369_ = _e501;
                                    }
                                    let _e678 = phi_1369_;
                                    phi_1397_ = _e664;
                                    phi_1398_ = _e678;
                                } else {
                                    let _e647 = (_e501 - 1i);
                                    let _e649 = (bitcast<u32>(_e647) % 128u);
                                    let _e650 = (_e649 < 128u);
                                    if _e650 {
                                    } else {
                                        phi_2917_ = true;
                                        break;
                                    }
                                    let _e652 = local[_e649];
                                    if (_e652 <= _e490.member.member_1) {
                                        if _e650 {
                                        } else {
                                            phi_2917_ = true;
                                            break;
                                        }
                                        let _e655 = local_1[_e649];
                                        phi_1396_ = _e655;
                                    } else {
                                        phi_1396_ = 2147483648u;
                                    }
                                    let _e657 = phi_1396_;
                                    phi_1397_ = _e657;
                                    phi_1398_ = _e647;
                                }
                                let _e680 = phi_1397_;
                                let _e682 = phi_1398_;
                                let _e683 = (_e503 - 1u);
                                phi_1405_ = _e680;
                                phi_1406_ = select(_e682, -1i, (_e683 == 0u));
                                phi_1407_ = _e683;
                            }
                            let _e687 = phi_1405_;
                            let _e689 = phi_1406_;
                            let _e691 = phi_1407_;
                            phi_878_ = _e687;
                            phi_881_ = _e689;
                            phi_883_ = _e691;
                            phi_1409_ = select(true, false, _e506);
                        } else {
                            phi_878_ = u32();
                            phi_881_ = i32();
                            phi_883_ = u32();
                            phi_1409_ = false;
                        }
                        let _e694 = phi_878_;
                        let _e696 = phi_881_;
                        let _e698 = phi_883_;
                        let _e700 = phi_1409_;
                        continue;
                        continuing {
                            phi_877_ = _e694;
                            phi_880_ = _e696;
                            phi_882_ = _e698;
                            phi_2917_ = _e488;
                            break if !(_e700);
                        }
                    }
                    let _e703 = phi_2917_;
                    phi_3117_ = _e703;
                    if _e703 {
                        break;
                    }
                    let _e705 = local_2;
                    if _e705 {
                        let _e707 = local_3;
                        let _e710 = local_4;
                        phi_1423_ = _e490;
                        phi_1426_ = SlimbvhTypeA(0u, ((_e710 >> bitcast<u32>(28u)) & 7u));
                        loop {
                            let _e716 = phi_1423_;
                            let _e718 = phi_1426_;
                            local_6 = _e716;
                            local_8 = _e716;
                            if (_e718.member < _e718.member_1) {
                                phi_1427_ = SlimbvhTypeA((_e718.member + 1u), _e718.member_1);
                                phi_1449_ = SlimbvhTypeA(1u, _e718.member);
                            } else {
                                phi_1427_ = _e718;
                                phi_1449_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                            }
                            let _e731 = phi_1427_;
                            let _e733 = phi_1449_;
                            let _e737 = (bitcast<i32>(_e733.member) != 0i);
                            if _e737 {
                                let _e738 = ((_e707 & 268435455u) + _e733.member_1);
                                let _e739 = (_e738 / 2u);
                                let _e740 = (_e739 < _e75);
                                if _e740 {
                                    let _e741 = (_e738 % 2u);
                                    if (_e739 >= _e75) {
                                        phi_1534_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                                    } else {
                                        if _e740 {
                                        } else {
                                            phi_3023_ = true;
                                            break;
                                        }
                                        let _e743 = (2u * _e741);
                                        if (_e743 < 5u) {
                                        } else {
                                            phi_3023_ = true;
                                            break;
                                        }
                                        let _e748 = slimbvh_triangles.member[_e739][_e743];
                                        if _e740 {
                                        } else {
                                            phi_3023_ = true;
                                            break;
                                        }
                                        let _e749 = (_e743 + 1u);
                                        if (_e749 < 5u) {
                                        } else {
                                            phi_3023_ = true;
                                            break;
                                        }
                                        let _e754 = slimbvh_triangles.member[_e739][_e749];
                                        if _e740 {
                                        } else {
                                            phi_3023_ = true;
                                            break;
                                        }
                                        let _e755 = (_e743 + 2u);
                                        if (_e755 < 5u) {
                                        } else {
                                            phi_3023_ = true;
                                            break;
                                        }
                                        let _e760 = slimbvh_triangles.member[_e739][_e755];
                                        if (_e741 == 0u) {
                                            phi_1533_ = array<vec4<f32>, 3>(_e748, _e754, _e760);
                                        } else {
                                            phi_1533_ = array<vec4<f32>, 3>(vec4<f32>(_e748.z, _e748.w, _e754.x, _e754.y), vec4<f32>(_e754.z, _e754.w, _e760.x, _e760.y), vec4<f32>(_e760.z, _e760.w, 0f, 0f));
                                        }
                                        let _e778 = phi_1533_;
                                        phi_1534_ = _e778;
                                    }
                                    let _e780 = phi_1534_;
                                    phi_1537_ = bitcast<u32>(_e780[2].y);
                                } else {
                                    phi_1537_ = 4294967295u;
                                }
                                let _e785 = phi_1537_;
                                let _e786 = (_e738 % 2u);
                                if (_e739 >= _e75) {
                                    phi_1610_ = array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
                                } else {
                                    if _e740 {
                                    } else {
                                        phi_3023_ = true;
                                        break;
                                    }
                                    let _e788 = (2u * _e786);
                                    if (_e788 < 5u) {
                                    } else {
                                        phi_3023_ = true;
                                        break;
                                    }
                                    let _e793 = slimbvh_triangles.member[_e739][_e788];
                                    if _e740 {
                                    } else {
                                        phi_3023_ = true;
                                        break;
                                    }
                                    let _e794 = (_e788 + 1u);
                                    if (_e794 < 5u) {
                                    } else {
                                        phi_3023_ = true;
                                        break;
                                    }
                                    let _e799 = slimbvh_triangles.member[_e739][_e794];
                                    if _e740 {
                                    } else {
                                        phi_3023_ = true;
                                        break;
                                    }
                                    let _e800 = (_e788 + 2u);
                                    if (_e800 < 5u) {
                                    } else {
                                        phi_3023_ = true;
                                        break;
                                    }
                                    let _e805 = slimbvh_triangles.member[_e739][_e800];
                                    if (_e786 == 0u) {
                                        phi_1609_ = array<vec4<f32>, 3>(_e793, _e799, _e805);
                                    } else {
                                        phi_1609_ = array<vec4<f32>, 3>(vec4<f32>(_e793.z, _e793.w, _e799.x, _e799.y), vec4<f32>(_e799.z, _e799.w, _e805.x, _e805.y), vec4<f32>(_e805.z, _e805.w, 0f, 0f));
                                    }
                                    let _e823 = phi_1609_;
                                    phi_1610_ = _e823;
                                }
                                let _e825 = phi_1610_;
                                if _e203 {
                                    phi_1634_ = array<f32, 3>(_e825[0].x, _e825[0].y, _e825[0].z);
                                } else {
                                    if (_e168 == 1u) {
                                        phi_1633_ = array<f32, 3>(_e825[0].y, _e825[0].z, _e825[0].x);
                                    } else {
                                        phi_1633_ = array<f32, 3>(_e825[0].z, _e825[0].x, _e825[0].y);
                                    }
                                    let _e848 = phi_1633_;
                                    phi_1634_ = _e848;
                                }
                                let _e851 = phi_1634_;
                                if _e203 {
                                    phi_1649_ = array<f32, 3>(_e825[0].w, _e825[1].x, _e825[1].y);
                                } else {
                                    if (_e168 == 1u) {
                                        phi_1648_ = array<f32, 3>(_e825[1].x, _e825[1].y, _e825[0].w);
                                    } else {
                                        phi_1648_ = array<f32, 3>(_e825[1].y, _e825[0].w, _e825[1].x);
                                    }
                                    let _e856 = phi_1648_;
                                    phi_1649_ = _e856;
                                }
                                let _e859 = phi_1649_;
                                if _e203 {
                                    phi_1664_ = array<f32, 3>(_e825[1].z, _e825[1].w, _e825[2].x);
                                } else {
                                    if (_e168 == 1u) {
                                        phi_1663_ = array<f32, 3>(_e825[1].w, _e825[2].x, _e825[1].z);
                                    } else {
                                        phi_1663_ = array<f32, 3>(_e825[2].x, _e825[1].z, _e825[1].w);
                                    }
                                    let _e864 = phi_1663_;
                                    phi_1664_ = _e864;
                                }
                                let _e867 = phi_1664_;
                                let _e881 = (_e851[2] - _e335);
                                let _e884 = (((_e851[0] - _e223) * _e366) - (_e881 * _e254));
                                let _e887 = (((_e851[1] - _e279) * _e366) - (_e881 * _e310));
                                let _e890 = (_e859[2] - _e335);
                                let _e893 = (((_e859[0] - _e223) * _e366) - (_e890 * _e254));
                                let _e896 = (((_e859[1] - _e279) * _e366) - (_e890 * _e310));
                                let _e899 = (_e867[2] - _e335);
                                let _e902 = (((_e867[0] - _e223) * _e366) - (_e899 * _e254));
                                let _e905 = (((_e867[1] - _e279) * _e366) - (_e899 * _e310));
                                let _e906 = (_e902 * _e896);
                                let _e907 = (_e905 * _e893);
                                let _e908 = (_e884 * _e905);
                                let _e909 = (_e887 * _e902);
                                let _e910 = (_e893 * _e887);
                                let _e911 = (_e896 * _e884);
                                let _e916 = (((_e906 >= _e907) && (_e908 >= _e909)) && (_e910 >= _e911));
                                let _e922 = (_e916 || (((_e906 <= _e907) && (_e908 <= _e909)) && (_e910 <= _e911)));
                                if _e922 {
                                    let _e924 = select(-1f, 1f, _e916);
                                    let _e926 = ((_e906 - _e907) * _e924);
                                    let _e928 = select(0f, _e926, (_e926 > 0f));
                                    let _e930 = ((_e908 - _e909) * _e924);
                                    let _e932 = select(0f, _e930, (_e930 > 0f));
                                    let _e934 = ((_e910 - _e911) * _e924);
                                    let _e936 = select(0f, _e934, (_e934 > 0f));
                                    let _e938 = ((_e928 + _e932) + _e936);
                                    let _e940 = select(_e859[0], _e851[0], (_e851[0] < _e859[0]));
                                    let _e944 = select(_e859[0], _e851[0], (_e851[0] > _e859[0]));
                                    let _e948 = select(_e859[1], _e851[1], (_e851[1] < _e859[1]));
                                    let _e952 = select(_e859[1], _e851[1], (_e851[1] > _e859[1]));
                                    let _e956 = select(_e859[2], _e851[2], (_e851[2] < _e859[2]));
                                    let _e960 = select(_e859[2], _e851[2], (_e851[2] > _e859[2]));
                                    let _e965 = ((select(_e867[0], _e940, (_e940 < _e867[0])) - _e255) * _e258);
                                    let _e966 = ((select(_e867[0], _e944, (_e944 > _e867[0])) - _e256) * _e258);
                                    let _e969 = ((select(_e867[1], _e948, (_e948 < _e867[1])) - _e311) * _e314);
                                    let _e970 = ((select(_e867[1], _e952, (_e952 > _e867[1])) - _e312) * _e314);
                                    let _e973 = ((select(_e867[2], _e956, (_e956 < _e867[2])) - _e367) * _e370);
                                    let _e974 = ((select(_e867[2], _e960, (_e960 > _e867[2])) - _e368) * _e370);
                                    let _e976 = select(_e974, _e973, (_e973 < _e974));
                                    let _e978 = select(_e974, _e973, (_e973 > _e974));
                                    let _e980 = select(_e966, _e965, (_e965 < _e966));
                                    let _e982 = select(_e970, _e969, (_e969 < _e970));
                                    let _e984 = select(_e982, _e980, (_e980 > _e982));
                                    let _e986 = select(_e976, _e984, (_e984 > _e976));
                                    let _e988 = select(_e966, _e965, (_e965 > _e966));
                                    let _e990 = select(_e970, _e969, (_e969 > _e970));
                                    let _e992 = select(_e990, _e988, (_e988 < _e990));
                                    let _e994 = select(_e978, _e992, (_e992 < _e978));
                                    let _e995 = -(_e976);
                                    let _e1001 = select(_e473, _e986, (_e986 > _e473));
                                    let _e1005 = select(_e893, _e884, (_e884 < _e893));
                                    let _e1010 = select(_e893, _e884, (_e884 > _e893));
                                    let _e1017 = select(_e896, _e887, (_e887 < _e896));
                                    let _e1022 = select(_e896, _e887, (_e887 > _e896));
                                    let _e1031 = (((((_e922 && (_e938 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e902, _e1005, (_e1005 < _e902)) <= 0f) && (select(_e902, _e1010, (_e1010 > _e902)) >= 0f))) && ((select(_e905, _e1017, (_e1017 < _e905)) <= 0f) && (select(_e905, _e1022, (_e1022 > _e905)) >= 0f))) && (_e1001 <= (_e994 + (select(_e995, _e978, (_e978 > _e995)) * 0.0000019073523f)))) && (_e1001 <= _e716.member.member_1));
                                    if _e1031 {
                                        let _e1036 = (_e859[0] - _e851[0]);
                                        let _e1037 = (_e859[1] - _e851[1]);
                                        let _e1038 = (_e859[2] - _e851[2]);
                                        let _e1039 = vec3<f32>(_e1036, _e1037, _e1038);
                                        let _e1040 = (_e867[0] - _e859[0]);
                                        let _e1041 = (_e867[1] - _e859[1]);
                                        let _e1042 = (_e867[2] - _e859[2]);
                                        let _e1043 = vec3<f32>(_e1040, _e1041, _e1042);
                                        let _e1044 = (_e851[0] - _e867[0]);
                                        let _e1045 = (_e851[1] - _e867[1]);
                                        let _e1046 = (_e851[2] - _e867[2]);
                                        let _e1047 = vec3<f32>(_e1044, _e1045, _e1046);
                                        let _e1050 = bitcast<f32>((bitcast<u32>(_e1036) & 2147483647u));
                                        let _e1053 = bitcast<f32>((bitcast<u32>(_e1037) & 2147483647u));
                                        let _e1055 = select(_e1053, _e1050, (_e1050 > _e1053));
                                        let _e1058 = bitcast<f32>((bitcast<u32>(_e1038) & 2147483647u));
                                        let _e1060 = select(_e1058, _e1055, (_e1055 > _e1058));
                                        let _e1063 = bitcast<f32>((bitcast<u32>(_e1040) & 2147483647u));
                                        let _e1066 = bitcast<f32>((bitcast<u32>(_e1041) & 2147483647u));
                                        let _e1068 = select(_e1066, _e1063, (_e1063 > _e1066));
                                        let _e1071 = bitcast<f32>((bitcast<u32>(_e1042) & 2147483647u));
                                        let _e1073 = select(_e1071, _e1068, (_e1068 > _e1071));
                                        let _e1076 = bitcast<f32>((bitcast<u32>(_e1044) & 2147483647u));
                                        let _e1079 = bitcast<f32>((bitcast<u32>(_e1045) & 2147483647u));
                                        let _e1081 = select(_e1079, _e1076, (_e1076 > _e1079));
                                        let _e1084 = bitcast<f32>((bitcast<u32>(_e1046) & 2147483647u));
                                        let _e1086 = select(_e1084, _e1081, (_e1081 > _e1084));
                                        let _e1088 = select(_e1073, _e1060, (_e1060 > _e1073));
                                        let _e1090 = select(_e1086, _e1088, (_e1088 > _e1086));
                                        if (_e1060 == _e1090) {
                                            phi_2188_ = _e896;
                                            phi_2189_ = _e893;
                                            phi_2190_ = _e887;
                                            phi_2191_ = _e884;
                                            phi_2192_ = vec3<f32>(_e851[0], _e851[1], _e851[2]);
                                            phi_2193_ = _e1047;
                                            phi_2194_ = _e1043;
                                            phi_2195_ = _e1039;
                                        } else {
                                            let _e1092 = (_e1073 == _e1090);
                                            let _e1097 = vec3(_e1092);
                                            phi_2188_ = select(_e887, _e905, _e1092);
                                            phi_2189_ = select(_e884, _e902, _e1092);
                                            phi_2190_ = select(_e905, _e896, _e1092);
                                            phi_2191_ = select(_e902, _e893, _e1092);
                                            phi_2192_ = select(vec3<f32>(_e867[0], _e867[1], _e867[2]), vec3<f32>(_e859[0], _e859[1], _e859[2]), _e1097);
                                            phi_2193_ = select(_e1043, _e1039, _e1097);
                                            phi_2194_ = select(_e1039, _e1047, _e1097);
                                            phi_2195_ = select(_e1047, _e1043, _e1097);
                                        }
                                        let _e1103 = phi_2188_;
                                        let _e1105 = phi_2189_;
                                        let _e1107 = phi_2190_;
                                        let _e1109 = phi_2191_;
                                        let _e1111 = phi_2192_;
                                        let _e1113 = phi_2193_;
                                        let _e1115 = phi_2194_;
                                        let _e1117 = phi_2195_;
                                        let _e1124 = ((_e1115.y * _e1113.z) - (_e1113.y * _e1115.z));
                                        let _e1129 = ((_e1115.z * _e1113.x) - (_e1113.z * _e1115.x));
                                        let _e1132 = ((_e1115.x * _e1113.y) - (_e1113.x * _e1115.y));
                                        let _e1135 = ((_e928 >= _e932) && (_e928 >= _e936));
                                        let _e1136 = (_e932 >= _e936);
                                        let _e1150 = (((_e1124 * (select(select(_e867[0], _e859[0], _e1136), _e851[0], _e1135) - _e223)) + (_e1129 * (select(select(_e867[1], _e859[1], _e1136), _e851[1], _e1135) - _e279))) + (_e1132 * (select(select(_e867[2], _e859[2], _e1136), _e851[2], _e1135) - _e335)));
                                        let _e1155 = (((_e1124 * _e254) + (_e1129 * _e310)) + (_e1132 * _e366));
                                        let _e1156 = (_e1105 - _e1109);
                                        let _e1157 = (_e1103 - _e1107);
                                        let _e1160 = ((_e1156 * _e1156) + (_e1157 * _e1157));
                                        let _e1167 = (-(((_e1109 * _e1156) + (_e1107 * _e1157))) / select(0.000000000000000000000000000000000000011754944f, _e1160, (_e1160 > 0.000000000000000000000000000000000000011754944f)));
                                        let _e1169 = select(1f, _e1167, (_e1167 < 1f));
                                        let _e1171 = select(0f, _e1169, (_e1169 > 0f));
                                        let _e1180 = ((_e1111.x + (_e1117.x * _e1171)) - _e223);
                                        let _e1183 = ((_e1111.y + (_e1117.y * _e1171)) - _e279);
                                        let _e1186 = ((_e1111.z + (_e1117.z * _e1171)) - _e335);
                                        let _e1189 = bitcast<f32>((bitcast<u32>(_e1180) & 2147483647u));
                                        let _e1192 = bitcast<f32>((bitcast<u32>(_e1183) & 2147483647u));
                                        let _e1194 = select(_e1192, _e1189, (_e1189 > _e1192));
                                        let _e1197 = bitcast<f32>((bitcast<u32>(_e1186) & 2147483647u));
                                        let _e1199 = select(_e1197, _e1194, (_e1194 > _e1197));
                                        let _e1205 = bitcast<f32>((bitcast<u32>(_e1124) & 2147483647u));
                                        let _e1208 = bitcast<f32>((bitcast<u32>(_e1129) & 2147483647u));
                                        let _e1210 = select(_e1208, _e1205, (_e1205 > _e1208));
                                        let _e1213 = bitcast<f32>((bitcast<u32>(_e1132) & 2147483647u));
                                        let _e1232 = bitcast<f32>((bitcast<u32>(_e1115.x) & 2147483647u));
                                        let _e1235 = bitcast<f32>((bitcast<u32>(_e1115.y) & 2147483647u));
                                        let _e1237 = select(_e1235, _e1232, (_e1232 > _e1235));
                                        let _e1240 = bitcast<f32>((bitcast<u32>(_e1115.z) & 2147483647u));
                                        let _e1246 = bitcast<f32>((bitcast<u32>(_e1113.x) & 2147483647u));
                                        let _e1249 = bitcast<f32>((bitcast<u32>(_e1113.y) & 2147483647u));
                                        let _e1251 = select(_e1249, _e1246, (_e1246 > _e1249));
                                        let _e1254 = bitcast<f32>((bitcast<u32>(_e1113.z) & 2147483647u));
                                        let _e1260 = ((bitcast<f32>((bitcast<u32>(((((_e1124 * _e1180) + (_e1129 * _e1183)) + (_e1132 * _e1186)) - _e1150)) & 2147483647u)) <= ((0.0000009536743f * select(_e1090, _e1199, (_e1199 > _e1090))) * select(_e1213, _e1210, (_e1210 > _e1213)))) && !((bitcast<f32>((bitcast<u32>(_e1155) & 2147483647u)) <= ((0.0000038146973f * select(_e1240, _e1237, (_e1237 > _e1240))) * select(_e1254, _e1251, (_e1251 > _e1254))))));
                                        let _e1261 = (_e1150 / _e1155);
                                        if (_e1031 && !(_e1260)) {
                                            let _e1264 = (_e1186 / _e366);
                                            let _e1272 = (((_e1124 * (_e1180 - (_e254 * _e1264))) + (_e1129 * (_e1183 - (_e310 * _e1264)))) / _e1155);
                                            phi_2386_ = select(select(_e1264, (_e1264 + _e1272), (bitcast<f32>((bitcast<u32>(_e1272) & 2147483647u)) <= _e1090)), _e1261, _e1260);
                                        } else {
                                            phi_2386_ = _e1261;
                                        }
                                        let _e1281 = phi_2386_;
                                        let _e1283 = select(_e994, _e1281, (_e1281 < _e994));
                                        let _e1285 = select(_e986, _e1283, (_e1283 > _e986));
                                        let _e1286 = (1f / _e938);
                                        phi_2406_ = SlimbvhTypeK(_e1285, (_e932 * _e1286), (_e936 * _e1286), ((_e1031 && (_e1285 >= _e473)) && (_e1285 <= _e716.member.member_1)));
                                        phi_2407_ = SlimbvhTypeK();
                                    } else {
                                        phi_2406_ = SlimbvhTypeK();
                                        phi_2407_ = SlimbvhTypeK(0f, 0f, 0f, _e1031);
                                    }
                                    let _e1295 = phi_2406_;
                                    let _e1297 = phi_2407_;
                                    phi_2410_ = _e1295;
                                    phi_2411_ = _e1297;
                                    phi_2412_ = select(true, false, _e1031);
                                } else {
                                    phi_2410_ = SlimbvhTypeK();
                                    phi_2411_ = SlimbvhTypeK(0f, 0f, 0f, _e922);
                                    phi_2412_ = true;
                                }
                                let _e1300 = phi_2410_;
                                let _e1302 = phi_2411_;
                                let _e1304 = phi_2412_;
                                if _e1304 {
                                    phi_2416_ = _e1302;
                                } else {
                                    phi_2416_ = _e1300;
                                }
                                let _e1306 = phi_2416_;
                                if _e1306.member_3 {
                                    phi_2425_ = SlimbvhTypeC(_e1306.member, _e1306.member_1, _e1306.member_2, _e785);
                                } else {
                                    phi_2425_ = SlimbvhTypeC(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                }
                                let _e1313 = phi_2425_;
                                if (_e1313.member_3 != 4294967295u) {
                                    if (_e785 != 4294967295u) {
                                        if (_e1313.member < _e716.member.member.member) {
                                            phi_2451_ = true;
                                        } else {
                                            if (_e1313.member == _e716.member.member.member) {
                                                phi_2450_ = (_e1313.member_3 < _e716.member.member.member_3);
                                            } else {
                                                phi_2450_ = false;
                                            }
                                            let _e1328 = phi_2450_;
                                            phi_2451_ = _e1328;
                                        }
                                        let _e1330 = phi_2451_;
                                        if _e1330 {
                                            phi_2458_ = SlimbvhTypeI(SlimbvhTypeH(_e1313, _e1313.member), _e716.member_1);
                                        } else {
                                            phi_2458_ = _e716;
                                        }
                                        let _e1336 = phi_2458_;
                                        if _e1336.member_1 {
                                            phi_2464_ = SlimbvhTypeI(SlimbvhTypeH(_e1336.member.member, -340282350000000000000000000000000000000f), _e1336.member_1);
                                        } else {
                                            phi_2464_ = _e1336;
                                        }
                                        let _e1345 = phi_2464_;
                                        phi_2465_ = _e1345;
                                    } else {
                                        phi_2465_ = _e716;
                                    }
                                    let _e1347 = phi_2465_;
                                    phi_2466_ = _e1347;
                                } else {
                                    phi_2466_ = _e716;
                                }
                                let _e1349 = phi_2466_;
                                phi_1424_ = _e1349;
                            } else {
                                phi_1424_ = SlimbvhTypeI();
                            }
                            let _e1351 = phi_1424_;
                            continue;
                            continuing {
                                phi_1423_ = _e1351;
                                phi_1426_ = _e731;
                                phi_3023_ = _e703;
                                break if !(_e737);
                            }
                        }
                        let _e1354 = phi_3023_;
                        phi_3117_ = _e1354;
                        if _e1354 {
                            break;
                        }
                        let _e1356 = local_5;
                        let _e1357 = (_e1356 - 1i);
                        let _e1359 = (bitcast<u32>(_e1357) % 128u);
                        let _e1360 = (_e1359 < 128u);
                        if _e1360 {
                        } else {
                            phi_3117_ = true;
                            break;
                        }
                        let _e1362 = local[_e1359];
                        let _e1364 = local_6;
                        if (_e1362 <= _e1364.member.member_1) {
                            if _e1360 {
                            } else {
                                phi_3117_ = true;
                                break;
                            }
                            let _e1369 = local_1[_e1359];
                            phi_2493_ = _e1369;
                        } else {
                            phi_2493_ = 2147483648u;
                        }
                        let _e1371 = phi_2493_;
                        phi_3119_ = _e1354;
                        let _e1618 = local_8;
                        phi_2500_ = _e1618;
                        phi_2501_ = _e1371;
                        phi_2502_ = select(_e1357, -1i, (_e473 > _e1364.member.member_1));
                    } else {
                        phi_3119_ = _e703;
                        phi_2500_ = _e490;
                        let _e1621 = local_9;
                        phi_2501_ = _e1621;
                        let _e1624 = local_10;
                        phi_2502_ = _e1624;
                    }
                    let _e1375 = phi_3119_;
                    let _e1377 = phi_2500_;
                    let _e1379 = phi_2501_;
                    let _e1381 = phi_2502_;
                    phi_3118_ = _e1375;
                    phi_862_ = _e1377;
                    phi_865_ = _e1379;
                    phi_867_ = _e1381;
                    let _e1631 = local_11;
                    phi_869_ = _e1631;
                } else {
                    phi_3118_ = _e488;
                    phi_862_ = SlimbvhTypeI();
                    phi_865_ = u32();
                    phi_867_ = i32();
                    phi_869_ = u32();
                }
                let _e1383 = phi_3118_;
                let _e1385 = phi_862_;
                let _e1387 = phi_865_;
                let _e1389 = phi_867_;
                let _e1391 = phi_869_;
                continue;
                continuing {
                    phi_2920_ = _e1383;
                    phi_861_ = _e1385;
                    phi_864_ = _e1387;
                    phi_866_ = _e1389;
                    phi_868_ = _e1391;
                    phi_3117_ = _e1383;
                    break if !(_e497);
                }
            }
            let _e1394 = phi_3117_;
            if _e1394 {
                break;
            }
            let _e1396 = local_7;
            if (_e1396.member.member.member_3 != 4294967295u) {
                let _e1402 = -(_e375);
                let _e1403 = bitcast<u32>(_e1396.member.member.member);
                let _e1407 = (bitcast<i32>((_e1403 >> bitcast<u32>(23i))) & 255i);
                let _e1408 = (_e1407 + _e1402);
                if (_e1407 == 255i) {
                    phi_2557_ = _e1396.member.member.member;
                } else {
                    if (_e1407 > 0i) {
                        if (_e1408 > 0i) {
                            let _e1412 = (_e1408 < 255i);
                            if _e1412 {
                                phi_2536_ = bitcast<f32>((_e1403 + bitcast<u32>((_e1402 << bitcast<u32>(23i)))));
                            } else {
                                phi_2536_ = f32();
                            }
                            let _e1419 = phi_2536_;
                            phi_2538_ = _e1419;
                            phi_2539_ = select(true, false, _e1412);
                        } else {
                            phi_2538_ = f32();
                            phi_2539_ = true;
                        }
                        let _e1422 = phi_2538_;
                        let _e1424 = phi_2539_;
                        phi_2540_ = _e1422;
                        phi_2541_ = _e1424;
                    } else {
                        phi_2540_ = f32();
                        phi_2541_ = true;
                    }
                    let _e1426 = phi_2540_;
                    let _e1428 = phi_2541_;
                    if _e1428 {
                        let _e1429 = (_e1403 & 2147483648u);
                        let _e1436 = ((_e1403 & 8388607u) | (select(0u, 1u, ((_e1403 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e1440 = (_e1436 == 0u);
                        if _e1440 {
                            phi_2912_ = bitcast<f32>(_e1429);
                        } else {
                            let _e1445 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1436)), 32u, _e1440) - 8u);
                            let _e1448 = (_e1436 << bitcast<u32>((_e1445 & 31u)));
                            let _e1450 = ((_e1408 + select(0i, 1i, (_e1407 == 0i))) - bitcast<i32>(_e1445));
                            if (_e1450 >= 255i) {
                                phi_2902_ = bitcast<f32>((_e1429 | 2139095040u));
                                phi_2903_ = f32();
                                phi_2904_ = true;
                            } else {
                                let _e1452 = (_e1450 > 0i);
                                if _e1452 {
                                    phi_2896_ = bitcast<f32>(((_e1429 | (bitcast<u32>(_e1450) << bitcast<u32>(23i))) | (_e1448 & 8388607u)));
                                    phi_2897_ = f32();
                                } else {
                                    if (_e1450 < -24i) {
                                        phi_2862_ = 26u;
                                    } else {
                                        phi_2862_ = bitcast<u32>((1i - _e1450));
                                    }
                                    let _e1457 = phi_2862_;
                                    let _e1458 = (_e1457 & 31u);
                                    let _e1460 = (_e1448 >> bitcast<u32>(_e1458));
                                    let _e1464 = (_e1448 & ((1u << bitcast<u32>(_e1458)) - 1u));
                                    let _e1468 = (1u << bitcast<u32>(((_e1457 - 1u) & 31u)));
                                    if (_e1464 > _e1468) {
                                        phi_2883_ = true;
                                    } else {
                                        if (_e1464 == _e1468) {
                                            phi_2880_ = ((_e1460 & 1u) == 1u);
                                        } else {
                                            phi_2880_ = false;
                                        }
                                        let _e1474 = phi_2880_;
                                        phi_2883_ = _e1474;
                                    }
                                    let _e1476 = phi_2883_;
                                    phi_2896_ = f32();
                                    phi_2897_ = bitcast<f32>((_e1429 | (_e1460 + select(0u, 1u, _e1476))));
                                }
                                let _e1489 = phi_2896_;
                                let _e1491 = phi_2897_;
                                phi_2902_ = _e1489;
                                phi_2903_ = _e1491;
                                phi_2904_ = _e1452;
                            }
                            let _e1495 = phi_2902_;
                            let _e1497 = phi_2903_;
                            let _e1499 = phi_2904_;
                            phi_2912_ = select(_e1497, _e1495, _e1499);
                        }
                        let _e1503 = phi_2912_;
                        phi_2556_ = _e1503;
                    } else {
                        phi_2556_ = _e1426;
                    }
                    let _e1505 = phi_2556_;
                    phi_2557_ = _e1505;
                }
                let _e1507 = phi_2557_;
                let _e1508 = bitcast<u32>(_e1507);
                if ((_e1508 & 2147483647u) >= 2139095040u) {
                    phi_2569_ = bitcast<f32>(((_e1508 & 2147483648u) | 2139095039u));
                } else {
                    phi_2569_ = _e1507;
                }
                let _e1515 = phi_2569_;
                phi_2574_ = SlimbvhTypeC(_e1515, _e1396.member.member.member_1, _e1396.member.member.member_2, _e1396.member.member.member_3);
            } else {
                phi_2574_ = SlimbvhTypeC(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
            }
            let _e1520 = phi_2574_;
            slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1520.member), bitcast<u32>(_e1520.member_1), bitcast<u32>(_e1520.member_2), _e1520.member_3);
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
