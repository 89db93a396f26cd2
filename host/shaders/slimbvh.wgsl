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
    var phi_234_: i32;
    var phi_235_: i32;
    var phi_245_: bool;
    var phi_255_: u32;
    var phi_256_: u32;
    var phi_258_: bool;
    var phi_263_: u32;
    var phi_275_: i32;
    var phi_295_: i32;
    var phi_349_: f32;
    var phi_360_: f32;
    var phi_405_: f32;
    var phi_416_: f32;
    var phi_461_: f32;
    var phi_472_: f32;
    var phi_568_: f32;
    var phi_569_: f32;
    var phi_579_: SlimbvhTypeK;
    var phi_2226_: bool;
    var phi_852_: SlimbvhTypeK;
    var phi_855_: u32;
    var phi_857_: u32;
    var phi_859_: bool;
    var phi_861_: u32;
    var phi_872_: bool;
    var phi_903_: u32;
    var phi_904_: bool;
    var phi_905_: u32;
    var phi_1734_: SlimbvhTypeL;
    var phi_2078_: u32;
    var phi_2105_: u32;
    var phi_2106_: u32;
    var phi_2107_: u32;
    var phi_2109_: u32;
    var phi_2110_: u32;
    var phi_2111_: bool;
    var phi_2120_: u32;
    var phi_2125_: u32;
    var phi_2126_: bool;
    var phi_920_: SlimbvhTypeK;
    var phi_923_: SlimbvhTypeA;
    var phi_924_: SlimbvhTypeA;
    var phi_946_: SlimbvhTypeA;
    var phi_967_: u32;
    var phi_1056_: array<array<f32, 3>, 3>;
    var phi_1527_: vec3<f32>;
    var phi_1528_: vec3<f32>;
    var phi_1559_: bool;
    var phi_1568_: vec3<f32>;
    var phi_1608_: SlimbvhTypeE;
    var phi_1610_: SlimbvhTypeE;
    var phi_1611_: bool;
    var phi_1615_: SlimbvhTypeE;
    var phi_1616_: SlimbvhTypeE;
    var phi_1617_: SlimbvhTypeE;
    var phi_1618_: bool;
    var phi_1622_: SlimbvhTypeE;
    var phi_1623_: bool;
    var phi_1627_: SlimbvhTypeE;
    var phi_1628_: bool;
    var phi_1632_: SlimbvhTypeE;
    var phi_1657_: bool;
    var phi_1658_: bool;
    var phi_1665_: SlimbvhTypeK;
    var phi_1666_: SlimbvhTypeK;
    var phi_1667_: SlimbvhTypeK;
    var phi_921_: SlimbvhTypeK;
    var phi_2220_: bool;
    var local_2: SlimbvhTypeK;
    var local_3: SlimbvhTypeK;
    var phi_1674_: bool;
    var phi_2339_: bool;
    var phi_2128_: SlimbvhTypeK;
    var phi_2129_: u32;
    var phi_2130_: bool;
    var phi_2131_: u32;
    var phi_2338_: bool;
    var phi_2132_: SlimbvhTypeK;
    var phi_2133_: u32;
    var phi_2134_: u32;
    var phi_2135_: bool;
    var phi_2136_: u32;
    var phi_2337_: bool;
    var phi_2137_: SlimbvhTypeK;
    var phi_2138_: u32;
    var phi_2139_: u32;
    var phi_2140_: bool;
    var phi_2141_: u32;
    var phi_2336_: bool;
    var phi_853_: SlimbvhTypeK;
    var phi_856_: u32;
    var phi_858_: u32;
    var phi_860_: bool;
    var phi_862_: u32;
    var phi_2142_: bool;
    var phi_2335_: bool;
    var local_4: SlimbvhTypeK;
    var phi_2194_: SlimbvhTypeE;
    var local_5: SlimbvhTypeK;

    switch bitcast<i32>(0u) {
        default: {
            let _e63 = arrayLength((&slimbvh_nodes.member));
            let _e65 = arrayLength((&slimbvh_triangles.member));
            let _e70 = slimbvh_origin.member;
            let _e76 = slimbvh_origin.member[3u];
            let _e77 = slimbvh_direction.member;
            let _e83 = slimbvh_direction.member[3u];
            let _e86 = slimbvh_exponent.member[0u];
            let _e87 = bitcast<i32>(_e86);
            let _e89 = (bitcast<u32>(_e77.x) & 2147483647u);
            let _e91 = (bitcast<u32>(_e77.y) & 2147483647u);
            let _e93 = (bitcast<u32>(_e77.z) & 2147483647u);
            let _e95 = (bitcast<u32>(_e70.x) & 2147483647u);
            let _e97 = (bitcast<u32>(_e70.y) & 2147483647u);
            let _e99 = (bitcast<u32>(_e70.z) & 2147483647u);
            let _e101 = select(_e91, _e89, (_e91 < _e89));
            let _e103 = select(_e93, _e101, (_e93 < _e101));
            let _e105 = select(_e95, _e103, (_e95 < _e103));
            let _e107 = select(_e97, _e105, (_e97 < _e105));
            let _e109 = select(_e99, _e107, (_e99 < _e107));
            let _e111 = (bitcast<u32>(_e76) & 2147483647u);
            let _e120 = (((select(_e111, _e109, (_e111 < _e109)) < 2139095040u) && ((bitcast<u32>(_e83) & 2147483647u) <= 2139095040u)) && (_e103 > 0u));
            if _e120 {
                let _e123 = (bitcast<u32>(bitcast<f32>(_e103)) & 2147483647u);
                if (_e123 >= 8388608u) {
                    phi_234_ = (bitcast<i32>((_e123 >> bitcast<u32>(23i))) - 127i);
                } else {
                    phi_234_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e123)), 32u, (_e123 == 0u))));
                }
                let _e137 = phi_234_;
                phi_235_ = _e137;
            } else {
                phi_235_ = 0i;
            }
            let _e139 = phi_235_;
            let _e140 = (_e89 == _e103);
            if _e140 {
                phi_245_ = true;
            } else {
                phi_245_ = (_e91 == _e103);
            }
            let _e143 = phi_245_;
            let _e144 = select(1u, 0u, _e140);
            if _e143 {
                let _e145 = (_e144 + 1u);
                phi_255_ = _e145;
                phi_256_ = _e145;
                phi_258_ = select(true, false, (_e145 == 2u));
            } else {
                phi_255_ = u32();
                phi_256_ = 0u;
                phi_258_ = true;
            }
            let _e149 = phi_255_;
            let _e151 = phi_256_;
            let _e153 = phi_258_;
            if _e153 {
                phi_263_ = (_e151 + 1u);
            } else {
                phi_263_ = 0u;
            }
            let _e157 = phi_263_;
            let _e158 = select(_e149, _e151, _e153);
            let _e159 = select(_e144, select(2u, _e144, _e143), _e153);
            if (_e87 < -126i) {
                phi_275_ = -126i;
            } else {
                phi_275_ = select(_e87, 127i, (_e87 > 127i));
            }
            let _e164 = phi_275_;
            let _e169 = bitcast<f32>((bitcast<u32>((_e164 + 127i)) << bitcast<u32>(23i)));
            let _e175 = bitcast<f32>((bitcast<u32>(((_e87 - _e164) + 127i)) << bitcast<u32>(23i)));
            let _e176 = -(_e139);
            if (_e176 < -126i) {
                phi_295_ = -126i;
            } else {
                phi_295_ = select(_e176, 127i, (_e176 > 127i));
            }
            let _e181 = phi_295_;
            let _e186 = bitcast<f32>((bitcast<u32>((_e181 + 127i)) << bitcast<u32>(23i)));
            let _e192 = bitcast<f32>((bitcast<u32>(((_e176 - _e181) + 127i)) << bitcast<u32>(23i)));
            let _e193 = (_e158 == 0u);
            let _e195 = (_e158 == 2u);
            let _e198 = ((select(select(_e70.y, _e70.x, _e193), _e70.z, _e195) * _e169) * _e175);
            let _e202 = ((select(select(_e77.y, _e77.x, _e193), _e77.z, _e195) * _e186) * _e192);
            let _e206 = (bitcast<f32>((bitcast<u32>(_e202) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e206 {
                let _e210 = (bitcast<f32>((bitcast<u32>(_e198) & 2147483647u)) * 0.00000011920929f);
                phi_349_ = select(0.00000000000011368684f, _e210, (_e210 > 0.00000000000011368684f));
            } else {
                phi_349_ = 0f;
            }
            let _e214 = phi_349_;
            let _e215 = (_e198 + _e214);
            let _e216 = (_e198 - _e214);
            let _e217 = select(_e202, 0f, _e206);
            if _e206 {
                phi_360_ = 38685626000000000000000000f;
            } else {
                phi_360_ = (1f / _e202);
            }
            let _e220 = phi_360_;
            let _e221 = (_e157 == 0u);
            let _e223 = (_e157 == 2u);
            let _e226 = ((select(select(_e70.y, _e70.x, _e221), _e70.z, _e223) * _e169) * _e175);
            let _e230 = ((select(select(_e77.y, _e77.x, _e221), _e77.z, _e223) * _e186) * _e192);
            let _e234 = (bitcast<f32>((bitcast<u32>(_e230) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e234 {
                let _e238 = (bitcast<f32>((bitcast<u32>(_e226) & 2147483647u)) * 0.00000011920929f);
                phi_405_ = select(0.00000000000011368684f, _e238, (_e238 > 0.00000000000011368684f));
            } else {
                phi_405_ = 0f;
            }
            let _e242 = phi_405_;
            let _e243 = (_e226 + _e242);
            let _e244 = (_e226 - _e242);
            let _e245 = select(_e230, 0f, _e234);
            if _e234 {
                phi_416_ = 38685626000000000000000000f;
            } else {
                phi_416_ = (1f / _e230);
            }
            let _e248 = phi_416_;
            let _e249 = (_e159 == 0u);
            let _e251 = (_e159 == 2u);
            let _e254 = ((select(select(_e70.y, _e70.x, _e249), _e70.z, _e251) * _e169) * _e175);
            let _e258 = ((select(select(_e77.y, _e77.x, _e249), _e77.z, _e251) * _e186) * _e192);
            let _e262 = (bitcast<f32>((bitcast<u32>(_e258) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e262 {
                let _e266 = (bitcast<f32>((bitcast<u32>(_e254) & 2147483647u)) * 0.00000011920929f);
                phi_461_ = select(0.00000000000011368684f, _e266, (_e266 > 0.00000000000011368684f));
            } else {
                phi_461_ = 0f;
            }
            let _e270 = phi_461_;
            let _e271 = (_e254 + _e270);
            let _e272 = (_e254 - _e270);
            let _e273 = select(_e258, 0f, _e262);
            if _e262 {
                phi_472_ = 38685626000000000000000000f;
            } else {
                phi_472_ = (1f / _e258);
            }
            let _e276 = phi_472_;
            let _e279 = bitcast<f32>((bitcast<u32>(_e198) & 2147483647u));
            let _e282 = bitcast<f32>((bitcast<u32>(_e226) & 2147483647u));
            let _e284 = select(_e282, _e279, (_e279 > _e282));
            let _e287 = bitcast<f32>((bitcast<u32>(_e254) & 2147483647u));
            let _e290 = (_e87 + _e139);
            if (_e120 && (select(_e287, _e284, (_e284 > _e287)) <= 1099511600000f)) {
                let _e293 = (_e290 / 3i);
                let _e300 = bitcast<f32>((bitcast<u32>((_e293 + 127i)) << bitcast<u32>(23i)));
                let _e307 = bitcast<f32>((bitcast<u32>(((_e290 - (2i * _e293)) + 127i)) << bitcast<u32>(23i)));
                let _e308 = (((_e76 * _e300) * _e300) * _e307);
                let _e310 = select(340282350000000000000000000000000000000f, _e308, (_e308 < 340282350000000000000000000000000000000f));
                let _e315 = (((_e83 * _e300) * _e300) * _e307);
                let _e317 = select(340282350000000000000000000000000000000f, _e315, (_e315 < 340282350000000000000000000000000000000f));
                phi_568_ = select(-340282350000000000000000000000000000000f, _e317, (_e317 > -340282350000000000000000000000000000000f));
                phi_569_ = select(-340282350000000000000000000000000000000f, _e310, (_e310 > -340282350000000000000000000000000000000f));
            } else {
                phi_568_ = 0f;
                phi_569_ = 1f;
            }
            let _e321 = phi_568_;
            let _e323 = phi_569_;
            let _e324 = slimbvh_any_will_do.member;
            if (_e324 == 1u) {
                phi_579_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e321), true);
            } else {
                phi_579_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e321), false);
            }
            let _e331 = phi_579_;
            local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
            local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
            phi_2226_ = false;
            phi_852_ = _e331;
            phi_855_ = select(0u, 2147483648u, (_e63 == 0u));
            phi_857_ = ((3u * _e63) + 1u);
            phi_859_ = (_e323 <= _e321);
            phi_861_ = 0u;
            loop {
                let _e338 = phi_2226_;
                let _e340 = phi_852_;
                let _e342 = phi_855_;
                let _e344 = phi_857_;
                let _e346 = phi_859_;
                let _e348 = phi_861_;
                local_4 = _e340;
                if _e346 {
                    phi_872_ = true;
                } else {
                    phi_872_ = (_e348 > 0u);
                }
                let _e351 = phi_872_;
                if _e351 {
                    let _e352 = (_e344 > 0u);
                    if _e352 {
                        if _e346 {
                            phi_903_ = _e342;
                            phi_904_ = _e346;
                            phi_905_ = _e348;
                        } else {
                            let _e353 = (_e348 - 1u);
                            let _e354 = (_e353 % 128u);
                            let _e355 = (_e354 < 128u);
                            if _e355 {
                            } else {
                                phi_2335_ = true;
                                break;
                            }
                            let _e357 = local_1[_e354];
                            if _e355 {
                            } else {
                                phi_2335_ = true;
                                break;
                            }
                            let _e359 = local[_e354];
                            phi_903_ = _e357;
                            phi_904_ = (_e359 <= _e340.member.member_1);
                            phi_905_ = _e353;
                        }
                        let _e364 = phi_903_;
                        let _e366 = phi_904_;
                        let _e368 = phi_905_;
                        if _e366 {
                            if ((_e364 & 2147483648u) != 0u) {
                                phi_920_ = _e340;
                                phi_923_ = SlimbvhTypeA(0u, ((_e364 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e567 = phi_920_;
                                    let _e569 = phi_923_;
                                    local_2 = _e567;
                                    local_3 = _e567;
                                    local_5 = _e567;
                                    if (_e569.member < _e569.member_1) {
                                        phi_924_ = SlimbvhTypeA((_e569.member + 1u), _e569.member_1);
                                        phi_946_ = SlimbvhTypeA(1u, _e569.member);
                                    } else {
                                        phi_924_ = _e569;
                                        phi_946_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                                    }
                                    let _e582 = phi_924_;
                                    let _e584 = phi_946_;
                                    let _e588 = (bitcast<i32>(_e584.member) != 0i);
                                    if _e588 {
                                        let _e589 = ((_e364 & 268435455u) + _e584.member_1);
                                        let _e590 = (_e589 < _e65);
                                        if _e590 {
                                            if _e590 {
                                            } else {
                                                phi_2220_ = true;
                                                break;
                                            }
                                            let _e594 = slimbvh_triangles.member[_e589].member_1;
                                            phi_967_ = _e594;
                                        } else {
                                            phi_967_ = 4294967295u;
                                        }
                                        let _e596 = phi_967_;
                                        if (_e589 >= _e65) {
                                            phi_1056_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                        } else {
                                            if _e590 {
                                            } else {
                                                phi_2220_ = true;
                                                break;
                                            }
                                            let _e598 = (_e158 % 3u);
                                            let _e599 = (_e157 % 3u);
                                            let _e600 = (_e159 % 3u);
                                            if (_e598 < 9u) {
                                            } else {
                                                phi_2220_ = true;
                                                break;
                                            }
                                            let _e606 = slimbvh_triangles.member[_e589].member[_e598];
                                            if (_e599 < 9u) {
                                            } else {
                                                phi_2220_ = true;
                                                break;
                                            }
                                            let _e612 = slimbvh_triangles.member[_e589].member[_e599];
                                            if (_e600 < 9u) {
                                            } else {
                                                phi_2220_ = true;
                                                break;
                                            }
                                            let _e618 = slimbvh_triangles.member[_e589].member[_e600];
                                            let _e620 = (3u + _e598);
                                            if (_e620 < 9u) {
                                            } else {
                                                phi_2220_ = true;
                                                break;
                                            }
                                            let _e626 = slimbvh_triangles.member[_e589].member[_e620];
                                            let _e627 = (3u + _e599);
                                            if (_e627 < 9u) {
                                            } else {
                                                phi_2220_ = true;
                                                break;
                                            }
                                            let _e633 = slimbvh_triangles.member[_e589].member[_e627];
                                            let _e634 = (3u + _e600);
                                            if (_e634 < 9u) {
                                            } else {
                                                phi_2220_ = true;
                                                break;
                                            }
                                            let _e640 = slimbvh_triangles.member[_e589].member[_e634];
                                            let _e642 = (6u + _e598);
                                            if (_e642 < 9u) {
                                            } else {
                                                phi_2220_ = true;
                                                break;
                                            }
                                            let _e648 = slimbvh_triangles.member[_e589].member[_e642];
                                            let _e649 = (6u + _e599);
                                            if (_e649 < 9u) {
                                            } else {
                                                phi_2220_ = true;
                                                break;
                                            }
                                            let _e655 = slimbvh_triangles.member[_e589].member[_e649];
                                            let _e656 = (6u + _e600);
                                            if (_e656 < 9u) {
                                            } else {
                                                phi_2220_ = true;
                                                break;
                                            }
                                            let _e662 = slimbvh_triangles.member[_e589].member[_e656];
                                            phi_1056_ = array<array<f32, 3>, 3>(array<f32, 3>(_e606, _e612, _e618), array<f32, 3>(_e626, _e633, _e640), array<f32, 3>(_e648, _e655, _e662));
                                        }
                                        let _e666 = phi_1056_;
                                        let _e675 = (_e666[0][2] - _e254);
                                        let _e678 = (((_e666[0][0] - _e198) * _e273) - (_e675 * _e217));
                                        let _e681 = (((_e666[0][1] - _e226) * _e273) - (_e675 * _e245));
                                        let _e688 = (_e666[1][2] - _e254);
                                        let _e691 = (((_e666[1][0] - _e198) * _e273) - (_e688 * _e217));
                                        let _e694 = (((_e666[1][1] - _e226) * _e273) - (_e688 * _e245));
                                        let _e701 = (_e666[2][2] - _e254);
                                        let _e704 = (((_e666[2][0] - _e198) * _e273) - (_e701 * _e217));
                                        let _e707 = (((_e666[2][1] - _e226) * _e273) - (_e701 * _e245));
                                        let _e708 = (_e704 * _e694);
                                        let _e709 = (_e707 * _e691);
                                        let _e710 = (_e678 * _e707);
                                        let _e711 = (_e681 * _e704);
                                        let _e712 = (_e691 * _e681);
                                        let _e713 = (_e694 * _e678);
                                        let _e718 = (((_e708 >= _e709) && (_e710 >= _e711)) && (_e712 >= _e713));
                                        if (_e718 || (((_e708 <= _e709) && (_e710 <= _e711)) && (_e712 <= _e713))) {
                                            let _e725 = select(-1f, 1f, _e718);
                                            let _e727 = ((_e708 - _e709) * _e725);
                                            let _e729 = select(0f, _e727, (_e727 > 0f));
                                            let _e731 = ((_e710 - _e711) * _e725);
                                            let _e733 = select(0f, _e731, (_e731 > 0f));
                                            let _e735 = ((_e712 - _e713) * _e725);
                                            let _e737 = select(0f, _e735, (_e735 > 0f));
                                            let _e739 = ((_e729 + _e733) + _e737);
                                            if (_e739 < 0.000000000000000000000000000000000000011754944f) {
                                                phi_1622_ = SlimbvhTypeE();
                                                phi_1623_ = true;
                                            } else {
                                                let _e742 = select(_e666[1][0], _e666[0][0], (_e666[0][0] < _e666[1][0]));
                                                let _e746 = select(_e666[1][0], _e666[0][0], (_e666[0][0] > _e666[1][0]));
                                                let _e750 = select(_e666[1][1], _e666[0][1], (_e666[0][1] < _e666[1][1]));
                                                let _e754 = select(_e666[1][1], _e666[0][1], (_e666[0][1] > _e666[1][1]));
                                                let _e758 = select(_e666[1][2], _e666[0][2], (_e666[0][2] < _e666[1][2]));
                                                let _e762 = select(_e666[1][2], _e666[0][2], (_e666[0][2] > _e666[1][2]));
                                                let _e767 = ((select(_e666[2][0], _e742, (_e742 < _e666[2][0])) - _e215) * _e220);
                                                let _e768 = ((select(_e666[2][0], _e746, (_e746 > _e666[2][0])) - _e216) * _e220);
                                                let _e771 = ((select(_e666[2][1], _e750, (_e750 < _e666[2][1])) - _e243) * _e248);
                                                let _e772 = ((select(_e666[2][1], _e754, (_e754 > _e666[2][1])) - _e244) * _e248);
                                                let _e775 = ((select(_e666[2][2], _e758, (_e758 < _e666[2][2])) - _e271) * _e276);
                                                let _e776 = ((select(_e666[2][2], _e762, (_e762 > _e666[2][2])) - _e272) * _e276);
                                                let _e778 = select(_e776, _e775, (_e775 < _e776));
                                                let _e780 = select(_e776, _e775, (_e775 > _e776));
                                                let _e782 = select(_e768, _e767, (_e767 < _e768));
                                                let _e784 = select(_e772, _e771, (_e771 < _e772));
                                                let _e786 = select(_e784, _e782, (_e782 > _e784));
                                                let _e788 = select(_e778, _e786, (_e786 > _e778));
                                                let _e790 = select(_e768, _e767, (_e767 > _e768));
                                                let _e792 = select(_e772, _e771, (_e771 > _e772));
                                                let _e794 = select(_e792, _e790, (_e790 < _e792));
                                                let _e796 = select(_e780, _e794, (_e794 < _e780));
                                                let _e797 = -(_e778);
                                                let _e803 = select(_e323, _e788, (_e788 > _e323));
                                                if (_e803 > (_e796 + (select(_e797, _e780, (_e780 > _e797)) * 0.0000019073523f))) {
                                                    phi_1617_ = SlimbvhTypeE();
                                                    phi_1618_ = true;
                                                } else {
                                                    let _e805 = (_e803 > _e567.member.member_1);
                                                    if _e805 {
                                                        phi_1616_ = SlimbvhTypeE();
                                                    } else {
                                                        let _e809 = (_e666[1][0] - _e666[0][0]);
                                                        let _e810 = (_e666[1][1] - _e666[0][1]);
                                                        let _e811 = (_e666[1][2] - _e666[0][2]);
                                                        let _e812 = vec3<f32>(_e809, _e810, _e811);
                                                        let _e813 = (_e666[2][0] - _e666[1][0]);
                                                        let _e814 = (_e666[2][1] - _e666[1][1]);
                                                        let _e815 = (_e666[2][2] - _e666[1][2]);
                                                        let _e816 = vec3<f32>(_e813, _e814, _e815);
                                                        let _e817 = (_e666[0][0] - _e666[2][0]);
                                                        let _e818 = (_e666[0][1] - _e666[2][1]);
                                                        let _e819 = (_e666[0][2] - _e666[2][2]);
                                                        let _e820 = vec3<f32>(_e817, _e818, _e819);
                                                        let _e823 = bitcast<f32>((bitcast<u32>(_e809) & 2147483647u));
                                                        let _e826 = bitcast<f32>((bitcast<u32>(_e810) & 2147483647u));
                                                        let _e828 = select(_e826, _e823, (_e823 > _e826));
                                                        let _e831 = bitcast<f32>((bitcast<u32>(_e811) & 2147483647u));
                                                        let _e833 = select(_e831, _e828, (_e828 > _e831));
                                                        let _e836 = bitcast<f32>((bitcast<u32>(_e813) & 2147483647u));
                                                        let _e839 = bitcast<f32>((bitcast<u32>(_e814) & 2147483647u));
                                                        let _e841 = select(_e839, _e836, (_e836 > _e839));
                                                        let _e844 = bitcast<f32>((bitcast<u32>(_e815) & 2147483647u));
                                                        let _e846 = select(_e844, _e841, (_e841 > _e844));
                                                        let _e849 = bitcast<f32>((bitcast<u32>(_e817) & 2147483647u));
                                                        let _e852 = bitcast<f32>((bitcast<u32>(_e818) & 2147483647u));
                                                        let _e854 = select(_e852, _e849, (_e849 > _e852));
                                                        let _e857 = bitcast<f32>((bitcast<u32>(_e819) & 2147483647u));
                                                        let _e859 = select(_e857, _e854, (_e854 > _e857));
                                                        let _e861 = select(_e846, _e833, (_e833 > _e846));
                                                        let _e863 = select(_e859, _e861, (_e861 > _e859));
                                                        if (_e833 == _e863) {
                                                            phi_1527_ = _e816;
                                                            phi_1528_ = _e820;
                                                        } else {
                                                            let _e866 = vec3((_e846 == _e863));
                                                            phi_1527_ = select(_e812, _e820, _e866);
                                                            phi_1528_ = select(_e816, _e812, _e866);
                                                        }
                                                        let _e870 = phi_1527_;
                                                        let _e872 = phi_1528_;
                                                        let _e879 = ((_e870.y * _e872.z) - (_e872.y * _e870.z));
                                                        let _e884 = ((_e870.z * _e872.x) - (_e872.z * _e870.x));
                                                        let _e887 = ((_e870.x * _e872.y) - (_e872.x * _e870.y));
                                                        if (_e729 >= _e733) {
                                                            phi_1559_ = select(true, false, (_e729 >= _e737));
                                                        } else {
                                                            phi_1559_ = true;
                                                        }
                                                        let _e892 = phi_1559_;
                                                        if _e892 {
                                                            phi_1568_ = select(vec3<f32>(_e666[2][0], _e666[2][1], _e666[2][2]), vec3<f32>(_e666[1][0], _e666[1][1], _e666[1][2]), vec3((_e733 >= _e737)));
                                                        } else {
                                                            phi_1568_ = vec3<f32>(_e666[0][0], _e666[0][1], _e666[0][2]);
                                                        }
                                                        let _e897 = phi_1568_;
                                                        let _e914 = ((((_e879 * (_e897.x - _e198)) + (_e884 * (_e897.y - _e226))) + (_e887 * (_e897.z - _e254))) / (((_e879 * _e217) + (_e884 * _e245)) + (_e887 * _e273)));
                                                        let _e916 = select(_e796, _e914, (_e914 < _e796));
                                                        let _e918 = select(_e788, _e916, (_e916 > _e788));
                                                        if (_e918 >= _e323) {
                                                            let _e920 = (_e918 <= _e567.member.member_1);
                                                            if _e920 {
                                                                let _e921 = (1f / _e739);
                                                                phi_1608_ = SlimbvhTypeE(_e918, (_e733 * _e921), (_e737 * _e921), _e596);
                                                            } else {
                                                                phi_1608_ = SlimbvhTypeE();
                                                            }
                                                            let _e926 = phi_1608_;
                                                            phi_1610_ = _e926;
                                                            phi_1611_ = select(true, false, _e920);
                                                        } else {
                                                            phi_1610_ = SlimbvhTypeE();
                                                            phi_1611_ = true;
                                                        }
                                                        let _e929 = phi_1610_;
                                                        let _e931 = phi_1611_;
                                                        if _e931 {
                                                            phi_1615_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                        } else {
                                                            phi_1615_ = _e929;
                                                        }
                                                        let _e933 = phi_1615_;
                                                        phi_1616_ = _e933;
                                                    }
                                                    let _e935 = phi_1616_;
                                                    phi_1617_ = _e935;
                                                    phi_1618_ = _e805;
                                                }
                                                let _e937 = phi_1617_;
                                                let _e939 = phi_1618_;
                                                phi_1622_ = _e937;
                                                phi_1623_ = _e939;
                                            }
                                            let _e941 = phi_1622_;
                                            let _e943 = phi_1623_;
                                            phi_1627_ = _e941;
                                            phi_1628_ = _e943;
                                        } else {
                                            phi_1627_ = SlimbvhTypeE();
                                            phi_1628_ = true;
                                        }
                                        let _e945 = phi_1627_;
                                        let _e947 = phi_1628_;
                                        if _e947 {
                                            phi_1632_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                        } else {
                                            phi_1632_ = _e945;
                                        }
                                        let _e949 = phi_1632_;
                                        if (_e949.member_3 != 4294967295u) {
                                            if (_e596 != 4294967295u) {
                                                if (_e949.member < _e567.member.member.member) {
                                                    phi_1658_ = true;
                                                } else {
                                                    if (_e949.member == _e567.member.member.member) {
                                                        phi_1657_ = (_e949.member_3 < _e567.member.member.member_3);
                                                    } else {
                                                        phi_1657_ = false;
                                                    }
                                                    let _e964 = phi_1657_;
                                                    phi_1658_ = _e964;
                                                }
                                                let _e966 = phi_1658_;
                                                if _e966 {
                                                    phi_1665_ = SlimbvhTypeK(SlimbvhTypeJ(_e949, _e949.member), _e567.member_1);
                                                } else {
                                                    phi_1665_ = _e567;
                                                }
                                                let _e972 = phi_1665_;
                                                phi_1666_ = _e972;
                                            } else {
                                                phi_1666_ = _e567;
                                            }
                                            let _e974 = phi_1666_;
                                            phi_1667_ = _e974;
                                        } else {
                                            phi_1667_ = _e567;
                                        }
                                        let _e976 = phi_1667_;
                                        phi_921_ = _e976;
                                    } else {
                                        phi_921_ = SlimbvhTypeK();
                                    }
                                    let _e978 = phi_921_;
                                    continue;
                                    continuing {
                                        phi_920_ = _e978;
                                        phi_923_ = _e582;
                                        phi_2220_ = _e338;
                                        break if !(_e588);
                                    }
                                }
                                let _e981 = phi_2220_;
                                phi_2335_ = _e981;
                                if _e981 {
                                    break;
                                }
                                let _e983 = local_2;
                                if _e983.member_1 {
                                    let _e986 = local_3;
                                    phi_1674_ = (_e986.member.member.member_3 != 4294967295u);
                                } else {
                                    phi_1674_ = false;
                                }
                                let _e992 = phi_1674_;
                                phi_2339_ = _e981;
                                let _e1160 = local_5;
                                phi_2128_ = _e1160;
                                phi_2129_ = _e364;
                                phi_2130_ = false;
                                phi_2131_ = select(_e368, 0u, _e992);
                            } else {
                                if (_e364 >= _e63) {
                                    phi_1734_ = SlimbvhTypeL(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                } else {
                                    if (_e364 < _e63) {
                                    } else {
                                        phi_2335_ = true;
                                        break;
                                    }
                                    let _e378 = (_e158 % 3u);
                                    if (_e378 < 3u) {
                                    } else {
                                        phi_2335_ = true;
                                        break;
                                    }
                                    let _e384 = slimbvh_nodes.member[_e364].member[_e378];
                                    let _e390 = (_e157 % 3u);
                                    if (_e390 < 3u) {
                                    } else {
                                        phi_2335_ = true;
                                        break;
                                    }
                                    let _e396 = slimbvh_nodes.member[_e364].member[_e390];
                                    let _e402 = (_e159 % 3u);
                                    if (_e402 < 3u) {
                                    } else {
                                        phi_2335_ = true;
                                        break;
                                    }
                                    let _e408 = slimbvh_nodes.member[_e364].member[_e402];
                                    let _e418 = slimbvh_nodes.member[_e364].member_1;
                                    let _e422 = slimbvh_nodes.member[_e364].member_2;
                                    phi_1734_ = SlimbvhTypeL(array<vec4<f32>, 3>(vec4<f32>(_e384[0], _e384[1], _e384[2], _e384[3]), vec4<f32>(_e396[0], _e396[1], _e396[2], _e396[3]), vec4<f32>(_e408[0], _e408[1], _e408[2], _e408[3])), _e418, _e422);
                                }
                                let _e425 = phi_1734_;
                                let _e438 = ((_e425.member[0].x - _e215) * _e220);
                                let _e439 = ((_e425.member[0].y - _e215) * _e220);
                                let _e440 = ((_e425.member[0].z - _e216) * _e220);
                                let _e441 = ((_e425.member[0].w - _e216) * _e220);
                                let _e451 = ((_e425.member[1].x - _e243) * _e248);
                                let _e452 = ((_e425.member[1].y - _e243) * _e248);
                                let _e453 = ((_e425.member[1].z - _e244) * _e248);
                                let _e454 = ((_e425.member[1].w - _e244) * _e248);
                                let _e464 = ((_e425.member[2].x - _e271) * _e276);
                                let _e465 = ((_e425.member[2].y - _e271) * _e276);
                                let _e466 = ((_e425.member[2].z - _e272) * _e276);
                                let _e467 = ((_e425.member[2].w - _e272) * _e276);
                                let _e469 = select(_e466, _e464, (_e464 < _e466));
                                let _e471 = select(_e467, _e465, (_e465 < _e467));
                                let _e473 = select(_e466, _e464, (_e464 > _e466));
                                let _e475 = select(_e467, _e465, (_e465 > _e467));
                                let _e477 = select(_e440, _e438, (_e438 < _e440));
                                let _e479 = select(_e441, _e439, (_e439 < _e441));
                                let _e481 = select(_e453, _e451, (_e451 < _e453));
                                let _e483 = select(_e454, _e452, (_e452 < _e454));
                                let _e485 = select(_e481, _e477, (_e477 > _e481));
                                let _e487 = select(_e483, _e479, (_e479 > _e483));
                                let _e489 = select(_e469, _e485, (_e485 > _e469));
                                let _e491 = select(_e471, _e487, (_e487 > _e471));
                                let _e493 = select(_e440, _e438, (_e438 > _e440));
                                let _e495 = select(_e441, _e439, (_e439 > _e441));
                                let _e497 = select(_e453, _e451, (_e451 > _e453));
                                let _e499 = select(_e454, _e452, (_e452 > _e454));
                                let _e501 = select(_e497, _e493, (_e493 < _e497));
                                let _e503 = select(_e499, _e495, (_e495 < _e499));
                                let _e508 = -(_e469);
                                let _e509 = -(_e471);
                                let _e516 = (select(_e473, _e501, (_e501 < _e473)) + (select(_e508, _e473, (_e473 > _e508)) * 0.0000019073523f));
                                let _e517 = (select(_e475, _e503, (_e503 < _e475)) + (select(_e509, _e475, (_e475 > _e509)) * 0.0000019073523f));
                                let _e519 = select(_e323, _e489, (_e489 > _e323));
                                let _e521 = select(_e323, _e491, (_e491 > _e323));
                                let _e526 = (_e519 <= select(_e340.member.member_1, _e516, (_e516 < _e340.member.member_1)));
                                let _e527 = (_e521 <= select(_e340.member.member_1, _e517, (_e517 < _e340.member.member_1)));
                                let _e528 = (_e519 <= _e521);
                                if _e526 {
                                    if _e527 {
                                        if _e528 {
                                            phi_2078_ = _e425.member_2;
                                        } else {
                                            phi_2078_ = _e425.member_1;
                                        }
                                        let _e532 = phi_2078_;
                                        let _e533 = (_e368 % 128u);
                                        let _e534 = (_e533 < 128u);
                                        if _e534 {
                                        } else {
                                            phi_2335_ = true;
                                            break;
                                        }
                                        local_1[_e533] = _e532;
                                        if _e534 {
                                        } else {
                                            phi_2335_ = true;
                                            break;
                                        }
                                        local[_e533] = select(_e521, _e519, (_e519 > _e521));
                                        if _e528 {
                                            phi_2105_ = _e425.member_1;
                                        } else {
                                            phi_2105_ = _e425.member_2;
                                        }
                                        let _e543 = phi_2105_;
                                        phi_2106_ = _e543;
                                        phi_2107_ = (_e368 + 1u);
                                    } else {
                                        phi_2106_ = u32();
                                        phi_2107_ = u32();
                                    }
                                    let _e545 = phi_2106_;
                                    let _e547 = phi_2107_;
                                    phi_2109_ = _e545;
                                    phi_2110_ = _e547;
                                    phi_2111_ = select(true, false, _e527);
                                } else {
                                    phi_2109_ = u32();
                                    phi_2110_ = u32();
                                    phi_2111_ = true;
                                }
                                let _e550 = phi_2109_;
                                let _e552 = phi_2110_;
                                let _e554 = phi_2111_;
                                if _e554 {
                                    if _e526 {
                                        phi_2120_ = _e425.member_1;
                                    } else {
                                        phi_2120_ = _e425.member_2;
                                    }
                                    let _e558 = phi_2120_;
                                    phi_2125_ = _e558;
                                    phi_2126_ = select(_e527, true, _e526);
                                } else {
                                    phi_2125_ = _e550;
                                    phi_2126_ = _e366;
                                }
                                let _e561 = phi_2125_;
                                let _e563 = phi_2126_;
                                phi_2339_ = _e338;
                                phi_2128_ = _e340;
                                phi_2129_ = _e561;
                                phi_2130_ = _e563;
                                phi_2131_ = select(_e552, _e368, _e554);
                            }
                            let _e995 = phi_2339_;
                            let _e997 = phi_2128_;
                            let _e999 = phi_2129_;
                            let _e1001 = phi_2130_;
                            let _e1003 = phi_2131_;
                            phi_2338_ = _e995;
                            phi_2132_ = _e997;
                            phi_2133_ = _e999;
                            phi_2134_ = (_e344 - 1u);
                            phi_2135_ = _e1001;
                            phi_2136_ = _e1003;
                        } else {
                            phi_2338_ = _e338;
                            phi_2132_ = _e340;
                            phi_2133_ = _e364;
                            phi_2134_ = _e344;
                            phi_2135_ = _e366;
                            phi_2136_ = _e368;
                        }
                        let _e1005 = phi_2338_;
                        let _e1007 = phi_2132_;
                        let _e1009 = phi_2133_;
                        let _e1011 = phi_2134_;
                        let _e1013 = phi_2135_;
                        let _e1015 = phi_2136_;
                        phi_2337_ = _e1005;
                        phi_2137_ = _e1007;
                        phi_2138_ = _e1009;
                        phi_2139_ = _e1011;
                        phi_2140_ = _e1013;
                        phi_2141_ = _e1015;
                    } else {
                        phi_2337_ = _e338;
                        phi_2137_ = SlimbvhTypeK();
                        phi_2138_ = u32();
                        phi_2139_ = u32();
                        phi_2140_ = bool();
                        phi_2141_ = u32();
                    }
                    let _e1017 = phi_2337_;
                    let _e1019 = phi_2137_;
                    let _e1021 = phi_2138_;
                    let _e1023 = phi_2139_;
                    let _e1025 = phi_2140_;
                    let _e1027 = phi_2141_;
                    phi_2336_ = _e1017;
                    phi_853_ = _e1019;
                    phi_856_ = _e1021;
                    phi_858_ = _e1023;
                    phi_860_ = _e1025;
                    phi_862_ = _e1027;
                    phi_2142_ = _e352;
                } else {
                    phi_2336_ = _e338;
                    phi_853_ = SlimbvhTypeK();
                    phi_856_ = u32();
                    phi_858_ = u32();
                    phi_860_ = bool();
                    phi_862_ = u32();
                    phi_2142_ = false;
                }
                let _e1029 = phi_2336_;
                let _e1031 = phi_853_;
                let _e1033 = phi_856_;
                let _e1035 = phi_858_;
                let _e1037 = phi_860_;
                let _e1039 = phi_862_;
                let _e1041 = phi_2142_;
                continue;
                continuing {
                    phi_2226_ = _e1029;
                    phi_852_ = _e1031;
                    phi_855_ = _e1033;
                    phi_857_ = _e1035;
                    phi_859_ = _e1037;
                    phi_861_ = _e1039;
                    phi_2335_ = _e1029;
                    break if !(_e1041);
                }
            }
            let _e1044 = phi_2335_;
            if _e1044 {
                break;
            }
            let _e1046 = local_4;
            if (_e1046.member.member.member_3 != 4294967295u) {
                let _e1052 = -(_e290);
                let _e1053 = (_e1052 / 3i);
                let _e1060 = bitcast<f32>((bitcast<u32>((_e1053 + 127i)) << bitcast<u32>(23i)));
                let _e1068 = (((_e1046.member.member.member * _e1060) * _e1060) * bitcast<f32>((bitcast<u32>(((_e1052 - (2i * _e1053)) + 127i)) << bitcast<u32>(23i))));
                let _e1070 = select(340282350000000000000000000000000000000f, _e1068, (_e1068 < 340282350000000000000000000000000000000f));
                phi_2194_ = SlimbvhTypeE(select(-340282350000000000000000000000000000000f, _e1070, (_e1070 > -340282350000000000000000000000000000000f)), _e1046.member.member.member_1, _e1046.member.member.member_2, _e1046.member.member.member_3);
            } else {
                phi_2194_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
            }
            let _e1077 = phi_2194_;
            slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1077.member), bitcast<u32>(_e1077.member_1), bitcast<u32>(_e1077.member_2), _e1077.member_3);
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
