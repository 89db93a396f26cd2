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
    var phi_2793_: bool;
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
    var phi_2787_: bool;
    var local_2: SlimbvhTypeK;
    var phi_2946_: bool;
    var phi_2356_: SlimbvhTypeK;
    var phi_2357_: bool;
    var phi_2358_: u32;
    var phi_2359_: u32;
    var phi_2945_: bool;
    var phi_2360_: SlimbvhTypeK;
    var phi_2361_: bool;
    var phi_2362_: u32;
    var phi_2363_: u32;
    var phi_2364_: u32;
    var phi_2944_: bool;
    var phi_2365_: SlimbvhTypeK;
    var phi_2366_: bool;
    var phi_2367_: u32;
    var phi_2368_: u32;
    var phi_2369_: u32;
    var phi_2943_: bool;
    var phi_864_: SlimbvhTypeK;
    var phi_867_: bool;
    var phi_869_: u32;
    var phi_871_: u32;
    var phi_873_: u32;
    var phi_2370_: bool;
    var phi_2942_: bool;
    var local_3: SlimbvhTypeK;
    var phi_2408_: f32;
    var phi_2410_: f32;
    var phi_2411_: bool;
    var phi_2412_: f32;
    var phi_2413_: bool;
    var phi_2732_: u32;
    var phi_2750_: bool;
    var phi_2753_: bool;
    var phi_2766_: f32;
    var phi_2767_: f32;
    var phi_2772_: f32;
    var phi_2773_: f32;
    var phi_2774_: bool;
    var phi_2782_: f32;
    var phi_2428_: f32;
    var phi_2429_: f32;
    var phi_2441_: f32;
    var phi_2446_: SlimbvhTypeE;
    var local_4: SlimbvhTypeK;

    switch bitcast<i32>(0u) {
        default: {
            let _e75 = arrayLength((&slimbvh_nodes.member));
            let _e77 = arrayLength((&slimbvh_triangles.member));
            let _e82 = slimbvh_origin.member;
            let _e88 = slimbvh_origin.member[3u];
            let _e89 = slimbvh_direction.member;
            let _e95 = slimbvh_direction.member[3u];
            let _e98 = slimbvh_exponent.member[0u];
            let _e99 = bitcast<i32>(_e98);
            let _e101 = (bitcast<u32>(_e89.x) & 2147483647u);
            let _e103 = (bitcast<u32>(_e89.y) & 2147483647u);
            let _e105 = (bitcast<u32>(_e89.z) & 2147483647u);
            let _e107 = (bitcast<u32>(_e82.x) & 2147483647u);
            let _e109 = (bitcast<u32>(_e82.y) & 2147483647u);
            let _e111 = (bitcast<u32>(_e82.z) & 2147483647u);
            let _e113 = select(_e103, _e101, (_e103 < _e101));
            let _e115 = select(_e105, _e113, (_e105 < _e113));
            let _e117 = select(_e107, _e115, (_e107 < _e115));
            let _e119 = select(_e109, _e117, (_e109 < _e117));
            let _e121 = select(_e111, _e119, (_e111 < _e119));
            let _e122 = bitcast<u32>(_e88);
            let _e123 = (_e122 & 2147483647u);
            let _e127 = bitcast<u32>(_e95);
            let _e128 = (_e127 & 2147483647u);
            let _e132 = (((select(_e123, _e121, (_e123 < _e121)) < 2139095040u) && (_e128 <= 2139095040u)) && (_e115 > 0u));
            if _e132 {
                let _e135 = (bitcast<u32>(bitcast<f32>(_e115)) & 2147483647u);
                if (_e135 >= 8388608u) {
                    phi_262_ = (bitcast<i32>((_e135 >> bitcast<u32>(23i))) - 127i);
                } else {
                    phi_262_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e135)), 32u, (_e135 == 0u))));
                }
                let _e149 = phi_262_;
                phi_263_ = _e149;
            } else {
                phi_263_ = 0i;
            }
            let _e151 = phi_263_;
            let _e152 = (_e101 == _e115);
            if _e152 {
                phi_273_ = true;
            } else {
                phi_273_ = (_e103 == _e115);
            }
            let _e155 = phi_273_;
            let _e156 = select(1u, 0u, _e152);
            if _e155 {
                let _e157 = (_e156 + 1u);
                phi_283_ = _e157;
                phi_284_ = _e157;
                phi_286_ = select(true, false, (_e157 == 2u));
            } else {
                phi_283_ = u32();
                phi_284_ = 0u;
                phi_286_ = true;
            }
            let _e161 = phi_283_;
            let _e163 = phi_284_;
            let _e165 = phi_286_;
            if _e165 {
                phi_291_ = (_e163 + 1u);
            } else {
                phi_291_ = 0u;
            }
            let _e169 = phi_291_;
            let _e170 = select(_e161, _e163, _e165);
            let _e171 = select(_e156, select(2u, _e156, _e155), _e165);
            if (_e99 < -126i) {
                phi_304_ = -126i;
            } else {
                phi_304_ = select(_e99, 127i, (_e99 > 127i));
            }
            let _e176 = phi_304_;
            let _e181 = bitcast<f32>((bitcast<u32>((_e176 + 127i)) << bitcast<u32>(23i)));
            let _e187 = bitcast<f32>((bitcast<u32>(((_e99 - _e176) + 127i)) << bitcast<u32>(23i)));
            let _e188 = -(_e151);
            if (_e188 < -126i) {
                phi_324_ = -126i;
            } else {
                phi_324_ = select(_e188, 127i, (_e188 > 127i));
            }
            let _e193 = phi_324_;
            let _e198 = bitcast<f32>((bitcast<u32>((_e193 + 127i)) << bitcast<u32>(23i)));
            let _e204 = bitcast<f32>((bitcast<u32>(((_e188 - _e193) + 127i)) << bitcast<u32>(23i)));
            let _e205 = (_e170 == 0u);
            let _e207 = (_e170 == 2u);
            let _e208 = select(select(_e82.y, _e82.x, _e205), _e82.z, _e207);
            let _e209 = bitcast<u32>(_e208);
            let _e211 = ((_e209 & 2139095040u) != 0u);
            let _e225 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e209 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e209 & 2147483648u))), _e208, _e211) * _e181) * select(0.00000011920929f, 1f, _e211)) * _e187);
            let _e227 = select(select(_e89.y, _e89.x, _e205), _e89.z, _e207);
            let _e228 = bitcast<u32>(_e227);
            let _e230 = ((_e228 & 2139095040u) != 0u);
            let _e244 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e228 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e228 & 2147483648u))), _e227, _e230) * _e198) * select(0.00000011920929f, 1f, _e230)) * _e204);
            let _e248 = (bitcast<f32>((bitcast<u32>(_e244) & 2147483647u)) >= 0.00000000000000000086736174f);
            let _e251 = bitcast<f32>((bitcast<u32>(_e225) & 2147483647u));
            let _e252 = (_e251 * 0.00000011920929f);
            let _e255 = select(select(0.00000000000011368684f, _e252, (_e252 > 0.00000000000011368684f)), 0f, _e248);
            let _e256 = select(0f, _e244, _e248);
            let _e257 = (_e225 + _e255);
            let _e258 = (_e225 - _e255);
            let _e260 = select(38685626000000000000000000f, (1f / _e244), _e248);
            let _e261 = (_e169 == 0u);
            let _e263 = (_e169 == 2u);
            let _e264 = select(select(_e82.y, _e82.x, _e261), _e82.z, _e263);
            let _e265 = bitcast<u32>(_e264);
            let _e267 = ((_e265 & 2139095040u) != 0u);
            let _e281 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e265 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e265 & 2147483648u))), _e264, _e267) * _e181) * select(0.00000011920929f, 1f, _e267)) * _e187);
            let _e283 = select(select(_e89.y, _e89.x, _e261), _e89.z, _e263);
            let _e284 = bitcast<u32>(_e283);
            let _e286 = ((_e284 & 2139095040u) != 0u);
            let _e300 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e284 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e284 & 2147483648u))), _e283, _e286) * _e198) * select(0.00000011920929f, 1f, _e286)) * _e204);
            let _e304 = (bitcast<f32>((bitcast<u32>(_e300) & 2147483647u)) >= 0.00000000000000000086736174f);
            let _e307 = bitcast<f32>((bitcast<u32>(_e281) & 2147483647u));
            let _e308 = (_e307 * 0.00000011920929f);
            let _e311 = select(select(0.00000000000011368684f, _e308, (_e308 > 0.00000000000011368684f)), 0f, _e304);
            let _e312 = select(0f, _e300, _e304);
            let _e313 = (_e281 + _e311);
            let _e314 = (_e281 - _e311);
            let _e316 = select(38685626000000000000000000f, (1f / _e300), _e304);
            let _e317 = (_e171 == 0u);
            let _e319 = (_e171 == 2u);
            let _e320 = select(select(_e82.y, _e82.x, _e317), _e82.z, _e319);
            let _e321 = bitcast<u32>(_e320);
            let _e323 = ((_e321 & 2139095040u) != 0u);
            let _e337 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e321 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e321 & 2147483648u))), _e320, _e323) * _e181) * select(0.00000011920929f, 1f, _e323)) * _e187);
            let _e339 = select(select(_e89.y, _e89.x, _e317), _e89.z, _e319);
            let _e340 = bitcast<u32>(_e339);
            let _e342 = ((_e340 & 2139095040u) != 0u);
            let _e356 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e340 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e340 & 2147483648u))), _e339, _e342) * _e198) * select(0.00000011920929f, 1f, _e342)) * _e204);
            let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) >= 0.00000000000000000086736174f);
            let _e363 = bitcast<f32>((bitcast<u32>(_e337) & 2147483647u));
            let _e364 = (_e363 * 0.00000011920929f);
            let _e367 = select(select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f)), 0f, _e360);
            let _e368 = select(0f, _e356, _e360);
            let _e369 = (_e337 + _e367);
            let _e370 = (_e337 - _e367);
            let _e372 = select(38685626000000000000000000f, (1f / _e356), _e360);
            let _e374 = select(_e307, _e251, (_e251 > _e307));
            let _e377 = (_e99 + _e151);
            if (_e132 && (select(_e363, _e374, (_e374 > _e363)) <= 1099511600000f)) {
                let _e387 = ((_e123 & 8388607u) | (select(0u, 1u, ((_e123 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e390 = bitcast<i32>((_e123 >> bitcast<u32>(23i)));
                let _e394 = (_e387 == 0u);
                let _e397 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e387)), 32u, _e394)) - 8i);
                if (_e390 == 255i) {
                    phi_749_ = 255i;
                } else {
                    phi_749_ = (((_e390 + select(0i, 1i, (_e390 == 0i))) - _e397) + _e377);
                }
                let _e405 = phi_749_;
                let _e415 = (_e405 <= 0i);
                if _e415 {
                    phi_772_ = u32();
                } else {
                    if _e394 {
                        phi_771_ = u32();
                    } else {
                        phi_771_ = select(((bitcast<u32>(_e405) << bitcast<u32>(23i)) | ((_e387 << bitcast<u32>(((_e397 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e405 >= 255i));
                    }
                    let _e419 = phi_771_;
                    phi_772_ = _e419;
                }
                let _e421 = phi_772_;
                let _e433 = ((_e128 & 8388607u) | (select(0u, 1u, ((_e128 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e436 = bitcast<i32>((_e128 >> bitcast<u32>(23i)));
                let _e440 = (_e433 == 0u);
                let _e443 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e433)), 32u, _e440)) - 8i);
                if (_e436 == 255i) {
                    phi_807_ = 255i;
                } else {
                    phi_807_ = (((_e436 + select(0i, 1i, (_e436 == 0i))) - _e443) + _e377);
                }
                let _e451 = phi_807_;
                let _e461 = (_e451 <= 0i);
                if _e461 {
                    phi_830_ = u32();
                } else {
                    if _e440 {
                        phi_829_ = u32();
                    } else {
                        phi_829_ = select(((bitcast<u32>(_e451) << bitcast<u32>(23i)) | ((_e433 << bitcast<u32>(((_e443 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e451 >= 255i));
                    }
                    let _e465 = phi_829_;
                    phi_830_ = _e465;
                }
                let _e467 = phi_830_;
                phi_838_ = bitcast<f32>(((_e127 & 2147483648u) | select(_e467, 0u, select(_e440, true, _e461))));
                phi_839_ = bitcast<f32>(((_e122 & 2147483648u) | select(_e421, 0u, select(_e394, true, _e415))));
            } else {
                phi_838_ = 0f;
                phi_839_ = 1f;
            }
            let _e473 = phi_838_;
            let _e475 = phi_839_;
            let _e476 = slimbvh_any_will_do.member;
            if (_e476 == 1u) {
                phi_853_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e473), true);
            } else {
                phi_853_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e473), false);
            }
            let _e483 = phi_853_;
            local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
            local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
            phi_2793_ = false;
            phi_863_ = _e483;
            phi_866_ = (_e475 <= _e473);
            phi_868_ = select(0u, 2147483648u, (_e75 == 0u));
            phi_870_ = 0u;
            phi_872_ = ((3u * _e75) + 1u);
            loop {
                let _e490 = phi_2793_;
                let _e492 = phi_863_;
                let _e494 = phi_866_;
                let _e496 = phi_868_;
                let _e498 = phi_870_;
                let _e500 = phi_872_;
                local_3 = _e492;
                if _e494 {
                    phi_883_ = true;
                } else {
                    phi_883_ = (_e498 > 0u);
                }
                let _e503 = phi_883_;
                if _e503 {
                    let _e504 = (_e500 > 0u);
                    if _e504 {
                        if _e494 {
                            phi_915_ = _e494;
                            phi_916_ = _e496;
                            phi_917_ = _e498;
                        } else {
                            let _e505 = (_e498 - 1u);
                            let _e506 = (_e505 % 128u);
                            let _e507 = (_e506 < 128u);
                            if _e507 {
                            } else {
                                phi_2942_ = true;
                                break;
                            }
                            let _e509 = local_1[_e506];
                            if _e507 {
                            } else {
                                phi_2942_ = true;
                                break;
                            }
                            let _e511 = local[_e506];
                            phi_915_ = (_e511 <= _e492.member.member_1);
                            phi_916_ = _e509;
                            phi_917_ = _e505;
                        }
                        let _e516 = phi_915_;
                        let _e518 = phi_916_;
                        let _e520 = phi_917_;
                        if _e516 {
                            if ((_e518 & 2147483648u) != 0u) {
                                phi_932_ = _e492;
                                phi_935_ = SlimbvhTypeA(0u, ((_e518 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e718 = phi_932_;
                                    let _e720 = phi_935_;
                                    local_2 = _e718;
                                    local_4 = _e718;
                                    if (_e720.member < _e720.member_1) {
                                        phi_936_ = SlimbvhTypeA((_e720.member + 1u), _e720.member_1);
                                        phi_958_ = SlimbvhTypeA(1u, _e720.member);
                                    } else {
                                        phi_936_ = _e720;
                                        phi_958_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                                    }
                                    let _e733 = phi_936_;
                                    let _e735 = phi_958_;
                                    let _e739 = (bitcast<i32>(_e735.member) != 0i);
                                    if _e739 {
                                        let _e740 = ((_e518 & 268435455u) + _e735.member_1);
                                        let _e741 = (_e740 < _e77);
                                        if _e741 {
                                            if _e741 {
                                            } else {
                                                phi_2787_ = true;
                                                break;
                                            }
                                            let _e745 = slimbvh_triangles.member[_e740].member_1;
                                            phi_979_ = _e745;
                                        } else {
                                            phi_979_ = 4294967295u;
                                        }
                                        let _e747 = phi_979_;
                                        if (_e740 >= _e77) {
                                            phi_1071_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                        } else {
                                            if _e741 {
                                            } else {
                                                phi_2787_ = true;
                                                break;
                                            }
                                            let _e749 = (_e170 % 3u);
                                            let _e750 = (_e169 % 3u);
                                            let _e751 = (_e171 % 3u);
                                            if (_e749 < 9u) {
                                            } else {
                                                phi_2787_ = true;
                                                break;
                                            }
                                            let _e757 = slimbvh_triangles.member[_e740].member[_e749];
                                            if (_e750 < 9u) {
                                            } else {
                                                phi_2787_ = true;
                                                break;
                                            }
                                            let _e763 = slimbvh_triangles.member[_e740].member[_e750];
                                            if (_e751 < 9u) {
                                            } else {
                                                phi_2787_ = true;
                                                break;
                                            }
                                            let _e769 = slimbvh_triangles.member[_e740].member[_e751];
                                            let _e771 = (3u + _e749);
                                            if (_e771 < 9u) {
                                            } else {
                                                phi_2787_ = true;
                                                break;
                                            }
                                            let _e777 = slimbvh_triangles.member[_e740].member[_e771];
                                            let _e778 = (3u + _e750);
                                            if (_e778 < 9u) {
                                            } else {
                                                phi_2787_ = true;
                                                break;
                                            }
                                            let _e784 = slimbvh_triangles.member[_e740].member[_e778];
                                            let _e785 = (3u + _e751);
                                            if (_e785 < 9u) {
                                            } else {
                                                phi_2787_ = true;
                                                break;
                                            }
                                            let _e791 = slimbvh_triangles.member[_e740].member[_e785];
                                            let _e793 = (6u + _e749);
                                            if (_e793 < 9u) {
                                            } else {
                                                phi_2787_ = true;
                                                break;
                                            }
                                            let _e799 = slimbvh_triangles.member[_e740].member[_e793];
                                            let _e800 = (6u + _e750);
                                            if (_e800 < 9u) {
                                            } else {
                                                phi_2787_ = true;
                                                break;
                                            }
                                            let _e806 = slimbvh_triangles.member[_e740].member[_e800];
                                            let _e807 = (6u + _e751);
                                            if (_e807 < 9u) {
                                            } else {
                                                phi_2787_ = true;
                                                break;
                                            }
                                            let _e813 = slimbvh_triangles.member[_e740].member[_e807];
                                            phi_1071_ = array<array<f32, 3>, 3>(array<f32, 3>(_e757, _e763, _e769), array<f32, 3>(_e777, _e784, _e791), array<f32, 3>(_e799, _e806, _e813));
                                        }
                                        let _e817 = phi_1071_;
                                        let _e834 = (_e817[0][2] - _e337);
                                        let _e837 = (((_e817[0][0] - _e225) * _e368) - (_e834 * _e256));
                                        let _e840 = (((_e817[0][1] - _e281) * _e368) - (_e834 * _e312));
                                        let _e843 = (_e817[1][2] - _e337);
                                        let _e846 = (((_e817[1][0] - _e225) * _e368) - (_e843 * _e256));
                                        let _e849 = (((_e817[1][1] - _e281) * _e368) - (_e843 * _e312));
                                        let _e852 = (_e817[2][2] - _e337);
                                        let _e855 = (((_e817[2][0] - _e225) * _e368) - (_e852 * _e256));
                                        let _e858 = (((_e817[2][1] - _e281) * _e368) - (_e852 * _e312));
                                        let _e859 = (_e855 * _e849);
                                        let _e860 = (_e858 * _e846);
                                        let _e861 = (_e837 * _e858);
                                        let _e862 = (_e840 * _e855);
                                        let _e863 = (_e846 * _e840);
                                        let _e864 = (_e849 * _e837);
                                        let _e869 = (((_e859 >= _e860) && (_e861 >= _e862)) && (_e863 >= _e864));
                                        let _e875 = (_e869 || (((_e859 <= _e860) && (_e861 <= _e862)) && (_e863 <= _e864)));
                                        if _e875 {
                                            let _e877 = select(-1f, 1f, _e869);
                                            let _e879 = ((_e859 - _e860) * _e877);
                                            let _e881 = select(0f, _e879, (_e879 > 0f));
                                            let _e883 = ((_e861 - _e862) * _e877);
                                            let _e885 = select(0f, _e883, (_e883 > 0f));
                                            let _e887 = ((_e863 - _e864) * _e877);
                                            let _e889 = select(0f, _e887, (_e887 > 0f));
                                            let _e891 = ((_e881 + _e885) + _e889);
                                            let _e893 = select(_e817[1][0], _e817[0][0], (_e817[0][0] < _e817[1][0]));
                                            let _e897 = select(_e817[1][0], _e817[0][0], (_e817[0][0] > _e817[1][0]));
                                            let _e901 = select(_e817[1][1], _e817[0][1], (_e817[0][1] < _e817[1][1]));
                                            let _e905 = select(_e817[1][1], _e817[0][1], (_e817[0][1] > _e817[1][1]));
                                            let _e909 = select(_e817[1][2], _e817[0][2], (_e817[0][2] < _e817[1][2]));
                                            let _e913 = select(_e817[1][2], _e817[0][2], (_e817[0][2] > _e817[1][2]));
                                            let _e918 = ((select(_e817[2][0], _e893, (_e893 < _e817[2][0])) - _e257) * _e260);
                                            let _e919 = ((select(_e817[2][0], _e897, (_e897 > _e817[2][0])) - _e258) * _e260);
                                            let _e922 = ((select(_e817[2][1], _e901, (_e901 < _e817[2][1])) - _e313) * _e316);
                                            let _e923 = ((select(_e817[2][1], _e905, (_e905 > _e817[2][1])) - _e314) * _e316);
                                            let _e926 = ((select(_e817[2][2], _e909, (_e909 < _e817[2][2])) - _e369) * _e372);
                                            let _e927 = ((select(_e817[2][2], _e913, (_e913 > _e817[2][2])) - _e370) * _e372);
                                            let _e929 = select(_e927, _e926, (_e926 < _e927));
                                            let _e931 = select(_e927, _e926, (_e926 > _e927));
                                            let _e933 = select(_e919, _e918, (_e918 < _e919));
                                            let _e935 = select(_e923, _e922, (_e922 < _e923));
                                            let _e937 = select(_e935, _e933, (_e933 > _e935));
                                            let _e939 = select(_e929, _e937, (_e937 > _e929));
                                            let _e941 = select(_e919, _e918, (_e918 > _e919));
                                            let _e943 = select(_e923, _e922, (_e922 > _e923));
                                            let _e945 = select(_e943, _e941, (_e941 < _e943));
                                            let _e947 = select(_e931, _e945, (_e945 < _e931));
                                            let _e948 = -(_e929);
                                            let _e954 = select(_e475, _e939, (_e939 > _e475));
                                            let _e958 = select(_e846, _e837, (_e837 < _e846));
                                            let _e963 = select(_e846, _e837, (_e837 > _e846));
                                            let _e970 = select(_e849, _e840, (_e840 < _e849));
                                            let _e975 = select(_e849, _e840, (_e840 > _e849));
                                            let _e984 = (((((_e875 && (_e891 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e855, _e958, (_e958 < _e855)) <= 0f) && (select(_e855, _e963, (_e963 > _e855)) >= 0f))) && ((select(_e858, _e970, (_e970 < _e858)) <= 0f) && (select(_e858, _e975, (_e975 > _e858)) >= 0f))) && (_e954 <= (_e947 + (select(_e948, _e931, (_e931 > _e948)) * 0.0000019073523f)))) && (_e954 <= _e718.member.member_1));
                                            if _e984 {
                                                let _e989 = (_e817[1][0] - _e817[0][0]);
                                                let _e990 = (_e817[1][1] - _e817[0][1]);
                                                let _e991 = (_e817[1][2] - _e817[0][2]);
                                                let _e992 = vec3<f32>(_e989, _e990, _e991);
                                                let _e993 = (_e817[2][0] - _e817[1][0]);
                                                let _e994 = (_e817[2][1] - _e817[1][1]);
                                                let _e995 = (_e817[2][2] - _e817[1][2]);
                                                let _e996 = vec3<f32>(_e993, _e994, _e995);
                                                let _e997 = (_e817[0][0] - _e817[2][0]);
                                                let _e998 = (_e817[0][1] - _e817[2][1]);
                                                let _e999 = (_e817[0][2] - _e817[2][2]);
                                                let _e1000 = vec3<f32>(_e997, _e998, _e999);
                                                let _e1003 = bitcast<f32>((bitcast<u32>(_e989) & 2147483647u));
                                                let _e1006 = bitcast<f32>((bitcast<u32>(_e990) & 2147483647u));
                                                let _e1008 = select(_e1006, _e1003, (_e1003 > _e1006));
                                                let _e1011 = bitcast<f32>((bitcast<u32>(_e991) & 2147483647u));
                                                let _e1013 = select(_e1011, _e1008, (_e1008 > _e1011));
                                                let _e1016 = bitcast<f32>((bitcast<u32>(_e993) & 2147483647u));
                                                let _e1019 = bitcast<f32>((bitcast<u32>(_e994) & 2147483647u));
                                                let _e1021 = select(_e1019, _e1016, (_e1016 > _e1019));
                                                let _e1024 = bitcast<f32>((bitcast<u32>(_e995) & 2147483647u));
                                                let _e1026 = select(_e1024, _e1021, (_e1021 > _e1024));
                                                let _e1029 = bitcast<f32>((bitcast<u32>(_e997) & 2147483647u));
                                                let _e1032 = bitcast<f32>((bitcast<u32>(_e998) & 2147483647u));
                                                let _e1034 = select(_e1032, _e1029, (_e1029 > _e1032));
                                                let _e1037 = bitcast<f32>((bitcast<u32>(_e999) & 2147483647u));
                                                let _e1039 = select(_e1037, _e1034, (_e1034 > _e1037));
                                                let _e1041 = select(_e1026, _e1013, (_e1013 > _e1026));
                                                let _e1043 = select(_e1039, _e1041, (_e1041 > _e1039));
                                                if (_e1013 == _e1043) {
                                                    phi_1601_ = _e849;
                                                    phi_1602_ = _e846;
                                                    phi_1603_ = _e840;
                                                    phi_1604_ = _e837;
                                                    phi_1605_ = vec3<f32>(_e817[0][0], _e817[0][1], _e817[0][2]);
                                                    phi_1606_ = _e1000;
                                                    phi_1607_ = _e996;
                                                    phi_1608_ = _e992;
                                                } else {
                                                    let _e1045 = (_e1026 == _e1043);
                                                    let _e1050 = vec3(_e1045);
                                                    phi_1601_ = select(_e840, _e858, _e1045);
                                                    phi_1602_ = select(_e837, _e855, _e1045);
                                                    phi_1603_ = select(_e858, _e849, _e1045);
                                                    phi_1604_ = select(_e855, _e846, _e1045);
                                                    phi_1605_ = select(vec3<f32>(_e817[2][0], _e817[2][1], _e817[2][2]), vec3<f32>(_e817[1][0], _e817[1][1], _e817[1][2]), _e1050);
                                                    phi_1606_ = select(_e996, _e992, _e1050);
                                                    phi_1607_ = select(_e992, _e1000, _e1050);
                                                    phi_1608_ = select(_e1000, _e996, _e1050);
                                                }
                                                let _e1056 = phi_1601_;
                                                let _e1058 = phi_1602_;
                                                let _e1060 = phi_1603_;
                                                let _e1062 = phi_1604_;
                                                let _e1064 = phi_1605_;
                                                let _e1066 = phi_1606_;
                                                let _e1068 = phi_1607_;
                                                let _e1070 = phi_1608_;
                                                let _e1077 = ((_e1068.y * _e1066.z) - (_e1066.y * _e1068.z));
                                                let _e1082 = ((_e1068.z * _e1066.x) - (_e1066.z * _e1068.x));
                                                let _e1085 = ((_e1068.x * _e1066.y) - (_e1066.x * _e1068.y));
                                                let _e1088 = ((_e881 >= _e885) && (_e881 >= _e889));
                                                let _e1089 = (_e885 >= _e889);
                                                let _e1103 = (((_e1077 * (select(select(_e817[2][0], _e817[1][0], _e1089), _e817[0][0], _e1088) - _e225)) + (_e1082 * (select(select(_e817[2][1], _e817[1][1], _e1089), _e817[0][1], _e1088) - _e281))) + (_e1085 * (select(select(_e817[2][2], _e817[1][2], _e1089), _e817[0][2], _e1088) - _e337)));
                                                let _e1108 = (((_e1077 * _e256) + (_e1082 * _e312)) + (_e1085 * _e368));
                                                let _e1109 = (_e1058 - _e1062);
                                                let _e1110 = (_e1056 - _e1060);
                                                let _e1113 = ((_e1109 * _e1109) + (_e1110 * _e1110));
                                                let _e1120 = (-(((_e1062 * _e1109) + (_e1060 * _e1110))) / select(0.000000000000000000000000000000000000011754944f, _e1113, (_e1113 > 0.000000000000000000000000000000000000011754944f)));
                                                let _e1122 = select(1f, _e1120, (_e1120 < 1f));
                                                let _e1124 = select(0f, _e1122, (_e1122 > 0f));
                                                let _e1133 = ((_e1064.x + (_e1070.x * _e1124)) - _e225);
                                                let _e1136 = ((_e1064.y + (_e1070.y * _e1124)) - _e281);
                                                let _e1139 = ((_e1064.z + (_e1070.z * _e1124)) - _e337);
                                                let _e1142 = bitcast<f32>((bitcast<u32>(_e1133) & 2147483647u));
                                                let _e1145 = bitcast<f32>((bitcast<u32>(_e1136) & 2147483647u));
                                                let _e1147 = select(_e1145, _e1142, (_e1142 > _e1145));
                                                let _e1150 = bitcast<f32>((bitcast<u32>(_e1139) & 2147483647u));
                                                let _e1152 = select(_e1150, _e1147, (_e1147 > _e1150));
                                                let _e1158 = bitcast<f32>((bitcast<u32>(_e1077) & 2147483647u));
                                                let _e1161 = bitcast<f32>((bitcast<u32>(_e1082) & 2147483647u));
                                                let _e1163 = select(_e1161, _e1158, (_e1158 > _e1161));
                                                let _e1166 = bitcast<f32>((bitcast<u32>(_e1085) & 2147483647u));
                                                let _e1185 = bitcast<f32>((bitcast<u32>(_e1068.x) & 2147483647u));
                                                let _e1188 = bitcast<f32>((bitcast<u32>(_e1068.y) & 2147483647u));
                                                let _e1190 = select(_e1188, _e1185, (_e1185 > _e1188));
                                                let _e1193 = bitcast<f32>((bitcast<u32>(_e1068.z) & 2147483647u));
                                                let _e1199 = bitcast<f32>((bitcast<u32>(_e1066.x) & 2147483647u));
                                                let _e1202 = bitcast<f32>((bitcast<u32>(_e1066.y) & 2147483647u));
                                                let _e1204 = select(_e1202, _e1199, (_e1199 > _e1202));
                                                let _e1207 = bitcast<f32>((bitcast<u32>(_e1066.z) & 2147483647u));
                                                let _e1213 = ((bitcast<f32>((bitcast<u32>(((((_e1077 * _e1133) + (_e1082 * _e1136)) + (_e1085 * _e1139)) - _e1103)) & 2147483647u)) <= ((0.0000009536743f * select(_e1043, _e1152, (_e1152 > _e1043))) * select(_e1166, _e1163, (_e1163 > _e1166)))) && !((bitcast<f32>((bitcast<u32>(_e1108) & 2147483647u)) <= ((0.0000038146973f * select(_e1193, _e1190, (_e1190 > _e1193))) * select(_e1207, _e1204, (_e1204 > _e1207))))));
                                                let _e1214 = (_e1103 / _e1108);
                                                if (_e984 && !(_e1213)) {
                                                    let _e1217 = (_e1139 / _e368);
                                                    let _e1225 = (((_e1077 * (_e1133 - (_e256 * _e1217))) + (_e1082 * (_e1136 - (_e312 * _e1217)))) / _e1108);
                                                    phi_1799_ = select(select(_e1217, (_e1217 + _e1225), (bitcast<f32>((bitcast<u32>(_e1225) & 2147483647u)) <= _e1043)), _e1214, _e1213);
                                                } else {
                                                    phi_1799_ = _e1214;
                                                }
                                                let _e1234 = phi_1799_;
                                                let _e1236 = select(_e947, _e1234, (_e1234 < _e947));
                                                let _e1238 = select(_e939, _e1236, (_e1236 > _e939));
                                                let _e1239 = (1f / _e891);
                                                phi_1819_ = SlimbvhTypeL(_e1238, (_e885 * _e1239), (_e889 * _e1239), ((_e984 && (_e1238 >= _e475)) && (_e1238 <= _e718.member.member_1)));
                                                phi_1820_ = SlimbvhTypeL();
                                            } else {
                                                phi_1819_ = SlimbvhTypeL();
                                                phi_1820_ = SlimbvhTypeL(0f, 0f, 0f, _e984);
                                            }
                                            let _e1248 = phi_1819_;
                                            let _e1250 = phi_1820_;
                                            phi_1823_ = _e1248;
                                            phi_1824_ = _e1250;
                                            phi_1825_ = select(true, false, _e984);
                                        } else {
                                            phi_1823_ = SlimbvhTypeL();
                                            phi_1824_ = SlimbvhTypeL(0f, 0f, 0f, _e875);
                                            phi_1825_ = true;
                                        }
                                        let _e1253 = phi_1823_;
                                        let _e1255 = phi_1824_;
                                        let _e1257 = phi_1825_;
                                        if _e1257 {
                                            phi_1829_ = _e1255;
                                        } else {
                                            phi_1829_ = _e1253;
                                        }
                                        let _e1259 = phi_1829_;
                                        if _e1259.member_3 {
                                            phi_1838_ = SlimbvhTypeE(_e1259.member, _e1259.member_1, _e1259.member_2, _e747);
                                        } else {
                                            phi_1838_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                        }
                                        let _e1266 = phi_1838_;
                                        if (_e1266.member_3 != 4294967295u) {
                                            if (_e747 != 4294967295u) {
                                                if (_e1266.member < _e718.member.member.member) {
                                                    phi_1864_ = true;
                                                } else {
                                                    if (_e1266.member == _e718.member.member.member) {
                                                        phi_1863_ = (_e1266.member_3 < _e718.member.member.member_3);
                                                    } else {
                                                        phi_1863_ = false;
                                                    }
                                                    let _e1281 = phi_1863_;
                                                    phi_1864_ = _e1281;
                                                }
                                                let _e1283 = phi_1864_;
                                                if _e1283 {
                                                    phi_1871_ = SlimbvhTypeK(SlimbvhTypeJ(_e1266, _e1266.member), _e718.member_1);
                                                } else {
                                                    phi_1871_ = _e718;
                                                }
                                                let _e1289 = phi_1871_;
                                                if _e1289.member_1 {
                                                    phi_1877_ = SlimbvhTypeK(SlimbvhTypeJ(_e1289.member.member, -340282350000000000000000000000000000000f), _e1289.member_1);
                                                } else {
                                                    phi_1877_ = _e1289;
                                                }
                                                let _e1298 = phi_1877_;
                                                phi_1878_ = _e1298;
                                            } else {
                                                phi_1878_ = _e718;
                                            }
                                            let _e1300 = phi_1878_;
                                            phi_1879_ = _e1300;
                                        } else {
                                            phi_1879_ = _e718;
                                        }
                                        let _e1302 = phi_1879_;
                                        phi_933_ = _e1302;
                                    } else {
                                        phi_933_ = SlimbvhTypeK();
                                    }
                                    let _e1304 = phi_933_;
                                    continue;
                                    continuing {
                                        phi_932_ = _e1304;
                                        phi_935_ = _e733;
                                        phi_2787_ = _e490;
                                        break if !(_e739);
                                    }
                                }
                                let _e1307 = phi_2787_;
                                phi_2942_ = _e1307;
                                if _e1307 {
                                    break;
                                }
                                let _e1309 = local_2;
                                phi_2946_ = _e1307;
                                let _e1572 = local_4;
                                phi_2356_ = _e1572;
                                phi_2357_ = false;
                                phi_2358_ = _e518;
                                phi_2359_ = select(_e520, 0u, (_e475 > _e1309.member.member_1));
                            } else {
                                if (_e518 >= _e75) {
                                    phi_1944_ = SlimbvhTypeM(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                } else {
                                    if (_e518 < _e75) {
                                    } else {
                                        phi_2942_ = true;
                                        break;
                                    }
                                    let _e530 = (_e170 % 3u);
                                    if (_e530 < 3u) {
                                    } else {
                                        phi_2942_ = true;
                                        break;
                                    }
                                    let _e536 = slimbvh_nodes.member[_e518].member[_e530];
                                    let _e542 = (_e169 % 3u);
                                    if (_e542 < 3u) {
                                    } else {
                                        phi_2942_ = true;
                                        break;
                                    }
                                    let _e548 = slimbvh_nodes.member[_e518].member[_e542];
                                    let _e554 = (_e171 % 3u);
                                    if (_e554 < 3u) {
                                    } else {
                                        phi_2942_ = true;
                                        break;
                                    }
                                    let _e560 = slimbvh_nodes.member[_e518].member[_e554];
                                    let _e570 = slimbvh_nodes.member[_e518].member_1;
                                    let _e574 = slimbvh_nodes.member[_e518].member_2;
                                    phi_1944_ = SlimbvhTypeM(array<vec4<f32>, 3>(vec4<f32>(_e536[0], _e536[1], _e536[2], _e536[3]), vec4<f32>(_e548[0], _e548[1], _e548[2], _e548[3]), vec4<f32>(_e560[0], _e560[1], _e560[2], _e560[3])), _e570, _e574);
                                }
                                let _e577 = phi_1944_;
                                let _e590 = ((_e577.member[0].x - _e257) * _e260);
                                let _e591 = ((_e577.member[0].y - _e257) * _e260);
                                let _e592 = ((_e577.member[0].z - _e258) * _e260);
                                let _e593 = ((_e577.member[0].w - _e258) * _e260);
                                let _e603 = ((_e577.member[1].x - _e313) * _e316);
                                let _e604 = ((_e577.member[1].y - _e313) * _e316);
                                let _e605 = ((_e577.member[1].z - _e314) * _e316);
                                let _e606 = ((_e577.member[1].w - _e314) * _e316);
                                let _e616 = ((_e577.member[2].x - _e369) * _e372);
                                let _e617 = ((_e577.member[2].y - _e369) * _e372);
                                let _e618 = ((_e577.member[2].z - _e370) * _e372);
                                let _e619 = ((_e577.member[2].w - _e370) * _e372);
                                let _e621 = select(_e618, _e616, (_e616 < _e618));
                                let _e623 = select(_e619, _e617, (_e617 < _e619));
                                let _e625 = select(_e618, _e616, (_e616 > _e618));
                                let _e627 = select(_e619, _e617, (_e617 > _e619));
                                let _e629 = select(_e592, _e590, (_e590 < _e592));
                                let _e631 = select(_e593, _e591, (_e591 < _e593));
                                let _e633 = select(_e605, _e603, (_e603 < _e605));
                                let _e635 = select(_e606, _e604, (_e604 < _e606));
                                let _e637 = select(_e633, _e629, (_e629 > _e633));
                                let _e639 = select(_e635, _e631, (_e631 > _e635));
                                let _e641 = select(_e621, _e637, (_e637 > _e621));
                                let _e643 = select(_e623, _e639, (_e639 > _e623));
                                let _e645 = select(_e592, _e590, (_e590 > _e592));
                                let _e647 = select(_e593, _e591, (_e591 > _e593));
                                let _e649 = select(_e605, _e603, (_e603 > _e605));
                                let _e651 = select(_e606, _e604, (_e604 > _e606));
                                let _e653 = select(_e649, _e645, (_e645 < _e649));
                                let _e655 = select(_e651, _e647, (_e647 < _e651));
                                let _e660 = -(_e621);
                                let _e661 = -(_e623);
                                let _e668 = (select(_e625, _e653, (_e653 < _e625)) + (select(_e660, _e625, (_e625 > _e660)) * 0.0000019073523f));
                                let _e669 = (select(_e627, _e655, (_e655 < _e627)) + (select(_e661, _e627, (_e627 > _e661)) * 0.0000019073523f));
                                let _e671 = select(_e475, _e641, (_e641 > _e475));
                                let _e673 = select(_e475, _e643, (_e643 > _e475));
                                let _e678 = (_e671 <= select(_e492.member.member_1, _e668, (_e668 < _e492.member.member_1)));
                                let _e679 = (_e673 <= select(_e492.member.member_1, _e669, (_e669 < _e492.member.member_1)));
                                let _e680 = (_e671 <= _e673);
                                if _e678 {
                                    if _e679 {
                                        if _e680 {
                                            phi_2306_ = _e577.member_2;
                                        } else {
                                            phi_2306_ = _e577.member_1;
                                        }
                                        let _e684 = phi_2306_;
                                        let _e686 = (_e520 % 128u);
                                        let _e687 = (_e686 < 128u);
                                        if _e687 {
                                        } else {
                                            phi_2942_ = true;
                                            break;
                                        }
                                        local_1[_e686] = _e684;
                                        if _e687 {
                                        } else {
                                            phi_2942_ = true;
                                            break;
                                        }
                                        local[_e686] = select(_e671, _e673, _e680);
                                        if _e680 {
                                            phi_2333_ = _e577.member_1;
                                        } else {
                                            phi_2333_ = _e577.member_2;
                                        }
                                        let _e694 = phi_2333_;
                                        phi_2334_ = _e694;
                                        phi_2335_ = (_e520 + 1u);
                                    } else {
                                        phi_2334_ = u32();
                                        phi_2335_ = u32();
                                    }
                                    let _e696 = phi_2334_;
                                    let _e698 = phi_2335_;
                                    phi_2337_ = _e696;
                                    phi_2338_ = _e698;
                                    phi_2339_ = select(true, false, _e679);
                                } else {
                                    phi_2337_ = u32();
                                    phi_2338_ = u32();
                                    phi_2339_ = true;
                                }
                                let _e701 = phi_2337_;
                                let _e703 = phi_2338_;
                                let _e705 = phi_2339_;
                                if _e705 {
                                    if _e678 {
                                        phi_2348_ = _e577.member_1;
                                    } else {
                                        phi_2348_ = _e577.member_2;
                                    }
                                    let _e709 = phi_2348_;
                                    phi_2353_ = select(_e679, true, _e678);
                                    phi_2354_ = _e709;
                                } else {
                                    phi_2353_ = _e516;
                                    phi_2354_ = _e701;
                                }
                                let _e712 = phi_2353_;
                                let _e714 = phi_2354_;
                                phi_2946_ = _e490;
                                phi_2356_ = _e492;
                                phi_2357_ = _e712;
                                phi_2358_ = _e714;
                                phi_2359_ = select(_e703, _e520, _e705);
                            }
                            let _e1315 = phi_2946_;
                            let _e1317 = phi_2356_;
                            let _e1319 = phi_2357_;
                            let _e1321 = phi_2358_;
                            let _e1323 = phi_2359_;
                            phi_2945_ = _e1315;
                            phi_2360_ = _e1317;
                            phi_2361_ = _e1319;
                            phi_2362_ = _e1321;
                            phi_2363_ = _e1323;
                            phi_2364_ = (_e500 - 1u);
                        } else {
                            phi_2945_ = _e490;
                            phi_2360_ = _e492;
                            phi_2361_ = _e516;
                            phi_2362_ = _e518;
                            phi_2363_ = _e520;
                            phi_2364_ = _e500;
                        }
                        let _e1325 = phi_2945_;
                        let _e1327 = phi_2360_;
                        let _e1329 = phi_2361_;
                        let _e1331 = phi_2362_;
                        let _e1333 = phi_2363_;
                        let _e1335 = phi_2364_;
                        phi_2944_ = _e1325;
                        phi_2365_ = _e1327;
                        phi_2366_ = _e1329;
                        phi_2367_ = _e1331;
                        phi_2368_ = _e1333;
                        phi_2369_ = _e1335;
                    } else {
                        phi_2944_ = _e490;
                        phi_2365_ = SlimbvhTypeK();
                        phi_2366_ = bool();
                        phi_2367_ = u32();
                        phi_2368_ = u32();
                        phi_2369_ = u32();
                    }
                    let _e1337 = phi_2944_;
                    let _e1339 = phi_2365_;
                    let _e1341 = phi_2366_;
                    let _e1343 = phi_2367_;
                    let _e1345 = phi_2368_;
                    let _e1347 = phi_2369_;
                    phi_2943_ = _e1337;
                    phi_864_ = _e1339;
                    phi_867_ = _e1341;
                    phi_869_ = _e1343;
                    phi_871_ = _e1345;
                    phi_873_ = _e1347;
                    phi_2370_ = _e504;
                } else {
                    phi_2943_ = _e490;
                    phi_864_ = SlimbvhTypeK();
                    phi_867_ = bool();
                    phi_869_ = u32();
                    phi_871_ = u32();
                    phi_873_ = u32();
                    phi_2370_ = false;
                }
                let _e1349 = phi_2943_;
                let _e1351 = phi_864_;
                let _e1353 = phi_867_;
                let _e1355 = phi_869_;
                let _e1357 = phi_871_;
                let _e1359 = phi_873_;
                let _e1361 = phi_2370_;
                continue;
                continuing {
                    phi_2793_ = _e1349;
                    phi_863_ = _e1351;
                    phi_866_ = _e1353;
                    phi_868_ = _e1355;
                    phi_870_ = _e1357;
                    phi_872_ = _e1359;
                    phi_2942_ = _e1349;
                    break if !(_e1361);
                }
            }
            let _e1364 = phi_2942_;
            if _e1364 {
                break;
            }
            let _e1366 = local_3;
            if (_e1366.member.member.member_3 != 4294967295u) {
                let _e1372 = -(_e377);
                let _e1373 = bitcast<u32>(_e1366.member.member.member);
                let _e1377 = (bitcast<i32>((_e1373 >> bitcast<u32>(23i))) & 255i);
                let _e1378 = (_e1377 + _e1372);
                if (_e1377 == 255i) {
                    phi_2429_ = _e1366.member.member.member;
                } else {
                    if (_e1377 > 0i) {
                        if (_e1378 > 0i) {
                            let _e1382 = (_e1378 < 255i);
                            if _e1382 {
                                phi_2408_ = bitcast<f32>((_e1373 + bitcast<u32>((_e1372 << bitcast<u32>(23i)))));
                            } else {
                                phi_2408_ = f32();
                            }
                            let _e1389 = phi_2408_;
                            phi_2410_ = _e1389;
                            phi_2411_ = select(true, false, _e1382);
                        } else {
                            phi_2410_ = f32();
                            phi_2411_ = true;
                        }
                        let _e1392 = phi_2410_;
                        let _e1394 = phi_2411_;
                        phi_2412_ = _e1392;
                        phi_2413_ = _e1394;
                    } else {
                        phi_2412_ = f32();
                        phi_2413_ = true;
                    }
                    let _e1396 = phi_2412_;
                    let _e1398 = phi_2413_;
                    if _e1398 {
                        let _e1399 = (_e1373 & 2147483648u);
                        let _e1406 = ((_e1373 & 8388607u) | (select(0u, 1u, ((_e1373 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e1410 = (_e1406 == 0u);
                        if _e1410 {
                            phi_2782_ = bitcast<f32>(_e1399);
                        } else {
                            let _e1415 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1406)), 32u, _e1410) - 8u);
                            let _e1418 = (_e1406 << bitcast<u32>((_e1415 & 31u)));
                            let _e1420 = ((_e1378 + select(0i, 1i, (_e1377 == 0i))) - bitcast<i32>(_e1415));
                            if (_e1420 >= 255i) {
                                phi_2772_ = bitcast<f32>((_e1399 | 2139095040u));
                                phi_2773_ = f32();
                                phi_2774_ = true;
                            } else {
                                let _e1422 = (_e1420 > 0i);
                                if _e1422 {
                                    phi_2766_ = bitcast<f32>(((_e1399 | (bitcast<u32>(_e1420) << bitcast<u32>(23i))) | (_e1418 & 8388607u)));
                                    phi_2767_ = f32();
                                } else {
                                    if (_e1420 < -24i) {
                                        phi_2732_ = 26u;
                                    } else {
                                        phi_2732_ = bitcast<u32>((1i - _e1420));
                                    }
                                    let _e1427 = phi_2732_;
                                    let _e1428 = (_e1427 & 31u);
                                    let _e1430 = (_e1418 >> bitcast<u32>(_e1428));
                                    let _e1434 = (_e1418 & ((1u << bitcast<u32>(_e1428)) - 1u));
                                    let _e1438 = (1u << bitcast<u32>(((_e1427 - 1u) & 31u)));
                                    if (_e1434 > _e1438) {
                                        phi_2753_ = true;
                                    } else {
                                        if (_e1434 == _e1438) {
                                            phi_2750_ = ((_e1430 & 1u) == 1u);
                                        } else {
                                            phi_2750_ = false;
                                        }
                                        let _e1444 = phi_2750_;
                                        phi_2753_ = _e1444;
                                    }
                                    let _e1446 = phi_2753_;
                                    phi_2766_ = f32();
                                    phi_2767_ = bitcast<f32>((_e1399 | (_e1430 + select(0u, 1u, _e1446))));
                                }
                                let _e1459 = phi_2766_;
                                let _e1461 = phi_2767_;
                                phi_2772_ = _e1459;
                                phi_2773_ = _e1461;
                                phi_2774_ = _e1422;
                            }
                            let _e1465 = phi_2772_;
                            let _e1467 = phi_2773_;
                            let _e1469 = phi_2774_;
                            phi_2782_ = select(_e1467, _e1465, _e1469);
                        }
                        let _e1473 = phi_2782_;
                        phi_2428_ = _e1473;
                    } else {
                        phi_2428_ = _e1396;
                    }
                    let _e1475 = phi_2428_;
                    phi_2429_ = _e1475;
                }
                let _e1477 = phi_2429_;
                let _e1478 = bitcast<u32>(_e1477);
                if ((_e1478 & 2147483647u) >= 2139095040u) {
                    phi_2441_ = bitcast<f32>(((_e1478 & 2147483648u) | 2139095039u));
                } else {
                    phi_2441_ = _e1477;
                }
                let _e1485 = phi_2441_;
                phi_2446_ = SlimbvhTypeE(_e1485, _e1366.member.member.member_1, _e1366.member.member.member_2, _e1366.member.member.member_3);
            } else {
                phi_2446_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
            }
            let _e1490 = phi_2446_;
            slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1490.member), bitcast<u32>(_e1490.member_1), bitcast<u32>(_e1490.member_2), _e1490.member_3);
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
