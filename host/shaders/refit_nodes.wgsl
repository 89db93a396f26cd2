struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: vec4<u32>,
}

struct type_15 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_24 {
    member: array<array<f32, 8>>,
}

struct type_27 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_32 {
    member: u32,
    member_1: u32,
    member_2: bool,
}

struct type_34 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(1) 
var<storage> global_2: type_17;
@group(0) @binding(2) 
var<storage> global_3: type_24;
@group(0) @binding(3) 
var<storage> global_4: type_4;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_29;

fn function_() {
    var phi_148_: u32;
    var phi_378_: type_7;
    var phi_381_: type_34;
    var phi_379_: type_7;
    var phi_404_: type_7;
    var phi_423_: type_15;
    var phi_382_: type_34;
    var phi_2060_: bool;
    var phi_582_: type_32;
    var phi_585_: type_34;
    var phi_597_: bool;
    var phi_622_: type_32;
    var phi_583_: type_32;
    var phi_625_: type_7;
    var phi_644_: type_15;
    var phi_586_: type_34;
    var phi_2090_: bool;
    var phi_815_: u32;
    var phi_818_: type_7;
    var phi_821_: u32;
    var phi_823_: u32;
    var phi_825_: u32;
    var phi_827_: u32;
    var phi_829_: type_34;
    var phi_819_: type_7;
    var phi_852_: type_7;
    var phi_880_: array<f32, 8>;
    var phi_951_: u32;
    var phi_952_: type_34;
    var phi_971_: array<f32, 8>;
    var phi_1041_: u32;
    var phi_1042_: type_34;
    var phi_1061_: u32;
    var phi_1062_: u32;
    var phi_1063_: u32;
    var phi_1064_: u32;
    var phi_1065_: u32;
    var phi_1066_: type_34;
    var phi_822_: u32;
    var phi_824_: u32;
    var phi_826_: u32;
    var phi_828_: u32;
    var phi_830_: type_34;
    var phi_1068_: bool;
    var phi_2121_: bool;
    var phi_157_: type_32;
    var phi_160_: type_34;
    var phi_172_: bool;
    var phi_197_: type_32;
    var phi_158_: type_32;
    var phi_200_: type_7;
    var phi_219_: type_15;
    var phi_161_: type_34;
    var phi_2148_: bool;
    var phi_2184_: bool;
    var phi_1069_: type_34;
    var phi_1095_: u32;
    var phi_1325_: type_7;
    var phi_1328_: type_34;
    var phi_1326_: type_7;
    var phi_1351_: type_7;
    var phi_1370_: type_15;
    var phi_1329_: type_34;
    var phi_2179_: bool;
    var phi_1529_: type_32;
    var phi_1532_: type_34;
    var phi_1544_: bool;
    var phi_1569_: type_32;
    var phi_1530_: type_32;
    var phi_1572_: type_7;
    var phi_1591_: type_15;
    var phi_1533_: type_34;
    var phi_2210_: bool;
    var phi_1762_: u32;
    var phi_1765_: type_7;
    var phi_1768_: u32;
    var phi_1770_: u32;
    var phi_1772_: u32;
    var phi_1774_: u32;
    var phi_1776_: type_34;
    var phi_1766_: type_7;
    var phi_1799_: type_7;
    var phi_1827_: array<f32, 8>;
    var phi_1898_: u32;
    var phi_1899_: type_34;
    var phi_1918_: array<f32, 8>;
    var phi_1988_: u32;
    var phi_1989_: type_34;
    var phi_2008_: u32;
    var phi_2009_: u32;
    var phi_2010_: u32;
    var phi_2011_: u32;
    var phi_2012_: u32;
    var phi_2013_: type_34;
    var phi_1769_: u32;
    var phi_1771_: u32;
    var phi_1773_: u32;
    var phi_1775_: u32;
    var phi_1777_: type_34;
    var phi_2015_: bool;
    var phi_2241_: bool;
    var phi_1104_: type_32;
    var phi_1107_: type_34;
    var phi_1119_: bool;
    var phi_1144_: type_32;
    var phi_1105_: type_32;
    var phi_1147_: type_7;
    var phi_1166_: type_15;
    var phi_1108_: type_34;
    var phi_2268_: bool;
    var phi_2016_: type_34;
    var local: type_34;
    var local_1: type_34;
    var local_2: type_34;
    var local_3: type_34;
    var local_4: type_34;
    var local_5: type_34;
    var local_6: type_34;
    var local_7: type_34;

    switch bitcast<i32>(0u) {
        default: {
            let _e32 = global;
            let _e34 = arrayLength((&global_2.member));
            let _e36 = arrayLength((&global_3.member));
            let _e44 = (_e32.x + (_e32.y * 2097152u));
            let _e47 = global_1.member[0u];
            if (_e44 < _e47) {
                let _e49 = (_e44 < arrayLength((&global_5.member)));
                if _e49 {
                    let _e50 = (_e44 < arrayLength((&global_4.member)));
                    if _e50 {
                        if _e49 {
                        } else {
                            break;
                        }
                        let _e53 = global_5.member[_e44];
                        if _e50 {
                        } else {
                            break;
                        }
                        let _e56 = global_4.member[_e44];
                        let _e58 = (_e53.member_3 / 4u);
                        if ((_e53.member_3 % 4u) > 0u) {
                            phi_148_ = (_e58 + 1u);
                        } else {
                            phi_148_ = _e58;
                        }
                        let _e63 = phi_148_;
                        let _e64 = (_e56 + 1u);
                        let _e65 = (_e64 / 4u);
                        if (_e63 >= _e65) {
                            phi_157_ = type_32(_e53.member_3, _e56, false);
                            phi_160_ = type_34(vec4<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec4<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
                            loop {
                                let _e475 = phi_157_;
                                let _e477 = phi_160_;
                                local_2 = _e477;
                                if _e475.member_2 {
                                    phi_172_ = true;
                                } else {
                                    phi_172_ = !((_e475.member <= _e475.member_1));
                                }
                                let _e484 = phi_172_;
                                if _e484 {
                                    phi_158_ = _e475;
                                    phi_200_ = type_7(0u, type_7().member_1);
                                } else {
                                    if (_e475.member < _e475.member_1) {
                                        phi_197_ = type_32((_e475.member + 1u), _e475.member_1, _e475.member_2);
                                    } else {
                                        phi_197_ = type_32(_e475.member, _e475.member_1, true);
                                    }
                                    let _e498 = phi_197_;
                                    phi_158_ = _e498;
                                    phi_200_ = type_7(1u, _e475.member);
                                }
                                let _e504 = phi_158_;
                                let _e506 = phi_200_;
                                let _e510 = (bitcast<i32>(_e506.member) != 0i);
                                if _e510 {
                                    let _e511 = (_e506.member_1 < _e34);
                                    if _e511 {
                                        if _e511 {
                                        } else {
                                            phi_2148_ = true;
                                            break;
                                        }
                                        let _e514 = global_2.member[_e506.member_1];
                                        phi_219_ = _e514;
                                    } else {
                                        phi_219_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                    }
                                    let _e516 = phi_219_;
                                    let _e528 = bitcast<f32>(_e516.member_1);
                                    let _e530 = select(_e516.member[3], _e516.member[0], (_e516.member[0] < _e516.member[3]));
                                    let _e532 = select(_e516.member[4], _e516.member[1], (_e516.member[1] < _e516.member[4]));
                                    let _e534 = select(_e516.member[5], _e516.member[2], (_e516.member[2] < _e516.member[5]));
                                    let _e536 = select(_e516.member[6], _e516.member[3], (_e516.member[3] < _e516.member[6]));
                                    let _e538 = select(_e516.member[6], _e530, (_e530 < _e516.member[6]));
                                    let _e540 = select(_e516.member[7], _e532, (_e532 < _e516.member[7]));
                                    let _e542 = select(_e516.member[8], _e534, (_e534 < _e516.member[8]));
                                    let _e544 = select(_e528, _e536, (_e536 < _e528));
                                    let _e546 = select(_e516.member[3], _e516.member[0], (_e516.member[0] > _e516.member[3]));
                                    let _e548 = select(_e516.member[4], _e516.member[1], (_e516.member[1] > _e516.member[4]));
                                    let _e550 = select(_e516.member[5], _e516.member[2], (_e516.member[2] > _e516.member[5]));
                                    let _e552 = select(_e516.member[6], _e516.member[3], (_e516.member[3] > _e516.member[6]));
                                    let _e554 = select(_e516.member[6], _e546, (_e546 > _e516.member[6]));
                                    let _e556 = select(_e516.member[7], _e548, (_e548 > _e516.member[7]));
                                    let _e558 = select(_e516.member[8], _e550, (_e550 > _e516.member[8]));
                                    let _e560 = select(_e528, _e552, (_e552 > _e528));
                                    phi_161_ = type_34(vec4<f32>(select(_e538, _e477.member.x, (_e477.member.x < _e538)), select(_e540, _e477.member.y, (_e477.member.y < _e540)), select(_e542, _e477.member.z, (_e477.member.z < _e542)), select(_e544, _e477.member.w, (_e477.member.w < _e544))), vec4<f32>(select(_e554, _e477.member_1.x, (_e477.member_1.x > _e554)), select(_e556, _e477.member_1.y, (_e477.member_1.y > _e556)), select(_e558, _e477.member_1.z, (_e477.member_1.z > _e558)), select(_e560, _e477.member_1.w, (_e477.member_1.w > _e560))));
                                } else {
                                    phi_161_ = type_34();
                                }
                                let _e591 = phi_161_;
                                continue;
                                continuing {
                                    phi_157_ = _e504;
                                    phi_160_ = _e591;
                                    phi_2148_ = false;
                                    break if !(_e510);
                                }
                            }
                            let _e594 = phi_2148_;
                            if _e594 {
                                break;
                            }
                            phi_2184_ = _e594;
                            let _e1222 = local_2;
                            phi_1069_ = _e1222;
                        } else {
                            phi_378_ = type_7(_e53.member_3, (_e63 * 4u));
                            phi_381_ = type_34(vec4<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec4<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
                            loop {
                                let _e70 = phi_378_;
                                let _e72 = phi_381_;
                                local = _e72;
                                if (_e70.member < _e70.member_1) {
                                    phi_379_ = type_7((_e70.member + 1u), _e70.member_1);
                                    phi_404_ = type_7(1u, _e70.member);
                                } else {
                                    phi_379_ = _e70;
                                    phi_404_ = type_7(0u, type_7().member_1);
                                }
                                let _e85 = phi_379_;
                                let _e87 = phi_404_;
                                let _e91 = (bitcast<i32>(_e87.member) != 0i);
                                if _e91 {
                                    let _e92 = (_e87.member_1 < _e34);
                                    if _e92 {
                                        if _e92 {
                                        } else {
                                            phi_2060_ = true;
                                            break;
                                        }
                                        let _e95 = global_2.member[_e87.member_1];
                                        phi_423_ = _e95;
                                    } else {
                                        phi_423_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                    }
                                    let _e97 = phi_423_;
                                    let _e109 = bitcast<f32>(_e97.member_1);
                                    let _e111 = select(_e97.member[3], _e97.member[0], (_e97.member[0] < _e97.member[3]));
                                    let _e113 = select(_e97.member[4], _e97.member[1], (_e97.member[1] < _e97.member[4]));
                                    let _e115 = select(_e97.member[5], _e97.member[2], (_e97.member[2] < _e97.member[5]));
                                    let _e117 = select(_e97.member[6], _e97.member[3], (_e97.member[3] < _e97.member[6]));
                                    let _e119 = select(_e97.member[6], _e111, (_e111 < _e97.member[6]));
                                    let _e121 = select(_e97.member[7], _e113, (_e113 < _e97.member[7]));
                                    let _e123 = select(_e97.member[8], _e115, (_e115 < _e97.member[8]));
                                    let _e125 = select(_e109, _e117, (_e117 < _e109));
                                    let _e127 = select(_e97.member[3], _e97.member[0], (_e97.member[0] > _e97.member[3]));
                                    let _e129 = select(_e97.member[4], _e97.member[1], (_e97.member[1] > _e97.member[4]));
                                    let _e131 = select(_e97.member[5], _e97.member[2], (_e97.member[2] > _e97.member[5]));
                                    let _e133 = select(_e97.member[6], _e97.member[3], (_e97.member[3] > _e97.member[6]));
                                    let _e135 = select(_e97.member[6], _e127, (_e127 > _e97.member[6]));
                                    let _e137 = select(_e97.member[7], _e129, (_e129 > _e97.member[7]));
                                    let _e139 = select(_e97.member[8], _e131, (_e131 > _e97.member[8]));
                                    let _e141 = select(_e109, _e133, (_e133 > _e109));
                                    phi_382_ = type_34(vec4<f32>(select(_e119, _e72.member.x, (_e72.member.x < _e119)), select(_e121, _e72.member.y, (_e72.member.y < _e121)), select(_e123, _e72.member.z, (_e72.member.z < _e123)), select(_e125, _e72.member.w, (_e72.member.w < _e125))), vec4<f32>(select(_e135, _e72.member_1.x, (_e72.member_1.x > _e135)), select(_e137, _e72.member_1.y, (_e72.member_1.y > _e137)), select(_e139, _e72.member_1.z, (_e72.member_1.z > _e139)), select(_e141, _e72.member_1.w, (_e72.member_1.w > _e141))));
                                } else {
                                    phi_382_ = type_34();
                                }
                                let _e172 = phi_382_;
                                continue;
                                continuing {
                                    phi_378_ = _e85;
                                    phi_381_ = _e172;
                                    phi_2060_ = false;
                                    break if !(_e91);
                                }
                            }
                            let _e175 = phi_2060_;
                            if _e175 {
                                break;
                            }
                            phi_582_ = type_32((_e65 * 4u), _e56, false);
                            let _e1172 = local;
                            phi_585_ = _e1172;
                            loop {
                                let _e179 = phi_582_;
                                let _e181 = phi_585_;
                                local_1 = _e181;
                                if _e179.member_2 {
                                    phi_597_ = true;
                                } else {
                                    phi_597_ = !((_e179.member <= _e179.member_1));
                                }
                                let _e188 = phi_597_;
                                if _e188 {
                                    phi_583_ = _e179;
                                    phi_625_ = type_7(0u, type_7().member_1);
                                } else {
                                    if (_e179.member < _e179.member_1) {
                                        phi_622_ = type_32((_e179.member + 1u), _e179.member_1, _e179.member_2);
                                    } else {
                                        phi_622_ = type_32(_e179.member, _e179.member_1, true);
                                    }
                                    let _e202 = phi_622_;
                                    phi_583_ = _e202;
                                    phi_625_ = type_7(1u, _e179.member);
                                }
                                let _e208 = phi_583_;
                                let _e210 = phi_625_;
                                let _e214 = (bitcast<i32>(_e210.member) != 0i);
                                if _e214 {
                                    let _e215 = (_e210.member_1 < _e34);
                                    if _e215 {
                                        if _e215 {
                                        } else {
                                            phi_2090_ = true;
                                            break;
                                        }
                                        let _e218 = global_2.member[_e210.member_1];
                                        phi_644_ = _e218;
                                    } else {
                                        phi_644_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                    }
                                    let _e220 = phi_644_;
                                    let _e232 = bitcast<f32>(_e220.member_1);
                                    let _e234 = select(_e220.member[3], _e220.member[0], (_e220.member[0] < _e220.member[3]));
                                    let _e236 = select(_e220.member[4], _e220.member[1], (_e220.member[1] < _e220.member[4]));
                                    let _e238 = select(_e220.member[5], _e220.member[2], (_e220.member[2] < _e220.member[5]));
                                    let _e240 = select(_e220.member[6], _e220.member[3], (_e220.member[3] < _e220.member[6]));
                                    let _e242 = select(_e220.member[6], _e234, (_e234 < _e220.member[6]));
                                    let _e244 = select(_e220.member[7], _e236, (_e236 < _e220.member[7]));
                                    let _e246 = select(_e220.member[8], _e238, (_e238 < _e220.member[8]));
                                    let _e248 = select(_e232, _e240, (_e240 < _e232));
                                    let _e250 = select(_e220.member[3], _e220.member[0], (_e220.member[0] > _e220.member[3]));
                                    let _e252 = select(_e220.member[4], _e220.member[1], (_e220.member[1] > _e220.member[4]));
                                    let _e254 = select(_e220.member[5], _e220.member[2], (_e220.member[2] > _e220.member[5]));
                                    let _e256 = select(_e220.member[6], _e220.member[3], (_e220.member[3] > _e220.member[6]));
                                    let _e258 = select(_e220.member[6], _e250, (_e250 > _e220.member[6]));
                                    let _e260 = select(_e220.member[7], _e252, (_e252 > _e220.member[7]));
                                    let _e262 = select(_e220.member[8], _e254, (_e254 > _e220.member[8]));
                                    let _e264 = select(_e232, _e256, (_e256 > _e232));
                                    phi_586_ = type_34(vec4<f32>(select(_e242, _e181.member.x, (_e181.member.x < _e242)), select(_e244, _e181.member.y, (_e181.member.y < _e244)), select(_e246, _e181.member.z, (_e181.member.z < _e246)), select(_e248, _e181.member.w, (_e181.member.w < _e248))), vec4<f32>(select(_e258, _e181.member_1.x, (_e181.member_1.x > _e258)), select(_e260, _e181.member_1.y, (_e181.member_1.y > _e260)), select(_e262, _e181.member_1.z, (_e181.member_1.z > _e262)), select(_e264, _e181.member_1.w, (_e181.member_1.w > _e264))));
                                } else {
                                    phi_586_ = type_34();
                                }
                                let _e295 = phi_586_;
                                continue;
                                continuing {
                                    phi_582_ = _e208;
                                    phi_585_ = _e295;
                                    phi_2090_ = _e175;
                                    break if !(_e214);
                                }
                            }
                            let _e298 = phi_2090_;
                            if _e298 {
                                break;
                            }
                            let _e299 = (_e34 / 4u);
                            if ((_e34 % 4u) > 0u) {
                                phi_815_ = (_e299 + 1u);
                            } else {
                                phi_815_ = _e299;
                            }
                            let _e304 = phi_815_;
                            phi_818_ = type_7(0u, 32u);
                            phi_821_ = _e304;
                            phi_823_ = 0u;
                            phi_825_ = _e65;
                            phi_827_ = _e63;
                            let _e1188 = local_1;
                            phi_829_ = _e1188;
                            loop {
                                let _e306 = phi_818_;
                                let _e308 = phi_821_;
                                let _e310 = phi_823_;
                                let _e312 = phi_825_;
                                let _e314 = phi_827_;
                                let _e316 = phi_829_;
                                local_3 = _e316;
                                if (_e306.member < _e306.member_1) {
                                    phi_819_ = type_7((_e306.member + 1u), _e306.member_1);
                                    phi_852_ = type_7(1u, _e306.member);
                                } else {
                                    phi_819_ = _e306;
                                    phi_852_ = type_7(0u, type_7().member_1);
                                }
                                let _e329 = phi_819_;
                                let _e331 = phi_852_;
                                if (bitcast<i32>(_e331.member) != 0i) {
                                    let _e335 = (_e314 >= _e312);
                                    if _e335 {
                                        phi_1062_ = u32();
                                        phi_1063_ = u32();
                                        phi_1064_ = u32();
                                        phi_1065_ = u32();
                                        phi_1066_ = type_34();
                                    } else {
                                        if ((_e314 & 1u) == 1u) {
                                            let _e338 = (_e310 + _e314);
                                            let _e339 = (_e338 < _e36);
                                            if _e339 {
                                                if _e339 {
                                                } else {
                                                    phi_2121_ = true;
                                                    break;
                                                }
                                                let _e342 = global_3.member[_e338];
                                                phi_880_ = _e342;
                                            } else {
                                                phi_880_ = array<f32, 8>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                                            }
                                            let _e344 = phi_880_;
                                            phi_951_ = (_e314 + 1u);
                                            phi_952_ = type_34(vec4<f32>(select(_e344[0], _e316.member.x, (_e316.member.x < _e344[0])), select(_e344[1], _e316.member.y, (_e316.member.y < _e344[1])), select(_e344[2], _e316.member.z, (_e316.member.z < _e344[2])), select(_e344[3], _e316.member.w, (_e316.member.w < _e344[3]))), vec4<f32>(select(_e344[4], _e316.member_1.x, (_e316.member_1.x > _e344[4])), select(_e344[5], _e316.member_1.y, (_e316.member_1.y > _e344[5])), select(_e344[6], _e316.member_1.z, (_e316.member_1.z > _e344[6])), select(_e344[7], _e316.member_1.w, (_e316.member_1.w > _e344[7]))));
                                        } else {
                                            phi_951_ = _e314;
                                            phi_952_ = _e316;
                                        }
                                        let _e384 = phi_951_;
                                        let _e386 = phi_952_;
                                        if ((_e312 & 1u) == 1u) {
                                            let _e389 = (_e312 - 1u);
                                            let _e390 = (_e310 + _e389);
                                            let _e391 = (_e390 < _e36);
                                            if _e391 {
                                                if _e391 {
                                                } else {
                                                    phi_2121_ = true;
                                                    break;
                                                }
                                                let _e394 = global_3.member[_e390];
                                                phi_971_ = _e394;
                                            } else {
                                                phi_971_ = array<f32, 8>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                                            }
                                            let _e396 = phi_971_;
                                            phi_1041_ = _e389;
                                            phi_1042_ = type_34(vec4<f32>(select(_e396[0], _e386.member.x, (_e386.member.x < _e396[0])), select(_e396[1], _e386.member.y, (_e386.member.y < _e396[1])), select(_e396[2], _e386.member.z, (_e386.member.z < _e396[2])), select(_e396[3], _e386.member.w, (_e386.member.w < _e396[3]))), vec4<f32>(select(_e396[4], _e386.member_1.x, (_e386.member_1.x > _e396[4])), select(_e396[5], _e386.member_1.y, (_e386.member_1.y > _e396[5])), select(_e396[6], _e386.member_1.z, (_e386.member_1.z > _e396[6])), select(_e396[7], _e386.member_1.w, (_e386.member_1.w > _e396[7]))));
                                        } else {
                                            phi_1041_ = _e312;
                                            phi_1042_ = _e386;
                                        }
                                        let _e435 = phi_1041_;
                                        let _e437 = phi_1042_;
                                        let _e441 = (_e308 / 2u);
                                        if ((_e308 % 2u) > 0u) {
                                            phi_1061_ = (_e441 + 1u);
                                        } else {
                                            phi_1061_ = _e441;
                                        }
                                        let _e446 = phi_1061_;
                                        phi_1062_ = _e446;
                                        phi_1063_ = (_e310 + _e308);
                                        phi_1064_ = (_e435 / 2u);
                                        phi_1065_ = (_e384 / 2u);
                                        phi_1066_ = _e437;
                                    }
                                    let _e448 = phi_1062_;
                                    let _e450 = phi_1063_;
                                    let _e452 = phi_1064_;
                                    let _e454 = phi_1065_;
                                    let _e456 = phi_1066_;
                                    phi_822_ = _e448;
                                    phi_824_ = _e450;
                                    phi_826_ = _e452;
                                    phi_828_ = _e454;
                                    phi_830_ = _e456;
                                    phi_1068_ = select(true, false, _e335);
                                } else {
                                    phi_822_ = u32();
                                    phi_824_ = u32();
                                    phi_826_ = u32();
                                    phi_828_ = u32();
                                    phi_830_ = type_34();
                                    phi_1068_ = false;
                                }
                                let _e459 = phi_822_;
                                let _e461 = phi_824_;
                                let _e463 = phi_826_;
                                let _e465 = phi_828_;
                                let _e467 = phi_830_;
                                let _e469 = phi_1068_;
                                continue;
                                continuing {
                                    phi_818_ = _e329;
                                    phi_821_ = _e459;
                                    phi_823_ = _e461;
                                    phi_825_ = _e463;
                                    phi_827_ = _e465;
                                    phi_829_ = _e467;
                                    phi_2121_ = _e298;
                                    break if !(_e469);
                                }
                            }
                            let _e472 = phi_2121_;
                            if _e472 {
                                break;
                            }
                            phi_2184_ = _e472;
                            let _e1224 = local_3;
                            phi_1069_ = _e1224;
                        }
                        let _e596 = phi_2184_;
                        let _e598 = phi_1069_;
                        if ((_e64 % 4u) > 0u) {
                            phi_1095_ = (_e65 + 1u);
                        } else {
                            phi_1095_ = _e65;
                        }
                        let _e612 = phi_1095_;
                        let _e614 = ((_e53.member_4 + 1u) / 4u);
                        if (_e612 >= _e614) {
                            phi_1104_ = type_32(_e64, _e53.member_4, false);
                            phi_1107_ = type_34(vec4<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec4<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
                            loop {
                                let _e1024 = phi_1104_;
                                let _e1026 = phi_1107_;
                                local_6 = _e1026;
                                if _e1024.member_2 {
                                    phi_1119_ = true;
                                } else {
                                    phi_1119_ = !((_e1024.member <= _e1024.member_1));
                                }
                                let _e1033 = phi_1119_;
                                if _e1033 {
                                    phi_1105_ = _e1024;
                                    phi_1147_ = type_7(0u, type_7().member_1);
                                } else {
                                    if (_e1024.member < _e1024.member_1) {
                                        phi_1144_ = type_32((_e1024.member + 1u), _e1024.member_1, _e1024.member_2);
                                    } else {
                                        phi_1144_ = type_32(_e1024.member, _e1024.member_1, true);
                                    }
                                    let _e1047 = phi_1144_;
                                    phi_1105_ = _e1047;
                                    phi_1147_ = type_7(1u, _e1024.member);
                                }
                                let _e1053 = phi_1105_;
                                let _e1055 = phi_1147_;
                                let _e1059 = (bitcast<i32>(_e1055.member) != 0i);
                                if _e1059 {
                                    let _e1060 = (_e1055.member_1 < _e34);
                                    if _e1060 {
                                        if _e1060 {
                                        } else {
                                            phi_2268_ = true;
                                            break;
                                        }
                                        let _e1063 = global_2.member[_e1055.member_1];
                                        phi_1166_ = _e1063;
                                    } else {
                                        phi_1166_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                    }
                                    let _e1065 = phi_1166_;
                                    let _e1077 = bitcast<f32>(_e1065.member_1);
                                    let _e1079 = select(_e1065.member[3], _e1065.member[0], (_e1065.member[0] < _e1065.member[3]));
                                    let _e1081 = select(_e1065.member[4], _e1065.member[1], (_e1065.member[1] < _e1065.member[4]));
                                    let _e1083 = select(_e1065.member[5], _e1065.member[2], (_e1065.member[2] < _e1065.member[5]));
                                    let _e1085 = select(_e1065.member[6], _e1065.member[3], (_e1065.member[3] < _e1065.member[6]));
                                    let _e1087 = select(_e1065.member[6], _e1079, (_e1079 < _e1065.member[6]));
                                    let _e1089 = select(_e1065.member[7], _e1081, (_e1081 < _e1065.member[7]));
                                    let _e1091 = select(_e1065.member[8], _e1083, (_e1083 < _e1065.member[8]));
                                    let _e1093 = select(_e1077, _e1085, (_e1085 < _e1077));
                                    let _e1095 = select(_e1065.member[3], _e1065.member[0], (_e1065.member[0] > _e1065.member[3]));
                                    let _e1097 = select(_e1065.member[4], _e1065.member[1], (_e1065.member[1] > _e1065.member[4]));
                                    let _e1099 = select(_e1065.member[5], _e1065.member[2], (_e1065.member[2] > _e1065.member[5]));
                                    let _e1101 = select(_e1065.member[6], _e1065.member[3], (_e1065.member[3] > _e1065.member[6]));
                                    let _e1103 = select(_e1065.member[6], _e1095, (_e1095 > _e1065.member[6]));
                                    let _e1105 = select(_e1065.member[7], _e1097, (_e1097 > _e1065.member[7]));
                                    let _e1107 = select(_e1065.member[8], _e1099, (_e1099 > _e1065.member[8]));
                                    let _e1109 = select(_e1077, _e1101, (_e1101 > _e1077));
                                    phi_1108_ = type_34(vec4<f32>(select(_e1087, _e1026.member.x, (_e1026.member.x < _e1087)), select(_e1089, _e1026.member.y, (_e1026.member.y < _e1089)), select(_e1091, _e1026.member.z, (_e1026.member.z < _e1091)), select(_e1093, _e1026.member.w, (_e1026.member.w < _e1093))), vec4<f32>(select(_e1103, _e1026.member_1.x, (_e1026.member_1.x > _e1103)), select(_e1105, _e1026.member_1.y, (_e1026.member_1.y > _e1105)), select(_e1107, _e1026.member_1.z, (_e1026.member_1.z > _e1107)), select(_e1109, _e1026.member_1.w, (_e1026.member_1.w > _e1109))));
                                } else {
                                    phi_1108_ = type_34();
                                }
                                let _e1140 = phi_1108_;
                                continue;
                                continuing {
                                    phi_1104_ = _e1053;
                                    phi_1107_ = _e1140;
                                    phi_2268_ = _e596;
                                    break if !(_e1059);
                                }
                            }
                            let _e1143 = phi_2268_;
                            if _e1143 {
                                break;
                            }
                            let _e1285 = local_6;
                            phi_2016_ = _e1285;
                        } else {
                            phi_1325_ = type_7(_e64, (_e612 * 4u));
                            phi_1328_ = type_34(vec4<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec4<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
                            loop {
                                let _e619 = phi_1325_;
                                let _e621 = phi_1328_;
                                local_4 = _e621;
                                if (_e619.member < _e619.member_1) {
                                    phi_1326_ = type_7((_e619.member + 1u), _e619.member_1);
                                    phi_1351_ = type_7(1u, _e619.member);
                                } else {
                                    phi_1326_ = _e619;
                                    phi_1351_ = type_7(0u, type_7().member_1);
                                }
                                let _e634 = phi_1326_;
                                let _e636 = phi_1351_;
                                let _e640 = (bitcast<i32>(_e636.member) != 0i);
                                if _e640 {
                                    let _e641 = (_e636.member_1 < _e34);
                                    if _e641 {
                                        if _e641 {
                                        } else {
                                            phi_2179_ = true;
                                            break;
                                        }
                                        let _e644 = global_2.member[_e636.member_1];
                                        phi_1370_ = _e644;
                                    } else {
                                        phi_1370_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                    }
                                    let _e646 = phi_1370_;
                                    let _e658 = bitcast<f32>(_e646.member_1);
                                    let _e660 = select(_e646.member[3], _e646.member[0], (_e646.member[0] < _e646.member[3]));
                                    let _e662 = select(_e646.member[4], _e646.member[1], (_e646.member[1] < _e646.member[4]));
                                    let _e664 = select(_e646.member[5], _e646.member[2], (_e646.member[2] < _e646.member[5]));
                                    let _e666 = select(_e646.member[6], _e646.member[3], (_e646.member[3] < _e646.member[6]));
                                    let _e668 = select(_e646.member[6], _e660, (_e660 < _e646.member[6]));
                                    let _e670 = select(_e646.member[7], _e662, (_e662 < _e646.member[7]));
                                    let _e672 = select(_e646.member[8], _e664, (_e664 < _e646.member[8]));
                                    let _e674 = select(_e658, _e666, (_e666 < _e658));
                                    let _e676 = select(_e646.member[3], _e646.member[0], (_e646.member[0] > _e646.member[3]));
                                    let _e678 = select(_e646.member[4], _e646.member[1], (_e646.member[1] > _e646.member[4]));
                                    let _e680 = select(_e646.member[5], _e646.member[2], (_e646.member[2] > _e646.member[5]));
                                    let _e682 = select(_e646.member[6], _e646.member[3], (_e646.member[3] > _e646.member[6]));
                                    let _e684 = select(_e646.member[6], _e676, (_e676 > _e646.member[6]));
                                    let _e686 = select(_e646.member[7], _e678, (_e678 > _e646.member[7]));
                                    let _e688 = select(_e646.member[8], _e680, (_e680 > _e646.member[8]));
                                    let _e690 = select(_e658, _e682, (_e682 > _e658));
                                    phi_1329_ = type_34(vec4<f32>(select(_e668, _e621.member.x, (_e621.member.x < _e668)), select(_e670, _e621.member.y, (_e621.member.y < _e670)), select(_e672, _e621.member.z, (_e621.member.z < _e672)), select(_e674, _e621.member.w, (_e621.member.w < _e674))), vec4<f32>(select(_e684, _e621.member_1.x, (_e621.member_1.x > _e684)), select(_e686, _e621.member_1.y, (_e621.member_1.y > _e686)), select(_e688, _e621.member_1.z, (_e621.member_1.z > _e688)), select(_e690, _e621.member_1.w, (_e621.member_1.w > _e690))));
                                } else {
                                    phi_1329_ = type_34();
                                }
                                let _e721 = phi_1329_;
                                continue;
                                continuing {
                                    phi_1325_ = _e634;
                                    phi_1328_ = _e721;
                                    phi_2179_ = _e596;
                                    break if !(_e640);
                                }
                            }
                            let _e724 = phi_2179_;
                            if _e724 {
                                break;
                            }
                            phi_1529_ = type_32((_e614 * 4u), _e53.member_4, false);
                            let _e1236 = local_4;
                            phi_1532_ = _e1236;
                            loop {
                                let _e728 = phi_1529_;
                                let _e730 = phi_1532_;
                                local_5 = _e730;
                                if _e728.member_2 {
                                    phi_1544_ = true;
                                } else {
                                    phi_1544_ = !((_e728.member <= _e728.member_1));
                                }
                                let _e737 = phi_1544_;
                                if _e737 {
                                    phi_1530_ = _e728;
                                    phi_1572_ = type_7(0u, type_7().member_1);
                                } else {
                                    if (_e728.member < _e728.member_1) {
                                        phi_1569_ = type_32((_e728.member + 1u), _e728.member_1, _e728.member_2);
                                    } else {
                                        phi_1569_ = type_32(_e728.member, _e728.member_1, true);
                                    }
                                    let _e751 = phi_1569_;
                                    phi_1530_ = _e751;
                                    phi_1572_ = type_7(1u, _e728.member);
                                }
                                let _e757 = phi_1530_;
                                let _e759 = phi_1572_;
                                let _e763 = (bitcast<i32>(_e759.member) != 0i);
                                if _e763 {
                                    let _e764 = (_e759.member_1 < _e34);
                                    if _e764 {
                                        if _e764 {
                                        } else {
                                            phi_2210_ = true;
                                            break;
                                        }
                                        let _e767 = global_2.member[_e759.member_1];
                                        phi_1591_ = _e767;
                                    } else {
                                        phi_1591_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                    }
                                    let _e769 = phi_1591_;
                                    let _e781 = bitcast<f32>(_e769.member_1);
                                    let _e783 = select(_e769.member[3], _e769.member[0], (_e769.member[0] < _e769.member[3]));
                                    let _e785 = select(_e769.member[4], _e769.member[1], (_e769.member[1] < _e769.member[4]));
                                    let _e787 = select(_e769.member[5], _e769.member[2], (_e769.member[2] < _e769.member[5]));
                                    let _e789 = select(_e769.member[6], _e769.member[3], (_e769.member[3] < _e769.member[6]));
                                    let _e791 = select(_e769.member[6], _e783, (_e783 < _e769.member[6]));
                                    let _e793 = select(_e769.member[7], _e785, (_e785 < _e769.member[7]));
                                    let _e795 = select(_e769.member[8], _e787, (_e787 < _e769.member[8]));
                                    let _e797 = select(_e781, _e789, (_e789 < _e781));
                                    let _e799 = select(_e769.member[3], _e769.member[0], (_e769.member[0] > _e769.member[3]));
                                    let _e801 = select(_e769.member[4], _e769.member[1], (_e769.member[1] > _e769.member[4]));
                                    let _e803 = select(_e769.member[5], _e769.member[2], (_e769.member[2] > _e769.member[5]));
                                    let _e805 = select(_e769.member[6], _e769.member[3], (_e769.member[3] > _e769.member[6]));
                                    let _e807 = select(_e769.member[6], _e799, (_e799 > _e769.member[6]));
                                    let _e809 = select(_e769.member[7], _e801, (_e801 > _e769.member[7]));
                                    let _e811 = select(_e769.member[8], _e803, (_e803 > _e769.member[8]));
                                    let _e813 = select(_e781, _e805, (_e805 > _e781));
                                    phi_1533_ = type_34(vec4<f32>(select(_e791, _e730.member.x, (_e730.member.x < _e791)), select(_e793, _e730.member.y, (_e730.member.y < _e793)), select(_e795, _e730.member.z, (_e730.member.z < _e795)), select(_e797, _e730.member.w, (_e730.member.w < _e797))), vec4<f32>(select(_e807, _e730.member_1.x, (_e730.member_1.x > _e807)), select(_e809, _e730.member_1.y, (_e730.member_1.y > _e809)), select(_e811, _e730.member_1.z, (_e730.member_1.z > _e811)), select(_e813, _e730.member_1.w, (_e730.member_1.w > _e813))));
                                } else {
                                    phi_1533_ = type_34();
                                }
                                let _e844 = phi_1533_;
                                continue;
                                continuing {
                                    phi_1529_ = _e757;
                                    phi_1532_ = _e844;
                                    phi_2210_ = _e724;
                                    break if !(_e763);
                                }
                            }
                            let _e847 = phi_2210_;
                            if _e847 {
                                break;
                            }
                            let _e848 = (_e34 / 4u);
                            if ((_e34 % 4u) > 0u) {
                                phi_1762_ = (_e848 + 1u);
                            } else {
                                phi_1762_ = _e848;
                            }
                            let _e853 = phi_1762_;
                            phi_1765_ = type_7(0u, 32u);
                            phi_1768_ = _e853;
                            phi_1770_ = 0u;
                            phi_1772_ = _e614;
                            phi_1774_ = _e612;
                            let _e1252 = local_5;
                            phi_1776_ = _e1252;
                            loop {
                                let _e855 = phi_1765_;
                                let _e857 = phi_1768_;
                                let _e859 = phi_1770_;
                                let _e861 = phi_1772_;
                                let _e863 = phi_1774_;
                                let _e865 = phi_1776_;
                                local_7 = _e865;
                                if (_e855.member < _e855.member_1) {
                                    phi_1766_ = type_7((_e855.member + 1u), _e855.member_1);
                                    phi_1799_ = type_7(1u, _e855.member);
                                } else {
                                    phi_1766_ = _e855;
                                    phi_1799_ = type_7(0u, type_7().member_1);
                                }
                                let _e878 = phi_1766_;
                                let _e880 = phi_1799_;
                                if (bitcast<i32>(_e880.member) != 0i) {
                                    let _e884 = (_e863 >= _e861);
                                    if _e884 {
                                        phi_2009_ = u32();
                                        phi_2010_ = u32();
                                        phi_2011_ = u32();
                                        phi_2012_ = u32();
                                        phi_2013_ = type_34();
                                    } else {
                                        if ((_e863 & 1u) == 1u) {
                                            let _e887 = (_e859 + _e863);
                                            let _e888 = (_e887 < _e36);
                                            if _e888 {
                                                if _e888 {
                                                } else {
                                                    phi_2241_ = true;
                                                    break;
                                                }
                                                let _e891 = global_3.member[_e887];
                                                phi_1827_ = _e891;
                                            } else {
                                                phi_1827_ = array<f32, 8>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                                            }
                                            let _e893 = phi_1827_;
                                            phi_1898_ = (_e863 + 1u);
                                            phi_1899_ = type_34(vec4<f32>(select(_e893[0], _e865.member.x, (_e865.member.x < _e893[0])), select(_e893[1], _e865.member.y, (_e865.member.y < _e893[1])), select(_e893[2], _e865.member.z, (_e865.member.z < _e893[2])), select(_e893[3], _e865.member.w, (_e865.member.w < _e893[3]))), vec4<f32>(select(_e893[4], _e865.member_1.x, (_e865.member_1.x > _e893[4])), select(_e893[5], _e865.member_1.y, (_e865.member_1.y > _e893[5])), select(_e893[6], _e865.member_1.z, (_e865.member_1.z > _e893[6])), select(_e893[7], _e865.member_1.w, (_e865.member_1.w > _e893[7]))));
                                        } else {
                                            phi_1898_ = _e863;
                                            phi_1899_ = _e865;
                                        }
                                        let _e933 = phi_1898_;
                                        let _e935 = phi_1899_;
                                        if ((_e861 & 1u) == 1u) {
                                            let _e938 = (_e861 - 1u);
                                            let _e939 = (_e859 + _e938);
                                            let _e940 = (_e939 < _e36);
                                            if _e940 {
                                                if _e940 {
                                                } else {
                                                    phi_2241_ = true;
                                                    break;
                                                }
                                                let _e943 = global_3.member[_e939];
                                                phi_1918_ = _e943;
                                            } else {
                                                phi_1918_ = array<f32, 8>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                                            }
                                            let _e945 = phi_1918_;
                                            phi_1988_ = _e938;
                                            phi_1989_ = type_34(vec4<f32>(select(_e945[0], _e935.member.x, (_e935.member.x < _e945[0])), select(_e945[1], _e935.member.y, (_e935.member.y < _e945[1])), select(_e945[2], _e935.member.z, (_e935.member.z < _e945[2])), select(_e945[3], _e935.member.w, (_e935.member.w < _e945[3]))), vec4<f32>(select(_e945[4], _e935.member_1.x, (_e935.member_1.x > _e945[4])), select(_e945[5], _e935.member_1.y, (_e935.member_1.y > _e945[5])), select(_e945[6], _e935.member_1.z, (_e935.member_1.z > _e945[6])), select(_e945[7], _e935.member_1.w, (_e935.member_1.w > _e945[7]))));
                                        } else {
                                            phi_1988_ = _e861;
                                            phi_1989_ = _e935;
                                        }
                                        let _e984 = phi_1988_;
                                        let _e986 = phi_1989_;
                                        let _e990 = (_e857 / 2u);
                                        if ((_e857 % 2u) > 0u) {
                                            phi_2008_ = (_e990 + 1u);
                                        } else {
                                            phi_2008_ = _e990;
                                        }
                                        let _e995 = phi_2008_;
                                        phi_2009_ = _e995;
                                        phi_2010_ = (_e859 + _e857);
                                        phi_2011_ = (_e984 / 2u);
                                        phi_2012_ = (_e933 / 2u);
                                        phi_2013_ = _e986;
                                    }
                                    let _e997 = phi_2009_;
                                    let _e999 = phi_2010_;
                                    let _e1001 = phi_2011_;
                                    let _e1003 = phi_2012_;
                                    let _e1005 = phi_2013_;
                                    phi_1769_ = _e997;
                                    phi_1771_ = _e999;
                                    phi_1773_ = _e1001;
                                    phi_1775_ = _e1003;
                                    phi_1777_ = _e1005;
                                    phi_2015_ = select(true, false, _e884);
                                } else {
                                    phi_1769_ = u32();
                                    phi_1771_ = u32();
                                    phi_1773_ = u32();
                                    phi_1775_ = u32();
                                    phi_1777_ = type_34();
                                    phi_2015_ = false;
                                }
                                let _e1008 = phi_1769_;
                                let _e1010 = phi_1771_;
                                let _e1012 = phi_1773_;
                                let _e1014 = phi_1775_;
                                let _e1016 = phi_1777_;
                                let _e1018 = phi_2015_;
                                continue;
                                continuing {
                                    phi_1765_ = _e878;
                                    phi_1768_ = _e1008;
                                    phi_1770_ = _e1010;
                                    phi_1772_ = _e1012;
                                    phi_1774_ = _e1014;
                                    phi_1776_ = _e1016;
                                    phi_2241_ = _e847;
                                    break if !(_e1018);
                                }
                            }
                            let _e1021 = phi_2241_;
                            if _e1021 {
                                break;
                            }
                            let _e1287 = local_7;
                            phi_2016_ = _e1287;
                        }
                        let _e1145 = phi_2016_;
                        if _e49 {
                        } else {
                            break;
                        }
                        global_5.member[_e44] = type_27(array<array<f32, 4>, 3>(array<f32, 4>(_e598.member.x, _e1145.member.x, _e598.member_1.x, _e1145.member_1.x), array<f32, 4>(_e598.member.y, _e1145.member.y, _e598.member_1.y, _e1145.member_1.y), array<f32, 4>(_e598.member.z, _e1145.member.z, _e598.member_1.z, _e1145.member_1.z)), _e53.member_1, _e53.member_2, _e53.member_3, _e53.member_4);
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn refit_nodes(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
