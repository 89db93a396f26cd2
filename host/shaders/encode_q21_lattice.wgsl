struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_16 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_25 {
    member: array<array<i32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_27 {
    member: array<type_25>,
}

struct type_31 {
    member: array<vec4<u32>, 2>,
}

struct type_34 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

struct type_37 {
    member: array<array<u32, 7>>,
}

struct type_41 {
    member: array<type_34>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_18;
@group(0) @binding(1) 
var<uniform> global_3: type_31;
@group(0) @binding(2) 
var<storage> global_4: type_27;
@group(0) @binding(4) 
var<storage> global_5: type_41;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(7) 
var<storage, read_write> global_7: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_8: type_37;

fn function_() {
    var phi_685_: u32;
    var phi_687_: u32;
    var phi_688_: bool;
    var phi_704_: u32;
    var phi_706_: u32;
    var phi_707_: bool;
    var phi_712_: u32;
    var phi_724_: u32;
    var phi_740_: u32;
    var phi_755_: u32;
    var phi_770_: u32;
    var phi_1300_: u32;
    var phi_1306_: u32;
    var phi_1316_: u32;
    var phi_1319_: type_8;
    var phi_1320_: type_8;
    var phi_1343_: type_8;
    var phi_1443_: u32;
    var phi_1640_: i32;
    var phi_1674_: i32;
    var phi_1708_: i32;
    var phi_1742_: i32;
    var phi_1776_: i32;
    var phi_1810_: i32;
    var phi_1844_: i32;
    var phi_1878_: i32;
    var phi_1912_: i32;
    var phi_1930_: array<u32, 10>;
    var phi_2854_: bool;
    var phi_2096_: u32;
    var phi_2102_: u32;
    var phi_2112_: u32;
    var phi_2115_: type_8;
    var phi_2116_: type_8;
    var phi_2139_: type_8;
    var phi_2239_: u32;
    var phi_2436_: i32;
    var phi_2470_: i32;
    var phi_2504_: i32;
    var phi_2538_: i32;
    var phi_2572_: i32;
    var phi_2606_: i32;
    var phi_2640_: i32;
    var phi_2674_: i32;
    var phi_2708_: i32;
    var phi_2726_: array<u32, 10>;
    var phi_2968_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e57 = global;
            let _e63 = arrayLength((&global_2.member));
            let _e69 = arrayLength((&global_6.member));
            let _e73 = arrayLength((&global_7.member));
            let _e77 = global_3.member[0u][3u];
            let _e82 = (_e57.x + (_e57.y * 2097152u));
            let _e85 = global_1.member[0u];
            if (_e82 < _e85) {
                let _e87 = (_e82 < arrayLength((&global_4.member)));
                if _e87 {
                    let _e88 = (_e82 < arrayLength((&global_5.member)));
                    if _e88 {
                        let _e89 = (_e82 < arrayLength((&global_8.member)));
                        if _e89 {
                            if _e89 {
                            } else {
                                break;
                            }
                            if _e88 {
                            } else {
                                break;
                            }
                            let _e94 = global_5.member[_e82].member;
                            let _e97 = global_5.member[_e82].member_1;
                            let _e107 = global_8.member[_e82][1u];
                            let _e111 = global_8.member[_e82][2u];
                            let _e113 = bitcast<u32>((_e97[0] - _e94[0]));
                            let _e119 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e113)), 32u, (_e113 == 0u)));
                            let _e124 = ((select(21u, _e119, (_e119 > 21u)) - 21u) & 31u);
                            let _e128 = (_e94[0] + bitcast<i32>(((_e107 & 2097151u) << bitcast<u32>(_e124))));
                            let _e133 = (_e97[0] - bitcast<i32>(((_e111 & 2097151u) << bitcast<u32>(_e124))));
                            let _e137 = (((_e107 >> bitcast<u32>(21u)) & 1u) == 1u);
                            let _e141 = (((_e111 >> bitcast<u32>(21u)) & 1u) == 1u);
                            let _e142 = select(_e94[0], _e128, _e137);
                            let _e143 = select(_e128, _e94[0], _e137);
                            let _e149 = global_8.member[_e82][3u];
                            let _e153 = global_8.member[_e82][4u];
                            let _e155 = bitcast<u32>((_e97[1] - _e94[1]));
                            let _e161 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e155)), 32u, (_e155 == 0u)));
                            let _e166 = ((select(21u, _e161, (_e161 > 21u)) - 21u) & 31u);
                            let _e170 = (_e94[1] + bitcast<i32>(((_e149 & 2097151u) << bitcast<u32>(_e166))));
                            let _e175 = (_e97[1] - bitcast<i32>(((_e153 & 2097151u) << bitcast<u32>(_e166))));
                            let _e179 = (((_e149 >> bitcast<u32>(21u)) & 1u) == 1u);
                            let _e183 = (((_e153 >> bitcast<u32>(21u)) & 1u) == 1u);
                            let _e184 = select(_e94[1], _e170, _e179);
                            let _e185 = select(_e170, _e94[1], _e179);
                            let _e191 = global_8.member[_e82][5u];
                            let _e195 = global_8.member[_e82][6u];
                            let _e197 = bitcast<u32>((_e97[2] - _e94[2]));
                            let _e203 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e197)), 32u, (_e197 == 0u)));
                            let _e208 = ((select(21u, _e203, (_e203 > 21u)) - 21u) & 31u);
                            let _e212 = (_e94[2] + bitcast<i32>(((_e191 & 2097151u) << bitcast<u32>(_e208))));
                            let _e217 = (_e97[2] - bitcast<i32>(((_e195 & 2097151u) << bitcast<u32>(_e208))));
                            let _e221 = (((_e191 >> bitcast<u32>(21u)) & 1u) == 1u);
                            let _e225 = (((_e195 >> bitcast<u32>(21u)) & 1u) == 1u);
                            let _e226 = select(_e94[2], _e212, _e221);
                            let _e227 = select(_e212, _e94[2], _e221);
                            if _e89 {
                            } else {
                                break;
                            }
                            let _e230 = global_8.member[_e82];
                            if _e87 {
                            } else {
                                break;
                            }
                            let _e233 = global_4.member[_e82].member_1;
                            let _e236 = global_4.member[_e82].member_2;
                            let _e238 = ((_e233 & 2147483648u) != 0u);
                            if _e238 {
                                let _e242 = (((_e233 >> bitcast<u32>(28u)) & 7u) > 0u);
                                if _e242 {
                                    phi_685_ = (_e233 & 268435455u);
                                } else {
                                    phi_685_ = u32();
                                }
                                let _e245 = phi_685_;
                                phi_687_ = _e245;
                                phi_688_ = select(true, false, _e242);
                            } else {
                                phi_687_ = u32();
                                phi_688_ = true;
                            }
                            let _e248 = phi_687_;
                            let _e250 = phi_688_;
                            if _e250 {
                                if ((_e236 & 2147483648u) != 0u) {
                                    let _e256 = (((_e236 >> bitcast<u32>(28u)) & 7u) > 0u);
                                    if _e256 {
                                        phi_704_ = (_e236 & 268435455u);
                                    } else {
                                        phi_704_ = u32();
                                    }
                                    let _e259 = phi_704_;
                                    phi_706_ = _e259;
                                    phi_707_ = select(true, false, _e256);
                                } else {
                                    phi_706_ = u32();
                                    phi_707_ = true;
                                }
                                let _e262 = phi_706_;
                                let _e264 = phi_707_;
                                phi_712_ = select(_e262, 0u, _e264);
                            } else {
                                phi_712_ = _e248;
                            }
                            let _e267 = phi_712_;
                            let _e268 = (_e267 < _e69);
                            if _e268 {
                                if _e268 {
                                } else {
                                    break;
                                }
                                let _e270 = global_6.member[_e267];
                                phi_724_ = _e270;
                            } else {
                                phi_724_ = 0u;
                            }
                            let _e272 = phi_724_;
                            if _e238 {
                                phi_740_ = select(_e236, 0u, ((_e236 & 2147483648u) != 0u));
                            } else {
                                phi_740_ = _e233;
                            }
                            let _e277 = phi_740_;
                            if _e238 {
                                let _e280 = ((_e233 >> bitcast<u32>(28u)) & 7u);
                                phi_755_ = select(_e280, 7u, (_e280 == 0u));
                            } else {
                                phi_755_ = 0u;
                            }
                            let _e284 = phi_755_;
                            let _e286 = ((_e236 & 2147483648u) != 0u);
                            if _e286 {
                                let _e289 = ((_e236 >> bitcast<u32>(28u)) & 7u);
                                phi_770_ = select(_e289, 7u, (_e289 == 0u));
                            } else {
                                phi_770_ = 0u;
                            }
                            let _e293 = phi_770_;
                            let _e306 = ((_e272 & 268435455u) | ((_e293 >> bitcast<u32>(1i)) << bitcast<u32>(28u)));
                            if _e89 {
                            } else {
                                break;
                            }
                            global_8.member[_e82] = array<u32, 7>((((_e277 & 268435455u) | (_e284 << bitcast<u32>(28u))) | (_e293 << bitcast<u32>(31i))), _e230[1], (_e230[2] | (_e306 << bitcast<u32>(22i))), _e230[3], (_e230[4] | ((_e306 >> bitcast<u32>(10u)) << bitcast<u32>(22i))), _e230[5], (_e230[6] | ((_e306 >> bitcast<u32>(20u)) << bitcast<u32>(22i))));
                            if _e87 {
                            } else {
                                break;
                            }
                            let _e331 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e77) + 127i)) << bitcast<u32>(23i)));
                            let _e339 = ((bitcast<u32>((select(_e97[0], _e133, _e141) - _e142)) | bitcast<u32>((select(_e97[1], _e175, _e183) - _e184))) | bitcast<u32>((select(_e97[2], _e217, _e225) - _e226)));
                            let _e340 = (_e339 < 1024u);
                            if _e340 {
                                phi_1300_ = 0u;
                            } else {
                                phi_1300_ = select(2u, 1u, (_e339 < 2097152u));
                            }
                            let _e344 = phi_1300_;
                            switch bitcast<i32>(_e344) {
                                case 0: {
                                    phi_1306_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_1306_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_1306_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_1306_ = u32();
                                    break;
                                }
                            }
                            let _e347 = phi_1306_;
                            let _e349 = ((3u * _e347) + 1u);
                            if _e238 {
                                phi_1316_ = ((_e233 >> bitcast<u32>(28u)) & 7u);
                            } else {
                                phi_1316_ = 0u;
                            }
                            let _e354 = phi_1316_;
                            phi_1319_ = type_8(0u, _e354);
                            loop {
                                let _e357 = phi_1319_;
                                if (_e357.member < _e357.member_1) {
                                    phi_1320_ = type_8((_e357.member + 1u), _e357.member_1);
                                    phi_1343_ = type_8(1u, _e357.member);
                                } else {
                                    phi_1320_ = _e357;
                                    phi_1343_ = type_8(0u, type_8().member_1);
                                }
                                let _e370 = phi_1320_;
                                let _e372 = phi_1343_;
                                let _e376 = (bitcast<i32>(_e372.member) != 0i);
                                if _e376 {
                                    let _e378 = ((_e233 & 268435455u) + _e372.member_1);
                                    let _e379 = (_e378 < _e63);
                                    if _e379 {
                                        let _e380 = (_e378 < _e69);
                                        if _e380 {
                                            if _e380 {
                                            } else {
                                                phi_2854_ = true;
                                                break;
                                            }
                                            let _e382 = global_6.member[_e378];
                                            if ((_e382 + _e349) <= _e73) {
                                                if _e379 {
                                                } else {
                                                    phi_2854_ = true;
                                                    break;
                                                }
                                                let _e387 = global_2.member[_e378].member_1;
                                                if _e340 {
                                                    phi_1443_ = 0u;
                                                } else {
                                                    phi_1443_ = select(2u, 1u, (_e339 < 2097152u));
                                                }
                                                let _e391 = phi_1443_;
                                                switch bitcast<i32>(_e391) {
                                                    case 0: {
                                                        let _e790 = (f32(_e142) * _e331);
                                                        let _e792 = (f32(_e184) * _e331);
                                                        let _e794 = (f32(_e226) * _e331);
                                                        let _e795 = (1f / _e331);
                                                        let _e799 = global_2.member[_e378].member[0u];
                                                        let _e803 = global_2.member[_e378].member[1u];
                                                        let _e807 = global_2.member[_e378].member[2u];
                                                        let _e811 = (1024f / _e331);
                                                        let _e828 = global_2.member[_e378].member[3u];
                                                        let _e832 = global_2.member[_e378].member[4u];
                                                        let _e836 = global_2.member[_e378].member[5u];
                                                        let _e856 = global_2.member[_e378].member[6u];
                                                        let _e860 = global_2.member[_e378].member[7u];
                                                        let _e864 = global_2.member[_e378].member[8u];
                                                        phi_1930_ = array<u32, 10>(((bitcast<u32>(((((_e799 - _e790) * _e795) + ((_e803 - _e792) * _e811)) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e807 - _e794) * _e795) + 8388608f)) & 4194303u) << bitcast<u32>(20i))), ((bitcast<u32>(((((_e828 - _e790) * _e795) + ((_e832 - _e792) * _e811)) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e836 - _e794) * _e795) + 8388608f)) & 4194303u) << bitcast<u32>(20i))), ((bitcast<u32>(((((_e856 - _e790) * _e795) + ((_e860 - _e792) * _e811)) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e864 - _e794) * _e795) + 8388608f)) & 4194303u) << bitcast<u32>(20i))), _e387, 0u, 0u, 0u, 0u, 0u, 0u);
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e677 = (f32(_e142) * _e331);
                                                        let _e679 = (f32(_e184) * _e331);
                                                        let _e681 = (f32(_e226) * _e331);
                                                        let _e682 = (1f / _e331);
                                                        let _e686 = global_2.member[_e378].member[0u];
                                                        let _e690 = global_2.member[_e378].member[1u];
                                                        let _e694 = global_2.member[_e378].member[2u];
                                                        let _e699 = (bitcast<u32>((((_e690 - _e679) * _e682) + 8388608f)) & 4194303u);
                                                        let _e721 = global_2.member[_e378].member[3u];
                                                        let _e725 = global_2.member[_e378].member[4u];
                                                        let _e729 = global_2.member[_e378].member[5u];
                                                        let _e734 = (bitcast<u32>((((_e725 - _e679) * _e682) + 8388608f)) & 4194303u);
                                                        let _e756 = global_2.member[_e378].member[6u];
                                                        let _e760 = global_2.member[_e378].member[7u];
                                                        let _e764 = global_2.member[_e378].member[8u];
                                                        let _e769 = (bitcast<u32>((((_e760 - _e679) * _e682) + 8388608f)) & 4194303u);
                                                        phi_1930_ = array<u32, 10>(((bitcast<u32>((((_e686 - _e677) * _e682) + 8388608f)) & 4194303u) | (_e699 << bitcast<u32>(21i))), ((_e699 >> bitcast<u32>(11i)) | ((bitcast<u32>((((_e694 - _e681) * _e682) + 8388608f)) & 4194303u) << bitcast<u32>(10i))), ((bitcast<u32>((((_e721 - _e677) * _e682) + 8388608f)) & 4194303u) | (_e734 << bitcast<u32>(21i))), ((_e734 >> bitcast<u32>(11i)) | ((bitcast<u32>((((_e729 - _e681) * _e682) + 8388608f)) & 4194303u) << bitcast<u32>(10i))), ((bitcast<u32>((((_e756 - _e677) * _e682) + 8388608f)) & 4194303u) | (_e769 << bitcast<u32>(21i))), ((_e769 >> bitcast<u32>(11i)) | ((bitcast<u32>((((_e764 - _e681) * _e682) + 8388608f)) & 4194303u) << bitcast<u32>(10i))), _e387, 0u, 0u, 0u);
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e396 = global_2.member[_e378].member[0u];
                                                        let _e398 = (bitcast<u32>(_e331) & 2147483647u);
                                                        let _e399 = (_e398 >= 8388608u);
                                                        if _e399 {
                                                            phi_1640_ = (bitcast<i32>((_e398 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1640_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e398)), 32u, (_e398 == 0u))));
                                                        }
                                                        let _e412 = phi_1640_;
                                                        let _e418 = (_e396 * bitcast<f32>((bitcast<u32>((127i - _e412)) << bitcast<u32>(23i))));
                                                        let _e430 = global_2.member[_e378].member[1u];
                                                        if _e399 {
                                                            phi_1674_ = (bitcast<i32>((_e398 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1674_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e398)), 32u, (_e398 == 0u))));
                                                        }
                                                        let _e443 = phi_1674_;
                                                        let _e449 = (_e430 * bitcast<f32>((bitcast<u32>((127i - _e443)) << bitcast<u32>(23i))));
                                                        let _e461 = global_2.member[_e378].member[2u];
                                                        if _e399 {
                                                            phi_1708_ = (bitcast<i32>((_e398 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1708_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e398)), 32u, (_e398 == 0u))));
                                                        }
                                                        let _e474 = phi_1708_;
                                                        let _e480 = (_e461 * bitcast<f32>((bitcast<u32>((127i - _e474)) << bitcast<u32>(23i))));
                                                        let _e492 = global_2.member[_e378].member[3u];
                                                        if _e399 {
                                                            phi_1742_ = (bitcast<i32>((_e398 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1742_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e398)), 32u, (_e398 == 0u))));
                                                        }
                                                        let _e505 = phi_1742_;
                                                        let _e511 = (_e492 * bitcast<f32>((bitcast<u32>((127i - _e505)) << bitcast<u32>(23i))));
                                                        let _e523 = global_2.member[_e378].member[4u];
                                                        if _e399 {
                                                            phi_1776_ = (bitcast<i32>((_e398 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1776_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e398)), 32u, (_e398 == 0u))));
                                                        }
                                                        let _e536 = phi_1776_;
                                                        let _e542 = (_e523 * bitcast<f32>((bitcast<u32>((127i - _e536)) << bitcast<u32>(23i))));
                                                        let _e554 = global_2.member[_e378].member[5u];
                                                        if _e399 {
                                                            phi_1810_ = (bitcast<i32>((_e398 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1810_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e398)), 32u, (_e398 == 0u))));
                                                        }
                                                        let _e567 = phi_1810_;
                                                        let _e573 = (_e554 * bitcast<f32>((bitcast<u32>((127i - _e567)) << bitcast<u32>(23i))));
                                                        let _e585 = global_2.member[_e378].member[6u];
                                                        if _e399 {
                                                            phi_1844_ = (bitcast<i32>((_e398 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1844_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e398)), 32u, (_e398 == 0u))));
                                                        }
                                                        let _e598 = phi_1844_;
                                                        let _e604 = (_e585 * bitcast<f32>((bitcast<u32>((127i - _e598)) << bitcast<u32>(23i))));
                                                        let _e616 = global_2.member[_e378].member[7u];
                                                        if _e399 {
                                                            phi_1878_ = (bitcast<i32>((_e398 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1878_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e398)), 32u, (_e398 == 0u))));
                                                        }
                                                        let _e629 = phi_1878_;
                                                        let _e635 = (_e616 * bitcast<f32>((bitcast<u32>((127i - _e629)) << bitcast<u32>(23i))));
                                                        let _e647 = global_2.member[_e378].member[8u];
                                                        if _e399 {
                                                            phi_1912_ = (bitcast<i32>((_e398 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_1912_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e398)), 32u, (_e398 == 0u))));
                                                        }
                                                        let _e660 = phi_1912_;
                                                        let _e666 = (_e647 * bitcast<f32>((bitcast<u32>((127i - _e660)) << bitcast<u32>(23i))));
                                                        phi_1930_ = array<u32, 10>(bitcast<u32>(select(0i, select(select(i32(_e418), i32(-2147483648), (_e418 < -2147483600f)), 2147483647i, (_e418 > 2147483500f)), (_e418 == _e418))), bitcast<u32>(select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < -2147483600f)), 2147483647i, (_e449 > 2147483500f)), (_e449 == _e449))), bitcast<u32>(select(0i, select(select(i32(_e480), i32(-2147483648), (_e480 < -2147483600f)), 2147483647i, (_e480 > 2147483500f)), (_e480 == _e480))), bitcast<u32>(select(0i, select(select(i32(_e511), i32(-2147483648), (_e511 < -2147483600f)), 2147483647i, (_e511 > 2147483500f)), (_e511 == _e511))), bitcast<u32>(select(0i, select(select(i32(_e542), i32(-2147483648), (_e542 < -2147483600f)), 2147483647i, (_e542 > 2147483500f)), (_e542 == _e542))), bitcast<u32>(select(0i, select(select(i32(_e573), i32(-2147483648), (_e573 < -2147483600f)), 2147483647i, (_e573 > 2147483500f)), (_e573 == _e573))), bitcast<u32>(select(0i, select(select(i32(_e604), i32(-2147483648), (_e604 < -2147483600f)), 2147483647i, (_e604 > 2147483500f)), (_e604 == _e604))), bitcast<u32>(select(0i, select(select(i32(_e635), i32(-2147483648), (_e635 < -2147483600f)), 2147483647i, (_e635 > 2147483500f)), (_e635 == _e635))), bitcast<u32>(select(0i, select(select(i32(_e666), i32(-2147483648), (_e666 < -2147483600f)), 2147483647i, (_e666 > 2147483500f)), (_e666 == _e666))), _e387);
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1930_ = array<u32, 10>();
                                                        break;
                                                    }
                                                }
                                                let _e883 = phi_1930_;
                                                if (_e382 < _e73) {
                                                } else {
                                                    phi_2854_ = true;
                                                    break;
                                                }
                                                global_7.member[_e382] = _e883[0];
                                                let _e897 = (_e382 + 1u);
                                                if (_e897 < _e73) {
                                                } else {
                                                    phi_2854_ = true;
                                                    break;
                                                }
                                                global_7.member[_e897] = _e883[1];
                                                let _e901 = (_e382 + 2u);
                                                if (_e901 < _e73) {
                                                } else {
                                                    phi_2854_ = true;
                                                    break;
                                                }
                                                global_7.member[_e901] = _e883[2];
                                                let _e905 = (_e382 + 3u);
                                                if (_e905 < _e73) {
                                                } else {
                                                    phi_2854_ = true;
                                                    break;
                                                }
                                                global_7.member[_e905] = _e883[3];
                                                if (_e349 > 4u) {
                                                    let _e910 = (_e382 + 4u);
                                                    if (_e910 < _e73) {
                                                    } else {
                                                        phi_2854_ = true;
                                                        break;
                                                    }
                                                    global_7.member[_e910] = _e883[4];
                                                    let _e914 = (_e382 + 5u);
                                                    if (_e914 < _e73) {
                                                    } else {
                                                        phi_2854_ = true;
                                                        break;
                                                    }
                                                    global_7.member[_e914] = _e883[5];
                                                    let _e918 = (_e382 + 6u);
                                                    if (_e918 < _e73) {
                                                    } else {
                                                        phi_2854_ = true;
                                                        break;
                                                    }
                                                    global_7.member[_e918] = _e883[6];
                                                }
                                                if (_e349 > 7u) {
                                                    let _e923 = (_e382 + 7u);
                                                    if (_e923 < _e73) {
                                                    } else {
                                                        phi_2854_ = true;
                                                        break;
                                                    }
                                                    global_7.member[_e923] = _e883[7];
                                                    let _e927 = (_e382 + 8u);
                                                    if (_e927 < _e73) {
                                                    } else {
                                                        phi_2854_ = true;
                                                        break;
                                                    }
                                                    global_7.member[_e927] = _e883[8];
                                                    let _e931 = (_e382 + 9u);
                                                    if (_e931 < _e73) {
                                                    } else {
                                                        phi_2854_ = true;
                                                        break;
                                                    }
                                                    global_7.member[_e931] = _e883[9];
                                                }
                                            }
                                        }
                                    }
                                }
                                continue;
                                continuing {
                                    phi_1319_ = _e370;
                                    phi_2854_ = false;
                                    break if !(_e376);
                                }
                            }
                            let _e937 = phi_2854_;
                            if _e937 {
                                break;
                            }
                            if _e87 {
                            } else {
                                break;
                            }
                            let _e945 = ((bitcast<u32>((select(_e133, _e97[0], _e141) - _e143)) | bitcast<u32>((select(_e175, _e97[1], _e183) - _e185))) | bitcast<u32>((select(_e217, _e97[2], _e225) - _e227)));
                            let _e946 = (_e945 < 1024u);
                            if _e946 {
                                phi_2096_ = 0u;
                            } else {
                                phi_2096_ = select(2u, 1u, (_e945 < 2097152u));
                            }
                            let _e950 = phi_2096_;
                            switch bitcast<i32>(_e950) {
                                case 0: {
                                    phi_2102_ = 1u;
                                    break;
                                }
                                case 1: {
                                    phi_2102_ = 2u;
                                    break;
                                }
                                case 2: {
                                    phi_2102_ = 3u;
                                    break;
                                }
                                default: {
                                    phi_2102_ = u32();
                                    break;
                                }
                            }
                            let _e953 = phi_2102_;
                            let _e955 = ((3u * _e953) + 1u);
                            if _e286 {
                                phi_2112_ = ((_e236 >> bitcast<u32>(28u)) & 7u);
                            } else {
                                phi_2112_ = 0u;
                            }
                            let _e960 = phi_2112_;
                            phi_2115_ = type_8(0u, _e960);
                            loop {
                                let _e963 = phi_2115_;
                                if (_e963.member < _e963.member_1) {
                                    phi_2116_ = type_8((_e963.member + 1u), _e963.member_1);
                                    phi_2139_ = type_8(1u, _e963.member);
                                } else {
                                    phi_2116_ = _e963;
                                    phi_2139_ = type_8(0u, type_8().member_1);
                                }
                                let _e976 = phi_2116_;
                                let _e978 = phi_2139_;
                                let _e982 = (bitcast<i32>(_e978.member) != 0i);
                                if _e982 {
                                    let _e984 = ((_e236 & 268435455u) + _e978.member_1);
                                    let _e985 = (_e984 < _e63);
                                    if _e985 {
                                        let _e986 = (_e984 < _e69);
                                        if _e986 {
                                            if _e986 {
                                            } else {
                                                phi_2968_ = true;
                                                break;
                                            }
                                            let _e988 = global_6.member[_e984];
                                            if ((_e988 + _e955) <= _e73) {
                                                if _e985 {
                                                } else {
                                                    phi_2968_ = true;
                                                    break;
                                                }
                                                let _e993 = global_2.member[_e984].member_1;
                                                if _e946 {
                                                    phi_2239_ = 0u;
                                                } else {
                                                    phi_2239_ = select(2u, 1u, (_e945 < 2097152u));
                                                }
                                                let _e997 = phi_2239_;
                                                switch bitcast<i32>(_e997) {
                                                    case 0: {
                                                        let _e1396 = (f32(_e143) * _e331);
                                                        let _e1398 = (f32(_e185) * _e331);
                                                        let _e1400 = (f32(_e227) * _e331);
                                                        let _e1401 = (1f / _e331);
                                                        let _e1405 = global_2.member[_e984].member[0u];
                                                        let _e1409 = global_2.member[_e984].member[1u];
                                                        let _e1413 = global_2.member[_e984].member[2u];
                                                        let _e1417 = (1024f / _e331);
                                                        let _e1434 = global_2.member[_e984].member[3u];
                                                        let _e1438 = global_2.member[_e984].member[4u];
                                                        let _e1442 = global_2.member[_e984].member[5u];
                                                        let _e1462 = global_2.member[_e984].member[6u];
                                                        let _e1466 = global_2.member[_e984].member[7u];
                                                        let _e1470 = global_2.member[_e984].member[8u];
                                                        phi_2726_ = array<u32, 10>(((bitcast<u32>(((((_e1405 - _e1396) * _e1401) + ((_e1409 - _e1398) * _e1417)) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e1413 - _e1400) * _e1401) + 8388608f)) & 4194303u) << bitcast<u32>(20i))), ((bitcast<u32>(((((_e1434 - _e1396) * _e1401) + ((_e1438 - _e1398) * _e1417)) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e1442 - _e1400) * _e1401) + 8388608f)) & 4194303u) << bitcast<u32>(20i))), ((bitcast<u32>(((((_e1462 - _e1396) * _e1401) + ((_e1466 - _e1398) * _e1417)) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e1470 - _e1400) * _e1401) + 8388608f)) & 4194303u) << bitcast<u32>(20i))), _e993, 0u, 0u, 0u, 0u, 0u, 0u);
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1283 = (f32(_e143) * _e331);
                                                        let _e1285 = (f32(_e185) * _e331);
                                                        let _e1287 = (f32(_e227) * _e331);
                                                        let _e1288 = (1f / _e331);
                                                        let _e1292 = global_2.member[_e984].member[0u];
                                                        let _e1296 = global_2.member[_e984].member[1u];
                                                        let _e1300 = global_2.member[_e984].member[2u];
                                                        let _e1305 = (bitcast<u32>((((_e1296 - _e1285) * _e1288) + 8388608f)) & 4194303u);
                                                        let _e1327 = global_2.member[_e984].member[3u];
                                                        let _e1331 = global_2.member[_e984].member[4u];
                                                        let _e1335 = global_2.member[_e984].member[5u];
                                                        let _e1340 = (bitcast<u32>((((_e1331 - _e1285) * _e1288) + 8388608f)) & 4194303u);
                                                        let _e1362 = global_2.member[_e984].member[6u];
                                                        let _e1366 = global_2.member[_e984].member[7u];
                                                        let _e1370 = global_2.member[_e984].member[8u];
                                                        let _e1375 = (bitcast<u32>((((_e1366 - _e1285) * _e1288) + 8388608f)) & 4194303u);
                                                        phi_2726_ = array<u32, 10>(((bitcast<u32>((((_e1292 - _e1283) * _e1288) + 8388608f)) & 4194303u) | (_e1305 << bitcast<u32>(21i))), ((_e1305 >> bitcast<u32>(11i)) | ((bitcast<u32>((((_e1300 - _e1287) * _e1288) + 8388608f)) & 4194303u) << bitcast<u32>(10i))), ((bitcast<u32>((((_e1327 - _e1283) * _e1288) + 8388608f)) & 4194303u) | (_e1340 << bitcast<u32>(21i))), ((_e1340 >> bitcast<u32>(11i)) | ((bitcast<u32>((((_e1335 - _e1287) * _e1288) + 8388608f)) & 4194303u) << bitcast<u32>(10i))), ((bitcast<u32>((((_e1362 - _e1283) * _e1288) + 8388608f)) & 4194303u) | (_e1375 << bitcast<u32>(21i))), ((_e1375 >> bitcast<u32>(11i)) | ((bitcast<u32>((((_e1370 - _e1287) * _e1288) + 8388608f)) & 4194303u) << bitcast<u32>(10i))), _e993, 0u, 0u, 0u);
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1002 = global_2.member[_e984].member[0u];
                                                        let _e1004 = (bitcast<u32>(_e331) & 2147483647u);
                                                        let _e1005 = (_e1004 >= 8388608u);
                                                        if _e1005 {
                                                            phi_2436_ = (bitcast<i32>((_e1004 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2436_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e1004)), 32u, (_e1004 == 0u))));
                                                        }
                                                        let _e1018 = phi_2436_;
                                                        let _e1024 = (_e1002 * bitcast<f32>((bitcast<u32>((127i - _e1018)) << bitcast<u32>(23i))));
                                                        let _e1036 = global_2.member[_e984].member[1u];
                                                        if _e1005 {
                                                            phi_2470_ = (bitcast<i32>((_e1004 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2470_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e1004)), 32u, (_e1004 == 0u))));
                                                        }
                                                        let _e1049 = phi_2470_;
                                                        let _e1055 = (_e1036 * bitcast<f32>((bitcast<u32>((127i - _e1049)) << bitcast<u32>(23i))));
                                                        let _e1067 = global_2.member[_e984].member[2u];
                                                        if _e1005 {
                                                            phi_2504_ = (bitcast<i32>((_e1004 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2504_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e1004)), 32u, (_e1004 == 0u))));
                                                        }
                                                        let _e1080 = phi_2504_;
                                                        let _e1086 = (_e1067 * bitcast<f32>((bitcast<u32>((127i - _e1080)) << bitcast<u32>(23i))));
                                                        let _e1098 = global_2.member[_e984].member[3u];
                                                        if _e1005 {
                                                            phi_2538_ = (bitcast<i32>((_e1004 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2538_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e1004)), 32u, (_e1004 == 0u))));
                                                        }
                                                        let _e1111 = phi_2538_;
                                                        let _e1117 = (_e1098 * bitcast<f32>((bitcast<u32>((127i - _e1111)) << bitcast<u32>(23i))));
                                                        let _e1129 = global_2.member[_e984].member[4u];
                                                        if _e1005 {
                                                            phi_2572_ = (bitcast<i32>((_e1004 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2572_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e1004)), 32u, (_e1004 == 0u))));
                                                        }
                                                        let _e1142 = phi_2572_;
                                                        let _e1148 = (_e1129 * bitcast<f32>((bitcast<u32>((127i - _e1142)) << bitcast<u32>(23i))));
                                                        let _e1160 = global_2.member[_e984].member[5u];
                                                        if _e1005 {
                                                            phi_2606_ = (bitcast<i32>((_e1004 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2606_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e1004)), 32u, (_e1004 == 0u))));
                                                        }
                                                        let _e1173 = phi_2606_;
                                                        let _e1179 = (_e1160 * bitcast<f32>((bitcast<u32>((127i - _e1173)) << bitcast<u32>(23i))));
                                                        let _e1191 = global_2.member[_e984].member[6u];
                                                        if _e1005 {
                                                            phi_2640_ = (bitcast<i32>((_e1004 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2640_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e1004)), 32u, (_e1004 == 0u))));
                                                        }
                                                        let _e1204 = phi_2640_;
                                                        let _e1210 = (_e1191 * bitcast<f32>((bitcast<u32>((127i - _e1204)) << bitcast<u32>(23i))));
                                                        let _e1222 = global_2.member[_e984].member[7u];
                                                        if _e1005 {
                                                            phi_2674_ = (bitcast<i32>((_e1004 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2674_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e1004)), 32u, (_e1004 == 0u))));
                                                        }
                                                        let _e1235 = phi_2674_;
                                                        let _e1241 = (_e1222 * bitcast<f32>((bitcast<u32>((127i - _e1235)) << bitcast<u32>(23i))));
                                                        let _e1253 = global_2.member[_e984].member[8u];
                                                        if _e1005 {
                                                            phi_2708_ = (bitcast<i32>((_e1004 >> bitcast<u32>(23i))) - 127i);
                                                        } else {
                                                            phi_2708_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e1004)), 32u, (_e1004 == 0u))));
                                                        }
                                                        let _e1266 = phi_2708_;
                                                        let _e1272 = (_e1253 * bitcast<f32>((bitcast<u32>((127i - _e1266)) << bitcast<u32>(23i))));
                                                        phi_2726_ = array<u32, 10>(bitcast<u32>(select(0i, select(select(i32(_e1024), i32(-2147483648), (_e1024 < -2147483600f)), 2147483647i, (_e1024 > 2147483500f)), (_e1024 == _e1024))), bitcast<u32>(select(0i, select(select(i32(_e1055), i32(-2147483648), (_e1055 < -2147483600f)), 2147483647i, (_e1055 > 2147483500f)), (_e1055 == _e1055))), bitcast<u32>(select(0i, select(select(i32(_e1086), i32(-2147483648), (_e1086 < -2147483600f)), 2147483647i, (_e1086 > 2147483500f)), (_e1086 == _e1086))), bitcast<u32>(select(0i, select(select(i32(_e1117), i32(-2147483648), (_e1117 < -2147483600f)), 2147483647i, (_e1117 > 2147483500f)), (_e1117 == _e1117))), bitcast<u32>(select(0i, select(select(i32(_e1148), i32(-2147483648), (_e1148 < -2147483600f)), 2147483647i, (_e1148 > 2147483500f)), (_e1148 == _e1148))), bitcast<u32>(select(0i, select(select(i32(_e1179), i32(-2147483648), (_e1179 < -2147483600f)), 2147483647i, (_e1179 > 2147483500f)), (_e1179 == _e1179))), bitcast<u32>(select(0i, select(select(i32(_e1210), i32(-2147483648), (_e1210 < -2147483600f)), 2147483647i, (_e1210 > 2147483500f)), (_e1210 == _e1210))), bitcast<u32>(select(0i, select(select(i32(_e1241), i32(-2147483648), (_e1241 < -2147483600f)), 2147483647i, (_e1241 > 2147483500f)), (_e1241 == _e1241))), bitcast<u32>(select(0i, select(select(i32(_e1272), i32(-2147483648), (_e1272 < -2147483600f)), 2147483647i, (_e1272 > 2147483500f)), (_e1272 == _e1272))), _e993);
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2726_ = array<u32, 10>();
                                                        break;
                                                    }
                                                }
                                                let _e1489 = phi_2726_;
                                                if (_e988 < _e73) {
                                                } else {
                                                    phi_2968_ = true;
                                                    break;
                                                }
                                                global_7.member[_e988] = _e1489[0];
                                                let _e1503 = (_e988 + 1u);
                                                if (_e1503 < _e73) {
                                                } else {
                                                    phi_2968_ = true;
                                                    break;
                                                }
                                                global_7.member[_e1503] = _e1489[1];
                                                let _e1507 = (_e988 + 2u);
                                                if (_e1507 < _e73) {
                                                } else {
                                                    phi_2968_ = true;
                                                    break;
                                                }
                                                global_7.member[_e1507] = _e1489[2];
                                                let _e1511 = (_e988 + 3u);
                                                if (_e1511 < _e73) {
                                                } else {
                                                    phi_2968_ = true;
                                                    break;
                                                }
                                                global_7.member[_e1511] = _e1489[3];
                                                if (_e955 > 4u) {
                                                    let _e1516 = (_e988 + 4u);
                                                    if (_e1516 < _e73) {
                                                    } else {
                                                        phi_2968_ = true;
                                                        break;
                                                    }
                                                    global_7.member[_e1516] = _e1489[4];
                                                    let _e1520 = (_e988 + 5u);
                                                    if (_e1520 < _e73) {
                                                    } else {
                                                        phi_2968_ = true;
                                                        break;
                                                    }
                                                    global_7.member[_e1520] = _e1489[5];
                                                    let _e1524 = (_e988 + 6u);
                                                    if (_e1524 < _e73) {
                                                    } else {
                                                        phi_2968_ = true;
                                                        break;
                                                    }
                                                    global_7.member[_e1524] = _e1489[6];
                                                }
                                                if (_e955 > 7u) {
                                                    let _e1529 = (_e988 + 7u);
                                                    if (_e1529 < _e73) {
                                                    } else {
                                                        phi_2968_ = true;
                                                        break;
                                                    }
                                                    global_7.member[_e1529] = _e1489[7];
                                                    let _e1533 = (_e988 + 8u);
                                                    if (_e1533 < _e73) {
                                                    } else {
                                                        phi_2968_ = true;
                                                        break;
                                                    }
                                                    global_7.member[_e1533] = _e1489[8];
                                                    let _e1537 = (_e988 + 9u);
                                                    if (_e1537 < _e73) {
                                                    } else {
                                                        phi_2968_ = true;
                                                        break;
                                                    }
                                                    global_7.member[_e1537] = _e1489[9];
                                                }
                                            }
                                        }
                                    }
                                }
                                continue;
                                continuing {
                                    phi_2115_ = _e976;
                                    phi_2968_ = _e937;
                                    break if !(_e982);
                                }
                            }
                            let _e1543 = phi_2968_;
                            if _e1543 {
                                break;
                            }
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn encode_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
