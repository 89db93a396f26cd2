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
    var phi_241_: i32;
    var phi_242_: i32;
    var phi_252_: bool;
    var phi_262_: u32;
    var phi_263_: u32;
    var phi_265_: bool;
    var phi_270_: u32;
    var phi_282_: i32;
    var phi_302_: i32;
    var phi_356_: f32;
    var phi_367_: f32;
    var phi_412_: f32;
    var phi_423_: f32;
    var phi_468_: f32;
    var phi_479_: f32;
    var phi_575_: f32;
    var phi_576_: f32;
    var phi_586_: SlimbvhTypeK;
    var phi_2233_: bool;
    var phi_596_: SlimbvhTypeK;
    var phi_599_: u32;
    var phi_601_: u32;
    var phi_603_: bool;
    var phi_605_: u32;
    var phi_616_: bool;
    var phi_648_: u32;
    var phi_649_: bool;
    var phi_650_: u32;
    var phi_1743_: SlimbvhTypeL;
    var phi_2087_: u32;
    var phi_2115_: u32;
    var phi_2116_: u32;
    var phi_2117_: u32;
    var phi_2119_: u32;
    var phi_2120_: u32;
    var phi_2121_: bool;
    var phi_2130_: u32;
    var phi_2135_: u32;
    var phi_2136_: bool;
    var phi_665_: SlimbvhTypeK;
    var phi_668_: SlimbvhTypeA;
    var phi_669_: SlimbvhTypeA;
    var phi_691_: SlimbvhTypeA;
    var phi_712_: u32;
    var phi_801_: array<array<f32, 3>, 3>;
    var phi_918_: bool;
    var phi_947_: bool;
    var phi_1348_: f32;
    var phi_1349_: f32;
    var phi_1350_: f32;
    var phi_1351_: f32;
    var phi_1352_: vec3<f32>;
    var phi_1353_: vec3<f32>;
    var phi_1354_: vec3<f32>;
    var phi_1355_: vec3<f32>;
    var phi_1386_: bool;
    var phi_1395_: vec3<f32>;
    var phi_1560_: f32;
    var phi_1562_: f32;
    var phi_1563_: bool;
    var phi_1583_: f32;
    var phi_1584_: f32;
    var phi_1607_: SlimbvhTypeE;
    var phi_1609_: SlimbvhTypeE;
    var phi_1610_: bool;
    var phi_1614_: SlimbvhTypeE;
    var phi_1615_: SlimbvhTypeE;
    var phi_1616_: SlimbvhTypeE;
    var phi_1617_: bool;
    var phi_1621_: SlimbvhTypeE;
    var phi_1622_: bool;
    var phi_1623_: SlimbvhTypeE;
    var phi_1624_: bool;
    var phi_1625_: bool;
    var phi_1626_: SlimbvhTypeE;
    var phi_1627_: bool;
    var phi_1628_: bool;
    var phi_1636_: SlimbvhTypeE;
    var phi_1637_: bool;
    var phi_1641_: SlimbvhTypeE;
    var phi_1666_: bool;
    var phi_1667_: bool;
    var phi_1674_: SlimbvhTypeK;
    var phi_1675_: SlimbvhTypeK;
    var phi_1676_: SlimbvhTypeK;
    var phi_666_: SlimbvhTypeK;
    var phi_2227_: bool;
    var local_2: SlimbvhTypeK;
    var local_3: SlimbvhTypeK;
    var phi_1683_: bool;
    var phi_2374_: bool;
    var phi_2138_: SlimbvhTypeK;
    var phi_2139_: u32;
    var phi_2140_: bool;
    var phi_2141_: u32;
    var phi_2373_: bool;
    var phi_2142_: SlimbvhTypeK;
    var phi_2143_: u32;
    var phi_2144_: u32;
    var phi_2145_: bool;
    var phi_2146_: u32;
    var phi_2372_: bool;
    var phi_2147_: SlimbvhTypeK;
    var phi_2148_: u32;
    var phi_2149_: u32;
    var phi_2150_: bool;
    var phi_2151_: u32;
    var phi_2371_: bool;
    var phi_597_: SlimbvhTypeK;
    var phi_600_: u32;
    var phi_602_: u32;
    var phi_604_: bool;
    var phi_606_: u32;
    var phi_2152_: bool;
    var phi_2370_: bool;
    var local_4: SlimbvhTypeK;
    var phi_2204_: SlimbvhTypeE;
    var local_5: SlimbvhTypeK;

    switch bitcast<i32>(0u) {
        default: {
            let _e66 = arrayLength((&slimbvh_nodes.member));
            let _e68 = arrayLength((&slimbvh_triangles.member));
            let _e73 = slimbvh_origin.member;
            let _e79 = slimbvh_origin.member[3u];
            let _e80 = slimbvh_direction.member;
            let _e86 = slimbvh_direction.member[3u];
            let _e89 = slimbvh_exponent.member[0u];
            let _e90 = bitcast<i32>(_e89);
            let _e92 = (bitcast<u32>(_e80.x) & 2147483647u);
            let _e94 = (bitcast<u32>(_e80.y) & 2147483647u);
            let _e96 = (bitcast<u32>(_e80.z) & 2147483647u);
            let _e98 = (bitcast<u32>(_e73.x) & 2147483647u);
            let _e100 = (bitcast<u32>(_e73.y) & 2147483647u);
            let _e102 = (bitcast<u32>(_e73.z) & 2147483647u);
            let _e104 = select(_e94, _e92, (_e94 < _e92));
            let _e106 = select(_e96, _e104, (_e96 < _e104));
            let _e108 = select(_e98, _e106, (_e98 < _e106));
            let _e110 = select(_e100, _e108, (_e100 < _e108));
            let _e112 = select(_e102, _e110, (_e102 < _e110));
            let _e114 = (bitcast<u32>(_e79) & 2147483647u);
            let _e123 = (((select(_e114, _e112, (_e114 < _e112)) < 2139095040u) && ((bitcast<u32>(_e86) & 2147483647u) <= 2139095040u)) && (_e106 > 0u));
            if _e123 {
                let _e126 = (bitcast<u32>(bitcast<f32>(_e106)) & 2147483647u);
                if (_e126 >= 8388608u) {
                    phi_241_ = (bitcast<i32>((_e126 >> bitcast<u32>(23i))) - 127i);
                } else {
                    phi_241_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e126)), 32u, (_e126 == 0u))));
                }
                let _e140 = phi_241_;
                phi_242_ = _e140;
            } else {
                phi_242_ = 0i;
            }
            let _e142 = phi_242_;
            let _e143 = (_e92 == _e106);
            if _e143 {
                phi_252_ = true;
            } else {
                phi_252_ = (_e94 == _e106);
            }
            let _e146 = phi_252_;
            let _e147 = select(1u, 0u, _e143);
            if _e146 {
                let _e148 = (_e147 + 1u);
                phi_262_ = _e148;
                phi_263_ = _e148;
                phi_265_ = select(true, false, (_e148 == 2u));
            } else {
                phi_262_ = u32();
                phi_263_ = 0u;
                phi_265_ = true;
            }
            let _e152 = phi_262_;
            let _e154 = phi_263_;
            let _e156 = phi_265_;
            if _e156 {
                phi_270_ = (_e154 + 1u);
            } else {
                phi_270_ = 0u;
            }
            let _e160 = phi_270_;
            let _e161 = select(_e152, _e154, _e156);
            let _e162 = select(_e147, select(2u, _e147, _e146), _e156);
            if (_e90 < -126i) {
                phi_282_ = -126i;
            } else {
                phi_282_ = select(_e90, 127i, (_e90 > 127i));
            }
            let _e167 = phi_282_;
            let _e172 = bitcast<f32>((bitcast<u32>((_e167 + 127i)) << bitcast<u32>(23i)));
            let _e178 = bitcast<f32>((bitcast<u32>(((_e90 - _e167) + 127i)) << bitcast<u32>(23i)));
            let _e179 = -(_e142);
            if (_e179 < -126i) {
                phi_302_ = -126i;
            } else {
                phi_302_ = select(_e179, 127i, (_e179 > 127i));
            }
            let _e184 = phi_302_;
            let _e189 = bitcast<f32>((bitcast<u32>((_e184 + 127i)) << bitcast<u32>(23i)));
            let _e195 = bitcast<f32>((bitcast<u32>(((_e179 - _e184) + 127i)) << bitcast<u32>(23i)));
            let _e196 = (_e161 == 0u);
            let _e198 = (_e161 == 2u);
            let _e201 = ((select(select(_e73.y, _e73.x, _e196), _e73.z, _e198) * _e172) * _e178);
            let _e205 = ((select(select(_e80.y, _e80.x, _e196), _e80.z, _e198) * _e189) * _e195);
            let _e209 = (bitcast<f32>((bitcast<u32>(_e205) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e209 {
                let _e213 = (bitcast<f32>((bitcast<u32>(_e201) & 2147483647u)) * 0.00000011920929f);
                phi_356_ = select(0.00000000000011368684f, _e213, (_e213 > 0.00000000000011368684f));
            } else {
                phi_356_ = 0f;
            }
            let _e217 = phi_356_;
            let _e218 = (_e201 + _e217);
            let _e219 = (_e201 - _e217);
            let _e220 = select(_e205, 0f, _e209);
            if _e209 {
                phi_367_ = 38685626000000000000000000f;
            } else {
                phi_367_ = (1f / _e205);
            }
            let _e223 = phi_367_;
            let _e224 = (_e160 == 0u);
            let _e226 = (_e160 == 2u);
            let _e229 = ((select(select(_e73.y, _e73.x, _e224), _e73.z, _e226) * _e172) * _e178);
            let _e233 = ((select(select(_e80.y, _e80.x, _e224), _e80.z, _e226) * _e189) * _e195);
            let _e237 = (bitcast<f32>((bitcast<u32>(_e233) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e237 {
                let _e241 = (bitcast<f32>((bitcast<u32>(_e229) & 2147483647u)) * 0.00000011920929f);
                phi_412_ = select(0.00000000000011368684f, _e241, (_e241 > 0.00000000000011368684f));
            } else {
                phi_412_ = 0f;
            }
            let _e245 = phi_412_;
            let _e246 = (_e229 + _e245);
            let _e247 = (_e229 - _e245);
            let _e248 = select(_e233, 0f, _e237);
            if _e237 {
                phi_423_ = 38685626000000000000000000f;
            } else {
                phi_423_ = (1f / _e233);
            }
            let _e251 = phi_423_;
            let _e252 = (_e162 == 0u);
            let _e254 = (_e162 == 2u);
            let _e257 = ((select(select(_e73.y, _e73.x, _e252), _e73.z, _e254) * _e172) * _e178);
            let _e261 = ((select(select(_e80.y, _e80.x, _e252), _e80.z, _e254) * _e189) * _e195);
            let _e265 = (bitcast<f32>((bitcast<u32>(_e261) & 2147483647u)) < 0.00000000000000000086736174f);
            if _e265 {
                let _e269 = (bitcast<f32>((bitcast<u32>(_e257) & 2147483647u)) * 0.00000011920929f);
                phi_468_ = select(0.00000000000011368684f, _e269, (_e269 > 0.00000000000011368684f));
            } else {
                phi_468_ = 0f;
            }
            let _e273 = phi_468_;
            let _e274 = (_e257 + _e273);
            let _e275 = (_e257 - _e273);
            let _e276 = select(_e261, 0f, _e265);
            if _e265 {
                phi_479_ = 38685626000000000000000000f;
            } else {
                phi_479_ = (1f / _e261);
            }
            let _e279 = phi_479_;
            let _e282 = bitcast<f32>((bitcast<u32>(_e201) & 2147483647u));
            let _e285 = bitcast<f32>((bitcast<u32>(_e229) & 2147483647u));
            let _e287 = select(_e285, _e282, (_e282 > _e285));
            let _e290 = bitcast<f32>((bitcast<u32>(_e257) & 2147483647u));
            let _e293 = (_e90 + _e142);
            if (_e123 && (select(_e290, _e287, (_e287 > _e290)) <= 1099511600000f)) {
                let _e296 = (_e293 / 3i);
                let _e303 = bitcast<f32>((bitcast<u32>((_e296 + 127i)) << bitcast<u32>(23i)));
                let _e310 = bitcast<f32>((bitcast<u32>(((_e293 - (2i * _e296)) + 127i)) << bitcast<u32>(23i)));
                let _e311 = (((_e79 * _e303) * _e303) * _e310);
                let _e313 = select(340282350000000000000000000000000000000f, _e311, (_e311 < 340282350000000000000000000000000000000f));
                let _e318 = (((_e86 * _e303) * _e303) * _e310);
                let _e320 = select(340282350000000000000000000000000000000f, _e318, (_e318 < 340282350000000000000000000000000000000f));
                phi_575_ = select(-340282350000000000000000000000000000000f, _e320, (_e320 > -340282350000000000000000000000000000000f));
                phi_576_ = select(-340282350000000000000000000000000000000f, _e313, (_e313 > -340282350000000000000000000000000000000f));
            } else {
                phi_575_ = 0f;
                phi_576_ = 1f;
            }
            let _e324 = phi_575_;
            let _e326 = phi_576_;
            let _e327 = slimbvh_any_will_do.member;
            if (_e327 == 1u) {
                phi_586_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e324), true);
            } else {
                phi_586_ = SlimbvhTypeK(SlimbvhTypeJ(SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e324), false);
            }
            let _e334 = phi_586_;
            local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
            local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
            phi_2233_ = false;
            phi_596_ = _e334;
            phi_599_ = select(0u, 2147483648u, (_e66 == 0u));
            phi_601_ = ((3u * _e66) + 1u);
            phi_603_ = (_e326 <= _e324);
            phi_605_ = 0u;
            loop {
                let _e341 = phi_2233_;
                let _e343 = phi_596_;
                let _e345 = phi_599_;
                let _e347 = phi_601_;
                let _e349 = phi_603_;
                let _e351 = phi_605_;
                local_4 = _e343;
                if _e349 {
                    phi_616_ = true;
                } else {
                    phi_616_ = (_e351 > 0u);
                }
                let _e354 = phi_616_;
                if _e354 {
                    let _e355 = (_e347 > 0u);
                    if _e355 {
                        if _e349 {
                            phi_648_ = _e345;
                            phi_649_ = _e349;
                            phi_650_ = _e351;
                        } else {
                            let _e356 = (_e351 - 1u);
                            let _e357 = (_e356 % 128u);
                            let _e358 = (_e357 < 128u);
                            if _e358 {
                            } else {
                                phi_2370_ = true;
                                break;
                            }
                            let _e360 = local_1[_e357];
                            if _e358 {
                            } else {
                                phi_2370_ = true;
                                break;
                            }
                            let _e362 = local[_e357];
                            phi_648_ = _e360;
                            phi_649_ = (_e362 <= _e343.member.member_1);
                            phi_650_ = _e356;
                        }
                        let _e367 = phi_648_;
                        let _e369 = phi_649_;
                        let _e371 = phi_650_;
                        if _e369 {
                            if ((_e367 & 2147483648u) != 0u) {
                                phi_665_ = _e343;
                                phi_668_ = SlimbvhTypeA(0u, ((_e367 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e570 = phi_665_;
                                    let _e572 = phi_668_;
                                    local_2 = _e570;
                                    local_3 = _e570;
                                    local_5 = _e570;
                                    if (_e572.member < _e572.member_1) {
                                        phi_669_ = SlimbvhTypeA((_e572.member + 1u), _e572.member_1);
                                        phi_691_ = SlimbvhTypeA(1u, _e572.member);
                                    } else {
                                        phi_669_ = _e572;
                                        phi_691_ = SlimbvhTypeA(0u, SlimbvhTypeA().member_1);
                                    }
                                    let _e585 = phi_669_;
                                    let _e587 = phi_691_;
                                    let _e591 = (bitcast<i32>(_e587.member) != 0i);
                                    if _e591 {
                                        let _e592 = ((_e367 & 268435455u) + _e587.member_1);
                                        let _e593 = (_e592 < _e68);
                                        if _e593 {
                                            if _e593 {
                                            } else {
                                                phi_2227_ = true;
                                                break;
                                            }
                                            let _e597 = slimbvh_triangles.member[_e592].member_1;
                                            phi_712_ = _e597;
                                        } else {
                                            phi_712_ = 4294967295u;
                                        }
                                        let _e599 = phi_712_;
                                        if (_e592 >= _e68) {
                                            phi_801_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                        } else {
                                            if _e593 {
                                            } else {
                                                phi_2227_ = true;
                                                break;
                                            }
                                            let _e601 = (_e161 % 3u);
                                            let _e602 = (_e160 % 3u);
                                            let _e603 = (_e162 % 3u);
                                            if (_e601 < 9u) {
                                            } else {
                                                phi_2227_ = true;
                                                break;
                                            }
                                            let _e609 = slimbvh_triangles.member[_e592].member[_e601];
                                            if (_e602 < 9u) {
                                            } else {
                                                phi_2227_ = true;
                                                break;
                                            }
                                            let _e615 = slimbvh_triangles.member[_e592].member[_e602];
                                            if (_e603 < 9u) {
                                            } else {
                                                phi_2227_ = true;
                                                break;
                                            }
                                            let _e621 = slimbvh_triangles.member[_e592].member[_e603];
                                            let _e623 = (3u + _e601);
                                            if (_e623 < 9u) {
                                            } else {
                                                phi_2227_ = true;
                                                break;
                                            }
                                            let _e629 = slimbvh_triangles.member[_e592].member[_e623];
                                            let _e630 = (3u + _e602);
                                            if (_e630 < 9u) {
                                            } else {
                                                phi_2227_ = true;
                                                break;
                                            }
                                            let _e636 = slimbvh_triangles.member[_e592].member[_e630];
                                            let _e637 = (3u + _e603);
                                            if (_e637 < 9u) {
                                            } else {
                                                phi_2227_ = true;
                                                break;
                                            }
                                            let _e643 = slimbvh_triangles.member[_e592].member[_e637];
                                            let _e645 = (6u + _e601);
                                            if (_e645 < 9u) {
                                            } else {
                                                phi_2227_ = true;
                                                break;
                                            }
                                            let _e651 = slimbvh_triangles.member[_e592].member[_e645];
                                            let _e652 = (6u + _e602);
                                            if (_e652 < 9u) {
                                            } else {
                                                phi_2227_ = true;
                                                break;
                                            }
                                            let _e658 = slimbvh_triangles.member[_e592].member[_e652];
                                            let _e659 = (6u + _e603);
                                            if (_e659 < 9u) {
                                            } else {
                                                phi_2227_ = true;
                                                break;
                                            }
                                            let _e665 = slimbvh_triangles.member[_e592].member[_e659];
                                            phi_801_ = array<array<f32, 3>, 3>(array<f32, 3>(_e609, _e615, _e621), array<f32, 3>(_e629, _e636, _e643), array<f32, 3>(_e651, _e658, _e665));
                                        }
                                        let _e669 = phi_801_;
                                        let _e678 = (_e669[0][2] - _e257);
                                        let _e681 = (((_e669[0][0] - _e201) * _e276) - (_e678 * _e220));
                                        let _e684 = (((_e669[0][1] - _e229) * _e276) - (_e678 * _e248));
                                        let _e691 = (_e669[1][2] - _e257);
                                        let _e694 = (((_e669[1][0] - _e201) * _e276) - (_e691 * _e220));
                                        let _e697 = (((_e669[1][1] - _e229) * _e276) - (_e691 * _e248));
                                        let _e704 = (_e669[2][2] - _e257);
                                        let _e707 = (((_e669[2][0] - _e201) * _e276) - (_e704 * _e220));
                                        let _e710 = (((_e669[2][1] - _e229) * _e276) - (_e704 * _e248));
                                        let _e711 = (_e707 * _e697);
                                        let _e712 = (_e710 * _e694);
                                        let _e713 = (_e681 * _e710);
                                        let _e714 = (_e684 * _e707);
                                        let _e715 = (_e694 * _e684);
                                        let _e716 = (_e697 * _e681);
                                        let _e721 = (((_e711 >= _e712) && (_e713 >= _e714)) && (_e715 >= _e716));
                                        if (_e721 || (((_e711 <= _e712) && (_e713 <= _e714)) && (_e715 <= _e716))) {
                                            let _e728 = select(-1f, 1f, _e721);
                                            let _e730 = ((_e711 - _e712) * _e728);
                                            let _e732 = select(0f, _e730, (_e730 > 0f));
                                            let _e734 = ((_e713 - _e714) * _e728);
                                            let _e736 = select(0f, _e734, (_e734 > 0f));
                                            let _e738 = ((_e715 - _e716) * _e728);
                                            let _e740 = select(0f, _e738, (_e738 > 0f));
                                            let _e742 = ((_e732 + _e736) + _e740);
                                            if (_e742 < 0.000000000000000000000000000000000000011754944f) {
                                                phi_1626_ = SlimbvhTypeE();
                                                phi_1627_ = true;
                                                phi_1628_ = false;
                                            } else {
                                                let _e745 = select(_e694, _e681, (_e681 < _e694));
                                                if (select(_e707, _e745, (_e745 < _e707)) > 0f) {
                                                    phi_918_ = true;
                                                } else {
                                                    let _e750 = select(_e694, _e681, (_e681 > _e694));
                                                    phi_918_ = (select(_e707, _e750, (_e750 > _e707)) < 0f);
                                                }
                                                let _e755 = phi_918_;
                                                if _e755 {
                                                    phi_1623_ = SlimbvhTypeE();
                                                    phi_1624_ = true;
                                                    phi_1625_ = false;
                                                } else {
                                                    let _e757 = select(_e697, _e684, (_e684 < _e697));
                                                    if (select(_e710, _e757, (_e757 < _e710)) > 0f) {
                                                        phi_947_ = true;
                                                    } else {
                                                        let _e762 = select(_e697, _e684, (_e684 > _e697));
                                                        phi_947_ = (select(_e710, _e762, (_e762 > _e710)) < 0f);
                                                    }
                                                    let _e767 = phi_947_;
                                                    if _e767 {
                                                        phi_1621_ = SlimbvhTypeE();
                                                        phi_1622_ = false;
                                                    } else {
                                                        let _e769 = select(_e669[1][0], _e669[0][0], (_e669[0][0] < _e669[1][0]));
                                                        let _e773 = select(_e669[1][0], _e669[0][0], (_e669[0][0] > _e669[1][0]));
                                                        let _e777 = select(_e669[1][1], _e669[0][1], (_e669[0][1] < _e669[1][1]));
                                                        let _e781 = select(_e669[1][1], _e669[0][1], (_e669[0][1] > _e669[1][1]));
                                                        let _e785 = select(_e669[1][2], _e669[0][2], (_e669[0][2] < _e669[1][2]));
                                                        let _e789 = select(_e669[1][2], _e669[0][2], (_e669[0][2] > _e669[1][2]));
                                                        let _e794 = ((select(_e669[2][0], _e769, (_e769 < _e669[2][0])) - _e218) * _e223);
                                                        let _e795 = ((select(_e669[2][0], _e773, (_e773 > _e669[2][0])) - _e219) * _e223);
                                                        let _e798 = ((select(_e669[2][1], _e777, (_e777 < _e669[2][1])) - _e246) * _e251);
                                                        let _e799 = ((select(_e669[2][1], _e781, (_e781 > _e669[2][1])) - _e247) * _e251);
                                                        let _e802 = ((select(_e669[2][2], _e785, (_e785 < _e669[2][2])) - _e274) * _e279);
                                                        let _e803 = ((select(_e669[2][2], _e789, (_e789 > _e669[2][2])) - _e275) * _e279);
                                                        let _e805 = select(_e803, _e802, (_e802 < _e803));
                                                        let _e807 = select(_e803, _e802, (_e802 > _e803));
                                                        let _e809 = select(_e795, _e794, (_e794 < _e795));
                                                        let _e811 = select(_e799, _e798, (_e798 < _e799));
                                                        let _e813 = select(_e811, _e809, (_e809 > _e811));
                                                        let _e815 = select(_e805, _e813, (_e813 > _e805));
                                                        let _e817 = select(_e795, _e794, (_e794 > _e795));
                                                        let _e819 = select(_e799, _e798, (_e798 > _e799));
                                                        let _e821 = select(_e819, _e817, (_e817 < _e819));
                                                        let _e823 = select(_e807, _e821, (_e821 < _e807));
                                                        let _e824 = -(_e805);
                                                        let _e830 = select(_e326, _e815, (_e815 > _e326));
                                                        if (_e830 > (_e823 + (select(_e824, _e807, (_e807 > _e824)) * 0.0000019073523f))) {
                                                            phi_1616_ = SlimbvhTypeE();
                                                            phi_1617_ = true;
                                                        } else {
                                                            let _e832 = (_e830 > _e570.member.member_1);
                                                            if _e832 {
                                                                phi_1615_ = SlimbvhTypeE();
                                                            } else {
                                                                let _e833 = vec3<f32>(_e669[0][0], _e669[0][1], _e669[0][2]);
                                                                let _e834 = vec3<f32>(_e669[1][0], _e669[1][1], _e669[1][2]);
                                                                let _e835 = vec3<f32>(_e669[2][0], _e669[2][1], _e669[2][2]);
                                                                let _e836 = (_e669[1][0] - _e669[0][0]);
                                                                let _e837 = (_e669[1][1] - _e669[0][1]);
                                                                let _e838 = (_e669[1][2] - _e669[0][2]);
                                                                let _e839 = vec3<f32>(_e836, _e837, _e838);
                                                                let _e840 = (_e669[2][0] - _e669[1][0]);
                                                                let _e841 = (_e669[2][1] - _e669[1][1]);
                                                                let _e842 = (_e669[2][2] - _e669[1][2]);
                                                                let _e843 = vec3<f32>(_e840, _e841, _e842);
                                                                let _e844 = (_e669[0][0] - _e669[2][0]);
                                                                let _e845 = (_e669[0][1] - _e669[2][1]);
                                                                let _e846 = (_e669[0][2] - _e669[2][2]);
                                                                let _e847 = vec3<f32>(_e844, _e845, _e846);
                                                                let _e850 = bitcast<f32>((bitcast<u32>(_e836) & 2147483647u));
                                                                let _e853 = bitcast<f32>((bitcast<u32>(_e837) & 2147483647u));
                                                                let _e855 = select(_e853, _e850, (_e850 > _e853));
                                                                let _e858 = bitcast<f32>((bitcast<u32>(_e838) & 2147483647u));
                                                                let _e860 = select(_e858, _e855, (_e855 > _e858));
                                                                let _e863 = bitcast<f32>((bitcast<u32>(_e840) & 2147483647u));
                                                                let _e866 = bitcast<f32>((bitcast<u32>(_e841) & 2147483647u));
                                                                let _e868 = select(_e866, _e863, (_e863 > _e866));
                                                                let _e871 = bitcast<f32>((bitcast<u32>(_e842) & 2147483647u));
                                                                let _e873 = select(_e871, _e868, (_e868 > _e871));
                                                                let _e876 = bitcast<f32>((bitcast<u32>(_e844) & 2147483647u));
                                                                let _e879 = bitcast<f32>((bitcast<u32>(_e845) & 2147483647u));
                                                                let _e881 = select(_e879, _e876, (_e876 > _e879));
                                                                let _e884 = bitcast<f32>((bitcast<u32>(_e846) & 2147483647u));
                                                                let _e886 = select(_e884, _e881, (_e881 > _e884));
                                                                let _e888 = select(_e873, _e860, (_e860 > _e873));
                                                                let _e890 = select(_e886, _e888, (_e888 > _e886));
                                                                if (_e860 == _e890) {
                                                                    phi_1348_ = _e697;
                                                                    phi_1349_ = _e694;
                                                                    phi_1350_ = _e684;
                                                                    phi_1351_ = _e681;
                                                                    phi_1352_ = _e833;
                                                                    phi_1353_ = _e847;
                                                                    phi_1354_ = _e843;
                                                                    phi_1355_ = _e839;
                                                                } else {
                                                                    let _e892 = (_e873 == _e890);
                                                                    let _e897 = vec3(_e892);
                                                                    phi_1348_ = select(_e684, _e710, _e892);
                                                                    phi_1349_ = select(_e681, _e707, _e892);
                                                                    phi_1350_ = select(_e710, _e697, _e892);
                                                                    phi_1351_ = select(_e707, _e694, _e892);
                                                                    phi_1352_ = select(_e835, _e834, _e897);
                                                                    phi_1353_ = select(_e843, _e839, _e897);
                                                                    phi_1354_ = select(_e839, _e847, _e897);
                                                                    phi_1355_ = select(_e847, _e843, _e897);
                                                                }
                                                                let _e903 = phi_1348_;
                                                                let _e905 = phi_1349_;
                                                                let _e907 = phi_1350_;
                                                                let _e909 = phi_1351_;
                                                                let _e911 = phi_1352_;
                                                                let _e913 = phi_1353_;
                                                                let _e915 = phi_1354_;
                                                                let _e917 = phi_1355_;
                                                                let _e924 = ((_e915.y * _e913.z) - (_e913.y * _e915.z));
                                                                let _e929 = ((_e915.z * _e913.x) - (_e913.z * _e915.x));
                                                                let _e932 = ((_e915.x * _e913.y) - (_e913.x * _e915.y));
                                                                if (_e732 >= _e736) {
                                                                    phi_1386_ = select(true, false, (_e732 >= _e740));
                                                                } else {
                                                                    phi_1386_ = true;
                                                                }
                                                                let _e937 = phi_1386_;
                                                                if _e937 {
                                                                    phi_1395_ = select(_e835, _e834, vec3((_e736 >= _e740)));
                                                                } else {
                                                                    phi_1395_ = _e833;
                                                                }
                                                                let _e942 = phi_1395_;
                                                                let _e953 = (((_e924 * (_e942.x - _e201)) + (_e929 * (_e942.y - _e229))) + (_e932 * (_e942.z - _e257)));
                                                                let _e958 = (((_e924 * _e220) + (_e929 * _e248)) + (_e932 * _e276));
                                                                let _e959 = (_e905 - _e909);
                                                                let _e960 = (_e903 - _e907);
                                                                let _e968 = (-(((_e909 * _e959) + (_e907 * _e960))) / ((_e959 * _e959) + (_e960 * _e960)));
                                                                let _e970 = select(1f, _e968, (_e968 < 1f));
                                                                let _e972 = select(0f, _e970, (_e970 > 0f));
                                                                let _e985 = ((_e911.x + (_e917.x * _e972)) - _e201);
                                                                let _e986 = ((_e911.y + (_e917.y * _e972)) - _e229);
                                                                let _e987 = ((_e911.z + (_e917.z * _e972)) - _e257);
                                                                let _e988 = (_e987 / _e276);
                                                                let _e1000 = bitcast<f32>((bitcast<u32>(_e985) & 2147483647u));
                                                                let _e1003 = bitcast<f32>((bitcast<u32>(_e986) & 2147483647u));
                                                                let _e1005 = select(_e1003, _e1000, (_e1000 > _e1003));
                                                                let _e1008 = bitcast<f32>((bitcast<u32>(_e987) & 2147483647u));
                                                                let _e1010 = select(_e1008, _e1005, (_e1005 > _e1008));
                                                                let _e1016 = bitcast<f32>((bitcast<u32>(_e924) & 2147483647u));
                                                                let _e1019 = bitcast<f32>((bitcast<u32>(_e929) & 2147483647u));
                                                                let _e1021 = select(_e1019, _e1016, (_e1016 > _e1019));
                                                                let _e1024 = bitcast<f32>((bitcast<u32>(_e932) & 2147483647u));
                                                                if (bitcast<f32>((bitcast<u32>(((((_e924 * _e985) + (_e929 * _e986)) + (_e932 * _e987)) - _e953)) & 2147483647u)) <= ((0.0000009536743f * select(_e890, _e1010, (_e1010 > _e890))) * select(_e1024, _e1021, (_e1021 > _e1024)))) {
                                                                    let _e1034 = bitcast<f32>((bitcast<u32>(_e915.x) & 2147483647u));
                                                                    let _e1037 = bitcast<f32>((bitcast<u32>(_e915.y) & 2147483647u));
                                                                    let _e1039 = select(_e1037, _e1034, (_e1034 > _e1037));
                                                                    let _e1042 = bitcast<f32>((bitcast<u32>(_e915.z) & 2147483647u));
                                                                    let _e1048 = bitcast<f32>((bitcast<u32>(_e913.x) & 2147483647u));
                                                                    let _e1051 = bitcast<f32>((bitcast<u32>(_e913.y) & 2147483647u));
                                                                    let _e1053 = select(_e1051, _e1048, (_e1048 > _e1051));
                                                                    let _e1056 = bitcast<f32>((bitcast<u32>(_e913.z) & 2147483647u));
                                                                    let _e1060 = (bitcast<f32>((bitcast<u32>(_e958) & 2147483647u)) > ((0.0000038146973f * select(_e1042, _e1039, (_e1039 > _e1042))) * select(_e1056, _e1053, (_e1053 > _e1056))));
                                                                    if _e1060 {
                                                                        phi_1560_ = (_e953 / _e958);
                                                                    } else {
                                                                        phi_1560_ = f32();
                                                                    }
                                                                    let _e1063 = phi_1560_;
                                                                    phi_1562_ = _e1063;
                                                                    phi_1563_ = select(true, false, _e1060);
                                                                } else {
                                                                    phi_1562_ = f32();
                                                                    phi_1563_ = true;
                                                                }
                                                                let _e1066 = phi_1562_;
                                                                let _e1068 = phi_1563_;
                                                                if _e1068 {
                                                                    let _e1076 = (((_e924 * (_e985 - (_e220 * _e988))) + (_e929 * (_e986 - (_e248 * _e988)))) / _e958);
                                                                    if (bitcast<f32>((bitcast<u32>(_e1076) & 2147483647u)) <= _e890) {
                                                                        phi_1583_ = (_e988 + _e1076);
                                                                    } else {
                                                                        phi_1583_ = _e988;
                                                                    }
                                                                    let _e1083 = phi_1583_;
                                                                    phi_1584_ = _e1083;
                                                                } else {
                                                                    phi_1584_ = _e1066;
                                                                }
                                                                let _e1085 = phi_1584_;
                                                                let _e1087 = select(_e823, _e1085, (_e1085 < _e823));
                                                                let _e1089 = select(_e815, _e1087, (_e1087 > _e815));
                                                                if (_e1089 >= _e326) {
                                                                    let _e1091 = (_e1089 <= _e570.member.member_1);
                                                                    if _e1091 {
                                                                        let _e1092 = (1f / _e742);
                                                                        phi_1607_ = SlimbvhTypeE(_e1089, (_e736 * _e1092), (_e740 * _e1092), _e599);
                                                                    } else {
                                                                        phi_1607_ = SlimbvhTypeE();
                                                                    }
                                                                    let _e1097 = phi_1607_;
                                                                    phi_1609_ = _e1097;
                                                                    phi_1610_ = select(true, false, _e1091);
                                                                } else {
                                                                    phi_1609_ = SlimbvhTypeE();
                                                                    phi_1610_ = true;
                                                                }
                                                                let _e1100 = phi_1609_;
                                                                let _e1102 = phi_1610_;
                                                                if _e1102 {
                                                                    phi_1614_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1614_ = _e1100;
                                                                }
                                                                let _e1104 = phi_1614_;
                                                                phi_1615_ = _e1104;
                                                            }
                                                            let _e1106 = phi_1615_;
                                                            phi_1616_ = _e1106;
                                                            phi_1617_ = _e832;
                                                        }
                                                        let _e1108 = phi_1616_;
                                                        let _e1110 = phi_1617_;
                                                        phi_1621_ = _e1108;
                                                        phi_1622_ = _e1110;
                                                    }
                                                    let _e1112 = phi_1621_;
                                                    let _e1114 = phi_1622_;
                                                    phi_1623_ = _e1112;
                                                    phi_1624_ = _e767;
                                                    phi_1625_ = _e1114;
                                                }
                                                let _e1116 = phi_1623_;
                                                let _e1118 = phi_1624_;
                                                let _e1120 = phi_1625_;
                                                phi_1626_ = _e1116;
                                                phi_1627_ = _e1118;
                                                phi_1628_ = _e1120;
                                            }
                                            let _e1122 = phi_1626_;
                                            let _e1124 = phi_1627_;
                                            let _e1126 = phi_1628_;
                                            phi_1636_ = _e1122;
                                            phi_1637_ = select(_e1126, true, _e1124);
                                        } else {
                                            phi_1636_ = SlimbvhTypeE();
                                            phi_1637_ = true;
                                        }
                                        let _e1129 = phi_1636_;
                                        let _e1131 = phi_1637_;
                                        if _e1131 {
                                            phi_1641_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                        } else {
                                            phi_1641_ = _e1129;
                                        }
                                        let _e1133 = phi_1641_;
                                        if (_e1133.member_3 != 4294967295u) {
                                            if (_e599 != 4294967295u) {
                                                if (_e1133.member < _e570.member.member.member) {
                                                    phi_1667_ = true;
                                                } else {
                                                    if (_e1133.member == _e570.member.member.member) {
                                                        phi_1666_ = (_e1133.member_3 < _e570.member.member.member_3);
                                                    } else {
                                                        phi_1666_ = false;
                                                    }
                                                    let _e1148 = phi_1666_;
                                                    phi_1667_ = _e1148;
                                                }
                                                let _e1150 = phi_1667_;
                                                if _e1150 {
                                                    phi_1674_ = SlimbvhTypeK(SlimbvhTypeJ(_e1133, _e1133.member), _e570.member_1);
                                                } else {
                                                    phi_1674_ = _e570;
                                                }
                                                let _e1156 = phi_1674_;
                                                phi_1675_ = _e1156;
                                            } else {
                                                phi_1675_ = _e570;
                                            }
                                            let _e1158 = phi_1675_;
                                            phi_1676_ = _e1158;
                                        } else {
                                            phi_1676_ = _e570;
                                        }
                                        let _e1160 = phi_1676_;
                                        phi_666_ = _e1160;
                                    } else {
                                        phi_666_ = SlimbvhTypeK();
                                    }
                                    let _e1162 = phi_666_;
                                    continue;
                                    continuing {
                                        phi_665_ = _e1162;
                                        phi_668_ = _e585;
                                        phi_2227_ = _e341;
                                        break if !(_e591);
                                    }
                                }
                                let _e1165 = phi_2227_;
                                phi_2370_ = _e1165;
                                if _e1165 {
                                    break;
                                }
                                let _e1167 = local_2;
                                if _e1167.member_1 {
                                    let _e1170 = local_3;
                                    phi_1683_ = (_e1170.member.member.member_3 != 4294967295u);
                                } else {
                                    phi_1683_ = false;
                                }
                                let _e1176 = phi_1683_;
                                phi_2374_ = _e1165;
                                let _e1363 = local_5;
                                phi_2138_ = _e1363;
                                phi_2139_ = _e367;
                                phi_2140_ = false;
                                phi_2141_ = select(_e371, 0u, _e1176);
                            } else {
                                if (_e367 >= _e66) {
                                    phi_1743_ = SlimbvhTypeL(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                } else {
                                    if (_e367 < _e66) {
                                    } else {
                                        phi_2370_ = true;
                                        break;
                                    }
                                    let _e381 = (_e161 % 3u);
                                    if (_e381 < 3u) {
                                    } else {
                                        phi_2370_ = true;
                                        break;
                                    }
                                    let _e387 = slimbvh_nodes.member[_e367].member[_e381];
                                    let _e393 = (_e160 % 3u);
                                    if (_e393 < 3u) {
                                    } else {
                                        phi_2370_ = true;
                                        break;
                                    }
                                    let _e399 = slimbvh_nodes.member[_e367].member[_e393];
                                    let _e405 = (_e162 % 3u);
                                    if (_e405 < 3u) {
                                    } else {
                                        phi_2370_ = true;
                                        break;
                                    }
                                    let _e411 = slimbvh_nodes.member[_e367].member[_e405];
                                    let _e421 = slimbvh_nodes.member[_e367].member_1;
                                    let _e425 = slimbvh_nodes.member[_e367].member_2;
                                    phi_1743_ = SlimbvhTypeL(array<vec4<f32>, 3>(vec4<f32>(_e387[0], _e387[1], _e387[2], _e387[3]), vec4<f32>(_e399[0], _e399[1], _e399[2], _e399[3]), vec4<f32>(_e411[0], _e411[1], _e411[2], _e411[3])), _e421, _e425);
                                }
                                let _e428 = phi_1743_;
                                let _e441 = ((_e428.member[0].x - _e218) * _e223);
                                let _e442 = ((_e428.member[0].y - _e218) * _e223);
                                let _e443 = ((_e428.member[0].z - _e219) * _e223);
                                let _e444 = ((_e428.member[0].w - _e219) * _e223);
                                let _e454 = ((_e428.member[1].x - _e246) * _e251);
                                let _e455 = ((_e428.member[1].y - _e246) * _e251);
                                let _e456 = ((_e428.member[1].z - _e247) * _e251);
                                let _e457 = ((_e428.member[1].w - _e247) * _e251);
                                let _e467 = ((_e428.member[2].x - _e274) * _e279);
                                let _e468 = ((_e428.member[2].y - _e274) * _e279);
                                let _e469 = ((_e428.member[2].z - _e275) * _e279);
                                let _e470 = ((_e428.member[2].w - _e275) * _e279);
                                let _e472 = select(_e469, _e467, (_e467 < _e469));
                                let _e474 = select(_e470, _e468, (_e468 < _e470));
                                let _e476 = select(_e469, _e467, (_e467 > _e469));
                                let _e478 = select(_e470, _e468, (_e468 > _e470));
                                let _e480 = select(_e443, _e441, (_e441 < _e443));
                                let _e482 = select(_e444, _e442, (_e442 < _e444));
                                let _e484 = select(_e456, _e454, (_e454 < _e456));
                                let _e486 = select(_e457, _e455, (_e455 < _e457));
                                let _e488 = select(_e484, _e480, (_e480 > _e484));
                                let _e490 = select(_e486, _e482, (_e482 > _e486));
                                let _e492 = select(_e472, _e488, (_e488 > _e472));
                                let _e494 = select(_e474, _e490, (_e490 > _e474));
                                let _e496 = select(_e443, _e441, (_e441 > _e443));
                                let _e498 = select(_e444, _e442, (_e442 > _e444));
                                let _e500 = select(_e456, _e454, (_e454 > _e456));
                                let _e502 = select(_e457, _e455, (_e455 > _e457));
                                let _e504 = select(_e500, _e496, (_e496 < _e500));
                                let _e506 = select(_e502, _e498, (_e498 < _e502));
                                let _e511 = -(_e472);
                                let _e512 = -(_e474);
                                let _e519 = (select(_e476, _e504, (_e504 < _e476)) + (select(_e511, _e476, (_e476 > _e511)) * 0.0000019073523f));
                                let _e520 = (select(_e478, _e506, (_e506 < _e478)) + (select(_e512, _e478, (_e478 > _e512)) * 0.0000019073523f));
                                let _e522 = select(_e326, _e492, (_e492 > _e326));
                                let _e524 = select(_e326, _e494, (_e494 > _e326));
                                let _e529 = (_e522 <= select(_e343.member.member_1, _e519, (_e519 < _e343.member.member_1)));
                                let _e530 = (_e524 <= select(_e343.member.member_1, _e520, (_e520 < _e343.member.member_1)));
                                let _e531 = (_e522 <= _e524);
                                if _e529 {
                                    if _e530 {
                                        if _e531 {
                                            phi_2087_ = _e428.member_2;
                                        } else {
                                            phi_2087_ = _e428.member_1;
                                        }
                                        let _e535 = phi_2087_;
                                        let _e538 = (_e371 % 128u);
                                        let _e539 = (_e538 < 128u);
                                        if _e539 {
                                        } else {
                                            phi_2370_ = true;
                                            break;
                                        }
                                        local_1[_e538] = _e535;
                                        if _e539 {
                                        } else {
                                            phi_2370_ = true;
                                            break;
                                        }
                                        local[_e538] = select(_e524, _e522, (_e522 > _e524));
                                        if _e531 {
                                            phi_2115_ = _e428.member_1;
                                        } else {
                                            phi_2115_ = _e428.member_2;
                                        }
                                        let _e546 = phi_2115_;
                                        phi_2116_ = _e546;
                                        phi_2117_ = (_e371 + 1u);
                                    } else {
                                        phi_2116_ = u32();
                                        phi_2117_ = u32();
                                    }
                                    let _e548 = phi_2116_;
                                    let _e550 = phi_2117_;
                                    phi_2119_ = _e548;
                                    phi_2120_ = _e550;
                                    phi_2121_ = select(true, false, _e530);
                                } else {
                                    phi_2119_ = u32();
                                    phi_2120_ = u32();
                                    phi_2121_ = true;
                                }
                                let _e553 = phi_2119_;
                                let _e555 = phi_2120_;
                                let _e557 = phi_2121_;
                                if _e557 {
                                    if _e529 {
                                        phi_2130_ = _e428.member_1;
                                    } else {
                                        phi_2130_ = _e428.member_2;
                                    }
                                    let _e561 = phi_2130_;
                                    phi_2135_ = _e561;
                                    phi_2136_ = select(_e530, true, _e529);
                                } else {
                                    phi_2135_ = _e553;
                                    phi_2136_ = _e369;
                                }
                                let _e564 = phi_2135_;
                                let _e566 = phi_2136_;
                                phi_2374_ = _e341;
                                phi_2138_ = _e343;
                                phi_2139_ = _e564;
                                phi_2140_ = _e566;
                                phi_2141_ = select(_e555, _e371, _e557);
                            }
                            let _e1179 = phi_2374_;
                            let _e1181 = phi_2138_;
                            let _e1183 = phi_2139_;
                            let _e1185 = phi_2140_;
                            let _e1187 = phi_2141_;
                            phi_2373_ = _e1179;
                            phi_2142_ = _e1181;
                            phi_2143_ = _e1183;
                            phi_2144_ = (_e347 - 1u);
                            phi_2145_ = _e1185;
                            phi_2146_ = _e1187;
                        } else {
                            phi_2373_ = _e341;
                            phi_2142_ = _e343;
                            phi_2143_ = _e367;
                            phi_2144_ = _e347;
                            phi_2145_ = _e369;
                            phi_2146_ = _e371;
                        }
                        let _e1189 = phi_2373_;
                        let _e1191 = phi_2142_;
                        let _e1193 = phi_2143_;
                        let _e1195 = phi_2144_;
                        let _e1197 = phi_2145_;
                        let _e1199 = phi_2146_;
                        phi_2372_ = _e1189;
                        phi_2147_ = _e1191;
                        phi_2148_ = _e1193;
                        phi_2149_ = _e1195;
                        phi_2150_ = _e1197;
                        phi_2151_ = _e1199;
                    } else {
                        phi_2372_ = _e341;
                        phi_2147_ = SlimbvhTypeK();
                        phi_2148_ = u32();
                        phi_2149_ = u32();
                        phi_2150_ = bool();
                        phi_2151_ = u32();
                    }
                    let _e1201 = phi_2372_;
                    let _e1203 = phi_2147_;
                    let _e1205 = phi_2148_;
                    let _e1207 = phi_2149_;
                    let _e1209 = phi_2150_;
                    let _e1211 = phi_2151_;
                    phi_2371_ = _e1201;
                    phi_597_ = _e1203;
                    phi_600_ = _e1205;
                    phi_602_ = _e1207;
                    phi_604_ = _e1209;
                    phi_606_ = _e1211;
                    phi_2152_ = _e355;
                } else {
                    phi_2371_ = _e341;
                    phi_597_ = SlimbvhTypeK();
                    phi_600_ = u32();
                    phi_602_ = u32();
                    phi_604_ = bool();
                    phi_606_ = u32();
                    phi_2152_ = false;
                }
                let _e1213 = phi_2371_;
                let _e1215 = phi_597_;
                let _e1217 = phi_600_;
                let _e1219 = phi_602_;
                let _e1221 = phi_604_;
                let _e1223 = phi_606_;
                let _e1225 = phi_2152_;
                continue;
                continuing {
                    phi_2233_ = _e1213;
                    phi_596_ = _e1215;
                    phi_599_ = _e1217;
                    phi_601_ = _e1219;
                    phi_603_ = _e1221;
                    phi_605_ = _e1223;
                    phi_2370_ = _e1213;
                    break if !(_e1225);
                }
            }
            let _e1228 = phi_2370_;
            if _e1228 {
                break;
            }
            let _e1230 = local_4;
            if (_e1230.member.member.member_3 != 4294967295u) {
                let _e1236 = -(_e293);
                let _e1237 = (_e1236 / 3i);
                let _e1244 = bitcast<f32>((bitcast<u32>((_e1237 + 127i)) << bitcast<u32>(23i)));
                let _e1252 = (((_e1230.member.member.member * _e1244) * _e1244) * bitcast<f32>((bitcast<u32>(((_e1236 - (2i * _e1237)) + 127i)) << bitcast<u32>(23i))));
                let _e1254 = select(340282350000000000000000000000000000000f, _e1252, (_e1252 < 340282350000000000000000000000000000000f));
                phi_2204_ = SlimbvhTypeE(select(-340282350000000000000000000000000000000f, _e1254, (_e1254 > -340282350000000000000000000000000000000f)), _e1230.member.member.member_1, _e1230.member.member.member_2, _e1230.member.member.member_3);
            } else {
                phi_2204_ = SlimbvhTypeE(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
            }
            let _e1261 = phi_2204_;
            slimbvh_hit.member = vec4<u32>(bitcast<u32>(_e1261.member), bitcast<u32>(_e1261.member_1), bitcast<u32>(_e1261.member_2), _e1261.member_3);
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
