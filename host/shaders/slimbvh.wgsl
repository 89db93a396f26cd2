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
    var phi_235_: i32;
    var phi_236_: i32;
    var phi_246_: bool;
    var phi_256_: u32;
    var phi_257_: u32;
    var phi_259_: bool;
    var phi_264_: u32;
    var phi_276_: i32;
    var phi_296_: i32;
    var phi_350_: f32;
    var phi_361_: f32;
    var phi_406_: f32;
    var phi_417_: f32;
    var phi_462_: f32;
    var phi_473_: f32;
    var phi_569_: f32;
    var phi_570_: f32;
    var phi_580_: SlimbvhTypeK;
    var phi_1963_: bool;
    var phi_590_: SlimbvhTypeK;
    var phi_593_: u32;
    var phi_595_: u32;
    var phi_597_: bool;
    var phi_599_: u32;
    var phi_610_: bool;
    var phi_642_: u32;
    var phi_643_: bool;
    var phi_644_: u32;
    var phi_1473_: SlimbvhTypeL;
    var phi_1817_: u32;
    var phi_1845_: u32;
    var phi_1846_: u32;
    var phi_1847_: u32;
    var phi_1849_: u32;
    var phi_1850_: u32;
    var phi_1851_: bool;
    var phi_1860_: u32;
    var phi_1865_: u32;
    var phi_1866_: bool;
    var phi_659_: SlimbvhTypeK;
    var phi_662_: SlimbvhTypeA;
    var phi_663_: SlimbvhTypeA;
    var phi_685_: SlimbvhTypeA;
    var phi_706_: u32;
    var phi_795_: array<array<f32, 3>, 3>;
    var phi_1266_: vec3<f32>;
    var phi_1267_: vec3<f32>;
    var phi_1298_: bool;
    var phi_1307_: vec3<f32>;
    var phi_1347_: SlimbvhTypeE;
    var phi_1349_: SlimbvhTypeE;
    var phi_1350_: bool;
    var phi_1354_: SlimbvhTypeE;
    var phi_1355_: SlimbvhTypeE;
    var phi_1356_: SlimbvhTypeE;
    var phi_1357_: bool;
    var phi_1361_: SlimbvhTypeE;
    var phi_1362_: bool;
    var phi_1366_: SlimbvhTypeE;
    var phi_1367_: bool;
    var phi_1371_: SlimbvhTypeE;
    var phi_1396_: bool;
    var phi_1397_: bool;
    var phi_1404_: SlimbvhTypeK;
    var phi_1405_: SlimbvhTypeK;
    var phi_1406_: SlimbvhTypeK;
    var phi_660_: SlimbvhTypeK;
    var phi_1957_: bool;
    var local_2: SlimbvhTypeK;
    var local_3: SlimbvhTypeK;
    var phi_1413_: bool;
    var phi_2076_: bool;
    var phi_1868_: SlimbvhTypeK;
    var phi_1869_: u32;
    var phi_1870_: bool;
    var phi_1871_: u32;
    var phi_2075_: bool;
    var phi_1872_: SlimbvhTypeK;
    var phi_1873_: u32;
    var phi_1874_: u32;
    var phi_1875_: bool;
    var phi_1876_: u32;
    var phi_2074_: bool;
    var phi_1877_: SlimbvhTypeK;
    var phi_1878_: u32;
    var phi_1879_: u32;
    var phi_1880_: bool;
    var phi_1881_: u32;
    var phi_2073_: bool;
    var phi_591_: SlimbvhTypeK;
    var phi_594_: u32;
    var phi_596_: u32;
    var phi_598_: bool;
    var phi_600_: u32;
    var phi_1882_: bool;
    var phi_2072_: bool;
    var local_4: SlimbvhTypeK;
    var phi_1934_: SlimbvhTypeE;
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
                    phi_235_ = (bitcast<i32>((_e123 >> bitcast<u32>(23i))) - 127i);
                } else {
                    phi_235_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e123)), 32u, (_e123 == 0u))));
                }
                let _e137 = phi_235_;
                phi_236_ = _e137;
            } else {
                phi_236_ = 0i;
            }
            let _e139 = phi_236_;
            let _e140 = (_e89 == _e103);
            if _e140 {
                phi_246_ = true;
            } else {
                phi_246_ = (_e91 == _e103);
            }
            let _e143 = phi_246_;
            let _e144 = select(1u, 0u, _e140);
            if _e143 {
                let _e145 = (_e144 + 1u);
                phi_256_ = _e145;
                phi_257_ = _e145;
                phi_259_ = select(true, false, (_e145 == 2u));
            } else {
                phi_256_ = u32();
                phi_257_ = 0u;
                phi_259_ = true;
            }
            let _e149 = phi_256_;
            let _e151 = phi_257_;
            let _e153 = phi_259_;
            if _e153 {
                phi_264_ = (_e151 + 1u);
            } else {
                phi_264_ = 0u;
            }
            let _e157 = phi_264_;
            let _e158 = select(_e149, _e151, _e153);
            let _e159 = select(_e144, select(2u, _e144, _e143), _e153);
            if (_e87 < -126i) {
                phi_276_ = -126i;
            } else {
                phi_276_ = select(_e87, 127i, (_e87 > 127i));
            }
            let _e164 = phi_276_;
            let _e169 = bitcast<f32>((bitcast<u32>((_e164 + 127i)) << bitcast<u32>(23i)));
            let _e175 = bitcast<f32>((bitcast<u32>(((_e87 - _e164) + 127i)) << bitcast<u32>(23i)));
            let _e176 = -(_e139);
            if (_e176 < -126i) {
                phi_296_ = -126i;
            } else {
                phi_296_ = select(_e176, 127i, (_e176 > 127i));
            }
            let _e181 = phi_296_;
            let _e186 = bitcast<f32>((bitcast<u32>((_e181 + 127i)) << bitcast<u32>(23i)));
            let _e192 = bitcast<f32>((bitcast<u32>(((_e176 - _e181) + 127i)) << bitcast<u32>(23i)));
            let _e193 = (_e158 == 0u);
            let _e195 = (_e158 == 2u);
            let _e198 = ((select(select(_e70.y, _e70.x, _e193), _e70.z, _e195) * _e169) * _e175);
            let _e202 = ((select(select(_e77.y, _e77.x, _e193), _e77.z, _e195) * _e186) * _e192);
            let _e206 = (bitcast<f32>((bitcast<u32>(_e202) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e206 {
                let _e210 = (bitcast<f32>((bitcast<u32>(_e198) & 2147483647u)) * 0.00000011920929f);
                phi_350_ = select(0.00000000000011368684f, _e210, (_e210 > 0.00000000000011368684f));
            } else {
                phi_350_ = 0f;
            }
            let _e214 = phi_350_;
            let _e215 = (_e198 + _e214);
            let _e216 = (_e198 - _e214);
            let _e217 = select(_e202, 0f, _e206);
            if _e206 {
                phi_361_ = 38685626000000000000000000f;
            } else {
                phi_361_ = (1f / _e202);
            }
            let _e220 = phi_361_;
            let _e221 = (_e157 == 0u);
            let _e223 = (_e157 == 2u);
            let _e226 = ((select(select(_e70.y, _e70.x, _e221), _e70.z, _e223) * _e169) * _e175);
            let _e230 = ((select(select(_e77.y, _e77.x, _e221), _e77.z, _e223) * _e186) * _e192);
            let _e234 = (bitcast<f32>((bitcast<u32>(_e230) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e234 {
                let _e238 = (bitcast<f32>((bitcast<u32>(_e226) & 2147483647u)) * 0.00000011920929f);
                phi_406_ = select(0.00000000000011368684f, _e238, (_e238 > 0.00000000000011368684f));
            } else {
                phi_406_ = 0f;
            }
            let _e242 = phi_406_;
            let _e243 = (_e226 + _e242);
            let _e244 = (_e226 - _e242);
            let _e245 = select(_e230, 0f, _e234);
            if _e234 {
                phi_417_ = 38685626000000000000000000f;
            } else {
                phi_417_ = (1f / _e230);
            }
            let _e248 = phi_417_;
            let _e249 = (_e159 == 0u);
            let _e251 = (_e159 == 2u);
            let _e254 = ((select(select(_e70.y, _e70.x, _e249), _e70.z, _e251) * _e169) * _e175);
            let _e258 = ((select(select(_e77.y, _e77.x, _e249), _e77.z, _e251) * _e186) * _e192);
            let _e262 = (bitcast<f32>((bitcast<u32>(_e258) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e262 {
                let _e266 = (bitcast<f32>((bitcast<u32>(_e254) & 2147483647u)) * 0.00000011920929f);
                phi_462_ = select(0.00000000000011368684f, _e266, (_e266 > 0.00000000000011368684f));
            } else {
                phi_462_ = 0f;
            }
            let _e270 = phi_462_;
            let _e271 = (_e254 + _e270);
            let _e272 = (_e254 - _e270);
            let _e273 = select(_e258, 0f, _e262);
            if _e262 {
                phi_473_ = 38685626000000000000000000f;
            } else {
                phi_473_ = (1f / _e258);
            }
            let _e276 = phi_473_;
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
                phi_569_ = select(-340282350000000000000000000000000000000f, _e317, (_e317 > -340282350000000000000000000000000000000f));
                phi_570_ = select(-340282350000000000000000000000000000000f, _e310, (_e310 > -340282350000000000000000000000000000000f));
            } else {
                phi_569_ = 0f;
                phi_570_ = 1f;
            }
            let _e321 = phi_569_;
            let _e323 = phi_570_;
            let _e324 = slimbvh_any_will_do.member;
            if (_e324 == 1u) {
                phi_580_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e321), true);
            } else {
                phi_580_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e321), false);
            }
            let _e331 = phi_580_;
            local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
            local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
            phi_1963_ = false;
            phi_590_ = _e331;
            phi_593_ = select(0u, 2147483648u, (_e63 == 0u));
            phi_595_ = ((3u * _e63) + 1u);
            phi_597_ = (_e323 <= _e321);
            phi_599_ = 0u;
            loop {
                let _e338 = phi_1963_;
                let _e340 = phi_590_;
                let _e342 = phi_593_;
                let _e344 = phi_595_;
                let _e346 = phi_597_;
                let _e348 = phi_599_;
                local_4 = _e340;
                if _e346 {
                    phi_610_ = true;
                } else {
                    phi_610_ = (_e348 > 0u);
                }
                let _e351 = phi_610_;
                if _e351 {
                    let _e352 = (_e344 > 0u);
                    if _e352 {
                        if _e346 {
                            phi_642_ = _e342;
                            phi_643_ = _e346;
                            phi_644_ = _e348;
                        } else {
                            let _e353 = (_e348 - 1u);
                            let _e354 = (_e353 % 128u);
                            let _e355 = (_e354 < 128u);
                            if _e355 {
                            } else {
                                phi_2072_ = true;
                                break;
                            }
                            let _e357 = local_1[_e354];
                            if _e355 {
                            } else {
                                phi_2072_ = true;
                                break;
                            }
                            let _e359 = local[_e354];
                            phi_642_ = _e357;
                            phi_643_ = (_e359 <= _e340.member.member_1);
                            phi_644_ = _e353;
                        }
                        let _e364 = phi_642_;
                        let _e366 = phi_643_;
                        let _e368 = phi_644_;
                        if _e366 {
                            if ((_e364 & 2147483648u) != 0u) {
                                phi_659_ = _e340;
                                phi_662_ = SlimbvhTypeA(0u, ((_e364 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e567 = phi_659_;
                                    let _e569 = phi_662_;
                                    local_2 = _e567;
                                    local_3 = _e567;
                                    local_5 = _e567;
                                    if (_e569.member < _e569.member_1) {
                                        phi_663_ = SlimbvhTypeA((_e569.member + 1u), _e569.member_1);
                                        phi_685_ = SlimbvhTypeA(1u, _e569.member);
                                    } else {
                                        phi_663_ = _e569;
                                        phi_685_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                                    }
                                    let _e582 = phi_663_;
                                    let _e584 = phi_685_;
                                    let _e588 = (bitcast<i32>(_e584.member) != 0i);
                                    if _e588 {
                                        let _e589 = ((_e364 & 268435455u) + _e584.member_1);
                                        let _e590 = (_e589 < _e65);
                                        if _e590 {
                                            if _e590 {
                                            } else {
                                                phi_1957_ = true;
                                                break;
                                            }
                                            let _e594 = slimbvh_triangles.member[_e589].member_1;
                                            phi_706_ = _e594;
                                        } else {
                                            phi_706_ = 4294967295u;
                                        }
                                        let _e596 = phi_706_;
                                        if (_e589 >= _e65) {
                                            phi_795_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                        } else {
                                            if _e590 {
                                            } else {
                                                phi_1957_ = true;
                                                break;
                                            }
                                            let _e598 = (_e158 % 3u);
                                            let _e599 = (_e157 % 3u);
                                            let _e600 = (_e159 % 3u);
                                            if (_e598 < 9u) {
                                            } else {
                                                phi_1957_ = true;
                                                break;
                                            }
                                            let _e606 = slimbvh_triangles.member[_e589].member[_e598];
                                            if (_e599 < 9u) {
                                            } else {
                                                phi_1957_ = true;
                                                break;
                                            }
                                            let _e612 = slimbvh_triangles.member[_e589].member[_e599];
                                            if (_e600 < 9u) {
                                            } else {
                                                phi_1957_ = true;
                                                break;
                                            }
                                            let _e618 = slimbvh_triangles.member[_e589].member[_e600];
                                            let _e620 = (3u + _e598);
                                            if (_e620 < 9u) {
                                            } else {
                                                phi_1957_ = true;
                                                break;
                                            }
                                            let _e626 = slimbvh_triangles.member[_e589].member[_e620];
                                            let _e627 = (3u + _e599);
                                            if (_e627 < 9u) {
                                            } else {
                                                phi_1957_ = true;
                                                break;
                                            }
                                            let _e633 = slimbvh_triangles.member[_e589].member[_e627];
                                            let _e634 = (3u + _e600);
                                            if (_e634 < 9u) {
                                            } else {
                                                phi_1957_ = true;
                                                break;
                                            }
                                            let _e640 = slimbvh_triangles.member[_e589].member[_e634];
                                            let _e642 = (6u + _e598);
                                            if (_e642 < 9u) {
                                            } else {
                                                phi_1957_ = true;
                                                break;
                                            }
                                            let _e648 = slimbvh_triangles.member[_e589].member[_e642];
                                            let _e649 = (6u + _e599);
                                            if (_e649 < 9u) {
                                            } else {
                                                phi_1957_ = true;
                                                break;
                                            }
                                            let _e655 = slimbvh_triangles.member[_e589].member[_e649];
                                            let _e656 = (6u + _e600);
                                            if (_e656 < 9u) {
                                            } else {
                                                phi_1957_ = true;
                                                break;
                                            }
                                            let _e662 = slimbvh_triangles.member[_e589].member[_e656];
                                            phi_795_ = array<array<f32, 3>, 3>(array<f32, 3>(_e606, _e612, _e618), array<f32, 3>(_e626, _e633, _e640), array<f32, 3>(_e648, _e655, _e662));
                                        }
                                        let _e666 = phi_795_;
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
                                                phi_1361_ = SlimbvhTypeE();
                                                phi_1362_ = true;
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
                                                    phi_1356_ = SlimbvhTypeE();
                                                    phi_1357_ = true;
                                                } else {
                                                    let _e805 = (_e803 > _e567.member.member_1);
                                                    if _e805 {
                                                        phi_1355_ = SlimbvhTypeE();
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
                                                            phi_1266_ = _e816;
                                                            phi_1267_ = _e820;
                                                        } else {
                                                            let _e866 = vec3((_e846 == _e863));
                                                            phi_1266_ = select(_e812, _e820, _e866);
                                                            phi_1267_ = select(_e816, _e812, _e866);
                                                        }
                                                        let _e870 = phi_1266_;
                                                        let _e872 = phi_1267_;
                                                        let _e879 = ((_e870.y * _e872.z) - (_e872.y * _e870.z));
                                                        let _e884 = ((_e870.z * _e872.x) - (_e872.z * _e870.x));
                                                        let _e887 = ((_e870.x * _e872.y) - (_e872.x * _e870.y));
                                                        if (_e729 >= _e733) {
                                                            phi_1298_ = select(true, false, (_e729 >= _e737));
                                                        } else {
                                                            phi_1298_ = true;
                                                        }
                                                        let _e892 = phi_1298_;
                                                        if _e892 {
                                                            phi_1307_ = select(vec3<f32>(_e666[2][0], _e666[2][1], _e666[2][2]), vec3<f32>(_e666[1][0], _e666[1][1], _e666[1][2]), vec3((_e733 >= _e737)));
                                                        } else {
                                                            phi_1307_ = vec3<f32>(_e666[0][0], _e666[0][1], _e666[0][2]);
                                                        }
                                                        let _e897 = phi_1307_;
                                                        let _e914 = ((((_e879 * (_e897.x - _e198)) + (_e884 * (_e897.y - _e226))) + (_e887 * (_e897.z - _e254))) / (((_e879 * _e217) + (_e884 * _e245)) + (_e887 * _e273)));
                                                        let _e916 = select(_e796, _e914, (_e914 < _e796));
                                                        let _e918 = select(_e788, _e916, (_e916 > _e788));
                                                        if (_e918 >= _e323) {
                                                            let _e920 = (_e918 <= _e567.member.member_1);
                                                            if _e920 {
                                                                let _e921 = (1f / _e739);
                                                                phi_1347_ = SlimbvhTypeE(_e918, (_e733 * _e921), (_e737 * _e921), _e596);
                                                            } else {
                                                                phi_1347_ = SlimbvhTypeE();
                                                            }
                                                            let _e926 = phi_1347_;
                                                            phi_1349_ = _e926;
                                                            phi_1350_ = select(true, false, _e920);
                                                        } else {
                                                            phi_1349_ = SlimbvhTypeE();
                                                            phi_1350_ = true;
                                                        }
                                                        let _e929 = phi_1349_;
                                                        let _e931 = phi_1350_;
                                                        if _e931 {
                                                            phi_1354_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                        } else {
                                                            phi_1354_ = _e929;
                                                        }
                                                        let _e933 = phi_1354_;
                                                        phi_1355_ = _e933;
                                                    }
                                                    let _e935 = phi_1355_;
                                                    phi_1356_ = _e935;
                                                    phi_1357_ = _e805;
                                                }
                                                let _e937 = phi_1356_;
                                                let _e939 = phi_1357_;
                                                phi_1361_ = _e937;
                                                phi_1362_ = _e939;
                                            }
                                            let _e941 = phi_1361_;
                                            let _e943 = phi_1362_;
                                            phi_1366_ = _e941;
                                            phi_1367_ = _e943;
                                        } else {
                                            phi_1366_ = SlimbvhTypeE();
                                            phi_1367_ = true;
                                        }
                                        let _e945 = phi_1366_;
                                        let _e947 = phi_1367_;
                                        if _e947 {
                                            phi_1371_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                        } else {
                                            phi_1371_ = _e945;
                                        }
                                        let _e949 = phi_1371_;
                                        if (_e949.member_3 != 4294967295u) {
                                            if (_e596 != 4294967295u) {
                                                if (_e949.member < _e567.member.member.member) {
                                                    phi_1397_ = true;
                                                } else {
                                                    if (_e949.member == _e567.member.member.member) {
                                                        phi_1396_ = (_e949.member_3 < _e567.member.member.member_3);
                                                    } else {
                                                        phi_1396_ = false;
                                                    }
                                                    let _e964 = phi_1396_;
                                                    phi_1397_ = _e964;
                                                }
                                                let _e966 = phi_1397_;
                                                if _e966 {
                                                    phi_1404_ = SlimbvhTypeK(SlimbvhTypeJ(_e949, _e949.member), _e567.member_1);
                                                } else {
                                                    phi_1404_ = _e567;
                                                }
                                                let _e972 = phi_1404_;
                                                phi_1405_ = _e972;
                                            } else {
                                                phi_1405_ = _e567;
                                            }
                                            let _e974 = phi_1405_;
                                            phi_1406_ = _e974;
                                        } else {
                                            phi_1406_ = _e567;
                                        }
                                        let _e976 = phi_1406_;
                                        phi_660_ = _e976;
                                    } else {
                                        phi_660_ = SlimbvhTypeK();
                                    }
                                    let _e978 = phi_660_;
                                    continue;
                                    continuing {
                                        phi_659_ = _e978;
                                        phi_662_ = _e582;
                                        phi_1957_ = _e338;
                                        break if !(_e588);
                                    }
                                }
                                let _e981 = phi_1957_;
                                phi_2072_ = _e981;
                                if _e981 {
                                    break;
                                }
                                let _e983 = local_2;
                                if _e983.member_1 {
                                    let _e986 = local_3;
                                    phi_1413_ = (_e986.member.member.member_3 != 4294967295u);
                                } else {
                                    phi_1413_ = false;
                                }
                                let _e992 = phi_1413_;
                                phi_2076_ = _e981;
                                let _e1160 = local_5;
                                phi_1868_ = _e1160;
                                phi_1869_ = _e364;
                                phi_1870_ = false;
                                phi_1871_ = select(_e368, 0u, _e992);
                            } else {
                                if (_e364 >= _e63) {
                                    phi_1473_ = SlimbvhTypeL(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                } else {
                                    if (_e364 < _e63) {
                                    } else {
                                        phi_2072_ = true;
                                        break;
                                    }
                                    let _e378 = (_e158 % 3u);
                                    if (_e378 < 3u) {
                                    } else {
                                        phi_2072_ = true;
                                        break;
                                    }
                                    let _e384 = slimbvh_nodes.member[_e364].member[_e378];
                                    let _e390 = (_e157 % 3u);
                                    if (_e390 < 3u) {
                                    } else {
                                        phi_2072_ = true;
                                        break;
                                    }
                                    let _e396 = slimbvh_nodes.member[_e364].member[_e390];
                                    let _e402 = (_e159 % 3u);
                                    if (_e402 < 3u) {
                                    } else {
                                        phi_2072_ = true;
                                        break;
                                    }
                                    let _e408 = slimbvh_nodes.member[_e364].member[_e402];
                                    let _e418 = slimbvh_nodes.member[_e364].member_1;
                                    let _e422 = slimbvh_nodes.member[_e364].member_2;
                                    phi_1473_ = SlimbvhTypeL(array<vec4<f32>, 3>(vec4<f32>(_e384[0], _e384[1], _e384[2], _e384[3]), vec4<f32>(_e396[0], _e396[1], _e396[2], _e396[3]), vec4<f32>(_e408[0], _e408[1], _e408[2], _e408[3])), _e418, _e422);
                                }
                                let _e425 = phi_1473_;
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
                                            phi_1817_ = _e425.member_2;
                                        } else {
                                            phi_1817_ = _e425.member_1;
                                        }
                                        let _e532 = phi_1817_;
                                        let _e535 = (_e368 % 128u);
                                        let _e536 = (_e535 < 128u);
                                        if _e536 {
                                        } else {
                                            phi_2072_ = true;
                                            break;
                                        }
                                        local_1[_e535] = _e532;
                                        if _e536 {
                                        } else {
                                            phi_2072_ = true;
                                            break;
                                        }
                                        local[_e535] = select(_e521, _e519, (_e519 > _e521));
                                        if _e528 {
                                            phi_1845_ = _e425.member_1;
                                        } else {
                                            phi_1845_ = _e425.member_2;
                                        }
                                        let _e543 = phi_1845_;
                                        phi_1846_ = _e543;
                                        phi_1847_ = (_e368 + 1u);
                                    } else {
                                        phi_1846_ = u32();
                                        phi_1847_ = u32();
                                    }
                                    let _e545 = phi_1846_;
                                    let _e547 = phi_1847_;
                                    phi_1849_ = _e545;
                                    phi_1850_ = _e547;
                                    phi_1851_ = select(true, false, _e527);
                                } else {
                                    phi_1849_ = u32();
                                    phi_1850_ = u32();
                                    phi_1851_ = true;
                                }
                                let _e550 = phi_1849_;
                                let _e552 = phi_1850_;
                                let _e554 = phi_1851_;
                                if _e554 {
                                    if _e526 {
                                        phi_1860_ = _e425.member_1;
                                    } else {
                                        phi_1860_ = _e425.member_2;
                                    }
                                    let _e558 = phi_1860_;
                                    phi_1865_ = _e558;
                                    phi_1866_ = select(_e527, true, _e526);
                                } else {
                                    phi_1865_ = _e550;
                                    phi_1866_ = _e366;
                                }
                                let _e561 = phi_1865_;
                                let _e563 = phi_1866_;
                                phi_2076_ = _e338;
                                phi_1868_ = _e340;
                                phi_1869_ = _e561;
                                phi_1870_ = _e563;
                                phi_1871_ = select(_e552, _e368, _e554);
                            }
                            let _e995 = phi_2076_;
                            let _e997 = phi_1868_;
                            let _e999 = phi_1869_;
                            let _e1001 = phi_1870_;
                            let _e1003 = phi_1871_;
                            phi_2075_ = _e995;
                            phi_1872_ = _e997;
                            phi_1873_ = _e999;
                            phi_1874_ = (_e344 - 1u);
                            phi_1875_ = _e1001;
                            phi_1876_ = _e1003;
                        } else {
                            phi_2075_ = _e338;
                            phi_1872_ = _e340;
                            phi_1873_ = _e364;
                            phi_1874_ = _e344;
                            phi_1875_ = _e366;
                            phi_1876_ = _e368;
                        }
                        let _e1005 = phi_2075_;
                        let _e1007 = phi_1872_;
                        let _e1009 = phi_1873_;
                        let _e1011 = phi_1874_;
                        let _e1013 = phi_1875_;
                        let _e1015 = phi_1876_;
                        phi_2074_ = _e1005;
                        phi_1877_ = _e1007;
                        phi_1878_ = _e1009;
                        phi_1879_ = _e1011;
                        phi_1880_ = _e1013;
                        phi_1881_ = _e1015;
                    } else {
                        phi_2074_ = _e338;
                        phi_1877_ = SlimbvhTypeK();
                        phi_1878_ = u32();
                        phi_1879_ = u32();
                        phi_1880_ = bool();
                        phi_1881_ = u32();
                    }
                    let _e1017 = phi_2074_;
                    let _e1019 = phi_1877_;
                    let _e1021 = phi_1878_;
                    let _e1023 = phi_1879_;
                    let _e1025 = phi_1880_;
                    let _e1027 = phi_1881_;
                    phi_2073_ = _e1017;
                    phi_591_ = _e1019;
                    phi_594_ = _e1021;
                    phi_596_ = _e1023;
                    phi_598_ = _e1025;
                    phi_600_ = _e1027;
                    phi_1882_ = _e352;
                } else {
                    phi_2073_ = _e338;
                    phi_591_ = SlimbvhTypeK();
                    phi_594_ = u32();
                    phi_596_ = u32();
                    phi_598_ = bool();
                    phi_600_ = u32();
                    phi_1882_ = false;
                }
                let _e1029 = phi_2073_;
                let _e1031 = phi_591_;
                let _e1033 = phi_594_;
                let _e1035 = phi_596_;
                let _e1037 = phi_598_;
                let _e1039 = phi_600_;
                let _e1041 = phi_1882_;
                continue;
                continuing {
                    phi_1963_ = _e1029;
                    phi_590_ = _e1031;
                    phi_593_ = _e1033;
                    phi_595_ = _e1035;
                    phi_597_ = _e1037;
                    phi_599_ = _e1039;
                    phi_2072_ = _e1029;
                    break if !(_e1041);
                }
            }
            let _e1044 = phi_2072_;
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
                phi_1934_ = SlimbvhTypeE(select(-340282350000000000000000000000000000000f, _e1070, (_e1070 > -340282350000000000000000000000000000000f)), _e1046.member.member.member_1, _e1046.member.member.member_2, _e1046.member.member.member_3);
            } else {
                phi_1934_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
            }
            let _e1077 = phi_1934_;
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
