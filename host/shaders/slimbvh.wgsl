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
    var phi_263_: i32;
    var phi_264_: i32;
    var phi_274_: bool;
    var phi_284_: u32;
    var phi_285_: u32;
    var phi_287_: bool;
    var phi_292_: u32;
    var phi_305_: i32;
    var phi_325_: i32;
    var phi_750_: i32;
    var phi_772_: u32;
    var phi_773_: u32;
    var phi_808_: i32;
    var phi_830_: u32;
    var phi_831_: u32;
    var phi_839_: f32;
    var phi_840_: f32;
    var phi_854_: SlimbvhTypeK;
    var phi_2871_: bool;
    var phi_864_: SlimbvhTypeK;
    var phi_867_: u32;
    var phi_869_: bool;
    var phi_871_: u32;
    var phi_873_: u32;
    var phi_884_: bool;
    var phi_916_: bool;
    var phi_917_: u32;
    var phi_918_: u32;
    var phi_933_: SlimbvhTypeK;
    var phi_936_: SlimbvhTypeA;
    var phi_937_: SlimbvhTypeA;
    var phi_959_: SlimbvhTypeA;
    var phi_980_: u32;
    var phi_1072_: array<array<f32, 3>, 3>;
    var phi_2617_: bool;
    var phi_2632_: bool;
    var phi_2647_: bool;
    var phi_2662_: bool;
    var phi_2677_: bool;
    var phi_2692_: bool;
    var phi_1614_: f32;
    var phi_1615_: f32;
    var phi_1616_: f32;
    var phi_1617_: f32;
    var phi_1618_: vec3<f32>;
    var phi_1619_: vec3<f32>;
    var phi_1620_: vec3<f32>;
    var phi_1621_: vec3<f32>;
    var phi_2707_: bool;
    var phi_2722_: bool;
    var phi_2737_: bool;
    var phi_2752_: bool;
    var phi_2767_: bool;
    var phi_2782_: bool;
    var phi_1829_: f32;
    var phi_1849_: SlimbvhTypeL;
    var phi_1850_: SlimbvhTypeL;
    var phi_1853_: SlimbvhTypeL;
    var phi_1854_: SlimbvhTypeL;
    var phi_1855_: bool;
    var phi_1859_: SlimbvhTypeL;
    var phi_1868_: SlimbvhTypeE;
    var phi_1893_: bool;
    var phi_1894_: bool;
    var phi_1901_: SlimbvhTypeK;
    var phi_1907_: SlimbvhTypeK;
    var phi_1908_: SlimbvhTypeK;
    var phi_1909_: SlimbvhTypeK;
    var phi_934_: SlimbvhTypeK;
    var phi_2865_: bool;
    var phi_3067_: bool;
    var phi_1910_: SlimbvhTypeK;
    var phi_1975_: SlimbvhTypeM;
    var phi_2337_: u32;
    var phi_2364_: u32;
    var phi_2365_: u32;
    var phi_2366_: u32;
    var phi_2368_: u32;
    var phi_2369_: u32;
    var phi_2370_: bool;
    var phi_2379_: u32;
    var phi_2384_: bool;
    var phi_2386_: u32;
    var phi_2390_: bool;
    var phi_2391_: u32;
    var phi_2392_: u32;
    var phi_2402_: bool;
    var phi_2408_: u32;
    var phi_3035_: bool;
    var phi_2410_: SlimbvhTypeK;
    var phi_2411_: u32;
    var phi_2412_: bool;
    var phi_2413_: u32;
    var phi_2414_: u32;
    var phi_3034_: bool;
    var phi_2415_: SlimbvhTypeK;
    var phi_2416_: u32;
    var phi_2417_: bool;
    var phi_2418_: u32;
    var phi_2419_: u32;
    var phi_3033_: bool;
    var phi_865_: SlimbvhTypeK;
    var phi_868_: u32;
    var phi_870_: bool;
    var phi_872_: u32;
    var phi_874_: u32;
    var phi_2420_: bool;
    var phi_3032_: bool;
    var local_2: SlimbvhTypeK;
    var phi_2458_: f32;
    var phi_2460_: f32;
    var phi_2461_: bool;
    var phi_2462_: f32;
    var phi_2463_: bool;
    var phi_2810_: u32;
    var phi_2828_: bool;
    var phi_2831_: bool;
    var phi_2844_: f32;
    var phi_2845_: f32;
    var phi_2850_: f32;
    var phi_2851_: f32;
    var phi_2852_: bool;
    var phi_2860_: f32;
    var phi_2478_: f32;
    var phi_2479_: f32;
    var phi_2491_: f32;
    var phi_2496_: SlimbvhTypeE;
    var local_3: SlimbvhTypeK;

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
                    phi_263_ = (bitcast<i32>((_e135 >> bitcast<u32>(23i))) - 127i);
                } else {
                    phi_263_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e135)), 32u, (_e135 == 0u))));
                }
                let _e149 = phi_263_;
                phi_264_ = _e149;
            } else {
                phi_264_ = 0i;
            }
            let _e151 = phi_264_;
            let _e152 = (_e101 == _e115);
            if _e152 {
                phi_274_ = true;
            } else {
                phi_274_ = (_e103 == _e115);
            }
            let _e155 = phi_274_;
            let _e156 = select(1u, 0u, _e152);
            if _e155 {
                let _e157 = (_e156 + 1u);
                phi_284_ = _e157;
                phi_285_ = _e157;
                phi_287_ = select(true, false, (_e157 == 2u));
            } else {
                phi_284_ = u32();
                phi_285_ = 0u;
                phi_287_ = true;
            }
            let _e161 = phi_284_;
            let _e163 = phi_285_;
            let _e165 = phi_287_;
            if _e165 {
                phi_292_ = (_e163 + 1u);
            } else {
                phi_292_ = 0u;
            }
            let _e169 = phi_292_;
            let _e170 = select(_e161, _e163, _e165);
            let _e171 = select(_e156, select(2u, _e156, _e155), _e165);
            if (_e99 < -126i) {
                phi_305_ = -126i;
            } else {
                phi_305_ = select(_e99, 127i, (_e99 > 127i));
            }
            let _e176 = phi_305_;
            let _e181 = bitcast<f32>((bitcast<u32>((_e176 + 127i)) << bitcast<u32>(23i)));
            let _e187 = bitcast<f32>((bitcast<u32>(((_e99 - _e176) + 127i)) << bitcast<u32>(23i)));
            let _e188 = -(_e151);
            if (_e188 < -126i) {
                phi_325_ = -126i;
            } else {
                phi_325_ = select(_e188, 127i, (_e188 > 127i));
            }
            let _e193 = phi_325_;
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
                    phi_750_ = 255i;
                } else {
                    phi_750_ = (((_e390 + select(0i, 1i, (_e390 == 0i))) - _e397) + _e377);
                }
                let _e405 = phi_750_;
                let _e415 = (_e405 <= 0i);
                if _e415 {
                    phi_773_ = u32();
                } else {
                    if _e394 {
                        phi_772_ = u32();
                    } else {
                        phi_772_ = select(((bitcast<u32>(_e405) << bitcast<u32>(23i)) | ((_e387 << bitcast<u32>(((_e397 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e405 >= 255i));
                    }
                    let _e419 = phi_772_;
                    phi_773_ = _e419;
                }
                let _e421 = phi_773_;
                let _e433 = ((_e128 & 8388607u) | (select(0u, 1u, ((_e128 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                let _e436 = bitcast<i32>((_e128 >> bitcast<u32>(23i)));
                let _e440 = (_e433 == 0u);
                let _e443 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e433)), 32u, _e440)) - 8i);
                if (_e436 == 255i) {
                    phi_808_ = 255i;
                } else {
                    phi_808_ = (((_e436 + select(0i, 1i, (_e436 == 0i))) - _e443) + _e377);
                }
                let _e451 = phi_808_;
                let _e461 = (_e451 <= 0i);
                if _e461 {
                    phi_831_ = u32();
                } else {
                    if _e440 {
                        phi_830_ = u32();
                    } else {
                        phi_830_ = select(((bitcast<u32>(_e451) << bitcast<u32>(23i)) | ((_e433 << bitcast<u32>(((_e443 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e451 >= 255i));
                    }
                    let _e465 = phi_830_;
                    phi_831_ = _e465;
                }
                let _e467 = phi_831_;
                phi_839_ = bitcast<f32>(((_e127 & 2147483648u) | select(_e467, 0u, select(_e440, true, _e461))));
                phi_840_ = bitcast<f32>(((_e122 & 2147483648u) | select(_e421, 0u, select(_e394, true, _e415))));
            } else {
                phi_839_ = 0f;
                phi_840_ = 1f;
            }
            let _e473 = phi_839_;
            let _e475 = phi_840_;
            let _e476 = slimbvh_any_will_do.member;
            if (_e476 == 1u) {
                phi_854_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e473), true);
            } else {
                phi_854_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e473), false);
            }
            let _e483 = phi_854_;
            local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
            local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
            phi_2871_ = false;
            phi_864_ = _e483;
            phi_867_ = ((3u * _e75) + 1u);
            phi_869_ = (_e475 <= _e473);
            phi_871_ = 0u;
            phi_873_ = select(0u, 2147483648u, (_e75 == 0u));
            loop {
                let _e490 = phi_2871_;
                let _e492 = phi_864_;
                let _e494 = phi_867_;
                let _e496 = phi_869_;
                let _e498 = phi_871_;
                let _e500 = phi_873_;
                local_2 = _e492;
                if _e496 {
                    phi_884_ = true;
                } else {
                    phi_884_ = (_e498 > 0u);
                }
                let _e503 = phi_884_;
                if _e503 {
                    let _e504 = (_e494 > 0u);
                    if _e504 {
                        if _e496 {
                            phi_916_ = _e496;
                            phi_917_ = _e498;
                            phi_918_ = _e500;
                        } else {
                            let _e505 = (_e498 - 1u);
                            let _e506 = (_e505 % 128u);
                            let _e507 = (_e506 < 128u);
                            if _e507 {
                            } else {
                                phi_3032_ = true;
                                break;
                            }
                            let _e509 = local_1[_e506];
                            if _e507 {
                            } else {
                                phi_3032_ = true;
                                break;
                            }
                            let _e511 = local[_e506];
                            phi_916_ = (_e511 <= _e492.member.member_1);
                            phi_917_ = _e505;
                            phi_918_ = _e509;
                        }
                        let _e516 = phi_916_;
                        let _e518 = phi_917_;
                        let _e520 = phi_918_;
                        if _e516 {
                            let _e523 = ((_e520 & 2147483648u) != 0u);
                            if _e523 {
                                phi_933_ = _e492;
                                phi_936_ = SlimbvhTypeA(0u, ((_e520 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e530 = phi_933_;
                                    let _e532 = phi_936_;
                                    local_3 = _e530;
                                    if (_e532.member < _e532.member_1) {
                                        phi_937_ = SlimbvhTypeA((_e532.member + 1u), _e532.member_1);
                                        phi_959_ = SlimbvhTypeA(1u, _e532.member);
                                    } else {
                                        phi_937_ = _e532;
                                        phi_959_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                                    }
                                    let _e545 = phi_937_;
                                    let _e547 = phi_959_;
                                    let _e551 = (bitcast<i32>(_e547.member) != 0i);
                                    if _e551 {
                                        let _e552 = ((_e520 & 268435455u) + _e547.member_1);
                                        let _e553 = (_e552 < _e77);
                                        if _e553 {
                                            if _e553 {
                                            } else {
                                                phi_2865_ = true;
                                                break;
                                            }
                                            let _e557 = slimbvh_triangles.member[_e552].member_1;
                                            phi_980_ = _e557;
                                        } else {
                                            phi_980_ = 4294967295u;
                                        }
                                        let _e559 = phi_980_;
                                        if (_e552 >= _e77) {
                                            phi_1072_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                        } else {
                                            if _e553 {
                                            } else {
                                                phi_2865_ = true;
                                                break;
                                            }
                                            let _e561 = (_e170 % 3u);
                                            let _e562 = (_e169 % 3u);
                                            let _e563 = (_e171 % 3u);
                                            if (_e561 < 9u) {
                                            } else {
                                                phi_2865_ = true;
                                                break;
                                            }
                                            let _e569 = slimbvh_triangles.member[_e552].member[_e561];
                                            if (_e562 < 9u) {
                                            } else {
                                                phi_2865_ = true;
                                                break;
                                            }
                                            let _e575 = slimbvh_triangles.member[_e552].member[_e562];
                                            if (_e563 < 9u) {
                                            } else {
                                                phi_2865_ = true;
                                                break;
                                            }
                                            let _e581 = slimbvh_triangles.member[_e552].member[_e563];
                                            let _e583 = (3u + _e561);
                                            if (_e583 < 9u) {
                                            } else {
                                                phi_2865_ = true;
                                                break;
                                            }
                                            let _e589 = slimbvh_triangles.member[_e552].member[_e583];
                                            let _e590 = (3u + _e562);
                                            if (_e590 < 9u) {
                                            } else {
                                                phi_2865_ = true;
                                                break;
                                            }
                                            let _e596 = slimbvh_triangles.member[_e552].member[_e590];
                                            let _e597 = (3u + _e563);
                                            if (_e597 < 9u) {
                                            } else {
                                                phi_2865_ = true;
                                                break;
                                            }
                                            let _e603 = slimbvh_triangles.member[_e552].member[_e597];
                                            let _e605 = (6u + _e561);
                                            if (_e605 < 9u) {
                                            } else {
                                                phi_2865_ = true;
                                                break;
                                            }
                                            let _e611 = slimbvh_triangles.member[_e552].member[_e605];
                                            let _e612 = (6u + _e562);
                                            if (_e612 < 9u) {
                                            } else {
                                                phi_2865_ = true;
                                                break;
                                            }
                                            let _e618 = slimbvh_triangles.member[_e552].member[_e612];
                                            let _e619 = (6u + _e563);
                                            if (_e619 < 9u) {
                                            } else {
                                                phi_2865_ = true;
                                                break;
                                            }
                                            let _e625 = slimbvh_triangles.member[_e552].member[_e619];
                                            phi_1072_ = array<array<f32, 3>, 3>(array<f32, 3>(_e569, _e575, _e581), array<f32, 3>(_e589, _e596, _e603), array<f32, 3>(_e611, _e618, _e625));
                                        }
                                        let _e629 = phi_1072_;
                                        let _e646 = (_e629[0][2] - _e337);
                                        let _e649 = (((_e629[0][0] - _e225) * _e368) - (_e646 * _e256));
                                        let _e652 = (((_e629[0][1] - _e281) * _e368) - (_e646 * _e312));
                                        let _e655 = (_e629[1][2] - _e337);
                                        let _e658 = (((_e629[1][0] - _e225) * _e368) - (_e655 * _e256));
                                        let _e661 = (((_e629[1][1] - _e281) * _e368) - (_e655 * _e312));
                                        let _e664 = (_e629[2][2] - _e337);
                                        let _e667 = (((_e629[2][0] - _e225) * _e368) - (_e664 * _e256));
                                        let _e670 = (((_e629[2][1] - _e281) * _e368) - (_e664 * _e312));
                                        let _e671 = (_e667 * _e661);
                                        let _e672 = (_e670 * _e658);
                                        let _e673 = (_e649 * _e670);
                                        let _e674 = (_e652 * _e667);
                                        let _e675 = (_e658 * _e652);
                                        let _e676 = (_e661 * _e649);
                                        let _e681 = (((_e671 >= _e672) && (_e673 >= _e674)) && (_e675 >= _e676));
                                        let _e687 = (_e681 || (((_e671 <= _e672) && (_e673 <= _e674)) && (_e675 <= _e676)));
                                        if _e687 {
                                            let _e689 = select(-1f, 1f, _e681);
                                            let _e691 = ((_e671 - _e672) * _e689);
                                            let _e693 = select(0f, _e691, (_e691 > 0f));
                                            let _e695 = ((_e673 - _e674) * _e689);
                                            let _e697 = select(0f, _e695, (_e695 > 0f));
                                            let _e699 = ((_e675 - _e676) * _e689);
                                            let _e701 = select(0f, _e699, (_e699 > 0f));
                                            let _e703 = ((_e693 + _e697) + _e701);
                                            let _e705 = select(_e629[1][0], _e629[0][0], (_e629[0][0] < _e629[1][0]));
                                            let _e709 = select(_e629[1][0], _e629[0][0], (_e629[0][0] > _e629[1][0]));
                                            let _e713 = select(_e629[1][1], _e629[0][1], (_e629[0][1] < _e629[1][1]));
                                            let _e717 = select(_e629[1][1], _e629[0][1], (_e629[0][1] > _e629[1][1]));
                                            let _e721 = select(_e629[1][2], _e629[0][2], (_e629[0][2] < _e629[1][2]));
                                            let _e725 = select(_e629[1][2], _e629[0][2], (_e629[0][2] > _e629[1][2]));
                                            let _e730 = ((select(_e629[2][0], _e705, (_e705 < _e629[2][0])) - _e257) * _e260);
                                            let _e731 = ((select(_e629[2][0], _e709, (_e709 > _e629[2][0])) - _e258) * _e260);
                                            let _e734 = ((select(_e629[2][1], _e713, (_e713 < _e629[2][1])) - _e313) * _e316);
                                            let _e735 = ((select(_e629[2][1], _e717, (_e717 > _e629[2][1])) - _e314) * _e316);
                                            let _e738 = ((select(_e629[2][2], _e721, (_e721 < _e629[2][2])) - _e369) * _e372);
                                            let _e739 = ((select(_e629[2][2], _e725, (_e725 > _e629[2][2])) - _e370) * _e372);
                                            let _e741 = select(_e739, _e738, (_e738 < _e739));
                                            let _e743 = select(_e739, _e738, (_e738 > _e739));
                                            let _e745 = select(_e731, _e730, (_e730 < _e731));
                                            let _e747 = select(_e735, _e734, (_e734 < _e735));
                                            let _e749 = select(_e747, _e745, (_e745 > _e747));
                                            let _e751 = select(_e741, _e749, (_e749 > _e741));
                                            let _e753 = select(_e731, _e730, (_e730 > _e731));
                                            let _e755 = select(_e735, _e734, (_e734 > _e735));
                                            let _e757 = select(_e755, _e753, (_e753 < _e755));
                                            let _e759 = select(_e743, _e757, (_e757 < _e743));
                                            let _e760 = -(_e741);
                                            let _e766 = select(_e475, _e751, (_e751 > _e475));
                                            let _e770 = select(_e658, _e649, (_e649 < _e658));
                                            let _e775 = select(_e658, _e649, (_e649 > _e658));
                                            let _e782 = select(_e661, _e652, (_e652 < _e661));
                                            let _e787 = select(_e661, _e652, (_e652 > _e661));
                                            let _e796 = (((((_e687 && (_e703 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e667, _e770, (_e770 < _e667)) <= 0f) && (select(_e667, _e775, (_e775 > _e667)) >= 0f))) && ((select(_e670, _e782, (_e782 < _e670)) <= 0f) && (select(_e670, _e787, (_e787 > _e670)) >= 0f))) && (_e766 <= (_e759 + (select(_e760, _e743, (_e743 > _e760)) * 0.0000019073523f)))) && (_e766 <= _e530.member.member_1));
                                            if _e796 {
                                                let _e801 = (_e629[1][0] - _e629[0][0]);
                                                let _e802 = (_e629[1][1] - _e629[0][1]);
                                                let _e803 = (_e629[1][2] - _e629[0][2]);
                                                let _e804 = vec3<f32>(_e801, _e802, _e803);
                                                let _e805 = (_e629[2][0] - _e629[1][0]);
                                                let _e806 = (_e629[2][1] - _e629[1][1]);
                                                let _e807 = (_e629[2][2] - _e629[1][2]);
                                                let _e808 = vec3<f32>(_e805, _e806, _e807);
                                                let _e809 = (_e629[0][0] - _e629[2][0]);
                                                let _e810 = (_e629[0][1] - _e629[2][1]);
                                                let _e811 = (_e629[0][2] - _e629[2][2]);
                                                let _e812 = vec3<f32>(_e809, _e810, _e811);
                                                let _e813 = abs(_e801);
                                                let _e814 = abs(_e802);
                                                if (_e813 != _e813) {
                                                    phi_2617_ = true;
                                                } else {
                                                    phi_2617_ = (_e814 >= _e813);
                                                }
                                                let _e818 = phi_2617_;
                                                let _e819 = select(_e813, _e814, _e818);
                                                let _e820 = abs(_e803);
                                                if (_e819 != _e819) {
                                                    phi_2632_ = true;
                                                } else {
                                                    phi_2632_ = (_e820 >= _e819);
                                                }
                                                let _e824 = phi_2632_;
                                                let _e825 = select(_e819, _e820, _e824);
                                                let _e826 = abs(_e805);
                                                let _e827 = abs(_e806);
                                                if (_e826 != _e826) {
                                                    phi_2647_ = true;
                                                } else {
                                                    phi_2647_ = (_e827 >= _e826);
                                                }
                                                let _e831 = phi_2647_;
                                                let _e832 = select(_e826, _e827, _e831);
                                                let _e833 = abs(_e807);
                                                if (_e832 != _e832) {
                                                    phi_2662_ = true;
                                                } else {
                                                    phi_2662_ = (_e833 >= _e832);
                                                }
                                                let _e837 = phi_2662_;
                                                let _e838 = select(_e832, _e833, _e837);
                                                let _e839 = abs(_e809);
                                                let _e840 = abs(_e810);
                                                if (_e839 != _e839) {
                                                    phi_2677_ = true;
                                                } else {
                                                    phi_2677_ = (_e840 >= _e839);
                                                }
                                                let _e844 = phi_2677_;
                                                let _e845 = select(_e839, _e840, _e844);
                                                let _e846 = abs(_e811);
                                                if (_e845 != _e845) {
                                                    phi_2692_ = true;
                                                } else {
                                                    phi_2692_ = (_e846 >= _e845);
                                                }
                                                let _e850 = phi_2692_;
                                                let _e851 = select(_e845, _e846, _e850);
                                                let _e853 = select(_e838, _e825, (_e825 > _e838));
                                                let _e855 = select(_e851, _e853, (_e853 > _e851));
                                                if (_e825 == _e855) {
                                                    phi_1614_ = _e661;
                                                    phi_1615_ = _e658;
                                                    phi_1616_ = _e652;
                                                    phi_1617_ = _e649;
                                                    phi_1618_ = vec3<f32>(_e629[0][0], _e629[0][1], _e629[0][2]);
                                                    phi_1619_ = _e812;
                                                    phi_1620_ = _e808;
                                                    phi_1621_ = _e804;
                                                } else {
                                                    let _e857 = (_e838 == _e855);
                                                    let _e862 = vec3(_e857);
                                                    phi_1614_ = select(_e652, _e670, _e857);
                                                    phi_1615_ = select(_e649, _e667, _e857);
                                                    phi_1616_ = select(_e670, _e661, _e857);
                                                    phi_1617_ = select(_e667, _e658, _e857);
                                                    phi_1618_ = select(vec3<f32>(_e629[2][0], _e629[2][1], _e629[2][2]), vec3<f32>(_e629[1][0], _e629[1][1], _e629[1][2]), _e862);
                                                    phi_1619_ = select(_e808, _e804, _e862);
                                                    phi_1620_ = select(_e804, _e812, _e862);
                                                    phi_1621_ = select(_e812, _e808, _e862);
                                                }
                                                let _e868 = phi_1614_;
                                                let _e870 = phi_1615_;
                                                let _e872 = phi_1616_;
                                                let _e874 = phi_1617_;
                                                let _e876 = phi_1618_;
                                                let _e878 = phi_1619_;
                                                let _e880 = phi_1620_;
                                                let _e882 = phi_1621_;
                                                let _e889 = ((_e880.y * _e878.z) - (_e878.y * _e880.z));
                                                let _e894 = ((_e880.z * _e878.x) - (_e878.z * _e880.x));
                                                let _e897 = ((_e880.x * _e878.y) - (_e878.x * _e880.y));
                                                let _e900 = ((_e693 >= _e697) && (_e693 >= _e701));
                                                let _e901 = (_e697 >= _e701);
                                                let _e915 = (((_e889 * (select(select(_e629[2][0], _e629[1][0], _e901), _e629[0][0], _e900) - _e225)) + (_e894 * (select(select(_e629[2][1], _e629[1][1], _e901), _e629[0][1], _e900) - _e281))) + (_e897 * (select(select(_e629[2][2], _e629[1][2], _e901), _e629[0][2], _e900) - _e337)));
                                                let _e920 = (((_e889 * _e256) + (_e894 * _e312)) + (_e897 * _e368));
                                                let _e921 = (_e870 - _e874);
                                                let _e922 = (_e868 - _e872);
                                                let _e925 = ((_e921 * _e921) + (_e922 * _e922));
                                                let _e932 = (-(((_e874 * _e921) + (_e872 * _e922))) / select(0.000000000000000000000000000000000000011754944f, _e925, (_e925 > 0.000000000000000000000000000000000000011754944f)));
                                                let _e934 = select(1f, _e932, (_e932 < 1f));
                                                let _e936 = select(0f, _e934, (_e934 > 0f));
                                                let _e945 = ((_e876.x + (_e882.x * _e936)) - _e225);
                                                let _e948 = ((_e876.y + (_e882.y * _e936)) - _e281);
                                                let _e951 = ((_e876.z + (_e882.z * _e936)) - _e337);
                                                let _e954 = bitcast<f32>((bitcast<u32>(_e945) & 2147483647u));
                                                let _e957 = bitcast<f32>((bitcast<u32>(_e948) & 2147483647u));
                                                let _e959 = select(_e957, _e954, (_e954 > _e957));
                                                let _e962 = bitcast<f32>((bitcast<u32>(_e951) & 2147483647u));
                                                let _e964 = select(_e962, _e959, (_e959 > _e962));
                                                let _e968 = abs(_e889);
                                                let _e969 = abs(_e894);
                                                if (_e968 != _e968) {
                                                    phi_2707_ = true;
                                                } else {
                                                    phi_2707_ = (_e969 >= _e968);
                                                }
                                                let _e973 = phi_2707_;
                                                let _e974 = select(_e968, _e969, _e973);
                                                let _e975 = abs(_e897);
                                                if (_e974 != _e974) {
                                                    phi_2722_ = true;
                                                } else {
                                                    phi_2722_ = (_e975 >= _e974);
                                                }
                                                let _e979 = phi_2722_;
                                                let _e995 = abs(_e880.x);
                                                let _e996 = abs(_e880.y);
                                                if (_e995 != _e995) {
                                                    phi_2737_ = true;
                                                } else {
                                                    phi_2737_ = (_e996 >= _e995);
                                                }
                                                let _e1000 = phi_2737_;
                                                let _e1001 = select(_e995, _e996, _e1000);
                                                let _e1002 = abs(_e880.z);
                                                if (_e1001 != _e1001) {
                                                    phi_2752_ = true;
                                                } else {
                                                    phi_2752_ = (_e1002 >= _e1001);
                                                }
                                                let _e1006 = phi_2752_;
                                                let _e1009 = abs(_e878.x);
                                                let _e1010 = abs(_e878.y);
                                                if (_e1009 != _e1009) {
                                                    phi_2767_ = true;
                                                } else {
                                                    phi_2767_ = (_e1010 >= _e1009);
                                                }
                                                let _e1014 = phi_2767_;
                                                let _e1015 = select(_e1009, _e1010, _e1014);
                                                let _e1016 = abs(_e878.z);
                                                if (_e1015 != _e1015) {
                                                    phi_2782_ = true;
                                                } else {
                                                    phi_2782_ = (_e1016 >= _e1015);
                                                }
                                                let _e1020 = phi_2782_;
                                                let _e1025 = ((bitcast<f32>((bitcast<u32>(((((_e889 * _e945) + (_e894 * _e948)) + (_e897 * _e951)) - _e915)) & 2147483647u)) <= ((0.0000009536743f * select(_e855, _e964, (_e964 > _e855))) * select(_e974, _e975, _e979))) && !((bitcast<f32>((bitcast<u32>(_e920) & 2147483647u)) <= ((0.0000038146973f * select(_e1001, _e1002, _e1006)) * select(_e1015, _e1016, _e1020)))));
                                                let _e1026 = (_e915 / _e920);
                                                if (_e796 && !(_e1025)) {
                                                    let _e1029 = (_e951 / _e368);
                                                    let _e1037 = (((_e889 * (_e945 - (_e256 * _e1029))) + (_e894 * (_e948 - (_e312 * _e1029)))) / _e920);
                                                    phi_1829_ = select(select(_e1029, (_e1029 + _e1037), (bitcast<f32>((bitcast<u32>(_e1037) & 2147483647u)) <= _e855)), _e1026, _e1025);
                                                } else {
                                                    phi_1829_ = _e1026;
                                                }
                                                let _e1046 = phi_1829_;
                                                let _e1048 = select(_e759, _e1046, (_e1046 < _e759));
                                                let _e1050 = select(_e751, _e1048, (_e1048 > _e751));
                                                let _e1051 = (1f / _e703);
                                                phi_1849_ = SlimbvhTypeL(_e1050, (_e697 * _e1051), (_e701 * _e1051), ((_e796 && (_e1050 >= _e475)) && (_e1050 <= _e530.member.member_1)));
                                                phi_1850_ = SlimbvhTypeL();
                                            } else {
                                                phi_1849_ = SlimbvhTypeL();
                                                phi_1850_ = SlimbvhTypeL(0f, 0f, 0f, _e796);
                                            }
                                            let _e1060 = phi_1849_;
                                            let _e1062 = phi_1850_;
                                            phi_1853_ = _e1060;
                                            phi_1854_ = _e1062;
                                            phi_1855_ = select(true, false, _e796);
                                        } else {
                                            phi_1853_ = SlimbvhTypeL();
                                            phi_1854_ = SlimbvhTypeL(0f, 0f, 0f, _e687);
                                            phi_1855_ = true;
                                        }
                                        let _e1065 = phi_1853_;
                                        let _e1067 = phi_1854_;
                                        let _e1069 = phi_1855_;
                                        if _e1069 {
                                            phi_1859_ = _e1067;
                                        } else {
                                            phi_1859_ = _e1065;
                                        }
                                        let _e1071 = phi_1859_;
                                        if _e1071.member_3 {
                                            phi_1868_ = SlimbvhTypeE(_e1071.member, _e1071.member_1, _e1071.member_2, _e559);
                                        } else {
                                            phi_1868_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                        }
                                        let _e1078 = phi_1868_;
                                        if (_e1078.member_3 != 4294967295u) {
                                            if (_e559 != 4294967295u) {
                                                if (_e1078.member < _e530.member.member.member) {
                                                    phi_1894_ = true;
                                                } else {
                                                    if (_e1078.member == _e530.member.member.member) {
                                                        phi_1893_ = (_e1078.member_3 < _e530.member.member.member_3);
                                                    } else {
                                                        phi_1893_ = false;
                                                    }
                                                    let _e1093 = phi_1893_;
                                                    phi_1894_ = _e1093;
                                                }
                                                let _e1095 = phi_1894_;
                                                if _e1095 {
                                                    phi_1901_ = SlimbvhTypeK(SlimbvhTypeJ(_e1078, _e1078.member), _e530.member_1);
                                                } else {
                                                    phi_1901_ = _e530;
                                                }
                                                let _e1101 = phi_1901_;
                                                if _e1101.member_1 {
                                                    phi_1907_ = SlimbvhTypeK(SlimbvhTypeJ(_e1101.member.member, -340282350000000000000000000000000000000f), _e1101.member_1);
                                                } else {
                                                    phi_1907_ = _e1101;
                                                }
                                                let _e1110 = phi_1907_;
                                                phi_1908_ = _e1110;
                                            } else {
                                                phi_1908_ = _e530;
                                            }
                                            let _e1112 = phi_1908_;
                                            phi_1909_ = _e1112;
                                        } else {
                                            phi_1909_ = _e530;
                                        }
                                        let _e1114 = phi_1909_;
                                        phi_934_ = _e1114;
                                    } else {
                                        phi_934_ = SlimbvhTypeK();
                                    }
                                    let _e1116 = phi_934_;
                                    continue;
                                    continuing {
                                        phi_933_ = _e1116;
                                        phi_936_ = _e545;
                                        phi_2865_ = _e490;
                                        break if !(_e551);
                                    }
                                }
                                let _e1119 = phi_2865_;
                                phi_3032_ = _e1119;
                                if _e1119 {
                                    break;
                                }
                                phi_3067_ = _e1119;
                                let _e1578 = local_3;
                                phi_1910_ = _e1578;
                            } else {
                                phi_3067_ = _e490;
                                phi_1910_ = _e492;
                            }
                            let _e1121 = phi_3067_;
                            let _e1123 = phi_1910_;
                            if _e523 {
                                phi_2390_ = bool();
                                phi_2391_ = u32();
                                phi_2392_ = u32();
                            } else {
                                if (_e520 >= _e75) {
                                    phi_1975_ = SlimbvhTypeM(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                } else {
                                    if (_e520 < _e75) {
                                    } else {
                                        phi_3032_ = true;
                                        break;
                                    }
                                    let _e1126 = (_e170 % 3u);
                                    if (_e1126 < 3u) {
                                    } else {
                                        phi_3032_ = true;
                                        break;
                                    }
                                    let _e1132 = slimbvh_nodes.member[_e520].member[_e1126];
                                    let _e1138 = (_e169 % 3u);
                                    if (_e1138 < 3u) {
                                    } else {
                                        phi_3032_ = true;
                                        break;
                                    }
                                    let _e1144 = slimbvh_nodes.member[_e520].member[_e1138];
                                    let _e1150 = (_e171 % 3u);
                                    if (_e1150 < 3u) {
                                    } else {
                                        phi_3032_ = true;
                                        break;
                                    }
                                    let _e1156 = slimbvh_nodes.member[_e520].member[_e1150];
                                    let _e1166 = slimbvh_nodes.member[_e520].member_1;
                                    let _e1170 = slimbvh_nodes.member[_e520].member_2;
                                    phi_1975_ = SlimbvhTypeM(array<vec4<f32>, 3>(vec4<f32>(_e1132[0], _e1132[1], _e1132[2], _e1132[3]), vec4<f32>(_e1144[0], _e1144[1], _e1144[2], _e1144[3]), vec4<f32>(_e1156[0], _e1156[1], _e1156[2], _e1156[3])), _e1166, _e1170);
                                }
                                let _e1173 = phi_1975_;
                                let _e1186 = ((_e1173.member[0].x - _e257) * _e260);
                                let _e1187 = ((_e1173.member[0].y - _e257) * _e260);
                                let _e1188 = ((_e1173.member[0].z - _e258) * _e260);
                                let _e1189 = ((_e1173.member[0].w - _e258) * _e260);
                                let _e1199 = ((_e1173.member[1].x - _e313) * _e316);
                                let _e1200 = ((_e1173.member[1].y - _e313) * _e316);
                                let _e1201 = ((_e1173.member[1].z - _e314) * _e316);
                                let _e1202 = ((_e1173.member[1].w - _e314) * _e316);
                                let _e1212 = ((_e1173.member[2].x - _e369) * _e372);
                                let _e1213 = ((_e1173.member[2].y - _e369) * _e372);
                                let _e1214 = ((_e1173.member[2].z - _e370) * _e372);
                                let _e1215 = ((_e1173.member[2].w - _e370) * _e372);
                                let _e1217 = select(_e1214, _e1212, (_e1212 < _e1214));
                                let _e1219 = select(_e1215, _e1213, (_e1213 < _e1215));
                                let _e1221 = select(_e1214, _e1212, (_e1212 > _e1214));
                                let _e1223 = select(_e1215, _e1213, (_e1213 > _e1215));
                                let _e1225 = select(_e1188, _e1186, (_e1186 < _e1188));
                                let _e1227 = select(_e1189, _e1187, (_e1187 < _e1189));
                                let _e1229 = select(_e1201, _e1199, (_e1199 < _e1201));
                                let _e1231 = select(_e1202, _e1200, (_e1200 < _e1202));
                                let _e1233 = select(_e1229, _e1225, (_e1225 > _e1229));
                                let _e1235 = select(_e1231, _e1227, (_e1227 > _e1231));
                                let _e1237 = select(_e1217, _e1233, (_e1233 > _e1217));
                                let _e1239 = select(_e1219, _e1235, (_e1235 > _e1219));
                                let _e1241 = select(_e1188, _e1186, (_e1186 > _e1188));
                                let _e1243 = select(_e1189, _e1187, (_e1187 > _e1189));
                                let _e1245 = select(_e1201, _e1199, (_e1199 > _e1201));
                                let _e1247 = select(_e1202, _e1200, (_e1200 > _e1202));
                                let _e1249 = select(_e1245, _e1241, (_e1241 < _e1245));
                                let _e1251 = select(_e1247, _e1243, (_e1243 < _e1247));
                                let _e1256 = -(_e1217);
                                let _e1257 = -(_e1219);
                                let _e1264 = (select(_e1221, _e1249, (_e1249 < _e1221)) + (select(_e1256, _e1221, (_e1221 > _e1256)) * 0.0000019073523f));
                                let _e1265 = (select(_e1223, _e1251, (_e1251 < _e1223)) + (select(_e1257, _e1223, (_e1223 > _e1257)) * 0.0000019073523f));
                                let _e1267 = select(_e475, _e1237, (_e1237 > _e475));
                                let _e1269 = select(_e475, _e1239, (_e1239 > _e475));
                                let _e1274 = (_e1267 <= select(_e1123.member.member_1, _e1264, (_e1264 < _e1123.member.member_1)));
                                let _e1275 = (_e1269 <= select(_e1123.member.member_1, _e1265, (_e1265 < _e1123.member.member_1)));
                                let _e1276 = (_e1267 <= _e1269);
                                if _e1274 {
                                    if _e1275 {
                                        if _e1276 {
                                            phi_2337_ = _e1173.member_2;
                                        } else {
                                            phi_2337_ = _e1173.member_1;
                                        }
                                        let _e1280 = phi_2337_;
                                        let _e1282 = (_e518 % 128u);
                                        let _e1283 = (_e1282 < 128u);
                                        if _e1283 {
                                        } else {
                                            phi_3032_ = true;
                                            break;
                                        }
                                        local_1[_e1282] = _e1280;
                                        if _e1283 {
                                        } else {
                                            phi_3032_ = true;
                                            break;
                                        }
                                        local[_e1282] = select(_e1267, _e1269, _e1276);
                                        if _e1276 {
                                            phi_2364_ = _e1173.member_1;
                                        } else {
                                            phi_2364_ = _e1173.member_2;
                                        }
                                        let _e1290 = phi_2364_;
                                        phi_2365_ = (_e518 + 1u);
                                        phi_2366_ = _e1290;
                                    } else {
                                        phi_2365_ = u32();
                                        phi_2366_ = u32();
                                    }
                                    let _e1292 = phi_2365_;
                                    let _e1294 = phi_2366_;
                                    phi_2368_ = _e1292;
                                    phi_2369_ = _e1294;
                                    phi_2370_ = select(true, false, _e1275);
                                } else {
                                    phi_2368_ = u32();
                                    phi_2369_ = u32();
                                    phi_2370_ = true;
                                }
                                let _e1297 = phi_2368_;
                                let _e1299 = phi_2369_;
                                let _e1301 = phi_2370_;
                                if _e1301 {
                                    if _e1274 {
                                        phi_2379_ = _e1173.member_1;
                                    } else {
                                        phi_2379_ = _e1173.member_2;
                                    }
                                    let _e1305 = phi_2379_;
                                    phi_2384_ = select(_e1275, true, _e1274);
                                    phi_2386_ = _e1305;
                                } else {
                                    phi_2384_ = _e516;
                                    phi_2386_ = _e1299;
                                }
                                let _e1308 = phi_2384_;
                                let _e1310 = phi_2386_;
                                phi_2390_ = _e1308;
                                phi_2391_ = select(_e1297, _e518, _e1301);
                                phi_2392_ = _e1310;
                            }
                            let _e1313 = phi_2390_;
                            let _e1315 = phi_2391_;
                            let _e1317 = phi_2392_;
                            if _e523 {
                                if _e1123.member_1 {
                                    phi_2402_ = (_e1123.member.member.member_3 != 4294967295u);
                                } else {
                                    phi_2402_ = false;
                                }
                                let _e1324 = phi_2402_;
                                phi_2408_ = select(_e518, 0u, _e1324);
                            } else {
                                phi_2408_ = _e1315;
                            }
                            let _e1327 = phi_2408_;
                            phi_3035_ = _e1121;
                            phi_2410_ = _e1123;
                            phi_2411_ = (_e494 - 1u);
                            phi_2412_ = select(_e1313, false, _e523);
                            phi_2413_ = _e1327;
                            phi_2414_ = select(_e1317, _e520, _e523);
                        } else {
                            phi_3035_ = _e490;
                            phi_2410_ = _e492;
                            phi_2411_ = _e494;
                            phi_2412_ = _e516;
                            phi_2413_ = _e518;
                            phi_2414_ = _e520;
                        }
                        let _e1331 = phi_3035_;
                        let _e1333 = phi_2410_;
                        let _e1335 = phi_2411_;
                        let _e1337 = phi_2412_;
                        let _e1339 = phi_2413_;
                        let _e1341 = phi_2414_;
                        phi_3034_ = _e1331;
                        phi_2415_ = _e1333;
                        phi_2416_ = _e1335;
                        phi_2417_ = _e1337;
                        phi_2418_ = _e1339;
                        phi_2419_ = _e1341;
                    } else {
                        phi_3034_ = _e490;
                        phi_2415_ = SlimbvhTypeK();
                        phi_2416_ = u32();
                        phi_2417_ = bool();
                        phi_2418_ = u32();
                        phi_2419_ = u32();
                    }
                    let _e1343 = phi_3034_;
                    let _e1345 = phi_2415_;
                    let _e1347 = phi_2416_;
                    let _e1349 = phi_2417_;
                    let _e1351 = phi_2418_;
                    let _e1353 = phi_2419_;
                    phi_3033_ = _e1343;
                    phi_865_ = _e1345;
                    phi_868_ = _e1347;
                    phi_870_ = _e1349;
                    phi_872_ = _e1351;
                    phi_874_ = _e1353;
                    phi_2420_ = _e504;
                } else {
                    phi_3033_ = _e490;
                    phi_865_ = SlimbvhTypeK();
                    phi_868_ = u32();
                    phi_870_ = bool();
                    phi_872_ = u32();
                    phi_874_ = u32();
                    phi_2420_ = false;
                }
                let _e1355 = phi_3033_;
                let _e1357 = phi_865_;
                let _e1359 = phi_868_;
                let _e1361 = phi_870_;
                let _e1363 = phi_872_;
                let _e1365 = phi_874_;
                let _e1367 = phi_2420_;
                continue;
                continuing {
                    phi_2871_ = _e1355;
                    phi_864_ = _e1357;
                    phi_867_ = _e1359;
                    phi_869_ = _e1361;
                    phi_871_ = _e1363;
                    phi_873_ = _e1365;
                    phi_3032_ = _e1355;
                    break if !(_e1367);
                }
            }
            let _e1370 = phi_3032_;
            if _e1370 {
                break;
            }
            let _e1372 = local_2;
            if (_e1372.member.member.member_3 != 4294967295u) {
                let _e1378 = -(_e377);
                let _e1379 = bitcast<u32>(_e1372.member.member.member);
                let _e1383 = (bitcast<i32>((_e1379 >> bitcast<u32>(23i))) & 255i);
                let _e1384 = (_e1383 + _e1378);
                if (_e1383 == 255i) {
                    phi_2479_ = _e1372.member.member.member;
                } else {
                    if (_e1383 > 0i) {
                        if (_e1384 > 0i) {
                            let _e1388 = (_e1384 < 255i);
                            if _e1388 {
                                phi_2458_ = bitcast<f32>((_e1379 + bitcast<u32>((_e1378 << bitcast<u32>(23i)))));
                            } else {
                                phi_2458_ = f32();
                            }
                            let _e1395 = phi_2458_;
                            phi_2460_ = _e1395;
                            phi_2461_ = select(true, false, _e1388);
                        } else {
                            phi_2460_ = f32();
                            phi_2461_ = true;
                        }
                        let _e1398 = phi_2460_;
                        let _e1400 = phi_2461_;
                        phi_2462_ = _e1398;
                        phi_2463_ = _e1400;
                    } else {
                        phi_2462_ = f32();
                        phi_2463_ = true;
                    }
                    let _e1402 = phi_2462_;
                    let _e1404 = phi_2463_;
                    if _e1404 {
                        let _e1405 = (_e1379 & 2147483648u);
                        let _e1412 = ((_e1379 & 8388607u) | (select(0u, 1u, ((_e1379 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e1416 = (_e1412 == 0u);
                        if _e1416 {
                            phi_2860_ = bitcast<f32>(_e1405);
                        } else {
                            let _e1421 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1412)), 32u, _e1416) - 8u);
                            let _e1424 = (_e1412 << bitcast<u32>((_e1421 & 31u)));
                            let _e1426 = ((_e1384 + select(0i, 1i, (_e1383 == 0i))) - bitcast<i32>(_e1421));
                            if (_e1426 >= 255i) {
                                phi_2850_ = bitcast<f32>((_e1405 | 2139095040u));
                                phi_2851_ = f32();
                                phi_2852_ = true;
                            } else {
                                let _e1428 = (_e1426 > 0i);
                                if _e1428 {
                                    phi_2844_ = bitcast<f32>(((_e1405 | (bitcast<u32>(_e1426) << bitcast<u32>(23i))) | (_e1424 & 8388607u)));
                                    phi_2845_ = f32();
                                } else {
                                    if (_e1426 < -24i) {
                                        phi_2810_ = 26u;
                                    } else {
                                        phi_2810_ = bitcast<u32>((1i - _e1426));
                                    }
                                    let _e1433 = phi_2810_;
                                    let _e1434 = (_e1433 & 31u);
                                    let _e1436 = (_e1424 >> bitcast<u32>(_e1434));
                                    let _e1440 = (_e1424 & ((1u << bitcast<u32>(_e1434)) - 1u));
                                    let _e1444 = (1u << bitcast<u32>(((_e1433 - 1u) & 31u)));
                                    if (_e1440 > _e1444) {
                                        phi_2831_ = true;
                                    } else {
                                        if (_e1440 == _e1444) {
                                            phi_2828_ = ((_e1436 & 1u) == 1u);
                                        } else {
                                            phi_2828_ = false;
                                        }
                                        let _e1450 = phi_2828_;
                                        phi_2831_ = _e1450;
                                    }
                                    let _e1452 = phi_2831_;
                                    phi_2844_ = f32();
                                    phi_2845_ = bitcast<f32>((_e1405 | (_e1436 + select(0u, 1u, _e1452))));
                                }
                                let _e1465 = phi_2844_;
                                let _e1467 = phi_2845_;
                                phi_2850_ = _e1465;
                                phi_2851_ = _e1467;
                                phi_2852_ = _e1428;
                            }
                            let _e1471 = phi_2850_;
                            let _e1473 = phi_2851_;
                            let _e1475 = phi_2852_;
                            phi_2860_ = select(_e1473, _e1471, _e1475);
                        }
                        let _e1479 = phi_2860_;
                        phi_2478_ = _e1479;
                    } else {
                        phi_2478_ = _e1402;
                    }
                    let _e1481 = phi_2478_;
                    phi_2479_ = _e1481;
                }
                let _e1483 = phi_2479_;
                let _e1484 = bitcast<u32>(_e1483);
                if ((_e1484 & 2147483647u) >= 2139095040u) {
                    phi_2491_ = bitcast<f32>(((_e1484 & 2147483648u) | 2139095039u));
                } else {
                    phi_2491_ = _e1483;
                }
                let _e1491 = phi_2491_;
                phi_2496_ = SlimbvhTypeE(_e1491, _e1372.member.member.member_1, _e1372.member.member.member_2, _e1372.member.member.member_3);
            } else {
                phi_2496_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
            }
            let _e1496 = phi_2496_;
            slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1496.member), bitcast<u32>(_e1496.member_1), bitcast<u32>(_e1496.member_2), _e1496.member_3);
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
