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
    var phi_233_: i32;
    var phi_234_: i32;
    var phi_244_: bool;
    var phi_254_: u32;
    var phi_255_: u32;
    var phi_257_: bool;
    var phi_262_: u32;
    var phi_342_: f32;
    var phi_353_: f32;
    var phi_398_: f32;
    var phi_409_: f32;
    var phi_454_: f32;
    var phi_465_: f32;
    var phi_561_: f32;
    var phi_562_: f32;
    var phi_572_: SlimbvhTypeK;
    var phi_2219_: bool;
    var phi_845_: SlimbvhTypeK;
    var phi_848_: u32;
    var phi_850_: u32;
    var phi_852_: bool;
    var phi_854_: u32;
    var phi_865_: bool;
    var phi_896_: u32;
    var phi_897_: bool;
    var phi_898_: u32;
    var phi_1727_: SlimbvhTypeL;
    var phi_2071_: u32;
    var phi_2098_: u32;
    var phi_2099_: u32;
    var phi_2100_: u32;
    var phi_2102_: u32;
    var phi_2103_: u32;
    var phi_2104_: bool;
    var phi_2113_: u32;
    var phi_2118_: u32;
    var phi_2119_: bool;
    var phi_913_: SlimbvhTypeK;
    var phi_916_: SlimbvhTypeA;
    var phi_917_: SlimbvhTypeA;
    var phi_939_: SlimbvhTypeA;
    var phi_960_: u32;
    var phi_1049_: array<array<f32, 3>, 3>;
    var phi_1520_: vec3<f32>;
    var phi_1521_: vec3<f32>;
    var phi_1552_: bool;
    var phi_1561_: vec3<f32>;
    var phi_1601_: SlimbvhTypeE;
    var phi_1603_: SlimbvhTypeE;
    var phi_1604_: bool;
    var phi_1608_: SlimbvhTypeE;
    var phi_1609_: SlimbvhTypeE;
    var phi_1610_: SlimbvhTypeE;
    var phi_1611_: bool;
    var phi_1615_: SlimbvhTypeE;
    var phi_1616_: bool;
    var phi_1620_: SlimbvhTypeE;
    var phi_1621_: bool;
    var phi_1625_: SlimbvhTypeE;
    var phi_1650_: bool;
    var phi_1651_: bool;
    var phi_1658_: SlimbvhTypeK;
    var phi_1659_: SlimbvhTypeK;
    var phi_1660_: SlimbvhTypeK;
    var phi_914_: SlimbvhTypeK;
    var phi_2213_: bool;
    var local_2: SlimbvhTypeK;
    var local_3: SlimbvhTypeK;
    var phi_1667_: bool;
    var phi_2328_: bool;
    var phi_2121_: SlimbvhTypeK;
    var phi_2122_: u32;
    var phi_2123_: bool;
    var phi_2124_: u32;
    var phi_2327_: bool;
    var phi_2125_: SlimbvhTypeK;
    var phi_2126_: u32;
    var phi_2127_: u32;
    var phi_2128_: bool;
    var phi_2129_: u32;
    var phi_2326_: bool;
    var phi_2130_: SlimbvhTypeK;
    var phi_2131_: u32;
    var phi_2132_: u32;
    var phi_2133_: bool;
    var phi_2134_: u32;
    var phi_2325_: bool;
    var phi_846_: SlimbvhTypeK;
    var phi_849_: u32;
    var phi_851_: u32;
    var phi_853_: bool;
    var phi_855_: u32;
    var phi_2135_: bool;
    var phi_2324_: bool;
    var local_4: SlimbvhTypeK;
    var phi_2187_: SlimbvhTypeE;
    var local_5: SlimbvhTypeK;

    switch bitcast<i32>(0u) {
        default: {
            let _e62 = arrayLength((&slimbvh_nodes.member));
            let _e64 = arrayLength((&slimbvh_triangles.member));
            let _e69 = slimbvh_origin.member;
            let _e75 = slimbvh_origin.member[3u];
            let _e76 = slimbvh_direction.member;
            let _e82 = slimbvh_direction.member[3u];
            let _e85 = slimbvh_exponent.member[0u];
            let _e86 = bitcast<i32>(_e85);
            let _e88 = (bitcast<u32>(_e76.x) & 2147483647u);
            let _e90 = (bitcast<u32>(_e76.y) & 2147483647u);
            let _e92 = (bitcast<u32>(_e76.z) & 2147483647u);
            let _e94 = (bitcast<u32>(_e69.x) & 2147483647u);
            let _e96 = (bitcast<u32>(_e69.y) & 2147483647u);
            let _e98 = (bitcast<u32>(_e69.z) & 2147483647u);
            let _e100 = select(_e90, _e88, (_e90 < _e88));
            let _e102 = select(_e92, _e100, (_e92 < _e100));
            let _e104 = select(_e94, _e102, (_e94 < _e102));
            let _e106 = select(_e96, _e104, (_e96 < _e104));
            let _e108 = select(_e98, _e106, (_e98 < _e106));
            let _e110 = (bitcast<u32>(_e75) & 2147483647u);
            let _e119 = (((select(_e110, _e108, (_e110 < _e108)) < 2139095040u) && ((bitcast<u32>(_e82) & 2147483647u) <= 2139095040u)) && (_e102 > 0u));
            if _e119 {
                let _e122 = (bitcast<u32>(bitcast<f32>(_e102)) & 2147483647u);
                if (_e122 >= 8388608u) {
                    phi_233_ = (bitcast<i32>((_e122 >> bitcast<u32>(23i))) - 127i);
                } else {
                    phi_233_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e122)), 32u, (_e122 == 0u))));
                }
                let _e136 = phi_233_;
                phi_234_ = _e136;
            } else {
                phi_234_ = 0i;
            }
            let _e138 = phi_234_;
            let _e139 = (_e88 == _e102);
            if _e139 {
                phi_244_ = true;
            } else {
                phi_244_ = (_e90 == _e102);
            }
            let _e142 = phi_244_;
            let _e143 = select(1u, 0u, _e139);
            if _e142 {
                let _e144 = (_e143 + 1u);
                phi_254_ = _e144;
                phi_255_ = _e144;
                phi_257_ = select(true, false, (_e144 == 2u));
            } else {
                phi_254_ = u32();
                phi_255_ = 0u;
                phi_257_ = true;
            }
            let _e148 = phi_254_;
            let _e150 = phi_255_;
            let _e152 = phi_257_;
            if _e152 {
                phi_262_ = (_e150 + 1u);
            } else {
                phi_262_ = 0u;
            }
            let _e156 = phi_262_;
            let _e157 = select(_e148, _e150, _e152);
            let _e158 = select(_e143, select(2u, _e143, _e142), _e152);
            let _e159 = (_e86 / 2i);
            let _e164 = bitcast<f32>((bitcast<u32>((_e159 + 127i)) << bitcast<u32>(23i)));
            let _e170 = bitcast<f32>((bitcast<u32>(((_e86 - _e159) + 127i)) << bitcast<u32>(23i)));
            let _e171 = -(_e138);
            let _e172 = (_e171 / 2i);
            let _e177 = bitcast<f32>((bitcast<u32>((_e172 + 127i)) << bitcast<u32>(23i)));
            let _e183 = bitcast<f32>((bitcast<u32>(((_e171 - _e172) + 127i)) << bitcast<u32>(23i)));
            let _e184 = (_e157 == 0u);
            let _e186 = (_e157 == 2u);
            let _e189 = ((select(select(_e69.y, _e69.x, _e184), _e69.z, _e186) * _e164) * _e170);
            let _e193 = ((select(select(_e76.y, _e76.x, _e184), _e76.z, _e186) * _e177) * _e183);
            let _e197 = (bitcast<f32>((bitcast<u32>(_e193) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e197 {
                let _e201 = (bitcast<f32>((bitcast<u32>(_e189) & 2147483647u)) * 0.00000011920929f);
                phi_342_ = select(0.00000000000011368684f, _e201, (_e201 > 0.00000000000011368684f));
            } else {
                phi_342_ = 0f;
            }
            let _e205 = phi_342_;
            let _e206 = (_e189 + _e205);
            let _e207 = (_e189 - _e205);
            let _e208 = select(_e193, 0f, _e197);
            if _e197 {
                phi_353_ = 38685626000000000000000000f;
            } else {
                phi_353_ = (1f / _e193);
            }
            let _e211 = phi_353_;
            let _e212 = (_e156 == 0u);
            let _e214 = (_e156 == 2u);
            let _e217 = ((select(select(_e69.y, _e69.x, _e212), _e69.z, _e214) * _e164) * _e170);
            let _e221 = ((select(select(_e76.y, _e76.x, _e212), _e76.z, _e214) * _e177) * _e183);
            let _e225 = (bitcast<f32>((bitcast<u32>(_e221) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e225 {
                let _e229 = (bitcast<f32>((bitcast<u32>(_e217) & 2147483647u)) * 0.00000011920929f);
                phi_398_ = select(0.00000000000011368684f, _e229, (_e229 > 0.00000000000011368684f));
            } else {
                phi_398_ = 0f;
            }
            let _e233 = phi_398_;
            let _e234 = (_e217 + _e233);
            let _e235 = (_e217 - _e233);
            let _e236 = select(_e221, 0f, _e225);
            if _e225 {
                phi_409_ = 38685626000000000000000000f;
            } else {
                phi_409_ = (1f / _e221);
            }
            let _e239 = phi_409_;
            let _e240 = (_e158 == 0u);
            let _e242 = (_e158 == 2u);
            let _e245 = ((select(select(_e69.y, _e69.x, _e240), _e69.z, _e242) * _e164) * _e170);
            let _e249 = ((select(select(_e76.y, _e76.x, _e240), _e76.z, _e242) * _e177) * _e183);
            let _e253 = (bitcast<f32>((bitcast<u32>(_e249) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e253 {
                let _e257 = (bitcast<f32>((bitcast<u32>(_e245) & 2147483647u)) * 0.00000011920929f);
                phi_454_ = select(0.00000000000011368684f, _e257, (_e257 > 0.00000000000011368684f));
            } else {
                phi_454_ = 0f;
            }
            let _e261 = phi_454_;
            let _e262 = (_e245 + _e261);
            let _e263 = (_e245 - _e261);
            let _e264 = select(_e249, 0f, _e253);
            if _e253 {
                phi_465_ = 38685626000000000000000000f;
            } else {
                phi_465_ = (1f / _e249);
            }
            let _e267 = phi_465_;
            let _e270 = bitcast<f32>((bitcast<u32>(_e189) & 2147483647u));
            let _e273 = bitcast<f32>((bitcast<u32>(_e217) & 2147483647u));
            let _e275 = select(_e273, _e270, (_e270 > _e273));
            let _e278 = bitcast<f32>((bitcast<u32>(_e245) & 2147483647u));
            let _e281 = (_e86 + _e138);
            if (_e119 && (select(_e278, _e275, (_e275 > _e278)) <= 1099511600000f)) {
                let _e284 = (_e281 / 3i);
                let _e291 = bitcast<f32>((bitcast<u32>((_e284 + 127i)) << bitcast<u32>(23i)));
                let _e298 = bitcast<f32>((bitcast<u32>(((_e281 - (2i * _e284)) + 127i)) << bitcast<u32>(23i)));
                let _e299 = (((_e75 * _e291) * _e291) * _e298);
                let _e301 = select(340282350000000000000000000000000000000f, _e299, (_e299 < 340282350000000000000000000000000000000f));
                let _e306 = (((_e82 * _e291) * _e291) * _e298);
                let _e308 = select(340282350000000000000000000000000000000f, _e306, (_e306 < 340282350000000000000000000000000000000f));
                phi_561_ = select(-340282350000000000000000000000000000000f, _e308, (_e308 > -340282350000000000000000000000000000000f));
                phi_562_ = select(-340282350000000000000000000000000000000f, _e301, (_e301 > -340282350000000000000000000000000000000f));
            } else {
                phi_561_ = 0f;
                phi_562_ = 1f;
            }
            let _e312 = phi_561_;
            let _e314 = phi_562_;
            let _e315 = slimbvh_any_will_do.member;
            if (_e315 == 1u) {
                phi_572_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e312), true);
            } else {
                phi_572_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e312), false);
            }
            let _e322 = phi_572_;
            local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
            local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
            phi_2219_ = false;
            phi_845_ = _e322;
            phi_848_ = select(0u, 2147483648u, (_e62 == 0u));
            phi_850_ = ((3u * _e62) + 1u);
            phi_852_ = (_e314 <= _e312);
            phi_854_ = 0u;
            loop {
                let _e329 = phi_2219_;
                let _e331 = phi_845_;
                let _e333 = phi_848_;
                let _e335 = phi_850_;
                let _e337 = phi_852_;
                let _e339 = phi_854_;
                local_4 = _e331;
                if _e337 {
                    phi_865_ = true;
                } else {
                    phi_865_ = (_e339 > 0u);
                }
                let _e342 = phi_865_;
                if _e342 {
                    let _e343 = (_e335 > 0u);
                    if _e343 {
                        if _e337 {
                            phi_896_ = _e333;
                            phi_897_ = _e337;
                            phi_898_ = _e339;
                        } else {
                            let _e344 = (_e339 - 1u);
                            let _e345 = (_e344 % 128u);
                            let _e346 = (_e345 < 128u);
                            if _e346 {
                            } else {
                                phi_2324_ = true;
                                break;
                            }
                            let _e348 = local_1[_e345];
                            if _e346 {
                            } else {
                                phi_2324_ = true;
                                break;
                            }
                            let _e350 = local[_e345];
                            phi_896_ = _e348;
                            phi_897_ = (_e350 <= _e331.member.member_1);
                            phi_898_ = _e344;
                        }
                        let _e355 = phi_896_;
                        let _e357 = phi_897_;
                        let _e359 = phi_898_;
                        if _e357 {
                            if ((_e355 & 2147483648u) != 0u) {
                                phi_913_ = _e331;
                                phi_916_ = SlimbvhTypeA(0u, ((_e355 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e558 = phi_913_;
                                    let _e560 = phi_916_;
                                    local_2 = _e558;
                                    local_3 = _e558;
                                    local_5 = _e558;
                                    if (_e560.member < _e560.member_1) {
                                        phi_917_ = SlimbvhTypeA((_e560.member + 1u), _e560.member_1);
                                        phi_939_ = SlimbvhTypeA(1u, _e560.member);
                                    } else {
                                        phi_917_ = _e560;
                                        phi_939_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                                    }
                                    let _e573 = phi_917_;
                                    let _e575 = phi_939_;
                                    let _e579 = (bitcast<i32>(_e575.member) != 0i);
                                    if _e579 {
                                        let _e580 = ((_e355 & 268435455u) + _e575.member_1);
                                        let _e581 = (_e580 < _e64);
                                        if _e581 {
                                            if _e581 {
                                            } else {
                                                phi_2213_ = true;
                                                break;
                                            }
                                            let _e585 = slimbvh_triangles.member[_e580].member_1;
                                            phi_960_ = _e585;
                                        } else {
                                            phi_960_ = 4294967295u;
                                        }
                                        let _e587 = phi_960_;
                                        if (_e580 >= _e64) {
                                            phi_1049_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                        } else {
                                            if _e581 {
                                            } else {
                                                phi_2213_ = true;
                                                break;
                                            }
                                            let _e589 = (_e157 % 3u);
                                            let _e590 = (_e156 % 3u);
                                            let _e591 = (_e158 % 3u);
                                            if (_e589 < 9u) {
                                            } else {
                                                phi_2213_ = true;
                                                break;
                                            }
                                            let _e597 = slimbvh_triangles.member[_e580].member[_e589];
                                            if (_e590 < 9u) {
                                            } else {
                                                phi_2213_ = true;
                                                break;
                                            }
                                            let _e603 = slimbvh_triangles.member[_e580].member[_e590];
                                            if (_e591 < 9u) {
                                            } else {
                                                phi_2213_ = true;
                                                break;
                                            }
                                            let _e609 = slimbvh_triangles.member[_e580].member[_e591];
                                            let _e611 = (3u + _e589);
                                            if (_e611 < 9u) {
                                            } else {
                                                phi_2213_ = true;
                                                break;
                                            }
                                            let _e617 = slimbvh_triangles.member[_e580].member[_e611];
                                            let _e618 = (3u + _e590);
                                            if (_e618 < 9u) {
                                            } else {
                                                phi_2213_ = true;
                                                break;
                                            }
                                            let _e624 = slimbvh_triangles.member[_e580].member[_e618];
                                            let _e625 = (3u + _e591);
                                            if (_e625 < 9u) {
                                            } else {
                                                phi_2213_ = true;
                                                break;
                                            }
                                            let _e631 = slimbvh_triangles.member[_e580].member[_e625];
                                            let _e633 = (6u + _e589);
                                            if (_e633 < 9u) {
                                            } else {
                                                phi_2213_ = true;
                                                break;
                                            }
                                            let _e639 = slimbvh_triangles.member[_e580].member[_e633];
                                            let _e640 = (6u + _e590);
                                            if (_e640 < 9u) {
                                            } else {
                                                phi_2213_ = true;
                                                break;
                                            }
                                            let _e646 = slimbvh_triangles.member[_e580].member[_e640];
                                            let _e647 = (6u + _e591);
                                            if (_e647 < 9u) {
                                            } else {
                                                phi_2213_ = true;
                                                break;
                                            }
                                            let _e653 = slimbvh_triangles.member[_e580].member[_e647];
                                            phi_1049_ = array<array<f32, 3>, 3>(array<f32, 3>(_e597, _e603, _e609), array<f32, 3>(_e617, _e624, _e631), array<f32, 3>(_e639, _e646, _e653));
                                        }
                                        let _e657 = phi_1049_;
                                        let _e666 = (_e657[0][2] - _e245);
                                        let _e669 = (((_e657[0][0] - _e189) * _e264) - (_e666 * _e208));
                                        let _e672 = (((_e657[0][1] - _e217) * _e264) - (_e666 * _e236));
                                        let _e679 = (_e657[1][2] - _e245);
                                        let _e682 = (((_e657[1][0] - _e189) * _e264) - (_e679 * _e208));
                                        let _e685 = (((_e657[1][1] - _e217) * _e264) - (_e679 * _e236));
                                        let _e692 = (_e657[2][2] - _e245);
                                        let _e695 = (((_e657[2][0] - _e189) * _e264) - (_e692 * _e208));
                                        let _e698 = (((_e657[2][1] - _e217) * _e264) - (_e692 * _e236));
                                        let _e699 = (_e695 * _e685);
                                        let _e700 = (_e698 * _e682);
                                        let _e701 = (_e669 * _e698);
                                        let _e702 = (_e672 * _e695);
                                        let _e703 = (_e682 * _e672);
                                        let _e704 = (_e685 * _e669);
                                        let _e709 = (((_e699 >= _e700) && (_e701 >= _e702)) && (_e703 >= _e704));
                                        if (_e709 || (((_e699 <= _e700) && (_e701 <= _e702)) && (_e703 <= _e704))) {
                                            let _e716 = select(-1f, 1f, _e709);
                                            let _e718 = ((_e699 - _e700) * _e716);
                                            let _e720 = select(0f, _e718, (_e718 > 0f));
                                            let _e722 = ((_e701 - _e702) * _e716);
                                            let _e724 = select(0f, _e722, (_e722 > 0f));
                                            let _e726 = ((_e703 - _e704) * _e716);
                                            let _e728 = select(0f, _e726, (_e726 > 0f));
                                            let _e730 = ((_e720 + _e724) + _e728);
                                            if (_e730 < 0.000000000000000000000000000000000000011754944f) {
                                                phi_1615_ = SlimbvhTypeE();
                                                phi_1616_ = true;
                                            } else {
                                                let _e733 = select(_e657[1][0], _e657[0][0], (_e657[0][0] < _e657[1][0]));
                                                let _e737 = select(_e657[1][0], _e657[0][0], (_e657[0][0] > _e657[1][0]));
                                                let _e741 = select(_e657[1][1], _e657[0][1], (_e657[0][1] < _e657[1][1]));
                                                let _e745 = select(_e657[1][1], _e657[0][1], (_e657[0][1] > _e657[1][1]));
                                                let _e749 = select(_e657[1][2], _e657[0][2], (_e657[0][2] < _e657[1][2]));
                                                let _e753 = select(_e657[1][2], _e657[0][2], (_e657[0][2] > _e657[1][2]));
                                                let _e758 = ((select(_e657[2][0], _e733, (_e733 < _e657[2][0])) - _e206) * _e211);
                                                let _e759 = ((select(_e657[2][0], _e737, (_e737 > _e657[2][0])) - _e207) * _e211);
                                                let _e762 = ((select(_e657[2][1], _e741, (_e741 < _e657[2][1])) - _e234) * _e239);
                                                let _e763 = ((select(_e657[2][1], _e745, (_e745 > _e657[2][1])) - _e235) * _e239);
                                                let _e766 = ((select(_e657[2][2], _e749, (_e749 < _e657[2][2])) - _e262) * _e267);
                                                let _e767 = ((select(_e657[2][2], _e753, (_e753 > _e657[2][2])) - _e263) * _e267);
                                                let _e769 = select(_e767, _e766, (_e766 < _e767));
                                                let _e771 = select(_e767, _e766, (_e766 > _e767));
                                                let _e773 = select(_e759, _e758, (_e758 < _e759));
                                                let _e775 = select(_e763, _e762, (_e762 < _e763));
                                                let _e777 = select(_e775, _e773, (_e773 > _e775));
                                                let _e779 = select(_e769, _e777, (_e777 > _e769));
                                                let _e781 = select(_e759, _e758, (_e758 > _e759));
                                                let _e783 = select(_e763, _e762, (_e762 > _e763));
                                                let _e785 = select(_e783, _e781, (_e781 < _e783));
                                                let _e787 = select(_e771, _e785, (_e785 < _e771));
                                                let _e788 = -(_e769);
                                                let _e794 = select(_e314, _e779, (_e779 > _e314));
                                                if (_e794 > (_e787 + (select(_e788, _e771, (_e771 > _e788)) * 0.0000019073523f))) {
                                                    phi_1610_ = SlimbvhTypeE();
                                                    phi_1611_ = true;
                                                } else {
                                                    let _e796 = (_e794 > _e558.member.member_1);
                                                    if _e796 {
                                                        phi_1609_ = SlimbvhTypeE();
                                                    } else {
                                                        let _e800 = (_e657[1][0] - _e657[0][0]);
                                                        let _e801 = (_e657[1][1] - _e657[0][1]);
                                                        let _e802 = (_e657[1][2] - _e657[0][2]);
                                                        let _e803 = vec3<f32>(_e800, _e801, _e802);
                                                        let _e804 = (_e657[2][0] - _e657[1][0]);
                                                        let _e805 = (_e657[2][1] - _e657[1][1]);
                                                        let _e806 = (_e657[2][2] - _e657[1][2]);
                                                        let _e807 = vec3<f32>(_e804, _e805, _e806);
                                                        let _e808 = (_e657[0][0] - _e657[2][0]);
                                                        let _e809 = (_e657[0][1] - _e657[2][1]);
                                                        let _e810 = (_e657[0][2] - _e657[2][2]);
                                                        let _e811 = vec3<f32>(_e808, _e809, _e810);
                                                        let _e814 = bitcast<f32>((bitcast<u32>(_e800) & 2147483647u));
                                                        let _e817 = bitcast<f32>((bitcast<u32>(_e801) & 2147483647u));
                                                        let _e819 = select(_e817, _e814, (_e814 > _e817));
                                                        let _e822 = bitcast<f32>((bitcast<u32>(_e802) & 2147483647u));
                                                        let _e824 = select(_e822, _e819, (_e819 > _e822));
                                                        let _e827 = bitcast<f32>((bitcast<u32>(_e804) & 2147483647u));
                                                        let _e830 = bitcast<f32>((bitcast<u32>(_e805) & 2147483647u));
                                                        let _e832 = select(_e830, _e827, (_e827 > _e830));
                                                        let _e835 = bitcast<f32>((bitcast<u32>(_e806) & 2147483647u));
                                                        let _e837 = select(_e835, _e832, (_e832 > _e835));
                                                        let _e840 = bitcast<f32>((bitcast<u32>(_e808) & 2147483647u));
                                                        let _e843 = bitcast<f32>((bitcast<u32>(_e809) & 2147483647u));
                                                        let _e845 = select(_e843, _e840, (_e840 > _e843));
                                                        let _e848 = bitcast<f32>((bitcast<u32>(_e810) & 2147483647u));
                                                        let _e850 = select(_e848, _e845, (_e845 > _e848));
                                                        let _e852 = select(_e837, _e824, (_e824 > _e837));
                                                        let _e854 = select(_e850, _e852, (_e852 > _e850));
                                                        if (_e824 == _e854) {
                                                            phi_1520_ = _e807;
                                                            phi_1521_ = _e811;
                                                        } else {
                                                            let _e857 = vec3((_e837 == _e854));
                                                            phi_1520_ = select(_e803, _e811, _e857);
                                                            phi_1521_ = select(_e807, _e803, _e857);
                                                        }
                                                        let _e861 = phi_1520_;
                                                        let _e863 = phi_1521_;
                                                        let _e870 = ((_e861.y * _e863.z) - (_e863.y * _e861.z));
                                                        let _e875 = ((_e861.z * _e863.x) - (_e863.z * _e861.x));
                                                        let _e878 = ((_e861.x * _e863.y) - (_e863.x * _e861.y));
                                                        if (_e720 >= _e724) {
                                                            phi_1552_ = select(true, false, (_e720 >= _e728));
                                                        } else {
                                                            phi_1552_ = true;
                                                        }
                                                        let _e883 = phi_1552_;
                                                        if _e883 {
                                                            phi_1561_ = select(vec3<f32>(_e657[2][0], _e657[2][1], _e657[2][2]), vec3<f32>(_e657[1][0], _e657[1][1], _e657[1][2]), vec3((_e724 >= _e728)));
                                                        } else {
                                                            phi_1561_ = vec3<f32>(_e657[0][0], _e657[0][1], _e657[0][2]);
                                                        }
                                                        let _e888 = phi_1561_;
                                                        let _e905 = ((((_e870 * (_e888.x - _e189)) + (_e875 * (_e888.y - _e217))) + (_e878 * (_e888.z - _e245))) / (((_e870 * _e208) + (_e875 * _e236)) + (_e878 * _e264)));
                                                        let _e907 = select(_e787, _e905, (_e905 < _e787));
                                                        let _e909 = select(_e779, _e907, (_e907 > _e779));
                                                        if (_e909 >= _e314) {
                                                            let _e911 = (_e909 <= _e558.member.member_1);
                                                            if _e911 {
                                                                let _e912 = (1f / _e730);
                                                                phi_1601_ = SlimbvhTypeE(_e909, (_e724 * _e912), (_e728 * _e912), _e587);
                                                            } else {
                                                                phi_1601_ = SlimbvhTypeE();
                                                            }
                                                            let _e917 = phi_1601_;
                                                            phi_1603_ = _e917;
                                                            phi_1604_ = select(true, false, _e911);
                                                        } else {
                                                            phi_1603_ = SlimbvhTypeE();
                                                            phi_1604_ = true;
                                                        }
                                                        let _e920 = phi_1603_;
                                                        let _e922 = phi_1604_;
                                                        if _e922 {
                                                            phi_1608_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                        } else {
                                                            phi_1608_ = _e920;
                                                        }
                                                        let _e924 = phi_1608_;
                                                        phi_1609_ = _e924;
                                                    }
                                                    let _e926 = phi_1609_;
                                                    phi_1610_ = _e926;
                                                    phi_1611_ = _e796;
                                                }
                                                let _e928 = phi_1610_;
                                                let _e930 = phi_1611_;
                                                phi_1615_ = _e928;
                                                phi_1616_ = _e930;
                                            }
                                            let _e932 = phi_1615_;
                                            let _e934 = phi_1616_;
                                            phi_1620_ = _e932;
                                            phi_1621_ = _e934;
                                        } else {
                                            phi_1620_ = SlimbvhTypeE();
                                            phi_1621_ = true;
                                        }
                                        let _e936 = phi_1620_;
                                        let _e938 = phi_1621_;
                                        if _e938 {
                                            phi_1625_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                        } else {
                                            phi_1625_ = _e936;
                                        }
                                        let _e940 = phi_1625_;
                                        if (_e940.member_3 != 4294967295u) {
                                            if (_e587 != 4294967295u) {
                                                if (_e940.member < _e558.member.member.member) {
                                                    phi_1651_ = true;
                                                } else {
                                                    if (_e940.member == _e558.member.member.member) {
                                                        phi_1650_ = (_e940.member_3 < _e558.member.member.member_3);
                                                    } else {
                                                        phi_1650_ = false;
                                                    }
                                                    let _e955 = phi_1650_;
                                                    phi_1651_ = _e955;
                                                }
                                                let _e957 = phi_1651_;
                                                if _e957 {
                                                    phi_1658_ = SlimbvhTypeK(SlimbvhTypeJ(_e940, _e940.member), _e558.member_1);
                                                } else {
                                                    phi_1658_ = _e558;
                                                }
                                                let _e963 = phi_1658_;
                                                phi_1659_ = _e963;
                                            } else {
                                                phi_1659_ = _e558;
                                            }
                                            let _e965 = phi_1659_;
                                            phi_1660_ = _e965;
                                        } else {
                                            phi_1660_ = _e558;
                                        }
                                        let _e967 = phi_1660_;
                                        phi_914_ = _e967;
                                    } else {
                                        phi_914_ = SlimbvhTypeK();
                                    }
                                    let _e969 = phi_914_;
                                    continue;
                                    continuing {
                                        phi_913_ = _e969;
                                        phi_916_ = _e573;
                                        phi_2213_ = _e329;
                                        break if !(_e579);
                                    }
                                }
                                let _e972 = phi_2213_;
                                phi_2324_ = _e972;
                                if _e972 {
                                    break;
                                }
                                let _e974 = local_2;
                                if _e974.member_1 {
                                    let _e977 = local_3;
                                    phi_1667_ = (_e977.member.member.member_3 != 4294967295u);
                                } else {
                                    phi_1667_ = false;
                                }
                                let _e983 = phi_1667_;
                                phi_2328_ = _e972;
                                let _e1149 = local_5;
                                phi_2121_ = _e1149;
                                phi_2122_ = _e355;
                                phi_2123_ = false;
                                phi_2124_ = select(_e359, 0u, _e983);
                            } else {
                                if (_e355 >= _e62) {
                                    phi_1727_ = SlimbvhTypeL(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                } else {
                                    if (_e355 < _e62) {
                                    } else {
                                        phi_2324_ = true;
                                        break;
                                    }
                                    let _e369 = (_e157 % 3u);
                                    if (_e369 < 3u) {
                                    } else {
                                        phi_2324_ = true;
                                        break;
                                    }
                                    let _e375 = slimbvh_nodes.member[_e355].member[_e369];
                                    let _e381 = (_e156 % 3u);
                                    if (_e381 < 3u) {
                                    } else {
                                        phi_2324_ = true;
                                        break;
                                    }
                                    let _e387 = slimbvh_nodes.member[_e355].member[_e381];
                                    let _e393 = (_e158 % 3u);
                                    if (_e393 < 3u) {
                                    } else {
                                        phi_2324_ = true;
                                        break;
                                    }
                                    let _e399 = slimbvh_nodes.member[_e355].member[_e393];
                                    let _e409 = slimbvh_nodes.member[_e355].member_1;
                                    let _e413 = slimbvh_nodes.member[_e355].member_2;
                                    phi_1727_ = SlimbvhTypeL(array<vec4<f32>, 3>(vec4<f32>(_e375[0], _e375[1], _e375[2], _e375[3]), vec4<f32>(_e387[0], _e387[1], _e387[2], _e387[3]), vec4<f32>(_e399[0], _e399[1], _e399[2], _e399[3])), _e409, _e413);
                                }
                                let _e416 = phi_1727_;
                                let _e429 = ((_e416.member[0].x - _e206) * _e211);
                                let _e430 = ((_e416.member[0].y - _e206) * _e211);
                                let _e431 = ((_e416.member[0].z - _e207) * _e211);
                                let _e432 = ((_e416.member[0].w - _e207) * _e211);
                                let _e442 = ((_e416.member[1].x - _e234) * _e239);
                                let _e443 = ((_e416.member[1].y - _e234) * _e239);
                                let _e444 = ((_e416.member[1].z - _e235) * _e239);
                                let _e445 = ((_e416.member[1].w - _e235) * _e239);
                                let _e455 = ((_e416.member[2].x - _e262) * _e267);
                                let _e456 = ((_e416.member[2].y - _e262) * _e267);
                                let _e457 = ((_e416.member[2].z - _e263) * _e267);
                                let _e458 = ((_e416.member[2].w - _e263) * _e267);
                                let _e460 = select(_e457, _e455, (_e455 < _e457));
                                let _e462 = select(_e458, _e456, (_e456 < _e458));
                                let _e464 = select(_e457, _e455, (_e455 > _e457));
                                let _e466 = select(_e458, _e456, (_e456 > _e458));
                                let _e468 = select(_e431, _e429, (_e429 < _e431));
                                let _e470 = select(_e432, _e430, (_e430 < _e432));
                                let _e472 = select(_e444, _e442, (_e442 < _e444));
                                let _e474 = select(_e445, _e443, (_e443 < _e445));
                                let _e476 = select(_e472, _e468, (_e468 > _e472));
                                let _e478 = select(_e474, _e470, (_e470 > _e474));
                                let _e480 = select(_e460, _e476, (_e476 > _e460));
                                let _e482 = select(_e462, _e478, (_e478 > _e462));
                                let _e484 = select(_e431, _e429, (_e429 > _e431));
                                let _e486 = select(_e432, _e430, (_e430 > _e432));
                                let _e488 = select(_e444, _e442, (_e442 > _e444));
                                let _e490 = select(_e445, _e443, (_e443 > _e445));
                                let _e492 = select(_e488, _e484, (_e484 < _e488));
                                let _e494 = select(_e490, _e486, (_e486 < _e490));
                                let _e499 = -(_e460);
                                let _e500 = -(_e462);
                                let _e507 = (select(_e464, _e492, (_e492 < _e464)) + (select(_e499, _e464, (_e464 > _e499)) * 0.0000019073523f));
                                let _e508 = (select(_e466, _e494, (_e494 < _e466)) + (select(_e500, _e466, (_e466 > _e500)) * 0.0000019073523f));
                                let _e510 = select(_e314, _e480, (_e480 > _e314));
                                let _e512 = select(_e314, _e482, (_e482 > _e314));
                                let _e517 = (_e510 <= select(_e331.member.member_1, _e507, (_e507 < _e331.member.member_1)));
                                let _e518 = (_e512 <= select(_e331.member.member_1, _e508, (_e508 < _e331.member.member_1)));
                                let _e519 = (_e510 <= _e512);
                                if _e517 {
                                    if _e518 {
                                        if _e519 {
                                            phi_2071_ = _e416.member_2;
                                        } else {
                                            phi_2071_ = _e416.member_1;
                                        }
                                        let _e523 = phi_2071_;
                                        let _e524 = (_e359 % 128u);
                                        let _e525 = (_e524 < 128u);
                                        if _e525 {
                                        } else {
                                            phi_2324_ = true;
                                            break;
                                        }
                                        local_1[_e524] = _e523;
                                        if _e525 {
                                        } else {
                                            phi_2324_ = true;
                                            break;
                                        }
                                        local[_e524] = select(_e512, _e510, (_e510 > _e512));
                                        if _e519 {
                                            phi_2098_ = _e416.member_1;
                                        } else {
                                            phi_2098_ = _e416.member_2;
                                        }
                                        let _e534 = phi_2098_;
                                        phi_2099_ = _e534;
                                        phi_2100_ = (_e359 + 1u);
                                    } else {
                                        phi_2099_ = u32();
                                        phi_2100_ = u32();
                                    }
                                    let _e536 = phi_2099_;
                                    let _e538 = phi_2100_;
                                    phi_2102_ = _e536;
                                    phi_2103_ = _e538;
                                    phi_2104_ = select(true, false, _e518);
                                } else {
                                    phi_2102_ = u32();
                                    phi_2103_ = u32();
                                    phi_2104_ = true;
                                }
                                let _e541 = phi_2102_;
                                let _e543 = phi_2103_;
                                let _e545 = phi_2104_;
                                if _e545 {
                                    if _e517 {
                                        phi_2113_ = _e416.member_1;
                                    } else {
                                        phi_2113_ = _e416.member_2;
                                    }
                                    let _e549 = phi_2113_;
                                    phi_2118_ = _e549;
                                    phi_2119_ = select(_e518, true, _e517);
                                } else {
                                    phi_2118_ = _e541;
                                    phi_2119_ = _e357;
                                }
                                let _e552 = phi_2118_;
                                let _e554 = phi_2119_;
                                phi_2328_ = _e329;
                                phi_2121_ = _e331;
                                phi_2122_ = _e552;
                                phi_2123_ = _e554;
                                phi_2124_ = select(_e543, _e359, _e545);
                            }
                            let _e986 = phi_2328_;
                            let _e988 = phi_2121_;
                            let _e990 = phi_2122_;
                            let _e992 = phi_2123_;
                            let _e994 = phi_2124_;
                            phi_2327_ = _e986;
                            phi_2125_ = _e988;
                            phi_2126_ = _e990;
                            phi_2127_ = (_e335 - 1u);
                            phi_2128_ = _e992;
                            phi_2129_ = _e994;
                        } else {
                            phi_2327_ = _e329;
                            phi_2125_ = _e331;
                            phi_2126_ = _e355;
                            phi_2127_ = _e335;
                            phi_2128_ = _e357;
                            phi_2129_ = _e359;
                        }
                        let _e996 = phi_2327_;
                        let _e998 = phi_2125_;
                        let _e1000 = phi_2126_;
                        let _e1002 = phi_2127_;
                        let _e1004 = phi_2128_;
                        let _e1006 = phi_2129_;
                        phi_2326_ = _e996;
                        phi_2130_ = _e998;
                        phi_2131_ = _e1000;
                        phi_2132_ = _e1002;
                        phi_2133_ = _e1004;
                        phi_2134_ = _e1006;
                    } else {
                        phi_2326_ = _e329;
                        phi_2130_ = SlimbvhTypeK();
                        phi_2131_ = u32();
                        phi_2132_ = u32();
                        phi_2133_ = bool();
                        phi_2134_ = u32();
                    }
                    let _e1008 = phi_2326_;
                    let _e1010 = phi_2130_;
                    let _e1012 = phi_2131_;
                    let _e1014 = phi_2132_;
                    let _e1016 = phi_2133_;
                    let _e1018 = phi_2134_;
                    phi_2325_ = _e1008;
                    phi_846_ = _e1010;
                    phi_849_ = _e1012;
                    phi_851_ = _e1014;
                    phi_853_ = _e1016;
                    phi_855_ = _e1018;
                    phi_2135_ = _e343;
                } else {
                    phi_2325_ = _e329;
                    phi_846_ = SlimbvhTypeK();
                    phi_849_ = u32();
                    phi_851_ = u32();
                    phi_853_ = bool();
                    phi_855_ = u32();
                    phi_2135_ = false;
                }
                let _e1020 = phi_2325_;
                let _e1022 = phi_846_;
                let _e1024 = phi_849_;
                let _e1026 = phi_851_;
                let _e1028 = phi_853_;
                let _e1030 = phi_855_;
                let _e1032 = phi_2135_;
                continue;
                continuing {
                    phi_2219_ = _e1020;
                    phi_845_ = _e1022;
                    phi_848_ = _e1024;
                    phi_850_ = _e1026;
                    phi_852_ = _e1028;
                    phi_854_ = _e1030;
                    phi_2324_ = _e1020;
                    break if !(_e1032);
                }
            }
            let _e1035 = phi_2324_;
            if _e1035 {
                break;
            }
            let _e1037 = local_4;
            if (_e1037.member.member.member_3 != 4294967295u) {
                let _e1043 = -(_e281);
                let _e1044 = (_e1043 / 3i);
                let _e1051 = bitcast<f32>((bitcast<u32>((_e1044 + 127i)) << bitcast<u32>(23i)));
                let _e1059 = (((_e1037.member.member.member * _e1051) * _e1051) * bitcast<f32>((bitcast<u32>(((_e1043 - (2i * _e1044)) + 127i)) << bitcast<u32>(23i))));
                let _e1061 = select(340282350000000000000000000000000000000f, _e1059, (_e1059 < 340282350000000000000000000000000000000f));
                phi_2187_ = SlimbvhTypeE(select(-340282350000000000000000000000000000000f, _e1061, (_e1061 > -340282350000000000000000000000000000000f)), _e1037.member.member.member_1, _e1037.member.member.member_2, _e1037.member.member.member_3);
            } else {
                phi_2187_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
            }
            let _e1068 = phi_2187_;
            slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1068.member), bitcast<u32>(_e1068.member_1), bitcast<u32>(_e1068.member_2), _e1068.member_3);
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
