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
    var phi_154_: u32;
    var phi_384_: type_7;
    var phi_387_: type_34;
    var phi_385_: type_7;
    var phi_410_: type_7;
    var phi_429_: type_15;
    var phi_388_: type_34;
    var phi_2067_: bool;
    var phi_588_: type_32;
    var phi_591_: type_34;
    var phi_603_: bool;
    var phi_628_: type_32;
    var phi_589_: type_32;
    var phi_631_: type_7;
    var phi_650_: type_15;
    var phi_592_: type_34;
    var phi_2097_: bool;
    var phi_821_: u32;
    var phi_824_: type_7;
    var phi_827_: u32;
    var phi_829_: u32;
    var phi_831_: u32;
    var phi_833_: u32;
    var phi_835_: type_34;
    var phi_825_: type_7;
    var phi_858_: type_7;
    var phi_886_: array<f32, 8>;
    var phi_957_: u32;
    var phi_958_: type_34;
    var phi_977_: array<f32, 8>;
    var phi_1047_: u32;
    var phi_1048_: type_34;
    var phi_1067_: u32;
    var phi_1068_: u32;
    var phi_1069_: u32;
    var phi_1070_: u32;
    var phi_1071_: u32;
    var phi_1072_: type_34;
    var phi_828_: u32;
    var phi_830_: u32;
    var phi_832_: u32;
    var phi_834_: u32;
    var phi_836_: type_34;
    var phi_1074_: bool;
    var phi_2128_: bool;
    var phi_163_: type_32;
    var phi_166_: type_34;
    var phi_178_: bool;
    var phi_203_: type_32;
    var phi_164_: type_32;
    var phi_206_: type_7;
    var phi_225_: type_15;
    var phi_167_: type_34;
    var phi_2155_: bool;
    var phi_2191_: bool;
    var phi_1075_: type_34;
    var phi_1101_: u32;
    var phi_1331_: type_7;
    var phi_1334_: type_34;
    var phi_1332_: type_7;
    var phi_1357_: type_7;
    var phi_1376_: type_15;
    var phi_1335_: type_34;
    var phi_2186_: bool;
    var phi_1535_: type_32;
    var phi_1538_: type_34;
    var phi_1550_: bool;
    var phi_1575_: type_32;
    var phi_1536_: type_32;
    var phi_1578_: type_7;
    var phi_1597_: type_15;
    var phi_1539_: type_34;
    var phi_2217_: bool;
    var phi_1768_: u32;
    var phi_1771_: type_7;
    var phi_1774_: u32;
    var phi_1776_: u32;
    var phi_1778_: u32;
    var phi_1780_: u32;
    var phi_1782_: type_34;
    var phi_1772_: type_7;
    var phi_1805_: type_7;
    var phi_1833_: array<f32, 8>;
    var phi_1904_: u32;
    var phi_1905_: type_34;
    var phi_1924_: array<f32, 8>;
    var phi_1994_: u32;
    var phi_1995_: type_34;
    var phi_2014_: u32;
    var phi_2015_: u32;
    var phi_2016_: u32;
    var phi_2017_: u32;
    var phi_2018_: u32;
    var phi_2019_: type_34;
    var phi_1775_: u32;
    var phi_1777_: u32;
    var phi_1779_: u32;
    var phi_1781_: u32;
    var phi_1783_: type_34;
    var phi_2021_: bool;
    var phi_2248_: bool;
    var phi_1110_: type_32;
    var phi_1113_: type_34;
    var phi_1125_: bool;
    var phi_1150_: type_32;
    var phi_1111_: type_32;
    var phi_1153_: type_7;
    var phi_1172_: type_15;
    var phi_1114_: type_34;
    var phi_2275_: bool;
    var phi_2022_: type_34;
    var phi_2040_: type_27;
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
            let _e33 = global;
            let _e35 = arrayLength((&global_2.member));
            let _e37 = arrayLength((&global_3.member));
            let _e45 = (_e33.x + (_e33.y * 2097152u));
            let _e48 = global_1.member[0u];
            if (_e45 < _e48) {
                let _e50 = (_e45 < arrayLength((&global_5.member)));
                if _e50 {
                    let _e51 = (_e45 < arrayLength((&global_4.member)));
                    if _e51 {
                        if _e50 {
                        } else {
                            break;
                        }
                        let _e54 = global_5.member[_e45];
                        if _e51 {
                        } else {
                            break;
                        }
                        let _e57 = global_4.member[_e45];
                        if (_e54.member_1 == 2147483648u) {
                            phi_2040_ = _e54;
                        } else {
                            let _e61 = (_e54.member_3 / 8u);
                            if ((_e54.member_3 % 8u) > 0u) {
                                phi_154_ = (_e61 + 1u);
                            } else {
                                phi_154_ = _e61;
                            }
                            let _e66 = phi_154_;
                            let _e67 = (_e57 + 1u);
                            let _e68 = (_e67 / 8u);
                            if (_e66 >= _e68) {
                                phi_163_ = type_32(_e54.member_3, _e57, false);
                                phi_166_ = type_34(vec4<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec4<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
                                loop {
                                    let _e478 = phi_163_;
                                    let _e480 = phi_166_;
                                    local_2 = _e480;
                                    if _e478.member_2 {
                                        phi_178_ = true;
                                    } else {
                                        phi_178_ = !((_e478.member <= _e478.member_1));
                                    }
                                    let _e487 = phi_178_;
                                    if _e487 {
                                        phi_164_ = _e478;
                                        phi_206_ = type_7(0u, type_7().member_1);
                                    } else {
                                        if (_e478.member < _e478.member_1) {
                                            phi_203_ = type_32((_e478.member + 1u), _e478.member_1, _e478.member_2);
                                        } else {
                                            phi_203_ = type_32(_e478.member, _e478.member_1, true);
                                        }
                                        let _e501 = phi_203_;
                                        phi_164_ = _e501;
                                        phi_206_ = type_7(1u, _e478.member);
                                    }
                                    let _e507 = phi_164_;
                                    let _e509 = phi_206_;
                                    let _e513 = (bitcast<i32>(_e509.member) != 0i);
                                    if _e513 {
                                        let _e514 = (_e509.member_1 < _e35);
                                        if _e514 {
                                            if _e514 {
                                            } else {
                                                phi_2155_ = true;
                                                break;
                                            }
                                            let _e517 = global_2.member[_e509.member_1];
                                            phi_225_ = _e517;
                                        } else {
                                            phi_225_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                        }
                                        let _e519 = phi_225_;
                                        let _e531 = bitcast<f32>(_e519.member_1);
                                        let _e533 = select(_e519.member[3], _e519.member[0], (_e519.member[0] < _e519.member[3]));
                                        let _e535 = select(_e519.member[4], _e519.member[1], (_e519.member[1] < _e519.member[4]));
                                        let _e537 = select(_e519.member[5], _e519.member[2], (_e519.member[2] < _e519.member[5]));
                                        let _e539 = select(_e519.member[6], _e519.member[3], (_e519.member[3] < _e519.member[6]));
                                        let _e541 = select(_e519.member[6], _e533, (_e533 < _e519.member[6]));
                                        let _e543 = select(_e519.member[7], _e535, (_e535 < _e519.member[7]));
                                        let _e545 = select(_e519.member[8], _e537, (_e537 < _e519.member[8]));
                                        let _e547 = select(_e531, _e539, (_e539 < _e531));
                                        let _e549 = select(_e519.member[3], _e519.member[0], (_e519.member[0] > _e519.member[3]));
                                        let _e551 = select(_e519.member[4], _e519.member[1], (_e519.member[1] > _e519.member[4]));
                                        let _e553 = select(_e519.member[5], _e519.member[2], (_e519.member[2] > _e519.member[5]));
                                        let _e555 = select(_e519.member[6], _e519.member[3], (_e519.member[3] > _e519.member[6]));
                                        let _e557 = select(_e519.member[6], _e549, (_e549 > _e519.member[6]));
                                        let _e559 = select(_e519.member[7], _e551, (_e551 > _e519.member[7]));
                                        let _e561 = select(_e519.member[8], _e553, (_e553 > _e519.member[8]));
                                        let _e563 = select(_e531, _e555, (_e555 > _e531));
                                        phi_167_ = type_34(vec4<f32>(select(_e541, _e480.member.x, (_e480.member.x < _e541)), select(_e543, _e480.member.y, (_e480.member.y < _e543)), select(_e545, _e480.member.z, (_e480.member.z < _e545)), select(_e547, _e480.member.w, (_e480.member.w < _e547))), vec4<f32>(select(_e557, _e480.member_1.x, (_e480.member_1.x > _e557)), select(_e559, _e480.member_1.y, (_e480.member_1.y > _e559)), select(_e561, _e480.member_1.z, (_e480.member_1.z > _e561)), select(_e563, _e480.member_1.w, (_e480.member_1.w > _e563))));
                                    } else {
                                        phi_167_ = type_34();
                                    }
                                    let _e594 = phi_167_;
                                    continue;
                                    continuing {
                                        phi_163_ = _e507;
                                        phi_166_ = _e594;
                                        phi_2155_ = false;
                                        break if !(_e513);
                                    }
                                }
                                let _e597 = phi_2155_;
                                if _e597 {
                                    break;
                                }
                                phi_2191_ = _e597;
                                let _e1226 = local_2;
                                phi_1075_ = _e1226;
                            } else {
                                phi_384_ = type_7(_e54.member_3, (_e66 * 8u));
                                phi_387_ = type_34(vec4<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec4<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
                                loop {
                                    let _e73 = phi_384_;
                                    let _e75 = phi_387_;
                                    local = _e75;
                                    if (_e73.member < _e73.member_1) {
                                        phi_385_ = type_7((_e73.member + 1u), _e73.member_1);
                                        phi_410_ = type_7(1u, _e73.member);
                                    } else {
                                        phi_385_ = _e73;
                                        phi_410_ = type_7(0u, type_7().member_1);
                                    }
                                    let _e88 = phi_385_;
                                    let _e90 = phi_410_;
                                    let _e94 = (bitcast<i32>(_e90.member) != 0i);
                                    if _e94 {
                                        let _e95 = (_e90.member_1 < _e35);
                                        if _e95 {
                                            if _e95 {
                                            } else {
                                                phi_2067_ = true;
                                                break;
                                            }
                                            let _e98 = global_2.member[_e90.member_1];
                                            phi_429_ = _e98;
                                        } else {
                                            phi_429_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                        }
                                        let _e100 = phi_429_;
                                        let _e112 = bitcast<f32>(_e100.member_1);
                                        let _e114 = select(_e100.member[3], _e100.member[0], (_e100.member[0] < _e100.member[3]));
                                        let _e116 = select(_e100.member[4], _e100.member[1], (_e100.member[1] < _e100.member[4]));
                                        let _e118 = select(_e100.member[5], _e100.member[2], (_e100.member[2] < _e100.member[5]));
                                        let _e120 = select(_e100.member[6], _e100.member[3], (_e100.member[3] < _e100.member[6]));
                                        let _e122 = select(_e100.member[6], _e114, (_e114 < _e100.member[6]));
                                        let _e124 = select(_e100.member[7], _e116, (_e116 < _e100.member[7]));
                                        let _e126 = select(_e100.member[8], _e118, (_e118 < _e100.member[8]));
                                        let _e128 = select(_e112, _e120, (_e120 < _e112));
                                        let _e130 = select(_e100.member[3], _e100.member[0], (_e100.member[0] > _e100.member[3]));
                                        let _e132 = select(_e100.member[4], _e100.member[1], (_e100.member[1] > _e100.member[4]));
                                        let _e134 = select(_e100.member[5], _e100.member[2], (_e100.member[2] > _e100.member[5]));
                                        let _e136 = select(_e100.member[6], _e100.member[3], (_e100.member[3] > _e100.member[6]));
                                        let _e138 = select(_e100.member[6], _e130, (_e130 > _e100.member[6]));
                                        let _e140 = select(_e100.member[7], _e132, (_e132 > _e100.member[7]));
                                        let _e142 = select(_e100.member[8], _e134, (_e134 > _e100.member[8]));
                                        let _e144 = select(_e112, _e136, (_e136 > _e112));
                                        phi_388_ = type_34(vec4<f32>(select(_e122, _e75.member.x, (_e75.member.x < _e122)), select(_e124, _e75.member.y, (_e75.member.y < _e124)), select(_e126, _e75.member.z, (_e75.member.z < _e126)), select(_e128, _e75.member.w, (_e75.member.w < _e128))), vec4<f32>(select(_e138, _e75.member_1.x, (_e75.member_1.x > _e138)), select(_e140, _e75.member_1.y, (_e75.member_1.y > _e140)), select(_e142, _e75.member_1.z, (_e75.member_1.z > _e142)), select(_e144, _e75.member_1.w, (_e75.member_1.w > _e144))));
                                    } else {
                                        phi_388_ = type_34();
                                    }
                                    let _e175 = phi_388_;
                                    continue;
                                    continuing {
                                        phi_384_ = _e88;
                                        phi_387_ = _e175;
                                        phi_2067_ = false;
                                        break if !(_e94);
                                    }
                                }
                                let _e178 = phi_2067_;
                                if _e178 {
                                    break;
                                }
                                phi_588_ = type_32((_e68 * 8u), _e57, false);
                                let _e1176 = local;
                                phi_591_ = _e1176;
                                loop {
                                    let _e182 = phi_588_;
                                    let _e184 = phi_591_;
                                    local_1 = _e184;
                                    if _e182.member_2 {
                                        phi_603_ = true;
                                    } else {
                                        phi_603_ = !((_e182.member <= _e182.member_1));
                                    }
                                    let _e191 = phi_603_;
                                    if _e191 {
                                        phi_589_ = _e182;
                                        phi_631_ = type_7(0u, type_7().member_1);
                                    } else {
                                        if (_e182.member < _e182.member_1) {
                                            phi_628_ = type_32((_e182.member + 1u), _e182.member_1, _e182.member_2);
                                        } else {
                                            phi_628_ = type_32(_e182.member, _e182.member_1, true);
                                        }
                                        let _e205 = phi_628_;
                                        phi_589_ = _e205;
                                        phi_631_ = type_7(1u, _e182.member);
                                    }
                                    let _e211 = phi_589_;
                                    let _e213 = phi_631_;
                                    let _e217 = (bitcast<i32>(_e213.member) != 0i);
                                    if _e217 {
                                        let _e218 = (_e213.member_1 < _e35);
                                        if _e218 {
                                            if _e218 {
                                            } else {
                                                phi_2097_ = true;
                                                break;
                                            }
                                            let _e221 = global_2.member[_e213.member_1];
                                            phi_650_ = _e221;
                                        } else {
                                            phi_650_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                        }
                                        let _e223 = phi_650_;
                                        let _e235 = bitcast<f32>(_e223.member_1);
                                        let _e237 = select(_e223.member[3], _e223.member[0], (_e223.member[0] < _e223.member[3]));
                                        let _e239 = select(_e223.member[4], _e223.member[1], (_e223.member[1] < _e223.member[4]));
                                        let _e241 = select(_e223.member[5], _e223.member[2], (_e223.member[2] < _e223.member[5]));
                                        let _e243 = select(_e223.member[6], _e223.member[3], (_e223.member[3] < _e223.member[6]));
                                        let _e245 = select(_e223.member[6], _e237, (_e237 < _e223.member[6]));
                                        let _e247 = select(_e223.member[7], _e239, (_e239 < _e223.member[7]));
                                        let _e249 = select(_e223.member[8], _e241, (_e241 < _e223.member[8]));
                                        let _e251 = select(_e235, _e243, (_e243 < _e235));
                                        let _e253 = select(_e223.member[3], _e223.member[0], (_e223.member[0] > _e223.member[3]));
                                        let _e255 = select(_e223.member[4], _e223.member[1], (_e223.member[1] > _e223.member[4]));
                                        let _e257 = select(_e223.member[5], _e223.member[2], (_e223.member[2] > _e223.member[5]));
                                        let _e259 = select(_e223.member[6], _e223.member[3], (_e223.member[3] > _e223.member[6]));
                                        let _e261 = select(_e223.member[6], _e253, (_e253 > _e223.member[6]));
                                        let _e263 = select(_e223.member[7], _e255, (_e255 > _e223.member[7]));
                                        let _e265 = select(_e223.member[8], _e257, (_e257 > _e223.member[8]));
                                        let _e267 = select(_e235, _e259, (_e259 > _e235));
                                        phi_592_ = type_34(vec4<f32>(select(_e245, _e184.member.x, (_e184.member.x < _e245)), select(_e247, _e184.member.y, (_e184.member.y < _e247)), select(_e249, _e184.member.z, (_e184.member.z < _e249)), select(_e251, _e184.member.w, (_e184.member.w < _e251))), vec4<f32>(select(_e261, _e184.member_1.x, (_e184.member_1.x > _e261)), select(_e263, _e184.member_1.y, (_e184.member_1.y > _e263)), select(_e265, _e184.member_1.z, (_e184.member_1.z > _e265)), select(_e267, _e184.member_1.w, (_e184.member_1.w > _e267))));
                                    } else {
                                        phi_592_ = type_34();
                                    }
                                    let _e298 = phi_592_;
                                    continue;
                                    continuing {
                                        phi_588_ = _e211;
                                        phi_591_ = _e298;
                                        phi_2097_ = _e178;
                                        break if !(_e217);
                                    }
                                }
                                let _e301 = phi_2097_;
                                if _e301 {
                                    break;
                                }
                                let _e302 = (_e35 / 8u);
                                if ((_e35 % 8u) > 0u) {
                                    phi_821_ = (_e302 + 1u);
                                } else {
                                    phi_821_ = _e302;
                                }
                                let _e307 = phi_821_;
                                phi_824_ = type_7(0u, 32u);
                                phi_827_ = _e307;
                                phi_829_ = 0u;
                                phi_831_ = _e68;
                                phi_833_ = _e66;
                                let _e1192 = local_1;
                                phi_835_ = _e1192;
                                loop {
                                    let _e309 = phi_824_;
                                    let _e311 = phi_827_;
                                    let _e313 = phi_829_;
                                    let _e315 = phi_831_;
                                    let _e317 = phi_833_;
                                    let _e319 = phi_835_;
                                    local_3 = _e319;
                                    if (_e309.member < _e309.member_1) {
                                        phi_825_ = type_7((_e309.member + 1u), _e309.member_1);
                                        phi_858_ = type_7(1u, _e309.member);
                                    } else {
                                        phi_825_ = _e309;
                                        phi_858_ = type_7(0u, type_7().member_1);
                                    }
                                    let _e332 = phi_825_;
                                    let _e334 = phi_858_;
                                    if (bitcast<i32>(_e334.member) != 0i) {
                                        let _e338 = (_e317 >= _e315);
                                        if _e338 {
                                            phi_1068_ = u32();
                                            phi_1069_ = u32();
                                            phi_1070_ = u32();
                                            phi_1071_ = u32();
                                            phi_1072_ = type_34();
                                        } else {
                                            if ((_e317 & 1u) == 1u) {
                                                let _e341 = (_e313 + _e317);
                                                let _e342 = (_e341 < _e37);
                                                if _e342 {
                                                    if _e342 {
                                                    } else {
                                                        phi_2128_ = true;
                                                        break;
                                                    }
                                                    let _e345 = global_3.member[_e341];
                                                    phi_886_ = _e345;
                                                } else {
                                                    phi_886_ = array<f32, 8>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                                                }
                                                let _e347 = phi_886_;
                                                phi_957_ = (_e317 + 1u);
                                                phi_958_ = type_34(vec4<f32>(select(_e347[0], _e319.member.x, (_e319.member.x < _e347[0])), select(_e347[1], _e319.member.y, (_e319.member.y < _e347[1])), select(_e347[2], _e319.member.z, (_e319.member.z < _e347[2])), select(_e347[3], _e319.member.w, (_e319.member.w < _e347[3]))), vec4<f32>(select(_e347[4], _e319.member_1.x, (_e319.member_1.x > _e347[4])), select(_e347[5], _e319.member_1.y, (_e319.member_1.y > _e347[5])), select(_e347[6], _e319.member_1.z, (_e319.member_1.z > _e347[6])), select(_e347[7], _e319.member_1.w, (_e319.member_1.w > _e347[7]))));
                                            } else {
                                                phi_957_ = _e317;
                                                phi_958_ = _e319;
                                            }
                                            let _e387 = phi_957_;
                                            let _e389 = phi_958_;
                                            if ((_e315 & 1u) == 1u) {
                                                let _e392 = (_e315 - 1u);
                                                let _e393 = (_e313 + _e392);
                                                let _e394 = (_e393 < _e37);
                                                if _e394 {
                                                    if _e394 {
                                                    } else {
                                                        phi_2128_ = true;
                                                        break;
                                                    }
                                                    let _e397 = global_3.member[_e393];
                                                    phi_977_ = _e397;
                                                } else {
                                                    phi_977_ = array<f32, 8>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                                                }
                                                let _e399 = phi_977_;
                                                phi_1047_ = _e392;
                                                phi_1048_ = type_34(vec4<f32>(select(_e399[0], _e389.member.x, (_e389.member.x < _e399[0])), select(_e399[1], _e389.member.y, (_e389.member.y < _e399[1])), select(_e399[2], _e389.member.z, (_e389.member.z < _e399[2])), select(_e399[3], _e389.member.w, (_e389.member.w < _e399[3]))), vec4<f32>(select(_e399[4], _e389.member_1.x, (_e389.member_1.x > _e399[4])), select(_e399[5], _e389.member_1.y, (_e389.member_1.y > _e399[5])), select(_e399[6], _e389.member_1.z, (_e389.member_1.z > _e399[6])), select(_e399[7], _e389.member_1.w, (_e389.member_1.w > _e399[7]))));
                                            } else {
                                                phi_1047_ = _e315;
                                                phi_1048_ = _e389;
                                            }
                                            let _e438 = phi_1047_;
                                            let _e440 = phi_1048_;
                                            let _e444 = (_e311 / 2u);
                                            if ((_e311 % 2u) > 0u) {
                                                phi_1067_ = (_e444 + 1u);
                                            } else {
                                                phi_1067_ = _e444;
                                            }
                                            let _e449 = phi_1067_;
                                            phi_1068_ = _e449;
                                            phi_1069_ = (_e313 + _e311);
                                            phi_1070_ = (_e438 / 2u);
                                            phi_1071_ = (_e387 / 2u);
                                            phi_1072_ = _e440;
                                        }
                                        let _e451 = phi_1068_;
                                        let _e453 = phi_1069_;
                                        let _e455 = phi_1070_;
                                        let _e457 = phi_1071_;
                                        let _e459 = phi_1072_;
                                        phi_828_ = _e451;
                                        phi_830_ = _e453;
                                        phi_832_ = _e455;
                                        phi_834_ = _e457;
                                        phi_836_ = _e459;
                                        phi_1074_ = select(true, false, _e338);
                                    } else {
                                        phi_828_ = u32();
                                        phi_830_ = u32();
                                        phi_832_ = u32();
                                        phi_834_ = u32();
                                        phi_836_ = type_34();
                                        phi_1074_ = false;
                                    }
                                    let _e462 = phi_828_;
                                    let _e464 = phi_830_;
                                    let _e466 = phi_832_;
                                    let _e468 = phi_834_;
                                    let _e470 = phi_836_;
                                    let _e472 = phi_1074_;
                                    continue;
                                    continuing {
                                        phi_824_ = _e332;
                                        phi_827_ = _e462;
                                        phi_829_ = _e464;
                                        phi_831_ = _e466;
                                        phi_833_ = _e468;
                                        phi_835_ = _e470;
                                        phi_2128_ = _e301;
                                        break if !(_e472);
                                    }
                                }
                                let _e475 = phi_2128_;
                                if _e475 {
                                    break;
                                }
                                phi_2191_ = _e475;
                                let _e1228 = local_3;
                                phi_1075_ = _e1228;
                            }
                            let _e599 = phi_2191_;
                            let _e601 = phi_1075_;
                            if ((_e67 % 8u) > 0u) {
                                phi_1101_ = (_e68 + 1u);
                            } else {
                                phi_1101_ = _e68;
                            }
                            let _e615 = phi_1101_;
                            let _e617 = ((_e54.member_4 + 1u) / 8u);
                            if (_e615 >= _e617) {
                                phi_1110_ = type_32(_e67, _e54.member_4, false);
                                phi_1113_ = type_34(vec4<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec4<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
                                loop {
                                    let _e1027 = phi_1110_;
                                    let _e1029 = phi_1113_;
                                    local_6 = _e1029;
                                    if _e1027.member_2 {
                                        phi_1125_ = true;
                                    } else {
                                        phi_1125_ = !((_e1027.member <= _e1027.member_1));
                                    }
                                    let _e1036 = phi_1125_;
                                    if _e1036 {
                                        phi_1111_ = _e1027;
                                        phi_1153_ = type_7(0u, type_7().member_1);
                                    } else {
                                        if (_e1027.member < _e1027.member_1) {
                                            phi_1150_ = type_32((_e1027.member + 1u), _e1027.member_1, _e1027.member_2);
                                        } else {
                                            phi_1150_ = type_32(_e1027.member, _e1027.member_1, true);
                                        }
                                        let _e1050 = phi_1150_;
                                        phi_1111_ = _e1050;
                                        phi_1153_ = type_7(1u, _e1027.member);
                                    }
                                    let _e1056 = phi_1111_;
                                    let _e1058 = phi_1153_;
                                    let _e1062 = (bitcast<i32>(_e1058.member) != 0i);
                                    if _e1062 {
                                        let _e1063 = (_e1058.member_1 < _e35);
                                        if _e1063 {
                                            if _e1063 {
                                            } else {
                                                phi_2275_ = true;
                                                break;
                                            }
                                            let _e1066 = global_2.member[_e1058.member_1];
                                            phi_1172_ = _e1066;
                                        } else {
                                            phi_1172_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                        }
                                        let _e1068 = phi_1172_;
                                        let _e1080 = bitcast<f32>(_e1068.member_1);
                                        let _e1082 = select(_e1068.member[3], _e1068.member[0], (_e1068.member[0] < _e1068.member[3]));
                                        let _e1084 = select(_e1068.member[4], _e1068.member[1], (_e1068.member[1] < _e1068.member[4]));
                                        let _e1086 = select(_e1068.member[5], _e1068.member[2], (_e1068.member[2] < _e1068.member[5]));
                                        let _e1088 = select(_e1068.member[6], _e1068.member[3], (_e1068.member[3] < _e1068.member[6]));
                                        let _e1090 = select(_e1068.member[6], _e1082, (_e1082 < _e1068.member[6]));
                                        let _e1092 = select(_e1068.member[7], _e1084, (_e1084 < _e1068.member[7]));
                                        let _e1094 = select(_e1068.member[8], _e1086, (_e1086 < _e1068.member[8]));
                                        let _e1096 = select(_e1080, _e1088, (_e1088 < _e1080));
                                        let _e1098 = select(_e1068.member[3], _e1068.member[0], (_e1068.member[0] > _e1068.member[3]));
                                        let _e1100 = select(_e1068.member[4], _e1068.member[1], (_e1068.member[1] > _e1068.member[4]));
                                        let _e1102 = select(_e1068.member[5], _e1068.member[2], (_e1068.member[2] > _e1068.member[5]));
                                        let _e1104 = select(_e1068.member[6], _e1068.member[3], (_e1068.member[3] > _e1068.member[6]));
                                        let _e1106 = select(_e1068.member[6], _e1098, (_e1098 > _e1068.member[6]));
                                        let _e1108 = select(_e1068.member[7], _e1100, (_e1100 > _e1068.member[7]));
                                        let _e1110 = select(_e1068.member[8], _e1102, (_e1102 > _e1068.member[8]));
                                        let _e1112 = select(_e1080, _e1104, (_e1104 > _e1080));
                                        phi_1114_ = type_34(vec4<f32>(select(_e1090, _e1029.member.x, (_e1029.member.x < _e1090)), select(_e1092, _e1029.member.y, (_e1029.member.y < _e1092)), select(_e1094, _e1029.member.z, (_e1029.member.z < _e1094)), select(_e1096, _e1029.member.w, (_e1029.member.w < _e1096))), vec4<f32>(select(_e1106, _e1029.member_1.x, (_e1029.member_1.x > _e1106)), select(_e1108, _e1029.member_1.y, (_e1029.member_1.y > _e1108)), select(_e1110, _e1029.member_1.z, (_e1029.member_1.z > _e1110)), select(_e1112, _e1029.member_1.w, (_e1029.member_1.w > _e1112))));
                                    } else {
                                        phi_1114_ = type_34();
                                    }
                                    let _e1143 = phi_1114_;
                                    continue;
                                    continuing {
                                        phi_1110_ = _e1056;
                                        phi_1113_ = _e1143;
                                        phi_2275_ = _e599;
                                        break if !(_e1062);
                                    }
                                }
                                let _e1146 = phi_2275_;
                                if _e1146 {
                                    break;
                                }
                                let _e1289 = local_6;
                                phi_2022_ = _e1289;
                            } else {
                                phi_1331_ = type_7(_e67, (_e615 * 8u));
                                phi_1334_ = type_34(vec4<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec4<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
                                loop {
                                    let _e622 = phi_1331_;
                                    let _e624 = phi_1334_;
                                    local_4 = _e624;
                                    if (_e622.member < _e622.member_1) {
                                        phi_1332_ = type_7((_e622.member + 1u), _e622.member_1);
                                        phi_1357_ = type_7(1u, _e622.member);
                                    } else {
                                        phi_1332_ = _e622;
                                        phi_1357_ = type_7(0u, type_7().member_1);
                                    }
                                    let _e637 = phi_1332_;
                                    let _e639 = phi_1357_;
                                    let _e643 = (bitcast<i32>(_e639.member) != 0i);
                                    if _e643 {
                                        let _e644 = (_e639.member_1 < _e35);
                                        if _e644 {
                                            if _e644 {
                                            } else {
                                                phi_2186_ = true;
                                                break;
                                            }
                                            let _e647 = global_2.member[_e639.member_1];
                                            phi_1376_ = _e647;
                                        } else {
                                            phi_1376_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                        }
                                        let _e649 = phi_1376_;
                                        let _e661 = bitcast<f32>(_e649.member_1);
                                        let _e663 = select(_e649.member[3], _e649.member[0], (_e649.member[0] < _e649.member[3]));
                                        let _e665 = select(_e649.member[4], _e649.member[1], (_e649.member[1] < _e649.member[4]));
                                        let _e667 = select(_e649.member[5], _e649.member[2], (_e649.member[2] < _e649.member[5]));
                                        let _e669 = select(_e649.member[6], _e649.member[3], (_e649.member[3] < _e649.member[6]));
                                        let _e671 = select(_e649.member[6], _e663, (_e663 < _e649.member[6]));
                                        let _e673 = select(_e649.member[7], _e665, (_e665 < _e649.member[7]));
                                        let _e675 = select(_e649.member[8], _e667, (_e667 < _e649.member[8]));
                                        let _e677 = select(_e661, _e669, (_e669 < _e661));
                                        let _e679 = select(_e649.member[3], _e649.member[0], (_e649.member[0] > _e649.member[3]));
                                        let _e681 = select(_e649.member[4], _e649.member[1], (_e649.member[1] > _e649.member[4]));
                                        let _e683 = select(_e649.member[5], _e649.member[2], (_e649.member[2] > _e649.member[5]));
                                        let _e685 = select(_e649.member[6], _e649.member[3], (_e649.member[3] > _e649.member[6]));
                                        let _e687 = select(_e649.member[6], _e679, (_e679 > _e649.member[6]));
                                        let _e689 = select(_e649.member[7], _e681, (_e681 > _e649.member[7]));
                                        let _e691 = select(_e649.member[8], _e683, (_e683 > _e649.member[8]));
                                        let _e693 = select(_e661, _e685, (_e685 > _e661));
                                        phi_1335_ = type_34(vec4<f32>(select(_e671, _e624.member.x, (_e624.member.x < _e671)), select(_e673, _e624.member.y, (_e624.member.y < _e673)), select(_e675, _e624.member.z, (_e624.member.z < _e675)), select(_e677, _e624.member.w, (_e624.member.w < _e677))), vec4<f32>(select(_e687, _e624.member_1.x, (_e624.member_1.x > _e687)), select(_e689, _e624.member_1.y, (_e624.member_1.y > _e689)), select(_e691, _e624.member_1.z, (_e624.member_1.z > _e691)), select(_e693, _e624.member_1.w, (_e624.member_1.w > _e693))));
                                    } else {
                                        phi_1335_ = type_34();
                                    }
                                    let _e724 = phi_1335_;
                                    continue;
                                    continuing {
                                        phi_1331_ = _e637;
                                        phi_1334_ = _e724;
                                        phi_2186_ = _e599;
                                        break if !(_e643);
                                    }
                                }
                                let _e727 = phi_2186_;
                                if _e727 {
                                    break;
                                }
                                phi_1535_ = type_32((_e617 * 8u), _e54.member_4, false);
                                let _e1240 = local_4;
                                phi_1538_ = _e1240;
                                loop {
                                    let _e731 = phi_1535_;
                                    let _e733 = phi_1538_;
                                    local_5 = _e733;
                                    if _e731.member_2 {
                                        phi_1550_ = true;
                                    } else {
                                        phi_1550_ = !((_e731.member <= _e731.member_1));
                                    }
                                    let _e740 = phi_1550_;
                                    if _e740 {
                                        phi_1536_ = _e731;
                                        phi_1578_ = type_7(0u, type_7().member_1);
                                    } else {
                                        if (_e731.member < _e731.member_1) {
                                            phi_1575_ = type_32((_e731.member + 1u), _e731.member_1, _e731.member_2);
                                        } else {
                                            phi_1575_ = type_32(_e731.member, _e731.member_1, true);
                                        }
                                        let _e754 = phi_1575_;
                                        phi_1536_ = _e754;
                                        phi_1578_ = type_7(1u, _e731.member);
                                    }
                                    let _e760 = phi_1536_;
                                    let _e762 = phi_1578_;
                                    let _e766 = (bitcast<i32>(_e762.member) != 0i);
                                    if _e766 {
                                        let _e767 = (_e762.member_1 < _e35);
                                        if _e767 {
                                            if _e767 {
                                            } else {
                                                phi_2217_ = true;
                                                break;
                                            }
                                            let _e770 = global_2.member[_e762.member_1];
                                            phi_1597_ = _e770;
                                        } else {
                                            phi_1597_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                        }
                                        let _e772 = phi_1597_;
                                        let _e784 = bitcast<f32>(_e772.member_1);
                                        let _e786 = select(_e772.member[3], _e772.member[0], (_e772.member[0] < _e772.member[3]));
                                        let _e788 = select(_e772.member[4], _e772.member[1], (_e772.member[1] < _e772.member[4]));
                                        let _e790 = select(_e772.member[5], _e772.member[2], (_e772.member[2] < _e772.member[5]));
                                        let _e792 = select(_e772.member[6], _e772.member[3], (_e772.member[3] < _e772.member[6]));
                                        let _e794 = select(_e772.member[6], _e786, (_e786 < _e772.member[6]));
                                        let _e796 = select(_e772.member[7], _e788, (_e788 < _e772.member[7]));
                                        let _e798 = select(_e772.member[8], _e790, (_e790 < _e772.member[8]));
                                        let _e800 = select(_e784, _e792, (_e792 < _e784));
                                        let _e802 = select(_e772.member[3], _e772.member[0], (_e772.member[0] > _e772.member[3]));
                                        let _e804 = select(_e772.member[4], _e772.member[1], (_e772.member[1] > _e772.member[4]));
                                        let _e806 = select(_e772.member[5], _e772.member[2], (_e772.member[2] > _e772.member[5]));
                                        let _e808 = select(_e772.member[6], _e772.member[3], (_e772.member[3] > _e772.member[6]));
                                        let _e810 = select(_e772.member[6], _e802, (_e802 > _e772.member[6]));
                                        let _e812 = select(_e772.member[7], _e804, (_e804 > _e772.member[7]));
                                        let _e814 = select(_e772.member[8], _e806, (_e806 > _e772.member[8]));
                                        let _e816 = select(_e784, _e808, (_e808 > _e784));
                                        phi_1539_ = type_34(vec4<f32>(select(_e794, _e733.member.x, (_e733.member.x < _e794)), select(_e796, _e733.member.y, (_e733.member.y < _e796)), select(_e798, _e733.member.z, (_e733.member.z < _e798)), select(_e800, _e733.member.w, (_e733.member.w < _e800))), vec4<f32>(select(_e810, _e733.member_1.x, (_e733.member_1.x > _e810)), select(_e812, _e733.member_1.y, (_e733.member_1.y > _e812)), select(_e814, _e733.member_1.z, (_e733.member_1.z > _e814)), select(_e816, _e733.member_1.w, (_e733.member_1.w > _e816))));
                                    } else {
                                        phi_1539_ = type_34();
                                    }
                                    let _e847 = phi_1539_;
                                    continue;
                                    continuing {
                                        phi_1535_ = _e760;
                                        phi_1538_ = _e847;
                                        phi_2217_ = _e727;
                                        break if !(_e766);
                                    }
                                }
                                let _e850 = phi_2217_;
                                if _e850 {
                                    break;
                                }
                                let _e851 = (_e35 / 8u);
                                if ((_e35 % 8u) > 0u) {
                                    phi_1768_ = (_e851 + 1u);
                                } else {
                                    phi_1768_ = _e851;
                                }
                                let _e856 = phi_1768_;
                                phi_1771_ = type_7(0u, 32u);
                                phi_1774_ = _e856;
                                phi_1776_ = 0u;
                                phi_1778_ = _e617;
                                phi_1780_ = _e615;
                                let _e1256 = local_5;
                                phi_1782_ = _e1256;
                                loop {
                                    let _e858 = phi_1771_;
                                    let _e860 = phi_1774_;
                                    let _e862 = phi_1776_;
                                    let _e864 = phi_1778_;
                                    let _e866 = phi_1780_;
                                    let _e868 = phi_1782_;
                                    local_7 = _e868;
                                    if (_e858.member < _e858.member_1) {
                                        phi_1772_ = type_7((_e858.member + 1u), _e858.member_1);
                                        phi_1805_ = type_7(1u, _e858.member);
                                    } else {
                                        phi_1772_ = _e858;
                                        phi_1805_ = type_7(0u, type_7().member_1);
                                    }
                                    let _e881 = phi_1772_;
                                    let _e883 = phi_1805_;
                                    if (bitcast<i32>(_e883.member) != 0i) {
                                        let _e887 = (_e866 >= _e864);
                                        if _e887 {
                                            phi_2015_ = u32();
                                            phi_2016_ = u32();
                                            phi_2017_ = u32();
                                            phi_2018_ = u32();
                                            phi_2019_ = type_34();
                                        } else {
                                            if ((_e866 & 1u) == 1u) {
                                                let _e890 = (_e862 + _e866);
                                                let _e891 = (_e890 < _e37);
                                                if _e891 {
                                                    if _e891 {
                                                    } else {
                                                        phi_2248_ = true;
                                                        break;
                                                    }
                                                    let _e894 = global_3.member[_e890];
                                                    phi_1833_ = _e894;
                                                } else {
                                                    phi_1833_ = array<f32, 8>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                                                }
                                                let _e896 = phi_1833_;
                                                phi_1904_ = (_e866 + 1u);
                                                phi_1905_ = type_34(vec4<f32>(select(_e896[0], _e868.member.x, (_e868.member.x < _e896[0])), select(_e896[1], _e868.member.y, (_e868.member.y < _e896[1])), select(_e896[2], _e868.member.z, (_e868.member.z < _e896[2])), select(_e896[3], _e868.member.w, (_e868.member.w < _e896[3]))), vec4<f32>(select(_e896[4], _e868.member_1.x, (_e868.member_1.x > _e896[4])), select(_e896[5], _e868.member_1.y, (_e868.member_1.y > _e896[5])), select(_e896[6], _e868.member_1.z, (_e868.member_1.z > _e896[6])), select(_e896[7], _e868.member_1.w, (_e868.member_1.w > _e896[7]))));
                                            } else {
                                                phi_1904_ = _e866;
                                                phi_1905_ = _e868;
                                            }
                                            let _e936 = phi_1904_;
                                            let _e938 = phi_1905_;
                                            if ((_e864 & 1u) == 1u) {
                                                let _e941 = (_e864 - 1u);
                                                let _e942 = (_e862 + _e941);
                                                let _e943 = (_e942 < _e37);
                                                if _e943 {
                                                    if _e943 {
                                                    } else {
                                                        phi_2248_ = true;
                                                        break;
                                                    }
                                                    let _e946 = global_3.member[_e942];
                                                    phi_1924_ = _e946;
                                                } else {
                                                    phi_1924_ = array<f32, 8>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                                                }
                                                let _e948 = phi_1924_;
                                                phi_1994_ = _e941;
                                                phi_1995_ = type_34(vec4<f32>(select(_e948[0], _e938.member.x, (_e938.member.x < _e948[0])), select(_e948[1], _e938.member.y, (_e938.member.y < _e948[1])), select(_e948[2], _e938.member.z, (_e938.member.z < _e948[2])), select(_e948[3], _e938.member.w, (_e938.member.w < _e948[3]))), vec4<f32>(select(_e948[4], _e938.member_1.x, (_e938.member_1.x > _e948[4])), select(_e948[5], _e938.member_1.y, (_e938.member_1.y > _e948[5])), select(_e948[6], _e938.member_1.z, (_e938.member_1.z > _e948[6])), select(_e948[7], _e938.member_1.w, (_e938.member_1.w > _e948[7]))));
                                            } else {
                                                phi_1994_ = _e864;
                                                phi_1995_ = _e938;
                                            }
                                            let _e987 = phi_1994_;
                                            let _e989 = phi_1995_;
                                            let _e993 = (_e860 / 2u);
                                            if ((_e860 % 2u) > 0u) {
                                                phi_2014_ = (_e993 + 1u);
                                            } else {
                                                phi_2014_ = _e993;
                                            }
                                            let _e998 = phi_2014_;
                                            phi_2015_ = _e998;
                                            phi_2016_ = (_e862 + _e860);
                                            phi_2017_ = (_e987 / 2u);
                                            phi_2018_ = (_e936 / 2u);
                                            phi_2019_ = _e989;
                                        }
                                        let _e1000 = phi_2015_;
                                        let _e1002 = phi_2016_;
                                        let _e1004 = phi_2017_;
                                        let _e1006 = phi_2018_;
                                        let _e1008 = phi_2019_;
                                        phi_1775_ = _e1000;
                                        phi_1777_ = _e1002;
                                        phi_1779_ = _e1004;
                                        phi_1781_ = _e1006;
                                        phi_1783_ = _e1008;
                                        phi_2021_ = select(true, false, _e887);
                                    } else {
                                        phi_1775_ = u32();
                                        phi_1777_ = u32();
                                        phi_1779_ = u32();
                                        phi_1781_ = u32();
                                        phi_1783_ = type_34();
                                        phi_2021_ = false;
                                    }
                                    let _e1011 = phi_1775_;
                                    let _e1013 = phi_1777_;
                                    let _e1015 = phi_1779_;
                                    let _e1017 = phi_1781_;
                                    let _e1019 = phi_1783_;
                                    let _e1021 = phi_2021_;
                                    continue;
                                    continuing {
                                        phi_1771_ = _e881;
                                        phi_1774_ = _e1011;
                                        phi_1776_ = _e1013;
                                        phi_1778_ = _e1015;
                                        phi_1780_ = _e1017;
                                        phi_1782_ = _e1019;
                                        phi_2248_ = _e850;
                                        break if !(_e1021);
                                    }
                                }
                                let _e1024 = phi_2248_;
                                if _e1024 {
                                    break;
                                }
                                let _e1291 = local_7;
                                phi_2022_ = _e1291;
                            }
                            let _e1148 = phi_2022_;
                            phi_2040_ = type_27(array<array<f32, 4>, 3>(array<f32, 4>(_e601.member.x, _e1148.member.x, _e601.member_1.x, _e1148.member_1.x), array<f32, 4>(_e601.member.y, _e1148.member.y, _e601.member_1.y, _e1148.member_1.y), array<f32, 4>(_e601.member.z, _e1148.member.z, _e601.member_1.z, _e1148.member_1.z)), _e54.member_1, _e54.member_2, _e54.member_3, _e54.member_4);
                        }
                        let _e1164 = phi_2040_;
                        if _e50 {
                        } else {
                            break;
                        }
                        global_5.member[_e45] = _e1164;
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
