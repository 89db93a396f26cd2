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
    var phi_240_: i32;
    var phi_241_: i32;
    var phi_251_: bool;
    var phi_261_: u32;
    var phi_262_: u32;
    var phi_264_: bool;
    var phi_269_: u32;
    var phi_281_: i32;
    var phi_301_: i32;
    var phi_355_: f32;
    var phi_366_: f32;
    var phi_411_: f32;
    var phi_422_: f32;
    var phi_467_: f32;
    var phi_478_: f32;
    var phi_574_: f32;
    var phi_575_: f32;
    var phi_585_: SlimbvhTypeK;
    var phi_2235_: bool;
    var phi_595_: SlimbvhTypeK;
    var phi_598_: u32;
    var phi_600_: u32;
    var phi_602_: bool;
    var phi_604_: u32;
    var phi_615_: bool;
    var phi_647_: u32;
    var phi_648_: bool;
    var phi_649_: u32;
    var phi_1745_: SlimbvhTypeL;
    var phi_2089_: u32;
    var phi_2117_: u32;
    var phi_2118_: u32;
    var phi_2119_: u32;
    var phi_2121_: u32;
    var phi_2122_: u32;
    var phi_2123_: bool;
    var phi_2132_: u32;
    var phi_2137_: u32;
    var phi_2138_: bool;
    var phi_664_: SlimbvhTypeK;
    var phi_667_: SlimbvhTypeA;
    var phi_668_: SlimbvhTypeA;
    var phi_690_: SlimbvhTypeA;
    var phi_711_: u32;
    var phi_800_: array<array<f32, 3>, 3>;
    var phi_917_: bool;
    var phi_946_: bool;
    var phi_1347_: f32;
    var phi_1348_: f32;
    var phi_1349_: f32;
    var phi_1350_: f32;
    var phi_1351_: vec3<f32>;
    var phi_1352_: vec3<f32>;
    var phi_1353_: vec3<f32>;
    var phi_1354_: vec3<f32>;
    var phi_1385_: bool;
    var phi_1394_: vec3<f32>;
    var phi_1561_: bool;
    var phi_1585_: f32;
    var phi_1586_: f32;
    var phi_1609_: SlimbvhTypeE;
    var phi_1611_: SlimbvhTypeE;
    var phi_1612_: bool;
    var phi_1616_: SlimbvhTypeE;
    var phi_1617_: SlimbvhTypeE;
    var phi_1618_: SlimbvhTypeE;
    var phi_1619_: bool;
    var phi_1623_: SlimbvhTypeE;
    var phi_1624_: bool;
    var phi_1625_: SlimbvhTypeE;
    var phi_1626_: bool;
    var phi_1627_: bool;
    var phi_1628_: SlimbvhTypeE;
    var phi_1629_: bool;
    var phi_1630_: bool;
    var phi_1638_: SlimbvhTypeE;
    var phi_1639_: bool;
    var phi_1643_: SlimbvhTypeE;
    var phi_1668_: bool;
    var phi_1669_: bool;
    var phi_1676_: SlimbvhTypeK;
    var phi_1677_: SlimbvhTypeK;
    var phi_1678_: SlimbvhTypeK;
    var phi_665_: SlimbvhTypeK;
    var phi_2229_: bool;
    var local_2: SlimbvhTypeK;
    var local_3: SlimbvhTypeK;
    var phi_1685_: bool;
    var phi_2376_: bool;
    var phi_2140_: SlimbvhTypeK;
    var phi_2141_: u32;
    var phi_2142_: bool;
    var phi_2143_: u32;
    var phi_2375_: bool;
    var phi_2144_: SlimbvhTypeK;
    var phi_2145_: u32;
    var phi_2146_: u32;
    var phi_2147_: bool;
    var phi_2148_: u32;
    var phi_2374_: bool;
    var phi_2149_: SlimbvhTypeK;
    var phi_2150_: u32;
    var phi_2151_: u32;
    var phi_2152_: bool;
    var phi_2153_: u32;
    var phi_2373_: bool;
    var phi_596_: SlimbvhTypeK;
    var phi_599_: u32;
    var phi_601_: u32;
    var phi_603_: bool;
    var phi_605_: u32;
    var phi_2154_: bool;
    var phi_2372_: bool;
    var local_4: SlimbvhTypeK;
    var phi_2206_: SlimbvhTypeE;
    var local_5: SlimbvhTypeK;

    switch bitcast<i32>(0u) {
        default: {
            let _e65 = arrayLength((&slimbvh_nodes.member));
            let _e67 = arrayLength((&slimbvh_triangles.member));
            let _e72 = slimbvh_origin.member;
            let _e78 = slimbvh_origin.member[3u];
            let _e79 = slimbvh_direction.member;
            let _e85 = slimbvh_direction.member[3u];
            let _e88 = slimbvh_exponent.member[0u];
            let _e89 = bitcast<i32>(_e88);
            let _e91 = (bitcast<u32>(_e79.x) & 2147483647u);
            let _e93 = (bitcast<u32>(_e79.y) & 2147483647u);
            let _e95 = (bitcast<u32>(_e79.z) & 2147483647u);
            let _e97 = (bitcast<u32>(_e72.x) & 2147483647u);
            let _e99 = (bitcast<u32>(_e72.y) & 2147483647u);
            let _e101 = (bitcast<u32>(_e72.z) & 2147483647u);
            let _e103 = select(_e93, _e91, (_e93 < _e91));
            let _e105 = select(_e95, _e103, (_e95 < _e103));
            let _e107 = select(_e97, _e105, (_e97 < _e105));
            let _e109 = select(_e99, _e107, (_e99 < _e107));
            let _e111 = select(_e101, _e109, (_e101 < _e109));
            let _e113 = (bitcast<u32>(_e78) & 2147483647u);
            let _e122 = (((select(_e113, _e111, (_e113 < _e111)) < 2139095040u) && ((bitcast<u32>(_e85) & 2147483647u) <= 2139095040u)) && (_e105 > 0u));
            if _e122 {
                let _e125 = (bitcast<u32>(bitcast<f32>(_e105)) & 2147483647u);
                if (_e125 >= 8388608u) {
                    phi_240_ = (bitcast<i32>((_e125 >> bitcast<u32>(23i))) - 127i);
                } else {
                    phi_240_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e125)), 32u, (_e125 == 0u))));
                }
                let _e139 = phi_240_;
                phi_241_ = _e139;
            } else {
                phi_241_ = 0i;
            }
            let _e141 = phi_241_;
            let _e142 = (_e91 == _e105);
            if _e142 {
                phi_251_ = true;
            } else {
                phi_251_ = (_e93 == _e105);
            }
            let _e145 = phi_251_;
            let _e146 = select(1u, 0u, _e142);
            if _e145 {
                let _e147 = (_e146 + 1u);
                phi_261_ = _e147;
                phi_262_ = _e147;
                phi_264_ = select(true, false, (_e147 == 2u));
            } else {
                phi_261_ = u32();
                phi_262_ = 0u;
                phi_264_ = true;
            }
            let _e151 = phi_261_;
            let _e153 = phi_262_;
            let _e155 = phi_264_;
            if _e155 {
                phi_269_ = (_e153 + 1u);
            } else {
                phi_269_ = 0u;
            }
            let _e159 = phi_269_;
            let _e160 = select(_e151, _e153, _e155);
            let _e161 = select(_e146, select(2u, _e146, _e145), _e155);
            if (_e89 < -126i) {
                phi_281_ = -126i;
            } else {
                phi_281_ = select(_e89, 127i, (_e89 > 127i));
            }
            let _e166 = phi_281_;
            let _e171 = bitcast<f32>((bitcast<u32>((_e166 + 127i)) << bitcast<u32>(23i)));
            let _e177 = bitcast<f32>((bitcast<u32>(((_e89 - _e166) + 127i)) << bitcast<u32>(23i)));
            let _e178 = -(_e141);
            if (_e178 < -126i) {
                phi_301_ = -126i;
            } else {
                phi_301_ = select(_e178, 127i, (_e178 > 127i));
            }
            let _e183 = phi_301_;
            let _e188 = bitcast<f32>((bitcast<u32>((_e183 + 127i)) << bitcast<u32>(23i)));
            let _e194 = bitcast<f32>((bitcast<u32>(((_e178 - _e183) + 127i)) << bitcast<u32>(23i)));
            let _e195 = (_e160 == 0u);
            let _e197 = (_e160 == 2u);
            let _e200 = ((select(select(_e72.y, _e72.x, _e195), _e72.z, _e197) * _e171) * _e177);
            let _e204 = ((select(select(_e79.y, _e79.x, _e195), _e79.z, _e197) * _e188) * _e194);
            let _e208 = (bitcast<f32>((bitcast<u32>(_e204) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e208 {
                let _e212 = (bitcast<f32>((bitcast<u32>(_e200) & 2147483647u)) * 0.00000011920929f);
                phi_355_ = select(0.00000000000011368684f, _e212, (_e212 > 0.00000000000011368684f));
            } else {
                phi_355_ = 0f;
            }
            let _e216 = phi_355_;
            let _e217 = (_e200 + _e216);
            let _e218 = (_e200 - _e216);
            let _e219 = select(_e204, 0f, _e208);
            if _e208 {
                phi_366_ = 38685626000000000000000000f;
            } else {
                phi_366_ = (1f / _e204);
            }
            let _e222 = phi_366_;
            let _e223 = (_e159 == 0u);
            let _e225 = (_e159 == 2u);
            let _e228 = ((select(select(_e72.y, _e72.x, _e223), _e72.z, _e225) * _e171) * _e177);
            let _e232 = ((select(select(_e79.y, _e79.x, _e223), _e79.z, _e225) * _e188) * _e194);
            let _e236 = (bitcast<f32>((bitcast<u32>(_e232) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e236 {
                let _e240 = (bitcast<f32>((bitcast<u32>(_e228) & 2147483647u)) * 0.00000011920929f);
                phi_411_ = select(0.00000000000011368684f, _e240, (_e240 > 0.00000000000011368684f));
            } else {
                phi_411_ = 0f;
            }
            let _e244 = phi_411_;
            let _e245 = (_e228 + _e244);
            let _e246 = (_e228 - _e244);
            let _e247 = select(_e232, 0f, _e236);
            if _e236 {
                phi_422_ = 38685626000000000000000000f;
            } else {
                phi_422_ = (1f / _e232);
            }
            let _e250 = phi_422_;
            let _e251 = (_e161 == 0u);
            let _e253 = (_e161 == 2u);
            let _e256 = ((select(select(_e72.y, _e72.x, _e251), _e72.z, _e253) * _e171) * _e177);
            let _e260 = ((select(select(_e79.y, _e79.x, _e251), _e79.z, _e253) * _e188) * _e194);
            let _e264 = (bitcast<f32>((bitcast<u32>(_e260) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e264 {
                let _e268 = (bitcast<f32>((bitcast<u32>(_e256) & 2147483647u)) * 0.00000011920929f);
                phi_467_ = select(0.00000000000011368684f, _e268, (_e268 > 0.00000000000011368684f));
            } else {
                phi_467_ = 0f;
            }
            let _e272 = phi_467_;
            let _e273 = (_e256 + _e272);
            let _e274 = (_e256 - _e272);
            let _e275 = select(_e260, 0f, _e264);
            if _e264 {
                phi_478_ = 38685626000000000000000000f;
            } else {
                phi_478_ = (1f / _e260);
            }
            let _e278 = phi_478_;
            let _e281 = bitcast<f32>((bitcast<u32>(_e200) & 2147483647u));
            let _e284 = bitcast<f32>((bitcast<u32>(_e228) & 2147483647u));
            let _e286 = select(_e284, _e281, (_e281 > _e284));
            let _e289 = bitcast<f32>((bitcast<u32>(_e256) & 2147483647u));
            let _e292 = (_e89 + _e141);
            if (_e122 && (select(_e289, _e286, (_e286 > _e289)) <= 1099511600000f)) {
                let _e295 = (_e292 / 3i);
                let _e302 = bitcast<f32>((bitcast<u32>((_e295 + 127i)) << bitcast<u32>(23i)));
                let _e309 = bitcast<f32>((bitcast<u32>(((_e292 - (2i * _e295)) + 127i)) << bitcast<u32>(23i)));
                let _e310 = (((_e78 * _e302) * _e302) * _e309);
                let _e312 = select(340282350000000000000000000000000000000f, _e310, (_e310 < 340282350000000000000000000000000000000f));
                let _e317 = (((_e85 * _e302) * _e302) * _e309);
                let _e319 = select(340282350000000000000000000000000000000f, _e317, (_e317 < 340282350000000000000000000000000000000f));
                phi_574_ = select(-340282350000000000000000000000000000000f, _e319, (_e319 > -340282350000000000000000000000000000000f));
                phi_575_ = select(-340282350000000000000000000000000000000f, _e312, (_e312 > -340282350000000000000000000000000000000f));
            } else {
                phi_574_ = 0f;
                phi_575_ = 1f;
            }
            let _e323 = phi_574_;
            let _e325 = phi_575_;
            let _e326 = slimbvh_any_will_do.member;
            if (_e326 == 1u) {
                phi_585_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e323), true);
            } else {
                phi_585_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e323), false);
            }
            let _e333 = phi_585_;
            local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
            local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
            phi_2235_ = false;
            phi_595_ = _e333;
            phi_598_ = select(0u, 2147483648u, (_e65 == 0u));
            phi_600_ = ((3u * _e65) + 1u);
            phi_602_ = (_e325 <= _e323);
            phi_604_ = 0u;
            loop {
                let _e340 = phi_2235_;
                let _e342 = phi_595_;
                let _e344 = phi_598_;
                let _e346 = phi_600_;
                let _e348 = phi_602_;
                let _e350 = phi_604_;
                local_4 = _e342;
                if _e348 {
                    phi_615_ = true;
                } else {
                    phi_615_ = (_e350 > 0u);
                }
                let _e353 = phi_615_;
                if _e353 {
                    let _e354 = (_e346 > 0u);
                    if _e354 {
                        if _e348 {
                            phi_647_ = _e344;
                            phi_648_ = _e348;
                            phi_649_ = _e350;
                        } else {
                            let _e355 = (_e350 - 1u);
                            let _e356 = (_e355 % 128u);
                            let _e357 = (_e356 < 128u);
                            if _e357 {
                            } else {
                                phi_2372_ = true;
                                break;
                            }
                            let _e359 = local_1[_e356];
                            if _e357 {
                            } else {
                                phi_2372_ = true;
                                break;
                            }
                            let _e361 = local[_e356];
                            phi_647_ = _e359;
                            phi_648_ = (_e361 <= _e342.member.member_1);
                            phi_649_ = _e355;
                        }
                        let _e366 = phi_647_;
                        let _e368 = phi_648_;
                        let _e370 = phi_649_;
                        if _e368 {
                            if ((_e366 & 2147483648u) != 0u) {
                                phi_664_ = _e342;
                                phi_667_ = SlimbvhTypeA(0u, ((_e366 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e569 = phi_664_;
                                    let _e571 = phi_667_;
                                    local_2 = _e569;
                                    local_3 = _e569;
                                    local_5 = _e569;
                                    if (_e571.member < _e571.member_1) {
                                        phi_668_ = SlimbvhTypeA((_e571.member + 1u), _e571.member_1);
                                        phi_690_ = SlimbvhTypeA(1u, _e571.member);
                                    } else {
                                        phi_668_ = _e571;
                                        phi_690_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                                    }
                                    let _e584 = phi_668_;
                                    let _e586 = phi_690_;
                                    let _e590 = (bitcast<i32>(_e586.member) != 0i);
                                    if _e590 {
                                        let _e591 = ((_e366 & 268435455u) + _e586.member_1);
                                        let _e592 = (_e591 < _e67);
                                        if _e592 {
                                            if _e592 {
                                            } else {
                                                phi_2229_ = true;
                                                break;
                                            }
                                            let _e596 = slimbvh_triangles.member[_e591].member_1;
                                            phi_711_ = _e596;
                                        } else {
                                            phi_711_ = 4294967295u;
                                        }
                                        let _e598 = phi_711_;
                                        if (_e591 >= _e67) {
                                            phi_800_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                        } else {
                                            if _e592 {
                                            } else {
                                                phi_2229_ = true;
                                                break;
                                            }
                                            let _e600 = (_e160 % 3u);
                                            let _e601 = (_e159 % 3u);
                                            let _e602 = (_e161 % 3u);
                                            if (_e600 < 9u) {
                                            } else {
                                                phi_2229_ = true;
                                                break;
                                            }
                                            let _e608 = slimbvh_triangles.member[_e591].member[_e600];
                                            if (_e601 < 9u) {
                                            } else {
                                                phi_2229_ = true;
                                                break;
                                            }
                                            let _e614 = slimbvh_triangles.member[_e591].member[_e601];
                                            if (_e602 < 9u) {
                                            } else {
                                                phi_2229_ = true;
                                                break;
                                            }
                                            let _e620 = slimbvh_triangles.member[_e591].member[_e602];
                                            let _e622 = (3u + _e600);
                                            if (_e622 < 9u) {
                                            } else {
                                                phi_2229_ = true;
                                                break;
                                            }
                                            let _e628 = slimbvh_triangles.member[_e591].member[_e622];
                                            let _e629 = (3u + _e601);
                                            if (_e629 < 9u) {
                                            } else {
                                                phi_2229_ = true;
                                                break;
                                            }
                                            let _e635 = slimbvh_triangles.member[_e591].member[_e629];
                                            let _e636 = (3u + _e602);
                                            if (_e636 < 9u) {
                                            } else {
                                                phi_2229_ = true;
                                                break;
                                            }
                                            let _e642 = slimbvh_triangles.member[_e591].member[_e636];
                                            let _e644 = (6u + _e600);
                                            if (_e644 < 9u) {
                                            } else {
                                                phi_2229_ = true;
                                                break;
                                            }
                                            let _e650 = slimbvh_triangles.member[_e591].member[_e644];
                                            let _e651 = (6u + _e601);
                                            if (_e651 < 9u) {
                                            } else {
                                                phi_2229_ = true;
                                                break;
                                            }
                                            let _e657 = slimbvh_triangles.member[_e591].member[_e651];
                                            let _e658 = (6u + _e602);
                                            if (_e658 < 9u) {
                                            } else {
                                                phi_2229_ = true;
                                                break;
                                            }
                                            let _e664 = slimbvh_triangles.member[_e591].member[_e658];
                                            phi_800_ = array<array<f32, 3>, 3>(array<f32, 3>(_e608, _e614, _e620), array<f32, 3>(_e628, _e635, _e642), array<f32, 3>(_e650, _e657, _e664));
                                        }
                                        let _e668 = phi_800_;
                                        let _e677 = (_e668[0][2] - _e256);
                                        let _e680 = (((_e668[0][0] - _e200) * _e275) - (_e677 * _e219));
                                        let _e683 = (((_e668[0][1] - _e228) * _e275) - (_e677 * _e247));
                                        let _e690 = (_e668[1][2] - _e256);
                                        let _e693 = (((_e668[1][0] - _e200) * _e275) - (_e690 * _e219));
                                        let _e696 = (((_e668[1][1] - _e228) * _e275) - (_e690 * _e247));
                                        let _e703 = (_e668[2][2] - _e256);
                                        let _e706 = (((_e668[2][0] - _e200) * _e275) - (_e703 * _e219));
                                        let _e709 = (((_e668[2][1] - _e228) * _e275) - (_e703 * _e247));
                                        let _e710 = (_e706 * _e696);
                                        let _e711 = (_e709 * _e693);
                                        let _e712 = (_e680 * _e709);
                                        let _e713 = (_e683 * _e706);
                                        let _e714 = (_e693 * _e683);
                                        let _e715 = (_e696 * _e680);
                                        let _e720 = (((_e710 >= _e711) && (_e712 >= _e713)) && (_e714 >= _e715));
                                        if (_e720 || (((_e710 <= _e711) && (_e712 <= _e713)) && (_e714 <= _e715))) {
                                            let _e727 = select(-1f, 1f, _e720);
                                            let _e729 = ((_e710 - _e711) * _e727);
                                            let _e731 = select(0f, _e729, (_e729 > 0f));
                                            let _e733 = ((_e712 - _e713) * _e727);
                                            let _e735 = select(0f, _e733, (_e733 > 0f));
                                            let _e737 = ((_e714 - _e715) * _e727);
                                            let _e739 = select(0f, _e737, (_e737 > 0f));
                                            let _e741 = ((_e731 + _e735) + _e739);
                                            if (_e741 < 0.000000000000000000000000000000000000011754944f) {
                                                phi_1628_ = SlimbvhTypeE();
                                                phi_1629_ = true;
                                                phi_1630_ = false;
                                            } else {
                                                let _e744 = select(_e693, _e680, (_e680 < _e693));
                                                if (select(_e706, _e744, (_e744 < _e706)) > 0f) {
                                                    phi_917_ = true;
                                                } else {
                                                    let _e749 = select(_e693, _e680, (_e680 > _e693));
                                                    phi_917_ = (select(_e706, _e749, (_e749 > _e706)) < 0f);
                                                }
                                                let _e754 = phi_917_;
                                                if _e754 {
                                                    phi_1625_ = SlimbvhTypeE();
                                                    phi_1626_ = true;
                                                    phi_1627_ = false;
                                                } else {
                                                    let _e756 = select(_e696, _e683, (_e683 < _e696));
                                                    if (select(_e709, _e756, (_e756 < _e709)) > 0f) {
                                                        phi_946_ = true;
                                                    } else {
                                                        let _e761 = select(_e696, _e683, (_e683 > _e696));
                                                        phi_946_ = (select(_e709, _e761, (_e761 > _e709)) < 0f);
                                                    }
                                                    let _e766 = phi_946_;
                                                    if _e766 {
                                                        phi_1623_ = SlimbvhTypeE();
                                                        phi_1624_ = false;
                                                    } else {
                                                        let _e768 = select(_e668[1][0], _e668[0][0], (_e668[0][0] < _e668[1][0]));
                                                        let _e772 = select(_e668[1][0], _e668[0][0], (_e668[0][0] > _e668[1][0]));
                                                        let _e776 = select(_e668[1][1], _e668[0][1], (_e668[0][1] < _e668[1][1]));
                                                        let _e780 = select(_e668[1][1], _e668[0][1], (_e668[0][1] > _e668[1][1]));
                                                        let _e784 = select(_e668[1][2], _e668[0][2], (_e668[0][2] < _e668[1][2]));
                                                        let _e788 = select(_e668[1][2], _e668[0][2], (_e668[0][2] > _e668[1][2]));
                                                        let _e793 = ((select(_e668[2][0], _e768, (_e768 < _e668[2][0])) - _e217) * _e222);
                                                        let _e794 = ((select(_e668[2][0], _e772, (_e772 > _e668[2][0])) - _e218) * _e222);
                                                        let _e797 = ((select(_e668[2][1], _e776, (_e776 < _e668[2][1])) - _e245) * _e250);
                                                        let _e798 = ((select(_e668[2][1], _e780, (_e780 > _e668[2][1])) - _e246) * _e250);
                                                        let _e801 = ((select(_e668[2][2], _e784, (_e784 < _e668[2][2])) - _e273) * _e278);
                                                        let _e802 = ((select(_e668[2][2], _e788, (_e788 > _e668[2][2])) - _e274) * _e278);
                                                        let _e804 = select(_e802, _e801, (_e801 < _e802));
                                                        let _e806 = select(_e802, _e801, (_e801 > _e802));
                                                        let _e808 = select(_e794, _e793, (_e793 < _e794));
                                                        let _e810 = select(_e798, _e797, (_e797 < _e798));
                                                        let _e812 = select(_e810, _e808, (_e808 > _e810));
                                                        let _e814 = select(_e804, _e812, (_e812 > _e804));
                                                        let _e816 = select(_e794, _e793, (_e793 > _e794));
                                                        let _e818 = select(_e798, _e797, (_e797 > _e798));
                                                        let _e820 = select(_e818, _e816, (_e816 < _e818));
                                                        let _e822 = select(_e806, _e820, (_e820 < _e806));
                                                        let _e823 = -(_e804);
                                                        let _e829 = select(_e325, _e814, (_e814 > _e325));
                                                        if (_e829 > (_e822 + (select(_e823, _e806, (_e806 > _e823)) * 0.0000019073523f))) {
                                                            phi_1618_ = SlimbvhTypeE();
                                                            phi_1619_ = true;
                                                        } else {
                                                            let _e831 = (_e829 > _e569.member.member_1);
                                                            if _e831 {
                                                                phi_1617_ = SlimbvhTypeE();
                                                            } else {
                                                                let _e832 = vec3<f32>(_e668[0][0], _e668[0][1], _e668[0][2]);
                                                                let _e833 = vec3<f32>(_e668[1][0], _e668[1][1], _e668[1][2]);
                                                                let _e834 = vec3<f32>(_e668[2][0], _e668[2][1], _e668[2][2]);
                                                                let _e835 = (_e668[1][0] - _e668[0][0]);
                                                                let _e836 = (_e668[1][1] - _e668[0][1]);
                                                                let _e837 = (_e668[1][2] - _e668[0][2]);
                                                                let _e838 = vec3<f32>(_e835, _e836, _e837);
                                                                let _e839 = (_e668[2][0] - _e668[1][0]);
                                                                let _e840 = (_e668[2][1] - _e668[1][1]);
                                                                let _e841 = (_e668[2][2] - _e668[1][2]);
                                                                let _e842 = vec3<f32>(_e839, _e840, _e841);
                                                                let _e843 = (_e668[0][0] - _e668[2][0]);
                                                                let _e844 = (_e668[0][1] - _e668[2][1]);
                                                                let _e845 = (_e668[0][2] - _e668[2][2]);
                                                                let _e846 = vec3<f32>(_e843, _e844, _e845);
                                                                let _e849 = bitcast<f32>((bitcast<u32>(_e835) & 2147483647u));
                                                                let _e852 = bitcast<f32>((bitcast<u32>(_e836) & 2147483647u));
                                                                let _e854 = select(_e852, _e849, (_e849 > _e852));
                                                                let _e857 = bitcast<f32>((bitcast<u32>(_e837) & 2147483647u));
                                                                let _e859 = select(_e857, _e854, (_e854 > _e857));
                                                                let _e862 = bitcast<f32>((bitcast<u32>(_e839) & 2147483647u));
                                                                let _e865 = bitcast<f32>((bitcast<u32>(_e840) & 2147483647u));
                                                                let _e867 = select(_e865, _e862, (_e862 > _e865));
                                                                let _e870 = bitcast<f32>((bitcast<u32>(_e841) & 2147483647u));
                                                                let _e872 = select(_e870, _e867, (_e867 > _e870));
                                                                let _e875 = bitcast<f32>((bitcast<u32>(_e843) & 2147483647u));
                                                                let _e878 = bitcast<f32>((bitcast<u32>(_e844) & 2147483647u));
                                                                let _e880 = select(_e878, _e875, (_e875 > _e878));
                                                                let _e883 = bitcast<f32>((bitcast<u32>(_e845) & 2147483647u));
                                                                let _e885 = select(_e883, _e880, (_e880 > _e883));
                                                                let _e887 = select(_e872, _e859, (_e859 > _e872));
                                                                let _e889 = select(_e885, _e887, (_e887 > _e885));
                                                                if (_e859 == _e889) {
                                                                    phi_1347_ = _e696;
                                                                    phi_1348_ = _e693;
                                                                    phi_1349_ = _e683;
                                                                    phi_1350_ = _e680;
                                                                    phi_1351_ = _e832;
                                                                    phi_1352_ = _e846;
                                                                    phi_1353_ = _e842;
                                                                    phi_1354_ = _e838;
                                                                } else {
                                                                    let _e891 = (_e872 == _e889);
                                                                    let _e896 = vec3(_e891);
                                                                    phi_1347_ = select(_e683, _e709, _e891);
                                                                    phi_1348_ = select(_e680, _e706, _e891);
                                                                    phi_1349_ = select(_e709, _e696, _e891);
                                                                    phi_1350_ = select(_e706, _e693, _e891);
                                                                    phi_1351_ = select(_e834, _e833, _e896);
                                                                    phi_1352_ = select(_e842, _e838, _e896);
                                                                    phi_1353_ = select(_e838, _e846, _e896);
                                                                    phi_1354_ = select(_e846, _e842, _e896);
                                                                }
                                                                let _e902 = phi_1347_;
                                                                let _e904 = phi_1348_;
                                                                let _e906 = phi_1349_;
                                                                let _e908 = phi_1350_;
                                                                let _e910 = phi_1351_;
                                                                let _e912 = phi_1352_;
                                                                let _e914 = phi_1353_;
                                                                let _e916 = phi_1354_;
                                                                let _e923 = ((_e914.y * _e912.z) - (_e912.y * _e914.z));
                                                                let _e928 = ((_e914.z * _e912.x) - (_e912.z * _e914.x));
                                                                let _e931 = ((_e914.x * _e912.y) - (_e912.x * _e914.y));
                                                                if (_e731 >= _e735) {
                                                                    phi_1385_ = select(true, false, (_e731 >= _e739));
                                                                } else {
                                                                    phi_1385_ = true;
                                                                }
                                                                let _e936 = phi_1385_;
                                                                if _e936 {
                                                                    phi_1394_ = select(_e834, _e833, vec3((_e735 >= _e739)));
                                                                } else {
                                                                    phi_1394_ = _e832;
                                                                }
                                                                let _e941 = phi_1394_;
                                                                let _e946 = (((_e923 * _e219) + (_e928 * _e247)) + (_e931 * _e275));
                                                                let _e957 = (((_e923 * (_e941.x - _e200)) + (_e928 * (_e941.y - _e228))) + (_e931 * (_e941.z - _e256)));
                                                                let _e959 = (_e904 - _e908);
                                                                let _e960 = (_e902 - _e906);
                                                                let _e968 = (-(((_e908 * _e959) + (_e906 * _e960))) / ((_e959 * _e959) + (_e960 * _e960)));
                                                                let _e970 = select(1f, _e968, (_e968 < 1f));
                                                                let _e972 = select(0f, _e970, (_e970 > 0f));
                                                                let _e985 = ((_e910.x + (_e916.x * _e972)) - _e200);
                                                                let _e986 = ((_e910.y + (_e916.y * _e972)) - _e228);
                                                                let _e987 = ((_e910.z + (_e916.z * _e972)) - _e256);
                                                                let _e988 = (_e987 / _e275);
                                                                let _e1000 = bitcast<f32>((bitcast<u32>(_e985) & 2147483647u));
                                                                let _e1003 = bitcast<f32>((bitcast<u32>(_e986) & 2147483647u));
                                                                let _e1005 = select(_e1003, _e1000, (_e1000 > _e1003));
                                                                let _e1008 = bitcast<f32>((bitcast<u32>(_e987) & 2147483647u));
                                                                let _e1010 = select(_e1008, _e1005, (_e1005 > _e1008));
                                                                let _e1016 = bitcast<f32>((bitcast<u32>(_e923) & 2147483647u));
                                                                let _e1019 = bitcast<f32>((bitcast<u32>(_e928) & 2147483647u));
                                                                let _e1021 = select(_e1019, _e1016, (_e1016 > _e1019));
                                                                let _e1024 = bitcast<f32>((bitcast<u32>(_e931) & 2147483647u));
                                                                if (bitcast<f32>((bitcast<u32>(((((_e923 * _e985) + (_e928 * _e986)) + (_e931 * _e987)) - _e957)) & 2147483647u)) <= ((0.0000009536743f * select(_e889, _e1010, (_e1010 > _e889))) * select(_e1024, _e1021, (_e1021 > _e1024)))) {
                                                                    let _e1034 = bitcast<f32>((bitcast<u32>(_e914.x) & 2147483647u));
                                                                    let _e1037 = bitcast<f32>((bitcast<u32>(_e914.y) & 2147483647u));
                                                                    let _e1039 = select(_e1037, _e1034, (_e1034 > _e1037));
                                                                    let _e1042 = bitcast<f32>((bitcast<u32>(_e914.z) & 2147483647u));
                                                                    let _e1048 = bitcast<f32>((bitcast<u32>(_e912.x) & 2147483647u));
                                                                    let _e1051 = bitcast<f32>((bitcast<u32>(_e912.y) & 2147483647u));
                                                                    let _e1053 = select(_e1051, _e1048, (_e1048 > _e1051));
                                                                    let _e1056 = bitcast<f32>((bitcast<u32>(_e912.z) & 2147483647u));
                                                                    phi_1561_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e946) & 2147483647u)) > ((0.0000038146973f * select(_e1042, _e1039, (_e1039 > _e1042))) * select(_e1056, _e1053, (_e1053 > _e1056)))));
                                                                } else {
                                                                    phi_1561_ = true;
                                                                }
                                                                let _e1063 = phi_1561_;
                                                                if _e1063 {
                                                                    let _e1074 = ((((_e923 * (_e985 - (_e219 * _e988))) + (_e928 * (_e986 - (_e247 * _e988)))) + (_e931 * (_e987 - _e987))) / _e946);
                                                                    if (bitcast<f32>((bitcast<u32>(_e1074) & 2147483647u)) <= _e889) {
                                                                        phi_1585_ = (_e988 + _e1074);
                                                                    } else {
                                                                        phi_1585_ = _e988;
                                                                    }
                                                                    let _e1081 = phi_1585_;
                                                                    phi_1586_ = _e1081;
                                                                } else {
                                                                    phi_1586_ = (_e957 / _e946);
                                                                }
                                                                let _e1083 = phi_1586_;
                                                                let _e1085 = select(_e822, _e1083, (_e1083 < _e822));
                                                                let _e1087 = select(_e814, _e1085, (_e1085 > _e814));
                                                                if (_e1087 >= _e325) {
                                                                    let _e1089 = (_e1087 <= _e569.member.member_1);
                                                                    if _e1089 {
                                                                        let _e1090 = (1f / _e741);
                                                                        phi_1609_ = SlimbvhTypeE(_e1087, (_e735 * _e1090), (_e739 * _e1090), _e598);
                                                                    } else {
                                                                        phi_1609_ = SlimbvhTypeE();
                                                                    }
                                                                    let _e1095 = phi_1609_;
                                                                    phi_1611_ = _e1095;
                                                                    phi_1612_ = select(true, false, _e1089);
                                                                } else {
                                                                    phi_1611_ = SlimbvhTypeE();
                                                                    phi_1612_ = true;
                                                                }
                                                                let _e1098 = phi_1611_;
                                                                let _e1100 = phi_1612_;
                                                                if _e1100 {
                                                                    phi_1616_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1616_ = _e1098;
                                                                }
                                                                let _e1102 = phi_1616_;
                                                                phi_1617_ = _e1102;
                                                            }
                                                            let _e1104 = phi_1617_;
                                                            phi_1618_ = _e1104;
                                                            phi_1619_ = _e831;
                                                        }
                                                        let _e1106 = phi_1618_;
                                                        let _e1108 = phi_1619_;
                                                        phi_1623_ = _e1106;
                                                        phi_1624_ = _e1108;
                                                    }
                                                    let _e1110 = phi_1623_;
                                                    let _e1112 = phi_1624_;
                                                    phi_1625_ = _e1110;
                                                    phi_1626_ = _e766;
                                                    phi_1627_ = _e1112;
                                                }
                                                let _e1114 = phi_1625_;
                                                let _e1116 = phi_1626_;
                                                let _e1118 = phi_1627_;
                                                phi_1628_ = _e1114;
                                                phi_1629_ = _e1116;
                                                phi_1630_ = _e1118;
                                            }
                                            let _e1120 = phi_1628_;
                                            let _e1122 = phi_1629_;
                                            let _e1124 = phi_1630_;
                                            phi_1638_ = _e1120;
                                            phi_1639_ = select(_e1124, true, _e1122);
                                        } else {
                                            phi_1638_ = SlimbvhTypeE();
                                            phi_1639_ = true;
                                        }
                                        let _e1127 = phi_1638_;
                                        let _e1129 = phi_1639_;
                                        if _e1129 {
                                            phi_1643_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                        } else {
                                            phi_1643_ = _e1127;
                                        }
                                        let _e1131 = phi_1643_;
                                        if (_e1131.member_3 != 4294967295u) {
                                            if (_e598 != 4294967295u) {
                                                if (_e1131.member < _e569.member.member.member) {
                                                    phi_1669_ = true;
                                                } else {
                                                    if (_e1131.member == _e569.member.member.member) {
                                                        phi_1668_ = (_e1131.member_3 < _e569.member.member.member_3);
                                                    } else {
                                                        phi_1668_ = false;
                                                    }
                                                    let _e1146 = phi_1668_;
                                                    phi_1669_ = _e1146;
                                                }
                                                let _e1148 = phi_1669_;
                                                if _e1148 {
                                                    phi_1676_ = SlimbvhTypeK(SlimbvhTypeJ(_e1131, _e1131.member), _e569.member_1);
                                                } else {
                                                    phi_1676_ = _e569;
                                                }
                                                let _e1154 = phi_1676_;
                                                phi_1677_ = _e1154;
                                            } else {
                                                phi_1677_ = _e569;
                                            }
                                            let _e1156 = phi_1677_;
                                            phi_1678_ = _e1156;
                                        } else {
                                            phi_1678_ = _e569;
                                        }
                                        let _e1158 = phi_1678_;
                                        phi_665_ = _e1158;
                                    } else {
                                        phi_665_ = SlimbvhTypeK();
                                    }
                                    let _e1160 = phi_665_;
                                    continue;
                                    continuing {
                                        phi_664_ = _e1160;
                                        phi_667_ = _e584;
                                        phi_2229_ = _e340;
                                        break if !(_e590);
                                    }
                                }
                                let _e1163 = phi_2229_;
                                phi_2372_ = _e1163;
                                if _e1163 {
                                    break;
                                }
                                let _e1165 = local_2;
                                if _e1165.member_1 {
                                    let _e1168 = local_3;
                                    phi_1685_ = (_e1168.member.member.member_3 != 4294967295u);
                                } else {
                                    phi_1685_ = false;
                                }
                                let _e1174 = phi_1685_;
                                phi_2376_ = _e1163;
                                let _e1359 = local_5;
                                phi_2140_ = _e1359;
                                phi_2141_ = _e366;
                                phi_2142_ = false;
                                phi_2143_ = select(_e370, 0u, _e1174);
                            } else {
                                if (_e366 >= _e65) {
                                    phi_1745_ = SlimbvhTypeL(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                } else {
                                    if (_e366 < _e65) {
                                    } else {
                                        phi_2372_ = true;
                                        break;
                                    }
                                    let _e380 = (_e160 % 3u);
                                    if (_e380 < 3u) {
                                    } else {
                                        phi_2372_ = true;
                                        break;
                                    }
                                    let _e386 = slimbvh_nodes.member[_e366].member[_e380];
                                    let _e392 = (_e159 % 3u);
                                    if (_e392 < 3u) {
                                    } else {
                                        phi_2372_ = true;
                                        break;
                                    }
                                    let _e398 = slimbvh_nodes.member[_e366].member[_e392];
                                    let _e404 = (_e161 % 3u);
                                    if (_e404 < 3u) {
                                    } else {
                                        phi_2372_ = true;
                                        break;
                                    }
                                    let _e410 = slimbvh_nodes.member[_e366].member[_e404];
                                    let _e420 = slimbvh_nodes.member[_e366].member_1;
                                    let _e424 = slimbvh_nodes.member[_e366].member_2;
                                    phi_1745_ = SlimbvhTypeL(array<vec4<f32>, 3>(vec4<f32>(_e386[0], _e386[1], _e386[2], _e386[3]), vec4<f32>(_e398[0], _e398[1], _e398[2], _e398[3]), vec4<f32>(_e410[0], _e410[1], _e410[2], _e410[3])), _e420, _e424);
                                }
                                let _e427 = phi_1745_;
                                let _e440 = ((_e427.member[0].x - _e217) * _e222);
                                let _e441 = ((_e427.member[0].y - _e217) * _e222);
                                let _e442 = ((_e427.member[0].z - _e218) * _e222);
                                let _e443 = ((_e427.member[0].w - _e218) * _e222);
                                let _e453 = ((_e427.member[1].x - _e245) * _e250);
                                let _e454 = ((_e427.member[1].y - _e245) * _e250);
                                let _e455 = ((_e427.member[1].z - _e246) * _e250);
                                let _e456 = ((_e427.member[1].w - _e246) * _e250);
                                let _e466 = ((_e427.member[2].x - _e273) * _e278);
                                let _e467 = ((_e427.member[2].y - _e273) * _e278);
                                let _e468 = ((_e427.member[2].z - _e274) * _e278);
                                let _e469 = ((_e427.member[2].w - _e274) * _e278);
                                let _e471 = select(_e468, _e466, (_e466 < _e468));
                                let _e473 = select(_e469, _e467, (_e467 < _e469));
                                let _e475 = select(_e468, _e466, (_e466 > _e468));
                                let _e477 = select(_e469, _e467, (_e467 > _e469));
                                let _e479 = select(_e442, _e440, (_e440 < _e442));
                                let _e481 = select(_e443, _e441, (_e441 < _e443));
                                let _e483 = select(_e455, _e453, (_e453 < _e455));
                                let _e485 = select(_e456, _e454, (_e454 < _e456));
                                let _e487 = select(_e483, _e479, (_e479 > _e483));
                                let _e489 = select(_e485, _e481, (_e481 > _e485));
                                let _e491 = select(_e471, _e487, (_e487 > _e471));
                                let _e493 = select(_e473, _e489, (_e489 > _e473));
                                let _e495 = select(_e442, _e440, (_e440 > _e442));
                                let _e497 = select(_e443, _e441, (_e441 > _e443));
                                let _e499 = select(_e455, _e453, (_e453 > _e455));
                                let _e501 = select(_e456, _e454, (_e454 > _e456));
                                let _e503 = select(_e499, _e495, (_e495 < _e499));
                                let _e505 = select(_e501, _e497, (_e497 < _e501));
                                let _e510 = -(_e471);
                                let _e511 = -(_e473);
                                let _e518 = (select(_e475, _e503, (_e503 < _e475)) + (select(_e510, _e475, (_e475 > _e510)) * 0.0000019073523f));
                                let _e519 = (select(_e477, _e505, (_e505 < _e477)) + (select(_e511, _e477, (_e477 > _e511)) * 0.0000019073523f));
                                let _e521 = select(_e325, _e491, (_e491 > _e325));
                                let _e523 = select(_e325, _e493, (_e493 > _e325));
                                let _e528 = (_e521 <= select(_e342.member.member_1, _e518, (_e518 < _e342.member.member_1)));
                                let _e529 = (_e523 <= select(_e342.member.member_1, _e519, (_e519 < _e342.member.member_1)));
                                let _e530 = (_e521 <= _e523);
                                if _e528 {
                                    if _e529 {
                                        if _e530 {
                                            phi_2089_ = _e427.member_2;
                                        } else {
                                            phi_2089_ = _e427.member_1;
                                        }
                                        let _e534 = phi_2089_;
                                        let _e537 = (_e370 % 128u);
                                        let _e538 = (_e537 < 128u);
                                        if _e538 {
                                        } else {
                                            phi_2372_ = true;
                                            break;
                                        }
                                        local_1[_e537] = _e534;
                                        if _e538 {
                                        } else {
                                            phi_2372_ = true;
                                            break;
                                        }
                                        local[_e537] = select(_e523, _e521, (_e521 > _e523));
                                        if _e530 {
                                            phi_2117_ = _e427.member_1;
                                        } else {
                                            phi_2117_ = _e427.member_2;
                                        }
                                        let _e545 = phi_2117_;
                                        phi_2118_ = _e545;
                                        phi_2119_ = (_e370 + 1u);
                                    } else {
                                        phi_2118_ = u32();
                                        phi_2119_ = u32();
                                    }
                                    let _e547 = phi_2118_;
                                    let _e549 = phi_2119_;
                                    phi_2121_ = _e547;
                                    phi_2122_ = _e549;
                                    phi_2123_ = select(true, false, _e529);
                                } else {
                                    phi_2121_ = u32();
                                    phi_2122_ = u32();
                                    phi_2123_ = true;
                                }
                                let _e552 = phi_2121_;
                                let _e554 = phi_2122_;
                                let _e556 = phi_2123_;
                                if _e556 {
                                    if _e528 {
                                        phi_2132_ = _e427.member_1;
                                    } else {
                                        phi_2132_ = _e427.member_2;
                                    }
                                    let _e560 = phi_2132_;
                                    phi_2137_ = _e560;
                                    phi_2138_ = select(_e529, true, _e528);
                                } else {
                                    phi_2137_ = _e552;
                                    phi_2138_ = _e368;
                                }
                                let _e563 = phi_2137_;
                                let _e565 = phi_2138_;
                                phi_2376_ = _e340;
                                phi_2140_ = _e342;
                                phi_2141_ = _e563;
                                phi_2142_ = _e565;
                                phi_2143_ = select(_e554, _e370, _e556);
                            }
                            let _e1177 = phi_2376_;
                            let _e1179 = phi_2140_;
                            let _e1181 = phi_2141_;
                            let _e1183 = phi_2142_;
                            let _e1185 = phi_2143_;
                            phi_2375_ = _e1177;
                            phi_2144_ = _e1179;
                            phi_2145_ = _e1181;
                            phi_2146_ = (_e346 - 1u);
                            phi_2147_ = _e1183;
                            phi_2148_ = _e1185;
                        } else {
                            phi_2375_ = _e340;
                            phi_2144_ = _e342;
                            phi_2145_ = _e366;
                            phi_2146_ = _e346;
                            phi_2147_ = _e368;
                            phi_2148_ = _e370;
                        }
                        let _e1187 = phi_2375_;
                        let _e1189 = phi_2144_;
                        let _e1191 = phi_2145_;
                        let _e1193 = phi_2146_;
                        let _e1195 = phi_2147_;
                        let _e1197 = phi_2148_;
                        phi_2374_ = _e1187;
                        phi_2149_ = _e1189;
                        phi_2150_ = _e1191;
                        phi_2151_ = _e1193;
                        phi_2152_ = _e1195;
                        phi_2153_ = _e1197;
                    } else {
                        phi_2374_ = _e340;
                        phi_2149_ = SlimbvhTypeK();
                        phi_2150_ = u32();
                        phi_2151_ = u32();
                        phi_2152_ = bool();
                        phi_2153_ = u32();
                    }
                    let _e1199 = phi_2374_;
                    let _e1201 = phi_2149_;
                    let _e1203 = phi_2150_;
                    let _e1205 = phi_2151_;
                    let _e1207 = phi_2152_;
                    let _e1209 = phi_2153_;
                    phi_2373_ = _e1199;
                    phi_596_ = _e1201;
                    phi_599_ = _e1203;
                    phi_601_ = _e1205;
                    phi_603_ = _e1207;
                    phi_605_ = _e1209;
                    phi_2154_ = _e354;
                } else {
                    phi_2373_ = _e340;
                    phi_596_ = SlimbvhTypeK();
                    phi_599_ = u32();
                    phi_601_ = u32();
                    phi_603_ = bool();
                    phi_605_ = u32();
                    phi_2154_ = false;
                }
                let _e1211 = phi_2373_;
                let _e1213 = phi_596_;
                let _e1215 = phi_599_;
                let _e1217 = phi_601_;
                let _e1219 = phi_603_;
                let _e1221 = phi_605_;
                let _e1223 = phi_2154_;
                continue;
                continuing {
                    phi_2235_ = _e1211;
                    phi_595_ = _e1213;
                    phi_598_ = _e1215;
                    phi_600_ = _e1217;
                    phi_602_ = _e1219;
                    phi_604_ = _e1221;
                    phi_2372_ = _e1211;
                    break if !(_e1223);
                }
            }
            let _e1226 = phi_2372_;
            if _e1226 {
                break;
            }
            let _e1228 = local_4;
            if (_e1228.member.member.member_3 != 4294967295u) {
                let _e1234 = -(_e292);
                let _e1235 = (_e1234 / 3i);
                let _e1242 = bitcast<f32>((bitcast<u32>((_e1235 + 127i)) << bitcast<u32>(23i)));
                let _e1250 = (((_e1228.member.member.member * _e1242) * _e1242) * bitcast<f32>((bitcast<u32>(((_e1234 - (2i * _e1235)) + 127i)) << bitcast<u32>(23i))));
                let _e1252 = select(340282350000000000000000000000000000000f, _e1250, (_e1250 < 340282350000000000000000000000000000000f));
                phi_2206_ = SlimbvhTypeE(select(-340282350000000000000000000000000000000f, _e1252, (_e1252 > -340282350000000000000000000000000000000f)), _e1228.member.member.member_1, _e1228.member.member.member_2, _e1228.member.member.member_3);
            } else {
                phi_2206_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
            }
            let _e1259 = phi_2206_;
            slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1259.member), bitcast<u32>(_e1259.member_1), bitcast<u32>(_e1259.member_2), _e1259.member_3);
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
